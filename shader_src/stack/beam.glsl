// Light that travels one way through one medium of a stack, as lobes that share a mean direction.
//
// The width of a lobe is alpha^2 of the GGX reflection lobe that is as wide: about in proportion to
// the square of its width on the projected disk, so that widths average. Reflections add up in
// f(alpha) = alpha^2 / (1 - alpha^2).
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, Eqs. 6 (with alpha^1.1), 8 and 9
#ifndef LQ_STACK_BEAM_GLSL
#define LQ_STACK_BEAM_GLSL

#include "../core/math.glsl"

const float LQ_MAX_WIDTH = 0.999;       // whose f is as good as infinite
const float LQ_TINY_LIGHT = 1.0e-30;    // keeps quotients of nothing finite

// Three lobes by what the light has met so far: nothing that reflects, interfaces below the top one
// at most, or the base. Energies are red, green, blue, and what they would be if no medium absorbed;
// `widths` the lobes' in that order; `cosine` the mean direction's.
struct LqStackBeam {
    float cosine;
    vec3 widths;
    vec4 through;
    vec4 interfaces;
    vec4 base;
};

LqStackBeam lq_no_beam() {
    return LqStackBeam(1.0, vec3(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
}

float lq_energy_sum(const vec4 energy) {
    return dot(energy, vec4(1.0));
}

vec3 lq_lobe_sums(const LqStackBeam beam) {
    return vec3(lq_energy_sum(beam.through), lq_energy_sum(beam.interfaces),
                lq_energy_sum(beam.base));
}

vec4 lq_beam_energy(const LqStackBeam beam) {
    return beam.through + beam.interfaces + beam.base;
}

// Roughness of all its light as one lobe.
float lq_beam_alpha(const LqStackBeam beam) {
    const vec3 sums = lq_lobe_sums(beam);
    return lq_safe_sqrt(dot(sums, beam.widths) / max(dot(sums, vec3(1.0)), LQ_TINY_LIGHT));
}

// Both beams' light; means and widths are averaged by energy.
LqStackBeam lq_merged(const LqStackBeam a, const LqStackBeam b) {
    const vec3 sums = lq_lobe_sums(a);
    const vec3 more = lq_lobe_sums(b);
    const vec3 shares = more / max(sums + more, vec3(LQ_TINY_LIGHT));
    const float here = dot(sums, vec3(1.0));
    const float rest = dot(more, vec3(1.0));
    const float share = rest / max(here + rest, LQ_TINY_LIGHT);
    return LqStackBeam(a.cosine + (b.cosine - a.cosine) * share,
                       a.widths + (b.widths - a.widths) * shares, a.through + b.through,
                       a.interfaces + b.interfaces, a.base + b.base);
}

float lq_lobe_variance(const float width) {
    const float most = min(width, LQ_MAX_WIDTH);
    return most / (1.0 - most);
}

vec3 lq_lobe_variances(const vec3 widths) {
    const vec3 most = min(widths, vec3(LQ_MAX_WIDTH));
    return most / (vec3(1.0) - most);
}

// Widths of lobes whose f is scaled and added to.
vec3 lq_widened(const vec3 widths, const float scale, const float added) {
    const vec3 variances = lq_lobe_variances(widths) * scale + vec3(added);
    return variances / (vec3(1.0) + variances);
}

// What has only gone through or met interfaces has met an interface, or the base, from now on.
LqStackBeam lq_met_interface(const LqStackBeam beam) {
    const float here = lq_energy_sum(beam.interfaces);
    const float more = lq_energy_sum(beam.through);
    const float share = more / max(here + more, LQ_TINY_LIGHT);
    const float width = beam.widths.y + (beam.widths.x - beam.widths.y) * share;
    return LqStackBeam(beam.cosine, vec3(0.0, width, beam.widths.z), vec4(0.0),
                       beam.interfaces + beam.through, beam.base);
}

LqStackBeam lq_met_base(const LqStackBeam beam) {
    const vec3 sums = lq_lobe_sums(beam);
    const float width =
        dot(sums, beam.widths) / max(dot(sums, vec3(1.0)), LQ_TINY_LIGHT);
    return LqStackBeam(beam.cosine, vec3(0.0, 0.0, width), vec4(0.0), vec4(0.0),
                       lq_beam_energy(beam));
}

#endif
