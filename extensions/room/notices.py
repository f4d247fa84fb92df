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
    "room.no_packets": "No packets of the glove arrived. Check that it is connected.",
    "room.not_received": (
        "No poses of the tracker {name} arrived. Test the source, and check the tracker's name."
    ),
    "room.only_positions": (
        "The tracker {name} has positions, but no rotations. It cannot be aligned."
    ),
    "room.test_no_connection": (
        "{address}: there is no connection. Check that the program runs there, the address, and "
        "the firewall."
    ),
    "room.test_nothing": (
        "{address}: nothing was received in {seconds:.0f} s. Check that the other program sends "
        "to this address, and the firewall."
    ),
    "room.test_unreadable": (
        "{address}: {count} packets were received that are not poses of this protocol."
    ),
    "room.test_missing": "Poses arrive, but none of {names}. Choose one of these trackers:",
    "room.test_unnamed": "Poses of {count} trackers arrive. Choose the tracker on each hand:",
    "room.test_received": "Poses of {count} trackers arrive:",
    "room.unknown_axis": "The axis {axis} cannot point up. Choose y or z.",
}
