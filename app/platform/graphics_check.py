"""Reports the renderer of the 3D view to ``glovetrack doctor``."""

from __future__ import annotations

from tracker.base.registry import deferred
from tracker.doctor.finding import Check

OPENGL = Check("opengl", "Graphics card", deferred("app.platform.graphics:opengl_check"), 45)
