// Binds the kernels to `lq_plain_*`: the rows of a packed surface, and the model under the names
// that every kernel uses. The host's side is host/backends/pack_plain.cpp.
#ifndef LQ_KERNELS_MODEL_PLAIN_GLSL
#define LQ_KERNELS_MODEL_PLAIN_GLSL

#include "../plain/plain.glsl"
#include "bindings.glsl"

#define LqModelSurface LqPlainSurface
#define lq_model_eval lq_plain_eval
#define lq_model_eval_cos lq_plain_eval_cos
#define lq_model_pdf lq_plain_pdf
#define lq_model_sample lq_plain_sample
#define lq_model_albedo lq_plain_albedo

const uint LQ_PLAIN_ROWS = 5u;

// Rows: (coat alpha x, y, coat eta, coat ndf), (base alpha x, y, base kind, base ndf), albedo, eta,
// kappa.
LqPlainSurface lq_model_surface(const uint query) {
    const uint row = query / parameters.queries_per_surface * LQ_PLAIN_ROWS;
    const vec4 coat = surfaces.rows[row];
    const vec4 base = surfaces.rows[row + 1u];
    const vec4 albedo = surfaces.rows[row + 2u];
    const vec4 eta = surfaces.rows[row + 3u];
    const vec4 kappa = surfaces.rows[row + 4u];
    return lq_plain_prepare(LqPlainSurface(
        LqFacets(int(coat.w), coat.x, coat.y), coat.z, int(base.z),
        vec3(albedo.x, albedo.y, albedo.z), LqFacets(int(base.w), base.x, base.y),
        vec3(eta.x, eta.y, eta.z), vec3(kappa.x, kappa.y, kappa.z)));
}

#endif
