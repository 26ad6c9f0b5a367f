// Counter-based random numbers: the n-th number of a stream is computed from (stream, n) alone, so
// that a result does not depend on how the work was split.
// Based on: Jarzynski and Olano 2020, Hash Functions for GPU Rendering (pcg4d)
#ifndef LQ_CORE_RANDOM_GLSL
#define LQ_CORE_RANDOM_GLSL

// Four well-mixed 32-bit words from a four-word counter.
uvec4 lq_random_bits(const uvec4 counter) {
    uint x = counter.x * 1664525u + 1013904223u;
    uint y = counter.y * 1664525u + 1013904223u;
    uint z = counter.z * 1664525u + 1013904223u;
    uint w = counter.w * 1664525u + 1013904223u;
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    x = x ^ (x >> 16u);
    y = y ^ (y >> 16u);
    z = z ^ (z >> 16u);
    w = w ^ (w >> 16u);
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
    return uvec4(x, y, z, w);
}

// A uniform number in [0, 1) from the upper 24 bits of a word: every value is exact in a float.
float lq_uniform_from_bits(const uint bits) {
    return float(bits >> 8u) * 5.9604644775390625e-08;
}

// Four uniform numbers in [0, 1).
vec4 lq_random_uniforms(const uvec4 counter) {
    const uvec4 bits = lq_random_bits(counter);
    return vec4(lq_uniform_from_bits(bits.x), lq_uniform_from_bits(bits.y),
                lq_uniform_from_bits(bits.z), lq_uniform_from_bits(bits.w));
}

#endif
