#pragma once
// Random numbers that are the same with every library, unlike the standard's distributions. This
// work is based on: G. Steele, D. Lea, C. Flood. Fast Splittable Pseudorandom Number Generators.
// 2014.

#include <cstdint>

namespace alcove {

class SplitMix {
  public:
    explicit SplitMix(std::uint64_t state) : m_state(state) {}

    /// In [0,1), a multiple of 2^-53.
    [[nodiscard]] double draw_unit() {
        m_state += 0x9e3779b97f4a7c15ull;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        z ^= z >> 31;
        return static_cast<double>(z >> 11) * 0x1.0p-53;
    }
    /// In [low, high).
    [[nodiscard]] double draw(double low, double high) { return low + (high - low) * draw_unit(); }
    /// 0 .. count - 1. `count` > 0, far below 2^53.
    [[nodiscard]] int draw_index(int count) { return static_cast<int>(draw_unit() * count); }

  private:
    std::uint64_t m_state;
};

} // namespace alcove
