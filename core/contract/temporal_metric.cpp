#include "core/contract/temporal_metric.hpp"

#include "core/base/error.hpp"

namespace alcove {

void check_temporal_frame(const TemporalFrame& frame, std::string_view metric) {
    const auto check = [&](const Image* image, int channels, const char* which) {
        if (image != nullptr &&
            (image->size() != frame.test.size() || image->channels() != channels)) {
            throw InputError(
                metric,
                std::string(which) + " differs from the test image in size, "
                                     "or has a wrong number of channels",
                std::to_string(image->width()) + "x" + std::to_string(image->height()) + "x" +
                    std::to_string(image->channels()),
                std::to_string(frame.test.width()) + "x" + std::to_string(frame.test.height()) +
                    "x" + std::to_string(channels));
        }
    };
    check(&frame.test, 1, "the test image");
    check(&frame.reference, 1, "the reference");
    check(frame.reference_a, 1, "half A of the reference");
    check(frame.reference_b, 1, "half B of the reference");
    check(&frame.surface, 1, "the surface mask");
    check(&frame.moves, 1, "the mask of what moves");
    check(frame.history_state, 4, "the history state");
    ALCOVE_ASSERT((frame.reference_a == nullptr) == (frame.reference_b == nullptr),
                  "both halves of a reference or none");
    for (const EarlierFrame& earlier : frame.earlier) {
        check(&earlier.reference, 1, "an earlier reference");
        check(earlier.reference_a ? &*earlier.reference_a : nullptr, 1, "half A of an earlier one");
        check(earlier.reference_b ? &*earlier.reference_b : nullptr, 1, "half B of an earlier one");
        check(&earlier.correspondence.position, 2, "an earlier frame's positions");
        check(&earlier.correspondence.valid, 1, "an earlier frame's validity");
        check(&earlier.correspondence.appeared, 1, "an earlier frame's appeared points");
    }
    PixelPosition position;
    if (find_non_finite(frame.test, position)) {
        throw InputError(metric,
                         "test image holds NaN or infinity at pixel (" +
                             std::to_string(position.x) + ", " + std::to_string(position.y) + ")",
                         "", "finite values");
    }
}

} // namespace alcove
