"""Colours of a session tracked again: fitted if they show no hand, and reported."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from tracker.base.clock import ClockAnchor
from tracker.base.errors import GlovetrackError
from tracker.glove import library
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Blobs, StereoFrame, Tracking
from tracker.offline import detection, own_colours
from tracker.offline.detection import AHEAD
from tracker.offline.options import TrackOptions
from tracker.offline.own_colours import APART, ATTEMPTS, IMAGES, OwnColours
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.description import SessionInfo
from tracker.session.images import PackedFrame, encode_image
from tracker.session.ros.sensors import ImageMessage
from tracker.vision.colours import ColourProfile, parse_profile, profile_to_toml
from tracker.vision.rig import ideal_rig

FACTORY = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
BLACK = ImageMessage(0, "left", "png", encode_image(np.zeros((8, 8, 3), np.uint8), "png", 0))
FITTED = ColourProfile("fitted", FACTORY.hues[::-1])


def colours(hand: HandModel, glove: GloveModel) -> OwnColours:
    info = SessionInfo(hand, glove, "", "", ClockAnchor(0, 0), rig=ideal_rig())
    return OwnColours(info, FACTORY)


def look(own: OwnColours, images: int, tracking: Tracking, start: float = 10.0) -> list[str]:
    """Codes of the notices over a number of images with this tracking."""
    for k in range(images):
        t = start + 1.01 * APART * k
        own._packed.append(PackedFrame(t, t, {"left": BLACK}, None, k))
        own.looked(BlobFrame(t, t, FACTORY.hue_names, Blobs.empty(), Blobs.empty()), tracking)
    return [event.code for event in own.drain_events()]


def test_images_without_a_hand_fit_the_colours_once(
    hand: HandModel, glove: GloveModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Images searched ahead with the old colours do not count against the new ones."""
    fits = []

    def fit(messages: list[StereoFrame], *_: object) -> SimpleNamespace:
        fits.append(len(messages))
        return SimpleNamespace(profile=FITTED, exchanged=())

    monkeypatch.setattr(own_colours, "fit_messages", fit)
    own = colours(hand, glove)
    assert look(own, IMAGES - 1, Tracking.SEARCHING) == []
    codes = look(own, AHEAD, Tracking.SEARCHING, 20.0)
    assert fits == [IMAGES]
    assert codes == ["colours.fitted_themselves"]
    assert own.detector.profile is FITTED


def test_a_rejected_fit_is_reported_once_and_retried_rarely(
    hand: HandModel, glove: GloveModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    tried = []

    def refuse(*_: object) -> None:
        tried.append(1)
        raise GlovetrackError("The colours could not be fitted.")

    monkeypatch.setattr(own_colours, "fit_messages", refuse)
    own = colours(hand, glove)
    codes = look(own, 10 * IMAGES, Tracking.LOST)
    assert codes == ["colours.no_hand"]
    assert len(tried) == ATTEMPTS
    assert own.detector.profile is FACTORY


def test_a_tracked_hand_is_not_changed(hand: HandModel, glove: GloveModel) -> None:
    own = colours(hand, glove)
    assert look(own, 3 * IMAGES, Tracking.TRACKING) == []


@pytest.mark.long
@pytest.mark.parametrize(("hands", "smooth"), [("right", True), ("both", False)])
def test_colours_are_fitted_for_smoothing_and_for_both_hands(
    hands: str, smooth: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With exchanged hue names no hand is found before; the quality of the fit is tested elsewhere.
    It is triggered after few images here, to save time."""
    names = FACTORY.hue_names[1:] + FACTORY.hue_names[:1]
    hues = tuple(replace(h, name=n) for h, n in zip(FACTORY.hues, names, strict=True))
    wrong = tmp_path / "wrong.toml"
    wrong.write_text(profile_to_toml(replace(FACTORY, hues=hues)))
    fitted = SimpleNamespace(profile=FACTORY, exchanged=())
    monkeypatch.setattr(own_colours, "fit_messages", lambda *_: fitted)
    monkeypatch.setattr(own_colours, "IMAGES", 2)
    for module in (own_colours, detection):
        monkeypatch.setattr(module, "AHEAD", 1)
    simulate(tmp_path / "in.mcap", SimulateOptions(seed=2, duration=1.3, fps=10, hands=hands))
    report = track(
        tmp_path / "in.mcap", tmp_path / "out.mcap", TrackOptions(colours=str(wrong), smooth=smooth)
    )
    own = report.hands.get("right", report)
    assert "colours.fitted_themselves" in [n.code for n in own.notices]
    assert 0.2 < own.lost_s < 1.1
