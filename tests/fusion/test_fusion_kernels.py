"""Compiled and vectorised stages of the filters against their plain twins."""

import numpy as np
import pytest

from tracker.fusion.chain.distal import OFFSET, DistalSegments, Synergies
from tracker.fusion.chain.driven_ends import ONE_WAY, EndDeviations
from tracker.fusion.chain.kinematics import jacobians
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PixelNoise, SynergyParams
from tracker.fusion.chain.pixel_rows import stack_rows
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.prediction import PosedRig, Prediction, pixel_jacobians
from tracker.fusion.chain.reports import _details
from tracker.fusion.chain.state import initial_state
from tracker.fusion.kalman import joined, products, times, update
from tracker.fusion.output.output import (
    BASE_SD,
    INFERRED_DEG,
    HandOutput,
    Sensed,
    sensed_lately,
)
from tracker.geometry.kernels import rotate_all
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, Tracking, Validity
from tracker.vision.rig import ideal_rig

NOISE = PixelNoise(0.002, 0.7, 3.0)


def plain_rows(H: Array, HP: Array, A: Array, residual: Array) -> tuple[Array, ...]:
    """The stacked rows as in the formulas; noise as a list of blocks on the diagonal."""
    out_H, out_HP, out_r, blocks = [], [], [], []
    for k in range(len(H)):
        sides = [c for c in range(2) if np.isfinite(residual[c, k, 0])]
        if not sides:
            continue
        J = np.concatenate([A[c, k] for c in sides])
        r = np.concatenate([residual[c, k] for c in sides])
        noise = J @ J.T * NOISE.marker**2 + np.eye(len(J)) * NOISE.pixel_px**2
        S = J @ HP[k] @ H[k].T @ J.T + noise
        distance = np.sqrt(r @ np.linalg.inv(S) @ r / len(r))
        blocks.append(noise * max(1.0, distance / NOISE.huber) ** 2)
        out_H.append(J @ H[k])
        out_HP.append(J @ HP[k])
        out_r.append(r)
    R = np.zeros((sum(map(len, out_r)),) * 2)
    at = 0
    for block in blocks:
        R[at : at + len(block), at : at + len(block)] = block
        at += len(block)
    return np.concatenate(out_H), np.concatenate(out_HP), np.concatenate(out_r), R


def test_pixel_rows_are_the_plain_ones() -> None:
    """Markers of both cameras, of one, of none, and a distant one with reduced weight."""
    rng = np.random.default_rng(8)
    n, size = 9, 30
    H, A = rng.normal(size=(n, 3, size)), 900 * rng.normal(size=(2, n, 2, 3))
    root = 1e-3 * rng.normal(size=(size, size))
    HP = (H.reshape(-1, size) @ root @ root.T).reshape(H.shape)
    residual = rng.normal(0, 2.0, (2, n, 2))
    residual[0, :3], residual[1, 2:5] = np.nan, np.nan
    residual[0, 7] = 300.0
    expected = plain_rows(H, HP, A, residual)
    got = stack_rows(H, HP, A, residual, NOISE)
    assert got[0].shape == (2 * (2 * n - 6), size)
    for mine, plain in zip(got, expected, strict=True):
        assert np.abs(mine - plain).max() < 1e-10 * np.abs(plain).max()
    start = 2 * int(np.isfinite(residual[:, :7, 0]).sum())
    usual = A[0, 7] @ A[0, 7].T * NOISE.marker**2 + np.eye(2) * NOISE.pixel_px**2
    assert np.all(np.diag(got[3])[start : start + 2] > np.diag(usual))


def test_no_match_gives_no_rows() -> None:
    nothing = stack_rows(
        np.ones((2, 3, 5)), np.ones((2, 3, 5)), np.ones((2, 2, 2, 3)), np.full((2, 2, 2), np.nan),
        NOISE,
    )  # fmt: skip
    assert [a.shape for a in nothing] == [(0, 5), (0, 5), (0,), (0, 0)]


