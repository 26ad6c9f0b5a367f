// What the facets of a rough interface do to the mean of a lobe and to its width, apart from
// mirroring it: looked at through four of the visible normals, a component of a vector each.
// Based on: Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps;
//           Belcour 2018, Eq. 10 (the roughness that refraction adds)
#ifndef LQ_STACK_FACET_EFFECT_GLSL
#define LQ_STACK_FACET_EFFECT_GLSL

#include "../core/math.glsl"

// Nearer to grazing lobes have no width to speak of: means are kept above.
const float LQ_LEAST_COSINE = 0.014;
const float LQ_MOST_SINE = 0.9999;

// Belcour 2018, Eq. 10, says 0.167 at normal incidence and eta 1.5, where simulated light through
// facets of alpha 0.05 to 0.3 is 0.151 to 0.136 as wide as their reflections.
const float LQ_REFRACTION_WIDTH = 0.85;

const float LQ_TINY_SPREAD = 1.0e-9;

// `reflected_tilt` is how much closer to the normal light is reflected than by perfect mirrors, as a
// difference of mean cosines; `reflected_width` the ratio of the spreads; `refracted_sine` that of
// the mean of what is refracted; `crossing_sine` that of the one direction that crosses what lies
// below as all of it does: into a denser medium halfway to that of the mean cosine, which is less.
struct LqFacetEffect {
    float reflected_tilt;
    float reflected_width;
    float refracted_sine;
    float crossing_sine;
};

// 1 / length of vectors whose components these are.
vec4 lq_inverse_lengths(const vec4 x, const vec4 y, const vec4 z) {
    return vec4(1.0) / sqrt(x * x + y * y + z * z);
}

// Squares of eta cos_theta_t; below 0 beyond the critical angle.
vec4 lq_refracted_squares(const vec4 cosines, const float eta) {
    return vec4((eta - 1.0) * (eta + 1.0)) + cosines * cosines;
}

// Fresnel reflectances of a dielectric boundary (fresnel/dielectric.glsl) for four cosines, where
// eta cos_theta_t is `roots`, whose squares are by `excess` more than Snell's law says.
vec4 lq_fresnel_by_roots(const vec4 cosines, const vec4 roots, const vec4 excess,
                         const float eta) {
    const float contrast = (eta - 1.0) * (eta + 1.0);
    const vec4 denominator_s = max(cosines + roots, vec4(LQ_TINY_SPREAD));
    const vec4 denominator_p = max(eta * eta * cosines + roots, vec4(LQ_TINY_SPREAD));
    const vec4 amplitude_s = (vec4(contrast) + excess) / (denominator_s * denominator_s);
    const vec4 amplitude_p =
        (contrast * (cosines * cosines * (eta * eta + 1.0) - vec4(1.0)) - excess) /
        (denominator_p * denominator_p);
    const vec4 partial =
        min(0.5 * (amplitude_s * amplitude_s + amplitude_p * amplitude_p), vec4(1.0));
    // Beyond the critical angle all is reflected.
    return mix(partial, vec4(1.0), step(roots, vec4(0.0)));
}

vec4 lq_fresnel_of_four(const vec4 cosines, const float eta) {
    const vec4 roots = sqrt(max(lq_refracted_squares(cosines, eta), vec4(0.0)));
    return lq_fresnel_by_roots(cosines, roots, vec4(0.0), eta);
}

// The mean of sqrt(max(x, 0)) over a width of 2 h about x, without differences of like numbers.
vec4 lq_mean_roots(const vec4 x, const float h) {
    const vec4 high = sqrt(max(x + vec4(h), vec4(0.0)));
    const vec4 low = sqrt(max(x - vec4(h), vec4(0.0)));
    const vec4 shares = clamp((x + vec4(h)) / h, vec4(0.0), vec4(2.0)) / 3.0;
    return shares * (high * high + high * low + low * low) /
           max(high + low, vec4(LQ_TINY_SPREAD));
}

// What four facets do in place of all those near them, whose incident cosines they have: at the
// critical angle, where the Fresnel equations follow a square root, that root's mean. `cosines` are
// those of what is refracted to the facets' normals.
struct LqFacetRefraction {
    vec4 reflectance;
    vec4 cosines;
};

LqFacetRefraction lq_refraction_near(const vec4 incidence, const float eta) {
    const vec4 squares = lq_refracted_squares(incidence, eta);
    vec4 roots = sqrt(max(squares, vec4(0.0)));
    vec4 excess = vec4(0.0);
    if (eta < 1.0) {
        const vec4 steps = squares - vec4(0.25 * dot(squares, vec4(1.0)));
        const float h = max(sqrt(0.1875 * dot(steps, steps)), LQ_TINY_SPREAD);
        roots = lq_mean_roots(squares, h);
        excess = roots * roots - squares;
    }
    return LqFacetRefraction(lq_fresnel_by_roots(incidence, roots, excess, eta), roots / eta);
}

// G1 of GGX facets for four cosines; 0 below the surface.
vec4 lq_masking_of_four(const vec4 cosines, const float alpha) {
    const vec4 c = max(cosines, vec4(0.0));
    const vec4 sine_squared = max((vec4(1.0) - c) * (vec4(1.0) + c), vec4(0.0));
    return 2.0 * c / max(c + sqrt(c * c + alpha * alpha * sine_squared), vec4(LQ_TINY_SPREAD));
}

