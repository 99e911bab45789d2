#pragma once
// A method that declares every part of a G-buffer there is and looks at what it gets.

#include "core/contract/method.hpp"

#include <memory>

namespace alcove {

/// What its frames looked like, of the frame that was rendered last.
struct PartsLog {
    int frames = 0;
    std::size_t layers = 0;
    /// Pixels of layer 2 nearer than those of layer 1, and the like: 0 where layers are in order.
    int disordered = 0;
    int deeper = 0; ///< pixels of layer 2 that hold a surface
    int behind = 0; ///< of the back faces
    std::size_t views = 0;
    ImageSize view_size;
    int samples = 0;
};

/// "parts_method": 3 layers, back faces, one view of half the resolution, 4 samples; a border of a
/// tenth.
[[nodiscard]] MethodUnit make_parts_method_unit(std::shared_ptr<PartsLog> log);

} // namespace alcove
