#include "reference/stack/stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/reflection.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

Facets facets_of(const StackLobe& lobe) {
    return {Ndf::ggx, lobe.alpha, lobe.alpha};
}

glm::dvec3 diffuse_albedo(const StackView& seen) {
    return seen.surface->diffuse ? seen.arriving * seen.surface->diffuse->returned
                                 : glm::dvec3{0.0};
}

// Probabilities of the top interface, of every lobe below it, and of the diffuse one.
std::vector<double> choices(const StackView& seen) {
    std::vector<double> energies{seen.top};
    for (const StackLobe& lobe : seen.lobes) energies.push_back(mean(lobe.energy));
    energies.push_back(mean(diffuse_albedo(seen)));
    double all = 0.0;
    int count = 0;
    for (const double energy : energies) {
        all += std::max(energy, 0.0);
        if (energy > 0.0) ++count;
    }
    for (double& energy : energies)
        energy = energy > 0.0 ? (1.0 - kMinChoice) * energy / all + kMinChoice / count : 0.0;
    return energies;
}

glm::dvec3 direction_from(const StackView& seen, const glm::dvec3& u) {
    const std::vector<double>& choice = seen.choice;
    const glm::dvec2 point{u.y, u.z};
    double left = u.x;
    if (left < choice.front())
        return coat_sample(seen.surface->top, seen.wo, left / choice.front(), point);
    left -= choice.front();
    for (std::size_t n = 0; n < seen.lobes.size(); ++n) {
        if (left < choice[n + 1])
            return reflection_sample(facets_of(seen.lobes[n]), seen.wo, point);
        left -= choice[n + 1];
    }
    return sample_cosine(point);
}

}  // namespace

StackSurface prepare_stack(const Material& material, const EnergyTables& tables) {
    StackLayers layers = prepare_layers(material, tables);
    const Interface& interface = material.layers.front().interface;
    const Coat top = prepare_coat(std::get<Microsurface>(interface.roughness),
                                  interface.ior / material.exterior_ior, tables);
    std::optional<DiffuseBase> diffuse;
    if (const auto* base = std::get_if<LambertianBase>(&material.base))
        diffuse = prepare_diffuse_base(layers, vector_of(base->albedo));
    return {std::move(layers), top, diffuse};
}

StackView view(const StackSurface& surface, const glm::dvec3& wo) {
    const StackLight light = light_from_above(surface.layers, wo.z);
    StackView seen{&surface, wo, light.lobes.front().energy.w, {}, glm::dvec3{light.down}, {}};
    const EnergyTables& tables = *surface.layers.tables;
    for (std::size_t n = 1; n < light.lobes.size(); ++n) {
        const double alpha = std::max(alpha_of_variance(light.lobes[n].variance), kMinAlpha);
        seen.lobes.push_back({glm::dvec3{light.lobes[n].energy}, alpha,
                              tables.mirror_single(std::min(wo.z, 1.0), alpha)});
    }
    seen.choice = choices(seen);
    return seen;
}

glm::dvec3 eval(const StackView& seen, const glm::dvec3& wi) {
    glm::dvec3 f{coat_lobe(seen.surface->top, wi, seen.wo)};
    for (const StackLobe& lobe : seen.lobes)
        f += lobe.energy / lobe.mirrored * reflection_lobe(facets_of(lobe), wi, seen.wo);
    if (seen.surface->diffuse)
        f += seen.arriving * arriving(seen.surface->layers, wi.z) * seen.surface->diffuse->spread;
    return f;
}

double pdf(const StackView& seen, const glm::dvec3& wi) {
    const std::vector<double>& choice = seen.choice;
    double density = choice.front() * coat_pdf(seen.surface->top, wi, seen.wo);
    for (std::size_t n = 0; n < seen.lobes.size(); ++n)
        density += choice[n + 1] * reflection_pdf(facets_of(seen.lobes[n]), wi, seen.wo);
    return density + choice.back() * wi.z / pi;
}

Sample sample(const StackView& seen, const glm::dvec3& u) {
    Sample chosen;
    chosen.wi = direction_from(seen, u);
    if (!is_above(chosen.wi)) return chosen;
    chosen.pdf = pdf(seen, chosen.wi);
    if (chosen.pdf > 0.0) chosen.weight = eval(seen, chosen.wi) * chosen.wi.z / chosen.pdf;
    return chosen;
}

glm::dvec3 eval(const StackSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return glm::dvec3{0.0};
    return eval(view(surface, wo), wi);
}

double pdf(const StackSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return 0.0;
    return pdf(view(surface, wo), wi);
}

Sample sample(const StackSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    return is_above(wo) ? sample(view(surface, wo), u) : Sample{};
}

Albedo albedo(const StackSurface& surface, const glm::dvec3& wo) {
    if (!is_above(wo)) return {};
    const StackView seen = view(surface, wo);
    Albedo all{glm::dvec3{seen.top}, diffuse_albedo(seen)};
    for (std::size_t n = 0; n + 1 < seen.lobes.size(); ++n) all.direct += seen.lobes[n].energy;
    if (!seen.lobes.empty() && surface.layers.conductor) all.base += seen.lobes.back().energy;
    return all;
}

}  // namespace lacquer::reference
