"""Each application, used from beginning to end by a simulated wearer, separately."""

from __future__ import annotations

import pytest

from extensions.applications.tests.hands import datas, outcomes, words
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.simulation.shows import SHOWS, show_keys, shown_application

REPORTED = {
    "touch": ["placed", "touch", "release"],
    "arm": ["placed", "clutch", "grab", "lifted", "stop", "go_on"],
    "swarm": ["placed", "nudge", "dragged", "stretched", "wall", "split", "cleared", "merge"],
    "place": ["placed", "point", "choose", "touch", "moved", "scaled", "faded", "back"],
}


@pytest.mark.parametrize("name", SHOWS)
def test_a_show_does_what_its_application_is_for(name: str) -> None:
    reported = words(outcomes(name, show_keys(f"show:{name}")))
    at = -1
    for word in REPORTED[name]:
        assert word in reported[at + 1 :], (word, reported)
        at = reported.index(word, at + 1)


def test_a_show_that_there_is_not_is_refused_in_words() -> None:
    with raises(ConfigError, "simulate.unknown_show", name="show:juggling"):
        show_keys("show:juggling")


@pytest.mark.parametrize("name", SHOWS)
def test_a_show_takes_its_application_to_be_where_that_puts_itself_before_the_first_hand(
    name: str,
) -> None:
    """So it may begin at any time: in a window it does when somebody chooses it."""
    found = outcomes(name, show_keys(name)[:2])
    application, settings = shown_application(f"show:{name}")
    assert application == name
    assert datas(found, "placed")[0]["at"] == pytest.approx(settings["place"], abs=0.01)


def test_each_label_of_the_place_is_pointed_at_and_opened() -> None:
    reported = outcomes("place", show_keys("place"), **shown_application("show:place")[1])
    assert [e["label"] for e in datas(reported, "choose")] == [
        "Church",
        "Gate tower",
        "Round tower",
    ]


def test_other_motions_use_no_application() -> None:
    assert shown_application("recorded.bvh") == shown_application("") == ("", {})
