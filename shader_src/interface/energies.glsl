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

// Where no light gets through there is no variance; this keeps the quotient finite.
const float LQ_MIN_ENERGY = 1.0e-12;

// Variance of the lobe of alpha 1: 1 / (12 (1 - ln 2)).
const float LQ_MAX_LOBE_VARIANCE = 0.271574279439244;

// `transmission`: T01 of the three colour channels, light arriving at cos_theta that enters and
// crosses the medium; in w the same of a clear medium, so that 1 - w is what is reflected.
// `t_up`: T10_bar, diffuse light that crosses the medium upwards and leaves. `r_up`: R10_bar,
// diffuse light that crosses, is reflected inside and crosses again.
// `multiple`: in x the reflected light that has met more than one facet; the rest is 0.
struct LqInterface {
    LqDirectionPolynomial transmission;
    vec3 t_up;
    vec3 r_up;
    LqDirectionPolynomial multiple;
    float multiple_average;
};

// Values of the functions of tau; a channel in each component.
struct LqAbsorption {
    vec4 values[LQ_ABSORPTIONS];
};

LqAbsorption lq_interface_absorption(const int first, const vec3 tau) {
    const LqSegment red = lq_tau_segment(tau.x);
    const LqSegment green = lq_tau_segment(tau.y);
    const LqSegment blue = lq_tau_segment(tau.z);
    const vec4 r = lq_table_read_line(first, red, LQ_ABSORPTION_TEXELS, 0);
    const vec4 g = lq_table_read_line(first, green, LQ_ABSORPTION_TEXELS, 0);
    const vec4 b = lq_table_read_line(first, blue, LQ_ABSORPTION_TEXELS, 0);
    const vec4 clear = lq_table_texel(first);
    LqAbsorption absorption;
    absorption.values[0] = vec4(r.x, g.x, b.x, clear.x);
    absorption.values[1] = vec4(r.y, g.y, b.y, clear.y);
    absorption.values[2] = vec4(r.z, g.z, b.z, clear.z);
    absorption.values[3] = vec4(r.w, g.w, b.w, clear.w);
    absorption.values[4] = vec4(lq_table_read_line(first, red, LQ_ABSORPTION_TEXELS, 1).x,
                                lq_table_read_line(first, green, LQ_ABSORPTION_TEXELS, 1).x,
                                lq_table_read_line(first, blue, LQ_ABSORPTION_TEXELS, 1).x,
                                lq_table_texel(first + 1).x);
    return absorption;
}

// eta < 1, to one side: 8, 8, 6, 6 and 4 coefficients for the functions of tau, end to end.
LqCoefficients lq_interface_thin_side(const LqCell cell, const LqAbsorption absorption) {
    vec4 texels[LQ_T_DOWN_THIN_TEXELS];
    for (int n = 0; n < LQ_T_DOWN_THIN_TEXELS; n++) {
        texels[n] = lq_table_read(cell, n);
    }
    LqCoefficients side;
    side.values[0] = absorption.values[0] * texels[0].x + absorption.values[1] * texels[2].x +
                     absorption.values[2] * texels[4].x + absorption.values[3] * texels[5].z +
                     absorption.values[4] * texels[7].x;
    side.values[1] = absorption.values[0] * texels[0].y + absorption.values[1] * texels[2].y +
                     absorption.values[2] * texels[4].y + absorption.values[3] * texels[5].w +
                     absorption.values[4] * texels[7].y;
    side.values[2] = absorption.values[0] * texels[0].z + absorption.values[1] * texels[2].z +
                     absorption.values[2] * texels[4].z + absorption.values[3] * texels[6].x +
                     absorption.values[4] * texels[7].z;
    side.values[3] = absorption.values[0] * texels[0].w + absorption.values[1] * texels[2].w +
                     absorption.values[2] * texels[4].w + absorption.values[3] * texels[6].y +
                     absorption.values[4] * texels[7].w;
    side.values[4] = absorption.values[0] * texels[1].x + absorption.values[1] * texels[3].x +
                     absorption.values[2] * texels[5].x + absorption.values[3] * texels[6].z;
    side.values[5] = absorption.values[0] * texels[1].y + absorption.values[1] * texels[3].y +
                     absorption.values[2] * texels[5].y + absorption.values[3] * texels[6].w;
    side.values[6] = absorption.values[0] * texels[1].z + absorption.values[1] * texels[3].z;
    side.values[7] = absorption.values[0] * texels[1].w + absorption.values[1] * texels[3].w;
    return side;
}

