#include "core/contract/method_gbuffers.hpp"

namespace alcove {
namespace {

ImageSize grow(ImageSize size, const Border& border) {
    return {size.width + 2 * border.x, size.height + 2 * border.y};
}

} // namespace

MethodGBuffers::MethodGBuffers(const gl::Functions& gl, SceneRenderer& renderer, const Scene& scene,
                               const MethodRequests& requests, ImageSize size,
                               const Precision& precision)
    : m_renderer(renderer), m_scene(scene), m_sphere(compute_bounding_sphere(scene)),
      m_raster(renderer, m_sphere), m_surroundings(gl),
      m_border(make_border(size, requests.border)),
      m_main(gl, grow(size, m_border), kBaseChannels | requests.channels, precision) {
    FrameView plain;
    plain.size = size;
    for (const GBufferPart& part : list_parts(requests)) {
        m_parts.push_back(
            {part,
             GBuffer(gl, get_part_size(part, size, m_border), get_part_channels(requests, part),
                     precision, part.kind == PartKind::multisampled ? part.index : 1),
             plain});
    }
}

void MethodGBuffers::draw(const FrameView& view) {
    m_view = m_border == Border{} ? view : extend(view, m_border);
    m_lights = m_scene.compute_lights(view.time_s);
    m_surroundings.update(m_lights);
    m_raster.set_frame(view);
    m_renderer.render(m_main, m_view);
    const GBuffer* nearer = &m_main;
    for (Part& part : m_parts) {
        part.view = make_part_view(part.part, view, m_border, m_sphere);
        draw_part(m_renderer, part.part, part.gbuffer, part.view, *nearer);
        if (part.part.kind == PartKind::layer) {
            nearer = &part.gbuffer;
        }
    }
}

MethodInputs MethodGBuffers::make_inputs() {
    MethodInputs inputs{m_view, m_main};
    inputs.lights = &m_lights;
    inputs.surroundings = m_surroundings.look_through(m_view.camera);
    inputs.raster = &m_raster;
    for (const Part& part : m_parts) {
        add_part(inputs, part.part, part.gbuffer, part.view);
    }
    return inputs;
}

void add_part(MethodInputs& inputs, const GBufferPart& part, const GBuffer& gbuffer,
              const FrameView& view) {
    switch (part.kind) {
    case PartKind::nearest:
        break;
    case PartKind::layer:
        inputs.layers.push_back(&gbuffer);
        break;
    case PartKind::back_faces:
        inputs.back_faces = &gbuffer;
        break;
    case PartKind::view:
        inputs.views.push_back({view, &gbuffer});
        break;
    case PartKind::multisampled:
        inputs.multisampled = &gbuffer;
        break;
    }
}

} // namespace alcove
