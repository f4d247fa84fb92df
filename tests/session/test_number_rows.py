"""Columns read at once equal estimates read one at a time."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.notices import raises
from tracker.base.errors import FileError
from tracker.messages import Estimate
from tracker.session.export.series import recorded_series, series_of
from tracker.session.number_rows import NumberRows
from tracker.session.reader import SessionReader
from tracker.session.ros import motion


def test_columns_equal_estimates_bit_for_bit(
    tmp_path: Path, record: Callable[..., Path], maker
) -> None:
    found = [maker.estimate(10.0 * k, lost=k % 10 > 6) for k in range(60)]
    for k in (20, 21, 40):
        state, angle_state = found[k].keypoint_state.copy(), found[k].angle_state.copy()
        state[5], angle_state[1] = 1, 2
        found[k] = replace(found[k], keypoint_state=state, angle_state=angle_state)
    found[30], found[31] = found[31], found[30]  # written out of order
    path = record(tmp_path / "in.mcap", found)
    with SessionReader(path) as reader:
        columns = recorded_series(reader)
        one_by_one = [m for m in reader.messages([Estimate]) if isinstance(m, Estimate)]
        series = series_of(reader.info, sorted(one_by_one, key=lambda m: m.t))
    assert np.array_equal(columns.stamp_ns, series.stamp_ns)
    for ours, theirs in (
        (columns.keypoints, series.keypoints),
        (columns.q, series.q),
        (columns.angles, series.angles),
        (columns.state, series.state),
        (columns.angle_state, series.angle_state),
        (columns.sd, series.sd),
        (columns.segment_p, series.segment_p),
        (columns.segment_q, series.segment_q),
    ):
        assert np.array_equal(ours, theirs, equal_nan=True)
    assert (columns.state == 1).sum() == 3 and np.isnan(columns.angles).any()


def test_joints_are_found_among_zeros_and_with_changing_names() -> None:
    """A message contains eight zero bytes in several positions."""
    rows_in = [
        (("a",), [0.0]),
        (("a",), [1.5]),
        (("a", "longer"), [2.5, 0.0]),
        (("longer", "a"), [3.5, 4.5]),
        ((), []),
        (("a",), [-1.0]),
    ]
    rows = NumberRows(8)
    for k, (names, values) in enumerate(rows_in):
        rows.feed_joints(motion.pack_joints(motion.JointState(k, names, np.array(values))))
    stamps, values = rows.by_name(("a", "longer"))
    assert stamps.tolist() == [0, 1, 2, 3, 4, 5]
    nan = np.nan
    wanted = [[0.0, nan], [1.5, nan], [2.5, 0.0], [4.5, 3.5], [nan, nan], [-1.0, nan]]
    assert np.array_equal(values, wanted, equal_nan=True)


def test_a_session_without_estimates_is_reported(
    tmp_path: Path, record: Callable[..., Path], maker
) -> None:
    path = record(tmp_path / "in.mcap", [maker.imu(0.0)])
    with SessionReader(path) as reader, raises(FileError, "session.not_tracked"):
        recorded_series(reader)
