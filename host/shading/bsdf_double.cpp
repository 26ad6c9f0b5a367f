// Bsdf<double>: the shader source in double behind the public interface.
#include "shading/shader_double.h"
//
#include "shading/bsdf_impl.h"
