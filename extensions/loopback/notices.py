"""Texts of the loop-back's notices."""

TEXTS = {
    "loopback.too_short": (
        "Only {pulses} pulses of the light are in the images, {least} are required. Measure longer."
    ),
    "loopback.no_light": (
        "No place in the left image follows the commands (correlation {correlation}). The light "
        "must be connected to this motor output and be in the picture, and the exposure be short "
        "enough that it is not saturated."
    ),
    "loopback.no_screen": (
        "No place in the left image follows the flashes of the screen (correlation {correlation}). "
        "The window must be in the picture, and the exposure be short enough that it is not "
        "saturated."
    ),
    "loopback.no_taps": (
        "The glove has measured no tap. Tap on a table with it, firmly, at irregular times."
    ),
    "loopback.screen_missing": "There is no screen that could flash.",
    "loopback.no_packets": "The glove has sent no packets.",
    "loopback.no_images": "The camera has sent no images.",
    "loopback.no_commands": "The glove has accepted no command.",
}
