"""The touch test against trackers whose errors are known."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from extensions.touch.analyse import analyse
from extensions.touch.lengths import pinch_closure, stillness
from extensions.touch.protocol import (
    FINGERS,
    Cued,
    TouchCue,
    began,
    cues_of,
    ended,
    protocol,
    ruler,
    ruler_of,
    touches,
)
from extensions.touch.result import TouchResult
from extensions.touch.simulated.session import write_session
from extensions.touch.simulated.trial import Fault, SimulatedTrial
from extensions.touch.statistics import agreement_limits, bootstrap, sd_interval, share_interval
from extensions.touch.tests.known import KnownTracker
from extensions.touch.track import TipTrack
from tracker.base.errors import ConfigError
from tracker.cli import main

pytestmark = pytest.mark.long

BIAS = {"thumb": [0.002, 0.0, 0.001], "index": [0.0, -0.003, 0.0], "middle": [-0.001, 0, 0.004]}
SD = 0.002


def known(seed: int, fault: Fault | None = None, claimed: float = SD) -> KnownTracker:
    return KnownTracker(SimulatedTrial(seed, fault, lead=1.0), BIAS, SD, claimed)


@pytest.fixture(scope="module")
def tracked() -> list[KnownTracker]:
    """Two wearers; the second has a print that is 1 % too small."""
    return [known(1), known(2, Fault("print", print_scale=0.99))]


@pytest.fixture(scope="module")
def sessions(tracked: list[KnownTracker], tmp_path_factory) -> list[Path]:
    folder = tmp_path_factory.mktemp("touch")
    out = []
    for k, tracker in enumerate(tracked):
        out.append(folder / f"{k}.mcap")
        write_session(out[-1], tracker.trial, tracker.estimates())
    return out


@pytest.fixture(scope="module")
def results(sessions: list[Path]) -> list[TouchResult]:
    return [analyse(path) for path in sessions]


def test_bias_and_spread_agree_with_the_known_errors(tracked, results) -> None:
    """Bias of each finger within 2.5 mm and of all within 0.8 mm on average; pooled sd within 15 %.

    A wearer's pulp differs by 0.4 mm per axis and misses crosses by 0.6 mm per axis and touch. Last
    segments differ from the hand's size by 4 % of their length and 6 % of their radius: 1.4 mm.
    """
    off, found, true = [], [], []
    for tracker, result in zip(tracked, results, strict=True):
        assert result.count == 24 and not result.missed
        for f in result.fingers:
            off.append(f.pulp.error.mean(axis=0) - tracker.true_bias(f.finger))
            found.append(f.sd.value**2)
            true.append(tracker.true_variance(f.finger))
    lengths = np.linalg.norm(off, axis=1)
    assert lengths.max() < 2.5e-3 and np.abs(np.mean(off, axis=0)).max() < 0.8e-3
    assert np.sqrt(np.mean(found) / np.mean(true)) == pytest.approx(1.0, abs=0.15)


def test_intervals_contain_the_truth(tracked, results) -> None:
    """For 18 intervals of a bias at 95 %, at least 14: fewer has a probability below 1 %."""
    hit = 0
    for tracker, result in zip(tracked, results, strict=True):
        axes = tracker.trial.sheet.R_GS @ np.diag([1.0, -1.0, -1.0])
        for f in result.fingers:
            true_S = np.array(BIAS[f.finger]) @ axes
            hit += sum(b.low < x < b.high for b, x in zip(f.bias, true_S, strict=True))
    assert hit >= 14


def test_a_wrong_print_is_reported_and_does_not_affect_the_result(results) -> None:
    codes = [{n.code for n in result.notices} for result in results]
    assert ["touch.print_scale" in c for c in codes] == [False, True]
    assert results[1].pose.scale == pytest.approx(0.99, abs=0.002)


def test_claimed_sd_are_judged(results, tmp_path: Path) -> None:
    """Claims of half the true sd hold for far fewer errors than they should."""
    tracker = replace_bias(known(4, claimed=SD / 2))
    write_session(tmp_path / "s.mcap", tracker.trial, tracker.estimates())
    small = analyse(tmp_path / "s.mcap")
    assert small.claims[0].high < 0.6827 and small.claims[1].high < 0.9545


def replace_bias(tracker: KnownTracker) -> KnownTracker:
    """Without biases: only the spread is to be judged."""
    tracker.bias = {f: [0.0, 0.0, 0.0] for f in FINGERS}
    return tracker


def test_repeatability_over_wearings(tmp_path: Path, capsys) -> None:
    """Three wearings whose biases differ by a known SD. It is found to the accuracy that three
    fingers, three axes and 8 touches of 2 mm allow: 33 % (95 %, chi-square with 18 degrees of
    freedom)."""
    rng, sd_wearing, names = np.random.default_rng(7), 0.003, []
    trial = SimulatedTrial(5, lead=1.0)
    for k in range(3):
        tracker = KnownTracker(
            trial,
            {f: rng.normal(0, sd_wearing, 3).tolist() for f in FINGERS},
            SD,
            SD,
        )
        tracker.noise = rng.normal(0, SD, tracker.noise.shape)
        names.append(tmp_path / f"wearing{k}.mcap")
        write_session(names[-1], tracker.trial, tracker.estimates())
    out = tmp_path / "r.html"
    words = [*map(str, names), "-o", str(out), "--json", str(tmp_path / "r.json")]
    assert main(["touch-test", *words]) == 0
    found = json.loads((tmp_path / "r.json").read_text())
    fingers = found["fingers"].values()
    wearing = np.sqrt(np.mean([f["wearing_sd_mm"] ** 2 for f in fingers]))
    within = np.sqrt(np.mean([f["within_sd_mm"] ** 2 for f in fingers]))
    assert wearing == pytest.approx(1e3 * sd_wearing, rel=0.35)
    assert within == pytest.approx(1e3 * np.hypot(SD, 0.0006), rel=0.15)
    for f in fingers:
        expected = 1.96 * np.sqrt(2) * np.hypot(f["wearing_sd_mm"], f["within_sd_mm"])
        assert f["limit_mm"] == pytest.approx(expected)
    assert found["line"] in capsys.readouterr().out and "<h1>" in out.read_text("utf-8")


def test_ruler_and_return_tests(results) -> None:
    """Errors of 2 mm per axis: a length of 80 mm is off by 2.8 mm, and the scale of some 20
    independent ones by 0.8 %; two errors differ by 2 √(2 · 3) = 4.9 mm."""
    for result in results:
        assert result.ruler is not None and result.ruler.count > 60
        assert result.ruler.scale.value == pytest.approx(1.0, abs=0.03)
        assert 0.01 < result.ruler.scale.high - result.ruler.scale.low < 0.06
        assert result.returned is not None and 0.5e-3 < result.returned.value < 9e-3


def test_touches_without_cues_are_found_too(tracked, sessions, tmp_path: Path) -> None:
    from tracker.messages import Estimate
    from tracker.session.reader import SessionReader

    with SessionReader(sessions[0]) as reader:
        kept = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]
    trial = tracked[0].trial
    motion, trial.motion.cued = list(trial.motion.cued), []
    write_session(tmp_path / "free.mcap", trial, kept)
    trial.motion.cued = motion
    free = analyse(tmp_path / "free.mcap")
    asked = {(c.cue.finger, c.cue.target) for c in motion}
    assert free.count >= 18
    assert {(t.cue.finger, t.cue.target) for t in free.touches} <= asked


def test_the_command_writes_page_pdf_and_json(sessions, tmp_path: Path, capsys) -> None:
    page, numbers = tmp_path / "r.html", tmp_path / "r.json"
    assert main(["touch-test", str(sessions[0]), "-o", str(page), "--json", str(numbers)]) == 0
    found = json.loads(numbers.read_text())
    assert found["line"] in page.read_text() and found["line"] in capsys.readouterr().out
    assert found["touches"] == 24 and set(found["fingers"]) == set(FINGERS)
    assert page.with_suffix(".pdf").read_bytes().count(b"/MediaBox") == 1
    assert "<svg" in page.read_text()
    assert main(["touch-test", str(sessions[0]), "-o", str(page)]) == 1  # exists
    before = page.read_bytes(), page.with_suffix(".pdf").read_bytes()
    assert main(["touch-test", str(sessions[0]), "-o", str(page), "--force"]) == 0
    assert (page.read_bytes(), page.with_suffix(".pdf").read_bytes()) == before


def test_too_few_touches_are_an_error(tracked, tmp_path: Path) -> None:
    path = tmp_path / "few.mcap"
    write_session(path, tracked[0].trial, tracked[0].estimates()[:100])
    with pytest.raises(ConfigError) as caught:
        analyse(path)
    assert caught.value.notice.code == "touch.too_few"


def test_events_carry_the_protocol() -> None:
    cues = protocol()
    assert len(touches()) == 24 and [c.finger for c in touches()].count("index") == 8
    events = [ruler(0.2595, 0.0)]
    for k, cue in enumerate(cues):
        events += [began(cue, 10.0 * k), ended(cue, 10.0 * k + 5)]
    events += [began(cues[0], 900.0), ended(cues[0], 905.0), began(cues[1], 910.0)]
    events += [ended(cues[1], 911.0, done=False)]
    found = cues_of(events)
    assert [c.cue for c in found] == [*cues[1:], cues[0]] and found[-1].begin == 900.0
    assert ruler_of(events) == pytest.approx(0.2595)
    odd = replace(events[1], data={**events[1].data, "target": "99"})
    assert cues_of([odd, events[2]]) == []


def still_track(t: np.ndarray, p: np.ndarray) -> TipTrack:
    n = len(t)
    return TipTrack(t, p, np.tile(np.eye(3), (n, 1, 1)), np.full(n, 1e-3), np.ones(n, bool), 0.008)


def test_pinches_and_stillness_of_known_movements() -> None:
    t = np.arange(0, 20, 0.01)
    gap = 0.0035 + 0.03 * (1 - np.cos(2 * np.pi * t)) / 2
    index = np.column_stack([gap, np.zeros(len(t)), np.zeros(len(t))])
    tracks = {"thumb": still_track(t, np.zeros((len(t), 3))), "index": still_track(t, index)}
    cued = [Cued(TouchCue(25, "pinch"), 0.5, 19.6)]
    closure = pinch_closure(tracks, cued, {})
    assert closure is not None and closure.count == 19
    assert closure.gap.value == pytest.approx(0.0035, abs=2e-4) and closure.sd.value < 2e-4
    noise = np.random.default_rng(1).normal(0, 0.0007, (len(t), 3))
    still = stillness({"index": still_track(t, noise)}, [Cued(TouchCue(26, "still"), 5.0, 15.0)])
    assert still[0].noise == pytest.approx(0.0007, rel=0.05)
    assert still[0].jitter == pytest.approx(0.0007, rel=0.05)
    assert still[0].seconds == pytest.approx(10.0, abs=0.05)


def test_statistics_against_tables() -> None:
    """Student's t and chi-square of published tables; Bland & Altman's peak flow (1986)."""
    sd = sd_interval(10.0, 9)
    assert (sd.low, sd.high) == pytest.approx((6.88, 18.26), abs=0.01)  # χ²: 19.023, 2.700
    share = share_interval(8, 10)
    assert (share.low, share.high) == pytest.approx((0.490, 0.943), abs=0.001)
    low, high = agreement_limits(-2.1, 38.8, 17)
    assert (low.value, high.value) == pytest.approx((-78.1, 73.9), abs=0.1)
    assert low.high - low.value == pytest.approx(2.12 * np.sqrt(3 / 17) * 38.8, abs=0.1)
    values = np.random.default_rng(3).normal(1.0, 2.0, 200)
    found = bootstrap(values, lambda v: np.mean(v, axis=1))
    half = 1.96 * values.std() / np.sqrt(200)
    assert found.high - found.value == pytest.approx(half, rel=0.15)
