// What every model's `sample` and `albedo` return, and the terms on which lobes are chosen.
#ifndef LQ_CORE_SHADING_GLSL
#define LQ_CORE_SHADING_GLSL

// `wi` unit, `weight` = f cos_theta_i / pdf, `pdf` per solid angle. A sample that reflects nothing
// has weight 0; its pdf is 0 where wi points below the surface.
struct LqSample {
    vec3 wi;
    vec3 weight;
    float pdf;
};

// A lobe is sampled at least this often where it reflects anything, so that weights stay bounded.
const float LQ_MIN_CHOICE = 0.1;

// Directional albedo split by where the light turned back: at the coat or at the base; and what of
// the light goes through, where no base is.
struct LqAlbedo {
    vec3 direct;
    vec3 base;
    vec3 transmitted;
};

LqAlbedo lq_no_albedo() {
    return LqAlbedo(vec3(0.0), vec3(0.0), vec3(0.0));
}

// Of a surface that lets nothing through.
LqAlbedo lq_opaque_albedo(const vec3 direct, const vec3 base) {
    return LqAlbedo(direct, base, vec3(0.0));
}

#endif
