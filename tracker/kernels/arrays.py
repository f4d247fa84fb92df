"""Type names for the arrays that kernels take: each specifies type, dimensions and order.

A kernel's parameters are annotated with these, with float, int and bool, and with named tuples of
such fields; so its annotations are its signature. Arrays are contiguous (C order) unless stated
otherwise. An argument that a kernel modifies is marked `Written`; all others may be read-only
arrays.
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
"""A sequence of matrices, such as (n, 3, 3) rotations."""
Stack4: TypeAlias = Annotated[NDArray[np.float64], "f8[4C]"]
IntVector: TypeAlias = Annotated[NDArray[np.int64], "i8[1C]"]
IntMatrix: TypeAlias = Annotated[NDArray[np.int64], "i8[2C]"]
BoolVector: TypeAlias = Annotated[NDArray[np.bool_], "b1[1C]"]
BoolMatrix: TypeAlias = Annotated[NDArray[np.bool_], "b1[2C]"]
ComplexVector: TypeAlias = Annotated[NDArray[np.complex128], "c16[1C]"]
ComplexMatrix: TypeAlias = Annotated[NDArray[np.complex128], "c16[2C]"]
Float32Matrix: TypeAlias = Annotated[NDArray[np.float32], "f4[2C]"]
Float32Stack: TypeAlias = Annotated[NDArray[np.float32], "f4[3C]"]
Float32Stack4: TypeAlias = Annotated[NDArray[np.float32], "f4[4C]"]
Float32Vector: TypeAlias = Annotated[NDArray[np.float32], "f4[1C]"]
ByteVector: TypeAlias = Annotated[NDArray[np.uint8], "u1[1C]"]
ByteMatrix: TypeAlias = Annotated[NDArray[np.uint8], "u1[2C]"]
ByteStack: TypeAlias = Annotated[NDArray[np.uint8], "u1[3C]"]
"""An image (h, w, 3): blue, green and red."""
Int8Vector: TypeAlias = Annotated[NDArray[np.int8], "i1[1C]"]
UInt16Vector: TypeAlias = Annotated[NDArray[np.uint16], "u2[1C]"]
Int16Vector: TypeAlias = Annotated[NDArray[np.int16], "i2[1C]"]
Int16Matrix: TypeAlias = Annotated[NDArray[np.int16], "i2[2C]"]
Int32Vector: TypeAlias = Annotated[NDArray[np.int32], "i4[1C]"]
Int32Matrix: TypeAlias = Annotated[NDArray[np.int32], "i4[2C]"]
Int32Stack: TypeAlias = Annotated[NDArray[np.int32], "i4[3C]"]
UInt32Matrix: TypeAlias = Annotated[NDArray[np.uint32], "u4[2C]"]
