"""Files that are complete or absent, on disks that may be full, disconnected or read-only.

A new file is written into a temporary folder next to it, synchronised with the disk, and renamed
last. A process that is killed before leaves nothing under that name, and the next one that writes
it deletes the temporary folder.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import os
import re
import shutil
import stat
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.notices import notice

try:
    import fcntl
except ImportError:  # Windows has no locks on folders
    fcntl = None  # type: ignore[assignment]

_WORDS = {
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "the disk quota is used up",
    errno.EFBIG: "the disk allows no file this large",
    errno.EACCES: "you may not write there",
    errno.EPERM: "you may not write there",
    errno.EROFS: "the disk can only be read",
    errno.EIO: "the disk failed or was taken away",
    errno.ENODEV: "the disk was taken away",
    errno.ENXIO: "the disk was taken away",
    errno.ESTALE: "the network disk is disconnected",
    errno.ENOENT: "the folder does not exist",
    errno.ENOTDIR: "the folder does not exist",
    errno.ENAMETOOLONG: "the name is too long",
    errno.EEXIST: "a file of that name exists already",
    errno.EISDIR: "a folder of that name exists already",
    errno.ENOTEMPTY: "a folder of that name exists already",
}
_PART = ".part"
_LONGEST_PREFIX = 60  # characters of the name in that of the temporary folder


class DiskError(FileError):
    """Writing to the disk failed."""


def disk_error(path: Path | str, error: OSError) -> DiskError:
    """Returns an operating-system error as a message for the user."""
    why = _WORDS.get(error.errno or 0, error.strerror or str(error))
    return DiskError(notice("file.not_writable", path=path, why=why))


def check_regular(path: Path) -> None:
    """Raises FileError for anything but a file: a folder, or a pipe or device, which may never end.

    Raises OSError if it cannot be queried.
    """
    if not stat.S_ISREG(path.stat().st_mode):
        raise FileError(notice("file.not_regular", path=path))


def read_bounded(path: Path, limit: int, what: str) -> bytes:
    """Reads a regular file of at most ``limit`` bytes; ``what`` names the expected kind of file.

    Raises FileError for a larger one and for one that is not regular, OSError where it is missing.
    """
    check_regular(path)
    with path.open("rb") as file:
        data = file.read(limit + 1)
    if len(data) > limit:
        raise FileError(notice("file.too_large", path=path, limit_bytes=limit, what=what))
    return data


def free_bytes(folder: Path) -> int:
    """Returns the free bytes on the disk of ``folder``; 0 if it is missing."""
    try:
        return shutil.disk_usage(folder).free
    except OSError:
        return 0


def free_path(path: Path) -> Path:
    """Returns ``path``, or with ``_2``, ``_3``… before the suffix if it exists."""
    candidate, n = path, 1
    while os.path.lexists(candidate):
        n += 1
        candidate = path.with_name(f"{path.stem}_{n}{path.suffix}")
    return candidate


def check_target(path: Path, force: bool = False, inputs: Sequence[Path] = ()) -> None:
    """Raises FileError if ``path`` must not be an output.

    An empty file may, as `mktemp` makes one; another existing file only if ``force``; a folder, a
    device or one of the ``inputs`` never.
    """
    if not os.path.lexists(path):
        return
    for source in inputs:
        if path.exists() and source.exists() and path.samefile(source):
            raise FileError(notice("file.is_input", path=path))
    if path.exists() and not path.is_file():
        what = "a folder" if path.is_dir() else "a device, not a file"
        raise FileError(notice("file.occupied", path=path, what=what))
    if not force and not _is_empty(path):
        raise FileError(notice("file.exists_force", path=path))


def check_folder_target(folder: Path, force: bool = False) -> None:
    """Raises FileError if ``folder`` must not be written to: it must be new or empty, or ``force``
    allows files in it to be replaced. A file of that name is never replaced."""
    try:
        found = next(folder.iterdir(), None)
    except FileNotFoundError:
        return
    except OSError as error:
        raise disk_error(folder, error) from error
    if found is not None and not force:
        raise FileError(notice("file.folder_not_empty", folder=folder))


@contextlib.contextmanager
def whole_files(
    *paths: Path, force: bool = False, inputs: Sequence[Path] = ()
) -> Iterator[tuple[Path, ...]]:
    """Yields paths to write to instead of ``paths``, which appear when the block ends.

    ``paths`` are of one folder. They appear in their order, each atomically, so that the last one
    shows that all are complete. If the block fails, none appears. A folder instead of a file is
    moved as a whole. Raises FileError as `check_target` does, DiskError if the disk fails.
    """
    for path in paths:
        check_target(path, force, inputs)
    main = paths[-1]
    try:
        folder, lock = _new_part(main)
    except OSError as error:
        raise disk_error(main, error) from error
    try:
        parts = tuple(folder / path.name for path in paths)
        yield parts
        for part in parts:
            _to_disk(part)
        _give_names(parts, paths, force)
        _sync(main.parent)
    except OSError as error:
        raise disk_error(main, error) from error
    except FileError as error:  # of a temporary name
        inside, beside = f"{folder}{os.sep}", f"{main.parent}{os.sep}"
        raise type(error)(error.notice.replaced(inside, beside)) from error
    finally:
        shutil.rmtree(folder, ignore_errors=True)
        _close(lock)


@contextlib.contextmanager
def whole_file(path: Path, force: bool = False, inputs: Sequence[Path] = ()) -> Iterator[Path]:
    """`whole_files` for one."""
    with whole_files(path, force=force, inputs=inputs) as (part,):
        yield part


def write_whole(
    path: Path, text: str | bytes, force: bool = True, inputs: Sequence[Path] = ()
) -> None:
    """Writes ``text`` (UTF-8) to a small file, completely or not at all."""
    data = text.encode() if isinstance(text, str) else text
    with whole_file(path, force, inputs) as part:
        part.write_bytes(data)


def write_with_folder(path: Path, text: str | bytes, force: bool = True) -> None:
    """As `write_whole`; creates the folder if it is missing. Raises FileError, DiskError."""
    make_folder(path.parent)
    write_whole(path, text, force)


def make_folder(folder: Path) -> None:
    """Creates it if it is missing. Raises DiskError."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise disk_error(folder, error) from error


