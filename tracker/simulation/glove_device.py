"""A simulated glove that sends bytes through a pseudo-terminal, in real time, with optional faults.

It implements the firmware's protocol: HELLO until START, then samples and one status per second.
The ordinary serial code opens ``path`` as it would a real glove.
"""

from __future__ import annotations

import contextlib
import math
import os
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from select import select

import numpy as np

from tracker import GRAVITY
from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.base.urgency import run_soon
from tracker.messages import Array, ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.protocol import (
    BITS_PER_BYTE,
    MAX_IMUS,
    ErrorText,
    Frame,
    GloveStatus,
    Haptic,
    Hello,
    HelloRequest,
    ImuChip,
    Samples,
    Start,
    Stop,
    Temperatures,
    encode,
)
from tracker.simulation.electric import ElectricFault

if sys.platform != "win32":
    import fcntl

GYRO_RANGE_DPS, ACCEL_RANGE_G = 2000, 16
TICK = 0.01  # s that a wait for the host's bytes lasts at most, also while nothing is due
MPU_9250 = 0x71
COLD_C = 26.0
SYSTEM_BUFFER = 65536  # bytes that the system buffers without a reader, as on Linux


@dataclass
class Faults:
    """Set by tests and the demo's menu while the device runs."""

    drop: float = 0.0  # share of packets that are not sent
    corrupt: float = 0.0  # share of packets with a flipped bit
    stalled: bool = False  # nothing is sent; samples accumulate and are sent together afterwards
    silent: bool = False  # nothing is sent or stored


@dataclass(frozen=True)
class GloveDeviceParams:
    """``skew`` of the glove's clock; bytes are sent in bursts of ``bunch`` s."""

    skew: float = 60e-6
    bunch: float = 0.0
    wire_baud: int = 0  # of a UART in between; 0 for USB alone, where a packet arrives as a whole
    glove_id: int = 1
    start_us: int = 4_000_000  # on the glove's clock at its start
    seed: int = 0
    says_hello: bool = True
    firmware: tuple[int, int, int] = (1, 3, 0)
    rate_hz: int = 100  # in HELLO; the samples have the rate of their source
    accel_range_g: int = ACCEL_RANGE_G
    chips: bool = True  # HELLO and temperatures as from firmware 1.3


def cold(t: Array) -> Array:
    """(n, `MAX_IMUS`) °C of chips that do not warm up."""
    return np.full((len(t), MAX_IMUS), COLD_C)


