"""numba's ahead-of-time compiler, in which each function keeps the options of its own decorator.

numba.pycc compiles all functions of a module with one set of options, without fast-math and with
Python's lock held, and has no public option for this. So one method of its compiler is replaced
here and four others are disabled meanwhile, which depends on numba's internals: pyproject.toml
keeps numba below the next minor version, and tests/kernels/test_aot.py shows whether another
version still works.
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
    warnings.simplefilter("ignore")  # numba has said since 2023 that this may move elsewhere
    from numba.pycc import CC
    from numba.pycc.compiler import ModuleCompiler

PROCESSOR = ""  # what every processor of the kind understands
ENVIRONMENT = "_ZN08NumbaEnv"  # how the names of functions' constants begin
DYNAMIC_ERROR = "__excinfo_unwrap_args"  # and those of what makes an error's arguments


class ExtensionModule(CC):
    """An extension module of compiled functions that needs no numba to run."""

    def __init__(self, name: str, folder: Path, features: str = "") -> None:
        """``features`` of processors, as LLVM has them, beside what every one understands."""
        super().__init__(name)
        self._features = features
        self.output_dir, self.target_cpu = str(folder), PROCESSOR
        self._options: dict[str, dict[str, Any]] = {}

    def add(
        self, name: str, types: tuple[Any, ...], function: Callable[..., Any], options: dict
    ) -> None:
        """``function`` for arguments of numba's ``types``, with ``options`` as numba.njit has."""
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
    """Functions that exported ones call, and that were not called before, are compiled for these
    alone: for LLVM to link in, without machine code and wrappers of their own. That takes a quarter
    less time. Called from Python afterwards they raise, so a process that compiles does nothing
    else with them.
    """

    def unwrapped(_compiler: _FunctionCompiler, flags: Flags) -> Flags:
        flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
        return flags

    def key(_context: CPUContext, _library: Any, _description: Any, _environment: Any) -> Any:
        """numba wants one of C for each function. This one refuses whatever it is given."""
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
    """What a module keeps as a pickle is unpickled once, not whenever it is used, as numba has it.

    Each array that a kernel returns asks for the type of arrays: 2 µs and an import, which in a
    process with Qt, where imports are PySide's, is 10 µs of Python.
    """
    unpickle = PythonAPI.unserialize

    def unserialize(api: Any, pickled: Any) -> Any:
        """Code that puts out the object, as a new reference; Python's lock is held."""
        if not isinstance(pickled, ir.GlobalVariable):
            return unpickle(api, pickled)
        name = f"{pickled.name}.kept"
        kept = api.module.globals.get(name)
        if kept is None:
            kept = cgutils.add_global_variable(api.module, api.pyobj, name)
            kept.linkage, kept.initializer = "internal", ir.Constant(api.pyobj, None)
        with api.builder.if_then(cgutils.is_null(api.builder, api.builder.load(kept))):
            api.builder.store(unpickle(api, pickled), kept)
        made = api.builder.load(kept)
        api.incref(made)
        return made

    with patch.object(PythonAPI, "unserialize", unserialize):
        yield


@contextmanager
def _for_processors_with(features: str) -> Iterator[None]:
    """Code of a module may use these; numba.pycc has no place to say so."""
    with patch.object(AOTCPUCodegen, "_customize_tm_features", lambda _codegen: features):
        yield


class _Compiler(ModuleCompiler):
    options: dict[str, dict[str, Any]]

    def _cull_exports(self) -> Any:
        """One LLVM library of all functions; what its base class keeps of them for the module."""
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
                function.linkage = "linkonce_odr"  # several functions bring the same
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
    """numba's flags for one function. The linked module holds the code, so none is made now."""
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
    """All but the module's own start stays inside."""
    for function in library.get_defined_functions():
        if function.name not in shown:
            local = function.linkage in {Linkage.private, Linkage.internal}
            function.visibility = "default" if local else "hidden"
