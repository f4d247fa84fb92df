"""Checks of the gloves: ports, their speed, latency timers, packets, IMUs, time stamps."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from tracker.base.notices import Notice, Severity, failure, notice, warning
from tracker.doctor.finding import Finding, graded
from tracker.doctor.machine import Machine
from tracker.firmware.versions import advice as firmware_advice
from tracker.messages import ImuSample
from tracker.sensors.discovery import PortReport, latency_advice, probe
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.imu_watch import ImuReport
from tracker.sensors.link_figures import is_low
from tracker.sensors.link_params import LinkParams
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
        yield Finding(warning("doctor.no_port"), notice("doctor.plug_glove"))
        return
    found = 0
    for port in ports:
        if port.path in machine.in_use:
            found += 1
            yield Finding(notice("doctor.in_use", device=port.path))
            continue
        report = probe(
            port.path, machine.open_port(port.path, BAUDS[0]), machine.timeout, machine.clock
        )
        found += report.is_glove
        yield from _port(machine, report)
        late = _latency(machine, port.path)
        if late is not None:
            yield Finding(late.with_severity(Severity.WARNING))
    numbers = [(p.vid, p.pid, p.serial_number) for p in ports if p.serial_number]
    if len(set(numbers)) < len(numbers):
        yield Finding(warning("doctor.twin_adapters"), notice("doctor.number_gloves"))
    if not found:
        yield Finding(warning("doctor.no_glove"), notice("doctor.check_cable"))


def _latency(machine: Machine, path: str) -> Notice | None:
    return latency_advice(path, machine.root / LATENCY_FILES, machine.system, machine.usb_ports)


def _port(machine: Machine, report: PortReport) -> Iterator[Finding]:
    problem = report.problem
    if report.is_glove:
        yield from _glove(machine, report)
    elif problem is None:
        return
    elif problem.code == "port.not_opened":
        finding = Finding(problem.with_severity(Severity.ERROR))
        has_remedy = bool(finding.texts()[1])
        yield finding if has_remedy else Finding(finding.what, notice("doctor.close_port"))
    elif problem.code == "port.not_glove":
        yield _undecoded(machine, report.path)
    else:
        what = problem.with_severity(Severity.WARNING)
        yield Finding(what, notice("doctor.write_if_glove"))


def _undecoded(machine: Machine, path: str) -> Finding:
    """Bytes that are not the protocol's: a glove at another speed, or another device."""
    open_port = machine.open_port(path, OTHER_BAUDS[0])
    again = probe(path, open_port, machine.timeout, machine.clock, OTHER_BAUDS)
    if again.is_glove:
        return Finding(
            failure("doctor.other_baud", port=path, baud=again.baud),
            notice("doctor.write_at_baud", port=path, baud=BAUDS[0]),
        )
    return Finding(warning("doctor.not_decoded", port=path, bauds=BAUDS), notice("doctor.if_glove"))


@dataclass(eq=False)
class _Received:
    """What came from a glove in the time of the measurement."""

    samples: list[ImuSample] = field(default_factory=list)
    notices: list[Notice] = field(default_factory=list)

    @property
    def span(self) -> float:
        """s between the first and the last packet's sampling."""
        return self.samples[-1].t - self.samples[0].t if len(self.samples) > 1 else 0.0


def _glove(machine: Machine, report: PortReport) -> Iterator[Finding]:
    hello, port = report.hello, report.path
    if hello is None:
        yield Finding(warning("doctor.no_answer", port=port), notice("doctor.replug"))
        return
    about = {"firmware": ".".join(map(str, hello.firmware)), "baud": report.baud}
    yield Finding(
        notice("doctor.glove", glove=hello.glove_id, port=port, imus=hello.imu_count, **about)
    )
    newer = firmware_advice(hello.firmware)
    if newer is not None:
        what = newer.with_severity(Severity.WARNING)
        yield Finding(what, notice("doctor.write_firmware", port=port))
    params = LinkParams(baud=report.baud)
    open_port = machine.open_port(port, report.baud)
    link = GloveLink(open_port, hello.imu_count, params, machine.clock)
    try:
        received = _receive(machine, link)
        yield from _packets(link, received, port)
        yield from _imus(link, received)
        yield from _time_stamps(link, received)
    finally:
        link.close()


