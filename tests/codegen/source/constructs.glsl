// What shader source may come to use, gathered to see every language cope with it.
#ifndef LQ_TEST_CONSTRUCTS_GLSL
#define LQ_TEST_CONSTRUCTS_GLSL

const int LQ_TEST_MAX_LAYERS = 4;
const uint LQ_TEST_MASK = 255u;

struct LqTestLayer {
    float ior;
    vec3 tau;
};

struct LqTestStack {
    LqTestLayer layers[LQ_TEST_MAX_LAYERS];
    int count;
};

// Fills an array of structs from a loop with a dynamic count.
LqTestStack lq_test_stack(const int count, const float ior) {
    LqTestStack stack;
    stack.count = min(count, LQ_TEST_MAX_LAYERS);
    for (int i = 0; i < stack.count; i++) {
        stack.layers[i] = LqTestLayer(ior + float(i), vec3(0.5));
    }
    return stack;
}

// Leaves the loop early, skips turns, and changes what outlives them.
float lq_test_walk(const LqTestStack stack, const float start) {
    float depth = start;
    float best = -1.0;
    for (int i = 0; i < stack.count; i++) {
        const LqTestLayer layer = stack.layers[i];
        if (layer.ior < 1.0) {
            continue;
        }
        if (depth > 10.0) {
            break;
        }
        if (layer.ior > 3.0) {
            return depth;
        }
        best = layer.ior > best ? layer.ior : best * 0.5;
        depth += best * layer.tau.x;
    }
    return depth + best;
}

// Two loops in one another, the inner one bounded by the outer.
float lq_test_triangle(const float weights[4], const int count) {
    float sum = 0.0;
    for (int i = 0; i < count; i++) {
        float row = 0.0;
        for (int k = 0; k <= i; k++) {
            row += weights[k];
        }
        sum += row * weights[i];
    }
    return sum;
}

// A loop that ends by what it computes.
float lq_test_root(const float x) {
    float guess = x;
    int steps = 0;
    while (abs(guess * guess - x) > 1.0e-6 && steps < 32) {
        guess = 0.5 * (guess + x / guess);
        steps++;
    }
    return guess;
}

// Choices within expressions, within one another, and with conditions of several parts.
float lq_test_choices(const float x, const float y) {
    const float a = x > 0.0 ? sqrt(x) : (y > 0.0 ? log(y) : exp(x));
    const float b = 1.0 + (x < y ? lq_test_root(x) : lq_test_root(y)) * 2.0;
    if ((x > 0.0 && y > 0.0) || a > b) {
        return a - (b - x) / (y * a);
    }
    return -(a + b) * (x - -y);
}

// Integers and bits.
uint lq_test_bits(const uint x, const int shift) {
    uint bits = x ^ (x >> 3u);
    bits = (bits << uint(shift)) | (bits & LQ_TEST_MASK);
    for (uint i = 0u; i < 4u; i++) {
        bits += i * 7u + (bits % 5u);
    }
    return ~bits;
}

// A constant table.
float lq_test_table(const int index) {
    const float table[4] = float[](0.25, 0.5, 0.125, 1.0);
    return table[clamp(index, 0, 3)];
}

// Vectors and the built-in functions.
vec3 lq_test_vectors(const vec3 v, const vec2 u, const bool flip) {
    const vec3 mixed = mix(v, vec3(u.x, u.y, 1.0), smoothstep(0.0, 1.0, u.x));
    vec3 result = flip ? -mixed : mixed;
    result.y = max(result.y, 0.0);
    result += reflect(v, normalize(mixed)) * step(0.5, u.y);
    return clamp(result, vec3(0.0), vec3(LQ_TEST_MAX_LAYERS));
}

// Uses everything, so that a kernel reaches it.
float lq_test_all(const float x) {
    const LqTestStack stack = lq_test_stack(3, x);
    const float weights[4] = float[](x, x * 0.5, x * x, 1.0);
    const vec3 v = lq_test_vectors(vec3(x), vec2(x, 0.5), x > 0.5);
    return lq_test_walk(stack, x) + lq_test_triangle(weights, 4) + lq_test_choices(x, v.x) +
           float(lq_test_bits(uint(x), 2)) + lq_test_table(int(x)) + v.y;
}

#endif
