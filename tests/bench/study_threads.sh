#!/bin/sh
# How paradt.h would scale on a larger machine: measures the work of each task of up to 64 threads, one task at a time
# (study_threads.c says what is emulated). Run the script from the top folder, as `make study-threads` does; what else
# runs matters little. Writes build/bench/study_threads.md and prints it.
#
#   STUDY_POINTS="N..."  numbers of points; 1,000,000 and 8,000,000 by default, which need 6 GB of memory
#   STUDY_RUNS=N         number of runs, of which the least times count; 3 by default, which take a quarter of an hour
work=build/bench
runs=${STUDY_RUNS:-3}
{
    echo "Milliseconds; a region a thread; 10 microseconds a step are added."
    for points in ${STUDY_POINTS:-1000000 8000000}; do
        for kind in uniform clusters; do
            echo
            "$work/study_threads" "$runs" "gen:$kind:$points:1" 1 real 2 4 8 16 32 64
        done
    done
} | tee "$work/study_threads.md"
echo "Written: $work/study_threads.md"
