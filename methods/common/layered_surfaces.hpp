#pragma once
// What methods/common/layered_surfaces.glsl reads: depth layers of the viewer and the images of
// further cameras.

#include "core/contract/method.hpp"
#include "core/frame/full_screen.hpp"

#include <string>

namespace alcove {

/// View space of `viewer` to that of `other`, composed in double.
[[nodiscard]] glm::mat4 compute_other_from_view(const Camera& other, const Camera& viewer);

/// For `#include "layer_counts.glsl"`. `is_clamped`: points outside the image are compared with the
/// nearest pixel.
[[nodiscard]] std::string make_layer_counts(int layers, int views, bool is_clamped);

/// Texture units 0 and 5 to 11, and the uniforms. The program must be current.
void bind_layered_surfaces(const gl::Functions& gl, const FullScreenProgram& program,
                           const MethodInputs& inputs);

} // namespace alcove
