#!/bin/sh
# The command-line tool: good and bad files, every format, options, exit statuses, interruptions. Builds the tool with the
# sanitizers, if the compiler has them, unless PARADT_TOOL names another. Prints TAP.
. tests/programs/tap.sh
work=$PWD/build/tests/tool
rm -rf "$work"
mkdir -p "$work"
CC=${CC:-cc}
tool=${PARADT_TOOL:-$work/paradt}
if [ -z "$PARADT_TOOL" ]; then
    build() { # flags
        $CC "$@" -g1 -D_XOPEN_SOURCE=700 -include tests/asserts.h -I. -o "$tool" examples/paradt.c -pthread -lm 2>"$work/build.log"
    }
    sanitize="-Og -DPARADT_VERIFY -fsanitize=address,undefined -fno-sanitize-recover=all"
    # The library is that of the sanitized test programs, if it is there.
    build $sanitize -DPARADT__IMPLEMENTED build/tests/sanitized/paradt.o || build $sanitize || build -O2 ||
        { echo "not ok 1 - the_tool_builds"; sed 's/^/# /' "$work/build.log"; echo "1..1"; exit 1; }
fi
ASAN_OPTIONS=exitcode=99:allocator_may_return_null=1
UBSAN_OPTIONS=exitcode=99
export ASAN_OPTIONS UBSAN_OPTIONS
cd "$work" || exit 1

explain() { echo "status $status"; tail -n 8 err; tail -n 3 out; }
run() { # arguments; sets status, and writes the files out and err
    "$tool" "$@" >out 2>err
    status=$?
}
ends() { # name, status, pattern of standard error, arguments
    name=$1 due=$2 pattern=$3
    shift 3
    run "$@"
    [ "$status" -eq "$due" ] && grep -q -- "$pattern" err
    report $? "$name"
}
done_well() { [ "$status" -eq 0 ] && [ ! -s err ]; }
hash_of() { "$tool" --hash --quiet "$@" 2>>err; }

# --- options ----------------------------------------------------------------------------------------------------------

run --help
done_well && grep -q 'gen:KIND:N:SEED' out && grep -q '  --locate Q=A ' out && grep -q '  --weights ' out && grep -q '  plummer ' out
report $? help_names_options_formats_and_kinds
run --version
done_well && grep -Eq '^paradt [0-9]+\.[0-9]+\.[0-9]+$' out
report $? version_is_one_line

while read -r name arguments; do
    # shellcheck disable=SC2086 # the arguments are words
    ends "usage_error_$name" 2 '^paradt: ' $arguments
done <<'TABLE'
no_input
two_inputs a.xyz b.xyz
unknown_option --frobnicate a.xyz
value_missing --dim
dim_too_small --dim 1 gen:uniform:10:1
dim_too_large --dim 9 gen:uniform:10:1
dim_no_number --dim 3x gen:uniform:10:1
no_such_method --method magic gen:uniform:10:1
no_regions --regions 0 gen:uniform:10:1
regions_overflow --regions 99999999999999999999999 gen:uniform:10:1
no_jobs --jobs 0 gen:uniform:10:1
no_such_partition --partition stripes gen:uniform:10:1
flag_with_value --check=yes gen:uniform:10:1
unknown_output -o out.doc gen:uniform:10:1
output_without_extension -o out gen:uniform:10:1
picture_of_four_dimensions --dim 4 -o out.png gen:uniform:10:1
hull_with_weights --hull --weights gen:uniform:10:1
hull_by_a_method --hull --method incode gen:uniform:10:1
hull_as_cells --hull -o out.ele gen:uniform:10:1
hull_as_picture --hull -o out.png gen:uniform:10:1
hull_of_four_dimensions_as_ply --hull --dim 4 -o out.ply gen:uniform:10:1
furthest_hull --furthest --hull gen:uniform:10:1
furthest_by_insertion --furthest --method bowyer-watson gen:uniform:10:1
furthest_certified --furthest --check gen:uniform:10:1
cells_of_a_hull --hull --voronoi out.csv gen:uniform:10:1
cells_as_a_mesh --voronoi out.obj gen:uniform:10:1
box_without_cells --box 0,0,0,1,1,1 gen:uniform:10:1
box_with_words --box 0,0,zero,1,1,1 --voronoi out.csv gen:uniform:10:1
box_with_a_hole --box 0,0,,1,1,1 --voronoi out.csv gen:uniform:10:1
box_infinite --box 0,0,0,1,1,inf --voronoi out.csv gen:uniform:10:1
box_too_long --box 0,0,0,0,0,0,0,0,1,1,1,1,1,1,1,1,1 --voronoi out.csv gen:uniform:10:1
queries_without_answers --locate gen:uniform:10:1 gen:uniform:10:1
answers_without_queries --nearest =out.csv gen:uniform:10:1
answers_as_text --locate gen:uniform:10:1=out.txt gen:uniform:10:1
queries_of_a_hull --hull --locate gen:uniform:10:1=- gen:uniform:10:1
queries_furthest --furthest --nearest gen:uniform:10:1=- gen:uniform:10:1
queries_twice --locate gen:uniform:9:1=a.csv --locate gen:uniform:9:1=b.csv gen:uniform:10:1
two_texts --locate gen:uniform:10:1=- --stats - gen:uniform:10:1
one_input_for_both --locate -=a.csv -
no_such_kind gen:marbles:10:1
no_count gen:uniform::1
count_too_large gen:uniform:1e30:1
seed_no_number gen:uniform:10:x
TABLE

# --- bad files: name | status | pattern | file | contents as printf prints them ---------------------------------------

while IFS='|' read -r name due pattern file contents; do
    # shellcheck disable=SC2059 # the contents are a format
    printf -- "$contents" >"$file"
    ends "bad_$name" "$due" "^paradt: $file:$pattern" -o out.ele "$file"
    rm -f "$file"
