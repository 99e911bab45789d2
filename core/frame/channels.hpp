#pragma once
// The G-buffer as one table of channels. A method reads only what it declares; what goes beyond the
// base is its input cost.

#include "core/gl/functions.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace alcove {

enum class Channel { eye_depth, normal, albedo, direct_light, motion, instance_id, motion_depth };

struct ChannelInfo {
    Channel channel;
    std::string_view name;
    GLenum format;              ///< as stored; eye_depth and motion may be changed by Precision
    std::string_view glsl_type; ///< of the fragment output
    int components;
    std::string_view meaning;
};

inline constexpr std::array kChannels{
    ChannelInfo{Channel::eye_depth, "eye_depth", GL_R32F, "float", 1,
                "positive distance along the view axis in metres; +infinity on the background"},
    ChannelInfo{Channel::normal, "normal", GL_RGBA16F, "vec4", 3,
                "view-space unit shading normal, turned to the viewer; 0 on the background; a is 1 "
                "where the surface is seen from behind"},
    ChannelInfo{Channel::albedo, "albedo", GL_RGBA16F, "vec4", 3, "linear Rec. 709 reflectance"},
    ChannelInfo{Channel::direct_light, "direct_light", GL_RGBA16F, "vec4", 3,
                "reflected direct radiance, linear Rec. 709; of deeper layers on the side that the "
                "mesh's normal points to"},
    ChannelInfo{Channel::motion, "motion", GL_RGBA16F, "vec4", 3,
                "object motion p_old - p_new in world axes, metres; exactly 0 for static points"},
    ChannelInfo{Channel::instance_id, "instance_id", GL_R32UI, "uint", 1,
                "index of the object + 1; 0 on the background"},
    ChannelInfo{Channel::motion_depth, "motion_depth", GL_RGBA32F, "vec4", 4,
                "motion in rgb and eye depth in a: both in one fetch, always in full precision"},
};

/// A set of channels.
class ChannelSet {
  public:
    constexpr ChannelSet() = default;
    constexpr ChannelSet(std::initializer_list<Channel> channels) {
        for (const Channel channel : channels) {
            add(channel);
        }
    }
    constexpr void add(Channel channel) { m_bits |= bit(channel); }
    [[nodiscard]] constexpr bool contains(Channel channel) const {
        return (m_bits & bit(channel)) != 0;
    }
    [[nodiscard]] constexpr bool contains(ChannelSet other) const {
        return (m_bits & other.m_bits) == other.m_bits;
    }
    friend constexpr ChannelSet operator|(ChannelSet a, ChannelSet b) {
        a.m_bits |= b.m_bits;
        return a;
    }
    friend constexpr auto operator<=>(const ChannelSet&, const ChannelSet&) = default;

  private:
    static constexpr std::uint32_t bit(Channel channel) {
        return 1u << static_cast<unsigned>(channel);
    }
    std::uint32_t m_bits = 0;
};

/// What every run rasterises; input cost is measured beyond it.
inline constexpr ChannelSet kBaseChannels{Channel::eye_depth, Channel::normal, Channel::albedo,
                                          Channel::direct_light};

/// The channels beyond the base as the name of an input-cost row: "motion", "motion+instance_id".
[[nodiscard]] std::string name_extra_channels(ChannelSet channels);

} // namespace alcove
