#!/usr/bin/env bash
# Seconds of rustc per operation: a chain of 32 free bodies against 16 chains of 2, bias and inverse dynamics, opt-level 3.
#
# Both crates hold like numbers of operations, so what rustc spends on any crate weighs alike; what an empty crate
# takes is subtracted. CPU seconds of the best of several runs in turn, so that other work on the machine does not count. Fails where an
# operation of the long function costs more than LIMIT times one of the short functions. Usage: tests/compile_time.sh [RUNS]
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-5}
limit=2.2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A chain of $1 free bodies.
chain() {
    local lower=0 body
    for ((body = 1; body < $1; body++)); do lower+=", $body"; done
    printf 'name = "chain"\ngravity = [0.1, 0.2, -9.81]\nlower_bodies = [%s]\n' "$lower"
    for ((body = 1; body <= $1; body++)); do
        # Numbers differ from body to body: equal ones would be shared.
        printf '\n[[body]]\nname = "b%d"\nmass = 1.%02d\nmass_center = [0.1%02d, -0.2%02d, 0.3%02d]\n' $body $body $body $body $body
        printf 'inertia = { xx = 0.3%02d, yy = 0.4%02d, zz = 0.5%02d, xy = 0.01%02d, xz = -0.02%02d, yz = 0.03%02d }\n' \
            $body $body $body $body $body $body
        printf 'attachment = [0.4%02d, -0.5%02d, 0.6%02d]\njoint = "free"\n' $body $body $body
    done
}

# The operations of the functions of a generated file.
operations() {
    sed -n 's|^/// Operations: \([0-9]*\) .*|\1|p' "$1" | awk '{ sum += $1 } END { print sum }'
}

# A crate of $1 copies of the module $2, on standard output.
copies() {
    local copy
    for ((copy = 1; copy <= $1; copy++)); do
        printf 'pub mod m%d { include!("%s"); pub fn call(q: &[f64; NQ], x: &mut [f64; NU], y: &mut [f64; NU]) {\n' $copy "$2"
        printf 'let p = Prepared::nominal(); bias(&p, q, x, y); inverse_dynamics(&p, q, y, q, x); } }\n'
    done
}

# CPU seconds of rustc for the crate $1.
seconds() {
    local TIMEFORMAT='%U %S'
    { time rustc --edition 2024 --crate-type lib --emit obj -C opt-level=3 -C codegen-units=1 -A warnings \
        --extern kane="$work/libkane.rlib" -o "$work/out.o" "$1" >&2; } 2>&1 | awk '{ print $1 + $2 }'
}

least() {
    sort -g | head -n 1
}

for bodies in 2 32; do
    chain $bodies > "$work/chain_$bodies.toml"
    cargo kane generate "$work/chain_$bodies.toml" --output "$work/chain_$bodies.rs" --functions bias,inverse_dynamics
done
rustc --edition 2024 --crate-type rlib --crate-name kane -C opt-level=3 -o "$work/libkane.rlib" src/lib.rs
: > "$work/empty.rs"
copies 16 "$work/chain_2.rs" > "$work/short.rs"
copies 1 "$work/chain_32.rs" > "$work/long.rs"
for ((run = 1; run <= runs; run++)); do
    for crate in empty short long; do seconds "$work/$crate.rs" >> "$work/$crate.seconds"; done
done

awk -v empty="$(least < "$work/empty.seconds")" -v short="$(least < "$work/short.seconds")" -v long="$(least < "$work/long.seconds")" \
    -v two="$(operations "$work/chain_2.rs")" -v all="$(operations "$work/chain_32.rs")" -v limit=$limit 'BEGIN {
    short_each = (short - empty) / (16 * two); long_each = (long - empty) / all
    printf "16 chains of 2 bodies: %d operations, %.2f s, %.3f s per thousand\n", 16 * two, short - empty, 1000 * short_each
    printf "1 chain of 32 bodies: %d operations, %.2f s, %.3f s per thousand\n", all, long - empty, 1000 * long_each
    ratio = long_each / short_each
    printf "ratio %.2f, at most %s\n", ratio, limit
    exit !(ratio <= limit)
}'
