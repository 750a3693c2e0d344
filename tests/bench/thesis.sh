#!/bin/sh
# Repeats the experiment of the thesis: ParaInCoDe on uniform points, on 2 and 4 ranks, compared with serial InCoDe and
# with randomized incremental flipping, beside the figures of tables 5.1 to 5.6; and DeWall, by tasks. Then measures
# larger sets and clusters, with replicated and with distributed points. Run the script from the top folder after `make`,
# as `make thesis` does. Writes build/bench/thesis.md, which it prints, and figure 5.1 as build/bench/thesis.svg.
#
#   THESIS=full|quick   all sizes, or only those of the thesis
#   THESIS_RUNS=N       run each case N times and take the fastest run; 3 by default
#
# The thesis does not name its seed, so the points here are others of the same kind. Its parallel output has the cells
# at the border twice. Here each cell is kept once, and the number of cells is that of one rank. The column "dropped"
# counts the cells that a rank made and does not own; with insertion, also cells that are not in the result. For
# flipping the thesis took the program Detri; here it is the method "flip". Detri perturbs places and ParaDT heights
# alone, so that on points with ties their cells would not be the same; on uniform points there are none.
THESIS=${THESIS:-full}
RUNS=${THESIS_RUNS:-3}
SIZES="1000 2000 4000 8000"
work=build/bench
mkdir -p "$work" || exit 1
. tests/programs/mpich.sh
[ -x build/paradt_mpi ] || { echo "thesis.sh: build/paradt_mpi is missing: make builds it where mpicc is found" >&2; exit 1; }
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
processors=$(getconf _NPROCESSORS_ONLN)
series=$work/thesis.series # what the figure shows, a point a line: curve, points, value
: >"$series"

# field NAME FILE: prints a number of the statistics
field() { sed -n "s/^ *\"$1\": \([0-9.]*\),*$/\1/p" "$2"; }

# measure PROGRAM...: leaves the statistics of the fastest run in $work/thesis.json, and its time in $best
measure() {
    best=
    i=0
    while [ $i -lt "$RUNS" ]; do
        i=$((i + 1))
        timeout 600 "$@" >"$work/thesis.run" || return 1
        seconds=$(field seconds "$work/thesis.run")
        if [ -z "$best" ] || awk "BEGIN { exit !($seconds < $best) }"; then
            best=$seconds
            mv "$work/thesis.run" "$work/thesis.json"
        fi
    done
}

# row NAME INPUT "RANKS..." OPTIONS...: prints a line for each number of ranks, with the thesis' figures if it has any
row() {
    name=$1 input=$2 list=$3
    shift 3
    one=
    for p in $list; do
        measure mpiexec -n "$p" build/paradt_mpi --stats - "$@" "$input" || { echo "| $name | $p | failed |"; continue; }
        [ -n "$one" ] || one=$best
        cells=$(field cells "$work/thesis.json")
        again=$(field cells_recomputed "$work/thesis.json")
        build=$(field seconds_build_sum "$work/thesis.json")
        slowest=$(field seconds_build_largest "$work/thesis.json")
        took=$best
        [ "$p" -le "$processors" ] || took=$slowest
        [ "$*" != '--replicated --method incode' ] || echo "incode-$p $name $took" >>"$series"
        echo "$name $p $best $one $cells $again $build $slowest" | awk -v theirs="$(thesis "$name" "$p")" '{
            printf "| %s | %d | %.4f | %.2f | %d | %.2f %% | %.4f | %.4f | %s |\n",
                $1, $2, $3, $4 / $3, $5, 100 * $6 / ($5 ? $5 : 1), $7 / $2, $8, theirs
        }'
    done
}

# thesis NAME RANKS: prints the thesis' figures for a case. The thesis gives ranges over 1,000 to 8,000 points.
thesis() {
    case "$1 $2" in
    "1000 1") echo "6,140 cells" ;;
    "1000 2" | "2000 2" | "4000 2" | "8000 2") echo "speed-up 1.15 to 1.36, 3.5 to 6.5 % twice" ;;
    "1000 4" | "2000 4" | "4000 4" | "8000 4") echo "speed-up 1.45 to 1.68, 6.65 to 8.2 % twice" ;;
    *) echo "" ;;
    esac
}

