"""The formats that a session can be exported to. Quick to import.

A package declares an `ExportFormat` as an entry point of the group ``glovetrack.formats``, under
its name.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.registry import Registry
from tracker.session.export.options import ExportOptions

if TYPE_CHECKING:
    from tracker.base.workers import WorkerRequest
    from tracker.session.export.series import EstimateSeries
    from tracker.session.reader import SessionReader

Writer: TypeAlias = "Callable[[SessionReader, Path, ExportOptions], EstimateSeries | None]"
DatasetWriter: TypeAlias = (
    "Callable[[Sequence[Path], Path, ExportOptions, Callable[[float], None], WorkerRequest],"
    " dict[str, Any]]"
)
COMMON = ("rate", "axes", "units", "start", "stop", "joints", "anonymous")
"""Options of a table of estimates."""
COPIED = ("start", "stop", "anonymous")
"""Options of a format that contains recorded values unchanged."""


@dataclass(frozen=True)
class ExportFormat:
    """``name`` is the value of ``--format`` and the ending of a file; ``title`` is for menus, in
    English.

    Exactly one of ``writer`` and ``dataset`` is set. Both import their module when they are called.
    A writer receives the session, the path of a new file (or of a folder to create) and the
    options; it returns the estimates that it wrote, or None if it wrote something else. A writer of
    data sets receives several sessions, and returns the content of the JSON file next to the data
    set.

    ``options``: the fields of `ExportOptions` that the format supports. ``both_hands``: one file
    contains both hands; other formats create a file for each. ``folder``: the writer creates a
    folder. ``beside``: extensions of further files that the writer creates. ``extra``: what to
    install with pip if a package is missing. ``order``: position in menus.
    """

    name: str
    title: str
    writer: Callable[[], Writer] | None = None
    dataset: Callable[[], DatasetWriter] | None = None
    options: tuple[str, ...] = COMMON
    both_hands: bool = False
    folder: bool = False
    beside: tuple[str, ...] = ()
    extra: str = ""
    order: int = 1000

    def load(self) -> Writer:
        """Imports the writer. Raises ConfigError for a data set, or if a package is missing."""
        if self.writer is None:
            raise ConfigError(notice("export.data_set", format=self.name))
        return self._imported(self.writer)

    def load_dataset(self) -> DatasetWriter:
        """Imports the writer of data sets. Raises ConfigError for another format."""
        if self.dataset is None:
            sets = " or ".join(kind.name for kind in formats() if kind.dataset is not None)
            raise ConfigError(notice("export.one_session", format=self.name, others=sets))
        return self._imported(self.dataset)

    def _imported(self, factory: Callable[[], Any]) -> Any:
        try:
            return factory()
        except ImportError as error:
            install = f" Run: pip install '{self.extra}'" if self.extra else ""
            raise ConfigError(
                notice("export.format_missing", format=self.name, why=error, install=install)
            ) from error

    def check(self, options: ExportOptions) -> None:
        """Raise ConfigError if an option is set that the format does not support."""
        unset = ExportOptions()
        wrong = [
            name
            for name in vars(unset)
            if name not in self.options and getattr(options, name) != getattr(unset, name)
        ]
        if wrong:
            raise ConfigError(notice("export.not_supported", format=self.name, options=wrong))

    def without_unused(self, options: ExportOptions) -> ExportOptions:
        """``options`` for several formats, without the axes, units and data set settings that this
        format does not support."""
        unset = ExportOptions()
        shared = ("axes", "units", "dataset", "every", "views")
        unused = {n: getattr(unset, n) for n in shared if n not in self.options}
        return replace(options, **unused)


FORMATS = Registry("formats", "export format", ExportFormat)


def formats() -> list[ExportFormat]:
    """All formats that can be loaded, in the order of menus."""
    return sorted(FORMATS.all().values(), key=lambda kind: (kind.order, kind.name))
