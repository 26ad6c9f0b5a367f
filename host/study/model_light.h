// A model's answers as studies ask for them: f, the base's part of it, and directional albedos.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "core/model.h"
#include "lacquer/material.h"
#include "reference/models.h"

namespace lacquer::study {

class ModelLight {
 public:
    // A material that the model can shade.
    ModelLight(const Material& material, Model model);

    // The same, its albedo always the integral of its lobes.
    static ModelLight integrated(const Material& material, Model model);

    // A variant of coated-exact or coated-ggx under a name of its own.
    ModelLight(std::string name, std::shared_ptr<const reference::Shading> shading);

    // Any model, with the same material over a black base.
    ModelLight(std::string name, std::shared_ptr<const reference::Shading> shading,
               std::shared_ptr<const reference::Shading> over_black);

    // The same, its albedo always the integral of its lobes.
    ModelLight integrated() const;

    const std::string& name() const { return name_; }

    glm::dvec3 eval(const glm::dvec3& wi, const glm::dvec3& wo) const;

    // What a black base would take away. Of a model, not of a variant.
    glm::dvec3 base(const glm::dvec3& wi, const glm::dvec3& wo) const;

    // By the model's own density; see its header.
    reference::Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const;

    // The model's own albedo where it has a formula; else its integral, to about 0.001.
    reference::Albedo albedo(const glm::dvec3& wo) const;

    // Whether that is a formula, which takes no time.
    bool has_albedo() const { return has_albedo_; }

 private:
    std::string name_;
    bool has_albedo_ = true;
    std::shared_ptr<const reference::Shading> shading_, over_black_;
};

}  // namespace lacquer::study
