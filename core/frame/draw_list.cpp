#include "core/frame/draw_list.hpp"

#include <algorithm>
#include <array>

#include <glm/matrix.hpp>

namespace alcove {
namespace {

/// The first three rows of an affine matrix.
struct Rows {
    std::array<glm::vec4, 3> rows;
};

Rows take_rows(const glm::dmat4& matrix) {
    const glm::mat4 transposed(glm::transpose(matrix));
    return {{transposed[0], transposed[1], transposed[2]}};
}

/// One instance as gbuffer.vert.glsl reads it.
struct Placement {
    Rows view_from_object;
    glm::vec3 albedo;
    GLuint instance_id;
};
static_assert(sizeof(Placement) == 64);

} // namespace

void DrawList::build(const Scene& scene, SceneGeometry& geometry, const VisibleSet& visible,
                     const FramePose& pose, const Camera& camera,
                     const std::function<bool(std::uint32_t object)>& includes) {
    std::vector<const VisibleObject*> objects;
    for (const VisibleObject& object : visible.objects) {
        if (includes(object.object)) {
            objects.push_back(&object);
        }
    }
    const auto mesh_of = [&scene](const VisibleObject* object) {
        return scene.get_objects()[object->object].mesh;
    };
    const auto batch_of = [&geometry](const VisibleObject* object) {
        return geometry.place(object->object).batch;
    };
    const auto texture_of = [&](const VisibleObject* object) {
        return scene.get_meshes()[mesh_of(object)].texture;
    };
    std::stable_sort(objects.begin(), objects.end(),
                     [&](const VisibleObject* a, const VisibleObject* b) {
                         const auto key = [&](const VisibleObject* object) {
                             return std::tuple(object->culls_back_faces, batch_of(object),
                                               texture_of(object), mesh_of(object));
                         };
                         return key(a) < key(b);
                     });
    std::vector<Placement> placements;
    std::vector<Rows> motions;
    std::vector<DrawCommand> commands;
    m_groups.clear();
    const VisibleObject* last = nullptr;
    for (const VisibleObject* object : objects) {
        const std::size_t index = object->object;
        const Mesh& mesh = scene.get_meshes()[mesh_of(object)];
        const glm::dmat4& now = pose.now.object_to_world[index];
        const glm::dmat4& before = pose.before.object_to_world[index];
        const MeshPlace& place = geometry.place(index);
        const bool starts_group = last == nullptr || batch_of(last) != place.batch ||
                                  last->culls_back_faces != object->culls_back_faces ||
                                  texture_of(last) != mesh.texture;
        if (starts_group) {
            m_groups.push_back({place.batch, object->culls_back_faces, mesh.texture,
                                glm::mat3(glm::dmat3(before)), commands.size(), 0});
        }
        const auto base_instance = static_cast<GLuint>(placements.size());
        placements.push_back({take_rows(compute_view_from_object(camera, now)), mesh.albedo,
                              static_cast<GLuint>(index + 1)});
        // p_old - p_new as one matrix: the difference is taken in double before anything is
        // rounded.
        motions.push_back(take_rows(before - now));
        const std::span ranges(visible.ranges.data() + object->first_range, object->range_count);
        const bool is_whole = ranges.size() == 1 && ranges[0].count == mesh.indices.size();
        const bool joins = !starts_group && is_whole && mesh_of(last) == mesh_of(object) &&
                           commands.back().index_count == mesh.indices.size();
        if (joins) {
            ++commands.back().instance_count;
        } else {
            for (const IndexRange& range : ranges) {
                commands.push_back({range.count, 1, place.first_index + range.first,
                                    place.base_vertex, base_instance});
                ++m_groups.back().command_count;
            }
        }
        last = object;
    }
    if (!objects.empty()) {
        upload(m_placements, std::as_bytes(std::span(placements)));
        upload(m_motions, std::as_bytes(std::span(motions)));
        upload(m_commands, std::as_bytes(std::span(commands)));
    }
}

void DrawList::draw(const SceneGeometry& geometry, FaceRule faces,
                    const std::function<void(const DrawGroup&)>& prepare) const {
    geometry.bind_instances(m_placements.buffer.get(), sizeof(Placement), m_motions.buffer.get(),
                            sizeof(Rows));
    m_gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, m_commands.buffer.get());
    m_gl.CullFace(faces == FaceRule::back ? GL_FRONT : GL_BACK);
    for (const DrawGroup& group : m_groups) {
        prepare(group);
        const bool culls =
            faces == FaceRule::back || (faces == FaceRule::as_listed && group.culls_back_faces);
        (culls ? m_gl.Enable : m_gl.Disable)(GL_CULL_FACE);
        m_gl.BindVertexArray(geometry.batch(group.batch).vertex_array.get());
        m_gl.MultiDrawElementsIndirect(
            GL_TRIANGLES, GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(group.first_command * sizeof(DrawCommand)),
            static_cast<GLsizei>(group.command_count), 0);
    }
    m_gl.Disable(GL_CULL_FACE);
    m_gl.CullFace(GL_BACK);
    m_gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

void DrawList::upload(Stream& stream, std::span<const std::byte> bytes) {
    if (stream.capacity < bytes.size()) {
        GLuint name = 0;
        m_gl.CreateBuffers(1, &name);
        stream.buffer = gl::BufferHandle(m_gl, name);
        stream.capacity = bytes.size() + bytes.size() / 2;
        m_gl.NamedBufferStorage(name, static_cast<GLsizeiptr>(stream.capacity), nullptr,
                                GL_DYNAMIC_STORAGE_BIT);
    }
    m_gl.NamedBufferSubData(stream.buffer.get(), 0, static_cast<GLsizeiptr>(bytes.size()),
                            bytes.data());
}

} // namespace alcove
