// The directions of a lobe as seven cosines of equal energy, over which the coefficients of
// interfaces and media are averaged: taken at the mean direction alone they are wrong by as much as
// 0.15 where a wide lobe reaches beyond the critical angle or takes long ways through a dark medium.
#ifndef LQ_STACK_NODES_GLSL
#define LQ_STACK_NODES_GLSL

#include "../tables/interpolate.glsl"

const float LQ_NODE_WEIGHT = 0.142857142857143;

// Light crossing a medium nearer to grazing is taken at this cosine.
const float LQ_LEAST_CROSSING_COSINE = 0.001;

// `low` and `high` are cosines in [0, 1], the steps what they differ by from the lobe's mean. The
// last components of `high` and its steps count for nothing.
struct LqStackNodes {
    vec4 low;
    vec4 high;
    vec4 low_steps;
    vec4 high_steps;
};

// A number for each direction of a lobe.
struct LqNodeValues {
    vec4 low;
    vec4 high;
};

LqOctet lq_stack_lobe(const float cosine, const float alpha) {
    const LqSegment column =
        lq_table_segment(lq_safe_sqrt(cosine) * float(LQ_LOBE_COSINES - 1), LQ_LOBE_COSINES);
    const LqCell cell = lq_table_cell(lq_alpha_segment(alpha, LQ_LOBE_NODE_ALPHAS), column,
                                      LQ_LOBE_COSINES, 1);
    return lq_table_read(cell, LQ_LOBE_NODES);
}

// Of the light that GGX mirrors of roughness `alpha` make of light at `cosine`, both in [0, 1].
LqStackNodes lq_stack_nodes(const float cosine, const float alpha) {
    const LqOctet lobe = lq_stack_lobe(cosine, alpha);
    LqStackNodes nodes;
    nodes.low_steps = clamp(lobe.low, vec4(-cosine), vec4(1.0 - cosine));
    nodes.high_steps = clamp(lobe.high, vec4(-cosine), vec4(1.0 - cosine));
    nodes.low = vec4(cosine) + nodes.low_steps;
    nodes.high = vec4(cosine) + nodes.high_steps;
    return nodes;
}

// The share of light that single reflections keep.
float lq_stack_single(const float cosine, const float alpha) {
    return lq_stack_lobe(cosine, alpha).high.w;
}

float lq_node_average(const vec4 low, const vec4 high) {
    return (low.x + low.y + low.z + low.w + (high.x + high.y + high.z)) * LQ_NODE_WEIGHT;
}

#endif
