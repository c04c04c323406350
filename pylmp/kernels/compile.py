"""A plain function into one small relocatable object. The only file, with alphabet.py, that knows numba."""

from __future__ import annotations

import types
from typing import Any

from pylmp.kernels.key import reached

HEAD = 2  # words of a block in front of the arguments: numba's result and error
_taught: set[types.FunctionType] = set()


def compile_object(function: types.FunctionType) -> bytes:
    """Machine code with one symbol, ``kernel``: double kernel(int64 block[]).

    block: HEAD words for the kernel's own use, then a word for each argument: an integer, the bits of a double, an address.
    One pointer is all a caller hands over, however many arguments there are: calls from Python cost by the argument.

    Strict IEEE arithmetic: no reassociation, no contraction. Raises TypeError, naming the kernel, when it would
    allocate, print, raise or call anything outside itself.
    """
    import llvmlite.binding as llvm
    from numba import njit
    from numba import types as numba_types

    base = {
        "f8": numba_types.float64, "i8": numba_types.int64, "i4": numba_types.int32, "u1": numba_types.uint8,
        "f4": numba_types.float32,
    }  # fmt: skip
    signature = tuple(
        numba_types.CPointer(base[kind[:-1]]) if kind.endswith("*") else base[kind] for kind in arguments(function)
    )
    _teach(function)
    compiled = njit(numba_types.float64(*signature), error_model="numpy")(function).overloads[signature]
    text, name = compiled.library.get_llvm_str(), compiled.fndesc.llvm_func_name
    native = llvm.parse_assembly(text).get_function(name)
    module = llvm.parse_assembly(text + _entry(native))
    for symbol in (*module.functions, *module.global_variables):
        if not symbol.is_declaration:
            symbol.linkage = "external" if symbol.name == "kernel" else "internal"
    machine = llvm.Target.from_triple(llvm.get_process_triple()).create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(),
        opt=3, reloc="pic", codemodel="small",
    )  # fmt: skip
    _drop_unreached(llvm, module, machine)
    outside = [f.name for f in module.functions if f.is_declaration and not f.name.startswith("llvm.")]
    if outside:
        raise TypeError(
            f"kernel {function.__name__} calls {outside}: kernels allocate nothing and call nothing outside"
        )
    if any(symbol.name.startswith(".const.pickle") for symbol in module.global_variables):  # an exception, ready to be raised
        raise TypeError(f"kernel {function.__name__} may raise: nobody would hear it")
    return bytes(machine.emit_object(module))


def _entry(native: Any) -> str:
    """kernel(block) in LLVM's language: unpack the block, call native(result, error, arguments...)."""
    kinds = [str(argument.type) for argument in native.arguments]
    words = "ptr" if kinds[0] == "ptr" else "i64*"  # LLVM before 17 says what a pointer points to
    lines = [f"  %words = inttoptr i64 %block to {words}"]
    for k, kind in enumerate(kinds):
        lines.append(f"  %at{k} = getelementptr i64, {words} %words, i64 {k}")
        if k < HEAD:
            lines.append(f"  %a{k} = bitcast {words} %at{k} to {kind}")
            continue
        how = {"i64": "bitcast", "double": "bitcast"}.get(kind, "inttoptr")
        lines.append(f"  %w{k} = load i64, {words} %at{k}")
        lines.append(f"  %a{k} = {how} i64 %w{k} to {kind}")
    passed = ", ".join(f"{kind} %a{k}" for k, kind in enumerate(kinds))
    lines.append(f'  %status = call i32 @"{native.name}"({passed})')
    lines.append(f"  %result = load double, {kinds[0]} %a0")
    body = "\n".join(lines)
    return f"\ndefine double @kernel(i64 %block) {{\n{body}\n  ret double %result\n}}\n"


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
