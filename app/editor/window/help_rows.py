"""Help beside the lesson: all keys, and what this is."""

from __future__ import annotations

import platform
from functools import partial
from typing import TYPE_CHECKING

import PySide6
from PySide6.QtWidgets import QWidget

from ... import __version__
from ..actions import ActionRow
from ..documents.asking import Answer, Question
from ..preferences.dialog import open_preferences

if TYPE_CHECKING:
    from ..studio import Studio

ABOUT = "Teach behaviors to groups of simulated agents by showing them."


def help_rows(window: QWidget) -> tuple[ActionRow, ...]:
    """The actions."""
    return (
        ActionRow(
            "help.keys",
            "All keys…",
            "Help",
            lambda studio: open_preferences(studio, window, "keys"),
            "about",
            tip="What every key does, and other keys for it",
            icon="keyboard-outline",
        ),
        ActionRow(
            "help.about",
            "About Understudy…",
            "Help",
            partial(show_about, window=window),
            "about",
            tip="Which version this is",
            icon="information-outline",
        ),
    )


def show_about(studio: Studio, window: QWidget) -> Question:
    """Say which version this is, with what has to be known when something is reported."""
    details = (
        f"Understudy {__version__}\nPython {platform.python_version()}, Qt {PySide6.__version__}\n"
        f"{platform.platform()}"
    )
    question = Question(
        window,
        studio.theme,
        f"Understudy {__version__}",
        f"{ABOUT} Free software, under the MIT license.",
        (Answer("Close"),),
        details,
        "information-outline",
    )
    question.ask()
    return question
