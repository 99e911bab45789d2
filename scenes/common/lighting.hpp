#pragma once
// Any scene under other light: what surrounds it, shadows, a lamp, lights that turn. Parameters
// that every scene understands beside its own, so that methods of directional occlusion and
// one-bounce light can be tried on any of them.

#include "core/contract/scene.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace alcove {

enum class SurroundingLight { scene, uniform, sky, two_colour, high_frequency };
enum class LampKind { none, point, spot };

struct LightingParams {
    SurroundingLight environment = SurroundingLight::scene;
    double environment_level = 1.0;
    double environment_turn = 0.0;  ///< degrees
    double environment_speed = 0.0; ///< degrees a second
    double sun = 1.0;
    bool shadows = false;
    LampKind lamp = LampKind::none;
    double lamp_level = 2.0;
    double lamp_azimuth = 35.0;   ///< degrees
    double lamp_elevation = 50.0; ///< degrees
    double lamp_distance = 1.5;   ///< bounding radii
    double lamp_speed = 0.0;      ///< degrees a second
};

struct Lighting {
    LightingParams params;
    /// An equirectangular HDR or EXR file in place of LightingParams::environment.
    std::optional<std::filesystem::path> environment_file;
};

[[nodiscard]] const ParameterTable& lighting_table();

/// The built surroundings, upright: a bright horizon below a blue zenith over a dim floor (sky);
/// red light from +x and blue light from -x, dim between (two_colour); a white and black pattern of
/// 12 by 24 fields (high_frequency). Each has a mean radiance of about `level`. Asserts another
/// than `scene`.
[[nodiscard]] Environment make_environment(SurroundingLight kind, double level);

/// The scene, which is owned from then on, under this light. Throws InputError on a file that is no
/// environment.
[[nodiscard]] std::unique_ptr<Scene> relight(std::unique_ptr<Scene> scene,
                                             const Lighting& lighting);

} // namespace alcove
