"""A plain function into one small relocatable object. The only file, with alphabet.py, that knows numba."""

from __future__ import annotations

import types
from typing import Any

from pylmp.kernels.key import reached

_taught: set[types.FunctionType] = set()


def compile_object(function: types.FunctionType) -> bytes:
    """Machine code with one symbol, ``kernel``: int32 kernel(double *result, void **error, arguments...).

    Strict IEEE arithmetic: no reassociation, no contraction. Raises TypeError, naming the kernel, when it would
    allocate, print or call anything outside itself.
    """
    import llvmlite.binding as llvm
    from numba import njit
    from numba import types as numba_types

    base = {
        "f8": numba_types.float64, "i8": numba_types.int64, "i4": numba_types.int32, "u1": numba_types.uint8,
    }  # fmt: skip
    signature = tuple(
        numba_types.CPointer(base[kind[:-1]]) if kind.endswith("*") else base[kind] for kind in arguments(function)
    )
    _teach(function)
    compiled = njit(numba_types.float64(*signature), error_model="numpy")(function).overloads[signature]
    module = llvm.parse_assembly(compiled.library.get_llvm_str())
    name = compiled.fndesc.llvm_func_name
    for symbol in (*module.functions, *module.global_variables):
        if not symbol.is_declaration:
            symbol.linkage = "external" if symbol.name == name else "internal"
    machine = llvm.Target.from_triple(llvm.get_process_triple()).create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(),
        opt=3, reloc="pic", codemodel="small",
    )  # fmt: skip
    _drop_unreached(llvm, module, machine)
    module.get_function(name).name = "kernel"
    outside = [f.name for f in module.functions if f.is_declaration and not f.name.startswith("llvm.")]
    if outside:
        raise TypeError(
            f"kernel {function.__name__} calls {outside}: kernels allocate nothing and call nothing outside"
        )
    return bytes(machine.emit_object(module))


def arguments(function: types.FunctionType) -> list[str]:
    """The annotated kinds of a kernel's arguments: 'f8*', 'i8*', 'i4*', 'u1*', 'f8', 'i8'."""
    return [str(kind).strip("'\"") for name, kind in function.__annotations__.items() if name != "return"]


def _drop_unreached(llvm: Any, module: Any, machine: Any) -> None:
    if not hasattr(llvm, "create_new_module_pass_manager"):  # llvmlite before 0.45
        passes = llvm.create_module_pass_manager()
        passes.add_global_dce_pass()
        passes.run(module)
        return
    passes = llvm.create_new_module_pass_manager()
    passes.add_global_dead_code_eliminate_pass()
    passes.run(module, llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(3)))


def _teach(function: types.FunctionType) -> None:
    """Make every plain function that function reaches callable from compiled code; they stay undecorated."""
    from numba.extending import register_jitable

    from pylmp.kernels.alphabet import WORDS

    pending = [function]
    while pending:
        current = pending.pop()
        for _, value in reached(current.__code__, current):
            if isinstance(value, types.FunctionType) and value not in WORDS and value not in _taught:
                _taught.add(value)
                register_jitable(value)
                pending.append(value)
