"""The model of an arm in OpenSim's format: forearm and hand with two pin joints."""

import numpy as np

WRIST = np.array([0.01, -0.02, 0.005])  # m in hand_r
MASS = 0.45  # kg
BODY = f"""<?xml version="1.0" encoding="UTF-8" ?>
<OpenSimDocument Version="40000"><Model name="arm">
<BodySet name="bodyset"><objects>
<Body name="radius_r"><mass>1.2</mass><mass_center>0 -0.12 0</mass_center>
<inertia>0.01 0.001 0.01 0 0 0</inertia></Body>
<Body name="hand_r"><mass>{MASS}</mass><mass_center>0 -0.07 0</mass_center>
<inertia>0.001 0.0005 0.001 0 0 0</inertia></Body>
</objects></BodySet>
<JointSet name="jointset"><objects>
<PinJoint name="elbow_r"><socket_parent_frame>/ground</socket_parent_frame>
<socket_child_frame>/bodyset/radius_r</socket_child_frame>
<coordinates><Coordinate name="elbow_flex_r"><default_value>0.3</default_value></Coordinate>
</coordinates></PinJoint>
<PinJoint name="wrist_r"><socket_parent_frame>radius_r_offset</socket_parent_frame>
<socket_child_frame>hand_r_offset</socket_child_frame>
<coordinates><Coordinate name="wrist_flex_r"><default_value>0</default_value></Coordinate>
</coordinates><frames>
<PhysicalOffsetFrame name="radius_r_offset"><socket_parent>/bodyset/radius_r</socket_parent>
<translation>0 -0.25 0</translation><orientation>0 0 0</orientation></PhysicalOffsetFrame>
<PhysicalOffsetFrame name="hand_r_offset"><socket_parent>/bodyset/hand_r</socket_parent>
<translation>{" ".join(map(str, WRIST))}</translation><orientation>0 0 0</orientation>
</PhysicalOffsetFrame></frames></PinJoint>
</objects></JointSet></Model></OpenSimDocument>
"""
