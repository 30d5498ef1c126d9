"""What a behavior looks at, also after it was demonstrated: old examples get their values from stored moments."""

from __future__ import annotations

from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout, QWidget

from ...core.automaton import Automaton
from ...core.edits import add_feature, drop_feature, move_feature, rebind_feature, rename_feature, tests_of
from ...core.features import FeatureUse
from ..forms.buttons import stand_back
from ..forms.ordered_list import Item, OrderedList
from ..forms.parts import Complaint, caption, side_by_side
from .editing import Editing
from .source_form import SourceForm

FORCE = "Drop it, and the rules and prunes that test it"


EMPTY = (
    "What the behavior looks at when it decides: a distance, whether a box is in sight, the flag of what it runs. "
    "Choose it below. Features can be added later, too, also to what was taught already."
)


class FeaturesPage(QWidget):
    """The list of features, the one that is chosen in full, and a form to add one."""

    def __init__(self, editing: Editing) -> None:
        super().__init__()
        self._editing = editing
        theme = editing.studio.theme
        self.features = OrderedList("Features", theme, empty=EMPTY)
        self.features.chosen.connect(lambda _: self._show_chosen())
        self.features.moved.connect(lambda key, to: self._say(editing.do(move_feature, key, to)))
        self.features.removed.connect(self._remove)
        self.new = SourceForm()
        self.new.changed.connect(self._ready)
        self.new.what.field.textChanged.connect(lambda _: self._ready())
        self.new.what.entered.connect(self._entered)
        self.new.entered.connect(self._pressed)
        self.add = QPushButton("Add feature")
        self.add.setToolTip("Let the behavior look at this, too")
        stand_back(self.add)
        self.add.clicked.connect(self._pressed)
        self.missing = caption("")
        self.trouble = Complaint(theme)
        self.force = QPushButton(FORCE)
        self.force.setToolTip("The feature goes, and what tests it; undo brings all of it back")
        stand_back(self.force)
        self.force.hide()
        self.force.clicked.connect(self._force)
        self.source = SourceForm()
        self.source.changed.connect(self._rebound)
        self.name = QLineEdit()
        self.name.setAccessibleName("Name of the feature")
        self.name.setToolTip("Another name for the feature; without one it is called as what it looks at")
        self.name.editingFinished.connect(self._named)
        self.measured = caption("")
        self.detail = QWidget()
        self._lay_out()
        editing.changed.connect(self.refresh)
        self.refresh()

    def _lay_out(self) -> None:
        form = QFormLayout(self.detail)
        form.setContentsMargins(0, 0, 0, 0)
        form.addRow("Looks at", self.source)
        form.addRow("Name", self.name)
        form.addRow(self.measured)
        left, right = QVBoxLayout(), QVBoxLayout()
        left.addWidget(self.features, 1)
        right.addWidget(self.detail)
        right.addStretch(1)
        adding = QHBoxLayout()
        adding.addWidget(self.new, 1)
        button = QVBoxLayout()
        button.addWidget(self.add)
        button.addStretch(1)
        adding.addLayout(button)
        column = QVBoxLayout(self)
        column.addLayout(side_by_side(left, right), 1)
        column.addLayout(adding)
        for below in (self.missing, self.trouble, self.force):
            column.addWidget(below)

    @property
    def _automaton(self) -> Automaton | None:
        return self._editing.automaton

    @property
    def _feature(self) -> FeatureUse | None:
        uses = () if self._automaton is None else self._automaton.features
        return next((use for use in uses if use.id == self.features.current), None)

    def refresh(self, chosen: str = "") -> None:
        """Show the features as they are now."""
        automaton, scope = self._automaton, self._editing.scope
        if automaton is None or scope is None:
            return
        self.features.show_items((Item(use.id, use.shown) for use in automaton.features), chosen)
        if self.new.what.choice is None and not self.new.what.field.hasFocus():
            self.new.offer(scope, automaton, None)
        self._ready()

    def _show_chosen(self) -> None:
        use, automaton, scope = self._feature, self._automaton, self._editing.scope
        self.detail.setVisible(use is not None)
        self.force.hide()
        if use is None or automaton is None or scope is None:
            return
        self.source.offer(scope, automaton, use.source)
        if self.name.text() != use.name and not self.name.hasFocus():
            self.name.setText(use.name)
        self.name.setPlaceholderText(use.shown)
        self.measured.setText(self._measured_words(use))

    def _measured_words(self, use: FeatureUse) -> str:
        """How many examples have a value of it."""
        examples = self._editing.project.examples_of(self._editing.type, self._editing.id)
        lacking = [e for e in examples if use.id not in e.values]
        if not lacking:
            all_of_them = (
                "The one example has" if len(examples) == 1 else f"All {len(examples)} examples have"
            )
            return f"{all_of_them} its value." if examples else "No examples yet."
        kept = sum(bool(e.snapshot) for e in lacking)
        return f"{len(lacking)} of {len(examples)} examples lack its value; it is read from the stored moments of {kept}."

    def _ready(self) -> None:
        missing = self.new.missing
        self.add.setEnabled(not missing)
        typed = bool(self.new.what.currentText().strip())
        self.missing.setText(missing[:1].upper() + missing[1:] + "." if missing and typed else "")
        self.missing.setVisible(bool(self.missing.text()))

    def _entered(self) -> None:
        """Enter goes on to what is left to choose, or else adds the feature."""
        if not self.new.go_on():
            self._add()

    def _pressed(self) -> None:
        if self.new.source is not None:
            self.new.what.field.setFocus()  # for the next one: the button has nothing to add then
            self._add()

    def _add(self) -> None:
        source, automaton, scope = self.new.source, self._automaton, self._editing.scope
        if source is None or automaton is None or scope is None:
            return
        before = {use.id for use in automaton.features}
        if not self._say(self._editing.do(add_feature, source)):
            self.new.offer(scope, automaton, None)
            after = self._automaton.features if self._automaton else ()
            self.refresh(next((use.id for use in after if use.id not in before), ""))

    def settle(self) -> bool:
        """Add what was composed but not added yet; whether nothing is left half done."""
        self._add()
        return not self.new.what.currentText().strip()

    def _remove(self, key: str) -> None:
        message = self._say(self._editing.do(drop_feature, key))
        self.force.setVisible(bool(message) and bool(self._automaton and tests_of(self._automaton, key)))

    def _force(self) -> None:
        self.force.hide()
        self._say(self._editing.do(drop_feature, self.features.current, force=True))

    def _rebound(self) -> None:
        use, source = self._feature, self.source.source
        if use is not None and source is not None and source != use.source:
            self._say(self._editing.do(rebind_feature, use.id, source))

    def _named(self) -> None:
        use = self._feature
        if use is not None and self.name.text().strip() != use.name:
            self._say(self._editing.do(rename_feature, use.id, self.name.text().strip()))

    def _say(self, message: str) -> str:
        self.trouble.say(message)
        return message
