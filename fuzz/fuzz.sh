#!/bin/sh
# Usage: fuzz.sh SECONDS [HARNESS[:WEIGHT]...]. Fuzzes each harness, or these, for SECONDS * WEIGHT (1, if none is given) without
# sanitizers, and then as long with them, by AFL++ in persistent mode, which is installed if it can be, or else by Clang's
# libFuzzer. What is found is kept in build/fuzz, where the next run goes on. Prints a table, and the files that show a fault. Exit
# status: 0; 1: there are such files; 2: there is nothing to fuzz with.
#
# In the environment:
#     JOBS       how many processes fuzz at a time (all processors)
#     INSTANCES  how many processes share a harness, each for that time, and what they find (1)
#     MANNERS    "plain sanitized", or one of them
root=build/fuzz
JOBS=${JOBS:-$(nproc 2>/dev/null || echo 1)}
INSTANCES=${INSTANCES:-1}
MANNERS=${MANNERS:-plain sanitized}
export ASAN_OPTIONS=abort_on_error=1:symbolize=0:detect_leaks=0:allocator_may_return_null=1
export UBSAN_OPTIONS=abort_on_error=1:symbolize=0
export AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1 AFL_AUTORESUME=1 AFL_QUIET=1
# a run takes less than finding out how to shorten its input
export AFL_DISABLE_TRIM=1 AFL_FAST_CAL=1

# The library is compiled once for all harnesses, and again when it has changed. With sanitizers it is not optimized, and undefined
# behaviour is a trap, as compiling takes many minutes otherwise.
build() { # plain or sanitized, harnesses
    manner=$1
    shift
    flags="-g1 -O2 -include tests/asserts.h -I. -DPARADT_FUZZ_LINKED"
    test $manner = plain || flags="$flags -O0 -fsanitize=address,undefined -fsanitize-trap=undefined"
    test $manner = plain || export AFL_DONT_OPTIMIZE=1
    mkdir -p $root/$manner
    library=$root/$manner/paradt_$fuzzer.o
    if [ -z "$(find $library -newer paradt.h -newer tests/asserts.h 2>/dev/null)" ]; then
        echo '#include "paradt.h"' >$root/paradt.c
        $compiler $flags -fsanitize=fuzzer-no-link -DPARADT_IMPLEMENTATION -c -o $library $root/paradt.c || exit 2
    fi
    for harness; do
        $compiler $flags -fsanitize=fuzzer -o $root/$manner/$harness fuzz/fuzz_$harness.c $library $zlib -pthread -lm || exit 2
    done
}

dictionary() { # harness, the option that names a dictionary
    test -e fuzz/$1.dict && echo "$2fuzz/$1.dict"
}

# The sum of a number in AFL++'s statistics over all instances
total() { # its name
    cat $found/*/fuzzer_stats 2>/dev/null | awk -v name="$1" '$1 == name { sum += $3 } END { printf "%.0f", sum }'
}

row() { # harness, manner, runs, runs a second, paths, coverage, faults
    printf '%-12s %-10s %12s %8s %8s %16s %7s\n' "$@"
}

# Fuzzes one harness. 5 seconds are a hang: inputs take a tenth at most, but processors may be busy. Prints how many runs that were.
by_afl() { # harness, manner, number of the instance, seconds
    found=$root/found/$2/$1 first=fuzz/corpus/$1 log=$root/$2/$1.$3.log
    mkdir -p $found
    # the sanitized one begins with what the other one has found
    test $2 = sanitized && set -- "$@" $root/found/plain/$1/*/queue && test -d "$5" && first=$5
    test $3 = 1 && find $first -maxdepth 1 -type f | xargs -n 100 sh "$0" --replay $2 $1
    test $2 = sanitized && export AFL_NO_STARTUP_CALIBRATION=1 # of thousands of inputs
    own=$found/$3/fuzzer_stats
    before=$(sed -n 's/^execs_done *: *//p' $own 2>/dev/null)
    afl-fuzz -V $4 -t 5000 -m none -i $first -o $found -S $3 $(dictionary $1 "-x ") -- $root/$2/$1 >$log 2>&1 ||
        tail -5 $log >&2
    after=$(sed -n 's/^execs_done *: *//p' $own 2>/dev/null)
    echo $((${after:-0} - ${before:-0}))
}

