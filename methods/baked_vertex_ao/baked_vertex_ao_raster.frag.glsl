// The visibility between the vertices, where the G-buffer shows a surface: at its silhouettes the two rasterisations may
// differ by a pixel.
#include "parameters.glsl"
layout(binding = 0) uniform sampler2D eye_depth_texture;
in float vertex_visibility;
layout(location = 0) out float visibility;

void main() {
    bool is_background = isinf(texelFetch(eye_depth_texture, ivec2(gl_FragCoord.xy), 0).r);
    float open = clamp(1.0 - param_strength * (1.0 - vertex_visibility), 0.0, 1.0);
    visibility = is_background ? 1.0 : open;
}
