// A real pixel for each 2x2: the nearest on one colour of a checkerboard, the farthest on the other, so that beside a
// depth edge both sides are represented and no depth is made up. At odd sizes the last 2x2 holds fewer pixels.
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(location = 0) out vec2 selection; // eye depth; place in the 2x2, x + 2 y

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(eye_depth_texture, 0) - 1;
    bool wants_nearest = ((texel.x + texel.y) & 1) == 0;
    selection = vec2(texelFetch(eye_depth_texture, 2 * texel, 0).r, 0.0);
    for (int place = 1; place < 4; ++place) {
        ivec2 pixel = 2 * texel + ivec2(place & 1, place >> 1);
        float depth = texelFetch(eye_depth_texture, min(pixel, last), 0).r;
        bool is_inside = all(lessThanEqual(pixel, last));
        if (is_inside && (wants_nearest ? depth < selection.r : depth > selection.r)) {
            selection = vec2(depth, float(place));
        }
    }
}
