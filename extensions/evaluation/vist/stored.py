"""Stores finished trials in a folder, so that an interrupted evaluation can be resumed.

Each trial is a file of plain arrays (NumPy's .npz, nothing pickled), named by its case and
participant. The file `PROGRAM` identifies the program that computed them, because a table must only
contain trials of one program.
"""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
from collections.abc import Iterator
from dataclasses import asdict, fields
from pathlib import Path

import numpy as np

import resources
import tracker
from extensions.evaluation.vist.cases import Case
from extensions.evaluation.vist.metrics import Trial, WholeHandErrors
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import sha256, slug, write_with_folder
from tracker.base.notices import notice

PROGRAM = "program.txt"
CASE = "case"  # stored in the file with the fields of a trial
WHOLE = "whole"  # the field of a trial whose parts are stored one by one
READ = ("hands", "gloves", "colours")  # resources that trials depend on


class StoredTrials:
    """Trials in ``folder``, which is created with the first one. Raises ConfigError if the folder
    contains trials of another version of the program."""

    def __init__(self, folder: Path) -> None:
        self._folder, self._program = folder, program()
        written = folder / PROGRAM
        if written.is_file() and written.read_text(encoding="utf-8") != self._program:
            raise ConfigError(notice("vist.other_version", folder=folder))

    def find(self, case: Case, participant: int) -> Trial | None:
        """A stored trial, or None. Raises FileError if its file is damaged."""
        path = self._path(case, participant)
        if not path.is_file():
            return None
        try:
            with np.load(path, allow_pickle=False) as file:
                values = {f.name: file[f.name] for f in fields(Trial) if f.name != WHOLE}
                parts = {f.name: file[f"{WHOLE}_{f.name}"] for f in fields(WholeHandErrors)}
        except (OSError, ValueError, KeyError, zipfile.BadZipFile) as error:
            raise FileError(notice("vist.damaged_trial", path=path)) from error
        names = tuple(map(str, parts.pop("names")))
        whole = WholeHandErrors(names, **parts) if names else None
        return Trial(**{name: v if v.ndim else v.item() for name, v in values.items()}, whole=whole)

    def add(self, case: Case, trial: Trial) -> None:
        """Store a finished trial. Raises DiskError."""
        data = io.BytesIO()
        values = {
            f.name: np.asarray(getattr(trial, f.name)) for f in fields(Trial) if f.name != WHOLE
        }
        none = np.zeros((0, 0))
        whole = trial.whole or WholeHandErrors((), none, none, none.astype(np.int64))
        values |= {
            f"{WHOLE}_{f.name}": np.asarray(getattr(whole, f.name)) for f in fields(WholeHandErrors)
        }
        np.savez_compressed(data, allow_pickle=False, **{CASE: np.array(_text(case)), **values})
        if not (self._folder / PROGRAM).is_file():
            write_with_folder(self._folder / PROGRAM, self._program)
        write_with_folder(self._path(case, trial.participant), data.getvalue())

    def _path(self, case: Case, participant: int) -> Path:
        text = _text(case)
        what = (case.experiment, case.engine, case.ablation, case.guided, case.light, case.session)
        name = slug(" ".join(part for part in what if part))
        key = hashlib.sha256(text.encode()).hexdigest()[:12]
        return self._folder / f"{name}-{key}-{participant:02d}.npz"


def _text(case: Case) -> str:
    """Everything that a case's trials depend on, except for the program."""
    files = [path for path in (*case.motion_files, case.wearer) if path]
    return json.dumps(asdict(case) | {"sha256": [sha256(Path(path)) for path in files]})


def program() -> str:
    """Identification of this program: version, and digest of the code and files used by trials."""
    digest = hashlib.sha256()
    for name, data in _sources():
        digest.update(f"{name} {len(data)}\n".encode() + data)
    return f"glovetrack {tracker.__version__} {digest.hexdigest()}\n"


def _sources() -> Iterator[tuple[str, bytes]]:
    """Names and contents in a fixed order."""

    code = Path(tracker.__file__).parent
    for path in sorted(code.rglob("*.py")):
        yield path.relative_to(code).as_posix(), path.read_bytes()
    for folder in READ:
        for file in sorted(resources.folder(folder).iterdir(), key=lambda f: f.name):
            if file.is_file():
                yield f"{folder}/{file.name}", file.read_bytes()
