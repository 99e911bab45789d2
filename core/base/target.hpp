#pragma once
// What ambient occlusion is asked for. Belongs to the experiment, the cell and every error that is
// printed.

#include <string>
#include <string_view>

namespace alcove {

/// Weight of a hit at distance d within the radius r: none 1, linear 1 - d/r, quadratic 1 -
/// (d/r)^2.
enum class Falloff { none, linear, quadratic };
/// Weight of a direction: cosine to the normal (over pi), or uniform over the hemisphere (over 2
/// pi).
enum class Weighting { cosine, uniform };
/// Which normal spans the hemisphere: interpolated vertex normals, or the triangle's, turned to the
/// viewer.
enum class Normals { shading, geometric };

/// The default is the default of a run, but for the radius, which comes from the scene.
struct Target {
    double radius_m = 1.0; ///< reach in metres, > 0
    Falloff falloff = Falloff::linear;
    Weighting weighting = Weighting::cosine;
    Normals normals = Normals::shading;
    friend bool operator==(const Target&, const Target&) = default;
};

[[nodiscard]] std::string_view to_text(Falloff falloff);
[[nodiscard]] std::string_view to_text(Weighting weighting);
[[nodiscard]] std::string_view to_text(Normals normals);

/// Parsers throw InputError with the nearest name.
[[nodiscard]] Falloff parse_falloff(std::string_view text);
[[nodiscard]] Weighting parse_weighting(std::string_view text);
[[nodiscard]] Normals parse_normals(std::string_view text);

/// "radius=0.5,falloff=linear,weighting=cosine,normals=shading", radius in metres: parse_target
/// reads it back.
[[nodiscard]] std::string describe(const Target& target);

/// Reads "radius=R,falloff=F,weighting=W,normals=N" over `base`, which gives what is not named.
/// Throws InputError on unknown keys, a radius that is not positive and finite, or a key given
/// twice.
[[nodiscard]] Target parse_target(std::string_view text, const Target& base);

} // namespace alcove
