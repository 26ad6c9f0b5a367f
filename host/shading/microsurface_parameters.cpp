#include "shading/microsurface_parameters.h"

#include "core/model_scope.h"
#include "shading/optical_depth.h"

namespace lacquer {

namespace {

using Stratum = MicrosurfaceParameters::Stratum;

// A uniform surface is one stratum.
void add_strata(MicrosurfaceParameters& parameters, const Roughness& roughness) {
    if (const auto* uniform = std::get_if<Microsurface>(&roughness)) {
        parameters.strata.push_back({*uniform});
        return;
    }
    const Blend& blend = std::get<Blend>(roughness);
    parameters.op = blend.op;
    for (const lacquer::Stratum& stratum : blend.strata)
        parameters.strata.push_back({stratum.microsurface, stratum.weight});
}

void set_metals(MicrosurfaceParameters& parameters, const ConductorBase& base,
                double exterior_ior) {
    const auto* blend = std::get_if<Blend>(&base.roughness);
    for (std::size_t k = 0; k < parameters.strata.size(); ++k) {
        const lacquer::Stratum own = blend != nullptr ? blend->strata[k] : lacquer::Stratum{};
        Stratum& stratum = parameters.strata[k];
        stratum.eta = relative_index(own.eta.value_or(base.eta), exterior_ior);
        stratum.kappa = relative_index(own.kappa.value_or(base.kappa), exterior_ior);
    }
}

}  // namespace

MicrosurfaceParameters microsurface_parameters(const Material& material, Model model) {
    require_shadeable(material, model);
    MicrosurfaceParameters parameters;
    if (const auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        add_strata(parameters, conductor->roughness);
        set_metals(parameters, *conductor, material.exterior_ior);
        return parameters;
    }
    const Layer& layer = material.layers.front();
    add_strata(parameters, layer.interface.roughness);
    parameters.eta = layer.interface.ior / material.exterior_ior;
    parameters.optical_depth = optical_depth(layer.medium);
    return parameters;
}

}  // namespace lacquer
