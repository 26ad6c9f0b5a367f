// A rough surface whose roughness or metal changes with height, with all the light that its facets
// send on: what met one facet in closed form, what met several as a diffuse lobe.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
//
// Directions may be on either side of facets that refract. f is for radiance over the square of the
// index, which refraction keeps: f(wi, wo) over the squared index on the side of wi is symmetric.
//
// What meets several facets depends on the material alone: find it out once, by `lq_several_facets`,
// and keep it with the material (kernels/several_facets_rows.glsl shows how as rows of a buffer).
#ifndef LQ_MICROSURFACE_COMPENSATED_MICROSURFACE_COMPENSATED_GLSL
#define LQ_MICROSURFACE_COMPENSATED_MICROSURFACE_COMPENSATED_GLSL

#include "../microsurface/several_facets.glsl"
#include "../microsurface_single/microsurface_single.glsl"

// `several` of the same material.
struct LqMicrosurfaceCompensatedSurface {
    LqMicrosurfaceSurface single;
    LqSeveralFacets several;
};

LqMicrosurfaceCompensatedSurface lq_microsurface_compensated_prepare(
    const LqMicrosurfaceMaterial material, const LqSeveralFacets several) {
    return LqMicrosurfaceCompensatedSurface(lq_microsurface_prepare(material), several);
}

// Of light along w, on its own side.
LqSeveralShares lq_microsurface_several_shares(const LqSeveralFacets several, const vec3 w) {
    const vec3 upright = vec3(w.x, w.y, abs(w.z));
    if (w.z < 0.0) {
        return lq_several_shares(several.turning, several.below, upright);
    }
    return lq_several_shares(several.turning, several.above, upright);
}

// f of what met several facets, without what the medium absorbs; the directions are not along the
// surface.
vec3 lq_microsurface_several(const LqSeveralFacets several, const vec3 wi, const vec3 wo) {
    const LqSeveralShares light = lq_microsurface_several_shares(several, wi);
    const LqSeveralShares viewer = lq_microsurface_several_shares(several, wo);
    if (wi.z < 0.0) {
        return wo.z < 0.0 ? lq_several_reflected(several.below, light, viewer)
                          : vec3(lq_several_let_through(several.below, light, viewer));
    }
    return wo.z < 0.0 ? vec3(lq_several_let_through(several.above, light, viewer))
                      : lq_several_reflected(several.above, light, viewer);
}

// Whether there is a surface for light along both.
bool lq_microsurface_joins(const LqMicrosurfaceSurface surface, const vec3 wi, const vec3 wo) {
    return lq_microsurface_is_met(surface, wi) && lq_microsurface_is_met(surface, wo);
}

// f(wi, wo), per steradian.
vec3 lq_microsurface_compensated_eval(const LqMicrosurfaceCompensatedSurface surface,
                                      const vec3 wi, const vec3 wo) {
    if (!lq_microsurface_joins(surface.single, wi, wo)) {
        return vec3(0.0);
    }
    const vec3 crossings = lq_microsurface_crossing(surface.single, wi) *
                           lq_microsurface_crossing(surface.single, wo);
    return lq_microsurface_single_eval(surface.single, wi, wo) +
           crossings * lq_microsurface_several(surface.several, wi, wo);
}

// f(wi, wo) |cos_theta_i|.
vec3 lq_microsurface_compensated_eval_cos(const LqMicrosurfaceCompensatedSurface surface,
                                          const vec3 wi, const vec3 wo) {
    return lq_microsurface_compensated_eval(surface, wi, wo) * abs(wi.z);
}

// Density per solid angle with which `lq_microsurface_compensated_sample` chooses wi.
float lq_microsurface_compensated_pdf(const LqMicrosurfaceCompensatedSurface surface,
                                      const vec3 wi, const vec3 wo) {
    if (!lq_microsurface_joins(surface.single, wi, wo)) {
        return 0.0;
    }
    const LqSeveralShares viewer = lq_microsurface_several_shares(surface.several, wo);
    const float reflected = lq_average(viewer.reflected);
    const float diffuse = wi.z * wo.z > 0.0 ? reflected : viewer.through;
    return (1.0 - reflected - viewer.through) *
               lq_microsurface_single_pdf(surface.single, wi, wo) +
           diffuse * abs(wi.z) * LQ_INVERSE_PI;
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// among cosine-weighted directions on either side, for what met several facets, and the first facet.
LqSample lq_microsurface_compensated_sample(const LqMicrosurfaceCompensatedSurface surface,
                                            const vec3 wo, const vec3 u) {
    if (!lq_microsurface_is_met(surface.single, wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const LqSeveralShares viewer = lq_microsurface_several_shares(surface.several, wo);
    const float reflected = lq_average(viewer.reflected);
    const float several = reflected + viewer.through;
    vec3 wi = lq_sample_cosine_hemisphere(vec2(u.y, u.z));
    bool is_lost = false;
    if (u.x < several) {
        const bool is_above = (u.x < reflected) == (wo.z > 0.0);
        wi = vec3(wi.x, wi.y, is_above ? wi.z : -wi.z);
    } else {
        const float rest =
            clamp((u.x - several) / max(1.0 - several, LQ_MIN_COSINE_PRODUCT), 0.0,
                  LQ_MOST_UNIFORM);
        const LqSample facet =
            lq_microsurface_single_sample(surface.single, wo, vec3(rest, u.y, u.z));
        wi = facet.wi;
        is_lost = facet.pdf <= 0.0;
    }
    const float pdf = is_lost ? 0.0 : lq_microsurface_compensated_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_microsurface_compensated_eval_cos(surface, wi, wo) * (1.0 / pdf), pdf);
}

// Fractions of the light from every direction that is sent to wo: by facets that refract, by a
// conductor (`base`), and from the other side. What met one facet by averaging the weights of
// `point_count` low-discrepancy samples; what met several is known, but for a medium that absorbs,
// whose part is averaged likewise.
LqAlbedo lq_microsurface_compensated_albedo(const LqMicrosurfaceCompensatedSurface surface,
                                            const vec3 wo, const int point_count) {
    const LqAlbedo single =
        lq_microsurface_single_albedo(surface.single, wo, point_count);
    if (!lq_microsurface_is_met(surface.single, wo)) {
        return single;
    }
    vec3 reflected = vec3(0.0);
    vec3 through = vec3(0.0);
    const float share = LQ_PI / float(max(point_count, 1));
    for (int several = 0; several < point_count; several++) {
        const vec3 light = lq_sample_cosine_hemisphere(lq_low_discrepancy_point(uint(several)));
        const vec3 same = vec3(light.x, light.y, wo.z < 0.0 ? -light.z : light.z);
        const vec3 other = vec3(light.x, light.y, wo.z < 0.0 ? light.z : -light.z);
        reflected += share * lq_microsurface_crossing(surface.single, same) *
                     lq_microsurface_several(surface.several, same, wo);
        through += share * lq_microsurface_crossing(surface.single, other) *
                   lq_microsurface_several(surface.several, other, wo);
    }
    const vec3 viewer = lq_microsurface_crossing(surface.single, wo);
    if (surface.single.above.eta > 0.0) {
        return LqAlbedo(single.direct + viewer * reflected, vec3(0.0),
                        single.transmitted + viewer * through);
    }
    return LqAlbedo(vec3(0.0), single.base + reflected, vec3(0.0));
}

#endif