done <<'TABLE'
empty|3| the file is empty|empty.xyz|
words|3|2: 'hello' is not a number|words.xyz|0 0 0\nhello world\n
too_few_columns|3|3: 2 numbers where 3 are needed|few.xyz|# c\n0 0 0\n1 2\n
ragged_text|3|2: more than the first point's 2 numbers|ragged.txt|0 0\n1 2 3\n
one_column|3|1: |one.txt|1\n2\n
nine_columns|3|1: |nine.txt|1 2 3 4 5 6 7 8 9\n
number_with_tail|3|1: '1.5abc' is not a number|tail.xyz|1.5abc 2 3\n
two_points_in_a_number|3|1: '1.2.3' is not a number|points.xyz|1.2.3 2 3\n
missing_field|3|1: a number is missing|field.csv|1,,3\n
late_title|3|3: 'x' is not a number|title.csv|x,y\n0,0\nx,y\n
nan|3|2: coordinate 2 is not finite|nan.xyz|0 0 0\n0 nan 0\n
inf|3|1: coordinate 1 is not finite|inf.xyz|-inf 0 0\n
overflow|3|1: coordinate 3 is not finite|over.xyz|0 0 1e999\n
zero_byte|3|1: |zero.xyz|0 0\000 0\n
binary_as_text|3|1: |binary.txt|\377\376\001\n
old_mac_line_ends|3|2: coordinate 1 is not finite|mac.xyz|0 0 0\rnan 0 0\r
node_empty|3|1: no header|a.node|# nothing\n
node_short|3| 5 points announced, but the file ends after 1|b.node|5 3 0 0\n1 0 0 0\n
node_long|3|3: more than the announced points|c.node|1 2 0 0\n0 0 0\n1 0 0\n
node_index|3|3: the point's index is 7 where 2 is due|d.node|2 2 0 0\n1 0 0\n7 0 1\n
node_base|3|2: the point's index is 5 where 0 is due|e.node|2 2 0 0\n5 0 0\n6 0 1\n
node_huge_count|3| 9007199254740992 points announced|f.node|9007199254740992 3 0 0\n1 0 0 0\n
node_dimension|3|1: dimension 99 is not 2 to 8|g.node|1 99 0 0\n
node_negative|3|1: the header is not|h.node|-3 3 0 0\n
off_no_keyword|3|1: not an OFF file|a.off|hello\n1 0 0\n
off_binary|3|1: binary OFF files are not supported|b.off|OFF BINARY\n
off_homogeneous|3|1: OFF files of homogeneous|c.off|4OFF\n1 0 0\n0 0 0 1\n
off_short|3| 4 points announced, but the file ends after 1|d.off|OFF\n4 0 0\n0 0 0\n
off_header|3|2: the file ends within its header|e.off|OFF\n4\n
off_few|3|3: 2 numbers where 3 are needed|f.off|OFF\n1 0 0\n0 0\n
ply_keyword|3|1: not a PLY file|a.ply|plywood\n
ply_header|3|3: the file ends within its header|b.ply|ply\nformat ascii 1.0\nelement vertex 3\n
ply_format|3|2: an unknown format|c.ply|ply\nformat binary 1.0\nend_header\n
ply_no_format|3|2: the header names no format|d.ply|ply\nend_header\n
ply_type|3|4: 'quad' is not a type|e.ply|ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n
ply_no_vertex|3|3: no element is called vertex|f.ply|ply\nformat ascii 1.0\nend_header\n
ply_no_y|3|5: the vertices have no property y|g.ply|ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n
ply_count|3|3: -1 is not a number of elements|h.ply|ply\nformat ascii 1.0\nelement vertex -1\nend_header\n
ply_short|3|7: the file ends before its last element|i.ply|ply\nformat ascii 1.0\nelement vertex 2\nproperty int x\nproperty int y\nend_header\n1 2\n
ply_binary_short|3| the file ends within its data|j.ply|ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nend_header\n1234567
ply_huge|3| the file ends within its data|k.ply|ply\nformat binary_little_endian 1.0\nelement vertex 9007199254740992\nproperty float x\nproperty float y\nend_header\n12345678
ply_binary_nan|3| point 0: coordinate 1 is not finite|l.ply|ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n\000\000\300\1771234
npy_magic|3| not an NPY file|a.npy|NUMPY and more\n
npy_version|3| an unknown version|b.npy|\223NUMPY\011\000\005\000abcde
npy_header|3| the file ends within its header|c.npy|\223NUMPY\001\000\377\377{}
npy_complex|3| the array's type is no integer or float|d.npy|\223NUMPY\001\000\102\000{'descr': '<c8', 'fortran_order': False, 'shape': (1, 3), }       \n123456781234567812345678
npy_short|3| the file ends within its data|e.npy|\223NUMPY\001\000\102\000{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }       \n123456781234567812345678
npy_huge|3| the file ends within its data|f.npy|\223NUMPY\001\000\102\000{'descr': '<f8', 'fortran_order': False, 'shape': (9999999999,3)} \n123456781234567812345678
npy_flat|3| the array is not two-dimensional|g.npy|\223NUMPY\001\000\102\000{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }         \n123456781234567812345678
pdb_short|3|1: the line ends before the coordinates do|a.pdb|ATOM      1  CA  ALA A   1      11.104\n
pdb_words|3|1: '   abc  ' is not a coordinate|b.pdb|ATOM      1  CA  ALA A   1      11.104   abc     4.000  1.00\n
unknown_extension|3| neither text nor of a known format|points.doc|\001\002\n
TABLE

mkdir folder.xyz
ends bad_folder 3 '^paradt: folder.xyz: Is a directory' folder.xyz
ends bad_missing_file 3 '^paradt: none.xyz: No such file' none.xyz
printf '0 0 0\n1 1 x\n' | "$tool" - >out 2>err
status=$?
[ "$status" -eq 3 ] && grep -q "^paradt: standard input:2: 'x' is not a number" err
report $? bad_standard_input_names_its_line
printf '0 0\n1 0\n0 1\n' >flat.txt
ends bad_fewer_columns_than_dim 3 '^paradt: flat.txt:1: 2 numbers where 3 are needed' --dim 3 flat.txt
printf '%0400dx 0 0\n' 7 >long.xyz
ends bad_long_token_is_shortened 3 "^paradt: long.xyz:1: '0\{23\}' is not a number" long.xyz
ls out.* >left 2>/dev/null
[ ! -s left ]
report $? bad_input_leaves_no_output

# --- the same points in every format ----------------------------------------------------------------------------------
# (0 0 0) (1 0 0) (0 1 0) (0 0 1) (1/4 1/4 1/4). With the weights 0 0 0 0 -1 the last point is hidden.

write() { # file, contents as printf prints them
    # shellcheck disable=SC2059 # the contents are a format
    printf -- "$2" >"$1"
}
text='0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0.25 .25 2.5e-1 -1\n'
write plain.node '5 3 0 0\n 0 0 0 0\n 1 1 0 0\n 2 0 1 0\n 3 0 0 1\n 4 0.25 0.25 0.25\n'
write weighted.node '5 3 1 0\n 0 0 0 0 0\n 1 1 0 0 0\n 2 0 1 0 0\n 3 0 0 1 0\n 4 0.25 0.25 0.25 -1\n'

