"""`understudy bench`: what it prints, what it leaves out, and what it refuses."""

import json
from collections.abc import Callable

import pytest

from app.cli import bench, main
from app.cli.bench import MEASURES, choose, shown
from app.core.errors import ParameterError
from app.engine.bench.figures import Better, Measure
from app.engine.bench.subject import Subject, UnmeasurableError

Take = Callable[[Subject], float]


def stopped(_: Subject) -> float:
    raise KeyboardInterrupt


def impossible(_: Subject) -> float:
    raise UnmeasurableError("there is no sea here")


def measure(name: str, take: Take, long: bool = False) -> Measure:
    return Measure(name, take, "knots", 10.0, Better.HIGHER, long)


def put(monkeypatch: pytest.MonkeyPatch, *measures: Measure) -> None:
    monkeypatch.setattr(bench, "MEASURES", measures)
    monkeypatch.setattr(bench, "is_busy", lambda _: False)


def test_json_has_the_keys_that_others_rely_on(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put(monkeypatch, measure("sailing", lambda _: 12.5), measure("rowing", lambda _: 3.0))
    assert main(["bench", "--json"]) == 0
    out, err = capsys.readouterr()
    document = json.loads(out)
    assert err == ""
    assert set(document) == {"machine", "figures"}
    assert document["machine"]["cores"] >= 1
    assert [figure["holds"] for figure in document["figures"]] == [True, False]
    assert document["figures"][0] == {
        "name": "sailing",
        "value": 12.5,
        "unit": "knots",
        "goal": 10.0,
        "better": "higher",
        "holds": True,
    }


def test_people_get_a_table_and_a_missed_goal_is_no_failure(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put(monkeypatch, measure("sailing", lambda _: 12.5), measure("rowing", lambda _: 3.0))
    assert main(["bench"]) == 0
    rows = {line.split()[0]: line for line in capsys.readouterr().out.splitlines() if line.strip()}
    assert "12.5" in rows["sailing"]
    assert "yes" in rows["sailing"]
    assert "≥ 10" in rows["rowing"]
    assert "no" in rows["rowing"]
    assert "1 of 2 goals reached" in rows["1"]


def test_an_interrupt_keeps_what_was_measured(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put(
        monkeypatch,
        measure("sailing", lambda _: 12.5),
        measure("rowing", stopped),
        measure("diving", stopped),
    )
    assert main(["bench", "--json"]) == 130
    out, err = capsys.readouterr()
    assert [figure["name"] for figure in json.loads(out)["figures"]] == ["sailing"]
    assert "interrupted" in err


def test_what_cannot_be_measured_is_left_out_with_its_reason(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put(monkeypatch, measure("sailing", impossible), measure("rowing", lambda _: 3.0))
    assert main(["bench", "--json"]) == 0
    out, err = capsys.readouterr()
    assert [figure["name"] for figure in json.loads(out)["figures"]] == ["rowing"]
    assert "'sailing' is left out: there is no sea here" in err


def test_a_busy_machine_is_told_on_stderr(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    put(monkeypatch, measure("sailing", lambda _: 12.5))
    monkeypatch.setattr(bench, "is_busy", lambda _: True)
    main(["bench", "--json"])
    assert "busy" in capsys.readouterr().err


def test_what_takes_long_is_measured_in_full_or_when_it_is_named() -> None:
    quick = [one.name for one in MEASURES if not one.long]
    assert [one.name for one in choose([], full=False)] == quick
    assert choose([], full=True) == list(MEASURES)
    assert [one.name for one in choose(["evaluation"], full=False)] == ["the paper's evaluation"]


def test_a_word_in_no_name_is_refused_with_the_names(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(ParameterError, match="rigid bodies"):
        choose(["flexible"], full=False)
    assert main(["bench", "flexible"]) == 2
    assert "flexible" in capsys.readouterr().err


def test_a_measure_of_the_program_itself_works_from_end_to_end(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "--help is typed", "--json"]) == 2
    capsys.readouterr()
    assert main(["bench", "check", "--json"]) == 0
    figure = json.loads(capsys.readouterr().out)["figures"][0]
    assert figure["unit"] == "s"
    assert figure["value"] > 0.0


@pytest.mark.parametrize(
    ("value", "text"),
    [(9_425_000.4, "9,425,000"), (98.12, "98.1"), (1.0, "1.00"), (0.4446, "0.445"), (240.2, "240")],
)
def test_numbers_have_three_digits_at_least(value: float, text: str) -> None:
    assert shown(value) == text
