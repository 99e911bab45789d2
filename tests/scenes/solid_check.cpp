#include "tests/scenes/solid_check.hpp"

#include <array>
#include <map>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {

SolidCheck check_solid(const Mesh& mesh) {
    std::map<std::tuple<float, float, float>, std::uint32_t> welded;
    std::vector<std::uint32_t> weld;
    for (const glm::vec3& p : mesh.positions) {
        const auto next = static_cast<std::uint32_t>(welded.size());
        weld.push_back(welded.try_emplace({p.x, p.y, p.z}, next).first->second);
    }
    SolidCheck result;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<glm::dvec3, 3> t;
        for (std::size_t k = 0; k < 3; ++k) {
            t[k] = glm::dvec3(mesh.positions[mesh.indices[i + k]]);
            ++edges[{weld[mesh.indices[i + k]], weld[mesh.indices[i + (k + 1) % 3]]}];
        }
        result.volume += glm::dot(t[0], glm::cross(t[1], t[2])) / 6.0;
    }
    for (const auto& [edge, count] : edges) {
        const auto back = edges.find({edge.second, edge.first});
        result.open_edges += count != 1 || back == edges.end() || back->second != 1 ? 1u : 0u;
    }
    return result;
}

} // namespace alcove
