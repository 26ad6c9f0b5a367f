// What a plane slab of a scattering medium does to light that crosses it, in closed form, red, green,
// blue and a channel without absorption at once: how much is transmitted and sent back, all orders
// of scattering, and how wide it is. The phase function is Henyey and Greenstein's.
// Based on: Joseph, Wiscombe and Weinman 1976, The Delta-Eddington Approximation for Radiative Flux
//           Transfer; Meador and Weaver 1980, Two-Stream Approximations to Radiative Transfer in
//           Planetary Atmospheres; van de Hulst 1980, Multiple Light Scattering (similarity)
//
// A beam that fades feeds two diffuse streams. The numbers were fitted to simulated slabs.
#ifndef LQ_STACK_SCATTERING_GLSL
#define LQ_STACK_SCATTERING_GLSL

#include "beam.glsl"
#include "facet_effect.glsl"
#include "nodes.glsl"

// Optical depths along the normal, of the four channels; g in [-0.99, 0.99] is the mean cosine of
// the phase function.
struct LqSlab {
    vec4 absorption;
    vec4 scattering;
    float g;
};

// Shares of the light that came: what leaves through the other side, and through the same.
struct LqSlabLight {
    vec4 transmitted;
    vec4 back;
};

// x^y for x in [0, 1] and y > 0; 0 at 0.
float lq_power(const float x, const float y) {
    return x > 0.0 ? exp(log(x) * y) : 0.0;
}

// Of light at `cosine` in [0, 1].
LqSlabLight lq_slab_light(const LqSlab slab, const float cosine) {
    const vec4 one = vec4(1.0);
    const float c = max(cosine, LQ_LEAST_CROSSING_COSINE);
    // Of scattered light the share g^1.85 goes on as if it had not been, less so near grazing.
    const float forward = max(slab.g, 0.0);
    const float kept = lq_power(forward, 1.85);
    const float g = (slab.g - kept) / (1.0 - kept);
    const float beam_kept = kept * c / (c + 0.314 * forward * (1.0 - forward));
    const vec4 leaving = slab.scattering * (1.0 - beam_kept);
    const vec4 lost = slab.absorption + leaving;
    const vec4 albedo =
        slab.scattering / max(slab.scattering + slab.absorption, vec4(1.0e-12));
    const vec4 up = clamp(vec4(0.5) + 0.159 * forward * albedo -
                              vec4((0.734 + 1.13 * max(g, 0.0)) * g * lq_power(c, 0.709)),
                          vec4(0.0), one);
    const vec4 down = one - up;
    const vec4 depth = max(lost / c, vec4(1.0e-12));
    const vec4 fed = leaving / max(lost, vec4(1.0e-12));
    const vec4 b = 0.794 * (1.0 - slab.g) * slab.scattering;
    // Where the streams fade as fast as the beam the solution divides 0 by 0: a step aside.
    const vec4 loss = 2.3 * slab.absorption;
    const vec4 gap = abs(depth - sqrt(loss * (loss + 2.0 * b)));
    const vec4 a = loss * (one - 0.006 * (one - step(0.001 * depth, gap)));
    const vec4 squared = a * (a + 2.0 * b);
    const vec4 k = sqrt(squared);
    const vec4 fade = exp(-k);
    const vec4 sech = 2.0 * fade / (one + fade * fade);
    const vec4 ratio = mix((one - fade * fade) / ((one + fade * fade) * max(k, vec4(1.0e-3))),
                           one - squared / 3.0, one - step(vec4(1.0e-3), k));
    const vec4 beam = exp(-depth);
    const vec4 gained_down = a * down + b;
    const vec4 gained_up = a * up + b;
    const vec4 scale = fed * depth / ((depth * depth - squared) * (one + (a + b) * ratio));
    const vec4 transmitted =
        beam - scale * (beam * ((depth * gained_down + squared * down) * ratio + depth * down +
                                gained_down) -
                        (depth * down + gained_down) * sech);
    const vec4 back = scale * ((depth * gained_up - squared * up) * ratio +
                               (depth * up - gained_up) * (one - beam * sech));
    const vec4 unscattered = exp(-(slab.absorption + slab.scattering) / c);
    return LqSlabLight(max(transmitted, unscattered), max(back, vec4(0.0)));
}