class SimulatedGlove:
    """Sends the samples of ``source``; their t = 0 is the host's ``t_0`` (s), see `begin`."""

    def __init__(
        self,
        source: Iterator[ImuSample],
        imu_count: int,
        t_0: float = math.inf,
        params: GloveDeviceParams | None = None,
        temperature: Callable[[Array], Array] = cold,
    ) -> None:
        """``temperature`` gives °C (n, I) of the chips at times (n,) s of the samples."""
        self._temperature = temperature
        self.params, self.faults = params or GloveDeviceParams(), Faults()
        self._source, self._imu_count, self._t_0 = source, imu_count, t_0
        self._rng = np.random.default_rng(self.params.seed)
        self._electric = ElectricFault("", 0.0, self._rng)
        self._motors = MotorVibration(imu_count, np.random.default_rng([self.params.seed, 1]))
        self._streaming, self._seq = False, 0
        self._stopping = threading.Event()
        self._lock = threading.Lock()
        self._rests = threading.Lock()  # held while the line is waited for; after `_lock`
        self._plug()
        self._thread = threading.Thread(target=self._run, name="glovetrack-glove-sim", daemon=True)
        self._thread.start()

    def begin(self, t_0: float) -> None:
        """Set the samples' time 0 to the host's ``t_0`` (s)."""
        self._t_0 = t_0

    # ---- the plug

    def _plug(self) -> None:
        """Raises DeviceError on a system without pseudo-terminals."""
        try:
            import pty  # deferred: missing on Windows
            import tty
        except ImportError as error:  # missing on Windows
            raise DeviceError(notice("simulator.no_terminal")) from error
        self._master, slave = pty.openpty()
        tty.setraw(slave)
        os.set_blocking(self._master, False)
        self.path = os.ttyname(slave)
        self._slave = slave  # open, so that the line persists when a host disconnects
        self._unsent = bytearray()
        self._decoder = FrameDecoder()

    def unplug(self) -> None:
        """Unplug the cable: the host's port fails."""
        with self._lock:
            self._streaming = False
            os.write(self._slave, b"\0")  # ends the wait: until then, the system keeps the line
            with self._rests:
                os.close(self._slave)
                os.close(self._master)
                self._master = self._slave = -1

    def plug(self) -> None:
        """Plug in again, with a new ``path``, as for a real adapter."""
        with self._lock:
            self._plug()
            self._seq = 0

    def reset(self) -> None:
        """Restart the chip: counters start from zero, HELLO is sent."""
        with self._lock:
            self._restart()

    def _restart(self) -> None:
        self._streaming, self._seq = False, 0
        self._greet()

    def fail(self, kind: str) -> None:
        """Start one of `ELECTRIC_FAULTS`; an empty ``kind`` ends it.

        The faults busy and forbidden apply to programs that open the port from now on; the
        superuser may open a forbidden port. Raises ValueError for an unknown kind.
        """
        with self._lock:
            self._electric = ElectricFault(kind, time.monotonic(), self._rng)
            if self._slave < 0:
                return
            fcntl.flock(self._slave, fcntl.LOCK_UN)
            if kind == "port busy":
                with contextlib.suppress(BlockingIOError):  # this host has it open
                    fcntl.flock(self._slave, fcntl.LOCK_EX | fcntl.LOCK_NB)
            Path(self.path).chmod(0 if kind == "port denied" else 0o620)

    def stop(self) -> None:
        """End the thread and close the line. Idempotent."""
        self._stopping.set()
        self._thread.join()
        if self._master >= 0:
            self.unplug()

    # ---- the firmware

    def _run(self) -> None:
        run_soon()  # a real device has its own processor
        pending: list[bytes] = []
        last_hello = last_status = last_flush = float("-inf")
        baud = self.params.wire_baud
        wire = BITS_PER_BYTE * (12 * self._imu_count + 11) / baud if baud else 0.0
        sample = next(self._source, None)
        while not self._stopping.is_set():
            self._rest(sample, wire)
            now = time.monotonic()
            with self._lock:
                if self._master < 0:
                    sample = self._skip(sample, now)
                    continue
                self._listen()
                self._write()
                if self._electric.is_reset_due(now):
                    self._restart()
                if not self._streaming:
                    sample = self._skip(sample, now)
                    if now - last_hello >= 1.0:
                        last_hello = now
                        self._greet()
                    continue
                while sample is not None and self._t_0 + sample.t + wire <= now:
                    pending += self._packet(sample)
                    sample = next(self._source, None)
                if now - last_status >= 1.0:
                    last_status = now
                    status = GloveStatus(3700, 2900, (1 << self._imu_count) - 1, 0)
                    pending.append(self._wired(status))
                    if self.params.chips:
                        pending.append(encode(self._temperatures(now)))
                if not self.faults.stalled and now - last_flush >= self.params.bunch:
                    last_flush = now
                    self._write(b"".join(pending))
                    pending.clear()

    def _temperatures(self, now: float) -> Temperatures:
        """The temperature of each IMU, from the source of the samples."""
        celsius = self._temperature(np.array([now - self._t_0]))[0]
        return Temperatures(tuple(round(100 * float(c)) for c in celsius[: self._imu_count]))

    def _rest(self, sample: ImuSample | None, wire: float) -> None:
        """Wait until the next packet is due or the host has sent something, at most `TICK`."""
        due = self._t_0 + sample.t + wire - time.monotonic() if sample is not None else TICK
        remaining = min(max(due, 0.0), TICK)
        with self._rests:
            if self._master >= 0:
                select([self._master], [], [], remaining)  # poll() would wait for whole ms
                return
        self._stopping.wait(remaining)

    def _skip(self, sample: ImuSample | None, now: float) -> ImuSample | None:
        """Discard samples from before a host was connected."""
        while sample is not None and self._t_0 + sample.t <= now:
            sample = next(self._source, None)
        return sample

    def _packet(self, sample: ImuSample) -> list[bytes]:
        seq, self._seq = self._seq, (self._seq + 1) % 65536
        if self.faults.silent or self._rng.random() < self.faults.drop:
            return []
        t_us = self.params.start_us + round(sample.t * (1 + self.params.skew) * 1e6)
        if (shaken := self._motors.at(sample.t)) is not None:
            accel, gyro = sample.accel + shaken[0], sample.gyro + shaken[1]
            sample = replace(sample, accel=accel, gyro=gyro)
        raw = quantised(sample, self.params.accel_range_g)
        packet = self._wired(Samples(seq, t_us % 2**32, raw))
        if self._rng.random() < self.faults.corrupt:
            damaged = bytearray(packet)
            damaged[int(self._rng.integers(len(packet)))] ^= 1 << int(self._rng.integers(8))
            packet = bytes(damaged)
        return [packet]

    def _wired(self, frame: Frame) -> bytes:
        """The bytes of a frame that arrive."""
        now = time.monotonic()
        return self._electric.wire(encode(self._electric.frame(frame, now)), now)

    def _greet(self) -> None:
        p = self.params
        hello = Hello(
            p.glove_id,
            self._imu_count,
            GYRO_RANGE_DPS,
            p.accel_range_g,
            p.rate_hz,
            firmware=p.firmware,
            chips=(ImuChip(MPU_9250, 0),) * self._imu_count if p.chips else (),
        )
        if p.says_hello:
            self._write(self._wired(hello))

    def _listen(self) -> None:
        try:
            data = os.read(self._master, 4096)
        except (BlockingIOError, OSError):
            return
        for frame in self._decoder.feed(data):
            match frame:
                case HelloRequest():
                    self._unsent.clear()  # a system discards the data of a closed port
                    self._greet()
                case Start():
                    self._streaming = True
                case Stop():
                    self._streaming = False
                case Haptic() if self._electric.kind == "motor reset":
                    self._restart()
                case Haptic():
                    self._motors.run(frame, time.monotonic() - self._t_0)
                case _:
                    continue

    def _write(self, data: bytes = b"") -> None:
        """Bytes are buffered for a host that does not read, at most `SYSTEM_BUFFER`."""
        if len(self._unsent) + len(data) <= SYSTEM_BUFFER:
            self._unsent += data
        if self._master < 0 or not self._unsent:
            return
        with contextlib.suppress(BlockingIOError, OSError):  # full, or the host has disconnected
            del self._unsent[: os.write(self._master, self._unsent)]

    def light(self, begin: float, end: float) -> float:
        """Brightness, 0 to 1, of an LED in place of the first motor: the mean between two times of
        `time.monotonic`. From any thread."""
        return self._motors.mean(0, begin - self._t_0, end - self._t_0)

    def on_problem(self, text: str) -> None:
        """Send an ERROR frame."""
        with self._lock:
            self._write(encode(ErrorText(text)))


