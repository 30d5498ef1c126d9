"""Whether a scenario's functions keep to what every engine does alike, found by reading them.

Compiled engines refuse much of the rest by themselves; what they would silently do in another way is found only here.
"""

import ast
import math
from collections.abc import Callable, Iterator
from inspect import getsource
from textwrap import dedent
from types import FunctionType
from typing import Any

from ..core.chance import uniform
from .scenario import Scenario

_BUILTINS = {f.__name__ for f in (abs, bool, float, int, max, min, range, round)}
#: These round differently, or not at all, when they are compiled.
_MATH = {name for name in vars(math) if not name.startswith("_")} - {
    "hypot",
    "fmod",
    "dist",
    "prod",
    "fsum",
    "sumprod",
}
_REFUSED: dict[type[ast.AST], str] = {
    ast.Try: "no exceptions",
    ast.Raise: "no exceptions",
    ast.Assert: "no exceptions",
    ast.With: "no 'with'",
    ast.Lambda: "no nested functions",
    ast.FunctionDef: "no nested functions",
    ast.ClassDef: "no classes",
    ast.Yield: "no generators",
    ast.YieldFrom: "no generators",
    ast.GeneratorExp: "no generators",
    ast.Await: "nothing asynchronous",
    ast.List: "no lists",
    ast.ListComp: "no lists",
    ast.Dict: "no dicts",
    ast.DictComp: "no dicts",
    ast.Set: "no sets",
    ast.SetComp: "no sets",
    ast.JoinedStr: "no strings",
    ast.Global: "state is in columns, and nowhere else",
    ast.Nonlocal: "state is in columns, and nowhere else",
    ast.Import: "imports belong to the beginning of the module",
    ast.ImportFrom: "imports belong to the beginning of the module",
    ast.Match: "no 'match'",
    ast.Delete: "no 'del'",
}


def faults(scenario: Scenario) -> list[str]:
    """What the scenario's functions, and those that they call, use against the contract; one line each."""
    found: dict[str, None] = {}
    seen: set[FunctionType] = set()
    waiting = list(_declared(scenario))
    while waiting:
        function = waiting.pop(0)
        if isinstance(function, FunctionType) and function not in seen and function is not uniform:
            seen.add(function)
            found |= dict.fromkeys(_faults(scenario, function))
            waiting += [value for value in _used(function) if isinstance(value, FunctionType)]
    return list(found)


def _declared(scenario: Scenario) -> Iterator[Callable[..., Any]]:
    """The functions that engines call; checks of parameters are not among them."""
    for table in (scenario.features, scenario.behaviors, scenario.targets, scenario.stages):
        yield from table.values()


def _faults(scenario: Scenario, function: FunctionType) -> Iterator[str]:
    first, where = function.__code__.co_firstlineno, f"scenario {scenario.name!r}, {function.__name__}"
    try:
        parsed = _parsed(function)
    except OSError:
        yield f"{where}: its source cannot be read"
        return
    for node, fault in _statements(parsed, function):
        yield f"{where}, line {first + node.lineno - 1}: {fault}"


def _parsed(function: FunctionType) -> ast.FunctionDef:
    parsed = ast.parse(dedent(getsource(function))).body[0]
    assert isinstance(parsed, ast.FunctionDef)
    return parsed


def _statements(parsed: ast.FunctionDef, function: FunctionType) -> Iterator[tuple[Any, str]]:
    """Every place in the body that breaks a rule, with what it breaks."""
    locals_ = function.__code__.co_varnames
    for node in _body(parsed):
        if type(node) in _REFUSED:
            yield node, _REFUSED[type(node)]
        elif isinstance(node, ast.BinOp | ast.AugAssign) and isinstance(node.op, ast.Pow):
            yield node, "** rounds differently when compiled"
        elif isinstance(node, ast.Constant) and not isinstance(node.value, int | float):
            yield node, f"only numbers, not {node.value!r}"
        elif isinstance(node, ast.Subscript) and _is_negative(node.slice):
            yield node, "no negative indices"
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "math":
            if node.attr not in _MATH:
                yield node, f"math.{node.attr} differs when compiled"
        elif isinstance(node, ast.Name) and node.id not in locals_:
            yield from ((node, fault) for fault in _outer(node.id, function))


def _body(parsed: ast.FunctionDef) -> Iterator[ast.AST]:
    """All nodes of a function's body but its docstring, annotations, and operators, which have no place of their own."""
    documented = ast.get_docstring(parsed) is not None
    waiting: list[ast.AST] = list(parsed.body[1 if documented else 0 :])
    while waiting:
        node = waiting.pop(0)
        yield node
        inner = [node.target, node.value] if isinstance(node, ast.AnnAssign) else ast.iter_child_nodes(node)
        waiting += [child for child in inner if child is not None and not isinstance(child, ast.operator)]


def _is_negative(index: ast.expr) -> bool:
    return (
        isinstance(index, ast.UnaryOp)
        and isinstance(index.op, ast.USub)
        and isinstance(index.operand, ast.Constant)
    )


def _outer(name: str, function: FunctionType) -> Iterator[str]:
    """What is wrong with using a name that is not a variable of the function."""
    if name in function.__code__.co_freevars:
        yield f"{name} belongs to a function around it"
    elif name not in function.__globals__:
        if name not in _BUILTINS:
            yield f"{name} is not among the functions that can be used: {', '.join(sorted(_BUILTINS))}"
    else:
        value = function.__globals__[name]
        if getattr(value, "__module__", None) == "math":
            if name not in _MATH:
                yield f"{name} differs when compiled"
        elif value is not math and not isinstance(value, int | float | FunctionType):
            yield f"{name} is {type(value).__name__}: only numbers, and functions of the same sort"


def _used(function: FunctionType) -> list[object]:
    """The values of the module that a function refers to."""
    return [function.__globals__[n] for n in function.__code__.co_names if n in function.__globals__]
