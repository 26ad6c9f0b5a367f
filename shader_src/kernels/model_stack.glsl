// Binds the kernels to `lq_stack_*`: the model under the names that every kernel uses, and the rows
// of a packed surface. The host's side is host/backends/pack_stack.cpp.
#ifndef LQ_KERNELS_MODEL_STACK_GLSL
#define LQ_KERNELS_MODEL_STACK_GLSL

#include "../stack/stack.glsl"

#define LqModelSurface LqStackSurface
#define lq_model_eval lq_stack_eval
#define lq_model_eval_cos lq_stack_eval_cos
#define lq_model_pdf lq_stack_pdf
#define lq_model_sample lq_stack_sample
#define LqModelView LqStackView
#define lq_model_view lq_stack_view
#define lq_model_view_eval_cos lq_stack_view_eval_cos
#define lq_model_albedo(surface, wo, point_count) lq_stack_albedo(surface, wo)

// Rows: (layer count, base kind, base alpha x, y), (base albedo or eta, base ndf), (base kappa, 0);
// then for each of LQ_MAX_LAYERS (alpha x, y, index, ndf), (absorption, g) and (scattering, 0).
#define LQ_MODEL_ROWS 27u

// The rows of a layer.
struct LqPackedLayer {
    vec4 interface_row;
    vec4 absorption;
    vec4 scattering;
};

LqStackMaterial lq_stack_unpack_base(const vec4 head, const vec4 colour, const vec4 kappa) {
    LqStackMaterial material;
    material.layer_count = int(head.x);
    material.base = int(head.y);
    material.albedo = vec3(colour.x, colour.y, colour.z);
    material.facets = LqFacets(int(colour.w), head.z, head.w);
    material.eta = material.albedo;
    material.kappa = vec3(kappa.x, kappa.y, kappa.z);
    return material;
}

// The prepared surface of packed rows; layers in pairs of rows.
LqStackSurface lq_stack_unpack(const vec4 head, const vec4 colour, const vec4 kappa,
                               const LqPackedLayer a, const LqPackedLayer b,
                               const LqPackedLayer c, const LqPackedLayer d,
                               const LqPackedLayer e, const LqPackedLayer f,
                               const LqPackedLayer g, const LqPackedLayer h) {
    LqStackMaterial material = lq_stack_unpack_base(head, colour, kappa);
    material.interfaces[0] = a.interface_row;
    material.interfaces[1] = b.interface_row;
    material.interfaces[2] = c.interface_row;
    material.interfaces[3] = d.interface_row;
    material.interfaces[4] = e.interface_row;
    material.interfaces[5] = f.interface_row;
    material.interfaces[6] = g.interface_row;
    material.interfaces[7] = h.interface_row;
    material.absorption[0] = a.absorption;
    material.scattering[0] = a.scattering;
    material.absorption[1] = b.absorption;
    material.scattering[1] = b.scattering;
    material.absorption[2] = c.absorption;
    material.scattering[2] = c.scattering;
    material.absorption[3] = d.absorption;
    material.scattering[3] = d.scattering;
    material.absorption[4] = e.absorption;
    material.scattering[4] = e.scattering;
    material.absorption[5] = f.absorption;
    material.scattering[5] = f.scattering;
    material.absorption[6] = g.absorption;
    material.scattering[6] = g.scattering;
    material.absorption[7] = h.absorption;
    material.scattering[7] = h.scattering;
    return lq_stack_prepare(material);
}

#define lq_packed_layer(rows, first, n)                                                          \
    LqPackedLayer(rows[(first) + 3u + 3u * n], rows[(first) + 4u + 3u * n],                      \
                  rows[(first) + 5u + 3u * n])

// The surface whose rows begin at `rows[first]`. A macro, because the kernels read a storage buffer
// and the viewer a uniform block, and neither can be passed to a function.
#define lq_model_unpack(rows, first)                                                             \
    lq_stack_unpack(rows[first], rows[(first) + 1u], rows[(first) + 2u],                         \
                    lq_packed_layer(rows, first, 0u), lq_packed_layer(rows, first, 1u),          \
                    lq_packed_layer(rows, first, 2u), lq_packed_layer(rows, first, 3u),          \
                    lq_packed_layer(rows, first, 4u), lq_packed_layer(rows, first, 5u),          \
                    lq_packed_layer(rows, first, 6u), lq_packed_layer(rows, first, 7u))

#endif
