#!/bin/sh
# Usage: fuzz.sh SECONDS [HARNESS...]. Fuzzes each harness for so long without sanitizers, and then as long with them, one after
# the other: by AFL++ in persistent mode, which is installed if it can be, or else by Clang's libFuzzer. What is found is kept in
# build/fuzz, where the next run goes on. Prints a table, and the files that show a fault. Exit status: 0; 1: there are such
# files; 2: there is nothing to fuzz with.
seconds=${1:-60}
test $# -gt 0 && shift
root=build/fuzz
mkdir -p $root
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
export ASAN_OPTIONS=abort_on_error=1:symbolize=0:detect_leaks=0:allocator_may_return_null=1
export UBSAN_OPTIONS=abort_on_error=1:symbolize=0
export AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_UI=1 AFL_NO_AFFINITY=1 AFL_AUTORESUME=1 AFL_QUIET=1

# The library is compiled once for all harnesses, and again when it has changed.
build() { # plain or sanitized
    manner=$1
    shift
    flags="-g1 -O1 -include tests/asserts.h -I. -DPARADT_FUZZ_LINKED"
    test $manner = plain || flags="$flags -fsanitize=address,undefined -fno-sanitize-recover=all"
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

value() { # name in AFL++'s statistics
    sed -n "s/^$1 *: *//p" "$found/default/fuzzer_stats" 2>/dev/null
}

row() { # harness, manner, runs, runs a second, paths, coverage, faults
    printf '%-12s %-10s %12s %8s %8s %16s %7s\n' "$@"
}

dictionary() { # harness, the option that names a dictionary
    test -e fuzz/$1.dict && echo "$2fuzz/$1.dict"
}

# Fuzzes one harness and adds a row to the table. 5 seconds are a hang: inputs take a tenth at most, but processors may be busy.
by_afl() {
    harness=$1 manner=$2 found=$root/found/$2/$1 first=fuzz/corpus/$1
    mkdir -p "$found"
    # the sanitized one begins with what the other one has found
    test $manner = sanitized && test -d $root/found/plain/$harness/default/queue && first=$root/found/plain/$harness/default/queue
    afl-fuzz -V $seconds -t 5000 -m none -i $first -o $found $(dictionary $harness "-x ") -- $root/$manner/$harness \
        >$root/$manner/$harness.log 2>&1 || tail -5 $root/$manner/$harness.log
    faults=$(ls $found/default/crashes $found/default/hangs 2>/dev/null | grep -c '^id')
    row $harness $manner "$(value execs_done)" "$(value execs_per_sec)" "$(value corpus_count)" \
        "$(value edges_found) of $(value total_edges)" $faults >>$root/table
    ls $found/default/crashes/id* $found/default/hangs/id* 2>/dev/null >>$root/faults
}

by_libfuzzer() {
    harness=$1 manner=$2 found=$root/found/libfuzzer/$1 log=$root/$2/$1.log
    mkdir -p "$found" $root/$manner/faults
    $root/$manner/$harness -max_total_time=$seconds -timeout=5 -rss_limit_mb=0 -print_final_stats=1 -max_len=4096 \
        -artifact_prefix=$root/$manner/faults/$harness- $(dictionary $harness -dict=) $found fuzz/corpus/$harness >$log 2>&1
    faults=$(ls $root/$manner/faults/$harness-* 2>/dev/null | wc -l)
    row $harness $manner "$(sed -n 's/^stat::number_of_executed_units: *//p' $log)" \
        "$(sed -n 's/^stat::average_exec_per_sec: *//p' $log)" "$(ls $found | wc -l)" \
        "$(sed -n 's/.* cov: \([0-9]*\).*/\1 edges/p' $log | tail -1)" $faults >>$root/table
    ls $root/$manner/faults/$harness-* 2>/dev/null >>$root/faults
}

: >$root/table
: >$root/faults
for manner in plain sanitized; do
    build $manner "$@"
    for harness; do
        echo "$harness, $manner, by $fuzzer: $seconds seconds"
        by_$fuzzer $harness $manner
    done
done
echo
row harness manner runs "a second" paths "edges covered" faults
cat $root/table
awk '{ sum += $3 } END { print "all runs: " sum }' $root/table
if [ -s $root/faults ]; then
    echo "These show faults (build/tests/fuzz/fuzz_HARNESS FILE replays one, after make test-programs):"
    cat $root/faults
    exit 1
fi
