"""Texts of the notices of this extension, by code."""

TEXTS = {
    "robot.too_large": "The robot hand {file} is larger than {limit_bytes} bytes.",
    "robot.not_usable": "The robot hand {file} cannot be used: {why}",
    "robot.not_mirrorable": "The robot hand cannot be mirrored: it has {what}.",
    "robot.no_fingers": (
        "A thumb and two other fingers were not found in the robot hand. Choose the links of its "
        "fingertips."
    ),
    "robot.finger": 'Unknown finger "{finger}". Use {known:or}.',
    "robot.link_twice": 'The link "{link}" is the tip of two fingers.',
    "robot.no_link": 'The robot hand has no link called "{link}".',
    "robot.no_finger_table": "{file} has no table [fingers] with a link for each finger.",
    "robot.joint_kind": "The joint {joint} of the robot hand is not a hinge.",
    "robot.no_palm": "The robot hand's fingers do not share a palm.",
    "robot.command": 'Unknown robot command "{command}". Use {known:or}.',
    "robot.needs_mujoco": "A robot hand requires MuJoCo, which is not installed. Run: {install}",
    "robot.hand_extra": "The robot hand {name} is not installed. Run: {install}",
    "robot.unknown_hand": (
        'Robot hand "{name}" not found. Use {known:or} or the path of an MJCF or URDF file.'
    ),
    "robot.needs_cube": "Add a cube to the objects: pick and place requires one.",
    "robot.side": 'The side must be right or left, not "{side}".',
    "robot.clutch": 'The clutch must be {known:or}, not "{clutch}".',
    "robot.objects": 'Unknown object "{value}". Use {known:or}.',
    "robot.scale": "The motion scale must be 0.1 to 10, the reach scale 0.5 to 2.",
    "robot.speeds": "Robot speeds must be greater than zero.",
    "robot.description_damaged": "The session's robot settings are damaged.",
    "robot.recorded_other": "The recording was made with another robot: {why}.",
    "robot.recorded_model": "The recorded robot does not match its model.",
    "robot.process_ended": "The robot's process has ended. Start the robot again.",
    "teleop.target": '--send requires HOST:PORT, not "{target}".',
    "teleop.address": 'Invalid address "{address}". Use a UDP port or ws://HOST:PORT.',
    "teleop.port": "Port {port} cannot be opened: {why}.",
    "robot.no_state": "{path} does not contain the initial state of its robot {robot}.",
    "robot.not_recorded": "{path} does not contain a robot. Requested: {robot}.",
}
