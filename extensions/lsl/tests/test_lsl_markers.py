"""LSL markers of other programs become requests for notes with the markers' times."""

from __future__ import annotations

import threading
from concurrent.futures import Future

import pytest

try:
    import pylsl
except (ImportError, RuntimeError) as error:  # RuntimeError: liblsl is missing
    pytest.skip(f"pylsl is not usable: {error}", allow_module_level=True)

from extensions.lsl.markers import MarkerDoor
from tests.notices import raises
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.streaming.connection import ConnectionSettings
from tracker.streaming.remote.registry import DOORS, open_door, with_doors
from tracker.streaming.remote.request import Reply, Request


class Taken:
    """A handler that stores requests."""

    def __init__(self) -> None:
        self.requests: list[Request] = []

    def answer(self, request: Request) -> Future[Reply]:
        self.requests.append(request)
        out: Future[Reply] = Future()
        out.set_result(Reply(True, request.do, "Noted."))
        return out


@pytest.fixture
def outlet() -> pylsl.StreamOutlet:
    """Another program's markers: a word and a number."""
    info = pylsl.StreamInfo("Stimuli", "Markers", 2, pylsl.IRREGULAR_RATE, "string", "lab-7")
    return pylsl.StreamOutlet(info)


def test_a_marker_is_a_note_at_its_own_instant(outlet: pylsl.StreamOutlet, wait_for) -> None:
    taken, kind = Taken(), DOORS.get("lsl")
    door = open_door(kind, with_doors(ConnectionSettings(), "lsl").options(kind), taken.answer)
    try:
        if not outlet.wait_for_consumers(10):
            pytest.skip("LSL finds nothing here: this machine passes no multicast")
        ago = 0.25  # s: it was pushed late, as programs do
        before = monotonic() - ago
        stamp = pylsl.local_clock() - ago
        after = monotonic() - ago
        outlet.push_sample(["go\n", "7"], stamp)
        deadline = monotonic() + 60
        while not taken.requests and monotonic() < deadline:
            threading.Event().wait(0.01)
        (request,) = taken.requests
        assert request.do == "note" and request.text == "go 7"
        assert before - 0.005 < request.t < after + 0.005
        source = request.data["lsl"]
        assert isinstance(source, dict)
        assert (source["stream"], source["source"]) == ("Stimuli", "lab-7")
        assert source["stamp"] == stamp and abs(source["clock_offset_s"]) < 0.005
        counts = door.counts()
        assert (counts.asked, counts.refused, counts.clients) == (1, 0, 1)
        pushed = 1
        while door.counts().refused <= 50:  # what floods is bounded
            assert pushed < 10_000, "also on a computer that sends only a few at a time"
            for k in range(300):
                outlet.push_sample(["flood", str(k)])
            pushed += 300
            wait_for(lambda n=pushed: door.counts().asked + door.counts().refused == n)
    finally:
        door.close()
    assert not [t for t in threading.enumerate() if t.name == "glovetrack-remote-lsl"]


def test_a_stream_that_ends_is_forgotten() -> None:
    taken = Taken()
    door = MarkerDoor(taken.answer)
    try:
        info = pylsl.StreamInfo("Short", "Markers", 1, pylsl.IRREGULAR_RATE, "int32", "lab-8")
        short = pylsl.StreamOutlet(info)
        if not short.wait_for_consumers(10):
            pytest.skip("LSL finds nothing here: this machine passes no multicast")
        short.push_sample([5])
        deadline = monotonic() + 60
        while not taken.requests and monotonic() < deadline:
            threading.Event().wait(0.01)
        assert [r.text for r in taken.requests] == ["5"]
        del short
        deadline = monotonic() + 60  # LSL continues to announce it for a while
        while door.counts().clients and monotonic() < deadline:
            threading.Event().wait(0.05)
        assert door.counts().clients == 0
    finally:
        door.close()


def test_markers_have_no_port() -> None:
    with raises(ConfigError, "stream.no_port"):
        with_doors(ConnectionSettings(), "lsl:9000")
