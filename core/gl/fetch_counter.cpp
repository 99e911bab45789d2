#include "core/gl/fetch_counter.hpp"

#include "core/base/assert.hpp"

#include <array>

namespace alcove::gl {
namespace {

constexpr GLuint kBinding = 7; ///< the last of the 8 that OpenGL 4.5 promises a stage
constexpr std::string_view kCountingText = R"() buffer FetchCountBlock {
    uint fetch_count;
    uint fetch_count_overflows;
};
uint count_fetch() {
    if (atomicAdd(fetch_count, 1u) == 0xffffffffu) {
        atomicAdd(fetch_count_overflows, 1u);
    }
    return 0u;
}
#define texelFetch(texels, place, level) (count_fetch(), texelFetch(texels, place, level))
#define textureLod(texels, place, level) (count_fetch(), textureLod(texels, place, level))
#define texture(texels, place) (count_fetch(), texture(texels, place))
#define imageLoad(texels, place) (count_fetch(), imageLoad(texels, place))
#define textureGather fetch_counter_does_not_know_textureGather
#define textureGrad fetch_counter_does_not_know_textureGrad
#define textureOffset fetch_counter_does_not_know_textureOffset
#define textureLodOffset fetch_counter_does_not_know_textureLodOffset
#define texelFetchOffset fetch_counter_does_not_know_texelFetchOffset
#define textureProj fetch_counter_does_not_know_textureProj
)";

using Counts = std::array<std::uint32_t, 2>; ///< low, high
constexpr Counts kZero{0, 0};

} // namespace

std::string make_counting_text() {
    return "layout(std430, binding = " + std::to_string(kBinding) + std::string(kCountingText);
}

FetchCounter::FetchCounter(Context& context)
    : m_context(context),
      m_buffer(create_buffer(context.functions(), std::as_bytes(std::span(kZero)),
                             GL_DYNAMIC_STORAGE_BIT)) {
    context.set_counts_fetches(true);
}

FetchCounter::~FetchCounter() {
    m_context.set_counts_fetches(false);
}

void FetchCounter::begin() {
    const Functions& gl = m_context.functions();
    gl.NamedBufferSubData(m_buffer.get(), 0, sizeof(kZero), kZero.data());
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kBinding, m_buffer.get());
}

std::uint64_t FetchCounter::read() {
    const Functions& gl = m_context.functions();
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    Counts counts{0, 0};
    gl.GetNamedBufferSubData(m_buffer.get(), 0, sizeof(counts), counts.data());
    return counts[0] + (std::uint64_t{counts[1]} << 32);
}

} // namespace alcove::gl
