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

// eta + i kappa relative to the medium above, both at least 0. Nothing unless `conducts`.
LqConductorAlbedo lq_conductor_albedo(const bool conducts, const float alpha, const vec3 eta,
                                      const vec3 kappa) {
    const LqSegment row = lq_alpha_segment(alpha, LQ_CONDUCTOR_ALPHAS);
    const LqOctet nothing = LqOctet(vec4(0.0), vec4(0.0));
    LqOctet red = nothing;
    LqOctet green = nothing;
    LqOctet blue = nothing;
    // Channel by channel, then term by term: what is read is in the code once.
    for (int channel = conducts ? 0 : 3; channel < 3; channel++) {
        red = green;
        green = blue;
        blue = lq_conductor_material(eta[channel], kappa[channel]);
    }
    LqConductorAlbedo albedo = LqConductorAlbedo(nothing, nothing, nothing);
    for (int k = conducts ? 0 : LQ_CONDUCTOR_TERMS; k < LQ_CONDUCTOR_TERMS; k++) {
        const LqOctet term =
            lq_table_read_line(row, LQ_CONDUCTOR_TERMS, LQ_CONDUCTOR_FACETS + k);
        albedo.red = lq_octet_sum(albedo.red, term, lq_octet_number(red, k));
        albedo.green = lq_octet_sum(albedo.green, term, lq_octet_number(green, k));
        albedo.blue = lq_octet_sum(albedo.blue, term, lq_octet_number(blue, k));
    }
    return albedo;
}

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
