"""A simulated wearer who is asked for the script's gestures during free motion meets every rule.

This is what the demo's wearer does, on the clock of the simulation: a loaded computer loses none.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from extensions.conformance.finding import PASS
from extensions.conformance.run import judge, session_records
from extensions.conformance.take import SCRIPT, ScriptStep, take_of
from extensions.conformance.window.view_model import ScriptRun
from tracker.base.clock import NS
from tracker.messages import CameraPose
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build
from tracker.offline.track import track
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, new_session
from tracker.simulation.demo import TABLE
from tracker.simulation.gestures import gesture_angles
from tracker.simulation.posture_requests import AHEAD, PostureRequest, RequestedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import default_pose, ideal_rig

BEGIN = 3.0  # s of free motion before the script
FPS = 15.0  # as the tests of the demo


@pytest.mark.long
@pytest.mark.timeout(300)
def test_a_wearer_who_is_asked_for_each_gesture_keeps_every_rule(tmp_path: Path) -> None:
    _, info = build(SimulateOptions(seed=1, images=False))
    stand = default_pose()
    camera = CameraPose(stand.R_GC, stand.p_GC + np.array([0.0, 0.0, TABLE]))
    begun: list[tuple[str, float]] = []
    run = ScriptRun("right", lambda label, t: begun.append((label, t)))
    own = RandomPostures(info.hand, 1, duration=BEGIN + run.duration + 1.0, camera=camera)
    motion = RequestedMotion(own, 1)
    rig = ideal_rig(pose=camera)
    sim = Simulation(info.hand, info.glove, motion, 1, fps=FPS, rig=rig)
    # As the dialog leads the wearer: at the tick at which the gesture is another one.
    run.start(BEGIN)
    t, shown = BEGIN, ""
    while run.is_running:
        if run.gesture() != shown:
            shown = run.gesture()
            angles = gesture_angles(info.hand, shown, sim.wearer)
            turning = 6.0 if shown == "turn" else 0.0
            motion.ask(PostureRequest(t + AHEAD, tuple(angles.tolist()), turning))
        t += 0.05
        run.tick(t)
    raw, tracked = tmp_path / "raw.mcap", tmp_path / "tracked.mcap"
    params = RecorderParams(images="none", sync=False)
    with new_session(raw, replace(info, rig=sim.rig), params=params) as recorder:
        for message in sim.messages():
            recorder.write(message)
    track(raw, tracked, TrackOptions())
    with SessionReader(tracked) as reader:
        records = session_records(reader)["right"]
    zero = info.anchor.monotonic_ns
    steps = [
        ScriptStep(label, zero + round(at * NS), zero + round((at + SCRIPT[label]) * NS))
        for label, at in begun
    ]
    found = judge("the demo's wearer", [take_of("right", records)], steps).findings
    assert len(found) > 30
    assert [(f.rule, f.figure) for f in found if f.status != PASS] == []
