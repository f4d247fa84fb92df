"""Checks of the gloves: ports, their speed, latency timers, packets, IMUs, time stamps."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from tracker.base.notices import Notice
from tracker.doctor.finding import Finding, error, ok, warning
from tracker.doctor.machine import Machine
from tracker.firmware.versions import advice as firmware_advice
from tracker.messages import Event, ImuSample
from tracker.sensors.discovery import PortReport, latency_advice, probe
from tracker.sensors.glove_link import GloveLink, LinkParams
from tracker.sensors.link_figures import is_low
from tracker.sensors.protocol import BAUDS

OTHER_BAUDS = (9600, 57_600, 500_000, 1_000_000)
"""Speeds of other firmware on the same boards, tried where bytes arrive that do not decode."""
POLL = 0.05  # s
LONGER = 3
"""A glove is measured for that many times the duration, so that its clock's skew is known."""
LOST_SHARE = 0.002
RATE_SHARE = 0.95
LATE_MS = 10.0
"""95 % of the packets should arrive within this time after they were sampled."""
SKEW_PPM = 200.0
LATENCY_FILES = "sys/bus/usb-serial/devices"


def gloves(machine: Machine) -> Iterator[Finding]:
    """Asks every USB serial port, and measures each glove that answers."""
    ports = machine.usb_ports()
    if not ports:
        yield warning("There is no USB serial port.", "Plug the glove in.")
        return
    found = 0
    for port in ports:
        if port.path in machine.in_use:
            found += 1
            yield ok(f"{port.path} is in use by this window and was not tested.")
            continue
        report = probe(
            port.path, machine.open_port(port.path, BAUDS[0]), machine.patience, machine.clock
        )
        found += report.is_glove
        yield from _port(machine, report)
        late = _latency(machine, port.path)
        if late is not None:
            yield warning(*_split(late))
    numbers = [(p.vid, p.pid, p.serial_number) for p in ports if p.serial_number]
    if len(set(numbers)) < len(numbers):
        yield warning(
            "Two USB adapters have the same serial number.",
            "Gloves are then recognised by their own number: give each a different one "
            "(glovetrack firmware write PORT --glove-id N).",
        )
    if not found:
        yield warning("No glove responds on any port.", "Check the cable, or write the firmware.")


def _split(report: Notice) -> tuple[str, str]:
    """The first sentence of a notice, and the rest."""
    what, _, remedy = str(report).partition(". ")
    return f"{what}.", remedy


def _latency(machine: Machine, path: str) -> Notice | None:
    return latency_advice(path, machine.root / LATENCY_FILES, machine.system, machine.usb_ports)


def _port(machine: Machine, report: PortReport) -> Iterator[Finding]:
    if report.is_glove:
        yield from _glove(machine, report)
    elif report.trouble is None:
        return
    elif report.trouble.code == "port.not_opened":
        what, remedy = _split(report.trouble)
        yield error(what, remedy or "Close the other program, or choose Retry after that.")
    elif report.trouble.code == "port.not_glove":
        yield _undecoded(machine, report.path)
    else:
        yield warning(str(report.trouble), "If a glove is connected there, write its firmware.")


def _undecoded(machine: Machine, path: str) -> Finding:
    """Bytes that are not the protocol's: a glove at another speed, or another device."""
    again = probe(
        path,
        machine.open_port(path, OTHER_BAUDS[0]),
        machine.patience,
        machine.clock,
        OTHER_BAUDS,
    )
    if again.is_glove:
        return error(
            f"The glove at {path} sends at {again.baud} baud, which Glovetrack does not use.",
            f"Write the firmware again: glovetrack firmware write {path} --baud {BAUDS[0]}.",
            baud=again.baud,
        )
    speeds = " or ".join(str(baud) for baud in BAUDS)
    return warning(
        f"{path} sends bytes that cannot be decoded at {speeds} baud.",
        "If it is a glove, its firmware has another baud rate or the cable is damaged: write the "
        "firmware again. Otherwise ignore this line.",
    )


@dataclass(eq=False)
class _Received:
    """What came from a glove in the time of the measurement."""

    samples: list[ImuSample] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)

    @property
    def span(self) -> float:
        """s between the first and the last packet's sampling."""
        return self.samples[-1].t - self.samples[0].t if len(self.samples) > 1 else 0.0


