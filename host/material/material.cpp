// Reads material files.
#include "lacquer/material.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "core/error.h"
#include "material/optical_constants.h"
#include "material/place.h"
#include "material/roughness.h"

namespace lacquer {

namespace {

// A material is a page of text; what is far larger is some other file.
constexpr std::size_t kMaxMaterialBytes = 256 * 1024;

Interface read_interface(const Place& place) {
    place.expect_object({"ior", "alpha", "ndf", "blend"});
    return {place.member("ior").number(kIorRange),
            read_roughness(place, {{"weight", "alpha", "ndf"}, {}})};
}

Medium read_medium(const Place& place) {
    place.expect_object({"tau", "sigma_a", "sigma_s", "g", "thickness"});
    const auto tau = place.find("tau");
    if (tau) {
        for (const char* key : {"sigma_a", "sigma_s", "g", "thickness"})
            if (const auto other = place.find(key))
                other->fail(fmt::format("'{}' and 'tau' exclude each other: give one", key));
        return AbsorbingMedium{tau->rgb(kTauRange)};
    }
    const auto sigma_a = place.find("sigma_a");
    const auto sigma_s = place.find("sigma_s");
    if (!sigma_a && !sigma_s) place.fail("one of 'tau', 'sigma_a' and 'sigma_s' is needed");
    ScatteringMedium medium;
    if (sigma_a) medium.sigma_a = sigma_a->rgb(kSigmaRange);
    if (sigma_s) medium.sigma_s = sigma_s->rgb(kSigmaRange);
    if (const auto g = place.find("g")) medium.g = g->number(kAnisotropyRange);
    if (const auto thickness = place.find("thickness"))
        medium.thickness = thickness->number(kThicknessRange);
    return medium;
}

Layer read_layer(const Place& place) {
    place.expect_object({"interface", "medium"});
    Layer layer{read_interface(place.member("interface")), AbsorbingMedium{}};
    if (const auto medium = place.find("medium")) layer.medium = read_medium(*medium);
    return layer;
}

// An index given by `metal`, or by `eta` and `kappa`, or not at all.
struct Index {
    std::optional<Rgb> eta, kappa;
};

Index read_index(const Place& place) {
    Index index;
    if (const auto eta = place.find("eta")) index.eta = eta->rgb(kConductorEtaRange);
    if (const auto kappa = place.find("kappa")) index.kappa = kappa->rgb(kConductorKappaRange);
    const auto metal = place.find("metal");
    if (!metal) return index;
    if (index.eta || index.kappa)
        metal->fail("'metal' takes the place of 'eta' and 'kappa': give one or the other");
    const std::string name = metal->string();
    if (const OpticalConstants* constants = find_optical_constants(name))
        return {constants->eta, constants->kappa};
    std::vector<std::string_view> known;
    for (const OpticalConstants& entry : all_optical_constants()) known.push_back(entry.metal);
    metal->fail(fmt::format("the metal '{}' is not one of: {}", name, fmt::join(known, ", ")));
}

void read_conductor_stratum(const Place& place, Stratum& stratum) {
    const Index index = read_index(place);
    stratum.eta = index.eta;
    stratum.kappa = index.kappa;
}

void read_diffuse_facets_stratum(const Place& place, Stratum& stratum) {
    if (const auto albedo = place.find("albedo")) stratum.albedo = albedo->rgb(kAlbedoRange);
}

// Whether every stratum says `field` itself, so that it need not stand outside.
bool all_strata_have(const Roughness& roughness, std::optional<Rgb> Stratum::*field) {
    const auto* blend = std::get_if<Blend>(&roughness);
    if (blend == nullptr) return false;
    for (const Stratum& stratum : blend->strata)
        if (!(stratum.*field)) return false;
    return true;
}

ConductorBase read_conductor(const Place& place) {
    place.expect_object({"eta", "kappa", "metal", "alpha", "ndf", "blend"});
    const Index index = read_index(place);
    const Roughness roughness = read_roughness(
        place, {{"weight", "alpha", "ndf", "eta", "kappa", "metal"}, read_conductor_stratum});
    if (!index.eta && !all_strata_have(roughness, &Stratum::eta))
        place.fail("the key 'eta' (or 'metal' for both it and 'kappa') is missing");
    if (!index.kappa && !all_strata_have(roughness, &Stratum::kappa))
        place.fail("the key 'kappa' (or 'metal' for both it and 'eta') is missing");
    return {index.eta.value_or(Rgb{}), index.kappa.value_or(Rgb{}), roughness};
}

DiffuseFacetsBase read_diffuse_facets(const Place& place) {
    place.expect_object({"albedo", "alpha", "ndf", "blend"});
    const Roughness roughness =
        read_roughness(place, {{"weight", "alpha", "ndf", "albedo"}, read_diffuse_facets_stratum});
    if (const auto albedo = place.find("albedo")) return {albedo->rgb(kAlbedoRange), roughness};
    if (!all_strata_have(roughness, &Stratum::albedo)) place.fail("the key 'albedo' is missing");
    return {Rgb{}, roughness};
}

Base read_base(const Place& place) {
    if (place.is_string()) {
        place.choice({"none"});
        return NoBase{};
    }
    place.expect_object({"lambertian", "conductor", "diffuse_facets"});
    const auto lambertian = place.find("lambertian");
    const auto conductor = place.find("conductor");
    const auto diffuse_facets = place.find("diffuse_facets");
    if (lambertian.has_value() + conductor.has_value() + diffuse_facets.has_value() != 1)
        place.fail("a base is one of 'lambertian', 'conductor', 'diffuse_facets', or \"none\"");
    if (conductor) return read_conductor(*conductor);
    if (diffuse_facets) return read_diffuse_facets(*diffuse_facets);
    lambertian->expect_object({"albedo"});
    return LambertianBase{lambertian->member("albedo").rgb(kAlbedoRange)};
}

std::vector<Layer> read_layers(const Place& place) {
    const std::vector<Place> places = place.elements();
    if (places.size() > kMaxLayers)
        place.fail(fmt::format("{} layers, at most {} are allowed", places.size(), kMaxLayers));
    std::vector<Layer> layers;
    for (const Place& layer : places) layers.push_back(read_layer(layer));
    return layers;
}

// The ratio at every interface, but not beside an ior that a texture has: it is not known yet.
void check_ior_ratios(const Place& root, const Material& material) {
    const auto exterior = root.find("exterior_ior");
    bool is_above_known = !exterior || !exterior->is_texture();
    double above = material.exterior_ior;
    for (std::size_t i = 0; i < material.layers.size(); ++i) {
        const Place ior = root.member("layers").elements()[i].member("interface").member("ior");
        const bool is_below_known = !ior.is_texture();
        const double below = material.layers[i].interface.ior;
        if (is_above_known && is_below_known && !is_ior_ratio_allowed(below, above))
            ior.fail(fmt::format("{} below {} is a ratio of {:.6g}, which is outside {}", below,
                                 above, below / above, kIorRatioRange.text()));
        above = below;
        is_above_known = is_below_known;
    }
}

std::string read_text(const std::filesystem::path& file) {
    const std::string name = file.string();
    if (std::filesystem::is_directory(file))
        throw Error{fmt::format("{}: is a folder, expected a material file", name)};
    std::ifstream stream{file, std::ios::binary};
    if (!stream) throw Error{fmt::format("{}: cannot be opened: {}", name, std::strerror(errno))};
    std::string text(kMaxMaterialBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (stream.bad()) throw Error{fmt::format("{}: cannot be read", name)};
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kMaxMaterialBytes)
        throw Error{fmt::format("{}: larger than {} bytes, which no material file is", name,
                                kMaxMaterialBytes)};
    return text;
}

}  // namespace

Material parse_material(const std::string& text, const std::filesystem::path& origin) {
    ReadContext context{origin.string(), origin.parent_path(), {}};
    const JsonValue document = parse_json(text, context.origin);
    const Place root{context, document, ""};
    root.expect_object({"$schema", "name", "exterior_ior", "layers", "base"});
    Material material;
    if (const auto schema = root.find("$schema")) schema->string();
    material.name = origin.stem().string();
    if (const auto name = root.find("name")) material.name = name->string();
    if (const auto ior = root.find("exterior_ior")) material.exterior_ior = ior->number(kIorRange);
    if (const auto layers = root.find("layers")) material.layers = read_layers(*layers);
    check_ior_ratios(root, material);
    material.base = read_base(root.member("base"));
    if (material.layers.empty() && std::holds_alternative<NoBase>(material.base))
        root.member("base").fail("\"none\" without layers leaves nothing to shade");
    material.textures = std::move(context.textures);
    return material;
}

Material load_material(const std::filesystem::path& file) {
    return parse_material(read_text(file), file);
}

}  // namespace lacquer
