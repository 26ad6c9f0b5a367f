#include "material/roughness.h"

#include <fmt/format.h>

#include <algorithm>

namespace lacquer {

namespace {

Ndf read_ndf(const Place& place, Ndf fallback) {
    const auto ndf = place.find("ndf");
    if (!ndf) return fallback;
    return ndf->choice({"ggx", "beckmann"}) == "ggx" ? Ndf::ggx : Ndf::beckmann;
}

// One number for both axes, or [along x, along y].
std::array<double, 2> read_alpha(const Place& place) {
    if (!place.is_array()) {
        const double alpha = place.number(kAlphaRange);
        return {alpha, alpha};
    }
    const std::vector<Place> axes = place.elements();
    if (axes.size() != 2)
        place.fail(fmt::format("expected a number or [alpha_x, alpha_y], found an array of {}",
                               axes.size()));
    return {axes[0].number(kAlphaRange), axes[1].number(kAlphaRange)};
}

Stratum read_stratum(const Place& place, Ndf fallback, const StratumFields& fields) {
    place.expect_object(fields.keys);
    Stratum stratum;
    stratum.microsurface = {read_ndf(place, fallback), read_alpha(place.member("alpha"))};
    if (fields.read) fields.read(place, stratum);
    return stratum;
}

// Reads the weights of all strata but the last, whose weight is what they leave.
void read_weights(const Place& place, const std::vector<Place>& places,
                  std::vector<Stratum>& strata) {
    if (const auto weight = places.back().find("weight"))
        weight->fail("the last stratum has no weight of its own: it gets what the others leave");
    double rest = 1.0;
    bool textured = false;
    for (std::size_t i = 0; i + 1 < strata.size(); ++i) {
        const Place weight = places[i].member("weight");
        strata[i].weight = weight.number(kWeightRange);
        textured = textured || weight.is_texture();
        rest -= strata[i].weight;
    }
    if (textured) {  // they are checked when their textures are read
        for (Stratum& stratum : strata) stratum.weight = 1.0 / static_cast<double>(strata.size());
        return;
    }
    if (rest <= 0.0)
        place.fail(fmt::format("the weights sum to {}, which leaves nothing for the last stratum",
                               1.0 - rest));
    strata.back().weight = rest;
}

Blend read_blend(const Place& place, Ndf fallback, const StratumFields& fields) {
    place.expect_object({"operator", "strata"});
    Blend blend;
    blend.op = place.member("operator").choice({"symmetric", "asymmetric"}) == "symmetric"
                   ? Blend::Operator::symmetric
                   : Blend::Operator::asymmetric;
    const Place strata = place.member("strata");
    const std::vector<Place> places = strata.elements();
    if (places.size() < kMinStrata)
        strata.fail(
            fmt::format("{} strata, where a blend has at least {}", places.size(), kMinStrata));
    for (const Place& stratum : places)
        blend.strata.push_back(read_stratum(stratum, fallback, fields));
    read_weights(strata, places, blend.strata);
    return blend;
}

}  // namespace

Roughness read_roughness(const Place& place, const StratumFields& fields) {
    const Ndf ndf = read_ndf(place, Ndf::ggx);
    const auto alpha = place.find("alpha");
    const auto blend = place.find("blend");
    if (alpha && blend) blend->fail("'blend' takes the place of 'alpha': give one of them");
    if (alpha) return Microsurface{ndf, read_alpha(*alpha)};
    if (blend) return read_blend(*blend, ndf, fields);
    place.fail("the key 'alpha' (or 'blend' in its place) is missing");
}

}  // namespace lacquer
