// The light of a stack by adding up its orders: twice from interface to interface down to the base
// and up again, energy and shape of every lobe; then the rest in closed form, by the coefficients of
// the last pass.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, sections 4 and 5
//
// Unlike there, every coefficient of an interface or medium is averaged over the directions of the
// light that meets it, and the mean of what goes either way follows from the same average: light
// that is reflected at the critical angle stays beyond it.
//
// One loop serves all that is asked, so that its body is compiled once: light from above, light that
// has entered the top medium from there, and diffuse light from the bottom, which is followed for
// one pass only.
#ifndef LQ_STACK_TRANSPORT_GLSL
#define LQ_STACK_TRANSPORT_GLSL

#include "adding.glsl"
#include "meeting.glsl"

const int LQ_LIGHT_FROM_ABOVE = 0;
const int LQ_LIGHT_ENTERED = 1;
const int LQ_LIGHT_FROM_BELOW = 2;

// Ways down or up, in turn.
const int LQ_STACK_WAYS = 4;

// Rows of light that waits: its two lobes, then (widths, cosine, 0).
#define LQ_BEAM_ROWS 3
// Rows of a level: what it reflects and lets through of light going down, and of light going up,
// after crossing the medium it comes from.
#define LQ_SHARE_ROWS 4

// `top` is what the top interface reflects. The other light that leaves at the top: of lobes
// reflected by lower interfaces at most, and by the base, or all of it in the former where
// LQ_STACK_LOBES is 2. What arrives at the bottom for the first time, where no conductor is:
// `straight` what came straight down, `detoured` what was reflected on the way. `returning` is what
// of diffuse light from there comes back.
struct LqStackLight {
    float top;
    vec4 interfaces;
    float interfaces_width;
    vec4 base;
    float base_width;
    LqStackBeam straight;
    LqStackBeam detoured;
    vec4 returning;
};

LqStackLight lq_no_light() {
    return LqStackLight(0.0, vec4(0.0), 0.0, vec4(0.0), 0.0, lq_no_beam(), lq_no_beam(),
                        vec4(0.0));
}

// Light as it begins: diffuse light is the widest lobe about the normal.
LqStackBeam lq_first_beam(const int kind, const float cosine) {
    const bool is_from_below = kind == LQ_LIGHT_FROM_BELOW;
    return LqStackBeam(is_from_below ? 1.0 : cosine, vec2(is_from_below ? 1.0 : 0.0, 0.0),
                       vec4(1.0), vec4(0.0));
}