write same.xyz "# x y z w\n\n$text"
write spread.xyz '\357\273\2770;0;0;0\r\n\t1 ,0,\t0,0\r\n  0,1,0,0 # third\r\n\r\n0 0 1 0 normal 1 2\r\n0x1p-2 25e-2 +0.25 -1.'
write macintosh.xyz '0 0 0 0\r1 0 0 0\r0 1 0 0\r0 0 1 0\r.25 .25 .25 -1\r'
write columns.txt "$text"
write titled.csv "x,y,z,weight\n$(printf '%s' "$text" | tr ' ' ,)"
write zero.node '5 3 2 1\n# point\n0 0 0 0 0 9 1\n1 1 0 0 0 9 1\n2 0 1 0 0 9 1\n3 0 0 1 0 9 1\n4 .25 .25 .25 -1 9 0\n'
write one.node '# points\n5 3 2 1 # of them\n1 0 0 0 0 9 1\n2 1 0 0 0 9 1\n3 0 1 0 0 9 1\n4 0 0 1 0 9 1\n5 .25 .25 .25 -1 9 0\n'
write faces.off "OFF # comment\n5\n1 0\n${text}3 0 1 2\n"
write colours.off "COFF 5 0 0\n$text"
write lines.off "OFF\n5\n1\n0\n${text}3 0 1 2\n"

# The bytes of 0, 1, 1/4 and -1 as float32, lowest first
zero='\000\000\000\000' one='\000\000\200\077' quarter='\000\000\200\076' minus='\000\000\200\277'
rows="$zero$zero$zero$zero$one$zero$zero$zero$zero$one$zero$zero$zero$zero$one$zero$quarter$quarter$quarter$minus"
turned="$zero$one$zero$zero$quarter$zero$zero$one$zero$quarter$zero$zero$zero$one$quarter$zero$zero$zero$zero$minus"
swap4() { printf '%s' "$1" | sed 's/\(\\...\)\(\\...\)\(\\...\)\(\\...\)/\4\3\2\1/g'; }
widen() { # converts these float32 to float64
    printf '%s' "$1" | sed 's/\\000\\000\\200\\077/A/g; s/\\000\\000\\200\\076/B/g; s/\\000\\000\\200\\277/C/g
        s/\\000\\000\\000\\000/&&/g; s/A/\\000\\000\\000\\000\\000\\000\\360\\077/g
        s/B/\\000\\000\\000\\000\\000\\000\\320\\077/g; s/C/\\000\\000\\000\\000\\000\\000\\360\\277/g'
}
npy() { # file, version and length 98 of the header, type, order, data
    header=$(printf "{'descr': '%s', 'fortran_order': %s, 'shape': (5, 4), }" "$3" "$4")
    write "$1" "\\223NUMPY$2$(printf '%-97s' "$header")\\n$5"
}
npy floats.npy '\001\000\142\000' '<f4' False "$rows"
npy doubles.npy '\001\000\142\000' '<f8' False "$(widen "$rows")"
npy fortran.npy '\002\000\142\000\000\000' '<f8' True "$(widen "$turned")"
npy swapped.npy '\003\000\142\000\000\000' '>f4' False "$(swap4 "$rows")"

vertex='element vertex 5\nproperty float x\nproperty float y\nproperty float z\nproperty float w\n'
write ascii.ply "ply\nformat ascii 1.0\ncomment here\n${vertex}end_header\n$text"
write little.ply "ply\nformat binary_little_endian 1.0\n${vertex}end_header\n$rows"
write big.ply "ply\r\nformat binary_big_endian 1.0\r\n${vertex}end_header\r\n$(swap4 "$rows")"
around() { printf '%s' '\002\001\000\002\000'"$(widen "$1")"'\377'"$2"'\007'"$3$4"; } # a list, z, red, x, y as int8, weight
write mixed.ply "ply\nformat binary_little_endian 1.0\nobj_info x\nelement camera 2\nproperty list ushort uchar settings
element vertex 5\nproperty list uint8 int16 tags\nproperty float64 z\nproperty uchar red\nproperty float32 x
property uchar green\nproperty float y\nproperty float weight\nelement face 1\nproperty list uchar int vertex_indices
end_header\n\002\000ab\001\000c$(around $zero $zero $zero $zero)$(around $zero $one $zero $zero
    )$(around $zero $zero $one $zero)$(around $one $zero $zero $zero)$(around $quarter $quarter $quarter $minus
    )\003$zero\001\000\000\000\002\000\000\000"

for file in same.xyz spread.xyz macintosh.xyz columns.txt titled.csv zero.node one.node faces.off colours.off lines.off floats.npy \
    doubles.npy fortran.npy swapped.npy ascii.ply little.ply big.ply mixed.ply; do
    run --dim 3 --quiet -o read.ele "$file"
    done_well && cmp -s read.node plain.node && [ "$(wc -l <read.ele)" -eq 5 ]
    report $? "reads_$file"
    run --dim 3 --weights --quiet -o read.ele "$file"
    done_well && cmp -s read.node weighted.node && [ "$(tr ' ' '\n' <read.ele | sort -n | tr '\n' ' ')" = " 0 0 0 1 1 2 3 4 " ]
    report $? "reads_weights_of_$file"
done
"$tool" --dim 3 --weights --quiet -o read.ele - <same.xyz >out 2>err
status=$?
done_well && cmp -s read.node weighted.node
report $? reads_standard_input

run --quiet --weights -o read.ele columns.txt
done_well && cmp -s read.node weighted.node
report $? columns_but_the_weight_are_coordinates
run --quiet -o read.ele columns.txt
done_well && [ "$(sed -n '1p;6p' read.node)" = "$(printf '5 4 0 0\n 4 0.25 0.25 0.25 -1')" ]
report $? all_columns_of_text_are_coordinates
run --quiet --dim 2 -o read.ele columns.txt
done_well && [ "$(sed -n '1p;6p' read.node)" = "$(printf '5 2 0 0\n 4 0.25 0.25')" ]
report $? dim_takes_the_first_columns
write four.off 'nOFF 4\n6 0 0\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n.1 .1 .1 .1\n'
run --quiet -o read.ele four.off
done_well && [ "$(sed -n 1p read.ele)" = "5 5 0" ]
report $? reads_off_of_four_dimensions