def sha256(path: Path) -> str:
    """Hex digest of a file, read in pieces."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def slug(name: str) -> str:
    """A file name for any text: small ASCII letters, digits and dashes."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-") or "unnamed"


def name_part(text: str) -> str:
    """A part of a file name that people read: letters of any language, digits, ``_`` and ``-``."""
    return re.sub(r"[^\w-]+", "-", text.strip()).strip("-")


def person_file_name(name: str) -> str:
    """Returns a person's name as a valid file name on every file system, with its spaces."""
    return re.sub(r"[^\w .-]+", "_", name).strip(" ._")[:60] or "unnamed"


def _new_part(path: Path) -> tuple[Path, int]:
    """Creates a temporary folder next to ``path``, locked while this process uses it."""
    prefix = f".{path.name[:_LONGEST_PREFIX]}."
    if fcntl is not None:
        for left in path.parent.glob(f"{_escaped(prefix)}*{_PART}"):
            _sweep(left)
    folder = Path(tempfile.mkdtemp(_PART, prefix, path.parent))
    return folder, _locked(folder)


def _escaped(prefix: str) -> str:
    return "".join(f"[{c}]" if c in "*?[" else c for c in prefix)


def _locked(folder: Path) -> int:
    """Locks ``folder``; -1 if another process has locked it, or without support for locks."""
    if fcntl is None:
        return -1
    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(handle)
        return -1
    return handle


def _sweep(left: Path) -> None:
    """Deletes the folder of a process that was killed, not one that is in use."""
    with contextlib.suppress(OSError):
        lock = _locked(left)
        if lock >= 0:
            shutil.rmtree(left, ignore_errors=True)
            _close(lock)


def _close(lock: int) -> None:
    if lock >= 0:
        os.close(lock)


def _to_disk(part: Path) -> None:
    """Synchronises a file, or all files of a folder, with the disk."""
    if part.is_dir():
        for inside in part.iterdir():
            _sync(inside)
    _sync(part)


def _sync(path: Path) -> None:
    if os.name == "nt" and path.is_dir():
        return  # Windows opens no folders
    handle = os.open(path, os.O_RDONLY if os.name != "nt" else os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _give_names(parts: Sequence[Path], paths: Sequence[Path], force: bool) -> None:
    """Renames all or, if one cannot be renamed, none."""
    given: list[Path] = []
    try:
        for part, path in zip(parts, paths, strict=True):
            _give_name(part, path, force)
            given.append(path)
    except BaseException:
        for path in given if not force else ():
            path.unlink(missing_ok=True)
        raise


def _is_empty(path: Path) -> bool:
    """Whether it is a regular file, not a link, without content."""
    try:
        found = path.lstat()
    except OSError:
        return False
    return stat.S_ISREG(found.st_mode) and found.st_size == 0


def _give_name(part: Path, path: Path, force: bool) -> None:
    """Renames; replaces a file with content that has appeared meanwhile only with ``force``."""
    if force and part.is_file():
        part.replace(path)  # a link is replaced, not what it points to
        return
    if part.is_file() and _is_empty(path):
        part.chmod(stat.S_IMODE(path.stat().st_mode))  # which `mktemp` made private
        part.replace(path)
        return
    if part.is_file():
        try:
            os.link(part, path)
            return
        except FileExistsError as error:
            raise FileError(notice("file.exists", path=path)) from error
        except OSError:
            pass  # a disk without hard links
    if os.path.lexists(path):
        raise FileError(notice("file.exists", path=path))
    part.rename(path)
