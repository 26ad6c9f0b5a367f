// The surface that `lq_coated_*` shades: one rough dielectric coat over an absorbing medium over a
// Lambertian base, prepared once per shading point for any number of lights.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces
#ifndef LQ_COATED_SURFACE_GLSL
#define LQ_COATED_SURFACE_GLSL

#include "../interface/energies.glsl"
#include "../microfacet/equivalent_alpha.glsl"

// How the light that has met the base is distributed.
const int LQ_BASE_LOBE_EXACT = 0;  // as it is; reciprocal
const int LQ_BASE_LOBE_GGX = 1;    // a GGX lobe about the normal, for prefiltered lighting

// `eta` = ior of the coat over that of the exterior, in [1/3, 3]; `tau` in [0, 1], transmittance of
// the coat along its normal; `albedo` of the base in [0, 1]; `base_lobe` one of LQ_BASE_LOBE_*: 0,
// light leaves as it does, or 1, as a GGX lobe about the normal, for prefiltered lighting.
struct LqCoatedMaterial {
    LqFacets coat;
    float eta;
    vec3 tau;
    vec3 albedo;
    int base_lobe;
};

// `returned` is what base and coat make of light that has entered: rho T10_bar / (1 - rho R10_bar);
// `spread` is rho / (pi eta^2 (1 - rho R10_bar)); `multiple_scale` is of m(wi) m(wo), m
// the light that the coat reflects after more than one facet. `lobe_alpha` is the GGX base lobe's,
// `lobe_energy` what its single scattering keeps of light along the normal.
struct LqCoatedSurface {
    LqFacets coat;
    float eta;
    int base_lobe;
    LqInterface energies;
    vec3 returned;
    vec3 spread;
    float multiple_scale;
    float lobe_alpha;
    float lobe_energy;
};

// What is known once the viewer is: a light then costs one look at the surface's functions of
// direction. `coat` and `base` are what each sends to the viewer of light from everywhere, its
// directional albedo; `multiple` the part of `coat` that has met more than one facet.
struct LqCoatedView {
    vec3 wo;
    float coat;
    vec3 base;
    vec3 entering;
    float multiple;
};

// Roughness of one GGX lobe for all channels, with the variance of all the light that leaves.
float lq_coated_base_alpha(const LqInterface energies, const vec3 returned) {
    const vec4 entering = energies.entering;
    const vec3 light = vec3(entering.x, entering.y, entering.z) * returned;
    const float sum = light.x + light.y + light.z;
    const vec3 spreads = lq_interface_spread(energies);
    const float spread = sum > LQ_MIN_ENERGY ? dot(light, spreads) / sum : spreads.x;
    return clamp(lq_equivalent_alpha(energies.critical, spread), LQ_MIN_ALPHA, 1.0);
}

// The surface for shading: call it once per shading point. What is out of range is clamped.
LqCoatedSurface lq_coated_prepare(const LqCoatedMaterial material) {
    const float eta = clamp(material.eta, LQ_MIN_ETA, LQ_MAX_ETA);
    const vec3 tau = clamp(material.tau, vec3(0.0), vec3(1.0));
    const vec3 albedo = clamp(material.albedo, vec3(0.0), vec3(1.0));
    LqCoatedSurface surface;
    surface.coat =
        lq_facets_prepare(material.coat.ndf, material.coat.alpha_x, material.coat.alpha_y);
    surface.eta = eta;
    surface.base_lobe = material.base_lobe;
    surface.energies =
        lq_interface_prepare(lq_equivalent_energy_alpha(material.coat, eta), eta, tau);
    surface.multiple_scale = lq_multiple_scale(surface.energies.multiple_average);
    // The base reflects again what the coat sends back: a geometric series.
    const vec3 reflected = albedo / (vec3(1.0) - albedo * surface.energies.r_up);
    surface.returned = reflected * surface.energies.t_up;
    surface.spread = reflected * (LQ_INVERSE_PI / (eta * eta));
    surface.lobe_alpha = 1.0;
    surface.lobe_energy = 1.0;
    if (material.base_lobe == LQ_BASE_LOBE_GGX) {
        surface.lobe_alpha = lq_coated_base_alpha(surface.energies, surface.returned);
        surface.lobe_energy = lq_normal_lobe_energy(surface.lobe_alpha);
    }
    return surface;
}

// For any number of lights; `wo` above the surface.
LqCoatedView lq_coated_view(const LqCoatedSurface surface, const vec3 wo) {
    const float cos_theta_o = clamp(wo.z, 0.0, 1.0);
    const vec4 t_down = lq_interface_t_down(surface.energies, cos_theta_o);
    const vec3 entering = vec3(t_down.x, t_down.y, t_down.z);
    return LqCoatedView(wo, 1.0 - t_down.w, entering * surface.returned, entering,
                        lq_interface_fgd_multiple(surface.energies, cos_theta_o));
}

#endif