head_of() {
    echo
    echo "$1"
    echo
    echo "| points | ranks | seconds | speed-up | cells | dropped | building, mean of ranks | slowest | thesis |"
    echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
}

# of CURVE POINTS: prints the time that the series has
of() { sed -n "s/^$1 $2 //p" "$series"; }

# serial INPUT POINTS METHOD: runs the method on one thread, and adds its time to the series
serial() {
    if measure build/paradt --jobs 1 --regions 1 --method "$3" --stats - "$1"; then
        echo "$3 $2 $best" >>"$series"
    fi
}

# Flipping beside InCoDe, serial and on ranks
flipping() {
    echo
    echo "Randomized incremental flipping, serial, beside InCoDe and ParaInCoDe, in seconds (tables 5.4 to 5.6; there Detri)."
    echo "Where there are more ranks than processors, the time is that of building on the slowest rank."
    echo
    echo "| points | cells | flip | InCoDe | 2 ranks | 4 ranks | InCoDe in times of flip | 2 ranks | 4 ranks |"
    echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    for n in "$@"; do
        serial "gen:uniform:$n:1" "$n" flip
        [ -n "$(of flip "$n")" ] || { echo "| $n | failed |"; continue; }
        echo "$n $(field cells "$work/thesis.json") $(of flip "$n") $(of incode-1 "$n") $(of incode-2 "$n") $(of incode-4 "$n")" |
            awk 'NF == 6 {
                printf "| %d | %d | %.4f | %.4f | %.4f | %.4f | %.2f | %.2f | %.2f |\n", $1, $2, $3, $4, $5, $6, $4 / $3, $5 / $3, $6 / $3
            }'
    done
}

# DeWall: the walls of the first levels, then both sides of each
walls() {
    echo
    echo "DeWall by tasks on one machine (thesis, chapter 4), in seconds: no cell is made twice"
    echo
    echo "| points | 1 thread | 2 threads | 4 threads | speed-up on 2 | on 4 | cells | made twice |"
    echo "| --- | --- | --- | --- | --- | --- | --- | --- |"
    for n in "$@"; do
        line=$n
        for p in 1 2 4; do
            if measure build/paradt --jobs "$p" --regions "$p" --method dewall --stats - "gen:uniform:$n:1"; then
                line="$line $best"
                echo "dewall-$p $n $best" >>"$series"
            else
                line="$line failed failed" # not six fields: no row
            fi
        done
        echo "$line $(field cells "$work/thesis.json") $(field cells_recomputed "$work/thesis.json")" | awk 'NF == 6 {
            printf "| %d | %.4f | %.4f | %.4f | %.2f | %.2f | %d | %d |\n", $1, $2, $3, $4, $2 / $3, $2 / $4, $5, $6
        }'
    done
}

{
    echo "# The thesis' experiment, on $processors processors"
    echo
    echo "Seconds are the wall time of the call on the slowest rank, in the fastest of $RUNS runs. If there are more ranks"
    echo "than processors, the speed-up means little; the other columns are still valid."
    head_of "ParaInCoDe: every rank has all points and builds its region by InCoDe (tables 5.1 to 5.3)"
    for n in $SIZES; do
        row "$n" "gen:uniform:$n:1" "1 2 4" --replicated --method incode
    done
    # shellcheck disable=SC2086
    flipping $SIZES
    # shellcheck disable=SC2086
    walls $SIZES
    head_of "The same points distributed, by the default method"
    for n in $SIZES; do
        row "$n" "gen:uniform:$n:1" "1 2 4"
    done
    if [ "$THESIS" = full ]; then
        walls 100000 1000000
        head_of "Larger sets, replicated, by InCoDe"
        for input in uniform:100000 uniform:1000000 clusters:100000; do
            row $input gen:$input:1 "1 2 4" --replicated --method incode
        done
        head_of "Larger sets, distributed, by the default method"
        for input in uniform:100000 uniform:1000000 clusters:100000 clusters:1000000; do
            row $input gen:$input:1 "1 2 4"
        done
    fi
} | tee "$work/thesis.md"
awk -v sizes="$SIZES" -v processors="$processors" -f tests/bench/thesis.awk "$series" >"$work/thesis.svg" &&
    echo "Written: $work/thesis.md, $work/thesis.svg"
