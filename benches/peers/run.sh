#!/usr/bin/env bash
# Times our functions beside those of CasADi, Pinocchio, MuJoCo and dynibo, and prints a table of ratios; README.md explains it.
#
#   benches/peers/run.sh [ROBOT...]      of ur5, panda, solo12, talos; all where none is named
#
# PEERS_WORK: the folder of everything that is downloaded and built; by default kane-peers in the user's cache.
# PEERS_SECONDS: for how long each function of each robot is timed; by default 2.
# PEERS_FUNCTIONS: what is timed, names with spaces between, as "jacobian regressor"; by default all that the table has.
# PEERS_FMA: 1 for our functions with fused multiply-add; by default without.
# PEERS_SNAP: what the rivals' models are snapped to, as ours are to 1e-9; by default 0, as their readers leave them.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
work=${PEERS_WORK:-${XDG_CACHE_HOME:-$HOME/.cache}/kane-peers}
snap=${PEERS_SNAP:-0}
packages=(pin==4.1.0 casadi==3.8.2 mujoco==4.0.0 cmeel-eigen==3.4.1)
robots=("$@")
if [ "$#" = 0 ]; then robots=(ur5 panda solo12 talos); fi

say() { printf '%s\n' "$*" >&2; }

for tool in python3 g++ gcc cargo; do
    command -v "$tool" >/dev/null || { say "$tool is needed and is not here"; exit 2; }
done

base() {
    case $1 in
    ur5 | panda) echo fixed ;;
    solo12 | talos) echo free ;;
    *) say "no robot $1: ur5, panda, solo12 or talos"; exit 2 ;;
    esac
}
for robot in "${robots[@]}"; do base "$robot" >/dev/null; done

# The joint of the link whose Jacobian is compared; kane/build.rs names the link.
joint() {
    case $1 in
    ur5) echo wrist_3_joint ;;
    panda) echo panda_joint7 ;;
    solo12) echo FL_KFE ;;
    talos) echo arm_left_7_joint ;;
    esac
}

mkdir -p "$work/bin"
cd "$work"

# The packages, where they are not those named above.
if [ "$(cat venv/packages 2>/dev/null)" != "${packages[*]}" ]; then
    say "packages from PyPI into $work/venv"
    python3 -m venv --clear venv || { say "python3 has no venv (Debian: python3-venv)"; exit 2; }
    venv/bin/pip install --quiet --no-input --disable-pip-version-check "${packages[@]}"
    echo "${packages[*]}" >venv/packages
fi
site=$(venv/bin/python -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
mujoco=$(find "$site/mujoco" -maxdepth 1 -name 'libmujoco.so.*')

# What Pinocchio's own build defines, without which its templates do not compile.
pinocchio=(
    -std=c++17 -DNDEBUG -w
    -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
    -DBOOST_FUSION_INVOKE_MAX_ARITY=12
    -isystem "$site/cmeel.prefix/include" -isystem "$site/cmeel.prefix/include/eigen3"
)

# program OUTPUT TIME ARGUMENT...: compiles "$here/OUTPUT.cpp" where it, a header or the packages are newer.
program() {
    local name=$1 time=$2 old='' source
    shift 2
    for source in "$here/$name.cpp" "$here"/*.hpp venv/packages; do
        if [ ! "bin/$name" -nt "$source" ]; then old=1; fi
    done
    if [ -z "$old" ]; then return; fi
    say "compiling $name.cpp, about $time"
    g++ "${pinocchio[@]}" "$here/$name.cpp" -o "bin/$name" "$@"
}
# Relaxed, because Pinocchio asks for joints that are not among the few of casadi.cpp.
program casadi "half a minute" -O1 -DBOOST_VARIANT_USE_RELAXED_GET_BY_DEFAULT -isystem "$site/casadi/include" -L"$site/casadi" -lcasadi "-Wl,-rpath,$site/casadi"
program bench "six minutes" -O3 -march=native -isystem "$site/mujoco/include" "$mujoco" "-Wl,-rpath,$site/mujoco" -ldl

say "our functions and dynibo"
features=()
if [ "${PEERS_FMA:-0}" = 1 ]; then features=(--features fma); fi
CARGO_TARGET_DIR=$work/target RUSTFLAGS='-C target-cpu=native' \
    cargo build --quiet --release --manifest-path "$here/kane/Cargo.toml" "${features[@]}"

# CasADi's C, one folder for each tolerance of snapping.
models=$work/models-$snap
arguments=()
for robot in "${robots[@]}"; do
    urdf=$(cd "$here/../../tests/robots/$robot" && pwd)/$robot.urdf
    arguments+=("$urdf:$(base "$robot"):$(joint "$robot")")
    if [ "$models/$robot/done" -nt bin/casadi ] && [ "$models/$robot/done" -nt "$here/model.py" ] &&
        [ "$models/$robot/done" -nt "$urdf" ]; then continue; fi
    say "CasADi's code of $robot"
    venv/bin/python "$here/model.py" "$urdf" "$(base "$robot")" "$models" "$snap"
    mkdir -p "$models/$robot"
    bin/casadi "$models/$robot.txt" "$models/$robot" "$(joint "$robot")" >"$models/$robot/operations"
    for source in "$models/$robot"/*.c; do
        gcc -O3 -march=native -fPIC -shared -w "$source" -o "${source%.c}.so" -lm
    done
    touch "$models/$robot/done"
done

bin/bench "$models" "$work/target/release/libkane_peers.so" "${PEERS_SECONDS:-2}" "${PEERS_FUNCTIONS:-}" "${arguments[@]}"
