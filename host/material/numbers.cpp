#include "material/numbers.h"

#include <fmt/format.h>

#include "core/error.h"

namespace lacquer {

namespace {

// Walks a material, keeping the pointer of where it is.
class NumberWalk {
 public:
    explicit NumberWalk(const NumberVisitor& visitor) : visitor_(visitor) {}

    void material(Material& material) const {
        visitor_("/exterior_ior", material.exterior_ior, kIorRange);
        for (std::size_t i = 0; i < material.layers.size(); ++i) {
            const std::string pointer = fmt::format("/layers/{}", i);
            Interface& interface = material.layers[i].interface;
            visitor_(pointer + "/interface/ior", interface.ior, kIorRange);
            roughness(pointer + "/interface", interface.roughness);
            std::visit([&](auto& m) { medium(pointer + "/medium", m); }, material.layers[i].medium);
        }
        std::visit([&](auto& b) { base(b); }, material.base);
    }

 private:
    void rgb(const std::string& pointer, Rgb& channels, const NumberRange& range) const {
        for (std::size_t i = 0; i < channels.size(); ++i)
            visitor_(fmt::format("{}/{}", pointer, i), channels[i], range);
    }

    void rgb(const std::string& pointer, std::optional<Rgb>& channels,
             const NumberRange& range) const {
        if (channels) rgb(pointer, *channels, range);
    }

    void alpha(const std::string& pointer, Microsurface& microsurface) const {
        visitor_(pointer + "/alpha/0", microsurface.alpha[0], kAlphaRange);
        visitor_(pointer + "/alpha/1", microsurface.alpha[1], kAlphaRange);
    }

    void roughness(const std::string& pointer, Roughness& roughness) const {
        if (auto* uniform = std::get_if<Microsurface>(&roughness)) {
            alpha(pointer, *uniform);
            return;
        }
        std::vector<Stratum>& strata = std::get<Blend>(roughness).strata;
        for (std::size_t i = 0; i < strata.size(); ++i) {
            const std::string here = fmt::format("{}/blend/strata/{}", pointer, i);
            if (i + 1 < strata.size()) visitor_(here + "/weight", strata[i].weight, kWeightRange);
            alpha(here, strata[i].microsurface);
            rgb(here + "/eta", strata[i].eta, kConductorEtaRange);
            rgb(here + "/kappa", strata[i].kappa, kConductorKappaRange);
            rgb(here + "/albedo", strata[i].albedo, kAlbedoRange);
        }
    }

    void medium(const std::string& pointer, AbsorbingMedium& medium) const {
        rgb(pointer + "/tau", medium.tau, kTauRange);
    }

    void medium(const std::string& pointer, ScatteringMedium& medium) const {
        rgb(pointer + "/sigma_a", medium.sigma_a, kSigmaRange);
        rgb(pointer + "/sigma_s", medium.sigma_s, kSigmaRange);
        visitor_(pointer + "/g", medium.g, kAnisotropyRange);
        visitor_(pointer + "/thickness", medium.thickness, kThicknessRange);
    }

    void base(LambertianBase& base) const {
        rgb("/base/lambertian/albedo", base.albedo, kAlbedoRange);
    }

    void base(ConductorBase& base) const {
        rgb("/base/conductor/eta", base.eta, kConductorEtaRange);
        rgb("/base/conductor/kappa", base.kappa, kConductorKappaRange);
        roughness("/base/conductor", base.roughness);
    }

    void base(DiffuseFacetsBase& base) const {
        rgb("/base/diffuse_facets/albedo", base.albedo, kAlbedoRange);
        roughness("/base/diffuse_facets", base.roughness);
    }

    void base(NoBase&) const {}

    const NumberVisitor& visitor_;
};

// Gives the last stratum of a blend what the others leave; returns that.
double settle_last_weight(Blend& blend) {
    double rest = 1.0;
    for (std::size_t i = 0; i + 1 < blend.strata.size(); ++i) rest -= blend.strata[i].weight;
    blend.strata.back().weight = rest;
    return rest;
}

// Every blend of a material.
template <typename Function>
void for_each_blend(Material& material, const Function& function) {
    const auto apply = [&](Roughness& roughness) {
        if (auto* blend = std::get_if<Blend>(&roughness)) function(*blend);
    };
    for (Layer& layer : material.layers) apply(layer.interface.roughness);
    if (auto* conductor = std::get_if<ConductorBase>(&material.base)) apply(conductor->roughness);
    if (auto* facets = std::get_if<DiffuseFacetsBase>(&material.base)) apply(facets->roughness);
}

// What the ranges of single numbers do not say.
void check_ior_ratios(const Material& material, std::string_view pointer) {
    double above = material.exterior_ior;
    for (const Layer& layer : material.layers) {
        const double below = layer.interface.ior;
        if (!is_ior_ratio_allowed(below, above))
            throw Error{fmt::format("material '{}': {}: {} below {} is a ratio outside {}",
                                    material.name, pointer, below, above, kIorRatioRange.text())};
        above = below;
    }
}

// Whether `pointer` is `place` or an element of the array at `place`.
bool is_at(std::string_view pointer, std::string_view place) {
    if (!pointer.starts_with(place)) return false;
    const std::string_view rest = pointer.substr(place.size());
    return rest.empty() || (rest[0] == '/' && rest.size() == 2 && rest[1] >= '0' && rest[1] <= '9');
}

}  // namespace

void visit_numbers(Material& material, const NumberVisitor& visitor) {
    NumberWalk{visitor}.material(material);
}

Material with_number(const Material& material, std::string_view pointer, double value) {
    Material changed = material;
    bool found = false;
    visit_numbers(changed, [&](const std::string& place, double& number, const NumberRange& range) {
        if (!is_at(place, pointer)) return;
        if (!range.contains(value))
            throw Error{fmt::format("material '{}': {}: {} is outside {}", material.name, pointer,
                                    value, range.text())};
        number = value;
        found = true;
    });
    if (!found)
        throw Error{
            fmt::format("material '{}': {}: no number stands there", material.name, pointer)};
    check_ior_ratios(changed, pointer);
    for_each_blend(changed, [&](Blend& blend) {
        if (settle_last_weight(blend) <= 0.0)
            throw Error{fmt::format(
                "material '{}': {}: with {} the weights leave nothing for the last stratum",
                material.name, pointer, value)};
    });
    return changed;
}

Material rounded_to_float(const Material& material) {
    Material rounded = material;
    const auto round = [](double value) { return static_cast<double>(static_cast<float>(value)); };
    visit_numbers(rounded, [&](const std::string&, double& number, const NumberRange&) {
        number = round(number);
    });
    for_each_blend(rounded, [&](Blend& blend) {
        blend.strata.back().weight = round(settle_last_weight(blend));
    });
    return rounded;
}

Material as_shaders_read(const Material& material) {
    Material relative = material;
    const auto divide = [&](Rgb& index) {
        for (double& channel : index) channel /= material.exterior_ior;
    };
    for (Layer& layer : relative.layers) layer.interface.ior /= material.exterior_ior;
    if (auto* conductor = std::get_if<ConductorBase>(&relative.base)) {
        divide(conductor->eta);
        divide(conductor->kappa);
        if (auto* blend = std::get_if<Blend>(&conductor->roughness))
            for (Stratum& stratum : blend->strata) {
                if (stratum.eta) divide(*stratum.eta);
                if (stratum.kappa) divide(*stratum.kappa);
            }
    }
    relative.exterior_ior = 1.0;
    return rounded_to_float(relative);
}

}  // namespace lacquer
