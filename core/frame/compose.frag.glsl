// The shaded picture from a method's image.
layout(binding = 0) uniform sampler2D eye_depth_texture;
layout(binding = 1) uniform sampler2D albedo_texture;
layout(binding = 2) uniform sampler2D direct_light_texture;
layout(binding = 3) uniform sampler2D method_texture; // visibility in r, or radiance in rgb
uniform bool is_radiance;
uniform vec3 ambient;
layout(location = 0) out vec4 picture;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool is_background = isinf(texelFetch(eye_depth_texture, pixel, 0).r);
    vec3 direct = texelFetch(direct_light_texture, pixel, 0).rgb;
    vec3 albedo = texelFetch(albedo_texture, pixel, 0).rgb;
    vec3 method_value = texelFetch(method_texture, pixel, 0).rgb;
    vec3 indirect = is_radiance ? method_value : ambient * albedo * method_value.r;
    picture = vec4(is_background ? ambient : direct + indirect, 1.0);
}
