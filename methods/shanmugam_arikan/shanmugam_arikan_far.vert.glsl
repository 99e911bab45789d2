// A billboard over all of the image that a sphere can reach: four corners of a rectangle, an instance a sphere.
layout(location = 0) in vec4 sphere_in;    // view space: centre, radius
layout(location = 1) in vec4 rectangle_in; // normalised device coordinates: low, high
flat out vec4 sphere;

void main() {
    sphere = sphere_in;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(rectangle_in.xy, rectangle_in.zw, corner), 0.0, 1.0);
}
