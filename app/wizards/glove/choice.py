"""Selection of the glove: its port, its file, the side, the hand."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.storage.bound_gloves import BoundGlove, bound
from app.storage.settings import AppSettings, wearer_of
from app.widgets.question import answer
from app.words import error_text, notice_text, tr
from tracker.base.errors import GlovetrackError
from tracker.base.toml_reader import read_toml
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.sensors.discovery import PortReport, latency_advice
from tracker.sensors.protocol import BAUD, BAUDS

SIMULATED = "simulated"
SESSION = "session"
USUAL = {"left": "vist-small-left", "right": library.DEFAULT_GLOVE}
"""Default glove file of each side."""


class ChoicePage(QWidget):
    """``models()``: the selected hand and glove; ``port()``: a path, `SIMULATED` or `SESSION`."""

    changed = Signal()
    search = Signal()

    def __init__(self, settings: AppSettings, wearers: list[str], with_session: bool) -> None:
        super().__init__()
        self._with_session, self._settings = with_session, settings
        self.ports, self.side = QComboBox(), QComboBox()
        self.gloves, self.hands = QComboBox(), QComboBox()
        self.wearers = QComboBox()
        self.wearers.addItem(self.tr("New wearer"), "")
        for name in wearers:
            self.wearers.addItem(name, name)
        self.again = QPushButton(self.tr("&Search again"))
        self.again.clicked.connect(self.search)
        self.other = QPushButton(self.tr("&Other port…"))
        self.other.clicked.connect(self._ask_port)
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setProperty("role", "faint")
        self.speed = QComboBox()
        self.speed.addItem(self.tr("Automatic"), 0)
        for baud in BAUDS:
            self.speed.addItem(self.tr("{} baud").format(baud), baud)
        self.speed.setCurrentIndex(max(0, self.speed.findData(settings.baud)))
        self._answered_at: dict[str, int] = {}
        self._numbers: dict[str, int] = {}  # numbers of the gloves that responded, by port
        self.side.addItem(self.tr("Right hand"), "right")
        self.side.addItem(self.tr("Left hand"), "left")
        self._lay_out()
        self.side.setCurrentIndex(max(0, self.side.findData(_side("gloves", settings.glove))))
        self._fill(settings.glove, settings.hand)
        self.show_ports([], SESSION if with_session else settings.port)
        self._show_wearer()
        self.side.currentIndexChanged.connect(lambda _i: self._fill("", ""))
        self.side.currentIndexChanged.connect(lambda _i: self._show_wearer())
        self.ports.currentIndexChanged.connect(lambda _i: self._recall())
        for box in (self.gloves, self.hands, self.ports, self.speed):
            box.currentIndexChanged.connect(lambda _i: self.changed.emit())

    def _lay_out(self) -> None:
        port_row = QHBoxLayout()
        port_row.addWidget(self.ports, 1)
        port_row.addWidget(self.again)
        port_row.addWidget(self.other)
        form = QFormLayout()
        port_label = QLabel(self.tr("&Port"))
        port_label.setBuddy(self.ports)
        form.addRow(port_label, port_row)
        form.addRow(self.tr("S&peed"), self.speed)
        form.addRow(self.tr("&Side"), self.side)
        form.addRow(self.tr("&Glove file"), self.gloves)
        form.addRow(self.tr("&Hand file"), self.hands)
        form.addRow(self.tr("&Wearer"), self.wearers)
        column = QVBoxLayout(self)
        column.addLayout(form)
        column.addWidget(self.words)
        column.addStretch(1)

    def _fill(self, glove: str, hand: str) -> None:
        """List only files of the selected side."""
        side = self.side.currentData()
        for box, kind, chosen in ((self.gloves, "gloves", glove), (self.hands, "hands", hand)):
            box.blockSignals(True)
            box.clear()
            box.addItems([n for n in library.names(kind) if _side(kind, n) == side])
            usual = USUAL.get(side, "") if kind == "gloves" else ""
            box.setCurrentIndex(max(0, box.findText(chosen or usual)))
            box.blockSignals(False)
        if not glove:
            self._match_hand()
        self.changed.emit()

    def _show_wearer(self) -> None:
        """Select the last wearer of a glove of this side."""
        name = wearer_of(self._settings, str(self.side.currentData()))
        self.wearers.setCurrentIndex(max(0, self.wearers.findData(name)))

    def _match_hand(self) -> None:
        """Select the hand file that the glove file refers to."""
        try:
            hand, _ = library.load(self.gloves.currentText())
        except GlovetrackError:
            return  # the error is shown when the glove is used
        self.hands.setCurrentIndex(max(0, self.hands.findText(hand.name)))

    def models(self) -> tuple[HandModel, GloveModel] | None:
        """None, with the reason on the page, if the files do not match."""
        try:
            return library.load(self.gloves.currentText(), self.hands.currentText())
        except GlovetrackError as error:
            self.words.setText(error_text(error))
            return None

    def port(self) -> str:
        return str(self.ports.currentData() or "")

    def glove_id(self) -> int | None:
        """Number of the glove at the selected port; None if it has not reported one."""
        return self._numbers.get(self.port())

    def glove_name(self, number: int | None) -> str:
        """Display name of the glove at the selected port; ``number`` is the one it reports."""
        port = self.port()
        if port == SIMULATED:
            return self.tr("Simulated glove")
        if port == SESSION:
            return self.tr("Glove {} in use").format(number) if number else self.tr("Glove in use")
        if number:
            return self.tr("Glove {} at {}").format(number, port)
        return self.tr("Glove at {}").format(port)

    def bound(self) -> BoundGlove:
        """The settings to store for this glove."""
        return BoundGlove(
            str(self.side.currentData()),
            self.gloves.currentText(),
            self.hands.currentText(),
            str(self.wearers.currentData()),
        )

    def _recall(self) -> None:
        """Restore side, files and wearer of a glove that was set up before."""
        known = bound(self._settings, self.glove_id())
        if known is None or self.side.findData(known.side) < 0:
            return
        self.side.setCurrentIndex(self.side.findData(known.side))
        self._fill(known.glove, known.hand)
        self.wearers.setCurrentIndex(max(0, self.wearers.findData(known.wearer)))

    def baud(self) -> int:
        """The selected speed; 0 for automatic."""
        return int(self.speed.currentData() or 0)

    def baud_of_port(self) -> int:
        """The speed at which the selected port is read."""
        return self.baud() or self._answered_at.get(self.port(), BAUD)

    def _ask_port(self) -> None:
        words = self.tr("A port that is not on USB, such as /dev/rfcomm0 or COM7:")
        path = answer(self, self.tr("Other port"), words)
        if path:
            self.add_port(path)

    def add_port(self, path: str) -> None:
        """Add and select a port that has not been queried."""
        self.words.clear()  # messages about other ports do not apply
        self.ports.insertItem(0, path, path)
        self.ports.setCurrentIndex(0)

    def show_searching(self) -> None:
        self.words.setText(self.tr("Looking for gloves…"))
        self.again.setEnabled(False)

    def show_ports(self, reports: list[PortReport], last: str) -> None:
        """List gloves that responded first, then other ports."""
        self.again.setEnabled(True)
        before = self.port() or last
        self.ports.blockSignals(True)
        self.ports.clear()
        if self._with_session:
            self.ports.addItem(self.tr("The glove in use"), SESSION)
        for report in reports:
            if report.is_glove:
                self._answered_at[report.path] = report.baud
                if report.hello is not None:
                    self._numbers[report.path] = report.hello.glove_id
                self.ports.addItem(_title(report), report.path)
        if before not in ("", SESSION, SIMULATED) and self.ports.findData(before) < 0:
            self.ports.addItem(before, before)  # it may be reconnected, and is not on every list
        self.ports.addItem(self.tr("Simulated glove (for practice)"), SIMULATED)
        self.ports.setCurrentIndex(max(0, self.ports.findData(before)))
        self.ports.blockSignals(False)
        self.words.setText("\n".join(_remarks(reports, self.port())))
        self._recall()
        self.changed.emit()


def _title(report: PortReport) -> str:
    hello = report.hello
    if hello is None:
        return tr("{}: a glove that sends data").format(report.path)
    if report.baud == BAUD:
        return tr("{}: glove {}, {} IMUs").format(report.path, hello.glove_id, hello.imu_count)
    words = tr("{}: glove {}, {} IMUs, {} baud")
    return words.format(report.path, hello.glove_id, hello.imu_count, report.baud)


def _remarks(reports: list[PortReport], chosen: str) -> list[str]:
    """Messages about the ports; the ``chosen`` one is in use and was not queried."""
    if not reports and chosen == SIMULATED:
        return [
            tr(
                "No glove was found on any USB port. Plug the glove in, then choose Search again. "
                "Without one, the simulated glove lets you try these pages."
            )
        ]
    if not reports:
        return [tr("No other glove was found on any USB port.")]
    advice = [latency_advice(r.path) for r in reports if r.is_glove]
    found = (*(r.problem for r in reports), *advice)
    return [notice_text(what) for what in found if what is not None]


def _side(kind: str, name: str) -> str:
    """``side`` of a hand or glove file; "" if it cannot be read."""
    try:
        return read_toml(library.text(kind, name), name).text("side")
    except GlovetrackError:
        return ""
