"""Unsensed end joints, measured by outlines of fingertips that deviate from the synergy."""

from dataclasses import replace

import numpy as np
import pytest

from tests.cloth_masks import cloth_of, looked_at
from tests.fusion.guided.test_guided_rows import somehow
from tracker.fusion.chain.distal import ASIDE, OFFSET, DistalSegments, Synergies
from tracker.fusion.chain.driven_ends import driven_points
from tracker.fusion.chain.finger_view import KnownParts
from tracker.fusion.chain.kinematics import segment_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, SynergyParams
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.state import ChainState, initial_state
from tracker.fusion.chain.tip_bends import APART, LASTS, TipBends
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, Blobs, CameraPose
from tracker.vision.rig import StereoRig, ideal_rig

ABOVE = CameraPose(np.diag([1.0, -1.0, -1.0]), np.array([0.09, 0.0, 0.42]))
BENT = np.deg2rad(20.0)  # beyond the synergy


@pytest.fixture
def layout(hand: HandModel, glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, glove)


@pytest.fixture
def rig() -> StereoRig:
    return ideal_rig(pose=ABOVE)


@pytest.fixture
def flat(layout: ChainLayout) -> ChainState:
    """A hand with the thumb in side view, and its position known to a millimetre."""
    state = initial_state(layout)
    state.P = 1e-6 * np.eye(len(state.P))
    return state


class Worn:
    """A tracker's parts that tip bends work with."""

    def __init__(self, layout: ChainLayout, rig: StereoRig) -> None:
        self.distal = DistalSegments(layout, SynergyParams())
        self.own = self.distal.prior()
        self.shown = ShownHand(layout, ChainParams().noise, self.distal)
        self.tips = TipBends(layout, rig, self.distal, self.shown)

    def look(self, state: ChainState, frame: BlobFrame) -> None:
        if self.tips.image(state, frame, ABOVE, self.own):
            self.shown.wear(
                *self.tips.worn(self.distal.gains(self.own), self.distal.lateral(self.own))
            )
            self.shown.trust(*self.tips.trusted(self.own))

    def tip(self, state: ChainState, k: int) -> Array:
        """(3,) m, of the digit ``k`` as displayed."""
        rows = self.shown.confidence.ends.driven_ends, self.shown.confidence.ends.own
        return points(self, state, *rows)[0][k, 1]


def points(worn: Worn, state: ChainState, driven, own):
    lay = worn.distal._layout
    return driven_points(
        lay.skeleton, lay.R_rest, lay.blocks, state.body, driven, own, state.p, state.P
    )


def drawn(rig: StereoRig, ends: Array, radius: Array, right: bool) -> Blobs:
    """An image of capsules with ends (k, 2, 3) m in C."""
    x, y = looked_at(rig.left.height, rig.left.width)
    mask = np.zeros(x.shape, bool)
    for (a, b), r in zip(ends, rig.fx * radius / ends[..., 2].mean(axis=1), strict=True):
        uv = rig.project(np.stack([a, b]), right)
        d = uv[1] - uv[0]
        along = (x - uv[0, 0]) * d[0] + (y - uv[0, 1]) * d[1]
        t = np.clip(along / (d @ d + 1e-9), 0, 1)
        mask |= np.hypot(x - uv[0, 0] - t * d[0], y - uv[0, 1] - t * d[1]) <= r
    none = Blobs.empty()
    return Blobs(none.uv, none.size, none.hue, none.score, cloth_of(mask))


