// The functions of OpenXR that the layer answers.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "loader.h"
#include "objects.h"

namespace glovetrack {

XrResult XRAPI_CALL create_instance(const XrInstanceCreateInfo*, const LayerCreateInfo*,
                                    XrInstance*);
XrResult XRAPI_CALL destroy_instance(XrInstance);
XrResult XRAPI_CALL get_system_properties(XrInstance, XrSystemId, XrSystemProperties*);
XrResult XRAPI_CALL poll_event(XrInstance, XrEventDataBuffer*);
XrResult XRAPI_CALL create_session(XrInstance, const XrSessionCreateInfo*, XrSession*);
XrResult XRAPI_CALL destroy_session(XrSession);
XrResult XRAPI_CALL create_reference_space(XrSession, const XrReferenceSpaceCreateInfo*, XrSpace*);
XrResult XRAPI_CALL destroy_space(XrSpace);
XrResult XRAPI_CALL create_hand_tracker(XrSession, const XrHandTrackerCreateInfoEXT*,
                                        XrHandTrackerEXT*);
XrResult XRAPI_CALL destroy_hand_tracker(XrHandTrackerEXT);
XrResult XRAPI_CALL locate_hand_joints(XrHandTrackerEXT, const XrHandJointsLocateInfoEXT*,
                                       XrHandJointLocationsEXT*);

// The space of Glovetrack's axes as it is placed now, or a null handle. LOCAL stands in for a
// STAGE that the runtime does not have.
XrSpace world_of(Session& session, const Placement& placement);

}  // namespace glovetrack
