#include "core/base/parameters_glsl.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace alcove {
namespace {

std::string glsl_literal(const ParameterInfo& info, const ParameterValue& value) {
    switch (info.kind) {
    case ParameterKind::integer:
        return std::to_string(std::get<std::int64_t>(value));
    case ParameterKind::boolean:
        return std::get<bool>(value) ? "true" : "false";
    case ParameterKind::enumeration:
        return "param_" + info.name + "_" + std::get<std::string>(value);
    case ParameterKind::real:
        break;
    }
    // By its bits: every float survives, infinity included.
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(std::get<double>(value)));
    return "uintBitsToFloat(" + std::to_string(bits) + "u)";
}

const char* glsl_type(ParameterKind kind) {
    switch (kind) {
    case ParameterKind::integer:
    case ParameterKind::enumeration:
        return "int";
    case ParameterKind::boolean:
        return "bool";
    case ParameterKind::real:
        break;
    }
    return "float";
}

std::uint32_t choice_index(const ParameterInfo& info, const std::string& name) {
    const auto found = std::find(info.choices.begin(), info.choices.end(), name);
    ALCOVE_ASSERT(found != info.choices.end(), "a resolved enumeration holds one of its choices");
    return static_cast<std::uint32_t>(found - info.choices.begin());
}

} // namespace

std::string make_glsl_parameters(const ParameterTable& table, const ResolvedParameters& resolved) {
    std::string constants;
    std::string block;
    for (const ParameterTable::Entry& entry : table.entries()) {
        const ParameterInfo& info = entry.info;
        for (std::size_t i = 0; i < info.choices.size(); ++i) {
            constants += "const int param_" + info.name + "_" + info.choices[i] + " = " +
                         std::to_string(i) + ";\n";
        }
        const std::string declaration = std::string(glsl_type(info.kind)) + " param_" + info.name;
        if (info.rebuild) {
            constants += "const " + declaration + " = " +
                         glsl_literal(info, resolved.get(info.name)) + ";\n";
        } else {
            block += "    " + declaration + "; // " + info.unit + "\n";
        }
    }
    if (!block.empty()) {
        constants += "layout(std140) uniform ParameterBlock {\n" + block + "};\n";
    }
    return constants;
}

std::vector<std::byte> pack_parameter_block(const ParameterTable& table,
                                            const ResolvedParameters& resolved) {
    std::vector<std::byte> bytes;
    for (const ParameterTable::Entry& entry : table.entries()) {
        const ParameterInfo& info = entry.info;
        if (info.rebuild) {
            continue;
        }
        const ParameterValue& value = resolved.get(info.name);
        std::uint32_t word = 0;
        if (info.kind == ParameterKind::enumeration) {
            word = choice_index(info, std::get<std::string>(value));
        } else if (info.kind == ParameterKind::real) {
            word = std::bit_cast<std::uint32_t>(static_cast<float>(std::get<double>(value)));
        } else {
            word = static_cast<std::uint32_t>(static_cast<std::int32_t>(to_number(value)));
        }
        const auto four = std::bit_cast<std::array<std::byte, 4>>(word);
        bytes.insert(bytes.end(), four.begin(), four.end());
    }
    bytes.resize((bytes.size() + 15) / 16 * 16);
    return bytes;
}

} // namespace alcove
