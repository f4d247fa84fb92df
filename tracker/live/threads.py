"""Threads that repeat a step until they are stopped; one that fails says so and ends alone."""

from __future__ import annotations

import threading
from collections.abc import Callable

from tracker.channels import Closed
from tracker.errors import GlovetrackError
from tracker.urgency import run_soon


class ThreadGroup:
    """``say`` gets a kind and a sentence when a thread fails. Methods are for one owner.

    ``turn`` is called with a thread's name before each of its steps, in that thread: whoever gives
    it may hold threads back, as a busy computer does.
    """

    def __init__(
        self, say: Callable[[str, str], None], turn: Callable[[str], None] = lambda name: None
    ) -> None:
        self._say, self._turn = say, turn
        self._stopping = threading.Event()
        self._threads: list[threading.Thread] = []

    @property
    def stopping(self) -> bool:
        """Whether the threads were told to end."""
        return self._stopping.is_set()

    def start(self, name: str, step: Callable[[], None], soon: bool = False) -> None:
        """Repeat ``step``, which waits for its work a moment at most, in a thread of this name;
        ``soon``: its work is short and cannot wait."""
        thread = threading.Thread(
            target=self._run, args=(name, step, soon), name=f"glovetrack-{name}", daemon=True
        )
        self._threads.append(thread)
        thread.start()

    def tell_to_stop(self) -> None:
        """No further step begins."""
        self._stopping.set()

    def join(self) -> None:
        """Wait for the last steps. May be called again."""
        for thread in self._threads:
            thread.join()
        self._threads.clear()

    def _run(self, name: str, step: Callable[[], None], soon: bool) -> None:
        if soon:
            run_soon()
        try:
            while not self._stopping.is_set():
                self._turn(name)
                step()
        except Closed:
            return
        except GlovetrackError as error:
            self._say("error", str(error))
        except Exception as error:  # noqa: BLE001 - the last line of defence of a thread
            self._say("error", f"The {name} thread failed: {type(error).__name__}: {error}.")
