"""The rooms that images can show, by name."""

from __future__ import annotations

from typing import NamedTuple

from tracker.base.errors import ConfigError
from tracker.simulation.backgrounds import BackgroundParams
from tracker.simulation.desk.arm import Forearm
from tracker.simulation.desk.lights import LIGHTS, light_of
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.render import RenderParams
from tracker.simulation.scene import Extra

SCENES = ("plain", "painted", "photo", "desk")
DEFAULT_LIGHT = next(iter(LIGHTS))


class Room(NamedTuple):
    """How images are drawn, and what else is in the scene."""

    render: RenderParams | DeskParams
    extras: tuple[Extra, ...]


def room_of(scene: str, light: str = "", photo: str = "", seed: int = 0) -> Room:
    """A room of `SCENES`; ``light`` is the desk's, ``photo`` the path of an image.

    Raises ConfigError for what there is not, or what does not go together.
    """
    if scene not in SCENES:
        raise ConfigError(f"The scene can be {', '.join(SCENES)}, not {scene!r}.")
    if light and scene != "desk":
        raise ConfigError(f"The light can be chosen for the scene desk, not for {scene}.")
    if bool(photo) != (scene == "photo"):
        raise ConfigError("The scene photo needs an image (--photo), and no other scene has one.")
    if scene == "desk":
        name = light or DEFAULT_LIGHT
        light_of(name)
        return Room(DeskParams(name), (Forearm(seed),))
    kind = "photograph" if scene == "photo" else scene
    return Room(RenderParams(BackgroundParams(kind, photo)), ())
