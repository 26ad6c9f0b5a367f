// T01, the light that enters a rough dielectric interface and crosses the medium below, from its
// compressed table; and the energies that follow from it.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           section 4 (the compression), Eq. 3 (the energies)
//
//   T01(cos_theta, alpha, eta, tau) =
//       sum over k, m of maps_km(alpha, eta) absorption_k(tau) profile_m(s(cos_theta, eta))
//
// The functions of tau k = 0 to 4 are multiplied with the first 12, 12, 10, 8 and 6 profiles. One
// colour channel each in the components of a vec3.
#ifndef LQ_INTERFACE_TRANSMISSION_GLSL
#define LQ_INTERFACE_TRANSMISSION_GLSL

#include "../tables/interpolate.glsl"
#include "profile.glsl"

// T01 over directions at one interface and medium: the weights of the twelve profiles, by fours
// per channel.
struct LqTransmission {
    float eta;
    mat3x4 first;   // profiles 0 to 3: column = channel
    mat3x4 second;  // 4 to 7
    mat3x4 third;   // 8 to 11
};
