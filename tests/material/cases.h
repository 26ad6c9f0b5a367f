// Material files, right and wrong, with what the loader must say about each. Shared by the loader's
// tests and by the program whose verdicts are compared with the JSON Schema.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace lacquer::test {

struct MaterialCase {
    std::string name;
    std::string text;
    std::vector<std::string> message_parts;  // all in the error; empty where the file is right
    bool schema_sees = true;                 // whether a JSON Schema can express what is wrong

    friend std::ostream& operator<<(std::ostream& out, const MaterialCase& entry) {
        return out << entry.name;
    }
};

inline const std::string kOrigin = "folder/case.json";

inline std::vector<MaterialCase> right_cases() {
    return {
        {"lambertian_alone", R"({"base": {"lambertian": {"albedo": [0, 0.5, 1]}}})", {}},
        {"named",
         R"({"$schema": "x", "name": "n", "comment": "c", "exterior_ior": 1.33, "layers": [],
            "base": {"comment": "c", "lambertian": {"comment": "c", "albedo": [1, 1, 1]}}})",
         {}},
        {"glass", R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0}}], "base": "none"})", {}},
        {"celadon",
         R"({"exterior_ior": 1.0, "layers": [{
            "interface": {"ior": 1.5, "alpha": 0.12, "ndf": "ggx"},
            "medium": {"tau": [0.70, 0.90, 0.80]}}],
            "base": {"lambertian": {"albedo": [0.8, 0.8, 0.75]}}})",
         {}},
        {"scattering",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": [0.1, 0.4]}, "medium":
            {"sigma_a": [0, 1, 2], "sigma_s": [1, 1, 1e9], "g": -0.99, "thickness": 0}}],
            "base": "none"})",
         {}},
        {"absorbing_coefficients",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0.1},
            "medium": {"sigma_a": [0, 1, 2]}}], "base": "none"})",
         {}},
        {"metal",
         R"({"base": {"conductor": {"metal": "gold", "alpha": 1, "ndf": "beckmann"}}})",
         {}},
        {"index",
         R"({"base": {"conductor": {"eta": [0, 5, 1], "kappa": [0, 10, 1], "alpha": 1}}})",
         {}},
        {"diffuse_facets",
         R"({"base": {"diffuse_facets": {"albedo": [0, 0, 0], "alpha": 0.5}}})",
         {}},
        {"blended_interface",
         R"({"layers": [{"interface": {"ior": 1.5, "ndf": "beckmann", "blend": {
            "operator": "asymmetric", "strata": [{"weight": 0.5, "alpha": 0.02},
            {"weight": 0.25, "alpha": [0.1, 0.2], "ndf": "ggx"}, {"alpha": 0.8}]}}}],
            "base": "none"})",
         {}},
        {"blended_metals",
         R"({"base": {"conductor": {"blend": {"operator": "symmetric", "strata": [
            {"weight": 0.5, "alpha": 0.02, "metal": "gold"},
            {"alpha": 0.8, "eta": [1, 1, 1], "kappa": [2, 2, 2]}]}}}})",
         {}},
        {"blended_facets",
         R"({"base": {"diffuse_facets": {"albedo": [1, 1, 1], "blend": {
            "operator": "symmetric", "strata": [{"weight": 0.5, "alpha": 0.02, "albedo": [0, 0, 0]},
            {"alpha": 0.8}]}}}})",
         {}},
        {"eight_layers",
         [] {
             std::string text = R"({"base": "none", "layers": [)";
             for (int i = 0; i < 8; ++i)
                 text += std::string(i == 0 ? "" : ",") +
                         R"({"interface": {"ior": 1.5, "alpha": 0.1}})";
             return text + "]}";
         }(),
         {}},
        {"ratio_at_its_ends",
         R"({"exterior_ior": 0.9, "layers": [
            {"interface": {"ior": 0.3, "alpha": 0.1}}, {"interface": {"ior": 0.9, "alpha": 0.1}}],
            "base": "none"})",
         {}},
        {"textures",
         R"({"exterior_ior": {"texture": "ior.exr", "channel": "a"}, "layers": [
            {"interface": {"ior": 3.5, "alpha": [{"texture": "rough.exr"}, 0.1]}}],
            "base": {"lambertian": {"albedo": {"texture": "wood.png"}}}})",
         {}},
    };
}

