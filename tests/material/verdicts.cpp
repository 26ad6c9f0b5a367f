// Prints, as JSON, every material case with the loader's verdict on it, for schema_test.py.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cases.h"
#include "core/error.h"
#include "lacquer/material.h"

namespace {

using lacquer::test::MaterialCase;

std::string verdict(const std::string& text) {
    try {
        lacquer::parse_material(text, lacquer::test::kOrigin);
        return "accepted";
    } catch (const lacquer::Error& error) {
        return error.what();
    }
}

}  // namespace

int main() {
    nlohmann::json all = nlohmann::json::array();
    for (const auto& cases : {lacquer::test::right_cases(), lacquer::test::wrong_values(),
                              lacquer::test::wrong_blends(), lacquer::test::wrong_shapes(),
                              lacquer::test::wrong_texts()})
        for (const MaterialCase& entry : cases) {
            // Texts need not be UTF-8: one character per byte.
            const std::vector<int> bytes{
                reinterpret_cast<const unsigned char*>(entry.text.data()),
                reinterpret_cast<const unsigned char*>(entry.text.data()) + entry.text.size()};
            all.push_back({{"name", entry.name},
                           {"bytes", bytes},
                           {"loader", verdict(entry.text)},
                           {"schema_sees", entry.schema_sees}});
        }
    fmt::print("{}\n", all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}
