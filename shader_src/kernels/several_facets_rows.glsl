// The rows of what meets several facets of a packed rough surface. The host's side is
// host/shading/several_facets_rows.h.
#ifndef LQ_KERNELS_SEVERAL_FACETS_ROWS_GLSL
#define LQ_KERNELS_SEVERAL_FACETS_ROWS_GLSL

#include "../microsurface/several_facets.glsl"

// Rows: (is_rougher_along_x, alpha_squared_ratio, beckmann_share, 0); then of each side seven
// coefficients in the plane of x, seven in that of y, (average_reflected, average_through) and
// (through_at_grazing, through_slope, 0, 0).
#define LQ_SEVERAL_FACETS_SIDE_ROWS 16u

vec3 lq_packed_colour(const uint index) {
    const vec4 row = lq_packed_row(index);
    return vec3(row.x, row.y, row.z);
}

LqAlbedoFit lq_albedo_fit_unpack(const uint first) {
    return LqAlbedoFit(lq_packed_colour(first), lq_packed_colour(first + 1u),
                       lq_packed_colour(first + 2u), lq_packed_colour(first + 3u),
                       lq_packed_colour(first + 4u), lq_packed_colour(first + 5u),
                       lq_packed_colour(first + 6u));
}

LqSeveralFacetsSide lq_several_facets_side_unpack(const uint first) {
    const vec4 averages = lq_packed_row(first + 14u);
    const vec4 through = lq_packed_row(first + 15u);
    return LqSeveralFacetsSide(lq_albedo_fit_unpack(first), lq_albedo_fit_unpack(first + 7u),
                               through.x, through.y, vec3(averages.x, averages.y, averages.z),
                               averages.w);
}

LqSeveralFacets lq_several_facets_unpack(const uint first) {
    const vec4 turning = lq_packed_row(first);
    return LqSeveralFacets(LqTurning(turning.x > 0.0, turning.y, turning.z),
                           lq_several_facets_side_unpack(first + 1u),
                           lq_several_facets_side_unpack(first + 1u + LQ_SEVERAL_FACETS_SIDE_ROWS));
}

#endif
