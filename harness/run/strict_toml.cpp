#include "harness/run/strict_toml.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"

#include <cmath>

#include <toml++/toml.h>

namespace alcove {
namespace {

const toml::table& as_table(const void* table) {
    return *static_cast<const toml::table*>(table);
}

const toml::node& as_node(const void* node) {
    return *static_cast<const toml::node*>(node);
}

std::string describe_type(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::table:
        return "a table";
    case toml::node_type::array:
        return "an array";
    case toml::node_type::string:
        return "a string";
    case toml::node_type::integer:
        return "an integer";
    case toml::node_type::floating_point:
        return "a number";
    case toml::node_type::boolean:
        return "a switch";
    default:
        return "a date or time";
    }
}

/// As parameters read it; nothing for what is no scalar.
std::optional<std::string> to_parameter_text(const toml::node& node) {
    if (const auto* text = node.as_string()) {
        return text->get();
    }
    if (const auto* integer = node.as_integer()) {
        return std::to_string(integer->get());
    }
    if (const auto* number = node.as_floating_point();
        number != nullptr && !std::isnan(number->get())) {
        return format_number(number->get());
    }
    if (const auto* boolean = node.as_boolean()) {
        return boolean->get() ? "true" : "false";
    }
    return std::nullopt;
}

} // namespace

struct TomlTable::Document {
    std::string file;
    toml::table root;
};

TomlTable::TomlTable(std::shared_ptr<const Document> document, const void* table)
    : m_document(std::move(document)), m_table(table) {}

TomlTable TomlTable::parse(std::string_view text, const std::string& file) {
    auto document = std::make_shared<Document>();
    document->file = file;
    try {
        document->root = toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(file + ":" + std::to_string(error.source().begin.line), "no TOML",
                         std::string(error.description()));
    }
    const void* root = &document->root;
    return {std::move(document), root};
}

std::vector<std::string> TomlTable::list_keys() const {
    std::vector<std::string> keys;
    for (const auto& [key, node] : as_table(m_table)) {
        keys.emplace_back(key.str());
    }
    return keys;
}

const void* TomlTable::find(const std::string& key) const {
    return as_table(m_table).get(key);
}

const void* TomlTable::take(const std::string& key) {
    m_known.insert(key);
    return find(key);
}

bool TomlTable::is_table(const std::string& key) const {
    const void* node = find(key);
    return node != nullptr && as_node(node).is_table();
}

std::string TomlTable::where(const std::string& key) const {
    const void* node = key.empty() ? nullptr : find(key);
    const toml::source_region& source =
        node != nullptr ? as_node(node).source() : as_table(m_table).source();
    return m_document->file + ":" + std::to_string(source.begin.line);
}

void TomlTable::throw_type(const std::string& key, const std::string& expected) const {
    throw InputError(where(key) + ": " + key, "wrong type", describe_type(as_node(find(key))),
                     expected);
}

std::optional<std::string> TomlTable::get_string(const std::string& key) {
    const void* node = take(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto* text = as_node(node).as_string();
    if (text == nullptr) {
        throw_type(key, "a string");
    }
    return text->get();
}

std::optional<std::int64_t> TomlTable::get_integer(const std::string& key) {
    const void* node = take(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto* integer = as_node(node).as_integer();
    if (integer == nullptr) {
        throw_type(key, "an integer");
    }
    return integer->get();
}

std::optional<double> TomlTable::get_number(const std::string& key) {
    const void* node = take(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (const auto* integer = as_node(node).as_integer()) {
        return static_cast<double>(integer->get());
    }
    const auto* number = as_node(node).as_floating_point();
    if (number == nullptr || std::isnan(number->get())) {
        throw_type(key, "a number");
    }
    return number->get();
}

std::optional<bool> TomlTable::get_boolean(const std::string& key) {
    const void* node = take(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const auto* boolean = as_node(node).as_boolean();
    if (boolean == nullptr) {
        throw_type(key, "true or false");
    }
    return boolean->get();
}

std::optional<std::vector<std::string>> TomlTable::get_strings(const std::string& key) {
    const void* node = take(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const char* const expected = "a string or an array of strings";
    if (const auto* text = as_node(node).as_string()) {
        return std::vector<std::string>{text->get()};
    }
    const toml::array* array = as_node(node).as_array();
    if (array == nullptr) {
        throw_type(key, expected);
    }
    std::vector<std::string> texts;
    for (const toml::node& item : *array) {
        const auto* text = item.as_string();
        if (text == nullptr) {
            throw_type(key, expected);
        }
        texts.push_back(text->get());
    }
    return texts;
}

std::optional<TomlTable> TomlTable::get_table(const std::string& key) {
    const void* node = take(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const toml::table* table = as_node(node).as_table();
    if (table == nullptr) {
        throw_type(key, "a table");
    }
    return TomlTable(m_document, table);
}

std::vector<TomlTable> TomlTable::get_tables(const std::string& key) {
    const void* node = take(key);
    std::vector<TomlTable> tables;
    if (node == nullptr) {
        return tables;
    }
    const toml::array* array = as_node(node).as_array();
    const std::string expected = "[[" + key + "]], an array of tables";
    if (array == nullptr) {
        throw_type(key, expected);
    }
    for (const toml::node& item : *array) {
        const toml::table* table = item.as_table();
        if (table == nullptr) {
            throw_type(key, expected);
        }
        tables.push_back(TomlTable(m_document, table));
    }
    return tables;
}

std::optional<std::vector<std::string>> TomlTable::get_values(const std::string& key) {
    const void* node = take(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const char* const expected = "a value or an array of values";
    std::vector<std::string> values;
    const auto add = [&](const toml::node& item) {
        const std::optional<std::string> text = to_parameter_text(item);
        if (!text) {
            throw_type(key, expected);
        }
        values.push_back(*text);
    };
    if (const toml::array* array = as_node(node).as_array()) {
        for (const toml::node& item : *array) {
            add(item);
        }
    } else {
        add(as_node(node));
    }
    return values;
}

void TomlTable::check_all_known() const {
    const std::vector<std::string> known(m_known.begin(), m_known.end());
    for (const std::string& key : list_keys()) {
        if (!m_known.contains(key)) {
            throw InputError(where(key), "unknown key", key, describe_choices(key, known));
        }
    }
}

void TomlTable::with_place(const std::string& key, const std::function<void()>& read) const {
    try {
        read();
    } catch (const InputError& error) {
        // The line is known here and the reason there.
        throw InputError(where(key) + ": " + error.what());
    }
}

} // namespace alcove
