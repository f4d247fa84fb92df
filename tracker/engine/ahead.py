"""Where the hand and its markers are expected in an image that has not arrived yet."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.engine import Engine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame
from tracker.online.frame_timing import FrameTiming
from tracker.online.hue_names import HueNames
from tracker.online.pair_offset import PairOffset
from tracker.vision.colours import hue_rows
from tracker.vision.region_prediction import RegionPrediction
from tracker.vision.sharing import HandInView
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, turned


class GloveOnHand(NamedTuple):
    """A glove on a hand, and how its hues are called in the colours."""

    hand: HandModel
    glove: GloveModel
    hues: HueNames


class Ahead:
    """What an engine expects, at the exposure times that the cameras will report."""

    def __init__(
        self,
        glove_on_hand: GloveOnHand,
        engine: Engine,
        timing: FrameTiming,
        pair_offset: PairOffset,
    ) -> None:
        self._glove, self._engine, self._hues = glove_on_hand.glove, engine, glove_on_hand.hues
        self._timing, self._pair = timing, pair_offset
        self._marker_segment = self._glove.marker_segment(glove_on_hand.hand)
        self._shape = HandShape.of(glove_on_hand.hand)

    def markers(self, t: float, before: RegionPrediction | None = None) -> RegionPrediction | None:
        """Returns where markers are expected at ``t``, not before the newest packet; None while
        searching. Their velocity follows from where they were expected ``before``.
        """
        markers = self._engine.predicted_markers(t)
        if markers is None:
            return None
        p_G, sd, ids = markers
        return RegionPrediction(
            t=t + self._timing.applied,
            p_G=p_G,
            v_G=np.zeros_like(p_G),
            sd=sd,
            size=self._glove.marker_size[ids],
            hue=self._glove.marker_hue[ids],
            hue_names=self._hues.as_found,
            right_late=self._pair.applied,
        ).after(before)

    def synchronised(self, frame: BlobFrame) -> BlobFrame:
        """Returns the frame as if both cameras had exposed at the left one's instant."""
        late, t = self._pair.applied, frame.t - self._timing.applied
        if late == 0.0:
            return frame
        then, after = (self._engine.expected(at) for at in (t, t + late))
        if then is None or after is None:
            return frame
        return self._pair.moved_back(frame, then.p_G, after.p_G)

    def in_view(self, frame: BlobFrame) -> HandInView | None:
        """Returns the hand that is expected in an image that was not fed yet, its hues numbered as
        the image's; None while its position is unknown."""
        found = self._engine.expected(frame.t - self._timing.applied)
        if found is None:
            return None
        estimate, glove, ids = found.estimate, self._glove, found.ids
        segment = self._marker_segment[ids]
        normal_G = turned(estimate.segment_R, segment, glove.marker_normal[ids])
        return HandInView(
            MarkerRows(found.p_G, normal_G, segment),
            hue_rows(self._hues.as_found, frame.hue_names)[glove.marker_hue[ids]],
            found.sd,
            PosedHand(self._shape, estimate.segment_R, estimate.segment_p),
            ids,
            len(glove.markers),
        )
