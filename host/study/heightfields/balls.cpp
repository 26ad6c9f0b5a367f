// Figures 7, 9, 10, 11 and 17 of d'Eon et al. 2023, as balls.
#include <fmt/format.h>

#include <array>

#include "study/heightfields/blend_pictures.h"
#include "study/heightfields/blended_material.h"
#include "study/heightfields/suite.h"
#include "study/layered/stacks.h"

namespace lacquer::study {

namespace {

// The same base under another surface.
template <typename OneBase>
OneBase with(OneBase base, Roughness roughness) {
    base.roughness = std::move(roughness);
    return base;
}

DiffuseFacetsBase diffuse(const Rgb& albedo, Roughness roughness) {
    return {albedo, std::move(roughness)};
}

Stratum diffuse_stratum(double weight, double alpha, const Rgb& albedo) {
    Stratum result = stratum(weight, alpha);
    result.albedo = albedo;
    return result;
}

// Both orders of two halves.
std::array<Blend, 2> both_orders(const Stratum& smooth, const Stratum& rough) {
    return {asymmetric({smooth, rough}), asymmetric({rough, smooth})};
}

constexpr const char* kSmoothAbove = "smooth above rough";
constexpr const char* kRoughAbove = "rough above smooth";

}  // namespace

Figure layouts_figure(const StudyRun& run) {
    Figure figure{
        "figure-7", "Figure 7: five surfaces with the same facets",
        "Silver whose facets are in halves of alpha 0.02 and 1, Beckmann, in five orders. Smooth "
        "facets on top hide nothing of what lies below, and the linear blend is right; rough ones "
        "above them hide them at grazing angles, where the linear blend keeps their mirror image. "
        "What meets one facet is too dark: rough metal passes light on from facet to facet.",
        kBlendMeasure};
    const Ndf ndf = Ndf::beckmann;
    const Stratum smooth = stratum(0.5, 0.02, ndf), rough = stratum(0.5, 1.0, ndf);
    const Stratum half_smooth = stratum(0.25, 0.02, ndf), half_rough = stratum(0.25, 1.0, ndf);
    const ConductorBase silver = metal("silver", 0.0);
    const std::array materials{
        bare("(a) smooth above rough", with(silver, asymmetric({smooth, rough}))),
        bare("(b) rough above smooth", with(silver, asymmetric({rough, smooth}))),
        bare("(c) rough between smooth",
             with(silver, asymmetric({half_smooth, rough, half_smooth}))),
        bare("(d) smooth between rough",
             with(silver, asymmetric({half_rough, smooth, half_rough}))),
        bare("(e) mixed at all heights", with(silver, symmetric({smooth, rough})))};
    add_blends(figure, "In the studio", materials, studio_ball(run), run);
    return figure;
}

Figure lit_diffuse_figure(const StudyRun& run) {
    Figure figure{
        "figure-9", "Figure 9: diffuse facets as the light moves",
        "Green diffuse facets of alpha 0.2 and 0.8 in halves, under one light. The further the "
        "light is "
        "from the viewer, the more the upper facets count for both, and the more the linear blend "
        "is "
        "off; with the rough ones above most of all. No model here shades diffuse facets.",
        kBlendMeasure};
    const Rgb green{0.3, 0.6, 0.1};
    const auto orders = both_orders(stratum(0.5, 0.2), stratum(0.5, 0.8));
    const std::array materials{bare(kSmoothAbove, diffuse(green, orders[0])),
                               bare(kRoughAbove, diffuse(green, orders[1]))};
    for (const double angle_deg : {30.0, 80.0, 130.0})
        add_blends(figure, fmt::format("Light at {:g} degrees from the viewer", angle_deg),
                   materials, lit_ball(angle_deg, run), run);
    return figure;
}

Figure damaged_gold_figure(const StudyRun& run) {
    Figure figure{
        "figure-10", "Figure 10: gold, damaged inwards",
        "Gold of alpha 0.01, damaged to 0.8 below its surface. What is left of the surface hides "
        "nothing of the damage, so that the linear blend is the same within noise. What meets one "
        "facet lacks the light that goes on between facets of the damage.",
        kBlendMeasure};
    std::vector<Material> materials;
    for (const double weight : {0.75, 0.5, 0.25})
        materials.push_back(
            bare(fmt::format("{:g} % left whole", 100.0 * weight),
                 with(metal("gold", 0.0),
                      asymmetric({stratum(weight, 0.01), stratum(1.0 - weight, 0.8)}))));
    add_blends(figure, "In the studio", materials, studio_ball(run), run);
    return figure;
}

Figure diffuse_and_coated_figure(const StudyRun& run) {
    Figure figure{"figure-11", "Figure 11: diffuse facets, and a coat of two roughnesses",
                  "Facets of alpha 0.02 and 0.8 in halves, diffuse ones, and those of a coat of "
                  "index 1.5. Smooth "
                  "above rough the linear blend is the same within noise; rough above smooth it "
                  "shows a mirror "
                  "image at grazing angles that the rough facets hide.",
                  kBlendMeasure};
    const auto orders = both_orders(stratum(0.5, 0.02), stratum(0.5, 0.8));
    const Rgb blue{0.05, 0.6, 0.8};
    const auto coated = [&](const std::string& name, const Blend& blend) {
        return stack_of(name, {{{1.5, blend}, AbsorbingMedium{}}}, LambertianBase{blue});
    };
    add_blends(figure, "Diffuse facets",
               std::array{bare(kSmoothAbove, diffuse(blue, orders[0])),
                          bare(kRoughAbove, diffuse(blue, orders[1]))},
               studio_ball(run), run);
    add_blends(figure, "A coat of index 1.5 over a Lambertian base",
               std::array{coated("coat, smooth above rough", orders[0]),
                          coated("coat, rough above smooth", orders[1])},
               studio_ball(run), run);
    return figure;
}

Figure diffuse_colors_figure(const StudyRun& run) {
    Figure figure{"figure-17", "Figure 17: diffuse facets of two colours",
                  "Blue facets of alpha 0.1 and orange ones of 0.9 in halves. Blue above orange "
                  "looks like the "
                  "linear blend; orange above blue turns orange towards grazing angles, where the "
                  "blue facets "
                  "are hidden.",
                  kBlendMeasure};
    const auto orders = both_orders(diffuse_stratum(0.5, 0.1, {0.1, 0.3, 0.8}),
                                    diffuse_stratum(0.5, 0.9, {0.9, 0.45, 0.1}));
    add_blends(figure, "In the studio",
               std::array{bare("smooth blue above rough orange", diffuse({}, orders[0])),
                          bare("rough orange above smooth blue", diffuse({}, orders[1]))},
               studio_ball(run), run);
    return figure;
}

}  // namespace lacquer::study
