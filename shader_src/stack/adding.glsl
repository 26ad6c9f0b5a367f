// Light that goes back and forth in a stack for ever, from what each of its interfaces reflects and
// lets through: geometric series of series.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, Eqs. 28-31
#ifndef LQ_STACK_ADDING_GLSL
#define LQ_STACK_ADDING_GLSL

// The least that a round trip loses, which keeps the series finite.
const float LQ_LEAST_LOSS = 1.0e-4;

// The sum of all powers of what is left after a round trip.
vec4 lq_series(const vec4 ratio) {
    return vec4(1.0) / max(vec4(1.0) - ratio, vec4(LQ_LEAST_LOSS));
}

// All that is to one side of a medium as a mirror: an interface that reflects and lets through, and
// the mirror `beyond` it, which light meets again that the interface reflects back to it.
vec4 lq_mirror_behind(const vec4 reflected, const vec4 through, const vec4 beyond,
                      const vec4 back_through, const vec4 reflected_back) {
    return reflected + through * beyond * back_through * lq_series(beyond * reflected_back);
}

#endif
