#include "reference/coated_base.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numbers>

#include "reference/blended_energies.h"
#include "reference/equivalent_alpha.h"
#include "reference/shading.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// No more than a clear medium lets through, whatever the tables are off by.
glm::dvec3 transmitted(const CoatedBase& base, const glm::dvec3& w) {
    const glm::dvec3 entering{base.entering[0].at(w.z), base.entering[1].at(w.z),
                              base.entering[2].at(w.z)};
    return glm::min(entering, glm::dvec3{base.clear.at(w.z)});
}

// One lobe for all channels, so that it is one look-up into prefiltered light. It has the variance
// of all its light: each channel's weighted by its energy, since all have the same mean direction.
double variance_of_all(const CoatedBase& base) {
    double energy = 0.0;
    double spread = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        const TransmissionProfile& profile = base.entering[static_cast<std::size_t>(channel)];
        const double light = profile.average() * base.returned[channel];
        energy += light;
        spread += light * profile.variance();
    }
    return energy > 0.0 ? spread / energy : base.entering[0].variance();
}

// The energies of eq. 3 at a coat, those of its strata taken together as blended_energies.h has it.
class Energies {
 public:
    Energies(const Roughness& roughness, double eta, const EnergyTables& tables)
        : eta_{eta}, tables_{tables} {
        const Blend blend = strata_of(roughness);
        for (const Stratum& stratum : blend.strata)
            alphas_.push_back(equivalent_ggx_alpha(stratum.microsurface, eta));
        facets_ = isotropic_strata(blend, alphas_);
        from_below_ = first_met_by_diffuse_light(facets_);
    }

    TransmissionProfile entering(double tau) const {
        std::vector<DirectionPolynomial> of_strata;
        for (const double alpha : alphas_)
            of_strata.push_back(tables_.t_down_profile(alpha, eta_, tau).polynomial());
        return TransmissionProfile{blended(facets_, of_strata)};
    }

    // T10_bar, by reciprocity.
    double leaving(double tau) const {
        if (is_uniform()) return tables_.t_up(alphas_.front(), eta_, tau);
        const auto at = [&](double t) { return entering(t).average() / (eta_ * eta_); };
        return std::clamp(at(tau), 0.0, std::clamp(at(1.0), 0.0, 1.0));
    }

    // R10_bar: without absorption all that does not leave, which keeps a white base white.
    double reflected_back(double tau) const {
        if (is_uniform()) return tables_.r_up(alphas_.front(), eta_, tau);
        double clear = 0.0, dimmed = 0.0;
        for (std::size_t k = 0; k < alphas_.size(); ++k) {
            clear += from_below_[k] * tables_.r_up(alphas_[k], eta_, 1.0);
            dimmed += from_below_[k] * tables_.r_up(alphas_[k], eta_, tau);
        }
        return clear > 0.0 ? (1.0 - leaving(1.0)) * dimmed / clear : 0.0;
    }

 private:
    bool is_uniform() const { return alphas_.size() == 1; }

    double eta_;
    const EnergyTables& tables_;
    FacetStrata facets_;
    std::vector<double> alphas_;  // of the strata's energies
    StratumShares from_below_;
};

}  // namespace

CoatedBase prepare_coated_base(const Roughness& roughness, double eta, const glm::dvec3& albedo,
                               const glm::dvec3& tau, BaseLobe shape, const EnergyTables& tables) {
    const Energies energies{roughness, eta, tables};
    CoatedBase base{shape,
                    {energies.entering(tau.x), energies.entering(tau.y), energies.entering(tau.z)},
                    energies.entering(1.0),
                    {},
                    {},
                    {}};
    for (int channel = 0; channel < 3; ++channel) {
        const double trapped = albedo[channel] * energies.reflected_back(tau[channel]);
        const double reflected = albedo[channel] / (1.0 - trapped);
        base.returned[channel] = reflected * energies.leaving(tau[channel]);
        base.spread[channel] = reflected / (pi * eta * eta);
    }
    base.lobe = prepare_normal_lobe(variance_of_all(base), tables);
    return base;
}

glm::dvec3 base_lobe(const CoatedBase& base, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (base.shape == BaseLobe::ggx) return base_albedo(base, wo) * normal_lobe(base.lobe, wi);
    return transmitted(base, wi) * transmitted(base, wo) * base.spread;
}

double base_pdf(const CoatedBase& base, const glm::dvec3& wi) {
    if (!is_above(wi)) return 0.0;
    return base.shape == BaseLobe::ggx ? normal_lobe_pdf(base.lobe, wi) : wi.z / pi;
}

glm::dvec3 base_sample(const CoatedBase& base, const glm::dvec2& u) {
    return base.shape == BaseLobe::ggx ? normal_lobe_sample(base.lobe, u) : sample_cosine(u);
}

glm::dvec3 base_albedo(const CoatedBase& base, const glm::dvec3& w) {
    return transmitted(base, w) * base.returned;
}

}  // namespace lacquer::reference
