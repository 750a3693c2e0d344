#!/usr/bin/env python3
"""Writes the seeds of the harnesses to fuzz/corpus/NAME: python3 fuzz/corpus.py

Files that are named found_... are inputs that once showed a fault; they stay.
"""
import gzip
import itertools
import os
import struct

LATTICE, ULPS, SCALED, RAW = range(4)
ONE, ZERO, SMALLEST_NORMAL, SUBNORMAL, LARGEST, _, _, INTEGERS_ONLY, TENTH, _ = range(10)  # parameters of ULPS
LARGE_STEPS = 3 << 5  # parameter of LATTICE: multiples of 2^40
HERE = os.path.dirname(os.path.abspath(__file__))
FOLDER = os.path.join(HERE, "corpus")
POINTS = ["triangulate", "hull", "voronoi", "regions"]  # harnesses whose inputs are points


def write(harness, name, data):
    os.makedirs(os.path.join(FOLDER, harness), exist_ok=True)
    with open(os.path.join(FOLDER, harness, name), "wb") as file:
        file.write(data)


def encoded(encoding, numbers):
    """Returns the bytes of the numbers"""
    data = b""
    for number in numbers:
        if encoding == RAW:
            data += struct.pack("<Q", number) if isinstance(number, int) else struct.pack("<d", number)
        elif encoding == SCALED:
            data += struct.pack("<bb", *number)
        else:
            data += struct.pack("<b", number)
    return data


def seed(name, dim, encoding, numbers, weighted=False, copies=False, keep=False, uniform=False, regions=3, parameter=0,
         spoil=5, copied_axis=None, constant_axis=None):
    """Writes one seed. What a fuzzer does with it depends on the name.

    numbers: signed bytes for LATTICE and ULPS, pairs of signed bytes for SCALED, doubles or bit patterns for RAW.
    """
    flags = dim - 2 | encoding << 2 | weighted << 4 | copies << 5 | keep << 6 | uniform << 7
    flat = 0
    if copied_axis is not None:
        flat = 2 * copied_axis + 1
    if constant_axis is not None:
        flat = 2 * (constant_axis + dim)
    choice = sum(name.encode()) % 29
    data = bytes([flags, regions - 1 + 9 * choice, parameter, spoil, flat]) + encoded(encoding, numbers)
    for harness in POINTS:
        if harness == "regions":  # the call, then its options; which of them, the name decides
            number = sum(name.encode())
            call = bytes([number % 7, 255 - number % 11 * 20, number % 5 * 51, 255 - number % 4 * 60])
            write(harness, name, data[:3] + bytes([number % 256]) + data[4:5] + call + data[5:])
        elif harness == "hull" and weighted:
            continue
        elif harness == "voronoi" and (dim == 5 or keep):
            continue
        else:
            write(harness, name, data)


def listed(points):
    return [x for point in points for x in point]


def lattice(side, dim):
    return list(itertools.product(range(side), repeat=dim))


def cross(dim, size):
    points = []
    for axis in range(dim):
        for sign in (-size, size):
            points.append(tuple(sign if i == axis else 0 for i in range(dim)))
    return points


def signs_and_orders(*coordinates):
    points = set()
    for order in itertools.permutations(coordinates):
        for sign in itertools.product((-1, 1), repeat=len(order)):
            points.add(tuple(s * x for s, x in zip(sign, order)))
    return sorted(points)


