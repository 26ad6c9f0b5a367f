// The body of Bsdf<Real>, compiled once per precision: include after shader_float.h or
// shader_double.h.
#pragma once

#include <utility>

#include "lacquer/bsdf.h"
#include "shading/one_coat_parameters.h"

namespace lacquer {

using shader::Real;

// A prepared surface with the functions of its level. Only one translation unit per precision sees
// this class, so that its members may have the internal linkage that keeps the shader source's
// names from meeting those of other units.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"
template <>
struct Bsdf<Real>::Shading {
    using Vector = shader::vec3;
    virtual ~Shading() = default;
    virtual Vector eval(const Vector& wi, const Vector& wo) const = 0;
    virtual Vector eval_cos(const Vector& wi, const Vector& wo) const = 0;
    virtual Real pdf(const Vector& wi, const Vector& wo) const = 0;
    virtual shader::LqSample sample(const Vector& wo, const Vector& u) const = 0;
    virtual shader::LqAlbedo albedo(const Vector& wo, int point_count) const = 0;
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

shader::LqOneCoat to_one_coat(const OneCoatParameters& parameters) {
    return {to_facets(parameters.coat),          static_cast<Real>(parameters.coat_eta),
            to_vector(parameters.optical_depth), static_cast<int>(parameters.base_kind),
            to_vector(parameters.albedo),        to_facets(parameters.base_facets),
            to_vector(parameters.eta),           to_vector(parameters.kappa)};
}

// The functions lq_LEVEL_* over a surface that lq_LEVEL_prepare made.
template <auto Eval, auto EvalCos, auto Pdf, auto Sample, auto Albedo, typename Surface>
class Level final : public Bsdf<Real>::Shading {
 public:
    explicit Level(const Surface& surface) : surface_{surface} {}
    Vector eval(const Vector& wi, const Vector& wo) const override {
        return Eval(surface_, wi, wo);
    }
    Vector eval_cos(const Vector& wi, const Vector& wo) const override {
        return EvalCos(surface_, wi, wo);
    }
    Real pdf(const Vector& wi, const Vector& wo) const override { return Pdf(surface_, wi, wo); }
    shader::LqSample sample(const Vector& wo, const Vector& u) const override {
        return Sample(surface_, wo, u);
    }
    shader::LqAlbedo albedo(const Vector& wo, int point_count) const override {
        return Albedo(surface_, wo, point_count);
    }

 private:
    Surface surface_;
};

template <auto Eval, auto EvalCos, auto Pdf, auto Sample, auto Albedo, typename Surface>
std::shared_ptr<const Bsdf<Real>::Shading> level(const Surface& surface) {
    return std::make_shared<const Level<Eval, EvalCos, Pdf, Sample, Albedo, Surface>>(surface);
}

shader::LqCoatedMaterial to_coated(const OneCoatParameters& parameters, int base_lobe) {
    return {to_facets(parameters.coat), static_cast<Real>(parameters.coat_eta),
            to_vector(transmittance(parameters)), to_vector(parameters.albedo), base_lobe};
}

// The tables' own, whatever the number of points.
shader::LqAlbedo coated_albedo(const shader::LqCoatedSurface& surface, const shader::vec3& wo,
                               int) {
    return shader::lq_coated_albedo(surface, wo);
}

std::shared_ptr<const Bsdf<Real>::Shading> shading_of(const Material& material, Model model) {
    using namespace shader;
    const LqOneCoat surface = to_one_coat(one_coat_parameters(material, model));
    switch (model) {
        case Model::plain:
            return level<lq_plain_eval, lq_plain_eval_cos, lq_plain_pdf, lq_plain_sample,
                         lq_plain_albedo>(lq_plain_prepare(surface));
        case Model::clearcoat:
            return level<lq_clearcoat_eval, lq_clearcoat_eval_cos, lq_clearcoat_pdf,
                         lq_clearcoat_sample, lq_clearcoat_albedo>(lq_clearcoat_prepare(surface));
        case Model::weidlich_wilkie:
            return level<lq_weidlich_wilkie_eval, lq_weidlich_wilkie_eval_cos,
                         lq_weidlich_wilkie_pdf, lq_weidlich_wilkie_sample,
                         lq_weidlich_wilkie_albedo>(lq_weidlich_wilkie_prepare(surface));
        case Model::openpbr_coat:
            return level<lq_openpbr_coat_eval, lq_openpbr_coat_eval_cos, lq_openpbr_coat_pdf,
                         lq_openpbr_coat_sample, lq_openpbr_coat_albedo>(
                lq_openpbr_coat_prepare(surface));
        case Model::coated_ggx:
        case Model::coated_exact:
            return level<lq_coated_eval, lq_coated_eval_cos, lq_coated_pdf, lq_coated_sample,
                         coated_albedo>(lq_coated_prepare(
                to_coated(one_coat_parameters(material, model),
                          model == Model::coated_ggx ? LQ_BASE_LOBE_GGX : LQ_BASE_LOBE_EXACT)));
    }
    return nullptr;
}

}  // namespace

template <typename T>
Bsdf<T>::Bsdf(std::shared_ptr<const Shading> shading) : shading_{std::move(shading)} {}

template <typename T>
Vec3<T> Bsdf<T>::eval(const Vec3<T>& wi, const Vec3<T>& wo) const {
    return shading_->eval(wi, wo);
}

template <typename T>
Vec3<T> Bsdf<T>::eval_cos(const Vec3<T>& wi, const Vec3<T>& wo) const {
    return shading_->eval_cos(wi, wo);
}

template <typename T>
T Bsdf<T>::pdf(const Vec3<T>& wi, const Vec3<T>& wo) const {
    return shading_->pdf(wi, wo);
}

template <typename T>
BsdfSample<T> Bsdf<T>::sample(const Vec3<T>& wo, const Vec3<T>& u) const {
    const shader::LqSample chosen = shading_->sample(wo, u);
    return {chosen.wi, chosen.weight, chosen.pdf};
}

template <typename T>
DirectionalAlbedo<T> Bsdf<T>::albedo(const Vec3<T>& wo, int point_count) const {
    const shader::LqAlbedo albedo = shading_->albedo(wo, point_count);
    return {albedo.direct, albedo.base};
}

template class Bsdf<Real>;

template <>
Bsdf<Real> prepare<Real>(const Material& material, Model model) {
    return Bsdf<Real>{shading_of(material, model)};
}

}  // namespace lacquer
