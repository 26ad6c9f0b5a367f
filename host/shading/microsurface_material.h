// A rough surface as the shader source takes it: include after shader_float.h or shader_double.h.
#pragma once

#include "lacquer/bsdf.h"
#include "shading/microsurface_parameters.h"

namespace lacquer {

using shader::Real;

namespace {

Vec3<Real> to_vector(const Rgb& rgb) {
    return {static_cast<Real>(rgb[0]), static_cast<Real>(rgb[1]), static_cast<Real>(rgb[2])};
}

shader::LqFacets to_facets(const Microsurface& microsurface) {
    return {microsurface.ndf == Ndf::beckmann ? shader::LQ_NDF_BECKMANN : shader::LQ_NDF_GGX,
            static_cast<Real>(microsurface.alpha[0]), static_cast<Real>(microsurface.alpha[1])};
}

shader::LqMicrosurfaceMaterial to_microsurface(const MicrosurfaceParameters& parameters) {
    const auto stratum = [&](std::size_t k) -> shader::LqStratum {
        if (k >= parameters.strata.size()) return {{0, Real{1}, Real{1}}, Real{0}, {}, {}};
        const MicrosurfaceParameters::Stratum& own = parameters.strata[k];
        return {to_facets(own.microsurface), static_cast<Real>(own.weight), to_vector(own.eta),
                to_vector(own.kappa)};
    };
    const bool is_mixed = parameters.op == Blend::Operator::symmetric;
    return {is_mixed ? shader::LQ_BLEND_SYMMETRIC : shader::LQ_BLEND_ASYMMETRIC,
            static_cast<int>(parameters.strata.size()),
            static_cast<Real>(parameters.eta),
            to_vector(parameters.optical_depth),
            stratum(0),
            stratum(1),
            stratum(2),
            stratum(3)};
}

}  // namespace
}  // namespace lacquer
