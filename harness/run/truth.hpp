#pragma once
// What a round's images are measured against: a traced reference with its two halves, or any other
// method's image. Under a target of visibility that is visibility; under one of radiance the
// picture behind tone_map, and of halves the mean of both behind it: what the curve makes of noise
// is then in the mean as in the halves, so that cross products of them stay free of bias.

#include "harness/run/reference_store.hpp"
#include "harness/run/round_stage.hpp"

#include <memory>
#include <optional>

namespace alcove {

struct Truth {
    Image mean;
    std::optional<ReferencePair> halves; ///< nothing for a method that has no noise of its own
    bool was_cached = false;
    [[nodiscard]] const Image* a() const { return halves ? &halves->a : nullptr; }
    [[nodiscard]] const Image* b() const { return halves ? &halves->b : nullptr; }
};

class TruthSource {
  public:
    virtual ~TruthSource() = default;
    TruthSource(const TruthSource&) = delete;
    TruthSource& operator=(const TruthSource&) = delete;
    /// Truth for one frame, which needs not be the stage's; the stage is left at it.
    [[nodiscard]] virtual Truth get(const FrameView& view) = 0;
    /// Cached truths that were made again, and agreed.
    [[nodiscard]] virtual std::size_t audited() const { return 0; }

  protected:
    TruthSource() = default;
};

/// The source that the round's record names.
[[nodiscard]] std::unique_ptr<TruthSource> make_truth_source(RoundStage& stage);

} // namespace alcove
