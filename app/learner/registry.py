"""Every classifier that an automaton can be given: names, titles, options, and how each is fitted.

All stand behind one interface: a dataset goes in, a `Classifier` comes out. Trees and forests are values of the core,
are stored in the project and lower to tables. The others are fitted again from their examples when a project is loaded.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import isfinite

from ..core.amounts import exact
from ..core.automaton import Model, Refit, Settings
from ..core.errors import ParameterError
from ..core.transition import Classifier
from ..core.tree import Forest, Leaf, Tree
from .builder import Growth, IsCancelled, LearningCancelled, build, never
from .dataset import Dataset

Options = Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Option:
    """A number that the user can set.

    Attributes:
        low, high: The least and the greatest allowed value.
        whole: Whether it must be a whole number.
        switch: Whether it is 1 for yes and 0 for no.
    """

    name: str
    title: str
    default: float
    low: float
    high: float
    whole: bool = True
    switch: bool = False


@dataclass(frozen=True, slots=True)
class Method:
    """A way to learn a transition function.

    Attributes:
        fit: Fits examples of two labels or more, with at least one column; every option has a value.
        lowers: Whether what it learns is a tree or a forest, which run as tables.
        prunes: Whether pessimistic pruning applies.
    """

    name: str
    title: str
    doc: str
    fit: Callable[[Dataset, Options, IsCancelled], Classifier]
    options: tuple[Option, ...] = ()
    lowers: bool = False
    prunes: bool = False


def method(name: str) -> Method:
    """The method called *name*.

    Raises:
        ParameterError: There is none; the message names those there are.
    """
    if name not in METHODS:
        raise ParameterError(f"there is no classifier {name!r}; there are: {', '.join(METHODS)}")
    return METHODS[name]


def options_of(settings: Settings) -> Options:
    """A value for each option of the settings' classifier.

    Raises:
        ParameterError: The classifier or an option is unknown, or a value is out of its range.
    """
    known = {option.name: option for option in method(settings.classifier).options}
    for name, value in settings.options.items():
        if name not in known:
            there = ", ".join(known) or "none"
            raise ParameterError(f"{settings.classifier!r} has no option {name!r}; there are: {there}")
        _refuse_out_of_range(known[name], value)
    return {name: settings.options.get(name, option.default) for name, option in known.items()}


def _refuse_out_of_range(option: Option, value: float) -> None:
    if not (
        isfinite(value) and option.low <= value <= option.high and (not option.whole or value == int(value))
    ):
        kind = "a whole number" if option.whole else "a number"
        allowed = f"{kind} from {exact(option.low)} to {exact(option.high)}"
        raise ParameterError(f"the option {option.name!r} is {exact(value)}; it must be {allowed}")


def fit(data: Dataset, settings: Settings, cancelled: IsCancelled = never) -> Classifier:
    """A classifier for the examples of one state, of which there is at least one.

    Where there is nothing to tell apart, or nothing to tell it by, every method gives a single leaf.
    """
    options = options_of(settings)
    if data.one_class or not data.columns:
        return Tree(data.labels, Leaf(data.counts()))
    chosen = method(settings.classifier)
    fitted = chosen.fit(data, options, cancelled)
    if settings.pruning_confidence is not None and chosen.prunes and isinstance(fitted, Tree):
        from .pruning import pruned  # noqa: PLC0415 - scipy.special takes longer to load than most trees to learn

        return pruned(fitted, settings.pruning_confidence)
    return fitted


def stored(fitted: Classifier, settings: Settings) -> Model:
    """What a project keeps of a fitted classifier."""
    return fitted if isinstance(fitted, Tree | Forest) else Refit(settings.classifier)


# ------------------------------------------------------------------------------------------------- the methods


def _c45(data: Dataset, options: Options, cancelled: IsCancelled) -> Tree:
    growth = Growth(options["min_leaf"], int(options["max_depth"]), bool(options["gain_ratio"]))
    return build(data, growth, cancelled)


def _by_scikit_learn(name: str) -> Callable[[Dataset, Options, IsCancelled], Classifier]:
    """A method of `sklearn_backends` that is imported when it is first used: scikit-learn takes a second to load."""

    def fit_it(data: Dataset, options: Options, cancelled: IsCancelled) -> Classifier:
        from . import sklearn_backends  # noqa: PLC0415 - see above

        if cancelled():
            raise LearningCancelled
        return sklearn_backends.FITTERS[name](data, options)

    return fit_it


_MIN_LEAF = Option("min_leaf", "Fewest examples at a leaf", 1, 1, 1000)
_MAX_DEPTH = Option("max_depth", "Most tests on a way down (0: any)", 0, 0, 100)

METHODS: Mapping[str, Method] = {
    each.name: each
    for each in (
        Method(
            "c45",
            "Decision tree (C4.5)",
            "The paper's: gain ratio, arcs of angles, counts at the leaves.",
            _c45,
            (
                _MIN_LEAF,
                _MAX_DEPTH,
                Option("gain_ratio", "Choose by gain ratio, not by gain", 1, 0, 1, switch=True),
            ),
            lowers=True,
            prunes=True,
        ),
        Method(
            "cart",
            "Decision tree (CART)",
            "Gini impurity; angles are cut once, as if they were not circular.",
            _by_scikit_learn("cart"),
            (_MIN_LEAF, _MAX_DEPTH),
            lowers=True,
            prunes=True,
        ),
        Method(
            "forest",
            "Random forest",
            "The mean of many CART trees, each on a random sample of examples and features.",
            _by_scikit_learn("forest"),
            (Option("trees", "Trees", 30, 1, 500), _MIN_LEAF, _MAX_DEPTH),
            lowers=True,
        ),
        Method(
            "knn",
            "Nearest neighbors",
            "The labels of the most similar examples; weights of examples do not count.",
            _by_scikit_learn("knn"),
            (Option("neighbors", "Neighbors", 3, 1, 100),),
        ),
        Method(
            "logistic",
            "Logistic regression",
            "A soft linear border between labels.",
            _by_scikit_learn("logistic"),
            (
                Option(
                    "strength", "Trust in the examples (inverse of regularization)", 1, 1e-4, 1e6, whole=False
                ),
            ),
        ),
        Method(
            "bayes",
            "Naive Bayes",
            "A bell curve for each feature and label.",
            _by_scikit_learn("bayes"),
            (Option("smoothing", "Least variance, as a share of the largest", 1e-3, 1e-12, 1, whole=False),),
        ),
        Method(
            "mlp",
            "Neural network",
            "One hidden layer.",
            _by_scikit_learn("mlp"),
            (
                Option("hidden", "Hidden units", 16, 1, 256),
                Option("steps", "Most training steps", 500, 10, 5000),
            ),
        ),
    )
}
