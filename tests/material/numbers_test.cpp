// The numbers of a material under their JSON pointers.
#include "material/numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "cases.h"
#include "core/error.h"

namespace lacquer {
namespace {

using testing::HasSubstr;

Material right(const std::string& name) {
    for (const test::MaterialCase& entry : test::right_cases())
        if (entry.name == name) return parse_material(entry.text, test::kOrigin);
    throw std::out_of_range{name};
}

std::string error_of(const Material& material, std::string_view pointer, double value) {
    try {
        with_number(material, pointer, value);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Numbers, EveryPointerSetsItsOwnNumberOnly) {
    for (const test::MaterialCase& entry : test::right_cases()) {
        Material material = parse_material(entry.text, test::kOrigin);
        std::set<std::string> pointers;
        visit_numbers(material, [&](const std::string& pointer, double&, const NumberRange&) {
            EXPECT_TRUE(pointers.insert(pointer).second) << pointer << " is visited twice";
        });
        for (const std::string& target : pointers) {
            // A value of its own, and small enough to keep weights and ratios valid.
            double wanted = 0.0;
            visit_numbers(material,
                          [&](const std::string& pointer, double& value, const NumberRange& range) {
                              if (pointer == target)
                                  wanted = value > range.low ? value * (1 - 1e-6) : value + 1e-6;
                              if (!range.contains(wanted) && pointer == target)
                                  wanted = value * (1 + 1e-6);
                          });
            Material changed = with_number(material, target, wanted);
            visit_numbers(changed, [&](const std::string& pointer, double& value,
                                       const NumberRange&) {
                if (pointer == target) {
                    EXPECT_EQ(value, wanted) << entry.name << " " << target;
                    return;
                }
                double before = 0.0;
                visit_numbers(material, [&](const std::string& p, double& v, const NumberRange&) {
                    if (p == pointer) before = v;
                });
                EXPECT_EQ(value, before) << entry.name << ": " << target << " changed " << pointer;
            });
        }
    }
}

TEST(Numbers, AnArraysPointerSetsAllItsNumbers) {
    const Material material = right("scattering");
    const Material changed = with_number(material, "/layers/0/interface/alpha", 0.25);
    EXPECT_EQ(std::get<Microsurface>(changed.layers[0].interface.roughness).alpha,
              (std::array<double, 2>{0.25, 0.25}));
    const Material grey = with_number(right("celadon"), "/base/lambertian/albedo", 0.5);
    EXPECT_EQ(std::get<LambertianBase>(grey.base).albedo, (Rgb{0.5, 0.5, 0.5}));
}

TEST(Numbers, TheLastStratumKeepsTheRest) {
    const Material changed =
        with_number(right("blended_interface"), "/layers/0/interface/blend/strata/0/weight", 0.125);
    const auto& strata = std::get<Blend>(changed.layers[0].interface.roughness).strata;
    EXPECT_EQ(strata[2].weight, 0.625);
}

TEST(Numbers, RefusesWhatAFileCouldNotSay) {
    const Material material = right("celadon");
    EXPECT_THAT(error_of(material, "/layers/0/interface/alpha", 1.5),
                HasSubstr("/layers/0/interface/alpha: 1.5 is outside [0, 1]"));
    EXPECT_THAT(
        error_of(material, "/base/lambertian/albedo/1", std::numeric_limits<double>::quiet_NaN()),
        HasSubstr("nan is outside [0, 1]"));
    EXPECT_THAT(error_of(material, "/layers/0/interface/ior", 3.5), HasSubstr("ratio"));
    EXPECT_THAT(error_of(material, "/layers/1/interface/ior", 1.5),
                HasSubstr("/layers/1/interface/ior: no number stands there"));
    for (const char* pointer : {"", "/", "/layers", "/layers/0", "/base/lambertian/albed",
                                "/base/lambertian/albedo/3", "/name", "/layers/0/interface/alpha/"})
        EXPECT_THAT(error_of(material, pointer, 0.5), HasSubstr("no number stands there"))
            << pointer;
    EXPECT_THAT(
        error_of(right("blended_interface"), "/layers/0/interface/blend/strata/0/weight", 0.75),
        HasSubstr("leave nothing for the last stratum"));
}

TEST(Numbers, RoundsEachToTheNearestFloat) {
    Material rounded = rounded_to_float(right("blended_interface"));
    visit_numbers(rounded, [](const std::string& pointer, double& value, const NumberRange&) {
        EXPECT_EQ(value, static_cast<double>(static_cast<float>(value))) << pointer;
    });
    EXPECT_EQ(rounded_to_float(rounded), rounded);
    const Material celadon = rounded_to_float(right("celadon"));
    EXPECT_EQ(std::get<Microsurface>(celadon.layers[0].interface.roughness).alpha[0],
              static_cast<double>(0.12f));
}

TEST(Numbers, AreReadByShadersRelativeToTheExterior) {
    Material material{"under water", 1.33, {}, ConductorBase{{0.2, 0.4, 1.4}, {4, 2, 1}, {}}, {}};
    material.layers.push_back({{1.5, Microsurface{}}, AbsorbingMedium{}});
    const Material read = as_shaders_read(material);
    EXPECT_EQ(read.exterior_ior, 1.0);
    EXPECT_EQ(read.layers[0].interface.ior, static_cast<double>(static_cast<float>(1.5 / 1.33)));
    const auto& conductor = std::get<ConductorBase>(read.base);
    EXPECT_EQ(conductor.eta[2], static_cast<double>(static_cast<float>(1.4 / 1.33)));
    EXPECT_EQ(conductor.kappa[0], static_cast<double>(static_cast<float>(4 / 1.33)));
    const Blend blend{Blend::Operator::symmetric, {Stratum{0.5, {}, Rgb{1, 1, 1}, {}, {}}, {}}};
    const Material blended =
        as_shaders_read({"blend", 2.0, {}, ConductorBase{{1, 1, 1}, {}, blend}, {}});
    const auto& strata = std::get<Blend>(std::get<ConductorBase>(blended.base).roughness).strata;
    EXPECT_EQ(strata[0].eta, (Rgb{0.5, 0.5, 0.5}));
}

}  // namespace
}  // namespace lacquer
