// The body of Bsdf<Real>, compiled once per precision: include after shader_float.h or
// shader_double.h.
#pragma once

#include <utility>

#include "lacquer/bsdf.h"
#include "shading/plain_parameters.h"

namespace lacquer {

using shader::Real;

// Only one translation unit per precision sees this struct, so that its members may have the
// internal linkage that keeps the shader source's names from meeting those of other units.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"
template <>
struct Bsdf<Real>::Shading {
    shader::LqPlainSurface surface;
};
#pragma GCC diagnostic pop

namespace {

Vec3<Real> to_vector(const Rgb& rgb) {
    return {static_cast<Real>(rgb[0]), static_cast<Real>(rgb[1]), static_cast<Real>(rgb[2])};
}

shader::LqFacets to_facets(const Microsurface& microsurface) {
    return {microsurface.ndf == Ndf::beckmann ? shader::LQ_NDF_BECKMANN : shader::LQ_NDF_GGX,
            static_cast<Real>(microsurface.alpha[0]), static_cast<Real>(microsurface.alpha[1])};
}

shader::LqPlainSurface to_plain_surface(const PlainParameters& parameters) {
    return {to_facets(parameters.coat),
            static_cast<Real>(parameters.coat_eta),
            static_cast<int>(parameters.base_kind),
            to_vector(parameters.albedo),
            to_facets(parameters.base_facets),
            to_vector(parameters.eta),
            to_vector(parameters.kappa)};
}

}  // namespace

template <typename T>
Bsdf<T>::Bsdf(std::shared_ptr<const Shading> shading) : shading_{std::move(shading)} {}

template <typename T>
Vec3<T> Bsdf<T>::eval(const Vec3<T>& wi, const Vec3<T>& wo) const {
    return shader::lq_plain_eval(shading_->surface, wi, wo);
}

template <typename T>
Vec3<T> Bsdf<T>::eval_cos(const Vec3<T>& wi, const Vec3<T>& wo) const {
    return shader::lq_plain_eval_cos(shading_->surface, wi, wo);
}

template <typename T>
T Bsdf<T>::pdf(const Vec3<T>& wi, const Vec3<T>& wo) const {
    return shader::lq_plain_pdf(shading_->surface, wi, wo);
}

template <typename T>
BsdfSample<T> Bsdf<T>::sample(const Vec3<T>& wo, const Vec3<T>& u) const {
    const shader::LqSample chosen = shader::lq_plain_sample(shading_->surface, wo, u);
    return {chosen.wi, chosen.weight, chosen.pdf};
}

template <typename T>
DirectionalAlbedo<T> Bsdf<T>::albedo(const Vec3<T>& wo, int point_count) const {
    const shader::LqAlbedo albedo = shader::lq_plain_albedo(shading_->surface, wo, point_count);
    return {albedo.direct, albedo.base};
}

template class Bsdf<Real>;

template <>
Bsdf<Real> prepare<Real>(const Material& material, Model) {
    using Shading = Bsdf<Real>::Shading;
    return Bsdf<Real>{std::make_shared<const Shading>(
        Shading{shader::lq_plain_prepare(to_plain_surface(plain_parameters(material)))})};
}

}  // namespace lacquer
