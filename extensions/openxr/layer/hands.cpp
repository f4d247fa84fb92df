// Hand trackers: the hand of a running Glovetrack, else the runtime's.
// SPDX-License-Identifier: Apache-2.0
#include <new>
#include <optional>

#include "functions.h"
#include "motion.h"

namespace glovetrack {
namespace {

constexpr XrSpaceLocationFlags PLACED =
    XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
constexpr XrSpaceLocationFlags TRACKED =
    XR_SPACE_LOCATION_POSITION_TRACKED_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
constexpr XrSpaceVelocityFlags MOVING =
    XR_SPACE_VELOCITY_LINEAR_VALID_BIT | XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;

// XR_SUCCESS if the data sources that the application accepts make sense.
XrResult read_sources(const XrHandTrackingDataSourceInfoEXT* info, Tracker& tracker) {
    if (!info) return XR_SUCCESS;
    tracker.asks_source = true;
    tracker.unobstructed = false;
    for (uint32_t i = 0; i < info->requestedDataSourceCount; ++i) {
        const auto source = info->requestedDataSources[i];
        for (uint32_t k = 0; k < i; ++k)
            if (info->requestedDataSources[k] == source) return XR_ERROR_VALIDATION_FAILURE;
        tracker.unobstructed |= source == XR_HAND_TRACKING_DATA_SOURCE_UNOBSTRUCTED_EXT;
    }
    return XR_SUCCESS;
}

XrResult make_tracker(XrSession handle, const XrHandTrackerCreateInfoEXT* info,
                      XrHandTrackerEXT* out) {
    auto tracker = std::make_shared<Tracker>();
    tracker->session = find(objects().sessions, handle);
    if (!tracker->session) return XR_ERROR_HANDLE_INVALID;
    const Instance& instance = *tracker->session->instance;
    if (!info || info->type != XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT || !out ||
        (info->hand != XR_HAND_LEFT_EXT && info->hand != XR_HAND_RIGHT_EXT))
        return XR_ERROR_VALIDATION_FAILURE;
    if (info->handJointSet != XR_HAND_JOINT_SET_DEFAULT_EXT)  // another extension's
        return instance.runtime_hands ? instance.next.create_hand_tracker(handle, info, out)
                                      : XR_ERROR_VALIDATION_FAILURE;
    tracker->hand = info->hand == XR_HAND_LEFT_EXT ? 0 : 1;
    const auto* sources = chained<XrHandTrackingDataSourceInfoEXT>(
        info->next, XR_TYPE_HAND_TRACKING_DATA_SOURCE_INFO_EXT);
    if (instance.sources) {
        const XrResult result = read_sources(sources, *tracker);
        if (XR_FAILED(result)) return result;
    }
    if (instance.runtime_hands) {
        XrHandTrackerCreateInfoEXT below = *info;
        if (sources == below.next && sources && !instance.runtime_sources)
            below.next = sources->next;
        if (XR_FAILED(instance.next.create_hand_tracker(handle, &below, &tracker->runtime)))
            tracker->runtime = XR_NULL_HANDLE;
    }
    // Functions of other extensions get the runtime's own handle.
    tracker->handle = tracker->runtime ? tracker->runtime
                                       : reinterpret_cast<XrHandTrackerEXT>(tracker.get());
    std::lock_guard<std::mutex> lock(objects().mutex);
    objects().trackers[tracker->handle] = tracker;
    *out = tracker->handle;
    return XR_SUCCESS;
}

}  // namespace

XrResult XRAPI_CALL create_hand_tracker(XrSession session, const XrHandTrackerCreateInfoEXT* info,
                                        XrHandTrackerEXT* out) {
    try {
        return make_tracker(session, info, out);
    } catch (const std::bad_alloc&) {
        return XR_ERROR_OUT_OF_MEMORY;
    }
}

XrResult XRAPI_CALL destroy_hand_tracker(XrHandTrackerEXT handle) {
    const auto tracker = find(objects().trackers, handle);
    if (!tracker) return XR_ERROR_HANDLE_INVALID;
    {
        std::lock_guard<std::mutex> lock(objects().mutex);
        objects().trackers.erase(handle);
    }
    if (!tracker->runtime) return XR_SUCCESS;
    return tracker->session->instance->next.destroy_hand_tracker(tracker->runtime);
}

namespace {

// The structures of one call: velocities and state are null unless they are chained.
struct Answer {
    XrHandJointLocationsEXT* locations;
    XrHandJointVelocitiesEXT* velocities;
    XrHandTrackingDataSourceStateEXT* state;

