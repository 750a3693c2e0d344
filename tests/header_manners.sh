#!/bin/sh
# The symbols of the compiled implementation show that it has no mutable globals and no foreign names, and makes no calls that
# print, end the process or touch the floating-point environment. Prints TAP.
work=build/tests/manners
rm -rf "$work"
mkdir -p "$work"
CC=${CC:-cc}
. tests/programs/tap.sh
nothing() { # name, file that lists what should not be there
    [ ! -s "$2" ]
    report $? "$1" "$2"
}
printf '#define PARADT_IMPLEMENTATION\n#include "paradt.h"\n' >"$work/all.c"
printf '#include "paradt.h"\n' >"$work/none.c"
printf '#define PARADT_STATIC\n#define PARADT_IMPLEMENTATION\n#include "paradt.h"\n' >"$work/static.c"
for kind in all none static; do
    # Unoptimised code has symbols for every function and object that the source defines or calls. Without -fno-pic a constant table
    # of pointers is relocated when loaded, and nm reports it as data (d).
    $CC -O0 -DNDEBUG -fno-pic -fno-pie -I. -c "$work/$kind.c" -o "$work/$kind.o" 2>"$work/$kind.errors" || {
        cp "$work/$kind.errors" "$work/failed"
        nothing "the_header_compiles_alone_($kind)" "$work/failed"
        plan
        exit 1
    }
    nm "$work/$kind.o" >"$work/$kind.symbols"
done

awk '$2 ~ /^[BbDdCGgSs]$/ { print $3 }' "$work/all.symbols" >"$work/mutable"
nothing no_mutable_global_state "$work/mutable"

awk 'NF == 3 && $2 ~ /^[A-Z]$/ && $2 != "U" && $3 !~ /^paradt_[a-z]/ { print $3 }' "$work/all.symbols" >"$work/foreign"
nothing every_public_symbol_begins_with_paradt "$work/foreign"

sed -n 's/^PARADT_DEF.*[ *]\(paradt_[a-z0-9_]*\)(.*/\1/p' paradt.h | sort -u >"$work/declared"
awk 'NF == 3 && $2 == "T" { print $3 }' "$work/all.symbols" | sort -u >"$work/defined"
comm -3 "$work/declared" "$work/defined" >"$work/difference"
nothing every_declared_function_is_defined_and_no_other "$work/difference"

awk '$1 == "U" || $2 == "U" { print $NF }' "$work/none.symbols" >"$work/from_declarations"
awk 'NF == 3 { print $3 }' "$work/none.symbols" >>"$work/from_declarations"
nothing the_declarations_alone_define_and_need_nothing "$work/from_declarations"

awk 'NF == 3 && $2 ~ /^[A-Z]$/ && $2 != "U" { print $3 }' "$work/static.symbols" >"$work/exported"
nothing paradt_static_exports_nothing "$work/exported"

nm -u "$work/all.o" | awk '{ print $NF }' | sed 's/@.*//' |
    grep -E '^_*(exit|_Exit|quick_exit|abort|.*printf.*|puts|putchar|fputs|fwrite|perror|fe[sg]et.*|longjmp|signal|raise|rand|srand|random|pthread.*|__assert.*|getenv|setlocale|strtok|atexit|system)$' \
    >"$work/calls"
nothing no_exit_no_printing_no_global_state_of_the_c_library "$work/calls"
plan
