"""Folders and several files: sessions are processed independently, failures reported, one table."""

import json
import logging
from collections.abc import Callable
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path
from queue import Queue
from threading import Event
from typing import Any, NamedTuple

import pytest

from tests.notices import raises, shows
from tracker.base.errors import ConfigError, DeviceError, FileError
from tracker.base.workers import WorkerRequest, WorkItem, dask_workers, run_all
from tracker.cli import main
from tracker.messages import Estimate
from tracker.offline.command_runs import BatchJob, plan, table, track_all
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.reader import SessionReader


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two sessions, one of them in a subfolder, and another file."""
    path = tmp_path_factory.mktemp("many")
    (path / "monday").mkdir()
    simulate(path / "a.mcap", SimulateOptions(seed=1, duration=2.0, fps=30, images=False))
    simulate(path / "monday" / "b.mcap", SimulateOptions(seed=2, duration=2.0, images=False))
    (path / "c.mcap").write_text("shopping list")
    return path


def names(jobs: list[BatchJob], out: Path) -> list[str]:
    return [j.out.relative_to(out).as_posix() for j in jobs]


@pytest.mark.long
def test_one_file_is_written_to_a_file_or_into_a_folder(folder: Path, tmp_path: Path) -> None:
    assert plan([folder / "a.mcap"], tmp_path / "x.mcap")[0].out == tmp_path / "x.mcap"
    assert plan([folder / "a.mcap"], tmp_path)[0].out == tmp_path / "a.mcap"


@pytest.mark.long
def test_a_folder_keeps_its_structure(folder: Path, tmp_path: Path) -> None:
    assert names(plan([folder], tmp_path), tmp_path) == ["a.mcap", "c.mcap", "monday/b.mcap"]


def test_equal_names_are_made_unique(folder: Path, tmp_path: Path) -> None:
    jobs = plan([folder / "a.mcap", folder / "a.mcap"], tmp_path)
    assert names(jobs, tmp_path) == ["a.mcap", "a_2.mcap"]


def test_tracked_sessions_are_not_tracked_again(folder: Path, tmp_path: Path) -> None:
    out = tmp_path / "tracked"
    out.mkdir()
    (out / "old.mcap").write_bytes(b"")
    (tmp_path / "new.mcap").write_bytes(b"")
    assert names(plan([tmp_path], out), out) == ["new.mcap"]


def test_impossible_arguments_are_rejected(folder: Path, tmp_path: Path) -> None:
    with raises(FileError, "session.none_in"):
        plan([tmp_path], tmp_path / "out")
    with raises(ConfigError, "track.out_is_file"):
        plan([folder], folder / "a.mcap")


@pytest.mark.long
def test_parallel_processes_give_identical_results(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, report = tmp_path / "out", tmp_path / "report.json"
    words = ["track", str(folder), "-o", str(out), "--jobs", "2", "--json", str(report)]
    assert main(words) == 1, "one of the three is no session"
    output = capsys.readouterr()
    assert shows(output.err, "track.some_failed", failed=1, count=3)
    rows = {line.split()[0]: line for line in output.out.splitlines()[1:]}
    assert "100.0 %" not in rows[str(folder / "c.mcap")]
    assert shows(rows[str(folder / "c.mcap")], "session.not_mcap")
    assert " mm" in rows[str(folder / "monday" / "b.mcap")]
    sessions = json.loads(report.read_text())["sessions"]
    assert ["error" in s for s in sessions] == [False, True, False]
    track(folder / "monday" / "b.mcap", tmp_path / "alone.mcap")
    assert compare(out / "monday" / "b.mcap", tmp_path / "alone.mcap")["identical"]
    assert not (out / "c.mcap").exists()


@pytest.mark.long
def test_nothing_is_overwritten(folder: Path, tmp_path: Path) -> None:
    precious = tmp_path / "a.mcap"
    precious.write_text("precious")
    jobs = [BatchJob(folder / "a.mcap", precious)]
    (outcome,) = track_all(jobs, TrackOptions(), lambda share: None, WorkerRequest(1))
    assert outcome.error is not None and outcome.error.code == "file.exists_force"
    assert shows(table(jobs, [outcome]), "file.exists_force")
    assert precious.read_text() == "precious"


class Dying(NamedTuple):
    """Workers whose processes die."""

    board: Queue[tuple[int, float]] = Queue()
    stop: Event = Event()

    def submit(self, _function: Callable[..., Any], *_arguments: Any) -> Future[Any]:
        future: Future[Any] = Future()
        future.set_exception(BrokenProcessPool("terminated abruptly"))
        return future


def test_a_worker_that_dies_is_reported() -> None:
    (outcome,) = run_all([WorkItem(print, ())], Dying(), lambda share: None)
    assert outcome.error is not None and outcome.error.code == "workers.ended"


@pytest.mark.long
def test_a_cluster_gives_identical_results(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    distributed = pytest.importorskip("distributed")
    monkeypatch.setattr(logging.getLogger("distributed"), "propagate", True)
    jobs = plan([folder], tmp_path)
    shares: list[float] = []
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None
    ) as cluster:
        asked = WorkerRequest(dask=cluster.scheduler_address)
        outcomes = track_all(jobs, TrackOptions(), shares.append, asked)
    assert [bool(o.error) for o in outcomes] == [False, True, False]
    assert shares[-1] == 1.0 and shares == sorted(shares)
    assert not [r for r in caplog.records if r.name == "distributed.core" and r.exc_info]
    with SessionReader(jobs[0].out) as reader:
        assert len(list(reader.messages((Estimate,)))) > 150


def test_an_unreachable_cluster_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("tracker.base.workers.DASK_TIMEOUT", 0.5)
    with raises(DeviceError, "workers.no_scheduler"), dask_workers("127.0.0.1:9"):
        pass


@pytest.mark.long
def test_a_folder_is_verified_with_one_command(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["verify", str(folder), "--json", "-"]) == 1
    found = json.loads(capsys.readouterr().out)
    ok = {Path(name).name: output["ok"] for name, output in found["files"].items()}
    assert ok == {"a.mcap": True, "b.mcap": True, "c.mcap": False} and not found["ok"]
    assert main(["verify", str(folder / "a.mcap"), str(folder / "monday")]) == 0
    assert "b.mcap is intact." in capsys.readouterr().out
