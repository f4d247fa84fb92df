// Which extensions the application, this layer and the runtime provide.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <new>
#include <string_view>
#include <vector>

#include "functions.h"

namespace glovetrack {
namespace {

constexpr const char* HANDS = XR_EXT_HAND_TRACKING_EXTENSION_NAME;
constexpr const char* SOURCES = "XR_EXT_hand_tracking_data_source";
#ifdef _WIN32
constexpr const char* TIME = XR_KHR_WIN32_CONVERT_PERFORMANCE_COUNTER_TIME_EXTENSION_NAME;
#else
constexpr const char* TIME = XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME;
#endif

using Names = std::vector<const char*>;

bool contains(const Names& names, std::string_view wanted) {
    return std::any_of(names.begin(), names.end(), [&](const char* n) { return n == wanted; });
}

// Adds the extensions that one of those below this layer reports without an instance; false if it
// does not answer.
bool add_extensions(PFN_xrGetInstanceProcAddr get, std::vector<XrExtensionProperties>& all) {
    PFN_xrVoidFunction function = nullptr;
    if (XR_FAILED(get(XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties", &function)))
        return false;
    const auto enumerate = reinterpret_cast<PFN_xrEnumerateInstanceExtensionProperties>(function);
    uint32_t count = 0;
    if (!enumerate || XR_FAILED(enumerate(nullptr, 0, &count, nullptr))) return false;
    XrExtensionProperties empty = {XR_TYPE_EXTENSION_PROPERTIES};
    std::vector<XrExtensionProperties> found(count, empty);
    if (XR_FAILED(enumerate(nullptr, count, &count, found.data()))) return false;
    all.insert(all.end(), found.begin(), found.end());
    return true;
}

// Which sets of our extensions to ask for below, the best one first. Few layers answer without an
// instance, but the end of the chain, the loader, does so for the runtime.
std::vector<Names> wanted_below(const LayerNextInfo* chain, bool sources) {
    const Names all = sources ? Names{HANDS, SOURCES, TIME} : Names{HANDS, TIME};
    std::vector<XrExtensionProperties> found;
    bool answered = false;
    for (const LayerNextInfo* below = chain; below; below = below->next)
        answered |= add_extensions(below->get_proc, found);
    if (!answered) return {all, {HANDS, TIME}, {TIME}, {HANDS}, {}};
    Names some;
    for (const char* name : all) {
        const auto is_it = [&](const auto& e) { return !std::strcmp(e.extensionName, name); };
        if (std::any_of(found.begin(), found.end(), is_it)) some.push_back(name);
    }
    return {some};
}

template <class F>
void load(const Instance& instance, const char* name, F& function) {
    PFN_xrVoidFunction found = nullptr;
    if (XR_FAILED(instance.next.get_proc(instance.handle, name, &found))) found = nullptr;
    function = reinterpret_cast<F>(found);
}

void load_all(Instance& instance) {
    Next& next = instance.next;
    load(instance, "xrDestroyInstance", next.destroy_instance);
    load(instance, "xrGetSystemProperties", next.get_system_properties);
    load(instance, "xrCreateSession", next.create_session);
    load(instance, "xrDestroySession", next.destroy_session);
    load(instance, "xrPollEvent", next.poll_event);
    load(instance, "xrCreateReferenceSpace", next.create_reference_space);
    load(instance, "xrDestroySpace", next.destroy_space);
    load(instance, "xrLocateSpace", next.locate_space);
    if (instance.runtime_hands) {
        load(instance, "xrCreateHandTrackerEXT", next.create_hand_tracker);
        load(instance, "xrDestroyHandTrackerEXT", next.destroy_hand_tracker);
        load(instance, "xrLocateHandJointsEXT", next.locate_hand_joints);
    }
#ifdef _WIN32
    load(instance, "xrConvertTimeToWin32PerformanceCounterKHR", next.convert_time);
#else
    load(instance, "xrConvertTimeToTimespecTimeKHR", next.convert_time);
#endif
}

XrResult make_instance(const XrInstanceCreateInfo* info, const LayerCreateInfo* layer,
                       XrInstance* out) {
    const LayerNextInfo& next = *layer->next_info;
    LayerCreateInfo below = *layer;
    below.next_info = next.next;
    const Names asked(info->enabledExtensionNames,
                      info->enabledExtensionNames + info->enabledExtensionCount);
    auto instance = std::make_shared<Instance>();
    instance->next.get_proc = next.get_proc;
    instance->hands = contains(asked, HANDS);
    instance->sources = contains(asked, SOURCES);
    XrResult result = XR_ERROR_EXTENSION_NOT_PRESENT;
    std::vector<Names> sets = {{}};
    if (instance->hands) sets = wanted_below(&next, instance->sources);
    for (const Names& ours : sets) {
        Names names = ours;
        for (const char* name : asked) {
            const std::string_view n = name;
            const bool answered_here = instance->hands && (n == HANDS || n == SOURCES);
            if (!answered_here && !contains(names, n)) names.push_back(name);
        }
        XrInstanceCreateInfo changed = *info;
        changed.enabledExtensionCount = static_cast<uint32_t>(names.size());
        changed.enabledExtensionNames = names.data();
        result = next.create_instance(&changed, &below, out);
        instance->runtime_hands = contains(ours, HANDS);
        instance->runtime_sources = contains(ours, SOURCES);
        if (result != XR_ERROR_EXTENSION_NOT_PRESENT) break;
    }
    if (XR_FAILED(result)) return result;
    instance->handle = *out;
    load_all(*instance);
    if (instance->hands) Memory::get().set_name(info->applicationInfo.applicationName);
    std::lock_guard<std::mutex> lock(objects().mutex);
    objects().instances[*out] = instance;
    return result;
}

}  // namespace

XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo* info, const LayerCreateInfo* layer,
                                    XrInstance* out) {
    if (!info || !layer || !layer->next_info || layer->kind != Kind::LayerCreateInfo ||
        layer->next_info->kind != Kind::LayerNextInfo)
        return XR_ERROR_INITIALIZATION_FAILED;
    try {
        return make_instance(info, layer, out);
    } catch (const std::bad_alloc&) {
        return XR_ERROR_OUT_OF_MEMORY;
    }
}

XrResult XRAPI_CALL destroy_instance(XrInstance handle) {
    const auto instance = find(objects().instances, handle);
    if (!instance) return XR_ERROR_HANDLE_INVALID;
    {
        std::lock_guard<std::mutex> lock(objects().mutex);
        erase_if(objects().trackers,
                 [&](const auto& tracker) { return tracker->session->instance == instance; });
        erase_if(objects().sessions,
                 [&](const auto& session) { return session->instance == instance; });
        objects().instances.erase(handle);
    }
    return instance->next.destroy_instance(handle);
}

XrResult XRAPI_CALL get_system_properties(XrInstance handle, XrSystemId system,
                                          XrSystemProperties* properties) {
    const auto instance = find(objects().instances, handle);
    if (!instance) return XR_ERROR_HANDLE_INVALID;
    if (!properties) return XR_ERROR_VALIDATION_FAILURE;
    constexpr XrStructureType TYPE = XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT;
    XrResult result;
    {
        const Unchained without(properties, TYPE, !instance->runtime_hands);
        result = instance->next.get_system_properties(handle, system, properties);
    }
    auto* ours = chained<XrSystemHandTrackingPropertiesEXT>(properties->next, TYPE);
    if (XR_SUCCEEDED(result) && ours) ours->supportsHandTracking = XR_TRUE;
    return result;
}

}  // namespace glovetrack
