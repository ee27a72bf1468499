#!/usr/bin/env bash
# Runs generated functions on two microcontrollers in QEMU, compares their bits with the host's, and prints what they cost.
#
#   [KANE_TREES=N] firmware/run.sh
#
# With KANE_TREES, random trees too, in programs that the flash has room for.
#
# What it lacks it downloads: the compiler's target by rustup, and where that fails Debian's compiler; QEMU from Debian.
#
# FIRMWARE_WORK: the folder of everything that is downloaded and built; by default `firmware` in cargo's target folder.
# FIRMWARE_DEBIAN: 1 for Debian's compiler in any case.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
work=${FIRMWARE_WORK:-${CARGO_TARGET_DIR:-$here/../target}/firmware}
mkdir -p "$work"
work=$(cd "$work" && pwd)
root=$work/debian
target=thumbv7em-none-eabihf

say() { printf '%s\n' "$*" >&2; }

has() { command -v "$1" >/dev/null; }

# What Debian has, installed or unpacked below, before what rustup has.
debian() {
    env PATH="$root/usr/bin:/usr/bin:$PATH" \
        LD_LIBRARY_PATH="$root/usr/lib/$(uname -m)-linux-gnu:$root/lib/$(uname -m)-linux-gnu" "$@"
}

# unpack PACKAGE...: Debian's packages and what they need, in a folder of their own. It takes no rights, and
# nothing that is installed changes.
unpack() {
    if [ -e "$root/$1.unpacked" ]; then return; fi
    if ! has apt-get; then
        say "needed, not here, and there is no apt-get to get it by: $*"
        exit 2
    fi
    say "Debian's packages into $root: $*"
    local apt=(apt-get -qq -o "Dir::State::Lists=$work/lists" -o "Dir::Cache=$work/cache" -o APT::Sandbox::User=root)
    local archives=$work/archives
    mkdir -p "$work/lists/partial" "$archives" "$root"
    "${apt[@]}" update
    "${apt[@]}" install --simulate --no-install-recommends "$@" | sed -n 's/^Inst \([^ ]*\).*/\1/p' >"$archives/names"
    (cd "$archives" && xargs --no-run-if-empty "${apt[@]}" download <names)
    find "$archives" -name '*.deb' -print0 | xargs -0 -I '{}' dpkg-deb --extract '{}' "$root"
    rm -r "$work/lists" "$archives"
    touch "$root/$1.unpacked"
}

# The compiler; `core` is compiled by us where Debian's is used, which has it as source alone.
has_target() { [ -d "$(rustc --print target-libdir --target "$target" 2>/dev/null)" ]; }
add_target() { has rustup && timeout 120 rustup target add "$target"; }
cargo=(cargo)
core=()
if [ "${FIRMWARE_DEBIAN:-0}" = 1 ] || { ! has_target && { [ -e "$root/rustc-web.unpacked" ] || ! add_target; }; }; then
    unpack rustc-web cargo-web rust-web-src binutils-arm-none-eabi
    # An unstable option of a stable compiler.
    export RUSTC_BOOTSTRAP=1 CARGO_TARGET_THUMBV7EM_NONE_EABIHF_LINKER=arm-none-eabi-ld
    cargo=(debian cargo)
    core=(-Zbuild-std=core)
fi

qemu=(timeout 300 qemu-system-arm)
if ! has qemu-system-arm; then
    unpack qemu-system-arm
    qemu=(debian "${qemu[@]}")
fi

# build TARGET OPTION...: with a named target build scripts are compiled once for all.
build() {
    "${cargo[@]}" build --quiet --release --locked --manifest-path "$here/Cargo.toml" --target-dir "$work/target" --target "$@"
}

# microcontroller NAME CPU BOARD
microcontroller() {
    local program=$work/$2 printed=$work/$2.txt
    say "$1: $3"
    # A double-precision unit is used where the processor is named that has it.
    RUSTFLAGS="-C target-cpu=$2" build "$target" "${core[@]}"
    cp "$work/target/$target/release/kane-firmware" "$program"
    # Time passes with instructions, which board.rs counts by it.
    "${qemu[@]}" -machine "$3" -display none -icount shift=7 \
        -semihosting-config enable=on,target=native -kernel "$program" >"$printed" ||
        { say "$1: QEMU ended with $? (124 is after five minutes)"; exit 1; }
    programs+=("$1" "$program" "$printed")
}

host=$("${cargo[@]}" -vV | sed -n 's/^host: //p')

# Runs the program everywhere and compares.
everywhere() {
    programs=()
    microcontroller Cortex-M4F cortex-m4 mps2-an386
    microcontroller Cortex-M7 cortex-m7 mps2-an500
    build "$host"
    "$work/target/$host/release/kane-firmware" "${programs[@]}"
}
everywhere

# The build script reads which of the trees a program has.
batch=10
for ((first = 0; first < ${KANE_TREES:-0}; first += batch)); do
    end=$((first + batch < KANE_TREES ? first + batch : KANE_TREES))
    say "trees $first to $((end - 1))"
    FIRMWARE_TREES="$first $end" everywhere
done
