// What every model's `sample` and `albedo` return.
#ifndef LQ_CORE_SHADING_GLSL
#define LQ_CORE_SHADING_GLSL

// `wi` unit, `weight` = f cos_theta_i / pdf, `pdf` per solid angle. A sample that reflects nothing
// has weight 0; its pdf is 0 where wi points below the surface.
struct LqSample {
    vec3 wi;
    vec3 weight;
    float pdf;
};

// Directional albedo split by where the light turned back: at the coat or at the base.
struct LqAlbedo {
    vec3 direct;
    vec3 base;
};

#endif
