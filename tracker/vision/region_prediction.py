"""Predicts the markers in future images, and plans which images are searched completely."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Vector
from tracker.messages import Array, CameraPose, IntArray
from tracker.vision.colours import hue_rows
from tracker.vision.hints import DetectionHints
from tracker.vision.rig import NEAREST, StereoIntrinsics, StereoRig

MARGIN_PX = 12.0
SPARING_EVERY, SPARING_LONGEST = 30, 0.3  # `SearchPlan` parameters on an overloaded computer
SPEED_SD = 0.5  # m/s, sd of a hand's change of velocity
SHORTEST, LONGEST = 0.005, 0.1  # s between two predictions from which a velocity is computed
CLOSE = 0.05  # m; at a smaller distance a radius in pixels is meaningless


class MovingMarkers(NamedTuple):
    """The arrays of a `RegionPrediction`: p_G (n, 3) m, v_G (n, 3) m/s, sd (n,) m, size (n,) m."""

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
    """Markers predicted for ``t``, and their motion; written by the engine, read by the vision
    thread.

    p_G (n, 3) m and v_G (n, 3) m/s in G, sd (n,) m, size (n,) m, hue (n,) index into ``hue_names``.
    """

    t: float
    p_G: Array
    v_G: Array
    sd: Array
    size: Array
    hue: IntArray
    hue_names: tuple[str, ...]
    right_late: float = 0.0  # s by which the right camera exposes later than the left one

    def after(self, before: RegionPrediction | None) -> RegionPrediction:
        """A copy with the velocity since ``before``, if that is recent."""
        if before is None or before.p_G.shape != self.p_G.shape:
            return self
        since = self.t - before.t
        if not SHORTEST <= since <= LONGEST:
            return self
        return replace(self, v_G=(self.p_G - before.p_G) / since)

    def at(self, t: float, hue_names: tuple[str, ...]) -> RegionPrediction:
        """Extrapolated to ``t``, hues numbered as in ``hue_names``, which must include them."""
        hue = hue_rows(self.hue_names, hue_names)[self.hue]
        p_G = self.p_G + (t - self.t) * self.v_G
        return replace(self, t=t, p_G=p_G, hue=hue, hue_names=hue_names)

    def hints(
        self, rig: StereoRig, t: float, pose: CameraPose, hue_names: tuple[str, ...]
    ) -> tuple[DetectionHints, DetectionHints]:
        """Positions in the two images taken at ``t``, hues numbered as in ``hue_names``.

        A hue that is not among them has number -1.
        A hue that is not among them has number -1.
        """
        hue = hue_rows(self.hue_names, hue_names)[self.hue]
        sides, markers = [], MovingMarkers(self.p_G, self.v_G, self.sd, self.size)
        eyes = ((rig.left, 0.0, 0.0), (rig.right, rig.baseline, self.right_late))
        for camera, shift, late in eyes:
            view = PosedCamera(
                pose.R_GC, pose.p_GC, shift, rig.intrinsics, camera.width, camera.height
            )
            ahead = np.full(len(self.p_G), t + late - self.t)
            uv, radius, rows = seen_soon(markers, ahead, view)
            if rig.line_time:
                ahead[rows] += rig.row_delays(np.stack([uv, uv]))[int(camera is rig.right)]
                uv, radius, rows = seen_soon(markers, ahead, view)
            sides.append(DetectionHints(camera.unrectify(uv), radius, hue[rows]))
        return sides[0], sides[1]


def together(predictions: Sequence[RegionPrediction]) -> RegionPrediction:
    """Combines several hands' predictions, at the latest of their times."""
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
    markers: MovingMarkers, ahead: Vector, view: PosedCamera
) -> tuple[Matrix, Vector, IntVector]:
    """Rectified pixels uv (k, 2), radius (k,) px and row (k,) of the markers near an image,
    each ``ahead`` (n,) s later.

    Markers behind the camera, or so far outside the image that a lens polynomial is invalid, are
    excluded.
    """
    p_G, v_G, sd, size = markers.p_G, markers.v_G, markers.sd, markers.size
    R_GC, p_GC, width, height = view.R_GC, view.p_GC, view.width, view.height
    fx, fy, cx, cy = view.camera.fx, view.camera.fy, view.camera.cx, view.camera.cy
    uv, radius, rows = np.empty((len(p_G), 2)), np.empty(len(p_G)), np.empty(len(p_G), np.int64)
    n = 0
    for i in range(len(p_G)):
        x, y, z = 0.0, 0.0, 0.0
        for k in range(3):
            d = p_G[i, k] + ahead[i] * v_G[i, k] - p_GC[k]
            x, y, z = x + d * R_GC[k, 0], y + d * R_GC[k, 1], z + d * R_GC[k, 2]
        if not z >= NEAREST:
            continue
        u, v = fx * (x - view.shift) / z + cx, fy * y / z + cy
        if -0.5 * width < u < 1.5 * width and -0.5 * height < v < 1.5 * height:
            reach = size[i] + 3 * sd[i] + SPEED_SD * abs(ahead[i])
            uv[n, 0], uv[n, 1], rows[n] = u, v, i
            radius[n] = fx * reach / max(z, CLOSE) + MARGIN_PX
            n += 1
    return uv[:n], radius[:n], rows[:n]


class SearchPlan:
    """Searches regions around predictions, and every few images the complete image.

    On an overloaded computer complete searches are less frequent, and older predictions are
    accepted.
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
        """Hints for the image at ``t``; None where it should be searched completely.

        That is every ``every``-th image, any without a prediction at most ``longest`` s old, and
        any in which no marker is predicted. ``sparing``: on an overloaded computer.
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
