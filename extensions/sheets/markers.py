"""Pages with the patches of a glove and their positions, at true scale."""

from __future__ import annotations

from itertools import groupby
from typing import Any

import numpy as np
from matplotlib.patches import Circle, Rectangle

from extensions.sheets.kinds import SheetKind
from extensions.sheets.page import FAINT, INK, MARGIN_MM, MM_PER_INCH, PAPERS_MM, Page
from tracker.glove.model import GloveModel, Marker
from tracker.hand.model import HandModel
from tracker.messages import Array

FILL = {"red": "#dc2626", "yellow": "#eab308", "green": "#16a34a", "blue": "#2563eb"}
GAP_MM, LABEL_MM, HEAD_MM = 6.0, 6.0, 26.0
MM = 1000.0
BOARD_MM = 15.0  # edge of an IMU's breakout board


def marker_pages(hand: HandModel, glove: GloveModel, paper: str = "a4") -> list[Page]:
    """Pages with the patches by segment, to cut out and sew on, and with the hand from above."""
    wide_mm, high_mm = PAPERS_MM[paper]
    pages = _patches(glove, wide_mm, high_mm)
    for title, below in (("Back of the hand", False), ("Palm side", True)):
        if any((_normal_up(hand, glove)[k] < 0) == below for k in range(len(glove.markers))):
            pages.append(_hand(hand, glove, below, (wide_mm, high_mm), title))
    return pages


def _patches(glove: GloveModel, wide_mm: float, high_mm: float) -> list[Page]:
    pages: list[Page] = []
    x_mm, y_mm = MARGIN_MM, -np.inf
    note = f"{len(glove.markers)} patches at true scale; cut along the line, from knitted cloth"
    segments = list(dict.fromkeys(m.segment for m in glove.markers))
    ordered = sorted(glove.markers, key=lambda m: (segments.index(m.segment), m.id))
    for segment, markers in groupby(ordered, key=lambda m: m.segment):
        label = segment.replace("_", " ")
        for k, marker in enumerate(markers):
            size_mm = marker.size * MM
            if k == 0 or x_mm + size_mm > wide_mm - MARGIN_MM:
                x_mm = MARGIN_MM
                y_mm -= size_mm + GAP_MM + 2 * LABEL_MM
                if y_mm < MARGIN_MM + LABEL_MM:
                    pages.append(_new_page(glove, note, wide_mm, high_mm))
                    y_mm = high_mm - HEAD_MM - LABEL_MM - size_mm - GAP_MM
                if k == 0:
                    pages[-1].text(MARGIN_MM, y_mm + size_mm + LABEL_MM - 2, label, 9, FAINT)
            _draw_patch(pages[-1], marker, x_mm + size_mm / 2, y_mm + size_mm / 2)
            pages[-1].text(x_mm, y_mm - 3, f"{marker.id} {marker.hue}", 6.5)
            x_mm += max(size_mm, 14.0) + GAP_MM
    return pages


def _new_page(glove: GloveModel, note: str, wide_mm: float, high_mm: float) -> Page:
    page = Page(wide_mm, high_mm)
    page.heading(f"Markers of the glove {glove.name} ({glove.side})", note)
    page.ruler()
    return page


def _draw_patch(page: Page, marker: Marker, x_mm: float, y_mm: float) -> None:
    half = marker.size * MM / 2
    look: dict[str, Any] = {
        "facecolor": FILL.get(marker.hue, "none"),
        "edgecolor": INK,
        "linewidth": 0.4,
    }
    if marker.shape == "square":
        corner = (x_mm - half, y_mm - half)
        page.axes.add_patch(Rectangle(corner, 2 * half, 2 * half, **look))
    else:
        page.axes.add_patch(Circle((x_mm, y_mm), half, **look))


def _rest(hand: HandModel) -> tuple[Array, Array]:
    """Rotations (S, 3, 3) and positions (S, 3) m of the flat hand in its root's frame."""
    R, p = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))[:2]
    return np.asarray(R), np.asarray(p)


def _normal_up(hand: HandModel, glove: GloveModel) -> Array:
    """Upward component (M,) of each marker's normal on the flat hand."""
    R, _ = _rest(hand)
    segment = glove.marker_segment(hand)
    return np.asarray(np.einsum("mij,mj->mi", R[segment], glove.marker_normal)[:, 2])


def _hand(
    hand: HandModel, glove: GloveModel, below: bool, paper_mm: tuple[float, float], title: str
) -> Page:
    """The flat hand with the fingers up; mirrored when seen from below."""
    page = Page(*paper_mm)
    page.heading(
        f"{title}: {glove.name} ({glove.side})",
        "Flat hand at true scale with bones and joints; numbers as on the patches",
    )
    page.ruler()
    R, p = _rest(hand)
    up = _normal_up(hand, glove)
    across = 1.0 if below else -1.0
    ends = p + np.einsum("sij,sj->si", R, np.array([[s.length, 0.0, 0.0] for s in hand.segments]))
    middle = paper_mm[0] / 2 - across * MM * (p[:, 1].min() + p[:, 1].max()) / 2

    def placed(point: Array) -> tuple[float, float]:
        return middle + across * point[1] * MM, 45.0 + point[0] * MM

    for s, segment in enumerate(hand.segments):
        (x_0, y_0), (x_1, y_1) = placed(p[s]), placed(ends[s])
        thick = max(2 * segment.radius, segment.width) * MM * 72 / MM_PER_INCH
        page.axes.plot([x_0, x_1], [y_0, y_1], color="#e5e7eb", linewidth=thick,
                       solid_capstyle="butt" if segment.width else "round", zorder=0)  # fmt: skip
        page.axes.plot([x_0, x_1], [y_0, y_1], color=FAINT, linewidth=0.6, marker=".", zorder=1)
    segment_of = glove.marker_segment(hand)
    for k, marker in enumerate(glove.markers):
        if (up[k] < 0) != below:
            continue
        s = segment_of[k]
        x_mm, y_mm = placed(p[s] + R[s] @ marker.position)
        _draw_patch(page, marker, x_mm, y_mm)
        page.axes.text(x_mm, y_mm, str(marker.id), fontsize=6, ha="center", va="center")
    for imu in () if below else glove.imus:
        s = hand.index[imu.segment]
        x_mm, y_mm = placed(p[s] + R[s] @ imu.position)
        corner = (x_mm - BOARD_MM / 2, y_mm - BOARD_MM / 2)
        outline: dict[str, Any] = {
            "fill": False,
            "linestyle": "--",
            "edgecolor": INK,
            "linewidth": 0.6,
        }
        page.axes.add_patch(Rectangle(corner, BOARD_MM, BOARD_MM, **outline))
    return page


def _sheet(hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    return marker_pages(hand, glove, paper), f"Markers of the glove {glove.name}"


MARKERS = SheetKind("markers", "marker patches and their positions", _sheet)
