#!/bin/sh
# Every fuzz harness survives every file of its corpus. Harnesses are built with the sanitizers, if there are any. Prints TAP.
number=0
for source in fuzz/*.c; do
    harness=$(basename "$source" .c)
    for seed in fuzz/corpus/*; do
        number=$((number + 1))
        log=build/tests/fuzz/$harness.log
        if timeout 120 "build/tests/fuzz/$harness" "$seed" >"$log" 2>&1; then
            echo "ok $number - ${harness}_survives_$(basename "$seed")"
        else
            echo "not ok $number - ${harness}_survives_$(basename "$seed")"
            tail -15 "$log" | sed 's/^/# /'
        fi
    done
done
echo "1..$number"
