// The pictures that studies show of a material: a lit sphere, and the light that one viewer gets
// from every direction. Per pixel the radiance pi f cos_theta_i under a light of irradiance pi
// across its beam, to which a sphere adds that of a uniform environment.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "compare/grids.h"
#include "lacquer/material.h"
#include "study/figure.h"
#include "study/model_light.h"

namespace lacquer::study {

struct View {
    std::string name;   // of its files: "sphere", "slice 45"
    std::string label;  // for people
    QueryGrid grid;
    double environment = 0.0;  // radiance from everywhere
    bool has_beam = true;      // false: lit by surroundings that it does not describe
};

View sphere_view();

// For a viewer at `theta_o_deg` from the normal.
View slice_view(double theta_o_deg);

// Radiance per query of a view, with its standard error where it was simulated or sampled.
struct Radiance {
    std::vector<glm::dvec3> values, errors{};
};

// By a model.
Radiance shade(const View& view, const ModelLight& model);

// A picture of radiance, its name that of its files.
Picture radiance_picture(const View& view, const Radiance& radiance, const std::string& name);

// A picture of the mean over the channels of `radiance` less `truth`, in colours up to `limit`.
Picture difference_picture(const View& view, const Radiance& radiance, const Radiance& truth,
                           double limit, const std::string& name);

// The mean |difference| over all pixels and channels, as a share of all of truth's radiance; the
// largest is that of one pixel, averaged over its channels, in radiance, beyond three standard
// errors of both.
ModelError picture_error(const View& view, const Radiance& radiance, const Radiance& truth,
                         const std::string& subject, std::string_view model);

}  // namespace lacquer::study
