// Sessions, their state, and where Glovetrack's world is in them.
// SPDX-License-Identifier: Apache-2.0
#include "functions.h"

namespace glovetrack {
namespace {

bool is_fixed(XrReferenceSpaceType type) {
    constexpr auto LOCAL_FLOOR = static_cast<XrReferenceSpaceType>(1000426000);
    return type == XR_REFERENCE_SPACE_TYPE_LOCAL || type == XR_REFERENCE_SPACE_TYPE_STAGE ||
           type == LOCAL_FLOOR;
}

}  // namespace

XrResult XRAPI_CALL create_session(XrInstance handle, const XrSessionCreateInfo* info,
                                   XrSession* out) {
    const auto instance = find(objects().instances, handle);
    if (!instance) return XR_ERROR_HANDLE_INVALID;
    const XrResult result = instance->next.create_session(handle, info, out);
    if (XR_FAILED(result)) return result;
    auto session = std::make_shared<Session>();
    session->instance = instance;
    session->handle = *out;
    std::lock_guard<std::mutex> lock(objects().mutex);
    objects().sessions[*out] = session;
    return result;
}

XrResult XRAPI_CALL destroy_session(XrSession handle) {
    const auto session = find(objects().sessions, handle);
    if (!session) return XR_ERROR_HANDLE_INVALID;
    {
        std::lock_guard<std::mutex> lock(objects().mutex);
        erase_if(objects().trackers,
                 [&](const auto& tracker) { return tracker->session == session; });
        objects().sessions.erase(handle);
    }
    return session->instance->next.destroy_session(handle);
}

XrResult XRAPI_CALL poll_event(XrInstance handle, XrEventDataBuffer* event) {
    const auto instance = find(objects().instances, handle);
    if (!instance) return XR_ERROR_HANDLE_INVALID;
    const XrResult result = instance->next.poll_event(handle, event);
    if (result == XR_SUCCESS && event->type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) {
        const auto* change = reinterpret_cast<const XrEventDataSessionStateChanged*>(event);
        const auto session = find(objects().sessions, change->session);
        if (session) session->state = change->state;
    }
    return result;
}

XrResult XRAPI_CALL create_reference_space(XrSession handle, const XrReferenceSpaceCreateInfo* info,
                                           XrSpace* out) {
    const auto session = find(objects().sessions, handle);
    if (!session) return XR_ERROR_HANDLE_INVALID;
    const XrResult result = session->instance->next.create_reference_space(handle, info, out);
    if (XR_SUCCEEDED(result)) {
        std::lock_guard<std::mutex> lock(objects().mutex);
        objects().fixed[*out] = is_fixed(info->referenceSpaceType);
    }
    return result;
}

// Of any kind of space, which many functions create: the loader allows one instance at a time.
XrResult XRAPI_CALL destroy_space(XrSpace handle) {
    std::shared_ptr<Instance> instance;
    {
        std::lock_guard<std::mutex> lock(objects().mutex);
        objects().fixed.erase(handle);
        if (objects().instances.empty()) return XR_ERROR_HANDLE_INVALID;
        instance = objects().instances.begin()->second;
    }
    return instance->next.destroy_space(handle);
}

// The space of Glovetrack's axes as it is placed now, or a null handle. LOCAL stands in for a
// STAGE that the runtime does not have.
XrSpace world_of(Session& session, const Placement& placement) {
    std::lock_guard<std::mutex> lock(session.placing);
    if (session.world && session.placement == placement) return session.world;
    const Next& next = session.instance->next;
    if (session.world) next.destroy_space(session.world);
    session.world = XR_NULL_HANDLE;
    const float* p = placement.position;
    const float* q = placement.orientation;
    XrReferenceSpaceCreateInfo info = {XR_TYPE_REFERENCE_SPACE_CREATE_INFO};
    info.referenceSpaceType = static_cast<XrReferenceSpaceType>(placement.space);
    info.poseInReferenceSpace = {{q[0], q[1], q[2], q[3]}, {p[0], p[1], p[2]}};
    XrResult result = next.create_reference_space(session.handle, &info, &session.world);
    if (result == XR_ERROR_REFERENCE_SPACE_UNSUPPORTED) {
        info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
        result = next.create_reference_space(session.handle, &info, &session.world);
    }
    if (XR_FAILED(result)) return session.world = XR_NULL_HANDLE;
    session.placement = placement;
    return session.world;
}

}  // namespace glovetrack
