"""The wiring diagram of the microcontroller and its parts (resources/firmware/README.md)."""

from __future__ import annotations

from typing import Any, NamedTuple

from matplotlib.patches import FancyBboxPatch

from extensions.sheets.kinds import SheetKind
from extensions.sheets.page import FAINT, INK, MARGIN_MM, PAPERS_MM, Page
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel

SELECT_PINS = ("A0", "A1", "A2", "A3", "A4", "A5", "D10")
MOTOR_PINS = ("D6", "D5", "D3")
BUS, SELECT, BACK, POWER, MOTOR = "#2563eb", "#7c3aed", "#16a34a", "#dc2626", "#b45309"


class Box(NamedTuple):
    """A part with its lower left corner and its size, mm."""

    x: float
    y: float
    wide: float
    high: float
    title: str


class Wire(NamedTuple):
    """From a height (mm) on one box's right side to a height on another's left side."""

    of: Box
    y: float
    to: Box
    at: float
    ink: str
    pin: str = ""
    end: str = ""


def wiring_page(glove: GloveModel, paper: str = "a4") -> Page:
    """The page; the glove file defines which IMU is on which select line."""
    wide_mm, high_mm = PAPERS_MM[paper]
    page = Page(wide_mm, high_mm)
    page.heading(
        f"Wiring of the glove {glove.name}",
        "Arduino Nano, level shifters, IMUs on one SPI bus; motors and battery are optional",
    )
    nano = Box(MARGIN_MM, 56, 34, 202, "Arduino Nano\n5 V, 16 MHz")
    down = Box(80, 98, 34, 160, "2 × 74HC4050\n5 V to 3.3 V")
    up = Box(80, 74, 34, 18, "74AHCT125\n3.3 V to 5 V")
    power = Box(80, 56, 34, 12, "3.3 V regulator")
    imus = [
        Box(145, 224 - 22 * k, 50, 16, f"IMU {k}: {imu.name.replace('_', ' ')}")
        for k, imu in enumerate(glove.imus[: len(SELECT_PINS)])
    ]
    for box in (nano, down, up, power, *imus):
        _draw(page, box)
    wires = [
        Wire(nano, 252, down, 252, BUS, "D13 SCK"),
        Wire(nano, 245, down, 245, BUS, "D11 MOSI"),
    ]
    for pin, imu in zip(SELECT_PINS, imus, strict=False):
        y = imu.y + 11  # straight, so that wires do not overlap
        wires.append(Wire(nano, y, down, y, SELECT, pin))
        wires.append(Wire(down, y, imu, y, SELECT, end="NCS"))
    wires.append(Wire(nano, 84, up, 84, BACK, "D12 MISO"))
    wires.append(Wire(nano, 61, power, 61, POWER, "5V"))
    for wire in wires:
        _connect(page, wire)
    _buses(page, down, up, power, imus)
    _rest(page)
    return page


def _draw(page: Page, box: Box) -> None:
    look: dict[str, Any] = {"facecolor": "#f3f4f6", "edgecolor": INK, "linewidth": 0.8}
    rounded, corner = "round,pad=0,rounding_size=2", (box.x, box.y)
    page.axes.add_patch(FancyBboxPatch(corner, box.wide, box.high, boxstyle=rounded, **look))
    page.axes.text(
        box.x + box.wide / 2, box.y + box.high / 2, box.title, fontsize=8, ha="center", va="center"
    )


def _connect(page: Page, wire: Wire) -> None:
    x_0, x_1 = wire.of.x + wire.of.wide, wire.to.x
    middle = (x_0 + x_1) / 2
    page.axes.plot([x_0, middle, middle, x_1], [wire.y, wire.y, wire.at, wire.at],
                   color=wire.ink, linewidth=1.0)  # fmt: skip
    if wire.pin:
        page.text(x_0 + 1.5, wire.y + 2, wire.pin, 6.5, wire.ink)
    if wire.end:
        page.text(x_1 + 1.5, wire.at, wire.end, 5.5, wire.ink)


def _buses(page: Page, down: Box, up: Box, power: Box, imus: list[Box]) -> None:
    """Draw the lines that all IMUs share, from the right, each in its colour."""
    right = imus[0].x + imus[0].wide
    for j, (name, ink, source) in enumerate(
        (("SCL, SDA", BUS, down), ("AD0", BACK, up), ("VCC 3.3 V", POWER, power))
    ):
        x, foot = right + 4 + 3 * j, 57.0 - 4 * j
        page.axes.plot([x, x], [foot, imus[0].y + 13 - 4 * j], color=ink, linewidth=1.0)
        for imu in imus:
            page.axes.plot([right, x], [imu.y + 13 - 4 * j] * 2, color=ink, linewidth=1.0)
        start = source.x + source.wide
        y = source.y + 3
        page.axes.plot([start, start + 4 + 3 * j, start + 4 + 3 * j, x], [y, y, foot, foot],
                       color=ink, linewidth=1.0)  # fmt: skip
        page.text(start + 16, foot + 1.8, f"{name} of all IMUs", 6.5, ink)


def _rest(page: Page) -> None:
    lines = (
        "Connect all grounds. 100 nF at each IMU. 10 kΩ from each NCS to 3.3 V.",
        "Motors: " + ", ".join(MOTOR_PINS) + " each through 22 Ω to the gate of a 2N7002, "
        "1N4148 across the motor.",
        "Battery: 300 kΩ from its plus to A7, 100 kΩ from A7 to ground.",
        "Keep the wires to a fingertip below 30 cm.",
    )
    for k, line in enumerate(lines):
        page.text(MARGIN_MM, 40 - 6 * k, line, 8, FAINT if k == len(lines) - 1 else INK)


def _sheet(_hand: HandModel, glove: GloveModel, paper: str) -> tuple[list[Page], str]:
    return [wiring_page(glove, paper)], f"Wiring of the glove {glove.name}"


WIRING = SheetKind("wiring", "the wiring", _sheet)
