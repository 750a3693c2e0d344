#!/bin/sh
# The Delaunay tree has the size that the theory of randomised incremental construction predicts from random samples (see
# tests/bench/theory.c), and the comparison notices when part of the tree is not looked at. Prints TAP.
work=build/tests/theory
mkdir -p "$work"
. tests/programs/tap.sh

tree="-DPARADT_NO_FRONTS -DPARADT_NO_REGIONS -DPARADT_NO_FLIPS -DPARADT_NO_HULLS -DPARADT_NO_MEASURES -DPARADT_NO_LOCATOR
    -DPARADT_NO_DYNAMIC -DPARADT_NO_VORONOI" # the tree alone is compiled
# shellcheck disable=SC2086
${CC:-cc} -O1 -Wall -Wextra -Wshadow -Werror $tree -I. -o "$work/theory" tests/bench/theory.c -lm >"$work/log" 2>&1
report $? the_theory_program_builds_without_warnings "$work/log"

"$work/theory" small >"$work/log" 2>&1 && [ "$(grep -c ' %  (' "$work/log")" = 36 ] && ! grep -q DIFFERENT "$work/log"
report $? the_tree_has_the_predicted_sizes "$work/log"

"$work/theory" small sons-only >"$work/log" 2>&1
[ $? = 1 ] && grep -q 'conflict history .*DIFFERENT' "$work/log"
report $? without_stepsons_conflicts_are_missing "$work/log"
plan
