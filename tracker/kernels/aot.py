"""Extension modules of compiled functions that do not need numba when they run.

numba compiles the functions (`tracker.kernels.target`) and LLVM makes one object file of them with
a table of what is in it; a C++ compiler adds numba's helper functions (`runtime.c`) and the
module's init function (`module.c`). numba.pycc, numba's own way of doing this, is deprecated and is
not used.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from llvmlite import ir
from llvmlite.binding import Linkage
from numba.core import cgutils
from numba.core.compiler import compile_extra
from numba.core.compiler_lock import global_compiler_lock
from numba.core.environment import lookup_environment
from numba.core.runtime import nrtdynmod
from numba.core.target_extension import target_override

from tracker.kernels import target

ENVIRONMENT = "_ZN08NumbaEnv"  # prefix of the symbols of functions' constants
DYNAMIC_ERROR = "__excinfo_unwrap_args"  # prefix of the symbols that build an error's arguments
WORD, POINTER = ir.IntType(32), cgutils.voidptr_t
NOTHING = ir.FunctionType(ir.VoidType(), ())
WITH_KEYWORDS = 1 | 2  # METH_VARARGS | METH_KEYWORDS
METHODS, CONSTANTS, PLACES = "kernel_methods", "kernel_constants", "kernel_places"
"""Symbols of the tables, which `runtime.c` reads."""


class Function(NamedTuple):
    """A function of the module: its name there, numba's types of its arguments, its code, and
    options as for numba.njit."""

    symbol: str
    types: tuple[Any, ...]
    python: Callable[..., Any]
    options: dict[str, Any]


class _Compiled(NamedTuple):
    symbol: str
    wrapper: ir.FunctionType
    environment: Any
    environment_symbol: str


@global_compiler_lock
def object_code(name: str, functions: Sequence[Function], features: str = "") -> bytes:
    """The object file of the extension module ``name`` (`toolchain.link_module`).

    ``features`` of processors, as named by LLVM, in addition to the baseline of the architecture.
    """
    with target_override(target.NAME):
        return _object_code(target.context(features), name, functions)


def _object_code(context: Any, name: str, functions: Sequence[Function]) -> bytes:
    library = context.codegen().create_library(name)
    memory, _ = nrtdynmod.create_nrt_module(context)
    library.add_ir_module(memory)
    made = [_compile(context, library, function) for function in functions]
    library.add_ir_module(_tables(context, library, made))
    library.finalize()
    _hide(library)
    code: bytes = library.emit_native_object()
    return code


def _compile(context: Any, library: Any, function: Function) -> _Compiled:
    """Adds a function to the library, and its wrapper, which Python calls."""
    made = compile_extra(
        context.typing_context, context, function.python, function.types, None,
        target.flags(function.options), locals={}, library=library,
    )  # fmt: skip
    for inner in library._final_module.functions:
        if inner.name.startswith(DYNAMIC_ERROR):
            inner.linkage = "linkonce_odr"  # several functions contain it
    made.library.get_function(made.fndesc.llvm_func_name).linkage = "internal"
    wrapper = made.library.get_function(made.fndesc.llvm_cpython_wrapper_name)
    wrapper.name, wrapper.linkage = _wrapper(function.symbol), "external"
    convention = made.target_context.call_conv
    kind = convention.get_function_type(made.fndesc.restype, made.fndesc.argtypes)
    return _Compiled(function.symbol, kind, made.environment, made.fndesc.env_name)


def _tables(context: Any, library: Any, functions: list[_Compiled]) -> ir.Module:
    """What `runtime.c` needs to create the module's functions: the PyMethodDef of each, its pickled
    constants, and where to store these. Constants of linked functions follow."""
    module = library.create_ir_module("tables")
    nowhere = ir.IRBuilder()
    nowhere.position_at_end(ir.Function(module, NOTHING, "unused").append_basic_block())
    nowhere.ret_void()
    api = context.get_python_api(nowhere)
    environments = [(f.environment_symbol, f.environment) for f in functions] + _linked(library)
    places = [context.declare_env_global(module, symbol) for symbol, _ in environments]
    tables = {
        METHODS: [_method(context, module, function) for function in functions],
        CONSTANTS: [api.serialize_uncached(made.consts) for _, made in environments],
        PLACES: [place.bitcast(POINTER) for place in places],
    }
    for name, values in tables.items():
        kind = values[0].type
        array = cgutils.create_constant_array(kind, [*values, ir.Constant(kind, None)])
        cgutils.add_global_variable(module, array.type, name).initializer = array
    return module


def _method(context: Any, module: ir.Module, function: _Compiled) -> ir.Constant:
    """A PyMethodDef: name, function, flags, and no docstring."""
    name = context.insert_const_string(module, function.symbol)
    code = ir.Function(module, function.wrapper, _wrapper(function.symbol))
    parts = (name, code.bitcast(POINTER), ir.Constant(WORD, WITH_KEYWORDS))
    return ir.Constant.literal_struct((*parts, ir.Constant(POINTER, None)))


def _wrapper(symbol: str) -> str:
    return f"call_{symbol}"


def _linked(library: Any) -> list[tuple[str, Any]]:
    """Symbols and constants of the functions that were linked in."""
    linked = [other._final_module for other in library._linking_libraries]
    names = dict.fromkeys(gv.name for module in linked for gv in module.global_variables)
    found = [(n, lookup_environment(n)) for n in names if n.startswith(ENVIRONMENT)]
    return [(n, env) for n, env in found if env is not None and env.can_cache()]


def _hide(library: Any) -> None:
    """Hides all functions from other modules of the process."""
    for function in library.get_defined_functions():
        local = function.linkage in {Linkage.private, Linkage.internal}
        function.visibility = "default" if local else "hidden"
