// Figures 3, 4 and 20 of 2018: how wide light is after one and two rough reflections.
#include <fmt/format.h>

#include <array>

#include "reference/stack/lobe_width.h"
#include "reference/stack/published/operators_2018.h"
#include "study/layered/operators/lobes.h"
#include "study/layered/operators/operator_plot.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

namespace published = reference::published_2018;

constexpr Abscissa kAlpha{"alpha", 0.02, 1.0};
constexpr Abscissa kSecondAlpha{"alpha_2", 0.02, 1.0};
constexpr double kWidthTop = 0.6;
constexpr std::uint64_t kDotShare = 1 << 6;

double sum_of_squares(double first, double second) {
    using namespace reference;
    return alpha_of_width(width_of_variance(variance_of_width(width_of_alpha(first)) +
                                            variance_of_width(width_of_alpha(second))));
}

double sum_of_2018(double first, double second) {
    return published::alpha_of_variance(published::variance_of_alpha(first) +
                                        published::variance_of_alpha(second));
}

// After reflection by parallel mirrors, all of its light.
std::optional<Measured> simulated_width(const std::vector<double>& alphas, double cosine,
                                        const StudyRun& run) {
    std::vector<simulator::SurfaceWalk> surfaces;
    std::string name = fmt::format("bounces {}", cosine);
    for (const double alpha : alphas) {
        surfaces.push_back(mirrors(Ndf::ggx, alpha));
        name += fmt::format(" {}", alpha);
    }
    const Spread spread = simulate_spread(
        run.options(run.share(kDotShare), name), [&](simulator::RandomStream& random) {
            glm::dvec3 direction = downwards(cosine);
            for (const simulator::SurfaceWalk& surface : surfaces)
                direction = turned_over(surface.cross(direction, random).direction);
            return Ray{direction, 1.0};
        });
    return Measured{spread.width, spread.width_error};
}

OperatorCheck one_bounce(const StudyRun& run) {
    OperatorCheck check{"one reflection", "width", kAlpha, 0.0, kWidthTop, true, {}};
    for (const double cosine : {1.0, 0.5, 0.2})
        check.cases.push_back(
            {fmt::format("cos_theta {}", cosine),
             [=, &run](double alpha) { return simulated_width({alpha}, cosine, run); },
             {{"lobe", [=](double alpha) { return ggx_lobe(alpha, cosine).width; }}}});
    return check;
}

// `first` of the second's alpha.
OperatorCase two_bounces(const std::string& title, double cosine,
                         const std::function<double(double)>& first, const StudyRun& run) {
    return {title,
            [=, &run](double alpha) {
                return simulated_width({first(alpha), alpha}, cosine, run);
            },
            {{"stack",
              [=](double alpha) {
                  return ggx_lobe(sum_of_squares(first(alpha), alpha), cosine).width;
              }},
             {"2018", [=](double alpha) {
                  return ggx_lobe(sum_of_2018(first(alpha), alpha), cosine).width;
              }}}};
}

OperatorCheck equal_bounces(const StudyRun& run) {
    OperatorCheck check{"two equal reflections", "width", kAlpha, 0.0, kWidthTop, true, {}};
    for (const double cosine : {1.0, 0.5, 0.2})
        check.cases.push_back(two_bounces(
            fmt::format("cos_theta {}", cosine), cosine, [](double alpha) { return alpha; }, run));
    return check;
}

OperatorCheck any_bounces(double cosine, const StudyRun& run) {
    OperatorCheck check{fmt::format("two reflections, cos_theta {}", cosine),
                        "width",
                        kSecondAlpha,
                        0.0,
                        kWidthTop,
                        true,
                        {}};
    for (const double first : {0.05, 0.15, 0.3})
        check.cases.push_back(two_bounces(
            fmt::format("alpha_1 {}", first), cosine, [=](double) { return first; }, run));
    return check;
}

}  // namespace

Figure reflection_operator_figure(const StudyRun& run) {
    Figure figure{
        "figure-4", "Figures 3, 4 and 20: rough reflections",
        "Parallel perfect mirrors, light that meets several facets included. lobe: the GGX lobe of "
        "single reflections by which models stand for it, which is too wide for alpha above 0.6: "
        "what meets several facets is spread evenly, as wide as 0.5. Two reflections: stack adds f "
        "= alpha^2 / (1 - alpha^2), 2018 f = alpha^1.1 / (1 - alpha^1.1) (Eqs. 5 and 6), and a "
        "GGX lobe of the roughness of the sum stands for both. For one ray and two reflections "
        "the paper's fit is the nearer one, and of all powers 1.1 is the best; alpha^2 is too "
        "narrow for middling roughnesses. stack keeps it all the same: on random stacks of one to "
        "three coats over metals, alpha to 0.6, it leaves 82 to 97 % of the widths within a "
        "tenth, alpha^1.1 57 to 91 %, since what stack adds up is averaged over lobes and paths "
        "before and after.",
        "width (standard deviation on the projected disk): mean and largest |difference| as a "
        "share of the simulated"};
    NumberTable table = operator_table();
    add_check(figure, table, one_bounce(run), run);
    add_check(figure, table, equal_bounces(run), run);
    for (const double cosine : {1.0, 0.5}) add_check(figure, table, any_bounces(cosine, run), run);
    figure.panels.emplace_back(std::move(table));
    return figure;
}

}  // namespace lacquer::study
