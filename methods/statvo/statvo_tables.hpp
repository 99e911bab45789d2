#pragma once
// The summed-area tables of a frame's layers: samples from depth, their layers, a table each.
//
// This work is based on: Hendrickx, Scandolo, Eisemann, Eisemann. Adaptively layered statistical
// volumetric obscurance. 2015, sections 4, 5 and 7.

#include "methods/common/parameter_block.hpp"
#include "methods/common/summed_area_table.hpp"
#include "methods/statvo/statvo.hpp"

namespace alcove {

/// Texture units that the shaders of this method agree on; tables follow from the last.
inline constexpr GLuint kStatvoRangeUnit = 3;
inline constexpr GLuint kStatvoTablesUnit = 4;
/// Tables that one evaluation reads: the layers of three adaptive levels, or a batch of slices.
inline constexpr int kStatvoBatch = 8;

class StatvoLayerTables {
  public:
    StatvoLayerTables(const gl::Functions& gl, const StatvoParams& params,
                      const ParameterBlock& parameters);
    /// `size`: of the G-buffer, border included.
    void resize(ImageSize size);
    /// Passes `statvo/downsample`, and `statvo/range` where it is asked for.
    void render_samples(const MethodInputs& inputs, PassRecorder& passes);
    /// Passes `statvo/root`, `statvo/level1` and so on: adaptive layers.
    void build_levels(PassRecorder& passes);
    /// Pass `statvo/slice`: which sample lies in which uniform layer.
    void assign_slices(PassRecorder& passes);
    /// Pass `statvo/tables<batch>`: uniform layers from kStatvoBatch * batch on.
    /// Returns how many there are.
    int build_slices(int batch, PassRecorder& passes);
    /// For an evaluation: the tables of the last level or batch, and the range.
    void bind() const;

    /// Layers that one evaluation adds up: NODE_COUNT of its shader.
    [[nodiscard]] int count_nodes() const;
    /// Tables that one frame builds of adaptive layers, or a batch of uniform ones.
    [[nodiscard]] int count_tables() const;
    /// What shaders over the tables include, for so many layers.
    [[nodiscard]] gl::GeneratedFiles make_generated_files(int nodes) const;

  private:
    [[nodiscard]] SummedAreaFormat get_format() const;
    [[nodiscard]] bool needs_range() const;
    [[nodiscard]] int find_first_table(int level) const;
    void bind_samples() const;
    void bind_level(int level) const;
    void set_space(const gl::Program& program) const;
    void render_range();
    void split_level(int level);
    /// layer: -1 for all samples.
    void build_table(const SummedAreaTable& table, int layer);

    const gl::Functions* m_gl;
    StatvoParams m_params;
    const ParameterBlock* m_parameters;
    FullScreenProgram m_downsample;
    FullScreenProgram m_range;
    std::vector<FullScreenProgram> m_partitions; ///< of level k into level k + 1
    FullScreenProgram m_slice;
    SummedAreaScan m_scan;

    ImageSize m_size;
    glm::vec2 m_tangents{1.0f};
    ImageSize m_sample_size;
    gl::Texture m_visible;
    gl::Texture m_hidden;
    gl::FramebufferHandle m_samples_framebuffer;
    struct Stage {
        gl::Texture texture;
        gl::FramebufferHandle framebuffer;
    };
    std::vector<Stage> m_ranges; ///< each of 16 x 16 of the one before; the last is one texel
    std::vector<Stage> m_layers; ///< read and written in turn
    std::size_t m_current_layers = 0;
    std::vector<SummedAreaTable> m_tables;
};

} // namespace alcove
