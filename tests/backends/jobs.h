// Jobs for every kernel over materials that use every branch of a model.
#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backends/backend.h"

namespace lacquer::test {

// A job with what it refers to.
struct OwnedJob {
    Kernel kernel = Kernel::eval;
    std::vector<Material> materials;
    std::uint64_t queries_per_material = 1;
    std::vector<glm::vec4> inputs;
    KernelParameters parameters;
    Model model = Model::plain;

    Job job() const;
};

inline constexpr Kernel kAllKernels[] = {Kernel::eval,   Kernel::slice,  Kernel::sphere,
                                         Kernel::sample, Kernel::albedo, Kernel::lights,
                                         Kernel::copy};

// All models of the shader source but `plain`.
std::vector<Model> other_models();

// Coated and bare, dielectric and metal, both distributions, isotropic and not, no base.
std::vector<Material> test_materials();

// Those of them that `model` can shade.
std::vector<Material> shadeable(std::vector<Material> materials, Model model);

// Unit directions above the surface, spread evenly over solid angle except that every eighth is
// within a degree of the horizon and every 64th is the normal. `stream` shifts the sequence.
std::vector<glm::vec4> directions(std::size_t count, double stream);

// Every query its own directions.
OwnedJob make_job(Kernel kernel, std::vector<Material> materials,
                  std::uint64_t queries_per_material);

// All backends of the registry but the reference, by name.
std::vector<std::string> shader_backends();

// The backend, or null with the reason in `skipped` where it cannot run here.
std::unique_ptr<Backend> create_or_explain(const std::string& name, std::string& skipped,
                                           const BackendOptions& options = {});

}  // namespace lacquer::test
