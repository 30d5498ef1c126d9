"""Classifiers of scikit-learn behind the learner's interface; nothing else here or elsewhere imports it.

*CART and random forests* become trees of our own. scikit-learn compares in single precision, so it is given the ranks
of values instead, which are exact, and thresholds are then placed between the values themselves by the same rule as
the builder's. Categories are told apart one against the rest. Angles are plain numbers in [-period/2, period/2): a cut
does not know that both ends meet, so a range across the seam needs two cuts where the builder's arc needs one test.

*The others* see angles as sine and cosine, categories as one column each, and all columns with mean 0 and deviation 1.

Everything is seeded: the same examples give the same classifier.
"""

import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np
from sklearn.ensemble import RandomForestClassifier
from sklearn.exceptions import ConvergenceWarning
from sklearn.linear_model import LogisticRegression
from sklearn.naive_bayes import GaussianNB
from sklearn.neighbors import KNeighborsClassifier
from sklearn.neural_network import MLPClassifier
from sklearn.tree import DecisionTreeClassifier
from sklearn.utils.validation import has_fit_parameter

from ..core.conditions import AtMost, Equals, InArc, Test, Values
from ..core.transition import Classifier
from ..core.tree import Branch, Decision, Forest, Leaf, Tree, TreeNode
from ..core.vocabulary import FeatureKind
from .dataset import Column, Dataset, Flags, Floats, Integers
from .splits import Side, cut, threshold

SEED = 0
#: Steps into which `hold` divides probabilities: it draws anew when one of them moves to another step.
STEPS = 10

Options = Mapping[str, float]


def _categories(values: Floats) -> Floats:
    """The values to tell apart from the rest: of two only the higher, since the other is the rest."""
    seen = np.unique(values)
    return seen[1:] if len(seen) == 2 else seen


# ---------------------------------------------------------------------------------------------- trees


@dataclass(frozen=True, slots=True, eq=False)
class _Encoded:
    """One column as scikit-learn's trees see it: ranks, or 1 where a category is *value* and 0 elsewhere."""

    place: int
    value: float | None
    numbers: Floats


def _encoded(data: Dataset) -> list[_Encoded]:
    found: list[_Encoded] = []
    for place, column in enumerate(data.columns):
        values = data.x[:, place]
        if column.kind in (FeatureKind.BOOLEAN, FeatureKind.CATEGORICAL):
            found += (
                _Encoded(place, float(v), np.asarray(values == v, np.float64)) for v in _categories(values)
            )
        else:
            found.append(
                _Encoded(place, None, np.asarray(np.unique(values, return_inverse=True)[1], np.float64))
            )
    return found


def _cart(data: Dataset, options: Options) -> Tree:
    encoded = _encoded(data)
    estimator = DecisionTreeClassifier(random_state=SEED, **_growth(options))
    estimator.fit(_matrix(encoded), data.y, sample_weight=data.weight)
    return _tree(estimator.tree_, estimator.classes_, data, encoded)


def _forest(data: Dataset, options: Options) -> Forest:
    encoded = _encoded(data)
    estimator = RandomForestClassifier(int(options["trees"]), random_state=SEED, **_growth(options))
    estimator.fit(_matrix(encoded), data.y, sample_weight=data.weight)
    trees = (_tree(each.tree_, estimator.classes_, data, encoded) for each in estimator.estimators_)
    return Forest(data.labels, tuple(trees))


def _growth(options: Options) -> dict[str, Any]:
    return {"min_samples_leaf": int(options["min_leaf"]), "max_depth": int(options["max_depth"]) or None}


def _matrix(encoded: list[_Encoded]) -> Floats:
    return np.column_stack([each.numbers for each in encoded])


def _tree(fitted: Any, classes: Integers, data: Dataset, encoded: list[_Encoded]) -> Tree:
    """scikit-learn's tree as ours: the same examples in the same leaves, with the counts that it was grown from."""
    counts = np.zeros((fitted.node_count, len(data.labels)))
    counts[:, classes] = fitted.value[:, 0, :] * fitted.weighted_n_node_samples[:, None]
    rows = {0: np.arange(len(data))}
    tests: dict[int, tuple[Test, int, int]] = {}
    for number in range(fitted.node_count):  # a parent comes before its children
        low, high = int(fitted.children_left[number]), int(fitted.children_right[number])
        if low >= 0:
            each = encoded[fitted.feature[number]]
            mine = rows.pop(number)
            goes_low = each.numbers[mine] <= fitted.threshold[number]
            rows[low], rows[high] = mine[goes_low], mine[~goes_low]
            test = _test(each, data, rows[low], rows[high])
            tests[number] = (test, high, low) if isinstance(test, Equals) else (test, low, high)
    return Tree(data.labels, _assembled(tests, np.asarray(np.round(counts, 9), np.float64)))


def _assembled(tests: Mapping[int, tuple[Test, int, int]], counts: Floats) -> TreeNode:
    nodes: list[TreeNode] = [Leaf(tuple(row)) for row in counts.tolist()]
    for number in sorted(tests, reverse=True):
        test, yes, no = tests[number]
        nodes[number] = Branch(test, nodes[yes], nodes[no], nodes[number].counts)
    return nodes[0]


