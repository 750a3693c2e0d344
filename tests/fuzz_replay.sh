#!/bin/sh
# Every fuzz harness survives every file of its corpus. Harnesses are built with the sanitizers, if there are any. Prints TAP.
. tests/programs/tap.sh
for source in fuzz/*.c; do
    harness=$(basename "$source" .c)
    for seed in fuzz/corpus/*; do
        log=build/tests/fuzz/$harness.log
        timeout 120 "build/tests/fuzz/$harness" "$seed" >"$log" 2>&1
        report $? "${harness}_survives_$(basename "$seed")" "$log"
    done
done
plan