// Of light at `cosine` in [0, 1] on facets of roughness `alpha` and relative index `eta` = index of
// the other medium over that of the light's.
LqFacetEffect lq_facet_effect(const float cosine, const float alpha, const float eta) {
    const float inverse_eta = 1.0 / eta;
    if (alpha < LQ_MIN_ALPHA) {
        const float sine = min(lq_sine_from_cosine(cosine) * inverse_eta, LQ_MOST_SINE);
        return LqFacetEffect(0.0, 1.0, sine, sine);
    }
    const float c = max(cosine, LQ_LEAST_COSINE);
    const float s = lq_sine_from_cosine(c);
    const float straight = min(s * inverse_eta, LQ_MOST_SINE);
    // Visible normals are halfway between the stretched direction and points of a spherical cap, a
    // quarter and three quarters up and at 45 and 135 degrees; others mirror these.
    const float stretching = 1.0 / sqrt(alpha * alpha * s * s + c * c);
    const float top = c * stretching;
    const vec4 heights = vec4(0.75, 0.75, 0.25, 0.25) * (1.0 + top);
    const vec4 caps = heights - vec4(top);
    const vec4 radii =
        sqrt(max((vec4(1.0) - caps) * (vec4(1.0) + caps), vec4(0.0))) * 0.707106781186548;
    const vec4 x = alpha * (radii * vec4(1.0, -1.0, 1.0, -1.0) + vec4(alpha * s * stretching));
    const vec4 y = alpha * radii;
    const vec4 scale = lq_inverse_lengths(x, y, heights);
    const vec4 normal_x = x * scale;
    const vec4 normal_y = y * scale;
    const vec4 normal_z = heights * scale;
    const vec4 incidence = clamp(s * normal_x + c * normal_z, vec4(0.0), vec4(1.0));
    const LqFacetRefraction facet = lq_refraction_near(incidence, eta);
    const vec4 reflectance = facet.reflectance;

    // Steps from where a flat facet mirrors to: moments about it lose no digits.
    const vec4 step_x = 2.0 * incidence * normal_x;
    const vec4 step_y = 2.0 * incidence * normal_y;
    const vec4 step_z =
        2.0 * (s * normal_x * normal_z - c * (normal_x * normal_x + normal_y * normal_y));
    const vec4 mirrored = lq_masking_of_four(vec4(c) + step_z, alpha);
    const vec4 reflected = mirrored * reflectance;
    const float mirrored_share = 1.0 / max(dot(mirrored, vec4(1.0)), LQ_TINY_SPREAD);
    const float reflected_light = dot(reflected, vec4(1.0));
    const float reflected_share = 1.0 / max(reflected_light, LQ_TINY_SPREAD);
    const vec4 squares = step_x * step_x + step_y * step_y;
    const float mirrored_mean = dot(mirrored, step_x) * mirrored_share;
    const float reflected_mean = dot(reflected, step_x) * reflected_share;
    const float mirrored_spread =
        max(dot(mirrored, squares) * mirrored_share - mirrored_mean * mirrored_mean,
            LQ_TINY_SPREAD);
    const float reflected_spread =
        max(dot(reflected, squares) * reflected_share - reflected_mean * reflected_mean,
            LQ_TINY_SPREAD);

    // Refracted directions, mirrored to the side of the light.
    const vec4 along = facet.cosines - incidence * inverse_eta;
    const vec4 refracted_x = vec4(s * inverse_eta) + along * normal_x;
    const vec4 refracted_z = vec4(c * inverse_eta) + along * normal_z;
    const vec4 entering = vec4(1.0) - reflectance;
    const vec4 refracted = entering * lq_masking_of_four(refracted_z, alpha);
    const float entering_light = dot(entering, vec4(1.0));
    const float refracted_light = dot(refracted, vec4(1.0));

    LqFacetEffect effect = LqFacetEffect(0.0, 1.0, straight, straight);
    if (reflected_light > LQ_TINY_SPREAD) {
        effect.reflected_tilt =
            dot(reflected, step_z) * reflected_share - dot(mirrored, step_z) * mirrored_share;
        effect.reflected_width = clamp(sqrt(reflected_spread / mirrored_spread), 0.5, 2.0);
    }
    // What the surface shadows is scattered again, and no more oblique than if it were smooth.
    if (refracted_light > LQ_TINY_SPREAD) {
        const float shadowed = entering_light - refracted_light;
        const float sine = (dot(refracted, refracted_x) + shadowed * straight) / entering_light;
        const float mean_cosine = (dot(refracted, refracted_z) +
                                   shadowed * lq_sine_from_cosine(straight)) / entering_light;
        effect.refracted_sine = clamp(sine, 0.0, LQ_MOST_SINE);
        effect.crossing_sine = effect.refracted_sine;
        if (eta >= 1.0) {
            effect.crossing_sine =
                min(0.5 * (max(sine, 0.0) + lq_sine_from_cosine(mean_cosine)), LQ_MOST_SINE);
        }
    }
    return effect;
}

// Of refracted light: how a lobe's roughness scales (x), and the roughness that facets add (y).
// Snell's law scales the projected disk by 1 / eta, and a lobe of roughness alpha is alpha cos_theta
// wide there. Belcour 2018, Eq. 10, with cosines as magnitudes; but reflections by facets of more
// than cos_theta^2 lean far up from grazing, where light refracted by such facets stays close to it.
vec2 lq_refracted_roughness(const float cosine, const float refracted_cosine, const float alpha,
                            const float eta) {
    const float stretch = cosine / (eta * max(refracted_cosine, LQ_LEAST_COSINE));
    const float turn = min(0.5 * abs(1.0 - stretch), 1.0);
    const float added = LQ_REFRACTION_WIDTH * turn * alpha;
    const float most = refracted_cosine * refracted_cosine;
    return vec2(clamp(stretch, 0.1, 3.0), added / sqrt(1.0 + lq_square(added / most)));
}

#endif
