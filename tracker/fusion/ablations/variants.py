"""Simpler fusion variants for comparison with the default (the papers' ablations).

``guide``: markers are searched for where the IMUs predict them ("imu"), or where they were in the
previous image ("previous"), which fails in movie S1 of Lee et al. 2021. ``coupling``: every marker
corrects the filter ("tight"), or the markers of a segment are first reduced to a segment pose by
vision alone, which then corrects the filter ("loose").
"""

from __future__ import annotations

from tracker.base.errors import ConfigError
from tracker.base.notices import notice

GUIDES = ("imu", "previous")
COUPLINGS = ("tight", "loose")


def check_variant(guide: str, coupling: str) -> None:
    """Raises ConfigError for an unknown ``guide`` or ``coupling``."""
    for what, word, known in (("guide", guide, GUIDES), ("coupling", coupling, COUPLINGS)):
        if word not in known:
            raise ConfigError(notice("option.choice", option=what, known=known, value=word))
