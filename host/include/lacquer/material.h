// A layered material as its file describes it, validated: every number is within its range.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace lacquer {

// One value per colour channel, linear Rec. 709 red, green, blue.
using Rgb = std::array<double, 3>;

// Distribution of facet normals.
enum class Ndf { ggx, beckmann };

// A uniform rough microsurface. `alpha` are slope roughnesses along x and y, each in [0, 1].
struct Microsurface {
    Ndf ndf = Ndf::ggx;
    std::array<double, 2> alpha{0.0, 0.0};
    friend bool operator==(const Microsurface&, const Microsurface&) = default;
};

// One stratum of a blended microsurface. `eta` and `kappa` stand only in strata of a conductor base,
// `albedo` only in those of diffuse facets; what is absent is the base's.
struct Stratum {
    double weight = 1.0;  // (0, 1); the last stratum's is what the others leave
    Microsurface microsurface;
    std::optional<Rgb> eta, kappa, albedo;
    friend bool operator==(const Stratum&, const Stratum&) = default;
};

// A microsurface whose roughness or material changes with height; `strata` from the top down.
struct Blend {
    enum class Operator { symmetric, asymmetric };
    Operator op = Operator::asymmetric;
    std::vector<Stratum> strata;  // at least two; models shade kMaxStrata
    friend bool operator==(const Blend&, const Blend&) = default;
};

inline constexpr std::size_t kMaxStrata = 4;  // shaders' LQ_MAX_STRATA

// Uniform or blended.
using Roughness = std::variant<Microsurface, Blend>;

// A dielectric interface. `ior` in [0.3, 4] is the absolute index of the medium below it.
struct Interface {
    double ior = 1.5;
    Roughness roughness;
    friend bool operator==(const Interface&, const Interface&) = default;
};

// A medium of unit thickness that only absorbs: `tau` in [0, 1] is its transmittance along the
// normal.
struct AbsorbingMedium {
    Rgb tau{1.0, 1.0, 1.0};
    friend bool operator==(const AbsorbingMedium&, const AbsorbingMedium&) = default;
};

// A medium that may scatter: coefficients per unit of thickness, >= 0; g in [-0.99, 0.99] is the
// mean cosine of the phase function; thickness >= 0.
struct ScatteringMedium {
    Rgb sigma_a{}, sigma_s{};
    double g = 0.0;
    double thickness = 1.0;
    friend bool operator==(const ScatteringMedium&, const ScatteringMedium&) = default;
};

using Medium = std::variant<AbsorbingMedium, ScatteringMedium>;

struct Layer {
    Interface interface;
    Medium medium;
    friend bool operator==(const Layer&, const Layer&) = default;
};

// Reflects diffusely; `albedo` in [0, 1].
struct LambertianBase {
    Rgb albedo{};
    friend bool operator==(const LambertianBase&, const LambertianBase&) = default;
};

// Absolute index eta + i kappa; eta in [0, 5], kappa in [0, 10].
struct ConductorBase {
    Rgb eta{}, kappa{};
    Roughness roughness;
    friend bool operator==(const ConductorBase&, const ConductorBase&) = default;
};

// Rough surface of diffuse facets; `albedo` in [0, 1].
struct DiffuseFacetsBase {
    Rgb albedo{};
    Roughness roughness;
    friend bool operator==(const DiffuseFacetsBase&, const DiffuseFacetsBase&) = default;
};

// Light passes on below the last layer.
struct NoBase {
    friend bool operator==(const NoBase&, const NoBase&) = default;
};

using Base = std::variant<LambertianBase, ConductorBase, DiffuseFacetsBase, NoBase>;

// Where a number of the material comes from an image in renders: `pointer` is the JSON pointer of
// the number (for example "/layers/0/interface/alpha"), `channel` one of r, g, b, a. `file` is
// resolved against the folder of the material; whether it exists is found out when it is read. Until
// then the number has a value within its range that means nothing.
struct TextureReference {
    std::string pointer;
    std::filesystem::path file;
    char channel = 'r';
    friend bool operator==(const TextureReference&, const TextureReference&) = default;
};

struct Material {
    std::string name;
    double exterior_ior = 1.0;  // [0.3, 4]
    std::vector<Layer> layers;  // top to bottom, at most kMaxLayers
    Base base;
    std::vector<TextureReference> textures;
    friend bool operator==(const Material&, const Material&) = default;
};

inline constexpr std::size_t kMaxLayers = 8;  // shaders' LQ_MAX_LAYERS where none is chosen

// Reads and validates a material file. Throws lacquer::Error naming file, line, JSON pointer, value
// and allowed range; for an unknown key, the keys allowed there.
Material load_material(const std::filesystem::path& file);

// The same from text; `origin` stands for the file in messages and for its folder in textures.
Material parse_material(const std::string& text, const std::filesystem::path& origin);

}  // namespace lacquer
