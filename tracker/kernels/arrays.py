"""Names for the arrays that kernels take: each says numbers, dimensions and order.

A kernel's parameters are annotated with these, with float, int and bool, and with named tuples
whose fields are; so its annotations are its signature. Arrays are contiguous (C order) unless said.
"""

from __future__ import annotations

from typing import Annotated, TypeAlias

import numpy as np
from numpy.typing import NDArray

Vector: TypeAlias = Annotated[NDArray[np.float64], "f8[1C]"]
Matrix: TypeAlias = Annotated[NDArray[np.float64], "f8[2C]"]
Stack: TypeAlias = Annotated[NDArray[np.float64], "f8[3C]"]
"""Matrices one behind the other, as (n, 3, 3) rotations are."""
Stack4: TypeAlias = Annotated[NDArray[np.float64], "f8[4C]"]
IntVector: TypeAlias = Annotated[NDArray[np.int64], "i8[1C]"]
IntMatrix: TypeAlias = Annotated[NDArray[np.int64], "i8[2C]"]
BoolVector: TypeAlias = Annotated[NDArray[np.bool_], "b1[1C]"]
BoolMatrix: TypeAlias = Annotated[NDArray[np.bool_], "b1[2C]"]
