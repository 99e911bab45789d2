// An orthonormal frame around a unit normal, without branches.
// This work is based on: Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin. Building an orthonormal basis,
// revisited. 2017.
void compute_tangent_frame(vec3 n, out vec3 tangent, out vec3 bitangent) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    tangent = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    bitangent = vec3(b, s + n.y * n.y * a, -n.y);
}
