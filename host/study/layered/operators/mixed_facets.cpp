// What 2018, appendix A, leaves open: stacks of GGX and Beckmann facets.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <random>

#include "reference/stack/equivalent_lobe_alpha.h"
#include "reference/stack/lobe_width.h"
#include "study/layered/compared.h"
#include "study/layered/error_sizes.h"
#include "study/layered/light_statistics.h"
#include "study/layered/operators/lobes.h"
#include "study/layered/operators/operator_plot.h"
#include "study/layered/random_stacks.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

constexpr Abscissa kAlpha{"alpha", 0.02, 1.0};
constexpr Abscissa kSecondAlpha{"alpha_2", 0.02, 1.0};
constexpr double kWidthTop = 0.6;
constexpr std::uint64_t kDotShare = 1 << 6;
constexpr int kStacks = 36;            // of each kind
constexpr int kMostCoats = 3;          // one to this many, in turn
constexpr double kLeastEnergy = 0.01;  // whose width the simulation knows

double equivalent(double alpha) {
    return reference::equivalent_lobe_alpha(Microsurface{Ndf::beckmann, {alpha, alpha}});
}

double sum_of(double first, double second) {
    using namespace reference;
    return alpha_of_width(width_of_variance(variance_of_width(width_of_alpha(first)) +
                                            variance_of_width(width_of_alpha(second))));
}

// After perfect mirrors of Beckmann facets, and of `first` ones before them.
std::optional<Measured> simulated_width(std::optional<Microsurface> first, double alpha,
                                        double cosine, const StudyRun& run) {
    const simulator::SurfaceWalk second = mirrors(Ndf::beckmann, alpha);
    std::optional<simulator::SurfaceWalk> before;
    if (first) before = mirrors(first->ndf, first->alpha[0]);
    const std::string name =
        fmt::format("Beckmann {} {} {}", first ? first->alpha[0] : 0.0, alpha, cosine);
    const Spread spread = simulate_spread(
        run.options(run.share(kDotShare), name), [&](simulator::RandomStream& random) {
            glm::dvec3 direction = downwards(cosine);
            if (before) direction = turned_over(before->cross(direction, random).direction);
            return Ray{second.cross(direction, random).direction, 1.0};
        });
    return Measured{spread.width, spread.width_error};
}

OperatorCheck one_lobe(const StudyRun& run) {
    OperatorCheck check{"one Beckmann reflection", "width", kAlpha, 0.0, kWidthTop, true, {}};
    for (const double cosine : {1.0, 0.7, 0.4})
        check.cases.push_back(
            {fmt::format("cos_theta {}", cosine),
             [=, &run](double alpha) { return simulated_width(std::nullopt, alpha, cosine, run); },
             {{"stack", [=](double alpha) { return ggx_lobe(equivalent(alpha), cosine).width; }},
              {"GGX of alpha", [=](double alpha) { return ggx_lobe(alpha, cosine).width; }}}});
    return check;
}

// Of facets of either kind and then Beckmann's.
OperatorCheck two_lobes(const StudyRun& run) {
    OperatorCheck check{"Beckmann after another", "width", kSecondAlpha, 0.0, kWidthTop, true, {}};
    constexpr double kCosine = 0.7;
    for (const auto& [ndf, first] :
         {std::pair{Ndf::beckmann, 0.1}, {Ndf::beckmann, 0.4}, {Ndf::ggx, 0.1}, {Ndf::ggx, 0.4}}) {
        const bool is_ggx = ndf == Ndf::ggx;
        const Microsurface before{ndf, {first, first}};
        const double alpha_before = first, lobe = is_ggx ? first : equivalent(first);
        check.cases.push_back(
            {fmt::format("{} of alpha_1 {}", is_ggx ? "GGX" : "Beckmann", first),
             [=, &run](double alpha) { return simulated_width(before, alpha, kCosine, run); },
             {{"stack",
               [=](double alpha) {
                   return ggx_lobe(sum_of(lobe, equivalent(alpha)), kCosine).width;
               }},
              {"GGX of alpha", [=](double alpha) {
                   return ggx_lobe(sum_of(alpha_before, alpha), kCosine).width;
               }}}});
    }
    return check;
}

void make_beckmann(Roughness& roughness) {
    std::get<Microsurface>(roughness).ndf = Ndf::beckmann;
}

// Which parts of a random stack have Beckmann facets.
struct Kind {
    const char* name;
    bool coats, base;

