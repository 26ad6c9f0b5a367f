// From a stack's parameters to what shading needs of it.
#ifndef LQ_STACK_PREPARE_GLSL
#define LQ_STACK_PREPARE_GLSL

#include "layers.glsl"
#include "surface.glsl"
#include "top.glsl"

// The stack for shading: call it once per shading point. What is out of range is clamped.
LqStackSurface lq_stack_prepare(const LqStackMaterial material) {
    LqStackSurface surface;
    surface.first_row = material.first_row;
    surface.layer_count = clamp(material.layer_count, 1, LQ_MAX_LAYERS);
    surface.level_count = surface.layer_count;
    for (int n = 0; n < surface.layer_count; n++) {
        if (lq_scatters(lq_stack_medium(surface.first_row, n))) {
            surface.level_count += 1;
        }
    }
    surface.index = lq_stack_index(surface.first_row, surface.layer_count - 1);

    const LqStackInterface top = lq_stack_interface(surface.first_row, 0);
    const vec4 row = lq_stack_row(top.row);
    surface.top = lq_facets_prepare(int(row.w), row.x, row.y);
    surface.top_count = top.count;
    surface.top_alpha = lq_greatest_alpha(top);
    surface.top_eta = top.eta;
    surface.top_critical = lq_critical_cosine(top.eta);
    surface.top_above = lq_stack_transmittance_octet(surface.top_alpha, top.eta, true);
    surface.top_below = lq_stack_transmittance_octet(surface.top_alpha, top.eta, false);
    surface.multiple = lq_stack_multiple(surface.top_alpha, top.eta);
    for (int blended = top.count > 1 ? 2 : 0; blended > 0; blended--) {
        const LqStackTopSide fitted = lq_stack_blended_side(top, blended == 1);
        surface.top_below = surface.top_above;
        surface.top_above = fitted.entering;
        surface.multiple = LqDirectionPolynomial(surface.multiple.above_low,
                                                 surface.multiple.above_high, fitted.multiple.low,
                                                 fitted.multiple.high);
    }
    const float average =
        2.0 * lq_direction_integral(surface.multiple,
                                    lq_energy_weights(surface.top_critical));
    surface.multiple_scale = lq_multiple_scale(max(average, 0.0));

    surface.base = material.base;
    const int last = surface.layer_count - 1;
    const bool is_open = material.base == LQ_STACK_BASE_NONE &&
                         !lq_scatters(lq_stack_medium(surface.first_row, last));
    surface.exit_place = is_open ? 2 * last : -1;
    surface.base_albedo = clamp(material.albedo, vec3(0.0), vec3(1.0));
    surface.base_alpha = lq_mean_alpha(material.facets);
    surface.base_lobe_alpha = lq_equivalent_lobe_alpha(material.facets);
    const vec3 least = vec3(0.0);
    const vec3 most = vec3(LQ_MAX_CONDUCTOR_INDEX);
    surface.base_eta = clamp(material.eta / surface.index, least, most);
    surface.base_kappa = clamp(material.kappa / surface.index, least, most);
    surface.base_conductor =
        lq_conductor_albedo(surface.base == LQ_STACK_BASE_CONDUCTOR, surface.base_alpha,
                            surface.base_eta, surface.base_kappa);
    return surface;
}

#endif
