"""The rooms that images can show, by name, and the wearer's forearm.

Packages add rooms as entry points of the group ``glovetrack.scenes`` that name a `SceneKind`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.registry import Registry
from tracker.messages import Array
from tracker.simulation.backgrounds import BackgroundParams
from tracker.simulation.desk.lights import LIGHTS, light_of
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.render import RenderParams
from tracker.simulation.scene import Extra
from tracker.simulation.smooth import rng_for
from tracker.simulation.solids import UNOWNED, Solids, capsules
from tracker.vision.rig import StereoRig, ideal_rig

BGR = (
    (118, 160, 212), (96, 132, 186), (66, 92, 140), (150, 184, 226),
    (98, 60, 38), (34, 28, 110), (112, 108, 104), (60, 92, 60), (44, 42, 42),
)  # fmt: skip
"""Skin, and the cloth of sleeves."""
CUFF = 0.06  # m behind the wrist, at the end of the glove
LENGTH, THIN, THICK = 0.24, 0.026, 0.036  # m


class Forearm(Extra):
    """Two capsules from the cuff towards the wearer, who is behind the camera."""

    def __init__(self, seed: int) -> None:
        rng = rng_for(seed, "arm")
        self._colour = np.array(BGR[int(rng.integers(len(BGR)))], float)
        self._thickness = float(rng.uniform(0.92, 1.1))

    def solids(self, t: float, R_GB: Array, p_GB: Array) -> Solids:
        """In G. The wrist bends by half of the hand's rotation."""
        ahead = R_GB[0][:, 0]
        level = np.array([ahead[0], ahead[1], 0.0])
        along = 0.5 * ahead + 0.5 * level / max(float(np.linalg.norm(level)), 1e-3)
        along = along / np.linalg.norm(along)
        begin = p_GB[0] - CUFF * ahead
        middle, end = begin - 0.4 * LENGTH * along, begin - LENGTH * along
        a, b = np.array([begin, middle]), np.array([middle, end])
        radius = self._thickness * np.array([THIN, THICK])
        return capsules(a, b, radius, np.full(2, UNOWNED), self._colour)

    def coloured(self, t: float) -> tuple[Array, Array, tuple[str, ...]]:
        return np.zeros((0, 3)), np.zeros(0), ()


SCENES = ("plain", "painted", "photo", "desk")
DEFAULT_LIGHT = next(iter(LIGHTS))


class Room(NamedTuple):
    """The renderer of the images, and additional objects in the scene."""

    render: RenderParams | DeskParams
    extras: tuple[Extra, ...]


@dataclass(frozen=True)
class SceneKind:
    """A room of another package: ``make(rig, seed)`` returns it for the cameras of a rig, which do
    not move. ``name`` is the entry point's."""

    name: str
    title: str
    make: Callable[[StereoRig, int], Room]


KINDS = Registry("scenes", "scene", SceneKind)


def room_of(
    scene: str, light: str = "", photo: str = "", seed: int = 0, rig: StereoRig | None = None
) -> Room:
    """A room of `SCENES` or `KINDS`; ``light`` is the desk's, ``photo`` the path of an image,
    ``rig`` the cameras if they are not the ideal ones.

    Raises ConfigError for unknown names and invalid combinations.
    """
    if scene not in (*SCENES, *KINDS.names()):
        raise ConfigError(
            notice("option.choice", option="--scene", known=(*SCENES, *KINDS.names()), value=scene)
        )
    if light and scene != "desk":
        raise ConfigError(notice("simulate.light_scene", scene=scene))
    if bool(photo) != (scene == "photo"):
        raise ConfigError(notice("simulate.photo_scene"))
    if scene not in SCENES:
        return KINDS.get(scene).make(rig or ideal_rig(), seed)
    if scene == "desk":
        name = light or DEFAULT_LIGHT
        light_of(name)
        return Room(DeskParams(name), (Forearm(seed),))
    kind = "photograph" if scene == "photo" else scene
    return Room(RenderParams(BackgroundParams(kind, photo)), ())
