"""The pose and the printed scale of the sheet, from images of a still camera."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from extensions.touch.sheet import RULER, TouchSheet
from tracker.base.errors import ConfigError
from tracker.base.notices import Notice, failure, notice, warning
from tracker.calibration.stereo.views import Corners, Image
from tracker.messages import Array, StereoFrame
from tracker.vision.rig import Camera, StereoRig

LEAST_CORNERS = 12
SCALE_LIMIT = 0.005
"""Relative difference of the squares' size, above which the print is called wrong: a printer at
100 % is within 0.3 %."""
FIT_LIMIT_PX = 0.5
MOVED_LIMIT = 0.0015
"""m by which the sheet may seem to move during the test."""


@dataclass(frozen=True, eq=False)
class SheetPose:
    """Pose of the sheet: x_G = R_GS x_S + p_GS (3,), for printed points of the true size.

    ``scale`` is the size of the printed squares as the stereo camera measures it, relative to the
    file, and ``scale_sd`` its standard deviation; NaN of a camera with one lens. ``print_scale`` is
    what targets are scaled by: the user's ruler where there is one, else ``scale``. ``fit_px`` is
    the RMS distance of corners from this pose in the left image, ``moved`` m how far the sheet
    moved.
    """

    R_GS: Array
    p_GS: Array
    scale: float
    scale_sd: float
    print_scale: float
    measured: bool
    fit_px: float
    moved: float
    images: int

    def target(self, p_S: Array) -> Array:
        """(3,) m in G of a point given in the sheet's nominal coordinates. Heights above the paper
        are scaled as well: the strip comes from the same printer."""
        return self.R_GS @ (self.print_scale * p_S) + self.p_GS

    def notices(self) -> list[Notice]:
        """What the user should know of print and camera."""
        out: list[Notice] = []
        percent = 100 * (self.print_scale - 1)
        size_mm = {"found_mm": 20 * self.print_scale, "percent": percent}
        if abs(self.print_scale - 1) > SCALE_LIMIT:
            out.append(warning("touch.print_scale", measured=self.measured, **size_mm))
        camera = self.scale / self.print_scale
        if self.measured and abs(camera - 1) > SCALE_LIMIT:
            out.append(warning("touch.camera_scale", percent=100 * (camera - 1)))
        if self.fit_px > FIT_LIMIT_PX:
            out.append(warning("touch.sheet_fit", fit_px=self.fit_px))
        if self.moved > MOVED_LIMIT:
            out.append(warning("touch.sheet_moved", moved_mm=1000 * self.moved))
        if not self.measured:
            out.append(notice("touch.no_ruler"))
        return out


class SheetFinder:
    """Finds the sheet's corners in images."""

    def __init__(self) -> None:
        self.sheet = TouchSheet()
        self._detector = cv2.aruco.CharucoDetector(self.sheet.board)

    def find(self, image: Image | None) -> Corners | None:
        """Corners of the frame in a BGR or grey image; None where too few are seen."""
        if image is None:
            return None
        grey = image if image.ndim == 2 else cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
        uv, ids, _, _ = self._detector.detectBoard(grey)
        if ids is None:
            return None
        ids, uv = ids.reshape(-1).astype(np.int64), uv.reshape(-1, 2).astype(float)
        keep = np.isin(ids, self.sheet.corner_ids)
        if np.count_nonzero(keep) < LEAST_CORNERS:
            return None
        order = np.argsort(ids[keep])
        return Corners(ids[keep][order], uv[keep][order])


def find_sheet(
    frames: Iterable[StereoFrame], rig: StereoRig, ruler: float | None = None
) -> SheetPose:
    """The pose of a sheet at rest, from all ``frames`` that show it.

    ``ruler`` is the length (m) that the user measured of the printed line of 260 mm. Raises
    ConfigError where no image shows the sheet.
    """
    finder = SheetFinder()
    looks = [(finder.find(f.left), finder.find(f.right)) for f in frames]
    return sheet_pose(looks, rig, ruler)


