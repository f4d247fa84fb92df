"""Tracks a session with and without the glove's cloth, and with the true silhouette of the hand
instead, and compares the fingertips with the truth."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple, Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.recognition import SeenImage
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.messages import (
    Array,
    BlobFrame,
    CameraImuSample,
    CameraPose,
    Cloth,
    Estimate,
    ImuSample,
    Validity,
)
from tracker.offline import by_side
from tracker.offline.options import TrackOptions
from tracker.offline.track import recorded_messages, track
from tracker.session.reader import SessionReader
from tracker.vision.cloth import SIDE, STEP, TILE
from tracker.vision.rig import NEAREST, Camera, StereoRig

DIGITS = ("thumb", *FINGERS)
SEGMENTS = 3  # of a digit; `capsules` begins with those of `DIGITS`
COARSE = 2.0  # px between two samples


class Seen(NamedTuple):
    """For f stereo pairs at the times t (f,) s: the share (f, 5) of each of `DIGITS` that is
    visible in the image that shows more of it."""

    t: Array
    share: Array

    def at(self, t: float, digit: str) -> float:
        """The share of a digit in the pair closest to ``t``, NaN without one."""
        if not len(self.t):
            return np.nan
        return float(self.share[int(np.argmin(np.abs(self.t - t))), DIGITS.index(digit)])


def shares_seen(
    keypoints: Array, names: Sequence[str], hand: HandModel, rig: StereoRig, pose: CameraPose
) -> Array:
    """(5,) share of each of `DIGITS` of a hand with true ``keypoints`` (K, 3) m in G that is in the
    image and not behind another part of the hand, in the image that shows more of it.

    Other objects are not known.
    """
    ends, radius = capsules(keypoints, names, hand)
    in_C = (ends - pose.p_GC) @ pose.R_GC
    return np.max([_shares(in_C, radius, rig, right) for right in (False, True)], axis=0)


def _shares(ends: Array, radius: Array, rig: StereoRig, right: bool) -> Array:
    """In one image, of capsules with ends (k, 2, 3) m in C and radii (k,) m."""
    camera: Camera = rig.right if right else rig.left
    rows, columns = (int(n / COARSE) for n in (camera.height, camera.width))
    depth, nearest = np.full((rows, columns), np.inf), np.full((rows, columns), -1)
    alone = np.zeros((len(DIGITS), rows, columns), bool)
    beyond = np.zeros(len(DIGITS))
    for k, (capsule, r) in enumerate(zip(ends, radius, strict=True)):
        digit, z = k // SEGMENTS, capsule[:, 2]
        if z.min() <= 3 * NEAREST:
            continue
        (a, b), size = rig.project(capsule, right=right) / COARSE, r * rig.fx / z.mean() / COARSE
        low = np.floor(np.minimum(a, b) - size).astype(int)
        high = np.ceil(np.maximum(a, b) + size).astype(int) + 1
        y, x = np.mgrid[low[1] : high[1], low[0] : high[0]]
        (du, dv), u, v = b - a, x - a[0], y - a[1]
        t = np.clip((u * du + v * dv) / (du**2 + dv**2 + 1e-9), 0.0, 1.0)
        away = np.hypot(u - t * du, v - t * dv) / size
        covered, inside = away <= 1.0, (x >= 0) & (y >= 0) & (x < columns) & (y < rows)
        if digit < len(DIGITS):
            beyond[digit] += (covered & ~inside).sum()
        at = covered & inside
        front = z[0] + t[at] * (z[1] - z[0]) - r * np.sqrt(1.0 - away[at] ** 2)
        y, x = y[at], x[at]
        if digit < len(DIGITS):
            alone[digit, y, x] = True
        first = front < depth[y, x]
        depth[y[first], x[first]], nearest[y[first], x[first]] = front[first], digit
    seen = np.array([(nearest == d).sum() for d in range(len(DIGITS))])
    return np.asarray(seen / np.maximum(alone.sum(axis=(1, 2)) + beyond, 1.0))


TIPS = tuple(f"{digit}_tip" for digit in ("thumb", *FINGERS))
SETTLED = 2.0
"""s from the start of the session that are not compared."""


class TipErrors(NamedTuple):
    """For one fingertip at n instants at which it has a position: error (n,) m, standard deviation
    (n,) m per axis, whether it is reported as measured (n,), and the visible share (n,) of its
    digit, NaN where unknown."""

    error: Array
    sd: Array
    measured: NDArray[np.bool_]
    visible: Array


def tips_of(
    session: Path, colours: str, with_cloth: bool, seen: Seen, progress: Callable[[float], None]
) -> dict[str, TipErrors]:
    """Errors of each fingertip of a session that is tracked with this version's settings; ``seen``
    is of its images.

    Raises ConfigError for a session without a true hand, and FileError if it cannot be tracked.
    """
    with SessionReader(session) as reader:
        names, start = reader.info.keypoint_names, reader.anchor.monotonic(reader.span_ns[0])
        truth = {_instant(e): e for e in reader.truth(start + SETTLED)}
    if not truth:
        raise ConfigError(notice("evaluation.no_truth", file=session.name))
    with tempfile.TemporaryDirectory() as folder:
        settings, out = Path(folder) / "settings.toml", Path(folder) / "tracked.mcap"
        settings.write_text(f"[chain.cloth]\nfingers = {str(with_cloth).lower()}\n")
        options = TrackOptions(settings=str(settings), colours=colours)
        track(session, out, options, progress)
        with SessionReader(out) as reader:
            estimates = [e for e in reader.messages((Estimate,)) if isinstance(e, Estimate)]
    pairs = [(e, truth[_instant(e)]) for e in estimates if _instant(e) in truth]
    return errors_of(pairs, names, seen)


class Bound(NamedTuple):
    """Errors of each fingertip with true silhouettes; and, of the same run, the processor time (n,)
    s of the thread that the evaluation of the cloth takes in each of n stereo pairs; and what its
    images show of the digits."""

    tips: dict[str, TipErrors]
    cost: Array
    seen: Seen


def bound_of(session: Path, colours: str, progress: Callable[[float], None]) -> Bound:
    """Tracks a session with the true silhouettes of its (first) hand, in all images, instead of the
    cloth of the images.

    Raises ConfigError for a session without a true hand, and FileError if it cannot be tracked.
    """
    texts = by_side.replacements(TrackOptions(colours=colours), False)
    with SessionReader(session, {name: r.text for name, r in texts.items()}) as reader:
        info, rig, names = reader.info, reader.rig(), reader.info.keypoint_names
        true = list(reader.truth())
        settled = reader.anchor.monotonic(reader.span_ns[0]) + SETTLED
        if not true or rig is None:
            raise ConfigError(notice("evaluation.no_truth", file=session.name))
        times, known = np.array([e.t for e in true]), {_instant(e): e for e in true}
        run, compared = Pipeline(info.hand, info.glove, rig), []
        cost, shares = _timed(run), []
        for message in recorded_messages(reader):
            if isinstance(message, BlobFrame):
                k = int(np.argmin(np.abs(times - message.t)))
                hand = capsules(true[k].keypoints, names, info.hand)
                pose = message.pose or rig.pose
                shares.append(
                    (message.t, shares_seen(true[k].keypoints, names, info.hand, rig, pose))
                )
                shown = with_silhouettes(message, hand, rig, pose)
                run.feed_frame(shown)
                run.take_results()
                progress(min(k / len(true), 1.0))
            elif isinstance(message, CameraImuSample):
                run.feed_camera_imu(message)
            elif isinstance(message, ImuSample):
                estimate = run.feed_imu(message)
                if estimate.t >= settled and _instant(estimate) in known:
                    compared.append((estimate, known[_instant(estimate)]))
    seen = Seen(np.array([t for t, _ in shares]), np.array([share for _, share in shares]))
    return Bound(errors_of(compared, names, seen), np.array(cost), seen)


@runtime_checkable
class _MeasuresCloth(Protocol):
    """The part of an engine that measures fingers by the outline of the glove."""

    def measure_cloth(self, image: SeenImage) -> None: ...


def _timed(run: Pipeline) -> list[float]:
    """The processor times (s) of the evaluations of the cloth, as they are made."""
    times: list[float] = []
    part = getattr(run.engine, "tracker", None)
    if not isinstance(part, _MeasuresCloth):
        return times
    measure = part.measure_cloth

    def timed(image: SeenImage) -> None:
        started = time.thread_time()
        measure(image)
        times.append(time.thread_time() - started)

    part.measure_cloth = timed  # type: ignore[method-assign]
    return times


def errors_of(
    pairs: Sequence[tuple[Estimate, Estimate]], names: Sequence[str], seen: Seen
) -> dict[str, TipErrors]:
    """Errors of the fingertips among the keypoints ``names``, for pairs of estimate and truth, of a
    session whose images show what was ``seen``."""
    out = {}
    for tip in TIPS:
        if tip not in names or not pairs:
            continue
        k = list(names).index(tip)
        error = [np.linalg.norm(e.keypoints[k] - true.keypoints[k]) for e, true in pairs]
        sd = np.array([e.keypoint_sd[k] for e, _ in pairs])
        measured = np.array([e.keypoint_state[k] == Validity.MEASURED for e, _ in pairs])
        visible = np.array([seen.at(e.t, tip.removesuffix("_tip")) for e, _ in pairs])
        known = np.isfinite(error)
        out[tip] = TipErrors(np.array(error)[known], sd[known], measured[known], visible[known])
    return out


def _instant(estimate: Estimate) -> int:
    return round(estimate.t * 1e6)


# ---- the true silhouette of a simulated hand as a map of its glove's cloth, the bound of what
# images can show of fingers

THUMB_JOINTS, FINGER_JOINTS = ("cmc", "mcp", "ip", "tip"), ("mcp", "pip", "dip", "tip")
CLOTH = 0.001  # m, of the glove on the skin
AT_WRIST = 0.35  # distance of metacarpals at the wrist, relative to that of their knuckles
PALM_RADIUS = 0.0135  # m
FROM_WRIST = 0.15  # share of a metacarpal's length at which its capsule starts


def capsules(keypoints: Array, names: Sequence[str], hand: HandModel) -> tuple[Array, Array]:
    """Ends (k, 2, 3) m in G and radii (k,) m of a hand with true ``keypoints`` (K, 3) m in G; the
    radii of digits are those of the hand file."""
    at = dict(zip(names, keypoints, strict=False))
    rows: list[tuple[Array, Array, float]] = []
    for digit, joints in (("thumb", THUMB_JOINTS), *((f, FINGER_JOINTS) for f in FINGERS)):
        for k, segment in enumerate(CHAINS[digit]):
            a, b = (at[f"{digit}_{joint}"] for joint in joints[k : k + 2])
            radius = hand.segments[hand.index[segment]].radius + CLOTH
            if joints[k + 1] == "tip":
                b = b - (b - a) * min(radius / np.linalg.norm(b - a), 1.0)
            rows.append((a, b, radius))
    wrist, knuckles = at["wrist"], np.array([at[f"{f}_mcp"] for f in FINGERS])
    middle = knuckles.mean(axis=0)
    across = knuckles[-1] - knuckles[0]
    width = np.linalg.norm(across)
    # The outer ones are as far inwards as they are thicker than the fingers.
    thicker = PALM_RADIUS - hand.segments[hand.index[CHAINS[FINGERS[-1]][0]]].radius
    for share in np.linspace(0.0, len(FINGERS) - 1.0, 2 * len(FINGERS) - 1):
        k = min(int(share), len(FINGERS) - 2)
        knuckle = knuckles[k] + (share - k) * (knuckles[k + 1] - knuckles[k])
        inwards = 1.0 - 2.0 * share / (len(FINGERS) - 1.0)
        knuckle = knuckle + inwards * thicker / width * across
        start = wrist + AT_WRIST * (knuckle - middle)
        rows.append((start + FROM_WRIST * (knuckle - start), knuckle, PALM_RADIUS))
    rows.append((at["thumb_cmc"], knuckles[0] + thicker / width * across, PALM_RADIUS))
    first, last, radii = zip(*rows, strict=True)
    return np.stack([np.array(first), np.array(last)], axis=1), np.array(radii)


def silhouette(ends: Array, radius: Array, rig: StereoRig, right: bool) -> NDArray[np.bool_]:
    """Which samples of a cloth map (rows, columns) the capsules with ends (k, 2, 3) m in C and
    radii (k,) m cover. Their axes are straight in the image as recorded."""
    camera: Camera = rig.right if right else rig.left
    rows, columns = (n // TILE * SIDE for n in (rig.left.height, rig.left.width))
    mask = np.zeros((rows, columns), bool)
    for capsule, r in zip(ends, radius, strict=True):
        z = capsule[:, 2]
        if z.min() <= 3 * NEAREST:
            continue
        (a, b), size = camera.unrectify(rig.project(capsule, right=right)), r * rig.fx / z.mean()
        low, high = np.minimum(a, b) - size, np.maximum(a, b) + size
        x0, y0 = np.clip(np.floor(low / STEP).astype(int), 0, (columns, rows))
        x1, y1 = np.clip(np.ceil(high / STEP).astype(int) + 1, 0, (columns, rows))
        y, x = STEP * np.mgrid[y0:y1, x0:x1]
        (du, dv), d = b - a, np.stack([x - a[0], y - a[1]])
        t = np.clip((d[0] * du + d[1] * dv) / (du**2 + dv**2 + 1e-9), 0.0, 1.0)
        mask[y0:y1, x0:x1] |= np.hypot(d[0] - t * du, d[1] - t * dv) <= size
    return mask


def as_cloth(mask: NDArray[np.bool_]) -> Cloth:
    """A map of all tiles, of samples (rows, columns)."""
    rows, columns = (n // SIDE for n in mask.shape)
    tiles = mask.reshape(rows, SIDE, columns, SIDE).transpose(0, 2, 1, 3).reshape(-1, SIDE**2)
    bits = (tiles * np.left_shift(np.int64(1), np.arange(SIDE**2))).sum(axis=1)
    return Cloth(columns, rows, np.arange(rows * columns), bits)


def with_silhouettes(
    frame: BlobFrame, hand: tuple[Array, Array], rig: StereoRig, pose: CameraPose
) -> BlobFrame:
    """The frame with the silhouette of a true ``hand`` (`capsules`) as its cloth."""
    ends, radius = (hand[0] - pose.p_GC) @ pose.R_GC, hand[1]
    left, right = (
        blobs and replace(blobs, cloth=as_cloth(silhouette(ends, radius, rig, bool(c))))
        for c, blobs in enumerate((frame.left, frame.right))
    )
    return replace(frame, left=left, right=right)
