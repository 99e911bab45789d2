// Writes the channels that the frame's methods declared (core/frame/channels.hpp).
#include "channel_outputs.glsl"
#include "vertex_streams.glsl"
in vec3 view_normal;
in float eye_depth;
in vec3 motion;
in vec3 surface_albedo;
flat in uint surface_id;
#ifdef HAS_TEXTURE
in vec2 texture_coordinates;
layout(binding = 0) uniform sampler2D albedo_texture; // sRGB: decoded before it is filtered
#endif

#ifdef HAS_PLACED_LIGHT
in vec3 surface_position; // view space
in vec4 tangent_plane;    // between those of the triangle's vertices

// Where a facet that stands for a smooth surface is lit: lifted along the side's normal by what the tangent planes of its
// vertices lie above it, each weighed as its vertex. On the facet itself solids of few facets shadow their own lit side.
// This work is based on: Hanika. Hacking the shadow terminator. Ray Tracing Gems II. 2021.
vec3 lift_off_facet(vec3 normal) {
    float above = tangent_plane.w - dot(tangent_plane.xyz, surface_position);
    float side = dot(normal, tangent_plane.xyz) < 0.0 ? -1.0 : 1.0;
    return surface_position + max(side * above, 0.0) * normal;
}
#endif
#ifdef WRITE_direct_light
#include "core/frame/lights.glsl"
#endif

#ifdef PEELED
layout(binding = 1) uniform sampler2D nearer_depth_texture;
#endif

const float kInversePi = 0.31830989;

void main() {
#ifdef PEELED
    // A surface of the layer before has the very depth that is stored: it was interpolated alike.
    if (eye_depth <= texelFetch(nearer_depth_texture, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
#endif
    vec3 n = normalize(gl_FrontFacing ? view_normal : -view_normal);
    vec3 albedo = surface_albedo;
#ifdef HAS_TEXTURE
    albedo *= texture(albedo_texture, texture_coordinates).rgb;
#endif
#ifdef WRITE_eye_depth
    out_eye_depth = eye_depth;
#endif
#ifdef WRITE_normal
    out_normal = vec4(n, gl_FrontFacing ? 0.0 : 1.0);
#endif
#ifdef WRITE_albedo
    out_albedo = vec4(albedo, 1.0);
#endif
#ifdef WRITE_direct_light
#ifdef PEELED
    // Behind the first layer it is the outside that is lit and may send light on.
    vec3 lit = normalize(view_normal);
#else
    vec3 lit = n;
#endif
#ifdef HAS_PLACED_LIGHT
    vec3 facet = normalize(cross(dFdx(surface_position), dFdy(surface_position)));
    vec3 irradiance = compute_irradiance(lift_off_facet(lit), lit, facet);
#else
    vec3 irradiance = compute_irradiance(vec3(0.0), lit, lit);
#endif
    out_direct_light = vec4(irradiance * albedo * kInversePi, 1.0);
#endif
#ifdef WRITE_motion
    out_motion = vec4(motion, 0.0);
#endif
#ifdef WRITE_motion_depth
    out_motion_depth = vec4(motion, eye_depth);
#endif
#ifdef WRITE_instance_id
    out_instance_id = surface_id;
#endif
}
