#include "reports/analysis/wording.hpp"
#include "reports/papers/shanmugam_arikan/shanmugam_arikan_parts.hpp"

#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;

void judge_layers(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> enough;
    std::vector<Outcome> minor;
    std::string numbers;
    for (const std::size_t round : {kStatue, kFoliage}) {
        const auto change = [&](const char* more, const char* fewer) {
            return compare_native(evidence, "layers", more, fewer, "rmse", round);
        };
        const Estimate second = change("2 layers", "1 layer");
        const Estimate third = change("3 layers", "2 layers");
        const Estimate fourth = change("4 layers", "2 layers");
        const double most = 0.25 * std::abs(second.value);
        enough.push_back(combine({judge_below(second, 0.0), judge_within(third, -most, most)}));
        const double small =
            0.1 * estimate_native(evidence, "layers", "2 layers", "rmse", round).value;
        minor.push_back(judge_within(fourth, -small, small));
        numbers += fmt::format("{}; {}: second {}, third {}, third and fourth {}",
                               numbers.empty() ? "image-space part against rays of its reach" : "",
                               describe_round(evidence, "layers", round), describe_estimate(second),
                               describe_estimate(third), describe_estimate(fourth));
    }
    judge.set("SA07-028",
              {combine(enough),
               "the second layer lowers rmse, and the third changes it by less than a quarter of "
               "that, on a statue and between leaves",
               compare_native(evidence, "layers", "2 layers", "1 layer", "rmse"),
               numbers + ". What a deeper layer adds is summed as if nothing stood before it; "
                         "measured: second, statue"});
    judge.set("SA07-049",
              {combine(minor), "a third and a fourth layer change rmse by less than a tenth of it",
               compare_native(evidence, "layers", "4 layers", "2 layers", "rmse"),
               numbers + "; measured: third and fourth, statue"});
}

void judge_planes(const Evidence& evidence, Judge& judge) {
    std::vector<Outcome> outcomes;
    std::string without;
    for (std::size_t round = 0; round < 3; ++round) {
        outcomes.push_back(
            judge_below(estimate_native(evidence, "planes", "near", "mae", round), 0.01));
        without += (round == 0 ? "" : ", ") +
                   describe_estimate(
                       estimate_native(evidence, "planes", "near, not pushed back", "mae", round));
    }
    judge.set("SA07-030",
              {combine(outcomes), "mean occlusion of planes at 0, 30 and 55 degrees below 0.01",
               estimate_native(evidence, "planes", "near", "mae", 2),
               "five views each; measured: 55 degrees. Not pushed back: " + without});
}

void judge_reach(const Evidence& evidence, Judge& judge) {
    const Estimate more = compare_native(evidence, "r_far", "10 units", "5 units", "mae");
    const Estimate there = estimate_native(evidence, "r_far", "5 units", "mae");
    judge.set("SA07-031",
              {judge_below(more, 0.1 * there.value),
               "twice the reach adds less than a tenth of mean occlusion", more,
               fmt::format("{}; 5 units have {}. A sphere's share falls with the square of the "
                           "distance, but as many more spheres lie there",
                           describe_round(evidence, "r_far"), describe_estimate(there))});
}

void judge_closed_room(const Evidence& evidence, Judge& judge) {
    const char* const kBlack = "false_occlusion:least=0.99";
    const auto get = [&](const char* label, const char* metric) {
        return estimate_native(evidence, "closed_room", label, metric);
    };
    const Estimate ours = get("combined", kBlack);
    const Estimate printed = get("as printed", kBlack);
    judge.set(
        "SA07-040",
        {combine({judge_below(ours, 0.5), judge_below(printed, 0.5)}),
         "less than half of the pixels have a visibility below 0.01, as printed and by default",
         ours,
         fmt::format("{}; measured: by default. As printed {}; at epsilon 0.5 {}, at 0.005 {}; "
                     "multiplied {}; endless rays {}. Mean occlusion by default {}",
                     describe_round(evidence, "closed_room"), describe_estimate(printed),
                     describe_estimate(get("epsilon 0.5", kBlack)),
                     describe_estimate(get("epsilon 0.005", kBlack)),
                     describe_estimate(get("multiplicative", kBlack)),
                     describe_estimate(get("endless rays", kBlack)),
                     describe_estimate(get("combined", "mae")))});
}

