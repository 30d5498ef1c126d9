"""Charts of experiments, as plain values: means with their confidence, over time, over a factor, or in rows."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Band:
    """A line of means in a band of confidence.

    Attributes:
        color: Place in the color table.
        dash: 0 for a solid line; others tell lines apart a second time.
        low, high: The ends of the interval around each mean.
        marks: Each mean is a measurement of its own, not a point of a curve.
    """

    label: str
    color: int
    dash: int
    x: tuple[float, ...]
    y: tuple[float, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    marks: bool = False


@dataclass(frozen=True, slots=True)
class Dot:
    """A mean with its interval; *color* as in `Band`."""

    color: int
    mean: float
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class Row:
    """Means to be compared, one below the name of what they have in common."""

    label: str
    dots: tuple[Dot, ...]


@dataclass(frozen=True, slots=True)
class Plot:
    """One chart: either lines or rows."""

    title: str
    x_title: str
    bands: tuple[Band, ...] = ()
    rows: tuple[Row, ...] = ()


@dataclass(frozen=True, slots=True)
class Key:
    """What a color and a dash mean."""

    label: str
    color: int
    dash: int = 0


@dataclass(frozen=True, slots=True)
class Chart:
    """Plots under one title.

    Attributes:
        keys: What the lines are, where their names do not stand beside them.
    """

    title: str
    subtitle: str
    plots: tuple[Plot, ...]
    keys: tuple[Key, ...] = ()
