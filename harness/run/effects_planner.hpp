#pragma once
// Which effects a walkthrough calls for, by exact rules: what is left out cannot change an image.

#include "core/contract/scene.hpp"
#include "core/frame/effects.hpp"
#include "reports/record/record.hpp"

#include <vector>

namespace alcove {

/// One decision an effect, with what it was seen from. Looks at every replayed frame and the one
/// before it, where its history is valid. `measures_pictures`: the round's target is radiance.
[[nodiscard]] std::vector<EffectRecord> plan_effects(const Scene& scene,
                                                     const std::vector<SegmentRecord>& segments,
                                                     bool measures_pictures);

/// The effects that the decisions keep.
[[nodiscard]] EffectSet choose_effects(const std::vector<EffectRecord>& decisions);

} // namespace alcove
