// The range of every number of a material file.
#pragma once

#include <cstddef>
#include <string>

namespace lacquer {

struct NumberRange {
    double low;
    double high;
    double placeholder;  // stands for a textured number until the texture is read
    bool open = false;   // the ends themselves are excluded

    // False for NaN.
    bool contains(double value) const;

    // For messages: "[0, 1]" or "(0, 1)".
    std::string text() const;
};

// Largest coefficient or thickness: products of a few of them still fit in a float.
inline constexpr double kMaxCoefficient = 1e9;

inline constexpr NumberRange kIorRange{0.3, 4.0, 1.5};
inline constexpr NumberRange kIorRatioRange{1.0 / 3.0, 3.0, 1.0};
inline constexpr NumberRange kAlphaRange{0.0, 1.0, 0.5};
inline constexpr NumberRange kTauRange{0.0, 1.0, 1.0};
inline constexpr NumberRange kSigmaRange{0.0, kMaxCoefficient, 0.0};
inline constexpr NumberRange kAnisotropyRange{-0.99, 0.99, 0.0};
inline constexpr NumberRange kThicknessRange{0.0, kMaxCoefficient, 1.0};
inline constexpr NumberRange kAlbedoRange{0.0, 1.0, 0.5};
inline constexpr NumberRange kConductorEtaRange{0.0, 5.0, 1.0};
inline constexpr NumberRange kConductorKappaRange{0.0, 10.0, 1.0};
inline constexpr NumberRange kWeightRange{0.0, 1.0, 0.5, true};

// A blend is of at least so many strata.
inline constexpr std::size_t kMinStrata = 2;

// Rounding in the division of two numbers of a file cannot put their ratio out of range.
inline constexpr double kRatioSlack = 1e-12;

// Whether the ratio of two indices, below over above, is within kIorRatioRange.
bool is_ior_ratio_allowed(double below, double above);

}  // namespace lacquer
