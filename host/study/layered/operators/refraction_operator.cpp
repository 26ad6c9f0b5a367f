// Figures 5 to 7 of 2018: where rough facets refract light to, and how wide it is then.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/stack/facet_effect.h"
#include "reference/stack/lobe_width.h"
#include "reference/stack/published/operators_2018.h"
#include "study/layered/operators/lobe_shapes.h"
#include "study/layered/operators/operator_plot.h"
#include "study/layered/operators/refracted_lobe.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

namespace published = reference::published_2018;

constexpr Abscissa kSine{"sin_theta", 0.0, 0.99};
constexpr Abscissa kAlpha{"alpha", 0.02, 1.0};
constexpr Abscissa kAlphaBefore{"alpha before", 0.02, 0.8};
constexpr std::uint64_t kDotShare = 1 << 6;
constexpr double kLeastEnergy = 0.01;  // whose statistics the simulation knows

double other(double sine_or_cosine) {
    return std::sqrt(std::max(1.0 - sine_or_cosine * sine_or_cosine, 0.0));
}

Spread simulate(const Refraction& at, const StudyRun& run) {
    const std::string name = fmt::format("refraction {} {} {}", at.cosine, at.alpha, at.eta);
    return simulate_spread(run.options(run.share(kDotShare), name), RefractedRays{at});
}

// Its mean, less what Snell's law says of the ray.
OperatorCheck off_specular_shift(const StudyRun& run) {
    OperatorCheck check{"mean of refracted light, less the refracted direction",
                        "sine",
                        kSine,
                        -0.4,
                        0.2,
                        false,
                        {}};
    struct Case {
        double eta, alpha;
    };
    for (const auto& [eta, alpha] :
         {Case{1.5, 0.1}, {1.5, 0.5}, {2.0, 0.5}, {1.0 / 1.5, 0.1}, {1.0 / 1.5, 0.5}, {0.8, 0.3}}) {
        const auto at = [eta = eta, alpha = alpha](double sine) {
            return Refraction{other(sine), alpha, eta};
        };
        check.cases.push_back(
            {fmt::format("eta {:.3g}, alpha {}", eta, alpha),
             [=, &run](double sine) -> std::optional<Measured> {
                 const Spread spread = simulate(at(sine), run);
                 if (spread.energy < kLeastEnergy) return std::nullopt;
                 return Measured{spread.mean - refracted_sine(at(sine)), spread.mean_error};
             },
             {{"stack",
               [=](double sine) {
                   return stack_refracted_sine(at(sine)) - refracted_sine(at(sine));
               }},
              {"2018", [](double) { return 0.0; }}}});
    }
    return check;
}

double width_of(const FakeLobe& lobe) {
    return ggx_lobe(lobe.alpha, lobe.cosine()).width;
}

OperatorCheck transmitted_roughness(const StudyRun& run) {
    OperatorCheck check{"width of one refracted ray", "width", kAlpha, 0.0, 0.5, true, {}};
    struct Case {
        double eta, cosine;
    };
    for (const auto& [eta, cosine] : {Case{1.5, 1.0},
                                      {1.5, 0.7},
                                      {1.5, 0.3},
                                      {2.0, 1.0},
                                      {1.0 / 1.5, 1.0},
                                      {1.0 / 1.5, 0.85}}) {
        const auto at = [eta = eta, cosine = cosine](double alpha) {
            return Refraction{cosine, alpha, eta};
        };
        OperatorCase one{fmt::format("eta {:.3g}, cos_theta {}", eta, cosine),
                         [=, &run](double alpha) -> std::optional<Measured> {
                             const Spread spread = simulate(at(alpha), run);
                             if (spread.energy < kLeastEnergy) return std::nullopt;
                             return Measured{spread.width, spread.width_error};
                         },
                         {}};
        for (const FakeLobeModel& model : fake_lobes())
            one.formulas.push_back({model.name, [=, lobe = model.lobe](double alpha) {
                                        return width_of(lobe(at(alpha)));
                                    }});
        check.cases.push_back(std::move(one));
    }
    return check;
}

