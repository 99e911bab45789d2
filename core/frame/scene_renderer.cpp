#include "core/frame/scene_renderer.hpp"

#include "core/base/error.hpp"
#include "core/frame/scene_textures.hpp"
#include "core/gl/shaders.hpp"

#include <algorithm>
#include <limits>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

/// Triangles that are drawn to find out what they hide, and how many more must be left for that to
/// pay: 50,000 take about 10 ms at 1024x768 on two cores of llvmpipe, with reading back 3 ms more.
constexpr std::size_t kHiderTriangles = 50'000;
constexpr std::size_t kWorthHiding = 4 * kHiderTriangles;

/// Texture unit of the depth that is peeled off; 0 is the albedo's.
constexpr GLuint kNearerUnit = 1;

/// One output a channel, in the order of the table, which is that of the framebuffer's attachments.
std::string make_channel_outputs(ChannelSet channels) {
    std::string text;
    int location = 0;
    for (const ChannelInfo& info : kChannels) {
        if (channels.contains(info.channel)) {
            const std::string name(info.name);
            text += "#define WRITE_" + name + "\nlayout(location = " + std::to_string(location++) +
                    ") out " + std::string(info.glsl_type) + " out_" + name + ";\n";
        }
    }
    return text;
}

bool has_placed_light(const Lights& lights) {
    return !lights.points.empty() ||
           std::any_of(lights.directional.begin(), lights.directional.end(),
                       [](const DirectionalLight& light) { return light.casts_shadow; });
}

std::string make_stream_switches(const VertexStreams& streams) {
    return std::string(streams.has_colors ? "#define HAS_COLORS\n" : "") +
           (streams.has_texture ? "#define HAS_TEXTURE\n" : "") +
           (streams.deforms ? "#define DEFORMS\n" : "");
}

} // namespace

SceneRenderer::SceneRenderer(const gl::Functions& gl, const Scene& scene, Culling culling)
    : m_gl(gl), m_scene(scene),
      m_culling(culling), m_library{embedded_frame_shaders(), embedded_gl_shaders()},
      m_geometry(gl, scene), m_textures(upload_textures(gl, scene.get_textures())),
      m_lights(gl, scene), m_has_placed_light(has_placed_light(scene.get_lights())),
      m_culler(scene), m_still(gl), m_moving(gl),
      m_rebuild(gl, m_library, "core/frame/rebuild_eye_depth.frag.glsl") {}

const SceneRenderer::Pipeline& SceneRenderer::get_pipeline(const PipelineKey& key) {
    const auto known = m_pipelines.find(key);
    if (known != m_pipelines.end()) {
        return known->second;
    }
    Pipeline pipeline;
    pipeline.is_lit = std::get<ChannelSet>(key).contains(Channel::direct_light);
    const bool needs_position = pipeline.is_lit && m_has_placed_light;
    pipeline.program = gl::build_program(
        m_gl, m_library,
        {{GL_VERTEX_SHADER, "core/frame/gbuffer.vert.glsl"},
         {GL_FRAGMENT_SHADER, "core/frame/gbuffer.frag.glsl"}},
        {{"channel_outputs.glsl", make_channel_outputs(std::get<ChannelSet>(key)) +
                                      (std::get<bool>(key) ? "#define PEELED\n" : "")},
         {"vertex_streams.glsl", make_stream_switches(std::get<VertexStreams>(key)) +
                                     (needs_position ? "#define HAS_PLACED_LIGHT\n" : "")},
         {"light_counts.glsl", SceneLights::make_shader_counts()}});
    SceneLights::connect(pipeline.program);
    pipeline.clip_from_view = pipeline.program.location("clip_from_view");
    pipeline.previous_world_from_object = pipeline.program.location("previous_world_from_object");
    return m_pipelines.emplace(key, std::move(pipeline)).first->second;
}