inline std::vector<MaterialCase> wrong_values() {
    return {
        {"alpha_out_of_range",
         "{\n\"layers\": [{\"interface\": {\"ior\": 1.5,\n\"alpha\": 1.5}}],\n"
         "\"base\": \"none\"}",
         {"folder/case.json:3: /layers/0/interface/alpha: 1.5 is outside [0, 1]"}},
        {"alpha_negative",
         R"({"base": {"conductor": {"metal": "gold", "alpha": -0.1}}})",
         {":1: /base/conductor/alpha: -0.1 is outside [0, 1]"}},
        {"alpha_of_an_axis",
         "{\"base\": {\"conductor\": {\"metal\": \"gold\", \"alpha\": [0.1,\n2]}}}",
         {":2: /base/conductor/alpha/1: 2 is outside [0, 1]"}},
        {"alpha_of_three",
         R"({"base": {"conductor": {"metal": "gold", "alpha": [0.1, 0.1, 0.1]}}})",
         {"/base/conductor/alpha: expected a number or [alpha_x, alpha_y], found an array of 3"}},
        {"ior_low",
         R"({"layers": [{"interface": {"ior": 0.2, "alpha": 0}}], "base": "none"})",
         {"/layers/0/interface/ior: 0.2 is outside [0.3, 4]"}},
        {"ior_high",
         R"({"exterior_ior": 4.5, "base": {"lambertian": {"albedo": [0, 0, 0]}}})",
         {"/exterior_ior: 4.5 is outside [0.3, 4]"}},
        {"ratio_to_exterior",
         R"({"layers": [{"interface": {"ior": 3.5, "alpha": 0}}], "base": "none"})",
         {"/layers/0/interface/ior: 3.5 below 1 is a ratio of 3.5, which is outside [0.333333, 3]"},
         false},
        {"ratio_between_layers",
         "{\"layers\": [{\"interface\": {\"ior\": 2, \"alpha\": 0}},\n"
         "{\"interface\": {\"ior\": 0.5, \"alpha\": 0}}], \"base\": \"none\"}",
         {":2: /layers/1/interface/ior: 0.5 below 2 is a ratio of 0.25"},
         false},
        {"tau",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0}, "medium": {"tau": [0, 1.1, 0]}}],
            "base": "none"})",
         {"/layers/0/medium/tau/1: 1.1 is outside [0, 1]"}},
        {"sigma",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0}, "medium":
            {"sigma_s": [0, -1, 0]}}], "base": "none"})",
         {"/layers/0/medium/sigma_s/1: -1 is outside [0, 1e+09]"}},
        {"anisotropy",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0}, "medium":
            {"sigma_s": [0, 1, 0], "g": 1}}], "base": "none"})",
         {"/layers/0/medium/g: 1 is outside [-0.99, 0.99]"}},
        {"thickness",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0}, "medium":
            {"sigma_s": [0, 1, 0], "thickness": -1}}], "base": "none"})",
         {"/layers/0/medium/thickness: -1 is outside [0, 1e+09]"}},
        {"albedo",
         R"({"base": {"lambertian": {"albedo": [0, 0, 1.001]}}})",
         {"/base/lambertian/albedo/2: 1.001 is outside [0, 1]"}},
        {"albedo_of_two",
         R"({"base": {"lambertian": {"albedo": [0, 0]}}})",
         {"/base/lambertian/albedo: expected an array of 3 numbers (red, green, blue), found an "
          "array of 2"}},
        {"albedo_a_number",
         R"({"base": {"lambertian": {"albedo": 0.5}}})",
         {"expected an array of 3 numbers", "found the number 0.5"}},
        {"eta",
         R"({"base": {"conductor": {"eta": [0, 6, 0], "kappa": [0, 0, 0], "alpha": 1}}})",
         {"/base/conductor/eta/1: 6 is outside [0, 5]"}},
        {"kappa",
         R"({"base": {"conductor": {"eta": [0, 0, 0], "kappa": [11, 0, 0], "alpha": 1}}})",
         {"/base/conductor/kappa/0: 11 is outside [0, 10]"}},
        {"metal",
         R"({"base": {"conductor": {"metal": "unobtainium", "alpha": 1}}})",
         {"/base/conductor/metal: the metal 'unobtainium' is not one of: gold, copper, silver"}},
        {"ndf",
         R"({"base": {"conductor": {"metal": "gold", "alpha": 1, "ndf": "bekmann"}}})",
         {"/base/conductor/ndf: 'bekmann' is not one of: ggx, beckmann; did you mean 'beckmann'?"}},
        {"base_string", R"({"base": "nothing"})", {"/base: 'nothing' is not one of: none"}},
        {"nothing_to_shade",
         R"({"layers": [], "base": "none"})",
         {"/base: \"none\" without layers leaves nothing to shade"}},
        {"channel",
         R"({"base": {"lambertian": {"albedo": {"texture": "a.exr", "channel": "x"}}}})",
         {"/base/lambertian/albedo/channel: 'x' is not one of: r, g, b, a"}},
        {"texture_name",
         R"({"base": {"lambertian": {"albedo": {"texture": ""}}}})",
         {"/base/lambertian/albedo/texture: the name of the texture's file is empty"}},
        {"texture_without_file",
         R"({"base": {"lambertian": {"albedo": {"channel": "r"}}}})",
         {"/base/lambertian/albedo: the key 'texture' is missing"}},
        {"nine_layers",
         [] {
             std::string text = R"({"base": "none", "layers": [)";
             for (int i = 0; i < 9; ++i)
                 text += std::string(i == 0 ? "" : ",") +
                         R"({"interface": {"ior": 1.5, "alpha": 0.1}})";
             return text + "]}";
         }(),
         {"/layers: 9 layers, at most 8 are allowed"}},
    };
}

