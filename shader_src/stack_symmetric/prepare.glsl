// From a stack's parameters to what symmetric shading needs of it: the only light that is followed.
#ifndef LQ_STACK_SYMMETRIC_PREPARE_GLSL
#define LQ_STACK_SYMMETRIC_PREPARE_GLSL

#include "../stack/prepare.glsl"
#include "../stack/transport.glsl"
#include "surface.glsl"

// What becomes of light that has entered at one cosine: lobes as in LqFittedLobe, ratios of sines as
// in LqStackSymmetricSurface, and what arrives at a Lambertian base.
struct LqEnteredLight {
    vec4 interfaces;
    vec4 base;
    vec4 straight;
    vec4 detoured;
    vec4 sine_ratios;
    vec4 arriving;
};

LqEnteredLight lq_no_entered_light() {
    return LqEnteredLight(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
}

// Less is as good as none: its width hangs on the last digits.
const float LQ_LEAST_LIGHT = 1.0e-12;

bool lq_is_lit(const vec4 energy) {
    return dot(energy, vec4(1.0)) > LQ_LEAST_LIGHT;
}

// A lobe without light is as wide as the one `before`, nearer to the normal.
vec4 lq_entered_lobe(const vec4 energy, const float width, const vec4 before) {
    return vec4(energy.x, energy.y, energy.z, lq_is_lit(energy) ? lq_safe_sqrt(width) : before.w);
}

// And as oblique.
float lq_sine_ratio(const LqStackBeam beam, const float cosine, const float before) {
    const float ratio = lq_sine_from_cosine(beam.cosine) / lq_sine_from_cosine(cosine);
    return lq_is_lit(beam.interfaces + beam.base) ? ratio : before;
}

// Of `light` that has entered at `cosine`, in (0, 1); `before` nearer to the normal.
LqEnteredLight lq_entered_light(const LqStackLight light, const float cosine,
                                const LqEnteredLight before) {
    const LqStackBeam straight = light.straight;
    const LqStackBeam detoured = light.detoured;
    const vec4 straight_energy = straight.interfaces + straight.base;
    const vec4 detoured_energy = detoured.interfaces + detoured.base;
    return LqEnteredLight(
        lq_entered_lobe(light.interfaces, light.interfaces_width, before.interfaces),
        lq_entered_lobe(light.base, light.base_width, before.base),
        lq_entered_lobe(straight_energy, lq_beam_width(straight), before.straight),
        lq_entered_lobe(detoured_energy, lq_beam_width(detoured), before.detoured),
        vec4(lq_sine_ratio(straight, cosine, before.sine_ratios.x),
             lq_sine_ratio(detoured, cosine, before.sine_ratios.y), 0.0, 0.0),
        straight_energy + detoured_energy);
}

// For shading: call it once per shading point. What is out of range is clamped. All light that is
// followed is followed in one loop: light that has entered at four cosines, from the normal to
// grazing, and for a Lambertian base from below.
LqStackSymmetricSurface lq_stack_symmetric_prepare(const LqStackMaterial material) {
    LqStackSymmetricSurface surface;
    surface.stack = lq_stack_prepare(material);
    const float least = lq_least_entering_cosine(surface.stack);
    LqEnteredLight a = lq_no_entered_light();
    LqEnteredLight b = a;
    LqEnteredLight c = a;
    LqEnteredLight d = a;
    vec4 returning = vec4(0.0);
    const int runs = surface.stack.base == LQ_STACK_BASE_LAMBERTIAN ? 5 : 4;
    for (int run = 0; run < runs; run++) {
        const float cosine = lq_cubic_node(3 - run, least);
        const LqStackLight light = lq_stack_light(
            surface.stack, run == 4 ? LQ_LIGHT_FROM_BELOW : LQ_LIGHT_ENTERED, cosine);
        if (run == 4) {
            returning = light.returning;
        } else {
            const LqEnteredLight before = a;
            d = c;
            c = b;
            b = a;
            a = lq_entered_light(light, cosine, before);
        }
    }
    surface.interfaces.light =
        lq_fitted_lobe(a.interfaces, b.interfaces, c.interfaces, d.interfaces, least);
    surface.base.light = lq_fitted_lobe(a.base, b.base, c.base, d.base, least);
    surface.straight = lq_fitted_lobe(a.straight, b.straight, c.straight, d.straight, least);
    surface.detoured = lq_fitted_lobe(a.detoured, b.detoured, c.detoured, d.detoured, least);
    surface.sine_ratios =
        lq_cubic_through(a.sine_ratios, b.sine_ratios, c.sine_ratios, d.sine_ratios, least);
    surface.diffuse = lq_stack_diffuse(
        surface.stack, lq_cubic_through(a.arriving, b.arriving, c.arriving, d.arriving, least),
        returning);
    // Each in turn, so that what fits them is compiled once.
    for (int lobe = 0; lobe < 2; lobe++) {
        const LqFittedLobe light = surface.interfaces.light;
        surface.interfaces = surface.base;
        surface.base = LqSymmetricLobe(light, lq_fit_balance(surface.stack, light));
    }
    return surface;
}

#endif