    Material with_beckmann(Material material) const {
        if (coats)
            for (Layer& layer : material.layers) make_beckmann(layer.interface.roughness);
        if (base) make_beckmann(std::get<ConductorBase>(material.base).roughness);
        return material;
    }
};

constexpr Kind kKinds[] = {{"Beckmann coats and metal", true, true},
                           {"Beckmann coats over GGX metal", true, false},
                           {"GGX coats over Beckmann metal", false, true}};

LightStatistics statistics_of(const Material& material, double cos_theta) {
    return model_statistics(*compared_on(material, Need::base).front().light, cos_theta);
}

// A random stack, simulated, and stack on it and on the same of GGX facets alone, as a model of one
// distribution has it.
struct Result {
    RandomStack stack;
    LightStatistics truth, mixed, as_ggx;
};

std::vector<Result> random_results(const Kind& kind, const StudyRun& run) {
    std::mt19937_64 generator{run.seed_of(kind.name)};
    std::vector<Result> results(kStacks);
    for (int n = 0; n < kStacks; ++n)
        results[static_cast<std::size_t>(n)].stack =
            random_stack(generator, BaseKind::conductor, 1 + n % kMostCoats);
    tbb::parallel_for(std::size_t{0}, results.size(), [&](std::size_t n) {
        Result& result = results[n];
        auto& [material, cos_theta] = result.stack;
        result.as_ggx = statistics_of(material, cos_theta);
        material = kind.with_beckmann(std::move(material));
        result.mixed = statistics_of(material, cos_theta);
        result.truth = simulate_statistics(material, cos_theta, run.share(kDotShare), run,
                                           fmt::format("{} {}", kind.name, n));
    });
    return results;
}

void add_stacks(Figure& figure, NumberTable& table, const Kind& kind, const StudyRun& run) {
    run.part(kind.name);
    const std::vector<Result> results = random_results(kind, run);
    std::vector<ErrorSizes> albedos, widths;
    for (const auto& [name, of] :
         {std::pair{"stack", &Result::mixed}, {"GGX of alpha", &Result::as_ggx}}) {
        ErrorSizes& albedo = albedos.emplace_back(fmt::format("{}: albedo", kind.name), name);
        ErrorSizes& width =
            widths.emplace_back(fmt::format("{}: width of the base's light", kind.name), name);
        for (const Result& result : results) {
            const Spread &all = result.truth.all, &base = result.truth.base;
            const auto where = [&] { return describe(result.stack, 1); };
            albedo.add((result.*of).all.energy - all.energy, all.energy_error, where);
            if (base.energy < kLeastEnergy || base.width <= 0.0) continue;
            width.add((result.*of).base.width / base.width - 1.0, base.width_error / base.width,
                      where);
        }
    }
    for (const std::vector<ErrorSizes>* errors : {&albedos, &widths})
        for (const ErrorSizes& one : *errors) {
            figure.errors.push_back(one.result());
            table.rows.push_back(one.row());
        }
}

}  // namespace

Figure mixed_facets_figure(const StudyRun& run) {
    Figure figure{
        "beckmann", "Appendix A: Beckmann facets beside GGX",
        fmt::format(
            "The paper's space of variances holds one distribution of facets. Here Beckmann's join "
            "in by the GGX roughness of lobes as wide: alpha (0.425 + 0.15 alpha) for all angles, "
            "while the energies keep a roughness of their own. A GGX lobe has most of its width in "
            "its tails, so that the ratio of the roughnesses goes from 0.4 to above 1 along the "
            "normal and from 0.4 down to 0.2 at a cosine of 0.2: one number for all angles is a "
            "compromise. Along the normal it is too narrow from alpha 0.3 on, which makes rough "
            "Beckmann metal under a smooth coat up to 0.06 too bright. GGX of alpha: the same "
            "facets called GGX, as a model of one distribution has them. Random stacks: {} of each "
            "kind, of one to three coats, as in the figure of that name.",
            kStacks),
        "widths: mean and largest |difference| as a share of the simulated; albedos: absolute"};
    NumberTable table = operator_table();
    add_check(figure, table, one_lobe(run), run);
    add_check(figure, table, two_lobes(run), run);
    for (const Kind& kind : kKinds) add_stacks(figure, table, kind, run);
    figure.panels.emplace_back(std::move(table));
    return figure;
}

}  // namespace lacquer::study
