"""Where markers are expected in images yet to come, and which of those are searched whole."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Vector
from tracker.messages import Array, CameraPose, IntArray
from tracker.vision.colours import hue_rows
from tracker.vision.detector import DetectionHints
from tracker.vision.rig import NEAREST, StereoIntrinsics, StereoRig

MARGIN_PX = 12.0
SPARING_EVERY, SPARING_LONGEST = 30, 0.3  # of a `SearchPlan` on a computer that is too slow
SPEED_SD = 0.5  # m/s by which a hand may differ from the speed it had
SHORTEST, LONGEST = 0.005, 0.1  # s between two predictions that give a speed
CLOSE = 0.05  # m; nearer than this a radius in pixels means nothing


class MovingMarkers(NamedTuple):
    """Of `RegionPrediction`: p_G (n, 3) m, v_G (n, 3) m/s, sd (n,) m, size (n,) m."""

    p_G: Matrix
    v_G: Matrix
    sd: Vector
    size: Vector


class PosedCamera(NamedTuple):
    """An image of width by height px, whose camera is ``shift`` m to the right of the pose."""

    R_GC: Matrix
    p_GC: Vector
    shift: float
    camera: StereoIntrinsics
    width: int
    height: int


@dataclass(frozen=True, eq=False)
class RegionPrediction:
    """Markers expected at ``t``, and how they move; written by the engine, read by vision.

    p_G (n, 3) m and v_G (n, 3) m/s in G, sd (n,) m, size (n,) m, hue (n,) index into ``hue_names``.
    """

    t: float
    p_G: Array
    v_G: Array
    sd: Array
    size: Array
    hue: IntArray
    hue_names: tuple[str, ...]
    right_late: float = 0.0  # s that the right camera exposes later than the left one

    def after(self, before: RegionPrediction | None) -> RegionPrediction:
        """The same, moving as it has since ``before`` where that is a little while ago."""
        if before is None or before.p_G.shape != self.p_G.shape:
            return self
        since = self.t - before.t
        if not SHORTEST <= since <= LONGEST:
            return self
        return replace(self, v_G=(self.p_G - before.p_G) / since)

    def at(self, t: float, hue_names: tuple[str, ...]) -> RegionPrediction:
        """Moved on to ``t``, hues numbered as in ``hue_names``; they must be among them."""
        hue = hue_rows(self.hue_names, hue_names)[self.hue]
        p_G = self.p_G + (t - self.t) * self.v_G
        return replace(self, t=t, p_G=p_G, hue=hue, hue_names=hue_names)

    def hints(
        self, rig: StereoRig, t: float, pose: CameraPose, hue_names: tuple[str, ...]
    ) -> tuple[DetectionHints, DetectionHints]:
        """Positions in the two images taken at ``t``, hues numbered as in ``hue_names``.

        A hue that is not among them has number -1.
        """
        hue = hue_rows(self.hue_names, hue_names)[self.hue]
        sides, markers = [], MovingMarkers(self.p_G, self.v_G, self.sd, self.size)
        eyes = ((rig.left, 0.0, 0.0), (rig.right, rig.baseline, self.right_late))
        for camera, shift, late in eyes:
            view = PosedCamera(
                pose.R_GC, pose.p_GC, shift, rig.intrinsics, camera.width, camera.height
            )
            uv, radius, rows = seen_soon(markers, t + late - self.t, view)
            sides.append(DetectionHints(camera.unrectify(uv), radius, hue[rows]))
        return sides[0], sides[1]


def together(predictions: Sequence[RegionPrediction]) -> RegionPrediction:
    """Of several hands as of one, at the latest of their instants."""
    if len(predictions) == 1:
        return predictions[0]
    t = max(p.t for p in predictions)
    names = tuple(dict.fromkeys(name for p in predictions for name in p.hue_names))
    moved = [p.at(t, names) for p in predictions]
    return RegionPrediction(
        t=t,
        p_G=np.concatenate([p.p_G for p in moved]),
        v_G=np.concatenate([p.v_G for p in moved]),
        sd=np.concatenate([p.sd for p in moved]),
        size=np.concatenate([p.size for p in moved]),
        hue=np.concatenate([p.hue for p in moved]),
        hue_names=names,
        right_late=moved[0].right_late,
    )


@kernel(nogil=False)
def seen_soon(
    markers: MovingMarkers, ahead: float, view: PosedCamera
) -> tuple[Matrix, Vector, IntVector]:
    """Rectified pixels uv (k, 2), radius (k,) px and row (k,) of the markers near an image,
    ``ahead`` s later.

    Not near is what lies behind the camera, or so far outside the image that a lens polynomial
    means nothing.
    """
    p_G, v_G, sd, size = markers.p_G, markers.v_G, markers.sd, markers.size
    R_GC, p_GC, width, height = view.R_GC, view.p_GC, view.width, view.height
    fx, fy, cx, cy = view.camera.fx, view.camera.fy, view.camera.cx, view.camera.cy
    uv, radius, rows = np.empty((len(p_G), 2)), np.empty(len(p_G)), np.empty(len(p_G), np.int64)
    n = 0
    for i in range(len(p_G)):
        x, y, z = 0.0, 0.0, 0.0
        for k in range(3):
            d = p_G[i, k] + ahead * v_G[i, k] - p_GC[k]
            x, y, z = x + d * R_GC[k, 0], y + d * R_GC[k, 1], z + d * R_GC[k, 2]
        if not z >= NEAREST:
            continue
        u, v = fx * (x - view.shift) / z + cx, fy * y / z + cy
        if -0.5 * width < u < 1.5 * width and -0.5 * height < v < 1.5 * height:
            reach = size[i] + 3 * sd[i] + SPEED_SD * abs(ahead)
            uv[n, 0], uv[n, 1], rows[n] = u, v, i
            radius[n] = fx * reach / max(z, CLOSE) + MARGIN_PX
            n += 1
    return uv[:n], radius[:n], rows[:n]


class SearchPlan:
    """Regions around what is expected, and every few images the whole, to see what is not.

    On a computer that is too slow the whole is searched seldom, and older predictions serve.
    """

    def __init__(self, every: int = 6, longest: float = 0.1) -> None:
        self._limits = (every, longest)
        self._since_whole = 0

    def hints(
        self,
        prediction: RegionPrediction | None,
        rig: StereoRig,
        t: float,
        pose: CameraPose | None,
        hue_names: tuple[str, ...],
        sparing: bool = False,
    ) -> tuple[DetectionHints, DetectionHints] | None:
        """For the image at ``t``; None where it should be searched whole.

        That is every ``every``-th, any without a prediction not older than ``longest`` s, and any
        in which nothing at all is expected. ``sparing``: on a computer that is too slow.
        """
        every, longest = (SPARING_EVERY, SPARING_LONGEST) if sparing else self._limits
        self._since_whole += 1
        if prediction is None or abs(t - prediction.t) > longest or self._since_whole >= every:
            self._since_whole = 0
            return None
        sides = prediction.hints(rig, t, pose or rig.pose, hue_names)
        if all(len(side.uv) for side in sides):
            return sides
        self._since_whole = 0
        return None
