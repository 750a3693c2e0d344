#!/bin/sh
# use.sh [N [DIM]]: compares what is done with a triangulation: locate, nearest, insert, remove, move, Voronoi cells.
# ParaDT and a peer (CGAL; Voro++ for Voronoi cells) hold the same N uniform points of the unit cube and work by turns:
# each ratio is of two runs right after each other, by CPU time, and the table has the median. "same": the answers of both
# are the same, cell by cell. Default: 1000000 points in 3 dimensions. Run it from the top folder. See use.h.
#
#   USE_OPERATIONS="..."   of the table's; all by default
#   USE_COUNT=K            operations in a run; by default a fortieth of the points: each is removed or moved once at most
#   USE_ROUNDS=R           runs of each; 3 by default
#   USE_FLAGS="..."        flags for the library, as -DPARADT_NO_VORONOI
#   MALLOC_MMAP_MAX_=0 MALLOC_TRIM_THRESHOLD_=8000000000
#                          of glibc: all programs keep the pages that they have had, so that what a page costs on a
#                          host that has to provide each anew is not measured; the first round then has them yet to get
N=${1:-1000000}
DIM=${2:-3}
COUNT=${USE_COUNT:-$((N / 40))}
ROUNDS=${USE_ROUNDS:-3}
B=build/bench
mkdir -p "$B" || exit 1
work=$(mktemp -d) || exit 1
trap 'exec 3>&- 5>&- 7>&-; wait; rm -rf "$work"' EXIT
trap 'exit 130' INT TERM

# A line for each row of the table: our operation, the peer, its operation. Those that change the triangulation come last,
# and set-... after them.
rows() {
    cat <<'END'
triangulate cgal triangulate
create paradt triangulate
locator paradt triangulate
locate-sorted cgal locate-sorted
locate-batch cgal locate-batch
locate-random cgal locate-random
nearest-sorted cgal nearest-sorted
nearest-batch cgal nearest-batch
nearest-random cgal nearest-random
insert-sorted cgal insert-sorted
insert-batch cgal insert-batch
insert-random cgal insert-random
remove-random cgal remove-random
remove-batch cgal remove-batch
move-random cgal move-random
move-batch cgal move-batch
set-locate cgal locate-random
set-nearest cgal nearest-random
cells cgal cells
voronoi voro voronoi
END
}

make --no-print-directory -k -f tests/bench/bench.mk $B/points $B/paradt-use $B/cgal-use $B/voro-use USE_FLAGS="$USE_FLAGS" \
    >"$B/use.log" 2>&1 || { grep -E 'rror|undefined' "$B/use.log" | head -10; echo "Not all could be built: $B/use.log."; }
"$B/points" "gen:uniform:$N:1" "$DIM" 0 "$work/points" || exit 1
"$B/points" "gen:uniform:$((4 * COUNT * ROUNDS)):2" "$DIM" 0 "$work/queries" || exit 1

# start NAME: starts a program, which reads $work/NAME.in and writes $work/NAME.out. One that could not be built has no
# operation.
start() {
    mkfifo "$work/$1.in" "$work/$1.out"
    if [ -x "$B/$1-use" ]; then
        "$B/$1-use" "$1" "$work/points" "$work/queries" <"$work/$1.in" >"$work/$1.out" 3>&- 5>&- 7>&- &
    else
        { echo ready && while read -r _; do echo '{"unknown":""}'; done; } <"$work/$1.in" >"$work/$1.out" 3>&- 5>&- 7>&- &
    fi
}
start paradt
exec 3>"$work/paradt.in" 4<"$work/paradt.out"
start cgal
exec 5>"$work/cgal.in" 6<"$work/cgal.out"
start voro
exec 7>"$work/voro.in" 8<"$work/voro.out"
if ! { read -r _ <&4 && read -r _ <&6 && read -r _ <&8; }; then
    echo "A program failed."
    exit 1
fi

# ask NAME OPERATION COUNT ROUND: leaves the program's line in $line.
ask() {
    line=
    case $1 in
    paradt) echo "$2 $3 $4" >&3 && read -r line <&4 ;;
    cgal) echo "$2 $3 $4" >&5 && read -r line <&6 ;;
    voro) echo "$2 $3 $4" >&7 && read -r line <&8 ;;
    esac
}
knows() { ask "$1" "$2" 0 0 && [ -n "$(field count)" ]; }
field() { echo "$line" | sed -n "s/.*\"$1\":\"\{0,1\}\([^,\"}]*\).*/\1/p"; }

# Reads lines: operation, peer, seconds of ours and theirs, bytes of both, checks of both
table() {
    awk -v n="$N" -v count="$COUNT" '
    function put() {
        if (!rounds) return
        for (i = 2; i <= rounds; i++) # sorts the ratios
            for (k = i; k > 1 && ratio[k] < ratio[k - 1]; k--) { r = ratio[k]; ratio[k] = ratio[k - 1]; ratio[k - 1] = r }
        whole = operation ~ /^(triangulate|create|locator|voronoi)$/
        each = 1e6 / (whole ? n : count)
        memory = whole ? sprintf("%.0f, %.0f MB", bytes / 1e6, their_bytes / 1e6) : ""
        printf "| %s | %.3f | %.3f | %s | %.3f | %s | %s |\n", operation, least * each, their_least * each, peer,
            ratio[int((rounds + 1) / 2)], same, memory
        fflush()
        rounds = 0
    }
    $1 == "cells" { put(); print $7 == $8 ? "All cells are the same in the end." : "THE CELLS DIFFER IN THE END."; next }
    $1 != operation { put(); operation = $1; peer = $2; least = their_least = 1e300; same = "" }
    {
        ratio[++rounds] = $3 / ($4 > 0 ? $4 : 1e-9)
        if ($3 < least) least = $3
        if ($4 < their_least) their_least = $4
        bytes = $5; their_bytes = $6
        if ($7 !~ /^0+$/) same = same == "NO" || $7 != $8 ? "NO" : "yes"
    }
    END { put() }'
}

echo "$N uniform points, d = $DIM, $COUNT operations a run, $ROUNDS runs. CPU microseconds an operation, or a point: least"
echo "of the runs; ratio: median; same: are the answers; memory: of ParaDT, of the peer"
echo
echo "| operation | ParaDT | peer | | ratio | same | memory |"
echo "|---|---|---|---|---|---|---|"
rows | while read -r ours peer theirs; do
    case " ${USE_OPERATIONS:-$ours} " in *" $ours "*) ;; *) continue ;; esac
    [ "$peer" != voro ] || [ "$DIM" = 3 ] || continue
    if ! { knows paradt "$ours" && knows "$peer" "$theirs"; }; then continue; fi
    round=0
    [ "$ours" != cells ] || round=$((ROUNDS - 1))
    while [ "$round" -lt "$ROUNDS" ]; do
        round=$((round + 1))
        ask paradt "$ours" "$COUNT" "$round" || { echo "ParaDT failed at $ours" >&2 && exit 1; }
        mine="$(field seconds)" bytes="$(field bytes)" check="$(field check)"
        ask "$peer" "$theirs" "$COUNT" "$round" || { echo "$peer failed at $theirs" >&2 && exit 1; }
        echo "$ours $peer $mine $(field seconds) $bytes $(field bytes) $check $(field check)"
    done
done | tee "$B/use.txt" | table
