"""What can be asked of tracking a session again. Quick to import."""

from __future__ import annotations

from dataclasses import dataclass

USUAL = "usual"  # in place of a settings file: those of this version


@dataclass(frozen=True)
class TrackOptions:
    """Names or paths; empty takes what the session holds."""

    engine: str = ""
    hand: str = ""
    glove: str = ""
    colours: str = ""
    with_sensors: bool = False
    settings: str = ""  # path of a TOML file of `tracker.engine.settings.Settings`, or `USUAL`
    smooth: bool = False  # estimates that know the whole session
    guided: bool = True  # learn from guided poses that the session holds
    wearer: str = ""  # path of a wearer's profile
    keep_wearer: str = ""  # path of the profile to be written of what was learned
    hand_length: float = 0.0  # m, of the wearer by a ruler; 0 where it is not known
    lenses: str = ""  # left or right: track with that one alone
