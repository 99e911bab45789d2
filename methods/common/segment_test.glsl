// Does anything that the viewer's depth layers know block a segment?
// This work is based on: Ritschel, Grosch, Seidel. Approximating dynamic global illumination in image space. 2009,
// section 4 (shadows of one light: samples on a segment towards it) and section 5 (the segment that a shadow map's bias
// leaves open).
#include "methods/common/layered_surfaces.glsl"

// `samples` points in the middles of equal parts of the segment from p to p + along. `bias`: of the receiver's footprint,
// inverse metres; thickness: of solids whose back is not known; reach: of blockers, metres from p.
bool is_segment_blocked(vec3 p, vec3 along, int samples, float bias, float thickness, float reach) {
    for (int i = 0; i < samples; ++i) {
        vec3 q = p + along * ((float(i) + 0.5) / float(samples));
        if (find_blocker(p, q, bias, thickness, reach).is_there) {
            return true;
        }
    }
    return false;
}
