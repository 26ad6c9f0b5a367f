// What brings the albedo of a symmetric lobe to the light that the lobe should have: a factor b of
// the cosine of either direction, per channel. Alone, lobes at grazing angles take their light from
// directions for which the stack reflects more, and none has what meets several facets.
// Based on: Sinkhorn 1964, A Relationship Between Arbitrary Positive Matrices and Doubly Stochastic
//           Matrices
#ifndef LQ_STACK_SYMMETRIC_BALANCE_GLSL
#define LQ_STACK_SYMMETRIC_BALANCE_GLSL

#include "../core/frame.glsl"
#include "../microfacet/reflection.glsl"
#include "../stack/diffuse_base.glsl"
#include "fitted_lobe.glsl"

#define LQ_BALANCE_NODES 5

// Points of the sampling square of visible normals, along each side; the other half of all azimuths
// mirrors this one. With 32 times as many, albedos change by 0.0003 in the mean.
const int LQ_BALANCE_AZIMUTHS = 2;
const int LQ_BALANCE_HEIGHTS = 8;

const int LQ_BALANCE_STEPS = 8;  // which find b to a percent

// No b can be found where nothing enters, or all of a lobe points below the surface.
const float LQ_LEAST_BALANCE = 0.2;
const float LQ_MOST_BALANCE = 5.0;
const float LQ_LEAST_BALANCED_ALBEDO = 1.0e-9;

// b at the first node, and by how much each of its channels rises from each node to the next.
struct LqBalance {
    vec3 first;
    vec4 red_rises;
    vec4 green_rises;
    vec4 blue_rises;
};

// The cosines between which b is linear, 0.05 to 1; finer at grazing angles, where it bends.
float lq_balance_node(const int n) {
    return min(0.05 + 0.05 * float(n * (n + 1)), 1.0);
}

// How far `cosine` in [0, 1] has come on the way from each node to the next.
vec4 lq_balance_ways(const float cosine) {
    const vec4 nodes = vec4(0.05, 0.15, 0.35, 0.65);
    const vec4 steps = vec4(0.1, 0.2, 0.3, 0.35);
    return clamp((vec4(cosine) - nodes) / steps, vec4(0.0), vec4(1.0));
}

vec3 lq_balance_value(const LqBalance balance, const float cosine) {
    const vec4 ways = lq_balance_ways(cosine);
    return balance.first + vec3(dot(balance.red_rises, ways), dot(balance.green_rises, ways),
                                dot(balance.blue_rises, ways));
}

// Of light that has entered along wo, the part that the lobe without b sends to wi, over the density
// of wi as a mirror image by normals of roughness `alpha` that are visible from wo.
vec3 lq_balance_weight(const LqStackSurface surface, const LqFittedLobe lobe, const float alpha,
                       const vec3 wi, const vec3 wo) {
    const vec4 light = lq_fitted_light(lobe, lq_cos_theta_halfway(wi, wo));
    const float leaving = sqrt(lq_stack_entering(surface, min(wi.z, 1.0)));
    const float pdf = lq_reflection_pdf(LqFacets(LQ_NDF_GGX, alpha, alpha), wi, wo);
    return vec3(light.x, light.y, light.z) *
           (leaving * wi.z * lq_reflection_lobe(lq_fitted_facets(light), wi, wo) /
            max(pdf, LQ_TINY_LIGHT));
}

