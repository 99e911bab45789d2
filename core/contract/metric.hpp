#pragma once
// The contract of a metric: a pure function of images (and motion): a number, its direction, its
// domain, and a map where that makes sense. No OpenGL, no files. Metrics over time:
// temporal_metric.hpp.

#include "core/base/domain.hpp"
#include "core/base/image.hpp"
#include "core/base/parameters.hpp"
#include "core/base/registry.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

enum class Direction { lower_is_better, higher_is_better };

/// What is compared. Both images have equal sizes and channels and are already in the metric's
/// domain (convert_for_metric, and compute_luma for metrics that say `luma`).
struct MetricInput {
    const Image& test;
    const Image& reference; ///< the mean of the halves where there are halves
    /// Two independent randomisations of the reference; both or none.
    const Image* reference_a = nullptr;
    const Image* reference_b = nullptr;
    /// One channel, the size of the images: 1 = counted, 0 = ignored, nothing else. A metric pools
    /// over counted pixels only; one with windows over the windows whose centre is counted, and
    /// still looks at ignored pixels inside of them.
    const Image* mask = nullptr;
    /// Eye depth in metres, one channel, the size of the images, inf on the background; only
    /// metrics that are measured at depth edges look at it, and have no value without it.
    const Image* depth = nullptr;
};

/// A further number that a metric gives beside its value.
struct NamedValue {
    std::string name;
    double value = 0.0;
};

struct MetricResult {
    std::optional<double> value;  ///< nothing where it is infinite or undefined
    std::string undefined_reason; ///< says why there is no value
    /// The value with the reference's noise taken out by cross products of the halves; only with
    /// halves.
    std::optional<double> debiased;
    /// What the reference's own noise alone would give; a value below it means nothing. Only with
    /// halves.
    std::optional<double> floor;
    std::optional<Image> map;       ///< one channel, the size that `map_offset` says
    int map_offset = 0;             ///< pixels cut off at each border of the map (valid region)
    std::vector<NamedValue> extras; ///< in the order of the definition; none without a value
    /// Of the pixels that are pooled where there is no mask, how many it counts and how many it
    /// ignores; only with a mask. One that counts none leaves no value, with a reason.
    std::optional<std::size_t> counted_pixels;
    std::optional<std::size_t> ignored_pixels;
};

class Metric {
  public:
    Metric() = default;
    virtual ~Metric() = default;
    Metric(const Metric&) = delete;
    Metric& operator=(const Metric&) = delete;
    /// Throws InputError if sizes or channels differ, a value is NaN or infinite (masked or not), a
    /// mask holds anything but 0 and 1, or the image is too small for it.
    [[nodiscard]] virtual MetricResult evaluate(const MetricInput& input) const = 0;
};

/// A published or hand-computable pair that pins the definition; run by the contract tests and
/// `metric --self-test`.
struct MetricCheck {
    std::string name;
    std::function<Image()> make_test; ///< already in the metric's domain
    std::function<Image()> make_reference;
    double expected = 0.0;
    double tolerance = 0.0; ///< absolute
    std::string source;     ///< who published it, or the hand calculation
    /// The unit's defaults where empty.
    std::vector<ParameterOverride> parameters = {};
    /// MetricInput::depth, for units that need it.
    std::function<Image()> make_depth = {};
};

/// Images on which a metric has a value, for the contract tests of one that has none on noise.
struct MetricCanary {
    std::function<Image(ImageSize)> make_reference;
    /// The reference with the error that the metric is made for, of that amount.
    std::function<Image(const Image& reference, float amount)> damage;
    std::function<Image(ImageSize)> make_depth = {};
};

class TemporalMetric;

/// The same for a metric over time: a planted sequence whose value is known.
struct TemporalCheck {
    std::string name;
    /// Resets the metric, feeds the sequence and gives the value of its last frame.
    std::function<double(TemporalMetric&)> run;
    double expected = 0.0;
    double tolerance = 0.0; ///< absolute
    std::string source;
};

/// Exactly one of `create` and `create_temporal` is set, and the checks that belong to it.
struct MetricUnit {
    std::string name;
    std::string title;
    std::string unit;       ///< of the value; "1" for a plain number
    std::string definition; ///< one paragraph: formula, constants, region, citation
    std::string blind_to;   ///< what it cannot see
    Direction direction = Direction::lower_is_better;
    MetricDomain domain = MetricDomain::values;
    bool luma = false;     ///< colour images are reduced to Rec. 709 luma first
    int smallest_side = 1; ///< pixels; smaller images are an error
    double minimum = 0.0;
    double maximum = 0.0;       ///< may be inf
    std::optional<double> best; ///< value of (x, x); nothing where that is undefined (psnr)
    std::string folder;         ///< filled by the registry
    std::string content_hash;   ///< filled by the registry
    bool reported = true;       ///< false for the template
    bool on_demand = false;     ///< a run measures it only where it is named
    /// Of an on-demand metric: a run that has a target of radiance measures it unasked.
    bool is_of_pictures = false;
    ParameterTable parameters;
    /// Has a value only of images of three channels.
    bool needs_colour = false;
    /// Has a value only where MetricInput::depth is given.
    bool needs_depth = false;
    /// Looks at the test alone, so that truth may have any value.
    bool ignores_reference = false;
    /// Nothing for metrics that any two images have a value of.
    std::optional<MetricCanary> canary;
    std::vector<MetricCheck> checks;
    std::function<std::unique_ptr<Metric>(const ResolvedParameters&)> create;
    std::vector<TemporalCheck> temporal_checks;
    std::function<std::unique_ptr<TemporalMetric>(const ResolvedParameters&)> create_temporal;
    [[nodiscard]] bool is_temporal() const { return static_cast<bool>(create_temporal); }
};

/// What every metric checks first. Throws InputError: sizes, channels, NaN (with its pixel and
/// which image), smallest side, mask, depth.
void check_metric_input(const MetricInput& input, std::string_view metric, int smallest_side = 1);

/// Evaluates a check's pair with a metric of the check's parameters.
[[nodiscard]] MetricResult evaluate_check(const Metric& metric, const MetricCheck& check);

/// An image of `from` as the unit's metrics take it, on `wanted`: converted, reduced to luma.
[[nodiscard]] Image convert_for_unit(const MetricUnit& unit, const Image& image, Domain from,
                                     MetricDomain wanted);

/// The result of a metric on images whose smaller side is under the unit's: no value and the
/// reason; nothing where they are large enough.
[[nodiscard]] std::optional<MetricResult> refuse_small_image(const MetricUnit& unit,
                                                             ImageSize size);

/// Runs a metric on images of a domain: converts to `wanted`, reduces to luma, evaluates. Images
/// that are too small give a result without value.
[[nodiscard]] MetricResult evaluate_in_domain(const MetricUnit& unit, const Metric& metric,
                                              const MetricInput& input, Domain domain,
                                              MetricDomain wanted);

} // namespace alcove
