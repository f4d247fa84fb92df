"""A drawn hand whose ring and little finger only the glove's cloth shows."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tests.cloth_masks import cloth_of, looked_at
from tests.cloth_texture import Capsule, textured
from tracker.fusion.chain.cloth_fingers import APART, ClothFingers
from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.kinematics import segment_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, SynergyParams
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.state import ChainState, initial_state
from tracker.fusion.output.output import Sensed
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, Blobs, CameraPose, Estimate, Tracking
from tracker.vision.rig import StereoRig, default_pose, ideal_rig

CAMERA = CameraPose(default_pose().R_GC, np.array([-0.11, 0.0, 0.37]))
IMAGES = 4
TIPS = "ring_tip", "little_tip"


def outline(hand: HandModel, rig: StereoRig, R: Array, p: Array, right: bool) -> NDArray[np.bool_]:
    """Of a hand whose segments have R_GB (S, 3, 3) and p_GB (S, 3) m."""
    x, y = looked_at(rig.left.height, rig.left.width)
    mask, pose = np.zeros(x.shape, bool), rig.pose
    for k, s in enumerate(hand.segments):
        half, is_tip = max(s.width / 2 - s.radius, 0.0), s.name.endswith("distal")
        length = s.length - (s.radius if is_tip else 0.0)
        for side in np.linspace(-half, half, 5 if half else 1):
            ends = p[k] + np.array([[0, side, 0], [length, side, 0]]) @ R[k].T
            p_C = (ends - pose.p_GC) @ pose.R_GC
            (u, v), b = rig.project(p_C, right)
            du, dv = b - (u, v)
            t = np.clip(((x - u) * du + (y - v) * dv) / (du**2 + dv**2), 0, 1)
            r = s.radius * rig.fx / p_C[:, 2].mean()
            mask |= np.hypot(x - u - t * du, y - v - t * dv) <= r
    return mask


class Scene:
    """A flat hand whose ring and little finger are bent by ``bent`` degrees (MCP, PIP joint)."""

    def __init__(self, hand: HandModel, glove: GloveModel, bent: dict[str, tuple[float, float]]):
        self.layout = ChainLayout(hand, glove)
        self.rig: StereoRig = ideal_rig(pose=CAMERA)
        self.state: ChainState = initial_state(self.layout)
        self.state.P = 1e-6 * np.eye(len(self.state.P))
        distal = DistalSegments(self.layout, SynergyParams())
        self.shown = ShownHand(self.layout, ChainParams().noise, distal)
        self.shown.confidence.saved.tip_sd = self.shown.confidence.ends(self.state)
        self.fingers = ClothFingers(self.layout, self.rig, self.shown)
        angles = self._complete()[3].copy()
        for finger, (mcp, pip) in bent.items():
            for joint, degrees in (("mcp", mcp), ("pip", pip), ("dip", 0.67 * pip)):
                angles[hand.angle_index[f"{finger}_{joint}_flexion"]] = np.deg2rad(degrees)
        R, p = self._complete()[:2]
        self.R, self.p = hand.forward(angles, R[hand.root], p[hand.root])

    def _complete(self) -> tuple[Array, ...]:
        p_GB = segment_positions(self.state, self.layout)
        return self.shown.complete(self.state.R_GB, p_GB, self.state.scale3())

    def tip(self, name: str) -> Array:
        hand = self.layout.hand
        s = hand.index[name.replace("tip", "distal")]
        return self.p[s] + self.R[s][:, 0] * hand.segments[s].length

    def image(self, right: bool, radius: float, beside: Sequence[Capsule] = ()) -> Blobs:
        """The outline of the whole hand, of a disc of cloth of this radius, m, between the tips of
        the ring and the little finger, and of capsules ``beside`` them."""
        mask = outline(self.layout.hand, self.rig, self.R, self.p, right)
        middle = (np.mean([self.tip(n) for n in TIPS], axis=0) - CAMERA.p_GC) @ CAMERA.R_GC
        x, y = looked_at(self.rig.left.height, self.rig.left.width)
        u, v = self.rig.project(middle[None], right)[0]
        mask |= np.hypot(x - u, y - v) * middle[2] / self.rig.fx < radius
        for start, end, r in beside:
            p_C = (np.stack([start, end]) - CAMERA.p_GC) @ CAMERA.R_GC
            (u, v), b = self.rig.project(p_C, right)
            du, dv = b - (u, v)
            t = np.clip(((x - u) * du + (y - v) * dv) / (du**2 + dv**2 + 1e-9), 0.0, 1.0)
            away = np.hypot(x - u - t * du, y - v - t * dv)
            mask |= away <= r * self.rig.fx / p_C[:, 2].mean()
        none = Blobs.empty()
        return Blobs(none.uv, none.size, none.hue, none.score, cloth_of(mask))

    def look(self, radius: float = 0.0, beside: Sequence[Capsule] = ()) -> Estimate:
        return self._look(*(self.image(side, radius, beside) for side in (False, True)))

    def look_at_texture(self, beside: Sequence[Capsule] = ()) -> Estimate:
        """As `look`, with a texture on the cloth and on what is ``beside`` the hand."""
        none, seen = Blobs.empty(), [*self.capsules(np.zeros(3)), *beside]
        left, right = (
            replace(none, cloth=textured(seen, self.rig, CAMERA, side)) for side in (False, True)
        )
        return self._look(left, right)

    def _look(self, left: Blobs, right: Blobs) -> Estimate:
        for _ in range(IMAGES):
            self.state.t += 1.1 * APART
            self.fingers.image(
                self.state, BlobFrame(self.state.t, self.state.t, (), left, right), CAMERA
            )
        return self.estimate()

    def capsules(self, offset: Array) -> list[Capsule]:
        """The segments of the hand, displaced by ``offset`` (3,) m in G: another one, or a shadow
        on a surface; without displacement, its own."""
        found = []
        for k, s in enumerate(self.layout.hand.segments):
            half = max(s.width / 2 - s.radius, 0.0)
            for side in np.linspace(-half, half, 5 if half else 1):
                a = self.p[k] + self.R[k] @ np.array([0.0, side, 0.0]) + offset
                length = s.length - (s.radius if s.name.endswith("distal") else 0.0)
                found.append((a, a + self.R[k][:, 0] * length, s.radius))
        return found

    def estimate(self) -> Estimate:
        sensed = Sensed(np.ones(len(self.layout.active), np.int64), Tracking.TRACKING)
        confidence = self.shown.confidence
        confidence.sensed = lambda t, tracking: sensed  # type: ignore[method-assign]
        return self.shown.estimate(self.state, self.state.t, Tracking.TRACKING, self.state)

    def point(self, estimate: Estimate, name: str) -> tuple[float, float, int]:
        """Error and sd (m) and state of a fingertip."""
        k = self.layout.glove.keypoint_names(self.layout.hand).index(name)
        off = float(np.linalg.norm(estimate.keypoints[k] - self.tip(name)))
        return off, float(estimate.keypoint_sd[k]), int(estimate.keypoint_state[k])
