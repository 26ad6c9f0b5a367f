// The cosine axis of tables over directions: a coordinate s in [0, 1] that spends its nodes where
// the Fresnel equations bend.
#pragma once

namespace lacquer {

// Which side of 1 the relative index eta = ior below / ior above lies on. Light that enters a
// thinner medium meets a critical angle; light that enters a denser one does not.
enum class Contrast { thin, dense };

// thin for eta < 1.
Contrast contrast_of(double eta);

// Cosine of the critical angle; 0 for eta >= 1.
double critical_cosine(double eta);

// dense: s = sqrt(cos_theta). thin: s = 1/2 at the critical cosine c, quadratic on both sides of
// it: cos_theta = c (1 - t^2) for t = 1 - 2 s >= 0, else c + (1 - c) t^2.
double profile_coordinate(double cos_theta, double eta);

// The cosine of a coordinate, for the contrast of the table that holds eta (both hold eta = 1).
double profile_cosine(double s, Contrast contrast, double eta);

}  // namespace lacquer