def _receive(machine: Machine, link: GloveLink) -> _Received:
    received, clock = _Received(), machine.clock
    duration = LONGER * machine.duration
    end = clock() + machine.timeout + duration
    while clock() < end and received.span < duration:
        for item in link.poll(POLL):
            if isinstance(item, ImuSample):
                received.samples.append(item)
            elif item.notice is not None:
                received.notices.append(item.notice)
    return received


def _packets(link: GloveLink, received: _Received, port: str) -> Iterator[Finding]:
    if received.span == 0.0:
        yield Finding(failure("doctor.no_samples", port=port), notice("doctor.replug_or_write"))
        return
    figures = link.figures
    rate_hz = (len(received.samples) - 1) / received.span
    lost = figures.lost / (figures.lost + len(received.samples))
    damaged = link.decoder.counters.errors
    what = notice("doctor.packets", rate_hz=rate_hz, lost_percent=100 * lost, damaged=damaged)
    severity, remedy = Severity.INFO, notice("doctor.shorter_cable")
    if lost > LOST_SHARE or damaged > 1:
        severity = Severity.WARNING
    elif rate_hz < RATE_SHARE * link.params.rate_hz:
        severity = Severity.WARNING
        remedy = notice("doctor.packet_rate", rate_hz=link.params.rate_hz)
    yield graded(what, severity, remedy)
    if figures.battery_mV is not None and is_low(figures.battery_mV):
        low = warning("doctor.battery", volts=figures.battery_mV / 1000)
        yield Finding(low, notice("doctor.charge"))


def _imus(link: GloveLink, received: _Received) -> Iterator[Finding]:
    """IMUs that do not answer, and what the firmware reports of its self-test."""
    if not received.samples:
        return
    answering = np.mean([s.valid for s in received.samples], axis=0) > 0.5  # (n,)
    absent = np.flatnonzero(~answering).tolist()
    if absent:
        yield Finding(failure("doctor.imus_absent", imus=absent), notice("doctor.imu_wires"))
    else:
        yield Finding(notice("doctor.imus", imus=len(answering)))
    for what in dict.fromkeys(n for n in received.notices if _is_selftest(n)):
        yield Finding(what.with_severity(Severity.WARNING), notice("doctor.selftest_again"))
    for j, imu in enumerate(link.report().imus):
        yield from _imu(j, imu)


def _is_selftest(what: Notice) -> bool:
    """Whether it is the firmware's message about a failed self-test."""
    return what.code == "glove.message" and "self-test" in str(what.values["text"])


def _imu(j: int, imu: ImuReport) -> Iterator[Finding]:
    """One IMU's chip, temperature, saturation and stuck axes, as far as they are known."""
    if imu.chip:
        about = {"imu": j, "chip": imu.chip, "selftest": imu.selftest}
        if imu.temperature_cC is None:
            yield Finding(notice("doctor.imu", **about))
        else:
            yield Finding(
                notice("doctor.imu_warm", temperature_c=imu.temperature_cC / 100, **about)
            )
    if imu.stuck:
        stuck = warning("doctor.imu_stuck", imu=j, axes=imu.stuck)
        yield Finding(stuck, notice("doctor.replace_imu"))
    if imu.saturated:
        at_end = warning("doctor.imu_saturated", imu=j, samples=imu.saturated)
        yield Finding(at_end, notice("doctor.move_slowly"))


def _time_stamps(link: GloveLink, received: _Received) -> Iterator[Finding]:
    if not received.samples:
        return
    delay_ms = 1000 * np.array([s.t_arrival - s.t for s in received.samples])
    spread_ms = float(np.percentile(delay_ms, 95) - np.percentile(delay_ms, 5))
    severity = Severity.WARNING if spread_ms > LATE_MS else Severity.INFO
    what = notice("doctor.arrivals", spread_ms=spread_ms)
    yield graded(what, severity, notice("doctor.latency_timer"))
    skew = link.figures.skew_ppm
    if skew is not None:
        severity = Severity.WARNING if abs(skew) > SKEW_PPM else Severity.INFO
        clock = notice("doctor.clock", skew_ppm=skew)
        yield graded(clock, severity, notice("doctor.replace_board"))