write atoms.pdb 'HEADER
ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  ALA A   1      10.000   0.000   0.000
HETATM    3 FE   HEM A   1       0.000  10.000   0.000  1.00  0.00          FE
ATOM      4  O   ALA A   1       0.000   0.000-110.500
ATOM      5 HG11 VAL A   1       2.500   2.500  -2.500
ENDMDL
ATOM      6  N   ALA A   1       9.000   0.000   0.000
END
'
run --quiet --weights -o read.ele atoms.pdb
awk 'NR > 1 { printf "%s %s %s %.4f;", $2, $3, $4, $5 }' read.node >atoms
done_well && [ "$(cat atoms)" = "0 0 0 2.4025;10 0 0 2.8900;0 10 0 4.0000;0 0 -110.5 2.3104;2.5 2.5 -2.5 1.4400;" ]
report $? reads_atoms_of_the_first_model_with_squared_radii

# Decimals on and beside the middle between two doubles, and at the ends of the range
write hard.txt '9007199254740993 9007199254740993.00000000000000000001\n9007199254740995 1e23\n123456789012345678901234567890 0.1
2.2250738585072011e-308 4.9406564584124654e-324\n1.7976931348623157e308 -2.4703282292062327e-324\n-1e-400 8.5e-27\n'
write hard.node ' 0 9007199254740992 9007199254740994\n 1 9007199254740996 9.9999999999999992e+22
 2 1.2345678901234568e+29 0.10000000000000001\n 3 2.2250738585072009e-308 4.9406564584124654e-324
 4 1.7976931348623157e+308 0\n 5 0 8.5000000000000003e-27\n'
run --quiet -o read.ele hard.txt
done_well && sed 1d read.node | cmp -s - hard.node
report $? decimals_are_rounded_exactly

# --- hulls ------------------------------------------------------------------------------------------------------------
# A cube with a point in the middle of it and of its bottom, and a corner twice

printf '0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n.5 .5 .5\n.5 .5 0\n1 1 1\n' >cube.xyz
run --hull --check --hash --stats stats.json -o cube.off -o cube.ply -o cube.obj -o cube.npy cube.xyz
done_well && grep -q '^vertices     9, 8 of them extreme$' out && grep -q '^hull facets  14 in 6 planes$' out &&
    grep -q '"hull_facets": 14,' stats.json && grep -q '"hull_vertices": 8,' stats.json && grep -q '"hull_planes": 6,' stats.json &&
    grep -q '"hull_volume": 1,' stats.json && grep -q '"hull_area": 6,' stats.json && grep -q '"certified": true' stats.json
report $? hull_of_a_cube
[ "$(sed -n 2p cube.off)" = "11 14 0" ] && [ "$(grep -c '^3 ' cube.off)" -eq 14 ] && [ "$(grep -c '^v ' cube.obj)" -eq 9 ] &&
    [ "$(grep -c '^f ' cube.obj)" -eq 14 ] && grep -aq '^element face 14$' cube.ply && grep -aq 'shape.: (14, 3)' cube.npy
report $? hull_is_written_in_every_format
awk 'NR > 2 && NF == 3 && n < 11 { for (k = 1; k <= 3; k++) x[n, k] = $k; n++ }
    NF == 4 { for (k = 1; k <= 3; k++) { a[k] = x[$2, k] - 0.5; b[k] = x[$3, k] - 0.5; c[k] = x[$4, k] - 0.5 }
        v += a[1] * (b[2] * c[3] - b[3] * c[2]) - a[2] * (b[1] * c[3] - b[3] * c[1]) + a[3] * (b[1] * c[2] - b[2] * c[1]) }
    END { exit !(v > 5.999 && v < 6.001) }' cube.off
report $? hull_faces_are_counterclockwise_from_outside
for dim in 2 3 4 5; do
    run --hull --check --quiet --dim $dim -o hull.off -o hull.npy gen:ball:2000:1
    done_well && grep -aq ", $dim)" hull.npy
    report $? "hull_in_${dim}_dimensions_is_certified"
done
[ "$(hash_of --hull --jobs 1 gen:ball:50000:1)" = "$(hash_of --hull --jobs 3 gen:ball:50000:1)" ] &&
    [ -n "$(hash_of --hull --jobs 2 gen:ball:50000:1)" ]
report $? hull_does_not_depend_on_jobs
run --hull --check --stats - gen:coplanar:100:1
done_well && grep -q '"affine_dim": 2' out
report $? hull_of_a_plane
run --hull --stats - gen:ball:1000:1
done_well && ! grep -q self_centred out
report $? hull_has_no_measures_of_cells
printf '1.5abc 2 3\n' >tail.xyz
ends hull_of_bad_file 3 "^paradt: tail.xyz:1:" --hull tail.xyz
run --hull --quiet --dim 3 same.xyz
done_well
report $? hull_of_weights_left_out
printf '1e300 0\n0 1e300\n-1e300 0\n0 -1e300\n' >huge.txt
run --hull --check --stats - huge.txt
done_well && grep -q '"hull_volume": null' out
report $? hull_too_large_for_a_double_is_null
run --furthest --stats - gen:ball:1000:1
done_well && grep -q '"cells"' out
report $? furthest_sites_have_cells

# --- generated points -------------------------------------------------------------------------------------------------

kinds=$("$tool" --help | sed -n '/^Kinds/,/^$/s/^  \([a-z-]*\) .*/\1/p')
for dim in 2 3 4; do
    for kind in $kinds; do
        run --dim $dim --weights --check --quiet -o read.ele "gen:$kind:40:7"
        done_well || break 2
        cat read.node
    done
done >generated
[ "$(grep -c ' 0$' generated)" -gt 70 ] && done_well
report $? every_kind_is_triangulated_and_certified
[ "$(cksum <generated)" = "4059516375 186139" ]
report $? generated_points_never_change
# Vertices of more cells than the tables of an insertion hold
run --check --hash --quiet --regions 1 gen:helix:2000:2
crowded=$(cat out)
done_well && [ "$(hash_of --regions 3 gen:helix:2000:2)" = "$crowded" ]
report $? crowded_vertices

run --hash --quiet gen:uniform:1e3
[ "$(cat out)" = "$(hash_of gen:uniform:1000:1)" ] && done_well
report $? counts_may_have_an_exponent_and_the_seed_defaults_to_1

