// Vulkan itself: what the validation layers say of our use of it, and the choice of devices.
#include <gmock/gmock.h>

#include <cstdlib>
#include <cstring>

#include "backends/jobs.h"
#include "backends/shader_store.h"
#include "core/environment.h"
#include "core/error.h"
#include "vulkan/compute.h"

namespace lacquer::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

class ValidatedBackend : public ::testing::TestWithParam<const char*> {};

TEST_P(ValidatedBackend, DrawsNoMessageFromTheValidationLayers) {
    std::string skipped;
    const auto backend = create_or_explain(GetParam(), skipped, {"", true});
    if (!backend) GTEST_SKIP() << skipped;
    for (const Kernel kernel : kAllKernels)
        // Twice, of growing size, because buffers are kept.
        for (const std::uint64_t queries_per_material : {7, 1000})
            backend->run(
                make_job(kernel, shadeable(test_materials(), Model::plain), queries_per_material)
                    .job());
}

INSTANTIATE_TEST_SUITE_P(Every, ValidatedBackend, ::testing::Values("vulkan", "hlsl"));

std::vector<std::uint32_t> words_of(const std::string& bytes) {
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

class VulkanDevice : public ::testing::Test {
 protected:
    void SetUp() override {
        std::string skipped;
        if (!create_or_explain("vulkan", skipped, {"", true})) GTEST_SKIP() << skipped;
    }
};

TEST_F(VulkanDevice, LeavesNothingBehindThatTheValidationLayersMiss) {
    std::shared_ptr<vulkan::ValidationLog> log;
    {
        vulkan::Device device{{"", true}};
        log = device.validation_log();
        const ShaderSource source = load_shader("spirv", Model::plain, Kernel::eval);
        using Kind = BufferArgument::Kind;
        const vulkan::Kernel kernel =
            device.compile(words_of(source.contents), "main",
                           {Kind::uniform, Kind::read, Kind::read, Kind::write});
    }
    EXPECT_THAT(log->take(), IsEmpty());
}

TEST_F(VulkanDevice, TurnsValidationMessagesIntoErrors) {
    vulkan::Device device{{"", true}};
    const ShaderSource source = load_shader("spirv", Model::plain, Kernel::eval);
    // The kernel's bindings 1 to 3 are missing from the layout.
    EXPECT_THAT(
        [&] { device.compile(words_of(source.contents), "main", {BufferArgument::Kind::uniform}); },
        ThrowsMessage<Error>(HasSubstr("Vulkan validation: ")));
}

TEST_F(VulkanDevice, IsChosenByIndexOrPartOfItsName) {
    const std::string name = vulkan::Device{{"0", false}}.name();
    EXPECT_EQ(vulkan::Device({name.substr(1, 4), false}).name(), name);
}

TEST_F(VulkanDevice, ListsThoseThereAreWhereNoneIsCalledSo) {
    const std::string name = vulkan::Device{{"0", false}}.name();
    EXPECT_THAT(
        [] {
            vulkan::Device({"Voodoo", false});
        },
        ThrowsMessage<Unavailable>(AllOf(HasSubstr("'Voodoo'"), HasSubstr("0: " + name))));
    EXPECT_THAT(
        [] {
            vulkan::Device({"99", false});
        },
        ThrowsMessage<Unavailable>(HasSubstr("'99'")));
}

TEST_F(VulkanDevice, LeavesTheEnvironmentAsItWas) {
    ScopedEnvironment environment;
    environment.unset("VK_ICD_FILENAMES");
    environment.set("VK_DRIVER_FILES", "");  // the loader would find nothing
    const vulkan::Device device{{}};
    EXPECT_EQ(std::getenv("VK_ICD_FILENAMES"), nullptr);
    EXPECT_STREQ(std::getenv("VK_DRIVER_FILES"), "");
}

}  // namespace
}  // namespace lacquer::test
