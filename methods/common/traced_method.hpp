#pragma once
// References that are traced on the CPU as methods among methods: over the posed geometry alone, in
// one pass `<name>/trace` that ends with the images on the GPU. A method of this shape brings a
// table and a tracer.

#include "core/base/parameters.hpp"
#include "core/contract/method.hpp"

#include <string>
#include <utility>

namespace alcove {

/// Rays in two halves with independent randomisations. `more` goes on behind the meaning.
template <class P>
[[nodiscard]] ParameterBuilder describe_reference_rays(int P::*field, const char* more = "") {
    return integer(field, "rays")
        .range(2, 16384)
        .log_scale()
        .unit("rays")
        .symbol("N")
        .meaning(
            std::string("Rays a pixel in all, in two independent halves; an odd number is rounded "
                        "down.") +
            more)
        .source("ours");
}

enum class TracedImages { visibility, visibility_and_radiance };

/// Of the view's size.
struct TracedFrame {
    Image visibility; ///< one channel, background 1
    Image radiance;   ///< linear Rec. 709, three channels, ends in half floats; empty without
};

class TracedMethod : public Method {
  public:
    TracedMethod(const gl::Functions& gl, std::string name, TracedImages images)
        : m_gl(gl), m_name(std::move(name)), m_images(images) {}

    MethodRequests get_requests() const final { return {{}, true}; }
    void resize(ImageSize size) final;
    /// Asserts that the posed geometry is there.
    MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) final;

  private:
    /// Both images, or visibility alone, as the constructor was told.
    [[nodiscard]] virtual TracedFrame trace(const MethodInputs& inputs) = 0;

    const gl::Functions& m_gl;
    std::string m_name;
    TracedImages m_images;
    gl::Texture m_visibility;
    gl::Texture m_radiance;
};

} // namespace alcove
