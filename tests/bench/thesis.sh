#!/bin/sh
# Repeats the experiment of the thesis: ParaInCoDe on uniform points, on 2 and 4 ranks, compared with serial InCoDe,
# beside the figures of tables 5.1 to 5.6. Then measures larger sets and clusters, with replicated and with distributed
# points. Run the script from the top folder after `make`, as `make thesis` does. Writes build/bench/thesis.md and
# prints it.
#
#   THESIS=full|quick   all sizes, or only those of the thesis
#   THESIS_RUNS=N       run each case N times and take the fastest run; 3 by default
#
# The thesis does not name its seed, so the points here are others of the same kind. Its parallel output has the cells
# at the border twice. Here each cell is kept once, and the number of cells is that of one rank. The column "dropped"
# counts the cells that a rank made and does not own; with insertion, also cells that are not in the result.
THESIS=${THESIS:-full}
RUNS=${THESIS_RUNS:-3}
work=build/bench
mkdir -p "$work" || exit 1
[ -x build/paradt_mpi ] || { echo "thesis.sh: build/paradt_mpi is missing: make builds it where mpicc is found" >&2; exit 1; }
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
processors=$(getconf _NPROCESSORS_ONLN)

# field NAME FILE: prints a number of the statistics
field() { sed -n "s/^ *\"$1\": \([0-9.]*\),*$/\1/p" "$2"; }

# measure RANKS ARGUMENTS...: leaves the statistics of the fastest run in $work/thesis.json
measure() {
    ranks=$1
    shift
    best=
    i=0
    while [ $i -lt "$RUNS" ]; do
        i=$((i + 1))
        timeout 600 mpiexec -n "$ranks" build/paradt_mpi --stats - "$@" >"$work/thesis.run" || return 1
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
        measure "$p" "$@" "$input" || { echo "| $name | $p | failed |"; continue; }
        [ -n "$one" ] || one=$best
        cells=$(field cells "$work/thesis.json")
        again=$(field cells_recomputed "$work/thesis.json")
        build=$(field seconds_build_sum "$work/thesis.json")
        slowest=$(field seconds_build_largest "$work/thesis.json")
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

{
    echo "# The thesis' experiment, on $processors processors"
    echo
    echo "Seconds are the wall time of the call on the slowest rank, in the fastest of $RUNS runs. If there are more ranks"
    echo "than processors, the speed-up means little; the other columns are still valid."
    head_of "ParaInCoDe: every rank has all points and builds its region by InCoDe (tables 5.1 to 5.6)"
    for n in 1000 2000 4000 8000; do
        row $n gen:uniform:$n:1 "1 2 4" --replicated --method incode
    done
    head_of "The same points distributed, by the default method"
    for n in 1000 2000 4000 8000; do
        row $n gen:uniform:$n:1 "1 2 4"
    done
    if [ "$THESIS" = full ]; then
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
