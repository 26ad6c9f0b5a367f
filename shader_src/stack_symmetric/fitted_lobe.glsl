// A lobe of light that has entered a stack, as cubics of the cosine at which it came: a direction
// then costs no transport.
#ifndef LQ_STACK_SYMMETRIC_FITTED_LOBE_GLSL
#define LQ_STACK_SYMMETRIC_FITTED_LOBE_GLSL

#include "../microfacet/facets.glsl"
#include "../stack/cubic.glsl"

// Red, green and blue per what has entered, where the cubics are in [0, 1], and the lobe's
// roughness, which what is known of it bounds. `is_lit` unless it has no light at all.
struct LqFittedLobe {
    bool is_lit;
    LqCubic light;
    float least_alpha;
    float most_alpha;
};

// Of the lobe's red, green, blue and roughness at the nodes of cubics from `least` on.
LqFittedLobe lq_fitted_lobe(const vec4 a, const vec4 b, const vec4 c, const vec4 d,
                            const float least) {
    const float narrowest = min(min(a.w, b.w), min(c.w, d.w));
    const float widest = max(max(a.w, b.w), max(c.w, d.w));
    const bool is_lit = dot(a + b + c + d, vec4(1.0, 1.0, 1.0, 0.0)) > 0.0;
    return LqFittedLobe(is_lit, lq_cubic_through(a, b, c, d, least),
                        clamp(narrowest, LQ_MIN_ALPHA, 1.0), clamp(widest, LQ_MIN_ALPHA, 1.0));
}

// Red, green, blue and roughness; `cosine` in [0, 1].
vec4 lq_fitted_light(const LqFittedLobe lobe, const float cosine) {
    return clamp(lq_cubic_value(lobe.light, cosine), vec4(0.0, 0.0, 0.0, lobe.least_alpha),
                 vec4(1.0, 1.0, 1.0, lobe.most_alpha));
}

LqFacets lq_fitted_facets(const vec4 light) {
    return LqFacets(LQ_NDF_GGX, light.w, light.w);
}

#endif
