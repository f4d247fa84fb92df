// A headless OpenXR runtime for tests: sessions without graphics, three reference spaces whose poses
// are formulas, and a hand tracking of its own if it is asked to have one. It fails on structures of
// extensions that were not enabled, so a layer that lets one through is found out.
// SPDX-License-Identifier: Apache-2.0
//
// GLOVETRACK_TEST_RUNTIME is a list of words: hands, sources (that extension too), no-time, no-stage,
// unfocused (a session stays visible), still (the head does not move), silent (no velocities).
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include <time.h>
#define XR_USE_TIMESPEC
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include "loader.h"

using namespace glovetrack;

namespace {

constexpr int64_t EPOCH = 7'000'000'123;  // ns that XrTime is ahead of CLOCK_MONOTONIC
constexpr auto SOURCE_INFO = static_cast<XrStructureType>(1000428000);
constexpr auto SOURCE_STATE = static_cast<XrStructureType>(1000428001);
constexpr const char* SOURCES = "XR_EXT_hand_tracking_data_source";
constexpr const char* HEADLESS = XR_MND_HEADLESS_EXTENSION_NAME;

bool has(const char* word) {
    const char* words = std::getenv("GLOVETRACK_TEST_RUNTIME");
    return words && (" " + std::string(words) + " ").find(" " + std::string(word) + " ") !=
                        std::string::npos;
}

struct Vector {
    double x, y, z;
};

struct Pose {
    double q[4];  // xyzw
    Vector p;
};

Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vector turned(const Pose& by, const Vector& v) {
    const Vector u = {by.q[0], by.q[1], by.q[2]}, c = cross(u, v), d = cross(u, c);
    const double w = 2 * by.q[3];
    return {v.x + w * c.x + 2 * d.x, v.y + w * c.y + 2 * d.y, v.z + w * c.z + 2 * d.z};
}

Pose operator*(const Pose& a, const Pose& b) {
    const Vector u = {a.q[0], a.q[1], a.q[2]}, v = {b.q[0], b.q[1], b.q[2]}, c = cross(u, v);
    const double s = a.q[3], t = b.q[3];
    const Vector p = turned(a, b.p);
    return {{s * v.x + t * u.x + c.x, s * v.y + t * u.y + c.y, s * v.z + t * u.z + c.z,
             s * t - (u.x * v.x + u.y * v.y + u.z * v.z)},
            {a.p.x + p.x, a.p.y + p.y, a.p.z + p.z}};
}

Pose inverse(const Pose& a) {
    const Pose back = {{-a.q[0], -a.q[1], -a.q[2], a.q[3]}, {0, 0, 0}};
    const Vector p = turned(back, a.p);
    return {{-a.q[0], -a.q[1], -a.q[2], a.q[3]}, {-p.x, -p.y, -p.z}};
}

Pose about_y(double angle, const Vector& p) {
    return {{0, std::sin(angle / 2), 0, std::cos(angle / 2)}, p};
}

struct Space {
    XrReferenceSpaceType type;
    Pose pose;
};

// Of a reference space's origin in LOCAL. The test has the same formulas.
Pose origin(XrReferenceSpaceType type, double t) {
    if (type == XR_REFERENCE_SPACE_TYPE_STAGE) return about_y(0.5, {0.3, -1.6, 0.2});
    if (type != XR_REFERENCE_SPACE_TYPE_VIEW) return about_y(0, {0, 0, 0});
    const double s = has("still") ? 0 : std::sin(2 * t);
    return about_y(0.4 * s, {0.1 + 0.2 * s, 0.05, 0.02});
}

Pose at(const Space& space, const Space& base, double t) {
    return inverse(origin(base.type, t) * base.pose) * (origin(space.type, t) * space.pose);
}

struct Runtime {
    std::vector<std::string> enabled;
    std::deque<XrEventDataSessionStateChanged> events;
    std::map<XrSpace, Space> spaces;
    uint64_t handles = 100;
    uint64_t trackers = 0;
    bool session = false;
} runtime;

const auto INSTANCE = reinterpret_cast<XrInstance>(uint64_t{11});
const auto SESSION = reinterpret_cast<XrSession>(uint64_t{12});

bool enabled(const char* name) {
    for (const auto& e : runtime.enabled)
        if (e == name) return true;
    return false;
}

bool is_chained(const void* next, XrStructureType type) {
    for (auto* s = static_cast<const XrBaseInStructure*>(next); s; s = s->next)
        if (s->type == type) return true;
    return false;
}

std::vector<std::pair<const char*, uint32_t>> offered() {
    std::vector<std::pair<const char*, uint32_t>> out = {{HEADLESS, 2}};
    if (!has("no-time")) out.push_back({XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME, 1});
    if (has("hands")) out.push_back({XR_EXT_HAND_TRACKING_EXTENSION_NAME, 4});
    if (has("sources")) out.push_back({SOURCES, 1});
    return out;
}

template <class T, class F>
XrResult list(uint32_t capacity, uint32_t* count, T* out, uint32_t n, F fill) {
    *count = n;
    if (!capacity) return XR_SUCCESS;
    if (capacity < n) return XR_ERROR_SIZE_INSUFFICIENT;
    for (uint32_t i = 0; i < n; ++i) fill(i, out[i]);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL enumerate_extensions(const char*, uint32_t capacity, uint32_t* count,
                                         XrExtensionProperties* out) {
    const auto all = offered();
    return list(capacity, count, out, static_cast<uint32_t>(all.size()), [&](uint32_t i, auto& e) {
        std::strncpy(e.extensionName, all[i].first, sizeof e.extensionName - 1);
        e.extensionVersion = all[i].second;
    });
}

XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo* info, XrInstance* out) {
    runtime = Runtime();
    for (uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
        bool known = false;
        for (const auto& e : offered()) known |= !std::strcmp(e.first, info->enabledExtensionNames[i]);
        if (!known) return XR_ERROR_EXTENSION_NOT_PRESENT;
        runtime.enabled.push_back(info->enabledExtensionNames[i]);
    }
    *out = INSTANCE;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_instance(XrInstance) { return XR_SUCCESS; }

XrResult XRAPI_CALL get_instance_properties(XrInstance, XrInstanceProperties* out) {
    out->runtimeVersion = XR_MAKE_VERSION(0, 1, 0);
    std::strcpy(out->runtimeName, "Glovetrack's headless test runtime");
    return XR_SUCCESS;
}

XrResult XRAPI_CALL get_system(XrInstance, const XrSystemGetInfo*, XrSystemId* out) {
    *out = 1;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL get_system_properties(XrInstance, XrSystemId, XrSystemProperties* out) {
    constexpr auto TYPE = XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT;
    const bool asked = is_chained(out->next, TYPE);
    if (asked && !enabled(XR_EXT_HAND_TRACKING_EXTENSION_NAME)) return XR_ERROR_VALIDATION_FAILURE;
    out->systemId = 1;
    std::strcpy(out->systemName, "test");
    for (auto* s = static_cast<XrBaseOutStructure*>(out->next); s; s = s->next)
        if (s->type == TYPE)
            reinterpret_cast<XrSystemHandTrackingPropertiesEXT*>(s)->supportsHandTracking = XR_TRUE;
    return XR_SUCCESS;
}

void change_to(XrSessionState state) {
    XrEventDataSessionStateChanged event = {XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED};
    event.session = SESSION;
    event.state = state;
    event.time = 1;
    runtime.events.push_back(event);
}

XrResult XRAPI_CALL poll_event(XrInstance, XrEventDataBuffer* out) {
    if (runtime.events.empty()) return XR_EVENT_UNAVAILABLE;
    std::memcpy(out, &runtime.events.front(), sizeof runtime.events.front());
    runtime.events.pop_front();
    return XR_SUCCESS;
}

XrResult XRAPI_CALL create_session(XrInstance, const XrSessionCreateInfo* info, XrSession* out) {
    if (info->next || !enabled(HEADLESS)) return XR_ERROR_GRAPHICS_DEVICE_INVALID;
    runtime.session = true;
    change_to(XR_SESSION_STATE_IDLE);
    change_to(XR_SESSION_STATE_READY);
    *out = SESSION;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_session(XrSession) {
    runtime.session = false;
    runtime.spaces.clear();
    return XR_SUCCESS;
}

XrResult XRAPI_CALL begin_session(XrSession, const XrSessionBeginInfo*) {
    change_to(XR_SESSION_STATE_SYNCHRONIZED);
    change_to(XR_SESSION_STATE_VISIBLE);
    if (!has("unfocused")) change_to(XR_SESSION_STATE_FOCUSED);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL end_session(XrSession) { return XR_SUCCESS; }

std::vector<XrReferenceSpaceType> space_types() {
    std::vector<XrReferenceSpaceType> out = {XR_REFERENCE_SPACE_TYPE_VIEW,
                                             XR_REFERENCE_SPACE_TYPE_LOCAL};
    if (!has("no-stage")) out.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
    return out;
}

XrResult XRAPI_CALL enumerate_spaces(XrSession, uint32_t capacity, uint32_t* count,
                                     XrReferenceSpaceType* out) {
    const auto all = space_types();
    return list(capacity, count, out, static_cast<uint32_t>(all.size()),
                [&](uint32_t i, auto& type) { type = all[i]; });
}

XrResult XRAPI_CALL create_space(XrSession, const XrReferenceSpaceCreateInfo* info, XrSpace* out) {
    bool known = false;
    for (const auto type : space_types()) known |= type == info->referenceSpaceType;
    if (!known) return XR_ERROR_REFERENCE_SPACE_UNSUPPORTED;
    const auto& [q, p] = info->poseInReferenceSpace;
    const double n = std::sqrt(double{q.x} * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    if (std::fabs(n - 1) > 0.01) return XR_ERROR_POSE_INVALID;
    *out = reinterpret_cast<XrSpace>(++runtime.handles);
    const Pose pose = {{q.x / n, q.y / n, q.z / n, q.w / n}, {p.x, p.y, p.z}};
    runtime.spaces[*out] = {info->referenceSpaceType, pose};
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_space(XrSpace space) {
    return runtime.spaces.erase(space) ? XR_SUCCESS : XR_ERROR_HANDLE_INVALID;
}

void differentiate(const Space& space, const Space& base, double t, XrSpaceVelocity& out) {
    constexpr double H = 1e-4;
    const Pose before = at(space, base, t - H), after = at(space, base, t + H);
    const Pose turn = after * inverse({{before.q[0], before.q[1], before.q[2], before.q[3]}, {}});
    const double s = (turn.q[3] < 0 ? -1 : 1) / H;
    out.velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT | XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;
    const auto f = [](double x) { return static_cast<float>(x); };
    out.angularVelocity = {f(s * turn.q[0]), f(s * turn.q[1]), f(s * turn.q[2])};
    out.linearVelocity = {f((after.p.x - before.p.x) / (2 * H)), f((after.p.y - before.p.y) / (2 * H)),
                          f((after.p.z - before.p.z) / (2 * H))};
}

XrResult XRAPI_CALL locate_space(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* out) {
    const auto s = runtime.spaces.find(space), b = runtime.spaces.find(base);
    if (s == runtime.spaces.end() || b == runtime.spaces.end()) return XR_ERROR_HANDLE_INVALID;
    const double t = 1e-9 * static_cast<double>(time - EPOCH);
    const Pose pose = at(s->second, b->second, t);
    const auto f = [](double x) { return static_cast<float>(x); };
    out->locationFlags = 15;
    out->pose = {{f(pose.q[0]), f(pose.q[1]), f(pose.q[2]), f(pose.q[3])},
                 {f(pose.p.x), f(pose.p.y), f(pose.p.z)}};
    for (auto* v = static_cast<XrBaseOutStructure*>(out->next); v; v = v->next) {
        if (v->type != XR_TYPE_SPACE_VELOCITY) return XR_ERROR_VALIDATION_FAILURE;
        auto& velocity = *reinterpret_cast<XrSpaceVelocity*>(v);
        velocity.velocityFlags = 0;
        if (!has("silent")) differentiate(s->second, b->second, t, velocity);
    }
    return XR_SUCCESS;
}

XrResult XRAPI_CALL to_timespec(XrInstance, XrTime time, timespec* out) {
    const int64_t t = time - EPOCH;
    *out = {t / 1'000'000'000, t % 1'000'000'000};
    return t < 0 ? XR_ERROR_TIME_INVALID : XR_SUCCESS;
}

XrResult XRAPI_CALL from_timespec(XrInstance, const timespec* in, XrTime* out) {
    *out = int64_t{in->tv_sec} * 1'000'000'000 + in->tv_nsec + EPOCH;
    return XR_SUCCESS;
}

XrResult XRAPI_CALL create_tracker(XrSession, const XrHandTrackerCreateInfoEXT* info,
                                   XrHandTrackerEXT* out) {
    if (is_chained(info->next, SOURCE_INFO) && !enabled(SOURCES)) return XR_ERROR_VALIDATION_FAILURE;
    ++runtime.trackers;
    *out = reinterpret_cast<XrHandTrackerEXT>(++runtime.handles);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL destroy_tracker(XrHandTrackerEXT) {
    return runtime.trackers-- ? XR_SUCCESS : XR_ERROR_HANDLE_INVALID;
}

// A hand of a held controller: every joint at (1, 2, 3).
XrResult XRAPI_CALL locate_joints(XrHandTrackerEXT, const XrHandJointsLocateInfoEXT*,
                                  XrHandJointLocationsEXT* out) {
    out->isActive = XR_TRUE;
    for (uint32_t i = 0; i < out->jointCount; ++i)
        out->jointLocations[i] = {3, {{0, 0, 0, 1}, {1, 2, 3}}, 0.01f};
    for (auto* s = static_cast<XrBaseOutStructure*>(out->next); s; s = s->next) {
        if (s->type != SOURCE_STATE) continue;
        if (!enabled(SOURCES)) return XR_ERROR_VALIDATION_FAILURE;
        const uint32_t state[2] = {XR_TRUE, 2};
        std::memcpy(reinterpret_cast<char*>(s) + sizeof *s, state, sizeof state);
    }
    return XR_SUCCESS;
}

XrResult XRAPI_CALL result_to_string(XrInstance, XrResult value, char out[]) {
    std::snprintf(out, XR_MAX_RESULT_STRING_SIZE, "%d", value);
    return XR_SUCCESS;
}

PFN_xrVoidFunction function(const std::string& name) {
#define F(name, f) {name, reinterpret_cast<PFN_xrVoidFunction>(f)}
    static const std::map<std::string, PFN_xrVoidFunction> all = {
        F("xrEnumerateInstanceExtensionProperties", enumerate_extensions),
        F("xrCreateInstance", create_instance),
        F("xrDestroyInstance", destroy_instance),
        F("xrGetInstanceProperties", get_instance_properties),
        F("xrGetSystem", get_system),
        F("xrGetSystemProperties", get_system_properties),
        F("xrPollEvent", poll_event),
        F("xrCreateSession", create_session),
        F("xrDestroySession", destroy_session),
        F("xrBeginSession", begin_session),
        F("xrEndSession", end_session),
        F("xrEnumerateReferenceSpaces", enumerate_spaces),
        F("xrCreateReferenceSpace", create_space),
        F("xrDestroySpace", destroy_space),
        F("xrLocateSpace", locate_space),
        F("xrConvertTimeToTimespecTimeKHR", to_timespec),
        F("xrConvertTimespecTimeToTimeKHR", from_timespec),
        F("xrCreateHandTrackerEXT", create_tracker),
        F("xrDestroyHandTrackerEXT", destroy_tracker),
        F("xrLocateHandJointsEXT", locate_joints),
        F("xrResultToString", result_to_string),
    };
#undef F
    const auto found = all.find(name);
    return found == all.end() ? nullptr : found->second;
}

XrResult XRAPI_CALL get_proc(XrInstance, const char* name, PFN_xrVoidFunction* out) {
    const bool hands = std::strstr(name, "Hand") != nullptr;
    const bool time = std::strstr(name, "Timespec") != nullptr;
    *out = function(name);
    if ((hands && !enabled(XR_EXT_HAND_TRACKING_EXTENSION_NAME)) ||
        (time && !enabled(XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME)))
        *out = nullptr;
    if (!std::strcmp(name, "xrGetInstanceProcAddr"))
        *out = reinterpret_cast<PFN_xrVoidFunction>(get_proc);
    return *out ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED;
}

}  // namespace

GLOVETRACK_EXPORT XrResult XRAPI_CALL xrNegotiateLoaderRuntimeInterface(const LoaderInfo* loader,
                                                                        RuntimeRequest* request) {
    if (!speaks(loader, RUNTIME_INTERFACE)) return XR_ERROR_INITIALIZATION_FAILED;
    request->interface_version = RUNTIME_INTERFACE;
    request->api_version = XR_MAKE_VERSION(1, 0, 20);
    request->get_proc = get_proc;
    return XR_SUCCESS;
}
