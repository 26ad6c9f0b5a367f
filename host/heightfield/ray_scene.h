// Which facet of a mesh a ray meets first (Embree).
#pragma once

#include <memory>
#include <optional>

#include "heightfield/facet_mesh.h"

namespace lacquer::heightfield {

struct RayHit {
    std::uint32_t triangle = 0;
    glm::dvec3 point{};  // on the triangle
};

class RayScene {
 public:
    explicit RayScene(FacetMesh mesh);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    const FacetMesh& mesh() const;

    // The first facet within `distance` that turns its upper side to the ray, or its lower side
    // where the ray is below the surface: a ray that leaves a facet is never caught by that same
    // facet. `direction` unit. Several threads may ask at once.
    std::optional<RayHit> first_hit(const glm::dvec3& origin, const glm::dvec3& direction,
                                    double distance, bool below) const;

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lacquer::heightfield
