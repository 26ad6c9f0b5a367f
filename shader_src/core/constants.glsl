// Numbers shared by every part of the library, and the limits that keep its formulas finite.
#ifndef LQ_CORE_CONSTANTS_GLSL
#define LQ_CORE_CONSTANTS_GLSL

const float LQ_PI = 3.14159265358979;
const float LQ_INVERSE_PI = 0.318309886183791;
const float LQ_INVERSE_SQRT_PI = 0.564189583547756;

// Lobes narrower than this are shaded at this width: a point light in a narrower one would land
// between the pixels, and the peak 1 / (pi alpha^2) stays well inside the range of a float.
const float LQ_MIN_ALPHA = 0.001;

// The ranges of the material format: a value outside them is clamped by `prepare`.
const float LQ_MIN_ETA = 0.333333333333333;
const float LQ_MAX_ETA = 3.0;
const float LQ_MAX_CONDUCTOR_INDEX = 40.0;

// exp(-80) is the smallest transmittance whose products are still normal floats.
const float LQ_MAX_OPTICAL_DEPTH = 80.0;

// Below this a denominator that is a product of two cosines is raised, so that directions within
// 1e-15 of the horizon give a large value instead of infinity.
const float LQ_MIN_COSINE_PRODUCT = 1.0e-30;

// A vector whose squared length lies outside these is no direction; formulas are bounded within.
const float LQ_MIN_SQUARED_LENGTH = 0.5;
const float LQ_MAX_SQUARED_LENGTH = 2.0;

#endif
