// Light that meets more than one facet of a rough surface. How much that is follows from what the
// first facets leave over; where it goes is taken as diffuse, with m(w) the part of the directional
// albedo that met several facets:
//     f = m(wi) m(wo) / (pi m_average),
// which is reciprocal. What facets let through is a part of m that depends on the cosine, chosen so
// that it is reciprocal too.
// Based on: Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks (the lobe)
#ifndef LQ_MICROSURFACE_SEVERAL_FACETS_GLSL
#define LQ_MICROSURFACE_SEVERAL_FACETS_GLSL

#include "albedo_fit.glsl"
#include "left_over.glsl"
#include "rough_surface.glsl"

// Averages below this are nothing: m is then next to 0 but near grazing, where its polynomial has few
// nodes, and would be divided by what rounding leaves of it elsewhere.
const float LQ_LEAST_SEVERAL_AVERAGE = 3.0e-4;

// Keeps quotients of averages finite.
const float LQ_LEAST_QUOTIENT = 1.0e-9;

// A ray that has met a second facet leaves with the probability 1 minus these times what the first
// left over, of its direction and on average: fitted to walks over random conductors.
const float LQ_KEPT_BY_DIRECTION = 0.4;
const float LQ_KEPT_ON_AVERAGE = 0.3;

// The second facet reflects half like the first facets of this direction, which may be of another
// metal than most, and half like those of all directions: fitted likewise.
const float LQ_LIKE_THE_FIRST = 0.5;

// m of GGX facets turns between the planes of x and y as roughnesses would whose squared ratio is
// this much closer to 0: fitted to the closed form of light that met one facet.
const float LQ_GGX_TURNING = 0.36;

// A quarter of the mean reflectance is what is reflected of light that met several facets from the
// side of the lower index, fitted to walks over random interfaces: most of it met two, and is let
// through by the one or the other.
const float LQ_REFLECTED_AGAIN = 0.25;

// How m turns between the planes: which roughness is the greater, what the square of the lesser is
// to its square, and the Beckmann facets' share of the surface.
struct LqTurning {
    bool is_rougher_along_x;
    float alpha_squared_ratio;
    float beckmann_share;
};

// Of light from one side: m in two planes, of which the part let through is `through_at_grazing` and
// `through_slope` more per cosine; and both parts averaged over cosine-weighted directions.
struct LqSeveralFacetsSide {
    LqAlbedoFit in_xz;
    LqAlbedoFit in_yz;
    float through_at_grazing;
    float through_slope;
    vec3 average_reflected;
    float average_through;
};

// `below` of facets that refract.
struct LqSeveralFacets {
    LqTurning turning;
    LqSeveralFacetsSide above;
    LqSeveralFacetsSide below;
};

// Reflected, and let through, of light along some direction.
struct LqSeveralShares {
    vec3 reflected;
    float through;
};

// How many times less the plane of the lesser roughness counts at 45 degrees than the other.
float lq_turned(const LqTurning turning, const float cos_theta) {
    const float cosine = cos_theta * cos_theta;
    const float scale = LQ_GGX_TURNING + (1.0 - LQ_GGX_TURNING) * turning.beckmann_share;
    const float square = cosine + (1.0 - cosine) * scale * turning.alpha_squared_ratio;
    return sqrt(square) * (1.0 - turning.beckmann_share) + square * turning.beckmann_share;
}

// What the plane of x counts for at w.
float lq_share_of_xz(const LqTurning turning, const vec3 w) {
    const float lesser = lq_turned(turning, w.z);
    const float x = w.x * w.x * (turning.is_rougher_along_x ? 1.0 : lesser);
    const float y = w.y * w.y * (turning.is_rougher_along_x ? lesser : 1.0);
    return x + y > 0.0 ? x / (x + y) : 0.5;
}

// The same averaged over the azimuths.
float lq_mean_share_of_xz(const LqTurning turning, const float cos_theta) {
    const float root = sqrt(lq_turned(turning, cos_theta));
    return (turning.is_rougher_along_x ? 1.0 : root) / (1.0 + root);
}

LqTurning lq_turning_of(const LqStrata strata) {
    float along_x = 0.0;
    float along_y = 0.0;
    float beckmann = 0.0;
    for (int turned = 0; turned < strata.count; turned++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, turned);
        const float weight = stratum.high - stratum.low;
        along_x += weight * lq_square(stratum.facets.alpha_x);
        along_y += weight * lq_square(stratum.facets.alpha_y);
        beckmann += stratum.facets.ndf == LQ_NDF_BECKMANN ? weight : 0.0;
    }
    return LqTurning(along_x >= along_y, min(along_x, along_y) / max(along_x, along_y), beckmann);
}

