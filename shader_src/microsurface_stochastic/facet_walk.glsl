// A ray of light among the facets of a surface of several strata: its flights between them and what
// each makes of it, all orders of scattering.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model;
//           d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
//
// A ray is in the frame of the side of the surface where it is: upwards it may leave. Depth is
// -log C, C the fraction of the surface below it: a ray then meets facets of a stratum at a constant
// rate, Lambda upwards and 1 + Lambda downwards.
#ifndef LQ_MICROSURFACE_STOCHASTIC_FACET_WALK_GLSL
#define LQ_MICROSURFACE_STOCHASTIC_FACET_WALK_GLSL

#include "../core/random.glsl"
#include "../microsurface/single_scattering.glsl"
#include "../microsurface/walk.glsl"

// Cosine of a ray along the surface, whose Lambda would be infinite.
const float LQ_MIN_RAY_COSINE = 1.0e-12;

// The lowest facets, deeper than any ray gets.
const float LQ_GREATEST_DEPTH = 1.0e30;

// Below 2^-10 lq_log_share has no digits; 2^12 times as much is where it has.
const float LQ_SMALL_SHARE = 0.0009765625;
const float LQ_SHARE_STEP = 4096.0;
const float LQ_LOG_SHARE_STEP = 8.31776616671934;

// Keeps f finite along the surface, where light of one direction fills no area.
const float LQ_MAX_CONNECTION = 1.0e20;

// Both sides of a surface, that of the viewer first; of a conductor the other is not used.
struct LqTwoSides {
    LqRoughSide first;
    LqRoughSide other;
};

// Light travelling along `w` (unit); `crossed`: on the other side; `stratum`, counted from the top
// of its side, of the facet that it met last. `weight`: what conductors leave of it. `is_inside`:
// it met another facet and did not leave.
struct LqFacetRay {
    vec3 w;
    float depth;
    bool crossed;
    int stratum;
    vec3 weight;
    bool is_inside;
};

// Towards one direction out of the surface: the density per solid angle with which a facet sends
// light there and it leaves, without what a conductor takes; and what that leaves.
struct LqConnection {
    float density;
    vec3 reflectance;
};

LqRoughSide lq_side_of_two(const LqTwoSides sides, const bool crossed) {
    if (crossed) {
        return sides.other;
    }
    return sides.first;
}

// A ray from w, above its side, that enters the surface.
LqFacetRay lq_entering_ray(const vec3 w, const bool crossed) {
    return LqFacetRay(vec3(-w.x, -w.y, -w.z), 0.0, crossed, 0, vec3(1.0), true);
}

// -log(1 - u), of u in [0, 1) in steps of 2^-24: the optical thickness that a ray passes.
float lq_random_thickness(const float u) {
    const float share = 1.0 - u;
    if (share < LQ_SMALL_SHARE) {
        return LQ_LOG_SHARE_STEP - lq_log_share(share * LQ_SHARE_STEP);
    }
    return -lq_log_share(share);
}

// w or its mirror image, whichever is above the surface.
vec3 lq_upper(const vec3 w) {
    return vec3(w.x, w.y, max(abs(w.z), LQ_MIN_RAY_COSINE));
}

float lq_ray_lambda(const LqFacets facets, const vec3 w) {
    const vec3 up = lq_upper(w);
    return lq_facets_projected_lambda(facets, up) / up.z;
}

// Area of the facets that face v, per unit of macroscopic area: v may be below the surface.
float lq_facing_area(const LqFacets facets, const vec3 v) {
    const vec3 up = lq_upper(v);
    return lq_facets_projected_lambda(facets, up) + (v.z < 0.0 ? 0.0 : up.z);
}

// Depth of the upper end of the n-th stratum.
float lq_stratum_ceiling(const LqStrata strata, const int n) {
    float depth = 0.0;
    for (int above = 0; above < n; above++) {
        const LqPlacedStratum passed = lq_stratum_at(strata, above);
        depth -= passed.log_up;
    }
    return depth;
}

