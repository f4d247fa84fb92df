"""OpenSim's motion files (MOT, STO): coordinates over time."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import Array


class MotionCourse(NamedTuple):
    """t (N,) s; values (N, C) of the coordinates ``names``: rotations in deg or rad, translations
    in m."""

    t: Array
    names: tuple[str, ...]
    values: Array
    in_degrees: bool

    @staticmethod
    def read(path: Path) -> MotionCourse:
        """Raises FileError."""
        try:
            head, _, rest = path.read_text("utf-8").partition("endheader")
            columns, *rows = rest.strip().splitlines()
            table = np.array([[float(cell) for cell in row.split()] for row in rows])
            first, *names = columns.split()
            if first != "time" or table.shape != (len(rows), len(names) + 1) or not rows:
                raise ValueError("time and one number per column are expected")
        except (OSError, ValueError) as error:
            raise FileError(notice("file.not_readable", path=path, why=error)) from error
        degrees = "indegrees=yes" in head.replace(" ", "").lower()
        return MotionCourse(table[:, 0], tuple(names), table[:, 1:], degrees)

    def write(self, path: Path) -> None:
        columns = ["time", *self.names]
        head = [path.stem, "version=1", f"nRows={len(self.t)}", f"nColumns={len(columns)}"]
        head.append(f"inDegrees={'yes' if self.in_degrees else 'no'}")
        with path.open("w", encoding="utf-8", newline="\n") as out:
            out.write("\n".join([*head, "endheader", "\t".join(columns)]) + "\n")
            np.savetxt(out, np.column_stack([self.t, self.values]), fmt="%.9g", delimiter="\t")
