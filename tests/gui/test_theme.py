"""Dressing the application."""

import ast
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QCheckBox

from app.widgets.icons import NAME, drawing
from app.widgets.measures import SPACES, TYPES
from app.widgets.view3d.view_3d import contrast_of, legible
from app.window.theme import DARK, LIGHT, style_sheet

pytestmark = pytest.mark.styled

ROOT = Path(__file__).resolve().parents[2]

COLLECTED_MEANWHILE = """
import gc
from PySide6.QtWidgets import QApplication, QLabel, QWidget
from app.window import theme

class Collector(QWidget):
    def changeEvent(self, event):
        if gc.isenabled():
            gc.collect()  # which an allocation may set off at any time
        super().changeEvent(event)

app = QApplication([])
collectors = [Collector() for _ in range(20)]
for widget in collectors:
    widget.show()
gc.set_threshold(1_000_000)
for _ in range(300):
    label = QLabel("in a ring that only the collector frees")
    label.ring = label
    label.show()
del label
theme.apply(app, "dark")
assert gc.isenabled()
assert len(app.allWidgets()) == 320
gc.collect()
print(len(app.allWidgets()))
"""


def test_the_garbage_collector_does_not_free_widgets_that_are_being_dressed():
    done = subprocess.run(
        [sys.executable, "-c", COLLECTED_MEANWHILE], cwd=ROOT, capture_output=True, text=True
    )  # the environment has QT_QPA_PLATFORM
    assert (done.returncode, done.stdout.strip()) == (0, "20"), done.stderr


def test_black_on_white_has_the_contrast_of_the_definition():
    assert contrast_of("#000000", "#FFFFFF") == 21.0


@pytest.mark.parametrize("c", [LIGHT, DARK], ids=["light", "dark"])
def test_all_text_has_the_contrast_of_wcag_aa(c):
    for ground in (c.window, c.base, c.raised):
        assert contrast_of(c.text, ground) >= 7
        assert contrast_of(c.faint, ground) >= 4.5
        assert contrast_of(c.danger, ground) >= 4.5
    for ground, text in ((c.accent, c.on_accent), c.notice, c.good, c.warning, (c.border, c.text)):
        assert contrast_of(ground, text) >= 4.5
    assert contrast_of(c.accent, c.window) >= 3  # WCAG 1.4.11, of controls


@pytest.mark.parametrize("c", [LIGHT, DARK], ids=["light", "dark"])
def test_a_ticked_box_is_a_box_of_the_accent_colour_with_a_tick_in_it(qapp, c):
    """Qt's own has no frame once the others are dressed."""
    qapp.setStyleSheet(style_sheet(c))
    box = QCheckBox()
    box.setChecked(True)
    image = box.grab().toImage()
    seen = Counter(image.pixelColor(x, y).name() for x in range(16) for y in range(image.height()))
    assert seen[c.accent.lower()] > 60  # of 144 px
    assert seen[c.on_accent.lower()] >= 3  # the middle of its strokes


@pytest.mark.long
@pytest.mark.parametrize("name", ["light", "dark"])
def test_icons_have_the_colour_of_the_words_beside_them(window, name):
    window.set_theme(name)
    action = window.commands.actions["demo"]
    assert action.property(NAME) == "flask-conical"
    image = action.icon().pixmap(32, 32).toImage()
    inked = [image.pixelColor(x, y) for x in range(32) for y in range(32)]
    solid = {c.name() for c in inked if c.alpha() == 255}
    assert solid == {window.palette().color(QPalette.ColorRole.ButtonText).name()}


def test_every_icon_is_drawn_and_its_licence_is_beside_it():
    place = ROOT / "resources" / "icons" / "lucide"
    assert "ISC License" in (place / "LICENSE").read_text()
    for path in place.glob("*.svg"):
        image = drawing(path.stem, QColor("#000000"), 32).toImage()
        inked = sum(image.pixelColor(x, y).alpha() > 128 for x in range(32) for y in range(32))
        assert inked > 30, path.stem


SPACED = {
    "setSpacing", "setContentsMargins", "setHorizontalSpacing", "setVerticalSpacing", "addSpacing",
    "setPointSize", "setPointSizeF", "FlowLayout",
}  # fmt: skip


def bare_measures(code: str) -> list[str]:
    """Calls that give a space or a size of type as a number of their own; 0 is none."""
    found = []
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Call) and name_of(node.func) in SPACED:
            given = [*node.args, *(k.value for k in node.keywords)]
            numbers = [a.value for a in given if isinstance(a, ast.Constant)]
            if any(isinstance(n, int | float) and n != 0 for n in numbers):
                found.append(ast.unparse(node))
    return found


def name_of(function: ast.expr) -> str:
    return getattr(function, "attr", getattr(function, "id", ""))


def test_a_space_that_is_on_no_scale_is_noticed():
    assert bare_measures("row.setSpacing(7)") == ["row.setSpacing(7)"]
    assert bare_measures("FlowLayout(spacing=6)") == ["FlowLayout(spacing=6)"]
    assert bare_measures("row.setContentsMargins(0, NEAR, 0, 0)") == []


@pytest.mark.long
def test_spaces_and_type_sizes_are_those_of_the_scale():
    paths = [*(ROOT / "app").rglob("*.py")]
    found = {p.name: bare_measures(p.read_text("utf-8")) for p in paths}
    assert {name: calls for name, calls in found.items() if calls} == {}


@pytest.mark.parametrize("c", [LIGHT, DARK], ids=["light", "dark"])
def test_spaces_and_type_sizes_of_thestyle_sheet_are_those_of_the_scale(c):
    sheet = style_sheet(c)
    spaces = re.findall(r"(?:padding|margin|spacing)[-a-z]*:([^;]*);", sheet)
    numbers = {int(n) for space in spaces for n in re.findall(r"(\d+)px", space)}
    assert numbers and numbers <= set(SPACES)
    sizes = {int(n) for n in re.findall(r"font-size: (\d+)pt", sheet)}
    assert sizes and sizes <= set(TYPES)


@pytest.mark.long
@pytest.mark.parametrize("c", [LIGHT, DARK], ids=["light", "dark"])
def test_what_is_written_in_the_3d_view_has_that_contrast_too(live, c):
    live.hand.view.set_background(c.scene)
    written = live.hand.view._view._labels
    assert [label.text for label in written] == ["x", "y", "z", "5 cm"]
    for label in written:
        assert contrast_of(label.colour, c.scene) >= 4.5, label.text
    assert legible(c.text, c.scene) == c.text.lower(), "what is legible stays as it is"