// A lobe's albedo over b of the viewer's direction: what each channel takes of the first value of b
// and of its rises. Of light that has entered along wo, in which direction the lobe's roughness is
// `alpha`.
LqBalance lq_balanced_albedo(const LqStackSurface surface, const LqFittedLobe lobe,
                             const float alpha, const vec3 wo) {
    const LqFacets facets = LqFacets(LQ_NDF_GGX, alpha, alpha);
    LqBalance albedo = LqBalance(vec3(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (int facet = 0; facet < LQ_BALANCE_AZIMUTHS * LQ_BALANCE_HEIGHTS; facet++) {
        const float azimuth = float(facet / LQ_BALANCE_HEIGHTS) + 0.5;
        const float height = float(facet % LQ_BALANCE_HEIGHTS) + 0.5;
        const vec3 wi = lq_reflection_sample(facets, wo,
                                             vec2(0.5 * azimuth / float(LQ_BALANCE_AZIMUTHS),
                                                  height / float(LQ_BALANCE_HEIGHTS)));
        if (lq_is_above(wi)) {
            const vec3 weight = lq_balance_weight(surface, lobe, alpha, wi, wo) /
                                float(LQ_BALANCE_AZIMUTHS * LQ_BALANCE_HEIGHTS);
            const vec4 ways = lq_balance_ways(min(wi.z, 1.0));
            albedo.first += weight;
            albedo.red_rises += weight.x * ways;
            albedo.green_rises += weight.y * ways;
            albedo.blue_rises += weight.z * ways;
        }
    }
    return albedo;
}

// A channel of b after another turn, from its last value, the light that the lobe sent with it and
// the light wanted.
float lq_balance_step(const float last, const float sent, const float wanted) {
    if (sent <= LQ_LEAST_BALANCED_ALBEDO) {
        return 1.0;
    }
    return clamp(sqrt(last * wanted / sent), LQ_LEAST_BALANCE, LQ_MOST_BALANCE);
}

// By alternating scaling, half a step at a time, in logarithms. 1 of a lobe that has no light, for
// which no loop is entered.
LqBalance lq_fit_balance(const LqStackSurface surface, const LqFittedLobe lobe) {
    vec3 of_first[LQ_BALANCE_NODES];
    vec4 of_red[LQ_BALANCE_NODES];
    vec4 of_green[LQ_BALANCE_NODES];
    vec4 of_blue[LQ_BALANCE_NODES];
    vec3 wanted[LQ_BALANCE_NODES];
    vec3 values[LQ_BALANCE_NODES];
    for (int node = 0; node < (lobe.is_lit ? LQ_BALANCE_NODES : 0); node++) {
        const float cosine = lq_balance_node(node);
        const vec4 light = lq_fitted_light(lobe, cosine);
        const float entering = lq_stack_entering(surface, cosine);
        const LqBalance albedo = lq_balanced_albedo(
            surface, lobe, light.w, vec3(lq_sine_from_cosine(cosine), 0.0, cosine));
        of_first[node] = sqrt(entering) * albedo.first;
        of_red[node] = sqrt(entering) * albedo.red_rises;
        of_green[node] = sqrt(entering) * albedo.green_rises;
        of_blue[node] = sqrt(entering) * albedo.blue_rises;
        wanted[node] = entering * vec3(light.x, light.y, light.z);
        values[node] = vec3(1.0);
    }
    LqBalance balance = LqBalance(vec3(1.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (int turn = 0; turn < (lobe.is_lit ? LQ_BALANCE_STEPS : 0); turn++) {
        for (int k = 0; k < LQ_BALANCE_NODES; k++) {
            const vec3 sent = of_first[k] * balance.first +
                              vec3(dot(of_red[k], balance.red_rises),
                                   dot(of_green[k], balance.green_rises),
                                   dot(of_blue[k], balance.blue_rises));
            values[k] = vec3(lq_balance_step(values[k].x, sent.x, wanted[k].x),
                             lq_balance_step(values[k].y, sent.y, wanted[k].y),
                             lq_balance_step(values[k].z, sent.z, wanted[k].z));
        }
        const vec3 first_rise = values[1] - values[0];
        const vec3 second_rise = values[2] - values[1];
        const vec3 third_rise = values[3] - values[2];
        const vec3 fourth_rise = values[4] - values[3];
        balance =
            LqBalance(values[0], vec4(first_rise.x, second_rise.x, third_rise.x, fourth_rise.x),
                      vec4(first_rise.y, second_rise.y, third_rise.y, fourth_rise.y),
                      vec4(first_rise.z, second_rise.z, third_rise.z, fourth_rise.z));
    }
    return balance;
}

#endif
