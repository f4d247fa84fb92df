"""Texts of the notices of this extension, by code."""

TEXTS = {
    "lerobot.needs_program": (
        "Videos require {program}, which is not installed. Keep the images as recorded."
    ),
    "lerobot.film_failed": "{program} could not write {path}: {why}.",
    "lerobot.image_sizes": (
        "The images of camera {camera} differ in size, which a data set does not allow. "
        "Export it with --images none."
    ),
    "lerobot.no_images": "A part of {path} has no images of camera {camera}.",
    "lerobot.no_episode": "No episodes: parts between notes require at least two frames.",
    "lerobot.rate": "LeRobot requires an integer rate, not {rate_hz:g} Hz.",
    "lerobot.image_kind": "The images of camera {camera} in {path} are not JPEG or PNG.",
    "lerobot.image_damaged": "An image is damaged.",
    "lerobot.layouts_differ": (
        "{first} and {other} differ in their {what:word}, which must be the same for all "
        "episodes. Export them one by one, or leave the difference out (--images none)."
    ),
}
