// Table files: what is written comes back, and every kind of damage is named.
#include "tables/table_file.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/error.h"

namespace lacquer {

namespace {

Table sample_table() {
    Table table;
    table.name = "sample";
    table.quantity = "numbers of a test";
    table.samples = 12;
    table.seed = 34;
    table.arrays = {{"maps",
                     {{"alpha", Mapping::squared, 3, 0.0, 1.0, "1"},
                      {"channel", Mapping::index, 2, 0.0, 0.0, "1"}},
                     {0.0, 1.0, 0.25, -2.5, 1e-3, 60000.0}},
                    {"moments",
                     {{"eta", Mapping::log_bent, 2, 1.0, 3.0, "1"},
                      {"channel", Mapping::index, 1, 0.0, 0.0, "1"}},
                     {1.0 / 3.0, 1e-20},
                     Encoding::float32}};
    round_to_encoding(table);
    return table;
}

std::string message_of(const std::string& bytes) {
    try {
        decode_table(bytes, "t.bin");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

struct Damage {
    std::function<void(std::string&)> apply;
    std::string expected;  // part of the message
};

}  // namespace

TEST(TableFile, ReadsBackWhatWasWritten) {
    const Table table = sample_table();
    EXPECT_EQ(decode_table(encode_table(table), "t.bin"), table);
}

TEST(TableFile, HalvesKeepElevenBits) {
    const Table table = sample_table();
    constexpr double kHalfStep = 0x1p-11;  // relative, rounded to nearest
    EXPECT_NEAR(table.arrays[0].values[4], 1e-3, 1e-3 * kHalfStep);
    EXPECT_EQ(table.arrays[0].values[3], -2.5);
}

TEST(TableFile, DamageIsNamed) {
    const std::vector<Damage> damages{
        {[](std::string& bytes) { bytes.clear(); }, "does not begin"},
        {[](std::string& bytes) { bytes[0] = 'x'; }, "does not begin"},
        {[](std::string& bytes) { bytes.resize(20); }, "20 bytes"},
        {[](std::string& bytes) { bytes.resize(bytes.size() - 1); }, "are expected"},
        {[](std::string& bytes) { bytes += '\0'; }, "are expected"},
        {[](std::string& bytes) { bytes[8] = 0; }, "older"},
        {[](std::string& bytes) { bytes[8] = 9; }, "newer"},
        {[](std::string& bytes) { bytes.back() ^= 1; }, "checksum"},
        {[](std::string& bytes) { bytes[30] ^= 1; }, "checksum"},
        {[](std::string& bytes) { bytes[70] ^= 1; }, "checksum"},
    };
    for (const Damage& damage : damages) {
        std::string bytes = encode_table(sample_table());
        damage.apply(bytes);
        const std::string message = message_of(bytes);
        EXPECT_NE(message.find(damage.expected), std::string::npos) << message;
        EXPECT_NE(message.find("t.bin"), std::string::npos) << message;
    }
}

TEST(TableFile, NoPrefixIsReadAsATable) {
    const std::string bytes = encode_table(sample_table());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(decode_table(bytes.substr(0, size), "t.bin"), Error) << size;
}

TEST(TableFile, NumbersThatHalvesCannotHoldAreRefused) {
    Table table = sample_table();
    table.arrays[0].values[0] = 1e6;
    EXPECT_THROW(round_to_encoding(table), Error);
}

TEST(Axis, PositionInvertsValue) {
    for (const Mapping mapping : {Mapping::linear, Mapping::squared, Mapping::log_bent}) {
        const Axis axis{"x", mapping, 17, 1.0, 1.0 / 3.0, "1"};
        for (std::size_t node = 0; node < axis.size; ++node)
            EXPECT_NEAR(axis_position(axis, axis_value(axis, node)), static_cast<double>(node),
                        1e-7);  // a square root amplifies rounding near the first node
        EXPECT_EQ(axis_position(axis, 2.0), 0.0);
        EXPECT_EQ(axis_position(axis, 0.1), 16.0);
    }
}

TEST(Interpolate, IsExactForAFunctionLinearInEachPosition) {
    TableArray array{"f",
                     {{"x", Mapping::linear, 4, 0.0, 1.0, "1"},
                      {"y", Mapping::linear, 3, 0.0, 1.0, "1"},
                      {"channel", Mapping::index, 1, 0.0, 0.0, "1"}},
                     {}};
    const auto f = [](double x, double y) { return 1.0 + 2.0 * x - 3.0 * y + 0.5 * x * y; };
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 3; ++y) array.values.push_back(f(x, y));
    for (const double x : {0.0, 0.3, 1.0, 2.9, 3.0})
        for (const double y : {0.0, 0.7, 1.0, 2.0})
            EXPECT_NEAR(interpolate(array, std::array{x, y}).front(), f(x, y), 1e-14);
}

}  // namespace lacquer
