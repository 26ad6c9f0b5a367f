// The energies of light at one rough dielectric interface and the absorbing medium below it, from the
// baked tables: all orders of scattering.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           section 3 (the energies), section 4 (their compression)
//
// T01 is a sum over five functions of tau times polynomials of direction, whose coefficients lie over
// (alpha, eta). `lq_interface_prepare` contracts the tables once; then directions cost no read.
#ifndef LQ_INTERFACE_ENERGIES_GLSL
#define LQ_INTERFACE_ENERGIES_GLSL

#include "../tables/interpolate.glsl"
#include "polynomial.glsl"

const int LQ_ABSORPTIONS = 5;

// Of light reflected after more than one facet, averaged over cosine-weighted directions. Below it
// the ripple of its polynomial would be seen as rings, and the light fades out.
const float LQ_LEAST_MULTIPLE_AVERAGE = 0.001;

// Where no light gets through there is no variance; this keeps the quotient finite.
const float LQ_MIN_ENERGY = 1.0e-12;

// Variance of the lobe of alpha 1: 1 / (12 (1 - ln 2)).
const float LQ_MAX_LOBE_VARIANCE = 0.271574279439244;

// `transmission`: T01 of the three colour channels, light arriving at cos_theta that enters and
// crosses the medium; in w the same of a clear medium, so that 1 - w is what is reflected.
// `t_up`: T10_bar, diffuse light that crosses the medium upwards and leaves. `r_up`: R10_bar,
// diffuse light that crosses, is reflected inside and crosses again.
// `multiple`: the reflected light that has met more than one facet.
struct LqInterface {
    float critical;  // lq_critical_cosine
    LqDirectionPolynomials transmission;
    LqDirectionPolynomial multiple;
    float multiple_average;
    vec4 entering;  // integral of `transmission` over cos_theta dcos_theta
    vec3 t_up;
    vec3 r_up;
};

// Segments of the tau axis per colour channel.
struct LqTauSegments {
    LqSegment red;
    LqSegment green;
    LqSegment blue;
};

// Values of the functions of tau: a colour channel in each component, a clear medium in w.
struct LqAbsorption {
    vec4 values[LQ_ABSORPTIONS];
};

LqAbsorption lq_interface_absorption(const int first, const LqTauSegments tau) {
    const LqOctet r = lq_table_read_line(tau.red, LQ_ABSORPTION_TEXELS, first);
    const LqOctet g = lq_table_read_line(tau.green, LQ_ABSORPTION_TEXELS, first);
    const LqOctet b = lq_table_read_line(tau.blue, LQ_ABSORPTION_TEXELS, first);
    const LqOctet clear = lq_table_octet(first);
    LqAbsorption absorption;
    absorption.values[0] = vec4(r.low.x, g.low.x, b.low.x, clear.low.x);
    absorption.values[1] = vec4(r.low.y, g.low.y, b.low.y, clear.low.y);
    absorption.values[2] = vec4(r.low.z, g.low.z, b.low.z, clear.low.z);
    absorption.values[3] = vec4(r.low.w, g.low.w, b.low.w, clear.low.w);
    absorption.values[4] = vec4(r.high.x, g.high.x, b.high.x, clear.high.x);
    return absorption;
}

// T01 to one side of the critical angle: eight coefficients for each function of tau.
LqCoefficients lq_interface_t_down_side(const LqCell cell, const int first,
                                        const LqAbsorption absorption) {
    LqCoefficients side;
    for (int n = 0; n < LQ_COEFFICIENTS; n++) {
        side.values[n] = vec4(0.0);
    }
    for (int k = 0; k < LQ_ABSORPTIONS; k++) {
        const vec4 share = absorption.values[k];
        const LqOctet coefficients = lq_table_read(cell, first + k);
        side.values[0] += share * coefficients.low.x;
        side.values[1] += share * coefficients.low.y;
        side.values[2] += share * coefficients.low.z;
        side.values[3] += share * coefficients.low.w;
        side.values[4] += share * coefficients.high.x;
        side.values[5] += share * coefficients.high.y;
        side.values[6] += share * coefficients.high.z;
        side.values[7] += share * coefficients.high.w;
    }
    return side;
}

