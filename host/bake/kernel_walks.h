// The walks of shader_src/microsurface on any backend, in place of the C++ walks of this folder.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "backends/backend.h"
#include "bake/walks.h"

namespace lacquer::bake {

// Plain random numbers drive these walks, so that they need more of them for the same noise. Their
// number is rounded up to whole queries. Throws Error with the backend's message where it fails.
class KernelWalks final : public Walks {
 public:
    // `name` is the backend's in the registry; every backend but the reference has the kernels.
    KernelWalks(std::string name, std::unique_ptr<Backend> backend, std::size_t samples);

    std::string_view backend() const override { return name_; }
    bool concurrent() const override { return false; }
    std::vector<CosineHistogram> light_entering(std::span<const double> cosines, double alpha,
                                                double eta, std::uint64_t seed) const override;
    std::vector<double> light_reflected_again(std::span<const double> cosines, double alpha,
                                              double eta, std::uint64_t seed) const override;
    DiffuseExits light_leaving(double alpha, double eta, std::uint64_t seed) const override;
    std::vector<double> reflected_by_conductors(double cos_theta, double alpha,
                                                const Conductors& conductors,
                                                std::uint64_t seed) const override;
    double reflected_once(double cos_theta, double alpha, std::uint64_t seed) const override;
    std::vector<double> lobe_transmittances(std::span<const double> cosines, double alpha,
                                            double eta, std::uint64_t seed) const override;

 private:
    // What `kernel` sums up, per cosine and walk.
    std::vector<glm::dvec3> means(Kernel kernel, std::span<const double> cosines, double alpha,
                                  double eta, std::uint64_t seed) const;

    // Runs `count` queries. `inputs(query, rows)` writes what each reads; `take(query, rows)` is
    // told what it returns.
    void run(Kernel kernel, std::size_t count,
             const std::function<void(std::size_t, std::span<glm::vec4>)>& inputs,
             const std::function<void(std::size_t, std::span<const glm::dvec4>)>& take) const;

    std::string name_;
    std::unique_ptr<Backend> backend_;
    std::size_t samples_;
};

}  // namespace lacquer::bake
