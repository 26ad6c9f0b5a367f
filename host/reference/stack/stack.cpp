#include "reference/stack/stack.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/reflection.h"
#include "reference/stack/lobe_width.h"
#include "reference/stack/transport.h"

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

glm::dvec3 transmitted(const StackView& seen) {
    glm::dvec3 energy{0.0};
    for (const TransmissionLobe& lobe : seen.transmission) energy += lobe.energy;
    return energy;
}

// Where in StackView::choice these are.
std::size_t diffuse_choice(const StackView& seen) {
    return 1 + seen.lobes.size();
}
std::size_t transmission_choice(const StackView& seen, std::size_t n) {
    return diffuse_choice(seen) + 1 + n;
}

std::vector<double> choices(const StackView& seen) {
    std::vector<double> energies{seen.top};
    for (const StackLobe& lobe : seen.lobes) energies.push_back(mean(lobe.energy));
    energies.push_back(mean(diffuse_albedo(seen)));
    for (const TransmissionLobe& lobe : seen.transmission) energies.push_back(mean(lobe.energy));
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

// How often a direction of the top interface is one that a facet mirrors.
double once_choice(const StackView& seen) {
    if (seen.top <= 0.0) return 1.0;
    const double multiple = std::clamp(seen.surface->top.multiple.at(seen.wo.z), 0.0, 1.0);
    return std::max(1.0 - multiple / seen.top, kMinChoice);
}

// A direction of light, and the side of the surface where its lobe is.
struct Chosen {
    glm::dvec3 wi;
    bool below = false;

    bool is_of_its_lobe() const { return below ? wi.z < 0.0 : is_above(wi); }
};

Chosen direction_from(const StackView& seen, const glm::dvec3& u) {
    const std::vector<double>& choice = seen.choice;
    const glm::dvec2 point{u.y, u.z};
    double left = u.x;
    if (left < choice.front()) {
        const double once = choice.front() * once_choice(seen);
        return {left < once ? coat_mirrored(seen.surface->top, seen.wo, {left / once, point})
                            : sample_cosine(point)};
    }
    left -= choice.front();
    for (std::size_t n = 0; n < seen.lobes.size(); ++n) {
        if (left < choice[n + 1])
            return {reflection_sample(facets_of(seen.lobes[n]), seen.wo, point)};
        left -= choice[n + 1];
    }
    left -= choice[diffuse_choice(seen)];
    if (left < 0.0 || seen.transmission.empty()) return {sample_cosine(point)};
    std::size_t n = 0;
    while (n + 1 < seen.transmission.size() && left >= choice[transmission_choice(seen, n)])
        left -= choice[transmission_choice(seen, n++)];
    return {transmission_sample(seen.transmission[n], point), true};
}

bool shares_lobe(const StackSurface& surface) {
    return surface.layers.conductor && surface.conductor_lobe == ConductorLobe::shared;
}

}  // namespace

StackSurface prepare_stack(const Material& material, const EnergyTables& tables, StackLobes lobes,
                           ConductorLobe conductor_lobe) {
    StackLayers layers = prepare_layers(material, tables);
    const Interface& interface = material.layers.front().interface;
    const Coat top =
        prepare_coat(interface.roughness, interface.ior / material.exterior_ior, tables);
    StackSurface surface{std::move(layers), top, conductor_lobe, {}, {}};
    const auto* base = std::get_if<LambertianBase>(&material.base);
    if (!base && lobes == StackLobes::forward) return surface;
    EnteredLight entered = entered_light(surface.layers);
    if (shares_lobe(surface))
        for (StackLight& light : entered.known) light.merge_lobes();
    if (base)
        surface.diffuse = prepare_diffuse_base(surface.layers, entered, vector_of(base->albedo));
    if (lobes == StackLobes::symmetric) surface.symmetric = fit_symmetric(surface.layers, entered);
    return surface;
}

namespace {

StackLobe lobe_of(const LobeLight& light, double cosine, const EnergyTables& tables) {
    const double alpha = std::clamp(alpha_of_width(light.width), kMinAlpha, 1.0);
    return {glm::dvec3{light.energy}, alpha, tables.lobe(cosine, alpha).single};
}

}  // namespace

