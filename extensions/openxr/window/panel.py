"""The panel *OpenXR*: registers the layer, places the hand, and shows who reads it."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from html import escape
from typing import Protocol

import numpy as np
from PySide6.QtCore import QSignalBlocker, Qt, QTimer
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.host_parts import CurrentEngine, ErrorSignal
from app.engines.snapshot import Snapshot
from app.jobs.outputs import Outputs
from app.panels.panel import Panel
from app.viewmodels.states import BAD, GOOD, IDLE, WARN, StateLook
from app.widgets.measures import NEAR
from app.words import mark, tr
from extensions.openxr.extension import STREAM
from extensions.openxr.readers import Link, Reader, read_link
from extensions.openxr.registration import LayerRegistration, Registered, user_registration
from tracker.base.errors import FileError
from tracker.geometry import so3
from tracker.hand.openxr import R_BX
from tracker.messages import Array, Validity

TEST_S = 1.0
REACH = 10.0  # m
STATE_PERIOD = 5.0  # s between two readings of the registration's files


class OpenXrHost(CurrentEngine, ErrorSignal, Protocol):
    """What the panel uses of the engine host."""


class OpenXrPanel(Panel):
    period = 0.5

    def __init__(
        self,
        host: OpenXrHost,
        outputs: Outputs,
        registration: Callable[[], LayerRegistration] = user_registration,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._outputs, self._registration = outputs, registration
        self._read_at, self._layer = float("-inf"), Registered.NO
        self.layer, self.stream, self.result = QLabel(), QLabel(), QLabel()
        for label in (self.layer, self.stream, self.result):
            label.setWordWrap(True)
        self.result.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, NEAR, NEAR, NEAR)
        column.setSpacing(NEAR)
        column.addWidget(self.layer)
        column.addLayout(self._layer_buttons())
        column.addWidget(self._switch())
        column.addWidget(self.stream)
        column.addLayout(self._placement())
        column.addLayout(self._test())
        column.addWidget(self.result)
        column.addStretch(1)
        outputs.changed.connect(self._show)
        self._show()

    # --- what it contains

    def _layer_buttons(self) -> QHBoxLayout:
        self.register = QPushButton(self.tr("Register"))
        self.register.setToolTip(
            self.tr("Adds hand tracking to every OpenXR application of this user")
        )
        self.register.clicked.connect(lambda: self._change(LayerRegistration.register))
        self.unregister = QPushButton(self.tr("Unregister"))
        self.unregister.clicked.connect(lambda: self._change(LayerRegistration.unregister))
        row = QHBoxLayout()
        row.addWidget(self.register)
        row.addWidget(self.unregister)
        row.addStretch(1)
        return row

    def _switch(self) -> QCheckBox:
        self.box = QCheckBox(self.tr("Send the hand to OpenXR applications"))
        self.box.toggled.connect(partial(self._outputs.switch, STREAM.name))
        return self.box

    def _placement(self) -> QFormLayout:
        """Where Glovetrack's origin is in the application's space."""
        self.space = QComboBox()
        self.space.addItem(self.tr("Local: where the headset was at the start"), "local")
        self.space.addItem(self.tr("Stage: the middle of the floor"), "stage")
        self.space.activated.connect(lambda _i: self._set("space", self.space.currentData()))
        form = QFormLayout()
        form.addRow(self.tr("Reference space"), self.space)
        self.numbers: dict[str, QDoubleSpinBox] = {}
        for option, label, limit, suffix in (
            ("x", self.tr("To the right"), REACH, self.tr(" m")),
            ("y", self.tr("Up"), REACH, self.tr(" m")),
            ("z", self.tr("Backwards"), REACH, self.tr(" m")),
            ("yaw", self.tr("Turned to the left"), 180.0, "°"),
        ):
            number = self.numbers[option] = QDoubleSpinBox()
            number.setRange(-limit, limit)
            number.setDecimals(0 if option == "yaw" else 2)
            number.setSingleStep(5.0 if option == "yaw" else 0.05)
            number.setSuffix(suffix)
            number.setKeyboardTracking(False)
            number.valueChanged.connect(partial(self._set, option))
            form.addRow(label, number)
        self.in_front = QPushButton(self.tr("Place the hand in front of the headset"))
        self.in_front.setToolTip(
            self.tr("Hold your hand in front of you, then press: it appears there in applications")
        )
        self.in_front.clicked.connect(self._place_in_front)
        form.addRow(self.in_front)
        return form

    def _test(self) -> QHBoxLayout:
        self.test = QPushButton(self.tr("Test"))
        self.test.setToolTip(self.tr("Whether an application reads the hand"))
        self.test.clicked.connect(self._begin_test)
        row = QHBoxLayout()
        row.addWidget(self.test)
        row.addStretch(1)
        return row

    # --- what it does

    def _change(self, do: Callable[[LayerRegistration], None]) -> None:
        """Register or unregister."""
        try:
            do(self._registration())
        except FileError as error:
            self.host.error.emit(str(error))
        self._read_at = float("-inf")
        self._show()

    def _set(self, option: str, value: object) -> None:
        self._outputs.set_option(STREAM.name, option, value)

    def _place_in_front(self) -> None:
        setup = self.host.setup
        estimate = setup.tracked.latest_estimate() if setup is not None else None
        row = setup.hand.keypoint_names.index("wrist") if setup is not None else 0
        if estimate is None or estimate.keypoint_state[row] == Validity.LOST:
            self.host.error.emit(
                self.tr("The hand is not tracked, so its position is unknown. Track it first.")
            )
            return
        options = self._outputs.settings.options(STREAM)
        origin = origin_for(estimate.keypoints[row], options.space, options.yaw)
        for option, value in zip("xyz", origin, strict=True):
            self._set(option, round(value, 3))
        self._show()

    def _begin_test(self) -> None:
        before, began = read_link(), time.monotonic()
        self.test.setEnabled(False)
        self.result.setText(self.tr("Testing…"))

        def end() -> None:
            self.test.setEnabled(True)
            on = self._outputs.is_on(STREAM.name)
            elapsed = time.monotonic() - began
            shown = test_result(self._state(), on, before, read_link(), elapsed)
            _show_on(self.result, shown)

        QTimer.singleShot(round(1000 * TEST_S), self, end)

    # --- what it shows

    def _state(self) -> Registered:
        now = time.monotonic()
        if now - self._read_at > STATE_PERIOD:
            self._read_at = now
            try:
                self._layer = self._registration().state()
            except FileError:  # the system has no layers; Register reports it
                self._layer = Registered.NO
        return self._layer

    def _show(self) -> None:
        state, on = self._state(), self._outputs.is_on(STREAM.name)
        _show_on(self.layer, layer_text(state))
        self.register.setEnabled(state != Registered.YES)
        self.unregister.setEnabled(state != Registered.NO)
        _show_on(self.stream, stream_text(on, read_link()))
        options = self._outputs.settings.options(STREAM)
        with QSignalBlocker(self.box):
            self.box.setChecked(on)
        self.space.setCurrentIndex(max(self.space.findData(options.space), 0))
        for option, number in self.numbers.items():
            if not number.hasFocus():
                with QSignalBlocker(number):
                    number.setValue(float(getattr(options, option)))

    def refresh(self, view: Snapshot | None) -> None:
        self._show()


def _show_on(label: QLabel, shown: StateText) -> None:
    lines = "<br>".join(escape(line) for line in shown.text.splitlines())
    text = f'<span style="color:{shown.look.colour}">{shown.look.sign}</span> {lines}'
    if label.text() != text:
        label.setText(text)


# ---- what the panel *OpenXR* shows, from the registration and the shared memory

LAYER_TEXTS = {
    Registered.NO: mark("The layer is not registered. Applications do not find the hand."),
    Registered.YES: mark("The layer is registered. Applications find the hand when they start."),
    Registered.OLD: mark("The layer of another version is registered. Register it again."),
    Registered.BROKEN: mark("The registered layer is damaged. Register it again."),
}
LAYER_LOOKS = {
    Registered.NO: IDLE,
    Registered.YES: GOOD,
    Registered.OLD: WARN,
    Registered.BROKEN: BAD,
}


IN_FRONT = {"local": np.array([0.0, -0.3, -0.4]), "stage": np.array([0.0, 1.1, -0.4])}
"""m, where a wrist is in front of the wearer, by the reference space."""


@dataclass(frozen=True)
class StateText:
    """A sign with its colour, and a sentence."""

    look: StateLook
    text: str


def origin_for(wrist_G: Array, space: str, yaw_deg: float) -> tuple[float, float, float]:
    """Position (m) of Glovetrack's origin with which a wrist (3,) m is `IN_FRONT`."""
    wrist = so3.ry(np.deg2rad(yaw_deg)) @ (wrist_G @ R_BX)
    x, y, z = (IN_FRONT.get(space, IN_FRONT["local"]) - wrist).tolist()
    return x, y, z


