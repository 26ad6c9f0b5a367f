// Light in a whole layered material: interfaces, the media between them and what lies below.
#pragma once

#include <optional>
#include <vector>

#include "lacquer/material.h"
#include "simulator/medium.h"
#include "simulator/microsurface.h"
#include "simulator/random.h"

namespace lacquer::simulator {

// What became of the light of one walk.
enum class Fate {
    direct,       // left upwards and never reached the base
    base,         // left upwards after the base had reflected it
    transmitted,  // left below a material without a base
    lost,         // absorbed, or beyond the wanted order
};

struct Exit {
    Fate fate = Fate::lost;
    Vec3 direction;    // travelling away from the material
    Vec3 weight{0.0};  // of the light that started as 1
    int order = 0;     // facets met in all
};

struct StackOptions {
    // Facets that light may meet at one visit of an interface; 1 is the single-scattering model of
    // systems without multiple scattering. More is lost.
    int orders_per_crossing = kAllOrders;
};

class StackWalk {
 public:
    // Throws Error where the material describes a surface that has no meaning (see SurfaceWalk).
    explicit StackWalk(const Material& material, StackOptions options = {});

    // One walk that starts from the exterior towards the viewer's direction wo, reversed: light and
    // its time reversal take the same paths. `wo` unit, above the surface.
    Exit walk(const Vec3& wo, RandomStream& random) const;

    // One walk that starts from below the last interface of a material without base; `w` unit,
    // below the surface.
    Exit walk_from_below(const Vec3& w, RandomStream& random) const;

    // The surface that alone sends light back, where there is one: a bare base, or one interface
    // over nothing. nullptr for a Lambertian base and for anything with several parts.
    const SurfaceWalk* only_surface() const;

    // Whether all light that comes back was reflected by one surface, so that the number of facets
    // it met is its order of scattering there.
    bool is_one_surface() const { return levels_.empty() || only_surface() != nullptr; }

    int orders_per_crossing() const { return orders_per_crossing_; }

 private:
    struct Level {
        SurfaceWalk surface;
        Slab below;
    };

    Exit run(int level, const Vec3& direction, RandomStream& random) const;

    std::vector<Level> levels_;
    std::optional<SurfaceWalk> rough_base_;
    std::optional<Vec3> lambertian_;
    int orders_per_crossing_;
};

}  // namespace lacquer::simulator
