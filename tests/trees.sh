#!/usr/bin/env bash
# The promises about generated code, on random trees, which are the same for each of them: prints how much was compared.
#
# Fails where one promise does not hold for one tree. Ordinary runs of these tests try a few of the trees.
# Usage: tests/trees.sh [TREES]   by default 50, which take about an hour
set -euo pipefail
cd "$(dirname "$0")/.."
export KANE_TREES=${1:-50}

step() { printf '\n== %s\n' "$*"; }

# The random trees of some of the tests of a package that start compilers.
trees() { cargo test --quiet --package "$1" --test compiled -- --nocapture "$2random_trees"; }

step "the tests beside a module pass, and see a wrong token"
trees kane-codegen beside::

step "machine code: no jump, no call, no panic, no memory but arguments, stack and constants"
trees kane-codegen object::

step "every call executes as many instructions"
tests/constant_time.sh trees "$KANE_TREES" | awk 'NR > 1 { n++ } / calls, of / { print } END { print n " functions, 1000 calls each" }'

step "C is given the bits of Rust"
trees kane ""

step "microcontrollers compute the bits of this machine"
firmware/run.sh | awk '{ print } /^All [0-9]+ numbers/ { sum += $2 } END { print sum " numbers of each microcontroller in all" }'
