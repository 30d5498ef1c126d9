"""The colors of the program, dark and light; text stands out from its ground by at least 4.5 : 1."""

from dataclasses import dataclass

#: One color per behavior, told apart in color-blind vision, too (Okabe and Ito); basic behaviors are grey.
OKABE_ITO = ("#E69F00", "#56B4E9", "#009E73", "#F0E442", "#0072B2", "#D55E00", "#CC79A7")
BASIC = "#8C94A3"


@dataclass(frozen=True, slots=True)
class Palette:
    """Colors by what they are for.

    Attributes:
        lines: Of a chart, in order: those of Okabe and Ito that stand out on this ground.
    """

    background: str
    panel: str
    raised: str
    hairline: str
    text: str
    dim: str
    accent: str
    teach: str
    good: str
    canvas: str
    grid: str
    lines: tuple[str, ...]


DARK = Palette(
    background="#16181d",
    panel="#1e2128",
    raised="#272b34",
    hairline="#343945",
    text="#e6e8ec",
    dim="#9aa1ae",
    accent="#5b9dff",
    teach="#ff6b5e",
    good="#4fbf7a",
    canvas="#12141a",
    grid="#1b1e26",
    lines=("#56B4E9", "#E69F00", "#009E73", "#CC79A7", "#F0E442", "#D55E00"),
)
LIGHT = Palette(
    background="#eceef2",
    panel="#fafbfc",
    raised="#ffffff",
    hairline="#d5d9e0",
    text="#1d2129",
    dim="#5d6675",
    accent="#1f5fca",
    teach="#c22d20",
    good="#17703c",
    canvas="#f4f5f8",
    grid="#e6e8ee",
    lines=("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"),
)
