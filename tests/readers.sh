#!/bin/sh
# The readers of the tools, alone: files as people have them are read right, or refused with the reason and what to do. Builds
# tests/programs/read.c with the sanitizers, if the compiler has them, and with zlib, if it is there. Prints TAP.
root=$PWD
. tests/programs/tap.sh
work=$root/build/tests/readers
rm -rf "$work"
mkdir -p "$work"
CC=${CC:-cc}
build() { # program, flags
    program=$1
    shift
    $CC -g1 -std=c99 -I. -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -o "$work/$program" tests/programs/read.c "$@" \
        2>>"$work/build.log"
}
sanitize="-O1 -fsanitize=address,undefined -fno-sanitize-recover=all"
zlib=1
build read $sanitize -DPARADT_ZLIB -lz -lm || build read -O1 -DPARADT_ZLIB -lz -lm || { zlib=; build read $sanitize -lm; } || build read -O1 -lm ||
    { echo "not ok 1 - the_readers_build"; sed 's/^/# /' "$work/build.log"; echo "1..1"; exit 1; }
build plain $sanitize -lm || build plain -O1 -lm
ASAN_OPTIONS=exitcode=99:allocator_may_return_null=1
UBSAN_OPTIONS=exitcode=99
export ASAN_OPTIONS UBSAN_OPTIONS
cp -r tests/inputs "$work/inputs"
cd "$work" || exit 1

explain() { echo "status $status"; tail -n 8 err; tail -n 3 out; }
run() { # arguments of read; sets status, and writes the files out and err
    ./read "$@" >out 2>err
    status=$?
}
prints() { # name, what is printed, arguments
    name=$1 due=$2
    shift 2
    run "$@"
    [ "$status" -eq 0 ] && [ ! -s err ] && [ "$(cat out)" = "$due" ]
    report $? "$name"
}
refuses() { # name, status, pattern of the error, arguments
    name=$1 due=$2 pattern=$3
    shift 3
    run "$@"
    [ "$status" -eq "$due" ] && grep -q -- "$pattern" err
    report $? "$name"
}

# --- files as people have them: tests/inputs ------------------------------------------------------------------------------

five='0.10000000000000001 0.20000000000000001 0.29999999999999999;1.5 0.25 0.125;0.29999999999999999 1.75 0.5;0.40000000000000002 0.59999999999999998 2.25;1.1000000000000001 1.2 1.3;'
for file in ascii.stl chem.xyz count_only.xyz dump.lammpstrj ext.xyz hdr_id.csv header.txt m.mesh m.obj m.pcd m.vtk pandas_index.csv pts.dat \
    qhull.txt quoted.csv semidec.csv tsv.tsv; do
    due=$five
    [ $file = ascii.stl ] && due='0 0 0;1 0 0;0 1 0;'
    prints "reads_$file" "$due" inputs/$file
    case $file in
    m.obj) ./read --format obj - <inputs/$file >out 2>err ;;
    *) ./read - <inputs/$file >out 2>err ;;
    esac
    status=$?
    [ $status -eq 0 ] && [ "$(cat out)" = "$due" ]
    report $? "reads_${file}_from_standard_input"
done
prints decimal_commas_between_blanks "$five [its commas are read as decimal commas]" inputs/decimal_comma.txt
prints integers_of_an_array '1 2 3;15 2 1;3 17 5;4 6 22;11 12 13;' inputs/i4.npy
prints a_shifted_serial_number_shifts_the_coordinates \
    '1007.5170000000001 2003.258 3011.1289999999999;1009.131 2004.4469999999999 3012.366;' inputs/shifted_serial.pdb
