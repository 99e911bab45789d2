// A mirrored or turned image of the same depths and normals gives the mirrored or turned result.
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "scenes/hard_cases/yard.hpp"

#include <algorithm>
#include <functional>

namespace alcove {
namespace {

constexpr int kSeeds = 16;

/// An operation on images whose inverse is `undo`.
struct Symmetry {
    /// Where pixel (x, y) of the result comes from.
    std::function<glm::ivec2(glm::ivec2 pixel, ImageSize size)> find_source;
    std::function<glm::ivec2(glm::ivec2 pixel, ImageSize size)> find_source_back;
    /// View-space x (right) and y (up) of a normal.
    std::function<glm::vec2(glm::vec2 normal)> turn_normal;
};

Image rearrange(const Image& image,
                const std::function<glm::ivec2(glm::ivec2, ImageSize)>& find_source) {
    Image result(image.size(), image.channels());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const glm::ivec2 source = find_source({x, y}, image.size());
            for (int c = 0; c < image.channels(); ++c) {
                result.at(x, y, c) = image.at(source.x, source.y, c);
            }
        }
    }
    return result;
}

/// Everything stands still, so that motion is 0 and needs no turning.
GBufferEdit make_edit(const gl::Functions& gl, const Symmetry& symmetry) {
    return [&gl, &symmetry](const GBuffer& gbuffer, const Border&) {
        for (const ChannelInfo& info : kChannels) {
            if (!gbuffer.channels().contains(info.channel)) {
                continue;
            }
            const gl::Texture& texture = gbuffer.texture(info.channel);
            Image image =
                rearrange(gl::read_texture(gl, texture, info.components), symmetry.find_source);
            if (info.channel == Channel::normal) {
                for (int y = 0; y < image.height(); ++y) {
                    for (int x = 0; x < image.width(); ++x) {
                        const glm::vec2 turned =
                            symmetry.turn_normal({image.at(x, y, 0), image.at(x, y, 1)});
                        image.at(x, y, 0) = turned.x;
                        image.at(x, y, 1) = turned.y;
                    }
                }
            }
            gl::write_texture(gl, texture, image);
        }
    };
}

StabilityScore measure(const StabilitySubject& subject, ImageSize size, double fov_degrees,
                       const std::vector<Symmetry>& symmetries) {
    constexpr ImageSize kBlocks{8, 6};
    YardSettings settings;
    settings.fov_y_degrees = fov_degrees;
    const std::unique_ptr<Scene> scene = make_yard_case(settings);
    SceneRig rig(subject.context(), *scene, size);
    const std::unique_ptr<Method> method = subject.create(scene->get_ao_radius_m(), size);
    const auto average = [&](const GBufferEdit& edit) {
        MeanImage mean;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            ShotOptions options;
            options.seed = seed;
            options.edit = edit;
            mean.add(rig.settle(*method, 0, 1, options).visibility);
        }
        return mean.compute();
    };
    const Image depth = rig.read_depth(rig.get_view(0));
    const Image plain = average({});
    WorstScore worst;
    worst.check(plain, depth);
    for (const Symmetry& symmetry : symmetries) {
        const Image changed = average(make_edit(subject.context().functions(), symmetry));
        const Image back = rearrange(changed, symmetry.find_source_back);
        worst.check(back, depth);
        worst.add(compute_worst_block_codes(back, plain, make_surface_mask(depth), kBlocks), 2.0);
    }
    return worst.finish(plain);
}

/// With odd sizes every second pixel is mirrored onto every second pixel, so that a method at half
/// size sees the same surface points.
ImageSize make_odd(ImageSize size) {
    return {size.width | 1, size.height | 1};
}

std::string find_obstacle(const StabilitySubject& subject) {
    const MethodRequests requests = subject.get_requests();
    if (requests.posed_geometry) {
        return "it traces geometry and reads no G-buffer";
    }
    return requests.channels.contains(Channel::instance_id)
               ? "it reads instance ids, which the case cannot mirror"
               : "";
}

Symmetry make_mirror(bool is_horizontal) {
    const auto source = [is_horizontal](glm::ivec2 pixel, ImageSize size) {
        return is_horizontal ? glm::ivec2(size.width - 1 - pixel.x, pixel.y)
                             : glm::ivec2(pixel.x, size.height - 1 - pixel.y);
    };
    return {source, source, [is_horizontal](glm::vec2 n) {
                return is_horizontal ? glm::vec2(-n.x, n.y) : glm::vec2(n.x, -n.y);
            }};
}

/// By 90 degrees against the clock: what is on the right comes to the top.
Symmetry make_turn() {
    return {[](glm::ivec2 pixel, ImageSize size) {
                return glm::ivec2(size.width - 1 - pixel.y, pixel.x);
            },
            [](glm::ivec2 pixel, ImageSize size) {
                return glm::ivec2(pixel.y, size.width - 1 - pixel.x);
            },
            [](glm::vec2 n) { return glm::vec2(-n.y, n.x); }};
}

StabilityCase make_case(const char* name, const char* title, const char* what, const char* source) {
    StabilityCase made;
    made.about = {
        name,
        title,
        "the G-buffer of one frame is " + std::string(what) +
            "; the angle of view grows, and with it what an axis that is not normalised gets wrong",
        source,
        "vertical field of view",
        "deg",
        label_severities({30.0, 60.0, 90.0, 120.0}, "deg"),
        "the image is " + std::string(what) + " and nothing else, on average over seeds",
        "largest |mean difference| over 8 x 6 blocks, 16 seeds each",
        "codes",
        "2 codes. What 16 seeds leave of the noise of 16 samples a pixel in a block of 144 pixels "
        "is about 0.3 codes (a standard deviation of 0.1 for a pixel, on both sides), so that the "
        "worst of 48 blocks stays below 1; sampling one side only costs tens",
    };
    made.find_obstacle = find_obstacle;
    return made;
}

} // namespace

std::vector<StabilityCase> make_symmetry_cases() {
    StabilityCase mirror = make_case(
        "mirror", "Mirror images", "mirrored",
        "reported: one side sampled for 26 months (DiligentGraphics/DiligentFX, commit 4c1d1e80)");
    mirror.measure = [](const StabilitySubject& subject, ImageSize size, double severity) {
        return measure(subject, make_odd(size), severity, {make_mirror(true), make_mirror(false)});
    };
    StabilityCase turn = make_case(
        "quarter_turn", "Turned by 90 degrees", "turned by 90 degrees",
        "reported: x and y exchanged in an upsampler for 27 months (DiligentGraphics/DiligentFX, "
        "commit 69693157)");
    turn.measure = [](const StabilitySubject& subject, ImageSize size, double severity) {
        const int side = std::max(size.width, size.height);
        return measure(subject, make_odd({side, side}), severity, {make_turn()});
    };
    return {std::move(mirror), std::move(turn)};
}

} // namespace alcove
