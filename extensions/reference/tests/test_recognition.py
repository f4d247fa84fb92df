"""Recognition of a file's content, templates of mapping files, and remarks on an import."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from extensions.reference.importing import ReferenceImportOptions, import_reference
from extensions.reference.mapping import read_mapping
from extensions.reference.recognition import mapping_template, recognise
from extensions.reference.remarks import remarks
from extensions.reference.report import replay
from extensions.reference.session import Described, read_imported
from extensions.reference.tests.conftest import Wearer
from extensions.reference.tests.laboratory import FAULTY, Laboratory, markers, write_c3d
from tracker.base.errors import FileError
from tracker.hand.names import KEYPOINTS
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.long

NAMES = tuple(KEYPOINTS)


@pytest.fixture
def about(imported: Path) -> Described:
    with SessionReader(imported) as reader:
        return read_imported(reader).about


def test_a_file_is_recognised_with_its_keypoints(tmp_path: Path) -> None:
    points = np.random.default_rng(0).normal(size=(241, 4, 3))
    labels = ("R_IndexTip", "R_Wrist", "R_Thumb1", "elbow")
    path = write_c3d(tmp_path / "a.c3d", labels, points)
    found = recognise(path, NAMES, "right")
    assert (found.kind, found.points) == ("C3D", labels)
    assert found.rate == pytest.approx(120.0)
    assert found.duration == pytest.approx(2.0) and found.problem is None
    assert found.keypoints == ("wrist", "thumb_cmc", "index_tip")
    assert found.assigned == (("R_Wrist",), ("R_Thumb1",), ("R_IndexTip",))
    assert set(found.keypoints) | set(found.missing) == set(NAMES)
    assert not found.has_clock and found.pulses == 0
    of_left = recognise(path, NAMES, "left")
    assert of_left.problem is not None and of_left.problem.code == "reference.few_points"
    assert of_left.keypoints == () and of_left.missing == NAMES


def test_a_template_lists_what_is_found_and_what_is_not(tmp_path: Path) -> None:
    """It reads back unchanged, and with the missing points filled in."""
    points = np.random.default_rng(0).normal(size=(20, 4, 3))
    path = write_c3d(tmp_path / "a.c3d", ("IndexTip", "Wrist", "Thumb1", 'cup "A"'), points)
    text = mapping_template(path, NAMES, "right")
    mapping = tmp_path / "a.toml"
    mapping.write_text(text, "utf-8")
    found = read_mapping(mapping)
    assert found.unit is None and found.table is None
    assert found.keypoints == {
        "wrist": ("Wrist",), "index_tip": ("IndexTip",), "thumb_cmc": ("Thumb1",)
    }  # fmt: skip
    assert '# not assigned: "cup \\"A\\""' in text
    filled = text.replace('# little_tip = [""]', r'little_tip = ["cup \"A\""]')
    mapping.write_text(filled, "utf-8")
    assert recognise(path, NAMES, "right", mapping).keypoints == (
        "wrist", "thumb_cmc", "index_tip", "little_tip"
    )  # fmt: skip


@pytest.mark.parametrize(
    ("header", "delimiter", "points", "time"),
    [
        ("t,A_x,A_y,A_z,B_x,B_y,B_z", ",", {"A", "B"}, "t"),
        ("Time (s);RIFT X [mm];RIFT Y [mm];RIFT Z [mm]", ";", {"RIFT"}, "Time (s)"),
        ("frame\tWristX\tWristY\tWristZ\tmax", "\t", {"Wrist"}, None),
    ],
)
def test_a_template_of_a_csv_names_its_columns(
    header: str, delimiter: str, points: set[str], time: str | None, tmp_path: Path
) -> None:
    path = tmp_path / "a.csv"
    width = len(header.split(delimiter))
    rows = [delimiter.join(str(i + k / 10) for k in range(width)) for i in range(3)]
    path.write_text("\n".join(["Made by a program", header, *rows]), "utf-8")
    mapping = tmp_path / "a.toml"
    mapping.write_text(mapping_template(path, NAMES, "right"), "utf-8")
    table = read_mapping(mapping).table
    assert table is not None and (table.time, table.delimiter) == (time, delimiter)
    assert set(table.points) == points and table.rate == (0.0 if time else 100.0)
    found = recognise(path, NAMES, "right", mapping)
    assert found.kind == "CSV" and set(found.points) == points
    assert found.keypoints == (("wrist",) if "Wrist" in points else ())


def test_a_template_of_a_file_that_cannot_be_read_is_refused(tmp_path: Path) -> None:
    for call in (mapping_template, recognise):
        with pytest.raises(FileError) as error:
            call(tmp_path / "missing.csv", NAMES, "right")
        assert error.value.notice.code == "file.not_readable"


def test_residuals_of_keypoints_are_those_put_in(about: Described) -> None:
    """Noise of 1 mm and 0.3 mm per coordinate over 2400 instants, known to 1.5 %; rigid 5 mm in
    addition, of which the registration of 22 offsets takes up to 1 mm per direction."""
    noise = np.sqrt(3 * (0.001**2 + 0.0003**2))
    rigid, with_offsets = about.residuals
    assert_allclose(with_offsets, noise, rtol=0.05)
    assert_allclose(rigid, np.hypot(noise, 0.005), atol=0.002)
    assert about.residuals.shape == (2, len(about.keypoints)) and about.missing == ()
    assert about.covered == pytest.approx(23.0 / 24.0, abs=0.001)  # the reference has 23 s


def test_a_rigid_registration_estimates_no_offsets(
    wearer: Wearer, short: Path, tmp_path: Path
) -> None:
    lab = replace(FAULTY, markers=markers(wearer))
    path = write_c3d(tmp_path / "l.c3d", wearer.info.keypoint_names, lab.record(wearer, 19.0)[1])
    options = ReferenceImportOptions(register="rigid")
    shares: list[float] = []
    found = import_reference(path, short, tmp_path / "out.mcap", options, watch=shares.append)
    assert not found.with_offsets.offsets.any()
    assert found.with_offsets.residual == found.rigid.residual > 0.004
    assert_allclose(found.residuals[0], found.residuals[1])
    assert shares == sorted(shares) and shares[-1] > 0.99 and len(shares) > 100


def test_an_import_without_a_fault_has_no_remarks(about: Described) -> None:
    assert remarks(about) == []


def test_remarks_name_the_limits_of_an_import(about: Described) -> None:
    timing = replace(about.timing, residual=0.02, drift_sd=float("nan"))
    sd = about.with_offsets.offset_sd.copy()
    sd[2], sd[3] = 0.008, np.nan
    registered = replace(about.with_offsets, residual=0.031, offset_sd=sd)
    poor = replace(
        about, timing=timing, with_offsets=registered, covered=0.42, missing=("ring_tip",)
    )
    found = {r.code: r for r in remarks(poor)}
    assert list(found) == [
        "reference.large_residual", "reference.partly_covered", "reference.time_scatters",
        "reference.drift_unknown", "reference.offsets_uncertain", "reference.offsets_inferred",
        "reference.not_drawn",
    ]  # fmt: skip
    assert found["reference.offsets_uncertain"].values["keypoints"] == (about.keypoints[2],)
    assert found["reference.offsets_inferred"].values["keypoints"] == (about.keypoints[3],)
    assert "31 mm" in str(found["reference.large_residual"])
    assert "reference.drift_unknown" not in [r.code for r in remarks(poor, with_drift=False)]


def test_a_part_of_a_session_is_covered(wearer: Wearer, short: Path, tmp_path: Path) -> None:
    path = write_c3d(
        tmp_path / "l.c3d", wearer.info.keypoint_names, Laboratory().record(wearer, 10.0)[1]
    )
    found = import_reference(path, short, tmp_path / "out.mcap")
    assert found.covered == pytest.approx(0.5, abs=0.01)


def test_the_command_of_an_instant_is_for_a_shell() -> None:
    """Times are rounded up, as the replay shows the last estimate up to them."""
    assert replay("P01_grasp.mcap", 12.3401) == "glovetrack P01_grasp.mcap --at 12.341"
    assert replay("two words.mcap", 5.0) == 'glovetrack "two words.mcap" --at 5.000'
