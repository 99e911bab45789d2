// Vertices with the visibility that was traced at them.
layout(location = 0) in vec3 position;
layout(location = 1) in float traced_visibility;
uniform mat4 view_from_object; // relative to the camera, composed in double
uniform mat4 clip_from_view;
out float vertex_visibility;

void main() {
    vertex_visibility = traced_visibility;
    gl_Position = clip_from_view * (view_from_object * vec4(position, 1.0));
}
