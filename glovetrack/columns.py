"""Named arrays over time, as NumPy arrays first and as pandas tables on request."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import pandas as pd  # deferred: an extra

Array = NDArray[np.float64]


class Columns(Mapping[str, NDArray[Any]]):
    """One array per name, all over the same N instants.

    ``columns["index_tip"]`` is a view of ``array[:, i]``. ``parts`` names what one instant of one
    column consists of (``("x", "y", "z")`` for points); it is empty where that is one number.
    """

    def __init__(
        self,
        names: Sequence[str],
        array: NDArray[Any],
        t: Array,
        unit: str = "",
        parts: Sequence[str] = (),
    ) -> None:
        """``array`` (N, C) or (N, C, len(parts)); ``t`` (N,) s."""
        expected = (len(t), len(names), *((len(parts),) if parts else ()))
        if array.shape != expected:
            raise ValueError(f"array has shape {array.shape}, expected {expected}")
        self.names: tuple[str, ...] = tuple(names)
        self.array: NDArray[Any] = array
        self.t: Array = t
        self.unit: str = unit
        self.parts: tuple[str, ...] = tuple(parts)
        self._index = {name: i for i, name in enumerate(self.names)}

    def __getitem__(self, name: str) -> NDArray[Any]:
        """(N,) or (N, parts) of one name. Raises KeyError with the nearest names."""
        try:
            return self.array[:, self._index[name]]
        except KeyError:
            near = difflib.get_close_matches(str(name), self.names, 3) or list(self.names)
            raise KeyError(f"no column {name!r}; available: {', '.join(near)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        unit = f" in {self.unit}" if self.unit else ""
        return f"<{len(self.t)} instants of {len(self.names)} columns{unit}>"

    def to_frame(self) -> pd.DataFrame:
        """A pandas table with the time ``t`` in s as index and a column for each number.

        Raises ImportError where pandas is not installed.
        """
        flat = self.array.reshape(len(self.t), -1)
        names = [f"{n}_{p}" for n in self.names for p in self.parts] or list(self.names)
        return frame(self.t, dict(zip(names, flat.T, strict=True)))


def frame(t: Array, columns: Mapping[str, NDArray[Any]]) -> pd.DataFrame:
    """A pandas table of arrays (N,) over ``t`` (N,) s. Raises ImportError without pandas."""
    try:
        import pandas as pd  # deferred: an extra
    except ImportError as error:
        raise ImportError(
            "to_frame() needs pandas, which is not installed. "
            "Install it with: pip install 'glovetrack[pandas]'"
        ) from error
    return pd.DataFrame(dict(columns), index=pd.Index(t, name="t"))
