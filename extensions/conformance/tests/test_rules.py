"""Each rule on a hand whose motion is known, and on one with the fault that the rule is for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from extensions.conformance.isaac.record import HandRecord, Stamps, joints_of
from extensions.conformance.isaac.writer import write_records
from extensions.conformance.page import as_json, page
from extensions.conformance.run import TakeVerdict, cues, judge, read_take
from extensions.conformance.take import (
    RecordTake,
    ScriptStep,
    labels_path,
    read_labels,
    take_of,
    write_labels,
)
from tests.fixtures import RESOURCES
from tracker.geometry import so3
from tracker.hand.files import load_hand
from tracker.hand.openxr import OpenXrHand, joint_radii, openxr_joints
from tracker.simulation.gestures import Gestures, tip_distances

pytestmark = pytest.mark.long

SIDES = ("right", "left")
HZ = 30


@pytest.fixture(scope="module")
def scripted() -> dict[str, tuple[list[HandRecord], list[ScriptStep]]]:
    """The true motion of the script, without sensors, one metre above the floor."""
    out = {}
    for side in SIDES:
        hand = load_hand(RESOURCES / "hands" / f"reference-{side}.toml")
        shown, labels = cues(side)
        motion = Gestures(hand, shown, seed=4)
        t = np.arange(int(motion.duration * HZ)) / HZ
        poses = zip(*motion.poses(t), strict=True)
        placed = [hand.forward(angles, R, p + [0.0, 0.0, 1.0]) for angles, R, p in poses]
        q = so3.quat_from_matrix(np.array([R for R, _ in placed]))[:, list(hand.keypoint_segment)]
        points, state = np.array([hand.keypoints(*one) for one in placed]), np.full(q.shape[:2], 2)
        xr = openxr_joints(points, q, state, hand.keypoint_names, joint_radii(hand))
        records = []
        each = zip(xr.position, xr.orientation, xr.state, xr.radius, strict=True)
        for k, joints in enumerate(each):
            sample = round(k / HZ * 1e9)
            stamps = Stamps(sample + 2_000_000, sample, sample)
            records.append(HandRecord(stamps, joints_of(OpenXrHand(t[k], *joints))))
        steps = [
            ScriptStep(label, round(start * 1e9), round((start + cue.hold) * 1e9))
            for cue, label, start in zip(shown, labels, motion.starts, strict=True)
            if label
        ]
        out[side] = records, steps
    return out


def verdict(
    scripted, change: Callable[[RecordTake], RecordTake] | None = None, side: str = "right"
) -> TakeVerdict:
    records, steps = scripted[side]
    take = take_of(side, records)
    return judge("test", [change(take) if change else take], steps)


def failed(v: TakeVerdict) -> set[str]:
    return {f.rule for f in v.findings if f.status == "fail"}


@pytest.mark.parametrize("side", SIDES)
def test_a_true_hand_that_follows_the_script_keeps_every_rule(scripted, side: str) -> None:
    v = verdict(scripted, side=side)
    bad = [(f.rule, f.status, f.figure) for f in v.findings if f.status != "pass"]
    assert v.ok and not bad, bad
    assert {f.layer for f in v.findings} == {"signal", "shape", "placement", "steps"}


def test_a_pinch_of_the_simulator_touches_the_named_finger(scripted) -> None:
    for side in SIDES:
        hand = load_hand(RESOURCES / "hands" / f"reference-{side}.toml")
        shown, _ = cues(side)
        motion = Gestures(hand, shown, seed=1)
        for cue, start in zip(motion.cues, motion.starts, strict=True):
            if cue.gesture.startswith("pinch_"):
                angles = motion.poses(np.array([start + 0.5])).angles[0]
                reach = tip_distances(hand, angles)
                finger = cue.gesture.removeprefix("pinch_")
                assert min(reach, key=reach.__getitem__) == finger and reach[finger] < 0.02
                low, high = hand.angle_limits.T
                assert (angles >= low - 1e-9).all() and (angles <= high + 1e-9).all()


def _mirrored(take: RecordTake) -> RecordTake:
    position = take.position * [-1, 1, 1]
    q = take.orientation * [1, -1, -1, 1]
    return replace(take, position=position, orientation=q)


def _noisy(take: RecordTake) -> RecordTake:
    rng = np.random.default_rng(1)
    return replace(take, position=take.position + rng.normal(0, 0.015, take.position.shape))


def _dead_finger(take: RecordTake) -> RecordTake:
    valid, position = take.valid.copy(), take.position.copy()
    rows = slice(len(take) // 2, None)
    valid[rows, 7:11], position[rows, 7:11] = False, np.nan
    return replace(take, valid=valid, position=position)


def _stiff_ring(take: RecordTake) -> RecordTake:
    """The ring finger's tip joints exchanged with the index': a wrong assignment."""
    order = list(range(26))
    order[7:11], order[17:21] = order[17:21], order[7:11]
    return replace(take, position=take.position[:, order], orientation=take.orientation[:, order])


def _jump(take: RecordTake) -> RecordTake:
    position = take.position.copy()
    position[500] += 1.0
    return replace(take, position=position)


def _gap(take: RecordTake) -> RecordTake:
    later = np.where(np.arange(len(take)) > 300, 200_000_000, 0)
    return replace(take, sample=take.sample + later, available=take.available + later)


def _jitter(take: RecordTake) -> RecordTake:
    rng = np.random.default_rng(3)
    period = round(1e9 / HZ)
    late = rng.integers(0, 3 * period // 4, len(take))
    return replace(take, sample=take.sample + late, available=take.available + period)


def _wxyz(take: RecordTake) -> RecordTake:
    return replace(take, orientation=take.orientation[..., [3, 0, 1, 2]])


def _unturned(take: RecordTake) -> RecordTake:
    """The wrist's quaternion remains that of the first record."""
    q = take.orientation.copy()
    q[:, 1] = q[0, 1]
    return replace(take, orientation=q)


