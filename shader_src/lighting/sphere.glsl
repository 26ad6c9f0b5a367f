// The picture of a unit sphere seen from far away: the viewer looks along -z, x points right, y up.
// Positions on the picture are in radii from the sphere's centre.
#ifndef LQ_LIGHTING_SPHERE_GLSL
#define LQ_LIGHTING_SPHERE_GLSL

#include "../core/frame.glsl"
#include "../core/math.glsl"

// The normal seen at `position`, which lies inside the unit disk.
vec3 lq_sphere_normal(const vec2 position) {
    return vec3(position.x, position.y, lq_safe_sqrt(1.0 - dot(position, position)));
}

// The frame of a surface whose tangent runs east along the parallel through `normal`; the poles are
// up and down. Brushed marks follow it.
LqFrame lq_sphere_frame(const vec3 normal) {
    return lq_frame_from_tangent(normal, vec3(normal.z, 0.0, -normal.x));
}

// Fraction of a pixel of width `pixel` at `position` that the sphere covers, as if its edge were
// straight.
float lq_sphere_coverage(const vec2 position, const float pixel) {
    return clamp((1.0 - length(position)) / pixel + 0.5, 0.0, 1.0);
}

// Where to shade a pixel of width `pixel`: its centre, or for a pixel that the edge crosses, a point
// half a pixel inside it, so that the edge is not the black of grazing light.
vec2 lq_sphere_shading_position(const vec2 position, const float pixel) {
    const float limit = 1.0 - 0.5 * pixel;
    const float radius = length(position);
    return radius > limit ? position * (limit / radius) : position;
}

#endif
