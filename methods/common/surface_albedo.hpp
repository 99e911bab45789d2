#pragma once
// The albedo of what a ray hit: the rasteriser's, but for its mip levels.

#include "methods/common/traced_surface.hpp"

#include "core/base/image.hpp"
#include "core/contract/scene.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

class SurfaceAlbedo {
  public:
    /// Decodes the scene's textures, unless they already are those of this scene, which must
    /// outlive its use. Null: a geometry without textures.
    void update(const Scene* scene);

    /// Linear Rec. 709: the mesh's albedo by its vertex colours by its texture, which is decoded
    /// before it is filtered: bilinear, repeated, in full resolution.
    [[nodiscard]] glm::vec3 look_up(const TracedSurface& surface) const;

  private:
    const Scene* m_scene = nullptr;
    std::vector<Image> m_textures; ///< linear
};

} // namespace alcove
