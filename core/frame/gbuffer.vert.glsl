// Everything is relative to the current camera: matrices were composed in double on the CPU.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 view_from_object;
uniform mat4 clip_from_view;
uniform mat3 normal_matrix;
uniform mat4 motion_matrix; // previous minus current object-to-world: zero for static objects

out vec3 view_normal;
out float eye_depth;
out vec3 motion;

void main() {
    vec4 view_position = view_from_object * vec4(position, 1.0);
    view_normal = normal_matrix * normal;
    eye_depth = -view_position.z;
    motion = (motion_matrix * vec4(position, 1.0)).xyz;
    gl_Position = clip_from_view * view_position;
}