// A direction in the plane of x, of weight 0, or of y.
vec3 lq_node_direction(const int n, const int plane) {
    const float cosine = lq_albedo_node_cosine(n);
    const float sine = lq_sine_from_cosine(cosine);
    return plane == 0 ? vec3(sine, 0.0, cosine) : vec3(0.0, sine, cosine);
}

// What a node counts for in averages over all directions.
float lq_node_share(const LqTurning turning, const int n, const int plane) {
    const float x = lq_mean_share_of_xz(turning, lq_albedo_node_cosine(n));
    return lq_albedo_node_weight(n) * (plane == 0 ? x : 1.0 - x);
}

LqSeveralFacetsSide lq_no_several_facets() {
    return LqSeveralFacetsSide(lq_albedo_fit_zero(), lq_albedo_fit_zero(), 0.0, 0.0, vec3(0.0),
                               0.0);
}

// Averages over cosine-weighted directions of what facets leave over.
struct LqLeftOnAverage {
    float met;
    float met_cosine;
    vec3 kept;
};

LqLeftOnAverage lq_left_on_average(const LqRoughSide side, const LqTurning turning) {
    float met = 0.0;
    float met_cosine = 0.0;
    vec3 kept = vec3(0.0);
    for (int averaged = 0; averaged < 2 * LQ_ALBEDO_NODES; averaged++) {
        const int node = averaged / 2;
        const int plane = averaged - 2 * node;
        const LqLeftOver left = lq_left_over(side, lq_node_direction(node, plane));
        const float share = lq_node_share(turning, node, plane);
        met += share * left.met;
        met_cosine += share * left.met * lq_albedo_node_cosine(node);
        kept += share * left.kept;
    }
    return LqLeftOnAverage(max(met, 0.0), max(met_cosine, 0.0), max(kept, vec3(0.0)));
}

// What finally leaves, by a series of facets that are all alike after the second.
vec3 lq_leaving(const LqLeftOver left, const LqLeftOnAverage average, const vec3 reflectance) {
    const float leaves = 1.0 - LQ_KEPT_BY_DIRECTION * left.met - LQ_KEPT_ON_AVERAGE * average.met;
    const vec3 first = left.kept / max(left.met, LQ_MIN_COSINE_PRODUCT);
    const vec3 second = reflectance * (1.0 - LQ_LIKE_THE_FIRST) + first * LQ_LIKE_THE_FIRST;
    return left.kept * second * leaves / (vec3(1.0) - reflectance * (1.0 - leaves));
}

// m of a side whose part let through, from `at_grazing` by `slope`, is known.
LqSeveralFacetsSide lq_several_facets_side(const LqRoughSide side, const LqTurning turning,
                                           const LqLeftOnAverage average, const float at_grazing,
                                           const float slope) {
    const vec3 reflectance = average.kept / max(average.met, LQ_LEAST_QUOTIENT);
    LqAlbedoFit in_xz = lq_albedo_fit_zero();
    LqAlbedoFit in_yz = lq_albedo_fit_zero();
    vec3 whole = vec3(0.0);
    for (int fitted = 0; fitted < 2 * LQ_ALBEDO_NODES; fitted++) {
        const int node = fitted / 2;
        const int plane = fitted - 2 * node;
        const LqLeftOver left = lq_left_over(side, lq_node_direction(node, plane));
        vec3 m = left.kept;
        if (side.eta <= 0.0) {
            m = lq_leaving(left, average, reflectance);
        }
        whole += m * lq_node_share(turning, node, plane);
        if (plane == 0) {
            in_xz = lq_albedo_fit_with(in_xz, node, m);
        } else {
            in_yz = lq_albedo_fit_with(in_yz, node, m);
        }
    }
    const float through = at_grazing * average.met + slope * average.met_cosine;
    return LqSeveralFacetsSide(in_xz, in_yz, at_grazing, slope,
                               max(whole - vec3(through), vec3(0.0)), through);
}

// Averaged over cosine-weighted directions, for eta > 1.
float lq_average_fresnel(const float eta) {
    float sum = 0.0;
    for (int half_range = 0; half_range < 4; half_range++) {
        for (int at = 0; at < 6; at++) {
            const vec2 rule = lq_gauss_six(at);
            const float cosine = 0.125 * (2.0 * float(half_range) + 1.0 + rule.x);
            sum += 0.125 * rule.y * 2.0 * cosine * lq_fresnel_dielectric(cosine, eta);
        }
    }
    return sum;
}

