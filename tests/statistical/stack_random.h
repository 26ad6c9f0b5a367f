// Random stacks and directions for the model `stack`.
#pragma once

#include <glm/vec3.hpp>
#include <random>
#include <string>

#include "lacquer/material.h"

namespace lacquer::test {

enum class BaseKind { lambertian, conductor, none };

struct Configuration {
    Material material;
    double cos_theta;
};

double uniform(std::mt19937_64& generator, double low, double high);
Rgb uniform_rgb(std::mt19937_64& generator, double low, double high);
Microsurface isotropic(double alpha);

// Of this cosine, in the plane of x and z.
glm::dvec3 direction(double cos_theta);

// tau from 0.3, indices of varnishes, glasses and glazes in any order.
Configuration random_configuration(std::mt19937_64& generator, BaseKind base, int coats,
                                   double max_alpha = 0.8);

// Every interface and a conductor then have two or three strata of alphas up to `max_alpha`, mixed
// or one above the other; half of the conductors an index for each.
void make_blended(std::mt19937_64& generator, Configuration& at, double max_alpha = 0.8);

std::string describe(const Configuration& at, std::size_t channel);

}  // namespace lacquer::test
