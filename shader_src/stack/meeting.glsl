// A beam meets an interface, the base or a medium that scatters.
//
// Loops of one turn or none stand where an `if` would do: some compilers run both sides of an `if`,
// but no loop that nobody enters.
#ifndef LQ_STACK_MEETING_GLSL
#define LQ_STACK_MEETING_GLSL

#include "first_met.glsl"
#include "medium.glsl"
#include "scattering.glsl"
#include "surface.glsl"

// What becomes of a beam: the shares that are reflected and let through, and these parts.
struct LqMeeting {
    vec4 reflected;
    vec4 refracted;
    LqStackBeam kept;
    LqStackBeam passed;
};

// What a boundary sends back whose lobes have roughness `alpha`.
LqStackBeam lq_mirrored_beam(const LqStackBeam beam, const float alpha,
                             const LqFacetEffect facets) {
    if (alpha < LQ_MIN_ALPHA) {
        return beam;
    }
    const float added = lq_lobe_variance(lq_square(alpha * facets.reflected_width));
    return LqStackBeam(clamp(beam.cosine + facets.reflected_tilt, LQ_LEAST_COSINE, 1.0),
                       lq_widened(beam.widths, 1.0, added), beam.interfaces, beam.base);
}

// What of a beam about `cosine` it lets through, into a medium of index `eta` over this one's;
// `mean` is the sine of what all of the beam becomes.
LqStackBeam lq_bent_beam(const LqStackBeam part, const float cosine, const float alpha,
                         const float eta, const float mean) {
    const float sine_step = lq_sine_from_cosine(part.cosine) - lq_sine_from_cosine(cosine);
    const float sine = clamp(mean + sine_step / eta, 0.0, LQ_MOST_SINE);
    const float refracted = lq_sine_from_cosine(sine);
    const vec2 roughness = lq_refracted_roughness(part.cosine, refracted, alpha, eta);
    const float added = lq_lobe_variance(lq_square(roughness.y));
    return LqStackBeam(refracted, lq_widened(part.widths, lq_square(roughness.x), added),
                       part.interfaces, part.base);
}

// What has crossed a medium, the share `first` of it in each direction, meets facets of an interface
// behind which the index is `eta` over this medium's. Where light leaves for good, its direction and
// width are seen and not only what they make of energies: facets are looked at from the mean of the
// part that passes.
LqMeeting lq_meet_stratum(const LqStackBeam beam, const LqStackNodes nodes,
                          const LqCrossedLight crossed, const LqNodeValues first,
                          const LqStackStratum at, const float eta, const bool leaves) {
    const LqNodeValues transmittance = lq_stack_transmittance(at.alpha, eta, nodes);
    const LqNodeValues through = lq_node_product(first, transmittance);
    const LqNodeValues back = LqNodeValues(first.low * (vec4(1.0) - transmittance.low),
                                           first.high * (vec4(1.0) - transmittance.high));
    const LqPart reflected = lq_crossed_part(beam, nodes, crossed, back);
    LqPart refracted = lq_crossed_part(beam, nodes, crossed, through);
    float cosine = beam.cosine;
    if (leaves) {
        cosine = refracted.cosine_by_sine;
        refracted.cosine = cosine;
    }
    const LqFacetEffect kept = lq_facet_effect(beam.cosine, at.alpha, eta);
    float mean = kept.crossing_sine;
    for (int looks = leaves ? 1 : 0; looks > 0; looks--) {
        mean = lq_facet_effect(cosine, at.alpha, eta).refracted_sine;
    }
    return LqMeeting(reflected.share, refracted.share,
                     lq_mirrored_beam(lq_part_of(beam, reflected), at.lobe_alpha, kept),
                     lq_bent_beam(lq_part_of(beam, refracted), cosine, at.lobe_alpha, eta,
                                  mean));
}

// A beam crosses a medium of optical depth `depth` and meets an interface, one stratum after the
// other.
LqMeeting lq_meet_interface(const LqStackBeam beam, const LqStackNodes nodes, const vec3 depth,
                            const LqStackInterface at, const bool is_down, const bool leaves) {
    const LqCrossedLight crossed = lq_crossed_light(depth, nodes);
    const float eta = is_down ? at.eta : 1.0 / at.eta;
    LqStrataCrossing crossing = lq_before_strata(at, nodes);
    LqMeeting all_met = LqMeeting(vec4(0.0), vec4(0.0), lq_no_beam(), lq_no_beam());
    for (int met = 0; met < at.count; met++) {
        const LqStackStratum stratum = lq_stratum_on_the_way(at, met, is_down);
        const float weight = lq_weight_on_the_way(at, met, is_down);
        const LqFirstMet first =
            lq_first_met(at, crossing, stratum.alpha, weight, met + 1 == at.count, nodes);
        crossing = first.behind;
        const LqMeeting here =
            lq_meet_stratum(beam, nodes, crossed, first.here, stratum, eta, leaves);
        if (met == 0) {
            all_met = here;
        } else {
            all_met = LqMeeting(all_met.reflected + here.reflected,
                                all_met.refracted + here.refracted,
                                lq_merged(all_met.kept, here.kept),
                                lq_merged(all_met.passed, here.passed));
        }
    }
    return all_met;
}

