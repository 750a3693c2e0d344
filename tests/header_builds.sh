#!/bin/sh
# The header compiles without warnings in each language that it promises, with each installed compiler, in each configuration,
# and the program built gives the same result everywhere. Prints TAP.
#
# Front ends give most warnings, so most builds are not optimised, which takes a fifth of the time. GCC's optimizer warns too:
# about C++ here, and about C when make builds the tools and the library that the tests share. Settings that have nothing to do
# with each other share a build. tests/hostile_flags.sh compares the results of other optimised builds. With QUICK=1 each
# compiler makes only its first two builds.
work=build/tests/header
rm -rf "$work"
mkdir -p "$work"
smallest=tests/programs/smallest.c
common="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I."
c="$common -Wstrict-prototypes -x c"
insertion_alone="-DPARADT_NO_FRONTS -DPARADT_NO_REGIONS -DPARADT_NO_TREE -DPARADT_NO_FLIPS -DPARADT_NO_HULLS \
    -DPARADT_NO_MEASURES -DPARADT_NO_LOCATOR -DPARADT_NO_DYNAMIC -DPARADT_NO_VORONOI -DPARADT_MAX_DIM=3"
. tests/programs/tap.sh
runner= # the command that runs programs for another processor

# builds NAME SHELL-COMMAND: the command must succeed, print nothing, and make the program $work/NAME, whose output must be that of
# the first program. The programs certify their results by paradt_check.
expected=
builds() {
    name=$1
    log=$work/$name.log
    if sh -c "$2" >"$log" 2>&1 && [ ! -s "$log" ] && $runner "$work/$name" >"$log" 2>&1 &&
        { [ -n "$expected" ] || expected=$(head -1 "$log"); } && [ "$(sort -u "$log")" = "$expected" ]; then
        report 0 "$name"
    else
        report 1 "$name" "$log"
    fi
}

for family in gcc clang; do
    if [ $family = gcc ]; then cxx=g++; else cxx=clang++; fi
    if ! has $family || ! has $cxx; then
        skip "header_builds_with_$family" "$family or $cxx is not installed"
        continue
    fi
    builds "${family}_c99" "$family -std=c99 $c $smallest -o $work/${family}_c99 -lm"
    builds "${family}_c++11" "$cxx -std=c++11 $common -x c++ $smallest -o $work/${family}_c++11 -lm"
    [ -z "$QUICK" ] || continue
    if [ $family = gcc ] && ! ${CC:-cc} --version | grep -q 'Free Software'; then
        builds gcc_O2 "gcc -std=c99 -O2 $c $smallest -o $work/gcc_O2 -lm"
    fi
    if [ $family = gcc ]; then level=-O1; else level=-O0; fi
    builds "${family}_c++20_ndebug_index64" "$cxx -std=c++20 $level -DNDEBUG -DPARADT_INDEX64 $common -x c++ $smallest \
        -o $work/${family}_c++20_ndebug_index64 -lm"
    builds "${family}_two_files_index64_no_simd_no_hulls" "
        $family -std=c99 $c -DPARADT_INDEX64 -DUSE_ONLY -DCALL_SECOND_FILE -c $smallest -o $work/${family}_1.o &&
        $family -std=c99 $c -DPARADT_INDEX64 -DPARADT_NO_SIMD -DPARADT_NO_HULLS -DSECOND_FILE -c $smallest -o $work/${family}_2.o &&
        $family $work/${family}_1.o $work/${family}_2.o -o $work/${family}_two_files_index64_no_simd_no_hulls -lm"
    builds "${family}_cxx_calls_c" "
        $cxx -std=c++11 $common -DPARADT_INDEX64 -DUSE_ONLY -DCALL_SECOND_FILE -x c++ -c $smallest -o $work/${family}_3.o &&
        $cxx $work/${family}_2.o $work/${family}_3.o -o $work/${family}_cxx_calls_c -lm"
    # The first file has assertions, and words that <windows.h> defines as macros; the second one insertion alone.
    builds "${family}_c11_static_in_two_files" "
        $family -std=c11 -DPARADT_VERIFY -include tests/asserts.h -Dnear= -Dfar= -Dsmall=char -Dinterface=struct -DIN= -DOUT= \
            $c -DPARADT_STATIC -DCALL_SECOND_FILE -c $smallest -o $work/${family}_5.o &&
        $family -std=c99 $c -DPARADT_STATIC $insertion_alone -DSECOND_FILE -c $smallest -o $work/${family}_6.o &&
        $family $work/${family}_5.o $work/${family}_6.o -o $work/${family}_c11_static_in_two_files -lm"
    builds "${family}_static_cxx_no_regions" \
        "$cxx -std=c++11 -DPARADT_STATIC -DPARADT_NO_REGIONS $common -x c++ $smallest -o $work/${family}_static_cxx_no_regions -lm"
    if runner=$(sh tests/programs/runner_32.sh $family -m32); then
        builds "${family}_m32" "$family -std=c99 -m32 $c $smallest -o $work/${family}_m32 -lm"
    else
        skip "${family}_m32" "$family has no 32-bit libraries here (gcc-multilib), or nothing runs them"
    fi
    runner=
    # GCC's own instrumented build is in the sanitized test programs.
    if [ $family = gcc ] && [ -e build/tests/sanitized/paradt.o ]; then
        builds gcc_undefined_behaviour "gcc -std=c99 -fsanitize=address,undefined -fno-sanitize-recover=all -DUSE_ONLY $c $smallest \
            -x none build/tests/sanitized/paradt.o -o $work/gcc_undefined_behaviour -lm"
    elif echo 'int main(void) { return 0; }' | $family -fsanitize=undefined -x c - -o "$work/probe" 2>/dev/null; then
        builds "${family}_undefined_behaviour" "$family -std=c99 -fsanitize=undefined \
            -fno-sanitize-recover=all $insertion_alone $c $smallest -o $work/${family}_undefined_behaviour -lm"
    else
        skip "${family}_undefined_behaviour" "$family has no -fsanitize=undefined here"
    fi
done

if [ -n "$QUICK" ]; then
    :
elif has tcc; then
    builds tcc "tcc -Wall -Werror -I. $smallest -o $work/tcc -lm"
    builds tcc_index64 "tcc -Wall -Werror -DPARADT_INDEX64 -I. $smallest -o $work/tcc_index64 -lm"
else
    skip tcc "tcc is not installed"
fi
plan
