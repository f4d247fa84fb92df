"""Channels between threads: two bounded queues and a slot for one value.

A lost IMU sample is a lost part of an integral, so samples go through `Fifo`, which reports each
loss. A skipped image is only old, so images go through `Latest`. A client wants every estimate but
no old ones, so estimates go through `Backlog`.
"""

from __future__ import annotations

import threading
from collections import deque
from typing import Generic, TypeVar

T = TypeVar("T")


class Closed(Exception):
    """The channel was closed and is empty."""


class Latest(Generic[T]):
    """A slot for one value: a new one replaces one that was not read; ``dropped`` counts those."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._value: T | None = None
        self._full = False
        self._closed = False
        self._dropped = 0

    @property
    def dropped(self) -> int:
        """How many values were replaced before anyone fetched them."""
        with self._changed:
            return self._dropped

    def put(self, value: T) -> bool:
        """Leave a value; False where the channel is closed. Never waits."""
        with self._changed:
            if self._closed:
                return False
            self._dropped += self._full
            self._value, self._full = value, True
            self._changed.notify()
            return True

    def get(self, timeout: float | None = 0.0) -> T | None:
        """Removes and returns the value; None if there is none within ``timeout`` s (None: no
        limit).

        Raises Closed once the channel is closed and empty.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._full or self._closed, timeout)
            if not self._full:
                if self._closed:
                    raise Closed
                return None
            value, self._value, self._full = self._value, None, False
            return value

    def close(self) -> None:
        """Refuse new values and wake whoever waits."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()


class Fifo(Generic[T]):
    """A queue of at most ``size`` values. A value that finds it full is refused and counted."""

    def __init__(self, size: int) -> None:
        if size < 1:
            raise ValueError("the size of a Fifo must be at least 1")
        self._size = size
        self._changed = threading.Condition()
        self._values: deque[T] = deque()
        self._closed = False
        self._overflowed = 0

    def __len__(self) -> int:
        with self._changed:
            return len(self._values)

    @property
    def overflowed(self) -> int:
        """How many values were refused because the queue was full."""
        with self._changed:
            return self._overflowed

    @property
    def fill(self) -> float:
        """How full the queue is, 0..1."""
        return len(self) / self._size

    def put(self, value: T, timeout: float = 0.0) -> bool:
        """Append; False if it stays full for ``timeout`` s (which counts) or is closed."""
        with self._changed:
            self._changed.wait_for(lambda: len(self._values) < self._size or self._closed, timeout)
            if self._closed:
                return False
            if len(self._values) >= self._size:
                self._overflowed += 1
                return False
            self._values.append(value)
            self._changed.notify_all()
            return True

    def get(self, timeout: float | None = 0.0) -> T | None:
        """Returns the oldest value; None if there is none within ``timeout`` s (None: no limit).

        Raises Closed once the channel is closed and empty.
        """
        with self._changed:
            self._changed.wait_for(lambda: bool(self._values) or self._closed, timeout)
            if not self._values:
                if self._closed:
                    raise Closed
                return None
            value = self._values.popleft()
            self._changed.notify_all()
            return value

    def drain(self) -> list[T]:
        """Everything that waits, oldest first."""
        with self._changed:
            values = list(self._values)
            self._values.clear()
            self._changed.notify_all()
            return values

    def close(self) -> None:
        """Refuses new values and wakes waiting threads; values in the channel can still be read."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()


class Backlog(Generic[T]):
    """A queue of the ``size`` newest values: a full one discards its oldest and counts it."""

    def __init__(self, size: int) -> None:
        if size < 1:
            raise ValueError("the size of a Backlog must be at least 1")
        self._changed = threading.Condition()
        self._values: deque[T] = deque(maxlen=size)
        self._closed = False
        self._dropped = 0

    @property
    def dropped(self) -> int:
        """How many values were discarded because the queue was full."""
        with self._changed:
            return self._dropped

    def put(self, value: T) -> bool:
        """Append; False where the channel is closed. Never waits."""
        with self._changed:
            if self._closed:
                return False
            self._dropped += len(self._values) == self._values.maxlen
            self._values.append(value)
            self._changed.notify()
            return True

    def get(self, timeout: float | None = 0.0) -> T | None:
        """Returns the oldest value; None if there is none within ``timeout`` s (None: no limit).

        Raises Closed once the channel is closed and empty.
        """
        with self._changed:
            self._changed.wait_for(lambda: bool(self._values) or self._closed, timeout)
            if self._values:
                return self._values.popleft()
            if self._closed:
                raise Closed
            return None

    def close(self) -> None:
        """Refuse new values and wake whoever waits; queued values can still be fetched."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()
