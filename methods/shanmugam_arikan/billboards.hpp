#pragma once
// The far part on the GPU: a billboard a sphere, blended into one image.

#include "core/contract/method.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/shanmugam_arikan/shanmugam_arikan.hpp"
#include "methods/shanmugam_arikan/sphere_clusters.hpp"

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

namespace alcove {

class Billboards {
  public:
    /// `parameters` must outlive this.
    Billboards(const gl::Functions& gl, const ShanmugamArikanParams& params,
               const ParameterBlock& parameters);
    void resize(ImageSize size);
    /// Passes `shanmugam_arikan/spheres` (their places on this frame, on the CPU) and
    /// `shanmugam_arikan/far`. R32F: occlusion by additive blending, what is left open by
    /// multiplicative. Clusters are found when a scene is first seen, before the passes.
    [[nodiscard]] const gl::Texture& render(const MethodInputs& inputs, PassRecorder& passes);

  private:
    struct Instance {
        glm::vec4 sphere;    ///< view space: centre, radius
        glm::vec4 rectangle; ///< device coordinates: low, high
    };

    void find_spheres(const Scene& scene);
    void place_spheres(const MethodInputs& inputs);
    void draw(const MethodInputs& inputs) const;

    const gl::Functions& m_gl;
    ShanmugamArikanParams m_params;
    const ParameterBlock& m_parameters;
    gl::Program m_program;
    const Scene* m_scene = nullptr;
    std::optional<SpherePoser> m_poser;
    std::vector<Instance> m_instances; ///< those that show on this frame
    gl::BufferHandle m_buffer;
    gl::VertexArrayHandle m_vertex_array;
    gl::Texture m_result;
    gl::FramebufferHandle m_framebuffer;
};

} // namespace alcove
