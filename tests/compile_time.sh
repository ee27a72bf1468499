#!/usr/bin/env bash
# Seconds of rustc per operation: a chain of 32 free bodies against 16 chains of 2, bias and inverse dynamics, opt-level 3.
#
# Both crates hold like numbers of operations, so what rustc spends on any crate weighs alike; what an empty crate
# takes is subtracted. CPU seconds of the best of several runs in turn, so that other work on the machine does not count.
# Fails where an operation of the long function costs more than LIMIT times one of the short functions.
# Usage: [KANE_RUSTC_FLAGS=FLAGS] tests/compile_time.sh [RUNS]
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-5}
limit=2.2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A chain of $1 free bodies, whose numbers begin with the $2th. No two bodies have the same ones: LLVM would merge their functions.
chain() {
    local lower=0 body n
    for ((body = 1; body < $1; body++)); do lower+=", $body"; done
    printf 'name = "chain"\ngravity = [0.1, 0.2, -9.81]\nlower_bodies = [%s]\n' "$lower"
    for ((body = 1; body <= $1; body++)); do
        n=$(printf '%02d' $(($2 + body)))
        printf '\n[[body]]\nname = "b%d"\nmass = 1.%s\nmass_center = [0.1%s, -0.2%s, 0.3%s]\n' $body $n $n $n $n
        printf 'inertia = { xx = 0.3%s, yy = 0.4%s, zz = 0.5%s, xy = 0.01%s, xz = -0.02%s, yz = 0.03%s }\n' $n $n $n $n $n $n
        printf 'attachment = [0.4%s, -0.5%s, 0.6%s]\njoint = "free"\n' $n $n $n
    done
}

# The operations of the functions of a generated file.
operations() {
    sed -n 's|^/// Operations: \([0-9]*\) .*|\1|p' "$1" | awk '{ sum += $1 } END { print sum }'
}

# A crate of these modules, on standard output.
crate() {
    local module number=0
    for module in "$@"; do
        printf 'pub mod m%d { include!("%s"); pub fn call(q: &[f64; NQ], x: &mut [f64; NU], y: &mut [f64; NU]) {\n' $((number++)) "$module"
        printf 'let p = Prepared::nominal(); bias(&p, q, x, y); inverse_dynamics(&p, q, y, q, x); } }\n'
    done
}

# Generates the chain of $1 bodies whose numbers begin with the $2th as $3.rs.
generate() {
    chain "$1" "$2" > "$work/$3.toml"
    cargo kane generate "$work/$3.toml" --output "$work/$3.rs" --functions bias,inverse_dynamics >&2
}

# CPU seconds of rustc for the crate $1.
seconds() {
    local TIMEFORMAT='%U %S'
    {
        time rustc --edition 2024 --crate-type lib --emit obj -C opt-level=3 -C codegen-units=1 ${KANE_RUSTC_FLAGS:-} -A warnings \
            --extern kane="$work/libkane.rlib" -o "$work/out.o" "$1" 2> "$work/log" || { cat "$work/log"; exit 1; } >&2
    } 2> "$work/time"
    awk '{ print $1 + $2 }' "$work/time"
}

least() {
    sort -g | head -n 1
}

short=()
for ((copy = 0; copy < 16; copy++)); do
    generate 2 $((2 * copy)) short_$copy
    short+=("$work/short_$copy.rs")
done
generate 32 0 long_0
rustc --edition 2024 --crate-type rlib --crate-name kane -C opt-level=3 -o "$work/libkane.rlib" src/lib.rs
crate > "$work/empty.rs"
crate "${short[@]}" > "$work/short.rs"
crate "$work/long_0.rs" > "$work/long.rs"
for ((run = 1; run <= runs; run++)); do
    for crate in empty short long; do seconds "$work/$crate.rs" >> "$work/$crate.seconds"; done
done

awk -v empty="$(least < "$work/empty.seconds")" -v short="$(least < "$work/short.seconds")" -v long="$(least < "$work/long.seconds")" \
    -v two="$(operations "$work/short_0.rs")" -v all="$(operations "$work/long_0.rs")" -v limit=$limit 'BEGIN {
    short_each = (short - empty) / (16 * two); long_each = (long - empty) / all
    printf "16 chains of 2 bodies: %d operations, %.2f s, %.3f s per thousand\n", 16 * two, short - empty, 1000 * short_each
    printf "1 chain of 32 bodies: %d operations, %.2f s, %.3f s per thousand\n", all, long - empty, 1000 * long_each
    ratio = long_each / short_each
    printf "ratio %.2f, at most %s\n", ratio, limit
    exit !(ratio <= limit)
}'
