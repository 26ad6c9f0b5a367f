// The public C++ API: materials from their files (material.h), their shading in float and double
// (bsdf.h), the models by name (model.h) and the errors all of these throw (error.h).
#pragma once

#include "core/error.h"
#include "core/model.h"
#include "lacquer/bsdf.h"
#include "lacquer/material.h"
