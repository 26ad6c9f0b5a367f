// A stack as prepared for symmetric shading, for any number of viewers and lights.
#ifndef LQ_STACK_SYMMETRIC_SURFACE_GLSL
#define LQ_STACK_SYMMETRIC_SURFACE_GLSL

#include "../stack/diffuse_base.glsl"
#include "../stack/surface.glsl"
#include "balance.glsl"
#include "fitted_lobe.glsl"

// A class of light that was reflected below the top interface.
struct LqSymmetricLobe {
    LqFittedLobe light;
    LqBalance balance;
};

// Besides what the forward model has: light reflected by lower interfaces at most, and by a
// conductor, or all of it in the former where LQ_STACK_LOBES is 2; without a base what comes straight
// down and what was reflected on the way, and the sine of either's mean direction over that of the
// light that came (x and y); and a Lambertian base's.
struct LqStackSymmetricSurface {
    LqStackSurface stack;
    LqSymmetricLobe interfaces;
    LqSymmetricLobe base;
    LqFittedLobe straight;
    LqFittedLobe detoured;
    LqCubic sine_ratios;
    LqStackDiffuse diffuse;
};

#endif
