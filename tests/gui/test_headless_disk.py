"""A headless report on a full disk: messages, and no partial file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtGui import QImage, QPixmap

from app.engines import demo
from app.engines.demo_camera import DemoChoice
from app.window import headless_report as report
from tests.notices import shows
from tests.session.recording.spoilers import FullDisk
from tracker.messages import Estimate
from tracker.offline.track import track
from tracker.session.reader import SessionReader
from tracker.session.recording.process import RecorderProcesses
from tracker.streaming.registry import StreamSettings

resource = pytest.importorskip("resource")

LIMIT = 2000  # bytes of a file


@pytest.fixture
def small_files() -> Iterator[None]:
    """No file may become longer than `LIMIT` bytes."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (LIMIT, hard))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def window() -> SimpleNamespace:
    noise = np.random.default_rng(1).integers(0, 255, (120, 160, 4), np.uint8)
    image = QImage(noise.tobytes(), 160, 120, QImage.Format.Format_RGB32).copy()
    return SimpleNamespace(grab=lambda: QPixmap.fromImage(image))


def test_an_image_that_does_not_fit_is_reported_and_not_left(qapp, tmp_path, small_files) -> None:
    problems: list[str] = []
    report._save(window(), tmp_path / "window.png", problems)
    assert len(problems) == 1 and shows(problems[0], "file.not_writable")
    assert list(tmp_path.iterdir()) == []


def test_an_image_that_fits_is_complete(qapp, tmp_path) -> None:
    problems: list[str] = []
    report._save(window(), tmp_path / "window.png", problems)
    assert problems == [] and QImage(str(tmp_path / "window.png")).width() == 160


def test_a_session_that_could_not_be_recorded_is_reported_as_such(tmp_path: Path) -> None:
    path = tmp_path / "session.mcap"
    assert report._session_text(path) == "not recorded"
    path.write_bytes(bytes(100_000))
    assert report._session_text(path) == f"{path} (0.1 MB), no table"
    (tmp_path / "session_left.csv").touch()
    (tmp_path / "session_right.csv").touch()
    assert report._session_text(path).endswith("MB), session_left.csv, session_right.csv")


@pytest.mark.long
def test_a_disk_that_fills_up_during_the_report_is_an_error(
    qapp, tmp_path: Path, monkeypatch, capsys
) -> None:
    """Other reasons than a full disk reach the report the same way; see test_recorder_process."""
    full = RecorderProcesses(FullDisk(600_000))
    monkeypatch.setattr(demo, "RecorderProcesses", lambda _: full)
    choice = DemoChoice(scene="plain", lenses="none")
    watched = report.Watched("demo", lambda progress: demo.demo_setup(progress, 1, choice))
    out = tmp_path / "report"
    assert report.headless_report(3.0, out, watched, report.Connected(StreamSettings())) == 1
    session = out / "session.mcap"
    printed = capsys.readouterr()
    assert printed.err.splitlines()[-1] == (
        f"{session} cannot be written: the disk is full. "
        f"`glovetrack recover {session}` recovers what was recorded."
    )
    assert "Traceback" not in printed.err
    assert "session.csv" in printed.out
    again = tmp_path / "again.mcap"
    track(session, again)
    with SessionReader(again) as reader:
        assert sum(isinstance(m, Estimate) for m in reader.messages()) > 50
