// A surface of at most one coat over a simple base, as `plain` and the models it is compared with
// shade it, and the lobes that all of these are made of.
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "core/model.h"
#include "lacquer/material.h"
#include "reference/facets.h"
#include "reference/shading.h"

namespace lacquer::reference {

// The top interface, seen from the exterior, and the medium below it.
struct CoatLayer {
    Facets facets;
    double eta;           // index below over index of the exterior
    glm::dvec3 tau{1.0};  // the medium's transmittance along the normal
};

// Index relative to the exterior, per colour channel.
struct Conductor {
    Facets facets;
    std::array<std::complex<double>, 3> eta;
};

// At most one of `albedo` and `conductor` is there: neither where the base is "none".
struct OneCoat {
    std::optional<CoatLayer> coat;
    std::optional<glm::dvec3> albedo;  // a Lambertian base
    std::optional<Conductor> conductor;
};

// Takes the first layer and the base of a material; diffuse facets are shaded as Lambertian. Throws
// Error naming the JSON pointer of what `model` cannot shade.
OneCoat prepare_one_coat(const Material& material, Model model);

// Index of the medium above the base, over that of the exterior.
double eta_above_base(const OneCoat& surface);

// The coat's single reflections, for wi and wo above the surface; 0 without a coat.
double coat_lobe(const OneCoat& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Their directional albedo, to 1e-7.
double coat_albedo(const OneCoat& surface, const glm::dvec3& wo);

// What the base, in a medium of index `eta_above` over the exterior's, would reflect at this angle
// were it smooth: its albedo, or its Fresnel reflectance. 0 where there is none.
glm::dvec3 base_reflectance(const OneCoat& surface, double cos_theta, double eta_above);

// The base's f in that medium, without a coat.
glm::dvec3 base_lobe(const OneCoat& surface, const glm::dvec3& wi, const glm::dvec3& wo,
                     double eta_above);

// The integral over wi above the surface of base_lobe(wi, wo) factor(wi) cos_theta_i, per channel,
// to 1e-7. `factor` is smooth.
using RgbFactor = std::function<glm::dvec3(const glm::dvec3& wi)>;
glm::dvec3 base_integral(const OneCoat& surface, const glm::dvec3& wo, double eta_above,
                         const RgbFactor& factor);

// The base's directional albedo without a coat, below the exterior.
glm::dvec3 base_albedo(const OneCoat& surface, const glm::dvec3& wo);

// The probability of choosing the coat where it reflects the fraction `coat` of the light and the
// base `base`: coat / (coat + base), kept within [kMinChoice, 1 - kMinChoice]; kMinChoice where
// both are 0, 1 without a base and 0 without a coat.
double coat_choice(const OneCoat& surface, double coat, double base);

// The density of `sample_mixture`: 0 unless both directions are above the surface.
double mixture_pdf(const OneCoat& surface, double coat_choice, const glm::dvec3& wi,
                   const glm::dvec3& wo);

// A direction from the coat with probability `coat_choice`, or else from the base, whichever u.x
// chooses; (u.y, u.z) choose the direction: a visible normal's mirror direction, or for a
// Lambertian base a cosine-weighted one. Its weight follows from eval(wi).
Sample sample_mixture(const OneCoat& surface, double coat_choice, const glm::dvec3& wo,
                      const glm::dvec3& u,
                      const std::function<glm::dvec3(const glm::dvec3& wi)>& eval);

}  // namespace lacquer::reference
