"""Names for the arrays that kernels take: each says numbers, dimensions and order.

A kernel's parameters are annotated with these, with float, int and bool, and with named tuples
whose fields are; so its annotations are its signature. Arrays are contiguous (C order) unless said.
What a kernel writes to is `Written`; all else it only reads, so that read-only arrays will do.
"""

from __future__ import annotations

from typing import Annotated, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

WRITTEN = object()
T = TypeVar("T")
Written: TypeAlias = Annotated[T, WRITTEN]
"""An array, or a named tuple of arrays, to which the kernel writes: ``P: Written[Matrix]``."""

Vector: TypeAlias = Annotated[NDArray[np.float64], "f8[1C]"]
Matrix: TypeAlias = Annotated[NDArray[np.float64], "f8[2C]"]
Stack: TypeAlias = Annotated[NDArray[np.float64], "f8[3C]"]
"""Matrices one behind the other, as (n, 3, 3) rotations are."""
Stack4: TypeAlias = Annotated[NDArray[np.float64], "f8[4C]"]
IntVector: TypeAlias = Annotated[NDArray[np.int64], "i8[1C]"]
IntMatrix: TypeAlias = Annotated[NDArray[np.int64], "i8[2C]"]
BoolVector: TypeAlias = Annotated[NDArray[np.bool_], "b1[1C]"]
BoolMatrix: TypeAlias = Annotated[NDArray[np.bool_], "b1[2C]"]
ComplexVector: TypeAlias = Annotated[NDArray[np.complex128], "c16[1C]"]
ComplexMatrix: TypeAlias = Annotated[NDArray[np.complex128], "c16[2C]"]
Float32Matrix: TypeAlias = Annotated[NDArray[np.float32], "f4[2C]"]
Float32Stack: TypeAlias = Annotated[NDArray[np.float32], "f4[3C]"]
Float32Vector: TypeAlias = Annotated[NDArray[np.float32], "f4[1C]"]
ByteVector: TypeAlias = Annotated[NDArray[np.uint8], "u1[1C]"]
ByteMatrix: TypeAlias = Annotated[NDArray[np.uint8], "u1[2C]"]
ByteStack: TypeAlias = Annotated[NDArray[np.uint8], "u1[3C]"]
"""Of an image (h, w, 3), blue, green and red."""
Int8Vector: TypeAlias = Annotated[NDArray[np.int8], "i1[1C]"]
UInt16Vector: TypeAlias = Annotated[NDArray[np.uint16], "u2[1C]"]
Int16Vector: TypeAlias = Annotated[NDArray[np.int16], "i2[1C]"]
Int16Matrix: TypeAlias = Annotated[NDArray[np.int16], "i2[2C]"]
Int32Vector: TypeAlias = Annotated[NDArray[np.int32], "i4[1C]"]
Int32Matrix: TypeAlias = Annotated[NDArray[np.int32], "i4[2C]"]
Int32Stack: TypeAlias = Annotated[NDArray[np.int32], "i4[3C]"]
UInt32Matrix: TypeAlias = Annotated[NDArray[np.uint32], "u4[2C]"]
