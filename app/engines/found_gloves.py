"""Finds the connected gloves, and the hand of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from app.platform.tasks import JobProgress
from app.storage.bound_gloves import as_bound, bound, bound_of, ports_of
from app.storage.settings import AppSettings
from app.words import notice_text, tr
from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, notice
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.sensors.discovery import PortReport, find_gloves, serial_ports
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.link_params import LinkParams, rates_at
from tracker.sensors.protocol import BAUD, BAUDS


@dataclass(frozen=True)
class HandGlove:
    """A glove, connected (``report``) or expected, with the names of its files; ``glove_id`` is
    None if it reported no number."""

    glove_name: str
    hand_name: str
    hand: HandModel
    glove: GloveModel
    report: PortReport | None
    glove_id: int | None
    port: str = ""  # where it was connected last, if that is not a USB port

    @property
    def side(self) -> str:
        return self.glove.side

    def link(self, rate_hz: int = 100) -> GloveLink:
        """The link to it; it searches for a glove that is not connected until one is.

        ``rate_hz`` is requested if the baud rate is sufficient.
        """
        path, baud = (self.report.path, self.report.baud) if self.report else (self.port, BAUD)
        port = GlovePort(path, baud, glove_id=self.glove_id)
        rate = rate_hz if rate_hz in rates_at(baud) else LinkParams.rate_hz
        return GloveLink(port, len(self.glove.imus), LinkParams(rate, baud=baud))


@dataclass(frozen=True)
class GlovesFound:
    """At most one for each side, connected ones first; ``remarks`` are sentences for the user."""

    gloves: tuple[HandGlove, ...]
    remarks: tuple[str, ...]


def find_hand_gloves(progress: JobProgress, settings: AppSettings) -> GlovesFound:
    """Search for gloves: for both if both hands' gloves were set up, else for the first that
    responds. Raises DeviceError if there is none."""
    both = settings.both_hands or len(set(bound_sides(settings))) > 1
    named = [port for port in (settings.port, *(ports_of(settings) if both else ())) if port]
    reports, problems = probe_ports(progress, named, settings.baud, not both)
    if not reports:
        raise DeviceError(_none(problems))
    found, remarks = _assigned(settings, reports)
    if settings.both_hands:
        found += _expected(settings, found)
    return GlovesFound(tuple(found), tuple(remarks))


def bound_sides(settings: AppSettings) -> list[str]:
    """The sides of all gloves that were set up."""
    known = (bound(settings, int(number)) for number in settings.gloves if number.isdecimal())
    return [glove.side for glove in known if glove is not None]


def probe_ports(
    progress: JobProgress, named: Sequence[str], baud: int = 0, first_only: bool = True
) -> tuple[list[PortReport], list[str]]:
    """Returns the ports with a glove, the ``named`` ones first, and the problems of the others.

    They are probed at ``baud``, or at each baud rate that gloves use.
    """
    # ports that are not on USB are not listed; the user entered them
    ports = list(dict.fromkeys((*named, *serial_ports())))
    reports: list[PortReport] = []
    problems: list[str] = []
    for i, path in enumerate(ports):
        progress(0.4 * i / len(ports), path)
        report = find_gloves([path], bauds=(baud,) if baud else BAUDS)[0]
        if not report.is_glove:
            problems += [notice_text(report.problem)] if report.problem is not None else []
            continue
        reports.append(report)
        if first_only:
            break
    return reports, problems


def _none(problems: Sequence[str]) -> Notice:
    if not problems:
        return notice("window.no_glove")
    return notice("window.no_glove_because", reasons=problems)


def _assigned(
    settings: AppSettings, reports: Sequence[PortReport]
) -> tuple[list[HandGlove], list[str]]:
    """A glove for each side, and remarks about stored files that are used and surplus gloves."""
    found: list[HandGlove] = []
    remarks: list[str] = []
    for report in reports:
        number = report.hello.glove_id if report.hello else None
        if found and bound(settings, number) is None:
            text = tr("Glove {} at {} is new. Choose its hand under Set-up, Glove.")
            remarks.append(text.format("–" if number is None else number, report.path))
            continue
        own, recalled = as_bound(settings, number)
        glove = _loaded(own.glove, own.hand, report, number)
        if glove.side in {other.side for other in found}:
            text = tr("Glove {} at {} is not used: there is already a glove for the {} hand.")
            remarks.append(text.format(number, report.path, _side(glove.side)))
            continue
        found.append(glove)
        remarks += [recalled] if recalled and len(reports) == 1 else []
    return found, remarks


def _expected(settings: AppSettings, found: Sequence[HandGlove]) -> list[HandGlove]:
    """The glove of the other hand, which is not connected yet."""
    if len(found) != 1:
        return []
    other = "left" if found[0].side == "right" else "right"
    known = bound_of(settings, other)
    if known is None:
        return []
    number, glove = known
    return [replace(_loaded(glove.glove, glove.hand, None, number), port=glove.port)]


def _loaded(
    glove_name: str, hand_name: str, report: PortReport | None, number: int | None
) -> HandGlove:
    hand, glove = library.load(glove_name, hand_name)
    return HandGlove(glove_name, hand_name, hand, glove, report, number)


def _side(side: str) -> str:
    return tr("left") if side == "left" else tr("right")
