# What tests of builds have in common: two programs are built in many manners, and must print the same, whatever the compiler, its
# flags, the processor and the mode. A test sets work, a folder of its own, sources this file after tap.sh, and calls begin.
points=$work/points
runner= # the command that runs programs for another processor
seconds=200
# Each run prints the next eleventh of the first program's lines, or third of the second one's. Where whole is 1, each prints all.
whole=
share=-1

# Writes the points, and runs the builds that the others are compared with. They have assertions, and the optimisation of the test
# programs, whose object they share.
begin() { # "MODES" of the first program, "MODES" of the second
    rm -rf "$work"
    mkdir -p "$work"
    if ! build/tests/families "$points"; then
        echo "not ok 1 - the_points_are_written"
        exit 1
    fi
    reference=cc
    has gcc && reference=gcc
    same reference "$1" $reference -O2 -DHASHES_LINKED build/tests/paradt.o
    if [ ! -s "$work/expected_-1" ]; then
        plan
        exit 1
    fi
    whole=1
    share=-1
    uses reference_uses "$2" $reference -O2 -DUSES_LINKED build/tests/paradt.o
    whole=
    share=0
}

can() { # compiler, flags: does it build here what runs here?
    echo 'int main(void) { return 0; }' >"$work/probe.c"
    "$@" "$work/probe.c" -o "$work/probe" -lm >"$work/probe.log" 2>&1 && $runner "$work/probe"
}

# show NAME "MODES" SOURCE COMPARE COMPILER FLAGS...: builds once, runs once plainly and once in each mode, and hands each run's
# name to COMPARE; "+" joins modes.
show() {
    name=$1 modes=$2 source=$3 compare=$4
    shift 4
    if ! has "$1"; then
        skip "$name" "$1 is not installed"
        return
    fi
    if ! can "$@"; then
        skip "$name" "$1 can't build and run with these flags here"
        return
    fi
    if ! "$@" -I. "$source" -o "$work/$name" -lm >"$work/$name.log" 2>&1; then
        report 1 "$name" "$work/$name.log"
        return
    fi
    for mode in plain $modes; do
        test=${name}_$(echo "$mode" | tr + _)
        if [ "$mode" = plain ]; then arguments=; else arguments=$(echo "$mode" | tr + ' '); fi
        # shellcheck disable=SC2086
        timeout $seconds $runner "$work/$name" "$points" $share $arguments >"$work/$test.out" 2>"$work/$test.log"
        status=$?
        if [ $status != 0 ]; then
            { echo "ended with status $status after:" && tail -n 1 "$work/$test.out"; } >>"$work/$test.log"
            report 1 "$test" "$work/$test.log"
        else
            $compare "$test"
        fi
    done
}

# same NAME "MODES" COMPILER FLAGS...: the hashes and certificates of every family by every method.
same() {
    name=$1 modes=$2
    shift 2
    show "$name" "$modes" tests/programs/hashes.c equal_hashes "$@"
}
equal_hashes() {
    if [ ! -e "$work/expected_-1" ]; then
        # The first output is the expectation. Its certificates prove that it is right.
        mv "$work/$1.out" "$work/expected_-1"
        for part in 0 1 2 3 4 5 6 7 8 9 10; do awk "NR % 11 == ($part + 1) % 11" "$work/expected_-1" >"$work/expected_$part"; done
        grep -v 'certificate: done$' "$work/expected_-1" >"$work/$1.log"
        [ -s "$work/expected_10" ] && [ ! -s "$work/$1.log" ]
    else
        diff "$work/expected_$share" "$work/$1.out" >"$work/$1.log"
    fi
    report $? "$1" "$work/$1.log"
    [ "$whole" = 1 ] || share=$(((share + 1) % 11))
}

# uses NAME "MODES" COMPILER FLAGS...: living sets, queries and Voronoi diagrams.
uses() {
    name=$1 modes=$2
    shift 2
    show "$name" "$modes" tests/programs/uses.c equal_uses "$@"
}
equal_uses() {
    if [ ! -e "$work/uses" ]; then
        mv "$work/$1.out" "$work/uses"
        grep -v ': living done .*, tree done .*, flips done .*, located done .*, nearest done ' "$work/uses" >"$work/$1.log"
        [ -s "$work/uses" ] && [ ! -s "$work/$1.log" ] && grep -q 'clipped done ' "$work/uses"
    else
        awk -v share="$share" 'share < 0 || (NR - 1) % 3 == share % 3' "$work/uses" | diff - "$work/$1.out" >"$work/$1.log"
    fi
    report $? "$1" "$work/$1.log"
    [ "$whole" = 1 ] || share=$(((share + 1) % 11))
}

# both NAME "MODES" "MODES" COMPILER FLAGS...: the two programs with one object of the implementation.
both() {
    name=$1 first=$2 second=$3
    shift 3
    if has "$1" && can "$@" &&
        ! echo '#include "paradt.h"' | "$@" -I. -DPARADT_IMPLEMENTATION -x c -c -o "$work/$name.o" - 2>"$work/$name.log"; then
        report 1 "$name" "$work/$name.log"
        return
    fi
    same "$name" "$first" "$@" -DHASHES_LINKED "$work/$name.o"
    uses "${name}_uses" "$second" "$@" -DUSES_LINKED "$work/$name.o"
}
