// A rough surface whose roughness or metal changes with height, with light of all orders: what meets
// one facet in closed form, what meets more estimated by random walks. The mean over seeds is the
// BSDF of Smith's theory.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields;
//           Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
//
// Directions and f as in microsurface_single.glsl. The same seed gives the same value: take another
// for every sample.
#ifndef LQ_MICROSURFACE_STOCHASTIC_MICROSURFACE_STOCHASTIC_GLSL
#define LQ_MICROSURFACE_STOCHASTIC_MICROSURFACE_STOCHASTIC_GLSL

#include "../microsurface_single/microsurface_single.glsl"
#include "facet_walk.glsl"

// Facets after which a walk goes on by chance alone (Russian roulette), which keeps the mean, with at
// most LQ_MOST_SURVIVAL each time.
const int LQ_CERTAIN_FACETS = 8;
const float LQ_MOST_SURVIVAL = 0.9;

// Facets that one walk may meet: of 10^11 walks, one meets more and loses the rest of its light.
const int LQ_MAX_STOCHASTIC_FACETS = 256;

// The share of samples chosen evenly over all that light leaves to, for what met several facets.
const float LQ_EVEN_CHOICE = 0.2;

// What random numbers are for: the third word of their counter.
const uint LQ_WALK_FROM_VIEWER = 0u;
const uint LQ_WALK_FROM_LIGHT = 1u;
const uint LQ_WALK_OF_ALBEDO = 2u;

// One end of a path: above one of two sides, and what the density of light that leaves along it is
// multiplied by to be f.
struct LqPathEnd {
    vec3 w;
    bool crossed;
    float scale;
};

LqTwoSides lq_microsurface_two_sides(const LqMicrosurfaceSurface surface, const vec3 wo) {
    if (surface.above.eta <= 0.0) {
        return LqTwoSides(surface.above, surface.above);
    }
    const LqRoughSide below = lq_rough_side_turned_over(surface.above);
    if (wo.z < 0.0) {
        return LqTwoSides(below, surface.above);
    }
    return LqTwoSides(surface.above, below);
}

// The weight of a ray that met so many facets; not inside where it ends, as u in [0, 1) decides.
LqFacetRay lq_ray_surviving(const LqFacetRay ray, const int facets, const float u) {
    const float most = max(ray.weight.x, max(ray.weight.y, ray.weight.z));
    LqFacetRay rest = ray;
    rest.is_inside = most > 0.0;
    if (facets >= LQ_CERTAIN_FACETS) {
        const float survival = min(most, LQ_MOST_SURVIVAL);
        rest.is_inside = u < survival;
        rest.weight = ray.weight * (1.0 / max(survival, LQ_MIN_COSINE_PRODUCT));
    }
    return rest;
}

// a b / (a + b), which the smaller bounds.
float lq_balanced(const float a, const float b) {
    const float least = min(min(a, b), LQ_MAX_CONNECTION);
    const float most = max(max(a, b), LQ_MIN_COSINE_PRODUCT);
    return least / (1.0 + least / most);
}

