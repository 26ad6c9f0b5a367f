// Light on its way across a medium, in the directions of a lobe.
#ifndef LQ_STACK_MEDIUM_GLSL
#define LQ_STACK_MEDIUM_GLSL

#include "beam.glsl"
#include "conductor.glsl"
#include "nodes.glsl"

// What is left of each channel.
struct LqCrossedLight {
    LqNodeValues red;
    LqNodeValues green;
    LqNodeValues blue;
};

LqNodeValues lq_crossed_channel(const float depth, const vec4 low_ways, const vec4 high_ways) {
    return LqNodeValues(exp(-depth * low_ways), exp(-depth * high_ways));
}

// `depth`: optical depths along the normal.
LqCrossedLight lq_crossed_light(const vec3 depth, const LqStackNodes nodes) {
    const vec4 low = vec4(1.0) / max(nodes.low, vec4(LQ_LEAST_CROSSING_COSINE));
    const vec4 high = vec4(1.0) / max(nodes.high, vec4(LQ_LEAST_CROSSING_COSINE));
    return LqCrossedLight(lq_crossed_channel(depth.x, low, high),
                          lq_crossed_channel(depth.y, low, high),
                          lq_crossed_channel(depth.z, low, high));
}

LqNodeValues lq_node_product(const LqNodeValues a, const LqNodeValues b) {
    return LqNodeValues(a.low * b.low, a.high * b.high);
}

// Part of the light of a beam: the share of each channel, and its mean cosine. `cosine_by_sine` is
// that of a mean whose sine is to the beam's as the mean sines of part and all are: right also of
// lobes so wide that their mean cosine says little of where they point.
struct LqPart {
    vec4 share;
    float cosine;
    float cosine_by_sine;
};

vec4 lq_sines_of_four(const vec4 cosines) {
    return sqrt(max((vec4(1.0) - cosines) * (vec4(1.0) + cosines), vec4(0.0)));
}

// What of each channel arrives and goes that way; `clear` the same of a channel without absorption.
LqPart lq_part(const LqStackBeam beam, const LqStackNodes nodes, const LqNodeValues red,
               const LqNodeValues green, const LqNodeValues blue, const LqNodeValues clear) {
    const vec4 energy = beam.interfaces + beam.base;
    const vec4 low = energy.x * red.low + energy.y * green.low + energy.z * blue.low +
                     energy.w * clear.low;
    const vec4 high = energy.x * red.high + energy.y * green.high + energy.z * blue.high +
                      energy.w * clear.high;
    const float light = lq_node_average(low, high);
    const float all_steps = lq_node_average(nodes.low_steps, nodes.high_steps);
    const vec4 low_sines = lq_sines_of_four(nodes.low);
    const vec4 high_sines = lq_sines_of_four(nodes.high);
    const float all_sines = lq_node_average(low_sines, high_sines);
    float cosine = beam.cosine;
    float cosine_by_sine = beam.cosine;
    if (light > LQ_TINY_LIGHT) {
        const float steps =
            lq_node_average(low * nodes.low_steps, high * nodes.high_steps) / light;
        cosine = clamp(beam.cosine + (steps - all_steps), min(beam.cosine, LQ_LEAST_COSINE), 1.0);
        const float sines =
            lq_node_average(low * low_sines, high * high_sines) / light;
        const float ratio = sines / max(all_sines, LQ_TINY_LIGHT);
        cosine_by_sine = lq_sine_from_cosine(
            min(lq_sine_from_cosine(beam.cosine) * ratio, LQ_MOST_SINE));
    }
    return LqPart(vec4(lq_node_average(red.low, red.high), lq_node_average(green.low, green.high),
                       lq_node_average(blue.low, blue.high),
                       lq_node_average(clear.low, clear.high)), cosine, cosine_by_sine);
}

LqPart lq_crossed_part(const LqStackBeam beam, const LqStackNodes nodes,
                       const LqCrossedLight crossing, const LqNodeValues share) {
    return lq_part(beam, nodes, lq_node_product(crossing.red, share),
                   lq_node_product(crossing.green, share), lq_node_product(crossing.blue, share),
                   share);
}

LqStackBeam lq_part_of(const LqStackBeam beam, const LqPart part) {
    return LqStackBeam(part.cosine, beam.widths, beam.interfaces * part.share,
                       beam.base * part.share);
}

#endif
