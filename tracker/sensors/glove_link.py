"""The glove on a serial port: handshake, samples, faults and automatic reconnection.

`GloveLink.poll` does all the work and owns no thread; `GloveLink.vibrate` may be called from any.
Every fault becomes a counter and, once, an event.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import serial

from tracker.base.notices import notice, warning
from tracker.messages import Event, ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.glove_messages import (
    RangeFromRest,
    Ranges,
    pulse_event,
    range_at_rest,
    si_sample,
)
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.glove_report import GloveReport
from tracker.sensors.imu_watch import CHIPS, ImuWatch
from tracker.sensors.link_faults import (
    LinkFaults,
    judge_rate,
    not_opened,
    other_glove,
    unknown_chip,
    why_no_hello,
)
from tracker.sensors.link_figures import Announcements, LinkFigures, LowBattery
from tracker.sensors.link_params import LinkParams, LinkState, rates_at
from tracker.sensors.motor_events import motor_event
from tracker.sensors.packet_clock import SEQ_BITS, PacketClock
from tracker.sensors.protocol import (
    BITS_PER_BYTE,
    ErrorText,
    Frame,
    GloveStatus,
    Haptic,
    Hello,
    HelloRequest,
    Pulse,
    Rate,
    Samples,
    Start,
    Stop,
    Temperatures,
    encode,
)
from tracker.sensors.serial_line import Port as Port
from tracker.sensors.serial_line import WiredPort, read_waiting, reason, write_now
from tracker.sensors.serial_line import serial_port as serial_port

LONG_PAUSE = 60.0  # s, after which seq may have wrapped unnoticed
ANSWER_WITHIN = 1.0  # s between a request for HELLO and its arrival, at most
MOMENT = 0.002  # s that a motor command waits for another frame to be written
LOST_AT_MOST = 200  # packets, while a HELLO is answered
RATE_WITHIN = 2.0  # s after which a glove has adopted a requested rate


class GloveLink:
    """One glove with ``imu_count`` IMUs. ``open_port`` opens its port or raises OSError."""

    def __init__(
        self,
        open_port: Callable[[], Port],
        imu_count: int,
        params: LinkParams | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.params = params or LinkParams()
        self._open_port, self._imu_count, self._clock = open_port, imu_count, clock
        self._port: Port | None = None
        self._writing = (
            threading.Lock()
        )  # frames must not mix, and the port must not close within one
        self._write_error: OSError | None = None  # from any thread, for the polling one
        self._events = Announcements(clock)
        self._next_open = float("-inf")
        self.state = LinkState.UNPLUGGED
        self.hello: Hello | None = None
        self.decoder = FrameDecoder()
        self.figures = LinkFigures(counters=self.decoder.counters, imus=ImuWatch(imu_count))
        self._battery = LowBattery()
        self._faults = LinkFaults(imu_count)
        self._imu_ok = (1 << imu_count) - 1
        self._ranges: Ranges | None = None
        self._at_rest = RangeFromRest()
        self._last_seq: int | None = None  # seq of the last samples since START
        self._before: int | None = None  # the same at a HELLO that may be a late answer
        self._was_disconnected = False  # its return has not been reported yet
        self._packet_clock = self._new_clock()
        self._wanted_rate = self.params.rate_hz  # set by any thread, sent by the polling one
        self._rate_requested_at = float("-inf")  # time of sending

    # ---- public interface

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        """Returns samples and events after waiting at most ``timeout`` s for bytes."""
        out: list[ImuSample | Event] = []
        if self._port is None:
            self._open(timeout)
        if self._port is None:
            return [*out, *self._events.drain()]
        try:
            self._ask_rate()
            data = read_waiting(self._port, timeout)
            now = self._clock()
            for frame in self.decoder.feed(data):
                if self._port is not None:  # the port of another glove was closed
                    out += self._take(frame, now)
            counters = self.decoder.counters
            self._events.report(self._faults.errors(now, counters.errors, counters.frames))
            self._watch(now)
            if self._write_error is not None:
                raise self._write_error
        except (serial.SerialException, OSError) as error:
            self._unplugged(error)
        return [*out, *self._events.drain()]

    def vibrate(self, channel: int, amplitude: int, duration_ms: int) -> bool:
        """Run a motor; whether the command was sent. It is not while the glove is away, nor if the
        line has no room, since this does not wait. From any thread."""
        if not self._writing.acquire(timeout=MOMENT):
            return False
        try:
            if self._port is not None:
                if amplitude and duration_ms:
                    self._faults.motor_started(self._clock())
                sent = write_now(self._port, encode(Haptic(channel, amplitude, duration_ms)))
                if sent:
                    run = motor_event(channel, amplitude, duration_ms, self._clock())
                    self._events.add(run)
                return sent
        except (serial.SerialException, OSError) as error:
            self._write_error = error
        finally:
            self._writing.release()
        return False

    def request_rate(self, rate_hz: int) -> None:
        """Requests another rate at the next poll and after each restart. From any thread.

        Raises ValueError for a rate that the protocol or the line does not support.
        """
        replace(self.params, rate_hz=rate_hz)
        self._wanted_rate = rate_hz

    def report(self) -> GloveReport:
        """Returns what is known about the glove and its line, without a query. From any thread."""
        hello, place, figures = self.hello, self._open_port, self.figures
        ranges = self._ranges
        return GloveReport(
            port=place.path if isinstance(place, GlovePort) else getattr(self._port, "port", ""),
            adapter=place.adapter if isinstance(place, GlovePort) else None,
            state=self.state.value,
            baud=self.params.baud,
            rates_hz=rates_at(self.params.baud),
            requested_rate_hz=self._wanted_rate,
            rate_hz=self._packet_clock.rate_hz,
            glove_id=hello.glove_id if hello else None,
            firmware=hello.firmware if hello else None,
            protocol=hello.protocol if hello else None,
            motors=hello.haptic_channels if hello else 0,
            accel_range_g=ranges.accel_g if ranges else None,
            gyro_range_dps=ranges.gyro_dps if ranges else None,
            imu_ok=tuple(bool(self._imu_ok >> j & 1) for j in range(self._imu_count)),
            battery_mV=figures.battery_mV,
            temperature_cC=figures.temperature_cC,
            latency_ms=figures.latency_ms,
            skew_ppm=figures.skew_ppm,
            imus=figures.imus.reports(hello.chips if hello else ()),
        )

    def close(self) -> None:
        """Stops the stream and frees the port. May be called repeatedly."""
        self._send(Stop())
        if self._port is not None:
            self._port.close()
            self._port = None
        self.state = LinkState.UNPLUGGED

    # ---- the port

    def _open(self, timeout: float) -> None:
        now = self._clock()
        if now < self._next_open:
            time.sleep(min(timeout, self._next_open - now))
            return
        self._next_open, self._write_error = now + self.params.reopen_every, None
        try:
            self._port = self._open_port()
        except (serial.SerialException, OSError) as error:
            self._events.once("open", not_opened(error))
            return
        self._events.topics.discard("open")
        if isinstance(self._open_port, GlovePort) and self._open_port.has_twin:
            self._events.once("twin", warning("glove.twin_adapters", port=self._open_port.path))
        self.figures.opened += 1
        self.figures.latency_ms = getattr(self._port, "latency_ms", None)
        counters, self.decoder = self.decoder.counters, FrameDecoder()
        self.decoder.counters = counters
        self._greet(now)

    def _greet(self, now: float) -> None:
        self.state, self._since, self._asked = LinkState.GREETING, now, False
        self._before_greeting = replace(self.decoder.counters)
        self.hello, self._ranges, self._at_rest = None, None, RangeFromRest()
        self._last_seq = self._before = None
        self._events.topics -= {"range", "ranges", "rate"}
        self._packet_clock = self._new_clock()
        self._send(HelloRequest())

    def _new_clock(self) -> PacketClock:
        """Subtracts the packet's transmission time on the wire, if it has one."""
        baud = self._port.wire_baud if isinstance(self._port, WiredPort) else 0
        packet = encode(Samples(0, 0, np.zeros((self._imu_count, 6), np.int16)))
        wire_time = BITS_PER_BYTE * len(packet) / baud if baud else 0.0
        reported = 1 / self.hello.rate_hz if self.hello is not None and self.hello.rate_hz else None
        return PacketClock(1 / self.params.rate_hz, wire_time, reported)

    def _ask_rate(self) -> None:
        """Sends the requested rate; the packet clock learns it from the packets."""
        rate_hz = self._wanted_rate
        if rate_hz == self.params.rate_hz:
            return
        self.params = replace(self.params, rate_hz=rate_hz)
        self._rate_requested_at = self._clock()
        self._events.topics.discard("rate")
        if self.state in (LinkState.STREAMING, LinkState.SILENT):
            self._send(Rate(rate_hz))

    def _send(self, frame: Frame) -> None:
        """If that fails, `poll` frees the port, since it may be reading from it."""
        with self._writing:
            if self._port is None:
                return
            try:
                self._port.write(encode(frame))
            except (serial.SerialException, OSError) as error:
                self._write_error = error

    def _unplugged(self, error: Exception) -> None:
        with self._writing:
            if self._port is not None:
                self._port.close()
            self._port = None
        self.state, self._was_disconnected = LinkState.UNPLUGGED, True
        self._events.report(warning("glove.unplugged", why=reason(error)))

    # ---- frames

    def _take(self, frame: Frame, now: float) -> list[ImuSample]:
        match frame:
            case Samples():
                return self._samples(frame, now)
            case Hello():
                self._greeted(frame, now)
            case GloveStatus():
                self._status(frame)
            case ErrorText():
                self._events.report(warning("glove.message", text=frame.text))
            case Pulse():
                self._events.add(pulse_event(frame, self._packet_clock, now))
            case Temperatures():
                self.figures.imus.set_temperatures(frame.values_cC)
        return []

    def _greeted(self, hello: Hello, now: float) -> None:
        """A HELLO after samples means a restart, unless it is a late answer to HELLO?."""
        if self._is_other_glove(hello.glove_id, now):
            return
        if self._last_seq is not None and self.state != LinkState.GREETING:
            if now - self._began < ANSWER_WITHIN:
                self._before = self._last_seq  # the next packet's number decides
            else:
                self._restarted()
        self.hello = hello
        if hello.accel_range_g and hello.gyro_range_dps:
            self._ranges = Ranges(hello.accel_range_g, hello.gyro_range_dps)
        for j, chip in enumerate(hello.chips):
            if chip.who_am_i and chip.who_am_i not in CHIPS:
                self._events.once(f"chip {j}", unknown_chip(j, chip))
        if hello.imu_count != self._imu_count:
            has = warning("glove.imu_count", imus=hello.imu_count, expected=self._imu_count)
            self._events.once("count", has)
        self._begin(now)

    def _is_other_glove(self, glove_id: int | None, now: float) -> bool:
        """If another glove is found here, it is not used, and the search continues."""
        place = self._open_port
        if not isinstance(place, GlovePort):
            return False
        before = place.home
        if place.is_right(glove_id):
            if place.home != before or self._was_disconnected:
                self._events.report(notice("glove.back_at", port=place.path))
                self._was_disconnected = False
            return False
        self._events.once(f"stranger {glove_id}", other_glove(place, glove_id))
        with self._writing:
            if self._port is not None:
                self._port.close()
            self._port = None
        self.state, self._next_open = LinkState.UNPLUGGED, now + self.params.reopen_every
        return True

    def _restarted(self) -> None:
        self.figures.resets += 1
        self._events.report(warning("glove.restarted"))
        self._events.report(self._faults.restarted(self._clock(), self.figures.battery_mV))

    def _begin(self, now: float) -> None:
        self._packet_clock, self._last_seq, self._began = self._new_clock(), None, now
        if self.hello is None or self.hello.rate_hz != self.params.rate_hz:
            self._send(Rate(self.params.rate_hz))
        self._send(Start())
        self.state, self._since = LinkState.STREAMING, now
        if self._was_disconnected:  # at the same port as before
            self._events.report(notice("glove.sends_again"))
            self._was_disconnected = False

    def _samples(self, frame: Samples, now: float) -> list[ImuSample]:
        if len(frame.raw) != self._imu_count:
            has = {"imus": len(frame.raw), "expected": self._imu_count}
            self._events.once("count", warning("glove.packet_imu_count", **has))
            return []
        if self.state == LinkState.SILENT:
            self._events.report(notice("glove.sends_again"))
            if now - self._since > LONG_PAUSE:
                self._packet_clock = self._new_clock()
        if (
            self.state != LinkState.GREETING
        ):  # a glove that was never stopped has not been queried yet
            self.state, self._since, self._last_seq = LinkState.STREAMING, now, frame.seq
        before, self._before = self._before, None
        if before is not None and not 0 < (frame.seq - before) % 2**SEQ_BITS <= LOST_AT_MOST:
            self._restarted()
        time_of = self._packet_clock.read(frame, now)
        if time_of is None:
            self.figures.repeated += 1
            return []
        self.figures.packets += 1
        self.figures.lost += time_of.lost
        if time_of.jumped:
            self.figures.clock_jumps += 1
            self._events.report(warning("glove.clock_jumped", jump_s=time_of.jumped))
        self.figures.skew_ppm = self._packet_clock.skew_ppm
        if now - self._rate_requested_at > RATE_WITHIN:
            judge_rate(self._packet_clock.rate_hz, self.params.rate_hz, self._events)
        if self._ranges is None:
            self._ranges = range_at_rest(frame, time_of.t_device, self._at_rest, self._events)
        trusted = self._imu_ok
        for j in np.flatnonzero(self.figures.imus.add(frame.raw)):
            trusted &= ~(1 << int(j))
            self._events.once(f"saturated {j}", warning("glove.imu_saturated", imu=j))
        for stuck, axes in self.figures.imus.newly_stuck():
            self._events.report(warning("glove.imu_stuck", imu=stuck, axes=axes))
        sample = si_sample(frame, time_of, now, self._ranges, trusted)
        return [replace(sample, temperature=self.figures.imus.take_temperatures())]

    def _status(self, status: GloveStatus) -> None:
        self.figures.battery_mV, self.figures.dropped = status.battery_mV, status.dropped
        self.figures.temperature_cC = status.temperature_cC
        if (low := self._battery.look(status.battery_mV)) is not None:
            self._events.report(low)
        changed = status.imu_ok ^ self._imu_ok
        self._imu_ok = status.imu_ok
        for j in range(self._imu_count):
            if changed >> j & 1:
                back = status.imu_ok >> j & 1
                what = (
                    notice("glove.imu_back", imu=j) if back else warning("glove.imu_silent", imu=j)
                )
                self._events.report(what)
                if not back:
                    self._events.report(self._faults.imu_lost(j, self._clock()))

    def _watch(self, now: float) -> None:
        """What is missing: HELLO or samples."""
        p, waited = self.params, now - self._since
        if self.state == LinkState.GREETING:
            if waited > p.boot and not self._asked:
                self._asked = True
                self._send(Stop())  # a glove that an earlier run started repeats its HELLO
                self._send(HelloRequest())
            if waited > p.boot + p.timeout and not self._is_other_glove(None, now):
                missing = why_no_hello(self.decoder.counters, self._before_greeting, p.baud)
                self._events.report(missing)
                self._begin(now)
        elif self.state == LinkState.STREAMING and waited > p.silent_after:
            self.state = LinkState.SILENT
            suspended = getattr(self._port, "is_suspended", False)
            silent = warning("glove.silent", silent_s=p.silent_after)
            self._events.report(warning("glove.usb_suspended") if suspended else silent)
