"""The errors of a simulated camera: by default those of a ZED that was calibrated with a board.

Sources: Stereolabs gives 15.7 µs per row for 720 rows at 60 images per second; `rig_errors` and
`flicker` describe theirs.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.simulation.flicker import FlickerParams
from tracker.simulation.rig_errors import BOARD, RigErrorParams, true_camera, with_lenses
from tracker.vision.rig import StereoRig, with_readout

if TYPE_CHECKING:
    from tracker.simulation.scenario import SimulationParams

ROOM_LAMP = FlickerParams(depth=0.1)
ALL, NONE = "all", "none"


@dataclass(frozen=True)
class CameraErrors:
    """``lenses``: whether they distort. ``calibration``: by how much it is off. ``readout``: s from
    the exposure of the first row to that of the last. ``stamp_jitter``: s, standard deviation of
    the time stamps; the driver stamps images of a ZED. ``flicker``: of a lamp with a filament or a
    smoothed supply."""

    lenses: bool = True
    calibration: RigErrorParams = BOARD
    readout: float = 0.011
    stamp_jitter: float = 0.0005
    flicker: FlickerParams = ROOM_LAMP

    def rig(self, ideal: StereoRig, seed: int) -> StereoRig:
        """The calibration of a camera with these errors, instead of an ``ideal`` one."""
        rig = with_readout(ideal, self.readout)
        return with_lenses(rig, seed) if self.lenses else rig

    def true_rig(self, rig: StereoRig, seed: int) -> StereoRig:
        """The camera that takes the images, of one that is calibrated as ``rig``."""
        return true_camera(rig, seed, self.calibration)

    def params(self, params: SimulationParams) -> SimulationParams:
        """Parameters of the simulation of such a camera."""
        return replace(
            params,
            rig_errors=self.calibration,
            stamp_jitter=self.stamp_jitter,
            flicker=self.flicker,
        )


IDEAL = CameraErrors(False, RigErrorParams(), 0.0, 0.0, FlickerParams())
ZED = CameraErrors()
WEBCAM = replace(ZED, readout=0.018, stamp_jitter=0.004)
"""With one lens; its images are stamped when they arrive."""
FIELDS = {
    "lenses": "lenses",
    "calibration": "calibration",
    "shutter": "readout",
    "stamps": "stamp_jitter",
    "flicker": "flicker",
}
"""The fields of `CameraErrors` by their names in options."""


def errors_named(names: str, one_camera: bool = False) -> CameraErrors:
    """The errors in a list such as ``lenses,stamps``, or `ALL` or `NONE`, of a ZED or a camera with
    one lens. Raises ConfigError for an unknown name."""
    real = WEBCAM if one_camera else ZED
    chosen = {ALL: list(FIELDS), NONE: []}.get(names, names.split(","))
    for name in chosen:
        if name not in FIELDS:
            known = (ALL, NONE, *FIELDS)
            raise ConfigError(
                notice("option.choice", option="--camera-errors", known=known, value=name)
            )
    fields = [FIELDS[name] for name in chosen]
    return replace(IDEAL, **{field: getattr(real, field) for field in fields})
