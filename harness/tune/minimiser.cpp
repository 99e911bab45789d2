#include "harness/tune/minimiser.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <nlopt.h>

namespace alcove {
namespace {

/// Steps of the search below this share of a range end it.
constexpr double kSmallestStep = 1e-3;

/// What the library's callback knows.
class Recorder {
  public:
    Recorder(Minimum& minimum, const std::function<double(const std::vector<double>&)>& cost)
        : m_minimum(minimum), m_cost(cost) {}

    double evaluate(const std::vector<double>& point, bool is_grid) {
        const double value = m_cost(point);
        ALCOVE_ASSERT(std::isfinite(value), "a finite cost");
        m_minimum.history.push_back({point, value, is_grid});
        if (value < m_minimum.history[m_minimum.best].cost) {
            m_minimum.best = m_minimum.history.size() - 1;
        }
        return value;
    }

    /// Exceptions must not pass through the library, which is C.
    static double call(unsigned count, const double* point, double*, void* self) {
        auto& recorder = *static_cast<Recorder*>(self);
        try {
            return recorder.evaluate({point, point + count}, false);
        } catch (...) {
            recorder.m_error = std::current_exception();
            nlopt_force_stop(recorder.m_search);
            return 0.0;
        }
    }

    void search(unsigned dimensions, int evaluations, double first_step) {
        using Search = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)>;
        const Search search(nlopt_create(NLOPT_LN_SBPLX, dimensions), nlopt_destroy);
        if (!search) {
            throw FailureError("tune", "NLopt could not be set up");
        }
        m_search = search.get();
        nlopt_set_min_objective(search.get(), &Recorder::call, this);
        nlopt_set_lower_bounds1(search.get(), 0.0);
        nlopt_set_upper_bounds1(search.get(), 1.0);
        nlopt_set_initial_step1(search.get(), first_step);
        nlopt_set_maxeval(search.get(), evaluations);
        nlopt_set_xtol_abs1(search.get(), kSmallestStep);
        std::vector<double> point = m_minimum.history[m_minimum.best].point;
        double cost = 0.0;
        const nlopt_result result = nlopt_optimize(search.get(), point.data(), &cost);
        if (m_error) {
            std::rethrow_exception(m_error);
        }
        // Rounding that stops progress is an end like any other.
        if (result < 0 && result != NLOPT_ROUNDOFF_LIMITED) {
            throw FailureError("tune", "NLopt failed with code " + std::to_string(result));
        }
    }

  private:
    Minimum& m_minimum;
    const std::function<double(const std::vector<double>&)>& m_cost;
    nlopt_opt m_search = nullptr;
    std::exception_ptr m_error;
};

double power(int base, std::size_t exponent) {
    return std::pow(static_cast<double>(base), static_cast<double>(exponent));
}

/// The point of the grid with this number, moved by `shift` cells along each axis.
std::vector<double> make_grid_point(std::size_t number, std::size_t dimensions, int points,
                                    const std::vector<double>& shift) {
    std::vector<double> point;
    for (std::size_t i = 0; i < dimensions; ++i) {
        const auto cell = static_cast<double>(number % static_cast<std::size_t>(points));
        number /= static_cast<std::size_t>(points);
        point.push_back(std::clamp((cell + 0.5 + shift[i]) / points, 0.0, 1.0));
    }
    return point;
}

} // namespace

int count_grid_points(std::size_t dimensions, int evaluations) {
    int points = 1;
    while (2.0 * power(points + 1, dimensions) <= evaluations) {
        ++points;
    }
    return points == 1 && power(2, dimensions) <= evaluations ? 2 : points;
}

Minimum minimise(std::size_t dimensions, const MinimiserSettings& settings,
                 const std::function<double(const std::vector<double>&)>& cost) {
    ALCOVE_ASSERT(dimensions > 0 && settings.evaluations >= 2, "something to search");
    Minimum minimum;
    Recorder recorder(minimum, cost);
    const int points = count_grid_points(dimensions, settings.evaluations);
    std::mt19937_64 random(settings.seed);
    std::vector<double> shift;
    for (std::size_t i = 0; i < dimensions; ++i) {
        // The upper 53 bits as a number in [-0.5, 0.5): the standard's distributions differ between
        // libraries.
        shift.push_back(static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    }
    const auto count = static_cast<std::size_t>(power(points, dimensions));
    for (std::size_t number = 0; number < count; ++number) {
        recorder.evaluate(make_grid_point(number, dimensions, points, shift), true);
    }
    const int left = settings.evaluations - static_cast<int>(count);
    if (left > 0) {
        recorder.search(static_cast<unsigned>(dimensions), left, 0.5 / points);
    }
    return minimum;
}

} // namespace alcove