def _test(each: _Encoded, data: Dataset, low: Integers, high: Integers) -> Test:
    """The test that sends rows *low* and *high* to different sides."""
    column, values = data.columns[each.place], data.x[:, each.place]
    if each.value is not None:
        return Equals(column.feature, each.value)
    sides = _side(values, data.continuation, low, max), _side(values, data.continuation, high, min)
    if column.kind is FeatureKind.TOROIDAL:
        return InArc(column.feature, min(-column.period / 2, float(values.min())), cut(*sides))
    return AtMost(column.feature, threshold(*sides))


def _side(values: Floats, continuation: Flags, rows: Integers, nearest: Callable[[Floats], float]) -> Side:
    value = float(nearest(values[rows]))
    return Side(value, bool(continuation[rows][values[rows] == value].all()))


# ---------------------------------------------------------------------------------------------- the others


@dataclass(frozen=True, slots=True, eq=False)
class _Encoding:
    """Rows of a dataset as standardized numbers without constant columns.

    Attributes:
        categories: For each column, the values that become columns of their own; empty where it is not categorical.
        kept: Which encoded columns vary.
        scale, mean, deviation: Of those; values are divided by *scale* first, so that nothing overflows.
    """

    columns: tuple[Column, ...]
    categories: tuple[Floats, ...]
    kept: Integers
    scale: Floats
    mean: Floats
    deviation: Floats

    def of(self, x: Floats) -> Floats:
        """Rows as the estimators see them."""
        raw = _raw(self.columns, self.categories, x)[:, self.kept]
        return np.asarray((raw / self.scale - self.mean) / self.deviation, np.float64)


def _encoding(data: Dataset) -> _Encoding:
    categories = tuple(
        _categories(values) if column.kind is FeatureKind.CATEGORICAL else np.empty(0)
        for column, values in zip(data.columns, data.x.T, strict=True)
    )
    raw = _raw(data.columns, categories, data.x)
    kept = np.flatnonzero(np.any(raw != raw[:1], axis=0))
    scale = np.abs(raw[:, kept]).max(axis=0, initial=0.0)
    scaled = raw[:, kept] / scale
    deviation = scaled.std(axis=0)
    # Values may differ by so little that nothing is left of it in the mean.
    deviation[deviation == 0.0] = 1.0
    return _Encoding(data.columns, categories, kept, scale, scaled.mean(axis=0), deviation)


def _raw(columns: tuple[Column, ...], categories: tuple[Floats, ...], x: Floats) -> Floats:
    parts: list[Floats] = []
    for column, seen, values in zip(columns, categories, x.T, strict=True):
        if column.kind is FeatureKind.TOROIDAL:
            angle = values * (2 * pi / column.period)
            parts += (np.sin(angle), np.cos(angle))
        elif column.kind is FeatureKind.CATEGORICAL:
            parts += (np.asarray(values == value, np.float64) for value in seen)
        else:
            parts.append(values)
    return np.column_stack(parts)


class Fitted:
    """A fitted estimator as a classifier.

    Attributes:
        labels: Ids of states.
    """

    def __init__(self, data: Dataset, encoding: _Encoding, estimator: Any) -> None:
        self.labels = data.labels
        self._encoding = encoding
        self._estimator = estimator

    def decide(self, values: Values) -> Decision:
        """The probabilities; the key is the step that each of them is on."""
        row = np.array([[values(column.feature) for column in self._encoding.columns]])
        found = self.probabilities(row)[0].tolist()
        return Decision(tuple(round(STEPS * p) for p in found), tuple(found))

    def probabilities(self, x: Floats) -> Floats:
        """The probabilities of the labels for many rows, rows by labels."""
        found = np.zeros((len(x), len(self.labels)))
        if len(x):
            found[:, self._estimator.classes_] = self._estimator.predict_proba(self._encoding.of(x))
        return found


def _fitted(data: Dataset, make: Callable[[], Any]) -> Classifier:
    encoding = _encoding(data)
    if not len(encoding.kept):
        return Tree(data.labels, Leaf(data.counts()))
    estimator = make()
    weights = {"sample_weight": data.weight} if has_fit_parameter(estimator, "sample_weight") else {}
    with warnings.catch_warnings():
        # Not having converged is no fault of the user's; the report shows how good the classifier is.
        warnings.simplefilter("ignore", ConvergenceWarning)
        estimator.fit(encoding.of(data.x), data.y, **weights)
    return Fitted(data, encoding, estimator)


def _knn(data: Dataset, options: Options) -> Classifier:
    return _fitted(data, lambda: KNeighborsClassifier(min(int(options["neighbors"]), len(data))))


def _logistic(data: Dataset, options: Options) -> Classifier:
    return _fitted(data, lambda: LogisticRegression(C=options["strength"], max_iter=1000, random_state=SEED))


def _bayes(data: Dataset, options: Options) -> Classifier:
    return _fitted(data, lambda: GaussianNB(var_smoothing=options["smoothing"]))


def _mlp(data: Dataset, options: Options) -> Classifier:
    hidden, steps = int(options["hidden"]), int(options["steps"])
    return _fitted(
        data, lambda: MLPClassifier((hidden,), solver="lbfgs", alpha=1e-3, max_iter=steps, random_state=SEED)
    )


FITTERS: Mapping[str, Callable[[Dataset, Options], Classifier]] = {
    "cart": _cart,
    "forest": _forest,
    "knn": _knn,
    "logistic": _logistic,
    "bayes": _bayes,
    "mlp": _mlp,
}
