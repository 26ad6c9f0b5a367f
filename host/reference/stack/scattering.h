// What a plane slab of a scattering medium does to light that crosses it, in closed form: how much
// is transmitted and sent back, all orders of scattering, and how wide it is. One colour at a time,
// one direction at a time. The phase function is Henyey and Greenstein's.
// Based on: Joseph, Wiscombe and Weinman 1976, The Delta-Eddington Approximation for Radiative Flux
//           Transfer; Meador and Weaver 1980, Two-Stream Approximations to Radiative Transfer in
//           Planetary Atmospheres; van de Hulst 1980, Multiple Light Scattering (similarity);
//           Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, section 4.4
//
// Differs from Belcour 2018, section 4.4: that follows the light scattered once, and none of it
// back. Here a beam that fades feeds two diffuse streams, whose coefficients were fitted to
// simulated slabs; so were the widths. Measured in
// tests/statistical/scattering_simulation_test.cpp.
#pragma once

#include <cstddef>

#include "lacquer/material.h"

namespace lacquer::reference {

// Optical depths along the normal, >= 0; g in [-0.99, 0.99] is the mean cosine of the phase
// function.
struct ScatteringSlab {
    double absorption = 0.0;  // sigma_a times thickness
    double scattering = 0.0;  // sigma_s times thickness
    double g = 0.0;
};

ScatteringSlab scattering_slab(const ScatteringMedium& medium, std::size_t channel);

// Shares of the light that came, none below 0; what is missing to 1 is absorbed. Without absorption
// nothing is missing but rounding.
struct SlabLight {
    double unscattered = 0.0;  // keeps its direction
    double scattered = 0.0;    // leaves through the other side
    double back = 0.0;         // leaves through the side it came from

    double transmitted() const { return unscattered + scattered; }
};

// Of light at cos_theta in (0, 1]. Meador and Weaver 1980, Eqs. 14 and 15, in another notation.
SlabLight slab_light(const ScatteringSlab& slab, double cos_theta);

// How wide light is that was parallel: its variance (that of the direction projected to the disk,
// both axes together: 0.5 for a Lambertian lobe) and its mean sine over that of the light that
// came.
struct SlabLobe {
    double spread = 0.0;
    double sine_ratio = 1.0;
};

// Of all transmitted light, what was not scattered included: the lobe to take where there is but
// one for both.
SlabLobe transmitted_lobe(const ScatteringSlab& slab, double cos_theta);

// Of the scattered part alone, to be kept beside a lobe that stays as narrow as it was: closer to
// the truth as long as much is not scattered. `light` of the same slab and direction.
SlabLobe scattered_lobe(const ScatteringSlab& slab, double cos_theta, const SlabLight& light);

// Of the light that comes back, about the mirror direction; nearly Lambertian, but for grazing
// light and g above 0.6, which stays oblique.
SlabLobe back_lobe(const ScatteringSlab& slab, double cos_theta);

// Roughness, in (0, 0.95], of the GGX lobe about the mirror direction of light at cos_theta in
// [0.05, 1] that is as wide: width_of_alpha of that is the width that adds to a
// beam's (lobe_width.h).
// Measured behind lobes of alpha up to 0.3: widths within 0.08.
double alpha_of_spread(double spread, double cos_theta);

// The paper's own, to be compared: Belcour 2018, Eq. 22, and Eq. 15 for what is not scattered.
// Nothing comes back, and what is scattered twice is lost.
SlabLight slab_light_2018(const ScatteringSlab& slab, double cos_theta);

// What one forward scattering adds to a beam's variance, for g in (0, 1]. Belcour 2018, Eq. 21.
double scattering_variance_2018(double g);

}  // namespace lacquer::reference
