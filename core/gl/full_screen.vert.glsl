// One triangle that covers the screen, without vertex buffers.
out vec2 screen_uv; // (0,0) bottom left, (1,1) top right

void main() {
    screen_uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(screen_uv * 2.0 - 1.0, 0.0, 1.0);
}
