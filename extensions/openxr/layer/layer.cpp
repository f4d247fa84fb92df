// The API layer XR_APILAYER_GLOVETRACK_hands: XR_EXT_hand_tracking and
// XR_EXT_hand_tracking_data_source from the hands of a running Glovetrack, on top of any runtime.
//
// Without that program, and for a hand that it does not send, the runtime's own hand tracking
// answers if it has any.
// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <map>
#include <string_view>

#include "functions.h"

namespace glovetrack {

Objects& objects() {
    static Objects* all = new Objects;  // stays until the process ends
    return *all;
}

namespace {

constexpr const char* LAYER_NAME = "XR_APILAYER_GLOVETRACK_hands";

PFN_xrVoidFunction own(std::string_view name) {
    static const std::map<std::string_view, PFN_xrVoidFunction> functions = {
        {"xrDestroyInstance", reinterpret_cast<PFN_xrVoidFunction>(destroy_instance)},
        {"xrGetSystemProperties", reinterpret_cast<PFN_xrVoidFunction>(get_system_properties)},
        {"xrCreateSession", reinterpret_cast<PFN_xrVoidFunction>(create_session)},
        {"xrDestroySession", reinterpret_cast<PFN_xrVoidFunction>(destroy_session)},
        {"xrPollEvent", reinterpret_cast<PFN_xrVoidFunction>(poll_event)},
        {"xrCreateReferenceSpace", reinterpret_cast<PFN_xrVoidFunction>(create_reference_space)},
        {"xrDestroySpace", reinterpret_cast<PFN_xrVoidFunction>(destroy_space)},
        {"xrCreateHandTrackerEXT", reinterpret_cast<PFN_xrVoidFunction>(create_hand_tracker)},
        {"xrDestroyHandTrackerEXT", reinterpret_cast<PFN_xrVoidFunction>(destroy_hand_tracker)},
        {"xrLocateHandJointsEXT", reinterpret_cast<PFN_xrVoidFunction>(locate_hand_joints)},
    };
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

XrResult XRAPI_CALL get_proc(XrInstance handle, const char* name, PFN_xrVoidFunction* function) {
    const auto instance = find(objects().instances, handle);
    if (!instance) return XR_ERROR_HANDLE_INVALID;
    if (!std::strcmp(name, "xrGetInstanceProcAddr")) {
        *function = reinterpret_cast<PFN_xrVoidFunction>(get_proc);
        return XR_SUCCESS;
    }
    const bool always = !std::strcmp(name, "xrDestroyInstance");
    *function = instance->hands || always ? own(name) : nullptr;
    return *function ? XR_SUCCESS : instance->next.get_proc(handle, name, function);
}

}  // namespace
}  // namespace glovetrack

GLOVETRACK_EXPORT XrResult XRAPI_CALL xrNegotiateLoaderApiLayerInterface(
    const glovetrack::LoaderInfo* loader, const char* name, glovetrack::LayerRequest* request) {
    using namespace glovetrack;
    const bool asked = name && !std::strcmp(name, LAYER_NAME) && request &&
                       request->kind == Kind::LayerRequest && request->version == STRUCTURE &&
                       request->size == sizeof(LayerRequest);
    if (!asked || !speaks(loader, LAYER_INTERFACE)) return XR_ERROR_INITIALIZATION_FAILED;
    request->interface_version = LAYER_INTERFACE;
    request->api_version = XR_MAKE_VERSION(1, 0, 0);
    request->get_proc = get_proc;
    request->create_instance = create_instance;
    return XR_SUCCESS;
}
