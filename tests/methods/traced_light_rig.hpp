#pragma once
// Scenes made by hand under lights made by hand, and the path tracer's images of them.

#include "core/contract/scene.hpp"
#include "methods/common/path_tracer.hpp"

#include <vector>

namespace alcove {

/// Meshes where they are, with textures; stands still.
class LitScene final : public Scene {
  public:
    explicit LitScene(std::vector<Mesh> meshes, std::vector<Texture> textures = {},
                      glm::dvec3 origin = glm::dvec3(0.0));
    /// For who takes them from the scene.
    void set_lights(const Lights& lights) { m_lights = lights; }
    void set_camera(const Camera& camera) { m_walkthrough.cameras = {camera}; }

    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_objects; }
    [[nodiscard]] std::span<const Texture> get_textures() const override { return m_textures; }
    [[nodiscard]] const Lights& get_lights() const override { return m_lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    [[nodiscard]] double get_ao_radius_m() const override { return 0.5; }
    [[nodiscard]] glm::dvec3 get_origin() const override { return m_origin; }
    [[nodiscard]] Pose compute_pose(double time_s) const override;

  private:
    std::vector<Mesh> m_meshes;
    std::vector<Object> m_objects;
    std::vector<Texture> m_textures;
    Lights m_lights;
    Walkthrough m_walkthrough;
    glm::dvec3 m_origin;
};

inline constexpr ImageSize kTracedSize{48, 36};

/// At 0, looking along -z, 60 degrees high.
[[nodiscard]] Camera make_forward_camera();
/// At the height `y` above 0, looking down at it, 1 degree high: all pixels show the same point
/// within 2 % of the height.
[[nodiscard]] Camera make_camera_above_zero(double y);

/// Lights with nothing but these surroundings.
[[nodiscard]] Lights make_surroundings(const glm::vec3& radiance);

/// The same mesh with another albedo.
[[nodiscard]] Mesh paint(Mesh mesh, const glm::vec3& albedo);

/// Faces the viewer at z, from -half to half.
[[nodiscard]] Mesh make_wall(float half, float z);
/// Faces up at y, or down.
[[nodiscard]] Mesh make_floor(float half, float y);
[[nodiscard]] Mesh make_ceiling(float half, float y);

/// An image of kTracedSize.
[[nodiscard]] TracedRadiance trace_light(const Scene& scene, const Camera& camera,
                                         const Lights& lights, const PathSettings& settings);

[[nodiscard]] glm::vec3 get_pixel(const Image& image, int x, int y);
/// Mean over all pixels.
[[nodiscard]] glm::dvec3 compute_average(const Image& image);
[[nodiscard]] float find_largest_difference(const Image& a, const Image& b);

} // namespace alcove
