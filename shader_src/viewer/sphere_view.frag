// A sphere under directional lights, shaded by the model that the variant was compiled for.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "tables.glsl"
#include "view.glsl"
#include "../kernels/model.glsl"
#include "../lighting/sphere.glsl"
#include "../lighting/tone_mapping.glsl"

layout(location = 0) in vec2 view_position;
layout(location = 0) out vec4 color;

void main() {
    const float coverage = lq_sphere_coverage(view_position, view.pixel);
    if (coverage <= 0.0) {
        color = view.background;
        return;
    }
    const vec3 normal = lq_sphere_normal(lq_sphere_shading_position(view_position, view.pixel));
    const LqFrame frame = lq_sphere_frame(normal);
    const vec3 wo = lq_frame_to_local(frame, vec3(0.0, 0.0, 1.0));
    const LqModelSurface surface = lq_model_unpack(0u);
    const LqModelView viewer = lq_model_view(surface, wo);
    vec3 radiance = vec3(0.0);
    for (uint light = 0u; light < min(view.light_count, LQ_VIEW_MAX_LIGHTS); light++) {
        const vec4 direction = view.light_directions[light];
        const vec4 irradiance = view.light_irradiances[light];
        const vec3 wi = lq_frame_to_local(frame, vec3(direction.x, direction.y, direction.z));
        radiance += vec3(irradiance.x, irradiance.y, irradiance.z) *
                    lq_model_view_eval_cos(surface, viewer, wi);
    }
    color = mix(view.background, vec4(lq_display_color(radiance), 1.0), coverage);
}
