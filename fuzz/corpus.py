#!/usr/bin/env python3
"""Writes the seeds of fuzz_triangulate.c to fuzz/corpus: python3 fuzz/corpus.py"""
import itertools
import os
import struct

LATTICE, ULPS, SCALED, RAW = range(4)
ONE, ZERO, SMALLEST_NORMAL, SUBNORMAL, LARGEST, _, _, INTEGERS_ONLY, TENTH, _ = range(10)  # parameters of ULPS
LARGE_STEPS = 3 << 5  # parameter of LATTICE: multiples of 2^40
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "corpus")


def seed(name, dim, encoding, numbers, weighted=False, copies=False, keep=False, uniform=False, regions=3, parameter=0,
         spoil=5, copied_axis=None, constant_axis=None):
    """Writes one seed.

    numbers: signed bytes for LATTICE and ULPS, pairs of signed bytes for SCALED, doubles or bit patterns for RAW.
    """
    flags = dim - 2 | encoding << 2 | weighted << 4 | copies << 5 | keep << 6 | uniform << 7
    flat = 0
    if copied_axis is not None:
        flat = 2 * copied_axis + 1
    if constant_axis is not None:
        flat = 2 * (constant_axis + dim)
    data = bytes([flags, regions - 1, parameter, spoil, flat])
    for number in numbers:
        if encoding == RAW:
            data += struct.pack("<Q", number) if isinstance(number, int) else struct.pack("<d", number)
        elif encoding == SCALED:
            data += struct.pack("<bb", *number)
        else:
            data += struct.pack("<b", number)
    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(data)


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


def main():
    os.makedirs(FOLDER, exist_ok=True)
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


if __name__ == "__main__":
    main()
