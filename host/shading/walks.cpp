#include "shading/walks.h"

#include <algorithm>

#include "shading/shader_float.h"

namespace lacquer {

namespace {

constexpr std::uint32_t kWalksPerExitQuery = 8;  // LQ_WALKS_PER_QUERY

std::uint32_t whole_number(float x) {
    return static_cast<std::uint32_t>(std::clamp(x, 0.0f, 16777215.0f));
}

// The stream of walk `n` of a query: shader_src/kernels/walk_queries.glsl.
shader::LqWalkStream stream_of(const glm::vec4* inputs, std::uint32_t n) {
    return {whole_number(inputs[1].x), whole_number(inputs[1].y), whole_number(inputs[0].w) + n};
}

}  // namespace

void walk_interface(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results) {
    const glm::vec4& boundary = inputs[0];
    const shader::LqInterfaceSums sums = shader::lq_walk_interface_sums(
        boundary.x, boundary.y, boundary.z, boundary.w, static_cast<std::uint32_t>(inputs[1].x),
        static_cast<int>(walk_count));
    results[0] = sums.energies;
    results[1] = sums.squares;
    results[2] = sums.spread;
}

void walk_exits(const glm::vec4* inputs, std::uint32_t, glm::dvec4* results) {
    const glm::vec4& boundary = inputs[0];
    for (std::uint32_t n = 0; n < kWalksPerExitQuery; ++n) {
        const shader::LqExits exits =
            shader::lq_walk_exits(boundary.z, boundary.x, boundary.y, stream_of(inputs, n));
        results[n] = {exits.entered.light, exits.entered.cosine, exits.reflected.light,
                      exits.reflected.cosine};
    }
}

void walk_orders(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results) {
    const glm::vec4& boundary = inputs[0];
    glm::vec3 sum{0.0f};
    for (std::uint32_t n = 0; n < walk_count; ++n) {
        const shader::LqExits exits =
            shader::lq_walk_exits(boundary.z, boundary.x, boundary.y, stream_of(inputs, n));
        sum += glm::vec3{exits.entered.light, exits.reflected_once,
                         std::max(exits.reflected.light - exits.reflected_once, 0.0f)};
    }
    results[0] = glm::dvec4{sum, 0.0};
}

void walk_conductors(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results) {
    glm::vec3 sum{0.0f};
    for (std::uint32_t n = 0; n < walk_count; ++n)
        sum += shader::lq_walk_conductors(inputs[0].z, inputs[0].x, glm::vec3{inputs[2]},
                                          glm::vec3{inputs[3]}, stream_of(inputs, n));
    results[0] = glm::dvec4{sum, 0.0};
}

void walk_mirror_lobe(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results) {
    float reflected = 0.0f, transmitted = 0.0f;
    for (std::uint32_t n = 0; n < walk_count; ++n) {
        const shader::LqLobeLight light = shader::lq_walk_mirror_lobe(
            inputs[0].z, inputs[0].x, inputs[0].y, stream_of(inputs, n));
        reflected += light.reflected;
        transmitted += light.transmitted;
    }
    results[0] = {reflected, transmitted, 0.0, 0.0};
}

}  // namespace lacquer
