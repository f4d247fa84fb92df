"""numba's ahead-of-time compiler, in which each function keeps the options of its own decorator.

numba.pycc compiles all functions of a module with one set of options, without fast-math and with
the GIL held, and has no public option for this. So one method of its compiler is replaced here and
four others are disabled meanwhile, which depends on numba's internals: pyproject.toml pins numba
below the next minor version, and tests/kernels/test_aot.py checks whether another version still
works.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest.mock import patch

from llvmlite import ir
from llvmlite.binding import Linkage
from numba.core import cgutils
from numba.core.codegen import AOTCPUCodegen, JITCodeLibrary
from numba.core.compiler import Flags, compile_extra
from numba.core.cpu import CPUContext
from numba.core.dispatcher import _FunctionCompiler  # type: ignore[attr-defined]
from numba.core.environment import lookup_environment
from numba.core.pythonapi import PythonAPI
from numba.core.registry import cpu_target
from numba.core.runtime import nrtdynmod

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # numba has warned since 2023 that this may move
    from numba.pycc import CC
    from numba.pycc.compiler import ModuleCompiler

PROCESSOR = ""  # baseline of the architecture
ENVIRONMENT = "_ZN08NumbaEnv"  # prefix of the symbols of functions' constants
DYNAMIC_ERROR = "__excinfo_unwrap_args"  # prefix of the symbols that build an error's arguments


class ExtensionModule(CC):
    """An extension module of compiled functions that does not need numba at run time."""

    def __init__(self, name: str, folder: Path, features: str = "") -> None:
        """``features`` of processors, as named by LLVM, in addition to the baseline."""
        super().__init__(name)
        self._features = features
        self.output_dir, self.target_cpu = str(folder), PROCESSOR
        self._options: dict[str, dict[str, Any]] = {}

    def add(
        self, name: str, types: tuple[Any, ...], function: Callable[..., Any], options: dict
    ) -> None:
        """Add ``function`` for arguments of numba's ``types``, with ``options`` as for
        numba.njit."""
        self.export(name, types)(function)
        self._options[name] = options

    def _compile_object_files(self, build_dir: str) -> tuple[list[str], list[str]]:
        with _for_processors_with(self._features):
            compiler = _Compiler(self._export_entries, self._basename, True, cpu_name=PROCESSOR)
        compiler.external_init_function = self._init_function
        compiler.options = self._options
        path = str(Path(build_dir, f"{self._basename}.o"))
        with _not_made_runnable(), _unpickled_once():
            compiler.write_native_object(path, wrap=True)
        return [path], compiler.dll_exports


@contextmanager
def _not_made_runnable() -> Iterator[None]:
    """Compiles the callees of exported functions only for LLVM to link them in, without machine
    code and wrappers of their own. This takes a quarter less time. Calling them from Python
    afterwards raises, so a process that compiles must not use them for anything else.
    """

    def unwrapped(_compiler: _FunctionCompiler, flags: Flags) -> Flags:
        flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
        return flags

    def key(_context: CPUContext, _library: Any, _description: Any, _environment: Any) -> Any:
        """numba requires a C callback for each function; this one rejects any arguments."""
        refusing: list[object] = []
        return refusing.index

    with (
        patch.object(_FunctionCompiler, "_customize_flags", unwrapped),
        patch.object(CPUContext, "get_executable", key),
        patch.object(JITCodeLibrary, "_finalize_specific", lambda _library: None),
    ):
        yield


@contextmanager
def _unpickled_once() -> Iterator[None]:
    """Unpickles a module's pickled objects once, instead of on each use as numba does.

    Each array that a kernel returns needs the array type: 2 µs and an import, which takes 10 µs in
    a process with Qt, where PySide hooks imports.
    """
    unpickle = PythonAPI.unserialize

    def unserialize(api: Any, pickled: Any) -> Any:
        """Emits code that returns the object as a new reference; the GIL is held."""
        if not isinstance(pickled, ir.GlobalVariable):
            return unpickle(api, pickled)
        name = f"{pickled.name}.kept"
        stored = api.module.globals.get(name)
        if stored is None:
            stored = cgutils.add_global_variable(api.module, api.pyobj, name)
            stored.linkage, stored.initializer = "internal", ir.Constant(api.pyobj, None)
        with api.builder.if_then(cgutils.is_null(api.builder, api.builder.load(stored))):
            api.builder.store(unpickle(api, pickled), stored)
        made = api.builder.load(stored)
        api.incref(made)
        return made

    with patch.object(PythonAPI, "unserialize", unserialize):
        yield


@contextmanager
def _for_processors_with(features: str) -> Iterator[None]:
    """Allows a module's code to use these features; numba.pycc has no parameter for them."""
    with patch.object(AOTCPUCodegen, "_customize_tm_features", lambda _codegen: features):
        yield


class _Compiler(ModuleCompiler):
    options: dict[str, dict[str, Any]]

    def _cull_exports(self) -> Any:
        """One LLVM library of all functions; stores for the module what the base class does."""
        self.exported_function_types: dict[Any, Any] = {}
        self.function_environments: dict[Any, Any] = {}
        self.environment_gvs: dict[Any, str] = {}
        self.extra_environments: dict[str, Any] = {}
        library = self.context.codegen().create_library(self.module_name)
        memory, _ = nrtdynmod.create_nrt_module(self.context)
        library.add_ir_module(memory)
        for entry in self.export_entries:
            self._add(entry, library)
        wrapper = library.create_ir_module("wrapper")
        self._emit_python_wrapper(wrapper)
        library.add_ir_module(wrapper)
        library.finalize()
        _hide(library, self.dll_exports)
        return library

    def _add(self, entry: Any, library: Any) -> None:
        made = compile_extra(
            self.typing_context, self.context, entry.function, entry.signature.args, None,
            _flags(self.options[entry.symbol]), locals={}, library=library,
        )  # fmt: skip
        for function in library._final_module.functions:
            if function.name.startswith(DYNAMIC_ERROR):
                function.linkage = "linkonce_odr"  # several functions contain it
        made.library.get_function(made.fndesc.llvm_func_name).linkage = "internal"
        wrapper = made.library.get_function(made.fndesc.llvm_cpython_wrapper_name)
        wrapper.name = self._mangle_method_symbol(entry.symbol)
        wrapper.linkage = "external"
        self.exported_function_types[entry] = made.target_context.call_conv.get_function_type(
            made.fndesc.restype, made.fndesc.argtypes
        )
        self.function_environments[entry] = made.environment
        self.environment_gvs[entry] = made.fndesc.env_name
        self.extra_environments |= _environments(library)


def _flags(options: dict[str, Any]) -> Flags:
    """numba's flags for one function. The linked module contains the code, so none is generated
    now."""
    flags = Flags()
    flags.no_compile, flags.nrt = True, True
    cpu_target.options.parse_as_flags(flags, options)
    flags.no_cpython_wrapper, flags.no_cfunc_wrapper = False, True
    return flags


def _environments(library: Any) -> dict[str, Any]:
    """Constants of the kernels that were linked in."""
    linked = [other._final_module for other in library._linking_libraries]
    names = [gv.name for module in linked for gv in module.global_variables]
    found = {n: lookup_environment(n) for n in names if n.startswith(ENVIRONMENT)}
    return {n: env for n, env in found.items() if env is not None and env.can_cache()}


def _hide(library: Any, shown: list[str]) -> None:
    """Makes all symbols internal except the module's init function."""
    for function in library.get_defined_functions():
        if function.name not in shown:
            local = function.linkage in {Linkage.private, Linkage.internal}
            function.visibility = "default" if local else "hidden"
