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

LobeCosines cosines_of(const Beam& beam) {
    return beam.diffuse ? diffuse_cosines() : lobe_cosines(beam.shape());
}

// What of a beam passes something that treats directions differently, and how the mean cosines of
// what passes and of the rest differ from that of the beam.
struct Share {
    double passing = 0.0;
    double passing_tilt = 0.0, remaining_tilt = 0.0;
};

template <typename Coefficient>
Share share_of(const LobeCosines& lobe, const Coefficient& coefficient) {
    double passing = 0.0, cosine = 0.0;
    for (std::size_t n = 0; n < lobe.count; ++n) {
        const double part = lobe.weights[n] * coefficient(lobe.cosines[n]);
        passing += part;
        cosine += part * lobe.cosines[n];
    }
    Share share{passing, 0.0, 0.0};
    if (lobe.count < 2) return share;
    const double mean = lobe.mean();
    if (passing > 0.0) share.passing_tilt = cosine / passing - mean;
    if (passing < 1.0) share.remaining_tilt = (mean - cosine) / (1.0 - passing) - mean;
    return share;
}

// The beam times a factor per colour that depends on direction.
template <typename Factor>
Beam attenuated(const Beam& beam, const Factor& factor) {
    const LobeCosines directions = cosines_of(beam);
    const Energy before = beam.energy();
    Energy average{0.0};
    double light = 0.0, cosine = 0.0;
    for (std::size_t n = 0; n < directions.count; ++n) {
        const Energy part = directions.weights[n] * factor(directions.cosines[n]);
        average += part;
        light += glm::dot(part, before);
        cosine += glm::dot(part, before) * directions.cosines[n];
    }
    Beam result = beam;
    for (LobeLight& lobe : result.lobes) lobe.energy *= average;
    if (light > 0.0 && directions.count > 1)
        result.sine = tilted(beam.shape(), cosine / light - directions.mean()).sine;
    return result;
}

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

    void start_below() {
        Beam diffuse{lobe_count_};
        diffuse.diffuse = true;
        const double alpha = layers_.tables->equivalent_alpha(kDiffuseVariance);
        diffuse.lobes.back() = {Energy{1.0}, variance_of_alpha(alpha)};
        send(up_.back(), lobe_count_ - 1, diffuse);
        up_.back().diffuse = true;
        pass_up();
        up_.back().diffuse = false;
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
    static constexpr double kTiny = 1e-300;

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

    // Sends a beam across medium `medium`, of which 0 is the exterior.
    void send(Beam& to, std::size_t medium, const Beam& beam) {
        const Energy& tau = layers_.tau[medium - 1];
        to.add(attenuated(beam, [&](double cosine) {
            return glm::pow(tau, Energy{1.0 / std::max(cosine, 1e-3)});
        }));
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
        const Share share = share_of(cosines_of(beam), [&](double cosine) {
            return downwards ? interface.t_down(cosine) : interface.t_up(cosine);
        });
        Parts parts{beam, beam};
        parts.reflected.diffuse = parts.refracted.diffuse = false;
        const LobeShape shape = beam.shape();
        const LobeShape remaining = tilted(shape, share.remaining_tilt);
        parts.reflected.sine =
            tilted(remaining, reflection_tilt(remaining, interface.alpha, into / from)).sine;
        const Refraction bent =
            refraction(tilted(shape, share.passing_tilt), interface.alpha, from / into);
        parts.refracted.sine = bent.sine;
        for (LobeLight& lobe : parts.reflected.lobes) lobe.energy *= 1.0 - share.passing;
        for (LobeLight& lobe : parts.refracted.lobes) {
            lobe.energy *= share.passing;
            lobe.variance = bent.variance(lobe.variance);
        }
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
    transport.start_below();
    return transport.run().down;
}

}  // namespace lacquer::reference