// `kind` is one of LQ_LIGHT_*; `cosine` in [0, 1] of light from above.
LqStackLight lq_stack_light(const LqStackSurface surface, const int kind, const float cosine) {
    const int base_place = lq_base_place(surface);
    const int bottom = surface.level_count;
    const bool conducts = surface.base == LQ_STACK_BASE_CONDUCTOR;
    // Light waits between levels, in zones counted from the exterior, for the next way to take it
    // along.
    vec4 waiting[(LQ_MAX_LEVELS + 1) * LQ_BEAM_ROWS];
    for (int row = 0; row < (bottom + 1) * LQ_BEAM_ROWS; row++) {
        waiting[row] = vec4(0.0);
    }
    vec4 shares[LQ_MAX_LEVELS * LQ_SHARE_ROWS];
    for (int share = 0; share < bottom * LQ_SHARE_ROWS; share++) {
        shares[share] = vec4(0.0);
    }
    vec4 base_share = vec4(0.0);
    LqStackBeam carried = lq_first_beam(kind, cosine);
    LqStackBeam escaped = lq_no_beam();
    LqStackLight light = lq_no_light();
    const int first_way = kind == LQ_LIGHT_FROM_BELOW ? 1 : 0;
    const int ways = kind == LQ_LIGHT_FROM_BELOW ? 3 : LQ_STACK_WAYS;
    int zone = first_way == 0 ? 0 : bottom;
    for (int way = first_way; way < ways; way++) {
        const bool is_down = way % 2 == 0;
        // Only the first way down meets the top interface, and no way up the base.
        const int first = way == 0 ? 0 : 1;
        zone = is_down ? first : zone;
        for (int met = first; met <= base_place; met++) {
            const int place = is_down ? met : base_place - met;
            const bool is_present =
                !lq_is_medium_place(place) ||
                lq_scatters(lq_stack_medium(surface.first_row, place / 2));
            for (int present = is_present ? 1 : 0; present > 0; present--) {
                const int slot = zone * LQ_BEAM_ROWS;
                const vec4 shape = waiting[slot + 2];
                const LqMeeting meeting = lq_meet(
                    surface, place, is_down,
                    lq_merged(carried, LqStackBeam(shape.z, vec2(shape.x, shape.y), waiting[slot],
                                                   waiting[slot + 1])));
                LqStackBeam left = meeting.kept;
                carried = meeting.passed;
                if (place == base_place) {
                    base_share = meeting.reflected;
                    left = lq_no_beam();
                    if (conducts) {
                        carried = meeting.kept;
                    } else if (way == 0) {
                        light.straight = meeting.kept;
                    } else {
                        light.detoured = lq_merged(light.detoured, meeting.kept);
                    }
                } else {
                    const int level = is_down ? zone : zone - 1;
                    const int share_row = level * LQ_SHARE_ROWS + (is_down ? 0 : 2);
                    shares[share_row] = meeting.reflected;
                    shares[share_row + 1] = meeting.refracted;
                    if (place == 0 && is_down) {
                        light.top = meeting.reflected.w;
                        left = lq_no_beam();
                        if (kind == LQ_LIGHT_ENTERED) {
                            carried.interfaces = vec4(1.0);
                        }
                    }
                    zone += is_down ? 1 : -1;
                }
                waiting[slot] = left.interfaces;
                waiting[slot + 1] = left.base;
                waiting[slot + 2] = vec4(left.widths, left.cosine, 0.0);
            }
        }
        if (!is_down) {
            escaped = lq_merged(escaped, carried);
            carried = lq_no_beam();
        }
    }
    light.interfaces_width = escaped.widths.x;
    light.base_width = escaped.widths.y;

    // The rest, all at once: it leaves as wide as what has left before.
    vec4 mirror = base_share * (conducts ? 1.0 : 0.0);
    vec4 rest_of_interfaces = vec4(0.0);
    vec4 rest_of_base = vec4(0.0);
    for (int under = bottom; under > 0; under--) {
        const int down = (under - 1) * LQ_SHARE_ROWS;
        const int up = down + 2;
        const bool met_base = conducts && under == bottom;
        const vec4 leaving = shares[up + 1] * lq_series(shares[up] * mirror);
        const vec4 shallow = mirror * waiting[under * LQ_BEAM_ROWS];
        const vec4 deep = mirror * waiting[under * LQ_BEAM_ROWS + 1];
        rest_of_interfaces =
            leaving * (rest_of_interfaces + (met_base ? 0.0 : 1.0) * shallow);
        rest_of_base = leaving * (rest_of_base + deep + (met_base ? 1.0 : 0.0) * shallow);
        mirror = lq_mirror_behind(shares[down], shares[down + 1], mirror, shares[up + 1],
                                  shares[up]);
    }
    light.interfaces = escaped.interfaces + rest_of_interfaces;
    light.base = escaped.base + rest_of_base;
    if (LQ_STACK_LOBES == 2) {
        light.interfaces_width = lq_beam_width(
            LqStackBeam(1.0, escaped.widths, light.interfaces, light.base));
        light.interfaces += light.base;
        light.base = vec4(0.0);
    }
    if (!conducts) {
        vec4 mirror_above = vec4(0.0);
        vec4 arriving = vec4(0.0);
        for (int over = 0; over < bottom; over++) {
            const int from_above = over * LQ_SHARE_ROWS;
            const int from_below = from_above + 2;
            const int rest = (over + 1) * LQ_BEAM_ROWS;
            arriving = arriving * shares[from_above + 1] *
                           lq_series(shares[from_above] * mirror_above) +
                       (waiting[rest] + waiting[rest + 1]);
            mirror_above =
                lq_mirror_behind(shares[from_below], shares[from_below + 1], mirror_above,
                                 shares[from_above + 1], shares[from_above]);
        }
        light.detoured.interfaces += arriving * base_share;
        light.returning = mirror_above * base_share;
    }
    return light;
}

#endif
