#include "harness/run/capture_store.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/hash.hpp"
#include "reports/record/csv.hpp"
#include "reports/record/record_csv.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKind = "captures";
// Names in the entry's table, whatever they were in the run.
constexpr const char* kRound = "round";
constexpr const char* kCell = "cell";
constexpr std::uintmax_t kLargestTable = std::uintmax_t{1} << 28;
constexpr std::uintmax_t kLargestPicture = std::uintmax_t{1} << 30;

void add_all(Hasher& hasher, const std::vector<IngredientRecord>& ingredients) {
    for (const IngredientRecord& ingredient : ingredients) {
        hasher.add(ingredient.name).add(ingredient.value);
    }
}

std::string hash_text(std::string_view text) {
    return Hasher().add(text).finish_hex();
}

std::vector<std::string> list_files(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (entry.is_regular_file(error)) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// A round in which the entry's table stands.
RoundRecord make_neutral_round(const RoundRecord& round) {
    RoundRecord neutral = round;
    neutral.id = kRound;
    neutral.cells.assign(1, {});
    neutral.cells.front().id = kCell;
    return neutral;
}

std::vector<MetricRow> take_rows(const std::vector<MetricRow>& rows, const std::string& cell) {
    std::vector<MetricRow> taken;
    for (MetricRow row : rows) {
        if (row.cell == cell) {
            row.round = kRound;
            row.cell = kCell;
            taken.push_back(std::move(row));
        }
    }
    return taken;
}

/// The lines of a table of two columns, without its header. Throws InputError.
std::vector<std::pair<std::string, std::string>> read_pairs(const fs::path& path) {
    const std::string text = read_file(path, kLargestTable);
    const std::string name = path.string();
    CsvReader reader(text, name);
    std::vector<std::pair<std::string, std::string>> pairs;
    std::vector<std::string> fields;
    bool is_header = true;
    while (reader.next(fields)) {
        if (fields.size() != 2) {
            throw InputError(reader.where(), "wrong number of fields",
                             std::to_string(fields.size()), "2");
        }
        if (!is_header) {
            pairs.emplace_back(fields[0], fields[1]);
        }
        is_header = false;
    }
    return pairs;
}

/// File name -> hash of what is in it.
using Manifest = std::map<std::string, std::string>;

std::optional<Manifest> read_manifest(const fs::path& entry) {
    std::error_code error;
    if (!fs::is_regular_file(entry / "manifest.csv", error)) {
        return std::nullopt;
    }
    Manifest manifest;
    for (const auto& [name, hash] : read_pairs(entry / "manifest.csv")) {
        if (name.find('/') != std::string::npos) {
            return std::nullopt;
        }
        manifest[name] = hash;
    }
    return manifest;
}

/// Text of a file of the entry if its hash is the manifest's.
std::optional<std::string> read_checked(const fs::path& path, const std::string& hash) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return std::nullopt;
    }
    std::string text = read_file(path, kLargestPicture);
    return hash_text(text) == hash ? std::optional(std::move(text)) : std::nullopt;
}

std::string make_contents_csv(const std::vector<IngredientRecord>& ingredients) {
    std::string text;
    append_csv_line(text, {"name", "value"});
    for (const IngredientRecord& ingredient : ingredients) {
        append_csv_line(text, {ingredient.name, ingredient.value});
    }
    return text;
}

fs::path make_names_path(const fs::path& folder, const CaptureIngredients& ingredients) {
    return folder / kKind / "names" / (ingredients.make_name_key() + ".csv");
}

} // namespace

std::string CaptureIngredients::make_key() const {
    Hasher hasher;
    add_all(hasher, names);
    add_all(hasher, contents);
    return hasher.finish_hex();
}

std::string CaptureIngredients::make_name_key() const {
    Hasher hasher;
    add_all(hasher, names);
    return hasher.finish_hex();
}

bool CaptureStore::has(const std::string& key) const {
    std::error_code error;
    return fs::is_regular_file(make_cache_path(m_folder, kKind, key, "") / "manifest.csv", error);
}

