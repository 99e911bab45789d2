#include "core/frame/channels.hpp"

namespace alcove {

std::string name_extra_channels(ChannelSet channels) {
    std::string text;
    for (const ChannelInfo& info : kChannels) {
        if (channels.contains(info.channel) && !kBaseChannels.contains(info.channel)) {
            text += text.empty() ? "" : "+";
            text += info.name;
        }
    }
    return text;
}

} // namespace alcove
