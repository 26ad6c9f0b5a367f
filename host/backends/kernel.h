// The compute kernels of shader_src/kernels as the host sees them: which rows they read and write.
#pragma once

#include <cstdint>
#include <string_view>

namespace lacquer {

enum class Kernel {
    eval,    // wi, wo -> (f, pdf)
    slice,   // wi, with parameters.wo -> (f, pdf)
    sphere,  // wi, wo, with parameters.radiance -> (radiance, 1)
    sample,  // wo, u -> (wi, pdf), (weight, 0)
    albedo,  // wo, with parameters.point_count -> (direct, 0), (base, 0), (transmitted, 0)
    lights,  // wo -> (radiance of parameters.point_count lights, 1): the directions of the queries
             // that follow, around to the first
    copy,    // two rows -> one; moves the bytes of eval and computes nothing
    walk,  // an interface and a stream of random numbers, with parameters.point_count -> energies,
           // squares, spread: see shader_src/kernels/walk.comp; shades no material
    // What tables are baked from, see the kernels of these names; no materials either.
    walk_exits,       // an interface and a stream -> kWalksPerExitQuery times where light left
    walk_orders,      // an interface and a stream -> light entered, reflected once, reflected again
    walk_conductors,  // facets, a stream, three etas, three kappas -> light reflected
    walk_mirror_lobe,  // facets, an interface and a stream -> light reflected, transmitted
};

// LQ_WALKS_PER_QUERY of shader_src/kernels/walk_exits.comp.
inline constexpr std::uint32_t kWalksPerExitQuery = 8;

struct KernelShape {
    std::string_view name;
    std::uint32_t input_rows;   // per query, of four floats
    std::uint32_t result_rows;  // per query, of four floats
};

constexpr KernelShape kernel_shape(Kernel kernel) {
    switch (kernel) {
        case Kernel::eval:
            return {"eval", 2, 1};
        case Kernel::slice:
            return {"slice", 1, 1};
        case Kernel::sphere:
            return {"sphere", 2, 1};
        case Kernel::sample:
            return {"sample", 2, 2};
        case Kernel::albedo:
            return {"albedo", 1, 3};
        case Kernel::lights:
            return {"lights", 1, 1};
        case Kernel::copy:
            return {"copy", 2, 1};
        case Kernel::walk:
            return {"walk", 2, 3};
        case Kernel::walk_exits:
            return {"walk_exits", 2, kWalksPerExitQuery};
        case Kernel::walk_orders:
            return {"walk_orders", 2, 1};
        case Kernel::walk_conductors:
            return {"walk_conductors", 4, 1};
        case Kernel::walk_mirror_lobe:
            return {"walk_mirror_lobe", 2, 1};
    }
    return {"", 0, 0};
}

// Whether a kernel has a model at all; the others are generated once, for the first level.
constexpr bool shades_materials(Kernel kernel) {
    return kernel < Kernel::copy;
}

// LqKernelParameters of shader_src/kernels/bindings.glsl, byte for byte (std140).
struct KernelParameters {
    std::uint32_t query_count = 0;
    std::uint32_t queries_per_surface = 1;
    std::uint32_t point_count = 256;
    std::uint32_t reserved = 0;
    float wo[4] = {0, 0, 1, 0};
    float radiance[4] = {1, 1, 1, 0};
};
static_assert(sizeof(KernelParameters) == 48);

}  // namespace lacquer
