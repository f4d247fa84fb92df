"""`evaluate fingers` on a small scale."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from extensions.evaluation.fingers.command import CLOTH, DISTAL, WITHOUT, rows_of, table
from extensions.evaluation.fingers.trial import (
    DIGITS,
    TIPS,
    Seen,
    TipErrors,
    as_cloth,
    capsules,
    shares_seen,
    silhouette,
)
from tracker.cli import main
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.messages import CameraPose
from tracker.vision.cloth import INSIDE, STEP, cloth_at, cloth_map
from tracker.vision.rig import ideal_rig


def test_rows_separate_the_states_and_pool_the_sessions() -> None:
    measured, share = np.array([True, False]), np.array([0.9, 0.5])
    seen = TipErrors(np.array([0.004, 0.03]), np.array([0.003, 0.02]), measured, share)
    hidden = TipErrors(np.array([0.05]), np.array([0.01]), np.array([False]), np.array([0.4]))
    (row,) = rows_of([{"ring_tip": seen}, {"ring_tip": hidden}], cloth="with")
    assert (row.tip, row.error_mm) == ("ring_tip", pytest.approx(28.0))
    assert row[3:] == pytest.approx((1 / 3, 4.0, 40.0, 2 / 3, 17.0))
    (other,) = rows_of([{"ring_tip": hidden}], cloth="without")
    assert other.measured_mm is None and other.visible_mm is None
    assert [line.split()[1] for line in table([row, other])[1:]] == ["with", "without"]


@pytest.mark.long
def test_sessions_without_cloth_are_tracked_the_same_both_times_and_with_silhouettes(
    tmp_path: Path,
) -> None:
    """True silhouettes show the ring finger of a session that has only blobs."""
    session, out = tmp_path / "s.mcap", tmp_path / "rows.json"
    short, other = ["--blobs-only", "--duration", "2.5", "--fps", "15"], tmp_path / "distal.mcap"
    assert main(["simulate", "-o", str(session), *short]) == 0
    assert main(["simulate", "-o", str(other), "--glove", "vist-small-distal", *short]) == 0
    distal = ["--distal", str(other)]
    assert main(["evaluate", "fingers", str(session), *distal, "--json", str(out)]) == 0
    report = json.loads(out.read_text())
    rows = report["rows"]
    assert [(r["tip"], r["cloth"]) for r in rows] == [
        (t, c) for c in (*CLOTH, DISTAL) for t in TIPS
    ]
    for with_cloth, without in zip(rows[5:10], rows[:5], strict=True):
        assert {**with_cloth, "cloth": WITHOUT} == without
        assert with_cloth["measured"] == 0.0 or "ring" not in with_cloth["tip"]
    without, _, bound, marked = ({r["tip"]: r for r in rows[k : k + 5]} for k in range(0, 20, 5))
    assert bound["ring_tip"]["error_mm"] < 0.95 * without["ring_tip"]["error_mm"]
    sensed = TIPS[:3]  # patches show their end joints
    assert all(marked[t]["measured"] > 0.9 > 0.1 > without[t]["measured"] for t in sensed)
    # no worse: in 2.5 s of one wearer the prior may be as good as what is measured
    assert np.mean([marked[t]["error_mm"] - without[t]["error_mm"] for t in sensed]) < 1.0
    assert report["cost"]["pairs"] > 20
    assert 0.0 < report["cost"]["median_ms"] <= report["cost"]["p99_ms"]


@pytest.mark.parametrize("right", [False, True])
def test_a_silhouette_is_where_the_true_hand_is(hand: HandModel, right: bool) -> None:
    """On its last segments, and neither beyond nor beside them."""
    rig = ideal_rig(pose=CameraPose(np.diag([1.0, -1.0, -1.0]), np.array([0.09, 0.0, 0.42])))
    R, p = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))
    ends, radius = capsules(hand.keypoints(R, p), hand.keypoint_names, hand)
    in_C = (ends - rig.pose.p_GC) @ rig.pose.R_GC
    mask = silhouette(in_C, radius, rig, right)
    tips = {f: hand.index[CHAINS[f][2]] for f in FINGERS}
    for finger, s in tips.items():
        length, r, along = hand.segments[s].length, hand.segments[s].radius, R[s][:, 0]
        points = [(p[s] + 0.5 * length * along, True), (p[s] + 1.3 * length * along, False)]
        if finger in ("index", "little"):  # nothing is beside them
            other = tips["middle" if finger == "index" else "ring"]
            away = p[s] - p[other] - along * (along @ (p[s] - p[other]))
            points.append((points[0][0] + 1.6 * r * away / np.linalg.norm(away), False))
        for point, covered in points:
            u, v = rig.project(((point - rig.pose.p_GC) @ rig.pose.R_GC)[None], right)[0]
            assert mask[int(v / STEP + 0.5), int(u / STEP + 0.5)] == covered, finger
    cloth = as_cloth(mask)
    again = [cloth_at(cloth_map(cloth), STEP * u, STEP * v) for v, u in np.argwhere(mask)[::97]]
    assert again == [INSIDE] * len(again)
    assert np.mean(mask) < 0.3


ABOVE = CameraPose(np.diag([1.0, -1.0, -1.0]), np.array([0.09, 0.0, 0.42]))


def test_digits_are_visible_that_nothing_covers(hand: HandModel) -> None:
    R, p = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3))
    points = hand.keypoints(R, p)
    rig = ideal_rig(pose=ABOVE)

    def seen(pose: CameraPose) -> dict[str, float]:
        share = shares_seen(points, hand.keypoint_names, hand, rig, pose)
        return dict(zip(DIGITS, share.tolist(), strict=True))

    from_above = seen(ABOVE)  # only the knuckles, and the ball of the thumb, are behind the palm's
    assert min(from_above[f] for f in FINGERS) > 0.75 and max(from_above.values()) <= 1.0
    assert from_above["thumb"] > 0.6
    # From beside the index finger, which hides the others; its own knuckle is all that is hidden.
    index = points[hand.keypoint_names.index("index_mcp")]
    little = points[hand.keypoint_names.index("little_mcp")]
    outwards = np.sign(index[1] - little[1])
    R_GC = np.column_stack([[1.0, 0.0, 0.0], [0.0, 0.0, -outwards], [0.0, -outwards, 0.0]])
    beside = seen(CameraPose(R_GC, np.array([0.09, 0.42 * outwards, 0.0])))
    assert beside["index"] > 0.75 and beside["ring"] < 0.3 and beside["little"] < 0.4
    # A hand that is left of both images.
    away = seen(CameraPose(ABOVE.R_GC, np.array([0.7, 0.0, 0.42])))
    assert max(away.values()) == 0.0


def test_an_instant_has_the_share_of_the_closest_pair() -> None:
    seen = Seen(np.array([1.0, 1.1]), np.array([[0.1, 0, 0, 0, 0.9], [0.2, 0, 0, 0, 0.8]]))
    assert (seen.at(1.04, "little"), seen.at(1.06, "thumb")) == (0.9, 0.2)
    assert np.isnan(Seen(np.zeros(0), np.zeros((0, 5))).at(1.0, "thumb"))
