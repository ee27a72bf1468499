#!/usr/bin/env bash
# Instructions of each call of generated functions, counted by valgrind: as many for every one of 1000 states.
#
# Each of the calls stands at a place of its own, so each has a count of its own. Of the states most are random, of both signs
# and magnitudes from 1e-6 to 1e6; the others are zeros, subnormal numbers, numbers with subnormal products, infinities and
# NaN. f64, opt-level 3. Fails where two calls of a function differ.
# Usage: tests/constant_time.sh              the bundled systems, and an arm with functions of frames, matrices and derivatives
#        tests/constant_time.sh robots       those of tests/robots
#        tests/constant_time.sh trees [50]   so many random ones
#        tests/constant_time.sh FILE...      generated modules
# KANE=PATH says which command generates; without, `cargo kane` compiles one.
# Without valgrind nothing is counted, and a line says so; with KANE_NO_SKIP=1 that is a failure.
set -euo pipefail
modules=()
for file in "$@"; do [[ $file != *.rs ]] || modules+=("$(realpath "$file")"); done
cd "$(dirname "$0")/.."
if ! command -v valgrind > /dev/null; then
    echo "skipped: instructions of each call; \`valgrind\` cannot be run" >&2
    [[ -z ${KANE_NO_SKIP:-} ]]
    exit
fi
states=1000
kane=(cargo kane)
[[ -z ${KANE:-} ]] || kane=("$KANE")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A program that calls every function of the module $1 for each state, on standard output.
program() {
    local state
    printf '#![allow(warnings)]\n#[path = "%s"]\nmod system;\nuse {std::{array::from_fn, hint::black_box, mem::zeroed}, system::*};\n' "$1"
    cat << 'RUST'
struct State { q: [f64; NQ], u: [f64; NU], u_dot: [f64; NU], tau: [f64; NU], loads: [kane::Load<f64>; NB], w_rel: [[f64; 3]; NB], point: [f64; 3], force: [f64; 3], moment: [f64; 3], q_direction: [f64; NU], u_direction: [f64; NU], u_dot_direction: [f64; NU], multiplier: [f64; NU] }

/// Mostly between 1e-6 and 1e6.
fn number(bits: &mut u64, state: usize) -> f64 {
    const SPECIAL: [f64; 7] = [0.0, -0.0, 1e-310, 1e-160, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    *bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    let unit = |bits: u64| (bits % 65_536) as f64 / 32_768.0 - 1.0;
    match SPECIAL.get(state / 2) {
        Some(special) if state % 2 == 0 || *bits >> 62 == 0 => *special,
        _ => unit(*bits >> 32) * 10_f64.powf(6.0 * unit(*bits >> 48)),
    }
}

impl State {
    fn new(state: usize) -> Self {
        let mut bits = state as u64;
        let mut x = |_| number(&mut bits, state);
        State {
            q: from_fn(&mut x), u: from_fn(&mut x), u_dot: from_fn(&mut x), tau: from_fn(&mut x),
            loads: from_fn(|_| kane::Load { force: from_fn(&mut x), moment: from_fn(&mut x) }),
            w_rel: from_fn(|_| from_fn(&mut x)),
            point: from_fn(&mut x), force: from_fn(&mut x), moment: from_fn(&mut x),
            q_direction: from_fn(&mut x), u_direction: from_fn(&mut x), u_dot_direction: from_fn(&mut x), multiplier: from_fn(&mut x),
        }
    }
}

#[inline(never)]
extern "C" fn end() { black_box(()); }

RUST
    printf '#[inline(never)]\nfn every_state(call: &mut dyn FnMut(usize)) {\n'
    for ((state = 0; state < states; state++)); do printf 'call(%d);\n' $state; done
    printf '}\n\nfn main() {\nlet p = black_box(Prepared::<f64>::nominal());\n'
    printf 'let states: Vec<State> = (0..%d).map(State::new).collect();\n' $states
    # Signatures in one line; arguments that are written, and those that are read.
    awk '/^pub fn /,/\{\}?$/ { printf "%s ", $0 } /^\) \{\}?$|^pub fn .*\{\}?$/ { print "" }' "$1" | sed -n 's/^pub fn \([a-z0-9_]*\)<[^>]*>(\(.*\)) {.*/\1 \2/p' |
        awk '{
            name = $1; read = "&p"; written = ""; declared = ""
            for (word = 2; word < NF; word++) {
                argument = $word
                if (sub(/:$/, "", argument) == 0 || argument == "p") continue
                if ($(word + 1) == "&mut") {
                    declared = declared "let mut " argument " = unsafe { zeroed() }; "
                    written = written ", &mut " argument
                } else read = read ", &states[i]." argument
            }
            printf "{ %severy_state(&mut |i| system::%s::<f64>(%s%s)); end(); }\n", declared, name, read, written
        }'
    printf '}\n'
}

