#pragma once
// The contract of a scene: geometry, materials, lights and animation, evaluated at a time t, with
// one walkthrough. Metres, right-handed, +Y up (as glTF). No OpenGL. State comes from the time
// alone, never from a clock, and a scene opened twice gives the same bits.

#include "core/base/camera.hpp"
#include "core/base/environment.hpp"
#include "core/base/parameters.hpp"
#include "core/base/registry.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// A picture on a surface: 8-bit sRGB codes, row 0 on top (at texture coordinate v = 0, as glTF),
/// repeated over the plane.
struct Texture {
    std::string name;
    ImageSize size;
    std::vector<std::uint8_t> rgb; ///< three a pixel, rows without padding
};

/// Triangles of one mesh that lie together: what culling keeps or leaves out.
struct Cluster {
    std::uint32_t first_index = 0; ///< into Mesh::indices, a multiple of 3
    std::uint32_t index_count = 0; ///< a positive multiple of 3
    glm::vec3 low{0.0f};           ///< bounding box, object space; holds every vertex exactly
    glm::vec3 high{0.0f};
    /// The cluster shows only back faces to every eye e with dot(normalize(cone_apex - e),
    /// cone_axis) >= cone_cutoff. A cutoff of 1 or more says that there is no such cone.
    glm::vec3 cone_apex{0.0f};
    glm::vec3 cone_axis{0.0f, 0.0f, 1.0f};
    float cone_cutoff = 1.0f;
};

/// Triangles in object space with one material.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;   ///< object space, metres
    std::vector<glm::vec3> normals;     ///< unit, one a position: shading normals
    std::vector<std::uint32_t> indices; ///< three a triangle, counter-clockwise seen from outside
    glm::vec3 albedo{0.8f};             ///< linear Rec. 709 reflectance in [0,1]
    std::vector<glm::vec3> colors; ///< none, or factors of the albedo, one a position, in [0,1]
    std::vector<glm::vec2> texture_coordinates; ///< none, or one a position
    /// Index into Scene::get_textures; its linear value is a factor of the albedo. Needs texture
    /// coordinates.
    std::optional<std::size_t> texture;
    /// True promises one or more closed solids, counter-clockwise seen from outside: an eye outside
    /// of them never sees a back face.
    bool closed = false;
    /// None (the mesh is one cluster), or a partition of `indices` in ascending order.
    std::vector<Cluster> clusters;
};

/// How an object may change over the walkthrough.
enum class ObjectMotion {
    still,    ///< a promise: one transform at all times
    rigid,    ///< its transform may change
    deforming ///< its vertices may change as well: Scene::deform gives them
};

/// One placed mesh. Its transform at a time is in Pose.
struct Object {
    std::string name;
    std::size_t mesh = 0; ///< index into Scene::get_meshes
    ObjectMotion motion = ObjectMotion::rigid;
};

/// The vertices of a deforming object at one time, in place of its mesh's and as many.
struct Deformation {
    std::vector<glm::vec3> positions; ///< object space, metres
    std::vector<glm::vec3> normals;   ///< unit
};

/// Where every object is at one time, in the order of Scene::get_objects. Affine, double: world may
/// be far from 0.
struct Pose {
    std::vector<glm::dmat4> object_to_world;
};

/// Light from infinitely far away in one direction.
struct DirectionalLight {
    glm::dvec3 to_light{0.0, 1.0, 0.0}; ///< unit, world
    glm::vec3 irradiance{0.0f};         ///< on a surface that faces the light; linear Rec. 709
    bool casts_shadow = false;          ///< false: shines through everything
};

/// Where a spot light shines: full intensity inside the inner cone, none outside the outer one,
/// in between by the square of (cos - cos outer) / (cos inner - cos outer), clamped, as glTF's
/// KHR_lights_punctual recommends.
struct SpotCone {
    glm::dvec3 direction{0.0, -1.0, 0.0};      ///< unit, world, away from the light
    double inner_radians = 0.0;                ///< half angle, in [0, outer)
    double outer_radians = 0.7853981633974483; ///< half angle, in (0, pi / 2]
};

/// A point that shines, in all directions or into a cone. Irradiance at a distance d on a surface
/// that faces it is intensity / d^2.
struct PointLight {
    glm::dvec3 position{0.0};  ///< world, metres
    glm::vec3 intensity{0.0f}; ///< linear Rec. 709, irradiance at 1 m
    std::optional<SpotCone> cone;
    bool casts_shadow = false;
};

struct Lights {
    std::vector<DirectionalLight> directional;
    std::vector<PointLight> points;
    glm::vec3 ambient{0.5f}; ///< radiance of the uniform surroundings; linear Rec. 709
    /// Replaces `ambient` where it is not null; turned about +Y, from z towards x.
    std::shared_ptr<const Environment> environment;
    double environment_turn_radians = 0.0;
};

/// Radiance that comes from the surroundings in a world direction (need not be unit, not 0).
[[nodiscard]] glm::vec3 compute_surrounding_radiance(const Lights& lights,
                                                     const glm::dvec3& direction);

/// The same between an environment's texels, which would show: what a picture has behind
/// everything.
[[nodiscard]] glm::vec3 compute_background_radiance(const Lights& lights,
                                                    const glm::dvec3& direction);

