#include "tests/harness/metric_verb.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace alcove {

Image make_visibility(double phase) {
    Image image(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            image.at(x, y) = static_cast<float>(0.55 + 0.45 * std::sin(0.2 * x + 0.1 * y + phase));
        }
    }
    return image;
}

std::string MetricVerb::write_exr_file(const std::string& name, const Image& image) {
    write_exr(folder() / name, image, Domain::visibility);
    return (folder() / name).string();
}

std::string MetricVerb::write_png_file(const std::string& name, const Image& visibility) {
    write_png(folder() / name, encode_view(visibility), Domain::view);
    return (folder() / name).string();
}

json MetricVerb::evaluate(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "metric");
    arguments.emplace_back("--json");
    const ChildResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out);
}

} // namespace alcove
