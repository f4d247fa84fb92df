"""Measures of a take's motion, compared with known motion."""

from __future__ import annotations

import csv
import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import FileError
from tracker.messages import Validity
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.motion import (
    APERTURE,
    COLUMNS,
    Take,
    Units,
    curve,
    distance,
    measures,
    read_take,
    speed,
    table,
)
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.long

RATE, SECONDS, SWING, TURN = 100.0, 4.0, 0.5, 2.0  # Hz, s, rad, rad/s of the swing's phase


def swinging() -> Take:
    """An angle that swings by ±0.5 rad at 2 rad/s; points 30 mm apart, then 50; lost between."""
    t = np.arange(0.0, SECONDS, 1 / RATE)
    angle = 0.2 + SWING * np.sin(TURN * t)
    points = np.zeros((len(t), 2, 3))
    points[:, 0] = np.stack([t, np.sin(t), 0 * t], axis=1)  # the hand moves, distances do not
    points[:, 1] = points[:, 0] + [0.0, 0.0, 0.03]
    points[t >= 3.0, 1, 2] = 0.05
    state = np.full((len(t), 2), int(Validity.MEASURED))
    state[(t >= 1.0) & (t < 2.0), 1] = Validity.INFERRED
    state[(t >= 2.0) & (t < 3.0), 1] = Validity.LOST
    points[(t >= 2.0) & (t < 3.0), 1] = np.nan
    return Take(
        t, ("index_mcp_flexion",), angle[:, None], np.full((len(t), 1), 2), np.array([[-1.0, 2.0]]),
        ("thumb_tip", "index_tip"), points, np.full((len(t), 2), 0.003), state,
    )  # fmt: skip


def test_range_and_maximum_rate_of_a_swing() -> None:
    angle, _ = measures(swinging(), [APERTURE])
    assert (angle.least, angle.greatest) == pytest.approx((0.2 - SWING, 0.2 + SWING), abs=1e-4)
    assert angle.range == pytest.approx(2 * SWING, abs=2e-4)
    # the mean slope over 50 ms around the fastest time: sin(x)/x of 0.05 rad below it
    assert angle.fastest == pytest.approx(SWING * TURN, rel=1e-3)
    assert (angle.measured, angle.inferred, angle.lost) == (1.0, 0.0, 0.0)
    assert np.isnan(angle.claimed_sd)


def test_a_distance_is_independent_of_position_and_of_lost_rows() -> None:
    _, aperture = measures(swinging(), [APERTURE])
    assert (aperture.least, aperture.greatest) == pytest.approx((0.03, 0.05))
    assert aperture.mean == pytest.approx((2 * 0.03 + 0.05) / 3)
    shares = aperture.measured, aperture.inferred, aperture.lost
    assert shares == pytest.approx((0.5, 0.25, 0.25))
    assert aperture.claimed_sd == pytest.approx(0.003 * np.sqrt(2))
    assert aperture.fastest == pytest.approx(0.0, abs=1e-9)  # no speed across lost rows


def with_hole(take: Take, start: float, stop: float) -> Take:
    """Without the estimates between two times (s)."""
    rows = (take.t < start) | (take.t >= stop)
    of_rows = ("t", "angles", "angle_state", "points", "point_sd", "point_state")
    return replace(take, **{name: getattr(take, name)[rows] for name in of_rows})


def test_time_without_estimates_is_lost_and_not_bridged() -> None:
    take = with_hole(swinging(), 1.0, 2.0)
    angle, aperture = measures(take, [APERTURE])
    shares = angle.measured, angle.inferred, angle.lost
    assert shares == pytest.approx((0.75, 0.0, 0.25), abs=1e-9)
    shares = aperture.measured, aperture.inferred, aperture.lost
    assert shares == pytest.approx((0.5, 0.0, 0.5), abs=1e-9)
    t, values = curve(take, take.angles[:, 0], take.angle_state[:, 0])
    assert t[np.isnan(values)] == pytest.approx([1.495])
    t, values = curve(take, *distance(take, APERTURE)[::2])
    lost = np.isnan(values)
    assert lost[(t > 1.0) & (t < 3.0)].all() and not lost[(t < 1.0) | (t >= 3.0)].any()


