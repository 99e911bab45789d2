#include "methods/statvo/statvo_tables.hpp"

#include "methods/common/shaders.hpp"

#include <algorithm>

namespace alcove {
namespace {

constexpr int kRangeSide = 16; ///< texels that one of statvo_range stands for, each way

int divide_up(int a, int b) {
    return (a + b - 1) / b;
}

} // namespace

StatvoLayerTables::StatvoLayerTables(const gl::Functions& gl, const StatvoParams& params,
                                     const ParameterBlock& parameters)
    : m_gl(&gl), m_params(params), m_parameters(&parameters) {
    const auto make = [&](const std::string& name, const gl::GeneratedFiles& generated) {
        FullScreenProgram program(gl, make_method_shader_library(),
                                  "methods/statvo/statvo_" + name + ".frag.glsl", generated);
        parameters.connect(program.program());
        return program;
    };
    m_downsample = make("downsample", parameters.generated_files());
    m_range = make("range", parameters.generated_files());
    if (params.layering == StatvoLayering::uniform) {
        m_slice = make("slice", parameters.generated_files());
    } else {
        for (int level = 0; level < params.levels; ++level) {
            m_partitions.push_back(make("partition", make_generated_files(1 << level)));
        }
    }
    gl::GeneratedFiles files = make_generated_files(1);
    files["summed_area_input.glsl"] = "#include \"methods/statvo/statvo_layer_input.glsl\"\n";
    m_scan = SummedAreaScan(gl, files);
    parameters.connect(m_scan.program());
}

gl::GeneratedFiles StatvoLayerTables::make_generated_files(int nodes) const {
    const bool has_all =
        m_params.layering == StatvoLayering::uniform || m_params.tables == StatvoTables::all;
    gl::GeneratedFiles files = m_parameters->generated_files();
    files["summed_area_format.glsl"] =
        make_summed_area_glsl(get_format(), m_params.downsample > 1) + "#define NODE_COUNT " +
        std::to_string(nodes) + "\n#define HAS_ALL_TABLES " + (has_all ? "1" : "0") + "\n";
    return files;
}

SummedAreaFormat StatvoLayerTables::get_format() const {
    return m_params.numbers == StatvoNumbers::integer ? SummedAreaFormat::uint32
                                                      : SummedAreaFormat::float32;
}

bool StatvoLayerTables::needs_range() const {
    return m_params.layering == StatvoLayering::uniform ||
           m_params.numbers != StatvoNumbers::float32;
}

int StatvoLayerTables::count_nodes() const {
    return m_params.layering == StatvoLayering::uniform ? std::min(m_params.slices, kStatvoBatch)
                                                        : 1 << m_params.levels;
}

int StatvoLayerTables::count_tables() const {
    return m_params.layering == StatvoLayering::uniform
               ? count_nodes()
               : find_first_table(m_params.levels) + (1 << m_params.levels);
}

int StatvoLayerTables::find_first_table(int level) const {
    return m_params.tables == StatvoTables::all ? (1 << level) - 1 : 0;
}

void StatvoLayerTables::resize(ImageSize size) {
    const gl::Functions& gl = *m_gl;
    m_size = size;
    m_sample_size = {divide_up(size.width, m_params.downsample),
                     divide_up(size.height, m_params.downsample)};
    m_visible = gl::Texture(gl, GL_RGBA32F, m_sample_size);
    m_hidden = gl::Texture();
    if (m_params.source == StatvoSource::peeled) {
        m_hidden = gl::Texture(gl, GL_RGBA32F, m_sample_size);
        m_samples_framebuffer = gl::create_framebuffer(gl, {&m_visible, &m_hidden});
    } else {
        m_samples_framebuffer = gl::create_framebuffer(gl, {&m_visible});
    }
    const auto add_stage = [&](std::vector<Stage>& stages, GLenum format, ImageSize stage_size) {
        Stage& stage = stages.emplace_back();
        stage.texture = gl::Texture(gl, format, stage_size);
        stage.framebuffer = gl::create_framebuffer(gl, {&stage.texture});
    };
    m_ranges.clear();
    ImageSize range_size = m_sample_size;
    do {
        range_size = {divide_up(range_size.width, kRangeSide),
                      divide_up(range_size.height, kRangeSide)};
        add_stage(m_ranges, GL_RGBA32F, range_size);
    } while (range_size.pixel_count() > 1);
    m_layers.clear();
    for (int i = 0; i < 2; ++i) {
        add_stage(m_layers, GL_RG8UI, m_sample_size);
    }
    m_tables.clear();
    for (int i = 0; i < count_tables(); ++i) {
        m_tables.emplace_back(gl, get_format(), m_sample_size);
    }
}

void StatvoLayerTables::bind_samples() const {
    m_gl->BindTextureUnit(0, m_visible.get());
    m_gl->BindTextureUnit(1, m_hidden.get());
    m_gl->BindTextureUnit(2, m_layers[m_current_layers].texture.get());
    m_gl->BindTextureUnit(kStatvoRangeUnit, m_ranges.back().texture.get());
}

void StatvoLayerTables::bind_level(int level) const {
    const auto first = static_cast<std::size_t>(find_first_table(level));
    for (std::size_t i = 0; i < std::size_t{1} << level; ++i) {
        m_gl->BindTextureUnit(kStatvoTablesUnit + static_cast<GLuint>(i),
                              m_tables[first + i].texture.get());
    }
}

void StatvoLayerTables::bind() const {
    m_gl->BindTextureUnit(kStatvoRangeUnit, m_ranges.back().texture.get());
    if (m_params.layering == StatvoLayering::adaptive) {
        bind_level(m_params.levels);
        return;
    }
    for (std::size_t i = 0; i < m_tables.size(); ++i) {
        m_gl->BindTextureUnit(kStatvoTablesUnit + static_cast<GLuint>(i),
                              m_tables[i].texture.get());
    }
}

void StatvoLayerTables::set_space(const gl::Program& program) const {
    m_gl->Uniform2f(program.location("size"), static_cast<float>(m_size.width),
                    static_cast<float>(m_size.height));
    m_gl->Uniform2f(program.location("tangents"), m_tangents.x, m_tangents.y);
}

void StatvoLayerTables::render_samples(const MethodInputs& inputs, PassRecorder& passes) {
    m_tangents = glm::vec2(compute_tangents(inputs.view.camera, inputs.view.size));
    {
        const auto pass = passes.scope("statvo/downsample");
        m_downsample.use();
        m_parameters->bind();
        m_gl->BindTextureUnit(0, inputs.gbuffer.texture(Channel::eye_depth).get());
        if (m_hidden) {
            m_gl->BindTextureUnit(1, inputs.layers.front()->texture(Channel::eye_depth).get());
        }
        set_space(m_downsample.program());
        m_downsample.draw(m_samples_framebuffer.get(), m_sample_size);
    }
    if (needs_range()) {
        const auto pass = passes.scope("statvo/range");
        render_range();
    }
}

void StatvoLayerTables::render_range() {
    m_range.use();
    m_parameters->bind();
    m_gl->BindTextureUnit(0, m_visible.get());
    m_gl->BindTextureUnit(1, m_hidden.get());
    m_gl->Uniform1i(m_range.location("reads_samples"), 1);
    for (const Stage& stage : m_ranges) {
        m_range.draw(stage.framebuffer.get(), stage.texture.size());
        m_gl->BindTextureUnit(0, stage.texture.get());
        m_gl->Uniform1i(m_range.location("reads_samples"), 0);
    }
}

void StatvoLayerTables::build_table(const SummedAreaTable& table, int layer) {
    m_scan.use();
    m_parameters->bind();
    bind_samples();
    set_space(m_scan.program());
    m_gl->Uniform1i(m_scan.program().location("layer"), layer);
    m_scan.build(table);
}

void StatvoLayerTables::split_level(int level) {
    const FullScreenProgram& partition = m_partitions[static_cast<std::size_t>(level)];
    partition.use();
    m_parameters->bind();
    bind_samples();
    bind_level(level);
    set_space(partition.program());
    m_current_layers = 1 - m_current_layers;
    partition.draw(m_layers[m_current_layers].framebuffer.get(), m_sample_size);
}

/// Algorithm 1, or all tables of a level. Each sample lies in one layer, so that all layers of a
/// level are split by one pass.
void StatvoLayerTables::build_levels(PassRecorder& passes) {
    {
        const auto pass = passes.scope("statvo/root");
        build_table(m_tables.front(), -1);
    }
    for (int level = 1; level <= m_params.levels; ++level) {
        const auto pass = passes.scope("statvo/level" + std::to_string(level));
        split_level(level - 1);
        // All tables of the level, or those of the even layers.
        const bool has_all = m_params.tables == StatvoTables::all;
        const int step = has_all ? 1 : 2;
        auto table = m_tables.begin() + (has_all ? find_first_table(level) : 1 << (level - 1));
        for (int layer = 0; layer < 1 << level; layer += step) {
            build_table(*table++, layer);
        }
    }
}

void StatvoLayerTables::assign_slices(PassRecorder& passes) {
    const auto pass = passes.scope("statvo/slice");
    m_slice.use();
    m_parameters->bind();
    bind_samples();
    m_current_layers = 1 - m_current_layers;
    m_slice.draw(m_layers[m_current_layers].framebuffer.get(), m_sample_size);
}

int StatvoLayerTables::build_slices(int batch, PassRecorder& passes) {
    const auto pass = passes.scope("statvo/tables" + std::to_string(batch + 1));
    const int first = batch * kStatvoBatch;
    const int count = std::min(kStatvoBatch, m_params.slices - first);
    for (int i = 0; i < count; ++i) {
        build_table(m_tables[static_cast<std::size_t>(i)], first + i);
    }
    return count;
}

} // namespace alcove
