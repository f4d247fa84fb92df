"""Drives a robot hand from a recorded session, and repeats a recorded drive to compare them."""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from extensions.robot.command import RobotCommand
from extensions.robot.driver import RobotDriver, RobotOutput, command_of
from extensions.robot.settings import RobotSettings, settings_of
from extensions.robot.teleop import Teleop
from extensions.robot.wearer_hand import hand_from_estimate
from tracker.base.clock import monotonic, nanoseconds
from tracker.base.errors import FileError
from tracker.base.files import whole_file
from tracker.base.notices import notice
from tracker.messages import Estimate, Event, RobotMemory, RobotState
from tracker.session.decode_robot import read_robot, robot_model, robot_names
from tracker.session.encode import Encoder, ImageCoding, Out
from tracker.session.export.mcap import copy_extras
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import RawMessage
from tracker.session.mcap.ordering import ordered
from tracker.session.message_check import sound
from tracker.session.reader import SessionReader
from tracker.session.ros import topics

WITHIN = 0.005  # m: largest distance of a tip from its target that counts as reached
COMPARED = ("command", "joints", "palm", "objects", "force")


@dataclass
class DriveFigures:
    """Statistics of a drive."""

    times_ms: list[float] = field(default_factory=list)  # per step
    errors_mm: list[float] = field(default_factory=list)  # largest tip error per hand
    holding: int = 0
    touches: int = 0
    largest_force: float = 0.0  # N
    _felt: np.ndarray = field(default_factory=lambda: np.zeros(5, bool))

    def count(self, state: RobotState, errors: np.ndarray, took: float) -> None:
        """Add one hand: ``errors`` (5,) m, and ``took`` s of computation."""
        self.times_ms.append(1e3 * took)
        self.holding += state.holding
        if not state.holding and np.isfinite(errors).any():
            self.errors_mm.append(1e3 * float(np.nanmax(errors)))
        felt = state.force > 0.0
        self.touches += int((felt & ~self._felt).sum())
        self._felt = felt
        self.largest_force = max(self.largest_force, float(state.force.max()))

    def report(self) -> dict[str, Any]:
        """Plain values by name; NaN without data."""

        def at(values: list[float], percent: float) -> float:
            return float(np.percentile(values, percent)) if values else float("nan")

        hands = len(self.times_ms)
        near = [e <= 1e3 * WITHIN for e in self.errors_mm]
        return {
            "hands": hands,
            "holding_percent": 100.0 * self.holding / max(hands, 1),
            "tip_error_mm_median": at(self.errors_mm, 50),
            "tip_error_mm_95": at(self.errors_mm, 95),
            "within_5_mm_percent": 100.0 * float(np.mean(near)) if near else float("nan"),
            "step_ms_median": at(self.times_ms, 50),
            "step_ms_99": at(self.times_ms, 99),
            "touches": self.touches,
            "largest_force_N": self.largest_force,
        }


Watch = Callable[[RobotState], None]


def drive(
    reader: SessionReader,
    driver: RobotDriver,
    figures: DriveFigures,
    watch: Watch = lambda state: None,
) -> Iterator[RobotOutput]:
    """The outputs of a robot that follows a session's hand."""
    for estimate in reader.messages((Estimate,)):
        assert isinstance(estimate, Estimate)
        began = monotonic()
        outputs = driver.feed(estimate)
        took = monotonic() - began
        for message in outputs:
            if isinstance(message, RobotState):
                figures.count(message, driver.teleop.fingers.error, took)
                watch(message)
        yield from outputs


def driver_of(reader: SessionReader, settings: RobotSettings) -> RobotDriver:
    """A driver for a session's hand. Raises ConfigError."""
    info = reader.info
    return RobotDriver(Teleop(settings), info.hand, info.keypoint_names)


def write_driven(
    reader: SessionReader, out: Path, outputs: Iterator[RobotOutput], force: bool = False
) -> None:
    """Write the session with this robot in place of any recorded one. Raises FileError."""
    with whole_file(out, force, [reader.path]) as part:
        output = McapOutput(part, sync=False)
        try:
            copy_extras(reader, output)
            copier, encoder = Copier(reader.source, output), Encoder(reader.info, ImageCoding())
            stored = sound(ordered(reader.source, None), reader.source.left_out)
            theirs = (m for m in stored if not topics.robot_of(m.topic)[0])
            ours = itertools.chain.from_iterable(encoder.encoded(m) for m in outputs)
            both: list[Iterator[RawMessage | Out]] = [theirs, ours]
            for m in heapq.merge(*both, key=lambda m: m.log_time):
                if isinstance(m, RawMessage):
                    copier.copy(m)
                else:
                    output.write(
                        output.channel(m.topic, m.type), m.log_time, m.stamp, m.data, m.sequence
                    )
        finally:
            output.finish()


@dataclass(frozen=True)
class RepeatedDrive:
    """Result of a repeated drive: states compared, and states that differ in any bit."""

    robot: str
    compared: int
    different: int
    first_difference: float  # s of the host's clock; NaN without a difference


def drive_again(path: Path, robot: str = "") -> RepeatedDrive:
    """Repeat the drive of a session's robot from its first stored state.

    Raises FileError if the session has no such robot or no stored state.
    """
    with SessionReader(path) as reader:
        names = robot_names(reader)
        if not names or (robot and robot not in names):
            raise FileError(notice("robot.not_recorded", path=path, robot=robot or "-"))
        name = robot or names[0]
        teleop = Teleop(settings_of(robot_model(reader, name).settings))
        recorded, memory = _recorded(reader, name)
        teleop.remember(memory)
        return _compare(reader, teleop, name, recorded)


def _recorded(reader: SessionReader, name: str) -> tuple[dict[int, RobotState], RobotMemory]:
    """The first memory and the states after it, by the time of their hands in ns."""
    memory: RobotMemory | None = None
    states: dict[int, RobotState] = {}
    for message in read_robot(reader, name):
        if isinstance(message, RobotMemory) and memory is None:
            memory = message
        elif isinstance(message, RobotState) and memory is not None and message.t > memory.t:
            states[nanoseconds(message.t)] = message
    if memory is None:
        raise FileError(notice("robot.no_state", path=reader.path, robot=name))
    return states, memory


def _compare(
    reader: SessionReader, teleop: Teleop, name: str, recorded: dict[int, RobotState]
) -> RepeatedDrive:
    commands = _commands(reader, name)
    compared = different = 0
    first = float("nan")
    for estimate in reader.messages((Estimate,)):
        assert isinstance(estimate, Estimate)
        expected = recorded.get(nanoseconds(estimate.t))
        if expected is None:
            continue  # the robot skipped this hand, or it is before the first memory
        for command in commands.get(nanoseconds(estimate.t), ()):
            teleop.command(command)
        state = teleop.feed(hand_from_estimate(estimate, reader.info.keypoint_names))
        compared += 1
        if not _same(state, expected):
            different += 1
            first = estimate.t if np.isnan(first) else first
    return RepeatedDrive(name, compared, different, first)


def _same(a: RobotState, b: RobotState) -> bool:
    return all(np.array_equal(getattr(a, n), getattr(b, n)) for n in COMPARED)


def _commands(reader: SessionReader, name: str) -> dict[int, list[RobotCommand]]:
    """Commands by the time in ns of the hand that they preceded."""
    out: dict[int, list[RobotCommand]] = {}
    for event in reader.messages((Event,)):
        assert isinstance(event, Event)
        command = command_of(event, name)
        if command is not None:
            out.setdefault(nanoseconds(event.t), []).append(command)
    return out
