// A damaged G-buffer: NaN for one frame, normals of length zero for good.
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "scenes/hard_cases/yard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace alcove {
namespace {

/// Half the widest blur and filter that a method may declare, and the reach of half-size
/// upsampling.
constexpr int kBlurReach = 8 + 2;
constexpr int kDamagedFrame = 4;
constexpr int kFrames = 7;

struct Patch {
    int left = 0;
    int top = 0;
    int side = 0;
};

/// In the image's centre, which shows the boxes.
Patch make_patch(ImageSize size, double side) {
    const int pixels = std::min({static_cast<int>(side), size.width, size.height});
    return {(size.width - pixels) / 2, (size.height - pixels) / 2, pixels};
}

const ChannelInfo& find_info(Channel channel) {
    for (const ChannelInfo& info : kChannels) {
        if (info.channel == channel) {
            return info;
        }
    }
    ALCOVE_ASSERT(false, "every channel is in the table");
    return kChannels.front();
}

GBufferEdit make_fill(const gl::Functions& gl, Channel channel, const Patch& patch, float value) {
    return [&gl, channel, patch, value](const GBuffer& gbuffer, const Border& border) {
        const int channels = find_info(channel).components;
        Image image = gl::read_texture(gl, gbuffer.texture(channel), channels);
        for (int y = 0; y < patch.side; ++y) {
            for (int x = 0; x < patch.side; ++x) {
                for (int c = 0; c < channels; ++c) {
                    image.at(patch.left + border.x + x, patch.top + border.y + y, c) = value;
                }
            }
        }
        gl::write_texture(gl, gbuffer.texture(channel), image);
    };
}

/// 1 where a kernel or a blur may reach the patch.
Image make_footprint(const Image& depth, const Camera& camera, double radius_m,
                     const Patch& patch) {
    Image footprint(depth.size(), 1);
    const double pixels_at_1_m =
        radius_m * depth.height() / (2.0 * std::tan(0.5 * camera.fov_y_radians));
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const int dx = std::max({patch.left - x, x - (patch.left + patch.side - 1), 0});
            const int dy = std::max({patch.top - y, y - (patch.top + patch.side - 1), 0});
            // A sphere off the view axis is seen larger than its radius over its depth: by less
            // than 2 at 60 degrees.
            const double reach =
                2.0 * pixels_at_1_m / static_cast<double>(depth.at(x, y)) + kBlurReach;
            footprint.at(x, y) = std::hypot(dx, dy) <= reach ? 1.0f : 0.0f;
        }
    }
    return footprint;
}

struct DamageRig {
    DamageRig(const StabilitySubject& subject, ImageSize size, double severity)
        : scene(make_yard_case({})), rig(subject.context(), *scene, size),
          patch(make_patch(size, severity)), first(rig.get_view(0, true)),
          depth(rig.read_depth(first)),
          footprint(make_footprint(depth, first.camera, scene->get_ao_radius_m(), patch)) {}

    /// A still camera; `edit` on the frames in [begin, end).
    std::vector<Image> replay(const StabilitySubject& subject, const GBufferEdit& edit, int begin,
                              int end) {
        const std::unique_ptr<Method> method = subject.create(scene->get_ao_radius_m(), rig.size());
        const FrameView held = hold(first);
        std::vector<Image> images;
        for (int frame = 0; frame < kFrames; ++frame) {
            ShotOptions options;
            if (frame >= begin && frame < end) {
                options.edit = edit;
            }
            images.push_back(rig.shoot(*method, frame == 0 ? first : held, options).visibility);
        }
        return images;
    }

    /// Pixels outside the footprint that are not what they are without the damage.
    [[nodiscard]] double count_spread(const Image& damaged, const Image& clean,
                                      double tolerance) const {
        double count = 0.0;
        for (std::size_t i = 0; i < clean.values().size(); ++i) {
            const double difference =
                std::abs(static_cast<double>(damaged.values()[i]) - clean.values()[i]);
            const bool is_same = difference <= tolerance; // false for NaN
            count += footprint.values()[i] == 0.0f && !is_same ? 1.0 : 0.0;
        }
        return count;
    }

    std::unique_ptr<Scene> scene;
    SceneRig rig;
    Patch patch;
    FrameView first;
    Image depth;
    Image footprint;
};

