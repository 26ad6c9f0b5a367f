#include "reference/microsurface/microsurface_stochastic.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "reference/microsurface/facet_walk.h"
#include "reference/random_numbers.h"

namespace lacquer::reference {

namespace {

// What the random numbers of a seed are for: the third word of their counter.
enum Purpose : std::uint32_t { kFromViewer = 0, kFromLight = 1, kOfAlbedo = 2 };

// The random numbers of one walk.
struct Stream {
    std::uint32_t seed, walk;
    Purpose purpose;

    std::array<double, 4> numbers(std::uint32_t draw) const {
        return random_numbers({seed, walk, static_cast<std::uint32_t>(purpose), draw});
    }
};

TwoSides sides_of(const SingleMicrosurface& surface, bool from_below) {
    const RoughSide& below = surface.below ? *surface.below : surface.above;
    return from_below ? TwoSides{below, surface.above} : TwoSides{surface.above, below};
}

bool is_on(const SingleMicrosurface& surface, const glm::dvec3& w) {
    return surface.is_there && (is_above(w) || (w.z < 0.0 && surface.below));
}

// w in the frame of its own side.
glm::dvec3 on_its_side(const glm::dvec3& w) {
    return w.z < 0.0 ? mirrored(w) : w;
}

// Of the weight, what a ray that met so many facets goes on with; false: it ends, as u in [0, 1)
// decides.
bool survives(glm::dvec3& weight, int facets, double u) {
    const double most = std::max({weight.x, weight.y, weight.z});
    if (most <= 0.0) return false;
    if (facets < kCertainFacets) return true;
    const double survival = std::min(most, kMostSurvival);
    weight /= survival;
    return u < survival;
}

// One end of a path: above `side` of the two, and what the density of light that leaves along it is
// multiplied by to be f.
struct End {
    glm::dvec3 w;
    std::size_t side;
    double scale;
};

// One walk from `start`: f of the light that leaves to `end` from its second facet on. A path is
// counted as often as this walk finds it among those from both ends: in proportion to its density,
// which is f over what connects the last facet to the end. Both walks therefore give a path the
// same value, a b / (a + b), with the connections a and b of its ends.
glm::dvec3 walked(const TwoSides& sides, const End& start, const End& end, const Stream& stream) {
    FacetRay ray = entering(start.w);
    ray.side = start.side;
    glm::dvec3 weight{1.0}, sum{0.0};
    double back = 0.0;  // connects the first facet to the start
    for (int facet = 1; facet <= kMaxWalkFacets; ++facet) {
        const std::uint32_t draw = 2u * static_cast<std::uint32_t>(facet - 1);
        const auto u = stream.numbers(draw), v = stream.numbers(draw + 1);
        if (!fly(sides, ray, {u[0], v[0]})) break;
        if (facet > 1) {
            const Connection last = connection(sides, ray, end.w, end.side);
            const double onwards = last.density * end.scale;
            if (onwards > 0.0)
                sum += weight * last.reflectance * (onwards * back / (onwards + back));
        }
        weight *= turn(sides, ray, {u[1], u[2], u[3]});
        if (facet == 1) {
            back = connection(sides, reversed(ray), start.w, start.side).density * start.scale;
            if (!(back > 0.0)) break;
        }
        if (!survives(weight, facet, v[1])) break;
    }
    return sum;
}

// f of light that met several facets, without what the medium takes.
glm::dvec3 reflected_often(const SingleMicrosurface& surface, const glm::dvec3& wi,
                           const glm::dvec3& wo, std::uint32_t seed) {
    const TwoSides sides = sides_of(surface, wo.z < 0.0);
    const bool through = (wi.z < 0.0) != (wo.z < 0.0);
    const double eta = through ? eta_of(sides[0]) : 1.0;
    const End viewer{on_its_side(wo), 0, eta * eta / std::abs(wo.z)};
    const End light{on_its_side(wi), through ? std::size_t{1} : std::size_t{0},
                    1.0 / std::abs(wi.z)};
    return walked(sides, viewer, light, {seed, 0, kFromViewer}) +
           walked(sides, light, viewer, {seed, 0, kFromLight});
}

// The directions that light leaves to: of a conductor one hemisphere.
double even_pdf(const SingleMicrosurface& surface, const glm::dvec3& wi) {
    return std::abs(wi.z) * std::numbers::inv_pi * (surface.below ? 0.5 : 1.0);
}

}  // namespace

StochasticMicrosurface prepare_microsurface_stochastic(const Material& material) {
    return {prepare_microsurface_single(material)};
}

glm::dvec3 eval(const StochasticMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo,
                std::uint32_t seed) {
    const SingleMicrosurface& first = surface.first;
    if (!is_on(first, wi) || !is_on(first, wo)) return glm::dvec3{0.0};
    return eval(first, wi, wo) +
           crossing(first, wi) * crossing(first, wo) * reflected_often(first, wi, wo, seed);
}

double pdf(const StochasticMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    const SingleMicrosurface& first = surface.first;
    if (!is_on(first, wi) || !is_on(first, wo)) return 0.0;
    return (1.0 - kEvenChoice) * pdf(first, wi, wo) + kEvenChoice * even_pdf(first, wi);
}

Sample sample(const StochasticMicrosurface& surface, const glm::dvec3& wo, const glm::dvec3& u,
              std::uint32_t seed) {
    const SingleMicrosurface& first = surface.first;
    Sample chosen;
    if (!is_on(first, wo)) return chosen;
    if (u.x < kEvenChoice) {
        chosen.wi = sample_cosine({u.y, u.z});
        const bool across = first.below && u.x >= 0.5 * kEvenChoice;
        if ((wo.z < 0.0) != across) chosen.wi = mirrored(chosen.wi);
    } else {
        const Sample facet =
            sample(first, wo, {(u.x - kEvenChoice) / (1.0 - kEvenChoice), u.y, u.z});
        chosen.wi = facet.wi;
        if (!(facet.pdf > 0.0)) return chosen;
    }
    chosen.pdf = pdf(surface, chosen.wi, wo);
    if (chosen.pdf > 0.0)
        chosen.weight = eval(surface, chosen.wi, wo, seed) * std::abs(chosen.wi.z) / chosen.pdf;
    return chosen;
}

Albedo albedo(const StochasticMicrosurface& surface, const glm::dvec3& wo, std::uint32_t seed) {
    const SingleMicrosurface& first = surface.first;
    Albedo light = albedo(first, wo);
    if (!is_on(first, wo)) return light;
    const TwoSides sides = sides_of(first, wo.z < 0.0);
    glm::dvec3 sums[2] = {glm::dvec3{0.0}, glm::dvec3{0.0}};
    for (std::uint32_t walk = 0; walk < kAlbedoWalks; ++walk) {
        const Stream stream{seed, walk, kOfAlbedo};
        FacetRay ray = entering(on_its_side(wo));
        glm::dvec3 weight{1.0};
        for (int facet = 1; facet <= kMaxWalkFacets; ++facet) {
            const std::uint32_t draw = 2u * static_cast<std::uint32_t>(facet - 1);
            const auto u = stream.numbers(draw), v = stream.numbers(draw + 1);
            if (!fly(sides, ray, {u[0], v[0]})) {
                const bool leaves_below = (wo.z < 0.0) != (ray.side == 1);
                if (facet > 2)
                    sums[ray.side] +=
                        weight * crossing(first, leaves_below ? mirrored(ray.w) : ray.w);
                break;
            }
            weight *= turn(sides, ray, {u[1], u[2], u[3]});
            if (!survives(weight, facet, v[1])) break;
        }
    }
    const glm::dvec3 share = crossing(first, wo) / static_cast<double>(kAlbedoWalks);
    (first.below ? light.direct : light.base) += share * sums[0];
    light.transmitted += share * sums[1];
    return light;
}

}  // namespace lacquer::reference
