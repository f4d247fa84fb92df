"""The transport of a replay: timeline, play, step, range, loop and speed."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QBoxLayout,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QToolButton,
    QWidget,
)

from app.engines.protocols import Player
from app.viewmodels.gaps import INTERPOLATED
from app.viewmodels.log import KINDS, kind_of, words_of
from app.viewmodels.recording import position_text
from app.widgets.measures import TIGHT
from app.widgets.one_line import OneLine
from app.widgets.timeline import Mark, TimelineBar
from app.words import local, tr
from tracker.messages import Event

SAME_PLACE = 0.6  # s; during playback the position soon passes a note that was jumped to
SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)


class TransportBar(QWidget):
    """Visible while there is a player. ``live_requested``: return to live tracking."""

    live_requested = Signal()
    removed = Signal(str, object)  # a message, and a function that undoes the change

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._player: Player | None = None
        self.timeline = TimelineBar()
        self.timeline.setAccessibleName(self.tr("Position in the session"))
        self.timeline.seek_requested.connect(self.seek)
        self.timeline.stepped.connect(self.step)
        self.timeline.range_changed.connect(self.set_range)
        self._lines = QBoxLayout(QBoxLayout.Direction.TopToBottom, self)
        self._lines.setContentsMargins(0, 0, 0, 0)
        self._lines.setSpacing(TIGHT)
        self._lines.addWidget(self.timeline, 2)
        self._lines.addLayout(self._foot(), 3)
        self.set_player(None)

    def put_in_one_line(self, on: bool) -> None:
        """Place the timeline next to the buttons, for a low and wide window."""
        beside, above = QBoxLayout.Direction.LeftToRight, QBoxLayout.Direction.TopToBottom
        self._lines.setDirection(beside if on else above)

    def _foot(self) -> QHBoxLayout:
        """The buttons and the position."""
        self.position = QLabel()
        self.live_button = QToolButton()
        self.live_button.setText(self.tr("Live"))
        self.live_button.setToolTip(self.tr("Return to live tracking (Ctrl+L)"))
        self.live_button.clicked.connect(self.live_requested)
        self.live_button.hide()
        row = QHBoxLayout()
        row.setSpacing(TIGHT)
        row.addWidget(self.live_button)
        row.addWidget(self._buttons(), 1)
        self.interpolated = QLabel(f"{INTERPOLATED.sign} {tr(INTERPOLATED.word)}")
        self.interpolated.setToolTip(self.tr("A filled gap: interpolated, not measured"))
        self.interpolated.hide()
        row.addWidget(self.interpolated)
        row.addWidget(self.position)
        return row

    def _buttons(self) -> OneLine:
        self.play_button = QToolButton()
        self.loop_button = QToolButton()
        self.loop_button.setCheckable(True)
        row = OneLine()
        buttons = (
            (self.play_button, self.tr("Pause"), self.tr("Ctrl+Space"), self.toggle),
            (QToolButton(), "◂", self.tr("Previous image (,)"), lambda: self.step(-1)),
            (QToolButton(), "▸", self.tr("Next image (.)"), lambda: self.step(1)),
            (QToolButton(), "◂✎", self.tr("Previous note (Ctrl+,)"), lambda: self.jump(-1)),
            (QToolButton(), "✎▸", self.tr("Next note (Ctrl+.)"), lambda: self.jump(1)),
            (QToolButton(), self.tr("In"), self.tr("Set the start of the range (I)"), self.set_in),
            (QToolButton(), self.tr("Out"), self.tr("Set the end of the range (O)"), self.set_out),
            (QToolButton(), self.tr("Whole"), self.tr("Clear the range"), self.clear_range),
            (self.loop_button, self.tr("Loop"), self.tr("Repeat the range (L)"), self._loop),
        )
        for button, text, tip, slot in buttons:
            button.setText(text)
            button.setToolTip(tip)
            button.setAccessibleName(tip if len(text) <= 2 and not text.isalpha() else text)
            button.clicked.connect(slot)
            row.add(button)
        self.speed = QComboBox()
        self.speed.setAccessibleName(self.tr("Speed"))
        for speed in SPEEDS:
            self.speed.addItem(f"{local(speed):g}×", speed)
        self.speed.setCurrentIndex(SPEEDS.index(1.0))
        self.speed.currentIndexChanged.connect(self._set_speed)
        row.add(self.speed)
        return row

    def offer_live(self, on: bool) -> None:
        """Set whether live tracking can be returned to."""
        self.live_button.setVisible(on)

    def set_player(self, player: Player | None) -> None:
        """Show a session from its start; None without one."""
        self._player = player
        self.setVisible(player is not None)
        if player is None:
            return
        noted = [(at, event, words_of(event)) for at, event in player.events]
        marks = [_mark(at, event, words) for at, event, words in noted if words]
        self.timeline.show_session(player.duration, marks)
        self.loop_button.setChecked(False)
        self.speed.setCurrentIndex(SPEEDS.index(1.0))
        self.refresh()

    # --- actions of the user

    def toggle(self) -> None:
        if self._player is not None:
            self._player.play(not self._player.playing)
            self.refresh()

    def step(self, images: int) -> None:
        if self._player is not None:
            self._player.step(images)

    def seek(self, position: float) -> None:
        if self._player is not None:
            self._player.seek(position)

    def jump(self, by: int) -> None:
        """Jump to the next note, or to the previous one if ``by`` is negative."""
        if self._player is None:
            return
        here = self._player.position
        notes = [at for at, event in self._player.events if event.kind == "note"]
        if by > 0:
            beyond = [at for at in notes if at > here + 1e-3]
        else:
            beyond = [at for at in notes if at < here - SAME_PLACE]
        if beyond:
            self.seek(min(beyond) if by > 0 else max(beyond))

    def set_range(self, start: float, stop: float) -> None:
        if self._player is not None:
            self._player.set_range(start, stop)
            self.refresh()

    def set_in(self) -> None:
        """Set the start of the range to the position; an earlier out point moves to the end."""
        if self._player is not None:
            here, stop = self._player.position, self._player.range[1]
            self.set_range(here, stop if stop > here else self._player.duration)

    def set_out(self) -> None:
        if self._player is not None:
            here, start = self._player.position, self._player.range[0]
            self.set_range(start if start < here else 0.0, here)

    def clear_range(self) -> None:
        """Remove the in and the out point."""
        player, part = self._player, self.range()
        if player is None or part is None:
            return
        self.set_range(0.0, player.duration)
        words = self.tr("The range {} – {} was removed.")
        text = words.format(*(position_text(t) for t in part))
        self.removed.emit(text, lambda: self._put_back(player, part))

    def _put_back(self, player: Player, part: tuple[float, float]) -> None:
        """Restore the range if its session is still open."""
        if self._player is player:
            self.set_range(*part)

    def toggle_loop(self) -> None:
        self.loop_button.toggle()
        self._loop()

    def _loop(self) -> None:
        if self._player is not None:
            self._player.set_loop(self.loop_button.isChecked())

    def _set_speed(self, _index: int) -> None:
        if self._player is not None:
            self._player.set_speed(float(self.speed.currentData()))

    # --- displayed data

    def range(self) -> tuple[float, float] | None:
        """The selected range in s; None for the whole session."""
        if self._player is None or self._player.range == (0.0, self._player.duration):
            return None
        return self._player.range

    def refresh(self) -> None:
        player = self._player
        if player is None:
            return
        self.play_button.setText(self.tr("Pause") if player.playing else self.tr("Play"))
        text = f"{position_text(player.position)} / {position_text(player.duration)}"
        part = self.range()
        if part is not None:
            text = f"{position_text(part[0])} – {position_text(part[1])}   {text}"
        self.position.setText(text)
        if not self.timeline.held:
            self.timeline.show_place(player.position, player.range)
        else:
            self.timeline.show_range(player.range)


def _mark(position: float, event: Event, words: str) -> Mark:
    """A mark on the timeline; notes have the text colour, since users look for them."""
    look = KINDS[kind_of(event)]
    colour = "" if event.kind == "note" else look.colour
    return Mark(position, f"{position_text(position)}  {words}", colour, look.sign)
