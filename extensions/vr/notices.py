"""Texts of virtual reality's notices."""

TEXTS = {
    "vr.vmt_answers": "{stream}: received. VMT {version} responds.",
    "vr.line_read": "{stream}: lines were sent, and the terminal has room for more.",
    "vr.line_unread": "{stream}: no program reads the terminal. Open it as a serial port.",
}
