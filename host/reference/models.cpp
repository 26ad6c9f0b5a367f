#include "reference/models.h"

#include <utility>

#include "core/paths.h"
#include "reference/clearcoat.h"
#include "reference/coated.h"
#include "reference/microsurface/microsurface_compensated.h"
#include "reference/microsurface/microsurface_single.h"
#include "reference/openpbr_coat.h"
#include "reference/plain.h"
#include "reference/stack/stack.h"
#include "reference/weidlich_wilkie.h"

namespace lacquer::reference {

namespace {

template <typename Surface>
class SurfaceShading final : public Shading {
 public:
    explicit SurfaceShading(Surface surface) : surface_{std::move(surface)} {}

    glm::dvec3 eval(const glm::dvec3& wi, const glm::dvec3& wo) const override {
        return reference::eval(surface_, wi, wo);
    }
    double pdf(const glm::dvec3& wi, const glm::dvec3& wo) const override {
        return reference::pdf(surface_, wi, wo);
    }
    Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const override {
        return reference::sample(surface_, wo, u);
    }
    Albedo albedo(const glm::dvec3& wo) const override { return reference::albedo(surface_, wo); }

 private:
    Surface surface_;
};

template <typename Surface>
std::shared_ptr<const Shading> shading(Surface surface) {
    return std::make_shared<const SurfaceShading<Surface>>(std::move(surface));
}

const EnergyTables& shipped_tables() {
    static const EnergyTables tables{share_file("tables")};
    return tables;
}

}  // namespace

std::shared_ptr<const Shading> prepare(const Material& material, Model model) {
    switch (model) {
        case Model::plain:
            return shading(prepare_plain(material));
        case Model::clearcoat:
            return shading(prepare_clearcoat(material));
        case Model::weidlich_wilkie:
            return shading(prepare_weidlich_wilkie(material));
        case Model::openpbr_coat:
            return shading(prepare_openpbr_coat(material));
        case Model::coated_ggx:
            return shading(prepare_coated(material, shipped_tables(), BaseLobe::ggx));
        case Model::coated_exact:
            return shading(prepare_coated(material, shipped_tables(), BaseLobe::exact));
        case Model::stack:
            return shading(prepare_stack(material, shipped_tables()));
        case Model::stack_symmetric:
            return shading(prepare_stack(material, shipped_tables(), StackLobes::symmetric));
        case Model::microsurface_single:
            return shading(prepare_microsurface_single(material));
        case Model::microsurface_compensated:
            return shading(prepare_microsurface_compensated(material));
    }
    return nullptr;
}

}  // namespace lacquer::reference