def layer_text(found: Registered) -> StateText:
    return StateText(LAYER_LOOKS[found], tr(LAYER_TEXTS[found]))


def stream_text(on: bool, link: Link | None) -> StateText:
    """Whether the hand is sent, and which applications read it now."""
    if not on:
        return StateText(IDLE, tr("The hand is not sent."))
    if link is None or not link.running:
        return StateText(IDLE, tr("The hand is sent as soon as tracking runs."))
    names = [r.name or tr("unnamed") for r in link.readers if r.is_reading(link.now_ns)]
    if not names:
        return StateText(WARN, tr("The hand is sent. No application reads it now."))
    return StateText(GOOD, tr("The hand is sent and read by {}.").format(", ".join(names)))


def test_result(
    found: Registered, on: bool, before: Link | None, after: Link | None, seconds: float
) -> StateText:
    """Whether an application read the hand between two states of the memory, ``seconds`` apart."""
    if found != Registered.YES:
        return layer_text(found)
    if not on or after is None or not after.running:
        return StateText(BAD, tr("Nothing is sent: tick the stream and start tracking, then test."))
    counts = {r.process: r for r in before.readers} if before is not None else {}
    reading = [r for r in after.readers if r.is_reading(after.now_ns)]
    if reading:
        lines = [_rate(r, counts.get(r.process), seconds) for r in reading]
        return StateText(GOOD, "\n".join(lines))
    if after.readers:
        last = max(after.readers, key=lambda r: r.last_ns)
        ago = (after.now_ns - last.last_ns) / 1e9
        text = tr("No application reads the hand now. The last one was {}, {:.0f} s ago.")
        return StateText(WARN, text.format(last.name, ago))
    return StateText(
        WARN,
        tr(
            "No application has read the hand. Start an application with hand tracking; one that "
            "was running before the layer was registered must be started again."
        ),
    )


def _rate(now: Reader, before: Reader | None, seconds: float) -> str:
    readings = now.readings - (before.readings if before is not None else 0)
    active = now.active - (before.active if before is not None else 0)
    text = (
        tr("{} reads the hand {:.0f} times per second.")
        if active
        else tr("{} asks for the hand {:.0f} times per second, but the hand is lost.")
    )
    return text.format(now.name or tr("unnamed"), readings / seconds)
