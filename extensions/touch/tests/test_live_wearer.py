"""The demo's wearer carries out the cues of the dialog."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from extensions.touch.pose import SheetPose, find_sheet
from extensions.touch.protocol import TouchCue, cues_of, touches
from extensions.touch.rest import find_touches
from extensions.touch.simulated.images import placed_sheet
from extensions.touch.simulated.session import Follower
from extensions.touch.track import tip_tracks
from extensions.touch.window.view_model import TouchPhase, TouchRun
from tracker.cli import main
from tracker.glove import library
from tracker.messages import Event, StereoFrame
from tracker.offline.simulate import SimulateOptions, build, truth_message
from tracker.session.description import SessionInfo
from tracker.session.reader import SessionReader
from tracker.simulation.demo import TABLE, DemoSpec, ask
from tracker.simulation.demo import build as build_demo
from tracker.simulation.posture_requests import AHEAD
from tracker.simulation.scenario import Simulation

pytestmark = pytest.mark.long

STEP = 0.05  # s
SEED = 1


@pytest.fixture(scope="module")
def demo() -> tuple[Simulation, SessionInfo]:
    texts = library.texts(library.DEFAULT_GLOVE)
    spec = DemoSpec(*texts, seed=SEED, duration=300.0, scene="touch_sheet", table=TABLE)
    return build_demo(spec), build(SimulateOptions(seed=SEED, images=False))[1]


def sheet_of(sim: Simulation) -> SheetPose:
    place = placed_sheet(SEED, rig=sim.rig)
    return SheetPose(place.R_GS, place.p_GS, 1.0, 1e-3, 1.0, True, 0.1, 0.0, 1)


def test_the_sheet_lies_in_the_images_where_the_wearer_touches_it(demo) -> None:
    sim, _ = demo
    ask(sim, Follower().away(sim, 0.5)[0])
    left, right = sim.renderer.pair(2.0)
    frames = [StereoFrame(2.0, 2.0, left, right)]
    assert find_sheet(frames, sim.scene.rig, 0.26).scale == pytest.approx(1, abs=1.5e-3)
    found = find_sheet(frames, sim.rig, 0.26)
    wrong = sim.rig.baseline / sim.scene.rig.baseline  # what the calibration is off by
    assert abs(wrong - 1) > 2e-3 and found.scale == pytest.approx(wrong, abs=1.5e-3)
    true = placed_sheet(SEED, rig=sim.rig)
    assert np.linalg.norm(found.p_GS - true.p_GS) < 1e-3
    assert np.degrees(np.arccos((np.trace(found.R_GS.T @ true.R_GS) - 1) / 2)) < 0.3


def test_each_touch_is_on_its_cross_and_found_by_its_cue(demo) -> None:
    """On the true hand: what is found differs from the cross by the wearer's aim and pulp alone.

    While the next cross is asked for, the wearer rests on the last one for longer than then on the
    next.
    """
    sim, info = demo
    events: list[Event] = []
    cues = [c for c in touches() if c.how != "covered"]
    run = TouchRun(lambda text, t, data: events.append(Event(t, "note", text, dict(data))), cues)
    follower, asked = Follower(), None
    names = sim.glove.keypoint_names(sim.hand)
    estimates = []
    t = 5.0
    run.start(t, sheet_of(sim), 0.26)
    while run.phase == TouchPhase.RUNNING and t < 250.0:
        if run.cue != asked:
            asked = run.cue
            for request in follower.cue(asked, sim, t + AHEAD):
                ask(sim, request)
        truth = truth_message(t, sim.truth(t), info)
        estimates.append(truth)
        run.tick(t, truth.keypoints[names.index(f"{run.cue.finger}_tip")])
        t += STEP
    assert run.done == {c.number for c in cues}
    found, missed = find_touches(
        tip_tracks(estimates, sim.hand, sim.glove), cues_of(events), sheet_of(sim)
    )
    assert not missed and [x.cue.target for x in found] == [x.asked for x in found]
    up_G = -sheet_of(sim).R_GS[:, 2]
    off = np.array([x.p_G - x.target_G for x in found])
    flat = off - (off @ up_G)[:, None] * up_G
    # the tip keypoint is the end of the finger, a contact up to one radius (9 mm) behind it
    assert np.linalg.norm(flat, axis=1).max() < 0.012 and (off @ up_G).max() < 0.015


def test_a_cue_without_a_touch_moves_the_hand_too(demo) -> None:
    sim, _ = demo
    follower = Follower()
    for cue in (TouchCue(25, "pinch"), TouchCue(26, "still")):
        plan = partial(follower.cue, cue)
        requests = plan(sim, 10.0)
        assert requests and all(len(r.place) == 12 for r in requests)
    assert len(follower.cue(TouchCue(25, "pinch"), sim, 10.0)) == 40


def test_simulated_sessions_show_the_sheet_and_their_camera_must_not_move(tmp_path) -> None:
    out = tmp_path / "sheet.mcap"
    words = ["simulate", "-o", str(out), "--scene", "touch_sheet", "--duration", "1"]
    assert main([*words, "--camera", "head"]) == 1 and not out.exists()
    assert main([*words, "--fps", "5", "--seed", str(SEED)]) == 0
    with SessionReader(out) as reader:
        frame = next(m for m in reader.messages((StereoFrame,)) if isinstance(m, StereoFrame))
        found = find_sheet([frame], reader.rig(), 0.26)
    assert np.linalg.norm(found.p_GS - placed_sheet(SEED).p_GS) < 2e-3
