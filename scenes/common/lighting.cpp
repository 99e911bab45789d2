#include "scenes/common/lighting.hpp"

#include "core/base/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtx/rotate_vector.hpp>
#include <glm/trigonometric.hpp>

namespace alcove {
namespace {

/// A spot's half angle against what the scene's sphere fills: all of it and a little beside.
constexpr double kSpotMargin = 1.1;
constexpr double kSpotInnerShare = 0.7;

/// Sine of the angle that the ground fades into the sky over, on either side: four texels of the
/// octahedral map.
constexpr float kHorizonSine = 0.1f;

/// The middle and half the diagonal of the box around the vertices as they stand at time 0.
struct Extent {
    glm::dvec3 centre{0.0};
    double radius_m = 1.0;
};

Extent find_extent(const Scene& scene) {
    const Pose pose = scene.compute_pose(0.0);
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
        for (const glm::vec3& position :
             scene.get_meshes()[scene.get_objects()[i].mesh].positions) {
            const glm::dvec3 world(pose.object_to_world[i] * glm::dvec4(position, 1.0));
            low = glm::min(low, world);
            high = glm::max(high, world);
        }
    }
    return {0.5 * (low + high), 0.5 * glm::distance(low, high)};
}

glm::vec3 shine_as_sky(const glm::dvec3& direction) {
    const auto height = static_cast<float>(direction.y);
    const glm::vec3 ground(0.22f, 0.2f, 0.18f);
    const glm::vec3 horizon(1.6f, 1.5f, 1.35f);
    const glm::vec3 zenith(0.45f, 0.75f, 1.4f);
    const float haze = std::exp(-4.0f * std::max(height, 0.0f));
    // One side of the sky is brighter: where the sun has set.
    const auto side = static_cast<float>(0.5 + 0.5 * direction.x);
    const glm::vec3 sky = (zenith + haze * (horizon - zenith)) * (0.6f + 0.8f * side);
    // A sharp horizon would lie along the diagonals of the map's texels, and show as teeth.
    return glm::mix(ground, sky, glm::smoothstep(-kHorizonSine, kHorizonSine, height));
}

glm::vec3 shine_in_two_colours(const glm::dvec3& direction) {
    const auto side = static_cast<float>(direction.x);
    const float red = std::max(side, 0.0f);
    const float blue = std::max(-side, 0.0f);
    return glm::vec3(3.2f * red + 0.25f, 0.45f * (red + blue) + 0.25f, 3.2f * blue + 0.25f);
}

glm::vec3 shine_in_fields(const glm::dvec3& direction) {
    const double longitude = std::atan2(direction.x, -direction.z) * std::numbers::inv_pi;
    const double latitude = std::acos(std::clamp(direction.y, -1.0, 1.0)) * std::numbers::inv_pi;
    const auto column = static_cast<int>(std::floor(12.0 * (longitude + 1.0)));
    const auto row = static_cast<int>(std::floor(12.0 * latitude));
    return glm::vec3((row + column) % 2 == 0 ? 2.0f : 0.0f);
}

std::shared_ptr<const Environment> make_surroundings(const Lighting& lighting) {
    const LightingParams& params = lighting.params;
    if (lighting.environment_file) {
        const std::string where = lighting.environment_file->string();
        Image image = read_image_file(*lighting.environment_file, Domain::linear).image;
        for (float& value : image.values()) {
            value *= static_cast<float>(params.environment_level);
        }
        return std::make_shared<const Environment>(Environment::from_equirectangular(image, where));
    }
    if (params.environment == SurroundingLight::scene) {
        return nullptr;
    }
    return std::make_shared<const Environment>(
        make_environment(params.environment, params.environment_level));
}

class RelitScene final : public Scene {
  public:
    RelitScene(std::unique_ptr<Scene> scene, const Lighting& lighting)
        : m_scene(std::move(scene)), m_params(lighting.params),
          m_environment(make_surroundings(lighting)), m_extent(find_extent(*m_scene)),
          m_lights(light(m_scene->get_lights(), 0.0)) {}

    std::span<const Mesh> get_meshes() const override { return m_scene->get_meshes(); }
    std::span<const Object> get_objects() const override { return m_scene->get_objects(); }
    std::span<const Texture> get_textures() const override { return m_scene->get_textures(); }
    const Lights& get_lights() const override { return m_lights; }
    Lights compute_lights(double time_s) const override {
        return light(m_scene->compute_lights(time_s), time_s);
    }
    const Walkthrough& get_walkthrough() const override { return m_scene->get_walkthrough(); }
    double get_ao_radius_m() const override { return m_scene->get_ao_radius_m(); }
    glm::dvec3 get_origin() const override { return m_scene->get_origin(); }
    Pose compute_pose(double time_s) const override { return m_scene->compute_pose(time_s); }
    Deformation deform(std::size_t object, double time_s) const override {
        return m_scene->deform(object, time_s);
    }
    bool is_static() const override { return m_scene->is_static(); }