LqDirectionPolynomials lq_interface_t_down_functions(const LqSegment row, const float eta,
                                                     const LqAbsorption absorption) {
    const bool is_thin = eta < 1.0;
    const int etas = is_thin ? LQ_T_DOWN_THIN_ETAS : LQ_TABLE_ETAS;
    const LqCell cell = lq_table_cell(row, lq_eta_segment(eta, etas), etas, LQ_T_DOWN_TEXELS);
    LqDirectionPolynomials functions;
    functions.above = lq_interface_t_down_side(
        cell, is_thin ? LQ_T_DOWN_THIN_ABOVE : LQ_T_DOWN_DENSE_ABOVE, absorption);
    functions.below = functions.above;
    if (is_thin) {
        functions.below = lq_interface_t_down_side(cell, LQ_T_DOWN_THIN_BELOW, absorption);
    }
    return functions;
}

LqDirectionPolynomial lq_interface_multiple_function(const LqCell cell, const float eta) {
    const bool is_thin = eta < 1.0;
    const LqOctet above =
        lq_table_read(cell, is_thin ? LQ_MULTIPLE_THIN_ABOVE : LQ_MULTIPLE_DENSE_ABOVE);
    LqOctet below = above;
    if (is_thin) {
        below = lq_table_read(cell, LQ_MULTIPLE_THIN_BELOW);
    }
    return LqDirectionPolynomial(below.low, below.high, above.low, above.high);
}

float lq_interface_dimming_channel(const LqOctet map, const LqSegment tau, const int first) {
    const LqOctet functions = lq_table_read_line(tau, LQ_ABSORPTION_TEXELS, first);
    return 1.0 + dot(map.low, functions.low) + dot(map.high, functions.high);
}

// What the two crossings of the medium leave of the light reflected inside, in [0, 1].
vec3 lq_interface_dimming(const LqCell cell, const float eta, const LqTauSegments tau) {
    const bool is_thin = eta < 1.0;
    const LqOctet map = lq_table_read(cell, is_thin ? LQ_R_UP_THIN : LQ_R_UP_DENSE);
    const int first = (is_thin ? LQ_ABSORPTION_THIN : LQ_ABSORPTION_DENSE) + 1;
    return clamp(vec3(lq_interface_dimming_channel(map, tau.red, first),
                      lq_interface_dimming_channel(map, tau.green, first),
                      lq_interface_dimming_channel(map, tau.blue, first)),
                 vec3(0.0), vec3(1.0));
}

// No channel lets more through than a clear medium, in w: else light would be made where tables are
// off.
vec4 lq_no_more_than_clear(const vec4 energy) {
    return min(energy, vec4(energy.w));
}

// alpha in [0, 1] of GGX facets; eta = ior below / ior above in [1/3, 3]; tau in [0, 1] per colour
// channel, the transmittance of the medium along its normal.
LqInterface lq_interface_prepare(const float alpha, const float eta, const vec3 tau) {
    const LqSegment row = lq_alpha_segment(alpha, LQ_TABLE_ALPHAS);
    const LqCell cell = lq_table_cell(row, lq_eta_segment(eta, LQ_TABLE_ETAS), LQ_TABLE_ETAS, 1);
    const LqTauSegments taus =
        LqTauSegments(lq_tau_segment(tau.x), lq_tau_segment(tau.y), lq_tau_segment(tau.z));
    const LqAbsorption absorption =
        lq_interface_absorption(eta < 1.0 ? LQ_ABSORPTION_THIN : LQ_ABSORPTION_DENSE, taus);
    LqInterface energies;
    energies.critical = lq_critical_cosine(eta);
    energies.transmission = lq_interface_t_down_functions(row, eta, absorption);
    energies.multiple = lq_interface_multiple_function(cell, eta);
    const LqDirectionWeights weights = lq_energy_weights(energies.critical);
    energies.multiple_average =
        max(2.0 * lq_direction_integral(energies.multiple, weights), 0.0);
    energies.entering =
        max(lq_direction_integrals(energies.transmission, weights), vec4(0.0));
    // Reciprocity: T10_bar eta^2 is the average of T01, and a path has the same length both ways.
    const vec4 t_up = lq_no_more_than_clear(
        min(energies.entering * (2.0 / (eta * eta)), vec4(1.0)));
    energies.t_up = vec3(t_up.x, t_up.y, t_up.z);
    energies.r_up = lq_interface_dimming(cell, eta, taus) * (1.0 - t_up.w);
    return energies;
}