std::string find_obstacle(const StabilitySubject& subject) {
    return subject.get_requests().posed_geometry ? "it traces geometry and reads no G-buffer" : "";
}

StabilityScore measure_nan(const StabilitySubject& subject, ImageSize size, double severity) {
    DamageRig damage(subject, size, severity);
    const std::vector<Image> clean = damage.replay(subject, {}, 0, 0);
    const ChannelSet channels =
        ChannelSet{Channel::eye_depth, Channel::normal} | subject.get_requests().channels;
    const gl::Functions& gl = subject.context().functions();
    WorstScore worst;
    Image picture = clean.back();
    for (const Channel channel :
         {Channel::eye_depth, Channel::normal, Channel::motion, Channel::motion_depth}) {
        if (!channels.contains(channel)) {
            continue;
        }
        const GBufferEdit edit =
            make_fill(gl, channel, damage.patch, std::numeric_limits<float>::quiet_NaN());
        const std::vector<Image> images =
            damage.replay(subject, edit, kDamagedFrame, kDamagedFrame + 1);
        for (std::size_t frame = 0; frame < images.size(); ++frame) {
            if (frame != kDamagedFrame) {
                worst.check(images[frame], damage.depth);
            }
            worst.add(damage.count_spread(images[frame], clean[frame], kOneCode), 0.0);
        }
        picture = images[kDamagedFrame];
    }
    return worst.finish(std::move(picture));
}

StabilityScore measure_zero_normals(const StabilitySubject& subject, ImageSize size,
                                    double severity) {
    DamageRig damage(subject, size, severity);
    const std::vector<Image> clean = damage.replay(subject, {}, 0, 0);
    const GBufferEdit edit =
        make_fill(subject.context().functions(), Channel::normal, damage.patch, 0.0f);
    const std::vector<Image> images = damage.replay(subject, edit, 0, kFrames);
    WorstScore worst;
    for (std::size_t frame = 0; frame < images.size(); ++frame) {
        worst.check(images[frame], damage.depth);
        worst.add(damage.count_spread(images[frame], clean[frame], kOneCode), 0.0);
    }
    return worst.finish(images.back());
}

} // namespace

std::vector<StabilityCase> make_damage_cases() {
    StabilityCase nan;
    nan.about = {
        "nan_input",
        "NaN in the G-buffer",
        "a square of NaN in one channel after the other that the method reads, on one frame of a "
        "still camera",
        "reported: NaN from degenerate normals (bevyengine/bevy#8925), one NaN that a blur "
        "enlarges (JoeyDeVries/Cell#17); a history that keeps a NaN (Mattausch et al. 2010, "
        "derived: reject a history that is not finite)",
        "side of the square",
        "px",
        label_severities({1.0, 3.0, 8.0, 16.0}, "px"),
        "on that frame nothing changes beyond the reach of kernel and blur; the next frame is "
        "finite everywhere and unchanged beyond that reach",
        "pixels beyond the reach that differ by more than a code, on the worst frame",
        "pixels",
        "none: no sample of such a pixel falls into the square. The reach is twice the projected "
        "radius (perspective stretches a sphere off the axis by less) and 10 pixels, the widest "
        "blur of 8 and 2 of upsampling",
    };
    nan.find_obstacle = find_obstacle;
    nan.measure = measure_nan;
    StabilityCase zero;
    zero.about = {
        "normals_zero",
        "Normals of length zero",
        "a square of normals (0, 0, 0) in the G-buffer on every frame, as broken assets and failed "
        "decoding leave them",
        "reported: black squares and NaN from degenerate normals (bevyengine/bevy#8925, "
        "google/filament#6216)",
        "side of the square",
        "px",
        label_severities({1.0, 4.0, 16.0, 48.0}, "px"),
        "the image is finite and in [0,1] everywhere, and unchanged beyond the reach of kernel and "
        "blur",
        "pixels beyond the reach that differ by more than a code, on the worst frame",
        "pixels",
        "none: no kernel of such a pixel meets the square, for the same reach as with NaN",
    };
    zero.find_obstacle = find_obstacle;
    zero.measure = measure_zero_normals;
    return {std::move(nan), std::move(zero)};
}

} // namespace alcove
