#include "reference/stack/transport.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "reference/stack/lobe_cosines.h"

namespace lacquer::reference {

namespace {

// Passes down to the base and up again that are followed one by one.
constexpr int kPasses = 64;
// Of the light that came, what is left to the geometric series.
constexpr double kLeft = 1e-3;

// Of a Lambertian lobe, per axis of the projected disk.
constexpr double kDiffuseVariance = 0.25;

constexpr double kTiny = 1e-30;  // keeps quotients of nothing finite

LobeCosines cosines_of(const Beam& beam) {
    return beam.diffuse ? diffuse_cosines() : lobe_cosines(beam.shape());
}

// What of a lobe becomes of part of its light: how much it is, and how its mean cosine and its
// spread differ from the lobe's.
struct Share {
    double light = 0.0;
    double tilt = 0.0, narrowing = 1.0;
};

Share share_of(const LobeCosines& lobe, const LobePart& all, const LobePart& part) {
    Share share{part.light(), 0.0, 1.0};
    if (lobe.count < 2 || part.light() <= kTiny) return share;
    share.tilt = part.mean_cosine() - all.mean_cosine();
    share.narrowing = std::min(part.spread() / std::max(all.spread(), kTiny), 1.0);
    return share;
}

// That part of a beam, each lobe of it narrower.
Beam part_of(const Beam& beam, const Share& share) {
    Beam part = beam;
    part.diffuse = false;
    part.sine = tilted(beam.shape(), share.tilt).sine;
    for (LobeLight& lobe : part.lobes) {
        lobe.energy *= share.light;
        lobe.variance = narrowed(lobe.variance, share.narrowing);
    }
    return part;
}

// The beam times a factor per colour that depends on direction.
template <typename Factor>
Beam attenuated(const Beam& beam, const Factor& factor) {
    const LobeCosines directions = cosines_of(beam);
    const Energy before = beam.energy();
    Energy average{0.0};
    LobePart all, left;
    for (std::size_t n = 0; n < directions.count; ++n) {
        const Energy passing = factor(directions.cosines[n]);
        average += directions.weights[n] * passing;
        all.add(directions, n, 1.0);
        left.add(directions, n, glm::dot(passing, before));
    }
    Share share = share_of(directions, all, left);
    share.light = 1.0;
    Beam result = part_of(beam, share);
    for (LobeLight& lobe : result.lobes) lobe.energy *= average;
    return result;
}

// What a medium lets through at an angle.
struct Crossing {
    Energy tau;
    Energy operator()(double cosine) const {
        return glm::pow(tau, Energy{1.0 / std::max(cosine, 1e-3)});
    }
};

class Transport {
 public:
    explicit Transport(const StackLayers& layers)
        : layers_{layers},
          lobe_count_{layers.interfaces.size() + 1},
          down_(lobe_count_, Beam{lobe_count_}),
          up_(lobe_count_, Beam{lobe_count_}) {
        light_.lobes.resize(lobe_count_);
    }

    void start_above(double cos_theta) {
        down_.front().sine = std::sqrt(1.0 - cos_theta * cos_theta);
        down_.front().lobes.front().energy = Energy{1.0};
    }

    // Returns what comes back from the lowest interface alone.
    Energy start_below() {
        Beam diffuse{lobe_count_};
        diffuse.diffuse = true;
        const double alpha = layers_.tables->equivalent_alpha(kDiffuseVariance);
        diffuse.lobes.back() = {Energy{1.0}, variance_of_alpha(alpha)};
        up_.back() = diffuse;
        up_.back().lobes.back().energy = attenuated(diffuse, crossing(lobe_count_ - 1)).energy();
        meet_from_below(layers_.interfaces.size() - 1);
        const Energy first = down_.back().energy();
        for (std::size_t n = layers_.interfaces.size() - 1; n-- > 0;) meet_from_below(n);
        return first;
    }

    StackLight run() {
        StackLight before = light_;
        Energy left{0.0}, now = moving();
        for (int pass = 0; pass < kPasses && sum(now) > kLeft; ++pass) {
            before = light_;
            left = now;
            pass_down();
            pass_up();
            now = moving();
        }
        add_rest(before, now / glm::max(left, now + kTiny));
        return light_;
    }

 private:
    // What travels between passes.
    Energy moving() const {
        Energy all{0.0};
        for (const Beam& beam : down_) all += beam.energy();
        return all;
    }

    // Every further pass adds `ratio` of what the one before added, of which `before` is the state.
    void add_rest(const StackLight& before, const Energy& ratio) {
        const Energy factor = ratio / (Energy{1.0} - glm::min(ratio, Energy{0.999}));
        for (std::size_t n = 0; n < lobe_count_; ++n)
            light_.lobes[n].energy += factor * (light_.lobes[n].energy - before.lobes[n].energy);
        light_.down += factor * (light_.down - before.down);
    }

