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

// Two lobes by what the light has met so far: interfaces at most, or the base. Energies are red,
// green, blue, and what they would be if no medium absorbed; `widths` the lobes' in that order;
// `cosine` the mean direction's.
struct LqStackBeam {
    float cosine;
    vec2 widths;
    vec4 interfaces;
    vec4 base;
};

LqStackBeam lq_no_beam() {
    return LqStackBeam(1.0, vec2(0.0), vec4(0.0), vec4(0.0));
}

vec2 lq_lobe_sums(const LqStackBeam beam) {
    return vec2(dot(beam.interfaces, vec4(1.0)), dot(beam.base, vec4(1.0)));
}

// Width of all its light as one lobe.
float lq_beam_width(const LqStackBeam beam) {
    const vec2 sums = lq_lobe_sums(beam);
    return dot(sums, beam.widths) / max(sums.x + sums.y, LQ_TINY_LIGHT);
}

// Both beams' light; means and widths are averaged by energy.
LqStackBeam lq_merged(const LqStackBeam a, const LqStackBeam b) {
    const vec2 sums = lq_lobe_sums(a);
    const vec2 more = lq_lobe_sums(b);
    const vec2 shares = more / max(sums + more, vec2(LQ_TINY_LIGHT));
    const float rest = more.x + more.y;
    const float share = rest / max(sums.x + sums.y + rest, LQ_TINY_LIGHT);
    return LqStackBeam(a.cosine + (b.cosine - a.cosine) * share,
                       a.widths + (b.widths - a.widths) * shares, a.interfaces + b.interfaces,
                       a.base + b.base);
}

float lq_lobe_variance(const float width) {
    const float most = min(width, LQ_MAX_WIDTH);
    return most / (1.0 - most);
}

vec2 lq_lobe_variances(const vec2 widths) {
    const vec2 most = min(widths, vec2(LQ_MAX_WIDTH));
    return most / (vec2(1.0) - most);
}

// Widths of lobes whose f is scaled and added to.
vec2 lq_widened(const vec2 widths, const float scale, const float added) {
    const vec2 variances = lq_lobe_variances(widths) * scale + vec2(added);
    return variances / (vec2(1.0) + variances);
}

// From now on all its light has met the base.
LqStackBeam lq_met_base(const LqStackBeam beam) {
    return LqStackBeam(beam.cosine, vec2(0.0, lq_beam_width(beam)), vec4(0.0),
                       beam.interfaces + beam.base);
}

#endif
