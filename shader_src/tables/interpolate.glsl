// Linear interpolation among table nodes, by hand: the same in every language and on every device,
// which a sampler's filter is not.
//
// Whoever includes this supplies `uvec4 lq_table_texel(const int index)`, a texel of the packed
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

// The first texels of the four nodes about a point of a two-dimensional grid, counted from where an
// array begins: those of its lower row, then of its higher. And how far between rows and columns.
struct LqCell {
    ivec4 texels;
    float row_share;
    float column_share;
};

// The eight numbers of a texel.
struct LqOctet {
    vec4 low;
    vec4 high;
};

LqOctet lq_table_octet(const int index) {
    const uvec4 texel = lq_table_texel(index);
    const vec2 a = unpackHalf2x16(texel.x);
    const vec2 b = unpackHalf2x16(texel.y);
    const vec2 c = unpackHalf2x16(texel.z);
    const vec2 d = unpackHalf2x16(texel.w);
    return LqOctet(vec4(a.x, a.y, b.x, b.y), vec4(c.x, c.y, d.x, d.y));
}

// Number n of the eight.
float lq_octet_number(const LqOctet octet, const int n) {
    vec4 half_of_them = octet.low;
    if (n > 3) {
        half_of_them = octet.high;
    }
    return half_of_them[n % 4];
}

// `position` in [0, size - 1].
LqSegment lq_table_segment(const float position, const int size) {
    const float inside = clamp(position, 0.0, float(size - 1));
    const int low = int(inside);
    return LqSegment(low, min(low + 1, size - 1), inside - float(low));
}

LqCell lq_table_cell(const LqSegment row, const LqSegment column, const int columns,
                     const int texels_per_node) {
    const ivec4 nodes =
        ivec4(row.low * columns + column.low, row.low * columns + column.high,
              row.high * columns + column.low, row.high * columns + column.high);
    return LqCell(nodes * texels_per_node, row.share, column.share);
}

// By difference, so that what hardly varies is hardly rounded.
LqOctet lq_octet_between(const LqOctet low, const LqOctet high, const float share) {
    return LqOctet(low.low + (high.low - low.low) * share,
                   low.high + (high.high - low.high) * share);
}

// The numbers at a point of a grid, `first` being a texel of its first node. A loop, so that
// shaders, which have many of these, hold the code of one texel each.
LqOctet lq_table_read(const LqCell cell, const int first) {
    const float both = cell.row_share * cell.column_share;
    const vec4 shares = vec4(0.0, cell.column_share - both, cell.row_share - both, both);
    LqOctet corner = LqOctet(vec4(0.0), vec4(0.0));
    LqOctet steps = corner;
    for (int n = 0; n < 4; n++) {
        const LqOctet node = lq_table_octet(first + cell.texels[n]);
        if (n == 0) {
            corner = node;
        }
        steps.low += (node.low - corner.low) * shares[n];
        steps.high += (node.high - corner.high) * shares[n];
    }
    return LqOctet(corner.low + steps.low, corner.high + steps.high);
}

// The same along one axis.
LqOctet lq_table_read_line(const LqSegment segment, const int texels_per_node, const int first) {
    return lq_octet_between(lq_table_octet(first + segment.low * texels_per_node),
                            lq_table_octet(first + segment.high * texels_per_node),
                            segment.share);
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
