"""Fingers without sensors, measured by the glove's cloth (docs/chain.md, "Fingers in the cloth").

In addition to the filter, which does not depend on them. What is known of such a finger is a grid
of probabilities (`finger_grid`); each image multiplies it by how well the finger explains the cloth
that the sensed parts of the hand leave unexplained (`tracker.vision.finger_cloth`).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.records import record
from tracker.fusion.chain.finger_grid import (
    GRID,
    INDEPENDENT,
    FingerFit,
    aged,
    fit,
    prior,
    summary,
    variance_about,
)
from tracker.fusion.chain.finger_view import (
    ClothViews,
    KnownParts,
    cloth_views,
    finger_images,
    is_other_thing,
    rim_part,
)
from tracker.fusion.chain.kinematics import segment_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.state import ChainState
from tracker.fusion.output.anatomy import NEIGHBOURS, UNLOADED
from tracker.fusion.output.measured_fingers import JOINTS, FingerRows, MeasuredFingers
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.messages import Array, BlobFrame, CameraPose
from tracker.vision.finger_cloth import ASIDE, BEND, FLEXION, Finger, FingerImages
from tracker.vision.rig import StereoRig

AHEAD = 0.02  # m from the knuckles along the palm, of the centre of a window
APART = 0.09  # s between two evaluated images of a finger
SPARSE = 0.05  # s between images from which all fingers are evaluated in the same image
TOGETHER = 0.08  # s between images from which that image is also evaluated for fingertips
INDEPENDENT_AFTER = 0.05  # s after which outlines are independent of each other
LASTS = 0.3  # s after the last evaluated image for which fingers are shown as measured
BODY_SD = 0.007  # m per axis, of what the grid does not contain: lengths, the hand's own pose
HIDDEN_SD = 0.022  # m per axis, added where the cloth does not show the finger
LEAST_RIM = 6.0  # the evidence is at most this many times what the outline contributes
HIDDEN_BELOW, SEEN_FROM = 8.0, 12.0  # ln of the likelihood ratio of the finger to none
SURROUNDED = -15.0  # of the evidence; below, what is around the finger has its colours too
EXCHANGED = 1.0  # s, in each of which a hidden finger is tried once in place of a visible one
BETTER = 2.0  # ln of the likelihood ratio from which it is that one
REFUTED = -0.9  # ln of the likelihood ratio of following the neighbour to not following it


@record(
    "chain.cloth_fingers",
    shapes={
        "posterior": f"d {len(GRID)}",
        "posture": "d 5",
        "best": "d 5",
        "angle_sd": "d 3",
        "joint_variance": "d 4",
        "evidence": "d",
        "follows": "d",
        "origin": "d 3",
        "fitted_at": "e",
    },
)
@dataclass(eq=False)
class ClothFingersSavedState:
    """For d fingers: the posterior (d, G) of the cells of the grid; the displayed posture (d, 5),
    the most probable one (d, 5), and the sd (d, 3) rad of flexion, abduction and bend; the variance
    (d, 4) m² per axis of its joints and its tip; the evidence and follows (d,), ln of likelihood
    ratios (`FingerFit`); the origin (d, 3) of the first segment in its parent's nominal B, m; the
    time of the last evaluated image, s, and whether it is shown; the time of the last evaluated
    image of each finger, (d,) s, and that of the last image."""

    posterior: Array = field(default_factory=lambda: np.zeros((0, len(GRID))))
    posture: Array = field(default_factory=lambda: np.zeros((0, 5)))
    best: Array = field(default_factory=lambda: np.zeros((0, 5)))
    angle_sd: Array = field(default_factory=lambda: np.zeros((0, 3)))
    joint_variance: Array = field(default_factory=lambda: np.zeros((0, 4)))
    evidence: Array = field(default_factory=lambda: np.zeros(0))
    follows: Array = field(default_factory=lambda: np.zeros(0))
    origin: Array = field(default_factory=lambda: np.zeros((0, 3)))
    t: float = -np.inf
    is_shown: bool = False
    fitted_at: Array = field(default_factory=lambda: np.zeros(0))
    image_t: float = -np.inf

    @property
    def is_fitted(self) -> NDArray[np.bool_]:
        """(d,) whether a finger is displayed as fitted: the cloth shows it, or not where its
        neighbour suggests. Others follow their neighbours as far as the images allow."""
        refuted = (self.follows < REFUTED) & (self.evidence > SURROUNDED)
        return np.asarray((self.evidence >= HIDDEN_BELOW) | refuted)


PER_FINGER = (
    "posterior", "posture", "best", "angle_sd", "joint_variance", "evidence", "follows", "origin",
    "fitted_at",
)  # fmt: skip
"""Arrays of the state."""

_Digit = tuple[int, int, int]  # segments of a finger without sensors


class _Hand(NamedTuple):
    """The displayed hand: R_GB (S, 3, 3), p_GB (S, 3) m, scale (S, 3); and the segments it was
    completed from, as for `Completion`."""

    R: Array
    p: Array
    scale: Array
    active: tuple[Array, Array, Array]


class ClothFingers:
    """For one hand with one glove; ``shown`` displays the result."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, shown: ShownHand) -> None:
        self._layout, self._rig, self._shown = layout, rig, shown
        self.digits = _digits(layout)
        segments = [s for d in self.digits for s in d]
        self._known = KnownParts.of(layout.hand, segments, [d[0] for d in self.digits])
        self._rows = [FingerRows.of(layout.hand, d) for d in self.digits]
        self.saved = ClothFingersSavedState()

    # ---- state

    def forget(self) -> None:
        """Reset, because the hand was found again."""
        if len(self.saved.posterior):
            self.restore(ClothFingersSavedState())

    def restore(self, saved: ClothFingersSavedState) -> None:
        """Continue from a saved state, which is not copied."""
        d = len(saved.posterior)
        if len(saved.fitted_at) != d:  # of an earlier version
            saved = replace(saved, fitted_at=np.full(d, saved.t))
        self.saved = saved
        self._show()

    def no_image(self, t: float) -> None:
        """Without images, fingers follow their neighbours again after a while."""
        if self.saved.is_shown and t - self.saved.t > LASTS:
            self.saved.is_shown = False
            self._show()

    def _show(self) -> None:
        now = self.saved
        if not now.is_shown:
            self._shown.show_fingers(None)
            return
        # eq. 74
        seen = np.clip((now.evidence - HIDDEN_BELOW) / (SEEN_FROM - HIDDEN_BELOW), 0.0, 1.0)
        variance, fitted = now.joint_variance + BODY_SD**2, now.is_fitted
        hidden = (fitted * (1.0 - seen))[:, None] * (np.arange(JOINTS) > 0)
        variance = variance + HIDDEN_SD**2 * hidden
        rows = tuple(self._rows)
        self._shown.show_fingers(
            MeasuredFingers(
                now.fitted_at,
                rows,
                _angles(now.posture),
                now.origin,
                variance,
                now.angle_sd,
                fitted,
                seen >= 1.0,
            )
        )

    # ---- measurement

    @property
    def wait_since(self) -> float:
        """s, of the finger that has waited longest for an image; infinite if none was fitted."""
        return float(np.min(self.saved.fitted_at, initial=np.inf))

    def is_alone(self, t: float) -> bool:
        """Whether images are so dense at ``t`` that one is evaluated either for fingers or for
        fingertips."""
        return 0.0 <= t - self.saved.image_t < TOGETHER

    def skip(self, t: float) -> None:
        """Another part of the hand is evaluated in the image at ``t``."""
        self.saved = replace(self.saved, image_t=t)

    def image(self, state: ChainState, frame: BlobFrame, pose: CameraPose) -> None:
        """Fits the fingers to the cloth around a hand that was just corrected."""
        due = self._due(state.t)
        self.skip(state.t)
        cloths = [b.cloth if b is not None else None for b in (frame.left, frame.right)]
        if not due:
            return
        if all(c is None for c in cloths):
            self.no_image(state.t)
            return
        hand = self._complete(state)
        fingers = [self._finger(d, hand, pose) for d in self.digits]
        known = self._known.capsules(hand.R, hand.p, hand.scale)
        centre = np.mean([f.base + AHEAD * f.palm[:, 0] for f in fingers], axis=0)
        views = cloth_views(self._rig, pose, cloths, known, centre)
        if not views.each:
            self.no_image(state.t)
            return
        self._fit(hand, fingers, views, due, state.t)
        self._show()

    def _due(self, t: float) -> list[int]:
        """The fingers to evaluate in an image at ``t``: one, which limits what an image costs, or
        all where images are sparse."""
        then = self.saved.fitted_at
        if not len(then):
            return list(range(len(self.digits)))
        due = [k for k, before in enumerate(then) if not 0.0 <= t - before < APART]
        if 0.0 <= t - self.saved.image_t < SPARSE:
            due.sort(key=lambda k: float(then[k]))
            return due[:1]
        return due

    def _complete(self, state: ChainState) -> _Hand:
        active = state.R_GB, segment_positions(state, self._layout), state.scale3()
        return _Hand(*self._shown.complete(*active)[:3], active)

    def _finger(self, digit: _Digit, hand: _Hand, pose: CameraPose) -> Finger:
        """The finger's geometry in C."""
        model, root, first = self._layout.hand, self._layout.hand.root, digit[0]
        segments = [model.segments[s] for s in digit]
        base = hand.p[root] + hand.R[root] @ (hand.scale[root] * segments[0].origin)
        palm = pose.R_GC.T @ hand.R[root]
        return Finger(
            pose.R_GC.T @ (base - pose.p_GC),
            np.ascontiguousarray(palm),
            np.ascontiguousarray(palm @ segments[0].R_rest),
            np.array([s.length for s in segments]) * hand.scale[first, 0],
            np.array([s.radius for s in segments]) * hand.scale[first, 1],
            UNLOADED,
        )

    def _fit(
        self, hand: _Hand, fingers: list[Finger], views: ClothViews, due: list[int], t: float
    ) -> None:
        """The fingers that are ``due``, one after the other; each explains its part of the cloth to
        the others."""
        before = self.saved
        now = self._copy(t)
        known = len(before.posterior) > 0
        for k in due:
            dt = t - before.fitted_at[k] if known and t >= before.fitted_at[k] else np.inf
            seen = [
                i
                for i in range(len(fingers))
                if i != k and (i < k or (known and dt < np.inf)) and now.evidence[i] >= HIDDEN_BELOW
            ]
            neighbour = self._neighbour(k, hand, now.posture)
            alone = prior(neighbour, INDEPENDENT)
            start = aged(before.posterior[k], alone, dt) if dt < np.inf else alone
            others = [(fingers[i], now.best[i]) for i in seen]
            images = finger_images(fingers[k], others, self._rig, views)
            share = min(dt / INDEPENDENT_AFTER, 1.0)
            found = fit(start, neighbour, images, share)
            self._adopt(now, k, hand, images, found)
            is_due = dt == np.inf or t // EXCHANGED > before.fitted_at[k] // EXCHANGED
            if is_due and seen and now.evidence[k] < HIDDEN_BELOW:
                self._exchange(now, (k, seen[-1]), hand, fingers, views)
        self.saved = now

    def _adopt(
        self, now: ClothFingersSavedState, k: int, hand: _Hand, images: FingerImages,
        found: FingerFit,
    ) -> None:  # fmt: skip
        """Puts what was found of the finger ``k`` into the state ``now``."""
        self._put(now, k, images.finger, found)
        now.evidence[k] = min(now.evidence[k], LEAST_RIM * rim_part(now.posture[k], images))
        if is_other_thing(now.posture[k], images):
            now.evidence[k] = min(now.evidence[k], HIDDEN_BELOW)
        if not now.is_fitted[k]:
            now.posture[k] = found.hidden
        if now.evidence[k] < HIDDEN_BELOW:
            spread = variance_about(now.posterior[k], images.finger, now.posture[k])
            now.joint_variance[k] = spread
        now.fitted_at[k] = now.t
        now.origin[k] = self._layout.hand.segments[self.digits[k][0]].origin
        now.origin[k, :2] += now.posture[k, :2] / hand.scale[self._layout.hand.root, :2]

    def _exchange(
        self,
        now: ClothFingersSavedState,
        pair: tuple[int, int],
        hand: _Hand,
        fingers: list[Finger],
        views: ClothViews,
    ) -> None:
        """Of two fingers, of which the first is hidden: the first is the one that is seen instead,
        if both together explain the cloth better that way, independent of earlier images."""
        found: list[tuple[float, list[tuple[FingerImages, FingerFit]]]] = []
        for one, other in (pair, pair[::-1]):
            postures, each, whole = now.posture.copy(), [], 0.0
            seen: list[tuple[Finger, Array]] = []
            for k in (one, other):
                neighbour = self._neighbour(k, hand, postures)
                images = finger_images(fingers[k], seen, self._rig, views)
                it = fit(prior(neighbour, INDEPENDENT), neighbour, images, 1.0)
                each.append((images, it))
                whole += it.whole
                best = it.postures[int(np.argmax(it.weights))]
                seen = [(fingers[k], best)]
                postures[k] = best if k == one else it.hidden
            found.append((whole, each))
        (first, each), (usual, _) = found
        if first > usual + BETTER:
            for k, (images, it) in zip(pair, each, strict=True):
                self._adopt(now, k, hand, images, it)

    def _copy(self, t: float) -> ClothFingersSavedState:
        """The state to which an image at ``t`` is added."""
        d, before = len(self.digits), self.saved
        if not len(before.posterior):
            return ClothFingersSavedState(
                np.zeros((d, len(GRID))), np.zeros((d, 5)), np.zeros((d, 5)), np.zeros((d, 3)),
                np.zeros((d, 4)), np.zeros(d), np.zeros(d), np.zeros((d, 3)), t, True,
                np.zeros(d), t,
            )  # fmt: skip
        arrays = {name: getattr(before, name).copy() for name in PER_FINGER}
        return replace(before, t=t, is_shown=True, **arrays)

    def _put(self, now: ClothFingersSavedState, k: int, finger: Finger, found: FingerFit) -> None:
        """Summarizes the fit of the finger ``k``."""
        mean, variance, sd = summary(found.postures, found.weights, finger)
        now.posterior[k], now.posture[k] = found.posterior, mean
        now.evidence[k], now.follows[k] = found.evidence, found.follows
        now.best[k] = found.postures[int(np.argmax(found.weights))]
        now.joint_variance[k], now.angle_sd[k] = variance, sd

    def _neighbour(self, k: int, hand: _Hand, postures: Array) -> Array:
        """(5,) the posture of the finger ``k`` that follows its neighbour as the hand file has it,
        where the fingers before have these ``postures``."""
        measured: dict[int, float] = {}
        for row, values in zip(self._rows[:k], _angles(postures), strict=False):
            measured.update(zip(row.columns, values.tolist(), strict=True))
        angles = self._shown.complete.angles_with(*hand.active, measured)
        posture = np.zeros(5)
        posture[[FLEXION, ASIDE, BEND]] = angles[list(self._rows[k].columns[:3])]
        return posture


