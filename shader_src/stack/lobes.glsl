// The lobes of a stack as one viewer sees it: of the top interface, of the interfaces below it, of
// a conductor, and of a Lambertian base.
#ifndef LQ_STACK_LOBES_GLSL
#define LQ_STACK_LOBES_GLSL

#include "../core/sampling.glsl"
#include "../core/shading.glsl"
#include "../fresnel/dielectric.glsl"
#include "../microfacet/reflection.glsl"
#include "diffuse_base.glsl"
#include "prepare.glsl"
#include "transport.glsl"

// A GGX lobe of what mirrors would send to `about`: its light, what of single reflections is that
// light's share, and its roughness. Belcour 2018, Eq. 39.
struct LqStackLobe {
    vec3 about;
    vec3 energy;
    float scale;
    float alpha;
};

// `top` is what the top interface reflects of light from everywhere, `multiple` the part of it that
// has met more than one facet; `arriving` T of a Lambertian base. Lobes above the surface are those
// of the interfaces below the top one and of a conductor; below it, mirrored, where no base is, those
// of light that came straight through and of light that was reflected on the way.
struct LqStackView {
    vec3 wo;
    float top;
    float multiple;
    LqStackLobe interfaces;
    LqStackLobe base;
    LqStackLobe straight;
    LqStackLobe detoured;
    vec3 arriving;
    LqStackDiffuse diffuse;
};

LqFacets lq_lobe_facets(const LqStackLobe lobe) {
    return LqFacets(LQ_NDF_GGX, lobe.alpha, lobe.alpha);
}

LqStackLobe lq_stack_lobe_of(const vec4 energy, const float width, const vec3 about) {
    const float alpha = clamp(lq_safe_sqrt(width), LQ_MIN_ALPHA, 1.0);
    const float single = max(lq_stack_single(min(about.z, 1.0), alpha), 0.01);
    return LqStackLobe(about, vec3(energy.x, energy.y, energy.z), 1.0 / single, alpha);
}

// The direction of this cosine in the azimuth of w; along the normal that is x.
vec3 lq_turned_to(const vec3 w, const float cosine) {
    const float sine = lq_sine_from_cosine(cosine);
    const float length_xy = sqrt(w.x * w.x + w.y * w.y);
    if (length_xy <= 0.0) {
        return vec3(sine, 0.0, cosine);
    }
    return vec3(sine * (w.x / length_xy), sine * (w.y / length_xy), cosine);
}

// Of the light at the bottom what leaves there, all or nothing, mirrored to above the surface.
LqStackLobe lq_stack_exit_of(const LqStackSurface surface, const LqStackBeam beam,
                             const vec3 wo) {
    const float leaving = surface.base == LQ_STACK_BASE_NONE ? 1.0 : 0.0;
    return lq_stack_lobe_of((beam.interfaces + beam.base) * leaving, lq_beam_width(beam),
                            lq_turned_to(wo, clamp(beam.cosine, LQ_LEAST_COSINE, 1.0)));
}

// Light reflected by the top interface after more than one facet.
float lq_stack_top_multiple(const LqStackSurface surface, const float cos_theta) {
    return clamp(lq_direction_value(surface.multiple, surface.top_critical, cos_theta), 0.0, 1.0);
}

