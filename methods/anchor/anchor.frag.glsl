// 32 fetches of eye depth at fixed offsets in pixels (a spiral of radius 16), nothing else. It includes nothing and has no
// parameter: a test pins this text, and a change raises kAnchorVersion.
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(location = 0) out float visibility;

const ivec2 kOffsets[32] = ivec2[](
    ivec2(2, 0), ivec2(-3, 2), ivec2(0, -4), ivec2(3, 4), ivec2(-6, -1), ivec2(6, -4), ivec2(-2, 7), ivec2(-4, -7),
    ivec2(8, 3), ivec2(-8, 3), ivec2(4, -8), ivec2(3, 9), ivec2(-9, -5), ivec2(10, -2), ivec2(-6, 9), ivec2(-1, -11),
    ivec2(9, 7), ivec2(-12, 0), ivec2(9, -9), ivec2(-1, 12), ivec2(-8, -10), ivec2(13, 2), ivec2(-11, 8), ivec2(3, -13),
    ivec2(7, 12), ivec2(-14, -4), ivec2(13, -6), ivec2(-6, 14), ivec2(-5, -14), ivec2(14, 7), ivec2(-15, 4), ivec2(9, -13));

void main() {
    vec2 pixel_size = 1.0 / vec2(textureSize(eye_depth_texture, 0));
    float nearest = 0.98 * textureLod(eye_depth_texture, gl_FragCoord.xy * pixel_size, 0.0).r;
    float open = 0.0;
    for (int i = 0; i < 32; ++i) {
        vec2 uv = (gl_FragCoord.xy + vec2(kOffsets[i])) * pixel_size;
        open += textureLod(eye_depth_texture, uv, 0.0).r >= nearest ? 1.0 : 0.0;
    }
    visibility = isinf(nearest) ? 1.0 : open * (1.0 / 32.0);
}
