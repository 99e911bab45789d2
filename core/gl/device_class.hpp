#pragma once
// What kind of hardware executes the passes, read from what the driver says about itself.

#include <string_view>

namespace alcove::gl {

enum class DeviceClass {
    software,   ///< passes run on the CPU: llvmpipe, softpipe, SwiftShader, Microsoft Basic Render
    integrated, ///< a GPU that shares memory with its CPU
    discrete,   ///< a card with memory of its own
    datacentre, ///< a compute card in a server
    translated, ///< OpenGL through another interface or a hypervisor (D3D12, Zink, ANGLE, virgl,
                ///< Apple's over Metal): the layer costs time of its own, whatever GPU is below
    unclassified, ///< no known name. Never guessed: a wrong class would let times of unlike devices
                  ///< be compared
};
[[nodiscard]] std::string_view to_text(DeviceClass device_class);

/// The class of GL_VENDOR and GL_RENDERER. Names are compared without case as whole words, (TM) and
/// (R) left out. What executes counts more than what is between: Zink, D3D12, ANGLE or virgl over a
/// software rasteriser is software. Names go by what vendors sold up to 2025; a part that is sold
/// under one name both as a chip's GPU and as a card goes by its model number (Arc A770 and Vega 64
/// are cards, Arc 140V and Vega 8 are not).
[[nodiscard]] DeviceClass classify_device(std::string_view vendor, std::string_view renderer);

} // namespace alcove::gl
