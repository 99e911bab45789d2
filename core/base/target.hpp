#pragma once
// What a method is asked for: visibility, or the picture that its visibility or radiance makes.
// Belongs to the experiment, the cell and every error that is printed.

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
/// What is measured: visibility, or the tone-mapped picture that a method's image is part of.
enum class TargetOutput { visibility, radiance };
/// What a truth of radiance counts. near: occluders and senders within the radius, with the
/// falloff, which is what a method of this radius can see. full: everything there is, at full
/// weight. Methods use the radius in both.
enum class Reach { near, full };

/// The default is the default of a run, but for the radius, which comes from the scene.
struct Target {
    double radius_m = 1.0; ///< reach in metres, > 0
    Falloff falloff = Falloff::linear;
    Weighting weighting = Weighting::cosine;
    Normals normals = Normals::shading;
    TargetOutput output = TargetOutput::visibility;
    Reach reach = Reach::near; ///< full only where `output` is radiance
    friend bool operator==(const Target&, const Target&) = default;
};

[[nodiscard]] std::string_view to_text(Falloff falloff);
[[nodiscard]] std::string_view to_text(Weighting weighting);
[[nodiscard]] std::string_view to_text(Normals normals);
[[nodiscard]] std::string_view to_text(TargetOutput output);
[[nodiscard]] std::string_view to_text(Reach reach);

/// Parsers throw InputError with the nearest name.
[[nodiscard]] Falloff parse_falloff(std::string_view text);
[[nodiscard]] Weighting parse_weighting(std::string_view text);
[[nodiscard]] Normals parse_normals(std::string_view text);
[[nodiscard]] TargetOutput parse_target_output(std::string_view text);
[[nodiscard]] Reach parse_reach(std::string_view text);

/// "radius=0.5,falloff=linear,weighting=cosine,normals=shading", radius in metres, and behind it
/// ",output=radiance,reach=near" where that is the output: parse_target reads it back.
[[nodiscard]] std::string describe(const Target& target);

/// Reads "radius=R,falloff=F,weighting=W,normals=N,output=O,reach=H" over `base`, which gives what
/// is not named. Throws InputError on unknown keys, a radius that is not positive and finite, a key
/// given twice, or a full reach of visibility.
[[nodiscard]] Target parse_target(std::string_view text, const Target& base);

} // namespace alcove
