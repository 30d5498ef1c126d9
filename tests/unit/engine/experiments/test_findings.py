"""What made-up results say: summaries, claims at each combination of levels, the report, the JSON document."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest

from app.engine.experiments.findings import Findings, findings
from app.engine.experiments.plan import Claim, Design, Experiment, Kind, Reference
from app.engine.experiments.report import Files, arm_columns, arm_rows, claim_rows, document, markdown, place
from app.engine.experiments.statistics import Verdict
from app.engine.experiments.store import Results
from tests.unit.engine.experiments.small import experiment, factor, row

MORE = Claim("Groups collect more", Kind.GREATER, "boxes", "grouped", "alone")
RANGE = factor("range", "world.deposit_range", 5.0, 10.0)
RELEASE = factor("release", "world.release", "anyone", "full")
FILES = Files(Path("r.sqlite"), Path("r.md"), (Path("r.svg"), Path("r.png")))


@pytest.fixture
def results(tmp_path: Path) -> Iterator[Results]:
    with Results.open(tmp_path / "r.sqlite", {}) as opened:
        yield opened


def judged(results: Results, of: Experiment, boxes: Mapping[int, Sequence[float]]) -> Findings:
    """Findings where each cell's runs collected so many boxes; a run that collected none has stalled."""
    for cell, counts in boxes.items():
        for run, count in enumerate(counts):
            results.add(row(cell, run, {"boxes": count, "weight": 5.0 * count}, stalled=count == 0))
    return findings(of, ["boxes", "weight"], results)


def test_a_cell_is_summed_up_by_measure(results: Results) -> None:
    alone = judged(results, experiment(), {0: [1.0, 2.0, 0.0]}).summaries[0]
    assert (alone.runs, alone.stalled, alone.rate) == (3, 1, 200.0)
    assert alone.measures["weight"].mean == 5.0
    assert alone.curve.tolist() == [[0.0, 1.0], [0.0, 5.0]]
    assert alone.band[0, 1] == pytest.approx(alone.measures["boxes"].half_width)


def test_runs_beyond_those_asked_for_do_not_count(results: Results) -> None:
    found = judged(results, experiment(runs=2), {0: [1.0, 2.0, 90.0]})
    assert found.summaries[0].runs == 2
    assert found.summaries[0].measures["boxes"].mean == 1.5


def test_a_claim_is_judged_in_the_order_of_its_arms(results: Results) -> None:
    (claim,) = judged(results, experiment(claims=(MORE,)), {0: [1.0, 2.0, 3.0], 1: [8.0, 9.0, 10.0]}).claims
    assert (claim.first.mean, claim.second.mean, claim.difference) == (9.0, 2.0, 7.0)
    assert claim.verdict is Verdict.HOLDS


def test_a_claim_is_judged_at_every_combination_of_levels_and_corrected_for_all(results: Results) -> None:
    boxes = {0: [1.0, 2.0, 3.0], 1: [8.0, 9.0, 10.0], 2: [8.0, 9.0, 10.0], 3: [1.0, 2.0, 3.0]}
    found = judged(results, experiment(claims=(MORE,), factors=(RANGE,)), boxes)
    assert found.tests == 2
    assert [(dict(c.levels), c.verdict) for c in found.claims] == [
        ({"range": "5.0"}, Verdict.HOLDS),
        ({"range": "10.0"}, Verdict.FAILS),
    ]
    assert all(c.p is not None and c.p_corrected == pytest.approx(2 * c.p) for c in found.claims)


def test_a_claim_with_a_place_says_nothing_elsewhere(results: Results) -> None:
    claim = Claim("here", Kind.SAME, "boxes", "grouped", "alone", {"range": "10.0"})
    found = judged(results, experiment(claims=(claim,), factors=(RANGE,)), {})
    assert [dict(c.levels) for c in found.claims] == [{"range": "10.0"}]
    assert found.claims[0].verdict is Verdict.OPEN


def test_a_result_from_elsewhere_is_compared_with(results: Results) -> None:
    theirs = Claim("no fewer", Kind.NO_LESS, "boxes", "alone", Reference("theirs", 8.0, 1.0, 20))
    found = judged(results, experiment(claims=(theirs,)), {0: [1.0, 2.0, 3.0]})
    assert found.claims[0].verdict is Verdict.FAILS
    assert "2.0 ± 2.5 against 8.0 ± 0.5 (theirs)" in claim_rows(found)[0]


def test_never_stalls_is_about_every_run_and_no_test(results: Results) -> None:
    claims = tuple(Claim(arm, Kind.NEVER_STALLS, "boxes", arm) for arm in ("alone", "grouped"))
    found = judged(results, experiment(claims=claims), {0: [1.0, 0.0], 1: [1.0, 1.0]})
    assert [claim.verdict for claim in found.claims] == [Verdict.FAILS, Verdict.HOLDS]
    assert found.tests == 0
    assert found.claims[0].p is None


def test_a_claim_that_does_not_hold_is_told_with_its_numbers(results: Results) -> None:
    found = judged(results, experiment(claims=(MORE,)), {0: [8.0, 9.0, 10.0], 1: [1.0, 2.0, 3.0]})
    (told,) = document(found, FILES)["claims"]
    assert (told["verdict"], told["first"], told["second"]) == ("does not hold", 2.0, 9.0)
    text = markdown(found, FILES, "understudy experiment p small")
    assert "Of 1 — does not hold: 1." in text
    assert "| Groups collect more | 2.0 ± 2.5 against 9.0 ± 2.5 | -7.0 | 0.0010 | does not hold |" in text


def test_the_document_has_the_keys_that_others_rely_on(results: Results) -> None:
    found = document(judged(results, experiment(claims=(MORE,)), {0: [1.0, 3.0], 1: [4.0]}), FILES)
    assert {"experiment", "arms", "claims", "results", "figures"} <= found.keys()
    (alone, _) = found["arms"]
    assert {"name", "runs", "measures", "stalled_share"} <= alone.keys()
    assert alone["measures"]["boxes"].keys() == {"mean", "ci95", "sd"}
    assert alone["measures"]["boxes"]["mean"] == 2.0
    assert {"text", "p", "p_corrected", "verdict"} <= found["claims"][0].keys()
    assert (found["results"], found["figures"]) == ("r.sqlite", ["r.svg", "r.png"])


def test_the_report_shows_the_figure_the_table_and_how_to_repeat_it(results: Results) -> None:
    text = markdown(
        judged(results, experiment(note="A note."), {0: [1.0, 3.0]}), FILES, "understudy experiment p"
    )
    assert text.startswith("# Small\n\nA note.\n\n![")
    assert "(r.png)" in text
    assert "| alone | 2 | 2.0 ± 12.7 | 10.0 ± 63.5 | 0% | 0.0 M |" in text
    assert "| grouped | 0 | – | – | 0% | 0.0 M |" in text
    assert text.endswith("    understudy experiment p\n")


def test_where_one_thing_is_changed_at_a_time_only_that_is_named(results: Results) -> None:
    plan: Any = experiment(factors=(RANGE, RELEASE), design=Design.ONE_AT_A_TIME, claims=(MORE,))
    found = judged(results, plan, {})
    assert arm_columns(found)[:2] == ["arm", "what is changed"]
    assert [cells[1] for cells in arm_rows(found)[::2]] == ["as usual", "range: 10.0", "release: full"]
    assert "| as usual | not significant |" in markdown(found, FILES, "c")
    assert (
        place({"range": "5.0", "release": "full"}, experiment(factors=(RANGE,))) == "range 5.0, release full"
    )