// eta >= 1: 8 coefficients for each function of tau.
LqCoefficients lq_interface_dense_side(const LqCell cell, const LqAbsorption absorption) {
    LqCoefficients side;
    for (int n = 0; n < LQ_COEFFICIENTS; n++) {
        side.values[n] = vec4(0.0);
    }
    for (int k = 0; k < LQ_ABSORPTIONS; k++) {
        const vec4 share = absorption.values[k];
        const vec4 low = lq_table_read(cell, 2 * k);
        const vec4 high = lq_table_read(cell, 2 * k + 1);
        side.values[0] += share * low.x;
        side.values[1] += share * low.y;
        side.values[2] += share * low.z;
        side.values[3] += share * low.w;
        side.values[4] += share * high.x;
        side.values[5] += share * high.y;
        side.values[6] += share * high.z;
        side.values[7] += share * high.w;
    }
    return side;
}

LqDirectionPolynomial lq_interface_transmission(const float alpha, const float eta,
                                                const vec3 tau) {
    const LqSegment row = lq_alpha_segment(alpha, LQ_TABLE_ALPHAS);
    LqDirectionPolynomial transmission;
    transmission.critical = lq_critical_cosine(eta);
    if (eta < 1.0) {
        const LqSegment column = lq_eta_segment(eta, LQ_T_DOWN_THIN_ETAS);
        const LqAbsorption absorption = lq_interface_absorption(LQ_T_DOWN_THIN_ABSORPTION, tau);
        transmission.below = lq_interface_thin_side(
            lq_table_cell(LQ_T_DOWN_THIN_BELOW, row, column, LQ_T_DOWN_THIN_ETAS,
                          LQ_T_DOWN_THIN_TEXELS),
            absorption);
        transmission.above = lq_interface_thin_side(
            lq_table_cell(LQ_T_DOWN_THIN_ABOVE, row, column, LQ_T_DOWN_THIN_ETAS,
                          LQ_T_DOWN_THIN_TEXELS),
            absorption);
        return transmission;
    }
    const LqSegment column = lq_eta_segment(eta, LQ_TABLE_ETAS);
    transmission.above = lq_interface_dense_side(
        lq_table_cell(LQ_T_DOWN_DENSE_ABOVE, row, column, LQ_TABLE_ETAS, LQ_T_DOWN_DENSE_TEXELS),
        lq_interface_absorption(LQ_T_DOWN_DENSE_ABSORPTION, tau));
    transmission.below = transmission.above;
    return transmission;
}

// Six coefficients in two texels.
LqCoefficients lq_interface_multiple_side(const int first, const LqSegment row,
                                          const LqSegment column) {
    const LqCell cell = lq_table_cell(first, row, column, LQ_TABLE_ETAS, LQ_MULTIPLE_TEXELS);
    const vec4 low = lq_table_read(cell, 0);
    const vec4 high = lq_table_read(cell, 1);
    LqCoefficients side;
    side.values[0] = vec4(low.x, 0.0, 0.0, 0.0);
    side.values[1] = vec4(low.y, 0.0, 0.0, 0.0);
    side.values[2] = vec4(low.z, 0.0, 0.0, 0.0);
    side.values[3] = vec4(low.w, 0.0, 0.0, 0.0);
    side.values[4] = vec4(high.x, 0.0, 0.0, 0.0);
    side.values[5] = vec4(high.y, 0.0, 0.0, 0.0);
    side.values[6] = vec4(0.0);
    side.values[7] = vec4(0.0);
    return side;
}

LqDirectionPolynomial lq_interface_multiple(const float alpha, const float eta) {
    const LqSegment row = lq_alpha_segment(alpha, LQ_TABLE_ALPHAS);
    const LqSegment column = lq_eta_segment(eta, LQ_TABLE_ETAS);
    LqDirectionPolynomial multiple;
    multiple.critical = lq_critical_cosine(eta);
    if (eta < 1.0) {
        multiple.below = lq_interface_multiple_side(LQ_MULTIPLE_THIN_BELOW, row, column);
        multiple.above = lq_interface_multiple_side(LQ_MULTIPLE_THIN_ABOVE, row, column);
        return multiple;
    }
    multiple.above = lq_interface_multiple_side(LQ_MULTIPLE_DENSE_ABOVE, row, column);
    multiple.below = multiple.above;
    return multiple;
}