def _angles(postures: Array) -> Array:
    """(d, 4) rad of the columns of `FingerRows`, of postures (d, 5)."""
    return np.asarray(postures[:, [FLEXION, ASIDE, BEND, BEND]] * (1.0, 1.0, 1.0, UNLOADED))


def _digits(layout: ChainLayout) -> tuple[_Digit, ...]:
    """Fingers of which no segment is estimated, each after the one that it follows."""
    hand = layout.hand
    out: dict[str, _Digit] = {}
    for finger, other in NEIGHBOURS:
        if finger in out or not _is_complete(hand, finger) or not _is_complete(hand, other):
            continue
        first, second, third = (hand.index[s] for s in CHAINS[finger])
        sensed = [hand.index[s] in layout.row_of for s in CHAINS[other][:2]]
        if {first, second, third} & set(layout.row_of) or not (other in out or all(sensed)):
            continue
        out[finger] = first, second, third
    return tuple(out.values())


def _is_complete(hand: HandModel, finger: str) -> bool:
    """Whether the hand has all joint axes of a finger on its palm."""
    rows = [hand.index.get(s, -1) for s in CHAINS[finger]]
    if finger not in FINGERS or min(rows) < 0 or hand.parent[rows[0]] != hand.root:
        return False
    axes = [hand.axis_columns[r] for r in rows]
    return min(axes[0][0], *(a[1] for a in axes)) >= 0
