// The lobes of a stack as one viewer sees it: of the top interface, of the interfaces below it, of
// a conductor, and of a Lambertian base.
#ifndef LQ_STACK_LOBES_GLSL
#define LQ_STACK_LOBES_GLSL

#include "../core/shading.glsl"
#include "../fresnel/dielectric.glsl"
#include "../microfacet/reflection.glsl"
#include "diffuse_base.glsl"
#include "top.glsl"

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
// of the interfaces below the top one and of a conductor, whose light is the former's where
// LQ_STACK_LOBES is 2; below it, mirrored, where no base is, those of light that came straight
// through and of light that was reflected on the way.
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

LqStackLobe lq_stack_lobe_of(const vec4 energy, const float alpha, const vec3 about) {
    const float shaded = clamp(alpha, LQ_MIN_ALPHA, 1.0);
    const float single = max(lq_stack_single(min(about.z, 1.0), shaded), 0.01);
    return LqStackLobe(about, vec3(energy.x, energy.y, energy.z), 1.0 / single, shaded);
}

LqStackLobe lq_stack_no_lobe(const vec3 about) {
    return LqStackLobe(about, vec3(0.0), 1.0, 1.0);
}

// Of a conductor.
LqStackLobe lq_stack_base_lobe(const vec4 energy, const float alpha, const vec3 about) {
    if (LQ_STACK_LOBES == 2) {
        return lq_stack_no_lobe(about);
    }
    return lq_stack_lobe_of(energy, alpha, about);
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

// The lobe of light that leaves below about `cosine`, mirrored to above the surface.
LqStackLobe lq_stack_lobe_below(const vec4 energy, const float alpha, const float cosine,
                                const vec3 wo) {
    return lq_stack_lobe_of(energy, alpha,
                            lq_turned_to(wo, clamp(cosine, LQ_LEAST_COSINE, 1.0)));
}

// Light reflected by the top interface after more than one facet.
float lq_stack_top_multiple(const LqStackSurface surface, const float cos_theta) {
    return clamp(lq_direction_value(surface.multiple, surface.top_critical, cos_theta), 0.0, 1.0);
}

// f of the top interface.
float lq_stack_top(const LqStackSurface surface, const LqStackView viewer, const vec3 wi) {
    float once = lq_fresnel_dielectric(lq_cos_theta_halfway(wi, viewer.wo), surface.top_eta) *
                 lq_reflection_lobe(surface.top, wi, viewer.wo);
    for (int blended = surface.top_count > 1 ? 1 : 0; blended > 0; blended--) {
        once = lq_reflected_once(lq_stack_top_side(surface), wi, viewer.wo).x;
    }
    return once + lq_stack_top_multiple(surface, min(wi.z, 1.0)) * viewer.multiple *
                      surface.multiple_scale;
}

// f of a lobe.
vec3 lq_stack_lobe_value(const LqStackLobe lobe, const vec3 wi) {
    return lobe.energy * (lobe.scale * lq_reflection_lobe(lq_lobe_facets(lobe), wi, lobe.about));
}

// f of the interfaces below the top one and of a conductor, for wi above the surface.
vec3 lq_stack_inner_value(const LqStackView viewer, const vec3 wi) {
    const vec3 interfaces = lq_stack_lobe_value(viewer.interfaces, wi);
    if (LQ_STACK_LOBES == 2) {
        return interfaces;
    }
    return interfaces + lq_stack_lobe_value(viewer.base, wi);
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

// f of the top interface and of a Lambertian base, for wi above the surface.
vec3 lq_stack_outer_value(const LqStackSurface surface, const LqStackView viewer, const vec3 wi) {
    const vec3 top = vec3(lq_stack_top(surface, viewer, wi));
    if (surface.base != LQ_STACK_BASE_LAMBERTIAN) {
        return top;
    }
    const vec4 arriving = lq_stack_arriving(surface, viewer.diffuse.arriving, min(wi.z, 1.0));
    return top + viewer.arriving * vec3(arriving.x, arriving.y, arriving.z) * viewer.diffuse.spread;
}

// What is sent to the viewer by way of the base.
vec3 lq_stack_base_albedo(const LqStackView viewer) {
    return viewer.base.energy + viewer.arriving * viewer.diffuse.returned;
}

// What is sent to the viewer: by interfaces alone, by way of the base, and from below. A lobe that
// interfaces and a conductor share counts as the conductor's, which sends most of it.
LqAlbedo lq_stack_view_albedo(const LqStackSurface surface, const LqStackView viewer) {
    const bool is_open = surface.base == LQ_STACK_BASE_NONE;
    const vec3 below = is_open ? viewer.straight.energy + viewer.detoured.energy : vec3(0.0);
    const vec3 top = vec3(viewer.top);
    const vec3 inner = viewer.interfaces.energy;
    const vec3 by_base = lq_stack_base_albedo(viewer);
    if (LQ_STACK_LOBES == 2) {
        if (surface.base == LQ_STACK_BASE_CONDUCTOR) {
            return LqAlbedo(top, by_base + inner, below);
        }
    }
    return LqAlbedo(top + inner, by_base, below);
}

#endif
