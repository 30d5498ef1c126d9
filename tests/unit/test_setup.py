"""The set-up's decisions, in bash as users run it, with stand-ins for the commands that look at or change a machine."""

import os
import re
import subprocess
from pathlib import Path

import pytest

from app.cli.verbs import STUDIO, verbs

ROOT = Path(__file__).parents[2]
SETUP = ROOT / ".ci" / "setup.sh"
PLAIN_USER = 'id() { echo 1000; }; sudo() { return 1; }; HOSTNAME=here; mkdir -p "$root/.cache"; '
NOBODY_HAS_SUDO = 'command() { [ "$2" != sudo ] && builtin command "$@"; }; '


def bash(script: str, root: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Runs *script* after the set-up's functions have been read, as ./run reads them, for a clone at *root*."""
    return subprocess.run(
        ["bash", "-c", f'set -euo pipefail; root="$1"; . "{SETUP}"; {script}', "bash", str(root)],
        capture_output=True,
        text=True,
        check=False,
        env=os.environ | environment,
    )


@pytest.fixture
def clone(tmp_path: Path) -> Path:
    """A clone that looks set up: an environment with something for an interpreter, and stamps."""
    root = tmp_path / "a clone"
    (root / ".venv" / "bin").mkdir(parents=True)
    (root / ".venv" / "bin" / "python").symlink_to("/bin/sh")
    for lock in ("requirements.lock", "requirements-dev.lock"):
        (root / lock).write_text("something==1\n")
    stamp = 'for kind in run dev; do digest $kind >"$venv/stamp.$kind"; done; identity >"$venv/stamp.place"'
    assert bash(stamp, root).returncode == 0
    return root


def ready(root: Path, kind: str = "run") -> bool:
    return bash(f"packages_ready {kind}", root).returncode == 0


@pytest.mark.parametrize("kind", ["run", "dev"])
def test_a_finished_set_up_is_not_done_again(clone: Path, kind: str) -> None:
    assert ready(clone, kind)


def test_a_changed_lock_is_noticed(clone: Path) -> None:
    (clone / "requirements-dev.lock").write_text("something==2\n")
    assert (ready(clone, "run"), ready(clone, "dev")) == (True, False)


def test_a_moved_clone_is_noticed(clone: Path) -> None:
    assert not ready(clone.rename(clone.with_name("another place")))


def test_a_replaced_interpreter_is_noticed(clone: Path) -> None:
    python = clone / ".venv" / "bin" / "python"
    python.unlink()
    python.symlink_to("/bin/cat")
    assert not ready(clone)


@pytest.mark.parametrize("stamp", ["stamp.run", "stamp.place"])
def test_an_interrupted_set_up_is_noticed(clone: Path, stamp: str) -> None:
    (clone / ".venv" / stamp).unlink()
    assert not ready(clone)


def test_only_libraries_that_the_linker_does_not_know_are_missing(tmp_path: Path) -> None:
    linker = r"""
        ldconfig() {
            for entry in "${run_libraries[@]}"; do printf '\t%s (libc6,x86-64) => /lib/x\n' "${entry%|*}"; done |
                grep -v libEGL
        }
        run_libraries=("libGL.so.1|libgl1" "libEGL.so.1|libegl1" "/|always-there" "/no/such/path|fonts")
        missing_libraries run; echo "${missing[@]}"
    """
    assert bash(linker, tmp_path).stdout.split() == ["libegl1", "fonts"]


def test_who_may_not_install_gets_one_command_with_everything_in_it(tmp_path: Path) -> None:
    asked = bash(PLAIN_USER + NOBODY_HAS_SUDO + "get_system_packages must libgl1 libegl1", tmp_path)
    assert asked.returncode == 2
    command = "apt-get update && apt-get install -y --no-install-recommends libgl1 libegl1"
    assert f"\n    su -c '{command}'\n" in asked.stderr


def test_with_a_password_for_sudo_the_command_uses_sudo(tmp_path: Path) -> None:
    asked = bash(PLAIN_USER + "get_system_packages must libgl1", tmp_path)
    assert asked.returncode == 2
    assert (
        "\n    sudo apt-get update && sudo apt-get install -y --no-install-recommends libgl1\n"
        in asked.stderr
    )


def test_what_can_do_without_a_window_goes_on_after_one_line(tmp_path: Path) -> None:
    warned = bash(PLAIN_USER + "get_system_packages may libgl1; echo went on", tmp_path)
    assert (warned.returncode, warned.stdout) == (0, "went on\n")
    assert warned.stderr.count("\n") == 1
    assert "libgl1" in warned.stderr


def test_installing_that_failed_is_not_tried_at_every_start(tmp_path: Path) -> None:
    fails = 'id() { echo 0; }; HOSTNAME=here; mkdir -p "$cache"; env() { echo tried; return 1; }; '
    for _ in range(2):
        assert bash(fails + "get_system_packages may libgl1", tmp_path).returncode == 0
    assert (tmp_path / ".cache" / "setup.log").read_text() == "tried\n"


def test_without_a_suitable_python_the_message_says_what_to_run(tmp_path: Path) -> None:
    refused = bash(PLAIN_USER + "find_python || no_python", tmp_path, UNDERSTUDY_PYTHON="no-such-python")
    assert refused.returncode == 2
    assert "apt-get install -y --no-install-recommends python3" in refused.stderr


@pytest.mark.bench
def test_a_second_start_adds_less_than_a_second() -> None:
    before = os.times()
    assert bash("set_up run may", ROOT).returncode == 0
    after = os.times()  # processor time, so that a busy machine is no fault of the program
    used = after.children_user + after.children_system - before.children_user - before.children_system
    assert used < 1.0


def test_no_verb_but_the_window_insists_on_what_qt_needs() -> None:
    script = (ROOT / "run").read_text()
    (named,) = re.findall(r"^ *(.*) -h \| --help .*qt=.may", script, re.MULTILINE)
    known = {
        command.name or command.callback.__name__ for command in verbs.registered_commands if command.callback
    }
    assert set(named.rstrip(" |").split(" | ")) == known - {STUDIO}
