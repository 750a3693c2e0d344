#!/bin/sh
# Every fuzz harness survives every file of its corpus. Harnesses are built with the sanitizers, if there are any. Prints TAP.
# The log of one that does not ends with the name of the file.
. tests/programs/tap.sh
for source in fuzz/fuzz_*.c; do
    harness=$(basename "$source" .c)
    corpus=fuzz/corpus/${harness#fuzz_}
    log=build/tests/fuzz/$harness.log
    timeout 300 "build/tests/fuzz/$harness" "$corpus"/* >"$log" 2>&1
    report $? "${harness}_survives_its_$(ls "$corpus" | wc -l)_seeds" "$log"
done
plan
