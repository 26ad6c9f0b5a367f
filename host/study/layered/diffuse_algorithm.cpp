// Algorithm 1 of 2022 beside the exact form, for the light of a Lambertian base through a stack.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "core/paths.h"
#include "reference/stack/diffuse_base.h"
#include "reference/stack/published/algorithm_1_2022.h"
#include "study/coat_light.h"
#include "study/layered/error_sizes.h"
#include "study/layered/operators/operator_plot.h"
#include "study/layered/random_stacks.h"
#include "study/layered/stacks.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

namespace p2022 = reference::published_2022;

constexpr int kStacks = 24;  // of each number of coats
constexpr int kMostCoats = 4;
constexpr std::uint64_t kDotShare = 1 << 6;
constexpr int kBins = 16;               // of equal cos_theta
constexpr int kSteps = 8;               // of the models' light, per bin
constexpr double kLeastEnergy = 0.005;  // whose distribution the simulation knows
constexpr Abscissa kTopIndex{"eta_0", 1.05, 2.5};
constexpr Rgb kAlbedo{0.9, 0.1, 0.1};  // of figure 10

// The base's light for a viewer: what of all that arrives, and f per light.
struct BaseModel {
    glm::dvec3 albedo;
    std::function<glm::dvec3(const glm::dvec3& wi)> f;
};

// The forms that are compared, on one stack.
class Forms {
 public:
    Forms(const Material& material, const EnergyTables& tables)
        : layers_{reference::prepare_layers(material, tables)},
          albedo_{reference::vector_of(std::get<LambertianBase>(material.base).albedo)},
          exact_{reference::prepare_diffuse_base(layers_, reference::entered_light(layers_),
                                                 albedo_)} {}

    BaseModel exact(double cosine) const {
        const glm::dvec3 arriving{exact_.arriving.at(cosine)};
        return {arriving * exact_.returned, [this, arriving](const glm::dvec3& wi) {
                    return arriving * glm::dvec3{exact_.arriving.at(wi.z)} * exact_.spread;
                }};
    }

    BaseModel algorithm(double cosine, p2022::Below below) const {
        const p2022::DiffuseLobe lobe = p2022::diffuse_lobe(layers_, albedo_, cosine, below);
        return {lobe.energy, [lobe](const glm::dvec3& wi) { return p2022::eval(lobe, wi); }};
    }

 private:
    reference::StackLayers layers_;
    glm::dvec3 albedo_;
    reference::DiffuseBase exact_;
};

struct Form {
    const char* name;
    BaseModel (*of)(const Forms& forms, double cosine);
};

constexpr std::array<Form, 3> kForms{{
    {"stack", [](const Forms& forms, double cosine) { return forms.exact(cosine); }},
    {"2022",
     [](const Forms& forms, double cosine) { return forms.algorithm(cosine, p2022::Below::all); }},
    {"as printed",
     [](const Forms& forms, double cosine) {
         return forms.algorithm(cosine, p2022::Below::next_interface);
     }},
}};

// Shares of the light, red, green and blue together, in bins of equal cos_theta.
using Shares = std::array<double, kBins>;

Shares shares_of(const BaseModel& model) {
    Shares shares{};
    double all = 0.0;
    for (int step = 0; step < kBins * kSteps; ++step) {
        const double z = (step + 0.5) / (kBins * kSteps);
        const glm::dvec3 f = model.f({std::sqrt(1.0 - z * z), 0.0, z});
        shares[static_cast<std::size_t>(step / kSteps)] += (f.x + f.y + f.z) * z;
        all += (f.x + f.y + f.z) * z;
    }
    if (all > 0.0)
        for (double& share : shares) share /= all;
    return shares;
}

double total(const Rgb& rgb) {
    return rgb[0] + rgb[1] + rgb[2];
}

// Total variation of the distributions, and what noise makes of it.
Measured distance(const BaseModel& model, const BaseLight& truth) {
    const Shares shares = shares_of(model);
    const double all = total(truth.base.mean);
    Measured result;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        result.value += 0.5 * std::abs(shares[bin] - total(truth.rings[bin].mean) / all);
        // Channels share their walks.
        result.standard_error += 0.5 * total(truth.rings[bin].standard_error) / all;
    }
    return result;
}

struct Case {
    RandomStack stack;
    std::string name;
};

// Errors of all forms on some stacks.
void add_stacks(Figure& figure, NumberTable& table, const std::string& subject,
                const std::vector<Case>& cases, const EnergyTables& tables, const StudyRun& run) {
    run.part(subject);
    std::vector<BaseLight> truths(cases.size());
    tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t n) {
        const auto& [material, cosine] = cases[n].stack;
        truths[n] = simulate_base_light(simulator::StackWalk{material}, cosine, kBins,
                                        run.options(run.share(kDotShare), cases[n].name));
    });
    std::vector<ErrorSizes> albedos, places;
    for (const Form& form : kForms) {
        ErrorSizes& albedo = albedos.emplace_back(subject + ": albedo", form.name);
        ErrorSizes& place = places.emplace_back(subject + ": where it goes", form.name);
        for (std::size_t n = 0; n < cases.size(); ++n) {
            const auto& [material, cosine] = cases[n].stack;
            const Forms forms{material, tables};
            const BaseModel model = form.of(forms, cosine);
            const BaseLight& truth = truths[n];
            for (std::size_t channel = 0; channel < 3; ++channel)
                albedo.add(model.albedo[static_cast<int>(channel)] - truth.base.mean[channel],
                           truth.base.standard_error[channel],
                           [&] { return describe(cases[n].stack, channel); });
            if (total(truth.base.mean) < 3.0 * kLeastEnergy) continue;
            const Measured apart = distance(model, truth);
            place.add(apart.value, apart.standard_error,
                      [&] { return describe(cases[n].stack, 0); });
        }
    }
    for (const std::vector<ErrorSizes>* errors : {&albedos, &places})
        for (const ErrorSizes& of : *errors) {
            figure.errors.push_back(of.result());
            table.rows.push_back(of.row());
        }
}

