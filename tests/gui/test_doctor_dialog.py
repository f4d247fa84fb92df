"""Help, Check computer and devices."""

import time
import zipfile

import pytest
from PySide6.QtWidgets import QFileDialog

from app.platform.bug_report import Choice
from app.window import doctor
from app.window.bug_reports import BugReports
from app.window.doctor import DoctorDialog, devices_in_use
from tracker.base.notices import failure, notice, warning
from tracker.doctor.finding import Check, Finding

FINDINGS = [
    Finding(notice("doctor.imus", imus=7)),
    Finding(warning("doctor.no_port"), notice("doctor.plug_glove")),
    Finding(failure("doctor.refused", device="/dev/ttyUSB0"), notice("doctor.replug")),
]


@pytest.fixture
def checked(window, qtbot, monkeypatch):
    """The dialog after it has run three checks."""
    check = Check("a", "A", lambda machine: FINDINGS)
    examine = doctor.examine
    monkeypatch.setattr(doctor, "examine", lambda machine: examine(machine, [check]))
    window.run_command("doctor")
    dialog = window.findChild(DoctorDialog)
    qtbot.waitUntil(dialog.save.isEnabled)
    return dialog


def texts(dialog) -> list[list[str]]:
    table = dialog.table
    return [[table.item(i, k).text() for k in range(3)] for i in range(table.rowCount())]


def test_the_findings_are_listed_with_their_remedies(checked):
    rows = texts(checked)
    assert [row[0] for row in rows] == ["● OK", "◐ Warning", "▲ Error"]
    assert rows[2][1:] == [str(FINDINGS[2].what), str(FINDINGS[2].remedy)]
    assert checked.summary.text() == "1 errors, 1 warnings."


def test_checking_again_replaces_the_findings(checked, qtbot):
    checked.again.click()
    assert not checked.save.isEnabled()
    qtbot.waitUntil(checked.save.isEnabled)
    assert len(texts(checked)) == 3


def test_the_report_is_saved_and_goes_into_a_bug_report(
    checked, window, tmp_path, qtbot, monkeypatch
):
    path = tmp_path / "report.txt"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *a: (str(path), ""))
    checked.save.click()
    assert str(FINDINGS[2].remedy) in path.read_text() and str(path) in checked.summary.text()
    reports: BugReports = window.reports
    reports.save(tmp_path / "bug.zip", Choice(screenshot=False, session=False))
    qtbot.waitUntil(lambda: not window.tasks.tasks)
    with zipfile.ZipFile(tmp_path / "bug.zip") as bundle:
        assert str(FINDINGS[2].what) in bundle.read("doctor.txt").decode()


def test_closing_stops_the_checks(window, qtbot, monkeypatch):
    """The devices are free again soon after, and nothing is shown in a closed dialog."""
    ran = []

    def endless(machine):
        while True:
            ran.append(1)
            time.sleep(0.01)
            yield FINDINGS[0]

    examine = doctor.examine
    check = Check("a", "A", endless)
    monkeypatch.setattr(doctor, "examine", lambda machine: examine(machine, [check]))
    window.run_command("doctor")
    dialog = window.findChild(DoctorDialog)
    qtbot.waitUntil(lambda: len(ran) > 3)
    dialog.close()
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_devices_of_this_window_are_not_opened(live):
    assert devices_in_use(live.host.setup) == frozenset()
    assert devices_in_use(None) == frozenset()
