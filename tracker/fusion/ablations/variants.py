"""Poorer ways of fusing, kept to be measured against the usual ones (the papers' ablations).

``guide``: markers are looked for where the IMUs say that they are ("imu"), or where they were in
the last image ("previous"), which movie S1 of Lee et al. 2021 shows to fail.
``coupling``: every marker corrects the filter ("tight"), or a segment's markers first become a
pose of the segment by vision alone, which then corrects it ("loose").
"""

from __future__ import annotations

from tracker.base.errors import ConfigError

GUIDES = ("imu", "previous")
COUPLINGS = ("tight", "loose")


def check_variant(guide: str, coupling: str) -> None:
    """Raises ConfigError for a word that means nothing."""
    for what, word, known in (("guide", guide, GUIDES), ("coupling", coupling, COUPLINGS)):
        if word not in known:
            raise ConfigError(f"The setting {what} can be {' or '.join(known)}, not {word!r}.")
