"""Images of the printed sheet before a stereo camera."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from extensions.touch.sheet import COLUMNS, CROSS, CROSSES, ROWS, SQUARE, TouchSheet
from tracker.calibration.stereo.board import BoardSpec
from tracker.geometry import so3
from tracker.messages import Array, StereoFrame
from tracker.simulation.backgrounds import BackgroundParams
from tracker.simulation.board_camera import true_rig
from tracker.simulation.board_images import SQUARE_PX, BoardPose, BoardRenderer
from tracker.simulation.render import RenderParams
from tracker.simulation.rooms import Room
from tracker.simulation.smooth import rng_for
from tracker.vision.rig import StereoRig, default_pose

LINE_PX = 2  # width of a cross's lines
_MIDDLE = np.array([TouchSheet.width / 2, TouchSheet.height / 2, 0.0])


@dataclass(frozen=True, eq=False)
class SheetPlace:
    """The true pose of the sheet in G: x_G = R_GS scale x_S + p_GS; ``scale`` of the print."""

    R_GS: Array
    p_GS: Array
    scale: float = 1.0

    def target(self, p_S: Array) -> Array:
        """(3,) m in G of a point given in the sheet's nominal coordinates."""
        return self.R_GS @ (self.scale * p_S) + self.p_GS

    @property
    def middle(self) -> Array:
        """(3,) m in G."""
        return self.target(_MIDDLE)


def placed_sheet(seed: int, scale: float = 1.0, rig: StereoRig | None = None) -> SheetPlace:
    """A sheet on the table below the cameras of ``rig`` (the ideal ones by default), its lower edge
    towards the wearer; up to 8° askew."""
    rng = rng_for(seed, "sheet")
    R_GS = so3.rz(np.deg2rad(rng.uniform(-8, 8))) @ np.array(
        [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]
    )
    middle_G = np.array([0.23, 0.0, 0.0]) + rng.normal(0, 0.008, 3) * [1, 1, 0]
    if rig is not None:
        middle_G = middle_G + rig.pose.p_GC - default_pose().p_GC
    return SheetPlace(R_GS, middle_G - R_GS @ (scale * _MIDDLE), scale)


def sheet_frames(
    place: SheetPlace, rig: StereoRig, count: int, seed: int, start: float = 0.0
) -> Iterator[StereoFrame]:
    """``count`` exposures, 0.6 s apart from ``start`` (s) on."""
    renderer, pose = _drawn(place, rig)
    for k in range(count):
        left, right = renderer.pair(pose, rng_for(seed, "sheet image", k))
        t = start + 0.6 * k
        yield StereoFrame(t=t, t_arrival=t + 0.04, left=left, right=right, index=k)


def _printed() -> NDArray[np.uint8]:
    """The sheet with its flat crosses; the ridge is not drawn."""
    image = TouchSheet().image(SQUARE_PX)
    half = round(0.5 * CROSS / SQUARE * SQUARE_PX)
    for cross in CROSSES:
        if cross.height == 0.0:
            u, v = (round(x / SQUARE * SQUARE_PX) for x in (cross.x, cross.y))
            cv2.line(image, (u - half, v), (u + half, v), 0, LINE_PX)
            cv2.line(image, (u, v - half), (u, v + half), 0, LINE_PX)
            place = (u + half // 2, v - half // 2)
            cv2.putText(image, cross.name, place, cv2.FONT_HERSHEY_SIMPLEX, 0.6, 0, LINE_PX)
    return image


def _drawn(
    place: SheetPlace, rig: StereoRig, noise: float = 2.0
) -> tuple[BoardRenderer, BoardPose]:
    spec = replace(BoardSpec(), columns=COLUMNS, rows=ROWS, square=SQUARE * place.scale)
    renderer = BoardRenderer(true_rig(rig), spec, noise, printed=_printed())
    R_LG = rig.left.R.T @ rig.pose.R_GC.T
    return renderer, BoardPose(R_LG @ place.R_GS, R_LG @ (place.p_GS - rig.pose.p_GC))


def sheet_room(rig: StereoRig, seed: int) -> Room:
    """The sheet of `placed_sheet` on the table, behind the hand."""
    renderer, pose = _drawn(placed_sheet(seed, rig=rig), rig, noise=0.0)
    left, right = renderer.pair(pose, rng_for(seed, "sheet room"))
    given = (left, left if right is None else right)
    return Room(RenderParams(BackgroundParams("given", given=given)), ())
