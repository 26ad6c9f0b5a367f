// Linear interpolation among table nodes, by hand: the same in every language and on every device,
// which a sampler's filter is not.
//
// Whoever includes this supplies `vec4 lq_table_texel(const int index)`, a texel of the packed
// tables: from a buffer, or with texelFetch from a texture.
#ifndef LQ_TABLES_INTERPOLATE_GLSL
#define LQ_TABLES_INTERPOLATE_GLSL

#include "../core/math.glsl"
#include "texels.glsl"

// Where the eta axes begin: tables hold the limits to both sides of 1.
const float LQ_ETA_NEAR_ONE = 1.0e-4;

// Two neighbouring nodes of an axis and how far between them.
struct LqSegment {
    int low;
    int high;
    float share;
};

// The four texels about a point of a two-dimensional grid, and their weights.
struct LqCell {
    ivec4 texels;
    vec4 weights;
};

// `position` in [0, size - 1].
LqSegment lq_table_segment(const float position, const int size) {
    const float inside = clamp(position, 0.0, float(size - 1));
    const int low = int(inside);
    return LqSegment(low, min(low + 1, size - 1), inside - float(low));
}

// `texels_per_node` texels for each node of rows and columns, from texel `first` on.
LqCell lq_table_cell(const int first, const LqSegment row, const LqSegment column,
                     const int columns, const int texels_per_node) {
    const ivec4 nodes =
        ivec4(row.low * columns + column.low, row.low * columns + column.high,
              row.high * columns + column.low, row.high * columns + column.high);
    const vec2 rows = vec2(1.0 - row.share, row.share);
    const vec2 sides = vec2(1.0 - column.share, column.share);
    return LqCell(nodes * texels_per_node + ivec4(first),
                  vec4(rows.x * sides.x, rows.x * sides.y, rows.y * sides.x, rows.y * sides.y));
}

// Four channels at a point of a grid: those of texel number `texel` of each node.
vec4 lq_table_read(const LqCell cell, const int texel) {
    return lq_table_texel(cell.texels.x + texel) * cell.weights.x +
           lq_table_texel(cell.texels.y + texel) * cell.weights.y +
           lq_table_texel(cell.texels.z + texel) * cell.weights.z +
           lq_table_texel(cell.texels.w + texel) * cell.weights.w;
}

// The same along one axis.
vec4 lq_table_read_line(const int first, const LqSegment segment, const int texels_per_node,
                        const int texel) {
    const vec4 low = lq_table_texel(first + segment.low * texels_per_node + texel);
    const vec4 high = lq_table_texel(first + segment.high * texels_per_node + texel);
    return low + (high - low) * segment.share;
}

// Positions on the axes of the tables (host/tables/axis.h).

// alpha in [0, 1], spaced as squares.
LqSegment lq_alpha_segment(const float alpha, const int size) {
    return lq_table_segment(lq_safe_sqrt(alpha) * float(size - 1), size);
}

// tau in [0, 1], from 1 down, spaced as squares.
LqSegment lq_tau_segment(const float tau) {
    return lq_table_segment(lq_safe_sqrt(1.0 - tau) * float(LQ_TABLE_TAUS - 1), LQ_TABLE_TAUS);
}

// eta in [1/3, 3]: from next to 1 to the end of its side, along a logarithm bent to give the
// neighbourhood of 1 more nodes.
LqSegment lq_eta_segment(const float eta, const int size) {
    const float slope = 0.02;
    const float first = eta < 1.0 ? 1.0 - LQ_ETA_NEAR_ONE : 1.0 + LQ_ETA_NEAR_ONE;
    const float last = eta < 1.0 ? LQ_MIN_ETA : LQ_MAX_ETA;
    const float share = lq_log_ratio(eta / first) / lq_log_ratio(last / first);
    const float bent = lq_safe_sqrt(slope * slope + 4.0 * (1.0 + slope) * share);
    return lq_table_segment(0.5 * (bent - slope) * float(size - 1), size);
}

#endif
