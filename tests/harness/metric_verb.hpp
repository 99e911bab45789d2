#pragma once
// `alcove metric` over small images of the test's own.

#include "core/base/image_file.hpp"
#include "tests/harness/program.hpp"

#include <nlohmann/json_fwd.hpp>

namespace alcove {

using nlohmann::json;

inline constexpr ImageSize kSize{48, 40};

/// A smooth visibility image in [0.1, 1].
[[nodiscard]] Image make_visibility(double phase);

class MetricVerb : public ProgramTest {
  protected:
    static std::string write_exr_file(const std::string& name, const Image& image);
    /// Its view in 8 bits.
    static std::string write_png_file(const std::string& name, const Image& visibility);
    /// The object of `metric ARGUMENTS --json`, which must exit 0.
    static json evaluate(std::vector<std::string> arguments);
};

} // namespace alcove
