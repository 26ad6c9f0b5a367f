// `lacquer interface --method simulate`.
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/run_lacquer.h"
#include "support/smooth_dielectric.h"

namespace lacquer {
namespace {

using nlohmann::json;
using test::expect_failure;
using test::expect_success;
using test::kUsage;
using test::run_lacquer;
using test::Words;
using ::testing::HasSubstr;

// Five standard errors: a false alarm in a million.
constexpr double kSigmas = 5.0;
constexpr double kRounding = 1e-12;

Words interface(const char* alpha, const char* eta, const char* tau, const char* cosine,
                const Words& rest = {"--method", "simulate", "--samples", "200000", "--json"}) {
    Words words{"interface", "--alpha", alpha, "--eta", eta, "--tau", tau, "--cos", cosine};
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
}

json simulate(const Words& words) {
    const ProcessResult result = run_lacquer(words);
    expect_success(result);
    return json::parse(result.out);
}

void expect_near(const json& values, const char* name, double expected) {
    EXPECT_NEAR(values.at(name).get<double>(), expected,
                kSigmas * values.at("stderr").at(name).get<double>() + kRounding)
        << name;
}

TEST(Interface, SmoothOneHasItsClosedForm) {
    constexpr double kEta = 1.5;
    constexpr double kTau = 0.5;
    constexpr double kCosine = 0.6;
    const json clear = simulate(interface("0", "1.5", "1", "0.6"));
    const double reflectance = test::smooth_reflectance(kCosine, kEta);
    expect_near(clear, "FGD", reflectance);
    expect_near(clear, "T01", 1.0 - reflectance);
    const double inside = test::smooth_diffuse_reflectance(1.0 / kEta);
    expect_near(clear, "R10", inside);
    expect_near(clear, "T10", 1.0 - inside);
    EXPECT_EQ(clear.at("samples"), 200000);

    const json dim = simulate(interface("0", "1.5", "0.5", "0.6"));
    const double cos_t = std::sqrt(1.0 - (1.0 - kCosine * kCosine) / (kEta * kEta));
    expect_near(dim, "T01", (1.0 - reflectance) * std::pow(kTau, 1.0 / cos_t));
    expect_near(dim, "FGD", reflectance);
}

TEST(Interface, ClearOneLosesNoLight) {
    for (const char* eta : {"0.5", "1", "2.5"})
        for (const char* ndf : {"ggx", "beckmann"}) {
            const json values = simulate(
                interface("0.7", eta, "1", "0.2",
                          {"--ndf", ndf, "--method", "simulate", "--samples", "10000", "--json"}));
            EXPECT_NEAR(values.at("T01").get<double>() + values.at("FGD").get<double>(), 1.0,
                        kRounding);
            EXPECT_NEAR(values.at("T10").get<double>() + values.at("R10").get<double>(), 1.0,
                        kRounding);
        }
}

TEST(Interface, EndsOfTheRangesGiveNumbers) {
    for (const char* alpha : {"0", "1"})
        for (const char* eta : {"0.3333", "3"})
            for (const char* tau : {"0", "1"})
                for (const char* cosine : {"0", "1"}) {
                    const json values = simulate(
                        interface(alpha, eta, tau, cosine,
                                  {"--method", "simulate", "--samples", "1000", "--json"}));
                    for (const char* name : {"T01", "R10", "T10", "variance", "FGD"}) {
                        EXPECT_GE(values.at(name).get<double>(), 0.0) << name;
                        EXPECT_LE(values.at(name).get<double>(), 1.0 + kRounding) << name;
                        EXPECT_GE(values.at("stderr").at(name).get<double>(), 0.0) << name;
                    }
                }
}

TEST(Interface, RepeatsForOneSeedAndDiffersForAnother) {
    const auto with_seed = [](const char* seed) {
        return simulate(
            interface("0.3", "1.5", "0.8", "0.5",
                      {"--method", "simulate", "--samples", "10000", "--seed", seed, "--json"}));
    };
    EXPECT_EQ(with_seed("3"), with_seed("3"));
    EXPECT_NE(with_seed("3"), with_seed("4"));
}

TEST(Interface, PrintsATable) {
    const ProcessResult result = run_lacquer(
        interface("0.3", "1.5", "0.8", "0.5", {"--method", "simulate", "--samples", "1000"}));
    expect_success(result);
    for (const char* word : {"T01", "R10", "T10", "variance", "FGD", "standard error"})
        EXPECT_THAT(result.out, HasSubstr(word));
}

TEST(Interface, NumbersOutsideTheirRangeNameIt) {
    for (const char* bad : {"-0.1", "1.01", "nan", "inf"}) {
        expect_failure(run_lacquer(interface(bad, "1.5", "1", "1")), kUsage,
                       {"--alpha", bad, "[0, 1]"});
        expect_failure(run_lacquer(interface("0.5", "1.5", bad, "1")), kUsage,
                       {"--tau", bad, "[0, 1]"});
        expect_failure(run_lacquer(interface("0.5", "1.5", "1", bad)), kUsage,
                       {"--cos", bad, "[0, 1]"});
    }
    for (const char* bad : {"0.3", "3.01", "-1", "nan"})
        expect_failure(run_lacquer(interface("0.5", bad, "1", "1")), kUsage,
                       {"--eta", bad, "[0.3333, 3]"});
    expect_failure(run_lacquer(interface("rough", "1.5", "1", "1")), kUsage, {"--alpha", "rough"});
}

TEST(Interface, WrongMethodsAndOptionsAreNamed) {
    const auto with = [](const Words& rest) {
        return run_lacquer(interface("0.5", "1.5", "1", "1", rest));
    };
    expect_failure(with({"--method", "guess"}), kUsage, {"--method", "guess", "table, simulate"});
    expect_failure(with({"--ndf", "phong"}), kUsage, {"--ndf", "phong", "ggx", "beckmann"});
    expect_failure(with({"--seed", "2"}), kUsage, {"--seed", "simulate", "table"});
    expect_failure(with({"--samples", "2"}), kUsage, {"--samples", "simulate", "table"});
    expect_failure(with({"--ndf", "beckmann"}), kUsage, {"--ndf", "beckmann", "simulate"});
    for (const char* samples : {"0", "1099511627777"})
        expect_failure(with({"--method", "simulate", "--samples", samples}), kUsage,
                       {"--samples", samples, "[1, 1099511627776]"});
    for (const char* option : {"--samples", "--seed"})
        expect_failure(with({"--method", "simulate", option, "-5"}), kUsage, {option, "-5"});
    expect_failure(run_lacquer({"interface", "--eta", "1.5", "--tau", "1", "--cos", "1"}), kUsage,
                   {"--alpha"});
}

}  // namespace
}  // namespace lacquer
