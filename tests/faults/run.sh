#!/bin/sh
# Usage: run.sh [NAME...]. Plants the faults of tests/faults/*.patch one by one and runs the tests that should see them, JOBS at a
# time. Prints a line for each, and at the end "N caught, M missed". Fails if one is missed or can't be planted.
#
# A patch is a unified diff of one fault. It is found by its context, so that it survives when lines move. Its first line is
#     TEST... -- what is wrong
# with the tests that should see it, the quickest first. A test is tests/NAME.c, as NAME or NAME:PATTERN for those of its tests
# whose names match (* and ?); tests/NAME.sh, as NAME.sh; or ranks:N, the first N cases of tests/programs/ranks.c (N,weights: its
# cases with weights). NAME+MACRO is a test that contains the implementation, built with a macro.
# A fault is caught when a test fails, crashes or takes more than FAULT_SECONDS of the processor. Before, each of these tests has to
# pass without a fault. A program under test is built with FAULT_FLAGS.
CC=$(command -v clang || echo "${CC:-cc}") # without optimisation clang takes half of the time
FAULT_SECONDS=${FAULT_SECONDS:-100}
FAULT_FLAGS=${FAULT_FLAGS:--O0}
here=${FAULTS:-tests/faults} # where the patches are
work=build/faults
flags="$FAULT_FLAGS -include tests/asserts.h -I. -Itests"
libraries="-pthread -lcmocka -lgmp -lm"

# Makes the folder $work/NAME with a copy of all that tests need.
plant() {
    rm -rf "$work/$1"
    mkdir -p "$work/$1/build/tests" "$work/$1/examples" "$work/$1/tests"
    cp paradt.h paradt_mpi.h Makefile "$work/$1/"
    cp examples/*.[ch] "$work/$1/examples/"
    mkdir "$work/$1/tests/bench"
    cp -r tests/*.* tests/inputs tests/programs "$work/$1/tests/"
    cp -r tests/bench/alone "$work/$1/tests/bench/"
}

# Builds a test in the current folder: $1 is its name, $2 a macro or nothing. What does not contain the implementation is built
# once for all faults.
build() {
    if [ "$1" = ranks ]; then
        $CC $flags -Itests/bench/alone -o build/ranks tests/programs/ranks.c -pthread -lm
    elif grep -q '^ *# *define *PARADT_IMPLEMENTATION' "tests/$1.c"; then
        $CC $flags ${2:+-D$2} -o "build/$1" "tests/$1.c" ../shared/filter.o $libraries
    else
        [ -e build/paradt.o ] || echo '#include "paradt.h"' | $CC $flags -DPARADT_IMPLEMENTATION -x c -c -o build/paradt.o - || return 1
        objects=build/paradt.o
        if [ "$1" = resources ]; then
            objcopy $(for call in malloc realloc calloc madvise; do echo "--redefine-sym $call=watched_$call"; done) \
                build/paradt.o build/watched.o || return 1
            objects=build/watched.o
        fi
        $CC -o "build/$1" "../shared/$1.o" $objects ../shared/filter.o $libraries
    fi
}

# Runs a test in the current folder up to the first failure. Prints that failure's line. Returns 0: passed, 1: failed, 2: not built.
run() {
    program=${1%%:*}
    pattern=
    macro=
    [ "$program" = "$1" ] || pattern=${1#*:}
    case $program in
    *+*) macro=${program#*+} program=${program%%+*} ;;
    esac
    lines=
    case $program in
    *.sh) command="sh tests/$program" ;; # writes line by line itself, and gcc's sanitizers refuse what stdbuf preloads
    *)
        lines="stdbuf -oL"
        build "$program" "$macro" >build/errors 2>&1 || return 2
        command=build/$program
        [ "$program" != ranks ] || command="build/ranks $(echo "$pattern" | tr , ' ')"
        ;;
    esac
    # The command's status comes first, or nothing if it was ended at its first failure.
    {
        ulimit -t "$FAULT_SECONDS"
        CMOCKA_MESSAGE_OUTPUT=TAP TEST_PATTERN=$pattern $lines timeout -k 2 $((20 * FAULT_SECONDS)) $command 2>build/messages
        echo "status $?"
    } 2>/dev/null | awk -v ranks="$([ "$program" = ranks ] && echo 1)" '
        /^ok /     { passed++ }
        /^not ok / { sub(/^not ok [0-9]* *-* */, ""); print; failed = 1; exit }
        /^status / { status = $2; passed += ranks }
        /^case /   { print; failed = 1; exit }
        END {
            if (failed) exit 1
            if (status == 124 || status == 137 || status == 152) print "takes too long"
            else if (status != 0) print "ends with status " status
            else if (!passed) print "has no such test"
            exit status == 0 && passed ? 0 : status == 0 ? 3 : 1
        }' >build/failure
    failed=$?
    case $(cat build/failure) in
    *_build | *_builds) return 2 ;; # that is no test of what was planted
    esac
    return $failed
}

