// The library's shading for C++ renderers: the shader source itself, compiled in float or double.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// Directions are unit, in a local frame whose z is the surface normal, and point away from the
// surface: `wi` to the light, `wo` to the viewer. RGB values are linear.
template <typename Real>
using Vec3 = glm::vec<3, Real>;

// A direction of light chosen for a viewer. `weight` is f cos_theta_i / pdf; a sample that carries
// no light has weight 0. `pdf` is per steradian.
template <typename Real>
struct BsdfSample {
    Vec3<Real> wi;
    Vec3<Real> weight;
    Real pdf;
};

// Directional albedo split by where the light turned back. Each channel is in [0, 1] for a model
// that conserves energy; `plain` and `weidlich-wilkie` may exceed 1 in sum.
template <typename Real>
struct DirectionalAlbedo {
    Vec3<Real> direct;       // never reached the base
    Vec3<Real> base;         // reflected by the base
    Vec3<Real> transmitted;  // left below, where no base is
};

// A viewer of a surface, for any number of lights. Immutable and cheap to copy; it may outlive the
// Bsdf that it comes from.
template <typename Real>
class BsdfView {
 public:
    // f(wi, wo) |cos_theta_i| for light from wi.
    Vec3<Real> eval_cos(const Vec3<Real>& wi) const;

    struct Shading;  // the compiled shader source behind the member
    explicit BsdfView(std::shared_ptr<const Shading> shading);

 private:
    std::shared_ptr<const Shading> shading_;
};

// A material made ready for one model. Immutable and cheap to copy; usable from any thread. No
// member returns NaN, infinity or a negative value for any finite input. Real is float or double.
template <typename Real>
class Bsdf {
 public:
    // f(wi, wo) per steradian, without the cosine. Zero where wi and wo are on opposite sides and
    // the model does not transmit.
    Vec3<Real> eval(const Vec3<Real>& wi, const Vec3<Real>& wo) const;

    // f(wi, wo) |cos_theta_i|.
    Vec3<Real> eval_cos(const Vec3<Real>& wi, const Vec3<Real>& wo) const;

    // What depends on wo alone, worked out once, for many lights. Only the coated models have much of
    // it; making a view allocates.
    BsdfView<Real> view(const Vec3<Real>& wo) const;

    // Density per steradian with which sample() chooses wi.
    Real pdf(const Vec3<Real>& wi, const Vec3<Real>& wo) const;

    // Chooses wi for wo from uniform numbers u in [0, 1)^3.
    BsdfSample<Real> sample(const Vec3<Real>& wo, const Vec3<Real>& u) const;

    // Directional albedo at wo; `point_count` >= 1 low-discrepancy points where no closed form is
    // known (256 give about three digits).
    DirectionalAlbedo<Real> albedo(const Vec3<Real>& wo, int point_count = 1024) const;

    struct Shading;  // the compiled shader source behind the members
    explicit Bsdf(std::shared_ptr<const Shading> shading);

 private:
    std::shared_ptr<const Shading> shading_;
};

// Makes `material` ready for `model`; the tables that the coated models read are in the library.
// Throws Error naming the material and the JSON pointer of a feature that the model cannot shade.
template <typename Real>
Bsdf<Real> prepare(const Material& material, Model model = Model::plain);

extern template class BsdfView<float>;
extern template class BsdfView<double>;
extern template class Bsdf<float>;
extern template class Bsdf<double>;
template <>
Bsdf<float> prepare<float>(const Material& material, Model model);
template <>
Bsdf<double> prepare<double>(const Material& material, Model model);

}  // namespace lacquer