inline std::vector<MaterialCase> wrong_blends() {
    const auto conductor = [](const std::string& blend) {
        return R"({"base": {"conductor": {"metal": "gold", "blend": )" + blend + "}}}";
    };
    return {
        {"weight_of_last",
         conductor(R"({"operator": "symmetric", "strata": [
            {"weight": 0.5, "alpha": 0}, {"weight": 0.5, "alpha": 1}]})"),
         {":2: /base/conductor/blend/strata/1/weight: the last stratum has no weight of its own"}},
        {"weight_missing",
         conductor(R"({"operator": "symmetric", "strata": [
            {"alpha": 0}, {"alpha": 1}]})"),
         {"/base/conductor/blend/strata/0: the key 'weight' is missing"}},
        {"weight_of_last_only",
         conductor(R"({"operator": "symmetric", "strata": [
            {"alpha": 0}, {"weight": 0.5, "alpha": 1}]})"),
         {"/base/conductor/blend/strata/1/weight: the last stratum has no weight of its own"},
         false},
        {"weight_one",
         conductor(R"({"operator": "symmetric", "strata": [
            {"weight": 1, "alpha": 0}, {"alpha": 1}]})"),
         {"/base/conductor/blend/strata/0/weight: 1 is outside (0, 1)"}},
        {"weight_zero",
         conductor(R"({"operator": "symmetric", "strata": [
            {"weight": 0, "alpha": 0}, {"alpha": 1}]})"),
         {"/base/conductor/blend/strata/0/weight: 0 is outside (0, 1)"}},
        {"weights_of_one",
         conductor(R"({"operator": "symmetric", "strata": [
            {"weight": 0.5, "alpha": 0}, {"weight": 0.75, "alpha": 0}, {"alpha": 1}]})"),
         {"/base/conductor/blend/strata: the weights sum to 1.25, which leaves nothing"},
         false},
        {"one_stratum",
         conductor(R"({"operator": "symmetric", "strata": [{"alpha": 1}]})"),
         {"/base/conductor/blend/strata: 1 strata, where a blend has at least 2"}},
        {"operator",
         conductor(R"({"operator": "asymetric", "strata": [{"weight": 0.5, "alpha": 0},
            {"alpha": 1}]})"),
         {"'asymetric' is not one of: symmetric, asymmetric; did you mean"}},
        {"operator_missing",
         conductor(R"({"strata": [{"weight": 0.5, "alpha": 0}, {"alpha": 1}]})"),
         {"/base/conductor/blend: the key 'operator' is missing"}},
        {"albedo_in_conductor",
         conductor(R"({"operator": "symmetric", "strata": [
            {"weight": 0.5, "alpha": 0, "albedo": [1, 1, 1]}, {"alpha": 1}]})"),
         {"/base/conductor/blend/strata/0/albedo: unknown key 'albedo'"}},
        {"eta_in_interface",
         R"({"layers": [{"interface": {"ior": 1.5, "blend": {"operator": "symmetric",
            "strata": [{"weight": 0.5, "alpha": 0, "eta": [1, 1, 1]}, {"alpha": 1}]}}}],
            "base": "none"})",
         {"/layers/0/interface/blend/strata/0/eta: unknown key 'eta', allowed here: weight, alpha, "
          "ndf"}},
        {"eta_in_one_stratum",
         R"({"base": {"conductor": {"kappa": [1, 1, 1], "blend": {
            "operator": "symmetric", "strata": [{"weight": 0.5, "alpha": 0, "eta": [1, 1, 1]},
            {"alpha": 1}]}}}})",
         {"/base/conductor: the key 'eta' (or 'metal' for both it and 'kappa') is missing"}},
        {"albedo_in_one_stratum",
         R"({"base": {"diffuse_facets": {"blend": {
            "operator": "symmetric", "strata": [{"weight": 0.5, "alpha": 0, "albedo": [1, 1, 1]},
            {"alpha": 1}]}}}})",
         {"/base/diffuse_facets: the key 'albedo' is missing"}},
        {"alpha_and_blend",
         R"({"base": {"conductor": {"metal": "gold", "alpha": 0.1, "blend": {
            "operator": "symmetric", "strata": [{"weight": 0.5, "alpha": 0}, {"alpha": 1}]}}}})",
         {"/base/conductor/blend: 'blend' takes the place of 'alpha'"}},
    };
}