# --- outputs ----------------------------------------------------------------------------------------------------------

run -o all.ele -o all.vtu -o all.off -o all.ply -o all.obj -o all.npy -o all.svg -o all.png --stats all.json --check gen:uniform:500:3
done_well && [ "$(ls all.* | tr '\n' ' ')" = "all.ele all.json all.neigh all.node all.npy all.obj all.off all.ply all.png all.svg all.vtu " ]
report $? all_outputs_at_once
cells=$(sed -n 's/^cells *//p' out) facets=$(sed -n 's/^hull facets *//p' out)

awk -v cells="$cells" '
    FNR == 1 { file++; if ($1 != cells || $2 != 4) exit bad = 1; next }
    file == 1 { for (i = 0; i < 4; i++) v[$1, i] = $(i + 2) }
    file == 2 { for (i = 0; i < 4; i++) n[$1, i] = $(i + 2) }
    function has(c, x,   i) { for (i = 0; i < 4; i++) if (v[c, i] == x) return 1; return 0 }
    END {
        for (c = 0; c < cells; c++)
            for (i = 0; i < 4; i++) {
                if ((m = n[c, i]) < 0) { hull++; continue }
                for (j = back = 0; j < 4; j++) {
                    if (n[m, j] == c) back++
                    if (j != i && !has(m, v[c, j])) bad = 1
                }
                if (back != 1) bad = 1
            }
        print hull + 0
        exit bad
    }' all.ele all.neigh >hull
[ $? -eq 0 ] && [ "$(cat hull)" = "$facets" ]
report $? neighbours_share_the_facet_opposite_their_vertex

run --quiet -o cube.obj -o cube.off -o cube.ply gen:lattice:64:1
awk '
    $1 == "v" { n++; x[n] = $2; y[n] = $3; z[n] = $4 }
    $1 == "f" {
        faces++
        a = $2; b = $3; c = $4
        six += x[a] * (y[b] * z[c] - z[b] * y[c]) - y[a] * (x[b] * z[c] - z[b] * x[c]) + z[a] * (x[b] * y[c] - y[b] * x[c])
    }
    END { print n, faces, six / 6 }' cube.obj >volume
[ "$(cat volume)" = "56 108 27" ]
report $? hull_of_a_lattice_in_obj_is_closed_and_looks_outward
[ "$(sed -n '1,2p' cube.off | tr '\n' ' ')" = "OFF 64 108 0 " ] && [ "$(wc -l <cube.off)" -eq $((2 + 64 + 108)) ]
report $? off_has_all_points_and_the_facets
bytes=$(sed '/^end_header/q' cube.ply | wc -c)
grep -aq '^element vertex 56$' cube.ply && grep -aq '^element face 108$' cube.ply &&
    [ "$(wc -c <cube.ply)" -eq $((bytes + 56 * 24 + 108 * 13)) ]
report $? ply_holds_what_it_announces
run --quiet --hash cube.ply
[ "$(cat out)" = "$(awk '$1 == "v" { print $2, $3, $4 }' cube.obj | hash_of -)" ] && done_well
report $? own_ply_is_read_back

grep -aq 'NumberOfPoints="500" NumberOfCells="'"$cells"'"' all.vtu &&
    bytes=$(sed '/^<AppendedData/q' all.vtu | wc -c) &&
    [ "$(wc -c <all.vtu)" -eq $((bytes + 1 + 4 * 8 + 500 * 24 + cells * 16 + cells * 8 + cells + 28)) ]
report $? vtu_holds_what_it_announces
dd if=all.vtu bs=1 skip=$((bytes + 1)) count=8 2>/dev/null | od -An -tu8 | tr -d ' ' >block
tail -c $((28 + cells + 8)) all.vtu | head -c 8 | od -An -tu8 | tr -d ' ' >>block
tail -c $((28 + 1)) all.vtu | head -c 1 | od -An -tu1 | tr -d ' ' >>block
[ "$(tr '\n' ' ' <block)" = "12000 $cells 10 " ]
report $? vtu_blocks_begin_with_their_size_and_cells_are_tetrahedra
[ "$(wc -c <all.npy)" -eq $((128 + cells * 16)) ] && grep -aq "'shape': ($cells, 4)" all.npy &&
    [ "$(tail -c 16 all.npy | od -An -td4 | tr -s ' ')" = "$(tail -n 1 all.ele | cut -d' ' -f3- | sed 's/^/ /')" ]
report $? npy_holds_the_cells

grep -q '^<svg ' all.svg && [ "$(tail -n 1 all.svg)" = "</svg>" ] && [ "$(grep -c '^<path' all.svg)" -gt 100 ]
report $? svg_is_drawn
# The data of a PNG are a zlib stream in a chunk that ends 16 bytes before the file does. gzip unpacks them if they follow its
# own header.
size=$(dd if=all.png bs=1 skip=33 count=4 2>/dev/null | od -An -tu1 | awk '{ print (($1 * 256 + $2) * 256 + $3) * 256 + $4 }')
{ printf '\037\213\010\000\000\000\000\000\000\000'; tail -c +44 all.png | head -c $((size - 6)); } | gzip -dc 2>/dev/null >pixels
[ "$size" -eq $(($(wc -c <all.png) - 57)) ] && [ "$(wc -c <pixels)" -eq $((1000 * (1 + 3 * 1200))) ]
report $? png_unpacks_to_its_size

for input in gen:collinear:20:1 gen:coplanar:20:1 gen:huge:20:1 gen:subnormal:20:1 gen:uniform:0:1 gen:uniform:1:1 \
    gen:uniform:2:1 gen:uniform:4:1; do
    for dim in 2 3; do
        run --dim $dim --quiet --check -o d.ele -o d.vtu -o d.off -o d.ply -o d.obj -o d.npy -o d.svg -o d.png $input
        done_well || break 2
    done
done
done_well
report $? flat_few_and_extreme_points_go_into_every_format
run --quiet --dim 5 -o five.off -o five.ele -o five.npy gen:uniform:20:1
done_well && [ "$(sed -n '1,2p' five.off | tr '\n' ' ')" = "nOFF 5 " ]
report $? five_dimensions_go_into_off_ele_and_npy
write comment.xyz '# no points\n'
write none.node '0 3 0 0\n'
run --quiet comment.xyz && run --quiet none.node
done_well
report $? no_points_are_no_error

# --- queries ----------------------------------------------------------------------------------------------------------

