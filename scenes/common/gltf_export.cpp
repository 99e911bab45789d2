#include "scenes/common/gltf_export.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/glb_builder.hpp"
#include "scenes/common/gltf_export_motion.hpp"
#include "scenes/common/texture_codec.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/gtx/quaternion.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

constexpr int kVertexArray = 34962;

template <class Vector>
std::span<const float> flatten(const std::vector<Vector>& vectors) {
    return {&vectors.front().x, vectors.size() * (sizeof(Vector) / sizeof(float))};
}

nlohmann::json to_json(const glm::dmat4& matrix) {
    nlohmann::json values = nlohmann::json::array();
    for (int i = 0; i < 16; ++i) {
        values.push_back(matrix[i / 4][i % 4]);
    }
    return values;
}

nlohmann::json to_json(const glm::dquat& q) {
    return {q.x, q.y, q.z, q.w};
}

nlohmann::json to_json(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// Of a light, in the world.
struct LightPlace {
    glm::dvec3 position{0.0};
    glm::dvec3 backward{0.0, 0.0, 1.0}; ///< against the direction it shines in
};

class SceneExporter {
  public:
    SceneExporter(const Scene& scene, std::string file)
        : m_scene(scene), m_glb(std::move(file)),
          m_motion(m_glb, scene.get_walkthrough().cameras.size(), scene.get_walkthrough().step_s) {}

    [[nodiscard]] std::string write() {
        add_textures();
        sample_poses();
        for (std::size_t i = 0; i < m_scene.get_objects().size(); ++i) {
            add_object(i);
        }
        add_lights();
        add_camera();
        m_motion.finish();
        const std::size_t root = m_glb.add("nodes", {{"name", "scene"},
                                                     {"translation", to_json(m_scene.get_origin())},
                                                     {"children", m_children}});
        m_glb.add("scenes", {{"nodes", nlohmann::json::array({root})}});
        return m_glb.finish();
    }

    [[nodiscard]] std::set<std::string> take_warnings() { return std::move(m_warnings); }

  private:
    void add_textures() {
        for (const Texture& texture : m_scene.get_textures()) {
            const std::string png = encode_texture(texture);
            const std::size_t view = m_glb.add_view(std::as_bytes(std::span(png)));
            const std::size_t image = m_glb.add(
                "images",
                {{"name", texture.name}, {"mimeType", "image/png"}, {"bufferView", view}});
            m_glb.add("textures", {{"source", image}});
        }
    }

    /// Of every object that moves rigidly, where it is at each frame, relative to the origin.
    void sample_poses() {
        const Walkthrough& walkthrough = m_scene.get_walkthrough();
        const std::size_t frames = m_scene.is_static() ? 1 : walkthrough.cameras.size();
        const auto objects = m_scene.get_objects();
        m_poses.resize(objects.size());
        for (std::size_t frame = 0; frame < frames; ++frame) {
            const Pose pose = m_scene.compute_pose(static_cast<double>(frame) * walkthrough.step_s);
            for (std::size_t i = 0; i < objects.size(); ++i) {
                if (frame == 0 || objects[i].motion != ObjectMotion::still) {
                    m_poses[i].push_back(pose.object_to_world[i]);
                    m_poses[i].back()[3] -= glm::dvec4(m_scene.get_origin(), 0.0);
                }
            }
        }
    }

    void add_object(std::size_t index) {
        const Object& object = m_scene.get_objects()[index];
        const std::vector<glm::dmat4>& poses = m_poses[index];
        nlohmann::json node{{"name", object.name}, {"mesh", find_mesh(index)}};
        const bool moves =
            std::any_of(poses.begin(), poses.end(),
                        [&poses](const glm::dmat4& pose) { return pose != poses.front(); });
        if (!moves) {
            node["matrix"] = to_json(poses.front());
            m_children.push_back(m_glb.add("nodes", std::move(node)));
            return;
        }
        if (const auto places = split_all(poses, glm::dmat4(1.0))) {
            node["scale"] = to_json(places->front().scale);
            const std::size_t place = m_glb.add("nodes", std::move(node));
            m_motion.add(place, *places);
            m_children.push_back(place);
            return;
        }
        // What shears at rest may still move rigidly: the motion on a node of its own.
        node["matrix"] = to_json(poses.front());
        const std::size_t inner = m_glb.add("nodes", std::move(node));
        if (const auto places = split_all(poses, glm::inverse(poses.front()))) {
            const std::size_t outer =
                m_glb.add("nodes", {{"name", object.name + " moves"},
                                    {"children", nlohmann::json::array({inner})}});
            m_motion.add(outer, *places);
            m_children.push_back(outer);
            return;
        }
        m_warnings.insert("stands as on frame 0, its motion shears: " + object.name);
        m_children.push_back(inner);
    }

    [[nodiscard]] static std::optional<std::vector<NodePlace>>
    split_all(const std::vector<glm::dmat4>& poses, const glm::dmat4& inner) {
        std::vector<NodePlace> places;
        for (const glm::dmat4& pose : poses) {
            const auto place = split_transform(pose * inner);
            if (!place) {
                return std::nullopt;
            }
            places.push_back(*place);
        }
        return places;
    }

    /// Deforming objects have meshes of their own, the others share them. A reader turns the
    /// triangles of a mirroring node around (glTF 2.0, 3.7.4), and a scene has them turned already.
    [[nodiscard]] std::size_t find_mesh(std::size_t index) {
        const Object& object = m_scene.get_objects()[index];
        const bool is_turned = glm::determinant(glm::dmat3(m_poses[index].front())) < 0.0;
        const Mesh& mesh = m_scene.get_meshes()[object.mesh];
        if (object.motion == ObjectMotion::deforming) {
            m_warnings.insert("stands as on frame 0, its vertices do not move: " + object.name);
            const Deformation shape = m_scene.deform(index, 0.0);
            return add_mesh(mesh, shape.positions, shape.normals, is_turned);
        }
        const auto key = std::pair(object.mesh, is_turned);
        const auto known = m_meshes.find(key);
        if (known != m_meshes.end()) {
            return known->second;
        }
        return m_meshes.emplace(key, add_mesh(mesh, mesh.positions, mesh.normals, is_turned))
            .first->second;
    }

    [[nodiscard]] std::size_t add_mesh(const Mesh& mesh, const std::vector<glm::vec3>& positions,
                                       const std::vector<glm::vec3>& normals, bool is_turned) {
        std::vector<std::uint32_t> indices = mesh.indices;
        for (std::size_t i = 0; is_turned && i < indices.size(); i += 3) {
            std::swap(indices[i + 1], indices[i + 2]);
        }
        nlohmann::json attributes{
            {"POSITION", m_glb.add_floats(flatten(positions), 3, kVertexArray)},
            {"NORMAL", m_glb.add_floats(flatten(normals), 3, kVertexArray)}};
        if (!mesh.colors.empty()) {
            attributes["COLOR_0"] = m_glb.add_floats(flatten(mesh.colors), 3, kVertexArray);
        }
        if (!mesh.texture_coordinates.empty()) {
            attributes["TEXCOORD_0"] =
                m_glb.add_floats(flatten(mesh.texture_coordinates), 2, kVertexArray);
        }
        const nlohmann::json primitive{{"attributes", attributes},
                                       {"indices", m_glb.add_indices(indices)},
                                       {"material", find_material(mesh)}};
        return m_glb.add("meshes",
                         {{"name", mesh.name}, {"primitives", nlohmann::json::array({primitive})}});
    }

    [[nodiscard]] std::size_t find_material(const Mesh& mesh) {
        const auto key = std::tuple(mesh.albedo.x, mesh.albedo.y, mesh.albedo.z, mesh.texture);
        const auto known = m_materials.find(key);
        if (known != m_materials.end()) {
            return known->second;
        }
        const glm::dvec3 albedo(mesh.albedo);
        nlohmann::json base{{"baseColorFactor", {albedo.x, albedo.y, albedo.z, 1.0}},
                            {"metallicFactor", 0.0}};
        if (mesh.texture) {
            base["baseColorTexture"] = {{"index", *mesh.texture}};
        }
        const std::size_t material = m_glb.add("materials", {{"pbrMetallicRoughness", base}});
        m_materials.emplace(key, material);
        return material;
    }

    /// A node with a light whose strength is colour times intensity, where `find_place` has it in
    /// the lights of a frame. It shines along its -z.
    template <class FindPlace>
    void add_light(nlohmann::json light, const glm::vec3& strength,
                   const std::vector<Lights>& frames, FindPlace find_place) {
        const double intensity = std::max({strength.x, strength.y, strength.z});
        const glm::dvec3 color =
            intensity > 0.0 ? glm::dvec3(strength) / intensity : glm::dvec3(1.0);
        std::vector<NodePlace> places;
        for (const Lights& lights : frames) {
            const LightPlace place = find_place(lights);
            places.push_back({place.position - m_scene.get_origin(),
                              glm::rotation(glm::dvec3(0.0, 0.0, 1.0), place.backward),
                              glm::dvec3(1.0)});
        }
        const NodePlace& first = places.front();
        const std::size_t node = m_glb.add(
            "nodes", {{"name", "light " + std::to_string(m_lights.size())},
                      {"translation", to_json(first.translation)},
                      {"rotation", to_json(first.rotation)},
                      {"extensions", {{"KHR_lights_punctual", {{"light", m_lights.size()}}}}}});
        if (std::any_of(places.begin(), places.end(), [&first](const NodePlace& place) {
                return place.translation != first.translation || place.rotation != first.rotation;
            })) {
            m_motion.add(node, places);
        }
        m_children.push_back(node);
        light["color"] = to_json(color);
        light["intensity"] = intensity;
        m_lights.push_back(std::move(light));
    }

    void add_lights() {
        const Walkthrough& walkthrough = m_scene.get_walkthrough();
        std::vector<Lights> frames;
        for (std::size_t frame = 0; frame < walkthrough.cameras.size(); ++frame) {
            frames.push_back(
                m_scene.compute_lights(static_cast<double>(frame) * walkthrough.step_s));
        }
        const Lights& lights = m_scene.get_lights();
        for (std::size_t i = 0; i < lights.directional.size(); ++i) {
            add_light({{"type", "directional"}}, lights.directional[i].irradiance, frames,
                      [this, i](const Lights& frame) {
                          return LightPlace{m_scene.get_origin(), frame.directional[i].to_light};
                      });
        }
        for (std::size_t i = 0; i < lights.points.size(); ++i) {
            nlohmann::json light{{"type", "point"}};
            if (const auto& cone = lights.points[i].cone) {
                light = {{"type", "spot"},
                         {"spot",
                          {{"innerConeAngle", cone->inner_radians},
                           {"outerConeAngle", cone->outer_radians}}}};
            }
            add_light(std::move(light), lights.points[i].intensity, frames,
                      [i](const Lights& frame) {
                          const PointLight& point = frame.points[i];
                          return LightPlace{point.position, point.cone ? -point.cone->direction
                                                                       : glm::dvec3(0.0, 0.0, 1.0)};
                      });
        }
        if (!m_lights.empty()) {
            m_glb.use_extension("KHR_lights_punctual", {{"lights", std::move(m_lights)}});
        }
        if (lights.environment || lights.ambient != glm::vec3(0.0f)) {
            m_warnings.insert("the light of the surroundings is left out");
        }
    }

    void add_camera() {
        const std::vector<Camera>& cameras = m_scene.get_walkthrough().cameras;
        const Camera& first = cameras.front();
        const std::size_t camera = m_glb.add(
            "cameras",
            {{"type", "perspective"},
             {"perspective",
              {{"yfov", first.fov_y_radians}, {"znear", first.near_m}, {"zfar", first.far_m}}}});
        std::vector<NodePlace> places;
        for (const Camera& own : cameras) {
            places.push_back({own.position - m_scene.get_origin(),
                              glm::normalize(glm::quat_cast(own.world_from_view)),
                              glm::dvec3(1.0)});
            if (own.fov_y_radians != first.fov_y_radians || own.near_m != first.near_m ||
                own.far_m != first.far_m) {
                m_warnings.insert("the camera keeps the angle of view and the planes of frame 0");
            }
        }
        const std::size_t node =
            m_glb.add("nodes", {{"name", "camera"},
                                {"camera", camera},
                                {"translation", to_json(places.front().translation)},
                                {"rotation", to_json(places.front().rotation)}});
        m_motion.add(node, places);
        m_children.push_back(node);
    }

    using MaterialKey = std::tuple<float, float, float, std::optional<std::size_t>>;

    const Scene& m_scene;
    GlbBuilder m_glb;
    MotionExporter m_motion;
    std::set<std::string> m_warnings;
    std::vector<std::vector<glm::dmat4>> m_poses; ///< of each object, a frame; one if it is still
    std::map<std::pair<std::size_t, bool>, std::size_t> m_meshes; ///< by mesh, turned or not
    std::map<MaterialKey, std::size_t> m_materials;
    std::vector<std::size_t> m_children;
    nlohmann::json m_lights = nlohmann::json::array();
};

} // namespace

std::set<std::string> export_gltf(const Scene& scene, const std::filesystem::path& path) {
    SceneExporter exporter(scene, path.string());
    write_file_atomically(path, exporter.write());
    return exporter.take_warnings();
}

} // namespace alcove
