// Which lobe of a stack a direction of light is drawn from, and with which density.
#ifndef LQ_STACK_CHOICES_GLSL
#define LQ_STACK_CHOICES_GLSL

#include "../core/sampling.glsl"
#include "../core/shading.glsl"
#include "../microfacet/reflection.glsl"
#include "lobes.glsl"

// Probabilities of lobes: of the top interface, of those below, and of a conductor and a Lambertian
// base, or without a base of the two that leave below. In proportion to their light, but each that
// has some at least with LQ_MIN_CHOICE over their number.
vec4 lq_stack_choices(const LqStackSurface surface, const LqStackView viewer) {
    const bool is_open = surface.base == LQ_STACK_BASE_NONE;
    const vec3 third = is_open ? viewer.straight.energy : viewer.base.energy;
    const vec3 fourth =
        is_open ? viewer.detoured.energy : viewer.arriving * viewer.diffuse.returned;
    const vec4 light = max(vec4(viewer.top, lq_average(viewer.interfaces.energy),
                                lq_average(third), lq_average(fourth)), vec4(0.0));
    const vec4 present = vec4(1.0) - step(light, vec4(0.0));
    const float sum = dot(light, vec4(1.0));
    if (sum <= 0.0) {
        return vec4(1.0, 0.0, 0.0, 0.0);
    }
    // Divided first: the sum may be too small for its inverse to be finite.
    return (1.0 - LQ_MIN_CHOICE) * (light / sum) +
           LQ_MIN_CHOICE / dot(present, vec4(1.0)) * present;
}

// How often a direction of the top interface's lobe is one that a facet mirrors.
float lq_stack_once_choice(const LqStackView viewer) {
    if (viewer.top <= 0.0) {
        return 1.0;
    }
    return max(1.0 - viewer.multiple / viewer.top, LQ_MIN_CHOICE);
}

float lq_stack_lobe_density(const LqStackLobe lobe, const vec3 wi) {
    return lq_reflection_pdf(lq_lobe_facets(lobe), wi, lobe.about);
}

// Density per solid angle of all lobes together. Belcour 2018, Eq. 40.
float lq_stack_density(const LqStackSurface surface, const LqStackView viewer, const vec3 wi) {
    const vec4 choices = lq_stack_choices(surface, viewer);
    const bool is_open = surface.base == LQ_STACK_BASE_NONE;
    if (!lq_is_above(wi)) {
        const vec3 mirrored = vec3(wi.x, wi.y, -wi.z);
        const float density = choices.z * lq_stack_lobe_density(viewer.straight, mirrored) +
                              choices.w * lq_stack_lobe_density(viewer.detoured, mirrored);
        return is_open && lq_is_above(mirrored) ? density : 0.0;
    }
    const float once = lq_stack_once_choice(viewer);
    const float diffuse = lq_cosine_hemisphere_pdf(wi.z);
    float mirrored_top = lq_reflection_pdf(surface.top, wi, viewer.wo);
    for (int blended = surface.top_count > 1 ? 1 : 0; blended > 0; blended--) {
        mirrored_top = 0.25 * lq_visible_density(lq_stack_top_side(surface).strata, viewer.wo,
                                                 lq_halfway(wi, viewer.wo));
    }
    const float top = once * mirrored_top + (1.0 - once) * diffuse;
    const float lobes = choices.x * top +
                        choices.y * lq_stack_lobe_density(viewer.interfaces, wi);
    if (is_open) {
        return lobes;
    }
    if (LQ_STACK_LOBES == 2) {
        return lobes + choices.w * diffuse;
    }
    return lobes + choices.z * lq_stack_lobe_density(viewer.base, wi) + choices.w * diffuse;
}

// A direction chosen by one lobe, which may have turned out to point to the other side of the
// surface: then `is_of_its_lobe` is false, and the sample has pdf 0.
struct LqStackChoice {
    vec3 wi;
    bool is_of_its_lobe;
};

// `u` in [0, 1)^3: the first chooses a lobe.
LqStackChoice lq_stack_direction(const LqStackSurface surface, const LqStackView viewer,
                                 const vec3 u) {
    const vec4 choices = lq_stack_choices(surface, viewer);
    const bool is_open = surface.base == LQ_STACK_BASE_NONE;
    const vec2 square = vec2(u.y, u.z);
    LqFacets facets = surface.top;
    vec3 about = viewer.wo;
    bool is_diffuse = false;
    float side = 1.0;
    if (u.x < choices.x) {
        is_diffuse = u.x >= choices.x * lq_stack_once_choice(viewer);
    } else if (u.x < choices.x + choices.y) {
        facets = lq_lobe_facets(viewer.interfaces);
    } else if (is_open) {
        side = -1.0;
        facets = lq_lobe_facets(viewer.straight);
        about = viewer.straight.about;
        if (u.x >= choices.x + choices.y + choices.z) {
            facets = lq_lobe_facets(viewer.detoured);
            about = viewer.detoured.about;
        }
    } else {
        is_diffuse = u.x >= choices.x + choices.y + choices.z;
        facets = lq_lobe_facets(viewer.base);
    }
    vec3 wi = lq_sample_cosine_hemisphere(square);
    if (!is_diffuse) {
        wi = lq_reflection_sample(facets, about, square);
    }
    const bool is_blended = surface.top_count > 1 && u.x < choices.x && !is_diffuse;
    for (int blended = is_blended ? 1 : 0; blended > 0; blended--) {
        const float rest = u.x / (choices.x * lq_stack_once_choice(viewer));
        const vec3 wm = lq_sample_visible_normal(lq_stack_top_side(surface).strata, viewer.wo,
                                                 vec3(min(rest, LQ_MOST_UNIFORM), u.y, u.z)).wm;
        wi = 2.0 * dot(viewer.wo, wm) * wm - viewer.wo;
    }
    return LqStackChoice(vec3(wi.x, wi.y, wi.z * side), lq_is_above(wi));
}

#endif
