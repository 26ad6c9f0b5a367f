// The body of Bsdf<Real>, compiled once per precision: include after shader_float.h or
// shader_double.h.
#pragma once

#include <utility>
#include <vector>

#include "lacquer/bsdf.h"
#include "shading/microsurface_material.h"
#include "shading/one_coat_parameters.h"
#include "shading/stack_parameters.h"

namespace lacquer {

using shader::Real;

// A prepared surface with the functions of its level. Only one translation unit per precision sees
// this class, so that its members may have the internal linkage that keeps the shader source's
// names from meeting those of other units.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"
template <>
struct BsdfView<Real>::Shading {
    virtual ~Shading() = default;
    virtual shader::vec3 eval_cos(const shader::vec3& wi) const = 0;
};

template <>
struct Bsdf<Real>::Shading : std::enable_shared_from_this<Shading> {
    using Vector = shader::vec3;
    using View = std::shared_ptr<const BsdfView<Real>::Shading>;
    virtual ~Shading() = default;
    virtual View view(const Vector& wo) const = 0;
    virtual Vector eval(const Vector& wi, const Vector& wo) const = 0;
    virtual Vector eval_cos(const Vector& wi, const Vector& wo) const = 0;
    virtual Real pdf(const Vector& wi, const Vector& wo) const = 0;
    virtual shader::LqSample sample(const Vector& wo, const Vector& u) const = 0;
    virtual shader::LqAlbedo albedo(const Vector& wo, int point_count) const = 0;
};
#pragma GCC diagnostic pop

namespace {

shader::LqOneCoat to_one_coat(const OneCoatParameters& parameters) {
    return {to_facets(parameters.coat),          static_cast<Real>(parameters.coat_eta),
            to_vector(parameters.optical_depth), static_cast<int>(parameters.base_kind),
            to_vector(parameters.albedo),        to_facets(parameters.base_facets),
            to_vector(parameters.eta),           to_vector(parameters.kappa)};
}

// The functions of a level (see Functions below) over a surface that lq_LEVEL_prepare made.
template <typename Functions, typename Surface>
class Level final : public Bsdf<Real>::Shading {
 public:
    explicit Level(const Surface& surface) : surface_{surface} {}
    View view(const Vector& wo) const override {
        return std::make_shared<const Viewed>(
            std::static_pointer_cast<const Level>(shared_from_this()), wo);
    }
    Vector eval(const Vector& wi, const Vector& wo) const override {
        return Functions::eval(surface_, wi, wo);
    }
    Vector eval_cos(const Vector& wi, const Vector& wo) const override {
        return Functions::eval_cos(surface_, wi, wo);
    }
    Real pdf(const Vector& wi, const Vector& wo) const override {
        return Functions::pdf(surface_, wi, wo);
    }
    shader::LqSample sample(const Vector& wo, const Vector& u) const override {
        return Functions::sample(surface_, wo, u);
    }
    shader::LqAlbedo albedo(const Vector& wo, int point_count) const override {
        return Functions::albedo(surface_, wo, point_count);
    }

 private:
    class Viewed final : public BsdfView<Real>::Shading {
     public:
        Viewed(std::shared_ptr<const Level> level, const Vector& wo)
            : level_{std::move(level)}, view_{Functions::view(level_->surface_, wo)} {}
        Vector eval_cos(const Vector& wi) const override {
            return Functions::view_eval_cos(level_->surface_, view_, wi);
        }

     private:
        std::shared_ptr<const Level> level_;
        decltype(Functions::view(std::declval<const Surface&>(), Vector{})) view_;
    };