// Of a lobe that mirrors of roughness `at.alpha` have made, through smooth facets.
Spread simulate_lobe(const Refraction& at, const StudyRun& run) {
    const simulator::SurfaceWalk mirror = mirrors(Ndf::ggx, at.alpha),
                                 surface = dielectric(0.0, at.eta);
    const std::string name = fmt::format("lobe refracted {} {} {}", at.cosine, at.alpha, at.eta);
    return simulate_spread(
        run.options(run.share(kDotShare), name), [&](simulator::RandomStream& random) {
            const auto lobe = mirror.cross(downwards(at.cosine), random);
            const auto crossing = surface.cross(turned_over(lobe.direction), random);
            return Ray{crossing.direction, crossing.below ? 1.0 : 0.0};
        });
}

double stack_alpha_after(const Refraction& at) {
    using namespace reference;
    const double scale =
        refracted_roughness(at.cosine, other(refracted_sine(at)), 0.0, at.eta).scale;
    return alpha_of_width(
        width_of_variance(width_of_alpha(scale) * variance_of_width(width_of_alpha(at.alpha))));
}

template <typename Change>
double alpha_after_2018(const Refraction& at, const Change& change) {
    return published::alpha_of_variance(change(published::variance_of_alpha(at.alpha), at.eta));
}

OperatorCheck refracted_lobes(const StudyRun& run) {
    OperatorCheck check{
        "width of a lobe refracted by smooth facets", "width", kAlphaBefore, 0.0, 0.6, true, {}};
    struct Case {
        double eta, cosine;
    };
    for (const auto& [eta, cosine] : {Case{1.5, 1.0}, {1.5, 0.5}, {1.0 / 1.5, 1.0}}) {
        const auto at = [eta = eta, cosine = cosine](double alpha) {
            return Refraction{cosine, alpha, eta};
        };
        const auto lobe = [=](double alpha, const Refraction& where) {
            return width_of({alpha, refracted_sine(where)});
        };
        check.cases.push_back(
            {fmt::format("eta {:.3g}, cos_theta {}", eta, cosine),
             [=, &run](double alpha) {
                 const Spread spread = simulate_lobe(at(alpha), run);
                 return std::optional{Measured{spread.width, spread.width_error}};
             },
             {{"stack",
               [=](double alpha) { return lobe(stack_alpha_after(at(alpha)), at(alpha)); }},
              {"2018",
               [=](double alpha) {
                   return lobe(alpha_after_2018(at(alpha), published::refracted_variance),
                               at(alpha));
               }},
              {"as printed", [=](double alpha) {
                   return lobe(
                       alpha_after_2018(at(alpha), published::refracted_variance_as_printed),
                       at(alpha));
               }}}});
    }
    return check;
}

}  // namespace

Figure refraction_operator_figure(const StudyRun& run) {
    Figure figure{
        "figure-7", "Figures 5 to 7: rough refraction",
        "The mean: 2018 takes the refracted direction (Eq. 12), stack the mean over four visible "
        "normals, each for those near it. The width of one refracted ray, beside the reflections "
        "that stand for it: of stack, 0.85 times the roughness of Eq. 10 but less than "
        "cos_theta^2, about stack's own mean; of 2018, Eq. 10 with the minus sign that "
        "its convention of signs means; as printed, with a plus, which is some five times too "
        "wide along the normal; equal peaks, the rule of thumb of equating the peaks of both "
        "lobes at normal incidence, after Kulla and Conty 2017, which is Eq. 10 there and too "
        "narrow at a slant. The width of a lobe that crosses smooth facets: Eq. 13 scales its "
        "variance by the index of the light's medium over the other's (2018), not the inverse (as "
        "printed). Both are too wide where a wide lobe enters a denser medium: it ends at the "
        "critical angle, as no GGX lobe does. On its way out the same scale is taken back.",
        "mean direction: mean and largest |difference|; shape: total variation distance; widths: "
        "mean and largest |difference| as a share of the simulated"};
    NumberTable table = operator_table();
    add_check(figure, table, off_specular_shift(run), run);
    add_lobe_shapes(figure, table, run);
    add_check(figure, table, transmitted_roughness(run), run);
    add_check(figure, table, refracted_lobes(run), run);
    figure.panels.emplace_back(std::move(table));
    return figure;
}

}  // namespace lacquer::study