def seen(
    worn: Worn, rig: StereoRig, state: ChainState, k: int, bent: float, t: float, beside: str = ""
) -> BlobFrame:
    """What cameras see of a gloved hand whose digit ``k`` bends its end joint ``bent`` rad beyond
    its synergy; ``beside`` it is another thing of the glove's colour."""
    hand, rows = worn.distal._layout.hand, [d.segment for d in worn.distal.digits]
    first = np.flatnonzero(hand.parent == hand.root).tolist()
    unsensed = [i for i in first if i not in worn.distal._layout.row_of]
    own, wearer = Synergies(worn.own.value.copy(), worn.own.P), Worn(worn.distal._layout, rig)
    own.value[k, OFFSET] += bent
    wearer.shown.wear(worn.distal.gains(own), worn.distal.lateral(own))
    at = state.R_GB, segment_positions(state, worn.distal._layout), state.scale3()
    posed = wearer.shown.complete(*at)[:3]
    capsules = KnownParts.of(hand, rows, unsensed), KnownParts.ends_of(hand, rows)
    ends, radius = zip(*(c.capsules(*posed) for c in capsules), strict=True)
    p_C = (np.concatenate(ends) - ABOVE.p_GC) @ ABOVE.R_GC
    # The last segments end one radius before the tip; the cloth is 1 mm thick on them.
    last = p_C[-len(rows) :]
    axis = last[:, 1] - last[:, 0]
    back = radius[1] / np.linalg.norm(axis, axis=1)
    last[:, 1] -= back[:, None] * axis
    thick = np.concatenate([radius[0], radius[1] + 0.001])
    if beside:
        tip = last[k, 1]
        ends, thickness = {
            "a pen": (np.array([[tip - [0.03, 0.0, 0.0], tip + [0.1, 0.0, 0.0]]]), [0.005]),
            "a bar": (np.array([[tip - [0.0, 0.08, 0.0], tip + [0.0, 0.08, 0.0]]]), [0.013]),
            "a shadow": (p_C + [0.01, 0.015, 0.03], thick),
        }[beside]
        p_C, thick = np.concatenate([p_C, ends]), np.concatenate([thick, thickness])
    left, right = (drawn(rig, p_C, thick, side) for side in (False, True))
    return BlobFrame(t, t, (), left, right)


def test_points_and_jacobians_are_those_of_the_distal_segments(
    layout: ChainLayout, rig: StereoRig
) -> None:
    worn, state = Worn(layout, rig), somehow(layout)
    rng = np.random.default_rng(3)
    root = rng.normal(size=state.P.shape)
    state.P = root @ root.T
    own = Synergies(worn.own.value + rng.normal(0, 0.1, worn.own.value.shape), worn.own.P)
    worn.shown.trust(own, worn.distal.posture_sd)
    p, J, C, _ = points(
        worn, state, worn.shown.confidence.ends.driven_ends, worn.shown.confidence.ends.own
    )
    for k, digit in enumerate(worn.distal.digits):
        end = np.array([layout.hand.segments[digit.segment].length, 0, 0])
        plain = worn.distal.point(state, own, digit.name, end)
        assert np.allclose(p[k, 0], worn.distal.point(state, own, digit.name, np.zeros(3)).p)
        assert np.allclose(p[k, 1], plain.p)
        assert np.allclose(J[k, :, 0], plain.H_own[:, 3 * k + OFFSET])
        assert np.allclose(J[k, :, 1], plain.H_own[:, 3 * k + ASIDE])
        # The Jacobian of the bend is made of differences: 1e-5 rad apart, to some 1e-7.
        assert np.allclose(C[k], plain.H @ state.P @ plain.H.T, rtol=1e-5, atol=1e-8)


def test_a_thumb_bends_as_its_outline_does(
    layout: ChainLayout, rig: StereoRig, flat: ChainState
) -> None:
    worn = Worn(layout, rig)
    before, sure = worn.tip(flat, 0), worn.shown.confidence.ends(flat)[len(layout.active)]
    own = Synergies(worn.own.value.copy(), worn.own.P)
    own.value[0, OFFSET] += BENT
    end = np.array([layout.hand.segments[worn.distal.digits[0].segment].length, 0, 0])
    true = worn.distal.point(flat, own, "thumb", end).p
    for k in range(6):
        flat.t = 1.1 * APART * k
        worn.look(flat, seen(worn, rig, flat, 0, BENT, flat.t))
    without, off = np.linalg.norm(before - true), np.linalg.norm(worn.tip(flat, 0) - true)
    assert without > 0.009  # 20° of 29 mm
    # Six images in half a second are worth one, as informative as the prior of the thumb.
    assert off < 0.5 * without
    assert worn.shown.confidence.ends(flat)[len(layout.active)] < 0.75 * sure


def test_what_was_seen_fades(layout: ChainLayout, rig: StereoRig, flat: ChainState) -> None:
    """Where a tip is seen no more, its joint follows the one before it again after a while."""
    worn, nothing = Worn(layout, rig), BlobFrame(0.0, 0.0, (), Blobs.empty(), Blobs.empty())
    worn.look(flat, seen(worn, rig, flat, 0, BENT, 0.0))
    bend, P = worn.tips.saved.bend.copy(), worn.tips.saved.P.copy()
    flat.t = APART / 2
    worn.look(flat, nothing)
    assert np.array_equal(worn.tips.saved.bend, bend)  # too soon to check again
    flat.t = LASTS
    worn.look(flat, nothing)
    assert np.allclose(worn.tips.saved.bend, np.exp(-1.0) * bend)
    assert worn.tips.saved.P[0, 0, 0] > P[0, 0, 0]


