// Where the light goes that meets perfect GGX mirrors, over (alpha, cos_theta): the means of seven
// equal shares of its cosines, which shading sums over in place of an integral over the lobe. By
// quadrature, so that tables of any number of walks hold the same.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "bake/half_space.h"
#include "bake/low_rank.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 24, kCosines = 24;
constexpr std::size_t kChannels = kLobeNodes + 1;

// Midpoints over the visible normals, half a turn of them by symmetry, and over diffuse light.
constexpr int kAzimuths = 64, kHeights = 64, kDiffuse = 256;

// Light nearer to the plane than this is taken as if it were not.
constexpr double kGrazing = 0.0002;

std::vector<Axis> node_axes() {
    return {alpha_axis(kAlphas), {"cos_theta", Mapping::squared, kCosines, 0.0, 1.0, "1"}};
}

// Light leaving at a cosine.
struct Ray {
    double cosine, light;
};

// What mirrors reflect at their first facet, of light from `w` above the surface: visible facets
// mirror it, and G2 / G1 of it leaves.
std::vector<Ray> reflected_rays(const Vec3& w, double alpha) {
    std::vector<Ray> rays;
    const double masking = 1.0 + ggx_lambda(alpha, w);
    for (int row = 0; row < kHeights; ++row) {
        // Spaced as squares towards the steepest facets, few but what smooth mirrors lose light to.
        const double rest = 1.0 - (row + 0.5) / kHeights;
        const double share = 2.0 * rest / (kHeights * kAzimuths);
        for (int column = 0; column < kAzimuths; ++column) {
            const double phi_number = 0.5 * (column + 0.5) / kAzimuths;
            const Vec3 out = mirror(-w, visible_normal(alpha, w, phi_number, 1.0 - rest * rest));
            if (out.z <= 0.0) continue;
            const double leaving = masking / (masking + ggx_lambda(alpha, out));
            rays.push_back({std::min(out.z, 1.0), share * leaving});
        }
    }
    return rays;
}

// Means of the cosines of kLobeNodes equal shares of the light, from the flattest up. The light of
// all rays is 1.
std::array<double, kLobeNodes> share_means(std::vector<Ray> rays) {
    std::ranges::sort(rays, {}, &Ray::cosine);
    constexpr double kShare = 1.0 / kLobeNodes;
    std::array<double, kLobeNodes> means{};
    std::size_t node = 0;
    double room = kShare;
    for (Ray ray : rays) {
        // The last share takes what rounding leaves.
        while (node + 1 < kLobeNodes && ray.light >= room) {
            means[node] += room * ray.cosine;
            ray.light -= room;
            room = kShare;
            ++node;
        }
        means[node] += ray.light * ray.cosine;
        room -= ray.light;
    }
    for (double& mean : means) mean /= kShare;
    return means;
}

void integrate_node(const Parameters& node, std::span<float> values) {
    const double alpha = node[0], cosine = std::max(node[1], kGrazing);
    std::fill(values.begin(), values.end(), 0.0f);
    values[kLobeNodes] = 1.0f;
    if (alpha <= 0.0) return;
    std::vector<Ray> rays = reflected_rays({std::sqrt(1.0 - cosine * cosine), 0.0, cosine}, alpha);
    double single = 0.0;
    for (const Ray& ray : rays) single += ray.light;
    for (int n = 0; n < kDiffuse; ++n)
        rays.push_back({std::sqrt((n + 0.5) / kDiffuse), (1.0 - single) / kDiffuse});
    const auto means = share_means(std::move(rays));
    for (std::size_t n = 0; n < kLobeNodes; ++n) values[n] = static_cast<float>(means[n] - cosine);
    values[kLobeNodes] = static_cast<float>(single);
}

double look_up(const EnergyTables& tables, const Parameters& at) {
    const LobeNodes nodes = tables.lobe(at[1], at[0]);
    const auto channel = static_cast<std::size_t>(at[2]);
    return channel < kLobeNodes ? nodes.cosines[channel] - at[1] : nodes.single;
}

}  // namespace

TableBake bake_of_lobes() {
    std::vector<Axis> axes = node_axes();
    axes.push_back(channel_axis("node", kChannels));
    return {"lobes",
            "cosines of the light from mirror facets in seven equal shares, less that of the light "
            "that arrives; what single scattering keeps of it",
            {{"lobes", axes, 2,
              [](const Parameters& node, const Walks&, std::uint64_t, std::span<float> values) {
                  integrate_node(node, values);
              },
              look_up}},
            [axes](const std::vector<DenseValues>& dense) {
                return std::vector{make_array("nodes", axes, to_matrix(dense.front(), kChannels))};
            }};
}

}  // namespace lacquer::bake