// A beam meets a medium that scatters.
LqMeeting lq_meet_slab(const LqStackBeam beam, const LqStackNodes nodes,
                       const LqStackMedium medium) {
    const LqSlab slab = LqSlab(vec4(medium.absorption, 0.0),
                               vec4(medium.scattering, lq_average(medium.scattering)), medium.g);
    const LqSlabLight light = lq_slab_light_of_lobe(slab, nodes);
    const float absorption = 0.25 * dot(slab.absorption, vec4(1.0));
    const float scattering = 0.25 * dot(slab.scattering, vec4(1.0));
    return LqMeeting(
        light.back, light.transmitted,
        lq_scattered_beam(beam, light.back, lq_back_lobe(scattering, slab.g, beam.cosine)),
        lq_scattered_beam(beam, light.transmitted,
                          lq_transmitted_lobe(absorption, scattering, slab.g, beam.cosine)));
}

// A beam crosses a medium and meets the base: `kept` is what a conductor sends back, or what arrives
// where there is none.
LqMeeting lq_meet_base(const LqStackBeam beam, const LqStackNodes nodes, const vec3 depth,
                       const LqStackSurface surface) {
    LqCrossedLight left = lq_crossed_light(depth, nodes);
    LqNodeValues clear = LqNodeValues(vec4(1.0), vec4(1.0));
    const bool conducts = surface.base == LQ_STACK_BASE_CONDUCTOR;
    if (conducts) {
        const bool is_smooth = surface.base_alpha < LQ_MIN_ALPHA;
        const vec3 reflectance =
            lq_fresnel_conductor_rgb(beam.cosine, surface.base_eta, surface.base_kappa);
        const LqConductorAlbedo albedo = surface.base_conductor;
        left.red = lq_node_product(left.red, lq_conductor_channel(albedo.red, is_smooth,
                                                                  reflectance.x, beam.cosine,
                                                                  nodes));
        left.green = lq_node_product(left.green,
                                     lq_conductor_channel(albedo.green, is_smooth, reflectance.y,
                                                          beam.cosine, nodes));
        left.blue = lq_node_product(left.blue, lq_conductor_channel(albedo.blue, is_smooth,
                                                                    reflectance.z, beam.cosine,
                                                                    nodes));
        clear = LqNodeValues(vec4(0.0), vec4(0.0));
    }
    const LqPart part = lq_part(beam, nodes, left.red, left.green, left.blue, clear);
    LqStackBeam kept = lq_part_of(beam, part);
    if (conducts) {
        kept = lq_met_base(
            lq_mirrored_beam(kept, surface.base_lobe_alpha, LqFacetEffect(0.0, 1.0, 0.0, 0.0)));
    }
    return LqMeeting(part.share, vec4(0.0), kept, lq_no_beam());
}

// A place in a stack: interface n at 2 n, the medium below it at 2 n + 1, the base behind the last.
int lq_base_place(const LqStackSurface surface) {
    return 2 * surface.layer_count;
}

bool lq_is_medium_place(const int place) {
    return place % 2 == 1;
}

// Optical depth of the medium that light crosses on its way to an interface or the base at `place`,
// where that medium only absorbs.
vec3 lq_crossed_depth(const LqStackSurface surface, const int place, const bool is_down) {
    const int layer = is_down ? place / 2 - 1 : place / 2;
    if (layer < 0) {
        return vec3(0.0);
    }
    const LqStackMedium medium = lq_stack_medium(surface.first_row, layer);
    return lq_scatters(medium) ? vec3(0.0) : medium.absorption;
}

// What becomes of light that meets what is at `place`, coming from above or from below.
LqMeeting lq_meet(const LqStackSurface surface, const int place, const bool is_down,
                  const LqStackBeam beam) {
    const LqStackNodes nodes = lq_stack_nodes(beam.cosine, lq_safe_sqrt(lq_beam_width(beam)));
    const bool is_slab = lq_is_medium_place(place);
    const bool is_base = place == lq_base_place(surface);
    LqMeeting meeting = LqMeeting(vec4(0.0), vec4(0.0), lq_no_beam(), lq_no_beam());
    for (int slab = is_slab ? 1 : 0; slab > 0; slab--) {
        meeting = lq_meet_slab(beam, nodes, lq_stack_medium(surface.first_row, place / 2));
    }
    for (int base = is_base ? 1 : 0; base > 0; base--) {
        meeting = lq_meet_base(beam, nodes, lq_crossed_depth(surface, place, true), surface);
    }
    const int interfaces = is_slab || is_base ? 0 : 1;
    for (int met = interfaces; met > 0; met--) {
        const LqStackInterface at = lq_stack_interface(surface.first_row, place / 2);
        meeting = lq_meet_interface(beam, nodes, lq_crossed_depth(surface, place, is_down), at,
                                    is_down, is_down && place == surface.exit_place);
    }
    return meeting;
}

#endif