// The parts let through by a surface between media: from the side of the lower index the same from
// everywhere, on the other in proportion to the cosine, or less steep where all would not be enough.
// As much light crosses either way, for radiance over the square of the index.
struct LqSeveralThrough {
    float thin;
    float dense_at_grazing;
    float dense_slope;
};

LqSeveralThrough lq_several_through(const LqLeftOnAverage thin, const LqLeftOnAverage dense,
                                    const float eta) {
    const float index_squared = eta * eta;
    const float wanted = 1.0 - LQ_REFLECTED_AGAIN * lq_average_fresnel(eta);
    const float through = min(wanted, index_squared * dense.met / thin.met);
    const float crossing = through * thin.met / index_squared;
    const float slope = crossing / max(dense.met_cosine, LQ_LEAST_QUOTIENT);
    if (slope <= 1.0) {
        return LqSeveralThrough(through, 0.0, slope);
    }
    const float flatter = clamp(
        (dense.met - crossing) / max(dense.met - dense.met_cosine, LQ_LEAST_QUOTIENT), 0.0,
        1.0);
    return LqSeveralThrough(through, 1.0 - flatter, flatter);
}

// Call it once per material: it looks at some hundred facets for each of 14 directions per side.
LqSeveralFacets lq_several_facets(const LqMicrosurfaceSurface surface) {
    const LqTurning turning = lq_turning_of(surface.above.strata);
    const LqSeveralFacets none =
        LqSeveralFacets(turning, lq_no_several_facets(), lq_no_several_facets());
    if (!surface.is_there) {
        return none;
    }
    const LqLeftOnAverage above = lq_left_on_average(surface.above, turning);
    if (above.met < LQ_LEAST_SEVERAL_AVERAGE) {
        return none;
    }
    if (surface.above.eta <= 0.0) {
        return LqSeveralFacets(turning,
                               lq_several_facets_side(surface.above, turning, above, 0.0, 0.0),
                               lq_no_several_facets());
    }
    const LqRoughSide other_side = lq_rough_side_turned_over(surface.above);
    const LqLeftOnAverage below = lq_left_on_average(other_side, turning);
    if (below.met < LQ_LEAST_SEVERAL_AVERAGE) {
        return none;
    }
    if (surface.above.eta > 1.0) {
        const LqSeveralThrough down = lq_several_through(above, below, surface.above.eta);
        return LqSeveralFacets(
            turning, lq_several_facets_side(surface.above, turning, above, down.thin, 0.0),
            lq_several_facets_side(other_side, turning, below, down.dense_at_grazing,
                                   down.dense_slope));
    }
    const LqSeveralThrough up = lq_several_through(below, above, 1.0 / surface.above.eta);
    return LqSeveralFacets(turning,
                           lq_several_facets_side(surface.above, turning, above,
                                                  up.dense_at_grazing, up.dense_slope),
                           lq_several_facets_side(other_side, turning, below, up.thin, 0.0));
}

// w above the side.
LqSeveralShares lq_several_shares(const LqTurning turning, const LqSeveralFacetsSide side,
                                  const vec3 w) {
    const float x = lq_share_of_xz(turning, w);
    const vec3 in_xz = lq_albedo_fit_at(side.in_xz, w.z);
    const vec3 in_yz = lq_albedo_fit_at(side.in_yz, w.z);
    const vec3 m = clamp(in_xz * x + in_yz * (1.0 - x), vec3(0.0), vec3(1.0));
    const float through = side.through_at_grazing + side.through_slope * w.z;
    return LqSeveralShares(m * max(1.0 - through, 0.0), m.x * through);
}

// 0 where there is next to nothing to divide.
float lq_per_average(const float average) {
    return average > LQ_LEAST_QUOTIENT ? LQ_INVERSE_PI / average : 0.0;
}

// f between directions of the same side, of their shares.
vec3 lq_several_reflected(const LqSeveralFacetsSide side, const LqSeveralShares light,
                          const LqSeveralShares viewer) {
    const vec3 scale =
        vec3(lq_per_average(side.average_reflected.x), lq_per_average(side.average_reflected.y),
             lq_per_average(side.average_reflected.z));
    return light.reflected * viewer.reflected * scale;
}

// f of light from the far side, for radiance over the square of the index.
float lq_several_let_through(const LqSeveralFacetsSide far_side, const LqSeveralShares light,
                             const LqSeveralShares viewer) {
    return light.through * viewer.through * lq_per_average(far_side.average_through);
}

#endif