def _glove(machine: Machine, report: PortReport) -> Iterator[Finding]:
    hello = report.hello
    if hello is None:
        yield warning(
            f"The glove at {report.path} sends samples but does not answer.",
            "Unplug it, then plug it in again.",
        )
        return
    version = ".".join(map(str, hello.firmware))
    yield ok(
        f"Glove {hello.glove_id} at {report.path}: {hello.imu_count} IMUs, firmware {version}, "
        f"{report.baud} baud.",
        baud=report.baud,
    )
    newer = firmware_advice(hello.firmware)
    if newer is not None:
        yield warning(str(newer), f"glovetrack firmware write {report.path}")
    params = LinkParams(baud=report.baud)
    open_port = machine.open_port(report.path, report.baud)
    link = GloveLink(open_port, hello.imu_count, params, machine.clock)
    try:
        received = _receive(machine, link)
        yield from _packets(link, received, report.path)
        yield from _imus(link, received)
        yield from _time_stamps(link, received)
    finally:
        link.close()


def _receive(machine: Machine, link: GloveLink) -> _Received:
    received, clock = _Received(), machine.clock
    duration = LONGER * machine.duration
    end = clock() + machine.patience + duration
    while clock() < end and received.span < duration:
        for item in link.poll(POLL):
            if isinstance(item, Event):
                received.texts.append(item.text)
            else:
                received.samples.append(item)
    return received


def _packets(link: GloveLink, received: _Received, path: str) -> Iterator[Finding]:
    if received.span == 0.0:
        yield error(
            f"The glove at {path} answers but sends no samples.",
            "Unplug it, then plug it in again. If this does not help, write the firmware.",
        )
        return
    figures = link.figures
    rate_hz = (len(received.samples) - 1) / received.span
    lost = figures.lost / (figures.lost + len(received.samples))
    errors = link.decoder.counters.errors
    what = f"{rate_hz:.1f} packets per second, {100 * lost:.1f} % lost, {errors} damaged."
    values = {"rate_hz": rate_hz, "lost_percent": 100 * lost, "damaged": float(errors)}
    if lost > LOST_SHARE or errors > 1:
        remedy = "Use a shorter cable and another USB port, without a hub, and check the plugs."
        yield warning(what, remedy, **values)
    elif rate_hz < RATE_SHARE * link.params.rate_hz:
        remedy = f"{link.params.rate_hz} were requested: write the current firmware."
        yield warning(what, remedy, **values)
    else:
        yield ok(what, **values)
    if figures.battery_mV is not None and is_low(figures.battery_mV):
        yield warning(
            f"The glove's battery has {figures.battery_mV / 1000:.2f} V.", "Charge the glove."
        )


def _imus(link: GloveLink, received: _Received) -> Iterator[Finding]:
    """IMUs that do not answer, and what the firmware reports of its self-test."""
    if not received.samples:
        return
    answering = np.mean([s.valid for s in received.samples], axis=0) > 0.5  # (n,)
    absent = [str(j) for j in np.flatnonzero(~answering)]
    if absent:
        yield error(
            f"IMUs that do not respond: {', '.join(absent)}.",
            "Check the wires of these IMUs: supply, clock, data and select line.",
            absent=len(absent),
        )
    else:
        yield ok(f"All {len(answering)} IMUs respond.", absent=0)
    for text in dict.fromkeys(t for t in received.texts if "self-test" in t):
        yield warning(text, "Keep the glove still and restart it; otherwise replace the IMU.")


def _time_stamps(link: GloveLink, received: _Received) -> Iterator[Finding]:
    if not received.samples:
        return
    delay_ms = 1000 * np.array([s.t_arrival - s.t for s in received.samples])
    late_ms = float(np.percentile(delay_ms, 95) - np.percentile(delay_ms, 5))
    skew = link.figures.skew_ppm
    what = f"Packets arrive within {late_ms:.1f} ms of each other's delay"
    what += "." if skew is None else f"; the glove's clock differs by {skew:+.0f} ppm."
    values = {"arrival_spread_ms": late_ms} | ({} if skew is None else {"skew_ppm": skew})
    if late_ms > LATE_MS:
        remedy = "Set the adapter's latency timer to 1 ms, and avoid USB hubs."
        yield warning(what, remedy, **values)
    elif skew is not None and abs(skew) > SKEW_PPM:
        yield warning(what, "Replace the board: its crystal is out of tolerance.", **values)
    else:
        yield ok(what, **values)
