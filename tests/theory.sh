#!/bin/sh
# The Delaunay tree has the size that the theory of randomised incremental construction predicts from random samples (see
# tests/bench/theory.c), and the comparison notices when part of the tree is not looked at. Prints TAP.
work=build/tests/theory
mkdir -p "$work"
number=0

report() { # ok|not ok, name
    number=$((number + 1))
    echo "$1 $number - $2"
    [ "$1" = ok ] || sed 's/^/# /' "$work/log"
}

if ${CC:-cc} -O2 -Wall -Wextra -Wshadow -Werror -I. -o "$work/theory" tests/bench/theory.c -lm >"$work/log" 2>&1; then
    report ok the_theory_program_builds_without_warnings
else
    report "not ok" the_theory_program_builds_without_warnings
fi

if "$work/theory" small >"$work/log" 2>&1 && [ "$(grep -c ' %  (' "$work/log")" = 36 ] && ! grep -q DIFFERENT "$work/log"; then
    report ok the_tree_has_the_predicted_sizes
else
    report "not ok" the_tree_has_the_predicted_sizes
fi

"$work/theory" small sons-only >"$work/log" 2>&1
status=$?
if [ $status = 1 ] && grep -q 'conflict history .*DIFFERENT' "$work/log"; then
    report ok without_stepsons_conflicts_are_missing
else
    report "not ok" without_stepsons_conflicts_are_missing
fi
echo "1..$number"
