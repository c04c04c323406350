"""The store of machine code: harm to it costs time, never the run, and never a wrong number."""

from __future__ import annotations

import errno
import os
import platform
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pylmp.kernels import compile as compiler
from pylmp.kernels import disk, load, store, workers
from pylmp.kernels.key import key
from tests.kernels.scenes import (
    allocating,
    both_of_an_angle,
    chain,
    fill_and_copy,
    line,
    raising,
    soft,
    spring,
    transcendental,
    word,
)

ROOT = Path(__file__).parents[2]
COMPILED_HERE = str(not hasattr(os, "fork") or sys.platform == "darwin")  # elsewhere children do it
EXPECTED = float(chain(spring, soft)(*line()))


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch) -> Path:
    """A store of its own, and a process that has placed nothing yet."""
    monkeypatch.setenv("PYLMP_CACHE", str(tmp_path / "store"))
    forget(monkeypatch)
    return tmp_path / "store"


def forget(monkeypatch) -> None:
    monkeypatch.setattr(store, "_placed", {})


def again(monkeypatch) -> tuple[float, bool]:
    """(result, whether it had to be compiled), as a new process would see it."""
    compiled = []
    monkeypatch.setattr(store, "compile_all", lambda work: compiled.extend(work) or workers.compile_all(work))
    forget(monkeypatch)
    return store.kernel(chain(spring, soft)).bind(*line())(), bool(compiled)


def entry(home: Path) -> Path:
    (found,) = home.glob("*.o")
    return found