// One walk from `start`: f of the light that leaves to `end` from its second facet on. A path is
// counted as often as this walk finds it among those from both ends: in proportion to its density,
// which is f over what connects the last facet to the end (the balance heuristic: Veach and Guibas
// 1995, Optimally Combining Sampling Techniques for Monte Carlo Rendering). Both walks therefore
// give a path the same value, a b / (a + b), with the connections a and b of its ends.
vec3 lq_walked(const LqTwoSides sides, const LqPathEnd start, const LqPathEnd end, const uint seed,
               const uint purpose) {
    LqFacetRay ray = lq_entering_ray(start.w, start.crossed);
    vec3 sum = vec3(0.0);
    float back = 0.0;
    for (int facet = 1; facet <= LQ_MAX_STOCHASTIC_FACETS; facet++) {
        const uint draw = 2u * uint(facet - 1);
        const vec4 u = lq_random_uniforms(uvec4(seed, 0u, purpose, draw));
        const vec4 v = lq_random_uniforms(uvec4(seed, 0u, purpose, draw + 1u));
        ray = lq_fly(sides, ray, u.x, v.x);
        if (!ray.is_inside) {
            break;
        }
        if (facet > 1) {
            const LqConnection onwards = lq_connection(sides, ray, end.w, end.crossed);
            sum += ray.weight * onwards.reflectance *
                   lq_balanced(onwards.density * end.scale, back);
        }
        ray = lq_turn(sides, ray, vec3(u.y, u.z, u.w));
        if (facet == 1) {
            LqFacetRay backwards = ray;
            backwards.w = -ray.w;
            const LqConnection first = lq_connection(sides, backwards, start.w, start.crossed);
            back = first.density * start.scale;
        }
        ray = lq_ray_surviving(ray, facet, v.y);
        if (!ray.is_inside) {
            break;
        }
    }
    return sum;
}

// f of light that met several facets, without what the medium takes.
vec3 lq_reflected_often(const LqMicrosurfaceSurface surface, const vec3 wi, const vec3 wo,
                        const uint seed) {
    const LqTwoSides sides = lq_microsurface_two_sides(surface, wo);
    const bool through = (wi.z < 0.0) != (wo.z < 0.0);
    const float index = through ? sides.first.eta : 1.0;
    const LqPathEnd viewer =
        LqPathEnd(vec3(wo.x, wo.y, abs(wo.z)), false,
                  index * index / max(abs(wo.z), LQ_MIN_RAY_COSINE));
    const LqPathEnd light = LqPathEnd(vec3(wi.x, wi.y, abs(wi.z)), through,
                                      1.0 / max(abs(wi.z), LQ_MIN_RAY_COSINE));
    return lq_walked(sides, viewer, light, seed, LQ_WALK_FROM_VIEWER) +
           lq_walked(sides, light, viewer, seed, LQ_WALK_FROM_LIGHT);
}

// An estimate of f(wi, wo), per steradian.
vec3 lq_microsurface_stochastic_eval(const LqMicrosurfaceSurface surface, const vec3 wi,
                                     const vec3 wo, const uint seed) {
    if (!lq_microsurface_is_met(surface, wo)) {
        return vec3(0.0);
    }
    if (!lq_microsurface_is_met(surface, wi)) {
        return vec3(0.0);
    }
    const vec3 crossings =
        lq_microsurface_crossing(surface, wi) * lq_microsurface_crossing(surface, wo);
    return lq_microsurface_single_eval(surface, wi, wo) +
           crossings * lq_reflected_often(surface, wi, wo, seed);
}

// An estimate of f(wi, wo) |cos_theta_i|.
vec3 lq_microsurface_stochastic_eval_cos(const LqMicrosurfaceSurface surface, const vec3 wi,
                                         const vec3 wo, const uint seed) {
    return lq_microsurface_stochastic_eval(surface, wi, wo, seed) * abs(wi.z);
}

