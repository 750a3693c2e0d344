#!/bin/sh
# paradt_mpi.h builds without warnings, gives the cells of the serial library, and the same errors on all ranks. The tool reads,
# writes and hashes as `paradt` does. All ranks share this machine's processors. A run that does not end is stopped and fails.
# Prints TAP. With QUICK=1 only the header is built, and the cells of some sets are compared.
work=$PWD/build/tests/mpi
rm -rf "$work"
mkdir -p "$work"
. tests/programs/mpich.sh
for program in mpicc mpicxx mpiexec; do
    command -v $program >/dev/null 2>&1 && continue
    echo "ok 1 - mpi # SKIP needs mpich libmpich-dev"
    echo "1..1"
    exit 0
done
CC=${CC:-cc}
. tests/programs/tap.sh
# Open MPI has to be told that there may be more ranks than processors, and that root may run them.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
on() { # ranks, command...
    ranks=$1
    shift
    timeout -k 5 300 mpiexec -n "$ranks" "$@"
}

# --- the header

# Front ends give most warnings, so these builds are not optimised. The optimizer warns when make builds the tool.
printf '#define PARADT_MPI_IMPLEMENTATION\n#include "paradt_mpi.h"\nint main(void) { return 0; }\n' >"$work/header.c"
cp "$work/header.c" "$work/header.cc"
printf '#include "paradt_mpi.h"\nint main(void) { paradt_mpi_free(0); return 0; }\n' >"$work/user.c"
printf '#define PARADT_STATIC\n' | cat - "$work/header.c" >"$work/static.c"
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I."
# Programs that do not call these parts do not compile them, and those that run for seconds are hardly optimised.
less="-DPARADT_NO_LOCATOR -DPARADT_NO_DYNAMIC -DPARADT_NO_VORONOI -DPARADT_NO_MEASURES"
least="$less -DPARADT_NO_TREE -DPARADT_NO_FLIPS -DPARADT_NO_HULLS"
mpicc -std=c99 $warnings $least -Wstrict-prototypes -fno-pic -Dmain=other -c -o "$work/header.o" "$work/header.c" 2>"$work/log"
report $? header_builds_as_c99 "$work/log"
mpicxx -std=c++11 $warnings $least -DOMPI_SKIP_MPICXX -o "$work/header" "$work/header.cc" -lm 2>"$work/log"
report $? header_builds_as_cxx11 "$work/log"
mpicc -std=c99 $warnings $least -DPARADT_INDEX64 -o "$work/header" "$work/header.c" -lm 2>"$work/log"
report $? header_builds_with_64_bit_indices "$work/log"
mpicc -std=c99 $warnings $least -o "$work/static" "$work/static.c" -lm 2>"$work/log"
report $? header_builds_static "$work/log"
mpicc -std=c99 $warnings -c -o "$work/user.o" "$work/user.c" 2>"$work/log" &&
    mpicc -no-pie -o "$work/user" "$work/user.o" "$work/header.o" -lm 2>>"$work/log"
report $? declarations_alone_link_with_the_implementation "$work/log"
# The second time the macro is defined in the manual, a whole program begins.
awk '/define PARADT_MPI_IMPLEMENTATION/ { n++ } n == 2 { print; if ($0 == "//     }") exit }' paradt_mpi.h | sed 's/^\/\///' >"$work/many.c"
mpicc -std=c99 $warnings $least -o "$work/many" "$work/many.c" -lm 2>"$work/log" && [ "$(on 3 "$work/many" | grep -c '^rank')" = 3 ]
report $? the_program_of_the_manual_works "$work/log"
if command -v nm >/dev/null 2>&1; then
    nm "$work/header.o" | grep -E ' [BbDdC] ' >"$work/log"
    [ ! -s "$work/log" ]
    report $? header_has_no_global_state "$work/log"
fi

if [ -z "$QUICK" ]; then # up to the cells

# --- the tool

# Both tools are those that make built, where warnings are errors.
cp build/paradt "$work/paradt" 2>"$work/log" && [ -x build/paradt_mpi ]
report $? tools_are_built "$work/log"
mpicc -O1 -shared -fPIC -include tests/programs/mpi_polite.h -x c -o "$work/polite.so" /dev/null 2>"$work/log" ||
    rm -f "$work/polite.so"
