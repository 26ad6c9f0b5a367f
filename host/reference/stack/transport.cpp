#include "reference/stack/transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "reference/shading.h"
#include "reference/stack/adding.h"
#include "reference/stack/directions.h"
#include "reference/stack/facet_effect.h"
#include "reference/stack/lobe_width.h"

namespace lacquer::reference {

namespace {

// Passes down to the base and up again that are followed one by one.
constexpr int kPasses = 2;
constexpr double kTiny = 1e-12;  // keeps quotients of nothing finite

using Cosines = decltype(LobeNodes::cosines);
constexpr double kNodes = std::tuple_size_v<Cosines>;

double sine_of(double cosine) {
    return direction_of(cosine).x;
}

// Part of the light of a beam: how much, relative to all that set out, and how its mean direction
// differs from that of all.
class Part {
 public:
    void add(const Energy& share, const Energy& beam, double cosine) {
        share_ += share / kNodes;
        const double light = glm::dot(share, beam);
        light_ += light;
        cosine_ += light * cosine;
        sine_ += light * sine_of(cosine);
    }

    const Energy& share() const { return share_; }

    Beam of(const Beam& beam, double mean_of_all) const {
        Beam part = beam;
        part.scale(share_);
        if (light_ <= kTiny) return part;
        part.cosine = std::clamp(beam.cosine + cosine_ / light_ - mean_of_all,
                                 std::min(beam.cosine, kLeastCosine), 1.0);
        return part;
    }

    // The same with a mean whose sine is to the beam's as the mean sines of part and all are, `all`
    // being the directions of the beam: right also of lobes so wide that their mean cosine says
    // little of where they point.
    Beam by_sine(const Beam& beam, const Cosines& all) const {
        Beam part = beam;
        part.scale(share_);
        double sum = 0.0;
        for (const double cosine : all) sum += sine_of(cosine);
        if (light_ <= kTiny || sum <= kTiny) return part;
        const double ratio = sine_ / light_ * kNodes / sum;
        const double sine = std::min(sine_of(beam.cosine) * ratio, kMostSine);
        part.cosine = std::sqrt(1.0 - sine * sine);
        return part;
    }

 private:
    Energy share_{0.0};
    double light_ = 0.0, cosine_ = 0.0, sine_ = 0.0;
};

double mean_of(const Cosines& cosines) {
    double sum = 0.0;
    for (const double cosine : cosines) sum += cosine;
    return sum / kNodes;
}

// The sine of the refracted mean, of a part of light that is more or less oblique than the beam
// whose mean is refracted to `refracted_sine`.
double sine_of_part(double refracted_sine, const Beam& part, const Beam& beam, double eta) {
    const double step = sine_of(part.cosine) - sine_of(beam.cosine);
    return std::clamp(refracted_sine + step / eta, 0.0, kMostSine);
}

// What light meets on its way: an interface, or a medium that scatters; after crossing what only
// absorbs.
struct Level {
    const StackInterface* interface = nullptr;
    const StackMedium* slab = nullptr;
    const StackMedium* above = nullptr;  // absorbs; null where nothing does
    const StackMedium* below = nullptr;
};

std::vector<Level> levels_of(const StackLayers& layers) {
    std::vector<Level> levels;
    const StackMedium* above = nullptr;
    for (std::size_t n = 0; n < layers.count(); ++n) {
        const StackMedium& medium = layers.media[n];
        const StackMedium* below = medium.slabs ? nullptr : &medium;
        levels.push_back({&layers.interfaces[n], nullptr, above, below});
        if (medium.slabs) levels.push_back({nullptr, &medium, nullptr, nullptr});
        above = below;
    }
    return levels;
}

class Transport {
 public:
    explicit Transport(const StackLayers& layers)
        : layers_{layers},
          levels_{levels_of(layers)},
          count_{levels_.size()},
          down_(count_ + 1),
          up_(count_ + 1),
          shares_(count_) {}

