#include "markup/plot.h"

#include <gmock/gmock.h>

namespace lacquer {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Plot, EscapesWhatItIsGiven) {
    const std::string svg = svg_of({"eta < 1 & \"thin\"", "x", "y", 0, 1, 0, 1, {{"a < b"}}});
    EXPECT_THAT(svg, HasSubstr("eta &lt; 1 &amp; &quot;thin&quot;"));
    EXPECT_THAT(svg, HasSubstr("a &lt; b"));
}

TEST(Plot, LogarithmicAxesHaveTicksAtRoundNumbers) {
    Plot plot{"", "x", "y", 1e-3, 1.0, 0, 1, {}};
    plot.x_logarithmic = true;
    const std::string svg = svg_of(plot);
    for (const char* tick : {">0.001<", ">0.01<", ">0.1<", ">1<"})
        EXPECT_THAT(svg, HasSubstr(tick));
    EXPECT_THAT(svg, Not(HasSubstr(">0.02<")));
}

TEST(Plot, LogarithmicPlacesHalveTheFrameAtTheGeometricMean) {
    Plot plot{"", "x", "y", 0.01, 1.0, 0, 1, {{"", {0.1, 0.505}, {0.5, 0.5}}}};
    Plot logarithmic = plot;
    logarithmic.x_logarithmic = true;
    const auto start_of = [](const std::string& svg, const char* mark) {
        return std::stod(svg.substr(svg.find(mark, svg.find("class=\"curve\"")) + 1));
    };
    // The first point of the one is where the second of the other is: in the middle.
    EXPECT_NEAR(start_of(svg_of(logarithmic), "M"), start_of(svg_of(plot), "L"), 0.11);
}

}  // namespace
}  // namespace lacquer
