// Baking: the low-noise walks agree with the simulator, and a bake ends with the same bytes however
// it is interrupted or shared.
#include "bake/bake.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "bake/dielectric.h"
#include "bake/mirror.h"
#include "core/file.h"
#include "core/process.h"
#include "simulator/interface.h"
#include "simulator/microsurface.h"
#include "support/normal.h"
#include "support/temporary_folder.h"

namespace lacquer::bake {

namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = LACQUER_PROGRAM;
constexpr double kSignificance = 0.01;

// A bake of a second or so: long enough to be killed half way.
const std::vector<std::string> kBake{"bake", "--table", "r_up", "--samples", "2048", "--seed", "7"};

std::vector<std::string> bake_into(const fs::path& folder) {
    std::vector<std::string> arguments = kBake;
    arguments.insert(arguments.end(), {"-o", folder.string()});
    return arguments;
}

std::string baked_bytes(const fs::path& folder) {
    const ProcessResult result = run_process(kProgram, bake_into(folder));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_file(folder / "r_up.bin");
}

pid_t start(const std::vector<std::string>& arguments) {
    std::vector<char*> argv{const_cast<char*>(kProgram)};
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::execv(kProgram, argv.data());
        ::_exit(127);
    }
    return child;
}

std::uintmax_t size_of(const fs::path& file) {
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(file, missing);
    return missing ? 0 : size;
}

}  // namespace

TEST(Bake, WalksAgreeWithTheSimulator) {
    // The mean of independent low-noise estimates against the simulator's, at fixed seeds: a z test
    // with the spread of both.
    struct Point {
        double cosine, alpha, eta, tau;
    };
    const std::vector<Point> points{{0.3, 0.3, 0.6, 1.0},  {0.9, 0.1, 0.8, 0.5},
                                    {0.4, 0.8, 0.92, 0.9}, {0.1, 0.9, 1.5, 1.0},
                                    {0.7, 0.2, 2.3, 0.7},  {0.5, 1.0, 3.0, 0.3}};
    constexpr int kRepeats = 16;
    const double limit =
        test::two_sided_z(kSignificance / (3.0 * static_cast<double>(points.size())));
    const SobolPoints sobol{1 << 10};
    for (const Point& point : points) {
        simulator::RunOptions options;
        options.samples = 200'000;
        const auto truth = simulator::estimate_interface(
            {Ndf::ggx, point.alpha, point.alpha}, point.eta, point.tau, point.cosine, options);
        simulator::Moments entering, leaving, reflected;
        for (int n = 0; n < kRepeats; ++n) {
            const std::uint64_t seed = mix_bits(static_cast<std::uint64_t>(n) + 1);
            entering.add(light_entering(point.cosine, point.alpha, point.eta, sobol, seed)
                             .transmitted(point.tau));
            const DiffuseExits exits = light_leaving(point.alpha, point.eta, sobol, seed);
            leaving.add(exits.left.transmitted(point.tau));
            reflected.add(exits.reflected.transmitted(point.tau, 2.0));
        }
        const auto expect_equal = [&](const simulator::Moments& mine,
                                      const simulator::Estimate& theirs) {
            const double error = std::hypot(mine.standard_error(kRepeats), theirs.standard_error);
            // The histogram of cosines shifts a transmittance by less than this.
            constexpr double kHistogram = 1e-4;
            EXPECT_NEAR(mine.mean(kRepeats), theirs.mean, limit * error + kHistogram)
                << point.cosine << " " << point.alpha << " " << point.eta << " " << point.tau;
        };
        expect_equal(entering, truth.t_down);
        expect_equal(leaving, truth.t_up);
        expect_equal(reflected, truth.r_up);
    }
}

TEST(Bake, LosslessConductorsReflectEverything) {
    const FresnelCurves white{1, [](std::size_t, double) { return 1.0; }};
    const SobolPoints points{1 << 12};
    // What is left to chance is less light than ends a walk, 0.02, over 64 walks' worth of spread.
    constexpr double kRoulette = 0.02 / 64.0;
    for (const double alpha : {0.1, 0.5, 1.0})
        EXPECT_NEAR(reflected_by_facets(0.6, alpha, white, points, 5).front(), 1.0, kRoulette);
}