@pytest.mark.parametrize("tracking", [Tracking.TRACKING, Tracking.COASTING, Tracking.LOST])
@pytest.mark.parametrize("seed", range(4))
def test_validity_and_sd_follow_the_tree(
    hand: HandModel, glove: GloveModel, tracking: Tracking, seed: int
) -> None:
    """Segment by segment and keypoint by keypoint, as in the rules."""
    layout = ChainLayout(hand, glove)
    rng = np.random.default_rng(seed)
    sensed = rng.integers(0, 2, len(layout.active))
    sd = rng.uniform(0.001, 0.01, len(sensed))
    s = initial_state(layout)
    p = rng.normal(size=(len(sensed), 3))
    e = HandOutput(layout).estimate(0.0, s.R_GB, p, s.scale3(), Sensed(sensed, tracking), sd)
    positions = glove.keypoint_positions(hand, e.segment_R, e.segment_p)
    assert np.allclose(e.keypoints, positions, equal_nan=True) or tracking == Tracking.LOST
    assert np.isnan(e.keypoints).all() == (tracking == Tracking.LOST)
    seen = [bool(sensed[layout.row_of[i]]) if i in layout.row_of else False
            for i in range(len(hand.segments))]  # fmt: skip
    for i, columns in enumerate(hand.axis_columns):
        both = seen[i] and seen[max(hand.parent[i], 0)]
        for c in (c for c in columns if c >= 0):
            assert e.angle_state[c] in ((Validity.MEASURED,) if both else (Validity.INFERRED,))
    for k, i in enumerate(hand.keypoint_segment):
        base = not hand.keypoint_offset[k].any() and hand.parent[i] >= 0
        knuckle = base and hand.parent[i] == 0 and i not in layout.row_of
        measured = seen[i] or (base and not knuckle and seen[hand.parent[i]])
        expected = Validity.MEASURED if measured else Validity.INFERRED
        if tracking == Tracking.COASTING:
            expected = Validity.INFERRED
        elif tracking == Tracking.LOST:
            expected = Validity.LOST
        assert e.keypoint_state[k] == expected
        end = hand.parent[i] if base else i
        known = _sd(layout, sd, end, i, positions[k] - e.segment_p)
        if hand.segment_names[i].startswith(("ring", "little")):  # more in test_inferred_sd.py
            assert e.keypoint_sd[k] >= known * (1 - 1e-9)
        else:
            assert e.keypoint_sd[k] == pytest.approx(known)


def _sd(layout: ChainLayout, sd: Array, segment: int, moves_with: int, levers: Array) -> float:
    """For a keypoint at the end of ``segment``, which is a joint of the segment it moves with,
    or of that; ``levers`` (S, 3) m from the segments' origins."""
    row = segment
    knuckle = row == 0 and moves_with not in layout.row_of
    variance = BASE_SD**2 if knuckle else 0.0
    while row not in layout.row_of:
        variance += BASE_SD**2 if layout.hand.parent[row] == 0 else 0.0
        bone = layout.hand.segments[row]
        kind = bone.name if bone.name in INFERRED_DEG else bone.name.split("_")[1]
        variance += levers[row] @ levers[row] * np.deg2rad(INFERRED_DEG[kind]) ** 2 / 3
        row = layout.hand.parent[row]
    return float(np.sqrt(sd[layout.row_of[row]] ** 2 + variance))


def test_an_inferred_finger_is_never_certain(hand: HandModel, glove: GloveModel) -> None:
    """The little finger's tip of the seven-IMU glove: centimetres, however accurate the dorsum."""
    layout = ChainLayout(hand, glove)
    s = initial_state(layout)
    a = len(layout.active)
    sensed = Sensed(np.ones(a, np.int64), Tracking.TRACKING)
    e = HandOutput(layout).estimate(
        0.0, s.R_GB, np.zeros((a, 3)), s.scale3(), sensed, np.full(a, 1e-3)
    )
    sd = dict(zip(glove.keypoint_names(hand), e.keypoint_sd, strict=True))
    assert sd["little_tip"] > 0.01 < sd["ring_tip"]
    assert sd["index_dip"] == pytest.approx(1e-3)


def test_update_rejects_an_indefinite_innovation_covariance() -> None:
    """An invalid covariance must not be used for an update."""
    with pytest.raises(np.linalg.LinAlgError, match="not positive definite"):
        update(np.eye(3), np.eye(3), np.ones(3), np.diag([1.0, 1.0, -2.0]))


def test_sparse_rows_are_multiplied_like_dense_ones() -> None:
    rng = np.random.default_rng(9)
    H = np.where(rng.random((12, 40)) < 0.2, rng.normal(size=(12, 40)), 0.0)
    P = rng.normal(size=(40, 33))
    assert np.allclose(times(H, P), H @ P, atol=1e-12)


def test_pixel_jacobians_are_the_projections_own() -> None:
    """Against central differences of the rig's own projection, both cameras."""
    rig, rng = ideal_rig(), np.random.default_rng(11)
    p_G, step = rng.normal(0, 0.03, (6, 3)), 1e-7
    R, p = rig.pose.R_GC, rig.pose.p_GC
    A = pixel_jacobians((p_G - p) @ R, PosedRig.of(rig, rig.pose))
    for c in range(2):
        for i in range(3):
            ahead, behind = (
                rig.project((p_G + s * step * np.eye(3)[i] - p) @ R, right=bool(c)) for s in (1, -1)
            )
            assert np.allclose(A[c, :, :, i], (ahead - behind) / (2 * step), atol=1e-3)


