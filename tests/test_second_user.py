"""What the program writes on the way is not open to another user of the computer."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from tracker.base.files import whole_file
from tracker.base.shared_memory import forget_name, new_memory
from tracker.kernels import cache
from tracker.simulation.rig_device import ImagePipe

pytestmark = pytest.mark.skipif(
    not hasattr(os, "getuid") or os.getuid() != 0, reason="only root can be a second user"
)
NOBODY = 65534
AS_NOBODY = """
import os, sys
os.setgroups([]); os.setgid(65534); os.setuid(65534)
for path in sys.argv[1:]:
    for flags in (os.O_RDONLY | os.O_NONBLOCK, os.O_WRONLY | os.O_NONBLOCK):
        try:
            os.close(os.open(path, flags))
            print("opened", path)
        except PermissionError:
            print("refused", path)
"""


def refused(*paths: Path) -> bool:
    """Whether another user can neither read nor write any of these, which all exist."""
    words = [sys.executable, "-c", AS_NOBODY, *map(str, paths)]
    output = subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines()
    assert len(output) == 2 * len(paths)
    return all(line.startswith("refused ") for line in output)


@pytest.fixture
def shared(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder that everybody may write to, as /tmp; files in it are made as a lax user has it."""
    before = os.umask(0)
    with tempfile.TemporaryDirectory(dir="/tmp") as name:
        Path(name).chmod(0o1777)
        monkeypatch.setattr(tempfile, "tempdir", name)
        yield Path(name)
    os.umask(before)


def test_the_check_itself_finds_an_open_file(shared: Path) -> None:
    (shared / "open.txt").write_text("x")
    assert not refused(shared / "open.txt")


def test_a_file_on_its_way_is_private_and_has_no_name_that_can_be_guessed(shared: Path) -> None:
    names = set()
    for _ in range(2):
        with whole_file(shared / "out.csv", force=True) as part:
            part.write_text("half")
            assert refused(part)
            assert part.parent.parent == shared and part.parent.stat().st_mode & 0o777 == 0o700
            names.add(part.parent.name)
    assert len(names) == 2


def test_a_planted_part_is_not_used_and_a_link_is_not_followed(shared: Path) -> None:
    """A stranger's folder that looks like ours, and a link in place of the output."""
    planted, target = shared / ".out.csv.abcdefgh.part", shared / "stranger.txt"
    planted.mkdir(mode=0o777)
    target.write_text("theirs")
    (planted / "out.csv").symlink_to(target)
    for path in (planted, planted / "out.csv"):
        os.chown(path, NOBODY, NOBODY, follow_symlinks=False)
    with whole_file(shared / "out.csv") as part:
        assert part.parent != planted
        part.write_text("ours")
    assert (shared / "out.csv").read_text() == "ours" and target.read_text() == "theirs"


def test_shared_memory_of_images_is_private() -> None:
    memory = new_memory(4096)
    try:
        assert refused(Path("/dev/shm") / memory.name.lstrip("/"))
    finally:
        forget_name(memory)
        memory.close()


def test_the_pipe_of_a_simulated_camera_is_private(shared: Path) -> None:
    pipe = ImagePipe(shared / "camera.mjpeg")
    try:
        assert refused(pipe.path)
    finally:
        pipe.close()


@pytest.mark.parametrize("place", ["file", "entry", "cache"])
def test_compiled_kernels_of_another_user_are_not_loaded(
    shared: Path, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    here, root = shared / "here", shared / "cache"
    for folder in (here, root, root / cache._key("table")):
        folder.mkdir(mode=0o700)
    monkeypatch.setattr(cache, "HERE", here)
    monkeypatch.setenv(cache.FOLDER, str(root))
    name = cache._file("_compiled")
    stored = root / cache._key("table") / name
    stored.write_bytes(b"code")
    stored.chmod(0o644)
    assert cache.fetch("table", "_compiled") and (here / name).read_bytes() == b"code"
    (here / name).unlink()
    changed = {"file": stored, "entry": stored.parent, "cache": root}[place]
    shutil.chown(changed, NOBODY, NOBODY)
    assert not cache.fetch("table", "_compiled") and not (here / name).exists()
    shutil.chown(changed, 0, 0)
    changed.chmod(0o777)
    assert not cache.fetch("table", "_compiled") and not (here / name).exists()
