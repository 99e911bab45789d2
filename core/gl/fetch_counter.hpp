#pragma once
// How often shaders fetch, a cost that no device has a say in.
//
// Programs that are built while a counter lives count every fetch from a texture or image that they
// execute, in all stages. Counting writes to memory: such programs are never timed, and since a
// shader that writes runs before the depth test, pixels that the depth test rejects count as well,
// which an ordinary program may skip.

#include "core/gl/context.hpp"
#include "core/gl/handles.hpp"

#include <cstdint>
#include <string>

namespace alcove::gl {

class FetchCounter {
  public:
    /// One at a time for a context, which must outlive it.
    explicit FetchCounter(Context& context);
    ~FetchCounter();
    FetchCounter(const FetchCounter&) = delete;
    FetchCounter& operator=(const FetchCounter&) = delete;

    /// From zero. Binds the counter's buffer: Context::reset_state() in between would end counting.
    void begin();
    /// Waits for the device; fetches since begin().
    [[nodiscard]] std::uint64_t read();

  private:
    Context& m_context;
    BufferHandle m_buffer;
};

/// GLSL that stands before a counting stage's own text. A fetch that it cannot count does not
/// compile.
[[nodiscard]] std::string make_counting_text();

} // namespace alcove::gl
