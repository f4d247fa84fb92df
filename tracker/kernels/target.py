"""numba's target for the library of compiled kernels, next to its target for this computer.

numba compiles for targets that others define (its target extension: a context, a code generator,
options and a dispatcher, all subclasses). This one generates code for the baseline of an
architecture, or for named features in addition, and none of it can be called in this process:
kernels that kernels call are compiled only to be linked into these.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

from llvmlite import ir
from numba.core import cgutils, decorators, types
from numba.core.codegen import AOTCPUCodegen
from numba.core.compiler import Flags
from numba.core.cpu import CPUContext, CPUTargetOptions
from numba.core.pythonapi import PythonAPI
from numba.core.registry import CPUDispatcher, CPUTarget, cpu_target
from numba.core.target_extension import CPU, dispatcher_registry, jit_registry, target_registry

from tracker.kernels.jit import numba_options

NAME = "glovetrack"
BASELINE = ""  # processor: any of the architecture
_jit: Any = decorators.jit  # its annotations lack the target


class _Any(CPU):
    """Any processor of this architecture; numba's implementations for CPUs apply to it."""


class _Codegen(AOTCPUCodegen):
    def __init__(self, features: str) -> None:
        self._features = features
        super().__init__(NAME, BASELINE)

    def _customize_tm_features(self) -> str:
        return self._features


class _PythonAPI(PythonAPI):
    def unserialize(self, pickled: Any) -> Any:
        """Emits code that returns a pickled object as a new reference; the GIL is held.

        A module unpickles each once, instead of on each use as numba does: every array that a
        kernel returns needs the array type, which would take 2 µs and an import, so 10 µs in a
        process with Qt, where PySide hooks imports.
        """
        if not isinstance(pickled, ir.GlobalVariable):
            return super().unserialize(pickled)
        name = f"{pickled.name}.kept"
        stored = self.module.globals.get(name)
        if stored is None:
            stored = cgutils.add_global_variable(self.module, self.pyobj, name)
            stored.linkage, stored.initializer = "internal", ir.Constant(self.pyobj, None)
        with self.builder.if_then(cgutils.is_null(self.builder, self.builder.load(stored))):
            self.builder.store(super().unserialize(pickled), stored)
        made = self.builder.load(stored)
        self.incref(made)
        return made


class _Context(CPUContext):
    aot_mode = True
    features: str | None = None

    def compile_for(self, features: str) -> None:
        if self.features not in (None, features):
            raise ValueError("this process has compiled kernels for other processors")
        if self.features is None:
            self.features, self._internal_codegen = features, _Codegen(features)
            self.refresh()

    def get_python_api(self, builder: ir.IRBuilder) -> PythonAPI:
        return _PythonAPI(self, builder)

    def get_function(self, function: Any, signature: Any, _firstcall: bool = True) -> Any:
        """A function that numba has decorated for this computer, such as a sort, is linked in as
        compiled for that: its intermediate code is valid for any processor."""
        if isinstance(function, types.Dispatcher):
            key = function.get_impl_key(signature)
            if key not in self._defns:
                self._defns[key] = cpu_target.target_context._defns[key]
        return super().get_function(function, signature, _firstcall)

    def get_executable(self, _library: Any, _description: Any, _environment: Any) -> Any:
        """numba requires a C function for each kernel; this one rejects any arguments."""
        refusing: list[object] = []
        return refusing.index


class _Options(CPUTargetOptions):
    def finalize(self, flags: Flags, options: dict[str, Any]) -> None:
        super().finalize(flags, options)
        flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True


class _Target(CPUTarget):
    options = _Options

    @cached_property
    def _toplevel_target_context(self) -> _Context:
        return _Context(self.typing_context, NAME)


_TARGET = _Target(NAME)


class _Dispatcher(CPUDispatcher):
    targetdescr = _TARGET


target_registry[NAME] = _Any
dispatcher_registry[_Any] = _Dispatcher


def declare(function: Callable[..., Any], options: dict[str, Any]) -> Any:
    """A kernel that kernels can call, for this target; ``options`` of `decorator.kernel`."""
    made = _jit(_target=NAME, **numba_options(options))(function)
    made.options = options
    return made


jit_registry[_Any] = lambda *args, **options: _jit(*args, _target=NAME, **options)


def context(features: str) -> _Context:
    """The context that compiles for processors with these features, as named by LLVM, in addition
    to the baseline. ValueError if the process has compiled for others: callees are kept."""
    made: _Context = _TARGET.target_context
    made.compile_for(features)
    return made


def flags(options: dict[str, Any]) -> Flags:
    """numba's flags for a function that Python calls."""
    made = Flags()
    made.nrt = True
    _Options.parse_as_flags(made, options)
    made.no_compile, made.no_cpython_wrapper, made.no_cfunc_wrapper = True, False, True
    return made