    StackLight run(double cosine) {
        down_[0].cosine = cosine;
        down_[0].through.energy = Energy{1.0};
        meet_interface(0, true);
        light_.top = light_.interfaces.energy.w;
        light_.interfaces = {};
        for (int pass = 0; pass < kPasses; ++pass) {
            pass_down();
            pass_up();
        }
        add_rest();
        return light_;
    }

    // As if all light entered.
    StackLight run_entered(double cosine) {
        all_enters_ = true;
        StackLight light = run(cosine);
        light.top = 0.0;
        return light;
    }

    Energy run_from_below() {
        Beam& diffuse = up_[count_];
        diffuse.cosine = kDiffuseCosine;
        diffuse.through = {Energy{1.0}, 1.0};
        pass_up();
        pass_down();
        return add_up(shares_, base_share_, false).returning;
    }

 private:
    // Of a lobe of roughness 1 about the normal, which is the widest there is.
    static constexpr double kDiffuseCosine = 1.0;

    void pass_down() {
        for (std::size_t n = 1; n < count_; ++n) meet(n, true);
        meet_bottom();
    }

    void pass_up() {
        for (std::size_t n = count_; n-- > 0;) meet(n, false);
        first_pass_ = false;
    }

    // The light about to leave a medium, which is taken from there.
    static Beam take(Beam& from) {
        Beam beam;
        std::swap(beam, from);
        return beam;
    }

    static Energy crossing(const StackMedium* medium, double cosine) {
        return medium ? medium->transmittance(cosine) : Energy{1.0};
    }

    void meet(std::size_t n, bool downwards) {
        if (levels_[n].slab)
            meet_slab(n, downwards);
        else
            meet_interface(n, downwards);
    }

    Beam take_arriving(std::size_t n, bool downwards) {
        return take(downwards ? down_[n] : up_[n + 1]);
    }

    void meet_interface(std::size_t n, bool downwards) {
        const Beam beam = take_arriving(n, downwards);
        const Energy light = beam.energy();
        if (sum(light) <= 0.0) return;
        const StackInterface& interface = *levels_[n].interface;
        const StackMedium* medium = downwards ? levels_[n].above : levels_[n].below;
        const Cosines cosines = layers_.tables->lobe(beam.cosine, beam.alpha()).cosines;
        std::vector<StratumShares> first;
        for (const double cosine : cosines) first.push_back(interface.first_met(cosine, downwards));
        const double eta = interface.eta(downwards);
        const double mean = mean_of(cosines);
        Energy reflected_share{0.0}, refracted_share{0.0};
        Beam kept, passed;
        for (std::size_t k = 0; k < interface.strata.size(); ++k) {
            const InterfaceStratum& stratum = interface.strata[k];
            Part reflected, refracted;
            for (std::size_t node = 0; node < cosines.size(); ++node) {
                const double cosine = cosines[node];
                const Energy arriving = crossing(medium, cosine) * first[node][k];
                const double share = interface.transmittance(stratum, cosine, downwards);
                refracted.add(arriving * share, light, cosine);
                reflected.add(arriving * (1.0 - share), light, cosine);
            }
            reflected_share += reflected.share();
            refracted_share += refracted.share();
            const FacetEffect facets = facet_effect(beam.cosine, stratum.alpha, eta);
            kept.add(mirrored(reflected.of(beam, mean), stratum.lobe_alpha, facets));
            passed.add(is_way_out(n, downwards)
                           ? let_out(refracted.by_sine(beam, cosines), stratum, eta)
                           : bent(refracted.of(beam, mean), beam, stratum.lobe_alpha, eta,
                                  facets.crossing_sine));
        }
        remember(n, downwards, reflected_share, refracted_share);
        if (all_enters_ && n == 0 && downwards) passed.through.energy = Energy{1.0};
        send_on(n, downwards, kept, passed);
    }

