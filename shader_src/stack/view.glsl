// The lobes of the forward model: the light of a stack followed from one viewer's direction.
#ifndef LQ_STACK_VIEW_GLSL
#define LQ_STACK_VIEW_GLSL

#include "lobes.glsl"
#include "transport.glsl"

// Of the light at the bottom what leaves there, all or nothing.
LqStackLobe lq_stack_exit_of(const LqStackSurface surface, const LqStackBeam beam,
                             const vec3 wo) {
    const float leaving = surface.base == LQ_STACK_BASE_NONE ? 1.0 : 0.0;
    return lq_stack_lobe_below((beam.interfaces + beam.base) * leaving,
                               lq_safe_sqrt(lq_beam_width(beam)), beam.cosine, wo);
}

// For any number of lights; `wo` above the surface. All light that is followed is followed here, in
// one loop: the viewer's, and before it what a Lambertian base needs, at four directions and from
// below.
LqStackView lq_stack_view(const LqStackSurface surface, const vec3 wo) {
    const float cosine = clamp(wo.z, 0.0, 1.0);
    const float least = lq_least_entering_cosine(surface);
    const bool is_lambertian = surface.base == LQ_STACK_BASE_LAMBERTIAN;
    LqStackLight light = lq_no_light();
    vec4 a = vec4(0.0);
    vec4 b = vec4(0.0);
    vec4 c = vec4(0.0);
    vec4 d = vec4(0.0);
    vec4 returning = vec4(0.0);
    for (int run = is_lambertian ? 0 : 5; run < 6; run++) {
        const int diffuse = run == 4 ? LQ_LIGHT_FROM_BELOW : LQ_LIGHT_ENTERED;
        light = lq_stack_light(surface, run == 5 ? LQ_LIGHT_FROM_ABOVE : diffuse,
                               run == 5 ? cosine : lq_cubic_node(run, least));
        if (run == 4) {
            returning = light.returning;
        } else if (run < 4) {
            a = b;
            b = c;
            c = d;
            d = light.straight.interfaces + light.detoured.interfaces;
        }
    }
    const LqStackDiffuse diffuse_base =
        lq_stack_diffuse(surface, lq_cubic_through(a, b, c, d, least), returning);
    const vec4 arriving = lq_stack_arriving(surface, diffuse_base.arriving, cosine);
    return LqStackView(wo, light.top, lq_stack_top_multiple(surface, cosine),
                       lq_stack_lobe_of(light.interfaces, lq_safe_sqrt(light.interfaces_width), wo),
                       lq_stack_base_lobe(light.base, lq_safe_sqrt(light.base_width), wo),
                       lq_stack_exit_of(surface, light.straight, wo),
                       lq_stack_exit_of(surface, light.detoured, wo),
                       vec3(arriving.x, arriving.y, arriving.z), diffuse_base);
}

// f(wi, wo) of a viewer, who is above the surface.
vec3 lq_stack_value(const LqStackSurface surface, const LqStackView viewer, const vec3 wi) {
    if (!lq_is_above(wi)) {
        return lq_stack_value_below(viewer, wi);
    }
    return lq_stack_outer_value(surface, viewer, wi) + lq_stack_inner_value(viewer, wi);
}

#endif
