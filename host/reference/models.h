// Every model of the reference behind one interface.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "core/model.h"
#include "lacquer/material.h"
#include "reference/shading.h"

namespace lacquer::reference {

// A material prepared for a model: the functions of the model's own header.
class Shading {
 public:
    virtual ~Shading() = default;
    virtual glm::dvec3 eval(const glm::dvec3& wi, const glm::dvec3& wo) const = 0;
    virtual double pdf(const glm::dvec3& wi, const glm::dvec3& wo) const = 0;
    virtual Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const = 0;
    virtual Albedo albedo(const glm::dvec3& wo) const = 0;
};

// Throws Error naming the material and the JSON pointer of what `model` cannot shade.
std::shared_ptr<const Shading> prepare(const Material& material, Model model);

}  // namespace lacquer::reference