polite() { # name, program: a script that runs it with ranks that sleep while they wait
    printf '#!/bin/sh\n[ ! -e "%s" ] || export LD_PRELOAD="%s"\nexec "%s" "$@"\n' "$work/polite.so" "$work/polite.so" "$2" >"$work/$1"
    chmod +x "$work/$1"
}
polite paradt_mpi "$PWD/build/paradt_mpi"
tool=$work/paradt_mpi
same() { # name, arguments: the hash is that of the serial tool, and the cells are certified
    name=$1
    shift
    serial=$("$work/paradt" --quiet --hash "$@" 2>&1)
    found=$(on 3 "$tool" --quiet --hash --check "$@" 2>&1)
    [ -n "$serial" ] && [ "$serial" = "$found" ]
    report $? "$name"
}
ends() { # name, status, pattern of standard error, arguments
    name=$1 due=$2 pattern=$3
    shift 3
    on 2 "$tool" "$@" >"$work/out" 2>"$work/all"
    [ $? -eq "$due" ] && sed '/^-----/,/^-----/d' "$work/all" >"$work/err" && # Open MPI's mpiexec adds remarks
        [ "$(grep -c . "$work/err")" -eq 1 ] && grep -q -- "$pattern" "$work/err"
    report $? "$name" "$work/err"
}
if command -v python3 >/dev/null 2>&1; then
    python3 - "$work" <<'END'
import random, struct, sys
random.seed(1)
points = [[random.random() for _ in range(4)] for _ in range(1000)]
def npy(name, columns, code, kind, rows, shape=None):
    head = "{'descr': '<%s', 'fortran_order': False, 'shape': (%s), }" % (kind, shape or '%d, %d' % (len(rows), columns))
    head += ' ' * (63 - (10 + len(head)) % 64) + '\n'
    with open(sys.argv[1] + '/' + name, 'wb') as file:
        file.write(b'\x93NUMPY\x01\x00' + struct.pack('<H', len(head)) + head.encode())
        for row in rows: file.write(struct.pack('<%d%s' % (columns, code), *row[:columns]))
npy('doubles.npy', 3, 'd', 'f8', points)
npy('floats.npy', 4, 'f', 'f4', points)
npy('nan.npy', 3, 'd', 'f8', points[:700] + [[0, float('nan'), 0]])
npy('deep.npy', 3, 'd', 'f8', points, '500, 3, 2')
npy('huge.npy', 8, 'd', 'f8', [], '2305843009213693952, 8')
for seed in 28, 39, 49: # with these the cut is on points for the one, and beside them for the other
    random.seed(seed)
    step = 1 + random.random()
    npy('steps_%d.npy' % seed, 2, 'd', 'f8',
        [[step * (random.randrange(10) + 3), random.randrange(40) * 0.01] for _ in range(1200)])