StackView view(const StackSurface& surface, const glm::dvec3& wo) {
    const double cosine = std::min(wo.z, 1.0);
    const EnergyTables& tables = *surface.layers.tables;
    StackLight light = surface.symmetric ? surface.symmetric->at(cosine)
                                         : light_from_above(surface.layers, cosine);
    if (shares_lobe(surface)) light.merge_lobes();
    StackView seen{&surface, wo, light.top, {}, glm::dvec3{0.0}, {}, {}};
    if (sum(light.interfaces.energy) > 0.0)
        seen.lobes.push_back(lobe_of(light.interfaces, cosine, tables));
    if (surface.layers.conductor) seen.lobes.push_back(lobe_of(light.base, cosine, tables));
    if (surface.diffuse) seen.arriving = glm::dvec3{surface.diffuse->arriving.at(cosine)};
    if (surface.layers.open_below)
        for (const Beam& beam : {light.straight, light.detoured})
            if (sum(beam.energy()) > 0.0)
                seen.transmission.push_back(transmission_lobe(beam, wo, tables));
    seen.choice = choices(seen);
    return seen;
}

namespace {

glm::dvec3 forward_value(const StackView& seen, const glm::dvec3& wi) {
    glm::dvec3 f{0.0};
    for (const StackLobe& lobe : seen.lobes)
        f += lobe.energy / lobe.mirrored * reflection_lobe(facets_of(lobe), wi, seen.wo);
    return f;
}

glm::dvec3 eval_below(const StackView& seen, const glm::dvec3& wi) {
    glm::dvec3 f{0.0};
    for (const TransmissionLobe& lobe : seen.transmission) f += transmission_value(lobe, wi);
    return f;
}

double pdf_below(const StackView& seen, const glm::dvec3& wi) {
    double density = 0.0;
    for (std::size_t n = 0; n < seen.transmission.size(); ++n)
        density +=
            seen.choice[transmission_choice(seen, n)] * transmission_pdf(seen.transmission[n], wi);
    return density;
}

}  // namespace

glm::dvec3 eval(const StackView& seen, const glm::dvec3& wi) {
    if (wi.z < 0.0) return eval_below(seen, wi);
    if (!is_above(wi)) return glm::dvec3{0.0};
    glm::dvec3 f{coat_lobe(seen.surface->top, wi, seen.wo)};
    f += seen.surface->symmetric ? symmetric_value(*seen.surface->symmetric, wi, seen.wo)
                                 : forward_value(seen, wi);
    if (seen.surface->diffuse)
        f += seen.arriving * glm::dvec3{seen.surface->diffuse->arriving.at(std::min(wi.z, 1.0))} *
             seen.surface->diffuse->spread;
    return f;
}

double pdf(const StackView& seen, const glm::dvec3& wi) {
    const std::vector<double>& choice = seen.choice;
    if (wi.z < 0.0) return pdf_below(seen, wi);
    if (!is_above(wi)) return 0.0;
    const double once = once_choice(seen), diffuse = wi.z / pi;
    double density = choice.front() * (once * coat_mirrored_pdf(seen.surface->top, wi, seen.wo) +
                                       (1.0 - once) * diffuse);
    for (std::size_t n = 0; n < seen.lobes.size(); ++n)
        density += choice[n + 1] * reflection_pdf(facets_of(seen.lobes[n]), wi, seen.wo);
    return density + choice[diffuse_choice(seen)] * diffuse;
}

Sample sample(const StackView& seen, const glm::dvec3& u) {
    const Chosen chosen = direction_from(seen, u);
    Sample drawn{.wi = chosen.wi};
    if (!chosen.is_of_its_lobe()) return drawn;
    drawn.pdf = pdf(seen, drawn.wi);
    if (drawn.pdf > 0.0) drawn.weight = eval(seen, drawn.wi) * std::abs(drawn.wi.z) / drawn.pdf;
    return drawn;
}

glm::dvec3 eval(const StackSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    return is_above(wo) ? eval(view(surface, wo), wi) : glm::dvec3{0.0};
}

double pdf(const StackSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    return is_above(wo) ? pdf(view(surface, wo), wi) : 0.0;
}

Sample sample(const StackSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    return is_above(wo) ? sample(view(surface, wo), u) : Sample{};
}

Albedo albedo(const StackSurface& surface, const glm::dvec3& wo) {
    if (!is_above(wo)) return {};
    const StackView seen = view(surface, wo);
    Albedo all{glm::dvec3{seen.top}, diffuse_albedo(seen), transmitted(seen)};
    const bool conducts = surface.layers.conductor.has_value();
    for (std::size_t n = 0; n < seen.lobes.size(); ++n)
        (conducts && n + 1 == seen.lobes.size() ? all.base : all.direct) += seen.lobes[n].energy;
    return all;
}

}  // namespace lacquer::reference
