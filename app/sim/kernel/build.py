# mypy: disable-error-code="no-untyped-call"
"""The kernel of a scenario: generated once for each hash of all that it is made of, compiled once, kept on disk.

numba caches a compiled function beside the file that it stands in and looks at nothing but that file. So the name of the
generated file holds a hash of the scenario's functions, the kernel's own, and the versions of numba and Python.
"""

import atexit
import hashlib
import os
import re
import sys
from collections.abc import Callable
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from shutil import rmtree
from tempfile import TemporaryFile, mkdtemp
from threading import RLock
from types import FunctionType, ModuleType
from typing import Any

import numba
import numpy as np
from numba import types
from numba.core.errors import NumbaError
from numpy.typing import NDArray
from platformdirs import user_cache_path

from ...core.errors import UncompilableError
from ..scenario import Scenario
from . import columns, linking, tick, twins
from .source import (
    Layout,
    kernel_source,
    runs_places,
    scenario_functions,
    tables_places,
    world_places,
)

#: Told in a few words what takes time.
Notice = Callable[[str], None]
#: Words that say where columns begin, and numbers.
Block = NDArray[np.int64]
#: Steps a world: addresses of the blocks of the world, its program and its runs, how many ticks, and which part of them.
Kernel = Callable[..., None]

#: With more functions than this, those with loops are not put into their callers: compiling would take minutes.
MOST_INLINED = 25
_LOCK = RLock()
_KERNELS: dict[str, Kernel] = {}


def build(
    scenario: Scenario, layout: Layout, notice: Notice | None = None, folder: Path | None = None
) -> Kernel:
    """The compiled kernel of a scenario.

    Args:
        notice: Told when it has to be compiled, which takes some ten seconds.
        folder: Where generated modules are kept; the user's cache folder by default.

    Raises:
        UncompilableError: numba cannot compile one of the scenario's functions.
    """
    source = kernel_source(scenario, layout)
    name = _name(scenario, layout, source)
    with _LOCK:
        if name not in _KERNELS:
            path = writable(folder or cache_folder()) / f"{name}.py"
            _KERNELS[name] = _compiled(scenario, layout, source, path, notice)
        return _KERNELS[name]


def path_in(folder: Path, scenario: Scenario, layout: Layout) -> Path:
    """Where *folder* keeps the kernel of a scenario."""
    return folder / f"{_name(scenario, layout, kernel_source(scenario, layout))}.py"


def is_kept(path: Path) -> bool:
    """Whether a kernel was compiled, or refused, before."""
    return _refused(path).exists() or _is_compiled(path)


def _refused(path: Path) -> Path:
    return path.with_suffix(".refused")  # numba takes seconds to find out: once is enough


def _is_compiled(path: Path) -> bool:
    return bool(list(path.parent.glob(f"__pycache__/{path.stem}.*.nbi")))


def cache_folder() -> Path:
    """Where compiled kernels are kept."""
    return user_cache_path("understudy") / "kernels"


def writable(folder: Path) -> Path:
    """*folder*, made if need be; where nothing can be written, one for this process alone."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=folder):
            return folder
    except OSError:
        return _own_folder()


@cache
def _own_folder() -> Path:
    """A folder for this process alone, gone when it ends."""
    folder = Path(mkdtemp(prefix="understudy-kernels-"))
    atexit.register(rmtree, folder, ignore_errors=True)
    return folder


def _name(scenario: Scenario, layout: Layout, source: str) -> str:
    functions = {**scenario_functions(scenario), "run": tick.run}
    for module in (columns, twins, linking):
        source += Path(str(module.__file__)).read_text(encoding="utf-8")
    source += repr((world_places(layout), tables_places(), runs_places()))
    versions = f"{numba.__version__} {np.__version__} {sys.version}"
    return (
        "kernel_"
        + hashlib.sha256((linking.fingerprint(functions) + source + versions).encode()).hexdigest()[:24]
    )


def _compiled(scenario: Scenario, layout: Layout, source: str, path: Path, notice: Notice | None) -> Kernel:
    refused = _refused(path)
    if refused.exists():
        raise UncompilableError(refused.read_text(encoding="utf-8"))
    module = _loaded(scenario, layout, _written(path, source))
    try:
        if not _is_compiled(path):
            if notice is not None:
                notice(f"compiling the kernel of {scenario.name!r}, once")
            _compile_functions(scenario, layout, module)
        kernel: Kernel = module.kernel
        module.kernel.compile((types.int64,) * 5)
    except NumbaError as error:
        message = f"scenario {scenario.name!r} cannot be compiled: {_gist(error)}"
        refused.write_text(message, encoding="utf-8")
        raise UncompilableError(message) from error
    return kernel


def _compile_functions(scenario: Scenario, layout: Layout, module: ModuleType) -> None:
    """Compile the scenario's functions as the kernel will call them: what is wrong with one shows at once."""
    world = columns.BlockType(world_places(layout))
    for name, function in scenario_functions(scenario).items():
        others = function.__code__.co_argcount - 1
        getattr(module, name).compile((world, *[types.int64] * others))


def _written(path: Path, source: str) -> Path:
    """The file, whole at every moment, so that other processes may write and read the same one."""
    if not path.exists():
        part = path.with_name(f"{path.stem}.{os.getpid()}.part")
        part.write_text(source, encoding="utf-8")
        part.replace(path)
    return path


def _loaded(scenario: Scenario, layout: Layout, path: Path) -> ModuleType:
    """The generated module; numba finds it again by its name when it reads its cache."""
    spec = spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    functions = scenario_functions(scenario)
    linker = linking.Linker(
        _compile_one, twins.TWINS, tick.APART, inline_loops=len(functions) <= MOST_INLINED
    )
    vars(module).update({called: linker.linked(function) for called, function in functions.items()})
    vars(module).update(
        as_world=columns.block(world_places(layout)),
        as_tables=columns.block(tables_places()),
        as_runs=columns.block(runs_places()),
        compiled=numba.njit(nogil=True, cache=True),
        inlined=lambda function: _compile_one(function, inline=True),
        linked=lambda **instead: linker.linked(tick.run, instead),
    )
    sys.modules[path.stem] = module
    spec.loader.exec_module(module)
    return module


def _compile_one(function: FunctionType, *, inline: bool) -> Any:
    """A part of a kernel; Python never calls it, so it needs no wrappers."""
    return _njit(nogil=True, forceinline=inline, no_cpython_wrapper=True, no_cfunc_wrapper=True)(function)


#: Its stubs leave out what saves half the time of compiling.
_njit: Any = numba.njit


def _gist(error: NumbaError) -> str:
    """What numba says is wrong, and in which file and line."""
    lines = [_COLOR.sub("", line).strip() for line in str(error).splitlines()]
    told = [line.removeprefix(">>> ") for line in lines if line and not line.startswith("Failed in nopython")]
    what = " ".join(told[:2] if told[0].endswith(":") else told[:1])
    place = next((found for line in lines if (found := _PLACE.search(line))), None)
    return f"{Path(place[1]).name}, line {place[2]}: {what}" if place else what


_COLOR = re.compile(r"\x1b\[[0-9;]*m")
_PLACE = re.compile(r"^During: .* at (.+) \((\d+)\)$")
