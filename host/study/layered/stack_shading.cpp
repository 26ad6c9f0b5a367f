#include "study/layered/stack_shading.h"

#include <tbb/enumerable_thread_specific.h>

#include <optional>
#include <utility>

#include "reference/stack/stack.h"

namespace lacquer::study {

namespace {

class StackShading final : public reference::Shading {
 public:
    explicit StackShading(reference::StackSurface surface) : surface_{std::move(surface)} {}

    glm::dvec3 eval(const glm::dvec3& wi, const glm::dvec3& wo) const override {
        if (!reference::is_above(wo)) return glm::dvec3{0.0};
        return reference::eval(seen_from(wo), wi);
    }
    double pdf(const glm::dvec3& wi, const glm::dvec3& wo) const override {
        if (!reference::is_above(wo)) return 0.0;
        return reference::pdf(seen_from(wo), wi);
    }
    reference::Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const override {
        if (!reference::is_above(wo)) return {};
        return reference::sample(seen_from(wo), u);
    }
    reference::Albedo albedo(const glm::dvec3& wo) const override {
        return reference::albedo(surface_, wo);
    }

 private:
    const reference::StackView& seen_from(const glm::dvec3& wo) const {
        std::optional<reference::StackView>& last = last_.local();
        if (!last || last->wo != wo) last.emplace(reference::view(surface_, wo));
        return *last;
    }

    reference::StackSurface surface_;
    mutable tbb::enumerable_thread_specific<std::optional<reference::StackView>> last_;
};

}  // namespace

std::shared_ptr<const reference::Shading> stack_shading(const Material& material,
                                                        const EnergyTables& tables) {
    return std::make_shared<const StackShading>(reference::prepare_stack(material, tables));
}

}  // namespace lacquer::study
