"""Results that several outputs need of the same estimate, computed once.

Outputs number estimates separately, so that each has a copy of its own. Copies share their arrays,
by which they are recognized.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import Generic, NamedTuple, Protocol, TypeVar

from tracker.gestures.recogniser import GestureRecogniser
from tracker.hand.model import HandModel
from tracker.messages import Estimate

Result = TypeVar("Result")
KEPT = 64  # estimates; more than wait in an output's queue
LATE = 1.0  # s; an estimate that is earlier than the newest one by more is of another recording


class RecentResults(Generic[Result]):
    """The results for the last estimates; may be used from several threads."""

    def __init__(self, kept: int = KEPT) -> None:
        self._kept = kept
        self._recent: tuple[tuple[Estimate, object, Result], ...] = ()  # replaced, newest first

    def find(self, e: Estimate, key: object = None) -> Result | None:
        """The result for this estimate or a copy of it; None if it was not computed or is too
        old."""
        for of, other, result in self._recent:
            if is_copy(e, of) and other == key:
                return result
        return None

    def put(self, e: Estimate, result: Result, key: object = None) -> None:
        self._recent = ((e, key, result), *self._recent[: self._kept - 1])

    def before(self, t: float) -> Result | None:
        """The newest result for an estimate before ``t`` (s)."""
        return next((result for of, _, result in self._recent if of.t <= t), None)

    def get(self, e: Estimate, key: object, compute: Callable[[], Result]) -> Result:
        """The result of ``compute``, which two threads may call at the same time."""
        found = self.find(e, key)
        if found is None:
            found = compute()
            self.put(e, found, key)
        return found


def is_copy(one: Estimate, other: Estimate) -> bool:
    """Whether both have the same arrays of keypoints and the same instant."""
    return (
        one.keypoints is other.keypoints
        and one.keypoint_q is other.keypoint_q
        and one.keypoint_state is other.keypoint_state
        and one.t == other.t
    )


class Gestures(Protocol):
    """What an output needs of a `GestureRecogniser`."""

    def feed(self, estimate: Estimate) -> Sequence[object]: ...
    @property
    def active(self) -> tuple[str, ...]: ...
    @property
    def values(self) -> dict[str, float]: ...
    @property
    def confidences(self) -> dict[str, float]: ...


class _Found(NamedTuple):
    """The properties of `GestureRecogniser` after an estimate."""

    active: tuple[str, ...]
    values: dict[str, float]
    confidences: dict[str, float]


class SharedGestures:
    """The gestures of one hand for outputs that process its estimates at different times.

    Estimates are recognized in the order in which the first output processes them. An output that
    is late gets what was found then; for an estimate that no output had processed in time, what was
    found for the one before it.
    """

    def __init__(self, hand: HandModel, keypoint_names: tuple[str, ...]) -> None:
        self._recogniser = GestureRecogniser(hand, keypoint_names)
        self._lock = threading.Lock()
        self._recent: RecentResults[_Found] = RecentResults()
        self._newest = float("-inf")

    def of(self, e: Estimate) -> _Found:
        with self._lock:
            found = self._recent.find(e)
            if found is None and self._newest - LATE < e.t < self._newest:
                found = self._recent.before(e.t)
            if found is None:
                self._recogniser.feed(e)
                r, self._newest = self._recogniser, e.t
                found = _Found(r.active, r.values, r.confidences)
                self._recent.put(e, found)
        return found


class OutputGestures:
    """The gestures of the estimate with which one output was fed last."""

    def __init__(self, shared: SharedGestures) -> None:
        self._shared = shared
        self._found = _Found((), {}, {})

    def feed(self, estimate: Estimate) -> Sequence[object]:
        self._found = self._shared.of(estimate)
        return ()

    @property
    def active(self) -> tuple[str, ...]:
        return self._found.active

    @property
    def values(self) -> dict[str, float]:
        return self._found.values

    @property
    def confidences(self) -> dict[str, float]:
        return self._found.confidences
