"""Rows from other processes: MediaPipe's environment, and the running app."""

import sys
from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks import mediapipe as bench_mediapipe
from tests.benchmarks import output as bench_output
from tests.benchmarks import window as bench_app
from tests.benchmarks.mediapipe import HandsPeer, PeerAbsentError

PAIRS = np.zeros((3, 2, 4, 5, 3), np.uint8)
WORKER = """
import json, sys
import numpy
pairs = numpy.load(sys.argv[1])
print("ready", flush=True)
for k, _ in enumerate(sys.stdin):
    print(json.dumps({"pair_s": 0.5 if k == 0 else 0.01 * k, "found": 3, "of": pairs.shape[0] * 2}),
          flush=True)
"""


@pytest.fixture
def environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An environment with this interpreter, so that only the worker must be faked."""
    python = tmp_path / "bin" / "python"
    python.parent.mkdir()
    python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')  # a link would lose our numpy
    python.chmod(0o755)
    monkeypatch.setenv("GLOVETRACK_PEERS", str(tmp_path))
    monkeypatch.setattr(bench_mediapipe, "WORKER", tmp_path / "worker.py")
    return tmp_path


def test_peer_calls_alternate_and_its_median_excludes_the_first(environment: Path) -> None:
    (environment / "worker.py").write_text(WORKER)
    with HandsPeer(PAIRS) as peer:
        for _ in range(4):
            peer()
        assert peer.pair_s == pytest.approx(0.02)
        assert peer.found_share == pytest.approx(0.5)


def test_peer_that_does_not_start_is_missing(environment: Path) -> None:
    (environment / "worker.py").write_text("raise ImportError('mediapipe')")
    with pytest.raises(PeerAbsentError, match="ImportError: mediapipe"):
        HandsPeer(PAIRS)


def test_peer_without_environment_explains_how_to_install_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GLOVETRACK_PEERS", str(tmp_path / "none"))
    with pytest.raises(PeerAbsentError, match="bench-peers"):
        HandsPeer(PAIRS)


def figures(**more: float) -> dict[str, object]:
    latency = {"latency_imu_ms": 1.5, "latency_imu_p99_ms": 30.0}
    return {
        "minutes": 10.0, "start_to_tracked_s": 2.5, "memory_mb": [500.0, 600.0, 604.0],
        "latency_ms": latency, **more,
    }  # fmt: skip


def test_rows_of_the_app_are_compared_with_their_goals() -> None:
    rows = bench_app.rows_of(figures())
    assert [r.value for r in rows] == [1.5, 30.0, 2.5, 604.0, 4.0]
    assert [bench_output.reached(r) for r in rows] == [True, False, True, True, None]


def test_an_app_that_fails_gives_no_rows(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    assert bench_app.app_rows(1) == []
    assert "was not measured" in capsys.readouterr().err
