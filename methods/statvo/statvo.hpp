#pragma once
// Volumetric obscurance from means: the share of a box over a surface point that is filled, taken
// from the mean position of the samples in it, a layer of the frame at a time. Means come from
// summed-area tables, so that time does not depend on the box's size, and nothing is random.
//
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical
// volumetric obscurance. 2015.

#include "core/contract/method.hpp"

namespace alcove {

/// Slices of equal depth (section 4), or layers that are split in two by the mean depth around each
/// sample (section 5).
enum class StatvoLayering { uniform, adaptive };
/// Heights along the view axis (equation 4), or along the normal (equations 6 and 7).
enum class StatvoProjection { view_aligned, normal };
/// Of the view-aligned box: its bottom on the surface, or the surface in its middle.
enum class StatvoBox { surface, centre };
enum class StatvoRegions { one, four };
/// A table for each layer, or for every second one (section 7.2).
enum class StatvoTables { all, differential };
enum class StatvoNumbers { float32, float32_centred, integer };
enum class StatvoSource { visible, peeled };

struct StatvoParams {
    double radius = 0.5; ///< metres: half the box's side
    double height = 0.5; ///< metres
    StatvoLayering layering = StatvoLayering::adaptive;
    int levels = 2;  ///< of adaptive splits: 2^levels layers
    int slices = 64; ///< uniform layers
    StatvoProjection projection = StatvoProjection::normal;
    StatvoBox box = StatvoBox::surface;
    double drop = 1.0; ///< slope of psi above the box
    StatvoRegions regions = StatvoRegions::one;
    int downsample = 4; ///< pixels a sample, each way
    StatvoTables tables = StatvoTables::differential;
    StatvoNumbers numbers = StatvoNumbers::float32_centred;
    StatvoSource source = StatvoSource::visible;
    double guard = 0.0;    ///< percent of width and height on each side
    double strength = 1.0; ///< factor on obscurance
};

[[nodiscard]] ParameterTable make_statvo_table();
[[nodiscard]] MethodUnit statvo_unit();

} // namespace alcove