    Surface surface_;
};

// Of a level that finds out nothing about a viewer.
template <auto Eval, auto EvalCos, auto Pdf, auto Sample, auto Albedo>
struct Functions {
    static constexpr auto eval = Eval;
    static constexpr auto eval_cos = EvalCos;
    static constexpr auto pdf = Pdf;
    static constexpr auto sample = Sample;
    static constexpr auto albedo = Albedo;
    static shader::vec3 view(const auto&, const shader::vec3& wo) { return wo; }
    static shader::vec3 view_eval_cos(const auto& surface, const shader::vec3& wo,
                                      const shader::vec3& wi) {
        return EvalCos(surface, wi, wo);
    }
};

template <typename Functions, typename Surface>
std::shared_ptr<const Bsdf<Real>::Shading> level(const Surface& surface) {
    return std::make_shared<const Level<Functions, Surface>>(surface);
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

struct CoatedFunctions : Functions<shader::lq_coated_eval, shader::lq_coated_eval_cos,
                                   shader::lq_coated_pdf, shader::lq_coated_sample, coated_albedo> {
    static constexpr auto view = shader::lq_coated_view;
    static constexpr auto view_eval_cos = shader::lq_coated_view_eval_cos;
};

// A prepared stack with the rows of its layers, which the shader source asks for.
template <typename Surface>
struct WithLayers {
    std::vector<shader::vec4> rows;
    Surface surface;

    // The surface, its rows being this thread's from now on.
    const Surface& in_use() const {
        shader::stack_rows = rows.data();
        return surface;
    }
};

std::vector<shader::vec4> to_rows(const StackParameters& parameters) {
    std::vector<shader::vec4> rows;
    for (const auto& [x, y, z, w] : layer_rows(parameters))
        rows.emplace_back(static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z),
                          static_cast<Real>(w));
    return rows;
}

// `prepare` is lq_LEVEL_prepare.
template <typename Surface>
WithLayers<Surface> to_stack(const StackParameters& parameters,
                             Surface (*prepare)(shader::LqStackMaterial)) {
    WithLayers<Surface> stack{to_rows(parameters), {}};
    shader::stack_rows = stack.rows.data();
    stack.surface = prepare({0, static_cast<int>(parameters.layers.size()),
                             static_cast<int>(parameters.base_kind), to_vector(parameters.albedo),
                             to_facets(parameters.base_facets), to_vector(parameters.eta),
                             to_vector(parameters.kappa)});
    return stack;
}

// Of a level whose functions read layers.
template <auto Eval, auto EvalCos, auto Pdf, auto Sample, auto Albedo, auto View, auto ViewEvalCos>
struct LayeredFunctions {
    using Vector = shader::vec3;
    static Vector eval(const auto& stack, const Vector& wi, const Vector& wo) {
        return Eval(stack.in_use(), wi, wo);
    }
    static Vector eval_cos(const auto& stack, const Vector& wi, const Vector& wo) {
        return EvalCos(stack.in_use(), wi, wo);
    }
    static Real pdf(const auto& stack, const Vector& wi, const Vector& wo) {
        return Pdf(stack.in_use(), wi, wo);
    }
    static shader::LqSample sample(const auto& stack, const Vector& wo, const Vector& u) {
        return Sample(stack.in_use(), wo, u);
    }
    static shader::LqAlbedo albedo(const auto& stack, const Vector& wo, int) {
        return Albedo(stack.in_use(), wo);
    }
    static auto view(const auto& stack, const Vector& wo) { return View(stack.in_use(), wo); }
    static Vector view_eval_cos(const auto& stack, const auto& viewer, const Vector& wi) {
        return ViewEvalCos(stack.in_use(), viewer, wi);
    }
};

using StackFunctions =
    LayeredFunctions<shader::lq_stack_eval, shader::lq_stack_eval_cos, shader::lq_stack_pdf,
                     shader::lq_stack_sample, shader::lq_stack_albedo, shader::lq_stack_view,
                     shader::lq_stack_view_eval_cos>;

using StackSymmetricFunctions =
    LayeredFunctions<shader::lq_stack_symmetric_eval, shader::lq_stack_symmetric_eval_cos,
                     shader::lq_stack_symmetric_pdf, shader::lq_stack_symmetric_sample,
                     shader::lq_stack_symmetric_albedo, shader::lq_stack_symmetric_view,
                     shader::lq_stack_symmetric_view_eval_cos>;

std::shared_ptr<const Bsdf<Real>::Shading> shading_of(const Material& material, Model model) {
    using namespace shader;
    if (model == Model::stack)
        return level<StackFunctions>(to_stack(stack_parameters(material, model), lq_stack_prepare));
    if (model == Model::stack_symmetric)
        return level<StackSymmetricFunctions>(
            to_stack(stack_parameters(material, model), lq_stack_symmetric_prepare));
    if (model == Model::microsurface_single)
        return level<Functions<lq_microsurface_single_eval, lq_microsurface_single_eval_cos,
                               lq_microsurface_single_pdf, lq_microsurface_single_sample,
                               lq_microsurface_single_albedo>>(
            lq_microsurface_prepare(to_microsurface(microsurface_parameters(material, model))));
    if (model == Model::microsurface_compensated) {
        const MicrosurfaceParameters surface = microsurface_parameters(material, model);
        return level<
            Functions<lq_microsurface_compensated_eval, lq_microsurface_compensated_eval_cos,
                      lq_microsurface_compensated_pdf, lq_microsurface_compensated_sample,
                      lq_microsurface_compensated_albedo>>(
            lq_microsurface_compensated_prepare(to_microsurface(surface),
                                                to_several_facets(surface)));
    }
    const OneCoatParameters parameters = one_coat_parameters(material, model);
    const LqOneCoat surface = to_one_coat(parameters);
    switch (model) {
        case Model::plain:
            return level<Functions<lq_plain_eval, lq_plain_eval_cos, lq_plain_pdf, lq_plain_sample,
                                   lq_plain_albedo>>(lq_plain_prepare(surface));
        case Model::clearcoat:
            return level<Functions<lq_clearcoat_eval, lq_clearcoat_eval_cos, lq_clearcoat_pdf,
                                   lq_clearcoat_sample, lq_clearcoat_albedo>>(
                lq_clearcoat_prepare(surface));
        case Model::weidlich_wilkie:
            return level<Functions<lq_weidlich_wilkie_eval, lq_weidlich_wilkie_eval_cos,
                                   lq_weidlich_wilkie_pdf, lq_weidlich_wilkie_sample,
                                   lq_weidlich_wilkie_albedo>>(lq_weidlich_wilkie_prepare(surface));
        case Model::openpbr_coat:
            return level<
                Functions<lq_openpbr_coat_eval, lq_openpbr_coat_eval_cos, lq_openpbr_coat_pdf,
                          lq_openpbr_coat_sample, lq_openpbr_coat_albedo>>(
                lq_openpbr_coat_prepare(surface));
        case Model::coated_ggx:
        case Model::coated_exact:
            return level<CoatedFunctions>(lq_coated_prepare(to_coated(
                parameters, model == Model::coated_ggx ? LQ_BASE_LOBE_GGX : LQ_BASE_LOBE_EXACT)));
        case Model::stack:
        case Model::stack_symmetric:
        case Model::microsurface_single:
        case Model::microsurface_compensated:
            break;
    }
    return nullptr;
}

}  // namespace

template <typename T>
BsdfView<T>::BsdfView(std::shared_ptr<const Shading> shading) : shading_{std::move(shading)} {}

template <typename T>
Vec3<T> BsdfView<T>::eval_cos(const Vec3<T>& wi) const {
    return shading_->eval_cos(wi);
}

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
BsdfView<T> Bsdf<T>::view(const Vec3<T>& wo) const {
    return BsdfView<T>{shading_->view(wo)};
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
    return {albedo.direct, albedo.base, albedo.transmitted};
}

template class BsdfView<Real>;
template class Bsdf<Real>;

template <>
Bsdf<Real> prepare<Real>(const Material& material, Model model) {
    return Bsdf<Real>{shading_of(material, model)};
}

}  // namespace lacquer
