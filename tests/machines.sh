#!/bin/sh
# Other processors and manners of building change no cell: the two programs of tests/programs/builds.sh print on each what they print
# here. Big-endian s390x, riscv64 and arm64 have other signs of char and sizes of long double than x86, and may join products and
# sums. Installs what it needs as the tests do. Not one of the tests, as emulated processors are slow: `make machines` runs it.
# The compiler for them is clang: Debian's gcc for other processors takes gcc-multilib away.
# Usage: machines.sh [GROUP...]   GROUP: processors, manners; without one, all. Prints TAP.
work=build/tests/machines
. tests/programs/tap.sh
. tests/programs/builds.sh
mkdir -p build/tests
sh tests/setup.sh build/tests/machines.mk gcc clang gcc-multilib qemu-user lld wasi-libc libclang-rt-dev-wasm32 nodejs \
    binutils-s390x-linux-gnu libc6-dev-s390x-cross libgcc-12-dev-s390x-cross \
    binutils-riscv64-linux-gnu libc6-dev-riscv64-cross libgcc-12-dev-riscv64-cross \
    binutils-aarch64-linux-gnu libc6-dev-arm64-cross libgcc-12-dev-arm64-cross | sed 's/^/# /'
groups=${*:-processors manners}
begin "" ""
seconds=1800

# on RUNNER LINES NAME COMPILER FLAGS...: both programs with all of their lines, or with LINES "few" a seventh of the first one's.
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

for group in $groups; do
    case $group in
    processors | manners) $group ;;
    *) echo "machines.sh: no group is named $group" >&2 && exit 2 ;;
    esac
done
plan
