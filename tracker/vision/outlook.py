"""Where markers are expected in images yet to come, and which of those are searched whole."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracker.kernels import kernel
from tracker.messages import Array, CameraPose, IntArray
from tracker.vision.colours import hue_rows
from tracker.vision.detector import DetectionHints
from tracker.vision.rig import NEAREST, StereoRig

MARGIN_PX = 12.0
SPEED_SD = 0.5  # m/s by which a hand may differ from the speed it had
SHORTEST, LONGEST = 0.005, 0.1  # s between two outlooks that tell a speed
CLOSE = 0.05  # m; nearer than this a radius in pixels means nothing


@dataclass(frozen=True, eq=False)
class Outlook:
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

    def after(self, before: Outlook | None) -> Outlook:
        """The same, moving as it has since ``before`` where that is a little while ago."""
        if before is None or before.p_G.shape != self.p_G.shape:
            return self
        since = self.t - before.t
        if not SHORTEST <= since <= LONGEST:
            return self
        return replace(self, v_G=(self.p_G - before.p_G) / since)

    def hints(
        self, rig: StereoRig, t: float, pose: CameraPose, hue_names: tuple[str, ...]
    ) -> tuple[DetectionHints, DetectionHints]:
        """Places in the two images taken at ``t``, hues numbered as in ``hue_names``.

        A hue that is not among them has number -1.
        """
        hue = hue_rows(self.hue_names, hue_names)[self.hue]
        sides = []
        for camera, shift in ((rig.left, 0.0), (rig.right, rig.baseline)):
            uv, radius, rows = seen_soon(
                self.p_G, self.v_G, self.sd, self.size, t - self.t,
                pose.R_GC, pose.p_GC, shift, rig.fx, rig.fy, rig.cx, rig.cy,
                camera.width, camera.height,
            )  # fmt: skip
            sides.append(DetectionHints(camera.unrectify(uv), radius, hue[rows]))
        return sides[0], sides[1]


@kernel
def seen_soon(  # type: ignore[no-untyped-def]
    p_G, v_G, sd, size, ahead, R_GC, p_GC, shift, fx, fy, cx, cy, width, height
):
    """Rectified pixels uv (k, 2), radius (k,) px and row (k,) of the markers near an image.

    p_G, v_G (n, 3), sd and size (n,) as in `Outlook`, ``ahead`` s later; the lens is ``shift`` m to
    the right of the pose's. Not near is what lies behind the lens, or so far outside the image
    that a lens polynomial means nothing.
    """
    uv, radius, rows = np.empty((len(p_G), 2)), np.empty(len(p_G)), np.empty(len(p_G), np.int64)
    n = 0
    for i in range(len(p_G)):
        x, y, z = 0.0, 0.0, 0.0
        for k in range(3):
            d = p_G[i, k] + ahead * v_G[i, k] - p_GC[k]
            x, y, z = x + d * R_GC[k, 0], y + d * R_GC[k, 1], z + d * R_GC[k, 2]
        if not z >= NEAREST:
            continue
        u, v = fx * (x - shift) / z + cx, fy * y / z + cy
        if -0.5 * width < u < 1.5 * width and -0.5 * height < v < 1.5 * height:
            reach = size[i] + 3 * sd[i] + SPEED_SD * abs(ahead)
            uv[n, 0], uv[n, 1], rows[n] = u, v, i
            radius[n] = fx * reach / max(z, CLOSE) + MARGIN_PX
            n += 1
    return uv[:n], radius[:n], rows[:n]


class SearchPlan:
    """Regions around what is expected, and every few images the whole, to see what is not."""

    def __init__(self, every: int = 6, longest: float = 0.1) -> None:
        self._every, self._longest = every, longest
        self._since_whole = 0

    def hints(
        self,
        outlook: Outlook | None,
        rig: StereoRig,
        t: float,
        pose: CameraPose | None,
        hue_names: tuple[str, ...],
    ) -> tuple[DetectionHints, DetectionHints] | None:
        """For the image at ``t``; None where it should be searched whole.

        That is every ``every``-th, any without an outlook not older than ``longest`` s, and any in
        which nothing at all is expected.
        """
        self._since_whole += 1
        if (
            outlook is None
            or abs(t - outlook.t) > self._longest
            or self._since_whole >= self._every
        ):
            self._since_whole = 0
            return None
        sides = outlook.hints(rig, t, pose or rig.pose, hue_names)
        if all(len(side.uv) for side in sides):
            return sides
        self._since_whole = 0
        return None
