"""Tables of experiments that grow while they are looked at."""

from PySide6.QtGui import QStandardItem, QStandardItemModel
from pytestqt.qtbot import QtBot

from app.editor.experiments.tables import table_view


def test_a_row_that_comes_later_has_the_room_that_its_words_need(qtbot: QtBot) -> None:
    model = QStandardItemModel(0, 2)
    view = table_view(model, "runs")
    qtbot.addWidget(view)
    view.resize(800, 300)
    with qtbot.waitExposed(view):
        view.show()
    for name in ("one level", "independent agents, trained"):
        model.appendRow([QStandardItem(name), QStandardItem("1")])
    needed = view.fontMetrics().horizontalAdvance("independent agents, trained")
    assert view.columnWidth(0) > needed
