"""One recorded hand as arrays."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glovetrack.columns import Columns, frame
from tracker.base.clock import NS
from tracker.messages import Array, IntArray, Validity
from tracker.session.export.series import EstimateSeries

if TYPE_CHECKING:
    import pandas as pd

XYZ, XYZW = ("x", "y", "z"), ("x", "y", "z", "w")


class Hand:
    """N estimates of one hand, in the order of their instants.

    Positions are in the global frame G (z up), in m; angles in rad. What is lost is NaN.
    """

    def __init__(self, side: str, series: EstimateSeries, zero_ns: int) -> None:
        """``zero_ns``: the instant of ``t = 0``, ns since 1970."""
        self.side: str = side
        self._series = series
        self._zero_ns = zero_ns
        self.t: Array = (series.stamp_ns - zero_ns) / NS
        """(N,) s since the recording began."""

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        return f"<{self.side} hand, {len(self)} estimates>"

    @property
    def t_unix_ns(self) -> IntArray:
        """(N,) ns since 1970."""
        return self._series.stamp_ns

    @property
    def keypoints(self) -> Columns:
        """Positions ``p_G`` (N, 3) m by keypoint name; NaN where lost."""
        s = self._series
        return Columns(s.keypoint_names, s.keypoints, self.t, "m", XYZ)

    @property
    def orientations(self) -> Columns:
        """Unit quaternions (N, 4) xyzw of the bone that begins at each keypoint, from the bone's
        axes (x to its tip, z out of the back of the hand) to G."""
        s = self._series
        return Columns(s.keypoint_names, s.q, self.t, "", XYZW)

    @property
    def sd(self) -> Columns:
        """Standard deviation (N,) m of each keypoint's position, as the tracker claims it."""
        return Columns(self._series.keypoint_names, self._series.sd, self.t, "m")

    @property
    def angles(self) -> Columns:
        """Joint angles (N,) rad by name; NaN where lost."""
        return Columns(self._series.joint_names, self._series.angles, self.t, "rad")

    @property
    def valid(self) -> Columns:
        """Whether each keypoint is known, (N,) bool: measured or inferred, not lost."""
        return self._states(self._series.state != Validity.LOST)

    @property
    def measured(self) -> Columns:
        """Whether each keypoint is measured, (N,) bool: neither inferred nor lost."""
        return self._states(self._series.state == Validity.MEASURED)

    @property
    def angles_measured(self) -> Columns:
        """Whether each joint angle is measured, (N,) bool."""
        state = self._series.angle_state == Validity.MEASURED
        return Columns(self._series.joint_names, state, self.t)

    def _states(self, state: NDArray[np.bool_]) -> Columns:
        return Columns(self._series.keypoint_names, state, self.t)

    def between(self, start: float, stop: float) -> Hand:
        """The estimates with ``start <= t < stop`` (s)."""
        first, last = np.searchsorted(self.t, [start, stop])
        rows = np.arange(first, last)
        return Hand(self.side, self._series.rows(rows), self._zero_ns)


class OnlyHand(ABC):
    """What a recording of one hand offers of it directly; of both hands each property raises
    ConfigError."""

    @property
    @abstractmethod
    def hand(self) -> Hand:
        """The only hand."""

    @property
    def t(self) -> Array:
        """(N,) s of the only hand's estimates."""
        return self.hand.t

    @property
    def t_unix_ns(self) -> IntArray:
        """(N,) ns since 1970 of the only hand's estimates."""
        return self.hand.t_unix_ns

    @property
    def keypoints(self) -> Columns:
        """See `Hand.keypoints`, of the only hand."""
        return self.hand.keypoints

    @property
    def angles(self) -> Columns:
        """See `Hand.angles`, of the only hand."""
        return self.hand.angles

    @property
    def sd(self) -> Columns:
        """See `Hand.sd`, of the only hand."""
        return self.hand.sd

    @property
    def valid(self) -> Columns:
        """See `Hand.valid`, of the only hand."""
        return self.hand.valid


class ImuSamples:
    """N samples of one IMU: ``t`` (N,) s, ``accel`` (N, 3) m/s² and ``gyro`` (N, 3) rad/s in the
    IMU's own axes, NaN where ``valid`` (N,) is False."""

    def __init__(
        self, name: str, t: Array, accel: Array, gyro: Array, valid: NDArray[np.bool_]
    ) -> None:
        self.name = name
        self.t = t
        self.accel = accel
        self.gyro = gyro
        self.valid = valid

    def __len__(self) -> int:
        return len(self.t)

    def __repr__(self) -> str:
        return f"<IMU {self.name}, {len(self)} samples>"

    def to_frame(self) -> pd.DataFrame:
        """A pandas table with ``accel_x`` … ``gyro_z`` and ``valid`` over ``t`` (s).

        Raises ImportError where pandas is not installed.
        """
        columns: dict[str, NDArray[Any]] = {}
        for what, values in (("accel", self.accel), ("gyro", self.gyro)):
            columns |= {f"{what}_{axis}": values[:, i] for i, axis in enumerate(XYZ)}
        return frame(self.t, columns | {"valid": self.valid})
