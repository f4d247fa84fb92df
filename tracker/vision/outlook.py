"""Where markers are expected in pictures yet to come, and which of those are searched whole."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracker.messages import Array, CameraPose, IntArray
from tracker.vision.detector import DetectionHints
from tracker.vision.rig import StereoRig

MARGIN_PX = 12.0
SPEED_SD = 0.5  # m/s by which a hand may differ from the speed it had
SHORTEST, LONGEST = 0.005, 0.1  # s between two outlooks that tell a speed
NEAREST = 0.05  # m; nearer than this a radius in pixels means nothing


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
        """Places in the two pictures taken at ``t``, hues numbered as in ``hue_names``.

        A hue that is not among them has number -1.
        """
        ahead = t - self.t
        p_C = (self.p_G + ahead * self.v_G - pose.p_GC) @ pose.R_GC
        reach = self.size + 3 * self.sd + SPEED_SD * abs(ahead)
        radius = rig.fx * reach / np.maximum(p_C[:, 2], NEAREST) + MARGIN_PX
        number = {name: k for k, name in enumerate(hue_names)}
        hue = np.array([number.get(self.hue_names[h], -1) for h in self.hue], np.int64)
        sides = []
        for right in (False, True):
            camera, uv = (rig.right if right else rig.left), rig.project(p_C, right)
            ok = np.flatnonzero(_near_picture(uv, camera.width, camera.height))
            sides.append(DetectionHints(camera.unrectify(uv[ok]), radius[ok], hue[ok]))
        return sides[0], sides[1]


def _near_picture(uv: Array, width: int, height: int) -> Array:
    """(n,) bool: not so far outside that a lens polynomial means nothing."""
    size = np.array([width, height], float)
    return np.all((uv > -0.5 * size) & (uv < 1.5 * size), axis=1)


class SearchPlan:
    """Regions around what is expected, and every few pictures the whole, to see what is not."""

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
        """For the picture at ``t``; None where it should be searched whole.

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