void SceneRenderer::clear(const GBuffer& gbuffer) const {
    GLint buffer = 0;
    for (const ChannelInfo& info : kChannels) {
        if (!gbuffer.channels().contains(info.channel)) {
            continue;
        }
        if (info.channel == Channel::instance_id) {
            const std::array<GLuint, 4> none{};
            m_gl.ClearNamedFramebufferuiv(gbuffer.framebuffer(), GL_COLOR, buffer, none.data());
        } else {
            std::array<float, 4> value{};
            if (info.channel == Channel::eye_depth) {
                value.fill(std::numeric_limits<float>::infinity());
            } else if (info.channel == Channel::motion_depth) {
                value[3] = std::numeric_limits<float>::infinity();
            }
            m_gl.ClearNamedFramebufferfv(gbuffer.framebuffer(), GL_COLOR, buffer, value.data());
        }
        ++buffer;
    }
    const float far_depth = gbuffer.precision().reversed ? 0.0f : 1.0f;
    m_gl.ClearNamedFramebufferfv(gbuffer.framebuffer(), GL_DEPTH, 0, &far_depth);
}

FramePose SceneRenderer::pose_frame(const FrameView& view) {
    FramePose pose;
    pose.now = m_scene.compute_pose(view.time_s);
    const bool is_held = view.previous_time_s == view.time_s;
    pose.before = is_held ? pose.now : m_scene.compute_pose(view.previous_time_s);
    for (std::size_t i = 0; i < m_scene.get_objects().size(); ++i) {
        if (m_scene.get_objects()[i].motion == ObjectMotion::deforming) {
            Deformation now = m_scene.deform(i, view.time_s);
            Deformation before = is_held ? now : m_scene.deform(i, view.previous_time_s);
            m_geometry.update(i, now, before);
            pose.deformed.push_back({i, std::move(now), std::move(before)});
        }
    }
    return pose;
}

VisibleSet SceneRenderer::find_visible(const FrameView& view, const FramePose& pose,
                                       const GBuffer& gbuffer, const Pass& pass,
                                       const glm::dmat4& projection) {
    const ViewVolume volume(view.camera, view.size);
    m_culler.set_frame(pose);
    if (m_culling == Culling::none) {
        return m_culler.find_all(volume);
    }
    if (pass.faces != FaceRule::as_listed) {
        return m_culler.find_in_frustum(volume);
    }
    VisibleSet visible = m_culler.find_visible(volume, std::nullopt);
    // What covers a pixel's centre need not cover its samples.
    if (m_culling != Culling::occlusion || visible.triangles < kWorthHiding ||
        gbuffer.samples() > 1) {
        return visible;
    }
    const Precision& precision = gbuffer.precision();
    const VisibleSet hiders = m_culler.choose_hiders(visible, volume, kHiderTriangles);
    m_counts.hiders = hiders.triangles;
    // Their raster depth stays: what lies behind them need not be shaded.
    if (!m_hider_depth || !(m_hider_depth.size() == view.size)) {
        m_hider_depth = gl::Texture(m_gl, GL_R32F, view.size);
    }
    const gl::FramebufferHandle framebuffer =
        gl::create_framebuffer(m_gl, {&m_hider_depth}, &gbuffer.raster_depth());
    constexpr float kFar = std::numeric_limits<float>::infinity();
    m_gl.ClearNamedFramebufferfv(framebuffer.get(), GL_COLOR, 0, &kFar);
    m_still.build(m_scene, m_geometry, hiders, pose, view.camera, [](auto) { return true; });
    draw(m_still, {Channel::eye_depth}, framebuffer.get(), view.camera, projection, {});
    std::vector<float> depth(view.size.pixel_count());
    m_gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    m_gl.GetTextureImage(m_hider_depth.get(), 0, GL_RED, GL_FLOAT,
                         static_cast<GLsizei>(depth.size() * sizeof(float)), depth.data());
    const DepthPyramid pyramid(std::move(depth), view.size);
    return m_culler.find_visible(volume, SceneCuller::Hider{pyramid, precision});
}