def python(code: str, **environment: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


WARM = """
import sys
from pylmp.kernels.store import kernel
from tests.kernels.scenes import chain, line, soft, spring
print(kernel(chain(spring, soft)).bind(*line())(), 'numba' in sys.modules, 'llvmlite' in sys.modules)
"""


def test_found_again_without_the_compiler(home: Path) -> None:
    first, second = python(WARM, PYLMP_CACHE=str(home)), python(WARM, PYLMP_CACHE=str(home))
    assert first.split() == [repr(EXPECTED), COMPILED_HERE, COMPILED_HERE]
    assert second.split() == [repr(EXPECTED), "False", "False"]


def test_a_changed_constant_of_a_law_changes_the_next_run(tmp_path: Path) -> None:
    law, script = tmp_path / "my_law.py", "from my_law import *\nprint(kernel(loop).bind(2.0)())"
    text = "from pylmp.kernels.store import kernel\ndef law(x):\n    return x * {}\n" + (
        'def compose(law):\n    def loop(x: "f8") -> "f8":\n        return law(x)\n    return loop\nloop = compose(law)\n'
    )
    path = f"{tmp_path}{os.pathsep}{ROOT}"
    seen = []
    for constant in ("3.0", "4.0", "3.0"):
        law.write_text(text.format(constant))
        seen.append(python(script, PYTHONPATH=path, PYTHONDONTWRITEBYTECODE="1").split())
    assert seen == [["6.0"], ["8.0"], ["6.0"]]


def test_folder_and_entries_are_private(home: Path, monkeypatch) -> None:
    again(monkeypatch)
    if os.name == "posix":
        assert home.stat().st_mode & 0o777 == 0o700
        assert entry(home).stat().st_mode & 0o777 == 0o600
    assert [p.suffix for p in home.iterdir()] == [".o"]


@pytest.mark.parametrize("harm", ["flip", "cut", "empty", "foreign", "moved", "writable by others"])
def test_harm_is_noticed_and_repaired(home: Path, monkeypatch, harm: str) -> None:
    assert again(monkeypatch) == (EXPECTED, True)
    assert again(monkeypatch) == (EXPECTED, False)
    path = entry(home)
    whole = path.read_bytes()
    match harm:
        case "flip":
            path.write_bytes(whole[:-100] + bytes([whole[-100] ^ 4]) + whole[-99:])
        case "cut":
            path.write_bytes(whole[: len(whole) // 2])
        case "empty":
            path.write_bytes(b"")
        case "foreign":
            disk.keep(path.stem, b"no machine code at all")
        case "moved":
            path.unlink()
            store.kernel(word("root"))
            entry(home).rename(path)
        case "writable by others":
            path.chmod(0o666)
    assert again(monkeypatch) == (EXPECTED, True)
    assert path.read_bytes() == whole
    assert again(monkeypatch) == (EXPECTED, False)


def test_no_folder_can_be_made(tmp_path: Path, monkeypatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("PYLMP_CACHE", str(tmp_path / "file" / "store"))
    assert again(monkeypatch) == (EXPECTED, True)
    assert again(monkeypatch) == (EXPECTED, True)


@pytest.mark.parametrize("reason", [errno.EROFS, errno.EACCES, errno.ENOSPC])
def test_nothing_can_be_written(home: Path, monkeypatch, reason: int) -> None:
    """A read-only folder still gives what it holds; what it lacks is compiled each time."""

    def refuse(*_: object) -> int:
        raise OSError(reason, os.strerror(reason))

    assert again(monkeypatch) == (EXPECTED, True)
    monkeypatch.setattr(disk.os, "open", refuse)
    assert again(monkeypatch) == (EXPECTED, False)
    entry(home).unlink()
    assert again(monkeypatch) == again(monkeypatch) == (EXPECTED, True)
    assert not list(home.iterdir())


def test_where_the_folder_is(monkeypatch, tmp_path: Path) -> None:
    assert disk.folder() == tmp_path / "store"
    monkeypatch.delenv("PYLMP_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert disk.folder() == tmp_path / "pylmp"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert disk.folder() == tmp_path / ".cache" / "pylmp"


def test_several_processes_at_once(home: Path) -> None:
    environment = {**os.environ, "PYLMP_CACHE": str(home)}
    running = [
        subprocess.Popen([sys.executable, "-c", WARM], cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True)
        for _ in range(3)
    ]
    assert [process.communicate()[0].split()[0] for process in running] == [repr(EXPECTED)] * 3
    assert len(list(home.iterdir())) == 1


PREPARE = """
import sys
from pylmp.kernels.store import kernel, prepare
from tests.kernels.scenes import chain, line, soft, spring, word
functions = [chain(spring, soft), word('root'), chain(spring, soft, doubled=True)]
prepare(functions, sys.stdout.write)
print(kernel(functions[0]).bind(*line())(), 'numba' in sys.modules)
"""


def test_prepare_compiles_in_children_and_says_so_once(home: Path) -> None:
    first = python(PREPARE, PYLMP_CACHE=str(home)).splitlines()
    assert "3 kernels" in first[0]
    assert first[1:] == [f"{EXPECTED!r} {COMPILED_HERE}"]
    assert python(PREPARE, PYLMP_CACHE=str(home)).splitlines() == [f"{EXPECTED!r} False"]
    assert len(list(home.iterdir())) == 3


def test_work_a_child_does_not_deliver_is_done_here(monkeypatch) -> None:
    monkeypatch.setattr(workers, "_may_fork", lambda: True)
    monkeypatch.setattr(workers.os, "cpu_count", lambda: 2)
    monkeypatch.setattr(workers, "_deliver", lambda *_: os._exit(1))
    functions = [chain(spring, soft), word("root")]
    store.prepare(functions, lambda _: None)
    assert store.kernel(functions[0]).bind(*line())() == EXPECTED


def test_llvm_links_where_the_small_loader_cannot(monkeypatch) -> None:
    code = compiler.compile_object(chain(spring, soft))
    monkeypatch.setattr(load, "_load_elf", lambda _: (_ for _ in ()).throw(ValueError))
    assert store.Kernel(chain(spring, soft), code).bind(*line())() == EXPECTED


@pytest.mark.skipif(sys.platform != "linux" or platform.machine() != "x86_64", reason="the small loader's platform")
@pytest.mark.parametrize(
    ("function", "called"), [(transcendental(), b"pow"), (fill_and_copy(), b"memset"), (both_of_an_angle(), b"sincos")]
)
def test_the_small_loader_links_the_c_library(function, called: bytes, monkeypatch) -> None:
    assert called in compiler.compile_object(function)
    monkeypatch.setattr(load, "_load_llvm", lambda _: pytest.fail("left to LLVM"))
    x, other = np.arange(100.0), np.full(100, 7.0)
    expected_x, expected_other = x.copy(), other.copy()
    expected = function(expected_x, expected_other, 100, 0.7)
    assert store.kernel(function).bind(x, other, 100, 0.7)() == expected
    assert x.tobytes() == expected_x.tobytes()
    assert other.tobytes() == expected_other.tobytes()


def test_a_kernel_that_allocates_is_refused_by_name() -> None:
    with pytest.raises(TypeError, match="kernel hungry calls"):
        store.kernel(allocating())


def test_a_kernel_that_raises_is_refused_by_name() -> None:
    with pytest.raises(TypeError, match="kernel loud may raise"):
        store.kernel(raising())


def test_arguments_are_checked(home: Path) -> None:
    bind = store.kernel(chain(spring, soft)).bind
    x, f, kinds, n, k = line()
    for wrong in (x.astype(np.float32), x[::2], x.tolist(), x.astype(">f8")):
        with pytest.raises(TypeError, match="forces wants a contiguous float64 array"):
            bind(wrong, f, kinds, n, k)
    with pytest.raises(TypeError, match="int32"):
        bind(x, f, kinds.astype(np.int64), n, k)
    with pytest.raises(TypeError, match="takes 5 arguments, not 4"):
        bind(x, f, kinds, n)
    with pytest.raises(TypeError):
        bind(x, f, kinds, 2.5, k)
    assert bind(x, f, kinds, np.int64(n), np.float64(k))() == EXPECTED


def test_a_bound_call_keeps_its_arrays_alive_and_sees_them_change() -> None:
    x, f, kinds, n, k = line()
    call = store.kernel(chain(spring, soft)).bind(x.copy(), f, kinds, n, k)
    np.ones(1000)
    assert call() == EXPECTED
    call = store.kernel(chain(spring, soft)).bind(x, f, kinds, n, k)
    x *= 1.01
    assert call() == chain(spring, soft)(x, f.copy(), kinds, n, k) != EXPECTED


def test_one_function_is_walked_once(monkeypatch) -> None:
    function = chain(spring, soft)
    made = store.kernel(function)
    monkeypatch.setattr(store, "key", lambda _: pytest.fail("walked again"))
    assert store.kernel(function) is made


def test_equal_functions_share_a_kernel() -> None:
    assert key(chain(spring, soft)) == key(chain(spring, soft))
    assert store.kernel(chain(spring, soft)) is store.kernel(chain(spring, soft))
