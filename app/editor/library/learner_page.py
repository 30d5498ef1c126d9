"""How a behavior learns and samples, and how well that goes."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QSlider,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from ...core.amounts import counted, exact
from ...core.automaton import Sampling, Settings
from ...core.edits import set_settings
from ...core.errors import UnderstudyError
from ...core.project import Project
from ...core.vocabulary import Vocabulary
from ...engine.worker import IsCancelled, Worker
from ...learner.builder import LearningCancelled
from ...learner.evaluation import BehaviorReport
from ...learner.registry import METHODS, Option
from ...learner.trainer import Key, learn, quiet
from ..forms.parts import Complaint, caption
from ..number_box import roomy
from .editing import Editing

#: The slider's confidence in percent, and where it begins when it is turned on (C4.5's own).
MOST_PERCENT, USUAL_PERCENT = 50, 25
#: Milliseconds without another change before the accuracy is estimated.
PATIENCE = 250
#: The row of the form at which the classifier's options begin: behind the classifier and what is said of it.
OPTIONS = 2
SAMPLINGS = {
    Sampling.SAMPLE: (
        "drawn at every tick",
        "The next state is drawn from the leaf's shares at every tick, as in the paper",
    ),
    Sampling.ARGMAX: ("always the most probable", "The state that most of the leaf's examples speak for"),
    Sampling.HOLD: (
        "drawn when the leaf changes",
        "Drawn again only when the situation leads to another leaf",
    ),
}
#: What an option is set by.
OptionField = QCheckBox | QDoubleSpinBox | QSpinBox


class LearnerPage(QWidget):
    """The form."""

    def __init__(self, editing: Editing) -> None:
        super().__init__()
        self._editing = editing
        self.classifier = QComboBox()
        self.classifier.setAccessibleName("Classifier")
        for method in METHODS.values():
            self.classifier.addItem(method.title, method.name)
            self.classifier.setItemData(self.classifier.count() - 1, method.doc, Qt.ItemDataRole.ToolTipRole)
        self.classifier.activated.connect(self._classifier_chosen)
        self.doc = caption("")
        self._form = QFormLayout()
        self.fields: dict[str, OptionField] = {}
        self._shown_method = ""
        self.sampling = QComboBox()
        self.sampling.setAccessibleName("How the next state is chosen")
        for value, (words, tip) in SAMPLINGS.items():
            self.sampling.addItem(words, value)
            self.sampling.setItemData(self.sampling.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)
        self.sampling.setToolTip("How the next state is chosen where examples disagree")
        self.sampling.activated.connect(lambda _: self._set(sampling=Sampling(self.sampling.currentData())))
        self._make_pruning()
        self.trouble = Complaint(editing.studio.theme)
        self.accuracy = QLabel()
        self.accuracy.setWordWrap(True)
        self.accuracy.setAccessibleName("How well it learns")
        self.accuracy.setText("Trying it out…")
        self._lay_out()
        self.validation = Validation(self)
        self.validation.told.connect(self.accuracy.setText)
        editing.studio.closing.connect(self.validation.close)
        self._soon = QTimer(self, interval=PATIENCE, singleShot=True)
        self._soon.timeout.connect(self._validate)
        editing.changed.connect(self.refresh)
        self.refresh()

    def _make_pruning(self) -> None:
        self.pruning = QCheckBox("Prune with confidence")
        self.pruning.setToolTip(
            "Pessimistic pruning: cuts branches that the examples do not speak for clearly"
        )
        self.pruning.clicked.connect(self._pruning_switched)
        self.confidence = QSlider(Qt.Orientation.Horizontal)
        self.confidence.setAccessibleName("Pruning confidence in percent")
        self.confidence.setToolTip("Smaller prunes more")
        self.confidence.setRange(1, MOST_PERCENT)
        self.confidence.valueChanged.connect(self._confidence_moved)
        self.confidence.sliderReleased.connect(self._editing.end_gesture)
        self.percent = QLabel()
        self.percent.setMinimumWidth(40)

    def _lay_out(self) -> None:
        strength = QHBoxLayout()
        strength.setSpacing(8)
        for part in (self.confidence, self.percent):
            strength.addWidget(part)
        form = self._form
        form.setHorizontalSpacing(16)
        form.addRow("Classifier", self.classifier)
        form.addRow("", self.doc)
        form.addRow("Next state", self.sampling)
        form.addRow(self.pruning, strength)
        column = QVBoxLayout(self)
        column.addLayout(form)
        column.addWidget(self.trouble)
        column.addSpacing(8)
        column.addWidget(caption("HOW WELL IT LEARNS"))
        column.addWidget(self.accuracy)
        column.addStretch(1)

    def refresh(self) -> None:
        """Show the settings as they are now."""
        automaton = self._editing.automaton
        if automaton is None:
            return
        settings = automaton.settings
        self.classifier.setCurrentIndex(self.classifier.findData(settings.classifier))
        method = METHODS.get(settings.classifier)
        self.doc.setText(method.doc if method else f"there is no classifier {settings.classifier!r}")
        self.classifier.setToolTip(self.doc.text())
        self._show_options(settings)
        self.sampling.setCurrentIndex(list(SAMPLINGS).index(settings.sampling))
        prunes = method is not None and method.prunes
        on = settings.pruning_confidence is not None
        self.pruning.setEnabled(prunes)
        self.pruning.setChecked(on)
        self.confidence.setEnabled(prunes and on)
        percent = round(100 * (settings.pruning_confidence or USUAL_PERCENT / 100))
        self.confidence.blockSignals(True)
        self.confidence.setValue(percent)
        self.confidence.blockSignals(False)
        self.percent.setText(f"{percent}%" if on else "off")
        if self.isVisible():
            self._soon.start()

    def _show_options(self, settings: Settings) -> None:
        method = METHODS.get(settings.classifier)
        if method is not None and method.name != self._shown_method:
            self._shown_method = method.name
            for _ in self.fields:
                self._form.removeRow(OPTIONS)
            self.fields = {option.name: self._field(option) for option in method.options}
            for place, option in enumerate(method.options, OPTIONS):
                field = self.fields[option.name]
                self._form.insertRow(place, "" if isinstance(field, QCheckBox) else option.title, field)
        for option in method.options if method else ():
            field, value = self.fields[option.name], settings.options.get(option.name, option.default)
            field.blockSignals(True)
            if isinstance(field, QCheckBox):
                field.setChecked(bool(value))
            elif isinstance(field, QSpinBox):
                field.setValue(int(value))
            else:
                field.setValue(value)
            field.blockSignals(False)

    def _field(self, option: Option) -> OptionField:
        return self._switch(option) if option.switch else self._number(option)

    def _switch(self, option: Option) -> QCheckBox:
        field = QCheckBox(option.title)
        field.setToolTip(f"{option.title}: {'on' if option.default else 'off'} at first")
        field.clicked.connect(lambda on: self._option_set(option.name, float(on)))
        field.clicked.connect(self._editing.end_gesture)
        return field

    def _number(self, option: Option) -> QDoubleSpinBox | QSpinBox:
        field: QDoubleSpinBox | QSpinBox
        if option.whole:
            field = roomy(QSpinBox())
            field.setRange(int(option.low), int(option.high))
        else:
            field = roomy(QDoubleSpinBox(decimals=6))
            field.setRange(option.low, option.high)
            field.setStepType(QDoubleSpinBox.StepType.AdaptiveDecimalStepType)
        field.setAccessibleName(option.title)
        field.setToolTip(
            f"{option.title}: {exact(option.low)} to {exact(option.high)}; {exact(option.default)} at first"
        )
        field.valueChanged.connect(lambda value: self._option_set(option.name, float(value)))
        field.editingFinished.connect(self._editing.end_gesture)
        return field

    # ------------------------------------------------------------------------------------------- changing

    def _set(self, *, gesture: str = "", **fields: object) -> None:
        automaton = self._editing.automaton
        if automaton is None:
            return
        changed = replace(automaton.settings, **fields)  # type: ignore[arg-type]  # by the names of its fields
        if changed != automaton.settings:
            self.trouble.say(self._editing.do(set_settings, changed, gesture=gesture))

    def _classifier_chosen(self) -> None:
        automaton, name = self._editing.automaton, str(self.classifier.currentData())
        if automaton is not None and name != automaton.settings.classifier:
            prunes = METHODS[name].prunes
            confidence = automaton.settings.pruning_confidence if prunes else None
            self._set(classifier=name, options={}, pruning_confidence=confidence)

    def _option_set(self, name: str, value: float) -> None:
        automaton = self._editing.automaton
        if automaton is not None:
            options = {**automaton.settings.options, name: value}
            self._set(options=options, gesture=f"option {name} of {self._editing.id}")

    def _pruning_switched(self, on: bool) -> None:  # noqa: FBT001 - Qt calls it so
        self._set(pruning_confidence=USUAL_PERCENT / 100 if on else None)

    def _confidence_moved(self, percent: int) -> None:
        self._set(pruning_confidence=percent / 100, gesture=f"confidence of {self._editing.id}")
        if not self.confidence.isSliderDown():
            self._editing.end_gesture()

    # ------------------------------------------------------------------------------------------- how well

    def showEvent(self, event: QShowEvent) -> None:
        """Estimate the accuracy as soon as somebody looks."""
        super().showEvent(event)
        self._soon.start()

    def hideEvent(self, event: QHideEvent) -> None:
        """Nobody looks."""
        super().hideEvent(event)
        self._soon.stop()

    def _validate(self) -> None:
        editing = self._editing
        examples = editing.project.examples_of(editing.type, editing.id)
        if not examples:
            self.accuracy.setText(
                "There is nothing to learn from yet: teach it, or write its transitions by hand."
            )
            return
        scenario = editing.studio.document.scenario.vocabulary
        self.validation.ask(editing.project, scenario, (editing.type, editing.id))


class Validation(QObject):
    """Learns a behavior again and again without a part of its examples, beside the window, to see how well it guesses them.

    Signals:
        told: What came of it, in words.
    """

    told = Signal(str)
    _ready = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._worker: Worker[tuple[Project, Vocabulary, Key], str] = Worker(
            _validated, lambda _question, why: f"learning failed: {why}", self._ready.emit, "validation"
        )
        self._ready.connect(self._take)

    def ask(self, project: Project, scenario: Vocabulary, key: Key) -> None:
        """Estimate this; an earlier question is given up."""
        self._worker.ask((project, scenario, key))

    def close(self) -> None:
        """End the thread."""
        self._worker.close()

    def _take(self) -> None:
        for answer in self._worker.answers():
            if answer:
                self.told.emit(answer)


def _validated(question: tuple[Project, Vocabulary, Key], cancelled: IsCancelled) -> str:
    project, scenario, key = question
    try:
        learned = learn(project, scenario, [key], quiet, cancelled, cross_validate=True)
    except UnderstudyError as error:
        return str(error)
    except LearningCancelled:
        return ""
    return report_words(learned.reports[0])


def report_words(report: BehaviorReport) -> str:
    """A line a state: how many of its examples are guessed right, seen and unseen."""
    lines = []
    for state in report.states:
        unseen = "" if state.cv_accuracy is None else f", {state.cv_accuracy:.0%} of those held out"
        nodes = f", {counted(state.nodes, 'node')}" if state.nodes else ""
        examples = counted(state.examples, "example")
        lines.append(f"from {state.name}: {examples}, fits {state.accuracy:.0%}{unseen}{nodes}")
    if report.left_out:
        first = report.left_out[0]
        lines.append(f"{len(report.left_out)} left out, the first because {first.reason}")
    return "\n".join(lines)