run inputs/altloc.pdb
[ "$status" -eq 0 ] && grep -q ';9 8 7;5 5 5; \[2 alternate locations are left out' out && [ "$(tr -cd ';' <out | wc -c)" -eq 8 ]
report $? the_first_alternate_location_is_kept_and_the_others_are_counted
run inputs/end_then_more.pdb
[ "$status" -eq 0 ] && [ "$(sed 's/ \[.*//' out | tr -cd ';')" = ';;;;;' ] && grep -q '\[what comes before END is read' out
report $? end_ends_the_atoms
refuses a_page_is_no_molecule 3 '404.pdb: an HTML page' inputs/404.pdb
refuses a_grid_without_points 3 'there is no Piece with Points' inputs/m.vtu
refuses row_numbers_are_no_coordinate 3 'the first column counts the rows: --columns 2-5 leaves it out, --columns 1-5' inputs/voropp.txt
run --columns 2-5 --radii inputs/voropp.txt
[ "$status" -eq 0 ] && grep -q '^0.5 0.5 0.5 0.089999999999999997;1.5 0.5 0.5 0.16000000000000003;' out
report $? columns_and_radii_of_voropp
for file in gz_oneline.csv p.txt.gz; do
    ./plain inputs/$file >out 2>err
    status=$?
    [ $status -eq 3 ] && grep -q 'built without zlib; unpack it first: gunzip' err
    report $? "without_zlib_${file}_is_refused"
    if [ -n "$zlib" ]; then
        [ $file = p.txt.gz ] && due=$five || due='20 0 0;1 0 0;0 1 0;0 0 1;'
        prints "with_zlib_$file" "$due" inputs/$file
    else
        skip "with_zlib_$file" "zlib is not installed"
    fi
done

# --- text, each way of writing it: name | arguments | file | contents as printf prints them | what is printed --------------

while IFS='|' read -r name arguments file contents due; do
    # shellcheck disable=SC2059 # the contents are a format
    printf -- "$contents" >"$file"
    # shellcheck disable=SC2086 # the arguments are words
    prints "$name" "$due" $arguments "$file"
