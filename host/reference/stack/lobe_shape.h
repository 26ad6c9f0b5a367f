// Width and mean of a lobe of light between the interfaces of a stack, and what one rough interface
// makes of them.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, Eqs. 5-13
//
// A lobe is a GGX reflection lobe: of light that arrives at the angle of its mean and meets facets
// of some roughness. Its variance is counted in the space in which reflections add up.
#pragma once

namespace lacquer::reference {

struct LobeShape {
    double sine = 0.0;      // of the mean direction against the normal, in [0, 1]
    double variance = 0.0;  // f(alpha) of the lobe's roughness
};

double cosine_of(const LobeShape& shape);

// f(alpha) = alpha^1.1 / (1 - alpha^1.1), and back. Eq. 6; alpha in [0, 1], of 1 finite.
double variance_of_alpha(double alpha);
double alpha_of_variance(double variance);

// The mean moved towards the normal by `cosine_step`, or away from it by a negative one.
LobeShape tilted(const LobeShape& shape, double cosine_step);

// The variance of a lobe that is so much less spread on the projected disk (a ratio of squares of
// widths, in [0, 1]).
double narrowed(double variance, double spread_ratio);

// Facets of roughness `alpha` reflect a lobe: what they add to its variance. The mean is mirrored.
// Eqs. 8 and 9.
double reflection_variance(double alpha);

// Facets refract a lobe: its mean in the other medium, and its variance there.
struct Refraction {
    double sine;
    double widening;  // of the variance it had
    double added;     // by the facets

    double variance(double before) const { return widening * before + added; }
};

// At facets of roughness `alpha`, into a medium of `ratio` = index of the lobe's medium / index of
// the other one. Snell's law scales the projected disk by `ratio`, and a lobe of roughness alpha is
// alpha cos_theta wide there, so that its roughness scales by ratio cos_theta_i / cos_theta_t. The
// mean is that of the light that facets refract, which is more oblique than the refracted mean
// (Belcour neglects that).
Refraction refraction(const LobeShape& shape, double alpha, double ratio);

// How much closer to the normal light is reflected by facets of roughness `alpha` and relative
// index `eta` than by mirrors, as a difference of mean cosines: below 0 where steep facets reflect
// more, at total reflection above all.
double reflection_tilt(const LobeShape& shape, double alpha, double eta);

}  // namespace lacquer::reference
