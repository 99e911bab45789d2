#pragma once
// Finished captures, cached a cell at a time: its metrics and pictures under everything that
// decides them. A capture knows its ingredients by name, so that one can be told which of them made
// a cell run again.

#include "harness/run/cache.hpp"
#include "reports/record/record.hpp"

#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// What decides a capture. Those that name it (scene, method, parameters, frames, size...) say
/// which cell it is, those of content (sources, data, driver) which state of it.
struct CaptureIngredients {
    std::vector<IngredientRecord> names;
    std::vector<IngredientRecord> contents;

    /// Of both: the key of the cache.
    [[nodiscard]] std::string make_key() const;
    /// Of the names alone.
    [[nodiscard]] std::string make_name_key() const;
};

class CaptureStore {
  public:
    explicit CaptureStore(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    [[nodiscard]] bool has(const std::string& key) const;
    /// Rows with the round's and the cell's names put in, and the cell's pictures copied to
    /// `pictures`. Nothing, and nothing copied, if the entry is missing or damaged.
    [[nodiscard]] std::optional<std::vector<MetricRow>>
    restore(const std::string& key, const RoundRecord& round, const std::string& cell,
            const std::filesystem::path& pictures) const;
    /// Puts the cell's rows (others are skipped) and its pictures into the cache.
    void store(const CaptureIngredients& ingredients, const std::vector<MetricRow>& rows,
               const std::string& cell, const std::filesystem::path& pictures) const;
    /// Throws FailureError naming the first number or picture in which a capture made now differs
    /// from the cached one.
    void compare(const std::string& key, const std::vector<MetricRow>& rows,
                 const std::string& cell, const std::filesystem::path& pictures) const;

    /// The contents with which a cell of these names was captured last; nothing if never here.
    [[nodiscard]] std::optional<std::vector<IngredientRecord>>
    find_last_contents(const CaptureIngredients& ingredients) const;

    /// Is the entry what was written? For `cache verify`.
    [[nodiscard]] static bool is_intact(const std::filesystem::path& entry);

  private:
    std::filesystem::path m_folder;
};

} // namespace alcove
