# shellcheck shell=bash
# Set-up shared by ./run and ./test: sourced with $root set to the repository, then `set_up run|dev must|may`.
#
# It makes .venv, installs the locked packages in it and the system libraries that Qt needs, and costs next to nothing
# when all of that is there. Stamps are written last, so that whatever was interrupted is done again by the next start.

setup_version=1 # raise it to have every virtual environment rebuilt
venv="${root:?the sourcing script sets it}/.venv"
cache="$root/.cache"
setup_log="$cache/setup.log"

# What Qt, its xcb and wayland platforms and Graphviz load at run time and the wheels do not carry (ldd on all of them
# in a bare system), as "what to look for|Debian package". A path must exist; a name is asked of the linker's cache.
run_libraries=(
    "libGL.so.1|libgl1"
    "libEGL.so.1|libegl1"
    "libX11.so.6|libx11-6"
    "libX11-xcb.so.1|libx11-xcb1"
    "libXext.so.6|libxext6"
    "libXrender.so.1|libxrender1"
    "libdbus-1.so.3|libdbus-1-3"
    "libfontconfig.so.1|libfontconfig1"
    "libfreetype.so.6|libfreetype6"
    "libglib-2.0.so.0|libglib2.0-0"
    "libxkbcommon.so.0|libxkbcommon0"
    "libxkbcommon-x11.so.0|libxkbcommon-x11-0"
    "libxcb.so.1|libxcb1"
    "libxcb-cursor.so.0|libxcb-cursor0"
    "libxcb-glx.so.0|libxcb-glx0"
    "libxcb-icccm.so.4|libxcb-icccm4"
    "libxcb-image.so.0|libxcb-image0"
    "libxcb-keysyms.so.1|libxcb-keysyms1"
    "libxcb-randr.so.0|libxcb-randr0"
    "libxcb-render.so.0|libxcb-render0"
    "libxcb-render-util.so.0|libxcb-render-util0"
    "libxcb-shape.so.0|libxcb-shape0"
    "libxcb-shm.so.0|libxcb-shm0"
    "libxcb-sync.so.1|libxcb-sync1"
    "libxcb-util.so.1|libxcb-util1"
    "libxcb-xfixes.so.0|libxcb-xfixes0"
    "libxcb-xkb.so.1|libxcb-xkb1"
    "libwayland-client.so.0|libwayland-client0"
    "libwayland-cursor.so.0|libwayland-cursor0"
    "libwayland-egl.so.1|libwayland-egl1"
    "/usr/share/fonts|fonts-dejavu-core"
)
dev_libraries=(
    "/usr/bin/Xvfb|xvfb"
    "/usr/bin/xauth|xauth"
    "/usr/bin/xdotool|xdotool"
)

say() { printf 'understudy: %s\n' "$*" >&2; }

show_apt() { # The command that installs packages, for this account, on a line of its own to be copied.
    local update="apt-get update" install="apt-get install -y --no-install-recommends $*"
    if [ "$(id -u)" -eq 0 ]; then
        printf '\n    %s && %s\n\n' "$update" "$install" >&2
    elif command -v sudo >/dev/null; then
        printf '\n    sudo %s && sudo %s\n\n' "$update" "$install" >&2
    else
        printf "\n    su -c '%s && %s'\n\n" "$update" "$install" >&2
    fi
}

show_log() { # The end of the set-up's log, after a step that failed.
    tail -n 15 "$setup_log" | sed 's/^/    /' >&2
    say "the whole log: $setup_log"
}

# --- is everything there? -----------------------------------------------------------------------------------------

lock_file() { if [ "$1" = dev ]; then echo "$root/requirements-dev.lock"; else echo "$root/requirements.lock"; fi; }

# An environment belongs to one place (its scripts hold absolute paths) and one interpreter (which an upgrade of the
# system may replace under it).
identity() { echo "$setup_version|$root|$(readlink -f "$venv/bin/python")"; }