# Plants one fault and prints its line. none/TEST: no fault; the test has to pass.
one() {
    case $1 in
    none/*)
        tests=${1#none/}
        name=none-$(echo "$tests" | tr -c 'a-zA-Z0-9\n' _)
        plant "$name"
        ;;
    *)
        name=$1
        tests=$(sed -n '1s/ -- .*//p' "$here/$1.patch")
        plant "$name"
        if ! (cd "$work/$name" && patch -p1 -F0 -s -f --no-backup-if-mismatch -i "../../../$here/$1.patch" >build/errors 2>&1); then
            echo "error   $name: does not apply: mend $here/$1.patch" | tee "$work/$name.line"
            return
        fi
        ;;
    esac
    start=$(date +%s)
    line=
    cd "$work/$name" || exit 1
    for test in $tests; do
        run "$test"
        case $? in
        0) ;;
        1) line="caught  $name: $test: $(cat build/failure)" && break ;;
        2) line="error   $name: $test does not build: $(grep -m1 error build/errors)" && break ;;
        *) line="error   $name: $test $(cat build/failure)" && break ;;
        esac
    done
    cd ../../..
    [ -n "$line" ] || line="missed  $name: $tests pass"
    echo "$line ($(($(date +%s) - start)) s)" >"$work/$name.line"
    case $1 in
    none/*) sed -n 's/^missed .*//; s/^[a-z]*  *none-[^:]*:/error   without a fault/p' "$work/$name.line" ;;
    *) cat "$work/$name.line" ;;
    esac
    [ -n "$KEEP" ] || rm -rf "${work:?}/$name"
}

if [ "$1" = --one ]; then
    one "$2"
    exit 0
fi

[ $# -gt 0 ] || set -- $(ls $here/*.patch | sed 's|.*/||; s|\.patch$||')
rm -rf $work/*.line
mkdir -p $work/shared
names=$*
tests=$(for name in $names; do sed -n '1s/ -- .*//p' $here/$name.patch; done | tr ' ' '\n' | sort -u)

# What reads TEST_PATTERN, and the tests without the implementation, are the same for all faults.
cat >$work/shared/filter.c <<'END'
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <signal.h>
#include <sys/time.h>
#include <cmocka.h>
// Tests stop sets that do not end by alarms. Under a fault that is no news, so they come sooner, and by the processor's time.
static void ring(int number) {
    (void)number;
    raise(SIGALRM);
}
unsigned alarm(unsigned seconds) {
    struct itimerval timer = {{0, 0}, {seconds < 10 ? seconds : 10, 0}};
    signal(SIGPROF, ring);
    setitimer(ITIMER_PROF, &timer, NULL);
    return 0;
}
__attribute__((constructor)) static void choose_tests(void) {
    const char *pattern = getenv("TEST_PATTERN");
    if (pattern && *pattern)
        cmocka_set_test_filter(pattern);
}
END
$CC -c -o $work/shared/filter.o $work/shared/filter.c || exit 1
for test in $(echo "$tests" | sed '/\.sh/d; /^ranks:/d; s/[:+].*//' | sort -u); do
    grep -q '^ *# *define *PARADT_IMPLEMENTATION' "tests/$test.c" && continue
    $CC $flags -c -o "$work/shared/$test.o" "tests/$test.c" || exit 1
done

{
    [ -n "$ONLY_FAULTS" ] || for test in $tests; do echo "none/$test"; done
    for name in $names; do echo "$name"; done
} | xargs -P "${JOBS:-1}" -I{} sh "$0" --one {}
cat $work/*.line | awk -v planted=$# '
    $1 == "caught" && $2 !~ /^none-/ { caught++ }
    $1 == "missed" && $2 !~ /^none-/ { missed++ }
    $1 == "error" || $1 == "caught" && $2 ~ /^none-/ { wrong++ }
    END {
        printf "%d caught, %d missed%s\n", caught, missed, wrong ? ", " wrong " errors" : ""
        exit missed || wrong || caught != planted
    }'
