"""Icons of one family, Material Design from qtawesome, in the colors of the palette."""

import qtawesome
from PySide6.QtGui import QIcon

from .theme import Theme, mixed


def icon(name: str, theme: Theme, color: str = "text") -> QIcon:
    """The icon *name* of the family, such as ``play``, in a color of the palette by its name."""
    colors = theme.palette
    off = mixed(colors.dim, colors.panel, 0.45)
    return qtawesome.icon(f"mdi6.{name}", color=theme.color(color), color_disabled=off)
