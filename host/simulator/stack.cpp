#include "simulator/stack.h"

#include "simulator/roulette.h"

namespace lacquer::simulator {

namespace {

Facets to_facets(const Microsurface& microsurface) {
    return {microsurface.ndf, microsurface.alpha[0], microsurface.alpha[1]};
}

// `material_of` gives the facets' material for a stratum, whose own constants it may hold.
template <typename MaterialOf>
Surface make_surface(const Roughness& roughness, const MaterialOf& material_of) {
    Surface surface;
    if (const auto* uniform = std::get_if<Microsurface>(&roughness)) {
        surface.strata.push_back({1.0, to_facets(*uniform), material_of(Stratum{})});
        return surface;
    }
    const auto& blend = std::get<Blend>(roughness);
    surface.op = blend.op;
    double rest = 1.0;
    for (std::size_t index = 0; index < blend.strata.size(); ++index) {
        const Stratum& stratum = blend.strata[index];
        const double weight = index + 1 == blend.strata.size() ? rest : stratum.weight;
        rest -= weight;
        surface.strata.push_back({weight, to_facets(stratum.microsurface), material_of(stratum)});
    }
    return surface;
}

Rgb divided(Rgb rgb, double by) {
    for (double& channel : rgb) channel /= by;
    return rgb;
}

Surface conductor_surface(const ConductorBase& base, double ior_above) {
    return make_surface(base.roughness, [&](const Stratum& stratum) -> FacetMaterial {
        if (stratum.albedo) return DiffuseFacet{*stratum.albedo};
        return ConductorFacet{divided(stratum.eta.value_or(base.eta), ior_above),
                              divided(stratum.kappa.value_or(base.kappa), ior_above)};
    });
}

Surface diffuse_surface(const DiffuseFacetsBase& base, double ior_above) {
    return make_surface(base.roughness, [&](const Stratum& stratum) -> FacetMaterial {
        if (stratum.eta || stratum.kappa)
            return ConductorFacet{divided(stratum.eta.value_or(Rgb{}), ior_above),
                                  divided(stratum.kappa.value_or(Rgb{}), ior_above)};
        return DiffuseFacet{stratum.albedo.value_or(base.albedo)};
    });
}

}  // namespace

StackWalk::StackWalk(const Material& material, StackOptions options)
    : orders_per_crossing_{options.orders_per_crossing} {
    double ior_above = material.exterior_ior;
    for (const Layer& layer : material.layers) {
        const double eta = layer.interface.ior / ior_above;
        levels_.push_back({SurfaceWalk{make_surface(layer.interface.roughness,
                                                    [eta](const Stratum&) -> FacetMaterial {
                                                        return DielectricFacet{eta};
                                                    })},
                           make_slab(layer.medium)});
        ior_above = layer.interface.ior;
    }
    if (const auto* lambertian = std::get_if<LambertianBase>(&material.base)) {
        lambertian_ = Vec3{lambertian->albedo[0], lambertian->albedo[1], lambertian->albedo[2]};
    } else if (const auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        rough_base_.emplace(conductor_surface(*conductor, ior_above));
    } else if (const auto* diffuse = std::get_if<DiffuseFacetsBase>(&material.base)) {
        rough_base_.emplace(diffuse_surface(*diffuse, ior_above));
    }
}

const SurfaceWalk* StackWalk::only_surface() const {
    if (levels_.empty() && rough_base_) return &*rough_base_;
    const bool bare = !rough_base_ && !lambertian_;
    if (levels_.size() == 1 && bare && !levels_.front().below.scatters())
        return &levels_.front().surface;
    return nullptr;
}

Exit StackWalk::walk(const Vec3& wo, RandomStream& random) const {
    return run(0, -wo, random);
}

Exit StackWalk::walk_from_below(const Vec3& w, RandomStream& random) const {
    return run(static_cast<int>(levels_.size()) - 1, -w, random);
}

// The walk stands above interface `level` when it travels down and below it when it travels up.
Exit StackWalk::run(int level, const Vec3& start, RandomStream& random) const {
    const int count = static_cast<int>(levels_.size());
    Exit exit;
    exit.weight = Vec3{1.0};
    Vec3 direction = start;
    bool reached_base = false;
    for (;;) {
        const bool at_base = level == count;
        if (at_base && !lambertian_ && !rough_base_) {
            exit.fate = Fate::transmitted;
            break;
        }
        reached_base = reached_base || at_base;
        if (at_base && lambertian_) {
            exit.weight *= *lambertian_;
            direction = sample_cosine(random);
            ++exit.order;
        } else {
            const SurfaceWalk& surface =
                at_base ? *rough_base_ : levels_[static_cast<std::size_t>(level)].surface;
            const Crossing crossing = surface.cross(direction, random, orders_per_crossing_);
            if (crossing.lost) return {};
            exit.weight *= crossing.weight;
            exit.order += crossing.order;
            direction = crossing.direction;
        }
        if (!survives(exit.weight, random)) return {};
        // On to the next interface through the slab on the side where the walk left this one.
        const int slab = direction.z < 0.0 ? level : level - 1;
        if (slab < 0) {
            exit.fate = reached_base ? Fate::base : Fate::direct;
            break;
        }
        const Passage passage =
            pass_slab(levels_[static_cast<std::size_t>(slab)].below, direction, random);
        if (passage.lost) return {};
        exit.weight *= passage.weight;
        direction = passage.direction;
        level = passage.down ? slab + 1 : slab;
    }
    exit.direction = direction;
    return exit;
}

}  // namespace lacquer::simulator
