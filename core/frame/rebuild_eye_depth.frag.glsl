// Eye depth from raster depth, with all its quantisation (precision axis eye_depth=raster).
layout(binding = 0) uniform sampler2D raster_depth;
uniform vec2 depth_range;        // scale and offset from stored depth to clip z / w
uniform vec2 projection_z;       // P22, P32
uniform float background_depth;  // the cleared value
layout(location = 0) out float eye_depth;

void main() {
    float depth = texelFetch(raster_depth, ivec2(gl_FragCoord.xy), 0).r;
    float ndc = depth_range.x * depth + depth_range.y;
    eye_depth = depth == background_depth ? uintBitsToFloat(0x7F800000u)
                                          : projection_z.y / (ndc + projection_z.x);
}
