// Means per colour channel with their standard errors.
#pragma once

#include <array>

#include "lacquer/material.h"
#include "simulator/estimator.h"
#include "simulator/sampling.h"

namespace lacquer::simulator {

struct RgbEstimate {
    Rgb mean{};
    Rgb standard_error{};
};

// Sums of what walks carry, per channel.
struct RgbMoments {
    std::array<Moments, 3> channels;

    void add(const Vec3& weight) {
        for (int channel = 0; channel < 3; ++channel)
            channels[static_cast<std::size_t>(channel)].add(weight[channel]);
    }

    void merge(const RgbMoments& other) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            channels[channel].merge(other.channels[channel]);
    }

    // Over `count` walks, times `scale`.
    RgbEstimate estimate(double count, double scale = 1.0) const {
        RgbEstimate result;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            result.mean[channel] = scale * channels[channel].mean(count);
            result.standard_error[channel] = scale * channels[channel].standard_error(count);
        }
        return result;
    }
};

}  // namespace lacquer::simulator
