"""What the target slots of a state or a feature stand for while the automaton that holds it runs."""

from collections.abc import Iterable

from .actor import Actor, Argument, Arguments, Run
from .automaton import State
from .errors import BindingError
from .features import Bindings, FeatureUse, Ground, Parameter


def bind(
    slots: Iterable[str], bindings: Bindings, actor: Actor, run: Run, place: State | FeatureUse
) -> Arguments:
    """The arguments of *slots* in *place*, a state or feature of the automaton that *run* is.

    A ground target is owned by the node that runs the automaton; an argument of the automaton keeps its owner.

    Raises:
        BindingError: A slot is open, or bound to a parameter that the automaton has no argument for.
    """
    bound = {}
    for slot in slots:
        binding = bindings.get(slot)
        if isinstance(binding, Ground):
            bound[slot] = Argument(binding.target, actor.node.id)
        elif binding is not None and binding.name in run.arguments:
            bound[slot] = run.arguments[binding.name]
        else:
            raise _open(slot, binding, run, place)
    return bound


def _open(slot: str, binding: Parameter | None, run: Run, place: State | FeatureUse) -> BindingError:
    kind, name = ("state", place.name or place.id) if isinstance(place, State) else ("feature", place.shown)
    what = f"{slot!r} of {kind} {name!r} of {run.behavior.name!r}"
    if binding is None:
        return BindingError(f"{what} is open: pick a target or a parameter")
    there = ", ".join(run.behavior.parameters) or "none"
    return BindingError(
        f"{what} is bound to {binding.name!r}, which has no target now; parameters are: {there}"
    )
