#include "core/gl/known_load.glsl"
in vec2 screen_uv;
uniform int iterations;
layout(location = 0) out float result;

void main() {
    result = run_known_load(iterations, screen_uv.x + 0.37 * screen_uv.y);
}
