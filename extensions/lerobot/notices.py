"""Texts of the notices of this extension, by code."""

TEXTS = {
    "lerobot.needs_program": (
        "Films require {program}, which this computer does not have. Export the images as recorded."
    ),
    "lerobot.film_failed": "{path} could not be made by {program}: {why}.",
    "lerobot.image_sizes": (
        "The images of camera {camera} are not all of one size, which a data set "
        "requires. Export it with --images none."
    ),
    "lerobot.no_images": "{path} has a part without images of camera {camera}.",
    "lerobot.no_episode": "There is no episode: parts between notes need at least two frames.",
    "lerobot.rate": "LeRobot counts whole frames per second, not {rate_hz:g} Hz.",
    "lerobot.image_kind": "{path} has images of camera {camera} that are neither JPEG nor PNG.",
    "lerobot.differ": (
        "{first} and {source} differ in their {what}: a data set has the same in all its "
        "episodes. Export them separately{hint}."
    ),
    "lerobot.image_damaged": "An image is damaged.",
}
