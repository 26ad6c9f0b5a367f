#include "core/table.h"

#include <gtest/gtest.h>

namespace lacquer {
namespace {

TEST(FormatTable, AlignsColumnsAndLeavesNoSpacesAtLineEnds) {
    EXPECT_EQ(format_table({{"name"}, {"value", Align::right}, {"note"}},
                           {{"a", "1", ""}, {"longer", "10.5", "x"}}),
              "name    value  note\n"
              "a           1\n"
              "longer   10.5  x\n");
}

TEST(FormatTable, CountsCodePointsNotBytes) {
    EXPECT_EQ(format_table({{"a"}, {"b"}}, {{"π", "x"}, {"ab", "y"}}), "a   b\nπ   x\nab  y\n");
}

}  // namespace
}  // namespace lacquer