    void meet_slab(std::size_t n, bool downwards) {
        const Beam beam = take_arriving(n, downwards);
        if (sum(beam.energy()) <= 0.0) return;
        const std::array<ScatteringSlab, 4>& slabs = *levels_[n].slab->slabs;
        const Cosines cosines = layers_.tables->lobe(beam.cosine, beam.alpha()).cosines;
        Energy back{0.0}, through{0.0};
        ScatteringSlab average{0.0, 0.0, slabs.back().g};
        for (int channel = 0; channel < 4; ++channel) {
            const ScatteringSlab& slab = slabs[static_cast<std::size_t>(channel)];
            for (const double cosine : cosines) {
                const SlabLight light = slab_light(slab, cosine);
                back[channel] += light.back / kNodes;
                through[channel] += light.transmitted() / kNodes;
            }
            average.absorption += 0.25 * slab.absorption;
            average.scattering += 0.25 * slab.scattering;
        }
        remember(n, downwards, back, through);
        send_on(n, downwards, spread(beam, back, back_lobe(average, beam.cosine)),
                spread(beam, through, transmitted_lobe(average, beam.cosine)));
    }

    // A part of a beam that a medium has scattered.
    static Beam spread(const Beam& beam, const Energy& share, const SlabLobe& lobe) {
        Beam part = beam;
        part.scale(share);
        const double alpha = alpha_of_spread(lobe.spread, beam.cosine);
        part.for_each_lobe([&](LobeLight& light) { light.reflect(alpha); });
        const double sine = std::min(sine_of(beam.cosine) * lobe.sine_ratio, kMostSine);
        part.cosine = std::sqrt(1.0 - sine * sine);
        return part;
    }

    void send_on(std::size_t n, bool downwards, const Beam& kept, const Beam& passed) {
        if (downwards) {
            leave_upwards(n, from_below_top(n, kept));
            down_[n + 1].add(passed);
        } else {
            leave_upwards(n, passed);
            down_[n + 1].add(kept);
        }
    }

    void remember(std::size_t n, bool downwards, const Energy& reflected, const Energy& refracted) {
        InterfaceShares& at = shares_[n];
        (downwards ? at.reflected_down : at.reflected_up) = reflected;
        (downwards ? at.transmitted_down : at.transmitted_up) = refracted;
    }

    static Beam mirrored(Beam beam, double alpha, const FacetEffect& facets) {
        if (alpha < kMinAlpha) return beam;
        beam.cosine = std::clamp(beam.cosine + facets.reflected_tilt, kLeastCosine, 1.0);
        beam.for_each_lobe([&](LobeLight& lobe) { lobe.reflect(alpha * facets.reflected_width); });
        return beam;
    }

    // `mean`: the sine of what all of the beam becomes.
    static Beam bent(Beam part, const Beam& beam, double alpha, double eta, double mean) {
        const double sine = sine_of_part(mean, part, beam, eta);
        const double cosine = std::sqrt(1.0 - sine * sine);
        const RefractedRoughness rough = refracted_roughness(part.cosine, cosine, alpha, eta);
        const double widening = width_of_alpha(rough.scale);
        const double added = variance_of_width(width_of_alpha(rough.added));
        part.for_each_lobe([&](LobeLight& lobe) {
            lobe.width = width_of_variance(widening * variance_of_width(lobe.width) + added);
        });
        part.cosine = cosine;
        return part;
    }

    bool is_way_out(std::size_t n, bool downwards) const {
        return downwards && n + 1 == count_ && layers_.open_below;
    }

    // Light that leaves for good: its direction and width are seen, not only what they make of
    // energies, so that facets are looked at from the mean of the part that passes.
    static Beam let_out(const Beam& part, const InterfaceStratum& stratum, double eta) {
        return bent(part, part, stratum.lobe_alpha, eta,
                    facet_effect(part.cosine, stratum.alpha, eta).refracted_sine);
    }

