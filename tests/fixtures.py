"""Fixtures that many folders share, and where real recordings are."""

import functools
import gc
import os
import tempfile
from contextlib import nullcontext
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
os.environ.setdefault("GLOVETRACK_KERNELS", "kept")  # windows that tests open compile nothing

import app.__main__  # noqa: F401, I001  (before numpy: it limits BLAS to one thread, as in workers)

from tests import crash_traces
from tests import kernel_twins  # before the kernels

from tests.live_recordings import LiveRecordings
from tests.simulated_sessions import SimulatedSessions
from tests.streaming.recorded_hand import RecordedHand
from tests.workers_here import WorkersHere
from tracker.glove.files import load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.vision import detector

ROOT = Path(__file__).resolve().parents[1]
RESOURCES = ROOT / "resources"
DATA = Path(os.environ.get("GLOVETRACK_DATA", ROOT / "data"))
"""Real recordings and images, which are not part of the project; few tests need them."""

detector.hue_table = functools.lru_cache(maxsize=16)(detector.hue_table)
"""Hundreds of tests make detectors of the same few profiles, and a table takes 0.1 s to fill."""


def _check_handle(handle: int) -> None:
    os.fstat(handle)


os.fsync = _check_handle
"""No test cuts the power. Each window syncs ten times, which takes up to 0.1 s a time on a busy
disk. Processes that tests start sync as usual."""


def pytest_configure(config: pytest.Config) -> None:
    folder = tempfile.TemporaryDirectory(prefix="glovetrack-tests-")
    config.add_cleanup(folder.cleanup)
    crash_traces.register(config, Path(folder.name))
    kernel_twins.register(config, Path(folder.name))


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Modules with a time limit of their own, the slowest ones, first: a worker that starts one of
    them last would leave the other cores idle."""
    slow = {item.path for item in items if item.get_closest_marker("timeout")}
    items.sort(key=lambda item: item.path not in slow)


def pytest_collection_finish() -> None:
    """A million objects of tests and modules stay to the end: no further collection is needed."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def compare_large(monkeypatch: pytest.MonkeyPatch) -> None:
    """Kernels are compared with their twins however large their arrays."""
    monkeypatch.setattr(kernel_twins.TWINS, "most", 50_000_000)


@pytest.fixture
def workers_here(monkeypatch: pytest.MonkeyPatch) -> None:
    """A command does its tasks in this process: each other one takes a second or two to start.
    `tests/offline/test_batch.py` and others run the same tasks in processes."""
    monkeypatch.setattr("tracker.base.workers.local_workers", lambda _: nullcontext(WorkersHere()))


@pytest.fixture(scope="session")
def data_folder() -> Path:
    """Real recordings and images; the test is skipped where they are absent."""
    if not DATA.is_dir():
        pytest.skip(f"no recordings at {DATA} (set GLOVETRACK_DATA)")
    return DATA


@pytest.fixture(scope="session")
def hand() -> HandModel:
    return load_hand(RESOURCES / "hands" / "reference-right.toml")


@pytest.fixture(scope="session")
def glove(hand: HandModel) -> GloveModel:
    return load_glove(RESOURCES / "gloves" / "vist-small.toml", hand)


@pytest.fixture(scope="session")
def distal_glove(hand: HandModel) -> GloveModel:
    return load_glove(RESOURCES / "gloves" / "vist-small-distal.toml", hand)


@pytest.fixture(scope="session")
def shared_folder(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Path:
    """Of all processes of a run; for `made_once`."""
    folder = tmp_path_factory.getbasetemp()
    return folder if worker_id == "master" else folder.parent


@pytest.fixture(scope="session")
def live_recordings(shared_folder: Path) -> LiveRecordings:
    """Recordings that the application writes, made once for all processes of a run."""
    return LiveRecordings(shared_folder / "live")


@pytest.fixture(scope="session")
def simulated_sessions(shared_folder: Path) -> SimulatedSessions:
    """Simulated sessions, made once for all processes of a run."""
    return SimulatedSessions(shared_folder / "simulated")


@pytest.fixture(scope="session")
def recorded(live_recordings: LiveRecordings) -> RecordedHand:
    """A hand of the window's demo, as the window recorded it."""
    return RecordedHand(live_recordings.path("one hand"))
