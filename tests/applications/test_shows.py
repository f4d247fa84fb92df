"""Each application used from beginning to end by a simulated wearer, where it stands by itself."""

from __future__ import annotations

import pytest

from tests.applications.hands import outcomes, words
from tracker.errors import ConfigError
from tracker.simulation.scripted import SHOWS, show_keys

TOLD = {
    "touch": ["placed", "touch", "release"],
    "arm": ["placed", "clutch", "grab", "lifted", "stop", "go_on"],
    "swarm": ["placed", "nudge", "dragged", "split", "merge"],
    "place": ["placed", "point", "choose", "touch", "moved", "faded", "back"],
}


@pytest.mark.parametrize("name", SHOWS)
def test_a_show_does_what_its_application_is_for(name: str) -> None:
    told = words(outcomes(name, show_keys(f"show:{name}")))
    at = -1
    for word in TOLD[name]:
        assert word in told[at + 1 :], (word, told)
        at = told.index(word, at + 1)


def test_a_show_that_there_is_not_is_refused_in_words() -> None:
    with pytest.raises(ConfigError, match="no show 'show:juggling'; there are touch"):
        show_keys("show:juggling")
