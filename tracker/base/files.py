"""Files that are whole or absent, on disks that may be full, gone or read-only.

What is made is written beside its place in a folder of its own, brought down to the disk, and
takes its name last. A process that is killed on the way leaves nothing under that name, and the
next one that wants it sweeps up what is left beside it.
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
    errno.ESTALE: "the network disk is gone",
    errno.ENOENT: "the folder does not exist",
    errno.ENOTDIR: "the folder does not exist",
    errno.ENAMETOOLONG: "the name is too long",
    errno.EEXIST: "a file of that name exists already",
    errno.EISDIR: "a folder of that name exists already",
    errno.ENOTEMPTY: "a folder of that name exists already",
}
_PART = ".part"
_LONGEST_PREFIX = 60  # characters of the name in that of the folder beside it


class DiskError(FileError):
    """The disk did not take what was written."""


def disk_error(path: Path | str, error: OSError) -> DiskError:
    """An operating-system error in the user's words."""
    why = _WORDS.get(error.errno or 0, error.strerror or str(error))
    return DiskError(notice("file.not_writable", path=path, why=why))


def check_regular(path: Path) -> None:
    """Raises FileError for a folder, and for a pipe or a device, which may not end; OSError."""
    if not stat.S_ISREG(path.stat().st_mode):
        raise FileError(notice("file.not_regular", path=path))


def read_bounded(path: Path, limit: int, what: str) -> bytes:
    """A regular file of at most ``limit`` bytes, whole; ``what`` names the kind that it is not.

    Raises FileError for a larger one and for one that is not regular, OSError where it is missing.
    """
    check_regular(path)
    with path.open("rb") as file:
        data = file.read(limit + 1)
    if len(data) > limit:
        raise FileError(notice("file.too_large", path=path, limit_bytes=limit, what=what))
    return data


def free_bytes(folder: Path) -> int:
    """Bytes left on the disk of ``folder``; 0 if it is gone."""
    try:
        return shutil.disk_usage(folder).free
    except OSError:
        return 0


def free_path(path: Path) -> Path:
    """``path``, or with ``_2``, ``_3``… before the suffix if it is taken."""
    candidate, n = path, 1
    while os.path.lexists(candidate):
        n += 1
        candidate = path.with_name(f"{path.stem}_{n}{path.suffix}")
    return candidate


def check_target(path: Path, force: bool = False, inputs: Sequence[Path] = ()) -> None:
    """Raises FileError where ``path`` may not become an output.

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
    """Raises FileError where ``folder`` may not be filled: it must be new or empty, or ``force``
    allows to replace files in it. A file in its place is never replaced."""
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
    """Paths to write to in place of ``paths``, of one folder; these appear when the block ends.

    They appear in their order, each at once, so that the last one tells that all are there. If
    the block fails none does. A folder in place of a file is moved as a whole. Raises FileError
    as `check_target` does, DiskError where the disk fails.
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
    """A small file that is there with all of ``text`` (UTF-8), or as it was before."""
    data = text.encode() if isinstance(text, str) else text
    with whole_file(path, force, inputs) as part:
        part.write_bytes(data)


def write_kept(path: Path, text: str | bytes, force: bool = True) -> None:
    """`write_whole` in a folder that is made where it is missing. Raises FileError, DiskError."""
    make_folder(path.parent)
    write_whole(path, text, force)


def make_folder(folder: Path) -> None:
    """Make it where it is missing. Raises DiskError."""
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


def kept_name(name: str) -> str:
    """A person's name as every file system takes it, with its spaces."""
    return re.sub(r"[^\w .-]+", "_", name).strip(" ._")[:60] or "unnamed"


def _new_part(path: Path) -> tuple[Path, int]:
    """A new folder beside ``path``, locked for as long as this process uses it."""
    prefix = f".{path.name[:_LONGEST_PREFIX]}."
    if fcntl is not None:
        for left in path.parent.glob(f"{_escaped(prefix)}*{_PART}"):
            _sweep(left)
    folder = Path(tempfile.mkdtemp(_PART, prefix, path.parent))
    return folder, _locked(folder)


def _escaped(prefix: str) -> str:
    return "".join(f"[{c}]" if c in "*?[" else c for c in prefix)


def _locked(folder: Path) -> int:
    """A lock on ``folder``; -1 where another process holds it, or there are no such locks."""
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
    """Take away a folder whose process was killed; one that is in use stays."""
    with contextlib.suppress(OSError):
        lock = _locked(left)
        if lock >= 0:
            shutil.rmtree(left, ignore_errors=True)
            _close(lock)


def _close(lock: int) -> None:
    if lock >= 0:
        os.close(lock)


def _to_disk(part: Path) -> None:
    """Have the disk itself hold a file, or all files of a folder."""
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
    """All or, where one cannot have its name, none."""
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
    """Rename, but over nothing with content that has come up meanwhile unless ``force``."""
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
