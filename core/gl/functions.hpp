#pragma once
// The OpenGL 4.5 core functions that Alcove calls, as one table filled by the context that is in
// use. There is no global loader: linking libGL and OSMesa together would clash, and OSMesa is not
// among the resolvers of the usual loaders.

#include <GL/glcorearb.h>

// One line a function: type's middle, member's name.
#define ALCOVE_GL_FUNCTIONS(X)                                                                     \
    X(ATTACHSHADER, AttachShader)                                                                  \
    X(BEGINQUERY, BeginQuery)                                                                      \
    X(BINDBUFFERBASE, BindBufferBase)                                                              \
    X(BINDBUFFER, BindBuffer)                                                                      \
    X(BINDFRAMEBUFFER, BindFramebuffer)                                                            \
    X(BINDIMAGETEXTURE, BindImageTexture)                                                          \
    X(BINDSAMPLER, BindSampler)                                                                    \
    X(BINDTEXTUREUNIT, BindTextureUnit)                                                            \
    X(BINDVERTEXARRAY, BindVertexArray)                                                            \
    X(BLENDEQUATION, BlendEquation)                                                                \
    X(BLENDFUNC, BlendFunc)                                                                        \
    X(CHECKNAMEDFRAMEBUFFERSTATUS, CheckNamedFramebufferStatus)                                    \
    X(CLEARNAMEDFRAMEBUFFERFV, ClearNamedFramebufferfv)                                            \
    X(CLEARNAMEDFRAMEBUFFERUIV, ClearNamedFramebufferuiv)                                          \
    X(CLEARTEXIMAGE, ClearTexImage)                                                                \
    X(CLIENTWAITSYNC, ClientWaitSync)                                                              \
    X(CLIPCONTROL, ClipControl)                                                                    \
    X(COLORMASK, ColorMask)                                                                        \
    X(COMPILESHADER, CompileShader)                                                                \
    X(CREATEBUFFERS, CreateBuffers)                                                                \
    X(CREATEFRAMEBUFFERS, CreateFramebuffers)                                                      \
    X(CREATEPROGRAM, CreateProgram)                                                                \
    X(CREATEQUERIES, CreateQueries)                                                                \
    X(CREATESHADER, CreateShader)                                                                  \
    X(CREATETEXTURES, CreateTextures)                                                              \
    X(CREATEVERTEXARRAYS, CreateVertexArrays)                                                      \
    X(CULLFACE, CullFace)                                                                          \
    X(DEBUGMESSAGECALLBACK, DebugMessageCallback)                                                  \
    X(DELETEBUFFERS, DeleteBuffers)                                                                \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)                                                      \
    X(DELETEPROGRAM, DeleteProgram)                                                                \
    X(DELETEQUERIES, DeleteQueries)                                                                \
    X(DELETESHADER, DeleteShader)                                                                  \
    X(DELETESYNC, DeleteSync)                                                                      \
    X(DELETETEXTURES, DeleteTextures)                                                              \
    X(DELETEVERTEXARRAYS, DeleteVertexArrays)                                                      \
    X(DEPTHFUNC, DepthFunc)                                                                        \
    X(DEPTHMASK, DepthMask)                                                                        \
    X(DISABLE, Disable)                                                                            \
    X(DISPATCHCOMPUTE, DispatchCompute)                                                            \
    X(DRAWARRAYS, DrawArrays)                                                                      \
    X(DRAWARRAYSINSTANCED, DrawArraysInstanced)                                                    \
    X(DRAWELEMENTS, DrawElements)                                                                  \
    X(DRAWELEMENTSBASEVERTEX, DrawElementsBaseVertex)                                              \
    X(ENABLE, Enable)                                                                              \
    X(ENABLEVERTEXARRAYATTRIB, EnableVertexArrayAttrib)                                            \
    X(ENDQUERY, EndQuery)                                                                          \
    X(FENCESYNC, FenceSync)                                                                        \
    X(FINISH, Finish)                                                                              \
    X(FLUSH, Flush)                                                                                \
    X(FRONTFACE, FrontFace)                                                                        \
    X(GENERATETEXTUREMIPMAP, GenerateTextureMipmap)                                                \
    X(GETERROR, GetError)                                                                          \
    X(GETINTEGER64V, GetInteger64v)                                                                \
    X(GETINTEGERV, GetIntegerv)                                                                    \
    X(GETNAMEDBUFFERSUBDATA, GetNamedBufferSubData)                                                \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                        \
    X(GETPROGRAMIV, GetProgramiv)                                                                  \
    X(GETQUERYOBJECTUI64V, GetQueryObjectui64v)                                                    \
    X(GETSHADERINFOLOG, GetShaderInfoLog)                                                          \
    X(GETSHADERIV, GetShaderiv)                                                                    \
    X(GETSTRING, GetString)                                                                        \
    X(GETSTRINGI, GetStringi)                                                                      \
    X(GETTEXTUREIMAGE, GetTextureImage)                                                            \
    X(GETUNIFORMBLOCKINDEX, GetUniformBlockIndex)                                                  \
    X(GETUNIFORMLOCATION, GetUniformLocation)                                                      \
    X(LINKPROGRAM, LinkProgram)                                                                    \
    X(MEMORYBARRIER, MemoryBarrier)                                                                \
    X(MULTIDRAWELEMENTSINDIRECT, MultiDrawElementsIndirect)                                        \
    X(NAMEDBUFFERSTORAGE, NamedBufferStorage)                                                      \
    X(NAMEDBUFFERSUBDATA, NamedBufferSubData)                                                      \
    X(NAMEDFRAMEBUFFERDRAWBUFFERS, NamedFramebufferDrawBuffers)                                    \
    X(NAMEDFRAMEBUFFERTEXTURE, NamedFramebufferTexture)                                            \
    X(PIXELSTOREI, PixelStorei)                                                                    \
    X(POLYGONMODE, PolygonMode)                                                                    \
    X(QUERYCOUNTER, QueryCounter)                                                                  \
    X(SHADERSOURCE, ShaderSource)                                                                  \
    X(TEXTUREPARAMETERI, TextureParameteri)                                                        \
    X(TEXTURESTORAGE2D, TextureStorage2D)                                                          \
    X(TEXTURESTORAGE2DMULTISAMPLE, TextureStorage2DMultisample)                                    \
    X(TEXTURESUBIMAGE2D, TextureSubImage2D)                                                        \
    X(UNIFORM1F, Uniform1f)                                                                        \
    X(UNIFORM1I, Uniform1i)                                                                        \
    X(UNIFORM1UI, Uniform1ui)                                                                      \
    X(UNIFORM2F, Uniform2f)                                                                        \
    X(UNIFORM2I, Uniform2i)                                                                        \
    X(UNIFORM3F, Uniform3f)                                                                        \
    X(UNIFORM4F, Uniform4f)                                                                        \
    X(UNIFORMBLOCKBINDING, UniformBlockBinding)                                                    \
    X(UNIFORMMATRIX3FV, UniformMatrix3fv)                                                          \
    X(UNIFORMMATRIX4FV, UniformMatrix4fv)                                                          \
    X(USEPROGRAM, UseProgram)                                                                      \
    X(VERTEXARRAYATTRIBBINDING, VertexArrayAttribBinding)                                          \
    X(VERTEXARRAYATTRIBFORMAT, VertexArrayAttribFormat)                                            \
    X(VERTEXARRAYATTRIBIFORMAT, VertexArrayAttribIFormat)                                          \
    X(VERTEXARRAYBINDINGDIVISOR, VertexArrayBindingDivisor)                                        \
    X(VERTEXARRAYELEMENTBUFFER, VertexArrayElementBuffer)                                          \
    X(VERTEXARRAYVERTEXBUFFER, VertexArrayVertexBuffer)                                            \
    X(VIEWPORT, Viewport)

namespace alcove::gl {

/// Valid while the context that filled it lives and is current.
struct Functions {
#define ALCOVE_GL_MEMBER(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
    ALCOVE_GL_FUNCTIONS(ALCOVE_GL_MEMBER)
#undef ALCOVE_GL_MEMBER
    /// Programs built with this table count their fetches (core/gl/fetch_counter.hpp).
    bool counts_fetches = false;
};

/// Fills the table through `resolve(name)`. Throws FailureError naming the first function the
/// driver lacks.
using Resolver = void (*(*)(const char*))();
[[nodiscard]] Functions load_functions(Resolver resolve);

} // namespace alcove::gl
