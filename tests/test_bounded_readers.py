"""No reader of a file takes in a device, a pipe without an end or more than its kind may have."""

import os
import time
import tracemalloc
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from extensions.applications.touch.touch import load_mesh
from extensions.conformance.run import read_records
from extensions.conformance.take import read_labels
from tests.notices import raises
from tracker.base.errors import GlovetrackError
from tracker.firmware.image import read_image
from tracker.fusion.chain.calibration.profile_file import read_wearer
from tracker.fusion.chain.layout import ChainLayout
from tracker.glove import library
from tracker.hand.files import load_hand
from tracker.offline.imports.run import import_imus
from tracker.sensors.rig_files import load_opencv_stereo, load_zed
from tracker.session.align import read_alignment
from tracker.session.reader import SessionReader
from tracker.simulation.recorded.load import read_track
from tracker.vision.colours import load_profile

LAYOUT = ChainLayout(*library.load(library.DEFAULT_GLOVE, ""))
READERS: dict[str, Callable[[Path], object]] = {
    "hand.toml": load_hand,
    "colours.toml": load_profile,
    "wearer.toml": lambda path: read_wearer(path, LAYOUT),
    "stereo.yml": lambda path: load_opencv_stereo([path], 1280, 720),
    "SN1.conf": lambda path: load_zed(path),
    "glove.hex": read_image,
    "mesh.stl": load_mesh,
    "mesh.obj": load_mesh,
    "a.aligned.json": read_alignment,
    "a.tsv": read_track,
    "a.bvh": read_track,
    "a.npz": read_track,
    "a.csv": lambda path: import_imus([path], path.with_name("out.mcap")),
    "a.mat": lambda path: import_imus([path], path.with_name("out.mcap")),
    "a.mcap": lambda path: SessionReader(path).close(),
    "isaac.mcap": lambda path: list(read_records(path)),
}
MOST = 210_000_000
"""Bytes of memory; the largest limit of a reader that reads a file whole is 100 MB."""


@pytest.mark.parametrize("kind", ["endless", "pipe", "huge"])
@pytest.mark.parametrize("name", READERS)
def test_what_has_no_end_is_refused(tmp_path: Path, name: str, kind: str) -> None:
    path = tmp_path / name
    if kind == "endless":
        path.symlink_to("/dev/zero")
    elif kind == "pipe":
        os.mkfifo(path)
    else:
        with path.open("wb") as file:
            file.truncate(6 * 10**9)
    started = time.process_time()
    tracemalloc.start()
    try:
        with pytest.raises(GlovetrackError, match=r"\.$"):
            READERS[name](path)
        assert tracemalloc.get_traced_memory()[1] < MOST
    finally:
        tracemalloc.stop()
    assert time.process_time() - started < 5.0


def test_labels_that_have_no_end_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "take.labels.json"
    with path.open("wb") as file:
        file.truncate(6 * 10**9)
    with raises(GlovetrackError, "file.too_large"):
        read_labels(path)


def test_an_archive_that_swells_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.npz"
    with (
        zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive,
        archive.open("joints.npy", "w", force_zip64=True) as part,
    ):
        for _ in range(600):
            part.write(bytes(1_000_000))
    assert path.stat().st_size < 1_000_000
    with raises(GlovetrackError, "file.unpacked_size"):
        read_track(path)
    path.write_bytes(path.read_bytes()[:1000])
    with raises(GlovetrackError, "motion.not_leap"):
        read_track(path)