done <<'TABLE'
halves_become_even||a.txt|9007199254740993 9007199254740995\n|9007199254740992 9007199254740996;
digits_beyond_the_nineteenth_decide||a.txt|9007199254740993.00000000 9007199254740993.00000001\n|9007199254740992 9007199254740994;
digits_beyond_the_nineteenth_count||a.txt|12345678901234567890000 1\n|1.2345678901234568e+22 1;
comment_signs||a.txt|# a\n%% b\n// c\n! d\n1 2\n  %% e\n3 4 # f\n|1 2;3 4;
several_title_lines||a.csv|Run of Monday\nx,y\n"in m","in m"\n1,2\n3,5\n|1 2;3 5;
titles_in_any_case_and_order||a.csv|Z;Name;Y;X\n3;a;2;1\n6;b;5;4\n|1 2 3;4 5 6;
titles_with_units||a.csv|t,X (mm),Y [mm],Z (mm)\n9,1,2,3\n8,4,5,6\n|1 2 3;4 5 6;
titles_of_paraview||a.csv|"pressure","Points:0","Points:1","Points:2"\n7,1,2,3\n7,4,5,6\n|1 2 3;4 5 6;
titles_in_a_comment||a.txt|# id x y z\n7 1 2 3\n3 4 5 6\n|1 2 3;4 5 6;
titles_of_cloudcompare||a.asc|//X Y Z R G B\n1 2 3 255 0 0\n4 5 6 0 255 0\n|1 2 3;4 5 6;
titles_with_weight|--weights|a.csv|w,x,y\n1,2,3\n4,5,7\n|2 3 1;5 7 4;
titles_with_radius|--weights|a.csv|radius,x,y\n3,2,3\n4,5,7\n|2 3 9;5 7 16;
titles_leave_other_words_out||a.csv|x,y,what\n1,2,a b\n3,5,c\n|1 2;3 5;
titles_without_axes_take_all||a.csv|a,b\n1,2\n3,5\n|1 2;3 5;
titles_with_blanks_between_tabs||a.tsv|point id\tx\ty\n1\t1\t2\n2\t4\t5\n|1 2;4 5;
row_names_of_r||a.txt|"x" "y" "z"\n"1" 1 2 3\n"2" 4 5 6\n"3" 7 8 9\n|1 2 3;4 5 6;7 8 9;
a_column_before_the_titles||a.txt|x y\n1 1 2\n2 3 5\n|1 2;3 5; [the first column has no title, and is left out]
row_names||a.csv|first one,1,2\n"second, too",3,5\n|1 2;3 5;
row_names_in_a_table_of_words||a.txt|north 1 2\nsouth 3 5\n|1 2;3 5;
an_empty_field_before_titles||a.csv|,x,y\nrow,1,2\nrow,3,5\n|1 2;3 5;
semicolons_with_points||a.csv|1.5;2\n3;5\n|1.5 2;3 5;
semicolons_with_commas||a.csv|0,5;2\n3;5,25\n|0.5 2;3 5.25;
quotes_with_commas||a.csv|"0,5","2"\n"3","5,25"\n|0.5 2;3 5.25;
long_decimal_commas||a.csv|0,50000000000000000000000000000;2\n3;5,25e0\n|0.5 2;3 5.25;
commas_of_three_and_blanks||a.txt|1,2,3 4\n5,6,7 9\n|1 2 3 4;5 6 7 9;
a_count_before_points||a.txt|2\n1 2\n3 5\n|1 2;3 5;
a_count_and_a_title||a.pts|2\nx y z\n1 2 3\n4 5 6\n|1 2 3;4 5 6;
points_with_colours||a.pts|2\n1 2 3 9 9 9 9\n4 5 6 9 9 9 9\n|1 2 3;4 5 6;
rbox||a.txt|2 rbox 2 D2\n2\n1 2\n3 5\n|1 2;3 5;
columns_by_numbers|--columns 3,1|a.txt|1 a 2\n3 b 5\n|2 1;5 3;
columns_by_range_and_weight|--columns 2-4 --weights|a.txt|9 1 2 4\n8 3 5 6\n|1 2 4;3 5 6;
columns_by_titles|--columns lon,lat|a.csv|lat,name,LON\n1,a,2\n3,"b, c",5\n|2 1;5 3;
columns_with_radii|--columns x,y,size --radii|a.csv|size,x,y\n3,1,2\n4,3,5\n|1 2 9;3 5 16;
columns_of_counted_rows|--columns 1-3|a.txt|1 5 5\n2 6 6\n3 7 9\n|1 5 5;2 6 6;3 7 9;
byte_order_mark||a.txt|\357\273\2771 2\n3 5\n|1 2;3 5;
utf16_low_byte_first||a.txt|\377\3761\000 \0002\000\n\0003\000 \0005\000\n\000|1 2;3 5;
utf16_high_byte_first||a.txt|\376\377\0001\000 \0002\000\r\000\n\0003\000 \0005|1 2;3 5;
utf16_without_mark||a.csv|1\000,\0002\000\n\0003\000,\0005\000\n\000|1 2;3 5;
any_name||a.points|1 2\n3 5\n|1 2;3 5;
no_name||a|1 2\n3 5\n|1 2;3 5;
exponents_of_fortran||a.txt|1.5D1 2d0\n3 5\n|15 2;3 5;
red_is_no_radius|--weights|a.csv|x,y,r,g,b\n1,2,3,4,5\n|1 2 3;
xy||a.xy|1 2 9\n3 5 9\n|1 2;3 5;
molecule_with_radii|--weights|a.xyz|2\nwater, less an atom\nO 1 2 3\nH1 4 5 6\n|1 2 3 2.3104;4 5 6 1.4399999999999999;
molecule_with_numbers|--weights|a.xyz|1\n\n8 1 2 3\n|1 2 3 2.3104;
molecule_in_frames||a.xyz|1\na\nC 1 2 3\n1\nb\nC 4 5 6\n|1 2 3; [the first frame is read; more follow]
molecule_in_the_plane|--dim 2|a.xyz|1\na\nC 1 2 3\n|1 2;
properties_in_another_order|--weights|a.xyz|1\nProperties=radius:R:1:id:I:1:pos:R:3:species:S:1\n3 7 1 2 4 Zn\n|1 2 4 9;
dump_of_scaled_atoms||a.lammpstrj|ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 4\n1 3\n-2 2\nITEM: ATOMS id xs ys zs\n1 .5 .25 .75\n|2 1.5 1;
dump_with_radii|--weights|a.dump|ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS radius xu yu zu\n3 1 2 4\n|1 2 4 9;
pqr|--weights|a.pqr|REMARK\nATOM 1 N ALA 1 1.5 2 3 -0.3 2\nATOM 2 N ALA A 1 4 5 6 -0.3 3\nTER\nEND\n|1.5 2 3 4;4 5 6 9;
a_second_model_ends_the_first||a.pdb|MODEL        1\nATOM      1  N   ALA A   1       1.000   2.000   3.000\nMODEL        2\nATOM      1  N   ALA A   1       4.000   5.000   6.000\n|1 2 3;
a_model_behind_atoms_ends_these||a.pdb|ATOM      1  N   ALA A   1       1.000   2.000   3.000\nMODEL        2\nATOM      1  N   ALA A   1       4.000   5.000   6.000\n|1 2 3;
mmcif|--weights|a.cif|data_1\n_entry.id 1\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\nC "C1'" . 1 2 3 1\nO 'O a' A 4 5 6 1\nO 'O a' B 4 5 7 1\nN N . 8 8 8 2\n#\n|1 2 3 2.8899999999999997;4 5 6 2.3104; [1 alternate location is left out; the first of each atom is kept]
obj_with_colours||a.obj|v 1 2 3 .5 .5 .5\nvt 0 0\nv 4 5 6 .5 .5 .5\nf 1 2 2\n|1 2 3;4 5 6;
obj_with_weights|--weights|a.obj|v 1 2 3 4\n|1 2 3 4;
equal_corners_are_one_point||a.stl|solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 -0\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex -0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n|0 0 0;1 0 0;0 1 0;
vtu_as_text|--weights|a.vtu|<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="1" NumberOfCells="0"><PointData><DataArray Name="weight" type="Float64" format="ascii">7</DataArray></PointData><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">1 2\n3</DataArray></Points></Piece></UnstructuredGrid></VTKFile>|1 2 3 7;
pcd_in_bytes|--weights|a.pcd|VERSION .7\nFIELDS y x _ z w\nSIZE 1 2 1 1 1\nTYPE U I U I U\nCOUNT 1 1 2 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n\002\001\000\377\377\003\004\005\377\377\000\000\376\006|1 2 3 4;-1 5 -2 6;
pcd_compressed||a.pcd|VERSION .7\nFIELDS x y z\nSIZE 1 1 1\nTYPE U U U\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA binary_compressed\n\005\000\000\000\014\000\000\000\000\007\340\002\000|7 7 7;7 7 7;7 7 7;7 7 7;
medit_in_the_plane||a.mesh|MeshVersionFormatted\n2\n\nDimension\n2\nVertices 2\n1 2 0\n3 5 0\nTriangles 0\nEnd\n|1 2;3 5;
half_floats||a.npy|\223NUMPY\001\000\102\000{'descr': '<f2', 'fortran_order': False, 'shape': (2, 2), }      \n\000\074\000\300\001\000\377\173|1 -2;5.9604644775390625e-08 65504;
TABLE

