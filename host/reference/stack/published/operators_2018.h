// The operators of Belcour 2018, section 4, as published: what one interface does to the mean of a
// lobe and to its variance, in the paper's linear space. No model here uses them; they are measured
// beside those of the folder above. Those of media are in scattering.h (slab_light_2018,
// scattering_variance_2018).
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators
//
// The paper's eta_12 is the index of the light's own medium over that of the other: 1 / eta here.
// Cosines are magnitudes.
#pragma once

namespace lacquer::reference::published_2018 {

// The variance of a lobe of roughness alpha in [0, 1), and back. Eq. 6.
double variance_of_alpha(double alpha);
double alpha_of_variance(double variance);

// Of the mean of refracted light, from that of the light that came: at most 1, which it would
// exceed beyond the critical angle. Eq. 12.
double refracted_sine(double sine, double eta);

// The roughness of the reflection that stands for the refraction of a single ray, over that of the
// facets. Eq. 10; its plus sign is a minus where both cosines are magnitudes, since the refracted
// direction's own is negative.
double refraction_scale(double cosine, double refracted_cosine, double eta);

// The same with the plus sign of print.
double refraction_scale_as_printed(double cosine, double refracted_cosine, double eta);

// The rule of thumb to equate the peaks of both lobes, at normal incidence and for all angles, as
// Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks, equate peaks. Peaks by
// Walter et al. 2007, Eqs. 20 and 21. Equated at every angle they give Eq. 10.
double peak_scale(double eta);

// Of a lobe of this variance that crosses smooth facets. Eq. 13, whose sigma_i / eta_12 widens it
// on its way into a denser medium...
double refracted_variance_as_printed(double variance, double eta);

// ... where Snell's law narrows it: sigma_i times eta_12.
double refracted_variance(double variance, double eta);

}  // namespace lacquer::reference::published_2018
