#include "shading/interface_walk.h"

#include "shading/shader_float.h"

namespace lacquer {

InterfaceSums walk_interface(const glm::vec4& boundary, float stream, std::uint32_t walk_count) {
    const shader::LqInterfaceSums sums = shader::lq_walk_interface_sums(
        boundary.x, boundary.y, boundary.z, boundary.w, static_cast<std::uint32_t>(stream),
        static_cast<int>(walk_count));
    return {sums.energies, sums.squares, sums.spread};
}

}  // namespace lacquer
