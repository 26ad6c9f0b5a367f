// What a conductor at the bottom of a stack reflects, all orders of scattering: a polynomial of
// direction per colour channel.
#ifndef LQ_STACK_CONDUCTOR_GLSL
#define LQ_STACK_CONDUCTOR_GLSL

#include "../fresnel/conductor.glsl"
#include "../tables/interpolate.glsl"
#include "interface.glsl"
#include "nodes.glsl"

// The largest indices of conductors that the tables hold.
const float LQ_MOST_TABLE_ETA = 5.0;
const float LQ_MOST_TABLE_KAPPA = 10.0;

// Coefficients of T_0 to T_7 of 2 sqrt(cos_theta) - 1.
struct LqConductorAlbedo {
    LqOctet red;
    LqOctet green;
    LqOctet blue;
};

LqOctet lq_conductor_material(const float eta, const float kappa) {
    const LqSegment row = lq_table_segment(
        lq_safe_sqrt(min(eta / LQ_MOST_TABLE_ETA, 1.0)) * float(LQ_CONDUCTOR_INDICES - 1),
        LQ_CONDUCTOR_INDICES);
    const LqSegment column = lq_table_segment(
        lq_safe_sqrt(min(kappa / LQ_MOST_TABLE_KAPPA, 1.0)) * float(LQ_CONDUCTOR_INDICES - 1),
        LQ_CONDUCTOR_INDICES);
    return lq_table_read(lq_table_cell(row, column, LQ_CONDUCTOR_INDICES, 1),
                         LQ_CONDUCTOR_MATERIALS);
}

LqOctet lq_octet_sum(const LqOctet sum, const LqOctet more, const float factor) {
    return LqOctet(sum.low + more.low * factor, sum.high + more.high * factor);
}

// eta + i kappa relative to the medium above, both at least 0.
LqConductorAlbedo lq_conductor_albedo(const float alpha, const vec3 eta, const vec3 kappa) {
    const LqOctet red = lq_conductor_material(eta.x, kappa.x);
    const LqOctet green = lq_conductor_material(eta.y, kappa.y);
    const LqOctet blue = lq_conductor_material(eta.z, kappa.z);
    vec3 terms[LQ_CONDUCTOR_TERMS];
    terms[0] = vec3(red.low.x, green.low.x, blue.low.x);
    terms[1] = vec3(red.low.y, green.low.y, blue.low.y);
    terms[2] = vec3(red.low.z, green.low.z, blue.low.z);
    terms[3] = vec3(red.low.w, green.low.w, blue.low.w);
    terms[4] = vec3(red.high.x, green.high.x, blue.high.x);
    terms[5] = vec3(red.high.y, green.high.y, blue.high.y);
    terms[6] = vec3(red.high.z, green.high.z, blue.high.z);
    terms[7] = vec3(red.high.w, green.high.w, blue.high.w);
    const LqSegment row = lq_alpha_segment(alpha, LQ_CONDUCTOR_ALPHAS);
    const LqOctet nothing = LqOctet(vec4(0.0), vec4(0.0));
    LqConductorAlbedo albedo = LqConductorAlbedo(nothing, nothing, nothing);
    for (int k = 0; k < LQ_CONDUCTOR_TERMS; k++) {
        const LqOctet facets =
            lq_table_read_line(row, LQ_CONDUCTOR_TERMS, LQ_CONDUCTOR_FACETS + k);
        albedo.red = lq_octet_sum(albedo.red, facets, terms[k].x);
        albedo.green = lq_octet_sum(albedo.green, facets, terms[k].y);
        albedo.blue = lq_octet_sum(albedo.blue, facets, terms[k].z);
    }
    return albedo;
}

// A number for each direction of a lobe.
struct LqNodeValues {
    vec4 low;
    vec4 high;
};

// What one channel reflects in the directions of a lobe. Of a smooth conductor the polynomials know
// the differences between directions better than the values: with `reflectance`, of the mean
// direction, these are put right.
LqNodeValues lq_conductor_channel(const LqOctet albedo, const bool is_smooth,
                                  const float reflectance, const float cosine,
                                  const LqStackNodes nodes) {
    float correction = 0.0;
    if (is_smooth) {
        const float x = 2.0 * lq_safe_sqrt(cosine) - 1.0;
        correction = reflectance - lq_chebyshev_sums(albedo.low, albedo.high, vec4(x)).x;
    }
    return LqNodeValues(
        clamp(lq_chebyshev_sums(albedo.low, albedo.high, 2.0 * sqrt(nodes.low) - vec4(1.0)) +
                  vec4(correction), vec4(0.0), vec4(1.0)),
        clamp(lq_chebyshev_sums(albedo.low, albedo.high, 2.0 * sqrt(nodes.high) - vec4(1.0)) +
                  vec4(correction), vec4(0.0), vec4(1.0)));
}

#endif
