// What studies ask of models, against closed forms and the models' own formulas.
#include "study/model_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lacquer::study {
namespace {

// Of an average over 2048 points of integrands whose slopes are of order 1.
constexpr double kIntegral = 2e-3;

Material coated(double eta, double alpha, const Rgb& albedo) {
    Material material;
    material.layers.push_back({{eta, Microsurface{Ndf::ggx, {alpha, alpha}}}, AbsorbingMedium{}});
    material.base = LambertianBase{albedo};
    return material;
}

const glm::dvec3 kViewer{0.6, 0.0, 0.8};

TEST(ModelLight, BaseOfPlainIsLambertian) {
    const ModelLight model{coated(1.5, 0.3, {0.2, 0.5, 1.0}), Model::plain};
    const glm::dvec3 base = model.base({0.0, 0.6, 0.8}, kViewer);
    EXPECT_NEAR(base.x, 0.2 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(base.z, 1.0 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(model.albedo(kViewer).base.y, 0.5, 1e-12);
}

TEST(ModelLight, NoContrastNoCoat) {
    const auto albedo = ModelLight{coated(1.0, 0.3, {0.5, 0.5, 0.5}), Model::plain}.albedo(kViewer);
    EXPECT_NEAR(albedo.direct.x, 0.0, kIntegral);
    EXPECT_NEAR(albedo.base.x, 0.5, 1e-12);
}

TEST(ModelLight, IntegralsAgreeWithTheModelsFormulas) {
    // The base's lobe alone: the coat's integral is off by what coat_albedo says.
    for (const double eta : {0.8, 1.5}) {
        const Material material = coated(eta, 0.3, {0.9, 0.6, 0.3});
        const auto formula = ModelLight{material, Model::coated_exact}.albedo(kViewer);
        const auto integral = ModelLight::integrated(material, Model::coated_exact).albedo(kViewer);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(integral.base[channel], formula.base[channel], kIntegral) << eta;
    }
    const Material material = coated(1.5, 0.3, {0.9, 0.6, 0.3});
    const auto formula = reference::prepare(material, Model::weidlich_wilkie)->albedo(kViewer);
    const auto integral = ModelLight{material, Model::weidlich_wilkie}.albedo(kViewer);
    EXPECT_NEAR(integral.base.x, formula.base.x, kIntegral);
    EXPECT_NEAR(integral.direct.x, formula.direct.x, kIntegral);
}

}  // namespace
}  // namespace lacquer::study
