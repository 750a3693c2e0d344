#!/bin/sh
# The predicates give the same signs with every compiler and set of flags, in every rounding and flushing mode. Built with
# PREDICATES_HASH, tests/predicates.c prints one hash of all signs. Prints TAP.
work=build/tests/predicates_flags
rm -rf "$work"
mkdir -p "$work"
. tests/programs/tap.sh
expected=
runner= # the command that runs programs for another processor

# same NAME MODES COMPILER FLAGS...: in each mode, the program built so prints what the first one printed.
same() {
    name=$1
    modes=$2
    shift 2
    log=$work/$name.log
    result=1
    if "$@" -w -DPREDICATES_HASH -o "$work/$name" tests/predicates.c -lm >"$log" 2>&1; then
        result=0
        for mode in $modes; do
            hash=$($runner "$work/$name" "$mode" 2>&1)
            echo "$mode $hash" >>"$log"
            expected=${expected:-$hash}
            [ -n "$hash" ] && [ "$hash" = "$expected" ] || result=1
        done
    fi
    echo "expected $expected" >>"$log"
    report $result "signs_with_$name" "$log"
}

rounding="nearest up down zero"
for compiler in gcc clang; do
    if ! command -v $compiler >/dev/null 2>&1; then
        skip "signs_with_$compiler" "$compiler is not installed"
        continue
    fi
    flush=
    echo 'int main(void) { return sizeof(__SSE2__) == 0; }' >"$work/probe.c"
    if $compiler "$work/probe.c" -o "$work/probe" 2>/dev/null; then flush=flush; fi
    same ${compiler}_O2 "$rounding $flush" $compiler -O2
    if [ $compiler = gcc ]; then level=-O1; else level=-O0; fi # gcc takes longest without optimisation
    same ${compiler}$(echo $level | tr - _) nearest $compiler $level
    same ${compiler}_without_int128 nearest $compiler -O1 -U__SIZEOF_INT128__
    same ${compiler}_Ofast "$rounding $flush" $compiler -Ofast
    if echo 'int main(void) { return 0; }' | $compiler -march=native -x c - -o "$work/probe" 2>/dev/null; then
        same ${compiler}_O3_native "$rounding" $compiler -O3 -march=native -ffp-contract=fast
        same ${compiler}_Ofast_native "nearest up $flush" $compiler -Ofast -march=native
    else
        skip "signs_with_${compiler}_native" "$compiler has no -march=native here"
    fi
done
if runner=$(sh tests/programs/runner_32.sh gcc -m32 -mfpmath=387); then
    same gcc_m32_387_O2 "nearest up" gcc -m32 -mfpmath=387 -O2
    same gcc_m32_387_Ofast nearest gcc -m32 -mfpmath=387 -Ofast
    same gcc_m32_sse_Ofast "nearest flush" gcc -m32 -msse2 -mfpmath=sse -Ofast
else
    skip signs_with_gcc_m32 "gcc can't build for -m32 with x87 here, or nothing runs it"
fi
runner=
if command -v tcc >/dev/null 2>&1; then
    same tcc "nearest up" tcc
else
    skip signs_with_tcc "tcc is not installed"
fi
plan
