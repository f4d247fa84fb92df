"""Recordings that the application itself writes: its window on simulated devices, off-screen,
started and stopped by remote control as a user's script does.

They begin in the middle of tracking. Each kind is made once for all tests of a run, whichever of
pytest's processes asks first; tests read it and write nothing beside it.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

from tracker.base.errors import GlovetrackError
from tracker.session.recover import needs_recovery
from tracker.streaming.remote.client import ask

ROOT = Path(__file__).parents[1]
WATCHED, RECORDED = 1.0, 3.0  # s before a recording begins, and of it
START_TIMEOUT, STEP_TIMEOUT = 240.0, 60.0  # s on a busy computer
ATTEMPT = 2.0  # s for an answer while the window starts

KINDS: dict[str, tuple[str, ...]] = {
    "one hand": ("--scene", "plain"),
    "both hands": ("--scene", "plain", "--hands", "both"),
    "one camera over a desk": ("--scene", "desk", "--lenses", "one"),
    "no camera": ("--lenses", "none"),
}
"""What each is a recording of, and the demo's options for it."""


class LiveRecordings:
    """Recordings in ``folder``, which all of a test run's processes share."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def path(self, kind: str) -> Path:
        """The recording of that kind, made where it is not there yet."""
        folder = self._folder / kind.replace(" ", "_")
        out, failed = folder / "session.mcap", folder / "failed.txt"
        try:
            folder.mkdir(parents=True)
        except FileExistsError:
            ready = lambda: out.exists() or failed.exists()  # noqa: E731
            _wait(ready, START_TIMEOUT + 4 * STEP_TIMEOUT, f"the recording of {kind}")
            assert not failed.exists(), failed.read_text("utf-8")
            return out
        try:
            made = record_demo(folder / "home", KINDS[kind])
            made.rename(out)
        except BaseException as error:
            failed.write_text(f"No recording of {kind}: {error}", "utf-8")
            raise
        return out


def record_demo(home: Path, options: tuple[str, ...], watched: float = WATCHED) -> Path:
    """A recording of the demo, begun after ``watched`` s of tracking by a new user whose folders
    are below ``home``."""
    home.mkdir(parents=True)
    port, log = _free_port(), home / "window.log"
    words = ["--demo", "--fps", "15", "--remote", f"udp:{port}", *options]
    with log.open("wb") as output:
        window = subprocess.Popen(
            [sys.executable, "-m", "app", *words],
            cwd=ROOT,
            env=_environment(home),
            stdout=output,
            stderr=subprocess.STDOUT,
        )
    try:
        return _record(window, port, watched, log, "none" not in options)
    finally:
        if window.poll() is None:
            window.send_signal(signal.SIGINT)
        window.wait(STEP_TIMEOUT)


def _record(
    window: subprocess.Popen[bytes], port: int, watched: float, log: Path, with_camera: bool
) -> Path:
    def running() -> bool:
        assert window.poll() is None, log.read_text("utf-8", "replace")
        return bool(_asked(port, "status", ATTEMPT).get("running"))

    def found() -> bool:
        status = _asked(port, "status", ATTEMPT)
        hands = {status[key] for key in status if key.startswith("tracking_")}
        return bool(hands) and not hands & {"searching", "lost"}

    _wait(running, START_TIMEOUT, "the demo")
    if with_camera:
        _wait(found, STEP_TIMEOUT, "finding the hand")
    time.sleep(watched)
    begun = _asked(port, "start")
    assert begun["ok"], begun
    time.sleep(RECORDED)
    ended = _asked(port, "stop")
    assert ended["ok"], ended
    name = Path(str(ended["file"])).name  # its folder is not sent over the network
    (path,) = log.parent.rglob(name)
    _wait(lambda: not needs_recovery(path), STEP_TIMEOUT, "the end of the recording")
    return path


def _asked(port: int, do: str, wait: float = STEP_TIMEOUT) -> dict[str, object]:
    """The window's answer; nothing while it does not answer yet."""
    try:
        answer = json.loads(ask({"do": do}, "127.0.0.1", port, wait))
    except GlovetrackError:
        time.sleep(0.1)
        return {}
    assert isinstance(answer, dict)
    return answer


def _wait(done: Callable[[], bool], timeout: float, what: str) -> None:
    end = time.monotonic() + timeout
    while not done():
        assert time.monotonic() < end, f"{what} took longer than {timeout:.0f} s"
        time.sleep(0.2)


def _free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
        asking.bind(("127.0.0.1", 0))
        return int(asking.getsockname()[1])


def _environment(home: Path) -> dict[str, str]:
    """A new user's; compiled kernels stay where they are."""
    out = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    folders = {"XDG_CONFIG_HOME": "config", "XDG_DATA_HOME": "data", "XDG_RUNTIME_DIR": "run"}
    cache = out.get("XDG_CACHE_HOME", str(Path.home() / ".cache"))
    (home / "run").mkdir(mode=0o700)
    out |= {name: str(home / folder) for name, folder in folders.items()}
    return out | {"HOME": str(home), "XDG_CACHE_HOME": cache, "QT_QPA_PLATFORM": "offscreen"}


def copied(path: Path, folder: Path) -> Path:
    """A copy that a test may change."""
    return Path(shutil.copy(path, folder / path.name))
