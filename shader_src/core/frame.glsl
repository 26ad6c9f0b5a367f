// Orthonormal frames: every BSDF of the library works in a local frame whose z is the normal.
// Based on: Duff et al. 2017, Building an Orthonormal Basis, Revisited
#ifndef LQ_CORE_FRAME_GLSL
#define LQ_CORE_FRAME_GLSL

#include "constants.glsl"

struct LqFrame {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};

// A frame about `normal` (unit), its tangent chosen without a branch in the normal's direction.
LqFrame lq_frame_from_normal(const vec3 normal) {
    const float side = normal.z < 0.0 ? -1.0 : 1.0;
    const float a = -1.0 / (side + normal.z);
    const float b = normal.x * normal.y * a;
    return LqFrame(vec3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x),
                   vec3(b, side + normal.y * normal.y * a, -normal.y),
                   normal);
}

// A frame about `normal` (unit) whose tangent is as near `tangent` as it can be; where the two are
// parallel, any tangent serves.
LqFrame lq_frame_from_tangent(const vec3 normal, const vec3 tangent) {
    const vec3 across = cross(normal, tangent);
    const float length_squared = dot(across, across);
    if (length_squared < 1.0e-12) {
        return lq_frame_from_normal(normal);
    }
    const vec3 bitangent = across * (1.0 / sqrt(length_squared));
    return LqFrame(cross(bitangent, normal), bitangent, normal);
}

vec3 lq_frame_to_local(const LqFrame frame, const vec3 w) {
    return vec3(dot(w, frame.tangent), dot(w, frame.bitangent), dot(w, frame.normal));
}

vec3 lq_frame_to_world(const LqFrame frame, const vec3 w) {
    return frame.tangent * w.x + frame.bitangent * w.y + frame.normal * w.z;
}

// Whether `w` is a direction above the surface. False too for vectors far from unit length, whose
// formulas could overflow: what is not a direction reflects nothing.
bool lq_is_above(const vec3 w) {
    const float length_squared = dot(w, w);
    if (length_squared < LQ_MIN_SQUARED_LENGTH) {
        return false;
    }
    return w.z > 0.0 ? length_squared < LQ_MAX_SQUARED_LENGTH : false;
}

#endif