void SceneRenderer::draw(const DrawList& list, ChannelSet channels, GLuint framebuffer,
                         const Camera& camera, const glm::dmat4& projection, const Pass& pass) {
    if (list.empty()) {
        return;
    }
    if (pass.nearer_depth != nullptr) {
        m_gl.BindTextureUnit(kNearerUnit, pass.nearer_depth->get());
    }
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const Pipeline* last = nullptr;
    list.draw(m_geometry, pass.faces, [&](const DrawGroup& group) {
        const VertexStreams& streams = m_geometry.batch(group.batch).streams;
        const Pipeline& pipeline = get_pipeline({channels, streams, pass.nearer_depth != nullptr});
        if (&pipeline != last) {
            pipeline.program.use();
            const glm::mat4 rounded(projection);
            m_gl.UniformMatrix4fv(pipeline.clip_from_view, 1, GL_FALSE, glm::value_ptr(rounded));
            if (pipeline.is_lit) {
                m_lights.bind(camera);
            }
            last = &pipeline;
        }
        if (streams.deforms) {
            m_gl.UniformMatrix3fv(pipeline.previous_world_from_object, 1, GL_FALSE,
                                  glm::value_ptr(group.previous_world_from_object));
        }
        if (group.texture) {
            m_gl.BindTextureUnit(0, m_textures[*group.texture].get());
        }
    });
}

void SceneRenderer::draw_from_light(const LightView& light, const FramePose& pose,
                                    ChannelSet channels, GLuint framebuffer, ImageSize size) {
    const ViewVolume volume(light.camera, size);
    m_culler.set_frame(pose);
    const VisibleSet visible =
        light.is_orthographic() ? m_culler.find_all(volume) : m_culler.find_in_frustum(volume);
    m_still.build(m_scene, m_geometry, visible, pose, light.camera, [](auto) { return true; });
    draw(m_still, channels, framebuffer, light.camera, compute_projection(light),
         {FaceRule::both, nullptr});
}

void SceneRenderer::draw_shadows(const FramePose& pose) {
    if (!m_lights.are_shadows_stale()) {
        return;
    }
    m_lights.clear_atlas();
    const int side = m_lights.face_side();
    m_gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    m_gl.Enable(GL_DEPTH_TEST);
    m_gl.DepthFunc(GL_LEQUAL);
    for (const SceneLights::Face& face : m_lights.faces()) {
        m_gl.Viewport(face.left, face.bottom, side, side);
        draw_from_light(face.view, pose, {Channel::eye_depth}, m_lights.atlas_framebuffer(),
                        {side, side});
    }
    m_gl.Disable(GL_DEPTH_TEST);
}

void SceneRenderer::prepare_shadows(const FrameView& view) {
    m_lights.set_time(m_scene, view.time_s);
    if (m_lights.are_shadows_stale()) {
        draw_shadows(pose_frame(view));
    }
}

void SceneRenderer::render_light_view(const GBuffer& gbuffer, const LightView& light,
                                      const FrameView& view) {
    ALCOVE_ASSERT(gbuffer.size().width == gbuffer.size().height, "a square image");
    ALCOVE_ASSERT(gbuffer.precision() == Precision{}, "the default precision");
    const FramePose pose = pose_frame(view);
    m_lights.set_time(m_scene, view.time_s);
    if (gbuffer.channels().contains(Channel::direct_light)) {
        draw_shadows(pose);
    }
    clear(gbuffer);
    m_gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    m_gl.Enable(GL_DEPTH_TEST);
    m_gl.DepthFunc(GL_LEQUAL);
    m_gl.Viewport(0, 0, gbuffer.size().width, gbuffer.size().height);
    draw_from_light(light, pose, gbuffer.channels(), gbuffer.framebuffer(), gbuffer.size());
    m_gl.Disable(GL_DEPTH_TEST);
}

void SceneRenderer::rebuild_eye_depth(const GBuffer& gbuffer, const Camera& camera) const {
    const bool reversed = gbuffer.precision().reversed;
    m_gl.Disable(GL_DEPTH_TEST);
    m_rebuild.use();
    m_gl.BindTextureUnit(0, gbuffer.raster_depth().get());
    const auto at_near = static_cast<float>(1.0 / camera.near_m);
    const auto at_far = static_cast<float>(1.0 / camera.far_m);
    m_gl.Uniform2f(m_rebuild.location("inverse_ends"), reversed ? at_far : at_near,
                   reversed ? at_near : at_far);
    m_gl.Uniform1f(m_rebuild.location("background_depth"), reversed ? 0.0f : 1.0f);
    m_rebuild.draw(gbuffer.rebuild_framebuffer(), gbuffer.size());
}

