#include "core/gl/functions.hpp"

#include "core/base/error.hpp"

namespace alcove::gl {

Functions load_functions(Resolver resolve) {
    Functions functions;
    const auto load = [resolve](auto& member, const char* name) {
        // Resolvers hand out one generic function type for all.
        member = reinterpret_cast<std::remove_reference_t<decltype(member)>>(resolve(name));
        if (member == nullptr) {
            throw FailureError("OpenGL driver", "lacks a function of OpenGL 4.5 core", name);
        }
    };
#define ALCOVE_GL_LOAD(TYPE, NAME) load(functions.NAME, "gl" #NAME);
    ALCOVE_GL_FUNCTIONS(ALCOVE_GL_LOAD)
#undef ALCOVE_GL_LOAD
    return functions;
}

} // namespace alcove::gl
