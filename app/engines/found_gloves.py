"""The gloves that are plugged in, and whose each is: of one hand or of both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from app.platform.tasks import JobProgress
from app.storage.bound_gloves import as_bound, bound, bound_of, ports_of
from app.storage.settings import AppSettings
from app.words import notice_text, tr
from tracker.base.errors import DeviceError
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.sensors.discovery import PortReport, find_gloves, serial_ports
from tracker.sensors.glove_link import GloveLink, LinkParams, rates_at
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.protocol import BAUD, BAUDS


@dataclass(frozen=True)
class WornGlove:
    """A glove, there (``report``) or expected, by its files' names; ``glove_id`` None where it told
    no number."""

    glove_name: str
    hand_name: str
    hand: HandModel
    glove: GloveModel
    report: PortReport | None
    glove_id: int | None
    port: str = ""  # where one that is not there was found, if that is on no list

    @property
    def side(self) -> str:
        return self.glove.side

    def link(self, rate_hz: int = 100) -> GloveLink:
        """To where it is; one that is not there is looked for until it comes.

        ``rate_hz`` is asked of it where its line carries so much.
        """
        path, baud = (self.report.path, self.report.baud) if self.report else (self.port, BAUD)
        place = GlovePort(path, baud, glove_id=self.glove_id)
        rate = rate_hz if rate_hz in rates_at(baud) else LinkParams.rate_hz
        return GloveLink(place, len(self.glove.imus), LinkParams(rate, baud=baud))


@dataclass(frozen=True)
class GlovesFound:
    """At most one for each side, those that are there first; ``words`` say what is not as usual."""

    gloves: tuple[WornGlove, ...]
    words: tuple[str, ...]


def find_worn(progress: JobProgress, settings: AppSettings) -> GlovesFound:
    """Look for the gloves. Where both hands' were set up both are looked for, else the first one
    that answers does. Raises DeviceError if none is there."""
    both = settings.both_hands or len(set(bound_sides(settings))) > 1
    named = [port for port in (settings.port, *(ports_of(settings) if both else ())) if port]
    reports, troubles = ask_ports(progress, named, settings.baud, not both)
    if not reports:
        raise DeviceError(_none(troubles))
    found, words = _worn(settings, reports)
    if settings.both_hands:
        found += _expected(settings, found)
    return GlovesFound(tuple(found), tuple(words))


def bound_sides(settings: AppSettings) -> list[str]:
    """Of all gloves that were set up."""
    known = (bound(settings, int(number)) for number in settings.gloves if number.isdecimal())
    return [glove.side for glove in known if glove is not None]


def ask_ports(
    progress: JobProgress, named: Sequence[str], baud: int = 0, first_only: bool = True
) -> tuple[list[PortReport], list[str]]:
    """Ports with a glove behind them, the ``named`` ones first; and why others have none.

    They are asked at ``baud``, or at all that a glove may speak.
    """
    # those that are not on USB are on no list, and were chosen by hand
    ports = list(dict.fromkeys((*named, *serial_ports())))
    reports: list[PortReport] = []
    troubles: list[str] = []
    for i, path in enumerate(ports):
        progress(0.4 * i / len(ports), path)
        report = find_gloves([path], bauds=(baud,) if baud else BAUDS)[0]
        if not report.is_glove:
            troubles += [notice_text(report.trouble)] if report.trouble is not None else []
            continue
        reports.append(report)
        if first_only:
            break
    return reports, troubles


def _none(troubles: Sequence[str]) -> str:
    if not troubles:
        return tr("No glove was found: no USB serial port is there. Is it plugged in?")
    return tr("No glove was found. {}").format(" ".join(troubles))


def _worn(
    settings: AppSettings, reports: Sequence[PortReport]
) -> tuple[list[WornGlove], list[str]]:
    """A glove for each side, and sentences about files that were recalled and gloves too many."""
    found: list[WornGlove] = []
    words: list[str] = []
    for report in reports:
        number = report.hello.glove_id if report.hello else None
        if found and bound(settings, number) is None:
            text = tr("Glove {} at {} is new: choose its hand under Set-up, Glove.")
            words.append(text.format("–" if number is None else number, report.path))
            continue
        own, recalled = as_bound(settings, number)
        glove = _loaded(own.glove, own.hand, report, number)
        if glove.side in {other.side for other in found}:
            text = tr("Glove {} at {} is of the {} hand too, of which there is one already.")
            words.append(text.format(number, report.path, _side(glove.side)))
            continue
        found.append(glove)
        words += [recalled] if recalled and len(reports) == 1 else []
    return found, words


def _expected(settings: AppSettings, found: Sequence[WornGlove]) -> list[WornGlove]:
    """The glove of the other hand, which is not there yet."""
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
) -> WornGlove:
    hand, glove = library.load(glove_name, hand_name)
    return WornGlove(glove_name, hand_name, hand, glove, report, number)


def _side(side: str) -> str:
    return tr("left") if side == "left" else tr("right")