void SceneRenderer::render(const GBuffer& gbuffer, const FrameView& view) {
    render(gbuffer, view, {});
}

void SceneRenderer::render_layer(const GBuffer& gbuffer, const FrameView& view,
                                 const GBuffer& nearer) {
    ALCOVE_ASSERT(nearer.size() == gbuffer.size() && nearer.samples() == 1,
                  "a nearer layer of the same pixels");
    if (nearer.precision().eye_depth != EyeDepth::float32 ||
        gbuffer.precision().eye_depth != EyeDepth::float32) {
        throw InputError("layers", "cannot be peeled off a coarse eye depth",
                         describe(nearer.precision()), "eye_depth=32F");
    }
    render(gbuffer, view, {FaceRule::both, &nearer.texture(Channel::eye_depth)});
}

void SceneRenderer::render_back_faces(const GBuffer& gbuffer, const FrameView& view) {
    render(gbuffer, view, {FaceRule::back, nullptr});
}

void SceneRenderer::render(const GBuffer& gbuffer, const FrameView& view, const Pass& pass) {
    ALCOVE_ASSERT(gbuffer.size() == view.size, "a G-buffer of the frame's size");
    const bool reversed = gbuffer.precision().reversed;
    const glm::dmat4 projection = compute_projection(view.camera, view.size, reversed);
    m_counts = {};
    clear(gbuffer);
    const FramePose pose = pose_frame(view);
    m_lights.set_time(m_scene, view.time_s);
    if (gbuffer.channels().contains(Channel::direct_light)) {
        draw_shadows(pose);
    }
    m_gl.Viewport(0, 0, view.size.width, view.size.height);
    m_gl.ClipControl(GL_LOWER_LEFT, reversed ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    m_gl.Enable(GL_DEPTH_TEST);
    // Of surfaces at equal depth the last one wins, whether or not hiders were drawn before.
    m_gl.DepthFunc(reversed ? GL_GEQUAL : GL_LEQUAL);
    const VisibleSet visible = find_visible(view, pose, gbuffer, pass, projection);
    m_counts.drawn = visible.triangles;
    m_counts.objects = visible.objects.size();
    // What stands still leaves the cleared motion alone. It comes first: a mover behind it then
    // fails the depth test, and one before it writes over the zero.
    const bool is_held = view.previous_time_s == view.time_s;
    const auto stands = [&](std::uint32_t object) {
        const bool deforms = m_scene.get_objects()[object].motion == ObjectMotion::deforming;
        return is_held || (!deforms &&
                           pose.now.object_to_world[object] == pose.before.object_to_world[object]);
    };
    m_still.build(m_scene, m_geometry, visible, pose, view.camera, stands);
    draw(m_still, gbuffer.still_channels(), gbuffer.still_framebuffer(), view.camera, projection,
         pass);
    m_moving.build(m_scene, m_geometry, visible, pose, view.camera,
                   [&](std::uint32_t object) { return !stands(object); });
    draw(m_moving, gbuffer.channels(), gbuffer.framebuffer(), view.camera, projection, pass);
    m_gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    if (gbuffer.rebuild_framebuffer() != 0) {
        rebuild_eye_depth(gbuffer, view.camera);
    }
    m_gl.Disable(GL_DEPTH_TEST);
}

void draw_part(SceneRenderer& renderer, const GBufferPart& part, const GBuffer& gbuffer,
               const FrameView& view, const GBuffer& nearer) {
    if (part.kind == PartKind::layer) {
        renderer.render_layer(gbuffer, view, nearer);
    } else if (part.kind == PartKind::back_faces) {
        renderer.render_back_faces(gbuffer, view);
    } else {
        renderer.render(gbuffer, view);
    }
}

} // namespace alcove
