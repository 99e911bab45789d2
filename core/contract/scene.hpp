#pragma once
// The contract of a scene: geometry, materials, lights and animation, evaluated at a time t, with
// one walkthrough. Metres, right-handed, +Y up (as glTF). No OpenGL. State comes from the time
// alone, never from a clock, and a scene opened twice gives the same bits.

#include "core/base/camera.hpp"
#include "core/base/parameters.hpp"
#include "core/base/registry.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Triangles in object space with one material.
struct Mesh {
    std::string name;
    std::vector<glm::vec3> positions;   ///< object space, metres
    std::vector<glm::vec3> normals;     ///< unit, one a position: shading normals
    std::vector<std::uint32_t> indices; ///< three a triangle, counter-clockwise seen from outside
    glm::vec3 albedo{0.8f};             ///< linear Rec. 709 reflectance in [0,1]
};

/// One placed mesh. Its transform at a time is in Pose.
struct Object {
    std::string name;
    std::size_t mesh = 0; ///< index into Scene::get_meshes
};

/// Where every object is at one time, in the order of Scene::get_objects. Affine, double: world may
/// be far from 0.
struct Pose {
    std::vector<glm::dmat4> object_to_world;
};

/// Light from infinitely far away, without shadow: what `direct` light a picture needs to be
/// readable.
struct DirectionalLight {
    glm::dvec3 to_light{0.0, 1.0, 0.0}; ///< unit, world
    glm::vec3 irradiance{0.0f};         ///< on a surface that faces the light; linear Rec. 709
};

struct Lights {
    std::vector<DirectionalLight> directional;
    glm::vec3 ambient{0.5f}; ///< radiance of the uniform surroundings; linear Rec. 709
};

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
    [[nodiscard]] virtual const Lights& get_lights() const = 0;
    [[nodiscard]] virtual const Walkthrough& get_walkthrough() const = 0;
    /// Radius of interest of ambient occlusion in metres: the default of a run's target.
    [[nodiscard]] virtual double get_ao_radius_m() const = 0;
    /// Fixed over the walkthrough. posed_geometry is relative to it; tracers subtract it from the
    /// camera in double.
    [[nodiscard]] virtual glm::dvec3 get_origin() const { return glm::dvec3(0.0); }
    [[nodiscard]] virtual Pose compute_pose(double time_s) const = 0;
    /// True if compute_pose does not depend on the time: a BVH is built once.
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

/// Content hash of meshes, objects, lights, the pose at `time_s` and nothing else: what decides a
/// reference besides camera and target. Relative to the scene's origin, so a scene moved as a whole
/// keeps its hash.
[[nodiscard]] std::string hash_geometry(const Scene& scene, double time_s);

/// Throws InputError naming `where` unless indices are in range, sizes agree, values are finite,
/// normals are unit within 1e-3, the walkthrough has a frame and valid cameras, cuts and events are
/// ascending and in range, and every track names an object once.
void check_scene(const Scene& scene, std::string_view where);

} // namespace alcove