@pytest.mark.long
def test_a_wearer_who_deviates_is_less_certain_where_the_tip_is_hidden(
    layout: ChainLayout, rig: StereoRig, flat: ChainState
) -> None:
    """An end joint that was seen to deviate more than those of most people may do so again."""
    sure, usual = {}, Worn(layout, rig).distal.posture_sd[0]
    for bent in (0.0, 3.5 * usual):
        worn = Worn(layout, rig)
        for k in range(40):
            flat.t = 1.1 * APART * k
            worn.look(flat, seen(worn, rig, flat, 0, bent, flat.t))
        nothing = BlobFrame(0.0, 0.0, (), Blobs.empty(), Blobs.empty())
        for _ in range(8):
            flat.t += LASTS
            worn.look(flat, nothing)
        sure[bent] = worn.shown.confidence.ends.own.posture[0]
    still, far = sure.values()
    assert usual < still < 1.3 * usual  # by what the filter does not know of the joint
    assert far > 1.2 * still
    assert far < 3.5 * usual


def test_the_uncertainty_of_older_recordings_starts_with_that_of_people(
    layout: ChainLayout, rig: StereoRig, flat: ChainState
) -> None:
    worn, other = Worn(layout, rig), Worn(layout, rig)
    image = seen(worn, rig, flat, 0, BENT, 0.0)
    for one in (worn, other):
        one.look(flat, image)
    other.tips.saved = replace(worn.tips.saved, measured=np.zeros(0), squares=np.zeros(0))
    flat.t = 1.1 * APART
    for one in (worn, other):
        one.look(flat, image)
    assert np.array_equal(other.tips.saved.P, worn.tips.saved.P)
    assert 0.0 < other.tips.saved.measured[0] < worn.tips.saved.measured[0]


@pytest.mark.long
@pytest.mark.parametrize("beside", ["a pen", "a bar", "a shadow"])
@pytest.mark.parametrize("k", [0, 1])
def test_nothing_false_is_claimed_beside_other_things_of_the_gloves_colour(
    layout: ChainLayout, rig: StereoRig, flat: ChainState, k: int, beside: str
) -> None:
    """Of the thumb in side view, and of the index finger that points away from the camera."""
    worn = Worn(layout, rig)
    own = Synergies(worn.own.value.copy(), worn.own.P)
    own.value[k, OFFSET] += BENT
    digit = worn.distal.digits[k]
    end = np.array([layout.hand.segments[digit.segment].length, 0, 0])
    true = worn.distal.point(flat, own, digit.name, end).p
    image = seen(worn, rig, flat, k, BENT, 0.0, beside)
    for n in range(6):
        flat.t = 1.1 * APART * n
        worn.look(flat, image)
    sd = worn.shown.confidence.ends(flat)[len(layout.active) + k]
    assert np.linalg.norm(worn.tip(flat, k) - true) < 3.0 * sd


def test_cloth_that_is_everywhere_changes_nothing(
    layout: ChainLayout, rig: StereoRig, flat: ChainState
) -> None:
    """On a table, or in front of a shirt, of the glove's colours no outline is found."""
    worn, none = Worn(layout, rig), Blobs.empty()
    everywhere = cloth_of(np.ones((rig.left.height, rig.left.width), bool))
    image = Blobs(none.uv, none.size, none.hue, none.score, everywhere)
    sure = worn.shown.confidence.ends(flat)
    worn.look(flat, BlobFrame(0.0, 0.0, (), image, image))
    assert not worn.tips.saved.bend.any()
    assert np.allclose(worn.shown.confidence.ends(flat), sure)


def test_images_without_cloth_change_nothing(
    layout: ChainLayout, rig: StereoRig, flat: ChainState
) -> None:
    worn = Worn(layout, rig)
    gains, lateral = worn.distal.gains(worn.own), worn.distal.lateral(worn.own)
    assert not worn.tips.image(flat, BlobFrame(0.0, 0.0, (), Blobs.empty(), None), ABOVE, worn.own)
    assert worn.tips.worn(gains, lateral) == (gains, lateral)
    assert worn.tips.trusted(worn.own)[0] is worn.own


def test_a_tip_behind_the_hand_is_not_looked_for(
    layout: ChainLayout, rig: StereoRig, flat: ChainState
) -> None:
    """Seen from above the palm hides what is under it."""
    worn = Worn(layout, rig)
    under = np.tile([0.04, 0.0, -0.06], (len(worn.distal.digits), 1))
    assert not worn.tips.in_sight(flat, under, ABOVE).any()
    assert worn.tips.in_sight(flat, under + [0.0, 0.12, 0.06], ABOVE).all()
