// The statistics of one rough dielectric interface over an absorbing medium: what the tables hold.
// Based on: de Dinechin and Belcour 2022, section 3
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/estimator.h"
#include "simulator/microsurface.h"

namespace lacquer::simulator {

struct Estimate {
    double mean = 0.0;
    double standard_error = 0.0;
};

// Each energy includes its crossings of the medium below: T01 one after entering, T10 one before
// leaving, R10 both.
struct InterfaceEstimate {
    Estimate t_down;    // T01: light arriving at cos_theta that enters
    Estimate fgd;       // light arriving at cos_theta that is reflected
    Estimate r_up;      // R10: diffuse light from inside that is reflected back inside
    Estimate t_up;      // T10: diffuse light from inside that leaves
    Estimate variance;  // sigma_2+: of the light that leaves, per axis of the projected disk; 0
                        // where none leaves, under an opaque medium
    std::uint64_t samples = 0;
};

// `eta` = ior below / ior above; `tau` in [0, 1] the transmittance of the medium along the normal.
InterfaceEstimate estimate_interface(const Facets& facets, double eta, double tau, double cos_theta,
                                     const RunOptions& options);

}  // namespace lacquer::simulator
