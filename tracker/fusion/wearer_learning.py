"""The interface of an engine that learns the wearer: reading and writing its profile."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, runtime_checkable

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.fusion.chain.calibration.measured import measured_profile
from tracker.fusion.chain.calibration.profile_file import WearerFile, read_wearer, write_wearer
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.engine import Engine
from tracker.messages import Array, Calibration

if TYPE_CHECKING:
    from tracker.fusion.chain.known import KnownWearer

FLOOR = np.deg2rad(0.1)
"""rad/s: residual rotation of a hand resting on a table, and drift of the bias until it is used."""


def with_gyro_bias(
    profile: WearerProfile, layout: ChainLayout, bias: Array, sd: Array
) -> WearerProfile:
    """``profile`` with the biases (n, 3) rad/s and their standard deviations (n,) of each IMU; rows
    of NaN leave an IMU unchanged."""
    known = np.flatnonzero(np.all(np.isfinite(bias), axis=1) & np.isfinite(sd))
    bg, P = profile.bg.copy(), profile.P.copy()
    for j in known:
        rows = layout.blocks.bg - layout.n_dynamic + 3 * j + np.arange(3)
        P[rows, :] = 0.0
        P[:, rows] = 0.0
        P[rows, rows] = float(np.hypot(sd[j], FLOOR)) ** 2
        bg[j] = bias[j]
    return replace(profile, bg=bg, P=P)


@runtime_checkable
class LearnsWearer(Protocol):
    """An engine that has the wearer calibration of the filter `chain`.

    ``wearer`` processes guided poses and a user's commands.
    """

    @property
    def wearer(self) -> KnownWearer: ...

    @property
    def layout(self) -> ChainLayout:
        """The rows of profiles."""

    def calibration(self) -> Calibration: ...

    def profile(self) -> WearerProfile:
        """The learned wearer profile."""

    def apply_profile(self, profile: WearerProfile) -> None:
        """Use a wearer profile, now and at each new start."""


def learner_of(engine: Engine) -> LearnsWearer | None:
    """The engine, if it learns the wearer."""
    return engine if isinstance(engine, LearnsWearer) else None


def load_wearer(engine: Engine, profile: Path) -> None:
    """Start with a wearer profile. Raises ConfigError for an engine that does not use profiles,
    FileError for an invalid file."""
    learner = _learner(engine)
    learner.apply_profile(read_wearer(profile, learner.layout).profile)


def start_with_length(engine: Engine, length: float) -> None:
    """Start with a hand of ``length`` m, average otherwise. Raises as `load_wearer`."""
    learner = _learner(engine)
    learner.apply_profile(measured_profile(learner.layout, length))


def save_wearer(engine: Engine, profile: Path) -> None:
    """Write the learned profile to the file, replacing it. Raises as `load_wearer`."""
    write_wearer(profile, learned(_learner(engine)))


def learned(learner: LearnsWearer) -> WearerFile:
    """The present profile of the wearer."""
    return WearerFile(learner.layout, learner.profile(), learner.calibration())


def take_gyro_bias(engine: Engine, bias: Array, sd: Array) -> None:
    """Use gyro biases (n, 3) rad/s, with sd (n,), measured at rest; no effect on an engine that
    does not learn the wearer."""
    if (learner := learner_of(engine)) is not None:
        learner.apply_profile(with_gyro_bias(learner.profile(), learner.layout, bias, sd))


def _learner(engine: Engine) -> LearnsWearer:
    if (learner := learner_of(engine)) is None:
        raise ConfigError(notice("engine.no_wearer"))
    return learner