    // What is reflected below the top interface has met an interface.
    static Beam from_below_top(std::size_t n, Beam beam) {
        if (n == 0) return beam;
        beam.interfaces.add(beam.through);
        beam.through = {};
        return beam;
    }

    // Light that goes up from interface n into the medium above it.
    void leave_upwards(std::size_t n, const Beam& beam) {
        if (n > 0) {
            up_[n].add(beam);
            return;
        }
        light_.interfaces.add(beam.through);
        light_.interfaces.add(beam.interfaces);
        light_.base.add(beam.base);
    }

    void meet_bottom() {
        const Beam beam = take(down_[count_]);
        const Energy light = beam.energy();
        if (sum(light) <= 0.0) return;
        const Cosines cosines = layers_.tables->lobe(beam.cosine, beam.alpha()).cosines;
        if (layers_.conductor) {
            base_share_ = Energy{0.0};
            for (std::size_t k = 0; k < layers_.conductor->strata.size(); ++k)
                meet_conductor(k, beam, cosines);
            return;
        }
        Part arriving;
        for (const double cosine : cosines)
            arriving.add(crossing(levels_.back().below, cosine), light, cosine);
        base_share_ = arriving.share();
        (first_pass_ ? light_.straight : light_.detoured).add(arriving.of(beam, mean_of(cosines)));
    }

    // Of a beam what facets of stratum k reflect first.
    void meet_conductor(std::size_t k, const Beam& beam, const Cosines& cosines) {
        const ConductorStratum& stratum = layers_.conductor->strata[k];
        Part remaining;
        for (const double cosine : cosines)
            remaining.add(crossing(levels_.back().below, cosine) *
                              layers_.conductor->first_met(cosine)[k] *
                              stratum.albedo(cosine, beam.cosine),
                          beam.energy(), cosine);
        base_share_ += remaining.share();
        Beam left = remaining.of(beam, mean_of(cosines));
        if (stratum.lobe_alpha >= kMinAlpha)
            left.for_each_lobe([&](LobeLight& lobe) { lobe.reflect(stratum.lobe_alpha); });
        left.base.add(left.interfaces);
        left.base.add(left.through);
        left.through = left.interfaces = {};
        up_[count_].add(left);
    }

    // What is still on its way down, all at once: it leaves as wide as what has left before.
    void add_rest() {
        const bool conducts = layers_.conductor.has_value();
        const StackShares rest = add_up(shares_, base_share_, conducts);
        for (std::size_t n = 1; n <= count_; ++n) {
            const Beam& beam = down_[n];
            const Energy shallow = beam.through.energy + beam.interfaces.energy;
            const bool meets_base = conducts && n == count_;
            light_.base.energy +=
                rest.escaping[n] * (beam.base.energy + (meets_base ? shallow : Energy{0.0}));
            if (!meets_base) light_.interfaces.energy += rest.escaping[n] * shallow;
            light_.detoured.interfaces.energy += rest.arriving[n] * beam.energy();
        }
    }

    const StackLayers& layers_;
    std::vector<Level> levels_;
    std::size_t count_;
    std::vector<Beam> down_, up_;  // on their way to level n, or up from it, and to the bottom
    std::vector<InterfaceShares> shares_;
    Energy base_share_{0.0};
    bool all_enters_ = false, first_pass_ = true;
    StackLight light_;
};

}  // namespace

void StackLight::merge_lobes() {
    base.add(interfaces);
    interfaces = {};
}

StackLight light_from_above(const StackLayers& layers, double cosine) {
    return Transport{layers}.run(cosine);
}

StackLight light_of_entered(const StackLayers& layers, double cosine) {
    return Transport{layers}.run_entered(cosine);
}

Energy diffuse_return(const StackLayers& layers) {
    return Transport{layers}.run_from_below();
}

}  // namespace lacquer::reference
