#include "heightfield/rough_surface.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

#include "core/error.h"
#include "simulator/stack.h"

namespace lacquer::heightfield {

namespace {

using simulator::Facets;
using simulator::FacetStratum;

// Ratios of alphas that differ by less are those of the same numbers rounded.
constexpr double kSameRatio = 1e-9;

bool is_flat(const Facets& facets) {
    return facets.alpha_x == 0.0 && facets.alpha_y == 0.0;
}

// What keeps strata from being a heightfield: which one, the key of the material file, and why.
struct Obstacle {
    std::size_t stratum;
    std::string key, reason;
};

std::optional<Obstacle> obstacle(std::span<const FacetStratum> strata) {
    const Facets* first = nullptr;
    for (std::size_t n = 0; n < strata.size(); ++n) {
        const Facets& facets = strata[n].facets;
        if (is_flat(facets)) continue;
        if (facets.ndf != Ndf::beckmann)
            return Obstacle{n, "ndf",
                            "'ggx' is not the distribution of a Gaussian heightfield, which has "
                            "'beckmann'"};
        if (facets.alpha_x == 0.0 || facets.alpha_y == 0.0)
            return Obstacle{n, "alpha",
                            fmt::format("[{}, {}]: a heightfield is rough along both axes or along "
                                        "none",
                                        facets.alpha_x, facets.alpha_y)};
        if (first == nullptr) first = &facets;
        const double other = facets.alpha_x * first->alpha_y;
        if (std::abs(facets.alpha_y * first->alpha_x - other) > kSameRatio * other)
            return Obstacle{
                n, "alpha",
                fmt::format("[{}, {}]: stretching a heightfield keeps the ratio of the "
                            "alphas, here that of [{}, {}]",
                            facets.alpha_x, facets.alpha_y, first->alpha_x, first->alpha_y)};
    }
    return std::nullopt;
}

// Where the roughness of the surface stands in the material file, and what it is.
struct Place {
    std::string pointer;
    const Roughness* roughness = nullptr;
};

Place place_of(const Material& material) {
    if (!material.layers.empty())
        return {"/layers/0/interface", &material.layers.front().interface.roughness};
    if (const auto* conductor = std::get_if<ConductorBase>(&material.base))
        return {"/base/conductor", &conductor->roughness};
    return {"/base/diffuse_facets", &std::get<DiffuseFacetsBase>(material.base).roughness};
}

[[noreturn]] void refuse(const Material& material, const std::string& what) {
    throw Error{fmt::format("material '{}': {}", material.name, what)};
}

void require_heightfield(const Material& material, std::span<const FacetStratum> strata) {
    const auto [pointer, roughness] = place_of(material);
    const auto* blend = std::get_if<Blend>(roughness);
    if (blend != nullptr && blend->op == Blend::Operator::symmetric)
        refuse(material, pointer +
                             "/blend/operator: 'symmetric' mixes facets at every height, as no "
                             "stretched heightfield does; 'asymmetric' does not");
    if (const auto found = obstacle(strata))
        refuse(material,
               fmt::format("{}/{}{}: {}", pointer,
                           blend == nullptr ? "" : fmt::format("blend/strata/{}/", found->stratum),
                           found->key, found->reason));
}

}  // namespace

void require_stretchable(std::span<const FacetStratum> strata) {
    if (strata.empty()) throw Error{"a heightfield needs at least one stratum of facets"};
    if (const auto found = obstacle(strata))
        throw Error{fmt::format("stratum {} of a heightfield: {} {}", found->stratum, found->key,
                                found->reason)};
}

RoughSurface rough_surface(const Material& material) {
    const simulator::StackWalk stack{material};
    const simulator::SurfaceWalk* surface = stack.only_surface();
    if (surface == nullptr)
        refuse(material,
               "a heightfield stands for one rough surface alone: 'layers' absent over a "
               "'conductor' or 'diffuse_facets' base, or one layer over the base 'none'");
    const auto& strata = surface->side(false).strata();
    require_heightfield(material, strata);
    return {*surface, strata};
}

}  // namespace lacquer::heightfield