same() { [ -r "$1" ] && [ "$(<"$1")" = "$2" ]; } # same FILE TEXT

digest() { sha256sum <"$(lock_file "$1")"; }

environment_ready() { [ -x "$venv/bin/python" ] && same "$venv/stamp.place" "$(identity)"; }

packages_ready() { environment_ready && same "$venv/stamp.$1" "$(digest "$1")"; }

missing_libraries() { # Sets $missing to the Debian packages that kind $1 lacks on this machine.
    local entry known wanted=("${run_libraries[@]}")
    missing=()
    [ "$(uname -s)" = Linux ] || return 0
    [ "$1" = run ] || wanted+=("${dev_libraries[@]}")
    known="$(PATH="$PATH:/sbin:/usr/sbin" ldconfig -p 2>/dev/null)" || return 0
    for entry in "${wanted[@]}"; do
        case "$entry" in
            /*) [ -e "${entry%|*}" ] || missing+=("${entry#*|}") ;;
            *) [[ "$known" == *$'\t'"${entry%|*} ("* ]] || missing+=("${entry#*|}") ;;
        esac
    done
}

# The machine's name is part of the stamp because a clone may be shared by several machines or containers, and what is
# wanted because a newer version may want more.
system_ready() {
    local stamp="$HOSTNAME ${run_libraries[*]}"
    [ "$1" = run ] || stamp+=" ${dev_libraries[*]}"
    same "$cache/system.$1" "$stamp" && return 0
    missing_libraries "$1"
    [ ${#missing[@]} -eq 0 ] || return 1
    { mkdir -p "$cache" && echo "$stamp" >"$cache/system.$1"; } 2>/dev/null || true
}

# --- system packages ----------------------------------------------------------------------------------------------

install_system_packages() { # Returns 1 when this account may not install, 2 when installing failed.
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        sudo -n true 2>/dev/null || return 1
        as_root=(sudo -n)
    fi
    say "installing system packages: $*"
    as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
    { "${as_root[@]}" update && "${as_root[@]}" install -y --no-install-recommends "$@"; } \
        >>"$setup_log" 2>&1 </dev/null 9>&- || return 2 # no daemon that a package starts may keep our lock
}

# get_system_packages must|may PACKAGE...: "may" goes on without them, after one line.
get_system_packages() {
    local need=$1 outcome=0
    shift
    if [ "$need" = may ] && same "$cache/system.failed" "$HOSTNAME $*"; then
        outcome=2 # It failed before; a start that can do without does not try again.
    else
        install_system_packages "$@" || outcome=$?
    fi
    [ $outcome -ne 0 ] || return 0
    if [ $outcome -eq 2 ] && [ -w "$cache" ]; then echo "$HOSTNAME $*" >"$cache/system.failed"; fi
    if [ "$need" = may ]; then
        say "windows and pictures may not work, these system packages are missing: $*"
        return 0
    fi
    if [ $outcome -eq 2 ]; then
        say "installing system packages failed:"
        show_log
        say "when the cause is mended, start again, or run this by hand first:"
    else
        say "system packages are missing, and this account may not install them. Run this once, then start again:"
    fi
    show_apt "$@"
    exit 2
}

# --- Python -------------------------------------------------------------------------------------------------------

# Prints "version ensurepip? executable" for an interpreter that the locked wheels support, else fails.
python_probe='
import importlib.util, sys
supported = (3, 11) <= sys.version_info[:2] <= (3, 14)
if not supported or sys.implementation.name != "cpython" or "t" in sys.abiflags:
    sys.exit(1)
ensurepip = importlib.util.find_spec("ensurepip") is not None
print("%d.%d" % sys.version_info[:2], "yes" if ensurepip else "no", sys.executable)
'

find_python() { # Sets python, python_version and has_venv; an interpreter that can make environments comes first.
    local name facts
    python=""
    for name in ${UNDERSTUDY_PYTHON:-python3 python3.13 python3.12 python3.11 python3.14}; do
        facts="$("$name" -c "$python_probe" 2>/dev/null)" || continue
        [ -z "$python" ] || [[ "$facts" == *" yes "* ]] || continue
        read -r python_version has_venv python <<<"$facts"
        [ "$has_venv" = no ] || return 0
    done
    [ -n "$python" ]
}

no_python() {
    local package=python3
    # Where python3 is there but too old, the newer one has another name.
    ! command -v python3 >/dev/null || package=python3.11
    say "needs Python 3.11, 3.12, 3.13 or 3.14. Run this once, then start again:"
    show_apt "$package" "$package-venv"
    say "or name an interpreter: UNDERSTUDY_PYTHON=/path/to/python3 ./run"
    exit 2
}

make_environment() {
    say "making the virtual environment with Python $python_version ($python)"
    rm -rf "$venv"
    "$python" -m venv "$venv" >>"$setup_log" 2>&1 || { say "that failed:" && show_log && exit 1; }
}

install_packages() { # install_packages run|dev
    local started=$SECONDS
    rm -f "$venv"/stamp.*
    say "installing the locked packages (the first time, a minute or two)"
    PIP_USER=0 "$venv/bin/python" -m pip install --require-hashes --only-binary :all: --no-input \
        --disable-pip-version-check -r "$(lock_file "$1")" >>"$setup_log" 2>&1 </dev/null ||
        { say "installing the packages failed:" && show_log && exit 1; }
    digest "$1" >"$venv/stamp.$1"
    # The packages for tests include those for running.
    [ "$1" = run ] || digest run >"$venv/stamp.run"
    identity >"$venv/stamp.place"
    say "packages are ready ($((SECONDS - started)) s)"
}

# --- all together -------------------------------------------------------------------------------------------------

# Only one start sets up at a time; the others wait and then find it done. venv and pip inherit the lock: should this
# script be killed, the next start waits for what it left behind.
take_lock() { # take_lock run|dev
    mkdir -p "$cache" 2>/dev/null || true
    if [ ! -w "$cache" ]; then
        setup_log=/dev/null
        packages_ready "$1" && return 0 # somebody else's clone, set up by them
        say "this folder cannot be written by this account, and its set-up is not complete: $root"
        exit 2
    fi
    exec 9>"$cache/setup.lock"
    command -v flock >/dev/null || return 0
    flock -n 9 || { say "another start is setting up; waiting for it" && flock 9; }
}

everything_ready() { packages_ready "$1" && system_ready "$1"; }

complete() { # complete run|dev must|may: whatever is not there yet.
    local fresh=no wanted=()
    packages_ready "$1" || date >"$setup_log"
    environment_ready || fresh=yes
    if [ $fresh = yes ]; then
        find_python || no_python
        if [ "$has_venv" = no ]; then wanted+=("python$python_version-venv"); fi
    fi
    missing=()
    system_ready "$1" || true
    # One message for everything, but only what cannot be done without stops the start.
    if [ ${#wanted[@]} -gt 0 ]; then
        get_system_packages must "${wanted[@]}" "${missing[@]}"
    elif [ ${#missing[@]} -gt 0 ] && command -v apt-get >/dev/null; then
        get_system_packages "$2" "${missing[@]}"
    elif [ ${#missing[@]} -gt 0 ]; then
        say "windows may not work; install what your system calls these Debian packages: ${missing[*]}"
    fi
    [ $fresh = no ] || make_environment
    packages_ready "$1" || install_packages "$1"
    system_ready "$1" || true
}

set_up() { # set_up run|dev must|may: "may" when a missing Qt library need not stop what was asked for.
    unset PYTHONHOME PYTHONPATH
    everything_ready "$1" && return 0
    trap 'say "interrupted; the next start takes it up again" && exit 130' INT TERM
    take_lock "$1"
    everything_ready "$1" || complete "$1" "$2"
    exec 9>&-
    trap - INT TERM
}
