#include "scenes/common/off_file.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "scenes/common/mesh_builder.hpp"
#include "scenes/common/orbit.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr double kFarthest = 1e9;
constexpr std::size_t kMostCorners = 64;

/// Lines that hold something, with their numbers.
class OffLines {
  public:
    OffLines(std::string_view text, std::string_view where) : m_rest(text), m_where(where) {}

    /// The next line without its comment; throws at the end.
    std::string_view next(std::string_view expected) {
        while (!m_rest.empty()) {
            const std::size_t end = m_rest.find('\n');
            std::string_view line = m_rest.substr(0, end);
            m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
            ++m_line;
            line = line.substr(0, line.find('#'));
            if (line.find_first_not_of(" \t\r") != std::string_view::npos) {
                return line;
            }
        }
        throw InputError(place(), "ends too early", {}, expected);
    }
    /// The next number of a line, which is taken off it.
    template <class T>
    T take(std::string_view& line, std::string_view expected) const {
        const std::size_t begin = line.find_first_not_of(" \t\r");
        T value{};
        if (begin != std::string_view::npos) {
            line.remove_prefix(begin);
            const auto [end, error] =
                std::from_chars(line.data(), line.data() + line.size(), value);
            const bool is_whole =
                end == line.data() + line.size() || *end == ' ' || *end == '\t' || *end == '\r';
            if (error == std::errc{} && is_whole) {
                line.remove_prefix(static_cast<std::size_t>(end - line.data()));
                return value;
            }
        }
        throw InputError(place(), "no such number", line.substr(0, 40), expected);
    }
    [[nodiscard]] std::string place() const {
        return std::string(m_where) + ":" + std::to_string(m_line);
    }
    /// How many lines there can be at most.
    [[nodiscard]] std::size_t left() const { return m_rest.size() / 2 + 1; }

  private:
    std::string_view m_rest;
    std::string_view m_where;
    int m_line = 0;
};

void read_points(OffLines& lines, std::size_t count, MeshBuilder& builder) {
    for (std::size_t i = 0; i < count; ++i) {
        std::string_view line = lines.next("a vertex, x y z");
        glm::dvec3 point(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = lines.take<double>(line, "a coordinate");
            if (!(std::abs(point[axis]) <= kFarthest)) {
                throw InputError(lines.place(), "coordinate not finite or too large",
                                 format_number(point[axis]), "within +-1e9");
            }
        }
        builder.add_point(point);
    }
}

void read_face(OffLines& lines, std::size_t vertices, MeshBuilder& builder) {
    std::string_view line = lines.next("a face, n i1 .. in");
    const auto corners = lines.take<std::size_t>(line, "a number of corners");
    if (corners < 3 || corners > kMostCorners) {
        throw InputError(lines.place(), "number of corners out of range", std::to_string(corners),
                         "3 to " + std::to_string(kMostCorners));
    }
    std::vector<std::uint32_t> polygon;
    for (std::size_t i = 0; i < corners; ++i) {
        const auto index = lines.take<std::size_t>(line, "a vertex's index");
        if (index >= vertices) {
            throw InputError(lines.place(), "index out of range", std::to_string(index),
                             "less than " + std::to_string(vertices));
        }
        polygon.push_back(static_cast<std::uint32_t>(index));
    }
    for (std::size_t i = 2; i < corners; ++i) {
        builder.add_triangle(polygon[0], polygon[i - 1], polygon[i]);
    }
}

} // namespace

Mesh parse_off(std::string_view text, std::string_view where) {
    OffLines lines(text, where);
    std::string_view head = lines.next("OFF");
    const std::size_t word = head.find_first_not_of(" \t\r");
    if (head.substr(word, 3) != "OFF" ||
        head.find_first_not_of(" \t\r", word + 3) != std::string_view::npos) {
        throw InputError(lines.place(), "not an OFF file", head.substr(0, 40), "OFF");
    }
    std::string_view counts = lines.next("numbers of vertices, faces and edges");
    const auto vertices = lines.take<std::size_t>(counts, "a number of vertices");
    const auto faces = lines.take<std::size_t>(counts, "a number of faces");
    if (vertices > lines.left() || faces > lines.left()) {
        throw InputError(lines.place(), "promises more lines than the file has",
                         std::to_string(vertices) + " vertices, " + std::to_string(faces) +
                             " faces");
    }
    MeshBuilder builder;
    read_points(lines, vertices, builder);
    for (std::size_t i = 0; i < faces; ++i) {
        read_face(lines, vertices, builder);
    }
    if (builder.triangles().empty()) {
        throw InputError(where, "holds no triangles");
    }
    Mesh mesh = builder.finish("model", glm::vec3(0.7f), 180.0);
    mesh.closed = false;
    return mesh;
}

std::unique_ptr<Scene> open_off_scene(const std::filesystem::path& path,
                                      const OffOptions& options) {
    RigidSceneContent content;
    content.meshes.push_back(parse_off(read_file(path), path.string()));
    content.objects.push_back({"model", 0});
    content.transforms.emplace_back(1.0);
    Bounds bounds;
    for (const glm::vec3& position : content.meshes.front().positions) {
        bounds.add(glm::dvec3(position));
    }
    if (!(bounds.diagonal() > 0.0)) {
        throw InputError(path.string(), "all vertices lie in one point");
    }
    content.ao_radius_m = options.ao_radius_m.value_or(0.05 * bounds.diagonal());
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.4, 1.0, 0.6)), glm::vec3(1.0f)});
    content.walkthrough =
        options.walkthrough ? read_walkthrough_file(*options.walkthrough) : make_orbit(bounds);
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace alcove
