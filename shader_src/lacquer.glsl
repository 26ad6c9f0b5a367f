// Lacquer: BSDFs of coated and layered surfaces. This file includes every part of the library; each
// level below also stands alone.
//
// Conventions, everywhere: a local frame with z = the macroscopic normal; `wi` towards the light,
// `wo` towards the viewer, `wm` a facet normal, all unit and pointing away from the surface. `f` is
// the BSDF per steradian without the cosine; a name ending in `_cos` includes cos_theta_i. `eta` is
// ior below / ior above an interface, a conductor's index is eta + i kappa, `alpha` is the slope
// roughness of the papers. Shaders return no NaN, no infinity and nothing negative.
//
// Whoever includes this supplies `lq_table_texel` (tables/interpolate.glsl) and `lq_stack_row`
// (stack/material.glsl).
#ifndef LQ_LACQUER_GLSL
#define LQ_LACQUER_GLSL

#include "core/frame.glsl"
#include "core/random.glsl"
#include "core/sampling.glsl"
#include "interface/energies.glsl"
#include "lighting/sphere.glsl"
#include "lighting/tone_mapping.glsl"
#include "microsurface/exits.glsl"
#include "microsurface/mirror_walk.glsl"
#include "microsurface/walk.glsl"

// Levels:
#include "clearcoat/clearcoat.glsl"
#include "coated/coated.glsl"
#include "microsurface_compensated/microsurface_compensated.glsl"
#include "microsurface_single/microsurface_single.glsl"
#include "microsurface_stochastic/microsurface_stochastic.glsl"
#include "openpbr_coat/openpbr_coat.glsl"
#include "plain/plain.glsl"
#include "stack/stack.glsl"
#include "stack_symmetric/stack_symmetric.glsl"
#include "weidlich_wilkie/weidlich_wilkie.glsl"

#endif