def _growing(take: RecordTake) -> RecordTake:
    size = np.linspace(0.7, 1.3, len(take))[:, None, None]
    wrist = take.position[:, 1:2]
    return replace(take, position=wrist + size * (take.position - wrist))


def _at_origin(take: RecordTake) -> RecordTake:
    return replace(take, position=take.position - take.position[:, 1:2])


FAULTS = {
    "mirrored": (_mirrored, {"a right hand"}),
    "noisy": (_noisy, {"rigid bones", "knuckles in order"}),
    "a finger's IMU dies": (_dead_finger, {"all 21 joints", "the same joints all along"}),
    "fingers exchanged": (_stiff_ring, {"knuckles in order", "pinch_index"}),
    "a jump": (_jump, {"joint speed"}),
    "a gap": (_gap, {"no gaps"}),
    "jitter": (_jitter, {"regular intervals"}),
    "in mm": (lambda t: replace(t, position=t.position * 1e3), {"wrist to middle tip"}),
    "wxyz": (_wxyz, {"−z along the bones, xyzw"}),
    "wrist not turned": (_unturned, {"wrist and joints turn together"}),
    "a growing hand": (_growing, {"rigid bones"}),
    "left at the origin": (_at_origin, {"the wrist is in the room"}),
    "no radius": (lambda t: replace(t, radius=t.radius * 0), {"radius"}),
    "late clock": (lambda t: replace(t, available=t.sample - 1), {"available after sampled"}),
    "not unit": (lambda t: replace(t, orientation=t.orientation * 1.1), {"unit quaternions"}),
    "absent": (
        lambda t: replace(t, active=np.arange(len(t)) % 10 > 0),
        {"a hand in the records"},
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_found_by_the_rule_that_is_for_it(scripted, name: str) -> None:
    change, rules = FAULTS[name]
    v = verdict(scripted, change)
    assert not v.ok
    assert rules <= failed(v), failed(v)


def test_a_rule_is_not_broken_by_an_unrelated_fault(scripted) -> None:
    assert failed(verdict(scripted, _gap)) == {"no gaps"}
    assert failed(verdict(scripted, _at_origin)) >= {"the wrist is in the room"}
    assert not failed(verdict(scripted, _jump)) - {"joint speed"}


def test_a_step_that_was_not_shown_fails_under_its_name(scripted) -> None:
    records, steps = scripted["right"]
    take = take_of("right", records)
    still = next(s for s in steps if s.label == "open_hand_close")
    by = {"fist": still, "pinch_ring": still, "wrist_rotate": still}
    wrong = [
        ScriptStep(s.label, by[s.label].start_ns, by[s.label].end_ns) if s.label in by else s
        for s in steps
    ]
    assert {"fist", "pinch_ring", "wrist_rotate", "windows in order"} <= failed(
        judge("test", [take], wrong)
    )


def test_without_labels_the_steps_are_not_known(scripted) -> None:
    records, _ = scripted["right"]
    v = judge("test", [take_of("right", records)], [])
    assert not v.ok and not failed(v)
    assert {f.rule for f in v.findings if f.status == "not enough data"} == {
        "scripted steps",
        "wrist and joints turn together",
    }


def test_a_turned_room_changes_nothing_but_the_place(scripted) -> None:
    """Shape is judged in the wrist's frame."""
    turn = Rotation.from_euler("xyz", [0.4, 1.0, -2.0])

    def turned(take: RecordTake) -> RecordTake:
        q = turn * Rotation.from_quat(take.orientation.reshape(-1, 4))
        position = take.position @ turn.as_matrix().T
        return replace(take, position=position, orientation=q.as_quat().reshape(-1, 26, 4))

    assert not failed(verdict(scripted, turned))


class _Page(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.foreign: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.foreign += [v for k, v in attrs if k in ("src", "href") and v]


def test_the_page_is_self_contained_and_lists_every_figure(scripted) -> None:
    v = replace(verdict(scripted, _gap), name="<take> & more.mcap")
    text = page(v)
    read = _Page()
    read.feed(text)
    assert not read.foreign and "script" not in read.tags
    assert read.tags.count("svg") >= 8
    assert "&lt;take&gt; &amp; more.mcap" in text
    assert all(part in text for f in v.findings for part in (f.rule.split("−")[0],))
    assert as_json(v)["ok"] is False
    assert len(as_json(v)["findings"]) == len(v.findings)


def test_a_record_and_its_labels_are_read_again(scripted, tmp_path: Path) -> None:
    path = tmp_path / "take.mcap"
    write_records(path, {side: scripted[side][0] for side in SIDES})
    steps = scripted["right"][1]
    write_labels(labels_path(path), path.name, steps, 0)
    assert labels_path(path).name == "take.labels.json"
    assert read_labels(labels_path(path)) == steps
    takes, again = read_take(path)
    assert again == steps and {t.side for t in takes} == {"right", "left"}
    v = judge("take", takes, again)
    assert v.ok, failed(v)
