"""Sessions whose estimates are the truth of a simulated hand with known noise."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, Slerp

from extensions.reference.tests.laboratory import FAULTY, markers, write_c3d
from tests.gui.conftest import no_leaks, qtbot, store, window
from tests.made_once import made_once
from tracker.cli import main
from tracker.geometry import so3
from tracker.messages import Array, Event, Validity
from tracker.offline.simulate import SimulateOptions, build, truth_message
from tracker.session.description import SessionInfo
from tracker.session.writer import RecorderParams, SessionRecorder

__all__ = ["no_leaks", "qtbot", "store", "window"]

DURATION = 24.0  # s
START = 0.5  # s of the simulation at the session's first estimate


@dataclass(frozen=True, eq=False)
class Wearer:
    """``points(t)``: keypoints (n, K, 3) m and axes of their segments (n, K, 3, 3) at session times
    t (n,) s from -1 on; ``session(path, noise, duration, seed, person, …)`` writes a session
    of them at ``rate`` Hz, with noise (sd in m, as claimed) per coordinate."""

    info: SessionInfo
    points: Callable[[Array], tuple[Array, Array]]
    session: Callable[..., Path]


@pytest.fixture(scope="session")
def wearer() -> Wearer:
    """Positions by a cubic spline through 100 instants per second, orientations in between."""
    sim, info = build(SimulateOptions(seed=4, duration=DURATION + 4, images=False))
    hand, glove = info.hand, info.glove
    segments = glove.keypoint_segments(hand)
    at = np.arange(-1.0, DURATION + 2.0, 0.01)
    poses = sim.motion.poses(at + START)
    p = np.empty((len(at), len(segments), 3))
    R = np.empty((len(at), len(segments), 3, 3))
    for i in range(len(at)):
        R_GB, p_GB = hand.forward(poses.angles[i], poses.R_GB[i], poses.p_GB[i])
        p[i] = glove.keypoint_positions(hand, R_GB, p_GB, np.ones((len(hand.segments), 3)))
        R[i] = R_GB[segments]
    turns = [Slerp(at, Rotation.from_matrix(R[:, k])) for k in range(len(segments))]
    spline = CubicSpline(at, p)

    def points(t: Array) -> tuple[Array, Array]:
        return spline(t), np.stack([turn(t).as_matrix() for turn in turns], axis=1)

    def session(
        path: Path,
        noise: float = 0.0,
        duration: float = DURATION,
        seed: int = 1,
        person: str = "",
        events: Sequence[Event] = (),
        inferred: Sequence[str] = (),
        rate: float = 100.0,
    ) -> Path:
        of = replace(info, participant=person)
        rng = np.random.default_rng(seed)
        t = np.arange(0, duration, 1.0 / rate)
        x, R_GB = points(t)
        x = x + rng.normal(0, 1, x.shape) * noise
        q = so3.quat_from_matrix(R_GB)
        like = truth_message(START, sim.truth(START), of)
        sd = np.full(len(segments), noise)
        state = np.where(np.isin(of.keypoint_names, inferred), Validity.INFERRED, Validity.MEASURED)
        with SessionRecorder(path, of, RecorderParams(images="none", sync=False)) as recorder:
            for i, s in enumerate(t):
                e = replace(like, t=float(s) + START, keypoints=x[i], keypoint_q=q[i])
                recorder.write(replace(e, keypoint_sd=sd, keypoint_state=state))
            for event in events:
                recorder.write(event)
        return path

    return Wearer(info, points, session)


@pytest.fixture(scope="session")
def tracked(wearer: Wearer, shared_folder: Path) -> Path:
    """24 s with noise of 1 mm; tests write nothing beside it."""
    made = made_once(
        shared_folder / "reference-24s", lambda to: wearer.session(to / "tracked.mcap", 0.001)
    )
    return made / "tracked.mcap"


@pytest.fixture(scope="session")
def short(wearer: Wearer, shared_folder: Path) -> Path:
    """Likewise, 20 s at 50 Hz."""
    made = made_once(
        shared_folder / "reference-20s",
        lambda to: wearer.session(to / "short.mcap", 0.001, duration=20.0, rate=50.0),
    )
    return made / "short.mcap"


@pytest.fixture(scope="session")
def imported(tracked: Path, faulty: Path, shared_folder: Path) -> Path:
    """By the command, with ``report.json`` next to it."""

    def make(folder: Path) -> None:
        words = ["-o", str(folder / "out.mcap"), "--json", str(folder / "report.json")]
        assert main(["import-reference", str(faulty), str(tracked), *words]) == 0

    return made_once(shared_folder / "reference-imported", make) / "out.mcap"


@pytest.fixture(scope="session")
def faulty(wearer: Wearer, tmp_path_factory: pytest.TempPathFactory) -> Path:
    lab = replace(FAULTY, markers=markers(wearer))
    _, x_L = lab.record(wearer, 23.0)
    path = tmp_path_factory.mktemp("lab") / "faulty.c3d"
    return write_c3d(path, wearer.info.keypoint_names, x_L)
