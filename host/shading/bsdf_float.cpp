// Bsdf<float>: the shader source in float behind the public interface.
#include "shading/shader_float.h"
//
#include "shading/bsdf_impl.h"
