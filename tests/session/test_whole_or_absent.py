"""Exports and tracked files with full disks, limits and signals: error messages, all or nothing."""

import json
import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tracker.cli import main
from tracker.session.export.formats import FORMATS

Record = Callable[..., Path]
ROOT = Path(__file__).resolve().parents[2]
LIMIT = 20_000  # bytes; every export of the session below is larger, but for the URDF
PICTURES = {"mp4", "png"}
RAW = {"imu.csv", "imu.parquet"}  # of samples, not of estimates
OF_ESTIMATES = [f for f in FORMATS.names() if f not in {"urdf", *PICTURES, *RAW}]


@pytest.fixture
def tracked(tmp_path: Path, record: Record, maker) -> Path:
    return record(tmp_path / "in.mcap", [maker.estimate(10.0 * k) for k in range(150)])


@pytest.fixture
def filmed(tmp_path: Path, record: Record, maker) -> Path:
    messages = []
    for k in range(60):
        messages += [maker.image(20.0 * k, k), maker.estimate(20.0 * k)]
    return record(tmp_path / "in.mcap", messages)


def command(*words: object, limit: int | None = None) -> subprocess.CompletedProcess[str]:
    """The command line in a subprocess that may write files of ``limit`` bytes.

    It writes no compiled modules: Python 3.11 writes half of one where no more fits (CPython issue
    126606), and that module could not be imported again.
    """

    def limited() -> None:
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.run(
        [sys.executable, "-m", "tracker.cli", *map(str, words)],
        cwd=ROOT,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        preexec_fn=limited,
        check=False,
    )


def others(folder: Path) -> list[str]:
    return sorted(p.name for p in folder.iterdir() if p.name != "in.mcap")


@pytest.mark.parametrize(
    "form", ["csv", *(pytest.param(f, marks=pytest.mark.long) for f in OF_ESTIMATES if f != "csv")]
)
def test_a_full_disk_leaves_nothing(tracked: Path, form: str) -> None:
    out = tracked.with_name(f"o.{form}")
    done = command("export", tracked, "--format", form, "-o", out, limit=LIMIT)
    assert done.returncode == 1, done.stderr
    assert done.stderr.startswith("glovetrack: ") and done.stderr.count("\n") == 1
    assert ".part" not in done.stderr
    assert others(tracked.parent) == []
    assert main(["export", str(tracked), "--format", form, "-o", str(out)]) == 0


@pytest.mark.long
@pytest.mark.parametrize("form", sorted(PICTURES))
def test_a_full_disk_for_images_leaves_nothing(filmed: Path, form: str) -> None:
    out = filmed.with_name(f"o.{form}")
    done = command("export", filmed, "--format", form, "-o", out, limit=4_000)
    assert done.returncode == 1
    assert "glovetrack: " in done.stderr
    assert others(filmed.parent) == []


def test_nothing_existing_is_overwritten(tracked: Path) -> None:
    out, other = tracked.with_name("o.csv"), tracked.with_name("other.mcap")
    other.write_bytes(tracked.read_bytes())
    (tracked.parent / "y.json").write_text("foreign")
    before = {p: p.read_bytes() for p in tracked.parent.iterdir()}
    words = ["export", str(tracked), "--format", "csv", "-o"]
    for taken in (other, tracked, tracked.parent / "y", Path(os.devnull)):
        assert main([*words, str(taken)]) == 1
    assert main([*words, str(tracked), "--force"]) == 1
    for target in (str(tracked), str(other)):
        for say in (["info"], ["verify"]):
            assert main([*say, str(tracked), "--json", target]) == 1
    assert main(["info", str(tracked), "--json", str(tracked), "--force"]) == 1
    assert {p: p.read_bytes() for p in tracked.parent.iterdir()} == before
    assert main([*words, str(out)]) == 0
    assert main([*words, str(out)]) == 1
    assert main([*words, str(out), "--force"]) == 0


def test_a_sidecar_left_by_a_kill_does_not_block(tracked: Path) -> None:
    words = ["export", str(tracked), "--format", "csv", "-o", str(tracked.with_name("o.csv"))]
    assert main(words) == 0
    tracked.with_name("o.csv").unlink()
    assert main(words) == 0
    assert json.loads(tracked.with_name("o.csv.json").read_text())["rows"] == 150


def test_nor_does_the_trajectory_of_a_missing_urdf(tracked: Path) -> None:
    words = ["export", str(tracked), "--format", "urdf", "-o", str(tracked.with_name("o.urdf"))]
    assert main(words) == 0
    assert main(words) == 1, "all is there already"
    tracked.with_name("o.urdf").unlink()
    assert main(words) == 0
    tracked.with_name("o.urdf").unlink()
    tracked.with_name("o.urdf.json").write_text("somebody's")
    assert main(words) == 1, "what is not ours stays"
    assert tracked.with_name("o.joints.csv").exists()


@pytest.mark.parametrize(
    "number",
    [
        *(pytest.param(n, marks=pytest.mark.long) for n in (signal.SIGTERM, signal.SIGINT)),
        signal.SIGKILL,
    ],
)
def test_a_signal_leaves_nothing_that_blocks(tmp_path: Path, number: signal.Signals) -> None:
    out = tmp_path / "o.mcap"
    words = ["simulate", "-o", str(out), "--blobs-only", "--duration"]
    running = subprocess.Popen(
        [sys.executable, "-m", "tracker.cli", *words, "3600"],
        cwd=ROOT,
        stderr=subprocess.PIPE,
        # a shell makes background processes ignore Ctrl+C
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline and not list(tmp_path.glob(".o*/o.mcap")):
        time.sleep(0.05)
    time.sleep(0.3)
    running.send_signal(number)
    _, errors = running.communicate(timeout=60)
    assert not out.exists()
    if number != signal.SIGKILL:
        assert (running.returncode, errors) == (1, b"glovetrack: stopped\n")
        assert list(tmp_path.iterdir()) == []
    assert main([*words, "1"]) == 0
    assert list(tmp_path.iterdir()) == [out]


def test_a_full_standard_output_is_reported(tracked: Path) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "tracker.cli", "info", str(tracked)],
            cwd=ROOT,
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert done.returncode == 1
    assert done.stderr == "glovetrack: standard output cannot be written: the disk is full.\n"


def test_a_terminal_without_unicode_is_sufficient(tracked: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "tracker.cli", "compare", str(tracked), str(tracked)],
        cwd=ROOT,
        env={**os.environ, "PYTHONIOENCODING": "ascii"},
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert b"identical to the last bit" in done.stdout and done.stdout.isascii()
