#!/bin/sh
# The examples: each compiles alone without warnings, runs, and prints and draws what it says. The first one is built alone, too; the
# others are linked with the implementation that the test programs share. Prints TAP.
root=$PWD
. tests/programs/tap.sh
work=$root/build/tests/examples
rm -rf "$work"
mkdir -p "$work" && cd "$work" || exit 1
CC=${CC:-cc}

explain() { head -n 12 log out 2>/dev/null; }
strict="-std=c99 -Wall -Wextra -Wpedantic -Wshadow -Werror"
shared=$root/build/tests/paradt.o
if [ ! -e "$shared" ]; then
    shared=$work/paradt.o
    echo '#include "paradt.h"' | $CC -O1 -I"$root" -DPARADT_IMPLEMENTATION -x c -c -o "$shared" -
fi
ran() { # name, whether to build it alone: compiles an example and runs it; writes the file out
    rm -f out "$1"
    if [ "$2" = alone ]; then
        $CC $strict -o "$1" "$root/examples/$1.c" -lm >log 2>&1
    else
        sed 's/^#define PARADT_IMPLEMENTATION.*//; s|"../paradt.h"|"paradt.h"|' "$root/examples/$1.c" >"$1.c"
        $CC $strict -fsyntax-only "$root/examples/$1.c" >log 2>&1 && $CC $strict -I"$root" -o "$1" "$1.c" "$shared" -lm >>log 2>&1
    fi && "./$1" >out 2>>log
}
drawn() { # name, least number of elements of the picture
    [ "$(tail -n 1 "$1.svg")" = "</svg>" ] && [ "$(grep -c '^<[a-z]* ' "$1.svg")" -ge "$2" ] && ! grep -q 'nan\|inf' "$1.svg"
}
between() { # low, high, sed expression that takes a number from the file out
    sed -n "$3" out | awk -v low="$1" -v high="$2" '{ good = $1 >= low && $1 <= high } END { exit !good }'
}

ran cube alone && [ "$(wc -l <out)" -eq 6 ]
report $? cube_has_six_tetrahedra
# Which triangle is first depends on the method.
ran square && [ "$(grep -c '^triangle [0-3]: [0-4] [0-4] [0-4]   neighbours:\( [0-3]\)* -1' out)" -eq 4 ] &&
    grep -q ': 3 4 2   neighbours: [0-3] -1 [0-3]$' out && [ "$(wc -l <out)" -eq 4 ]
report $? square_has_four_triangles_with_neighbours
ran dynamic && grep -q '^201 points, ' out && drawn dynamic 350 && [ "$(grep -c '#e65' dynamic.svg)" -ge 3 ]
report $? dynamic_inserts_removes_and_moves
ran interpolate && drawn interpolate 6000 && between 0 0.1 's/.*error //p'
report $? interpolate_comes_near_the_function
ran mesh && drawn mesh 1700 && between 5.8 6 's/.* triangles, \(.*\) neighbours.*/\1/p'
report $? mesh_has_six_neighbours_a_vertex
ran nearest && drawn nearest 600 && between 5 100 's/.*changed \(.*\) times/\1/p'
report $? nearest_follows_the_wanderer
ran fracture && drawn fracture 100 && between 0.999999999999 1.000000000001 's/.*volume //p'
report $? fracture_fills_the_block
# Each edge of a piece comes once in each direction.
awk '
    function close_piece(  e, ends) {
        for (e in edges) { split(e, ends, " "); if (edges[e] != 1 || edges[ends[2] " " ends[1]] != 1) bad++ }
        split("", edges)
    }
    $1 == "o" { close_piece(); pieces++ }
    $1 == "f" { for (i = 2; i <= NF; i++) edges[$i " " (i < NF ? $(i + 1) : $2)]++ }
    END { close_piece(); exit !(pieces == 60 && !bad) }' fracture.obj
report $? pieces_are_closed
ran molecule && drawn molecule 40 && [ "$(wc -l <out)" -eq 10 ] && between 60 100 's/^ethanol //p'
report $? molecule_has_a_volume
ran density && drawn density 1000 && between 0.9 1.3 's/.*: //p'
report $? density_is_that_of_the_model
listed=" paradt paradt_mpi cube square dynamic interpolate mesh nearest fracture molecule density "
for file in "$root"/examples/*.c; do
    name=$(basename "$file" .c)
    case $listed in *" $name "*) ;; *) echo "$name is not tested" >log && (exit 1) && break ;; esac
done
report $? every_example_is_tested
plan
