"""The public API on recordings: those of the application and those with known truth."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

import glovetrack
from tests.live_recordings import LiveRecordings
from tests.notices import raises
from tracker.messages import Estimate, ImuSample, StereoFrame
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.timeout(600)


@pytest.fixture
def live(live_recordings: LiveRecordings) -> glovetrack.Recording:
    return glovetrack.open(live_recordings.path("one hand"))


@pytest.fixture(scope="module")
def simulated(tmp_path_factory: pytest.TempPathFactory) -> glovetrack.Recording:
    path = tmp_path_factory.mktemp("simulated") / "session.mcap"
    return glovetrack.simulate(path, seed=5, duration=3.0, images=False)


@pytest.fixture(scope="module")
def tracked(simulated: glovetrack.Recording) -> glovetrack.Recording:
    return simulated.track()


def test_arrays_are_those_of_the_file(live: glovetrack.Recording) -> None:
    with SessionReader(live.path) as reader:
        found = sorted(
            (m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)), key=lambda m: m.t
        )
        names = reader.info.keypoint_names
        start = reader.anchor.monotonic(reader.span_ns[0])
    i = names.index("index_tip")
    np.testing.assert_array_equal(live.keypoints["index_tip"], [m.keypoints[i] for m in found])
    np.testing.assert_array_equal(live.sd["index_tip"], [m.keypoint_sd[i] for m in found])
    np.testing.assert_allclose(live.t, [m.t - start for m in found], atol=2e-9)
    assert live.keypoints.names == names and live.sides == ("right",)
    assert set(np.unique(live.valid.array)) <= {False, True}


def test_lost_is_not_valid_and_nan(tracked: glovetrack.Recording) -> None:
    lost = ~tracked.valid["index_tip"]
    assert lost.any(), "before the hand is found it is lost"
    assert np.isnan(tracked.keypoints["index_tip"][lost]).all()
    assert np.isfinite(tracked.keypoints["index_tip"][~lost]).all()
    measured = tracked.hand.measured.array
    assert measured.any() and not (measured & ~tracked.valid.array).any()


def test_the_truth_of_a_simulated_session(
    simulated: glovetrack.Recording, tracked: glovetrack.Recording
) -> None:
    true = simulated.truth["right"]
    rows = tracked.t > 1.0  # the hand was found by then
    for axis in range(3):
        at = np.interp(tracked.t, true.t, true.keypoints["index_tip"][:, axis])
        away = tracked.keypoints["index_tip"][rows, axis] - at[rows]
        assert np.median(np.abs(away)) < 0.02, "the truth is that of this hand (usual error 4 mm)"
    kept = tracked.truth["right"]
    np.testing.assert_array_equal(kept.t_unix_ns, true.t_unix_ns)
    np.testing.assert_array_equal(kept.keypoints["index_tip"], true.keypoints["index_tip"])


def test_a_slice_has_the_same_times(live: glovetrack.Recording) -> None:
    part = live[1.0:2.0]
    inside = (live.t >= 1.0) & (live.t < 2.0)
    np.testing.assert_array_equal(part.t, live.t[inside])
    np.testing.assert_array_equal(part.keypoints["thumb_tip"], live.keypoints["thumb_tip"][inside])
    whole, some = live.imu("dorsum"), part.imu("dorsum")
    rows = (whole.t >= 1.0) & (whole.t < 2.0)
    np.testing.assert_array_equal(some.gyro, whole.gyro[rows])
    assert part.duration == pytest.approx(1.0)
    nested = part[1.5:9.0]
    assert nested.t[0] >= 1.5 and nested.t[-1] < 2.0
    with pytest.raises(TypeError, match="seconds"):
        live[::2]


def test_sensors_are_those_of_the_file(live: glovetrack.Recording) -> None:
    with SessionReader(live.path) as reader:
        found = [m for m in reader.messages((ImuSample,)) if isinstance(m, ImuSample)]
        names = reader.info.glove.imu_names
    samples = live.imu("index_proximal")
    i = names.index("index_proximal")
    np.testing.assert_array_equal(samples.accel, [m.accel[i] for m in found])
    table = samples.to_frame()
    assert list(table.columns[:3]) == ["accel_x", "accel_y", "accel_z"] and table.index.name == "t"
    with pytest.raises(KeyError, match="elbow"):
        live.imu("elbow")


def test_tables_have_a_column_for_each_number(live: glovetrack.Recording) -> None:
    angles = live.angles.to_frame()
    np.testing.assert_array_equal(angles["index_mcp_flexion"], live.angles["index_mcp_flexion"])
    points = live.keypoints.to_frame()
    np.testing.assert_array_equal(points["index_tip_y"], live.keypoints["index_tip"][:, 1])


def test_images_are_in_order_and_of_both_cameras(live: glovetrack.Recording) -> None:
    with SessionReader(live.path) as reader:
        frames = [m for m in reader.messages((StereoFrame,)) if isinstance(m, StereoFrame)]
    left, right = list(live.images("left")), list(live.images("right"))
    assert len(left) == len(frames) > 10 and len(right) == len(frames)
    np.testing.assert_array_equal(left[3].rgb[..., ::-1], frames[3].left)
    assert (np.diff([image.t for image in left]) > 0).all()
    part = list(live[1.0:2.0].images("right"))
    assert [i.t for i in part] == [i.t for i in right if 1.0 <= i.t < 2.0]
    with raises(glovetrack.ConfigError, "option.choice", option="camera"):
        next(live.images("middle"))


def test_tracked_again_it_is_identical(live: glovetrack.Recording) -> None:
    again = live.track()
    assert again.compare(live)["identical"]
    assert again.path.exists()
    folder = again.path.parent
    again.close()
    assert not folder.exists(), "a recording without a name is deleted with its object"


def test_a_slice_is_tracked_as_the_whole(live: glovetrack.Recording) -> None:
    part = live[0.5:2.0].track()
    common, rows, _ = np.intersect1d(live.t_unix_ns, part.t_unix_ns, return_indices=True)
    assert len(common) > 20  # a loaded computer estimates the last seconds later
    np.testing.assert_array_equal(live.keypoints.array[rows], part.keypoints.array)
    np.testing.assert_array_equal(live.t[rows], part.t)
    later = part[1.5:]
    np.testing.assert_array_equal(later.t, part.t[part.t >= 1.5])
    assert later.duration == pytest.approx(part.t[-1] - 1.5, abs=0.3)
    assert "x" in repr(next(live.images())) and len(repr(next(live.images()))) < 60


@pytest.mark.long
def test_another_engine(live: glovetrack.Recording, tmp_path: Path) -> None:
    other = live.track(engine="vist", out=tmp_path / "vist.mcap")
    assert other.engine == "vist" and other.path == tmp_path / "vist.mcap"
    assert not other.compare(live)["identical"]
    with raises(glovetrack.GlovetrackError, "file.exists_force"):
        live.track(out=tmp_path / "vist.mcap")


def test_exports_contain_the_same_numbers(live: glovetrack.Recording, tmp_path: Path) -> None:
    done = live.export("csv", tmp_path / "hand.csv")
    with (tmp_path / "hand.csv").open() as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    assert len(rows) == done["rows"] == len(live.t)
    (column,) = [c for c in rows[0] if c.startswith("index_tip_x")]
    scale = 1000.0 if "mm" in column else 1.0
    written = [float(r[column] or "nan") / scale for r in rows]
    np.testing.assert_allclose(written, live.keypoints["index_tip"][:, 0], atol=1e-6)


@pytest.mark.long
def test_both_hands(live_recordings: LiveRecordings) -> None:
    both = glovetrack.open(live_recordings.path("both hands"))
    assert both.sides == ("left", "right") and set(both.hands) == {"left", "right"}
    assert len(both.hands["left"].t) > 20
    with raises(glovetrack.ConfigError, "api.both_recorded"):
        both.keypoints  # noqa: B018
    with raises(glovetrack.ConfigError, "api.both_recorded"):
        both.imu("dorsum")
    assert len(both.imu("dorsum", "left")) > 20


def test_events_are_notes_and_incidents(live: glovetrack.Recording) -> None:
    (begun,) = [e for e in live.events if e.kind == "recording"]
    # A loaded computer records packets, and reports events of images, seconds after their instant.
    assert -1.0 < begun.t < 30.0
    assert all(-30.0 < e.t < live.duration + 1.0 for e in live.events)


def test_other_files_are_rejected(tmp_path: Path) -> None:
    with pytest.raises(glovetrack.FileError):
        glovetrack.open(tmp_path / "missing.mcap")
    (tmp_path / "text.mcap").write_text("not a session")
    with pytest.raises(glovetrack.FileError):
        glovetrack.open(tmp_path / "text.mcap")


def test_a_misspelled_name_names_the_nearest(live: glovetrack.Recording) -> None:
    with pytest.raises(KeyError, match="index_tip"):
        live.keypoints["index_tpi"]


def test_a_difference_is_located(
    simulated: glovetrack.Recording, tracked: glovetrack.Recording
) -> None:
    vist = simulated.track(engine="vist")
    found = tracked.compare(vist)
    assert not found["identical"] and 0.0 <= found["first_difference_s"] < 1.0
    assert vist.track().compare(vist)["first_difference_s"] is None


def test_a_slice_is_compared_and_exported_as_a_slice(
    tracked: glovetrack.Recording, tmp_path: Path
) -> None:
    """Files are cut at the arrival times of messages, which a loaded computer delays."""
    part = tracked[1.0:2.0]
    found = part.compare(tracked)
    assert found["estimates"][0] == found["compared"] == pytest.approx(len(part.t), abs=3)
    assert found["estimates"][1] == len(tracked.t)
    done = part.export("csv", tmp_path / "part.csv")
    assert done["rows"] == pytest.approx(len(part.t), abs=3)


def test_a_failed_tracking_leaves_nothing(
    live: glovetrack.Recording, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with pytest.raises(glovetrack.ConfigError):
        live.track(engine="none")
    with pytest.raises(glovetrack.ConfigError):
        glovetrack.simulate(duration=-1.0)
    assert list(tmp_path.iterdir()) == []
