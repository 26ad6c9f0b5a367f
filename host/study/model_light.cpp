#include "study/model_light.h"

#include <numbers>

#include "study/even_point.h"

namespace lacquer::study {

namespace {

constexpr int kPoints = 2048;

Material over_black(Material material) {
    material.base = LambertianBase{};
    return material;
}

}  // namespace

ModelLight::ModelLight(const Material& material, Model model)
    : name_{model_name(model)},
      has_albedo_{reads_tables(model)},
      shading_{reference::prepare(material, model)},
      over_black_{reference::prepare(over_black(material), model)} {}

ModelLight::ModelLight(std::string name, std::shared_ptr<const reference::Shading> shading)
    : name_{std::move(name)}, shading_{std::move(shading)} {}

ModelLight::ModelLight(std::string name, std::shared_ptr<const reference::Shading> shading,
                       std::shared_ptr<const reference::Shading> over_black)
    : name_{std::move(name)}, shading_{std::move(shading)}, over_black_{std::move(over_black)} {}

ModelLight ModelLight::integrated(const Material& material, Model model) {
    return ModelLight{material, model}.integrated();
}

ModelLight ModelLight::integrated() const {
    ModelLight light = *this;
    light.has_albedo_ = false;
    return light;
}

glm::dvec3 ModelLight::eval(const glm::dvec3& wi, const glm::dvec3& wo) const {
    return shading_->eval(wi, wo);
}

glm::dvec3 ModelLight::base(const glm::dvec3& wi, const glm::dvec3& wo) const {
    return shading_->eval(wi, wo) - over_black_->eval(wi, wo);
}

reference::Sample ModelLight::sample(const glm::dvec3& wo, const glm::dvec3& u) const {
    return shading_->sample(wo, u);
}

reference::Albedo ModelLight::albedo(const glm::dvec3& wo) const {
    if (has_albedo_) return shading_->albedo(wo);
    reference::Albedo albedo;
    glm::dvec3 total{0.0};
    for (int n = 0; n < kPoints; ++n) {
        const glm::dvec3 u = even_point(n);
        total += shading_->sample(wo, u).weight;
        albedo.base += std::numbers::pi * base(reference::sample_cosine({u.y, u.z}), wo);
    }
    albedo.base /= kPoints;
    albedo.direct = total / double{kPoints} - albedo.base;
    return albedo;
}

}  // namespace lacquer::study
