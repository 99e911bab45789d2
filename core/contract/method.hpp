#pragma once
// The contract of a method: from the G-buffer channels it declared, and its own history, to a
// visibility image, a radiance image, or both. Visibility: 1 = open, 0 = blocked, linear, R32F,
// background exactly 1. A method never includes another method; what two share lives in
// methods/common.

#include "core/base/history_state.hpp"
#include "core/base/parameters.hpp"
#include "core/base/registry.hpp"
#include "core/base/target.hpp"
#include "core/frame/effects.hpp"
#include "core/frame/frame_view.hpp"
#include "core/frame/gbuffer.hpp"
#include "core/frame/gbuffer_part.hpp"
#include "core/frame/passes.hpp"
#include "core/frame/posed_geometry.hpp"
#include "core/frame/raster.hpp"
#include "core/frame/surroundings.hpp"
#include "core/gl/context.hpp"
#include "core/gl/program.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// What a method declares that it reads. May depend on its parameters; channels beyond the base are
/// charged to it.
struct MethodRequests {
    ChannelSet channels{Channel::eye_depth, Channel::normal};
    bool posed_geometry = false;
    /// Added to the G-buffer on each side, as a fraction of width and height, in [0, 0.5]. Layers
    /// and back faces have it as well; extra views and samples do not.
    double border = 0.0;
    /// Depth layers in all, 1 to kMostLayers.
    int layers = 1;
    bool back_faces = false;
    std::vector<ExtraView> views{}; ///< at most kMostViews
    /// Of layers, back faces and views, all of which hold eye depth.
    ChannelSet part_channels{Channel::eye_depth, Channel::normal};
    /// Samples a pixel that the picture is composed with, 1, 2, 4 or 8: the base channels.
    int samples = 1;
    /// With more than one sample: each takes the method's value of that of the 3x3 pixels around
    /// whose depth is nearest to its own, not of its own pixel.
    bool samples_take_nearest = false;

    friend bool operator==(const MethodRequests&, const MethodRequests&) = default;
};

/// The parts that a method declares beside its ordinary G-buffer, layers first and in order.
/// Asserts the ranges above.
[[nodiscard]] std::vector<GBufferPart> list_parts(const MethodRequests& requests);
[[nodiscard]] ChannelSet get_part_channels(const MethodRequests& requests, const GBufferPart& part);

/// What it gets, for one frame. Textures hold exactly the declared channels, or more.
struct MethodInputs {
    const FrameView& view;  ///< of the G-buffer: extended by the border that was asked for
    const GBuffer& gbuffer; ///< view.size, border included
    std::vector<const GBuffer*> layers{}; ///< the second and deeper ones that were requested
    const GBuffer* back_faces = nullptr;  ///< only if requested
    struct View {
        FrameView view;
        const GBuffer* gbuffer = nullptr;
    };
    std::vector<View> views{};               ///< as requested
    const GBuffer* multisampled = nullptr;   ///< only if more than one sample was requested
    const PosedGeometry* geometry = nullptr; ///< only if requested
    const Lights* lights = nullptr;
    SurroundingsView surroundings{}; ///< the light of `lights` from all around, on the GPU
    Raster* raster = nullptr;        ///< draws the frame's scene from elsewhere, in passes of yours
    std::uint32_t noise_seed =
        0; ///< belongs to the harness: equal seeds and frames give equal images
    /// Asks a method that gives radiance for its visibility beside it; never while times are taken.
    bool wants_visibility = false;
    /// Asks for MethodOutput::history_state. Never set while times are taken, and must not change
    /// the images.
    bool wants_history_state = false;
};

/// What it leaves. Textures stay the method's and hold until the next call. Not both images null.
struct MethodOutput {
    const gl::Texture* visibility = nullptr; ///< R32F, the size of resize()
    const gl::Texture* radiance = nullptr;   ///< RGBA16F, linear Rec. 709, the same size
    /// True: `radiance` is all light, and the G-buffer's direct light is not added to it.
    bool replaces_direct_light = false;
    /// RGBA32F with the channels of HistoryChannel, border included; may be smaller than the view
    /// where the method works at a lower resolution. Only if it was asked for and the method has a
    /// history.
    const gl::Texture* history_state = nullptr;
};

class Method {
  public:
    Method() = default;
    virtual ~Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;

    /// Which effects the frames to come call for. Called at most once, before get_requests and
    /// resize; without a call it is all of them. A method leaves out what it can: with frames that
    /// meet an effect's rule (kEffects) its images must stay within 1/255.
    virtual void set_effects(EffectSet /*effects*/) {}
    [[nodiscard]] virtual MethodRequests get_requests() const { return {}; }
    /// Allocates for images of this size (without border). Called before the first frame and
    /// whenever the size changes; implies reset_history.
    virtual void resize(ImageSize size) = 0;
    /// Forgets all earlier frames. Called at each segment's start.
    virtual void reset_history() {}
    /// Renders one frame; every GPU step lies in a scope of `passes`. GL state is as
    /// Context::reset_state leaves it.
    [[nodiscard]] virtual MethodOutput render(const MethodInputs& inputs, PassRecorder& passes) = 0;
};

/// A named row over a method's parameters.
struct Preset {
    std::string name;
    std::string meaning; ///< with its source where it is published
    std::vector<ParameterOverride> overrides;
    /// Largest |mean - plane response| of the contract's tilted planes at 0..60 degrees and at 75,
    /// in units of 1/255, with the reason where it is not that of the default preset.
    double plane_tolerance = 1.0;
    double plane_tolerance_75 = 2.0;
    std::string plane_reason;
};

/// How a target becomes parameters: overrides, or the reason why the method cannot do it. What it
/// can do in part (a falloff it lacks, with the radius mapped all the same) is said in `reason`
/// beside the overrides.
struct TargetMapping {
    std::vector<ParameterOverride> overrides;
    std::string reason; ///< empty if the whole target is mapped
};

/// What a method's cost is told by beside its pixels.
struct SampleCount {
    std::string pass;       ///< the one that takes them, "hemisphere_ssao/occlusion"
    double per_pixel = 0.0; ///< of the full-resolution image
};

struct MethodUnit {
    std::string name;
    std::string title;
    std::string citation;     ///< author. title. year.
    std::string folder;       ///< filled by the registry
    std::string content_hash; ///< filled by the registry
    bool reported = true;     ///< false for templates: compiled and tested, never reported
    bool has_passes = true;   ///< false: time 0 by definition, no ratio row
    bool is_reference =
        false; ///< never part of a default suite: it is what others are held against
    ParameterTable parameters;
    std::vector<Preset> presets; ///< the first is "default"
    /// Visibility of an infinite plane: 1 for hemisphere estimators; nothing where the definition
    /// gives none.
    std::optional<double> plane_response;
    /// Overrides that give the method's own limit of many samples; nothing if it has none.
    std::optional<std::string> converged_preset;
    std::function<TargetMapping(const Target&)> map_target;
    /// Frames of a held camera until the image no longer changes; 0 for a method without history.
    /// Known without a device, because the plan says it.
    std::function<int(const ResolvedParameters&)> warm_frames = [](const ResolvedParameters&) {
        return 0;
    };
    /// Nothing where there are no samples or their number is not known beforehand.
    std::function<std::optional<SampleCount>(const ResolvedParameters&)> count_samples =
        [](const ResolvedParameters&) { return std::nullopt; };
    std::function<std::unique_ptr<Method>(gl::Context&, const ResolvedParameters&)> create;

    /// Throws InputError with the nearest name.
    [[nodiscard]] const Preset& find_preset(std::string_view preset) const;
};

} // namespace alcove