// Every second of them clear: through many coats that absorb little light returns.
std::vector<Case> random_cases(int coats, const StudyRun& run) {
    const std::string name = fmt::format("algorithm 1, {} coats", coats);
    std::mt19937_64 generator{run.seed_of(name)};
    std::vector<Case> cases;
    for (int n = 0; n < kStacks; ++n) {
        RandomStack stack = random_stack(generator, BaseKind::lambertian, coats);
        if (n % 2 == 1)
            for (Layer& layer : stack.material.layers) layer.medium = AbsorbingMedium{};
        cases.push_back({std::move(stack), fmt::format("{} {}", name, n)});
    }
    return cases;
}

// A smooth coat over one of index 2.
Material figure_10(double eta, double alpha) {
    return stack_of("", {coat(eta, 0.0), coat(2.0, alpha)}, LambertianBase{kAlbedo});
}

std::vector<Case> figure_10_cases() {
    std::vector<Case> cases;
    for (const double eta : {1.2, 1.6, 2.0, 2.4})
        for (const double alpha : {0.1, 0.4})
            for (const double cosine : {1.0, 0.4})
                cases.push_back({{figure_10(eta, alpha), cosine},
                                 fmt::format("figure 10 {} {} {}", eta, alpha, cosine)});
    return cases;
}

// Red light from the base, over the index of the top coat.
OperatorCheck over_top_index(const EnergyTables& tables, const StudyRun& run) {
    OperatorCheck check{
        "figure 10: red light from the base", "albedo", kTopIndex, 0.0, 1.0, false, {}};
    struct Parameters {
        double alpha, cosine;
    };
    for (const auto& [alpha, cosine] : {Parameters{0.1, 1.0}, {0.4, 1.0}, {0.1, 0.4}}) {
        OperatorCase one{
            fmt::format("alpha_1 {}, cos_theta {}", alpha, cosine),
            [&run, alpha = alpha, cosine = cosine](double eta) {
                const BaseLight light = simulate_base_light(
                    simulator::StackWalk{figure_10(eta, alpha)}, cosine, kBins,
                    run.options(run.share(kDotShare),
                                fmt::format("eta_0 {} {} {}", eta, alpha, cosine)));
                return std::optional{Measured{light.base.mean[0], light.base.standard_error[0]}};
            },
            {}};
        for (const Form& form : kForms)
            one.formulas.push_back(
                {form.name, [&tables, &form, alpha = alpha, cosine = cosine](double eta) {
                     const Forms forms{figure_10(eta, alpha), tables};
                     return form.of(forms, cosine).albedo.x;
                 }});
        check.cases.push_back(std::move(one));
    }
    return check;
}

}  // namespace

Figure diffuse_algorithm_figure(const StudyRun& run) {
    const EnergyTables tables{share_folder() / "tables"};
    Figure figure{
        "algorithm-1-of-2022", "Algorithm 1 of 2022: a diffuse base in a stack",
        fmt::format(
            "The light that a Lambertian base sends through a stack. 2022 is the published "
            "algorithm: one GGX lobe about the normal, carried up from the coated base through the "
            "interfaces with its energy and variance (Eqs. 12 and 13), where r_(i+1), off which it "
            "comes back up, is all that lies below; as printed, only the next interface, which "
            "leaves out the light that goes back to the base and is some 0.3 too dark where the "
            "base is bright. stack has the exact form of any reciprocal stack, f = T(wi) T(wo) rho "
            "/ (pi n^2 (1 - rho R)), and is the default: it is nearer in energy and in where the "
            "light goes, reciprocal, and has the critical angle, at the cost of T(wi) per light. "
            "For one coat 2022 takes its energy from tables and is nearer than stack's transport. "
            "Figure 10: a smooth coat of index eta_0 over one of index 2 and alpha_1, over a base "
            "of albedo 0.9, 0.1 and 0.1. Random stacks: {} of each number of coats, as in the "
            "figure of that name, every second clear.",
            kStacks),
        "albedo: mean and largest |difference| of the base's part; where it goes: total variation "
        "distance of its light from the simulated, in 16 bins of equal cos_theta"};
    NumberTable table = operator_table();
    add_check(figure, table, over_top_index(tables, run), run);
    add_stacks(figure, table, "figure 10", figure_10_cases(), tables, run);
    for (int coats = 1; coats <= kMostCoats; ++coats)
        add_stacks(figure, table, fmt::format("{} coat{}", coats, coats == 1 ? "" : "s"),
                   random_cases(coats, run), tables, run);
    figure.panels.emplace_back(std::move(table));
    return figure;
}

}  // namespace lacquer::study
