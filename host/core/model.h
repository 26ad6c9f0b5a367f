// The models of the library that can be asked for by name.
#pragma once

#include <span>
#include <string_view>

namespace lacquer {

enum class Model {
    plain,                // single reflections of the top interface plus the base as if bare
    clearcoat,            // glTF's: Fresnel's factor divides the light between coat and base
    weidlich_wilkie,      // light enters and leaves the coat through one facet
    openpbr_coat,         // OpenPBR's: the base made rougher, darker and attenuated by the coat
    coated_ggx,           // all light between coat and base; the base's leaves as a GGX lobe
    coated_exact,         // the same; the base's leaves as it is
    stack,                // any number of layers over any base, with all light between them
    stack_symmetric,      // the same, the same when light and viewer change places
    microsurface_single,  // one rough surface, uniform or blended: what meets one facet
    microsurface_compensated,  // the same, with what meets several facets as a diffuse lobe
};

// The name on the command line, in JSON and in file names of shader variants.
std::string_view model_name(Model model);

// The level of the shader source that implements it: the prefix of its public functions,
// lq_LEVEL_*.
std::string_view model_level(Model model);

// Whether its shaders read the baked tables.
bool reads_tables(Model model);

// Throws UsageError listing the models there are.
Model model_from_name(std::string_view name);

std::span<const Model> all_models();

}  // namespace lacquer
