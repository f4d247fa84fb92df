"""Every fault of the glove and of the camera, with both at once; `evaluate faults` runs 1000."""

from __future__ import annotations

import pytest

from extensions.evaluation.faults.drill import FAULTS, DrillParams, DrillReport, drill
from tracker.cli import main

pytestmark = pytest.mark.long

QUICK = DrillParams(fps=15.0, shortest=0.1, longest=0.7, rest_longest=0.3)


@pytest.fixture(scope="module")
def report() -> DrillReport:
    return drill(2 * len(FAULTS), seed=4, params=QUICK)


def test_tracking_recovers_within_a_second(report: DrillReport) -> None:
    assert set(report.faults) == set(FAULTS)
    assert report.worst_recovery() < 1.0, report.to_json()


def test_no_error_remains_unreported(report: DrillReport) -> None:
    assert not report.silent_wrong
    assert not report.unsaid


@pytest.mark.parametrize(
    "code",
    [
        "camera.swapped",
        "camera.lens_moved",
        "camera.lens_knocked",
        "camera.black",
        "camera.no_images",
        "glove.unplugged",
        "glove.restarted",
        "glove.clock_jumped",
    ],
)
def test_the_drill_requires_each_fault_to_be_reported(report: DrillReport, code: str) -> None:
    assert report.notices[code] > 0


def test_a_camera_that_is_knocked_over_is_reported() -> None:
    """Not every one: where the hand moves along with the image, its motion explains the jump."""
    lasting = DrillParams(fps=15.0, shortest=0.7, longest=0.8)
    assert drill(4, seed=2, params=lasting, kinds=("knocked",)).notices["camera.moved"] > 0


def test_undetected_errors_fail_the_drill(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the watch, and without the alignment that learns the rows of the right image, a
    swapped or moved camera is not detected, and the drill reports it."""
    alignment = "tracker.online.rig_alignment.RigAlignment"
    monkeypatch.setattr(f"{alignment}.learn", lambda self, result, is_known: None)
    monkeypatch.setattr(f"{alignment}.start_from", lambda self, shift: None)
    monkeypatch.setattr("tracker.online.rig_watch.RigWatch.usable", lambda self, frame, px: True)
    monkeypatch.setattr("tracker.online.rig_watch.RigWatch.check", lambda self, result: None)
    lasting = DrillParams(fps=15.0, shortest=0.7, longest=0.8)
    report = drill(2, seed=2, params=lasting, kinds=("lens up", "swapped"))
    assert report.unsaid == {"lens up": 1, "swapped": 1}


def test_the_command(tmp_path) -> None:
    out = tmp_path / "drill.json"
    assert main(["evaluate", "faults", "--count", "1", "--json", str(out)]) == 0
    assert '"silent_wrong": {}' in out.read_text()
