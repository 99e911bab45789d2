#pragma once
// The pictures that a round leaves in its run folder: chosen frames, the film of a burst, and what
// was accumulated over it. Names and scales: reports/README.md.

#include "harness/run/history_record.hpp"
#include "harness/run/profile_strip.hpp"
#include "harness/run/truth.hpp"

#include <filesystem>
#include <string_view>

namespace alcove {

class RoundPictures {
  public:
    /// Pictures go below `run_folder`, the time they take to `done`; all must outlive it.
    RoundPictures(RoundStage& stage, RoundDone& done, std::filesystem::path run_folder)
        : m_stage(stage), m_done(done), m_run_folder(std::move(run_folder)) {}

    // A round of visibility keeps that and the shaded pictures that it makes; a round of radiance
    // keeps the tone-mapped pictures that it measures. `measured`: RoundStage::read_measured.

    /// Truth, and of visibility its shaded picture; uses the stage's G-buffer of the frame.
    void write_reference(int frame, const Truth& truth);
    /// A method's image, its error map, and of visibility its shaded picture.
    void write_cell(const MethodCell& cell, int frame, const Image& measured,
                    const MethodOutput& output, const Truth& truth);

    /// Is the map of this metric over time part of the film?
    [[nodiscard]] static bool is_filmed(std::string_view metric);
    /// Its map; `largest` is the metric's largest value, infinite or not.
    void write_film_map(const std::string& cell, int frame, const std::string& metric,
                        const Image& map, double largest);
    void write_film_reference(int frame, const Truth& truth);
    /// A method's image and error map, and the history's maps where there is a state.
    void write_film_frame(const std::string& cell, int frame, const Image& measured,
                          const Truth& truth, const Image* state, const HistoryRecord& history);
    /// On the film's last frame: 95th percentile of `flicker` (|D| a frame), and the history's sums
    /// if the method has one.
    void write_accumulated(const std::string& cell, int frame, const std::vector<Image>& flicker,
                           const HistoryRecord* history);

    /// On the film's last frame: the temporal profile of a cell or of "reference".
    void write_profile(const std::string& cell, int frame, const ProfileStrip& strip);

    /// Are pictures of this frame kept?
    [[nodiscard]] bool is_kept(int frame) const;
    /// from - to of two visibilities, as an error map whose full colour is at kStepRange: steps are
    /// smaller than whole errors.
    static constexpr float kStepRange = 0.25f;
    void write_step(const std::string& cell, int frame, const std::string& picture,
                    const Image& from, const Image& to);

  private:
    /// How the pictures of what is measured are named.
    [[nodiscard]] const char* name_measured() const {
        return m_stage.measures_pictures() ? "picture" : "visibility";
    }
    /// Of an output whose picture composes, as eyes see it.
    void write_shaded(const std::string& cell, int frame);
    void write(const std::string& cell, int frame, const std::string& picture, const Image& codes);

    RoundStage& m_stage;
    RoundDone& m_done;
    std::filesystem::path m_run_folder;
};

} // namespace alcove