by_libfuzzer() {
    found=$root/found/libfuzzer/$1 log=$root/$2/$1.$3.log
    mkdir -p $found $root/$2/faults
    $root/$2/$1 -max_total_time=$4 -timeout=5 -rss_limit_mb=0 -print_final_stats=1 -max_len=4096 \
        -artifact_prefix=$root/$2/faults/$1- $(dictionary $1 -dict=) $found fuzz/corpus/$1 >$log 2>&1
    sed -n 's/^stat::number_of_executed_units: *//p' $log
}

# Runs files, as AFL++ leaves out those that show a fault at its start: manner, harness, files
if [ "$1" = --replay ]; then
    program=$root/$2/$3 faults=$root/$2/faults/$3
    shift 3
    timeout 300 $program "$@" >/dev/null 2>&1 && exit 0
    mkdir -p ${faults%/*}
    for file; do
        timeout 20 $program $file >/dev/null 2>&1 || cp $file $faults-${file##*/}
    done
    exit 0
fi

# One process: fuzzer, manner, harness, number of the instance, seconds
if [ "$1" = --one ]; then
    echo "$4, $3, by $2: $6 seconds"
    by_$2 $4 $3 $5 $6 >$root/runs/$3.$4.$5
    exit 0
fi

seconds=${1:-60}
test $# -gt 0 && shift
rm -rf $root/runs
mkdir -p $root/runs
sh tests/setup.sh $root/have.mk clang afl++ >$root/setup.log
if command -v afl-fuzz >/dev/null 2>&1 && command -v afl-clang-fast >/dev/null 2>&1; then
    fuzzer=afl compiler=afl-clang-fast
elif command -v clang >/dev/null 2>&1; then
    fuzzer=libfuzzer compiler=clang
    echo "There is no AFL++ (apt-get install afl++): libFuzzer does the work."
else
    echo "There is neither AFL++ nor Clang:  apt-get install afl++ clang"
    exit 2
fi
zlib=$(echo 'int main(void) { return zlibVersion() == 0; }' | cc -include zlib.h -x c -o $root/probe - -lz 2>/dev/null &&
    echo "-DPARADT_ZLIB -lz")
test $# -gt 0 || set -- $(ls fuzz/fuzz_*.c | sed 's|fuzz/fuzz_\(.*\)\.c|\1|')

# The processes that take longest begin first; those of a harness begin together.
for manner in $MANNERS; do
    build $manner $(for harness; do echo ${harness%%:*}; done)
    for harness; do
        case $harness in *:*) weight=${harness#*:} ;; *) weight=1 ;; esac
        for instance in $(seq $INSTANCES); do
            echo $fuzzer $manner ${harness%%:*} $instance $(awk "BEGIN { print int($seconds * $weight + 0.5) }")
        done
    done | sort -s -k5,5nr | xargs -P $JOBS -L 1 sh "$0" --one
done

: >$root/table
: >$root/faults
for manner in $MANNERS; do
    for harness; do
        harness=${harness%%:*}
        runs=$(cat $root/runs/$manner.$harness.* | awk '{ sum += $1 } END { printf "%.0f", sum }')
        if [ $fuzzer = afl ]; then
            found=$root/found/$manner/$harness
            ls $found/*/crashes/id* $found/*/hangs/id* $root/$manner/faults/$harness-* 2>/dev/null >$root/shown
            row $harness $manner $runs "$(total execs_per_sec)" "$(total corpus_count)" \
                "$(cat $found/*/fuzzer_stats | awk '$1 == "edges_found" && $3 > found { found = $3 }
                    $1 == "total_edges" { all = $3 } END { print found " of " all }')" $(wc -l <$root/shown)
        else
            log=$root/$manner/$harness.1.log
            ls $root/$manner/faults/$harness-* 2>/dev/null >$root/shown
            row $harness $manner $runs "$(sed -n 's/^stat::average_exec_per_sec: *//p' $log)" \
                "$(ls $root/found/libfuzzer/$harness | wc -l)" "$(sed -n 's/.* cov: \([0-9]*\).*/\1 edges/p' $log | tail -1)" \
                $(wc -l <$root/shown)
        fi >>$root/table
        cat $root/shown >>$root/faults
    done
done
echo
row harness manner runs "a second" paths "edges covered" faults
cat $root/table
awk '{ sum[$2] += $3; all += $3 } END { for (manner in sum) printf "%s runs: %.0f\n", manner, sum[manner]
    printf "all runs: %.0f\n", all }' $root/table
if [ -s $root/faults ]; then
    echo "These show faults (build/tests/fuzz/fuzz_HARNESS FILE replays one, after make test-programs):"
    cat $root/faults
    exit 1
fi
