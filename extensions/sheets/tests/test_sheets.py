"""Sheets to build a glove with: true scale, every patch once, nothing over the paper's edge."""

from __future__ import annotations

import re
from pathlib import Path

import cv2
import numpy as np
import pytest
from matplotlib.patches import Circle

from extensions.sheets.board import board_page
from extensions.sheets.markers import marker_pages
from extensions.sheets.page import PAPERS_MM
from extensions.sheets.wiring import SELECT_PINS, wiring_page
from tracker.calibration.stereo.board import BoardSpec
from tracker.cli import main
from tracker.glove import library

POINTS_PER_MM = 72 / 25.4


def circles(page) -> list[Circle]:
    return [p for p in page.axes.patches if isinstance(p, Circle)]


@pytest.mark.long
@pytest.mark.parametrize("paper", PAPERS_MM)
@pytest.mark.parametrize("name", library.names("gloves"))
def test_every_patch_is_printed_once_at_true_size(name: str, paper: str) -> None:
    hand, glove = library.load(name)
    pages = marker_pages(hand, glove, paper)
    cut = [p for p in pages if "patches at true scale" in p.axes.texts[1].get_text()]
    drawn = [(c, page) for page in cut for c in circles(page)]
    assert len(drawn) == sum(m.shape == "circle" for m in glove.markers)
    sizes = sorted(1000 * m.size for m in glove.markers if m.shape == "circle")
    assert sorted(2 * c.radius for c, _ in drawn) == pytest.approx(sizes)
    for page in pages:
        wide_mm, high_mm = PAPERS_MM[paper]
        for c in circles(page):
            x, y = c.center
            assert c.radius < x < wide_mm - c.radius and c.radius < y < high_mm - c.radius
    for page in cut:
        places = np.array([[*c.center, c.radius] for c in circles(page)])
        for i, a in enumerate(places):
            for b in places[i + 1 :]:
                assert np.hypot(*(a - b)[:2]) > a[2] + b[2]


def test_the_hand_shows_each_patch_where_the_glove_has_it() -> None:
    """Two markers of the dorsum lie as far apart on the paper as on the glove, from above."""
    hand, glove = library.load()
    above = [
        p for p in marker_pages(hand, glove) if "Back of the hand" in p.axes.texts[0].get_text()
    ]
    number = {t.get_text(): np.array(t.get_position()) for t in above[0].axes.texts[2:]}
    dorsal = [m for m in glove.markers if m.segment == "dorsum" and m.normal[2] > 0.5]
    a, b = dorsal[0], dorsal[1]
    apart = 1000 * np.hypot(*(a.position - b.position)[:2])
    assert np.hypot(*(number[str(a.id)] - number[str(b.id)])) == pytest.approx(apart)


def test_the_pdf_has_the_paper_s_size_and_is_the_same_each_time(tmp_path: Path) -> None:
    first, again = tmp_path / "a.pdf", tmp_path / "b.pdf"
    for path in (first, again):
        assert main(["print", "markers", "-o", str(path), "--paper", "letter"]) == 0
    assert first.read_bytes() == again.read_bytes()
    box = re.search(rb"/MediaBox \[ 0 0 ([0-9.]+) ([0-9.]+) \]", first.read_bytes())
    assert box is not None
    size_mm = [float(x) / POINTS_PER_MM for x in box.groups()]
    assert size_mm == pytest.approx(PAPERS_MM["letter"], abs=0.05)


@pytest.mark.long
def test_the_board_is_found_on_its_page_in_its_size() -> None:
    """OpenCV measures the square on the page, drawn at ten pixels a millimetre."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    page, spec = board_page(), BoardSpec()
    page.figure.set_dpi(254)
    canvas = FigureCanvasAgg(page.figure)
    canvas.draw()
    grey = cv2.cvtColor(np.asarray(canvas.buffer_rgba())[..., :3].copy(), cv2.COLOR_RGB2GRAY)
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_250)
    size = (spec.columns, spec.rows)
    board = cv2.aruco.CharucoBoard(size, 0.025, 0.75 * 0.025, dictionary)
    corners = cv2.aruco.CharucoDetector(board).detectBoard(grey)[0].reshape(-1, 2)
    assert len(corners) == spec.corner_count
    side_mm = np.linalg.norm(corners[1] - corners[0]) / 10
    assert side_mm == pytest.approx(25.0, abs=0.05)


def test_the_wiring_shows_each_select_line_with_its_imu() -> None:
    glove = library.load()[1]
    words = " ".join(t.get_text() for t in wiring_page(glove).axes.texts)
    assert all(pin in words for pin in SELECT_PINS)
    assert all(imu.name.replace("_", " ") in words for imu in glove.imus)


def test_existing_files_are_not_replaced(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "board.pdf"
    path.write_text("mine")
    assert main(["print", "board", "-o", str(path)]) == 1
    assert path.read_text() == "mine" and "--force" in capsys.readouterr().err
