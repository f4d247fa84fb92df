"""A reference with known faults is aligned and registered, by the command and from real files."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import ezc3d
import numpy as np
import pytest

from extensions.reference.importing import ReferenceImportOptions, import_reference
from extensions.reference.registration import register, register_offsets
from extensions.reference.session import read_imported
from extensions.reference.tests.conftest import START, Wearer
from extensions.reference.tests.laboratory import FAULTY, RATE, Laboratory, markers, write_c3d
from extensions.reference.timing import by_pulse
from tracker.base.errors import FileError
from tracker.cli import main
from tracker.geometry import so3
from tracker.messages import Event
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.long


def test_known_faults_are_recovered(wearer: Wearer, imported: Path) -> None:
    """The estimates have 1 mm of noise per coordinate, 2400 instants of 22 points.

    Time: a part of 2 s has 13 200 coordinates of at least 10 mm/s, so its offset has a standard
    deviation below 1 mm / (√13200 · 10 mm/s) ≈ 0.9 ms, typically 0.05 ms; a line through 12 of them
    over 24 s has 0.05 / √12 ≈ 0.015 ms and 2 ppm. The interpolation between samples adds up to
    0.04 ms. Bounds: 0.2 ms and 8 ppm, a tenth of the fault. Pose and offsets: 1 mm / √2400 ≈
    0.02 mm per coordinate, divided by the lever of the hand's turns; 3 mm C3D floats are exact to
    0.1 µm. Bounds: 0.03°, 0.5 mm, and 0.3 mm of the 5 mm."""
    found = json.loads(imported.with_name("report.json").read_text())
    timing = found["timing"]
    assert timing["offset"] == pytest.approx(FAULTY.offset, abs=2e-4)
    assert timing["drift"] == pytest.approx(FAULTY.drift, abs=8e-6)
    assert timing["drift_sd"] < 8e-6 and timing["residual"] < 1e-3
    registered = found["with_offsets"]
    turn = so3.log(np.array(registered["R_GL"]).T @ FAULTY.R_GL)
    assert np.rad2deg(np.linalg.norm(turn)) < 0.03
    assert registered["p_GL"] == pytest.approx(FAULTY.p_GL, abs=5e-4)
    names = wearer.info.keypoint_names
    assert tuple(found["keypoints"]) == names
    assert np.abs(np.array(registered["offsets"]) - markers(wearer)).max() < 3e-4
    # noise of 1 mm and 0.3 mm per coordinate, and without offsets 5 mm in addition
    noise = np.sqrt(3 * (0.001**2 + 0.0003**2))
    assert registered["residual"] == pytest.approx(noise, rel=0.05)
    assert found["rigid"]["residual"] == pytest.approx(np.hypot(noise, 0.005), rel=0.1)


def test_the_topics_have_the_reference_at_the_session_s_times(
    wearer: Wearer, imported: Path
) -> None:
    """Rigidly registered markers are up to 5 mm from the keypoints, and the registration of 22
    random offsets may move by 5 mm / √22 ≈ 1 mm per direction; corrected ones are within noise."""
    with SessionReader(imported) as reader:
        found = read_imported(reader)
        start = reader.anchor.monotonic(reader.span_ns[0])
        t = np.array([reader.anchor.monotonic(int(s)) for s in found.stamp_ns]) - start
        assert len(list(reader.truth())) == 0
    x, R_GB = wearer.points(t)
    assert np.linalg.norm(found.points - x, axis=2).max() < 0.005 + 0.004
    corrected = found.about.corrected(found.points, R_GB)
    assert np.sqrt(np.mean((corrected - x) ** 2)) < 0.0005
    assert main(["verify", str(imported)]) == 0


def test_an_export_of_the_session_is_a_perfect_reference(short: Path, tmp_path: Path) -> None:
    """C3D has floats (0.1 µm), TRC 1 nm; both in other axes or units. Nothing else differs."""
    for form in ("c3d", "trc", "bvh"):
        path = tmp_path / f"own.{form}"
        assert main(["export", str(short), "--format", form, "-o", str(path)]) == 0
        about = import_reference(path, short, tmp_path / f"{form}.mcap")
        assert about.timing.offset == pytest.approx(0.0, abs=2e-5), form
        if form != "bvh":  # whose bones have constant lengths, unlike keypoints with noise
            assert about.rigid.residual < 1e-5 and len(about.keypoints) >= 21, form
        assert about.timing.drift == pytest.approx(0.0, abs=2e-6), form
        assert np.abs(about.with_offsets.offsets).max() < (1e-5 if form != "bvh" else 2e-3), form


def test_importing_again_replaces_the_reference(
    imported: Path, wearer: Wearer, tmp_path: Path
) -> None:
    second = tmp_path / "b.mcap"
    _, x = Laboratory().record(wearer, 15.0)
    other = write_c3d(tmp_path / "other.c3d", wearer.info.keypoint_names, x)
    import_reference(other, imported, second)
    with SessionReader(second) as reader:
        found = read_imported(reader)
        names = [a.name for a in reader.source.attachments()]
    assert found.about.file == "other.c3d" and len(found.stamp_ns) == round(15 * RATE)
    assert names.count("reference_right.json") == 1


def test_registration_survives_swapped_markers(wearer: Wearer, short: Path, tmp_path: Path) -> None:
    """A tenth of the time, two markers are swapped (100 mm), as happens in laboratories."""
    _, x_L = FAULTY.record(wearer, 19.0)
    names = list(wearer.info.keypoint_names)
    a, b = names.index("index_tip"), names.index("little_mcp")
    rows = slice(500, 730)
    x_L[rows, a], x_L[rows, b] = x_L[rows, b].copy(), x_L[rows, a].copy()
    path = write_c3d(tmp_path / "swapped.c3d", tuple(names), x_L)
    about = import_reference(path, short, tmp_path / "out.mcap")
    assert about.rigid.p_GL == pytest.approx(FAULTY.p_GL, abs=5e-4)
    assert about.timing.drift == pytest.approx(FAULTY.drift, abs=40e-6)
    assert np.abs(about.with_offsets.offsets).max() < 1e-3


def test_a_mirrored_reference_is_recognised(wearer: Wearer, short: Path, tmp_path: Path) -> None:
    _, x_L = FAULTY.record(wearer, 19.0)
    path = write_c3d(tmp_path / "m.c3d", wearer.info.keypoint_names, x_L * [1.0, -1.0, 1.0])
    with pytest.raises(FileError) as error:
        import_reference(path, short, tmp_path / "out.mcap")
    assert error.value.notice.code == "reference.mirrored"
    assert not (tmp_path / "out.mcap").exists()


def test_an_existing_file_is_not_replaced(wearer: Wearer, short: Path, tmp_path: Path) -> None:
    _, x_L = FAULTY.record(wearer, 19.0)
    path = write_c3d(tmp_path / "m.c3d", wearer.info.keypoint_names, x_L)
    out = tmp_path / "out.mcap"
    out.write_bytes(b"the user's own")
    assert main(["import-reference", str(path), str(short), "-o", str(out)]) == 1
    assert out.read_bytes() == b"the user's own"
    assert main(["import-reference", str(path), str(short), "-o", str(out), "--force"]) == 0
    assert out.read_bytes()[:5] == b"\x89MCAP"


def test_a_reference_of_another_movement_is_refused(
    wearer: Wearer, short: Path, tmp_path: Path
) -> None:
    rng = np.random.default_rng(0)
    steps = rng.normal(0, 0.002, (int(18 * RATE), 1, 3))
    x = np.cumsum(steps, axis=0) + rng.normal(0, 0.05, (1, len(wearer.info.keypoint_names), 3))
    path = write_c3d(tmp_path / "noise.c3d", wearer.info.keypoint_names, x)
    with pytest.raises(FileError) as error:
        import_reference(path, short, tmp_path / "out.mcap")
    assert error.value.notice.code in ("align.no_fit", "align.ambiguous", "reference.no_movement")


def test_times_are_aligned_by_the_clock(wearer: Wearer, short: Path, tmp_path: Path) -> None:
    _, x_L = FAULTY.record(wearer, 15.0)
    path = write_c3d(tmp_path / "lab.c3d", wearer.info.keypoint_names, x_L)
    options = ReferenceImportOptions(
        by="clock", start="2025-01-01T00:00:00.537+00:00"
    )  # START + 37 ms
    about = import_reference(path, short, tmp_path / "out.mcap", options)
    assert START == 0.5 and about.timing.offset == pytest.approx(0.037, abs=1e-6)
    with pytest.raises(FileError) as error:
        import_reference(path, short, tmp_path / "o.mcap", ReferenceImportOptions(by="clock"))
    assert error.value.notice.code == "reference.no_clock"
    late = ReferenceImportOptions(by="clock", start="2025-01-01T02:00:00+00:00")
    with pytest.raises(FileError) as error:
        import_reference(path, short, tmp_path / "o.mcap", late)
    assert error.value.notice.code == "reference.no_overlap"


def test_pulses_give_offset_and_drift_though_some_are_missing() -> None:
    """Twelve pulses stamped to 10 µs (uniform: sd 3 µs): the line has 3 µs / √12 ≈ 1 µs, and over
    some minutes a drift to 0.02 ppm."""
    rng = np.random.default_rng(1)
    theirs = np.cumsum(rng.uniform(5, 20, 12))
    ours = np.round(0.037 + (1 + 80e-6) * theirs, 5)
    found = by_pulse(np.delete(ours, 4), np.delete(theirs, [7, 9]))
    assert found.offset == pytest.approx(0.037, abs=2e-5)
    assert found.drift == pytest.approx(80e-6, abs=2e-7)
    assert found.parts == 9 and found.residual < 1e-5
    assert by_pulse([3.5], [1.25]).offset == 2.25


@pytest.mark.parametrize(
    ("ours", "theirs", "code"),
    [
        ([], [1.0], "reference.no_pulses"),
        ([1.0], [], "reference.no_pulses_in_file"),
        ([1.0, 2.0, 3.0, 4.0], [1.0, 2.0, 3.0], "reference.pulses_differ"),  # two offsets fit
        ([1.0, 2.0, 4.0], [1.0, 1.7, 5.0], "reference.pulses_differ"),
    ],
)
def test_pulses_that_do_not_match_are_refused(
    ours: list[float], theirs: list[float], code: str
) -> None:
    with pytest.raises(FileError) as error:
        by_pulse(ours, theirs)
    assert error.value.notice.code == code


def test_pulses_of_a_session_and_of_a_c3d_file(wearer: Wearer, tmp_path: Path) -> None:
    """An analogue channel at 1200 Hz shows edges to 0.8 ms; interpolated between two samples."""
    at = [2.0, 3.5, 7.25, 9.0]
    pulses = [Event(START + t, "pulse", "", {"number": k}) for k, t in enumerate(at)]
    session = wearer.session(tmp_path / "s.mcap", 0.001, duration=12.0, events=pulses)
    lab = Laboratory(offset=0.4)
    _, x_L = lab.record(wearer, 11.0)
    path = write_c3d(tmp_path / "lab.c3d", wearer.info.keypoint_names, x_L)
    file = ezc3d.c3d(str(path))
    file["parameters"]["ANALOG"]["RATE"]["value"] = [1200.0]
    file["parameters"]["ANALOG"]["LABELS"]["value"] = ["Sync"]
    t = np.arange(len(x_L) * 10) / 1200
    file["data"]["analogs"] = sum(
        5.0 * ((t >= p - 0.4) & (t < p - 0.3)) for p in at
    )[None, None]  # fmt: skip
    file.write(str(path))
    options = ReferenceImportOptions(by="pulse", pulse="Sync")
    about = import_reference(path, session, tmp_path / "out.mcap", options)
    assert about.timing.parts == 4 and about.timing.offset == pytest.approx(0.4, abs=1 / 1200)
    assert about.rigid.residual < 0.0025


def test_keypoints_that_are_only_inferred_have_offsets_too(wearer: Wearer, tmp_path: Path) -> None:
    """Offsets of 5 mm; six keypoints determine the pose: 1 mm / √2000 ≈ 0.02 mm each, times the
    lever of the others, which are up to twice as far away as the six are from one another."""
    digits = ("thumb", "middle", "ring", "little")
    inferred = [n for n in wearer.info.keypoint_names if n.split("_")[0] in digits]
    assert len(inferred) == 16
    session = wearer.session(tmp_path / "s.mcap", 0.001, duration=20.0, inferred=inferred)
    lab = replace(FAULTY, markers=markers(wearer))
    path = write_c3d(tmp_path / "l.c3d", wearer.info.keypoint_names, lab.record(wearer, 19.0)[1])
    about = import_reference(path, session, tmp_path / "out.mcap")
    found, k = about.with_offsets, [about.keypoints.index(n) for n in inferred]
    assert np.abs(found.offsets - markers(wearer)).max() < 5e-4
    assert (
        np.isnan(found.offset_sd[k]).all() and np.isfinite(np.delete(found.offset_sd, k, 0)).all()
    )


def test_a_common_offset_is_found_as_a_translation() -> None:
    """A hand that moves without turning; all markers 60 mm above their keypoints."""
    rng = np.random.default_rng(7)
    path = np.cumsum(rng.normal(0, 0.002, (600, 1, 3)), axis=0)
    x_G = path + rng.normal(0, 0.04, (1, 8, 3)) + rng.normal(0, 0.001, (600, 8, 3))
    x_L = x_G + [0.0, 0.0, 0.06] + rng.normal(0, 0.0005, x_G.shape)
    R_GB = np.broadcast_to(np.eye(3), (600, 8, 3, 3))
    rigid = register(x_L, x_G, "x.c3d")
    found = register_offsets(x_L, x_G, R_GB, rigid)
    assert found.p_GL == pytest.approx([0, 0, -0.06], abs=1e-3)
    assert np.abs(found.offsets).max() < 1e-3
    assert found.offset_sd.min() > 0.002  # a translation of all: the prior's 15 mm / √8
