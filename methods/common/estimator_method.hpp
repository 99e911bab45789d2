#pragma once
// Estimators in one full-screen pass: from depth and normal around a pixel to its visibility, at
// full or half resolution, then a cross-bilateral blur or upsampling. A method of this shape brings
// a table, a kernel and the shader `methods/<name>/<name>_occlusion.frag.glsl`, which includes
// methods/common/estimator.glsl.
// Passes: `<name>/occlusion`, then `<name>/blur_x` and `<name>/blur_y` where the blur's radius is
// not 0; at half resolution `<name>/downsample`, `<name>/occlusion`, `<name>/upsample`.

#include "core/contract/method.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

namespace alcove {

enum class EstimatorResolution { full, half };

/// What an estimator reads beside the G-buffer, made anew every frame in passes of its own before
/// the occlusion pass, which finds it at texture unit 3.
class EstimatorPreparation {
  public:
    EstimatorPreparation() = default;
    virtual ~EstimatorPreparation() = default;
    EstimatorPreparation(const EstimatorPreparation&) = delete;
    EstimatorPreparation& operator=(const EstimatorPreparation&) = delete;
    virtual void resize(ImageSize size) = 0;
    /// The texture holds until the next call.
    virtual const gl::Texture& prepare(const MethodInputs& inputs, PassRecorder& passes) = 0;
};

struct EstimatorRecipe {
    std::string name;              ///< of the method and its folder
    std::vector<glm::vec4> kernel; ///< `kernel[]` of the shader's KernelBlock; may be empty
    EstimatorResolution resolution = EstimatorResolution::full;
    int blur_radius = 0;        ///< at full resolution: taps on each side, 0: no blur
    int upsample_width = 2;     ///< at half resolution: window in full-resolution pixels
    double edge_distance_m = 1; ///< off the tangent plane, where a tap's weight is 1/e
    MethodRequests requests{};  ///< beyond eye depth and normal
};

/// Of a method that declares resolution, blur_radius, upsample_width, blur_edge (in radii) and
/// radius (metres).
template <class P>
[[nodiscard]] EstimatorRecipe make_estimator_recipe(std::string name, const P& params,
                                                    std::vector<glm::vec4> kernel) {
    EstimatorRecipe recipe;
    recipe.name = std::move(name);
    recipe.kernel = std::move(kernel);
    recipe.resolution = params.resolution;
    recipe.blur_radius = params.blur_radius;
    recipe.upsample_width = params.upsample_width;
    recipe.edge_distance_m = params.blur_edge * params.radius;
    return recipe;
}

/// `preparation` may be null.
[[nodiscard]] std::unique_ptr<Method>
make_estimator_method(const gl::Functions& gl, const ParameterTable& table,
                      const ResolvedParameters& resolved, const EstimatorRecipe& recipe,
                      std::unique_ptr<EstimatorPreparation> preparation = nullptr);

} // namespace alcove
