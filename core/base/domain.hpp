#pragma once
// Domains of images (DESIGN 3.10): what the values of a file mean, and on which of them a metric
// works.

#include "core/base/image.hpp"

#include <string_view>

namespace alcove {

/// srgb: display codes in [0,1], used as they are. linear: linear radiance. visibility: linear, one
/// channel. view: what eyes get, sRGB-encoded once from visibility or tone-mapped radiance.
enum class Domain { srgb, linear, visibility, view };

[[nodiscard]] std::string_view to_text(Domain domain);
/// Throws InputError with the nearest name.
[[nodiscard]] Domain parse_domain(std::string_view text);

/// The sRGB transfer function and its inverse (IEC 61966-2-1), each clamped to [0,1].
[[nodiscard]] float encode_srgb(float linear);
[[nodiscard]] float decode_srgb(float code);

/// What a metric runs on: numeric ones (mse, rmse, mae, psnr) on values, perceptual ones on views.
/// linear: light, whatever the file holds. codes: what is stored, as it is, for comparison with
/// papers that did so.
enum class MetricDomain { values, view, linear, codes };

[[nodiscard]] std::string_view to_text(MetricDomain domain);
/// Throws InputError naming `where`, with the nearest name.
[[nodiscard]] MetricDomain parse_metric_domain(std::string_view text, std::string_view where);

/// Turns an image of `domain` into what a metric of `wanted` runs on.
/// values: srgb codes as they are, linear as it is, visibility as it is; a view of visibility
/// stored as codes is decoded to linear visibility, so that EXR and PNG of one image give the same
/// numbers up to quantisation. view: srgb and view as they are; linear and visibility clamped to
/// [0,1] and sRGB-encoded. linear: srgb and view decoded, the others as they are. codes: as it is.
[[nodiscard]] Image convert_for_metric(const Image& image, Domain domain, MetricDomain wanted);

/// Rec. 709 luma (0.2126, 0.7152, 0.0722) of a three- or four-channel image; a copy of the first
/// channel otherwise.
[[nodiscard]] Image compute_luma(const Image& image);

/// sRGB encoding of every value.
[[nodiscard]] Image encode_view(const Image& linear);

} // namespace alcove
