// The lobes of light that was reflected below the top interface, the same when light and viewer
// change places. For each class of light, of the interfaces and of a conductor,
//
//   f(wi, wo) = b(c_i) b(c_o) sqrt(T(c_i) T(c_o)) e(c_d) D(h) G2(wi, wo) / (4 c_i c_o)
//
// with c_i, c_o and c_d the cosines of wi and wo to the normal and of either to the half vector h;
// T what the top interface lets in, e what of that comes back, and b the factor of balance.glsl. e
// and the lobe's roughness are cubics of c_d.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, section 6.2
//
// Differs: there T is taken at c_d too, which lets light in beyond critical angles of the top
// interface; light is followed for every pair of directions; and there is no b.
#ifndef LQ_STACK_SYMMETRIC_LOBES_GLSL
#define LQ_STACK_SYMMETRIC_LOBES_GLSL

#include "../stack/lobes.glsl"
#include "surface.glsl"

// `lobes` are the forward model's, by which directions are chosen; the others what of f each class
// has from wo: b sqrt(T).
struct LqStackSymmetricView {
    LqStackView lobes;
    vec3 interfaces_share;
    vec3 base_share;
};

// Of light at `cosine` that the top interface lets in by the share `entering`.
LqStackLobe lq_symmetric_albedo_lobe(const LqSymmetricLobe lobe, const float entering,
                                     const vec3 wo) {
    const vec4 light = lq_fitted_light(lobe.light, min(wo.z, 1.0));
    return LqStackLobe(wo, entering * vec3(light.x, light.y, light.z), 1.0, light.w);
}

// Of a conductor.
LqStackLobe lq_symmetric_base_lobe(const LqSymmetricLobe lobe, const float entering,
                                   const vec3 wo) {
    if (LQ_STACK_LOBES == 2) {
        return lq_stack_no_lobe(wo);
    }
    return lq_symmetric_albedo_lobe(lobe, entering, wo);
}

LqStackLobe lq_symmetric_lobe_below(const LqFittedLobe lobe, const float entering,
                                    const float sine_ratio, const vec3 wo) {
    const float cosine = min(wo.z, 1.0);
    const vec4 light = lq_fitted_light(lobe, cosine);
    const float sine = clamp(sine_ratio * lq_sine_from_cosine(cosine), 0.0, LQ_MOST_SINE);
    return lq_stack_lobe_below(entering * light, light.w, lq_sine_from_cosine(sine), wo);
}

// What comes through a stack is no more than what has entered and was not reflected, which cubics
// know apart from it: the lobe's light by so much.
LqStackLobe lq_symmetric_lobe_within(const LqStackLobe lobe, const vec3 share) {
    return LqStackLobe(lobe.about, lobe.energy * share, lobe.scale, lobe.alpha);
}

// For any number of lights; `wo` above the surface.
LqStackSymmetricView lq_stack_symmetric_view(const LqStackSymmetricSurface surface,
                                             const vec3 wo) {
    const float cosine = clamp(wo.z, 0.0, 1.0);
    const float entering = lq_stack_entering(surface.stack, cosine);
    const float leaving = surface.stack.base == LQ_STACK_BASE_NONE ? entering : 0.0;
    const vec4 sine_ratios = lq_cubic_value(surface.sine_ratios, cosine);
    const vec4 arriving = lq_stack_arriving(surface.stack, surface.diffuse.arriving, cosine);
    const LqStackLobe interfaces = lq_symmetric_albedo_lobe(surface.interfaces, entering, wo);
    const LqStackLobe base = lq_symmetric_base_lobe(surface.base, entering, wo);
    const LqStackLobe straight =
        lq_symmetric_lobe_below(surface.straight, leaving, sine_ratios.x, wo);
    const LqStackLobe detoured =
        lq_symmetric_lobe_below(surface.detoured, leaving, sine_ratios.y, wo);
    const vec3 room = max(vec3(entering) - interfaces.energy - base.energy, vec3(0.0));
    const vec3 share = min(
        room / max(straight.energy + detoured.energy, vec3(LQ_TINY_LIGHT)), vec3(1.0));
    return LqStackSymmetricView(
        LqStackView(wo, 1.0 - entering, lq_stack_top_multiple(surface.stack, cosine), interfaces,
                    base, lq_symmetric_lobe_within(straight, share),
                    lq_symmetric_lobe_within(detoured, share),
                    vec3(arriving.x, arriving.y, arriving.z), surface.diffuse),
        lq_balance_value(surface.interfaces.balance, cosine) * sqrt(entering),
        lq_balance_value(surface.base.balance, cosine) * sqrt(entering));
}

// f of a class, over what it has from either direction.
vec3 lq_symmetric_lobe_value(const LqSymmetricLobe lobe, const vec3 wi, const vec3 wo) {
    const vec4 light = lq_fitted_light(lobe.light, lq_cos_theta_halfway(wi, wo));
    return vec3(light.x, light.y, light.z) * lq_reflection_lobe(lq_fitted_facets(light), wi, wo);
}

// f(wi, wo) of a viewer, who is above the surface.
vec3 lq_stack_symmetric_value(const LqStackSymmetricSurface surface,
                              const LqStackSymmetricView viewer, const vec3 wi) {
    if (!lq_is_above(wi)) {
        return lq_stack_value_below(viewer.lobes, wi);
    }
    const float cosine = min(wi.z, 1.0);
    const float entering = sqrt(lq_stack_entering(surface.stack, cosine));
    const vec3 interfaces_share = lq_balance_value(surface.interfaces.balance, cosine) * entering;
    const vec3 f = lq_stack_outer_value(surface.stack, viewer.lobes, wi) +
                   interfaces_share * viewer.interfaces_share *
                       lq_symmetric_lobe_value(surface.interfaces, wi, viewer.lobes.wo);
    if (LQ_STACK_LOBES == 2) {
        return f;
    }
    const vec3 base_share = lq_balance_value(surface.base.balance, cosine) * entering;
    return f + base_share * viewer.base_share *
                   lq_symmetric_lobe_value(surface.base, wi, viewer.lobes.wo);
}

#endif
