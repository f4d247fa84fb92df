"""A short study with two simulated participants."""

from __future__ import annotations

from pathlib import Path

import pytest

from extensions.study.command_runs import run_headless
from extensions.study.folder import Study, open_study, start_study
from extensions.study.tests.studies import QUICK, write_protocol
from tests.gui.conftest import no_leaks, qtbot, store, window
from tests.made_once import made_once

__all__ = ["no_leaks", "qtbot", "store", "window"]


@pytest.fixture(scope="session")
def short_study(shared_folder: Path) -> Study:
    """All trials are done; made once for all processes of a run."""

    def make(folder: Path) -> None:
        study = start_study(write_protocol(folder, QUICK), folder / "short")
        for participant in study.protocol.participants:
            run_headless(study.progress(participant))

    return open_study(made_once(shared_folder / "short-study", make) / "short")
