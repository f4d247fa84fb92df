"""A short study with two simulated participants."""

from __future__ import annotations

import pytest

from extensions.study.folder import Study, start_study
from extensions.study.headless import run_headless
from extensions.study.tests.studies import write_protocol
from tests.gui.conftest import no_leaks, qtbot, store, window

__all__ = ["no_leaks", "qtbot", "store", "window"]


@pytest.fixture(scope="session")
def short_study(tmp_path_factory: pytest.TempPathFactory) -> Study:
    """All trials are done."""
    folder = tmp_path_factory.mktemp("study")
    study = start_study(write_protocol(folder), folder / "short")
    for participant in study.protocol.participants:
        run_headless(study.progress(participant))
    return study
