#pragma once
// Parameters that every method over the shared estimators declares alike: one text for all tables.

#include "core/base/parameters.hpp"
#include "methods/common/estimator_method.hpp"
#include "methods/common/kernels.hpp"

#include <limits>

namespace alcove {

inline constexpr const char* kMattausch2010 = "Mattausch et al. 2010";
inline constexpr const char* kRitschel2009 = "Ritschel et al. 2009";

template <class P>
[[nodiscard]] ParameterBuilder describe_radius(double P::*field) {
    return real(field, "radius")
        .range(1e-4, 1e3)
        .log_scale()
        .unit("m")
        .symbol("r")
        .default_expression("scene_radius")
        .meaning("Reach of the samples.")
        .source(kMattausch2010);
}

/// Compiled into the shader: the length of its kernel. Add the source.
template <class P>
[[nodiscard]] ParameterBuilder describe_samples(int P::*field) {
    return integer(field, "samples")
        .range(1, 512)
        .log_scale()
        .rebuild()
        .unit("samples")
        .symbol("n")
        .meaning("Samples a pixel.");
}

/// Compiled into the shader: the length of each set of a tile. Add the meaning.
template <class P>
[[nodiscard]] ParameterBuilder describe_set_samples(int P::*field, const char* name = "samples") {
    return integer(field, name)
        .range(4, 256)
        .log_scale()
        .rebuild()
        .unit("samples")
        .symbol("N")
        .source(kRitschel2009);
}

/// Depth layers that samples are compared with. Add the meaning.
template <class P>
[[nodiscard]] ParameterBuilder describe_layers(int P::*field) {
    return integer(field, "layers")
        .range(1, kMostLayers)
        .rebuild()
        .unit("layers")
        .source(kRitschel2009);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_thickness(double P::*field) {
    return real(field, "thickness")
        .range(1e-3, std::numeric_limits<double>::infinity())
        .log_scale()
        .unit("m")
        .meaning("Depth of solids whose back no layer knows.")
        .source("ours; inf: Ritschel et al. 2009");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_grazing_cosine(double P::*field) {
    return real(field, "grazing_cosine")
        .range(0.0, 0.3)
        .unit("cosine")
        .symbol("eps_g")
        .meaning("Smaller elevations of a disc's surface points are rejected.")
        .source("Mattausch et al. 2010; value ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_directions(KernelDirections P::*field) {
    return choice(field, "directions", {"uniform", "cosine"})
        .rebuild()
        .meaning("Directions uniform over the hemisphere, each hit weighted by 2 cos, or "
                 "distributed as the cosine with equal weights.")
        .source(kMattausch2010);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_cut(double P::*field) {
    return real(field, "cut")
        .range(1.0, 4.0)
        .unit("r")
        .meaning("Surfaces farther than this from the receiver never count.")
        .source(kMattausch2010);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_bias(double P::*field) {
    return real(field, "bias")
        .range(0.0, 4.0)
        .unit("half pixel footprints")
        .meaning("Depth bias along the receiver's tangent plane; 1 is exact for planes at any "
                 "tilt.")
        .source("ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_tile(int P::*field) {
    return integer(field, "tile")
        .range(1, 4)
        .rebuild()
        .unit("px")
        .meaning("Side of the tile whose pixels take different sets of samples; M = tile^2.")
        .source(kRitschel2009);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_fade(double P::*field) {
    return real(field, "fade")
        .range(0.0, 0.99)
        .unit("r")
        .symbol("f")
        .meaning("Distance from which blockers fade, by a smooth step that ends at the radius.")
        .source("Ritschel et al. 2009; value ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_tile_blur(bool P::*field) {
    return boolean(field, "blur")
        .rebuild()
        .meaning("The mean over a tile, along surfaces.")
        .source(kRitschel2009);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_strength(double P::*field) {
    return real(field, "strength")
        .range(0.1, 10.0)
        .log_scale()
        .unit("1")
        .meaning(
            "Factor on occlusion; 1 is the estimate itself. What `tune` fits beside the radius.")
        .source("ours");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_border(KernelBorder P::*field) {
    return choice(field, "border", {"open", "clamp"})
        .rebuild()
        .meaning("Samples outside the image: never blocked, or compared with the nearest pixel.")
        .source("clamp: Mattausch et al. 2010");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_rotation(KernelRotation P::*field) {
    return choice(field, "rotation", {"off", "tile", "pixel"})
        .rebuild()
        .meaning("Turns the kernel about its axis: not at all, by 16 angles that repeat in 4x4 "
                 "pixels, or by a random angle a pixel.")
        .source("tile: Mittring 2007");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_resolution(EstimatorResolution P::*field) {
    return choice(field, "resolution", {"full", "half"})
        .rebuild()
        .meaning("Half: the estimate at half width and height, then upsampling along surfaces.")
        .source("Kopf et al. 2007");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_blur_radius(int P::*field) {
    return integer(field, "blur_radius")
        .range(0, 8)
        .unit("px")
        .meaning("Taps on each side of the cross-bilateral blur; 0 is off.")
        .source(kMattausch2010);
}

template <class P>
[[nodiscard]] ParameterBuilder describe_upsample_width(int P::*field) {
    return integer(field, "upsample_width")
        .range(2, 16)
        .unit("px")
        .meaning("Window of the upsampling at half resolution; 2 is linear interpolation.")
        .alive_with("resolution=half")
        .source("Kopf et al. 2007");
}

template <class P>
[[nodiscard]] ParameterBuilder describe_blur_edge(double P::*field) {
    return real(field, "blur_edge")
        .range(0.001, 10.0)
        .log_scale()
        .unit("r")
        .meaning("Distance off the receiver's tangent plane at which a tap's weight is 1/e: small "
                 "keeps edges (weak blur), large blurs over them (strong blur).")
        .source("ours");
}

} // namespace alcove
