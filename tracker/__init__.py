"""The Glovetrack engine: glove bytes and camera pixels in, a tracked hand out.

Conventions, the same in every module
-------------------------------------
Units
    SI and radians. A value in any other unit has the unit in its name (``_deg``, ``_mm``, ``_px``).
Time
    ``t`` is seconds on the host's monotonic clock, a whole number of nanoseconds
    (`tracker.base.clock`).
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

Other programs import `glovetrack`, which is stable; what is here is internal.
"""

__version__ = "0.2.0"
CONTINUED = ("0.1.0",)
"""Earlier versions whose recorded states this version continues from: its records still read them.
Add a version when the next one is given its number, and remove those that cannot be continued."""
GRAVITY = 9.80665
"""Standard gravity, m/s²."""
