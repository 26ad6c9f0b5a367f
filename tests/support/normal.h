// The normal distribution's limits for z tests.
#pragma once

namespace lacquer::test {

// |z| that a standard normal number exceeds with probability `significance`.
double two_sided_z(double significance);

}  // namespace lacquer::test