write plane.txt '0 0\n4 0\n4 3\n0 3\n1 1\n'
write places.csv 'x,y\n1,1\n2,0\n0.5,0.25\n9,9\n2.5,2\n1 1.4\n'
run --dim 2 -o plane.ele --locate places.csv=- --nearest places.csv=near.csv plane.txt
done_well && awk '
    FILENAME == "plane.ele" { if (FNR > 1) for (k = 0; k < 3; k++) vertex[$1, k] = $(k + 2); next }
    {
        split($0, answer, ",")
        for (n = k = 0; k < 3; k++) if (int(answer[2] / 2 ^ k) % 2) { n++; last = vertex[answer[1], k] }
        faces = faces n
        if (FNR == 1) first = last
    }
    END { exit !(faces == "123023" && first == 4) }' plane.ele out && [ "$(tr '\n' ' ' <near.csv)" = "4 4 0 2 4 4 " ]
report $? places_on_a_vertex_on_an_edge_inside_and_outside

run --quiet --dim 2 -o seen.ele --locate gen:uniform:300:2=cells.csv --nearest gen:uniform:300:2=near.csv gen:uniform:200:1
run --quiet --dim 2 -o asked.ele gen:uniform:300:2
done_well && awk '
    FNR == 1 { file++; if (file < 4) next }
    file == 1 { x[$1] = $2; y[$1] = $3; next }
    file == 2 { for (k = 0; k < 3; k++) vertex[$1, k] = $(k + 2); next }
    file == 3 { qx[$1] = $2; qy[$1] = $3; next }
    file == 4 { split($0, answer, ","); cell[FNR - 1] = answer[1]; face[FNR - 1] = answer[2]; next }
    {
        q = FNR - 1; best = 9
        for (i in x) { d = (x[i] - qx[q]) ^ 2 + (y[i] - qy[q]) ^ 2; if (d < best) { best = d; nearest = i } }
        if (nearest != $1) wrong++
        for (outside = k = 0; k < 3; k++) {
            a = vertex[cell[q], k]; b = vertex[cell[q], (k + 1) % 3]
            if ((x[b] - x[a]) * (qy[q] - y[a]) - (y[b] - y[a]) * (qx[q] - x[a]) < 0) outside++
        }
        if (!outside != (face[q] == 7) || (outside && face[q] != 0)) wrong++
        answers++
    }
    END { exit !(answers == 300 && !wrong) }' seen.node seen.ele asked.node cells.csv near.csv
report $? answers_are_those_of_brute_force

run --quiet --locate gen:uniform:300:2=a.npy --nearest gen:uniform:300:2=b.npy gen:uniform:200:1
done_well && grep -aq "'<i4'.*'shape': (300, 2)" a.npy && [ "$(wc -c <a.npy)" -eq $((128 + 300 * 8)) ] &&
    grep -aq "'shape': (300, 1)" b.npy && [ "$(wc -c <b.npy)" -eq $((128 + 300 * 4)) ]
report $? answers_as_arrays
run --quiet --locate gen:uniform:300:2=a.vtu --nearest gen:uniform:300:2=b.vtu gen:uniform:200:1
done_well && grep -aq 'NumberOfPoints="300" NumberOfCells="300"' a.vtu && grep -aq 'Name="face"' a.vtu && grep -aq 'Name="nearest"' b.vtu
report $? answers_as_points_for_paraview
run --stats all.json --weights --locate gen:uniform:50:2=a.csv --nearest gen:uniform:50:2=b.csv gen:uniform:200:1
done_well && grep -q '"seconds_locate": [0-9]' all.json && grep -q '"seconds_nearest": [0-9]' all.json &&
    [ "$(cat a.csv b.csv | wc -l)" -eq 100 ] && grep -q '^located  *50 queries' out
report $? queries_are_timed_and_weights_are_fine
printf '0 0\n' | "$tool" --dim 2 --quiet --nearest -=- plane.txt >out 2>err
status=$?
done_well && [ "$(cat out)" = 0 ]
report $? queries_from_standard_input
for input in gen:uniform:0:1 gen:uniform:1:1 gen:uniform:2:1 gen:collinear:9:1 gen:coplanar:9:1 gen:duplicates:30:1 gen:huge:30:1 \
    gen:subnormal:30:1; do
    for dim in 2 3; do
        run --dim $dim --quiet --locate gen:uniform:20:2=a.csv --nearest $input=b.csv $input
        done_well && [ "$(wc -l <a.csv)" -eq 20 ] || break 2
    done
done
done_well
report $? queries_of_flat_few_and_extreme_points
ends queries_of_another_dimension 3 '^paradt: plane.txt:1: 2 numbers where 3 are needed' --locate plane.txt=a.csv gen:uniform:30:1
write nowhere.xyz '0 0 nan\n'
ends a_query_that_is_not_finite 3 '^paradt: nowhere.xyz:1: coordinate 3 is not finite' --nearest nowhere.xyz=late.csv gen:uniform:30:1
[ ! -e late.csv ]
report $? no_answers_are_left_after_an_error
ends queries_are_not_replaced 2 '^paradt: places.csv: would replace' --dim 2 --locate places.csv=places.csv gen:uniform:30:1
ends queries_that_are_missing 3 '^paradt: missing.csv: ' --dim 2 --locate missing.csv=a.csv gen:uniform:30:1

# --- Voronoi cells ----------------------------------------------------------------------------------------------------

sum_is() { # file, sum, number of rows that are not infinite: of the volumes
    awk -F, -v due="$2" -v rows="$3" 'NR > 1 && $2 != "inf" { sum += $2; n++ }
        END { d = sum - due; exit !(d < 1e-12 * due && -d < 1e-12 * due && n == rows) }' "$1"
}
run --box 0,0,0,1,1,1 --voronoi box.csv --voronoi box.vtu --voronoi box.npy --voronoi box.png --stats box.json gen:uniform:400:1
done_well && sum_is box.csv 1 400 && [ "$(sed -n 1p box.csv)" = index,volume,cx,cy,cz,faces ] &&
    awk -F, 'NR > 1 && ($1 != NR - 2 || $3 <= 0 || $3 >= 1 || $6 < 4) { exit 1 }' box.csv &&
    grep -Eq '"voronoi_volume": (1|0.99999999999|1.00000000000)' box.json && grep -q '"seconds_voronoi": ' box.json &&
    awk -F, 'NR == FNR { sides += $6; next } /voronoi_faces/ { split($1, f, ":"); exit !(f[2] < sides && 2 * f[2] > sides) }' box.csv box.json