def quantised(sample: ImuSample, accel_range_g: int = ACCEL_RANGE_G) -> np.ndarray:
    """Raw (n, 6) int16 of a sample, saturated at the ranges."""
    accel = sample.accel / (accel_range_g * GRAVITY)
    gyro = sample.gyro / (GYRO_RANGE_DPS * np.pi / 180)
    raw = np.round(np.concatenate([accel, gyro], axis=1) * 32768.0)
    return np.clip(np.nan_to_num(raw), -32768, 32767).astype(np.int16)


def link_to(folder: Path, device: SimulatedGlove, name: str = "glove") -> Path:
    """A stable name for a device whose path changes when it is plugged in again.

    Raises FileExistsError if a file other than a link has this name."""
    link = folder / name
    if link.is_symlink():
        link.unlink()
    link.symlink_to(device.path)
    return link


# ---- vibration that a glove's motors cause in its IMUs

MOTOR_HZ = 183.0
"""Of an eccentric motor at full amplitude; 100 packets a second alias it to 17 Hz."""
ACCEL, GYRO = 0.2 * GRAVITY, np.deg2rad(5.0)
"""m/s² and rad/s at full amplitude in the motor's own IMU: assumed is a coin motor that shakes a
fingertip by 0.5 g, of which the IMU's low-pass filter (92 Hz) passes 0.4."""
ELSEWHERE = 0.1
"""Share that the glove's other IMUs measure."""
FIRST_IMU, IMUS_PER_MOTOR = 2, 2
"""The IMU at the end of the first motor's finger, and IMUs for each finger after it."""
MOST_MS = 5000
KEPT = 50
"""Commands of which `MotorVibration.mean` knows."""


class MotorVibration:
    """The running motors, on the clock of the samples (s)."""

    def __init__(self, imu_count: int, rng: np.random.Generator) -> None:
        self._n, self._rng = imu_count, rng
        self._running: dict[int, tuple[float, float]] = {}  # end time, share of full amplitude
        self._runs: deque[tuple[int, float, float, float]] = deque(maxlen=KEPT)
        self._axis = rng.normal(0, 1 / math.sqrt(3), (2, imu_count, 3))

    def run(self, command: Haptic, now: float) -> None:
        """Starts or stops a motor."""
        duration = min(command.duration_ms, MOST_MS) / 1000
        share = command.amplitude / 255
        self._running[command.channel] = now + duration, share
        self._runs.append((command.channel, now, now + duration, share))

    def mean(self, channel: int, begin: float, end: float) -> float:
        """Mean share of full amplitude of a motor, or the brightness of a light in its place."""
        total, until = 0.0, end
        for number, on, off, share in reversed(tuple(self._runs)):
            if number == channel and on < until:
                total += share * max(min(off, until) - max(on, begin), 0.0)
                until = on  # a command replaces the one before
        return total / (end - begin)

    def at(self, t: float) -> tuple[Array, Array] | None:
        """accel (n, 3) m/s² and gyro (n, 3) rad/s to be added at ``t``; None if no motor runs."""
        self._running = {k: v for k, v in self._running.items() if t < v[0] and v[1] > 0}
        if not self._running:
            return None
        size = np.zeros(self._n)
        for channel, (_, share) in self._running.items():
            near = np.full(self._n, ELSEWHERE)
            own = FIRST_IMU + IMUS_PER_MOTOR * channel
            if own < self._n:
                near[own] = 1.0
            size = np.hypot(size, share * near)
        phase = 2 * math.pi * MOTOR_HZ * t
        shaken = size[:, None] * self._axis * math.sin(phase)
        return ACCEL * shaken[0], GYRO * shaken[1]
