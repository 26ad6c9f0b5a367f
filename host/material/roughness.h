// Reads the microsurface of an interface or a base: alpha and ndf, or a blend of strata.
#pragma once

#include <functional>

#include "material/place.h"

namespace lacquer {

// What the strata of a blend may say beside weight, alpha and ndf.
struct StratumFields {
    std::vector<std::string_view> keys;                // all keys allowed in a stratum
    std::function<void(const Place&, Stratum&)> read;  // reads the other ones; may be empty
};

// `place` is the object that holds `alpha` or `blend`. Its keys are checked by the caller.
Roughness read_roughness(const Place& place, const StratumFields& fields);

}  // namespace lacquer