def sheet_pose(
    looks: Sequence[tuple[Corners | None, Corners | None]],
    rig: StereoRig,
    ruler: float | None = None,
) -> SheetPose:
    """As `find_sheet`, from the corners in the left and the right image of each exposure."""
    seen = [left for left, _ in looks if left is not None]
    if not seen:
        raise ConfigError(failure("touch.no_sheet"))
    left = _median(seen, rig.left)
    right = {} if rig.one_camera else _median([c for _, c in looks if c is not None], rig.right)
    scale, scale_sd = _scale(left, right, rig)
    if ruler is not None:
        print_scale = ruler / RULER
    else:
        print_scale = scale if np.isfinite(scale) else 1.0
    R_CS, p_CS, fit_px = _place(left, rig.left, print_scale)
    R_GC, p_GC = rig.pose.R_GC, rig.pose.p_GC
    return SheetPose(
        R_GS=R_GC @ R_CS,
        p_GS=R_GC @ p_CS + p_GC,
        scale=scale,
        scale_sd=scale_sd,
        print_scale=print_scale,
        measured=ruler is not None,
        fit_px=fit_px,
        moved=_moved(seen, left, rig.left, float(p_CS[2])),
        images=len(seen),
    )


def _median(looks: Sequence[Corners], camera: Camera) -> dict[int, Array]:
    """Rectified px (2,) of each corner, the median over the images that show it."""
    by_id: dict[int, list[Array]] = {}
    for corners in looks:
        for number, uv in zip(corners.ids, camera.rectify(corners.uv), strict=True):
            by_id.setdefault(int(number), []).append(uv)
    return {k: np.median(np.array(by_id[k]), axis=0) for k in sorted(by_id)}


def _scale(left: dict[int, Array], right: dict[int, Array], rig: StereoRig) -> tuple[float, float]:
    """Size of the print in the stereo camera's metres relative to the file, and its sd (Umeyama
    1991, doi:10.1109/34.88573, eq. 42)."""
    common = [k for k in left if k in right]
    if len(common) < LEAST_CORNERS:
        return float("nan"), float("nan")
    uv_left, uv_right = (np.array([side[k] for k in common]) for side in (left, right))
    p_C = rig.triangulate(uv_left, uv_right)
    points = TouchSheet().points(np.array(common))
    a, b = points - points.mean(axis=0), p_C - p_C.mean(axis=0)
    u, d, vt = np.linalg.svd(b.T @ a)
    sign = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    spread = float(np.sum(a**2))
    scale = float(d @ sign) / spread
    residual = b - scale * a @ (u @ np.diag(sign) @ vt).T
    variance = float(np.sum(residual**2)) / (3 * len(common) - 7)
    return scale, float(np.sqrt(variance / spread))


def _place(left: dict[int, Array], camera: Camera, scale: float) -> tuple[Array, Array, float]:
    """R_CS, p_CS of the sheet in the left image, independent of the right lens; RMS px."""
    ids = np.array(list(left))
    points = scale * TouchSheet().points(ids)
    uv, K = np.array(list(left.values())), np.ascontiguousarray(camera.P[:, :3])
    _, turn, place = cv2.solvePnP(points, uv, K, None, flags=cv2.SOLVEPNP_IPPE)
    turn, place = cv2.solvePnPRefineLM(points, uv, K, None, turn, place)
    expected, _ = cv2.projectPoints(points, turn, place, K, None)
    off = np.linalg.norm(expected.reshape(-1, 2) - uv, axis=1)
    return cv2.Rodrigues(turn)[0], place.reshape(3), float(np.sqrt(np.mean(off**2)))


def _moved(
    looks: Sequence[Corners], middle: dict[int, Array], camera: Camera, depth: float
) -> float:
    """The 95th percentile over images of how far the sheet was from its median place, m."""
    off = []
    for corners in looks:
        known = np.array([middle[int(k)] for k in corners.ids])
        off.append(np.linalg.norm(np.median(camera.rectify(corners.uv) - known, axis=0)))
    return float(np.percentile(off, 95)) * depth / float(camera.P[0, 0])
