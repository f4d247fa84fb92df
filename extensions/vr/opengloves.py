"""Hands to OpenGloves' SteamVR driver (a named pipe) and to Monado's (a serial line).

The pipe takes a structure of 120 bytes, the line takes text such as ``A512(AB)600``. Both have a
flexion of four joints of each digit, splays, a trigger and buttons. What is lost keeps its last
value in the pipe and is absent from the line.
Sources: github.com/LucidVR/opengloves-driver, gitlab.freedesktop.org/monado, drv_opengloves.
"""

from __future__ import annotations

import contextlib
import os
import struct
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from extensions.vr.buttons import CONTROLS, ButtonGestures, Controls, control_reader
from tracker.base.notices import Notice, failure, notice
from tracker.messages import Array, Estimate
from tracker.streaming.connection import StreamError, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind

if sys.platform != "win32":
    import pty
    import termios
    import tty
    from fcntl import ioctl

RETRY_AFTER = 1.0  # s
PACKET = struct.Struct("<20f5f2f8?f")
MOST_UNREAD = 1000  # bytes in the terminal's buffer: some five lines
MOST_ANALOG = 1023  # of Monado's line
DIGITS = "ABCDE"  # thumb to little finger
ROW = np.array([[0, 1, 2, 2], *([[0, 0, 1, 2]] * 4)])
"""For each digit, of `Controls.flexion` what each of the driver's four joints takes: the thumb's
fourth does not exist, and a finger's first is its metacarpal, which bends with the knuckle."""


@dataclass(frozen=True)
class OpenGlovesOptions:
    pipe: str = option(
        r"\\.\pipe\vrapplication\input\glove\v2\{side}",
        "path of the driver's pipe; {side} stands for left or right",
    )
    trigger: str = option("pinch_index", "gesture for the trigger", CONTROLS)
    grip: str = option("grasp", "gesture for the grip", CONTROLS)
    a: str = option("pinch_middle", "gesture for button A", CONTROLS)
    b: str = option("pinch_ring", "gesture for button B", CONTROLS)


@dataclass(frozen=True)
class MonadoOptions:
    link: str = option("", "path of a link to the serial port, with {side} for left or right")
    trigger: str = option("pinch_index", "gesture for the trigger", CONTROLS)
    grip: str = option("grasp", "gesture for the grip", CONTROLS)
    a: str = option("pinch_middle", "gesture for button A", CONTROLS)
    b: str = option("pinch_ring", "gesture for button B", CONTROLS)


def joints_of(controls: Controls) -> Array:
    """(5, 4) flexion 0 to 1 of the driver's joints; NaN where lost."""
    return np.take_along_axis(controls.flexion, ROW, axis=1)


class PipePublisher:
    """Writes a structure for each estimate to OpenGloves' pipe, which is opened when there is
    something to send and again after it breaks. Raises StreamError meanwhile."""

    def __init__(self, names: Names, gestures: ButtonGestures, pipe: str) -> None:
        """``pipe``: its path, in which ``{side}`` is replaced by left or right."""
        self._path = pipe.replace("{side}", names.side)
        self.name = notice("vr.at", stream="OpenGloves", path=self._path)
        self._controls = control_reader(names, gestures)
        self._file = -1
        self._due = 0.0  # s of the monotonic clock when it is opened next
        self._joints, self._splay = np.zeros((5, 4)), np.zeros(5)

    @property
    def clients(self) -> int:
        """Whether the driver has the pipe open: 1 or 0."""
        return int(self._file >= 0)

    def send(self, estimate: Estimate) -> None:
        data = self._packet(self._controls.read(estimate))
        if self._file < 0:
            self._file = self._opened()
        try:
            os.write(self._file, data)
        except OSError as error:
            self.close()
            raise StreamError(notice("stream.failed", stream=self.name, why=error)) from error

    def _opened(self) -> int:
        now = time.monotonic()
        if now < self._due:
            raise StreamError(notice("stream.not_connected", stream=self.name))
        self._due = now + RETRY_AFTER
        flags = os.O_WRONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_NONBLOCK", 0)
        try:
            return os.open(self._path, flags)
        except OSError as error:
            raise StreamError(
                notice("stream.no_connection", stream=self.name, why=error)
            ) from error

    def _packet(self, c: Controls) -> bytes:
        joints, splay = joints_of(c), c.splay
        self._joints = np.where(np.isfinite(joints), joints, self._joints)
        self._splay = np.where(np.isfinite(splay), splay, self._splay)
        buttons = (False, c.trigger_click, c.a, c.b, c.grip_click, c.trigger_click, False, False)
        floats = (*self._joints.ravel().tolist(), *self._splay.tolist(), 0.0, 0.0)
        return PACKET.pack(*floats, *buttons, c.trigger)

    def close(self) -> None:
        if self._file >= 0:
            os.close(self._file)
            self._file = -1


