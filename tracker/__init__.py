"""The Glovetrack engine: glove bytes and camera pixels in, a tracked hand out.

Conventions, the same in every module
-------------------------------------
Units
    SI and radians. A value in any other unit says so in its name (``_deg``, ``_mm``, ``_px``).
Time
    ``t`` is seconds on the host's monotonic clock, a whole number of nanoseconds (`tracker.clock`).
Arrays
    Rows are samples: N points are (N, 3).
Pixels
    (u, v); the centre of the top-left pixel is (0, 0).
Frames
    G global (z up), C left rectified camera (x right, y down, z forward), B a hand segment (origin
    at its proximal joint, x to the tip, z dorsal, y = z × x the flexion axis), I an IMU's own axes.
Names
    ``R_GB`` maps B to G, ``p_GB`` is B's origin in G; neighbours cancel:
    ``p_G = R_GB @ p_B + p_GB``.
Quaternions
    Hamilton, unit, stored x, y, z, w.
Rotation errors
    Local: ``R_true = R_est @ Exp(dtheta)``.
Joints
    ``R_parentB = R_rest @ Rz(abduction) @ Ry(flexion) @ Rx(twist)``.

Threads and clocks
    Those that start threads or read clocks are few, and listed in ``tests/test_project.py``. No
    filter does either: the same messages in the same order give the same states.

What other programs need is here by name, imported when it is first asked for::

    from tracker import Pipeline, SessionReader, load
    hand, glove = load("vist-small")
"""

import os
from importlib import import_module
from typing import Any

# Two BLAS threads make small products up to a hundred times slower on a loaded machine, so the
# pool is held to one thread. It has to be said before numpy is first imported.
for _name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

__version__ = "0.1.0"
GRAVITY = 9.80665
"""Standard gravity, m/s²."""

_FACE = {
    "pipeline": ("Pipeline",),
    "settings": ("ENGINES", "Settings"),
    "config": ("from_toml", "to_toml"),
    "library": ("load",),
    "live.runner": ("LiveTracker",),
    "offline.track": ("track",),
    "offline.options": ("TrackOptions",),
    "session.reader": ("SessionReader",),
    "session.writer": ("SessionRecorder",),
    "session.export.run": ("export",),
    "session.export.options": ("ExportOptions",),
    "streaming.attach": ("attach",),
    "streaming.params": ("StreamParams", "open_publishers"),
    "errors": ("ConfigError", "DeviceError", "FileError", "GlovetrackError"),
    "messages": (
        *("BlobFrame", "Blobs", "Calibration", "CameraImuSample", "CameraPose", "Estimate"),
        *("Event", "FrameResult", "ImuSample", "Status", "StereoFrame", "Tracking", "Validity"),
    ),
}
_HOME = {name: module for module, names in _FACE.items() for name in names}

__all__ = ["GRAVITY", "__version__", *sorted(_HOME)]


def __getattr__(name: str) -> Any:
    """The public face, which would take a second to import whole."""
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
