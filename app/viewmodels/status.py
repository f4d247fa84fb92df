"""The status bar: rates, latency, losses and the tracking state."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

from app.viewmodels.states import BAD, GOOD, IDLE, PURPLE, TRACKING, WARN, StateLook
from app.words import local, mark, notice_text, tr
from tracker.live.load import BEGINS
from tracker.messages import Shed, Status, Tracking

LATENCY_WARN_MS = 60.0
LATENCY_BAD_MS = 120.0
STALE = (Tracking.TRACKING, Tracking.COASTING)
STAGES = {
    "detect": mark("Search of both images"),
    "filter": mark("Engine step for a message"),
    "imu": mark("Arrival of a packet to its estimate"),
    "total": mark("Arrival of an image to its estimate"),
    "screen": mark("Sample to the screen"),
    "stream": mark("Sample to the streams"),
    "motor": mark("Sample to a motor"),
}
ALWAYS = ("detect", "filter", "imu", "total")
SHED = {
    Shed.VIEW_RATE: mark("3D view slower"),
    Shed.OVERLAYS: mark("overlays off"),
    Shed.WHOLE_SEARCHES: mark("full-frame search off"),
    Shed.IMAGES: mark("fewer images searched"),
}


@dataclass(frozen=True)
class Field:
    """One value: its name, text and state.

    ``short``: abbreviated for little space; empty if it cannot be shortened.
    """

    key: str
    name: str
    text: str
    look: StateLook
    tip: str
    short: str = ""

    @property
    def full(self) -> str:
        """Name and text."""
        return f"{self.name} {self.text}".strip()


def tracking_look(
    status: Status | None,
    running: bool,
    has_place: bool = True,
    replayed: bool = False,
    brief: bool = False,
) -> StateLook:
    """``has_place``: whether a calibrated camera provides the position. ``replayed``: the status is
    from a session. ``brief``: without the heading's sd."""
    if not running or status is None:
        return StateLook(IDLE.colour, IDLE.sign, tr("Stopped"))
    if replayed:
        return StateLook(PURPLE, "▶", tr("Replay: {}").format(tr(TRACKING[status.tracking].word)))
    if nothing_arrives(status):
        return StateLook(BAD.colour, BAD.sign, tr("No data"))
    if images_alone(status):
        return StateLook(IDLE.colour, IDLE.sign, tr("No data from the glove"))
    look = TRACKING[status.tracking]
    if status.tracking != Tracking.LOST:
        return replace(look, word=tr(look.word))
    word = tr(look.word) if has_place else tr("Position unknown")
    look = look if has_place else StateLook(WARN.colour, WARN.sign, word)
    heading_sd_deg = math.nan if brief else status.values.get("heading_sd_deg", math.nan)
    return replace(look, word=_drifting(word, heading_sd_deg))


def nothing_arrives(status: Status) -> bool:
    """Whether neither packets nor images arrive any more; the tracking state is outdated."""
    rates = [status.values[key] for key in ("imu_rate_hz", "frame_rate_hz") if key in status.values]
    return bool(rates) and not any(rate > 0 for rate in rates) and status.tracking in STALE


def images_alone(status: Status) -> bool:
    """Whether images arrive but no packets: then no hand can be found."""
    values = status.values
    searching = status.tracking == Tracking.SEARCHING
    return searching and "frame_rate_hz" in values and not values.get("imu_rate_hz", 0.0) > 0


def _drifting(word: str, heading_sd_deg: float) -> str:
    """With the possible error of the heading, which drifts without images."""
    if not math.isfinite(heading_sd_deg):
        return word
    return tr("{}, heading within {:.0f}°").format(word, 2 * heading_sd_deg)


def hand_tip(status: Status | None) -> str:
    """Details of one of two hands: rate and losses of its glove."""
    values = status.values if status is not None else {}
    glove, losses = _glove(values), _losses(values)
    return f"{glove.name} {glove.text}\n{losses.name} {losses.text}"


def fields(status: Status | None, replayed: bool = False) -> list[Field]:
    """The values of the status bar, in order; without states for a replay."""
    v = status.values if status is not None else {}
    found = _fields(status, v)
    if not replayed:
        return found
    tip = tr("As recorded")
    shown = [replace(f, look=IDLE, tip=f"{f.tip}\n{tip}") for f in found if f.key != "shed"]
    return [*shown, _shed({})]


