#include "harness/run/round_pictures.hpp"

#include "core/base/domain.hpp"
#include "core/base/image_file.hpp"
#include "harness/run/error_map.hpp"
#include "harness/run/heatmap.hpp"
#include "harness/run/wall_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace alcove {
namespace {

/// Full scale of maps whose metric has no largest value.
constexpr float kMapRange = 0.1f;
/// Full scale of samples a pixel and frame.
constexpr float kSamplesRange = 64.0f;
constexpr std::array<std::string_view, 3> kFilmMaps{"temporal_flicker", "missed_invalidation",
                                                    "false_invalidation"};

/// Per pixel the value that 95 % of the frames do not exceed (nearest rank).
Image compute_p95(const std::vector<Image>& images) {
    Image p95(images.front().size(), 1);
    std::vector<float> values(images.size());
    const auto rank =
        static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(images.size())) - 1.0);
    for (std::size_t pixel = 0; pixel < p95.values().size(); ++pixel) {
        std::transform(images.begin(), images.end(), values.begin(),
                       [pixel](const Image& image) { return image.values()[pixel]; });
        std::nth_element(values.begin(), values.begin() + rank, values.end());
        p95.values()[pixel] = values[static_cast<std::size_t>(rank)];
    }
    return p95;
}

} // namespace

bool RoundPictures::is_filmed(std::string_view metric) {
    return std::find(kFilmMaps.begin(), kFilmMaps.end(), metric) != kFilmMaps.end();
}

void RoundPictures::write_film_map(const std::string& cell, int frame, const std::string& metric,
                                   const Image& map, double largest) {
    const float range = std::isfinite(largest) ? static_cast<float>(largest) : kMapRange;
    write(cell, frame, "film_" + metric, make_scale_map(map, range));
}

void RoundPictures::write_film_reference(int frame, const Truth& truth) {
    write("reference", frame, std::string("film_") + name_measured(), encode_view(truth.mean));
}

void RoundPictures::write_film_frame(const std::string& cell, int frame, const Image& measured,
                                     const Truth& truth, const Image* state,
                                     const HistoryRecord& history) {
    write(cell, frame, std::string("film_") + name_measured(), encode_view(measured));
    write(cell, frame, "film_error", make_error_map(measured, truth.mean));
    if (state == nullptr) {
        return;
    }
    const auto take = [state](HistoryChannel channel) {
        return take_channel(*state, static_cast<int>(channel));
    };
    write(cell, frame, "film_age", make_age_map(history.age(), *state));
    write(cell, frame, "film_cause", make_cause_map(*state));
    write(cell, frame, "film_convergence", make_scale_map(take(HistoryChannel::convergence), 1.0f));
    write(cell, frame, "film_samples",
          make_scale_map(take(HistoryChannel::samples), kSamplesRange));
}

void RoundPictures::write_accumulated(const std::string& cell, int frame,
                                      const std::vector<Image>& flicker,
                                      const HistoryRecord* history) {
    if (!flicker.empty()) {
        write(cell, frame, "accumulated_flicker_p95",
              make_scale_map(compute_p95(flicker), kMapRange));
    }
    if (history != nullptr) {
        const SegmentRecord& film = m_stage.round().film;
        write(cell, frame, "accumulated_invalidations",
              make_scale_map(history->compute_invalidated_share(), 1.0f));
        write(cell, frame, "accumulated_samples",
              make_scale_map(history->samples(),
                             kSamplesRange * static_cast<float>(film.end - film.begin)));
    }
}

void RoundPictures::write_profile(const std::string& cell, int frame, const ProfileStrip& strip) {
    write(cell, frame, "accumulated_profile", encode_view(strip.make_image()));
}

void RoundPictures::write_reference(int frame, const Truth& truth) {
    write("reference", frame, name_measured(), encode_view(truth.mean));
    if (m_stage.measures_pictures()) {
        return;
    }
    gl::Texture texture(m_stage.gl(), GL_R32F, m_stage.size());
    gl::write_texture(m_stage.gl(), texture, truth.mean);
    m_stage.compose(nullptr, {.visibility = &texture}, PassTiming::none);
    write_shaded("reference", frame);
}

void RoundPictures::write_cell(const MethodCell& cell, int frame, const Image& measured,
                               const MethodOutput& output, const Truth& truth) {
    write(cell.record().id, frame, name_measured(), encode_view(measured));
    write(cell.record().id, frame, "error", make_error_map(measured, truth.mean));
    if (!m_stage.measures_pictures()) {
        m_stage.compose(&cell, output, PassTiming::none);
        write_shaded(cell.record().id, frame);
    }
}

void RoundPictures::write_shaded(const std::string& cell, int frame) {
    write(cell, frame, "shaded",
          encode_view(tone_map(gl::read_texture(m_stage.gl(), m_stage.picture(), 3))));
}

bool RoundPictures::is_kept(int frame) const {
    const std::vector<int>& kept = m_stage.round().image_frames;
    return std::find(kept.begin(), kept.end(), frame) != kept.end();
}

void RoundPictures::write_step(const std::string& cell, int frame, const std::string& picture,
                               const Image& from, const Image& to) {
    write(cell, frame, picture, make_error_map(from, to, kStepRange));
}

void RoundPictures::write(const std::string& cell, int frame, const std::string& picture,
                          const Image& codes) {
    const WallTime wall(m_done.images_s);
    write_png(m_run_folder / RunFolder::make_image_path(m_stage.round().id, cell, frame, picture),
              codes, Domain::view);
}

} // namespace alcove