def test_noise_of_one_estimate_and_gaps_give_no_speed() -> None:
    t = np.arange(0.0, 1.0, 0.01)
    values = 3.0 * t
    np.testing.assert_allclose(speed(t, values), 3.0)
    values[50] += 0.1
    assert np.nanmax(np.abs(speed(t, values))) < 3.0 + 0.1 / 0.025
    far = np.concatenate([t, t + 5.0])
    steps = np.concatenate([0 * t, 0 * t + 1.0])
    assert np.nanmax(np.abs(speed(far, steps))) == 0.0
    assert np.isnan(speed(np.array([0.0]), np.array([1.0]))).all()


def test_without_known_rows_there_are_no_numbers() -> None:
    take = swinging()
    take.angles[:] = np.nan
    angle = measures(take, [])[0]
    assert np.isnan(angle.range) and angle.lost == 1.0
    assert list(csv.reader(io.StringIO(table([angle], Units()))))[1][2:6] == [""] * 4


@pytest.mark.parametrize(("degrees", "factor"), [(True, 180 / np.pi), (False, 1.0)])
def test_the_table_has_the_requested_units(degrees: bool, factor: float) -> None:
    rows = measures(swinging(), [APERTURE])
    read = list(csv.DictReader(io.StringIO(table(rows, Units(degrees)))))
    assert tuple(read[0]) == COLUMNS
    assert float(read[0]["range"]) == pytest.approx(rows[0].range * factor, rel=1e-5)
    assert read[0]["unit"] == ("deg" if degrees else "rad")
    assert read[1]["unit"] == "mm" and float(read[1]["max"]) == pytest.approx(50.0)
    assert table(rows, Units(), "\t").splitlines()[0].split("\t") == list(COLUMNS)


@pytest.fixture(scope="module")
def sessions(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    folder = tmp_path_factory.mktemp("motion")
    simulated, tracked = folder / "simulated.mcap", folder / "tracked.mcap"
    simulate(simulated, SimulateOptions(seed=4, duration=6.0, fps=30, images=False))
    track(simulated, tracked, TrackOptions("chain"))
    return simulated, tracked


def test_a_simulated_take_has_the_simulated_motion(
    sessions: tuple[Path, Path],
) -> None:
    with SessionReader(sessions[1]) as reader:
        take = read_take(reader)
        start = reader.anchor.monotonic(reader.span_ns[0])
    with SessionReader(sessions[0]) as reader:
        truth = {round(e.t, 4): e.keypoints for e in reader.truth()}
        names = reader.info.keypoint_names
    a, b = (names.index(n) for n in APERTURE)
    away, sd, state = distance(take, APERTURE)
    at = [truth.get(round(t + start, 4)) for t in take.t]
    true = np.array([np.nan if k is None else np.linalg.norm(k[a] - k[b]) for k in at])
    late = (take.t > 3.0) & np.isfinite(true) & np.isfinite(away)
    assert late.sum() > 30
    assert (
        np.sqrt(np.mean((away - true)[late] ** 2)) < 0.012
    )  # the hand's size is still being estimated
    assert (np.abs(away - true)[late] < 3 * sd[late]).mean() > 0.9
    assert set(np.unique(state)) <= {0, 1, 2}
    assert -0.02 < take.t[0] < 1.0 and take.t[-1] == pytest.approx(6.0, abs=0.5)


def test_a_session_without_estimates_is_rejected(sessions: tuple[Path, Path]) -> None:
    with SessionReader(sessions[0]) as reader, raises(FileError, "session.not_tracked"):
        read_take(reader)
