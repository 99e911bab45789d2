#include "core/contract/method.hpp"

namespace alcove {

const Preset& MethodUnit::find_preset(std::string_view preset) const {
    std::vector<std::string> names;
    for (const Preset& candidate : presets) {
        if (candidate.name == preset) {
            return candidate;
        }
        names.push_back(candidate.name);
    }
    throw InputError(name, "unknown preset", preset, describe_choices(preset, names));
}

std::vector<GBufferPart> list_parts(const MethodRequests& requests) {
    ALCOVE_ASSERT(requests.layers >= 1 && requests.layers <= kMostLayers, "1 to 4 layers");
    ALCOVE_ASSERT(requests.views.size() <= kMostViews, "at most 4 extra views");
    ALCOVE_ASSERT(requests.samples == 1 || requests.samples == 2 || requests.samples == 4 ||
                      requests.samples == kMostSamples,
                  "1, 2, 4 or 8 samples");
    std::vector<GBufferPart> parts;
    for (int k = 2; k <= requests.layers; ++k) {
        parts.push_back({PartKind::layer, k, {}});
    }
    if (requests.back_faces) {
        parts.push_back({PartKind::back_faces, 0, {}});
    }
    for (std::size_t i = 0; i < requests.views.size(); ++i) {
        parts.push_back({PartKind::view, static_cast<int>(i) + 1, requests.views[i]});
    }
    if (requests.samples > 1) {
        parts.push_back({PartKind::multisampled, requests.samples, {}});
    }
    return parts;
}

ChannelSet get_part_channels(const MethodRequests& requests, const GBufferPart& part) {
    return part.kind == PartKind::multisampled
               ? kBaseChannels
               : requests.part_channels | ChannelSet{Channel::eye_depth};
}

} // namespace alcove