  private:
    Lights light(Lights lights, double time_s) const {
        if (m_environment) {
            lights.environment = m_environment;
        }
        lights.environment_turn_radians +=
            glm::radians(m_params.environment_turn + m_params.environment_speed * time_s);
        for (DirectionalLight& sun : lights.directional) {
            sun.irradiance *= static_cast<float>(m_params.sun);
            sun.casts_shadow = sun.casts_shadow || m_params.shadows;
        }
        for (PointLight& point : lights.points) {
            point.casts_shadow = point.casts_shadow || m_params.shadows;
        }
        if (m_params.lamp != LampKind::none) {
            lights.points.push_back(make_lamp(time_s));
        }
        return lights;
    }

    PointLight make_lamp(double time_s) const {
        const double azimuth = glm::radians(m_params.lamp_azimuth + m_params.lamp_speed * time_s);
        const double elevation = glm::radians(m_params.lamp_elevation);
        const glm::dvec3 direction(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                   std::cos(elevation) * std::cos(azimuth));
        const double distance = m_params.lamp_distance * m_extent.radius_m;
        PointLight lamp;
        lamp.position = m_extent.centre + distance * direction;
        lamp.intensity = glm::vec3(static_cast<float>(m_params.lamp_level * distance * distance));
        lamp.casts_shadow = m_params.shadows;
        if (m_params.lamp == LampKind::spot) {
            const double filled = std::asin(std::min(1.0 / m_params.lamp_distance, 1.0));
            const double outer = std::min(kSpotMargin * filled, 1.4);
            lamp.cone = SpotCone{-direction, kSpotInnerShare * outer, outer};
        }
        return lamp;
    }

    std::unique_ptr<Scene> m_scene;
    LightingParams m_params;
    std::shared_ptr<const Environment> m_environment; ///< null: the scene's own surroundings
    Extent m_extent;
    Lights m_lights;
};

ParameterTable make_table() {
    using P = LightingParams;
    return describe_parameters(
        "lighting",
        {
            choice(&P::environment, "environment",
                   {"scene", "uniform", "sky", "two_colour", "high_frequency"})
                .meaning("Light from all around: the scene's own, 1 everywhere, a built sky, red "
                         "from +x and blue from -x, or a pattern of 12 by 24 fields; or the path "
                         "of an equirectangular .hdr or .exr file.")
                .source("ours; Ritschel, Grosch and Seidel 2009, figures 3 and 10"),
            real(&P::environment_level, "environment_level")
                .range(0.0, 100.0)
                .unit("1")
                .meaning("Factor on an environment that is not the scene's own.")
                .source("ours"),
            real(&P::environment_turn, "environment_turn")
                .range(-360.0, 360.0)
                .unit("degrees")
                .meaning("Turns the environment about +Y, from z towards x.")
                .source("ours"),
            real(&P::environment_speed, "environment_speed")
                .range(-720.0, 720.0)
                .unit("degrees/s")
                .meaning("Turns it on over the walkthrough.")
                .source("ours"),
            real(&P::sun, "sun")
                .range(0.0, 100.0)
                .unit("1")
                .meaning("Factor on the scene's directional lights.")
                .source("ours"),
            boolean(&P::shadows, "shadows").meaning("All lights cast shadows.").source("ours"),
            choice(&P::lamp, "lamp", {"none", "point", "spot"})
                .meaning("A further light; a spot shines at the scene's middle.")
                .source("Ritschel, Grosch and Seidel 2009, figures 3 and 14"),
            real(&P::lamp_level, "lamp_level")
                .range(0.0, 100.0)
                .unit("1")
                .meaning("Irradiance of the lamp at the scene's middle.")
                .source("ours"),
            real(&P::lamp_azimuth, "lamp_azimuth")
                .range(-360.0, 360.0)
                .unit("degrees")
                .meaning("Where the lamp stands around the middle, from z towards x.")
                .source("ours"),
            real(&P::lamp_elevation, "lamp_elevation")
                .range(-90.0, 90.0)
                .unit("degrees")
                .meaning("How high it stands above the middle.")
                .source("ours"),
            real(&P::lamp_distance, "lamp_distance")
                .range(0.05, 10.0)
                .unit("bounding radii")
                .meaning("How far it stands from the middle.")
                .source("ours"),
            real(&P::lamp_speed, "lamp_speed")
                .range(-720.0, 720.0)
                .unit("degrees/s")
                .meaning("Carries it around the middle over the walkthrough.")
                .source("ours"),
        });
}

} // namespace

const ParameterTable& lighting_table() {
    static const ParameterTable table = make_table();
    return table;
}

Environment make_environment(SurroundingLight kind, double level) {
    ALCOVE_ASSERT(kind != SurroundingLight::scene, "surroundings that are built");
    const auto shine = [kind, level](const glm::dvec3& direction) {
        glm::vec3 radiance(1.0f);
        if (kind == SurroundingLight::sky) {
            radiance = shine_as_sky(direction);
        } else if (kind == SurroundingLight::two_colour) {
            radiance = shine_in_two_colours(direction);
        } else if (kind == SurroundingLight::high_frequency) {
            radiance = shine_in_fields(direction);
        }
        return radiance * static_cast<float>(level);
    };
    return Environment(shine, "built environment");
}

std::unique_ptr<Scene> relight(std::unique_ptr<Scene> scene, const Lighting& lighting) {
    return std::make_unique<RelitScene>(std::move(scene), lighting);
}

} // namespace alcove
