"""Resources opened and closed in jobs: in order, once, and never left open."""

import threading
from functools import partial

import pytest

from app.jobs.openings import Openings
from app.platform.tasks import TaskOwner
from tracker.base.errors import GlovetrackError


class Port:
    """Only one may be open, as with a server's port."""

    def __init__(self, log: list[str], name: str) -> None:
        if log and log[-1].startswith("opened"):
            raise GlovetrackError(f"{name} finds the port taken")
        self._log, self._name = log, name
        log.append(f"opened {name}")

    def close(self) -> None:
        self._log.append(f"closed {self._name}")


@pytest.fixture
def tasks(qtbot):
    owner = TaskOwner()
    yield owner
    owner.shut_down()


@pytest.fixture
def openings(tasks):
    return Openings(tasks, lambda: None)


def test_a_resource_is_closed_before_it_is_opened_again(openings, qtbot):
    log = []
    openings.renew("a", "a", lambda: Port(log, "first"), lambda port: True)
    qtbot.waitUntil(lambda: openings.get("a") is not None)
    openings.renew("a", "a", lambda: Port(log, "second"), lambda port: True)
    qtbot.waitUntil(lambda: openings.get("a") is not None)
    assert log == ["opened first", "closed first", "opened second"]
    assert openings.problems == {}
    openings.close("a", "a")
    qtbot.waitUntil(lambda: log[-1] == "closed second")
    assert openings.get("a") is None


def test_a_resource_no_longer_needed_is_closed_after_opening(openings, qtbot):
    log, begun, go = [], threading.Event(), threading.Event()

    def slowly() -> Port:
        begun.set()
        go.wait(60.0)
        return Port(log, "slow")

    openings.renew("a", "a", slowly, lambda port: True)
    assert begun.wait(60.0)
    openings.close("a", "a")
    go.set()
    qtbot.waitUntil(lambda: log == ["opened slow", "closed slow"])
    openings.renew("a", "a", lambda: Port(log, "refused"), lambda port: False)
    qtbot.waitUntil(lambda: log[2:] == ["opened refused", "closed refused"])
    assert openings.get("a") is None


def test_requests_in_quick_succession_leave_the_last_one_open(openings, qtbot):
    """Each job has a thread of its own; whichever runs first, no two resources are open at once."""
    log: list[str] = []
    go = threading.Event()

    def made(k: int) -> Port:
        go.wait(60.0)
        return Port(log, str(k))

    openings.renew("a", "a", lambda: Port(log, "first"), lambda port: True)
    qtbot.waitUntil(lambda: openings.get("a") is not None)
    for k in range(6):
        openings.renew("a", "a", partial(made, k), lambda port: True)
    go.set()
    qtbot.waitUntil(lambda: openings.get("a") is not None and log[-1] == "opened 5")
    qtbot.wait(100)  # nothing follows
    assert openings.problems == {} and log[-1] == "opened 5"
    assert [line.split()[0] for line in log[::2]] == ["opened"] * (len(log) // 2 + 1)
    openings.close("a", "a")
    qtbot.waitUntil(lambda: log[-1] == "closed 5")


def test_a_failure_is_reported_and_the_end_leaves_nothing_open(openings, tasks, qtbot):
    log = []
    openings.renew("a", "a", lambda: Port(log, "a"), lambda port: True)
    qtbot.waitUntil(lambda: openings.get("a") is not None)
    openings.renew("b", "b", lambda: Port(log, "b"), lambda port: True)
    qtbot.waitUntil(lambda: "b" in openings.problems)
    assert "taken" in openings.problems["b"]
    tasks.shut_down()
    openings.shut_down()
    assert log == ["opened a", "closed a"]
