// SPDX-License-Identifier: Apache-2.0
#include "motion.h"

#include <cmath>

namespace glovetrack {
namespace {

constexpr uint32_t WRIST = XR_HAND_JOINT_WRIST_EXT;

// The joint from which a bone leads to this one.
uint32_t parent(uint32_t joint) {
    switch (joint) {
        case XR_HAND_JOINT_PALM_EXT:
        case XR_HAND_JOINT_THUMB_METACARPAL_EXT:
        case XR_HAND_JOINT_INDEX_METACARPAL_EXT:
        case XR_HAND_JOINT_MIDDLE_METACARPAL_EXT:
        case XR_HAND_JOINT_RING_METACARPAL_EXT:
        case XR_HAND_JOINT_LITTLE_METACARPAL_EXT:
            return WRIST;
        default:
            return joint - 1;
    }
}

Located located(const Joint& joint) {
    const float *p = joint.position, *q = joint.orientation;
    const float *v = joint.linear, *w = joint.angular;
    Located out;
    out.pose = {{q[0], q[1], q[2], q[3]}, {p[0], p[1], p[2]}};
    out.moves = std::isfinite(v[0] + v[1] + v[2] + w[0] + w[1] + w[2]);
    out.linear = out.moves ? XrVector3f{v[0], v[1], v[2]} : XrVector3f{0, 0, 0};
    out.angular = out.moves ? XrVector3f{w[0], w[1], w[2]} : XrVector3f{0, 0, 0};
    out.tracked = joint.state == State::Measured;
    out.radius = joint.radius;
    return out;
}

void interpolate(const Pose& after, float share, Located (&joints)[JOINTS]) {
    for (uint32_t j = 0; j < JOINTS; ++j) {
        const Located next = located(after.joints[j]);
        XrPosef& pose = joints[j].pose;
        const XrQuaternionf turn = next.pose.orientation * inverse(pose.orientation);
        const XrVector3f axis = {turn.x, turn.y, turn.z};
        const float n = std::hypot(turn.x, turn.y, turn.z);
        const float angle = 2 * std::atan2(n, std::fabs(turn.w)) * (turn.w < 0 ? -1.0f : 1.0f);
        if (n > 0) pose.orientation = rotation((share * angle / n) * axis) * pose.orientation;
        pose.position = pose.position + share * (next.pose.position - pose.position);
        joints[j].tracked = joints[j].tracked && next.tracked;
    }
}

// By `dt` s; a joint whose own turn is not known turns with the bone before it.
void predict(float dt, Located (&joints)[JOINTS]) {
    if (!joints[WRIST].moves) return;
    XrPosef before[JOINTS];
    XrQuaternionf turn[JOINTS];
    for (uint32_t k = 0; k < JOINTS; ++k) before[k] = joints[k].pose;
    const auto move = [&](uint32_t j) {
        const bool moves = joints[j].moves;
        turn[j] = moves ? rotation(dt * joints[j].angular) : turn[parent(j)];
        joints[j].pose.orientation = turn[j] * before[j].orientation;
        if (j == WRIST) {
            joints[j].pose.position = before[j].position + dt * joints[j].linear;
            return;
        }
        const uint32_t from = parent(j);
        const XrVector3f bone = before[j].position - before[from].position;
        joints[j].pose.position = joints[from].pose.position + rotate(turn[from], bone);
    };
    move(WRIST);
    for (uint32_t j = 0; j < JOINTS; ++j)
        if (j != WRIST) move(j);
}

}  // namespace

XrVector3f operator+(const XrVector3f& a, const XrVector3f& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

XrVector3f operator-(const XrVector3f& a, const XrVector3f& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

XrVector3f operator*(float s, const XrVector3f& v) { return {s * v.x, s * v.y, s * v.z}; }

XrVector3f cross(const XrVector3f& a, const XrVector3f& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

XrQuaternionf operator*(const XrQuaternionf& a, const XrQuaternionf& b) {
    const XrVector3f u = {a.x, a.y, a.z}, v = {b.x, b.y, b.z};
    const XrVector3f xyz = a.w * v + b.w * u + cross(u, v);
    return {xyz.x, xyz.y, xyz.z, a.w * b.w - (u.x * v.x + u.y * v.y + u.z * v.z)};
}

XrQuaternionf inverse(const XrQuaternionf& q) { return {-q.x, -q.y, -q.z, q.w}; }

XrVector3f rotate(const XrQuaternionf& q, const XrVector3f& v) {
    const XrVector3f u = {q.x, q.y, q.z}, twice = 2 * cross(u, v);
    return v + q.w * twice + cross(u, twice);
}

XrQuaternionf rotation(const XrVector3f& vector) {
    const float angle = std::hypot(vector.x, vector.y, vector.z);
    const float s = angle < 1e-8f ? 0.5f : std::sin(angle / 2) / angle;
    return {s * vector.x, s * vector.y, s * vector.z, std::cos(angle / 2)};
}

bool locate(const Moment& moment, std::optional<int64_t> t, Located (&joints)[JOINTS]) {
    const Pose& pose = moment.before;
    if (!pose.active) return false;
    for (uint32_t j = 0; j < JOINTS; ++j) joints[j] = located(pose.joints[j]);
    if (!t) return true;
    const int64_t since = *t - pose.t;
    if (moment.after && moment.after->active && since > 0) {
        const auto whole = static_cast<float>(moment.after->t - pose.t);
        interpolate(*moment.after, static_cast<float>(since) / whole, joints);
    } else if (since > 0) {
        predict(1e-9f * static_cast<float>(std::min(since, moment.ahead)), joints);
    }
    if (since < 0 || since > moment.ahead)
        for (Located& joint : joints) joint.tracked = false;
    return true;
}

}  // namespace glovetrack
