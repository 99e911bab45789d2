// Eye depth from raster depth, with all its quantisation (precision axis eye_depth=raster). 1/eye depth is linear in the
// stored depth; this form keeps what a division by the projection's terms would cancel (4 steps of 24 bits at 5 m).
layout(binding = 0) uniform sampler2D raster_depth;
uniform vec2 inverse_ends;       // 1/eye depth where the stored depth is 0 and where it is 1
uniform float background_depth;  // the cleared value
layout(location = 0) out float eye_depth;

void main() {
    float depth = texelFetch(raster_depth, ivec2(gl_FragCoord.xy), 0).r;
    float inverse_depth = (1.0 - depth) * inverse_ends.x + depth * inverse_ends.y;
    eye_depth = depth == background_depth ? uintBitsToFloat(0x7F800000u) : 1.0 / inverse_depth;
}
