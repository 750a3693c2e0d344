#!/bin/sh
# How paradt_mpi.h would scale past this machine: the work of each of up to 256 ranks measured alone, one after another
# (study.c, alone/mpi.h), and a model of their messages. Run it from the top folder, as `make study` does, with nothing
# else running. Writes build/bench/study.md, also to standard output.
#
#   STUDY_POINTS=N   8,000,000 by default, which take 6 GB
#   STUDY_RUNS=N     3 by default, of which the least times count; a quarter of an hour
points=${STUDY_POINTS:-8000000}
runs=${STUDY_RUNS:-3}
work=build/bench
{
    echo "2 microseconds a message, 10^10 bytes a second; times in seconds."
    echo
    echo "| points | ranks | work | slowest | time | of it messages | efficiency | guessed | asked | cells again | bytes a point | sent |"
    echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
    "$work/study" "$runs" "gen:uniform:$points:1" 1 2 4 8 16 32 64 128 256
    "$work/study" "$runs" "gen:clusters:$points:1" 1 8 64 256
    "$work/study" "$runs" "gen:plummer:$points:1" 1 8 64 256
} | tee "$work/study.md"
echo "Written: $work/study.md"
