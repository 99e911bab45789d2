// NAME[@DOMAIN][:key=value,...]
#include "harness/run/metric_spec.hpp"

#include "core/base/error.hpp"
#include "metrics/registry.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace alcove {
namespace {

class MetricSpecTest : public testing::Test {
  protected:
    ResolvedMetric resolve(const std::string& text) const {
        return resolve_metric(m_metrics, parse_metric_spec(text, "--metric"));
    }
    const Registry<MetricUnit> m_metrics = metrics_registry();
};

TEST_F(MetricSpecTest, ANameAloneIsTheUnitAsItIs) {
    const ResolvedMetric metric = resolve("flip");
    EXPECT_EQ(metric.unit->name, "flip");
    EXPECT_EQ(metric.domain, MetricDomain::view);
    EXPECT_NEAR(std::get<double>(metric.parameters.get("ppd")), 67.020643, 1e-6);
}

TEST_F(MetricSpecTest, DomainAndParametersAreTaken) {
    const MetricSpec spec = parse_metric_spec("flip@codes:ppd=30", "--metric");
    EXPECT_EQ(spec.text, "flip@codes:ppd=30");
    const ResolvedMetric metric = resolve_metric(m_metrics, spec);
    EXPECT_EQ(metric.domain, MetricDomain::codes);
    EXPECT_EQ(std::get<double>(metric.parameters.get("ppd")), 30.0);
    EXPECT_EQ(std::get<std::string>(resolve("ms_ssim:low_pass=mean").parameters.get("low_pass")),
              "mean");
    EXPECT_EQ(resolve("rmse@view").domain, MetricDomain::view);
}

TEST_F(MetricSpecTest, WhatIsNotDeclaredIsAnErrorThatNamesTheNearest) {
    const auto expect = [&](const std::string& text, const std::string& part) {
        try {
            static_cast<void>(resolve(text));
            ADD_FAILURE() << text << " was taken";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    expect("flop", "nearest: flip");
    expect("flip@code", "nearest: codes");
    expect("flip:pdp=30", "nearest: ppd");
    expect("flip:ppd=1000", "500");
    expect("flip:ppd", "=");
    expect("flip:ppd=30,ppd=40", "twice");
    expect("flip@", "domain");
    expect("", "");
    expect("temporal_flicker@view", "over time");
    EXPECT_THROW(check_metric_specs(m_metrics, {"rmse", "rmse"}, "--metric"), InputError);
    EXPECT_NO_THROW(check_metric_specs(m_metrics, {"rmse", "rmse@view"}, "--metric"));
}

TEST_F(MetricSpecTest, RunsMeasureByDefaultWhatIsNotOnDemand) {
    for (const bool has_pictures : {false, true}) {
        const std::vector<std::string> names = list_default_metrics(m_metrics, has_pictures);
        const auto has = [&](const char* name) {
            return std::find(names.begin(), names.end(), name) != names.end();
        };
        EXPECT_TRUE(has("rmse") && has("ssim") && has("flip") && has("temporal_flicker"));
        EXPECT_FALSE(has("hdr_flip") || has("ms_ssim") || has("template_metric"));
        EXPECT_EQ(has("chroma_error"), has_pictures);
        EXPECT_EQ(has("energy_ratio"), has_pictures);
    }
}

} // namespace
} // namespace alcove
