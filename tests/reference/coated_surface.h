// Coated surfaces of the committed tables, for tests.
#pragma once

#include "reference/coated.h"

namespace lacquer::reference::surfaces {

// What the tables promise over their whole range (tables/README.md), and what they keep to nearly
// everywhere.
inline constexpr double kTableError = 0.01;
inline constexpr double kUsualTableError = 0.003;

inline const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

inline Material coated(double eta, Microsurface microsurface, const Rgb& tau, const Rgb& albedo) {
    Material material;
    material.name = "test";
    material.layers.push_back({{eta, microsurface}, AbsorbingMedium{tau}});
    material.base = LambertianBase{albedo};
    return material;
}

inline Microsurface ggx(double alpha) {
    return {Ndf::ggx, {alpha, alpha}};
}

inline constexpr Rgb kWhite{1.0, 1.0, 1.0};
inline constexpr Rgb kClay{0.5, 0.3, 0.2};
inline constexpr Rgb kGlazeTau{0.7, 0.9, 0.4};

inline CoatedSurface prepare(const Material& material, BaseLobe shape = BaseLobe::exact) {
    return prepare_coated(material, tables(), shape);
}

}  // namespace lacquer::reference::surfaces
