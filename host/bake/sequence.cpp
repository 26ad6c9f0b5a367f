#include "bake/sequence.h"

#include <boost/random/sobol.hpp>

namespace lacquer::bake {

SobolPoints::SobolPoints(std::size_t count) : points_(count) {
    boost::random::sobol sequence{kDimensions};
    for (Point& point : points_)
        for (std::uint32_t& number : point) number = static_cast<std::uint32_t>(sequence() >> 32);
}

}  // namespace lacquer::bake