inline std::vector<MaterialCase> wrong_shapes() {
    return {
        {"unknown_key",
         "{\"base\": {\"lambertian\":\n{\"albdeo\": [1, 1, 1]}}}",
         {":2: /base/lambertian/albdeo: unknown key 'albdeo', allowed here: albedo, comment; did "
          "you "
          "mean 'albedo'?"}},
        {"unknown_key_far_from_all",
         R"({"transparency": 1, "base": {"lambertian": {"albedo": [0, 0, 0]}}})",
         {"/transparency: unknown key 'transparency', allowed here: $schema, name, exterior_ior, "
          "layers, base, comment"}},
        {"key_with_slash", R"({"a/b~": 1, "base": "none"})", {"/a~1b~0: unknown key 'a/b~'"}},
        {"comment_not_text",
         R"({"comment": 1, "base": {"lambertian": {"albedo": [0, 0, 0]}}})",
         {"/comment: expected a string, found the number 1"}},
        {"base_missing", R"({"name": "x"})", {":1: the key 'base' is missing"}},
        {"interface_missing",
         R"({"layers": [{}], "base": "none"})",
         {"/layers/0: the key 'interface' is missing"}},
        {"alpha_missing",
         R"({"base": {"conductor": {"metal": "gold"}}})",
         {"/base/conductor: the key 'alpha' (or 'blend' in its place) is missing"}},
        {"ior_missing",
         R"({"layers": [{"interface": {"alpha": 0}}], "base": "none"})",
         {"/layers/0/interface: the key 'ior' is missing"}},
        {"kappa_missing",
         R"({"base": {"conductor": {"eta": [1, 1, 1], "alpha": 1}}})",
         {"/base/conductor: the key 'kappa'", "is missing"}},
        {"metal_and_eta",
         R"({"base": {"conductor": {"metal": "gold", "eta": [1, 1, 1], "alpha": 1}}})",
         {"/base/conductor/metal: 'metal' takes the place of 'eta' and 'kappa'"}},
        {"tau_and_sigma",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0}, "medium":
            {"tau": [1, 1, 1], "g": 0}}], "base": "none"})",
         {"/layers/0/medium/g: 'g' and 'tau' exclude each other"}},
        {"medium_of_nothing",
         R"({"layers": [{"interface": {"ior": 1.5, "alpha": 0}, "medium":
            {"g": 0}}], "base": "none"})",
         {"/layers/0/medium: one of 'tau', 'sigma_a' and 'sigma_s' is needed"}},
        {"two_bases",
         R"({"base": {"lambertian": {"albedo": [0, 0, 0]}, "conductor": {"metal": "gold",
            "alpha": 0}}})",
         {"/base: a base is one of 'lambertian', 'conductor', 'diffuse_facets', or \"none\""}},
        {"empty_base", R"({"base": {}})", {"/base: a base is one of"}},
        {"base_array", R"({"base": []})", {"/base: expected an object, found an array of 0"}},
        {"root_array", "[]", {":1: expected an object, found an array of 0"}},
        {"layers_object",
         R"({"layers": {}, "base": "none"})",
         {"/layers: expected an array, found an object"}},
        {"layer_null",
         R"({"layers": [null], "base": "none"})",
         {"/layers/0: expected an object, found null"}},
        {"number_as_text",
         R"({"exterior_ior": "1", "base": {"lambertian": {"albedo": [0, 0, 0]}}})",
         {"/exterior_ior: expected a number or a texture, found the string \"1\""}},
        {"number_as_boolean",
         R"({"base": {"lambertian": {"albedo": [true, 0, 0]}}})",
         {"/base/lambertian/albedo/0: expected a number or a texture, found true"}},
        {"name_as_number",
         R"({"name": 1, "base": {"lambertian": {"albedo": [0, 0, 0]}}})",
         {"/name: expected a string, found the number 1"}},
    };
}

