#include "methods/shadow_correction/environment_lights.hpp"

#include "methods/common/energy_runs.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

constexpr int kSide = Environment::kSide;
const glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);

/// Of a texel of the octahedral map whose centre this is. The map is a flat octahedron whose area
/// element, seen from the middle, shrinks with the cube of the distance: d omega = dx dz / |p|^3
/// with |p_x| + |p_y| + |p_z| = 1 and x, z in [-1, 1].
double compute_solid_angle(const glm::dvec3& unit) {
    const double sum = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
    return 4.0 / (double(kSide) * kSide) * sum * sum * sum;
}

} // namespace

std::vector<DirectionalLight> gather_environment_lights(const Lights& lights, int count) {
    std::vector<glm::dvec3> directions;
    std::vector<glm::dvec3> energies;
    std::vector<double> luminances;
    for (const std::size_t index : order_along_curve(kSide)) {
        const int x = static_cast<int>(index) % kSide;
        const int y = static_cast<int>(index) / kSide;
        const glm::dvec3 direction = decode_octahedral({(x + 0.5) / kSide, (y + 0.5) / kSide});
        glm::dvec3 radiance(lights.ambient);
        if (lights.environment) {
            const Image& map = lights.environment->radiance();
            radiance = {map.at(x, y, 0), map.at(x, y, 1), map.at(x, y, 2)};
        }
        directions.push_back(direction);
        energies.push_back(radiance * compute_solid_angle(direction));
        luminances.push_back(glm::dot(kLuminance, energies.back()));
    }
    std::vector<DirectionalLight> around;
    std::size_t first = 0;
    for (const std::size_t end : cut_into_runs(luminances, count)) {
        glm::dvec3 energy(0.0);
        glm::dvec3 vector(0.0);
        double luminance = 0.0;
        for (; first < end; ++first) {
            energy += energies[first];
            vector += luminances[first] * directions[first];
            luminance += luminances[first];
        }
        // All of the energy comes from the mean direction, although the mean cosine of a wide patch
        // is less: the mean irradiance over all normals is right then, since what a normal that
        // faces the patch gains one at the patch's horizon loses. A patch all around has no middle.
        const double length = glm::length(vector);
        if (length > 1e-6 * luminance) {
            around.push_back({vector / length, glm::vec3(energy), true});
        }
    }
    return around;
}

void turn_environment_lights(std::vector<DirectionalLight>& around, double turn_radians) {
    const glm::dmat3 world_from_map(
        glm::rotate(glm::dmat4(1.0), turn_radians, glm::dvec3(0.0, 1.0, 0.0)));
    for (DirectionalLight& light : around) {
        light.to_light = world_from_map * light.to_light;
    }
}

} // namespace alcove