    // No joint has a pose; `source`: whether there is a source all the same.
    XrResult inactive(bool source) const {
        locations->isActive = XR_FALSE;
        for (uint32_t j = 0; j < JOINTS; ++j) {
            locations->jointLocations[j] = {};
            locations->jointLocations[j].pose.orientation.w = 1;
            if (velocities) velocities->jointVelocities[j] = {};
        }
        has_source(source);
        return XR_SUCCESS;
    }

    void has_source(bool source) const {
        if (!state) return;
        state->isActive = source;
        state->dataSource = XR_HAND_TRACKING_DATA_SOURCE_UNOBSTRUCTED_EXT;
    }
};

bool is_valid(const Tracker& tracker, const XrHandJointsLocateInfoEXT* info, const Answer& to) {
    const auto* l = to.locations;
    const auto* v = to.velocities;
    return info->type == XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT &&
           l->type == XR_TYPE_HAND_JOINT_LOCATIONS_EXT && l->jointCount == JOINTS &&
           l->jointLocations && (!v || (v->jointCount == JOINTS && v->jointVelocities)) &&
           (!to.state || tracker.asks_source);
}

// The instant of our clock; nothing if the runtime does not convert its time.
std::optional<int64_t> our_time(const Instance& instance, XrTime time) {
    if (!instance.next.convert_time) return std::nullopt;
#ifdef _WIN32
    LARGE_INTEGER count, frequency;
    if (XR_FAILED(instance.next.convert_time(instance.handle, time, &count))) return std::nullopt;
    QueryPerformanceFrequency(&frequency);
    const int64_t s = count.QuadPart / frequency.QuadPart;
    return s * 1'000'000'000 +
           (count.QuadPart % frequency.QuadPart) * 1'000'000'000 / frequency.QuadPart;
#else
    timespec found;
    if (XR_FAILED(instance.next.convert_time(instance.handle, time, &found))) return std::nullopt;
    return int64_t{found.tv_sec} * 1'000'000'000 + found.tv_nsec;
#endif
}

// Where Glovetrack's axes are in the application's space, and how they move there.
struct Base {
    XrSpaceLocation location = {XR_TYPE_SPACE_LOCATION};
    XrSpaceVelocity velocity = {XR_TYPE_SPACE_VELOCITY};
};

XrResult locate_world(const Tracker& tracker, const Placement& placement,
                      const XrHandJointsLocateInfoEXT* info, Base& base) {
    Session& session = *tracker.session;
    const XrSpace world = world_of(session, placement);
    if (!world) return XR_ERROR_RUNTIME_FAILURE;
    base.location.next = &base.velocity;
    const XrResult result =
        session.instance->next.locate_space(world, info->baseSpace, info->time, &base.location);
    std::lock_guard<std::mutex> lock(objects().mutex);
    const auto found = objects().fixed.find(info->baseSpace);
    if (found != objects().fixed.end() && found->second && base.velocity.velocityFlags == 0) {
        base.velocity.velocityFlags = MOVING;  // two spaces of the room do not move in each other
        base.velocity.linearVelocity = base.velocity.angularVelocity = {0, 0, 0};
    }
    return result;
}

void write(const Base& base, const Located& joint, XrHandJointLocationEXT& location) {
    const XrPosef& world = base.location.pose;
    const bool tracked = joint.tracked && (base.location.locationFlags & TRACKED) == TRACKED;
    location.locationFlags = PLACED | (tracked ? TRACKED : 0);
    location.pose.orientation = world.orientation * joint.pose.orientation;
    location.pose.position = world.position + rotate(world.orientation, joint.pose.position);
    location.radius = joint.radius;
}

void write(const Base& base, const Located& joint, XrHandJointVelocityEXT& velocity) {
    const XrPosef& world = base.location.pose;
    const XrSpaceVelocity& moving = base.velocity;
    velocity = {};
    if (!joint.moves || (moving.velocityFlags & MOVING) != MOVING) return;
    const XrVector3f from_world = rotate(world.orientation, joint.pose.position);
    velocity.velocityFlags = MOVING;
    velocity.linearVelocity = moving.linearVelocity + cross(moving.angularVelocity, from_world) +
                              rotate(world.orientation, joint.linear);
    velocity.angularVelocity = moving.angularVelocity + rotate(world.orientation, joint.angular);
}

XrResult answer(const Tracker& tracker, const XrHandJointsLocateInfoEXT* info,
                std::optional<int64_t> t, const Moment& moment, const Answer& to) {
    const XrSessionState state = tracker.session->state;
    const bool focused = state == XR_SESSION_STATE_UNKNOWN || state == XR_SESSION_STATE_FOCUSED;
    Located joints[JOINTS];
    Base base;
    const XrResult result = locate_world(tracker, moment.placement, info, base);
    if (XR_FAILED(result)) return result;
    const bool placed = (base.location.locationFlags & PLACED) == PLACED;
    const bool active = placed && focused && locate(moment, t, joints);
    Memory::get().sign(active);
    if (!active) return to.inactive(true);
    to.locations->isActive = XR_TRUE;
    for (uint32_t j = 0; j < JOINTS; ++j) {
        write(base, joints[j], to.locations->jointLocations[j]);
        if (to.velocities) write(base, joints[j], to.velocities->jointVelocities[j]);
    }
    to.has_source(true);
    return result;
}

XrResult answer_by_runtime(const Tracker& tracker, const XrHandJointsLocateInfoEXT* info,
                           const Answer& to) {
    const Instance& instance = *tracker.session->instance;
    if (!tracker.runtime) return to.inactive(false);
    if (to.state && !instance.runtime_sources && !tracker.unobstructed) return to.inactive(false);
    const bool unknown = !instance.runtime_sources;
    XrResult result;
    {
        const Unchained without(to.locations, XR_TYPE_HAND_TRACKING_DATA_SOURCE_STATE_EXT, unknown);
        result = instance.next.locate_hand_joints(tracker.runtime, info, to.locations);
    }
    if (unknown) to.has_source(to.locations->isActive);
    return result;
}

}  // namespace

XrResult XRAPI_CALL locate_hand_joints(XrHandTrackerEXT handle,
                                       const XrHandJointsLocateInfoEXT* info,
                                       XrHandJointLocationsEXT* locations) {
    const auto tracker = find(objects().trackers, handle);
    if (!tracker) return XR_ERROR_HANDLE_INVALID;
    if (!info || !locations) return XR_ERROR_VALIDATION_FAILURE;
    const Answer to = {locations,
                       chained<XrHandJointVelocitiesEXT>(locations->next,
                                                         XR_TYPE_HAND_JOINT_VELOCITIES_EXT),
                       chained<XrHandTrackingDataSourceStateEXT>(
                           locations->next, XR_TYPE_HAND_TRACKING_DATA_SOURCE_STATE_EXT)};
    if (!is_valid(*tracker, info, to)) return XR_ERROR_VALIDATION_FAILURE;
    if (info->time <= 0) return XR_ERROR_TIME_INVALID;
    const auto t = our_time(*tracker->session->instance, info->time);
    const auto moment =
        tracker->unobstructed ? Memory::get().hand(tracker->hand, t) : std::nullopt;
    return moment ? answer(*tracker, info, t, *moment, to) : answer_by_runtime(*tracker, info, to);
}

}  // namespace glovetrack
