"""Images and packets collected for a live fit of the colours."""

import dataclasses
from functools import partial

import numpy as np
import pytest

from app.engines.snapshot import Snapshot
from app.viewmodels.colour_live import ENOUGH, GAP, MOST_IMAGES, LiveImages
from tests.benchmarks.desk import detection, folder, load
from tests.gui.gui_fakes import ScriptedEngine, frame_and_blobs, scripted_setup, with_camera
from tests.notices import raises
from tracker.base.errors import GlovetrackError
from tracker.calibration.colours_image import Pick, learn_picked
from tracker.glove import library
from tracker.messages import ImuSample, Status, Tracking
from tracker.vision.colours import parse_profile

SETUP = scripted_setup(ScriptedEngine())
SCENES = folder()
FACTORY = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
needs_data = pytest.mark.skipif(SCENES is None, reason="needs the photographs of a desk")


def packet(t: float) -> ImuSample:
    n = len(SETUP.glove.imus)
    still = np.tile([0.0, 0.0, 9.81], (n, 1))
    return ImuSample(t, t + 0.01, t, -1, still, np.zeros((n, 3)), np.ones(n, bool))


def view(t: float) -> Snapshot:
    """A sample at ``t`` with the packets of the last second."""
    frame = dataclasses.replace(frame_and_blobs(5)[0], t=t, t_arrival=t + 0.03)
    imu = tuple(packet(x) for x in np.arange(round(100 * t) - 100, round(100 * t)) / 100)
    return Snapshot(setup=SETUP, running=True, frame=frame, imu=imu)


def gathered(looks: int, start: float = 10.0) -> LiveImages:
    live = LiveImages(SETUP)
    for k in range(looks):
        live.watch(view(start + 0.125 * k))
    return live


def test_a_second_of_samples_is_sufficient_and_memory_is_bounded() -> None:
    assert not gathered(ENOUGH - 1).is_enough
    assert gathered(ENOUGH).is_enough
    assert len(gathered(3 * MOST_IMAGES)) == MOST_IMAGES


def test_samples_before_a_gap_or_a_jump_back_are_dropped() -> None:
    live = gathered(ENOUGH)
    live.watch(view(20.0 + GAP))
    assert len(live) == 1
    live.watch(view(5.0))
    assert len(live) == 1


@pytest.mark.long
def test_a_fit_without_a_hand_is_rejected() -> None:
    live = gathered(ENOUGH)
    live.ask()
    assert live.wanted
    blind = dataclasses.replace(
        SETUP.profile,
        hues=tuple(dataclasses.replace(h, saturation=(255, 255)) for h in SETUP.profile.hues),
    )
    for frame in live._frames:  # the room alone
        object.__setattr__(frame, "left", np.full_like(frame.left, 128))
        object.__setattr__(frame, "right", np.full_like(frame.right, 128))
    with raises(GlovetrackError, "colours.no_hand_found"):
        live.fit(blind)()
    assert not live.wanted


def test_without_calibrated_cameras_the_fit_names_an_alternative() -> None:
    live = LiveImages(with_camera(SETUP, calibrated=False))
    with raises(GlovetrackError, "colours.live_needs"):
        live.ask()


def test_the_banner_reports_unsuitable_colours_and_leads_to_a_fit(window, engine, qtbot):
    window.host.adopt(scripted_setup(engine))
    engine.values["colours_unfit"] = 1.0
    qtbot.waitUntil(lambda: "none fit the glove" in window.banner.text())
    engine.values["colours_unfit"] = 0.0
    qtbot.waitUntil(lambda: not window.messages.isVisible())
    engine.values["colours_unfit"] = 1.0
    qtbot.waitUntil(window.messages.isVisible)
    window.banner.buttons[0].click()
    assert window.colours.tuning.live.wanted
    assert not window.messages.isVisible()


@pytest.mark.long
def test_a_start_that_finds_no_hand_fits_automatically_in_the_background(window, qtbot):
    """The panel is hidden; a rejected automatic fit is not reported."""
    searching = ScriptedEngine(tracking=Tracking.SEARCHING)
    window.host.adopt(scripted_setup(searching))
    tuning = window.colours.tuning
    before = tuning.profile
    qtbot.waitUntil(lambda: tuning.live.wanted)
    assert window.colours.works_unseen
    assert window.banner.text() == ""
    assert tuning.profile is before


def test_colours_are_not_fitted_automatically_to_a_glove_of_the_other_hand(window, qtbot):
    searching = ScriptedEngine(tracking=Tracking.SEARCHING)
    searching.values["glove_of_other_side"] = 1.0
    window.host.adopt(scripted_setup(searching))
    tuning = window.colours.tuning
    status = Status(10.0, Tracking.SEARCHING, searching.values)
    window.colours.fitting.fit_by_itself()
    assert tuning.live.wanted
    for k in range(ENOUGH):
        look = dataclasses.replace(view(10.0 + 0.125 * k), status=status)
        window.colours.fitting.gather(look)
    assert not tuning.live.wanted
    assert "Fitting the colours" not in [job.title for job in window.tasks.tasks]


@pytest.mark.long
def test_an_automatic_fit_fails_silently() -> None:
    live = gathered(ENOUGH)
    live.ask()
    for frame in live._frames:
        object.__setattr__(frame, "left", np.full_like(frame.left, 128))
        object.__setattr__(frame, "right", np.full_like(frame.right, 128))
    profile, found = live.fit(SETUP.profile, refuse=False)()
    assert profile is SETUP.profile
    assert found == ()


@pytest.mark.long
@needs_data
def test_clicks_learn_from_the_images_around_them_like_a_fit() -> None:
    """In lamp light one image of a bent hand shows few patches of each hue, and none of their other
    sides."""
    assert SCENES is not None
    scene = load(SCENES / "lamp")
    info = scene.info
    setup = dataclasses.replace(SETUP, hand=info.hand, glove=info.glove)
    setup = with_camera(setup, rig=info.rig)
    live = LiveImages(setup)
    imu = [m for m in scene.messages if isinstance(m, ImuSample)]
    for frame in scene.frames[: 2 * ENOUGH + 2]:
        packets = tuple(p for p in imu if frame.t - 0.5 < p.t < frame.t + 0.05)
        live.watch(Snapshot(setup=setup, running=True, frame=frame, imu=packets))
    k, seen = 8, scene.visible
    image = scene.frames[k].left
    assert image is not None and info.rig is not None
    picks = []
    for name in FACTORY.hue_names:
        rows = [j for j, m in enumerate(info.glove.markers) if m.hue == name]
        best = max(rows, key=lambda j: (seen["frac"][k, 0, j] > 0.9) - seen["angle"][k, 0, j] / 100)
        picks.append(Pick(image, seen["uv_vis"][k, 0, best], name))
    picked = partial(learn_picked, picks, FACTORY, 0.012, info.rig.fx)
    profile, _ = live.after(picked, FACTORY)()
    assert detection(scene, profile, 6).recall > detection(scene, picked()[0], 6).recall + 0.02
    assert detection(scene, profile, 6).recall >= 0.96
