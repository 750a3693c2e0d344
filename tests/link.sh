#!/bin/sh
# The header in several files of a program, with the macros and compilers of host programs, and as a shared library. Prints TAP.
work=build/tests/link
rm -rf "$work"
mkdir -p "$work"
CC=${CC:-cc}
. tests/programs/tap.sh
# Programs that call little of the library compile little of it.
least="-DPARADT_NO_FRONTS -DPARADT_NO_REGIONS -DPARADT_NO_TREE -DPARADT_NO_FLIPS -DPARADT_NO_HULLS -DPARADT_NO_MEASURES
    -DPARADT_NO_LOCATOR -DPARADT_NO_DYNAMIC -DPARADT_NO_VORONOI -DPARADT_MAX_DIM=3"

# --- the clock: the call sleeps for nearly all of its time
cat >"$work/clock.c" <<'END'
#define PARADT_IMPLEMENTATION
#include "paradt.h"
#include <stdio.h>
int usleep(unsigned microseconds); /* not declared under a strict standard */
static int doze(void *user, double fraction) {
    int *once = (int *)user;
    if (!(*once)++) usleep(300000);
    return fraction < 0;
}
int main(void) {
    static const double x[] = {0, 0, 1, 0, 0, 1};
    paradt_points points = {0};
    paradt_options options = {0};
    paradt_triangulation t;
    int once = 0;
    points.data = x;
    points.count = 3;
    points.dim = 2;
    options.progress = doze;
    options.user = &once;
    if (paradt_triangulate(&t, &points, &options) != PARADT_OK) return 1;
    printf("%.3f s\n", t.stats.seconds);
    return !(t.stats.seconds >= 0.29 && t.stats.seconds < 30);
}
END
for way in gcc-c99 gcc-c11 gcc-gnu99 clang-c99 tcc-c99; do
    compiler=${way%-*} strict="-Wall -Wextra -Wpedantic -Werror"
    [ $compiler = tcc ] && strict=
    if has $compiler; then
        $compiler -std=${way#*-} $strict $least -I. "$work/clock.c" -o "$work/clock" -lm >"$work/clock.log" 2>&1 &&
            [ ! -s "$work/clock.log" ] && "$work/clock" >"$work/clock.log" 2>&1
        report $? "seconds_are_wall_time_$way" "$work/clock.log"
    else
        skip "seconds_are_wall_time_$way" "$compiler is not installed"
    fi
done

# --- the manual's programs

awk '/^\/\/ A whole program/ { on = 1 } /cc -O2 -o cube/ { on = 0 } on && /^\/\/     / { print substr($0, 8) }' paradt.h >"$work/cube.c"
awk '/^\/\/     paradt_index walk\(/ { on = 1 } on { print substr($0, 8) } /^\/\/     }$/ { on = 0 }' paradt.h >"$work/walk.h"
cat >"$work/walk.c" <<'END'
#define PARADT_IMPLEMENTATION
#include "paradt.h"
#include "walk.h"
#include <stdio.h>
enum { COUNT = 400 };
int main(void) {
    static double x[COUNT][3];
    paradt_points points = paradt_points_f64(x[0], COUNT, 3);
    paradt_options options;
    paradt_triangulation t;
    unsigned state = 1;
    int i, j, axis, inside = 0;
    for (i = 0; i < COUNT; i++)
        for (axis = 0; axis < 3; axis++) { /* a small lattice: ties everywhere */
            state = state * 1664525u + 1013904223u;
            x[i][axis] = (double)(state >> 24) / 32 - (double)((state >> 24) % 32) / 32;
        }
    memset(&options, 0, sizeof options);
    options.flags = PARADT_FULL_DIM;
    if (paradt_triangulate(&t, &points, &options) != PARADT_OK) return 1;
    for (i = 0; i < 2000; i++) {
        double q[3];
        paradt_index cell;
        for (axis = 0; axis < 3; axis++) {
            state = state * 1664525u + 1013904223u;
            q[axis] = (double)(state >> 24) / 36;
        }
        cell = walk(&t, x, q, (paradt_index)((size_t)i % t.cell_count));
        inside += cell >= 0;
        for (j = 0; cell >= 0 && j < 4; j++) {
            const double *p[4];
            for (axis = 0; axis < 4; axis++) p[axis] = x[t.cells[4 * cell + axis]];
            p[j] = q;
            if (paradt_orient(3, p) < 0) return 2;
        }
    }
    /* The facets as the manual lists them, seen from outside of the cell */
    for (i = 0; i < (int)t.cell_count; i++) {
        static const int facets[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        const paradt_index *v = t.cells + 4 * i;
        for (j = 0; j < 4; j++) /* seen from the opposite vertex they run clockwise */
            if (paradt_orient3(x[v[facets[j][0]]], x[v[facets[j][1]]], x[v[facets[j][2]]], x[v[j]]) >= 0) return 3;
    }
    paradt_free(&t);
    printf("%d inside\n", inside);
    return !(inside > 1000 && inside < 2000);
}
END
for way in "gcc -std=c99" "g++ -std=c++11 -x c++" "clang++ -std=c++20 -x c++"; do
    compiler=${way%% *}
    if has $compiler; then
        strict="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I."
        $way $strict $least "$work/cube.c" -o "$work/cube" -lm >"$work/log" 2>&1 && "$work/cube" >"$work/log" 2>&1 &&
            ! grep -qvE '^[0-7] [0-7] [0-7] [0-7]$' "$work/log" && [ "$(wc -l <"$work/log")" -ge 5 ]
        report $? "the_first_program_of_the_manual_runs_with_$compiler" "$work/log"
    else
        skip "the_first_program_of_the_manual_runs_with_$compiler" "$compiler is not installed"
    fi
done
$CC $least -I. "$work/walk.c" -o "$work/walk" -lm >"$work/log" 2>&1 && timeout 60 "$work/walk" >>"$work/log" 2>&1
report $? the_walk_of_the_manual_ends_in_the_right_cell "$work/log"

# --- files of one program that disagree

cat >"$work/use.c" <<'END'
#include "paradt.h"
int main(void) {
    static const double x[] = {0, 0, 1, 0, 0, 1};
    paradt_points points = {0};
    paradt_triangulation t;
    points.data = x;
    points.count = 3;
    points.dim = 2;
    return paradt_triangulate(&t, &points, NULL) || paradt_check(&t, &points, NULL, NULL) || t.cells[1] + t.cells[2] > 3 ||
           paradt_hash(&t) == 0 || (paradt_free(&t), paradt_version() != PARADT_VERSION);
}
END
printf '#define PARADT_IMPLEMENTATION\n#include "paradt.h"\n' >"$work/all.c"
if [ -e build/tests/paradt.o ]; then cp build/tests/paradt.o "$work/all_32.o"; else $CC -I. -c "$work/all.c" -o "$work/all_32.o"; fi
$CC -DPARADT_INDEX64 -I. -c "$work/all.c" -o "$work/all_64.o" &&
    $CC -I. -c "$work/use.c" -o "$work/use_32.o" && $CC -DPARADT_INDEX64 -I. -c "$work/use.c" -o "$work/use_64.o"
for bits in 32 64; do
    $CC "$work/use_$bits.o" "$work/all_$bits.o" -o "$work/agree" -lm >"$work/log" 2>&1 && "$work/agree" >>"$work/log" 2>&1
    report $? "files_that_agree_on_${bits}_bits_are_linked" "$work/log"
    ! $CC "$work/use_$((96 - bits)).o" "$work/all_$bits.o" -o "$work/disagree" -lm >"$work/log" 2>&1 &&
        grep -q 'paradt_triangulate' "$work/log" && grep -q 'paradt_check' "$work/log" && grep -q 'paradt_free' "$work/log"
    report $? "files_that_disagree_on_${bits}_bits_are_not_linked" "$work/log"
done
nm "$work/all_64.o" | awk '$2 == "T" && $3 !~ /_64$/' >"$work/log"
[ ! -s "$work/log" ]
report $? every_name_says_that_indices_have_64_bits "$work/log"
$CC "$work/use_32.o" "$work/all_32.o" "$work/all_64.o" -o "$work/both" -lm >"$work/log" 2>&1 && "$work/both"
report $? both_implementations_fit_into_one_program "$work/log"

printf '#include <stdio.h>\n#include "paradt.h"\nint main(void) { printf("%%zu %%zu\\n", sizeof(paradt_triangulation), sizeof(paradt_options)); }\n' \
    >"$work/sizes.c"
for dim in 2 8; do
    $CC -DPARADT_MAX_DIM=$dim -I. "$work/sizes.c" -o "$work/sizes_$dim" && "$work/sizes_$dim" >"$work/sizes_$dim.txt"
done
[ -s "$work/sizes_2.txt" ] && diff "$work/sizes_2.txt" "$work/sizes_8.txt" >"$work/log"
report $? structs_do_not_depend_on_the_largest_dimension "$work/log"

for macro in PARADT_STATIC PARADT_INDEX64; do
    printf '#include "paradt.h"\n#define %s\n#define PARADT_IMPLEMENTATION\n#include "paradt.h"\n' $macro >"$work/late.c"
    ! $CC -I. -c "$work/late.c" -o "$work/late.o" 2>"$work/log" && grep -q "error.*$macro is defined after" "$work/log"
    report $? "${macro}_after_the_first_include_is_an_error" "$work/log"
    printf '#define %s\n#include "paradt.h"\n#define PARADT_IMPLEMENTATION\n#include "paradt.h"\n' $macro >"$work/early.c"
    $CC -I. -fsyntax-only "$work/early.c" >"$work/log" 2>&1 && [ ! -s "$work/log" ]
    report $? "${macro}_before_the_first_include_is_none" "$work/log"
done

# --- warnings of C++ about C code

for compiler in g++ clang++; do
    if has $compiler; then
        $compiler -std=c++11 -Wall -Wextra -Wold-style-cast -Wzero-as-null-pointer-constant -Werror -fsyntax-only -I. \
            -x c++ "$work/all.c" >"$work/log" 2>&1
        # The pragmas end with the implementation, so the compiler still warns after it.
        ! echo 'int old(double x); int old(double x) { return (int)x; }' | $compiler -std=c++11 -Wold-style-cast -Werror $least \
            -fsyntax-only -I. -DPARADT_IMPLEMENTATION -include paradt.h -x c++ - >>"$work/log.after" 2>&1 &&
            [ ! -s "$work/log" ]
        report $? "casts_of_c_are_no_warnings_with_$compiler" "$work/log"
    else
        skip "casts_of_c_are_no_warnings_with_$compiler" "$compiler is not installed"
    fi
done

# --- ranks keep the contracts of paradt.h: a single vertex, points in a plane, what is empty

cat >"$work/ranks.c" <<'END'
#define PARADT_MPI_IMPLEMENTATION
#include "paradt_mpi.h"
#include <stdio.h>
int main(int argc, char **argv) {
    double x[50][3];
    int rank, i, good = 1;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    for (i = 0; i < 50; i++) {
        x[i][0] = rank * 50 + i;
        x[i][1] = (i * 7 + rank) % 13;
        x[i][2] = 1;
    }
    for (i = 0; i < 3; i++) {
        paradt_points points = paradt_points_f64(x[0], i ? 50 : rank == 0, 3);
        paradt_mpi_options options = {0};
        paradt_mpi_triangulation t;
        paradt_triangulation whole;
        paradt_status status;
        options.local.flags = i == 2 ? PARADT_FULL_DIM : 0;
        status = paradt_mpi_triangulate(&t, MPI_COMM_WORLD, &points, &options);
        good = good && status == (i == 2 ? PARADT_ERROR_FLAT : PARADT_OK) && t.dim == (i == 0 ? 0 : i == 1 ? 2 : -1);
        good = good && (i == 1 || (!t.neighbors && !t.sum.hull_facets));
        if (!status) {
            good = good && paradt_mpi_gather(&whole, MPI_COMM_WORLD, &t, 0) == PARADT_OK;
            good = good && whole.dim == (rank ? -1 : i ? 2 : 0) && (rank || i || (whole.cell_count == 1 && !whole.neighbors));
            paradt_free(&whole);
        }
        paradt_mpi_free(&t);
    }
    MPI_Finalize();
    return !good;
}
END
. tests/programs/mpich.sh
if has mpicc && has mpiexec; then
    mpicc -DPARADT_NO_TREE -DPARADT_NO_FLIPS -DPARADT_NO_HULLS -DPARADT_NO_MEASURES -DPARADT_NO_LOCATOR -DPARADT_NO_DYNAMIC \
        -DPARADT_NO_VORONOI -I. "$work/ranks.c" -o "$work/ranks" -lm >"$work/log" 2>&1 &&
        timeout 120 mpiexec -n 2 "$work/ranks" >>"$work/log" 2>&1 </dev/null
    report $? ranks_keep_the_contracts_of_small_results "$work/log"
else
    skip ranks_keep_the_contracts_of_small_results "mpicc is not installed"
fi

# --- a shared library

if make -s lib BUILD="$work" CFLAGS=-O0 >"$work/log" 2>&1 && [ ! -s "$work/log" ]; then
    sed -n 's/^PARADT_DEF.*[ *]\(paradt_[a-z0-9_]*\)(.*/\1/p' paradt.h | sort -u >"$work/declared"
    nm -D --defined-only "$work/libparadt.so" | awk '$2 == "T" { print $3 }' | sort >"$work/exported"
    diff "$work/declared" "$work/exported" >"$work/log"
    report $? a_shared_library_shows_the_public_functions_alone "$work/log"
    if has python3; then
        python3 -c "
import ctypes, sys
library = ctypes.CDLL(sys.argv[1])
library.paradt_orient2.argtypes = [ctypes.POINTER(ctypes.c_double)] * 3
row = ctypes.c_double * 2
assert library.paradt_version() == int(sys.argv[2])
assert library.paradt_orient2(row(0, 0), row(1, 0), row(0, 1)) == 1
" "$work/libparadt.so" "$(sed -n 's/^#define PARADT_VERSION \([0-9]*\).*/\1/p' paradt.h)" >"$work/log" 2>&1
        report $? a_shared_library_is_loaded_by_another_language "$work/log"
    else
        skip a_shared_library_is_loaded_by_another_language "python3 is not installed"
    fi
else
    report 1 make_lib "$work/log"
fi

plan