class LinePublisher:
    """Writes a line for each estimate to a pseudo-terminal, which another program opens as a serial
    port at ``path``. Where nothing reads, lines are discarded."""

    def __init__(self, names: Names, gestures: ButtonGestures, link: str) -> None:
        """``link``: path of a symbolic link to the port, in which ``{side}`` is replaced; "" for
        none. Raises StreamError where there are no pseudo-terminals, as on Windows."""
        if sys.platform == "win32":
            raise StreamError(notice("opengloves.no_terminal"))
        self._controls = control_reader(names, gestures)
        self._master, self._slave = pty.openpty()
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        self.path = os.ttyname(self._slave)
        self._link = Path(link.replace("{side}", names.side)) if link else None
        self._unread = False
        self.name = notice("vr.at", stream="Monado", path=self._link or self.path)
        if self._link is not None:
            self._point(self._link)

    def _point(self, link: Path) -> None:
        try:
            if link.is_symlink():
                link.unlink()
            link.symlink_to(self.path)
        except OSError as error:
            self._link = None
            self.close()
            raise StreamError(notice("opengloves.link", link=link, why=error)) from error

    def send(self, estimate: Estimate) -> None:
        data = line_of(self._controls.read(estimate)).encode()
        waiting = self._waiting()
        if waiting >= MOST_UNREAD:  # a program that begins to read shall not get old lines
            termios.tcflush(self._slave, termios.TCIFLUSH)
            self._unread = True
        elif waiting == 0:
            self._unread = False
        with contextlib.suppress(BlockingIOError):
            os.write(self._master, data)

    def _waiting(self) -> int:
        """Bytes that no program has read yet."""
        count = ioctl(self._slave, termios.FIONREAD, bytes(4))
        return int.from_bytes(count, sys.byteorder)

    def probe(self) -> Notice:
        """Lines remain in the terminal's buffer where no program reads them."""
        if self._unread:
            return failure("vr.line_unread", stream=self.name)
        return notice("vr.line_read", stream=self.name)

    def close(self) -> None:
        for each in (self._master, self._slave):
            with contextlib.suppress(OSError):
                os.close(each)
        self._master = self._slave = -1
        if self._link is not None and self._link.is_symlink():
            self._link.unlink()
        self._link = None


def line_of(c: Controls) -> str:
    """``A512(AB)600(AAB)498...``: curls and joints from 0 to 1023, splays about 512, buttons that
    are pressed by their letter."""
    out, joints, curls = [], joints_of(c), c.curls
    for digit, letter in enumerate(DIGITS):
        if np.isfinite(curls[digit]):
            out.append(f"{letter}{_analog(curls[digit])}")
        if np.isfinite(c.splay[digit]):
            out.append(f"({letter}B){_analog((c.splay[digit] + 1) / 2)}")
        for joint in range(1, 3 if digit == 0 else 4):  # the first takes the curl
            if np.isfinite(joints[digit, joint]):
                out.append(f"({letter}A{DIGITS[joint]}){_analog(joints[digit, joint])}")
    pressed = {"I": c.trigger_click, "J": c.a, "K": c.b, "L": c.grip_click, "M": c.trigger_click}
    letters = "".join(letter for letter, on in pressed.items() if on)
    return f"{''.join(out)}P{_analog(c.trigger)}{letters}\n"


def _analog(share: float) -> int:
    return round(float(share) * MOST_ANALOG)


def _opengloves(options: OpenGlovesOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    gestures = ButtonGestures(options.trigger, options.grip, options.a, options.b)
    for names in hands:
        yield PipePublisher(names, gestures, options.pipe)


def _monado(options: MonadoOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    gestures = ButtonGestures(options.trigger, options.grip, options.a, options.b)
    for names in hands:
        yield LinePublisher(names, gestures, options.link)


OPENGLOVES = StreamKind(
    name="opengloves",
    title="SteamVR (OpenGloves)",
    options=OpenGlovesOptions,
    make=_opengloves,
    order=23,
)
MONADO = StreamKind(
    name="monado",
    title="Monado (serial line)",
    options=MonadoOptions,
    make=_monado,
    order=23,
)
