"""Rules on the signal: finite values, ordered time stamps, no gaps, no jumps."""

from __future__ import annotations

import numpy as np

from extensions.conformance.finding import LayerJudge, RuleFinding
from extensions.conformance.take import RecordTake
from tracker.base.clock import NS

UNIT = 1e-3  # tolerance of a quaternion's norm
PRESENT = 0.95  # share of records with a hand
IRREGULAR = 0.2  # median deviation of the interval relative to its median
GAP = 5.0  # periods
FASTEST = 20.0  # m/s
SHORTEST = 0.004  # s: shorter intervals reflect the clock, not the hand


def judge_signal(take: RecordTake) -> list[RuleFinding]:
    judge = LayerJudge("signal", take)
    _numbers(take, judge)
    _stamps(take, judge)
    _speed(take, judge)
    return judge.found


def _numbers(take: RecordTake, judge: LayerJudge) -> None:
    values = np.concatenate([take.position, take.orientation], axis=2)[take.valid]
    bad = int((~np.isfinite(values)).any(axis=1).sum()) if len(values) else 0
    judge.say("finite", None if not len(values) else bad == 0, f"{bad} joints not finite", "0")
    length = np.linalg.norm(take.orientation[take.valid], axis=1)
    off = float(np.nanmax(np.abs(length - 1))) if len(length) else np.nan
    ok = None if not len(length) else off <= UNIT
    judge.say("unit quaternions", ok, f"{off:.1e} off 1", f"≤ {UNIT:g}")
    share = float(take.active.mean()) if len(take) else 0.0
    judge.say("a hand in the records", share >= PRESENT, f"{share:.1%}", f"≥ {PRESENT:.0%}")


def _stamps(take: RecordTake, judge: LayerJudge) -> None:
    steps = np.diff(take.sample)
    back = int((steps <= 0).sum() + (np.diff(take.available) < 0).sum())
    judge.say("stamps rise", None if len(take) < 2 else back == 0, f"{back} go back", "0")
    early = int((take.available < take.sample).sum())
    judge.say("available after sampled", early == 0, f"{early} before", "0")
    forward = steps[steps > 0] / NS
    if len(forward) < 10:
        judge.say("regular intervals", None, f"{len(forward)} intervals", f"≤ {IRREGULAR:g}")
        judge.say("no gaps", None, f"{len(forward)} intervals", f"≤ {GAP:g} periods")
        return
    period = float(np.median(forward))
    deviation = float(np.median(np.abs(forward - period))) / period
    plot = (forward * 1e3, "ms", (period * 1e3 * GAP,))
    figure = f"{deviation:.3f} of {period * 1e3:.1f} ms"
    judge.say("regular intervals", deviation <= IRREGULAR, figure, f"≤ {IRREGULAR:g}")
    longest = float(forward.max()) / period
    judge.say("no gaps", longest <= GAP, f"{longest:.1f} periods", f"≤ {GAP:g} periods", plot)


def _speed(take: RecordTake, judge: LayerJudge) -> None:
    dt = np.diff(take.sample) / NS
    steps = np.linalg.norm(np.diff(take.position, axis=0), axis=2)
    speed = np.where((dt >= SHORTEST)[:, None], steps / np.maximum(dt, SHORTEST)[:, None], np.nan)
    known = np.isfinite(speed).any(axis=1)
    most = np.full(len(speed), np.nan)
    most[known] = np.nanmax(speed[known], axis=1)
    top = float(np.nanmax(most)) if known.any() else np.nan
    ok = None if not known.any() else top <= FASTEST
    judge.say("joint speed", ok, f"{top:.1f} m/s", f"≤ {FASTEST:g} m/s", (most, "m/s", (FASTEST,)))
