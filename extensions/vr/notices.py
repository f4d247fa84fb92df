"""Texts of virtual reality's notices."""

TEXTS = {
    "vr.at": "{stream} at {path}",
    "vr.vmt_answers": "{stream}: received. VMT {version} responds.",
    "vr.line_read": "{stream}: lines were sent, and the terminal has room for more.",
    "vr.line_unread": "{stream}: no program reads the terminal. Open it as a serial port.",
    "vr.unknown_gesture": 'There is no gesture "{name}". Available: {known}.',
    "vr.haptic_values": "{address} has an index, a frequency, an amplitude and a duration.",
    "vr.unknown_finger": 'There is no finger "{name}". Available: {known}, {all}.',
    "opengloves.no_terminal": "This system has no pseudo-terminals.",
    "opengloves.link": "The link {link} cannot be created: {why}.",
}