// T01 of the three channels, and in w of a clear medium; cos_theta in [0, 1].
vec4 lq_interface_t_down(const LqInterface energies, const float cos_theta) {
    return lq_no_more_than_clear(
        clamp(lq_direction_values(energies.transmission, energies.critical, cos_theta),
              vec4(0.0), vec4(1.0)));
}

// Light reflected after more than one facet, which a single-scattering lobe lacks.
float lq_interface_fgd_multiple(const LqInterface energies, const float cos_theta) {
    return clamp(lq_direction_value(energies.multiple, energies.critical, cos_theta), 0.0, 1.0);
}

// What makes m(wi) m(wo) an f whose albedo is m, of this average of m: 1 / (pi average), and in
// proportion to it below the least.
float lq_multiple_scale(const float average) {
    const float bounded = max(average, LQ_LEAST_MULTIPLE_AVERAGE);
    return LQ_INVERSE_PI * average / (bounded * bounded);
}

// How far the light that leaves spreads, per colour channel: the mean of its sin^2_theta, less
// lq_mean_sine_squared, which is what light through a smooth interface has about.
vec3 lq_interface_spread(const LqInterface energies) {
    const vec4 spread =
        lq_direction_integrals(energies.transmission, lq_spread_weights(energies.critical)) /
        max(energies.entering, vec4(LQ_MIN_ENERGY));
    return vec3(spread.x, spread.y, spread.z);
}

// sigma_2+: variance of that light per axis of the projected disk, in [0, 0.5].
float lq_spread_variance(const float critical, const float spread) {
    return clamp(0.5 * (lq_mean_sine_squared(critical) + spread), 0.0, 0.5);
}

// Where a variance is on the table of lobes, spaced as squares. Next to the largest, which is near
// that of diffuse light, roughness grows 2.7 times as fast as variance: counted from there, by what
// is missing, so that the difference of the two is not rounded twice.
LqSegment lq_lobe_segment(const float critical, const float spread) {
    const int most = LQ_LOBE_VARIANCES - 1;
    const float variance = lq_spread_variance(critical, spread);
    if (variance < 0.5 * LQ_MAX_LOBE_VARIANCE) {
        return lq_table_segment(lq_safe_sqrt(variance / LQ_MAX_LOBE_VARIANCE) * float(most),
                                LQ_LOBE_VARIANCES);
    }
    const float missing =
        (LQ_MAX_LOBE_VARIANCE - 0.5 * lq_mean_sine_squared(critical)) - 0.5 * spread;
    const float share = clamp(missing / LQ_MAX_LOBE_VARIANCE, 0.0, 1.0);
    const LqSegment from_most = lq_table_segment(
        share / (1.0 + lq_safe_sqrt(1.0 - share)) * float(most), LQ_LOBE_VARIANCES);
    return LqSegment(most - from_most.low, most - from_most.high, from_most.share);
}

// alpha_2+: roughness of the GGX lobe, of light along the normal, that has this variance; and the
// share of light that its single scattering keeps.
float lq_equivalent_alpha(const float critical, const float spread) {
    return lq_table_read_line(lq_lobe_segment(critical, spread), 1, LQ_LOBE_ALPHA).low.x;
}

float lq_normal_lobe_energy(const float alpha) {
    const LqSegment segment = lq_alpha_segment(alpha, LQ_MIRROR_ALPHAS);
    return lq_table_read_line(segment, 1, LQ_LOBE_ENERGY).low.x;
}

#endif
