// Instances, sessions and hand trackers as the layer knows them.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <unknwn.h>
#include <windows.h>
#define XR_USE_PLATFORM_WIN32
#else
#include <time.h>
#define XR_USE_TIMESPEC
#endif
#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <atomic>
#include <map>
#include <memory>
#include <mutex>

#include "memory.h"

#ifndef XR_EXT_hand_tracking_data_source  // newer than Debian's headers; numbers of the registry
constexpr XrStructureType XR_TYPE_HAND_TRACKING_DATA_SOURCE_INFO_EXT =
    static_cast<XrStructureType>(1000428000);
constexpr XrStructureType XR_TYPE_HAND_TRACKING_DATA_SOURCE_STATE_EXT =
    static_cast<XrStructureType>(1000428001);
enum XrHandTrackingDataSourceEXT {
    XR_HAND_TRACKING_DATA_SOURCE_UNOBSTRUCTED_EXT = 1,
    XR_HAND_TRACKING_DATA_SOURCE_CONTROLLER_EXT = 2,
};
struct XrHandTrackingDataSourceInfoEXT {
    XrStructureType type;
    const void* next;
    uint32_t requestedDataSourceCount;
    XrHandTrackingDataSourceEXT* requestedDataSources;
};
struct XrHandTrackingDataSourceStateEXT {
    XrStructureType type;
    void* next;
    XrBool32 isActive;
    XrHandTrackingDataSourceEXT dataSource;
};
#endif

namespace glovetrack {

// The next layer's or the runtime's functions.
struct Next {
    PFN_xrGetInstanceProcAddr get_proc;
    PFN_xrDestroyInstance destroy_instance;
    PFN_xrGetSystemProperties get_system_properties;
    PFN_xrCreateSession create_session;
    PFN_xrDestroySession destroy_session;
    PFN_xrPollEvent poll_event;
    PFN_xrCreateReferenceSpace create_reference_space;
    PFN_xrDestroySpace destroy_space;
    PFN_xrLocateSpace locate_space;
    PFN_xrCreateHandTrackerEXT create_hand_tracker;
    PFN_xrDestroyHandTrackerEXT destroy_hand_tracker;
    PFN_xrLocateHandJointsEXT locate_hand_joints;
#ifdef _WIN32
    PFN_xrConvertTimeToWin32PerformanceCounterKHR convert_time;
#else
    PFN_xrConvertTimeToTimespecTimeKHR convert_time;
#endif
};

struct Instance {
    XrInstance handle;
    Next next;
    bool hands;    // whether the application uses hand tracking, and this layer does anything
    bool sources;  // whether it uses data sources
    bool runtime_hands;
    bool runtime_sources;
};

struct Session {
    std::shared_ptr<Instance> instance;
    XrSession handle;
    std::atomic<XrSessionState> state{XR_SESSION_STATE_UNKNOWN};
    std::mutex placing;
    Placement placement{};  // of `world`
    XrSpace world = XR_NULL_HANDLE;  // Glovetrack's axes and origin
};

struct Tracker {
    std::shared_ptr<Session> session;
    uint32_t hand;  // 0 left, 1 right
    XrHandTrackerEXT handle;
    XrHandTrackerEXT runtime = XR_NULL_HANDLE;  // the runtime's tracker
    bool asks_source = false;   // created with the data sources that the application accepts
    bool unobstructed = true;   // whether fingers that are tracked one by one are accepted
};

// Objects by their handles. A call copies the pointer and works without the lock.
struct Objects {
    std::mutex mutex;
    std::map<XrInstance, std::shared_ptr<Instance>> instances;
    std::map<XrSession, std::shared_ptr<Session>> sessions;
    std::map<XrHandTrackerEXT, std::shared_ptr<Tracker>> trackers;
    std::map<XrSpace, bool> fixed;  // whether a reference space is fixed in the room
};

Objects& objects();

template <class Handle, class Object>
std::shared_ptr<Object> find(const std::map<Handle, std::shared_ptr<Object>>& all, Handle handle) {
    std::lock_guard<std::mutex> lock(objects().mutex);
    const auto found = all.find(handle);
    return found == all.end() ? nullptr : found->second;
}

template <class Map, class Condition>
void erase_if(Map& map, Condition condition) {
    for (auto at = map.begin(); at != map.end();) at = condition(at->second) ? map.erase(at) : ++at;
}

template <class T>
T* chained(void* next, XrStructureType type) {
    for (auto* s = static_cast<XrBaseOutStructure*>(next); s; s = s->next)
        if (s->type == type) return reinterpret_cast<T*>(s);
    return nullptr;
}

template <class T>
const T* chained(const void* next, XrStructureType type) {
    return chained<T>(const_cast<void*>(next), type);
}

// Takes a structure that the runtime does not know out of a chain while it is called.
class Unchained {
  public:
    Unchained(void* head, XrStructureType type, bool is_unknown) {
        auto* s = static_cast<XrBaseOutStructure*>(head);
        for (; is_unknown && s && s->next; s = s->next) {
            if (s->next->type != type) continue;
            before_ = s;
            taken_ = s->next;
            s->next = taken_->next;
            return;
        }
    }
    ~Unchained() {
        if (before_) before_->next = taken_;
    }
    Unchained(const Unchained&) = delete;
    Unchained& operator=(const Unchained&) = delete;

  private:
    XrBaseOutStructure* before_ = nullptr;
    XrBaseOutStructure* taken_ = nullptr;
};

}  // namespace glovetrack
