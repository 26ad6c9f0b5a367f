// From a stack's parameters to what shading needs of it.
#ifndef LQ_STACK_PREPARE_GLSL
#define LQ_STACK_PREPARE_GLSL

#include "../interface/energies.glsl"
#include "diffuse_base.glsl"

// Less than this average of light reflected more than once is the noise of the tables.
const float LQ_STACK_LEAST_MULTIPLE = 0.001;
const float LQ_MOST_DEPTH = 80.0;  // lets no light through
const float LQ_MOST_G = 0.99;

vec3 lq_stack_depths(const vec4 depths) {
    return vec3(clamp(depths.x, 0.0, LQ_MOST_DEPTH), clamp(depths.y, 0.0, LQ_MOST_DEPTH),
                clamp(depths.z, 0.0, LQ_MOST_DEPTH));
}

// The isotropic GGX roughness whose energies stand for those of other facets, to some percent: the
// mean of two roughnesses; and less of Beckmann's, which has fewer steep facets.
float lq_stack_energy_alpha(const vec4 layer, const float eta) {
    const float alpha = clamp(0.5 * (layer.x + layer.y), 0.0, 1.0);
    if (int(layer.w) == LQ_NDF_BECKMANN) {
        return alpha * (0.52 + (eta < 1.0 ? 0.41 : 0.09) * alpha);
    }
    return alpha;
}

// The part of the top interface's albedo that has met more than one facet.
LqDirectionPolynomial lq_stack_multiple(const float alpha, const float eta) {
    const LqCell cell =
        lq_table_cell(lq_alpha_segment(alpha, LQ_TABLE_ALPHAS), lq_eta_segment(eta, LQ_TABLE_ETAS),
                      LQ_TABLE_ETAS, 1);
    return lq_interface_multiple_function(cell, eta);
}

// The stack for shading: call it once per shading point. What is out of range is clamped.
LqStackSurface lq_stack_prepare(const LqStackMaterial material) {
    LqStackMaterial stack = material;
    LqStackSurface surface;
    surface.layer_count = clamp(material.layer_count, 1, LQ_MAX_LAYERS);
    surface.base = material.base;
    surface.level_count = 0;
    float absorber_above = -1.0;
    float index_above = 1.0;
    for (int n = 0; n < surface.layer_count; n++) {
        const vec4 layer = stack.interfaces[n];
        const float index =
            clamp(layer.z, index_above * LQ_MIN_ETA, index_above * LQ_MAX_ETA);
        const float eta = index / index_above;
        const float alpha = lq_stack_energy_alpha(layer, eta);
        const LqInterfaceRows read = lq_interface_rows(alpha, max(eta, 1.0 / eta));
        surface.interfaces[n] = vec4(alpha, index_above, index, 0.0);
        surface.rows[n * LQ_INTERFACE_ROWS] = read.dense.low;
        surface.rows[n * LQ_INTERFACE_ROWS + 1] = read.dense.high;
        surface.rows[n * LQ_INTERFACE_ROWS + 2] = read.thin_above.low;
        surface.rows[n * LQ_INTERFACE_ROWS + 3] = read.thin_above.high;
        surface.rows[n * LQ_INTERFACE_ROWS + 4] = read.thin_below.low;
        surface.rows[n * LQ_INTERFACE_ROWS + 5] = read.thin_below.high;
        const vec4 absorption = stack.absorption[n];
        const vec4 scattering = stack.scattering[n];
        surface.absorption[n] = vec4(lq_stack_depths(absorption), 0.0);
        surface.scattering[n] =
            vec4(lq_stack_depths(scattering), clamp(absorption.w, -LQ_MOST_G, LQ_MOST_G));
        const bool scatters = max(max(scattering.x, scattering.y), scattering.z) > 0.0;
        const float absorber = scatters ? -1.0 : float(n);
        surface.levels[surface.level_count] = vec4(float(n), 0.0, absorber_above, absorber);
        surface.level_count += 1;
        if (scatters) {
            surface.levels[surface.level_count] = vec4(float(n), 1.0, -1.0, -1.0);
            surface.level_count += 1;
        }
        absorber_above = absorber;
        index_above = index;
    }

    const vec4 top = material.interfaces[0];
    surface.top = lq_facets_prepare(int(top.w), top.x, top.y);
    surface.top_eta = surface.interfaces[0].z;
    surface.top_critical = lq_critical_cosine(surface.top_eta);
    surface.top_above = LqOctet(surface.rows[0], surface.rows[1]);
    if (surface.top_eta < 1.0) {
        surface.top_above = LqOctet(surface.rows[2], surface.rows[3]);
    }
    surface.top_below = LqOctet(surface.rows[4], surface.rows[5]);
    surface.multiple = lq_stack_multiple(surface.interfaces[0].x, surface.top_eta);
    const float average =
        2.0 * lq_direction_integral(surface.multiple,
                                    lq_energy_weights(surface.top_critical));
    surface.multiple_scale = LQ_INVERSE_PI / max(average, LQ_STACK_LEAST_MULTIPLE);

    surface.base_alpha = clamp(0.5 * (material.facets.alpha_x + material.facets.alpha_y), 0.0, 1.0);
    const vec3 least = vec3(0.0);
    const vec3 most = vec3(LQ_MAX_CONDUCTOR_INDEX);
    surface.base_eta = clamp(material.eta / index_above, least, most);
    surface.base_kappa = clamp(material.kappa / index_above, least, most);
    const LqOctet nothing = LqOctet(vec4(0.0), vec4(0.0));
    surface.base_albedo = LqConductorAlbedo(nothing, nothing, nothing);
    if (surface.base == LQ_STACK_BASE_CONDUCTOR) {
        surface.base_albedo =
            lq_conductor_albedo(surface.base_alpha, surface.base_eta, surface.base_kappa);
    }
    surface.spread = vec3(0.0);
    surface.returned = vec3(0.0);
    surface.arriving = LqCubic(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    if (surface.base == LQ_STACK_BASE_LAMBERTIAN) {
        const LqDiffuseTransport transport = lq_diffuse_transport(surface);
        surface.arriving = transport.arriving;
        const vec3 albedo = clamp(material.albedo, vec3(0.0), vec3(1.0));
        // By reciprocity, what leaves of diffuse light from the base; no more than in clear media.
        const float fraction = 1.0 / (index_above * index_above);
        const vec4 leaving = min(lq_stack_mean_arriving(surface) * fraction, vec4(1.0));
        // Without absorption all that does not leave comes back: that keeps a white base white.
        const vec4 dimmed =
            min(transport.returning / max(transport.returning.w, LQ_TINY_LIGHT), vec4(1.0)) *
            (1.0 - leaving.w);
        const vec3 reflected = albedo / (vec3(1.0) - albedo * vec3(dimmed.x, dimmed.y, dimmed.z));
        surface.spread = reflected * (LQ_INVERSE_PI * fraction);
        const vec4 returned = min(leaving, vec4(leaving.w));
        surface.returned = reflected * vec3(returned.x, returned.y, returned.z);
    }
    return surface;
}

#endif
