#include "harness/app/image_pairs.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "reports/record/csv.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestList = 64u << 20;
constexpr std::size_t kMostPairs = 100'000;

bool is_image_name(const fs::path& path) {
    constexpr std::array<std::string_view, 3> kExtensions{".png", ".exr", ".hdr"};
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::vector<fs::path> list_images(const fs::path& folder) {
    std::vector<fs::path> names;
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
        if (file.is_regular_file() && is_image_name(file.path())) {
            names.push_back(file.path().filename());
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// A name that stands in one of two sorted lists only.
std::string find_odd_name(const std::vector<fs::path>& a, const std::vector<fs::path>& b) {
    std::vector<fs::path> odd;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(odd));
    return odd.empty() ? "" : odd.front().string();
}

std::string make_safe(std::string name) {
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-' && c != '.'; },
        '_');
    return name;
}

/// The test's name without its extension; with the pair's number in front if two are alike.
void label_pairs(std::vector<ImagePair>& pairs) {
    std::set<std::string> seen;
    for (ImagePair& pair : pairs) {
        pair.label = make_safe(pair.test.stem().string());
        seen.insert(pair.label);
    }
    for (std::size_t i = 0; seen.size() < pairs.size() && i < pairs.size(); ++i) {
        pairs[i].label = fmt::format("{:06}_{}", i + 1, pairs[i].label);
    }
}

fs::path resolve_listed(const fs::path& list, const std::string& name, const std::string& where) {
    try {
        fs::path path = resolve_inside(list.parent_path(), name);
        if (!fs::is_regular_file(path)) {
            throw InputError(name, "no such file");
        }
        return path;
    } catch (const InputError& error) {
        throw InputError(where + ": " + error.what());
    }
}

} // namespace

std::vector<ImagePair> pair_images(const fs::path& test, const fs::path& reference) {
    std::vector<ImagePair> pairs;
    if (!fs::is_directory(test) && !fs::is_directory(reference)) {
        pairs.push_back({test, reference, ""});
        label_pairs(pairs);
        return pairs;
    }
    if (!fs::is_directory(test) || !fs::is_directory(reference)) {
        throw InputError("metric", "one is a folder, the other is not",
                         test.string() + " and " + reference.string(), "two files or two folders");
    }
    const std::vector<fs::path> names = list_images(test);
    const std::vector<fs::path> others = list_images(reference);
    if (names != others) {
        throw InputError("metric",
                         "the folders do not hold the same PNG, EXR and HDR names: " +
                             test.string() + " and " + reference.string(),
                         find_odd_name(names, others), "every name in both");
    }
    if (names.empty()) {
        throw InputError(test.string(), "holds no PNG, EXR or HDR");
    }
    for (const fs::path& name : names) {
        pairs.push_back({test / name, reference / name, ""});
    }
    label_pairs(pairs);
    return pairs;
}

std::vector<ImagePair> read_pair_list(const fs::path& list) {
    const std::string file = list.string();
    std::string text = read_file(list, kLargestList);
    // Other programs leave the last line open.
    if (!text.empty() && text.back() != '\n') {
        text += '\n';
    }
    CsvReader reader(text, file);
    std::vector<std::string> fields;
    if (!reader.next(fields) || fields != std::vector<std::string>{"test", "reference"}) {
        throw InputError(file + ":1", "not the header of a list",
                         fmt::format("{}", fmt::join(fields, ",")), "test,reference");
    }
    std::vector<ImagePair> pairs;
    while (reader.next(fields)) {
        if (fields.size() != 2) {
            throw InputError(reader.where(), "not a pair",
                             std::to_string(fields.size()) + " fields", "2: test,reference");
        }
        if (pairs.size() == kMostPairs) {
            throw InputError(reader.where(), "too many pairs", "", std::to_string(kMostPairs));
        }
        pairs.push_back({resolve_listed(list, fields[0], reader.where()),
                         resolve_listed(list, fields[1], reader.where()), ""});
    }
    if (pairs.empty()) {
        throw InputError(file, "lists no pair");
    }
    label_pairs(pairs);
    return pairs;
}

} // namespace alcove
