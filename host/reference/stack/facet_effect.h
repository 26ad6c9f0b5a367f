// What the facets of a rough interface do to the mean of a lobe and to its width, apart from
// mirroring it.
#pragma once

namespace lacquer::reference {

struct FacetEffect {
    // Of the mean cosine of what is reflected, against that of perfect mirrors: below 0 where steep
    // facets reflect more, at total reflection above all.
    double reflected_tilt = 0.0;
    double reflected_width = 1.0;  // of its spread, against that of perfect mirrors
    double refracted_sine = 0.0;   // of the mean of what is refracted
    // Of the one direction that crosses what lies below as all of it does: into a denser medium
    // halfway to that of the mean cosine, which is less.
    double crossing_sine = 0.0;
};

// Of light that arrives at `cosine` in [0, 1] at facets of roughness `alpha` in [0, 1] and relative
// index `eta` = index of the other medium / index of the light's. Refracted light is more oblique
// than the refracted mean, which Belcour 2018 neglects (Eq. 5).
FacetEffect facet_effect(double cosine, double alpha, double eta);

// Of refracted light: how a lobe's roughness scales, and the roughness that the facets add.
struct RefractedRoughness {
    double scale, added;
};

// `cosine` before and `refracted_cosine`, above 0, after. Snell's law scales the projected disk by
// 1 / eta, and a lobe of roughness alpha is alpha cos_theta wide there. The facets' part is Eq. 10
// of Belcour 2018 with cosines as magnitudes; but reflections by facets of more than cos_theta^2
// lean far up from grazing, where light refracted by such facets stays close to it (by simulation:
// with this bound mean cosines into thinner media are 0.026 off instead of 0.068).
RefractedRoughness refracted_roughness(double cosine, double refracted_cosine, double alpha,
                                       double eta);

}  // namespace lacquer::reference
