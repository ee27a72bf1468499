#!/usr/bin/env bash
# Fuzzes a target: `fuzz/run.sh toml -runs=1000000`, or `urdf`, `mjcf`, `generate`. No run may panic, take more than a second or
# more than a GiB; what made one do so then stands in fuzz/artifacts. `cargo fuzz tmin` makes it small, and it becomes a file of
# codegen/tests/fuzzed, from where every test run reads it.
#
# Without a sanitizer: the generator has no `unsafe` code, so there is nothing for one to find, and runs are many times faster.
# That needs no nightly compiler, either; `cargo install --locked cargo-fuzz` is all.
set -euo pipefail
cd "$(dirname "$0")"

target=${1:?toml, urdf, mjcf or generate}
shift
corpus=corpus/$target
mkdir -p "$corpus" dictionaries

# Prints the seeds of a format: the models of this repository, right ones and wrong ones.
models() {
    case $1 in
        toml) find ../models ../codegen/tests -name '*.toml' -not -path '*/config/*' ;;
        urdf) find ../tests/robots ../codegen/tests -name '*.urdf' ;;
        mjcf) find ../tests/mjcf ../codegen/tests -name '*.xml' ;;
    esac
}

# Copies the seeds of a format, with these bytes before them.
seed() {
    models "$1" | while read -r model; do
        { printf '%b' "$2"; cat "$model"; } > "$corpus/$(sha1sum < "$model" | cut -c 1-16)"
    done
}

if [[ $target == generate ]]; then
    seed toml '\x00\x00\x00\xff'
    seed urdf '\x01\x01\x2a\xff'
    seed mjcf '\x02\x30\x11\xff'
    for number in $(seq 100); do
        { printf '\x03'; seq "$number" 100000 | sha512sum; seq "$number" 20000 | sha512sum -b; } > "$corpus/tree$number"
    done
    readers=(toml urdf mjcf)
else
    seed "$target" ''
    readers=("$target")
fi

# Whatever word the readers know.
for reader in "${readers[@]}"; do
    cat "../codegen/src/description/$reader"/*.rs ../codegen/src/description/mod.rs
done | grep -oE '"[A-Za-z0-9_]+"' | sort -u > "dictionaries/$target"
echo '"\x00"' >> "dictionaries/$target"

exec cargo fuzz run --fuzz-dir . --sanitizer none "$target" -- \
    -timeout=1 -rss_limit_mb=1024 -max_len=10000 -dict="dictionaries/$target" "$@"
