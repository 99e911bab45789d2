#include "scenes/common/strict_json.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

constexpr int kDeepest = 64;

/// What was found, short enough for a message.
std::string describe(const nlohmann::json& value) {
    if (value.is_object() || value.is_array()) {
        return std::string("an ") + value.type_name() + " of " + std::to_string(value.size());
    }
    std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    constexpr std::size_t kLongest = 60;
    if (text.size() > kLongest) {
        text = text.substr(0, kLongest) + "...";
    }
    return text;
}

} // namespace

nlohmann::json parse_strict_json(std::string_view text, std::string_view file) {
    std::vector<std::set<std::string>> seen;
    const auto watch = [&](int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
        if (depth > kDeepest) {
            throw InputError(file, "nested too deeply",
                             "more than " + std::to_string(kDeepest) + " levels");
        }
        if (event == nlohmann::json::parse_event_t::object_start) {
            seen.emplace_back();
        } else if (event == nlohmann::json::parse_event_t::object_end) {
            seen.pop_back();
        } else if (event == nlohmann::json::parse_event_t::key &&
                   !seen.back().insert(parsed.get<std::string>()).second) {
            throw InputError(file, "key stands twice in one object", parsed.get<std::string>());
        }
        return true;
    };
    try {
        return nlohmann::json::parse(text.begin(), text.end(), watch);
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file, std::string("is not JSON: ") + error.what());
    }
}

void JsonPlace::check_keys(std::initializer_list<std::string_view> keys,
                           std::initializer_list<std::string_view> optional) const {
    if (!m_value.is_object()) {
        fail("wrong type", "an object");
    }
    std::vector<std::string_view> allowed(keys);
    allowed.insert(allowed.end(), optional);
    std::string expected;
    for (const std::string_view key : allowed) {
        expected += (expected.empty() ? "" : ", ") + std::string(key);
    }
    for (const auto& item : m_value.items()) {
        if (std::find(allowed.begin(), allowed.end(), item.key()) == allowed.end()) {
            throw InputError(where(), "unknown key", item.key(), "one of " + expected);
        }
    }
    for (const std::string_view key : keys) {
        static_cast<void>(get(key));
    }
}

bool JsonPlace::has(std::string_view key) const {
    return m_value.is_object() && m_value.contains(std::string(key));
}

JsonPlace JsonPlace::get(std::string_view key) const {
    if (!m_value.is_object()) {
        fail("wrong type", "an object");
    }
    const auto found = m_value.find(std::string(key));
    if (found == m_value.end()) {
        throw InputError(where(), "missing key", {}, key);
    }
    return {*found, m_file, m_path + (m_path.empty() ? "" : ".") + std::string(key)};
}

std::size_t JsonPlace::count() const {
    if (!m_value.is_array()) {
        fail("wrong type", "an array");
    }
    return m_value.size();
}

JsonPlace JsonPlace::at(std::size_t index) const {
    if (index >= count()) {
        fail("too few elements", "at least " + std::to_string(index + 1));
    }
    return {m_value[index], m_file, m_path + "[" + std::to_string(index) + "]"};
}

double JsonPlace::read_number() const {
    if (!m_value.is_number()) {
        fail("wrong type", "a number");
    }
    const double number = m_value.get<double>();
    if (!(std::abs(number) <= kLargestNumber)) {
        fail("out of range",
             "a finite number of at most " + format_number(kLargestNumber) + " in size");
    }
    return number;
}

std::int64_t JsonPlace::read_integer(std::int64_t minimum, std::int64_t maximum) const {
    const std::string expected =
        "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum);
    if (!m_value.is_number_integer()) {
        fail("wrong type", expected);
    }
    // As double first: an unsigned value beyond int64 must not wrap into the range.
    const double size = m_value.get<double>();
    if (size < static_cast<double>(minimum) || size > static_cast<double>(maximum)) {
        fail("out of range", expected);
    }
    return m_value.get<std::int64_t>();
}

std::string JsonPlace::read_text() const {
    if (!m_value.is_string()) {
        fail("wrong type", "a string");
    }
    return m_value.get<std::string>();
}

bool JsonPlace::read_truth() const {
    if (!m_value.is_boolean()) {
        fail("wrong type", "true or false");
    }
    return m_value.get<bool>();
}

glm::dvec3 JsonPlace::read_vector() const {
    if (!m_value.is_array() || m_value.size() != 3) {
        fail("wrong type", "three numbers");
    }
    return {at(0).read_number(), at(1).read_number(), at(2).read_number()};
}

std::string JsonPlace::where() const {
    return m_path.empty() ? m_file : m_file + ": " + m_path;
}

void JsonPlace::fail(std::string_view what, std::string_view expected) const {
    throw InputError(where(), what, describe(m_value), expected);
}

} // namespace alcove