def scattered(count, spread=251, start=7):
    """Returns pseudo-random signed bytes from -(spread // 2) on."""
    numbers, x = [], start
    for _ in range(count):
        x = (x * 1103515245 + 12345) & 0x7fffffff
        numbers.append((x >> 16) % spread - spread // 2)
    return numbers


def points():
    # few points
    seed("no_points_3d", 3, LATTICE, [])
    seed("one_point_4d", 4, LATTICE, [1, 2, 3, 4])
    seed("two_points_2d", 2, LATTICE, [1, 2, 3, 4])
    seed("all_equal_3d", 3, LATTICE, [5, 5, 5] * 6)
    seed("all_equal_weighted_2d", 2, LATTICE, [5, 5, 1, 5, 5, 3, 5, 5, 3, 5, 5, 0], weighted=True)
    # lower affine dimension
    seed("collinear_2d", 2, LATTICE, listed((3 * t, 5 * t) for t in (0, 4, 1, 3, 9, 2)))
    seed("collinear_in_4d", 4, LATTICE, listed((7, t, -t, 2 * t) for t in (0, 4, 1, 3, 9, 2)))
    seed("coplanar_grid_in_3d", 3, LATTICE, listed((2, x, x + y) for x, y in lattice(4, 2)))
    seed("flat_of_2_in_5d", 5, LATTICE, listed((1, x, y, x + y, x - y) for x, y in lattice(4, 2)))
    seed("coplanar_weighted_in_3d", 3, LATTICE, listed((x, y, x + 2 * y, x * y % 3) for x, y in lattice(4, 2)),
         weighted=True)
    seed("nearly_collinear_in_a_plane_3d", 3, RAW, listed((1.0, i * 0.1, i * 0.1 * 3.3) for i in range(12)),
         constant_axis=0)
    seed("ulps_in_a_plane_3d", 3, ULPS, scattered(90, 5), parameter=TENTH, copied_axis=2)
    seed("ulps_in_a_hyperplane_4d", 4, ULPS, scattered(64, 5), parameter=ONE, constant_axis=1)
    seed("scaled_in_a_plane_3d", 3, SCALED, list(zip(scattered(60), scattered(60, 61, 3))), copied_axis=0)
    seed("large_lattice_in_a_hyperplane_4d", 4, LATTICE, scattered(80), parameter=LARGE_STEPS | 4, copied_axis=3)
    # ties
    seed("grid_2d", 2, LATTICE, listed(lattice(6, 2)), regions=4)
    seed("grid_3d", 3, LATTICE, listed(lattice(3, 3)), regions=5, uniform=True)
    seed("cube_with_centre_3d", 3, LATTICE,
         [1, 1, 1] + listed((2 * x, 2 * y, 2 * z) for x, y, z in lattice(2, 3)))
    seed("cube_4d", 4, LATTICE, listed(lattice(2, 4)), regions=2)
    seed("half_cube_5d", 5, LATTICE, listed(p for p in lattice(2, 5) if sum(p) % 2 == 0))
    seed("cross_polytope_4d", 4, LATTICE, listed(cross(4, 3)) + [0, 0, 0, 0])
    seed("sphere_of_radius_9_3d", 3, LATTICE, listed((signs_and_orders(4, 4, 7) + signs_and_orders(0, 0, 9))[:40]))
    seed("circle_of_radius_65_2d", 2, LATTICE,
         listed(p for sides in ((16, 63), (33, 56), (25, 60), (39, 52)) for p in signs_and_orders(*sides)))
    seed("face_centred_3d", 3, LATTICE, listed(p for p in lattice(4, 3) if sum(p) % 2 == 0))
    seed("surface_of_a_cube_3d", 3, LATTICE, listed(p for p in lattice(4, 3) if 0 in p or 3 in p), regions=8)
    seed("prism_3d", 3, LATTICE,
         listed((x, y, z) for x, y in signs_and_orders(3, 4) + signs_and_orders(0, 5) for z in (0, 1, 4)))
    seed("small_lattice_with_copies_3d", 3, LATTICE, scattered(160), parameter=2, copies=True)
    # general position
    seed("scattered_2d", 2, LATTICE, scattered(120), regions=9)
    seed("scattered_5d", 5, LATTICE, scattered(60), uniform=True)
    # weights
    seed("weighted_grid_3d", 3, LATTICE, listed((x, y, z, (x * y + z) % 3) for x, y, z in lattice(3, 3)), weighted=True)
    seed("weighted_with_hidden_2d", 2, LATTICE, scattered(180, 61), weighted=True, regions=4)
    seed("weighted_with_copies_4d", 4, LATTICE, scattered(110, 9), weighted=True, copies=True)
    # points close together, far apart, at the ends of the range of doubles
    seed("ulps_at_one_3d", 3, ULPS, scattered(100, 7), parameter=ONE)
    seed("ulps_at_one_weighted_2d", 2, ULPS, scattered(100, 5), parameter=ONE, weighted=True)
    seed("ulps_at_a_tenth_4d", 4, ULPS, scattered(64, 5), parameter=TENTH)
    seed("ulps_at_zero_3d", 3, ULPS, scattered(90, 9), parameter=ZERO)
    seed("ulps_at_the_smallest_normal_2d", 2, ULPS, scattered(90, 15), parameter=SMALLEST_NORMAL)
    seed("ulps_at_the_largest_3d", 3, ULPS, scattered(90, 9), parameter=LARGEST)
    seed("scaled_2d", 2, SCALED, list(zip(scattered(60), scattered(60, 251, 3))))
    seed("scaled_3d", 3, SCALED, list(zip(scattered(60), scattered(60, 61, 3))))
    seed("scaled_weighted_3d", 3, SCALED, list(zip(scattered(64), scattered(64, 31, 3))), weighted=True)
    # any doubles
    seed("raw_3d", 3, RAW, [x / 256 for x in scattered(60)])
    seed("raw_largest_2d", 2, RAW, [x * 1.4e306 for x in scattered(40)])
    seed("raw_negative_zero_2d", 2, RAW, [0.0, -0.0, -0.0, 0.0, 1.0, -0.0, 0.0, 1.0, -0.0, -1.0])
    seed("raw_any_bits_4d", 4, RAW, [(x * 0x9e3779b97f4a7c15) % 2**64 for x in range(1, 41)])
    seed("raw_nan_3d", 3, RAW, [1.0, 2.0, 3.0, 4.0, 0x7ff8000000000001, 5.0, float("inf"), 1.0, 2.0], keep=True)
    seed("raw_infinite_weight_2d", 2, RAW, [1.0, 2.0, 0.0, 3.0, 4.0, float("-inf")], keep=True, weighted=True)


def predicate(name, dim, encoding, numbers, parameter=0, mode=0, floats=False, swap=0x21, measures=True, made=0, which=0):
    """Writes a seed of fuzz_predicates.c. numbers: of each of dim + 2 points the coordinates and the weight"""
    data = bytes([dim - 2 | encoding << 3 | floats << 5 | mode << 6, parameter, swap, measures | made << 1 | which << 3])
    data += encoded(encoding, numbers)
    write("predicates", name, data)


def predicates():
    for dim in range(2, 9):
        corners = [p + (0,) for p in lattice(2, dim)][:dim + 2]
        predicate("corners_of_a_cube_%dd" % dim, dim, LATTICE, listed(corners), measures=dim < 6)
        predicate("cross_%dd" % dim, dim, LATTICE, listed(p + (1,) for p in cross(dim, 5)[:dim + 2]), measures=dim < 6)
        predicate("ulps_at_one_%dd" % dim, dim, ULPS, scattered((dim + 1) * (dim + 2), 5), parameter=ONE, mode=dim % 4,
                  measures=dim < 6)
        predicate("means_%dd" % dim, dim, LATTICE, scattered((dim + 1) * (dim + 2)), made=1, which=dim, measures=dim < 6)
        predicate("mirrored_%dd" % dim, dim, LATTICE, scattered((dim + 1) * (dim + 2)), made=3, which=dim + 1, mode=1,
                  measures=dim < 6)
        predicate("floats_%dd" % dim, dim, LATTICE, scattered((dim + 1) * (dim + 2), 7), parameter=1 << 5, floats=True,
                  measures=dim < 6)
    for dim in (2, 3, 4):
        numbers = scattered((dim + 1) * (dim + 2))
        predicate("scaled_%dd" % dim, dim, SCALED, list(zip(numbers, scattered(len(numbers), 61, 3))), mode=2)
        predicate("raw_%dd" % dim, dim, RAW, [x / 10 for x in numbers], mode=3)
        predicate("any_bits_%dd" % dim, dim, RAW, [(x * 0x9e3779b97f4a7c15) % 2**64 for x in range(1, len(numbers) + 1)])
        predicate("subnormal_%dd" % dim, dim, ULPS, scattered(len(numbers), 5), parameter=ZERO)
        predicate("largest_%dd" % dim, dim, ULPS, scattered(len(numbers), 5), parameter=LARGEST, mode=1)
    nearly = [float.fromhex(x) for x in (
        "-0x1.24f1928ad4edfp-1", "0x1.54488f0729af1p-1", "0", "0x1.3eb839b990a1ap-1", "-0x1.28b6ffd14fa38p-1", "0",
        "-0x1.b4d51578b336fp+0", "0x1.d88768d77bd75p+0", "0", "0", "0", "0")]
    predicate("nearly_collinear_upward_2d", 2, RAW, nearly, mode=1)
    circle = [p + (0,) for p in signs_and_orders(16, 63)]
    predicate("on_a_circle_2d", 2, LATTICE, listed(circle[:4]))
    predicate("on_a_sphere_3d", 3, LATTICE, listed(p + (0,) for p in signs_and_orders(4, 4, 7)[:5]))
    predicate("coplanar_but_one_3d", 3, RAW, listed((x, y, z, 0.0) for x, y, z in (
        (0.1, 0.2, 0.0), (0.7, 0.3, 0.0), (0.4, 0.9, 0.0), (0.5, 0.5, 2.0**-100), (0.3, 0.3, 0.0))))


REMOVE, INSERT, MOVE, REMOVE_MANY, INSERT_MANY, MOVE_MANY, ASK = range(7)
WALK, TREE, FLIPS = range(3)  # how points are located


def living(name, dim, encoding, first, operations, weighted=False, parameter=0, flat=0, method=WALK):
    """Writes a seed of fuzz_living.c. first: the first points; operations: (kind, flags, bytes)"""
    count = len(first)
    data = bytes([dim - 2 | encoding << 2 | weighted << 4 | count << 5, parameter, flat | method << 3])
    data += struct.pack("<%db" % len(listed(first)), *listed(first)) + bytes([255])
    for kind, flags, more in operations:
        data += bytes([kind | flags]) + bytes(x % 256 for x in more)
    write("living", name, data)


def livings():
    for dim in (2, 3, 4):
        grid = [p for p in lattice(3, dim)]
        come = [(INSERT, 0, (0,) + p) for p in grid[7:30]]
        go = [(REMOVE, 0, (i * 5,)) for i in range(9)]
        walk = [(MOVE, 0, (i * 7,) + grid[i * 5 % len(grid)]) for i in range(9)]
        ask = [(ASK, 0, (i,) + grid[i % len(grid)]) for i in range(6)]
        living("lattice_%dd" % dim, dim, LATTICE, grid[:7], come[:20] + ask + walk + go)
        living("lattice_with_failures_%dd" % dim, dim, LATTICE, grid[:7],
               [(k, 8, (m[0], i) + m[1:]) for i, (k, _, m) in enumerate(come[:20])] + walk + go)
        living("scattered_%dd" % dim, dim, LATTICE, [],
               [(INSERT, 0, (0,) + tuple(scattered(dim, 251, i + 1))) for i in range(25)] + ask + walk + go)
        living("batches_%dd" % dim, dim, LATTICE, grid[:7],
               [(INSERT_MANY, 7 << 5, tuple(listed((i,) + p for i, p in enumerate(grid[:8])))),
                (MOVE_MANY, 7 << 5, tuple(listed((i * 3,) + p for i, p in enumerate(grid[1:9])))),
                (REMOVE_MANY, 7 << 5, tuple(listed((i * 2,) + p for i, p in enumerate(grid[:8]))))] + ask)
        living("flat_then_not_%dd" % dim, dim, LATTICE, grid[:6],
               [(INSERT, 0, (0,) + p) for p in grid[6:9]] + [(INSERT, 16, (0,) + (9,) * dim)] + ask + go, flat=1)
        living("ulps_%dd" % dim, dim, ULPS, [], [(INSERT, 0, (0,) + tuple(scattered(dim, 5, i + 1))) for i in range(25)] + walk,
               parameter=ONE)
        weighty = [(INSERT, 0, (0,) + p + (i % 3,)) for i, p in enumerate(grid[:24])]
        living("weighted_%dd" % dim, dim, LATTICE, [], weighty + [(MOVE, 0, (i,) + grid[i] + (9 * i,)) for i in range(8)] + go,
               weighted=True)
        for name, method in (("tree", TREE), ("flips", FLIPS)):
            some = tuple(listed((i,) + p for i, p in enumerate(grid[:8])))
            living("by_%s_%dd" % (name, dim), dim, LATTICE, grid[:7],
                   come[:12] + ask + [(INSERT_MANY, 7 << 5, some), walk[0], go[0], (MOVE_MANY, 32, some[:2 * dim + 2])] +
                   [(INSERT, 8, (0, i) + p) for i, p in enumerate(grid[1:9])] + ask, method=method)
            living("by_%s_weighted_%dd" % (name, dim), dim, LATTICE, [], weighty + ask, weighted=True, method=method)
            living("by_%s_out_of_a_flat_%dd" % (name, dim), dim, ULPS, grid[:5],
                   come[:5] + [(INSERT, 16, (0,) + tuple(scattered(dim, 5, i + 1))) for i in range(12)], parameter=ONE,
                   flat=1, method=method)


def readers():
    """Files of every format, small: those of the tests, and some more"""
    inputs = os.path.join(HERE, "..", "tests", "inputs")
    # must be the order of paradt_io_inputs; the harness takes any number, so that a wrong one costs no more than a seed
    for number, name in enumerate(sorted(os.listdir(inputs))):
        with open(os.path.join(inputs, name), "rb") as file:
            data = file.read()
        if len(data) < 6000:
            write("readers", name.replace(".", "_"), bytes([255, number % 3 * 16]) + data)
    more = {
        "text": b"# points\n0 0 0\n1.5,2;3\n-1e3 0x1p3 .5\n",
        "titles": b"id;X;y;Z;r\n1;0,5;1;2;3\n2;1;1,25;0;1\n",
        "node": b"4 2 1 1\n1 0 0 5 0\n2 1 0 5 0\n3 0 1 5 1\n4 1 1 5 1\n",
        "off": b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n",
        "noff": b"nOFF\n4\n2 0 0\n0 0 0 0\n1 0 0 1\n",
        "ply": b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty double y\nproperty int z\n"
               b"property float radius\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
               b"0 0 0 1\n1 2 3 2\n3 0 1 0\n",
        "ply_big": b"ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty"
                   b" float z\nend_header\n" + struct.pack(">6f", 0, 1, 2, 3, 4, 5),
        "npy": b"\x93NUMPY\x01\x00v\x00" + (b"{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }".ljust(117) +
                                             b"\n") + struct.pack("<6d", 0, 1, 2, 3, 4, 5),
        "npy_half": b"\x93NUMPY\x01\x00v\x00" + (b"{'descr': '>f2', 'fortran_order': True, 'shape': (2, 2), }".ljust(117) +
                                                  b"\n") + struct.pack(">4e", 0, 1, 2, 3),
        "pdb": b"ATOM      1  CA AALA A   1      11.104   6.134  -6.504  0.50  0.00           C\n"
               b"HETATM    2  O   HOH A   2       1.000   2.000   3.000  1.00  0.00           O\nEND\n",
        "pqr": b"ATOM 1 N ALA 1 1.0 2.0 3.0 0.1 1.85\nATOM 2 C ALA 1 2.0 2.0 3.0 0.1 1.7\n",
        "cif": b"data_x\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
               b"_atom_site.Cartn_z\nATOM C 1 2 3\nATOM 'N' 2 3 4\n#\n",
        "msh2": b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0\n2 1 1 1\n$EndNodes\n",
        "msh4": b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 2 1 2\n2 1 0 2\n1\n2\n0 0 0\n1 1 1\n$EndNodes\n",
        "stl_binary": b"binary".ljust(80) + struct.pack("<I12fH", 1, *range(12), 0),
        "pcd_binary": b"VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                      b"DATA binary\n" + struct.pack("<3f", 1, 2, 3),
        "vtk_binary": b"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS 2 float\n" +
                      struct.pack(">6f", 0, 1, 2, 3, 4, 5) + b"\n",
        "vtu_ascii": b"<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece NumberOfPoints='1'><Points><DataArray type="
                     b"'Float32' NumberOfComponents='3' format='ascii'>1 2 3</DataArray></Points></Piece></UnstructuredGrid>"
                     b"</VTKFile>",
        "xyz": b"2\ncomment\nC 0 0 0\nO 1 0 0.5\n2\n\nC 0 0 0\nO 1 0 0.5\n",
        "extxyz": b'1\nLattice="1 0 0 0 1 0 0 0 1" Properties=species:S:1:pos:R:3:radius:R:1\nC 0 0 0 1.5\n',
        "obj": b"# o\nv 0 0 0\nv 1 2 3 0.5\nvn 0 0 1\nf 1 2 1\n",
        "mesh": b"MeshVersionFormatted 2\nDimension 3\nVertices\n2\n0 0 0 1\n1 1 1 1\nEnd\n",
        "utf16": "1 2 3\n4 5 6\n".encode("utf-16"),
        "bom": b"\xef\xbb\xbf1 2\n3 4\n",
        "html": b"<!DOCTYPE html><html><body>404</body></html>\n",
        "empty": b"",
        "gzip": gzip.compress(b"1 2 3\n4 5 6\n", mtime=0),
    }
    for number, (name, data) in enumerate(more.items()):
        write("readers", name, bytes([255, 0]) + data)
        if number % 2:
            write("readers", name + "_forced", bytes([number, 0x33 if number % 4 == 1 else 0xc0]) + data)


if __name__ == "__main__":
    points()
    predicates()
    livings()
    readers()