printf "\\223NUMPY\\001\\000\\102\\000{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3), }      \\n\\001\\002\\003\\004\\005\\006" >a.npy
prints columns_of_an_array '3 1;6 4;' --columns 3,1 a.npy
printf "\\223NUMPY\\001\\000\\102\\000{'descr': '>i8', 'fortran_order': False, 'shape': (1, 2), }      \\n\\377\\377\\377\\377\\377\\377\\377\\376\\000\\000\\000\\000\\000\\000\\000\\003" >a.npy
prints long_integers '-2 3;' a.npy

# --- what is refused: name | status | pattern | arguments | file | contents ------------------------------------------------

while IFS='|' read -r name due pattern arguments file contents; do
    # shellcheck disable=SC2059 # the contents are a format
    printf -- "$contents" >"$file"
    # shellcheck disable=SC2086 # the arguments are words
    refuses "$name" "$due" "$pattern" $arguments "$file"
done <<'TABLE'
an_infinite_coordinate|3|coordinate 2 is not finite||a.txt|1 2\n3 1e999\n
a_nan|3|coordinate 1 is not finite||a.txt|1 2\nnan 4\n
mmcif_called_pdb|3|that of a .cif file, not of .pdb; rename it, or give --format cif||a.pdb|data_1\nloop_\n_atom_site.Cartn_x\n1\n
ply_called_text|3|that of a .ply file, not of .csv||a.csv|ply\nformat ascii 1.0\nend_header\n
text_called_ply|3|not a PLY file||a.ply|1 2 3\n
text_called_pdb|3|no ATOM or HETATM record||a.pdb|1 2 3\n
a_page_called_csv|3|an HTML page||a.csv|\n <!DOCTYPE html>\n<html>\n
another_xml|3|XML of a kind||a.csv|<?xml version="1.0"?><kml></kml>\n
json|3|JSON||a.json|{"points": [[1, 2]]}\n
an_archive|3|a ZIP archive||a.npz|PK\003\004abc
another_compression|3|compressed by xz; unpack it first||a.txt.xz|\3757zXZ\000
a_damaged_archive|3|compressed||a.gz|\037\213\010\000damaged
las|3|LAS or LAZ; convert it||a.las|LASF\000\000
cells|3|it has cells; the points are in the .node file||a.ele|1 3 0\n0 0 1 2\n
pieces|3|give one of these||a.pvtu|x
bytes_of_no_format|3|neither text nor of a known format||a.bin|\001\002\003\000
titles_alone|3|there is no point in the file||a.csv|x,y,z\n
words_alone|3|there is no point in the file||a.txt|once upon a time\n
counted_rows|3|the first column counts the rows: --columns 2-4||a.csv|1,5,5,5\n2,6,6,6\n3,7,9,9\n
counted_rows_before_three|3|the first column counts the rows: --columns 2-4||a.xyz|10 5 5 5\n11 6 6 6\n12 7 9 9\n
counted_rows_in_spite_of_dim|3|the first column counts the rows: --columns 2-3|--dim 2|a.txt|0 5 5\n1 6 6\n2 7 9\n
some_decimal_commas|3|decimal commas, or commas between numbers||a.txt|0,5 1\n
changing_commas|3|2: decimal commas, or commas between||a.txt|1,2\n1,5;2\n
thousands|3|'1.234' is not a number||a.csv|1.234,5;2\n
a_short_row_with_decimal_commas|3|2: 1 number where 2 are needed||a.csv|0,5;2\n1,5\n
a_count_that_is_wrong|3|3 points announced, but there are 2||a.txt|3\n1 2\n3 5\n
a_count_that_is_too_small|3|2 points announced, but there are 3||a.txt|2\n1 2\n3 5\n7 4\n
a_node_file_called_text|3|that of a .node file; rename it||a.txt|3 2 0\n1 0 0\n2 1 0\n3 0 1\n
a_first_row_in_brackets|3|1: '(0' is not a number||a.txt|(0 1)\n2 3\n
blanks_within_numbers|3|1: ';' is missing between two numbers, or a blank is within one||a.csv|1 000,5;2\n
more_atoms_than_announced|3|4: more than the announced atoms||a.xyz|1\n\nC 1 2 3\nC 4 5 6\n
a_word_behind_numbers|3|'C' is not a number; --columns lists the columns||a.txt|1 2 C\n
a_missing_name|3|2: the row has no name||a.txt|a 1 2\n3 4\n
a_missing_separator|3|2: ',' is missing between columns 1 and 2||a.csv|x,y,z\n1 2.5,3,4,5\n
words_and_numbers_before_named_rows|3|1: words and numbers before||a.txt|broken 1 x\nb 1 2\n
no_such_title|3|no column has the title 'q'|--columns x,q|a.csv|x,y\n1,2\n
too_few_columns|3|2: 2 columns where 3 are needed|--columns 1,3|a.csv|1,2,3\n4,5\n
an_empty_column|3|1: a number is missing|--columns 1,2|a.csv|1,,3\n
column_zero|2|numbered from 1|--columns 0|a.csv|1,2\n
a_reversed_range|2|FIRST-LAST|--columns 3-2|a.csv|1,2\n
ten_columns|2|at most 8 coordinates|--columns 1-10|a.csv|1,2\n
a_comma_at_the_end|2|missing beside a comma|--columns 1,|a.csv|1,2\n
columns_of_a_mesh|2|--columns is for text and .npy|--columns 1,2|a.obj|v 1 2 3\n
no_such_format|2|no such format|--format doc|a.csv|1,2\n
a_negative_radius|3|1: the radius -1 is negative|--radii|a.txt|1 2 -1\n
a_radius_too_large|3|is too large to be squared|--radii|a.txt|1 2 1e200\n
shifted_columns|3|the long serial number shifts the columns||a.pdb|ATOM  100000  N   ALA A   1    1007.51720 03.2583011.129  1.00 20.00           N\n
columns_that_run_together|3|columns 31 to 54 do not hold||a.pdb|ATOM      1  N   ALA A   1     1007.51722003.2583011.129  1.00 20.00           N\n
fields_that_run_together|3|8 fields where 10 or 11||a.pqr|ATOM 1 N ALA 1 1007.5172003.2583011.129 -0.3 2\n
a_missing_atom|3|3 atoms announced, but the file ends after 2||a.xyz|3\n\nC 1 2 3\nC 4 5 6\n
fractions_of_a_crystal|3|its coordinates are fractions||a.cif|data_1\nloop_\n_atom_site_label\n_atom_site_fract_x\nC1 0.5\n
a_tilted_box|3|scaled coordinates need a box||a.lammpstrj|ITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz\n0 4 0\n1 3 0\n-2 2 0\nITEM: ATOMS xs ys zs\n1 .5 .25\n
records|3|the array has records||a.npy|\223NUMPY\001\000\102\000{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (1, 2), }\n
a_short_stl|3|before endsolid||a.stl|solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n
no_stl|3|not an STL file||a.stl|\001\002\003
a_grid|3|a grid without points||a.vtk|# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n
short_vtk|3|the file ends within its||a.vtk|# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n1 2 3\n
a_huge_vtk|3|the file ends within its data||a.vtk|# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 9007199254740992 double\n1 2 3\n
a_huge_vtu|3|the file ends within its data||a.vtu|<VTKFile type="PolyData"><Piece NumberOfPoints="18446744073709551615"><Points></Piece></VTKFile>
lz4|3|compressed in a way that is not supported||a.vtu|<VTKFile type="PolyData" compressor="vtkLZ4DataCompressor"></VTKFile>
a_huge_pcd|3|the file ends within its data||a.pcd|VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 9007199254740992\nDATA binary\n1
an_old_msh|3|save it as 2.2 or 4.1||a.msh|$MeshFormat\n4 0 8\n$EndMeshFormat\n
no_weights_in_stl|3|no weights|--weights|a.stl|solid a\nendsolid a\n
utf16_cut_off|3|ends within a character||a.txt|\377\3761\000 
TABLE

