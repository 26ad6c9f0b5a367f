#include "bake/quantity.h"

namespace lacquer::bake {

std::size_t Quantity::nodes() const {
    return grid_size(std::span{axes}.first(node_axes));
}

std::size_t Quantity::values_per_node() const {
    return grid_size(std::span{axes}.subspan(node_axes));
}

Parameters grid_parameters(std::span<const Axis> axes, std::size_t index) {
    Parameters parameters(axes.size());
    for (std::size_t axis = axes.size(); axis-- > 0;) {
        parameters[axis] = axis_value(axes[axis], index % axes[axis].size);
        index /= axes[axis].size;
    }
    return parameters;
}

std::vector<TableBake> all_table_bakes() {
    return {bake_of_t_down(Contrast::thin),
            bake_of_t_down(Contrast::dense),
            bake_of_r_up(),
            bake_of_multiple(),
            bake_of_conductor(),
            bake_of_tir(),
            bake_of_mirror(),
            bake_of_lobes()};
}

Axis alpha_axis(std::size_t size) {
    return {"alpha", Mapping::squared, size, 0.0, 1.0, "1"};
}

Axis eta_axis(Contrast contrast, std::size_t size) {
    // Between equal media there is no interface, and everything jumps at grazing angles: the first
    // node is the limit.
    constexpr double kNearOne = 1e-4;
    if (contrast == Contrast::thin)
        return {"eta", Mapping::log_bent, size, 1.0 - kNearOne, 1.0 / 3.0, "1"};
    return {"eta", Mapping::log_bent, size, 1.0 + kNearOne, 3.0, "1"};
}

Axis tau_axis() {
    // Dense near 1, from where the light that leaves along the surface soon goes out.
    return {"tau", Mapping::squared, 33, 1.0, 0.0, "1"};
}

Axis profile_axis(std::size_t size) {
    return {"s", Mapping::linear, size, 0.0, 1.0, "1"};
}

std::vector<double> profile_cosines(std::size_t size, Contrast contrast, double eta) {
    const Axis axis = profile_axis(size);
    std::vector<double> cosines;
    for (std::size_t n = 0; n < size; ++n)
        cosines.push_back(profile_cosine(axis_value(axis, n), contrast, eta));
    return cosines;
}

Axis channel_axis(std::string name, std::size_t size) {
    return {std::move(name), Mapping::index, size, 0.0, 0.0, "1"};
}

}  // namespace lacquer::bake
