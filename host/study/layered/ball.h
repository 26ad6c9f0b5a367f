// A ball of an isotropic material in surroundings, seen from far away, simulated and by models.
#pragma once

#include "simulator/stack.h"
#include "study/layered/received.h"
#include "study/run.h"
#include "study/view.h"

namespace lacquer::study {

View ball_view();

// By run.samples / 4 walks. Pixels as far from the middle as each other see the same walks from
// different places, so that their errors go together. `max_order` leaves out light that met more
// facets.
Radiance simulate_ball(const View& view, const simulator::StackWalk& stack,
                       Surroundings surroundings, const StudyRun& run, std::string_view name,
                       int max_order = simulator::kAllOrders);

// By so many of the model's own samples for each distance from the middle, each of which serves 16
// pixels; with errors, see received_evenly.
Radiance shade_ball(const View& view, const ModelLight& model, Surroundings surroundings,
                    std::uint64_t points);

}  // namespace lacquer::study
