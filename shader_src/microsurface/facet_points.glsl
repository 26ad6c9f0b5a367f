// A few of the facets that a direction sees, weighted so that sums over them are integrals over all.
//
// The direction w is above the surface and in its xz or yz plane, about which facets are symmetric:
// only one half of them is looked at, along rays of slopes. Slopes are in units of alpha: tan(x), and
// `height` is tan(x / 2), of which GGX is a rational function; at height 1 facets are vertical.
#ifndef LQ_MICROSURFACE_FACET_POINTS_GLSL
#define LQ_MICROSURFACE_FACET_POINTS_GLSL

#include "../core/math.glsl"
#include "../microfacet/facets.glsl"

// Rays, four in each quarter of the azimuths; and where azimuths end at the critical angle.
const int LQ_FACET_RAYS = 8;
const int LQ_CONE_RAYS = 4;
const int LQ_FACET_HEIGHTS = 6;

// Above the facets that mirror to the horizon.
const int LQ_STEEP_HEIGHTS = 2;

// Beyond, at a slope of 2.9 alpha, Beckmann's distribution has nothing left that counts.
const float LQ_BECKMANN_HEIGHT = 0.71;

// A facet, and its part of the integral over wm of D(wm) dot(w, wm) / cos_theta.
struct LqFacetPoint {
    vec3 wm;
    float cos_theta;
    float weight;
};

// Slopes along one azimuth: `unit` that of steepness 1, `along` the cosine between its azimuth and
// w, `weight` its part of the azimuths.
struct LqSlopeRay {
    vec2 unit;
    float stretch;
    float along;
    float weight;
};

// Offset from the middle of [-1, 1] and weight of a point of Gauss and Legendre's rule.
vec2 lq_gauss_two(const int n) {
    return vec2(n == 0 ? -0.577350269189626 : 0.577350269189626, 1.0);
}

vec2 lq_gauss_four(const int n) {
    const float sense = n < 2 ? -1.0 : 1.0;
    if (n == 0 || n == 3) {
        return vec2(sense * 0.861136311594053, 0.347854845137454);
    }
    return vec2(sense * 0.339981043584856, 0.652145154862546);
}

vec2 lq_gauss_six(const int n) {
    const float sense = n < 3 ? -1.0 : 1.0;
    if (n == 0 || n == 5) {
        return vec2(sense * 0.932469514203152, 0.17132449237917);
    }
    if (n == 1 || n == 4) {
        return vec2(sense * 0.661209386466265, 0.360761573048139);
    }
    return vec2(sense * 0.238619186083197, 0.467913934572691);
}

float lq_facet_height(const float steepness) {
    return steepness / (1.0 + sqrt(1.0 + steepness * steepness));
}

// `cosine` and `sine` of the stretched azimuth, from that of w.
LqSlopeRay lq_slope_ray_at(const LqFacets facets, const vec3 w, const float cosine,
                           const float sine, const float weight) {
    const bool is_x = abs(w.y) <= abs(w.x);
    const vec2 unit = vec2(facets.alpha_x * (is_x ? cosine : sine),
                           facets.alpha_y * (is_x ? sine : cosine));
    const float stretch = sqrt(unit.x * unit.x + unit.y * unit.y);
    return LqSlopeRay(unit, stretch, (unit.x * w.x + unit.y * w.y) / stretch, weight);
}

// (cos, sin) of point n of that rule over a quarter of the azimuths.
vec2 lq_quarter_azimuth(const int n) {
    if (n == 0) {
        return vec2(0.994058492765765, 0.108847200057032);
    }
    if (n == 1) {
        return vec2(0.86862413778796, 0.495471600853291);
    }
    if (n == 2) {
        return vec2(0.495471600853291, 0.86862413778796);
    }
    return vec2(0.108847200057032, 0.994058492765765);
}

// One of LQ_FACET_RAYS over all azimuths.
LqSlopeRay lq_slope_ray(const LqFacets facets, const vec3 w, const int n) {
    const bool is_back = n > 3;
    const int nth = is_back ? n - 4 : n;
    const vec2 azimuth = lq_quarter_azimuth(nth);
    return lq_slope_ray_at(facets, w, is_back ? -azimuth.x : azimuth.x, azimuth.y,
                           0.5 * LQ_PI * lq_gauss_four(nth).y);
}

// Height of facets that mirror w to the horizon.
float lq_horizon_height(const LqSlopeRay ray, const vec3 w) {
    const float root = sqrt(ray.along * ray.along + w.z * w.z);
    const float slope = ray.along > 0.0 ? (ray.along + root) / w.z : w.z / (root - ray.along);
    return lq_facet_height(slope / ray.stretch);
}

// Height of facets that w grazes.
float lq_grazed_height(const LqSlopeRay ray, const vec3 w) {
    if (ray.along >= 0.0) {
        return 1.0;
    }
    return lq_facet_height(w.z / (-ray.along * ray.stretch));
}

