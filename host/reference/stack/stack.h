// The model `stack` in double precision: any number of rough dielectric interfaces and media that
// absorb and scatter, over a rough conductor, a Lambertian base or nothing, with all reflections
// between them.
//
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators; de Dinechin and Belcour 2022, Rendering Layered Materials
//           with Diffuse Interfaces
//
// The top interface's lobe is the coat's of coat.h; the others are GGX lobes about the mirror
// direction, whose energy and roughness come from transport.h (2018, Eq. 39); a Lambertian base
// adds the exact lobe of diffuse_base.h, and no base at all those of transmission.h: then light
// comes from below as well. Viewers are above.
//
// In the forward model the GGX lobes follow from the viewer's direction alone and are not
// reciprocal; in the symmetric one (symmetric.h) all that is reflected is. That looks at the stack
// from four directions once, where the forward model follows the light for every viewer.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "lacquer/material.h"
#include "reference/coat.h"
#include "reference/shading.h"
#include "reference/stack/diffuse_base.h"
#include "reference/stack/layers.h"
#include "reference/stack/symmetric.h"
#include "reference/stack/transmission.h"

namespace lacquer::reference {

// Whether a conductor has a lobe of its own, or one with the interfaces above it.
enum class ConductorLobe { own, shared };

struct StackSurface {
    StackLayers layers;
    Coat top;
    ConductorLobe conductor_lobe = ConductorLobe::own;
    std::optional<DiffuseBase> diffuse;
    std::optional<SymmetricLight> symmetric;  // none in the forward model
};

enum class StackLobes { forward, symmetric };

// `tables` must outlive the result. See prepare_layers for what it throws.
StackSurface prepare_stack(const Material& material, const EnergyTables& tables,
                           StackLobes lobes = StackLobes::forward,
                           ConductorLobe conductor_lobe = ConductorLobe::own);

// A GGX lobe of light that was reflected below the top interface.
struct StackLobe {
    glm::dvec3 energy;
    double alpha;
    double mirrored;  // what single reflections by facets of alpha have of it at wo
};

// A stack as one viewer sees it.
struct StackView {
    StackSurface const* surface;
    glm::dvec3 wo;
    double top;                    // what the top interface reflects
    std::vector<StackLobe> lobes;  // of the interfaces below it, if any, and of a conductor
    glm::dvec3 arriving;           // T(wo)
    std::vector<TransmissionLobe> transmission;
    // Probabilities of the top interface, of the lobes, of a diffuse base, and of transmission.
    std::vector<double> choice;
};

// `wo` above the surface; `surface` must outlive the result.
StackView view(const StackSurface& surface, const glm::dvec3& wo);

// As below, for a viewer who looks at many lights.
glm::dvec3 eval(const StackView& view, const glm::dvec3& wi);
double pdf(const StackView& view, const glm::dvec3& wi);
Sample sample(const StackView& view, const glm::dvec3& u);

// f(wi, wo), per steradian, for radiance over the square of the index (transmission.h); 0 where wo
// is not above the surface, and for light from below unless there is no base.
glm::dvec3 eval(const StackSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi; 0 where eval is.
double pdf(const StackSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3: u.x chooses a lobe in proportion to
// its energy, averaged over the channels, but each that has some at least with kMinChoice / count;
// (u.y, u.z) choose the direction, the pdf is that of all lobes together (2018, Eq. 40). A
// direction on the wrong side of the surface for its lobe has pdf 0.
Sample sample(const StackSurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fraction of light from every direction that is sent to wo, and of light along wo what leaves
// below; 0 unless wo is above.
Albedo albedo(const StackSurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
