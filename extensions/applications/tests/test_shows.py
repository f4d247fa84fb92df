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


@pytest.mark.long
@pytest.mark.parametrize("name", SHOWS)
def test_a_show_completes_its_application(name: str) -> None:
    reported = words(outcomes(name, show_keys(f"show:{name}")))
    at = -1
    for word in REPORTED[name]:
        assert word in reported[at + 1 :], (word, reported)
        at = reported.index(word, at + 1)


def test_an_unknown_show_is_refused() -> None:
    with raises(ConfigError, "simulate.unknown_show", name="show:juggling"):
        show_keys("show:juggling")


@pytest.mark.parametrize("name", SHOWS)
def test_a_show_expects_its_application_at_its_default_position(
    name: str,
) -> None:
    """So it may begin at any time: in a window, when the user selects it."""
    found = outcomes(name, show_keys(name)[:2])
    application, settings = shown_application(f"show:{name}")
    assert application == name
    assert datas(found, "placed")[0]["at"] == pytest.approx(settings["place"], abs=0.01)


@pytest.mark.long
def test_each_label_of_the_place_is_pointed_at_and_opened() -> None:
    reported = outcomes("place", show_keys("place"), **shown_application("show:place")[1])
    assert [e["label"] for e in datas(reported, "choose")] == [
        "Church",
        "Gate tower",
        "Round tower",
    ]


def test_other_motions_use_no_application() -> None:
    assert shown_application("recorded.bvh") == shown_application("") == ("", {})
