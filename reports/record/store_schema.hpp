#pragma once
// The store's tables and how they came to be: version N of the schema is what the first N
// migrations leave.

#include "reports/record/store_database.hpp"

namespace alcove {

/// `PRAGMA application_id` of a store: "ALCV".
inline constexpr std::int64_t kStoreApplication = 0x414c4356;

/// Brings a new or older file to kStoreSchemaVersion, all migrations in one transaction. Throws
/// InputError, naming both versions, for a newer file, and for a database that is no store.
void migrate_store(Database& database);

} // namespace alcove
