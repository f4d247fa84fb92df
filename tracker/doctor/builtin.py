"""The program's own checks, as pyproject.toml declares them; imports happen when they run."""

from __future__ import annotations

from tracker.base.registry import deferred
from tracker.doctor.finding import Check

SYSTEM = Check("system", "System", deferred("tracker.doctor.computer:system"), 10)
PROCESSOR = Check("processor", "Processor", deferred("tracker.doctor.computer:processor"), 20)
DISK = Check("disk", "Disk", deferred("tracker.doctor.computer:disk"), 30)
GRAPHICS = Check("graphics", "Graphics card", deferred("tracker.doctor.computer:graphics"), 40)
PERMISSIONS = Check(
    "permissions", "Permissions", deferred("tracker.doctor.permissions:permissions"), 60
)
GLOVES = Check("gloves", "Gloves", deferred("tracker.doctor.gloves:gloves"), 70)
CAMERAS = Check("cameras", "Cameras", deferred("tracker.doctor.cameras:cameras"), 80)
