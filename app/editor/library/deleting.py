"""Deleting a behavior: at once if nobody uses it, otherwise with a replacement for those who do."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QLabel,
    QListWidget,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ...core.amounts import counted
from ...core.edits import delete_automaton, users
from ...core.naming import natural
from ...core.vocabulary import BasicBehavior
from ..forms.choosing import Choice, Chooser
from ..forms.parts import Complaint, framed
from ..room import resize_within
from ..selection import BehaviorKey

if TYPE_CHECKING:
    from ..studio import Studio


def delete_behavior(studio: Studio, parent: QWidget, then: BehaviorKey | None = None) -> None:
    """Delete the behavior that is shown; ask for a replacement if something uses it.

    Args:
        then: The behavior to show afterwards.
    """
    shown = studio.selection.behavior
    if shown is None:
        return
    if users(studio.document.project, shown.type, shown.id):
        ReplaceDialog(studio, shown, parent, then).open()
    else:
        _delete(studio, shown, then, studio.document.attempt)


def _delete(
    studio: Studio,
    doomed: BehaviorKey,
    then: BehaviorKey | None,
    attempt: Callable[..., bool],
    *replacement: object,
) -> bool:
    """Delete a behavior, and say what went with it.

    Args:
        attempt: Carries an edit out, or says why it is refused.
    """
    project = studio.document.project
    name = project.library(doomed.type).get(doomed.id).name
    examples = len(project.examples_of(doomed.type, doomed.id))
    if not attempt(delete_automaton, doomed.type, doomed.id, *replacement):
        return False
    if then is not None:
        studio.selection.select_behavior(then)
    lost = f" with {counted(examples, 'example')}" if examples else ""
    studio.say(f"{name} was deleted{lost}; undo brings it back")
    return True


class ReplaceDialog(QDialog):
    """Names the users of a behavior, and lets the user choose what they use from now on.

    Attributes:
        chooser: The replacement.
        delete: Replaces and deletes.
    """

    def __init__(
        self, studio: Studio, behavior: BehaviorKey, parent: QWidget, then: BehaviorKey | None = None
    ) -> None:
        super().__init__(parent)
        self._then = then
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._studio = studio
        self._behavior = behavior
        document = studio.document
        doomed = document.project.library(behavior.type).get(behavior.id)
        self.setWindowTitle(f"Delete {doomed.name}")
        using = users(document.project, behavior.type, behavior.id)
        words = QLabel(
            f"{doomed.name} is used. Choose what these use instead, or close and change them first."
        )
        words.setWordWrap(True)
        listed = QListWidget()
        listed.setAccessibleName(f"Who uses {doomed.name}")
        listed.addItems(using)
        listed.setMaximumHeight(160)
        framed(listed, studio.theme)
        self.chooser = Chooser("Replacement", "choose a replacement")
        self.chooser.offer(self._choices())
        self.chooser.chosen.connect(lambda _: self.delete.setEnabled(self.chooser.choice is not None))
        self.trouble = Complaint(studio.theme)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.delete: QPushButton = buttons.addButton(
            "Replace and delete", QDialogButtonBox.ButtonRole.AcceptRole
        )
        self.delete.setEnabled(False)
        buttons.accepted.connect(self._accept)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.setSpacing(8)
        for part in (words, listed, self.chooser, self.trouble, buttons):
            column.addWidget(part)
        resize_within(self, 520, 280)
        self.chooser.setFocus()

    def _choices(self) -> list[Choice]:
        """All but what would come to run itself."""
        document, of = self._studio.document, self._behavior
        library = document.project.library(of.type)
        circular = {of.id, *library.all_users(of.id)}
        automata = sorted(library.automata.values(), key=lambda a: natural(a.name))
        choices = [Choice(a.name, a.id, "automaton") for a in automata if a.id not in circular]
        basics = document.vocabulary(of.type).behaviors.values()
        return choices + [Choice(basic.name, basic, basic.doc) for basic in basics]

    def _accept(self) -> None:
        choice, gone = self.chooser.choice, self.result() == QDialog.DialogCode.Accepted
        if choice is None or gone:
            return
        replacement = choice.value
        assert isinstance(replacement, str | BasicBehavior)
        then = BehaviorKey(self._behavior.type, replacement) if isinstance(replacement, str) else self._then
        attempt = partial(self.trouble.attempt, self._studio.document)
        if _delete(self._studio, self._behavior, then, attempt, replacement):
            self.accept()