void judge_deforming(const Evidence& evidence, Judge& judge) {
    const char* const kMoving = "rmse[moving]";
    const auto get = [&](const char* label, std::size_t round) {
        return estimate_native(evidence, "deforming", label, kMoving, round);
    };
    const Estimate start = get("silhouettes", 0);
    const Estimate change =
        evidence.compare_metric(find_native("deforming", "silhouettes", 1),
                                find_native("deforming", "silhouettes", 0), kMoving, kCold);
    // Spheres that stay where they are at first raise it by more than a tenth.
    const double most = 0.05 * start.value;
    judge.set(
        "SA07-024",
        {judge_within(change, -most, most),
         "rmse of the far part, where something moves, changes by less than a twentieth while "
         "figures walk for a second",
         change,
         fmt::format("crowd before a camera at rest, spheres of half the radius; at first {}. "
                     "By default {} and then {}",
                     describe_estimate(start), describe_estimate(get("far", 0)),
                     describe_estimate(get("far", 1)))});
}

void judge_independence(const Evidence& evidence, Judge& judge) {
    const auto is_same = [&](const char* label) {
        const std::size_t kSequence = 0;
        const std::size_t kAlone = 1;
        const int frame = evidence.get_round("independence", kAlone).segments.front().begin;
        return evidence.find_image_hash(find_native("independence", label, kSequence), frame) ==
                       evidence.find_image_hash(find_native("independence", label, kAlone), frame)
                   ? Outcome::holds
                   : Outcome::fails;
    };
    const std::string on = "a knight with a waving cloak, frame 39";
    judge.set("SA07-010", {combine({is_same("near"), is_same("combined"), is_same("as printed")}),
                           "a frame at the end of a sequence is, bit for bit, the frame alone",
                           std::nullopt, on});
    judge.set("SA07-034",
              {is_same("near"),
               "the image-space part's frame at the end of a sequence is, bit for "
               "bit, the frame alone",
               std::nullopt, on + "; it asks for no geometry but the G-buffer's layers"});
}

void judge_limits(const Evidence& evidence, Judge& judge) {
    const auto grows = [&](std::size_t far, std::size_t near, const char* label = "near") {
        return evidence.compare_metric(find_native("far_camera", label, far),
                                       find_native("far_camera", label, near), "rmse", kCold);
    };
    const auto too_dark = [&](std::size_t round) {
        return describe_estimate(
            estimate_native(evidence, "far_camera", "near", "false_occlusion:least=0.05", round));
    };
    judge.set("SA07-035",
              {combine({judge_above(grows(1, 0), 0.0), judge_above(grows(2, 1), 0.0)}),
               "rmse rises with each halving of the pixels that a reach has", grows(2, 0),
               fmt::format("{} and half and a quarter of that, which is how a camera twice and "
                           "four times as far away sees it; measured: quarter - whole. First "
                           "halving {}, second {}; with 1024 neighbours, no fixed number, {} and "
                           "{}. Pixels that are too dark at the whole {}, at a quarter {}: near "
                           "creases more and smaller spheres are summed the finer the image is. "
                           "Faces parallel to the view are not tested",
                           describe_round(evidence, "far_camera"), describe_estimate(grows(1, 0)),
                           describe_estimate(grows(2, 1)),
                           describe_estimate(grows(1, 0, "near, every pixel")),
                           describe_estimate(grows(2, 1, "near, every pixel")), too_dark(0),
                           too_dark(2))});
    const Estimate facets =
        evidence.compare_metric(find_native("low_poly", "near", 0),
                                find_native("low_poly", "near", 1), "gradient_error", kCold);
    judge.set("SA07-036",
              {judge_above(facets, 0.0),
               "gradient_error on coarse triangles - on fine ones of the same bones > 0", facets,
               describe_round(evidence, "low_poly") + ", against rays on the same triangles"});
}

} // namespace

void judge_shanmugam_arikan_quality(const Evidence& evidence, Judge& judge) {
    judge_layers(evidence, judge);
    judge_planes(evidence, judge);
    judge_reach(evidence, judge);
    judge_closed_room(evidence, judge);
    judge_deforming(evidence, judge);
    judge_independence(evidence, judge);
    judge_limits(evidence, judge);
}

} // namespace alcove
