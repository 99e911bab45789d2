#pragma once
// What a run is asked for, before any scene is opened.

#include "core/base/image.hpp"
#include "core/base/parameters.hpp"
#include "core/frame/precision.hpp"
#include "core/gl/context.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// "M[@PRESET][:key=value,...][#label]"
struct MethodSpec {
    std::string method;
    std::string preset = "default";
    std::vector<ParameterOverride> overrides;
    std::string label; ///< the text after '#', else the specification itself
};
/// Throws InputError naming `option` and the part that cannot be read. Names are checked when the
/// plan is made.
[[nodiscard]] MethodSpec parse_method_spec(std::string_view text,
                                           std::string_view option = "--method");

/// "WxH", each 1 to 16384. Throws InputError.
[[nodiscard]] ImageSize parse_size(std::string_view text);

struct Experiment {
    std::string name = "default";
    std::vector<std::string> scenes; ///< names or paths of glTF files; empty: all reported scenes
    std::vector<MethodSpec> methods; ///< empty: the default suite
    ImageSize size{384, 288};
    std::optional<std::string> frames; ///< "A:B"
    bool warm = false;  ///< holds the pose of A before [A,B) until histories have converged
    bool quick = false; ///< one scene, 24 frames
    int repeats = 6;
    /// What errors are measured against.
    MethodSpec reference = {"reference_ray_traced", "default", {}, "reference_ray_traced"};
    std::string target; ///< over the scene's default; empty: the default
    Precision precision;
    int reference_rays_per_half = 64;
    std::uint64_t shuffle_seed = 1;
    std::string command_line; ///< for the record
};

/// Methods of the default suite: what a newcomer sees first.
[[nodiscard]] std::vector<MethodSpec> make_default_methods();

} // namespace alcove
