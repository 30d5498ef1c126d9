"""What is wrong with a file is said in words: which file, where in it, what was found, what is allowed."""

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from app.core.errors import StorageError
from app.core.storage import FilesError, Problem, load

GOTO = "libraries/agent/mixed.json"
TAUGHT = "examples/agent/mixed.json"
SHOWN = "demonstrations/d1.json"
PROJECT = "project.json"

Change = Callable[[Any], object]


def problems(folder: Path) -> list[Problem]:
    with pytest.raises(FilesError) as caught:
        load(folder)
    return list(caught.value.problems)


def change(folder: Path, file: str, how: Change) -> None:
    path = folder / file
    document = json.loads(path.read_text())
    how(document)
    path.write_text(json.dumps(document))


def put(*where: Any) -> Change:
    """A change that puts the last of *where* at the place that the others lead to."""
    *path, key, value = where

    def do(document: Any) -> None:
        for step in path:
            document = document[step]
        document[key] = value

    return do


def drop(*where: Any) -> Change:
    *path, key = where

    def do(document: Any) -> None:
        for step in path:
            document = document[step]
        del document[key]

    return do


S1 = ("learned", "s1")
CASES: dict[str, tuple[str, Change, str, str]] = {
    # what must be there, and what must not
    "a missing key": (GOTO, drop("states", 2, "content", "automaton"), "states[2].content", "the key 'automaton' is missing"),
    "a misspelled key": (
        GOTO,
        put("rules", 1, "guard", 0, "treshold", 1.0),
        "rules[1].guard[0]",
        "unknown key 'treshold'; did you mean 'threshold'? allowed: feature, kind, threshold, wanted",
    ),
    "an unknown key": (
        GOTO,
        put("settings", "xyz", 1),
        "settings",
        "unknown key 'xyz'; allowed: classifier, options, pruning_confidence, sampling",
    ),
    "an unknown key at the top": (PROJECT, put("worldz", {}), "", "unknown key 'worldz'; did you mean 'worlds'?"),
    # kinds of value
    "a number for text": (GOTO, put("states", 1, "content", "behavior", 7), "states[1].content.behavior", "must be text, but found 7"),
    "text for a number": (GOTO, put("rules", 1, "probability", "often"), "rules[1].probability", 'must be a number, but found "often"'),
    "true for a number": (GOTO, put("rules", 1, "probability", True), "rules[1].probability", "must be a number, but found true"),
    "a fraction for a whole number": (SHOWN, put("ticks", 1.5), "ticks", "must be a whole number, but found 1.5"),
    "null for text": (PROJECT, put("name", None), "name", "must be text, but found null"),
    "an object for an array": (GOTO, put("states", {}), "states", "must be an array, but found {}"),
    "a number for an object": (GOTO, put("states", 1, 5), "states[1]", "must be an object, but found 5"),
    "an array for a file": (GOTO, lambda _: None, "", "must be an object, but found []"),
    "text for a switch": (TAUGHT, put("examples", 1, "enabled", "no"), "examples[1].enabled", 'must be true or false, but found "no"'),
    "a list as a parameter": (PROJECT, put("worlds", "hard", "boxes", [4]), "worlds.hard.boxes", "must be a finite number, a whole number of 64 bits, text, true or false"),
    # one of several
    "an unknown kind of content": (
        GOTO,
        put("states", 1, "content", "kind", "basics"),
        "states[1].content",
        "the kind must be 'start', 'basic', 'automaton' or 'flag', but found \"basics\"",
    ),
    "content without a kind": (GOTO, drop("states", 1, "content", "kind"), "states[1].content", "the key 'kind' is missing; allowed: 'start', 'basic', 'automaton' or 'flag'"),
    "an unknown sampling": (GOTO, put("settings", "sampling", "max"), "settings.sampling", "must be 'sample', 'argmax' or 'hold', but found \"max\""),
    "an unknown act": (SHOWN, put("picks", 0, "act", "poke"), "picks[0].act", "must be 'pick', 'answer', 'should not have left', 'undo', 'redo', 'test', 'learn', 'teach' or 'move', but found \"poke\""),
    "a binding to two things": (
        GOTO,
        put("features", 0, "source", "bindings", "target", "ground", "deposit"),
        "features[0].source.bindings.target",
        "must have either the key 'ground' or the key 'parameter'",
    ),
    # numbers out of their range
    "a probability above one": (GOTO, put("rules", 1, "probability", 1.5), "rules[1].probability", "must be at most 1, but found 1.5"),
    "a negative probability": (GOTO, put("rules", 1, "probability", -0.5), "rules[1].probability", "must be at least 0, but found -0.5"),
    "a pruning confidence of zero": (GOTO, put("settings", "pruning_confidence", 0.0), "settings.pruning_confidence", "must be more than 0, but found 0.0"),
    "a pruning confidence above a half": (GOTO, put("settings", "pruning_confidence", 0.6), "settings.pruning_confidence", "must be at most 0.5, but found 0.6"),
    "a negative weight": (TAUGHT, put("examples", 0, "weight", -1), "examples[0].weight", "must be at least 0, but found -1"),
    "a negative tick": (TAUGHT, put("examples", 1, "tick", -1), "examples[1].tick", "must be at least 0, but found -1"),
    "not a number": (TAUGHT, put("examples", 0, "values", "f1", math.nan), "examples[0].values.f1", "must be a finite number, but found NaN"),
    "infinity": (TAUGHT, put("examples", 0, "values", "f1", -math.inf), "examples[0].values.f1", "must be a finite number, but found -Infinity"),
    "infinity as a parameter": (PROJECT, put("worlds", "", "speed", math.inf), 'worlds[""].speed', "must be a finite number"),
    "a seed of more than 64 bits": (SHOWN, put("seed", 2**64), "seed", f"must be at most {2**63 - 1:,}, but found {2**64}"),
    "a number beyond float64": (TAUGHT, put("examples", 0, "values", "f1", 10**400), "examples[0].values.f1", "must be a number that float64 can hold, but found 1000"),
    # trees
    "a tree that points backward": (GOTO, put(*S1, "yes", 2, 1), "learned.s1.yes[2]", "must be the index of a later node, 3 to 6, but found 1"),
    "a tree that points outside": (GOTO, put(*S1, "no", 0, 7), "learned.s1.no[0]", "must be the index of a later node, 1 to 6, but found 7"),
    "a tree whose node stands twice": (GOTO, put(*S1, "no", 0, 3), "learned.s1.slot[2]", "node 2 must stand below one node, not 0"),
    "a leaf with a node below": (GOTO, put(*S1, "yes", 1, 2), "learned.s1.yes[1]", "must be -1 at a leaf, but found 2"),
    "a leaf with a test": (GOTO, put(*S1, "operation", 1, "equals"), "learned.s1.operation[1]", 'must be "" where \'slot\' is -1'),
    "a test of a feature that is not listed": (GOTO, put(*S1, "slot", 0, 3), "learned.s1.slot[0]", "an index into 'features', which has 3; found 3"),
    "an unknown test": (GOTO, put(*S1, "operation", 0, "near"), "learned.s1.operation[0]", "must be 'at most', 'equals', 'in arc' or '', but found \"near\""),
    "arrays of different lengths": (GOTO, drop(*S1, "a", 0), "learned.s1.a", "must have as many entries as 'slot', 7, but has 6"),
    "counts for other labels": (GOTO, put(*S1, "counts", 0, [1.0]), "learned.s1.counts[0]", "must have one count a label, 2, but has 1"),
    "counts for other labels in a forest": (
        GOTO,
        put("learned", "s2", "trees", 1, "counts", 0, [1.0, 2.0, 3.0]),
        "learned.s2.trees[1].counts[0]",
        "must have one count a label, 2, but has 3",
    ),
    "a negative count": (GOTO, put(*S1, "counts", 0, 0, -1.0), "learned.s1.counts[0][0]", "must be at least 0, but found -1.0"),
    "a forest without trees": (GOTO, put("learned", "s2", "trees", []), "learned.s2.trees", "must have at least 1 entry, but has 0"),
    "a label twice": (GOTO, put(*S1, "labels", ["s1", "s1"]), "learned.s1.labels[0]", "'s1' stands here more than once"),
    # states and ids
    "no states": (GOTO, put("states", []), "states", "must have at least 1 entry, but has 0"),
    "another first state": (GOTO, put("states", 0, "id", "begin"), "states[0].id", "the first state, and no other, must have the id 'start', but found 'begin'"),
    "a second start": (GOTO, put("states", 1, "content", {"kind": "start"}), "states[1].content", "the first state, and no other, must be of the kind 'start', but found 'start'"),
    "two states with one id": (GOTO, put("states", 2, "id", "s1"), "states[1].id", "'s1' stands here more than once"),
    "two features with one id": (GOTO, put("features", 2, "id", "f1"), "features[2].id", "'f1' stands here more than once"),
    "two examples with one id": (TAUGHT, put("examples", 2, "id", "1"), "examples[0].id", "'1' stands here more than once"),
    "a parameter twice": (GOTO, put("parameters", ["whom", "whom"]), "parameters[1]", "'whom' stands here more than once"),
    "two arms with one name": (PROJECT, put("arms", 1, "name", "independent"), "arms[0].name", "'independent' stands here more than once"),
    "two types with one name": (PROJECT, put("types", 1, "name", "agent"), "types[1].name", "'agent' stands here more than once"),
    "a state without an id": (GOTO, put("states", 1, "id", ""), "states[1].id", 'must be text that is not empty, but found ""'),
    # forests of nodes
    "a level of nobody": (PROJECT, put("arms", 0, "hierarchy", "sizes", 0, 0), "arms[0].hierarchy.sizes[0]", "must be at least 1, but found 0"),
    "sizes without types": (PROJECT, put("arms", 0, "hierarchy", "types", []), "arms[0].hierarchy.types", "1 sizes need as many types, but there are 0"),
    # names of files
    "an id that leads out of the folder": (PROJECT, put("demonstrations", ["../../secret"]), "demonstrations[0]", "'../../secret' cannot be the name of a file: it holds '/'"),
    "a snapshot that leads out of the folder": (
        TAUGHT,
        put("examples", 0, "snapshot", "../../secret"),
        "examples[0].snapshot",
        'must be 16 hexadecimal digits in small letters, or empty, but found "../../secret"',
    ),
    "a type that leads out of the folder": (PROJECT, put("types", 0, "name", ".."), "types[0].name", "'..' cannot be the name of a type: it begins with a dot"),
    "an id that is not the file's": (GOTO, put("id", "other"), "id", "must be the name of the file, 'mixed', but found 'other'"),
    "two files with one id": (GOTO, put("id", "goto"), "id", "'goto' is the id of two files, this one and libraries/agent/goto.json"),
    "examples of another behavior": (TAUGHT, put("automaton", "goto"), "automaton", "must be the name of the file, 'mixed', but found 'goto'"),
    # what refers to files
    "a demonstration that is not there": (PROJECT, put("demonstrations", ["d1", "d3"]), "demonstrations[1]", "the file demonstrations/d3.json is missing"),
    "a moment that is not there": (
        TAUGHT,
        put("examples", 3, "snapshot", "0" * 16),
        "examples[3].snapshot",
        'the file examples/moments/0000000000000000.npz is missing; bring it back, or write ""',
    ),
    # the version
    "a newer schema": (
        PROJECT,
        put("schema_version", 7),
        "schema_version",
        "its schema version is 7, and this one reads versions up to 1; update Understudy",
    ),
    "no schema version": (PROJECT, drop("schema_version"), "", "the key 'schema_version' is missing, so this is no Understudy project"),
    "a version in words": (PROJECT, put("schema_version", "one"), "schema_version", "must be a whole number from 1 to 1"),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_a_wrong_document_is_refused_with_its_place_and_what_is_allowed(folder: Path, case: str) -> None:
    file, how, where, message = CASES[case]
    if case == "an array for a file":
        (folder / file).write_text("[]")
    else:
        change(folder, file, how)
    found = problems(folder)
    matching = [problem for problem in found if problem.where == where and message in problem.message]
    assert matching, found
    assert {problem.file for problem in found} == {file}


TEXTS: dict[str, tuple[bytes, str, str]] = {
    "cut in a string": (b'{"id": "go', "line 1, column 8", "cut short"),
    "cut in an object": (b'{\n  "id": 1,\n', "line 3, column 1", "cut short"),
    "no comma": (
        b'{\n  "id": 1\n  "name": 2}',
        "line 3, column 3",
        "this is not JSON: expecting ',' delimiter",
    ),
    "text after the end": (b"{} {}", "line 1, column 4", "this is not JSON: extra data"),
    "empty": (b"", "line 1, column 1", "the file is empty"),
    "only blanks": (b" \n ", "line 2, column 2", "the file is empty"),
    "not UTF-8": (b'{\n"a": "\xff"}', "line 2", "the byte 0xff is not UTF-8"),
    "a key twice": (
        b'{"states": [{"id": 1, "id": 2}]}',
        "states[0]",
        "the key 'id' stands here more than once",
    ),
    "too deep": (b"[" * 100_000, "", "it is nested too deeply"),
    "too many digits": (b"[\n" + b"1" * 5000 + b"]", "line 2", "a number has too many digits"),
    "no member begins": (b"{,}", "line 1, column 2", "this is not JSON: expecting property name"),
}


@pytest.mark.parametrize("case", TEXTS)
@pytest.mark.parametrize("file", [GOTO, PROJECT])
def test_damaged_text_is_refused_with_line_and_column(folder: Path, case: str, file: str) -> None:
    data, where, message = TEXTS[case]
    (folder / file).write_bytes(data)
    [problem] = problems(folder)
    assert (problem.file, problem.where) == (file, where)
    assert message in problem.message


def test_every_way_to_cut_a_file_short_is_a_problem_of_that_file(folder: Path) -> None:
    path = folder / SHOWN
    whole = path.read_bytes().rstrip()
    for length in range(0, len(whole), 7):
        path.write_bytes(whole[:length])
        assert {problem.file for problem in problems(folder)} == {SHOWN}


def test_all_problems_of_all_files_are_reported_at_once(folder: Path) -> None:
    change(folder, GOTO, put("rules", 1, "probability", 2))
    change(folder, GOTO, put("settings", "sampling", "max"))
    change(folder, TAUGHT, put("examples", 0, "values", "f1", None))
    (folder / SHOWN).write_bytes(b"{")
    (folder / "examples/moments/8866191d021cee12.npz").write_bytes(b"PK")
    found = problems(folder)
    assert sorted({problem.file for problem in found}) == [SHOWN, TAUGHT, "libraries/agent/mixed.json"]
    assert len(found) == 4


def test_the_message_names_the_folder_once_and_each_problem_on_a_line(folder: Path) -> None:
    change(folder, GOTO, put("rules", 1, "probability", 2))
    with pytest.raises(StorageError) as one:
        load(folder)
    assert str(one.value) == f"{folder}/{GOTO}: rules[1].probability: must be at most 1, but found 2"
    change(folder, SHOWN, put("ticks", -1))
    with pytest.raises(StorageError) as two:
        load(folder)
    assert str(two.value).splitlines() == [
        f"{folder}: 2 problems",
        f"  {GOTO}: rules[1].probability: must be at most 1, but found 2",
        f"  {SHOWN}: ticks: must be at least 0, but found -1",
    ]


def test_a_long_list_of_problems_is_counted(folder: Path) -> None:
    change(folder, TAUGHT, put("examples", [{}] * 30))
    with pytest.raises(FilesError, match="and 100 more") as caught:
        load(folder)
    assert len(caught.value.problems) == 120


@pytest.mark.parametrize(
    ("levels", "message"), [(65, "must have at most 64 levels, but has 65"), (400, "is nested too deeply")]
)
def test_forests_deeper_than_anyone_needs_are_refused(folder: Path, levels: int, message: str) -> None:
    node: dict[str, Any] = {"id": "a", "type": "agent"}
    for _ in range(levels - 1):
        node = {"id": "a", "type": "agent", "children": [node]}
    change(folder, PROJECT, put("arms", 1, "hierarchy", "roots", [node]))
    [problem] = problems(folder)
    assert problem.where.startswith("arms[1].hierarchy.roots")
    assert problem.message == message


def test_a_byte_order_mark_is_taken(folder: Path) -> None:
    before = load(folder)
    path = folder / GOTO
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    assert load(folder) == before
