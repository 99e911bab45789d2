#include "reports/record/store_database.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"

#include <cmath>

#include <sqlite3.h>

namespace alcove {
namespace {

constexpr int kBusyMilliseconds = 10'000;
/// A store is not ours alone: no text in it is near this long.
constexpr int kLongestValueBytes = 1 << 20;

} // namespace

Database::Database(const std::filesystem::path& path) : m_name(path.string()) {
    if (path.has_parent_path()) {
        create_output_folder(path.parent_path());
    }
    if (sqlite3_open(m_name.c_str(), &m_handle) != SQLITE_OK) {
        const std::string reason = sqlite3_errmsg(m_handle);
        sqlite3_close(m_handle);
        throw FailureError(m_name, "cannot be opened", reason, "a file that can be written to");
    }
    sqlite3_busy_timeout(m_handle, kBusyMilliseconds);
    sqlite3_limit(m_handle, SQLITE_LIMIT_LENGTH, kLongestValueBytes);
    // A file of somebody else's may hold triggers and views that call functions.
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_FKEY, 1, nullptr);
}

Database::~Database() {
    sqlite3_close(m_handle);
}

void Database::throw_error() const {
    const std::string reason = sqlite3_errmsg(m_handle);
    switch (sqlite3_errcode(m_handle)) {
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
    case SQLITE_ERROR: // such as a table that is not there
    case SQLITE_CONSTRAINT:
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
        throw InputError(m_name, "not a sound store", reason, "a file made by `alcove nightly`");
    default:
        throw FailureError(m_name, "the store failed", reason);
    }
}

void Database::execute(const char* sql) {
    if (sqlite3_exec(m_handle, sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
        throw_error();
    }
}

std::int64_t Database::read_integer(const char* sql) {
    Statement statement(*this, sql);
    const bool has_row = statement.step();
    ALCOVE_ASSERT(has_row, "SQL that gives a row");
    return statement.get_integer(0);
}

std::int64_t Database::get_last_row() const {
    return sqlite3_last_insert_rowid(m_handle);
}

Statement::Statement(Database& database, const char* sql) : m_database(database) {
    check(sqlite3_prepare_v2(database.handle(), sql, -1, &m_handle, nullptr));
}

Statement::~Statement() {
    sqlite3_finalize(m_handle);
}

void Statement::check(int code) const {
    if (code != SQLITE_OK) {
        m_database.throw_error();
    }
}

Statement& Statement::bind(int parameter, std::string_view text) {
    // A null pointer would be NULL, not an empty text.
    check(sqlite3_bind_text64(m_handle, parameter + 1, text.data() == nullptr ? "" : text.data(),
                              text.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind(int parameter, std::int64_t number) {
    check(sqlite3_bind_int64(m_handle, parameter + 1, number));
    return *this;
}

Statement& Statement::bind(int parameter, double number) {
    ALCOVE_ASSERT(std::isfinite(number), "a number that SQL can hold");
    check(sqlite3_bind_double(m_handle, parameter + 1, number));
    return *this;
}

Statement& Statement::bind(int parameter, const std::optional<double>& number) {
    if (number) {
        return bind(parameter, *number);
    }
    check(sqlite3_bind_null(m_handle, parameter + 1));
    return *this;
}

bool Statement::step() {
    const int code = sqlite3_step(m_handle);
    if (code != SQLITE_ROW && code != SQLITE_DONE) {
        m_database.throw_error();
    }
    return code == SQLITE_ROW;
}

void Statement::run() {
    const bool has_row = step();
    ALCOVE_ASSERT(!has_row, "SQL that gives no row");
    reset();
}

void Statement::reset() {
    sqlite3_reset(m_handle);
    sqlite3_clear_bindings(m_handle);
}

std::string Statement::get_text(int column) const {
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(m_handle, column));
    const int size = sqlite3_column_bytes(m_handle, column);
    return bytes == nullptr ? std::string() : std::string(bytes, static_cast<std::size_t>(size));
}

std::int64_t Statement::get_integer(int column) const {
    return sqlite3_column_int64(m_handle, column);
}

double Statement::get_number(int column) const {
    const std::optional<double> number = get_optional_number(column);
    if (!number) {
        throw InputError(m_database.name(), "a row without its number");
    }
    return *number;
}

std::optional<double> Statement::get_optional_number(int column) const {
    const int type = sqlite3_column_type(m_handle, column);
    if (type == SQLITE_NULL) {
        return std::nullopt;
    }
    const double number = sqlite3_column_double(m_handle, column);
    if ((type != SQLITE_FLOAT && type != SQLITE_INTEGER) || !std::isfinite(number)) {
        throw InputError(m_database.name(), "a row holds what is no finite number",
                         get_text(column));
    }
    return number;
}

Transaction::Transaction(Database& database) : m_database(database) {
    database.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
    if (m_is_open) {
        // What fails here is rolled back by SQLite itself when the file is opened next.
        sqlite3_exec(m_database.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
}

void Transaction::commit() {
    m_database.execute("COMMIT");
    m_is_open = false;
}

} // namespace alcove
