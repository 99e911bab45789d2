#include "core/gl/device_class.hpp"

#include <array>
#include <cctype>
#include <regex>
#include <string>

namespace alcove::gl {
namespace {

struct Rule {
    DeviceClass device_class;
    const char* pattern; ///< for " vendor words | renderer words "
};

// The first rule that matches decides, so exceptions stand before the family they belong to.
constexpr std::array kRules{
    Rule{DeviceClass::software, " (llvmpipe|softpipe|swrast|swiftshader|lavapipe) "},
    Rule{DeviceClass::software, " microsoft basic render | software (renderer|rasterizer) "},
    Rule{DeviceClass::translated, " (d3d12|zink|angle|virgl|svga3d) "},
    // Mesa's own driver for the same chips (Asahi) has another vendor and no Metal below it.
    Rule{DeviceClass::translated, "^ apple (inc )?\\|"},
    Rule{DeviceClass::integrated, " apple m[0-9]"},
    Rule{DeviceClass::integrated, " (tegra|integrated|mali|adreno) | mali [gt]"},
    Rule{DeviceClass::datacentre, " tesla | instinct | data center gpu "},
    Rule{DeviceClass::datacentre,
         " nvidia .* (a(2|10|10g|16|30|40|100|800)|b[123]00|gb[123]00|gh200|h(20|100|200|800)|"
         "l(2|4|20|40|40s)|p(4|40|100)|t4|v100) "},
    Rule{DeviceClass::discrete, " (geforce|quadro|rtx|titan) | nvidia .* t[0-9]{3,4} "},
    Rule{DeviceClass::discrete, " intel .* (dg[12]|bmg|max) "},
    Rule{DeviceClass::discrete, " arc (pro )?[ab][0-9]+m? "},
    Rule{DeviceClass::integrated, " arc "},
    Rule{DeviceClass::integrated, " intel .* (graphics|uhd|hd|iris) "},
    Rule{DeviceClass::integrated, " vega (3|6|8|9|10|11) "},
    Rule{DeviceClass::integrated,
         " radeon (graphics|[0-9]{3}m|80[0-9]{2}s|r[2-7] graphics) | amd custom gpu "},
    Rule{DeviceClass::discrete, " radeon (rx|pro|vii|hd|r[579]|vega) "},
};

/// Lower case, words parted by single spaces, one at either end.
std::string split_words(std::string_view text) {
    std::string words = " ";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto letter = static_cast<unsigned char>(text[i]);
        if (std::isalnum(letter) != 0) {
            words += static_cast<char>(std::tolower(letter));
        } else if (words.back() != ' ') {
            words += ' ';
        }
    }
    if (words.back() != ' ') {
        words += ' ';
    }
    static const std::regex trademark(" (tm|r)(?= )");
    return std::regex_replace(words, trademark, "");
}

} // namespace

std::string_view to_text(DeviceClass device_class) {
    switch (device_class) {
    case DeviceClass::software:
        return "software";
    case DeviceClass::integrated:
        return "integrated";
    case DeviceClass::discrete:
        return "discrete";
    case DeviceClass::datacentre:
        return "datacentre";
    case DeviceClass::translated:
        return "translated";
    case DeviceClass::unclassified:
        break;
    }
    return "unclassified";
}

DeviceClass classify_device(std::string_view vendor, std::string_view renderer) {
    const std::string words = split_words(vendor) + "|" + split_words(renderer);
    for (const Rule& rule : kRules) {
        if (std::regex_search(words, std::regex(rule.pattern))) {
            return rule.device_class;
        }
    }
    return DeviceClass::unclassified;
}

} // namespace alcove::gl
