"""How kernels are to be made."""

MODE = "GLOVETRACK_KERNELS"
"""Environment variable. ``numba``: leave the compiled library aside. ``record``: the same, and note
the types of calls (`tracker.kernels.record`). ``build``: as the library's compiler wants them."""
