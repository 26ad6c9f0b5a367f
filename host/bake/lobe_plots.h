// The plots of Belcour 2018, figures 3 to 6 and 21.
#pragma once

#include <string>

namespace lacquer::bake {

// <svg> elements one after the other; simulated anew, in some seconds.
std::string lobe_plots();

}  // namespace lacquer::bake