# --- the tool: options, notes, and what it writes ---------------------------------------------------------------------------

tool=${PARADT_TOOL:-$root/build/paradt}
with() { # arguments of the tool
    "$tool" "$@" >out 2>err
    status=$?
}
if [ -x "$tool" ]; then
    with --quiet -o t.ele inputs/altloc.pdb
    [ $status -eq 0 ] && [ "$(sed -n 1p t.node)" = '7 3 0 0' ] && grep -q '^paradt: inputs/altloc.pdb: 2 alternate locations' err
    report $? the_tool_tells_what_it_left_out
    with --quiet --radii --columns 2-5 -o t.ele inputs/voropp.txt
    [ $status -eq 0 ] && [ "$(sed -n '1p;5p' t.node)" = "$(printf '4 3 1 0\n 3 0.5 0.5 1.5 0.0625')" ]
    report $? the_tool_takes_columns_and_radii
    "$tool" --quiet --format obj -o t.ele - <inputs/m.obj >out 2>err
    status=$?
    [ $status -eq 0 ] && [ "$(sed -n 1p t.node)" = '5 3 0 0' ]
    report $? the_tool_takes_any_format_from_standard_input
    with --columns 0 inputs/pts.dat
    [ $status -eq 2 ] && grep -q 'numbered from 1' err
    report $? the_tool_checks_columns_at_once
    with --format doc inputs/pts.dat
    [ $status -eq 2 ] && grep -q 'no such format' err
    report $? the_tool_checks_formats_at_once
    with --radii gen:uniform:10:1
    [ $status -eq 2 ] && grep -q 'no radii' err
    report $? generated_points_have_no_radii
    with --quiet --check -o t.stl -o t.vtk -o t.csv -o t.ele -o t.vtu gen:uniform:200:1
    tail -n +2 t.ele | cut -d' ' -f3- | tr ' ' , >due
    [ $status -eq 0 ] && [ "$(sed -n 1p t.csv)" = v0,v1,v2,v3 ] && tail -n +2 t.csv | cmp -s - due
    report $? cells_are_written_as_csv
    for file in t.vtk t.vtu t.stl; do
        ./read $file | tr ';' '\n' | sed '/^$/d' | sort >$file.points
    done
    comm -23 t.stl.points t.vtk.points >strange
    cmp -s t.vtk.points t.vtu.points && [ "$(wc -l <t.vtk.points)" -eq 200 ] && [ -s t.stl.points ] && [ ! -s strange ]
    report $? what_is_written_is_read_back_to_the_bit
    with --quiet --weights -o w.vtu -o w.vtk gen:uniform:50:1
    ./read --weights w.vtu | tr ';' '\n' | awk 'NF && NF != 4 { bad = 1 } END { exit bad }'
    report $? weights_are_read_back
    with --quiet --dim 4 -o t.stl gen:uniform:50:1
    [ $status -eq 2 ] && grep -q '.stl files hold at most 3 dimensions' err
    report $? a_surface_in_four_dimensions_is_refused
    for candidate in python3 /usr/bin/python3; do
        $candidate -c 'import meshio' >/dev/null 2>&1 || continue
        $candidate -c 'import meshio
