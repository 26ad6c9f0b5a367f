// The incomplete beta function, as much of it as lies between two heights of a rough surface.
#pragma once

namespace lacquer::reference {

// The integral over c from `low` to `high` of
//     (c / high)^lambda_above ((1 - c) / (1 - low))^lambda_below,
// 0 <= low < high <= 1 and both lambdas finite and at least 0: facets between both heights, as far
// as rays leave the range upwards and downwards. At most high - low. Relative error about 1e-12.
//
// Without its divisors this is B(high; a, b) - B(low; a, b), a and b = 1 + both lambdas; with them
// it is in range for lambdas of any size.
double beta_between(double low, double high, double lambda_above, double lambda_below);

}  // namespace lacquer::reference
