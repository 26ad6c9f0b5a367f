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
#include "medium.glsl"
#include "scattering.glsl"
#include "surface.glsl"

const int LQ_LIGHT_FROM_ABOVE = 0;
const int LQ_LIGHT_ENTERED = 1;
const int LQ_LIGHT_FROM_BELOW = 2;

const int LQ_STACK_PASSES = 2;

// Rows of a beam in an array: its three lobes, then (widths, cosine).
#define LQ_BEAM_ROWS 4
// Rows of an interface: what it reflects and lets through of light going down, and of light going
// up, after crossing the medium it comes from.
#define LQ_SHARE_ROWS 4

// `top` is what the top interface reflects. The other light that leaves at the top: of lobes
// reflected by lower interfaces at most, and by the base. `arrived` at the bottom for the first
// time, where no conductor is; `returning` what of diffuse light from there comes back.
struct LqStackLight {
    float top;
    vec4 interfaces;
    float interfaces_width;
    vec4 base;
    float base_width;
    vec4 arrived;
    vec4 returning;
};

// An interface as light meets it from one side: its roughness, the index of the other medium over
// that of the light's, its critical cosine, and its coefficients beyond that and below.
struct LqMetInterface {
    float alpha;
    float eta;
    float critical;
    LqOctet above;
    LqOctet below;
};

// The shares of light that cross it, in the directions of a lobe.
LqNodeValues lq_stack_transmittance(const LqMetInterface met, const LqStackNodes nodes) {
    if (met.alpha < LQ_MIN_ALPHA) {
        return LqNodeValues(vec4(1.0) - lq_fresnel_of_four(nodes.low, met.eta),
                            vec4(1.0) - lq_fresnel_of_four(nodes.high, met.eta));
    }
    return LqNodeValues(lq_entering(met.above, met.below, met.critical, nodes.low),
                        lq_entering(met.above, met.below, met.critical, nodes.high));
}

// What an interface of roughness `alpha` sends back.
LqStackBeam lq_mirrored_beam(const LqStackBeam beam, const float alpha,
                             const LqFacetEffect facets) {
    if (alpha < LQ_MIN_ALPHA) {
        return beam;
    }
    const float added = lq_lobe_variance(lq_square(alpha * facets.reflected_width));
    return LqStackBeam(clamp(beam.cosine + facets.reflected_tilt, LQ_LEAST_COSINE, 1.0),
                       lq_widened(beam.widths, 1.0, added), beam.through, beam.interfaces,
                       beam.base);
}

// What of a beam about `cosine` it lets through, into a medium of index `eta` over this one's.
LqStackBeam lq_bent_beam(const LqStackBeam part, const float cosine, const float alpha,
                         const float eta, const LqFacetEffect facets) {
    const float sine_step = lq_sine_from_cosine(part.cosine) - lq_sine_from_cosine(cosine);
    const float sine = clamp(facets.refracted_sine + sine_step / eta, 0.0, LQ_MOST_SINE);
    const float refracted = lq_sine_from_cosine(sine);
    const vec2 roughness = lq_refracted_roughness(part.cosine, refracted, alpha, eta);
    const float added = lq_lobe_variance(lq_square(roughness.y));
    return LqStackBeam(refracted, lq_widened(part.widths, lq_square(roughness.x), added),
                       part.through, part.interfaces, part.base);
}

// What becomes of a beam: the shares that are reflected and let through, and these parts.
struct LqMeeting {
    vec4 reflected;
    vec4 refracted;
    LqStackBeam kept;
    LqStackBeam passed;
};

// A beam crosses a medium of optical depth `depth` and meets an interface.
LqMeeting lq_meet_interface(const LqStackBeam beam, const vec3 depth, const LqMetInterface met) {
    const LqStackNodes nodes = lq_stack_nodes(beam.cosine, lq_beam_alpha(beam));
    const LqCrossedLight crossed = lq_crossed_light(depth, nodes);
    const LqNodeValues through = lq_stack_transmittance(met, nodes);
    const LqNodeValues back = LqNodeValues(vec4(1.0) - through.low, vec4(1.0) - through.high);
    const LqPart refracted = lq_crossed_part(beam, nodes, crossed, through);
    const LqPart reflected = lq_crossed_part(beam, nodes, crossed, back);
    const LqFacetEffect facets = lq_facet_effect(beam.cosine, met.alpha, met.eta);
    return LqMeeting(reflected.share, refracted.share,
                     lq_mirrored_beam(lq_part_of(beam, reflected), met.alpha, facets),
                     lq_bent_beam(lq_part_of(beam, refracted), beam.cosine, met.alpha, met.eta,
                                  facets));
}

