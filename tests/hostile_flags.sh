#!/bin/sh
# Flags and modes that break careless floating-point code change no cell. One program prints the hashes and certificates of every
# family by every method; its output must be the same, however it is built and in whatever mode it runs. The first run prints all
# lines, each later one the next seventh of them. A second program does the same with living sets, queries and Voronoi diagrams, in
# few builds, as it compiles what the first one leaves out. Prints TAP.
work=build/tests/hostile
rm -rf "$work"
mkdir -p "$work"
points=$work/points
source=tests/programs/hashes.c
. tests/programs/tap.sh
share=-1
can() { # compiler, flags: does it build here what runs here?
    echo 'int main(void) { return 0; }' >"$work/probe.c"
    "$@" "$work/probe.c" -o "$work/probe" -lm >"$work/probe.log" 2>&1 && $runner "$work/probe"
}
runner= # the command that runs programs for another processor

# same NAME "MODES" COMPILER FLAGS...: builds once, and runs once plainly and once in each mode; "+" joins modes.
same() {
    name=$1 modes=$2
    shift 2
    if ! has "$1"; then
        skip "$name" "$1 is not installed"
        return
    fi
    if ! can "$@"; then
        skip "$name" "$1 can't build and run with these flags here"
        return
    fi
    if ! "$@" -I. $source -o "$work/$name" -lm >"$work/$name.log" 2>&1; then
        report 1 "$name" "$work/$name.log"
        return
    fi
    for mode in plain $modes; do
        test=${name}_$(echo "$mode" | tr + _)
        if [ "$mode" = plain ]; then arguments=; else arguments=$(echo "$mode" | tr + ' '); fi
        # shellcheck disable=SC2086
        timeout 200 $runner "$work/$name" "$points" $share $arguments >"$work/$test.out" 2>"$work/$test.log"
        status=$?
        if [ $status != 0 ]; then
            { echo "ended with status $status after:" && tail -n 1 "$work/$test.out"; } >>"$work/$test.log"
            report 1 "$test" "$work/$test.log"
        elif [ ! -e "$work/expected" ]; then
            # The first output is the expectation. Its certificates prove that it is right.
            mv "$work/$test.out" "$work/expected"
            for seventh in 0 1 2 3 4 5 6; do awk "NR % 7 == ($seventh + 1) % 7" "$work/expected" >"$work/expected_$seventh"; done
            grep -v 'certificate: done$' "$work/expected" >"$work/$test.log"
            [ -s "$work/expected_6" ] && [ ! -s "$work/$test.log" ]
            report $? "$test" "$work/$test.log"
        else
            diff "$work/expected_$share" "$work/$test.out" >"$work/$test.log"
            report $? "$test" "$work/$test.log"
        fi
        share=$(((share + 1) % 7))
    done
}

# uses NAME "MODES" COMPILER FLAGS...: the same for the second program, which always prints all lines.
uses() {
    name=$1 modes=$2
    shift 2
    if ! can "$@"; then
        skip "$name" "$1 can't build and run with these flags here"
        return
    fi
    if ! "$@" -I. tests/programs/uses.c -o "$work/$name" -lm >"$work/$name.log" 2>&1; then
        report 1 "$name" "$work/$name.log"
        return
    fi
    for mode in plain $modes; do
        test=${name}_$(echo "$mode" | tr + _)
        if [ "$mode" = plain ]; then arguments=; else arguments=$(echo "$mode" | tr + ' '); fi
        # shellcheck disable=SC2086
        if ! timeout 200 "$work/$name" "$points" $arguments >"$work/$test.out" 2>"$work/$test.log"; then
            report 1 "$test" "$work/$test.log"
        elif [ ! -e "$work/uses" ]; then
            mv "$work/$test.out" "$work/uses"
            grep -v ': living done .*, tree done .*, flips done .*, located done .*, nearest done ' "$work/uses" >"$work/$test.log"
            [ -s "$work/uses" ] && [ ! -s "$work/$test.log" ] && grep -q 'clipped done ' "$work/uses"
            report $? "$test" "$work/$test.log"
        else
            diff "$work/uses" "$work/$test.out" >"$work/$test.log"
            report $? "$test" "$work/$test.log"
        fi
    done
}

if ! build/tests/families "$points"; then
    echo "not ok 1 - the_points_are_written"
    exit 1
fi
reference=cc
has gcc && reference=gcc
# The reference has assertions, and the optimisation of the test programs, whose object it shares.
same reference "up down zero" $reference -O2 -DHASHES_LINKED build/tests/paradt.o
if [ ! -s "$work/expected" ]; then
    plan
    exit 1
fi
case $(uname -m) in
x86_64 | i?86) sse="ftz up+ftz" x87="single double double+down" ;;
*) sse= x87= ;;
esac
uses reference_uses "up down zero" $reference -O2 -DUSES_LINKED build/tests/paradt.o
uses gcc_native_fast_math_uses "up $sse" gcc -O1 -march=native -ffast-math -ffp-contract=fast
uses gcc_x87_uses "$x87" gcc -O1 -m32 -mfpmath=387 -mno-sse
same gcc_O0 "up" gcc -O0
same gcc_no_simd "" gcc -O2 -DPARADT_NO_SIMD -Wall -Wextra -Werror
same gcc_index64 "" gcc -O1 -DPARADT_INDEX64
same gcc_Ofast "up $sse" gcc -Ofast
same gcc_native "zero $sse" gcc -O3 -march=native
same gcc_native_fast_math "up $sse" gcc -O2 -march=native -ffast-math -ffp-contract=fast
same gcc_x87 "up $x87" gcc -O2 -m32 -mfpmath=387 -mno-sse
same gcc_x87_Ofast "single" gcc -Ofast -m32 -mfpmath=387 -mno-sse
same gcc_m32_sse "$sse" gcc -O2 -m32 -msse2 -mfpmath=sse
same clang_O2 "down" clang -O2 -Wall -Wextra -Werror
same clang_native_fast "up $sse" clang -Ofast -march=native -w
same clang_x87 "double+down" clang -O2 -m32 -mno-sse
same tcc "" tcc
runner=qemu-aarch64
if has $runner; then same arm64_Ofast "" clang --target=aarch64-linux-gnu -Ofast -static -w; else skip arm64_Ofast "$runner is not installed"; fi
# The default stack of wasm-ld is too small for the exact stages.
runner="node --no-warnings tests/programs/wasi.mjs"
if has node; then
    same wasm_Ofast "" clang --target=wasm32-wasi -Ofast -msimd128 -Wl,-z,stack-size=262144 -w
else
    skip wasm_Ofast "node is not installed"
fi
plan