def _fields(status: Status | None, v: Mapping[str, float]) -> list[Field]:
    return [
        _glove(v),
        _rate("frame_rate_hz", tr("Camera"), v, tr("Stereo images per second")),
        _hand(status),
        _latency(v),
        _losses(v),
        _shed(v),
    ]


def _shed(values: Mapping[str, float]) -> Field:
    """Describes what is reduced because the system is overloaded; empty if nothing is."""
    level = int(values.get("load_shed", 0.0))
    if level <= 0:
        return Field("shed", "", "", IDLE, "")
    names = ", ".join(tr(SHED[step]) for step in SHED if step <= level)
    details = "\n".join(notice_text(BEGINS[step]) for step in SHED if step <= level)
    return Field("shed", tr("System overloaded:"), names, WARN, details, tr("Overloaded"))


def _glove(values: Mapping[str, float]) -> Field:
    """Rate of the glove, and a warning while its battery is low."""
    field = _rate("imu_rate_hz", tr("Glove"), values, tr("Packets of the glove per second"))
    if not values.get("battery_low") or field.look not in (GOOD, IDLE):
        return field
    volts = f"{local(values['battery_v']):.2f}"
    low = tr("The glove's battery is low ({} V). Charge it soon.").format(volts)
    tip = f"{field.tip}\n{low}"
    return replace(field, text=tr("{}, battery low").format(field.text), look=WARN, tip=tip)


def _hand(status: Status | None) -> Field:
    """Rate of the estimates; none with only a camera."""
    values = status.values if status is not None and not images_alone(status) else {}
    tip = tr("Estimates of the hand per second")
    return _rate("estimate_rate_hz", tr("Hand"), values, tip)


def _rate(key: str, name: str, values: Mapping[str, float], tip: str) -> Field:
    rate = values.get(key, math.nan)
    if not math.isfinite(rate):
        return Field(key, name, "–", IDLE, tip)
    return Field(key, name, f"{rate:.0f} Hz", GOOD if rate > 0 else BAD, tip)


def _latency(values: Mapping[str, float]) -> Field:
    tip = "\n".join([tr("Of each stage, median (99th percentile):"), *_stages(values)])
    total = values.get("latency_total_ms", math.nan)
    if not math.isfinite(total):
        return Field("latency", tr("Latency"), "–", IDLE, tip)
    worst = values.get("latency_total_p99_ms", math.nan)
    text = f"{total:.0f} ms" + (f" (99 %: {worst:.0f})" if math.isfinite(worst) else "")
    look = GOOD if total < LATENCY_WARN_MS else WARN if total < LATENCY_BAD_MS else BAD
    short = f"{tr('Latency')} {total:.0f} ms"
    return Field("latency", tr("Latency"), text, look, tip, short)


def _stages(values: Mapping[str, float]) -> list[str]:
    """One line per stage, from the counters in `/tracker/status`."""
    return [
        f"{tr(name)}: {_ms(values, f'latency_{key}_ms')} ({_ms(values, f'latency_{key}_p99_ms')})"
        for key, name in STAGES.items()
        if key in ALWAYS or f"latency_{key}_ms" in values
    ]


def _ms(values: Mapping[str, float], key: str) -> str:
    value = values.get(key, math.nan)
    return f"{local(value):.1f} ms" if math.isfinite(value) else "–"


def _losses(values: Mapping[str, float]) -> Field:
    tip = tr(
        "Lost packets of the glove; images dropped because they arrived faster than they were read"
    )
    lost, dropped = values.get("imu_lost", math.nan), values.get("frames_dropped", math.nan)
    if not math.isfinite(lost) and not math.isfinite(dropped):
        return Field("losses", tr("Lost"), "–", IDLE, tip)
    lost, dropped = (0.0 if math.isnan(x) else x for x in (lost, dropped))
    look = BAD if lost > 0 else GOOD
    return Field(
        "losses",
        tr("Lost"),
        tr("{} packets, {} images").format(f"{lost:.0f}", f"{dropped:.0f}"),
        look,
        tip,
        f"{tr('Lost')} {lost:.0f} + {dropped:.0f}",
    )
