"""Texts of notices about OSC messages."""

TEXTS = {
    "osc.address": "The OSC addresses are {addresses}.",
    "osc.values": "{address} has {expected} values, not {found}.",
    "osc.not_osc": "This is not an OSC message: {why}.",
    "osc.expected": "An OSC message was expected: {why}.",
    "osc.no_slash": "an OSC address begins with a slash",
    "osc.no_tags": "the OSC type tags are missing",
    "osc.truncated": "the OSC bundle is truncated",
    "osc.several": "the OSC bundle contains more than one message",
    "osc.type": 'the OSC type "{tag}" is unknown, or its value is truncated',
    "osc.no_end": "an OSC text has no end",
    "osc.not_utf8": "an OSC text is not UTF-8",
    "osc.nested": "the OSC bundles are nested too deeply",
    "osc.pose_numbers": "a pose requires {count} numbers",
    "osc.pose_finite": "a pose contains numbers that are not finite",
    "osc.pose_norm": "a quaternion is not of unit length",
}
