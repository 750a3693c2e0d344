#!/bin/sh
# How paradt_mpi.h would scale on a larger machine: measures the work of each of up to 256 ranks, one rank at a time,
# and models their messages (study.c, alone/mpi.h). Run the script from the top folder, as `make study` does, with
# nothing else running. Writes build/bench/study.md and prints it.
#
#   STUDY_POINTS=N   number of points; 8,000,000 by default, which need 6 GB of memory
#   STUDY_RUNS=N     number of runs, of which the least times count; 3 by default, which take a quarter of an hour
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