std::optional<std::vector<MetricRow>> CaptureStore::restore(const std::string& key,
                                                            const RoundRecord& round,
                                                            const std::string& cell,
                                                            const fs::path& pictures) const {
    const fs::path entry = make_cache_path(m_folder, kKind, key, "");
    try {
        const std::optional<Manifest> manifest = read_manifest(entry);
        if (!manifest || !manifest->contains("metrics.csv")) {
            return std::nullopt;
        }
        std::map<std::string, std::string> files;
        for (const auto& [name, hash] : *manifest) {
            const bool is_table = name == "metrics.csv";
            std::optional<std::string> text =
                read_checked(is_table ? entry / name : entry / "pictures" / name, hash);
            if (!text) {
                return std::nullopt;
            }
            files[name] = std::move(*text);
        }
        std::vector<MetricRow> rows = parse_metrics_csv(
            files.at("metrics.csv"), (entry / "metrics.csv").string(), make_neutral_round(round));
        for (MetricRow& row : rows) {
            row.round = round.id;
            row.cell = cell;
        }
        for (const auto& [name, text] : files) {
            if (name != "metrics.csv") {
                write_cache_file(pictures / name, text);
            }
        }
        mark_used(entry);
        return rows;
    } catch (const InputError&) {
        return std::nullopt; // damaged: captured anew
    }
}

void CaptureStore::store(const CaptureIngredients& ingredients, const std::vector<MetricRow>& rows,
                         const std::string& cell, const fs::path& pictures) const {
    const std::string key = ingredients.make_key();
    const fs::path entry = make_cache_path(m_folder, kKind, key, "");
    std::random_device random;
    const fs::path temporary = m_folder / kKind / ("tmp-" + key + "-" + std::to_string(random()));
    const std::string table = make_metrics_csv(take_rows(rows, cell));
    std::string manifest;
    append_csv_line(manifest, {"file", "hash"});
    append_csv_line(manifest, {"metrics.csv", hash_text(table)});
    write_cache_file(temporary / "metrics.csv", table);
    for (const std::string& name : list_files(pictures)) {
        const std::string text = read_file(pictures / name, kLargestPicture);
        write_cache_file(temporary / "pictures" / name, text);
        append_csv_line(manifest, {name, hash_text(text)});
    }
    write_cache_file(temporary / "manifest.csv", manifest);
    std::error_code error;
    fs::remove_all(entry, error); // a damaged one
    fs::create_directories(entry.parent_path(), error);
    publish_folder(temporary, entry);
    write_cache_file(make_names_path(m_folder, ingredients),
                     make_contents_csv(ingredients.contents));
}

void CaptureStore::compare(const std::string& key, const std::vector<MetricRow>& rows,
                           const std::string& cell, const fs::path& pictures) const {
    const fs::path entry = make_cache_path(m_folder, kKind, key, "");
    const auto fail = [&](const std::string& what) {
        throw FailureError("audit", "a cached capture is not what is captured now: " + what, cell,
                           "the same bytes; `alcove cache prune --limit 0` empties the cache");
    };
    const std::optional<Manifest> manifest = read_manifest(entry);
    if (!manifest) {
        fail("no manifest");
    }
    Manifest now{{"metrics.csv", hash_text(make_metrics_csv(take_rows(rows, cell)))}};
    for (const std::string& name : list_files(pictures)) {
        now[name] = hash_text(read_file(pictures / name, kLargestPicture));
    }
    for (const auto& [name, hash] : *manifest) {
        if (!now.contains(name) || now.at(name) != hash) {
            fail(name);
        }
    }
    if (now.size() != manifest->size()) {
        fail("number of pictures");
    }
}

std::optional<std::vector<IngredientRecord>>
CaptureStore::find_last_contents(const CaptureIngredients& ingredients) const {
    const fs::path path = make_names_path(m_folder, ingredients);
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return std::nullopt;
    }
    std::vector<IngredientRecord> contents;
    try {
        for (const auto& [name, value] : read_pairs(path)) {
            contents.push_back({name, value});
        }
    } catch (const InputError&) {
        return std::nullopt; // it only explains
    }
    return contents;
}

bool CaptureStore::is_intact(const fs::path& entry) {
    if (!fs::is_directory(entry)) {
        return true; // a table of names
    }
    const std::optional<Manifest> manifest = read_manifest(entry);
    return manifest && std::all_of(manifest->begin(), manifest->end(), [&](const auto& file) {
               const auto& [name, hash] = file;
               return read_checked(name == "metrics.csv" ? entry / name : entry / "pictures" / name,
                                   hash)
                   .has_value();
           });
}

} // namespace alcove
