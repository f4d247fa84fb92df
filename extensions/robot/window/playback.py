"""States of the recorded robot of a replayed session, for the instant that is shown."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from tracker.base.errors import FileError
from tracker.messages import RobotModel, RobotState
from tracker.session.decode_robot import read_robot, robot_model, robot_names
from tracker.session.reader import SessionReader

LEAD = 0.1  # s before the instant at which reading starts
JUMP = 2.0  # s: for larger steps ahead the reader seeks instead of reading on
SAME = 1e-6  # s


class RobotPlayback:
    """Reads the first robot of a session; fast for successive instants."""

    def __init__(self, reader: SessionReader, name: str) -> None:
        self._reader, self._name = reader, name
        self.model: RobotModel = robot_model(reader, name)
        self._coming: Iterator[RobotState] = iter(())
        self._last: RobotState | None = None
        self._next: RobotState | None = None
        self._t = float("inf")

    @staticmethod
    def of(path: Path) -> RobotPlayback | None:
        """None if the session has no robot or does not describe it."""
        reader = SessionReader(path)
        try:
            names = robot_names(reader)
            if names:
                return RobotPlayback(reader, names[0])
        except FileError:
            reader.close()
            return None
        reader.close()
        return None

    def at(self, t: float) -> RobotState | None:
        """The last state at or before ``t`` s; None before the first."""
        if not self._t <= t < self._t + JUMP:
            found = read_robot(self._reader, self._name, t - LEAD)
            self._coming = (m for m in found if isinstance(m, RobotState))
            self._last, self._next = None, next(self._coming, None)
        self._t = t
        while self._next is not None and self._next.t <= t + SAME:
            self._last, self._next = self._next, next(self._coming, None)
        return self._last

    def close(self) -> None:
        self._reader.close()