// What no JSON parser may accept; repeated keys most do, though.
inline std::vector<MaterialCase> wrong_texts() {
    return {
        {"empty", "", {"folder/case.json:1:1: not valid JSON: the text is empty"}},
        {"only_spaces", " \n\t ", {"not valid JSON: the text is empty"}},
        {"nan", "{\"exterior_ior\":\n NaN}", {":2:2: not valid JSON", "invalid literal"}},
        {"infinity", "{\"exterior_ior\": -Infinity}", {":1:19: not valid JSON", "invalid number"}},
        {"overflow",
         "{\"exterior_ior\": 1e999}",
         {"not valid JSON: number overflow parsing '1e999'"}},
        {"truncated",
         "{\"base\": {\"lambertian\": {\"albedo\": [0.5,\n0.5",
         {":2:4: not valid JSON", "unexpected end of input"}},
        {"truncated_text", "{\"na", {"not valid JSON", "missing closing quote"}},
        {"trailing", "{\"base\": \"none\"} x", {":1:18: not valid JSON"}},
        {"trailing_comma", "{\"base\": \"none\",\n}", {":2:1: not valid JSON"}},
        {"comment", "// a\n{}", {":1:1: not valid JSON"}},
        {"bytes", "\xff\xfe\x01", {":1:1: not valid JSON"}},
        {"not_utf8", "{\"name\": \"\xc3\x28\"}", {"not valid JSON", "UTF-8"}},
        {"deep", std::string(100, '['), {":1:33: nested deeper than 32 levels"}, false},
        {"duplicate",
         "{\"base\": \"none\",\n\n\"name\": \"x\", \"base\": \"none\"}",
         {":3:19: the key 'base' is there already, on line 1"},
         false},
    };
}

}  // namespace lacquer::test
