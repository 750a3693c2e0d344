// paradt.h - v0.1.0 - exact Delaunay and regular triangulations in 2 to 8 dimensions - public domain or MIT-0
//
// DO THIS in one C or C++ file of the program, and include the header without the define in all others:
//
//     #define PARADT_IMPLEMENTATION
//     #include "paradt.h"
//
// A whole program, in C or C++. It triangulates the corners of a cube and prints the cells, the indices of four points
// a line:
//
//     #define PARADT_IMPLEMENTATION
//     #include "paradt.h"
//     #include <stdio.h>
//
//     int main(void) {
//         const double corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
//                                       {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
//         paradt_points points = paradt_points_f64(corners[0], 8, 3);
//         paradt_triangulation t;
//         if (paradt_triangulate(&t, &points, NULL) != PARADT_OK)
//             return 1;
//         const size_t k = (size_t)(t.dim + 1); // 4; fewer where all points lie in a plane
//         for (size_t c = 0; c < t.cell_count; c++)
//             for (size_t j = 0; j < k; j++)
//                 printf("%d%c", (int)t.cells[c * k + j], j + 1 < k ? ' ' : '\n');
//         paradt_free(&t);
//         return 0;
//     }
//
//     cc -O2 -o cube cube.c -lm && ./cube
//
// There is nothing else to build, and nothing to link but the C library (-lm where that has its mathematics apart).
//
// MACROS, to be defined before the header is included
//
//     PARADT_IMPLEMENTATION  in one file: the functions as well as their declarations
//     PARADT_STATIC          makes the functions private to this file. Define it with PARADT_IMPLEMENTATION before the
//                            first include; several files may
//     PARADT_DEF             what stands before each public function; extern, or static with PARADT_STATIC
//     PARADT_INDEX64         indices of points and cells have 64 bits, not 32. Define it in all files of a program or
//                            in none: the functions have other names with it, so the linker refuses files that
//                            disagree. Insertion has no code for SSE2 and AVX2 then
//     PARADT_MAX_DIM         the largest dimension, 2 to 8; code for larger ones is not compiled. The same in all files
//     PARADT_ASSERT(c)       checks of the code's own invariants, never of your data; nothing, or as you define it
//     PARADT_NO_FRONTS       leaves out InCoDe and DeWall, a tenth of the compiled code; PARADT_AUTO inserts in all
//                            dimensions, and the other two are PARADT_ERROR_ARGUMENT
//     PARADT_NO_CHECK        leaves out paradt_check
//     PARADT_NO_REGIONS      leaves out divided space: all points are one region, whatever options.regions asks for.
//                            Not with paradt_mpi.h
//     PARADT_NO_FLIPS        leaves out PARADT_FLIP and paradt_repair
//     PARADT_NO_SIMD         no code for SSE2, and no second copy of the inner loops for processors with AVX2 and FMA
//                            (x86-64, GCC or Clang). The compiler may still use instructions that its flags allow
//
// WHAT IT DOES
//
//     - Delaunay triangulations, and with weights regular triangulations, of points in 2 to 8 dimensions
//     - exact for all finite doubles and floats: huge, subnormal, mixed, collinear, coplanar, cospherical, repeated
//     - one result: the same points give the same set of cells by every method, with any number of regions and threads,
//       in any order, with any compiler and its flags
//     - cells with orientation and neighbours; for each point the one that stands for it when points coincide
//     - divided into regions that are built alone, on threads that the program provides
//     - a certificate: paradt_check proves that a result is the triangulation of its points, or says what is wrong
//     - no global state, no threads of its own, no output, no exit; memory from your allocator, within your limit
//     - C99 and C++11
//
// CONTENTS
//
//     points, options, result, walking, methods, regions and threads, degenerate input, numbers and compiler flags,
//     memory, errors, cost, limits, the thesis, credits, changes; the declarations; the implementation in sections
//     marked "// >>name"; the licence
//
//
// POINTS
//
// paradt_points describes an array of yours. It is read during a call only, and never written. paradt_points_f64 and
// paradt_points_f32 fill it for packed arrays of doubles and floats; its fields allow more. The coordinates of a point
// are adjacent and of the type `scalar`. `stride` bytes lead from one point to the next, so points may be members of
// larger structures. No alignment is needed. A mesh whose vertices begin with their position:
//
//     struct vertex { float position[3], normal[3], uv[2]; } mesh[1000];
//     paradt_points points = paradt_points_f32(mesh[0].position, 1000, 3);
//     points.stride = sizeof(struct vertex);
//
// Weights make the triangulation regular (also called weighted Delaunay, or the dual of a power diagram): a point of
// weight w is a sphere of radius sqrt(w), and distance is power distance, |x - p|^2 - w. So a sphere of radius r has
// the weight r * r. Weights may be negative. Adding the same number to all weights changes nothing; where all are equal
// the triangulation is Delaunay. Weights have a type and a stride of their own:
//
//     struct atom { double place[3]; float radius, weight; } atoms[1000];
//     paradt_points points = paradt_points_f64(atoms[0].place, 1000, 3);
//     points.stride = points.weight_stride = sizeof(struct atom);
//     points.weights = &atoms[0].weight;
//     points.weight_scalar = PARADT_F32;
//
// Coordinates and weights must be finite. -0.0 is the same as 0.0.
//
//
// OPTIONS
//
// NULL, or all fields zero, is the default: the method that suits the input, one region, the calling thread, malloc.
// Set what you need and leave the rest zero. Then fields that later versions add do not surprise you:
//
//     paradt_options options = {0}; // in C++: = {}
//     options.method = PARADT_DEWALL;
//     options.memory_limit = (size_t)1 << 30;
//
// `progress` is called now and then with the part of the call's work that is done, as far as that can be foretold: one
// number from 0 to 1 for all regions and threads, which never falls and ends at 1. Returning nonzero cancels the work:
// the call ends with PARADT_ERROR_CANCELLED within some hundredths of a second and gives back all memory. Any thread
// that works may call `progress`, but never two threads concurrently. (Compilers without atomic operations: only the
// first task of a parallel_for does.)
//
//
// RESULT
//
// cells[i] is dim + 1 indices into your points; neighbors[i][j] is the cell on the other side of the facet opposite the
// vertex cells[i][j], or -1 where that facet is on the hull. As plain arrays, with k = t.dim + 1:
//
//     t.cells[i * k + j]        vertex j of cell i
//     t.neighbors[i * k + j]    the cell opposite that vertex
//     t.representative[p]       p itself if it is a vertex, else the vertex at the same place; -1 if p is hidden
//
// Every cell is positively oriented: the determinant of (v1 - v0, v2 - v0, ...) is positive. So triangles run
// counterclockwise, and so does the triangle v0 v1 v2 of a tetrahedron when seen from v3, in right-handed coordinates.
// The facets of a cell, in the order that is counterclockwise when seen from outside the cell (for a triangle: with the
// triangle on the left):
//
//     opposite     v0          v1          v2          v3
//     triangle     v1 v2       v2 v0       v0 v1
//     tetrahedron  v1 v2 v3    v0 v3 v2    v0 v1 v3    v0 v2 v1
//
// Neighbours have all vertices but one in common. The order of the cells means nothing, and neither does the order of a
// cell's vertices apart from the orientation: both may differ between methods, machines and versions. The set of cells
// never differs; paradt_hash is equal for equal sets.
//
// With PARADT_FACETS in options.flags, neighbors hold half-facets: the position in `neighbors` of the same facet as its
// other cell sees it. Position f = i * k + j is the facet of cell f / k opposite its vertex f % k. With
// g = t.neighbors[f]:
//
//     g < 0             the facet is on the hull (g is -1); otherwise
//     g / k             the cell on the other side
//     t.cells[g]        the vertex of that cell that is not in the facet
//     t.neighbors[g]    f
//
// So programs that go from cell to cell, or around a ridge, need not search for the way back.
//
// In dimension 0 a cell is a single vertex and has no facets: neighbors is NULL and stats.hull_facets is 0.
//
// t.stats counts what was done, also when the call fails. Give the arrays back with paradt_free, not with free.
//
//
// WALKING
//
// To find the cell that contains a place x, walk: start in any cell, best in one nearby, and cross a facet that has x
// on its other side, until there is none. The orientation of the cell with x in the place of vertex j tells: negative
// means that x is beyond the facet opposite that vertex. For tetrahedra, with double points[][3]:
//
//     paradt_index walk(const paradt_triangulation *t, const double (*points)[3], const double *x, paradt_index cell) {
//         int j = 0;
//         while (cell >= 0 && j < 4) {
//             const double *p[4];
//             for (j = 0; j < 4; j++)
//                 p[j] = points[t->cells[4 * cell + j]];
//             for (j = 0; j < 4; j++) {
//                 const double *vertex = p[j];
//                 p[j] = x;
//                 if (paradt_orient3(p[0], p[1], p[2], p[3]) < 0)
//                     break; // x is beyond the facet opposite vertex j
//                 p[j] = vertex;
//             }
//             if (j < 4)
//                 cell = t->neighbors[4 * cell + j];
//         }
//         return cell; // -1: x is outside of the hull
//     }
//
// The walk ends, whichever of the facets it crosses: lift the points to the height |x|^2 - w, and take the planes of
// the cells at the place x. The lifted cells are a convex surface, so each facet crossed leads to a plane that is
// higher there, and no cell comes twice (Edelsbrunner 1990; ties are broken as under DEGENERATE INPUT). That needs
// exact signs and a Delaunay or regular triangulation: a walk with rounded signs, or in other triangulations, may go in
// circles.
//
//
// METHODS
//
//     PARADT_AUTO           the one that suits the input: Bowyer-Watson in two and three dimensions; in more, InCoDe,
//                           and Bowyer-Watson where InCoDe gets stuck in ties, as on lattices
//     PARADT_INCODE         incremental construction: from a first cell, the neighbour across every facet without one
//     PARADT_DEWALL         divide and conquer, merge first: the wall of cells across a plane, then each side of it
//     PARADT_BOWYER_WATSON  insertion of one point after the other: cells whose sphere contains the new point are
//                           replaced by cells that join it to the hole's boundary
//
// All give the same cells; they differ in time and memory. InCoDe and DeWall find the cell across a facet by a search
// in a hierarchical grid of the points, and never change a cell once it is made.
//
//
// REGIONS AND THREADS
//
// options.regions = k divides space into k boxes. Each box is built alone, each cell is owned by one box, and the owned
// cells are put together and linked across the seams. Cells near a seam are made by several regions and kept by one:
// stats.cells_recomputed were made in vain, so (cells + cells_recomputed) / cells is the factor of duplication, which
// is the price of the division.
//
//     PARADT_BISECTION  boxes of equal numbers of points, estimated from a sample: each box is cut across the longest
//                       side of its points
//     PARADT_UNIFORM    boxes of equal size: the bounding box is cut into equal parts
//
// The header starts no threads. To work on the regions concurrently, hand in a parallel_for: a function that runs
// task(context, i) for all i below count, on any threads and in any order, and returns when all have ended. With
// OpenMP:
//
//     void parallel_for(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
//         long i;
//         (void)user;
//         #pragma omp parallel for schedule(dynamic)
//         for (i = 0; i < (long)count; i++) task(context, (size_t)i);
//     }
//
// examples/paradt.c has one for POSIX threads. Its threads call the allocator concurrently, and the progress callback
// one at a time. parallel_for is called some ten times, for large sets up to forty times: insertion proceeds in legs,
// and between two legs regions move from slow threads to fast ones. Near surfaces, where regions exchange what they
// lack, it is called some dozens of times more. One region a thread is right where the points are alike everywhere; a
// few more even out regions that take longer. The cells depend neither on the regions nor on the threads.
//
// Insertion abandons the division where regions would have to ask each other for longer than all the rest takes: among
// points exactly on a sphere, or almost on a line. One region then takes in the points of the others, and stats.regions
// is 1.
//
// Any number of calls may run concurrently on any threads, each with its own result. They may share points.
//
//
// DEGENERATE INPUT
//
// Ties. The Delaunay triangulation is the lower hull of the points lifted to the height |x|^2 - w. Where an empty
// sphere has more points on it than a cell has vertices there are several such triangulations, and one is chosen: all
// heights are raised by infinitesimal amounts, the height of a lexicographically larger point (by x, then y, ...) by
// infinitely more than that of a smaller one. Only heights move, never places: no cell is flat, and the hull is that of
// the points. With s the exact in-sphere test, the point q is in conflict with the positively oriented cell p0..pd when
//
//     s > 0 (inside), or s = 0 and, going through p0..pd and q from the lexicographically largest downward:
//         q:  no conflict
//         pi: let o be the orientation of the cell with q in the place of pi;
//             o > 0: conflict, o < 0: no conflict, o = 0: go on
//
// and the triangulation is the set of cells that no point is in conflict with. The rule looks at places and weights
// only, at no index and no history, so whoever applies it decides alike. Weights play no part in the order.
// paradt_insphere_perturbed is this test. (The rule of Devillers and Teillaud, in every dimension.)
//
// Equal points are one vertex. The point of the smallest index stands for it; with weights the point of the largest
// weight, and among these of the smallest index. stats.duplicates counts the others, and `representative` says who
// stands for each.
//
// Hidden points. A weighted point may be a vertex of no cell; it and its duplicates have the representative -1.
// stats.hidden counts places, not duplicates.
//
// Lower dimensions. Points in a line, plane or flat of dimension k < d are triangulated within it: t.dim is k and cells
// have k + 1 vertices. Their orientation is that of the first k axes in which the flat has its full dimension. One
// point, or many at one place, give t.dim = 0 and one cell of one vertex; no points give t.dim = -1 and no cell. None
// of these is an error, so read cells in rows of t.dim + 1. A program that has no use for lower dimensions sets
// PARADT_FULL_DIM in options.flags: then such points give PARADT_ERROR_FLAT, and after PARADT_OK t.dim is d.
//
//
// NUMBERS AND COMPILER FLAGS
//
// Every decision is the sign of a determinant. A floating-point filter settles nearly all of them. Its error bound
// holds for any order of the operations, fused or not, in any rounding mode, with x87 registers, and with subnormals
// flushed to zero; the filter is not used where the input's exponents could make it overflow. What it leaves open is
// computed in integers, from the bits of the doubles, in three stages: small integers, a fixed number of words, any
// number of words. So -O3, -Ofast, -ffast-math, -march=native, -m32 and a changed rounding mode change the time, not
// the cells. Floats are widened exactly.
//
// Coordinates of lattices have few bits: there the filter or small integers settle even ties.
//
//
// MEMORY
//
// All memory comes from options.allocator (malloc and free when its functions are NULL; give both or neither). Blocks
// must be aligned as those of malloc; the allocator returns NULL when there is no more. Where a parallel_for uses
// several threads, the allocator must be safe to call concurrently. It has to live as long as the result, which keeps a
// copy of it for paradt_free.
//
// Huge pages are left to you: an allocator that asks for them takes a tenth off the time of large sets where the system
// has them ready, and adds a third on a virtual machine whose host has to provide them first. On Linux from 5.14 on,
// small pages are made somewhat ahead of their use, by madvise.
//
// The result takes (2 cells (dim + 1) + points) indices, with PARADT_NO_NEIGHBORS (cells (dim + 1) + points). The
// arrays may be up to a third larger than that, with regions up to a half, and for a few hundred points some kilobytes
// larger.
//
// memory_limit bounds the bytes that one call holds at any time, the result included. Regions get equal shares of what
// the points leave of it, so the more regions, the sooner the limit is reached. stats.peak_bytes is the most that was
// held (with regions an upper bound: the sum of their peaks).
//
// With PARADT_NO_NEIGHBORS, insertion in two and three dimensions builds regions one after another unless they run
// concurrently: as many as were asked for, or five from 500,000 points on. Each gives its links back before the next
// begins. That takes a third off the memory, and adds a tenth to a fifth to the time, a third to a half where points
// crowd as in a star cluster.
//
// paradt_memory_estimate says beforehand about how much a call will hold. Measured on uniform points, in bytes a point:
//
//                                       2D, 100,000    3D, 200,000    4D, 5,000    5D, 2,000
//     PARADT_AUTO                                79            295        1,390        7,280
//        2 regions                               90            327        2,740       14,560
//        4 regions                               92            376        2,720       16,570
//        8 regions                               95            420        2,800       21,640
//     PARADT_INCODE                             109            295        1,390        7,280
//        8 regions                              146            550        2,800       21,640
//     PARADT_NO_NEIGHBORS, 8 regions,
//        one after another                       68            225
//
// A call, compiled with optimisation, takes 30 KB of stack, or up to 45 KB in two and three dimensions and up to 95 KB
// from four on, where numbers of extreme exponents reach the last exact stage. So 64 KB are enough in two and three
// dimensions and 128 KB in all; more without optimisation. Recursion is as deep as the logarithm of the number of
// points. Linkers for WebAssembly give 64 KB unless they are told otherwise: wasm-ld -z stack-size=262144.
//
//
// ERRORS
//
// Functions that can fail return a paradt_status; PARADT_OK is 0. paradt_status_string describes the others, and
// error_text in the result, or reason in paradt_fault, says more: for each ARGUMENT error which argument and why.
//
//     PARADT_ERROR_ARGUMENT    a missing pointer, a dimension out of range, a small stride, an unknown value
//     PARADT_ERROR_NOT_FINITE  a NaN or infinity; error_point is the index of the first such point
//     PARADT_ERROR_MEMORY      the allocator returned NULL, or memory_limit was reached
//     PARADT_ERROR_TOO_LARGE   more points or cells than an index can number (see LIMITS)
//     PARADT_ERROR_CANCELLED   the progress callback returned nonzero
//     PARADT_ERROR_INVALID     paradt_check only: the triangulation is wrong; paradt_fault says where
//     PARADT_ERROR_FLAT        with PARADT_FULL_DIM: the points lie in a line, plane or flat of lower dimension
//
// After an error the result is empty: dim is -1, the arrays are NULL, and there is nothing to free (paradt_free does no
// harm). error_point, error_text and stats are filled. After PARADT_ERROR_MEMORY stats.peak_bytes is the most that was
// held, and stats.needed_bytes what it would have been with the block that was refused: a smaller memory_limit fails at
// this block again, and one of this size gets past it. Callbacks must return: an exception or longjmp out of them leaks
// what the call holds.
//
//
// COST
//
// For points that are spread without structure the expected work on a cell does not grow with n: InCoDe and DeWall look
// at a bounded number of candidates a facet, insertion at a bounded number of cells a point. So time is proportional to
// the number of cells, apart from sorting the points. InCoDe and DeWall have two exceptions, which insertion has not.
// When all points lie exactly on one sphere, or in a slanting plane but for rounding, every point ties with every
// sphere, and a search looks at all of them. And points whose coordinates or weights are too large for floating point,
// or too far apart in size (see NUMBERS), are searched one by one.
//
// The number of cells depends on the points. For most input in a fixed dimension it is proportional to n, with a factor
// that grows quickly with the dimension. At worst it grows like n^ceil(d/2): examples are a moment curve in any
// dimension, and two skew lines in space. The counters of paradt_stats tell what a run cost in terms that do not depend
// on the machine:
//
//     distance_evaluations / cells   candidates looked at for a cell, eight a grid cell (InCoDe, DeWall; with regions
//                                    insertion, too)
//     grid_cells_visited / cells     how far these searches went
//     exact_* / cells                predicates too close for floating point, orientations included
//     perturbed                      ties
//     cells_recomputed / cells       the price of regions, except where the division was abandoned
//     active_peak                    the size of the front (InCoDe, DeWall)
//
// paradt_check takes expected linear time. The public predicates measure their arguments anew at each call; the
// triangulation does that once for all points, and is faster for each of them. paradt_orient2, paradt_orient3 and the
// like are the fastest to call from outside.
//
//
// LIMITS
//
//     dimension    2 to 8
//     points       2^30 - 1; with PARADT_INDEX64 as many as memory holds
//     cells        cells * (dim + 1) below 2^31 (536,870,911 tetrahedra); with PARADT_INDEX64 as many as memory holds;
//                  for insertion the facets of the hull count as cells too
//     changes      a triangulation is computed as a whole; points are not added to it or taken away later
//     constraints  none: no edges or facets can be demanded
//     methods      those of PARADT_METHOD_LIST: no flips, Delaunay tree or lifted hull yet
//     machine      right shift of negative integers is arithmetic, doubles are IEEE 754, as on all platforms met so far
//
//
// THE THESIS
//
// InCoDe, DeWall and their parallel forms follow "Parallel Delaunay Triangulation in 3D and Higher Dimensions". Where
// its parts are:
//
//     InCoDe      MakeFirstSimplex       paradt__cell_towards: paradt__simplex_guess grows it from the nearest
//                                        neighbour by smallest spheres (paradt__simplex_next_vertex), then descent
//                 MakeSimplex            paradt__search_apex, the smallest signed Delaunay distance outside of a facet
//                 active face list       struct paradt__facets, a hash table: paradt__facets_match
//                 update of the AFL      paradt__front_add
//                 uniform grid           paradt__grid_build: a hierarchy of boxes that adapts to the points
//                 the loop               paradt__incode, with paradt__front_expand for each facet
//     DeWall      dividing plane         paradt__grid_cut
//                 simplex wall           paradt__wall_build, begun by paradt__wall_seed where no facet crosses it
//                 AFL alpha, 1, 2        struct paradt__wall; paradt__wall_activate says which one a facet enters
//                 recursion              paradt__wall_build, from paradt__dewall
//     ParaInCoDe  regions                paradt__build_by_front; one of them: paradt__front_task
//                 owner                  paradt__cell_owner, the box with most vertices instead of the one with the
//                                        ULF vertex, and which facets a region needs for that: paradt__needs
//                 uniform partition      paradt__cutter_divide with PARADT_UNIFORM
//                 adaptive partition     the same with PARADT_BISECTION
//                 joining                paradt__collect_fronts
//
// Here every decision is exact, ties follow the perturbation, and one code serves all dimensions, with and without
// weights. Why a region reaches all the cells that it owns is shown in >>reach.
//
//
// CREDITS
//
//     P. Cignoni, C. Montani, R. Scopigno, "DeWall: a fast divide and conquer Delaunay triangulation algorithm in E^d",
//         Computer-Aided Design 30, 1998: DeWall and InCoDe
//     "Parallel Delaunay Triangulation in 3D and Higher Dimensions", thesis: their parallel forms, the regions
//     O. Devillers, M. Teillaud, "Perturbations for Delaunay and weighted Delaunay 3D triangulations", Computational
//         Geometry 44, 2011: the perturbation
//     A. Bowyer, "Computing Dirichlet tessellations", and D. F. Watson, "Computing the n-dimensional Delaunay
//         tessellation with application to Voronoi polytopes", The Computer Journal 24, 1981: insertion
//     N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", Symposium on Computational Geometry, 2003: the
//         order of insertion
//     C. H. Hamilton, "Compact Hilbert indices", Dalhousie University, CS-2006-07: Hilbert's curve in any dimension
//     H. Edelsbrunner, "An acyclicity theorem for cell complexes in d dimensions", Combinatorica 10, 1990:
//         why walks end
//     R. A. Dwyer, "Higher-dimensional Voronoi diagrams in linear expected time", Discrete and Computational Geometry
//         6, 1991: the expected number of cells
//     M. L. Balinski, "On the graph structure of convex polyhedra in n-space", Pacific Journal of Mathematics 11, 1961:
//         why a region reaches all its cells
//     K. Mehlhorn, S. Naeher, T. Schilz, S. Schirra, M. Seel, R. Seidel, C. Uhrig, "Checking geometric programs or
//         verification of geometric structures", Computational Geometry 12, 1999: the certificate
//     O. Devillers, G. Liotta, F. P. Preparata, R. Tamassia, "Checking the convexity of polytopes and the planarity of
//         subdivisions", Computational Geometry 11, 1998: the certificate of the hull
//     C. A. R. Hoare, "Algorithm 65: Find", Communications of the ACM 4, 1961: sorting into the grid
//     J. Hadamard's bound on determinants, 1893: error bounds of the filter
//
//
// CHANGES
//
//     0.1.0  the first version: InCoDe, DeWall, Bowyer-Watson, regions, the certificate
//

// These macros change the declarations, which are read at the first include.
#if defined(PARADT_H) && defined(PARADT_STATIC) && !defined(PARADT__IS_STATIC)
#error "PARADT_STATIC is defined after the first include of paradt.h in this file: define it before"
#endif
#if defined(PARADT_H) && defined(PARADT_INDEX64) && !defined(PARADT__IS_INDEX64)
#error "PARADT_INDEX64 is defined after the first include of paradt.h in this file: define it before"
#endif

#ifndef PARADT_H
#define PARADT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifdef PARADT_STATIC
#define PARADT__IS_STATIC
#endif
#ifndef PARADT_DEF
#if defined(PARADT_STATIC) && defined(__GNUC__)
#define PARADT_DEF static __attribute__((unused)) // a file need not call all of them
#elif defined(PARADT_STATIC)
#define PARADT_DEF static
#else
#define PARADT_DEF extern
#endif
#endif

#define PARADT_VERSION 100 // major * 10000 + minor * 100 + patch
#ifndef PARADT_MAX_DIM
#define PARADT_MAX_DIM 8 // the largest dimension, 2..8; code for larger ones is not compiled
#elif PARADT_MAX_DIM < 2 || PARADT_MAX_DIM > 8
#error "PARADT_MAX_DIM must be 2 to 8"
#endif

#ifdef PARADT_INDEX64
#define PARADT__IS_INDEX64
typedef int64_t paradt_index; // a point, a cell or a half-facet; negative: none
// The functions have other names, so that the linker refuses files that differ in PARADT_INDEX64.
#define paradt_points_f64         paradt_points_f64_64
#define paradt_points_f32         paradt_points_f32_64
#define paradt_triangulate        paradt_triangulate_64
#define paradt_memory_estimate    paradt_memory_estimate_64
#define paradt_repair             paradt_repair_64
#define paradt_free               paradt_free_64
#define paradt_version            paradt_version_64
#define paradt_status_string      paradt_status_string_64
#define paradt_method_string      paradt_method_string_64
#define paradt_check              paradt_check_64
#define paradt_hash               paradt_hash_64
#define paradt_hash_cell          paradt_hash_cell_64
#define paradt_orient             paradt_orient_64
#define paradt_insphere           paradt_insphere_64
#define paradt_insphere_perturbed paradt_insphere_perturbed_64
#define paradt_orient2            paradt_orient2_64
#define paradt_orient3            paradt_orient3_64
#define paradt_insphere2          paradt_insphere2_64
#define paradt_insphere3          paradt_insphere3_64
#define paradt_orient2f           paradt_orient2f_64
#define paradt_orient3f           paradt_orient3f_64
#define paradt_insphere2f         paradt_insphere2f_64
#define paradt_insphere3f         paradt_insphere3f_64
#else
typedef int32_t paradt_index; // a point, a cell or a half-facet; negative: none
#endif

// What functions that can fail return: name, what paradt_status_string says. PARADT_OK is 0.
#define PARADT_STATUS_LIST(X)                                                                                          \
    X(PARADT_OK, "done")                                                                                               \
    X(PARADT_ERROR_ARGUMENT, "an argument is out of its range or missing")                                             \
    X(PARADT_ERROR_NOT_FINITE, "a coordinate or weight is NaN or infinite")                                            \
    X(PARADT_ERROR_MEMORY, "an allocation failed or the memory limit was reached")                                     \
    X(PARADT_ERROR_TOO_LARGE, "the input or the result has more elements than an index can number")                    \
    X(PARADT_ERROR_CANCELLED, "the progress callback asked to stop")                                                   \
    X(PARADT_ERROR_INVALID, "the triangulation is not the one its points define")                                      \
    X(PARADT_ERROR_FLAT, "the points lie in a flat of lower dimension, and PARADT_FULL_DIM is set")

#define PARADT__ENUM_FIRST(name, text) name,
typedef enum paradt_status { PARADT_STATUS_LIST(PARADT__ENUM_FIRST) PARADT_STATUS_COUNT } paradt_status;

// How to triangulate: name, name on the command line. The cells are the same by every method.
#define PARADT_METHOD_LIST(X)                                                                                          \
    X(PARADT_AUTO, "auto")                                                                                             \
    X(PARADT_INCODE, "incode")                                                                                         \
    X(PARADT_DEWALL, "dewall")                                                                                         \
    X(PARADT_BOWYER_WATSON, "bowyer-watson")                                                                           \
    X(PARADT_FLIP, "flip")                                                                                             \
    X(PARADT_DELAUNAY_TREE, "delaunay-tree")                                                                           \
    X(PARADT_LIFTED_HULL, "lifted-hull")

typedef enum paradt_method { PARADT_METHOD_LIST(PARADT__ENUM_FIRST) PARADT_METHOD_COUNT } paradt_method;

// The type of coordinates and weights: double or float
typedef enum paradt_scalar { PARADT_F64, PARADT_F32 } paradt_scalar;

// How space is divided into regions: into boxes of equal numbers of points, or of equal size
typedef enum paradt_partition { PARADT_BISECTION, PARADT_UNIFORM } paradt_partition;

// paradt_options.flags
enum {
    PARADT_NO_NEIGHBORS = 1, // the result's neighbors are NULL
    PARADT_FACETS = 2,       // neighbors are half-facets (see RESULT), not cells; not with PARADT_NO_NEIGHBORS
    PARADT_FULL_DIM = 4      // points of a lower affine dimension than their own are PARADT_ERROR_FLAT
};

// Runs task(context, i) for every i below count, in any order and on any threads, and returns when all have ended.
// Tasks do not wait for each other, so one thread is enough. It is called for one step of the work after another (for
// how many, see REGIONS AND THREADS), from the thread that called paradt_triangulate.
//   user  that of the options
typedef void (*paradt_parallel_for)(void *user, size_t count, void (*task)(void *context, size_t index), void *context);

// Is told how far a call is. A nonzero return cancels it. With a parallel_for any of its threads makes the call, but
// never two of them concurrently.
//   user      that of the options
//   fraction  0..1, the part of the whole call's work that is done: an estimate that never falls, and 1 at the end
typedef int (*paradt_progress)(void *user, double fraction);

// Where memory comes from. Give both functions or neither. The threads of a parallel_for call them concurrently.
typedef struct paradt_allocator {
    void *(*alloc)(void *user, size_t size); // NULL: malloc; size: bytes, never 0; aligned as by malloc; NULL: no more
    void (*free)(void *user, void *memory);  // NULL: free; never called with NULL
    void *user;                              // handed to both
} paradt_allocator;

typedef struct paradt_points {
    const void *data;            // first coordinate of the first point; may be NULL when count is 0
    size_t count;                // number of points
    int dim;                     // coordinates a point, 2..PARADT_MAX_DIM
    size_t stride;               // bytes from one point to the next; 0: tightly packed
    paradt_scalar scalar;        // type of the coordinates; PARADT_F64
    const void *weights;         // weight of the first point, the square of a radius, any sign; NULL: without weights
    size_t weight_stride;        // bytes from one weight to the next; 0: tightly packed
    paradt_scalar weight_scalar; // type of the weights; PARADT_F64
} paradt_points;

typedef struct paradt_options {
    paradt_method method;             // PARADT_AUTO
    size_t regions;                   // 0 or 1: undivided (but see MEMORY); at most as many as there are points
    paradt_partition partition;       // PARADT_BISECTION
    paradt_parallel_for parallel_for; // NULL: regions run one after another in the calling thread
    paradt_progress progress;         // NULL: none
    paradt_allocator allocator;       // zero: malloc and free
    size_t memory_limit;              // bytes that a call may hold at any time; 0: no limit
    unsigned flags;                   // 0; PARADT_NO_NEIGHBORS or PARADT_FACETS, PARADT_FULL_DIM
    void *user;                       // handed to parallel_for and progress; NULL
} paradt_options;

// Counts are sums over all regions unless they say otherwise.
typedef struct paradt_stats {
    uint64_t cells;                // cells of the triangulation
    uint64_t hull_facets;          // facets with a cell on one side only
    uint64_t duplicates;           // points at the place of another
    uint64_t hidden;               // places of weighted points that are not vertices
    uint64_t distance_evaluations; // Delaunay distances computed by searches, in lanes of eight
    uint64_t grid_cells_visited;   // grid cells whose points were looked at
    uint64_t active_peak;          // largest size of an active face list of InCoDe or DeWall, in facets
    uint64_t orient_calls;         // orientation predicates
    uint64_t insphere_calls;       // in-sphere predicates; in 3D insertion those that cached spheres could not decide
    uint64_t exact_small;          // predicates settled in small integers, or found to be 0 by the filter on lattices
    uint64_t exact_fixed;          // ... in integers of a fixed number of words
    uint64_t exact_general;        // ... in integers of any length
    uint64_t perturbed;            // in-sphere predicates settled by the perturbation
    uint64_t regions;              // regions built
    uint64_t cells_recomputed;     // cells that regions made and did not own: the duplication
    uint64_t peak_bytes;           // most memory held at any time, result included; with regions an upper bound
    uint64_t history_nodes; // cells that PARADT_FLIP and PARADT_DELAUNAY_TREE made, those that were replaced included
    uint64_t flips[PARADT_MAX_DIM + 2]; // PARADT_FLIP: flips that replaced so many simplices of a circuit
    uint64_t needed_bytes; // PARADT_ERROR_MEMORY: what that would be with the block that was refused; else 0
    double seconds_points; // reading, checking, sorting and merging the points; wall time, like all of these
    double seconds_grid;   // sorting them into the grid of InCoDe and DeWall
    double seconds_build;  // making cells, and joining those of regions
    double seconds_finish; // finding hidden points, freeing memory
    double seconds;        // all of it
} paradt_stats;

typedef struct paradt_triangulation {
    int dim;                      // affine dimension of the points: dim + 1 vertices a cell; -1: no points, or an error
    size_t cell_count;            // number of cells
    paradt_index *cells;          // [cell_count][dim + 1] point indices, positively oriented
    paradt_index *neighbors;      // [cell_count][dim + 1] the cell opposite each vertex; -1: hull; NULL: not wanted
    size_t point_count;           // number of points, as given
    paradt_index *representative; // [point_count] the point itself, or the one that stands for it; -1: hidden
    size_t error_point;           // PARADT_ERROR_NOT_FINITE: index of the first such point; else 0
    const char *error_text;       // what went wrong; for ARGUMENT which and why; static storage; NULL: no error
    paradt_allocator allocator;   // what paradt_free gives the arrays back to
    paradt_stats stats;           // what was done, also before an error; last, so that new counters move nothing
} paradt_triangulation;

// What paradt_check found wrong first, or why it could not tell; all zero when nothing is wrong
typedef struct paradt_fault {
    const char *reason; // a sentence, of static storage; NULL: nothing is wrong
    paradt_index cell;  // index of the cell concerned, or -1
    paradt_index point; // index of the point concerned, or -1
} paradt_fault;

// These functions only take an array's address: it may be filled later.
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 11
#define PARADT__ADDRESS_ONLY __attribute__((access(none, 1)))
#else
#define PARADT__ADDRESS_ONLY
#endif

// Return points without weights that are tightly packed in an array: [count][dim]. The compiler checks that their type
// is the right one. Thread-safe.
PARADT_DEF paradt_points paradt_points_f64(const double *coordinates, size_t count, int dim) PARADT__ADDRESS_ONLY;
PARADT_DEF paradt_points paradt_points_f32(const float *coordinates, size_t count, int dim) PARADT__ADDRESS_ONLY;

// Computes the triangulation of the points.
//   out      is overwritten, whatever it held. After an error it is empty and holds no memory: dim is -1, the arrays
//            are NULL, the counts 0; but error_point, error_text and stats are filled.
//   points   read during the call only
//   options  NULL: the defaults
// Errors: ARGUMENT, NOT_FINITE, MEMORY, TOO_LARGE, CANCELLED, FLAT. Thread safety: any number of concurrent calls, each
// with its own `out`. Cost: sorting the points, and expected constant time a cell for points without structure.
PARADT_DEF paradt_status paradt_triangulate(paradt_triangulation *out, const paradt_points *points,
                                            const paradt_options *options);

// Returns about how many bytes paradt_triangulate would hold at most if it were called with the same arguments: for
// points spread evenly in all dimensions rather too many than too few, by up to a half in two and three dimensions and
// up to twice beyond. Other points may take more. Of the points only count and dim matter; data may be NULL. Returns 0
// where an argument is wrong. Thread-safe.
PARADT_DEF uint64_t paradt_memory_estimate(const paradt_points *points, const paradt_options *options);

#ifndef PARADT_NO_FLIPS
// What paradt_repair did
typedef struct paradt_repair_stats {
    uint64_t inverted;   // cells that the moves had turned over or made flat
    uint64_t irregular;  // facets between the others that were not locally regular, before anything was changed
    uint64_t flips;      // flips done
    uint64_t stuck;      // cells that were still turned over, and facets not locally regular, when no flip was possible
    uint64_t holes;      // holes that were cut around these, and filled anew
    uint64_t reinserted; // points inserted again: those of the holes, counted in each, and such as were no vertices
    int rebuilt;         // 1: the triangulation was built anew, by paradt_triangulate
    double seconds;      // all of it, wall time
} paradt_repair_stats;

// Makes a triangulation that of its points again, after these have moved, or had their weights changed: the result is
// that of paradt_triangulate, in less time where the moves are small. Cells that are still right stay; most others are
// replaced by flips.
//   triangulation  with neighbors, from paradt_triangulate or paradt_repair; what was done to its arrays since must
//                  have left a valid triangulation of the points as they were then. A triangulation that is empty, has
//                  no neighbors or another dimension than the points is built anew, and so is one with many cells
//                  turned over, or where many points become or cease to be hidden. Its arrays and stats are replaced.
//   points         as many as before, at their new places
//   options        NULL: the defaults. memory_limit, progress, user and flags are used, PARADT_FACETS for what
//   neighbors
//                  hold and are to hold; not with PARADT_NO_NEIGHBORS. All memory comes from the triangulation's
//                  allocator. The rest is for building anew.
//   stats          NULL: not wanted
// Errors: those of paradt_triangulate, and INVALID where the arrays do not fit together. After ARGUMENT, NOT_FINITE,
// and TOO_LARGE for the number of points the triangulation is what it was, but for error_point and error_text; after
// another error it may be empty, as after one of paradt_triangulate: then dim is -1. Thread safety: any number of
// concurrent calls, each with its own triangulation. Cost: linear time, a fraction of paradt_triangulate's, if little
// changes.
PARADT_DEF paradt_status paradt_repair(paradt_triangulation *triangulation, const paradt_points *points,
                                       const paradt_options *options, paradt_repair_stats *stats);
#endif

// Gives the arrays back to the allocator they came from and leaves the triangulation empty: all zero but dim, which is
// -1. NULL, and a triangulation that is all zero, are fine. Thread safety: as free.
PARADT_DEF void paradt_free(paradt_triangulation *triangulation);

// Returns PARADT_VERSION of the implementation that the program is linked with. Thread-safe.
PARADT_DEF int paradt_version(void);

// Returns a sentence of static storage, without a full stop; never NULL, whatever the value. Thread-safe.
PARADT_DEF const char *paradt_status_string(paradt_status status);

// Returns the method's name on the command line, of static storage; never NULL, whatever the value. Thread-safe.
PARADT_DEF const char *paradt_method_string(paradt_method method);

#ifndef PARADT_NO_CHECK
// Proves in exact arithmetic that the triangulation is the one that the points define: cells, neighbours,
// representatives, hidden points, dimension. Returns PARADT_OK if it is. Returns PARADT_ERROR_INVALID if it is not, and
// *fault says what was found first.
//   triangulation  of any origin: the sizes of the arrays are trusted, their values are not. neighbors may be NULL.
//   points         those that it was made from
//   options        NULL: the defaults. allocator, memory_limit, progress and user are used, and PARADT_FACETS in flags,
//                  which says what neighbors hold. The rest is only checked.
//   fault          NULL: not wanted. It says which argument is wrong, too.
// Errors: INVALID; and ARGUMENT, NOT_FINITE, MEMORY, TOO_LARGE, CANCELLED, which say nothing about the triangulation.
// Thread safety: any number of concurrent calls. Cost: expected linear time. It shares the predicates with
// paradt_triangulate, but neither its searches nor its data structures.
PARADT_DEF paradt_status paradt_check(const paradt_triangulation *triangulation, const paradt_points *points,
                                      const paradt_options *options, paradt_fault *fault);
#endif

// Returns a hash of the set of cells, each as a set of point indices: the sum of paradt_hash_cell over the cells, 0
// without cells. It depends neither on the order of cells and vertices nor on the size of indices or the machine, and
// needs no neighbours. Thread-safe. Cost: linear time.
PARADT_DEF uint64_t paradt_hash(const paradt_triangulation *triangulation);

// Returns the hash of one cell. For programs that hold the cells in parts, or with other numbers: sums of the parts add
// up to the hash of the whole. Thread-safe.
//   vertices  [count] in any order
//   count     0..PARADT_MAX_DIM + 1
PARADT_DEF uint64_t paradt_hash_cell(const uint64_t *vertices, int count);

// The predicates are exact for all finite doubles. Other values, and a dim out of 2..PARADT_MAX_DIM, are undefined
// behaviour. Each point is a pointer to dim coordinates. No memory is allocated. Thread-safe. A call costs a pass over
// its arguments and the filter; the exact stages only when the filter can not decide.

// Returns the sign, -1, 0 or 1, of the determinant of points[1] - points[0], ..., points[dim] - points[0]. 1:
// positively oriented, in the plane counterclockwise; 0: flat.
PARADT_DEF int paradt_orient(int dim, const double *const *points /* [dim + 1] */);

// Returns 1 when points[dim + 1] is inside the sphere through the first dim + 1 points, which are positively oriented;
// 0 when it is on the sphere; -1 when it is outside. Where the first dim + 1 are negatively oriented, the opposite.
//   weights  NULL, or [dim + 2]: then inside means below the hyperplane through the first dim + 1 when all are lifted
//            to |x|^2 - weight (the power test)
PARADT_DEF int paradt_insphere(int dim, const double *const *points /* [dim + 2] */, const double *weights);

// Returns the same with ties broken by the perturbation (see DEGENERATE INPUT): 1 in conflict, -1 not, never 0. The
// first dim + 1 points must be positively oriented, and none of them equal to points[dim + 1].
PARADT_DEF int paradt_insphere_perturbed(int dim, const double *const *points /* [dim + 2] */, const double *weights);

// Return the signs of paradt_orient for the points a, b, c (d), and of paradt_insphere without weights for these and q,
// in two and three dimensions, of doubles and floats. Coordinates instead of pointers to pointers, and much faster: for
// programs that call them by the million, as a walk does.
PARADT_DEF int paradt_orient2(const double a[2], const double b[2], const double c[2]);
PARADT_DEF int paradt_orient2f(const float a[2], const float b[2], const float c[2]);
PARADT_DEF int paradt_insphere2(const double a[2], const double b[2], const double c[2], const double q[2]);
PARADT_DEF int paradt_insphere2f(const float a[2], const float b[2], const float c[2], const float q[2]);
#if PARADT_MAX_DIM >= 3
PARADT_DEF int paradt_orient3(const double a[3], const double b[3], const double c[3], const double d[3]);
PARADT_DEF int paradt_orient3f(const float a[3], const float b[3], const float c[3], const float d[3]);
PARADT_DEF int paradt_insphere3(const double a[3], const double b[3], const double c[3], const double d[3],
                                const double q[3]);
PARADT_DEF int paradt_insphere3f(const float a[3], const float b[3], const float c[3], const float d[3],
                                 const float q[3]);
#endif

#ifdef __cplusplus
}
#endif

#endif // PARADT_H

// The implementation follows; stop here if you only use the API. Its sections are marked "// >>name". Each begins with
// what it is for, what holds in it, where the idea is from and its doors, and uses only what stands above it.

// READING THE IMPLEMENTATION
//
// A POINT'S WAY through the file, from the caller's array to the caller's cells:
//
//       the caller's points                                            index
//             |
//             |  >>reading, >>sorting: finite, distinct, along Hilbert's curve, box after box
//             |  >>scale and axes: the axes that orient, a scale for the filters
//             v
//       a set of records                                               position
//             |
//             +---------------- facet by facet ---+---------------- point by point -----+
//             |                                   |                                     |
//             |  >>grid          cells of eight   |  >>order of insertion   rounds      |
//             |  >>first simplex where to begin   |  >>insertion     walk, dig, star    |
//             |  >>search        the apex         |  >>kept spheres  tests by one       |
//             |  >>front         the AFL          |                  product, in space  |
//             |  >>incode, >>dewall               |                                     |
//             v                                   v                                     |
//       a mesh of cells                     a mesh of cells and ghosts                  |  place, handle
//             |                                   |                                     |
//             +-----------------+-----------------+                                     |
//                               |  each region does all that for a part of space, by >>reach and >>fronts, or by
//                               |  >>fields and patches and >>regions of insertion
//                               |
//                               |  paradt__mesh_close: ghosts go, gaps are filled, positions become indices,
//                               |  handles become numbers
//                               v
//       paradt_triangulation                                           index, number
//
// INDEX SPACES. All are paradt_index or size_t; a variable's name says of which space it is.
//
//     index      a point as the caller counts. set.origin[position] gives it
//     position   a point in a set: its record is records + position * width. The vertices of a mesh are positions until
//                the mesh is closed. A region's patch counts its own points first, then others' (vertex)
//     place      a cell in a mesh, a point in a grid: its row, wherever the cell or point moves from
//     handle     a facet as one of its cells sees it: corners * place + i, opposite vertex i. Links are handles
//     number     a cell as delivered
//     slot       of a hash table
//     region     0 to regions - 1, a box of space; a rank in paradt_mpi.h
//
// SENTINELS
//
//     PARADT__HULL      a link: no cell is on the other side        PARADT__INFINITE  a vertex: that of ghosts
//     PARADT__OPEN      a link: the cell there is not known;        PARADT__DEAD      a vertex: the place is free
//                       a list's end                                PARADT__NOWHERE   no position, no place
//     PARADT__GAVE_UP   a status: another way is to be tried        PARADT__FAR       a bound: there is none
//
// VOCABULARY. The field's words: cell, facet, ridge (a facet of a facet), vertex, apex (the vertex opposite a facet),
// star and link of a vertex, conflict, cavity, hull, circumsphere, active face list (AFL). And of this file:
//
//     ghost           the cell on the outer side of a hull facet, with the infinite vertex
//     half-facet      a facet as one of its cells sees it; its mirror: as the other cell does
//     rim             the cavity's facets; to star the cavity: to join the point with the rim
//     update          what a change did: cells killed, cells made
//     region, owner   a box of space; the region that delivers a cell which several make
//     field, patch    a region's points, as others see them; its triangulation under construction, by insertion
//     seam            facets between the first region's cells and others'
//     representative  the point that stands for all points at its place; hidden: a weighted point that is no vertex
//     lift, power     |x|^2 less the weight; the distance from a sphere in that sense, negative inside
//     sagitta         how far a point is inside the reference sphere; near a sphere it replaces |x|^2
//     orients         an axis orients if it is one of the first `dim` axes, which decide about orientation
//     filter          floating point that decides, or says that it can't
//
// THREE READING PATHS
//
//     insertion         >>mesh, >>scene, >>insertion; then >>kept spheres and >>insertion in space, the same once more
//                       where it is fast; >>inserting
//     InCoDe, DeWall    >>mesh, >>facets, >>grid, >>pencil, >>search, >>first simplex, >>front, >>incode, >>dewall
//     regions, ranks    >>cuts, >>call; >>reach, >>regions of fronts, >>fronts; >>questions, >>fringe to
//                       >>results of patches, >>regions of insertion; then paradt_mpi.h
//
// CONTENTS, with the lines of each section
//
//   ground
//     memory                       173   the account of every byte
//     numbers                      200   bit patterns, integers, small helpers
//     tasks                        185   progress, teams, pauses, the clock
//   predicates
//     space                        235   what the predicates know of a set
//     filters                      196   signs in floating point, with error bounds
//     digits                       132   integers of many digits
//     exact                        608   signs in integers
//     signs                        244   orientation, in-sphere, the perturbation; the public predicates
//   points
//     curve                        323   Hilbert's curve, sorting along it
//     points                       162   the caller's points, records
//     measures                     144   points that span, spacing
//     cuts                         220   boxes of space
//     reading                      199   the first pass over the points
//     sorting                      373   along the curve, box after box
//     scale and axes               102   the scale, the axes that orient
//     reference sphere             195   sagittas near a sphere
//   mesh
//     mesh                         688   cells, links, ghosts, free places; closing
//     facets                       257   the table of facets: AFL, ridges, open facets
//     scene                        116   conflict test, walk, update
//   search
//     grid                         375   a hierarchy of boxes over a set
//     search kernels               388   tests of eight boxes or points together
//     pencil                       444   the spheres through a facet
//     search                       355   the apex of a facet, a point in a sphere
//     questions                     76   the same of cells of others' points
//   making
//     first simplex                139   a cell to begin with
//     reach                         96   which cells a region makes and owns, facet by facet
//     front                        408   what facet by facet has in common
//     incode                        28   incremental construction
//     dewall                       145   divide and conquer, merge first
//     order of insertion           144   rounds along the curve
//     insertion                    255   dig and star, in any dimension
//     kept spheres                 508   conflict tests by one product, in space
//     insertion in space           656   dig and star with kept spheres
//     insertion in space by AVX2   466   its inner functions for four lanes
//     inserting                    184   insertions from begin to end
//     flips                        248   circuits and their flips, in any dimension
//     history                      170   the dag of all cells, by which points are located
//     insertion by flips           308   search, split, collect, flip
//   division
//     regions of fronts            125   owners, joining
//     fringe                        94   cells that are not a region's own alone
//     fields and patches           335   a region's points, its insertion
//     questions between regions    364   is a cell one of T(P)?
//     seam                         226   what of the first region's cells is right
//     results of patches           162   dropping, emitting, taking over
//     known points                 234   what a rank builds
//     call                         192   what one call works with; steps
//     fronts                       106   InCoDe and DeWall from set to mesh
//     regions of insertion         529   the steps of a divided insertion
//   entry
//     methods                      255   one row a method; AUTO's choice
//     triangulate                  367   the entry
//     mending by flips             263   what has moved, by flips
//     mending by holes             438   what flips leave, by small triangulations
//     spheres of cells in space    147   which cells and facets are still right, four cells together
//     repair                       590   the entry of repairing
//   check
//     check                        498   the certificate
//   division
//     check of the hull            285   ... and of hidden points

#ifdef PARADT_IMPLEMENTATION
#ifndef PARADT__IMPLEMENTED
#define PARADT__IMPLEMENTED

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#if !defined(CLOCK_MONOTONIC) && (defined(__unix__) || defined(__APPLE__) || defined(__MINGW32__))
#include <sys/time.h>
#define PARADT__TIMEVAL
#endif
#if defined(__linux__)
#include <errno.h>
#include <sys/mman.h> // for pages made ahead
#if defined(MADV_NORMAL)
#define PARADT__MADVISE 1
#elif !defined(__cplusplus)
#define PARADT__MADVISE 1 // it is there, too, where the compiler is asked for a standard without it
int madvise(void *address, size_t length, int advice);
#endif
#endif
#if defined(__SSE2__) && !defined(PARADT_NO_SIMD)
#include <emmintrin.h>
#endif
#if defined(__GNUC__) && defined(__x86_64__) && !defined(PARADT_NO_SIMD)
#include <immintrin.h> // for copies of the inner functions that are chosen at run time
#define PARADT__AVX2 __attribute__((target("avx2,fma,popcnt")))
#endif

// Casts and null pointers are written as C and C++ both have them.
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wzero-as-null-pointer-constant"
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wuseless-cast"
#endif
#endif

// Floating point rules cases out, with bounds that hold however sums of products are ordered and contracted, but a
// difference of two coordinates must be taken before anything is added to it: (a - b) - c as a - (b + c) has an error
// relative to a. So flags that allow that, -ffast-math among them, are turned off up to the end of the implementation.
#if defined(__clang__)
#pragma clang diagnostic push // float_control is not known for all targets: there it stays off after the end, too
#pragma clang diagnostic ignored "-Wignored-pragmas"
#pragma float_control(push)
#pragma clang diagnostic pop
#pragma clang fp reassociate(off)
#elif defined(__GNUC__) && !defined(__TINYC__)
#pragma GCC push_options
#pragma GCC optimize("no-associative-math")
#elif defined(_MSC_VER)
#pragma float_control(precise, on, push)
#endif

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PARADT_ASSERT
#define PARADT_ASSERT(condition) ((void)0)
#endif

#if defined(PARADT_NO_FRONTS) && defined(PARADT_NO_REGIONS)
#define PARADT__NO_SEARCH // nobody looks for points in a grid
#endif

// A function that is not used where a macro leaves out those who use it
#if defined(__GNUC__)
#define PARADT__OPTIONAL static __attribute__((unused))
#else
#define PARADT__OPTIONAL static
#endif

// A function that is called seldom (PARADT__COLD) is made small instead of fast. GCC treats the functions that only it
// calls likewise, unless they are marked (PARADT__HOT), and what follows a call of it; so a loop that is to be fast
// there is a function that is not inlined (PARADT__HOT_LOOP).
#if defined(__GNUC__) && !defined(__TINYC__)
#define PARADT__COLD     static __attribute__((cold, noinline))
#define PARADT__HOT      static __attribute__((hot))
#define PARADT__HOT_LOOP static __attribute__((hot, noinline))
#else
#define PARADT__COLD     PARADT__NOINLINE
#define PARADT__HOT      static
#define PARADT__HOT_LOOP static
#endif

#if defined(__GNUC__)
#define PARADT__INLINE                     static inline __attribute__((always_inline))
#define PARADT__NOINLINE                   static __attribute__((noinline))
#define PARADT__LIKELY(condition)          __builtin_expect(!!(condition), 1)
#define PARADT__PREFETCH(address)          __builtin_prefetch(address)
#define PARADT__PREFETCH_TO_WRITE(address) __builtin_prefetch(address, 1)
#define PARADT__RESTRICT                   __restrict
#elif defined(_MSC_VER)
#define PARADT__INLINE                     static __forceinline
#define PARADT__NOINLINE                   static __declspec(noinline)
#define PARADT__LIKELY(condition)          (condition)
#define PARADT__PREFETCH(address)          ((void)(address))
#define PARADT__PREFETCH_TO_WRITE(address) ((void)(address))
#define PARADT__RESTRICT                   __restrict
#else
#define PARADT__INLINE                     static inline
#define PARADT__NOINLINE                   static
#define PARADT__LIKELY(condition)          (condition)
#define PARADT__PREFETCH(address)          ((void)(address))
#define PARADT__PREFETCH_TO_WRITE(address) ((void)(address))
#define PARADT__RESTRICT
#endif

// Unrolls the loop that follows. Short loops of constant length are only fast unrolled, and GCC does it below -O3 on
// request alone. Loops of variable length are unrolled four times: ten copies are much code for little speed.
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__)
#define PARADT__UNROLL   _Pragma("GCC unroll 10")
#define PARADT__UNROLL_4 _Pragma("GCC unroll 4")
#else
#define PARADT__UNROLL
#define PARADT__UNROLL_4
#endif

// Is dim, which is at most PARADT_MAX_DIM, equal to the constant k? A constant 0 if k is more than PARADT_MAX_DIM, so
// that the compiler drops the code for k.
#define PARADT__IS(dim, k) ((k) <= PARADT_MAX_DIM && (dim) == (k))

// Prefetches an element of an array. The element need not exist: the address is just a number. A function that only
// prefetches must be PARADT__INLINE: otherwise GCC takes it for one without effect and drops the calls.
#define PARADT__FETCH(array, index)                                                                                    \
    PARADT__PREFETCH((const void *)((uintptr_t)(array) + (size_t)(index) * sizeof *(array)))

// Numbers that several threads read and change concurrently. Where the compiler has nothing for them PARADT__ATOMICS is
// not defined, and the numbers are one thread's at a time.
#if defined(__GNUC__) && !defined(__TINYC__)
#define PARADT__ATOMICS
#define PARADT__ATOMIC_ADD(number, more) __atomic_add_fetch(number, more, __ATOMIC_RELAXED) // returns the sum
#define PARADT__ATOMIC_LOAD(number)      __atomic_load_n(number, __ATOMIC_RELAXED)
#define PARADT__ATOMIC_LOCK(flag)        (!__atomic_exchange_n(flag, 1, __ATOMIC_ACQUIRE)) // 0: it is locked already
#define PARADT__ATOMIC_UNLOCK(flag)      __atomic_store_n(flag, 0, __ATOMIC_RELEASE)
// Replaces *number by `value` where it is *expected; otherwise *expected becomes what it is. May fail without a reason.
#define PARADT__ATOMIC_SWAP(number, expected, value)                                                                   \
    __atomic_compare_exchange_n(number, expected, value, 1, __ATOMIC_RELAXED, __ATOMIC_RELAXED)
#else
#define PARADT__ATOMIC_ADD(number, more)             (*(number) += (more))
#define PARADT__ATOMIC_LOAD(number)                  (*(number))
#define PARADT__ATOMIC_LOCK(flag)                    (*(flag) ? 0 : (*(flag) = 1))
#define PARADT__ATOMIC_UNLOCK(flag)                  (*(flag) = 0)
#define PARADT__ATOMIC_SWAP(number, expected, value) (*(number) = (value), (void)(expected), 1)
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>memory
//
// Allocates from the caller's allocator and accounts for every byte. A block is preceded by its size, so that a release
// needs no size and the account stays exact. An account belongs to one thread at a time: each region has an account
// of its own with a share of the limit, which paradt__memory_join adds to the parent's account when the region ends.
// Doors: paradt__memory_begin, paradt__memory_fork, paradt__memory_join, paradt__alloc, paradt__alloc_filled,
// paradt__grow, paradt__release, paradt__make_pages, paradt__block_bytes.

typedef struct paradt__memory {
    paradt_allocator allocator;
    uint64_t limit;  // bytes; UINT64_MAX: none
    uint64_t held;   // bytes. Wraps below zero while the task has released more than it allocated
    uint64_t peak;   // the most bytes held so far
    uint64_t needed; // a limit that would have allowed the block that was refused last; 0: none was
    uint64_t base;   // of a share: what the parent held,
    uint64_t shares; // and how many shares there are; 0: not a share
} paradt__memory;

// Bytes in front of the payload: the block's size and padding, which keeps the payload as aligned as the allocator's
// memory, up to a cache line.
enum { PARADT__BLOCK_HEADER = 64 };

// Tells the address sanitizer that the padding is nobody's, so that it detects an index just below an array's start.
#if defined(__SANITIZE_ADDRESS__)
#define PARADT__ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PARADT__ADDRESS_SANITIZER
#endif
#endif
#ifdef PARADT__ADDRESS_SANITIZER
#include <sanitizer/asan_interface.h>
#define PARADT__FORBID(memory, size) __asan_poison_memory_region(memory, size)
#define PARADT__ALLOW(memory, size)  __asan_unpoison_memory_region(memory, size)
#else
#define PARADT__FORBID(memory, size) (void)0
#define PARADT__ALLOW(memory, size)  (void)0
#endif

static void *paradt__default_alloc(void *user, size_t size) {
    (void)user;
    return malloc(size);
}

static void paradt__default_free(void *user, void *memory) {
    (void)user;
    free(memory);
}

// Opens an account by the allocator and the limit of the options, which may be NULL.
static void paradt__memory_begin(paradt__memory *memory, const paradt_options *options) {
    memset(memory, 0, sizeof *memory);
    memory->limit = UINT64_MAX;
    if (options) {
        memory->allocator = options->allocator;
        if (options->memory_limit) memory->limit = options->memory_limit;
    }
    if (!memory->allocator.alloc || !memory->allocator.free) {
        memory->allocator.alloc = paradt__default_alloc;
        memory->allocator.free = paradt__default_free;
    }
}

// Returns the account of one of `shares` tasks that may run concurrently.
PARADT__OPTIONAL paradt__memory paradt__memory_fork(const paradt__memory *parent, size_t shares) {
    paradt__memory memory = *parent;
    PARADT_ASSERT(shares > 0);
    memory.held = memory.peak = memory.needed = 0;
    memory.base = parent->held;
    memory.shares = shares;
    if (parent->limit != UINT64_MAX) memory.limit = (parent->limit - parent->held) / shares;
    return memory;
}

// Adds what the child holds to the parent's account, and the child's peak to *sum_of_peaks. The tasks may have run
// concurrently, so that the sum of their peaks is an upper bound of the true peak.
PARADT__OPTIONAL void paradt__memory_join(paradt__memory *parent, const paradt__memory *child, uint64_t *sum_of_peaks) {
    parent->held += child->held;
    *sum_of_peaks += child->peak;
    if (child->needed > parent->needed) parent->needed = child->needed;
    if (parent->held > parent->peak) parent->peak = parent->held;
}

// Notes how much memory the call would have needed for a block that is refused: by the limit, which all shares have an
// equal part of, or by the allocator. Returns NULL.
static void *paradt__refuse(paradt__memory *memory, uint64_t bytes, int by_limit) {
    uint64_t held = memory->held + bytes;
    memory->needed = memory->base + (by_limit && memory->shares ? held * memory->shares : held);
    return NULL;
}

// Returns `count` elements of `size` bytes, not cleared; NULL if the limit, the allocator or size_t does not admit so
// many. Even zero elements get a block.
static void *paradt__alloc(paradt__memory *memory, size_t count, size_t size) {
    size_t bytes;
    uint64_t held;
    int stays_below_zero;
    char *block;
    if (size && count > (SIZE_MAX / 2 - PARADT__BLOCK_HEADER) / size) return NULL;
    bytes = count * size + PARADT__BLOCK_HEADER;
    held = memory->held + bytes;
    stays_below_zero = memory->held > UINT64_MAX / 2 && held > UINT64_MAX / 2;
    if (held > memory->limit && !stays_below_zero) return paradt__refuse(memory, bytes, 1);
    block = (char *)memory->allocator.alloc(memory->allocator.user, bytes);
    if (!block) return paradt__refuse(memory, bytes, 0);
    memcpy(block, &bytes, sizeof bytes);
    PARADT__FORBID(block + sizeof bytes, PARADT__BLOCK_HEADER - sizeof bytes);
    memory->held = held;
    if (held > memory->peak && !stays_below_zero) memory->peak = held;
    return block + PARADT__BLOCK_HEADER;
}

// Returns a block to the allocator. payload: NULL or a block of this account or of one joined with it
static void paradt__release(paradt__memory *memory, void *payload) {
    size_t bytes;
    char *block;
    if (!payload) return;
    block = (char *)payload - PARADT__BLOCK_HEADER;
    memcpy(&bytes, block, sizeof bytes);
    memory->held -= bytes;
    PARADT__ALLOW(block + sizeof bytes, PARADT__BLOCK_HEADER - sizeof bytes);
    memory->allocator.free(memory->allocator.user, block);
}

// The bytes of a block, which begins with its size
PARADT__OPTIONAL size_t paradt__block_bytes(const void *payload) {
    size_t bytes = 0;
    if (payload) memcpy(&bytes, (const char *)payload - PARADT__BLOCK_HEADER, sizeof bytes);
    return bytes;
}

enum { PARADT__PAGE = 4096 }; // bytes a page on most systems

// Has the system provide the pages of the array's bytes first..end - 1, which are about to be written, in one call.
// Otherwise it provides them one at a time, at the first write to each, which takes longer. The call never changes
// memory that has its pages already, whatever the caller's allocator returned; where pages are larger than
// PARADT__PAGE, the system refuses the call, and nothing is lost.
static void paradt__make_pages(const void *array, size_t first, size_t end) {
#ifdef PARADT__MADVISE
    enum { FEWEST = 8, POPULATE_WRITE = 23 /* not in all headers */ };
    uintptr_t begin = (uintptr_t)array, from = (begin + first) / PARADT__PAGE * PARADT__PAGE;
    uintptr_t to = (begin + end) / PARADT__PAGE * PARADT__PAGE;
    int before = errno;
    PARADT_ASSERT(first <= end);
    if (from < begin) from += PARADT__PAGE;
    if (to > from && (to - from) / PARADT__PAGE >= FEWEST && madvise((void *)from, (size_t)(to - from), POPULATE_WRITE))
        errno = before;
#else
    (void)array, (void)first, (void)end;
#endif
}

// Replaces *array by a block of `count` elements of `size` bytes and copies its first `used` elements. Returns 0, with
// *array as it was, if there is no memory.
static int paradt__grow(paradt__memory *memory, void **array, size_t used, size_t count, size_t size) {
    void *larger = paradt__alloc(memory, count, size);
    PARADT_ASSERT(used <= count);
    if (!larger) return 0;
    paradt__make_pages(larger, 0, used * size);
    if (used) memcpy(larger, *array, used * size);
    paradt__release(memory, *array);
    *array = larger;
    return 1;
}

// Does the same as paradt__alloc for a block that one thread is about to fill.
static void *paradt__alloc_filled(paradt__memory *memory, size_t count, size_t size) {
    void *block = paradt__alloc(memory, count, size);
    if (block) paradt__make_pages(block, 0, count * size);
    return block;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>numbers
//
// Doubles as bit patterns, small helpers for integers and doubles, and a hash. Every decision in this file comes down
// to bit patterns and integers, or to floating-point values beyond a bound on their error: so neither the rounding mode
// nor flush-to-zero nor a compiler's liberties with floating-point algebra can change it. Right shifts of negative
// integers are assumed to be arithmetic, as they are with all compilers.
// Doors: paradt__bits, paradt__from_bits, paradt__biased_exponent, paradt__is_finite, paradt__ordered_bits,
// paradt__from_ordered_bits, paradt__power, paradt__trailing_zeros, paradt__bit_length, paradt__split, paradt__scale,
// paradt__max, paradt__min, paradt__mix, paradt__precise, paradt__rounded, paradt__abs, paradt__larger,
// paradt__largest, PARADT__DIMENSIONS, paradt__widen.

// X(d) for each dimension that the implementation is compiled for
#if PARADT_MAX_DIM == 2
#define PARADT__DIMENSIONS(X) X(2)
#elif PARADT_MAX_DIM == 3
#define PARADT__DIMENSIONS(X) X(2) X(3)
#elif PARADT_MAX_DIM == 4
#define PARADT__DIMENSIONS(X) X(2) X(3) X(4)
#elif PARADT_MAX_DIM == 5
#define PARADT__DIMENSIONS(X) X(2) X(3) X(4) X(5)
#elif PARADT_MAX_DIM == 6
#define PARADT__DIMENSIONS(X) X(2) X(3) X(4) X(5) X(6)
#elif PARADT_MAX_DIM == 7
#define PARADT__DIMENSIONS(X) X(2) X(3) X(4) X(5) X(6) X(7)
#else
#define PARADT__DIMENSIONS(X) X(2) X(3) X(4) X(5) X(6) X(7) X(8)
#endif

// --- bit patterns

PARADT__INLINE uint64_t paradt__bits(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

PARADT__INLINE double paradt__from_bits(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

PARADT__INLINE int paradt__biased_exponent(double x) {
    return (int)(paradt__bits(x) >> 52 & 2047);
}

PARADT__INLINE int paradt__is_finite(double x) {
    return paradt__biased_exponent(x) < 2047;
}

// Maps finite doubles to integers in the same order; both -0.0 and 0.0 become 0.
PARADT__INLINE int64_t paradt__ordered_bits(double x) {
    uint64_t bits = paradt__bits(x), negative = 0 - (bits >> 63);
    return (int64_t)((bits ^ negative >> 1) - negative);
}

// The inverse of paradt__ordered_bits
PARADT__INLINE double paradt__from_ordered_bits(int64_t x) {
    return paradt__from_bits(x < 0 ? (0 - (uint64_t)x) | (uint64_t)1 << 63 : (uint64_t)x);
}

// Returns 2^exponent. exponent: -1022..1023
PARADT__INLINE double paradt__power(int exponent) {
    PARADT_ASSERT(exponent >= -1022 && exponent <= 1023);
    return paradt__from_bits((uint64_t)(exponent + 1023) << 52);
}

PARADT__INLINE int paradt__trailing_zeros(uint64_t x) { // x: not 0
    PARADT_ASSERT(x);
#if defined(__GNUC__) || defined(__clang__)
    return __builtin_ctzll(x);
#else
    int n = 0;
    for (; !(x & 255); x >>= 8) n += 8;
    for (; !(x & 1); x >>= 1) n++;
    return n;
#endif
}

// The number of bits from the highest one set; 0 for 0
PARADT__INLINE int paradt__bit_length(uint64_t x) {
#if defined(__GNUC__) || defined(__clang__)
    return x ? 64 - __builtin_clzll(x) : 0;
#else
    int n = 0;
    for (; x > 255; x >>= 8) n += 8;
    for (; x; x >>= 1) n++;
    return n;
#endif
}

// Returns the mantissa of |x| = mantissa * 2^*exponent, mantissa < 2^53, *exponent in -1074..971.
PARADT__INLINE uint64_t paradt__split(double x, int *exponent) {
    uint64_t bits = paradt__bits(x);
    int biased = (int)(bits >> 52 & 2047), normal = biased != 0;
    *exponent = biased + !normal - 1075;
    return (bits & 0xfffffffffffffu) | (uint64_t)normal << 52;
}

// Returns x * 2^exponent. Clears *exact if bits are lost, which are cut off, or if the product overflows: then it
// becomes the largest double of its sign.
static double paradt__scale(double x, int exponent, int *exact) {
    int e, drop;
    uint64_t sign = paradt__bits(x) & (uint64_t)1 << 63, mantissa = paradt__split(x, &e);
    if (!mantissa) return x;
    int normalize = 53 - paradt__bit_length(mantissa);
    mantissa <<= normalize;
    // beyond 4200 everything is shifted out in either direction
    e += (exponent < -4200 ? -4200 : exponent > 4200 ? 4200 : exponent) - normalize;
    if (e > 971) {
        *exact = 0;
        return paradt__from_bits(sign | 0x7fefffffffffffffu);
    }
    if (e >= -1074) return paradt__from_bits(sign | (uint64_t)(e + 1075) << 52 | (mantissa & 0xfffffffffffffu));
    drop = -1074 - e < 53 ? -1074 - e : 53; // the result is subnormal
    if (mantissa & (((uint64_t)1 << drop) - 1)) *exact = 0;
    return paradt__from_bits(sign | mantissa >> drop);
}

// --- integers and doubles

PARADT__INLINE int paradt__max(int a, int b) {
    return a > b ? a : b;
}

PARADT__INLINE int paradt__min(int a, int b) {
    return a < b ? a : b;
}

// Returns a hash of h.
static uint64_t paradt__mix(uint64_t h) {
    h ^= h >> 32;
    h *= UINT64_C(0xd6e8feb86659fd93);
    h ^= h >> 32;
    h *= UINT64_C(0xd6e8feb86659fd93);
    return h ^ h >> 32;
}

// Unit roundoff: no operation on doubles errs by more, relative to its result. It is 2^-52, that of directed rounding,
// for the FPU's mode is the host's; double rounding by x87 registers stays below it, too.
#define PARADT__ROUNDOFF 2.220446049250313080847263336181640625e-16

// Does arithmetic have at least that precision? x87 registers can be set to round to single precision, and some hosts
// set them so.
static int paradt__precise(void) {
#if defined(__i386__) || defined(_M_IX86)
    volatile double one = 1.0, above = one + 2.0 * PARADT__ROUNDOFF;
    return above > one;
#else
    return 1;
#endif
}

// Rounds x to a double where arithmetic may keep more digits in a register. Needed for a value that is used or compared
// in several places, which must all see the same number.
PARADT__INLINE double paradt__rounded(double x) {
    volatile double rounded = x;
    return rounded;
}

PARADT__INLINE double paradt__abs(double x) {
#if defined(__GNUC__) || defined(__clang__)
    return __builtin_fabs(x);
#else
    return x < 0 ? -x : x;
#endif
}

PARADT__INLINE double paradt__larger(double a, double b) {
    return a > b ? a : b;
}

// Returns the largest |x[i]| of count > 0 values.
PARADT__INLINE double paradt__largest(const double *x, int count) {
    double m = paradt__abs(x[0]);
    for (int i = 1; i < count; i++) m = paradt__larger(m, paradt__abs(x[i]));
    return m;
}

// Makes a double of a float's bits. A processor that is told to treat subnormal floats as zero would lose them in a
// conversion.
static double paradt__widen(uint32_t bits) {
    uint64_t sign = (uint64_t)(bits >> 31) << 63, exponent = bits >> 23 & 255, fraction = bits & 0x7fffff, wide;
    double x;
    if (exponent == 255) {
        wide = sign | (uint64_t)2047 << 52 | fraction << 29;
    } else if (exponent) {
        wide = sign | (exponent + 1023 - 127) << 52 | fraction << 29;
    } else if (!fraction) {
        wide = sign;
    } else {
        int shift = 0;
        while (!(fraction >> 23)) fraction <<= 1, shift++;
        wide = sign | (uint64_t)(1023 - 126 - shift) << 52 | (fraction & 0x7fffff) << 29;
    }
    memcpy(&x, &wide, sizeof x);
    return x;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>tasks
//
// What runs on several threads: progress and cancelling, teams of tasks, giving up, and pauses of insertions that work
// together; and the clock. Doors: paradt__progress_cancels, paradt__progress_of, paradt__meter_begin,
// paradt__meter_done, paradt__meter_cancels, paradt__progress_of_task, paradt__team_of, paradt__team_run,
// paradt__team_cancels, paradt__team_cancelled, paradt__alone, PARADT__GAVE_UP, paradt__relay_pauses,
// paradt__relay_waits, paradt__now.

// --- progress
//
// All tasks of a call add what they have done to one sum, and the callback gets the sum: it never falls, in whatever
// order the tasks run. One thread at a time is in the callback; another thread that would call it meanwhile goes on
// without. After the callback has cancelled the call, every task ends at its next call of paradt__progress_cancels.

enum { PARADT__ALL_DONE = 1 << 30 }; // the sum of all shares of a call's work
enum { PARADT__REPORT_STEP = 1024 }; // cells or insertions between two reports of progress

typedef struct paradt__meter {
    paradt_progress call; // NULL: none
    void *user;
    uint32_t done; // of PARADT__ALL_DONE
    int calling;   // 1: a thread is in the callback
    int cancelled;
} paradt__meter;

// The share of a call's work that one task does, or several that work through it together
typedef struct paradt__progress {
    paradt__meter *meter; // NULL: nobody asks
    uint32_t *reported;   // the part of the share that has been added to the meter
    double share;         // 0..1, of the whole call
} paradt__progress;

static void paradt__meter_begin(paradt__meter *meter, const paradt_options *options) {
    memset(meter, 0, sizeof *meter);
    if (!options) return;
    meter->call = options->progress;
    meter->user = options->user;
}

// Returns the part of the work that is done: 0..1
static double paradt__meter_done(const paradt__meter *meter) {
    double done = (double)PARADT__ATOMIC_LOAD(&meter->done) / (double)PARADT__ALL_DONE;
    return done < 1.0 ? done : 1.0;
}

// Calls the callback. Returns 1 when the call is to end.
static int paradt__meter_cancels(paradt__meter *meter) {
    if (!meter->call) return 0;
    if (!PARADT__ATOMIC_LOAD(&meter->cancelled) && PARADT__ATOMIC_LOCK(&meter->calling)) {
        if (!PARADT__ATOMIC_LOAD(&meter->cancelled) && meter->call(meter->user, paradt__meter_done(meter)))
            (void)PARADT__ATOMIC_ADD(&meter->cancelled, 1);
        PARADT__ATOMIC_UNLOCK(&meter->calling);
    }
    return PARADT__ATOMIC_LOAD(&meter->cancelled);
}

// A share of the work. *reported, 0 at first, is the caller's to keep for as long as somebody works on the share.
static paradt__progress paradt__progress_of(paradt__meter *meter, uint32_t *reported, double share) {
    paradt__progress progress;
    progress.meter = meter->call ? meter : NULL;
    progress.reported = reported;
    progress.share = share;
    return progress;
}

// Reports that about `fraction` of the share is done; to be called some hundred times a second. Returns 1 when the call
// is to end. Several threads may work on one share: the largest fraction counts.
static int paradt__progress_cancels(const paradt__progress *progress, double fraction) {
    uint32_t now, before;
    if (!progress->meter) return 0;
    if (fraction > 1.0) fraction = 1.0;
    now = (uint32_t)(fraction * progress->share * (double)PARADT__ALL_DONE);
    before = PARADT__ATOMIC_LOAD(progress->reported);
    while (before < now && !PARADT__ATOMIC_SWAP(progress->reported, &before, now)) {
    }
    if (before < now) (void)PARADT__ATOMIC_ADD(&progress->meter->done, now - before);
    return paradt__meter_cancels(progress->meter);
}

// The progress of a task that may run concurrently with others: without atomics only the first of them reports.
static paradt__progress paradt__progress_of_task(paradt__progress progress, size_t index) {
#if !defined(PARADT__ATOMICS)
    if (index) progress.meter = NULL;
#endif
    (void)index;
    return progress;
}

// --- teams

// Tasks that may run concurrently, for work that is divided by points
typedef struct paradt__team {
    paradt_parallel_for parallel_for; // NULL: one after another
    void *user;
    size_t tasks;              // 1..PARADT__MOST_TASKS
    paradt__progress progress; // of what they do together
} paradt__team;

enum { PARADT__MOST_TASKS = 4 };

static paradt__team paradt__team_of(const paradt_options *options, size_t regions, paradt__progress progress) {
    paradt__team team;
    team.parallel_for = options->parallel_for;
    team.user = options->user;
    team.tasks = options->parallel_for ? regions : 1;
    if (team.tasks > PARADT__MOST_TASKS) team.tasks = PARADT__MOST_TASKS;
    team.progress = progress;
    return team;
}

static const paradt__team paradt__alone = {NULL, NULL, 1, {NULL, NULL, 0.0}};

static void paradt__team_run(const paradt__team *team, void (*task)(void *context, size_t index), void *context) {
    if (team->tasks > 1) team->parallel_for(team->user, team->tasks, task, context);
    else task(context, 0);
}

// Reports, for the task `index` of a team, the `fraction` that is done of what the team does. Returns 1 when the call
// is to end.
static int paradt__team_cancels(const paradt__team *team, size_t index, double fraction) {
    paradt__progress progress = paradt__progress_of_task(team->progress, index);
    return paradt__progress_cancels(&progress, fraction);
}

// Has one of the tasks found that the call is to end?
static int paradt__team_cancelled(const paradt__team *team) {
    return team->progress.meter && PARADT__ATOMIC_LOAD(&team->progress.meter->cancelled);
}

// --- giving up, and pauses

// A status that stays inside the implementation: this way of building gave up, another one follows
#define PARADT__GAVE_UP ((paradt_status)PARADT_STATUS_COUNT)

// The common account of insertions that run concurrently and pause together
typedef struct paradt__relay {
    ptrdiff_t done; // work done by all of them, in inserted points. May be negative: paradt__relay_waits subtracts
    ptrdiff_t stop; // they pause when `done` is that much
} paradt__relay;

// Adds 64 steps of work to the account after every 64th step. Returns 1 when it is time to pause.
//   done    number of steps that this insertion has done
//   points  how many inserted points take as long as 64 steps
static int paradt__relay_pauses(paradt__relay *relay, size_t done, size_t points) {
#if defined(PARADT__ATOMICS)
    return relay && done % 64 == 0 && PARADT__ATOMIC_ADD(&relay->done, (ptrdiff_t)points) >= relay->stop;
#else
    (void)relay, (void)done, (void)points;
    return 0;
#endif
}

// Puts the pause off: one insertion begins what cannot be paused and takes as long as inserting `points` points.
PARADT__OPTIONAL void paradt__relay_waits(paradt__relay *relay, size_t points) {
#if defined(PARADT__ATOMICS)
    if (relay) PARADT__ATOMIC_ADD(&relay->done, -(ptrdiff_t)points);
#else
    (void)relay, (void)points;
#endif
}

// --- the clock

// Seconds of wall time, from some moment on. Of the system's clocks it is the best that the language standard in use
// lets <time.h> declare; gettimeofday is declared by any, where there is <sys/time.h>. Without any of them, processor
// time.
static double paradt__now(void) {
#if defined(CLOCK_MONOTONIC) && !defined(__MINGW32__) // there it would take another library
    struct timespec now;
    if (!clock_gettime(CLOCK_MONOTONIC, &now)) return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
#elif defined(TIME_UTC)
    struct timespec now;
    if (timespec_get(&now, TIME_UTC)) return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
#elif defined(PARADT__TIMEVAL)
    struct timeval now;
    if (!gettimeofday(&now, NULL)) return (double)now.tv_sec + 1e-6 * (double)now.tv_usec;
#endif
#if defined(__wasi__) // has no clock()
    return 0.0;
#else
    return (double)clock() / (double)CLOCKS_PER_SEC;
#endif
}

// ---------------------------------------------------------------------------------------------------------------------
// >>space
//
// What the predicates know of a set of points: the exponents of its numbers, its extents, and bounds for the filters.
// This section and the next four give the signs of determinants of doubles, exactly for all finite ones.
//
// The determinants are those of the differences between some points and one of them, the base: k columns of
// coordinates for the orientation, and one more for the in-sphere test, the lift |x - base|^2 - (w - w_base). The lift
// differs from |x|^2 - w by a linear function of x, so that the determinant is the same. A determinant is a multiple of
// its quantum, the product of its columns' units. There are four stages; each passes on what it cannot decide:
//   filter   in doubles (>>filters), with an error bound that holds for every order, contraction and rounding that the
//            compiler and the FPU may choose. If the quantum exceeds value and error together, the determinant is 0: so
//            lattices hardly ever need another stage.
//   small    by minors in wide integers (>>exact): 128 bits, or 64 where there are no such integers
//   fixed    for 2 and 3 columns, differences of at most 60 or 117 bits (one or two digits): loops of constant length
//   general  for any exponents and any dimension, with as many digits as it takes
// No stage allocates. The general stage takes 16 KB of stack, which suffices for all determinants in 2 and 3
// dimensions, or 63 KB: in 4 dimensions if exponents are more than 1100 apart, in 6 dimensions 250, in 8 dimensions in
// most in-sphere tests that get there. A predicate, compiled with optimisation, takes less than 26 KB in all in 2 and 3
// dimensions and 73 KB in more. The other stages take 9 KB.
// Filters with bounds for a whole set come from Fortune and Van Wyk (Efficient exact arithmetic for computational
// geometry, SCG 1993), stages that adapt to each call from Shewchuk (Adaptive precision floating-point arithmetic and
// fast robust geometric predicates, DCG 18, 1997). The exact stages compute with integers instead of his expansions.
// Doors: paradt__measure, paradt__space_is_finite, paradt__space_begin, paradt__space_add, paradt__space_join,
// paradt__space_end, paradt__compare, paradt__rounding.

// Columns and rows of the largest determinant; at least 4 and 5, as the code for 4 dimensions names each by a constant.
#define PARADT__MAX_COLUMNS (PARADT_MAX_DIM > 4 ? PARADT_MAX_DIM : 4)
#define PARADT__MAX_ROWS    (PARADT__MAX_COLUMNS + 1)

typedef struct paradt__counters {
    uint64_t orient_calls, insphere_calls, exact_small, exact_fixed, exact_general, perturbed;
} paradt__counters;

// The exponents of some doubles. If all of them are 0, unit > top.
typedef struct paradt__range {
    int unit;   // each is a multiple of 2^unit
    int bottom; // each is 0 or at least 2^bottom in size
    int top;    // each is less than 2^top in size
} paradt__range;

// A filter's bounds for determinants of one kind
typedef struct paradt__bounds {
    double factor;  // the error by rounding is at most this times the product of the columns' largest entries
    double certain; // an error bound for all points of the set
    double quantum; // a bit less than the quantum, of which each determinant is a multiple
} paradt__bounds;

// The predicates may only be asked about points that were measured. Each thread needs a space of its own, as the
// predicates count their calls in it. After measuring, dim and ambient may be lowered and the axes of all points be
// permuted.
typedef struct paradt__space {
    int dim;      // k: orientations are those of the first k coordinates
    int ambient;  // d >= k: all d coordinates enter the lift (the points lie in a k-flat, a graph over the first k)
    int weighted; // 1: a point's weight follows its d coordinates and is subtracted from its lift
    int filtered; // 1: each coordinate is 0 or 2^-120..2^120 in size, each weight 0 or 2^-240..2^240
    int bounded;  // 1: the filters cannot overflow. They need no lower bound of sizes: see paradt__space_end
    paradt__range coordinates;
    paradt__range weights;
    int64_t low[PARADT_MAX_DIM];               // ordered bits of the smallest ...
    int64_t high[PARADT_MAX_DIM];              // ... and the largest coordinate on each axis, as measured
    double per_unit;                           // 2^-unit if all coordinates are below 2^59 units in size, else 0
    double tiny;                               // no filter errs by more than this by underflow
    paradt__bounds orient[PARADT__MAX_ROWS];   // of orientations in k dimensions
    paradt__bounds insphere[PARADT__MAX_ROWS]; // of in-sphere tests in k dimensions
    double orient_certain;                     // the largest `certain` of all orientations, k = 1..d
    double orient_quantum;                     // the smallest `quantum` of all orientations
    paradt__counters counters;
} paradt__space;

static const paradt__range paradt__no_range = {4000, 4000, -4000};

// Extends the range to x, whatever x is.
PARADT__NOINLINE void paradt__measure_anew(paradt__range *range, double x) {
    int e;
    uint64_t mantissa = paradt__split(x, &e);
    if (!mantissa) return;
    int top = e + paradt__bit_length(mantissa);
    range->unit = paradt__min(range->unit, e + paradt__trailing_zeros(mantissa));
    range->bottom = paradt__min(range->bottom, top - 1);
    range->top = paradt__max(range->top, top);
}

// Extends the range to x. Most numbers do not extend it, which their exponents and last bits show. Numbers that are not
// finite count as 2^1024.
PARADT__INLINE void paradt__measure(paradt__range *range, double x) {
    uint64_t bits = paradt__bits(x);
    int biased = (int)(bits >> 52 & 2047), top = biased - 1022;
    int unit = biased - 1075 + paradt__trailing_zeros(bits | (uint64_t)1 << 52);
    if (!PARADT__LIKELY((biased > 0) & (unit >= range->unit) & (top > range->bottom) & (top <= range->top)))
        paradt__measure_anew(range, x);
}

// Are all coordinates and weights that were measured finite?
static int paradt__space_is_finite(const paradt__space *s) {
    return s->coordinates.top <= 1024 && s->weights.top <= 1024;
}

static void paradt__range_join(paradt__range *range, const paradt__range *other) {
    range->unit = paradt__min(range->unit, other->unit);
    range->bottom = paradt__min(range->bottom, other->bottom);
    range->top = paradt__max(range->top, other->top);
}

// Begins to measure a set, of any number of points: paradt__space_add follows for each, then paradt__space_end. dim: -1
// where there are no points
static void paradt__space_begin(paradt__space *s, int dim, int ambient, int weighted) {
    PARADT_ASSERT(dim >= -1 && dim <= ambient && ambient <= PARADT_MAX_DIM);
    memset(s, 0, sizeof *s);
    s->dim = dim;
    s->ambient = ambient;
    s->weighted = weighted;
    s->coordinates = s->weights = paradt__no_range;
    for (int j = 0; j < ambient; j++) {
        s->low[j] = INT64_MAX;
        s->high[j] = INT64_MIN;
    }
}

// Measures a point: its coordinates and, in a weighted space, its weight.
PARADT__INLINE void paradt__space_add(paradt__space *s, const double *p) {
    for (int j = 0; j < s->ambient; j++) {
        int64_t x = paradt__ordered_bits(p[j]);
        paradt__measure(&s->coordinates, p[j]);
        if (x < s->low[j]) s->low[j] = x;
        if (x > s->high[j]) s->high[j] = x;
    }
    if (s->weighted) paradt__measure(&s->weights, p[s->ambient]);
}

// Returns a bit less than 2^exponent, for comparisons with rounded values; 0 if that is too small for the filters.
static double paradt__quantum(int exponent) {
    return exponent < -900 ? 0 : paradt__power(paradt__min(exponent, 1000)) * (1 - 8 * PARADT__ROUNDOFF);
}

// Returns the factor of a filter's error by rounding: the error is at most the factor times P, the product of the m_j,
// where m_j is the largest size in column j of n columns. Let u be the roundoff.
//
// Minors (k = 2, 3, 4). The determinant is a sum of n! monomials, where an entry of the lift counts as one value. A
// computed monomial has been rounded at most c times, however sums are ordered and products contracted: once by each
// product, and by a sum once less than the sum has terms.
//   k = 2  2 differences, and 2 for a pair (a product, a sum of two): 4. With the lift: its 2 differences, a product,
//          d + 1 <= 9 additions, and 3 for the last product and sum: 19
//   k = 3  3 + 2 + 3 = 8; with the lift 8 + 12 + 4 = 24
//   k = 4  4 + 2 pairs' 4 + 6 = 14; with the lift 14 + 12 + 5 = 31
// To first order the error is at most c u S, where S is the sum of the monomials' sizes, and S <= n! P. The factor is
// twice as large, which covers the higher orders, the errors of the computed m_j, and the rounding of the bound itself.
//
// Elimination with row pivoting (all other k). Entries begin with errors of at most 12 u m_j. After t steps they are at
// most 2^t m_j in size, as multipliers are at most 1 in size; a multiplier, by a division or a product with a
// reciprocal, errs by 3 u. Each of an entry's n - 1 products and n - 1 differences, in whatever order, errs by at most
// 2^(n-1) u m_j, and the multipliers contribute three times as much. So the computed pivots are exactly those of a
// matrix whose entries differ by at most e m_j, e = ((2 n + 1) 2^(n-1) + 12) u. By Hadamard's bound the determinant of
// that matrix differs by at most n e h P to first order, h = n^(n/2); the product of the pivots adds n u of itself.
// Again the factor is twice as large.
static double paradt__rounding(int k, int n) {
    static const int roundings[3][2] = {{4, 19}, {8, 24}, {14, 31}}, factorial[] = {1, 1, 2, 6, 24, 120};
    static const double hadamard[] = {1, 1, 2, 6, 16, 56, 216, 908, 4096, 19684};
    PARADT_ASSERT(k >= 1 && k <= PARADT_MAX_DIM && (n == k || n == k + 1));
    if (k >= 2 && k <= 4) return 2 * PARADT__ROUNDOFF * roundings[k - 2][n - k] * factorial[n];
    return 2 * PARADT__ROUNDOFF * n * ((2 * n + 1) * (1 << (n - 1)) + 12) * hadamard[n];
}

// Adds what another space has measured.
static void paradt__space_join(paradt__space *s, const paradt__space *other) {
    for (int j = 0; j < s->ambient; j++) {
        if (other->low[j] < s->low[j]) s->low[j] = other->low[j];
        if (other->high[j] > s->high[j]) s->high[j] = other->high[j];
    }
    paradt__range_join(&s->coordinates, &other->coordinates);
    paradt__range_join(&s->weights, &other->weights);
}

// Ends measuring: derives the bounds.
//
// Underflow, or flushing results and operands to zero, adds an error of at most 2^-1022 for each operation. Let Q be
// the product of the max(1, m_j). With minors there are less than 2^13 operations, and each error is multiplied by
// other entries, at most Q in size together, in at most n! < 2^19 monomials. With elimination an error is multiplied by
// pivots, in at most n h 2^n < 2^36 ways (2^n because pivots grow) of 2^3 operations each. A column without a pivot
// above 1e-300 makes the determinant less than 2^36 1e-300 Q. All of that is below 2^-959 Q. No value exceeds 2^36 Q,
// so that nothing overflows if 2^36 Q < 2^1023.
static void paradt__space_end(paradt__space *s) {
    const int d = s->ambient, unit = s->coordinates.unit, top = paradt__max(s->coordinates.top + 1, 0);
    const int lift_top = paradt__max(2 * top + 3, s->weights.top + 1) + 1, growth = d * top + lift_top; // Q <= 2^growth
    const int lift_unit = s->weighted ? paradt__min(2 * unit, s->weights.unit) : 2 * unit;
    double extents[PARADT_MAX_DIM], product = 1, lift = 0;
    const int precise = paradt__precise();
    s->filtered = precise && s->coordinates.top <= 120 && s->coordinates.bottom >= -120 && s->weights.top <= 240 &&
                  s->weights.bottom >= -240;
    s->bounded = precise && growth <= 940;
    s->tiny = s->bounded ? paradt__power(growth - 950) : 0;
    // these products and conversions are exact in any rounding mode, and none of them can be flushed to zero
    s->per_unit = 0;
    if (precise && unit >= -900 && unit < s->coordinates.top && s->coordinates.top <= paradt__min(unit + 59, 900))
        s->per_unit = paradt__power(-unit);
    if (!s->bounded) return;
    for (int j = 0; j < d; j++) { // extents in descending order: no k of them have a larger product than the first k
        double extent = 0;
        int i = j;
        if (s->low[j] < s->high[j])
            extent = paradt__from_ordered_bits(s->high[j]) - paradt__from_ordered_bits(s->low[j]);
        for (; i > 0 && extents[i - 1] < extent; i--) extents[i] = extents[i - 1];
        extents[i] = extent;
        lift += extent * extent;
    }
    if (s->weighted && s->weights.top > -1000) lift += 2 * paradt__power(s->weights.top);
    s->orient_certain = 0;
    s->orient_quantum = paradt__quantum(1000);
    for (int k = 1; k <= d; k++) {
        paradt__bounds *orient = &s->orient[k], *insphere = &s->insphere[k];
        product *= extents[k - 1];
        orient->factor = paradt__rounding(k, k);
        orient->certain = orient->factor * product + s->tiny;
        orient->quantum = paradt__quantum(k * unit);
        insphere->factor = paradt__rounding(k, k + 1);
        insphere->certain = insphere->factor * product * lift + s->tiny;
        insphere->quantum = paradt__quantum(k * unit + lift_unit);
        s->orient_certain = paradt__larger(s->orient_certain, orient->certain);
        s->orient_quantum = -paradt__larger(-s->orient_quantum, -orient->quantum);
    }
}

// Compares two points lexicographically by the first dim coordinates: -1, 0 or 1.
PARADT__INLINE int paradt__compare(const paradt__space *s, const double *a, const double *b) {
    for (int j = 0; j < s->dim; j++) {
        if (s->filtered) { // no number is so small that it could be flushed to zero
            if (a[j] != b[j]) return a[j] < b[j] ? -1 : 1;
        } else {
            int64_t x = paradt__ordered_bits(a[j]), y = paradt__ordered_bits(b[j]);
            if (x != y) return x < y ? -1 : 1;
        }
    }
    return 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>filters
//
// Determinants in doubles. A filter returns the determinant's sign, or PARADT__UNDECIDED if rounding may have changed
// it. The space must be bounded, so that nothing overflows, and its points measured. A filter first compares with the
// error bound for all points of the set, which costs nothing; only where that does not decide, it computes the bound
// for its points. The bounds are derived in >>space.
// Doors: paradt__filter_orient2, paradt__filter_orient3, paradt__filter_insphere2, paradt__filter_insphere3,
// paradt__filter4, paradt__filter_any.

#define PARADT__UNDECIDED 2

// The last step of each filter. largest: the product of the columns' largest entries
PARADT__INLINE int paradt__decide(paradt__space *s, double value, double largest, const paradt__bounds *b) {
    double error = b->factor * largest + s->tiny;
    if (value > error) return 1;
    if (value < -error) return -1;
    if (paradt__abs(value) + error >= b->quantum) return PARADT__UNDECIDED;
    s->counters.exact_small++;
    return 0;
}

// The orientation of p[0..2]
PARADT__INLINE int paradt__filter_orient2(paradt__space *s, const double *const *p) {
    const double *o = p[0], *a = p[1], *b = p[2];
    double ax = a[0] - o[0], ay = a[1] - o[1], bx = b[0] - o[0], by = b[1] - o[1];
    double det = ax * by - bx * ay;
    if (paradt__abs(det) > s->orient[2].certain) return det > 0 ? 1 : -1;
    double x = paradt__larger(paradt__abs(ax), paradt__abs(bx)), y = paradt__larger(paradt__abs(ay), paradt__abs(by));
    return paradt__decide(s, det, x * y, &s->orient[2]);
}

// The orientation of p[0..3]
PARADT__INLINE int paradt__filter_orient3(paradt__space *s, const double *const *p) {
    const double *o = p[0], *a = p[1], *b = p[2], *c = p[3];
    double x[3] = {a[0] - o[0], b[0] - o[0], c[0] - o[0]};
    double y[3] = {a[1] - o[1], b[1] - o[1], c[1] - o[1]};
    double z[3] = {a[2] - o[2], b[2] - o[2], c[2] - o[2]};
    double det =
        (x[0] * y[1] - x[1] * y[0]) * z[2] + (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1];
    if (paradt__abs(det) > s->orient[3].certain) return det > 0 ? 1 : -1;
    return paradt__decide(s, det, paradt__largest(x, 3) * paradt__largest(y, 3) * paradt__largest(z, 3), &s->orient[3]);
}

// Completes the lift of the point a over the base o: adds the squares of coordinates k..d - 1 to `lift`, the sum of the
// first k squares, and subtracts the weights' difference. *size: a bound of the lift's size, for the error
PARADT__INLINE double paradt__lift_rest(double lift, double *size, int k, int d, int weighted, const double *a,
                                        const double *o) {
    for (int j = k; j < d; j++) lift += (a[j] - o[j]) * (a[j] - o[j]);
    *size = weighted ? lift + (paradt__abs(a[d]) + paradt__abs(o[d])) : lift;
    return weighted ? lift - (a[d] - o[d]) : lift;
}

// Is p[3] inside the circle of p[0..2]? d >= 2: the coordinates of the lift
PARADT__INLINE int paradt__filter_insphere2(paradt__space *s, const double *const *p, int d, int weighted) {
    const double *o = p[3];
    double x[3], y[3], lift[3], size[3], det;
    for (int i = 0; i < 3; i++) {
        x[i] = p[i][0] - o[0];
        y[i] = p[i][1] - o[1];
        lift[i] = paradt__lift_rest(x[i] * x[i] + y[i] * y[i], &size[i], 2, d, weighted, p[i], o);
    }
    det = (x[0] * y[1] - x[1] * y[0]) * lift[2] + (x[1] * y[2] - x[2] * y[1]) * lift[0] +
          (x[2] * y[0] - x[0] * y[2]) * lift[1];
    if (paradt__abs(det) > s->insphere[2].certain) return det > 0 ? 1 : -1;
    return paradt__decide(s, det, paradt__largest(x, 3) * paradt__largest(y, 3) * paradt__largest(size, 3),
                          &s->insphere[2]);
}

// The sum of the sizes of all monomials of four rows. It is at most 24 times the product of the columns' largest
// entries, and much less if some rows are small, as those of points on a curve are.
static double paradt__monomials4(const double *x, const double *y, const double *z, const double *lift) {
    double a[4], b[4], c[4], sum = 0;
    for (int i = 0; i < 4; i++) {
        a[i] = paradt__abs(x[i]);
        b[i] = paradt__abs(y[i]);
        c[i] = paradt__abs(z[i]);
    }
    for (int i = 0; i < 4; i++) {
        int j = (i + 1) & 3, k = (i + 2) & 3, l = (i + 3) & 3;
        sum += lift[i] * ((a[j] * b[k] + a[k] * b[j]) * c[l] + (a[k] * b[l] + a[l] * b[k]) * c[j] +
                          (a[l] * b[j] + a[j] * b[l]) * c[k]);
    }
    return sum;
}

// Is p[4] inside the sphere of p[0..3]? d >= 3: the coordinates of the lift
PARADT__INLINE int paradt__filter_insphere3(paradt__space *s, const double *const *p, int d, int weighted) {
    const double *o = p[4];
    double x[4], y[4], z[4], lift[4], size[4], det;
    for (int i = 0; i < 4; i++) {
        x[i] = p[i][0] - o[0];
        y[i] = p[i][1] - o[1];
        z[i] = p[i][2] - o[2];
        lift[i] = paradt__lift_rest(x[i] * x[i] + y[i] * y[i] + z[i] * z[i], &size[i], 3, d, weighted, p[i], o);
    }
    double xy01 = x[0] * y[1] - x[1] * y[0], xy12 = x[1] * y[2] - x[2] * y[1], xy23 = x[2] * y[3] - x[3] * y[2];
    double xy30 = x[3] * y[0] - x[0] * y[3], xy02 = x[0] * y[2] - x[2] * y[0], xy13 = x[1] * y[3] - x[3] * y[1];
    double xyz012 = xy01 * z[2] + xy12 * z[0] - xy02 * z[1], xyz123 = xy12 * z[3] + xy23 * z[1] - xy13 * z[2];
    double xyz230 = xy23 * z[0] + xy30 * z[2] + xy02 * z[3], xyz301 = xy30 * z[1] + xy01 * z[3] + xy13 * z[0];
    // minus the determinant of the rows (x, y, z, lift): in odd dimensions its sign is negative inside
    det = (xyz123 * lift[0] - xyz230 * lift[1]) + (xyz301 * lift[2] - xyz012 * lift[3]);
    if (paradt__abs(det) > s->insphere[3].certain) return det > 0 ? 1 : -1;
    double largest = paradt__largest(x, 4) * paradt__largest(y, 4) * paradt__largest(z, 4) * paradt__largest(size, 4);
    int sign = paradt__decide(s, det, largest, &s->insphere[3]);
    if (sign != PARADT__UNDECIDED) return sign;
    return paradt__decide(s, det, paradt__monomials4(x, y, z, size) / 24, &s->insphere[3]);
}

// The determinant of four of five rows, without row `out`. xy[i][j], zw[i][j]: the determinants of rows i and j in the
// first two and in the last two columns
PARADT__INLINE double paradt__without(double (*xy)[5], double (*zw)[5], int out) {
    const int a = out == 0, b = 1 + (out <= 1), c = 2 + (out <= 2), d = 3 + (out <= 3);
    return (xy[a][b] * zw[c][d] - xy[a][c] * zw[b][d]) + (xy[a][d] * zw[b][c] + xy[b][c] * zw[a][d]) +
           (xy[c][d] * zw[a][b] - xy[b][d] * zw[a][c]);
}

// Either determinant in 4 dimensions, of rows p[0..n-1] - base: n = 4 for the orientation, 5 for the in-sphere test
PARADT__INLINE int paradt__filter4(paradt__space *s, const double *const *p, const double *base, int n, int d) {
    double x[4][5], xy[5][5], zw[5][5], lift[5], size[5], det, largest = 1;
    const paradt__bounds *b = n == 4 ? &s->orient[4] : &s->insphere[4];
    PARADT__UNROLL
    for (int i = 0; i < n; i++) {
        PARADT__UNROLL
        for (int j = 0; j < 4; j++) x[j][i] = p[i][j] - base[j];
        if (n == 5)
            lift[i] = paradt__lift_rest(x[0][i] * x[0][i] + x[1][i] * x[1][i] + x[2][i] * x[2][i] + x[3][i] * x[3][i],
                                        &size[i], 4, d, s->weighted, p[i], base);
    }
    PARADT__UNROLL
    for (int i = 0; i < n; i++) {
        PARADT__UNROLL
        for (int j = i + 1; j < n; j++) {
            xy[i][j] = x[0][i] * x[1][j] - x[0][j] * x[1][i];
            zw[i][j] = x[2][i] * x[3][j] - x[2][j] * x[3][i];
        }
    }
    det = paradt__without(xy, zw, 4);
    if (n == 5)
        det = (det * lift[4] - paradt__without(xy, zw, 3) * lift[3]) +
              (paradt__without(xy, zw, 2) * lift[2] - paradt__without(xy, zw, 1) * lift[1]) +
              paradt__without(xy, zw, 0) * lift[0];
    if (paradt__abs(det) > b->certain) return det > 0 ? 1 : -1;
    for (int j = 0; j < 4; j++) largest *= paradt__largest(x[j], n);
    return paradt__decide(s, det, n == 5 ? largest * paradt__largest(size, 5) : largest, b);
}

// Returns the determinant of n rows by elimination with pivots, or 0 if there is no pivot. Overwrites a.
PARADT__INLINE double paradt__eliminate(double (*a)[PARADT__MAX_ROWS], int n) {
    double det = 1;
    for (int t = 0; t < n; t++) {
        int pivot = t;
        for (int i = t + 1; i < n; i++)
            if (paradt__abs(a[i][t]) > paradt__abs(a[pivot][t])) pivot = i;
        // a pivot so small is noise of underflow, and its reciprocal would overflow
        if (!(paradt__abs(a[pivot][t]) > 1e-300)) return 0;
        if (pivot != t) {
            det = -det;
            for (int j = t; j < n; j++) {
                double swap = a[t][j];
                a[t][j] = a[pivot][j];
                a[pivot][j] = swap;
            }
        }
        det *= a[t][t];
        for (int i = t + 1; i < n; i++) {
            double m = a[i][t] / a[t][t];
            for (int j = t + 1; j < n; j++) a[i][j] -= m * a[t][j];
        }
    }
    return det;
}

// Either determinant in any dimension, of rows p[0..n-1] - base: k coordinates and, if n > k, the lift over d
// coordinates
PARADT__INLINE int paradt__filter_any(paradt__space *s, const double *const *p, const double *base, int n, int k,
                                      int d) {
    double a[PARADT__MAX_ROWS][PARADT__MAX_ROWS], largest[PARADT__MAX_ROWS] = {0}, det, product = 1;
    PARADT_ASSERT(n <= PARADT__MAX_ROWS && (n == k || n == k + 1) && k <= d);
    for (int i = 0; i < n; i++) {
        double lift = 0, size;
        for (int j = 0; j < k; j++) {
            a[i][j] = p[i][j] - base[j];
            largest[j] = paradt__larger(largest[j], paradt__abs(a[i][j]));
            lift += a[i][j] * a[i][j];
        }
        if (n == k) continue;
        a[i][k] = paradt__lift_rest(lift, &size, k, d, s->weighted, p[i], base);
        largest[k] = paradt__larger(largest[k], size);
    }
    det = paradt__eliminate(a, n);
    for (int j = 0; j < n; j++) product *= largest[j];
    if (n > k && k & 1) det = -det;
    return paradt__decide(s, det, product, n == k ? &s->orient[k] : &s->insphere[k]);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>digits
//
// Integers of any length, for determinants that no machine integer holds. paradt__wide is the widest integer that the
// compiler computes with. A longer number is an array of digits in base 2^PARADT__RADIX, least significant first, and
// balanced: -2^(RADIX - 1) <= digit <= 2^(RADIX - 1), where the last digit may be larger if that is stated. Products
// are summed digit by digit in an array of wide integers, a sum; PARADT__SUMMANDS products fit before carries must be
// taken. So a sum has neither a carry nor a sign to care for, the sign of a number is that of its highest digit other
// than 0, and the difference of two doubles has few digits other than 0, however far apart their exponents are.
// Functions whose names end in _any are for numbers of any length; the others are unrolled, for constant lengths.
// Doors: paradt__digit_count, paradt__low_digit, paradt__carry, paradt__sign, paradt__clear, paradt__clear_any,
// paradt__multiply_add, paradt__multiply_add_any, paradt__add_shifted, paradt__make_room, paradt__store,
// paradt__store_any.

#ifdef __SIZEOF_INT128__
__extension__ typedef __int128 paradt__wide;
typedef int64_t paradt__digit;
#define PARADT__WIDE_BITS 127 // without the sign
#define PARADT__RADIX     60
#else
typedef int64_t paradt__wide;
typedef int32_t paradt__digit;
#define PARADT__WIDE_BITS 63
#define PARADT__RADIX     28
#endif

// The number of products of two balanced digits that fit into a wide integer beside a carry: 508
#define PARADT__SUMMANDS ((1 << (PARADT__WIDE_BITS - 2 * (PARADT__RADIX - 1))) - 4)

// The number of digits, the last one balanced too, of an integer below 2^bits in size
PARADT__INLINE int paradt__digit_count(int bits) {
    return bits / PARADT__RADIX + 1;
}

// Returns the balanced digit of x = digit + 2^PARADT__RADIX * carry.
PARADT__INLINE paradt__digit paradt__low_digit(paradt__wide x) {
    const int above = 8 * (int)sizeof(paradt__digit) - PARADT__RADIX;
    return (paradt__digit)((paradt__digit)((uint64_t)x << above) >> above);
}

// Returns the carry of the same sum.
PARADT__INLINE paradt__wide paradt__carry(paradt__wide x) {
    return (x + ((paradt__wide)1 << (PARADT__RADIX - 1))) >> PARADT__RADIX;
}

// The sign of a number, -1, 0 or 1
PARADT__INLINE int paradt__sign(const paradt__digit *digits, int count) {
    PARADT_ASSERT(count > 0);
    while (count > 1 && !digits[count - 1]) count--;
    return (digits[count - 1] > 0) - (digits[count - 1] < 0);
}

PARADT__INLINE void paradt__clear(paradt__wide *sum, int count) {
    PARADT__UNROLL
    for (int i = 0; i < count; i++) sum[i] = 0;
}

PARADT__INLINE void paradt__clear_any(paradt__wide *sum, int count) {
    memset(sum, 0, (size_t)count * sizeof *sum);
}

// Adds sign * a[an] * b[bn] to the sum. Each of its elements receives at most min(an, bn) products of digits.
PARADT__INLINE void paradt__multiply_add(paradt__wide *sum, int sign, const paradt__digit *a, int an,
                                         const paradt__digit *b, int bn) {
    PARADT__UNROLL
    for (int i = 0; i < an; i++) {
        paradt__digit x = sign < 0 ? -a[i] : a[i];
        PARADT__UNROLL
        for (int j = 0; j < bn; j++) sum[i + j] += (paradt__wide)x * b[j];
    }
}

PARADT__INLINE void paradt__multiply_add_any(paradt__wide *sum, int sign, const paradt__digit *a, int an,
                                             const paradt__digit *b, int bn) {
    for (int i = 0; i < an; i++, sum++) {
        paradt__digit x = sign < 0 ? -a[i] : a[i];
        if (!x) continue; // long differences have few digits other than 0
        PARADT__UNROLL_4
        for (int j = 0; j < bn; j++) sum[j] += (paradt__wide)x * b[j];
    }
}

// Adds sign * mantissa * 2^shift to the sum; mantissa < 2^53, shift >= 0. A summand of an element is below
// 2^(2 RADIX - 1).
PARADT__INLINE void paradt__add_shifted(paradt__wide *sum, int sign, uint64_t mantissa, int shift) {
    const uint64_t mask = ((uint64_t)1 << PARADT__RADIX) - 1;
    PARADT_ASSERT(shift >= 0);
    for (sum += shift / PARADT__RADIX; mantissa; mantissa >>= PARADT__RADIX) {
        paradt__wide part = (paradt__wide)(mantissa & mask) << shift % PARADT__RADIX;
        *sum++ += sign < 0 ? -part : part;
    }
}

// Takes the carries of sum[count] in place.
PARADT__INLINE void paradt__balance(paradt__wide *sum, int count) {
    for (int i = 0; i + 1 < count; i++) {
        sum[i + 1] += paradt__carry(sum[i]);
        sum[i] = paradt__low_digit(sum[i]);
    }
}

// Prepares sum[count] for another `products` products an element. *used counts those since the last carries.
PARADT__INLINE void paradt__make_room(paradt__wide *sum, int count, int *used, int products) {
    PARADT_ASSERT(products <= PARADT__SUMMANDS);
    *used += products;
    if (*used <= PARADT__SUMMANDS) return;
    paradt__balance(sum, count);
    *used = products;
}

// Takes the carries of sum[count] and writes the digits of the number. The last digit is what remains, balanced or not.
PARADT__INLINE void paradt__store(paradt__digit *digits, const paradt__wide *sum, int count) {
    paradt__wide carry = 0;
    PARADT__UNROLL
    for (int i = 0; i + 1 < count; i++) {
        carry += sum[i];
        digits[i] = paradt__low_digit(carry);
        carry = paradt__carry(carry);
    }
    digits[count - 1] = (paradt__digit)(carry + sum[count - 1]);
}

PARADT__INLINE void paradt__store_any(paradt__digit *digits, const paradt__wide *sum, int count) {
    paradt__wide carry = 0;
    for (int i = 0; i + 1 < count; i++) {
        carry += sum[i];
        digits[i] = paradt__low_digit(carry);
        carry = paradt__carry(carry);
    }
    digits[count - 1] = (paradt__digit)(carry + sum[count - 1]);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>exact
//
// The exact stages: signs of determinants in integers, for what the filters left undecided. The columns and the bits of
// their numbers decide which stage takes a determinant (paradt__exact_inline). The small stage expands it by minors in
// wide integers; the fixed stage does the same with numbers of one or two digits, unrolled; the general stage takes
// numbers of any length. Coordinates are integers in a unit, a power of two of which all are multiples. The lifts' unit
// is the square of that unit, or less if the weights need it.
// Doors: paradt__exact_insphere3, paradt__exact_orient, paradt__exact_insphere.

// ceil(log2(n!)): a determinant of n rows has at most so many bits more than the product of its columns
static const int paradt__log_factorial[] = {0, 0, 1, 3, 5, 7, 10, 13, 16, 19};

// The determinant of the n rows row[i] - base: k columns of coordinates and, if n > k, the lift over d coordinates
typedef struct paradt__determinant {
    int n, k, d, weighted;
    const double *const *row;
    const double *base;
} paradt__determinant;

// The range of the coordinates (or weights) first..end - 1 of all rows and the base
static paradt__range paradt__measure_columns(const paradt__determinant *q, int first, int end) {
    paradt__range range = paradt__no_range;
    for (int j = first; j < end; j++) {
        for (int i = 0; i < q->n; i++) paradt__measure(&range, q->row[i][j]);
        paradt__measure(&range, q->base[j]);
    }
    return range;
}

// Returns the mantissa of |x| / 2^unit = mantissa * 2^*shift. x: a multiple of 2^unit
PARADT__INLINE uint64_t paradt__mantissa(double x, int unit, int *shift) {
    int e;
    uint64_t mantissa = paradt__split(x, &e);
    *shift = mantissa ? paradt__max(e - unit, 0) : 0;
    return mantissa ? mantissa >> paradt__max(unit - e, 0) : 0;
}

// --- numbers that fit: the small stage

// The entries of a determinant as integers: differences of at most 60 bits and a sign
typedef struct paradt__fixed {
    int unit;      // exponent of the coordinates' unit; that of the lifts is 2 * unit
    int bits;      // differences are below 2^bits in size
    int lift_bits; // lifts are below 2^lift_bits in size
    int64_t x[PARADT__MAX_ROWS][PARADT__MAX_COLUMNS];
    paradt__wide lift[PARADT__MAX_ROWS];
} paradt__fixed;

// Returns x / 2^unit, for |x| < 2^(unit + 59), and adds the bits below the unit to *lost.
PARADT__INLINE int64_t paradt__fix(double x, int unit, uint64_t *lost) {
    int e, drop;
    uint64_t mantissa = paradt__split(x, &e) << 10;
    drop = paradt__min(unit + 10 - e, 63);
    *lost |= mantissa & (((uint64_t)1 << drop) - 1);
    return paradt__bits(x) >> 63 ? -(int64_t)(mantissa >> drop) : (int64_t)(mantissa >> drop);
}

// Fills f->x in the unit of the set, which s->per_unit must allow.
PARADT__INLINE void paradt__fix_by_set(paradt__fixed *f, const paradt__space *s, const paradt__determinant *q,
                                       int columns) {
    f->unit = s->coordinates.unit;
    f->bits = s->coordinates.top + 1 - f->unit;
    PARADT__UNROLL
    for (int j = 0; j < columns; j++) {
        int64_t base = (int64_t)(q->base[j] * s->per_unit);
        PARADT__UNROLL
        for (int i = 0; i < q->n; i++) f->x[i][j] = (int64_t)(q->row[i][j] * s->per_unit) - base;
    }
}

// Fills f->x in the largest unit of which all differences are multiples. Returns 0 if they need more bits, or if a
// weight needs a smaller unit.
PARADT__NOINLINE int paradt__fix_by_bits(paradt__fixed *f, const paradt__determinant *q, int columns,
                                         const paradt__range *weights) {
    uint64_t top = 0, lost = 0, any = 0, size = 0;
    int spare;
    for (int i = 0; i <= q->n; i++) {
        const double *x = i < q->n ? q->row[i] : q->base;
        for (int j = 0; j < columns; j++) {
            uint64_t doubled = paradt__bits(x[j]) << 1; // without the sign
            top = doubled > top ? doubled : top;
        }
    }
    f->unit = paradt__max((int)(top >> 53), 1) - 1022 - 59; // coordinates are below 2^(biased exponent - 1022)
    for (int j = 0; j < columns; j++) {
        int64_t base = paradt__fix(q->base[j], f->unit, &lost);
        for (int i = 0; i < q->n; i++) {
            int64_t x = f->x[i][j] = paradt__fix(q->row[i][j], f->unit, &lost) - base;
            any |= (uint64_t)x;
            size |= (uint64_t)(x < 0 ? -x : x);
        }
    }
    if (lost) return 0;
    spare = any ? paradt__trailing_zeros(any) : 0;
    spare = paradt__min(spare, (weights->unit - (weights->unit & 1)) / 2 - f->unit);
    if (spare < 0) return 0;
    for (int i = 0; i < q->n; i++) {
        for (int j = 0; j < columns; j++) f->x[i][j] >>= spare;
    }
    f->unit += spare;
    f->bits = paradt__bit_length(size) - spare;
    return 1;
}

// Fills f without the lifts. Returns 0 if differences or weights do not fit.
PARADT__INLINE int paradt__fix_rows(paradt__fixed *f, const paradt__space *s, const paradt__determinant *q) {
    int columns = q->n > q->k ? q->d : q->k;
    paradt__range weights = paradt__no_range;
    if (q->n > q->k && q->weighted) weights = paradt__measure_columns(q, q->d, q->d + 1);
    if (s->per_unit > 0 && 2 * s->coordinates.unit <= weights.unit) paradt__fix_by_set(f, s, q, columns);
    else if (!paradt__fix_by_bits(f, q, columns, &weights)) return 0;
    // a sum of up to 8 squares, and the difference of two weights
    f->lift_bits = paradt__max(2 * f->bits + 3, weights.top + 1 - 2 * f->unit) + (weights.top > weights.bottom);
    return 1;
}

// Fills f->lift. f->lift_bits must be at most PARADT__WIDE_BITS - 5.
PARADT__INLINE void paradt__fix_lifts(paradt__fixed *f, const paradt__determinant *q) {
    for (int i = 0; i < q->n; i++) {
        paradt__wide lift = 0;
        for (int j = 0; j < q->d; j++) lift += (paradt__wide)f->x[i][j] * f->x[i][j];
        for (int side = 0; side < 2 && q->weighted; side++) {
            double w = side ? q->base[q->d] : q->row[i][q->d];
            int shift;
            paradt__wide m = (paradt__wide)paradt__mantissa(w, 2 * f->unit, &shift);
            m *= (paradt__wide)1 << shift;
            lift += (paradt__bits(w) >> 63) == (uint64_t)side ? -m : m;
        }
        f->lift[i] = lift;
    }
}

// The determinant of rows i and j in the first two columns
PARADT__INLINE paradt__wide paradt__wide_pair(const paradt__fixed *f, int i, int j) {
    return (paradt__wide)f->x[i][0] * f->x[j][1] - (paradt__wide)f->x[j][0] * f->x[i][1];
}

// The determinant of all rows, which must fit in a wide integer, for k = 2 or 3
PARADT__INLINE paradt__wide paradt__wide_small(const paradt__fixed *f, int n, int k) {
    paradt__wide p01 = paradt__wide_pair(f, 0, 1), p02, p12, p03, p13, p23, z0, z1, z2, z3;
    if (n == 2) return p01;
    p02 = paradt__wide_pair(f, 0, 2), p12 = paradt__wide_pair(f, 1, 2);
    z0 = k > 2 ? f->x[0][2] : f->lift[0], z1 = k > 2 ? f->x[1][2] : f->lift[1], z2 = k > 2 ? f->x[2][2] : f->lift[2];
    if (n == 3) return z0 * p12 - z1 * p02 + z2 * p01;
    p03 = paradt__wide_pair(f, 0, 3), p13 = paradt__wide_pair(f, 1, 3), p23 = paradt__wide_pair(f, 2, 3);
    z3 = f->x[3][2];
    return f->lift[3] * (z0 * p12 - z1 * p02 + z2 * p01) - f->lift[2] * (z0 * p13 - z1 * p03 + z3 * p01) +
           f->lift[1] * (z0 * p23 - z2 * p03 + z3 * p02) - f->lift[0] * (z1 * p23 - z2 * p13 + z3 * p12);
}

// The same for any k. minor[mask] is the determinant of the rows in the mask and of as many first columns.
PARADT__NOINLINE paradt__wide paradt__wide_any(const paradt__fixed *f, int n, int k) {
    paradt__wide minor[1 << PARADT__MAX_ROWS];
    minor[0] = 1;
    for (unsigned mask = 1; mask < 1u << n; mask++) {
        paradt__wide sum = 0;
        int column = 0;
        for (unsigned rest = mask & (mask - 1); rest; rest &= rest - 1) column++;
        for (unsigned rest = mask; rest; rest &= rest - 1) {
            int i = paradt__trailing_zeros(rest);
            paradt__wide x = column < k ? f->x[i][column] : f->lift[i];
            sum = x * minor[mask ^ 1u << i] - sum; // along the last column: the sign of its last row is positive
        }
        minor[mask] = sum;
    }
    return minor[(1 << n) - 1];
}

// few: is k 2 or 3?
PARADT__INLINE int paradt__small_sign(const paradt__fixed *f, int n, int k, int few) {
    paradt__wide det = few ? paradt__wide_small(f, n, k) : paradt__wide_any(f, n, k);
    return (det > 0) - (det < 0);
}

// --- numbers of any length: the general stage

// The lengths of a determinant's entries. Units are exponents.
typedef struct paradt__layout {
    int unit, bits, digits;                // of the coordinates' differences
    int lift_unit, lift_bits, lift_digits; // of the lifts; 2 unit - lift_unit is a multiple of PARADT__RADIX
} paradt__layout;

// Two sizes of room on the stack, each for all numbers of a determinant and for sums. Differences have at most 2099
// bits (from 2^-1074 to 2^1025), lifts 4202 (from 2^-2148 to 2^2054): 35 and 71 digits of 60 bits, or 75 and 151 of 28.
//   small  Every determinant of up to 3 columns of coordinates fits. The largest is the weighted in-sphere test with
//          k = 3: rows take 4 (3 35 + 71) = 704 digits, minors of 1 or 3 columns 4 106 = 424, of 2 columns 6 70 = 420,
//          together 1548, and sums 177 elements. With digits of 28 bits: 1504 + 904 + 900 = 3308, and 377.
//   large  Every determinant fits. The largest, with k = 8, takes 5768 digits of 60 bits and sums of 562 elements, or
//          12328 and 1202 of 28 bits, when it is made from halves (paradt__general_halves).
#define PARADT__LARGE_DIGITS (53248 / (int)sizeof(paradt__digit))
#define PARADT__LARGE_SUM    (36 * 1024 / PARADT__RADIX)
#define PARADT__SMALL_DIGITS (13312 / (int)sizeof(paradt__digit))
#define PARADT__SMALL_SUM    (10800 / PARADT__RADIX)

// Finds the lengths: from the set's range or, if that is long, from the points'.
static paradt__layout paradt__lay_out(const paradt__space *s, const paradt__determinant *q) {
    paradt__layout y;
    int lifted = q->n > q->k;
    paradt__range x = s->coordinates, w = paradt__no_range;
    if (x.top + 1 - x.unit > 117) x = paradt__measure_columns(q, 0, lifted ? q->d : q->k);
    if (lifted && q->weighted) w = paradt__measure_columns(q, q->d, q->d + 1);
    if (x.unit > x.top) x.unit = x.top = 0;
    y.unit = x.unit;
    y.bits = x.top + 1 - x.unit;
    y.digits = paradt__digit_count(y.bits);
    y.lift_unit = 2 * y.unit;
    if (w.unit < y.lift_unit) y.lift_unit -= (y.lift_unit - w.unit + PARADT__RADIX - 1) / PARADT__RADIX * PARADT__RADIX;
    y.lift_bits = paradt__max(2 * x.top + 5, w.top + 1) + 1 - y.lift_unit;
    y.lift_digits = paradt__digit_count(y.lift_bits);
    return y;
}

// Adds sign * (a - b) / 2^unit to the sum.
PARADT__INLINE void paradt__add_difference(paradt__wide *sum, int sign, double a, double b, int unit) {
    int shift;
    uint64_t mantissa = paradt__mantissa(a, unit, &shift);
    paradt__add_shifted(sum, paradt__bits(a) >> 63 ? -sign : sign, mantissa, shift);
    mantissa = paradt__mantissa(b, unit, &shift);
    paradt__add_shifted(sum, paradt__bits(b) >> 63 ? sign : -sign, mantissa, shift);
}

// Writes the digits of (a - b) / 2^unit, which must fit in a wide integer.
PARADT__INLINE void paradt__short_difference(paradt__digit *digits, int count, double a, double b, int unit) {
    int shift;
    paradt__wide x, y;
    x = (paradt__wide)paradt__mantissa(a, unit, &shift);
    x = paradt__bits(a) >> 63 ? -(x << shift) : x << shift;
    y = (paradt__wide)paradt__mantissa(b, unit, &shift);
    y <<= shift;
    x += paradt__bits(b) >> 63 ? y : -y;
    for (int i = 0; i + 1 < count; i++, x = paradt__carry(x)) digits[i] = paradt__low_digit(x);
    digits[count - 1] = (paradt__digit)x;
}

// Writes the rows one after another: each k numbers of y->digits and, with the lift, one of y->lift_digits. Uses
// another y->digits behind the rows. sum: room for a lift and y->digits more
PARADT__NOINLINE void paradt__load_rows(paradt__digit *out, paradt__wide *sum, const paradt__determinant *q,
                                        const paradt__layout *y) {
    int lifted = q->n > q->k, offset = (2 * y->unit - y->lift_unit) / PARADT__RADIX;
    paradt__wide *lift = sum + y->digits;
    paradt__digit *further = out + q->n * (q->k * y->digits + lifted * y->lift_digits);
    for (int i = 0; i < q->n; i++) {
        int used = 8; // the weights add less than 8 products
        if (lifted) paradt__clear_any(lift, y->lift_digits);
        for (int j = 0; j < (lifted ? q->d : q->k); j++) {
            paradt__digit *x = j < q->k ? out : further;
            if (y->bits < PARADT__WIDE_BITS - 1) {
                paradt__short_difference(x, y->digits, q->row[i][j], q->base[j], y->unit);
            } else {
                paradt__clear_any(sum, y->digits);
                paradt__add_difference(sum, 1, q->row[i][j], q->base[j], y->unit);
                paradt__store_any(x, sum, y->digits);
            }
            if (j < q->k) out += y->digits;
            if (!lifted) continue;
            paradt__make_room(lift, y->lift_digits, &used, y->digits);
            paradt__multiply_add_any(lift + offset, 1, x, y->digits, x, y->digits);
        }
        if (!lifted) continue;
        if (q->weighted) paradt__add_difference(lift, -1, q->row[i][q->d], q->base[q->d], y->lift_unit);
        paradt__store_any(out, lift, y->lift_digits);
        out += y->lift_digits;
    }
}

// The minors of a determinant that consist of columns first, first + 1, ...
typedef struct paradt__minors {
    const paradt__determinant *whole;
    const paradt__layout *layout;
    const paradt__digit *rows; // as paradt__load_rows writes them
    int first;
} paradt__minors;

// The number of digits of a minor of so many columns
PARADT__INLINE int paradt__minor_digits(const paradt__minors *m, int columns) {
    int lifted = m->first + columns > m->whole->k;
    return paradt__digit_count((columns - lifted) * m->layout->bits + lifted * m->layout->lift_bits +
                               paradt__log_factorial[columns]);
}

// The most digits that all minors of one size take together, among sizes of odd (parity 1) or even parity, if they are
// made of so many rows
static int paradt__minors_space(const paradt__minors *m, int rows, int parity) {
    int most = 0;
    for (int columns = 1, binomial = rows; columns <= rows; columns++) {
        if ((columns & 1) == parity) most = paradt__max(most, binomial * paradt__minor_digits(m, columns));
        binomial = binomial * (rows - columns) / (columns + 1);
    }
    return most;
}

// Returns the next larger number with as many bits set (Gosper's hack).
PARADT__INLINE unsigned paradt__next_subset(unsigned set) {
    unsigned low = set & (0 - set), ripple = set + low;
    return ripple | ((set ^ ripple) >> 2) / low;
}

// Computes the minor of the rows in the set and of as many columns from m->first. Returns its digits, in work, and
// their number in *digits. All minors of each size are made from those that are one column smaller, in two areas of
// work that take turns.
static const paradt__digit *paradt__minor(const paradt__minors *m, unsigned set, paradt__digit *work, paradt__wide *sum,
                                          int *digits) {
    const paradt__layout *y = m->layout;
    int k = m->whole->k, row_digits = k * y->digits + (m->whole->n > k ? y->lift_digits : 0);
    int row[PARADT__MAX_ROWS], rows = 0, previous = 0;
    uint16_t place[1 << PARADT__MAX_ROWS];
    paradt__digit *places[2], *from = NULL;
    for (unsigned rest = set; rest; rest &= rest - 1) row[rows++] = paradt__trailing_zeros(rest);
    places[1] = work;
    places[0] = work + paradt__minors_space(m, rows, 1);
    for (int columns = 1; columns <= rows; columns++) {
        paradt__digit *to = places[columns & 1];
        int column = m->first + columns - 1, length = paradt__minor_digits(m, columns), count = 0;
        int entry_digits = column < k ? y->digits : y->lift_digits;
        for (unsigned mask = (1u << columns) - 1; mask < 1u << rows; mask = paradt__next_subset(mask)) {
            int sign = 1, used = 0;
            paradt__clear_any(sum, length);
            for (unsigned rest = mask; rest; rest &= rest - 1, sign = -sign) {
                int i = paradt__trailing_zeros(rest);
                const paradt__digit *x = m->rows + row[i] * row_digits + column * y->digits;
                if (columns == 1) {
                    for (int j = 0; j < length && j < entry_digits; j++) sum[j] = x[j];
                    continue;
                }
                const paradt__digit *minor = from + place[mask ^ 1u << i] * previous;
                paradt__make_room(sum, length, &used, paradt__min(entry_digits, previous));
                paradt__multiply_add_any(sum, columns & 1 ? sign : -sign, x, entry_digits, minor, previous);
            }
            paradt__store_any(to + count * length, sum, length);
            place[mask] = (uint16_t)count++;
        }
        previous = length;
        from = to;
    }
    *digits = previous;
    return from;
}

// The sign of the whole determinant in less room: it is the sum, over all sets of half the rows, of the minor of the
// first columns in these rows times the minor of the other columns in the other rows (Laplace). With 9 rows that takes
// a sixth of the room and six times as long.
static int paradt__general_halves(paradt__minors *m, paradt__digit *work, paradt__wide *sum, int digits) {
    int n = m->whole->n, half = n / 2, used = 0, a_digits, b_digits;
    paradt__digit *b_work = work + paradt__minors_space(m, half, 0) + paradt__minors_space(m, half, 1);
    paradt__wide *minor_sum = sum + digits;
    paradt__clear_any(sum, digits);
    for (unsigned mask = (1u << half) - 1; mask < 1u << n; mask = paradt__next_subset(mask)) {
        int sign = half * (half - 1) / 2 & 1;
        for (unsigned rest = mask; rest; rest &= rest - 1) sign ^= paradt__trailing_zeros(rest) & 1;
        m->first = 0;
        const paradt__digit *a = paradt__minor(m, mask, work, minor_sum, &a_digits);
        m->first = half;
        const paradt__digit *b = paradt__minor(m, ((1u << n) - 1) ^ mask, b_work, minor_sum, &b_digits);
        paradt__make_room(sum, digits, &used, paradt__min(a_digits, b_digits));
        paradt__multiply_add_any(sum, sign ? -1 : 1, a, a_digits, b, b_digits);
    }
    paradt__store_any(work, sum, digits);
    return paradt__sign(work, digits);
}

// Do all minors fit together into so many digits, and the sums into so many elements?
static int paradt__general_fits(const paradt__determinant *q, const paradt__layout *y, int digits, int sums) {
    paradt__minors m = {q, y, NULL, 0};
    int rows = q->n * (q->k * y->digits + y->lift_digits);
    int minors = paradt__minors_space(&m, q->n, 0) + paradt__minors_space(&m, q->n, 1);
    minors = paradt__max(minors, y->digits); // one more number while the rows are made
    return rows + minors <= digits && paradt__minor_digits(&m, q->n) + 1 <= sums;
}

// whole: 1 if paradt__general_fits, so that all minors are made; 0: from halves
PARADT__NOINLINE int paradt__general(const paradt__determinant *q, const paradt__layout *y, paradt__digit *work,
                                     paradt__wide *sum, int whole) {
    paradt__minors m = {q, y, work, 0};
    paradt__digit *free_work = work + q->n * (q->k * y->digits + y->lift_digits);
    const paradt__digit *determinant;
    int digits = paradt__minor_digits(&m, q->n);
    paradt__load_rows(work, sum, q, y);
    if (!whole) return paradt__general_halves(&m, free_work, sum, digits);
    determinant = paradt__minor(&m, (1u << q->n) - 1, free_work, sum, &digits);
    return paradt__sign(determinant, digits);
}

PARADT__NOINLINE int paradt__general_small(const paradt__determinant *q, const paradt__layout *y) {
    PARADT_ASSERT(paradt__general_fits(q, y, PARADT__SMALL_DIGITS, PARADT__SMALL_SUM));
    paradt__digit work[PARADT__SMALL_DIGITS];
    paradt__wide sum[PARADT__SMALL_SUM];
    return paradt__general(q, y, work, sum, 1);
}

PARADT__NOINLINE int paradt__general_large(const paradt__determinant *q, const paradt__layout *y) {
    paradt__digit work[PARADT__LARGE_DIGITS];
    paradt__wide sum[PARADT__LARGE_SUM];
    int whole = paradt__general_fits(q, y, PARADT__LARGE_DIGITS, PARADT__LARGE_SUM);
    return paradt__general(q, y, work, sum, whole);
}

// --- one or two digits: the fixed stage

#ifdef __SIZEOF_INT128__
// The rows are as paradt__load_rows writes them, with w digits a coordinate and 2 w a lift, and every product of
// numbers gets as many digits as its factors have together. That suffices for
//   w = 1  differences of 60 bits. Last digits may exceed the radix: they are at most 2^61 for pairs, 2^62.6 for
//          triples and 2^62 for lifts (which are below 2^122), so that a sum of four of their products is below 2^126.7
//   w = 2  differences of 117 bits, with all digits balanced

// Computes p[2 w], the determinant of the rows a and b in the first two columns.
PARADT__INLINE void paradt__pair(paradt__digit *p, const paradt__digit *a, const paradt__digit *b, int w) {
    paradt__wide sum[4];
    paradt__clear(sum, 2 * w);
    paradt__multiply_add(sum, 1, a, w, b + w, w);
    paradt__multiply_add(sum, -1, b, w, a + w, w);
    paradt__store(p, sum, 2 * w);
}

PARADT__NOINLINE void paradt__pair_two(paradt__digit *p, const paradt__digit *a, const paradt__digit *b) {
    paradt__pair(p, a, b, 2);
}

// Does the same. The code for two digits is long and there only once.
PARADT__INLINE void paradt__fixed_pair(paradt__digit *p, const paradt__digit *a, const paradt__digit *b, int w) {
    if (w == 1) paradt__pair(p, a, b, 1);
    else paradt__pair_two(p, a, b);
}

// Computes t[2 w + third], the determinant of the rows a, b and c in three columns, from those of two: bc, ac and ab.
// third: digits of an entry in the third column
PARADT__INLINE void paradt__triple(paradt__digit *t, int third, const paradt__digit *a, const paradt__digit *bc,
                                   const paradt__digit *b, const paradt__digit *ac, const paradt__digit *c,
                                   const paradt__digit *ab, int w) {
    paradt__wide sum[8];
    paradt__clear(sum, 2 * w + third);
    paradt__multiply_add(sum, 1, a + 2 * w, third, bc, 2 * w);
    paradt__multiply_add(sum, -1, b + 2 * w, third, ac, 2 * w);
    paradt__multiply_add(sum, 1, c + 2 * w, third, ab, 2 * w);
    paradt__store(t, sum, 2 * w + third);
}

PARADT__NOINLINE void paradt__triple_two(paradt__digit *t, const paradt__digit *a, const paradt__digit *bc,
                                         const paradt__digit *b, const paradt__digit *ac, const paradt__digit *c,
                                         const paradt__digit *ab) {
    paradt__triple(t, 2, a, bc, b, ac, c, ab, 2);
}

// Does the same for third entries of w digits.
PARADT__INLINE void paradt__fixed_triple(paradt__digit *t, const paradt__digit *a, const paradt__digit *bc,
                                         const paradt__digit *b, const paradt__digit *ac, const paradt__digit *c,
                                         const paradt__digit *ab, int w) {
    if (w == 1) paradt__triple(t, 1, a, bc, b, ac, c, ab, 1);
    else paradt__triple_two(t, a, bc, b, ac, c, ab);
}

// The sign of the determinant. w: a constant, 1 or 2
PARADT__INLINE int paradt__fixed_sign(const paradt__digit *rows, int n, int k, int w) {
    const int stride = k * w + (n > k ? 2 * w : 0);
    const paradt__digit *x0 = rows, *x1 = x0 + stride, *x2 = x1 + stride, *x3 = x2 + stride;
    paradt__digit p01[4], p02[4], p12[4], p03[4], p13[4], p23[4], t012[8], t013[8], t023[8], t123[8], det[10];
    paradt__wide sum[10];
    paradt__fixed_pair(p01, x0, x1, w);
    if (n == 2) return paradt__sign(p01, 2 * w);
    paradt__fixed_pair(p02, x0, x2, w);
    paradt__fixed_pair(p12, x1, x2, w);
    if (n == 3 && k == 2) {
        paradt__triple(t012, 2 * w, x0, p12, x1, p02, x2, p01, w);
        return paradt__sign(t012, 4 * w);
    }
    paradt__fixed_triple(t012, x0, p12, x1, p02, x2, p01, w);
    if (n == 3) return paradt__sign(t012, 3 * w);
    paradt__fixed_pair(p03, x0, x3, w);
    paradt__fixed_pair(p13, x1, x3, w);
    paradt__fixed_pair(p23, x2, x3, w);
    paradt__fixed_triple(t123, x1, p23, x2, p13, x3, p12, w);
    paradt__fixed_triple(t023, x0, p23, x2, p03, x3, p02, w);
    paradt__fixed_triple(t013, x0, p13, x1, p03, x3, p01, w);
    paradt__clear(sum, 5 * w);
    paradt__multiply_add(sum, -1, x0 + 3 * w, 2 * w, t123, 3 * w);
    paradt__multiply_add(sum, 1, x1 + 3 * w, 2 * w, t023, 3 * w);
    paradt__multiply_add(sum, -1, x2 + 3 * w, 2 * w, t013, 3 * w);
    paradt__multiply_add(sum, 1, x3 + 3 * w, 2 * w, t012, 3 * w);
    paradt__store(det, sum, 5 * w);
    return paradt__sign(det, 5 * w);
}

PARADT__INLINE int paradt__fixed_one(const paradt__fixed *f, int n, int k) {
    paradt__digit rows[4 * 5], *out = rows;
    PARADT__UNROLL
    for (int i = 0; i < n; i++) {
        PARADT__UNROLL
        for (int j = 0; j < k; j++) *out++ = f->x[i][j];
        if (n == k) continue;
        *out++ = paradt__low_digit(f->lift[i]);
        *out++ = (paradt__digit)paradt__carry(f->lift[i]);
    }
    return paradt__fixed_sign(rows, n, k, 1);
}

// Do two digits suffice for the differences, and four for the lifts?
PARADT__INLINE int paradt__two_fit(const paradt__layout *y, int n, int k) {
    if ((k != 2 && k != 3) || y->bits > 117) return 0;
    return n == k || (y->lift_digits <= 4 && y->lift_unit >= 2 * y->unit - PARADT__RADIX);
}

// Writes rows of two digits a coordinate and four a lift.
PARADT__NOINLINE void paradt__load_two(paradt__digit *out, const paradt__determinant *q, const paradt__layout *y) {
    const int lifted = q->n > q->k, offset = (2 * y->unit - y->lift_unit) / PARADT__RADIX; // 0 or 1
    for (int i = 0; i < q->n; i++) {
        paradt__wide lift[4] = {0};
        for (int j = 0; j < (lifted ? q->d : q->k); j++) {
            paradt__digit x[2];
            paradt__short_difference(x, 2, q->row[i][j], q->base[j], y->unit);
            if (j < q->k) *out++ = x[0], *out++ = x[1];
            if (lifted) paradt__multiply_add(lift + offset, 1, x, 2, x, 2);
        }
        if (!lifted) continue;
        if (q->weighted) paradt__add_difference(lift, -1, q->row[i][q->d], q->base[q->d], y->lift_unit);
        paradt__store(out, lift, 4);
        out += 4;
    }
}

PARADT__NOINLINE int paradt__fixed_two(const paradt__determinant *q, const paradt__layout *y) {
    paradt__digit rows[4 * 10];
    paradt__load_two(rows, q, y);
    return paradt__fixed_sign(rows, q->n, q->k, 2);
}
#endif

// --- which stage

// The sign of the determinant. few: k is 2 or 3, and n, k and d are constants, so that the compiler unrolls the loops
// of the small stage and of the fixed stage with one digit.
PARADT__INLINE int paradt__exact_inline(paradt__space *s, const double *const *row, const double *base, int n, int k,
                                        int d, int few) {
    const paradt__determinant q = {n, k, d, s->weighted, row, base};
    PARADT_ASSERT((n == k || n == k + 1) && k >= 1 && k <= d && d <= PARADT_MAX_DIM);
    int lifted = n > k;
    paradt__layout y;
    paradt__fixed f;
    if (paradt__fix_rows(&f, s, &q)) {
        int is_small = k * f.bits + (lifted ? f.lift_bits : 0) + paradt__log_factorial[n] <= PARADT__WIDE_BITS;
        int lift_fits = !lifted || f.lift_bits <= PARADT__WIDE_BITS - 5;
        if (lifted && lift_fits) paradt__fix_lifts(&f, &q);
        if (is_small && lift_fits) {
            s->counters.exact_small++;
            return paradt__small_sign(&f, n, k, few);
        }
#ifdef __SIZEOF_INT128__
        if (few && lift_fits) {
            s->counters.exact_fixed++;
            return paradt__fixed_one(&f, n, k);
        }
#endif
    }
    y = paradt__lay_out(s, &q);
#ifdef __SIZEOF_INT128__
    if (few && paradt__two_fit(&y, n, k)) {
        s->counters.exact_fixed++;
        return paradt__fixed_two(&q, &y);
    }
#endif
    s->counters.exact_general++;
    if (PARADT_MAX_DIM <= 3 || k <= 3 || paradt__general_fits(&q, &y, PARADT__SMALL_DIGITS, PARADT__SMALL_SUM))
        return paradt__general_small(&q, &y);
    return paradt__general_large(&q, &y);
}

PARADT__NOINLINE int paradt__exact_orient2(paradt__space *s, const double *const *p) {
    return paradt__exact_inline(s, p + 1, p[0], 2, 2, 2, 1);
}

PARADT__NOINLINE int paradt__exact_orient3(paradt__space *s, const double *const *p) {
    return paradt__exact_inline(s, p + 1, p[0], 3, 3, 3, 1);
}

PARADT__NOINLINE int paradt__exact_insphere2(paradt__space *s, const double *const *p) {
    return paradt__exact_inline(s, p, p[3], 3, 2, 2, 1);
}

PARADT__NOINLINE int paradt__exact_insphere3(paradt__space *s, const double *const *p) {
    return -paradt__exact_inline(s, p, p[4], 4, 3, 3, 1);
}

// The in-sphere test for points of a plane in space
PARADT__NOINLINE int paradt__exact_flat3(paradt__space *s, const double *const *p) {
    return paradt__exact_inline(s, p, p[3], 3, 2, 3, 1);
}

PARADT__NOINLINE int paradt__exact_any(paradt__space *s, const double *const *row, const double *base, int n) {
    return paradt__exact_inline(s, row, base, n, s->dim, s->ambient, 0);
}

// The orientation of p[0..k], k = s->dim
static int paradt__exact_orient(paradt__space *s, const double *const *p) {
    if (PARADT__IS(s->dim, 3)) return paradt__exact_orient3(s, p);
    if (s->dim == 2) return paradt__exact_orient2(s, p);
    return paradt__exact_any(s, p + 1, p[0], s->dim);
}

// The in-sphere test of p[k + 1] with p[0..k]
static int paradt__exact_insphere(paradt__space *s, const double *const *p) {
    int k = s->dim, sign;
    if (PARADT__IS(k, 3) && s->ambient == 3) return paradt__exact_insphere3(s, p);
    if (k == 2 && s->ambient == 2) return paradt__exact_insphere2(s, p);
    if (k == 2 && PARADT__IS(s->ambient, 3)) return paradt__exact_flat3(s, p);
    sign = paradt__exact_any(s, p, p[k + 1], k + 1);
    return k & 1 ? -sign : sign;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>signs
//
// The predicates: orientation, in-sphere test, and the test for conflict, which is the in-sphere test with its ties
// broken. Each asks a filter first and the exact stages if the filter is undecided. All points must have been measured
// into the space, and the cell of an in-sphere test must be positively oriented.
// The ties are broken as by Devillers and Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations,
// CGTA 44, 2011. The public predicates measure the points of each call.
// Doors: paradt__orient, paradt__perturbed, paradt__conflict.

// Was the set measured, up to the end, and are the dimensions among those measured?
PARADT__INLINE int paradt__space_is_ready(const paradt__space *s) {
    return s->dim >= 1 && s->dim <= s->ambient && s->ambient <= PARADT_MAX_DIM &&
           (!s->bounded || s->insphere[s->dim].factor > 0);
}

// The orientation by the first k coordinates. k: s->dim, as a constant where code for it alone is wanted
PARADT__INLINE int paradt__orient_any(paradt__space *s, const double *const *p, int k) {
    int sign = PARADT__UNDECIDED;
    PARADT_ASSERT(paradt__space_is_ready(s));
    s->counters.orient_calls++;
    if (k == 1) return paradt__compare(s, p[1], p[0]);
    if (s->bounded)
        sign = k == 2             ? paradt__filter_orient2(s, p)
               : PARADT__IS(k, 3) ? paradt__filter_orient3(s, p)
               : PARADT__IS(k, 4) ? paradt__filter4(s, p + 1, p[0], 4, 4)
                                  : paradt__filter_any(s, p + 1, p[0], k, k, s->ambient);
    return sign == PARADT__UNDECIDED ? paradt__exact_orient(s, p) : sign;
}

// The sign of det[p[1] - p[0]; ...; p[k] - p[0]], k = s->dim
static int paradt__orient(paradt__space *s, const double *const *p) {
    if (PARADT__IS(s->dim, 3)) return paradt__orient_any(s, p, 3);
    if (s->dim == 2) return paradt__orient_any(s, p, 2);
    return paradt__orient_any(s, p, s->dim);
}

// The in-sphere test. k, d: s->dim and s->ambient, as constants where code for them alone is wanted
PARADT__INLINE int paradt__insphere_any(paradt__space *s, const double *const *p, int k, int d) {
    int sign = PARADT__UNDECIDED;
    PARADT_ASSERT(paradt__space_is_ready(s));
    s->counters.insphere_calls++;
    if (s->bounded)
        sign = k == 2             ? paradt__filter_insphere2(s, p, d, s->weighted)
               : PARADT__IS(k, 3) ? paradt__filter_insphere3(s, p, d, s->weighted)
               : PARADT__IS(k, 4) ? paradt__filter4(s, p, p[5], 5, d)
                                  : paradt__filter_any(s, p, p[k + 1], k + 1, k, d);
    return sign == PARADT__UNDECIDED ? paradt__exact_insphere(s, p) : sign;
}

// Returns 1 if p[k + 1] is inside the sphere of the cell p[0..k], 0 if it is on the sphere, -1 if it is outside.
static int paradt__insphere(paradt__space *s, const double *const *p) {
    if (PARADT__IS(s->dim, 3) && s->ambient == 3) return paradt__insphere_any(s, p, 3, 3);
    if (s->dim == 2 && s->ambient == 2) return paradt__insphere_any(s, p, 2, 2);
    return paradt__insphere_any(s, p, s->dim, s->ambient);
}

// Returns the place of the lexicographically largest of p[0..query] that is not in the mask `done`. In 3 dimensions it
// does not branch on comparisons, as the processor could not predict the branches in lattices.
PARADT__INLINE int paradt__largest_point(const paradt__space *s, const double *const *p, int query, unsigned done) {
    int largest = query, i;
    if (PARADT__IS(s->dim, 3) && s->filtered) {
        const double *y = p[query];
        for (i = 0; i < 4; i++) {
            const double *x = p[i];
            int above = (x[1] > y[1]) | ((x[1] == y[1]) & (x[2] > y[2]));
            above = ((x[0] > y[0]) | ((x[0] == y[0]) & above)) & (int)(~done >> i & 1);
            largest = above ? i : largest;
            y = above ? x : y;
        }
    } else {
        for (i = 0; i < query; i++) {
            if (!(done >> i & 1) && paradt__compare(s, p[i], p[largest]) > 0) largest = i;
        }
    }
    return largest;
}

// Decides an in-sphere test of sign 0: 1 in conflict, 0 not. The query is p[k + 1]. The perturbation raises the lifts
// of all points, those of lexicographically larger points overwhelmingly more: going down from the largest point, the
// first one whose lift matters decides. Raising the query's lift moves the query outside. Raising the lift of p[i]
// moves the query inside if the cell stays positively oriented when the query takes the place of p[i].
PARADT__NOINLINE int paradt__perturbed(paradt__space *s, const double *const *p) {
    const int query = s->dim + 1;
    const double *other[PARADT__MAX_ROWS];
    unsigned done = 0;
    PARADT_ASSERT(paradt__space_is_ready(s));
    s->counters.perturbed++;
    for (;;) {
        int largest = paradt__largest_point(s, p, query, done), sign;
        if (largest == query) return 0;
        for (int i = 0; i < query; i++) other[i] = p[i == largest ? query : i];
        sign = paradt__orient(s, other);
        if (sign) return sign > 0;
        done |= 1u << largest;
    }
}

// Is p[k + 1] in conflict with the cell p[0..k]? 1 or 0; there are no ties.
static int paradt__conflict(paradt__space *s, const double *const *p) {
    int sign = paradt__insphere(s, p);
    return sign ? sign > 0 : paradt__perturbed(s, p);
}

PARADT_DEF int paradt_orient(int dim, const double *const *points) {
    paradt__space s;
    paradt__space_begin(&s, dim, dim, 0);
    for (int i = 0; i <= dim; i++) paradt__space_add(&s, points[i]);
    paradt__space_end(&s);
    return paradt__orient(&s, points);
}

// --- the public predicates

// Copies of points, each with its weight behind it
typedef struct paradt__joined {
    double memory[PARADT_MAX_DIM + 2][PARADT_MAX_DIM + 1];
    const double *points[PARADT_MAX_DIM + 2];
} paradt__joined;

// Copies dim + 2 points and their weights, and measures them. weights: NULL: none
static void paradt__join(paradt__joined *joined, paradt__space *s, int dim, const double *const *points,
                         const double *weights) {
    paradt__space_begin(s, dim, dim, weights != NULL);
    for (int i = 0; i < dim + 2; i++) {
        memcpy(joined->memory[i], points[i], (size_t)dim * sizeof(double));
        joined->memory[i][dim] = weights ? weights[i] : 0;
        joined->points[i] = joined->memory[i];
        paradt__space_add(s, joined->points[i]);
    }
    paradt__space_end(s);
}

PARADT_DEF int paradt_insphere(int dim, const double *const *points, const double *weights) {
    paradt__space s;
    paradt__joined joined;
    paradt__join(&joined, &s, dim, points, weights);
    return paradt__insphere(&s, joined.points);
}

PARADT_DEF int paradt_insphere_perturbed(int dim, const double *const *points, const double *weights) {
    paradt__space s;
    paradt__joined joined;
    paradt__join(&joined, &s, dim, points, weights);
    return paradt__conflict(&s, joined.points) ? 1 : -1;
}

// --- few points of two or three dimensions, given by their coordinates

// Makes the filters ready for k + 1 or k + 2 points of which no more is known than that no coordinate is 2^100 or more.
// They decide by the error bound alone. Returns 0 where a coordinate is larger, or the filters can't be trusted.
PARADT__INLINE int paradt__space_of_few(paradt__space *s, const double *const *p, int count, int k) {
    const double most = paradt__power(100);
    int i, j, fits = 1;
    for (i = 0; i < count; i++)
        for (j = 0; j < k; j++) fits &= paradt__abs(p[i][j]) < most;
    s->tiny = paradt__power(-440); // more than that of paradt__space_end where the top is 100
    s->orient[k].certain = s->insphere[k].certain = paradt__power(1000); // more than any determinant
    s->orient[k].quantum = s->insphere[k].quantum = 0;
    s->orient[k].factor = paradt__rounding(k, k);
    s->insphere[k].factor = paradt__rounding(k, k + 1);
    return fits && paradt__precise();
}

PARADT__INLINE int paradt__orient_few(const double *const *p, int k) {
    paradt__space s;
    int sign = PARADT__UNDECIDED;
    if (paradt__space_of_few(&s, p, k + 1, k))
        sign = k == 2 ? paradt__filter_orient2(&s, p) : paradt__filter_orient3(&s, p);
    return PARADT__LIKELY(sign != PARADT__UNDECIDED) ? sign : paradt_orient(k, p);
}

PARADT__INLINE int paradt__insphere_few(const double *const *p, int k) {
    paradt__space s;
    int sign = PARADT__UNDECIDED;
    if (paradt__space_of_few(&s, p, k + 2, k))
        sign = k == 2 ? paradt__filter_insphere2(&s, p, 2, 0) : paradt__filter_insphere3(&s, p, 3, 0);
    return PARADT__LIKELY(sign != PARADT__UNDECIDED) ? sign : paradt_insphere(k, p, NULL);
}

PARADT_DEF int paradt_orient2(const double a[2], const double b[2], const double c[2]) {
    const double *p[] = {a, b, c};
    return paradt__orient_few(p, 2);
}

PARADT_DEF int paradt_insphere2(const double a[2], const double b[2], const double c[2], const double q[2]) {
    const double *p[] = {a, b, c, q};
    return paradt__insphere_few(p, 2);
}

// Fills w[count][k] with points of floats.
static void paradt__widen_points(double *w, const float *const *p, int count, int k) {
    int i, j;
    for (i = 0; i < count; i++) {
        for (j = 0; j < k; j++) {
            uint32_t bits;
            memcpy(&bits, p[i] + j, sizeof bits);
            *w++ = bits >> 23 & 255 ? (double)p[i][j] : paradt__widen(bits); // subnormal: see there
        }
    }
}

PARADT_DEF int paradt_orient2f(const float a[2], const float b[2], const float c[2]) {
    const float *p[] = {a, b, c};
    double w[3][2];
    paradt__widen_points(w[0], p, 3, 2);
    return paradt_orient2(w[0], w[1], w[2]);
}

PARADT_DEF int paradt_insphere2f(const float a[2], const float b[2], const float c[2], const float q[2]) {
    const float *p[] = {a, b, c, q};
    double w[4][2];
    paradt__widen_points(w[0], p, 4, 2);
    return paradt_insphere2(w[0], w[1], w[2], w[3]);
}

#if PARADT_MAX_DIM >= 3
PARADT_DEF int paradt_orient3(const double a[3], const double b[3], const double c[3], const double d[3]) {
    const double *p[] = {a, b, c, d};
    return paradt__orient_few(p, 3);
}

PARADT_DEF int paradt_insphere3(const double a[3], const double b[3], const double c[3], const double d[3],
                                const double q[3]) {
    const double *p[] = {a, b, c, d, q};
    return paradt__insphere_few(p, 3);
}

PARADT_DEF int paradt_orient3f(const float a[3], const float b[3], const float c[3], const float d[3]) {
    const float *p[] = {a, b, c, d};
    double w[4][3];
    paradt__widen_points(w[0], p, 4, 3);
    return paradt_orient3(w[0], w[1], w[2], w[3]);
}

PARADT_DEF int paradt_insphere3f(const float a[3], const float b[3], const float c[3], const float d[3],
                                 const float q[3]) {
    const float *p[] = {a, b, c, d, q};
    double w[5][3];
    paradt__widen_points(w[0], p, 5, 3);
    return paradt_insphere3(w[0], w[1], w[2], w[3], w[4]);
}
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>curve
//
// Keys: positions of points on Hilbert's curve, and sorting by them. Points that are neighbours in this order are
// neighbours in space; all that is built later is fast because of that. Keys matter for more than speed in one respect:
// equal points have equal keys, and are found by them. So keys are made from the bits of the coordinates in integer
// arithmetic, and no compiler flag changes them. The curve is D. Hilbert's (Math. Annalen 38, 1891), its step in any
// dimension is C. Hamilton's ("Compact Hilbert indices", Dalhousie University, CS-2006-07).
// Doors: paradt__curve_begin, paradt__curve_limit, paradt__curve_key, paradt__curve_sort, paradt__levels_for; for
// callers that make keys in their own way paradt__whole_steps, paradt__lattice_begin, paradt__hilbert_begin,
// paradt__hilbert_key, paradt__keyed_sort.

typedef struct paradt__keyed {
    uint64_t key;
    paradt_index item; // what has the key: a caller's index, or a position in a set
} paradt__keyed;

enum {
    PARADT__CURVE_BITS = 60,      // bits of a key, at most
    PARADT__FEW_KEYS = 32,        // so many are sorted by insertion
    PARADT__MOST_DIGIT_BITS = 11, // bits of a key that one pass of the sort looks at, at most
    PARADT__STEP_BITS = 6,        // bits of a key that one look into the table for many points gives
    PARADT__MANY_KEYS = 2048,     // from so many keys on the table for many points pays
    PARADT__FLAT = 1 << 14,       // an exponent that makes every coordinate 0
    // of the curve in two or three dimensions, at most: dim << dim
    PARADT__ORIENTATIONS = PARADT_MAX_DIM > 2 ? 3 << 3 : 2 << 2
};

// --- sorting by keys

// Returns how many bits of a key the next pass sorts by, of the `bits` that are left: enough that each of `count`
// evenly spread keys has a value of its own. Where the table would be too large, half as many, for two passes.
static int paradt__digit_bits(size_t count, int bits) {
    int wanted = paradt__bit_length(count) - 1;
    if (wanted > PARADT__MOST_DIGIT_BITS) wanted = (wanted + 1) / 2;
    if (wanted > PARADT__MOST_DIGIT_BITS) wanted = PARADT__MOST_DIGIT_BITS;
    return wanted < bits ? wanted : bits;
}

// Sorts by insertion. to: where the result goes; may be `keyed`.
static void paradt__keyed_insert(const paradt__keyed *keyed, paradt__keyed *to, size_t count) {
    size_t i;
    for (i = 0; i < count; i++) {
        paradt__keyed moved = keyed[i];
        size_t j = i;
        for (; j > 0 && to[j - 1].key > moved.key; j--) to[j] = to[j - 1];
        to[j] = moved;
    }
}

// paradt__keyed_sort with a table of digits that all depths of the recursion share: after a pass the keys themselves
// tell which of them have a digit in common.
static void paradt__keyed_sort_by(paradt_index *ends, paradt__keyed *keyed, paradt__keyed *other, size_t count,
                                  int bits, int across) {
    paradt_index most = 0;
    size_t digits, begin, end, i;
    int shift;
    if (count <= PARADT__FEW_KEYS) {
        paradt__keyed_insert(keyed, across ? other : keyed, count);
        return;
    }
    shift = bits - paradt__digit_bits(count, bits);
    digits = (size_t)1 << (bits - shift);
    memset(ends, 0, (digits + 1) * sizeof *ends);
    for (i = 0; i < count; i++) ends[(keyed[i].key >> shift & (digits - 1)) + 1]++;
    for (i = 1; i <= digits; i++) {
        most = ends[i] > most ? ends[i] : most;
        ends[i] += ends[i - 1];
    }
    for (i = 0; i < count; i++) other[ends[keyed[i].key >> shift & (digits - 1)]++] = keyed[i];
    if (!shift) {
        if (!across) memcpy(keyed, other, count * sizeof *keyed);
    } else if (most <= PARADT__FEW_KEYS) {
        paradt__keyed_insert(other, across ? other : keyed, count);
    } else {
        for (begin = 0; begin < count; begin = end) {
            for (end = begin + 1; end < count && other[end].key >> shift == other[begin].key >> shift;) end++;
            paradt__keyed_sort_by(ends, other + begin, keyed + begin, end - begin, shift, !across);
        }
    }
}

// Sorts by the lowest `bits` bits of the keys, which are equal above these; equal keys stay in their order. A radix
// sort from the highest digit down, until few keys have a digit in common: they are nearly sorted then, and insertion
// ends it. other: scratch for as many. The result is in `other` if `across`, else in `keyed`.
PARADT__NOINLINE void paradt__keyed_sort(paradt__keyed *keyed, paradt__keyed *other, size_t count, int bits,
                                         int across) {
    paradt_index ends[(1 << PARADT__MOST_DIGIT_BITS) + 1];
    PARADT_ASSERT(bits >= 0 && bits <= 64);
    paradt__keyed_sort_by(ends, keyed, other, count, bits, across);
}

// --- the lattice

// The lattice that points are put on: 2^levels places along the longest side of a box. Its units are of one size; or
// they are steps from one double to the next, so that a side has at most 2^64 of them however many scales it spans.
typedef struct paradt__lattice {
    int dim, levels, shift;
    int by_steps;
    int exponent[PARADT_MAX_DIM]; // of the unit along each axis
    int64_t low[PARADT_MAX_DIM];
} paradt__lattice;

// Returns x in units of 2^(exponent - 9), cut off. The exponent of x (see paradt__split) is at most `exponent`.
PARADT__INLINE int64_t paradt__fixed_point(double x, int exponent) {
    int own;
    uint64_t size = paradt__split(x, &own) << 9, negative = 0 - (paradt__bits(x) >> 63);
    size = exponent - own < 63 ? size >> (exponent - own) : 0;
    return (int64_t)((size ^ negative) - negative);
}

// Returns so many levels, or a few more that take the same number of steps through the table for many points.
static int paradt__whole_steps(int levels, int dim) {
    int step = PARADT__STEP_BITS / dim;
    return step > 1 ? (levels + step - 1) / step * step : levels;
}

// Number of levels that tell nearly all of `count` points apart, if they are spread evenly
static int paradt__levels_for(size_t count, int dim) {
    int most = PARADT__CURVE_BITS / dim < 31 ? PARADT__CURVE_BITS / dim : 31;
    int levels = paradt__whole_steps((paradt__bit_length(count) + 10) / dim + 1, dim);
    return levels < most ? levels : most;
}

// Coordinate of a point of the box in the lattice's units
PARADT__INLINE uint64_t paradt__lattice_place(const paradt__lattice *lattice, int axis, double x) {
    int64_t place = lattice->by_steps ? paradt__ordered_bits(x) : paradt__fixed_point(x, lattice->exponent[axis]);
    return (uint64_t)place - (uint64_t)lattice->low[axis];
}

// Chooses the unit of each axis, so that the box fits into 62 bits. On an axis without extent all places are 0.
static void paradt__lattice_units(paradt__lattice *lattice, const int64_t *low, const int64_t *high) {
    int axis, largest = -1074, own;
    for (axis = 0; axis < lattice->dim; axis++) {
        if (low[axis] >= high[axis]) continue;
        paradt__split(paradt__from_ordered_bits(low[axis]), &own);
        largest = own > largest ? own : largest;
        paradt__split(paradt__from_ordered_bits(high[axis]), &own);
        largest = own > largest ? own : largest;
    }
    for (axis = 0; axis < lattice->dim; axis++)
        lattice->exponent[axis] = low[axis] < high[axis] ? largest : PARADT__FLAT;
}

// Lays the lattice over a box. low, high: its corners, as ordered bits. If the box has an extent, its corners get
// different places.
static void paradt__lattice_begin(paradt__lattice *lattice, int dim, int levels, int by_steps, const int64_t *low,
                                  const int64_t *high) {
    uint64_t longest = 0;
    int axis;
    PARADT_ASSERT(dim > 0 && dim <= PARADT_MAX_DIM && levels <= 32 && dim * levels <= 64);
    memset(lattice, 0, sizeof *lattice);
    lattice->dim = dim;
    lattice->levels = levels;
    lattice->by_steps = by_steps;
    paradt__lattice_units(lattice, low, high);
    for (axis = 0; axis < dim; axis++) {
        uint64_t side;
        lattice->low[axis] = (int64_t)paradt__lattice_place(lattice, axis, paradt__from_ordered_bits(low[axis]));
        side = paradt__lattice_place(lattice, axis, paradt__from_ordered_bits(high[axis]));
        longest = side > longest ? side : longest;
    }
    lattice->shift = paradt__bit_length(longest) - levels;
    if (lattice->shift < 0) lattice->shift = 0;
}

// --- the curve

// One level of the curve in `dim` dimensions. Takes one bit of each coordinate to `dim` bits of the key, and the
// orientation of the curve (entry corner and direction) to its orientation inside of the orthant.
PARADT__INLINE unsigned paradt__hilbert_step(int dim, unsigned bits, unsigned *entry, unsigned *direction) {
    unsigned n = (unsigned)dim, all = (1u << n) - 1, rotation = *direction + 1, place, start;
    bits ^= *entry;
    bits = (bits >> rotation | bits << (n - rotation)) & all;
    place = bits;
    place ^= place >> 1;
    place ^= place >> 2;
    place ^= place >> 4;
    start = (place - (place != 0)) & ~1u;
    start ^= start >> 1;
    *entry ^= (start << rotation | start >> (n - rotation)) & all;
    // counts the trailing ones of an odd place, or of the place before an even one
    *direction = (rotation + (unsigned)paradt__trailing_zeros(((place + 1) & ~1u) | 1u << n)) % n;
    return place;
}

// In two and three dimensions steps come from tables. An entry is found by the orientation and the coordinates' bits,
// the first coordinate's lowest; it holds the key's bits and above them the next orientation.
typedef struct paradt__hilbert {
    int dim;
    int many;                                                  // 1: `steps` is filled
    uint16_t step[PARADT__ORIENTATIONS << 3];                  // of one level
    uint16_t steps[PARADT__ORIENTATIONS << PARADT__STEP_BITS]; // of PARADT__STEP_BITS / dim levels
} paradt__hilbert;

// Returns the entry for several levels one after another.
static uint16_t paradt__hilbert_steps(const paradt__hilbert *hilbert, unsigned orientation, unsigned coordinates) {
    unsigned dim = (unsigned)hilbert->dim, levels = PARADT__STEP_BITS / dim, key = 0, level, j;
    for (level = levels; level-- > 0;) {
        unsigned bits = 0, step;
        for (j = 0; j < dim; j++) bits |= (coordinates >> (j * levels + level) & 1) << j;
        step = hilbert->step[orientation << dim | bits];
        key = key << dim | (step & ((1u << dim) - 1));
        orientation = step >> dim;
    }
    return (uint16_t)(orientation << PARADT__STEP_BITS | key);
}

// Fills the table of one level: in every orientation its steps are those of the first one, rotated and mirrored.
// Inlined with a constant.
PARADT__INLINE void paradt__hilbert_table(paradt__hilbert *hilbert, int dim) {
    unsigned n = (unsigned)dim, all = (1u << n) - 1, bits, corner, rotation;
    for (bits = 0; bits <= all; bits++) {
        unsigned entry = 0, direction = n - 1, place = paradt__hilbert_step(dim, bits, &entry, &direction);
        for (rotation = 1; rotation <= n; rotation++) {
            unsigned rotated = (bits << rotation | bits >> (n - rotation)) & all;
            unsigned leave = (entry << rotation | entry >> (n - rotation)) & all, next = (direction + rotation) % n;
            for (corner = 0; corner <= all; corner++) {
                unsigned from = (corner * n + rotation - 1) << n | (rotated ^ corner);
                hilbert->step[from] = (uint16_t)(((leave ^ corner) * n + next) << n | place);
            }
        }
    }
}

// Fills the tables for about `keys` keys.
PARADT__HOT void paradt__hilbert_begin(paradt__hilbert *hilbert, int dim, size_t keys) {
    unsigned orientations = (unsigned)dim << dim, orientation, bits;
    hilbert->dim = dim;
    hilbert->many = dim > 1 && dim < 4 && keys >= PARADT__MANY_KEYS;
    if (PARADT_MAX_DIM > 2 && dim == 3) paradt__hilbert_table(hilbert, 3);
    if (dim == 2) paradt__hilbert_table(hilbert, 2);
    for (orientation = 0; hilbert->many && orientation < orientations; orientation++) {
        for (bits = 0; bits < 1u << PARADT__STEP_BITS; bits++)
            hilbert->steps[orientation << PARADT__STEP_BITS | bits] = paradt__hilbert_steps(hilbert, orientation, bits);
    }
}

// Makes a key by a table with steps of so many levels. Inlined with constants.
PARADT__INLINE uint64_t paradt__hilbert_key_by(const uint16_t *table, int dim, int step_levels, const uint32_t *x,
                                               int levels) {
    const unsigned mask = (1u << step_levels) - 1, places = (1u << (dim * step_levels)) - 1;
    uint64_t key = 0;
    unsigned step = 0;
    int level, j;
    for (level = levels - step_levels; level >= 0; level -= step_levels) {
        unsigned bits = 0;
        for (j = 0; j < dim; j++) bits |= (x[j] >> level & mask) << (j * step_levels);
        step = table[(step & ~places) | bits];
        key = key << (dim * step_levels) | (step & places);
    }
    return key;
}

// Returns the key of a point of the lattice's box: its position on the curve, of dim * levels bits.
PARADT__INLINE uint64_t paradt__hilbert_key(const paradt__hilbert *hilbert, const paradt__lattice *lattice,
                                            const double *point) {
    uint32_t x[PARADT_MAX_DIM];
    uint64_t key = 0;
    unsigned entry = 0, direction = 0;
    int levels = lattice->levels, dim = lattice->dim, level, j;
    for (j = 0; j < dim; j++) x[j] = (uint32_t)(paradt__lattice_place(lattice, j, point[j]) >> lattice->shift);
    if (PARADT_MAX_DIM > 2 && dim == 3 && hilbert->many) return paradt__hilbert_key_by(hilbert->steps, 3, 2, x, levels);
    if (dim == 2 && hilbert->many) return paradt__hilbert_key_by(hilbert->steps, 2, 3, x, levels);
    if (PARADT_MAX_DIM > 2 && dim == 3) return paradt__hilbert_key_by(hilbert->step, 3, 1, x, levels);
    if (dim == 2) return paradt__hilbert_key_by(hilbert->step, 2, 1, x, levels);
    for (level = levels - 1; level >= 0; level--) {
        unsigned bits = 0;
        for (j = 0; j < dim; j++) bits |= (x[j] >> level & 1) << j;
        key = key << dim | paradt__hilbert_step(dim, bits, &entry, &direction);
    }
    return key;
}

// --- records along the curve

// The curve through a box
typedef struct paradt__curve {
    paradt__hilbert hilbert;
    paradt__lattice lattice;
    int64_t low[PARADT_MAX_DIM], high[PARADT_MAX_DIM]; // points outside of this part of the box get its nearest place
} paradt__curve;

// Begins the curve through the box with the corners low and high, as ordered bits. levels: see paradt__levels_for.
// keys: about how many will be made.
static void paradt__curve_begin(paradt__curve *curve, int dim, int levels, const int64_t *low, const int64_t *high,
                                size_t keys) {
    paradt__hilbert_begin(&curve->hilbert, dim, keys);
    paradt__lattice_begin(&curve->lattice, dim, levels, 0, low, high);
    memcpy(curve->low, low, (size_t)dim * sizeof *low);
    memcpy(curve->high, high, (size_t)dim * sizeof *high);
}

// Limits the curve to a part of its box.
PARADT__OPTIONAL void paradt__curve_limit(paradt__curve *curve, const int64_t *low, const int64_t *high) {
    int axis;
    for (axis = 0; axis < curve->lattice.dim; axis++) {
        curve->low[axis] = low[axis] > curve->low[axis] ? low[axis] : curve->low[axis];
        curve->high[axis] = high[axis] < curve->high[axis] ? high[axis] : curve->high[axis];
    }
}

// Returns the key of the curve's place that is nearest to a point.
static uint64_t paradt__curve_key(const paradt__curve *curve, const double *point) {
    double inside[PARADT_MAX_DIM];
    int axis;
    for (axis = 0; axis < curve->lattice.dim; axis++) {
        int64_t x = paradt__ordered_bits(point[axis]);
        x = x < curve->low[axis] ? curve->low[axis] : x > curve->high[axis] ? curve->high[axis] : x;
        inside[axis] = paradt__from_ordered_bits(x);
    }
    return paradt__hilbert_key(&curve->hilbert, &curve->lattice, inside);
}

// Sorts records along the curve. On entry keyed[i].item are the positions of the records; the keys are made here.
// other: scratch for as many.
static void paradt__curve_sort(const paradt__curve *curve, const double *records, size_t width, paradt__keyed *keyed,
                               paradt__keyed *other, size_t count) {
    size_t i;
    for (i = 0; i < count; i++) keyed[i].key = paradt__curve_key(curve, records + (size_t)keyed[i].item * width);
    paradt__keyed_sort(keyed, other, count, curve->lattice.dim * curve->lattice.levels, 0);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>points
//
// The set: the caller's points as records, which everything below works on. A record holds the coordinates of one
// point and, where there is one, its grade: the weight, or the sagitta of >>reference sphere. Records are finite and
// distinct, -0.0 is 0.0 in them, and the first `dim` coordinates orient (dim: the affine dimension of the set).
// A point has two numbers. Its *index* is where the caller has it; its *position* is where the set has its record;
// origin[position] is the index. This section has the set itself and how one point is read; the set is made in the
// sections >>reading, >>sorting and >>scale and axes.
// Doors: paradt__record, paradt__copy_record, paradt__set_free, paradt__hash_coordinates, paradt__source_of,
// paradt__weight_size, paradt__read_record, paradt__coordinates, paradt__fetch_point.

enum {
    PARADT__UNGRADED,
    PARADT__WEIGHT,
    PARADT__SAGITTA // weight and lift in one: r^2 - |x - o|^2 for the reference sphere of the set
};

typedef struct paradt__set {
    paradt__space space;
    size_t count;                  // distinct points
    int grade;                     // what follows the coordinates in a record: nothing, a weight or a sagitta
    double grade_error;            // sagittas: bound on the error of each,
    double grade_limit;            // ... bound on their size,
    double centre[PARADT_MAX_DIM]; // ... centre of the reference sphere
    int exponent;                  // the largest of a coordinate as the caller has it, with IEEE's bias
    size_t width;                  // doubles a record
    double *records;               // [capacity][width] by position
    paradt_index *origin;          // [capacity] by position: the caller's index
    size_t capacity;               // number of points that the arrays have memory for
    int axes[PARADT_MAX_DIM];      // the caller's axis that each coordinate of a record is along
} paradt__set;

PARADT__INLINE const double *paradt__record(const paradt__set *set, paradt_index position) {
    PARADT_ASSERT(position >= 0);
    return set->records + (size_t)position * set->width;
}

PARADT__INLINE void paradt__copy_record(double *to, const double *from, size_t width) {
    size_t i;
    if (width == 3) {
        to[0] = from[0];
        to[1] = from[1];
        to[2] = from[2];
        return;
    }
    for (i = 0; i < width; i++) to[i] = from[i];
}

static void paradt__set_free(paradt__set *set, paradt__memory *memory) {
    paradt__release(memory, set->records);
    paradt__release(memory, set->origin);
    set->records = NULL;
    set->origin = NULL;
}

// Returns a hash of a point's coordinates. Equal points have equal hashes.
PARADT__OPTIONAL uint64_t paradt__hash_coordinates(const double *record, int ambient) {
    uint64_t h = 0, bits;
    int axis;
    for (axis = 0; axis < ambient; axis++) {
        memcpy(&bits, record + axis, sizeof bits);
        h = paradt__mix(h + bits) + UINT64_C(0x9e3779b97f4a7c15);
    }
    return h;
}

// --- reading one point

// Where points are read from: the caller's arrays, or other arrays in which a weight stands with each point
typedef struct paradt__source {
    paradt_points points;
    size_t weight_stride; // bytes from one weight to the next
    size_t reserve;       // number of further points that the set's arrays are to have memory for
} paradt__source;

static size_t paradt__weight_size(const paradt_points *points) {
    return points->weight_scalar == PARADT_F32 ? sizeof(float) : sizeof(double);
}

static paradt__source paradt__source_of(const paradt_points *points) {
    paradt__source source;
    source.points = *points;
    source.weight_stride = points->weight_stride ? points->weight_stride : paradt__weight_size(points);
    source.reserve = 0;
    return source;
}

PARADT__INLINE const char *paradt__address(const paradt_points *points, size_t index) {
    size_t size = points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double);
    return (const char *)points->data + index * (points->stride ? points->stride : size * (size_t)points->dim);
}

enum {
    // Passes over all points fetch points so far ahead of their use. Processors do that themselves, but only within a
    // page.
    PARADT__POINTS_AHEAD = 64,
    PARADT__PACE = 1 << 15 // points between two looks at whether the call is cancelled
};

// Fetches a point ahead of its use; there may be no point with the index. It may lie across the border of two cache
// lines.
PARADT__INLINE void paradt__fetch_point(const paradt_points *points, size_t index) {
    size_t size = (points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double)) * (size_t)points->dim;
    size_t begin = index * (points->stride ? points->stride : size);
    PARADT__FETCH((const char *)points->data, begin);
    PARADT__FETCH((const char *)points->data, begin + size - 1);
}

// The double with these bits; 0.0 for the bits of -0.0
PARADT__INLINE double paradt__signless_zero(uint64_t bits) {
    return paradt__from_bits(bits << 1 ? bits : 0);
}

// Reads the coordinates of a point, -0.0 as 0.0. There are two loops, so that compilers unroll the short one.
PARADT__INLINE void paradt__coordinates(const paradt_points *points, size_t index, double *x) {
    const char *address = paradt__address(points, index);
    int axis;
    if (points->scalar == PARADT_F32) {
        for (axis = 0; axis < points->dim; axis++) {
            uint32_t bits;
            memcpy(&bits, address + (size_t)axis * sizeof bits, sizeof bits);
            x[axis] = paradt__signless_zero(paradt__bits(paradt__widen(bits)));
        }
    } else {
        for (axis = 0; axis < points->dim; axis++) {
            uint64_t bits;
            memcpy(&bits, address + (size_t)axis * sizeof bits, sizeof bits);
            x[axis] = paradt__signless_zero(bits);
        }
    }
}

// Reads the weight of a point, -0.0 as 0.0.
static double paradt__weight(const paradt__source *source, size_t index) {
    const char *address = (const char *)source->points.weights + index * source->weight_stride;
    uint64_t bits;
    if (source->points.weight_scalar == PARADT_F32) {
        uint32_t narrow;
        memcpy(&narrow, address, sizeof narrow);
        bits = paradt__bits(paradt__widen(narrow));
    } else {
        memcpy(&bits, address, sizeof bits);
    }
    return paradt__signless_zero(bits);
}

// Reads a point into a record. Returns the largest exponent of its coordinates, with IEEE's bias: 2047 when a
// coordinate or the weight is no finite number.
PARADT__INLINE int paradt__read_record(const paradt__source *source, size_t index, double *record) {
    const paradt_points *points = &source->points;
    int axis, dim = points->dim, largest = 0;
    paradt__coordinates(points, index, record);
    for (axis = 0; axis < dim; axis++) {
        int exponent = paradt__biased_exponent(record[axis]);
        largest = exponent > largest ? exponent : largest;
    }
    if (!points->weights) return largest;
    record[dim] = paradt__weight(source, index);
    return paradt__is_finite(record[dim]) ? largest : 2047;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>measures
//
// What several sections ask about a set or a part of it: along which axis it is longest, how far its points are from
// their neighbours, and which of its points span it. The first two steer the work and are estimates in floating-point
// arithmetic; the last is exact.
// Doors: paradt__longest_axis, paradt__spacing, paradt__margin_for, paradt__set_basis.

// Returns the axis along which a box is longest, the first of several. by_steps: lengths are numbers of steps from one
// double to the next; else they are differences of coordinates, halved as a difference may overflow.
PARADT__INLINE int paradt__longest_axis(const double *low, const double *high, int dim, int by_steps) {
    double length = -1.0;
    int axis, longest = 0;
    PARADT_ASSERT(dim > 0);
    for (axis = 0; axis < dim; axis++) {
        double side =
            by_steps ? (double)paradt__ordered_bits(high[axis]) * 0.5 - (double)paradt__ordered_bits(low[axis]) * 0.5
                     : high[axis] * 0.5 - low[axis] * 0.5;
        if (side > length) length = side, longest = axis;
    }
    return longest;
}

// --- the density of the points

// Estimates how far apart points are that stand beside each other along a curve: the median, over a sample of groups
// of eight points in a row, of the longest side of the group's bounding box. That is about two distances between
// neighbours. order: the positions along the curve; NULL: the records are along it.
static double paradt__spacing(const double *records, size_t width, int dim, const paradt_index *order, size_t count) {
    enum { SAMPLE = 63, TOGETHER = 8 };
    double sides[SAMPLE];
    int axis, i, j;
    if (count == 0) return 0.0;
    for (i = 0; i < SAMPLE; i++) {
        size_t first = (count + TOGETHER - 1) / TOGETHER * (size_t)i / SAMPLE * TOGETHER, at;
        size_t end = first + TOGETHER < count ? first + TOGETHER : count;
        double longest = 0.0;
        for (axis = 0; axis < dim; axis++) {
            double low = 0.0, high = 0.0;
            for (at = first; at < end; at++) {
                double x = records[(order ? (size_t)order[at] : at) * width + (size_t)axis];
                low = at == first || x < low ? x : low;
                high = at == first || x > high ? x : high;
            }
            longest = high - low > longest ? high - low : longest;
        }
        for (j = i; j > 0 && sides[j - 1] > longest; j--) sides[j] = sides[j - 1];
        sides[j] = longest;
    }
    return sides[SAMPLE / 2];
}

#define PARADT__MARGIN_PART 0.7 // of paradt__spacing

// Returns the width of the margin beside a cut: points of the other side within it are taken to be neighbours of this
// side's. It is about one and a half distances between neighbours. spacing: by paradt__spacing.
static double paradt__margin_for(double spacing) {
    return PARADT__MARGIN_PART * spacing;
}

// --- points that span a set

// Is x outside of the affine hull of the taken + 1 points, seen in the axes taken and one more?
static int paradt__extends(paradt__counters *counters, int taken, const double *const *points, const int *axes,
                           const double *x) {
    double copies[PARADT_MAX_DIM + 1][PARADT_MAX_DIM + 1];
    const double *pointers[PARADT_MAX_DIM + 1];
    paradt__space view; // its own: bounds hold for one dimension, and for coordinates at their places
    int i, j, independent;
    memset(copies, 0, sizeof copies);
    paradt__space_begin(&view, taken + 1, taken + 1, 0);
    for (i = 0; i <= taken + 1; i++) {
        const double *from = i <= taken ? points[i] : x;
        for (j = 0; j <= taken; j++) copies[i][j] = from[axes[j]];
        pointers[i] = copies[i];
        paradt__space_add(&view, copies[i]);
    }
    paradt__space_end(&view);
    view.counters = *counters;
    independent = paradt__orient(&view, pointers) != 0;
    *counters = view.counters;
    return independent;
}

static int paradt__is_among(int number, const int *numbers, int count) {
    while (count > 0 && numbers[count - 1] != number) count--;
    return count > 0;
}

// Returns the first place in the order, from `from` on and then from the beginning, whose point is outside of the
// affine hull of the taken + 1 points of the basis, seen in the axes taken and one more; set->count: there is none.
static size_t paradt__find_outside(const paradt__set *set, const paradt_index *order, size_t from, int taken,
                                   const paradt_index *basis, const int *axes, paradt__counters *counters,
                                   paradt__meter *meter) {
    const double *points[PARADT_MAX_DIM + 1];
    size_t step;
    int i;
    for (i = 0; i <= taken; i++) points[i] = paradt__record(set, basis[i]);
    for (step = 0; step < set->count; step++) {
        size_t at = (from + step) % set->count;
        const double *x = paradt__record(set, order ? order[at] : (paradt_index)at);
        if (meter && step % PARADT__PACE == PARADT__PACE - 1 && paradt__meter_cancels(meter)) break;
        for (i = 0; i <= taken && points[i] != x;) i++; // a point of the basis does not extend it
        if (i > taken && paradt__extends(counters, taken, points, axes, x)) return at;
    }
    return set->count;
}

// Finds points that span the set. Returns their number: one more than the affine dimension of the set, 0 if it is
// empty. Axes are taken greedily, from the first to the last; each comes with the first point that extends the basis.
//   order     positions, in the order in which points are tried; NULL: the order of the set, from basis[0] on
//   given     number of points that are already in the basis: none, one, or two different ones
//   basis     positions of the points; [dim + 1], with axes [ambient + 1]
//   axes      NULL: only the set's first `dim` axes count, which orient. Else [ambient], and all axes count: on return
//             the axes in which the points are independent come first, one fewer than points, then the others
//   counters  of predicates
//   meter     NULL, or asked now and then; when it cancels, the rest of the set is not looked at
PARADT__COLD int paradt__set_basis(const paradt__set *set, const paradt_index *order, int given, paradt_index *basis,
                                   int *axes, paradt__counters *counters, paradt__meter *meter) {
    int unasked[PARADT_MAX_DIM], taken = 0, dim, axis, all = axes ? set->space.ambient : set->space.dim;
    size_t from = given && !order ? (size_t)basis[0] : 0;
    PARADT_ASSERT(given >= 0 && given <= 2 && (size_t)given <= set->count);
    PARADT_ASSERT(from < set->count || !set->count);
    if (!axes) axes = unasked;
    if (!given && set->count) basis[0] = order ? order[0] : 0;
    if (given == 2) {
        const double *a = paradt__record(set, basis[0]), *b = paradt__record(set, basis[1]);
        for (axis = 0; paradt__bits(a[axis]) == paradt__bits(b[axis]);) axis++;
        axes[taken++] = axis;
    }
    for (axis = 0; axis < all && set->count; axis++) {
        size_t at;
        if (paradt__is_among(axis, axes, taken)) continue;
        axes[taken] = axis;
        at = paradt__find_outside(set, order, from, taken, basis, axes, counters, meter);
        if (at < set->count) basis[++taken] = order ? order[at] : (paradt_index)at;
    }
    dim = taken;
    for (axis = 0; axis < all; axis++) {
        if (!paradt__is_among(axis, axes, taken)) axes[taken++] = axis;
    }
    return set->count ? dim + 1 : 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>cuts
//
// Space is divided into boxes, one for each region, by cutting a box in two again and again: where each side gets its
// part of the points (bisection), or of the volume (uniform); the thesis, chapters 4 and 6. A point on a cut belongs to
// the upper side; the outer boxes are unbounded. The boxes of the upper side come first. Where exactly the cuts are
// matters for speed only, so they are found by a sample of the points.
// Doors: paradt__cut_is_above, paradt__cuts_find, paradt__cuts_nearest, paradt__cuts_box, paradt__cuts_end,
// paradt__cuts_reserve, paradt__cuts_mark, paradt__cuts_follow, paradt__select_key, paradt__cutter_divide.

typedef struct paradt__cut {
    double at;
    int axis;
    size_t begin; // position of the first point of the box below, in a set in the order of the boxes
} paradt__cut;

typedef struct paradt__cuts {
    size_t boxes;
    paradt_partition partition;
    int larger_first; // 1: box 0 gets more points than others. By insertion its region looks for no points of others
    int gaps;         // 1: the set is to have memory for gaps between the boxes' points, where a region adds others'
    paradt__cut *cut; // [boxes] cut[i] is between boxes before i and those from i on; cut[0] is not used
} paradt__cuts;

PARADT__INLINE int paradt__cut_is_above(const paradt__cut *cut, const double *x) {
    return paradt__ordered_bits(cut->at) > paradt__ordered_bits(x[cut->axis]);
}

// Returns the box of a point. Without a branch for the side: processors would predict half of them wrongly.
PARADT__INLINE size_t paradt__cuts_find(const paradt__cuts *cuts, const double *x) {
    size_t first = 0, boxes = cuts->boxes;
    PARADT_ASSERT(boxes > 0);
    while (boxes > 1) {
        size_t below = (size_t)paradt__cut_is_above(cuts->cut + first + boxes / 2, x);
        first += boxes / 2 * below;
        boxes = boxes / 2 + (boxes & below);
    }
    return first;
}

// Returns the cut nearest to x among the cuts that bound its box, the first of several; NULL: no cut does. Distances
// are rounded: all that matters is that they never get smaller as a point moves away from the cut.
PARADT__OPTIONAL const paradt__cut *paradt__cuts_nearest(const paradt__cuts *cuts, const double *x) {
    const paradt__cut *nearest = NULL;
    size_t first = 0, boxes = cuts->boxes;
    int64_t least = 0;
    while (boxes > 1) {
        const paradt__cut *cut = cuts->cut + first + boxes / 2;
        int64_t distance = paradt__ordered_bits(paradt__abs(x[cut->axis] - cut->at));
        if (!nearest || distance < least) nearest = cut, least = distance;
        if (paradt__cut_is_above(cut, x)) first += boxes / 2, boxes -= boxes / 2;
        else boxes /= 2;
    }
    return nearest;
}

// Writes the bounds of a box into low and high. Where the box has no bound, the value there stays.
PARADT__OPTIONAL void paradt__cuts_box(const paradt__cuts *cuts, size_t box, double *low, double *high) {
    size_t first = 0, boxes = cuts->boxes;
    PARADT_ASSERT(box < boxes);
    while (boxes > 1) {
        const paradt__cut *cut = cuts->cut + first + boxes / 2;
        if (box < first + boxes / 2) {
            low[cut->axis] = cut->at;
            boxes /= 2;
        } else {
            high[cut->axis] = cut->at;
            first += boxes / 2;
            boxes -= boxes / 2;
        }
    }
}

// Position after the last point of a box, in a set of `count` points in the order of the boxes
PARADT__OPTIONAL size_t paradt__cuts_end(const paradt__cuts *cuts, size_t box, size_t count) {
    return box + 1 < cuts->boxes ? cuts->cut[box + 1].begin : count;
}

// Number of points that a set of `count` points needs memory for besides, to have gaps between the boxes' points
static size_t paradt__cuts_reserve(const paradt__cuts *cuts, size_t count) {
    return cuts && cuts->gaps && cuts->boxes > 1 ? count / 8 + 64 * cuts->boxes : 0;
}

// Notes where each box begins in a set in the order of the boxes. Its records are as they were read.
static void paradt__cuts_mark(paradt__cuts *cuts, const paradt__set *set) {
    size_t box;
    for (box = 1; box < cuts->boxes; box++) {
        size_t begin = box > 1 ? cuts->cut[box - 1].begin : 0, end = set->count;
        while (begin < end) {
            size_t middle = begin + (end - begin) / 2;
            if (paradt__cuts_find(cuts, paradt__record(set, (paradt_index)middle)) < box) begin = middle + 1;
            else end = middle;
        }
        cuts->cut[box].begin = begin;
    }
}

// Adapts cuts to a set whose axes have been permuted and, if `scaled`, whose coordinates have been scaled. A cut that
// is no point's coordinate may lose bits, which are cut off; it becomes larger then instead of smaller, so that each
// point stays on its side.
static void paradt__cuts_follow(paradt__cuts *cuts, const paradt__set *set, int scaled) {
    size_t box;
    for (box = 1; box < cuts->boxes; box++) {
        paradt__cut *cut = cuts->cut + box;
        int axis = 0, exact = 1;
        if (scaled) cut->at = paradt__scale(cut->at, 1023 - set->exponent, &exact);
        if (!exact && !(paradt__bits(cut->at) >> 63)) cut->at = paradt__from_bits(paradt__bits(cut->at) + 1);
        while (set->axes[axis] != cut->axis) axis++;
        cut->axis = axis;
    }
}

// --- finding the cuts

// Returns a key that is likely to be near the nth smallest: the corresponding one of a sample.
static int64_t paradt__pivot_key(const int64_t *keys, size_t count, size_t nth) {
    enum { SAMPLE = 31 };
    int64_t sample[SAMPLE];
    size_t i, j, some = count < SAMPLE ? 1 : SAMPLE;
    for (i = 0; i < some; i++) {
        int64_t key = keys[count / some * i + count / some / 2];
        for (j = i; j > 0 && sample[j - 1] > key; j--) sample[j] = sample[j - 1];
        sample[j] = key;
    }
    return sample[(size_t)((double)nth / (double)count * (double)some)];
}

// Returns the nth smallest key and permutes the keys (quickselect).
static int64_t paradt__select_key(int64_t *keys, size_t count, size_t nth) {
    size_t begin = 0, end = count;
    PARADT_ASSERT(nth < count);
    while (end - begin > 1) {
        int64_t pivot = paradt__pivot_key(keys + begin, end - begin, nth - begin);
        size_t i = begin, j = end - 1;
        for (;;) {
            int64_t t;
            while (keys[i] < pivot) i++;
            while (pivot < keys[j]) j--;
            if (i >= j) break;
            t = keys[i];
            keys[i++] = keys[j];
            keys[j--] = t;
        }
        if (i == j && nth == i) return pivot;
        if (nth < i) end = i;
        else begin = i == j ? i + 1 : i;
    }
    return keys[begin];
}

// A sample of points by which space is divided
typedef struct paradt__cutter {
    paradt__cuts *cuts;
    int dim;
    const double *sample; // [count][dim]
    paradt_index *order;  // [count] positions in the sample, permuted so that those of a box are a range
    int64_t *keys;        // [count] scratch for the coordinates of a box along one axis, as ordered bits
    size_t count;
    size_t extra; // points of the sample that box 0 gets more than the others
} paradt__cutter;

PARADT__INLINE int64_t paradt__cutter_key(const paradt__cutter *c, paradt_index position, int axis) {
    return paradt__ordered_bits(c->sample[(size_t)position * (size_t)c->dim + (size_t)axis]);
}

// Finds the bounding box of the points [begin, end) of the order, of which there are some.
static void paradt__cutter_bound(const paradt__cutter *c, size_t begin, size_t end, double *low, double *high) {
    int axis;
    size_t i;
    for (axis = 0; axis < c->dim; axis++) {
        int64_t least = INT64_MAX, most = INT64_MIN;
        for (i = begin; i < end; i++) {
            int64_t key = paradt__cutter_key(c, c->order[i], axis);
            least = key < least ? key : least;
            most = key > most ? key : most;
        }
        low[axis] = paradt__from_ordered_bits(least);
        high[axis] = paradt__from_ordered_bits(most);
    }
}

// Returns the coordinate at which to cut a box, above for the first half of `boxes`, one of which is to have `extra`
// points more.
static double paradt__cutter_coordinate(const paradt__cutter *c, size_t begin, size_t end, size_t boxes, size_t extra,
                                        int axis, const double *low, const double *high) {
    double above = (double)(boxes / 2) / (double)boxes;
    size_t count = end - begin, even = count - (extra < count ? extra : 0), i;
    if (c->cuts->partition == PARADT_UNIFORM || begin == end) return low[axis] * above + high[axis] * (1.0 - above);
    for (i = begin; i < end; i++) c->keys[i - begin] = paradt__cutter_key(c, c->order[i], axis);
    return paradt__from_ordered_bits(paradt__select_key(c->keys, count, (size_t)((double)even * (1.0 - above))));
}

// Divides one box, which has the points [begin, end) of the order, into `boxes`, and writes the cuts between these
// boxes, which are numbered from `first` on. low, high: bounds of the box, or of all points.
PARADT__COLD void paradt__cutter_divide(paradt__cutter *c, size_t begin, size_t end, const double *low,
                                        const double *high, size_t first, size_t boxes) {
    double below[PARADT_MAX_DIM], above[PARADT_MAX_DIM], cut_low[PARADT_MAX_DIM], cut_high[PARADT_MAX_DIM];
    size_t i, middle = begin, bytes = sizeof(double) * (size_t)c->dim;
    paradt__cut *cut = c->cuts->cut + first + boxes / 2;
    PARADT_ASSERT(begin <= end && end <= c->count && boxes > 0 && first + boxes <= c->cuts->boxes);
    if (boxes == 1) return;
    memcpy(below, low, bytes);
    memcpy(above, high, bytes);
    if (c->cuts->partition == PARADT_BISECTION && begin < end && boxes < c->cuts->boxes)
        paradt__cutter_bound(c, begin, end, below, above);
    cut->axis = paradt__longest_axis(below, above, c->dim, 0);
    cut->at = paradt__cutter_coordinate(c, begin, end, boxes, first ? 0 : c->extra, cut->axis, below, above);
    for (i = begin; i < end; i++) {
        paradt_index position = c->order[i];
        c->order[i] = c->order[middle];
        c->order[middle] = position;
        middle += (size_t)(paradt__cutter_key(c, position, cut->axis) >= paradt__ordered_bits(cut->at));
    }
    memcpy(cut_low, below, bytes);
    memcpy(cut_high, above, bytes);
    cut_low[cut->axis] = cut_high[cut->axis] = cut->at;
    paradt__cutter_divide(c, begin, middle, cut_low, above, first, boxes / 2);
    paradt__cutter_divide(c, middle, end, below, cut_high, first + boxes / 2, boxes - boxes / 2);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>reading
//
// The first pass over the caller's points, shared between the tasks of a team: finds the first point that is not
// finite, measures the set for the predicates, takes a sample, and makes the pages of the memory that is filled from
// then on. The loader is the state that this pass shares with the passes of >>sorting. Each pass asks every few
// thousand points whether the call is cancelled. Doors: paradt__loader_begin, paradt__loader_allocate,
// paradt__loader_free, paradt__loader_range, paradt__loader_cancels, paradt__loader_survey.

enum {
    PARADT__MOST_FIRST_BITS = 8,  // bits of a key that all points are scattered by first, at most
    PARADT__FEW_SAMPLED = 1 << 9, // sampled points that tell whether points are crowded
    PARADT__CUT_SAMPLED = 1 << 16 // sampled points that tell where space is cut
};

// The passes over the points, and where each begins in the progress of them all
enum {
    PARADT__SURVEY = 0,
    PARADT__KEYS = 20,
    PARADT__SCATTER = 45,
    PARADT__SORT = 50,
    PARADT__GATHER = 80,
    PARADT__LOADED = 100
};

typedef struct paradt__loader {
    const paradt__team *team;
    const paradt__source *source;
    paradt__set *set;
    paradt_index *representative;         // [points.count] by index
    paradt__cuts *cuts;                   // NULL: there is one box
    size_t bad[PARADT__MOST_TASKS];       // by task: index of the first point that is not finite; SIZE_MAX: none
    size_t repeating[PARADT__MOST_TASKS]; // by task: points that are not the first at their place
    paradt__space space[PARADT__MOST_TASKS];
    double *sample;         // [sampled][dim] points that tell how all are spread, in memory of the records
    size_t sampled;         // 0 to PARADT__CUT_SAMPLED
    paradt__keyed *keyed;   // [points.count]
    paradt__keyed *scratch; // [points.count] the sort's scratch buffer, in memory of the records
    size_t *next;           // [tasks][2^first_bits] by first digit: where the task's next such point goes
    int first_bits;         // bits of a key's first digit, at most
    int shift;              // bits of a key below its first digit, which has the box's number, if there are boxes
    size_t digits;          // values that the first digit may have
    paradt__lattice lattice;
    paradt__hilbert hilbert;
} paradt__loader;

static void paradt__loader_begin(paradt__loader *loader, paradt__set *set, const paradt__source *source,
                                 paradt__cuts *cuts, const paradt__team *team, paradt_index *representative) {
    memset(loader, 0, offsetof(paradt__loader, hilbert));
    loader->set = set;
    loader->source = source;
    loader->cuts = cuts && cuts->boxes > 1 ? cuts : NULL;
    loader->team = team;
    loader->representative = representative;
    set->grade = source->points.weights ? PARADT__WEIGHT : PARADT__UNGRADED;
    set->width = (size_t)source->points.dim + (source->points.weights != NULL);
    paradt__space_begin(&set->space, source->points.dim, source->points.dim, source->points.weights != NULL);
}

// Allocates the arrays of the set and the loader, and the cuts; paradt__loader_free, paradt__set_free and the owner of
// the cuts free them. Until it is filled, the record array holds the sample and then is the sort's scratch buffer, so
// its pages are touched only once.
static paradt_status paradt__loader_allocate(paradt__loader *loader, paradt__memory *memory) {
    paradt__set *set = loader->set;
    size_t count = loader->source->points.count;
    loader->first_bits = paradt__min(paradt__bit_length(count), PARADT__MOST_FIRST_BITS) + (loader->cuts != NULL);
    set->capacity = count + loader->source->reserve;
    loader->keyed = (paradt__keyed *)paradt__alloc(memory, count, sizeof *loader->keyed);
    loader->next = (size_t *)paradt__alloc(memory, loader->team->tasks << loader->first_bits, sizeof *loader->next);
    set->records = (double *)paradt__alloc(memory, set->capacity, set->width * sizeof(double));
    set->origin = (paradt_index *)paradt__alloc(memory, set->capacity, sizeof *set->origin);
    loader->sample = set->records;
    loader->sampled = loader->cuts                ? (size_t)PARADT__CUT_SAMPLED
                      : count < PARADT__MANY_KEYS ? 0
                                                  : (size_t)PARADT__FEW_SAMPLED;
    if (loader->sampled > count) loader->sampled = count;
    if (loader->cuts) {
        loader->cuts->cut = (paradt__cut *)paradt__alloc(memory, loader->cuts->boxes, sizeof *loader->cuts->cut);
        if (!loader->cuts->cut) return PARADT_ERROR_MEMORY;
    }
    if (!loader->keyed || !loader->next || !set->records || !set->origin) return PARADT_ERROR_MEMORY;
    // A record takes at least two doubles, as much as a key with its item. In the middle, so that each of two tasks
    // that fill the records has as many new pages to touch.
    loader->scratch = (paradt__keyed *)(void *)(set->records + (set->capacity * set->width - 2 * count) / 2);
    return PARADT_OK;
}

static void paradt__loader_free(paradt__loader *loader, paradt__memory *memory) {
    paradt__release(memory, loader->keyed);
    paradt__release(memory, loader->next);
    loader->keyed = NULL;
    loader->next = NULL;
}

// Divides `count` elements between the tasks of a team: those of `task` are [*begin, the result).
static size_t paradt__loader_range(const paradt__team *team, size_t count, size_t task, size_t *begin) {
    *begin = count / team->tasks * task;
    return task + 1 == team->tasks ? count : count / team->tasks * (task + 1);
}

// Looks in on the caller after `done` of a task's `count` elements, in the pass that takes the progress from `begin` to
// `end`. Returns 1 when the call is to end.
static int paradt__loader_cancels(const paradt__loader *loader, size_t task, int begin, int end, size_t done,
                                  size_t count) {
    double part = (double)done / (double)count;
    return paradt__team_cancels(loader->team, task, (begin + (end - begin) * part) / (double)PARADT__LOADED);
}

// Reads the points [index, end) for a task.
PARADT__INLINE void paradt__survey_points(paradt__loader *loader, size_t task, size_t index, size_t end, int dim) {
    paradt__source source = *loader->source; // copies, that no store through a pointer can change
    paradt__space space = loader->space[task];
    double record[PARADT_MAX_DIM + 1];
    source.points.dim = space.ambient = dim;
    for (; index < end; index++) {
        paradt__read_record(&source, index, record);
        paradt__fetch_point(&source.points, index + PARADT__POINTS_AHEAD);
        paradt__space_add(&space, record);
        loader->representative[index] = (paradt_index)index;
    }
    loader->space[task] = space;
}

// Returns the index of the first point from `index` on that is not finite. There is one.
static size_t paradt__first_bad(const paradt__source *source, size_t index) {
    double record[PARADT_MAX_DIM + 1];
    while (paradt__read_record(source, index, record) < 2047) index++;
    return index;
}

// All points are divided into loader->sampled intervals. Samples a point of each of the intervals [i, end), at random:
// a regular choice might meet a pattern of the points.
static void paradt__sample(paradt__loader *loader, size_t i, size_t end) {
    const paradt_points *points = &loader->source->points;
    double step = i < end ? (double)points->count / (double)loader->sampled : 0.0;
    for (; i < end; i++) {
        size_t from = (size_t)(step * (double)i), to = (size_t)(step * (double)(i + 1));
        size_t index = from + (to > from ? (size_t)(paradt__mix(i) % (to - from)) : 0);
        paradt__coordinates(points, index, loader->sample + i * (size_t)points->dim);
    }
}

// Number of the sample's intervals that end at or before a point. Computed in integers, so that a task's intervals
// begin where the previous task's end.
static size_t paradt__intervals_until(const paradt__loader *loader, size_t index) {
    return (size_t)((uint64_t)index * loader->sampled / loader->source->points.count);
}

// Makes the pages of a task's part of the arrays that are filled from now on. Returns 1 when the call is to end.
static int paradt__loader_pages(const paradt__loader *loader, size_t task) {
    enum { TOGETHER = 1 << 17 }; // points
    size_t record = loader->set->width * sizeof(double), i, next;
    size_t end = paradt__loader_range(loader->team, loader->source->points.count, task, &i);
    for (; i < end; i = next) {
        if (paradt__loader_cancels(loader, task, PARADT__SURVEY, PARADT__KEYS, 0, 1)) return 1;
        next = end - i < 2 * TOGETHER ? end : i + TOGETHER;
        paradt__make_pages(loader->keyed, i * sizeof *loader->keyed, next * sizeof *loader->keyed);
        paradt__make_pages(loader->set->records, i * record, next * record);
        paradt__make_pages(loader->set->origin, i * sizeof(paradt_index), next * sizeof(paradt_index));
        paradt__make_pages(loader->representative, i * sizeof(paradt_index), next * sizeof(paradt_index));
    }
    return 0;
}

// Reads the points of a task. Points are sampled while they are in the cache.
static void paradt__survey_task(void *context, size_t task) {
    enum { TOGETHER = 1 << 12 };
    paradt__loader *loader = (paradt__loader *)context;
    int dim = loader->source->points.dim;
    size_t i, next, end = paradt__loader_range(loader->team, loader->source->points.count, task, &i), first = i;
    loader->space[task] = loader->set->space;
    loader->bad[task] = SIZE_MAX;
    if (paradt__loader_pages(loader, task)) return;
    for (; i < end && loader->bad[task] == SIZE_MAX; i = next) {
        if (paradt__loader_cancels(loader, task, PARADT__SURVEY, PARADT__KEYS, i - first, end - first)) return;
        next = end - i < TOGETHER ? end : i + TOGETHER;
        if (PARADT_MAX_DIM > 2 && dim == 3) paradt__survey_points(loader, task, i, next, 3);
        else paradt__survey_points(loader, task, i, next, dim);
        if (!paradt__space_is_finite(&loader->space[task])) loader->bad[task] = paradt__first_bad(loader->source, i);
        paradt__sample(loader, paradt__intervals_until(loader, i), paradt__intervals_until(loader, next));
    }
}

// Reads all points. On return the set is measured; or *bad is the index of the first point that is not finite.
static paradt_status paradt__loader_survey(paradt__loader *loader, size_t *bad) {
    paradt__set *set = loader->set;
    size_t task;
    paradt__team_run(loader->team, paradt__survey_task, loader);
    if (paradt__team_cancelled(loader->team)) return PARADT_ERROR_CANCELLED;
    for (task = 0; task < loader->team->tasks; task++) {
        if (loader->bad[task] == SIZE_MAX) continue;
        *bad = loader->bad[task];
        return PARADT_ERROR_NOT_FINITE;
    }
    for (task = 0; task < loader->team->tasks; task++) paradt__space_join(&set->space, &loader->space[task]);
    set->exponent = paradt__max(set->space.coordinates.top + 1022, 0);
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>sorting
//
// Sorts the points along the curve, box after box where space is divided, and makes their records. Each point gets a
// key, above which stands the number of its box; keys are scattered by their first digits and then sorted digit by
// digit, each digit by one task. Points with the same key are sorted anew along the curve through their own bounding
// box, until they differ or are known to be equal. So equal points come one after another, in the order of their
// indices, and are merged.
// Doors: paradt__set_gather.

// --- points with equal keys

PARADT__INLINE uint64_t paradt__loader_key(const paradt__loader *loader, const paradt__lattice *lattice, size_t index) {
    double x[PARADT_MAX_DIM];
    paradt__coordinates(&loader->source->points, index, x);
    return paradt__hilbert_key(&loader->hilbert, lattice, x);
}

static int paradt__sort_cancels(const paradt__loader *loader, size_t task) {
    return paradt__loader_cancels(loader, task, PARADT__SORT, PARADT__SORT, 0, 1);
}

// Sorts points with the same key by a lattice over their own box. Returns 0 if they are equal: the first one's key
// becomes 0 then, and the others' 1; or if the call is to end. other: scratch for as many.
PARADT__COLD int paradt__split_run(const paradt__loader *loader, size_t task, paradt__keyed *run, paradt__keyed *other,
                                   size_t count, int by_steps) {
    paradt__lattice lattice;
    int64_t low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    int dim = loader->source->points.dim, levels = paradt__levels_for(count, dim), axis, equal = 1;
    size_t i;
    for (i = 0; i < count; i++) {
        double record[PARADT_MAX_DIM];
        if (i % PARADT__PACE == PARADT__PACE - 1 && paradt__sort_cancels(loader, task)) return 0;
        paradt__coordinates(&loader->source->points, (size_t)run[i].item, record);
        for (axis = 0; axis < dim; axis++) {
            int64_t x = paradt__ordered_bits(record[axis]);
            low[axis] = i && low[axis] < x ? low[axis] : x;
            high[axis] = i && high[axis] > x ? high[axis] : x;
            equal &= low[axis] == high[axis];
        }
    }
    if (equal) {
        for (i = 0; i < count; i++) run[i].key = i > 0;
        return 0;
    }
    paradt__lattice_begin(&lattice, dim, levels, by_steps, low, high);
    for (i = 0; i < count; i++) {
        if (i % PARADT__PACE == PARADT__PACE - 1 && paradt__sort_cancels(loader, task)) return 0;
        run[i].key = paradt__loader_key(loader, &lattice, (size_t)run[i].item);
    }
    paradt__keyed_sort(run, other, count, dim * levels, 0);
    return 1;
}

// Ends the sorting: points with equal keys are sorted again, until they differ or are known to be equal. On return a
// key is 1 if the point equals the one before, else 0. The longest run is left to the loop, so that the recursion is no
// deeper than the logarithm of count. If most points stay together pass after pass, the reason is a few distant points,
// with others behind them, on scale after scale. After many such passes the lattice goes by steps from one double to
// the next, which leaves at most 64 / levels passes.
static void paradt__refine(const paradt__loader *loader, size_t task, paradt__keyed *keyed, paradt__keyed *other,
                           size_t count) {
    enum { PASSES = 20 };
    size_t all = count, looked_at = 0;
    for (;;) {
        size_t begin, end, longest = 0, length = 1;
        if (count > PARADT__PACE && paradt__sort_cancels(loader, task)) return;
        for (begin = 0; begin < count; begin = end) {
            uint64_t key = keyed[begin].key;
            size_t run = begin, size;
            for (end = begin + 1; end < count && keyed[end].key == key;) end++;
            size = end - begin;
            if (size == 1) {
                keyed[begin].key = 0;
                continue;
            }
            if (size > length) { // the run that was the longest is dealt with instead
                size_t was = length;
                run = longest;
                longest = begin;
                length = size;
                size = was;
            }
            if (size > 1 && paradt__split_run(loader, task, keyed + run, other + run, size, 0))
                paradt__refine(loader, task, keyed + run, other + run, size);
        }
        looked_at += length;
        if (length == 1 ||
            !paradt__split_run(loader, task, keyed + longest, other + longest, length, looked_at / PASSES > all))
            return;
        keyed += longest;
        other += longest;
        count = length;
    }
}

// --- what a sample tells

// Sorts a few points of the sample, evenly chosen, along a curve of so many levels: in loader->keyed, which has memory
// for twice as many.
PARADT__HOT void paradt__sort_few(const paradt__loader *loader, size_t few, int levels) {
    const paradt__space *space = &loader->set->space;
    paradt__curve curve;
    size_t i;
    PARADT_ASSERT(2 * few <= loader->source->points.count);
    paradt__curve_begin(&curve, space->ambient, levels, space->low, space->high, few);
    for (i = 0; i < few; i++) loader->keyed[i].item = (paradt_index)((double)loader->sampled / (double)few * (double)i);
    paradt__curve_sort(&curve, loader->sample, (size_t)space->ambient, loader->keyed, loader->keyed + few, few);
}

// Estimates the spacing of the set (see paradt__spacing) by that of few points: one in 2^(k dim) points is 2^k times as
// far from its neighbours, where points are spread in all dimensions.
static double paradt__sample_spacing(const paradt__loader *loader) {
    enum { FEW = 1 << 12 };
    size_t count = loader->source->points.count, few = count, i;
    int dim = loader->source->points.dim;
    double nearer = 1.0;
    paradt_index *order;
    do {
        few >>= dim;
        nearer *= 0.5;
    } while (few > FEW);
    paradt__sort_few(loader, few, paradt__levels_for(few, dim));
    order = (paradt_index *)(void *)(loader->keyed + 2 * few);
    for (i = 0; i < few; i++) order[i] = loader->keyed[i].item;
    return nearer * paradt__spacing(loader->sample, (size_t)dim, dim, order, few);
}

// Returns how many points of the sample box 0 is to get more than other boxes. By insertion its region takes no points
// of others and asks about no cell, which saves the work for some 2.2 times the points in a margin beside a cut through
// all, as measured on uniform points.
static size_t paradt__sample_extra(const paradt__loader *loader, int axis) {
    enum { SOME = 1 << 11, WIDTH = 4 }; // of the slab that is looked at, in margins
    int64_t *keys = (int64_t *)(void *)loader->keyed;
    double margin = paradt__margin_for(paradt__sample_spacing(loader)), middle, extra, most;
    size_t dim = (size_t)loader->source->points.dim, count = loader->sampled, i, beside = 0;
    size_t some = count < SOME ? count : (size_t)SOME;
    const double *x = loader->sample + axis;
    for (i = 0; i < some; i++) {
        size_t position = (size_t)((double)count * (double)i / (double)some);
        keys[i] = paradt__ordered_bits(x[position * dim]);
    }
    middle = paradt__from_ordered_bits(paradt__select_key(keys, some, some / 2));
    for (i = 0; i < count && margin > 0.0; i++)
        beside += paradt__abs(x[i * dim] - middle) < margin * 0.5 * (double)WIDTH;
    extra = 2.2 * (double)beside / (double)WIDTH;
    most = (double)count / 4.0 / (double)loader->cuts->boxes;
    return (size_t)(extra < most ? extra : most);
}

// Finds the cuts by the sample, with loader->keyed as scratch.
static void paradt__loader_cut(paradt__loader *loader) {
    const paradt__set *set = loader->set;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    int dim = set->space.ambient, axis;
    size_t i;
    paradt__cutter cutter;
    for (axis = 0; axis < dim; axis++) {
        low[axis] = paradt__from_ordered_bits(set->space.low[axis]);
        high[axis] = paradt__from_ordered_bits(set->space.high[axis]);
    }
    cutter.cuts = loader->cuts;
    cutter.dim = dim;
    cutter.sample = loader->sample;
    cutter.count = loader->sampled;
    cutter.extra =
        loader->cuts->larger_first ? paradt__sample_extra(loader, paradt__longest_axis(low, high, dim, 0)) : 0;
    cutter.keys = (int64_t *)(void *)loader->keyed;
    cutter.order = (paradt_index *)(void *)(cutter.keys + cutter.count);
    for (i = 0; i < cutter.count; i++) cutter.order[i] = (paradt_index)i;
    paradt__cutter_divide(&cutter, 0, cutter.count, low, high, 0, loader->cuts->boxes);
}

// Would many points share places of a lattice with so many levels? If so, keys of more levels take less time than
// sorting these points anew. A few points of the sample tell, on a lattice with fewer levels: the number is such that,
// on a surface, the few share places as often as all points do on the finer lattice. In space the few share places more
// often than that, but still rarely.
static int paradt__loader_crowded(const paradt__loader *loader, int levels) {
    enum { MANY = 32 }; // one in so many is many
    size_t count = loader->source->points.count, few = PARADT__FEW_SAMPLED, shared = 0, i;
    if (few > count / 2) few = count / 2;
    if (!few || !loader->sampled) return 0;
    levels -= (paradt__bit_length(count / few) - 1) / 2;
    levels = paradt__whole_steps(paradt__max(levels, 1), loader->source->points.dim);
    paradt__sort_few(loader, few, levels);
    for (i = 1; i < few; i++) shared += loader->keyed[i].key == loader->keyed[i - 1].key;
    return shared > few / MANY;
}

// --- all points

PARADT__INLINE size_t *paradt__loader_next(const paradt__loader *loader, size_t task) {
    return loader->next + (task << loader->first_bits);
}

// Makes the keys of a task's points and counts their first digits.
PARADT__INLINE void paradt__make_keys(paradt__loader *loader, size_t task, int dim) {
    paradt_points points = loader->source->points; // copies, that no store through a pointer can change
    paradt__lattice lattice = loader->lattice;
    paradt__keyed *keyed = loader->keyed;
    size_t i, end = paradt__loader_range(loader->team, points.count, task, &i), first = i;
    size_t *count = paradt__loader_next(loader, task);
    int bits = dim * lattice.levels, shift = loader->shift;
    points.dim = lattice.dim = dim;
    memset(count, 0, loader->digits * sizeof *count);
    for (; i < end; i++) {
        double x[PARADT_MAX_DIM];
        uint64_t key;
        if (i % PARADT__PACE == 0 &&
            paradt__loader_cancels(loader, task, PARADT__KEYS, PARADT__SCATTER, i - first, end - first))
            return;
        paradt__coordinates(&points, i, x);
        paradt__fetch_point(&points, i + PARADT__POINTS_AHEAD);
        key = paradt__hilbert_key(&loader->hilbert, &lattice, x);
        if (loader->cuts) key |= (uint64_t)paradt__cuts_find(loader->cuts, x) << bits;
        keyed[i].key = key;
        keyed[i].item = (paradt_index)i;
        count[(size_t)(key >> shift)]++;
    }
}

static void paradt__key_task(void *context, size_t task) {
    paradt__loader *loader = (paradt__loader *)context;
    if (PARADT_MAX_DIM > 2 && loader->lattice.dim == 3) paradt__make_keys(loader, task, 3);
    else paradt__make_keys(loader, task, loader->lattice.dim);
}

// Makes places of the tasks' counts: those of a digit follow each other, task by task.
static void paradt__place_digits(const paradt__loader *loader) {
    size_t digit, task, before = 0;
    for (digit = 0; digit < loader->digits; digit++) {
        for (task = 0; task < loader->team->tasks; task++) {
            size_t *next = paradt__loader_next(loader, task) + digit, count = *next;
            *next = before;
            before += count;
        }
    }
    PARADT_ASSERT(before == loader->source->points.count);
}

// Scatters the keys of a task by their first digits, into the scratch buffer.
static void paradt__scatter_task(void *context, size_t task) {
    paradt__loader *loader = (paradt__loader *)context;
    const paradt__keyed *keyed = loader->keyed;
    paradt__keyed *scratch = loader->scratch;
    size_t i, end = paradt__loader_range(loader->team, loader->source->points.count, task, &i), first = i;
    size_t *next = paradt__loader_next(loader, task);
    int shift = loader->shift;
    for (; i < end; i++) {
        if (i % PARADT__PACE == 0 &&
            paradt__loader_cancels(loader, task, PARADT__SCATTER, PARADT__SORT, i - first, end - first))
            return;
        PARADT__FETCH(keyed, i + PARADT__POINTS_AHEAD);
        scratch[next[(size_t)(keyed[i].key >> shift)]++] = keyed[i];
    }
}

// Sorts the points with the first digits that end in the task's range.
static void paradt__sort_task(void *context, size_t task) {
    paradt__loader *loader = (paradt__loader *)context;
    const size_t *ends = paradt__loader_next(loader, loader->team->tasks - 1); // after scattering: of all tasks
    size_t first, last = paradt__loader_range(loader->team, loader->source->points.count, task, &first), begin = 0,
                  digit;
    for (digit = 0; digit < loader->digits; begin = ends[digit++]) {
        size_t count = ends[digit] - begin;
        if (!count || ends[digit] <= first || ends[digit] > last) continue;
        if (paradt__loader_cancels(loader, task, PARADT__SORT, PARADT__GATHER, ends[digit] - first, last - first))
            return;
        paradt__keyed_sort(loader->scratch + begin, loader->keyed + begin, count, loader->shift, 1);
        paradt__refine(loader, task, loader->keyed + begin, loader->scratch + begin, count);
    }
}

// Sorts the points along the curve, box after box, in loader->keyed; where a point equals the one before, its key is 1,
// else 0.
static paradt_status paradt__loader_sort(paradt__loader *loader) {
    size_t count = loader->source->points.count;
    int dim = loader->set->space.ambient, levels = paradt__levels_for(count, dim), step = PARADT__STEP_BITS / dim;
    int box_bits = loader->cuts ? paradt__bit_length(loader->cuts->boxes - 1) : 0;
    paradt__hilbert_begin(&loader->hilbert, dim, count);
    if (paradt__loader_crowded(loader, levels)) levels = paradt__levels_for(SIZE_MAX, dim);
    while (dim * levels + box_bits > 64) levels -= step > 1 ? step : 1;
    loader->shift = paradt__max(dim * levels + box_bits - loader->first_bits, 0);
    loader->digits = (size_t)1 << (dim * levels + box_bits - loader->shift);
    paradt__lattice_begin(&loader->lattice, dim, levels, 0, loader->set->space.low, loader->set->space.high);
    paradt__team_run(loader->team, paradt__key_task, loader);
    if (paradt__team_cancelled(loader->team)) return PARADT_ERROR_CANCELLED;
    paradt__place_digits(loader);
    paradt__team_run(loader->team, paradt__scatter_task, loader);
    if (paradt__team_cancelled(loader->team)) return PARADT_ERROR_CANCELLED;
    paradt__team_run(loader->team, paradt__sort_task, loader);
    return paradt__team_cancelled(loader->team) ? PARADT_ERROR_CANCELLED : PARADT_OK;
}

// --- records

// Reads the records of a task's positions, and counts those that repeat the one before.
static void paradt__gather_task(void *context, size_t task) {
    enum { AHEAD = PARADT__POINTS_AHEAD / 2 };
    paradt__loader *loader = (paradt__loader *)context;
    paradt__set *set = loader->set;
    size_t i, end = paradt__loader_range(loader->team, loader->source->points.count, task, &i), repeating = 0,
              first = i;
    for (; i < end; i++) {
        size_t soon = i + AHEAD < end ? i + AHEAD : i;
        if (i % PARADT__PACE == 0 &&
            paradt__loader_cancels(loader, task, PARADT__GATHER, PARADT__LOADED, i - first, end - first))
            return;
        PARADT__FETCH(loader->keyed, i + PARADT__POINTS_AHEAD);
        paradt__fetch_point(&loader->source->points, (size_t)loader->keyed[soon].item);
        paradt__read_record(loader->source, (size_t)loader->keyed[i].item, set->records + i * set->width);
        set->origin[i] = loader->keyed[i].item;
        repeating += (size_t)loader->keyed[i].key;
    }
    loader->repeating[task] = repeating;
}

// Keeps one record of equal points. representative[index] becomes the index of the point that stands for the point:
// the smallest, with weights that of the largest weight. Equal points are neighbours, in the order of their indices.
static void paradt__loader_merge(paradt__loader *loader) {
    paradt__set *set = loader->set;
    size_t kept = 0, i, width = set->width, ambient = (size_t)set->space.ambient;
    for (i = 0; i < set->count; i++) {
        const double *record = set->records + i * width;
        if (!loader->keyed[i].key) {
            if (kept < i) memcpy(set->records + kept * width, record, width * sizeof *record);
            set->origin[kept++] = loader->keyed[i].item;
        } else if (set->space.weighted) {
            double *weight = set->records + (kept - 1) * width + ambient;
            if (paradt__ordered_bits(record[ambient]) > paradt__ordered_bits(*weight)) {
                *weight = record[ambient];
                set->origin[kept - 1] = loader->keyed[i].item;
            }
        }
        loader->representative[loader->keyed[i].item] = (paradt_index)(kept - 1);
    }
    for (i = 0; i < set->count; i++) loader->representative[i] = set->origin[loader->representative[i]];
    set->count = kept;
}

// Makes the records of the sorted points, one a place, and notes where the boxes begin.
static paradt_status paradt__loader_gather(paradt__loader *loader) {
    size_t repeating = 0, task;
    loader->set->count = loader->source->points.count;
    paradt__team_run(loader->team, paradt__gather_task, loader);
    if (paradt__team_cancelled(loader->team)) return PARADT_ERROR_CANCELLED;
    for (task = 0; task < loader->team->tasks; task++) repeating += loader->repeating[task];
    if (repeating) paradt__loader_merge(loader);
    if (loader->cuts) paradt__cuts_mark(loader->cuts, loader->set);
    return PARADT_OK;
}

// Makes the set of the source's points: each place once, along a curve, measured, but neither scaled nor with its axes
// permuted. set: zeroed. cuts: NULL, or how space is to be divided: the cuts are found then, and the points are in the
// order of the boxes. representative: [points.count] see paradt__loader_merge. *bad: see paradt__loader_survey. After
// an error the caller frees the set and the cuts.
PARADT__NOINLINE paradt_status paradt__set_gather(paradt__set *set, const paradt__source *source, paradt__cuts *cuts,
                                                  const paradt__team *team, paradt__memory *memory,
                                                  paradt_index *representative, size_t *bad) {
    paradt__loader loader;
    paradt_status status;
    PARADT_ASSERT(!set->records && !set->origin && source->points.dim >= 2);
    paradt__loader_begin(&loader, set, source, cuts, team, representative);
    status = paradt__loader_allocate(&loader, memory);
    if (!status) status = paradt__loader_survey(&loader, bad);
    if (!status) {
        if (loader.cuts) paradt__loader_cut(&loader);
        status = paradt__loader_sort(&loader);
    }
    if (!status) status = paradt__loader_gather(&loader);
    paradt__loader_free(&loader, memory);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>scale and axes
//
// The last steps that make a set: its coordinates are scaled by a power of two where that loses no bit, and permuted so
// that the first `dim` of them orient. The axes are taken greedily, from the first to the last. So the lexicographic
// order over the axes taken is the order over all coordinates: a coordinate passed over is an affine function of the
// coordinates taken before it.
// Doors: paradt__set_load; paradt__set_scale, paradt__set_permute, paradt__set_measure, paradt__set_measured for sets
// that are parts of one.

// Brings the largest coordinate near 1, if no bit of any coordinate or weight is lost by that: T(P) does not change,
// and sets far from 1 get the floating-point filter. Weights are squares of lengths. Returns whether it has.
static int paradt__set_scale(paradt__set *set) {
    size_t i, pass;
    int axis, ambient = set->space.ambient, shift = 1023 - set->exponent, exact = 1;
    if (shift >= -32 && shift <= 32) return 0;
    for (pass = 0; pass < 2 && exact; pass++) {
        for (i = 0; i < set->count && exact; i++) {
            double *record = set->records + i * set->width;
            for (axis = 0; axis < (int)set->width; axis++) {
                double scaled = paradt__scale(record[axis], axis < ambient ? shift : 2 * shift, &exact);
                if (pass) record[axis] = scaled;
            }
        }
    }
    return exact;
}

// Permutes the coordinates of all records: set->axes[j], of the axes that they are along, comes to place j. Returns 0
// if that changes nothing.
static int paradt__set_permute(paradt__set *set) {
    size_t i;
    int axis, ambient = set->space.ambient, identity = 1;
    for (axis = 0; axis < ambient; axis++) identity &= set->axes[axis] == axis;
    if (identity) return 0;
    for (i = 0; i < set->count; i++) {
        double *record = set->records + i * set->width, copy[PARADT_MAX_DIM];
        for (axis = 0; axis < ambient; axis++) copy[axis] = record[set->axes[axis]];
        memcpy(record, copy, (size_t)ambient * sizeof(double));
    }
    return 1;
}

typedef struct paradt__measuring {
    const paradt__set *set;
    const paradt__team *team;
    paradt__space space[PARADT__MOST_TASKS];
} paradt__measuring;

static void paradt__measure_task(void *context, size_t task) {
    paradt__measuring *measuring = (paradt__measuring *)context;
    const paradt__set *set = measuring->set;
    size_t i, end = paradt__loader_range(measuring->team, set->count, task, &i);
    measuring->space[task] = set->space;
    for (; i < end; i++) paradt__space_add(&measuring->space[task], set->records + i * set->width);
}

// Measures the set: tells the predicates what they may rely on.
static void paradt__set_measure(paradt__set *set, const paradt__team *team, int dim) {
    paradt__space *space = &set->space;
    paradt__measuring measuring;
    size_t task;
    measuring.set = set;
    measuring.team = team;
    paradt__space_begin(space, dim, space->ambient, space->weighted);
    paradt__team_run(team, paradt__measure_task, &measuring);
    for (task = 0; task < team->tasks; task++) paradt__space_join(space, &measuring.space[task]);
    if (dim > 0) paradt__space_end(space);
}

// The same where what was measured while the points were read still holds.
static void paradt__set_measured(paradt__set *set, int dim) {
    set->space.dim = dim;
    memset(&set->space.counters, 0, sizeof set->space.counters);
    if (dim > 0) paradt__space_end(&set->space);
}

// Makes the set of the caller's points. Returns with it, for each index in representative, [points->count], the index
// of the point that stands for the point. cuts: see paradt__set_gather; *bad: index of the first point that is not
// finite. After an error the caller frees the set and the cuts.
static paradt_status paradt__set_load(paradt__set *set, const paradt_points *points, paradt__cuts *cuts,
                                      const paradt__team *team, paradt__memory *memory, paradt_index *representative,
                                      size_t *bad) {
    paradt__source source = paradt__source_of(points);
    paradt_index basis[PARADT_MAX_DIM + 1];
    paradt_status status;
    int dim, scaled, permuted;
    memset(set, 0, sizeof *set);
    source.reserve = paradt__cuts_reserve(cuts, points->count);
    status = paradt__set_gather(set, &source, cuts, team, memory, representative, bad);
    if (status) return status;
    scaled = paradt__set_scale(set);
    if (paradt__team_cancels(team, 0, 1.0)) return PARADT_ERROR_CANCELLED;
    dim = paradt__set_basis(set, NULL, 0, basis, set->axes, &set->space.counters, team->progress.meter) - 1;
    if (paradt__team_cancels(team, 0, 1.0)) return PARADT_ERROR_CANCELLED;
    permuted = paradt__set_permute(set);
    if (cuts) paradt__cuts_follow(cuts, set, scaled);
    if (scaled || permuted) paradt__set_measure(set, team, dim);
    else paradt__set_measured(set, dim);
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>reference sphere
//
// Points on one sphere, up to rounding or noise, are the worst case of a search: every sphere through four of them is
// almost that sphere, all points are almost on it, and no box can be ruled out by its distance. T(P) does not change
// when an affine function is added to the lift. So for such a set the lift is measured from a sphere that the points
// are near to, the reference sphere: instead of |x|^2 each record carries its sagitta r^2 - |x - o|^2, which is
// computed once, in integers, with an error far below the noise that decides. Then lifts are as small as the noise, so
// are the spheres' coefficients, and the largest sagitta of a box tells whether the box matters. The floating-point
// search and the insertion's spheres in three dimensions use sagittas; the predicates go on working with the
// coordinates. Doors: paradt__set_grade, paradt__centre_shift; paradt__fit_sphere, paradt__set_sagittas,
// paradt__set_grade_bounds for sets that are parts of one.

// Returns how far the centre of the smallest sphere through o and `count` - 1 more points moves when x is included too.
// rows: an orthonormal basis of the span of these points; centre: relative to o. The centre moves along *row, the unit
// vector across the span towards x, which is at height *height above the span.
static double paradt__centre_shift(const double *o, const double *x, double rows[][PARADT_MAX_DIM], int count,
                                   int ambient, const double *centre, double *row, double *height) {
    double lift = 0.0, length = 0.0;
    int i, j;
    for (j = 0; j < ambient; j++) {
        row[j] = x[j] - o[j];
        lift += row[j] * (row[j] - 2.0 * centre[j]);
    }
    for (i = 0; i + 1 < count; i++) {
        double dot = 0.0;
        for (j = 0; j < ambient; j++) dot += rows[i][j] * row[j];
        for (j = 0; j < ambient; j++) row[j] -= dot * rows[i][j];
    }
    for (j = 0; j < ambient; j++) length += row[j] * row[j];
    *height = length = sqrt(length);
    if (!(length > 0.0)) return 0.0;
    for (j = 0; j < ambient; j++) row[j] /= length;
    return lift / (2.0 * length);
}

#define PARADT__NEAR_SPHERE 0.0009765625 // of r^2: |r^2 - |x - o|^2| for x near to it

// Finds the sphere through points of a sample that are far from each other, one more than axes. Returns 0 if there is
// none, or the sample is not so near to it (see PARADT__NEAR_SPHERE). The set has at least 64 points.
static int paradt__fit_sphere(const paradt__set *set, double nearness, double *centre, double *radius2) {
    double rows[PARADT_MAX_DIM][PARADT_MAX_DIM], row[PARADT_MAX_DIM], shift[PARADT_MAX_DIM] = {0.0}, height;
    size_t step = set->count / 64, i;
    const double *o = set->records;
    int ambient = set->space.ambient, count, j;
    PARADT_ASSERT(set->count >= 64);
    for (count = 1; count <= ambient; count++) {
        double highest = 0.0, best = 0.0;
        for (i = 0; i < 64; i++) {
            double t = paradt__centre_shift(o, o + i * step * set->width, rows, count, ambient, shift, row, &height);
            if (height <= highest) continue;
            highest = height;
            best = t;
            memcpy(rows[count - 1], row, sizeof row);
        }
        if (!(highest > 0.0)) return 0;
        for (j = 0; j < ambient; j++) shift[j] += best * rows[count - 1][j];
    }
    *radius2 = 0.0;
    for (j = 0; j < ambient; j++) {
        centre[j] = paradt__rounded(o[j] + shift[j]);
        *radius2 += shift[j] * shift[j];
    }
    for (i = 0; i < 64; i++) {
        double excess = -*radius2;
        for (j = 0; j < ambient; j++) {
            double u = o[i * step * set->width + (size_t)j] - centre[j];
            excess += u * u;
        }
        if (!(paradt__abs(excess) < *radius2 * nearness)) return 0;
    }
    return 1;
}

enum { PARADT__SAGITTA_DIGITS = 4 };

// Writes x / 2^(top - 108), cut off to an integer, in four digits of 27 bits, the first one the highest; |x| < 2^top.
static void paradt__digits_of(double x, int top, int64_t *digits) {
    int exponent, shift, i;
    uint64_t mantissa = paradt__split(x, &exponent);
    shift = exponent - top + 27;
    for (i = 0; i < PARADT__SAGITTA_DIGITS; i++, shift += 27) { // the digit's lowest bit is that of 2^-shift
        uint64_t part = shift >= 0 ? mantissa << (shift < 27 ? shift : 27) : shift > -64 ? mantissa >> -shift : 0;
        digits[i] = (int64_t)(part & 0x7ffffff);
        if (x < 0.0) digits[i] = -digits[i];
    }
}

// Returns r^2 - |x - o|^2, where r^2 = squared * 2^(2 top - 54) and o is in digits. Every coordinate is cut off below
// 2^(top - 108), which is an error of at most d 2^(2 top - 104); the sum is exact up to its last rounding to a double,
// of at most 2^-48 of itself.
static double paradt__sagitta(const double *x, const int64_t (*o)[PARADT__SAGITTA_DIGITS], int64_t squared, int top,
                              int ambient) {
    enum { LAST = 2 * PARADT__SAGITTA_DIGITS - 2 };
    int64_t level[LAST + 1] = {0}, d[PARADT__SAGITTA_DIGITS], carry;
    double sum = 0.0;
    int i, j, k;
    for (j = 0; j < ambient; j++) { // each adds less than 2^57 to a level
        paradt__digits_of(x[j], top, d);
        for (i = 0; i < PARADT__SAGITTA_DIGITS; i++) d[i] -= o[j][i];
        for (i = 0; i < PARADT__SAGITTA_DIGITS; i++) {
            for (k = 0; k < PARADT__SAGITTA_DIGITS; k++) level[i + k] += d[i] * d[k];
        }
    }
    level[0] -= squared;
    for (i = LAST; i > 0; i--) { // leaves digits of at most 2^26 in size below the first
        carry = (level[i] + (1 << 26)) / (1 << 27) - (level[i] + (1 << 26) < 0);
        level[i] -= carry * (1 << 27);
        level[i - 1] += carry;
    }
    for (i = LAST; i >= 0; i--) sum += (double)level[i] * paradt__power(2 * top - 54 - 27 * i);
    return -sum;
}

// Returns the exponent of a power of two that is at least twice the radius and, as sagittas need, over four times the
// centre's coordinates. The latter fails where the set is a small part of a sphere far away, which tells no more than a
// plane.
static int paradt__sphere_top(const paradt__set *set, double radius2) {
    const paradt__space *space = &set->space;
    double reach = 4.0 * radius2, distant = 0.0, extent2 = 0.0;
    int top = 0, j;
    for (j = 0; j < space->ambient; j++) {
        double side = paradt__from_ordered_bits(space->high[j]) - paradt__from_ordered_bits(space->low[j]);
        distant = paradt__larger(distant, 16.0000001 * set->centre[j] * set->centre[j]);
        extent2 += side * side;
    }
    if (distant > reach && radius2 < extent2) reach = distant;
    while (top < 100 && paradt__power(2 * top) < reach) top++;
    while (top > -100 && paradt__power(2 * top - 2) > reach) top--;
    return top;
}

// Gives the records their sagittas by the sphere around set->centre, in a new record array for `capacity` points. On
// return set->grade_limit is the largest sagitta, and set->grade_error the error by cutting off:
// paradt__set_grade_bounds makes bounds of them. *nearby: whether all points are so near to the sphere; if not, or
// after an error, the set is as it was. meter: NULL, or asked now and then.
static paradt_status paradt__set_sagittas(paradt__set *set, double radius2, double nearness, size_t capacity,
                                          paradt__meter *meter, paradt__memory *memory, int *nearby) {
    int ambient = set->space.ambient, top = paradt__sphere_top(set, radius2), j;
    int64_t o[PARADT_MAX_DIM][PARADT__SAGITTA_DIGITS], squared;
    double largest = 0.0, *records;
    size_t i, width = set->width;
    PARADT_ASSERT(capacity >= set->count && set->grade == PARADT__UNGRADED);
    *nearby = radius2 < paradt__power(2 * top);
    for (j = 0; j < ambient; j++) {
        paradt__digits_of(set->centre[j], top, o[j]);
        *nearby &= paradt__abs(set->centre[j]) < 0.25 * paradt__power(top);
    }
    if (!*nearby) return PARADT_OK;
    squared = (int64_t)(radius2 * paradt__power(54 - 2 * top));
    records = (double *)paradt__alloc(memory, capacity, (width + 1) * sizeof(double));
    if (!records) return PARADT_ERROR_MEMORY;
    for (i = 0; i < set->count && *nearby; i++) {
        double *to = records + i * (width + 1);
        if (meter && i % PARADT__PACE == PARADT__PACE - 1 && paradt__meter_cancels(meter)) {
            paradt__release(memory, records);
            return PARADT_ERROR_CANCELLED;
        }
        memcpy(to, set->records + i * width, width * sizeof(double));
        *nearby = paradt__largest(to, ambient) < paradt__power(top);
        if (!*nearby) break;
        to[ambient] = paradt__sagitta(to, (const int64_t(*)[PARADT__SAGITTA_DIGITS])o, squared, top, ambient);
        largest = paradt__larger(largest, paradt__abs(to[ambient]));
        *nearby = largest < radius2 * nearness;
    }
    paradt__release(memory, *nearby ? set->records : records);
    if (!*nearby) return PARADT_OK;
    set->records = records;
    set->width++;
    set->grade = PARADT__SAGITTA;
    set->grade_limit = largest;
    set->grade_error = ambient * paradt__power(2 * top - 104);
    return PARADT_OK;
}

// Sets the bounds of the set's sagittas, of which `largest` is the largest.
static void paradt__set_grade_bounds(paradt__set *set, double largest) {
    set->grade_limit = largest * 1.0000001;
    set->grade_error += largest * paradt__power(-48);
}

// Gives the records their sagittas, if the set is near to a sphere and spans all its axes; else leaves it as it is.
// nearness: of r^2, the largest size of a sagitta, such as PARADT__NEAR_SPHERE. meter: NULL, or asked now and then.
PARADT__HOT paradt_status paradt__set_grade(paradt__set *set, double nearness, paradt__meter *meter,
                                            paradt__memory *memory) {
    double radius2;
    int nearby;
    paradt_status status;
    if (set->count < 64 || set->grade || set->space.dim < set->space.ambient || !set->space.filtered) return PARADT_OK;
    if (!paradt__fit_sphere(set, nearness, set->centre, &radius2)) return PARADT_OK;
    status = paradt__set_sagittas(set, radius2, nearness, set->capacity, meter, memory, &nearby);
    if (!status && nearby) paradt__set_grade_bounds(set, set->grade_limit);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>mesh
//
// The triangulation, whoever builds it: its cells, how they hang together, which places are free. All methods build
// one, the result is delivered from one, and every construction on a triangulation starts from one.
//
// A cell has a place, a row of `corners` vertices and a row of as many links. `corners` is the mesh's own number. The
// facet opposite vertex i of the cell at a place is named by its handle, corners * place + i. So a handle is a
// half-facet: a facet as one of its two cells sees it. Its link is the mirror, the handle of the same facet as the
// other cell sees it. Two cells with the facet b c d in common, corners = 4:
//
//     place       0            1
//     vertices    a  b  c  d   d  c  e  b
//     handles     0  1  2  3   4  5  6  7
//     links       6  .  .  .   .  .  0  .        links[0] = 6, links[6] = 0: the facet b c d, twice
//
// A link is PARADT__HULL where the hull has no cell on the other side, and PARADT__OPEN where that cell is not known.
// A mesh may be closed: then ghosts stand on the hull's facets, cells with the vertex PARADT__INFINITE in the place of
// a point beyond the facet, and no link is negative. So inside and outside are one case.
//
// What holds between two changes, and what paradt__mesh_verify checks in debug builds:
//     - links[links[handle]] is the handle;
//     - the two handles of a facet name the same vertices, and the cells see it with opposite orientation;
//     - a ghost has one infinite vertex;
//     - a place that is free has PARADT__DEAD for its first vertex, and is named once in `spare`, unless the mesh is
//       about to be compacted: then dead places are in no list.
// Marks are bits of a cell; each has one owner, who clears it.
//
// The mesh knows no coordinates. Its functions say nothing of geometry; see >>scene for what does.
// Doors: paradt__mesh_*, paradt__most_cells, paradt__vertices_below, paradt__vertices_among, paradt__is_finite_cell,
// paradt__ghost_place, paradt__same_facet, paradt__facet_without, paradt__star_of, paradt__list_room,
// paradt__list_append, paradt__list_free, paradt__expected_places, paradt__cells_a_point, paradt__off_hull,
// paradt__fetch_row, PARADT__VERIFY, PARADT__VERIFY_SMALL.

#define PARADT__NOWHERE ((paradt_index)(sizeof(paradt_index) == 4 ? INT32_MAX : INT64_MAX)) // no position and no place

// Links that are no handles
enum {
    PARADT__HULL = -1, // no cell on the other side
    PARADT__OPEN = -2  // the cell on the other side is not known
};

// Vertices that are no positions
enum {
    PARADT__INFINITE = -1, // that of ghosts
    PARADT__DEAD = -3      // the first vertex at a free place
};

// Marks of a cell
enum {
    PARADT__CONFLICT = 1, // in conflict with the point that is being inserted
    PARADT__WAITING = 2,  // in the list of cells to be asked about
    PARADT__ASKED = 4,    // known to be one of T(P)
    PARADT__LISTED = 8,   // in the list of the fringe; not kept by all regions
    PARADT__DROPPED = 16, // not kept in the end; used by ranks
    PARADT__WRONG = 32    // in the list of cells that are not of T(P)
};

#ifdef PARADT_INDEX64
typedef uint64_t paradt__tag;
#else
typedef uint32_t paradt__tag; // an index without its sign: comparing two in one step, dividing by shifts
#endif

// Whether four indices fit into a register that every processor of the kind has
#if defined(__SSE2__) && !defined(PARADT_NO_SIMD) && !defined(PARADT_INDEX64)
#define PARADT__FOUR_AT_ONCE 1
#else
#define PARADT__FOUR_AT_ONCE 0
#endif

typedef struct paradt__mesh {
    int corners;            // vertices a cell
    size_t count, capacity; // places in use or free; places that there is memory for
    paradt_index *vertices; // [capacity][corners]
    paradt_index *links;    // [capacity][corners] handles of the mirrors
    int lent;             // vertices and links are parts of others' arrays: left behind when the mesh grows, not freed
    int marked;           // there are marks
    unsigned char *marks; // [capacity] bits; 0 at first
    size_t paged;         // places whose rows have their pages already
    paradt_index *spare;  // [spare_capacity] free places
    size_t spare_count, spare_capacity;
} paradt__mesh;

// --- how many cells to expect

// Cells a point of T(P) for uniform points, far from the hull (d = 2, 3: exact; d >= 4: Dwyer 1991, the constants of
// the Poisson-Delaunay mosaic); near the hull there are fewer.
static double paradt__cells_a_point(int dim) {
    static const double mean[] = {1.0, 1.0, 2.0, 6.7677, 31.78, 186.1, 1297.0, 10470.0, 96000.0};
    return mean[dim];
}

// The part of them that is left for so many points in all. The exponents for d >= 5 are fitted to uniform points: 0.78
// of the cells for 4,000 points in five dimensions, 0.46 for 1,000 in six, 0.16 for 300 in seven, 0.04 for 150 in
// eight.
PARADT__OPTIONAL double paradt__off_hull(double points, int dim) {
    double layer = pow(points + 1.0, -1.0 / dim);
    return dim < 5 ? 1.0 - 0.5 * layer : pow(1.0 - layer, dim - 3.8);
}

// Number of places that the cells and ghosts of so many points take in two and three dimensions: enough for most sets
static size_t paradt__expected_places(size_t count, int dim) {
    return (size_t)((double)count * paradt__cells_a_point(dim) * 1.02) + 64;
}

// --- memory

// Replaces a list, of which `used` elements are in use, by one of `count` elements at least.
PARADT__NOINLINE paradt_status paradt__list_grow(paradt_index **list, size_t used, size_t *capacity, size_t count,
                                                 paradt__memory *memory) {
    void *array = *list;
    size_t larger = *capacity * 2 > count ? *capacity * 2 : count;
    if (!paradt__grow(memory, &array, used, larger, sizeof **list)) return PARADT_ERROR_MEMORY;
    *list = (paradt_index *)array;
    *capacity = larger;
    return PARADT_OK;
}

// Makes room for `count` elements in a list of which `used` are in use.
PARADT__INLINE paradt_status paradt__list_room(paradt_index **list, size_t used, size_t *capacity, size_t count,
                                               paradt__memory *memory) {
    return PARADT__LIKELY(count <= *capacity) ? PARADT_OK : paradt__list_grow(list, used, capacity, count, memory);
}

typedef struct paradt__list {
    paradt_index *items; // [capacity]
    size_t count, capacity;
} paradt__list;

// Appends an item.
PARADT__INLINE paradt_status paradt__list_append(paradt__list *list, paradt_index item, paradt__memory *memory) {
    paradt_status status = paradt__list_room(&list->items, list->count, &list->capacity, list->count + 1, memory);
    if (!status) list->items[list->count++] = item;
    return status;
}

PARADT__OPTIONAL void paradt__list_free(paradt__list *list, paradt__memory *memory) {
    paradt__release(memory, list->items);
    memset(list, 0, sizeof *list);
}

static void paradt__mesh_begin(paradt__mesh *mesh, int corners, int marked) {
    memset(mesh, 0, sizeof *mesh);
    mesh->corners = corners;
    mesh->marked = marked;
}

// Frees the marks, which are not needed any more.
PARADT__OPTIONAL void paradt__mesh_free_marks(paradt__mesh *mesh, paradt__memory *memory) {
    paradt__release(memory, mesh->marks);
    mesh->marks = NULL;
    mesh->marked = 0;
}

// Frees what only changes need: marks and the list of free places.
static void paradt__mesh_rest(paradt__mesh *mesh, paradt__memory *memory) {
    paradt__mesh_free_marks(mesh, memory);
    paradt__release(memory, mesh->spare);
    mesh->spare = NULL;
    mesh->spare_count = mesh->spare_capacity = 0;
}

static void paradt__mesh_free(paradt__mesh *mesh, paradt__memory *memory) {
    paradt__mesh_rest(mesh, memory);
    if (!mesh->lent) {
        paradt__release(memory, mesh->vertices);
        paradt__release(memory, mesh->links);
    }
    memset(mesh, 0, sizeof *mesh);
}

// The most cells whose facets can be numbered
static size_t paradt__most_cells(int corners) {
    return (size_t)(((paradt_index)-1 < 0 && sizeof(paradt_index) == 4) ? INT32_MAX : INT64_MAX) / (size_t)corners;
}

// Allocates a larger array for one of the two arrays of rows and copies it; frees the old one unless it is lent.
static paradt_status paradt__mesh_grow_rows(const paradt__mesh *mesh, paradt_index **rows, size_t capacity,
                                            paradt__memory *memory) {
    size_t corners = (size_t)mesh->corners, used = mesh->count * corners;
    void *array = mesh->lent ? NULL : *rows;
    if (!paradt__grow(memory, &array, mesh->lent ? 0 : used, capacity * corners, sizeof(paradt_index)))
        return PARADT_ERROR_MEMORY;
    if (mesh->lent && used) memcpy(array, *rows, used * sizeof(paradt_index));
    *rows = (paradt_index *)array;
    return PARADT_OK;
}

// Makes room for `needed` places, and for as many as are wanted if these can be numbered.
static paradt_status paradt__mesh_reserve(paradt__mesh *mesh, size_t needed, size_t wanted, paradt__memory *memory) {
    size_t before = mesh->capacity, most = paradt__most_cells(mesh->corners);
    size_t capacity = wanted < needed ? needed : wanted < most ? wanted : most;
    paradt_index *vertices = mesh->vertices, *links = mesh->links;
    void *marks = mesh->marks;
    paradt_status status;
    if (needed > most) return PARADT_ERROR_TOO_LARGE;
    status = paradt__mesh_grow_rows(mesh, &vertices, capacity, memory);
    if (status) return status;
    if (!mesh->lent) mesh->vertices = vertices;
    status = paradt__mesh_grow_rows(mesh, &links, capacity, memory);
    if (status) {
        if (mesh->lent) paradt__release(memory, vertices);
        return status;
    }
    mesh->vertices = vertices;
    mesh->links = links;
    mesh->lent = 0;
    mesh->capacity = capacity;
    mesh->paged = mesh->count;
    if (!mesh->marked) return PARADT_OK;
    if (!paradt__grow(memory, &marks, before, capacity, 1)) {
        mesh->capacity = before; // of the marks: nothing reads rows behind that
        return PARADT_ERROR_MEMORY;
    }
    mesh->marks = (unsigned char *)marks;
    paradt__make_pages(mesh->marks, before, capacity);
    memset(mesh->marks + before, 0, capacity - before);
    return PARADT_OK;
}

// Makes room for one more cell. Growing by a quarter keeps the peak at 2.25 times the result where the first guess was
// short.
PARADT__INLINE paradt_status paradt__mesh_room(paradt__mesh *mesh, paradt__memory *memory) {
    if (PARADT__LIKELY(mesh->count < mesh->capacity)) return PARADT_OK;
    return paradt__mesh_reserve(mesh, mesh->count + 1, mesh->capacity + mesh->capacity / 4 + 64, memory);
}

// Lends an empty mesh rows of other arrays. Its marks, which are its own, are not cleared yet.
PARADT__OPTIONAL paradt_status paradt__mesh_lend(paradt__mesh *mesh, paradt_index *vertices, paradt_index *links,
                                                 size_t capacity, paradt__memory *memory) {
    PARADT_ASSERT(!mesh->count && !mesh->vertices);
    mesh->marks = (unsigned char *)paradt__alloc(memory, capacity, 1);
    if (!mesh->marks) return PARADT_ERROR_MEMORY;
    mesh->vertices = vertices;
    mesh->links = links;
    mesh->capacity = capacity;
    mesh->lent = 1;
    return PARADT_OK;
}

// Makes the pages of the marks that came with lent rows, and clears them. By the thread that is going to use them.
static void paradt__mesh_clear_marks(paradt__mesh *mesh) {
    paradt__make_pages(mesh->marks, 0, mesh->capacity);
    memset(mesh->marks, 0, mesh->capacity);
}

// Makes the pages of some more rows than are needed. The last page may lie behind them in part; then it is not made
// now, and the cells on it do not count as paged.
static void paradt__mesh_make_pages(paradt__mesh *mesh, size_t needed) {
    enum { AHEAD = 1 << 17 }; // bytes
    size_t row = (size_t)mesh->corners * sizeof(paradt_index), end = needed + AHEAD / row + PARADT__PAGE / row;
    if (end > mesh->capacity) end = mesh->capacity;
    paradt__make_pages(mesh->vertices, mesh->paged * row, end * row);
    paradt__make_pages(mesh->links, mesh->paged * row, end * row);
    mesh->paged = end < mesh->capacity ? end - PARADT__PAGE / row : end;
}

// --- cells, facets, ghosts

// The place of the cell that a handle's facet belongs to. Divisions by what is not a constant are slow.
PARADT__INLINE paradt_index paradt__mesh_cell(const paradt__mesh *mesh, paradt_index handle) {
    return mesh->corners == 4 ? handle >> 2 : handle / mesh->corners;
}

// The vertices of the cell at a place
PARADT__INLINE const paradt_index *paradt__mesh_row(const paradt__mesh *mesh, paradt_index place) {
    PARADT_ASSERT(place >= 0 && (size_t)place < mesh->count);
    return mesh->vertices + (size_t)place * (size_t)mesh->corners;
}

// Ties two half-facets to each other.
PARADT__INLINE void paradt__mesh_tie(paradt__mesh *mesh, paradt_index a, paradt_index b) {
    mesh->links[a] = b;
    mesh->links[b] = a;
}

// Takes a place for a new cell: a free one, or the next.
PARADT__INLINE paradt_index paradt__mesh_take(paradt__mesh *mesh) {
    PARADT_ASSERT(mesh->spare_count || mesh->count < mesh->capacity);
    if (mesh->spare_count) return mesh->spare[--mesh->spare_count];
    return (paradt_index)mesh->count++;
}

// Makes sure that so many places can be given back.
static paradt_status paradt__mesh_spare_room(paradt__mesh *mesh, size_t count, paradt__memory *memory) {
    return paradt__list_room(&mesh->spare, mesh->spare_count, &mesh->spare_capacity, mesh->spare_count + count, memory);
}

// Gives the place of a cell back; there is room for it in the list.
PARADT__INLINE void paradt__mesh_give(paradt__mesh *mesh, paradt_index place, size_t corners) {
    mesh->vertices[(size_t)place * corners] = PARADT__DEAD;
    mesh->spare[mesh->spare_count++] = place;
}

// The place on the other side of a facet of the cell or ghost at a place
PARADT__INLINE size_t paradt__mesh_across(const paradt__mesh *mesh, size_t corners, size_t place, size_t facet) {
    return (size_t)mesh->links[place * corners + facet] / corners;
}

// Sets a mark of the cell at a place. Returns 0 if it was set already.
PARADT__INLINE int paradt__mesh_mark(paradt__mesh *mesh, size_t place, unsigned char mark) {
    if (mesh->marks[place] & mark) return 0;
    mesh->marks[place] |= mark;
    return 1;
}

PARADT__INLINE void paradt__mesh_unmark(paradt__mesh *mesh, size_t place, unsigned char mark) {
    mesh->marks[place] &= (unsigned char)~mark;
}

// Number of the vertices of a cell or ghost that are in [0, end)
PARADT__INLINE int paradt__vertices_below(const paradt_index *vertices, size_t corners, paradt_index end) {
    int count = 0;
    size_t i;
    for (i = 0; i < corners; i++) count += (paradt__tag)vertices[i] < (paradt__tag)end;
    return count;
}

// Are all vertices of a cell in [begin, end)? Those of a ghost or a free place never are.
PARADT__INLINE int paradt__vertices_among(const paradt_index *vertices, int corners, paradt_index begin,
                                          paradt_index end) {
    paradt__tag first = (paradt__tag)begin, span = (paradt__tag)end - first;
    int i, among = 1;
#if PARADT__FOUR_AT_ONCE
    if (corners == 4) {
        const __m128i sign = _mm_set1_epi32(INT32_MIN), most = _mm_set1_epi32((int)(span ^ (paradt__tag)INT32_MIN));
        __m128i four = _mm_sub_epi32(_mm_loadu_si128((const __m128i *)(const void *)vertices), _mm_set1_epi32(begin));
        return _mm_movemask_epi8(_mm_cmplt_epi32(_mm_xor_si128(four, sign), most)) == 0xffff;
    }
#else
    if (corners == 4) {
        return ((paradt__tag)vertices[0] - first < span) & ((paradt__tag)vertices[1] - first < span) &
               ((paradt__tag)vertices[2] - first < span) & ((paradt__tag)vertices[3] - first < span);
    }
#endif
    for (i = 0; i < corners; i++) among &= (paradt__tag)vertices[i] - first < span;
    return among;
}

// Is there a cell, neither a ghost nor a free place?
PARADT__INLINE int paradt__is_finite_cell(const paradt_index *vertices, int corners) {
    return paradt__vertices_among(vertices, corners, 0, PARADT__NOWHERE);
}

// The place of the infinite vertex in the cell, or -1: it is no ghost
PARADT__INLINE int paradt__ghost_place(const paradt_index *cell, int corners) {
    int i;
    for (i = 0; i < corners; i++) {
        if (cell[i] == PARADT__INFINITE) return i;
    }
    return -1;
}

// Is a place in use? If by a ghost, *place becomes that of the cell behind its facet, and *facet the facet's number in
// that cell; else *facet is -1.
PARADT__INLINE int paradt__mesh_behind_ghost(const paradt__mesh *mesh, size_t corners, size_t *place, int *facet) {
    const paradt_index *vertices = mesh->vertices + *place * corners;
    size_t mirror;
    *facet = -1;
    if (PARADT__LIKELY(paradt__is_finite_cell(vertices, (int)corners))) return 1;
    if (vertices[0] == PARADT__DEAD) return 0;
    mirror = (size_t)mesh->links[*place * corners + (size_t)paradt__ghost_place(vertices, (int)corners)];
    *place = mirror / corners;
    *facet = (int)(mirror % corners);
    return 1;
}

// The vertices of the facet opposite `opposite`, in the cell's order.
PARADT__INLINE void paradt__facet_without(const paradt_index *cell, int corners, int opposite, paradt_index *facet) {
    int i, count = 0;
    for (i = 0; i < corners; i++) {
        if (i != opposite) facet[count++] = cell[i];
    }
}

// Do two handles, each of a mesh of its own, name the same set of vertices?
PARADT__INLINE int paradt__same_facet(const paradt_index *vertices, paradt_index a, const paradt_index *others,
                                      paradt_index b, int corners) {
    int skip_a = (int)(a % corners), skip_b = (int)(b % corners), i, j, missing = 0;
    const paradt_index *x = vertices + (a - skip_a), *y = others + (b - skip_b);
    for (i = 0; i < corners; i++) {
        int met = i == skip_a;
        for (j = 0; j < corners; j++) met |= (y[j] == x[i]) & (j != skip_b);
        missing |= !met;
    }
    return !missing;
}

// --- the star of a vertex

enum {
    PARADT__STAR_CELLS = 256, // that a star holds at most; some more are found with the last
    PARADT__STAR_PLACES = 512
};

typedef struct paradt__star {
    size_t count; // more than PARADT__STAR_CELLS: there are too many, and the star is not complete
    paradt_index handles[PARADT__STAR_CELLS + PARADT_MAX_DIM + 1]; // of the facet by which each cell was entered
    paradt_index table[PARADT__STAR_PLACES];                       // places of the cells, hashed; -1: free
} paradt__star;

// Adds the cell of a handle, unless the star has it.
PARADT__INLINE void paradt__star_add(paradt__star *star, paradt_index handle, paradt_index cell) {
    size_t at = (uint32_t)cell * 0x9E3779B1u >> 23;
    for (; star->table[at] != cell; at = (at + 1) % PARADT__STAR_PLACES) {
        if (star->table[at] >= 0) continue;
        star->table[at] = cell;
        star->handles[star->count++] = handle;
        return;
    }
}

// Collects the cells and ghosts around a vertex of the cell at `first`, through the facets that have the vertex. The
// first is entered by the facet opposite its first other vertex; every vertex of the star but the first cell's stands
// opposite to an entry.
PARADT__OPTIONAL void paradt__star_of(const paradt__mesh *mesh, paradt_index first, paradt_index vertex,
                                      paradt__star *star) {
    paradt_index corners = mesh->corners, base = first * corners, i;
    size_t next;
    star->count = 0;
    memset(star->table, -1, sizeof star->table);
    paradt__star_add(star, base + (mesh->vertices[base] == vertex), first);
    for (next = 0; next < star->count && star->count <= PARADT__STAR_CELLS; next++) {
        base = star->handles[next] - star->handles[next] % corners;
        for (i = base; i < base + corners; i++) {
            PARADT_ASSERT(mesh->links[i] >= 0);
            if (mesh->vertices[i] != vertex) paradt__star_add(star, mesh->links[i], mesh->links[i] / corners);
        }
    }
}

// --- compacting and closing

// Fetches the row of a place ahead of its use, of vertices and links.
PARADT__INLINE void paradt__fetch_row(const paradt_index *vertices, const paradt_index *links, size_t row,
                                      size_t corners) {
    PARADT__FETCH(vertices, row * corners);
    PARADT__FETCH(links, row * corners);
}

// Passes over all cells ask for rows so far ahead: processors do that themselves, but only within a page.
enum { PARADT__ROWS_AHEAD = 128 };

// Fetches the row of a place that comes soon in a list.
PARADT__INLINE void paradt__mesh_fetch_listed(const paradt__mesh *mesh, const paradt_index *list, size_t count,
                                              size_t at) {
    enum { AHEAD = 8 };
    if (at + AHEAD < count)
        paradt__fetch_row(mesh->vertices, mesh->links, (size_t)list[at + AHEAD], (size_t)mesh->corners);
}

// Drops the cell at a place that is to be compacted away. Its mirrors become `becomes`: PARADT__OPEN or PARADT__HULL.
PARADT__INLINE void paradt__mesh_drop(const paradt__mesh *mesh, size_t place, size_t corners, paradt_index becomes) {
    const paradt_index *links = mesh->links + place * corners;
    size_t j;
    for (j = 0; j < corners; j++) {
        if (links[j] >= 0) mesh->links[links[j]] = becomes; // else the cell there was dropped before
    }
    mesh->vertices[place * corners] = PARADT__DEAD;
}

// Drops the ghost at a place, if there is one: its facet becomes the hull's. Returns whether a cell is there.
PARADT__INLINE int paradt__mesh_keeps(const paradt__mesh *mesh, size_t place, size_t corners, uint64_t *ghosts) {
    paradt_index *vertices = mesh->vertices + place * corners;
    if (PARADT__LIKELY(paradt__is_finite_cell(vertices, (int)corners))) return 1;
    if (vertices[0] == PARADT__DEAD) return 0;
    mesh->links[mesh->links[place * corners + (size_t)paradt__ghost_place(vertices, (int)corners)]] = PARADT__HULL;
    vertices[0] = PARADT__DEAD;
    ++*ghosts;
    return 0;
}

// Moves a cell to a free place before it. Rows before `numbered` have been emitted with numbers for links. As a rule
// the cells just before this one are moved next: their neighbours, which are anywhere, are fetched ahead.
PARADT__INLINE void paradt__mesh_move(const paradt__mesh *mesh, size_t place, size_t from, size_t corners,
                                      size_t numbered) {
    enum { AHEAD = 8 };
    paradt_index *vertices = mesh->vertices, *links = mesh->links;
    const paradt_index *soon = links + (from - (from < AHEAD ? 0 : AHEAD)) * corners;
    size_t j;
    for (j = 0; j < corners; j++) PARADT__FETCH(links, soon[j]);
    memcpy(vertices + place * corners, vertices + from * corners, corners * sizeof *vertices);
    memcpy(links + place * corners, links + from * corners, corners * sizeof *links);
    for (j = 0; j < corners; j++) {
        paradt_index mirror = links[place * corners + j];
        if (mirror >= 0)
            links[mirror] = (paradt_index)((size_t)mirror < numbered * corners ? place : place * corners + j);
    }
}

// Fills those of the listed places that are dead and below mesh->count, which is the number of cells already, with the
// last cells. end: where these end. Returns where they end afterwards.
PARADT__INLINE size_t paradt__mesh_fill_listed(const paradt__mesh *mesh, const paradt_index *places, size_t count,
                                               size_t end, size_t corners) {
    size_t i;
    for (i = 0; i < count; i++) {
        size_t place = (size_t)places[i];
        if (place >= mesh->count || mesh->vertices[place * corners] != PARADT__DEAD) continue;
        do end--;
        while (mesh->vertices[end * corners] == PARADT__DEAD);
        paradt__mesh_move(mesh, place, end, corners, 0);
    }
    return end;
}

static void paradt__mesh_fill_gaps(const paradt__mesh *mesh, const paradt_index *places, size_t count, size_t *end) {
    const paradt__mesh copy = *mesh; // which nothing that is written can change
    if (copy.corners == 4) *end = paradt__mesh_fill_listed(&copy, places, count, *end, 4);
    else *end = paradt__mesh_fill_listed(&copy, places, count, *end, (size_t)copy.corners);
}

// Closes the gaps that free places and `dropped` cells leave. lists: [list_count] these name all dropped cells, and may
// name others, free places, and places more than once
PARADT__OPTIONAL void paradt__mesh_compact(paradt__mesh *mesh, size_t dropped, const paradt__list *lists,
                                           size_t list_count) {
    size_t end = mesh->count, i;
    mesh->count -= mesh->spare_count + dropped;
    paradt__mesh_fill_gaps(mesh, mesh->spare, mesh->spare_count, &end);
    for (i = 0; i < list_count; i++) paradt__mesh_fill_gaps(mesh, lists[i].items, lists[i].count, &end);
    mesh->spare_count = 0;
}

// Where the rows of emitted cells go, and in what form
typedef struct paradt__rows {
    paradt_index *vertices, *links;
    paradt_index offset; // what is added to a link for the cells before these
    int divisor, shift;  // a handle divided by that, or with four corners shifted, is the link that is wanted
} paradt__rows;

// Rows for cells of the mesh from number `first` on. facets: links remain half-facets; else they become the numbers of
// the cells on the other side.
static paradt__rows paradt__mesh_rows(int corners, int facets, paradt_index *vertices, paradt_index *links,
                                      size_t first) {
    paradt__rows to;
    to.vertices = vertices;
    to.links = links;
    to.offset = (paradt_index)(facets ? first * (size_t)corners : first);
    to.divisor = facets ? 1 : corners;
    to.shift = facets ? 0 : 2;
    return to;
}

// Writes the cell at a place into the same row of `to`, its vertices translated (origin NULL: not). Returns whether a
// facet of it has no mirror.
PARADT__INLINE int paradt__mesh_emit_row(const paradt__mesh *mesh, size_t place, size_t corners,
                                         const paradt_index *origin, const paradt__rows *to) {
    const paradt_index *vertices = mesh->vertices + place * corners, *links = mesh->links + place * corners;
    paradt_index *new_vertices = to->vertices + place * corners, *new_links = to->links + place * corners, any = 0;
    size_t j;
    paradt__fetch_row(mesh->vertices, mesh->links, place + PARADT__ROWS_AHEAD, corners);
#if PARADT__FOUR_AT_ONCE
    if (corners == 4) {
        __m128i handles = _mm_loadu_si128((const __m128i *)(const void *)links), bare = _mm_srai_epi32(handles, 31);
        __m128i mirrors = _mm_srl_epi32(handles, _mm_cvtsi32_si128(to->shift));
        mirrors = _mm_add_epi32(mirrors, _mm_set1_epi32(to->offset));
        any = -_mm_movemask_ps(_mm_castsi128_ps(handles));
        _mm_storeu_si128((__m128i *)(void *)new_links,
                         _mm_or_si128(_mm_and_si128(bare, handles), _mm_andnot_si128(bare, mirrors)));
    } else
#endif
        for (j = 0; j < corners; j++) {
            paradt_index handle = links[j];
            any |= handle;
            new_links[j] =
                handle < 0 ? handle : (paradt_index)((paradt__tag)handle / (paradt__tag)to->divisor) + to->offset;
        }
    for (j = 0; origin && j < corners; j++) new_vertices[j] = origin[vertices[j]];
    return any < 0;
}

// Drops the ghosts, closes the gaps from the end, and emits the cells in place: links in the form that is wanted,
// vertices translated by `origin`. All in one pass, for the cells don't fit into a cache. Returns the number of ghosts.
// meter: of the call, or NULL; when it is cancelled, cells are left as they are.
PARADT__INLINE uint64_t paradt__mesh_close_any(paradt__mesh *mesh, const paradt_index *origin, int facets,
                                               paradt__meter *meter, size_t corners) {
    enum { PACE = 1 << 17 };         // cells between two looks at whether the call is cancelled
    const paradt__mesh copy = *mesh; // which nothing that is written can change
    const paradt__rows to = paradt__mesh_rows(copy.corners, facets, copy.vertices, copy.links, 0);
    size_t end = copy.count, i;
    uint64_t ghosts = 0;
    for (i = 0; i < end; i++) {
        if (i % PACE == 0 && meter && paradt__meter_cancels(meter)) break;
        if (!paradt__mesh_keeps(&copy, i, corners, &ghosts)) {
            for (end--; end > i && !paradt__mesh_keeps(&copy, end, corners, &ghosts);) end--;
            if (end == i) break;
            paradt__mesh_move(&copy, i, end, corners, facets ? 0 : i);
        }
        paradt__mesh_emit_row(&copy, i, corners, origin, &to);
    }
    mesh->count = end;
    return ghosts;
}

PARADT__HOT uint64_t paradt__mesh_close(paradt__mesh *mesh, const paradt_index *origin, int facets,
                                        paradt__meter *meter) {
    if (mesh->corners == 4) return paradt__mesh_close_any(mesh, origin, facets, meter, 4);
    return paradt__mesh_close_any(mesh, origin, facets, meter, (size_t)mesh->corners);
}

// The first place from `place` on of a ghost, or of a cell with a vertex that is not in [0, own); mesh->count if there
// is none.
PARADT__INLINE size_t paradt__mesh_fringe_from(const paradt__mesh *mesh, size_t corners, paradt_index own,
                                               size_t place) {
    for (; place < mesh->count; place++) {
        const paradt_index *vertices = mesh->vertices + place * corners;
        PARADT__FETCH(vertices, 4 * PARADT__ROWS_AHEAD * corners);
        if (PARADT__LIKELY(paradt__vertices_among(vertices, (int)corners, 0, own))) continue;
        if (vertices[0] != PARADT__DEAD) break;
    }
    return place;
}

// Appends the cells of another mesh, which has no free places.
PARADT__OPTIONAL void paradt__mesh_append(paradt__mesh *mesh, const paradt__mesh *part) {
    size_t corners = (size_t)mesh->corners, i;
    paradt_index offset = (paradt_index)(mesh->count * corners), *to = mesh->links + offset;
    PARADT_ASSERT(mesh->count + part->count <= mesh->capacity && mesh->corners == part->corners);
    if (!part->count) return;
    memcpy(mesh->vertices + offset, part->vertices, part->count * corners * sizeof *to);
    for (i = 0; i < part->count * corners; i++) to[i] = part->links[i] < 0 ? part->links[i] : part->links[i] + offset;
    mesh->count += part->count;
}

// --- the validator

#if defined(PARADT_VERIFY)
// 1 where sorting the row takes an odd number of exchanges; -1: two vertices are equal
static int paradt__parity(const paradt_index *row, int count) {
    int i, j, odd = 0;
    for (i = 0; i < count; i++) {
        for (j = i + 1; j < count; j++) {
            if (row[i] == row[j]) return -1;
            odd ^= row[i] > row[j];
        }
    }
    return odd;
}

// Does what the head of the section says hold at a place?
static int paradt__mesh_is_sound_at(const paradt__mesh *mesh, size_t place) {
    int corners = mesh->corners, i, j, infinite = 0;
    const paradt_index *vertices = mesh->vertices + place * (size_t)corners;
    paradt_index facet[PARADT_MAX_DIM + 1], other[PARADT_MAX_DIM + 1];
    for (i = 0; i < corners; i++) infinite += vertices[i] == PARADT__INFINITE;
    if (infinite > 1 || paradt__parity(vertices, corners) < 0) return 0;
    for (i = 0; i < corners; i++) {
        paradt_index handle = (paradt_index)(place * (size_t)corners) + i, mirror = mesh->links[handle];
        int opposite = (int)(mirror % corners);
        if (mirror == PARADT__HULL || mirror == PARADT__OPEN) continue;
        if (mirror < 0 || (size_t)mirror >= mesh->count * (size_t)corners || mesh->links[mirror] != handle) return 0;
        if (!paradt__same_facet(mesh->vertices, handle, mesh->vertices, mirror, corners)) return 0;
        // With one name for the vertices off the facet, the rows are permutations of each other, an odd one.
        for (j = 0; j < corners; j++) {
            facet[j] = j == i ? PARADT__NOWHERE : vertices[j];
            other[j] = j == opposite ? PARADT__NOWHERE : mesh->vertices[mirror - opposite + j];
        }
        if (paradt__parity(facet, corners) == paradt__parity(other, corners)) return 0;
    }
    return 1;
}

// Is the mesh sound? closed: it has ghosts and no open facets; unmarked: these marks are clear.
static int paradt__mesh_verify(const paradt__mesh *mesh, int closed, unsigned char unmarked) {
    size_t corners = (size_t)mesh->corners, dead = 0, i, j;
    for (i = 0; i < mesh->count; i++) {
        if (mesh->vertices[i * corners] == PARADT__DEAD) {
            dead++;
            continue;
        }
        if (!paradt__mesh_is_sound_at(mesh, i) || (mesh->marks && mesh->marks[i] & unmarked)) return 0;
        for (j = 0; j < corners && closed; j++) {
            if (mesh->links[i * corners + j] < 0) return 0;
        }
    }
    return dead == mesh->spare_count;
}

enum { PARADT__VERIFIED_PLACES = 200 }; // a larger mesh is not verified after every change

#define PARADT__VERIFY(mesh, closed, unmarked) PARADT_ASSERT(paradt__mesh_verify(mesh, closed, unmarked))
#define PARADT__VERIFY_SMALL(mesh, closed, unmarked)                                                                   \
    PARADT_ASSERT((mesh)->count > PARADT__VERIFIED_PLACES || paradt__mesh_verify(mesh, closed, unmarked))
#else
#define PARADT__VERIFY(mesh, closed, unmarked)       ((void)0)
#define PARADT__VERIFY_SMALL(mesh, closed, unmarked) ((void)0)
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>facets
//
// A table of facets that wait for their mirrors, by their vertices: the active face list of the thesis (AFL), the
// ridges of a cavity, the open facets of regions. An entry is a handle in a mesh. paradt__facets_match finds the entry
// with the same vertices as a handle and takes it out, or else enters the handle; so every facet of a complete
// triangulation is entered once and taken out once, and a table that has done its work is empty without being cleared.
//
// The table is hashed with chains. The chain is chosen by the facet's smallest vertex, so that facets close to each
// other in grid order are close in memory too: the front moves over the table as it moves over the points. The rest of
// the key, a sum over the vertices that does not depend on their order, spreads the facets of one vertex where there
// are many (in high dimension), and tells facets in a chain apart. A table begun with `by_key` is spread by that key
// alone, as all ridges of a cavity have the new point in common. The table itself says where to go on, at its lowest
// chain. Doors: paradt__facets_*, paradt__facet_*, paradt__vertex_key, paradt__cell_sum, paradt__smallest_but.

typedef struct paradt__facet_entry {
    paradt_index handle, next;
    paradt_index smallest; // vertex of the facet; 0 where the table is spread by the key alone
    uint32_t key;
} paradt__facet_entry;

typedef struct paradt__facets {
    paradt_index *heads; // [mask + 1] first entry of each chain, or PARADT__OPEN
    paradt__facet_entry *entries;
    size_t mask, capacity;
    paradt_index fresh, spare; // first entry never used, first one given back
    int spread;                // a vertex has 2^spread chains
    int by_key;                // vertices do not matter
    size_t lowest;             // the chains before it are empty
    size_t count, peak;        // facets
} paradt__facets;

// How the table finds a facet
typedef struct paradt__facet_key {
    paradt_index smallest;
    uint32_t key;
} paradt__facet_key;

PARADT__INLINE uint64_t paradt__vertex_key(paradt_index vertex) {
    return ((uint64_t)vertex + 1) * UINT64_C(0x9e3779b97f4a7c15);
}

// The sum of products alone would be linear in the vertices; a square mixes it.
PARADT__INLINE uint32_t paradt__facet_hash(uint64_t sum) {
    return (uint32_t)(((sum ^ sum >> 29) * UINT64_C(0xbf58476d1ce4e5b9)) >> 32);
}

PARADT__INLINE uint64_t paradt__cell_sum(const paradt_index *vertices, int corners) {
    uint64_t sum = 0;
    int i;
    for (i = 0; i < corners; i++) sum += paradt__vertex_key(vertices[i]);
    return sum;
}

// Smallest vertex of a cell, but for the one at `without`
PARADT__INLINE paradt_index paradt__smallest_but(const paradt_index *cell, int corners, int without) {
    paradt_index smallest = PARADT__NOWHERE;
    int i;
    for (i = 0; i < corners; i++) {
        paradt_index vertex = i == without ? PARADT__NOWHERE : cell[i];
        smallest = vertex < smallest ? vertex : smallest;
    }
    return smallest;
}

// The key of the facet of a handle
PARADT__INLINE paradt__facet_key paradt__facet_key_of(const paradt__facets *facets, const paradt__mesh *mesh,
                                                      paradt_index handle) {
    int opposite = (int)(handle % mesh->corners);
    const paradt_index *cell = mesh->vertices + (handle - opposite);
    paradt__facet_key key;
    key.key = paradt__facet_hash(paradt__cell_sum(cell, mesh->corners) - paradt__vertex_key(cell[opposite]));
    key.smallest = facets->by_key ? 0 : paradt__smallest_but(cell, mesh->corners, opposite);
    return key;
}

static void paradt__facets_free(paradt__facets *facets, paradt__memory *memory) {
    paradt__release(memory, facets->heads);
    paradt__release(memory, facets->entries);
    facets->heads = NULL;
    facets->entries = NULL;
}

PARADT__INLINE paradt_index *paradt__facets_chain(const paradt__facets *facets, paradt__facet_key key) {
    size_t place = (size_t)key.smallest << facets->spread | (key.key & (((size_t)1 << facets->spread) - 1));
    return facets->heads + (place & facets->mask);
}

// Distributes the entries anew over `chains` chains.
static paradt_status paradt__facets_rehash(paradt__facets *facets, size_t chains, paradt__memory *memory) {
    paradt_index *heads = (paradt_index *)paradt__alloc(memory, chains, sizeof *heads), *old = facets->heads;
    size_t count = old ? facets->mask + 1 : 0, i;
    if (!heads) return PARADT_ERROR_MEMORY;
    for (i = 0; i < chains; i++) heads[i] = PARADT__OPEN;
    facets->heads = heads;
    facets->mask = chains - 1;
    facets->lowest = 0;
    for (i = 0; i < count; i++) {
        paradt_index at = old[i];
        while (at >= 0) {
            paradt__facet_entry *entry = facets->entries + at;
            paradt__facet_key key = {entry->smallest, entry->key};
            paradt_index next = entry->next, *head = paradt__facets_chain(facets, key);
            entry->next = *head;
            *head = at;
            at = next;
        }
    }
    paradt__release(memory, old);
    return PARADT_OK;
}

enum { PARADT__FACETS_SPREAD = 1 }; // to begin with: a small table stays in the cache

// Begins an empty table. vertices: how many vertices may be the smallest of a facet, an estimate for the number of
// chains; by_key: chains are chosen by the key alone
static paradt_status paradt__facets_begin(paradt__facets *facets, size_t vertices, int by_key, paradt__memory *memory) {
    size_t chains = 64;
    memset(facets, 0, sizeof *facets);
    facets->spare = PARADT__OPEN;
    facets->by_key = by_key;
    facets->spread = by_key ? 6 : PARADT__FACETS_SPREAD;
    while (chains >> PARADT__FACETS_SPREAD < vertices) chains *= 2;
    return paradt__facets_rehash(facets, chains, memory);
}

// Makes room for so many more facets. There are at least as many chains as facets.
PARADT__INLINE paradt_status paradt__facets_room(paradt__facets *facets, size_t more, paradt__memory *memory) {
    void *entries = facets->entries;
    size_t capacity = facets->capacity ? facets->capacity * 2 : 256, chains = (facets->mask + 1) * 2;
    paradt_status status = PARADT_OK;
    if (!PARADT__LIKELY(facets->count + more <= facets->mask)) {
        for (facets->spread++; chains <= facets->count + more; facets->spread++) chains *= 2;
        status = paradt__facets_rehash(facets, chains, memory);
    }
    if (PARADT__LIKELY((size_t)facets->fresh + more <= facets->capacity) || status) return status;
    if (capacity < (size_t)facets->fresh + more) capacity = (size_t)facets->fresh + more;
    if (!paradt__grow(memory, &entries, (size_t)facets->fresh, capacity, sizeof *facets->entries))
        return PARADT_ERROR_MEMORY;
    facets->entries = (paradt__facet_entry *)entries;
    facets->capacity = capacity;
    return PARADT_OK;
}

// Takes an entry out of its chain. Returns its handle.
PARADT__INLINE paradt_index paradt__facets_unlink(paradt__facets *facets, paradt_index *from) {
    paradt_index at = *from, handle = facets->entries[at].handle;
    *from = facets->entries[at].next;
    facets->entries[at].next = facets->spare;
    facets->spare = at;
    facets->count--;
    return handle;
}

// Takes out the facet with the same vertices as `handle` and returns it; or enters the handle, for which there is room,
// and returns PARADT__OPEN. chain: that of the key
PARADT__INLINE paradt_index paradt__facets_match(paradt__facets *facets, const paradt__mesh *mesh, paradt_index *chain,
                                                 paradt__facet_key key, paradt_index handle, int corners) {
    paradt_index *from = chain, at;
    paradt__facet_entry *entry;
    while ((at = *from) >= 0) {
        entry = facets->entries + at;
        if (entry->key == key.key && entry->smallest == key.smallest &&
            paradt__same_facet(mesh->vertices, entry->handle, mesh->vertices, handle, corners)) {
            return paradt__facets_unlink(facets, from);
        }
        from = &entry->next;
    }
    at = facets->spare;
    if (at >= 0) facets->spare = facets->entries[at].next;
    else at = facets->fresh++;
    PARADT_ASSERT((size_t)at < facets->capacity);
    entry = facets->entries + at;
    entry->handle = handle;
    entry->smallest = key.smallest;
    entry->key = key.key;
    entry->next = *chain;
    *chain = at;
    if ((size_t)(chain - facets->heads) < facets->lowest) facets->lowest = (size_t)(chain - facets->heads);
    if (++facets->count > facets->peak) facets->peak = facets->count;
    return PARADT__OPEN;
}

// Ties a facet to its mirror, if the table has that, or enters it.
PARADT__INLINE void paradt__facets_tie(paradt__facets *facets, paradt__mesh *mesh, paradt__facet_key key,
                                       paradt_index handle, int corners) {
    paradt_index mirror = paradt__facets_match(facets, mesh, paradt__facets_chain(facets, key), key, handle, corners);
    if (mirror >= 0) paradt__mesh_tie(mesh, handle, mirror);
}

// Finds the entry with the same vertices as a handle of another mesh. Returns its handle, or PARADT__OPEN.
PARADT__INLINE paradt_index paradt__facets_find(const paradt__facets *facets, const paradt__mesh *mesh,
                                                paradt__facet_key key, const paradt_index *vertices,
                                                paradt_index handle, int corners) {
    paradt_index at = *paradt__facets_chain(facets, key);
    for (; at >= 0; at = facets->entries[at].next) {
        const paradt__facet_entry *entry = facets->entries + at;
        if (entry->key == key.key && paradt__same_facet(mesh->vertices, entry->handle, vertices, handle, corners))
            return entry->handle;
    }
    return PARADT__OPEN;
}

// Takes out a facet that is in the table.
PARADT__INLINE void paradt__facets_remove(paradt__facets *facets, paradt__facet_key key, paradt_index handle) {
    paradt_index *from = paradt__facets_chain(facets, key);
    while (facets->entries[*from].handle != handle) {
        PARADT_ASSERT(facets->entries[*from].next >= 0);
        from = &facets->entries[*from].next;
    }
    paradt__facets_unlink(facets, from);
}

// Takes out a facet at the lowest vertex that there is one at, up to the wrap; PARADT__OPEN: the table is empty.
PARADT__INLINE paradt_index paradt__facets_first(paradt__facets *facets) {
    size_t at = facets->lowest;
    if (!facets->count) return PARADT__OPEN;
    while (facets->heads[at] < 0) at++;
    facets->lowest = at;
    return paradt__facets_unlink(facets, facets->heads + at);
}

enum { PARADT__JOINED = 8 }; // facets whose mirrors are looked for together

// Ties open facets to their mirrors, if these were seen before. Each step waits for memory, for all facets together.
// numbered: links are numbers of cells, as when they are delivered
PARADT__OPTIONAL paradt_status paradt__facets_join(paradt__facets *facets, paradt__mesh *mesh,
                                                   const paradt_index *handles, size_t count, int numbered,
                                                   paradt__memory *memory) {
    const paradt_index divisor = numbered ? mesh->corners : 1;
    paradt_index *chain[PARADT__JOINED];
    paradt__facet_key key[PARADT__JOINED];
    paradt_status status = paradt__facets_room(facets, PARADT__JOINED, memory);
    size_t i;
    PARADT_ASSERT(count <= PARADT__JOINED);
    for (i = 0; i < count && !status; i++) {
        key[i] = paradt__facet_key_of(facets, mesh, handles[i]);
        chain[i] = paradt__facets_chain(facets, key[i]);
        PARADT__PREFETCH(chain[i]);
    }
    for (i = 0; i < count && !status; i++) {
        if (*chain[i] >= 0) PARADT__PREFETCH(facets->entries + *chain[i]);
    }
    for (i = 0; i < count && !status; i++) {
        if (*chain[i] < 0) continue;
        PARADT__PREFETCH(mesh->vertices + facets->entries[*chain[i]].handle);
        PARADT__PREFETCH(mesh->links + facets->entries[*chain[i]].handle);
    }
    for (i = 0; i < count && !status; i++) {
        paradt_index mirror = paradt__facets_match(facets, mesh, chain[i], key[i], handles[i], mesh->corners);
        if (mirror < 0) continue;
        mesh->links[handles[i]] = mirror / divisor;
        mesh->links[mirror] = handles[i] / divisor;
    }
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>scene
//
// A mesh whose vertices are points: what walks, conflict tests and changes work on. Points are positions: their record
// is records + position * width, and all have been measured with `space`.
//
// The mesh is a closed one of T(P), P the points so far: every cell is positively oriented, never flat, and has no
// point of P in conflict with it; a ghost has the vertices of its hull facet, and the infinite vertex on the outer
// side. Each change hands out an update: the cells it killed and those it made.
//
// A ghost is in conflict with the points strictly beyond its hull facet. In the plane of the facet, it is in conflict
// with the points of the facet's circumscribing disc; these are the points of the plane with which the finite cell on
// the facet is in conflict, and that remains so under the perturbation: the lift of a point in the plane is compared
// with an affine function through the facet's lifted vertices alone.
// Doors: paradt__scene_record, paradt__side, paradt__conflicts, paradt__walk, paradt__update_free, paradt__scene_cell,
// paradt__scene_fetch_around.

typedef struct paradt__scene {
    paradt__space space;   // its own, for the counters
    const double *records; // [points][width]
    size_t width;
    paradt__mesh mesh;
    paradt_index hint; // a cell near the point inserted last
} paradt__scene;

// What a change did to the mesh. A cell is named by the handle of any of its facets. Places of killed cells may be
// those of cells made.
typedef struct paradt__update {
    paradt_index *killed; // [killed_capacity]
    size_t killed_count, killed_capacity;
    paradt_index *made; // [made_capacity]
    size_t made_count, made_capacity;
} paradt__update;

static void paradt__update_free(paradt__update *update, paradt__memory *memory) {
    paradt__release(memory, update->killed);
    paradt__release(memory, update->made);
    memset(update, 0, sizeof *update);
}

PARADT__INLINE const double *paradt__scene_record(const paradt__scene *scene, paradt_index point) {
    PARADT_ASSERT(point >= 0);
    return scene->records + (size_t)point * scene->width;
}

// The vertices of a cell, and their records
PARADT__INLINE void paradt__scene_cell(const paradt__scene *scene, size_t corners, size_t place, paradt_index *vertices,
                                       const double **records) {
    size_t i;
    for (i = 0; i < corners; i++) {
        vertices[i] = scene->mesh.vertices[place * corners + i];
        records[i] = paradt__scene_record(scene, vertices[i]);
    }
}

// Fetches the records of the vertices at a place, and the marks of its neighbours, ahead of their use.
PARADT__INLINE void paradt__scene_fetch_around(const paradt__scene *scene, size_t corners, size_t place) {
    const paradt_index *vertices = scene->mesh.vertices + place * corners;
    size_t i;
    for (i = 0; i < corners; i++) {
        if (vertices[i] >= 0) PARADT__PREFETCH(paradt__scene_record(scene, vertices[i]));
        PARADT__PREFETCH(scene->mesh.marks + paradt__mesh_across(&scene->mesh, corners, place, i));
    }
}

// Sign of the orientation of the cell with the vertex at `place` replaced by x. The other vertices are finite.
static int paradt__side(paradt__scene *scene, paradt_index cell, int place, const double *x) {
    const paradt_index *vertices = paradt__mesh_row(&scene->mesh, cell);
    const double *p[PARADT_MAX_DIM + 1];
    int i;
    for (i = 0; i < scene->mesh.corners; i++) p[i] = i == place ? x : paradt__scene_record(scene, vertices[i]);
    return paradt__orient(&scene->space, p);
}

// Is the cell or ghost in conflict with x?
static int paradt__conflicts(paradt__scene *scene, paradt_index cell, const double *x) {
    int corners = scene->mesh.corners, ghost, i, side;
    const paradt_index *vertices = paradt__mesh_row(&scene->mesh, cell);
    const double *p[PARADT_MAX_DIM + 2];
    ghost = paradt__ghost_place(vertices, corners);
    if (ghost >= 0) {
        side = paradt__side(scene, cell, ghost, x);
        if (side) return side > 0;
        cell = paradt__mesh_cell(&scene->mesh, scene->mesh.links[(size_t)cell * (size_t)corners + (size_t)ghost]);
        vertices = paradt__mesh_row(&scene->mesh, cell);
    }
    for (i = 0; i < corners; i++) p[i] = paradt__scene_record(scene, vertices[i]);
    p[corners] = x;
    return paradt__conflict(&scene->space, p);
}

// Walks from a cell or ghost to the cell that contains x, or to a ghost whose hull facet has x strictly beyond it. A
// visibility walk: it crosses any facet that has x on its other side. In a regular triangulation it ends whichever it
// takes (Edelsbrunner, "An acyclicity theorem for cell complexes in d dimensions", Combinatorica 10, 1990).
static paradt_index paradt__walk(paradt__scene *scene, paradt_index cell, const double *x) {
    const paradt__mesh *mesh = &scene->mesh;
    int corners = mesh->corners, i, from = -1;
    for (;;) {
        size_t base = (size_t)cell * (size_t)corners;
        int ghost = paradt__ghost_place(mesh->vertices + base, corners);
        PARADT_ASSERT(mesh->vertices[base] != PARADT__DEAD);
        if (ghost >= 0) {
            if (paradt__side(scene, cell, ghost, x) > 0) return cell;
            i = ghost;
        } else {
            for (i = 0; i < corners; i++) {
                if (i != from && paradt__side(scene, cell, i, x) < 0) break;
            }
            if (i == corners) return cell;
        }
        from = (int)(mesh->links[base + (size_t)i] % corners);
        cell = paradt__mesh_cell(mesh, mesh->links[base + (size_t)i]);
    }
}

#ifndef PARADT__NO_SEARCH
// ---------------------------------------------------------------------------------------------------------------------
// >>grid
//
// A hierarchy of boxes over the set, by which searches rule out most of its points. The thesis speeds InCoDe up by a
// uniform grid. This grid adapts: the set is halved again and again across the longest side of its bounding box, down
// to grid cells of eight points, which stand side by side in the record array. Eight grid cells make a group, eight
// groups one of the next level, and so on: cell i of a level covers the positions from 8^(level + 1) i on. On uniform
// points that is a uniform grid; in clusters it is as fine as they are, and in any dimension it has n / 8 cells. The
// halves are cut at multiples of 8, so positions need no pointers: the left half of a range is the smallest 8 * 2^j
// points that are at least half of it. Ties on a cut are broken by the other axes (a symbolically tilted plane), so a
// cut separates the vertices on its two sides in the sense that DeWall needs.
// Each level keeps the bounding boxes of its cells in lanes of eight, so that one group is tested at a time: the loops
// over lanes have constant bounds and straight bodies, and compilers turn them into vector code.
// Doors: paradt__grid_build, paradt__grid_lay, paradt__grid_free, paradt__grid_lanes, paradt__grid_list_within; for
// DeWall paradt__grid_cut, paradt__grid_axis, paradt__before; paradt__exchange.

enum {
    PARADT__LANES = 8,       // points a grid cell, grid cells a group
    PARADT__MAX_LEVELS = 21, // 8^21 > 2^62
    // doubles of the scratch that paradt__grid_lanes needs
    PARADT__LANES_SCRATCH = (PARADT_MAX_DIM + 1) * PARADT__LANES
};

#define PARADT__FAR 1e300 // farther than any point of a set that the floating-point filter is used on

typedef struct paradt__grid {
    int levels;
    size_t cell_count;  // grid cells at level 0
    size_t group_width; // doubles a group of boxes: low and high of each axis, the largest grade, in lanes
    double *lanes;      // [cell_count][set.width][8] the records again, coordinate by coordinate; NULL: not kept
    double *boxes[PARADT__MAX_LEVELS];      // [level] groups of eight bounding boxes
    size_t box_count[PARADT__MAX_LEVELS];   // [level] boxes
    double *cut_bounds[PARADT__MAX_LEVELS]; // [level][group] low and high of each axis, by the cuts around the group:
                                            // the set's points inside are the group's. NULL: not kept
    double heaviest;                        // largest weight, or 0
} paradt__grid;

// Is a before b along the axis? Ties are broken by the next axes: a total order on distinct points.
PARADT__INLINE int paradt__before(const paradt__space *space, const double *a, const double *b, int axis) {
    int i, dim = space->dim;
    for (i = 0; i < dim; i++) {
        if (space->filtered) {
            if (a[axis] != b[axis]) return a[axis] < b[axis];
        } else {
            int64_t left = paradt__ordered_bits(a[axis]), right = paradt__ordered_bits(b[axis]);
            if (left != right) return left < right;
        }
        if (++axis == dim) axis = 0;
    }
    return 0;
}

// Exchanges the points at two positions.
PARADT__INLINE void paradt__exchange(paradt__set *set, size_t width, size_t a, size_t b) {
    double *x = set->records + a * width, *y = set->records + b * width;
    paradt_index origin = set->origin[a];
    size_t i;
    for (i = 0; i < width; i++) {
        double t = x[i];
        x[i] = y[i];
        y[i] = t;
    }
    set->origin[a] = set->origin[b];
    set->origin[b] = origin;
}

// Returns a position in [begin, end) whose point is likely to come a little after the nth one along the axis, or a
// little before it: whichever leaves the smaller part to go on with. The point is found in a sample of `size` points,
// which are brought to the front of the range.
PARADT__INLINE size_t paradt__pivot_position(paradt__set *set, size_t width, size_t begin, size_t end, size_t nth,
                                             int axis, size_t size) {
    size_t i, j, count = end - begin, beyond = size / 16, target = (nth - begin) * size / count;
    uint64_t state = count;
#define PARADT__AT(position) (set->records + (position)*width)
    for (i = 0; i < size; i++) {
        state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        paradt__exchange(set, width, begin + i, begin + i + (size_t)((state >> 32) % (count - i)));
        for (j = begin + i; j > begin && paradt__before(&set->space, PARADT__AT(j), PARADT__AT(j - 1), axis); j--) {
            paradt__exchange(set, width, j, j - 1);
        }
    }
#undef PARADT__AT
    if (target < size / 2) target += beyond;
    else target -= beyond < target ? beyond : target;
    return begin + target;
}

// Quickselect (Hoare; the pivot by a sample, after Floyd and Rivest, CACM 18, 1975): afterwards the points of
// [begin, nth) are before those of [nth, end) along the axis. Returns a coordinate that separates the two sides weakly.
PARADT__INLINE double paradt__select(paradt__set *set, size_t width, size_t begin, size_t end, size_t nth, int axis) {
    const paradt__space *space = &set->space;
    while (end - begin > 1) {
        double pivot[PARADT_MAX_DIM + 1];
        size_t i = begin, j = end - 1, count = end - begin,
               size = count > 4096  ? 48
                      : count > 256 ? 15
                      : count > 8   ? 3
                                    : 1;
        size_t position = paradt__pivot_position(set, width, begin, end, nth, axis, size);
        memcpy(pivot, set->records + position * width, width * sizeof(double));
#define PARADT__AT(position) (set->records + (position)*width)
        for (;;) {
            while (paradt__before(space, PARADT__AT(i), pivot, axis)) i++;
            while (paradt__before(space, pivot, PARADT__AT(j), axis)) j--;
            if (i >= j) break;
            paradt__exchange(set, width, i++, j--);
        }
#undef PARADT__AT
        // Points before i are not after the pivot, points after j not before it; i == j + 1, or i == j at the pivot.
        if (nth == i || (i == j && nth == i + 1)) return pivot[axis];
        if (nth < i) end = i;
        else begin = i == j ? i + 1 : i;
    }
    return set->records[nth * width + (size_t)axis];
}

// Position of the first point of the right half of a range of more than eight points
static size_t paradt__grid_cut(size_t begin, size_t end) {
    size_t left = PARADT__LANES;
    PARADT_ASSERT(end - begin > PARADT__LANES);
    while (left * 2 < end - begin) left *= 2;
    return begin + left;
}

// Returns the axis along which the bounding box of the points [begin, end) is longest. Where differences of coordinates
// may overflow, lengths are numbers of steps from one double to the next. Inlined with constants.
PARADT__INLINE int paradt__longest_axis_of(const paradt__set *set, size_t begin, size_t end, size_t width, int dim) {
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    const double *x = set->records + begin * width, *last = set->records + end * width;
    int axis;
    for (axis = 0; axis < dim; axis++) low[axis] = high[axis] = x[axis];
    for (; x < last; x += width) {
        for (axis = 0; axis < dim; axis++) {
            low[axis] = x[axis] < low[axis] ? x[axis] : low[axis];
            high[axis] = x[axis] > high[axis] ? x[axis] : high[axis];
        }
    }
    return paradt__longest_axis(low, high, dim, !set->space.filtered);
}

// Returns the axis across which a range is cut.
static int paradt__grid_axis(const paradt__set *set, size_t begin, size_t end) {
    PARADT_ASSERT(begin < end);
    if (PARADT_MAX_DIM > 2 && set->width == 3 && set->space.dim == 3)
        return paradt__longest_axis_of(set, begin, end, 3, 3);
    return paradt__longest_axis_of(set, begin, end, set->width, set->space.dim);
}

// Keeps the bounds by cuts of a range that is a whole group, on every level where it is one.
static void paradt__grid_keep_bounds(paradt__grid *grid, const paradt__set *set, size_t begin, size_t end,
                                     const double *bounds) {
    int level;
    size_t span = PARADT__LANES * PARADT__LANES, width = 2 * (size_t)set->space.dim;
    for (level = 0; level < grid->levels; level++, span *= PARADT__LANES) {
        if (begin % span == 0 && (end - begin == span || (end == set->count && end - begin < span))) {
            memcpy(grid->cut_bounds[level] + begin / span * width, bounds, width * sizeof(double));
        }
    }
}

// Halves the range down to grid cells. around: low and high of each axis, by the cuts around the range. Returns 1 when
// the meter cancels, else 0.
static int paradt__grid_sort(paradt__grid *grid, paradt__set *set, size_t begin, size_t end, const double *around,
                             paradt__meter *meter) {
    double bounds[2 * PARADT_MAX_DIM];
    memcpy(bounds, around, sizeof bounds);
    for (;;) {
        size_t cut;
        double at, high;
        int axis;
        if (end - begin > PARADT__LANES * PARADT__LANES / 2 || end == set->count)
            paradt__grid_keep_bounds(grid, set, begin, end, bounds);
        if (end - begin <= PARADT__LANES) return 0;
        if (meter && end - begin > PARADT__PACE / 4 && paradt__meter_cancels(meter)) return 1;
        cut = paradt__grid_cut(begin, end);
        axis = paradt__grid_axis(set, begin, end);
        switch (set->width) { // the same code with the width known
        case 2: at = paradt__select(set, 2, begin, end, cut, axis); break;
        case 3: at = paradt__select(set, 3, begin, end, cut, axis); break;
        default: at = paradt__select(set, set->width, begin, end, cut, axis);
        }
        high = bounds[2 * axis + 1];
        bounds[2 * axis + 1] = at;
        if (paradt__grid_sort(grid, set, begin, cut, bounds, meter)) return 1;
        bounds[2 * axis + 1] = high;
        bounds[2 * axis] = at;
        begin = cut;
    }
}

// Writes the points of a grid cell coordinate by coordinate. Where the set ends, its last point is repeated. Inlined
// with a constant width.
PARADT__INLINE void paradt__lay_lanes_of(const paradt__set *set, size_t width, size_t cell, double *lanes) {
    size_t lane, j;
    for (lane = 0; lane < PARADT__LANES; lane++) {
        size_t position = cell * PARADT__LANES + lane;
        const double *record = set->records + (position < set->count ? position : set->count - 1) * width;
        for (j = 0; j < width; j++) lanes[j * PARADT__LANES + lane] = record[j];
    }
}

static void paradt__lay_lanes(const paradt__set *set, size_t cell, double *lanes) {
    if (set->width == 3) paradt__lay_lanes_of(set, 3, cell, lanes);
    else paradt__lay_lanes_of(set, set->width, cell, lanes);
}

// Returns the points of a grid cell coordinate by coordinate. scratch: [PARADT__LANES_SCRATCH], where they are written
// if the grid does not keep lanes.
PARADT__INLINE const double *paradt__grid_lanes(const paradt__grid *grid, const paradt__set *set, size_t cell,
                                                double *scratch) {
    PARADT_ASSERT(cell < grid->cell_count);
    if (PARADT__LIKELY(grid->lanes != NULL)) return grid->lanes + cell * set->width * PARADT__LANES;
    paradt__lay_lanes(set, cell, scratch);
    return scratch;
}

// Makes one box, around `count` points or boxes, with their largest grade where they are graded. In doubles, these are
// `step` apart, the axes of one `stride`, and its lower and upper bound `rise`. Inlined with constants.
PARADT__INLINE void paradt__grid_bound(double *box, const double *below, size_t count, size_t step, size_t stride,
                                       size_t rise, size_t ambient, int graded) {
    size_t axis, i;
    for (axis = 0; axis < ambient + (size_t)graded; axis++) {
        const double *low = below + axis * stride, *high = axis < ambient ? low + rise : low;
        double *to = box + axis * 2 * PARADT__LANES, least = low[0], most = high[0];
        for (i = 1; i < count; i++) {
            least = low[i * step] < least ? low[i * step] : least;
            most = high[i * step] > most ? high[i * step] : most;
        }
        to[0] = axis < ambient ? least : most;
        if (axis < ambient) to[PARADT__LANES] = most;
    }
}

static void paradt__grid_fill_level(paradt__grid *grid, const paradt__set *set, int level) {
    enum { ROWS = 2 * PARADT__LANES };
    size_t below = level ? grid->box_count[level - 1] : set->count, width = set->width, i;
    size_t ambient = (size_t)set->space.ambient;
    int graded = set->grade != PARADT__UNGRADED;
    for (i = 0; i < grid->box_count[level]; i++) {
        double *box = grid->boxes[level] + i / PARADT__LANES * grid->group_width + i % PARADT__LANES;
        const double *from =
            level ? grid->boxes[level - 1] + i * grid->group_width : set->records + i * PARADT__LANES * width;
        size_t left = below - i * PARADT__LANES, count = left < PARADT__LANES ? left : (size_t)PARADT__LANES;
        if (level) paradt__grid_bound(box, from, count, 1, ROWS, PARADT__LANES, ambient, graded);
        else if (PARADT_MAX_DIM > 2 && width == 3 && ambient == 3 && count == PARADT__LANES)
            paradt__grid_bound(box, from, PARADT__LANES, 3, 1, 0, 3, 0);
        else paradt__grid_bound(box, from, count, width, 1, 0, ambient, graded);
    }
}

// Fills the lanes and boxes by the set in its present order.
static void paradt__grid_fill(paradt__grid *grid, const paradt__set *set) {
    int level;
    size_t i;
    for (i = 0; grid->lanes && i < grid->cell_count; i++)
        paradt__lay_lanes(set, i, grid->lanes + i * set->width * PARADT__LANES);
    for (level = 0; level < grid->levels; level++) paradt__grid_fill_level(grid, set, level);
    for (i = 0; set->space.weighted && i < set->count; i++) {
        double weight = set->records[i * set->width + (size_t)set->space.ambient];
        if (i == 0 || weight > grid->heaviest) grid->heaviest = weight;
    }
}

static void paradt__grid_free(paradt__grid *grid, paradt__memory *memory) {
    int level;
    paradt__release(memory, grid->lanes);
    for (level = 0; level < grid->levels; level++) {
        paradt__release(memory, grid->boxes[level]);
        paradt__release(memory, grid->cut_bounds[level]);
    }
    memset(grid, 0, sizeof *grid);
}

// front: for a method that searches for every facet: the grid keeps lanes and bounds by cuts.
static paradt_status paradt__grid_allocate(paradt__grid *grid, const paradt__set *set, int front,
                                           paradt__memory *memory) {
    size_t count;
    memset(grid, 0, sizeof *grid);
    count = grid->cell_count = (set->count + PARADT__LANES - 1) / PARADT__LANES;
    grid->group_width = (size_t)(2 * set->space.ambient + (set->grade != PARADT__UNGRADED)) * PARADT__LANES;
    if (front) grid->lanes = (double *)paradt__alloc_filled(memory, count * PARADT__LANES, set->width * sizeof(double));
    if (front && !grid->lanes) return PARADT_ERROR_MEMORY;
    do {
        int level = grid->levels++;
        size_t groups = (count + PARADT__LANES - 1) / PARADT__LANES;
        grid->box_count[level] = count;
        grid->boxes[level] = (double *)paradt__alloc_filled(memory, groups * grid->group_width, sizeof(double));
        if (front)
            grid->cut_bounds[level] =
                (double *)paradt__alloc(memory, groups * 2 * (size_t)set->space.dim, sizeof(double));
        if (!grid->boxes[level] || (front && !grid->cut_bounds[level])) return PARADT_ERROR_MEMORY;
        memset(grid->boxes[level] + (groups - 1) * grid->group_width, 0, grid->group_width * sizeof(double));
        count = groups;
    } while (count > 1);
    return PARADT_OK;
}

// Sorts the set and lays the grid over it. The set has at least one point. meter: NULL, or asked now and then. After an
// error the caller frees the grid.
PARADT__OPTIONAL paradt_status paradt__grid_build(paradt__grid *grid, paradt__set *set, paradt__meter *meter,
                                                  paradt__memory *memory) {
    double bounds[2 * PARADT_MAX_DIM];
    paradt_status status = paradt__grid_allocate(grid, set, 1, memory);
    size_t i;
    PARADT_ASSERT(set->count > 0 && set->space.dim > 0);
    if (status) return status;
    for (i = 0; i < 2 * PARADT_MAX_DIM; i++) bounds[i] = i % 2 ? PARADT__FAR : -PARADT__FAR;
    if (paradt__grid_sort(grid, set, 0, set->count, bounds, meter)) return PARADT_ERROR_CANCELLED;
    paradt__grid_fill(grid, set);
    return PARADT_OK;
}

// Lays a grid over the set in the order that it has, for few searches, which begin at the top. The grid has no lanes
// and no bounds by cuts.
PARADT__OPTIONAL paradt_status paradt__grid_lay(paradt__grid *grid, const paradt__set *set, paradt__memory *memory) {
    paradt_status status = paradt__grid_allocate(grid, set, 0, memory);
    if (!status) paradt__grid_fill(grid, set);
    return status;
}

// --- the points in a box

// Is the point in the closed box?
static int paradt__is_within(const double *x, const double *low, const double *high, int dim) {
    int axis;
    for (axis = 0; axis < dim; axis++) {
        if (x[axis] < low[axis] || x[axis] > high[axis]) return 0;
    }
    return 1;
}

// What paradt__grid_list_within looks for
typedef struct paradt__within {
    const double *low, *high;
    size_t offset;
    paradt__list *list;
    paradt__memory *memory;
} paradt__within;

// Appends what is in one of the grid's boxes.
static paradt_status paradt__grid_list_box(const paradt__grid *grid, const paradt__set *set, int level, size_t box,
                                           const paradt__within *within) {
    int dim = set->space.dim, axis;
    size_t first = box * PARADT__LANES, i;
    const double *bounds = grid->boxes[level] + box / PARADT__LANES * grid->group_width + box % PARADT__LANES;
    paradt_status status = PARADT_OK;
    for (axis = 0; axis < dim; axis++, bounds += 2 * PARADT__LANES) {
        if (bounds[0] > within->high[axis] || bounds[PARADT__LANES] < within->low[axis]) return PARADT_OK;
    }
    for (i = first; i < first + PARADT__LANES && !status; i++) {
        if (level) {
            if (i >= grid->box_count[level - 1]) break;
            status = paradt__grid_list_box(grid, set, level - 1, i, within);
        } else if (i < set->count &&
                   paradt__is_within(paradt__record(set, (paradt_index)i), within->low, within->high, dim)) {
            status = paradt__list_append(within->list, (paradt_index)(within->offset + i), within->memory);
        }
    }
    return status;
}

// Appends the positions of the set's points in the closed box [low, high], each plus `offset`. A grid without points
// need not have been laid.
PARADT__OPTIONAL paradt_status paradt__grid_list_within(const paradt__grid *grid, const paradt__set *set,
                                                        const double *low, const double *high, size_t offset,
                                                        paradt__list *list, paradt__memory *memory) {
    const paradt__within within = {low, high, offset, list, memory};
    int top = grid->levels - 1;
    paradt_status status = PARADT_OK;
    size_t box;
    for (box = 0; top >= 0 && box < grid->box_count[top] && !status; box++)
        status = paradt__grid_list_box(grid, set, top, box, &within);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>search kernels
//
// The search's inner loops: each looks at the eight boxes of a group, or at the eight points of a grid cell, and rules
// out those that certainly do not matter. Boxes and points stand in lanes (see >>grid), so a kernel is a few loops of
// eight straight steps, which compilers turn into vector code. Beside each kernel stands its copy in AVX2, which is
// chosen at run time where the processor has AVX2. There is one set of kernels for each dimension and grade.
//
// A query is a facet and a sphere through it. Let o be the facet's first vertex, u = x - o, and gain the weight of x
// less that of o. The query has two functions of x:
//
//     F(u) = sum_j u_j (u_j - centre_j) - gain    negative inside the sphere
//     N(u) = sum_j normal_j u_j                   positive outside the facet
//
// With sagittas (see >>reference sphere) the lift |u|^2 - gain is the difference of the sagittas of o and x, so F(u) is
// that difference less centre . u. Floating point only ever rules out, by the bounds that the query has for the errors
// of F and N: a lane is kept unless F is certainly positive or N certainly not. What is kept >>search looks at one by
// one. All kernels use the same bounds, so all lead to the same cells, though not by the same way. >>search derives the
// bounds; K is PARADT__ROUND.
// Doors: paradt__kernels_choose, PARADT__ROUND.

// u = 2^-52 holds in every rounding mode. A term of a sum passes through a difference (u), at most 2 products (2u), and
// at most d + 2 additions in any order, and once more through as much where a box and a point in it are compared.
#define PARADT__ROUND(dim) (8.0 * ((dim) + 6) * 2.220446049250313e-16)
#define PARADT__NO_BOUND   3.2733906078961419e150 // 2^500: larger than all of a filtered set, its square finite

typedef struct paradt__lane_query {
    double origin[PARADT_MAX_DIM];
    double normal[PARADT_MAX_DIM];
    size_t outer[PARADT_MAX_DIM];     // of a box's sides on the axis, where the one with the larger N starts in a group
    double centre[PARADT_MAX_DIM];    // twice the sphere's centre
    double slack[PARADT_MAX_DIM];     // |error of F| <= f_floor + sum_j |u_j| (K |u_j| + slack_j) + K |gain|
    double reach[PARADT_MAX_DIM];     // |error of N| <= sum_j |u_j| reach_j
    double weight;                    // of the origin, or its sagitta; 0 without grades
    double clear;                     // N of a point that is worth a try as the first apex exceeds this
    double f_floor;                   // error that F has everywhere
    double n_floor;                   // N of a point outside is at least this
    double cap[PARADT_MAX_DIM];       // with sagittas: of a point outside, sum_j u_j (u_j - cap_j) is at most
    double cap_slack[PARADT_MAX_DIM]; // ... cap_floor + sum_j |u_j| (K |u_j| + cap_slack_j)
    double cap_floor;                 // ... PARADT__NO_BOUND: nothing is known of that sum
    double extent[PARADT_MAX_DIM];    // with sagittas: length of the set along each axis
    double weight_slack;              // ... and the error of a difference of two sagittas
    double curve;                     // with sagittas: on the reference sphere F(u) = curve |u|^2 - tangent . u
    double tangent[PARADT_MAX_DIM];   // ... - (1 - curve) (s(x) - s(o)), s the sagitta
    double summit[PARADT_MAX_DIM];    // where curve |u|^2 - tangent . u is least, if curve > 0; else 0
    double curve_slack;               // error of this form of F beyond F's own
    double round;                     // K
} paradt__lane_query;

// What a kernel tells of the boxes of a group
typedef struct paradt__lane_bounds {
    double f[PARADT__LANES];       // bound on the error of F in the box
    double n[PARADT__LANES];       // bound on the error of N in the box
    double promise[PARADT__LANES]; // how far below zero F may be in the box
} paradt__lane_bounds;

typedef unsigned (*paradt__group_kernel)(const paradt__lane_query *q, const double *group, paradt__lane_bounds *bounds);
typedef unsigned (*paradt__cell_kernel)(const paradt__lane_query *q, const double *cell, double f_bound,
                                        double n_bound);
typedef double (*paradt__best_kernel)(const paradt__lane_query *q, const double *cell);

typedef struct paradt__kernels {
    paradt__group_kernel group; // the mask of a group's boxes that may hold a point outside the facet and in the sphere
    paradt__cell_kernel cell;   // the mask of a grid cell's points that may be outside the facet and in the sphere
    paradt__best_kernel best;   // the grid cell's point that gives the smallest sphere; see paradt__kernel_best_plain
} paradt__kernels;

// Returns the mask of the lanes whose value is not negative.
PARADT__INLINE unsigned paradt__kernel_mask(const double *value) {
#if defined(__SSE2__) && !defined(PARADT_NO_SIMD)
    unsigned mask = (unsigned)_mm_movemask_pd(_mm_loadu_pd(value));
    mask |= (unsigned)_mm_movemask_pd(_mm_loadu_pd(value + 2)) << 2;
    mask |= (unsigned)_mm_movemask_pd(_mm_loadu_pd(value + 4)) << 4;
    mask |= (unsigned)_mm_movemask_pd(_mm_loadu_pd(value + 6)) << 6;
    return ~mask & 255;
#else
    unsigned mask = 0;
    int lane;
    for (lane = 0; lane < PARADT__LANES; lane++) mask |= (unsigned)(value[lane] >= 0.0) << lane;
    return mask;
#endif
}

// Returns the mask of the boxes that may hold a point outside the facet and inside the sphere.
PARADT__INLINE unsigned paradt__kernel_group_plain(const paradt__lane_query *q, const double *group,
                                                   paradt__lane_bounds *PARADT__RESTRICT bounds, int ambient,
                                                   int grade) {
    double margin[PARADT__LANES], f[PARADT__LANES], n[PARADT__LANES];
    int lane, j;
    for (lane = 0; lane < PARADT__LANES; lane++) {
        f[lane] = n[lane] = 0.0;
        bounds->f[lane] = q->f_floor;
        bounds->n[lane] = -q->n_floor;
    }
    for (j = 0; j < ambient; j++) {
        const double *lows = group + j * 2 * PARADT__LANES, *highs = lows + PARADT__LANES;
        const double *outer = lows + q->outer[j];
        double origin = q->origin[j], centre = q->centre[j], middle = 0.5 * centre, normal = q->normal[j];
        for (lane = 0; lane < PARADT__LANES; lane++) {
            double low = lows[lane] - origin, high = highs[lane] - origin;
            double x = middle, reach = -low > high ? -low : high;
            x = x > low ? x : low;
            x = x < high ? x : high;
            f[lane] += x * (x - centre);
            n[lane] += normal * (outer[lane] - origin);
            bounds->f[lane] += reach * (q->round * reach + q->slack[j]);
            bounds->n[lane] += reach * q->reach[j];
        }
    }
    if (grade) {
        const double *grades = group + ambient * 2 * PARADT__LANES;
        for (lane = 0; lane < PARADT__LANES; lane++) {
            double gain = grades[lane] - q->weight;
            f[lane] -= gain;
            bounds->f[lane] += q->round * (gain > 0.0 ? gain : 0.0);
        }
    }
    for (lane = 0; lane < PARADT__LANES; lane++) {
        double promise = bounds->f[lane] - f[lane], outside = bounds->n[lane] + n[lane];
        bounds->promise[lane] = promise;
        margin[lane] = promise < outside ? promise : outside;
    }
    return paradt__kernel_mask(margin);
}

// The same with sagittas. All lifts of the set are of one size, so one bound on the errors suffices: the bound at the
// distance of the set's whole extent. N is affine, so one corner of a box decides. F is taken in the form with `curve`;
// see paradt__pencil_set_curve.
PARADT__INLINE unsigned paradt__kernel_group_sagittas(const paradt__lane_query *q, const double *group,
                                                      paradt__lane_bounds *bounds, int ambient) {
    const double *grades = group + ambient * 2 * PARADT__LANES, *outer[PARADT_MAX_DIM];
    double margin[PARADT__LANES], f_bound = q->f_floor + q->weight_slack, n_bound = -q->n_floor;
    double gain = 1.0 - q->curve;
    int lane, j;
    for (j = 0; j < ambient; j++) {
        outer[j] = group + j * 2 * PARADT__LANES + q->outer[j];
        f_bound += q->extent[j] * q->slack[j];
        n_bound += q->extent[j] * q->reach[j];
    }
    if (q->curve > 0.0) {
        for (lane = 0; lane < PARADT__LANES; lane++) {
            double f = gain * (q->weight - grades[lane]), n = n_bound;
            for (j = 0; j < ambient; j++) {
                double low = group[j * 2 * PARADT__LANES + lane] - q->origin[j];
                double high = group[(j * 2 + 1) * PARADT__LANES + lane] - q->origin[j], x = q->summit[j];
                x = x > low ? x : low;
                x = x < high ? x : high;
                f += x * (q->curve * x - q->tangent[j]);
                n += q->normal[j] * (outer[j][lane] - q->origin[j]);
            }
            f = f_bound + q->curve_slack - f;
            bounds->promise[lane] = f;
            margin[lane] = f < n ? f : n;
        }
    } else {
        for (lane = 0; lane < PARADT__LANES; lane++) {
            double f = gain * (q->weight - grades[lane]), n = n_bound;
            for (j = 0; j < ambient; j++) {
                double low = group[j * 2 * PARADT__LANES + lane] - q->origin[j];
                double high = group[(j * 2 + 1) * PARADT__LANES + lane] - q->origin[j];
                double a = low * (q->curve * low - q->tangent[j]), b = high * (q->curve * high - q->tangent[j]);
                f += a < b ? a : b;
                n += q->normal[j] * (outer[j][lane] - q->origin[j]);
            }
            f = f_bound + q->curve_slack - f;
            bounds->promise[lane] = f;
            margin[lane] = f < n ? f : n;
        }
    }
    for (lane = 0; lane < PARADT__LANES; lane++) {
        bounds->f[lane] = f_bound;
        bounds->n[lane] = n_bound;
    }
    if (q->cap_floor < PARADT__NO_BOUND) {
        for (lane = 0; lane < PARADT__LANES; lane++) {
            double g = -q->cap_floor;
            for (j = 0; j < ambient; j++) {
                double low = group[j * 2 * PARADT__LANES + lane] - q->origin[j];
                double high = group[(j * 2 + 1) * PARADT__LANES + lane] - q->origin[j];
                double x = q->cap[j] * 0.5, reach = -low > high ? -low : high;
                x = x > low ? x : low;
                x = x < high ? x : high;
                g += x * (x - q->cap[j]) - reach * (q->round * reach + q->cap_slack[j]);
            }
            margin[lane] = -g < margin[lane] ? -g : margin[lane];
        }
    }
    return paradt__kernel_mask(margin);
}

// The same for the eight points of a grid cell. f_bound, n_bound: the bounds on the errors that hold in its box
PARADT__INLINE unsigned paradt__kernel_cell_plain(const paradt__lane_query *q, const double *cell, double f_bound,
                                                  double n_bound, int ambient, int grade) {
    double margin[PARADT__LANES];
    int lane, j;
    for (lane = 0; lane < PARADT__LANES; lane++) {
        double f = 0.0, n = 0.0;
        for (j = 0; j < ambient; j++) {
            double u = cell[j * PARADT__LANES + lane] - q->origin[j];
            f += grade == PARADT__SAGITTA ? -u * q->centre[j] : u * (u - q->centre[j]);
            n += q->normal[j] * u;
        }
        if (grade) f -= cell[ambient * PARADT__LANES + lane] - q->weight;
        f = f_bound - f;
        n = n + n_bound;
        margin[lane] = f < n ? f : n;
    }
    return paradt__kernel_mask(margin);
}

// Of the eight points of a grid cell that are clearly outside the facet, finds the one on the sphere with the smallest
// parameter t in the pencil. Returns F / N, which is that t less the current sphere's; the last three bits are the
// lane. Returns about PARADT__FAR when no point is clearly outside.
PARADT__INLINE double paradt__kernel_best_plain(const paradt__lane_query *q, const double *cell, int ambient,
                                                int grade) {
    double ratio[PARADT__LANES], heights[PARADT__LANES];
    uint64_t bits[PARADT__LANES];
    int lane, j;
    for (lane = 0; lane < PARADT__LANES; lane++) {
        double lift = 0.0, height = 0.0;
        for (j = 0; j < ambient; j++) {
            double u = cell[j * PARADT__LANES + lane] - q->origin[j];
            lift += grade == PARADT__SAGITTA ? -u * q->centre[j] : u * (u - q->centre[j]);
            height += q->normal[j] * u;
        }
        if (grade) lift -= cell[ambient * PARADT__LANES + lane] - q->weight;
        ratio[lane] = lift / height;
        heights[lane] = height;
    }
    for (lane = 0; lane < PARADT__LANES; lane++) ratio[lane] = heights[lane] > q->clear ? ratio[lane] : PARADT__FAR;
    memcpy(bits, ratio, sizeof bits);
    for (lane = 0; lane < PARADT__LANES; lane++) bits[lane] = (bits[lane] & ~(uint64_t)7) | (uint64_t)lane;
    memcpy(ratio, bits, sizeof bits);
    for (lane = 0; lane < 4; lane++) ratio[lane] = ratio[lane] < ratio[lane + 4] ? ratio[lane] : ratio[lane + 4];
    for (lane = 0; lane < 2; lane++) ratio[lane] = ratio[lane] < ratio[lane + 2] ? ratio[lane] : ratio[lane + 2];
    return ratio[0] < ratio[1] ? ratio[0] : ratio[1];
}

#if defined(PARADT__AVX2)
// The same three for processors with AVX2, four lanes at a time.
#define PARADT__ALL(value) _mm256_set1_pd(value)

PARADT__AVX2 PARADT__INLINE unsigned paradt__kernel_group_avx2(const paradt__lane_query *q, const double *group,
                                                               paradt__lane_bounds *bounds, int ambient, int grade) {
    const __m256d sign = PARADT__ALL(-0.0), round = PARADT__ALL(q->round);
    __m256d f[2], n[2], f_bound[2], n_bound[2];
    unsigned mask = 0;
    int half, j;
    for (half = 0; half < 2; half++) {
        f[half] = n[half] = _mm256_setzero_pd();
        f_bound[half] = PARADT__ALL(q->f_floor);
        n_bound[half] = PARADT__ALL(-q->n_floor);
    }
    for (j = 0; j < ambient; j++) {
        const double *side = group + j * 2 * PARADT__LANES;
        const __m256d origin = PARADT__ALL(q->origin[j]), centre = PARADT__ALL(q->centre[j]);
        const __m256d middle = _mm256_mul_pd(PARADT__ALL(0.5), centre), normal = PARADT__ALL(q->normal[j]);
        for (half = 0; half < 2; half++) {
            __m256d low = _mm256_sub_pd(_mm256_loadu_pd(side + 4 * half), origin);
            __m256d high = _mm256_sub_pd(_mm256_loadu_pd(side + 4 * half + PARADT__LANES), origin);
            __m256d outer = _mm256_sub_pd(_mm256_loadu_pd(side + 4 * half + q->outer[j]), origin);
            __m256d reach = _mm256_max_pd(_mm256_xor_pd(low, sign), high);
            __m256d x = _mm256_min_pd(_mm256_max_pd(middle, low), high);
            __m256d error = _mm256_fmadd_pd(round, reach, PARADT__ALL(q->slack[j]));
            f[half] = _mm256_fmadd_pd(x, _mm256_sub_pd(x, centre), f[half]);
            n[half] = _mm256_fmadd_pd(normal, outer, n[half]);
            f_bound[half] = _mm256_fmadd_pd(reach, error, f_bound[half]);
            n_bound[half] = _mm256_fmadd_pd(reach, PARADT__ALL(q->reach[j]), n_bound[half]);
        }
    }
    for (half = 0; half < 2; half++) {
        if (grade) {
            const double *grades = group + ambient * 2 * PARADT__LANES + 4 * half;
            __m256d gain = _mm256_sub_pd(_mm256_loadu_pd(grades), PARADT__ALL(q->weight));
            f[half] = _mm256_sub_pd(f[half], gain);
            f_bound[half] = _mm256_fmadd_pd(round, _mm256_max_pd(gain, _mm256_setzero_pd()), f_bound[half]);
        }
        f[half] = _mm256_sub_pd(f_bound[half], f[half]);
        n[half] = _mm256_add_pd(n_bound[half], n[half]);
        _mm256_storeu_pd(bounds->f + 4 * half, f_bound[half]);
        _mm256_storeu_pd(bounds->n + 4 * half, n_bound[half]);
        _mm256_storeu_pd(bounds->promise + 4 * half, f[half]);
        mask |= (unsigned)_mm256_movemask_pd(_mm256_min_pd(f[half], n[half])) << 4 * half;
    }
    return ~mask & 255;
}

// Computes F and N of four points.
PARADT__AVX2 PARADT__INLINE void paradt__kernel_lift_avx2(const paradt__lane_query *q, const double *lanes, int ambient,
                                                          int grade, __m256d *f, __m256d *n) {
    int j;
    *f = *n = _mm256_setzero_pd();
    for (j = 0; j < ambient; j++) {
        __m256d u = _mm256_sub_pd(_mm256_loadu_pd(lanes + j * PARADT__LANES), PARADT__ALL(q->origin[j]));
        __m256d centre = PARADT__ALL(q->centre[j]);
        if (grade == PARADT__SAGITTA) *f = _mm256_fnmadd_pd(u, centre, *f);
        else *f = _mm256_fmadd_pd(u, _mm256_sub_pd(u, centre), *f);
        *n = _mm256_fmadd_pd(PARADT__ALL(q->normal[j]), u, *n);
    }
    if (grade) {
        __m256d weight = _mm256_loadu_pd(lanes + ambient * PARADT__LANES);
        *f = _mm256_sub_pd(*f, _mm256_sub_pd(weight, PARADT__ALL(q->weight)));
    }
}

PARADT__AVX2 PARADT__INLINE unsigned paradt__kernel_cell_avx2(const paradt__lane_query *q, const double *cell,
                                                              double f_bound, double n_bound, int ambient, int grade) {
    unsigned mask = 0;
    int half;
    for (half = 0; half < PARADT__LANES; half += 4) {
        __m256d f, n;
        paradt__kernel_lift_avx2(q, cell + half, ambient, grade, &f, &n);
        f = _mm256_sub_pd(PARADT__ALL(f_bound), f);
        n = _mm256_add_pd(n, PARADT__ALL(n_bound));
        mask |= (unsigned)_mm256_movemask_pd(_mm256_min_pd(f, n)) << half;
    }
    return ~mask & 255;
}

PARADT__AVX2 PARADT__INLINE double paradt__kernel_best_avx2(const paradt__lane_query *q, const double *cell,
                                                            int ambient, int grade) {
    const __m256d beyond = PARADT__ALL(PARADT__FAR), number = _mm256_castsi256_pd(_mm256_set1_epi64x(7));
    __m256d best[2], n;
    __m128d pair;
    int half;
    for (half = 0; half < 2; half++) {
        paradt__kernel_lift_avx2(q, cell + 4 * half, ambient, grade, best + half, &n);
        best[half] =
            _mm256_blendv_pd(beyond, _mm256_div_pd(best[half], n), _mm256_cmp_pd(n, PARADT__ALL(q->clear), _CMP_GT_OQ));
        best[half] =
            _mm256_or_pd(_mm256_andnot_pd(number, best[half]),
                         _mm256_castsi256_pd(half ? _mm256_setr_epi64x(4, 5, 6, 7) : _mm256_setr_epi64x(0, 1, 2, 3)));
    }
    best[0] = _mm256_min_pd(best[0], best[1]);
    pair = _mm_min_pd(_mm256_castpd256_pd128(best[0]), _mm256_extractf128_pd(best[0], 1));
    return _mm_cvtsd_f64(_mm_min_sd(pair, _mm_unpackhi_pd(pair, pair)));
}
#undef PARADT__ALL
#endif

// The kernels of one instruction set for dimension d and grade w
#define PARADT__KERNEL_SET(isa, attribute, d, w)                                                                       \
    attribute static unsigned paradt__kernel_group_##isa##_##d##_##w(const paradt__lane_query *q, const double *group, \
                                                                     paradt__lane_bounds *bounds) {                    \
        if (w == PARADT__SAGITTA) return paradt__kernel_group_sagittas(q, group, bounds, d);                           \
        return paradt__kernel_group_##isa(q, group, bounds, d, w);                                                     \
    }                                                                                                                  \
    attribute static unsigned paradt__kernel_cell_##isa##_##d##_##w(const paradt__lane_query *q, const double *cell,   \
                                                                    double f_bound, double n_bound) {                  \
        return paradt__kernel_cell_##isa(q, cell, f_bound, n_bound, d, w);                                             \
    }                                                                                                                  \
    attribute static double paradt__kernel_best_##isa##_##d##_##w(const paradt__lane_query *q, const double *cell) {   \
        return paradt__kernel_best_##isa(q, cell, d, w);                                                               \
    }
#define PARADT__KERNEL_SETS(isa, attribute, d)                                                                         \
    PARADT__KERNEL_SET(isa, attribute, d, 0)                                                                           \
    PARADT__KERNEL_SET(isa, attribute, d, 1)                                                                           \
    PARADT__KERNEL_SET(isa, attribute, d, 2)
#define PARADT__KERNEL_NAMES(isa, d, w)                                                                                \
    {                                                                                                                  \
        paradt__kernel_group_##isa##_##d##_##w, paradt__kernel_cell_##isa##_##d##_##w,                                 \
            paradt__kernel_best_##isa##_##d##_##w                                                                      \
    }
#define PARADT__KERNEL_ROW(isa, d)                                                                                     \
    {PARADT__KERNEL_NAMES(isa, d, 0), PARADT__KERNEL_NAMES(isa, d, 1), PARADT__KERNEL_NAMES(isa, d, 2)},

#define PARADT__KERNEL_SETS_PLAIN(d) PARADT__KERNEL_SETS(plain, , d)
#define PARADT__KERNEL_ROW_PLAIN(d)  PARADT__KERNEL_ROW(plain, d)
PARADT__DIMENSIONS(PARADT__KERNEL_SETS_PLAIN)
#if defined(PARADT__AVX2)
#define PARADT__KERNEL_SETS_AVX2(d) PARADT__KERNEL_SETS(avx2, PARADT__AVX2, d)
#define PARADT__KERNEL_ROW_AVX2(d)  PARADT__KERNEL_ROW(avx2, d)
PARADT__DIMENSIONS(PARADT__KERNEL_SETS_AVX2)
#endif

// Returns the fastest kernels that the processor has. ambient: coordinates a point; grade: as that of a set
static paradt__kernels paradt__kernels_choose(int ambient, int grade) {
    static const paradt__kernels plain[][3] = {PARADT__DIMENSIONS(PARADT__KERNEL_ROW_PLAIN)};
#if defined(PARADT__AVX2)
    static const paradt__kernels avx2[][3] = {PARADT__DIMENSIONS(PARADT__KERNEL_ROW_AVX2)};
#endif
    PARADT_ASSERT(ambient >= 2 && ambient <= PARADT_MAX_DIM && grade >= 0 && grade <= 2);
#if defined(PARADT__AVX2)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2[ambient - 2][grade];
#endif
    return plain[ambient - 2][grade];
}

// ---------------------------------------------------------------------------------------------------------------------
// >>pencil
//
// The spheres through a facet, and how far floating point can be trusted with them.
//
// Let o be a vertex of the facet f, u = x - o, and lift(u) = |u|^2 less the difference of the weights. The spheres
// through f are the pencil F_t(u) = A(u) - t N(u), where N(u) = normal . u vanishes on f and is positive outside, and
// A(u) = lift(u) - base . u vanishes on f. x is inside sphere t where F_t < 0. Outside of f, x lies on the sphere t(x)
// = A(x) / N(x). The centre moves outward along the normal with t, so the smallest t is the smallest signed Delaunay
// distance dd of the thesis.
//
// Let K bound the relative rounding of the sums below (PARADT__ROUND). Let e_i = p_i - o be the edges of f at o, and
// e*_i their dual basis in their span. The computed `base` and `normal` do not vanish on f but have residuals r_i =
// lift(e_i) - base . e_i and s_i = normal . e_i. So the true A differs from the computed one by at most
//
//     sum_i |r_i| |e*_i . u| <= base_slack |u|_1,    base_slack = sum_i |r_i| |e*_i|_max
//
// and N likewise by normal_slack |u|_1, with s_i for r_i. To these come the rounding, K sum_j |normal_j u_j| and the
// like, and f_floor for the error that sagittas have themselves. The dual basis is itself computed. The product |e_i|_1
// |e*_i|_max is the inverse sine of the facet's angles: while it stays below 2^36, the relative error of the dual basis
// is below 2^-10, and a factor of 2 in the slacks covers it. A facet more needle-like than that gets slacks so large
// that nothing is ruled out and all is decided exactly.
//
// A search keeps one pencil and sets it facet by facet. Doors: paradt__pencil_begin, paradt__pencil_set_facet,
// paradt__pencil_set_sphere, paradt__pencil_set_whole_sphere, paradt__pencil_is_inside, paradt__pencil_is_outside,
// paradt__pencil_boxes_beyond, paradt__pencil_is_confined.

#define PARADT__NEEDLE 68719476736.0         // 2^36
#define PARADT__STEEP  2.0370359763344861e90 // 2^300: spheres that flat are left to the predicates

// The dimension that the inner functions have copies for, where all coordinates orient and nothing follows them
enum { PARADT__PLAIN_DIM = PARADT_MAX_DIM < 3 ? PARADT_MAX_DIM : 3 };

typedef struct paradt__pencil {
    const paradt__set *set;
    paradt__space space; // the set's, but with the counters of this pencil
    int plain;           // the set has PARADT__PLAIN_DIM coordinates, of which all orient, and no grades
    const double *corners[PARADT_MAX_DIM + 2]; // the facet's dim vertices, then the current sphere's point
    int outside;                               // sign of the orientation (facet, x) for x outside
    double base[PARADT_MAX_DIM];
    double base_slack, normal_slack;
    unsigned changes; // how often the sphere was set for this facet; 0: there is none yet
    unsigned growths; // how often a bound on the errors was enlarged by that, for all facets
    paradt__lane_query q;
} paradt__pencil;

// Prepares pencils for facets of the set, or of sets of the same space and grade.
static void paradt__pencil_begin(paradt__pencil *p, const paradt__set *set) {
    int j;
    memset(p, 0, sizeof *p);
    p->set = set;
    p->space = set->space;
    memset(&p->space.counters, 0, sizeof p->space.counters);
    p->plain = set->space.dim == PARADT__PLAIN_DIM && set->space.ambient == PARADT__PLAIN_DIM && !set->grade;
    p->q.round = PARADT__ROUND(set->space.ambient);
    p->q.f_floor = 4.0 * set->grade_error;
    p->q.weight_slack = 2.0 * p->q.round * set->grade_limit;
    for (j = 0; j < set->space.ambient; j++) {
        if (set->space.low[j] > set->space.high[j]) continue;
        p->q.extent[j] =
            1.0000001 * (paradt__from_ordered_bits(set->space.high[j]) - paradt__from_ordered_bits(set->space.low[j]));
    }
}

// Adds the terms of one edge to the slacks. lift_size: sum of the sizes of the lift's terms. Returns 0 if the facet is
// a needle.
PARADT__INLINE int paradt__pencil_add_residual(paradt__pencil *p, const double *edge, double lift, double lift_size,
                                               const double *dual, int dim) {
    double r = lift, r_size = lift_size, n = 0.0, n_size = 0.0, length = 0.0, dual_size = 0.0;
    int j;
    for (j = 0; j < dim; j++) {
        double d = paradt__abs(dual[j]);
        r -= p->base[j] * edge[j];
        r_size += paradt__abs(p->base[j] * edge[j]);
        n += p->q.normal[j] * edge[j];
        n_size += paradt__abs(p->q.normal[j] * edge[j]);
        length += paradt__abs(edge[j]);
        dual_size = d > dual_size ? d : dual_size;
    }
    p->base_slack += 2.0 * dual_size * (paradt__abs(r) + p->q.round * r_size + p->q.f_floor);
    p->normal_slack += 2.0 * dual_size * (paradt__abs(n) + p->q.round * n_size);
    return length * dual_size < PARADT__NEEDLE;
}

#if PARADT_MAX_DIM >= 3
// Computes the normal, e1 x e2, and the dual basis d of a triangle in 3D by cross products. Returns 0 if it is flat.
PARADT__INLINE int paradt__pencil_of_triangle(paradt__pencil *p, double edges[][PARADT_MAX_DIM],
                                              double d[][PARADT_MAX_DIM]) {
    const double *e = edges[0], *f = edges[1];
    double *n = p->q.normal, size, inverse;
    int j;
    n[0] = e[1] * f[2] - e[2] * f[1];
    n[1] = e[2] * f[0] - e[0] * f[2];
    n[2] = e[0] * f[1] - e[1] * f[0];
    size = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (!(size > 0.0)) return 0;
    inverse = 1.0 / size;
    d[0][0] = (f[1] * n[2] - f[2] * n[1]) * inverse;
    d[0][1] = (f[2] * n[0] - f[0] * n[2]) * inverse;
    d[0][2] = (f[0] * n[1] - f[1] * n[0]) * inverse;
    d[1][0] = (n[1] * e[2] - n[2] * e[1]) * inverse;
    d[1][1] = (n[2] * e[0] - n[0] * e[2]) * inverse;
    d[1][2] = (n[0] * e[1] - n[1] * e[0]) * inverse;
    for (j = 0; j < 3 && p->outside < 0; j++) n[j] = -n[j];
    return 1;
}
#endif

// Computes a unit vector perpendicular to the orthonormal rows: takes the axis farthest from their span and subtracts,
// twice, its projection on the span.
static void paradt__pencil_normal(const double rows[][PARADT_MAX_DIM], int count, int dim, double *normal) {
    int axis, best = 0, i, j, pass;
    double least = 2.0, length = 0.0;
    for (axis = 0; axis < dim; axis++) {
        double inside = 0.0;
        for (i = 0; i < count; i++) inside += rows[i][axis] * rows[i][axis];
        if (inside < least) least = inside, best = axis;
    }
    for (j = 0; j < dim; j++) normal[j] = j == best ? 1.0 : 0.0;
    for (pass = 0; pass < 2; pass++) {
        for (i = 0; i < count; i++) {
            double dot = 0.0;
            for (j = 0; j < dim; j++) dot += rows[i][j] * normal[j];
            for (j = 0; j < dim; j++) normal[j] -= dot * rows[i][j];
        }
    }
    for (j = 0; j < dim; j++) length += normal[j] * normal[j];
    length = 1.0 / sqrt(length);
    for (j = 0; j < dim; j++) normal[j] *= length;
}

// Computes the normal, of either sign, and the dual basis of a facet in any dimension: edges = L Q by modified
// Gram-Schmidt, and the dual basis is the columns of Q^T L^-1. The ratios of the edges to the diagonal of L are bounded
// first, so nothing overflows before a needle is found. Returns 0 if the facet is a needle.
PARADT__NOINLINE int paradt__pencil_of_facet(paradt__pencil *p, double edges[][PARADT_MAX_DIM],
                                             double dual[][PARADT_MAX_DIM], int dim) {
    double q[PARADT_MAX_DIM][PARADT_MAX_DIM], l[PARADT_MAX_DIM][PARADT_MAX_DIM];
    int i, j, k;
    for (i = 0; i < dim - 1; i++) {
        double length = 0.0;
        memcpy(q[i], edges[i], sizeof q[i]);
        for (k = 0; k < i; k++) {
            double dot = 0.0;
            for (j = 0; j < dim; j++) dot += q[k][j] * q[i][j];
            for (j = 0; j < dim; j++) q[i][j] -= dot * q[k][j];
            l[i][k] = dot;
        }
        for (j = 0; j < dim; j++) length += q[i][j] * q[i][j];
        l[i][i] = sqrt(length);
        if (!(l[i][i] * PARADT__NEEDLE > paradt__largest(edges[i], dim))) return 0;
        for (j = 0; j < dim; j++) q[i][j] /= l[i][i];
    }
    // Dual vector i is y Q with L y = unit i.
    for (i = 0; i < dim - 1; i++) {
        double y[PARADT_MAX_DIM];
        memset(dual[i], 0, sizeof dual[i]);
        for (k = i; k < dim - 1; k++) {
            double rest = k == i ? 1.0 : 0.0;
            for (j = i; j < k; j++) rest -= l[k][j] * y[j];
            y[k] = rest / l[k][k];
            for (j = 0; j < dim; j++) dual[i][j] += y[k] * q[k][j];
        }
    }
    paradt__pencil_normal((const double(*)[PARADT_MAX_DIM])q, dim - 1, dim, p->q.normal);
    return 1;
}

// Makes the normal point away from `inner`. Where the side of `inner` is in doubt, N will rule out nothing.
static void paradt__pencil_orient_normal(paradt__pencil *p, const double *inner, int dim) {
    double side = 0.0, size = 0.0;
    int j;
    for (j = 0; j < dim; j++) {
        double u = inner[j] - p->q.origin[j];
        side += p->q.normal[j] * u;
        size += paradt__abs(u) * (p->q.round * paradt__abs(p->q.normal[j]) + p->normal_slack);
    }
    for (j = 0; j < dim && side > size; j++) p->q.normal[j] = -p->q.normal[j];
    if (side >= -size && side <= size) p->normal_slack = PARADT__NO_BOUND;
}

// Nothing is known about the pencil in floating point: leaves everything to the predicates.
static void paradt__pencil_forget(paradt__pencil *p) {
    memset(p->q.normal, 0, sizeof p->q.normal);
    memset(p->base, 0, sizeof p->base);
    p->base_slack = p->normal_slack = PARADT__NO_BOUND;
}

// Sets the least N of a point outside. If the coordinates are multiples of one power of two, as in lattices, and N is a
// determinant of them (`determinant`), N is such a multiple, too. If, besides, its error is less than half of the
// smallest such multiple that is not 0, the sign of N is known everywhere.
PARADT__INLINE void paradt__pencil_set_floor(paradt__pencil *p, int determinant) {
    const paradt__space *space = &p->space;
    p->q.n_floor =
        determinant && space->orient_certain < 0.5 * space->orient_quantum ? 0.5 * space->orient_quantum : 0.0;
}

// Finds the sphere that holds the cap of the reference sphere outside of the facet. Near a reference sphere with centre
// c, the points outside of a facet that faces away from c are such a cap, and the cap lies in the smallest sphere
// through the facet. Let G(u) = |u|^2 - cap . u with cap = twice the centre of that smallest sphere, w = o - c, and s
// the sagittas. All u of the set have |u|^2 = -2 w . u + s(o) - s(u), so G(u) = -(2 w + cap) . u + s(o) - s(u). Now
// 2 w + cap is mu times the normal, up to a rest. If mu > 0, N(u) > 0 implies G(u) <= |rest| |u| + s(o) - s(u). This
// rules out boxes that the facet's plane cuts far from the facet; near the hull it cuts boxes of every size.
static void paradt__pencil_set_cap(paradt__pencil *p, double edges[][PARADT_MAX_DIM], double dual[][PARADT_MAX_DIM],
                                   int dim) {
    double mu = 0.0, size = 0.0, two_w[PARADT_MAX_DIM];
    int i, j;
    for (j = 0; j < dim; j++) p->q.cap[j] = 0.0;
    for (i = 0; i < dim - 1; i++) {
        double lift = 0.0;
        for (j = 0; j < dim; j++) lift += edges[i][j] * edges[i][j];
        for (j = 0; j < dim; j++) p->q.cap[j] += lift * dual[i][j];
    }
    for (j = 0; j < dim; j++) {
        two_w[j] = 2.0 * (p->q.origin[j] - p->set->centre[j]);
        mu += (two_w[j] + p->q.cap[j]) * p->q.normal[j];
        size += p->q.normal[j] * p->q.normal[j];
    }
    if (!(mu > 0.0)) return;
    mu /= size;
    for (j = 0; j < dim; j++) {
        double rest = two_w[j] + p->q.cap[j] - mu * p->q.normal[j];
        p->q.cap_slack[j] =
            paradt__abs(rest) + mu * p->q.reach[j] +
            p->q.round * (paradt__abs(two_w[j]) + paradt__abs(p->q.cap[j]) + paradt__abs(mu * p->q.normal[j]));
    }
    p->q.cap_floor = 2.0 * (p->set->grade_limit + p->set->grade_error) + mu * p->q.n_floor;
}

// Computes the pencil of the facet p->corners[0..dim - 1]. inner: a point off the facet, on the inner side; sided: 0 if
// both sides are outside. Inlined with constants for plain sets.
PARADT__INLINE void paradt__pencil_set_facet_of_shape(paradt__pencil *p, const double *inner, int sided, int dim,
                                                      int ambient, int grade) {
    double edges[PARADT_MAX_DIM][PARADT_MAX_DIM], dual[PARADT_MAX_DIM][PARADT_MAX_DIM];
    double lifts[PARADT_MAX_DIM], lift_sizes[PARADT_MAX_DIM];
    int i, j, sound;
    const double *o = p->corners[0];
    for (j = 0; j < ambient; j++) p->q.origin[j] = o[j];
    p->q.weight = grade ? o[ambient] : 0.0;
    for (i = 0; i < dim - 1; i++) {
        const double *x = p->corners[i + 1];
        double loss = grade ? p->q.weight - x[ambient] : 0.0, square = 0.0;
        for (j = 0; j < ambient; j++) {
            double e = x[j] - o[j];
            edges[i][j] = e;
            if (grade != PARADT__SAGITTA) square += e * e;
        }
        lifts[i] = square + loss;
        lift_sizes[i] = square + paradt__abs(loss); // square and loss may cancel
    }
    p->base_slack = p->normal_slack = 0.0;
#if PARADT_MAX_DIM >= 3
    sound = dim == 3 ? paradt__pencil_of_triangle(p, edges, dual) : paradt__pencil_of_facet(p, edges, dual, dim);
#else
    sound = paradt__pencil_of_facet(p, edges, dual, dim);
#endif
    for (j = 0; j < dim && sound; j++) {
        p->base[j] = 0.0;
        for (i = 0; i < dim - 1; i++) p->base[j] += lifts[i] * dual[i][j];
    }
    for (i = 0; i < dim - 1 && sound; i++) {
        sound = paradt__pencil_add_residual(p, edges[i], lifts[i], lift_sizes[i], dual[i], dim);
    }
    if (sound && dim != 3) paradt__pencil_orient_normal(p, inner, dim);
    if (!sound) paradt__pencil_forget(p);
    paradt__pencil_set_floor(p, sound && dim == 3);
    p->q.clear = 0.0;
    for (j = 0; j < dim; j++) p->q.clear = paradt__larger(p->q.clear, paradt__abs(p->q.normal[j]));
    if (dim > 1) p->q.clear *= 1e-9 * paradt__largest(edges[0], dim);
    for (j = 0; j < ambient; j++) {
        if (j >= dim) p->q.normal[j] = p->base[j] = 0.0;
        p->q.outer[j] = p->q.normal[j] < 0.0 ? 0 : PARADT__LANES;
        p->q.centre[j] = p->base[j];
        p->q.slack[j] = PARADT__NO_BOUND;
        p->q.reach[j] =
            j < dim && p->q.n_floor == 0.0 ? p->q.round * paradt__abs(p->q.normal[j]) + p->normal_slack : 0.0;
    }
    PARADT_ASSERT(p->base_slack >= 0.0 && p->normal_slack >= 0.0); // and are numbers
    p->q.cap_floor = PARADT__NO_BOUND;
    if (grade == PARADT__SAGITTA && sound && sided) paradt__pencil_set_cap(p, edges, dual, dim);
    p->changes = 0;
}

static void paradt__pencil_set_facet(paradt__pencil *p, const double *inner, int sided) {
    if (p->plain) paradt__pencil_set_facet_of_shape(p, inner, sided, PARADT__PLAIN_DIM, PARADT__PLAIN_DIM, 0);
    else paradt__pencil_set_facet_of_shape(p, inner, sided, p->space.dim, p->space.ambient, p->set->grade);
}

// Chooses the form of F for boxes near the reference sphere. On that sphere |u|^2 = -2 w . u + s(o) - s(u), with w =
// o - c, so a multiple of the difference of the two sides may be added to F: the multiple that leaves nothing of the
// centre along w. In this form F varies in a box with the square of its size, as on the sphere, though the box reaches
// off the sphere by its size.
static void paradt__pencil_set_curve(paradt__pencil *p, int dim) {
    double dot = 0.0, square = 0.0, half, two_w[PARADT_MAX_DIM];
    int j;
    for (j = 0; j < dim; j++) {
        two_w[j] = 2.0 * (p->q.origin[j] - p->set->centre[j]);
        dot += p->q.centre[j] * two_w[j];
        square += two_w[j] * two_w[j];
    }
    p->q.curve = dot / square;
    if (!(paradt__abs(p->q.curve) < 0.5 && paradt__abs(p->q.curve) > 1.0 / PARADT__STEEP)) p->q.curve = 0.0;
    half = p->q.curve > 0.0 ? 0.5 / p->q.curve : 0.0;
    p->q.curve_slack = paradt__abs(p->q.curve) * (p->q.f_floor + 2.0 * p->q.weight_slack);
    for (j = 0; j < dim; j++) {
        double moved = p->q.curve * two_w[j];
        p->q.tangent[j] = p->q.centre[j] - moved;
        p->q.summit[j] = p->q.tangent[j] * half;
        p->q.curve_slack +=
            2.0 * p->q.round * p->q.extent[j] *
            (paradt__abs(p->q.curve) * p->q.extent[j] + paradt__abs(p->q.centre[j]) + 2.0 * paradt__abs(moved));
    }
}

// Makes the sphere through x the current one. n: N(x); n_bound: the bound on its error. The slacks are set to twice
// what is needed and then kept while that suffices, so bounds on errors in a box mostly hold for the next sphere, too.
// Inlined with constants for plain sets.
PARADT__INLINE void paradt__pencil_set_sphere_of_shape(paradt__pencil *p, const double *x, double n, double n_bound,
                                                       int dim, int ambient, int grade) {
    int j, grown = !p->changes;
    double a = 0.0, a_bound = p->q.f_floor, t, t_bound, size;
    if (p->q.n_floor > 0.0) n_bound = p->space.orient_certain;
    size = paradt__abs(n) - n_bound;
    p->corners[dim] = x;
    p->changes++;
    for (j = 0; j < ambient; j++) {
        double u = x[j] - p->q.origin[j], reach = paradt__abs(u);
        a += grade == PARADT__SAGITTA ? -u * p->base[j] : u * (u - p->base[j]);
        a_bound += reach * (p->q.round * paradt__abs(p->base[j]) + p->base_slack);
        if (grade != PARADT__SAGITTA) a_bound += p->q.round * reach * reach;
    }
    if (grade) {
        double gain = x[ambient] - p->q.weight;
        a -= gain;
        a_bound += p->q.round * paradt__abs(gain);
    }
    t = size > 0.0 ? a / n : PARADT__STEEP;
    t_bound = size > 0.0 ? (a_bound + paradt__abs(t) * n_bound) / size + p->q.round * paradt__abs(t) : PARADT__STEEP;
    if (!(paradt__abs(t) < PARADT__STEEP && t_bound < PARADT__STEEP)) {
        for (j = 0; j < ambient; j++) p->q.slack[j] = PARADT__NO_BOUND;
        p->growths++;
        return;
    }
    for (j = 0; j < ambient; j++) {
        double normal = p->q.normal[j], slack;
        p->q.centre[j] = p->base[j] + t * normal;
        slack = p->q.round * (paradt__abs(p->base[j]) + paradt__abs(t * normal)) + t_bound * paradt__abs(normal);
        if (j < dim) slack += p->base_slack + (paradt__abs(t) + t_bound) * p->normal_slack;
        if (grown || slack > p->q.slack[j]) {
            p->q.slack[j] = 2.0 * slack;
            grown = 1;
        }
    }
    p->growths += (unsigned)grown;
    if (grade == PARADT__SAGITTA) paradt__pencil_set_curve(p, dim);
}

static void paradt__pencil_set_sphere(paradt__pencil *p, const double *x, double n, double n_bound) {
    if (p->plain) paradt__pencil_set_sphere_of_shape(p, x, n, n_bound, PARADT__PLAIN_DIM, PARADT__PLAIN_DIM, 0);
    else paradt__pencil_set_sphere_of_shape(p, x, n, n_bound, p->space.dim, p->space.ambient, p->set->grade);
}

// Makes the sphere through x the current one and lets both sides of the facet be outside.
static void paradt__pencil_set_whole_sphere(paradt__pencil *p, const double *x) {
    double n = 0.0, n_bound = 0.0;
    int j;
    for (j = 0; j < p->space.dim && p->space.filtered; j++) {
        double u = x[j] - p->q.origin[j];
        n += p->q.normal[j] * u;
        n_bound += paradt__abs(u) * p->q.reach[j];
    }
    paradt__pencil_set_sphere(p, x, n, n_bound);
    for (j = 0; j < p->space.ambient; j++) p->q.reach[j] = PARADT__NO_BOUND;
    p->q.n_floor = 0.0;
}

// Is x in conflict with the cell of the facet and the current sphere's point? Decides exactly.
static int paradt__pencil_is_inside(paradt__pencil *p, const double *x) {
    const double *points[PARADT_MAX_DIM + 2];
    int dim = p->space.dim, i;
    for (i = 0; i <= dim; i++) points[i] = p->corners[i];
    if (p->outside < 0) {
        points[dim - 1] = p->corners[dim];
        points[dim] = p->corners[dim - 1];
    }
    points[dim + 1] = x;
    return paradt__conflict(&p->space, points);
}

// Is x strictly outside the facet? Decides exactly.
static int paradt__pencil_is_outside(paradt__pencil *p, const double *x) {
    const double *points[PARADT_MAX_DIM + 1];
    int dim = p->space.dim, i;
    for (i = 0; i < dim; i++) points[i] = p->corners[i];
    points[dim] = x;
    return paradt__orient(&p->space, points) * p->outside > 0;
}

// Returns the mask without those boxes of a group that surely do not reach strictly beyond the facet. In a box, N(u)
// and its error add up to at most the sum over the axes of the largest normal_j u_j + reach_j |u_j|, which is convex in
// u_j. Where that sum is not positive, nothing in the box is beyond. So the many points in the plane of a facet on a
// flat hull are ruled out.
PARADT__NOINLINE unsigned paradt__pencil_boxes_beyond(const paradt__pencil *p, const double *group, unsigned mask) {
    unsigned left, beyond = 0;
    int j;
    if (p->q.n_floor > 0.0) return mask; // then the kernel has ruled such boxes out
    for (left = mask; left; left &= left - 1) {
        int lane = paradt__trailing_zeros(left);
        double most = 0.0;
        for (j = 0; j < p->space.dim; j++) {
            double low = group[2 * j * PARADT__LANES + lane] - p->q.origin[j];
            double high = group[(2 * j + 1) * PARADT__LANES + lane] - p->q.origin[j];
            double a = p->q.normal[j] * low + p->q.reach[j] * paradt__abs(low);
            double b = p->q.normal[j] * high + p->q.reach[j] * paradt__abs(high);
            most += a > b ? a : b;
        }
        beyond |= (unsigned)(most > 0.0) << lane;
    }
    return beyond;
}

// Is every point outside of the box ruled out? box: low and high of each axis; heaviest: no point is heavier. Let there
// be a current sphere. Its centre is m = centre / 2, its radius r = |m|, or sqrt(|m|^2 + the largest gain) if there are
// heavier points than the origin. For u outside of the box, D = |u - m| is at least the distance of m from the walls,
// and F(u) >= D^2 - r^2. With |u|_1 <= sqrt(d) (D + r), F(u) > K |u|_1 |u|_max + slack |u|_1 if D - r > K d (D + r) +
// sqrt(d) slack. Both sides of this grow with D, so the walls decide. With sagittas, the sphere that holds the cap
// outside the facet takes the place of the current sphere, even while there is none.
static int paradt__pencil_is_confined(const paradt__pencil *p, const double *box, double heaviest) {
    int capped = p->q.cap_floor < PARADT__NO_BOUND, j, dim = p->space.dim;
    const double *whole = capped ? p->q.cap : p->q.centre, *slacks = capped ? p->q.cap_slack : p->q.slack;
    double nearest = PARADT__FAR, radius = capped ? p->q.cap_floor : 0.0, slack = 0.0;
    if (!capped && (!p->changes || p->set->grade == PARADT__SAGITTA)) return 0;
    for (j = 0; j < dim; j++) {
        double m = 0.5 * whole[j]; // the differences first: they have small relative errors
        double low = (p->q.origin[j] - box[2 * j]) + m, high = (box[2 * j + 1] - p->q.origin[j]) - m;
        nearest = low < nearest ? low : nearest;
        nearest = high < nearest ? high : nearest;
        radius += m * m;
        slack = slacks[j] > slack ? slacks[j] : slack;
    }
    if (p->space.weighted && heaviest > p->q.weight) radius += heaviest - p->q.weight;
    radius = sqrt(radius);
    return nearest - radius > p->q.round * dim * (nearest + radius) + 3.0 * slack;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>search
//
// MakeSimplex of the thesis: given a facet, finds the point on its outer side with the smallest signed Delaunay
// distance dd. By the same means it finds a point in conflict with a given cell, or beyond a given facet.
//
// A point whose F is certainly positive for the current sphere can't be the apex and is passed over. A point whose F is
// certainly negative replaces the apex. All others are settled by the exact perturbed predicate, which is a total order
// on the pencil. The same bounds, taken over a box, rule out the boxes on the inner side and those outside the sphere
// (see >>pencil and >>search kernels). The order in which points are seen only matters for speed.
//
// Nobody else writes the search's fields; its set may be read. Doors: paradt__search_begin, paradt__search_limit,
// paradt__search_skip_finished, paradt__search_admit, paradt__search_space, paradt__search_counters,
// paradt__search_effort, paradt__search_add_counts, paradt__search_point, paradt__search_from_top,
// paradt__search_aim_at_facet, paradt__search_aim_at_cell, paradt__search_apex, paradt__search_conflict.

// What the search is aimed at
enum {
    PARADT__AIM_APEX,     // the point outside the facet that is on the smallest sphere
    PARADT__AIM_CONFLICT, // any point in the sphere, on both sides of the facet
    PARADT__AIM_BEYOND    // any point strictly outside the facet
};

typedef struct paradt__search {
    const paradt__set *set;
    const paradt__grid *grid;
    paradt__kernels kernels;
    size_t begin, end;          // only these positions are searched
    double heaviest;            // no point that may be found is heavier
    uint8_t *const *unfinished; // [level][group] bits of the boxes with points that may be an apex; NULL: all boxes
    uint64_t distance_evaluations, grid_cells_visited;
    int aim;
    int opposite;                       // the vertex of the cell aimed at that is not of the facet
    uint8_t *const *boxes;              // as `unfinished`, for the present aim
    paradt_index facet[PARADT_MAX_DIM]; // positions of the facet's vertices; others than the set's: they are not in it
    paradt_index apex;                  // the best point so far, or PARADT__OPEN
    int found;                          // aimed at any point: the apex is one
    paradt__pencil pencil;              // of the facet
} paradt__search;

// Prepares a search in the set, of which the grid has the points.
static void paradt__search_begin(paradt__search *s, const paradt__set *set, const paradt__grid *grid) {
    memset(s, 0, sizeof *s);
    s->set = set;
    s->grid = grid;
    s->heaviest = grid->heaviest;
    s->kernels = paradt__kernels_choose(set->space.ambient, set->grade);
    s->end = set->count;
    paradt__pencil_begin(&s->pencil, set);
}

// Only the positions [begin, end) are searched from now on.
PARADT__OPTIONAL void paradt__search_limit(paradt__search *s, size_t begin, size_t end) {
    PARADT_ASSERT(begin <= end && end <= s->set->count);
    s->begin = begin;
    s->end = end;
}

// From now on searches for an apex pass over boxes without unfinished points. unfinished: [level][group] bits of the
// boxes that have some, as they are at each search
PARADT__OPTIONAL void paradt__search_skip_finished(paradt__search *s, uint8_t *const *unfinished) {
    s->unfinished = unfinished;
}

// The search will be put to points of another grid, too: its heaviest point may be an answer.
PARADT__OPTIONAL void paradt__search_admit(paradt__search *s, const paradt__grid *grid) {
    s->heaviest = paradt__larger(s->heaviest, grid->heaviest);
}

// Returns the space of the search's set, in which its predicates are counted.
PARADT__INLINE paradt__space *paradt__search_space(paradt__search *s) {
    return &s->pencil.space;
}

// Returns what the search counted of predicates.
static const paradt__counters *paradt__search_counters(const paradt__search *s) {
    return &s->pencil.space.counters;
}

// Returns how much work the search has done: grid cells visited and predicates evaluated.
PARADT__OPTIONAL uint64_t paradt__search_effort(const paradt__search *s) {
    return s->grid_cells_visited + s->pencil.space.counters.insphere_calls + s->pencil.space.counters.orient_calls;
}

// Adds what the search counted of grid cells and distances.
static void paradt__search_add_counts(const paradt__search *s, paradt_stats *stats) {
    stats->distance_evaluations += s->distance_evaluations;
    stats->grid_cells_visited += s->grid_cells_visited;
}

// --- points

// Looks at one point that was not ruled out with its neighbours: the point becomes the apex, or is no answer.
PARADT__INLINE void paradt__search_point_of_shape(paradt__search *s, size_t position, int dim, int ambient, int grade) {
    paradt_index point = (paradt_index)position;
    const double *x;
    double f = 0.0, f_bound = s->pencil.q.f_floor, n = 0.0, n_bound = -s->pencil.q.n_floor;
    int i, j;
    if (position >= s->set->count || point == s->apex) return;
    for (i = 0; i < dim; i++) {
        if (point == s->facet[i]) return;
    }
    x = paradt__record(s->set, point);
    if (s->pencil.space.filtered) {
        for (j = 0; j < ambient; j++) {
            double u = x[j] - s->pencil.q.origin[j], reach = paradt__abs(u);
            f += grade == PARADT__SAGITTA ? -u * s->pencil.q.centre[j] : u * (u - s->pencil.q.centre[j]);
            f_bound += reach * s->pencil.q.slack[j];
            if (grade != PARADT__SAGITTA) f_bound += reach * s->pencil.q.round * reach;
            n += s->pencil.q.normal[j] * u;
            n_bound += reach * s->pencil.q.reach[j];
        }
        if (grade) {
            double gain = x[ambient] - s->pencil.q.weight;
            f -= gain;
            f_bound += s->pencil.q.round * paradt__abs(gain);
        }
    } else {
        f_bound = n_bound = PARADT__NO_BOUND;
    }
    if (s->aim != PARADT__AIM_CONFLICT) {
        if (n < -n_bound || (n <= n_bound && !paradt__pencil_is_outside(&s->pencil, x))) return;
    }
    if (s->apex >= 0) {
        if (f > f_bound || (f >= -f_bound && !paradt__pencil_is_inside(&s->pencil, x))) return;
    }
    if (s->aim == PARADT__AIM_APEX) {
        paradt__pencil_set_sphere(&s->pencil, x, n, n_bound);
    } else {
        s->found = 1;
    }
    s->apex = point;
}

static void paradt__search_point(paradt__search *s, size_t position) {
    if (s->pencil.plain) paradt__search_point_of_shape(s, position, PARADT__PLAIN_DIM, PARADT__PLAIN_DIM, 0);
    else paradt__search_point_of_shape(s, position, s->pencil.space.dim, s->pencil.space.ambient, s->set->grade);
}

// --- boxes

// Returns the mask without the bit of a point, where that is in the grid cell.
PARADT__INLINE unsigned paradt__lanes_without(unsigned mask, size_t cell, paradt_index point) {
    size_t lane = (size_t)point - cell * PARADT__LANES;
    return mask & ~(unsigned)((uint64_t)1 << (lane < 63 ? lane : 63));
}

// Returns the lane that a kernel has put into the last bits of its result.
PARADT__INLINE int paradt__lane_unpack(double packed) {
    return (int)(paradt__bits(packed) & 7);
}

// Looks at the points of a grid cell that are not ruled out together, the most promising first: after that one, most
// others are ruled out. f_bound, n_bound: bounds on the errors of F and N in the grid cell's box
static void paradt__search_cell(paradt__search *s, size_t cell, double f_bound, double n_bound) {
    double scratch[PARADT__LANES_SCRATCH];
    const double *lanes = paradt__grid_lanes(s->grid, s->set, cell, scratch);
    unsigned mask = s->kernels.cell(&s->pencil.q, lanes, f_bound, n_bound);
    int i;
    s->distance_evaluations += PARADT__LANES;
    s->grid_cells_visited++;
    if (!mask) return;
    for (i = 0; i < s->pencil.space.dim; i++)
        mask = paradt__lanes_without(mask, cell, s->facet[i]); // they are on every sphere
    mask = paradt__lanes_without(mask, cell, s->apex);
    while (mask && !s->found) {
        int lane = paradt__trailing_zeros(mask);
        unsigned changes = s->pencil.changes, growths = s->pencil.growths;
        if (mask & (mask - 1)) {
            int best = paradt__lane_unpack(s->kernels.best(&s->pencil.q, lanes));
            lane = mask >> best & 1 ? best : lane;
        }
        paradt__search_point(s, cell * PARADT__LANES + (size_t)lane);
        mask &= ~(1u << lane);
        if (mask && s->pencil.changes != changes && s->pencil.growths == growths)
            mask &= s->kernels.cell(&s->pencil.q, lanes, f_bound, n_bound);
    }
}

// Returns the box of the mask, which is not 0, in which F may be the smallest.
PARADT__INLINE int paradt__lanes_most_promising(const paradt__lane_bounds *bounds, unsigned mask) {
    int best = paradt__trailing_zeros(mask), lane;
    for (mask &= mask - 1; mask; mask &= mask - 1) {
        lane = paradt__trailing_zeros(mask);
        best = bounds->promise[lane] > bounds->promise[best] ? lane : best;
    }
    return best;
}

// Looks into the boxes of a group at `level`. skip: number of a box that was looked at before, or any other number
static void paradt__search_group(paradt__search *s, int level, size_t group, size_t skip) {
    const double *boxes = s->grid->boxes[level] + group * s->grid->group_width;
    size_t span = (size_t)PARADT__LANES << (3 * level); // points a box
    size_t first = group * PARADT__LANES, lane;
    unsigned remaining = 255, mask, changes = s->pencil.changes, growths = s->pencil.growths;
    paradt__lane_bounds bounds;
    if (first * span < s->begin) remaining &= 255u << (s->begin / span - first);
    if ((first + PARADT__LANES) * span > s->end) remaining &= 255u >> (first + PARADT__LANES - 1 - (s->end - 1) / span);
    if (s->boxes) remaining &= s->boxes[level][group];
    if (skip - first < PARADT__LANES) remaining &= ~(1u << (skip - first));
    mask = s->kernels.group(&s->pencil.q, boxes, &bounds) & remaining;
    if (s->aim == PARADT__AIM_BEYOND) mask = paradt__pencil_boxes_beyond(&s->pencil, boxes, mask);
    while (mask && !s->found) {
        lane = level ? (size_t)paradt__lanes_most_promising(&bounds, mask) : (size_t)paradt__trailing_zeros(mask);
        mask &= ~(1u << lane);
        remaining &= ~(1u << lane);
        if (level) {
            paradt__search_group(s, level - 1, first + lane, SIZE_MAX);
        } else {
            paradt__search_cell(s, first + lane, bounds.f[lane], bounds.n[lane]);
        }
        // A smaller sphere rules out more boxes: worth another test where boxes are groups. Larger bounds need one.
        if (s->pencil.growths != growths || (level && mask && s->pencil.changes != changes)) {
            changes = s->pencil.changes;
            growths = s->pencil.growths;
            mask = s->kernels.group(&s->pencil.q, boxes, &bounds) & remaining;
        }
    }
}

// Finds a first apex in the grid cells of the facet's vertices, so that most of the grid is ruled out from the start.
static void paradt__search_start(paradt__search *s) {
    size_t cells[3], best = SIZE_MAX;
    double least = 0.5 * PARADT__FAR, scratch[PARADT__LANES_SCRATCH];
    int i, count = 0;
    for (i = 0; i < s->pencil.space.dim && i < 3; i++) {
        cells[count] = (size_t)s->facet[i] / PARADT__LANES;
        count += count == 0 || (cells[count] != cells[count - 1] && cells[count] != cells[0]);
    }
    for (i = 0; i < count; i++) {
        double t = s->kernels.best(&s->pencil.q, paradt__grid_lanes(s->grid, s->set, cells[i], scratch));
        size_t position = cells[i] * PARADT__LANES + (size_t)paradt__lane_unpack(t);
        best = t < least ? position : best;
        least = t < least ? t : least;
    }
    s->distance_evaluations += (uint64_t)count * PARADT__LANES;
    s->grid_cells_visited += (uint64_t)count;
    if (best != SIZE_MAX) paradt__search_point(s, best);
}

// Is no point outside of the group of use any more?
static int paradt__search_is_done(const paradt__search *s, int level, size_t group) {
    const double *room = s->grid->cut_bounds[level] + group * 2 * (size_t)s->pencil.space.dim;
    return paradt__pencil_is_confined(&s->pencil, room, s->heaviest);
}

// Looks at all points that may matter, those near `position` first: at its grid cell's group, then, level by level, at
// the groups that contain this group.
static void paradt__search_around(paradt__search *s, size_t position) {
    size_t box = position / PARADT__LANES, skip = SIZE_MAX;
    int level;
    if (!s->pencil.space.filtered) {
        for (box = s->begin; box < s->end && !s->found; box++) paradt__search_point(s, box);
        return;
    }
    for (level = 0; level < s->grid->levels && !s->found; level++) {
        size_t span = (size_t)PARADT__LANES << (3 * level);
        if (level && skip * span <= s->begin && (skip + 1) * span >= s->end) break;
        paradt__search_group(s, level, box / PARADT__LANES, skip);
        skip = box / PARADT__LANES;
        if (level && paradt__search_is_done(s, level, skip)) break;
        box = skip;
    }
}

// Looks at all points that may matter, from the top of the grid, as no position is near to the facet.
PARADT__OPTIONAL void paradt__search_from_top(paradt__search *s) {
    size_t at;
    if (s->pencil.space.filtered) {
        paradt__search_group(s, s->grid->levels - 1, 0, SIZE_MAX);
    } else {
        for (at = s->begin; at < s->end && !s->found; at++) paradt__search_point(s, at);
    }
}

// --- what to search for

// Aims at the facet opposite `opposite` of a cell with this orientation. corners: [dim + 1] records of the cell's
// vertices, laid out as those of the set, or NULL: they are all points of the set; positions: theirs in the set, any
// others for vertices that are not in it
PARADT__INLINE void paradt__search_aim_at_facet(paradt__search *s, int aim, const double *const *corners,
                                                const paradt_index *positions, int opposite, int orientation) {
    int dim = s->pencil.space.dim, i, count = 0;
    PARADT_ASSERT(opposite >= 0 && opposite <= dim && (orientation == 1 || orientation == -1));
    for (i = 0; i <= dim; i++) {
        if (i == opposite) continue;
        s->facet[count] = positions[i];
        s->pencil.corners[count++] = corners ? corners[i] : paradt__record(s->set, positions[i]);
    }
    s->aim = aim;
    s->boxes = aim == PARADT__AIM_APEX ? s->unfinished : NULL;
    s->opposite = opposite;
    // x in the place of `opposite` reverses the orientation; dim - opposite exchanges move x to the end.
    s->pencil.outside = (dim - opposite) % 2 ? orientation : -orientation;
    s->found = 0;
    s->apex = PARADT__OPEN;
    if (s->pencil.space.filtered)
        paradt__pencil_set_facet(&s->pencil, corners ? corners[opposite] : paradt__record(s->set, positions[opposite]),
                                 aim != PARADT__AIM_CONFLICT);
}

// Aims at any point in conflict with a positively oriented cell: the facet is the one opposite its last vertex, which
// is the apex and outside. corners, positions: as above, but no position is negative
static void paradt__search_aim_at_cell(paradt__search *s, const double *const *corners, const paradt_index *positions) {
    int dim = s->pencil.space.dim;
    PARADT_ASSERT(positions[dim] >= 0);
    paradt__search_aim_at_facet(s, PARADT__AIM_CONFLICT, corners, positions, dim, -1);
    paradt__pencil_set_whole_sphere(&s->pencil, corners[dim]);
    s->apex = positions[dim];
}

// Are all vertices of the cell points of the set?
PARADT__INLINE int paradt__search_has(const paradt__search *s, const paradt_index *cell) {
    int i;
    for (i = 0; i <= s->pencil.space.dim; i++) {
        if (cell[i] < 0 || (size_t)cell[i] >= s->set->count) return 0;
    }
    return 1;
}

// Finds the cell outside the facet opposite vertex `opposite` of the positively oriented cell. Returns its apex, or
// PARADT__HULL if there is no such cell. made: gets the cell's vertices, positively oriented; *place: the apex's place
PARADT__OPTIONAL paradt_index paradt__search_apex(paradt__search *s, const paradt_index *cell, int opposite,
                                                  paradt_index *made, int *place) {
    int dim = s->pencil.space.dim, i;
    PARADT_ASSERT(paradt__search_has(s, cell));
    paradt__search_aim_at_facet(s, PARADT__AIM_APEX, NULL, cell, opposite, 1);
    if (s->pencil.space.filtered) paradt__search_start(s);
    paradt__search_around(s, (size_t)s->facet[0]);
    if (s->apex < 0) return PARADT__HULL;
    PARADT_ASSERT(s->apex != cell[opposite]);
    for (i = 0; i < dim; i++) made[i] = s->facet[i];
    made[dim] = s->apex;
    *place = dim;
    if (s->pencil.outside < 0) { // two vertices change places: other ones than the apex, if there are
        made[1] = s->facet[0];
        made[0] = dim > 1 ? s->facet[1] : s->apex;
        *place = dim > 1 ? dim : 0;
    }
    return s->apex;
}

// Returns a point in conflict with the positively oriented cell, or PARADT__OPEN: the cell is one of T(P).
PARADT__OPTIONAL paradt_index paradt__search_conflict(paradt__search *s, const paradt_index *cell) {
    const double *corners[PARADT_MAX_DIM + 1];
    int i;
    PARADT_ASSERT(paradt__search_has(s, cell));
    for (i = 0; i <= s->pencil.space.dim; i++) corners[i] = paradt__record(s->set, cell[i]);
    paradt__search_aim_at_cell(s, corners, cell);
    paradt__search_around(s, (size_t)cell[0]);
    return s->found ? s->apex : (paradt_index)PARADT__OPEN;
}
#endif // PARADT__NO_SEARCH

#ifndef PARADT_NO_REGIONS
// ---------------------------------------------------------------------------------------------------------------------
// >>questions
//
// Is any point of a set in conflict with this cell, or strictly beyond this facet? The cell's vertices need not be
// points of the set: regions and ranks ask each other about cells that they have built alone. A question is put to a
// search: paradt__question_cell and paradt__question_facet state it, paradt__question_redirect puts it to another set
// of the same space, axes and grade. paradt__question_boxes and paradt__question_is_confined answer on the safe side,
// paradt__question_answer and paradt__question_fits exactly. Any point that fits is an answer, not the best one.
//
// A cell is given by the records of its vertices, laid out as those of the set and measured with it, and by their
// positions in the set; a vertex that is not in the set has PARADT__NOWHERE or a negative number for its position.
// Doors: paradt__question_cell, paradt__question_facet, paradt__question_redirect, paradt__question_is_confined,
// paradt__question_boxes, paradt__question_fits, paradt__question_answer.

// Asks for a point in conflict with the positively oriented cell. corners, positions: [dim + 1]
static void paradt__question_cell(paradt__search *s, const double *const *corners, const paradt_index *positions) {
    paradt_index places[PARADT_MAX_DIM + 1];
    int i;
    for (i = 0; i <= s->pencil.space.dim; i++) places[i] = positions[i] >= 0 ? positions[i] : PARADT__NOWHERE;
    paradt__search_aim_at_cell(s, corners, places);
}

// Asks for a point strictly beyond the facet opposite vertex `opposite` of a cell with this orientation, 1 or -1.
// corners, positions: [dim + 1]
static void paradt__question_facet(paradt__search *s, const double *const *corners, const paradt_index *positions,
                                   int opposite, int orientation) {
    paradt__search_aim_at_facet(s, PARADT__AIM_BEYOND, corners, positions, opposite, orientation);
}

// Puts the question to another set. positions: [dim + 1] of the vertices in that set, none of them negative; grid: of
// the set, or NULL where only paradt__question_fits follows
static void paradt__question_redirect(paradt__search *s, const paradt__set *set, const paradt__grid *grid,
                                      const paradt_index *positions) {
    int i, count = 0;
    PARADT_ASSERT(s->aim != PARADT__AIM_APEX && !s->found);
    PARADT_ASSERT(set->space.dim == s->pencil.space.dim && set->grade == s->set->grade);
    for (i = 0; i <= s->pencil.space.dim; i++) {
        if (i != s->opposite) s->facet[count++] = positions[i];
        else if (s->aim == PARADT__AIM_CONFLICT) s->apex = positions[i];
    }
    s->set = set;
    s->grid = grid;
    s->begin = 0;
    s->end = set->count;
}

// Do all answers lie in the box, wherever their points come from? box: low and high of each axis. 1: yes; 0: unknown
static int paradt__question_is_confined(const paradt__search *s, const double *box) {
    return s->pencil.space.filtered && paradt__pencil_is_confined(&s->pencil, box, s->heaviest);
}

// Returns the mask of the boxes that may hold an answer. group: eight boxes, laid out as those of a grid
PARADT__INLINE unsigned paradt__question_boxes(const paradt__search *s, const double *group) {
    paradt__lane_bounds bounds;
    unsigned mask;
    if (!s->pencil.space.filtered) return 255u;
    mask = s->kernels.group(&s->pencil.q, group, &bounds);
    return s->aim == PARADT__AIM_BEYOND ? paradt__pencil_boxes_beyond(&s->pencil, group, mask) : mask;
}

// Is the point an answer?
static int paradt__question_fits(paradt__search *s, size_t position) {
    PARADT_ASSERT(s->aim != PARADT__AIM_APEX && !s->found);
    paradt__search_point(s, position);
    return s->found;
}

// Returns a point of the set that is an answer, or PARADT__OPEN: there is none.
static paradt_index paradt__question_answer(paradt__search *s) {
    PARADT_ASSERT(s->aim != PARADT__AIM_APEX && !s->found && s->grid);
    paradt__search_from_top(s);
    return s->found ? s->apex : (paradt_index)PARADT__OPEN;
}
#endif // PARADT_NO_REGIONS

#ifndef PARADT_NO_FRONTS
// ---------------------------------------------------------------------------------------------------------------------
// >>first simplex
//
// A cell of T(P) to begin with. MakeFirstSimplex of the thesis takes a point, its nearest neighbour, then again and
// again the point that gives the smallest circumscribing sphere. In floating point, among the points around the first,
// the result is a good guess and no more. Descent on the lifted points makes it certain, as in the simplex method. Let
// z be a location in the guess. While a point q is in conflict with the simplex, q replaces the one vertex that keeps z
// inside, and the lifted simplex above z gets lower. The perturbed heights are in general position, so this does not
// cycle; it ends with the cell of T(P) that contains z. z is the first vertex moved infinitesimally towards the second,
// far less towards the third, and so on. So the cell contains the first vertex, if that is not hidden, and the way from
// there to the second begins in it. Doors: paradt__cell_towards, paradt__cell_pivot.

// Orders the vertices of a simplex that is not flat so that it is positively oriented.
static void paradt__simplex_orient(paradt__search *s, paradt_index *simplex) {
    const double *p[PARADT_MAX_DIM + 1];
    int dim = s->set->space.dim, i;
    for (i = 0; i <= dim; i++) p[i] = paradt__record(s->set, simplex[i]);
    if (paradt__orient(paradt__search_space(s), p) < 0) {
        paradt_index last = simplex[dim];
        simplex[dim] = simplex[dim - 1];
        simplex[dim - 1] = last;
    }
}

// Returns the sign of the orientation of the simplex with x in the place of vertex `place`.
static int paradt__simplex_side(paradt__search *s, const paradt_index *simplex, int place, const double *x) {
    const double *p[PARADT_MAX_DIM + 1];
    int dim = s->set->space.dim, i;
    for (i = 0; i <= dim; i++) p[i] = i == place ? x : paradt__record(s->set, simplex[i]);
    return paradt__orient(paradt__search_space(s), p);
}

// Does the positively oriented simplex contain z (see the section's head)? goal: vertices of the guess, which give z
static int paradt__simplex_has_goal(paradt__search *s, const paradt_index *simplex, const paradt_index *goal) {
    int dim = s->set->space.dim, place, i;
    for (place = 0; place <= dim; place++) {
        int side = 0;
        for (i = 0; i <= dim && !side; i++) {
            side = paradt__simplex_side(s, simplex, place, paradt__record(s->set, goal[i]));
        }
        if (side < 0) return 0;
    }
    return 1;
}

// Puts q in the place of the one vertex of the positively oriented simplex for which it still contains z.
static void paradt__simplex_exchange(paradt__search *s, paradt_index *simplex, const paradt_index *goal,
                                     paradt_index q) {
    int dim = s->set->space.dim, place;
    const double *x = paradt__record(s->set, q);
    for (place = 0; place <= dim; place++) {
        paradt_index trial[PARADT_MAX_DIM + 1];
        if (paradt__simplex_side(s, simplex, place, x) == 0) continue;
        memcpy(trial, simplex, sizeof trial);
        trial[place] = q;
        paradt__simplex_orient(s, trial);
        if (paradt__simplex_has_goal(s, trial, goal)) {
            memcpy(simplex, trial, sizeof trial);
            return;
        }
    }
    PARADT_ASSERT(0);
}

// Finds, among the points [begin, end), the one that gives the smallest circumscribing sphere with the first `count`
// vertices of the simplex; for one vertex, its nearest neighbour. Returns -1 if no point is off their span. rows: an
// orthonormal basis of their span; centre: that of their smallest sphere. The point found is added to both.
static paradt_index paradt__simplex_next_vertex(const paradt__search *s, const paradt_index *simplex, int count,
                                                size_t begin, size_t end, double rows[][PARADT_MAX_DIM],
                                                double *centre) {
    int ambient = s->set->space.ambient, i, j;
    const double *o = paradt__record(s->set, simplex[0]);
    paradt_index best = -1;
    double least = 0.0, best_t = 0.0, best_row[PARADT_MAX_DIM];
    size_t at;
    for (at = begin; at < end; at++) {
        double row[PARADT_MAX_DIM], height, t;
        int known = 0;
        for (i = 0; i < count; i++) known |= simplex[i] == (paradt_index)at;
        if (known) continue;
        t = paradt__centre_shift(o, s->set->records + at * s->set->width, rows, count, ambient, centre, row, &height);
        if (height > 0.0 && (best < 0 || paradt__abs(t) < least)) {
            best = (paradt_index)at;
            least = paradt__abs(t);
            best_t = t;
            memcpy(best_row, row, sizeof row);
        }
    }
    for (j = 0; best >= 0 && j < ambient; j++) {
        rows[count - 1][j] = best_row[j];
        centre[j] += best_t * best_row[j];
    }
    return best;
}

// Guesses the thesis' first simplex from the points near simplex[0]. given: 1, or 2 if simplex[1] is given, too.
// Returns 0 if the guess failed.
static int paradt__simplex_guess(paradt__search *s, paradt_index *simplex, int given) {
    double rows[PARADT_MAX_DIM][PARADT_MAX_DIM], centre[PARADT_MAX_DIM] = {0.0};
    size_t span = PARADT__LANES * PARADT__LANES, begin = (size_t)simplex[0] / span * span, end = begin + span;
    int dim = s->set->space.dim, count;
    if (!s->set->space.filtered) return 0;
    if (end > s->set->count) end = s->set->count;
    for (count = 1; count <= dim; count++) {
        size_t from = count < given ? (size_t)simplex[count] : begin, to = count < given ? from + 1 : end;
        simplex[count] = paradt__simplex_next_vertex(s, simplex, count, from, to, rows, centre);
        if (simplex[count] < 0) return 0;
    }
    return paradt__simplex_side(s, simplex, 0, paradt__record(s->set, simplex[0])) != 0;
}

// Finds the cell of T(P) at simplex[0] on the way to simplex[1] (given = 2), or to any other point (given = 1), and
// leaves it in `simplex`, positively oriented. The cell does not contain simplex[0] just when that point is hidden.
static void paradt__cell_towards(paradt__search *s, paradt_index *simplex, int given) {
    paradt_index goal[PARADT_MAX_DIM + 1], q;
    PARADT_ASSERT(given == 1 || (given == 2 && simplex[0] != simplex[1]));
    if (!paradt__simplex_guess(s, simplex, given))
        paradt__set_basis(s->set, NULL, given, simplex, NULL, &paradt__search_space(s)->counters, NULL);
    memcpy(goal, simplex, sizeof goal);
    paradt__simplex_orient(s, simplex);
    while ((q = paradt__search_conflict(s, simplex)) >= 0) paradt__simplex_exchange(s, simplex, goal, q);
}

// Replaces the cell of T(P) by its neighbour across a facet that has x outside: one step of a visibility walk, by a
// search. Returns 0 if there is no such facet or no neighbour. Such walks end in every regular triangulation
// (Edelsbrunner, Combinatorica 10, 1990).
static int paradt__cell_pivot(paradt__search *s, paradt_index *cell, const double *x) {
    int dim = s->set->space.dim, place, unused;
    for (place = 0; place <= dim; place++) {
        if (paradt__simplex_side(s, cell, place, x) < 0) {
            paradt_index made[PARADT_MAX_DIM + 1];
            if (paradt__search_apex(s, cell, place, made, &unused) < 0) return 0;
            memcpy(cell, made, sizeof made);
            return 1;
        }
    }
    return 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>reach
//
// Which cells a region of InCoDe or DeWall makes, and which of these cells it owns. (Regions of insertion have another
// rule, see >>fringe.)
//
// Reach. The edge from v to w leads away if w is farther than v from the cut nearest to v (farther along the cut's
// axis; where both are equally far, if w is lexicographically larger). A region reaches a cell if an edge of the cell
// leads away from one of the region's points, and needs a facet if an edge of the facet does. A needed facet is worked
// on. Any other facet is only entered, so that two cells get linked when both have been made.
//
// Why a region finds every cell that it reaches: consider the neighbours w of v to which edges lead away. In the vertex
// figure of the lifted hull at v they are the vertices on one side of a plane, so edges among themselves connect them
// (Balinski's argument). From one such edge (v, w) the work on needed facets therefore gets around the ends of all the
// others, and to all cells around these edges. A vertex of the region from which no edge of a cell has led away gets a
// cell of its own to start from, a seed.
//
// Ownership. Of the regions that reach a cell the one with most of its vertices owns the cell; of several the first
// does. A region reaches every cell in which it has two vertices u and v, for one of the edges between them leads away:
// let u be nearer to its nearest cut than v to its own, or equally near and the cut of u not the later one. Then v is
// farther from the cut of u than u is. If the rounded distances are equal, that cut is nearest to v, too, and of two
// points one is always the farther from a cut. So few cells are made by several regions: those across a cut with two
// vertices on either side, and some cells that cross another cut than the one nearest to a vertex.
//
// Cells that no region reaches. There are a few, where boxes meet at an edge or a corner. They form clusters, whose
// cells are connected by facets in which no edge leads away. If a cell has such a facet, the region that owns the cell
// looks behind the facet, its gate. If a cluster is there, the region makes all of the cluster and the cells next to
// it. So every owner of a cell next to a cluster knows all cells next to it, and the first of these owners owns the
// cluster. If a cluster has no cell next to it, it is all of T(P): every region makes it, as each begins with a cell,
// and the first region that has points owns it.
//
// Vertices are positions in the set.
// Doors: paradt__edge_leads_away, paradt__leads_away, paradt__needs, paradt__cell_owner.

// What a front knows of its region and of the others
typedef struct paradt__region_view {
    const uint32_t *owner; // [set.count] region of each point; NULL: space is undivided
    const paradt__cuts *cuts;
    uint32_t region;
} paradt__region_view;

// Does the edge from one point to another lead away? cut: the one nearest to `from`; NULL: there is none
static int paradt__edge_leads_away(const paradt__space *space, const paradt__cut *cut, const double *from,
                                   const double *to) {
    if (cut) {
        int64_t x = paradt__ordered_bits(from[cut->axis]), y = paradt__ordered_bits(to[cut->axis]);
        if (x != y) return (y < x) == paradt__cut_is_above(cut, from);
    }
    return paradt__compare(space, to, from) > 0;
}

// Does any edge of the simplex lead away from its vertex `place`? count: vertices of the simplex
static int paradt__leads_away(const paradt__region_view *view, const paradt__set *set, const paradt_index *simplex,
                              int count, int place) {
    const double *x = paradt__record(set, simplex[place]);
    const paradt__cut *cut = paradt__cuts_nearest(view->cuts, x);
    int i;
    for (i = 0; i < count; i++) {
        const double *to = paradt__record(set, simplex[i]);
        if (i != place && paradt__edge_leads_away(&set->space, cut, x, to)) return 1;
    }
    return 0;
}

// Does the region need the facet? Two points of the region always have an edge that leads away.
static int paradt__needs(const paradt__region_view *view, const paradt__set *set, const paradt_index *facet,
                         int count) {
    int i, inside = 0, only = 0;
    if (!view->owner) return 1;
    for (i = 0; i < count; i++) {
        if (view->owner[facet[i]] == view->region) inside++, only = i;
    }
    if (inside != 1) return inside != 0;
    return paradt__leads_away(view, set, facet, count, only);
}

// Returns the owner of a cell or facet: of the regions that reach it, the one with most of its vertices, of several the
// first; or PARADT__OPEN if no region reaches it.
static paradt_index paradt__cell_owner(const paradt__region_view *view, const paradt__set *set,
                                       const paradt_index *simplex, int count) {
    paradt_index owner = PARADT__OPEN;
    int most = 0, i, j;
    PARADT_ASSERT(view->owner);
    for (i = 0; i < count; i++) {
        paradt_index region = (paradt_index)view->owner[simplex[i]];
        int inside = 0;
        for (j = 0; j < count; j++) inside += view->owner[simplex[j]] == view->owner[simplex[i]];
        if (inside > count / 2 && inside > 1) return region;
        if (inside < most || (inside == most && region >= owner)) continue;
        if (inside == 1 && !paradt__leads_away(view, set, simplex, count, i)) continue;
        owner = region;
        most = inside;
    }
    return owner;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>front
//
// What InCoDe and DeWall, which build facet by facet, have in common: a mesh that is not closed; its active facets,
// those whose other cell is not known yet (the thesis' active face list, AFL); the search for the cell across an active
// facet; and the region for which cells are made. A cell is never changed once it is made. Vertices are positions in
// the set.
//
// What holds between two cells: every facet whose link is PARADT__OPEN stands once in one of two tables. `active` has
// the AFL; `unneeded` has those that the region does not need (see >>reach) and is used with regions only.
//
// A vertex with no active facet has all its cells and can't be an apex any more: it is finished. InCoDe counts the
// active facets at each vertex and takes grid cells and groups of them out of the search once all their points are
// finished. So the search need not look behind the front.
//
// A method with an order of its own keeps active facets in work lists, linked lists of handles. A facet that is tied
// while it is in a list stays there, and is passed over when it comes up.
// Doors: paradt__front_begin, paradt__front_end, paradt__front_add, paradt__front_expand, paradt__front_next_seed,
// paradt__front_seed, paradt__front_take, paradt__front_is_stuck, paradt__finished_begin, paradt__list_push,
// paradt__list_pop.

typedef struct paradt__node {
    paradt_index handle, next; // next: PARADT__OPEN at the end
} paradt__node;

// The pool from which all work lists take their nodes. A list is the index of its first node; PARADT__OPEN: empty.
typedef struct paradt__lists {
    paradt__node *nodes;
    size_t capacity;
    paradt_index fresh, spare; // the first node never used; the list of nodes given back
} paradt__lists;

static void paradt__lists_free(paradt__lists *lists, paradt__memory *memory) {
    paradt__release(memory, lists->nodes);
    memset(lists, 0, sizeof *lists);
}

// Puts a handle at the head of a list.
static paradt_status paradt__list_push(paradt__lists *lists, paradt_index *head, paradt_index handle,
                                       paradt__memory *memory) {
    paradt_index node = lists->spare;
    if (node >= 0 && lists->capacity) {
        lists->spare = lists->nodes[node].next;
    } else {
        if ((size_t)lists->fresh == lists->capacity) {
            void *nodes = lists->nodes;
            size_t capacity = lists->capacity ? lists->capacity * 2 : 256;
            if (!paradt__grow(memory, &nodes, lists->capacity, capacity, sizeof(paradt__node)))
                return PARADT_ERROR_MEMORY;
            if (!lists->capacity) lists->spare = PARADT__OPEN;
            lists->nodes = (paradt__node *)nodes;
            lists->capacity = capacity;
        }
        node = lists->fresh++;
    }
    lists->nodes[node].handle = handle;
    lists->nodes[node].next = *head;
    *head = node;
    return PARADT_OK;
}

// Takes the first handle out of a list that is not empty.
static paradt_index paradt__list_pop(paradt__lists *lists, paradt_index *head) {
    paradt_index node = *head, handle = lists->nodes[node].handle;
    PARADT_ASSERT(node < lists->fresh);
    *head = lists->nodes[node].next;
    lists->nodes[node].next = lists->spare;
    lists->spare = node;
    return handle;
}

// Which vertices may still get cells
typedef struct paradt__finished {
    uint32_t *incident;                 // [set.count] active facets at each vertex; NULL: not counted
    uint8_t *unfinished;                // [grid.cell_count] number of unfinished points in each grid cell
    uint8_t *alive[PARADT__MAX_LEVELS]; // [level][group] a bit for each box that has unfinished points
} paradt__finished;

typedef struct paradt__front {
    const paradt__set *set;
    const paradt__grid *grid;
    paradt__memory *memory;
    paradt__search search;
    paradt__mesh mesh;       // without ghosts
    paradt__facets active;   // the AFL: facets to be worked on
    paradt__facets unneeded; // with regions: open facets that the region does not need
    paradt__lists lists;
    paradt__region_view view;
    paradt__progress progress;
    double expected;          // number of cells, for the progress
    int impatient;            // 1: give up where the filters decide too little; see paradt__front_is_stuck
    uint64_t seed_predicates; // predicates evaluated to find seeds: they say nothing about the region's cells
    uint64_t hull_facets;
    paradt__finished finished;
    uint64_t *seeded;   // with regions: a bit for each vertex from which an edge of a cell leads away; needs no seed
    paradt_index gates; // with regions: list of facets to look behind
    size_t next_seed;   // no position before this one needs a seed
} paradt__front;

static void paradt__finished_free(paradt__finished *finished, paradt__memory *memory) {
    int level;
    paradt__release(memory, finished->incident);
    paradt__release(memory, finished->unfinished);
    for (level = 0; level < PARADT__MAX_LEVELS; level++) paradt__release(memory, finished->alive[level]);
    memset(finished, 0, sizeof *finished);
}

// Begins with no vertex finished. After an error paradt__finished_free frees what there is.
static paradt_status paradt__finished_begin(paradt__finished *finished, const paradt__set *set,
                                            const paradt__grid *grid, paradt__memory *memory) {
    size_t i;
    int level;
    finished->incident = (uint32_t *)paradt__alloc(memory, set->count, sizeof(uint32_t));
    finished->unfinished = (uint8_t *)paradt__alloc(memory, grid->cell_count, 1);
    if (!finished->incident || !finished->unfinished) return PARADT_ERROR_MEMORY;
    memset(finished->incident, 0, set->count * sizeof(uint32_t));
    memset(finished->unfinished, PARADT__LANES, grid->cell_count);
    finished->unfinished[grid->cell_count - 1] = (uint8_t)(set->count - (grid->cell_count - 1) * PARADT__LANES);
    for (level = 0; level < grid->levels; level++) {
        size_t boxes = grid->box_count[level], groups = (boxes + PARADT__LANES - 1) / PARADT__LANES;
        finished->alive[level] = (uint8_t *)paradt__alloc(memory, groups, 1);
        if (!finished->alive[level]) return PARADT_ERROR_MEMORY;
        for (i = 0; i < groups; i++) {
            size_t count = boxes - i * PARADT__LANES;
            finished->alive[level][i] = (uint8_t)(count < PARADT__LANES ? (1u << count) - 1 : 255u);
        }
    }
    return PARADT_OK;
}

// Adds `change` to the number of active facets at a vertex. When the number becomes 0 the vertex is finished.
PARADT__INLINE void paradt__finished_count(paradt__finished *finished, const paradt__grid *grid, paradt_index vertex,
                                           int change) {
    size_t box = (size_t)vertex / PARADT__LANES;
    int level;
    finished->incident[vertex] += (uint32_t)change;
    if (PARADT__LIKELY(finished->incident[vertex]) || --finished->unfinished[box]) return;
    for (level = 0; level < grid->levels; level++, box /= PARADT__LANES) {
        uint8_t *alive = finished->alive[level] + box / PARADT__LANES;
        *alive = (uint8_t)(*alive & ~(1u << box % PARADT__LANES));
        if (*alive) return;
    }
}

// Frees all but the mesh.
static void paradt__front_end(paradt__front *front) {
    paradt__facets_free(&front->active, front->memory);
    paradt__facets_free(&front->unneeded, front->memory);
    paradt__lists_free(&front->lists, front->memory);
    paradt__finished_free(&front->finished, front->memory);
    paradt__release(front->memory, front->seeded);
    front->seeded = NULL;
}

// Makes room for the expected number of cells; if that is refused, for some: weighted points may have far fewer cells.
static paradt_status paradt__front_room(paradt__front *front) {
    const size_t some = 1 << 16, most = paradt__most_cells(front->mesh.corners);
    double expected = front->expected * 1.01 + 64.0;
    size_t cells = expected < (double)most ? (size_t)expected : most;
    paradt_status status = paradt__mesh_reserve(&front->mesh, 1, cells, front->memory);
    if (!status || cells <= some) return status;
    paradt__release(front->memory, front->mesh.vertices); // the one array that may be there
    front->mesh.vertices = NULL;
    return paradt__mesh_reserve(&front->mesh, 1, some, front->memory);
}

// Begins a front without cells. part: fraction of the set's points for which the front makes cells. After an error
// paradt__front_end is called as well.
PARADT__COLD paradt_status paradt__front_begin(paradt__front *front, const paradt__set *set, const paradt__grid *grid,
                                               paradt__memory *memory, paradt__region_view view, double part) {
    double points = (double)set->count * part;
    memset(front, 0, sizeof *front);
    front->set = set;
    front->grid = grid;
    front->memory = memory;
    front->view = view;
    front->gates = PARADT__OPEN;
    paradt__mesh_begin(&front->mesh, set->space.dim + 1, 0);
    front->expected = points * paradt__cells_a_point(set->space.dim) * paradt__off_hull(points, set->space.dim) + 16.0;
    paradt__search_begin(&front->search, set, grid);
    if (view.owner) {
        size_t words = set->count / 64 + 1;
        front->seeded = (uint64_t *)paradt__alloc(memory, words, sizeof(uint64_t));
        if (!front->seeded || paradt__facets_begin(&front->unneeded, 0, 0, memory)) return PARADT_ERROR_MEMORY;
        memset(front->seeded, 0, words * sizeof(uint64_t));
    }
    if (paradt__facets_begin(&front->active, (size_t)points, 0, memory)) return PARADT_ERROR_MEMORY;
    return paradt__front_room(front);
}

// Notes the vertices of the region from which an edge of a new cell leads away: they need no seed.
static void paradt__front_note_seeded(paradt__front *front, const paradt_index *cell) {
    int corners = front->mesh.corners, i;
    for (i = 0; i < corners; i++) {
        uint64_t *word = front->seeded + cell[i] / 64, bit = (uint64_t)1 << cell[i] % 64;
        if (front->view.owner[cell[i]] != front->view.region || *word & bit) continue;
        if (paradt__leads_away(&front->view, front->set, cell, corners, i)) *word |= bit;
    }
}

// Called for each facet that becomes active, to put it into a work list. NULL: there are no lists.
typedef paradt_status (*paradt__activate)(paradt__front *front, void *method, paradt_index handle);

// Fills the keys of a cell's facets and the active facets' chains for them, and prefetches what these begin with.
PARADT__INLINE void paradt__front_keys(const paradt__facets *active, const paradt_index *cell, int corners,
                                       paradt__facet_key *key, paradt_index **chain) {
    uint64_t sum = paradt__cell_sum(cell, corners);
    int i;
    for (i = 0; i < corners; i++) {
        key[i].key = paradt__facet_hash(sum - paradt__vertex_key(cell[i]));
        key[i].smallest = paradt__smallest_but(cell, corners, i);
        chain[i] = paradt__facets_chain(active, key[i]);
        PARADT__PREFETCH(chain[i]);
    }
    for (i = 0; i < corners; i++) PARADT__PREFETCH(active->entries + (*chain[i] < 0 ? 0 : *chain[i]));
}

// Stores a cell and updates the AFL: facets of the cell that were active are tied and leave, the others enter. from:
// the facet across which the cell was found, which has left the AFL, as a handle in the older cell; across: which
// vertex of the new cell is opposite that facet. For a seed: PARADT__OPEN and -1.
PARADT__INLINE paradt_status paradt__front_store(paradt__front *front, const paradt_index *cell, int across,
                                                 paradt_index from, paradt__activate activate, void *method,
                                                 int corners) {
    paradt__mesh *mesh = &front->mesh;
    paradt_index base = (paradt_index)mesh->count * corners;
    paradt_status status = PARADT_OK;
    int i, change[PARADT_MAX_DIM + 1], sum_of_changes = 0;
    paradt__facet_key key[PARADT_MAX_DIM + 1];
    paradt_index *chain[PARADT_MAX_DIM + 1], facet[PARADT_MAX_DIM];
    paradt__facets *table = &front->active;
    PARADT_ASSERT(mesh->count < mesh->capacity && (across < 0) == (from < 0));
    for (i = 0; i < corners; i++) mesh->vertices[base + i] = cell[i];
    paradt__front_keys(table, cell, corners, key, chain);
    for (i = 0; i < corners && !status; i++) {
        paradt_index mirror = from;
        if (i != across) {
            if (front->view.owner) {
                paradt__facet_without(cell, corners, i, facet);
                table = paradt__needs(&front->view, front->set, facet, corners - 1) ? &front->active : &front->unneeded;
                chain[i] = paradt__facets_chain(table, key[i]);
            }
            mirror = paradt__facets_match(table, mesh, chain[i], key[i], base + i, corners);
        }
        mesh->links[base + i] = mirror < 0 ? (paradt_index)PARADT__OPEN : mirror;
        change[i] = mirror < 0 ? 1 : -1;
        sum_of_changes += change[i];
        if (mirror >= 0) {
            mesh->links[mirror] = base + i;
        } else if (activate && table == &front->active) {
            status = activate(front, method, base + i);
        }
    }
    for (i = 0; i < corners && front->finished.incident && !status; i++) {
        paradt__finished_count(&front->finished, front->grid, cell[i], sum_of_changes - change[i]);
    }
    mesh->count++;
    return status;
}

// Lists the gates of the newest cell, if it is up to this region to look behind them: the facets behind which there may
// be a cell that no region reaches. The vertices of such a cell are all of different regions.
static paradt_status paradt__front_list_gates(paradt__front *front) {
    const paradt__mesh *mesh = &front->mesh;
    int corners = mesh->corners, foreign = 0, i;
    size_t base = (mesh->count - 1) * (size_t)corners;
    const paradt_index *cell = mesh->vertices + base;
    paradt_index facet[PARADT_MAX_DIM], owner;
    paradt_status status = PARADT_OK;
    for (i = 0; i < corners; i++) foreign += front->view.owner[cell[i]] != front->view.region;
    if (foreign < corners - 2 || front->view.cuts->boxes < (size_t)corners) return PARADT_OK;
    owner = paradt__cell_owner(&front->view, front->set, cell, corners);
    if (owner >= 0 && owner != (paradt_index)front->view.region) return PARADT_OK;
    for (i = 0; i < corners && !status; i++) {
        if (mesh->links[base + (size_t)i] != PARADT__OPEN) continue;
        paradt__facet_without(cell, corners, i, facet);
        if (paradt__cell_owner(&front->view, front->set, facet, corners - 1) < 0)
            status = paradt__list_push(&front->lists, &front->gates, (paradt_index)base + i, front->memory);
    }
    return status;
}

// Adds a cell; the parameters are those of paradt__front_store.
static paradt_status paradt__front_add(paradt__front *front, const paradt_index *cell, int across, paradt_index from,
                                       paradt__activate activate, void *method) {
    paradt_status status = paradt__mesh_room(&front->mesh, front->memory);
    if (!status) status = paradt__facets_room(&front->active, PARADT_MAX_DIM + 1, front->memory);
    if (!status && front->view.owner) status = paradt__facets_room(&front->unneeded, PARADT_MAX_DIM + 1, front->memory);
    if (status) return status;
    if (front->seeded) paradt__front_note_seeded(front, cell);
    if (front->mesh.corners == 4) status = paradt__front_store(front, cell, across, from, activate, method, 4);
    else status = paradt__front_store(front, cell, across, from, activate, method, front->mesh.corners);
    if (!status && front->view.owner) status = paradt__front_list_gates(front);
    if (!status && front->mesh.count % PARADT__REPORT_STEP == 0) {
        double done = (double)front->mesh.count / front->expected;
        if (paradt__progress_cancels(&front->progress, done)) status = PARADT_ERROR_CANCELLED;
    }
    return status;
}

// The thesis' MakeSimplex. Searches for the cell across a facet that has just been taken out of the AFL and adds the
// cell; if there is none the facet is one of the hull's.
static paradt_status paradt__front_expand(paradt__front *front, paradt_index handle, paradt__activate activate,
                                          void *method) {
    int corners = front->mesh.corners, opposite = (int)(handle % corners), place;
    const paradt_index *cell = front->mesh.vertices + (handle - opposite);
    paradt_index made[PARADT_MAX_DIM + 1];
    PARADT_ASSERT(front->mesh.links[handle] == PARADT__OPEN);
    if (paradt__search_apex(&front->search, cell, opposite, made, &place) >= 0) {
        return paradt__front_add(front, made, place, handle, activate, method);
    }
    front->hull_facets++;
    front->mesh.links[handle] = PARADT__HULL;
    for (place = 0; place < corners && front->finished.incident; place++) {
        if (place != opposite) paradt__finished_count(&front->finished, front->grid, cell[place], -1);
    }
    return PARADT_OK;
}

// Takes a facet that came from a work list out of the AFL. Returns 0 if it was not active any more.
static int paradt__front_take(paradt__front *front, paradt_index handle) {
    if (front->mesh.links[handle] != PARADT__OPEN) return 0;
    paradt__facets_remove(&front->active, paradt__facet_key_of(&front->active, &front->mesh, handle), handle);
    return 1;
}

// Finds a cell behind a gate that is in a cluster or next to one. Returns 0 if there is none.
static int paradt__front_seed_behind_gate(paradt__front *front, paradt_index *cell) {
    int corners = front->mesh.corners, unused;
    while (front->gates >= 0) {
        paradt_index handle = paradt__list_pop(&front->lists, &front->gates);
        const paradt_index *from = front->mesh.vertices + handle / corners * corners;
        if (front->mesh.links[handle] != PARADT__OPEN) continue;
        if (paradt__search_apex(&front->search, from, (int)(handle % corners), cell, &unused) < 0) continue;
        if (paradt__cell_owner(&front->view, front->set, cell, corners) < 0 ||
            paradt__cell_owner(&front->view, front->set, from, corners) < 0)
            return 1;
    }
    return 0;
}

// Finds a cell with an edge that leads away from the vertex; for the region's first cell any cell at the vertex will
// do. Returns 0 if there is none.
static int paradt__front_seed_at(paradt__front *front, size_t vertex, paradt_index *cell) {
    const paradt__set *set = front->set;
    const double *x = set->records + vertex * set->width;
    const paradt__cut *cut = paradt__cuts_nearest(front->view.cuts, x);
    size_t step, other = 0;
    int i;
    for (step = 1; step < set->count; step++) {
        other = (vertex + step) % set->count;
        if (paradt__edge_leads_away(&set->space, cut, x, set->records + other * set->width)) break;
    }
    if (step == set->count && front->mesh.count) return 0;
    cell[0] = (paradt_index)vertex;
    cell[1] = (paradt_index)other;
    paradt__cell_towards(&front->search, cell, 2);
    for (i = 0; i < front->mesh.corners; i++) {
        if (cell[i] == (paradt_index)vertex) return 1;
    }
    return 0;
}

// Finds the next seed: a cell behind a gate or at a vertex of the region that still needs a seed; without regions any
// one cell. Returns 0 if no seed is left.
static int paradt__front_seed(paradt__front *front, paradt_index *cell) {
    const paradt__set *set = front->set;
    if (!front->view.owner) {
        cell[0] = (paradt_index)(set->count / 2);
        if (front->next_seed++) return 0;
        paradt__cell_towards(&front->search, cell, 1);
        return 1;
    }
    if (paradt__front_seed_behind_gate(front, cell)) return 1;
    while (front->next_seed < set->count) {
        size_t at = front->next_seed++;
        if (front->view.owner[at] != front->view.region || front->seeded[at / 64] >> at % 64 & 1) continue;
        if (paradt__front_seed_at(front, at, cell)) return 1;
    }
    return 0;
}

enum {
    PARADT__PATIENCE = 4,         // predicates a cell that an impatient front puts up with,
    PARADT__FIRST_PATIENCE = 2000 // and predicates in addition, as the first cells take more
};

// Number of predicates that the searches have evaluated so far
static uint64_t paradt__front_predicates(const paradt__front *front) {
    const paradt__counters *c = paradt__search_counters(&front->search);
    return c->orient_calls + c->insphere_calls;
}

// Do the searches take so many predicates that insertion would be faster? Where many points are on one sphere, as in a
// lattice, a search has to compare all of them with each other, exactly. Among points in general position hardly any
// cell takes a predicate.
static int paradt__front_is_stuck(const paradt__front *front) {
    uint64_t patience = PARADT__PATIENCE * (uint64_t)front->mesh.count + PARADT__FIRST_PATIENCE;
    return paradt__front_predicates(front) - front->seed_predicates > patience;
}

// Finds the next seed as paradt__front_seed does, and counts the predicates that this takes.
static int paradt__front_next_seed(paradt__front *front, paradt_index *cell) {
    uint64_t before = paradt__front_predicates(front);
    int found = paradt__front_seed(front, cell);
    front->seed_predicates += paradt__front_predicates(front) - before;
    return found;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>incode
//
// InCoDe, incremental construction (Cignoni, Montani, Scopigno, "DeWall: a fast divide and conquer Delaunay
// triangulation algorithm in E^d", CAD 1998; thesis, chapter 2). Begins with one cell and adds the cell across each
// active facet until no facet is active. Facets at the lowest vertices in grid order come first, so that the front
// sweeps over the grid and what it works on stays in the cache.
// Doors: paradt__incode.

// Makes all cells of the front, or returns PARADT__GAVE_UP if the front is impatient and stuck.
static paradt_status paradt__incode(paradt__front *front) {
    paradt_status status = PARADT_OK;
    paradt_index cell[PARADT_MAX_DIM + 1];
    if (!front->view.owner) {
        status = paradt__finished_begin(&front->finished, front->set, front->grid, front->memory);
        paradt__search_skip_finished(&front->search, front->finished.alive);
    }
    while (!status && paradt__front_next_seed(front, cell)) {
        paradt_index handle = PARADT__OPEN;
        status = paradt__front_add(front, cell, -1, PARADT__OPEN, NULL, NULL);
        while (!status && (handle = paradt__facets_first(&front->active)) >= 0) {
            status = paradt__front_expand(front, handle, NULL, NULL);
            if (!status && front->impatient && paradt__front_is_stuck(front)) return PARADT__GAVE_UP;
        }
    }
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>dewall
//
// DeWall, divide and conquer with the merging first (Cignoni, Montani, Scopigno, CAD 1998; thesis, chapter 3). A plane
// alpha halves the points. First all cells that cross it are made, the wall, with MakeSimplex on the active facets that
// cross it (AFL alpha). Then the cells on its two sides are independent of each other. They are made by recursion from
// the active facets that the wall has left on either side (AFL 1 and AFL 2).
//
// The planes are those of the grid. So a half is a range of positions, and MakeSimplex searches that range only: all
// cells with a vertex outside of it are in walls made before.
//
// If no active facet crosses alpha, either no cell of the range crosses alpha or no such cell has been made: a facet
// between a cell of the range that crosses alpha and a cell of another wall would be active and cross alpha. Any cell
// of T(P) that crosses alpha tells which is the case; one is found by a walk from one side to the other.
//
// A region need not make all of a wall. Then facets may lead out of a range, and go back to the caller. Vertices are
// positions in the set.
// Doors: paradt__dewall.

enum { PARADT__WALL_SMALL = 64 }; // so few points are not divided further

// A range of positions, the plane that divides it, and work lists of active facets
typedef struct paradt__wall {
    size_t begin, cut, end;       // positions in [begin, cut) are on the plane's one side, [cut, end) on its other
    paradt_index alpha, one, two; // facets that cross the plane, are in [begin, cut), are in [cut, end)
    paradt_index outside;         // facets with a vertex outside of [begin, end)
} paradt__wall;

// Puts an active facet into the wall's list for it. method: the wall
static paradt_status paradt__wall_activate(paradt__front *front, void *method, paradt_index handle) {
    paradt__wall *wall = (paradt__wall *)method;
    size_t low = SIZE_MAX, high = 0;
    paradt_index *head = &wall->alpha;
    int corners = front->mesh.corners, opposite = (int)(handle % corners), i;
    const paradt_index *cell = front->mesh.vertices + (handle - opposite);
    for (i = 0; i < corners; i++) {
        size_t at = (size_t)cell[i];
        if (i == opposite) continue;
        low = at < low ? at : low;
        high = at > high ? at : high;
    }
    if (low < wall->begin || high >= wall->end) head = &wall->outside;
    else if (high < wall->cut) head = &wall->one;
    else if (low >= wall->cut) head = &wall->two;
    return paradt__list_push(&front->lists, head, handle, front->memory);
}

// Moves the facets of a list to the wall's lists.
static paradt_status paradt__wall_distribute(paradt__front *front, paradt__wall *wall, paradt_index *head) {
    paradt_status status = PARADT_OK;
    while (*head >= 0 && !status) status = paradt__wall_activate(front, wall, paradt__list_pop(&front->lists, head));
    return status;
}

// Expands the facets of one of the wall's lists until the list is empty.
static paradt_status paradt__wall_expand(paradt__front *front, paradt__wall *wall, paradt_index *head) {
    paradt_status status = PARADT_OK;
    while (*head >= 0 && !status) {
        paradt_index handle = paradt__list_pop(&front->lists, head);
        if (paradt__front_take(front, handle)) {
            status = paradt__front_expand(front, handle, paradt__wall_activate, wall);
        }
    }
    return status;
}

// Finds a cell of the range that crosses the plane, where no active facet does. Returns 0 if there is none.
static int paradt__wall_seed(paradt__front *front, const paradt__wall *wall, paradt_index *cell) {
    const paradt__set *set = front->set;
    const paradt__space *space = &set->space;
    int axis = paradt__grid_axis(set, wall->begin, wall->end), dim = space->dim, i;
    size_t at, left = wall->begin, right = wall->cut;
    const double *p, *q;
    for (at = wall->begin; at < wall->cut; at++) {
        if (paradt__before(space, set->records + left * set->width, set->records + at * set->width, axis)) left = at;
    }
    for (at = wall->cut; at < wall->end; at++) {
        if (paradt__before(space, set->records + at * set->width, set->records + right * set->width, axis)) right = at;
    }
    p = set->records + left * set->width;
    q = set->records + right * set->width;
    cell[0] = (paradt_index)left;
    cell[1] = (paradt_index)right;
    paradt__search_limit(&front->search, 0, set->count);
    paradt__cell_towards(&front->search, cell, 2);
    do {
        int behind = 0, within = 0;
        for (i = 0; i <= dim; i++) {
            behind += paradt__before(space, p, paradt__record(set, cell[i]), axis);
            within += (size_t)cell[i] >= wall->begin && (size_t)cell[i] < wall->end;
        }
        if (behind > 0 && behind <= dim) return within == dim + 1;
    } while (paradt__cell_pivot(&front->search, cell, q));
    return 0;
}

// Makes the cells of the positions [begin, end). head: list of active facets in the range, emptied; outside: list to
// which facets that lead out of the range are added. The recursion is as deep as the logarithm of the number of points.
PARADT__COLD paradt_status paradt__wall_build(paradt__front *front, size_t begin, size_t end, paradt_index *head,
                                              paradt_index *outside) {
    paradt__wall wall;
    paradt_status status;
    wall.begin = begin;
    wall.end = wall.cut = end;
    wall.alpha = wall.one = wall.two = PARADT__OPEN;
    wall.outside = *outside;
    if (end - begin > PARADT__WALL_SMALL) wall.cut = paradt__grid_cut(begin, end);
    PARADT_ASSERT(begin < wall.cut && wall.cut <= end);
    status = paradt__wall_distribute(front, &wall, head);
    if (!status && wall.alpha < 0 && wall.cut < end && !front->view.owner && (wall.one >= 0 || wall.two >= 0)) {
        paradt_index cell[PARADT_MAX_DIM + 1];
        if (paradt__wall_seed(front, &wall, cell)) {
            status = paradt__front_add(front, cell, -1, PARADT__OPEN, paradt__wall_activate, &wall);
        }
    }
    while (!status && (wall.alpha >= 0 || wall.one >= 0 || wall.two >= 0)) {
        paradt_index back = PARADT__OPEN;
        if (!front->view.owner) paradt__search_limit(&front->search, begin, end);
        status = paradt__wall_expand(front, &wall, &wall.alpha);
        if (!status && wall.cut == end) status = paradt__wall_expand(front, &wall, &wall.one);
        if (!status && wall.one >= 0) status = paradt__wall_build(front, begin, wall.cut, &wall.one, &back);
        if (!status && wall.two >= 0) status = paradt__wall_build(front, wall.cut, end, &wall.two, &back);
        if (!status) status = paradt__wall_distribute(front, &wall, &back);
    }
    *outside = wall.outside;
    return status;
}

// Makes all cells of the front. On a line facets are points and cross no plane, so there is no wall: InCoDe does it.
static paradt_status paradt__dewall(paradt__front *front) {
    paradt_index cell[PARADT_MAX_DIM + 1];
    size_t count = front->set->count;
    paradt_status status = PARADT_OK;
    if (front->set->space.dim == 1) return paradt__incode(front);
    while (!status && paradt__front_seed(front, cell)) {
        paradt_index outside = PARADT__OPEN;
        paradt__wall wall = {0, 0, 0, PARADT__OPEN, PARADT__OPEN, PARADT__OPEN, PARADT__OPEN};
        wall.cut = wall.end = count;
        status = paradt__front_add(front, cell, -1, PARADT__OPEN, paradt__wall_activate, &wall);
        if (!status) status = paradt__wall_build(front, 0, count, &wall.one, &outside);
    }
    return status;
}
#endif // PARADT_NO_FRONTS

// ---------------------------------------------------------------------------------------------------------------------
// >>order of insertion
//
// The order in which points are inserted; it matters for speed only. Points are inserted in rounds, each 16 times as
// large as the one before, and within a round along Hilbert's curve (Amenta, Choi and Rote, "Incremental constructions
// con BRIO", SoCG 2003). The rounds are dealt like cards: of each group of 16 neighbours along the curve one, drawn by
// a hash of the group's number, goes to an earlier round than the last. Of the points drawn from 16 neighbouring groups
// one goes to a still earlier round, and so on. So a round's points are spread more evenly than by chance.
// Doors: paradt__round_order, paradt__merged_order, paradt__late_order.

enum {
    PARADT__ROUND_SHIFT = 4,  // a round is 2^4 times as large as the one before
    PARADT__FIRST_ROUND = 16, // the first round has at least so many points
    PARADT__MOST_ROUNDS = 15  // after the first
};

// Returns the number of rounds after the first for `count` points.
static int paradt__round_count(size_t count) {
    int rounds = 0;
    while (rounds < PARADT__MOST_ROUNDS && count >> ((rounds + 1) * PARADT__ROUND_SHIFT) >= PARADT__FIRST_ROUND)
        rounds++;
    return rounds;
}

// Draws the one of a group's 16 members that goes to an earlier round, and returns its number. level: what the members
// are: 0: points, 1: groups of points, 2: groups of these, and so on
PARADT__INLINE size_t paradt__earlier_one(size_t group, int level) {
    uint64_t draw = paradt__mix((uint64_t)group + ((uint64_t)level << 58) + 1);
    return (group << PARADT__ROUND_SHIFT) + (size_t)(draw >> 32 & ((1u << PARADT__ROUND_SHIFT) - 1));
}

// Returns the round of the point drawn from a group of points, 0 to rounds - 1.
static int paradt__earlier_round(size_t group, int rounds) {
    int level = 1;
    for (; level < rounds && paradt__earlier_one(group >> PARADT__ROUND_SHIFT, level) == group; level++)
        group >>= PARADT__ROUND_SHIFT;
    return rounds - level;
}

// Points that come along the curve, dealt to rounds
typedef struct paradt__rounds {
    paradt_index *order;                 // [count] round after round
    int rounds;                          // after the first
    size_t end[PARADT__MOST_ROUNDS + 1]; // where in `order` each round's next point goes
    size_t next, earlier; // numbers along the curve: of the next point, and of the one drawn in its group
} paradt__rounds;

// Allocates the order, and finds where each round begins in it.
static paradt_status paradt__rounds_begin(paradt__rounds *r, size_t count, paradt__memory *memory) {
    size_t group, groups = 0, before = 0;
    int round;
    memset(r, 0, sizeof *r);
    r->order = (paradt_index *)paradt__alloc_filled(memory, count, sizeof *r->order);
    if (!r->order) return PARADT_ERROR_MEMORY;
    r->rounds = paradt__round_count(count);
    for (group = 0; r->rounds && group << PARADT__ROUND_SHIFT < count; group++) {
        if (paradt__earlier_one(group, 0) < count) r->end[paradt__earlier_round(group, r->rounds)]++, groups++;
    }
    for (round = 0; round < r->rounds; round++) {
        size_t size = r->end[round];
        r->end[round] = before;
        before += size;
    }
    r->end[r->rounds] = groups;
    return PARADT_OK;
}

// Deals the next point along the curve.
PARADT__INLINE void paradt__rounds_put(paradt__rounds *r, paradt_index point) {
    size_t group = r->next >> PARADT__ROUND_SHIFT;
    int round = r->rounds;
    if (r->next == group << PARADT__ROUND_SHIFT) r->earlier = r->rounds ? paradt__earlier_one(group, 0) : SIZE_MAX;
    if (r->next++ == r->earlier) round = paradt__earlier_round(group, r->rounds);
    PARADT_ASSERT(r->rounds == 0 || round == r->rounds || r->end[round] < r->end[round + 1]);
    r->order[r->end[round]++] = point;
}

// Returns the positions 0 to count - 1, whose points are along the curve, in the order of insertion: a new block, or
// NULL when there is no memory.
static paradt_index *paradt__round_order(size_t count, paradt__memory *memory) {
    paradt__rounds r;
    size_t i;
    if (paradt__rounds_begin(&r, count, memory)) return NULL;
    for (i = 0; i < count; i++) paradt__rounds_put(&r, (paradt_index)i);
    return r.order;
}

// Deals all points of the set. Its first `own` points are along the curve. The others are sorted, and each is dealt
// near the own points between which the curve passes it. sorted, other: scratch for set->count - own elements
static void paradt__merge_others(const paradt__set *set, size_t own, const paradt__curve *curve, paradt__keyed *sorted,
                                 paradt__keyed *other, paradt__rounds *r) {
    enum { FEW = 16 }; // own points from one comparison of keys to the next
    size_t others = set->count - own, i, few, end, next = 0;
    for (i = 0; i < others; i++) sorted[i].item = (paradt_index)(own + i);
    paradt__curve_sort(curve, set->records, set->width, sorted, other, others);
    for (i = 0; i < own; i += FEW) {
        uint64_t key = paradt__curve_key(curve, set->records + i * set->width);
        while (next < others && sorted[next].key < key) paradt__rounds_put(r, sorted[next++].item);
        for (end = i + FEW < own ? i + FEW : own, few = i; few < end; few++) paradt__rounds_put(r, (paradt_index)few);
    }
    while (next < others) paradt__rounds_put(r, sorted[next++].item);
}

// Returns the positions of the set's points in the order of insertion, where only the first `own` are along the curve:
// a new block, or NULL when there is no memory.
PARADT__OPTIONAL paradt_index *paradt__merged_order(const paradt__set *set, size_t own, const paradt__curve *curve,
                                                    paradt__memory *memory) {
    size_t others = set->count - own;
    paradt__rounds r;
    paradt__keyed *sorted, *other;
    if (!own || !others) return paradt__round_order(set->count, memory);
    sorted = (paradt__keyed *)paradt__alloc(memory, others, sizeof *sorted);
    other = (paradt__keyed *)paradt__alloc(memory, others, sizeof *other);
    if (!sorted || !other || paradt__rounds_begin(&r, set->count, memory)) r.order = NULL;
    else paradt__merge_others(set, own, curve, sorted, other, &r);
    paradt__release(memory, other);
    paradt__release(memory, sorted);
    return r.order;
}

// Returns the order in which to insert points that come late: by rounds, and in each along a curve. A new block, or
// NULL when there is no memory.
PARADT__OPTIONAL paradt_index *paradt__late_order(const paradt__set *set, paradt__memory *memory) {
    paradt__keyed *keyed = (paradt__keyed *)paradt__alloc(memory, set->count, sizeof *keyed);
    paradt__keyed *other = (paradt__keyed *)paradt__alloc(memory, set->count, sizeof *other);
    paradt_index *order = paradt__round_order(set->count, memory);
    const paradt__space *space = &set->space;
    paradt__curve curve;
    size_t i;
    if (keyed && other && order) {
        paradt__curve_begin(&curve, space->dim, paradt__levels_for(SIZE_MAX, space->dim), space->low, space->high,
                            set->count);
        for (i = 0; i < set->count; i++) keyed[i].item = (paradt_index)i;
        paradt__curve_sort(&curve, set->records, set->width, keyed, other, set->count);
        for (i = 0; i < set->count; i++) order[i] = keyed[order[i]].item;
    } else {
        paradt__release(memory, order);
        order = NULL;
    }
    paradt__release(memory, keyed);
    paradt__release(memory, other);
    return order;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>insertion
//
// Incremental insertion (Bowyer 1981, Watson 1981) in any dimension. The cells in conflict with a new point form a
// star-shaped cavity, which is found from any one of them through their neighbours. The point and each facet of the
// cavity's rim make a new cell. Ghosts close the mesh, so inside and outside of the hull are one case.
//
// After each insertion the mesh is T(P), complete and exact, of the points P inserted so far; so no cell is ever flat.
// A weighted point is hidden if no cell is in conflict with it; a vertex becomes hidden if it is on no facet of the
// rim.
//
// Between two insertions `scene` is as >>scene says, no cell has the mark PARADT__CONFLICT, `ridges` is empty, and
// `update` says what the last insertion did. After an error the mesh may only be freed.
// Doors: paradt__insertion_point, paradt__insertion_room, paradt__insertion_reserve, paradt__insertion_first_points,
// paradt__insertion_first_cells, paradt__cavity_star, paradt__cavity_clear, paradt__insert.

struct paradt__kept; // see >>kept spheres

// An insertion of points, from its first cells on
typedef struct paradt__insertion {
    paradt__scene scene;
    paradt__memory *memory;
    const paradt_index *order; // [count] positions in the order of insertion; NULL: that of the records
    size_t count;              // number of points to insert
    size_t inserted;           // number of points inserted so far
    size_t later;              // number of points that may follow these; only for the capacity of the mesh
    double rate, rate_at;      // cells a point when the mesh last grew, and 1 + `inserted` then; 0: never
    paradt__relay *relay;      // says when the insertion pauses; NULL: it never does
    paradt__update update;     // what the last insertion did
    paradt_index *rim;         // [rim_capacity] the facets of the rim, as handles in the cavity's cells
    size_t rim_count, rim_capacity;
    paradt__facets ridges;     // facets of new cells that wait for their mirrors; empty between insertions
    struct paradt__kept *kept; // NULL: spheres are not kept
    int graded;                // records have sagittas (see >>reference sphere)
    double grade_limit;        // the largest size of a sagitta
    double grade_error;        // the largest error of a sagitta
} paradt__insertion;

// Returns the position of the i-th point to be inserted.
PARADT__INLINE paradt_index paradt__insertion_point(const paradt__insertion *build, size_t i) {
    return build->order ? build->order[i] : (paradt_index)i;
}

// --- room

enum {
    PARADT__GROW_PART = 16,       // a mesh grows by at least a sixteenth
    PARADT__FEW_POINTS = 1 << 15, // fewer points get room for all their cells in the beginning
    PARADT__JUDGED_PART = 32      // of more points a 32nd tells how many cells the others will have
};

#define PARADT__EXPECT_MORE 1.08 // capacity: the extrapolated number of cells times this,
#define PARADT__RATE_MORE   1.06 // or in space, with more cells than uniform points have: that at the present rate

// Makes room for `needed` places, and for as many as are wanted if these can be numbered.
static paradt_status paradt__insertion_reserve(paradt__insertion *build, size_t needed, size_t wanted) {
    if (needed <= build->scene.mesh.capacity && wanted <= build->scene.mesh.capacity) return PARADT_OK;
    return paradt__mesh_reserve(&build->scene.mesh, needed, wanted, build->memory);
}

// Returns the number of places to make room for when `needed` places are more than there are. The number of cells a
// point is extrapolated from what it is now and what it was when the mesh last grew, since on curves it grows with the
// number of points. Few sets have more cells than uniform points (scanned surfaces and shaken lattices do), and in the
// plane none has; so the number for uniform points is a limit there, and a guide in space.
static size_t paradt__insertion_expected(paradt__insertion *build, size_t needed) {
    int dim = build->scene.mesh.corners - 1;
    size_t points = build->count + build->later;
    double inserted = (double)build->inserted + 1.0, count = (double)points, rate = (double)needed / inserted;
    double judged = count / (double)PARADT__JUDGED_PART; // with fewer points the hull has too large a share
    int known = build->rate_at > judged && inserted > build->rate_at;
    double rise = known ? paradt__larger(rate - build->rate, 0.0) / (inserted - build->rate_at) : 0.0;
    double more = rise * (count - inserted),
           expected = (rate + (more < rate ? more : rate)) * count * PARADT__EXPECT_MORE;
    double most = dim <= 3 ? (double)paradt__expected_places(points, dim) : 1e15;
    double numbered = (double)paradt__most_cells(build->scene.mesh.corners);
    size_t least = needed + needed / PARADT__GROW_PART + 64;
    build->rate = rate;
    build->rate_at = inserted;
    if (expected > most && (double)least < most)
        expected = dim == 3 ? paradt__larger(most, rate * count * PARADT__RATE_MORE) : most;
    if (expected > numbered) expected = numbered;
    return inserted > judged && expected > (double)least ? (size_t)expected : least;
}

// Returns the number of points to make room for at the start. If the points are few, that is all of them and some more,
// as surfaces have more cells. If they are many, it is as many as it takes to extrapolate the number of cells: then the
// rows are copied once.
static size_t paradt__insertion_first_points(const paradt__insertion *build) {
    return build->count < PARADT__FEW_POINTS ? build->count + build->count / 32
                                             : build->count / PARADT__JUDGED_PART * 5 / 4;
}

// Makes sure that `count` places can be taken.
static paradt_status paradt__insertion_room(paradt__insertion *build, size_t count) {
    paradt__mesh *mesh = &build->scene.mesh;
    size_t needed = mesh->count + count - (mesh->spare_count < count ? mesh->spare_count : count);
    paradt_status status = PARADT_OK;
    if (PARADT__LIKELY(needed <= mesh->paged)) return PARADT_OK;
    if (needed > mesh->capacity)
        status = paradt__mesh_reserve(mesh, needed, paradt__insertion_expected(build, needed), build->memory);
    if (!status) paradt__mesh_make_pages(mesh, needed);
    return status;
}

// --- the cavity

// Digs the cavity of x: marks its cells and fills update.killed and the rim. first: a cell in conflict with x
static paradt_status paradt__cavity_dig(paradt__insertion *build, paradt_index first, const double *x) {
    const paradt__mesh *mesh = &build->scene.mesh;
    paradt__update *update = &build->update;
    int corners = mesh->corners, i;
    size_t head;
    PARADT_ASSERT(!(mesh->marks[first] & PARADT__CONFLICT) && *paradt__mesh_row(mesh, first) != PARADT__DEAD);
    update->killed[0] = first * corners;
    update->killed_count = 1;
    build->rim_count = 0;
    mesh->marks[first] |= PARADT__CONFLICT;
    for (head = 0; head < update->killed_count; head++) {
        paradt_index base = update->killed[head] - update->killed[head] % corners;
        paradt_status status = paradt__list_room(&update->killed, update->killed_count, &update->killed_capacity,
                                                 update->killed_count + (size_t)corners, build->memory);
        if (!status)
            status = paradt__list_room(&build->rim, build->rim_count, &build->rim_capacity,
                                       build->rim_count + (size_t)corners, build->memory);
        if (status) return status;
        for (i = 0; i < corners; i++) {
            paradt_index mirror = mesh->links[base + i], other = paradt__mesh_cell(mesh, mirror);
            if (mesh->marks[other] & PARADT__CONFLICT) continue;
            if (paradt__conflicts(&build->scene, other, x)) {
                mesh->marks[other] |= PARADT__CONFLICT;
                update->killed[update->killed_count++] = mirror;
            } else {
                build->rim[build->rim_count++] = base + i;
            }
        }
    }
    PARADT_ASSERT(build->rim_count >= (size_t)corners);
    return PARADT_OK;
}

// Makes room for what starring makes: places, update.made, and ridges, each of which is in two new cells.
static paradt_status paradt__cavity_room(paradt__insertion *build) {
    paradt__update *update = &build->update;
    size_t count = build->rim_count, ridges = count * (size_t)(build->scene.mesh.corners - 1);
    paradt_status status = paradt__insertion_room(build, count);
    if (!status) status = paradt__list_room(&update->made, 0, &update->made_capacity, count, build->memory);
    if (!status && !build->ridges.heads) status = paradt__facets_begin(&build->ridges, 0, 1, build->memory);
    return status ? status : paradt__facets_room(&build->ridges, ridges / 2 + 1, build->memory);
}

// Makes a cell of each facet of the rim: a copy of the cavity's cell at the facet, with the point instead of the vertex
// opposite the facet.
PARADT__INLINE void paradt__cavity_fill(paradt__insertion *build, paradt_index point, int corners) {
    paradt__mesh *mesh = &build->scene.mesh;
    paradt__facets *ridges = &build->ridges;
    size_t i;
    int j;
    for (i = 0; i < build->rim_count; i++) {
        paradt_index inner = build->rim[i], place = inner % corners, made = paradt__mesh_take(mesh);
        paradt_index base = made * corners, *vertices = mesh->vertices + base;
        uint64_t sum;
        PARADT_ASSERT(!(mesh->marks[paradt__mesh_cell(mesh, mesh->links[inner])] & PARADT__CONFLICT));
        memcpy(vertices, mesh->vertices + (inner - place), (size_t)corners * sizeof *vertices);
        vertices[place] = point;
        paradt__mesh_tie(mesh, base + place, mesh->links[inner]);
        sum = paradt__cell_sum(vertices, corners);
        for (j = 0; j < corners; j++) {
            paradt__facet_key key = {0, paradt__facet_hash(sum - paradt__vertex_key(vertices[j]))};
            if (j != (int)place) paradt__facets_tie(ridges, mesh, key, base + j, corners);
        }
        build->update.made[i] = base + place;
        build->scene.hint = made;
    }
    build->update.made_count = build->rim_count;
}

// Stars the cavity with the point. Fills update.made with the facets of the rim, as handles in the new cells.
static paradt_status paradt__cavity_star(paradt__insertion *build, paradt_index point) {
    paradt_status status = paradt__cavity_room(build);
    if (status) return status;
    switch (build->scene.mesh.corners) {
    case 3: paradt__cavity_fill(build, point, 3); break;
    case 4: paradt__cavity_fill(build, point, 4); break;
    default: paradt__cavity_fill(build, point, build->scene.mesh.corners);
    }
    PARADT_ASSERT(build->ridges.count == 0);
    return PARADT_OK;
}

// Clears the marks of the cavity's cells and gives their places back.
static paradt_status paradt__cavity_clear(paradt__insertion *build) {
    paradt__mesh *mesh = &build->scene.mesh;
    const paradt__update *update = &build->update;
    size_t i;
    paradt_status status = paradt__mesh_spare_room(mesh, update->killed_count, build->memory);
    if (status) return status;
    for (i = 0; i < update->killed_count; i++) {
        paradt_index cell = paradt__mesh_cell(mesh, update->killed[i]);
        mesh->marks[cell] = 0;
        paradt__mesh_give(mesh, cell, (size_t)mesh->corners);
    }
    return PARADT_OK;
}

// Inserts a point: walk, dig, star.
static paradt_status paradt__insert(paradt__insertion *build, paradt_index point) {
    const double *x = paradt__scene_record(&build->scene, point);
    paradt_index cell = paradt__walk(&build->scene, build->scene.hint, x);
    paradt_status status;
    build->scene.hint = cell;
    build->update.killed_count = build->update.made_count = 0;
    if (build->scene.space.weighted && !paradt__conflicts(&build->scene, cell, x)) return PARADT_OK; // hidden
    status = paradt__cavity_dig(build, cell, x);
    if (!status) status = paradt__cavity_star(build, point);
    if (!status) status = paradt__cavity_clear(build);
    return status;
}

// --- the first cells

// Makes the cell of the first points, which span the space, at place 0, and at place 1 + i the ghost on its facet
// opposite vertex i.
static paradt_status paradt__insertion_first_cells(paradt__insertion *build) {
    paradt__mesh *mesh = &build->scene.mesh;
    int corners = mesh->corners, side, i, j;
    const double *p[PARADT_MAX_DIM + 1];
    paradt_status status = paradt__insertion_reserve(build, (size_t)corners + 1, (size_t)corners + 1);
    if (status) return status;
    mesh->count = (size_t)corners + 1;
    for (i = 0; i < corners; i++) {
        mesh->vertices[i] = paradt__insertion_point(build, (size_t)i);
        p[i] = paradt__scene_record(&build->scene, mesh->vertices[i]);
    }
    side = paradt__orient(&build->scene.space, p);
    PARADT_ASSERT(side != 0);
    if (side < 0) {
        mesh->vertices[0] = paradt__insertion_point(build, 1);
        mesh->vertices[1] = paradt__insertion_point(build, 0);
    }
    // The infinite vertex is on the other side of the facet than vertex i; so in a ghost vertices 0 and 1 are
    // exchanged. Ghosts i and j have the facet without vertices i and j in common; in ghost j it is opposite vertex i
    // of the cell.
    for (i = 0; i < corners; i++) {
        paradt_index base = (paradt_index)((i + 1) * corners);
        for (j = 0; j < corners; j++) {
            int place = j < 2 ? 1 - j : j;
            mesh->vertices[base + place] = j == i ? (paradt_index)PARADT__INFINITE : mesh->vertices[j];
            mesh->links[base + place] =
                j == i ? (paradt_index)i : (paradt_index)((j + 1) * corners + (i < 2 ? 1 - i : i));
            if (j == i) mesh->links[i] = base + place;
        }
    }
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>kept spheres
//
// Conflict tests in three dimensions, without weights, by spheres that are kept: a test is one dot product, for ghosts
// too. Where the value does not exceed the bound on its error the predicates decide, so the answers are always theirs.
//
// A cell's sphere is kept as an affine function of x: the power of x with regard to the sphere, without |x|^2.
//     power(x) = |x|^2 + normal . x + constant, negative inside; x is relative to the centre of the set's bounding box
// A ghost has the halfspace beyond its facet instead of a ball: a function so steep that |x|^2 does not matter. The
// spheres stand in a table, in slots. A cell's slot is its place modulo the table's size, a power of two. If another
// cell's sphere has driven a sphere out of its slot, the sphere is made again when it is wanted.
//
// THE ERROR of a power. u = 2^-52 bounds the relative error of a rounding in any rounding mode.
// (1) The exact sphere. Let p be one of the vertices, and a, b, c the differences of the other three to p. Then
//         power(x) = |x - p|^2 - w . (x - p),   w = n / det,
//         n = |a|^2 b x c + |b|^2 c x a + |c|^2 a x b,   det = a . b x c > 0.
//     The centre is p + w / 2. With s_p and s_x the differences of p and x to the box's centre, as computed, what is
//     kept is normal = -(2 s_p + w) and constant = |s_p|^2 + w . s_p.
// (2) det and n. Let P be at least the sum of the sizes of the six terms of det, and N_j that of the terms of n_j. A
//     computed difference has a relative error of at most u. So the product of two has at most 3u, the terms of b x c
//     have 4u, and those of det 8u: det is wrong by at most 8.1u P. |a|^2 has 5u, so n_j is wrong by at most 12.1u N_j.
//     (The first two terms of n may also be computed as v x c, v = |a|^2 b - |b|^2 a, with fewer operations: the terms
//     of v have 8u then, those of v x c 11u, and n_j is wrong by at most 12.1u N_j again.)
// (3) w. Where det > 32u P, the true determinant is more than 0.74 det. Then w_j is wrong by at most
//         2.1u |w_j| + (11u P |w_j| + 16.4u N_j) / det.
// (4) The power. Let h_j be the largest |s_j| in the set, H = sum h_j^2 and W = sum |w_j| h_j. A term of the power
//     passes at most 15 roundings, and the sizes of the terms add up to at most 4 H + 2 W: that makes 60u H + 30u W.
//     The error of w_j counts 2 h_j times. As det < 1.1 P, what is a multiple of W alone is less than 1.1 W P / det. In
//     all the power is wrong by less than
//         error = 64u (H + (P W + sum N_j h_j) / det).
//     The two factors are 60 and less than 60. Rounding them up covers the roundings in this bound itself, and in P,
//     N_j and h_j.
// (5) P and N_j. Sharp bounds take the sums of the terms' sizes themselves. Quick bounds take fewer operations: with
//     m_j = |a_j| + |b_j| + |c_j| and L = |a|^2 + |b|^2 + |c|^2 they take the products
//         P = m_x m_y m_z,   N_x = L m_y m_z,   N_y = m_x L m_z,   N_z = m_x m_y L.
//     Where cells are long and thin the quick bounds leave many powers open that the in-sphere filter decides; then
//     paradt__kept_adapt changes over to sharp ones. All sums may be associated in any order and contracted, which only
//     drops roundings.
// (6) Ghosts. A ghost's function is power(x) = |x|^2 - t N . (x - p) with N = a x b, a and b the differences of its
//     facet's other vertices to p, and t = 2^60 H^(1/2) / max |N_j|. With m_j = max(|a_j|, |b_j|), N_x is wrong by at
//     most 3.1u * 2 m_y m_z + u |N_x|. The terms N_j (x - p)_j pass 8 more roundings, |x - p|_j is at most 2 h_j, and
//     the lift |x|^2 adds at most 1.1 H. In all the sign of the power is right if its size exceeds
//         error = 2 H + 16u t (2 sum |N_j| h_j + Q),   Q = h_x m_y m_z + m_x h_y m_z + m_x m_y h_z.
// (7) Sagittas (see >>reference sphere). Near a sphere of centre o records have sagittas, and g(x) = -sagitta is taken
//     for |x|^2. This adds an affine function to |x|^2, so with g(a) - g(p) instead of |a|^2 in n, a here the vertex,
//         normal = -w,   constant = w . s_p - g(p),
//     power(x) = g(x) + normal . x + constant is what it was. Let E bound the error of g, and G its size. If N_j is
//     computed with E / 4u added to the size of each difference of g, n_j is wrong by at most 12.1u N_j again, for 2 E
//     is less than 12.1u times that. The terms of the power add up to at most 2 G + 2 W, and E counts twice. So the
//     bound of (4) holds with H = G + E / 16u, which is as small as the noise.
// (8) Zero. A power times det is the in-sphere determinant, a multiple of the set's quantum, and det is at most
//     6 * 8 h_x h_y h_z. So a power that is surely less than quantum / (64 h_x h_y h_z) in size is 0. A ghost's power
//     never passes this test, for the ghost's error exceeds 2 H.
//
// Doors: paradt__kept_begin, paradt__kept_free, paradt__kept_more_numbers, paradt__kept_sphere, paradt__kept_settle,
// paradt__kept_evict, paradt__kept_adapt, paradt__sphere_make, paradt__sphere_of_facet, paradt__sphere_power,
// paradt__centred_of, paradt__spoke_of, paradt__spoke_at.

// Slots of the table: eight a point up to MANY_SPHERES; for more points one for 5 of them (for 8 where the mesh is a
// slice of the result) up to MOST_SPHERES. There is memory for LEAST_SPHERES at least, as a block of that size keeps
// common allocators from giving pages back.
enum { PARADT__MOST_SPHERES = 1 << 16, PARADT__MANY_SPHERES = 1 << 14, PARADT__LEAST_SPHERES = 1 << 11 };

// Stars. Of a star of R cells the rim has R facets and 2 + R / 2 vertices (Euler). The edges of its rim stand in a
// table. There are three: a small one for common stars, which stays in the first cache; a second for wide stars; and
// one for larger stars, which is allocated when it is first needed.
enum {
    PARADT__COMMON_RIM = 60, // few stars have more cells
    PARADT__COMMON_VERTICES = 32,
    PARADT__WIDE_RIM = 256,
    PARADT__WIDE_VERTICES = 130,
    PARADT__MOST_RIM = 2048, // larger stars are made by >>insertion
    PARADT__RIM_VERTICES = 1026,
    PARADT__EDGE_UNIT = 32, // the length of a row of edges is a multiple of this
    PARADT__WIDE_UNITS = 5  // of a row for wide stars
};

enum {
    PARADT__MOST_WAITING = 16,                   // facets that wait at a time for their spheres to be made again
    PARADT__DIG_ROOM = PARADT__MOST_WAITING + 4, // room in the lists before a cell is dug: for the facets that wait,
                                                 // and for the cell's own, of which four are stored together
    PARADT__DIG_BATCH = 512,                     // cells dug before numbers are limited again
    PARADT__FIRST_DIG = 512,                     // the capacity that the lists of the cavity and the rim begin with
    PARADT__PLACES_AHEAD = 16,                   // from a new place to the place whose slot is prefetched
    PARADT__INSERTIONS_AHEAD = 4                 // from an insertion to the insertion whose point is prefetched
};

#define PARADT__LAST_NUMBER 0xfffe0000 // the largest that a cavity may begin with; it takes less than 2^17
#define PARADT__IN_CAVITY   (~((paradt__tag)-1 >> 1)) // bit of a tag: the cell is in the cavity that is being dug
#define PARADT__NO_SPHERE   (PARADT__IN_CAVITY - 1)   // tag of an empty slot: no cell has this place

// A slot of the table
typedef struct paradt__sphere {
    double normal[3], constant;
    double error;                                     // bound on the error of a power
    paradt__tag tag;                                  // place of the cell, and PARADT__IN_CAVITY
    paradt__tag unused[24 / sizeof(paradt__tag) - 1]; // makes it a cache line, 64 bytes
} paradt__sphere;

// A point relative to the centre of the box, and its lift: |s|^2, or with sagittas g
typedef struct paradt__centred {
    double s[3], lift;
} paradt__centred;

// A vertex of the cavity: at first its position, then the edge that leads to it from the new point
typedef union paradt__spoke {
    paradt_index vertex;
    double edge[4]; // by axis; last the square of its length, or with sagittas how much larger g is at the vertex
} paradt__spoke;

enum { PARADT__NUMBER_STEP = sizeof(paradt__spoke) }; // from the number of one vertex to the next one's

// What the bounds on errors are made of: h_j, rounded up; H; and with sagittas E / 4u
typedef struct paradt__frame {
    double half[3], square, slack;
} paradt__frame;

// How spheres are made: with quick or with sharp bounds on the errors; or with sharp ones, by sagittas
typedef enum paradt__making { PARADT__MAKE_QUICKLY, PARADT__MAKE_SHARP, PARADT__MAKE_GRADED } paradt__making;

// The spheres, and what an insertion with their help works on
typedef struct paradt__kept {
    paradt__sphere *table; // [mask + 1] on cache lines; at first in the same block, behind this struct
    paradt__tag mask;
    int evicted;          // a cell of the cavity has lost its sphere, and has the mark PARADT__CONFLICT instead
    double centre[3];     // of the bounding box
    paradt__frame frame;  // of the spheres of cells
    double box_square;    // H without sagittas
    double steepness;     // of ghosts: 2^60 times the root of box_square
    double zero_below;    // a power of less than this in size is 0
    paradt__centred next; // the point to be inserted next
    paradt_index start;   // where the search for it begins: of the last new cells the one with its least power

    // Since the last call of paradt__kept_adapt: new cells; spheres made again; powers in doubt that the filter decided
    size_t made_count, missed_count, doubtful_count;
    paradt__making making;
    void *table_block;             // NULL: the table is in the same block as this struct
    paradt_index *large_edges;     // the table of edges for stars of up to large_rim cells; NULL: none
    size_t large_rim, large_units; // large_units: of its rows

    // The vertices of a cavity have numbers. That of v is number[v + 1], and number - first is its offset in bytes in
    // `spokes`. Numbers go on from cavity to cavity; one that is less than `first` is of an earlier cavity.
    uint32_t *number;                        // [numbers]
    size_t numbers;                          // at least points + 1
    uint32_t first, next_number, spokes_end; // spokes_end: the offset behind the last vertex
    paradt__spoke spokes[(int)PARADT__RIM_VERTICES + (int)PARADT__DIG_BATCH + 4]; // see paradt__kept_limit_numbers

    // Tables of edges. Row i, element j: the handle of the facet that contains the edge from vertex i to vertex j and
    // the new point, in the new cell that sees the edge in this direction.
    paradt_index common_edges[PARADT__COMMON_VERTICES * PARADT__COMMON_VERTICES];
    paradt_index wide_edges[PARADT__WIDE_VERTICES * PARADT__WIDE_UNITS * PARADT__EDGE_UNIT];

    paradt_index waiting[PARADT__MOST_WAITING]; // facets whose spheres are missing, as handles in the cavity's cells

    // The new cells, one for each facet of the rim. Spheres are made four at a time: hence three more.
    uint16_t offsets[PARADT__MOST_RIM + 3][4]; // of the spokes of the facet's vertices
    paradt_index row[PARADT__MOST_RIM][4];     // vertices, the point last
    paradt_index outer[PARADT__MOST_RIM];      // mirrors of the facets of the rim
    int ghosts;                                // there are ghosts among the new cells; then these are the others:
    paradt_index finite_base[PARADT__MOST_RIM + 3];
    uint16_t finite_offsets[PARADT__MOST_RIM + 3][4];
} paradt__kept;

#define PARADT__UNIT_ERROR     2.220446049250313e-16
#define PARADT__NO_ERROR_BOUND 3.2733906078961419e150 // 2^500: more than any power in a filtered set
#define PARADT__FLATTEST       2.0370359763344861e90  // 2^300: limit of a ghost's t, and of sum N_j h_j / det
#define PARADT__GRADE_PAYS     1.4901161193847656e-8  // 2^-26, of H or r^2: smaller sagittas tell more than |x|^2 does

// Returns the spoke at an offset in bytes.
PARADT__INLINE paradt__spoke *paradt__spoke_at(paradt__spoke *spokes, size_t offset) {
    return (paradt__spoke *)(void *)((char *)spokes + offset);
}

// Returns the first cache line that begins in the block.
PARADT__INLINE paradt__sphere *paradt__on_cache_line(void *memory) {
    return (paradt__sphere *)(void *)((char *)memory + (64 - (uintptr_t)memory % 64) % 64);
}

static void paradt__kept_free(paradt__kept *s, paradt__memory *memory) {
    if (!s) return;
    paradt__release(memory, s->number);
    paradt__release(memory, s->table_block);
    paradt__release(memory, s->large_edges);
    paradt__release(memory, s);
}

// Returns a point, given by its record, as the spheres need it.
PARADT__INLINE paradt__centred paradt__centred_of(const paradt__kept *s, const double *x) {
    paradt__centred centred;
    centred.s[0] = x[0] - s->centre[0];
    centred.s[1] = x[1] - s->centre[1];
    centred.s[2] = x[2] - s->centre[2];
    centred.lift = centred.s[0] * centred.s[0] + centred.s[1] * centred.s[1] + centred.s[2] * centred.s[2];
    if (!PARADT__LIKELY(s->making != PARADT__MAKE_GRADED)) centred.lift = -x[3];
    return centred;
}

// Returns the edge from one point to another, given by their records.
PARADT__INLINE paradt__spoke paradt__spoke_of(paradt__making making, const double *from, const double *to) {
    paradt__spoke spoke;
    double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
    spoke.edge[0] = x;
    spoke.edge[1] = y;
    spoke.edge[2] = z;
    spoke.edge[3] = making == PARADT__MAKE_GRADED ? from[3] - to[3] : x * x + y * y + z * z;
    return spoke;
}

// Returns the largest of the sizes of three numbers.
PARADT__INLINE double paradt__largest_of_three(double a, double b, double c) {
    return paradt__larger(paradt__larger(paradt__abs(a), paradt__abs(b)), paradt__abs(c));
}

// Returns the sum of the sizes of the two terms of ad - bc.
PARADT__INLINE double paradt__minor_size(double a, double b, double c, double d) {
    return paradt__abs(a * d) + paradt__abs(b * c);
}

// Makes the sphere through p, p + a, p + b and p + c, a cell that is positively oriented, by (1) to (5) and (7). a[3]:
// |a|^2, or with sagittas g(p + a) - g(p).
// The code has no branches, so that compilers can make vectors of several calls. Where det is too small, a larger
// number stands in for it and the error is so large that all powers are in doubt. That is a choice by comparison: with
// x87 registers a term like (safe - det) * 2^500 need not be 0 where both are equal, as one of them may have been
// rounded.
PARADT__INLINE void paradt__sphere_make(paradt__making making, const paradt__frame *f, const paradt__centred *p,
                                        const double *a, const double *b, const double *c, double *normal,
                                        double *constant, double *error) {
    const int graded = making == PARADT__MAKE_GRADED;
    double ax = a[0], ay = a[1], az = a[2], la = a[3], bx = b[0], by = b[1], bz = b[2], lb = b[3];
    double cx = c[0], cy = c[1], cz = c[2], lc = c[3];
    double bcx = by * cz - bz * cy, bcy = bz * cx - bx * cz, bcz = bx * cy - by * cx;
    double cax = cy * az - cz * ay, cay = cz * ax - cx * az, caz = cx * ay - cy * ax;
    double abx = ay * bz - az * by, aby = az * bx - ax * bz, abz = ax * by - ay * bx;
    double det = ax * bcx + ay * bcy + az * bcz, size, sides; // size: P; sides: sum N_j h_j
    double floor, safe, inverse, wx, wy, wz, reach;           // reach: W
    if (making != PARADT__MAKE_QUICKLY) {
        double sla = graded ? paradt__abs(la) + f->slack : la, slb = graded ? paradt__abs(lb) + f->slack : lb;
        double slc = graded ? paradt__abs(lc) + f->slack : lc;
        double sbcx = paradt__minor_size(by, bz, cy, cz), sbcy = paradt__minor_size(bz, bx, cz, cx);
        double sbcz = paradt__minor_size(bx, by, cx, cy), scax = paradt__minor_size(cy, cz, ay, az);
        double scay = paradt__minor_size(cz, cx, az, ax), scaz = paradt__minor_size(cx, cy, ax, ay);
        double sabx = paradt__minor_size(ay, az, by, bz), saby = paradt__minor_size(az, ax, bz, bx);
        double sabz = paradt__minor_size(ax, ay, bx, by);
        size = paradt__abs(ax) * sbcx + paradt__abs(ay) * sbcy + paradt__abs(az) * sbcz;
        sides = f->half[0] * (sla * sbcx + slb * scax + slc * sabx) +
                f->half[1] * (sla * sbcy + slb * scay + slc * saby) +
                f->half[2] * (sla * sbcz + slb * scaz + slc * sabz);
    } else {
        double mx = paradt__abs(ax) + paradt__abs(bx) + paradt__abs(cx);
        double my = paradt__abs(ay) + paradt__abs(by) + paradt__abs(cy);
        double mz = paradt__abs(az) + paradt__abs(bz) + paradt__abs(cz);
        size = mx * my * mz;
        sides = (la + lb + lc) * (f->half[0] * my * mz + mx * f->half[1] * mz + mx * my * f->half[2]);
    }
    // the least det; the last two terms keep quotients from overflowing
    floor = 32.0 * PARADT__UNIT_ERROR * size + sides * (1.0 / PARADT__FLATTEST) + 1.0 / PARADT__NO_ERROR_BOUND;
    safe = det > floor ? det : floor;
    inverse = 1.0 / safe;
    wx = (la * bcx + lb * cax + lc * abx) * inverse;
    wy = (la * bcy + lb * cay + lc * aby) * inverse;
    wz = (la * bcz + lb * caz + lc * abz) * inverse;
    reach = paradt__abs(wx) * f->half[0] + paradt__abs(wy) * f->half[1] + paradt__abs(wz) * f->half[2];
    normal[0] = graded ? -wx : -2.0 * p->s[0] - wx;
    normal[1] = graded ? -wy : -2.0 * p->s[1] - wy;
    normal[2] = graded ? -wz : -2.0 * p->s[2] - wz;
    *constant = (graded ? -p->lift : p->lift) + (wx * p->s[0] + wy * p->s[1] + wz * p->s[2]);
    *error = 64.0 * PARADT__UNIT_ERROR * (f->square + (size * reach + sides) * inverse) +
             (det > floor ? 0.0 : PARADT__NO_ERROR_BOUND);
}

// Row i: the order of a cell's vertices but for vertex i. With what replaces vertex i last, it keeps the orientation.
static const unsigned char paradt__facet_order[4][3] = {{1, 3, 2}, {0, 2, 3}, {1, 0, 3}, {0, 1, 2}};

// Makes the function of the ghost on the facet p q r by (6). centred: p. Where the facet is too small for it, all
// powers are in doubt.
PARADT__INLINE void paradt__sphere_of_facet(const paradt__kept *s, paradt__sphere *sphere,
                                            const paradt__centred *centred, const double *p, const double *q,
                                            const double *r) {
    const double *h = s->frame.half;
    double ax = q[0] - p[0], ay = q[1] - p[1], az = q[2] - p[2], bx = r[0] - p[0], by = r[1] - p[1], bz = r[2] - p[2];
    double nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx,
           size = paradt__largest_of_three(nx, ny, nz);
    double mx = paradt__largest_of_three(ax, bx, 0.0), my = paradt__largest_of_three(ay, by, 0.0),
           mz = paradt__largest_of_three(az, bz, 0.0), t;
    double sides = h[0] * my * mz + mx * h[1] * mz + mx * my * h[2];
    if (!(s->steepness < PARADT__FLATTEST * size)) {
        sphere->normal[0] = sphere->normal[1] = sphere->normal[2] = sphere->constant = 0.0;
        sphere->error = PARADT__NO_ERROR_BOUND;
        return;
    }
    t = s->steepness / size;
    sphere->normal[0] = -t * nx;
    sphere->normal[1] = -t * ny;
    sphere->normal[2] = -t * nz;
    sphere->constant = t * (nx * centred->s[0] + ny * centred->s[1] + nz * centred->s[2]);
    sphere->error = 2.0 * s->box_square +
                    PARADT__UNIT_ERROR * t * 16.0 *
                        (2.0 * (paradt__abs(nx) * h[0] + paradt__abs(ny) * h[1] + paradt__abs(nz) * h[2]) + sides);
}

// Makes the function of a ghost. place: that of the infinite vertex
static void paradt__sphere_of_ghost(const paradt__insertion *build, paradt__sphere *sphere,
                                    const paradt_index *vertices, int place) {
    const unsigned char *order = paradt__facet_order[place];
    const double *p = paradt__scene_record(&build->scene, vertices[order[0]]),
                 *q = paradt__scene_record(&build->scene, vertices[order[1]]);
    paradt__centred centred = paradt__centred_of(build->kept, p);
    paradt__sphere_of_facet(build->kept, sphere, &centred, p, q,
                            paradt__scene_record(&build->scene, vertices[order[2]]));
}

// Makes the sphere of a cell and puts it into the table.
PARADT__NOINLINE void paradt__kept_make(const paradt__insertion *build, paradt_index cell) {
    paradt__kept *s = build->kept;
    paradt__sphere *sphere = s->table + ((paradt__tag)cell & s->mask);
    const paradt_index *vertices = build->scene.mesh.vertices + 4 * (size_t)cell;
    int ghost = paradt__ghost_place(vertices, 4);
    if (ghost >= 0) {
        paradt__sphere_of_ghost(build, sphere, vertices, ghost);
    } else {
        const double *a = paradt__scene_record(&build->scene, vertices[0]),
                     *b = paradt__scene_record(&build->scene, vertices[1]);
        const double *c = paradt__scene_record(&build->scene, vertices[2]),
                     *p = paradt__scene_record(&build->scene, vertices[3]);
        paradt__spoke to_a = paradt__spoke_of(s->making, p, a), to_b = paradt__spoke_of(s->making, p, b),
                      to_c = paradt__spoke_of(s->making, p, c);
        paradt__centred centred = paradt__centred_of(s, p);
        // (a, b, c, p) is positive when det(a - p, b - p, c - p) is negative
        paradt__sphere_make(s->making, &s->frame, &centred, to_b.edge, to_a.edge, to_c.edge, sphere->normal,
                            &sphere->constant, &sphere->error);
    }
    sphere->tag = (paradt__tag)cell;
}

// Drives the sphere out that is in a cell's slot, and returns the slot. If the sphere is that of a cell in the cavity,
// this cell gets the mark PARADT__CONFLICT instead.
PARADT__INLINE paradt__sphere *paradt__kept_evict(const paradt__insertion *build, paradt_index cell) {
    paradt__kept *s = build->kept;
    paradt__sphere *sphere = s->table + ((paradt__tag)cell & s->mask);
    if (sphere->tag & PARADT__IN_CAVITY) {
        build->scene.mesh.marks[sphere->tag & ~PARADT__IN_CAVITY] |= PARADT__CONFLICT;
        s->evicted = 1;
    }
    s->missed_count++;
    PARADT_ASSERT(((s->mask + 1) & s->mask) == 0 && *paradt__mesh_row(&build->scene.mesh, cell) != PARADT__DEAD);
    return sphere;
}

// Makes a sphere again that is not in the table.
PARADT__NOINLINE void paradt__kept_remake(const paradt__insertion *build, paradt_index cell) {
    paradt__sphere *sphere = paradt__kept_evict(build, cell);
    paradt__kept_make(build, cell);
    if (build->scene.mesh.marks[cell] & PARADT__CONFLICT) sphere->tag |= PARADT__IN_CAVITY;
}

// Returns the sphere of a cell, which is in the table afterwards.
PARADT__INLINE const paradt__sphere *paradt__kept_sphere(const paradt__insertion *build, paradt_index cell) {
    const paradt__sphere *sphere = build->kept->table + ((paradt__tag)cell & build->kept->mask);
    if (!PARADT__LIKELY((sphere->tag & ~PARADT__IN_CAVITY) == (paradt__tag)cell)) paradt__kept_remake(build, cell);
    return sphere;
}

// Returns the power of x.
PARADT__INLINE double paradt__sphere_power(const paradt__sphere *sphere, const paradt__centred *x) {
    return (x->lift + sphere->constant) +
           (sphere->normal[0] * x->s[0] + sphere->normal[1] * x->s[1] + sphere->normal[2] * x->s[2]);
}

// Fills p with the vertices of a cell, and x.
PARADT__INLINE void paradt__kept_corners(const paradt__insertion *build, paradt_index cell, const double *x,
                                         const double **p) {
    int i;
    for (i = 0; i < 4; i++)
        p[i] = paradt__scene_record(&build->scene, build->scene.mesh.vertices[4 * (size_t)cell + (size_t)i]);
    p[4] = x;
}

// Is the cell, which is no ghost, in conflict with a point that is on its sphere?
PARADT__INLINE unsigned paradt__kept_tie(paradt__insertion *build, paradt_index cell, const double *x) {
    const double *p[PARADT_MAX_DIM + 2];
    paradt__kept_corners(build, cell, x, p);
    build->scene.space.counters.insphere_calls++;
    build->scene.space.counters.exact_small++;
    return (unsigned)paradt__perturbed(&build->scene.space, p);
}

// Is the cell or ghost in conflict with the point? Asks the predicates.
PARADT__NOINLINE unsigned paradt__kept_decide(paradt__insertion *build, paradt_index cell, const double *x) {
    const double *p[PARADT_MAX_DIM + 2];
    int sign;
    if (!paradt__is_finite_cell(build->scene.mesh.vertices + 4 * (size_t)cell, 4))
        return (unsigned)paradt__conflicts(&build->scene, cell, x);
    paradt__kept_corners(build, cell, x, p);
    build->scene.space.counters.insphere_calls++;
    sign = paradt__filter_insphere3(&build->scene.space, p, 3, 0);
    if (sign == PARADT__UNDECIDED) sign = paradt__exact_insphere3(&build->scene.space, p);
    else build->kept->doubtful_count++;
    return (unsigned)(sign ? sign > 0 : paradt__perturbed(&build->scene.space, p));
}

// Is the cell or ghost in conflict with the point? Its sphere need not be in the table, nor its power tell.
PARADT__NOINLINE unsigned paradt__kept_settle(paradt__insertion *build, paradt_index cell,
                                              const paradt__centred *centred, const double *x) {
    const paradt__kept *s = build->kept;
    const paradt__sphere *sphere = paradt__kept_sphere(build, cell);
    double power;
    if (sphere->tag & PARADT__IN_CAVITY) return 1;
    power = paradt__sphere_power(sphere, centred);
    if (paradt__abs(power) > sphere->error) return power < 0.0;
    if (paradt__abs(power) + sphere->error < s->zero_below) return paradt__kept_tie(build, cell, x);
    return paradt__kept_decide(build, cell, x);
}

// Adapts to long cells, and to points with hundreds of cells. Changes over to sharp bounds if quick ones leave many
// powers in doubt. Makes the table four times as large if many spheres have been made again, and if for the cells to
// come more would be than the larger table has slots. The table takes at most half of the memory that the cells take.
// If that is refused the table stays as it is.
PARADT__NOINLINE void paradt__kept_adapt(paradt__insertion *build) {
    paradt__kept *s = build->kept;
    size_t size = 4 * ((size_t)s->mask + 1), i;
    void *larger = NULL;
    double to_come = 28.0 * (double)(build->count - build->inserted); // new cells, as many as uniform points make
    int often =
        s->missed_count > s->made_count / 4 && (double)s->missed_count * to_come > (double)s->made_count * (double)size;
    PARADT_ASSERT(build->inserted < build->count);
    if (s->doubtful_count > s->made_count / 16 && s->making == PARADT__MAKE_QUICKLY) s->making = PARADT__MAKE_SHARP;
    s->made_count = s->missed_count = s->doubtful_count = 0;
    if (often && size * sizeof *s->table <= build->scene.mesh.count * 4 * sizeof(paradt_index))
        larger = paradt__alloc(build->memory, size + 1, sizeof *s->table);
    if (!larger) return;
    paradt__release(build->memory, s->table_block);
    s->table_block = larger;
    s->table = paradt__on_cache_line(larger);
    s->mask = (paradt__tag)(size - 1);
    for (i = 0; i < size; i++) s->table[i].tag = PARADT__NO_SPHERE;
}

// Makes room for the numbers of more vertices. Returns 0 if there is no memory.
static int paradt__kept_more_numbers(paradt__insertion *build, size_t numbers) {
    paradt__kept *s = build->kept;
    void *array = s->number;
    PARADT_ASSERT(numbers > s->numbers);
    if (!paradt__grow(build->memory, &array, s->numbers, numbers, sizeof *s->number)) return 0;
    s->number = (uint32_t *)array;
    paradt__make_pages(s->number, s->numbers * sizeof *s->number, numbers * sizeof *s->number);
    memset(s->number + s->numbers, 0, (numbers - s->numbers) * sizeof *s->number);
    s->numbers = numbers;
    return 1;
}

// Changes over to sagittas if the records have them, so small that without them most powers would be in doubt.
static void paradt__kept_grade(paradt__insertion *build) {
    paradt__kept *s = build->kept;
    double square = build->grade_limit + build->grade_error / (16.0 * PARADT__UNIT_ERROR);
    if (!build->graded || !(square < s->box_square * PARADT__GRADE_PAYS)) return;
    s->making = PARADT__MAKE_GRADED;
    s->frame.square = square;
    s->frame.slack = build->grade_error / (4.0 * PARADT__UNIT_ERROR);
}

// Finds what the set's bounding box decides: its centre, and what bounds on errors and ghosts are made of.
static void paradt__kept_measure(paradt__insertion *build) {
    paradt__kept *s = build->kept;
    int axis;
    for (axis = 0; axis < 3; axis++) {
        double low = paradt__from_ordered_bits(build->scene.space.low[axis]);
        double high = paradt__from_ordered_bits(build->scene.space.high[axis]);
        s->centre[axis] = paradt__rounded(low + (high - low) * 0.5);
        s->frame.half[axis] = paradt__larger(high - s->centre[axis], s->centre[axis] - low) * 1.0000002;
        s->frame.square += s->frame.half[axis] * s->frame.half[axis];
    }
    s->box_square = s->frame.square;
    s->steepness = sqrt(s->box_square) * paradt__power(60);
    paradt__kept_grade(build);
    s->zero_below =
        build->scene.space.insphere[3].quantum / (64.0 * s->frame.half[0] * s->frame.half[1] * s->frame.half[2]);
}

// Begins to keep spheres if the set has three coordinates, no weights, and passes the floating-point filter. Else
// build->kept stays NULL, and the insertion is that in any dimension. After an error paradt__kept_free is called.
static paradt_status paradt__kept_begin(paradt__insertion *build) {
    paradt__kept *s;
    size_t size = 64, points = build->scene.mesh.lent ? 8 : 5; // a slot
    size_t room, bytes, i;
    if (!build->scene.space.filtered || build->scene.space.weighted || build->scene.space.ambient != 3)
        return PARADT_OK;
    while (size < 8 * build->count && size < PARADT__MANY_SPHERES) size *= 2;
    while (size < build->count / points && size < PARADT__MOST_SPHERES) size *= 2;
    room = size > PARADT__LEAST_SPHERES ? size : (size_t)PARADT__LEAST_SPHERES;
    bytes = sizeof *s + (room + 1) * sizeof *s->table;
    s = (paradt__kept *)paradt__alloc(build->memory, 1, bytes);
    build->kept = s;
    if (!s) return PARADT_ERROR_MEMORY;
    // not for few points: allocators keep the pages from the call before, and even to look for them takes long then
    if (size > PARADT__LEAST_SPHERES) paradt__make_pages(s, sizeof *s, bytes);
    memset(s, 0, offsetof(paradt__kept, spokes)); // what follows is written before it is read
    s->mask = (paradt__tag)(size - 1);
    s->table = paradt__on_cache_line(s + 1);
    if (!paradt__kept_more_numbers(build, build->count + 1)) return PARADT_ERROR_MEMORY;
    s->next_number = PARADT__NUMBER_STEP;
    for (i = 0; i < size; i++) s->table[i].tag = PARADT__NO_SPHERE;
    paradt__kept_measure(build);
    PARADT_ASSERT((size & (size - 1)) == 0 && sizeof(paradt__sphere) == 64);
    if (build->count > 4)
        s->next = paradt__centred_of(s, paradt__scene_record(&build->scene, paradt__insertion_point(build, 4)));
    return paradt__list_room(&build->rim, 0, &build->rim_capacity, PARADT__FIRST_DIG, build->memory);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>insertion in space
//
// The insertion once more for three dimensions, with kept spheres. The steps are those of >>insertion: locate, dig,
// star; here the new cells take the places of the cavity's cells. The form differs: there is no branch that processors
// can't predict in any step, and memory is prefetched before it is used. The inner functions have twins for AVX2, so
// they are handed in as a constant (paradt__kept_kernels) to functions that are inlined. Handles are taken apart by
// shifts, as there are four a cell.
//
// While a cavity is dug, a cell is in it if its sphere's tag has PARADT__IN_CAVITY; or the mark PARADT__CONFLICT, if
// the sphere has been driven out of the table. When all of the cavity is dug its vertices have numbers, and a table of
// edges, by the numbers of their ends, takes the place of the table of ridges. Cavities whose rim has more than
// PARADT__MOST_RIM facets, or no table of edges, are starred by >>insertion.
//
// Between two insertions no tag has PARADT__IN_CAVITY, kept->evicted is 0, and kept->next is the point to come.
// Doors: paradt__kept_insert, paradt__kept_insert_any, paradt__kept_number,
// paradt__kept_remake_plain, paradt__kept_make_graded, paradt__new_cells_pad, paradt__kept_fetch_around.

// Finds a cell in conflict with the point, from neighbour to neighbour down the powers. The powers of a point with
// regard to two neighbours differ by an affine function that vanishes on their common facet, so this is a walk towards
// the point. It ends at the first cell that is in conflict for certain. Where powers are too inexact to go on, the walk
// by orientations takes over. Powers are rounded before they are compared: otherwise, of two neighbours with equal
// powers each could be less than the other where one power is in a longer register, and the walk would not end.
PARADT__INLINE paradt_index paradt__kept_locate(paradt__insertion *build, const paradt__centred *centred,
                                                const double *x) {
    paradt_index cell = build->kept->start;
    const paradt__sphere *sphere = paradt__kept_sphere(build, cell);
    double power = paradt__rounded(paradt__sphere_power(sphere, centred)), error = sphere->error;
    while (power >= -error) {
        const paradt_index *links = build->scene.mesh.links + 4 * (size_t)cell;
        double least = power;
        paradt_index best = cell;
        int i;
        for (i = 0; i < 4; i++) {
            paradt_index other = links[i] >> 2;
            double value;
            sphere = paradt__kept_sphere(build, other);
            value = paradt__rounded(paradt__sphere_power(sphere, centred));
            best = value < least ? other : best;
            error = value < least ? sphere->error : error;
            least = value < least ? value : least;
        }
        if (best == cell) return paradt__walk(&build->scene, cell, x);
        cell = best;
        power = least;
    }
    return cell;
}

// What digging works with: parts of the mesh, the update, the rim and paradt__kept, close together
typedef struct paradt__dig {
    paradt_index
        *killed; // the cavity's cells: by the handles by which they were entered; once dug, by their first ones
    paradt_index *rim;
    size_t killed_count, rim_count;
    const paradt_index *links;
    paradt__sphere *table;
    paradt__tag mask;
    int waiting_count;
    const paradt_index *vertices;
    paradt__spoke *spokes;
    uint32_t *numbers, first, next; // of vertices, as in paradt__kept; numbers: that of vertex 0
} paradt__dig;

// Begins to number the vertices of a new cavity. Near the largest number that there is, numbers start again.
PARADT__INLINE void paradt__kept_begin_numbers(const paradt__insertion *build, paradt__dig *dig) {
    paradt__kept *s = build->kept;
    dig->vertices = build->scene.mesh.vertices;
    dig->spokes = s->spokes;
    if (!PARADT__LIKELY(s->next_number <= PARADT__LAST_NUMBER)) {
        memset(s->number, 0, s->numbers * sizeof *s->number);
        s->next_number = PARADT__NUMBER_STEP;
    }
    dig->numbers = s->number + 1;
    dig->first = dig->next = s->next_number;
}

// Gives a vertex of the cavity a number if it has none yet; without a branch, as processors can't predict which.
PARADT__INLINE void paradt__kept_number(paradt__dig *dig, paradt_index vertex) {
    uint32_t number = dig->numbers[vertex], is_new = 0 - (uint32_t)(number < dig->first);
    paradt__spoke_at(dig->spokes, dig->next - dig->first)->vertex = vertex;
    dig->numbers[vertex] = number + ((dig->next - number) & is_new);
    dig->next += is_new & PARADT__NUMBER_STEP;
}

// Keeps numbers in bounds; to be called for every PARADT__DIG_BATCH cells that are dug. The numbers of a cavity with
// more than PARADT__RIM_VERTICES vertices are not used, so they may be given twice.
PARADT__INLINE void paradt__kept_limit_numbers(paradt__dig *dig) {
    uint32_t most = (uint32_t)PARADT__RIM_VERTICES * PARADT__NUMBER_STEP;
    if (dig->next - dig->first > most) dig->next = dig->first + most;
}

// Publishes this cavity's numbering. Numbers only grow, so stale ones are recognised by being below `first`.
PARADT__INLINE void paradt__kept_end_numbers(paradt__kept *s, const paradt__dig *dig) {
    uint32_t most = (uint32_t)PARADT__RIM_VERTICES * PARADT__NUMBER_STEP, end = dig->next - dig->first;
    s->first = dig->first;
    s->spokes_end = end < most ? end : most;
    s->next_number = end < most ? dig->next : dig->first + (uint32_t)sizeof s->spokes;
    s->ghosts = dig->numbers[PARADT__INFINITE] >= dig->first;
    // any vertex will do instead of the infinite one: its record is read, and what is made of it is not used
    if (s->ghosts) paradt__spoke_at(s->spokes, dig->numbers[PARADT__INFINITE] - dig->first)->vertex = 0;
}

// Adds the cell across a facet of the cavity to the cavity, unless it is there, or the facet to the rim; without
// branches. inner: the facet's handle in the cavity's cell; sphere: the slot of the cell across; conflict: 1 or 0
PARADT__INLINE void paradt__kept_judge(paradt__dig *dig, paradt_index inner, paradt__sphere *sphere,
                                       unsigned conflict) {
    unsigned fresh = conflict & !(sphere->tag & PARADT__IN_CAVITY);
    sphere->tag |= conflict ? PARADT__IN_CAVITY : 0;
    dig->killed[dig->killed_count] = dig->links[inner];
    dig->killed_count += fresh;
    dig->rim[dig->rim_count] = inner;
    dig->rim_count += conflict ^ 1;
}

// Lets a facet wait whose sphere across is not in the table, and prefetches the vertices of the cell across. count:
// number of facets that wait so far. Returns their new number.
PARADT__NOINLINE int paradt__kept_wait(const paradt__insertion *build, paradt_index inner, paradt_index other,
                                       int count) {
    PARADT__PREFETCH(build->scene.mesh.vertices + 4 * (size_t)other);
    build->kept->waiting[count] = inner;
    return count + 1;
}

// Looks at the cell across a facet of the cavity: it joins the cavity, the facet joins the rim, or the facet waits.
// inner: the facet's handle in the cavity's cell
PARADT__INLINE void paradt__kept_look(paradt__insertion *build, paradt__dig *dig, const paradt__centred *centred,
                                      const double *x, paradt_index inner) {
    paradt_index handle = dig->links[inner];
    paradt__tag other = (paradt__tag)handle >> 2;
    paradt__sphere *sphere = dig->table + (other & dig->mask);
    double power = paradt__sphere_power(sphere, centred);
    unsigned conflict = power < 0.0;
    PARADT__PREFETCH(dig->links + 4 * (size_t)other);
    if (!PARADT__LIKELY(((sphere->tag & ~PARADT__IN_CAVITY) == other) & (paradt__abs(power) > sphere->error))) {
        if ((sphere->tag & ~PARADT__IN_CAVITY) != other && dig->waiting_count < PARADT__MOST_WAITING) {
            dig->waiting_count = paradt__kept_wait(build, inner, (paradt_index)other, dig->waiting_count);
            return;
        }
        conflict = paradt__kept_settle(build, (paradt_index)other, centred, x);
    }
    paradt__kept_judge(dig, inner, sphere, conflict);
}

// New cells that are no ghosts: first handles, and the offsets of their vertices' spokes; with room for three more
typedef struct paradt__new_cells {
    paradt_index *base;
    uint16_t (*offsets)[4];
    int count;
} paradt__new_cells;

// The inner functions that have versions for an instruction set; two of them are handed on alone
typedef void (*paradt__remake_kernel)(const paradt__insertion *build, const paradt_index *waiting, int count);
typedef void (*paradt__links_kernel)(paradt_index *links, paradt_index a, paradt_index b, paradt_index c,
                                     paradt_index d);

typedef struct paradt__kept_kernels {
    // Digs the cells of the cavity from number `head` on, as long as the lists have room; facets may wait. Returns the
    // number of cells that are dug.
    size_t (*spread)(paradt__insertion *build, paradt__dig *work, const paradt__centred *centred, const double *x,
                     size_t head);
    // Makes the missing spheres of the cells across facets that wait. Some may be missing again afterwards: of two
    // cells with the same slot one drives out the other.
    paradt__remake_kernel remake;
    // Makes the spheres of new cells, and chooses kept->start among them.
    void (*make)(const paradt__insertion *build, paradt__new_cells *star, const double *x,
                 const paradt__centred *centred);
    // Fills the row of a new cell: a cell's vertices but for one, and the point last.
    void (*fill_row)(paradt_index *row, const paradt_index *cell, int without, paradt_index point);
    // Stores the four links of a new cell.
    paradt__links_kernel store_links;
} paradt__kept_kernels;

// The kernel `remake`
static void paradt__kept_remake_plain(const paradt__insertion *build, const paradt_index *waiting, int count) {
    int i;
    for (i = 0; i < count; i++) paradt__kept_sphere(build, build->scene.mesh.links[waiting[i]] >> 2);
}

// Looks at the facets that wait, whose spheres are made again together. Of the vertices of the cell across a facet the
// one opposite the facet is the least likely to be in a cache, so it is prefetched.
PARADT__NOINLINE void paradt__kept_look_waiting(paradt__insertion *build, paradt__dig *dig,
                                                const paradt__centred *centred, const double *x,
                                                paradt__remake_kernel remake) {
    const paradt_index *waiting = build->kept->waiting;
    int i, count = dig->waiting_count;
    for (i = 0; i < count; i++) {
        paradt_index opposite = build->scene.mesh.vertices[dig->links[waiting[i]]];
        PARADT__PREFETCH(paradt__scene_record(&build->scene, opposite >= 0 ? opposite : 0));
    }
    remake(build, waiting, count);
    for (i = 0; i < count; i++) {
        paradt__tag other = (paradt__tag)dig->links[waiting[i]] >> 2;
        paradt__kept_judge(dig, waiting[i], dig->table + (other & dig->mask),
                           paradt__kept_settle(build, (paradt_index)other, centred, x));
    }
    dig->waiting_count = 0;
}

// The kernel `spread`. Numbers vertices, too: of the vertices of a cell, only the one opposite the facet by which the
// cell was entered has not been met.
static size_t paradt__kept_spread_plain(paradt__insertion *build, paradt__dig *work, const paradt__centred *point,
                                        const double *x, size_t head) {
    size_t cells = build->update.killed_capacity - PARADT__DIG_ROOM, facets = build->rim_capacity - PARADT__DIG_ROOM;
    paradt__dig dig = *work;
    paradt__centred centred = *point;
    size_t last = head + PARADT__DIG_BATCH;
    // the first cell was entered across no facet, so all four are looked at
    if (!head) paradt__kept_look(build, &dig, &centred, x, dig.killed[0]);
    for (; head < last && head < dig.killed_count && dig.killed_count <= cells && dig.rim_count <= facets; head++) {
        paradt_index entry = dig.killed[head], base = entry & ~(paradt_index)3;
        dig.killed[head] = base;
        paradt__kept_number(&dig, dig.vertices[entry]);
        paradt__kept_look(build, &dig, &centred, x, base | ((entry + 1) & 3));
        paradt__kept_look(build, &dig, &centred, x, base | ((entry + 2) & 3));
        paradt__kept_look(build, &dig, &centred, x, base | ((entry + 3) & 3));
    }
    *work = dig;
    return head;
}

// Digs the cavity of x from the cell `first`, which is in conflict with x. Fills update.killed with the cells' first
// handles, and the rim; and numbers the cavity's vertices.
PARADT__INLINE paradt_status paradt__kept_dig(paradt__insertion *build, paradt_index first,
                                              const paradt__centred *centred, const double *x,
                                              const paradt__kept_kernels *kernels) {
    size_t head = 0, i;
    paradt__dig dig;
    dig.killed = build->update.killed;
    dig.rim = build->rim;
    dig.links = build->scene.mesh.links;
    dig.table = build->kept->table;
    dig.mask = build->kept->mask;
    PARADT_ASSERT(*paradt__mesh_row(&build->scene.mesh, first) != PARADT__DEAD);
    dig.killed[0] = 4 * first;
    dig.killed_count = 1;
    dig.rim_count = 0;
    dig.waiting_count = 0;
    paradt__kept_sphere(build, first);
    dig.table[(paradt__tag)first & dig.mask].tag |= PARADT__IN_CAVITY;
    paradt__kept_begin_numbers(build, &dig);
    for (i = 1; i < 4; i++) paradt__kept_number(&dig, dig.vertices[4 * (size_t)first + i]);
    for (;;) {
        paradt_status status;
        head = kernels->spread(build, &dig, centred, x, head);
        paradt__kept_limit_numbers(&dig);
        if (head == dig.killed_count && !dig.waiting_count) break;
        if (dig.waiting_count) paradt__kept_look_waiting(build, &dig, centred, x, kernels->remake);
        status = paradt__list_room(&build->update.killed, dig.killed_count, &build->update.killed_capacity,
                                   dig.killed_count + PARADT__DIG_ROOM, build->memory);
        if (!status)
            status = paradt__list_room(&build->rim, dig.rim_count, &build->rim_capacity,
                                       dig.rim_count + PARADT__DIG_ROOM, build->memory);
        if (status) return status;
        dig.killed = build->update.killed;
        dig.rim = build->rim;
    }
    build->update.killed_count = dig.killed_count;
    build->rim_count = dig.rim_count;
    paradt__kept_end_numbers(build->kept, &dig);
    PARADT_ASSERT(dig.rim_count >= 4 && dig.rim_count % 2 == 0);
    PARADT_ASSERT(dig.rim_count > PARADT__MOST_RIM ||
                  build->kept->spokes_end == (2 + dig.rim_count / 2) * PARADT__NUMBER_STEP);
    return PARADT_OK;
}

// Allocates a table of edges that is large enough for the cavity's rim, unless it would take more than half of the
// memory that the cells take; the largest table, which few stars need, may take an eighth of it. If there is no memory
// there is no table.
PARADT__NOINLINE void paradt__kept_widen(paradt__insertion *build) {
    paradt__kept *s = build->kept;
    size_t star = PARADT__WIDE_RIM, vertices, units;
    if (build->rim_count <= PARADT__WIDE_RIM || build->rim_count <= s->large_rim || build->rim_count > PARADT__MOST_RIM)
        return;
    while (star < build->rim_count) star *= 2;
    vertices = 2 + star / 2;
    units = (vertices + PARADT__EDGE_UNIT - 1) / PARADT__EDGE_UNIT | 1; // odd: columns spread over the sets of a cache
    if (vertices * units * PARADT__EDGE_UNIT > build->scene.mesh.count * (star < PARADT__MOST_RIM ? 4 : 1)) return;
    paradt__release(build->memory, s->large_edges);
    s->large_rim = 0;
    s->large_edges =
        (paradt_index *)paradt__alloc(build->memory, vertices * units * PARADT__EDGE_UNIT, sizeof *s->large_edges);
    if (!s->large_edges) return;
    s->large_rim = star;
    s->large_units = units;
}

// The kernel `fill_row`
static void paradt__kept_row_plain(paradt_index *row, const paradt_index *cell, int without, paradt_index point) {
    const unsigned char *order = paradt__facet_order[without];
    paradt_index a = cell[order[0]], b = cell[order[1]], c = cell[order[2]];
    row[0] = a;
    row[1] = b;
    row[2] = c;
    row[3] = point;
}

// Returns the index of an edge in a table of edges. from, to: offsets of its ends; units: of the table's rows
PARADT__INLINE size_t paradt__edge_index(size_t from, size_t to, size_t units) {
    return from * (PARADT__EDGE_UNIT * units / sizeof(paradt__spoke)) + to / sizeof(paradt__spoke);
}

// Fills kept->row and kept->outer.
PARADT__INLINE void paradt__kept_rows(paradt__insertion *build, paradt_index point,
                                      const paradt__kept_kernels *kernels) {
    paradt__kept *s = build->kept;
    const paradt_index *vertices = build->scene.mesh.vertices, *links = build->scene.mesh.links, *rim = build->rim;
    size_t i, count = build->rim_count;
    for (i = 0; i < count; i++) {
        paradt__tag inner = (paradt__tag)rim[i];
        kernels->fill_row(s->row[i], vertices + (inner & ~(paradt__tag)3), (int)(inner & 3), point);
        s->outer[i] = links[inner];
        PARADT_ASSERT(s->table[(paradt__tag)s->outer[i] >> 2 & s->mask].tag !=
                      ((paradt__tag)s->outer[i] >> 2 | PARADT__IN_CAVITY));
    }
}

// Enters the edges of the rim into a table, and fills kept->offsets.
PARADT__INLINE void paradt__kept_enter_edges(paradt__insertion *build, paradt_index *edges, size_t units) {
    paradt__kept *s = build->kept;
    const uint32_t *numbers = s->number + 1, first = s->first;
    size_t i, count = build->rim_count;
    for (i = 0; i < count; i++) {
        const paradt_index *row = s->row[i];
        size_t a = numbers[row[0]] - first, b = numbers[row[1]] - first, c = numbers[row[2]] - first;
        paradt_index base = build->update.made[i];
        uint16_t *offsets = s->offsets[i];
        offsets[0] = (uint16_t)a;
        offsets[1] = (uint16_t)b;
        offsets[2] = (uint16_t)c;
        PARADT_ASSERT(a < s->spokes_end && b < s->spokes_end && c < s->spokes_end);
        edges[paradt__edge_index(b, c, units)] = base;
        edges[paradt__edge_index(c, a, units)] = base + 1;
        edges[paradt__edge_index(a, b, units)] = base + 2;
    }
}

// The kernel `store_links`
static void paradt__kept_links_plain(paradt_index *links, paradt_index a, paradt_index b, paradt_index c,
                                     paradt_index d) {
    links[0] = a;
    links[1] = b;
    links[2] = c;
    links[3] = d;
}

// Stores the new cells at their places, and links them. A new cell sees an edge of the rim from b to c; its neighbour
// there sees it from c to b.
PARADT__INLINE void paradt__kept_star(paradt__insertion *build, const paradt_index *edges, size_t units,
                                      paradt__links_kernel store_links) {
    const paradt__kept *s = build->kept;
    paradt_index *vertices = build->scene.mesh.vertices, *links = build->scene.mesh.links;
    size_t i, count = build->rim_count;
    for (i = 0; i < count; i++) {
        paradt__tag base = (paradt__tag)build->update.made[i], outer = (paradt__tag)s->outer[i];
        size_t a = s->offsets[i][0], b = s->offsets[i][1], c = s->offsets[i][2];
        memcpy(vertices + base, s->row[i], sizeof s->row[i]);
        store_links(links + base, edges[paradt__edge_index(c, b, units)], edges[paradt__edge_index(a, c, units)],
                    edges[paradt__edge_index(b, a, units)], (paradt_index)outer);
        links[outer] = (paradt_index)(base + 3);
    }
}

// Stores and links the new cells by a table of edges. units: of its rows; a constant for common stars
PARADT__INLINE void paradt__kept_link(paradt__insertion *build, paradt_index *edges, size_t units,
                                      paradt__links_kernel store_links) {
    paradt__kept_enter_edges(build, edges, units);
    paradt__kept_star(build, edges, units, store_links);
}

// Stores and links the new cells of a star that is larger than common ones.
PARADT__NOINLINE void paradt__kept_link_uncommon(paradt__insertion *build) {
    paradt__kept *s = build->kept;
    if (build->rim_count <= PARADT__WIDE_RIM)
        paradt__kept_link(build, s->wide_edges, PARADT__WIDE_UNITS, paradt__kept_links_plain);
    else paradt__kept_link(build, s->large_edges, s->large_units, paradt__kept_links_plain);
}

// Takes places for the new cells: those of the cavity's cells, then more. Fills update.made with their first handles.
// Slots of places that have not been used lately are prefetched for the cells to come.
PARADT__INLINE paradt_status paradt__kept_places(paradt__insertion *build) {
    enum { TOGETHER = 8 }; // handles that are copied together: both lists have room behind their last one
    const paradt__kept *s = build->kept;
    paradt__mesh *mesh = &build->scene.mesh;
    paradt__update *update = &build->update;
    size_t count = build->rim_count, killed = update->killed_count, reused = killed < count ? killed : count, i;
    paradt_status status = killed < count ? paradt__insertion_room(build, count - killed) : PARADT_OK;
    if (!status) status = paradt__list_room(&update->made, 0, &update->made_capacity, count + TOGETHER, build->memory);
    if (status) return status;
    for (i = 0; i < reused; i += TOGETHER)
        memcpy(update->made + i, update->killed + i, TOGETHER * sizeof *update->made);
    for (i = reused; i < count; i++) {
        update->made[i] = 4 * paradt__mesh_take(mesh);
        PARADT__PREFETCH_TO_WRITE(s->table + ((paradt__tag)(mesh->count + PARADT__PLACES_AHEAD) & s->mask));
    }
    update->made_count = count;
    return PARADT_OK;
}

// Repeats the last of the new cells up to a multiple of four.
PARADT__INLINE void paradt__new_cells_pad(paradt__new_cells *star) {
    int last = star->count - 1, i;
    for (i = star->count; i % 4; i++) {
        star->base[i] = star->base[last];
        memcpy(star->offsets[i], star->offsets[last], sizeof star->offsets[i]);
    }
}

// Four new cells that are no ghosts, in lanes: the edges to their vertices, and what is made of them
typedef struct paradt__four_cells {
    double edge[3][4][4]; // [vertex][as in paradt__spoke][lane]
    double normal[3][4], constant[4], error[4], power[4];
    double least[4], least_at[4]; // by lane the least power so far, and the index of the first cell of that four
} paradt__four_cells;

// Fills the edges. offsets: of the four cells
PARADT__INLINE void paradt__four_load(paradt__four_cells *four, paradt__kept *s, uint16_t (*offsets)[4]) {
    int lane, vertex, axis;
    for (lane = 0; lane < 4; lane++) {
        for (vertex = 0; vertex < 3; vertex++) {
            const double *edge = paradt__spoke_at(s->spokes, offsets[lane][vertex])->edge;
            for (axis = 0; axis < 4; axis++) four->edge[vertex][axis][lane] = edge[axis];
        }
    }
}

// Makes the spheres of the four cells, and the next point's powers. p: the new point; at: index of the first cell
PARADT__INLINE void paradt__four_make(paradt__four_cells *four, paradt__making making, const paradt__frame *frame,
                                      const paradt__centred *p, const paradt__centred *next, double at) {
    double(*a)[4] = four->edge[0], (*b)[4] = four->edge[1], (*c)[4] = four->edge[2];
    int lane, axis;
    for (lane = 0; lane < 4; lane++) {
        const double to_a[4] = {a[0][lane], a[1][lane], a[2][lane], a[3][lane]};
        const double to_b[4] = {b[0][lane], b[1][lane], b[2][lane], b[3][lane]};
        const double to_c[4] = {c[0][lane], c[1][lane], c[2][lane], c[3][lane]};
        double n[3], d, e;
        paradt__sphere_make(making, frame, p, to_b, to_a, to_c, n, &d, &e);
        for (axis = 0; axis < 3; axis++) four->normal[axis][lane] = n[axis];
        four->constant[lane] = d;
        four->error[lane] = e;
        four->power[lane] = (next->lift + d) + (n[0] * next->s[0] + n[1] * next->s[1] + n[2] * next->s[2]);
        four->least_at[lane] = four->power[lane] < four->least[lane] ? at : four->least_at[lane];
        four->least[lane] = four->power[lane] < four->least[lane] ? four->power[lane] : four->least[lane];
    }
}

// Stores the spheres of the four cells in the table. base: the cells' first handles
PARADT__INLINE void paradt__four_put(const paradt__four_cells *four, const paradt__kept *s, const paradt_index *base) {
    int lane, axis;
    for (lane = 0; lane < 4; lane++) {
        paradt__tag cell = (paradt__tag)base[lane] >> 2;
        paradt__sphere *to = s->table + (cell & s->mask);
        for (axis = 0; axis < 3; axis++) to->normal[axis] = four->normal[axis][lane];
        to->constant = four->constant[lane];
        to->error = four->error[lane];
        to->tag = cell;
    }
}

// The kernel `make` for one kind of spheres. The code of four cells has no branches, so that compilers can make vectors
// of the lanes.
PARADT__INLINE void paradt__kept_make_any(paradt__making making, const paradt__insertion *build,
                                          paradt__new_cells *star, const double *x, const paradt__centred *centred) {
    paradt__kept *s = build->kept;
    const paradt__frame frame = s->frame;
    paradt__centred p = *centred, next = s->next;
    paradt__four_cells four;
    paradt__spoke *spoke = s->spokes, *end = paradt__spoke_at(spoke, s->spokes_end);
    int i, lane, best = 0;
    for (; spoke < end; spoke++)
        *spoke = paradt__spoke_of(making, x, paradt__scene_record(&build->scene, spoke->vertex));
    for (lane = 0; lane < 4; lane++) {
        four.least[lane] = PARADT__NO_ERROR_BOUND;
        four.least_at[lane] = 0.0;
    }
    paradt__new_cells_pad(star);
    for (i = 0; i < star->count; i += 4) {
        paradt__four_load(&four, s, star->offsets + i);
        paradt__four_make(&four, making, &frame, &p, &next, i);
        paradt__four_put(&four, s, star->base + i);
    }
    for (lane = 1; lane < 4; lane++) best = four.least[lane] < four.least[best] ? lane : best;
    s->start = star->base[(int)four.least_at[best] + best] >> 2;
}

// The kernel `make` for sharp bounds
PARADT__NOINLINE void paradt__kept_make_sharp_plain(const paradt__insertion *build, paradt__new_cells *star,
                                                    const double *x, const paradt__centred *centred) {
    paradt__kept_make_any(PARADT__MAKE_SHARP, build, star, x, centred);
}

// The kernel `make` for sagittas; it has no twin for AVX2
PARADT__NOINLINE void paradt__kept_make_graded(const paradt__insertion *build, paradt__new_cells *star, const double *x,
                                               const paradt__centred *centred) {
    paradt__kept_make_any(PARADT__MAKE_GRADED, build, star, x, centred);
}

// The kernel `make`
static void paradt__kept_make_plain(const paradt__insertion *build, paradt__new_cells *star, const double *x,
                                    const paradt__centred *centred) {
    paradt__making making = build->kept->making;
    if (PARADT__LIKELY(making == PARADT__MAKE_QUICKLY))
        paradt__kept_make_any(PARADT__MAKE_QUICKLY, build, star, x, centred);
    else if (making == PARADT__MAKE_SHARP) paradt__kept_make_sharp_plain(build, star, x, centred);
    else paradt__kept_make_graded(build, star, x, centred);
}

// Makes the functions of the ghosts among the new cells, and fills `star` with the other new cells. Tells them apart
// without branches, as processors can't predict which is which: ghosts fill its lists from the end, the others from the
// beginning.
PARADT__NOINLINE void paradt__kept_ghosts(paradt__insertion *build, paradt__new_cells *star, const double *x,
                                          const paradt__centred *centred) {
    paradt__kept *s = build->kept;
    const size_t rim = build->rim_count;
    const paradt_index *made = build->update.made;
    paradt_index *base = s->finite_base;
    size_t count = 0, end = rim, i;
    for (i = 0; i < rim; i++) {
        size_t is_ghost = (s->row[i][0] | s->row[i][1] | s->row[i][2]) < 0, at = is_ghost ? end - 1 : count;
        base[at] = made[i];
        memcpy(s->finite_offsets[at], s->offsets[i], sizeof s->offsets[i]);
        count += is_ghost ^ 1;
        end -= is_ghost;
    }
    for (i = end; i < rim; i++) {
        const paradt_index *vertices = build->scene.mesh.vertices + base[i];
        paradt__tag cell = (paradt__tag)base[i] >> 2;
        paradt__sphere *sphere = s->table + (cell & s->mask);
        // the facet's vertices in the order of paradt__facet_order, from the point on, which is the cell's last vertex
        int q = vertices[0] < 0 ? 2 : vertices[1] < 0 ? 0 : 1, r = q ? q - 1 : 2;
        paradt__sphere_of_facet(s, sphere, centred, x, paradt__scene_record(&build->scene, vertices[q]),
                                paradt__scene_record(&build->scene, vertices[r]));
        sphere->tag = cell;
    }
    star->base = base;
    star->offsets = s->finite_offsets;
    star->count = (int)count;
}

// Makes the spheres of the new cells, and chooses where the search for the next point starts.
PARADT__INLINE void paradt__kept_spheres(paradt__insertion *build, const double *x, const paradt__centred *centred,
                                         const paradt__kept_kernels *kernels) {
    paradt__kept *s = build->kept;
    paradt__new_cells star;
    star.base = build->update.made;
    star.offsets = s->offsets;
    star.count = (int)build->rim_count;
    s->start = build->update.made[0] >> 2;
    if (!PARADT__LIKELY(!s->ghosts)) paradt__kept_ghosts(build, &star, x, centred);
    if (star.count) kernels->make(build, &star, x, centred);
}

// Gives back the places of the cavity's cells from number `first` on, and takes their spheres out of the table.
static paradt_status paradt__kept_clear(paradt__insertion *build, size_t first) {
    paradt__kept *s = build->kept;
    const paradt__update *update = &build->update;
    size_t i;
    paradt_status status = paradt__mesh_spare_room(&build->scene.mesh, update->killed_count - first, build->memory);
    if (status) return status;
    for (i = first; i < update->killed_count; i++) {
        paradt__tag cell = (paradt__tag)update->killed[i] >> 2, *tag = &s->table[cell & s->mask].tag;
        if (*tag & PARADT__IN_CAVITY) *tag = PARADT__NO_SPHERE;
        paradt__mesh_give(&build->scene.mesh, (paradt_index)cell, 4);
    }
    return PARADT_OK;
}

// Stars a cavity whose rim is too large for the tables of edges, by >>insertion.
static paradt_status paradt__kept_star_large(paradt__insertion *build, paradt_index point) {
    paradt__kept *s = build->kept;
    paradt_status status = paradt__cavity_star(build, point);
    size_t i;
    for (i = 0; i < build->update.made_count && !status; i++) {
        paradt__tag cell = (paradt__tag)build->update.made[i] >> 2;
        s->table[cell & s->mask].tag = PARADT__NO_SPHERE;
    }
    s->start = build->scene.hint;
    return status ? status : paradt__kept_clear(build, 0);
}

// Prepares the next insertion: sets kept->next, and prefetches the record of a later point.
PARADT__INLINE void paradt__kept_look_ahead(const paradt__insertion *build) {
    paradt__kept *s = build->kept;
    size_t next = build->inserted + 1, later = build->inserted + PARADT__INSERTIONS_AHEAD;
    if (next < build->count)
        s->next = paradt__centred_of(s, paradt__scene_record(&build->scene, paradt__insertion_point(build, next)));
    if (later < build->count)
        PARADT__PREFETCH(paradt__scene_record(&build->scene, paradt__insertion_point(build, later)));
}

// After digging: takes back the marks that stood in for evicted spheres, counts, and adapts if there is reason to.
PARADT__INLINE void paradt__kept_dug(paradt__insertion *build) {
    paradt__kept *s = build->kept;
    size_t i;
    for (i = 0; s->evicted && i < build->update.killed_count; i++)
        build->scene.mesh.marks[build->update.killed[i] >> 2] = 0;
    s->evicted = 0;
    s->made_count += build->rim_count;
    if (!PARADT__LIKELY(s->missed_count + s->doubtful_count <= s->mask)) paradt__kept_adapt(build);
}

// Inserts a point that is kept->next: locate, dig, star. Inlined with constant kernels
PARADT__INLINE paradt_status paradt__kept_insert_any(paradt__insertion *build, paradt_index point,
                                                     const paradt__kept_kernels *kernels) {
    paradt__kept *s = build->kept;
    const double *x = paradt__scene_record(&build->scene, point);
    paradt__centred centred = s->next;
    paradt_index first = paradt__kept_locate(build, &centred, x);
    paradt_status status = paradt__kept_dig(build, first, &centred, x, kernels);
    int is_common;
    if (status) return status;
    paradt__kept_look_ahead(build);
    paradt__kept_dug(build);
    is_common = build->rim_count <= PARADT__COMMON_RIM;
    if (!PARADT__LIKELY(is_common)) paradt__kept_widen(build);
    if (!PARADT__LIKELY(is_common) && build->rim_count > PARADT__WIDE_RIM && build->rim_count > s->large_rim)
        return paradt__kept_star_large(build, point);
    status = paradt__kept_places(build);
    if (status) return status;
    paradt__kept_rows(build, point, kernels);
    if (PARADT__LIKELY(is_common))
        paradt__kept_link(build, s->common_edges, PARADT__COMMON_VERTICES / PARADT__EDGE_UNIT, kernels->store_links);
    else paradt__kept_link_uncommon(build);
    paradt__kept_spheres(build, x, &centred, kernels);
    PARADT_ASSERT(build->update.made_count == build->rim_count);
    return build->rim_count < build->update.killed_count ? paradt__kept_clear(build, build->rim_count) : PARADT_OK;
}

// Inserts the point kept->next, by plain kernels.
static paradt_status paradt__kept_insert(paradt__insertion *build, paradt_index point) {
    const paradt__kept_kernels kernels = {paradt__kept_spread_plain, paradt__kept_remake_plain, paradt__kept_make_plain,
                                          paradt__kept_row_plain, paradt__kept_links_plain};
    return paradt__kept_insert_any(build, point, &kernels);
}

// Prefetches what the insertion of a point in conflict with the cell looks at, up to three facets away. If nothing of
// it is in a cache, the insertion would otherwise wait for one thing after another.
PARADT__INLINE void paradt__kept_fetch_around(const paradt__insertion *build, paradt_index cell) {
    enum { CELLS = 1 + 4 + 12 }; // at distances 0, 1 and 2
    const paradt__kept *s = build->kept;
    paradt_index around[CELLS];
    size_t count = 1, i, j;
    around[0] = cell;
    for (i = 0; i < count; i++) {
        const paradt_index *vertices = build->scene.mesh.vertices + 4 * (size_t)around[i];
        const paradt_index *links = build->scene.mesh.links + 4 * (size_t)around[i];
        for (j = 0; j < 4; j++) {
            paradt_index other = links[j] >> 2;
            paradt__fetch_row(build->scene.mesh.vertices, build->scene.mesh.links, (size_t)other, 4);
            PARADT__PREFETCH(s->table + ((paradt__tag)other & s->mask));
            if (vertices[j] >= 0) PARADT__PREFETCH(paradt__scene_record(&build->scene, vertices[j]));
            if (count < CELLS) around[count++] = other;
        }
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// >>insertion in space by AVX2
//
// The kernels of >>insertion in space for four facets, cells or vertices together, chosen at run time where the
// processor has AVX2 and FMA. They differ from the plain ones in the last bits of powers at most, and powers decide
// nothing where these bits matter. In names `four` stands for four lanes.
// Doors: paradt__kept_insert_avx2,
// paradt__dot_avx2, paradt__four_spheres, paradt__four_differences.

#if defined(PARADT__AVX2) && !defined(PARADT_INDEX64)
#define PARADT__KEPT_AVX2 1

// By mask: the shuffle that moves the elements, of four, whose bits the mask has to the front
#define PARADT__LANE(i) 4 * (i), 4 * (i) + 1, 4 * (i) + 2, 4 * (i) + 3
static const unsigned char paradt__packing[16][16] = {
    {PARADT__LANE(0), PARADT__LANE(0), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(0), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(1), PARADT__LANE(0), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(1), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(2), PARADT__LANE(0), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(2), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(1), PARADT__LANE(2), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(1), PARADT__LANE(2), PARADT__LANE(0)},
    {PARADT__LANE(3), PARADT__LANE(0), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(3), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(1), PARADT__LANE(3), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(1), PARADT__LANE(3), PARADT__LANE(0)},
    {PARADT__LANE(2), PARADT__LANE(3), PARADT__LANE(0), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(2), PARADT__LANE(3), PARADT__LANE(0)},
    {PARADT__LANE(1), PARADT__LANE(2), PARADT__LANE(3), PARADT__LANE(0)},
    {PARADT__LANE(0), PARADT__LANE(1), PARADT__LANE(2), PARADT__LANE(3)},
};

// Returns the elements with the bits of the mask moved to the front.
PARADT__AVX2 PARADT__INLINE __m128i paradt__packed(__m128i elements, unsigned mask) {
    return _mm_shuffle_epi8(elements, _mm_loadu_si128((const __m128i *)(const void *)paradt__packing[mask]));
}

// The slots of four cells; each may hold another cell's sphere.
typedef struct paradt__four_slots {
    char *a, *b, *c, *d;
} paradt__four_slots;

enum { PARADT__ERROR_AT = offsetof(paradt__sphere, error), PARADT__TAG_AT = offsetof(paradt__sphere, tag) };

// Returns the slots of the four cells across the facets of a cell. links: of this cell. Vectors would take longer.
PARADT__INLINE paradt__four_slots paradt__four_across(const paradt__dig *dig, const paradt_index *links) {
    const paradt__tag mask = 4 * dig->mask; // of first handles: 16 times such a handle is 64 times the cell's place
    char *table = (char *)dig->table;
    paradt__four_slots at;
    at.a = table + 16 * (size_t)((paradt__tag)links[0] & mask);
    at.b = table + 16 * (size_t)((paradt__tag)links[1] & mask);
    at.c = table + 16 * (size_t)((paradt__tag)links[2] & mask);
    at.d = table + 16 * (size_t)((paradt__tag)links[3] & mask);
    return at;
}

// Returns the products that a sphere's affine function is the sum of.
PARADT__AVX2 PARADT__INLINE __m256d paradt__terms(const char *sphere, __m256d query) {
    return _mm256_mul_pd(_mm256_load_pd((const double *)(const void *)sphere), query);
}

// Returns a point's powers with regard to four spheres. query: its coordinates and 1; lift: its lift, four times
PARADT__AVX2 PARADT__INLINE __m256d paradt__four_powers(paradt__four_slots at, __m256d query, __m256d lift) {
    __m256d ab = _mm256_hadd_pd(paradt__terms(at.a, query), paradt__terms(at.b, query));
    __m256d cd = _mm256_hadd_pd(paradt__terms(at.c, query), paradt__terms(at.d, query));
    __m256d ends = _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x31), lift);
    return _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x20), ends);
}

// Returns the errors of two spheres.
PARADT__AVX2 PARADT__INLINE __m128d paradt__two_errors(const char *a, const char *b) {
    __m128d error = _mm_load_sd((const double *)(const void *)(a + PARADT__ERROR_AT));
    return _mm_loadh_pd(error, (const double *)(const void *)(b + PARADT__ERROR_AT));
}

PARADT__AVX2 PARADT__INLINE __m256d paradt__four_errors(paradt__four_slots at) {
    __m128d ab = paradt__two_errors(at.a, at.b), cd = paradt__two_errors(at.c, at.d);
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(ab), cd, 1);
}

PARADT__INLINE int *paradt__tag_at(char *sphere) {
    return (int *)(void *)(sphere + PARADT__TAG_AT);
}

PARADT__AVX2 PARADT__INLINE __m128i paradt__four_tags(paradt__four_slots at) {
    __m128i tags = _mm_cvtsi32_si128(*paradt__tag_at(at.a));
    tags = _mm_insert_epi32(tags, *paradt__tag_at(at.b), 1);
    tags = _mm_insert_epi32(tags, *paradt__tag_at(at.c), 2);
    return _mm_insert_epi32(tags, *paradt__tag_at(at.d), 3);
}

// Stores the tags of four cells, with PARADT__IN_CAVITY where the power is negative: the signs, narrowed to 32 bits.
PARADT__AVX2 PARADT__INLINE void paradt__four_mark(paradt__four_slots at, __m128i cells, __m256d power) {
    __m128i tags = _mm_castps_si128(_mm_shuffle_ps(_mm_castpd_ps(_mm256_castpd256_pd128(power)),
                                                   _mm_castpd_ps(_mm256_extractf128_pd(power, 1)), 0xdd));
    tags = _mm_or_si128(cells, _mm_and_si128(tags, _mm_set1_epi32((int)PARADT__IN_CAVITY)));
    *paradt__tag_at(at.a) = _mm_cvtsi128_si32(tags);
    *paradt__tag_at(at.b) = _mm_extract_epi32(tags, 1);
    *paradt__tag_at(at.c) = _mm_extract_epi32(tags, 2);
    *paradt__tag_at(at.d) = _mm_extract_epi32(tags, 3);
}

// Returns a mask of the negative elements.
PARADT__AVX2 PARADT__INLINE unsigned paradt__signs_avx2(__m128i x) {
    return (unsigned)_mm_movemask_ps(_mm_castsi128_ps(x));
}

// The kernel `spread`. A facet waits if the sphere of the cell across is missing or the power with regard to it does
// not tell. The order of the statements matters for speed.
PARADT__AVX2 static size_t paradt__kept_spread_avx2(paradt__insertion *build, paradt__dig *work,
                                                    const paradt__centred *centred, const double *x, size_t head) {
    paradt__dig dig = *work;
    const size_t cells = build->update.killed_capacity - PARADT__DIG_ROOM - dig.killed_count;
    const size_t facets = build->rim_capacity - PARADT__DIG_ROOM - dig.rim_count;
    const size_t room = (cells < facets ? cells : facets) / 4;
    const __m256d query = _mm256_setr_pd(centred->s[0], centred->s[1], centred->s[2], 1.0);
    const __m256d lift = _mm256_set1_pd(centred->lift), sign = _mm256_set1_pd(-0.0);
    const __m128i marks = _mm_set1_epi32((int)PARADT__IN_CAVITY), order = _mm_setr_epi32(0, 1, 2, 3);
    paradt_index *cell = dig.killed + head, *end = dig.killed + dig.killed_count, *rim = dig.rim + dig.rim_count;
    paradt_index *last = cell + (room < PARADT__DIG_BATCH ? room : PARADT__DIG_BATCH - 1);
    paradt__sphere nowhere; // where tags are stored that are not to be
    (void)x;
    for (; cell < end && cell <= last; cell++) {
        paradt_index entry = *cell, base = entry & ~(paradt_index)3;
        const paradt_index *row = dig.links + (paradt__tag)base;
        __m128i across = _mm_loadu_si128((const __m128i *)(const void *)row), others = _mm_srli_epi32(across, 2);
        __m128i here = _mm_castps_si128(_mm_broadcast_ss((const float *)(const void *)cell)), tags;
        paradt__four_slots at = paradt__four_across(&dig, row);
        __m256d power = paradt__four_powers(at, query, lift), error = paradt__four_errors(at);
        unsigned inside = (unsigned)_mm256_movemask_pd(power), outside, sure, fresh;
        here = _mm_or_si128(_mm_andnot_si128(_mm_set1_epi32(3), here), order);
        *cell = base;
        paradt__kept_number(&dig, dig.vertices[entry]);
        tags = paradt__four_tags(at);
        sure = (unsigned)_mm256_movemask_pd(_mm256_cmp_pd(_mm256_andnot_pd(sign, power), error, _CMP_GT_OQ)) &
               paradt__signs_avx2(_mm_cmpeq_epi32(_mm_andnot_si128(marks, tags), others));
        outside = ~inside & 15;
        // what the next rounds of this loop and the new cells' links will touch
        PARADT__PREFETCH(dig.links + (paradt__tag)row[0]);
        PARADT__PREFETCH(dig.links + (paradt__tag)row[1]);
        PARADT__PREFETCH(dig.links + (paradt__tag)row[2]);
        PARADT__PREFETCH(dig.links + (paradt__tag)row[3]);
        if (!PARADT__LIKELY(sure == 15)) {
            int i;
            for (i = 0; i < 4; i++) PARADT__PREFETCH(dig.vertices + row[i]);
            _mm_storeu_si128((__m128i *)(void *)(build->kept->waiting + dig.waiting_count),
                             paradt__packed(here, sure ^ 15));
            dig.waiting_count += __builtin_popcount(sure ^ 15);
            if (dig.waiting_count > PARADT__MOST_WAITING - 4) last = cell;
            at.a = sure & 1 ? at.a : (char *)&nowhere;
            at.b = sure & 2 ? at.b : (char *)&nowhere;
            at.c = sure & 4 ? at.c : (char *)&nowhere;
            at.d = sure & 8 ? at.d : (char *)&nowhere;
            inside &= sure;
            outside &= sure;
        }
        fresh = inside & ~paradt__signs_avx2(tags);
        paradt__four_mark(at, others, power);
        _mm_storeu_si128((__m128i *)(void *)end, paradt__packed(across, fresh));
        end += __builtin_popcount(fresh);
        _mm_storeu_si128((__m128i *)(void *)rim, paradt__packed(here, outside));
        rim += __builtin_popcount(outside);
    }
    dig.killed_count = (size_t)(end - dig.killed);
    dig.rim_count = (size_t)(rim - dig.rim);
    *work = dig;
    return (size_t)(cell - dig.killed);
}

PARADT__AVX2 PARADT__INLINE __m256d paradt__abs_avx2(__m256d x) {
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x);
}

PARADT__AVX2 PARADT__INLINE __m256d paradt__dot_avx2(const __m256d *a, const __m256d *b) {
    return _mm256_fmadd_pd(a[2], b[2], _mm256_fmadd_pd(a[1], b[1], _mm256_mul_pd(a[0], b[0])));
}

// Returns a component of a x b; with sign -1 the sum of its two terms instead of their difference.
PARADT__AVX2 PARADT__INLINE __m256d paradt__cross_avx2(const __m256d *a, const __m256d *b, int axis, int sign) {
    int j = (axis + 1) % 3, k = (axis + 2) % 3;
    __m256d product = _mm256_mul_pd(a[k], b[j]);
    return sign > 0 ? _mm256_fmsub_pd(a[j], b[k], product) : _mm256_fmadd_pd(a[j], b[k], product);
}

// Computes P and sum N_j h_j of paradt__sphere_make for four cells.
PARADT__AVX2 PARADT__INLINE void paradt__four_sizes(int sharp, const __m256d *half, const __m256d *a, const __m256d *b,
                                                    const __m256d *c, __m256d *size, __m256d *sides) {
    __m256d sa[3], sb[3], sc[3], m[3], n[3];
    int i;
    for (i = 0; i < 3; i++) {
        sa[i] = paradt__abs_avx2(a[i]);
        sb[i] = paradt__abs_avx2(b[i]);
        sc[i] = paradt__abs_avx2(c[i]);
        m[i] = _mm256_add_pd(_mm256_add_pd(sa[i], sb[i]), sc[i]);
    }
    if (sharp) {
        __m256d bc[3];
        for (i = 0; i < 3; i++) {
            bc[i] = paradt__cross_avx2(sb, sc, i, -1);
            n[i] = _mm256_mul_pd(a[3], bc[i]);
            n[i] = _mm256_fmadd_pd(b[3], paradt__cross_avx2(sc, sa, i, -1), n[i]);
            n[i] = _mm256_fmadd_pd(c[3], paradt__cross_avx2(sa, sb, i, -1), n[i]);
        }
        *size = paradt__dot_avx2(sa, bc);
        *sides = paradt__dot_avx2(half, n);
    } else {
        __m256d sum = _mm256_add_pd(_mm256_add_pd(a[3], b[3]), c[3]);
        __m256d base = _mm256_mul_pd(m[0], m[1]);
        __m256d walls = _mm256_fmadd_pd(m[0], half[1], _mm256_mul_pd(m[1], half[0]));
        *size = _mm256_mul_pd(base, m[2]);
        *sides = _mm256_mul_pd(sum, _mm256_fmadd_pd(walls, m[2], _mm256_mul_pd(base, half[2])));
    }
}

// Makes the spheres of four cells, as paradt__sphere_make does. sphere: the normals by axis, and the constants; p: by
// axis relative to the box's centre, and the lift; a, b, c: by axis, and the squares of their lengths
PARADT__AVX2 PARADT__INLINE void paradt__four_spheres(int sharp, const paradt__frame *f, const __m256d *p,
                                                      const __m256d *a, const __m256d *b, const __m256d *c,
                                                      __m256d *sphere, __m256d *error) {
    const __m256d half[3] = {_mm256_set1_pd(f->half[0]), _mm256_set1_pd(f->half[1]), _mm256_set1_pd(f->half[2])};
    __m256d ab[3], v[3], w[3], sizes[3], size, sides, floor, det, inverse, doubt;
    int i;
    paradt__four_sizes(sharp, half, a, b, c, &size, &sides);
    floor = _mm256_set1_pd(1.0 / PARADT__NO_ERROR_BOUND);
    floor = _mm256_fmadd_pd(sides, _mm256_set1_pd(1.0 / PARADT__FLATTEST), floor);
    floor = _mm256_fmadd_pd(size, _mm256_set1_pd(32.0 * PARADT__UNIT_ERROR), floor);
    for (i = 0; i < 3; i++) {
        ab[i] = paradt__cross_avx2(a, b, i, 1);
        v[i] = _mm256_fmsub_pd(a[3], b[i], _mm256_mul_pd(b[3], a[i]));
    }
    det = paradt__dot_avx2(ab, c);
    inverse = _mm256_div_pd(_mm256_set1_pd(1.0), _mm256_max_pd(det, floor));
    for (i = 0; i < 3; i++) {
        w[i] = _mm256_fmadd_pd(c[3], ab[i], paradt__cross_avx2(v, c, i, 1));
        w[i] = _mm256_mul_pd(w[i], inverse);
        sphere[i] = _mm256_fmsub_pd(_mm256_set1_pd(-2.0), p[i], w[i]);
        sizes[i] = paradt__abs_avx2(w[i]);
    }
    sphere[3] = _mm256_add_pd(paradt__dot_avx2(w, p), p[3]);
    doubt = _mm256_fmadd_pd(size, paradt__dot_avx2(sizes, half), sides);
    doubt = _mm256_fmadd_pd(doubt, inverse, _mm256_set1_pd(f->square));
    *error = _mm256_blendv_pd(_mm256_set1_pd(PARADT__NO_ERROR_BOUND),
                              _mm256_mul_pd(doubt, _mm256_set1_pd(64.0 * PARADT__UNIT_ERROR)),
                              _mm256_cmp_pd(det, floor, _CMP_GT_OQ));
}

// Stores four columns as four rows.
PARADT__AVX2 PARADT__INLINE void paradt__four_rows(const __m256d *column, double *a, double *b, double *c, double *d) {
    __m256d xy_02 = _mm256_unpacklo_pd(column[0], column[1]), xy_13 = _mm256_unpackhi_pd(column[0], column[1]);
    __m256d zw_02 = _mm256_unpacklo_pd(column[2], column[3]), zw_13 = _mm256_unpackhi_pd(column[2], column[3]);
    _mm256_storeu_pd(a, _mm256_permute2f128_pd(xy_02, zw_02, 0x20));
    _mm256_storeu_pd(b, _mm256_permute2f128_pd(xy_13, zw_13, 0x20));
    _mm256_storeu_pd(c, _mm256_permute2f128_pd(xy_02, zw_02, 0x31));
    _mm256_storeu_pd(d, _mm256_permute2f128_pd(xy_13, zw_13, 0x31));
}

// Stores the spheres of four cells in the table.
PARADT__AVX2 PARADT__INLINE void paradt__four_store(paradt__sphere *table, paradt__tag mask, __m128i cells,
                                                    const __m256d *sphere, __m256d error) {
    __m128i slots = _mm_slli_epi32(_mm_and_si128(cells, _mm_set1_epi32((int)mask)), 6);
    uint64_t low = (uint64_t)_mm_cvtsi128_si64(slots), high = (uint64_t)_mm_extract_epi64(slots, 1);
    double *to[4];
    __m256d tags = _mm256_castsi256_pd(_mm256_cvtepu32_epi64(cells));
    __m256d rest_02 = _mm256_unpacklo_pd(error, tags), rest_13 = _mm256_unpackhi_pd(error, tags);
    to[0] = (double *)(void *)((char *)table + (uint32_t)low);
    to[1] = (double *)(void *)((char *)table + (low >> 32));
    to[2] = (double *)(void *)((char *)table + (uint32_t)high);
    to[3] = (double *)(void *)((char *)table + (high >> 32));
    paradt__four_rows(sphere, to[0], to[1], to[2], to[3]);
    _mm_store_pd(to[0] + 4, _mm256_castpd256_pd128(rest_02));
    _mm_store_pd(to[1] + 4, _mm256_castpd256_pd128(rest_13));
    _mm_store_pd(to[2] + 4, _mm256_extractf128_pd(rest_02, 1));
    _mm_store_pd(to[3] + 4, _mm256_extractf128_pd(rest_13, 1));
}

// Returns the differences of four points to another point, by axis.
PARADT__AVX2 PARADT__INLINE void paradt__four_differences(const double *a, const double *b, const double *c,
                                                          const double *d, const __m256d *point, __m256d *to) {
    __m256d xy_02 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(a)), _mm_loadu_pd(c), 1);
    __m256d xy_13 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(b)), _mm_loadu_pd(d), 1);
    __m256d z_02 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_sd(a + 2)), _mm_load_sd(c + 2), 1);
    __m256d z_13 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_sd(b + 2)), _mm_load_sd(d + 2), 1);
    to[0] = _mm256_sub_pd(_mm256_unpacklo_pd(xy_02, xy_13), point[0]);
    to[1] = _mm256_sub_pd(_mm256_unpackhi_pd(xy_02, xy_13), point[1]);
    to[2] = _mm256_sub_pd(_mm256_unpacklo_pd(z_02, z_13), point[2]);
}

// Replaces the vertices in kept->spokes by the edges from the point to them. Any vertex will do to fill up the last
// four.
PARADT__AVX2 PARADT__INLINE void paradt__kept_edges_avx2(const paradt__insertion *build, const __m256d *point) {
    paradt__spoke *at = build->kept->spokes, *end = paradt__spoke_at(at, build->kept->spokes_end);
    int i;
    for (i = 0; i < 3; i++) end[i].vertex = 0;
    for (; at < end; at += 4) {
        __m256d to[4];
        paradt__four_differences(paradt__scene_record(&build->scene, at[0].vertex),
                                 paradt__scene_record(&build->scene, at[1].vertex),
                                 paradt__scene_record(&build->scene, at[2].vertex),
                                 paradt__scene_record(&build->scene, at[3].vertex), point, to);
        to[3] = paradt__dot_avx2(to, to);
        paradt__four_rows(to, at[0].edge, at[1].edge, at[2].edge, at[3].edge);
    }
}

// Returns two elements of a row and two of another.
PARADT__AVX2 PARADT__INLINE __m256d paradt__two_halves(const double *a, const double *b) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(a)), _mm_loadu_pd(b), 1);
}

// Returns, by axis, the edges to the vertices with number `vertex` of four new cells.
PARADT__AVX2 PARADT__INLINE void paradt__four_edges(paradt__kept *s, uint16_t (*offsets)[4], int vertex, __m256d *to) {
    const double *a = paradt__spoke_at(s->spokes, offsets[0][vertex])->edge;
    const double *b = paradt__spoke_at(s->spokes, offsets[1][vertex])->edge;
    const double *c = paradt__spoke_at(s->spokes, offsets[2][vertex])->edge;
    const double *d = paradt__spoke_at(s->spokes, offsets[3][vertex])->edge;
    __m256d xy_02 = paradt__two_halves(a, c), xy_13 = paradt__two_halves(b, d);
    __m256d zl_02 = paradt__two_halves(a + 2, c + 2), zl_13 = paradt__two_halves(b + 2, d + 2);
    to[0] = _mm256_unpacklo_pd(xy_02, xy_13);
    to[1] = _mm256_unpackhi_pd(xy_02, xy_13);
    to[2] = _mm256_unpacklo_pd(zl_02, zl_13);
    to[3] = _mm256_unpackhi_pd(zl_02, zl_13);
}

// Returns that of four cells which has the least power.
PARADT__AVX2 PARADT__INLINE paradt_index paradt__four_least(__m256d powers, __m128i cells) {
    int cell[4];
    __m256d least = _mm256_min_pd(powers, _mm256_permute2f128_pd(powers, powers, 1));
    least = _mm256_min_pd(least, _mm256_permute_pd(least, 5));
    _mm_storeu_si128((__m128i *)(void *)cell, cells);
    return cell[paradt__trailing_zeros((unsigned)_mm256_movemask_pd(_mm256_cmp_pd(powers, least, _CMP_EQ_OQ)))];
}

// The kernel `make` for quick or sharp bounds
PARADT__AVX2 PARADT__INLINE void paradt__kept_make_four(int sharp, const paradt__insertion *build,
                                                        paradt__new_cells *star, const double *x,
                                                        const paradt__centred *centred) {
    paradt__kept *s = build->kept;
    const __m256d point[3] = {_mm256_set1_pd(x[0]), _mm256_set1_pd(x[1]), _mm256_set1_pd(x[2])};
    const __m256d p[4] = {_mm256_set1_pd(centred->s[0]), _mm256_set1_pd(centred->s[1]), _mm256_set1_pd(centred->s[2]),
                          _mm256_set1_pd(centred->lift)};
    const __m256d next[3] = {_mm256_set1_pd(s->next.s[0]), _mm256_set1_pd(s->next.s[1]), _mm256_set1_pd(s->next.s[2])};
    const paradt__frame frame = s->frame;
    paradt__sphere *table = s->table;
    paradt__tag mask = s->mask;
    __m256d least = _mm256_set1_pd(PARADT__NO_ERROR_BOUND);
    __m128i best = _mm_set1_epi32(star->base[0] >> 2);
    int i, count = star->count;
    paradt__kept_edges_avx2(build, point);
    paradt__new_cells_pad(star);
    for (i = 0; i < count; i += 4) {
        __m256d a[4], b[4], c[4], sphere[4], error, power, less;
        __m128i cells = _mm_srli_epi32(_mm_loadu_si128((const __m128i *)(const void *)(star->base + i)), 2), is_less;
        paradt__four_edges(s, star->offsets + i, 1, a);
        paradt__four_edges(s, star->offsets + i, 0, b);
        paradt__four_edges(s, star->offsets + i, 2, c);
        paradt__four_spheres(sharp, &frame, p, a, b, c, sphere, &error);
        paradt__four_store(table, mask, cells, sphere, error);
        power =
            _mm256_add_pd(sphere[3], paradt__dot_avx2(sphere, next)); // without the next point's lift, which all have
        less = _mm256_cmp_pd(power, least, _CMP_LT_OQ);
        least = _mm256_min_pd(power, least);
        is_less = _mm_castps_si128(_mm_shuffle_ps(_mm_castpd_ps(_mm256_castpd256_pd128(less)),
                                                  _mm_castpd_ps(_mm256_extractf128_pd(less, 1)), 0x88));
        best = _mm_blendv_epi8(best, cells, is_less);
    }
    s->start = paradt__four_least(least, best);
}

PARADT__AVX2 PARADT__NOINLINE void paradt__kept_make_sharp_avx2(const paradt__insertion *build, paradt__new_cells *star,
                                                                const double *x, const paradt__centred *centred) {
    paradt__kept_make_four(1, build, star, x, centred);
}

// The kernel `make`
PARADT__AVX2 static void paradt__kept_make_avx2(const paradt__insertion *build, paradt__new_cells *star,
                                                const double *x, const paradt__centred *centred) {
    paradt__making making = build->kept->making;
    if (PARADT__LIKELY(making == PARADT__MAKE_QUICKLY)) paradt__kept_make_four(0, build, star, x, centred);
    else if (making == PARADT__MAKE_SHARP) paradt__kept_make_sharp_avx2(build, star, x, centred);
    else paradt__kept_make_graded(build, star, x, centred);
}

// Makes the spheres of four cells again, none of them a ghost.
PARADT__AVX2 PARADT__INLINE void paradt__kept_remake_four(const paradt__insertion *build, const int *cells) {
    const paradt__kept *s = build->kept;
    const __m256d centre[3] = {_mm256_set1_pd(s->centre[0]), _mm256_set1_pd(s->centre[1]),
                               _mm256_set1_pd(s->centre[2])};
    __m256d corner[4][4], p[4], sphere[4], error;
    int i, axis;
    for (i = 0; i < 4; i++) {
        const paradt_index *vertices = build->scene.mesh.vertices + i;
        const __m256d zero[3] = {_mm256_setzero_pd(), _mm256_setzero_pd(), _mm256_setzero_pd()};
        paradt__four_differences(paradt__scene_record(&build->scene, vertices[4 * (size_t)cells[0]]),
                                 paradt__scene_record(&build->scene, vertices[4 * (size_t)cells[1]]),
                                 paradt__scene_record(&build->scene, vertices[4 * (size_t)cells[2]]),
                                 paradt__scene_record(&build->scene, vertices[4 * (size_t)cells[3]]), zero, corner[i]);
    }
    for (i = 0; i < 3; i++) {
        for (axis = 0; axis < 3; axis++) corner[i][axis] = _mm256_sub_pd(corner[i][axis], corner[3][axis]);
        corner[i][3] = paradt__dot_avx2(corner[i], corner[i]);
    }
    for (axis = 0; axis < 3; axis++) p[axis] = _mm256_sub_pd(corner[3][axis], centre[axis]);
    p[3] = paradt__dot_avx2(p, p);
    paradt__four_spheres(s->making == PARADT__MAKE_SHARP, &s->frame, p, corner[1], corner[0], corner[2], sphere,
                         &error);
    paradt__four_store(s->table, s->mask, _mm_loadu_si128((const __m128i *)(const void *)cells), sphere, error);
}

// The kernel `remake`. Ghosts stay missing: there are few, and they are made one by one when they are needed.
PARADT__AVX2 static void paradt__kept_remake_avx2(const paradt__insertion *build, const paradt_index *waiting,
                                                  int count) {
    const paradt__kept *s = build->kept;
    int cells[PARADT__MOST_WAITING + 3], missing = 0, i;
    if (s->making == PARADT__MAKE_GRADED) {
        paradt__kept_remake_plain(build, waiting, count);
        return;
    }
    for (i = 0; i < count; i++) {
        paradt_index cell = build->scene.mesh.links[waiting[i]] >> 2;
        cells[missing] = cell;
        missing += ((s->table[(paradt__tag)cell & s->mask].tag & ~PARADT__IN_CAVITY) != (paradt__tag)cell) &
                   paradt__is_finite_cell(build->scene.mesh.vertices + 4 * (size_t)cell, 4);
    }
    for (i = 0; i < missing; i++) paradt__kept_evict(build, cells[i]);
    for (i = missing; i % 4; i++) cells[i] = cells[missing - 1];
    for (i = 0; i < missing; i += 4) paradt__kept_remake_four(build, cells + i);
    for (i = 0; i < missing; i++) {
        paradt__sphere *sphere = s->table + ((paradt__tag)cells[i] & s->mask);
        if (build->scene.mesh.marks[cells[i]] & PARADT__CONFLICT && sphere->tag == (paradt__tag)cells[i])
            sphere->tag |= PARADT__IN_CAVITY;
    }
}

// paradt__facet_order as shuffles, which leave the last element 0
#define PARADT__FACET_SHUFFLE(a, b, c)                                                                                 \
    { PARADT__LANE(a), PARADT__LANE(b), PARADT__LANE(c), 128, 128, 128, 128 }
static const unsigned char paradt__facet_shuffle[4][16] = {
    PARADT__FACET_SHUFFLE(1, 3, 2), PARADT__FACET_SHUFFLE(0, 2, 3), PARADT__FACET_SHUFFLE(1, 0, 3),
    PARADT__FACET_SHUFFLE(0, 1, 2)};
#undef PARADT__FACET_SHUFFLE
#undef PARADT__LANE

// The kernel `fill_row`
PARADT__AVX2 static void paradt__kept_row_avx2(paradt_index *row, const paradt_index *cell, int without,
                                               paradt_index point) {
    __m128i vertices = _mm_loadu_si128((const __m128i *)(const void *)cell);
    __m128i facet =
        _mm_shuffle_epi8(vertices, _mm_loadu_si128((const __m128i *)(const void *)paradt__facet_shuffle[without]));
    _mm_storeu_si128((__m128i *)(void *)row, _mm_or_si128(facet, _mm_setr_epi32(0, 0, 0, point)));
}

// The kernel `store_links`: one store, so that a load of all four soon after need not wait until they are in the cache.
PARADT__AVX2 static void paradt__kept_links_avx2(paradt_index *links, paradt_index a, paradt_index b, paradt_index c,
                                                 paradt_index d) {
    _mm_storeu_si128((__m128i *)(void *)links, _mm_setr_epi32(a, b, c, d));
}

// Inserts the point kept->next, by these kernels.
PARADT__AVX2 static paradt_status paradt__kept_insert_avx2(paradt__insertion *build, paradt_index point) {
    const paradt__kept_kernels kernels = {paradt__kept_spread_avx2, paradt__kept_remake_avx2, paradt__kept_make_avx2,
                                          paradt__kept_row_avx2, paradt__kept_links_avx2};
    return paradt__kept_insert_any(build, point, &kernels);
}
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>inserting
//
// Insertions from beginning to end: of points in their order, with pauses, and of one more point at a time. Chooses
// between the insertion in any dimension and the one in space, so that nobody else has to know which it is.
//
// An insertion begins with paradt__insertion_begin, or with a struct that is zero but for the fields filled by hand and
// by paradt__insertion_layout. paradt__insertion_run inserts its points; after a pause paradt__insertion_go goes on.
// More points follow by paradt__insertion_more, or one at a time by paradt__insert_one_more. paradt__insertion_rest
// frees all but the mesh, paradt__insertion_end everything.
// Doors: paradt__insertion_begin, paradt__insertion_layout, paradt__insertion_span_first, paradt__insertion_run,
// paradt__insertion_go, paradt__insertion_more, paradt__insert_one_more, paradt__insertion_start,
// paradt__insertion_rest, paradt__insertion_end, paradt__bowyer_watson.

// Frees all but the mesh.
static void paradt__insertion_rest(paradt__insertion *build) {
    paradt__update_free(&build->update, build->memory);
    paradt__release(build->memory, build->rim);
    paradt__facets_free(&build->ridges, build->memory);
    paradt__kept_free(build->kept, build->memory);
    build->rim = NULL;
    build->rim_count = build->rim_capacity = 0;
    build->kept = NULL;
}

// Frees everything.
PARADT__OPTIONAL void paradt__insertion_end(paradt__insertion *build) {
    paradt__insertion_rest(build);
    paradt__mesh_free(&build->scene.mesh, build->memory);
}

// Moves dim + 1 points that span the space to the front of the order.
static void paradt__insertion_span_first(const paradt__set *set, paradt_index *order, paradt__counters *counters) {
    paradt_index basis[PARADT_MAX_DIM + 1];
    int i, count = paradt__set_basis(set, order, 0, basis, NULL, counters, NULL);
    for (i = 0; i < count; i++) {
        size_t at = (size_t)i;
        while (order[at] != basis[i]) at++;
        order[at] = order[i];
        order[i] = basis[i];
    }
}

typedef paradt_status (*paradt__inserter)(paradt__insertion *build, paradt_index point);

// Returns the function that inserts a point.
static paradt__inserter paradt__choose_inserter(const paradt__insertion *build) {
    if (PARADT_MAX_DIM < 3 || !build->kept) return paradt__insert;
#if defined(PARADT__KEPT_AVX2)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return paradt__kept_insert_avx2;
#endif
    return paradt__kept_insert;
}

// Inserts the points that are left, in their order, until there are none or the relay says to pause.
static paradt_status paradt__insertion_go(paradt__insertion *build, const paradt__progress *progress) {
    paradt__inserter insert = paradt__choose_inserter(build);
    paradt_status status = PARADT_OK;
    size_t i;
    for (i = build->inserted; i < build->count && !status; i++) {
        if (i % PARADT__REPORT_STEP == 0 && paradt__progress_cancels(progress, (double)i / (double)build->count))
            return PARADT_ERROR_CANCELLED;
        status = insert(build, paradt__insertion_point(build, i));
        if (!status) PARADT__VERIFY_SMALL(&build->scene.mesh, 1, PARADT__CONFLICT);
        build->inserted = i + 1;
        if (paradt__relay_pauses(build->relay, build->inserted, 64)) break;
    }
    return status;
}

// Makes the first cells of the points that come first, which span the space, and inserts the others as
// paradt__insertion_go does.
PARADT__HOT paradt_status paradt__insertion_run(paradt__insertion *build, const paradt__progress *progress) {
    paradt__mesh *mesh = &build->scene.mesh;
    paradt__update *update = &build->update;
    paradt_status status =
        paradt__list_room(&update->killed, 0, &update->killed_capacity, PARADT__FIRST_DIG, build->memory);
    if (mesh->lent) paradt__mesh_clear_marks(mesh);
    if (!status && mesh->corners <= 4)
        status = paradt__insertion_reserve(
            build, 1, paradt__expected_places(paradt__insertion_first_points(build), mesh->corners - 1));
    if (!status) status = paradt__insertion_first_cells(build);
    build->inserted = (size_t)mesh->corners;
    if (!status && PARADT__IS(mesh->corners - 1, 3)) status = paradt__kept_begin(build);
    return status ? status : paradt__insertion_go(build, progress);
}

// Returns a cell near the point that was inserted last.
PARADT__INLINE paradt_index paradt__insertion_start(const paradt__insertion *build) {
    return build->kept ? build->kept->start : build->scene.hint;
}

// Prepares the insertion of more points; build->count has been increased. first: the first of them; numbers: the number
// of points that there are; cell: where the search for the first begins
static paradt_status paradt__insertion_go_on(paradt__insertion *build, paradt_index first, size_t numbers,
                                             paradt_index cell) {
    paradt__kept *kept = build->kept;
    PARADT_ASSERT(*paradt__mesh_row(&build->scene.mesh, cell) != PARADT__DEAD);
    build->scene.hint = cell;
    if (!kept) return PARADT_OK;
    if (numbers >= kept->numbers && !paradt__kept_more_numbers(build, numbers + numbers / 8 + 64))
        return PARADT_ERROR_MEMORY;
    kept->start = cell;
    kept->next = paradt__centred_of(kept, paradt__scene_record(&build->scene, first));
    return PARADT_OK;
}

// Inserts the points from number `inserted` on of `order`, which have been counted in build->count since the points
// before were inserted, until it pauses.
PARADT__OPTIONAL paradt_status paradt__insertion_more(paradt__insertion *build, const paradt_index *order,
                                                      size_t inserted, const paradt__progress *progress) {
    paradt_status status;
    build->order = order;
    build->inserted = inserted;
    build->later = 0;
    if (inserted == build->count) return PARADT_OK;
    status = paradt__insertion_go_on(build, paradt__insertion_point(build, inserted), build->count,
                                     paradt__insertion_start(build));
    return status ? status : paradt__insertion_go(build, progress);
}

// Inserts one more point; build->count has been increased by 1. cell: a cell in conflict with the point; negative: none
// is known. Then one is found by a walk by orientations, as the spheres on the way are in no table.
PARADT__OPTIONAL paradt_status paradt__insert_one_more(paradt__insertion *build, paradt_index point,
                                                       paradt_index cell) {
    paradt__kept *kept = build->kept;
    paradt_status status;
    if (cell < 0) {
        cell = paradt__insertion_start(build);
        if (kept) cell = paradt__walk(&build->scene, cell, paradt__scene_record(&build->scene, point));
    }
    status = paradt__insertion_go_on(build, point, (size_t)point + 1, cell);
    build->order = NULL;
    build->inserted = build->count - 1;
    if (kept) {
        kept->missed_count = 0; // such points are scattered: a larger table would not have their spheres either
        paradt__kept_fetch_around(build, cell);
    }
    if (!status) status = paradt__choose_inserter(build)(build, point);
    if (!status) PARADT__VERIFY_SMALL(&build->scene.mesh, 1, PARADT__CONFLICT);
    return status;
}

// Takes over how the records of the set are laid out, and what is known of their sagittas.
static void paradt__insertion_layout(paradt__insertion *build, const paradt__set *set) {
    build->scene.width = set->width;
    build->graded = set->grade == PARADT__SAGITTA;
    build->grade_limit = set->grade_limit;
    build->grade_error = set->grade_error;
}

// Begins the insertion of a set in an order. Points that span the space are moved to the front of the order.
static void paradt__insertion_begin(paradt__insertion *build, const paradt__set *set, paradt_index *order,
                                    paradt__memory *memory) {
    memset(build, 0, sizeof *build);
    paradt__mesh_begin(&build->scene.mesh, set->space.dim + 1, 1);
    build->scene.space = set->space;
    paradt__insertion_span_first(set, order, &build->scene.space.counters);
    build->memory = memory;
    build->scene.records = set->records;
    build->order = order;
    paradt__insertion_layout(build, set);
    build->count = set->count;
}

// Makes the closed mesh of a set, whose points are along a curve, by insertion. Vertices are positions in the set.
// After an error the mesh is empty.
PARADT__HOT paradt_status paradt__bowyer_watson(const paradt__set *set, paradt__memory *memory, paradt__mesh *mesh,
                                                const paradt__progress *progress, paradt__counters *counters) {
    paradt__insertion build;
    paradt_index *order = paradt__round_order(set->count, memory);
    paradt_status status;
    if (!order) return PARADT_ERROR_MEMORY;
    paradt__insertion_begin(&build, set, order, memory);
    status = paradt__insertion_run(&build, progress);
    *counters = build.scene.space.counters;
    paradt__insertion_rest(&build);
    paradt__release(memory, order);
    *mesh = build.scene.mesh;
    if (status) paradt__mesh_free(mesh, memory);
    return status;
}

#ifndef PARADT_NO_FLIPS
// ---------------------------------------------------------------------------------------------------------------------
// >>flips
//
// Flips in any dimension. A flip takes a circuit: a point p and those vertices of a cell that p is a proper affine
// combination of,
//     p = sum of c_i v_i,   sum of c_i = 1,   c_i != 0.
// Let N be the vertices with c_i < 0, Q those with c_i > 0. The two triangulations of the circuit are the simplices
// that leave out one point of {p} + N, and those that leave out one of Q. A flip replaces the first by the second. If
// c_i is 0 for some vertices of the cell, as in a lattice, the circuit lies in a face, and other cells have it, too:
// those around the simplex of N and Q, its star. With their other vertices, which make the simplex's link, they are
// replaced together. That is possible if and only if all simplices of the first triangulation have the same link: if
// for each cell of the star and each vertex in N the neighbour across the facet opposite that vertex has p for its
// apex. In the plane and in space:
//
//     N   Q          N   Q              N   Q                        N   Q
//     0   3   1-3    0   4   1-4        0   3   2-6 (in a facet)     1   3   2-3    2   2   3-2
//     0   2   2-4    1   2   2-2        0   2   in an edge           1   2   4-4, 2-2 on the hull
//     2   1   3-1    3   1   4-1        2   1   6-2        1 1 ...   with weights: the vertex in Q is hidden then
//
// One function serves all of them, in all dimensions: the mesh is closed, so cells and ghosts of a star are alike.
//
// On flips of a closed mesh whose cells are positively oriented; nothing else is asked of it. N is not empty where p is
// beyond a facet of the cell, and empty where p is in the cell and no vertex yet: then the flip inserts p.
// After Lawson, "Properties of n-dimensional triangulations", Computer Aided Geometric Design 3, 1986; the circuits and
// their links: de Loera, Rambau, Santos, "Triangulations", 2010, section 4.4.
// Doors: paradt__flipper_*, paradt__flip_sign, paradt__flip_collect, paradt__flip.

// The signs of a cell's coefficients, a bit for each place in its row. Both masks are 0 where no flip is wanted.
typedef struct paradt__signs {
    uint16_t negative, positive;
} paradt__signs;

// What a flip works with
typedef struct paradt__flipper {
    paradt__insertion build;                 // the scene, room for cells, and the update of the last flip
    paradt_index point;                      // p
    int negative, positive;                  // numbers of vertices in N and in Q
    paradt_index member[PARADT_MAX_DIM + 1]; // the vertices themselves: N, then Q
    paradt__list star;                       // places of the cells around them
    unsigned char *places; // [places_capacity] for each of these cells, where in its row each member is
    size_t places_capacity;
    paradt_index *number; // [numbers] by place: that of the cell in the star
    size_t numbers;
} paradt__flipper;

static void paradt__flipper_rest(paradt__flipper *f) {
    paradt__memory *memory = f->build.memory;
    paradt__list_free(&f->star, memory);
    paradt__release(memory, f->places);
    paradt__release(memory, f->number);
    f->places = NULL;
    f->number = NULL;
    paradt__insertion_rest(&f->build);
}

// Makes sure that all places have numbers.
static paradt_status paradt__flipper_numbers(paradt__flipper *f) {
    size_t capacity = f->build.scene.mesh.capacity;
    void *array = f->number;
    if (PARADT__LIKELY(f->numbers >= capacity)) return PARADT_OK;
    if (!paradt__grow(f->build.memory, &array, 0, capacity, sizeof *f->number)) return PARADT_ERROR_MEMORY;
    f->number = (paradt_index *)array;
    f->numbers = capacity;
    return PARADT_OK;
}

// The sign of p's coefficient at a vertex of a cell, or of a ghost whose hull facet has p in its plane; i: the vertex's
// place, not that of the infinite vertex, whose coefficient is 0
PARADT__INLINE int paradt__flip_sign(paradt__scene *scene, paradt_index cell, int i, const double *x, int corners) {
    const paradt__mesh *mesh = &scene->mesh;
    const paradt_index *finite = paradt__mesh_row(mesh, cell);
    const double *p[PARADT_MAX_DIM + 1];
    paradt_index vertex = finite[i];
    int ghost = paradt__ghost_place(finite, corners), j;
    if (ghost >= 0) finite = paradt__mesh_row(mesh, mesh->links[cell * corners + ghost] / corners);
    for (j = 0; j < corners; j++) p[j] = finite[j] == vertex ? x : paradt__scene_record(scene, finite[j]);
    return paradt__orient(&scene->space, p);
}

// Adds a cell to the star.
PARADT__INLINE paradt_status paradt__star_append(paradt__flipper *f, paradt_index cell, int corners) {
    const paradt_index *vertices = paradt__mesh_row(&f->build.scene.mesh, cell);
    size_t at = f->star.count * (size_t)corners;
    int members = f->negative + f->positive, i, j;
    paradt_status status = paradt__list_append(&f->star, cell, f->build.memory);
    if (status) return status;
    if (at + (size_t)corners > f->places_capacity) {
        void *array = f->places;
        size_t capacity = 2 * at + 8 * (size_t)corners;
        if (!paradt__grow(f->build.memory, &array, at, capacity, 1)) return PARADT_ERROR_MEMORY;
        f->places = (unsigned char *)array;
        f->places_capacity = capacity;
    }
    for (i = 0; i < members; i++) {
        for (j = 0; vertices[j] != f->member[i];) j++;
        f->places[at + (size_t)i] = (unsigned char)j;
    }
    return PARADT_OK;
}

// Adds the star's other cells: through the facets that have all members.
static paradt_status paradt__star_spread(paradt__flipper *f, int corners) {
    paradt__mesh *mesh = &f->build.scene.mesh;
    int members = f->negative + f->positive, i;
    paradt_status status = paradt__flipper_numbers(f);
    size_t next;
    if (status) return status;
    f->number[f->star.items[0]] = 0;
    mesh->marks[f->star.items[0]] |= PARADT__CONFLICT;
    for (next = 0; next < f->star.count && !status; next++) {
        paradt_index base = f->star.items[next] * corners;
        unsigned inside = 0;
        for (i = 0; i < members; i++) inside |= 1u << f->places[next * (size_t)corners + (size_t)i];
        for (i = 0; i < corners && !status; i++) {
            paradt_index other = mesh->links[base + i] / corners;
            if (inside >> i & 1 || !paradt__mesh_mark(mesh, (size_t)other, PARADT__CONFLICT)) continue;
            f->number[other] = (paradt_index)f->star.count;
            status = paradt__star_append(f, other, corners);
        }
    }
    for (next = 0; next < f->star.count; next++)
        paradt__mesh_unmark(mesh, (size_t)f->star.items[next], PARADT__CONFLICT);
    return status;
}

// Do all simplices of the first triangulation have the same link?
PARADT__INLINE int paradt__links_are_equal(const paradt__flipper *f, int corners) {
    const paradt__mesh *mesh = &f->build.scene.mesh;
    size_t i;
    int j;
    for (i = 0; i < f->star.count; i++) {
        paradt_index base = f->star.items[i] * corners;
        const unsigned char *places = f->places + i * (size_t)corners;
        for (j = 0; j < f->negative; j++) {
            if (mesh->vertices[mesh->links[base + places[j]]] != f->point) return 0;
        }
    }
    return 1;
}

// Collects what a flip of the cell and the point is about, by the signs: members and star. *possible: the flip can be
// done
PARADT__INLINE paradt_status paradt__flip_collect(paradt__flipper *f, paradt_index cell, paradt_index point,
                                                  paradt__signs signs, int corners, int *possible) {
    const paradt__mesh *mesh = &f->build.scene.mesh;
    const paradt_index *vertices = paradt__mesh_row(mesh, cell);
    paradt_status status;
    int i, members = 0;
    *possible = 0;
    for (i = 0; i < corners; i++) {
        if (!(signs.negative >> i & 1)) continue;
        if (mesh->vertices[mesh->links[cell * corners + i]] != point) return PARADT_OK;
        f->member[members++] = vertices[i];
    }
    f->negative = members;
    for (i = 0; i < corners; i++) {
        if (signs.positive >> i & 1) f->member[members++] = vertices[i];
    }
    f->positive = members - f->negative;
    f->point = point;
    f->star.count = 0;
    status = paradt__star_append(f, cell, corners);
    if (!status && members < corners) {
        status = paradt__star_spread(f, corners);
        if (!status) *possible = paradt__links_are_equal(f, corners);
        return status;
    }
    *possible = 1;
    return status;
}

// Makes room for what the flip kills and makes.
static paradt_status paradt__flip_room(paradt__flipper *f) {
    paradt__insertion *build = &f->build;
    paradt__update *update = &build->update;
    size_t killed = f->star.count * (size_t)(1 + f->negative), made = f->star.count * (size_t)f->positive;
    paradt_status status = paradt__insertion_room(build, made);
    if (!status) status = paradt__list_room(&update->made, 0, &update->made_capacity, made, build->memory);
    if (!status) status = paradt__list_room(&update->killed, 0, &update->killed_capacity, killed, build->memory);
    return status ? status : paradt__mesh_spare_room(&build->scene.mesh, killed, build->memory);
}

// Links a new cell. i: the cell of the star that it is made of; j: number of the vertex in Q that p has replaced
PARADT__INLINE void paradt__flip_link(paradt__flipper *f, size_t i, int j, int corners) {
    paradt__mesh *mesh = &f->build.scene.mesh;
    const unsigned char *places = f->places + i * (size_t)corners;
    const paradt_index *made = f->build.update.made + i * (size_t)f->positive;
    paradt_index base = f->star.items[i] * corners, own = made[j] - places[f->negative + j];
    int k, place = places[f->negative + j], members = f->negative + f->positive;
    unsigned inside = 0;
    paradt__mesh_tie(mesh, own + place, mesh->links[base + place]);
    for (k = 0; k < f->negative; k++) { // the facet is one of the neighbour that joins p with the facet opposite
        paradt_index mirror = mesh->links[base + places[k]], other = mirror - mirror % corners;
        while (mesh->vertices[other] != f->member[f->negative + j]) other++;
        paradt__mesh_tie(mesh, own + places[k], mesh->links[other]);
    }
    for (k = 0; k < f->positive; k++) {
        if (k != j) mesh->links[own + places[f->negative + k]] = made[k] - places[f->negative + k] + place;
    }
    if (members == corners) return;
    for (k = 0; k < members; k++) inside |= 1u << places[k];
    for (k = 0; k < corners; k++) { // to the new cells made of the star's other cells
        paradt_index mirror = mesh->links[base + k], other = mirror / corners;
        size_t at = (size_t)f->number[other];
        if (inside >> k & 1) continue;
        other = f->build.update.made[at * (size_t)f->positive + (size_t)j] -
                f->places[at * (size_t)corners + (size_t)(f->negative + j)];
        mesh->links[own + k] = other + mirror % corners;
    }
}

// Flips what was collected. Fills the update: killed, for each cell of the star that cell and then the others
// that have its part of the link; made, for each cell of the star, by the facets opposite p.
// Places of killed cells are free afterwards.
PARADT__INLINE paradt_status paradt__flip(paradt__flipper *f, int corners) {
    paradt__insertion *build = &f->build;
    paradt__mesh *mesh = &build->scene.mesh;
    paradt__update *update = &build->update;
    paradt_status status = paradt__flip_room(f);
    size_t i, count = 0;
    int j;
    if (status) return status;
    update->made_count = 0;
    for (i = 0; i < f->star.count; i++) {
        const paradt_index *row = mesh->vertices + f->star.items[i] * corners;
        for (j = 0; j < f->positive; j++) {
            paradt_index made = paradt__mesh_take(mesh) * corners;
            int place = f->places[i * (size_t)corners + (size_t)(f->negative + j)];
            memcpy(mesh->vertices + made, row, (size_t)corners * sizeof *row);
            mesh->vertices[made + place] = f->point;
            update->made[update->made_count++] = made + place;
        }
        update->killed[count++] = f->star.items[i] * corners;
        for (j = 0; j < f->negative; j++)
            update->killed[count++] =
                mesh->links[f->star.items[i] * corners + f->places[i * (size_t)corners + (size_t)j]];
    }
    update->killed_count = count;
    for (i = 0; i < f->star.count; i++) {
        for (j = 0; j < f->positive; j++) paradt__flip_link(f, i, j, corners);
    }
    for (i = 0; i < count; i++) {
        mesh->marks[update->killed[i] / corners] = 0;
        paradt__mesh_give(mesh, update->killed[i] / corners, (size_t)corners);
    }
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>history
//
// The history dag: all cells that an incremental construction ever made. When a flip replaces cells by others, those
// that were made of one part of its star become the children of each cell that it killed there. They cover it. So
// whoever wants to know which cell contains a point x goes from a cell that does, living or dead, to a child that does,
// until the cell lives. Here "contains" is for a cell that x is in it or on its boundary; for a ghost that x is
// strictly beyond its hull facet. A point outside is connected to many hull facets by many cells, all of which would
// have to be asked; there a walk finds the cell in a few steps.
//
// The thesis starts at the root. But points come in rounds, along a curve in each round, so the last one is nearby.
// Hence location climbs first, from the cell made last to its parent and on, until there is a cell that contains x: to
// the parent, one of the killed cells, which was there before the point whose flip killed it. So a path has a few steps
// for each point that was inserted nearby since the cell at its top was made. The rounds are random samples as far as
// places are concerned, each 16 times larger than the one before: the expected number of such points is a constant for
// each round, and the number of rounds is O(log n), as in a random order.
//
// A node has the vertices of its cell, which stay, while its place is used again. Nodes stand in blocks, so that they
// need not be copied when there are more. Siblings follow each other and have the same parent.
// After Guibas, Knuth, Sharir, "Randomized incremental construction of Delaunay and Voronoi diagrams", Algorithmica 7,
// 1992, and Edelsbrunner and Shah, Algorithmica 15, 1996; the thesis, 3.1.
// Doors: paradt__history_*.

enum {
    PARADT__NODE_PARENT, // the parent, or PARADT__OPEN: a first cell
    PARADT__NODE_CHILD,  // the first child; or, of a living cell, -1 - its place
    PARADT__NODE_VERTICES,
    PARADT__NODE_SHIFT = 14 // a block has 2^14 nodes
};

typedef struct paradt__history {
    size_t width;         // of a node
    size_t count;         // nodes
    paradt_index **block; // [block_capacity]
    size_t blocks, block_capacity;
} paradt__history;

static void paradt__history_free(paradt__history *h, paradt__memory *memory) {
    size_t i;
    for (i = 0; i < h->blocks; i++) paradt__release(memory, h->block[i]);
    paradt__release(memory, h->block);
    memset(h, 0, sizeof *h);
}

PARADT__INLINE paradt_index *paradt__history_node(const paradt__history *h, paradt_index node) {
    return h->block[node >> PARADT__NODE_SHIFT] + (size_t)(node & ((1 << PARADT__NODE_SHIFT) - 1)) * h->width;
}

// Makes room for more nodes.
static paradt_status paradt__history_grow(paradt__history *h, size_t more, paradt__memory *memory) {
    size_t most = (size_t)PARADT__NOWHERE;
    if (more > most - h->count) return PARADT_ERROR_TOO_LARGE;
    while (h->blocks << PARADT__NODE_SHIFT < h->count + more) {
        void *array = h->block;
        if (h->blocks == h->block_capacity) {
            if (!paradt__grow(memory, &array, h->blocks, 2 * h->blocks + 16, sizeof *h->block))
                return PARADT_ERROR_MEMORY;
            h->block = (paradt_index **)array;
            h->block_capacity = 2 * h->blocks + 16;
        }
        array = paradt__alloc_filled(memory, (size_t)1 << PARADT__NODE_SHIFT, h->width * sizeof(paradt_index));
        if (!array) return PARADT_ERROR_MEMORY;
        h->block[h->blocks++] = (paradt_index *)array;
    }
    return PARADT_OK;
}

PARADT__INLINE paradt_status paradt__history_room(paradt__history *h, size_t more, paradt__memory *memory) {
    if (PARADT__LIKELY(h->count + more <= h->blocks << PARADT__NODE_SHIFT)) return PARADT_OK;
    return paradt__history_grow(h, more, memory);
}

// Adds a living cell, for which there is room. Returns its node.
PARADT__INLINE paradt_index paradt__history_add(paradt__history *h, paradt_index parent, paradt_index place,
                                                const paradt_index *vertices, int corners) {
    paradt_index node = (paradt_index)h->count++, *row = paradt__history_node(h, node);
    row[PARADT__NODE_PARENT] = parent;
    row[PARADT__NODE_CHILD] = -1 - place;
    memcpy(row + PARADT__NODE_VERTICES, vertices, (size_t)corners * sizeof *vertices);
    return node;
}

// Does the cell, living or dead, contain x?
PARADT__INLINE int paradt__history_contains(paradt__scene *scene, const paradt_index *row, const double *x,
                                            int corners) {
    const paradt_index *vertices = row + PARADT__NODE_VERTICES;
    const double *p[PARADT_MAX_DIM + 1], *corner;
    int ghost = -1, i;
    for (i = 0; i < corners; i++) {
        if (vertices[i] == PARADT__INFINITE) p[ghost = i] = x;
        else p[i] = paradt__scene_record(scene, vertices[i]);
    }
    if (ghost >= 0) return paradt__orient(&scene->space, p) > 0;
    for (i = 0; i < corners; i++) {
        int side;
        corner = p[i];
        p[i] = x;
        side = paradt__orient(&scene->space, p);
        p[i] = corner;
        if (side < 0) return 0;
    }
    return 1;
}

// The first cell, or ghost on one of its facets, that contains x
static paradt_index paradt__history_root(const paradt__history *h, paradt__scene *scene, const double *x) {
    int corners = (int)h->width - PARADT__NODE_VERTICES;
    paradt_index node = 0;
    while (node < corners && !paradt__history_contains(scene, paradt__history_node(h, node), x, corners)) node++;
    return node; // the last need not be asked
}

// On which side of the facet between two cells that a flip made is x? Not negative: on that of the first cell, or on
// the facet. Their rows differ in two places, with the flip's point at one of them in each.
PARADT__INLINE int paradt__history_between(paradt__scene *scene, const paradt_index *one, const paradt_index *two,
                                           const double *x, int corners) {
    const double *p[PARADT_MAX_DIM + 1];
    int i, low = -1, high = 0;
    for (i = 0; i < corners; i++) {
        p[i] = paradt__scene_record(scene, one[i]);
        if (one[i] == two[i]) continue;
        if (low < 0) low = i;
        high = i;
    }
    p[one[low] == two[high] ? high : low] = x;
    return paradt__orient(&scene->space, p);
}

// The child, from `first` on, that contains x. The children of a cell are those made of its part of the circuit's star:
// this part covers x, and only vertices in Q may have negative coefficients for x in one of them. Add a multiple of the
// circuit's relation to a combination of x by all points of the circuit with no negative coefficient: those of Q fall,
// and the first to become zero tells which vertex the cell that contains x does not have. So two of the children are
// compared by the facet between them, and the best of all contains x.
PARADT__INLINE paradt_index paradt__history_child(const paradt__history *h, paradt__scene *scene, paradt_index first,
                                                  const double *x, int corners) {
    const paradt_index *row = paradt__history_node(h, first), *next;
    paradt_index parent = row[PARADT__NODE_PARENT], best = first, node;
    if (paradt__ghost_place(row + PARADT__NODE_VERTICES, corners) >= 0) return first; // all of them contain x
    for (node = first + 1; (size_t)node < h->count; node++) {
        next = paradt__history_node(h, node);
        if (next[PARADT__NODE_PARENT] != parent) break;
        if (paradt__history_between(scene, row + PARADT__NODE_VERTICES, next + PARADT__NODE_VERTICES, x, corners) >= 0)
            continue;
        best = node;
        row = next;
    }
    return best;
}

// Finds the living cell, or ghost, that contains x. Returns its place; or PARADT__OPEN where all that is known is that
// x is beyond a hull facet that a point was connected to. node: where to start
PARADT__INLINE paradt_index paradt__history_locate(const paradt__history *h, paradt__scene *scene, paradt_index node,
                                                   const double *x, int corners) {
    const paradt_index *row = paradt__history_node(h, node), *parent;
    while (!paradt__history_contains(scene, row, x, corners)) {
        node = row[PARADT__NODE_PARENT];
        row = paradt__history_node(h, node < 0 ? paradt__history_root(h, scene, x) : node);
        if (node < 0) break;
    }
    while (row[PARADT__NODE_CHILD] >= 0) {
        parent = row;
        row = paradt__history_node(h, row[PARADT__NODE_CHILD]);
        if (paradt__ghost_place(parent + PARADT__NODE_VERTICES, corners) >= 0 &&
            paradt__ghost_place(row + PARADT__NODE_VERTICES, corners) < 0)
            return PARADT__OPEN;
        row = paradt__history_node(h, paradt__history_child(h, scene, parent[PARADT__NODE_CHILD], x, corners));
    }
    return -1 - row[PARADT__NODE_CHILD];
}

// ---------------------------------------------------------------------------------------------------------------------
// >>insertion by flips
//
// The randomized incremental flip algorithm (thesis 2.3 and 3.1; Joe 1991, Rajan 1991, Edelsbrunner and Shah 1996) in
// any dimension, with and without weights. A new point p is inserted in four steps:
//     search    the history finds the cell that contains p
//     split     p in the cell or a face of it: a flip without negative vertices. p outside of the hull: it is connected
//               to all hull facets that it sees. p in a cell that it is not in conflict with: it is hidden
//     collect   of a facet of the link of p: the circuit of p and the cell on the other side, if p is in conflict with
//               that: if the facet is not locally regular
//     flip      if it can be done; the new cells' facets opposite p join the list of those to be looked at
// until no facet is left.
//
// Why nothing is missed. All cells that contain p are right but for their facets opposite p, the link of p. A facet
// that is not locally regular and can't be flipped yet lacks a neighbour that joins p with another facet of its
// circuit. When the last of these neighbours is made, its own facet is looked at, and has the same circuit. And as long
// as there is a facet that is not locally regular one of them can be flipped (Edelsbrunner and Shah); the perturbation
// moves heights alone, as if the lifted points were in general position, so that this holds in degenerate places, too.
//
// What is known of a cell is kept beside its place, as long as p is the same: each is asked once, from whatever facet.
// Doors: paradt__insert_by_flips.

// What is kept with a place
typedef struct paradt__flip_place {
    paradt_index node;   // of the cell there, in the history
    paradt_index asked;  // the point that was compared with it last, + 1,
    paradt__signs signs; // and with what result: not in conflict, or these, or PARADT__NO_SIGNS
} paradt__flip_place;

enum { PARADT__NO_SIGNS = 0xffff }; // for the mask of negative signs: in conflict, but the signs are not known yet

typedef struct paradt__flips {
    paradt__flipper flipper;
    paradt__history history;
    paradt__flip_place *at; // [places] by place
    size_t places;
    paradt__list facets; // to be looked at: pairs, a handle and the node of its cell, which may be dead
    paradt_index recent; // a node, of a cell near the point inserted last
    uint64_t *counts;    // [PARADT_MAX_DIM + 2] flips by the number of simplices that a circuit had before
    uint64_t steps;      // flips
} paradt__flips;

// Makes room for so many new cells in the history and in the list of facets, and keeps something with all places.
static paradt_status paradt__flips_room(paradt__flips *f, size_t made) {
    paradt__memory *memory = f->flipper.build.memory;
    size_t capacity = f->flipper.build.scene.mesh.capacity;
    paradt_status status = paradt__history_room(&f->history, made, memory);
    if (!status)
        status = paradt__list_room(&f->facets.items, f->facets.count, &f->facets.capacity, f->facets.count + 2 * made,
                                   memory);
    if (!status && f->places < capacity) {
        void *array = f->at;
        if (!paradt__grow(memory, &array, f->places, capacity, sizeof *f->at)) return PARADT_ERROR_MEMORY;
        f->at = (paradt__flip_place *)array;
        memset(f->at + f->places, 0, (capacity - f->places) * sizeof *f->at);
        f->places = capacity;
    }
    return status;
}

// Enters a cell that was made, of a parent, and the facet of the handle: it is opposite p.
PARADT__INLINE void paradt__flips_enter(paradt__flips *f, paradt_index handle, paradt_index parent, int corners) {
    const paradt__mesh *mesh = &f->flipper.build.scene.mesh;
    paradt_index place = handle / corners;
    f->recent = paradt__history_add(&f->history, parent, place, mesh->vertices + place * corners, corners);
    f->at[place].node = f->recent;
    f->facets.items[f->facets.count++] = handle;
    f->facets.items[f->facets.count++] = f->recent;
}

// Makes the next node the first child of the cell of a handle.
PARADT__INLINE void paradt__flips_bury(paradt__flips *f, paradt_index handle, int corners) {
    paradt_index node = f->at[handle / corners].node;
    paradt__history_node(&f->history, node)[PARADT__NODE_CHILD] = (paradt_index)f->history.count;
}

// Enters a flip: a cell of the star, and the cells killed with it, have the children that were made of the cell.
PARADT__INLINE paradt_status paradt__flips_record(paradt__flips *f, int corners) {
    const paradt__update *update = &f->flipper.build.update;
    const size_t positive = (size_t)f->flipper.positive, each = (size_t)f->flipper.negative + 1;
    paradt_status status = paradt__flips_room(f, update->made_count);
    size_t i, j;
    for (i = 0; i < f->flipper.star.count && !status; i++) {
        paradt_index parent = f->at[update->killed[i * each] / corners].node;
        for (j = 0; j < each; j++) paradt__flips_bury(f, update->killed[i * each + j], corners);
        for (j = 0; j < positive; j++) paradt__flips_enter(f, update->made[i * positive + j], parent, corners);
    }
    return status;
}

// Enters the cells that connect a point: they are children of all the ghosts killed.
static paradt_status paradt__flips_record_star(paradt__flips *f) {
    const paradt__update *update = &f->flipper.build.update;
    int corners = f->flipper.build.scene.mesh.corners;
    paradt_status status = paradt__flips_room(f, update->made_count);
    paradt_index parent = f->at[update->killed[0] / corners].node;
    size_t i;
    for (i = 0; i < update->killed_count && !status; i++) paradt__flips_bury(f, update->killed[i], corners);
    for (i = 0; i < update->made_count && !status; i++) paradt__flips_enter(f, update->made[i], parent, corners);
    return status;
}

// Flips the cell and p, if that can be done.
PARADT__INLINE paradt_status paradt__flips_try(paradt__flips *f, paradt_index cell, paradt_index point,
                                               paradt__signs signs, int corners) {
    int possible;
    paradt_status status = paradt__flip_collect(&f->flipper, cell, point, signs, corners, &possible);
    if (status || !possible) return status;
    status = paradt__flip(&f->flipper, corners);
    if (!status) status = paradt__flips_record(f, corners);
    f->counts[f->flipper.negative + 1]++;
    f->steps++;
    if (!status) PARADT__VERIFY_SMALL(&f->flipper.build.scene.mesh, 1, PARADT__CONFLICT);
    return status;
}

// Compares a cell with p, unless that was done. Returns what is kept with its place.
PARADT__INLINE paradt__flip_place *paradt__flips_ask(paradt__flips *f, paradt_index cell, paradt_index point) {
    paradt__flip_place *at = f->at + cell;
    paradt__scene *scene = &f->flipper.build.scene;
    if (at->asked == point + 1) return at;
    at->asked = point + 1;
    at->signs.positive = 0;
    at->signs.negative = 0;
    if (paradt__conflicts(scene, cell, paradt__scene_record(scene, point))) at->signs.negative = PARADT__NO_SIGNS;
    return at;
}

// Finds the signs of a cell that is in conflict with p. Most follow from its neighbours. The cells in conflict are a
// star-shaped cavity: p is strictly on the inner side of its rim. Where the neighbour is in the cavity, too, and has
// signs, it sees the facet from the other side; and where the neighbour joins p with the facet, p is beyond it.
PARADT__INLINE void paradt__flips_sign(paradt__flips *f, paradt_index cell, paradt_index point, int corners) {
    paradt__scene *scene = &f->flipper.build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    const double *x = paradt__scene_record(scene, point);
    paradt__signs signs = {0, 0};
    int i, side;
    for (i = 0; i < corners; i++) {
        paradt_index mirror = mesh->links[cell * corners + i];
        const paradt__flip_place *at;
        if (mesh->vertices[cell * corners + i] == PARADT__INFINITE) continue;
        if (mesh->vertices[mirror] == point) {
            side = -1;
        } else {
            at = paradt__flips_ask(f, mirror / corners, point);
            if (!at->signs.negative) side = 1;
            else if (at->signs.negative == PARADT__NO_SIGNS) side = paradt__flip_sign(scene, cell, i, x, corners);
            else side = (at->signs.negative >> mirror % corners & 1) - (at->signs.positive >> mirror % corners & 1);
        }
        signs.negative |= (uint16_t)((unsigned)(side < 0) << i);
        signs.positive |= (uint16_t)((unsigned)(side > 0) << i);
    }
    f->at[cell].signs = signs;
}

// Looks at the last facet of the list.
PARADT__INLINE paradt_status paradt__flips_next(paradt__flips *f, paradt_index point, int corners) {
    paradt_index node = f->facets.items[--f->facets.count], handle = f->facets.items[--f->facets.count], other;
    const paradt__flip_place *at;
    if (paradt__history_node(&f->history, node)[PARADT__NODE_CHILD] >= 0) return PARADT_OK; // dead
    other = f->flipper.build.scene.mesh.links[handle] / corners;
    at = paradt__flips_ask(f, other, point);
    if (!at->signs.negative) return PARADT_OK;
    if (at->signs.negative == PARADT__NO_SIGNS) paradt__flips_sign(f, other, point, corners);
    return paradt__flips_try(f, other, point, at->signs, corners);
}

// Fills update.killed with the ghosts on the hull facets that have the point strictly beyond them, and the rim with the
// facets of these ghosts on the hull and on the silhouette. first: one of the ghosts
static paradt_status paradt__flips_see(paradt__flips *f, paradt_index first, const double *x) {
    paradt__insertion *build = &f->flipper.build;
    paradt__mesh *mesh = &build->scene.mesh;
    paradt__update *update = &build->update;
    int corners = mesh->corners, i;
    size_t next;
    update->killed_count = 1;
    update->killed[0] = first * corners;
    build->rim_count = 0;
    mesh->marks[first] |= PARADT__CONFLICT;
    for (next = 0; next < update->killed_count; next++) {
        paradt_index base = update->killed[next] - update->killed[next] % corners;
        int ghost = paradt__ghost_place(mesh->vertices + base, corners);
        paradt_status status = paradt__list_room(&update->killed, update->killed_count, &update->killed_capacity,
                                                 update->killed_count + (size_t)corners, build->memory);
        if (!status)
            status = paradt__list_room(&build->rim, build->rim_count, &build->rim_capacity,
                                       build->rim_count + (size_t)corners, build->memory);
        if (status) return status;
        build->rim[build->rim_count++] = base + ghost; // so the first cell made is not a ghost
        for (i = 0; i < corners; i++) {
            paradt_index mirror = mesh->links[base + i], other = mirror / corners;
            if (i == ghost || mesh->marks[other] & PARADT__CONFLICT) continue;
            if (paradt__side(&build->scene, other, paradt__ghost_place(mesh->vertices + other * corners, corners), x) >
                0) {
                mesh->marks[other] |= PARADT__CONFLICT;
                update->killed[update->killed_count++] = mirror;
            } else {
                build->rim[build->rim_count++] = base + i;
            }
        }
    }
    return PARADT_OK;
}

// Connects the point to the hull facets that it sees, one of which has the ghost `first`.
static paradt_status paradt__flips_connect(paradt__flips *f, paradt_index first, paradt_index point) {
    paradt__insertion *build = &f->flipper.build;
    paradt_status status = paradt__flips_see(f, first, paradt__scene_record(&build->scene, point));
    if (!status) status = paradt__cavity_star(build, point);
    if (!status) status = paradt__flips_record_star(f);
    if (!status) status = paradt__cavity_clear(build);
    if (!status) PARADT__VERIFY_SMALL(&build->scene.mesh, 1, PARADT__CONFLICT);
    return status;
}

// Inserts a point, but for the flips of its link's facets.
PARADT__INLINE paradt_status paradt__flips_begin_point(paradt__flips *f, paradt_index point, int corners) {
    paradt__scene *scene = &f->flipper.build.scene;
    const double *x = paradt__scene_record(scene, point);
    paradt_index start = -1 - paradt__history_node(&f->history, f->recent)[PARADT__NODE_CHILD];
    paradt_index cell = paradt__history_locate(&f->history, scene, f->recent, x, corners);
    if (cell < 0) cell = paradt__walk(scene, start, x);
    f->recent = f->at[cell].node;
    if (paradt__ghost_place(paradt__mesh_row(&scene->mesh, cell), corners) >= 0)
        return paradt__flips_connect(f, cell, point);
    if (scene->space.weighted && !paradt__flips_ask(f, cell, point)->signs.negative) return PARADT_OK; // hidden
    paradt__flips_sign(f, cell, point, corners);
    return paradt__flips_try(f, cell, point, f->at[cell].signs, corners);
}

// Inserts the points after the first ones.
PARADT__INLINE paradt_status paradt__flips_go_any(paradt__flips *f, const paradt__progress *progress, int corners) {
    enum { PACE = 1024 }; // points and flips between two looks at whether the call is cancelled
    paradt__insertion *build = &f->flipper.build;
    paradt_status status = PARADT_OK;
    uint64_t next = 0;
    while (build->inserted < build->count && !status) {
        paradt_index point = paradt__insertion_point(build, build->inserted);
        status = paradt__flips_begin_point(f, point, corners);
        for (;;) {
            if (f->steps + build->inserted >= next) {
                next = f->steps + build->inserted + PACE;
                if (paradt__progress_cancels(progress, (double)build->inserted / (double)build->count))
                    return PARADT_ERROR_CANCELLED;
            }
            if (status || !f->facets.count) break;
            status = paradt__flips_next(f, point, corners);
        }
        build->inserted++;
    }
    return status;
}

PARADT__HOT_LOOP paradt_status paradt__flips_go(paradt__flips *f, const paradt__progress *progress) {
    int corners = f->flipper.build.scene.mesh.corners;
    return corners == 4 ? paradt__flips_go_any(f, progress, 4) : paradt__flips_go_any(f, progress, corners);
}

// Makes the first cells, and roots of the history of them.
static paradt_status paradt__flips_begin(paradt__flips *f) {
    paradt__insertion *build = &f->flipper.build;
    paradt__mesh *mesh = &build->scene.mesh;
    paradt__update *update = &build->update;
    size_t corners = (size_t)mesh->corners, place;
    paradt_status status = paradt__list_room(&update->killed, 0, &update->killed_capacity, corners + 1, build->memory);
    if (!status && corners <= 4)
        status = paradt__insertion_reserve(
            build, 1, paradt__expected_places(paradt__insertion_first_points(build), mesh->corners - 1));
    if (!status) status = paradt__insertion_first_cells(build);
    if (status) return status;
    build->inserted = corners;
    f->history.width = corners + PARADT__NODE_VERTICES;
    status = paradt__flips_room(f, corners + 1);
    for (place = 0; place < mesh->count && !status; place++)
        f->at[place].node = paradt__history_add(&f->history, PARADT__OPEN, (paradt_index)place,
                                                mesh->vertices + place * corners, mesh->corners);
    return status;
}

// Makes the closed mesh of a set, whose points are along a curve, by flips. Vertices are positions in the set. After an
// error the mesh is empty. stats: history_nodes and flips are filled.
PARADT__HOT paradt_status paradt__insert_by_flips(const paradt__set *set, paradt__memory *memory, paradt__mesh *mesh,
                                                  const paradt__progress *progress, paradt__counters *counters,
                                                  paradt_stats *stats) {
    paradt__flips f;
    paradt__insertion *build = &f.flipper.build;
    paradt_index *order = paradt__round_order(set->count, memory);
    paradt_status status;
    if (!order) return PARADT_ERROR_MEMORY;
    memset(&f, 0, sizeof f);
    f.counts = stats->flips;
    paradt__insertion_begin(build, set, order, memory);
    status = paradt__flips_begin(&f);
    if (!status) status = paradt__flips_go(&f, progress);
    stats->history_nodes = f.history.count;
    *counters = build->scene.space.counters;
    paradt__history_free(&f.history, memory);
    paradt__list_free(&f.facets, memory);
    paradt__release(memory, f.at);
    paradt__flipper_rest(&f.flipper);
    paradt__release(memory, order);
    *mesh = build->scene.mesh;
    if (status) paradt__mesh_free(mesh, memory);
    return status;
}
#endif // PARADT_NO_FLIPS

#if !defined(PARADT_NO_FRONTS) && !defined(PARADT_NO_REGIONS)
// ---------------------------------------------------------------------------------------------------------------------
// >>regions of fronts
//
// Each box of space is a region. Regions of InCoDe and DeWall build their cells alone, and keep the cells that they own
// by the rule of >>reach. When all regions have ended, the facets between cells of different regions are matched.
// Vertices are positions in the set; owners are numbers of regions, or PARADT__OPEN. Doors: paradt__regions_assign,
// paradt__regions_deal, paradt__region_compact, paradt__regions_join.

// Fills owner[set->count] with the region of each point.
static void paradt__regions_assign(const paradt__set *set, const paradt__cuts *cuts, uint32_t *owner) {
    size_t i;
    for (i = 0; i < set->count; i++) owner[i] = (uint32_t)paradt__cuts_find(cuts, paradt__record(set, (paradt_index)i));
}

// Restores the order of the boxes among points that were in that order until a grid moved them: the points from `begin`
// to `end`, of `boxes` boxes from `first` on.
static void paradt__regions_deal(paradt__set *set, const paradt__cuts *cuts, size_t begin, size_t end, size_t first,
                                 size_t boxes) {
    const paradt__cut *cut = cuts->cut + first + boxes / 2;
    size_t i, lower;
    if (boxes == 1) return;
    for (i = begin, lower = cut->begin; i < cut->begin; i++) {
        if (!paradt__cut_is_above(cut, paradt__record(set, (paradt_index)i))) continue;
        while (paradt__cut_is_above(cut, paradt__record(set, (paradt_index)lower))) lower++;
        PARADT_ASSERT(lower < end);
        paradt__exchange(set, set->width, i, lower++);
    }
    paradt__regions_deal(set, cuts, begin, cut->begin, first, boxes / 2);
    paradt__regions_deal(set, cuts, cut->begin, end, first + boxes / 2, boxes - boxes / 2);
}

// Gives the cluster of a cell that no region reaches to its owner: the first of the regions that own a cell next to the
// cluster, or, if there is none, the first that has a vertex of it. owners: [mesh->count]; cluster: room for all cells
// that are PARADT__OPEN
static void paradt__cluster_give(const paradt__mesh *mesh, const uint32_t *owner, paradt_index *owners,
                                 paradt_index *cluster, paradt_index first) {
    enum { IN_CLUSTER = -3 };
    paradt_index beside = PARADT__NOWHERE, within = PARADT__NOWHERE, corners = mesh->corners, i, j, count = 1;
    cluster[0] = first;
    owners[first] = IN_CLUSTER;
    for (i = 0; i < count; i++) {
        for (j = cluster[i] * corners; j < (cluster[i] + 1) * corners; j++) {
            paradt_index neighbor = mesh->links[j] / corners, region = (paradt_index)owner[mesh->vertices[j]];
            if (region < within) within = region;
            if (mesh->links[j] < 0) continue;
            if (owners[neighbor] == PARADT__OPEN) owners[neighbor] = IN_CLUSTER, cluster[count++] = neighbor;
            else if (owners[neighbor] != IN_CLUSTER && owners[neighbor] < beside) beside = owners[neighbor];
        }
    }
    for (i = 0; i < count; i++) owners[cluster[i]] = beside < PARADT__NOWHERE ? beside : within;
}

// Fills owners[mesh->count] with the region that owns each cell.
static paradt_status paradt__find_owners(const paradt__mesh *mesh, const paradt__set *set,
                                         const paradt__region_view *view, const paradt__progress *progress,
                                         paradt__memory *memory, paradt_index *owners) {
    size_t corners = (size_t)mesh->corners, unreached = 0, i;
    paradt_index *cluster;
    for (i = 0; i < mesh->count; i++) {
        if (i % PARADT__PACE == PARADT__PACE - 1 && paradt__progress_cancels(progress, 1.0))
            return PARADT_ERROR_CANCELLED;
        owners[i] = paradt__cell_owner(view, set, mesh->vertices + i * corners, mesh->corners);
        unreached += owners[i] < 0;
    }
    if (!unreached) return PARADT_OK;
    cluster = (paradt_index *)paradt__alloc(memory, unreached, sizeof *cluster);
    if (!cluster) return PARADT_ERROR_MEMORY;
    for (i = 0; i < mesh->count; i++) {
        if (owners[i] < 0) paradt__cluster_give(mesh, view->owner, owners, cluster, (paradt_index)i);
    }
    paradt__release(memory, cluster);
    return PARADT_OK;
}

// Leaves only the cells that the region owns. Their facets in common with other regions' cells become open. *foreign:
// number of the cells dropped
static paradt_status paradt__region_compact(paradt__mesh *mesh, const paradt__set *set, const paradt__region_view *view,
                                            const paradt__progress *progress, paradt__memory *memory,
                                            uint64_t *foreign) {
    paradt__list dropped = {NULL, 0, 0};
    size_t i;
    paradt_index *owners = (paradt_index *)paradt__alloc(memory, mesh->count, sizeof *owners);
    paradt_status status =
        owners ? paradt__find_owners(mesh, set, view, progress, memory, owners) : PARADT_ERROR_MEMORY;
    for (i = 0; i < mesh->count && !status; i++) {
        if (owners[i] == (paradt_index)view->region) continue;
        paradt__mesh_drop(mesh, i, (size_t)mesh->corners, PARADT__OPEN);
        status = paradt__list_append(&dropped, (paradt_index)i, memory);
    }
    if (!status) {
        paradt__mesh_compact(mesh, dropped.count, &dropped, 1);
        *foreign = dropped.count;
        PARADT__VERIFY(mesh, 0, 0);
    }
    paradt__release(memory, owners);
    paradt__list_free(&dropped, memory);
    return status;
}

// Ties the open facets of all regions to their mirrors. Facets without a mirror become the hull's.
static paradt_status paradt__regions_join(paradt__mesh *all, paradt__meter *meter, paradt__memory *memory,
                                          uint64_t *hull_facets) {
    paradt__facets table;
    size_t facets = all->count * (size_t)all->corners, count = 0, i;
    paradt_index open[PARADT__JOINED];
    paradt_status status = paradt__facets_begin(&table, 0, 0, memory);
    for (i = 0; i < facets && !status; i++) {
        if (all->links[i] == PARADT__OPEN) open[count++] = (paradt_index)i;
        if (count < PARADT__JOINED && i + 1 < facets) continue;
        status = paradt__facets_join(&table, all, open, count, 0, memory);
        count = 0;
        if (!status && i % PARADT__PACE < PARADT__JOINED && paradt__meter_cancels(meter))
            status = PARADT_ERROR_CANCELLED;
    }
    for (i = 0; i < facets; i++) {
        if (all->links[i] == PARADT__OPEN) all->links[i] = PARADT__HULL;
        *hull_facets += all->links[i] == PARADT__HULL;
    }
    if (!status) PARADT__VERIFY(all, 0, 0);
    paradt__facets_free(&table, memory);
    return status;
}
#endif // PARADT_NO_FRONTS, PARADT_NO_REGIONS

#ifndef PARADT_NO_REGIONS
// ---------------------------------------------------------------------------------------------------------------------
// >>fringe
//
// What regions by insertion and ranks have in common: which of their cells could be wrong, and which they own. Either
// is called a part here.
//
// A part inserts S: its own points and some points of other parts. The own points are the first vertices of its mesh,
// [0, own). Which cells of T(S) could be in conflict with a point of P that is missing? Let K be a convex set, a box
// here, such that S has all points of P in K. So a missing point q is outside K. The cells and ghosts of T(S) in
// conflict with q are connected through facets, and one of them contains q, or is a ghost that has q strictly beyond
// its facet. A cell that contains q has a vertex outside K, since K is convex.
//
// Let a cell with an own vertex be in conflict with q, and follow a path of such cells from it to the one that contains
// q. If all of them have own vertices, so has the last, which is a ghost or has a vertex outside K. Otherwise some cell
// on the path is the first without an own vertex. The facet that it has in common with the cell before it has none
// either, so that cell has just one. In both cases a *suspect* is in conflict with q. The suspects are, of the cells
// and ghosts with an own vertex:
//
//     ghosts; cells with a vertex that may be outside K; cells with just one own vertex
//
// So if no suspect is in conflict with a missing point, no cell with an own vertex is: then the own points have all
// their cells of T(P). Whether cells without an own vertex are right does not matter.
//
// A cell or ghost is owned by the last part that has a vertex of it. A part whose points have all their cells has all
// the cells that it owns.
//
// The fringe consists of all ghosts, and of all cells with a vertex that is not own. All suspects are in the fringe,
// and so is everything that the part does not own. Its list may name a place more than once, and places whose cells
// have been in the fringe. PARADT__LISTED marks only places that the list names.
// Doors: paradt__fringe_add, paradt__fringe_add_next, paradt__fringe_list, paradt__fringe_forget, paradt__is_suspect,
// paradt__owns.

// Adds a place to the list of the fringe, unless it is marked as listed.
PARADT__INLINE paradt_status paradt__fringe_add(paradt__list *fringe, paradt__mesh *mesh, paradt_index place,
                                                paradt__memory *memory) {
    return paradt__mesh_mark(mesh, (size_t)place, PARADT__LISTED) ? paradt__list_append(fringe, place, memory)
                                                                  : PARADT_OK;
}

// Finds the first place of the fringe from *place on and adds it. On return *place is that place, or mesh->count if
// there is none. corners: the mesh's; inlined with a constant
PARADT__INLINE paradt_status paradt__fringe_add_next(paradt__list *fringe, paradt__mesh *mesh, size_t corners,
                                                     paradt_index own, size_t *place, paradt__memory *memory) {
    *place = paradt__mesh_fringe_from(mesh, corners, own, *place);
    return *place < mesh->count ? paradt__fringe_add(fringe, mesh, (paradt_index)*place, memory) : PARADT_OK;
}

// Empties the list of the fringe.
static void paradt__fringe_forget(paradt__list *fringe, paradt__mesh *mesh) {
    size_t i;
    for (i = 0; i < fringe->count; i++) paradt__mesh_unmark(mesh, (size_t)fringe->items[i], PARADT__LISTED);
    fringe->count = 0;
}

// Lists the fringe anew.
static paradt_status paradt__fringe_list(paradt__list *fringe, paradt__mesh *mesh, paradt_index own,
                                         paradt__memory *memory) {
    paradt_status status = PARADT_OK;
    size_t place = 0;
    for (paradt__fringe_forget(fringe, mesh); place < mesh->count && !status; place++) {
        status = mesh->corners == 4 ? paradt__fringe_add_next(fringe, mesh, 4, own, &place, memory)
                                    : paradt__fringe_add_next(fringe, mesh, (size_t)mesh->corners, own, &place, memory);
    }
    return status;
}

// Is the cell or ghost a suspect? outer: vertices from this one on may be outside K; marks: NULL, or 1 for those of the
// vertices [own, outer) that may be, from `own` on. Without branches, which could not be predicted.
PARADT__INLINE int paradt__is_suspect(const paradt_index *vertices, size_t corners, paradt_index own,
                                      paradt_index outer, const unsigned char *marks) {
    int own_vertices = paradt__vertices_below(vertices, corners, own), outside = own_vertices == 1;
    size_t i;
    for (i = 0; i < corners; i++) {
        paradt_index vertex = vertices[i];
        outside |= (vertex < 0) | (vertex >= outer);
        if (marks) outside |= (vertex >= own) & (vertex < outer) & marks[vertex >= own ? vertex - own : 0];
    }
    return (own_vertices > 0) & outside;
}

// Does the part own the cell or ghost: does it have a vertex of it, and no later part? bits: [vertices] has the bit
// `later` for points of later parts
PARADT__INLINE int paradt__owns(const paradt_index *vertices, size_t corners, paradt_index own,
                                const paradt_index *bits, paradt_index later) {
    paradt_index all = 0;
    int has_own = 0;
    size_t i;
    for (i = 0; i < corners; i++) {
        has_own |= (paradt__tag)vertices[i] < (paradt__tag)own;
        all |= vertices[i] < 0 ? 0 : bits[vertices[i]];
    }
    return has_own && !(all & later);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>fields and patches
//
// A region by insertion is a patch. It inserts its own points, and those of other regions in a margin around its box,
// and then asks for every suspect (see >>fringe) whether another region has a point in conflict with it. Such a point
// is inserted, until all answers are no. The answers are exact, so the width of the margin does not matter for the
// result. K is the box with its margin, or the box alone where there is no margin.
//
// The first region owns the cells with its points alone. So if its points span the space, it inserts no others and asks
// nothing: what the other regions say of the seam (see there) decides which of its cells are right. If the points of a
// patch do not span the space, it inserts others that do: a region may have flat sets of points, or none.
//
// A region takes time and memory for its own points and the seam: of other regions it reads the points, through their
// grids, and the neighbours of points (see >>questions between regions).
//
// Positions are those of the whole set, in which each region has a *field*: its points along a curve, and behind them
// room for copies of others' points that only the region sees. Vertices of a patch are numbered on their own: the
// region's points in their order, then others' points in the order in which they came. paradt__patch_position
// translates.
// Doors: paradt__field_begin, paradt__spans, paradt__patch_begin, paradt__patch_use_memory, paradt__patch_points,
// paradt__patch_sort, paradt__patch_reserve, paradt__patch_add, paradt__patch_position, paradt__patch_is_own,
// paradt__patch_own_vertices, paradt__patch_rest, paradt__patch_end.

typedef struct paradt__field {
    paradt__set set; // owns nothing
    paradt__grid grid;
    size_t begin, capacity; // positions [begin, begin + set.count) are the points', up to begin + capacity the field's
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM]; // the region's box, unbounded at +-PARADT__FAR
    const struct paradt__patch *published;            // what the region has built, where others may look at it; or NULL
    paradt__mesh seam; // the seam as the region sees it, see there; vertices are positions in the set
    int has_cells;     // some cell or ghost of T(P) has a vertex of the region
} paradt__field;

typedef struct paradt__patch {
    // the region among others
    const paradt__set *set;
    const paradt__field *fields; // [field_count]
    size_t field_count;
    const paradt__field *own; // the region's
    int own_points_only;      // it is the first region, begins with its own points alone, and asks nothing
    paradt__memory *memory;

    // the insertion and its points
    paradt__insertion build;
    paradt_index *order;               // of the insertion of the first points
    size_t capacity;                   // points that the arrays below have room for
    double *records;                   // [capacity][build.scene.width]
    int records_lent;                  // these are those of the field
    paradt_index *others;              // [capacity - own points] positions of others' points in the set
    paradt__list margin;               // while points are collected, positions of others' points in K
    double bounds[2 * PARADT_MAX_DIM]; // K: low and high of each axis
    int has_margin;                    // S has all points in K, with those on its border
    size_t outer;                      // vertices from this one on may be outside K

    // the questions about cells
    paradt__search search;     // is put to the fields one by one
    paradt__set unbounded_set; // the set without a bound on positions: fields have gaps between them
    paradt__list fringe;       // see >>fringe; of the first region, the ghosts
    paradt__list waiting;      // cells to be asked about
    paradt__list deferred;     // cells to be asked about when neighbours have been learned from other regions
    int is_asking;             // the points to begin with are inserted
    size_t questions;          // cells taken from `waiting`
    size_t answer_cells;       // cells made by the insertion of answers

    // neighbours learned from other regions
    paradt_index *a_cell;       // [own points] one of the cells at each point, for others to look at; or NULL
    paradt__list neighbor_ends; // for the first of others' points, where in `neighbors` each one's neighbours end
    paradt__list neighbors;     // as positions in the set; no neighbours of a point that has too many
    uint64_t neighbor_effort;   // groups of neighbours that have been looked at

    // the seam
    paradt__list seam_cells; // cells that were on the seam when they were asked about
    paradt__list wrong;      // cells and ghosts of the first region that are not of T(P)

    // the result
    paradt_index *origin;       // the caller's indices of all points, or -1 for the points of later regions:
    paradt_index *origin_block; // in this block, or, if it is NULL, in the field's part of set.origin
    size_t dropped;             // cells and ghosts that are not delivered
    paradt__list open;          // facets delivered without a mirror, numbered as in the result
    size_t cells_built;         // cells of the triangulation, of which the mesh has the owned ones in the end
    uint64_t hull_facets;       // of the hull of T(P), whose ghosts the region owns
} paradt__patch;

// Begins the field of `count` points of the set, without a grid. field->begin is set.
static void paradt__field_begin(paradt__field *field, const paradt__set *set, size_t count) {
    int axis;
    field->set = *set;
    field->set.records = set->records + field->begin * set->width;
    field->set.origin = NULL;
    field->set.count = count;
    for (axis = 0; axis < PARADT_MAX_DIM; axis++) {
        field->low[axis] = -PARADT__FAR;
        field->high[axis] = PARADT__FAR;
    }
}

// Has the patch take memory from this account, and return to it what it has.
static void paradt__patch_use_memory(paradt__patch *patch, paradt__memory *memory) {
    patch->memory = patch->build.memory = memory;
}

// Begins the patch of region number `own`. first_alone: the first region's points span the space
static void paradt__patch_begin(paradt__patch *patch, const paradt__set *set, const paradt__field *fields,
                                size_t field_count, size_t own, int first_alone, paradt__memory *memory) {
    paradt__scene *scene = &patch->build.scene;
    size_t i;
    PARADT_ASSERT(own < field_count);
    memset(patch, 0, sizeof *patch);
    patch->set = set;
    patch->unbounded_set = *set;
    patch->unbounded_set.count = (size_t)PARADT__NOWHERE;
    patch->fields = fields;
    patch->field_count = field_count;
    patch->own = fields + own;
    patch->own_points_only = first_alone && own == 0;
    paradt__patch_use_memory(patch, memory);
    paradt__mesh_begin(&scene->mesh, set->space.dim + 1, 1);
    scene->space = set->space;
    memset(&scene->space.counters, 0, sizeof scene->space.counters);
    paradt__insertion_layout(&patch->build, set);
    paradt__search_begin(&patch->search, &fields[own].set, &fields[own].grid);
    for (i = 0; i < field_count; i++) paradt__search_admit(&patch->search, &fields[i].grid);
}

// Frees what only building needs: all patches wait together for the last step.
static void paradt__patch_rest(paradt__patch *patch) {
    paradt__insertion_rest(&patch->build);
    paradt__mesh_free_marks(&patch->build.scene.mesh, patch->memory);
    paradt__release(patch->memory, patch->order);
    if (!patch->records_lent) paradt__release(patch->memory, patch->records);
    paradt__release(patch->memory, patch->a_cell);
    paradt__list_free(&patch->waiting, patch->memory);
    paradt__list_free(&patch->deferred, patch->memory);
    paradt__list_free(&patch->neighbor_ends, patch->memory);
    paradt__list_free(&patch->neighbors, patch->memory);
    paradt__list_free(&patch->seam_cells, patch->memory);
    patch->build.order = patch->order = NULL;
    patch->records = NULL;
    patch->a_cell = NULL;
}

// Frees all that the patch has, its mesh included.
static void paradt__patch_end(paradt__patch *patch) {
    paradt__patch_rest(patch);
    paradt__list_free(&patch->margin, patch->memory);
    paradt__list_free(&patch->wrong, patch->memory);
    paradt__list_free(&patch->fringe, patch->memory);
    paradt__list_free(&patch->open, patch->memory);
    paradt__insertion_end(&patch->build);
    paradt__release(patch->memory, patch->others);
    paradt__release(patch->memory, patch->origin_block);
}

// --- vertices

// Is the vertex a point of the region? The infinite vertex is not.
PARADT__INLINE int paradt__patch_is_own(const paradt__patch *patch, paradt_index vertex) {
    return (size_t)vertex < patch->own->set.count;
}

// The position of a vertex in the set
PARADT__INLINE paradt_index paradt__patch_position(const paradt__patch *patch, paradt_index vertex) {
    size_t own = patch->own->set.count;
    PARADT_ASSERT(vertex >= 0 && (size_t)vertex < patch->build.count);
    return (size_t)vertex < own ? (paradt_index)patch->own->begin + vertex : patch->others[(size_t)vertex - own];
}

// Number of the vertices of a cell or ghost that are the region's; 0: the cell does not matter to the region.
static int paradt__patch_own_vertices(const paradt__patch *patch, paradt_index cell) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    return paradt__vertices_below(paradt__mesh_row(mesh, cell), (size_t)mesh->corners,
                                  (paradt_index)patch->own->set.count);
}

// Makes room for `capacity` points. Records in the field are copied, since other regions read the field.
static paradt_status paradt__patch_reserve(paradt__patch *patch, size_t capacity) {
    size_t used = patch->build.count, width = patch->build.scene.width, own = patch->own->set.count;
    void *records = patch->records_lent ? NULL : patch->records, *others = patch->others;
    PARADT_ASSERT(capacity > patch->capacity);
    if (!paradt__grow(patch->memory, &records, patch->records_lent ? 0 : used * width, capacity * width,
                      sizeof(double)))
        return PARADT_ERROR_MEMORY;
    if (patch->records_lent) memcpy(records, patch->records, used * width * sizeof(double));
    patch->records_lent = 0;
    patch->records = (double *)records;
    patch->build.scene.records = patch->records;
    used = used > own ? used - own : 0;
    if (!paradt__grow(patch->memory, &others, used, capacity - own, sizeof *patch->others)) return PARADT_ERROR_MEMORY;
    patch->others = (paradt_index *)others;
    patch->capacity = capacity;
    return PARADT_OK;
}

// Takes the field's records for those of the insertion.
static paradt_status paradt__patch_lend(paradt__patch *patch) {
    const paradt__field *own = patch->own;
    patch->others = (paradt_index *)paradt__alloc(patch->memory, own->capacity - own->set.count, sizeof *patch->others);
    if (!patch->others) return PARADT_ERROR_MEMORY;
    patch->records = own->set.records;
    patch->build.scene.records = patch->records;
    patch->capacity = own->capacity;
    patch->records_lent = 1;
    return PARADT_OK;
}

// Adds the region's own points, for which there is room.
static void paradt__patch_add_own(paradt__patch *patch) {
    const paradt__field *own = patch->own;
    size_t width = patch->build.scene.width, i;
    for (i = 0; i < own->set.count && !patch->records_lent; i++)
        paradt__copy_record(patch->records + i * width, own->set.records + i * own->set.width, width);
    patch->build.count = own->set.count;
}

// Adds another region's point.
static paradt_status paradt__patch_add(paradt__patch *patch, size_t position) {
    size_t at = patch->build.count, width = patch->build.scene.width;
    paradt_status status = at < patch->capacity ? PARADT_OK : paradt__patch_reserve(patch, at + at / 8 + 256);
    PARADT_ASSERT(at >= patch->own->set.count && position - patch->own->begin >= patch->own->set.count);
    if (status) return status;
    paradt__copy_record(patch->records + at * width, patch->set->records + position * patch->set->width, width);
    patch->others[at - patch->own->set.count] = (paradt_index)position;
    patch->build.count++;
    return PARADT_OK;
}

// --- the points to begin with

// Returns the width of the margin: about one and a half distances between neighbours. 0: there is none, since
// differences of coordinates may overflow, or the box is cut across an axis that orient does not use.
static double paradt__field_margin(const paradt__field *field) {
    const paradt__set *set = &field->set;
    int axis, open = 1;
    for (axis = set->space.dim; axis < set->space.ambient; axis++)
        open &= field->low[axis] == -PARADT__FAR && field->high[axis] == PARADT__FAR;
    if (!set->space.filtered || !open) return 0.0;
    return paradt__margin_for(paradt__spacing(set->records, set->width, set->space.dim, NULL, set->count));
}

// Sets K, and lists the points of other regions in it.
static paradt_status paradt__patch_find_margin(paradt__patch *patch) {
    const paradt__field *own = patch->own, *field;
    double margin = paradt__field_margin(own), low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    paradt_status status = PARADT_OK;
    int axis;
    for (axis = 0; axis < patch->set->space.dim; axis++) {
        patch->bounds[2 * axis] = low[axis] = own->low[axis] - margin;
        patch->bounds[2 * axis + 1] = high[axis] = own->high[axis] + margin;
    }
    patch->has_margin = margin > 0.0;
    for (field = patch->fields; field < patch->fields + patch->field_count && patch->has_margin && !status; field++) {
        if (field != own)
            status = paradt__grid_list_within(&field->grid, &field->set, low, high, field->begin, &patch->margin,
                                              patch->memory);
    }
    return status;
}

// The points that the patch has so far, as a set
static paradt__set paradt__patch_as_set(const paradt__patch *patch) {
    paradt__set known = *patch->set;
    known.records = patch->records;
    known.width = patch->build.scene.width;
    known.count = patch->build.count;
    memset(&known.space.counters, 0, sizeof known.space.counters);
    return known;
}

// Do the points of a set span the space?
static int paradt__spans(const paradt__set *set) {
    paradt_index basis[PARADT_MAX_DIM + 1];
    paradt__counters counters;
    memset(&counters, 0, sizeof counters);
    return set->count > (size_t)set->space.dim &&
           paradt__set_basis(set, NULL, 0, basis, NULL, &counters, NULL) == set->space.dim + 1;
}

// If the patch's points do not span the space, adds those of `basis` that it has not got; basis: positions of points
// that span. Only then, because of points far away cells at the hull get so large that floating point cannot decide
// about their spheres.
static paradt_status paradt__patch_add_span(paradt__patch *patch, const paradt_index *basis) {
    paradt__set known = paradt__patch_as_set(patch);
    int i;
    size_t j;
    paradt_status status = PARADT_OK;
    patch->outer = patch->has_margin ? known.count : patch->own->set.count;
    if (paradt__spans(&known)) return PARADT_OK;
    for (i = 0; i <= known.space.dim && !status; i++) {
        for (j = 0; j < known.count && paradt__patch_position(patch, (paradt_index)j) != basis[i];) j++;
        if (j == known.count) status = paradt__patch_add(patch, (size_t)basis[i]);
    }
    return status;
}

// Makes the order of insertion: points in the margin along with the region's.
static paradt_status paradt__patch_sort(paradt__patch *patch) {
    const paradt__field *own = patch->own;
    paradt__set known = paradt__patch_as_set(patch);
    const paradt__space *space = &patch->set->space;
    paradt__curve curve;
    int64_t low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    int axis;
    paradt__curve_begin(&curve, space->ambient, paradt__levels_for(patch->set->count, space->ambient), space->low,
                        space->high, known.count / 8);
    for (axis = 0; axis < space->ambient; axis++) {
        low[axis] = paradt__ordered_bits(own->low[axis]);
        high[axis] = paradt__ordered_bits(own->high[axis]);
    }
    paradt__curve_limit(&curve, low, high);
    patch->order = paradt__merged_order(&known, own->set.count, &curve, patch->memory);
    if (!patch->order) return PARADT_ERROR_MEMORY;
    patch->build.order = patch->order;
    paradt__insertion_span_first(&known, patch->order, &patch->build.scene.space.counters);
    return PARADT_OK;
}

// Collects the points to begin with. The first region, if it begins with its own points alone, sorts them now, while
// the others look for points in their margins; the others sort when they build. basis: positions of points that span
// the space
static paradt_status paradt__patch_points(paradt__patch *patch, const paradt_index *basis) {
    const paradt__field *own = patch->own;
    size_t needed, i;
    paradt_status status = patch->own_points_only ? PARADT_OK : paradt__patch_find_margin(patch);
    if (!status) status = paradt__patch_lend(patch);
    needed = own->set.count + (patch->own_points_only ? 0 : patch->margin.count + (size_t)patch->set->space.dim + 1);
    if (!status && patch->capacity < needed) status = paradt__patch_reserve(patch, needed + needed / 64 + 256);
    if (status) return status;
    paradt__patch_add_own(patch);
    for (i = 0; i < patch->margin.count && !status; i++)
        status = paradt__patch_add(patch, (size_t)patch->margin.items[i]);
    paradt__list_free(&patch->margin, patch->memory);
    if (!status) status = paradt__patch_add_span(patch, basis);
    return status || !patch->own_points_only ? status : paradt__patch_sort(patch);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>questions between regions
//
// How a patch gets from the triangulation of its first points to all cells of T(P) with a vertex of the region. It asks
// about the cells that wait, first of all the suspects (see >>fringe), and inserts the answers; new cells have to wait
// in turn. A cell need not be asked about if its sphere is inside K; nor a ghost near a reference sphere, if the cap of
// that sphere beyond the ghost's facet is inside K.
//
// A question about a cell is put to the other fields one by one, in one of two ways. Through the field's grid, by
// the doors of >>questions. Or through the neighbours of a vertex:
//
// Let v be a vertex of the cell, or of the ghost's facet, and a point of a set Q. If any point of Q is in conflict with
// the cell, so is one of v's neighbours in T(Q). For, lifted, Q is in the convex cone that the edges at v and the
// upward vertical span; and the hyperplane of the cell passes through v, so if none of the edges leads below it,
// nothing in the cone is below it. What a region has built is at any time a triangulation of a set Q of all its own
// points and some more. So v's neighbours there, learned at any time, decide for all points of that region. They are
// few, also near surfaces, where large spheres touch many boxes of the grid and the grid rules out little.
//
// So when a region finds that learning is faster than searching, it waits until all regions have built. Then each
// publishes its mesh; the waiting regions learn the neighbours of those points that they have from other regions, while
// no mesh changes; and they go on. A cell whose vertices came only after that is deferred until the next such round.
//
// Marks: PARADT__WAITING where a cell waits, or is deferred; PARADT__ASKED where it has been asked about. Neither where
// the cell was made after that.
// Doors: paradt__patch_build, paradt__patch_complete, paradt__patch_pauses, paradt__patch_publish,
// paradt__patch_learn_all, paradt__patch_on_seam, paradt__patch_done, paradt__patch_left.

// Is the cell or ghost on the seam: has it one vertex of the region, and no others but the first region's?
static int paradt__patch_on_seam(const paradt__patch *patch, paradt_index cell) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    const paradt_index *vertices = paradt__mesh_row(mesh, cell);
    paradt_index end = (paradt_index)patch->fields[0].set.count;
    int i, own_vertices = 0;
    for (i = 0; i < mesh->corners; i++) {
        if (vertices[i] < 0) continue;
        if (paradt__patch_is_own(patch, vertices[i])) own_vertices++;
        else if (paradt__patch_position(patch, vertices[i]) >= end) return 0;
    }
    return own_vertices == 1 && patch->own != patch->fields;
}

// Adds a cell to those that wait, unless it waits or has been asked about.
static paradt_status paradt__patch_add_waiting(paradt__patch *patch, paradt_index cell) {
    paradt__mesh *mesh = &patch->build.scene.mesh;
    if (mesh->marks[cell] & PARADT__ASKED || !paradt__mesh_mark(mesh, (size_t)cell, PARADT__WAITING)) return PARADT_OK;
    return paradt__list_append(&patch->waiting, cell, patch->memory);
}

// Lists the fringe, and has its suspects wait. corners: the mesh's; inlined with a constant
PARADT__INLINE paradt_status paradt__patch_list_suspects(paradt__patch *patch, size_t corners) {
    paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt_index own = (paradt_index)patch->own->set.count, outer = (paradt_index)patch->outer;
    paradt_status status = PARADT_OK;
    size_t place = 0;
    for (; !status; place++) {
        status = paradt__fringe_add_next(&patch->fringe, mesh, corners, own, &place, patch->memory);
        if (status || place == mesh->count) break;
        if (paradt__is_suspect(mesh->vertices + place * corners, corners, own, outer, NULL))
            status = paradt__patch_add_waiting(patch, (paradt_index)place);
    }
    return status;
}

// Begins asking. Listing the suspects takes as long as inserting some points, while the other regions go on.
static paradt_status paradt__patch_begin_asking(paradt__patch *patch) {
    enum { CELLS_A_POINT = 400 };
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    PARADT__VERIFY(mesh, 1, PARADT__CONFLICT);
    patch->is_asking = 1;
    if (patch->own_points_only) return PARADT_OK;
    paradt__relay_waits(patch->build.relay, mesh->count / CELLS_A_POINT);
    if (mesh->corners == 4) return paradt__patch_list_suspects(patch, 4);
    return paradt__patch_list_suspects(patch, (size_t)mesh->corners);
}

// --- asking

// States the question about a cell: is any point in its sphere, or, for a ghost, strictly beyond its facet? ghost: the
// place of the infinite vertex; -1: none
static void paradt__patch_state_question(paradt__patch *patch, paradt_index cell, int ghost) {
    const paradt__scene *scene = &patch->build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    const paradt_index *vertices = paradt__mesh_row(mesh, cell);
    const double *corners[PARADT_MAX_DIM + 1];
    paradt_index nowhere[PARADT_MAX_DIM + 1];
    int i;
    for (i = 0; i < mesh->corners; i++) {
        nowhere[i] = PARADT__NOWHERE;
        if (i != ghost) corners[i] = paradt__record(patch->set, paradt__patch_position(patch, vertices[i]));
    }
    if (ghost < 0) {
        paradt__question_cell(&patch->search, corners, nowhere);
    } else { // the vertex behind the facet, which is on the other side, takes the infinite vertex's place
        paradt_index inner = mesh->vertices[mesh->links[cell * mesh->corners + ghost]];
        corners[ghost] = paradt__scene_record(scene, inner);
        paradt__question_facet(&patch->search, corners, nowhere, ghost, -1);
    }
}

// Puts the question to a field's grid. Returns a point of the field that is an answer, or -1. positions: of the cell's
// vertices
static paradt_index paradt__patch_ask_grid(paradt__patch *patch, const paradt__field *field,
                                           const paradt_index *positions) {
    paradt_index places[PARADT_MAX_DIM + 1], found;
    int i;
    for (i = 0; i < patch->build.scene.mesh.corners; i++) {
        size_t place = (size_t)positions[i] - field->begin;
        places[i] = place < field->set.count ? (paradt_index)place : PARADT__NOWHERE;
    }
    paradt__question_redirect(&patch->search, &field->set, &field->grid, places);
    found = paradt__question_answer(&patch->search);
    return found >= 0 ? found + (paradt_index)field->begin : (paradt_index)-1;
}

// Where the neighbours of others' point number `other` begin; its end is where the next one's begin.
static size_t paradt__patch_neighbors_from(const paradt__patch *patch, size_t other) {
    return other ? (size_t)patch->neighbor_ends.items[other - 1] : 0;
}

// Puts the question to the learned neighbours of a vertex. Returns one that is an answer, or -1. other: the vertex, as
// the number of others' point
static paradt_index paradt__patch_ask_neighbors(paradt__patch *patch, size_t other, const paradt_index *positions) {
    size_t i = paradt__patch_neighbors_from(patch, other), end = paradt__patch_neighbors_from(patch, other + 1);
    patch->neighbor_effort += 1 + (end - i) / PARADT__LANES;
    paradt__question_redirect(&patch->search, &patch->unbounded_set, NULL, positions);
    for (; i < end; i++) {
        paradt_index neighbor = patch->neighbors.items[i];
        if (paradt__question_fits(&patch->search, (size_t)neighbor)) return neighbor;
    }
    return -1;
}

// Returns a vertex of the cell that is the field's, as the number of others' point: one whose neighbours have been
// learned and are not too many; otherwise one whose neighbours have not been learned yet; otherwise SIZE_MAX.
static size_t paradt__patch_witness(const paradt__patch *patch, const paradt__field *field, paradt_index cell) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    const paradt_index *vertices = paradt__mesh_row(mesh, cell);
    size_t own = patch->own->set.count, unlearned = SIZE_MAX;
    int i;
    for (i = 0; i < mesh->corners; i++) {
        size_t other = (size_t)vertices[i] - own;
        if (vertices[i] < 0) continue;
        if ((size_t)paradt__patch_position(patch, vertices[i]) - field->begin >= field->set.count) continue;
        if (other >= patch->neighbor_ends.count) unlearned = other;
        else if (paradt__patch_neighbors_from(patch, other + 1) > paradt__patch_neighbors_from(patch, other))
            return other;
    }
    return unlearned;
}

// Does the question about the cell take neighbours that have not been learned yet?
static int paradt__patch_must_defer(const paradt__patch *patch, paradt_index cell) {
    const paradt__field *field = patch->fields, *end = field + patch->field_count;
    for (; field < end; field++) {
        size_t witness;
        if (field == patch->own || !field->published) continue;
        witness = paradt__patch_witness(patch, field, cell);
        if (witness != SIZE_MAX && witness >= patch->neighbor_ends.count) return 1;
    }
    return 0;
}

// Puts the stated question about a cell to another region's field. Returns a point of the field that is an answer, or
// -1.
static paradt_index paradt__patch_ask(paradt__patch *patch, const paradt__field *field, paradt_index cell, int ghost) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    const paradt_index *vertices = paradt__mesh_row(mesh, cell);
    paradt_index positions[PARADT_MAX_DIM + 1];
    size_t witness = field->published ? paradt__patch_witness(patch, field, cell) : SIZE_MAX;
    int i;
    for (i = 0; i < mesh->corners; i++)
        positions[i] = i == ghost ? PARADT__NOWHERE : paradt__patch_position(patch, vertices[i]);
    return witness == SIZE_MAX ? paradt__patch_ask_grid(patch, field, positions)
                               : paradt__patch_ask_neighbors(patch, witness, positions);
}

// Notes the cell as one of those at its own vertices.
PARADT__INLINE void paradt__patch_note_cell(paradt__patch *patch, paradt_index cell) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    const paradt_index *vertices = paradt__mesh_row(mesh, cell);
    int i;
    for (i = 0; i < mesh->corners; i++) {
        if (paradt__patch_is_own(patch, vertices[i])) patch->a_cell[vertices[i]] = cell;
    }
}

// Inserts a point in conflict with the cell. Nothing is known about the new cells: those with own vertices have to
// wait.
static paradt_status paradt__patch_insert(paradt__patch *patch, size_t position, paradt_index cell) {
    paradt__insertion *build = &patch->build;
    paradt__mesh *mesh = &build->scene.mesh;
    const paradt__update *update = &build->update;
    size_t i;
    paradt_status status = paradt__patch_add(patch, position);
    if (!status) status = paradt__insert_one_more(build, (paradt_index)(build->count - 1), cell);
    patch->answer_cells += update->made_count;
    for (i = 0; i < update->killed_count && !status; i++)
        paradt__mesh_unmark(mesh, (size_t)paradt__mesh_cell(mesh, update->killed[i]), PARADT__WAITING | PARADT__ASKED);
    for (i = 0; i < update->made_count && !status; i++) {
        paradt_index made = paradt__mesh_cell(mesh, update->made[i]);
        PARADT_ASSERT(!(mesh->marks[made] & (PARADT__WAITING | PARADT__ASKED)));
        if (patch->a_cell) paradt__patch_note_cell(patch, made);
        status = paradt__fringe_add(&patch->fringe, mesh, made, patch->memory);
        if (!status && paradt__patch_own_vertices(patch, made)) status = paradt__patch_add_waiting(patch, made);
    }
    return status;
}

// Asks about a cell and inserts the answer, if there is one; or defers the cell.
static paradt_status paradt__patch_settle(paradt__patch *patch, paradt_index cell) {
    paradt__mesh *mesh = &patch->build.scene.mesh;
    const paradt__field *field = patch->fields, *end = field + patch->field_count;
    int ghost = paradt__ghost_place(paradt__mesh_row(mesh, cell), mesh->corners);
    paradt_index answer = -1;
    if (paradt__patch_must_defer(patch, cell)) return paradt__list_append(&patch->deferred, cell, patch->memory);
    paradt__mesh_unmark(mesh, (size_t)cell, PARADT__WAITING);
    paradt__mesh_mark(mesh, (size_t)cell, PARADT__ASKED);
    if (paradt__patch_on_seam(patch, cell)) {
        paradt_status status = paradt__list_append(&patch->seam_cells, cell, patch->memory);
        if (status) return status;
    }
    paradt__patch_state_question(patch, cell, ghost);
    if (patch->has_margin && paradt__question_is_confined(&patch->search, patch->bounds)) return PARADT_OK;
    for (; field < end && answer < 0; field++) {
        if (field != patch->own && field->set.count) answer = paradt__patch_ask(patch, field, cell, ghost);
    }
    if (answer >= 0) return paradt__patch_insert(patch, (size_t)answer, cell);
    if (ghost < 0) return PARADT_OK;
    // A point in the plane of the ghost's facet is in conflict with the ghost if it is with the cell behind the facet.
    return paradt__patch_add_waiting(patch, paradt__mesh_cell(mesh, mesh->links[cell * mesh->corners + ghost]));
}

// --- neighbours learned from other regions

// Makes the mesh ready to be looked at by other regions.
static paradt_status paradt__patch_publish(paradt__patch *patch) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    size_t cell;
    patch->a_cell = (paradt_index *)paradt__alloc(patch->memory, patch->own->set.count, sizeof *patch->a_cell);
    if (!patch->a_cell) return PARADT_ERROR_MEMORY;
    for (cell = 0; cell < mesh->count; cell++) {
        if (mesh->vertices[cell * (size_t)mesh->corners] != PARADT__DEAD)
            paradt__patch_note_cell(patch, (paradt_index)cell);
    }
    return PARADT_OK;
}

// Appends the neighbours of another region's own point in its mesh, each at least once; none if they are too many.
static paradt_status paradt__patch_learn(paradt__patch *patch, const paradt__patch *other, paradt_index vertex) {
    const paradt__mesh *mesh = &other->build.scene.mesh;
    paradt_index first = other->a_cell[vertex], base = first * (paradt_index)mesh->corners, i;
    paradt__star star;
    size_t next;
    paradt_status status = PARADT_OK;
    PARADT_ASSERT(paradt__patch_is_own(other, vertex));
    paradt__star_of(mesh, first, vertex, &star);
    patch->neighbor_effort += PARADT__LANES + star.count / 4;
    if (star.count > PARADT__STAR_CELLS) return PARADT_OK;
    for (i = base; i < base + mesh->corners && !status; i++) {
        if (mesh->vertices[i] != vertex && mesh->vertices[i] >= 0)
            status =
                paradt__list_append(&patch->neighbors, paradt__patch_position(other, mesh->vertices[i]), patch->memory);
    }
    for (next = 1; next < star.count && !status; next++) {
        paradt_index neighbor = mesh->vertices[star.handles[next]];
        if (neighbor >= 0)
            status = paradt__list_append(&patch->neighbors, paradt__patch_position(other, neighbor), patch->memory);
    }
    return status;
}

// Learns the neighbours of all points that the patch has from regions that have published. Deferred cells wait again.
static paradt_status paradt__patch_learn_all(paradt__patch *patch) {
    size_t own = patch->own->set.count, i;
    paradt_status status = PARADT_OK;
    while (own + patch->neighbor_ends.count < patch->build.count && !status) {
        paradt_index position = patch->others[patch->neighbor_ends.count];
        const paradt__field *field = patch->fields;
        while ((size_t)position - field->begin >= field->set.count) field++;
        PARADT_ASSERT(field != patch->own && field < patch->fields + patch->field_count);
        if (field->published)
            status = paradt__patch_learn(patch, field->published, position - (paradt_index)field->begin);
        if (!status)
            status = paradt__list_append(&patch->neighbor_ends, (paradt_index)patch->neighbors.count, patch->memory);
    }
    for (i = 0; i < patch->deferred.count && !status; i++)
        status = paradt__list_append(&patch->waiting, patch->deferred.items[i], patch->memory);
    patch->deferred.count = 0;
    return status;
}

// --- building

// Number of groups of boxes and of neighbours that have been looked at for answers
static uint64_t paradt__patch_effort(const paradt__patch *patch) {
    return paradt__search_effort(&patch->search) + patch->neighbor_effort;
}

// Is it faster to learn neighbours now than to go on searching? Learning a point's neighbours takes as long as some
// looks.
static int paradt__patch_learning_pays(const paradt__patch *patch) {
    size_t others = patch->build.count - patch->own->set.count;
    return paradt__patch_effort(patch) > 10000 + patch->build.scene.mesh.count / 32 + 8 * others;
}

// Should the region give up? It should when the questions and the insertion of their answers take longer than to insert
// all points of another region, or of two where there are more. Making a cell takes as long as two looks or more, in
// high dimension many. Everything may be the seam, as on exactly cospherical points.
static int paradt__patch_gives_up(const paradt__patch *patch) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    uint64_t effort = paradt__patch_effort(patch) / (mesh->corners <= 4 ? 2 : 4);
    return effort + patch->answer_cells > mesh->count * (patch->field_count > 2 ? 2 : 1) + 5000;
}

// Inserts the points to begin with, until it pauses or begins asking.
static paradt_status paradt__patch_build(paradt__patch *patch, const paradt__progress *progress) {
    paradt__insertion *build = &patch->build;
    paradt_status status = patch->order ? PARADT_OK : paradt__patch_sort(patch);
    PARADT_ASSERT(!patch->is_asking);
    if (!status)
        status = build->inserted ? paradt__insertion_go(build, progress) : paradt__insertion_run(build, progress);
    if (!status && build->inserted < build->count) return PARADT_OK;
    paradt__release(patch->memory, patch->order);
    build->order = patch->order = NULL;
    if (!status) status = paradt__patch_begin_asking(patch);
    return status;
}

// So many questions, with the insertion of their answers, take as long as the insertion of a point.
enum { PARADT__QUESTIONS_A_POINT = 2 };

// Asks about the cells that wait, until all cells of T(P) with a vertex of the region are there, deferred ones
// excepted; or until it pauses. can_learn: it stops, with cells waiting, when learning is faster than searching
static paradt_status paradt__patch_complete(paradt__patch *patch, int can_learn, const paradt__progress *progress) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt_status status = PARADT_OK;
    PARADT_ASSERT(patch->is_asking);
    while (!status && patch->waiting.count && !(can_learn && paradt__patch_learning_pays(patch))) {
        paradt_index cell = patch->waiting.items[--patch->waiting.count];
        if (mesh->marks[cell] & PARADT__WAITING) status = paradt__patch_settle(patch, cell);
        if (!status && paradt__patch_gives_up(patch)) status = PARADT__GAVE_UP;
        if (++patch->questions % 1024 == 0 && paradt__progress_cancels(progress, 1.0)) return PARADT_ERROR_CANCELLED;
        if (paradt__relay_pauses(patch->build.relay, patch->questions, 64 / PARADT__QUESTIONS_A_POINT)) break;
    }
    return status;
}

// Has it paused, inserting or asking?
static int paradt__patch_pauses(const paradt__patch *patch, int can_learn) {
    return !patch->is_asking || (patch->waiting.count && !(can_learn && paradt__patch_learning_pays(patch)));
}

// What has been done, in points inserted
static size_t paradt__patch_done(const paradt__patch *patch) {
    return patch->build.inserted + patch->questions / PARADT__QUESTIONS_A_POINT;
}

// What is still to be done, in points inserted. The questions to come take as long as the insertion of the margin.
static size_t paradt__patch_left(const paradt__patch *patch) {
    const paradt__insertion *build = &patch->build;
    if (patch->is_asking) return patch->waiting.count / PARADT__QUESTIONS_A_POINT;
    return build->count - build->inserted + build->count - patch->own->set.count;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>seam
//
// Which cells of the first region are right, if it has its own points alone. It has built T(S) of its points S. As it
// owns the cells with its points alone, it has all of them: a cell of T(P) with vertices in S alone is one of T(S). But
// some cells of T(S) are wrong, in conflict with points of other regions.
//
// The other regions list the *seam*: cells and ghosts of T(P) with one vertex that is not in S, the apex. A facet of
// the seam is the facet of such a cell opposite the apex, with vertices in S alone. A facet that is listed twice has
// other regions' cells on both sides. Behind a facet that is listed once is a cell of T(P) with vertices in S alone; it
// is right. On the apex's side of this facet T(S) has a wrong cell: if the apex q were inserted into T(S) alone, the
// facet would get a cell with q, as it has in T(P). The cells of T(S) in conflict with q, all wrong, are connected
// through facets. So from the one that contains q all wrong cells around can be reached without crossing a facet that
// is listed once. And no right cell can: a facet between a right and a wrong cell is a facet of T(P), where the cell on
// its wrong side has a vertex that is not in S, just one, so the facet is listed, once.
//
// Each wrong cell is reached from some facet in this way, as the cells of T(S) are connected through facets, unless no
// facet is listed once. In that case all cells are wrong if any cell of T(P) has a vertex that is not in S; otherwise
// all are right.
//
// The seam is a mesh with positions for vertices, which for points of the first region are its own vertices too. Links
// of a cell's facets that do not belong to the seam are PARADT__HULL. Marks in the first region's mesh: PARADT__WRONG.
// Doors: paradt__patch_list_seam, paradt__patch_apply_seam.

// Adds a cell or ghost to the seam, with its facet opposite the apex open.
static paradt_status paradt__patch_add_to_seam(const paradt__patch *patch, paradt__mesh *seam, paradt_index cell) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    const paradt_index *vertices = paradt__mesh_row(mesh, cell);
    paradt_index handle, i;
    paradt_status status = paradt__mesh_room(seam, patch->memory);
    if (status) return status;
    handle = paradt__mesh_take(seam) * mesh->corners;
    for (i = 0; i < mesh->corners; i++, handle++) {
        seam->vertices[handle] = vertices[i] < 0 ? vertices[i] : paradt__patch_position(patch, vertices[i]);
        seam->links[handle] = paradt__patch_is_own(patch, vertices[i]) ? PARADT__OPEN : PARADT__HULL;
    }
    return PARADT_OK;
}

// Has any cell or ghost a vertex of the region?
static int paradt__patch_has_cells(const paradt__patch *patch) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt_index cell;
    for (cell = 0; (size_t)cell < mesh->count; cell++) {
        if (*paradt__mesh_row(mesh, cell) != PARADT__DEAD && paradt__patch_own_vertices(patch, cell)) return 1;
    }
    return 0;
}

// Lists the seam in the region's field, when all cells of T(P) with a vertex of the region are there.
static paradt_status paradt__patch_list_seam(paradt__patch *patch, paradt__field *field) {
    paradt__mesh *mesh = &patch->build.scene.mesh;
    size_t i;
    paradt_status status = PARADT_OK;
    PARADT_ASSERT(field == patch->own && !patch->own_points_only && !patch->waiting.count && !patch->deferred.count);
    PARADT__VERIFY(mesh, 1, PARADT__CONFLICT | PARADT__WAITING);
    paradt__mesh_begin(&field->seam, mesh->corners, 0);
    for (i = 0; i < patch->seam_cells.count && !status; i++) {
        paradt_index cell = patch->seam_cells.items[i];
        if (!(mesh->marks[cell] & PARADT__ASKED) || !paradt__patch_on_seam(patch, cell)) continue; // another one by now
        paradt__mesh_unmark(mesh, (size_t)cell, PARADT__ASKED); // it may be listed twice
        status = paradt__patch_add_to_seam(patch, &field->seam, cell);
    }
    field->has_cells = field->seam.count || paradt__patch_has_cells(patch);
    return status;
}

// --- what the other regions list, put together

// The links of facets that have been listed twice are handles. The link of a facet that has been listed once is
// PARADT__OPEN, and becomes PARADT__HULL when the wrong cell on its side has been reached.
typedef struct paradt__seam {
    paradt__mesh mesh;
    paradt__facets once; // facets that have been listed once, by keys
} paradt__seam;

static void paradt__seam_free(paradt__seam *seam, paradt__memory *memory) {
    paradt__mesh_free(&seam->mesh, memory);
    paradt__facets_free(&seam->once, memory);
}

// Puts together what the other regions have listed.
static paradt_status paradt__seam_begin(paradt__seam *seam, const paradt__patch *patch) {
    const paradt__field *end = patch->fields + patch->field_count, *field;
    int corners = patch->build.scene.mesh.corners;
    paradt_index facets, facet;
    size_t count = 0;
    paradt_status status;
    memset(seam, 0, sizeof *seam);
    paradt__mesh_begin(&seam->mesh, corners, 0);
    for (field = patch->fields + 1; field < end; field++) count += field->seam.count;
    status = paradt__mesh_reserve(&seam->mesh, count, count, patch->memory);
    if (!status) status = paradt__facets_begin(&seam->once, 0, 1, patch->memory);
    if (!status) status = paradt__facets_room(&seam->once, count, patch->memory);
    if (status) return status;
    for (field = patch->fields + 1; field < end; field++) {
        if (field->seam.count) paradt__mesh_append(&seam->mesh, &field->seam);
    }
    facets = (paradt_index)count * corners;
    for (facet = 0; facet < facets; facet++) {
        if (seam->mesh.links[facet] == PARADT__OPEN)
            paradt__facets_tie(&seam->once, &seam->mesh, paradt__facet_key_of(&seam->once, &seam->mesh, facet), facet,
                               corners);
    }
    PARADT__VERIFY(&seam->mesh, 0, 0);
    return PARADT_OK;
}

// Is the facet of a wrong cell listed once, so that the cell on the other side is right? The wrong cell has been
// reached then. sum: paradt__cell_sum of the cell; corners: the mesh's; inlined with a constant
PARADT__INLINE int paradt__seam_stops(const paradt__seam *seam, const paradt__mesh *mesh, paradt_index handle,
                                      uint64_t sum, int corners) {
    paradt__facet_key key = {0, paradt__facet_hash(sum - paradt__vertex_key(mesh->vertices[handle]))};
    paradt_index facet = paradt__facets_find(&seam->once, &seam->mesh, key, mesh->vertices, handle, corners);
    if (facet < 0) return 0;
    PARADT_ASSERT(seam->mesh.links[facet] == PARADT__OPEN); // a facet has one wrong side
    seam->mesh.links[facet] = PARADT__HULL;
    return 1;
}

// --- wrong cells

// Lists a wrong cell, unless it is listed.
static paradt_status paradt__patch_add_wrong(paradt__patch *patch, paradt_index cell) {
    if (!paradt__mesh_mark(&patch->build.scene.mesh, (size_t)cell, PARADT__WRONG)) return PARADT_OK;
    return paradt__list_append(&patch->wrong, cell, patch->memory);
}

// Flood fill from wrong.items[next] on: appends every cell that is reached without crossing the seam.
PARADT__INLINE paradt_status paradt__patch_flood_wrong(paradt__patch *patch, const paradt__seam *seam, size_t next,
                                                       int corners) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt_status status = PARADT_OK;
    int i;
    for (; next < patch->wrong.count && !status; next++) {
        paradt_index base = patch->wrong.items[next] * corners;
        uint64_t sum = paradt__cell_sum(mesh->vertices + base, corners);
        paradt__mesh_fetch_listed(mesh, patch->wrong.items, patch->wrong.count, next);
        for (i = 0; i < corners && !status; i++) {
            paradt_index other = mesh->links[base + i] / corners;
            if (!(mesh->marks[other] & PARADT__WRONG) && !paradt__seam_stops(seam, mesh, base + i, sum, corners))
                status = paradt__patch_add_wrong(patch, other);
        }
    }
    return status;
}

// Lists a wrong cell and all that are reached from it.
static paradt_status paradt__patch_list_wrong(paradt__patch *patch, const paradt__seam *seam, paradt_index first) {
    size_t next = patch->wrong.count;
    int corners = seam->mesh.corners;
    paradt_status status = paradt__patch_add_wrong(patch, first);
    if (status) return status;
    return corners == 4 ? paradt__patch_flood_wrong(patch, seam, next, 4)
                        : paradt__patch_flood_wrong(patch, seam, next, corners);
}

// Lists all cells and ghosts as wrong.
static paradt_status paradt__patch_list_all_wrong(paradt__patch *patch) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt_index cell;
    paradt_status status = PARADT_OK;
    for (cell = 0; (size_t)cell < mesh->count && !status; cell++) {
        if (*paradt__mesh_row(mesh, cell) != PARADT__DEAD) status = paradt__patch_add_wrong(patch, cell);
    }
    return status;
}

// Lists the wrong cells and ghosts of the first region.
static paradt_status paradt__patch_find_wrong(paradt__patch *patch, paradt__seam *seam) {
    paradt__scene *scene = &patch->build.scene;
    paradt_index cell = paradt__insertion_start(&patch->build);
    size_t facets = seam->mesh.count * (size_t)seam->mesh.corners, i;
    int others_have_cells = 0;
    paradt_status status = PARADT_OK;
    for (i = 1; i < patch->field_count; i++) others_have_cells |= patch->fields[i].has_cells;
    if (others_have_cells && !seam->once.count) return paradt__patch_list_all_wrong(patch);
    for (i = 0; i < facets && !status; i++) {
        if (seam->mesh.links[i] != PARADT__OPEN) continue;
        cell = paradt__walk(scene, cell, paradt__record(patch->set, seam->mesh.vertices[i]));
        status = paradt__patch_list_wrong(patch, seam, cell);
    }
    return status;
}

// --- ghosts

// Lists the ghosts that are reached from those in the fringe's list through facets.
static paradt_status paradt__patch_flood_ghosts(paradt__patch *patch) {
    paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt_index corners = (paradt_index)mesh->corners, i;
    size_t next;
    paradt_status status = PARADT_OK;
    for (next = 0; next < patch->fringe.count && !status; next++) {
        paradt_index base = patch->fringe.items[next] * corners;
        paradt__mesh_fetch_listed(mesh, patch->fringe.items, patch->fringe.count, next);
        for (i = base; i < base + corners && !status; i++) {
            if (mesh->vertices[i] != PARADT__INFINITE)
                status = paradt__fringe_add(&patch->fringe, mesh, mesh->links[i] / corners, patch->memory);
        }
    }
    return status;
}

// Lists the first region's fringe, which are its ghosts. If any ghost is wrong, so is the first cell that was listed.
static paradt_status paradt__patch_list_ghosts(paradt__patch *patch) {
    paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt_status status;
    if (!patch->wrong.count || paradt__is_finite_cell(paradt__mesh_row(mesh, patch->wrong.items[0]), mesh->corners))
        return paradt__fringe_list(&patch->fringe, mesh, PARADT__NOWHERE, patch->memory);
    status = paradt__fringe_add(&patch->fringe, mesh, patch->wrong.items[0], patch->memory);
    return status ? status : paradt__patch_flood_ghosts(patch);
}

// Lists the wrong cells and the ghosts of the first region, when all other regions have listed the seam.
static paradt_status paradt__patch_apply_seam(paradt__patch *patch) {
    paradt__seam seam;
    paradt_status status;
    PARADT_ASSERT(patch->own_points_only && patch->own == patch->fields && !patch->own->begin);
    status = paradt__seam_begin(&seam, patch);
    if (!status) status = paradt__patch_find_wrong(patch, &seam);
    if (!status) status = paradt__patch_list_ghosts(patch);
    paradt__seam_free(&seam, patch->memory);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>results of patches
//
// What a patch delivers: the cells that the region owns, with the caller's indices, and a list of their open facets,
// behind which other regions' cells are. Or, if regions are given up, the triangulation of the whole set.
//
// All that the region does not own is in the fringe, and of the first region in the list of wrong cells; the mesh is
// compacted by these lists. Points of later regions get -1 for an index meanwhile: a cell with such a vertex is not the
// region's. Doors: paradt__patch_compact, paradt__patch_emit, paradt__patch_take_all.

#define PARADT__LATER_REGION ((paradt_index)(sizeof(paradt_index) == 4 ? INT32_MIN : INT64_MIN)) // a bit of -1

// Makes patch->origin: the caller's indices, or -1 for positions from `end` on.
static paradt_status paradt__patch_translate(paradt__patch *patch, paradt_index end) {
    const paradt__field *own = patch->own;
    size_t count = own->set.count, i;
    patch->origin = patch->set->origin + own->begin;
    if (patch->build.count > own->capacity) {
        patch->origin_block =
            (paradt_index *)paradt__alloc(patch->memory, patch->build.count, sizeof *patch->origin_block);
        if (!patch->origin_block) return PARADT_ERROR_MEMORY;
        memcpy(patch->origin_block, patch->origin, count * sizeof *patch->origin_block);
        patch->origin = patch->origin_block;
    }
    for (i = count; i < patch->build.count; i++) {
        paradt_index position = patch->others[i - count];
        patch->origin[i] = position < end ? patch->set->origin[position] : -1;
    }
    return PARADT_OK;
}

// Does the region own the cell or ghost? corners: the mesh's
PARADT__INLINE int paradt__patch_owns(const paradt__patch *patch, const paradt_index *vertices, size_t corners) {
    return paradt__owns(vertices, corners, (paradt_index)patch->own->set.count, patch->origin, PARADT__LATER_REGION);
}

// Drops a ghost, or a cell that the region does not own. is_right: 0 where nothing says that it is one of T(P). The
// facet of a right ghost is on the hull of T(P); other facets become open.
PARADT__INLINE void paradt__patch_drop(paradt__patch *patch, size_t place, size_t corners, int is_right) {
    const paradt__mesh *mesh = &patch->build.scene.mesh;
    const paradt_index *vertices = mesh->vertices + place * corners;
    int is_ghost = !paradt__is_finite_cell(vertices, (int)corners);
    patch->cells_built += (size_t)!is_ghost;
    patch->hull_facets += (uint64_t)(is_ghost && is_right && paradt__patch_owns(patch, vertices, corners));
    paradt__mesh_drop(mesh, place, corners, is_ghost && is_right ? PARADT__HULL : PARADT__OPEN);
    patch->dropped++;
}

// Drops the wrong cells, and all ghosts and cells in the fringe that the region does not own. A cell or ghost with an
// own vertex is right.
PARADT__INLINE void paradt__patch_drop_others(paradt__patch *patch, size_t corners) {
    const paradt__mesh mesh = patch->build.scene.mesh; // a copy, which nothing that is written can change
    const paradt_index *fringe = patch->fringe.items, own = (paradt_index)patch->own->set.count;
    size_t count = patch->fringe.count, i;
    for (i = 0; i < patch->wrong.count; i++) paradt__patch_drop(patch, (size_t)patch->wrong.items[i], corners, 0);
    for (i = 0; i < count; i++) {
        const paradt_index *vertices = mesh.vertices + (size_t)fringe[i] * corners;
        paradt__mesh_fetch_listed(&mesh, fringe, count, i);
        if (vertices[0] == PARADT__DEAD) continue;
        if (!paradt__is_finite_cell(vertices, (int)corners) || !paradt__patch_owns(patch, vertices, corners))
            paradt__patch_drop(patch, (size_t)fringe[i], corners, paradt__vertices_below(vertices, corners, own) > 0);
    }
}

// Leaves only the cells that the region owns, at the first places.
static paradt_status paradt__patch_compact(paradt__patch *patch) {
    const paradt__field *own = patch->own;
    paradt__mesh *mesh = &patch->build.scene.mesh;
    paradt__list dropped[2];
    paradt_status status = paradt__patch_translate(patch, (paradt_index)(own->begin + own->set.count));
    if (status) return status;
    if (mesh->corners == 4) paradt__patch_drop_others(patch, 4);
    else paradt__patch_drop_others(patch, (size_t)mesh->corners);
    dropped[0] = patch->wrong;
    dropped[1] = patch->fringe;
    paradt__mesh_compact(mesh, patch->dropped, dropped, 2);
    paradt__list_free(&patch->wrong, patch->memory);
    paradt__list_free(&patch->fringe, patch->memory);
    patch->cells_built += mesh->count;
    PARADT__VERIFY(mesh, 0, 0);
    return PARADT_OK;
}

// Lists the open facets of a cell that has been emitted. first: number of the region's first cell in the result
static paradt_status paradt__patch_list_open(paradt__patch *patch, const paradt__rows *to, size_t cell, size_t first) {
    size_t corners = (size_t)patch->build.scene.mesh.corners, j;
    paradt_status status = PARADT_OK;
    for (j = 0; j < corners && !status; j++) {
        if (to->links[cell * corners + j] == PARADT__OPEN)
            status = paradt__list_append(&patch->open, (paradt_index)((first + cell) * corners + j), patch->memory);
    }
    return status;
}

// Writes the region's cells to `rows`, which may be where they are, or before it, with the caller's vertices, and lists
// their open facets.
PARADT__INLINE paradt_status paradt__patch_emit_cells(paradt__patch *patch, const paradt__rows *rows, size_t first,
                                                      const paradt__progress *progress, size_t corners) {
    const paradt__mesh mesh = patch->build.scene.mesh; // copies, which nothing that is written can change
    const paradt__rows to = *rows;
    const paradt_index *origin = patch->origin;
    size_t i;
    paradt_status status = PARADT_OK;
    for (i = 0; i < mesh.count; i++) {
        int bare;
        if (i % PARADT__PACE == PARADT__PACE - 1 && paradt__progress_cancels(progress, 1.0))
            return PARADT_ERROR_CANCELLED;
        bare = paradt__mesh_emit_row(&mesh, i, corners, origin, &to);
        paradt__fetch_row(to.vertices, to.links, i + PARADT__ROWS_AHEAD, corners);
        if (!PARADT__LIKELY(!bare) && !status) status = paradt__patch_list_open(patch, &to, i, first);
    }
    return status;
}

static paradt_status paradt__patch_emit(paradt__patch *patch, const paradt__rows *to, size_t first,
                                        const paradt__progress *progress) {
    if (patch->build.scene.mesh.corners == 4) return paradt__patch_emit_cells(patch, to, first, progress, 4);
    return paradt__patch_emit_cells(patch, to, first, progress, (size_t)patch->build.scene.mesh.corners);
}

// --- the whole set

// Adds all points that the patch has not got, behind those inserted, and makes their order.
static paradt_status paradt__patch_add_all(paradt__patch *patch) {
    const paradt__field *last = patch->fields + patch->field_count - 1, *field;
    size_t before = patch->build.count, end = last->begin + last->set.count, i;
    unsigned char *has = (unsigned char *)paradt__alloc(patch->memory, end, 1);
    paradt_index *order;
    paradt_status status = has ? PARADT_OK : PARADT_ERROR_MEMORY;
    if (!status && patch->capacity < patch->set->count) status = paradt__patch_reserve(patch, patch->set->count);
    if (!status) memset(has, 0, end);
    for (i = 0; i < before && !status; i++) has[paradt__patch_position(patch, (paradt_index)i)] = 1;
    for (field = patch->fields; field <= last; field++) {
        for (i = field->begin; i < field->begin + field->set.count && !status; i++) {
            if (!has[i]) status = paradt__patch_add(patch, i);
        }
    }
    paradt__release(patch->memory, has);
    if (status || patch->build.count == before) return status;
    paradt__release(patch->memory, patch->order);
    patch->order = (paradt_index *)paradt__alloc(patch->memory, patch->build.count, sizeof *patch->order);
    order = paradt__round_order(patch->build.count - before, patch->memory);
    if (!patch->order || !order) status = PARADT_ERROR_MEMORY;
    for (i = before; i < patch->build.count && !status; i++) patch->order[i] = order[i - before] + (paradt_index)before;
    paradt__release(patch->memory, order);
    return status;
}

// Makes the patch the triangulation of the whole set, closed, with the caller's indices. facets: links remain
// half-facets
static paradt_status paradt__patch_take_all(paradt__patch *patch, int facets, const paradt__progress *progress) {
    paradt__insertion *build = &patch->build;
    size_t before = build->count;
    paradt_status status = paradt__patch_add_all(patch);
    if (!status) status = paradt__insertion_more(build, patch->order, before, progress);
    if (status) return status;
    status = paradt__patch_translate(patch, PARADT__NOWHERE);
    if (!status) patch->hull_facets = paradt__mesh_close(&build->scene.mesh, patch->origin, facets, progress->meter);
    return status;
}
#endif // PARADT_NO_REGIONS

// ---------------------------------------------------------------------------------------------------------------------
// >>known points
//
// What a rank builds by insertion: the triangulation of all points that it knows, its own and other ranks'. It grows
// whenever more points become known; at the end only the cells that the rank owns are left. Vertices are positions in a
// set whose first points are the own ones. All cells that other ranks may own, or may destroy by points of theirs, are
// in the fringe (>>fringe). Compiled only where paradt_mpi.h is implemented. Doors: paradt__known_*,
// paradt__mark_vertices, paradt__remote_owns.

#ifdef PARADT_MPI_IMPLEMENTATION
#define PARADT__RANKS 1 // paradt_mpi.h checks that this has been compiled

typedef struct paradt__known {
    paradt__insertion build;
    paradt_index *order; // in which the first points are inserted
    paradt__list fringe; // see >>fringe
} paradt__known;

// The cells and ghosts, whose vertices are positions.
PARADT__INLINE const paradt__mesh *paradt__known_mesh(const paradt__known *known) {
    return &known->build.scene.mesh;
}

// The mesh with the records of its vertices.
PARADT__INLINE const paradt__scene *paradt__known_scene(const paradt__known *known) {
    return &known->build.scene;
}

// Number of points inserted: those at the first positions.
PARADT__INLINE size_t paradt__known_count(const paradt__known *known) {
    return known->build.count;
}

// Sets where the set's records are, after they have moved.
static void paradt__known_move_records(paradt__known *known, const double *records) {
    known->build.scene.records = records;
}

static void paradt__known_free(paradt__known *known, paradt__memory *memory) {
    known->build.memory = memory;
    paradt__insertion_end(&known->build);
    paradt__list_free(&known->fringe, memory);
    paradt__release(memory, known->order);
    memset(known, 0, sizeof *known);
}

// Inserts all points of the set. It was measured with all points that are to come and spans them; if it has sagittas,
// they have sagittas as well.
//   own        number of own points, at least 1. They are in the order of a curve
//   low, high  the own points' box, as ordered bits
static paradt_status paradt__known_begin(paradt__known *known, const paradt__set *set, size_t own, const int64_t *low,
                                         const int64_t *high, paradt__memory *memory,
                                         const paradt__progress *progress) {
    paradt__curve curve;
    memset(known, 0, sizeof *known);
    paradt__curve_begin(&curve, set->space.ambient, paradt__levels_for(own, set->space.ambient), low, high,
                        set->count / 8);
    known->order = paradt__merged_order(set, own, &curve, memory);
    if (!known->order) return PARADT_ERROR_MEMORY;
    paradt__insertion_begin(&known->build, set, known->order, memory);
    known->build.later = (set->count - own) / 6; // about as many of others' points are still missing
    return paradt__insertion_run(&known->build, progress);
}

// Marks a place as waiting in a queue. Returns 0 if it is marked.
PARADT__INLINE int paradt__known_wait(paradt__known *known, size_t place) {
    return paradt__mesh_mark(&known->build.scene.mesh, place, PARADT__WAITING);
}

PARADT__INLINE void paradt__known_wait_no_more(paradt__known *known, size_t place) {
    paradt__mesh_unmark(&known->build.scene.mesh, place, PARADT__WAITING);
}

// Empties the fringe's list, to make it anew.
static void paradt__known_relist(paradt__known *known) {
    paradt__fringe_forget(&known->fringe, &known->build.scene.mesh);
}

// Lists the first place of the fringe from *place on, and sets *place to it, or to the number of all places if there is
// none. own: number of own points
PARADT__INLINE paradt_status paradt__known_list(paradt__known *known, paradt_index own, size_t *place) {
    paradt__mesh *mesh = &known->build.scene.mesh;
    size_t corners = (size_t)mesh->corners;
    if (corners == 4) return paradt__fringe_add_next(&known->fringe, mesh, 4, own, place, known->build.memory);
    return paradt__fringe_add_next(&known->fringe, mesh, corners, own, place, known->build.memory);
}

// Lists the whole fringe.
static paradt_status paradt__known_list_all(paradt__known *known, paradt_index own) {
    return paradt__fringe_list(&known->fringe, &known->build.scene.mesh, own, known->build.memory);
}

// Inserts one more point of the set, whose records may have moved. All cells that this makes are listed as fringe,
// though not all of them have other ranks' points.
static paradt_status paradt__known_insert(paradt__known *known, const paradt__set *set, paradt_index position) {
    paradt__insertion *build = &known->build;
    size_t i;
    paradt_status status;
    build->scene.records = set->records;
    build->count++;
    status = paradt__insert_one_more(build, position, -1);
    for (i = 0; i < build->update.made_count && !status; i++) {
        paradt_index made = paradt__mesh_cell(&build->scene.mesh, build->update.made[i]);
        status = paradt__fringe_add(&known->fringe, &build->scene.mesh, made, build->memory);
    }
    return status;
}

// Ends the insertion: gives back all memory but that of the mesh and the fringe.
static void paradt__known_rest(paradt__known *known, paradt__memory *memory) {
    paradt__insertion_rest(&known->build);
    paradt__release(memory, known->order);
    known->build.order = known->order = NULL;
}

// What is known of a point when cells are dropped, as bits
enum {
    PARADT__NO_VERTEX = 0,
    PARADT__VERTEX = 1,          // it is a vertex of a cell
    PARADT__OF_OWN_CELL = 2,     // ... of an own cell
    PARADT__OF_NONE_DROPPED = 4, // no cell that is dropped has it: if it is a vertex, then of own cells alone
    PARADT__OF_LATER_RANK = 8    // a rank with a higher number has it
};

PARADT__INLINE void paradt__mark_vertices(paradt_index *mark, const paradt_index *vertices, size_t corners,
                                          paradt_index bits) {
    size_t j;
    for (j = 0; j < corners; j++) mark[vertices[j]] |= bits;
}

// Does the rank own the cell? mark: of all points, says which are a later rank's
PARADT__INLINE int paradt__remote_owns(const paradt_index *vertices, size_t corners, paradt_index own,
                                       const paradt_index *mark) {
    return paradt__owns(vertices, corners, own, mark, PARADT__OF_LATER_RANK);
}

// Takes the own cells off the fringe's list: ghosts and other ranks' cells are left, which are marked as dropped.
// Returns the number of other ranks' cells.
PARADT__INLINE uint64_t paradt__known_judge(paradt__known *known, paradt_index own, size_t corners,
                                            paradt_index *mark) {
    const paradt__mesh *cells = &known->build.scene.mesh;
    size_t count = known->fringe.count, i, j, left = 0;
    uint64_t others = 0;
    for (i = 0; i < count; i++) {
        paradt_index place = known->fringe.items[i];
        const paradt_index *vertices = cells->vertices + (size_t)place * corners;
        int is_cell = paradt__is_finite_cell(vertices, (int)corners);
        paradt__mesh_fetch_listed(cells, known->fringe.items, count, i);
        if (vertices[0] == PARADT__DEAD) continue;
        if (is_cell && paradt__remote_owns(vertices, corners, own, mark)) {
            paradt__mark_vertices(mark, vertices, corners, PARADT__VERTEX | PARADT__OF_OWN_CELL);
            continue;
        }
        if (known->build.scene.mesh.marks[place] & PARADT__DROPPED) continue; // it is in the list twice
        for (j = 0; j < corners && is_cell; j++)
            mark[vertices[j]] = (mark[vertices[j]] | PARADT__VERTEX) & ~PARADT__OF_NONE_DROPPED;
        others += (uint64_t)is_cell;
        known->build.scene.mesh.marks[place] |= PARADT__DROPPED;
        known->fringe.items[left++] = place;
    }
    known->fringe.count = left;
    return others;
}

// Has a dropped cell an own point that no own cell is known to have?
PARADT__INLINE int paradt__known_leaves(const paradt_index *vertices, size_t corners, paradt_index own,
                                        const paradt_index *mark) {
    int leaves = 0;
    size_t j;
    for (j = 0; j < corners; j++)
        leaves |= vertices[j] >= 0 && vertices[j] < own && mark[vertices[j]] == PARADT__VERTEX;
    return leaves;
}

// Drops the listed cells and ghosts; the facets of the cells beside them become open. An own point of a dropped cell
// may be a vertex of own cells too. The star of a vertex is connected through facets, so some cell of it that is
// dropped and some cell that is not have a facet in common: that is where such points are found and marked. Of the
// cells that are not dropped, those with other ranks' points have their vertices marked already, so only cells of own
// points alone matter.
PARADT__INLINE void paradt__known_drop(paradt__known *known, paradt_index own, size_t corners, paradt_index *mark) {
    paradt__mesh *cells = &known->build.scene.mesh;
    size_t i, j, count = known->fringe.count;
    for (i = 0; i < count; i++) {
        size_t base = (size_t)known->fringe.items[i] * corners;
        paradt__mesh_fetch_listed(cells, known->fringe.items, count, i);
        for (j = 0; j < corners; j++) {
            paradt_index link = cells->links[base + j];
            const paradt_index *across = cells->vertices + (size_t)link / corners * corners;
            if (PARADT__LIKELY(known->build.scene.mesh.marks[(size_t)link / corners] & PARADT__DROPPED)) continue;
            cells->links[link] = PARADT__OPEN;
            if (paradt__known_leaves(cells->vertices + base, corners, own, mark) &&
                paradt__vertices_among(across, (int)corners, 0, own))
                paradt__mark_vertices(mark, across, corners, PARADT__VERTEX | PARADT__OF_OWN_CELL);
        }
    }
    for (i = 0; i < count; i++) cells->vertices[(size_t)known->fringe.items[i] * corners] = PARADT__DEAD;
}

PARADT__INLINE uint64_t paradt__known_drop_others(paradt__known *known, paradt_index own, size_t corners,
                                                  paradt_index *mark) {
    uint64_t others = paradt__known_judge(known, own, corners, mark);
    paradt__known_drop(known, own, corners, mark);
    return others;
}

// Hands the own cells over in *cells, after paradt__known_rest and with the fringe listed. Facets without an own cell
// on the other side are open. Returns how many cells are dropped because other ranks own them.
//   set   of the own points
//   mark  [positions] filled with what is known of each point; of other ranks' points it says before whether a later
//         rank has them
static uint64_t paradt__known_end(paradt__known *known, const paradt__set *set, paradt__memory *memory,
                                  paradt__mesh *cells, paradt_index *mark) {
    paradt__insertion *build = &known->build;
    paradt_index own = (paradt_index)set->count;
    size_t corners = (size_t)build->scene.mesh.corners, i;
    uint64_t others;
    // without weights no point is hidden
    for (i = 0; i < set->count; i++)
        mark[i] = set->space.weighted ? PARADT__NO_VERTEX : PARADT__VERTEX | PARADT__OF_NONE_DROPPED;
    others = corners == 4 ? paradt__known_drop_others(known, own, 4, mark)
                          : paradt__known_drop_others(known, own, corners, mark);
    paradt__mesh_compact(&build->scene.mesh, known->fringe.count, &known->fringe, 1);
    for (i = 0; i < build->scene.mesh.count && set->space.weighted; i++)
        paradt__mark_vertices(mark, build->scene.mesh.vertices + i * corners, corners,
                              PARADT__VERTEX | PARADT__OF_OWN_CELL);
    paradt__mesh_rest(&build->scene.mesh, memory);
    paradt__list_free(&known->fringe, memory);
    *cells = build->scene.mesh;
    memset(known, 0, sizeof *known);
    return others;
}

#endif // PARADT_MPI_IMPLEMENTATION

// ---------------------------------------------------------------------------------------------------------------------
// >>call
//
// What one call works with, from the options to the mesh, and how its steps are run. A step is a task for each region;
// the program's parallel_for, or a loop, runs the tasks. Between two steps no task runs: then the regions' accounts of
// memory are joined, and what is left of the limit is shared among them anew.
// Doors: paradt__count_predicates, paradt__count_region, paradt__begin_way, paradt__whole_progress,
// paradt__region_progress, paradt__region_count, paradt__run_step, paradt__begin_regions, paradt__share_memory.

struct paradt__front;
struct paradt__work;

// One row a method: what it can do, and its functions
typedef struct paradt__method {
    unsigned can;                                        // PARADT__CAN_* bits
    int least_dim, most_dim;                             // of the points; 0 and 0: this build leaves the method out
    paradt_status (*front)(struct paradt__front *front); // builds a region, or all, facet by facet; NULL: it inserts
    paradt_status (*build)(struct paradt__work *work);   // builds work->mesh of work->set; NULL: AUTO, which chooses
} paradt__method;

enum {
    PARADT__CAN_WEIGHTS = 1, // regular triangulations
    PARADT__CAN_LINK = 2,    // neighbours
    PARADT__CAN_REGIONS = 4, // divided space
    PARADT__CAN_LIVE = 8     // more points after the first ones
};

#ifndef PARADT_NO_REGIONS
// What one region leaves behind
typedef struct paradt__region {
    paradt__memory memory;
    paradt_status status;
    paradt__mesh mesh;   // by a front, or
    paradt__patch patch; // by insertion:
    size_t offset;       // the number of its first cell in the result
    size_t slice;        // the first place of its slice
    uint64_t hull_facets;
    int built;         // all its cells are there, or it waits
    int waits;         // it waits until it can learn neighbours from other regions
    size_t runs;       // in a leg of the relay, the region that the task of this number runs,
    size_t ran;        // and the points that the task has inserted
    uint32_t reported; // of its share of the progress
    paradt_stats stats;
} paradt__region;
#endif // PARADT_NO_REGIONS

typedef struct paradt__work {
    paradt_options options;
    paradt__memory memory;
    paradt__meter meter;
    paradt_stats *stats;
    // the plan
    const paradt__method *method; // the one that is tried
    int impatient;                // the method may give up
    size_t regions;
    int one_by_one; // insertion builds one region after another, without neighbours
    int facets;     // links are delivered as half-facets
    // progress
    double share;      // of the call's work: what was left when the present way of building began
    uint32_t reported; // of the share, while one task does all of it
    // the points
    paradt__set set;
#ifndef PARADT_NO_FRONTS
    paradt__grid grid;
#endif                 // PARADT_NO_FRONTS
    paradt__cuts cuts; // between the regions
#ifndef PARADT_NO_REGIONS
    // the regions
    struct paradt__region *region;          // [regions]
    uint32_t *owner;                        // [set.count] with fronts: the region of each point
    paradt__field *fields;                  // [regions] with insertion
    paradt_index basis[PARADT_MAX_DIM + 1]; // with insertion: positions of points that span the set
    int hollow;                             // the points may be on a surface or a curve
    int first_alone;                        // with insertion: the first region has its own points alone
    paradt__relay relay;                    // with insertion
    paradt__mesh slices;                    // with insertion: a slice of the rows for each region, while they fit
    paradt__facets open_facets;             // with insertion: of regions, when they are put together
#endif                                      // PARADT_NO_REGIONS
    // the result
    paradt__mesh mesh;
    int delivered; // the mesh has the caller's indices and final links already
} paradt__work;

// --- counting

static void paradt__count_predicates(paradt_stats *stats, const paradt__counters *c) {
    stats->orient_calls += c->orient_calls;
    stats->insphere_calls += c->insphere_calls;
    stats->exact_small += c->exact_small;
    stats->exact_fixed += c->exact_fixed;
    stats->exact_general += c->exact_general;
    stats->perturbed += c->perturbed;
}

#ifndef PARADT_NO_REGIONS
// Adds the counters of a region.
static void paradt__count_region(paradt_stats *stats, const paradt_stats *region) {
    stats->distance_evaluations += region->distance_evaluations;
    stats->grid_cells_visited += region->grid_cells_visited;
    if (region->active_peak > stats->active_peak) stats->active_peak = region->active_peak;
    stats->orient_calls += region->orient_calls;
    stats->insphere_calls += region->insphere_calls;
    stats->exact_small += region->exact_small;
    stats->exact_fixed += region->exact_fixed;
    stats->exact_general += region->exact_general;
    stats->perturbed += region->perturbed;
    stats->cells_recomputed += region->cells_recomputed;
}
#endif // PARADT_NO_REGIONS

// --- progress

// Begins a way of building. Its share is what is left of the call's work, except for the last steps.
static void paradt__begin_way(paradt__work *work) {
    const double finish = 0.025; // the part for the steps after the cells are made
    work->share = (1.0 - paradt__meter_done(&work->meter)) * (1.0 - finish);
    work->reported = 0;
}

// The progress of a way that one task goes
static paradt__progress paradt__whole_progress(paradt__work *work) {
    return paradt__progress_of(&work->meter, &work->reported, work->share);
}

#ifndef PARADT_NO_REGIONS
// The progress of a region, which has an equal part of the share
static paradt__progress paradt__region_progress(paradt__work *work, size_t index) {
    double share = work->share / (double)work->regions;
    return paradt__progress_of_task(paradt__progress_of(&work->meter, &work->region[index].reported, share), index);
}

// --- steps

// Number of the points of a region
static size_t paradt__region_count(const paradt__work *work, size_t index) {
    return paradt__cuts_end(&work->cuts, index, work->set.count) - (index ? work->cuts.cut[index].begin : 0);
}

// Joins the regions' accounts to the call's, and shares what is left of the limit among them. No task runs meanwhile.
static void paradt__share_memory(paradt__work *work) {
    uint64_t peaks = work->memory.held;
    size_t i;
    for (i = 0; i < work->regions; i++) paradt__memory_join(&work->memory, &work->region[i].memory, &peaks);
    if (work->memory.peak < peaks) work->memory.peak = peaks;
    for (i = 0; i < work->regions; i++) work->region[i].memory = paradt__memory_fork(&work->memory, work->regions);
}

// Runs a task for each region. Returns the first region's status that is not PARADT_OK; an error,
// PARADT_ERROR_CANCELLED included, comes before PARADT__GAVE_UP.
static paradt_status paradt__run_tasks(paradt__work *work, void (*task)(void *context, size_t index)) {
    paradt_status status = PARADT_OK;
    size_t i;
    if (work->options.parallel_for) {
        work->options.parallel_for(work->options.user, work->regions, task, work);
    } else {
        for (i = 0; i < work->regions; i++) {
            task(work, i);
            if (!work->region[i].status && paradt__meter_cancels(&work->meter))
                work->region[i].status = PARADT_ERROR_CANCELLED;
            if (work->region[i].status) break;
        }
    }
    for (i = 0; i < work->regions; i++) {
        if (!status || (status == PARADT__GAVE_UP && work->region[i].status)) status = work->region[i].status;
    }
    return status;
}

// Runs a step, unless there has been an error before.
static paradt_status paradt__run_step(paradt__work *work, paradt_status status,
                                      void (*task)(void *context, size_t index)) {
    if (status) return status;
    paradt__share_memory(work);
    status = paradt__run_tasks(work, task);
    paradt__share_memory(work);
    return !status && paradt__meter_cancels(&work->meter) ? PARADT_ERROR_CANCELLED : status;
}

// Makes work->region, all zero but for the accounts of memory, and begins the result's mesh.
static paradt_status paradt__begin_regions(paradt__work *work) {
    size_t i;
    work->region = (paradt__region *)paradt__alloc(&work->memory, work->regions, sizeof *work->region);
    if (!work->region) return PARADT_ERROR_MEMORY;
    memset(work->region, 0, work->regions * sizeof *work->region);
    for (i = 0; i < work->regions; i++) work->region[i].memory = paradt__memory_fork(&work->memory, work->regions);
    paradt__mesh_begin(&work->mesh, work->set.space.dim + 1, 0);
    paradt__begin_way(work);
    return PARADT_OK;
}
#endif // PARADT_NO_REGIONS

#ifndef PARADT_NO_FRONTS
// ---------------------------------------------------------------------------------------------------------------------
// >>fronts
//
// InCoDe and DeWall from the set to the mesh, undivided or by regions (thesis, chapter 4): each region's front is a
// task, and keeps the cells that the region owns; these are appended to each other, and the facets between cells of
// different regions, left open, are tied. Doors: paradt__build_by_front, paradt__prepare_fronts, paradt__begin_fronts,
// paradt__front_task.

static void paradt__count_front(paradt_stats *stats, const paradt__front *front) {
    paradt__search_add_counts(&front->search, stats);
    if (front->active.peak > stats->active_peak) stats->active_peak = front->active.peak;
    paradt__count_predicates(stats, paradt__search_counters(&front->search));
}

// Runs a front that has begun, unless that failed, and ends it: leaves its mesh, adds what it counted.
static paradt_status paradt__run_front(paradt__front *front, paradt_status status, const paradt__method *method,
                                       paradt__mesh *mesh, paradt_stats *stats) {
    if (!status) status = method->front(front);
    paradt__count_front(stats, front);
    stats->hull_facets += front->hull_facets;
    paradt__front_end(front);
    *mesh = front->mesh;
    return status;
}

#ifndef PARADT_NO_REGIONS
// Leaves the cells that the region owns in region->mesh.
static void paradt__front_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__region_view view;
    paradt__progress progress = paradt__region_progress(work, index);
    paradt__front front;
    view.owner = work->owner;
    view.cuts = &work->cuts;
    view.region = (uint32_t)index;
    region->status =
        paradt__front_begin(&front, &work->set, &work->grid, &region->memory, view, 1.0 / (double)work->regions);
    front.progress = progress;
    front.impatient = work->impatient;
    region->status = paradt__run_front(&front, region->status, work->method, &region->mesh, &region->stats);
    if (!region->status)
        region->status = paradt__region_compact(&region->mesh, &work->set, &view, &progress, &region->memory,
                                                &region->stats.cells_recomputed);
}

// Appends the regions' cells to each other, and frees each region's mesh when its cells have been copied.
static paradt_status paradt__collect_fronts(paradt__work *work, paradt_status status) {
    size_t total = 0, i;
    for (i = 0; i < work->regions; i++) {
        total += work->region[i].mesh.count;
        paradt__count_region(work->stats, &work->region[i].stats);
    }
    if (!status) status = paradt__mesh_reserve(&work->mesh, total, total, &work->memory);
    for (i = 0; i < work->regions; i++) {
        if (!status && paradt__meter_cancels(&work->meter)) status = PARADT_ERROR_CANCELLED;
        if (!status) paradt__mesh_append(&work->mesh, &work->region[i].mesh);
        paradt__mesh_free(&work->region[i].mesh, &work->memory);
    }
    return status;
}
#endif // PARADT_NO_REGIONS

// Prepares the set for fronts: sagittas, and the grid.
static paradt_status paradt__prepare_fronts(paradt__work *work) {
    double begun = paradt__now();
    paradt_status status = paradt__set_grade(&work->set, PARADT__NEAR_SPHERE, &work->meter, &work->memory);
    if (!status) status = paradt__grid_build(&work->grid, &work->set, &work->meter, &work->memory);
    work->stats->seconds_grid += paradt__now() - begun;
    return status;
}

#ifndef PARADT_NO_REGIONS
// Begins the regions, and finds the region of each point.
static paradt_status paradt__begin_fronts(paradt__work *work) {
    paradt_status status = paradt__begin_regions(work);
    if (status) return status;
    work->owner = (uint32_t *)paradt__alloc(&work->memory, work->set.count, sizeof *work->owner);
    if (!work->owner) return PARADT_ERROR_MEMORY;
    paradt__regions_assign(&work->set, &work->cuts, work->owner);
    return PARADT_OK;
}
#endif // PARADT_NO_REGIONS

PARADT__COLD paradt_status paradt__build_by_front(paradt__work *work) {
    const paradt__region_view undivided = {NULL, NULL, 0};
    paradt__front front;
    paradt_status status = paradt__prepare_fronts(work);
#ifndef PARADT_NO_REGIONS
    if (!status && work->regions > 1) {
        status = paradt__begin_fronts(work);
        if (!status) status = paradt__collect_fronts(work, paradt__run_step(work, PARADT_OK, paradt__front_task));
        return status ? status
                      : paradt__regions_join(&work->mesh, &work->meter, &work->memory, &work->stats->hull_facets);
    }
#endif // PARADT_NO_REGIONS
    if (status) return status;
    paradt__begin_way(work);
    status = paradt__front_begin(&front, &work->set, &work->grid, &work->memory, undivided, 1.0);
    front.progress = paradt__whole_progress(work);
    front.impatient = work->impatient;
    return paradt__run_front(&front, status, work->method, &work->mesh, work->stats);
}
#endif // PARADT_NO_FRONTS

#ifndef PARADT_NO_REGIONS
// ---------------------------------------------------------------------------------------------------------------------
// >>regions of insertion
//
// Insertion by regions, step after step. A step is a task for each region, see >>call; what a region does in it is in
// the sections above:
//
//     grid       the grid of the region's points, by which others look for points of it
//     points     the points to begin with: its own, and others' in a margin
//     lend       rows for its cells: a slice of those of the result, where the number of cells can be foreseen
//     build      inserts them and asks about the cells that could be wrong; in legs, see "the relay"
//     publish    | regions that wait for what others know: each publishes its cells,
//     learn      | looks at what others have published,
//     complete   | and asks on, until none of them waits
//     compact    leaves only the cells that the region owns
//     emit       writes them into the result
//
// At the end the facets between cells of different regions are tied. A region gives up if its questions take longer
// than the insertion of all other points would; then the largest region that gave up inserts all points.
// Doors: paradt__build_by_patches, paradt__close_set.

// --- the steps

// Of two regions of which the first is built alone, only the second looks for points of the other.
static void paradt__grid_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__field *field = work->fields + index;
    int is_asked = !work->first_alone || work->regions > 2 || index == 0;
    region->status = PARADT_OK;
    if (is_asked && field->set.count) region->status = paradt__grid_lay(&field->grid, &field->set, &region->memory);
}

// Begins the patch of a region with its points.
PARADT__COLD void paradt__begin_patch(paradt__work *work, size_t index, paradt__memory *memory) {
    paradt__region *region = work->region + index;
    paradt__patch *patch = &region->patch;
    paradt__patch_begin(patch, &work->set, work->fields, work->regions, index, work->first_alone, memory);
    region->status = paradt__patch_points(patch, work->basis);
}

static void paradt__points_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__begin_patch(work, index, &work->region[index].memory);
}

// Returns the number of places of a region's slice: somewhat more than uniform points need, since cells that do not fit
// are copied, which costs more than closing the gap behind those that do. The last slice gets more, as no cells have to
// be moved behind it. Surfaces may have a tenth more cells a point, solids hardly any. Where there are many
// points of others there is less to add, as their cells go in the end.
static size_t paradt__slice_places(const paradt__work *work, size_t index) {
    const paradt__patch *patch = &work->region[index].patch;
    size_t count = patch->build.count, own = patch->fields[index].set.count;
    if (count - own <= own / 8) count += count / (index + 1 == work->regions ? 6 : work->hollow ? 9 : 32);
    else count += count / 32;
    return paradt__expected_places(count, work->set.space.dim);
}

// Reserves the slices: in two and three dimensions.
static paradt_status paradt__reserve_slices(paradt__work *work) {
    paradt__mesh *slices = &work->slices;
    int dim = work->set.space.dim;
    size_t total = 0, i;
    paradt_status status;
    paradt__mesh_begin(slices, dim + 1, 0);
    if (dim < 2 || dim > 3) return PARADT_OK;
    for (i = 0; i < work->regions; i++) {
        work->region[i].slice = total;
        total += paradt__slice_places(work, i);
    }
    status = paradt__mesh_reserve(slices, total, total, &work->memory);
    if (status) paradt__mesh_free(slices, &work->memory);
    return status == PARADT_ERROR_TOO_LARGE ? PARADT_OK : status; // there may be fewer cells in the end
}

// A patch whose cells do not fit into the slice takes rows of its own.
static void paradt__lend_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    size_t first = region->slice * (size_t)work->slices.corners;
    if (!work->slices.capacity) return;
    region->status = paradt__mesh_lend(&region->patch.build.scene.mesh, work->slices.vertices + first,
                                       work->slices.links + first, paradt__slice_places(work, index), &region->memory);
}

static void paradt__count_patch(paradt__region *region) {
    const paradt__patch *patch = &region->patch;
    memset(&region->stats, 0, sizeof region->stats);
    paradt__count_predicates(&region->stats, &patch->build.scene.space.counters);
    paradt__count_predicates(&region->stats, paradt__search_counters(&patch->search));
    paradt__search_add_counts(&patch->search, &region->stats);
}

// Ends the questions of a region: all cells of T(P) with a vertex of it are there.
static void paradt__end_questions(paradt__work *work, size_t index) {
    paradt__region *region = work->region + index;
    region->waits = 0;
    region->status = paradt__patch_list_seam(&region->patch, work->fields + index);
}

// Builds the cells of a region, unless it pauses. Regions can learn neighbours in up to three dimensions, where a
// vertex has few, and without weights, since a hidden point has none.
PARADT__COLD void paradt__build_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__patch *patch = &region->patch;
    int can_learn = !work->one_by_one && work->set.space.dim <= 3 && !work->set.space.weighted;
    paradt__progress progress = paradt__region_progress(work, index);
    region->status = patch->is_asking ? PARADT_OK : paradt__patch_build(patch, &progress);
    if (!region->status && patch->is_asking) region->status = paradt__patch_complete(patch, can_learn, &progress);
    if (!region->status && paradt__patch_pauses(patch, can_learn)) return;
    region->built = 1;
    region->waits = !region->status && patch->waiting.count;
    paradt__count_patch(region);
    if (region->status || region->waits || patch->own_points_only) return;
    paradt__end_questions(work, index);
    paradt__patch_rest(patch);
}

static void paradt__publish_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    region->status = paradt__patch_publish(&region->patch);
    work->fields[index].published = &region->patch;
}

// No region changes while others look at it.
static void paradt__learn_task(void *context, size_t index) {
    paradt__region *region = ((paradt__work *)context)->region + index;
    if (region->waits) region->status = paradt__patch_learn_all(&region->patch);
}

static void paradt__complete_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__progress progress = paradt__region_progress(work, index);
    if (!region->waits) return;
    region->status = paradt__patch_complete(&region->patch, 0, &progress);
    paradt__count_patch(region);
    if (!region->status && !region->patch.deferred.count) paradt__end_questions(work, index);
}

static void paradt__compact_task(void *context, size_t index) {
    paradt__region *region = ((paradt__work *)context)->region + index;
    paradt__patch *patch = &region->patch;
    region->status = patch->own_points_only ? paradt__patch_apply_seam(patch) : PARADT_OK;
    paradt__count_patch(region);
    if (!region->status) region->status = paradt__patch_compact(patch);
    region->stats.cells_recomputed = patch->cells_built - patch->build.scene.mesh.count;
    region->hull_facets = patch->hull_facets;
    paradt__patch_rest(patch);
}

// Are the emitted cells of a region written to the start of its slice, to be moved to their place in the result later?
// The second region's are written to their place directly: no other task uses the gap before its slice.
static int paradt__stays_in_slice(const paradt__work *work, size_t index) {
    return index > 1 && work->mesh.vertices == work->slices.vertices;
}

// Ties a region's open facets whose mirrors have been seen, and enters the others into the table.
static paradt_status paradt__join_patch(paradt__work *work, size_t index, paradt__memory *memory) {
    const paradt__patch *patch = &work->region[index].patch;
    paradt_status status = PARADT_OK;
    size_t i, j, end;
    for (i = 0; i < patch->open.count && !status; i = end) {
        end = patch->open.count - i < PARADT__JOINED ? patch->open.count : i + PARADT__JOINED;
        for (j = end; j < patch->open.count && j < end + PARADT__JOINED; j++) {
            PARADT__PREFETCH(work->mesh.vertices + patch->open.items[j]);
            PARADT__PREFETCH(work->mesh.links + patch->open.items[j]);
        }
        status =
            paradt__facets_join(&work->open_facets, &work->mesh, patch->open.items + i, end - i, !work->facets, memory);
    }
    return status;
}

// Frees the coordinates, which no later step takes.
static void paradt__release_records(paradt__work *work, paradt__memory *memory) {
    paradt__release(memory, work->set.records);
    work->set.records = NULL;
}

// Writes the cells into the result, or to the start of the region's slice. The first region's cells are at their final
// places then, so its open facets are entered into the table.
static void paradt__emit_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    const paradt__mesh *own = &region->patch.build.scene.mesh;
    paradt__progress progress = paradt__region_progress(work, index);
    size_t first = region->offset * (size_t)work->mesh.corners;
    int stays = paradt__stays_in_slice(work, index);
    paradt__rows to =
        paradt__mesh_rows(work->mesh.corners, work->facets, stays ? own->vertices : work->mesh.vertices + first,
                          stays ? own->links : work->mesh.links + first, region->offset);
    if (!index) paradt__release_records(work, &region->memory); // before others' cells need new pages
    region->status = paradt__patch_emit(&region->patch, &to, region->offset, &progress);
    if (index || region->status) return;
    region->status = paradt__facets_begin(&work->open_facets, region->patch.open.count, 0, &region->memory);
    if (!region->status) region->status = paradt__join_patch(work, 0, &region->memory);
}

// --- the relay
//
// The build step takes most of the time, and threads are not equally fast: processors differ, and others use them, too.
// So the step is done in legs. A leg ends for all regions when together they have done a part of what was left. In the
// next leg the task that did most gets the region that has most left, since the task is likely to be on the same thread
// again. What a region builds does not depend on where it pauses.

typedef struct paradt__ranked {
    size_t amount, number;
} paradt__ranked;

// Sorts by amount, the largest first.
static void paradt__rank(paradt__ranked *list, size_t count) {
    size_t i, j;
    for (i = 1; i < count; i++) {
        paradt__ranked one = list[i];
        for (j = i; j > 0 && list[j - 1].amount < one.amount; j--) list[j] = list[j - 1];
        list[j] = one;
    }
}

static void paradt__leg_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *task = work->region + index, *region = work->region + task->runs;
    size_t before = paradt__patch_done(&region->patch);
    if (!region->built) paradt__build_task(work, task->runs);
    task->ran = paradt__patch_done(&region->patch) - before;
}

// Decides which task runs which region in the next leg. Returns how much is left to be done in all.
static size_t paradt__assign_leg(paradt__work *work, paradt__ranked *regions, paradt__ranked *tasks) {
    size_t left = 0, i;
    for (i = 0; i < work->regions; i++) {
        regions[i].number = tasks[i].number = i;
        tasks[i].amount = work->region[i].ran;
        regions[i].amount = work->region[i].built ? 0 : paradt__patch_left(&work->region[i].patch);
        left += regions[i].amount;
    }
    paradt__rank(regions, work->regions);
    paradt__rank(tasks, work->regions);
    for (i = 0; i < work->regions; i++) work->region[tasks[i].number].runs = regions[i].number;
    return left;
}

// Runs the build step. No leg is so short that the time to begin it matters. With many regions there is one leg:
// threads even out their work by taking region after region.
static paradt_status paradt__run_relay(paradt__work *work) {
    enum { MOST = 64, PART = 4, FEWEST = 1 << 14 /* cells a region */ };
    paradt__ranked regions[MOST], tasks[MOST];
    double fewest = (double)(work->regions * FEWEST) / paradt__cells_a_point(work->set.space.dim);
    paradt_status status;
    int last;
    if (!work->options.parallel_for || work->regions > MOST)
        return paradt__run_step(work, PARADT_OK, paradt__build_task);
    do {
        size_t left = paradt__assign_leg(work, regions, tasks), i;
        last = (double)left < fewest;
        work->relay.stop = work->relay.done + (ptrdiff_t)(left / PART);
        for (i = 0; i < work->regions; i++) work->region[i].patch.build.relay = last ? NULL : &work->relay;
        status = paradt__run_step(work, PARADT_OK, paradt__leg_task);
    } while (!last && (!status || status == PARADT__GAVE_UP));
    return status;
}

// --- all regions together

// Moves the emitted cells from the slices' starts to their places.
static void paradt__close_slices(paradt__work *work) {
    size_t corners = (size_t)work->mesh.corners, i;
    for (i = 0; i < work->regions; i++) {
        const paradt__mesh *own = &work->region[i].patch.build.scene.mesh;
        size_t first = work->region[i].offset * corners, bytes = own->count * corners * sizeof(paradt_index);
        if (!bytes || !paradt__stays_in_slice(work, i)) continue;
        memmove(work->mesh.vertices + first, own->vertices, bytes);
        memmove(work->mesh.links + first, own->links, bytes);
    }
}

// Ties the open facets that the regions have listed; those of the first region are in the table. A facet without a
// mirror is on the hull.
static paradt_status paradt__join_patches(paradt__work *work) {
    size_t i, j;
    paradt_status status = PARADT_OK;
    for (i = 1; i < work->regions && !status; i++) status = paradt__join_patch(work, i, &work->memory);
    for (i = 0; i < work->regions && !status && work->open_facets.count; i++) {
        const paradt__patch *patch = &work->region[i].patch;
        for (j = 0; j < patch->open.count; j++) {
            paradt_index *link = work->mesh.links + patch->open.items[j];
            if (*link == PARADT__OPEN) *link = PARADT__HULL;
        }
    }
    return status;
}

// Puts the cells of the regions together. The slices become the result, unless a region has left its slice, or more
// than a third of them would be unused: to copy the cells takes as much memory again.
static paradt_status paradt__collect_patches(paradt__work *work) {
    size_t total = 0, i;
    int in_place = work->slices.vertices != NULL, lent = 0;
    paradt_status status = PARADT_OK;
    for (i = 0; i < work->regions; i++) {
        const paradt__mesh *own = &work->region[i].patch.build.scene.mesh;
        work->region[i].offset = total;
        total += own->count;
        in_place = in_place && own->lent;
        lent = lent || own->lent;
    }
    if (!lent) paradt__mesh_free(&work->slices, &work->memory);
    in_place = in_place && work->slices.capacity <= total + total / 2 + 64;
    if (in_place) {
        work->mesh = work->slices;
    } else {
        paradt__release_records(work, &work->memory);
        status = paradt__mesh_reserve(&work->mesh, total, total, &work->memory);
    }
    work->mesh.count = total;
    status = paradt__run_step(work, status, paradt__emit_task);
    if (!status && in_place) paradt__close_slices(work);
    if (in_place) memset(&work->slices, 0, sizeof work->slices);
    return status ? status : paradt__join_patches(work);
}

static size_t paradt__count_waiting(const paradt__work *work) {
    size_t waiting = 0, i;
    for (i = 0; i < work->regions; i++) waiting += (size_t)work->region[i].waits;
    return waiting;
}

static paradt_status paradt__build_together(paradt__work *work) {
    paradt_status status = paradt__run_step(work, PARADT_OK, paradt__points_task);
    if (!status) status = paradt__reserve_slices(work);
    status = paradt__run_step(work, status, paradt__lend_task);
    if (!status) status = paradt__run_relay(work);
    if (!status && paradt__count_waiting(work)) status = paradt__run_step(work, status, paradt__publish_task);
    while (!status && paradt__count_waiting(work)) {
        status = paradt__run_step(work, status, paradt__learn_task);
        status = paradt__run_step(work, status, paradt__complete_task);
    }
    status = paradt__run_step(work, status, paradt__compact_task);
    return status ? status : paradt__collect_patches(work);
}

// --- one by one: without neighbours, a region's links are given back before the next one begins

// Makes room in the result for the vertices of `count` more cells. If it grows, it also gets room for `expected` cells
// after these.
static paradt_status paradt__next_room(paradt__work *work, size_t count, size_t expected) {
    paradt__mesh *mesh = &work->mesh;
    size_t corners = (size_t)mesh->corners;
    void *vertices = mesh->vertices;
    if (mesh->count + count <= mesh->capacity) return PARADT_OK;
    count += mesh->count + expected;
    if (!paradt__grow(&work->memory, &vertices, mesh->count * corners, count * corners, sizeof(paradt_index)))
        return PARADT_ERROR_MEMORY;
    mesh->vertices = (paradt_index *)vertices;
    mesh->capacity = count;
    return PARADT_OK;
}

// Builds a region, at the end of the result while its cells fit there.
static paradt_status paradt__build_next(paradt__work *work, size_t index) {
    paradt__region *region = work->region + index;
    paradt__mesh *mesh = &work->mesh, *own = &region->patch.build.scene.mesh, *lent = &work->slices;
    size_t corners = (size_t)mesh->corners, capacity, rest;
    paradt__progress progress = paradt__region_progress(work, index);
    paradt__rows to;
    paradt__begin_patch(work, index, &work->memory);
    if (region->status) return region->status;
    capacity = paradt__expected_places(region->patch.build.count, work->set.space.dim);
    if (capacity > paradt__most_cells(mesh->corners)) capacity = paradt__most_cells(mesh->corners);
    rest = paradt__expected_places(index ? work->cuts.cut[index].begin : 0, work->set.space.dim);
    region->status = paradt__next_room(work, capacity, rest);
    if (region->status) return region->status;
    lent->links = (paradt_index *)paradt__alloc(&work->memory, capacity * corners, sizeof(paradt_index));
    if (!lent->links) return PARADT_ERROR_MEMORY;
    region->status =
        paradt__mesh_lend(own, mesh->vertices + mesh->count * corners, lent->links, capacity, &work->memory);
    if (!region->status) paradt__build_task(work, index);
    if (!region->status) paradt__compact_task(work, index);
    if (!region->status && !own->lent) region->status = paradt__next_room(work, own->count, rest);
    to = paradt__mesh_rows(mesh->corners, work->facets, mesh->vertices + mesh->count * corners, own->links, 0);
    if (!region->status) region->status = paradt__patch_emit(&region->patch, &to, 0, &progress);
    if (region->status) return region->status;
    mesh->count += own->count;
    paradt__patch_end(&region->patch);
    memset(&region->patch, 0, sizeof region->patch);
    paradt__mesh_free(lent, &work->memory);
    return PARADT_OK;
}

static paradt_status paradt__build_one_by_one(paradt__work *work) {
    paradt__mesh *mesh = &work->mesh;
    size_t i;
    paradt_status status = PARADT_OK;
    // the first region is the last to be built: which of its cells are right follows from what the others list
    for (i = work->regions; i-- > 0 && !status;) status = paradt__build_next(work, i);
    if (!status && mesh->capacity > mesh->count + mesh->count / 4 + 64) {
        void *vertices = mesh->vertices;
        size_t used = mesh->count * (size_t)mesh->corners;
        if (!paradt__grow(&work->memory, &vertices, used, used, sizeof(paradt_index))) return PARADT_ERROR_MEMORY;
        mesh->vertices = (paradt_index *)vertices;
        mesh->capacity = mesh->count;
    }
    return status;
}

// --- given up

// Has the largest of the regions that gave up insert all points that it has not got: its triangulation becomes the
// result. The others' are freed.
static paradt_status paradt__take_over(paradt__work *work) {
    paradt__progress progress;
    paradt__region *largest = NULL, *region, *end = work->region + work->regions;
    paradt__mesh *own;
    paradt_status status;
    paradt__begin_way(work);
    progress = paradt__whole_progress(work);
    for (region = work->region; region < end; region++) {
        paradt__patch_use_memory(&region->patch, &work->memory);
        if (region->status == PARADT__GAVE_UP && (!largest || region->patch.build.count > largest->patch.build.count))
            largest = region;
    }
    for (region = work->region; region < end; region++) {
        region->stats.cells_recomputed = region->hull_facets = 0;
        if (region == largest) continue;
        paradt__patch_end(&region->patch);
        memset(&region->patch, 0, sizeof region->patch);
    }
    own = &largest->patch.build.scene.mesh;
    if (!own->lent) paradt__mesh_free(&work->slices, &work->memory);
    status = paradt__patch_take_all(&largest->patch, work->facets, &progress);
    paradt__count_patch(largest);
    largest->hull_facets = largest->patch.hull_facets;
    if (!status && own->lent) {
        status = paradt__mesh_reserve(&work->mesh, own->count, own->count, &work->memory);
        if (!status) paradt__mesh_append(&work->mesh, own);
    } else if (!status) {
        work->mesh = *own;
        memset(own, 0, sizeof *own);
    }
    return status;
}

// --- the points of the regions

// Decides where the fields are in the set. with_gaps: each field but the first ends with a gap for the points of others
// that the region is likely to need. Returns the number of positions.
static size_t paradt__place_fields(paradt__work *work, int with_gaps) {
    size_t total = 0, i;
    for (i = 0; i < work->regions; i++) {
        size_t count = paradt__region_count(work, i);
        work->fields[i].begin = total;
        work->fields[i].capacity = with_gaps && i > 0 ? count + count / 8 + 64 : count;
        total += work->fields[i].capacity;
    }
    return total;
}

static void paradt__move_points(paradt__work *work, size_t index, size_t from, size_t to) {
    paradt__set *set = &work->set;
    size_t count = paradt__region_count(work, index);
    if (from == to) return;
    memmove(set->records + to * set->width, set->records + from * set->width, count * set->width * sizeof(double));
    memmove(set->origin + to, set->origin + from, count * sizeof *set->origin);
}

// Finds points that span the set, as positions in it after paradt__open_set.
static void paradt__find_basis(paradt__work *work) {
    paradt__set *set = &work->set;
    int i, count = paradt__set_basis(set, NULL, 0, work->basis, NULL, &set->space.counters, NULL);
    for (i = 0; i < count; i++) {
        size_t position = (size_t)work->basis[i], region = 0;
        while (position >= paradt__cuts_end(&work->cuts, region, set->count)) region++;
        if (region) position += work->fields[region].begin - work->cuts.cut[region].begin;
        work->basis[i] = (paradt_index)position;
    }
}

// Makes gaps between the regions' points, for copies of others' points. The first region is built alone if its points
// span the space.
static void paradt__open_set(paradt__work *work) {
    size_t i;
    if (paradt__place_fields(work, 1) > (size_t)PARADT__NOWHERE) paradt__place_fields(work, 0);
    paradt__find_basis(work);
    for (i = work->regions; i-- > 1;) paradt__move_points(work, i, work->cuts.cut[i].begin, work->fields[i].begin);
    for (i = 0; i < work->regions; i++) {
        paradt__field *field = work->fields + i;
        paradt__field_begin(field, &work->set, paradt__region_count(work, i));
        paradt__cuts_box(&work->cuts, i, field->low, field->high);
    }
    work->first_alone = work->regions > 1 && paradt__spans(&work->fields[0].set);
}

// Closes the gaps again.
static void paradt__close_set(paradt__work *work) {
    size_t i;
    for (i = 1; i < work->regions; i++) paradt__move_points(work, i, work->fields[i].begin, work->cuts.cut[i].begin);
}

static paradt_status paradt__build_by_patches(paradt__work *work) {
    int taken;
    paradt_status status = paradt__begin_regions(work);
    size_t i;
    if (status) return status;
    work->fields = (paradt__field *)paradt__alloc(&work->memory, work->regions, sizeof *work->fields);
    if (!work->fields) return PARADT_ERROR_MEMORY;
    memset(work->fields, 0, work->regions * sizeof *work->fields);
    paradt__open_set(work);
    status = paradt__run_step(work, PARADT_OK, paradt__grid_task);
    if (!status) status = work->one_by_one ? paradt__build_one_by_one(work) : paradt__build_together(work);
    taken = status == PARADT__GAVE_UP && !work->one_by_one;
    if (taken) status = paradt__take_over(work);
    work->delivered = !status;
    for (i = 0; i < work->regions; i++) {
        paradt__region *region = work->region + i;
        paradt__count_region(work->stats, &region->stats);
        work->stats->hull_facets += region->hull_facets;
        paradt__patch_use_memory(&region->patch, &work->memory);
        paradt__patch_end(&region->patch);
        paradt__grid_free(&work->fields[i].grid, &work->memory);
        paradt__mesh_free(&work->fields[i].seam, &work->memory);
    }
    paradt__mesh_free(&work->slices, &work->memory);
    paradt__facets_free(&work->open_facets, &work->memory);
    if (taken) work->regions = 1;
    return status;
}
#endif // PARADT_NO_REGIONS

// ---------------------------------------------------------------------------------------------------------------------
// >>methods
//
// One row a method, and the choice between them. A new method is a row here and a name in PARADT_METHOD_LIST.
// Doors: paradt__method_of, paradt__choose_method, paradt__plan, paradt__build_mesh, paradt__build_trivial,
// paradt__release_helpers.

#ifndef PARADT_NO_REGIONS
// --- do regions pay?
//
// On some surfaces and curves many points have neighbours far away. Nearly everything is wrong then that a region
// builds of its own points, and the region gives up after some time. A sample shows this in advance. Points that are
// spread in all dimensions need no sample: few of them have neighbours beyond a cut.

enum { PARADT__SAMPLED = 2048 }; // points of the sample

// Are points spread in fewer dimensions than they have? One in 64 is four times as far from its neighbours in three
// dimensions, and eight times on a surface; in two dimensions eight times, and 64 times on a curve.
static int paradt__is_hollow(const paradt__set *set) {
    enum { EVERY = 64 };
    int dim = set->space.dim;
    double all = paradt__spacing(set->records, set->width, dim, NULL, set->count);
    double some = paradt__spacing(set->records, set->width * EVERY, dim, NULL, set->count / EVERY);
    return dim >= 2 && dim <= 3 && some > (dim == 3 ? 5.6 : 11.2) * all;
}

// Number of the sample's points that have a neighbour on the other side of the first cut. side: [SAMPLED]
static size_t paradt__count_across(const paradt__mesh *mesh, unsigned char *side) {
    enum { UPPER = 1, ACROSS = 2 };
    size_t corners = (size_t)mesh->corners, i, j, count = 0;
    for (i = 0; i < mesh->count; i++) {
        const paradt_index *cell = mesh->vertices + i * corners;
        size_t upper = 0;
        for (j = 0; j < corners; j++) upper += side[cell[j]] & UPPER;
        for (j = 0; j < corners && upper % corners; j++) side[cell[j]] |= ACROSS;
    }
    for (i = 0; i < PARADT__SAMPLED; i++) count += side[i] >= ACROSS;
    return count;
}

// Would the regions give up? Of a sample's points 0.1 to 0.33 have such neighbours where regions pay (scans, a sphere,
// a Gaussian, Plummer's cluster), 0.42 on a torus and nearly all on a cylinder or a helix, where they don't.
PARADT__COLD paradt_status paradt__foresee(paradt__work *work, int *in_vain) {
    const paradt__set *set = &work->set;
    paradt__set sample = *set;
    paradt__mesh mesh;
    paradt__counters counters;
    paradt__progress silent;
    size_t i;
    unsigned char side[PARADT__SAMPLED];
    paradt_status status = PARADT_OK;
    *in_vain = 0;
    if (set->count < 4 * PARADT__SAMPLED || set->space.weighted) return PARADT_OK;
    memset(&mesh, 0, sizeof mesh);
    memset(&silent, 0, sizeof silent);
    sample.count = PARADT__SAMPLED;
    sample.origin = NULL;
    sample.records = (double *)paradt__alloc(&work->memory, sample.count, set->width * sizeof(double));
    if (!sample.records) return PARADT_ERROR_MEMORY;
    for (i = 0; i < sample.count; i++) {
        size_t at = (size_t)((double)set->count / (double)sample.count * (double)i);
        paradt__copy_record(sample.records + i * set->width, paradt__record(set, (paradt_index)at), set->width);
        side[i] = at < work->cuts.cut[work->regions / 2].begin;
    }
    if (paradt__spans(&sample)) status = paradt__bowyer_watson(&sample, &work->memory, &mesh, &silent, &counters);
    if (!status && mesh.count) {
        paradt__mesh_close(&mesh, NULL, 0, NULL);
        *in_vain = paradt__count_across(&mesh, side) > PARADT__SAMPLED / 8 * 3;
    }
    paradt__mesh_free(&mesh, &work->memory);
    paradt__set_free(&sample, &work->memory);
    return status;
}
#endif // PARADT_NO_REGIONS

// --- what a row's function does

// Frees what building cells has taken, except for the set and the mesh.
static void paradt__release_helpers(paradt__work *work) {
#ifndef PARADT_NO_FRONTS
    paradt__grid_free(&work->grid, &work->memory);
    memset(&work->grid, 0, sizeof work->grid);
#endif
#ifndef PARADT_NO_REGIONS
    paradt__release(&work->memory, work->owner);
    paradt__release(&work->memory, work->fields);
    paradt__release(&work->memory, work->region);
    work->owner = NULL;
    work->fields = NULL;
    work->region = NULL;
#endif
    (void)work;
}

// Frees what a way of building has made that gave up.
PARADT__OPTIONAL void paradt__begin_again(paradt__work *work) {
    paradt__release_helpers(work);
    paradt__mesh_free(&work->mesh, &work->memory);
    work->stats->cells_recomputed = work->stats->hull_facets = 0;
}

static paradt_status paradt__insert_undivided(paradt__work *work) {
    paradt__progress progress;
    paradt__counters counters;
    paradt_status status;
    paradt__begin_way(work);
    progress = paradt__whole_progress(work);
    memset(&counters, 0, sizeof counters);
    status = paradt__bowyer_watson(&work->set, &work->memory, &work->mesh, &progress, &counters);
    paradt__count_predicates(work->stats, &counters);
    return status;
}

#ifndef PARADT_NO_FLIPS
static paradt_status paradt__build_by_flips(paradt__work *work) {
    paradt__progress progress;
    paradt__counters counters;
    paradt_status status;
    paradt__begin_way(work);
    progress = paradt__whole_progress(work);
    memset(&counters, 0, sizeof counters);
    status = paradt__insert_by_flips(&work->set, &work->memory, &work->mesh, &progress, &counters, work->stats);
    paradt__count_predicates(work->stats, &counters);
    return status;
}
#endif

// Builds by insertion, in regions if these pay. If regions built one by one give up, the set keeps their order.
PARADT__COLD paradt_status paradt__build_by_insertion(paradt__work *work) {
    enum { WORTHWHILE = 512 }; // points: with fewer, a sphere is not looked for
    paradt_status status = PARADT_OK;
#ifndef PARADT_NO_REGIONS
    int in_vain = 0;
    work->hollow = work->regions > 1 && paradt__is_hollow(&work->set);
    if (work->hollow) status = paradt__foresee(work, &in_vain);
    if (in_vain) work->regions = 1;
    if (!status && work->regions > 1) { // sagittas are for the questions as well
        status = paradt__set_grade(&work->set, PARADT__NEAR_SPHERE, &work->meter, &work->memory);
        if (!status) status = paradt__build_by_patches(work);
        if (status != PARADT__GAVE_UP) return status;
        paradt__close_set(work);
        paradt__begin_again(work);
        work->regions = 1;
        return paradt__insert_undivided(work);
    }
#endif
    if (!status && work->set.space.dim == 3 && work->set.count >= WORTHWHILE)
        status = paradt__set_grade(&work->set, PARADT__GRADE_PAYS, &work->meter, &work->memory);
    return status ? status : paradt__insert_undivided(work);
}

// --- the table and the choice

enum {
#ifdef PARADT_NO_REGIONS
    PARADT__CAN_DIVIDE = 0,
#else
    PARADT__CAN_DIVIDE = PARADT__CAN_REGIONS,
#endif
    PARADT__CAN_ALL = (int)PARADT__CAN_WEIGHTS | (int)PARADT__CAN_LINK | (int)PARADT__CAN_DIVIDE,
    PARADT__AUTO_INCODE_DIM = 4 // AUTO tries InCoDe from here on
};

// The row of a method. AUTO's row says what all the methods can do that it chooses from.
static const paradt__method *paradt__method_of(paradt_method method) {
    static const paradt__method rows[PARADT_METHOD_COUNT] = {
        {PARADT__CAN_ALL, 2, PARADT_MAX_DIM, NULL, NULL}, // AUTO
#ifdef PARADT_NO_FRONTS
        {0, 0, 0, NULL, NULL}, // INCODE
        {0, 0, 0, NULL, NULL}, // DEWALL
#else
        {PARADT__CAN_ALL, 2, PARADT_MAX_DIM, paradt__incode, paradt__build_by_front},                        // INCODE
        {PARADT__CAN_ALL, 2, PARADT_MAX_DIM, paradt__dewall, paradt__build_by_front},                        // DEWALL
#endif
        {(int)PARADT__CAN_ALL | (int)PARADT__CAN_LIVE, 2, PARADT_MAX_DIM, NULL, paradt__build_by_insertion},

#ifdef PARADT_NO_FLIPS
        {0, 0, 0, NULL, NULL}, // FLIP
#else
        {(int)PARADT__CAN_WEIGHTS | (int)PARADT__CAN_LINK, 2, PARADT_MAX_DIM, NULL, paradt__build_by_flips}, // FLIP
#endif

        {0, 0, 0, NULL, NULL}, // DELAUNAY_TREE

        {0, 0, 0, NULL, NULL}, // LIFTED_HULL

    };
    return rows + method;
}

// The method that builds points of an affine dimension: AUTO's choice. In four dimensions and more, what insertion
// makes only to destroy it again costs more than InCoDe's searches, unless these have to decide ties, see
// paradt__front_is_stuck; where InCoDe gave up, insertion is next.
static const paradt__method *paradt__choose_method(paradt_method wanted, int dim, int gave_up) {
#ifdef PARADT_NO_FRONTS
    const int incode_pays = 0 * dim;
#else
    const int incode_pays = dim >= PARADT__AUTO_INCODE_DIM;
#endif
    if (wanted != PARADT_AUTO) return paradt__method_of(wanted);
    return paradt__method_of(incode_pays && !gave_up ? PARADT_INCODE : PARADT_BOWYER_WATSON);
}

// Plans the call, before the points are read: how many regions there are, how they are built, and what that asks of the
// order of the points. Without neighbours, in three dimensions and less, insertion builds regions one after another,
// and makes some for that of many points: each gives its links back before the next one begins.
static void paradt__plan(paradt__work *work, const paradt_points *points) {
    enum { ONE_BY_ONE = 5, LEAST_POINTS = 500000 };
    const paradt__method *first = paradt__choose_method(work->options.method, points->dim, 0);
    work->facets = (work->options.flags & PARADT_FACETS) != 0;
    work->regions = first->can & PARADT__CAN_REGIONS && work->options.regions ? work->options.regions : 1;
    if (work->regions > points->count) work->regions = points->count ? points->count : 1;
    work->one_by_one = work->options.flags & PARADT_NO_NEIGHBORS && points->dim <= 3 && !first->front &&
                       (work->regions == 1 || !work->options.parallel_for);
    if (first->can & PARADT__CAN_REGIONS && work->one_by_one && work->regions == 1 && points->count >= LEAST_POINTS)
        work->regions = ONE_BY_ONE;
    work->cuts.boxes = work->regions;
    work->cuts.partition = work->options.partition;
    work->cuts.larger_first = !work->one_by_one && !first->front;
    work->cuts.gaps = !first->front || work->options.method == PARADT_AUTO;
}

// Makes the cell of a set of one point, or of none.
static paradt_status paradt__build_trivial(paradt__work *work) {
    paradt_status status;
    work->regions = 1;
    paradt__mesh_begin(&work->mesh, 1, 0);
    status = paradt__mesh_reserve(&work->mesh, 1, 1, &work->memory);
    if (status) return status;
    work->mesh.count = work->set.count;
    work->mesh.vertices[0] = 0;
    work->mesh.links[0] = PARADT__HULL;
    return PARADT_OK;
}

// Builds the mesh, by another method where the first gives up.
static paradt_status paradt__build_mesh(paradt__work *work) {
    paradt_method wanted = work->options.method;
    paradt_status status;
    if (work->set.space.dim <= 0) return paradt__build_trivial(work);
    work->method = paradt__choose_method(wanted, work->set.space.dim, 0);
    work->impatient = wanted == PARADT_AUTO && work->method->front != NULL;
    status = work->method->build(work);
#ifndef PARADT_NO_FRONTS
    if (status != PARADT__GAVE_UP) return status;
    paradt__begin_again(work);
#ifndef PARADT_NO_REGIONS
    if (work->regions > 1) paradt__regions_deal(&work->set, &work->cuts, 0, work->set.count, 0, work->regions);
#endif
    work->method = paradt__choose_method(wanted, work->set.space.dim, 1);
    status = work->method->build(work);
#endif
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>triangulate
//
// The entry: arguments are checked, the call is planned, points are read, the mesh is built, closed and handed over.
// Doors: the public functions; paradt__withdraw; for ranks paradt__check_arguments, paradt__triangulate_region,
// paradt__flat_text.

PARADT_DEF int paradt_version(void) {
    return PARADT_VERSION;
}

static paradt_points paradt__packed_points(size_t count, int dim, paradt_scalar scalar) {
    paradt_points points;
    memset(&points, 0, sizeof points);
    points.count = count;
    points.dim = dim;
    points.scalar = scalar;
    return points;
}

PARADT_DEF paradt_points paradt_points_f64(const double *coordinates, size_t count, int dim) {
    paradt_points points = paradt__packed_points(count, dim, PARADT_F64);
    points.data = coordinates;
    return points;
}

PARADT_DEF paradt_points paradt_points_f32(const float *coordinates, size_t count, int dim) {
    paradt_points points = paradt__packed_points(count, dim, PARADT_F32);
    points.data = coordinates;
    return points;
}

PARADT_DEF const char *paradt_status_string(paradt_status status) {
#define PARADT__TEXT(name, text) text,
    static const char *const texts[] = {PARADT_STATUS_LIST(PARADT__TEXT)};
    return (unsigned)status < PARADT_STATUS_COUNT ? texts[status] : "unknown status";
}

PARADT_DEF const char *paradt_method_string(paradt_method method) {
    static const char *const names[] = {PARADT_METHOD_LIST(PARADT__TEXT)};
#undef PARADT__TEXT
    return (unsigned)method < PARADT_METHOD_COUNT ? names[method] : "unknown method";
}

PARADT_DEF uint64_t paradt_hash_cell(const uint64_t *vertices, int count) {
    uint64_t sorted[PARADT_MAX_DIM + 1], h = (uint64_t)count;
    int i, j;
    for (i = 0; i < count; i++) {
        for (j = i; j > 0 && sorted[j - 1] > vertices[i]; j--) sorted[j] = sorted[j - 1];
        sorted[j] = vertices[i];
    }
    for (i = 0; i < count; i++) h = paradt__mix(h + sorted[i]) + UINT64_C(0x9e3779b97f4a7c15);
    return paradt__mix(h);
}

PARADT_DEF uint64_t paradt_hash(const paradt_triangulation *t) {
    uint64_t sum = 0;
    size_t i;
    int j;
    for (i = 0; i < t->cell_count; i++) {
        uint64_t vertices[PARADT_MAX_DIM + 1];
        for (j = 0; j <= t->dim; j++) vertices[j] = (uint64_t)t->cells[i * (size_t)(t->dim + 1) + (size_t)j];
        sum += paradt_hash_cell(vertices, t->dim + 1);
    }
    return sum;
}

PARADT_DEF void paradt_free(paradt_triangulation *t) {
    paradt__memory memory;
    paradt_options options;
    if (!t) return;
    memset(&options, 0, sizeof options);
    options.allocator = t->allocator;
    paradt__memory_begin(&memory, &options);
    paradt__release(&memory, t->cells);
    paradt__release(&memory, t->neighbors);
    paradt__release(&memory, t->representative);
    memset(t, 0, sizeof *t);
    t->dim = -1;
}

// Returns what is wrong with the points, apart from their number, or NULL.
static const char *paradt__points_fault(const paradt_points *points) {
    size_t size = points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double);
    if (points->dim < 2 || points->dim > PARADT_MAX_DIM) return "points.dim is out of 2..PARADT_MAX_DIM";
    if ((unsigned)points->scalar > PARADT_F32) return "points.scalar is neither PARADT_F64 nor PARADT_F32";
    if (points->count && !points->data) return "points.data is NULL, but points.count is not 0";
    if (points->stride && points->stride < size * (size_t)points->dim)
        return "points.stride is less than the bytes of a point's coordinates; it counts bytes, not coordinates";
    if ((unsigned)points->weight_scalar > PARADT_F32)
        return "points.weight_scalar is neither PARADT_F64 nor PARADT_F32";
    if (points->weight_stride && points->weight_stride < paradt__weight_size(points))
        return "points.weight_stride is less than the bytes of a weight; it counts bytes, not weights";
    return NULL;
}

// Returns what is wrong with the options, or NULL.
static const char *paradt__options_fault(const paradt_options *options) {
    if ((unsigned)options->method >= PARADT_METHOD_COUNT) return "options.method is none of PARADT_METHOD_LIST";
    if ((unsigned)options->partition > PARADT_UNIFORM)
        return "options.partition is neither PARADT_BISECTION nor PARADT_UNIFORM";
    if (options->flags & ~(unsigned)(PARADT_NO_NEIGHBORS | PARADT_FACETS | PARADT_FULL_DIM))
        return "options.flags has a bit that means nothing; were the options zeroed before they were filled?";
    if (options->flags & PARADT_NO_NEIGHBORS && options->flags & PARADT_FACETS)
        return "options.flags has PARADT_FACETS, which is about neighbours, and PARADT_NO_NEIGHBORS";
    if (options->allocator.alloc && !options->allocator.free)
        return "options.allocator has alloc but not free; give both or neither";
    if (options->allocator.free && !options->allocator.alloc)
        return "options.allocator has free but not alloc; give both or neither";
    return NULL;
}

// Returns why the method can't do what is asked of it, or NULL.
static const char *paradt__method_fault(const paradt_points *points, const paradt_options *options) {
    const paradt__method *method = paradt__method_of(options->method);
    if (!method->most_dim) return "options.method is left out of this build, by a macro PARADT_NO_...";
    if (points->dim < method->least_dim || points->dim > method->most_dim)
        return "options.method has no triangulations of dimension points.dim";
    if (points->weights && !(method->can & PARADT__CAN_WEIGHTS)) return "options.method takes no weights";
    if (!(options->flags & PARADT_NO_NEIGHBORS || method->can & PARADT__CAN_LINK))
        return "options.method gives no neighbours; PARADT_NO_NEIGHBORS does without";
    return NULL;
}

// Checks the arguments. Fills *text with what is wrong, or NULL.
PARADT__COLD paradt_status paradt__check_arguments(const paradt_points *points, const paradt_options *options,
                                                   const char **text) {
    size_t size = points && points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double);
    const char *fault = points ? paradt__points_fault(points) : "points is NULL";
    if (!fault && options) fault = paradt__options_fault(options);
    if (!fault && options) fault = paradt__method_fault(points, options);
    if (fault) {
        *text = fault;
        return PARADT_ERROR_ARGUMENT;
    }
    *text = "points.count is larger than an index can number";
    if (points->count > (sizeof(paradt_index) == 4 ? (size_t)INT32_MAX : SIZE_MAX / 16) / 2)
        return PARADT_ERROR_TOO_LARGE;
    *text = "points.count times points.stride is larger than the address space";
    if (points->count > SIZE_MAX / (points->stride ? points->stride : size * (size_t)points->dim))
        return PARADT_ERROR_TOO_LARGE;
    *text = NULL;
    return PARADT_OK;
}

// Returns the most bytes that a call holds, as a multiple of the result's with neighbours. Measured on uniform points.
static double paradt__memory_factor(const paradt__work *work, const paradt_points *points) {
    const paradt__method *first = paradt__choose_method(work->options.method, points->dim, 0);
    double each = (double)points->count / (double)work->regions;
    int several = work->regions > 1;
    if (first->front) {
        if (points->dim == 2) return several ? 3.0 : 2.2;
        return several ? points->dim < 5 ? 2.8 : 4.2 : points->dim < 5 ? 1.45 : 2.0;
    }
    if (points->dim > 3) return several ? 5.0 : 2.0;
    if (points->dim == 2) return several ? work->one_by_one ? 1.4 : 2.0 : 1.6;
    if (!several) return 1.45;
    if (work->one_by_one) return 1.2;
    return 1.5 + 12000.0 / (each + 3000.0);
}

// Returns how many indices the history of PARADT_FLIP takes, and what it keeps with the places, for each cell of the
// result: nodes of dim + 3 indices. Measured on uniform points.
static double paradt__flip_nodes(int dim) {
    static const double nodes[] = {0.0, 3.0, 4.7, 8.5, 12.8, 16.0, 18.5, 20.0, 21.0};
    return nodes[dim] * (dim + 3) + 4.0;
}

PARADT_DEF uint64_t paradt_memory_estimate(const paradt_points *points, const paradt_options *options) {
    enum { FIXED = 1 << 16, SPHERES = 1 << 20 }; // bytes; of insertion in space, for each region
    paradt__work work;
    paradt_points given;
    const char *text;
    double count, cells, bytes;
    if (!points) return 0;
    given = *points;
    given.data = &given; // any address but NULL
    if (paradt__check_arguments(&given, options, &text)) return 0;
    memset(&work, 0, sizeof work);
    if (options) work.options = *options;
    paradt__plan(&work, &given);
    count = (double)given.count;
    cells = count * paradt__cells_a_point(given.dim) * paradt__off_hull(count, given.dim);
    bytes = (2.0 * cells * (given.dim + 1) + count) * (double)sizeof(paradt_index);
    bytes *= paradt__memory_factor(&work, &given);
    if (work.options.method == PARADT_FLIP)
        bytes += cells * paradt__flip_nodes(given.dim) * (double)sizeof(paradt_index);
    if (given.dim == 3) bytes += (double)SPHERES * (0.7 + 0.5 * (double)work.regions);
    return (uint64_t)bytes + FIXED;
}

// Reads the points into the set.
static paradt_status paradt__load(paradt__work *work, const paradt_points *points, paradt_triangulation *out) {
    double begun = paradt__now();
    double reading = points->dim == 2 ? 0.2 : points->dim == 3 ? 0.1 : 0.01; // of the work, reading and sorting points
    paradt__progress progress = paradt__progress_of(&work->meter, &work->reported, reading);
    paradt__team team = paradt__team_of(&work->options, work->regions, progress);
    paradt_status status;
    out->representative = (paradt_index *)paradt__alloc(&work->memory, points->count, sizeof(paradt_index));
    if (!out->representative) return PARADT_ERROR_MEMORY;
    status =
        paradt__set_load(&work->set, points, &work->cuts, &team, &work->memory, out->representative, &out->error_point);
    work->stats->seconds_points = paradt__now() - begun;
    if (!status && paradt__progress_cancels(&progress, 1.0)) status = PARADT_ERROR_CANCELLED;
    if (status) return status;
    work->stats->duplicates = points->count - work->set.count;
    return work->options.flags & PARADT_FULL_DIM && work->set.space.dim < points->dim ? PARADT_ERROR_FLAT : PARADT_OK;
}

// Closes the mesh: drops ghosts, makes vertices the caller's indices, and links what the flags ask for.
static paradt_status paradt__close(paradt__work *work) {
    if (!work->delivered) {
        PARADT__VERIFY(&work->mesh, 0, PARADT__CONFLICT);
        work->stats->hull_facets += paradt__mesh_close(&work->mesh, work->set.origin, work->facets, &work->meter);
    }
    paradt__mesh_rest(&work->mesh, &work->memory);
    if (work->options.flags & PARADT_NO_NEIGHBORS || work->set.space.dim < 1) { // one point has no facets
        paradt__release(&work->memory, work->mesh.links);
        work->mesh.links = NULL;
    }
    return paradt__meter_cancels(&work->meter) ? PARADT_ERROR_CANCELLED : PARADT_OK;
}

// Marks the representatives that are no vertex, and those they stand for, as hidden.
static paradt_status paradt__find_hidden(paradt__work *work, paradt_triangulation *out) {
    const paradt__mesh *mesh = &work->mesh;
    size_t words = out->point_count / 64 + 1, vertices = mesh->count * (size_t)mesh->corners, i;
    uint64_t *used;
    if (!work->set.space.weighted) return PARADT_OK;
    used = (uint64_t *)paradt__alloc(&work->memory, words, sizeof *used);
    if (!used) return PARADT_ERROR_MEMORY;
    memset(used, 0, words * sizeof *used);
    for (i = 0; i < vertices; i++) {
        size_t point = (size_t)mesh->vertices[i];
        used[point / 64] |= (uint64_t)1 << point % 64;
    }
    for (i = 0; i < out->point_count; i++) {
        size_t point = (size_t)out->representative[i];
        if (used[point / 64] >> point % 64 & 1) continue;
        work->stats->hidden += point == i;
        out->representative[i] = -1;
    }
    paradt__release(&work->memory, used);
    return PARADT_OK;
}

// Returns why the points do not span their dimension.
static const char *paradt__flat_text(int dim) {
    if (dim < 0) return "there are no points";
    if (dim == 0) return "all points are at one place";
    if (dim == 1) return "all points lie on a line";
    return dim == 2 ? "all points lie in a plane" : "all points lie in a flat of a lower dimension than points.dim";
}

// Clears `out` after an error, except for what the error is.
static void paradt__withdraw(paradt_triangulation *out, paradt_status status, int dim) {
    size_t bad = out->error_point;
    paradt_free(out);
    out->error_point = bad;
    out->error_text = status == PARADT_ERROR_FLAT ? paradt__flat_text(dim) : paradt_status_string(status);
}

// Begins a call: the plan, the accounts of memory and progress, the statistics.
static void paradt__begin_call(paradt__work *work, paradt_stats *stats, paradt_triangulation *out,
                               const paradt_points *points, const paradt_options *options) {
    memset(work, 0, sizeof *work);
    memset(stats, 0, sizeof *stats);
    if (options) work->options = *options;
    paradt__memory_begin(&work->memory, options);
    paradt__meter_begin(&work->meter, options);
    work->stats = stats;
    out->point_count = points->count;
    out->allocator = work->memory.allocator;
    paradt__plan(work, points);
}

// Ends a call: hands the mesh over, frees all else, and fills the statistics. begun, built: the clock
static paradt_status paradt__end_call(paradt__work *work, paradt_triangulation *out, paradt_status status, double begun,
                                      double built) {
    paradt_stats *stats = work->stats;
    int dim = work->set.space.dim;
    work->meter.done = PARADT__ALL_DONE;
    if (!status && paradt__meter_cancels(&work->meter)) status = PARADT_ERROR_CANCELLED;
    if (!status) {
        out->dim = dim;
        out->cell_count = work->mesh.count;
        out->cells = work->mesh.vertices;
        out->neighbors = work->mesh.links;
        work->mesh.vertices = work->mesh.links = NULL;
    }
    paradt__mesh_free(&work->mesh, &work->memory);
    paradt__set_free(&work->set, &work->memory);
    paradt__release(&work->memory, work->cuts.cut);
    if (status) paradt__withdraw(out, status, dim);
    stats->cells = out->cell_count;
    stats->regions = work->regions;
    stats->peak_bytes = work->memory.peak;
    if (status == PARADT_ERROR_MEMORY) stats->needed_bytes = work->memory.needed;
    stats->seconds_build = built - begun - stats->seconds_points - stats->seconds_grid;
    stats->seconds_finish = paradt__now() - built;
    stats->seconds = paradt__now() - begun;
    out->stats = *stats;
    return status;
}

PARADT_DEF paradt_status paradt_triangulate(paradt_triangulation *out, const paradt_points *points,
                                            const paradt_options *options) {
    paradt__work work;
    paradt_stats stats;
    paradt_status status;
    double begun = paradt__now(), built;
    if (!out) return PARADT_ERROR_ARGUMENT;
    memset(out, 0, sizeof *out);
    out->dim = -1;
    status = paradt__check_arguments(points, options, &out->error_text);
    if (status) return status;
    paradt__begin_call(&work, &stats, out, points, options);
    status = paradt__load(&work, points, out);
    if (!status) status = paradt__build_mesh(&work);
    if (!status) status = paradt__close(&work);
    built = paradt__now();
    paradt__release_helpers(&work);
    if (!status) status = paradt__find_hidden(&work, out);
    return paradt__end_call(&work, out, status, begun, built);
}

#if defined(PARADT_MPI_IMPLEMENTATION) && !defined(PARADT_NO_FRONTS)
// paradt_triangulate for one region of options->regions alone, by InCoDe where the method is neither that nor DeWall:
// `out` gets just the cells that the region owns. Facets that they share with other regions' cells are PARADT__OPEN.
// Hidden points are not found: that takes the cells of all regions.
static paradt_status paradt__triangulate_region(paradt_triangulation *out, const paradt_points *points,
                                                const paradt_options *options, size_t index) {
    paradt__work work;
    paradt_stats stats;
    paradt_status status;
    double begun = paradt__now();
    memset(out, 0, sizeof *out);
    out->dim = -1;
    paradt__begin_call(&work, &stats, out, points, options);
    work.cuts.larger_first = work.cuts.gaps = 0;
    work.method = paradt__method_of(options->method);
    if (!work.method->front) work.method = paradt__method_of(PARADT_INCODE);
    status = paradt__load(&work, points, out);
    if (!status && work.set.space.dim <= 0) {
        status = paradt__build_trivial(&work);
        if (index) work.mesh.count = 0;
    } else if (!status) {
        status = paradt__prepare_fronts(&work);
        if (!status) status = paradt__begin_fronts(&work);
        if (!status) {
            size_t only = index < work.regions ? index : 0;
            paradt__share_memory(&work); // the owners have been allocated since the regions began
            paradt__front_task(&work, only);
            status = work.region[only].status;
            work.mesh = work.region[only].mesh;
            if (index != only) work.mesh.count = 0;
            paradt__count_region(&stats, &work.region[only].stats);
            paradt__share_memory(&work);
        }
    }
    if (!status) status = paradt__close(&work);
    paradt__release_helpers(&work);
    return paradt__end_call(&work, out, status, begun, paradt__now());
}
#endif

#ifndef PARADT_NO_FLIPS
// ---------------------------------------------------------------------------------------------------------------------
// >>mending by flips
//
// Local improvement (thesis, chapter 2): a triangulation whose points have moved is made T(P) again, as far as flips
// can. The mesh is the caller's, with ghosts; its vertices are indices. Moving points turns some cells over, which are
// marked PARADT__WRONG, and makes facets not locally regular. Whatever happens to the places, the mesh remains closed,
// and so every place is covered once if cells that are turned over count -1.
//
// A facet between two cells that are positively oriented is flipped as in >>flips, with the apex of one as the point p.
// So is one between ghosts, if the apex lies in the plane of the hull facet. For a cell t that is turned over, and the
// apex p of a neighbour, the circuit is taken as the mesh has it: N are the vertices of t across whose facets p is the
// apex, Q the others. The flip is done if all new cells are positively oriented; then there are fewer cells that are
// not. A ghost that has p strictly beyond its hull facet is treated likewise: the hull is not convex there.
//
// A ghost counts as turned over if a fixed point, the mean of all, is not strictly on the inner side of its hull facet.
// Think of it as the part beyond the facet of the cone from that point. Then cells and ghosts cover every place once.
//
// Flips of facets that are not locally regular lower the surface of the lifted points, the others lessen the number of
// cells that are turned over, or fill a notch of the hull. In the plane only few places are left, from three dimensions
// on facets may be stuck: they are left to >>mending by holes.
// Doors: paradt__mend_flip_all, paradt__mend_is_wrong.

// What mending works with
typedef struct paradt__mend {
    paradt__flipper flipper;
    paradt_repair_stats *stats;
    paradt__meter *meter;
    paradt__list facets; // to be looked at
    paradt__list stuck;  // facets that no flip could help, when they were looked at
    const double *inner; // the record of a point that is to be inside of the hull
    uint64_t looks;      // at facets
    uint64_t most_flips; // with more it is better to build anew
    int vanished;        // vertices may be in no cell any more
} paradt__mend;

// Is a vertex of what was collected in Q?
PARADT__INLINE int paradt__mend_in_q(const paradt__flipper *f, paradt_index vertex) {
    int i;
    for (i = f->negative; i < f->negative + f->positive; i++) {
        if (f->member[i] == vertex) return 1;
    }
    return 0;
}

// Do the facets of a cell that is to be flipped lead to other cells where they are opposite to vertices in Q, and
// nowhere else?
static int paradt__mend_is_part(const paradt__mend *m, paradt_index cell) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    paradt_index corners = mesh->corners, i;
    for (i = cell * corners; i < (cell + 1) * corners; i++) {
        int leaves = !(mesh->marks[mesh->links[i] / corners] & PARADT__WAITING);
        if (leaves != paradt__mend_in_q(&m->flipper, mesh->vertices[i])) return 0;
    }
    return 1;
}

// The cell of number i of those that the flip would kill: for each cell of the star that cell and those across from N
static paradt_index paradt__mend_killed(const paradt__mend *m, size_t i) {
    const paradt__flipper *f = &m->flipper;
    const paradt__mesh *mesh = &f->build.scene.mesh;
    paradt_index corners = mesh->corners;
    size_t each = (size_t)f->negative + 1, at = i / each;
    if (i % each == 0) return f->star.items[at];
    return mesh->links[f->star.items[at] * corners + f->places[at * (size_t)corners + i % each - 1]] / corners;
}

// Does the mesh have the simplices that the flip replaces as the circuit has them? That is certain in a triangulation,
// but not where cells are turned over.
static int paradt__mend_is_circuit(paradt__mend *m) {
    paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    size_t count = m->flipper.star.count * (size_t)(m->flipper.negative + 1), i, marked;
    int is = 1;
    for (marked = 0; marked < count && is; marked += is != 0)
        is = paradt__mesh_mark(mesh, (size_t)paradt__mend_killed(m, marked), PARADT__WAITING);
    for (i = 0; i < count && is; i++) is = paradt__mend_is_part(m, paradt__mend_killed(m, i));
    for (i = 0; i < marked; i++) paradt__mesh_unmark(mesh, (size_t)paradt__mend_killed(m, i), PARADT__WAITING);
    return is;
}

// Flips what was collected, and lists the facets of the new cells: all, or those that are not between cells of the same
// circuit, which are locally regular where the circuit was not.
static paradt_status paradt__mend_flip(paradt__mend *m, int all) {
    const paradt__update *update = &m->flipper.build.update;
    int corners = m->flipper.build.scene.mesh.corners, i;
    paradt_status status = corners == 4 ? paradt__flip(&m->flipper, 4) : paradt__flip(&m->flipper, corners);
    size_t made, count = update->made_count * (size_t)corners;
    if (!status)
        status = paradt__list_room(&m->facets.items, m->facets.count, &m->facets.capacity, m->facets.count + count,
                                   m->flipper.build.memory);
    if (status) return status;
    for (made = 0; made < update->made_count; made++) {
        paradt_index base = update->made[made] - update->made[made] % corners;
        const paradt_index *row = m->flipper.build.scene.mesh.vertices + base;
        for (i = 0; i < corners; i++) {
            if (all || !paradt__mend_in_q(&m->flipper, row[i])) m->facets.items[m->facets.count++] = base + i;
        }
    }
    m->vanished |= m->flipper.positive == 1;
    PARADT__VERIFY_SMALL(&m->flipper.build.scene.mesh, 1, PARADT__CONFLICT);
    return ++m->stats->flips > m->most_flips ? PARADT__GAVE_UP : PARADT_OK;
}

// Would a cell or ghost be turned over, or flat, with p in the place i of its row?
static int paradt__mend_turns(paradt__mend *m, paradt_index cell, int i, paradt_index point) {
    paradt__scene *scene = &m->flipper.build.scene;
    const paradt_index *vertices = paradt__mesh_row(&scene->mesh, cell);
    const double *p[PARADT_MAX_DIM + 1];
    int corners = scene->mesh.corners, ghost = -1, j;
    for (j = 0; j < corners; j++) {
        if (j == i) p[j] = paradt__scene_record(scene, point);
        else if (vertices[j] == PARADT__INFINITE) p[ghost = j] = m->inner;
        else p[j] = paradt__scene_record(scene, vertices[j]);
    }
    j = paradt__orient(&scene->space, p);
    return ghost < 0 ? j <= 0 : j >= 0;
}

// Tries the circuit that the mesh has around a cell, or a ghost, and the apex p of one of its neighbours.
static paradt_status paradt__mend_try(paradt__mend *m, paradt_index cell, paradt_index point, int *done) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    int corners = mesh->corners, i, possible;
    paradt__signs signs = {0, 0};
    paradt_status status;
    *done = 0;
    for (i = 0; i < corners; i++) {
        if (mesh->vertices[cell * corners + i] == point) return PARADT_OK;
        if (mesh->vertices[mesh->links[cell * corners + i]] == point) signs.negative |= (uint16_t)(1u << i);
        else if (paradt__mend_turns(m, cell, i, point)) return PARADT_OK;
        else signs.positive |= (uint16_t)(1u << i);
    }
    if (!signs.positive) return PARADT_OK;
    status = paradt__flip_collect(&m->flipper, cell, point, signs, corners, &possible);
    if (status || !possible || !paradt__mend_is_circuit(m)) return status;
    *done = 1;
    return paradt__mend_flip(m, 1);
}

// Notes a facet that no flip could help.
static paradt_status paradt__mend_note(paradt__mend *m, paradt_index handle) {
    return paradt__list_append(&m->stuck, handle, m->flipper.build.memory);
}

// Tries to get rid of a cell that is turned over.
static paradt_status paradt__mend_turn(paradt__mend *m, paradt_index cell) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    paradt_index corners = mesh->corners, i;
    int done = 0;
    paradt_status status = PARADT_OK;
    for (i = 0; i < corners && !done && !status; i++) {
        paradt_index mirror = mesh->links[cell * corners + i], apex = mesh->vertices[mirror];
        paradt_index vertex = mesh->vertices[cell * corners + i];
        if (apex == PARADT__INFINITE && vertex == PARADT__INFINITE) continue; // ghosts back to back
        if (apex == PARADT__INFINITE) status = paradt__mend_try(m, mirror / corners, vertex, &done);
        else status = paradt__mend_try(m, cell, apex, &done);
    }
    return status || done ? status : paradt__mend_note(m, cell * corners);
}

// Is the cell or ghost turned over, or the ghost on a cell that is?
static int paradt__mend_is_wrong(const paradt__mesh *mesh, paradt_index cell) {
    int ghost = paradt__ghost_place(paradt__mesh_row(mesh, cell), mesh->corners);
    if (mesh->marks[cell] & PARADT__WRONG) return 1;
    if (ghost >= 0) cell = mesh->links[cell * mesh->corners + ghost] / mesh->corners;
    return (mesh->marks[cell] & PARADT__WRONG) != 0;
}

// Flips the facet of a cell that is in conflict with the apex p on the other side, if that can be done.
static paradt_status paradt__mend_improve(paradt__mend *m, paradt_index handle, paradt_index point) {
    paradt__scene *scene = &m->flipper.build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    const double *x = paradt__scene_record(scene, point);
    const int corners = mesh->corners;
    paradt_index cell = handle / corners;
    int ghost = paradt__ghost_place(paradt__mesh_row(mesh, cell), corners), i, possible;
    paradt__signs signs = {0, 0};
    paradt_status status;
    size_t at;
    for (i = 0; i < corners; i++) {
        int side = i == ghost ? 0 : paradt__flip_sign(scene, cell, i, x, corners);
        signs.negative |= (uint16_t)((unsigned)(side < 0) << i);
        signs.positive |= (uint16_t)((unsigned)(side > 0) << i);
    }
    status = paradt__flip_collect(&m->flipper, cell, point, signs, corners, &possible);
    for (at = 0; at < m->flipper.star.count && possible; at++)
        possible = !paradt__mend_is_wrong(mesh, m->flipper.star.items[at]);
    if (status) return status;
    return possible && paradt__mend_is_circuit(m) ? paradt__mend_flip(m, 0) : paradt__mend_note(m, handle);
}

// Looks at a facet, if its cell is still there.
static paradt_status paradt__mend_look(paradt__mend *m, paradt_index handle) {
    paradt__scene *scene = &m->flipper.build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    const int corners = mesh->corners;
    paradt_index cell = handle / corners, mirror, point;
    const double *x;
    int ghost, done;
    if (mesh->vertices[cell * corners] == PARADT__DEAD) return PARADT_OK;
    mirror = mesh->links[handle];
    if (mesh->marks[cell] & PARADT__WRONG) return paradt__mend_turn(m, cell);
    if (mesh->marks[mirror / corners] & PARADT__WRONG) return paradt__mend_turn(m, mirror / corners);
    point = mesh->vertices[mirror];
    if (point == PARADT__INFINITE || mesh->vertices[handle] == PARADT__INFINITE) return PARADT_OK;
    x = paradt__scene_record(scene, point);
    ghost = paradt__ghost_place(paradt__mesh_row(mesh, cell), corners);
    if (ghost >= 0 && paradt__side(scene, cell, ghost, x) > 0) {
        paradt_status status = paradt__mend_try(m, cell, point, &done);
        return status || done ? status : paradt__mend_note(m, handle);
    }
    if (ghost >= 0 && paradt__mend_is_wrong(mesh, cell)) return paradt__mend_note(m, handle);
    return paradt__conflicts(scene, cell, x) ? paradt__mend_improve(m, handle, point) : PARADT_OK;
}

// Fetches what looks at facets that are soon to come need, in three steps: rows, neighbours' rows, records and the rows
// around the neighbour. Facets are taken from the end of the list, which the survey has filled in the order of cells.
PARADT__INLINE void paradt__mend_fetch(const paradt__mend *m, size_t at) {
    enum { ROWS_AHEAD = 24, ACROSS_AHEAD = 16, RECORDS_AHEAD = 8 };
    const paradt__scene *scene = &m->flipper.build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    const paradt_index *items = m->facets.items;
    const int corners = mesh->corners;
    paradt_index handle, base, other, i;
    if (at < ROWS_AHEAD) return;
    handle = items[at - ROWS_AHEAD];
    PARADT__FETCH(mesh->links, handle);
    PARADT__FETCH(mesh->vertices, handle);
    handle = items[at - ACROSS_AHEAD];
    base = handle - handle % corners;
    PARADT__FETCH(mesh->marks, base / corners);
    if (mesh->vertices[base] == PARADT__DEAD) return;
    for (i = base; i < base + corners; i++) {
        PARADT__FETCH(mesh->links, mesh->links[i]);
        PARADT__FETCH(mesh->vertices, mesh->links[i]);
    }
    handle = items[at - RECORDS_AHEAD];
    base = handle - handle % corners;
    if (mesh->vertices[base] == PARADT__DEAD) return;
    PARADT__FETCH(mesh->marks, mesh->links[handle] / corners);
    other = mesh->links[handle] - mesh->links[handle] % corners;
    for (i = 0; i < corners; i++) {
        PARADT__FETCH(mesh->links, mesh->links[other + i]);
        PARADT__FETCH(mesh->vertices, mesh->links[other + i]);
    }
    for (i = base; i < base + corners; i++) {
        paradt_index mirror = mesh->links[i];
        if (mesh->vertices[i] >= 0) PARADT__FETCH(scene->records, (size_t)mesh->vertices[i] * scene->width);
        if (mesh->vertices[mirror] >= 0) PARADT__FETCH(scene->records, (size_t)mesh->vertices[mirror] * scene->width);
    }
}

// Looks at all facets that are listed.
static paradt_status paradt__mend_flip_all(paradt__mend *m) {
    enum { PACE = 1024 }; // facets between two looks at whether the call is cancelled
    paradt_status status = PARADT_OK;
    size_t fetched = m->facets.count + 1;
    while (m->facets.count && !status) {
        if (m->looks++ % PACE == 0 && paradt__meter_cancels(m->meter)) return PARADT_ERROR_CANCELLED;
        if (m->facets.count < fetched) paradt__mend_fetch(m, fetched = m->facets.count);
        status = paradt__mend_look(m, m->facets.items[--m->facets.count]);
    }
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>mending by holes
//
// What flips leave: cells that are turned over, and facets that are not locally regular. Such cells are taken out. Let
// Q be the vertices of the hole. If the facets of its rim are facets of T(P), T(P) fills the hole with cells on points
// of Q, which are cells of T(Q), too: ghosts as well as others. T(Q) is made by insertion, and the hole is filled with
// the cells of T(Q) that can be reached from its rim. A hole is enlarged by the cells beyond those facets of its rim
// that T(Q) does not have, or that would not be locally regular, and by all beyond its rim if the filling gets out of
// the hole. So nothing is left to be looked at afterwards. In the end all cells are positively oriented, all facets and
// the hull's ridges are locally regular, and every place is covered once: that proves that the mesh is T(P).
// Doors: paradt__mend_fill_all, paradt__mend_end,
// paradt__vertex_at, paradt__mend_is_done.

// A hole, and what it is filled with
typedef struct paradt__hole {
    paradt__list cells;      // places; they have the mark PARADT__CONFLICT
    paradt__list points;     // Q
    paradt__list rim;        // facets of the hole's cells
    paradt__list walls;      // for each the same facet in T(Q), seen from inside
    paradt__list reached;    // places in T(Q) of the cells that fill the hole
    paradt__list becomes;    // by place in T(Q): where the cell gets its place; PARADT__OPEN: it is not reached
    paradt__list outer;      // by handle in T(Q): the facet of a kept cell that is on the other side, or PARADT__OPEN
    paradt__insertion small; // T(Q)
    paradt__facets table;    // of the facets of T(Q)
    uint32_t *seen;          // [points] by point: the number of the last hole that it was in
    uint32_t number;         // of holes that points were collected for
} paradt__hole;

static void paradt__hole_free(paradt__hole *hole, paradt__memory *memory) {
    paradt__list_free(&hole->cells, memory);
    paradt__list_free(&hole->points, memory);
    paradt__list_free(&hole->rim, memory);
    paradt__list_free(&hole->walls, memory);
    paradt__list_free(&hole->reached, memory);
    paradt__list_free(&hole->becomes, memory);
    paradt__list_free(&hole->outer, memory);
    hole->small.memory = memory;
    paradt__insertion_end(&hole->small);
    paradt__facets_free(&hole->table, memory);
    paradt__release(memory, hole->seen);
}

// Frees what mending has taken, except for the mesh.
static void paradt__mend_end(paradt__mend *m) {
    paradt__list_free(&m->facets, m->flipper.build.memory);
    paradt__list_free(&m->stuck, m->flipper.build.memory);
    paradt__flipper_rest(&m->flipper);
}

// Adds a cell to the hole.
static paradt_status paradt__hole_add(paradt__mend *m, paradt__hole *hole, paradt_index cell) {
    if (!paradt__mesh_mark(&m->flipper.build.scene.mesh, (size_t)cell, PARADT__CONFLICT)) return PARADT_OK;
    return paradt__list_append(&hole->cells, cell, m->flipper.build.memory);
}

// Collects the rim and the points of the hole; neighbours that must go, too, are added first.
static paradt_status paradt__hole_survey(paradt__mend *m, paradt__hole *hole) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    paradt__memory *memory = m->flipper.build.memory;
    paradt_index corners = mesh->corners, i;
    paradt_status status = PARADT_OK;
    size_t at;
    hole->rim.count = hole->points.count = 0;
    hole->number++;
    for (at = 0; at < hole->cells.count && !status; at++) {
        for (i = 0; i < corners && !status; i++) {
            paradt_index other = mesh->links[hole->cells.items[at] * corners + i] / corners;
            if (mesh->marks[other] & (PARADT__LISTED | PARADT__WRONG)) status = paradt__hole_add(m, hole, other);
        }
    }
    for (at = 0; at < hole->cells.count && !status; at++) {
        for (i = 0; i < corners && !status; i++) {
            paradt_index handle = hole->cells.items[at] * corners + i, vertex = mesh->vertices[handle];
            if (!(mesh->marks[mesh->links[handle] / corners] & PARADT__CONFLICT))
                status = paradt__list_append(&hole->rim, handle, memory);
            if (status || vertex < 0 || hole->seen[vertex] == hole->number) continue;
            hole->seen[vertex] = hole->number;
            status = paradt__list_append(&hole->points, vertex, memory);
        }
    }
    return status;
}

// Begins T(Q) anew. Returns PARADT_OK with an empty mesh if Q does not span the space.
static paradt_status paradt__hole_first_cells(paradt__mend *m, paradt__hole *hole, const paradt__set *set) {
    paradt__insertion *small = &hole->small;
    paradt__mesh *mesh = &small->scene.mesh;
    paradt__set part = *set;
    paradt_index basis[PARADT_MAX_DIM + 1], *order = hole->points.items;
    int count, i;
    part.count = hole->points.count;
    if (mesh->marks) memset(mesh->marks, 0, mesh->count);
    mesh->count = mesh->spare_count = 0;
    count = paradt__set_basis(&part, order, 0, basis, NULL, &small->scene.space.counters, NULL);
    if (count < mesh->corners) return PARADT_OK;
    for (i = 0; i < count; i++) {
        size_t at = (size_t)i;
        while (order[at] != basis[i]) at++;
        order[at] = order[i];
        order[i] = basis[i];
    }
    small->memory = m->flipper.build.memory;
    small->order = order;
    small->count = part.count;
    small->inserted = (size_t)count;
    small->scene.hint = 0;
    return paradt__insertion_first_cells(small);
}

// Is the point at the place of a vertex of the cell? Returns the vertex, or PARADT__NOWHERE.
static paradt_index paradt__vertex_at(const paradt__scene *scene, paradt_index cell, paradt_index point) {
    const paradt_index *vertices = paradt__mesh_row(&scene->mesh, cell);
    const double *x = paradt__scene_record(scene, point);
    int i;
    for (i = 0; i < scene->mesh.corners; i++) {
        if (vertices[i] >= 0 && !paradt__compare(&scene->space, paradt__scene_record(scene, vertices[i]), x))
            return vertices[i];
    }
    return PARADT__NOWHERE;
}

// Makes T(Q). Points at the same place are one; with weights it is better to build anew then.
static paradt_status paradt__hole_triangulate(paradt__mend *m, paradt__hole *hole, const paradt__set *set) {
    paradt__insertion *small = &hole->small;
    paradt_status status = paradt__hole_first_cells(m, hole, set);
    if (!small->scene.mesh.count) return status;
    for (; small->inserted < small->count && !status; small->inserted++) {
        paradt_index point = small->order[small->inserted];
        small->scene.hint = paradt__walk(&small->scene, small->scene.hint, paradt__scene_record(&small->scene, point));
        if (paradt__vertex_at(&small->scene, small->scene.hint, point) == PARADT__NOWHERE)
            status = paradt__insert(small, point);
        else if (small->scene.space.weighted) status = PARADT__GAVE_UP;
        if (small->inserted % 64 == 63 && paradt__meter_cancels(m->meter)) status = PARADT_ERROR_CANCELLED;
    }
    return status;
}

// Do two cells see a facet, opposite vertex i of one and j of the other, from different sides?
static int paradt__sees_from_outside(const paradt_index *one, int i, const paradt_index *two, int j, int corners) {
    int to[PARADT_MAX_DIM + 1], a, b, odd = 0;
    for (a = 0; a < corners; a++) {
        to[a] = j;
        for (b = 0; b < corners && a != i; b++) {
            if (b != j && two[b] == one[a]) to[a] = b;
        }
    }
    for (a = 0; a < corners; a++) {
        for (b = a + 1; b < corners; b++) odd ^= to[a] > to[b];
    }
    return odd;
}

// Enters the facets of T(Q) into the table.
static paradt_status paradt__hole_enter(paradt__mend *m, paradt__hole *hole) {
    paradt__mesh *mesh = &hole->small.scene.mesh;
    paradt__memory *memory = m->flipper.build.memory;
    const int corners = mesh->corners;
    paradt_index handle, end = (paradt_index)mesh->count * corners;
    paradt_status status = PARADT_OK;
    paradt__facets_free(&hole->table, memory);
    status = paradt__facets_begin(&hole->table, 0, 1, memory);
    if (!status) status = paradt__facets_room(&hole->table, (size_t)end / 2 + 1, memory);
    for (handle = 0; handle < end && !status; handle++) {
        paradt__facet_key key;
        if (mesh->vertices[handle - handle % corners] == PARADT__DEAD || mesh->links[handle] < handle) continue;
        key = paradt__facet_key_of(&hole->table, mesh, handle);
        paradt__facets_match(&hole->table, mesh, paradt__facets_chain(&hole->table, key), key, handle, corners);
    }
    return status;
}

// Finds the facets of the rim in T(Q). The cells beyond those that are not there are added to the hole.
static paradt_status paradt__hole_match(paradt__mend *m, paradt__hole *hole) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh, *small = &hole->small.scene.mesh;
    paradt__memory *memory = m->flipper.build.memory;
    const int corners = mesh->corners;
    paradt_status status = PARADT_OK;
    size_t at;
    hole->walls.count = 0;
    for (at = 0; at < hole->rim.count && !status; at++) {
        paradt_index outer = mesh->links[hole->rim.items[at]], base = outer - outer % corners, found = PARADT__OPEN;
        if (small->count)
            found = paradt__facets_find(&hole->table, small, paradt__facet_key_of(&hole->table, mesh, outer),
                                        mesh->vertices, outer, corners);
        if (found < 0) {
            status = paradt__hole_add(m, hole, outer / corners);
            continue;
        }
        if (!paradt__sees_from_outside(mesh->vertices + base, (int)(outer % corners),
                                       small->vertices + (found - found % corners), (int)(found % corners), corners))
            found = small->links[found];
        status = paradt__list_append(&hole->walls, found, memory);
    }
    return status;
}

// Fills a list with `count` items of PARADT__OPEN.
static paradt_status paradt__list_open(paradt__list *list, size_t count, paradt__memory *memory) {
    paradt_status status = paradt__list_room(&list->items, 0, &list->capacity, count, memory);
    if (status) return status;
    for (list->count = 0; list->count < count; list->count++) list->items[list->count] = PARADT__OPEN;
    return PARADT_OK;
}

// Reaches the cells of T(Q) that fill the hole, from the walls. *tight: none is beyond a wall
static paradt_status paradt__hole_reach(paradt__mend *m, paradt__hole *hole, int *tight) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh, *small = &hole->small.scene.mesh;
    paradt__memory *memory = m->flipper.build.memory;
    paradt_index corners = mesh->corners, i;
    size_t at;
    paradt_status status = paradt__list_open(&hole->becomes, small->count, memory);
    if (!status) status = paradt__list_open(&hole->outer, small->count * (size_t)corners, memory);
    if (!status) status = paradt__list_room(&hole->reached.items, 0, &hole->reached.capacity, small->count, memory);
    if (status) return status;
    hole->reached.count = 0;
    *tight = 1;
    for (at = 0; at < hole->rim.count; at++) {
        paradt_index wall = hole->walls.items[at];
        if (hole->outer.items[wall] >= 0) *tight = 0;
        hole->outer.items[wall] = mesh->links[hole->rim.items[at]];
        if (hole->becomes.items[wall / corners] >= 0) continue;
        hole->becomes.items[wall / corners] = 0;
        hole->reached.items[hole->reached.count++] = wall / corners;
    }
    for (at = 0; at < hole->reached.count; at++) {
        paradt_index base = hole->reached.items[at] * corners;
        for (i = base; i < base + corners; i++) {
            paradt_index other = small->links[i] / corners;
            if (hole->outer.items[i] >= 0 || hole->becomes.items[other] >= 0) continue;
            hole->becomes.items[other] = 0;
            hole->reached.items[hole->reached.count++] = other;
        }
    }
    for (at = 0; at < hole->walls.count; at++) {
        if (hole->becomes.items[small->links[hole->walls.items[at]] / corners] >= 0) *tight = 0;
    }
    return PARADT_OK;
}

// How often does a cell cover the inner point: 1, 0, or if it is turned over -1? *unclear: the point is on its boundary
static int paradt__mend_covers(const paradt__mend *m, paradt__scene *scene, paradt_index cell, int *unclear) {
    const paradt_index *row = paradt__mesh_row(&scene->mesh, cell);
    int corners = scene->mesh.corners, i, positive = 0, negative = 0;
    if (paradt__ghost_place(row, corners) >= 0) return 0;
    for (i = 0; i < corners && !(positive && negative); i++) {
        int side = paradt__side(scene, cell, i, m->inner);
        positive += side > 0;
        negative += side < 0;
    }
    if (positive && negative) return 0;
    *unclear |= positive + negative < corners;
    return positive ? 1 : -1;
}

// Does what was reached fit into the hole: are its ghosts the right way round, and is it the inside of the rim as the
// hole's cells have it, not the outside? That is so if both cover one point, the inner one, equally often.
static int paradt__hole_fits(const paradt__mend *m, paradt__scene *scene, paradt__hole *hole) {
    paradt__scene *small = &hole->small.scene;
    int covers = 0, unclear = 0;
    size_t at;
    for (at = 0; at < hole->reached.count; at++) {
        paradt_index cell = hole->reached.items[at];
        int ghost = paradt__ghost_place(paradt__mesh_row(&small->mesh, cell), small->mesh.corners);
        if (ghost >= 0 && paradt__side(small, cell, ghost, m->inner) >= 0) return 0;
        covers += paradt__mend_covers(m, small, cell, &unclear);
    }
    for (at = 0; at < hole->cells.count; at++) covers -= paradt__mend_covers(m, scene, hole->cells.items[at], &unclear);
    return !covers && !unclear;
}

// Adds the cells beyond the rim to the hole: all, or where the facet would not be locally regular.
static paradt_status paradt__hole_enlarge(paradt__mend *m, paradt__hole *hole, int all) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    paradt__scene *small = &hole->small.scene;
    paradt_index corners = mesh->corners;
    paradt_status status = PARADT_OK;
    size_t at;
    for (at = 0; at < hole->rim.count && !status; at++) {
        paradt_index outer = mesh->links[hole->rim.items[at]], apex = mesh->vertices[outer];
        paradt_index wall = all ? 0 : hole->walls.items[at];
        if (!all && (apex == PARADT__INFINITE || small->mesh.vertices[wall] == PARADT__INFINITE)) continue;
        if (all || paradt__conflicts(small, wall / corners, paradt__scene_record(small, apex)))
            status = paradt__hole_add(m, hole, outer / corners);
    }
    return status;
}

// Are there points of the hole that are no vertices of the cells reached?
static int paradt__hole_loses(paradt__hole *hole) {
    const paradt__mesh *small = &hole->small.scene.mesh;
    size_t corners = (size_t)small->corners, count = 0, at, i;
    hole->number++;
    for (at = 0; at < hole->reached.count; at++) {
        const paradt_index *row = paradt__mesh_row(small, hole->reached.items[at]);
        for (i = 0; i < corners; i++) {
            if (row[i] < 0 || hole->seen[row[i]] == hole->number) continue;
            hole->seen[row[i]] = hole->number;
            count++;
        }
    }
    return count < hole->points.count;
}

// Puts the cells that were reached into the mesh, in the place of the hole's.
static paradt_status paradt__hole_close(paradt__mend *m, paradt__hole *hole) {
    paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    const paradt__mesh *small = &hole->small.scene.mesh;
    paradt_index corners = mesh->corners, i;
    size_t at, row = (size_t)corners * sizeof(paradt_index);
    paradt_status status = paradt__insertion_room(&m->flipper.build, hole->reached.count);
    if (!status) status = paradt__mesh_spare_room(mesh, hole->cells.count, m->flipper.build.memory);
    if (status) return status;
    for (at = 0; at < hole->reached.count; at++) {
        paradt_index place = paradt__mesh_take(mesh), from = hole->reached.items[at];
        mesh->marks[place] = 0;
        memcpy(mesh->vertices + place * corners, small->vertices + from * corners, row);
        hole->becomes.items[from] = place;
    }
    for (at = 0; at < hole->reached.count; at++) {
        paradt_index from = hole->reached.items[at] * corners,
                     to = hole->becomes.items[hole->reached.items[at]] * corners;
        for (i = 0; i < corners; i++) {
            paradt_index outer = hole->outer.items[from + i], mirror = small->links[from + i];
            if (outer >= 0) paradt__mesh_tie(mesh, to + i, outer);
            else mesh->links[to + i] = hole->becomes.items[mirror / corners] * corners + mirror % corners;
        }
    }
    for (at = 0; at < hole->cells.count; at++) {
        mesh->marks[hole->cells.items[at]] = 0;
        paradt__mesh_give(mesh, hole->cells.items[at], (size_t)corners);
    }
    m->vanished |= paradt__hole_loses(hole);
    m->stats->reinserted += hole->points.count;
    m->stats->holes++;
    PARADT__VERIFY_SMALL(mesh, 1, PARADT__CONFLICT);
    return PARADT_OK;
}

// Makes a hole around a cell and fills it.
static paradt_status paradt__mend_fill(paradt__mend *m, paradt__hole *hole, const paradt__set *set, paradt_index cell) {
    const paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    paradt_status status;
    hole->cells.count = 0;
    status = paradt__hole_add(m, hole, cell);
    while (!status) {
        size_t before;
        int tight = 0;
        status = paradt__hole_survey(m, hole);
        before = hole->cells.count;
        if (!status && (before > mesh->count / 4 + 64 || !hole->rim.count)) status = PARADT__GAVE_UP;
        if (!status) status = paradt__hole_triangulate(m, hole, set);
        if (!status && hole->small.scene.mesh.count) status = paradt__hole_enter(m, hole);
        if (!status) status = paradt__hole_match(m, hole);
        if (status || hole->cells.count > before) continue;
        status = paradt__hole_reach(m, hole, &tight);
        if (!status)
            status = paradt__hole_enlarge(m, hole, !tight || !paradt__hole_fits(m, &m->flipper.build.scene, hole));
        if (!status && hole->cells.count == before) return paradt__hole_close(m, hole);
    }
    return status;
}

// Marks the cells of a facet, if it is still there, and not locally regular or of a cell that is turned over. Facets
// between others are marked by their own cells.
static void paradt__mend_list(paradt__mend *m, paradt_index handle) {
    paradt__scene *scene = &m->flipper.build.scene;
    paradt__mesh *mesh = &scene->mesh;
    paradt_index corners = mesh->corners, cell = handle / corners, other, point;
    if (mesh->vertices[cell * corners] == PARADT__DEAD) return;
    if (mesh->marks[cell] & PARADT__WRONG) {
        m->stats->stuck += paradt__mesh_mark(mesh, (size_t)cell, PARADT__LISTED) != 0;
        return;
    }
    other = mesh->links[handle] / corners;
    point = mesh->vertices[mesh->links[handle]];
    if (point < 0 || mesh->vertices[handle] < 0 || paradt__mend_is_wrong(mesh, cell)) return;
    if (!paradt__conflicts(scene, cell, paradt__scene_record(scene, point))) return;
    m->stats->stuck++;
    paradt__mesh_mark(mesh, (size_t)cell, PARADT__LISTED);
    paradt__mesh_mark(mesh, (size_t)other, PARADT__LISTED);
}

#if defined(PARADT_VERIFY)
// Is the mesh T(P), P its vertices?
static int paradt__mend_is_done(paradt__mend *m) {
    paradt__scene *scene = &m->flipper.build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    paradt_index corners = mesh->corners, cell, i;
    for (cell = 0; cell < (paradt_index)mesh->count; cell++) {
        const paradt_index *row = paradt__mesh_row(mesh, cell);
        int ghost = paradt__ghost_place(row, corners);
        if (row[0] == PARADT__DEAD) continue;
        if (mesh->marks[cell]) return 0;
        if (ghost < 0 ? paradt__side(scene, cell, 0, paradt__scene_record(scene, row[0])) <= 0
                      : paradt__side(scene, cell, ghost, m->inner) >= 0)
            return 0;
        for (i = 0; i < corners; i++) {
            paradt_index apex = mesh->vertices[mesh->links[cell * corners + i]];
            if (apex < 0 || row[i] < 0) continue;
            if (paradt__conflicts(scene, cell, paradt__scene_record(scene, apex))) return 0;
        }
    }
    return 1;
}
#endif

// Takes out and fills what flips could not help.
static paradt_status paradt__mend_fill_all(paradt__mend *m, const paradt__set *set) {
    paradt__mesh *mesh = &m->flipper.build.scene.mesh;
    paradt__memory *memory = m->flipper.build.memory;
    const int corners = mesh->corners;
    paradt__hole hole;
    paradt_status status = PARADT_OK;
    size_t at;
    for (at = 0; at < m->stuck.count; at++) paradt__mend_list(m, m->stuck.items[at]);
    if (!m->stats->stuck) return PARADT_OK;
    memset(&hole, 0, sizeof hole);
    hole.small = m->flipper.build;
    memset(&hole.small.update, 0, sizeof hole.small.update);
    hole.small.rim = NULL;
    hole.small.rim_count = hole.small.rim_capacity = 0;
    memset(&hole.small.ridges, 0, sizeof hole.small.ridges);
    hole.small.kept = NULL;
    paradt__mesh_begin(&hole.small.scene.mesh, corners, 1);
    hole.seen = (uint32_t *)paradt__alloc(memory, set->count, sizeof *hole.seen);
    if (!hole.seen) return PARADT_ERROR_MEMORY;
    memset(hole.seen, 0, set->count * sizeof *hole.seen);
    status = paradt__list_room(&hole.small.update.killed, 0, &hole.small.update.killed_capacity, 16, memory);
    for (at = 0; at < m->stuck.count && !status; at++) {
        paradt_index cell = m->stuck.items[at] / corners;
        if (mesh->vertices[cell * corners] == PARADT__DEAD || !(mesh->marks[cell] & PARADT__LISTED)) continue;
        status = paradt__mend_fill(m, &hole, set, cell);
        if (!status && paradt__meter_cancels(m->meter)) status = PARADT_ERROR_CANCELLED;
    }
    paradt__hole_free(&hole, memory);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>spheres of cells in space
//
// In space, without weights: are cells positively oriented, and their facets locally regular? Each cell's sphere is
// made once for all of its facets, as in >>kept spheres, and four cells are looked at together: in lanes that compilers
// can make vectors of, or by AVX2. The sphere's bound on the error also proves that the cell is positively oriented.
// Where it does not, the predicates are to be asked. A facet is looked at from the first of its cells alone.
// Doors: paradt__choose_fine.

enum { PARADT__TOGETHER = 4 }; // cells whose spheres are made together

// What is known of some cells in lanes, so that compilers can make vectors of them
typedef struct paradt__lanes {
    double edge[3][4][PARADT__TOGETHER]; // from the last vertex to the others; and their squares
    double base[4][PARADT__TOGETHER];    // the last vertex, and its lift
    double apex[3][PARADT__TOGETHER];    // across a facet
    double asked[PARADT__TOGETHER];      // 0 where nothing is to be asked about the facet, else 1
    double normal[3][PARADT__TOGETHER], constant[PARADT__TOGETHER], error[PARADT__TOGETHER];
    double least[PARADT__TOGETHER]; // of the powers of apexes, less the error; positive: all facets are locally regular
} paradt__lanes;

// Fills in the vertices.
PARADT__INLINE void paradt__lanes_load(paradt__lanes *lanes, const paradt__insertion *build, size_t cell) {
    const double *centre = build->kept->centre;
    int lane, vertex, axis;
    for (lane = 0; lane < PARADT__TOGETHER; lane++) {
        const paradt_index *row = build->scene.mesh.vertices + 4 * (cell + (size_t)lane);
        const double *p = build->scene.records + 3 * (size_t)row[3];
        for (axis = 0; axis < 3; axis++) lanes->base[axis][lane] = p[axis] - centre[axis];
        for (vertex = 0; vertex < 3; vertex++) {
            const double *x = build->scene.records + 3 * (size_t)row[vertex];
            for (axis = 0; axis < 3; axis++) lanes->edge[vertex][axis][lane] = x[axis] - p[axis];
        }
    }
}

// Fills in the apexes across the facets of number i, where these are asked about: from the first of their cells.
PARADT__INLINE void paradt__lanes_across(paradt__lanes *lanes, const paradt__insertion *build, size_t cell, int i) {
    const double *centre = build->kept->centre;
    int lane, axis;
    for (lane = 0; lane < PARADT__TOGETHER; lane++) {
        paradt_index handle = (paradt_index)(4 * (cell + (size_t)lane)) + i, mirror = build->scene.mesh.links[handle];
        int asked = mirror > handle;
        const double *x = build->scene.records + 3 * (size_t)build->scene.mesh.vertices[asked ? mirror : handle];
        for (axis = 0; axis < 3; axis++) lanes->apex[axis][lane] = x[axis] - centre[axis];
        lanes->asked[lane] = asked ? 1.0 : 0.0;
    }
}

// Of some cells from `cell` on: a bit for each whose sphere tells that the cell is positively oriented and its facets
// are locally regular
PARADT__INLINE unsigned paradt__lanes_fine(const paradt__insertion *build, size_t cell) {
    const paradt__frame *frame = &build->kept->frame;
    paradt__lanes l;
    unsigned fine = 0;
    int lane, i;
    paradt__lanes_load(&l, build, cell);
    for (lane = 0; lane < PARADT__TOGETHER; lane++) {
        double edge[3][4], normal[3], constant, error;
        paradt__centred p;
        for (i = 0; i < 3; i++) {
            double x = l.edge[i][0][lane], y = l.edge[i][1][lane], z = l.edge[i][2][lane];
            edge[i][0] = x;
            edge[i][1] = y;
            edge[i][2] = z;
            edge[i][3] = x * x + y * y + z * z;
            p.s[i] = l.base[i][lane];
        }
        p.lift = p.s[0] * p.s[0] + p.s[1] * p.s[1] + p.s[2] * p.s[2];
        // (a, b, c, p) is positive when det(a - p, b - p, c - p) is negative
        paradt__sphere_make(PARADT__MAKE_QUICKLY, frame, &p, edge[1], edge[0], edge[2], normal, &constant, &error);
        for (i = 0; i < 3; i++) l.normal[i][lane] = normal[i];
        l.constant[lane] = constant;
        l.error[lane] = error;
        l.least[lane] = PARADT__NO_ERROR_BOUND * 0.5 - error;
    }
    for (i = 0; i < 4; i++) {
        paradt__lanes_across(&l, build, cell, i);
        for (lane = 0; lane < PARADT__TOGETHER; lane++) {
            double x = l.apex[0][lane], y = l.apex[1][lane], z = l.apex[2][lane];
            double power = (x * x + y * y + z * z + l.constant[lane]) +
                           (l.normal[0][lane] * x + l.normal[1][lane] * y + l.normal[2][lane] * z) - l.error[lane];
            power = l.asked[lane] > 0.5 ? power : l.least[lane];
            l.least[lane] = power < l.least[lane] ? power : l.least[lane];
        }
    }
    for (lane = 0; lane < PARADT__TOGETHER; lane++) fine |= (unsigned)(l.least[lane] > 0.0) << lane;
    return fine;
}

static unsigned paradt__fine_plain(const paradt__insertion *build, size_t cell) {
    return paradt__lanes_fine(build, cell);
}

#if defined(PARADT__KEPT_AVX2)
// Returns the vertices of a number in four cells, relative to a point each.
PARADT__AVX2 PARADT__INLINE void paradt__four_vertices(const paradt__insertion *build, const paradt_index *vertices,
                                                       const paradt_index *handles, const __m256d *point, __m256d *to) {
    const double *records = build->scene.records;
    paradt__four_differences(records + 3 * (size_t)vertices[handles[0]], records + 3 * (size_t)vertices[handles[1]],
                             records + 3 * (size_t)vertices[handles[2]], records + 3 * (size_t)vertices[handles[3]],
                             point, to);
}

PARADT__AVX2 static unsigned paradt__fine_avx2(const paradt__insertion *build, size_t cell) {
    static const paradt_index rows[4][4] = {{0, 4, 8, 12}, {1, 5, 9, 13}, {2, 6, 10, 14}, {3, 7, 11, 15}};
    const double *c = build->kept->centre;
    const paradt_index *vertices = build->scene.mesh.vertices, *links = build->scene.mesh.links + 4 * cell;
    const __m256d centre[3] = {_mm256_set1_pd(c[0]), _mm256_set1_pd(c[1]), _mm256_set1_pd(c[2])};
    const __m256d zero[3] = {_mm256_setzero_pd(), _mm256_setzero_pd(), _mm256_setzero_pd()};
    __m256d last[3], p[4], edge[3][4], sphere[4], error, least;
    int i;
    paradt__four_vertices(build, vertices + 4 * cell, rows[3], zero, last);
    for (i = 0; i < 3; i++) {
        p[i] = _mm256_sub_pd(last[i], centre[i]);
        paradt__four_vertices(build, vertices + 4 * cell, rows[i], last, edge[i]);
        edge[i][3] = paradt__dot_avx2(edge[i], edge[i]);
    }
    p[3] = paradt__dot_avx2(p, p);
    // (a, b, c, p) is positive when det(a - p, b - p, c - p) is negative
    paradt__four_spheres(0, &build->kept->frame, p, edge[1], edge[0], edge[2], sphere, &error);
    least = _mm256_set1_pd(PARADT__NO_ERROR_BOUND * 0.5);
    for (i = 0; i < 4; i++) {
        paradt_index apexes[4]; // from the first of a facet's cells; else any vertex
        __m256d x[3], power, asked;
        __m128i first = _mm_add_epi32(_mm_set1_epi32((int)(4 * cell) + i), _mm_setr_epi32(0, 4, 8, 12));
        __m128i across = _mm_setr_epi32(links[i], links[4 + i], links[8 + i], links[12 + i]);
        _mm_storeu_si128((__m128i *)(void *)apexes, _mm_max_epi32(across, first));
        asked = _mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm_cmpgt_epi32(across, first)));
        paradt__four_vertices(build, vertices, apexes, centre, x);
        power = _mm256_add_pd(paradt__dot_avx2(x, x), sphere[3]);
        power = _mm256_add_pd(power, paradt__dot_avx2(sphere, x));
        least = _mm256_blendv_pd(least, _mm256_min_pd(power, least), asked);
    }
    return (unsigned)_mm256_movemask_pd(_mm256_cmp_pd(least, error, _CMP_GT_OQ));
}
#endif

typedef unsigned (*paradt__fine)(const paradt__insertion *build, size_t cell);

static paradt__fine paradt__choose_fine(void) {
#if defined(PARADT__KEPT_AVX2)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return paradt__fine_avx2;
#endif
    return paradt__fine_plain;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>repair
//
// paradt_repair: takes the caller's triangulation over as a mesh, asks each cell and facet once whether it is still
// right, and mends what is not; or builds anew where that is not possible or does not pay. Then come the points that
// were no vertices, or are none any more: each is found to be at the place of a vertex, hidden, or is inserted.
//
// The rows are the caller's, changed in place, so that most cells are read once and written nowhere. Vertices remain
// indices: the records are in the caller's order.
// Doors: the public function.

typedef struct paradt__repair {
    paradt__mend mend;
    paradt__memory memory;
    paradt__meter meter;
    paradt__set set;
    paradt_triangulation *t;
    int facets;  // links are half-facets
    int touched; // the caller's arrays have been changed
    int renamed; // a vertex has another index now
    size_t hull, inverted;
    uint64_t hidden, duplicates;
} paradt__repair;

// Reads the points, in their order, and measures them.
static paradt_status paradt__repair_read(paradt__repair *r, const paradt_points *points) {
    paradt__source source = paradt__source_of(points);
    paradt__set *set = &r->set;
    const double part = 1.0 / (double)points->count;
    double *inner;
    size_t i;
    int axis;
    set->width = (size_t)points->dim + (points->weights != NULL);
    set->count = points->count;
    set->records = (double *)paradt__alloc_filled(&r->memory, points->count + 1, set->width * sizeof(double));
    if (!set->records) return PARADT_ERROR_MEMORY;
    inner = set->records + points->count * set->width;
    memset(inner, 0, set->width * sizeof *inner);
    paradt__space_begin(&set->space, points->dim, points->dim, points->weights != NULL);
    for (i = 0; i < points->count; i++) {
        double *record = set->records + i * set->width;
        if (i % PARADT__PACE == 0 && paradt__meter_cancels(&r->meter)) return PARADT_ERROR_CANCELLED;
        if (paradt__read_record(&source, i, record) == 2047) {
            r->t->error_point = i;
            return PARADT_ERROR_NOT_FINITE;
        }
        paradt__space_add(&set->space, record);
        for (axis = 0; axis < points->dim; axis++) inner[axis] += record[axis] * part;
    }
    paradt__space_add(&set->space, inner);
    paradt__space_end(&set->space);
    r->mend.inner = inner;
    return paradt__space_is_finite(&set->space) ? PARADT_OK : PARADT__GAVE_UP;
}

// Takes over the arrays of the triangulation.
static paradt_status paradt__repair_adopt(paradt__repair *r) {
    paradt__mesh *mesh = &r->mend.flipper.build.scene.mesh;
    paradt_triangulation *t = r->t;
    size_t row = (size_t)(t->dim + 1) * sizeof(paradt_index);
    size_t vertices = (paradt__block_bytes(t->cells) - PARADT__BLOCK_HEADER) / row;
    size_t links = (paradt__block_bytes(t->neighbors) - PARADT__BLOCK_HEADER) / row;
    paradt__mesh_begin(mesh, t->dim + 1, 1);
    mesh->capacity = vertices < links ? vertices : links;
    mesh->marks = (unsigned char *)paradt__alloc_filled(&r->memory, mesh->capacity, 1);
    if (!mesh->marks) return PARADT_ERROR_MEMORY;
    memset(mesh->marks, 0, mesh->capacity);
    r->touched = 1;
    mesh->count = mesh->paged = t->cell_count;
    mesh->vertices = t->cells;
    mesh->links = t->neighbors;
    t->cells = t->neighbors = NULL;
    return PARADT_OK;
}

// The place of a vertex in a row, of which it is one; more than any place: it is not
PARADT__INLINE int paradt__repair_place(const paradt_index *row, paradt_index vertex, int corners) {
    int i = 0;
#if PARADT__FOUR_AT_ONCE && defined(__GNUC__)
    if (corners == 4) {
        __m128i four = _mm_loadu_si128((const __m128i *)(const void *)row);
        return __builtin_ctz(
            (unsigned)_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(four, _mm_set1_epi32(vertex)))) | 1u << 8);
    }
#endif
    while (i < corners && row[i] != vertex) i++;
    return i;
}

// Makes handles of the links of a cell. Two neighbours differ in one vertex, so that the exclusive or of both rows and
// the own vertex is the other. Cells before this one have handles already. Returns 0 where links do not fit together.
PARADT__INLINE int paradt__repair_link(const paradt__mesh *mesh, size_t cell, int facets, int corners) {
    paradt_index *links = mesh->links, base = (paradt_index)cell * corners, end = (paradt_index)mesh->count, i, j;
    paradt_index own = 0;
    int fits = 1;
    for (j = 0; j < corners; j++) own ^= mesh->vertices[base + j];
    for (i = base; i < base + corners; i++) {
        paradt_index link = links[i], other = link * corners, apex = own ^ mesh->vertices[i], back;
        int place;
        if (link == PARADT__HULL) continue;
        if (facets) {
            if (link < 0 || link >= end * corners || links[link] != i) return 0;
            continue;
        }
        if (link < 0 || link >= end) return 0;
        for (j = 0; j < corners; j++) apex ^= mesh->vertices[other + j];
        place = paradt__repair_place(mesh->vertices + other, apex, corners);
        if (place >= corners) return 0;
        back = link < (paradt_index)cell ? i : (paradt_index)cell;
        fits &= links[other + place] == back;
        links[i] = other + place;
    }
    return fits;
}

// Looks at a cell: lists it if it is turned over or flat, else its facets that are not locally regular, each as the
// first of its cells sees it. Asks the predicates.
PARADT__NOINLINE paradt_status paradt__repair_ask(paradt__repair *r, size_t cell) {
    paradt__scene *scene = &r->mend.flipper.build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    paradt_index corners = mesh->corners, base = (paradt_index)cell * corners, i;
    const paradt_index *vertices = mesh->vertices + base;
    const double *p[PARADT_MAX_DIM + 2] = {NULL};
    for (i = 0; i < corners; i++) p[i] = paradt__scene_record(scene, vertices[i]);
    if (paradt__orient(&scene->space, p) <= 0) {
        mesh->marks[cell] |= PARADT__WRONG;
        r->inverted++;
        return paradt__list_append(&r->mend.facets, base, &r->memory);
    }
    for (i = 0; i < corners; i++) {
        paradt_index mirror = mesh->links[base + i];
        paradt_status status;
        if (mirror < base) continue;
        p[corners] = paradt__scene_record(scene, mesh->vertices[mirror]);
        if (!paradt__conflict(&scene->space, p)) continue;
        r->mend.stats->irregular++;
        status = paradt__list_append(&r->mend.facets, base + i, &r->memory);
        if (status) return status;
    }
    return PARADT_OK;
}

// Fetches the rows of a cell's neighbours ahead of their use: those of which the cell is the first to be looked at.
PARADT__INLINE void paradt__repair_fetch_rows(const paradt__mesh *mesh, size_t cell, int facets, int corners) {
    int i;
    if (cell >= mesh->count) return;
    for (i = 0; i < corners; i++) {
        paradt_index link = mesh->links[cell * (size_t)corners + (size_t)i];
        size_t row = (size_t)link * (facets ? 1 : (size_t)corners);
        if (link < 0) continue;
        PARADT__FETCH(mesh->links, row);
        PARADT__FETCH(mesh->vertices, row);
    }
}

// Fetches the records of a cell, and of the apexes of neighbours, ahead of their use.
PARADT__INLINE void paradt__repair_fetch_records(const paradt__insertion *build, size_t cell, int corners) {
    const paradt__mesh *mesh = &build->scene.mesh;
    paradt_index base = (paradt_index)cell * corners, i;
    for (i = base; i < base + corners; i++) {
        paradt_index mirror = mesh->links[i] > i ? mesh->links[i] : i; // no branch, which could not be predicted
        PARADT__FETCH(build->scene.records, (size_t)mesh->vertices[i] * build->scene.width);
        PARADT__FETCH(build->scene.records, (size_t)mesh->vertices[mirror] * build->scene.width);
    }
}

// Passes over all cells: links become handles, and what is not right is listed. Rows are fetched first, then the cells
// are linked, for which the neighbours' rows are needed, and their records fetched, then the cells are looked at.
PARADT__INLINE paradt_status paradt__repair_survey_any(paradt__repair *r, int corners, int spheres) {
    enum { PACE = 1 << 14, ROWS_AHEAD = 24, LINKED_AHEAD = 12 };
    const paradt__insertion *build = &r->mend.flipper.build;
    const paradt__mesh mesh = build->scene.mesh;
    const paradt__fine fine = paradt__choose_fine();
    paradt_status status = PARADT_OK;
    size_t cell, linked = 0;
    unsigned known = 0; // of this and the next cells: they are fine
    int i;
    for (cell = 0; cell < mesh.count && !status; cell++, known >>= 1) {
        const paradt_index *links = mesh.links + cell * (size_t)corners;
        if (cell % PACE == 0 && paradt__meter_cancels(&r->meter)) return PARADT_ERROR_CANCELLED;
        for (; linked < mesh.count && linked <= cell + LINKED_AHEAD; linked++) {
            paradt__repair_fetch_rows(&mesh, linked + ROWS_AHEAD, r->facets, corners);
            if (!paradt__vertices_among(mesh.vertices + linked * (size_t)corners, corners, 0,
                                        (paradt_index)r->set.count) ||
                !paradt__repair_link(&mesh, linked, r->facets, corners))
                return PARADT_ERROR_INVALID;
            paradt__repair_fetch_records(build, linked, corners);
        }
        for (i = 0; i < corners; i++) r->hull += links[i] < 0;
        if (spheres && cell % PARADT__TOGETHER == 0)
            known = cell + PARADT__TOGETHER <= mesh.count ? fine(build, cell) : 0;
        if (!(known & 1)) status = paradt__repair_ask(r, cell);
    }
    return status;
}

PARADT__HOT_LOOP paradt_status paradt__repair_survey(paradt__repair *r) {
    int corners = r->mend.flipper.build.scene.mesh.corners;
    if (PARADT_MAX_DIM >= 3 && r->mend.flipper.build.kept) return paradt__repair_survey_any(r, 4, 1);
    return paradt__repair_survey_any(r, corners, 0);
}

// Makes the ghosts, and lists their facets.
static paradt_status paradt__repair_ghosts(paradt__repair *r) {
    paradt__mesh *mesh = &r->mend.flipper.build.scene.mesh;
    const int corners = mesh->corners;
    paradt_index end = (paradt_index)mesh->count * corners, handle, base;
    int i;
    paradt__facets ridges;
    paradt_status status =
        paradt__insertion_reserve(&r->mend.flipper.build, mesh->count + r->hull, mesh->count + r->hull);
    if (status) return status;
    status = paradt__facets_begin(&ridges, 0, 1, &r->memory);
    for (handle = 0; handle < end && !status; handle++) {
        paradt_index first = handle - handle % corners;
        const int place = (int)(handle % corners);
        if (mesh->links[handle] >= 0) continue;
        base = (paradt_index)mesh->count++ * corners;
        for (i = 0; i < corners; i++) // 0 and 1 are exchanged, as the ghost sees the facet from outside
            mesh->vertices[base + (i < 2 ? 1 - i : i)] =
                i == place ? (paradt_index)PARADT__INFINITE : mesh->vertices[first + i];
        paradt__mesh_tie(mesh, handle, base + (place < 2 ? 1 - place : place));
        if (paradt__side(&r->mend.flipper.build.scene, base / corners, place < 2 ? 1 - place : place, r->mend.inner) >=
            0)
            mesh->marks[base / corners] |= PARADT__WRONG;
        status = paradt__facets_room(&ridges, (size_t)corners, &r->memory);
        for (i = 0; i < corners && !status; i++) {
            if (mesh->vertices[base + i] == PARADT__INFINITE) continue;
            paradt__facets_tie(&ridges, mesh, paradt__facet_key_of(&ridges, mesh, base + i), base + i, corners);
            status = paradt__list_append(&r->mend.facets, base + i, &r->memory);
        }
    }
    if (!status && ridges.count) status = PARADT_ERROR_INVALID;
    mesh->paged = mesh->count;
    paradt__facets_free(&ridges, &r->memory);
    return status;
}

// --- points that are no vertices

// Finds out what a point is that is no vertex.
static paradt_status paradt__repair_point(paradt__repair *r, paradt_index point) {
    paradt__insertion *build = &r->mend.flipper.build;
    paradt__scene *scene = &build->scene;
    paradt_index *representative = r->t->representative, vertex;
    const double *x = paradt__scene_record(scene, point);
    paradt_status status;
    scene->hint = paradt__walk(scene, scene->hint, x);
    vertex = paradt__vertex_at(scene, scene->hint, point);
    representative[point] = point;
    if (vertex != PARADT__NOWHERE) {
        size_t weight = r->set.width - 1;
        const double *other = paradt__scene_record(scene, vertex);
        if (scene->space.weighted && (x[weight] > other[weight] || (x[weight] == other[weight] && point < vertex)))
            return PARADT__GAVE_UP;
        while (representative[vertex] != vertex) vertex = representative[vertex];
        if (point < vertex && !scene->space.weighted) {
            representative[vertex] = point;
            r->renamed = 1;
        } else {
            representative[point] = vertex;
        }
        return PARADT_OK;
    }
    if (scene->space.weighted && !paradt__conflicts(scene, scene->hint, x)) return PARADT_OK; // hidden
    status = paradt__insert(build, point);
    build->inserted++;
    r->mend.stats->reinserted++;
    return status;
}

// Were all points vertices before?
static int paradt__repair_all_are_vertices(const paradt__repair *r) {
    size_t i = 0;
    while (i < r->set.count && r->t->representative[i] == (paradt_index)i) i++;
    return i == r->set.count;
}

// Finds which points are vertices. used: [points / 64 + 1] a bit for each
static void paradt__repair_vertices(const paradt__repair *r, uint64_t *used) {
    const paradt__mesh *mesh = &r->mend.flipper.build.scene.mesh;
    size_t corners = (size_t)mesh->corners, i, j;
    memset(used, 0, (r->set.count / 64 + 1) * sizeof *used);
    for (i = 0; i < mesh->count; i++) {
        const paradt_index *row = mesh->vertices + i * corners;
        for (j = 0; j < corners && row[0] != PARADT__DEAD; j++) {
            if (row[j] >= 0) used[row[j] / 64] |= (uint64_t)1 << row[j] % 64;
        }
    }
}

// Lets hidden points find the points at their places that have become vertices after them.
static void paradt__repair_rejoin(paradt__repair *r, const uint64_t *used) {
    paradt__scene *scene = &r->mend.flipper.build.scene;
    paradt_index *representative = r->t->representative, i, vertex;
    for (i = 0; (size_t)i < r->set.count; i++) {
        if (used[i / 64] >> i % 64 & 1 || representative[i] != i) continue;
        scene->hint = paradt__walk(scene, scene->hint, paradt__scene_record(scene, i));
        vertex = paradt__vertex_at(scene, scene->hint, i);
        if (vertex != PARADT__NOWHERE) representative[i] = vertex;
    }
}

// Deals with all points that are no vertices, in their order.
static paradt_status paradt__repair_others(paradt__repair *r, uint64_t *used) {
    paradt__scene *scene = &r->mend.flipper.build.scene;
    paradt_index *representative = r->t->representative;
    size_t i, others = 0, most = r->set.count / 4 + 64;
    uint64_t inserted = r->mend.stats->reinserted;
    paradt_status status = PARADT_OK;
    paradt__repair_vertices(r, used);
    for (i = 0; i < r->set.count; i++) others += !(used[i / 64] >> i % 64 & 1);
    if (!others) return PARADT_OK;
    if (others > most) return PARADT__GAVE_UP;
    scene->hint = 0;
    while (scene->mesh.vertices[scene->hint * scene->mesh.corners] == PARADT__DEAD) scene->hint++;
    for (i = 0; i < r->set.count; i++) representative[i] = (paradt_index)i;
    for (i = 0; i < r->set.count && !status; i++) {
        if (used[i / 64] >> i % 64 & 1) continue;
        status = paradt__repair_point(r, (paradt_index)i);
        if (!status && i % 64 == 0 && paradt__meter_cancels(&r->meter)) status = PARADT_ERROR_CANCELLED;
    }
    if (status || !scene->space.weighted || inserted == r->mend.stats->reinserted) return status;
    paradt__repair_vertices(r, used);
    paradt__repair_rejoin(r, used);
    return PARADT_OK;
}

// Gives vertices their new indices, and points that are neither vertices nor at the place of one the representative -1.
// Counts these.
static void paradt__repair_settle(paradt__repair *r, uint64_t *used) {
    paradt__mesh *mesh = &r->mend.flipper.build.scene.mesh;
    paradt_index *representative = r->t->representative, at;
    size_t i;
    for (i = 0; i < r->set.count; i++) {
        for (at = (paradt_index)i; representative[at] != at;) at = representative[at];
        representative[i] = at;
    }
    for (i = 0; i < mesh->count * (size_t)mesh->corners && r->renamed; i++) {
        if (mesh->vertices[i] >= 0) mesh->vertices[i] = representative[mesh->vertices[i]];
    }
    paradt__repair_vertices(r, used);
    for (i = 0; i < r->set.count; i++) {
        at = representative[i];
        if (!(used[at / 64] >> at % 64 & 1)) r->hidden++;
        else r->duplicates += at != (paradt_index)i;
    }
    for (i = 0; i < r->set.count; i++) {
        at = representative[i];
        if (!(used[at / 64] >> at % 64 & 1)) representative[i] = -1;
    }
}

// Finds out how many of the hidden points are at the place of another, which makes them duplicates.
static paradt_status paradt__repair_places(paradt__repair *r) {
    size_t ambient = (size_t)r->set.space.ambient, mask = 1, i, at;
    paradt_index *table;
    uint64_t repeated = 0;
    if (r->hidden < 2) return PARADT_OK;
    while (mask < 2 * r->hidden) mask *= 2;
    table = (paradt_index *)paradt__alloc(&r->memory, mask, sizeof *table);
    if (!table) return PARADT_ERROR_MEMORY;
    for (i = 0; i < mask; i++) table[i] = PARADT__OPEN;
    for (i = 0; i < r->set.count; i++) {
        const double *x = r->set.records + i * r->set.width;
        if (r->t->representative[i] >= 0) continue;
        at = (size_t)paradt__hash_coordinates(x, r->set.space.ambient) & (mask - 1);
        while (table[at] >= 0 && memcmp(r->set.records + (size_t)table[at] * r->set.width, x, ambient * sizeof *x) != 0)
            at = (at + 1) & (mask - 1);
        repeated += table[at] >= 0;
        table[at] = (paradt_index)i;
    }
    paradt__release(&r->memory, table);
    r->hidden -= repeated;
    r->duplicates += repeated;
    return PARADT_OK;
}

// --- the whole

// Returns why the triangulation can't be repaired, but only be built anew, or NULL. Then nothing is wrong with it.
static int paradt__repair_pays(const paradt_triangulation *t, const paradt_points *points) {
    return t->dim == points->dim && t->cell_count && t->neighbors && t->cells;
}

// Prepares mending: the insertion that the flips are done in.
static paradt_status paradt__repair_begin(paradt__repair *r) {
    paradt__insertion *build = &r->mend.flipper.build;
    paradt_status status;
    r->mend.meter = &r->meter;
    build->memory = &r->memory;
    build->scene.space = r->set.space;
    build->scene.records = r->set.records;
    build->scene.width = r->set.width;
    status = paradt__repair_adopt(r);
    if (status) return status;
    build->count = build->inserted = 8; // few: no more is kept of spheres than what they are made with
    if (r->t->dim == 3) status = paradt__kept_begin(build);
    build->count = build->inserted = r->set.count;
    r->mend.most_flips = 2 * r->t->cell_count + 1000;
    return status ? status
                  : paradt__list_room(&build->update.killed, 0, &build->update.killed_capacity, 64, &r->memory);
}

// Through how many hull facets does the ray from the inner point through a vertex leave? -1: through the border of one
static int paradt__repair_exits(paradt__repair *r, paradt_index vertex) {
    paradt__scene *scene = &r->mend.flipper.build.scene;
    const paradt__mesh *mesh = &scene->mesh;
    const double *p[PARADT_MAX_DIM + 1], *x = paradt__scene_record(scene, vertex);
    int corners = mesh->corners, exits = 0, ghost, i;
    size_t cell;
    for (cell = 0; cell < mesh->count; cell++) {
        const paradt_index *row = mesh->vertices + cell * (size_t)corners;
        int beyond = 0, on = 0;
        if (PARADT__LIKELY(paradt__is_finite_cell(row, corners)) || row[0] == PARADT__DEAD) continue;
        ghost = paradt__ghost_place(row, corners);
        for (i = 0; i < corners; i++) p[i] = i == ghost ? r->mend.inner : paradt__scene_record(scene, row[i]);
        for (i = 0; i < corners && !beyond; i++) {
            const double *corner = p[i];
            int side;
            if (i == ghost) continue;
            p[i] = x;
            side = paradt__orient(&scene->space, p); // negative: that of the facet with the inner point
            p[i] = corner;
            beyond |= side > 0;
            on |= side == 0;
        }
        if (!beyond && on) return -1;
        exits += !beyond;
    }
    return exits;
}

// Does the hull surround the inner point once? With all else that mending has established the mesh is T(P) then. In the
// beginning that was so, and flips and holes do not change it; but large moves may have drawn the hull over the point.
static int paradt__repair_surrounds(paradt__repair *r) {
    enum { TRIES = 8 };
    const paradt__mesh *mesh = &r->mend.flipper.build.scene.mesh;
    size_t corners = (size_t)mesh->corners, attempt, cell;
    for (attempt = 0; attempt < TRIES; attempt++) {
        for (cell = mesh->count / TRIES * attempt; cell < mesh->count; cell++) {
            int exits;
            if (!paradt__is_finite_cell(mesh->vertices + cell * corners, mesh->corners)) continue;
            exits = paradt__repair_exits(r, mesh->vertices[cell * corners + attempt % corners]);
            if (exits >= 0) return exits == 1;
            break;
        }
    }
    return 0;
}

// Mends the triangulation.
static paradt_status paradt__repair_mend(paradt__repair *r) {
    paradt_repair_stats *stats = r->mend.stats;
    const paradt__mesh *mesh = &r->mend.flipper.build.scene.mesh;
    uint64_t *used = NULL;
    size_t cells = r->t->cell_count;
    paradt_status status = paradt__repair_begin(r);
    if (!status) status = paradt__repair_survey(r);
    stats->inverted = r->inverted;
    if (!status && (r->inverted > cells / 8 + 8 || stats->irregular > cells / 2 + 64)) status = PARADT__GAVE_UP;
    if (!status) status = paradt__repair_ghosts(r);
    if (!status) PARADT__VERIFY(mesh, 1, PARADT__CONFLICT);
    (void)mesh;
    if (!status) status = paradt__mend_flip_all(&r->mend);
    if (!status) status = paradt__mend_fill_all(&r->mend, &r->set);
    if (status) return status;
    if (!paradt__repair_surrounds(r)) return PARADT__GAVE_UP;
#if defined(PARADT_VERIFY)
    PARADT_ASSERT(paradt__mend_is_done(&r->mend));
#endif
    if (!r->mend.vanished && paradt__repair_all_are_vertices(r)) return PARADT_OK;
    used = (uint64_t *)paradt__alloc(&r->memory, r->set.count / 64 + 1, sizeof *used);
    if (!used) return PARADT_ERROR_MEMORY;
    status = paradt__repair_others(r, used);
#if defined(PARADT_VERIFY)
    PARADT_ASSERT(status || paradt__mend_is_done(&r->mend));
#endif
    if (!status) paradt__repair_settle(r, used);
    paradt__release(&r->memory, used);
    return status ? status : paradt__repair_places(r);
}

// Hands the mesh back.
static paradt_status paradt__repair_hand_back(paradt__repair *r) {
    paradt__mesh *mesh = &r->mend.flipper.build.scene.mesh;
    paradt_triangulation *t = r->t;
    paradt_stats *stats = &t->stats;
    PARADT__VERIFY(mesh, 1, PARADT__CONFLICT);
    memset(stats, 0, sizeof *stats);
    stats->hull_facets = paradt__mesh_close(mesh, NULL, r->facets, &r->meter);
    if (paradt__meter_cancels(&r->meter)) return PARADT_ERROR_CANCELLED;
    paradt__mesh_rest(mesh, &r->memory);
    t->cells = mesh->vertices;
    t->neighbors = mesh->links;
    t->cell_count = stats->cells = mesh->count;
    mesh->vertices = mesh->links = NULL;
    stats->duplicates = r->duplicates;
    stats->hidden = r->hidden;
    stats->regions = 1;
    paradt__count_predicates(stats, &r->mend.flipper.build.scene.space.counters);
    return PARADT_OK;
}

// Builds the triangulation anew. The old one stays where that fails, if it is still there.
static paradt_status paradt__repair_anew(paradt_triangulation *t, const paradt_points *points,
                                         const paradt_options *options, paradt_repair_stats *stats) {
    paradt_triangulation fresh;
    paradt_status status = paradt_triangulate(&fresh, points, options);
    stats->rebuilt = 1;
    if (status) {
        t->error_point = fresh.error_point;
        t->error_text = fresh.error_text;
        return status;
    }
    paradt_free(t);
    *t = fresh;
    return PARADT_OK;
}

// Repairs in place. *touched: after an error the triangulation is empty
static paradt_status paradt__repair_in_place(paradt_triangulation *t, const paradt_points *points,
                                             const paradt_options *options, paradt_repair_stats *stats, int *touched) {
    paradt__repair r;
    paradt_status status;
    memset(&r, 0, sizeof r);
    paradt__memory_begin(&r.memory, options);
    paradt__meter_begin(&r.meter, options);
    r.memory.held =
        paradt__block_bytes(t->cells) + paradt__block_bytes(t->neighbors) + paradt__block_bytes(t->representative);
    r.memory.peak = r.memory.held;
    r.t = t;
    r.mend.stats = stats;
    r.facets = (options->flags & PARADT_FACETS) != 0;
    status = paradt__repair_read(&r, points);
    if (!status) status = paradt__repair_mend(&r);
    r.meter.done = PARADT__ALL_DONE;
    if (!status) status = paradt__repair_hand_back(&r);
    if (r.mend.flipper.build.memory) {
        paradt__mend_end(&r.mend);
        paradt__mesh_free(&r.mend.flipper.build.scene.mesh, &r.memory);
    }
    paradt__set_free(&r.set, &r.memory);
    t->stats.peak_bytes = r.memory.peak;
    t->stats.needed_bytes = status == PARADT_ERROR_MEMORY ? r.memory.needed : 0;
    *touched = r.touched;
    return status;
}

PARADT_DEF paradt_status paradt_repair(paradt_triangulation *t, const paradt_points *points,
                                       const paradt_options *options, paradt_repair_stats *stats) {
    paradt_options given;
    paradt_repair_stats own;
    paradt_status status = PARADT_ERROR_ARGUMENT;
    const char *text = "the triangulation has another number of points";
    double begun = paradt__now();
    int touched = 0;
    if (!stats) stats = &own;
    memset(stats, 0, sizeof *stats);
    if (!t) return status;
    memset(&given, 0, sizeof given);
    if (options) given = *options;
    given.allocator = t->allocator;
    t->error_point = 0;
    if (!points || points->count == t->point_count) status = paradt__check_arguments(points, &given, &text);
    if (!status && given.flags & PARADT_NO_NEIGHBORS) {
        status = PARADT_ERROR_ARGUMENT;
        text = "options.flags has PARADT_NO_NEIGHBORS, but paradt_repair takes and gives neighbours";
    }
    t->error_text = text;
    if (status) return status;
    status = PARADT__GAVE_UP;
    if (paradt__repair_pays(t, points)) status = paradt__repair_in_place(t, points, &given, stats, &touched);
    if (touched && status) {
        uint64_t needed = t->stats.needed_bytes, peak = t->stats.peak_bytes;
        paradt__withdraw(t, status, points->dim);
        t->allocator = given.allocator;
        t->point_count = points->count;
        t->stats.needed_bytes = needed;
        t->stats.peak_bytes = peak;
    }
    if (status == PARADT__GAVE_UP) status = paradt__repair_anew(t, points, &given, stats);
    else if (status) t->error_text = paradt_status_string(status);
    stats->seconds = paradt__now() - begun;
    if (!status) t->stats.seconds = stats->seconds;
    return status;
}
#endif // PARADT_NO_FLIPS

#ifndef PARADT_NO_CHECK
// ---------------------------------------------------------------------------------------------------------------------
// >>check
//
// The certificate: whatever the arrays of a triangulation hold, paradt_check accepts exactly those that are T(P). It
// shares only the reading of points, the predicates and the memory account with the methods, and builds nothing that it
// could get wrong in the same way. It takes linear time (expected: there is hashing, and hidden points are found by
// short walks). Program checking for geometry in this spirit: Mehlhorn, Naeher, Schilz, Schirra, Seel, Seidel and
// Uhrig, "Checking geometric programs or verification of geometric structures", Computational Geometry 12, 1999;
// Devillers, Liotta, Preparata and Tamassia, "Checking the convexity of polytopes and the planarity of subdivisions",
// Computational Geometry 11, 1998.
//
// What is tested, all of it in exact signs. k is the affine dimension, determined anew; o is a place infinitesimally
// near the lexicographically smallest vertex, inside one of its cells.
//   (1) points of equal coordinates have the same representative, the right one, or all are hidden; each
//       representative is a vertex, each vertex is its own representative;
//   (2) each cell is positively oriented;
//   (3) adjacency is an involution on the facets of cells, two neighbours have all vertices but one in common, and
//   their
//       other vertices lie on opposite sides of the facet (given (2), that is the parity of a permutation);
//   (4) for each facet with two cells, the vertex opposite in one cell is not in conflict with the other cell;
//   (5) each hull facet (one with a single cell) has o strictly on the side of its cell;
//   (6) at each ridge of the hull, where turning around it through the cells leads from one hull facet to another,
//       neither facet has its remaining vertex beyond the hyperplane of the other;
//   (7) only one cell contains o;
//   (8) each hidden point lies in a cell that it is not in conflict with.
//
// Why this proves T(P). Choose the infinitesimals of o and of the perturbation as real numbers so small that all the
// finitely many signs stay as they are. "Generic" means off the hyperplanes of all facets.
//   The cells near a facet. Let n(x) be the number of cells that contain a generic x. By (2) and (3) n does not change
// across a facet of two cells: one cell is left, one entered. Across a hull facet, outward, it falls by one.
//   The hull is star-shaped. Facets of the hull are paired at ridges: turning around a ridge is an injective map of
//   flags
// by (3), so it never runs in circles and ends at another hull facet, which by (2) and (3) has the opposite orientation
// at the ridge. By (5), when projected from o to the sphere, neighbouring facets lie on opposite sides of their ridge.
// So the projection covers the sphere equally often everywhere, and any generic ray from o crosses the hull n(o) times,
// each time outward. By (7) that is once. So the hull is the boundary of one body Q, star-shaped about o, with n = 1
// inside and n = 0 outside.
//   The hull is convex. A section of Q by a generic plane through o is a star-shaped polygon, convex at each corner by
// (6), and therefore convex; so Q is convex. Q contains all of P: vertices and duplicates by (1), hidden points by (8).
// So Q = conv(P), and the cells tile it.
//   The cells are Delaunay. Let g be the function on Q that is affine on each cell and takes the lifted heights at the
// vertices. Along any generic segment g is continuous, as neighbours share the vertices of a facet, and strictly convex
// at each facet crossed, by (4). So the plane of any cell lies below g on all of Q, and hence below each lifted vertex.
// It lies below each lifted hidden point by (8), as the plane of the cell under such a point decides whether it is in
// conflict. With perturbed heights "below" is strict except at the vertices of the cell: each cell is a facet of the
// lower hull of P. Together they tile conv(P), so none is missing; n = 1, so none is there twice.
//   Conversely T(P) passes: each of (1) to (8) holds for the lower hull. (For (5): the interior of Q contains o.
//   Nothing
// else is needed: a second component would have its own hull around o, and n(o) would be 2.)
//
// This section has the conditions (1) to (4), which look at points, cells and facets one by one; >>check of the hull
// has the others. Doors: paradt__check_fail, paradt__check_pace, paradt__check_neighbor, paradt__check_cell,
// paradt__check_gather, paradt__check_side, paradt__check_across, paradt__check_read, paradt__check_dimension,
// paradt__check_representatives, paradt__check_cells, paradt__check_adjacency, paradt__check_facets.

enum { PARADT__CHECK_PACE = 4096 }; // elements between two calls of the progress callback, which take some milliseconds

// The phases of the check in their order: name, part of the work that is done when the phase begins
#define PARADT__CHECK_PHASES(X)                                                                                        \
    X(READ, 0.0)                                                                                                       \
    X(LEAD, 0.02)                                                                                                      \
    X(REPRESENT, 0.04)                                                                                                 \
    X(CELLS, 0.06)                                                                                                     \
    X(MATCH, 0.2)                                                                                                      \
    X(FACETS, 0.35)                                                                                                    \
    X(HULL, 0.8)                                                                                                       \
    X(HIDDEN, 0.9)

typedef enum paradt__check_phase {
#define PARADT__CHECK_NAME(name, begin) PARADT__CHECK_##name,
    PARADT__CHECK_PHASES(PARADT__CHECK_NAME)
#undef PARADT__CHECK_NAME
        PARADT__CHECK_END
} paradt__check_phase;

typedef struct paradt__check {
    const paradt_triangulation *t;
    const paradt_options *options; // may be NULL
    paradt_fault *fault;
    paradt__memory memory;
    paradt__set set;               // the records of all points, by the caller's index
    size_t corners;                // vertices of a cell: dim + 1
    const paradt_index *neighbors; // t->neighbors or `matched`
    int halves;                    // 1: neighbors are half-facets
    paradt_index *matched;         // [cell_count][corners] the neighbours found here, or NULL
    paradt_index *cell_of;         // [point_count] a cell of each vertex; -1: not a vertex
    // o is the first of these vertices, moved towards the second, by infinitely less towards the third, and so on.
    const double *origin[PARADT_MAX_DIM + 1];
    paradt__check_phase phase;
} paradt__check;

// Says what is wrong. cell, point: an index, or -1
static paradt_status paradt__check_fail(paradt__check *check, const char *reason, paradt_index cell,
                                        paradt_index point) {
    check->fault->reason = reason;
    check->fault->cell = cell;
    check->fault->point = point;
    return PARADT_ERROR_INVALID;
}

// Tells the progress callback that `done` of the phase's elements are done; to be called for each of them.
static paradt_status paradt__check_pace(const paradt__check *check, size_t done, size_t all) {
#define PARADT__CHECK_BEGIN(name, begin) begin,
    static const double begins[] = {PARADT__CHECK_PHASES(PARADT__CHECK_BEGIN) 1.0, 1.0};
#undef PARADT__CHECK_BEGIN
    const paradt_options *options = check->options;
    double fraction = begins[check->phase];
    PARADT_ASSERT(done <= all);
    if (done % PARADT__CHECK_PACE || !options || !options->progress) return PARADT_OK;
    fraction += (begins[check->phase + 1] - fraction) * (double)done / (double)all;
    return options->progress(options->user, fraction) ? PARADT_ERROR_CANCELLED : PARADT_OK;
}

// Returns the cell across a facet, whose number is cell * corners + corner; -1: none.
PARADT__INLINE paradt_index paradt__check_neighbor(const paradt__check *check, size_t facet) {
    paradt_index neighbor = check->neighbors[facet];
    return check->halves && neighbor >= 0 ? (paradt_index)((size_t)neighbor / check->corners) : neighbor;
}

PARADT__INLINE const paradt_index *paradt__check_cell(const paradt__check *check, size_t cell) {
    return check->t->cells + cell * check->corners;
}

// Fills corners with the coordinates of the cell's vertices.
static void paradt__check_gather(const paradt__check *check, size_t cell, const double **corners) {
    const paradt_index *vertices = paradt__check_cell(check, cell);
    size_t i;
    for (i = 0; i < check->corners; i++) corners[i] = paradt__record(&check->set, vertices[i]);
}

// Returns the orientation of a cell. In dimension 0 a cell is a point, and the empty determinant is 1.
static int paradt__check_orient(paradt__check *check, const double *const *corners) {
    return check->set.space.dim == 0 ? 1 : paradt__orient(&check->set.space, corners);
}

// Returns on which side of the facet opposite `corner` the point x lies: 1 on the side of the cell, 0 on its
// hyperplane, -1 beyond it. corners: the cell's; they come back as they were.
static int paradt__check_side(paradt__check *check, const double **corners, size_t corner, const double *x) {
    const double *own = corners[corner];
    int side;
    size_t i;
    PARADT_ASSERT(corner < check->corners);
    if (x == own) return 1;
    for (i = 0; i < check->corners; i++)
        if (x == corners[i]) return 0;
    corners[corner] = x;
    side = paradt__check_orient(check, corners);
    corners[corner] = own;
    return side;
}

// --- points: condition (1) up to "is a vertex"

// Sets the dimension in which the predicates work, and their error bounds.
static void paradt__check_set_dim(paradt__check *check, int dim) {
    check->set.space.dim = dim;
    if (dim > 0) paradt__space_end(&check->set.space);
}

// Measures all records anew, as the order of their coordinates has changed, and sets the dimension.
static void paradt__check_measure(paradt__check *check, int dim) {
    paradt__space *space = &check->set.space;
    size_t i;
    paradt__space_begin(space, dim, space->ambient, space->weighted);
    for (i = 0; i < check->set.count; i++) paradt__space_add(space, check->set.records + i * check->set.width);
    paradt__check_set_dim(check, dim);
}

// Reads the points.
static paradt_status paradt__check_read(paradt__check *check, const paradt_points *points) {
    paradt__source source = paradt__source_of(points);
    paradt__set *set = &check->set;
    set->width = (size_t)points->dim + (points->weights != NULL);
    set->records = (double *)paradt__alloc(&check->memory, points->count, set->width * sizeof(double));
    paradt__space_begin(&set->space, points->dim, points->dim, points->weights != NULL);
    if (!set->records) return PARADT_ERROR_MEMORY;
    for (; set->count < points->count; set->count++) {
        paradt_status status = paradt__check_pace(check, set->count, points->count);
        int exponent = paradt__read_record(&source, set->count, set->records + set->count * set->width);
        if (exponent > set->exponent) set->exponent = exponent;
        if (status) return status;
        if (exponent < 2047) continue;
        paradt__check_fail(check, "a coordinate or weight is NaN or infinite", -1, (paradt_index)set->count);
        return PARADT_ERROR_NOT_FINITE;
    }
    paradt__set_scale(set);
    paradt__check_measure(check, points->dim);
    return PARADT_OK;
}

// Moves the coordinate at place `axis` of all records to the end of the coordinates. `axis` axes are taken so far.
static void paradt__check_pass_over(paradt__check *check, int axis) {
    size_t i, after = (size_t)(check->set.space.ambient - axis - 1);
    for (i = 0; i < check->set.count; i++) {
        double *record = check->set.records + i * check->set.width + axis, coordinate = *record;
        memmove(record, record + 1, after * sizeof(double));
        record[after] = coordinate;
    }
    paradt__check_measure(check, axis);
}

// Determines the affine dimension. Axes are taken from the first to the last: each one that raises the dimension of the
// projection to the axes taken, which one point off the flat of the basis shows. An axis that is passed over is an
// affine function of those taken, for then all points are exactly in that flat. In the end the records begin with the
// axes taken.
static paradt_status paradt__check_dimension(paradt__check *check) {
    const double *basis[PARADT_MAX_DIM + 1];
    int axis, taken = 0, ambient = check->set.space.ambient;
    size_t i, n = check->set.count;
    if (n) basis[0] = check->set.records;
    for (axis = 0; n && axis < ambient; axis++) {
        paradt__check_set_dim(check, taken + 1);
        for (i = 1; i < n; i++) {
            basis[taken + 1] = paradt__record(&check->set, (paradt_index)i);
            if (paradt__orient(&check->set.space, basis)) break;
        }
        if (i < n) taken++;
        else paradt__check_pass_over(check, taken);
    }
    if (!n) taken = -1;
    if (check->t->dim != taken)
        return paradt__check_fail(check, "dim is not the affine dimension of the points", -1, -1);
    paradt__check_set_dim(check, taken);
    check->corners = (size_t)(taken + 1);
    return PARADT_OK;
}

// Returns the slot of the table that holds the record's coordinates, or the empty slot where they belong.
static size_t paradt__check_place(const paradt__check *check, const paradt_index *table, size_t slots,
                                  const double *record) {
    int ambient = check->set.space.ambient;
    size_t slot = (size_t)paradt__hash_coordinates(record, ambient) & (slots - 1);
    PARADT_ASSERT(slots > check->set.count && !(slots & (slots - 1)));
    while (table[slot] >= 0 &&
           memcmp(paradt__record(&check->set, table[slot]), record, (size_t)ambient * sizeof(double)))
        slot = (slot + 1) & (slots - 1);
    return slot;
}

// Fills the table with the point that has to stand for each place: the heaviest, among these the first.
static paradt_status paradt__check_lead(const paradt__check *check, paradt_index *table, size_t slots) {
    const paradt__space *space = &check->set.space;
    paradt_status status = PARADT_OK;
    size_t i;
    for (i = 0; i < check->set.count && !status; i++) {
        const double *record = paradt__record(&check->set, (paradt_index)i);
        paradt_index *leader = table + paradt__check_place(check, table, slots, record);
        if (*leader < 0 ||
            (space->weighted && paradt__ordered_bits(record[space->ambient]) >
                                    paradt__ordered_bits(paradt__record(&check->set, *leader)[space->ambient])))
            *leader = (paradt_index)i;
        status = paradt__check_pace(check, i, check->set.count);
    }
    return status;
}

// Compares representatives with the points that have to stand for their places.
static paradt_status paradt__check_against_leaders(paradt__check *check, const paradt_index *table, size_t slots) {
    const paradt_index *representative = check->t->representative;
    paradt_status status = PARADT_OK;
    size_t i;
    for (i = 0; i < check->set.count && !status; i++) {
        paradt_index point = (paradt_index)i, stands = representative[i], leader;
        leader = table[paradt__check_place(check, table, slots, paradt__record(&check->set, point))];
        if ((stands < 0) != (representative[leader] < 0))
            return paradt__check_fail(check, "of points with equal coordinates some are called hidden, some not", -1,
                                      point);
        if (stands >= 0 && stands != leader)
            return paradt__check_fail(
                check, "the representative is not the first of the heaviest with these coordinates", -1, point);
        status = paradt__check_pace(check, i, check->set.count);
    }
    return status;
}

// Condition (1), but for whether representatives are vertices.
static paradt_status paradt__check_representatives(paradt__check *check) {
    paradt_status status;
    paradt_index *table;
    size_t slots = 16, i;
    for (i = 0; i < check->set.count; i++) {
        paradt_index stands = check->t->representative[i];
        if (stands < -1 || stands >= (paradt_index)check->set.count)
            return paradt__check_fail(check, "a representative is no point", -1, (paradt_index)i);
        if (stands < 0 && !check->set.space.weighted)
            return paradt__check_fail(check, "a point is called hidden without weights", -1, (paradt_index)i);
    }
    while (slots < check->set.count * 2) slots *= 2;
    table = (paradt_index *)paradt__alloc(&check->memory, slots, sizeof *table);
    if (!table) return PARADT_ERROR_MEMORY;
    memset(table, 0xff, slots * sizeof *table);
    check->phase = PARADT__CHECK_LEAD;
    status = paradt__check_lead(check, table, slots);
    check->phase = PARADT__CHECK_REPRESENT;
    if (!status) status = paradt__check_against_leaders(check, table, slots);
    paradt__release(&check->memory, table);
    return status;
}

// --- cells: condition (2), the rest of (1)

// Checks that the cell's vertices are distinct representatives, and notes the cell for each of them.
static paradt_status paradt__check_vertices(paradt__check *check, size_t cell) {
    const paradt_index *vertices = paradt__check_cell(check, cell);
    size_t i, j;
    for (i = 0; i < check->corners; i++) {
        paradt_index v = vertices[i];
        if (v < 0 || v >= (paradt_index)check->set.count)
            return paradt__check_fail(check, "a vertex is no point", (paradt_index)cell, -1);
        if (check->t->representative[v] < 0)
            return paradt__check_fail(check, "a vertex is called hidden", (paradt_index)cell, v);
        if (check->t->representative[v] != v)
            return paradt__check_fail(check, "a vertex is represented by another point", (paradt_index)cell, v);
        for (j = 0; j < i; j++)
            if (vertices[j] == v) return paradt__check_fail(check, "a cell has a vertex twice", (paradt_index)cell, v);
        check->cell_of[v] = (paradt_index)cell;
    }
    return PARADT_OK;
}

// Condition (2), and the rest of (1).
static paradt_status paradt__check_cells(paradt__check *check) {
    const double *corners[PARADT_MAX_DIM + 1];
    size_t i, cell_count = check->t->cell_count;
    check->cell_of = (paradt_index *)paradt__alloc(&check->memory, check->set.count, sizeof(paradt_index));
    if (!check->cell_of) return PARADT_ERROR_MEMORY;
    memset(check->cell_of, 0xff, check->set.count * sizeof(paradt_index));
    for (i = 0; i < cell_count; i++) {
        paradt_status status = paradt__check_pace(check, i, cell_count);
        int orientation;
        if (!status) status = paradt__check_vertices(check, i);
        if (status) return status;
        paradt__check_gather(check, i, corners);
        orientation = paradt__check_orient(check, corners);
        if (orientation == 0) return paradt__check_fail(check, "a cell is flat", (paradt_index)i, -1);
        if (orientation < 0) return paradt__check_fail(check, "a cell is negatively oriented", (paradt_index)i, -1);
    }
    for (i = 0; i < check->set.count; i++)
        if (check->t->representative[i] == (paradt_index)i && check->cell_of[i] < 0)
            return paradt__check_fail(check, "a point that is not hidden is a vertex of no cell", -1, (paradt_index)i);
    return PARADT_OK;
}

// --- facets: conditions (3) and (4)

// Returns the corner of the cell `other` that is not in the facet opposite `corner` of `cell`; -1 if the cells do not
// share that facet. place[i] becomes the corner of `other` at which vertex i of `cell` stands; place[corner] the one
// that is returned.
static int paradt__check_across(const paradt__check *check, size_t cell, size_t corner, size_t other, size_t *place) {
    const paradt_index *a = paradt__check_cell(check, cell), *b = paradt__check_cell(check, other);
    unsigned left = (1u << check->corners) - 1;
    size_t i, j;
    PARADT_ASSERT(corner < check->corners && cell < check->t->cell_count && other < check->t->cell_count);
    for (i = 0; i < check->corners; i++) {
        if (i == corner) continue;
        for (j = 0; j < check->corners && a[i] != b[j]; j++) {
        }
        if (j == check->corners) return -1;
        place[i] = j;
        left &= ~(1u << j);
    }
    for (j = 0; left >> 1; left >>= 1) j++;
    place[corner] = j;
    return a[corner] == b[j] ? -1 : (int)j;
}

// Is the permutation odd? Of two positively oriented cells with a common facet, the opposite vertices lie on different
// sides of it if and only if `place` is odd: replacing one vertex by the other reverses the orientation.
static int paradt__check_is_odd(const size_t *place, size_t corners) {
    size_t i, j;
    int odd = 0;
    for (i = 0; i < corners; i++)
        for (j = 0; j < i; j++) odd ^= place[j] > place[i];
    return odd;
}

// Conditions (3) and (4) for one facet.
static paradt_status paradt__check_facet(paradt__check *check, size_t cell, size_t corner, const double **corners) {
    size_t facet = cell * check->corners + corner, place[PARADT_MAX_DIM + 1], other, twin;
    paradt_index neighbor = paradt__check_neighbor(check, facet);
    int opposite;
    if (neighbor < 0) return PARADT_OK;
    other = (size_t)neighbor;
    opposite = paradt__check_across(check, cell, corner, other, place);
    if (opposite < 0)
        return paradt__check_fail(check, "a cell does not share the facet with the neighbour across it",
                                  (paradt_index)cell, paradt__check_cell(check, cell)[corner]);
    twin = other * check->corners + (size_t)opposite;
    if (check->halves && (size_t)check->neighbors[facet] != twin)
        return paradt__check_fail(check, "a half-facet is another facet of the neighbour", (paradt_index)cell,
                                  paradt__check_cell(check, cell)[corner]);
    if (check->neighbors[twin] != (paradt_index)(check->halves ? facet : cell))
        return paradt__check_fail(check, "a neighbour's neighbour is another cell", (paradt_index)cell,
                                  paradt__check_cell(check, cell)[corner]);
    if (cell > other) return PARADT_OK;
    if (!paradt__check_is_odd(place, check->corners))
        return paradt__check_fail(check, "neighbours lie on the same side of their facet", (paradt_index)cell,
                                  paradt__check_cell(check, cell)[corner]);
    corners[check->corners] = paradt__record(&check->set, paradt__check_cell(check, other)[opposite]);
    if (paradt__conflict(&check->set.space, corners))
        return paradt__check_fail(check, "a facet is not locally Delaunay", (paradt_index)cell,
                                  paradt__check_cell(check, other)[opposite]);
    return PARADT_OK;
}

// Conditions (3) and (4).
static paradt_status paradt__check_facets(paradt__check *check) {
    const double *corners[PARADT_MAX_DIM + 2];
    size_t cell, corner, cell_count = check->t->cell_count;
    for (cell = 0; cell < cell_count; cell++) {
        paradt_status status = paradt__check_pace(check, cell, cell_count);
        paradt__check_gather(check, cell, corners);
        for (corner = 0; corner < check->corners && !status; corner++)
            status = paradt__check_facet(check, cell, corner, corners);
        if (status) return status;
    }
    return PARADT_OK;
}

// Returns the slot of the table that holds the facet opposite `corner` of the cell, or the empty slot where it belongs.
// table: facets, each its number cell * corners + corner, plus 1; 0: empty
static size_t paradt__check_facet_place(const paradt__check *check, const size_t *table, size_t slots, size_t cell,
                                        size_t corner) {
    const paradt_index *vertices = paradt__check_cell(check, cell);
    uint64_t hash = 0;
    size_t i, j, slot;
    for (i = 0; i < check->corners; i++)
        if (i != corner) hash += paradt__mix((uint64_t)vertices[i] + 1);
    for (slot = (size_t)paradt__mix(hash) & (slots - 1); table[slot]; slot = (slot + 1) & (slots - 1)) {
        size_t facet = table[slot] - 1, same = 1;
        const paradt_index *other = paradt__check_cell(check, facet / check->corners);
        for (i = 0; i < check->corners && same; i++) {
            if (i == corner) continue;
            for (j = 0; j < check->corners && (j == facet % check->corners || vertices[i] != other[j]); j++) {
            }
            same = j < check->corners;
        }
        if (same) break;
    }
    return slot;
}

// Finds the neighbours of a triangulation that comes without: cells with equal facets.
static paradt_status paradt__check_match(paradt__check *check, size_t *table, size_t slots) {
    size_t cell, corner, corners = check->corners;
    for (cell = 0; cell < check->t->cell_count; cell++) {
        paradt_status status = paradt__check_pace(check, cell, check->t->cell_count);
        if (status) return status;
        for (corner = 0; corner < corners; corner++) {
            size_t *place = table + paradt__check_facet_place(check, table, slots, cell, corner);
            size_t facet = cell * corners + corner, twin = *place - 1;
            check->matched[facet] = -1;
            if (!*place) {
                *place = facet + 1;
                continue;
            }
            if (check->matched[twin] >= 0)
                return paradt__check_fail(check, "a facet belongs to three cells", (paradt_index)cell,
                                          paradt__check_cell(check, cell)[corner]);
            check->matched[facet] = (paradt_index)(twin / corners);
            check->matched[twin] = (paradt_index)cell;
        }
    }
    return PARADT_OK;
}

// Takes the neighbours, each of which has to be a cell or a half-facet, or finds them.
static paradt_status paradt__check_adjacency(paradt__check *check) {
    size_t facets = check->t->cell_count * check->corners, slots = 16, i, *table;
    paradt_status status;
    check->neighbors = check->t->neighbors;
    check->halves = check->neighbors && check->options && check->options->flags & PARADT_FACETS;
    if (check->neighbors) {
        size_t end = check->halves ? facets : check->t->cell_count;
        for (i = 0; i < facets; i++) {
            status = paradt__check_pace(check, i, facets);
            if (status) return status;
            if (check->neighbors[i] < -1 || (check->neighbors[i] >= 0 && (size_t)check->neighbors[i] >= end))
                return paradt__check_fail(check,
                                          check->halves ? "a neighbour is no half-facet" : "a neighbour is no cell",
                                          (paradt_index)(i / check->corners), -1);
        }
        return PARADT_OK;
    }
    while (slots < facets + facets / 4) // most facets are there twice and take one slot
        slots *= 2;
    check->neighbors = check->matched = (paradt_index *)paradt__alloc(&check->memory, facets, sizeof(paradt_index));
    table = (size_t *)paradt__alloc(&check->memory, slots, sizeof *table);
    if (!check->matched || !table) {
        paradt__release(&check->memory, table);
        return PARADT_ERROR_MEMORY;
    }
    memset(table, 0, slots * sizeof *table);
    status = paradt__check_match(check, table, slots);
    paradt__release(&check->memory, table);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>check of the hull
//
// The conditions (5) to (8) of >>check, which need the cells as a whole: the hull, the covering and the hidden points;
// and all conditions in their order. The walk to a hidden point is of its own, as nothing here is to rely on the code
// that makes triangulations. Door: paradt_check.

// --- the hull and the covering: conditions (5) to (7)

// Is o on the cell's side of the facet opposite `corner`? The orientation is affine in o, so its sign is that of the
// first of o's vertices that is off the facet. Not all of them are on it, as they are the vertices of a cell.
static int paradt__check_holds_origin(paradt__check *check, const double **corners, size_t corner) {
    size_t i;
    int side = 0;
    for (i = 0; i < check->corners && !side; i++) side = paradt__check_side(check, corners, corner, check->origin[i]);
    return side > 0;
}

// Chooses o near the lexicographically smallest vertex, so that most cells can be passed over by their first
// coordinates.
static void paradt__check_choose_origin(paradt__check *check) {
    size_t i, smallest = check->set.count, home;
    const double *first;
    for (i = 0; i < check->set.count; i++)
        if (check->cell_of[i] >= 0 && (smallest == check->set.count ||
                                       paradt__compare(&check->set.space, paradt__record(&check->set, (paradt_index)i),
                                                       paradt__record(&check->set, (paradt_index)smallest)) < 0))
            smallest = i;
    paradt__check_gather(check, (size_t)check->cell_of[smallest], check->origin);
    first = paradt__record(&check->set, (paradt_index)smallest);
    for (home = 0; check->origin[home] != first; home++) {
    }
    check->origin[home] = check->origin[0];
    check->origin[0] = first;
}

// Are all corners strictly on one side of o's first vertex along some axis? Then the cell does not contain o.
static int paradt__check_is_apart(const paradt__check *check, const double *const *corners) {
    int axis;
    for (axis = 0; axis < check->set.space.dim; axis++) {
        double at = check->origin[0][axis];
        size_t i, above = 0, below = 0;
        for (i = 0; i < check->corners; i++) {
            above += corners[i][axis] > at;
            below += corners[i][axis] < at;
        }
        if (above == check->corners || below == check->corners) return 1;
    }
    return 0;
}

// The hull facet opposite `corner` of the cell has a ridge, without the corner `aside` too. Returns the remaining
// vertex of the other hull facet at this ridge, by turning around the ridge from cell to cell: `leave` is the corner
// opposite the facet that the cell is left through, `stay` the other corner that is not in the ridge. Each flag (cell,
// leave, stay) has at most one predecessor, and the first has none, so this ends.
static paradt_index paradt__check_turn(const paradt__check *check, size_t cell, size_t corner, size_t aside) {
    size_t leave = aside, stay = corner, place[PARADT_MAX_DIM + 1];
    for (;;) {
        paradt_index next = paradt__check_neighbor(check, cell * check->corners + leave);
        int opposite;
        if (next < 0) return paradt__check_cell(check, cell)[stay];
        opposite = paradt__check_across(check, cell, leave, (size_t)next, place);
        leave = place[stay];
        stay = (size_t)opposite;
        cell = (size_t)next;
    }
}

// Conditions (5) and (6) for one hull facet.
static paradt_status paradt__check_hull_facet(paradt__check *check, size_t cell, size_t corner,
                                              const double **corners) {
    size_t aside;
    if (!paradt__check_holds_origin(check, corners, corner))
        return paradt__check_fail(check, "a hull facet has cells beyond it", (paradt_index)cell,
                                  paradt__check_cell(check, cell)[corner]);
    for (aside = 0; aside < check->corners; aside++) {
        paradt_index next;
        if (aside == corner) continue;
        next = paradt__check_turn(check, cell, corner, aside);
        if (paradt__check_side(check, corners, corner, paradt__record(&check->set, next)) < 0)
            return paradt__check_fail(check, "the hull is not convex", (paradt_index)cell, next);
    }
    return PARADT_OK;
}

// Conditions (5) to (7).
static paradt_status paradt__check_hull(paradt__check *check) {
    const double *corners[PARADT_MAX_DIM + 1];
    size_t cell, corner, cell_count = check->t->cell_count;
    paradt_index first = -1;
    paradt__check_choose_origin(check);
    for (cell = 0; cell < cell_count; cell++) {
        paradt_status status = paradt__check_pace(check, cell, cell_count);
        size_t held = 0;
        paradt__check_gather(check, cell, corners);
        for (corner = 0; corner < check->corners && !status; corner++)
            if (check->neighbors[cell * check->corners + corner] < 0)
                status = paradt__check_hull_facet(check, cell, corner, corners);
        if (status) return status;
        if (paradt__check_is_apart(check, corners)) continue;
        while (held < check->corners && paradt__check_holds_origin(check, corners, held)) held++;
        if (held < check->corners) continue;
        if (first >= 0) return paradt__check_fail(check, "the cells cover a place twice", (paradt_index)cell, -1);
        first = (paradt_index)cell;
    }
    return PARADT_OK;
}

// --- hidden points: condition (8)

enum { PARADT__CHECK_DIGIT = 11, PARADT__CHECK_DIGITS = 4 }; // bits sorted by at a time, times: 44 bits a key

typedef struct paradt__check_key {
    uint64_t key;
    paradt_index point;
} paradt__check_key;

// Returns the place of x in the Morton order of a grid with 2^bits cells along each axis of the box. Only the time of
// the walks depends on it. A box so thin that its width has no inverse is not divided.
static uint64_t paradt__check_morton(const double *x, const double *low, const double *high, int dim, int bits) {
    uint64_t key = 0, limit = ((uint64_t)1 << bits) - 1, cell[PARADT_MAX_DIM];
    int axis, bit;
    for (axis = 0; axis < dim; axis++) {
        double width = high[axis] * 0.5 - low[axis] * 0.5, from = x[axis] * 0.5 - low[axis] * 0.5;
        double scaled = width > 1e-300 ? from / width * (double)limit : 0.0;
        cell[axis] = scaled > 0.0 ? (uint64_t)scaled : 0;
        if (cell[axis] > limit) cell[axis] = limit;
    }
    for (bit = bits - 1; bit >= 0; bit--)
        for (axis = 0; axis < dim; axis++) key = key << 1 | (cell[axis] >> bit & 1);
    return key;
}

// Lists the vertices and hidden points with their keys, in no order yet. Returns how many there are.
static size_t paradt__check_list(const paradt__check *check, paradt__check_key *keys) {
    const paradt__set *set = &check->set;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    int axis, dim = set->space.dim, bits = PARADT__CHECK_DIGIT * PARADT__CHECK_DIGITS / dim;
    size_t i, listed = 0;
    if (bits > 20) bits = 20;
    memcpy(low, set->records, (size_t)dim * sizeof(double));
    memcpy(high, set->records, (size_t)dim * sizeof(double));
    for (i = 0; i < set->count; i++) {
        const double *x = set->records + i * set->width;
        for (axis = 0; axis < dim; axis++) {
            low[axis] = x[axis] < low[axis] ? x[axis] : low[axis];
            high[axis] = x[axis] > high[axis] ? x[axis] : high[axis];
        }
    }
    for (i = 0; i < set->count; i++) {
        if (check->cell_of[i] < 0 && check->t->representative[i] >= 0) continue;
        keys[listed].key = paradt__check_morton(set->records + i * set->width, low, high, dim, bits);
        keys[listed++].point = (paradt_index)i;
    }
    return listed;
}

// Sorts by key, in passes by one digit from the lowest. The number of passes is even, so the result is in `keys` again.
static void paradt__check_sort(paradt__check_key *keys, paradt__check_key *other, size_t count) {
    int digit;
    for (digit = 0; digit < PARADT__CHECK_DIGITS; digit++) {
        size_t starts[(1 << PARADT__CHECK_DIGIT) + 1] = {0}, i, mask = (1 << PARADT__CHECK_DIGIT) - 1;
        int shift = digit * PARADT__CHECK_DIGIT;
        paradt__check_key *swap = keys;
        for (i = 0; i < count; i++) starts[(keys[i].key >> shift & mask) + 1]++;
        for (i = 0; i < mask; i++) starts[i + 1] += starts[i];
        for (i = 0; i < count; i++) other[starts[keys[i].key >> shift & mask]++] = keys[i];
        keys = other;
        other = swap;
    }
}

// Condition (8) for one point: walks from *cell, across facets that have the point beyond them, to a cell that contains
// it. The cells are known to be a regular triangulation by now, and in such a triangulation the walk never comes back
// to a cell (Edelsbrunner, "An acyclicity theorem for cell complexes in d dimensions", Combinatorica 10, 1990).
static paradt_status paradt__check_walk(paradt__check *check, paradt_index point, paradt_index *cell) {
    const double *corners[PARADT_MAX_DIM + 2], *x = paradt__record(&check->set, point);
    for (;;) {
        size_t corner = 0;
        paradt__check_gather(check, (size_t)*cell, corners);
        while (corner < check->corners && paradt__check_side(check, corners, corner, x) >= 0) corner++;
        if (corner == check->corners) break;
        *cell = paradt__check_neighbor(check, (size_t)*cell * check->corners + corner);
        if (*cell < 0) return paradt__check_fail(check, "a hidden point lies outside of all cells", -1, point);
    }
    corners[check->corners] = x;
    if (paradt__conflict(&check->set.space, corners))
        return paradt__check_fail(check, "a point that is called hidden should be a vertex", *cell, point);
    return PARADT_OK;
}

// Condition (8).
static paradt_status paradt__check_hidden(paradt__check *check) {
    paradt__check_key *keys;
    paradt_status status = PARADT_OK;
    paradt_index cell = 0;
    size_t i = 0, n = check->set.count;
    while (i < n && check->t->representative[i] >= 0) i++;
    if (i == n) return PARADT_OK;
    keys = (paradt__check_key *)paradt__alloc(&check->memory, n, 2 * sizeof *keys);
    if (!keys) return PARADT_ERROR_MEMORY;
    n = paradt__check_list(check, keys);
    paradt__check_sort(keys, keys + n, n);
    for (i = 0; i < n && !status; i++) {
        paradt_index point = keys[i].point;
        status = paradt__check_pace(check, i, n);
        if (check->cell_of[point] >= 0) cell = check->cell_of[point];
        else if (!status) status = paradt__check_walk(check, point, &cell);
    }
    paradt__release(&check->memory, keys);
    return status;
}

// --- all of it

// Tests the conditions of a triangulation that has points, each in an order in which it may rely on those before.
static paradt_status paradt__check_conditions(paradt__check *check) {
    paradt_status status = paradt__check_representatives(check);
    check->phase = PARADT__CHECK_CELLS;
    if (!status) status = paradt__check_cells(check);
    if (!status && !check->t->cell_count) status = paradt__check_fail(check, "there are points, but no cells", -1, -1);
    check->phase = PARADT__CHECK_MATCH;
    if (!status) status = paradt__check_adjacency(check);
    check->phase = PARADT__CHECK_FACETS;
    if (!status) status = paradt__check_facets(check);
    check->phase = PARADT__CHECK_HULL;
    if (!status) status = paradt__check_hull(check);
    check->phase = PARADT__CHECK_HIDDEN;
    return status ? status : paradt__check_hidden(check);
}

static paradt_status paradt__check_all(paradt__check *check, const paradt_points *points) {
    const paradt_triangulation *t = check->t;
    paradt_status status;
    if (t->point_count != points->count)
        return paradt__check_fail(check, "the triangulation has another number of points", -1, -1);
    if (t->cell_count > (sizeof(paradt_index) == 4 ? (size_t)INT32_MAX : SIZE_MAX / 16))
        return paradt__check_fail(check, "there are more cells than an index can number", -1, -1);
    status = paradt__check_read(check, points);
    if (!status) status = paradt__check_dimension(check);
    if (!status && !points->count && t->cell_count)
        status = paradt__check_fail(check, "there are cells without points", -1, -1);
    if (!status && points->count) status = paradt__check_conditions(check);
    check->phase = PARADT__CHECK_END;
    return status ? status : paradt__check_pace(check, 0, 1);
}

// Returns what is missing in the triangulation; NULL: nothing.
static const char *paradt__check_triangulation(const paradt_triangulation *t) {
    if (!t) return "triangulation is NULL";
    if (t->cell_count && !t->cells) return "triangulation.cells is NULL, but triangulation.cell_count is not 0";
    if (t->point_count && !t->representative)
        return "triangulation.representative is NULL, but triangulation.point_count is not 0";
    return NULL;
}

PARADT_DEF paradt_status paradt_check(const paradt_triangulation *triangulation, const paradt_points *points,
                                      const paradt_options *options, paradt_fault *fault) {
    paradt__check check;
    paradt_fault unwanted;
    paradt_status status;
    memset(&check, 0, sizeof check);
    check.t = triangulation;
    check.options = options;
    check.fault = fault ? fault : &unwanted;
    memset(check.fault, 0, sizeof *check.fault);
    status = paradt__check_arguments(points, options, &check.fault->reason);
    if (!status) {
        check.fault->reason = paradt__check_triangulation(triangulation);
        if (check.fault->reason) status = PARADT_ERROR_ARGUMENT;
    }
    if (status) {
        check.fault->cell = check.fault->point = -1;
        return status;
    }
    paradt__memory_begin(&check.memory, options);
    status = paradt__check_all(&check, points);
    paradt__release(&check.memory, check.set.records);
    paradt__release(&check.memory, check.matched);
    paradt__release(&check.memory, check.cell_of);
    if (status && !check.fault->reason) paradt__check_fail(&check, paradt_status_string(status), -1, -1);
    return status;
}
#endif // PARADT_NO_CHECK

#ifdef __cplusplus
}
#endif

#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"
#pragma float_control(pop)
#pragma clang diagnostic pop
#elif defined(__GNUC__) && !defined(__TINYC__)
#pragma GCC pop_options
#elif defined(_MSC_VER)
#pragma float_control(pop)
#endif

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif // PARADT__IMPLEMENTED
#endif // PARADT_IMPLEMENTATION

// ParaDT is available under two licences: choose whichever you prefer.
//
// ------------------------------------------------------------------------------
// ALTERNATIVE A - MIT No Attribution (MIT-0)
//
// Copyright (c) The ParaDT authors
//
// Permission is hereby granted, free of charge, to any person obtaining a copy of
// this software and associated documentation files (the "Software"), to deal in
// the Software without restriction, including without limitation the rights to
// use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies
// of the Software, and to permit persons to whom the Software is furnished to do
// so.
//
// THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
// IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
// FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
// AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
// LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
// OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
// SOFTWARE.
//
// ------------------------------------------------------------------------------
// ALTERNATIVE B - Public Domain (Unlicense, www.unlicense.org)
//
// This is free and unencumbered software released into the public domain.
//
// Anyone is free to copy, modify, publish, use, compile, sell, or distribute this
// software, either in source code form or as a compiled binary, for any purpose,
// commercial or non-commercial, and by any means.
//
// In jurisdictions that recognize copyright laws, the author or authors of this
// software dedicate any and all copyright interest in the software to the public
// domain. We make this dedication for the benefit of the public at large and to
// the detriment of our heirs and successors. We intend this dedication to be an
// overt act of relinquishment in perpetuity of all present and future rights to
// this software under copyright law.
//
// THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
// IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
// FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
// AUTHORS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN
// ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION
// WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
