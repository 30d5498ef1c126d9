"""Plain functions made compiled ones: each is given fresh globals in which the functions that it calls are compiled too.

The originals stay as they are; the reference engine goes on calling them.
"""

import hashlib
from collections.abc import Collection, Iterator, Mapping
from dis import get_instructions
from types import CodeType, FunctionType, ModuleType
from typing import Any, Protocol


class Compile(Protocol):
    """Turns a function into a compiled one."""

    def __call__(self, function: FunctionType, *, inline: bool) -> Any:
        """The compiled twin; *inline* asks for it to become part of its callers."""


class Linker:
    """Compiles functions with all that they call, each once.

    Attributes:
        apart: Functions that stay out of their callers.
        inline_loops: Whether functions with loops become part of their callers, too: faster, slower to compile.
    """

    def __init__(
        self,
        compile_one: Compile,
        twins: Mapping[Any, Any],
        apart: Collection[Any] = (),
        *,
        inline_loops: bool = True,
    ) -> None:
        self._compile = compile_one
        self._done: dict[Any, Any] = dict(twins)
        self._apart = apart
        self._inline_loops = inline_loops

    def linked(self, function: Any, instead: Mapping[str, Any] | None = None) -> Any:
        """The compiled twin of *function*; *instead* names functions to be put in the place of those it calls."""
        if function in self._done:
            return self._done[function]
        if not isinstance(function, FunctionType):
            return function
        namespace = dict(function.__globals__)
        bound = FunctionType(
            function.__code__, namespace, function.__name__, function.__defaults__, function.__closure__
        )
        inline = function not in self._apart and (self._inline_loops or not _has_loop(function.__code__))
        self._done[function] = made = self._compile(bound, inline=inline)
        for name, value in referred(function).items():
            if instead is not None and name in instead:
                namespace[name] = instead[name]
            elif isinstance(value, FunctionType):
                namespace[name] = self.linked(value, instead)
        return made


def referred(function: FunctionType) -> Mapping[str, Any]:
    """The globals that a function refers to."""
    return {
        name: function.__globals__[name] for name in _names(function.__code__) if name in function.__globals__
    }


def _names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _has_loop(code: CodeType) -> bool:
    return any("JUMP_BACKWARD" in instruction.opname for instruction in get_instructions(code))


def fingerprint(functions: Mapping[str, Any]) -> str:
    """A hash of what functions do: their code, that of all they call, and the constants that they use."""
    digest = hashlib.sha256()
    seen: set[int] = set()

    def add(value: Any) -> None:
        if isinstance(value, FunctionType):
            digest.update(f"function {value.__name__} {value.__defaults__!r}".encode())
            if id(value) not in seen:
                seen.add(id(value))
                add(value.__code__)
                for cell in value.__closure__ or ():
                    add(cell.cell_contents)
                for name, used in sorted(referred(value).items()):
                    digest.update(name.encode())
                    add(used)
        elif isinstance(value, CodeType):
            digest.update(value.co_code)
            digest.update(value.co_exceptiontable)
            digest.update(
                repr((value.co_names, value.co_varnames, value.co_freevars, value.co_argcount)).encode()
            )
            for constant in value.co_consts:
                add(constant)
        elif isinstance(value, ModuleType):
            digest.update(f"module {value.__name__}".encode())
        elif hasattr(value, "tobytes"):
            digest.update(value.tobytes())
        elif isinstance(value, int | float | str | bytes | tuple | bool | None):
            digest.update(repr(value).encode())
        else:
            digest.update(f"{type(value).__name__} {getattr(value, '__name__', '')}".encode())

    for name, function in sorted(functions.items()):
        digest.update(name.encode())
        add(function)
    return digest.hexdigest()