// A beam meets a medium that scatters.
LqMeeting lq_meet_slab(const LqStackBeam beam, const LqSlab slab) {
    const LqStackNodes nodes = lq_stack_nodes(beam.cosine, lq_beam_alpha(beam));
    const LqSlabLight light = lq_slab_light_of_lobe(slab, nodes);
    const float absorption = 0.25 * lq_energy_sum(slab.absorption);
    const float scattering = 0.25 * lq_energy_sum(slab.scattering);
    return LqMeeting(
        light.back, light.transmitted,
        lq_scattered_beam(beam, light.back, lq_back_lobe(scattering, slab.g, beam.cosine)),
        lq_scattered_beam(beam, light.transmitted,
                          lq_transmitted_lobe(absorption, scattering, slab.g, beam.cosine)));
}

// A conductor: its roughness, its index over that of the medium above it, and its albedo.
struct LqMetConductor {
    float alpha;
    vec3 eta;
    vec3 kappa;
    LqConductorAlbedo albedo;
};

// A beam crosses a medium and meets the base: `kept` is what a conductor sends back, or what arrives
// where there is none.
LqMeeting lq_meet_base(const LqStackBeam beam, const vec3 depth, const bool conducts,
                       const LqMetConductor base) {
    const LqStackNodes nodes = lq_stack_nodes(beam.cosine, lq_beam_alpha(beam));
    LqCrossedLight left = lq_crossed_light(depth, nodes);
    LqNodeValues clear = LqNodeValues(vec4(1.0), vec4(1.0));
    if (conducts) {
        const bool is_smooth = base.alpha < LQ_MIN_ALPHA;
        const vec3 reflectance = lq_fresnel_conductor_rgb(beam.cosine, base.eta, base.kappa);
        left.red = lq_node_product(left.red, lq_conductor_channel(base.albedo.red, is_smooth,
                                                                  reflectance.x, beam.cosine,
                                                                  nodes));
        left.green = lq_node_product(left.green,
                                     lq_conductor_channel(base.albedo.green, is_smooth,
                                                          reflectance.y, beam.cosine, nodes));
        left.blue = lq_node_product(left.blue, lq_conductor_channel(base.albedo.blue, is_smooth,
                                                                    reflectance.z, beam.cosine,
                                                                    nodes));
        clear = LqNodeValues(vec4(0.0), vec4(0.0));
    }
    const LqPart part = lq_part(beam, nodes, left.red, left.green, left.blue, clear);
    LqStackBeam kept = lq_part_of(beam, part);
    if (conducts) {
        kept = lq_met_base(lq_mirrored_beam(kept, base.alpha, LqFacetEffect(0.0, 1.0, 0.0)));
    }
    return LqMeeting(part.share, vec4(0.0), kept, lq_no_beam());
}

