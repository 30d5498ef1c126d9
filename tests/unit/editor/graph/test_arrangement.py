"""States never cover each other, and edges run from border to border."""

from itertools import combinations

import pytest

from app.editor.graph.arrangement import (
    Request,
    Run,
    Taken,
    at_once,
    border,
    clear_of,
    from_dot,
    loop_clear_of,
    loop_of,
    middle_of,
    run_around,
    run_between,
    spread,
)
from app.editor.graph.dot import arranged, not_reached
from app.editor.graph.walking import next_one

SIZE = (100.0, 36.0)
REQUEST = Request(
    (("start", *SIZE), ("a", *SIZE), ("b", *SIZE), ("lonely", *SIZE)),
    (("start", "a", 60.0, 28.0), ("a", "b", 60.0, 28.0), ("b", "a", 0.0, 0.0), ("a", "a", 40.0, 28.0)),
)


def apart(places: dict[str, tuple[float, float]], sizes: dict[str, tuple[float, float]]) -> bool:
    return all(
        abs(places[a][0] - places[b][0]) >= (sizes[a][0] + sizes[b][0]) / 2 - 1
        or abs(places[a][1] - places[b][1]) >= (sizes[a][1] + sizes[b][1]) / 2 - 1
        for a, b in combinations(places, 2)
    )


def sizes() -> dict[str, tuple[float, float]]:
    return {node: SIZE for node, *_ in REQUEST.nodes}


def test_without_graphviz_states_stand_in_rows_from_start() -> None:
    places = dict(at_once(REQUEST).places)
    assert places["start"][1] < places["a"][1] < places["b"][1] < places["lonely"][1]
    assert apart(places, sizes())


def test_states_whose_place_is_known_stay_there_and_new_ones_cover_none_of_them() -> None:
    known = {"start": (7.0, 0.0), "a": (0.0, 92.0), "b": (0.0, 300.0)}
    places = dict(at_once(REQUEST, known).places)
    assert {state: places[state] for state in known} == known
    assert apart(places, sizes())


def test_graphviz_places_all_states_and_routes_all_edges() -> None:
    answer = arranged({"nodes": REQUEST.nodes, "edges": REQUEST.edges})
    arrangement = from_dot(REQUEST, answer)
    assert apart(dict(arrangement.places), sizes())
    assert set(arrangement.runs) == {(source, target) for source, target, *_ in REQUEST.edges}


def test_an_open_state_gets_room_and_nobody_is_covered() -> None:
    places = dict(at_once(REQUEST).places)
    open_sizes = {**sizes(), "a": (400.0, 300.0), "b": (300.0, 200.0)}
    grown = {state: open_sizes[state] for state in ("a", "b")}
    assert apart(spread(places, sizes(), grown), open_sizes)


def test_closing_all_puts_states_back() -> None:
    places = dict(at_once(REQUEST).places)
    assert spread(places, sizes(), {}) == places


@pytest.mark.parametrize("toward", [(1.0, 0.0), (0.0, 1.0), (-3.0, 1.0), (1.0, -9.0)])
def test_a_border_point_lies_on_the_border(toward: tuple[float, float]) -> None:
    x, y = border((10.0, 20.0), SIZE, toward)
    assert max(abs(x - 10.0) / 50.0, abs(y - 20.0) / 18.0) == pytest.approx(1.0)


def test_two_edges_between_the_same_states_do_not_cover_each_other() -> None:
    there = run_around((0.0, 0.0), SIZE, (0.0, 200.0), SIZE, Taken(), bowed=True)
    back = run_around((0.0, 200.0), SIZE, (0.0, 0.0), SIZE, Taken(), bowed=True)
    assert abs(there.label[0] - back.label[0]) > 20.0


def test_an_edge_goes_around_a_state_that_stands_in_its_way() -> None:
    a, b, between = (0.0, 0.0), (0.0, 300.0), (10.0, 150.0)
    assert run_around(a, SIZE, b, SIZE, Taken([(a, SIZE), (b, SIZE)]), bowed=False).label[0] == 0.0
    states = Taken([(a, SIZE), (b, SIZE), (between, SIZE)])
    for bowed in (False, True):
        x, y = run_around(a, SIZE, b, SIZE, states, bowed=bowed).label
        assert abs(x - between[0]) > SIZE[0] / 2, bowed
        assert y == pytest.approx(150.0)


def test_a_loop_begins_and_ends_at_its_state() -> None:
    run = loop_of((0.0, 0.0), SIZE)
    assert {run.points[0][0], run.points[-1][0]} == {50.0}
    assert middle_of(run.points)[0] > 60.0


def test_arrow_keys_find_the_nearest_state_ahead() -> None:
    others = [
        ("far", (300.0, 0.0)),
        ("near", (100.0, 20.0)),
        ("behind", (-50.0, 0.0)),
        ("above", (10.0, -80.0)),
    ]
    assert next_one((0.0, 0.0), others, (1.0, 0.0)) == "near"
    assert next_one((0.0, 0.0), others, (0.0, -1.0)) == "above"
    assert next_one((0.0, 0.0), others, (0.0, 1.0)) is None


def test_states_that_nothing_leads_to_stand_below_start_with_room_for_a_transition() -> None:
    answer = arranged({"nodes": REQUEST.nodes, "edges": ()})
    places = from_dot(Request(REQUEST.nodes, ()), answer).places
    assert {places[node][1] - places["start"][1] > 60.0 for node in ("a", "b", "lonely")} == {True}


def test_of_states_that_cannot_be_reached_the_first_of_each_group_wants_a_transition() -> None:
    edges = (("a", "b", 0.0, 0.0), ("b", "a", 0.0, 0.0))
    assert not_reached({"nodes": REQUEST.nodes, "edges": edges}) == ["a", "lonely"]
    assert not_reached({"nodes": REQUEST.nodes, "edges": REQUEST.edges}) == ["lonely"]


def test_words_of_a_loop_stand_beside_what_else_comes_to_its_state() -> None:
    loop, size = loop_of((0.0, 0.0), SIZE, 80.0), (80.0, 40.0)
    x, y = loop.label
    comes = Run(
        ((x + 60.0, y + 60.0), (x + 40.0, y + 14.0), (x + 20.0, y + 8.0), (x - 60.0, y + 6.0)), (x, y)
    )
    assert loop_clear_of(loop, size, (), Taken()).label == (x, y)
    above = loop_clear_of(loop, size, [comes], Taken()).label
    assert (above[0], above[1] < y) == (x, True)
    below = loop_clear_of(loop, size, [comes], Taken([((x, y - 20.0), (80.0, 30.0))])).label
    assert below[1] >= y, "words upon words are worse"


def test_words_at_an_edge_make_room_for_what_is_there() -> None:
    run, size = run_between((0.0, 0.0), SIZE, (0.0, 300.0), SIZE), (60.0, 28.0)
    assert clear_of(run, size, Taken()).label == pytest.approx(middle_of(run.points))
    x, y = clear_of(run, size, Taken([(run.label, size)])).label
    assert (x, abs(y - run.label[1]) >= 28.0) == (0.0, True)