# The counts of what callgrind has written into $1: of each function of the system $2 one line. A part ends a function's
# calls; $3 is their names in this order, of which symbols do not tell all: functions of the same code are one. One that does
# nothing is not called, and has no instructions.
counts() {
    awk -v model="$2" -v states=$states -v names="$3" '
        BEGIN { n_names = split(names, name_of) }
        function finish() {
            if (!calls) return
            name = name_of[++n_functions]
            if (calls != states || least != most) {
                printf "%-12s %-30s %d calls, of %d to %d instructions\n", model, name, calls, least, most
                differs = 1
            } else printf "%-12s %-30s %d\n", model, name, total / calls
            calls = total = 0
        }
        /^part: / { finish() }
        /^fn=/ { is_sweep = /::every_state/; is_closure = /::main::\{closure/ }
        /^cfn=/ { in_system = /::system::/ }
        /^calls=/ {
            getline
            if (is_sweep) {
                calls++
                if (calls == 1 || $NF < least) least = $NF
                if (calls == 1 || $NF > most) most = $NF
            }
            if (is_closure && in_system) total = $NF
        }
        END { finish(); exit differs || n_functions != n_names }' "$1"
}

# Whether every function of the module $1 executes as many instructions in every state.
measure() {
    local name names
    name=$(basename "$1" .rs)
    program "$(realpath "$1")" > "$work/${name}_calls.rs"
    names=$(sed -n 's/.*system::\([a-z0-9_]*\)::<f64>(.*/\1/p' "$work/${name}_calls.rs")
    if [[ $(wc -w <<< "$names") != $(grep -c '^pub fn ' "$1") ]]; then
        echo "$1: not all of its functions are called" >&2
        exit 1
    fi
    rustc --edition 2024 -C opt-level=3 -C codegen-units=1 -C symbol-mangling-version=v0 --extern kane="$work/libkane.rlib" \
        -o "$work/$name" "$work/${name}_calls.rs"
    valgrind --quiet --tool=callgrind --dump-instr=yes --compress-strings=no --compress-pos=no --combine-dumps=yes \
        --dump-after='*end*' --callgrind-out-file="$work/$name.out" "$work/$name" 2> "$work/$name.log" || { cat "$work/$name.log"; exit 1; }
    counts "$work/$name.out" "$name" "$names"
}

# generate NAME OPTION...: the module of a robot.
generate() {
    "${kane[@]}" generate "tests/robots/$1/$1.urdf" --output "$work/$1.rs" "${@:2}" 2> "$work/$1.log" || { cat "$work/$1.log"; exit 1; }
    modules+=("$work/$1.rs")
}

case ${1:-} in
    "")
        modules=(generated/*.rs)
        frame=panda_hand_tcp
        frames="pose($frame)+jacobian($frame), jacobian($frame, panda_link3), jacobian_packed($frame), point_jacobian($frame)"
        frames+=", velocity($frame, local), acceleration($frame), jacobian_dot_u($frame), generalized_force($frame), imu($frame)"
        frames+=", operational_inverse_inertia($frame, panda_link4)"
        derivatives="d(inverse_dynamics)/d(q, u, u_dot), d(forward_dynamics)/d(q, u, tau), jvp(inverse_dynamics; q, u, u_dot)"
        derivatives+=", vjp(forward_dynamics; q, u, tau), hessian(inverse_dynamics; q)"
        generate panda --functions "$frames, coriolis_matrix, mass_matrix_dot, mass_matrix_inverse, regressor, base_regressor, $derivatives"
        ;;
    robots)
        for name in panda ur5; do generate $name; done
        for name in solo12 talos; do generate $name --base free; done
        ;;
    trees)
        KANE_TREES=${2:-50} KANE_TREES_FOLDER=$work cargo test --quiet --package kane-codegen --test compiled object::random_trees > "$work/trees.log" || { cat "$work/trees.log"; exit 1; }
        modules=("$work"/tree_*.rs)
        ;;
    *.rs) ;;
    *) sed -n 's/^# //p' "$0"; exit 2 ;;
esac
rustc --edition 2024 --crate-type rlib --crate-name kane -C opt-level=3 -o "$work/libkane.rlib" src/lib.rs
printf 'system       function                       instructions of every call\n'
for module in "${modules[@]}"; do measure "$module"; done
