#pragma once
// A binary glTF file under construction: its JSON and its one buffer.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

namespace alcove {

class GlbBuilder {
  public:
    /// `file` is what errors call it.
    explicit GlbBuilder(std::string file);
    ~GlbBuilder();
    GlbBuilder(const GlbBuilder&) = delete;
    GlbBuilder& operator=(const GlbBuilder&) = delete;

    /// Appends an element to a top-level list. Returns its index.
    std::size_t add(const char* list, nlohmann::json element);
    void use_extension(const char* name, nlohmann::json value);

    /// Appends bytes as a buffer view that starts at a multiple of 4. Throws InputError once the
    /// file would not fit the 4 GiB that its format can tell. Returns the view's index.
    std::size_t add_view(std::span<const std::byte> bytes, int target = 0);
    /// Floats, `components` (1 to 4) an element, with their bounds. Returns the accessor's index.
    std::size_t add_floats(std::span<const float> values, std::size_t components, int target = 0);
    std::size_t add_indices(std::span<const std::uint32_t> indices);

    /// The whole file.
    [[nodiscard]] std::string finish();

  private:
    std::string m_file;
    std::unique_ptr<nlohmann::json> m_json;
    std::string m_buffer;
};

} // namespace alcove