def test_sd_of_the_ends_is_the_trace(hand: HandModel, glove: GloveModel) -> None:
    """For estimated segments by their Jacobians; for driven ones by the Jacobians used for guided
    poses, with the uncertainty of the bend multiplied by `ONE_WAY`."""
    layout, rng = ChainLayout(hand, glove), np.random.default_rng(12)
    distal = DistalSegments(layout, SynergyParams())
    state, sure = initial_state(layout), EndDeviations(layout, distal)
    state.R_GB = rotate_all(state.R_GB, rng.normal(0, 0.3, (len(layout.active), 3)))
    root, root_own = rng.normal(size=state.P.shape), rng.normal(size=2 * (3 * len(distal.digits),))
    state.P, prior = root @ root.T, distal.prior()
    own = Synergies(prior.value + rng.normal(0, 0.1, prior.value.shape), root_own @ root_own.T)
    sure.trust(own)
    sd = sure(state)
    none = np.full(len(layout.active), -1, np.int64)
    H = jacobians(layout.skeleton, layout.blocks, state.body, layout.tips, none)
    plain = [np.sqrt(np.trace(h @ state.P @ h.T) / 3) for h in H]
    assert np.allclose(sd[: len(H)], plain)
    assert [distal.digits[k].segment for k in range(3)] == list(sure.driven)
    for k, digit in enumerate(distal.digits):
        end = np.array([hand.segments[digit.segment].length, 0, 0])
        row = distal.point(state, own, digit.name, end)
        bend = row.H_own[:, 3 * k + OFFSET]
        posture = np.outer(bend, bend) * distal.posture_sd[k] ** 2
        known = np.trace(row.H @ state.P @ row.H.T)
        unknown = np.trace(row.H_own @ own.P @ row.H_own.T + posture)
        # The Jacobian of the bend is a difference quotient with a step of 1e-5 rad: accurate to
        # 1e-7.
        assert sd[len(H) + k] == pytest.approx(np.sqrt((known + ONE_WAY * unknown) / 3), rel=1e-5)


def test_joined_measurements_are_block_diagonal() -> None:
    rng = np.random.default_rng(13)
    root = rng.normal(size=(9, 9))
    P, H_1, H_2 = root @ root.T, rng.normal(size=(4, 9)), rng.normal(size=(3, 9))
    r_1, r_2, R_1, variance = (rng.normal(size=n) for n in (4, 3, (4, 4), 3))
    H, HP, HPH, r, R = joined(H_1, H_1 @ P, r_1, R_1, H_2, r_2, variance, P)
    assert np.array_equal(H, np.concatenate([H_1, H_2]))
    assert np.allclose(HP, H @ P) and np.allclose(HPH, H @ P @ H.T)
    assert np.array_equal(r, np.concatenate([r_1, r_2]))
    assert np.array_equal(R[:4, :4], R_1) and np.array_equal(R[4:, 4:], np.diag(variance))
    assert not R[:4, 4:].any() and not R[4:, :4].any()
    alone = products(H, P)
    assert np.allclose(alone[0], H @ P) and np.allclose(alone[1], H @ P @ H.T)


def test_details_of_an_image_are_the_plain_ones() -> None:
    """Residuals, sources, covariances and counts, marker by marker."""
    rng = np.random.default_rng(14)
    m, blobs = 6, 5
    uv, prior = rng.normal(size=(2, m, 2)), rng.random((2, m))
    match = np.array([[0, -1, 3, 2, -1, 4], [1, 2, -1, 0, -1, 3]])
    seen, source = rng.normal(size=(2, blobs, 2)), rng.permutation(2 * blobs).reshape(2, blobs)
    rows, S = np.array([0, 2, 3, 5]), rng.normal(size=(4, 2, 2))
    none = np.zeros((0, 3, 1))
    prediction = Prediction(
        rows, uv, prior, none, none, none, np.zeros((2, m, 2, 3)), np.stack([S, S])
    )
    blobs_of = [SeenBlobs(seen[c], np.zeros(blobs, np.int64), source[c]) for c in range(2)]
    residual, sources, cov, visible, stereo = _details(prediction, match, *blobs_of)
    for c in range(2):
        hit = match[c] >= 0
        assert np.array_equal(residual[hit, 2 * c : 2 * c + 2], (seen[c][match[c]] - uv[c])[hit])
        assert np.isnan(residual[~hit, 2 * c : 2 * c + 2]).all()
        assert np.array_equal(sources[c], np.where(hit, source[c][match[c]], -1))
    assert np.array_equal(cov[rows], S) and np.isnan(np.delete(cov, rows, axis=0)).all()
    assert np.array_equal(visible, prior.max(axis=0)) and stereo == 3


def test_a_segment_is_sensed_by_any_of_its_imus_or_markers() -> None:
    rng = np.random.default_rng(15)
    felt, seen = rng.uniform(0.0, 1.0, 4), rng.uniform(0.0, 1.0, 9)
    felt[1] = seen[2] = -np.inf
    imu_segment, marker_segment = np.array([0, 2, 3, 5]), rng.integers(0, 7, 9)
    got = sensed_lately(felt, imu_segment, seen, marker_segment, 7, 1.0, 0.5)
    expected = np.zeros(7, np.int64)
    expected[imu_segment[1.0 - felt < 0.5]] = 1
    expected[marker_segment[1.0 - seen < 0.5]] = 1
    assert np.array_equal(got, expected) and 0 < got.sum() < 7
