"""Files are written atomically, and existing ones are not lost."""

import errno
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.notices import raises
from tracker.base.errors import FileError
from tracker.base.files import (
    DiskError,
    free_path,
    name_part,
    person_file_name,
    slug,
    whole_file,
    whole_files,
    write_whole,
    write_with_folder,
)


def test_a_file_appears_when_it_is_complete(tmp_path: Path) -> None:
    out = tmp_path / "a.txt"
    with whole_file(out) as part:
        part.write_text("all")
        assert not out.exists() and part.parent.parent == tmp_path
    assert out.read_text() == "all"
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]


@pytest.mark.parametrize("error", [KeyboardInterrupt(), OSError(errno.ENOSPC, "full")])
def test_a_failure_leaves_nothing(tmp_path: Path, error: BaseException) -> None:
    wanted = DiskError if isinstance(error, OSError) else KeyboardInterrupt
    with pytest.raises(wanted), whole_file(tmp_path / "a.txt") as part:
        part.write_text("half")
        raise error
    assert not list(tmp_path.iterdir())


def test_an_error_names_the_requested_file(tmp_path: Path) -> None:
    with pytest.raises(FileError) as caught, whole_file(tmp_path / "a.txt") as part:
        raise FileError(f"{part} is bad.")
    assert str(caught.value) == f"{tmp_path / 'a.txt'} is bad."


def test_nothing_is_overwritten_unless_forced(tmp_path: Path) -> None:
    out = tmp_path / "a.txt"
    out.write_text("old")
    with raises(FileError, "file.exists_force"), whole_file(out):
        pass
    with raises(FileError, "file.exists_force"):
        write_whole(out, "new", force=False)
    assert out.read_text() == "old"
    write_whole(out, "new")
    assert out.read_text() == "new"


def test_an_input_file_is_never_written(tmp_path: Path) -> None:
    source, link, hard = tmp_path / "in", tmp_path / "link", tmp_path / "hard"
    source.write_text("precious")
    link.symlink_to(source)
    hard.hardlink_to(source)
    for out in (source, link, hard):
        with raises(FileError, "file.is_input"):
            write_whole(out, "new", force=True, inputs=[source])
    assert source.read_text() == "precious"


def test_folders_and_devices_are_not_overwritten(tmp_path: Path) -> None:
    for out in (tmp_path, Path(os.devnull)):
        with raises(FileError, "file.occupied"):
            write_whole(out, "x", force=True)


def test_a_name_created_meanwhile_is_not_overwritten(tmp_path: Path) -> None:
    first, second = tmp_path / "a.json", tmp_path / "a"
    with raises(FileError, "file.exists"), whole_files(first, second) as parts:
        for part in parts:
            part.write_text("ours")
        second.write_text("theirs")
    assert second.read_text() == "theirs"
    assert not first.exists(), "all or none"


def test_a_dangling_link_counts_as_existing(tmp_path: Path) -> None:
    link = tmp_path / "a"
    link.symlink_to(tmp_path / "nowhere")
    with raises(FileError, "file.exists_force"):
        write_whole(link, "x", force=False)
    assert free_path(link).name == "a_2"


_KILLED = """
import os, sys, pathlib
from tracker.base.files import whole_file
with whole_file(pathlib.Path(sys.argv[1])) as part:
    part.write_text("half")
    os.kill(os.getpid(), 9)
"""


def test_leftovers_of_a_killed_process_do_not_block(tmp_path: Path) -> None:
    out = tmp_path / "a[1].txt"
    died = subprocess.run([sys.executable, "-c", _KILLED, str(out)], check=False)
    assert died.returncode == -signal.SIGKILL
    assert not out.exists() and len(list(tmp_path.iterdir())) == 1
    write_whole(out, "whole", force=False)
    assert [p.name for p in tmp_path.iterdir()] == [out.name], "and is swept up"


def test_files_of_a_running_process_are_not_removed(tmp_path: Path) -> None:
    out = tmp_path / "a.txt"
    with whole_file(out, force=True) as slow:
        slow.write_text("slow")
        write_whole(out, "quick")
    assert out.read_text() == "slow"


def test_a_stored_file_replaces_the_old_one_and_its_folder_is_created(tmp_path: Path) -> None:
    path = tmp_path / "new" / "a.toml"
    write_with_folder(path, "Größe = 1")
    write_with_folder(path, b"other")
    assert path.read_bytes() == b"other"
    assert [p.name for p in path.parent.iterdir()] == ["a.toml"]
    with raises(FileError, "file.not_writable"):
        write_with_folder(path / "inside", "")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("ZED 2i (left)", ("zed-2i-left", "ZED-2i-left", "ZED 2i _left")),
        ("Änne/O'Hara", ("nne-o-hara", "Änne-O-Hara", "Änne_O_Hara")),
        (" ..", ("unnamed", "", "unnamed")),
    ],
)
def test_any_text_is_converted_to_a_portable_file_name(
    text: str, expected: tuple[str, str, str]
) -> None:
    assert (slug(text), name_part(text), person_file_name(text)) == expected
