"""Availability of MuJoCo, and the robot hands that installed packages provide."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from tracker.base.errors import ConfigError
from tracker.base.notices import notice

EXTRA = 'pip install "glovetrack[robot]"'
SHADOW = "shadow"
MODELS = {SHADOW: ("gymnasium_robotics", "envs/assets/hand/reach.xml")}
"""Hands by name: package and path of the MJCF file in it (Shadow hand, Apache-2.0)."""


def is_there() -> bool:
    """Whether the extra ``robot`` is installed."""
    return find_spec("mujoco") is not None


def need_mujoco() -> None:
    """Raises ConfigError if MuJoCo is not installed."""
    if not is_there():
        raise ConfigError(notice("robot.needs_mujoco", install=EXTRA))


def model_path(name: str) -> Path:
    """Path of a hand's MJCF file; ``name`` is one of `MODELS` or a path. Raises ConfigError."""
    if name not in MODELS:
        path = Path(name).expanduser()
        if not path.is_file():
            known = ", ".join(MODELS)
            raise ConfigError(notice("robot.unknown_hand", name=name, known=known))
        return path
    package, inside = MODELS[name]
    found = find_spec(package)
    if found is None or not found.submodule_search_locations:
        raise ConfigError(notice("robot.hand_extra", name=name, install=EXTRA))
    return Path(next(iter(found.submodule_search_locations)), inside)
