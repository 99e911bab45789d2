#pragma once
// Why a round's images are wrong, on its single frames: errors in steps over the converged form and
// a brute-force march (DESIGN 3.7), and what the best monotone curve would mend. Asked for by
// `--explain-errors`, since a march takes seconds a frame.

#include "core/base/monotone_curve.hpp"
#include "harness/run/error_steps.hpp"
#include "harness/run/round_pictures.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace alcove {

/// Finite thicknesses of which the best is chosen, in radii: a factor of 2 apart.
inline constexpr std::array kThicknesses{0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0};

class ErrorExplainer {
  public:
    /// Behind the capture of a round of visibility. Results go to `done`, pictures below
    /// `run_folder`; all must outlive it.
    ErrorExplainer(RoundStage& stage, RoundDone& done, std::filesystem::path run_folder);

    /// Nothing where the round has no single frames or no method.
    void run();

  private:
    /// One single frame with what all cells are held against.
    struct Frame {
        RoundFrame frame;
        Truth truth;
        double truth_noise = 0.0;
        Image infinite;
        Image best;
        double infinite_noise = 0.0;
        double best_noise = 0.0;
    };

    void take_truth();
    void choose_thickness();
    void march_frames();
    void explain_cell(MethodCell& cell);
    void explain_frame(const MethodCell& cell, std::size_t index, const Image& image,
                       const Image* converged);
    void fit_curves(const MethodCell& cell, const std::vector<Image>& images);
    [[nodiscard]] CellRecord make_march(double thickness, int rays) const;
    /// A fresh start, converged if the cell has a history; one image a single frame.
    [[nodiscard]] std::vector<Image> take_images(MethodCell& cell, std::uint32_t seed);
    /// Of a method that is not one of the stage's.
    [[nodiscard]] std::vector<Image> take_images(const CellRecord& record, std::uint32_t seed);

    RoundStage& m_stage;
    RoundDone& m_done;
    RoundPictures m_pictures;
    std::vector<Frame> m_frames;
    double m_best_thickness = 1.0;
};

} // namespace alcove