few = [[random.randrange(10**6) * 5e-324, random.randrange(3 * 10**6) * 5e-324] for _ in range(200)]
npy('subnormal.npy', 2, 'd', 'f8', [few[i // 5] for i in range(1000)])
def ply(name, between):
    with open(sys.argv[1] + '/' + name, 'wb') as file:
        file.write(b'ply\nformat binary_little_endian 1.0\nelement vertex 1000\nproperty float x\nproperty float y\n'
                   b'property float z\n' + between + b'property uchar red\nelement face 0\n'
                   b'property list uchar int vertex_indices\nend_header\n')
        for row in points: file.write(struct.pack('<fffB', *row[:3], 1))
ply('scan.ply', b'')
ply('remark.ply', b'comment colours follow\n')
ply('end.ply', b'comment not yet the end_header\n')
END
    same reads_npy_in_parts "$work/doubles.npy"
    same reads_npy_of_floats "$work/floats.npy"
    same reads_npy_with_weights --weights "$work/floats.npy"
    same reads_npy_in_the_plane --dim 2 "$work/doubles.npy"
    cp "$work/doubles.npy" "$work/12:30.npy"
    same reads_a_name_with_a_colon "$work/12:30.npy"
    same reads_binary_ply_in_parts "$work/scan.ply"
    same reads_ply_with_a_comment_among_the_properties "$work/remark.ply"
    same reads_ply_with_a_comment_that_names_the_end "$work/end.ply"
    ends npy_of_three_dimensions_is_an_input_error 3 'not two-dimensional' "$work/deep.npy"
    ends npy_of_more_than_can_be_is_an_input_error 3 'ends within' --weights --dim 3 "$work/huge.npy"
    ends more_dimensions_than_an_output_holds_are_found_early 2 'at most 3' -o "$work/four.pvtu" --dim 4 "$work/floats.npy"
    mkfifo "$work/pipe.ply"
    timeout 100 cat "$work/scan.ply" >"$work/pipe.ply" &
    [ "$(on 2 "$tool" --quiet --hash "$work/pipe.ply" 2>&1)" = "$("$work/paradt" --quiet --hash "$work/scan.ply")" ]
    report $? reads_a_pipe_once
    ends nan_is_an_input_error_with_its_number 3 'point 700 is not finite' "$work/nan.npy"
    # Some ranks fuse multiplications with additions and take subnormals for zero, others don't. If points lie on a cut, all
    # ranks must agree on their side.
    mixed() { # name, ranks of the first build, ranks of the second, arguments
        name=$1 some=$2 others=$3
        shift 3
        serial=$("$work/paradt" --quiet --hash "$@" 2>&1)
        found=$(timeout -k 5 60 mpiexec -n "$some" "$tool" --quiet --hash "$@" : \
            -n "$others" "$work/fast" --quiet --hash "$@" 2>&1)
        [ -n "$serial" ] && [ "$serial" = "$found" ]
        report $? "$name"
    }
    mpicc -O1 -fexpensive-optimizations -ffast-math -march=native $least -w -I. -o "$work/fast_mpi" examples/paradt_mpi.c -pthread -lm \
        2>"$work/log" || mpicc -O1 -ffast-math $least -w -I. -o "$work/fast_mpi" examples/paradt_mpi.c -pthread -lm 2>"$work/log"
    polite fast "$work/fast_mpi"
    mixed builds_agree_on_boxes_of_equal_size 1 2 --partition uniform "$work/steps_28.npy"
    mixed builds_agree_on_boxes_of_equal_size_again 1 2 --partition uniform "$work/steps_39.npy"
    mixed builds_agree_on_subnormal_cuts 2 2 "$work/subnormal.npy"
else
    skip reads_npy_in_parts "needs python3, as 15 more tests do"
fi
printf '0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1.5\n' >"$work/few.xyz"
same reads_text_on_rank_0 "$work/few.xyz"
[ "$(on 2 "$tool" --quiet --hash --check - <"$work/few.xyz" 2>&1)" = "$("$work/paradt" --quiet --hash "$work/few.xyz")" ]
report $? certifies_standard_input
mkdir "$work/has" "$work/lacks" && cp "$work/few.xyz" "$work/has"
timeout -k 5 200 mpiexec -n 1 -wdir "$work/has" "$tool" --replicated few.xyz : -n 1 -wdir "$work/lacks" "$tool" --replicated few.xyz \
    >"$work/out" 2>"$work/log"
[ $? -eq 3 ] && grep -q 'few.xyz: No such file' "$work/log"
report $? what_one_rank_lacks_it_says "$work/log"
same makes_points_in_parts gen:plummer:3000:7
same makes_points_with_weights --weights --dim 2 gen:uniform:1000:7
printf '0 0 0\n1 x 0\n' >"$work/bad.xyz"
ends bad_input_is_named_with_its_line 3 'bad.xyz:2' "$work/bad.xyz"
ends missing_input_is_an_input_error 3 missing.xyz "$work/missing.xyz"
ends unknown_option_is_a_usage_error 2 no-such --no-such "$work/few.xyz"
ends unknown_output_is_a_usage_error 2 out.what -o "$work/out.what" "$work/few.xyz"
ends replicas_of_a_stream_are_a_usage_error 2 'has to be a file' --replicated -
ends a_piece_is_no_other_output 2 'has a piece of that name' -o "$work/one.pvtu" -o "$work/one_1.vtu" "$work/few.xyz"
ends statistics_do_not_replace_the_input 2 'would replace' --stats "$work/few.xyz" "$work/few.xyz"
ends replicas_by_insertion_are_a_usage_error 2 'incode or dewall' --replicated --method bowyer-watson "$work/few.xyz"
# On these sets tess2 (Argonne) misses cells, or sends every point to every rank. The cells must be those of the serial tool,
# which are certified, and few points may be sent.
certified() { # ranks, input: the cells are right; leaves the statistics in the file found
    "$work/paradt" --quiet --hash --check "$2" >"$work/serial" 2>"$work/log" &&
        on "$1" "$tool" --hash --stats - "$2" >"$work/found" 2>>"$work/log" &&
        [ -s "$work/serial" ] && [ "$(tail -n 1 "$work/found")" = "$(tail -n 1 "$work/serial")" ]
}
statistics() { # prints lines name:value
    tr -d ' "' <"$work/found" | tr ',{' '\n\n'
}
exact() { # name, ranks, most points sent to other ranks in percent of all, input
    certified "$2" "$4" && statistics | awk -F: -v most="$3" '
        $1 == "points" { all = $2 }
        $1 == "points_guessed" || $1 == "points_asked" { sent += $2 }
        END { print sent, "of", all, "points sent"; exit !(all && 100 * sent <= most * all) }' >>"$work/log"
    report $? "$1" "$work/log"
}
exact clusters_in_two_boxes_miss_no_cell 2 5 gen:clusters:300000:1
exact a_thin_slab_in_eight_boxes_misses_no_cell 8 25 gen:plane:64000:1
exact a_sphere_is_not_sent_to_every_rank 8 50 gen:sphere:100000:1
# The questions would take minutes here, so all points are sent instead.
exact points_almost_on_a_line_end_in_time 8 800 gen:line:30000:1
exact points_on_a_cylinder_end_in_time 4 400 gen:cylinder:20000:1
# Points are weighed by the work that they cause. Of two ranks, the one with more different points has this percentage of them;
# half of the points handed in would be 91 % and 50 % of the different ones.
weighed() { # name, least, most, input
    certified 2 "$4" && statistics | awk -F: -v least="$2" -v most="$3" '
        $1 == "points" { all = $2 }
        $1 == "points_largest" { largest = $2 }
        END { print largest, "of", all; exit !(all && 100 * largest >= least * all && 100 * largest <= most * all) }
    ' >>"$work/log"
    report $? "$1" "$work/log"
}
awk 'BEGIN { for (i = 0; i < 5000; i++) place[i] = rand() " " rand() " " rand()
    for (i = 0; i < 50000; i++) print place[i % 5000]
    for (i = 0; i < 50000; i++) print 1.1 + rand(), rand(), rand() }' >"$work/copies.xyz"
awk 'BEGIN { n = 37
    for (i = 0; i < n * n * n; i++) print i % n, int(i / n) % n, int(i / n / n)
    for (i = 0; i < n * n * n; i++) print 1.1 * n + n * rand(), n * rand(), n * rand() }' >"$work/lattice.xyz"
awk 'BEGIN { for (i = 0; i < 20000; i++) print rand(), rand(), i % 2 ? rand() : i % 4 / 4 }' >"$work/planes.xyz"
certified 4 "$work/planes.xyz"
report $? points_that_come_late_from_planes_are_right "$work/log"
weighed equal_points_weigh_less 50 65 "$work/copies.xyz"
weighed points_of_a_lattice_weigh_more 57 70 "$work/lattice.xyz"

on 3 "$tool" --quiet -o "$work/cloud.pvtu" -o "$work/cloud.ele" gen:uniform:2000:1 2>"$work/log" &&
    [ "$(grep -c '<Piece' "$work/cloud.pvtu")" = 3 ] && [ -s "$work/cloud_0.vtu" ] && [ -s "$work/cloud_2.vtu" ] &&
    "$work/paradt" --quiet -o "$work/serial.ele" gen:uniform:2000:1 &&
    [ "$(head -n 1 "$work/cloud.ele")" = "$(head -n 1 "$work/serial.ele")" ]
report $? writes_a_piece_for_each_rank "$work/log"
[ "$(grep -ao 'NumberOfCells="[0-9]*"' "$work"/cloud_?.vtu | tr -dc '0-9"\n' | tr '"' ' ' |
    awk '{ sum += $NF } END { print sum }')" = "$(awk 'NR == 1 { print $1 }' "$work/serial.ele")" ]
report $? pieces_have_every_cell_once
mkdir "$work/a&b" && on 2 "$tool" --quiet -o "$work/a&b/x&y.pvtu" gen:uniform:100:1 2>"$work/log" &&
    grep -q '"x&amp;y_1.vtu"' "$work/a&b/x&y.pvtu" && [ -s "$work/a&b/x&y_1.vtu" ]
report $? names_of_pieces_are_escaped "$work/log"

on 2 "$tool" --quiet --progress gen:uniform:3000000:1 2>"$work/log" &&
    tr '\r' '\n' <"$work/log" | grep -o '[0-9]*%' | tr -d % >"$work/percents" && [ -s "$work/percents" ] &&
    sort -n -c "$work/percents" 2>>"$work/log"
report $? rank_0_shows_progress_that_never_goes_back "$work/log"

# --- the benchmark's MPI, which runs all ranks in one process

$CC $least -Wall -Wextra -Wshadow -Werror -Itests/bench/alone -I. -o "$work/study" tests/bench/study.c -pthread -lm \
    2>"$work/log" && timeout 200 "$work/study" 1 gen:clusters:10000:1 1 2 7 100 >>"$work/log" 2>&1
report $? a_hundred_ranks_one_at_a_time_have_the_cells_of_one "$work/log"
$CC -O1 $least -Wall -Wextra -Wshadow -Wno-unused-function -Werror -Itests/bench/alone -I. -o "$work/ranks" \
    tests/programs/ranks.c -pthread -lm 2>"$work/log" && timeout 300 "$work/ranks" 300 >>"$work/log" 2>&1
report $? small_sets_on_up_to_twelve_ranks_have_the_serial_cells "$work/log"
timeout 300 "$work/ranks" 160 weights >"$work/log" 2>&1
report $? so_they_have_with_weights "$work/log"
if runner=$(sh tests/programs/runner_32.sh "$CC" -m32 -msse2); then
    $CC -m32 -msse2 -mfpmath=sse -O1 $least -w -Itests/bench/alone -I. -o "$work/ranks" tests/programs/ranks.c -pthread -lm \
        2>"$work/log" && timeout 300 $runner "$work/ranks" 100 >>"$work/log" 2>&1
    report $? so_they_have_where_sizes_have_32_bits "$work/log"
fi

fi
plan

# --- the cells: the lines of another program follow, with their own plan

build() { # name of the program, compiler flags
    program=$1
    shift
    mpicc "$@" -g1 -include tests/asserts.h -Wall -Wextra -Wshadow -I. -Itests -Itests/programs -o "$work/$program" \
        tests/programs/mpi.c -lm >"$work/$program.log" 2>&1
}
run() { # name of the group, of the program
    if [ -x "$work/$2" ]; then
        ASAN_OPTIONS=detect_leaks=0 on 8 "$work/$2" "$1"
        ended=$?
        [ $ended -eq 0 ] && return
        # A stopped group has printed no plan, so its missing tests would not be noticed. A group with failures of its own
        # counts one more here.
        echo "1..1"
        echo "not ok 1 - $1 ended with status $ended"
    else
        echo "1..1"
        echo "not ok 1 - $1 builds"
        sed 's/^/# /' "$work/$2.log"
    fi
}
build plain -O1 $less
run many plain
run shares plain
run options plain
[ -z "$QUICK" ] || exit 0
run families plain
# With the sanitizers where they work: weights, because points that come late can hide others, and errors.
sanitize="-Og -DPARADT_VERIFY -fsanitize=address,undefined -fno-sanitize=null,object-size -fno-sanitize-recover=all"
echo 'int main(void) { return 0; }' >"$work/probe.c"
mpicc $sanitize "$work/probe.c" -o "$work/probe" 2>/dev/null || sanitize="-O1 -DPARADT_VERIFY"
build sanitized $sanitize $least
run weights sanitized
run errors sanitized