report $? cells_fill_the_box
[ "$(wc -c <box.npy)" -eq $((128 + 400 * 6 * 8)) ] && grep -aq "'<f8'.*'shape': (400, 6)" box.npy &&
    [ "$(tail -c 48 box.npy | od -An -tf8 -N 8 | tr -d ' ')" = 399 ]
report $? cells_as_an_array
run --dim 2 --quiet --voronoi - --box -1,-1,2,2 gen:uniform:50:1
done_well && mv out flat.csv && sum_is flat.csv 9 50 && [ "$(sed -n 1p flat.csv)" = index,volume,cx,cy,faces ]
report $? cells_in_the_plane_as_text
run --dim 2 --voronoi flat.csv --stats flat.json plane.txt
done_well && [ "$(awk -F, '$2 == "inf" && $3 == "nan"' flat.csv | wc -l)" -eq 4 ] && grep -q '"voronoi_volume": null' flat.json
report $? unbounded_cells_say_so
write twice.txt '0 0 1\n2 0 1\n1 0 -9\n2 0 0\n1 2 1\n' # the third is hidden, the fourth a duplicate
run --dim 2 --weights --box -4,-4,4,4 --voronoi twice.csv twice.txt
done_well && sum_is twice.csv 64 5 && [ "$(awk -F, '$2 == 0 { printf "%s:%s ", $1, $5 }' twice.csv)" = "2:0 3:0 " ]
report $? hidden_points_and_duplicates_have_empty_cells
run --dim 4 --voronoi four.csv --box 0,0,0,0,1,1,1,1 gen:uniform:40:1
done_well && sum_is four.csv 1 40 && [ "$(sed -n 1p four.csv)" = index,volume,c1,c2,c3,c4,faces ]
report $? cells_in_four_dimensions
for input in gen:uniform:0:1 gen:uniform:1:1 gen:uniform:2:1 gen:collinear:9:1 gen:coplanar:9:1 gen:lattice:27:1 gen:huge:30:1 \
    gen:subnormal:30:1; do
    for dim in 2 3; do
        run --dim $dim --quiet --voronoi v.csv --voronoi v.vtu --voronoi v.npy --voronoi v.svg --voronoi v.png $input
        done_well || break 2
    done
done
done_well
report $? cells_of_flat_few_and_extreme_points_in_every_format
run --dim 2 --quiet --voronoi flat.svg --voronoi flat.vtu --voronoi flat.csv gen:uniform:300:1
done_well && [ "$(grep -c '^<path' flat.svg)" -eq "$(grep -c '^<circle' flat.svg)" ] && [ "$(grep -c '^<path' flat.svg)" -gt 250 ]
report $? a_picture_of_cells_in_the_plane
run --quiet --voronoi block.svg --box 0,0,0,1,1,1 gen:uniform:2000:1
done_well && [ "$(grep -c '^<path' block.svg)" -gt 300 ]
report $? a_picture_of_a_block_in_space
python=
for name in python3 /usr/bin/python3; do
    [ -n "$python" ] || ! $name -c 'import vtkmodules.vtkFiltersVerdict' 2>/dev/null || python=$name
done
sees() { # name, files as tool arguments: VTK reads see.vtu and finds the cells of see.csv
    name=$1
    shift
    if [ -z "$python" ]; then
        skip "$name" "needs python3-vtk9"
        return
    fi
    run --quiet --voronoi see.vtu --voronoi see.csv "$@"
    done_well && $python ../../../tests/programs/vtk_cells.py see.vtu see.csv >out 2>err
    report $? "$name"
}
sees vtk_opens_polyhedra_in_a_box --box 0,0,0,1,1,1 gen:uniform:400:1
sees vtk_opens_unclipped_polyhedra gen:uniform:400:1
sees vtk_opens_cells_of_a_lattice --box -1,-1,-1,4,4,4 gen:lattice:64:1
sees vtk_opens_power_cells --weights --box 0,0,0,1,1,1 gen:uniform:400:1
sees vtk_opens_polygons --dim 2 --box 0,0,1,1 gen:uniform:400:1
ends voronoi_in_five_dimensions_for_vtk 2 '^paradt: five.vtu: .vtu files hold at most 3 dimensions' --dim 5 --voronoi five.vtu gen:uniform:9:1
ends a_box_of_another_dimension 2 '^paradt: --box: 4 numbers where 6 are needed' --box 0,0,1,1 --voronoi a.csv gen:uniform:9:1
ends a_box_without_inside 2 '^paradt: --box: the lower bound 2 is not below' --dim 2 --box 0,1,1,1 --voronoi a.csv gen:uniform:9:1
ends cells_in_a_folder_that_is_missing 1 '^paradt: nowhere/a.csv: No such file' --voronoi nowhere/a.csv gen:uniform:9:1
ends two_files_of_cells_of_one_name 2 '^paradt: one.csv: two outputs of one name' --voronoi one.csv --nearest gen:uniform:9:1=one.csv gen:uniform:9:1
[ ! -e one.csv ]
report $? no_cells_are_left_after_an_error

# --- what is printed --------------------------------------------------------------------------------------------------

