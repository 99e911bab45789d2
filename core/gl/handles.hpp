#pragma once
// RAII handles for GL objects. Each holds the function table it was made with and must die before
// its context.

#include "core/base/image.hpp"
#include "core/gl/functions.hpp"

#include <cstddef>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <utility>

namespace alcove::gl {

/// A GL name that the function `Delete` of the table frees. Movable, not copyable; empty (0) after
/// a move.
template <auto Delete>
class Handle {
  public:
    Handle() = default;
    Handle(const Functions& gl, GLuint name) : m_gl(&gl), m_name(name) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : m_gl(other.m_gl), m_name(std::exchange(other.m_name, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            m_gl = other.m_gl;
            m_name = std::exchange(other.m_name, 0);
        }
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    [[nodiscard]] GLuint get() const noexcept { return m_name; }
    [[nodiscard]] explicit operator bool() const noexcept { return m_name != 0; }

  private:
    void reset() {
        if (m_name == 0) {
            return;
        }
        if constexpr (std::is_invocable_v<decltype(m_gl->*Delete), GLuint>) {
            (m_gl->*Delete)(m_name);
        } else {
            (m_gl->*Delete)(1, &m_name);
        }
    }
    const Functions* m_gl = nullptr;
    GLuint m_name = 0;
};

using TextureHandle = Handle<&Functions::DeleteTextures>;
using BufferHandle = Handle<&Functions::DeleteBuffers>;
using FramebufferHandle = Handle<&Functions::DeleteFramebuffers>;
using VertexArrayHandle = Handle<&Functions::DeleteVertexArrays>;
using QueryHandle = Handle<&Functions::DeleteQueries>;
using ShaderHandle = Handle<&Functions::DeleteShader>;
using ProgramHandle = Handle<&Functions::DeleteProgram>;

/// An immutable 2D texture with one level, nearest filtering and clamp-to-edge (the fastest fetch
/// on llvmpipe).
class Texture {
  public:
    Texture() = default;
    /// `format` is sized, e.g. GL_R32F.
    Texture(const Functions& gl, GLenum format, ImageSize size);
    /// One of `samples` a pixel, at fixed places; read by sampler2DMS alone. Throws InputError
    /// above what the device offers.
    Texture(const Functions& gl, GLenum format, ImageSize size, int samples);
    [[nodiscard]] GLuint get() const noexcept { return m_handle.get(); }
    [[nodiscard]] GLenum format() const noexcept { return m_format; }
    [[nodiscard]] ImageSize size() const noexcept { return m_size; }
    [[nodiscard]] explicit operator bool() const noexcept { return static_cast<bool>(m_handle); }

  private:
    TextureHandle m_handle;
    GLenum m_format = 0;
    ImageSize m_size;
};

/// An immutable buffer. `bytes` must not be empty.
[[nodiscard]] BufferHandle create_buffer(const Functions& gl, std::span<const std::byte> bytes,
                                         GLbitfield flags = 0);

/// A framebuffer over colour textures in order, and a depth texture if not null. Throws
/// FailureError if incomplete.
[[nodiscard]] FramebufferHandle create_framebuffer(const Functions& gl,
                                                   std::initializer_list<const Texture*> colors,
                                                   const Texture* depth = nullptr);
[[nodiscard]] FramebufferHandle create_framebuffer(const Functions& gl,
                                                   std::span<const Texture* const> colors,
                                                   const Texture* depth = nullptr);

/// Reads `channels` float channels (1 to 4) of a texture, or the whole numbers of an R32UI one
/// (exact up to 2^24); row 0 of the image is the top row, which is the texture's last.
[[nodiscard]] Image read_texture(const Functions& gl, const Texture& texture, int channels);

/// Uploads an image (row 0 on top) into a texture with the same size and at least its channels.
void write_texture(const Functions& gl, const Texture& texture, const Image& image);

} // namespace alcove::gl