    // What medium `medium`, of which 0 is the exterior, lets through.
    Crossing crossing(std::size_t medium) const { return {layers_.tau[medium - 1]}; }

    void send(Beam& to, std::size_t medium, const Beam& beam) {
        to.add(attenuated(beam, crossing(medium)));
    }

    void pass_down() {
        for (std::size_t n = 0; n < layers_.interfaces.size(); ++n) meet_from_above(n);
        Beam arrived{lobe_count_};
        std::swap(arrived, down_.back());
        if (!layers_.conductor) {
            light_.down += arrived.energy();
            return;
        }
        Beam returned =
            attenuated(arrived, [&](double cosine) { return layers_.conductor_albedo(cosine); });
        deepen(returned, lobe_count_ - 1, reflection_variance(layers_.conductor->alpha));
        send(up_.back(), lobe_count_ - 1, returned);
    }

    void pass_up() {
        for (std::size_t n = layers_.interfaces.size(); n-- > 0;) meet_from_below(n);
    }

    // Light reflected at interface or base `level` belongs to its lobe from now on, unless it has
    // been deeper.
    void deepen(Beam& beam, std::size_t level, double added_variance) const {
        for (LobeLight& lobe : beam.lobes) lobe.variance += added_variance;
        for (std::size_t n = 0; n < level; ++n) {
            beam.lobes[level].add(beam.lobes[n].energy, beam.lobes[n].variance);
            beam.lobes[n] = {};
        }
    }

    struct Parts {
        Beam reflected, refracted;
    };

    Parts split(const Beam& beam, const StackInterface& interface, bool downwards) const {
        const auto [from, into] = downwards ? std::pair{interface.ior_above, interface.ior_below}
                                            : std::pair{interface.ior_below, interface.ior_above};
        const LobeCosines directions = cosines_of(beam);
        LobePart all, passing, remaining;
        for (std::size_t n = 0; n < directions.count; ++n) {
            const double cosine = directions.cosines[n];
            const double t = downwards ? interface.t_down(cosine) : interface.t_up(cosine);
            all.add(directions, n, 1.0);
            passing.add(directions, n, t);
            remaining.add(directions, n, 1.0 - t);
        }
        Parts parts{part_of(beam, share_of(directions, all, remaining)),
                    part_of(beam, share_of(directions, all, passing))};
        const LobeShape kept = parts.reflected.shape();
        parts.reflected.sine =
            tilted(kept, reflection_tilt(kept, interface.alpha, into / from)).sine;
        const Refraction bent = refraction(parts.refracted.shape(), interface.alpha, from / into);
        parts.refracted.sine = bent.sine;
        for (LobeLight& lobe : parts.refracted.lobes) lobe.variance = bent.variance(lobe.variance);
        return parts;
    }

    void meet_from_above(std::size_t n) {
        Beam beam{lobe_count_};
        std::swap(beam, down_[n]);
        if (sum(beam.energy()) <= 0.0) return;
        const StackInterface& interface = layers_.interfaces[n];
        Parts parts = split(beam, interface, true);
        deepen(parts.reflected, n, reflection_variance(interface.alpha));
        if (n == 0)
            leave(parts.reflected);
        else
            send(up_[n], n, parts.reflected);
        send(down_[n + 1], n + 1, parts.refracted);
    }

    void meet_from_below(std::size_t n) {
        Beam beam{lobe_count_};
        std::swap(beam, up_[n + 1]);
        if (sum(beam.energy()) <= 0.0) return;
        const StackInterface& interface = layers_.interfaces[n];
        Parts parts = split(beam, interface, false);
        if (n == 0)
            leave(parts.refracted);
        else
            send(up_[n], n, parts.refracted);
        deepen(parts.reflected, 0, reflection_variance(interface.alpha));
        send(down_[n + 1], n + 1, parts.reflected);
    }

    void leave(const Beam& beam) {
        for (std::size_t n = 0; n < lobe_count_; ++n)
            light_.lobes[n].add(beam.lobes[n].energy, beam.lobes[n].variance);
    }

    const StackLayers& layers_;
    std::size_t lobe_count_;
    std::vector<Beam> down_, up_;  // about to leave each medium, of which 0 is the exterior
    StackLight light_;
};

}  // namespace

StackLight light_from_above(const StackLayers& layers, double cos_theta) {
    Transport transport{layers};
    transport.start_above(cos_theta);
    return transport.run();
}

Energy diffuse_return(const StackLayers& layers) {
    Transport transport{layers};
    const Energy first = transport.start_below();
    // The tables know that part better.
    const StackInterface& lowest = layers.interfaces.back();
    Energy known;
    for (int channel = 0; channel < 4; ++channel)
        known[channel] = layers.tables->r_up(lowest.alpha, lowest.ior_below / lowest.ior_above,
                                             layers.tau.back()[channel]);
    return glm::max(transport.run().down - first + known, Energy{0.0});
}

}  // namespace lacquer::reference