// For any number of lights; `wo` above the surface. All light that is followed is followed here, in
// one loop: the viewer's, and before it what a Lambertian base needs, at four directions and from
// below.
LqStackView lq_stack_view(const LqStackSurface surface, const vec3 wo) {
    const float cosine = clamp(wo.z, 0.0, 1.0);
    const bool is_lambertian = surface.base == LQ_STACK_BASE_LAMBERTIAN;
    LqStackLight light = lq_no_light();
    vec4 a = vec4(0.0);
    vec4 b = vec4(0.0);
    vec4 c = vec4(0.0);
    vec4 d = vec4(0.0);
    vec4 returning = vec4(0.0);
    for (int run = is_lambertian ? 0 : 5; run < 6; run++) {
        const float narrow = run == 0 ? LQ_CUBIC_NODES.x : LQ_CUBIC_NODES.y;
        const float wide = run == 2 ? LQ_CUBIC_NODES.z : LQ_CUBIC_NODES.w;
        const float entered = run < 2 ? narrow : wide;
        const int diffuse = run == 4 ? LQ_LIGHT_FROM_BELOW : LQ_LIGHT_ENTERED;
        light = lq_stack_light(surface, run == 5 ? LQ_LIGHT_FROM_ABOVE : diffuse,
                               run == 5 ? cosine : entered);
        if (run == 4) {
            returning = light.returning;
        } else if (run < 4) {
            a = b;
            b = c;
            c = d;
            d = light.straight.interfaces + light.detoured.interfaces;
        }
    }
    const LqStackDiffuse diffuse_base =
        lq_stack_diffuse(surface, lq_cubic_through(a, b, c, d), returning);
    const vec4 arriving = lq_stack_arriving(surface, diffuse_base.arriving, cosine);
    return LqStackView(wo, light.top, lq_stack_top_multiple(surface, cosine),
                       lq_stack_lobe_of(light.interfaces, light.interfaces_width, wo),
                       lq_stack_lobe_of(light.base, light.base_width, wo),
                       lq_stack_exit_of(surface, light.straight, wo),
                       lq_stack_exit_of(surface, light.detoured, wo),
                       vec3(arriving.x, arriving.y, arriving.z), diffuse_base);
}

// f of the top interface.
float lq_stack_top(const LqStackSurface surface, const LqStackView viewer, const vec3 wi) {
    const float once = lq_fresnel_dielectric(lq_cos_theta_halfway(wi, viewer.wo), surface.top_eta) *
                       lq_reflection_lobe(surface.top, wi, viewer.wo);
    return once + lq_stack_top_multiple(surface, min(wi.z, 1.0)) * viewer.multiple *
                      surface.multiple_scale;
}

// f of a lobe.
vec3 lq_stack_lobe_value(const LqStackLobe lobe, const vec3 wi) {
    return lobe.energy * (lobe.scale * lq_reflection_lobe(lq_lobe_facets(lobe), wi, lobe.about));
}

// f of what leaves below the surface; 0 unless wi is on that side.
vec3 lq_stack_value_below(const LqStackView viewer, const vec3 wi) {
    const vec3 mirrored = vec3(wi.x, wi.y, -wi.z);
    if (!lq_is_above(mirrored)) {
        return vec3(0.0);
    }
    return lq_stack_lobe_value(viewer.straight, mirrored) +
           lq_stack_lobe_value(viewer.detoured, mirrored);
}

// f(wi, wo) of a viewer, who is above the surface.
vec3 lq_stack_value(const LqStackSurface surface, const LqStackView viewer, const vec3 wi) {
    if (!lq_is_above(wi)) {
        return lq_stack_value_below(viewer, wi);
    }
    vec3 f = vec3(lq_stack_top(surface, viewer, wi)) + lq_stack_lobe_value(viewer.interfaces, wi) +
             lq_stack_lobe_value(viewer.base, wi);
    if (surface.base == LQ_STACK_BASE_LAMBERTIAN) {
        const vec4 arriving =
            lq_stack_arriving(surface, viewer.diffuse.arriving, min(wi.z, 1.0));
        f += viewer.arriving * vec3(arriving.x, arriving.y, arriving.z) * viewer.diffuse.spread;
    }
    return f;
}

// What is sent to the viewer by way of the base.
vec3 lq_stack_base_albedo(const LqStackView viewer) {
    return viewer.base.energy + viewer.arriving * viewer.diffuse.returned;
}

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
    const float top =
        once * lq_reflection_pdf(surface.top, wi, viewer.wo) + (1.0 - once) * diffuse;
    const float lobes = choices.x * top +
                        choices.y * lq_stack_lobe_density(viewer.interfaces, wi);
    if (is_open) {
        return lobes;
    }
    return lobes + choices.z * lq_stack_lobe_density(viewer.base, wi) + choices.w * diffuse;
}

// A direction chosen by one lobe, which may have turned out to point to the other side of the
// surface: then the lobe has none there.
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
    return LqStackChoice(vec3(wi.x, wi.y, wi.z * side), lq_is_above(wi));
}

#endif
