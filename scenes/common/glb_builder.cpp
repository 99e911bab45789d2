#include "scenes/common/glb_builder.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kElementArray = 34963;
constexpr std::size_t kLargestFile = std::numeric_limits<std::uint32_t>::max();

void check_size(std::size_t bytes, const std::string& file) {
    if (bytes > kLargestFile) {
        throw InputError(file, "the scene does not fit a binary glTF file", {},
                         "at most 4 GiB, since its header tells sizes in 32 bits");
    }
}

void append_u32(std::string& bytes, std::size_t value) {
    for (unsigned i = 0; i < 4; ++i) {
        bytes += static_cast<char>((value >> (8 * i)) & 0xFFu);
    }
}

void pad(std::string& bytes, char filler) {
    bytes.append((4 - bytes.size() % 4) % 4, filler);
}

} // namespace

GlbBuilder::GlbBuilder(std::string file)
    : m_file(std::move(file)), m_json(std::make_unique<nlohmann::json>(nlohmann::json{
                                   {"asset", {{"version", "2.0"}, {"generator", "Alcove"}}}})) {}

GlbBuilder::~GlbBuilder() = default;

std::size_t GlbBuilder::add(const char* list, nlohmann::json element) {
    nlohmann::json& elements = (*m_json)[list];
    elements.push_back(std::move(element));
    return elements.size() - 1;
}

void GlbBuilder::use_extension(const char* name, nlohmann::json value) {
    (*m_json)["extensionsUsed"].push_back(name);
    (*m_json)["extensions"][name] = std::move(value);
}

std::size_t GlbBuilder::add_view(std::span<const std::byte> bytes, int target) {
    check_size(m_buffer.size() + bytes.size(), m_file);
    pad(m_buffer, '\0');
    nlohmann::json view{
        {"buffer", 0}, {"byteOffset", m_buffer.size()}, {"byteLength", bytes.size()}};
    if (target != 0) {
        view["target"] = target;
    }
    m_buffer.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return add("bufferViews", std::move(view));
}

std::size_t GlbBuilder::add_floats(std::span<const float> values, std::size_t components,
                                   int target) {
    static constexpr std::array kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    ALCOVE_ASSERT(components >= 1 && components <= kTypes.size() && !values.empty() &&
                      values.size() % components == 0,
                  "whole elements");
    std::vector<double> low(components, std::numeric_limits<double>::infinity());
    std::vector<double> high(components, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i];
        low[i % components] = std::min(low[i % components], value);
        high[i % components] = std::max(high[i % components], value);
    }
    const std::size_t view = add_view(std::as_bytes(values), target);
    return add("accessors", {{"bufferView", view},
                             {"componentType", kFloat},
                             {"count", values.size() / components},
                             {"type", kTypes.at(components - 1)},
                             {"min", low},
                             {"max", high}});
}

std::size_t GlbBuilder::add_indices(std::span<const std::uint32_t> indices) {
    const std::size_t view = add_view(std::as_bytes(indices), kElementArray);
    return add("accessors", {{"bufferView", view},
                             {"componentType", kUnsignedInt},
                             {"count", indices.size()},
                             {"type", "SCALAR"}});
}

std::string GlbBuilder::finish() {
    pad(m_buffer, '\0');
    add("buffers", {{"byteLength", m_buffer.size()}});
    // Names of a scene may come from anybody's file: bytes that are no UTF-8 are replaced.
    std::string text = m_json->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    pad(text, ' ');
    const std::size_t size = 12 + 8 + text.size() + 8 + m_buffer.size();
    check_size(size, m_file);
    std::string file = "glTF";
    file.reserve(size);
    append_u32(file, 2);
    append_u32(file, size);
    append_u32(file, text.size());
    file += "JSON";
    file += text;
    append_u32(file, m_buffer.size());
    file.append("BIN\0", 4);
    file += m_buffer;
    return file;
}

} // namespace alcove