TEST(Bake, AKilledBakeResumesToTheSameBytes) {
    const test::TemporaryFolder whole, killed;
    const std::string expected = baked_bytes(whole.path());

    // Killed in the second of its two grids: the first is not simulated again.
    const fs::path checkpoint = killed / "r_up_dense.checkpoint-1-of-1";
    const pid_t child = start(bake_into(killed.path()));
    constexpr std::uintmax_t kSomeNodes = 20'000;
    while (size_of(checkpoint) < kSomeNodes && ::waitpid(child, nullptr, WNOHANG) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds{2});
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ASSERT_GE(size_of(checkpoint), kSomeNodes) << "the bake ended before it could be killed";
    ASSERT_TRUE(fs::exists(killed / "r_up_thin.checkpoint-1-of-1"));
    ASSERT_FALSE(fs::exists(killed / "r_up.bin"));

    std::vector<std::string> arguments = bake_into(killed.path());
    arguments.push_back("--resume");
    const ProcessResult result = run_process(kProgram, arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(read_file(killed / "r_up.bin"), expected);
    EXPECT_EQ(killed.entries(), (std::vector<std::string>{"r_up.bin", "r_up.exr"}));
}

TEST(Bake, TwoProcessesMakeTheSameBytes) {
    const ProcessResult found = run_process("/bin/sh", {"-c", "command -v mpirun"});
    if (found.exit_code != 0) GTEST_SKIP() << "mpirun is not installed";
    const test::TemporaryFolder one, two;
    std::vector<std::string> arguments{
        "-c", "exec mpirun --allow-run-as-root --oversubscribe -n 2 \"$@\"", "sh", kProgram};
    for (const std::string& argument : bake_into(two.path())) arguments.push_back(argument);
    const ProcessResult result = run_process("/bin/sh", arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("2 processes"), std::string::npos) << result.err;
    EXPECT_EQ(read_file(two / "r_up.bin"), baked_bytes(one.path()));
}

TEST(Bake, AFullDiskLeavesTheGoodTable) {
    const test::TemporaryFolder folder;
    baked_bytes(folder.path());
    const std::string good = read_file(folder / "r_up.bin");
    // A limit on the size of files stands for a full disk: the first checkpoint exceeds it.
    std::vector<std::string> arguments{"-c", "ulimit -f 8; trap '' XFSZ; exec \"$@\"", "sh",
                                       kProgram};
    for (const std::string& argument : bake_into(folder.path())) arguments.push_back(argument);
    const ProcessResult result = run_process("/bin/sh", arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("r_up_thin.checkpoint"), std::string::npos) << result.err;
    EXPECT_EQ(read_file(folder / "r_up.bin"), good);
}

TEST(Bake, AFolderThatCannotBeMadeIsAnError) {
    const ProcessResult result = run_process(kProgram, bake_into("/proc/nowhere"));
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("/proc/nowhere"), std::string::npos) << result.err;
}

TEST(Bake, OptionsThatMakeNoSenseTogetherAreRefused) {
    const std::vector<std::vector<std::string>> senseless{
        {"bake", "--coarse"},
        {"bake", "--seed", "-1", "-o", "/proc/nowhere"},
        {"bake", "--table", "mirror", "--report", "r", "-o", "/proc/nowhere"},
        {"bake", "--device", "x", "-o", "/proc/nowhere"}};
    for (const std::vector<std::string>& arguments : senseless)
        EXPECT_EQ(run_process(kProgram, arguments).exit_code, 2) << arguments[1];
}

TEST(Bake, ACoarseBakeIsComplete) {
    const test::TemporaryFolder folder;
    const ProcessResult result =
        run_process(kProgram, {"bake", "--coarse", "--report", (folder / "report").string(), "-o",
                               (folder / "tables").string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const EnergyTables tables{folder / "tables"};
    // 128 walks per node: no more than an impression.
    EXPECT_NEAR(tables.t_down(0.8, 0.2, 1.5, 1.0), 0.95, 0.05);
    EXPECT_NE(result.out.find("| T01 |"), std::string::npos) << result.out;
    EXPECT_NE(read_file(folder / "report" / "tables.html").find("<svg"), std::string::npos);
}

}  // namespace lacquer::bake
