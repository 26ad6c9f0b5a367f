#include "vulkan/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "core/error.h"
#include "vulkan/driver.h"

namespace lacquer::vulkan {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL collect_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                               VkDebugUtilsMessageTypeFlagsEXT,
                                               const VkDebugUtilsMessengerCallbackDataEXT* data,
                                               void* log) {
    static_cast<ValidationLog*>(log)->add(data->pMessage);
    return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messenger_info(ValidationLog& log) {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    return {{},
            Severity::eError | Severity::eWarning,
            Type::eValidation | Type::ePerformance,
            collect_message,
            &log};
}

void require_validation_layer(const vk::raii::Context& context) {
    for (const vk::LayerProperties& layer : context.enumerateInstanceLayerProperties())
        if (std::string_view{layer.layerName} == kValidationLayer) return;
    throw Unavailable{"the Vulkan validation layers are not installed",
                      "apt-get install vulkan-validationlayers"};
}

vk::raii::Context load_vulkan() {
    try {
        return vk::raii::Context{};
    } catch (const std::runtime_error&) {
        throw Unavailable{"the Vulkan loader libvulkan.so.1 cannot be loaded",
                          "apt-get install libvulkan1"};
    }
}

// Why the loader has no driver that works, and what to do.
Unavailable no_driver(std::string_view failure) {
    if (const auto choice = users_driver_choice())
        return {fmt::format("{} ({})", failure, *choice),
                fmt::format("correct or unset {}", choice->substr(0, choice->find('=')))};
    return {std::string{failure}, "apt-get install mesa-vulkan-drivers"};
}

bool matches(const std::string& wanted, std::size_t index, const std::string& name) {
    std::size_t number = 0;
    const char* end = wanted.data() + wanted.size();
    const auto parsed = std::from_chars(wanted.data(), end, number);
    if (parsed.ec == std::errc{} && parsed.ptr == end) return number == index;
    const auto equal = [](unsigned char a, unsigned char b) {
        return std::tolower(a) == std::tolower(b);
    };
    return std::ranges::search(name, wanted, equal).begin() != name.end();
}

}  // namespace

Instance create_instance(const DeviceOptions& options, std::vector<const char*> extensions,
                         const std::shared_ptr<ValidationLog>& log) {
    ensure_runtime_folder();
    ScopedEnvironment environment;
    if (options.device.empty())
        show_default_driver(environment);
    else
        show_all_drivers(environment);

    Instance instance{load_vulkan()};
    const vk::ApplicationInfo application{"lacquer", 0, "lacquer", 0, VK_API_VERSION_1_1};
    vk::InstanceCreateInfo info{{}, &application};
    const vk::ValidationFeatureEnableEXT hazards =
        vk::ValidationFeatureEnableEXT::eSynchronizationValidation;
    vk::ValidationFeaturesEXT features{hazards};
    vk::DebugUtilsMessengerCreateInfoEXT messenger = messenger_info(*log);
    if (options.validation) {
        require_validation_layer(instance.context);
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
        info.setPEnabledLayerNames(kValidationLayer);
        info.setPNext(&features);
        features.setPNext(&messenger);  // for what is said while the instance comes and goes
    }
    info.setPEnabledExtensionNames(extensions);
    try {
        instance.handle = {instance.context, info};
        if (options.validation) instance.messenger = {instance.handle, messenger};
    } catch (const vk::IncompatibleDriverError&) {
        throw no_driver("no Vulkan driver found");
    } catch (const vk::SystemError& error) {
        throw no_driver(fmt::format("Vulkan does not start: {}", error.what()));
    }
    return instance;
}

vk::raii::PhysicalDevice choose_device(const vk::raii::Instance& instance,
                                       const std::string& wanted, const Refusal& refusal) {
    std::string found;
    std::size_t index = 0;
    const auto devices = instance.enumeratePhysicalDevices();
    for (const vk::raii::PhysicalDevice& device : devices) {
        const std::string name = device.getProperties().deviceName;
        const auto reason = refusal(device);
        if (!reason && (wanted.empty() || matches(wanted, index, name))) return device;
        found += fmt::format("{}{}: {}", index == 0 ? "" : ", ", index, name);
        if (reason) found += fmt::format(" ({})", *reason);
        ++index;
    }
    if (devices.empty()) throw no_driver("no Vulkan driver found");
    if (wanted.empty())
        throw Unavailable{fmt::format("no Vulkan device serves; found {}", found),
                          "apt-get install mesa-vulkan-drivers"};
    throw Unavailable{fmt::format("no Vulkan device is called '{}'", wanted),
                      fmt::format("choose one of {}", found)};
}

std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device,
                                               vk::QueueFlags flags) {
    const auto families = device.getQueueFamilyProperties();
    for (std::uint32_t index = 0; index < families.size(); ++index)
        if ((families[index].queueFlags & flags) == flags) return index;
    return std::nullopt;
}

}  // namespace lacquer::vulkan