// Averaged over the directions of a lobe. A loop, so that stacks of clear media pay little for it.
LqSlabLight lq_slab_light_of_lobe(const LqSlab slab, const LqStackNodes nodes) {
    vec4 transmitted = vec4(0.0);
    vec4 back = vec4(0.0);
    for (int n = 0; n < 7; n++) {
        const float cosine = lq_octet_number(LqOctet(nodes.low, nodes.high), n);
        const LqSlabLight light = lq_slab_light(slab, cosine);
        transmitted += light.transmitted * LQ_NODE_WEIGHT;
        back += light.back * LQ_NODE_WEIGHT;
    }
    return LqSlabLight(transmitted, back);
}

// How wide light is that was parallel: the roughness of the GGX lobe that is as wide, and its mean
// sine over that of the light that came.
struct LqSlabLobe {
    float alpha;
    float sine_ratio;
};

// `spread` is a variance on the projected disk, both axes together: 0.5 for a Lambertian lobe.
float lq_alpha_of_spread(const float spread, const float cosine) {
    const float v = clamp(spread, 0.0, 0.62);
    const float width = max(sqrt(v), 1.0e-6);
    const float c = clamp(cosine, 0.05, 1.0);
    const float log_alpha = 1.0345 * log(width) - 0.2286 / (c + 0.1) - 1.4913 * c +
                            1.9008 * c * width + (0.4404 - 1.2914 * log(c)) * v * v;
    return min(exp(log_alpha), 0.95);
}

// Of transmitted light; one slab for all channels, of these depths.
LqSlabLobe lq_transmitted_lobe(const float absorption, const float scattering, const float g,
                               const float cosine) {
    const float c = max(cosine, LQ_LEAST_CROSSING_COSINE);
    const float forward = max(g, 0.0);
    const float isotropic = 1.0 - forward;
    const float turning = scattering * (1.0 - g);
    const float path = turning / c;
    const float most = 0.394 + 0.186 * isotropic * (1.0 - c);
    // Absorption takes from light that scattering leads to longer ways, and spares what it leads to
    // shorter ones.
    const float longer = 1.8 * isotropic * absorption;
    const float shorter = (1.47 * isotropic + 0.0559 * forward) * absorption * (1.0 / c - 1.0);
    const float rate = (1.16 * (1.0 + min(g, 0.0)) + 1.63 * forward) *
                       exp(log(c) * (0.197 * forward - 0.0709)) * (1.0 + shorter) / (1.0 + longer);
    const float turned = (0.613 + 0.898 * forward) * turning / (c + 0.13 * forward);
    const float spread = most * (1.0 - exp(-rate * path * (1.0 + 0.474 * path)));
    return LqSlabLobe(lq_alpha_of_spread(spread, cosine),
                      exp(-turned / (1.0 + 0.278 * (1.0 - c) * forward * turned)));
}

// Of light that comes back: nearly Lambertian.
LqSlabLobe lq_back_lobe(const float scattering, const float g, const float cosine) {
    const float forward = max(g, 0.0);
    const float depth = scattering * (1.0 - g);
    return LqSlabLobe(lq_alpha_of_spread(0.5, cosine),
                      (0.046 + 1.006 * forward) * (1.0 - 0.5 * lq_safe_sqrt(cosine)) /
                          (1.0 + 1.39 * depth / (depth + 0.574)));
}

// A part of a beam that a slab has scattered.
LqStackBeam lq_scattered_beam(const LqStackBeam beam, const vec4 share, const LqSlabLobe lobe) {
    const float sine =
        min(lq_sine_from_cosine(beam.cosine) * lobe.sine_ratio, LQ_MOST_SINE);
    return LqStackBeam(lq_sine_from_cosine(sine),
                       lq_widened(beam.widths, 1.0, lq_lobe_variance(lq_square(lobe.alpha))),
                       beam.interfaces * share, beam.base * share);
}

#endif