// Below, from the arrays of one side of eta 1.
vec3 lq_interface_dimming_side(const int maps, const int first, const float alpha,
                               const float eta, const vec3 tau) {
    const LqCell cell =
        lq_table_cell(maps, lq_alpha_segment(alpha, LQ_TABLE_ALPHAS),
                      lq_eta_segment(eta, LQ_TABLE_ETAS), LQ_TABLE_ETAS, LQ_R_UP_TEXELS);
    const vec4 low = lq_table_read(cell, 0);
    const vec4 high = lq_table_read(cell, 1);
    const LqSegment red = lq_tau_segment(tau.x);
    const LqSegment green = lq_tau_segment(tau.y);
    const LqSegment blue = lq_tau_segment(tau.z);
    const vec3 change = vec3(dot(low, lq_table_read_line(first, red, LQ_R_UP_TEXELS, 0)) +
                                 dot(high, lq_table_read_line(first, red, LQ_R_UP_TEXELS, 1)),
                             dot(low, lq_table_read_line(first, green, LQ_R_UP_TEXELS, 0)) +
                                 dot(high, lq_table_read_line(first, green, LQ_R_UP_TEXELS, 1)),
                             dot(low, lq_table_read_line(first, blue, LQ_R_UP_TEXELS, 0)) +
                                 dot(high, lq_table_read_line(first, blue, LQ_R_UP_TEXELS, 1)));
    return clamp(vec3(1.0) + change, vec3(0.0), vec3(1.0));
}

// What the two crossings of the medium leave of the light reflected inside, in [0, 1].
vec3 lq_interface_dimming(const float alpha, const float eta, const vec3 tau) {
    if (eta < 1.0) {
        return lq_interface_dimming_side(LQ_R_UP_THIN_MAPS, LQ_R_UP_THIN_ABSORPTION, alpha, eta,
                                         tau);
    }
    return lq_interface_dimming_side(LQ_R_UP_DENSE_MAPS, LQ_R_UP_DENSE_ABSORPTION, alpha, eta, tau);
}

// No channel lets more through than a clear medium, in w: else light would be made where tables are
// off.
vec4 lq_no_more_than_clear(const vec4 energy) {
    return min(energy, vec4(energy.w));
}

// alpha in [0, 1] of GGX facets; eta = ior below / ior above in [1/3, 3]; tau in [0, 1] per colour
// channel, the transmittance of the medium along its normal.
LqInterface lq_interface_prepare(const float alpha, const float eta, const vec3 tau) {
    LqInterface energies;
    energies.transmission = lq_interface_transmission(alpha, eta, tau);
    // Reciprocity: T10_bar eta^2 is the average of T01, and a path has the same length both ways.
    const vec4 t_up = lq_no_more_than_clear(
        clamp(lq_direction_energy(energies.transmission) * (2.0 / (eta * eta)), vec4(0.0),
              vec4(1.0)));
    energies.t_up = vec3(t_up.x, t_up.y, t_up.z);
    energies.r_up = lq_interface_dimming(alpha, eta, tau) * (1.0 - t_up.w);
    energies.multiple = lq_interface_multiple(alpha, eta);
    energies.multiple_average = max(2.0 * lq_direction_energy(energies.multiple).x, 0.0);
    return energies;
}

// T01 of the three channels, and in w of a clear medium; cos_theta in [0, 1].
vec4 lq_interface_t_down(const LqInterface energies, const float cos_theta) {
    return lq_no_more_than_clear(clamp(lq_direction_polynomial(energies.transmission, cos_theta),
                                       vec4(0.0), vec4(1.0)));
}

// Light reflected after more than one facet, which a single-scattering lobe lacks.
float lq_interface_fgd_multiple(const LqInterface energies, const float cos_theta) {
    return clamp(lq_direction_polynomial(energies.multiple, cos_theta).x, 0.0, 1.0);
}

// sigma_2+: variance of the light that leaves, per axis of the projected disk and colour channel.
vec3 lq_interface_variance(const LqInterface energies) {
    const vec4 energy =
        max(lq_direction_energy(energies.transmission), vec4(LQ_MIN_ENERGY));
    const vec4 spread = lq_direction_spread(energies.transmission);
    const vec4 variance = clamp(vec4(0.5) - 0.5 * spread / energy, vec4(0.0), vec4(0.5));
    return vec3(variance.x, variance.y, variance.z);
}

// alpha_2+: roughness of the GGX lobe, of light along the normal, that has this variance; and the
// share of light that its single scattering keeps.
float lq_equivalent_alpha(const float variance) {
    const float position =
        lq_safe_sqrt(variance / LQ_MAX_LOBE_VARIANCE) * float(LQ_LOBE_VARIANCES - 1);
    return lq_table_read_line(LQ_LOBE_ALPHA, lq_table_segment(position, LQ_LOBE_VARIANCES), 1, 0).x;
}

float lq_normal_lobe_energy(const float alpha) {
    return lq_table_read_line(LQ_LOBE_ENERGY, lq_alpha_segment(alpha, LQ_MIRROR_ALPHAS), 1, 0).x;
}

#endif
