#pragma once
// Effects that passes simulate and that a scene may or may not call for (DESIGN 3.12). What is left
// out costs nothing: no pass, no G-buffer channel.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace alcove {

/// Those that a plan can leave out today.
enum class Effect { object_motion, reprojection, light_buffers };

struct EffectInfo {
    Effect effect;
    std::string_view name;
    std::string_view meaning;
    std::string_view rule; ///< when it can be left out without changing an image
};

inline constexpr std::array kEffects{
    EffectInfo{Effect::object_motion, "object_motion",
               "the motion channel, and tests of what moves in a pixel's neighbourhood",
               "no object moves in the frames that are replayed"},
    EffectInfo{Effect::reprojection, "reprojection",
               "looking a history up where the surface was, instead of at its own pixel",
               "no object moves and the camera stands still"},
    EffectInfo{Effect::light_buffers, "light_buffers",
               "albedo and direct light in the G-buffers of methods", "no bounce is asked for"},
};

class EffectSet {
  public:
    constexpr EffectSet() = default;
    [[nodiscard]] static constexpr EffectSet all() {
        EffectSet set;
        for (const EffectInfo& info : kEffects) {
            set.m_bits |= bit(info.effect);
        }
        return set;
    }
    constexpr void remove(Effect effect) { m_bits &= ~bit(effect); }
    [[nodiscard]] constexpr bool contains(Effect effect) const {
        return (m_bits & bit(effect)) != 0;
    }
    friend constexpr bool operator==(const EffectSet&, const EffectSet&) = default;

  private:
    static constexpr std::uint32_t bit(Effect effect) {
        return 1u << static_cast<unsigned>(effect);
    }
    std::uint32_t m_bits = 0;
};

/// "all", or "without object_motion,light_buffers". parse_effects reads it back.
[[nodiscard]] std::string describe(EffectSet effects);
/// Throws InputError with the nearest name.
[[nodiscard]] EffectSet parse_effects(std::string_view text);

} // namespace alcove
