"""Contents of the stereo calibration pages: rows, values and overlays."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.viewmodels.states import BAD, GOOD, IDLE, SKY, WARN, StateLook
from app.widgets.image_shapes import Cross, ImageLine, Shape
from app.words import local, mark, notice_text, tr
from tracker.base.notices import Notice
from tracker.calibration.stereo.checks import (
    Extrinsics,
    known_baseline_problems,
    quality_problems,
    rig_problems,
)
from tracker.calibration.stereo.collect import ExposureResult
from tracker.calibration.stereo.coverage import Coverage, CoverageParams, advice, shape_of
from tracker.calibration.stereo.solve import Solution
from tracker.calibration.stereo.verify import Verification
from tracker.calibration.stereo.views import Corners, StereoView
from tracker.geometry import so3
from tracker.vision.rig import Camera, StereoRig

ANSWERS = {
    ExposureResult.TAKEN: mark("View taken."),
    ExposureResult.MOVING: mark("Hold the board still."),
    ExposureResult.KNOWN: mark("There is already a similar view. Move the board."),
    ExposureResult.FULL: mark("There are enough views."),
}
VERDICTS: dict[str, StateLook] = {"good": GOOD, "usable": WARN, "refused": BAD, "waiting": IDLE}

SUSPECT_PX = 1.0
"""A view with a larger error was blurred, or the board was bent."""


@dataclass(frozen=True)
class Meter:
    """One value relative to its requirement; ``share`` 0..1."""

    name: str
    text: str
    share: float


def meters(cover: Coverage, params: CoverageParams | None = None) -> list[Meter]:
    """Progress of the collection in four values."""
    p = params or CoverageParams()
    return [
        Meter(tr("Views"), tr("{} of {}").format(cover.views, p.views), cover.views / p.views),
        Meter(
            tr("Image area"),
            tr("{:.0f} of {:.0f} %").format(100 * cover.area, 100 * p.area),
            cover.area / p.area,
        ),
        Meter(
            tr("Tilted views"),
            tr("{} of {}").format(cover.tilted, p.tilted),
            cover.tilted / p.tilted,
        ),
        Meter(
            tr("Distance range"),
            tr("{:.2f} ({:.2f} required)").format(local(cover.distances), local(p.distances)),
            (cover.distances - 1) / (p.distances - 1),
        ),
    ]


def exposure_text(answer: ExposureResult, problem: Notice | None, cover: Coverage) -> str:
    """The message below the images."""
    more = advice(cover)
    if more is None:
        return tr("There are enough views. Press Calibrate.")
    if answer is ExposureResult.ABSENT:
        return notice_text(problem) if problem is not None else ""
    if answer is ExposureResult.TAKEN:
        return f"{tr(ANSWERS[answer])} {notice_text(more)}"
    return tr(ANSWERS[answer])


def corner_shapes(corners: Corners | None, good: bool) -> list[Shape]:
    """A cross at each detected corner."""
    if corners is None:
        return []
    colour = GOOD.colour if good else WARN.colour
    return [Cross(u, v, colour) for u, v in corners.uv.tolist()]


def row_lines(camera: Camera, corners: Corners | None, width: int) -> list[Shape]:
    """Lines through a few corners of a rectified image: the same corner is on the same row."""
    if corners is None or len(corners) == 0:
        return []
    rows = camera.rectify(corners.uv)[:: max(1, len(corners) // 6), 1]
    return [ImageLine(0.0, v, float(width), v, SKY) for v in rows.tolist()]


def view_name(index: int, view: StereoView, error_px: float) -> str:
    """Name of a view in the list; ``error_px`` is NaN without a calibration."""
    tilt_deg = np.rad2deg(shape_of(view).tilt)
    words = tr("{}: {} corners, tilted {:.0f}°").format(index + 1, len(view.ids), tilt_deg)
    if np.isnan(error_px):
        return words
    sign = BAD.sign if error_px > SUSPECT_PX else GOOD.sign
    off = tr("{}, error {:.2f} px").format(words, local(error_px))
    return f"{sign} {off}"


@dataclass(frozen=True)
class ViewRow:
    """Reprojection errors of one view, in each image."""

    name: str
    errors: tuple[str, ...]
    look: StateLook
    state: str


def view_rows(solution: Solution) -> list[ViewRow]:
    """All views; rejected ones are marked."""
    used = set(solution.used)
    return [
        ViewRow(
            str(i + 1),
            tuple(f"{local(e):.2f}" for e in errors),
            GOOD if i in used else BAD,
            tr("used") if i in used else tr("rejected: inconsistent with the others"),
        )
        for i, errors in enumerate(solution.error.tolist())
    ]


def problems(solution: Solution, cover: Coverage, baseline: float = 0.0) -> list[Notice]:
    """Why a solution is rejected; empty if it can be checked.

    ``baseline``: known distance of the lenses, m; 0 if unknown.
    """
    rig = Extrinsics(solution.left, solution.right, solution.R, solution.T)
    found = rig_problems(rig) or known_baseline_problems(rig, baseline)
    return found or quality_problems(solution, cover)


def solution_figures(solution: Solution) -> list[tuple[str, str]]:
    """Names and values of a solution."""
    focal = [
        f"{local(camera.K[0, 0]):.1f} px ± {local(100 * sd):.2f} %"
        for camera, sd in zip(solution.cameras, solution.focal_sd, strict=True)
    ]
    views = tr("{} used, {} rejected").format(len(solution.used), len(solution.dropped))
    corners = (tr("Error over all corners"), f"{local(solution.rms_px):.3f} px")
    if solution.right is None:
        return [corners, (tr("Focal length"), focal[0]), (tr("Views"), views)]
    turn_deg = np.rad2deg(np.linalg.norm(so3.log(solution.R)))
    return [
        corners,
        (
            tr("Baseline"),
            f"{local(1000 * float(np.linalg.norm(solution.T))):.2f} mm",
        ),
        (tr("Relative rotation"), f"{local(turn_deg):.2f}°"),
        (tr("Focal length, left"), focal[0]),
        (tr("Focal length, right"), focal[1]),
        (tr("Views"), views),
    ]


def rig_figures(rig: StereoRig) -> list[tuple[str, str]]:
    """Names and values of a calibration from a file."""
    if rig.one_camera:
        return [
            (tr("Image"), tr("{} by {} px").format(rig.left.width, rig.left.height)),
            (tr("Focal length"), f"{local(rig.left.K[0, 0]):.1f} px"),
        ]
    return [
        (tr("Image"), tr("{} by {} px").format(rig.left.width, rig.left.height)),
        (tr("Baseline"), f"{local(1000 * rig.baseline):.2f} mm"),
        (tr("Focal length, left"), f"{local(rig.left.K[0, 0]):.1f} px"),
        (tr("Focal length, right"), f"{local(rig.right.K[0, 0]):.1f} px"),
    ]


def check_figures(found: Verification) -> list[tuple[str, str]]:
    """Combined errors of all new views; a vertical offset means that a camera was tilted."""
    if len(found.off_px) == 0:
        return []
    if found.one_camera:
        return [(tr("Largest corner error"), f"{local(found.worst_px):.2f} px")]
    return [
        (tr("Largest corner error"), f"{local(found.worst_px):.2f} px"),
        (tr("Vertical offset"), f"{local(found.offset_px):+.2f} px"),
    ]


def check_rows(found: Verification) -> list[tuple[str, str]]:
    """Each new view and the error of its corners."""
    return [(str(i + 1), f"{local(e):.2f} px") for i, e in enumerate(found.off_px.tolist())]


def split_fresh(views: Sequence[StereoView]) -> tuple[list[StereoView], list[StereoView]]:
    """Split images from a folder: every third one is reserved for the check."""
    return [v for i, v in enumerate(views) if i % 3 != 2], list(views[2::3])
