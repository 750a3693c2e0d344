#!/bin/sh
# Other processors and manners of building change no cell: the two programs of tests/programs/builds.sh print on each what they print
# here. Big-endian s390x, riscv64 and arm64 have other signs of char and sizes of long double than x86, and may join products and
# sums. Installs what it needs as the tests do. Not one of the tests, as emulated processors are slow: `make machines` runs it.
# The compiler for them is clang: Debian's gcc for other processors takes gcc-multilib away.
# The header is also read by cppcheck and gcc's analyser; what they may report is in tests/programs/analysers.txt, with the reasons.
# Valgrind's memcheck runs an eleventh of the first program (see tests/programs/valgrind.supp).
# Usage: machines.sh [GROUP...]   GROUP: processors, manners, analysers; without one, all. Prints TAP.
work=build/tests/machines
. tests/programs/tap.sh
. tests/programs/builds.sh
mkdir -p build/tests
sh tests/setup.sh build/tests/machines.mk gcc clang gcc-multilib qemu-user lld wasi-libc libclang-rt-dev-wasm32 nodejs cppcheck valgrind \
    binutils-s390x-linux-gnu libc6-dev-s390x-cross libgcc-12-dev-s390x-cross \
    binutils-riscv64-linux-gnu libc6-dev-riscv64-cross libgcc-12-dev-riscv64-cross \
    binutils-aarch64-linux-gnu libc6-dev-arm64-cross libgcc-12-dev-arm64-cross | sed 's/^/# /'
groups=${*:-processors manners analysers}
begin "" ""
seconds=1800

# on RUNNER LINES NAME COMPILER FLAGS...: both programs with all of their lines, or with LINES "few" an eleventh of the first one's.
on() {
    runner=$1 lines=$2 named=$3
    shift 3
    if ! has "${runner%% *}"; then
        skip "$named" "${runner%% *} is not installed"
    elif [ "$lines" = few ]; then
        same "$named" "" "$@"
    else
        whole=1
        share=-1
        same "$named" "" "$@"
        uses "${named}_uses" "" "$@"
        whole=
        share=0
    fi
    runner=
}

processors() {
    share=0
    on qemu-s390x all s390x clang --target=s390x-linux-gnu -O2 -ffp-contract=fast -static -w
    on qemu-riscv64 all riscv64 clang --target=riscv64-linux-gnu -O2 -ffp-contract=fast -static -w
    on qemu-aarch64 all arm64 clang --target=aarch64-linux-gnu -O2 -ffp-contract=fast -static -w
    # The default stack of wasm-ld is too small for the exact stages.
    on "node --no-warnings tests/programs/wasi.mjs" all wasm clang --target=wasm32-wasi -O2 -Wl,-z,stack-size=262144 -w
    on qemu-s390x few s390x_Ofast clang --target=s390x-linux-gnu -Ofast -march=z13 -static -w
    on qemu-riscv64 few riscv64_Ofast clang --target=riscv64-linux-gnu -Ofast -static -w
}

manners() {
    whole=1
    share=-1
    same lto "" gcc -O2 -flto=1
    uses lto_uses "" gcc -O2 -flto=1
    same unsigned_char "" gcc -O2 -funsigned-char
    uses unsigned_char_uses "" gcc -O2 -funsigned-char
    same Ofast_lto "up" gcc -Ofast -flto=1 -w
    uses Ofast_uses "up" gcc -Ofast -w
    same native "zero" gcc -O3 -march=native
    same m32 "" gcc -O2 -m32
    case $(uname -m) in
    x86_64 | i?86)
        same x87 "single up" gcc -O2 -m32 -mfpmath=387 -mno-sse
        same x87_Ofast "single" gcc -Ofast -m32 -mfpmath=387 -mno-sse -w
        uses x87_uses "single up" gcc -O2 -m32 -mfpmath=387 -mno-sse
        ;;
    *) skip x87 "only x86 has it" ;;
    esac
    whole=
}

# explained NAME REPORTS: lines "line|id|message" about paradt.h, of which each is in the list, with that line of the header.
explained() {
    awk -F'|' 'FILENAME ~ /analysers/ { if ($0 !~ /^#/ && NF) known[$0]; next }
        FILENAME == "paradt.h" { sub(/^ +/, ""); text[FNR] = $0; next }
        !($2 "|" text[$1] in known)' tests/programs/analysers.txt paradt.h "$2" >"$2.left"
    [ ! -s "$2.left" ]
    report $? "$1" "$2.left"
}

# analyse NAME COMMAND...: runs an analyser, which ends well.
analyse() {
    name=$1
    shift
    timeout $seconds "$@" >"$work/$name.log" 2>&1
    status=$?
    [ $status = 0 ] || report 1 "$name" "$work/$name.log"
    return $status
}

analysers() {
    printf '#define PARADT_IMPLEMENTATION\n#include "paradt.h"\n' >"$work/implementation.c"
    if has cppcheck; then
        analyse cppcheck cppcheck -q --std=c99 --enable=warning,performance,portability --suppress=missingIncludeSystem -I. \
            -D__GNUC__=12 -D__linux__ -D__x86_64__ -D__LP64__ --platform=unix64 --template='{line}|{id}|{message}' \
            "$work/implementation.c" && explained cppcheck "$work/cppcheck.log"
    else
        skip cppcheck "it is not installed"
    fi
    # More than the core in three dimensions takes the analyser more than some minutes.
    if has gcc && can gcc -fanalyzer; then
        analyse analyzer gcc -fanalyzer --param analyzer-bb-explosion-factor=1 --param analyzer-max-enodes-per-program-point=3 \
            -fdiagnostics-plain-output -DPARADT_MAX_DIM=3 -DPARADT_NO_SIMD -DPARADT_NO_LOCATOR -DPARADT_NO_DYNAMIC -DPARADT_NO_VORONOI \
            -DPARADT_NO_HULLS -DPARADT_NO_FRONTS -DPARADT_NO_REGIONS -I. -c "$work/implementation.c" -o "$work/analyzer.o" && {
            sed -n 's/^[^ ]*paradt.h:\([0-9]*\):[0-9]*: warning: \(.*\) \[\(-W[^]]*\)\]$/\1|\3|\2/p' "$work/analyzer.log" >"$work/analyzer.reports"
            explained analyzer "$work/analyzer.reports"
        }
    else
        skip analyzer "gcc has no -fanalyzer here"
    fi
    if has valgrind; then
        valgrind -q --error-exitcode=9 --suppressions=tests/programs/valgrind.supp "$work/reference" "$points" 0 >"$work/valgrind.out" \
            2>"$work/valgrind.log" && cmp "$work/valgrind.out" "$work/expected_0" >>"$work/valgrind.log"
        report $? valgrind "$work/valgrind.log"
    else
        skip valgrind "it is not installed"
    fi
}

for group in $groups; do
    case $group in
    processors | manners | analysers) $group ;;
    *) echo "machines.sh: no group is named $group" >&2 && exit 2 ;;
    esac
done
plan
