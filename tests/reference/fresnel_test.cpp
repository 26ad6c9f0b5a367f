// Fresnel's formulas against closed forms of the textbooks.
#include "reference/fresnel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace lacquer::reference {
namespace {

using Complex = std::complex<double>;

// A few hundred roundings of a double.
constexpr double kRounding = 1e-13;

constexpr std::array kCosines{1.0, 0.99, 0.9, 0.7, 0.5, 0.3, 0.1, 0.01, 1e-4};
constexpr std::array kEtas{1.0 / 3.0, 0.5, 0.75, 0.999, 1.001, 1.33, 1.5, 2.4, 3.0};

double sine(double cosine) {
    return std::sqrt((1.0 - cosine) * (1.0 + cosine));
}

// Born and Wolf 1999, section 1.5.2, Eq. 36: at normal incidence ((n - 1) / (n + 1))^2.
TEST(Fresnel, AtNormalIncidenceOnADielectric) {
    EXPECT_NEAR(fresnel(1.0, 1.5), 0.04, kRounding);
    for (const double eta : kEtas)
        EXPECT_NEAR(fresnel(1.0, eta), std::pow((eta - 1) / (eta + 1), 2), kRounding) << eta;
}

// Born and Wolf 1999, section 14.2: at normal incidence |(n - 1) / (n + 1)|^2 for a complex n.
TEST(Fresnel, AtNormalIncidenceOnAConductor) {
    for (const Complex eta : {Complex{0.143, 3.983}, Complex{1.442, 1.603}, Complex{2.9, 3.1}}) {
        const double n = eta.real();
        const double k = eta.imag();
        EXPECT_NEAR(fresnel(1.0, eta), (std::pow(n - 1, 2) + k * k) / (std::pow(n + 1, 2) + k * k),
                    kRounding);
    }
}

// At Brewster's angle, tan theta = n, the parallel part vanishes; the perpendicular part is
// ((n^2 - 1) / (n^2 + 1))^2.
TEST(Fresnel, AtBrewstersAngle) {
    for (const double eta : kEtas) {
        const double cos_theta = std::cos(std::atan(eta));
        const double square = eta * eta;
        EXPECT_NEAR(fresnel(cos_theta, eta), 0.5 * std::pow((square - 1) / (square + 1), 2),
                    kRounding)
            << eta;
    }
}

// Born and Wolf 1999, section 1.5.2, Eq. 21a: the laws of sines and tangents, with real angles.
TEST(Fresnel, FollowsTheLawsOfSinesAndTangents) {
    for (const double eta : kEtas)
        for (const double cosine : kCosines) {
            const double sin_t = sine(cosine) / eta;
            if (cosine == 1.0 || sin_t >= 1.0) continue;
            const double theta_i = std::acos(cosine);
            const double theta_t = std::asin(sin_t);
            const double s = std::sin(theta_i - theta_t) / std::sin(theta_i + theta_t);
            const double p = std::tan(theta_i - theta_t) / std::tan(theta_i + theta_t);
            // The difference of two angles has lost what the angles were rounded by.
            EXPECT_NEAR(fresnel(cosine, eta), 0.5 * (s * s + p * p), 1e-11)
                << eta << " at " << cosine;
        }
}

TEST(Fresnel, ReflectsAllBeyondTheCriticalAngle) {
    for (const double eta : {1.0 / 3.0, 0.5, 0.75, 0.999}) {
        const double critical = sine(eta);  // sin theta = eta
        for (const double below : {0.0, 0.5, 0.9, 0.999999})
            EXPECT_NEAR(fresnel(critical * below, eta), 1.0, kRounding) << eta;
        EXPECT_LT(fresnel(critical * 1.0001, eta), 0.999);
    }
}

// Stokes: a boundary reflects the same fraction from both sides along a refracted path.
TEST(Fresnel, IsTheSameFromTheOtherSide) {
    for (const double eta : kEtas)
        for (const double cosine : kCosines) {
            const double sin_t = sine(cosine) / eta;
            if (sin_t >= 1.0) continue;
            // Near grazing the sine has lost what the cosine still has.
            EXPECT_NEAR(fresnel(cosine, eta), fresnel(sine(sin_t), 1.0 / eta), kRounding / cosine)
                << eta << " at " << cosine;
        }
}

// Abeles: at 45 degrees the parallel reflectance is the square of the perpendicular one, for any
// index. The perpendicular one in real arithmetic: Born and Wolf 1999, section 14.2, Eqs. 14 to 18.
TEST(Fresnel, SatisfiesAbelesIdentityAt45Degrees) {
    const double c = std::sqrt(0.5);
    for (const Complex eta : {Complex{0.143, 3.983}, Complex{1.442, 1.603}, Complex{1.657, 9.224},
                              Complex{0.05, 0.3}, Complex{5.0, 10.0}, Complex{1.5, 0.0}}) {
        const double difference = std::norm(eta.real()) - std::norm(eta.imag()) - 0.5;
        const double product = 2.0 * eta.real() * eta.imag();
        const double modulus = std::hypot(difference, product);
        const double u = std::sqrt(0.5 * (modulus + difference));
        const double v = std::sqrt(0.5 * (modulus - difference));
        const double s = (std::pow(c - u, 2) + v * v) / (std::pow(c + u, 2) + v * v);
        EXPECT_NEAR(fresnel(c, eta), 0.5 * (s + s * s), kRounding) << eta;
    }
}

TEST(Fresnel, IsContinuousFromDielectricToConductor) {
    for (const double eta : kEtas)
        for (const double cosine : kCosines) {
            // Near the critical angle a root amplifies the small kappa.
            constexpr double kKappa = 1e-14;
            EXPECT_NEAR(fresnel(cosine, Complex{eta, kKappa}), fresnel(cosine, eta),
                        10 * std::sqrt(kKappa))
                << eta << " at " << cosine;
        }
}

TEST(Fresnel, HasItsLimits) {
    EXPECT_EQ(fresnel(0.5, 1.0), 0.0);
    for (const Complex eta : {Complex{1.5, 0.0}, Complex{0.5, 0.0}, Complex{0.2, 3.0}})
        EXPECT_NEAR(fresnel(0.0, eta), 1.0, kRounding) << eta;
    for (const double cosine : kCosines) EXPECT_NEAR(fresnel(cosine, 0.0), 1.0, kRounding);
    EXPECT_EQ(fresnel(0.0, 1.0), 1.0);  // the limit in cos_theta at every other index
    for (const double cosine : kCosines)
        for (double eta = 0.0; eta <= 5.0; eta += 0.25)
            for (double kappa = 0.0; kappa <= 10.0; kappa += 0.5) {
                const double f = fresnel(cosine, Complex{eta, kappa});
                EXPECT_GE(f, 0.0);
                EXPECT_LE(f, 1.0 + kRounding);
            }
}

}  // namespace
}  // namespace lacquer::reference
