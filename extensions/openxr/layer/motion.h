// The pose of a hand between and beyond its samples. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <openxr/openxr.h>

#include "memory.h"

namespace glovetrack {

XrVector3f operator+(const XrVector3f& a, const XrVector3f& b);
XrVector3f operator-(const XrVector3f& a, const XrVector3f& b);
XrVector3f operator*(float s, const XrVector3f& v);
XrVector3f cross(const XrVector3f& a, const XrVector3f& b);
XrQuaternionf operator*(const XrQuaternionf& a, const XrQuaternionf& b);
XrQuaternionf inverse(const XrQuaternionf& q);  // of a unit quaternion
XrVector3f rotate(const XrQuaternionf& q, const XrVector3f& v);
XrQuaternionf rotation(const XrVector3f& vector);  // about a rotation vector, rad

struct Located {
    XrPosef pose;
    XrVector3f linear;   // m/s
    XrVector3f angular;  // rad/s
    bool moves;          // whether the velocities are known
    bool tracked;        // measured, not inferred
    float radius;
};

// All joints at `t` ns: of the newest sample without it. Nothing if the hand is not active then.
// A joint between two samples is interpolated. Beyond the newest one it is predicted by its
// velocity for `moment.ahead` ns at most: bones keep their length. A later or earlier instant than
// there is gives the nearest pose, which is not called tracked.
bool locate(const Moment& moment, std::optional<int64_t> t, Located (&joints)[JOINTS]);

}  // namespace glovetrack
