#include "methods/common/sequence.hpp"

namespace alcove {

double compute_radical_inverse(std::uint32_t index, std::uint32_t base) {
    double value = 0.0;
    double digit = 1.0;
    for (; index != 0; index /= base) {
        digit /= base;
        value += digit * (index % base);
    }
    return value;
}

} // namespace alcove
