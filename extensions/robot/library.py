"""Whether MuJoCo is there, and where the robot hands are that come with packages."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from tracker.base.errors import ConfigError

EXTRA = 'pip install "glovetrack[robot]"'
SHADOW = "shadow"
MODELS = {SHADOW: ("gymnasium_robotics", "envs/assets/hand/reach.xml")}
"""Hands by name: the package that has each and its MJCF in there (Shadow hand, Apache-2.0)."""


def is_there() -> bool:
    """Whether the extra ``robot`` is installed."""
    return find_spec("mujoco") is not None


def need_mujoco() -> None:
    """Raises ConfigError in words where MuJoCo is not installed."""
    if not is_there():
        raise ConfigError(
            f"A robot hand needs MuJoCo, an extra that is not installed. Run: {EXTRA}"
        )


def model_path(name: str) -> Path:
    """The MJCF of a hand: one of `MODELS`, or a path. Raises ConfigError in words."""
    if name not in MODELS:
        path = Path(name).expanduser()
        if not path.is_file():
            known = ", ".join(MODELS)
            raise ConfigError(f"There is no robot hand {name}: it is {known} or a file of MJCF.")
        return path
    package, inside = MODELS[name]
    found = find_spec(package)
    if found is None or not found.submodule_search_locations:
        raise ConfigError(f"The robot hand {name} comes with an extra. Run: {EXTRA}")
    return Path(next(iter(found.submodule_search_locations)), inside)