/// Irradiance on a surface with this unit normal from one light that nothing blocks, on `position`
/// (world); 0 on its back.
[[nodiscard]] glm::vec3 compute_irradiance(const DirectionalLight& light, const glm::dvec3& normal);
[[nodiscard]] glm::vec3 compute_irradiance(const PointLight& light, const glm::dvec3& position,
                                           const glm::dvec3& normal);

/// Where an object stands on one frame of its track, against its place at rest.
struct TrackKey {
    int frame = 0;
    glm::dvec3 translation{0.0}; ///< metres, world axes
    double degrees = 0.0;        ///< about the track's axis; more than a turn is allowed
};

/// The rigid motion of one object over a walkthrough: turned about `pivot`, then moved. Before its
/// first key and after its last one the object rests there.
struct ObjectTrack {
    std::string object;             ///< an Object's name
    glm::dvec3 pivot{0.0};          ///< metres, relative to the scene's origin
    glm::dvec3 axis{0.0, 1.0, 0.0}; ///< unit, world axes
    std::vector<TrackKey> keys;     ///< ascending in frame, at least one
};

/// Something that happens at a frame and that reports mark: "box lifts".
struct WalkthroughEvent {
    int frame = 0;
    std::string label;
};

/// The recorded camera path that is replayed, one camera a frame.
struct Walkthrough {
    std::string name = "default";
    double step_s = 1.0 / 30.0;  ///< fixed time step
    std::vector<Camera> cameras; ///< one a frame, at least one
    std::vector<int> cuts; ///< frames whose history is invalid, ascending; frame 0 always is one
    std::vector<ObjectTrack> tracks;
    std::vector<WalkthroughEvent> events; ///< ascending in frame
};

/// An opened scene. Everything but the pose is constant over its life.
class Scene {
  public:
    Scene() = default;
    virtual ~Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    [[nodiscard]] virtual std::span<const Mesh> get_meshes() const = 0;
    [[nodiscard]] virtual std::span<const Object> get_objects() const = 0;
    [[nodiscard]] virtual std::span<const Texture> get_textures() const { return {}; }
    [[nodiscard]] virtual const Lights& get_lights() const = 0;
    /// The lights at a time: as many, in the same order, as get_lights, which are those at time 0.
    [[nodiscard]] virtual Lights compute_lights(double /*time_s*/) const { return get_lights(); }
    [[nodiscard]] virtual const Walkthrough& get_walkthrough() const = 0;
    /// Radius of interest of ambient occlusion in metres: the default of a run's target.
    [[nodiscard]] virtual double get_ao_radius_m() const = 0;
    /// Fixed over the walkthrough. posed_geometry is relative to it; tracers subtract it from the
    /// camera in double.
    [[nodiscard]] virtual glm::dvec3 get_origin() const { return glm::dvec3(0.0); }
    [[nodiscard]] virtual Pose compute_pose(double time_s) const = 0;
    /// The vertices of a deforming object (an index into get_objects). From the time alone, so that
    /// asking for t and t - 1 gives exact motion. Asserts that the object deforms.
    [[nodiscard]] virtual Deformation deform(std::size_t object, double time_s) const;
    /// True if neither compute_pose nor deform depends on the time: a BVH is built once.
    [[nodiscard]] virtual bool is_static() const { return true; }
};

/// What the registry and `alcove list scenes` know of a scene without opening it.
struct SceneUnit {
    std::string name;
    std::string title;
    std::string stresses;      ///< what it is hard on
    std::string license;       ///< SPDX identifier or "unstated", and whom to credit
    std::string folder;        ///< filled by the registry
    std::string content_hash;  ///< filled by the registry
    bool reported = true;      ///< false for templates and test rigs: never part of a default suite
    ParameterTable parameters; ///< e.g. detail, seed
    /// Why the scene cannot be opened here, with the command that mends it; nothing if it can.
    std::function<std::optional<std::string>()> find_obstacle = [] {
        return std::optional<std::string>{};
    };
    /// Throws InputError on bad data.
    std::function<std::unique_ptr<Scene>(const ResolvedParameters&)> open;
};

/// Total number of vertices and triangles over all objects (a mesh placed twice counts twice).
struct SceneSize {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
};
[[nodiscard]] SceneSize count_size(const Scene& scene);

/// Content hash of what does not change with time: meshes, textures and objects.
[[nodiscard]] std::string hash_surfaces(const Scene& scene);

/// `surfaces` (hash_surfaces) with the pose and the deformations at `time_s` and nothing else: with
/// the camera, what decides a reference, and with hash_lights a G-buffer. Relative to the scene's
/// origin, so a scene moved as a whole keeps its hash.
[[nodiscard]] std::string hash_geometry(const Scene& scene, double time_s,
                                        std::string_view surfaces);
[[nodiscard]] std::string hash_geometry(const Scene& scene, double time_s);

/// Content hash of the lights at `time_s`.
[[nodiscard]] std::string hash_lights(const Scene& scene, double time_s);

/// Throws InputError naming `where` unless indices are in range, sizes agree, values are finite,
/// clusters partition their mesh, textures exist, lights are finite and not negative, normals are
/// unit within 1e-3, the walkthrough has a frame and valid cameras, cuts and events are ascending
/// and in range, and every track names an object once.
void check_scene(const Scene& scene, std::string_view where);

} // namespace alcove
