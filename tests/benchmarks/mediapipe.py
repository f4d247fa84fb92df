"""MediaPipe Hands as a peer: in its own environment, as a process that takes turns with ours."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import NDArray

import tracker

WORKER = Path(__file__).with_name("mediapipe_worker.py")
NAME = "two MediaPipe Hands calls"


class PeerAbsentError(Exception):
    """The peer cannot run here; the message gives the reason."""


def interpreter() -> Path:
    """Python of the peers' environment: ``GLOVETRACK_PEERS`` or what ``make bench-peers`` built.

    Raises PeerAbsentError.
    """
    folder = Path(tracker.__file__).parents[1] / "build" / "peers"
    folder = Path(os.environ.get("GLOVETRACK_PEERS", folder))
    python = folder / "bin" / "python"
    if not python.exists():
        raise PeerAbsentError(f"{folder} is not there; make bench-peers makes it")
    return python


class HandsPeer:
    """Searches the pairs (n, 2, h, w, 3) at each call and keeps the processor's seconds a pair."""

    def __init__(self, pairs: NDArray[np.uint8]) -> None:
        """Raises PeerAbsentError."""
        self._seconds: list[float] = []
        self.found_share = 0.0
        python = interpreter()
        self._folder = tempfile.TemporaryDirectory()
        images = Path(self._folder.name) / "pairs.npy"
        np.save(images, pairs)
        log = images.with_name("stderr.txt")
        with log.open("wb") as complaints:
            self._process = subprocess.Popen(
                [str(python), str(WORKER), str(images)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=complaints,
                text=True,
            )
        if self._line() != "ready":
            last = log.read_text(errors="replace").strip().rpartition("\n")[2]
            self.close()
            raise PeerAbsentError(f"mediapipe does not start there: {last or 'not a word'}")

    def _line(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline().strip()

    def __call__(self) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write("\n")
        self._process.stdin.flush()
        answer = json.loads(self._line())
        self._seconds.append(answer["pair_s"])
        self.found_share = answer["found"] / answer["of"]

    @property
    def pair_s(self) -> float:
        """Median seconds a pair; the first call, which may set things up, is not counted."""
        return float(np.median(self._seconds[1:]))

    def close(self) -> None:
        """End the process."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()
        self._folder.cleanup()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