// `kind` is one of LQ_LIGHT_*; `cosine` in [0, 1] of light from above.
LqStackLight lq_stack_light(const LqStackSurface prepared, const int kind, const float cosine) {
    // A variable, whose arrays can be looked into without a copy for each look.
    LqStackSurface surface = prepared;
    const int count = surface.level_count;
    const int cycle = 2 * count;
    const bool conducts = surface.base == LQ_STACK_BASE_CONDUCTOR;
    const LqMetConductor conductor = LqMetConductor(surface.base_alpha, surface.base_eta,
                                                    surface.base_kappa, surface.base_albedo);
    // Light that waits in each medium, 0 being the exterior, for the next sweep to take it along.
    vec4 waiting[(LQ_MAX_LEVELS + 1) * LQ_BEAM_ROWS];
    for (int row = 0; row < (count + 1) * LQ_BEAM_ROWS; row++) {
        waiting[row] = vec4(0.0);
    }
    vec4 shares[LQ_MAX_LEVELS * LQ_SHARE_ROWS];
    for (int share = 0; share < count * LQ_SHARE_ROWS; share++) {
        shares[share] = vec4(0.0);
    }
    vec4 base_share = vec4(0.0);
    const bool is_from_below = kind == LQ_LIGHT_FROM_BELOW;
    // Diffuse light is the widest lobe about the normal.
    LqStackBeam carried = LqStackBeam(is_from_below ? 1.0 : cosine,
                                      vec3(is_from_below ? 1.0 : 0.0, 0.0, 0.0), vec4(1.0),
                                      vec4(0.0), vec4(0.0));
    LqStackBeam escaped = lq_no_beam();
    LqStackLight light =
        LqStackLight(0.0, vec4(0.0), 0.0, vec4(0.0), 0.0, vec4(0.0), vec4(0.0));
    const int first = is_from_below ? count : -1;
    const int end = is_from_below ? 3 * count : LQ_STACK_PASSES * cycle;
    for (int turn = first; turn < end; turn++) {
        // On its way down light meets level 0 once, then 1, 2 and so on, then the base; on its
        // way up all levels.
        const int place = turn < 0 ? -1 : turn % cycle;
        const bool is_down = place < count;
        const int index = is_down ? place + 1 : cycle - 1 - place;
        const int medium = is_down ? index : index + 1;
        const int slot = medium * LQ_BEAM_ROWS;
        const vec4 shape = waiting[slot + 3];
        const LqStackBeam beam =
            lq_merged(carried, LqStackBeam(shape.w, vec3(shape.x, shape.y, shape.z),
                                           waiting[slot], waiting[slot + 1], waiting[slot + 2]));
        const bool is_bottom = index == count;
        const vec4 level = surface.levels[is_bottom ? count - 1 : index];
        const int absorber = int(is_down && !is_bottom ? level.z : level.w);
        const vec4 depths = surface.absorption[max(absorber, 0)] * (absorber < 0 ? 0.0 : 1.0);
        const vec3 depth = vec3(depths.x, depths.y, depths.z);
        LqStackBeam left = lq_no_beam();
        if (is_bottom) {
            const LqMeeting meeting = lq_meet_base(beam, depth, conducts, conductor);
            base_share = meeting.reflected;
            carried = meeting.kept;
            if (!conducts) {
                light.arrived += lq_beam_energy(meeting.kept);
                carried = lq_no_beam();
            }
        } else {
            const int layer = int(level.x);
            LqMeeting meeting = LqMeeting(vec4(0.0), vec4(0.0), lq_no_beam(), lq_no_beam());
            if (level.y > 0.0) {
                const vec4 absorption = surface.absorption[layer];
                const vec4 scattering = surface.scattering[layer];
                const float mean = (scattering.x + scattering.y + scattering.z) / 3.0;
                meeting = lq_meet_slab(
                    beam, LqSlab(absorption, vec4(scattering.x, scattering.y, scattering.z, mean),
                                 scattering.w));
            } else {
                const vec4 at = surface.interfaces[layer];
                const float eta = is_down ? at.z / at.y : at.y / at.z;
                const int interface_row = layer * LQ_INTERFACE_ROWS;
                const int above = interface_row + (eta < 1.0 ? 2 : 0);
                meeting = lq_meet_interface(
                    beam, depth,
                    LqMetInterface(at.x, eta, lq_critical_cosine(eta),
                                   LqOctet(surface.rows[above], surface.rows[above + 1]),
                                   LqOctet(surface.rows[interface_row + 4],
                                           surface.rows[interface_row + 5])));
            }
            const int share_row = index * LQ_SHARE_ROWS + (is_down ? 0 : 2);
            shares[share_row] = meeting.reflected;
            shares[share_row + 1] = meeting.refracted;
            carried = meeting.passed;
            left = meeting.kept;
            if (turn < 0) {
                light.top = left.through.w;
                left = lq_no_beam();
                if (kind == LQ_LIGHT_ENTERED) {
                    carried.through = vec4(1.0);
                }
            } else if (is_down) {
                left = lq_met_interface(left);
            } else if (index == 0) {
                escaped = lq_merged(escaped, carried);
                carried = lq_no_beam();
            }
        }
        waiting[slot] = left.through;
        waiting[slot + 1] = left.interfaces;
        waiting[slot + 2] = left.base;
        waiting[slot + 3] = vec4(left.widths, left.cosine);
    }
    escaped = lq_met_interface(escaped);
    light.interfaces = escaped.interfaces;
    light.interfaces_width = escaped.widths.y;
    light.base = escaped.base;
    light.base_width = escaped.widths.z;

    // The rest, all at once: it leaves as wide as what has left before.
    vec4 mirrors_below[LQ_MAX_LEVELS + 1];
    mirrors_below[count] = base_share * (conducts ? 1.0 : 0.0);
    for (int level = count - 1; level > 0; level--) {
        const int at = level * LQ_SHARE_ROWS;
        mirrors_below[level] = lq_mirror_behind(shares[at], shares[at + 1],
                                                mirrors_below[level + 1], shares[at + 3],
                                                shares[at + 2]);
    }
    vec4 mirrors_above[LQ_MAX_LEVELS + 1];
    mirrors_above[0] = vec4(0.0);
    vec4 leaving = vec4(1.0);
    for (int below = 1; below <= count; below++) {
        const int upper = (below - 1) * LQ_SHARE_ROWS;
        leaving *= shares[upper + 3] * lq_series(shares[upper + 2] * mirrors_below[below]);
        mirrors_above[below] = lq_mirror_behind(shares[upper + 2], shares[upper + 3],
                                                mirrors_above[below - 1], shares[upper + 1],
                                                shares[upper]);
        const vec4 escaping = mirrors_below[below] * leaving;
        const int left_over = below * LQ_BEAM_ROWS;
        const vec4 shallow = waiting[left_over] + waiting[left_over + 1];
        light.base += escaping * waiting[left_over + 2];
        if (conducts && below == count) {
            light.base += escaping * shallow;
        } else {
            light.interfaces += escaping * shallow;
        }
    }
    if (!conducts) {
        vec4 arriving = base_share;
        for (int zone = count; zone > 0; zone--) {
            if (zone < count) {
                const int lower = zone * LQ_SHARE_ROWS;
                arriving *= shares[lower + 1] * lq_series(shares[lower] * mirrors_above[zone]);
            }
            const int rest = zone * LQ_BEAM_ROWS;
            light.arrived += arriving * (waiting[rest] + waiting[rest + 1] + waiting[rest + 2]);
        }
        light.returning = mirrors_above[count] * base_share;
    }
    return light;
}

#endif
