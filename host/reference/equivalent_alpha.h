// Which isotropic GGX roughness the energies of another microsurface are looked up at: the tables
// hold GGX only.
//
// An approximation. An anisotropic surface is taken at the mean of its two roughnesses, a Beckmann
// surface at a roughness between 0.5 and 0.95 times its own, since GGX has more of steep facets.
// Both were fitted to simulated T01 of clear interfaces, averaged over azimuths: of the mean,
// geometric mean and root mean square of two roughnesses the first came nearest. What T01 is off by
// (root mean square, greatest), against taking the roughness itself or the geometric mean:
//
//                           fitted         instead
//   beckmann, eta > 1   0.006, 0.022   0.043, 0.156
//   beckmann, eta < 1   0.029, 0.089   0.044, 0.157
//   alpha_y = 2 alpha_x 0.004, 0.011   0.005, 0.017
//             4 alpha_x 0.005, 0.021   0.020, 0.082
//            10 alpha_x 0.020, 0.064   0.039, 0.142
//           100 alpha_x 0.024, 0.075   0.119, 0.375
//
// Albedos of coated surfaces, on 400 random ones each: Beckmann 0.012 in the mean, at most 0.075;
// anisotropic (azimuths included, which this leaves out) 0.020, at most 0.23. Isotropic GGX: 0.001
// and 0.008 (tests/statistical/coated_simulation_test.cpp).
#pragma once

#include "lacquer/material.h"

namespace lacquer::reference {

// In [0, 1]; `eta` = ior below / ior above the interface.
double equivalent_ggx_alpha(const Microsurface& microsurface, double eta);

}  // namespace lacquer::reference
