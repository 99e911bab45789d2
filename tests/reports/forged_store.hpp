#pragma once
// Nights without a renderer: points of made-up series, for the store, the gate and the dashboard.

#include "reports/record/store.hpp"

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace alcove::forged {

inline constexpr const char* kDevice = "software: llvmpipe, A made-up processor, 2 threads";

/// Night `index` from 0: a day each from 2026-01-01.
[[nodiscard]] StoredRun make_run(int index);

[[nodiscard]] SeriesName make_name(const std::string& method, const std::string& state,
                                   const std::string& pass, const std::string& metric);

/// With a 95 % interval of `half_width` where that is positive.
[[nodiscard]] NightPoint make_point(SeriesKind kind, SeriesName name, double value,
                                    double half_width = 0.0);
[[nodiscard]] NightPoint make_images(const std::string& method, const std::string& hash);

/// Times of `value` with lognormal noise of `sigma`.
class Noise {
  public:
    explicit Noise(std::uint64_t seed) : m_engine(seed) {}
    [[nodiscard]] double draw(double value, double sigma);

  private:
    std::mt19937_64 m_engine;
};

/// What a method leaves in a night: envelope, two passes, milliseconds, two metrics, images.
struct Scenario {
    int nights = 30;
    int methods = 4; ///< of 7 series each, and one of an input cost
    double sigma = 0.01;
    int slower_from = -1;     ///< night from which pass 1 of method 0 takes 5 % more; -1: never
    int image_from = -1;      ///< night from which method 1 has other images
    int new_driver_from = -1; ///< night from which another driver draws
    std::string text = "";    ///< appended to what people read: markup, line ends
    std::uint64_t seed = 1;
};

inline constexpr int kSeriesOfMethod = 8;

/// Runs SQL on a store's file behind the store's back. Throws std::runtime_error.
void execute_sql(const std::filesystem::path& path, const std::string& sql);

/// One measurement of night `index`.
[[nodiscard]] std::vector<NightPoint> make_night(const Scenario& scenario, int index, Noise& noise);

/// Appends the nights as `alcove nightly` would: judged, suspects measured again, stored.
void append_nights(Store& store, const Scenario& scenario);

} // namespace alcove::forged
