#!/bin/sh
# Flags and modes that break careless floating-point code change no cell. One program prints the hashes and certificates of every
# family by every method; its output must be the same, however it is built and in whatever mode it runs. The first run prints all
# lines, each later one the next eleventh of them. A second program does the same with living sets, queries and Voronoi diagrams, by
# thirds, in few builds, as these compile what the others leave out. Other processors, and more manners of building, are in machines.sh.
# Compilers take most of the time, so what matters is the flag, and the level of optimisation only in few builds. GCC joins products
# and sums only with -fexpensive-optimizations.
# Prints TAP.
work=build/tests/hostile
. tests/programs/tap.sh
. tests/programs/builds.sh
begin "up down zero" "up down zero"
case $(uname -m) in
x86_64 | i?86) sse="ftz up+ftz" both=up+ftz x87="single double double+down" rounded=double+down ;;
*) sse= both= x87= rounded= ;;
esac
both gcc_native_fast_math "up zero $sse" "up $sse" gcc -O1 -fexpensive-optimizations -march=native -ffast-math -ffp-contract=fast
both gcc_x87 "$rounded" "$x87" gcc -O1 -m32 -mfpmath=387 -mno-sse
same gcc_O0_no_simd "up" gcc -O0 -DPARADT_NO_SIMD -Wall -Wextra -Werror
same gcc_O2_fast_math "up $sse" gcc -O2 -ffast-math
same gcc_m32_sse "$both" gcc -O1 -m32 -msse2 -mfpmath=sse
same clang_O1_index64 "down" clang -O1 -DPARADT_INDEX64 -Wall -Wextra -Werror
same clang_native_fast "up $sse" clang -Ofast -march=native -w
same tcc "" tcc
runner=qemu-aarch64
if has $runner; then same arm64_fast_math "" clang --target=aarch64-linux-gnu -O1 -ffast-math -static -w; else skip arm64_fast_math "$runner is not installed"; fi
# The default stack of wasm-ld is too small for the exact stages.
runner="node --no-warnings tests/programs/wasi.mjs"
if has node; then
    same wasm_fast_math "" clang --target=wasm32-wasi -O1 -ffast-math -msimd128 -Wl,-z,stack-size=262144 -w
else
    skip wasm_fast_math "node is not installed"
fi
plan
