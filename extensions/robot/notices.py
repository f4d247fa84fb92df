"""Texts of the notices of this extension, by code."""

TEXTS = {
    "robot.no_fingers": (
        "The robot hand's fingers are not found: name their bodies thumb (or th), index "
        "(ff), middle (mf), ring (rf) and little (lf)."
    ),
    "robot.no_palm": "The robot hand's fingers do not share a palm.",
    "robot.no_tip": "The robot hand's {finger:word} has no tip: a site named tip, or a geom.",
    "robot.command": 'A robot takes {known:or}, not "{command}".',
    "robot.too_large": "The robot hand {file} is larger than {limit_bytes} bytes.",
    "robot.not_usable": "The robot hand {file} cannot be used: {why}",
    "robot.needs_mujoco": (
        "A robot hand requires MuJoCo, an extra that is not installed. Run: {install}"
    ),
    "robot.unknown_hand": (
        'There is no robot hand "{name}". Available: {known:list}, or a file of MJCF.'
    ),
    "robot.hand_extra": "The robot hand {name} requires an extra. Run: {install}",
    "robot.not_mirrorable": "The robot hand cannot be mirrored: it has {what}.",
    "robot.process_ended": "The robot's process has ended.",
    "robot.recorded_model": "The recorded robot does not match its model.",
    "robot.side": 'A hand is right or left, not "{side}".',
    "robot.clutch": 'The clutch is {known:or}, not "{clutch}".',
    "robot.objects": 'Objects are {known:or}, not "{value}".',
    "robot.scale": "The motion is scaled by 0.1 to 10, the reach by 0.5 to 2.",
    "robot.speeds": "A robot's speeds must be greater than zero.",
    "robot.description_damaged": "The session's robot description is damaged.",
    "robot.recorded_other": "The recorded robot is another one: {why}.",
}
