#include "material/optical_constants.h"

#include <algorithm>
#include <vector>

#include "material/optical_constants_text.h"
#include "material/place.h"

namespace lacquer {

namespace {

std::vector<OpticalConstants> read_table() {
    ReadContext context{"optical_constants.json", {}, {}};
    const JsonValue document = parse_json(kOpticalConstantsText, context.origin);
    const Place root{context, document, ""};
    root.expect_object({"metals"});
    std::vector<OpticalConstants> table;
    for (const Place& metal : root.member("metals").elements()) {
        metal.expect_object({"name", "eta", "kappa", "source"});
        table.push_back({metal.member("name").string(), metal.member("eta").rgb(kConductorEtaRange),
                         metal.member("kappa").rgb(kConductorKappaRange)});
    }
    return table;
}

}  // namespace

std::span<const OpticalConstants> all_optical_constants() {
    static const std::vector<OpticalConstants> table = read_table();
    return table;
}

const OpticalConstants* find_optical_constants(std::string_view metal) {
    const auto table = all_optical_constants();
    const auto found = std::ranges::find(table, metal, &OpticalConstants::metal);
    return found == table.end() ? nullptr : &*found;
}

}  // namespace lacquer
