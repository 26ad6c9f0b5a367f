#include "backends/pack.h"

#include "backends/pack_coated.h"
#include "backends/pack_microsurface.h"
#include "backends/pack_one_coat.h"
#include "backends/pack_stack.h"

namespace lacquer {

std::size_t surface_rows(Model model) {
    switch (model) {
        case Model::plain:
        case Model::clearcoat:
        case Model::weidlich_wilkie:
        case Model::openpbr_coat:
            return kOneCoatRows;
        case Model::coated_ggx:
        case Model::coated_exact:
            return kCoatedRows;
        case Model::stack:
        case Model::stack_symmetric:
            return kStackRows;
        case Model::microsurface_single:
            return kMicrosurfaceRows;
        case Model::microsurface_compensated:
            return kMicrosurfaceRows + kSeveralFacetsRows;
    }
    return 0;
}

std::vector<glm::vec4> pack_surfaces(Model model, std::span<const Material> materials) {
    std::vector<glm::vec4> rows;
    rows.reserve(materials.size() * surface_rows(model));
    for (const Material& material : materials) {
        switch (model) {
            case Model::plain:
            case Model::clearcoat:
            case Model::weidlich_wilkie:
            case Model::openpbr_coat: {
                const auto packed = pack_one_coat(material, model);
                rows.insert(rows.end(), packed.begin(), packed.end());
                break;
            }
            case Model::coated_ggx:
            case Model::coated_exact: {
                const auto packed = pack_coated(material, model);
                rows.insert(rows.end(), packed.begin(), packed.end());
                break;
            }
            case Model::stack:
            case Model::stack_symmetric: {
                const auto packed = pack_stack(material, model);
                rows.insert(rows.end(), packed.begin(), packed.end());
                break;
            }
            case Model::microsurface_single: {
                const auto packed = pack_microsurface(material, model);
                rows.insert(rows.end(), packed.begin(), packed.end());
                break;
            }
            case Model::microsurface_compensated: {
                const auto packed = pack_microsurface(material, model);
                const auto several = pack_several_facets(material, model);
                rows.insert(rows.end(), packed.begin(), packed.end());
                rows.insert(rows.end(), several.begin(), several.end());
            }
        }
    }
    return rows;
}

}  // namespace lacquer
