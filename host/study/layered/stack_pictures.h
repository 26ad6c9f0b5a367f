// Stacks in pictures: simulated, by every model that can shade them, and how far each is off.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/figure.h"
#include "study/layered/compared.h"
#include "study/run.h"
#include "study/view.h"

namespace lacquer::study {

// What the errors of pictures are.
extern const char* const kPictureMeasure;

// One view of one material, simulated.
struct Shown {
    Material material;
    View view;
    Radiance truth;
    std::uint64_t points = 0;  // of each model's samples, for a ball
};

// A ball in the studio.
Shown shown_ball(const Material& material, const StudyRun& run);

// All light directions for a viewer at `theta_o_deg`.
Shown shown_slice(const Material& material, double theta_o_deg, const StudyRun& run);

// A table of pictures: for each of `shown` a row of pictures and one of differences, a column for
// the simulation and for each model; empty with the reason where a model cannot shade it. Adds the
// errors too.
void add_pictures(Figure& figure, const std::string& title, std::span<const Shown> shown);

// Appends a column of other pictures of `shown`, one of each, to the table added last, with the
// error of each in place of a model's.
void add_column(Figure& figure, const std::string& name, std::span<const Shown> shown,
                std::span<const Radiance> pictures);

}  // namespace lacquer::study
