// From linear radiance to what a display shows.
#ifndef LQ_LIGHTING_TONE_MAPPING_GLSL
#define LQ_LIGHTING_TONE_MAPPING_GLSL

#include "../core/math.glsl"

// Radiance in [0, infinity) to [0, 1): 1 - exp(-x) keeps hue order and never clips.
float lq_tone_curve(const float radiance) {
    return 1.0 - exp(-max(radiance, 0.0));
}

// IEC 61966-2-1 (sRGB) transfer function from linear [0, 1] to encoded [0, 1].
float lq_srgb_encode(const float value) {
    return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 0.416666666666667) - 0.055;
}

// Linear radiance to an encoded display colour.
vec3 lq_display_color(const vec3 radiance) {
    return vec3(lq_srgb_encode(lq_tone_curve(radiance.x)), lq_srgb_encode(lq_tone_curve(radiance.y)),
                lq_srgb_encode(lq_tone_curve(radiance.z)));
}

#endif
