"""Texts about what the window could not do."""

TEXTS = {
    "window.process_ended": ("The process ended unexpectedly. The computer may be out of memory."),
    "window.demo_camera": "The simulated camera did not start.",
    "window.no_devices": "{problems}",
    "window.no_glove": "No glove was found on any USB serial port. Plug it in, then try again.",
    "window.no_glove_because": "No glove was found. {reasons}",
    "window.imus_alone": "The hand is tracked by its IMUs alone, so its position is unknown.",
    "window.no_rig": (
        "The camera has no calibration yet. Make or import one under Set-up, Camera calibration."
    ),
    "window.glove_settings": "The glove's settings cannot be changed: {why}.",
    "window.no_folder": "The folder {folder} no longer exists.",
    "window.not_tracked": "{file} has not been tracked. Choose Track again first.",
    "window.settings_no_version": "they have no version number",
    "window.settings_later": "they were written by a later version of Glovetrack",
    "window.tags_too_large": "it is too large",
    "window.being_recorded": "{file} is being recorded.",
    "window.is_open": "{file} is open. Close it first (Ctrl+W).",
    "window.image_not_readable": "{file} is not a readable image.",
    "window.image_not_encoded": "{file}: the image could not be encoded.",
    "window.exists_again": "{file} exists again. It was not replaced by the removed file.",
    "window.not_removed": "{name} was not removed: {why}.",
    "window.tags_not_moved": "The tags of {file} were not moved with it: {why}.",
    "window.no_trash": "{file} cannot be moved to the trash.",
    "window.not_restored": "{file} exists again, so it was not restored from the trash.",
    "window.no_image_to_fit": "There is no image yet to fit the colours to.",
    "window.no_markers_to_fit": "No markers were tracked yet. Fit from the image alone first.",
    "window.other_hues": "{file} must have the hues {hues:words} for this glove.",
    "window.recording_folder": "Cannot record to {folder}: {why}.",
    "window.unknown_field": "A file name can contain {known}, not {field}.",
    "window.bad_template": (
        'The file name "{template}" is incomplete. It can contain text and {known}.'
    ),
}
