// What the picture of a sphere reads: the surface, its lights and the size of the picture.
#ifndef LQ_VIEWER_VIEW_GLSL
#define LQ_VIEWER_VIEW_GLSL

const uint LQ_VIEW_MAX_LIGHTS = 4u;
const uint LQ_VIEW_MAX_ROWS = 59u;

// `surface` begins with the rows of a packed surface. Light i < `light_count` shines from the unit
// direction light_directions[i].xyz with the irradiance light_irradiances[i].xyz across its beam.
// `background` is a display colour with premultiplied alpha. Lengths are in radii of the sphere:
// `half_extent` from the centre of the picture to its edges, `pixel` the width of a pixel.
layout(set = 0, binding = 0, std140) uniform LqSphereView {
    vec4 surface[LQ_VIEW_MAX_ROWS];
    vec4 light_directions[LQ_VIEW_MAX_LIGHTS];
    vec4 light_irradiances[LQ_VIEW_MAX_LIGHTS];
    vec4 background;
    vec2 half_extent;
    float pixel;
    uint light_count;
} view;

// Row `index` of the packed surface.
vec4 lq_packed_row(const uint index) {
    return view.surface[index];
}

#endif