run gen:uniform:300:1
done_well && grep -q '^points  *300 in 3 dimensions$' out && grep -Eq '^cells  *[0-9]+$' out && grep -q '^time .* cells a second' out
report $? the_summary_says_what_was_done
run --regions 1000000 gen:uniform:4:1
done_well && grep -q ' 4 regions)' out
report $? the_summary_counts_the_regions_that_were_built
run --quiet gen:uniform:300:1
done_well && [ ! -s out ]
report $? quiet_is_silent
run --hash gen:uniform:300:1
done_well && tail -n 1 out | grep -Eq '^[0-9a-f]{16}$' && [ "$(wc -l <out)" -gt 3 ]
report $? the_hash_is_the_last_line
run --stats - --hash --weights --check gen:uniform:300:1
sed '$d' out >stats
done_well && [ "$(sed -n '1p;$p' stats | tr -d '\n')" = '{}' ] && grep -q '^  "points": 300,$' stats &&
    grep -q '^  "dim": 3,$' stats && grep -q '^  "weights": true,$' stats && grep -q '^  "certified": true,$' stats &&
    grep -Eq '^  "seconds": [0-9]+\.[0-9]+$' stats && [ "$(grep -Ec '^  "[a-z_]+": ("[^"]*"|[0-9.]+(e[-+][0-9]+)?|true|false),?$' stats)" -eq \
    $(($(wc -l <stats) - 2)) ]
report $? statistics_on_standard_output_are_json_alone
printf '0 0\n4 0\n1 1\n' >obtuse.txt
run --stats - obtuse.txt
done_well && grep -q '^  "max_min_containment_radius": 2,$' out && grep -q '^  "self_centred_cells": 0,$' out
report $? statistics_tell_how_cells_are_shaped
hidden=$(sed -n 's/^  "hidden": \(.*\),/\1/p' stats)
run --weights gen:uniform:300:1
[ "$hidden" -gt 0 ] && grep -q "^hidden  *$hidden\$" out
report $? hidden_points_are_counted
cp same.xyz 'a "quoted\ name.xyz'
run --stats - 'a "quoted\ name.xyz'
done_well && grep -q '^  "input": "a \\u0022quoted\\u005c name.xyz",$' out
report $? names_in_json_are_escaped
if [ -w /dev/full ]; then
    "$tool" gen:uniform:100:1 >/dev/full 2>err
    status=$?
    [ "$status" -eq 1 ] && grep -q '^paradt: standard output' err
    report $? a_full_standard_output_is_an_error
    "$tool" -o unseen.obj gen:uniform:100:1 >/dev/full 2>err
    status=$?
    [ "$status" -eq 1 ] && ! ls unseen.* >/dev/null 2>&1
    report $? what_could_not_be_printed_leaves_no_file
    "$tool" --help >/dev/full 2>err
    status=$?
    [ "$status" -eq 1 ] && grep -q '^paradt: standard output' err
    report $? help_that_could_not_be_printed_is_an_error
fi

# --- the same result in every way -------------------------------------------------------------------------------------

for input in gen:uniform:1500:1 gen:fcc:1000:1 gen:clusters:1500:1; do
    due=$(hash_of "$input")
    for way in '--method incode' '--method dewall' '--regions 5 --jobs 1' '--regions 4 --jobs 3' \
        '--regions 7 --partition uniform' '--partition=bisection --regions=2 --jobs=64'; do
        # shellcheck disable=SC2086 # the way is words
        [ -n "$due" ] && [ "$(hash_of $way $input)" = "$due" ] || break 2
    done
done
[ "$(hash_of $way $input)" = "$due" ] && [ "$input" = gen:clusters:1500:1 ]
report $? methods_regions_jobs_and_partitions_agree

# --- failures leave nothing behind ------------------------------------------------------------------------------------

write old.ele 'old\n'
(ulimit -f 16; "$tool" --quiet -o old.ele gen:uniform:5000:1 >out 2>err; echo $? >status)
status=$(cat status)
[ "$status" -eq 1 ] && grep -q '^paradt: old\.' err && [ "$(cat old.ele)" = old ] && [ "$(ls old.*)" = old.ele ]
report $? a_failed_write_keeps_the_old_file_and_leaves_no_other
mkdir taken.neigh
run --quiet -o taken.ele gen:uniform:50:1
[ "$status" -eq 1 ] && grep -q '^paradt: taken.neigh: Is a directory' err && [ "$(ls -d taken.*)" = taken.neigh ]
report $? a_folder_in_the_way_is_refused
ends a_missing_folder_is_refused 1 '^paradt: nowhere/out.ele: No such file' -o nowhere/out.ele gen:uniform:50:1
ends the_input_is_not_replaced 2 '^paradt: ./one.node: would replace the input' -o ./one.ele one.node
ends statistics_do_not_replace_the_input 2 '^paradt: same.xyz: would replace' --stats same.xyz same.xyz

ends two_outputs_of_one_name_are_refused 2 '^paradt: one.off: two outputs of one name' -o one.off -o one.off same.xyz
mkfifo pipe.off
ends a_pipe_is_not_replaced 1 '^paradt: pipe.off: no regular file' -o pipe.off same.xyz
ends statistics_do_not_replace_a_pipe 1 '^paradt: pipe.off: no regular file' --stats pipe.off same.xyz
write target.off 'old\n'
ln -s target.off link.off
run --quiet -o link.off same.xyz
done_well && [ -h link.off ] && [ "$(sed -n 1p target.off)" = OFF ]
report $? a_link_is_followed
if [ "$(id -u)" -eq 0 ] && command -v setpriv >/dev/null 2>&1; then # in a folder where files of other users can't be replaced
    mkdir sticky && chmod 1777 sticky && chmod a+rx . && write sticky/mine.off 'old\n' && chown 65534 sticky/mine.off
    write sticky/yours.off 'old\n'
    ran=$(setpriv --reuid=65534 --clear-groups "$tool" --quiet -o sticky/mine.off -o sticky/yours.off gen:uniform:50:1 2>&1)
    status=$?
    case $ran in
    *denied*) ;; # this user can't enter the folder
    *)
        [ $status -eq 1 ] && [ "$(cat sticky/mine.off sticky/yours.off)" = "$(printf 'old\nold')" ] &&
            [ "$(ls -A sticky | tr '\n' ' ')" = "mine.off yours.off " ]
        report $? what_was_replaced_already_comes_back
        ;;
    esac
fi

# Ends the tool as soon as a temporary file of its outputs exists.
caught=1
for try in 1 2 3 4 5; do
    "$tool" --quiet -o late.ele -o late.vtu gen:uniform:$((try * 20000)):1 >out 2>err &
    process=$!
    while kill -0 $process 2>/dev/null && ! ls late.* >/dev/null 2>&1; do :; done
    kill -TERM $process 2>/dev/null && caught=0
    wait $process 2>/dev/null
    status=$?
    [ $status -gt 128 ] && break
    caught=1
    rm -f late.*
done
ls late.* >left 2>/dev/null
[ $caught -eq 0 ] && [ $status -eq 143 ] && [ ! -s left ]
report $? an_interrupted_run_leaves_no_file

# Ctrl-C while it works: it ends at once, by the signal, and says so.
"$tool" --quiet -o later.vtu gen:uniform:3000000:1 >out 2>err &
process=$!
sleep 1
kill -INT $process 2>/dev/null
caught=$?
wait $process 2>/dev/null
status=$?
ls later.* >left 2>/dev/null
[ $caught -eq 0 ] && [ $status -eq 130 ] && [ ! -s left ] && grep -q '^interrupted$' err
report $? control_c_ends_a_run_which_says_so_and_leaves_no_file

plan
