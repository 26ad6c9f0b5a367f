// A rough surface as the shader source takes it: include after shader_float.h or shader_double.h.
#pragma once

#include "lacquer/bsdf.h"
#include "shading/microsurface_parameters.h"
#include "shading/several_facets_rows.h"

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

inline shader::LqSeveralFacetsSide to_several_facets_side(const glm::vec4* rows) {
    const auto colour = [&](int n) { return shader::vec3{rows[n]}; };
    const auto fit = [&](int n) -> shader::LqAlbedoFit {
        return {colour(n),     colour(n + 1), colour(n + 2), colour(n + 3),
                colour(n + 4), colour(n + 5), colour(n + 6)};
    };
    return {fit(0), fit(7), rows[15].x, rows[15].y, colour(14), rows[14].w};
}

// What float would lose of the rest of sums of 1 is found out in double, as for the backends.
inline shader::LqSeveralFacets to_several_facets(const MicrosurfaceParameters& parameters) {
    if constexpr (sizeof(Real) == sizeof(double)) {
        return lq_several_facets(lq_microsurface_prepare(to_microsurface(parameters)));
    } else {
        const auto rows = several_facets_rows(parameters);
        return {{rows[0].x > 0, rows[0].y, rows[0].z},
                to_several_facets_side(rows.data() + 1),
                to_several_facets_side(rows.data() + 1 + kSeveralFacetsSideRows)};
    }
}

}  // namespace
}  // namespace lacquer