// Depth of its lower end.
float lq_stratum_floor(const LqStrata strata, const int n) {
    if (n + 1 >= strata.count) {
        return LQ_GREATEST_DEPTH;
    }
    return lq_stratum_ceiling(strata, n + 1);
}

// Of a symmetric blend: by the area that each population shows to v; u in [0, 1).
int lq_facing_stratum(const LqStrata strata, const vec3 v, const float u) {
    float whole = 0.0;
    for (int shown = 0; shown < strata.count; shown++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, shown);
        whole += (stratum.high - stratum.low) * lq_facing_area(stratum.facets, v);
    }
    float before = 0.0;
    for (int chosen = 0; chosen + 1 < strata.count; chosen++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, chosen);
        before += (stratum.high - stratum.low) * lq_facing_area(stratum.facets, v);
        if (u * whole < before) {
            return chosen;
        }
    }
    return strata.count - 1;
}

LqFacetRay lq_fly_mixed(const LqStrata strata, const LqFacetRay ray, const float thickness,
                        const float u) {
    const vec3 up = lq_upper(ray.w);
    const float lambda = lq_mixed_projected_lambda(strata, up) / up.z;
    LqFacetRay flown = ray;
    if (ray.w.z < 0.0) {
        flown.depth = ray.depth + thickness / (1.0 + lambda);
    } else {
        flown.is_inside = thickness < lambda * ray.depth;
        flown.depth = max(ray.depth - thickness / max(lambda, LQ_MIN_COSINE_PRODUCT), 0.0);
    }
    flown.stratum = lq_facing_stratum(strata, -ray.w, u);
    return flown;
}

LqFacetRay lq_fly_down(const LqStrata strata, const LqFacetRay ray, const float thickness) {
    LqFacetRay flown = ray;
    float rest = thickness;
    for (int reached = 0; reached < strata.count; reached++) {
        const float low_end = lq_stratum_floor(strata, reached);
        if (flown.depth <= low_end) {
            const LqPlacedStratum stratum = lq_stratum_at(strata, reached);
            const float rate = 1.0 + lq_ray_lambda(stratum.facets, ray.w);
            const float whole = rate * (low_end - flown.depth);
            flown.stratum = reached;
            if (rest < whole) {
                flown.depth += rest / rate;
                return flown;
            }
            rest -= whole;
            flown.depth = low_end;
        }
    }
    return flown;
}

LqFacetRay lq_fly_up(const LqStrata strata, const LqFacetRay ray, const float thickness) {
    LqFacetRay flown = ray;
    float rest = thickness;
    for (int passed = strata.count - 1; passed >= 0; passed--) {
        const float high_end = lq_stratum_ceiling(strata, passed);
        if (flown.depth > high_end) {
            const LqPlacedStratum stratum = lq_stratum_at(strata, passed);
            const float rate = lq_ray_lambda(stratum.facets, ray.w);
            const float whole = rate * (flown.depth - high_end);
            if (rest < whole) {
                flown.stratum = passed;
                flown.depth = max(flown.depth - rest / rate, high_end);
                return flown;
            }
            rest -= whole;
            flown.depth = high_end;
        }
    }
    flown.is_inside = false;
    return flown;
}

// Flies to the next facet or out of the surface. u is for the distance, `choice` for the stratum of
// a symmetric blend, both in [0, 1).
LqFacetRay lq_fly(const LqTwoSides sides, const LqFacetRay ray, const float u, const float choice) {
    const LqRoughSide side = lq_side_of_two(sides, ray.crossed);
    const float thickness = lq_random_thickness(u);
    if (side.strata.blend == LQ_BLEND_SYMMETRIC) {
        return lq_fly_mixed(side.strata, ray, thickness, choice);
    }
    if (ray.w.z < 0.0) {
        return lq_fly_down(side.strata, ray, thickness);
    }
    return lq_fly_up(side.strata, ray, thickness);
}