float lq_highest(const LqFacets facets, const float height) {
    return facets.ndf == LQ_NDF_BECKMANN ? min(height, LQ_BECKMANN_HEIGHT) : height;
}

// The facet at a point of a rule from one height to another; weight 0 where there is none.
LqFacetPoint lq_facet_point(const LqFacets facets, const vec3 w, const LqSlopeRay ray,
                            const float low, const float high, const vec2 rule) {
    const float half_range = 0.5 * max(lq_highest(facets, high) - low, 0.0);
    const float y = low + half_range * (1.0 + rule.x);
    const float flatness = max((1.0 - y) * (1.0 + y), 1.0e-12);
    const float steepness = 2.0 * y / flatness;
    const float roundness = 1.0 + y * y;
    // slope_density(steepness) steepness d steepness / d y
    float density = LQ_INVERSE_PI * 4.0 * y * flatness / (roundness * roundness * roundness);
    if (facets.ndf == LQ_NDF_BECKMANN) {
        density = LQ_INVERSE_PI * exp(-steepness * steepness) * 2.0 * steepness * roundness /
                  (flatness * flatness);
    }
    const vec3 slope = vec3(steepness * ray.unit.x, steepness * ray.unit.y, 1.0);
    const float facing = dot(w, slope);
    if (facing <= 0.0) {
        return LqFacetPoint(vec3(0.0, 0.0, 1.0), 0.0, 0.0);
    }
    const float scale = 1.0 / sqrt(dot(slope, slope));
    return LqFacetPoint(slope * scale, facing * scale,
                        rule.y * half_range * ray.weight * density * facing / w.z);
}

// The point `n` among those of facets that mirror w to above the surface; of LQ_FACET_HEIGHTS.
LqFacetPoint lq_facet_point_mirroring_up(const LqFacets facets, const vec3 w, const LqSlopeRay ray,
                                         const int n) {
    return lq_facet_point(facets, w, ray, 0.0, lq_horizon_height(ray, w), lq_gauss_six(n));
}

// Of those that mirror it down, to other facets; of LQ_STEEP_HEIGHTS.
LqFacetPoint lq_facet_point_mirroring_down(const LqFacets facets, const vec3 w,
                                           const LqSlopeRay ray, const int n) {
    return lq_facet_point(facets, w, ray, lq_horizon_height(ray, w), lq_grazed_height(ray, w),
                          lq_gauss_two(n));
}

// How many rays there are over the azimuths of facets that w meets below the critical angle.
int lq_rays_within(const vec3 w, const float critical_cosine) {
    return w.z >= critical_cosine ? LQ_FACET_RAYS : LQ_CONE_RAYS;
}

LqSlopeRay lq_slope_ray_within(const LqFacets facets, const vec3 w, const float critical_cosine,
                               const int n) {
    if (w.z >= critical_cosine) {
        return lq_slope_ray(facets, w, n);
    }
    // Azimuths within the cone have a cosine to w of at least `least`, to the side of w alone.
    const float least = lq_safe_sqrt((critical_cosine - w.z) * (critical_cosine + w.z));
    const float most = sqrt(w.x * w.x + w.y * w.y);
    const bool is_x = abs(w.y) <= abs(w.x);
    const float own = is_x ? facets.alpha_x : facets.alpha_y;
    const float other = is_x ? facets.alpha_y : facets.alpha_x;
    // tan^2 of the stretched azimuth where the cone ends; then the tangent of its half.
    const float square = max(most - least, 0.0) * (most + least) * own * own /
                         max(least * least * other * other, LQ_MIN_COSINE_PRODUCT);
    const float root = sqrt(1.0 + square);
    const float last = sqrt(square) / (1.0 + root);
    const vec2 rule = lq_gauss_four(n);
    const float t = 0.5 * last * (1.0 + rule.x);
    const float whole = 1.0 + t * t;
    return lq_slope_ray_at(facets, w, (1.0 - t) * (1.0 + t) / whole, 2.0 * t / whole,
                           2.0 * rule.y * last / whole);
}

// Of the facets on a ray within that cone, the point `n` of LQ_FACET_HEIGHTS.
LqFacetPoint lq_facet_point_within(const LqFacets facets, const vec3 w, const LqSlopeRay ray,
                                   const float critical_cosine, const int n) {
    const float beyond = lq_safe_sqrt(ray.along * ray.along + w.z * w.z -
                                      critical_cosine * critical_cosine);
    const float above = ray.along * critical_cosine - w.z * beyond;
    const float steep = ray.along * critical_cosine + w.z * beyond;
    const float across = w.z * critical_cosine - ray.along * beyond;
    float low = 0.0;
    if (above > 0.0) {
        low = lq_facet_height(above / (w.z * critical_cosine + ray.along * beyond) / ray.stretch);
    }
    float high = 1.0;
    if (across > 0.0) {
        high = lq_facet_height(steep / across / ray.stretch);
    }
    return lq_facet_point(facets, w, ray, low, high, lq_gauss_six(n));
}

#endif
