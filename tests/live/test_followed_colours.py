"""Colours learned during live tracking: applied, reported and recorded; the user has priority."""

from __future__ import annotations

import dataclasses
from types import SimpleNamespace
from typing import Any

import pytest

from tracker.base.channels import Closed
from tracker.glove import library
from tracker.live.colours import KIND, FollowedColours
from tracker.live.journal import Journal
from tracker.messages import BlobFrame, FrameResult, StereoFrame, Tracking
from tracker.vision.colours import ColourProfile, parse_profile

FACTORY = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
WARM = ColourProfile("warm", FACTORY.hues[:2])
USERS = ColourProfile("the user's", FACTORY.hues[1:])
USED = (
    StereoFrame(10.0, 10.0, None, None),
    BlobFrame(10.0, 10.0, FACTORY.hue_names, None, None),
    FrameResult.nothing(10.0, Tracking.TRACKING, 1),
)


class Scripted:
    """A follower that returns ``answer`` on request."""

    def __init__(self, answer: ColourProfile | None) -> None:
        self.profile, self.answer = FACTORY, answer
        self.while_learning = lambda: None

    def take(self, profile: ColourProfile) -> None:
        self.profile = profile

    def is_due(self, t: float) -> bool:
        return True

    def look(self, *_: object) -> ColourProfile | None:
        self.while_learning()
        if self.answer is not None:
            self.profile = self.answer
        return self.answer


def made(answer: ColourProfile | None) -> tuple[FollowedColours, Any, Scripted, Journal]:
    follower, vision = Scripted(answer), SimpleNamespace(profile=FACTORY)
    journal = Journal(lambda: 0.0)
    return FollowedColours(follower, vision, journal), vision, follower, journal  # type: ignore[arg-type]


def test_learned_colours_are_applied_and_recorded() -> None:
    colours, vision, _, journal = made(WARM)
    colours.used.put(USED)
    colours.step()
    assert vision.profile is WARM
    (event,) = journal.drain_events()
    assert (event.kind, event.t) == (KIND, 10.0)
    assert parse_profile(str(event.data["colours"])).hues == WARM.hues


def test_the_users_colours_have_priority() -> None:
    colours, vision, follower, journal = made(WARM)

    def change() -> None:
        vision.profile = USERS

    follower.while_learning = change
    colours.used.put(USED)
    colours.step()
    assert vision.profile is USERS
    assert journal.drain_events() == []
    follower.answer = None
    colours.used.put(USED)
    colours.step()
    assert follower.profile is USERS  # these are followed from now on


class StoringRecorder:
    """A recorder that stores what it receives."""

    def __init__(self) -> None:
        self.messages: list[Any] = []

    def write(self, message: Any, overloaded: bool = False, side: str = "") -> bool:
        self.messages.append(message)
        return True

    def flush(self) -> None: ...

    def close(self) -> None: ...


def used_at(t: float) -> Any:
    return dataclasses.replace(USED[0], t=t), *USED[1:]


def test_colours_set_by_a_user_are_recorded_once_they_are_final() -> None:
    """A slider passes through many values; none of them is written to the user's log."""
    colours, vision, _, journal = made(None)
    recorder = StoringRecorder()
    journal.open(recorder)
    passed = dataclasses.replace(USERS, name="on the way")
    for t, profile in (
        (10.0, FACTORY),
        (10.1, passed),
        (10.2, USERS),
        (10.6, USERS),
        (10.8, USERS),
    ):
        vision.profile = profile
        colours.used.put(used_at(t))
        colours.step()
    colours.used.put(used_at(12.0))
    colours.step()
    disk = journal.detach()
    assert disk is not None
    disk.finish()
    (event,) = recorder.messages
    assert (event.kind, event.t, event.text) == (KIND, pytest.approx(10.2), "")
    assert parse_profile(str(event.data["colours"])).hues == USERS.hues
    assert KIND not in [journalled.kind for journalled in journal.drain_events()]


def test_it_stops_without_images() -> None:
    colours, *_ = made(None)
    colours.used.close()
    with pytest.raises(Closed):
        colours.step()