// The chance to leave along w, above the surface, from a depth.
float lq_escape(const LqStrata strata, const vec3 w, const float depth) {
    const vec3 up = lq_upper(w);
    if (strata.blend == LQ_BLEND_SYMMETRIC) {
        return exp(-depth * lq_mixed_projected_lambda(strata, up) / up.z);
    }
    float thickness = 0.0;
    for (int above = 0; above < strata.count; above++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, above);
        const float crossed =
            min(depth, lq_stratum_floor(strata, above)) - lq_stratum_ceiling(strata, above);
        thickness += max(crossed, 0.0) * lq_ray_lambda(stratum.facets, up);
    }
    return exp(-thickness);
}

// A ray that was refracted, in the frame of its new side.
LqFacetRay lq_ray_turned_over(const LqStrata strata, const LqFacetRay ray, const vec3 refracted) {
    return LqFacetRay(vec3(refracted.x, refracted.y, -refracted.z),
                      lq_walk_turned_depth(ray.depth), !ray.crossed,
                      strata.count - 1 - ray.stratum, ray.weight, ray.is_inside);
}

// Turns a ray at the facet it met by one of its visible normals, from (u.x, u.y), reflected or, as
// u.z chooses by Fresnel's reflectance, refracted.
LqFacetRay lq_turn(const LqTwoSides sides, const LqFacetRay ray, const vec3 u) {
    const LqRoughSide side = lq_side_of_two(sides, ray.crossed);
    const LqPlacedStratum stratum = lq_stratum_at(side.strata, ray.stratum);
    const vec3 v = -ray.w;
    const vec3 wm = lq_facets_sample_visible_normal(stratum.facets, v, vec2(u.x, u.y));
    const float cos_theta = clamp(dot(v, wm), 0.0, 1.0);
    if (side.eta > 0.0) {
        if (u.z >= lq_fresnel_dielectric(cos_theta, side.eta)) {
            return lq_ray_turned_over(side.strata, ray,
                                      normalize(lq_refracted(v, wm, side.eta)));
        }
    }
    LqFacetRay mirrored = ray;
    mirrored.w = normalize(wm * (2.0 * cos_theta) - v);
    if (side.eta <= 0.0) {
        mirrored.weight =
            ray.weight * lq_fresnel_conductor_rgb(cos_theta, stratum.eta, stratum.kappa);
    }
    return mirrored;
}

LqConnection lq_no_connection() {
    return LqConnection(0.0, vec3(0.0));
}

// Towards w, above the side that `crossed` tells, from the facet that a ray met.
LqConnection lq_connection(const LqTwoSides sides, const LqFacetRay ray, const vec3 w,
                           const bool crossed) {
    const LqRoughSide side = lq_side_of_two(sides, ray.crossed);
    const LqPlacedStratum stratum = lq_stratum_at(side.strata, ray.stratum);
    const vec3 v = -ray.w;
    const float area = lq_facing_area(stratum.facets, v);
    if (area <= LQ_MIN_COSINE_PRODUCT) {
        return lq_no_connection();
    }
    if (crossed == ray.crossed) {
        const vec3 wm = lq_halfway(v, w);
        const float cos_theta = min(dot(v, wm), 1.0);
        if (min(wm.z, cos_theta) <= 0.0) {
            return lq_no_connection();
        }
        const float density = 0.25 * lq_escape(side.strata, w, ray.depth) *
                              lq_facets_density(stratum.facets, wm) / area;
        if (side.eta > 0.0) {
            return LqConnection(density * lq_fresnel_dielectric(cos_theta, side.eta), vec3(1.0));
        }
        return LqConnection(density,
                            lq_fresnel_conductor_rgb(cos_theta, stratum.eta, stratum.kappa));
    }
    const LqRefraction refraction = lq_refraction(vec3(w.x, w.y, -w.z), v, side.eta);
    if (refraction.cos_theta <= 0.0) {
        return lq_no_connection();
    }
    const LqRoughSide beyond = lq_side_of_two(sides, crossed);
    const float leaving = lq_escape(beyond.strata, w, lq_walk_turned_depth(ray.depth));
    return LqConnection(leaving * lq_transmittance_dielectric(refraction.cos_theta, side.eta) *
                            lq_facets_density(stratum.facets, refraction.wm) *
                            (refraction.cos_theta / area) * refraction.jacobian,
                        vec3(1.0));
}

#endif
