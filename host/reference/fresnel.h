// Reflectance of a smooth boundary for unpolarised light.
// Based on: Born and Wolf 1999, Principles of Optics, sections 1.5 and 14.2
#pragma once

#include <complex>

namespace lacquer::reference {

// Fraction of light reflected, for cos_theta_i in [0, 1] and `eta` = index of the far side over
// that of the side of incidence: real for a dielectric, eta + i kappa with kappa >= 0 for a
// conductor. 1 under total internal reflection.
double fresnel(double cos_theta_i, std::complex<double> eta);

}  // namespace lacquer::reference