// Density per solid angle with which `lq_microsurface_stochastic_sample` chooses wi: not random, and
// above 0 wherever f is.
float lq_microsurface_stochastic_pdf(const LqMicrosurfaceSurface surface, const vec3 wi,
                                     const vec3 wo) {
    if (!lq_microsurface_is_met(surface, wo)) {
        return 0.0;
    }
    if (!lq_microsurface_is_met(surface, wi)) {
        return 0.0;
    }
    const float hemispheres = surface.above.eta > 0.0 ? 2.0 : 1.0;
    return (1.0 - LQ_EVEN_CHOICE) * lq_microsurface_single_pdf(surface, wi, wo) +
           LQ_EVEN_CHOICE * LQ_INVERSE_PI * abs(wi.z) / hemispheres;
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1), weighted by the
// estimate of that seed.
LqSample lq_microsurface_stochastic_sample(const LqMicrosurfaceSurface surface, const vec3 wo,
                                           const vec3 u, const uint seed) {
    if (!lq_microsurface_is_met(surface, wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    vec3 wi = vec3(0.0, 0.0, 1.0);
    if (u.x < LQ_EVEN_CHOICE) {
        const bool through = surface.above.eta > 0.0 && u.x >= 0.5 * LQ_EVEN_CHOICE;
        const vec3 even = lq_sample_cosine_hemisphere(vec2(u.y, u.z));
        wi = vec3(even.x, even.y, (wo.z < 0.0) != through ? -even.z : even.z);
    } else {
        const float rest = (u.x - LQ_EVEN_CHOICE) / (1.0 - LQ_EVEN_CHOICE);
        const LqSample facet = lq_microsurface_single_sample(
            surface, wo, vec3(clamp(rest, 0.0, LQ_MOST_UNIFORM), u.y, u.z));
        wi = facet.wi;
        if (facet.pdf <= 0.0) {
            return LqSample(wi, vec3(0.0), 0.0);
        }
    }
    const float pdf = lq_microsurface_stochastic_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi,
                    lq_microsurface_stochastic_eval_cos(surface, wi, wo, seed) * (1.0 / pdf), pdf);
}

// What one walk adds to the albedo: light that leaves after several facets.
LqAlbedo lq_walked_albedo(const LqMicrosurfaceSurface surface, const vec3 wo, const uint seed,
                          const uint walk) {
    const LqTwoSides sides = lq_microsurface_two_sides(surface, wo);
    LqFacetRay ray = lq_entering_ray(vec3(wo.x, wo.y, abs(wo.z)), false);
    int met = 0;
    for (int facet = 1; facet <= LQ_MAX_STOCHASTIC_FACETS; facet++) {
        const uint draw = 2u * uint(facet - 1);
        const vec4 u = lq_random_uniforms(uvec4(seed, walk, LQ_WALK_OF_ALBEDO, draw));
        const vec4 v = lq_random_uniforms(uvec4(seed, walk, LQ_WALK_OF_ALBEDO, draw + 1u));
        ray = lq_fly(sides, ray, u.x, v.x);
        if (!ray.is_inside) {
            break;
        }
        met = facet;
        ray = lq_turn(sides, ray, vec3(u.y, u.z, u.w));
        ray = lq_ray_surviving(ray, facet, v.y);
        if (!ray.is_inside) {
            return lq_no_albedo();
        }
    }
    if (met < 2 || ray.is_inside) {
        return lq_no_albedo();
    }
    const bool below = (wo.z < 0.0) != ray.crossed;
    const vec3 exit = vec3(ray.w.x, ray.w.y, below ? -ray.w.z : ray.w.z);
    const vec3 light = ray.weight * lq_microsurface_crossing(surface, wo) *
                       lq_microsurface_crossing(surface, exit);
    if (ray.crossed) {
        return LqAlbedo(vec3(0.0), vec3(0.0), light);
    }
    if (surface.above.eta > 0.0) {
        return LqAlbedo(light, vec3(0.0), vec3(0.0));
    }
    return LqAlbedo(vec3(0.0), light, vec3(0.0));
}

// As `lq_microsurface_single_albedo`; of light that met several facets, the mean of `point_count`
// walks.
LqAlbedo lq_microsurface_stochastic_albedo(const LqMicrosurfaceSurface surface, const vec3 wo,
                                           const int point_count, const uint seed) {
    LqAlbedo sum = lq_microsurface_single_albedo(surface, wo, point_count);
    if (!lq_microsurface_is_met(surface, wo)) {
        return sum;
    }
    const float share = 1.0 / float(max(point_count, 1));
    for (int index = 0; index < point_count; index++) {
        const LqAlbedo walked = lq_walked_albedo(surface, wo, seed, uint(index));
        sum.direct += share * walked.direct;
        sum.base += share * walked.base;
        sum.transmitted += share * walked.transmitted;
    }
    return sum;
}

#endif
