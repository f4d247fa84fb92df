"""The conditions of bit identity are stored in every file, and reported where two differ."""

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from tracker.cli import main
from tracker.session.arithmetic import arithmetic
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder

Record = Callable[..., Path]


def asked(**environment: str) -> str:
    code = "from tracker.session.arithmetic import arithmetic; print(arithmetic())"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.strip()


def test_another_blas_kernel_is_another_arithmetic() -> None:
    first, second = asked(OPENBLAS_CORETYPE="Haswell"), asked(OPENBLAS_CORETYPE="Nehalem")
    if "OpenBLAS" not in first:
        pytest.skip("NumPy was built with another BLAS here")
    assert "OpenBLAS Haswell" in first and "OpenBLAS Nehalem" in second
    assert first == asked(OPENBLAS_CORETYPE="Haswell")


def test_a_recording_contains_its_arithmetic(tmp_path: Path, record: Record, maker) -> None:
    with SessionReader(record(tmp_path / "a.mcap", [maker.estimate(10)])) as reader:
        assert reader.info.arithmetic == reader.metadata["arithmetic"] == arithmetic()


def test_compare_reports_a_different_arithmetic(
    tmp_path: Path, session_info, record: Record, maker, capsys: pytest.CaptureFixture[str]
) -> None:
    estimates = [maker.estimate(10.0 * k) for k in range(5)]
    ours = record(tmp_path / "ours.mcap", estimates)
    other = replace(session_info, arithmetic="processor abacus")
    moved = [replace(e, keypoints=e.keypoints + 1e-12) for e in estimates]
    for name, content in (("theirs", moved), ("alike", estimates)):
        path = tmp_path / f"{name}.mcap"
        with SessionRecorder(path, other, RecorderParams(sync=False)) as recorder:
            for e in content:
                recorder.write(e)
    assert main(["compare", str(ours), str(tmp_path / "theirs.mcap")]) == 0
    output = capsys.readouterr().out
    assert "not identical" in output and "different arithmetic" in output
    assert arithmetic() in output and "processor abacus" in output
    main(["compare", str(ours), str(tmp_path / "alike.mcap")])
    assert "arithmetic" not in capsys.readouterr().out
