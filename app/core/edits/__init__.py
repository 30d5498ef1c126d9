"""Every change of a project: pure functions from one project to the next, which share what did not change.

The first argument is the project, the next ones say where. An edit that makes something also returns its id. One that
names what is not there, or would break the project, raises an `EditError` that says what is allowed; whether bindings
are closed and names resolve is for `app.core.check` to say, since a user may mend that later.

`describe` gives the sentence that the undo menu shows, and `app.core.history` undoes.
"""

from .arms import (
    add_arm,
    delete_arm,
    delete_world,
    move_arm,
    rename_arm,
    rename_world,
    replace_arm,
    set_world,
)
from .behaviors import (
    add_automaton,
    delete_automaton,
    duplicate_automaton,
    rename_automaton,
    rename_parameter,
    set_note,
    set_parameters,
    set_settings,
)
from .calls import Caller, callers, users
from .carrying import carry_states, give_back, left_behind, lend
from .copying import Where, copy_states
from .cuts import move_cut, remove_cut
from .demonstrations import (
    add_demonstration,
    move_demonstration,
    note_project,
    remove_demonstration,
    rename_project,
    replace_demonstration,
)
from .examples import (
    Recorded,
    disable_examples,
    enable_examples,
    next_pick,
    record_pick,
    relabel_examples,
    replace_examples,
    set_values,
    take_back_pick,
    weight_examples,
    without_examples,
)
from .features import (
    add_feature,
    drop_feature,
    move_feature,
    rebind_feature,
    rename_feature,
    tests_of,
)
from .forests import (
    add_node,
    dissolve_node,
    group_nodes,
    move_nodes,
    remove_node,
    rename_node,
    set_hierarchy,
)
from .layouts import forget_layout, move_states
from .learned import add_prune, prune_weak, remove_prune, replace_prune, set_learned
from .node_types import add_type, delete_type, rename_type, set_subsidiaries
from .picking import state_for
from .rules import (
    add_rule,
    author_learned,
    order_rules,
    remove_rule,
    remove_rules_of,
    replace_rule,
)
from .states import (
    add_state,
    bind_state,
    move_state,
    note_state,
    remove_state,
    rename_state,
    set_content,
)
from .words import SENTENCES, describe

__all__ = [
    "SENTENCES",
    "Caller",
    "Recorded",
    "Where",
    "add_arm",
    "add_automaton",
    "add_demonstration",
    "add_feature",
    "add_node",
    "add_prune",
    "add_rule",
    "add_state",
    "add_type",
    "author_learned",
    "bind_state",
    "callers",
    "carry_states",
    "copy_states",
    "delete_arm",
    "delete_automaton",
    "delete_type",
    "delete_world",
    "describe",
    "disable_examples",
    "dissolve_node",
    "drop_feature",
    "duplicate_automaton",
    "enable_examples",
    "forget_layout",
    "give_back",
    "group_nodes",
    "left_behind",
    "lend",
    "move_arm",
    "move_cut",
    "move_demonstration",
    "move_feature",
    "move_nodes",
    "move_state",
    "move_states",
    "next_pick",
    "note_project",
    "note_state",
    "order_rules",
    "prune_weak",
    "rebind_feature",
    "record_pick",
    "relabel_examples",
    "remove_cut",
    "remove_demonstration",
    "remove_node",
    "remove_prune",
    "remove_rule",
    "remove_rules_of",
    "remove_state",
    "rename_arm",
    "rename_automaton",
    "rename_feature",
    "rename_node",
    "rename_parameter",
    "rename_project",
    "rename_state",
    "rename_type",
    "rename_world",
    "replace_arm",
    "replace_demonstration",
    "replace_examples",
    "replace_prune",
    "replace_rule",
    "set_content",
    "set_hierarchy",
    "set_learned",
    "set_note",
    "set_parameters",
    "set_settings",
    "set_subsidiaries",
    "set_values",
    "set_world",
    "state_for",
    "take_back_pick",
    "tests_of",
    "users",
    "weight_examples",
    "without_examples",
]