cells = sum(len(c.data) for c in meshio.read("t.vtk").cells)
same = cells == sum(1 for line in open("t.csv")) - 1
with_weights = "weight" in meshio.read("w.vtk").point_data
closed = 2 * len(meshio.read("t.stl").points) - 4 == sum(len(c.data) for c in meshio.read("t.stl").cells)
assert same and with_weights and closed' >out 2>err
        report $? meshio_reads_what_is_written
        break
    done
else
    skip the_tool "build/paradt is not built"
fi

# --- the programs that write such files, and read them: meshio, VTK, gemmi and NumPy ----------------------------------------

python=
for candidate in python3 /usr/bin/python3; do
    [ -n "$python" ] || ! $candidate -c 'import numpy' >/dev/null 2>&1 || python=$candidate
done
for peer in numpy meshio vtk gemmi; do
    if [ -z "$python" ] || ! $python -c "import $(echo $peer | sed 's/vtk/vtkmodules/')" >/dev/null 2>&1; then
        skip "as_$peer" "python3-$peer is not installed"
        continue
    fi
    $python "$root/tests/programs/read_peers.py" $peer "$zlib" >lines 2>err
    status=$?
    while read -r verdict name; do
        [ "$verdict" = ok ]
        report $? "$name"
    done <lines
    [ $status -eq 0 ]
    report $? "as_${peer}_has_them"
done
plan
