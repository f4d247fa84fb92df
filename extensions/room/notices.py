"""Texts of the room's notices."""

TEXTS = {
    "room.too_short": (
        "The movement is too short. Turn the hand for at least {least_s:.0f} s while both the "
        "glove and the tracking system measure it."
    ),
    "room.movements_differ": (
        "The glove and the tracker do not move together (correlation {correlation:.2f}). Check "
        "that the tracker is on this hand and that it is tracked all the time."
    ),
    "room.one_axis": (
        "The hand was turned about one axis only. Turn it about all axes: palm up and down, "
        "fingers up and down, left and right."
    ),
    "room.rotations_differ": (
        "The rotations of the glove and the tracker differ by {rms_deg:.0f}° (rms). Check that "
        "the tracker is fixed to the back of the hand and which axis of the room points up."
    ),
    "room.wrist_moved": (
        "The wrist moved by {rms_mm:.0f} mm (rms). Rest it on a point while you turn the hand."
    ),
    "room.no_poses": "{file} contains no poses of a tracker on the {side:word} hand.",
    "room.no_rotations": (
        "{file} contains positions of a tracker on the {side:word} hand, but no rotations. They "
        "cannot be aligned."
    ),
    "room.no_root_imu": "The glove has no IMU on the segment {segment}. It cannot be aligned.",
    "room.bad_alignment": "{file} is not an alignment: {why}.",
    "room.unknown_axis": "The axis {axis} cannot point up. Choose y or z.",
}
