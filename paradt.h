// paradt.h - v0.1.0 - exact Delaunay and regular triangulations in 2 to 8 dimensions - public domain or MIT-0
//
// DO THIS in one C or C++ file of the program, and include the header without the define in all others:
//
//     #define PARADT_IMPLEMENTATION
//     #include "paradt.h"
//
// A whole program, in C (C++ before 20 wants `paradt_points points = {corners, 8, 3, 0, PARADT_F64, NULL};`). It
// triangulates the corners of a cube and prints the cells, four point indices a line:
//
//     #define PARADT_IMPLEMENTATION
//     #include "paradt.h"
//     #include <stdio.h>
//
//     int main(void) {
//         const double corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
//                                       {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
//         paradt_points points = {.data = corners, .count = 8, .dim = 3};
//         paradt_triangulation t;
//         if (paradt_triangulate(&t, &points, NULL) != PARADT_OK)
//             return 1;
//         for (size_t c = 0; c < t.cell_count; c++)
//             printf("%d %d %d %d\n", (int)t.cells[4 * c], (int)t.cells[4 * c + 1], (int)t.cells[4 * c + 2],
//                    (int)t.cells[4 * c + 3]);
//         paradt_free(&t);
//         return 0;
//     }
//
//     cc -o cube cube.c -lm && ./cube
//
// There is nothing else to build, and nothing to link but the C library (-lm where that has its mathematics apart).
//
// MACROS, to be defined before the header is included
//
//     PARADT_IMPLEMENTATION  in one file: the functions as well as their declarations
//     PARADT_STATIC          the functions are static: define it with PARADT_IMPLEMENTATION, in any number of files
//     PARADT_DEF             what stands before each public function; extern, or static with PARADT_STATIC
//     PARADT_INDEX64         indices of points and cells have 64 bits, not 32; the same in every file of a program.
//                            Insertion has no code for SSE2 and AVX2 then
//     PARADT_ASSERT(c)       checks of the code's own invariants, never of your data; nothing, or as you define it
//     PARADT_NO_SIMD         no code for SSE2, and no second copy of the inner loops that is chosen where the processor
//                            has AVX2 and FMA (x86-64, GCC or Clang); compilers use what they were told of all the same
//
// WHAT IT DOES
//
//     - Delaunay triangulations, and with weights regular triangulations, of points in 2 to 8 dimensions
//     - exact for all finite doubles and floats: huge, subnormal, mixed, collinear, coplanar, cospherical, repeated
//     - one result: the same points give the same set of cells by every method, any number of regions and threads, in
//       any order, with any compiler and its flags
//     - cells with orientation and neighbours; for each point the one that stands for it when points coincide
//     - divided into regions that are built alone, on threads that the program provides
//     - a certificate: paradt_check proves a result to be the triangulation of its points, or says what is wrong
//     - no global state, no threads of its own, no output, no exit; memory from your allocator, within your limit
//     - C99 and C++11
//
// CONTENTS
//
//     points, options, result, methods, regions and threads, degenerate input, numbers and compiler flags, memory,
//     errors, cost, limits, the thesis, credits, changes; the declarations; the implementation in sections marked
//     "// >>name"; the licence
//
//
// POINTS
//
// paradt_points describes an array of yours, which is only read, and only during a call. Coordinates are doubles, or
// floats with scalar = PARADT_F32; those of one point are adjacent, and `stride` bytes lead from a point to the next,
// so points may be members of larger structures. No alignment is needed. A vertex of a mesh with its position in front:
//
//     struct vertex { float position[3], normal[3], uv[2]; } mesh[1000];
//     paradt_points points = {mesh, 1000, 3, sizeof(struct vertex), PARADT_F32, NULL};
//
// Weights make the triangulation regular (also called weighted Delaunay, or a power diagram's dual): a point of weight
// w is a sphere of radius sqrt(w), and distance is power distance, |x - p|^2 - w. Weights are doubles of any sign. To
// add the same number to all of them changes nothing; all equal is Delaunay.
//
// Coordinates and weights must be finite. -0.0 is 0.0.
//
//
// OPTIONS
//
// NULL, or all fields zero, is the default: the method that suits the input, one region, the calling thread, malloc.
// Set what you need and leave the rest zero, and fields that later versions add will not surprise you:
//
//     paradt_options options = {0}; // in C++: = {}
//     options.method = PARADT_DEWALL;
//     options.memory_limit = (size_t)1 << 30;
//
// `progress` is called now and then with the part of the work that is done, as far as that can be foretold. It cancels
// the work by returning nonzero: the call then ends with PARADT_ERROR_CANCELLED and gives back all memory.
//
//
// RESULT
//
// cells[i] is dim + 1 indices into your points; neighbors[i][j] is the cell on the other side of the facet opposite the
// vertex cells[i][j], or -1 where that facet is on the hull. As plain arrays, with k = t.dim + 1:
//
//     t.cells[i * k + j]        vertex j of cell i
//     t.neighbors[i * k + j]    the cell opposite that vertex
//     t.representative[p]       p where p is a vertex; the point of the same place that is; -1 where p is hidden
//
// Every cell is positively oriented: the determinant of (v1 - v0, v2 - v0, ...) is positive. So triangles run
// counterclockwise, and so does the triangle v0 v1 v2 of a tetrahedron when seen from v3, in right-handed coordinates.
// Neighbours have all but one vertex in common. The order of the cells, and of the vertices within a cell but for the
// orientation, means nothing, and may differ from one method, machine or version to another. What never differs is the
// set of cells; paradt_hash is equal for equal sets.
//
// t.stats counts what was done. Give the arrays back with paradt_free, not with free.
//
//
// METHODS
//
//     PARADT_AUTO           the one that suits the input: Bowyer-Watson in two and three dimensions; in more, InCoDe,
//                           and Bowyer-Watson again where that gets stuck in ties, as on lattices
//     PARADT_INCODE         incremental construction: from a first cell, the neighbour across every facet without one
//     PARADT_DEWALL         divide and conquer, merge first: the wall of cells across a plane, then each side of it
//     PARADT_BOWYER_WATSON  insertion of one point after the other: the cells in conflict with it make room for those
//                           between their rim and the point; a region adds points of others until its cells are right
//
// All give the same cells; they differ in time and memory. InCoDe and DeWall find the cell across a facet by a search
// in a hierarchical grid of the points, and never change a cell once it is made.
//
//
// REGIONS AND THREADS
//
// options.regions = k divides space into k boxes. Each box is built alone, every cell is owned by one of them, and what
// they own is put together, and neighbours are linked across the seams. Some of the cells at a seam are made by more
// than one region and kept by one: stats.cells_recomputed of them were made in vain, so (cells + cells_recomputed) /
// cells is the factor of duplication, the price of the division. By InCoDe and DeWall a cell is owned by the box with
// most of its vertices (>>incode has the rule), by insertion by the last box that has any. The first box then needs no
// points but its own; it gets somewhat more of them. The others also get cells among others' points alone, which count
// too, whether they are in the result or in none.
//
//     PARADT_BISECTION  boxes of equal numbers of points, by a sample of 65,536: each box is cut across the longest
//                       side of its points
//     PARADT_UNIFORM    boxes of equal size: the bounding box is cut into equal parts
//
// The header starts no threads. To work on the regions at once, hand in a parallel_for: a function that runs
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
// examples/paradt.c has one for POSIX threads. The allocator and the progress callback are then called from those
// threads, at once. It is called some ten times, for large sets up to forty: the insertion is done in legs, between
// which regions change hands, so that a slow processor, or one that others use, is not waited for. Near surfaces, where
// regions tell each other what they lack, it is called some dozens of times more. One region a thread is right where
// the points are alike everywhere; a few more even out regions that take longer. The cells do not depend on the
// regions, nor on the threads.
//
// Insertion gives the regions up where they would have to ask each other for longer than all the rest takes: among
// points exactly on a sphere, or almost on a line. One of them takes in the others' points then, and stats.regions is
// 1. Threads may see the progress go back.
//
// Any number of calls may run at once from any threads, each with its own result; points may be shared.
//
//
// DEGENERATE INPUT
//
// Ties. The Delaunay triangulation is the lower hull of the points lifted to the height |x|^2 - w. Where an empty
// sphere has more points on it than a cell has vertices there are several, and one is chosen: the heights are raised by
// infinitesimal amounts, that of a lexicographically larger point (by x, then y, ...) infinitely more than that of a
// smaller one. Only heights move, never places: no cell is flat, and the hull is that of the points. With s the exact
// in-sphere test, the point q is in conflict with the positively oriented cell p0..pd when
//
//     s > 0 (inside), or s = 0 and, going through p0..pd and q from the lexicographically largest downward:
//         q:  no conflict
//         pi: let o be the orientation of the cell with q in the place of pi;
//             o > 0: conflict, o < 0: no conflict, o = 0: go on
//
// and the triangulation is the set of cells that no point is in conflict with. The rule knows places and weights only,
// no index and no history, so it decides alike for everybody. Weights have no part in the order.
// paradt_insphere_perturbed is this test. (Devillers and Teillaud's rule, in every dimension.)
//
// Equal points are one vertex. The smallest index stands for them; with weights that of the largest weight, and among
// these the smallest index. stats.duplicates counts the others, `representative` names who stands for each.
//
// Hidden points. A weighted point may be a vertex of no cell; it and its duplicates have the representative -1.
// stats.hidden counts places, not duplicates.
//
// Lower dimensions. Points in a line, plane or flat of dimension k < d are triangulated within it: t.dim is k and the
// cells have k + 1 vertices. Orientation is that of the first k axes in which the flat has its full dimension. One
// point, or many at one place, give t.dim = 0 and one cell of one vertex; no points give t.dim = -1 and no cell. None
// of these is an error.
//
//
// NUMBERS AND COMPILER FLAGS
//
// What decides is the sign of a determinant. A filter in floating point settles nearly all of them, with an error bound
// that holds for any order of the operations, fused or not, in any rounding mode, with x87 registers, and with
// subnormals flushed to zero; it is not used where the input's exponents could make it overflow. What it leaves open is
// computed in integers, on the bits of the doubles, in three stages: small integers, a fixed number of words, any
// number of words. So -O3, -Ofast, -ffast-math, -march=native, -m32 and a changed rounding mode change the time, not
// the cells. Floats are widened exactly.
//
// The coordinates of lattices have few bits: for them even ties are settled in the filter or in small integers.
//
//
// MEMORY
//
// Everything comes from options.allocator (malloc and free when its functions are NULL; give both or neither). Its
// blocks must be aligned as malloc aligns them; it returns NULL when there is no more. It must be safe to call from
// several threads at once when a parallel_for is given and uses several. It has to live as long as the result, which
// keeps a copy of it for paradt_free.
//
// Huge pages are left to you: an allocator that asks for them takes a tenth off the time of large sets where the system
// has them ready, and adds a third on a virtual machine whose host has to provide them anew. On Linux from 5.14 on
// small pages are made somewhat ahead of their use, by madvise; that takes 3 to 5 hundredths off.
//
// The result takes (2 cells (dim + 1) + points) indices; with PARADT_NO_NEIGHBORS half of the cells' share is missing.
// The arrays may be up to a third larger than that, and for a few hundred points some kilobytes larger.
// Without neighbours insertion in two and three dimensions (PARADT_AUTO too) builds regions one after another, if they
// don't run at once: those that are asked for, or, from 500,000 points on, five. Each gives its links back before the
// next begins: 10^6 uniform points in space need 190 bytes a point instead of 280, and take a tenth to a fifth more
// time; points that crowd as in a star cluster take a third to a half more.
// memory_limit bounds the bytes that one call holds at any time, the result included; regions get equal shares of what
// the points have left of it, so many regions reach it sooner. stats.peak_bytes is what was held at most (with regions:
// an upper bound, the sum of their peaks).
//
// The stack is used moderately: the exact predicates take up to 66 KB of it for numbers of extreme exponents. Recursion
// is as deep as the logarithm of the number of points. 256 KB are enough. Linkers for WebAssembly give 64 KB if they
// are not told: wasm-ld -z stack-size=262144.
//
//
// ERRORS
//
// Functions that can fail return a paradt_status; PARADT_OK is 0, paradt_status_string describes the others.
//
//     PARADT_ERROR_ARGUMENT    a missing pointer, a dimension out of 2..8, a stride less than a point, an unknown value
//     PARADT_ERROR_NOT_FINITE  a NaN or infinity; error_point is the index of the first such point
//     PARADT_ERROR_MEMORY      the allocator returned NULL, or memory_limit is reached
//     PARADT_ERROR_TOO_LARGE   more points or cells than an index can number (see LIMITS)
//     PARADT_ERROR_CANCELLED   the progress callback returned nonzero
//     PARADT_ERROR_INVALID     paradt_check only: the triangulation is wrong; paradt_fault says where
//
// After an error the result is empty: all memory is given back, and there is nothing to free (paradt_free does no
// harm). Callbacks must return: an exception or longjmp out of them leaks what the call holds.
//
//
// COST
//
// For points that are spread without structure the work on a cell is expected not to grow with n: InCoDe and DeWall
// look at a bounded number of candidates a facet, insertion at a bounded number of cells a point. So time is
// proportional to the number of cells, but for sorting the points. Exceptions: when all points lie exactly on one
// sphere, or in a slanting plane but for rounding, every point ties with every sphere, and a search of InCoDe or DeWall
// looks at all of them; and points whose coordinates or weights are too large or too far apart in size for floating
// point (see NUMBERS) are searched one by one. Insertion has neither. How many cells there are depends on the points:
// proportional to n for most input in a fixed dimension, with a factor that grows quickly with the dimension; at worst
// they grow like n^ceil(d/2), for which a moment curve in any dimension, or two skew lines in space, are examples. The
// counters of paradt_stats tell what a run cost in terms that do not depend on the machine:
//
//     distance_evaluations / cells   candidates looked at for a cell, eight a grid cell (InCoDe, DeWall; with regions
//                                    insertion, too)
//     grid_cells_visited / cells     how far these searches went
//     exact_* / cells                predicates too close for floating point, orientations included
//     perturbed                      ties
//     cells_recomputed / cells       the price of regions, but for those that were given up
//     active_peak                    the size of the front (InCoDe, DeWall)
//
// paradt_check takes expected linear time. The predicates alone (paradt_orient, paradt_insphere) measure their
// arguments anew at each call; the triangulation does that once for all points, and is faster for each of them.
//
//
// LIMITS
//
//     dimension   2 to 8
//     points      2^30 - 1, with PARADT_INDEX64 as many as memory holds
//     cells       cells * (dim + 1) below 2^31 (536,870,911 tetrahedra), with PARADT_INDEX64 as many as memory holds;
//                 in Bowyer-Watson's method the facets of the hull count as cells too
//     changes     a triangulation is computed as a whole; points are not added to it or taken away later
//     constraints none: no edges or facets can be demanded
//     methods     those of PARADT_METHOD_LIST: no flips, Delaunay tree or lifted hull yet
//     right shift of negative integers has to be arithmetic, doubles IEEE 754, as on all platforms met so far
//
//
// THE THESIS
//
// InCoDe, DeWall and their parallel forms as in "Parallel Delaunay Triangulation in 3D and Higher Dimensions". Where
// its parts are:
//
//     InCoDe      MakeFirstSimplex       paradt__cell_towards: paradt__guess_simplex grows it from the nearest
//                                        neighbour by smallest spheres (paradt__smallest_sphere), descent makes it sure
//                 MakeSimplex            paradt__search_apex, the smallest signed Delaunay distance outside of a facet
//                 active face list       struct paradt__active, a hash table: paradt__active_match
//                 update of the AFL      paradt__front_add
//                 uniform grid           paradt__grid_build: a hierarchy of boxes that adapts to the points
//                 the loop               paradt__incode, with paradt__front_expand for each facet
//     DeWall      dividing plane         paradt__grid_cut
//                 simplex wall           paradt__wall_build, begun by paradt__wall_seed where no facet crosses it
//                 AFL alpha, 1, 2        struct paradt__wall; paradt__wall_activate says which one a facet enters
//                 recursion              paradt__wall_build, from paradt__dewall
//     ParaInCoDe  regions                paradt__build_regions; one of them: paradt__front_task
//                 owner                  paradt__cell_owner, the box with most vertices instead of the one with the
//                                        ULF vertex, and which facets a region needs for that: paradt__needs
//                 uniform partition      paradt__cutter_divide with PARADT_UNIFORM
//                 adaptive partition     the same with PARADT_BISECTION
//                 joining                paradt__region_compact, paradt__regions_join
//
// Here every decision is exact, ties follow the perturbation, and one code serves all dimensions, with and without
// weights. That a region reaches all the cells it owns is shown in >>incode.
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

#ifndef PARADT_H
#define PARADT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
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
#define PARADT_MAX_DIM 8 // 2..8: code for more dimensions is not compiled
#endif
#if PARADT_MAX_DIM < 2 || PARADT_MAX_DIM > 8
#error "PARADT_MAX_DIM must be 2 to 8"
#endif

#ifdef PARADT_INDEX64
typedef int64_t paradt_index; // a point or a cell; negative: none
#else
typedef int32_t paradt_index; // a point or a cell; negative: none
#endif

// What functions that can fail return: name, what paradt_status_string says. PARADT_OK is 0.
#define PARADT_STATUS_LIST(X)                                                                                          \
    X(PARADT_OK, "done")                                                                                               \
    X(PARADT_ERROR_ARGUMENT, "an argument is out of its range or missing")                                             \
    X(PARADT_ERROR_NOT_FINITE, "a coordinate or weight is NaN or infinite")                                            \
    X(PARADT_ERROR_MEMORY, "an allocation failed or the memory limit was reached")                                     \
    X(PARADT_ERROR_TOO_LARGE, "the input or the result has more elements than an index can number")                    \
    X(PARADT_ERROR_CANCELLED, "the progress callback asked to stop")                                                   \
    X(PARADT_ERROR_INVALID, "the triangulation is not the one its points define")

#define PARADT__ENUM_FIRST(name, text) name,
typedef enum paradt_status { PARADT_STATUS_LIST(PARADT__ENUM_FIRST) PARADT_STATUS_COUNT } paradt_status;

// How to triangulate: name, name on the command line. The cells are the same by every method.
#define PARADT_METHOD_LIST(X)                                                                                          \
    X(PARADT_AUTO, "auto")                                                                                             \
    X(PARADT_INCODE, "incode")                                                                                         \
    X(PARADT_DEWALL, "dewall")                                                                                         \
    X(PARADT_BOWYER_WATSON, "bowyer-watson")

typedef enum paradt_method { PARADT_METHOD_LIST(PARADT__ENUM_FIRST) PARADT_METHOD_COUNT } paradt_method;

// What a coordinate is: a double or a float.
typedef enum paradt_scalar { PARADT_F64, PARADT_F32 } paradt_scalar;

// How space is divided into regions: into boxes of equal numbers of points, or of equal size.
typedef enum paradt_partition { PARADT_BISECTION, PARADT_UNIFORM } paradt_partition;

// paradt_options.flags
enum { PARADT_NO_NEIGHBORS = 1 }; // the result's neighbors are NULL

// Runs task(context, i) for every i below count, in any order and on any threads, and returns when all have ended.
// user: that of the options. Tasks don't wait for each other, so one thread is enough. Called by paradt_triangulate,
// from the thread that called that, for one step of the work after another (how many: see REGIONS AND THREADS).
typedef void (*paradt_parallel_for)(void *user, size_t count, void (*task)(void *context, size_t index), void *context);

// fraction: 0..1, of the work done; an estimate. A nonzero return cancels. With a parallel_for it is called from its
// threads, at once, and the fractions of several regions come interleaved. user: that of the options.
typedef int (*paradt_progress)(void *user, double fraction);

// Where memory comes from. Give both functions or neither. A parallel_for's threads call them at once.
typedef struct paradt_allocator {
    void *(*alloc)(void *user, size_t size); // NULL: malloc; bytes, never 0; aligned as malloc does, or NULL on failure
    void (*free)(void *user, void *memory);  // NULL: free; never called with NULL
    void *user;                              // handed to both
} paradt_allocator;

typedef struct paradt_points {
    const void *data;      // first coordinate of the first point; may be NULL when count is 0
    size_t count;          // number of points
    int dim;               // coordinates a point, 2..PARADT_MAX_DIM
    size_t stride;         // bytes from one point to the next; 0: tightly packed
    paradt_scalar scalar;  // type of the coordinates; PARADT_F64
    const double *weights; // [count] squares of lengths, any sign; NULL: Delaunay; else the regular triangulation
} paradt_points;

typedef struct paradt_options {
    paradt_method method;             // PARADT_AUTO
    size_t regions;                   // 0 or 1: undivided (but see MEMORY); at most as many as there are points
    paradt_partition partition;       // PARADT_BISECTION
    paradt_parallel_for parallel_for; // NULL: regions run one after another in the calling thread
    paradt_progress progress;         // NULL: none
    paradt_allocator allocator;       // zero: malloc and free
    size_t memory_limit;              // bytes that a call may hold at once; 0: no limit
    unsigned flags;                   // 0; PARADT_NO_NEIGHBORS
    void *user;                       // handed to parallel_for and progress; NULL
} paradt_options;

// Counts are sums over all regions unless they say otherwise.
typedef struct paradt_stats {
    uint64_t cells;                // cells of the triangulation
    uint64_t hull_facets;          // facets with a cell on one side only
    uint64_t duplicates;           // points at the place of another
    uint64_t hidden;               // places of weighted points that are no vertex
    uint64_t distance_evaluations; // Delaunay distances computed by searches, in lanes of eight
    uint64_t grid_cells_visited;   // grid cells whose points were looked at
    uint64_t active_peak;          // largest size of an active face list of InCoDe or DeWall, in facets
    uint64_t orient_calls;         // orientation predicates
    uint64_t insphere_calls;       // in-sphere predicates; of insertion in space those that kept spheres left open
    uint64_t exact_small;          // predicates settled in small integers, or found to be 0 by the filter on lattices
    uint64_t exact_fixed;          // ... in integers of a fixed number of words
    uint64_t exact_general;        // ... in integers of any length
    uint64_t perturbed;            // in-sphere predicates settled by the perturbation
    uint64_t regions;              // regions built
    uint64_t cells_recomputed;     // cells that regions were left with and did not own: the duplication
    uint64_t peak_bytes;           // most memory held at once, result included; with regions an upper bound
    double seconds_points;         // reading, checking, sorting and merging the points; wall time, like all of these
    double seconds_grid;           // sorting them into the grid of InCoDe and DeWall
    double seconds_build;          // making cells, with regions joining them too
    double seconds_finish;         // hidden points, translating indices
    double seconds;                // all of it. Where there is no timespec_get (C11) these are processor time
} paradt_stats;

typedef struct paradt_triangulation {
    int dim;                      // affine dimension of the points: dim + 1 vertices a cell; -1: no points
    size_t cell_count;            // number of cells
    paradt_index *cells;          // [cell_count][dim + 1] point indices, positively oriented
    paradt_index *neighbors;      // [cell_count][dim + 1] cell opposite each vertex, -1: hull; NULL when not wanted
    size_t point_count;           // number of points, as given
    paradt_index *representative; // [point_count] itself, or the point that stands for it, or -1 when hidden
    paradt_stats stats;           // what was done
    size_t error_point;           // PARADT_ERROR_NOT_FINITE: index of the first such point; else 0
    paradt_allocator allocator;   // what paradt_free gives the arrays back to
} paradt_triangulation;

// What paradt_check found wrong first; all of it zero when nothing is.
typedef struct paradt_fault {
    const char *reason; // a sentence, of static storage; NULL: nothing is wrong
    paradt_index cell;  // index of the cell concerned, or -1
    paradt_index point; // index of the point concerned, or -1
} paradt_fault;

// Computes the triangulation of the points.
//   out      is overwritten, whatever it held. After an error it is empty but for error_point, and holds no memory.
//   points   read during the call only.
//   options  NULL: the defaults.
// Errors: ARGUMENT, NOT_FINITE, MEMORY, TOO_LARGE, CANCELLED. Thread safety: any number of calls at once, with an `out`
// each. Cost: that of sorting the points, and expected constant time a cell for points without structure.
PARADT_DEF paradt_status paradt_triangulate(paradt_triangulation *out, const paradt_points *points,
                                            const paradt_options *options);

// Gives the arrays back to the allocator they came from and makes the triangulation all zero. NULL and all zero are
// fine. Thread safety: as free.
PARADT_DEF void paradt_free(paradt_triangulation *triangulation);

// A sentence of static storage, without a full stop; never NULL, whatever the value. Thread-safe.
PARADT_DEF const char *paradt_status_string(paradt_status status);

// The method's name on the command line, of static storage; never NULL, whatever the value. Thread-safe.
PARADT_DEF const char *paradt_method_string(paradt_method method);

// Proves in exact arithmetic that the triangulation is the one that the points define: cells, neighbours,
// representatives, hidden points, dimension. PARADT_OK: it is. PARADT_ERROR_INVALID: it is not, and *fault says what
// was found first.
//   triangulation  of any origin: the values in the arrays are not trusted, their sizes are. neighbors may be NULL.
//   points         those it was made of.
//   options        NULL: the defaults; allocator, memory_limit, progress and user are used, the rest is only checked.
//   fault          NULL: not wanted.
// Errors: INVALID, and ARGUMENT, NOT_FINITE, MEMORY, TOO_LARGE, CANCELLED, by which nothing is said about the
// triangulation. Thread safety: any number of calls at once. Cost: expected linear time; it shares the predicates with
// paradt_triangulate, but neither its searches nor its data structures.
PARADT_DEF paradt_status paradt_check(const paradt_triangulation *triangulation, const paradt_points *points,
                                      const paradt_options *options, paradt_fault *fault);

// A hash of the set of cells as sets of point indices: the sum of paradt_hash_cell over the cells. It does not depend
// on the order of cells and vertices, the size of indices, nor the machine, and needs no neighbours. Without cells it
// is 0. Thread-safe. Cost: linear time.
PARADT_DEF uint64_t paradt_hash(const paradt_triangulation *triangulation);

// The hash of one cell. vertices: [count] in any order; count: 0..PARADT_MAX_DIM + 1. For programs that hold the cells
// in parts, or with other numbers: sums of the parts add up to the hash of the whole. Thread-safe.
PARADT_DEF uint64_t paradt_hash_cell(const uint64_t *vertices, int count);

// The predicates: exact for all finite doubles; others are undefined behaviour, and so is a dim out of
// 2..PARADT_MAX_DIM. Each point is a pointer to dim coordinates. No memory is allocated. Thread-safe. Each call costs a
// pass over its arguments and the filter; the exact stages only when that can't decide.

// The sign, -1, 0 or 1, of the determinant of points[1] - points[0], ..., points[dim] - points[0]. 1: positively
// oriented, in the plane counterclockwise; 0: flat.
PARADT_DEF int paradt_orient(int dim, const double *const *points /* [dim + 1] */);

// 1 when points[dim + 1] is inside of the sphere through the first dim + 1, which are positively oriented; 0 on it; -1
// outside. With the first dim + 1 negatively oriented, the opposite. weights: NULL, or [dim + 2]; then inside means
// below the hyperplane through the first dim + 1 when all are lifted to |x|^2 - weight (the power test).
PARADT_DEF int paradt_insphere(int dim, const double *const *points /* [dim + 2] */, const double *weights);

// The same with ties broken by the perturbation (see DEGENERATE INPUT): 1 in conflict, -1 not, never 0. The first dim +
// 1 points must be positively oriented, and none of them equal to points[dim + 1].
PARADT_DEF int paradt_insphere_perturbed(int dim, const double *const *points /* [dim + 2] */, const double *weights);

#ifdef __cplusplus
}
#endif

#endif // PARADT_H

// The implementation follows; stop here if you only use the API. Its sections are marked "// >>name", and each begins
// with what it is for, what it relies on and where the idea comes from. Each uses only what stands above it.

#ifdef PARADT_IMPLEMENTATION
#ifndef PARADT__IMPLEMENTED
#define PARADT__IMPLEMENTED

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
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

// Adds to a counter that several threads share and returns the sum. Not defined where the compiler has no atomic
// addition; callers then do without.
#if defined(__GNUC__) && !defined(__TINYC__)
#define PARADT__ADD_AT_ONCE(count, more) __atomic_add_fetch(count, more, __ATOMIC_RELAXED)
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>memory
//
// Allocates from the caller's allocator and accounts for every byte. A block is preceded by its size, so that a release
// needs no size and the account stays exact. An account belongs to one thread at a time: each region has an account
// of its own with a share of the limit, which paradt__memory_join adds to the parent's account when the region ends.
// Doors: paradt__memory_begin, paradt__memory_fork, paradt__memory_join, paradt__alloc, paradt__alloc_filled,
// paradt__grow, paradt__release, paradt__make_pages.

typedef struct paradt__memory {
    paradt_allocator allocator;
    uint64_t limit; // bytes; UINT64_MAX: none
    uint64_t held;  // bytes. Wraps below zero while the task has released more than it allocated
    uint64_t peak;  // the most bytes held so far
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
static paradt__memory paradt__memory_fork(const paradt__memory *parent, size_t shares) {
    paradt__memory memory = *parent;
    PARADT_ASSERT(shares > 0);
    memory.held = memory.peak = 0;
    if (parent->limit != UINT64_MAX) memory.limit = (parent->limit - parent->held) / shares;
    return memory;
}

// Adds what the child holds to the parent's account, and the child's peak to *sum_of_peaks. The tasks may have run
// concurrently, so that the sum of their peaks is an upper bound of the true peak.
static void paradt__memory_join(paradt__memory *parent, const paradt__memory *child, uint64_t *sum_of_peaks) {
    parent->held += child->held;
    *sum_of_peaks += child->peak;
    if (parent->held > parent->peak) parent->peak = parent->held;
}

// Returns `count` elements of `size` bytes, not cleared; NULL if the limit, the allocator or size_t does not admit so
// many. Even zero elements get a block.
static void *paradt__alloc(paradt__memory *memory, size_t count, size_t size) {
    size_t bytes;
    uint64_t held;
    char *block;
    if (size && count > (SIZE_MAX / 2 - PARADT__BLOCK_HEADER) / size) return NULL;
    bytes = count * size + PARADT__BLOCK_HEADER;
    held = memory->held + bytes;
    if (bytes > memory->limit || (held > memory->limit && held <= UINT64_MAX / 2)) return NULL;
    block = (char *)memory->allocator.alloc(memory->allocator.user, bytes);
    if (!block) return NULL;
    memcpy(block, &bytes, sizeof bytes);
    PARADT__FORBID(block + sizeof bytes, PARADT__BLOCK_HEADER - sizeof bytes);
    memory->held = held;
    if (held > memory->peak && held <= UINT64_MAX / 2) memory->peak = held;
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
// paradt__largest.

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

// ---------------------------------------------------------------------------------------------------------------------
// >>tasks
//
// What runs on several threads: teams of tasks, progress, giving up, and pauses of insertions that work together.
// Doors: to be listed.

// Tasks that may run at once, for work that is divided by points
typedef struct paradt__team {
    paradt_parallel_for parallel_for; // NULL: one after another
    void *user;
    size_t tasks; // 1..PARADT__MOST_TASKS
} paradt__team;

enum { PARADT__MOST_TASKS = 4 };

static paradt__team paradt__team_of(const paradt_options *options, size_t regions) {
    paradt__team team;
    team.parallel_for = options->parallel_for;
    team.user = options->user;
    team.tasks = options->parallel_for ? regions : 1;
    if (team.tasks > PARADT__MOST_TASKS) team.tasks = PARADT__MOST_TASKS;
    return team;
}

static const paradt__team paradt__alone = {NULL, NULL, 1};

static void paradt__team_run(const paradt__team *team, void (*task)(void *context, size_t index), void *context) {
    if (team->tasks > 1) team->parallel_for(team->user, team->tasks, task, context);
    else task(context, 0);
}
// Progress and cancellation, asked for now and then.
typedef struct paradt__progress {
    paradt_progress call; // NULL: none
    void *user;
    double begin, length; // the part of the work that this task is
} paradt__progress;

static int paradt__progress_cancels(const paradt__progress *progress, double fraction) {
    if (!progress->call) return 0;
    if (fraction > 1.0) fraction = 1.0;
    return progress->call(progress->user, progress->begin + fraction * progress->length) != 0;
}

// A status that no caller gets to see
#define PARADT__GAVE_UP ((paradt_status)PARADT_STATUS_COUNT)

// What insertions at once have in common that are to pause together
typedef struct paradt__relay {
    ptrdiff_t done; // by them all so far, in points inserted; below zero after a wait at the begin
    ptrdiff_t stop; // they pause when it is so much
} paradt__relay;

// Is it time to pause, with so many parts of the work done? worth: of 64 of them, in points inserted.
static int paradt__relay_pauses(paradt__relay *relay, size_t done, size_t worth) {
#if defined(PARADT__ADD_AT_ONCE)
    return relay && done % 64 == 0 && PARADT__ADD_AT_ONCE(&relay->done, (ptrdiff_t)worth) >= relay->stop;
#else
    (void)relay, (void)done, (void)worth;
    return 0;
#endif
}

// The others do not pause while one does what takes as long as so many points and can't be paused.
static void paradt__relay_waits(paradt__relay *relay, size_t points) {
#if defined(PARADT__ADD_AT_ONCE)
    if (relay) PARADT__ADD_AT_ONCE(&relay->done, -(ptrdiff_t)points);
#else
    (void)relay, (void)points;
#endif
}

static double paradt__now(void) {
#if defined(__wasi__) // has no clock()
    struct timespec now;
    return clock_gettime(CLOCK_REALTIME, &now) ? 0.0 : (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
#else
#if defined(TIME_UTC)
    struct timespec now;
    if (timespec_get(&now, TIME_UTC)) return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
#endif
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
// paradt__space_end, paradt__compare.

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

// Begins to measure a set, of any number of points: paradt__space_add follows for each, then paradt__space_end.
static void paradt__space_begin(paradt__space *s, int dim, int ambient, int weighted) {
    PARADT_ASSERT(dim >= 0 && dim <= ambient && ambient <= PARADT_MAX_DIM);
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

// ---------------------------------------------------------------------------------------------------------------------
// >>curve
//
// Points in the order of Hilbert's curve: neighbours in it are neighbours in space. The order only matters for speed,
// but for one thing: equal points have equal positions on the curve, and are found by that. So positions come from the
// bits of the coordinates, by integers alone. Doors: paradt__levels_for, paradt__lattice_begin, paradt__hilbert_begin,
// paradt__curve_key, paradt__keyed_sort.

typedef struct paradt__keyed {
    uint64_t key;
    paradt_index point;
} paradt__keyed;

enum {
    PARADT__CURVE_BITS = 60, // of a key, at most
    PARADT__FEW_KEYS = 32,   // sorted by insertion
    PARADT__DIGIT_BITS = 8,  // of a key, by which all points are sorted first, at most
    PARADT__DIGITS = 1 << PARADT__DIGIT_BITS,
    PARADT__MOST_DIGIT_BITS = 11, // by which some of them are sorted next, at most
    PARADT__STEP_BITS = 6,        // of a key, found at once for many points in two or three dimensions
    PARADT__TURNS = 24,           // orientations of the curve there, at most: dim << dim
    PARADT__MANY_KEYS = 2048,
    PARADT__FLAT = 1 << 14 // an exponent that makes every coordinate 0
};

// The bits of a key by which so many are sorted next, of those that are left: as many as give each key a value of its
// own, if they are spread evenly. Where that takes too large a table, two steps have half of the bits each.
static int paradt__digit_bits(size_t count, int bits) {
    int wanted = paradt__bit_length(count) - 1;
    if (wanted > PARADT__MOST_DIGIT_BITS) wanted = (wanted + 1) / 2;
    if (wanted > PARADT__MOST_DIGIT_BITS) wanted = PARADT__MOST_DIGIT_BITS;
    return wanted < bits ? wanted : bits;
}

// Sorts by insertion. to: may be the same.
static void paradt__keyed_insert(const paradt__keyed *keyed, paradt__keyed *to, size_t count) {
    size_t i;
    for (i = 0; i < count; i++) {
        paradt__keyed moved = keyed[i];
        size_t j = i;
        for (; j > 0 && to[j - 1].key > moved.key; j--) to[j] = to[j - 1];
        to[j] = moved;
    }
}

// paradt__keyed_sort with a table of digits, which all depths share: what has a digit in common is found by the keys.
static void paradt__keyed_sort_by(paradt_index *place, paradt__keyed *keyed, paradt__keyed *other, size_t count,
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
    memset(place, 0, (digits + 1) * sizeof *place);
    for (i = 0; i < count; i++) place[(keyed[i].key >> shift & (digits - 1)) + 1]++;
    for (i = 1; i <= digits; i++) {
        most = place[i] > most ? place[i] : most;
        place[i] += place[i - 1];
    }
    for (i = 0; i < count; i++) other[place[keyed[i].key >> shift & (digits - 1)]++] = keyed[i];
    if (!shift) {
        if (!across) memcpy(keyed, other, count * sizeof *keyed);
    } else if (most <= PARADT__FEW_KEYS) {
        paradt__keyed_insert(other, across ? other : keyed, count);
    } else {
        for (begin = 0; begin < count; begin = end) {
            for (end = begin + 1; end < count && other[end].key >> shift == other[begin].key >> shift;) end++;
            paradt__keyed_sort_by(place, other + begin, keyed + begin, end - begin, shift, !across);
        }
    }
}

// Sorts by the lowest bits of the keys, which differ in no others, without changing the order of equal ones: radix from
// the top, until few have a digit in common; then they are nearly sorted. other: room for as many; where the result
// goes if `across`.
static void paradt__keyed_sort(paradt__keyed *keyed, paradt__keyed *other, size_t count, int bits, int across) {
    paradt_index place[(1 << PARADT__MOST_DIGIT_BITS) + 1];
    paradt__keyed_sort_by(place, keyed, other, count, bits, across);
}

// The lattice that points are put on: 2^levels places along the longest side of their box. Its units are of one size,
// or steps from one double to the next, so that a side has 2^64 of them at most however many scales it spans.
typedef struct paradt__lattice {
    int dim, levels, shift;
    int by_steps;
    int exponent[PARADT_MAX_DIM]; // of the unit along each axis
    int64_t low[PARADT_MAX_DIM];
} paradt__lattice;

// x in units of 2^(exponent - 9), cut off. Its own exponent (paradt__split) is at most that.
PARADT__INLINE int64_t paradt__fixed_point(double x, int exponent) {
    int own;
    uint64_t size = paradt__split(x, &own) << 9, negative = 0 - (paradt__bits(x) >> 63);
    size = exponent - own < 63 ? size >> (exponent - own) : 0;
    return (int64_t)((size ^ negative) - negative);
}

// So many levels, or some more that take the same steps
static int paradt__whole_steps(int levels, int dim) {
    int step = PARADT__STEP_BITS / dim;
    return step > 1 ? (levels + step - 1) / step * step : levels;
}

// How many levels tell nearly all of so many points apart, if they are spread evenly
static int paradt__levels_for(size_t count, int dim) {
    int most = PARADT__CURVE_BITS / dim < 31 ? PARADT__CURVE_BITS / dim : 31;
    int levels = paradt__whole_steps((paradt__bit_length(count) + 10) / dim + 1, dim);
    return levels < most ? levels : most;
}

// The coordinate of a point of the box, in the lattice's units.
PARADT__INLINE uint64_t paradt__lattice_place(const paradt__lattice *lattice, int axis, double x) {
    int64_t place = lattice->by_steps ? paradt__ordered_bits(x) : paradt__fixed_point(x, lattice->exponent[axis]);
    return (uint64_t)place - (uint64_t)lattice->low[axis];
}

// The units along each axis: such that all of the box fits into 62 bits. On axes without extent all places are 0.
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

// low, high: the corners of the points' box, as ordered bits. If it has an extent, its corners get different places.
static void paradt__lattice_begin(paradt__lattice *lattice, int dim, int levels, int by_steps, const int64_t *low,
                                  const int64_t *high) {
    uint64_t longest = 0;
    int axis;
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

// One level of Hilbert's curve in `dim` dimensions: takes one bit of each coordinate to `dim` bits of the position on
// the curve, and the orientation of the curve (entry corner and direction) to that inside the orthant (Hamilton,
// "Compact Hilbert indices", Dalhousie University, CS-2006-07).
PARADT__INLINE unsigned paradt__hilbert_step(int dim, unsigned bits, unsigned *entry, unsigned *direction) {
    unsigned n = (unsigned)dim, all = (1u << n) - 1, turn = *direction + 1, place, start;
    bits ^= *entry;
    bits = (bits >> turn | bits << (n - turn)) & all;
    place = bits;
    place ^= place >> 1;
    place ^= place >> 2;
    place ^= place >> 4;
    start = (place - (place != 0)) & ~1u;
    start ^= start >> 1;
    *entry ^= (start << turn | start >> (n - turn)) & all;
    // by the ones at the end of an odd place and those of the place before an even one
    *direction = (turn + (unsigned)paradt__trailing_zeros(((place + 1) & ~1u) | 1u << n)) % n;
    return place;
}

// In two and three dimensions the steps come from tables: by the orientation and the bits of the coordinates, the
// first coordinate's lowest, the bits of the position and above them the next orientation.
typedef struct paradt__hilbert {
    int dim;
    int many;                                                                     // 1: there are steps
    uint16_t step[PARADT__TURNS << 3], steps[PARADT__TURNS << PARADT__STEP_BITS]; // of one level, of 6 / dim
} paradt__hilbert;

// Several levels one after another.
static uint16_t paradt__hilbert_steps(const paradt__hilbert *hilbert, unsigned turn, unsigned coordinates) {
    unsigned dim = (unsigned)hilbert->dim, levels = PARADT__STEP_BITS / dim, key = 0, level, j;
    for (level = levels; level-- > 0;) {
        unsigned bits = 0, step;
        for (j = 0; j < dim; j++) bits |= (coordinates >> (j * levels + level) & 1) << j;
        step = hilbert->step[turn << dim | bits];
        key = key << dim | (step & ((1u << dim) - 1));
        turn = step >> dim;
    }
    return (uint16_t)(turn << PARADT__STEP_BITS | key);
}

// The steps of one level: in every orientation they are those of the first one, turned and mirrored. Inlined with a
// constant.
PARADT__INLINE void paradt__hilbert_table(paradt__hilbert *hilbert, int dim) {
    unsigned n = (unsigned)dim, all = (1u << n) - 1, bits, corner, turn;
    for (bits = 0; bits <= all; bits++) {
        unsigned entry = 0, direction = n - 1, place = paradt__hilbert_step(dim, bits, &entry, &direction);
        for (turn = 1; turn <= n; turn++) {
            unsigned turned = (bits << turn | bits >> (n - turn)) & all;
            unsigned leave = (entry << turn | entry >> (n - turn)) & all, next = (direction + turn) % n;
            for (corner = 0; corner <= all; corner++) {
                unsigned from = (corner * n + turn - 1) << n | (turned ^ corner);
                hilbert->step[from] = (uint16_t)(((leave ^ corner) * n + next) << n | place);
            }
        }
    }
}

// For `count` points, about
static void paradt__hilbert_begin(paradt__hilbert *hilbert, int dim, size_t count) {
    unsigned turns = (unsigned)dim << dim, turn, bits;
    hilbert->dim = dim;
    hilbert->many = dim > 1 && dim < 4 && count >= PARADT__MANY_KEYS;
    if (dim == 3) paradt__hilbert_table(hilbert, 3);
    if (dim == 2) paradt__hilbert_table(hilbert, 2);
    for (turn = 0; hilbert->many && turn < turns; turn++) {
        for (bits = 0; bits < 1u << PARADT__STEP_BITS; bits++)
            hilbert->steps[turn << PARADT__STEP_BITS | bits] = paradt__hilbert_steps(hilbert, turn, bits);
    }
}

// By a table with steps of so many levels; inlined with constants.
PARADT__INLINE uint64_t paradt__curve_key_by(const uint16_t *table, int dim, int step_levels, const uint32_t *x,
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

// The position on the curve of a point of the lattice's box: of dim * levels bits.
PARADT__INLINE uint64_t paradt__curve_key(const paradt__hilbert *hilbert, const paradt__lattice *lattice,
                                          const double *point) {
    uint32_t x[PARADT_MAX_DIM];
    uint64_t key = 0;
    unsigned entry = 0, direction = 0;
    int levels = lattice->levels, dim = lattice->dim, level, j;
    for (j = 0; j < dim; j++) x[j] = (uint32_t)(paradt__lattice_place(lattice, j, point[j]) >> lattice->shift);
    if (dim == 3 && hilbert->many) return paradt__curve_key_by(hilbert->steps, 3, 2, x, levels);
    if (dim == 2 && hilbert->many) return paradt__curve_key_by(hilbert->steps, 2, 3, x, levels);
    if (dim == 3) return paradt__curve_key_by(hilbert->step, 3, 1, x, levels);
    if (dim == 2) return paradt__curve_key_by(hilbert->step, 2, 1, x, levels);
    for (level = levels - 1; level >= 0; level--) {
        unsigned bits = 0;
        for (j = 0; j < dim; j++) bits |= (x[j] >> level & 1) << j;
        key = key << dim | paradt__hilbert_step(dim, bits, &entry, &direction);
    }
    return key;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>cuts
//
// Space is divided into boxes, one for each region, by cutting a box in two again and again: at the coordinate that
// gives each side its share of the points (bisection), or of the volume (uniform). A point on a cut belongs to the
// upper side; the outer boxes are unbounded. The upper side's boxes come first. Where exactly the cuts are does not
// matter but for speed, so a sample of the points tells.
// Doors: paradt__cutter_divide, paradt__cuts_find, paradt__cuts_nearest, paradt__cuts_box, paradt__cuts_end,
// paradt__spacing.

typedef struct paradt__cut {
    double at;
    int axis;
    size_t begin; // of the box below, in a set that is in the order of the boxes
} paradt__cut;

typedef struct paradt__cuts {
    size_t boxes;
    paradt_partition partition;
    int spares;       // box 0 gets more points than others: by insertion its region is spared what the others' do
    int opens;        // each region's own points may want others' behind them: by insertion
    paradt__cut *cut; // [boxes] cut[i] is between the boxes before i and those from i on, none for 0
} paradt__cuts;

PARADT__INLINE int paradt__cut_is_above(const paradt__cut *cut, const double *x) {
    return paradt__ordered_bits(cut->at) > paradt__ordered_bits(x[cut->axis]);
}

// The box of a point. Without a branch for the side: half of them would be foreseen wrongly.
PARADT__INLINE size_t paradt__cuts_find(const paradt__cuts *cuts, const double *x) {
    size_t first = 0, boxes = cuts->boxes;
    while (boxes > 1) {
        size_t below = (size_t)paradt__cut_is_above(cuts->cut + first + boxes / 2, x);
        first += boxes / 2 * below;
        boxes = boxes / 2 + (boxes & below);
    }
    return first;
}

// The cut nearest to x of those around its box, of several the first; NULL: there is none. Distances are rounded: all
// that counts is that they never get smaller as a point moves away from the cut.
static const paradt__cut *paradt__cuts_nearest(const paradt__cuts *cuts, const double *x) {
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

// Bounds of a box, where it has any, in place of low and high.
static void paradt__cuts_box(const paradt__cuts *cuts, size_t box, double *low, double *high) {
    size_t first = 0, boxes = cuts->boxes;
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

// Where a box ends in a set of `count` points in the order of the boxes.
static size_t paradt__cuts_end(const paradt__cuts *cuts, size_t box, size_t count) {
    return box + 1 < cuts->boxes ? cuts->cut[box + 1].begin : count;
}

// A key near the nth smallest: that of a sample.
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

// The nth smallest key (quickselect).
static int64_t paradt__select_key(int64_t *keys, size_t count, size_t nth) {
    size_t begin = 0, end = count;
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

// The axis along which a box is longest, the first of several.
static int paradt__longest_axis(const double *low, const double *high, int dim) {
    int axis, longest = 0;
    for (axis = 1; axis < dim; axis++) {
        if (high[axis] * 0.5 - low[axis] * 0.5 > high[longest] * 0.5 - low[longest] * 0.5) longest = axis;
    }
    return longest;
}

// How far neighbours are from each other where points are dense: the median of the longest sides of some boxes of eight
// neighbours along a curve. order: that of the points (NULL: as they are)
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

// More points that a set in the order of the boxes has room for
static size_t paradt__cuts_spare(const paradt__cuts *cuts, size_t count) {
    return cuts && cuts->opens && cuts->boxes > 1 ? count / 8 + 64 * cuts->boxes : 0;
}

// A sample of points that is divided
typedef struct paradt__cutter {
    paradt__cuts *cuts;
    int dim;
    const double *sample; // [count][dim]
    paradt_index *points; // [count] permuted, so that a box is a range
    int64_t *keys;        // [count] room for the coordinates of a box along one axis, as ordered bits
    size_t count;
    size_t extra; // points that box 0 gets more than the others
} paradt__cutter;

PARADT__INLINE int64_t paradt__cutter_key(const paradt__cutter *c, paradt_index point, int axis) {
    return paradt__ordered_bits(c->sample[(size_t)point * (size_t)c->dim + (size_t)axis]);
}

// Bounding box of the points of a range, which are some.
static void paradt__cutter_bound(const paradt__cutter *c, size_t begin, size_t end, double *low, double *high) {
    int axis;
    size_t i;
    for (axis = 0; axis < c->dim; axis++) {
        int64_t least = INT64_MAX, most = INT64_MIN;
        for (i = begin; i < end; i++) {
            int64_t key = paradt__cutter_key(c, c->points[i], axis);
            least = key < least ? key : least;
            most = key > most ? key : most;
        }
        low[axis] = paradt__from_ordered_bits(least);
        high[axis] = paradt__from_ordered_bits(most);
    }
}

// Where to cut a box, above for the first half of `boxes`, one of which is to have `extra` points more.
static double paradt__cutter_place(const paradt__cutter *c, size_t begin, size_t end, size_t boxes, size_t extra,
                                   int axis, const double *low, const double *high) {
    double above = (double)(boxes / 2) / (double)boxes;
    size_t count = end - begin, even = count - (extra < count ? extra : 0), i;
    if (c->cuts->partition == PARADT_UNIFORM || begin == end) return low[axis] * above + high[axis] * (1.0 - above);
    for (i = begin; i < end; i++) c->keys[i - begin] = paradt__cutter_key(c, c->points[i], axis);
    return paradt__from_ordered_bits(paradt__select_key(c->keys, count, (size_t)((double)even * (1.0 - above))));
}

// Cuts the boxes from `first` on out of one, which has the points of a range. low, high: its bounds, or those of all.
static void paradt__cutter_divide(paradt__cutter *c, size_t begin, size_t end, const double *low, const double *high,
                                  size_t first, size_t boxes) {
    double below[PARADT_MAX_DIM], above[PARADT_MAX_DIM], cut_low[PARADT_MAX_DIM], cut_high[PARADT_MAX_DIM];
    size_t i, middle = begin, bytes = sizeof(double) * (size_t)c->dim;
    paradt__cut *cut = c->cuts->cut + first + boxes / 2;
    if (boxes == 1) return;
    memcpy(below, low, bytes);
    memcpy(above, high, bytes);
    if (c->cuts->partition == PARADT_BISECTION && begin < end && boxes < c->cuts->boxes)
        paradt__cutter_bound(c, begin, end, below, above);
    cut->axis = paradt__longest_axis(below, above, c->dim);
    cut->at = paradt__cutter_place(c, begin, end, boxes, first ? 0 : c->extra, cut->axis, below, above);
    for (i = begin; i < end; i++) {
        paradt_index point = c->points[i];
        c->points[i] = c->points[middle];
        c->points[middle] = point;
        middle += (size_t)(paradt__cutter_key(c, point, cut->axis) >= paradt__ordered_bits(cut->at));
    }
    memcpy(cut_low, below, bytes);
    memcpy(cut_high, above, bytes);
    cut_low[cut->axis] = cut_high[cut->axis] = cut->at;
    paradt__cutter_divide(c, begin, middle, cut_low, above, first, boxes / 2);
    paradt__cutter_divide(c, middle, end, below, cut_high, first + boxes / 2, boxes - boxes / 2);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>points
//
// The caller's points become a set of records: finite, distinct, -0.0 made 0.0, scaled by a power of two where that
// loses no bit, and with the coordinates permuted so that the first `dim` of them orient (dim: the affine dimension).
// The axes are taken greedily from the first to the last, so the lexicographic order over them equals that over all
// coordinates: a coordinate passed over is an affine function of those taken before it. The records are in the order of
// a curve, in which equal points are neighbours; where space is divided, box after box.
// What looks at all points is shared out to tasks. Doors: paradt__set_load, paradt__set_gather, paradt__set_free,
// paradt__span, paradt__record.


enum {
    PARADT__UNGRADED,
    PARADT__WEIGHT,
    PARADT__SAGITTA // weight and lift in one: r^2 - |x - o|^2 for the reference sphere of the set
};

typedef struct paradt__set {
    paradt__space space;
    size_t count;       // distinct points
    int grade;          // what follows a record's coordinates: nothing, its weight, or its sagitta (see below)
    double grade_error; // sagittas: bound on the error of each
    double grade_limit; // ... and on their size
    double centre[PARADT_MAX_DIM]; // ... and the reference sphere's centre
    int exponent;                  // the largest of a coordinate, with IEEE's bias, when it was read
    size_t width;                  // doubles a record
    double *records;               // [count][width]
    paradt_index *origin;          // [count] the caller's index of the point
    size_t capacity;               // points that there is room for
    int axes[PARADT_MAX_DIM];      // the caller's coordinate that stands at each place
} paradt__set;

PARADT__INLINE const double *paradt__record(const paradt__set *set, paradt_index point) {
    return set->records + (size_t)point * set->width;
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

// A float as a double, through the bits: a processor told to treat subnormal floats as zero would lose them.
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

// Where the caller has a point.
PARADT__INLINE const char *paradt__address(const paradt_points *points, size_t point) {
    size_t size = points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double);
    return (const char *)points->data + point * (points->stride ? points->stride : size * (size_t)points->dim);
}

// Passes over all points ask for them so far ahead of their use: processors do that themselves, but only within a page.
enum { PARADT__POINTS_AHEAD = 64 };

// Fetches a point, if there is one of that number. It may lie across the border of two of the cache's lines.
PARADT__INLINE void paradt__fetch_point(const paradt_points *points, size_t point) {
    size_t size = (points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double)) * (size_t)points->dim;
    size_t begin = point * (points->stride ? points->stride : size);
    PARADT__FETCH((const char *)points->data, begin);
    PARADT__FETCH((const char *)points->data, begin + size - 1);
}

// -0.0 as 0.0
PARADT__INLINE double paradt__signless_zero(uint64_t bits) {
    return paradt__from_bits(bits << 1 ? bits : 0);
}

// The coordinates of a point, -0.0 as 0.0. Two loops, so that compilers unroll the short one.
PARADT__INLINE void paradt__coordinates(const paradt_points *points, size_t point, double *x) {
    const char *address = paradt__address(points, point);
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

static uint64_t paradt__hash_coordinates(const double *record, int ambient) {
    uint64_t h = 0, bits;
    int axis;
    for (axis = 0; axis < ambient; axis++) {
        memcpy(&bits, record + axis, sizeof bits);
        h = paradt__mix(h + bits) + UINT64_C(0x9e3779b97f4a7c15);
    }
    return h;
}

// The caller's points, or points with weights among them
typedef struct paradt__source {
    paradt_points points;
    size_t weight_stride; // bytes from one weight to the next
    size_t spare;         // more points that the records are to have room for
} paradt__source;

static paradt__source paradt__source_of(const paradt_points *points) {
    paradt__source source;
    source.points = *points;
    source.weight_stride = sizeof(double);
    source.spare = 0;
    return source;
}

// The weight of a point, -0.0 as 0.0
static double paradt__weight(const paradt__source *source, size_t point) {
    uint64_t bits;
    memcpy(&bits, (const char *)source->points.weights + point * source->weight_stride, sizeof bits);
    return paradt__signless_zero(bits);
}

// Reads a record. Returns the largest exponent of a coordinate, biased: 2047 when it or the weight is no number.
PARADT__INLINE int paradt__read_record(const paradt__source *source, size_t point, double *record) {
    const paradt_points *points = &source->points;
    int axis, dim = points->dim, largest = 0;
    paradt__coordinates(points, point, record);
    for (axis = 0; axis < dim; axis++) {
        int exponent = paradt__biased_exponent(record[axis]);
        largest = exponent > largest ? exponent : largest;
    }
    if (!points->weights) return largest;
    record[dim] = paradt__weight(source, point);
    return paradt__is_finite(record[dim]) ? largest : 2047;
}

enum {
    PARADT__FIRST_DIGITS = 2 * PARADT__DIGITS,
    PARADT__FEW_SAMPLED = 1 << 9 // enough to tell whether points are crowded
};

typedef struct paradt__loader {
    const paradt__team *team;
    const paradt__source *source;
    paradt__set *set;
    paradt_index *representative;         // [points.count]
    size_t bad[PARADT__MOST_TASKS];       // first point with a coordinate or weight that is no number; SIZE_MAX: none
    size_t repeating[PARADT__MOST_TASKS]; // points that are not the first at their place
    paradt__space space[PARADT__MOST_TASKS];
    paradt__cuts *cuts; // where there is more than one box; or NULL
    double *sample;     // [sampled][dim] points that tell how they are spread, in the set's records
    size_t sampled;
    int shift; // of a key's first digit, which has a bit more where there are boxes: that is a key's upper part then
    size_t digits; // values that it may have
    paradt__hilbert hilbert;
    paradt__lattice lattice;
    paradt__keyed *keyed, *other; // [points.count], the other in the set's records
    // By a key's first digit, where the task's next such point goes
    size_t place[PARADT__MOST_TASKS][PARADT__FIRST_DIGITS];
} paradt__loader;

static void paradt__loader_begin(paradt__loader *loader, paradt__set *set, const paradt__team *team) {
    memset(loader, 0, offsetof(paradt__loader, hilbert));
    loader->set = set;
    loader->team = team;
}

// The positions of `count` that are a task's: [*begin, its result).
static size_t paradt__loader_share(const paradt__loader *loader, size_t count, size_t index, size_t *begin) {
    size_t tasks = loader->team->tasks;
    *begin = count / tasks * index;
    return index + 1 == tasks ? count : count / tasks * (index + 1);
}

// Looks at all coordinates of a task's points [i, end).
PARADT__INLINE void paradt__survey(paradt__loader *loader, size_t index, size_t i, size_t end, int dim) {
    paradt__source source = *loader->source; // copies, that no store through a pointer can change
    paradt__space space = loader->space[index];
    double record[PARADT_MAX_DIM + 1];
    source.points.dim = space.ambient = dim;
    for (; i < end; i++) {
        paradt__read_record(&source, i, record);
        paradt__fetch_point(&source.points, i + PARADT__POINTS_AHEAD);
        paradt__space_add(&space, record);
        loader->representative[i] = (paradt_index)i;
    }
    loader->space[index] = space;
}

// The first point from i on that has a coordinate or weight that is no number. There is one.
static size_t paradt__first_bad(const paradt__source *source, size_t i) {
    double record[PARADT_MAX_DIM + 1];
    while (paradt__read_record(source, i, record) < 2047) i++;
    return i;
}

// All points make loader->sampled equal shares. Samples a point of each of the shares [i, end), at random: a regular
// choice might meet a pattern of the points.
static void paradt__sample(paradt__loader *loader, size_t i, size_t end) {
    const paradt_points *points = &loader->source->points;
    double step = i < end ? (double)points->count / (double)loader->sampled : 0.0;
    for (; i < end; i++) {
        size_t from = (size_t)(step * (double)i), to = (size_t)(step * (double)(i + 1));
        size_t point = from + (to > from ? (size_t)(paradt__mix(i) % (to - from)) : 0);
        paradt__coordinates(points, point, loader->sample + i * (size_t)points->dim);
    }
}

// Makes the pages of a task's part of the arrays that are filled from now on.
static void paradt__loader_pages(const paradt__loader *loader, size_t index) {
    size_t record = loader->set->width * sizeof(double), first;
    size_t end = paradt__loader_share(loader, loader->source->points.count, index, &first);
    paradt__make_pages(loader->keyed, first * sizeof *loader->keyed, end * sizeof *loader->keyed);
    paradt__make_pages(loader->set->records, first * record, end * record);
    paradt__make_pages(loader->set->origin, first * sizeof(paradt_index), end * sizeof(paradt_index));
    paradt__make_pages(loader->representative, first * sizeof(paradt_index), end * sizeof(paradt_index));
}

// How many of the sample's shares end up to a point. In integers: where a task ends the next one begins.
static size_t paradt__shares_until(const paradt__loader *loader, size_t point) {
    return (size_t)((uint64_t)point * loader->sampled / loader->source->points.count);
}

// The points are sampled while they are in the cache.
static void paradt__survey_task(void *context, size_t index) {
    enum { TOGETHER = 1 << 12 };
    paradt__loader *loader = (paradt__loader *)context;
    int dim = loader->source->points.dim;
    size_t i, next, end = paradt__loader_share(loader, loader->source->points.count, index, &i);
    paradt__loader_pages(loader, index);
    loader->space[index] = loader->set->space;
    loader->bad[index] = SIZE_MAX;
    for (; i < end && loader->bad[index] == SIZE_MAX; i = next) {
        next = end - i < TOGETHER ? end : i + TOGETHER;
        if (dim == 3) paradt__survey(loader, index, i, next, 3);
        else paradt__survey(loader, index, i, next, dim);
        if (!paradt__space_is_finite(&loader->space[index])) loader->bad[index] = paradt__first_bad(loader->source, i);
        paradt__sample(loader, paradt__shares_until(loader, i), paradt__shares_until(loader, next));
    }
}

// Measures the set. *bad is the first point with a coordinate or weight that is no number.
static paradt_status paradt__set_survey(paradt__loader *loader, size_t *bad) {
    paradt__set *set = loader->set;
    size_t i;
    paradt__team_run(loader->team, paradt__survey_task, loader);
    for (i = 0; i < loader->team->tasks; i++) {
        if (loader->bad[i] == SIZE_MAX) continue;
        *bad = loader->bad[i];
        return PARADT_ERROR_NOT_FINITE;
    }
    for (i = 0; i < loader->team->tasks; i++) paradt__space_join(&set->space, &loader->space[i]);
    set->exponent = paradt__max(set->space.coordinates.top + 1022, 0);
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>order
//
// Doors: to be listed.

PARADT__INLINE uint64_t paradt__loader_key(const paradt__loader *loader, const paradt__lattice *lattice, size_t point) {
    double x[PARADT_MAX_DIM];
    paradt__coordinates(&loader->source->points, point, x);
    return paradt__curve_key(&loader->hilbert, lattice, x);
}

// Sorts points with the same key by a lattice of their own box. Returns 0 if they are equal: their keys say so then.
// other: room for as many.
static int paradt__split_run(const paradt__loader *loader, paradt__keyed *run, paradt__keyed *other, size_t count,
                             int by_steps) {
    paradt__lattice lattice;
    int64_t low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    int dim = loader->source->points.dim, levels = paradt__levels_for(count, dim), axis, equal = 1;
    size_t i;
    for (i = 0; i < count; i++) {
        double record[PARADT_MAX_DIM];
        paradt__coordinates(&loader->source->points, (size_t)run[i].point, record);
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
    for (i = 0; i < count; i++) run[i].key = paradt__loader_key(loader, &lattice, (size_t)run[i].point);
    paradt__keyed_sort(run, other, count, dim * levels, 0);
    return 1;
}

// Ends the sorting of points that are sorted by keys: those with the same key are sorted again, until they differ or
// are known to be equal. The keys then tell whether a point equals the one before. The longest run is left to the loop,
// so the recursion is no deeper than the logarithm of count. Where most points remain together, a few far away are the
// reason, and others behind them, on scale after scale: after many passes by units, steps leave no more than 64 /
// levels of them.
static void paradt__refine(const paradt__loader *loader, paradt__keyed *keyed, paradt__keyed *other, size_t count) {
    enum { PASSES = 20 };
    size_t all = count, looked_at = 0;
    for (;;) {
        size_t begin, end, longest = 0, length = 1;
        for (begin = 0; begin < count; begin = end) {
            uint64_t key = keyed[begin].key;
            size_t run = begin, size;
            for (end = begin + 1; end < count && keyed[end].key == key;) end++;
            size = end - begin;
            if (size == 1) {
                keyed[begin].key = 0;
                continue;
            }
            if (size > length) { // the one that was the longest is dealt with instead
                size_t was = length;
                run = longest;
                longest = begin;
                length = size;
                size = was;
            }
            if (size > 1 && paradt__split_run(loader, keyed + run, other + run, size, 0))
                paradt__refine(loader, keyed + run, other + run, size);
        }
        looked_at += length;
        if (length == 1 ||
            !paradt__split_run(loader, keyed + longest, other + longest, length, looked_at / PASSES > all))
            return;
        keyed += longest;
        other += longest;
        count = length;
    }
}

// --- cuts by a sample

// Puts a few points of the sample along a curve: the first of loader->keyed, which has room for twice as many.
static void paradt__sort_few(const paradt__loader *loader, const paradt__hilbert *hilbert, size_t few, int levels) {
    int dim = loader->source->points.dim;
    paradt__keyed *keyed = loader->keyed;
    paradt__lattice lattice;
    size_t i;
    paradt__lattice_begin(&lattice, dim, levels, 0, loader->set->space.low, loader->set->space.high);
    for (i = 0; i < few; i++) {
        keyed[i].point = (paradt_index)((double)loader->sampled / (double)few * (double)i);
        keyed[i].key = paradt__curve_key(hilbert, &lattice, loader->sample + (size_t)keyed[i].point * (size_t)dim);
    }
    paradt__keyed_sort(keyed, keyed + few, few, dim * levels, 0);
}

// How far points of the set are from their neighbours: 2^k times as far are those of one in 2^(k dim) points, such as
// are put along a curve here, where they are spread in all dimensions.
static double paradt__sample_spacing(const paradt__loader *loader) {
    enum { FEW = 1 << 12 };
    size_t count = loader->source->points.count, few = count, i;
    int dim = loader->source->points.dim;
    double nearer = 1.0;
    paradt__hilbert hilbert;
    paradt_index *order;
    do {
        few >>= dim;
        nearer *= 0.5;
    } while (few > FEW);
    paradt__hilbert_begin(&hilbert, dim, few);
    paradt__sort_few(loader, &hilbert, few, paradt__levels_for(few, dim));
    order = (paradt_index *)(void *)(loader->keyed + 2 * few);
    for (i = 0; i < few; i++) order[i] = loader->keyed[i].point;
    return nearer * paradt__spacing(loader->sample, (size_t)dim, dim, order, few);
}

// Points of the sample that box 0 gets more than others, since by insertion its region takes in none of theirs and asks
// about no cell: so many times what there is in a margin beside a cut through all. Measured on uniform points.
static size_t paradt__sample_extra(const paradt__loader *loader, int axis) {
    enum { SOME = 1 << 11, WIDTH = 4 }; // of the part looked at, in margins
    int64_t keys[SOME];
    double margin = 0.7 * paradt__sample_spacing(loader), middle, extra, most;
    size_t dim = (size_t)loader->source->points.dim, count = loader->sampled, i, beside = 0;
    const double *x = loader->sample + axis;
    for (i = 0; i < SOME; i++) {
        size_t point = (size_t)((double)count * (double)i / (double)SOME);
        keys[i] = paradt__ordered_bits(x[point * dim]);
    }
    middle = paradt__from_ordered_bits(paradt__select_key(keys, SOME, SOME / 2));
    for (i = 0; i < count && margin > 0.0; i++)
        beside += paradt__abs(x[i * dim] - middle) < margin * 0.5 * (double)WIDTH;
    extra = 2.2 * (double)beside / (double)WIDTH;
    most = (double)count / 4.0 / (double)loader->cuts->boxes;
    return (size_t)(extra < most ? extra : most);
}

// Finds the cuts by the sample, in memory that is filled later.
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
    cutter.extra = loader->cuts->spares ? paradt__sample_extra(loader, paradt__longest_axis(low, high, dim)) : 0;
    cutter.keys = (int64_t *)(void *)loader->keyed;
    cutter.points = (paradt_index *)(void *)(cutter.keys + cutter.count);
    for (i = 0; i < cutter.count; i++) cutter.points[i] = (paradt_index)i;
    paradt__cutter_divide(&cutter, 0, cutter.count, low, high, 0, loader->cuts->boxes);
}

// Notes where each box begins in the set, whose records are as they were read.
static void paradt__loader_bound(paradt__loader *loader) {
    const paradt__set *set = loader->set;
    paradt__cuts *cuts = loader->cuts;
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

// --- sorted by keys

PARADT__INLINE size_t paradt__first_digit(const paradt__loader *loader, uint64_t key) {
    return (size_t)(key >> loader->shift);
}

// Makes the keys of a task's points.
PARADT__INLINE void paradt__make_keys(paradt__loader *loader, size_t index, int dim) {
    paradt_points points = loader->source->points; // copies, that no store through a pointer can change
    paradt__lattice lattice = loader->lattice;
    paradt__keyed *keyed = loader->keyed;
    size_t i, end = paradt__loader_share(loader, points.count, index, &i), *count = loader->place[index];
    int bits = dim * lattice.levels;
    points.dim = lattice.dim = dim;
    memset(count, 0, loader->digits * sizeof *count);
    for (; i < end; i++) {
        double x[PARADT_MAX_DIM];
        uint64_t key;
        paradt__coordinates(&points, i, x);
        paradt__fetch_point(&points, i + PARADT__POINTS_AHEAD);
        key = paradt__curve_key(&loader->hilbert, &lattice, x);
        if (loader->cuts) key |= (uint64_t)paradt__cuts_find(loader->cuts, x) << bits;
        keyed[i].key = key;
        keyed[i].point = (paradt_index)i;
        count[paradt__first_digit(loader, key)]++;
    }
}

static void paradt__key_task(void *context, size_t index) {
    paradt__loader *loader = (paradt__loader *)context;
    if (loader->lattice.dim == 3) paradt__make_keys(loader, index, 3);
    else paradt__make_keys(loader, index, loader->lattice.dim);
}

static void paradt__scatter_task(void *context, size_t index) {
    paradt__loader *loader = (paradt__loader *)context;
    size_t i, end = paradt__loader_share(loader, loader->source->points.count, index, &i),
              *place = loader->place[index];
    for (; i < end; i++) {
        PARADT__FETCH(loader->keyed, i + PARADT__POINTS_AHEAD);
        loader->other[place[paradt__first_digit(loader, loader->keyed[i].key)]++] = loader->keyed[i];
    }
}

// Sorts the points with the first digits that end in the task's share.
static void paradt__sort_task(void *context, size_t index) {
    paradt__loader *loader = (paradt__loader *)context;
    const size_t *ends = loader->place[loader->team->tasks - 1]; // scattered, the last task's next places are the ends
    size_t share, last = paradt__loader_share(loader, loader->source->points.count, index, &share), begin = 0, digit;
    for (digit = 0; digit < loader->digits; begin = ends[digit++]) {
        size_t count = ends[digit] - begin;
        if (!count || ends[digit] <= share || ends[digit] > last) continue;
        paradt__keyed_sort(loader->other + begin, loader->keyed + begin, count, loader->shift, 1);
        paradt__refine(loader, loader->keyed + begin, loader->other + begin, count);
    }
}

// Would many points share places of a lattice with so many levels? Then it takes less time to make keys of more levels
// than to sort those points anew. A few tell, on a lattice with so many levels less that they share as many places if
// they lie on surfaces. Where they fill space they share more, but few still.
static int paradt__loader_crowded(const paradt__loader *loader, int levels) {
    enum { SHARE = 32 }; // one in so many is many
    size_t count = loader->source->points.count, few = PARADT__FEW_SAMPLED, shared = 0, i;
    if (few > count / 2) few = count / 2;
    if (!few || !loader->sampled) return 0;
    levels -= (paradt__bit_length(count / few) - 1) / 2;
    levels = paradt__whole_steps(paradt__max(levels, 1), loader->source->points.dim);
    paradt__sort_few(loader, &loader->hilbert, few, levels);
    for (i = 1; i < few; i++) shared += loader->keyed[i].key == loader->keyed[i - 1].key;
    return shared > few / SHARE;
}

// The order of the points along the curve, box after box, in loader->keyed.
static void paradt__loader_sort(paradt__loader *loader) {
    size_t count = loader->source->points.count, tasks = loader->team->tasks, before = 0, digit, i;
    int dim = loader->set->space.ambient, levels = paradt__levels_for(count, dim), step = PARADT__STEP_BITS / dim;
    int box_bits = loader->cuts ? paradt__bit_length(loader->cuts->boxes - 1) : 0;
    int digit_bits = paradt__min(paradt__bit_length(count), PARADT__DIGIT_BITS) + (box_bits > 0);
    paradt__hilbert_begin(&loader->hilbert, dim, count);
    if (paradt__loader_crowded(loader, levels)) levels = paradt__levels_for(SIZE_MAX, dim);
    while (dim * levels + box_bits > 64) levels -= step > 1 ? step : 1;
    loader->shift = paradt__max(dim * levels + box_bits - digit_bits, 0);
    loader->digits = (size_t)1 << (dim * levels + box_bits - loader->shift);
    paradt__lattice_begin(&loader->lattice, dim, levels, 0, loader->set->space.low, loader->set->space.high);
    paradt__team_run(loader->team, paradt__key_task, loader);
    for (digit = 0; digit < loader->digits; digit++) {
        for (i = 0; i < tasks; i++) {
            size_t here = loader->place[i][digit];
            loader->place[i][digit] = before;
            before += here;
        }
    }
    paradt__team_run(loader->team, paradt__scatter_task, loader);
    paradt__team_run(loader->team, paradt__sort_task, loader);
}

static void paradt__gather_task(void *context, size_t index) {
    enum { AHEAD = PARADT__POINTS_AHEAD / 2 };
    paradt__loader *loader = (paradt__loader *)context;
    paradt__set *set = loader->set;
    size_t i, end = paradt__loader_share(loader, loader->source->points.count, index, &i), repeating = 0;
    for (; i < end; i++) {
        size_t soon = i + AHEAD < end ? i + AHEAD : i;
        PARADT__FETCH(loader->keyed, i + PARADT__POINTS_AHEAD);
        paradt__fetch_point(&loader->source->points, (size_t)loader->keyed[soon].point);
        paradt__read_record(loader->source, (size_t)loader->keyed[i].point, set->records + i * set->width);
        set->origin[i] = loader->keyed[i].point;
        repeating += (size_t)loader->keyed[i].key;
    }
    loader->repeating[index] = repeating;
}

// Keeps one record a place. representative[i] becomes the caller's index of the point that stands for point i: the
// smallest index, with weights the largest weight first. Equal points are neighbours, in the order of their indices.
static void paradt__loader_merge(paradt__loader *loader) {
    paradt__set *set = loader->set;
    size_t kept = 0, i, width = set->width, ambient = (size_t)set->space.ambient;
    for (i = 0; i < set->count; i++) {
        const double *record = set->records + i * width;
        if (!loader->keyed[i].key) {
            if (kept < i) memcpy(set->records + kept * width, record, width * sizeof *record);
            set->origin[kept++] = loader->keyed[i].point;
        } else if (set->space.weighted) {
            double *weight = set->records + (kept - 1) * width + ambient;
            if (paradt__ordered_bits(record[ambient]) > paradt__ordered_bits(*weight)) {
                *weight = record[ambient];
                set->origin[kept - 1] = loader->keyed[i].point;
            }
        }
        loader->representative[loader->keyed[i].point] = (paradt_index)(kept - 1);
    }
    for (i = 0; i < set->count; i++) loader->representative[i] = set->origin[loader->representative[i]];
    set->count = kept;
}

// The records, of two doubles at least, are what the keys are sorted by way of, until they are filled: new pages take
// time.
static paradt_status paradt__loader_room(paradt__loader *loader, paradt__memory *memory) {
    enum { SAMPLE = 1 << 16 };
    paradt__set *set = loader->set;
    size_t count = loader->source->points.count;
    set->capacity = count + loader->source->spare;
    loader->keyed = (paradt__keyed *)paradt__alloc(memory, count, sizeof *loader->keyed);
    set->records = (double *)paradt__alloc(memory, set->capacity, set->width * sizeof(double));
    set->origin = (paradt_index *)paradt__alloc(memory, set->capacity, sizeof *set->origin);
    loader->sample = set->records;
    loader->sampled = loader->cuts ? (size_t)SAMPLE : count < PARADT__MANY_KEYS ? 0 : (size_t)PARADT__FEW_SAMPLED;
    if (loader->sampled > count) loader->sampled = count;
    if (loader->cuts) {
        loader->cuts->cut = (paradt__cut *)paradt__alloc(memory, loader->cuts->boxes, sizeof *loader->cuts->cut);
        if (!loader->cuts->cut) return PARADT_ERROR_MEMORY;
    }
    if (!loader->keyed || !set->records || !set->origin) return PARADT_ERROR_MEMORY;
    // In the middle of the records, which take two doubles a point or more, as a key does at most: so each of two tasks
    // that fill them has as many new pages to touch.
    loader->other = (paradt__keyed *)(void *)(set->records + (set->capacity * set->width - 2 * count) / 2);
    return PARADT_OK;
}

// The points of the source, each place once, along a curve, as they are: neither scaled nor with their axes in order,
// but measured. cuts: NULL, or space is divided, and the points are in the order of the boxes. *bad: see
// paradt__set_survey. representative: [points.count].
static paradt_status paradt__set_gather(paradt__set *set, const paradt__source *source, paradt__cuts *cuts,
                                        const paradt__team *team, paradt__memory *memory, paradt_index *representative,
                                        size_t *bad) {
    paradt__loader loader;
    const paradt_points *points = &source->points;
    size_t repeating = 0, i;
    paradt_status status;
    paradt__loader_begin(&loader, set, team);
    loader.source = source;
    loader.cuts = cuts && cuts->boxes > 1 ? cuts : NULL;
    loader.representative = representative;
    set->grade = points->weights ? PARADT__WEIGHT : PARADT__UNGRADED;
    set->width = (size_t)points->dim + (points->weights != NULL);
    paradt__space_begin(&set->space, points->dim, points->dim, points->weights != NULL);
    status = paradt__loader_room(&loader, memory);
    if (!status) status = paradt__set_survey(&loader, bad);
    if (!status) {
        if (loader.cuts) paradt__loader_cut(&loader);
        paradt__loader_sort(&loader);
        set->count = points->count;
        paradt__team_run(team, paradt__gather_task, &loader);
        for (i = 0; i < team->tasks; i++) repeating += loader.repeating[i];
        if (repeating) paradt__loader_merge(&loader);
        if (loader.cuts) paradt__loader_bound(&loader);
    }
    paradt__release(memory, loader.keyed);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>measures
//
// Doors: to be listed.

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

// Is x outside the affine hull of the basis, seen in the axes taken and one more?
static int paradt__extends(paradt__space *space, int taken, const double *const *basis, const int *axes,
                           const double *x) {
    double copies[PARADT_MAX_DIM + 1][PARADT_MAX_DIM + 1];
    const double *pointers[PARADT_MAX_DIM + 1];
    paradt__space view; // bounds hold for one dimension, and for coordinates at their places
    int i, j, independent;
    memset(copies, 0, sizeof copies);
    paradt__space_begin(&view, taken + 1, taken + 1, 0);
    for (i = 0; i <= taken + 1; i++) {
        const double *from = i <= taken ? basis[i] : x;
        for (j = 0; j <= taken; j++) copies[i][j] = from[axes[j]];
        pointers[i] = copies[i];
        paradt__space_add(&view, copies[i]);
    }
    paradt__space_end(&view);
    view.counters = space->counters;
    independent = paradt__orient(&view, pointers) != 0;
    space->counters = view.counters;
    return independent;
}

// Adds points to the basis and axes to the axes until they span the set: the simplex stays independent in just the axes
// taken. Points are searched for in the order (NULL: that of the set), `from` on. Returns the number of axes taken.
static int paradt__span(paradt__set *set, const paradt_index *order, const double **basis, int *axes, int taken,
                        size_t from) {
    int candidate, i, ambient = set->space.ambient;
    for (candidate = 0; candidate < ambient; candidate++) {
        size_t step;
        int known = 0;
        for (i = 0; i < taken; i++) known |= axes[i] == candidate;
        if (known) continue;
        axes[taken] = candidate;
        for (step = 0; step < set->count; step++) {
            size_t at = (from + step) % set->count;
            const double *x = paradt__record(set, order ? order[at] : (paradt_index)at);
            for (i = 0; i <= taken && basis[i] != x;) i++; // a point of the basis does not extend it
            if (i > taken && paradt__extends(&set->space, taken, basis, axes, x)) {
                basis[++taken] = x;
                break;
            }
        }
    }
    return taken;
}

// Puts the axes that orient first. Returns whether they were not.
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

static void paradt__measure_task(void *context, size_t index) {
    paradt__loader *loader = (paradt__loader *)context;
    const paradt__set *set = loader->set;
    size_t i, end = paradt__loader_share(loader, set->count, index, &i);
    loader->space[index] = set->space;
    for (; i < end; i++) paradt__space_add(&loader->space[index], set->records + i * set->width);
}

// Tells the predicates what they may rely on.
static void paradt__set_measure(paradt__set *set, const paradt__team *team, int dim) {
    paradt__space *space = &set->space;
    paradt__loader loader;
    size_t i;
    paradt__loader_begin(&loader, set, team);
    paradt__space_begin(space, dim, space->ambient, space->weighted);
    paradt__team_run(team, paradt__measure_task, &loader);
    for (i = 0; i < team->tasks; i++) paradt__space_join(space, &loader.space[i]);
    if (dim > 0) paradt__space_end(space);
}

// Tells the predicates what they may rely on, where that has been measured while the points were read.
static void paradt__set_measured(paradt__set *set, int dim) {
    set->space.dim = dim;
    memset(&set->space.counters, 0, sizeof set->space.counters);
    if (dim > 0) paradt__space_end(&set->space);
}

// Finds the affine dimension and puts the axes that orient first. *as_read is cleared when that changes records.
static int paradt__set_orient(paradt__set *set, int *as_read) {
    const double *basis[PARADT_MAX_DIM + 1];
    int axis, i, dim, taken = 0, ambient = set->space.ambient;
    if (set->count) {
        basis[0] = set->records;
        taken = paradt__span(set, NULL, basis, set->axes, 0, 0);
    }
    dim = set->count ? taken : -1;
    for (axis = 0; axis < ambient; axis++) {
        int known = 0;
        for (i = 0; i < taken; i++) known |= set->axes[i] == axis;
        if (!known) set->axes[taken++] = axis;
    }
    if (paradt__set_permute(set)) *as_read = 0;
    return dim;
}

// The cuts are where they were, of the set scaled and with its axes in order. One that is no point's coordinate may
// lose bits, which are cut off; it becomes larger instead of smaller, so that each point stays on its side.
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

// Makes the set of the caller's points. cuts: see paradt__set_gather; if they open it there is room for more points.
// representative: [points->count].
static paradt_status paradt__set_load(paradt__set *set, const paradt_points *points, paradt__cuts *cuts,
                                      const paradt__team *team, paradt__memory *memory, paradt_index *representative,
                                      size_t *bad) {
    paradt__source source = paradt__source_of(points);
    paradt_status status;
    int dim, scaled, as_read;
    memset(set, 0, sizeof *set);
    source.spare = paradt__cuts_spare(cuts, points->count);
    status = paradt__set_gather(set, &source, cuts, team, memory, representative, bad);
    if (status) return status;
    scaled = paradt__set_scale(set);
    as_read = !scaled;
    dim = paradt__set_orient(set, &as_read);
    if (cuts) paradt__cuts_follow(cuts, set, scaled);
    if (as_read) paradt__set_measured(set, dim);
    else paradt__set_measure(set, team, dim);
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>reference sphere
//
// Points on one sphere, up to rounding or noise, are the worst case of a search: every sphere through four of them is
// that sphere almost, all points are almost on it, and no box can be ruled out by its distance. T(P) does not change
// when an affine function is added to the lift, so for such a set the lift is measured from a sphere that the points
// are near to: instead of |x|^2 each record carries its sagitta r^2 - |x - o|^2, computed once in integers, with an
// error far below the noise that decides. Lifts then are as small as the noise, so are the spheres' coefficients, and a
// box is known by its largest sagitta. The floating-point search and the insertion's spheres in three dimensions use
// it; the predicates go on working with the coordinates. Doors: paradt__set_grade, paradt__centre_shift, and for sets
// that know of a part of the points each paradt__fit_sphere, paradt__set_sagittas, paradt__set_grade_bounds.

// How far the centre of the smallest sphere through o and `count` - 1 more points, whose span the rows are an
// orthonormal basis of, moves to include x too; along *row, the unit vector across the span towards x, at height
// *height.
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

// The sphere through dim + 1 points far from each other, of a sample. 0: not found, or the sample is not so near to it.
static int paradt__fit_sphere(const paradt__set *set, double nearness, double *centre, double *radius2) {
    double rows[PARADT_MAX_DIM][PARADT_MAX_DIM], row[PARADT_MAX_DIM], shift[PARADT_MAX_DIM] = {0.0}, height;
    size_t step = set->count / 64, i;
    const double *o = set->records;
    int ambient = set->space.ambient, count, j;
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

// x / 2^(top - 108), cut off to an integer, in four digits of 27 bits, the first one the highest; |x| < 2^top.
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

// r^2 - |x - o|^2, r^2 = squared * 2^(2 top - 54); o in digits. Every coordinate is cut off below 2^(top - 108), an
// error of at most d 2^(2 top - 104); the sum is exact up to its last rounding to a double, of at most 2^-48 of itself.
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

// The exponent of a power of two that is twice the radius or more and, as should be, over four times the centre's
// coordinates; but not so where the set is a small part of a sphere far away: that tells no more than a plane.
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

// Gives the records their sagittas by the sphere around set->centre, in new memory with room for so many. *nearby:
// whether all points are so near to it; if not, the set remains as it is. The largest sagitta is left in
// set->grade_limit, in set->grade_error what comes of cutting off.
static paradt_status paradt__set_sagittas(paradt__set *set, double radius2, double nearness, size_t room,
                                          paradt__memory *memory, int *nearby) {
    int ambient = set->space.ambient, top = paradt__sphere_top(set, radius2), j;
    int64_t o[PARADT_MAX_DIM][PARADT__SAGITTA_DIGITS], squared;
    double largest = 0.0, *records;
    size_t i, width = set->width;
    *nearby = radius2 < paradt__power(2 * top);
    for (j = 0; j < ambient; j++) {
        paradt__digits_of(set->centre[j], top, o[j]);
        *nearby &= paradt__abs(set->centre[j]) < 0.25 * paradt__power(top);
    }
    if (!*nearby) return PARADT_OK;
    squared = (int64_t)(radius2 * paradt__power(54 - 2 * top));
    records = (double *)paradt__alloc(memory, room, (width + 1) * sizeof(double));
    if (!records) return PARADT_ERROR_MEMORY;
    for (i = 0; i < set->count && *nearby; i++) {
        double *to = records + i * (width + 1);
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

// The bounds, if no sagitta is larger than that.
static void paradt__set_grade_bounds(paradt__set *set, double largest) {
    set->grade_limit = largest * 1.0000001;
    set->grade_error += largest * paradt__power(-48);
}

// Gives the records their sagittas, if the set is so near to a sphere.
static paradt_status paradt__set_grade(paradt__set *set, double nearness, paradt__memory *memory) {
    double radius2;
    int nearby;
    paradt_status status;
    if (set->count < 64 || set->grade || set->space.dim < set->space.ambient || !set->space.filtered) return PARADT_OK;
    if (!paradt__fit_sphere(set, nearness, set->centre, &radius2)) return PARADT_OK;
    status = paradt__set_sagittas(set, radius2, nearness, set->capacity, memory, &nearby);
    if (!status && nearby) paradt__set_grade_bounds(set, set->grade_limit);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>cells and the active face list
//
// Cells are stored as they are made. A facet is named by its handle: (dim + 1) * cell + i is the facet of `cell`
// opposite its vertex i. A facet is active while the cell on its other side is not known. The active face list (AFL) is
// a hash table with chains, keyed by the facet's vertices. The chain is chosen by the smallest vertex, so that facets
// close to each other in grid order are close in memory too: the front moves over the table as it moves over the
// points. The rest of the key, a sum over the vertices that does not depend on their order, spreads the facets of one
// vertex where there are many (in high dimension), and tells facets in a chain apart. The table itself says where to go
// on: at its lowest chain. Work lists, for methods with an order of their own, are linked lists of handles; a facet
// that was matched meanwhile stays in its list and is passed over when it comes up. Doors: paradt__cells_*,
// paradt__active_*, paradt__list_*.

// A position that no point of a set has
#define PARADT__NOWHERE ((paradt_index)(sizeof(paradt_index) == 4 ? INT32_MAX : INT64_MAX))

typedef struct paradt__cells {
    int corners;             // dim + 1
    size_t count, capacity;  // cells
    paradt_index *vertices;  // [capacity][corners]
    paradt_index *neighbors; // [capacity][corners]
    int lent;                // the arrays are parts of others: left behind when more room is needed, and not freed
} paradt__cells;

enum {
    PARADT__HULL = -1, // no cell on the other side
    PARADT__OPEN = -2  // the cell on the other side is not known
};

typedef struct paradt__slot { // of an open-addressed table of facets
    uint32_t key;
    paradt_index handle; // PARADT__OPEN: free
} paradt__slot;

typedef struct paradt__link {
    paradt_index handle, next;
    paradt_index smallest; // vertex of the facet
    uint32_t key;
} paradt__link;

typedef struct paradt__active {
    paradt_index *heads; // [mask + 1] first link of each chain, or PARADT__OPEN
    paradt__link *links;
    size_t mask, capacity;
    paradt_index fresh, spare; // first link never used, first one given back
    int spread;                // a vertex has 2^spread chains
    size_t lowest;             // the chains before it are empty
    size_t count, peak;        // active facets
} paradt__active;

typedef struct paradt__node {
    paradt_index handle, next;
} paradt__node;

typedef struct paradt__lists {
    paradt__node *nodes;
    size_t capacity;
    paradt_index fresh, spare; // first node never used, first node given back
} paradt__lists;

static void paradt__cells_free(paradt__cells *cells, paradt__memory *memory) {
    if (!cells->lent) {
        paradt__release(memory, cells->vertices);
        paradt__release(memory, cells->neighbors);
    }
    memset(cells, 0, sizeof *cells);
}

// Arrays of its own in the place of lent ones
static paradt_status paradt__cells_own(paradt__cells *cells, size_t capacity, paradt__memory *memory) {
    paradt__cells own = *cells;
    size_t used = cells->count * (size_t)cells->corners * sizeof(paradt_index);
    own.vertices = (paradt_index *)paradt__alloc(memory, capacity * (size_t)cells->corners, sizeof(paradt_index));
    own.neighbors = (paradt_index *)paradt__alloc(memory, capacity * (size_t)cells->corners, sizeof(paradt_index));
    own.capacity = capacity;
    own.lent = 0;
    if (!own.vertices || !own.neighbors) {
        paradt__cells_free(&own, memory);
        return PARADT_ERROR_MEMORY;
    }
    if (used) {
        memcpy(own.vertices, cells->vertices, used);
        memcpy(own.neighbors, cells->neighbors, used);
    }
    *cells = own;
    return PARADT_OK;
}

// How many cells have facets that can be numbered
static size_t paradt__most_cells(int corners) {
    return (size_t)(((paradt_index)-1 < 0 && sizeof(paradt_index) == 4) ? INT32_MAX : INT64_MAX) / (size_t)corners;
}

// Makes room for the cells that are needed, and for as many as are wanted if these can be numbered.
static paradt_status paradt__cells_reserve(paradt__cells *cells, size_t needed, size_t wanted, paradt__memory *memory) {
    size_t corners = (size_t)cells->corners, used = cells->count * corners, most = paradt__most_cells(cells->corners);
    size_t capacity = wanted < needed ? needed : wanted < most ? wanted : most;
    void *array = cells->vertices;
    if (needed > most) return PARADT_ERROR_TOO_LARGE;
    if (cells->lent) return paradt__cells_own(cells, capacity, memory);
    if (!paradt__grow(memory, &array, used, capacity * corners, sizeof(paradt_index))) return PARADT_ERROR_MEMORY;
    cells->vertices = (paradt_index *)array;
    array = cells->neighbors;
    if (!paradt__grow(memory, &array, used, capacity * corners, sizeof(paradt_index))) return PARADT_ERROR_MEMORY;
    cells->neighbors = (paradt_index *)array;
    cells->capacity = capacity;
    return PARADT_OK;
}

// Room for one more cell. Growing by a quarter keeps the peak at 2.25 times the result where the first guess was short.
PARADT__INLINE paradt_status paradt__cells_room(paradt__cells *cells, paradt__memory *memory) {
    if (PARADT__LIKELY(cells->count < cells->capacity)) return PARADT_OK;
    return paradt__cells_reserve(cells, cells->count + 1, cells->capacity + cells->capacity / 4 + 64, memory);
}

PARADT__INLINE uint64_t paradt__vertex_key(paradt_index vertex) {
    return ((uint64_t)vertex + 1) * UINT64_C(0x9e3779b97f4a7c15);
}

// The sum of products alone would be linear in the vertices; a square mixes it.
PARADT__INLINE uint32_t paradt__facet_key(uint64_t sum) {
    return (uint32_t)(((sum ^ sum >> 29) * UINT64_C(0xbf58476d1ce4e5b9)) >> 32);
}

PARADT__INLINE uint64_t paradt__cell_sum(const paradt_index *vertices, int corners) {
    uint64_t sum = 0;
    int i;
    for (i = 0; i < corners; i++) sum += paradt__vertex_key(vertices[i]);
    return sum;
}

// Do the two handles name the same set of vertices?
PARADT__INLINE int paradt__same_facet(const paradt__cells *cells, paradt_index a, paradt_index b, int corners) {
    int skip_a = (int)(a % corners), skip_b = (int)(b % corners), i, j, missing = 0;
    const paradt_index *x = cells->vertices + (a - skip_a), *y = cells->vertices + (b - skip_b);
    for (i = 0; i < corners; i++) {
        int met = i == skip_a;
        for (j = 0; j < corners; j++) met |= (y[j] == x[i]) & (j != skip_b);
        missing |= !met;
    }
    return !missing;
}

static void paradt__active_free(paradt__active *active, paradt__memory *memory) {
    paradt__release(memory, active->heads);
    paradt__release(memory, active->links);
    active->heads = NULL;
    active->links = NULL;
}

PARADT__INLINE paradt_index *paradt__active_chain(const paradt__active *active, paradt_index smallest, uint32_t key) {
    size_t place = (size_t)smallest << active->spread | (key & (((size_t)1 << active->spread) - 1));
    return active->heads + (place & active->mask);
}

// Makes the table anew, with `chains` of them.
static paradt_status paradt__active_rehash(paradt__active *active, size_t chains, paradt__memory *memory) {
    paradt_index *heads = (paradt_index *)paradt__alloc(memory, chains, sizeof *heads), *old = active->heads;
    size_t count = old ? active->mask + 1 : 0, i;
    if (!heads) return PARADT_ERROR_MEMORY;
    for (i = 0; i < chains; i++) heads[i] = PARADT__OPEN;
    active->heads = heads;
    active->mask = chains - 1;
    active->lowest = 0;
    for (i = 0; i < count; i++) {
        paradt_index at = old[i];
        while (at >= 0) {
            paradt__link *link = active->links + at;
            paradt_index next = link->next, *head = paradt__active_chain(active, link->smallest, link->key);
            link->next = *head;
            *head = at;
            at = next;
        }
    }
    paradt__release(memory, old);
    return PARADT_OK;
}

enum { PARADT__ACTIVE_SPREAD = 1 }; // to begin with: a small table stays in the cache

// vertices: how many there may be active facets at.
static paradt_status paradt__active_begin(paradt__active *active, size_t vertices, paradt__memory *memory) {
    size_t chains = 64;
    memset(active, 0, sizeof *active);
    active->spare = PARADT__OPEN;
    active->spread = PARADT__ACTIVE_SPREAD;
    while (chains >> PARADT__ACTIVE_SPREAD < vertices) chains *= 2;
    return paradt__active_rehash(active, chains, memory);
}

// Room for the facets of one more cell. There are at least as many chains as facets.
PARADT__INLINE paradt_status paradt__active_room(paradt__active *active, paradt__memory *memory) {
    void *links = active->links;
    size_t capacity = active->capacity ? active->capacity * 2 : 256;
    paradt_status status = PARADT_OK;
    if (!PARADT__LIKELY(active->count + PARADT_MAX_DIM + 1 <= active->mask)) {
        active->spread++;
        status = paradt__active_rehash(active, (active->mask + 1) * 2, memory);
    }
    if (PARADT__LIKELY((size_t)active->fresh + PARADT_MAX_DIM + 1 <= active->capacity) || status) return status;
    if (!paradt__grow(memory, &links, (size_t)active->fresh, capacity, sizeof *active->links))
        return PARADT_ERROR_MEMORY;
    active->links = (paradt__link *)links;
    active->capacity = capacity;
    return PARADT_OK;
}

// Takes a link out of its chain.
PARADT__INLINE paradt_index paradt__active_unlink(paradt__active *active, paradt_index *from) {
    paradt_index at = *from, handle = active->links[at].handle;
    *from = active->links[at].next;
    active->links[at].next = active->spare;
    active->spare = at;
    active->count--;
    return handle;
}

// The active facet with the same vertices as `handle`, which is active no more, or PARADT__OPEN: then `handle` is
// active from now on. chain: that of the smallest vertex and the key.
PARADT__INLINE paradt_index paradt__active_match(paradt__active *active, const paradt__cells *cells,
                                                 paradt_index *chain, paradt_index smallest, uint32_t key,
                                                 paradt_index handle, int corners) {
    paradt_index *from = chain, at;
    paradt__link *link;
    while ((at = *from) >= 0) {
        link = active->links + at;
        if (link->key == key && link->smallest == smallest &&
            paradt__same_facet(cells, link->handle, handle, corners)) {
            return paradt__active_unlink(active, from);
        }
        from = &link->next;
    }
    at = active->spare;
    if (at >= 0) active->spare = active->links[at].next;
    else at = active->fresh++;
    link = active->links + at;
    link->handle = handle;
    link->smallest = smallest;
    link->key = key;
    link->next = *chain;
    *chain = at;
    if ((size_t)(chain - active->heads) < active->lowest) active->lowest = (size_t)(chain - active->heads);
    if (++active->count > active->peak) active->peak = active->count;
    return PARADT__OPEN;
}

// Takes out a facet that is active.
PARADT__INLINE void paradt__active_remove(paradt__active *active, paradt_index smallest, uint32_t key,
                                          paradt_index handle) {
    paradt_index *from = paradt__active_chain(active, smallest, key);
    while (active->links[*from].handle != handle) from = &active->links[*from].next;
    paradt__active_unlink(active, from);
}

// Takes out a facet at the lowest vertex that there is one at, up to the wrap; PARADT__OPEN: no facet is active.
PARADT__INLINE paradt_index paradt__active_first(paradt__active *active) {
    size_t at = active->lowest;
    if (!active->count) return PARADT__OPEN;
    while (active->heads[at] < 0) at++;
    active->lowest = at;
    return paradt__active_unlink(active, active->heads + at);
}

// Smallest vertex of a cell, but for the one at `without`.
PARADT__INLINE paradt_index paradt__smallest_but(const paradt_index *cell, int corners, int without) {
    paradt_index smallest = PARADT__NOWHERE;
    int i;
    for (i = 0; i < corners; i++) {
        paradt_index vertex = i == without ? PARADT__NOWHERE : cell[i];
        smallest = vertex < smallest ? vertex : smallest;
    }
    return smallest;
}

static void paradt__lists_free(paradt__lists *lists, paradt__memory *memory) {
    paradt__release(memory, lists->nodes);
    memset(lists, 0, sizeof *lists);
}

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

// The list must not be empty.
static paradt_index paradt__list_pop(paradt__lists *lists, paradt_index *head) {
    paradt_index node = *head, handle = lists->nodes[node].handle;
    *head = lists->nodes[node].next;
    lists->nodes[node].next = lists->spare;
    lists->spare = node;
    return handle;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>grid
//
// The thesis speeds InCoDe up by a uniform grid. This one adapts: the set is halved again and again across the longest
// side of its bounding box, down to grid cells of eight points, which stand side by side in memory. Eight grid cells
// make a group, eight groups one of the next level, and so on: cell i of a level covers the points from 8^(level+1) i.
// On uniform points that is a uniform grid; in clusters it is as fine as they are, and in any dimension it has n/8
// cells. The halves are cut at multiples of 8, so positions need no pointers: the left half of a range is the smallest
// 8 * 2^j points that are at least half of it. Ties on the cut are broken by the other axes (a symbolically tilted
// plane), so a cut separates the vertices on its two sides in the sense DeWall needs.
// Each level keeps the bounding boxes of its cells in lanes of eight, so that one group is tested at a time: the loops
// over lanes have constant bounds and straight bodies, and compilers turn them into vector code.
// Doors: paradt__grid_build, paradt__grid_free, paradt__grid_cut, paradt__grid_axis, paradt__before; the lanes.

enum {
    PARADT__LANES = 8,       // points a grid cell, grid cells a group
    PARADT__MAX_LEVELS = 21, // 8^21 > 2^62
    PARADT__GRID_ROOM = (PARADT_MAX_DIM + 1) * PARADT__LANES
};

#define PARADT__FAR 1e300 // farther than any point of a set that the floating-point filter is used on

typedef struct paradt__grid {
    int levels;
    size_t cell_count;  // grid cells at level 0
    size_t group_width; // doubles a group of boxes: low and high of each axis, the largest grade, in lanes
    double *lanes;      // [cell_count][set.width][8] the records again, coordinate by coordinate; NULL: not kept
    double *boxes[PARADT__MAX_LEVELS];    // [level] groups of eight bounding boxes
    size_t box_count[PARADT__MAX_LEVELS]; // [level] boxes
    double *rooms[PARADT__MAX_LEVELS];    // [level][group] low and high of each axis: the points inside are the group's
    double heaviest;                      // largest weight, or 0
} paradt__grid;

// Is a before b along the axis? A total order on distinct points.
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

// A place in [begin, end) whose point is likely to come a little after the nth one along the axis, or a little before
// it: whichever leaves the smaller part to go on with. It is found in a sample of `size` points, which are brought to
// the front of the range.
PARADT__INLINE size_t paradt__pivot_place(paradt__set *set, size_t width, size_t begin, size_t end, size_t nth,
                                          int axis, size_t size) {
    size_t i, j, count = end - begin, beyond = size / 16, target = (nth - begin) * size / count;
    uint64_t state = count;
#define PARADT__AT(place) (set->records + (place)*width)
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
        size_t place = paradt__pivot_place(set, width, begin, end, nth, axis, size);
        memcpy(pivot, set->records + place * width, width * sizeof(double));
#define PARADT__AT(place) (set->records + (place)*width)
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

// The first point of the right half of a range of more than eight points.
static size_t paradt__grid_cut(size_t begin, size_t end) {
    size_t left = PARADT__LANES;
    while (left * 2 < end - begin) left *= 2;
    return begin + left;
}

// The axis across which a range is cut: the longest side of its bounding box. Where differences of coordinates may
// overflow, lengths are counted in representable numbers.
PARADT__INLINE int paradt__longest_side(const paradt__set *set, size_t begin, size_t end, size_t width, int dim) {
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM], length = -1.0;
    const double *x = set->records + begin * width, *last = set->records + end * width;
    int axis, longest = 0;
    for (axis = 0; axis < dim; axis++) low[axis] = high[axis] = x[axis];
    for (; x < last; x += width) {
        for (axis = 0; axis < dim; axis++) {
            low[axis] = x[axis] < low[axis] ? x[axis] : low[axis];
            high[axis] = x[axis] > high[axis] ? x[axis] : high[axis];
        }
    }
    for (axis = 0; axis < dim; axis++) {
        double side = set->space.filtered ? high[axis] - low[axis]
                                          : (double)paradt__ordered_bits(high[axis]) * 0.5 -
                                                (double)paradt__ordered_bits(low[axis]) * 0.5;
        if (side > length) length = side, longest = axis;
    }
    return longest;
}

static int paradt__grid_axis(const paradt__set *set, size_t begin, size_t end) {
    if (set->width == 3 && set->space.dim == 3) return paradt__longest_side(set, begin, end, 3, 3);
    return paradt__longest_side(set, begin, end, set->width, set->space.dim);
}

// Keeps the room of a range that is a whole group, on every level where it is one.
static void paradt__grid_keep_room(paradt__grid *grid, const paradt__set *set, size_t begin, size_t end,
                                   const double *room) {
    int level;
    size_t span = PARADT__LANES * PARADT__LANES, width = 2 * (size_t)set->space.dim;
    for (level = 0; level < grid->levels; level++, span *= PARADT__LANES) {
        if (begin % span == 0 && (end - begin == span || (end == set->count && end - begin < span))) {
            memcpy(grid->rooms[level] + begin / span * width, room, width * sizeof(double));
        }
    }
}

// Halves the range down to grid cells. room: low and high of each axis between the cuts around the range.
static void paradt__grid_sort(paradt__grid *grid, paradt__set *set, size_t begin, size_t end, const double *around) {
    double room[2 * PARADT_MAX_DIM];
    memcpy(room, around, sizeof room);
    for (;;) {
        size_t cut;
        double at, high;
        int axis;
        if (end - begin > PARADT__LANES * PARADT__LANES / 2 || end == set->count)
            paradt__grid_keep_room(grid, set, begin, end, room);
        if (end - begin <= PARADT__LANES) return;
        cut = paradt__grid_cut(begin, end);
        axis = paradt__grid_axis(set, begin, end);
        switch (set->width) { // the same code with the width known
        case 2: at = paradt__select(set, 2, begin, end, cut, axis); break;
        case 3: at = paradt__select(set, 3, begin, end, cut, axis); break;
        default: at = paradt__select(set, set->width, begin, end, cut, axis);
        }
        high = room[2 * axis + 1];
        room[2 * axis + 1] = at;
        paradt__grid_sort(grid, set, begin, cut, room);
        room[2 * axis + 1] = high;
        room[2 * axis] = at;
        begin = cut;
    }
}

// The points of a grid cell, coordinate by coordinate. Behind the last point of the set it is repeated. Inlined with a
// constant width.
PARADT__INLINE void paradt__lay_lanes_of(const paradt__set *set, size_t width, size_t cell, double *lanes) {
    size_t lane, j;
    for (lane = 0; lane < PARADT__LANES; lane++) {
        size_t place = cell * PARADT__LANES + lane;
        const double *record = set->records + (place < set->count ? place : set->count - 1) * width;
        for (j = 0; j < width; j++) lanes[j * PARADT__LANES + lane] = record[j];
    }
}

static void paradt__lay_lanes(const paradt__set *set, size_t cell, double *lanes) {
    if (set->width == 3) paradt__lay_lanes_of(set, 3, cell, lanes);
    else paradt__lay_lanes_of(set, set->width, cell, lanes);
}

// The same, kept or in `room`, which has PARADT__GRID_ROOM doubles.
PARADT__INLINE const double *paradt__grid_lanes(const paradt__grid *grid, const paradt__set *set, size_t cell,
                                                double *room) {
    if (PARADT__LIKELY(grid->lanes != NULL)) return grid->lanes + cell * set->width * PARADT__LANES;
    paradt__lay_lanes(set, cell, room);
    return room;
}

// One box, around `count` points or boxes, with the largest weight where they are graded. From one of these to the next
// it is `step` doubles, from axis to axis `stride`, and from the lower bound to the upper `rise`. Inlined with
// constants.
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
        else if (width == 3 && ambient == 3 && count == PARADT__LANES)
            paradt__grid_bound(box, from, PARADT__LANES, 3, 1, 0, 3, 0);
        else paradt__grid_bound(box, from, count, width, 1, 0, ambient, graded);
    }
}

// Fills the grid cells and boxes of a set in its present order.
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
        paradt__release(memory, grid->rooms[level]);
    }
    memset(grid, 0, sizeof *grid);
}

// front: for a method that searches for every facet; it keeps lanes and rooms.
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
            grid->rooms[level] = (double *)paradt__alloc(memory, groups * 2 * (size_t)set->space.dim, sizeof(double));
        if (!grid->boxes[level] || (front && !grid->rooms[level])) return PARADT_ERROR_MEMORY;
        memset(grid->boxes[level] + (groups - 1) * grid->group_width, 0, grid->group_width * sizeof(double));
        count = groups;
    } while (count > 1);
    return PARADT_OK;
}

// Sorts the set and lays the grid over it. The set has at least one point.
static paradt_status paradt__grid_build(paradt__grid *grid, paradt__set *set, paradt__memory *memory) {
    double room[2 * PARADT_MAX_DIM];
    paradt_status status = paradt__grid_allocate(grid, set, 1, memory);
    size_t i;
    if (status) return status;
    for (i = 0; i < 2 * PARADT_MAX_DIM; i++) room[i] = i % 2 ? PARADT__FAR : -PARADT__FAR;
    paradt__grid_sort(grid, set, 0, set->count, room);
    paradt__grid_fill(grid, set);
    return PARADT_OK;
}

// Lays a grid over the set in the order that it has, for few searches, from the top. It has no lanes and no rooms.
static paradt_status paradt__grid_lay(paradt__grid *grid, const paradt__set *set, paradt__memory *memory) {
    paradt_status status = paradt__grid_allocate(grid, set, 0, memory);
    if (!status) paradt__grid_fill(grid, set);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>search
//
// MakeSimplex of the thesis: given a facet, the point on its outer side with the smallest signed Delaunay distance dd,
// and, by the same means, a point in conflict with a given cell.
//
// Let o be a vertex of the facet f, u = x - o, and lift(u) = |u|^2 less the difference of the weights. The spheres
// through f are a pencil: F_t(u) = A(u) - t N(u), where N(u) = normal . u vanishes on f and is positive outside, and
// A(u) = lift(u) - base . u vanishes on f. x is inside the sphere t where F_t < 0. Outside of f, x lies on the sphere
// t(x) = A(x) / N(x); the smallest t is the smallest dd, since the centre moves outward along the normal with t.
//
// Floating point only ever rules points out. Let K be a bound on the relative rounding of the sums below
// (PARADT__ROUND). Computed `base` and `normal` miss f by the residuals r_i = lift(e_i) - base . e_i and s_i = normal .
// e_i on the edges e_i = p_i - o. Let e*_i be the dual basis of the edges in their span. Then the true A and N differ
// from the computed by at most sum_i |r_i| |e*_i . u| <= (sum_i |r_i| |e*_i|_max) |u|_1 = base_slack |u|_1, likewise
// normal_slack, to which comes K sum_j |normal_j u_j| and so on for rounding, and for sagittas f_floor for their own
// error. The dual basis is itself computed; while |e_i|_1 |e*_i|_max, the inverse sine of the facet's angles, stays
// below 2^36, its relative error is below 2^-10 and a factor of 2 covers it. A facet more needle-like than that gets
// slacks so large that nothing is ruled out and all is decided exactly. A point whose F is certainly positive for the
// current sphere can't be the apex and is passed over; one whose F is certainly negative replaces the apex; all others
// are settled by the exact perturbed predicate, which is a total order on the pencil. The same bounds, taken over a
// box, rule out boxes: those on the inner side, and those outside the sphere. The order in which points are seen only
// matters for speed. Doors: paradt__search_begin, paradt__search_apex, paradt__search_conflict.

// u = 2^-52 holds in every rounding mode. A term of a sum passes a difference (u), at most 2 products (2u), at most d +
// 2 additions in any order, and once more as much where the same quantity is computed for a box and for a point in it.
#define PARADT__ROUND(dim) (8.0 * ((dim) + 6) * 2.220446049250313e-16)
#define PARADT__NO_BOUND   3.2733906078961419e150 // 2^500: larger than all of a filtered set, its square finite
#define PARADT__NEEDLE     68719476736.0          // 2^36
#define PARADT__STEEP      2.0370359763344861e90  // 2^300: spheres that flat are left to the predicates

typedef struct paradt__lane_query {
    double origin[PARADT_MAX_DIM];
    double normal[PARADT_MAX_DIM];
    size_t outer[PARADT_MAX_DIM];      // where a box has N's largest value: offset of the row of low or high sides
    double centre[PARADT_MAX_DIM];     // F(u) = sum_j u_j (u_j - centre_j): twice the centre of the current sphere
    double slack[PARADT_MAX_DIM];      // |error of F| <= sum_j |u_j| (K |u_j| + slack_j)
    double reach[PARADT_MAX_DIM];      // |error of N| <= sum_j |u_j| reach_j
    double weight;                     // of the origin
    double clear;                      // N of a point that is a good candidate is more than this
    double f_floor;                    // error that F has everywhere
    double n_floor;                    // N of a point outside is at least this
    double disc[PARADT_MAX_DIM];       // with sagittas: a point outside has sum_j u_j (u_j - disc_j) of at most
    double disc_slack[PARADT_MAX_DIM]; // disc_floor + sum_j |u_j| (K |u_j| + disc_slack_j)
    double disc_floor;
    double extent[PARADT_MAX_DIM];  // with sagittas: the length of the set along each axis
    double weight_slack;            // ... and the error of a difference of two
    double curve;                   // with sagittas, on the reference sphere: F(u) = curve |u|^2 - tangent . u
    double tangent[PARADT_MAX_DIM]; // - (1 - curve) (s(u) - s(0)), s the sagitta
    double summit[PARADT_MAX_DIM];  // if curve > 0: where curve |u|^2 - tangent . u is least; else 0
    double curve_slack;             // error of that form of F beyond F's own
    double round;                   // K
} paradt__lane_query;

typedef struct paradt__lane_bounds {
    double f[PARADT__LANES]; // a box: bounds on the errors of F and N in it
    double n[PARADT__LANES];
    double promise[PARADT__LANES]; // how far below zero F may be
} paradt__lane_bounds;

typedef unsigned (*paradt__group_kernel)(const paradt__lane_query *q, const double *group, paradt__lane_bounds *bounds);
typedef unsigned (*paradt__cell_kernel)(const paradt__lane_query *q, const double *cell, double f_bound,
                                        double n_bound);
typedef double (*paradt__best_kernel)(const paradt__lane_query *q, const double *cell);

typedef struct paradt__kernels {
    paradt__group_kernel group;
    paradt__cell_kernel cell;
    paradt__best_kernel best;
} paradt__kernels;

// The lanes whose value is not negative.
PARADT__INLINE unsigned paradt__lane_mask(const double *value) {
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

// Which of eight boxes may hold a point outside the facet and inside the sphere?
PARADT__INLINE unsigned paradt__test_group_plain(const paradt__lane_query *q, const double *group,
                                                 paradt__lane_bounds *PARADT__RESTRICT bounds, int ambient, int grade) {
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
    return paradt__lane_mask(margin);
}

// The same with sagittas. The lifts are of one size in all of the set, so one bound on the errors does: that at the
// distance of its whole extent. N is affine, so one corner of a box decides; F is taken as paradt__set_curve has it.
PARADT__INLINE unsigned paradt__test_graded_group(const paradt__lane_query *q, const double *group,
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
    if (q->disc_floor < PARADT__NO_BOUND) {
        for (lane = 0; lane < PARADT__LANES; lane++) {
            double g = -q->disc_floor;
            for (j = 0; j < ambient; j++) {
                double low = group[j * 2 * PARADT__LANES + lane] - q->origin[j];
                double high = group[(j * 2 + 1) * PARADT__LANES + lane] - q->origin[j];
                double x = q->disc[j] * 0.5, reach = -low > high ? -low : high;
                x = x > low ? x : low;
                x = x < high ? x : high;
                g += x * (x - q->disc[j]) - reach * (q->round * reach + q->disc_slack[j]);
            }
            margin[lane] = -g < margin[lane] ? -g : margin[lane];
        }
    }
    return paradt__lane_mask(margin);
}

// The same for the eight points of a grid cell, with the bounds that hold in its box.
PARADT__INLINE unsigned paradt__test_cell_plain(const paradt__lane_query *q, const double *cell, double f_bound,
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
    return paradt__lane_mask(margin);
}

// The smallest parameter t of the eight points of a grid cell, less that of the current sphere (that of the base, while
// there is no apex), among those that are clearly outside; its last three bits are the lane. PARADT__FAR or so: none.
PARADT__INLINE double paradt__best_of_cell_plain(const paradt__lane_query *q, const double *cell, int ambient,
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
// The twins of the three above for processors with AVX2, four lanes at a time.
#define PARADT__ALL(value) _mm256_set1_pd(value)

PARADT__AVX2 PARADT__INLINE unsigned paradt__test_group_avx2(const paradt__lane_query *q, const double *group,
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

PARADT__AVX2 PARADT__INLINE void paradt__lift_avx2(const paradt__lane_query *q, const double *lanes, int ambient,
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

PARADT__AVX2 PARADT__INLINE unsigned paradt__test_cell_avx2(const paradt__lane_query *q, const double *cell,
                                                            double f_bound, double n_bound, int ambient, int grade) {
    unsigned mask = 0;
    int half;
    for (half = 0; half < PARADT__LANES; half += 4) {
        __m256d f, n;
        paradt__lift_avx2(q, cell + half, ambient, grade, &f, &n);
        f = _mm256_sub_pd(PARADT__ALL(f_bound), f);
        n = _mm256_add_pd(n, PARADT__ALL(n_bound));
        mask |= (unsigned)_mm256_movemask_pd(_mm256_min_pd(f, n)) << half;
    }
    return ~mask & 255;
}

PARADT__AVX2 PARADT__INLINE double paradt__best_of_cell_avx2(const paradt__lane_query *q, const double *cell,
                                                             int ambient, int grade) {
    const __m256d beyond = PARADT__ALL(PARADT__FAR), number = _mm256_castsi256_pd(_mm256_set1_epi64x(7));
    __m256d best[2], n;
    __m128d pair;
    int half;
    for (half = 0; half < 2; half++) {
        paradt__lift_avx2(q, cell + 4 * half, ambient, grade, best + half, &n);
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

// One set of kernels for each dimension, with and without weights, and each instruction set that can be chosen at run
// time. All of them rule out by the same bounds, so all lead to the same cells.
#define PARADT__KERNEL_SET(isa, attribute, d, w)                                                                       \
    attribute static unsigned paradt__group_##isa##d##w(const paradt__lane_query *q, const double *group,              \
                                                        paradt__lane_bounds *bounds) {                                 \
        if (w == PARADT__SAGITTA) return paradt__test_graded_group(q, group, bounds, d);                               \
        return paradt__test_group##isa(q, group, bounds, d, w);                                                        \
    }                                                                                                                  \
    attribute static unsigned paradt__cell_##isa##d##w(const paradt__lane_query *q, const double *cell,                \
                                                       double f_bound, double n_bound) {                               \
        return paradt__test_cell##isa(q, cell, f_bound, n_bound, d, w);                                                \
    }                                                                                                                  \
    attribute static double paradt__best_##isa##d##w(const paradt__lane_query *q, const double *cell) {                \
        return paradt__best_of_cell##isa(q, cell, d, w);                                                               \
    }
#define PARADT__KERNEL_PAIR(isa, attribute, d)                                                                         \
    PARADT__KERNEL_SET(isa, attribute, d, 0)                                                                           \
    PARADT__KERNEL_SET(isa, attribute, d, 1) PARADT__KERNEL_SET(isa, attribute, d, 2)
#define PARADT__KERNELS(isa, attribute)                                                                                \
    PARADT__KERNEL_PAIR(isa, attribute, 2)                                                                             \
    PARADT__KERNEL_PAIR(isa, attribute, 3)                                                                             \
    PARADT__KERNEL_PAIR(isa, attribute, 4)                                                                             \
    PARADT__KERNEL_PAIR(isa, attribute, 5)                                                                             \
    PARADT__KERNEL_PAIR(isa, attribute, 6) PARADT__KERNEL_PAIR(isa, attribute, 7) PARADT__KERNEL_PAIR(isa, attribute, 8)
#define PARADT__KERNEL_NAMES(isa, d, w)                                                                                \
    { paradt__group_##isa##d##w, paradt__cell_##isa##d##w, paradt__best_##isa##d##w }
#define PARADT__KERNEL_ROW(isa, d)                                                                                     \
    { PARADT__KERNEL_NAMES(isa, d, 0), PARADT__KERNEL_NAMES(isa, d, 1), PARADT__KERNEL_NAMES(isa, d, 2) }
#define PARADT__KERNEL_TABLE(isa)                                                                                      \
    {                                                                                                                  \
        PARADT__KERNEL_ROW(isa, 2), PARADT__KERNEL_ROW(isa, 3), PARADT__KERNEL_ROW(isa, 4),                            \
            PARADT__KERNEL_ROW(isa, 5), PARADT__KERNEL_ROW(isa, 6), PARADT__KERNEL_ROW(isa, 7),                        \
            PARADT__KERNEL_ROW(isa, 8)                                                                                 \
    }

PARADT__KERNELS(_plain, )
#if defined(PARADT__AVX2)
PARADT__KERNELS(_avx2, PARADT__AVX2)
#endif

static paradt__kernels paradt__choose_kernels(int ambient, int grade) {
    static const paradt__kernels plain[][3] = PARADT__KERNEL_TABLE(_plain);
#if defined(PARADT__AVX2)
    static const paradt__kernels avx2[][3] = PARADT__KERNEL_TABLE(_avx2);
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2[ambient - 2][grade];
#endif
    return plain[ambient - 2][grade];
}

// ---------------------------------------------------------------------------------------------------------------------
// >>search
//
// Doors: to be listed.

typedef struct paradt__search {
    const paradt__set *set;
    const paradt__grid *grid;
    paradt__space space; // this search's own, for its counters
    int plain3;          // three coordinates and no weights: the shape that has its own copies of the inner functions
    paradt__kernels test;
    size_t begin, end;     // positions that matter: the whole set, or the part that a DeWall works on
    double heaviest;       // no point that may be found is heavier
    uint8_t *const *alive; // [level][group] which of its boxes have points that may be an apex; NULL: all
    uint64_t distance_evaluations, grid_cells_visited;

    // the facet and its pencil
    const double *corners[PARADT_MAX_DIM + 2]; // the facet's dim vertices; room for an apex and one more
    paradt_index facet[PARADT_MAX_DIM];
    int outside;  // sign of the orientation (facet, x) for x outside
    int conflict; // both sides count, and the first point found in conflict with the sphere is the answer
    int found;    // there is one
    double base[PARADT_MAX_DIM];
    double base_slack, normal_slack;

    paradt_index apex; // best so far, or PARADT__OPEN
    unsigned changes;  // times the sphere changed
    unsigned growths;  // times a bound on the errors became larger by that
    paradt__lane_query q;
} paradt__search;

static void paradt__search_begin(paradt__search *s, const paradt__set *set, const paradt__grid *grid) {
    int j;
    memset(s, 0, sizeof *s);
    s->set = set;
    s->grid = grid;
    s->heaviest = grid->heaviest;
    s->space = set->space;
    memset(&s->space.counters, 0, sizeof s->space.counters);
    s->test = paradt__choose_kernels(set->space.ambient, set->grade);
    s->end = set->count;
    s->plain3 = set->space.dim == 3 && set->space.ambient == 3 && !set->grade;
    s->q.round = PARADT__ROUND(set->space.ambient);
    s->q.f_floor = 4.0 * set->grade_error;
    s->q.weight_slack = 2.0 * s->q.round * set->grade_limit;
    for (j = 0; j < set->space.ambient; j++) {
        if (set->space.low[j] > set->space.high[j]) continue;
        s->q.extent[j] =
            1.0000001 * (paradt__from_ordered_bits(set->space.high[j]) - paradt__from_ordered_bits(set->space.low[j]));
    }
}

// One edge's share of the slacks; 0 when the facet is a needle. lift_size: the sum of the sizes of the lift's terms.
PARADT__INLINE int paradt__add_residual(paradt__search *s, const double *edge, double lift, double lift_size,
                                        const double *dual, int dim) {
    double r = lift, r_size = lift_size, n = 0.0, n_size = 0.0, length = 0.0, dual_size = 0.0;
    int j;
    for (j = 0; j < dim; j++) {
        double d = paradt__abs(dual[j]);
        r -= s->base[j] * edge[j];
        r_size += paradt__abs(s->base[j] * edge[j]);
        n += s->q.normal[j] * edge[j];
        n_size += paradt__abs(s->q.normal[j] * edge[j]);
        length += paradt__abs(edge[j]);
        dual_size = d > dual_size ? d : dual_size;
    }
    s->base_slack += 2.0 * dual_size * (paradt__abs(r) + s->q.round * r_size + s->q.f_floor);
    s->normal_slack += 2.0 * dual_size * (paradt__abs(n) + s->q.round * n_size);
    return length * dual_size < PARADT__NEEDLE;
}

// A triangle in 3D: normal = e1 x e2, and the dual basis from cross products with it. 0: it is flat.
PARADT__INLINE int paradt__pencil3(paradt__search *s, double edges[][PARADT_MAX_DIM], double d[][PARADT_MAX_DIM]) {
    const double *e = edges[0], *f = edges[1];
    double *n = s->q.normal, size, inverse;
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
    for (j = 0; j < 3 && s->outside < 0; j++) n[j] = -n[j];
    return 1;
}

static double paradt__longest(const double *vector, int dim) {
    double longest = 0.0;
    int j;
    for (j = 0; j < dim; j++) {
        double length = paradt__abs(vector[j]);
        longest = length > longest ? length : longest;
    }
    return longest;
}

// A unit vector across the span of the orthonormal rows: the axis farthest from the span, less its part in it, twice.
static void paradt__normal_to(const double rows[][PARADT_MAX_DIM], int count, int dim, double *normal) {
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

// Any dimension: edges = L Q by modified Gram-Schmidt; the dual basis is the columns of Q^T L^-1. The ratios of the
// edges to the diagonal of L are bounded first, so that nothing overflows on the way to finding a needle.
static int paradt__pencil(paradt__search *s, double edges[][PARADT_MAX_DIM], double dual[][PARADT_MAX_DIM], int dim) {
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
        if (!(l[i][i] * PARADT__NEEDLE > paradt__longest(edges[i], dim))) return 0;
        for (j = 0; j < dim; j++) q[i][j] /= l[i][i];
    }
    // Dual vector i is y Q with L y = unit i.
    for (i = 0; i < dim - 1; i++) {
        double y[PARADT_MAX_DIM];
        for (j = 0; j < dim; j++) dual[i][j] = 0.0;
        for (k = i; k < dim - 1; k++) {
            double rest = k == i ? 1.0 : 0.0;
            for (j = i; j < k; j++) rest -= l[k][j] * y[j];
            y[k] = rest / l[k][k];
            for (j = 0; j < dim; j++) dual[i][j] += y[k] * q[k][j];
        }
    }
    paradt__normal_to((const double(*)[PARADT_MAX_DIM])q, dim - 1, dim, s->q.normal);
    return 1;
}

// Turns the normal away from `inner`; where the side of that is in doubt, N rules out nothing.
static void paradt__turn_normal(paradt__search *s, const double *inner, int dim) {
    double side = 0.0, size = 0.0;
    int j;
    for (j = 0; j < dim; j++) {
        double u = inner[j] - s->q.origin[j];
        side += s->q.normal[j] * u;
        size += paradt__abs(u) * (s->q.round * paradt__abs(s->q.normal[j]) + s->normal_slack);
    }
    for (j = 0; j < dim && side > size; j++) s->q.normal[j] = -s->q.normal[j];
    if (side >= -size && side <= size) s->normal_slack = PARADT__NO_BOUND;
}

// Nothing is known about the pencil in floating point: all is left to the predicates.
static void paradt__pencil_unknown(paradt__search *s) {
    memset(s->q.normal, 0, sizeof s->q.normal);
    memset(s->base, 0, sizeof s->base);
    s->base_slack = s->normal_slack = PARADT__NO_BOUND;
}

// Where N is a determinant of the coordinates (`determinant`) and these are multiples of one power of two, as in
// lattices, N is too; if its error is less than half of the smallest one that is not 0, its sign is known everywhere.
PARADT__INLINE void paradt__set_floors(paradt__search *s, int determinant) {
    const paradt__space *space = &s->space;
    s->q.n_floor =
        determinant && space->orient_certain < 0.5 * space->orient_quantum ? 0.5 * space->orient_quantum : 0.0;
}

// Near a sphere with centre c, the part outside of a facet that faces away from c is a cap, which lies in the smallest
// sphere through the facet: for G(u) = |u|^2 - disc . u with that sphere's disc = twice its centre, and all u on the
// sphere, |u|^2 = -2 w . u + s0 - s(u) with w = o - c and sagittas s, so that G(u) = -(2 w + disc) . u + s0 - s(u). 2 w
// + disc is mu times the normal up to a rest. If mu > 0, N(u) > 0 has G(u) <= |rest| |u| + s0 - s(u). This rules out
// boxes that the facet's plane cuts far from the facet, as it cuts boxes of every size near the hull.
static void paradt__set_disc(paradt__search *s, double edges[][PARADT_MAX_DIM], double dual[][PARADT_MAX_DIM],
                             int dim) {
    double mu = 0.0, size = 0.0, two_w[PARADT_MAX_DIM];
    int i, j;
    for (j = 0; j < dim; j++) s->q.disc[j] = 0.0;
    for (i = 0; i < dim - 1; i++) {
        double lift = 0.0;
        for (j = 0; j < dim; j++) lift += edges[i][j] * edges[i][j];
        for (j = 0; j < dim; j++) s->q.disc[j] += lift * dual[i][j];
    }
    for (j = 0; j < dim; j++) {
        two_w[j] = 2.0 * (s->q.origin[j] - s->set->centre[j]);
        mu += (two_w[j] + s->q.disc[j]) * s->q.normal[j];
        size += s->q.normal[j] * s->q.normal[j];
    }
    if (!(mu > 0.0)) return;
    mu /= size;
    for (j = 0; j < dim; j++) {
        double rest = two_w[j] + s->q.disc[j] - mu * s->q.normal[j];
        s->q.disc_slack[j] =
            paradt__abs(rest) + mu * s->q.reach[j] +
            s->q.round * (paradt__abs(two_w[j]) + paradt__abs(s->q.disc[j]) + paradt__abs(mu * s->q.normal[j]));
    }
    s->q.disc_floor = 2.0 * (s->set->grade_limit + s->set->grade_error) + mu * s->q.n_floor;
}

// Sets the pencil of the facet s->corners. inner: a point off the facet, on the inner side if there are sides.
PARADT__INLINE void paradt__facet_of_shape(paradt__search *s, const double *inner, int dim, int ambient, int grade) {
    double edges[PARADT_MAX_DIM][PARADT_MAX_DIM], dual[PARADT_MAX_DIM][PARADT_MAX_DIM];
    double lifts[PARADT_MAX_DIM], lift_sizes[PARADT_MAX_DIM];
    int i, j, sound;
    const double *o = s->corners[0];
    for (j = 0; j < ambient; j++) s->q.origin[j] = o[j];
    s->q.weight = grade ? o[ambient] : 0.0;
    for (i = 0; i < dim - 1; i++) {
        const double *p = s->corners[i + 1];
        double loss = grade ? s->q.weight - p[ambient] : 0.0, square = 0.0;
        for (j = 0; j < ambient; j++) {
            double e = p[j] - o[j];
            edges[i][j] = e;
            if (grade != PARADT__SAGITTA) square += e * e;
        }
        lifts[i] = square + loss;
        lift_sizes[i] = square + paradt__abs(loss); // square and loss may cancel
    }
    s->base_slack = s->normal_slack = 0.0;
    sound = dim == 3 ? paradt__pencil3(s, edges, dual) : paradt__pencil(s, edges, dual, dim);
    for (j = 0; j < dim && sound; j++) {
        s->base[j] = 0.0;
        for (i = 0; i < dim - 1; i++) s->base[j] += lifts[i] * dual[i][j];
    }
    for (i = 0; i < dim - 1 && sound; i++) {
        sound = paradt__add_residual(s, edges[i], lifts[i], lift_sizes[i], dual[i], dim);
    }
    if (sound && dim != 3) paradt__turn_normal(s, inner, dim);
    if (!sound) paradt__pencil_unknown(s);
    paradt__set_floors(s, sound && dim == 3);
    s->q.clear = 0.0;
    for (j = 0; j < dim; j++) s->q.clear = paradt__larger(s->q.clear, paradt__abs(s->q.normal[j]));
    if (dim > 1) s->q.clear *= 1e-9 * paradt__largest(edges[0], dim);
    for (j = 0; j < ambient; j++) {
        if (j >= dim) s->q.normal[j] = s->base[j] = 0.0;
        s->q.outer[j] = s->q.normal[j] < 0.0 ? 0 : PARADT__LANES;
        s->q.centre[j] = s->base[j];
        s->q.slack[j] = PARADT__NO_BOUND;
        s->q.reach[j] =
            j < dim && s->q.n_floor == 0.0 ? s->q.round * paradt__abs(s->q.normal[j]) + s->normal_slack : 0.0;
    }
    s->q.disc_floor = PARADT__NO_BOUND;
    if (grade == PARADT__SAGITTA && sound && !s->conflict) paradt__set_disc(s, edges, dual, dim);
    s->apex = PARADT__OPEN;
}

static void paradt__search_facet(paradt__search *s, const double *inner) {
    if (s->plain3) paradt__facet_of_shape(s, inner, 3, 3, 0);
    else paradt__facet_of_shape(s, inner, s->space.dim, s->space.ambient, s->set->grade);
}

// On the reference sphere, |u|^2 = -2 w . u + s0 - s(u) with w = o - c, so that a multiple of the difference may be
// added to F: the one that leaves nothing of the centre along w. Then F varies with the square of a box's size, as it
// does on the sphere, while the box reaches off it by its size.
static void paradt__set_curve(paradt__search *s, int dim) {
    double dot = 0.0, square = 0.0, half, two_w[PARADT_MAX_DIM];
    int j;
    for (j = 0; j < dim; j++) {
        two_w[j] = 2.0 * (s->q.origin[j] - s->set->centre[j]);
        dot += s->q.centre[j] * two_w[j];
        square += two_w[j] * two_w[j];
    }
    s->q.curve = dot / square;
    if (!(paradt__abs(s->q.curve) < 0.5 && paradt__abs(s->q.curve) > 1.0 / PARADT__STEEP)) s->q.curve = 0.0;
    half = s->q.curve > 0.0 ? 0.5 / s->q.curve : 0.0;
    s->q.curve_slack = paradt__abs(s->q.curve) * (s->q.f_floor + 2.0 * s->q.weight_slack);
    for (j = 0; j < dim; j++) {
        double moved = s->q.curve * two_w[j];
        s->q.tangent[j] = s->q.centre[j] - moved;
        s->q.summit[j] = s->q.tangent[j] * half;
        s->q.curve_slack +=
            2.0 * s->q.round * s->q.extent[j] *
            (paradt__abs(s->q.curve) * s->q.extent[j] + paradt__abs(s->q.centre[j]) + 2.0 * paradt__abs(moved));
    }
}

// Makes x the apex: the sphere through the facet and it. n: N(x), n_bound: its error. The slacks are taken twice as
// large as needed and then kept as long as they do, so that bounds computed for one sphere mostly hold for the next.
PARADT__INLINE void paradt__accept_of_shape(paradt__search *s, paradt_index point, const double *x, double n,
                                            double n_bound, int dim, int ambient, int grade) {
    int j, grown = s->apex < 0;
    double a = 0.0, a_bound = s->q.f_floor, t, t_bound, size;
    if (s->q.n_floor > 0.0) n_bound = s->space.orient_certain;
    size = paradt__abs(n) - n_bound;
    s->apex = point;
    s->corners[dim] = x;
    s->changes++;
    for (j = 0; j < ambient; j++) {
        double u = x[j] - s->q.origin[j], reach = paradt__abs(u);
        a += grade == PARADT__SAGITTA ? -u * s->base[j] : u * (u - s->base[j]);
        a_bound += reach * (s->q.round * paradt__abs(s->base[j]) + s->base_slack);
        if (grade != PARADT__SAGITTA) a_bound += s->q.round * reach * reach;
    }
    if (grade) {
        double gain = x[ambient] - s->q.weight;
        a -= gain;
        a_bound += s->q.round * paradt__abs(gain);
    }
    t = size > 0.0 ? a / n : PARADT__STEEP;
    t_bound = size > 0.0 ? (a_bound + paradt__abs(t) * n_bound) / size + s->q.round * paradt__abs(t) : PARADT__STEEP;
    if (!(paradt__abs(t) < PARADT__STEEP && t_bound < PARADT__STEEP)) {
        for (j = 0; j < ambient; j++) s->q.slack[j] = PARADT__NO_BOUND;
        s->growths++;
        return;
    }
    for (j = 0; j < ambient; j++) {
        double normal = s->q.normal[j], slack;
        s->q.centre[j] = s->base[j] + t * normal;
        slack = s->q.round * (paradt__abs(s->base[j]) + paradt__abs(t * normal)) + t_bound * paradt__abs(normal);
        if (j < dim) slack += s->base_slack + (paradt__abs(t) + t_bound) * s->normal_slack;
        if (grown || slack > s->q.slack[j]) {
            s->q.slack[j] = 2.0 * slack;
            grown = 1;
        }
    }
    s->growths += (unsigned)grown;
    if (grade == PARADT__SAGITTA) paradt__set_curve(s, dim);
}

static void paradt__search_accept(paradt__search *s, paradt_index point, const double *x, double n, double n_bound) {
    if (s->plain3) paradt__accept_of_shape(s, point, x, n, n_bound, 3, 3, 0);
    else paradt__accept_of_shape(s, point, x, n, n_bound, s->space.dim, s->space.ambient, s->set->grade);
}

// Is x in conflict with the cell of the facet and the apex? Exactly, with the perturbation.
static int paradt__search_settle(paradt__search *s, const double *x) {
    const double *p[PARADT_MAX_DIM + 2];
    int dim = s->space.dim, i;
    for (i = 0; i <= dim; i++) p[i] = s->corners[i];
    if (s->outside < 0) {
        p[dim - 1] = s->corners[dim];
        p[dim] = s->corners[dim - 1];
    }
    p[dim + 1] = x;
    return paradt__conflict(&s->space, p);
}

static int paradt__search_is_outside(paradt__search *s, const double *x) {
    const double *p[PARADT_MAX_DIM + 1];
    int dim = s->space.dim, i;
    for (i = 0; i < dim; i++) p[i] = s->corners[i];
    p[dim] = x;
    return paradt__orient(&s->space, p) * s->outside > 0;
}

// Looks at one point that could not be ruled out with its neighbours.
PARADT__INLINE void paradt__point_of_shape(paradt__search *s, size_t position, int dim, int ambient, int grade) {
    paradt_index point = (paradt_index)position;
    const double *x;
    double f = 0.0, f_bound = s->q.f_floor, n = 0.0, n_bound = -s->q.n_floor;
    int i, j;
    if (position >= s->set->count || point == s->apex) return;
    for (i = 0; i < dim; i++) {
        if (point == s->facet[i]) return;
    }
    x = paradt__record(s->set, point);
    if (s->space.filtered) {
        for (j = 0; j < ambient; j++) {
            double u = x[j] - s->q.origin[j], reach = paradt__abs(u);
            f += grade == PARADT__SAGITTA ? -u * s->q.centre[j] : u * (u - s->q.centre[j]);
            f_bound += reach * s->q.slack[j];
            if (grade != PARADT__SAGITTA) f_bound += reach * s->q.round * reach;
            n += s->q.normal[j] * u;
            n_bound += reach * s->q.reach[j];
        }
        if (grade) {
            double gain = x[ambient] - s->q.weight;
            f -= gain;
            f_bound += s->q.round * paradt__abs(gain);
        }
    } else {
        f_bound = n_bound = PARADT__NO_BOUND;
    }
    if (!s->conflict) {
        if (n < -n_bound || (n <= n_bound && !paradt__search_is_outside(s, x))) return;
    }
    if (s->apex >= 0) {
        if (f > f_bound || (f >= -f_bound && !paradt__search_settle(s, x))) return;
    }
    if (s->conflict) {
        s->apex = point;
        s->found = 1;
    } else {
        paradt__search_accept(s, point, x, n, n_bound);
    }
}

static void paradt__search_point(paradt__search *s, size_t position) {
    if (s->plain3) paradt__point_of_shape(s, position, 3, 3, 0);
    else paradt__point_of_shape(s, position, s->space.dim, s->space.ambient, s->set->grade);
}

// Clears the bit of a point, if it is in the grid cell.
PARADT__INLINE unsigned paradt__mask_without(unsigned mask, size_t cell, paradt_index point) {
    size_t lane = (size_t)point - cell * PARADT__LANES;
    return mask & ~(unsigned)((uint64_t)1 << (lane < 63 ? lane : 63));
}

PARADT__INLINE int paradt__lane_of(double packed) {
    return (int)(paradt__bits(packed) & 7);
}

// The points of a grid cell that can't be ruled out together, the most promising first: after it, most others can.
static void paradt__search_cell(paradt__search *s, size_t cell, double f_bound, double n_bound) {
    double room[PARADT__GRID_ROOM];
    const double *lanes = paradt__grid_lanes(s->grid, s->set, cell, room);
    unsigned mask = s->test.cell(&s->q, lanes, f_bound, n_bound);
    int i;
    s->distance_evaluations += PARADT__LANES;
    s->grid_cells_visited++;
    if (!mask) return;
    for (i = 0; i < s->space.dim; i++) mask = paradt__mask_without(mask, cell, s->facet[i]); // they are on every sphere
    mask = paradt__mask_without(mask, cell, s->apex);
    while (mask && !s->found) {
        int lane = paradt__trailing_zeros(mask);
        unsigned changes = s->changes, growths = s->growths;
        if (mask & (mask - 1)) {
            int best = paradt__lane_of(s->test.best(&s->q, lanes));
            lane = mask >> best & 1 ? best : lane;
        }
        paradt__search_point(s, cell * PARADT__LANES + (size_t)lane);
        mask &= ~(1u << lane);
        if (mask && s->changes != changes && s->growths == growths)
            mask &= s->test.cell(&s->q, lanes, f_bound, n_bound);
    }
}

PARADT__INLINE int paradt__most_promising(const paradt__lane_bounds *bounds, unsigned mask) {
    int best = paradt__trailing_zeros(mask), lane;
    for (mask &= mask - 1; mask; mask &= mask - 1) {
        lane = paradt__trailing_zeros(mask);
        best = bounds->promise[lane] > bounds->promise[best] ? lane : best;
    }
    return best;
}

// The boxes of a group at `level`, but for one that was looked at before (skip: its number, or any other).
static void paradt__search_group(paradt__search *s, int level, size_t group, size_t skip) {
    const double *boxes = s->grid->boxes[level] + group * s->grid->group_width;
    size_t span = (size_t)PARADT__LANES << (3 * level); // points a box
    size_t first = group * PARADT__LANES, lane;
    unsigned remaining = 255, mask, changes = s->changes, growths = s->growths;
    paradt__lane_bounds bounds;
    if (first * span < s->begin) remaining &= 255u << (s->begin / span - first);
    if ((first + PARADT__LANES) * span > s->end) remaining &= 255u >> (first + PARADT__LANES - 1 - (s->end - 1) / span);
    if (s->alive && !s->conflict) remaining &= s->alive[level][group];
    if (skip - first < PARADT__LANES) remaining &= ~(1u << (skip - first));
    mask = s->test.group(&s->q, boxes, &bounds) & remaining;
    while (mask && !s->found) {
        lane = level ? (size_t)paradt__most_promising(&bounds, mask) : (size_t)paradt__trailing_zeros(mask);
        mask &= ~(1u << lane);
        remaining &= ~(1u << lane);
        if (level) {
            paradt__search_group(s, level - 1, first + lane, SIZE_MAX);
        } else {
            paradt__search_cell(s, first + lane, bounds.f[lane], bounds.n[lane]);
        }
        // A smaller sphere rules out more boxes: worth another test where boxes are groups. Larger bounds need one.
        if (s->growths != growths || (level && mask && s->changes != changes)) {
            changes = s->changes;
            growths = s->growths;
            mask = s->test.group(&s->q, boxes, &bounds) & remaining;
        }
    }
}

// A first apex from the grid cells of the facet's vertices, so that most of the grid is ruled out from the start.
static void paradt__search_near(paradt__search *s) {
    size_t cells[3], best = SIZE_MAX;
    double least = 0.5 * PARADT__FAR, room[PARADT__GRID_ROOM];
    int i, count = 0;
    for (i = 0; i < s->space.dim && i < 3; i++) {
        cells[count] = (size_t)s->facet[i] / PARADT__LANES;
        count += count == 0 || (cells[count] != cells[count - 1] && cells[count] != cells[0]);
    }
    for (i = 0; i < count; i++) {
        double t = s->test.best(&s->q, paradt__grid_lanes(s->grid, s->set, cells[i], room));
        size_t position = cells[i] * PARADT__LANES + (size_t)paradt__lane_of(t);
        best = t < least ? position : best;
        least = t < least ? t : least;
    }
    s->distance_evaluations += (uint64_t)count * PARADT__LANES;
    s->grid_cells_visited += (uint64_t)count;
    if (best != SIZE_MAX) paradt__search_point(s, best);
}

// Is no point outside of the room (low and high of each axis) of use any more? The sphere's centre is m = centre / 2,
// its radius |m|, or for heavier points than the origin sqrt(|m|^2 + their gain). For u outside of the room, D = |u -
// m| is at least the distance of m from its walls, and F(u) >= D^2 - r^2 > K |u|_1 |u|_max + slack |u|_1, with |u|_1 <=
// sqrt(d) (D + r), if D - r > K d (D + r) + sqrt(d) slack; both sides grow with D so that the walls decide. With
// sagittas the disc of a facet that faces away from the reference sphere's centre takes the place of the sphere, even
// while there is no apex.
static int paradt__search_within(const paradt__search *s, const double *room) {
    int capped = s->q.disc_floor < PARADT__NO_BOUND, j, dim = s->space.dim;
    const double *whole = capped ? s->q.disc : s->q.centre, *slacks = capped ? s->q.disc_slack : s->q.slack;
    double nearest = PARADT__FAR, radius = capped ? s->q.disc_floor : 0.0, slack = 0.0;
    if (!capped && (s->apex < 0 || s->set->grade == PARADT__SAGITTA)) return 0;
    for (j = 0; j < dim; j++) {
        double m = 0.5 * whole[j]; // the differences first: they have small relative errors
        double low = (s->q.origin[j] - room[2 * j]) + m, high = (room[2 * j + 1] - s->q.origin[j]) - m;
        nearest = low < nearest ? low : nearest;
        nearest = high < nearest ? high : nearest;
        radius += m * m;
        slack = slacks[j] > slack ? slacks[j] : slack;
    }
    if (s->space.weighted && s->heaviest > s->q.weight) radius += s->heaviest - s->q.weight;
    radius = sqrt(radius);
    return nearest - radius > s->q.round * dim * (nearest + radius) + 3.0 * slack;
}

// The same for the room of a group.
static int paradt__search_inside(const paradt__search *s, int level, size_t group) {
    return paradt__search_within(s, s->grid->rooms[level] + group * 2 * (size_t)s->space.dim);
}

// All points that may matter, those near `position` first: its grid cell's group, then the groups around it level by
// level.
static void paradt__search_all(paradt__search *s, size_t position) {
    size_t box = position / PARADT__LANES, skip = SIZE_MAX;
    int level;
    if (!s->space.filtered) {
        for (box = s->begin; box < s->end && !s->found; box++) paradt__search_point(s, box);
        return;
    }
    for (level = 0; level < s->grid->levels && !s->found; level++) {
        size_t span = (size_t)PARADT__LANES << (3 * level);
        if (level && skip * span <= s->begin && (skip + 1) * span >= s->end) break;
        paradt__search_group(s, level, box / PARADT__LANES, skip);
        skip = box / PARADT__LANES;
        if (level && paradt__search_inside(s, level, skip)) break;
        box = skip;
    }
}

// The apex of the cell outside the facet opposite vertex `opposite` of the positively oriented cell, or PARADT__HULL.
// `made` gets the new cell's vertices, positively oriented, the apex at the place that is returned through *place.
static paradt_index paradt__search_apex(paradt__search *s, const paradt_index *cell, int opposite, paradt_index *made,
                                        int *place) {
    int dim = s->space.dim, i, count = 0;
    for (i = 0; i <= dim; i++) {
        if (i == opposite) continue;
        s->facet[count] = cell[i];
        s->corners[count++] = paradt__record(s->set, cell[i]);
    }
    // The apex in the place of `opposite` turns the orientation; dim - opposite exchanges move it to the end.
    s->outside = (dim - opposite) % 2 ? 1 : -1;
    s->conflict = s->found = 0;
    if (s->space.filtered) {
        paradt__search_facet(s, paradt__record(s->set, cell[opposite]));
        paradt__search_near(s);
    } else {
        s->apex = PARADT__OPEN;
    }
    paradt__search_all(s, (size_t)s->facet[0]);
    if (s->apex < 0) return PARADT__HULL;
    for (i = 0; i < dim; i++) made[i] = s->facet[i];
    made[dim] = s->apex;
    *place = dim;
    if (s->outside < 0) { // two vertices change places: other ones than the apex, if there are
        made[1] = s->facet[0];
        made[0] = dim > 1 ? s->facet[1] : s->apex;
        *place = dim > 1 ? dim : 0;
    }
    return s->apex;
}

// From the top: all points that may matter, when the facet is not one of the set's own.
static void paradt__search_down(paradt__search *s) {
    size_t at;
    if (s->space.filtered) {
        paradt__search_group(s, s->grid->levels - 1, 0, SIZE_MAX);
    } else {
        for (at = s->begin; at < s->end && !s->found; at++) paradt__search_point(s, at);
    }
}

// The sphere of a positively oriented cell, for a search of points in conflict with it. corners: its vertices, of which
// those that are in the set have the positions vertices[], the others positions that are none.
static void paradt__search_sphere(paradt__search *s, const double *const *corners, const paradt_index *vertices) {
    int dim = s->space.dim, i, j;
    const double *apex = corners[dim];
    double n = 0.0, n_bound = 0.0;
    for (i = 0; i < dim; i++) {
        s->facet[i] = vertices[i];
        s->corners[i] = corners[i];
    }
    s->outside = 1;
    s->conflict = 1;
    s->found = 0;
    if (s->space.filtered) {
        paradt__search_facet(s, apex);
        for (j = 0; j < dim; j++) {
            double u = apex[j] - s->q.origin[j];
            n += s->q.normal[j] * u;
            n_bound += paradt__abs(u) * s->q.reach[j];
        }
    }
    paradt__search_accept(s, vertices[dim], apex, n, n_bound);
    for (j = 0; j < s->space.ambient; j++) s->q.reach[j] = PARADT__NO_BOUND; // both sides
    s->q.n_floor = 0.0;
}

// A point in conflict with the positively oriented cell, or PARADT__OPEN: the cell is one of T(P).
static paradt_index paradt__search_conflict(paradt__search *s, const paradt_index *cell) {
    const double *corners[PARADT_MAX_DIM + 1];
    int i;
    for (i = 0; i <= s->space.dim; i++) corners[i] = paradt__record(s->set, cell[i]);
    paradt__search_sphere(s, corners, cell);
    paradt__search_all(s, (size_t)cell[0]);
    return s->found ? s->apex : (paradt_index)PARADT__OPEN;
}

// Turns a search to another set of the same space, under its grid. vertices: of the facet and the apex, as positions
// there, or positions that are none; that of the apex is the last one.
static void paradt__search_turn(paradt__search *s, const paradt__set *set, const paradt__grid *grid,
                                const paradt_index *vertices) {
    int i;
    for (i = 0; i < s->space.dim; i++) s->facet[i] = vertices[i];
    if (s->conflict) s->apex = vertices[s->space.dim];
    s->set = set;
    s->grid = grid;
    s->begin = 0;
    s->end = set->count;
}

// A facet of other points, for a search of points outside of it. outside: the sign of the orientation (facet, x) for x
// outside; inner: a point on the other side.
static void paradt__search_beyond(paradt__search *s, const double *const *facet, int outside, const double *inner) {
    int i;
    for (i = 0; i < s->space.dim; i++) {
        s->facet[i] = PARADT__NOWHERE;
        s->corners[i] = facet[i];
    }
    s->outside = outside;
    s->conflict = s->found = 0;
    s->apex = PARADT__OPEN;
    if (s->space.filtered) paradt__search_facet(s, inner);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>first simplex
//
// A cell of T(P) to begin with. MakeFirstSimplex of the thesis takes a point, its nearest neighbour, then again and
// again the point that gives the smallest circumscribing sphere. In floating point, among the points around the first,
// that is a good guess and no more. It is made certain by descent on the lifted points, as the simplex method does it:
// let z be a location in the guess; while a point q conflicts with the simplex, q replaces the one vertex that keeps z
// inside, and the lifted simplex above z gets lower. There is no cycling, for the perturbed heights are in general
// position, and the end is the cell of T(P) that contains z. z is the first vertex moved infinitesimally towards the
// second, far less towards the third, and so on: so the cell contains the first vertex (if that is not hidden) and
// begins the way from it to the second. Doors: paradt__cell_towards, paradt__walk.

// Orders the simplex so that it is positively oriented.
static void paradt__turn_positive(paradt__search *s, paradt_index *simplex) {
    const double *p[PARADT_MAX_DIM + 1];
    int dim = s->space.dim, i;
    for (i = 0; i <= dim; i++) p[i] = paradt__record(s->set, simplex[i]);
    if (paradt__orient(&s->space, p) < 0) {
        paradt_index last = simplex[dim];
        simplex[dim] = simplex[dim - 1];
        simplex[dim - 1] = last;
    }
}

// Sign of the orientation of the simplex with vertex `place` replaced by x.
static int paradt__orient_with(paradt__search *s, const paradt_index *simplex, int place, const double *x) {
    const double *p[PARADT_MAX_DIM + 1];
    int dim = s->space.dim, i;
    for (i = 0; i <= dim; i++) p[i] = i == place ? x : paradt__record(s->set, simplex[i]);
    return paradt__orient(&s->space, p);
}

// Does the simplex contain z (see the section's head), given through `goal`, the vertices of the first guess?
static int paradt__contains_goal(paradt__search *s, const paradt_index *simplex, const paradt_index *goal) {
    int dim = s->space.dim, place, i;
    for (place = 0; place <= dim; place++) {
        int side = 0;
        for (i = 0; i <= dim && !side; i++) {
            side = paradt__orient_with(s, simplex, place, paradt__record(s->set, goal[i]));
        }
        if (side < 0) return 0;
    }
    return 1;
}

// Replaces the vertex of the positively oriented simplex that lets it keep z.
static void paradt__pivot(paradt__search *s, paradt_index *simplex, const paradt_index *goal, paradt_index q) {
    int dim = s->space.dim, place;
    const double *x = paradt__record(s->set, q);
    for (place = 0; place <= dim; place++) {
        paradt_index trial[PARADT_MAX_DIM + 1];
        if (paradt__orient_with(s, simplex, place, x) == 0) continue;
        memcpy(trial, simplex, sizeof trial);
        trial[place] = q;
        paradt__turn_positive(s, trial);
        if (paradt__contains_goal(s, trial, goal)) {
            memcpy(simplex, trial, sizeof trial);
            return;
        }
    }
    PARADT_ASSERT(0);
}

// Of the points [begin, end) the one that gives the smallest circumscribing sphere with the `count` points of the
// simplex; they span the orthonormal rows, and centre is that of their own. With one point: its nearest neighbour. -1:
// none.
static paradt_index paradt__smallest_sphere(const paradt__search *s, const paradt_index *simplex, int count,
                                            size_t begin, size_t end, double rows[][PARADT_MAX_DIM], double *centre) {
    int ambient = s->space.ambient, i, j;
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

// The thesis' first simplex from the points near simplex[0]; a second point may be given too. 0: the guess failed.
static int paradt__guess_simplex(paradt__search *s, paradt_index *simplex, int given) {
    double rows[PARADT_MAX_DIM][PARADT_MAX_DIM], centre[PARADT_MAX_DIM] = {0.0};
    size_t span = PARADT__LANES * PARADT__LANES, begin = (size_t)simplex[0] / span * span, end = begin + span;
    int dim = s->space.dim, count;
    if (!s->space.filtered) return 0;
    if (end > s->set->count) end = s->set->count;
    for (count = 1; count <= dim; count++) {
        size_t from = count < given ? (size_t)simplex[count] : begin, to = count < given ? from + 1 : end;
        simplex[count] = paradt__smallest_sphere(s, simplex, count, from, to, rows, centre);
        if (simplex[count] < 0) return 0;
    }
    return paradt__orient_with(s, simplex, 0, paradt__record(s->set, simplex[0])) != 0;
}

// Any simplex with the first `given` (1 or 2) vertices; those exist, as the set spans its dimension.
static void paradt__any_simplex(paradt__search *s, paradt_index *simplex, int given) {
    paradt__set *set = (paradt__set *)(uintptr_t)s->set;
    const double *basis[PARADT_MAX_DIM + 1];
    int axes[PARADT_MAX_DIM + 1], i, taken = 0;
    paradt__set view = *set;
    view.space = s->space;
    view.space.ambient = s->space.dim; // only the axes that orient
    for (i = 0; i < given; i++) basis[i] = paradt__record(s->set, simplex[i]);
    if (given == 2) {
        while (paradt__bits(basis[0][taken]) == paradt__bits(basis[1][taken])) taken++;
        axes[0] = taken;
        taken = 1;
    }
    paradt__span(&view, NULL, basis, axes, taken, (size_t)simplex[0]);
    for (i = 0; i <= s->space.dim; i++) simplex[i] = (paradt_index)((size_t)(basis[i] - set->records) / set->width);
    s->space.counters = view.space.counters;
}

// The cell of T(P) at simplex[0] on the way to simplex[1] (given = 2), or to any other point (given = 1). The cell is
// positively oriented. It does not contain simplex[0] just when that is hidden.
static void paradt__cell_towards(paradt__search *s, paradt_index *simplex, int given) {
    paradt_index goal[PARADT_MAX_DIM + 1], q;
    if (!paradt__guess_simplex(s, simplex, given)) paradt__any_simplex(s, simplex, given);
    memcpy(goal, simplex, sizeof goal);
    paradt__turn_positive(s, simplex);
    while ((q = paradt__search_conflict(s, simplex)) >= 0) paradt__pivot(s, simplex, goal, q);
}

// One step of a visibility walk in T(P): replaces the cell by its neighbour across a facet that has x outside. 0: there
// is no such facet. Such walks end in every regular triangulation (Edelsbrunner, Combinatorica 10, 1990).
static int paradt__walk(paradt__search *s, paradt_index *cell, const double *x) {
    int dim = s->space.dim, place, unused;
    for (place = 0; place <= dim; place++) {
        if (paradt__orient_with(s, cell, place, x) < 0) {
            paradt_index made[PARADT_MAX_DIM + 1];
            if (paradt__search_apex(s, cell, place, made, &unused) < 0) return 0;
            memcpy(cell, made, sizeof made);
            return 1;
        }
    }
    return 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>incode
//
// Incremental construction: from a first cell, a cell on each active facet, until there is none. What is common to all
// methods that make cells facet by facet is here: the store of the cells, the active face list, and the region for
// which the cells are made. A vertex that no active facet is left at has all its cells, and can't be an apex any more.
// InCoDe counts the active facets at each vertex and takes grid cells and groups without other points out of the
// search: it need not look behind the front.
//
// Regions. The edge from v to w leads away if w is farther than v from the cut nearest to v (farther along its axis; if
// equally far, if w is lexicographically larger). A region reaches a cell in which an edge leads away from one of the
// region's points: needed are the facets in which one does. All such cells are found from one around each vertex: the
// neighbours w of v that edges lead away to are connected by edges among themselves (the vertices of the vertex figure
// of the lifted hull at v on one side of a plane: Balinski's argument), so from one edge (v, w) all the others are
// reached around their ends, and all cells around them. Facets that are not needed end in the seam: they are stored, so
// that two cells that both were made get linked, but not worked on. A vertex of the region that no edge led away from
// gets a cell of its own to start from.
//
// The owner of a cell is, of the regions that reach it, the one with most of its vertices, of several the first. Two
// points u and v of one region have an edge that leads away: let u be nearer to its nearest cut, or equally near, and
// that cut not a later one. Then v is farther from that cut, unless the rounded distances are equal; but then it is
// nearest to v too, and one of two points is always the farther. So a cell with two vertices in a region is reached by
// it, and few cells are made by several: those across a cut with two vertices on either side, and some in which the cut
// nearest to a vertex is not the one that the cell crosses.
//
// A few cells nobody reaches, where boxes meet at an edge or corner. They are in clusters, connected by facets in which
// no edge leads away. A region that owns a cell with such a facet looks behind it; if it finds one of a cluster there,
// it goes on to all of the cluster and the cells next to it: these facets are its doors. So whoever owns a cell next to
// a cluster knows all of them, and the first of these owns the cluster. If there is none, the cluster is all of T(P):
// then every region has it, since all begin with a cell, and the first that has points owns it.
//
// Doors: paradt__front_begin, paradt__front_end, paradt__front_add, paradt__front_expand, paradt__front_seed,
// paradt__incode, paradt__cell_owner.

typedef struct paradt__region_view {
    const uint32_t *owner; // [set.count] region of each point; NULL: undivided
    const paradt__cuts *cuts;
    uint32_t region;
} paradt__region_view;

typedef struct paradt__finished {
    uint32_t *incident;                 // [set.count] active facets at each vertex; NULL: not counted
    uint8_t *unfinished;                // [grid.cell_count] points of each grid cell
    uint8_t *alive[PARADT__MAX_LEVELS]; // [level][group] bits of the boxes with unfinished points
} paradt__finished;

typedef struct paradt__front {
    const paradt__set *set;
    const paradt__grid *grid;
    paradt__memory *memory;
    paradt__search search;
    paradt__cells cells;
    paradt__active active; // to be worked on
    paradt__active seam;   // with regions: not needed, but known
    paradt__lists lists;
    paradt__region_view view;
    paradt__progress progress;
    double expected;  // cells, for the progress
    int impatient;    // 1: give up where the filters decide too little; see paradt__front_is_stuck
    uint64_t seeding; // predicates for the cells to start from: they come with the region, not with its cells
    uint64_t hull_facets;
    paradt__finished finished;
    uint64_t *touched;  // with regions: a bit for each vertex that an edge leads away from
    paradt_index doors; // with regions: list of facets to look behind
    size_t next_seed;   // positions before it need no seed
} paradt__front;

// Cells a point of T(P) for uniform points, far from the hull (d = 2, 3: exact; d >= 4: Dwyer 1991, the constants of
// the Poisson-Delaunay mosaic); near the hull there are fewer.
static double paradt__cells_a_point(int dim) {
    static const double mean[PARADT_MAX_DIM + 1] = {1.0, 1.0, 2.0, 6.7677, 31.78, 186.1, 1297.0, 10470.0, 96000.0};
    return mean[dim];
}

// The part of them that is left for so many points in all. The exponents for d >= 5 are fitted to uniform points: 0.78
// of the cells for 4,000 points in five dimensions, 0.46 for 1,000 in six, 0.16 for 300 in seven, 0.04 for 150 in
// eight.
static double paradt__off_hull(double points, int dim) {
    double layer = pow(points + 1.0, -1.0 / dim);
    return dim < 5 ? 1.0 - 0.5 * layer : pow(1.0 - layer, dim - 3.8);
}

static void paradt__finished_free(paradt__finished *finished, paradt__memory *memory) {
    int level;
    paradt__release(memory, finished->incident);
    paradt__release(memory, finished->unfinished);
    for (level = 0; level < PARADT__MAX_LEVELS; level++) paradt__release(memory, finished->alive[level]);
    memset(finished, 0, sizeof *finished);
}

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

// Adds to the count of active facets at a vertex; at 0 it is finished.
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

static void paradt__front_end(paradt__front *front) {
    paradt__active_free(&front->active, front->memory);
    paradt__active_free(&front->seam, front->memory);
    paradt__lists_free(&front->lists, front->memory);
    paradt__finished_free(&front->finished, front->memory);
    paradt__release(front->memory, front->touched);
    front->touched = NULL;
}

// Room for the cells that are expected, or where that is refused for some: weighted points may have far fewer.
static paradt_status paradt__front_room(paradt__front *front) {
    const size_t some = 1 << 16, most = paradt__most_cells(front->cells.corners);
    double expected = front->expected * 1.01 + 64.0;
    size_t cells = expected < (double)most ? (size_t)expected : most;
    paradt_status status = paradt__cells_reserve(&front->cells, 1, cells, front->memory);
    if (!status || cells <= some) return status;
    paradt__release(front->memory, front->cells.vertices); // the one array that may be there
    front->cells.vertices = NULL;
    return paradt__cells_reserve(&front->cells, 1, some, front->memory);
}

// share: the part of the points that the front is for.
static paradt_status paradt__front_begin(paradt__front *front, const paradt__set *set, const paradt__grid *grid,
                                         paradt__memory *memory, paradt__region_view view, double share) {
    double points = (double)set->count * share;
    memset(front, 0, sizeof *front);
    front->set = set;
    front->grid = grid;
    front->memory = memory;
    front->view = view;
    front->doors = PARADT__OPEN;
    front->cells.corners = set->space.dim + 1;
    front->expected = points * paradt__cells_a_point(set->space.dim) * paradt__off_hull(points, set->space.dim) + 16.0;
    paradt__search_begin(&front->search, set, grid);
    if (view.owner) {
        size_t words = set->count / 64 + 1;
        front->touched = (uint64_t *)paradt__alloc(memory, words, sizeof(uint64_t));
        if (!front->touched || paradt__active_begin(&front->seam, 0, memory)) return PARADT_ERROR_MEMORY;
        memset(front->touched, 0, words * sizeof(uint64_t));
    }
    if (paradt__active_begin(&front->active, (size_t)points, memory)) return PARADT_ERROR_MEMORY;
    return paradt__front_room(front);
}

// Does the edge from a point to another lead away from the cut, the one nearest to it, or NULL?
static int paradt__edge_leads_away(const paradt__space *space, const paradt__cut *cut, const double *from,
                                   const double *to) {
    if (cut) {
        int64_t x = paradt__ordered_bits(from[cut->axis]), y = paradt__ordered_bits(to[cut->axis]);
        if (x != y) return (y < x) == paradt__cut_is_above(cut, from);
    }
    return paradt__compare(space, to, from) > 0;
}

// Does an edge of the simplex lead away from its vertex `place`?
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

// Has the facet an edge that leads away from a point of the region? Two points of the region have one.
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

// The owner of a cell or facet: of the regions that reach it, the one with most vertices, of several the first.
// PARADT__OPEN: nobody reaches it.
static paradt_index paradt__cell_owner(const paradt__region_view *view, const paradt__set *set,
                                       const paradt_index *simplex, int count) {
    paradt_index owner = PARADT__OPEN;
    int most = 0, i, j;
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

static void paradt__touch(paradt__front *front, const paradt_index *cell) {
    int corners = front->cells.corners, i;
    for (i = 0; i < corners; i++) {
        uint64_t *word = front->touched + cell[i] / 64, bit = (uint64_t)1 << cell[i] % 64;
        if (front->view.owner[cell[i]] != front->view.region || *word & bit) continue;
        if (paradt__leads_away(&front->view, front->set, cell, corners, i)) *word |= bit;
    }
}

// The vertices of the facet opposite `opposite`, in the cell's order.
PARADT__INLINE void paradt__facet_of(const paradt_index *cell, int corners, int opposite, paradt_index *facet) {
    int i, count = 0;
    for (i = 0; i < corners; i++) {
        if (i != opposite) facet[count++] = cell[i];
    }
}

// Called for a facet that has become active and is needed: puts it into a work list. NULL: there are no lists.
typedef paradt_status (*paradt__activate)(paradt__front *front, void *method, paradt_index handle);

// Stores a cell and updates the AFL with its facets: a facet that was active is linked and leaves, the others enter.
// across: the place of the apex, whose facet is the one that the cell was made on, and that facet's handle; or -1.
PARADT__INLINE paradt_status paradt__add_cell(paradt__front *front, const paradt_index *cell, int across,
                                              paradt_index from, paradt__activate activate, void *method, int corners) {
    paradt__cells *cells = &front->cells;
    paradt_index number = (paradt_index)cells->count, base = number * corners;
    uint64_t sum = paradt__cell_sum(cell, corners);
    paradt_status status = PARADT_OK;
    int i, change[PARADT_MAX_DIM + 1], sum_of_changes = 0;
    uint32_t keys[PARADT_MAX_DIM + 1];
    paradt_index smallest[PARADT_MAX_DIM + 1], *chains[PARADT_MAX_DIM + 1], facet[PARADT_MAX_DIM];
    paradt__active *table = &front->active;
    for (i = 0; i < corners; i++) {
        cells->vertices[base + i] = cell[i];
        keys[i] = paradt__facet_key(sum - paradt__vertex_key(cell[i]));
        smallest[i] = paradt__smallest_but(cell, corners, i);
        chains[i] = paradt__active_chain(table, smallest[i], keys[i]);
        PARADT__PREFETCH(chains[i]);
    }
    for (i = 0; i < corners; i++) PARADT__PREFETCH(table->links + (*chains[i] < 0 ? 0 : *chains[i]));
    for (i = 0; i < corners && !status; i++) {
        paradt_index twin = from;
        if (i != across) {
            if (front->view.owner) {
                paradt__facet_of(cell, corners, i, facet);
                table = paradt__needs(&front->view, front->set, facet, corners - 1) ? &front->active : &front->seam;
                chains[i] = paradt__active_chain(table, smallest[i], keys[i]);
            }
            twin = paradt__active_match(table, cells, chains[i], smallest[i], keys[i], base + i, corners);
        }
        cells->neighbors[base + i] = twin < 0 ? (paradt_index)PARADT__OPEN : twin / corners;
        change[i] = twin < 0 ? 1 : -1;
        sum_of_changes += change[i];
        if (twin >= 0) {
            cells->neighbors[twin] = number;
        } else if (activate && table == &front->active) {
            status = activate(front, method, base + i);
        }
    }
    for (i = 0; i < corners && front->finished.incident && !status; i++) {
        paradt__finished_count(&front->finished, front->grid, cell[i], sum_of_changes - change[i]);
    }
    cells->count++;
    return status;
}

// Lists the facets of the newest cell behind which there may be a cell that nobody reaches, if it is for the region to
// look. No two vertices of such a cell are of one region.
static paradt_status paradt__front_list_doors(paradt__front *front) {
    const paradt__cells *cells = &front->cells;
    int corners = cells->corners, foreign = 0, i;
    size_t base = (cells->count - 1) * (size_t)corners;
    const paradt_index *cell = cells->vertices + base;
    paradt_index facet[PARADT_MAX_DIM], owner;
    paradt_status status = PARADT_OK;
    for (i = 0; i < corners; i++) foreign += front->view.owner[cell[i]] != front->view.region;
    if (foreign < corners - 2 || front->view.cuts->boxes < (size_t)corners) return PARADT_OK;
    owner = paradt__cell_owner(&front->view, front->set, cell, corners);
    if (owner >= 0 && owner != (paradt_index)front->view.region) return PARADT_OK;
    for (i = 0; i < corners && !status; i++) {
        if (cells->neighbors[base + (size_t)i] != PARADT__OPEN) continue;
        paradt__facet_of(cell, corners, i, facet);
        if (paradt__cell_owner(&front->view, front->set, facet, corners - 1) < 0)
            status = paradt__list_push(&front->lists, &front->doors, (paradt_index)base + i, front->memory);
    }
    return status;
}

static paradt_status paradt__front_add(paradt__front *front, const paradt_index *cell, int across, paradt_index from,
                                       paradt__activate activate, void *method) {
    paradt_status status = paradt__cells_room(&front->cells, front->memory);
    if (!status) status = paradt__active_room(&front->active, front->memory);
    if (!status && front->view.owner) status = paradt__active_room(&front->seam, front->memory);
    if (status) return status;
    if (front->touched) paradt__touch(front, cell);
    if (front->cells.corners == 4) status = paradt__add_cell(front, cell, across, from, activate, method, 4);
    else status = paradt__add_cell(front, cell, across, from, activate, method, front->cells.corners);
    if (!status && front->view.owner) status = paradt__front_list_doors(front);
    if (!status && front->cells.count % 1024 == 0) {
        double done = (double)front->cells.count / front->expected;
        if (paradt__progress_cancels(&front->progress, done)) status = PARADT_ERROR_CANCELLED;
    }
    return status;
}

// MakeSimplex on a facet that was taken out of the AFL: the cell outside of it, or a facet of the hull.
static paradt_status paradt__front_expand(paradt__front *front, paradt_index handle, paradt__activate activate,
                                          void *method) {
    int corners = front->cells.corners, opposite = (int)(handle % corners), place;
    const paradt_index *cell = front->cells.vertices + (handle - opposite);
    paradt_index made[PARADT_MAX_DIM + 1];
    if (paradt__search_apex(&front->search, cell, opposite, made, &place) >= 0) {
        return paradt__front_add(front, made, place, handle, activate, method);
    }
    front->hull_facets++;
    front->cells.neighbors[handle] = PARADT__HULL;
    for (place = 0; place < corners && front->finished.incident; place++) {
        if (place != opposite) paradt__finished_count(&front->finished, front->grid, cell[place], -1);
    }
    return PARADT_OK;
}

// A cell behind a door, or 0 when there is none: one of a cluster, or next to it.
static int paradt__front_pass_door(paradt__front *front, paradt_index *cell) {
    int corners = front->cells.corners, unused;
    while (front->doors >= 0) {
        paradt_index handle = paradt__list_pop(&front->lists, &front->doors);
        const paradt_index *from = front->cells.vertices + handle / corners * corners;
        if (front->cells.neighbors[handle] != PARADT__OPEN) continue;
        if (paradt__search_apex(&front->search, from, (int)(handle % corners), cell, &unused) < 0) continue;
        if (paradt__cell_owner(&front->view, front->set, cell, corners) < 0 ||
            paradt__cell_owner(&front->view, front->set, from, corners) < 0)
            return 1;
    }
    return 0;
}

// A cell with an edge that leads away from the vertex, or 0 when there is none. The region's first cell may be any at
// it.
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
    if (step == set->count && front->cells.count) return 0;
    cell[0] = (paradt_index)vertex;
    cell[1] = (paradt_index)other;
    paradt__cell_towards(&front->search, cell, 2);
    for (i = 0; i < front->cells.corners; i++) {
        if (cell[i] == (paradt_index)vertex) return 1;
    }
    return 0;
}

// A cell to start from: behind a door, or at a vertex of the region that still needs one; or 0 when there is none.
// Undivided, there is one.
static int paradt__front_seed(paradt__front *front, paradt_index *cell) {
    const paradt__set *set = front->set;
    if (!front->view.owner) {
        cell[0] = (paradt_index)(set->count / 2);
        if (front->next_seed++) return 0;
        paradt__cell_towards(&front->search, cell, 1);
        return 1;
    }
    if (paradt__front_pass_door(front, cell)) return 1;
    while (front->next_seed < set->count) {
        size_t at = front->next_seed++;
        if (front->view.owner[at] != front->view.region || front->touched[at / 64] >> at % 64 & 1) continue;
        if (paradt__front_seed_at(front, at, cell)) return 1;
    }
    return 0;
}

enum { PARADT__PATIENCE = 4, PARADT__FIRST_PATIENCE = 2000 };

static uint64_t paradt__front_predicates(const paradt__front *front) {
    return front->search.space.counters.orient_calls + front->search.space.counters.insphere_calls;
}

// Where many points are on one sphere (lattices, points exactly on a sphere), a search has to compare them all with
// each other, exactly, and insertion is faster. On points in general position a cell takes less than a tenth of a
// predicate.
static int paradt__front_is_stuck(const paradt__front *front) {
    uint64_t patience = PARADT__PATIENCE * (uint64_t)front->cells.count + PARADT__FIRST_PATIENCE;
    return paradt__front_predicates(front) - front->seeding > patience;
}

static int paradt__front_next_seed(paradt__front *front, paradt_index *cell) {
    uint64_t before = paradt__front_predicates(front);
    int found = paradt__front_seed(front, cell);
    front->seeding += paradt__front_predicates(front) - before;
    return found;
}

// The facets at the lowest vertices in grid order come first: the front sweeps over the grid, and what it touches stays
// in the cache.
static paradt_status paradt__incode(paradt__front *front) {
    paradt_status status = PARADT_OK;
    paradt_index cell[PARADT_MAX_DIM + 1];
    if (!front->view.owner) {
        status = paradt__finished_begin(&front->finished, front->set, front->grid, front->memory);
        front->search.alive = front->finished.alive;
    }
    while (!status && paradt__front_next_seed(front, cell)) {
        paradt_index handle = PARADT__OPEN;
        status = paradt__front_add(front, cell, -1, PARADT__OPEN, NULL, NULL);
        while (!status && (handle = paradt__active_first(&front->active)) >= 0) {
            status = paradt__front_expand(front, handle, NULL, NULL);
            if (!status && front->impatient && paradt__front_is_stuck(front)) return PARADT__GAVE_UP;
        }
    }
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>dewall
//
// Divide and conquer, merge first (Cignoni, Montani, Scopigno, CAD 1998; thesis, chapter 3). A plane alpha halves the
// points; first all cells that cross it are made, the wall, with MakeSimplex on the facets that cross it (AFL alpha);
// what remains on the two sides has nothing in common any more, and is built by recursion from the facets the wall left
// there (AFL 1 and AFL 2). The planes are those of the grid, so a half is a range of positions, and MakeSimplex looks
// into that range only: all cells with a vertex elsewhere are in walls made before. Where no active facet crosses
// alpha, either no cell of this range crosses it or none that crosses it has been made: for a facet between a cell of
// the range and one of another wall would be active and cross alpha. Any cell of T(P) that crosses alpha decides which;
// one is found by a walk from one side to the other. With a region not all of a wall is needed; then facets can lead
// out of a range, and go back to the caller. Doors: paradt__dewall.

enum { PARADT__WALL_SMALL = 64 }; // points that are not divided further

typedef struct paradt__wall {
    size_t begin, cut, end;
    paradt_index alpha, one, two; // facets that cross the plane, or are in [begin, cut), or in [cut, end)
    paradt_index outside;         // facets with a vertex out of the range
} paradt__wall;

static paradt_status paradt__wall_activate(paradt__front *front, void *method, paradt_index handle) {
    paradt__wall *wall = (paradt__wall *)method;
    size_t low = SIZE_MAX, high = 0;
    paradt_index *head = &wall->alpha;
    int corners = front->cells.corners, opposite = (int)(handle % corners), i;
    const paradt_index *cell = front->cells.vertices + (handle - opposite);
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

// Moves the facets of a list to the lists of the wall.
static paradt_status paradt__wall_receive(paradt__front *front, paradt__wall *wall, paradt_index *head) {
    paradt_status status = PARADT_OK;
    while (*head >= 0 && !status) status = paradt__wall_activate(front, wall, paradt__list_pop(&front->lists, head));
    return status;
}

// Takes a facet from a list out of the AFL, if it is still active.
static int paradt__front_take(paradt__front *front, paradt_index handle) {
    int corners = front->cells.corners, opposite = (int)(handle % corners);
    const paradt_index *cell = front->cells.vertices + (handle - opposite);
    uint32_t key = paradt__facet_key(paradt__cell_sum(cell, corners) - paradt__vertex_key(cell[opposite]));
    if (front->cells.neighbors[handle] != PARADT__OPEN) return 0;
    paradt__active_remove(&front->active, paradt__smallest_but(cell, corners, opposite), key, handle);
    return 1;
}

// Works on a list of the wall until it is empty.
static paradt_status paradt__wall_serve(paradt__front *front, paradt__wall *wall, paradt_index *head) {
    paradt_status status = PARADT_OK;
    while (*head >= 0 && !status) {
        paradt_index handle = paradt__list_pop(&front->lists, head);
        if (paradt__front_take(front, handle)) {
            status = paradt__front_expand(front, handle, paradt__wall_activate, wall);
        }
    }
    return status;
}

// A cell of the range that crosses the plane, where no active facet does. 0: there is none.
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
    front->search.begin = 0;
    front->search.end = set->count;
    paradt__cell_towards(&front->search, cell, 2);
    do {
        int behind = 0, within = 0;
        for (i = 0; i <= dim; i++) {
            behind += paradt__before(space, p, paradt__record(set, cell[i]), axis);
            within += (size_t)cell[i] >= wall->begin && (size_t)cell[i] < wall->end;
        }
        if (behind > 0 && behind <= dim) return within == dim + 1;
    } while (paradt__walk(&front->search, cell, q));
    return 0;
}

// Builds the cells of the positions [begin, end), of which some facets in *head are active. Facets that lead out of the
// range are added to *outside. The depth is at most the logarithm of the number of points.
static paradt_status paradt__wall_build(paradt__front *front, size_t begin, size_t end, paradt_index *head,
                                        paradt_index *outside) {
    paradt__wall wall;
    paradt_status status;
    wall.begin = begin;
    wall.end = wall.cut = end;
    wall.alpha = wall.one = wall.two = PARADT__OPEN;
    wall.outside = *outside;
    if (end - begin > PARADT__WALL_SMALL) wall.cut = paradt__grid_cut(begin, end);
    status = paradt__wall_receive(front, &wall, head);
    if (!status && wall.alpha < 0 && wall.cut < end && !front->view.owner && (wall.one >= 0 || wall.two >= 0)) {
        paradt_index cell[PARADT_MAX_DIM + 1];
        if (paradt__wall_seed(front, &wall, cell)) {
            status = paradt__front_add(front, cell, -1, PARADT__OPEN, paradt__wall_activate, &wall);
        }
    }
    while (!status && (wall.alpha >= 0 || wall.one >= 0 || wall.two >= 0)) {
        paradt_index back = PARADT__OPEN;
        if (!front->view.owner) front->search.begin = begin, front->search.end = end;
        status = paradt__wall_serve(front, &wall, &wall.alpha);
        if (!status && wall.cut == end) status = paradt__wall_serve(front, &wall, &wall.one);
        if (!status && wall.one >= 0) status = paradt__wall_build(front, begin, wall.cut, &wall.one, &back);
        if (!status && wall.two >= 0) status = paradt__wall_build(front, wall.cut, end, &wall.two, &back);
        if (!status) status = paradt__wall_receive(front, &wall, &back);
    }
    *outside = wall.outside;
    return status;
}

// On a line facets are points, which cross nothing: there is no wall to build.
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

// ---------------------------------------------------------------------------------------------------------------------
// >>bowyer-watson
//
// Incremental insertion (Bowyer 1981, Watson 1981): the cells in conflict with a new point form a star-shaped cavity,
// found from any one of them through their neighbours; the point and the cavity's rim make the new cells. The hull is
// closed by ghost cells, whose vertex PARADT__INFINITE lies beyond everything, so that inside and outside are one case.
// A ghost is in conflict with the points strictly beyond its hull facet. In the plane of the facet, it is in conflict
// with the points of the facet's circumscribing disc; these are the points of the plane with which the finite cell on
// the facet is in conflict, and that remains so under the perturbation: the lift of a point in the plane is compared
// with an affine function through the facet's lifted vertices alone.
// Every T(P_i) of the points so far is complete and exact, so no cell is ever flat, and the last one is T(P).
// A weighted point that is in conflict with no cell is hidden; a vertex inside of the cavity becomes hidden.
//
// The points come in rounds of 16 times the size of the one before (Amenta, Choi and Rote, "Incremental
// constructions con BRIO", SoCG 2003), within a round along Hilbert's curve. The order only matters for speed.
// Doors: paradt__bowyer_watson.

enum {
    PARADT__INFINITE = -1, // the vertex of ghost cells that is no point
    PARADT__DEAD = -3,     // first vertex of a free place
    PARADT__CONFLICT = 1,  // a mark: in conflict with the point that is being inserted
    PARADT__GROW_PART = 16,
    PARADT__FEW_POINTS = 1 << 15, // get room for all the cells to be expected at once
    PARADT__JUDGED_PART = 32      // of more points this part tells how many cells the rest will have
};

#define PARADT__EXPECT_MORE 1.08

#if defined(PARADT__AVX2) && !defined(PARADT_INDEX64)
#define PARADT__BW_AVX2 1
#else
#define PARADT__BW_AVX2 0
#endif

// Whether four indices fit into a register that every processor of the kind has
#if defined(__SSE2__) && !defined(PARADT_NO_SIMD) && !defined(PARADT_INDEX64)
#define PARADT__FOUR_AT_ONCE 1
#else
#define PARADT__FOUR_AT_ONCE 0
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>order of insertion
//
// Doors: to be listed.

enum {
    PARADT__ROUND_SHIFT = 4,  // a round is 2^4 times as large as the one before
    PARADT__FIRST_ROUND = 16, // points of the first round, about
    PARADT__MOST_ROUNDS = 15
};

// How many rounds come after the first, for so many points
static int paradt__round_count(size_t count) {
    int rounds = 0;
    while (rounds < PARADT__MOST_ROUNDS && count >> ((rounds + 1) * PARADT__ROUND_SHIFT) >= PARADT__FIRST_ROUND)
        rounds++;
    return rounds;
}

// Of 16 neighbours, those numbered from 16 * group on, the one that comes earlier than in the last round; of 16 such
// ones, at the next level, the one that comes earlier still.
PARADT__INLINE size_t paradt__earlier_one(size_t group, int level) {
    uint64_t draw = paradt__mix((uint64_t)group + ((uint64_t)level << 58) + 1);
    return (group << PARADT__ROUND_SHIFT) + (size_t)(draw >> 32 & ((1u << PARADT__ROUND_SHIFT) - 1));
}

// The round of the one that comes earlier than the others of its group: 0 to rounds - 1. One of 16 neighbours, at
// random, and one of 16 such ones: so a round's points are spread more evenly than by chance, and 2 % fewer cells are
// made.
static int paradt__earlier_round(size_t group, int rounds) {
    int level = 1;
    for (; level < rounds && paradt__earlier_one(group >> PARADT__ROUND_SHIFT, level) == group; level++)
        group >>= PARADT__ROUND_SHIFT;
    return rounds - level;
}

// Points that are dealt to the rounds of an insertion as they come along the curve
typedef struct paradt__rounds {
    paradt_index *order;                   // [count]
    int rounds;                            // after the first
    size_t place[PARADT__MOST_ROUNDS + 1]; // where each round's next point goes
    size_t next, earlier;                  // the number of the next point, and that of its group that comes earlier
} paradt__rounds;

static paradt_status paradt__rounds_begin(paradt__rounds *r, size_t count, paradt__memory *memory) {
    size_t group, groups = 0, before = 0;
    int round;
    memset(r, 0, sizeof *r);
    r->order = (paradt_index *)paradt__alloc_filled(memory, count, sizeof *r->order);
    if (!r->order) return PARADT_ERROR_MEMORY;
    r->rounds = paradt__round_count(count);
    for (group = 0; r->rounds && group << PARADT__ROUND_SHIFT < count; group++) {
        if (paradt__earlier_one(group, 0) < count) r->place[paradt__earlier_round(group, r->rounds)]++, groups++;
    }
    for (round = 0; round < r->rounds; round++) {
        size_t size = r->place[round];
        r->place[round] = before;
        before += size;
    }
    r->place[r->rounds] = groups;
    return PARADT_OK;
}

// The next point along the curve
PARADT__INLINE void paradt__rounds_put(paradt__rounds *r, paradt_index point) {
    size_t group = r->next >> PARADT__ROUND_SHIFT;
    int round = r->rounds;
    if (r->next == group << PARADT__ROUND_SHIFT) r->earlier = r->rounds ? paradt__earlier_one(group, 0) : SIZE_MAX;
    if (r->next++ == r->earlier) round = paradt__earlier_round(group, r->rounds);
    r->order[r->place[round]++] = point;
}

// Positions on the curve by rounds, and in each in their order: a new block, or NULL when there is no memory.
static paradt_index *paradt__round_order(size_t count, paradt__memory *memory) {
    paradt__rounds r;
    size_t i;
    if (paradt__rounds_begin(&r, count, memory)) return NULL;
    for (i = 0; i < count; i++) paradt__rounds_put(&r, (paradt_index)i);
    return r.order;
}

// A curve, by the box of its lattice and how many points are along it
typedef struct paradt__curve {
    const int64_t *low, *high;
    size_t along;
} paradt__curve;

// Where the curve comes by next to a point: the key of the nearest place in a box, its corners as ordered bits.
static uint64_t paradt__key_near(const paradt__hilbert *hilbert, const paradt__lattice *lattice, const double *x,
                                 const int64_t *low, const int64_t *high) {
    double inside[PARADT_MAX_DIM];
    int axis;
    for (axis = 0; axis < lattice->dim; axis++) {
        int64_t bits = paradt__ordered_bits(x[axis]);
        bits = bits < low[axis] ? low[axis] : bits > high[axis] ? high[axis] : bits;
        inside[axis] = paradt__from_ordered_bits(bits);
    }
    return paradt__curve_key(hilbert, lattice, inside);
}

// The first `own` points of the set are along a curve, in the box of low and high. The others come where it passes
// them, within a few own ones. sorted, other: room for set->count - own.
static void paradt__merge_others(const paradt__set *set, size_t own, const paradt__curve *curve, const int64_t *low,
                                 const int64_t *high, paradt__keyed *sorted, paradt__keyed *other, paradt__rounds *r) {
    enum { FEW = 16 };
    paradt__hilbert hilbert;
    paradt__lattice lattice;
    int ambient = set->space.ambient, levels = paradt__levels_for(curve->along, ambient);
    size_t others = set->count - own, i, few, end, next = 0;
    paradt__hilbert_begin(&hilbert, ambient, others + own / FEW);
    paradt__lattice_begin(&lattice, ambient, levels, 0, curve->low, curve->high);
    for (i = 0; i < others; i++) {
        sorted[i].point = (paradt_index)(own + i);
        sorted[i].key = paradt__key_near(&hilbert, &lattice, set->records + (own + i) * set->width, low, high);
    }
    paradt__keyed_sort(sorted, other, others, ambient * levels, 0);
    for (i = 0; i < own; i += FEW) {
        uint64_t key = paradt__curve_key(&hilbert, &lattice, set->records + i * set->width);
        while (next < others && sorted[next].key < key) paradt__rounds_put(r, sorted[next++].point);
        for (end = i + FEW < own ? i + FEW : own, few = i; few < end; few++) paradt__rounds_put(r, (paradt_index)few);
    }
    while (next < others) paradt__rounds_put(r, sorted[next++].point);
}

// The positions of the set's points by rounds, and in each along the curve that the first `own` are along, as above: a
// new block, or NULL when there is no memory.
static paradt_index *paradt__merged_order(const paradt__set *set, size_t own, const paradt__curve *curve,
                                          const int64_t *low, const int64_t *high, paradt__memory *memory) {
    size_t others = set->count - own;
    paradt__rounds r;
    paradt__keyed *sorted, *other;
    if (!own || !others) return paradt__round_order(set->count, memory);
    sorted = (paradt__keyed *)paradt__alloc(memory, others, sizeof *sorted);
    other = (paradt__keyed *)paradt__alloc(memory, others, sizeof *other);
    if (!sorted || !other || paradt__rounds_begin(&r, set->count, memory)) r.order = NULL;
    else paradt__merge_others(set, own, curve, low, high, sorted, other, &r);
    paradt__release(memory, other);
    paradt__release(memory, sorted);
    return r.order;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>kept spheres
//
// Doors: to be listed.

// A cell's sphere is kept as the affine function of x that the power of x with regard to the sphere is, less |x|^2:
//     power(x) = |x|^2 + normal . x + constant, x from the centre of the set's bounding box; negative inside.
// Ghosts have the halfspace beyond their facet in the place of a ball: a function so steep that |x|^2 does not matter.
// So a test is one dot product, for ghosts too. Where its value does not exceed the bound on its error, the predicates
// decide. The spheres are kept in a table, each in the place that its cell's number says; one that another has driven
// out is made again when it is wanted.
//
// The error. u = 2^-52 bounds a rounding's relative error in any rounding mode. With p one of the vertices, and a, b, c
// the differences of the other three to it, a cell's sphere is power(x) = |x - p|^2 - w . (x - p), w = n / det,
//     n = |a|^2 b x c + |b|^2 c x a + |c|^2 a x b,   det = a . b x c > 0.
// Let P be at least the sum of the sizes of det's six terms, and N_j that of n_j's. A difference has an error of u
// relative to it, so a product of two has at most 3u, the terms of b x c 4u, those of det 8u: det is wrong by at most
// 8.1u P. |a|^2 is wrong by 5u of it, n_j by 12.1u N_j. Where det > 32u P, the true determinant is more than 0.74 of
// it, and w_j is wrong by at most 2.1u |w_j| + (11u P |w_j| + 16.4u N_j) / det. (The first two terms of n may be made
// as v x c, v = |a|^2 b - |b|^2 a, with fewer operations: 8u for v's terms, 11u for v x c's, 12.1u for n's.) With s_p,
// s_x the computed differences of p and x to the centre, h_j the largest size of an |s_j| in the set, and
//     normal = -(2 s_p + w), constant = |s_p|^2 + w . s_p,
// a term of the power passes at most 15 roundings, and the sizes of the terms add up to at most 4 H + 2 W, H = sum
// h_j^2, W = sum |w_j| h_j: that is 60u H + 30u W. The error of w counts 2 h_j times. As det < 1.1 P, W alone counts
// less than 1.1 W P / det. In all less than
//     64u (H + (P W + sum N_j h_j) / det);
// 60 and less than 60 are rounded up so far that the roundings of this bound itself and of P, N and h don't matter. Two
// choices of P and N: the sums themselves (sharp), or, with m_j = |a_j| + |b_j| + |c_j| and L = |a|^2 + |b|^2 + |c|^2,
// the products P = m_x m_y m_z, N_x = L m_y m_z, N_y = m_x L m_z, N_z = m_x m_y L, for fewer operations. The sums are
// taken once the products have left many powers open that the in-sphere filter decides: where cells are long and thin.
// Sums may be associated in any order and contracted: that only drops roundings.
// Points near a reference sphere, of centre o, have sagittas (see >>reference sphere). There g(x) = -sagitta is taken
// for |x|^2, which adds an affine function to it: with g(a) - g(p) in the place of |a|^2 in n,
//     normal = -w, constant = w . s_p - g(p),   and power(x) = g(x) + normal . x + constant is what it was.
// g is wrong by E at most, and G at most in size. n_j is wrong by 12.1u N_j again if N_j has E / 4u added to the size
// of each difference: two of E are less than 12.1u of that. The power's terms add up to 2 G + 2 W, and E counts twice:
// with H = G + E / 16u the same bound holds, which is as small as the noise. A power times det is the in-sphere
// determinant, a multiple of the set's quantum, and det <= 6 * 8 h_x h_y h_z: a power whose size is surely less than
// quantum / (64 h_x h_y h_z) is 0. No ghost's is, for its error exceeds 2 H. A ghost's function is -t N . (x - p) +
// |x|^2 with N = a x b and t = 2^60 H^(1/2) / max |N_j|. N_x is wrong by 3.1u * 2 m_y m_z and by u |N_x|, the terms
// N_j (x - p)_j pass 8 more roundings, |x - p|_j is at most 2 h_j, and the lift adds at most 1.1 H. In all less than
//     2 H + u t (16 sum |N_j| h_j * 2 + 16 Q),   Q = h_x m_y m_z + m_x h_y m_z + m_x m_y h_z, m_j = max(|a_j|, |b_j|).

enum {
    PARADT__MOST_SPHERES = 1 << 16,  // of the table, for very many points, one for 5 of them (8 in slices);
    PARADT__SPHERES = 1 << 14,       // for many, and
    PARADT__LEAST_SPHERES = 1 << 11, // room at least: a block that large keeps common allocators from giving pages back
    PARADT__STAR = 2048,             // new cells that are made together, at most; else the general way is taken
    PARADT__STAR_VERTICES = 1026,    // their vertices: that many facets have at most 2 + 2048 / 2 (Euler)
    PARADT__COMMON_STAR = 60,        // new cells that a point has as a rule at most, with
    PARADT__COMMON_VERTICES = 32,    // so many vertices: their edges take an eighth of the first cache
    PARADT__WIDE_STAR = 256,         // new cells for whose edges there is room to begin with
    PARADT__WIDE_VERTICES = 130,
    PARADT__EDGE_ROW = 32,               // rows of the tables of edges are multiples of this
    PARADT__WIDE_ROWS = 5,               // so many of these
    PARADT__LATE = 16,                   // facets that wait for a sphere to be made again, while others are looked at
    PARADT__DIG_ROOM = PARADT__LATE + 4, // in the lists of the cavity and the rim
    PARADT__DIG_AT_ONCE = 512,           // cells whose facets are looked at between two looks at the room
    PARADT__FIRST_DIG = 512,             // cells and facets of the rim that there is room for to begin with
    PARADT__PLACES_AHEAD = 16,           // cells: then the place of a sphere that is fetched is wanted
    PARADT__AHEAD = 4                    // insertions: then the point that is fetched is wanted
};

#ifdef PARADT_INDEX64
typedef uint64_t paradt__tag;
#else
typedef uint32_t paradt__tag;
#endif

#define PARADT__LAST_NUMBER 0xfffe0000                // that a cavity may begin with: its vertices take less than 2^17
#define PARADT__KNOWN       (~((paradt__tag)-1 >> 1)) // of a tag: the cell is in the cavity
#define PARADT__NO_SPHERE   (PARADT__KNOWN - 1)       // a tag that is no cell's

typedef struct paradt__sphere3 {
    double normal[3], constant;
    double error;
    paradt__tag tag;                                  // the cell, with the two marks
    paradt__tag unused[24 / sizeof(paradt__tag) - 1]; // 64 bytes
} paradt__sphere3;

// A point as the spheres want it
typedef struct paradt__seen3 {
    double s[3], lift;
} paradt__seen3;

// A vertex of the cavity: at first its number among the points, then what leads to it from the new point
typedef union paradt__around3 {
    paradt_index vertex;
    double edge[4]; // by axis, and the square of its length, or how much g is larger there
} paradt__around3;

enum { PARADT__NEXT_NUMBER = sizeof(paradt__around3) }; // from number to number

// What bounds the errors: half of the bounding box' sides, rounded up, H, and with sagittas E / 4u
typedef struct paradt__frame3 {
    double half[3], square, slack;
} paradt__frame3;

// How spheres are made
typedef enum paradt__making3 {
    PARADT__MAKE_QUICKLY,
    PARADT__MAKE_SHARP,  // with sharp bounds on the powers' errors
    PARADT__MAKE_GRADED, // with these, by sagittas
} paradt__making3;

typedef struct paradt__spheres3 {
    paradt__sphere3 *table; // [mask + 1] on cache lines, in the same block behind this
    paradt__tag mask;
    int driven_out;   // a sphere of a cell of the cavity has been, while it is dug: see bw.marks
    double centre[3]; // of the bounding box
    paradt__frame3 frame;
    double square;      // H as it is without sagittas
    double steep;       // 2^60 times its root
    double nil;         // powers of less than this in size are 0
    paradt__seen3 next; // the point to be inserted next
    paradt_index start; // the cell to start from for it: of the last new ones, that in whose sphere it is deepest

    // new cells since the table was judged; spheres wanted that were not in it; powers that told nothing where the
    // in-sphere filter did
    size_t made, missed, vague;
    paradt__making3 making;
    void *large_table; // its block; NULL: it is in the same block, behind this
    paradt_index *large_edges;
    size_t large_star, large_rows; // for so many new cells

    // The vertices around the point have small numbers, that of v is number[v + 1] - first: offsets in bytes in
    // `around`. Numbers go on from point to point, so what is less than `first` is none.
    uint32_t *number;                        // [numbers]
    size_t numbers;                          // points + 1, at least
    uint32_t first, next_number, around_end; // around_end: the offset behind the last vertex
    paradt__around3 around[PARADT__STAR_VERTICES + PARADT__DIG_AT_ONCE + 4]; // see paradt__bw3_limit_numbers

    // For the edge from vertex i to j the handle of the new cells' facet with it: [i * row + j] in one of these, or in
    // large_edges.
    paradt_index common_edges[PARADT__COMMON_VERTICES * PARADT__COMMON_VERTICES];
    paradt_index wide_edges[PARADT__WIDE_VERTICES * PARADT__WIDE_ROWS * PARADT__EDGE_ROW];

    paradt_index waiting[PARADT__LATE]; // facets of the cavity, as handles in its cells, to be looked at later

    // The new cells. Spheres are made four at a time: there is room for three copies of the last one.
    uint16_t corner[PARADT__STAR + 3][4]; // the vertices, as offsets
    paradt_index row[PARADT__STAR][4];    // vertices
    paradt_index outer[PARADT__STAR];
    int ghosts; // there are some among them; those that are none then:
    paradt_index finite_base[PARADT__STAR + 3];
    uint16_t finite_corner[PARADT__STAR + 3][4];
} paradt__spheres3;

#define PARADT__UNIT_ERROR     2.220446049250313e-16
#define PARADT__NO_ERROR_BOUND 3.2733906078961419e150 // 2^500: more than any power in a filtered set
#define PARADT__FLATTEST       2.0370359763344861e90  // 2^300
#define PARADT__GRADE_PAYS     1.4901161193847656e-8  // 2^-26, of H or r^2: sagittas below tell more than |x|^2

// The vertex with a number, as an offset
PARADT__INLINE paradt__around3 *paradt__around3_at(paradt__around3 *around, size_t offset) {
    return (paradt__around3 *)(void *)((char *)around + offset);
}

// The first cache line that begins there
PARADT__INLINE paradt__sphere3 *paradt__on_line(void *memory) {
    return (paradt__sphere3 *)(void *)((char *)memory + (64 - (uintptr_t)memory % 64) % 64);
}

static void paradt__spheres3_free(paradt__spheres3 *s, paradt__memory *memory) {
    if (!s) return;
    paradt__release(memory, s->number);
    paradt__release(memory, s->large_table);
    paradt__release(memory, s->large_edges);
    paradt__release(memory, s);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>insertion
//
// Doors: to be listed.

typedef struct paradt__bw {
    paradt__space space; // its own, for the counters
    paradt__memory *memory;
    const double *records;     // [count][width]
    const paradt_index *order; // [count] of insertion; NULL: that of the records
    size_t width, count;
    int graded; // records have sagittas, of at most grade_limit in size, wrong by grade_error
    double grade_limit, grade_error;
    size_t inserted;      // points so far
    paradt__relay *relay; // NULL: it does not pause
    size_t later;         // points that may come after these, as far as can be foreseen: for the room
    double rate, rate_at; // cells a point when there was last made room, and 1 + the points then; 0: never
    paradt__cells cells;  // cells.count: places in use or free; neighbors are handles of facets
    size_t paged;         // so many cells have pages for their rows already
    unsigned char *marks; // [cells.capacity] PARADT__CONFLICT, and bits of those who go on with the cells; 0 at first
    paradt_index *spare;  // [spare_capacity] places that are free
    size_t spare_count, spare_capacity;
    // [cavity_capacity] cells in conflict with the point: handles of the facets they were entered by. In three
    // dimensions each becomes four times the cell's place once its facets are looked at, and the same of the places
    // that the new cells need besides comes behind them.
    paradt_index *cavity;
    size_t cavity_count, cavity_capacity;
    paradt_index *rim; // [rim_capacity] handles of the cavity's facets on the rim
    size_t rim_count, rim_capacity;
    paradt__slot *ridges; // [ridge_capacity] the first ridge_mask + 1 are a hash table of the new cells' open facets
    size_t ridge_capacity, ridge_mask;
    paradt_index last;         // a cell near the point inserted last
    paradt__spheres3 *spheres; // in three dimensions, where the filter holds
} paradt__bw;

PARADT__INLINE const double *paradt__bw_record(const paradt__bw *bw, paradt_index point) {
    return bw->records + (size_t)point * bw->width;
}

// The i-th point to be inserted
PARADT__INLINE paradt_index paradt__bw_point(const paradt__bw *bw, size_t i) {
    return bw->order ? bw->order[i] : (paradt_index)i;
}

// The cell that a handle's facet belongs to. Divisions by what is not a constant are slow.
PARADT__INLINE paradt_index paradt__bw_cell(const paradt__bw *bw, paradt_index handle) {
    return bw->cells.corners == 4 ? handle >> 2 : handle / bw->cells.corners;
}

static void paradt__bw_end(paradt__bw *bw) {
    paradt__release(bw->memory, bw->marks);
    paradt__release(bw->memory, bw->spare);
    paradt__release(bw->memory, bw->cavity);
    paradt__release(bw->memory, bw->rim);
    paradt__release(bw->memory, bw->ridges);
    paradt__spheres3_free(bw->spheres, bw->memory);
}

// Room for the cells that are needed, and those that are wanted if it can be had
static paradt_status paradt__bw_reserve(paradt__bw *bw, size_t needed, size_t wanted) {
    size_t before = bw->cells.capacity;
    void *array = bw->marks;
    paradt_status status;
    if (needed <= before && wanted <= before) return PARADT_OK;
    status = paradt__cells_reserve(&bw->cells, needed, wanted, bw->memory);
    if (status) return status;
    bw->paged = bw->cells.count;
    if (!paradt__grow(bw->memory, &array, before, bw->cells.capacity, 1)) return PARADT_ERROR_MEMORY;
    bw->marks = (unsigned char *)array;
    paradt__make_pages(bw->marks, before, bw->cells.capacity);
    memset(bw->marks + before, 0, bw->cells.capacity - before);
    return PARADT_OK;
}

// Lends it the places of the cells from `first` on.
static paradt_status paradt__bw_lend(paradt__bw *bw, paradt_index *vertices, paradt_index *neighbors, size_t capacity) {
    bw->marks = (unsigned char *)paradt__alloc(bw->memory, capacity, 1);
    if (!bw->marks) return PARADT_ERROR_MEMORY;
    bw->cells.vertices = vertices;
    bw->cells.neighbors = neighbors;
    bw->cells.capacity = capacity;
    bw->cells.lent = 1;
    return PARADT_OK;
}

// Room for `count` elements in a list of which `used` are in use
static paradt_status paradt__bw_list(paradt__bw *bw, paradt_index **list, size_t used, size_t *capacity, size_t count) {
    void *array = *list;
    size_t larger = *capacity * 2 > count ? *capacity * 2 : count;
    if (PARADT__LIKELY(count <= *capacity)) return PARADT_OK;
    if (!paradt__grow(bw->memory, &array, used, larger, sizeof **list)) return PARADT_ERROR_MEMORY;
    *list = (paradt_index *)array;
    *capacity = larger;
    return PARADT_OK;
}

// Places that the cells of so many points take, ghosts and all, in two and three dimensions: mostly enough
static size_t paradt__bw_places(size_t count, int dim) {
    return (size_t)((double)count * paradt__cells_a_point(dim) * 1.02) + 64;
}

// The number of cells to make room for when `needed` is too much for now: what the cells per point now, and what they
// were when there was last made room, let expect, and somewhat more. Along curves they grow with the points. Few sets
// have more than uniform points; but scanned surfaces do, and lattices that are shaken: 3 to 6 % more a point in the
// end than when they are judged. In the plane no set has more.
static size_t paradt__bw_expected(paradt__bw *bw, size_t needed) {
    int dim = bw->cells.corners - 1;
    size_t points = bw->count + bw->later;
    double inserted = (double)bw->inserted + 1.0, count = (double)points, rate = (double)needed / inserted;
    double judged = count / (double)PARADT__JUDGED_PART; // before, the hull has too large a share
    int known = bw->rate_at > judged && inserted > bw->rate_at;
    double rise = known ? paradt__larger(rate - bw->rate, 0.0) / (inserted - bw->rate_at) : 0.0;
    double more = rise * (count - inserted),
           expected = (rate + (more < rate ? more : rate)) * count * PARADT__EXPECT_MORE;
    double most = dim <= 3 ? (double)paradt__bw_places(points, dim) : 1e15;
    double numbered = (double)paradt__most_cells(bw->cells.corners);
    size_t least = needed + needed / PARADT__GROW_PART + 64;
    bw->rate = rate;
    bw->rate_at = inserted;
    if (expected > most && (double)least < most) expected = dim == 3 ? paradt__larger(most, rate * count * 1.06) : most;
    if (expected > numbered) expected = numbered;
    return inserted > judged && expected > (double)least ? (size_t)expected : least;
}

// The cells of so many points get room at once: of all, and the more that surfaces have; or of few of them, as that is
// copied when there is more.
static size_t paradt__bw_first_points(const paradt__bw *bw) {
    return bw->count < PARADT__FEW_POINTS ? bw->count + bw->count / 32 : bw->count / PARADT__JUDGED_PART * 5 / 4;
}

// Makes pages for some more cells than are needed. Of the last page, which is not made if it lies behind them in part,
// the cells do not count: it is made with the next.
static void paradt__bw_make_pages(paradt__bw *bw, size_t needed) {
    enum { AHEAD = 1 << 17 }; // bytes
    size_t row = (size_t)bw->cells.corners * sizeof(paradt_index), end = needed + AHEAD / row + PARADT__PAGE / row;
    if (end > bw->cells.capacity) end = bw->cells.capacity;
    paradt__make_pages(bw->cells.vertices, bw->paged * row, end * row);
    paradt__make_pages(bw->cells.neighbors, bw->paged * row, end * row);
    bw->paged = end < bw->cells.capacity ? end - PARADT__PAGE / row : end;
}

// Makes sure of `count` free places.
static paradt_status paradt__bw_room(paradt__bw *bw, size_t count) {
    size_t needed = bw->cells.count + count - (bw->spare_count < count ? bw->spare_count : count);
    paradt_status status = PARADT_OK;
    if (PARADT__LIKELY(needed <= bw->paged)) return PARADT_OK;
    if (needed > bw->cells.capacity) status = paradt__bw_reserve(bw, needed, paradt__bw_expected(bw, needed));
    if (!status) paradt__bw_make_pages(bw, needed);
    return status;
}

PARADT__INLINE paradt_index paradt__bw_place(paradt__bw *bw) {
    if (bw->spare_count) return bw->spare[--bw->spare_count];
    return (paradt_index)bw->cells.count++;
}

// How many vertices of a cell or ghost are in [0, end)?
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

// The place of the infinite vertex in the cell, or -1
PARADT__INLINE int paradt__bw_ghost(const paradt_index *cell, int corners) {
    int i;
    for (i = 0; i < corners; i++) {
        if (cell[i] == PARADT__INFINITE) return i;
    }
    return -1;
}

// --- predicates of a cell and a point; the cells are whole

// Sign of the orientation of the cell with the vertex at `place` replaced by x. The other vertices are finite.
static int paradt__bw_side(paradt__bw *bw, paradt_index cell, int place, const double *x) {
    const paradt_index *vertices = bw->cells.vertices + (size_t)cell * (size_t)bw->cells.corners;
    const double *p[PARADT_MAX_DIM + 1];
    int i;
    for (i = 0; i < bw->cells.corners; i++) p[i] = i == place ? x : paradt__bw_record(bw, vertices[i]);
    return paradt__orient(&bw->space, p);
}

static int paradt__bw_conflicts(paradt__bw *bw, paradt_index cell, const double *x) {
    int corners = bw->cells.corners, ghost, i, side;
    const paradt_index *vertices = bw->cells.vertices + (size_t)cell * (size_t)corners;
    const double *p[PARADT_MAX_DIM + 2];
    ghost = paradt__bw_ghost(vertices, corners);
    if (ghost >= 0) {
        side = paradt__bw_side(bw, cell, ghost, x);
        if (side) return side > 0;
        cell = paradt__bw_cell(bw, bw->cells.neighbors[(size_t)cell * (size_t)corners + (size_t)ghost]);
        vertices = bw->cells.vertices + (size_t)cell * (size_t)corners;
    }
    for (i = 0; i < corners; i++) p[i] = paradt__bw_record(bw, vertices[i]);
    p[corners] = x;
    return paradt__conflict(&bw->space, p);
}

// The cell that contains x, or a ghost whose hull facet has x strictly beyond it. A visibility walk: in a regular
// triangulation it ends whichever facet it takes (Edelsbrunner, "An acyclicity theorem for cell complexes in d
// dimensions", Combinatorica 10, 1990).
static paradt_index paradt__bw_walk(paradt__bw *bw, paradt_index cell, const double *x) {
    int corners = bw->cells.corners, i, from = -1;
    for (;;) {
        size_t base = (size_t)cell * (size_t)corners;
        int ghost = paradt__bw_ghost(bw->cells.vertices + base, corners);
        if (ghost >= 0) {
            if (paradt__bw_side(bw, cell, ghost, x) > 0) return cell;
            i = ghost;
        } else {
            for (i = 0; i < corners; i++) {
                if (i != from && paradt__bw_side(bw, cell, i, x) < 0) break;
            }
            if (i == corners) return cell;
        }
        from = (int)(bw->cells.neighbors[base + (size_t)i] % corners);
        cell = paradt__bw_cell(bw, bw->cells.neighbors[base + (size_t)i]);
    }
}

// --- insertion in any dimension

// Fills the cavity and its rim from the first cell in conflict with x.
static paradt_status paradt__bw_dig(paradt__bw *bw, paradt_index first, const double *x) {
    int corners = bw->cells.corners, i;
    size_t head;
    bw->cavity_count = bw->rim_count = 0;
    bw->cavity[bw->cavity_count++] = first * corners;
    bw->marks[first] |= PARADT__CONFLICT;
    for (head = 0; head < bw->cavity_count; head++) {
        paradt_index base = bw->cavity[head] - bw->cavity[head] % corners;
        paradt_status status = paradt__bw_list(bw, &bw->cavity, bw->cavity_count, &bw->cavity_capacity,
                                               bw->cavity_count + (size_t)corners);
        if (!status)
            status = paradt__bw_list(bw, &bw->rim, bw->rim_count, &bw->rim_capacity, bw->rim_count + (size_t)corners);
        if (status) return status;
        for (i = 0; i < corners; i++) {
            paradt_index other = paradt__bw_cell(bw, bw->cells.neighbors[base + i]);
            if (bw->marks[other] & PARADT__CONFLICT) continue;
            if (paradt__bw_conflicts(bw, other, x)) {
                bw->marks[other] |= PARADT__CONFLICT;
                bw->cavity[bw->cavity_count++] = bw->cells.neighbors[base + i];
            } else {
                bw->rim[bw->rim_count++] = base + i;
            }
        }
    }
    return PARADT_OK;
}

// Links an open facet of a new cell to its twin, or leaves it in the table for that. Every ridge of the rim is in two
// facets, so each entry is met once and needs no removal.
static void paradt__bw_link(paradt__bw *bw, uint32_t key, paradt_index handle) {
    size_t mask = bw->ridge_mask, slot = key & mask;
    for (; bw->ridges[slot].handle >= 0; slot = (slot + 1) & mask) {
        paradt_index twin = bw->ridges[slot].handle;
        if (bw->ridges[slot].key != key || !paradt__same_facet(&bw->cells, twin, handle, bw->cells.corners)) continue;
        bw->cells.neighbors[twin] = handle;
        bw->cells.neighbors[handle] = twin;
        return;
    }
    bw->ridges[slot].key = key;
    bw->ridges[slot].handle = handle;
}

// A table for the rim's ridges, empty. At most half full: each of the ridges is in two of the facets. It is no larger
// than that, for to clear the largest that was ever needed could take longer than all the rest.
static paradt_status paradt__bw_ridges(paradt__bw *bw) {
    size_t needed = 16, i;
    while (needed < bw->rim_count * (size_t)bw->cells.corners) needed *= 2;
    if (needed > bw->ridge_capacity) {
        paradt__release(bw->memory, bw->ridges);
        bw->ridges = (paradt__slot *)paradt__alloc(bw->memory, needed, sizeof *bw->ridges);
        bw->ridge_capacity = bw->ridges ? needed : 0;
        if (!bw->ridges) return PARADT_ERROR_MEMORY;
    }
    bw->ridge_mask = needed - 1;
    for (i = 0; i < needed; i++) bw->ridges[i].handle = PARADT__OPEN;
    return PARADT_OK;
}

// Makes the new cells: those of the cavity with the point in the place of the vertex off the rim. The rim is theirs
// then.
static paradt_status paradt__bw_fill(paradt__bw *bw, paradt_index point) {
    int corners = bw->cells.corners, j;
    size_t i;
    paradt_status status = paradt__bw_room(bw, bw->rim_count);
    if (!status) status = paradt__bw_ridges(bw);
    if (status) return status;
    for (i = 0; i < bw->rim_count; i++) {
        paradt_index inner = bw->rim[i], outer = bw->cells.neighbors[inner], made = paradt__bw_place(bw);
        int place = (int)(inner % corners);
        paradt_index *vertices = bw->cells.vertices + (size_t)made * (size_t)corners;
        uint64_t sum;
        memcpy(vertices, bw->cells.vertices + (inner - place), (size_t)corners * sizeof *vertices);
        vertices[place] = point;
        sum = paradt__cell_sum(vertices, corners);
        bw->cells.neighbors[made * corners + place] = outer;
        bw->cells.neighbors[outer] = made * corners + place;
        for (j = 0; j < corners; j++) {
            if (j != place)
                paradt__bw_link(bw, paradt__facet_key(sum - paradt__vertex_key(vertices[j])), made * corners + j);
        }
        bw->rim[i] = made * corners + place;
        bw->last = made;
    }
    return PARADT_OK;
}

// The places of the cavity become free.
static paradt_status paradt__bw_clear(paradt__bw *bw) {
    size_t i;
    paradt_status status =
        paradt__bw_list(bw, &bw->spare, bw->spare_count, &bw->spare_capacity, bw->spare_count + bw->cavity_count);
    if (status) return status;
    for (i = 0; i < bw->cavity_count; i++) {
        paradt_index cell = paradt__bw_cell(bw, bw->cavity[i]);
        bw->marks[cell] = 0;
        bw->spare[bw->spare_count + i] = cell;
    }
    bw->spare_count += bw->cavity_count;
    return PARADT_OK;
}

static paradt_status paradt__bw_insert(paradt__bw *bw, paradt_index point) {
    const double *x = paradt__bw_record(bw, point);
    paradt_index cell = paradt__bw_walk(bw, bw->last, x);
    paradt_status status;
    bw->last = cell;
    if (bw->space.weighted && !paradt__bw_conflicts(bw, cell, x)) return PARADT_OK;
    status = paradt__bw_dig(bw, cell, x);
    if (!status) status = paradt__bw_fill(bw, point);
    if (!status) status = paradt__bw_clear(bw);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>insertion in space
//
// Doors: to be listed.

PARADT__INLINE paradt__seen3 paradt__seen3_of(const paradt__spheres3 *s, const double *x) {
    paradt__seen3 seen;
    seen.s[0] = x[0] - s->centre[0];
    seen.s[1] = x[1] - s->centre[1];
    seen.s[2] = x[2] - s->centre[2];
    seen.lift = seen.s[0] * seen.s[0] + seen.s[1] * seen.s[1] + seen.s[2] * seen.s[2];
    if (!PARADT__LIKELY(s->making != PARADT__MAKE_GRADED)) seen.lift = -x[3];
    return seen;
}

// The edge from a point to another
PARADT__INLINE paradt__around3 paradt__around3_of(paradt__making3 making, const double *from, const double *to) {
    paradt__around3 around;
    double x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
    around.edge[0] = x;
    around.edge[1] = y;
    around.edge[2] = z;
    around.edge[3] = making == PARADT__MAKE_GRADED ? from[3] - to[3] : x * x + y * y + z * z;
    return around;
}

PARADT__INLINE double paradt__largest3(double a, double b, double c) {
    return paradt__larger(paradt__larger(paradt__abs(a), paradt__abs(b)), paradt__abs(c));
}

// The size of the terms of a 2 x 2 determinant
PARADT__INLINE double paradt__minor_size(double a, double b, double c, double d) {
    return paradt__abs(a * d) + paradt__abs(b * c);
}

// The sphere through p and p + a, p + b, p + c, positively oriented; a[3] is |a|^2, or g(p + a) - g(p). Straight code,
// to be vectorised: where the determinant is too small it is replaced, and the bound on the error leaves all in doubt.
// (By a choice: with x87 registers the difference of the two need not be 0 where they are the same, as one may have
// been rounded.)
PARADT__INLINE void paradt__sphere3_make(paradt__making3 making, const paradt__frame3 *f, const paradt__seen3 *p,
                                         const double *a, const double *b, const double *c, double *normal,
                                         double *constant, double *error) {
    const int graded = making == PARADT__MAKE_GRADED;
    double ax = a[0], ay = a[1], az = a[2], la = a[3], bx = b[0], by = b[1], bz = b[2], lb = b[3];
    double cx = c[0], cy = c[1], cz = c[2], lc = c[3];
    double bcx = by * cz - bz * cy, bcy = bz * cx - bx * cz, bcz = bx * cy - by * cx;
    double cax = cy * az - cz * ay, cay = cz * ax - cx * az, caz = cx * ay - cy * ax;
    double abx = ay * bz - az * by, aby = az * bx - ax * bz, abz = ax * by - ay * bx;
    double det = ax * bcx + ay * bcy + az * bcz, size, sides; // P, sum N_j h_j
    double floor, safe, inverse, wx, wy, wz, reach;
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

// The order of the vertices of a cell without vertex i that, followed by what comes in its place, keeps the orientation
static const unsigned char paradt__facet3[4][3] = {{1, 3, 2}, {0, 2, 3}, {1, 0, 3}, {0, 1, 2}};

// The sphere of the ghost on a facet. seen: p
PARADT__INLINE void paradt__sphere3_of_facet(const paradt__spheres3 *s, paradt__sphere3 *sphere,
                                             const paradt__seen3 *seen, const double *p, const double *q,
                                             const double *r) {
    const double *h = s->frame.half;
    double ax = q[0] - p[0], ay = q[1] - p[1], az = q[2] - p[2], bx = r[0] - p[0], by = r[1] - p[1], bz = r[2] - p[2];
    double nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx, size = paradt__largest3(nx, ny, nz);
    double mx = paradt__largest3(ax, bx, 0.0), my = paradt__largest3(ay, by, 0.0), mz = paradt__largest3(az, bz, 0.0),
           t;
    double sides = h[0] * my * mz + mx * h[1] * mz + mx * my * h[2];
    if (!(s->steep < PARADT__FLATTEST * size)) {
        sphere->normal[0] = sphere->normal[1] = sphere->normal[2] = sphere->constant = 0.0;
        sphere->error = PARADT__NO_ERROR_BOUND;
        return;
    }
    t = s->steep / size;
    sphere->normal[0] = -t * nx;
    sphere->normal[1] = -t * ny;
    sphere->normal[2] = -t * nz;
    sphere->constant = t * (nx * seen->s[0] + ny * seen->s[1] + nz * seen->s[2]);
    sphere->error = 2.0 * s->square +
                    PARADT__UNIT_ERROR * t * 16.0 *
                        (2.0 * (paradt__abs(nx) * h[0] + paradt__abs(ny) * h[1] + paradt__abs(nz) * h[2]) + sides);
}

static void paradt__sphere3_of_ghost(const paradt__bw *bw, paradt__sphere3 *sphere, const paradt_index *vertices,
                                     int place) {
    const unsigned char *order = paradt__facet3[place];
    const double *p = paradt__bw_record(bw, vertices[order[0]]), *q = paradt__bw_record(bw, vertices[order[1]]);
    paradt__seen3 seen = paradt__seen3_of(bw->spheres, p);
    paradt__sphere3_of_facet(bw->spheres, sphere, &seen, p, q, paradt__bw_record(bw, vertices[order[2]]));
}

// Makes the sphere of a cell and puts it into the table.
PARADT__NOINLINE void paradt__bw3_sphere(const paradt__bw *bw, paradt_index cell) {
    paradt__spheres3 *s = bw->spheres;
    paradt__sphere3 *sphere = s->table + ((paradt__tag)cell & s->mask);
    const paradt_index *vertices = bw->cells.vertices + 4 * (size_t)cell;
    int ghost = paradt__bw_ghost(vertices, 4);
    if (ghost >= 0) {
        paradt__sphere3_of_ghost(bw, sphere, vertices, ghost);
    } else {
        const double *a = paradt__bw_record(bw, vertices[0]), *b = paradt__bw_record(bw, vertices[1]);
        const double *c = paradt__bw_record(bw, vertices[2]), *p = paradt__bw_record(bw, vertices[3]);
        paradt__around3 to_a = paradt__around3_of(s->making, p, a), to_b = paradt__around3_of(s->making, p, b),
                        to_c = paradt__around3_of(s->making, p, c);
        paradt__seen3 seen = paradt__seen3_of(s, p);
        // (a, b, c, p) is positive when det(a - p, b - p, c - p) is negative
        paradt__sphere3_make(s->making, &s->frame, &seen, to_b.edge, to_a.edge, to_c.edge, sphere->normal,
                             &sphere->constant, &sphere->error);
    }
    sphere->tag = (paradt__tag)cell;
}

// A sphere that is not in the table gets its place in it. The mark of the one that is driven out, if the cavity is
// being dug, is kept in bw.marks.
PARADT__INLINE paradt__sphere3 *paradt__bw3_drive_out(const paradt__bw *bw, paradt_index cell) {
    paradt__spheres3 *s = bw->spheres;
    paradt__sphere3 *sphere = s->table + ((paradt__tag)cell & s->mask);
    if (sphere->tag & PARADT__KNOWN) {
        bw->marks[sphere->tag & ~PARADT__KNOWN] |= PARADT__CONFLICT;
        s->driven_out = 1;
    }
    s->missed++;
    return sphere;
}

// Makes a sphere that is not in the table.
PARADT__NOINLINE void paradt__bw3_missed(const paradt__bw *bw, paradt_index cell) {
    paradt__sphere3 *sphere = paradt__bw3_drive_out(bw, cell);
    paradt__bw3_sphere(bw, cell);
    if (bw->marks[cell] & PARADT__CONFLICT) sphere->tag |= PARADT__KNOWN;
}

PARADT__INLINE const paradt__sphere3 *paradt__bw3_sphere_of(const paradt__bw *bw, paradt_index cell) {
    const paradt__sphere3 *sphere = bw->spheres->table + ((paradt__tag)cell & bw->spheres->mask);
    if (!PARADT__LIKELY((sphere->tag & ~PARADT__KNOWN) == (paradt__tag)cell)) paradt__bw3_missed(bw, cell);
    return sphere;
}

PARADT__INLINE double paradt__sphere3_power(const paradt__sphere3 *sphere, const paradt__seen3 *x) {
    return (x->lift + sphere->constant) +
           (sphere->normal[0] * x->s[0] + sphere->normal[1] * x->s[1] + sphere->normal[2] * x->s[2]);
}

// A cell in conflict with the point: down the powers, from neighbour to neighbour. The powers of a point with regard to
// two neighbours differ by an affine function that vanishes on their common facet, so this is a walk towards the point;
// it may end at the first cell in conflict. Where powers are too inexact for that, the walk by orientations goes on.
// Powers are compared as rounded: of two neighbours with equal ones each could be less than the other else, if one is
// in a longer register and the other is not, and the walk would not end.
PARADT__INLINE paradt_index paradt__bw3_locate(paradt__bw *bw, const paradt__seen3 *seen, const double *x) {
    paradt_index cell = bw->spheres->start;
    const paradt__sphere3 *sphere = paradt__bw3_sphere_of(bw, cell);
    double power = paradt__rounded(paradt__sphere3_power(sphere, seen)), error = sphere->error;
    while (power >= -error) {
        const paradt_index *neighbors = bw->cells.neighbors + 4 * (size_t)cell;
        double least = power;
        paradt_index best = cell;
        int i;
        for (i = 0; i < 4; i++) {
            paradt_index other = neighbors[i] >> 2;
            double value;
            sphere = paradt__bw3_sphere_of(bw, other);
            value = paradt__rounded(paradt__sphere3_power(sphere, seen));
            best = value < least ? other : best;
            error = value < least ? sphere->error : error;
            least = value < least ? value : least;
        }
        if (best == cell) return paradt__bw_walk(bw, cell, x);
        cell = best;
        power = least;
    }
    return cell;
}

PARADT__INLINE void paradt__bw3_corners(const paradt__bw *bw, paradt_index cell, const double *x, const double **p) {
    int i;
    for (i = 0; i < 4; i++) p[i] = paradt__bw_record(bw, bw->cells.vertices[4 * (size_t)cell + (size_t)i]);
    p[4] = x;
}

// Is the cell in conflict with the point? For a point on the sphere of a cell that is no ghost
PARADT__INLINE unsigned paradt__bw3_tie(paradt__bw *bw, paradt_index cell, const double *x) {
    const double *p[PARADT_MAX_DIM + 2];
    paradt__bw3_corners(bw, cell, x, p);
    bw->space.counters.insphere_calls++;
    bw->space.counters.exact_small++;
    return (unsigned)paradt__perturbed(&bw->space, p);
}

// Is the cell in conflict with the point? Where nothing is known.
PARADT__NOINLINE unsigned paradt__bw3_decide(paradt__bw *bw, paradt_index cell, const double *x) {
    const double *p[PARADT_MAX_DIM + 2];
    int sign;
    if (!paradt__vertices_among(bw->cells.vertices + 4 * (size_t)cell, 4, 0, PARADT__NOWHERE))
        return (unsigned)paradt__bw_conflicts(bw, cell, x);
    paradt__bw3_corners(bw, cell, x, p);
    bw->space.counters.insphere_calls++;
    sign = paradt__filter_insphere3(&bw->space, p, 3, 0);
    if (sign == PARADT__UNDECIDED) sign = paradt__exact_insphere3(&bw->space, p);
    else bw->spheres->vague++;
    return (unsigned)(sign ? sign > 0 : paradt__perturbed(&bw->space, p));
}

// Is the cell in conflict with the point? Where its sphere may not be in the table, or the power does not tell.
PARADT__NOINLINE unsigned paradt__bw3_settle(paradt__bw *bw, paradt_index cell, const paradt__seen3 *seen,
                                             const double *x) {
    const paradt__spheres3 *s = bw->spheres;
    const paradt__sphere3 *sphere = paradt__bw3_sphere_of(bw, cell);
    double power;
    if (sphere->tag & PARADT__KNOWN) return 1;
    power = paradt__sphere3_power(sphere, seen);
    if (paradt__abs(power) > sphere->error) return power < 0.0;
    if (paradt__abs(power) + sphere->error < s->nil) return paradt__bw3_tie(bw, cell, x);
    return paradt__bw3_decide(bw, cell, x);
}

// What the search for the cavity works with
typedef struct paradt__dig3 {
    paradt_index *cavity, *rim;
    size_t cavity_count, rim_count;
    const paradt_index *neighbors;
    paradt__sphere3 *table;
    paradt__tag mask;
    int waiting_count;
    const paradt_index *vertices;
    paradt__around3 *around;
    uint32_t *numbers, first, next; // of the vertices: as in paradt__spheres3, from vertex 0 on
} paradt__dig3;

// Begins with the numbers of another cavity's vertices. Where they come near their end they begin again.
PARADT__INLINE void paradt__bw3_begin_numbers(const paradt__bw *bw, paradt__dig3 *dig) {
    paradt__spheres3 *s = bw->spheres;
    dig->vertices = bw->cells.vertices;
    dig->around = s->around;
    if (!PARADT__LIKELY(s->next_number <= PARADT__LAST_NUMBER)) {
        memset(s->number, 0, s->numbers * sizeof *s->number);
        s->next_number = PARADT__NEXT_NUMBER;
    }
    dig->numbers = s->number + 1;
    dig->first = dig->next = s->next_number;
}

// Numbers a vertex of the cavity, if it has no number yet. There is no branch, as nothing foretells it.
PARADT__INLINE void paradt__bw3_number(paradt__dig3 *dig, paradt_index vertex) {
    uint32_t number = dig->numbers[vertex], is_new = 0 - (uint32_t)(number < dig->first);
    paradt__around3_at(dig->around, dig->next - dig->first)->vertex = vertex;
    dig->numbers[vertex] = number + ((dig->next - number) & is_new);
    dig->next += is_new & PARADT__NEXT_NUMBER;
}

// Numbers of more vertices than a star may have are not used, so they needn't differ: from there on they are given
// again. To be called every PARADT__DIG_AT_ONCE vertices.
PARADT__INLINE void paradt__bw3_limit_numbers(paradt__dig3 *dig) {
    uint32_t most = (uint32_t)PARADT__STAR_VERTICES * PARADT__NEXT_NUMBER;
    if (dig->next - dig->first > most) dig->next = dig->first + most;
}

// Keeps which numbers these vertices have. The next cavity's are larger than all of them.
PARADT__INLINE void paradt__bw3_end_numbers(paradt__spheres3 *s, const paradt__dig3 *dig) {
    uint32_t most = (uint32_t)PARADT__STAR_VERTICES * PARADT__NEXT_NUMBER, end = dig->next - dig->first;
    s->first = dig->first;
    s->around_end = end < most ? end : most;
    s->next_number = end < most ? dig->next : dig->first + (uint32_t)sizeof s->around;
    s->ghosts = dig->numbers[PARADT__INFINITE] >= dig->first;
    // what comes of it is not used, but any point will do where its record is read
    if (s->ghosts) paradt__around3_at(s->around, dig->numbers[PARADT__INFINITE] - dig->first)->vertex = 0;
}

// What is across a facet of the cavity becomes part of the cavity or the rim, without branches.
PARADT__INLINE void paradt__bw3_judge(paradt__dig3 *dig, paradt_index inner, paradt__sphere3 *sphere,
                                      unsigned conflict) {
    unsigned fresh = conflict & !(sphere->tag & PARADT__KNOWN);
    sphere->tag |= conflict ? PARADT__KNOWN : 0;
    dig->cavity[dig->cavity_count] = dig->neighbors[inner];
    dig->cavity_count += fresh;
    dig->rim[dig->rim_count] = inner;
    dig->rim_count += conflict ^ 1;
}

// Looks later at a facet, across which the sphere is not in the table, and fetches the vertices that it is made of.
// count: of facets that wait already. Returns how many wait then.
PARADT__NOINLINE int paradt__bw3_wait(const paradt__bw *bw, paradt_index inner, paradt_index other, int count) {
    PARADT__PREFETCH(bw->cells.vertices + 4 * (size_t)other);
    bw->spheres->waiting[count] = inner;
    return count + 1;
}

// Looks at the other side of a facet of the cavity.
PARADT__INLINE void paradt__bw3_look(paradt__bw *bw, paradt__dig3 *dig, const paradt__seen3 *seen, const double *x,
                                     paradt_index inner) {
    paradt_index handle = dig->neighbors[inner];
    paradt__tag other = (paradt__tag)handle >> 2;
    paradt__sphere3 *sphere = dig->table + (other & dig->mask);
    double power = paradt__sphere3_power(sphere, seen);
    unsigned conflict = power < 0.0;
    PARADT__PREFETCH(dig->neighbors + 4 * (size_t)other);
    if (!PARADT__LIKELY(((sphere->tag & ~PARADT__KNOWN) == other) & (paradt__abs(power) > sphere->error))) {
        if ((sphere->tag & ~PARADT__KNOWN) != other && dig->waiting_count < PARADT__LATE) {
            dig->waiting_count = paradt__bw3_wait(bw, inner, (paradt_index)other, dig->waiting_count);
            return;
        }
        conflict = paradt__bw3_settle(bw, (paradt_index)other, seen, x);
    }
    paradt__bw3_judge(dig, inner, sphere, conflict);
}

// Makes the spheres across facets that wait, where they are not in the table. Not all need be there then: of two cells
// with the same place one drives out the other.
typedef void (*paradt__remake3)(const paradt__bw *bw, const paradt_index *waiting, int count);

static void paradt__bw3_remake_plain(const paradt__bw *bw, const paradt_index *waiting, int count) {
    int i;
    for (i = 0; i < count; i++) paradt__bw3_sphere_of(bw, bw->cells.neighbors[waiting[i]] >> 2);
}

// Looks at the facets that wait. Of the vertices across one, that opposite it is the least likely to be in the caches.
PARADT__NOINLINE void paradt__bw3_look_late(paradt__bw *bw, paradt__dig3 *dig, const paradt__seen3 *seen,
                                            const double *x, paradt__remake3 remake) {
    const paradt_index *waiting = bw->spheres->waiting;
    int i, count = dig->waiting_count;
    for (i = 0; i < count; i++) {
        paradt_index opposite = bw->cells.vertices[dig->neighbors[waiting[i]]];
        PARADT__PREFETCH(paradt__bw_record(bw, opposite >= 0 ? opposite : 0));
    }
    remake(bw, waiting, count);
    for (i = 0; i < count; i++) {
        paradt__tag other = (paradt__tag)dig->neighbors[waiting[i]] >> 2;
        paradt__bw3_judge(dig, waiting[i], dig->table + (other & dig->mask),
                          paradt__bw3_settle(bw, (paradt_index)other, seen, x));
    }
    dig->waiting_count = 0;
}

// Looks through the facets of the cavity's cells from number `head` on, while the lists have room for four more and for
// those that wait, and numbers the vertices. A cell has those of the cell that it was entered from, and that opposite
// the facet between them.
PARADT__INLINE size_t paradt__bw3_spread(paradt__bw *bw, paradt__dig3 *work, const paradt__seen3 *at, const double *x,
                                         size_t head) {
    size_t cells = bw->cavity_capacity - PARADT__DIG_ROOM, facets = bw->rim_capacity - PARADT__DIG_ROOM;
    paradt__dig3 dig = *work;
    paradt__seen3 seen = *at;
    size_t last = head + PARADT__DIG_AT_ONCE;
    if (!head) paradt__bw3_look(bw, &dig, &seen, x, dig.cavity[0]); // the first cell was not entered by that facet
    for (; head < last && head < dig.cavity_count && dig.cavity_count <= cells && dig.rim_count <= facets; head++) {
        paradt_index entry = dig.cavity[head], base = entry & ~(paradt_index)3;
        dig.cavity[head] = base;
        paradt__bw3_number(&dig, dig.vertices[entry]);
        paradt__bw3_look(bw, &dig, &seen, x, base | ((entry + 1) & 3));
        paradt__bw3_look(bw, &dig, &seen, x, base | ((entry + 2) & 3));
        paradt__bw3_look(bw, &dig, &seen, x, base | ((entry + 3) & 3));
    }
    *work = dig;
    return head;
}

// New cells that are no ghosts, with room for three more: 4 times their places, the numbers of their vertices
typedef struct paradt__star3 {
    paradt_index *base;
    uint16_t (*corner)[4];
    int count;
} paradt__star3;

// The inner functions that have versions for an instruction set
typedef size_t (*paradt__spread3)(paradt__bw *bw, paradt__dig3 *work, const paradt__seen3 *at, const double *x,
                                  size_t head);
typedef void (*paradt__make_spheres3)(const paradt__bw *bw, paradt__star3 *star, const double *x,
                                      const paradt__seen3 *seen);

PARADT__INLINE paradt_status paradt__bw3_dig(paradt__bw *bw, paradt_index first, const paradt__seen3 *seen,
                                             const double *x, paradt__spread3 spread, paradt__remake3 remake) {
    size_t head = 0, i;
    paradt__dig3 dig;
    dig.cavity = bw->cavity;
    dig.rim = bw->rim;
    dig.neighbors = bw->cells.neighbors;
    dig.table = bw->spheres->table;
    dig.mask = bw->spheres->mask;
    dig.cavity[0] = 4 * first;
    dig.cavity_count = 1;
    dig.rim_count = 0;
    dig.waiting_count = 0;
    paradt__bw3_sphere_of(bw, first);
    dig.table[(paradt__tag)first & dig.mask].tag |= PARADT__KNOWN;
    paradt__bw3_begin_numbers(bw, &dig);
    for (i = 1; i < 4; i++) paradt__bw3_number(&dig, dig.vertices[4 * (size_t)first + i]);
    for (;;) {
        paradt_status status;
        head = spread(bw, &dig, seen, x, head);
        paradt__bw3_limit_numbers(&dig);
        if (head == dig.cavity_count && !dig.waiting_count) break;
        if (dig.waiting_count) paradt__bw3_look_late(bw, &dig, seen, x, remake);
        status = paradt__bw_list(bw, &bw->cavity, dig.cavity_count, &bw->cavity_capacity,
                                 dig.cavity_count + PARADT__DIG_ROOM);
        if (!status)
            status = paradt__bw_list(bw, &bw->rim, dig.rim_count, &bw->rim_capacity, dig.rim_count + PARADT__DIG_ROOM);
        if (status) return status;
        dig.cavity = bw->cavity;
        dig.rim = bw->rim;
    }
    bw->cavity_count = dig.cavity_count;
    bw->rim_count = dig.rim_count;
    paradt__bw3_end_numbers(bw->spheres, &dig);
    return PARADT_OK;
}

// Where cells are long and points have hundreds of them in common: sharp bounds if many powers tell nothing without,
// and a table of four times the size if many spheres have had to be made again, and so many more would be for the cells
// to come that it has no more places. It takes at most half of the memory that the cells take; where that can't be had
// the table stays as it is.
PARADT__NOINLINE void paradt__bw3_adapt(paradt__bw *bw) {
    paradt__spheres3 *s = bw->spheres;
    size_t size = 4 * ((size_t)s->mask + 1), i;
    void *larger = NULL;
    double to_come = 28.0 * (double)(bw->count - bw->inserted); // cells, at least
    int often = s->missed > s->made / 4 && (double)s->missed * to_come > (double)s->made * (double)size;
    if (s->vague > s->made / 16 && s->making == PARADT__MAKE_QUICKLY) s->making = PARADT__MAKE_SHARP;
    s->made = s->missed = s->vague = 0;
    if (often && size * sizeof *s->table <= bw->cells.count * 4 * sizeof(paradt_index))
        larger = paradt__alloc(bw->memory, size + 1, sizeof *s->table);
    if (!larger) return;
    paradt__release(bw->memory, s->large_table);
    s->large_table = larger;
    s->table = paradt__on_line(larger);
    s->mask = (paradt__tag)(size - 1);
    for (i = 0; i < size; i++) s->table[i].tag = PARADT__NO_SPHERE;
}

// Room for the edges of the cavity's rim, if it can be had and takes at most half of the memory that the cells take,
// and the largest, which few stars need, at most an eighth.
PARADT__NOINLINE void paradt__bw3_widen_star(paradt__bw *bw) {
    paradt__spheres3 *s = bw->spheres;
    size_t star = PARADT__WIDE_STAR, vertices, rows;
    if (bw->rim_count <= PARADT__WIDE_STAR || bw->rim_count <= s->large_star || bw->rim_count > PARADT__STAR) return;
    while (star < bw->rim_count) star *= 2;
    vertices = 2 + star / 2;
    rows = (vertices + PARADT__EDGE_ROW - 1) / PARADT__EDGE_ROW | 1; // odd: so they don't compete for the same lines
    if (vertices * rows * PARADT__EDGE_ROW > bw->cells.count * (star < PARADT__STAR ? 4 : 1)) return;
    paradt__release(bw->memory, s->large_edges);
    s->large_star = 0;
    s->large_edges =
        (paradt_index *)paradt__alloc(bw->memory, vertices * rows * PARADT__EDGE_ROW, sizeof *s->large_edges);
    if (!s->large_edges) return;
    s->large_star = star;
    s->large_rows = rows;
}

// The vertices of a new cell: those of a cell but for one, and the point.
typedef void (*paradt__turn3)(paradt_index *row, const paradt_index *cell, int without, paradt_index point);

static void paradt__turn3_plain(paradt_index *row, const paradt_index *cell, int without, paradt_index point) {
    const unsigned char *order = paradt__facet3[without];
    paradt_index a = cell[order[0]], b = cell[order[1]], c = cell[order[2]];
    row[0] = a;
    row[1] = b;
    row[2] = c;
    row[3] = point;
}

// The place of the edge from one vertex to another, by their offsets, in a table of edges
PARADT__INLINE size_t paradt__edge3(size_t from, size_t to, size_t rows) {
    return from * (PARADT__EDGE_ROW * rows / sizeof(paradt__around3)) + to / sizeof(paradt__around3);
}

// The rows of the new cells, and what is across the rim
PARADT__INLINE void paradt__bw3_rows(paradt__bw *bw, paradt_index point, paradt__turn3 turn) {
    paradt__spheres3 *s = bw->spheres;
    const paradt_index *vertices = bw->cells.vertices, *neighbors = bw->cells.neighbors, *rim = bw->rim;
    size_t i, count = bw->rim_count;
    for (i = 0; i < count; i++) {
        paradt__tag inner = (paradt__tag)rim[i];
        turn(s->row[i], vertices + (inner & ~(paradt__tag)3), (int)(inner & 3), point);
        s->outer[i] = neighbors[inner];
    }
}

// Enters the rim's edges.
PARADT__INLINE void paradt__bw3_outline(paradt__bw *bw, paradt_index *edges, size_t rows) {
    paradt__spheres3 *s = bw->spheres;
    const uint32_t *numbers = s->number + 1, first = s->first;
    size_t i, count = bw->rim_count;
    for (i = 0; i < count; i++) {
        const paradt_index *row = s->row[i];
        size_t a = numbers[row[0]] - first, b = numbers[row[1]] - first, c = numbers[row[2]] - first;
        paradt_index edge = bw->cavity[i];
        uint16_t *corner = s->corner[i];
        corner[0] = (uint16_t)a;
        corner[1] = (uint16_t)b;
        corner[2] = (uint16_t)c;
        edges[paradt__edge3(b, c, rows)] = edge;
        edges[paradt__edge3(c, a, rows)] = edge + 1;
        edges[paradt__edge3(a, b, rows)] = edge + 2;
    }
}

// The links of a new cell
typedef void (*paradt__put3)(paradt_index *links, paradt_index a, paradt_index b, paradt_index c, paradt_index d);

static void paradt__put3_plain(paradt_index *links, paradt_index a, paradt_index b, paradt_index c, paradt_index d) {
    links[0] = a;
    links[1] = b;
    links[2] = c;
    links[3] = d;
}

// Makes the new cells in the places of the cavity, and in fresh ones, and links them.
PARADT__INLINE void paradt__bw3_star(paradt__bw *bw, const paradt_index *edges, size_t rows, paradt__put3 put) {
    const paradt__spheres3 *s = bw->spheres;
    paradt_index *vertices = bw->cells.vertices, *neighbors = bw->cells.neighbors;
    size_t i, count = bw->rim_count;
    for (i = 0; i < count; i++) {
        paradt__tag base = (paradt__tag)bw->cavity[i], outer = (paradt__tag)s->outer[i];
        size_t a = s->corner[i][0], b = s->corner[i][1], c = s->corner[i][2];
        memcpy(vertices + base, s->row[i], sizeof s->row[i]);
        put(neighbors + base, edges[paradt__edge3(c, b, rows)], edges[paradt__edge3(a, c, rows)],
            edges[paradt__edge3(b, a, rows)], (paradt_index)outer);
        neighbors[outer] = (paradt_index)(base + 3);
    }
}

// The new cells and their links by a table of edges with so many times PARADT__EDGE_ROW places a row. Inlined with a
// constant it is faster.
PARADT__INLINE void paradt__bw3_link(paradt__bw *bw, paradt_index *edges, size_t rows, paradt__put3 put) {
    paradt__bw3_outline(bw, edges, rows);
    paradt__bw3_star(bw, edges, rows, put);
}

// The same for more new cells than a point has as a rule
PARADT__NOINLINE void paradt__bw3_link_uncommon(paradt__bw *bw) {
    paradt__spheres3 *s = bw->spheres;
    if (bw->rim_count <= PARADT__WIDE_STAR) paradt__bw3_link(bw, s->wide_edges, PARADT__WIDE_ROWS, paradt__put3_plain);
    else paradt__bw3_link(bw, s->large_edges, s->large_rows, paradt__put3_plain);
}

// Where the new cells go: into the places of the cavity, and free ones behind them in its list. If there are fewer,
// what remains of the cavity becomes free. The spheres of the next new cells have places where nothing has been for
// long.
PARADT__INLINE paradt_status paradt__bw3_places(paradt__bw *bw) {
    paradt__spheres3 *s = bw->spheres;
    size_t count = bw->rim_count, i = bw->cavity_count;
    paradt_status status = i < count ? paradt__bw_room(bw, count - i) : PARADT_OK;
    if (!status) status = paradt__bw_list(bw, &bw->cavity, i, &bw->cavity_capacity, count + 3);
    if (status) return status;
    for (; i < count; i++) {
        bw->cavity[i] = 4 * paradt__bw_place(bw);
        PARADT__PREFETCH_TO_WRITE(s->table + ((paradt__tag)(bw->cells.count + PARADT__PLACES_AHEAD) & s->mask));
    }
    return PARADT_OK;
}

// Four new cells that are no ghosts: the edges to their vertices, and what their spheres are made of
typedef struct paradt__four3 {
    double edge[3][4][4]; // [vertex][axis, or square][cell]
    double normal[3][4], constant[4], error[4], power[4], least[4], least_at[4];
} paradt__four3;

// Of new cells, none of them a ghost, the last one again, up to a multiple of four
PARADT__INLINE void paradt__star3_fill(paradt__star3 *star) {
    int last = star->count - 1, i;
    for (i = star->count; i % 4; i++) {
        star->base[i] = star->base[last];
        memcpy(star->corner[i], star->corner[last], sizeof star->corner[i]);
    }
}

// The spheres of new cells, none of them a ghost, four at a time in vectors, and the next point's powers. In each of
// the four lanes the least power so far is kept, and of which four it is.
PARADT__INLINE void paradt__bw3_make_any(paradt__making3 making, const paradt__bw *bw, paradt__star3 *star,
                                         const double *x, const paradt__seen3 *seen) {
    paradt__spheres3 *s = bw->spheres;
    const paradt__frame3 frame = s->frame;
    paradt__seen3 p = *seen, next = s->next;
    paradt__four3 four;
    double(*a)[4] = four.edge[0], (*b)[4] = four.edge[1], (*c)[4] = four.edge[2];
    paradt__around3 *around = s->around, *end = paradt__around3_at(around, s->around_end);
    int i, vertex, axis, lane, best = 0;
    for (; around < end; around++) *around = paradt__around3_of(making, x, paradt__bw_record(bw, around->vertex));
    for (lane = 0; lane < 4; lane++) {
        four.least[lane] = PARADT__NO_ERROR_BOUND;
        four.least_at[lane] = 0.0;
    }
    paradt__star3_fill(star);
    for (i = 0; i < star->count; i += 4) {
        const double at = i;
        for (lane = 0; lane < 4; lane++) {
            for (vertex = 0; vertex < 3; vertex++) {
                const double *edge = paradt__around3_at(s->around, star->corner[i + lane][vertex])->edge;
                for (axis = 0; axis < 4; axis++) four.edge[vertex][axis][lane] = edge[axis];
            }
        }
        for (lane = 0; lane < 4; lane++) {
            const double to_a[4] = {a[0][lane], a[1][lane], a[2][lane], a[3][lane]};
            const double to_b[4] = {b[0][lane], b[1][lane], b[2][lane], b[3][lane]};
            const double to_c[4] = {c[0][lane], c[1][lane], c[2][lane], c[3][lane]};
            double n[3], d, e;
            paradt__sphere3_make(making, &frame, &p, to_b, to_a, to_c, n, &d, &e);
            for (axis = 0; axis < 3; axis++) four.normal[axis][lane] = n[axis];
            four.constant[lane] = d;
            four.error[lane] = e;
            four.power[lane] = (next.lift + d) + (n[0] * next.s[0] + n[1] * next.s[1] + n[2] * next.s[2]);
            four.least_at[lane] = four.power[lane] < four.least[lane] ? at : four.least_at[lane];
            four.least[lane] = four.power[lane] < four.least[lane] ? four.power[lane] : four.least[lane];
        }
        for (lane = 0; lane < 4; lane++) {
            paradt__tag cell = (paradt__tag)star->base[i + lane] >> 2;
            paradt__sphere3 *to = s->table + (cell & s->mask);
            for (axis = 0; axis < 3; axis++) to->normal[axis] = four.normal[axis][lane];
            to->constant = four.constant[lane];
            to->error = four.error[lane];
            to->tag = cell;
        }
    }
    for (lane = 1; lane < 4; lane++) best = four.least[lane] < four.least[best] ? lane : best;
    s->start = star->base[(int)four.least_at[best] + best] >> 2;
}

PARADT__NOINLINE void paradt__bw3_make_sharp_plain(const paradt__bw *bw, paradt__star3 *star, const double *x,
                                                   const paradt__seen3 *seen) {
    paradt__bw3_make_any(PARADT__MAKE_SHARP, bw, star, x, seen);
}

PARADT__NOINLINE void paradt__bw3_make_graded(const paradt__bw *bw, paradt__star3 *star, const double *x,
                                              const paradt__seen3 *seen) {
    paradt__bw3_make_any(PARADT__MAKE_GRADED, bw, star, x, seen);
}

static void paradt__bw3_make_plain(const paradt__bw *bw, paradt__star3 *star, const double *x,
                                   const paradt__seen3 *seen) {
    paradt__making3 making = bw->spheres->making;
    if (PARADT__LIKELY(making == PARADT__MAKE_QUICKLY)) paradt__bw3_make_any(PARADT__MAKE_QUICKLY, bw, star, x, seen);
    else if (making == PARADT__MAKE_SHARP) paradt__bw3_make_sharp_plain(bw, star, x, seen);
    else paradt__bw3_make_graded(bw, star, x, seen);
}

// The spheres of the ghosts among the new cells; the others into `star`. They are told apart without branches, as
// nothing foretells which is what: the others from the begin of its lists on, ghosts from the end.
PARADT__NOINLINE void paradt__bw3_ghosts(paradt__bw *bw, paradt__star3 *star, const double *x,
                                         const paradt__seen3 *seen) {
    paradt__spheres3 *s = bw->spheres;
    const size_t rim = bw->rim_count;
    const paradt_index *cavity = bw->cavity;
    paradt_index *base = s->finite_base;
    size_t count = 0, end = rim, i;
    for (i = 0; i < rim; i++) {
        size_t is_ghost = (s->row[i][0] | s->row[i][1] | s->row[i][2]) < 0, at = is_ghost ? end - 1 : count;
        base[at] = cavity[i];
        memcpy(s->finite_corner[at], s->corner[i], sizeof s->corner[i]);
        count += is_ghost ^ 1;
        end -= is_ghost;
    }
    for (i = end; i < rim; i++) {
        const paradt_index *vertices = bw->cells.vertices + base[i];
        paradt__tag cell = (paradt__tag)base[i] >> 2;
        paradt__sphere3 *sphere = s->table + (cell & s->mask);
        // the facet's vertices in the order of paradt__facet3, but from the point on, which is the cell's last one
        int q = vertices[0] < 0 ? 2 : vertices[1] < 0 ? 0 : 1, r = q ? q - 1 : 2;
        paradt__sphere3_of_facet(s, sphere, seen, x, paradt__bw_record(bw, vertices[q]),
                                 paradt__bw_record(bw, vertices[r]));
        sphere->tag = cell;
    }
    star->base = base;
    star->corner = s->finite_corner;
    star->count = (int)count;
}

// The spheres of the new cells, and where to start for the next point.
PARADT__INLINE void paradt__bw3_spheres(paradt__bw *bw, const double *x, const paradt__seen3 *seen,
                                        paradt__make_spheres3 make) {
    paradt__spheres3 *s = bw->spheres;
    paradt__star3 star;
    star.base = bw->cavity;
    star.corner = s->corner;
    star.count = (int)bw->rim_count;
    s->start = bw->cavity[0] >> 2;
    // what makes spheres fills the list up, in which more of the cavity may follow
    if (!PARADT__LIKELY(!s->ghosts && bw->rim_count >= bw->cavity_count)) paradt__bw3_ghosts(bw, &star, x, seen);
    if (star.count) make(bw, &star, x, seen);
}

// The places of the cavity from number `first` on become free, and their marks are taken away.
static paradt_status paradt__bw3_clear(paradt__bw *bw, size_t first) {
    paradt__spheres3 *s = bw->spheres;
    size_t i;
    paradt_status status =
        paradt__bw_list(bw, &bw->spare, bw->spare_count, &bw->spare_capacity, bw->spare_count + bw->cavity_count);
    if (status) return status;
    for (i = first; i < bw->cavity_count; i++) {
        paradt__tag cell = (paradt__tag)bw->cavity[i] >> 2, *tag = &s->table[cell & s->mask].tag;
        if (*tag & PARADT__KNOWN) *tag = PARADT__NO_SPHERE;
        bw->spare[bw->spare_count++] = (paradt_index)cell;
    }
    return PARADT_OK;
}

// Makes the new cells one by one, where there are too many for the tables.
static paradt_status paradt__bw3_fill_large(paradt__bw *bw, paradt_index point) {
    paradt__spheres3 *s = bw->spheres;
    paradt_status status = paradt__bw_fill(bw, point);
    size_t i;
    for (i = 0; i < bw->rim_count && !status; i++) {
        paradt__tag cell = (paradt__tag)bw->rim[i] >> 2;
        s->table[cell & s->mask].tag = PARADT__NO_SPHERE;
    }
    s->start = bw->last;
    return status ? status : paradt__bw3_clear(bw, 0);
}

PARADT__INLINE paradt_status paradt__bw3_insert_any(paradt__bw *bw, paradt_index point, paradt__spread3 spread,
                                                    paradt__remake3 remake, paradt__make_spheres3 make,
                                                    paradt__turn3 turn, paradt__put3 put) {
    paradt__spheres3 *s = bw->spheres;
    const double *x = paradt__bw_record(bw, point);
    paradt__seen3 seen = s->next;
    paradt_status status = paradt__bw3_dig(bw, paradt__bw3_locate(bw, &seen, x), &seen, x, spread, remake);
    size_t i;
    int is_common;
    if (status) return status;
    if (bw->inserted + 1 < bw->count)
        s->next = paradt__seen3_of(s, paradt__bw_record(bw, paradt__bw_point(bw, bw->inserted + 1)));
    if (bw->inserted + PARADT__AHEAD < bw->count)
        PARADT__PREFETCH(paradt__bw_record(bw, paradt__bw_point(bw, bw->inserted + PARADT__AHEAD)));
    for (i = 0; s->driven_out && i < bw->cavity_count; i++) bw->marks[bw->cavity[i] >> 2] = 0;
    s->driven_out = 0;
    s->made += bw->rim_count;
    if (!PARADT__LIKELY(s->missed + s->vague <= s->mask)) paradt__bw3_adapt(bw);
    is_common = bw->rim_count <= PARADT__COMMON_STAR;
    if (!PARADT__LIKELY(is_common)) paradt__bw3_widen_star(bw);
    if (!PARADT__LIKELY(is_common) && bw->rim_count > PARADT__WIDE_STAR && bw->rim_count > s->large_star)
        return paradt__bw3_fill_large(bw, point);
    status = paradt__bw3_places(bw);
    if (status) return status;
    paradt__bw3_rows(bw, point, turn);
    if (PARADT__LIKELY(is_common))
        paradt__bw3_link(bw, s->common_edges, PARADT__COMMON_VERTICES / PARADT__EDGE_ROW, put);
    else paradt__bw3_link_uncommon(bw);
    paradt__bw3_spheres(bw, x, &seen, make);
    return bw->rim_count < bw->cavity_count ? paradt__bw3_clear(bw, bw->rim_count) : PARADT_OK;
}

static size_t paradt__bw3_spread_plain(paradt__bw *bw, paradt__dig3 *work, const paradt__seen3 *at, const double *x,
                                       size_t head) {
    return paradt__bw3_spread(bw, work, at, x, head);
}

static paradt_status paradt__bw3_insert(paradt__bw *bw, paradt_index point) {
    return paradt__bw3_insert_any(bw, point, paradt__bw3_spread_plain, paradt__bw3_remake_plain, paradt__bw3_make_plain,
                                  paradt__turn3_plain, paradt__put3_plain);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>insertion in space, avx2
//
// Doors: to be listed.

#if PARADT__BW_AVX2
// The same for four facets, cells or vertices at a time. It differs in nothing but the last bits of powers, which
// decide nothing where they are in doubt.

// Bytes to shuffle so that the elements of four of which the mask has bits come first
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

// The elements of which the mask has bits, first
PARADT__AVX2 PARADT__INLINE __m128i paradt__packed3(__m128i elements, unsigned mask) {
    return _mm_shuffle_epi8(elements, _mm_loadu_si128((const __m128i *)(const void *)paradt__packing[mask]));
}

// Where the spheres of four cells are, or others that have their places
typedef struct paradt__four_at {
    char *a, *b, *c, *d;
} paradt__four_at;

enum { PARADT__ERROR_AT = offsetof(paradt__sphere3, error), PARADT__TAG_AT = offsetof(paradt__sphere3, tag) };

// Of the cells across the facets of a row. Not by way of vectors, so they are known sooner.
PARADT__INLINE paradt__four_at paradt__four_across(const paradt__dig3 *dig, const paradt_index *row) {
    const paradt__tag places = 4 * dig->mask; // of handles, which times 16 are times 64 of the cells' numbers
    char *table = (char *)dig->table;
    paradt__four_at at;
    at.a = table + 16 * (size_t)((paradt__tag)row[0] & places);
    at.b = table + 16 * (size_t)((paradt__tag)row[1] & places);
    at.c = table + 16 * (size_t)((paradt__tag)row[2] & places);
    at.d = table + 16 * (size_t)((paradt__tag)row[3] & places);
    return at;
}

PARADT__AVX2 PARADT__INLINE __m256d paradt__terms3(const char *sphere, __m256d query) {
    return _mm256_mul_pd(_mm256_load_pd((const double *)(const void *)sphere), query);
}

// A point's powers. query: its place and 1; lift: its lift, four times
PARADT__AVX2 PARADT__INLINE __m256d paradt__four_powers(paradt__four_at at, __m256d query, __m256d lift) {
    __m256d ab = _mm256_hadd_pd(paradt__terms3(at.a, query), paradt__terms3(at.b, query));
    __m256d cd = _mm256_hadd_pd(paradt__terms3(at.c, query), paradt__terms3(at.d, query));
    __m256d ends = _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x31), lift);
    return _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x20), ends);
}

PARADT__AVX2 PARADT__INLINE __m128d paradt__two_errors(const char *a, const char *b) {
    __m128d error = _mm_load_sd((const double *)(const void *)(a + PARADT__ERROR_AT));
    return _mm_loadh_pd(error, (const double *)(const void *)(b + PARADT__ERROR_AT));
}

PARADT__AVX2 PARADT__INLINE __m256d paradt__four_errors(paradt__four_at at) {
    __m128d ab = paradt__two_errors(at.a, at.b), cd = paradt__two_errors(at.c, at.d);
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(ab), cd, 1);
}

PARADT__INLINE int *paradt__tag_at(char *sphere) {
    return (int *)(void *)(sphere + PARADT__TAG_AT);
}

PARADT__AVX2 PARADT__INLINE __m128i paradt__four_tags(paradt__four_at at) {
    __m128i tags = _mm_cvtsi32_si128(*paradt__tag_at(at.a));
    tags = _mm_insert_epi32(tags, *paradt__tag_at(at.b), 1);
    tags = _mm_insert_epi32(tags, *paradt__tag_at(at.c), 2);
    return _mm_insert_epi32(tags, *paradt__tag_at(at.d), 3);
}

// The cells become the tags, with a mark where the power is negative: its sign, narrowed to 32 bits.
PARADT__AVX2 PARADT__INLINE void paradt__four_mark(paradt__four_at at, __m128i cells, __m256d power) {
    __m128i tags = _mm_castps_si128(_mm_shuffle_ps(_mm_castpd_ps(_mm256_castpd256_pd128(power)),
                                                   _mm_castpd_ps(_mm256_extractf128_pd(power, 1)), 0xdd));
    tags = _mm_or_si128(cells, _mm_and_si128(tags, _mm_set1_epi32((int)PARADT__KNOWN)));
    *paradt__tag_at(at.a) = _mm_cvtsi128_si32(tags);
    *paradt__tag_at(at.b) = _mm_extract_epi32(tags, 1);
    *paradt__tag_at(at.c) = _mm_extract_epi32(tags, 2);
    *paradt__tag_at(at.d) = _mm_extract_epi32(tags, 3);
}

PARADT__AVX2 PARADT__INLINE unsigned paradt__signs_avx2(__m128i x) {
    return (unsigned)_mm_movemask_ps(_mm_castsi128_ps(x));
}

// Facets wait behind which a sphere is missing or the power does not tell. (The order of statements counts: 4 %.)
PARADT__AVX2 static size_t paradt__bw3_spread_avx2(paradt__bw *bw, paradt__dig3 *work, const paradt__seen3 *seen,
                                                   const double *x, size_t head) {
    paradt__dig3 dig = *work;
    const size_t cells = bw->cavity_capacity - PARADT__DIG_ROOM - dig.cavity_count;
    const size_t facets = bw->rim_capacity - PARADT__DIG_ROOM - dig.rim_count;
    const size_t room = (cells < facets ? cells : facets) / 4;
    const __m256d query = _mm256_setr_pd(seen->s[0], seen->s[1], seen->s[2], 1.0);
    const __m256d lift = _mm256_set1_pd(seen->lift), sign = _mm256_set1_pd(-0.0);
    const __m128i marks = _mm_set1_epi32((int)PARADT__KNOWN), order = _mm_setr_epi32(0, 1, 2, 3);
    paradt_index *cell = dig.cavity + head, *end = dig.cavity + dig.cavity_count, *rim = dig.rim + dig.rim_count;
    paradt_index *last = cell + (room < PARADT__DIG_AT_ONCE ? room : PARADT__DIG_AT_ONCE - 1);
    paradt__sphere3 nowhere; // what no cell is marked in
    (void)x;
    for (; cell < end && cell <= last; cell++) {
        paradt_index entry = *cell, base = entry & ~(paradt_index)3;
        const paradt_index *row = dig.neighbors + (paradt__tag)base;
        __m128i across = _mm_loadu_si128((const __m128i *)(const void *)row), others = _mm_srli_epi32(across, 2);
        __m128i here = _mm_castps_si128(_mm_broadcast_ss((const float *)(const void *)cell)), tags;
        paradt__four_at at = paradt__four_across(&dig, row);
        __m256d power = paradt__four_powers(at, query, lift), error = paradt__four_errors(at);
        unsigned inside = (unsigned)_mm256_movemask_pd(power), outside, sure, fresh;
        here = _mm_or_si128(_mm_andnot_si128(_mm_set1_epi32(3), here), order);
        *cell = base;
        paradt__bw3_number(&dig, dig.vertices[entry]);
        tags = paradt__four_tags(at);
        sure = (unsigned)_mm256_movemask_pd(_mm256_cmp_pd(_mm256_andnot_pd(sign, power), error, _CMP_GT_OQ)) &
               paradt__signs_avx2(_mm_cmpeq_epi32(_mm_andnot_si128(marks, tags), others));
        outside = ~inside & 15;
        // what the next rounds of this loop and the new cells' links will touch
        PARADT__PREFETCH(dig.neighbors + (paradt__tag)row[0]);
        PARADT__PREFETCH(dig.neighbors + (paradt__tag)row[1]);
        PARADT__PREFETCH(dig.neighbors + (paradt__tag)row[2]);
        PARADT__PREFETCH(dig.neighbors + (paradt__tag)row[3]);
        if (!PARADT__LIKELY(sure == 15)) {
            int i;
            for (i = 0; i < 4; i++) PARADT__PREFETCH(dig.vertices + row[i]);
            _mm_storeu_si128((__m128i *)(void *)(bw->spheres->waiting + dig.waiting_count),
                             paradt__packed3(here, sure ^ 15));
            dig.waiting_count += __builtin_popcount(sure ^ 15);
            if (dig.waiting_count > PARADT__LATE - 4) last = cell;
            at.a = sure & 1 ? at.a : (char *)&nowhere;
            at.b = sure & 2 ? at.b : (char *)&nowhere;
            at.c = sure & 4 ? at.c : (char *)&nowhere;
            at.d = sure & 8 ? at.d : (char *)&nowhere;
            inside &= sure;
            outside &= sure;
        }
        fresh = inside & ~paradt__signs_avx2(tags);
        paradt__four_mark(at, others, power);
        _mm_storeu_si128((__m128i *)(void *)end, paradt__packed3(across, fresh));
        end += __builtin_popcount(fresh);
        _mm_storeu_si128((__m128i *)(void *)rim, paradt__packed3(here, outside));
        rim += __builtin_popcount(outside);
    }
    dig.cavity_count = (size_t)(end - dig.cavity);
    dig.rim_count = (size_t)(rim - dig.rim);
    *work = dig;
    return (size_t)(cell - dig.cavity);
}

PARADT__AVX2 PARADT__INLINE __m256d paradt__abs_avx2(__m256d x) {
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x);
}

PARADT__AVX2 PARADT__INLINE __m256d paradt__dot_avx2(const __m256d *a, const __m256d *b) {
    return _mm256_fmadd_pd(a[2], b[2], _mm256_fmadd_pd(a[1], b[1], _mm256_mul_pd(a[0], b[0])));
}

// a x b along an axis; with sign -1 the sum of its two terms instead: of sizes, their size
PARADT__AVX2 PARADT__INLINE __m256d paradt__cross_avx2(const __m256d *a, const __m256d *b, int axis, int sign) {
    int j = (axis + 1) % 3, k = (axis + 2) % 3;
    __m256d product = _mm256_mul_pd(a[k], b[j]);
    return sign > 0 ? _mm256_fmsub_pd(a[j], b[k], product) : _mm256_fmadd_pd(a[j], b[k], product);
}

// P and sum N_j h_j of paradt__sphere3_make, for four cells
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

// The spheres of four cells, as paradt__sphere3_make makes them: the normals by axis, and the constants. p: by axis,
// and the lift, as the spheres see it; a, b, c: by axis, and the squares of the lengths
PARADT__AVX2 PARADT__INLINE void paradt__four_spheres(int sharp, const paradt__frame3 *f, const __m256d *p,
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

// Four columns to four rows
PARADT__AVX2 PARADT__INLINE void paradt__four_rows(const __m256d *column, double *a, double *b, double *c, double *d) {
    __m256d xy_02 = _mm256_unpacklo_pd(column[0], column[1]), xy_13 = _mm256_unpackhi_pd(column[0], column[1]);
    __m256d zw_02 = _mm256_unpacklo_pd(column[2], column[3]), zw_13 = _mm256_unpackhi_pd(column[2], column[3]);
    _mm256_storeu_pd(a, _mm256_permute2f128_pd(xy_02, zw_02, 0x20));
    _mm256_storeu_pd(b, _mm256_permute2f128_pd(xy_13, zw_13, 0x20));
    _mm256_storeu_pd(c, _mm256_permute2f128_pd(xy_02, zw_02, 0x31));
    _mm256_storeu_pd(d, _mm256_permute2f128_pd(xy_13, zw_13, 0x31));
}

// Puts the spheres of four cells into the table.
PARADT__AVX2 PARADT__INLINE void paradt__four_store(paradt__sphere3 *table, paradt__tag mask, __m128i cells,
                                                    const __m256d *sphere, __m256d error) {
    __m128i places = _mm_slli_epi32(_mm_and_si128(cells, _mm_set1_epi32((int)mask)), 6);
    uint64_t low = (uint64_t)_mm_cvtsi128_si64(places), high = (uint64_t)_mm_extract_epi64(places, 1);
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

// Four places, by axis, less a point
PARADT__AVX2 PARADT__INLINE void paradt__four_places(const double *a, const double *b, const double *c, const double *d,
                                                     const __m256d *point, __m256d *to) {
    __m256d xy_02 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(a)), _mm_loadu_pd(c), 1);
    __m256d xy_13 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(b)), _mm_loadu_pd(d), 1);
    __m256d z_02 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_sd(a + 2)), _mm_load_sd(c + 2), 1);
    __m256d z_13 = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_sd(b + 2)), _mm_load_sd(d + 2), 1);
    to[0] = _mm256_sub_pd(_mm256_unpacklo_pd(xy_02, xy_13), point[0]);
    to[1] = _mm256_sub_pd(_mm256_unpackhi_pd(xy_02, xy_13), point[1]);
    to[2] = _mm256_sub_pd(_mm256_unpacklo_pd(z_02, z_13), point[2]);
}

// The edges to the vertices around the point, in the place of these
PARADT__AVX2 PARADT__INLINE void paradt__bw3_edges_avx2(const paradt__bw *bw, const __m256d *point) {
    paradt__around3 *at = bw->spheres->around, *end = paradt__around3_at(at, bw->spheres->around_end);
    int i;
    for (i = 0; i < 3; i++) end[i].vertex = 0; // they are made four at a time: any will do behind the last
    for (; at < end; at += 4) {
        __m256d to[4];
        paradt__four_places(paradt__bw_record(bw, at[0].vertex), paradt__bw_record(bw, at[1].vertex),
                            paradt__bw_record(bw, at[2].vertex), paradt__bw_record(bw, at[3].vertex), point, to);
        to[3] = paradt__dot_avx2(to, to);
        paradt__four_rows(to, at[0].edge, at[1].edge, at[2].edge, at[3].edge);
    }
}

// Half of two rows
PARADT__AVX2 PARADT__INLINE __m256d paradt__two_halves(const double *a, const double *b) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(a)), _mm_loadu_pd(b), 1);
}

// The edges to the vertices that four new cells have in a place
PARADT__AVX2 PARADT__INLINE void paradt__four_around(paradt__spheres3 *s, uint16_t (*corner)[4], int place,
                                                     __m256d *to) {
    const double *a = paradt__around3_at(s->around, corner[0][place])->edge;
    const double *b = paradt__around3_at(s->around, corner[1][place])->edge;
    const double *c = paradt__around3_at(s->around, corner[2][place])->edge;
    const double *d = paradt__around3_at(s->around, corner[3][place])->edge;
    __m256d xy_02 = paradt__two_halves(a, c), xy_13 = paradt__two_halves(b, d);
    __m256d zl_02 = paradt__two_halves(a + 2, c + 2), zl_13 = paradt__two_halves(b + 2, d + 2);
    to[0] = _mm256_unpacklo_pd(xy_02, xy_13);
    to[1] = _mm256_unpackhi_pd(xy_02, xy_13);
    to[2] = _mm256_unpacklo_pd(zl_02, zl_13);
    to[3] = _mm256_unpackhi_pd(zl_02, zl_13);
}

// Of four cells that with the least power
PARADT__AVX2 PARADT__INLINE paradt_index paradt__four_least(__m256d powers, __m128i cells) {
    int cell[4];
    __m256d least = _mm256_min_pd(powers, _mm256_permute2f128_pd(powers, powers, 1));
    least = _mm256_min_pd(least, _mm256_permute_pd(least, 5));
    _mm_storeu_si128((__m128i *)(void *)cell, cells);
    return cell[paradt__trailing_zeros((unsigned)_mm256_movemask_pd(_mm256_cmp_pd(powers, least, _CMP_EQ_OQ)))];
}

PARADT__AVX2 PARADT__INLINE void paradt__bw3_make_four(int sharp, const paradt__bw *bw, paradt__star3 *star,
                                                       const double *x, const paradt__seen3 *seen) {
    paradt__spheres3 *s = bw->spheres;
    const __m256d point[3] = {_mm256_set1_pd(x[0]), _mm256_set1_pd(x[1]), _mm256_set1_pd(x[2])};
    const __m256d p[4] = {_mm256_set1_pd(seen->s[0]), _mm256_set1_pd(seen->s[1]), _mm256_set1_pd(seen->s[2]),
                          _mm256_set1_pd(seen->lift)};
    const __m256d next[3] = {_mm256_set1_pd(s->next.s[0]), _mm256_set1_pd(s->next.s[1]), _mm256_set1_pd(s->next.s[2])};
    const paradt__frame3 frame = s->frame;
    paradt__sphere3 *table = s->table;
    paradt__tag mask = s->mask;
    __m256d least = _mm256_set1_pd(PARADT__NO_ERROR_BOUND);
    __m128i best = _mm_set1_epi32(star->base[0] >> 2);
    int i, count = star->count;
    paradt__bw3_edges_avx2(bw, point);
    paradt__star3_fill(star);
    for (i = 0; i < count; i += 4) {
        __m256d a[4], b[4], c[4], sphere[4], error, power, less;
        __m128i cells = _mm_srli_epi32(_mm_loadu_si128((const __m128i *)(const void *)(star->base + i)), 2), is_less;
        paradt__four_around(s, star->corner + i, 1, a);
        paradt__four_around(s, star->corner + i, 0, b);
        paradt__four_around(s, star->corner + i, 2, c);
        paradt__four_spheres(sharp, &frame, p, a, b, c, sphere, &error);
        paradt__four_store(table, mask, cells, sphere, error);
        power = _mm256_add_pd(sphere[3], paradt__dot_avx2(sphere, next)); // less the next point's lift
        less = _mm256_cmp_pd(power, least, _CMP_LT_OQ);
        least = _mm256_min_pd(power, least);
        is_less = _mm_castps_si128(_mm_shuffle_ps(_mm_castpd_ps(_mm256_castpd256_pd128(less)),
                                                  _mm_castpd_ps(_mm256_extractf128_pd(less, 1)), 0x88));
        best = _mm_blendv_epi8(best, cells, is_less);
    }
    s->start = paradt__four_least(least, best);
}

PARADT__AVX2 PARADT__NOINLINE void paradt__bw3_make_sharp_avx2(const paradt__bw *bw, paradt__star3 *star,
                                                               const double *x, const paradt__seen3 *seen) {
    paradt__bw3_make_four(1, bw, star, x, seen);
}

PARADT__AVX2 static void paradt__bw3_make_avx2(const paradt__bw *bw, paradt__star3 *star, const double *x,
                                               const paradt__seen3 *seen) {
    paradt__making3 making = bw->spheres->making;
    if (PARADT__LIKELY(making == PARADT__MAKE_QUICKLY)) paradt__bw3_make_four(0, bw, star, x, seen);
    else if (making == PARADT__MAKE_SHARP) paradt__bw3_make_sharp_avx2(bw, star, x, seen);
    else paradt__bw3_make_graded(bw, star, x, seen);
}

// The spheres of four cells that are not in the table, none of them a ghost
PARADT__AVX2 PARADT__INLINE void paradt__bw3_remake_four(const paradt__bw *bw, const int *cells) {
    const paradt__spheres3 *s = bw->spheres;
    const __m256d centre[3] = {_mm256_set1_pd(s->centre[0]), _mm256_set1_pd(s->centre[1]),
                               _mm256_set1_pd(s->centre[2])};
    __m256d corner[4][4], p[4], sphere[4], error;
    int i, axis;
    for (i = 0; i < 4; i++) {
        const paradt_index *vertices = bw->cells.vertices + i;
        const __m256d zero[3] = {_mm256_setzero_pd(), _mm256_setzero_pd(), _mm256_setzero_pd()};
        paradt__four_places(paradt__bw_record(bw, vertices[4 * (size_t)cells[0]]),
                            paradt__bw_record(bw, vertices[4 * (size_t)cells[1]]),
                            paradt__bw_record(bw, vertices[4 * (size_t)cells[2]]),
                            paradt__bw_record(bw, vertices[4 * (size_t)cells[3]]), zero, corner[i]);
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

PARADT__AVX2 static void paradt__bw3_remake_avx2(const paradt__bw *bw, const paradt_index *waiting, int count) {
    const paradt__spheres3 *s = bw->spheres;
    int cells[PARADT__LATE + 3], missing = 0, i;
    if (s->making == PARADT__MAKE_GRADED) {
        paradt__bw3_remake_plain(bw, waiting, count);
        return;
    }
    for (i = 0; i < count; i++) {
        paradt_index cell = bw->cells.neighbors[waiting[i]] >> 2;
        cells[missing] = cell;
        missing += ((s->table[(paradt__tag)cell & s->mask].tag & ~PARADT__KNOWN) != (paradt__tag)cell) &
                   paradt__vertices_among(bw->cells.vertices + 4 * (size_t)cell, 4, 0, PARADT__NOWHERE);
    }
    for (i = 0; i < missing; i++) paradt__bw3_drive_out(bw, cells[i]);
    for (i = missing; i % 4; i++) cells[i] = cells[missing - 1];
    for (i = 0; i < missing; i += 4) paradt__bw3_remake_four(bw, cells + i);
    for (i = 0; i < missing; i++) {
        paradt__sphere3 *sphere = s->table + ((paradt__tag)cells[i] & s->mask);
        if (bw->marks[cells[i]] & PARADT__CONFLICT && sphere->tag == (paradt__tag)cells[i])
            sphere->tag |= PARADT__KNOWN;
    }
}

// The shuffles for paradt__facet3; the last place is left empty.
#define PARADT__TURN(a, b, c)                                                                                          \
    { PARADT__LANE(a), PARADT__LANE(b), PARADT__LANE(c), 128, 128, 128, 128 }
static const unsigned char paradt__turns3[4][16] = {PARADT__TURN(1, 3, 2), PARADT__TURN(0, 2, 3), PARADT__TURN(1, 0, 3),
                                                    PARADT__TURN(0, 1, 2)};
#undef PARADT__TURN
#undef PARADT__LANE

PARADT__AVX2 static void paradt__turn3_avx2(paradt_index *row, const paradt_index *cell, int without,
                                            paradt_index point) {
    __m128i vertices = _mm_loadu_si128((const __m128i *)(const void *)cell);
    __m128i facet = _mm_shuffle_epi8(vertices, _mm_loadu_si128((const __m128i *)(const void *)paradt__turns3[without]));
    _mm_storeu_si128((__m128i *)(void *)row, _mm_or_si128(facet, _mm_setr_epi32(0, 0, 0, point)));
}

// One store: what reads all four soon need not wait until they are in the cache.
PARADT__AVX2 static void paradt__put3_avx2(paradt_index *links, paradt_index a, paradt_index b, paradt_index c,
                                           paradt_index d) {
    _mm_storeu_si128((__m128i *)(void *)links, _mm_setr_epi32(a, b, c, d));
}

PARADT__AVX2 static paradt_status paradt__bw3_insert_avx2(paradt__bw *bw, paradt_index point) {
    return paradt__bw3_insert_any(bw, point, paradt__bw3_spread_avx2, paradt__bw3_remake_avx2, paradt__bw3_make_avx2,
                                  paradt__turn3_avx2, paradt__put3_avx2);
}
#endif

// Room for the numbers of more vertices
static int paradt__bw3_more_numbers(paradt__bw *bw, size_t numbers) {
    paradt__spheres3 *s = bw->spheres;
    void *array = s->number;
    if (!paradt__grow(bw->memory, &array, s->numbers, numbers, sizeof *s->number)) return 0;
    s->number = (uint32_t *)array;
    paradt__make_pages(s->number, s->numbers * sizeof *s->number, numbers * sizeof *s->number);
    memset(s->number + s->numbers, 0, (numbers - s->numbers) * sizeof *s->number);
    s->numbers = numbers;
    return 1;
}

// Takes the sagittas where they are so small that without them most powers would tell nothing.
static void paradt__bw3_grade(paradt__bw *bw) {
    paradt__spheres3 *s = bw->spheres;
    double square = bw->grade_limit + bw->grade_error / (16.0 * PARADT__UNIT_ERROR);
    if (!bw->graded || !(square < s->square * PARADT__GRADE_PAYS)) return;
    s->making = PARADT__MAKE_GRADED;
    s->frame.square = square;
    s->frame.slack = bw->grade_error / (4.0 * PARADT__UNIT_ERROR);
}

// Where the floating-point filter holds; elsewhere the insertion in any dimension does it.
static paradt_status paradt__bw3_begin(paradt__bw *bw) {
    paradt__spheres3 *s;
    size_t size = 64, points = bw->cells.lent ? 8 : 5, room, bytes, i;
    int axis;
    if (!bw->space.filtered || bw->space.weighted || bw->space.ambient != 3) return PARADT_OK;
    while (size < 8 * bw->count && size < PARADT__SPHERES) size *= 2;
    while (size < bw->count / points && size < PARADT__MOST_SPHERES) size *= 2;
    room = size > PARADT__LEAST_SPHERES ? size : (size_t)PARADT__LEAST_SPHERES;
    bytes = sizeof *s + (room + 1) * sizeof *s->table;
    s = (paradt__spheres3 *)paradt__alloc(bw->memory, 1, bytes);
    bw->spheres = s;
    if (!s) return PARADT_ERROR_MEMORY;
    // not for few: allocators keep the pages from the call before, and only to look for them takes a seventh of a call
    if (size > PARADT__LEAST_SPHERES) paradt__make_pages(s, sizeof *s, bytes);
    memset(s, 0, offsetof(paradt__spheres3, around)); // what follows is written before it is read
    s->mask = (paradt__tag)(size - 1);
    s->table = paradt__on_line(s + 1);
    if (!paradt__bw3_more_numbers(bw, bw->count + 1)) return PARADT_ERROR_MEMORY;
    s->next_number = PARADT__NEXT_NUMBER;
    for (i = 0; i < size; i++) s->table[i].tag = PARADT__NO_SPHERE;
    for (axis = 0; axis < 3; axis++) {
        double low = paradt__from_ordered_bits(bw->space.low[axis]);
        double high = paradt__from_ordered_bits(bw->space.high[axis]);
        s->centre[axis] = paradt__rounded(low + (high - low) * 0.5);
        s->frame.half[axis] = paradt__larger(high - s->centre[axis], s->centre[axis] - low) * 1.0000002;
        s->frame.square += s->frame.half[axis] * s->frame.half[axis];
    }
    s->square = s->frame.square;
    s->steep = sqrt(s->square) * paradt__power(60);
    paradt__bw3_grade(bw);
    s->nil = bw->space.insphere[3].quantum / (64.0 * s->frame.half[0] * s->frame.half[1] * s->frame.half[2]);
    if (bw->count > 4) s->next = paradt__seen3_of(s, paradt__bw_record(bw, paradt__bw_point(bw, 4)));
    return paradt__bw_list(bw, &bw->rim, 0, &bw->rim_capacity, PARADT__FIRST_DIG);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>ends
//
// Doors: to be listed.

// Cell 0 is that of the first points, cell 1 + i the ghost on its facet opposite vertex i.
static paradt_status paradt__bw_first(paradt__bw *bw) {
    int corners = bw->cells.corners, i, j;
    const double *p[PARADT_MAX_DIM + 1];
    paradt_index *vertices, *neighbors;
    paradt_status status = paradt__bw_reserve(bw, (size_t)corners + 1, (size_t)corners + 1);
    if (status) return status;
    vertices = bw->cells.vertices;
    neighbors = bw->cells.neighbors;
    bw->cells.count = (size_t)corners + 1;
    for (i = 0; i < corners; i++) {
        vertices[i] = paradt__bw_point(bw, (size_t)i);
        p[i] = paradt__bw_record(bw, vertices[i]);
    }
    if (paradt__orient(&bw->space, p) < 0) {
        vertices[0] = paradt__bw_point(bw, 1);
        vertices[1] = paradt__bw_point(bw, 0);
    }
    // In the ghosts two vertices change places, 0 and 1, for the infinite vertex is on the other side of the facet.
    for (i = 0; i < corners; i++) {
        paradt_index base = (paradt_index)((i + 1) * corners);
        for (j = 0; j < corners; j++) {
            int place = j < 2 ? 1 - j : j;
            vertices[base + place] = j == i ? (paradt_index)PARADT__INFINITE : vertices[j];
            // ghosts i and j meet in the facet without vertices i and j, and that is opposite what stands for i in
            // ghost j
            neighbors[base + place] =
                j == i ? (paradt_index)i : (paradt_index)((j + 1) * corners + (i < 2 ? 1 - i : i));
            if (j == i) neighbors[i] = base + place;
        }
    }
    return PARADT_OK;
}

// Marks the places that are free.
static void paradt__bw_mark_free(paradt__bw *bw) {
    size_t corners = (size_t)bw->cells.corners, i;
    for (i = 0; i < bw->spare_count; i++) bw->cells.vertices[(size_t)bw->spare[i] * corners] = PARADT__DEAD;
}

// Is at a place a cell that is no ghost? A ghost becomes free, and its facet the hull's.
PARADT__INLINE int paradt__bw_keep(const paradt__cells *cells, size_t place, size_t corners, uint64_t *ghosts) {
    paradt_index *vertices = cells->vertices + place * corners;
    if (PARADT__LIKELY(paradt__vertices_among(vertices, (int)corners, 0, PARADT__NOWHERE))) return 1;
    if (vertices[0] == PARADT__DEAD) return 0;
    cells->neighbors[cells->neighbors[place * corners + (size_t)paradt__bw_ghost(vertices, (int)corners)]] =
        PARADT__HULL;
    vertices[0] = PARADT__DEAD;
    ++*ghosts;
    return 0;
}

// Moves a cell to a place before it. In the first `numbered` cells neighbours are numbers, else handles. As a rule
// those just before it are moved next: their neighbours, which are anywhere, are fetched ahead.
PARADT__INLINE void paradt__bw_move(const paradt__cells *cells, size_t place, size_t from, size_t corners,
                                    size_t numbered) {
    enum { AHEAD = 8 };
    paradt_index *vertices = cells->vertices, *neighbors = cells->neighbors;
    const paradt_index *soon = neighbors + (from - (from < AHEAD ? 0 : AHEAD)) * corners;
    size_t j;
    for (j = 0; j < corners; j++) PARADT__FETCH(neighbors, soon[j]);
    memcpy(vertices + place * corners, vertices + from * corners, corners * sizeof *vertices);
    memcpy(neighbors + place * corners, neighbors + from * corners, corners * sizeof *neighbors);
    for (j = 0; j < corners; j++) {
        paradt_index handle = neighbors[place * corners + j];
        if (handle >= 0)
            neighbors[handle] = (paradt_index)((size_t)handle < numbered * corners ? place : place * corners + j);
    }
}

// Fills those of the places that are free, and below the number of cells that there are, with the last cells. end:
// where these end. Returns where they do then.
PARADT__INLINE size_t paradt__bw_fill_places(const paradt__cells *cells, const paradt_index *places, size_t count,
                                             size_t end, size_t corners) {
    size_t i;
    for (i = 0; i < count; i++) {
        size_t place = (size_t)places[i];
        if (place >= cells->count || cells->vertices[place * corners] != PARADT__DEAD) continue;
        do end--;
        while (cells->vertices[end * corners] == PARADT__DEAD);
        paradt__bw_move(cells, place, end, corners, 0);
    }
    return end;
}

static void paradt__bw_fill_gaps(const paradt__bw *bw, const paradt_index *places, size_t count, size_t *end) {
    const paradt__cells cells = bw->cells; // a copy, which nothing that is written can change
    if (cells.corners == 4) *end = paradt__bw_fill_places(&cells, places, count, *end, 4);
    else *end = paradt__bw_fill_places(&cells, places, count, *end, (size_t)cells.corners);
}

// Passes over all cells ask for rows so far ahead, for the same reason as passes over all points.
enum { PARADT__ROWS_AHEAD = 128 };

PARADT__INLINE void paradt__fetch_row(const paradt_index *vertices, const paradt_index *neighbors, size_t row,
                                      size_t corners) {
    PARADT__FETCH(vertices, row * corners);
    PARADT__FETCH(neighbors, row * corners);
}

// Fetches the row of a place that comes soon in a list.
PARADT__INLINE void paradt__fetch_listed(const paradt__cells *cells, const paradt_index *list, size_t count,
                                         size_t at) {
    enum { AHEAD = 8 };
    if (at + AHEAD < count)
        paradt__fetch_row(cells->vertices, cells->neighbors, (size_t)list[at + AHEAD], (size_t)cells->corners);
}

// Where cells go: the rows of the first, and its number
typedef struct paradt__rows {
    paradt_index *vertices, *neighbors, offset;
} paradt__rows;

static paradt__rows paradt__rows_in_place(const paradt__cells *cells) {
    paradt__rows to;
    to.vertices = cells->vertices;
    to.neighbors = cells->neighbors;
    to.offset = 0;
    return to;
}

// Writes the cell at a place into the same row of `to`: its neighbours, that were handles, become numbers, its vertices
// are translated (origin NULL: not). Has it a facet without a neighbour?
PARADT__INLINE int paradt__bw_number(const paradt__cells *cells, size_t place, size_t corners,
                                     const paradt_index *origin, const paradt__rows *to) {
    const paradt_index *vertices = cells->vertices + place * corners, *neighbors = cells->neighbors + place * corners;
    paradt_index *new_vertices = to->vertices + place * corners, *numbers = to->neighbors + place * corners, any = 0;
    size_t j;
    paradt__fetch_row(cells->vertices, cells->neighbors, place + PARADT__ROWS_AHEAD, corners);
#if PARADT__FOUR_AT_ONCE
    if (corners == 4) {
        __m128i handles = _mm_loadu_si128((const __m128i *)(const void *)neighbors), open = _mm_srai_epi32(handles, 31);
        __m128i number = _mm_add_epi32(_mm_srli_epi32(handles, 2), _mm_set1_epi32(to->offset));
        any = -_mm_movemask_ps(_mm_castsi128_ps(handles));
        handles = _mm_or_si128(_mm_and_si128(open, handles), _mm_andnot_si128(open, number));
        _mm_storeu_si128((__m128i *)(void *)numbers, handles);
    } else
#endif
        for (j = 0; j < corners; j++) {
            paradt_index handle = neighbors[j];
            any |= handle;
            numbers[j] = handle < 0 ? handle : (paradt_index)((paradt__tag)handle / (paradt__tag)corners) + to->offset;
        }
    for (j = 0; origin && j < corners; j++) new_vertices[j] = origin[vertices[j]];
    return any < 0;
}

// Drops the ghosts, closes the gaps from the end, numbers the neighbours and translates the vertices. All at once: the
// cells don't fit into a cache. Returns the ghosts' number.
PARADT__INLINE uint64_t paradt__bw_close_cells(paradt__bw *bw, const paradt_index *origin, size_t corners) {
    const paradt__cells cells = bw->cells; // a copy, which nothing that is written can change
    const paradt__rows to = paradt__rows_in_place(&cells);
    size_t end = cells.count, i;
    uint64_t ghosts = 0;
    paradt__bw_mark_free(bw);
    for (i = 0; i < end; i++) {
        if (!paradt__bw_keep(&cells, i, corners, &ghosts)) {
            for (end--; end > i && !paradt__bw_keep(&cells, end, corners, &ghosts);) end--;
            if (end == i) break;
            paradt__bw_move(&cells, i, end, corners, i);
        }
        paradt__bw_number(&cells, i, corners, origin, &to);
    }
    bw->cells.count = end;
    return ghosts;
}

static uint64_t paradt__bw_close(paradt__bw *bw, const paradt_index *origin) {
    if (bw->cells.corners == 4) return paradt__bw_close_cells(bw, origin, 4);
    return paradt__bw_close_cells(bw, origin, (size_t)bw->cells.corners);
}

// --- the door

// Points that span the set come first in the order.
static void paradt__bw_span_first(const paradt__set *set, paradt_index *order, paradt__counters *counters) {
    const double *basis[PARADT_MAX_DIM + 1];
    int axes[PARADT_MAX_DIM + 1], i, dim = set->space.dim;
    paradt__set view = *set;
    view.space.ambient = dim; // only the axes that orient
    basis[0] = paradt__record(set, order[0]);
    paradt__span(&view, order, basis, axes, 0, 0);
    *counters = view.space.counters;
    for (i = 0; i <= dim; i++) {
        paradt_index point = (paradt_index)((size_t)(basis[i] - set->records) / set->width);
        size_t at = (size_t)i;
        while (order[at] != point) at++;
        order[at] = order[i];
        order[i] = point;
    }
}

typedef paradt_status (*paradt__inserter)(paradt__bw *bw, paradt_index point);

static paradt__inserter paradt__choose_inserter(const paradt__bw *bw) {
    if (!bw->spheres) return paradt__bw_insert;
#if PARADT__BW_AVX2
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return paradt__bw3_insert_avx2;
#endif
    return paradt__bw3_insert;
}

// Inserts the points that are left, in their order, until it pauses.
static paradt_status paradt__bw_insert_rest(paradt__bw *bw, const paradt__progress *progress) {
    paradt__inserter insert = paradt__choose_inserter(bw);
    paradt_status status = PARADT_OK;
    size_t i;
    for (i = bw->inserted; i < bw->count && !status; i++) {
        if (i % 1024 == 0 && paradt__progress_cancels(progress, (double)i / (double)bw->count))
            return PARADT_ERROR_CANCELLED;
        status = insert(bw, paradt__bw_point(bw, i));
        bw->inserted = i + 1;
        if (paradt__relay_pauses(bw->relay, bw->inserted, 64)) break;
    }
    return status;
}

static paradt_status paradt__bw_build(paradt__bw *bw, const paradt__progress *progress) {
    paradt_status status = paradt__bw_list(bw, &bw->cavity, 0, &bw->cavity_capacity, PARADT__FIRST_DIG);
    if (bw->cells.lent) {
        paradt__make_pages(bw->marks, 0, bw->cells.capacity);
        memset(bw->marks, 0, bw->cells.capacity);
    }
    if (!status && bw->cells.corners <= 4)
        status = paradt__bw_reserve(bw, 1, paradt__bw_places(paradt__bw_first_points(bw), bw->cells.corners - 1));
    if (!status) status = paradt__bw_first(bw);
    bw->inserted = (size_t)bw->cells.corners;
    if (!status && bw->cells.corners == 4) status = paradt__bw3_begin(bw);
    return status ? status : paradt__bw_insert_rest(bw, progress);
}

// Makes ready to go on with more points, which have been counted. first: the next; numbers: of points that there are;
// cell: where to begin the search for the first; negative: the last one made.
static paradt_status paradt__bw_go_on(paradt__bw *bw, paradt_index first, size_t numbers, paradt_index cell) {
    paradt__spheres3 *s = bw->spheres;
    if (cell < 0) cell = s ? s->start : bw->last;
    bw->last = cell;
    if (!s) return PARADT_OK;
    if (numbers >= s->numbers && !paradt__bw3_more_numbers(bw, numbers + numbers / 8 + 64)) return PARADT_ERROR_MEMORY;
    s->start = cell;
    s->next = paradt__seen3_of(s, paradt__bw_record(bw, first));
    return PARADT_OK;
}

// Fetches what the insertion of a point in conflict with the cell looks at, up to three facets away, all at once: where
// nothing of that is in a cache, the insertion would wait for one after another.
PARADT__INLINE void paradt__bw3_fetch_around(const paradt__bw *bw, paradt_index cell) {
    enum { CELLS = 1 + 4 + 12 };
    const paradt__spheres3 *s = bw->spheres;
    paradt_index around[CELLS];
    size_t count = 1, i, j;
    around[0] = cell;
    for (i = 0; i < count; i++) {
        const paradt_index *vertices = bw->cells.vertices + 4 * (size_t)around[i];
        const paradt_index *neighbors = bw->cells.neighbors + 4 * (size_t)around[i];
        for (j = 0; j < 4; j++) {
            paradt_index other = neighbors[j] >> 2;
            paradt__fetch_row(bw->cells.vertices, bw->cells.neighbors, (size_t)other, 4);
            PARADT__PREFETCH(s->table + ((paradt__tag)other & s->mask));
            if (vertices[j] >= 0) PARADT__PREFETCH(paradt__bw_record(bw, vertices[j]));
            if (count < CELLS) around[count++] = other;
        }
    }
}

// The first place from `place` on of a ghost, or of a cell with a vertex that is none of the first `own` points; behind
// all places if there is none. Free places are marked.
PARADT__INLINE size_t paradt__bw_fringe_from(const paradt__cells *cells, size_t corners, paradt_index own,
                                             size_t place) {
    for (; place < cells->count; place++) {
        const paradt_index *vertices = cells->vertices + place * corners;
        PARADT__FETCH(vertices, 4 * PARADT__ROWS_AHEAD * corners);
        if (PARADT__LIKELY(paradt__vertices_among(vertices, (int)corners, 0, own))) continue;
        if (vertices[0] != PARADT__DEAD) break;
    }
    return place;
}

// Inserts a point that has just been counted. cell: in conflict with the point; or negative: one is walked to, by
// orientations, for the spheres on the way are in no table.
static paradt_status paradt__bw_insert_one_more(paradt__bw *bw, paradt_index point, paradt_index cell) {
    paradt_status status;
    if (bw->spheres && cell < 0) cell = paradt__bw_walk(bw, bw->spheres->start, paradt__bw_record(bw, point));
    status = paradt__bw_go_on(bw, point, (size_t)point + 1, cell);
    bw->order = NULL;
    bw->inserted = bw->count - 1;
    if (bw->spheres) {
        bw->spheres->missed = 0; // such points are here and there: no larger table would have their spheres
        paradt__bw3_fetch_around(bw, cell);
    }
    return status ? status : paradt__choose_inserter(bw)(bw, point);
}

// The i-th of the cells that the last insertion made, of bw->rim_count.
PARADT__INLINE paradt_index paradt__bw_made(const paradt__bw *bw, size_t i) {
    const paradt__spheres3 *s = bw->spheres;
    if (s && (bw->rim_count <= PARADT__WIDE_STAR || bw->rim_count <= s->large_star)) return bw->cavity[i] >> 2;
    return paradt__bw_cell(bw, bw->rim[i]);
}

// Takes records as those of the set are.
static void paradt__bw_layout(paradt__bw *bw, const paradt__set *set) {
    bw->width = set->width;
    bw->graded = set->grade == PARADT__SAGITTA;
    bw->grade_limit = set->grade_limit;
    bw->grade_error = set->grade_error;
}

// Before paradt__bw_build. The order has the points that span the set first then.
static void paradt__bw_begin(paradt__bw *bw, const paradt__set *set, paradt_index *order, paradt__memory *memory) {
    memset(bw, 0, sizeof *bw);
    bw->space = set->space;
    paradt__bw_span_first(set, order, &bw->space.counters);
    bw->cells.corners = set->space.dim + 1;
    bw->memory = memory;
    bw->records = set->records;
    bw->order = order;
    paradt__bw_layout(bw, set);
    bw->count = set->count;
}

// The cells of the set, whose points are along a curve, with the caller's indices. adjacency: whether their neighbours
// are wanted.
static paradt_status paradt__bowyer_watson(const paradt__set *set, paradt__memory *memory, paradt__cells *cells,
                                           int adjacency, const paradt__progress *progress, paradt__counters *counters,
                                           uint64_t *hull_facets) {
    paradt__bw bw;
    paradt_index *order = paradt__round_order(set->count, memory);
    paradt_status status;
    if (!order) return PARADT_ERROR_MEMORY;
    paradt__bw_begin(&bw, set, order, memory);
    status = paradt__bw_build(&bw, progress);
    *counters = bw.space.counters;
    if (!status) *hull_facets = paradt__bw_close(&bw, set->origin);
    paradt__bw_end(&bw);
    paradt__release(memory, order);
    *cells = bw.cells;
    if (!adjacency) {
        paradt__release(memory, cells->neighbors);
        cells->neighbors = NULL;
    }
    if (status) paradt__cells_free(cells, memory);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>regions
//
// Each box of space is a region. A cell belongs to the box with most of its vertices, as told in >>incode; by insertion
// to the last box that holds any. Each region is built alone and keeps the cells it owns; the facets between cells of
// different regions are matched when all have ended. Doors: paradt__regions_assign, paradt__regions_deal,
// paradt__region_compact, paradt__regions_join.

// Fills owner[set->count] with the region of each point.
static void paradt__regions_assign(const paradt__set *set, const paradt__cuts *cuts, uint32_t *owner) {
    size_t i;
    for (i = 0; i < set->count; i++) owner[i] = (uint32_t)paradt__cuts_find(cuts, paradt__record(set, (paradt_index)i));
}

// Puts the points that were in the order of the boxes into that order again, where a grid has changed it: those from
// `begin` on, of the boxes from `first` on.
static void paradt__regions_deal(paradt__set *set, const paradt__cuts *cuts, size_t begin, size_t end, size_t first,
                                 size_t boxes) {
    const paradt__cut *cut = cuts->cut + first + boxes / 2;
    size_t i, lower;
    if (boxes == 1) return;
    for (i = begin, lower = cut->begin; i < cut->begin; i++) {
        if (!paradt__cut_is_above(cut, paradt__record(set, (paradt_index)i))) continue;
        while (paradt__cut_is_above(cut, paradt__record(set, (paradt_index)lower))) lower++;
        paradt__exchange(set, set->width, i, lower++);
    }
    paradt__regions_deal(set, cuts, begin, cut->begin, first, boxes / 2);
    paradt__regions_deal(set, cuts, cut->begin, end, first + boxes / 2, boxes - boxes / 2);
}

// Gives the cluster of a cell that nobody reaches to its owner, see >>incode. owners: [cells->count], PARADT__OPEN for
// such cells; cluster: room for all of them.
static void paradt__cluster_give(const paradt__cells *cells, const uint32_t *owner, paradt_index *owners,
                                 paradt_index *cluster, paradt_index first) {
    enum { MET = -3 };
    paradt_index beside = PARADT__NOWHERE, within = PARADT__NOWHERE, corners = cells->corners, i, j, count = 1;
    cluster[0] = first;
    owners[first] = MET;
    for (i = 0; i < count; i++) {
        for (j = cluster[i] * corners; j < (cluster[i] + 1) * corners; j++) {
            paradt_index neighbor = cells->neighbors[j], region = (paradt_index)owner[cells->vertices[j]];
            if (region < within) within = region;
            if (neighbor < 0) continue;
            if (owners[neighbor] == PARADT__OPEN) owners[neighbor] = MET, cluster[count++] = neighbor;
            else if (owners[neighbor] != MET && owners[neighbor] < beside) beside = owners[neighbor];
        }
    }
    for (i = 0; i < count; i++) owners[cluster[i]] = beside < PARADT__NOWHERE ? beside : within;
}

// Fills owners[cells->count].
static paradt_status paradt__cells_find_owners(const paradt__cells *cells, const paradt__set *set,
                                               const paradt__region_view *view, paradt__memory *memory,
                                               paradt_index *owners) {
    size_t corners = (size_t)cells->corners, unreached = 0, i;
    paradt_index *cluster;
    for (i = 0; i < cells->count; i++) {
        owners[i] = paradt__cell_owner(view, set, cells->vertices + i * corners, cells->corners);
        unreached += owners[i] < 0;
    }
    if (!unreached) return PARADT_OK;
    cluster = (paradt_index *)paradt__alloc(memory, unreached, sizeof *cluster);
    if (!cluster) return PARADT_ERROR_MEMORY;
    for (i = 0; i < cells->count; i++) {
        if (owners[i] < 0) paradt__cluster_give(cells, view->owner, owners, cluster, (paradt_index)i);
    }
    paradt__release(memory, cluster);
    return PARADT_OK;
}

// Leaves only the cells that the region owns; their neighbours in other regions become open. *foreign: cells dropped.
static paradt_status paradt__region_compact(paradt__cells *cells, const paradt__set *set,
                                            const paradt__region_view *view, paradt__memory *memory,
                                            uint64_t *foreign) {
    size_t corners = (size_t)cells->corners, i, kept = 0;
    paradt_index *place = (paradt_index *)paradt__alloc(memory, cells->count, sizeof *place);
    paradt_status status = place ? paradt__cells_find_owners(cells, set, view, memory, place) : PARADT_ERROR_MEMORY;
    if (status) {
        paradt__release(memory, place);
        return status;
    }
    for (i = 0; i < cells->count; i++) {
        int owned = place[i] == (paradt_index)view->region;
        place[i] = owned ? (paradt_index)kept++ : (paradt_index)PARADT__OPEN;
    }
    for (i = 0; i < cells->count; i++) {
        paradt_index *to;
        size_t j;
        if (place[i] < 0) continue;
        memmove(cells->vertices + (size_t)place[i] * corners, cells->vertices + i * corners, corners * sizeof *to);
        to = cells->neighbors + (size_t)place[i] * corners;
        for (j = 0; j < corners; j++) {
            paradt_index neighbor = cells->neighbors[i * corners + j];
            to[j] = neighbor < 0 ? neighbor : place[neighbor];
        }
    }
    *foreign = cells->count - kept;
    cells->count = kept;
    paradt__release(memory, place);
    return PARADT_OK;
}

// Appends the cells of a region.
static void paradt__cells_append(paradt__cells *all, const paradt__cells *part) {
    size_t corners = (size_t)all->corners, offset = all->count, i;
    paradt_index *to = all->neighbors + offset * corners;
    if (!part->count) return;
    memcpy(all->vertices + offset * corners, part->vertices, part->count * corners * sizeof *to);
    for (i = 0; i < part->count * corners; i++) {
        to[i] = part->neighbors[i] < 0 ? part->neighbors[i] : part->neighbors[i] + (paradt_index)offset;
    }
    all->count += part->count;
}

enum { PARADT__JOINED = 8 }; // facets at once: there is room for those of a cell

// Links open facets to their twins, if these were seen before. Each step waits for memory, for all of them together.
static paradt_status paradt__join_facets(paradt__active *active, paradt__cells *all, const paradt_index *handles,
                                         size_t count, paradt__memory *memory) {
    paradt_index corners = all->corners, *chain[PARADT__JOINED], smallest[PARADT__JOINED];
    uint32_t key[PARADT__JOINED];
    paradt_status status = paradt__active_room(active, memory);
    size_t i;
    for (i = 0; i < count && !status; i++) {
        int opposite = (int)(handles[i] % corners);
        const paradt_index *cell = all->vertices + (handles[i] - opposite);
        key[i] = paradt__facet_key(paradt__cell_sum(cell, all->corners) - paradt__vertex_key(cell[opposite]));
        smallest[i] = paradt__smallest_but(cell, all->corners, opposite);
        chain[i] = paradt__active_chain(active, smallest[i], key[i]);
        PARADT__PREFETCH(chain[i]);
    }
    for (i = 0; i < count && !status; i++) {
        if (*chain[i] >= 0) PARADT__PREFETCH(active->links + *chain[i]);
    }
    for (i = 0; i < count && !status; i++) {
        if (*chain[i] < 0) continue;
        PARADT__PREFETCH(all->vertices + active->links[*chain[i]].handle);
        PARADT__PREFETCH(all->neighbors + active->links[*chain[i]].handle);
    }
    for (i = 0; i < count && !status; i++) {
        paradt_index twin = paradt__active_match(active, all, chain[i], smallest[i], key[i], handles[i], all->corners);
        if (twin < 0) continue;
        all->neighbors[handles[i]] = twin / corners;
        all->neighbors[twin] = handles[i] / corners;
    }
    return status;
}

// Links the open facets of all regions to each other. What finds no partner is the hull.
static paradt_status paradt__regions_join(paradt__cells *all, paradt__memory *memory, uint64_t *hull_facets) {
    paradt__active active;
    size_t facets = all->count * (size_t)all->corners, count = 0, i;
    paradt_index open[PARADT__JOINED];
    paradt_status status = paradt__active_begin(&active, 0, memory);
    for (i = 0; i < facets && !status; i++) {
        if (all->neighbors[i] == PARADT__OPEN) open[count++] = (paradt_index)i;
        if (count < PARADT__JOINED && i + 1 < facets) continue;
        status = paradt__join_facets(&active, all, open, count, memory);
        count = 0;
    }
    for (i = 0; i < facets; i++) {
        if (all->neighbors[i] == PARADT__OPEN) all->neighbors[i] = PARADT__HULL;
        *hull_facets += all->neighbors[i] == PARADT__HULL;
    }
    paradt__active_free(&active, memory);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>patches
//
// A region by insertion. A cell or ghost is owned by the last region that has a vertex of it. The region inserts its
// own points and those of the others in a margin around its box, and then asks for every cell that could be wrong
// whether a point that it has not got is in conflict with the cell. Such a point is inserted, until the answers are no.
// The answers are exact, so nothing depends on the width of the margin.
//
// Which cells could be wrong? Let K be the box with its margin (or the box alone, where there is none), S the points
// inserted, q a point that is missing. K is convex, and S has all points in it, so q is outside K. The cells of T(S) in
// conflict with q are connected through facets, and one of them contains q (or, q being outside of the hull, is a ghost
// that q is strictly beyond): a ghost, or a cell with a vertex outside K. Let such a path lead there from a cell with a
// vertex of the region. If all cells on the path have one, so has the last. Else there is a first one that has none,
// and the facet through which it is reached is of a cell with just one. So where none of these cells with vertices of
// the region is in conflict with a point that is missing, none at all is:
//
//     ghosts; cells with a vertex that may be outside K; cells with just one vertex of the region
//
// Then the region's vertices have all their cells of T(P), and those without a vertex of a later region are its own.
// Of the cells without a vertex of the region it does not matter whether they are right. Nor need those be asked about
// whose sphere is inside K, or, near a sphere, of ghosts the cap that their facet cuts off.
//
// The first region owns the cells with its points alone. It inserts no others' and asks about nothing: it keeps those
// cells that the others' list of the seam leaves it (see there).
//
// Near a sphere the questions are asked with sagittas, as in >>search.
//
// Where these points don't span the set, others that do are inserted too: a region may have flat sets of points, or
// none.
// A region takes time and memory for its own points and the seam: it reads others' points through their grids, and what
// they tell of their neighbours.
// Doors: paradt__field_begin, paradt__patch_begin, paradt__patch_points, paradt__patch_build, paradt__patch_complete,
// paradt__patch_show, paradt__patch_hear_all, paradt__patch_list_seam, paradt__patch_has_cells, paradt__patch_judge,
// paradt__patch_compact, paradt__patch_emit, paradt__patch_take_all, paradt__patch_end.

// The points of one region, as it and the others see them: positions [begin, begin + set.count) of the whole set, along
// a curve, under a grid. Behind them, up to begin + room, there is place for others' points that only the region sees.
typedef struct paradt__field {
    paradt__set set; // owns nothing
    paradt__grid grid;
    size_t begin, room;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM]; // the region's box, unbounded at +-PARADT__FAR
    const struct paradt__patch *patch;                // what the region has built, where others may look at it; or NULL
    paradt_index *seam; // [seam_count][dim + 1] the seam: vertices of a facet and apex, as positions in the set
    size_t seam_count;
    int has_cells; // some cell or ghost of T(P) has a vertex of the region
} paradt__field;

// What is known of a cell: marks of it
enum {
    PARADT__WAITING = 2, // it is in the list of cells to be asked about, or of wrong ones
    PARADT__ASKED = 4,   // it is one of T(P)
    PARADT__LISTED = 8,  // it is in the list of the fringe; not in all regions
    PARADT__DROPPED = 16 // it is not kept in the end; of ranks alone
};

typedef struct paradt__patch {
    const paradt__set *set;
    paradt__set everyone;        // the same without a bound on positions: fields have gaps between them
    const paradt__field *fields; // [field_count]
    size_t field_count, own;     // own: the region's number
    paradt__search search;       // for the questions: aimed at a cell, it is turned to the fields one by one
    paradt__memory *memory;
    paradt__bw bw;
    size_t capacity;                 // points that the arrays below have room for
    double *records;                 // [capacity][bw.width]
    int lent;                        // these are those of the field
    paradt_index *others;            // [capacity - own points] positions of others' points in the set
    paradt_index *origin;            // at the end, the caller's indices of all points:
    paradt_index *table;             // in this, or, if it is NULL, in the field's part of set.origin
    double room[2 * PARADT_MAX_DIM]; // K: low and high of each axis
    size_t outer;                    // vertices from this one on may be outside of K
    int roomy;                       // there is a margin: all points in K are in the set, with those on its border
    paradt_index *list; // [list_capacity] cells waiting, or wrong; at the end, facets behind which others go on
    size_t list_count, list_capacity;
    // [fringe_capacity] places of all cells and ghosts that have not only vertices of the region; some more than once,
    // and some where such ones have been
    paradt_index *fringe;
    size_t fringe_count, fringe_capacity;
    int asks;             // 1: the points that it begins with are inserted
    size_t asked;         // so many of the list have been taken from it
    size_t dropped;       // cells and ghosts, at the end
    int trusts;           // it is the first region, has its own points alone, and asks about nothing
    paradt_index *border; // [border_capacity] cells that were on the seam when they were asked about
    size_t border_count, border_capacity;
    paradt_index *seam; // [seam_capacity] see paradt__field
    size_t seam_count, seam_capacity;
    paradt_index *order;  // of the insertion of the first points
    paradt_index *around; // [own points] one of the cells around each, for others to look at; or NULL
    paradt_index *late;   // [late_capacity] cells waiting for what is not told yet
    size_t late_count, late_capacity;
    paradt_index *told; // [told_capacity] for the first told_count of others' points where their neighbours end
    size_t told_count, told_capacity;
    paradt_index *nearby; // [nearby_capacity] these neighbours, as positions in the set; none where there are too many
    size_t nearby_count, nearby_capacity;
    uint64_t looked;      // groups of neighbours
    size_t late_cells;    // made by answers
    size_t made;          // cells of the triangulation, of which bw.cells are owned in the end
    uint64_t hull_facets; // of the hull of T(P), whose ghosts the region owns
} paradt__patch;

// A field of `count` points of the set, without a grid.
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

// --- points

// Room for `capacity` points. Others read what the field lent, so that stays as it is.
static paradt_status paradt__patch_reserve(paradt__patch *patch, size_t capacity) {
    size_t used = patch->bw.count, width = patch->bw.width, own = patch->fields[patch->own].set.count;
    void *records = patch->lent ? NULL : patch->records, *others = patch->others;
    if (!paradt__grow(patch->memory, &records, patch->lent ? 0 : used * width, capacity * width, sizeof(double)))
        return PARADT_ERROR_MEMORY;
    if (patch->lent) memcpy(records, patch->records, used * width * sizeof(double));
    patch->lent = 0;
    patch->records = (double *)records;
    patch->bw.records = patch->records;
    used = used > own ? used - own : 0;
    if (!paradt__grow(patch->memory, &others, used, capacity - own, sizeof *patch->others)) return PARADT_ERROR_MEMORY;
    patch->others = (paradt_index *)others;
    patch->capacity = capacity;
    return PARADT_OK;
}

// Begins with the region's own points, in the field: the insertion uses its records.
static paradt_status paradt__patch_lend(paradt__patch *patch) {
    const paradt__field *own = patch->fields + patch->own;
    patch->others = (paradt_index *)paradt__alloc(patch->memory, own->room - own->set.count, sizeof *patch->others);
    if (!patch->others) return PARADT_ERROR_MEMORY;
    patch->records = own->set.records;
    patch->bw.records = patch->records;
    patch->capacity = own->room;
    patch->lent = 1;
    return PARADT_OK;
}

static paradt_status paradt__patch_add(paradt__patch *patch, size_t position) {
    size_t at = patch->bw.count, width = patch->bw.width;
    paradt_status status = at < patch->capacity ? PARADT_OK : paradt__patch_reserve(patch, at + at / 8 + 256);
    if (status) return status;
    paradt__copy_record(patch->records + at * width, patch->set->records + position * patch->set->width, width);
    patch->others[at - patch->fields[patch->own].set.count] = (paradt_index)position;
    patch->bw.count++;
    return PARADT_OK;
}

// Adds the region's own points, for which there is room.
static void paradt__patch_add_own(paradt__patch *patch) {
    const paradt__field *own = patch->fields + patch->own;
    size_t width = patch->bw.width, i;
    for (i = 0; i < own->set.count && !patch->lent; i++)
        paradt__copy_record(patch->records + i * width, own->set.records + i * own->set.width, width);
    patch->bw.count = own->set.count;
}

// The position of a vertex in the set
PARADT__INLINE paradt_index paradt__patch_position(const paradt__patch *patch, paradt_index vertex) {
    const paradt__field *own = patch->fields + patch->own;
    if ((size_t)vertex < own->set.count) return (paradt_index)own->begin + vertex;
    return patch->others[(size_t)vertex - own->set.count];
}

// Makes patch->origin: the caller's indices, or -1 for positions from `end` on.
static paradt_status paradt__patch_translate(paradt__patch *patch, paradt_index end) {
    const paradt__field *own = patch->fields + patch->own;
    size_t count = own->set.count, i;
    patch->origin = patch->set->origin + own->begin;
    if (patch->bw.count > own->room) {
        patch->table = (paradt_index *)paradt__alloc(patch->memory, patch->bw.count, sizeof *patch->table);
        if (!patch->table) return PARADT_ERROR_MEMORY;
        memcpy(patch->table, patch->origin, count * sizeof *patch->table);
        patch->origin = patch->table;
    }
    for (i = count; i < patch->bw.count; i++) {
        paradt_index position = patch->others[i - count];
        patch->origin[i] = position < end ? patch->set->origin[position] : -1;
    }
    return PARADT_OK;
}

// Is the point in K?
static int paradt__within(const double *x, const double *low, const double *high, int dim) {
    int axis;
    for (axis = 0; axis < dim; axis++) {
        if (x[axis] < low[axis] || x[axis] > high[axis]) return 0;
    }
    return 1;
}

static paradt_status paradt__patch_append(paradt__patch *patch, paradt_index **list, size_t *count, size_t *capacity,
                                          paradt_index item) {
    paradt_status status = paradt__bw_list(&patch->bw, list, *count, capacity, *count + 1);
    if (!status) (*list)[(*count)++] = item;
    return status;
}

// Appends to one of the patch's lists.
#define PARADT__PATCH_LIST(patch, which, item)                                                                         \
    paradt__patch_append(patch, &(patch)->which, &(patch)->which##_count, &(patch)->which##_capacity, item)

// Lists the points of a field's box that are in K.
static paradt_status paradt__patch_gather(paradt__patch *patch, const paradt__field *field, int level, size_t box,
                                          const double *low, const double *high) {
    int dim = patch->set->space.dim, axis;
    size_t first = box * PARADT__LANES, i;
    const double *bounds =
        field->grid.boxes[level] + box / PARADT__LANES * field->grid.group_width + box % PARADT__LANES;
    paradt_status status = PARADT_OK;
    for (axis = 0; axis < dim; axis++, bounds += 2 * PARADT__LANES) {
        if (bounds[0] > high[axis] || bounds[PARADT__LANES] < low[axis]) return PARADT_OK;
    }
    for (i = first; i < first + PARADT__LANES && !status; i++) {
        if (level) {
            if (i >= field->grid.box_count[level - 1]) break;
            status = paradt__patch_gather(patch, field, level - 1, i, low, high);
        } else if (i < field->set.count && paradt__within(field->set.records + i * field->set.width, low, high, dim)) {
            status = PARADT__PATCH_LIST(patch, list, (paradt_index)(field->begin + i));
        }
    }
    return status;
}

// The margin: about one and a half distances between neighbours. Where differences of coordinates may overflow there is
// none, nor where the box is cut across an axis that is not among those that orient.
static double paradt__margin(const paradt__field *field) {
    const paradt__set *set = &field->set;
    int axis, open = 1;
    for (axis = set->space.dim; axis < set->space.ambient; axis++)
        open &= field->low[axis] == -PARADT__FAR && field->high[axis] == PARADT__FAR;
    if (!set->space.filtered || !open) return 0.0;
    return 0.7 * paradt__spacing(set->records, set->width, set->space.dim, NULL, set->count);
}

// Lists the points of the others in the margin, which K has then.
static paradt_status paradt__patch_find_margin(paradt__patch *patch) {
    const paradt__field *own = patch->fields + patch->own;
    double margin = paradt__margin(own), low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    paradt_status status = PARADT_OK;
    size_t i;
    int axis;
    for (axis = 0; axis < patch->set->space.dim; axis++) {
        patch->room[2 * axis] = low[axis] = own->low[axis] - margin;
        patch->room[2 * axis + 1] = high[axis] = own->high[axis] + margin;
    }
    patch->roomy = margin > 0.0;
    for (i = 0; i < patch->field_count && patch->roomy && !status; i++) {
        const paradt__field *field = patch->fields + i;
        int level = field->grid.levels - 1;
        size_t box;
        for (box = 0; i != patch->own && level >= 0 && box < field->grid.box_count[level] && !status; box++) {
            status = paradt__patch_gather(patch, field, level, box, low, high);
        }
    }
    return status;
}

// The points that the patch has so far, as a set
static paradt__set paradt__patch_known(const paradt__patch *patch) {
    paradt__set known = *patch->set;
    known.records = patch->records;
    known.width = patch->bw.width;
    known.count = patch->bw.count;
    memset(&known.space.counters, 0, sizeof known.space.counters);
    return known;
}

// Does a set of points span the space?
static int paradt__spans(const paradt__set *set) {
    paradt__set view = *set;
    const double *points[PARADT_MAX_DIM + 1];
    int axes[PARADT_MAX_DIM + 1], dim = view.space.dim;
    if (view.count <= (size_t)dim) return 0;
    points[0] = view.records;
    view.space.ambient = dim; // only the axes that orient
    return paradt__span(&view, NULL, points, axes, 0, 0) == dim;
}

// Adds those of `whole`, which span the set, that the patch has not got, if its own points don't span. Only then:
// points far away give the hull cells so large that their spheres can't be told without exact arithmetic.
static paradt_status paradt__patch_add_span(paradt__patch *patch, const paradt_index *whole) {
    paradt__set known = paradt__patch_known(patch);
    int i;
    size_t j;
    paradt_status status = PARADT_OK;
    patch->outer = patch->roomy ? known.count : patch->fields[patch->own].set.count;
    if (paradt__spans(&known)) return PARADT_OK;
    for (i = 0; i <= known.space.dim && !status; i++) {
        for (j = 0; j < known.count && paradt__patch_position(patch, (paradt_index)j) != whole[i];) j++;
        if (j == known.count) status = paradt__patch_add(patch, (size_t)whole[i]);
    }
    return status;
}

// The order of insertion: points in the margin along with the region's
static paradt_status paradt__patch_sort(paradt__patch *patch) {
    const paradt__field *own = patch->fields + patch->own;
    paradt__set known = paradt__patch_known(patch);
    paradt__curve curve;
    int64_t low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    int axis;
    curve.low = patch->set->space.low;
    curve.high = patch->set->space.high;
    curve.along = patch->set->count;
    for (axis = 0; axis < patch->set->space.ambient; axis++) {
        low[axis] = paradt__ordered_bits(own->low[axis]);
        high[axis] = paradt__ordered_bits(own->high[axis]);
    }
    patch->order = paradt__merged_order(&known, own->set.count, &curve, low, high, patch->memory);
    if (!patch->order) return PARADT_ERROR_MEMORY;
    patch->bw.order = patch->order;
    paradt__bw_span_first(&known, patch->order, &patch->bw.space.counters);
    return PARADT_OK;
}

// The points to begin with. Vertices are the region's first, in their order, then those in the margin. The region that
// has no margin sorts its points at once, while the others look for theirs; these do it when they build.
static paradt_status paradt__patch_points(paradt__patch *patch, const paradt_index *whole) {
    const paradt__field *own = patch->fields + patch->own;
    size_t needed, i;
    paradt_status status;
    status = patch->trusts ? PARADT_OK : paradt__patch_find_margin(patch);
    if (!status) status = paradt__patch_lend(patch);
    needed = own->set.count + (patch->trusts ? 0 : patch->list_count + (size_t)patch->set->space.dim + 1);
    if (!status && patch->capacity < needed) status = paradt__patch_reserve(patch, needed + needed / 64 + 256);
    if (status) return status;
    paradt__patch_add_own(patch);
    for (i = 0; i < patch->list_count && !status; i++) status = paradt__patch_add(patch, (size_t)patch->list[i]);
    patch->list_count = 0;
    if (!status) status = paradt__patch_add_span(patch, whole);
    return status || !patch->trusts ? status : paradt__patch_sort(patch);
}

// --- cells

PARADT__INLINE const paradt_index *paradt__patch_cell(const paradt__patch *patch, paradt_index cell) {
    return patch->bw.cells.vertices + (size_t)cell * (size_t)patch->bw.cells.corners;
}

// Is the vertex a point of the region? These are the first.
PARADT__INLINE int paradt__patch_has(const paradt__patch *patch, paradt_index vertex) {
    return (size_t)vertex < patch->fields[patch->own].set.count;
}

// How many vertices of the cell are the region's? If none, the cell does not matter to it.
static int paradt__patch_share(const paradt__patch *patch, paradt_index cell) {
    paradt_index own = (paradt_index)patch->fields[patch->own].set.count;
    return paradt__vertices_below(paradt__patch_cell(patch, cell), (size_t)patch->bw.cells.corners, own);
}

// Does the region own a cell or ghost that has a vertex of it? Once patch->origin has the caller's indices, or -1.
static int paradt__patch_owns(const paradt__patch *patch, paradt_index cell) {
    const paradt_index *vertices = paradt__patch_cell(patch, cell);
    int i;
    for (i = 0; i < patch->bw.cells.corners; i++) {
        if (vertices[i] >= 0 && patch->origin[vertices[i]] < 0) return 0;
    }
    return 1;
}

// Has a cell or ghost one vertex of the region, and else the first region's?
static int paradt__patch_on_seam(const paradt__patch *patch, paradt_index cell) {
    const paradt_index *vertices = paradt__patch_cell(patch, cell);
    paradt_index end = (paradt_index)patch->fields[0].set.count;
    int i, share = 0;
    for (i = 0; i < patch->bw.cells.corners; i++) {
        if (vertices[i] < 0) continue;
        if (paradt__patch_has(patch, vertices[i])) share++;
        else if (paradt__patch_position(patch, vertices[i]) >= end) return 0;
    }
    return share == 1 && patch->own > 0;
}

// Puts a cell into the list of those to be asked about, if nothing is known of it.
static paradt_status paradt__patch_wait(paradt__patch *patch, paradt_index cell) {
    if (patch->bw.marks[cell] & (PARADT__WAITING | PARADT__ASKED)) return PARADT_OK;
    patch->bw.marks[cell] |= PARADT__WAITING;
    return PARADT__PATCH_LIST(patch, list, cell);
}

// Could a cell or ghost be wrong that has not only vertices of the region?
static int paradt__patch_is_suspect(const paradt__patch *patch, const paradt_index *vertices) {
    int share = 0, outer = 0, i;
    for (i = 0; i < patch->bw.cells.corners; i++) {
        share += vertices[i] >= 0 && paradt__patch_has(patch, vertices[i]);
        outer |= vertices[i] < 0 || (size_t)vertices[i] >= patch->outer;
    }
    return share == 1 || (share && outer);
}

// Lists the fringe, and of it the cells that could be wrong.
PARADT__INLINE paradt_status paradt__patch_list_suspects(paradt__patch *patch, size_t corners) {
    const paradt__cells *cells = &patch->bw.cells;
    paradt_index own = (paradt_index)patch->fields[patch->own].set.count;
    size_t cell = paradt__bw_fringe_from(cells, corners, own, 0);
    paradt_status status = PARADT_OK;
    for (; cell < cells->count && !status; cell = paradt__bw_fringe_from(cells, corners, own, cell + 1)) {
        status = PARADT__PATCH_LIST(patch, fringe, (paradt_index)cell);
        if (!status && paradt__patch_is_suspect(patch, cells->vertices + cell * corners))
            status = paradt__patch_wait(patch, (paradt_index)cell);
    }
    return status;
}

// To look for them takes as long as the insertion of a few points, in which the other regions go on.
static paradt_status paradt__patch_suspects(paradt__patch *patch) {
    enum { CELLS_A_POINT = 400 };
    paradt__relay_waits(patch->bw.relay, patch->bw.cells.count / CELLS_A_POINT);
    paradt__bw_mark_free(&patch->bw);
    if (patch->bw.cells.corners == 4) return paradt__patch_list_suspects(patch, 4);
    return paradt__patch_list_suspects(patch, (size_t)patch->bw.cells.corners);
}

// Aims the search at a cell: at the points in its sphere, or, for a ghost, strictly beyond its facet.
static void paradt__patch_aim(paradt__patch *patch, paradt_index cell, int ghost) {
    const paradt__bw *bw = &patch->bw;
    const paradt_index *vertices = paradt__patch_cell(patch, cell);
    const double *corners[PARADT_MAX_DIM + 1];
    paradt_index nowhere[PARADT_MAX_DIM + 1];
    int dim = bw->cells.corners - 1, i, count = 0;
    for (i = 0; i <= dim; i++) {
        nowhere[i] = PARADT__NOWHERE;
        if (i != ghost) corners[count++] = paradt__record(patch->set, paradt__patch_position(patch, vertices[i]));
    }
    if (ghost < 0) {
        paradt__search_sphere(&patch->search, corners, nowhere);
    } else {
        paradt_index handle = bw->cells.neighbors[(size_t)cell * (size_t)(dim + 1) + (size_t)ghost];
        const paradt_index *inner = paradt__patch_cell(patch, paradt__bw_cell(bw, handle));
        paradt__search_beyond(&patch->search, corners, (dim - ghost) % 2 ? -1 : 1,
                              paradt__bw_record(bw, inner[handle % (dim + 1)]));
    }
}

// Has the search found what it is aimed at?
PARADT__INLINE int paradt__patch_met(const paradt__search *s) {
    return s->conflict ? s->found : s->apex >= 0;
}

// A point of the field that the search is aimed at, or -1. positions: of the cell's vertices.
static paradt_index paradt__patch_ask_boxes(paradt__patch *patch, const paradt__field *field,
                                            const paradt_index *positions) {
    paradt__search *s = &patch->search;
    paradt_index places[PARADT_MAX_DIM + 1];
    int i;
    for (i = 0; i < patch->bw.cells.corners; i++) {
        size_t place = (size_t)positions[i] - field->begin;
        places[i] = place < field->set.count ? (paradt_index)place : PARADT__NOWHERE;
    }
    paradt__search_turn(s, &field->set, &field->grid, places);
    paradt__search_down(s);
    return paradt__patch_met(s) ? s->apex + (paradt_index)field->begin : (paradt_index)-1;
}

// The search is aimed at a cell with one of others' points, of which the neighbours are told: one of these that it is
// aimed at, or -1.
static paradt_index paradt__patch_ask_near(paradt__patch *patch, size_t told, const paradt_index *positions) {
    paradt__search *s = &patch->search;
    size_t i = told ? (size_t)patch->told[told - 1] : 0, end = (size_t)patch->told[told];
    patch->looked += 1 + (end - i) / PARADT__LANES;
    paradt__search_turn(s, &patch->everyone, s->grid, positions);
    for (; i < end; i++) {
        paradt__search_point(s, (size_t)patch->nearby[i]);
        if (paradt__patch_met(s)) return s->apex;
    }
    return -1;
}

// A vertex of the cell that is the field's, as the number of others' points that the patch has: one of which the
// neighbours are told, or else one of which they are not told yet, or SIZE_MAX.
static size_t paradt__patch_witness(const paradt__patch *patch, const paradt__field *field, paradt_index cell) {
    const paradt_index *vertices = paradt__patch_cell(patch, cell);
    size_t own = patch->fields[patch->own].set.count, untold = SIZE_MAX;
    int i;
    for (i = 0; i < patch->bw.cells.corners; i++) {
        size_t other = (size_t)vertices[i] - own;
        if (vertices[i] < 0) continue;
        if ((size_t)paradt__patch_position(patch, vertices[i]) - field->begin >= field->set.count) continue;
        if (other >= patch->told_count) untold = other;
        else if (patch->told[other] > (other ? patch->told[other - 1] : 0)) return other;
    }
    return untold;
}

// Is there a region of which the patch is not told yet what the cell needs?
static int paradt__patch_is_late(const paradt__patch *patch, paradt_index cell) {
    size_t i, witness;
    for (i = 0; i < patch->field_count; i++) {
        if (i == patch->own || !patch->fields[i].patch) continue;
        witness = paradt__patch_witness(patch, patch->fields + i, cell);
        if (witness != SIZE_MAX && witness >= patch->told_count) return 1;
    }
    return 0;
}

// A point of another region that the search is aimed at, or -1.
static paradt_index paradt__patch_ask(paradt__patch *patch, const paradt__field *field, paradt_index cell, int ghost) {
    const paradt_index *vertices = paradt__patch_cell(patch, cell);
    paradt_index positions[PARADT_MAX_DIM + 1];
    size_t witness = field->patch ? paradt__patch_witness(patch, field, cell) : SIZE_MAX;
    int i, count = 0;
    for (i = 0; i < patch->bw.cells.corners; i++) {
        if (i != ghost) positions[count++] = paradt__patch_position(patch, vertices[i]);
    }
    if (ghost >= 0) positions[count] = PARADT__NOWHERE;
    return witness == SIZE_MAX ? paradt__patch_ask_boxes(patch, field, positions)
                               : paradt__patch_ask_near(patch, witness, positions);
}

// Notes of a cell that it is around its vertices, for those that are the region's.
PARADT__INLINE void paradt__patch_note_around(paradt__patch *patch, paradt_index cell) {
    const paradt_index *vertices = paradt__patch_cell(patch, cell);
    int i;
    for (i = 0; i < patch->bw.cells.corners; i++) {
        if (vertices[i] >= 0 && paradt__patch_has(patch, vertices[i])) patch->around[vertices[i]] = cell;
    }
}

// Inserts a point in conflict with the cell. What it replaced is forgotten, what it made has to wait.
static paradt_status paradt__patch_insert(paradt__patch *patch, size_t position, paradt_index cell) {
    paradt__bw *bw = &patch->bw;
    size_t i;
    paradt_status status = paradt__patch_add(patch, position);
    if (!status) status = paradt__bw_insert_one_more(bw, (paradt_index)(bw->count - 1), cell);
    patch->late_cells += bw->rim_count;
    for (i = 0; i < bw->cavity_count && !status; i++) bw->marks[paradt__bw_cell(bw, bw->cavity[i])] = 0;
    for (i = 0; i < bw->rim_count && !status; i++) {
        paradt_index made = paradt__bw_made(bw, i);
        bw->marks[made] = 0;
        if (patch->around) paradt__patch_note_around(patch, made);
        status = PARADT__PATCH_LIST(patch, fringe, made);
        if (!status && paradt__patch_share(patch, made)) status = paradt__patch_wait(patch, made);
    }
    return status;
}

// Asks about a cell, and does what follows from the answer. No point that is missing is in a sphere inside K, nor
// beyond a ghost's facet or in its plane where these have no more of the reference sphere than a cap inside K.
static paradt_status paradt__patch_settle(paradt__patch *patch, paradt_index cell) {
    paradt__bw *bw = &patch->bw;
    int ghost = paradt__bw_ghost(paradt__patch_cell(patch, cell), bw->cells.corners);
    paradt_index answer = -1;
    size_t i;
    paradt_status status = PARADT_OK;
    if (paradt__patch_is_late(patch, cell)) return PARADT__PATCH_LIST(patch, late, cell);
    bw->marks[cell] = PARADT__ASKED;
    if (paradt__patch_on_seam(patch, cell)) status = PARADT__PATCH_LIST(patch, border, cell);
    if (status) return status;
    paradt__patch_aim(patch, cell, ghost);
    if (patch->roomy && paradt__search_within(&patch->search, patch->room)) return PARADT_OK;
    for (i = 0; i < patch->field_count && answer < 0; i++) {
        if (i != patch->own && patch->fields[i].set.count)
            answer = paradt__patch_ask(patch, patch->fields + i, cell, ghost);
    }
    if (answer >= 0) return paradt__patch_insert(patch, (size_t)answer, cell);
    if (ghost < 0) return PARADT_OK;
    // Points in the plane of its facet are in conflict with the ghost if they are with the cell behind it.
    return paradt__patch_wait(patch, paradt__bw_cell(bw, bw->cells.neighbors[cell * bw->cells.corners + ghost]));
}

// ---------------------------------------------------------------------------------------------------------------------
// >>telling
//
// Doors: to be listed.

// --- what regions tell each other
//
// Let v be a vertex of a cell, or of the facet of a ghost, and a point of a set Q. If any point of Q is in conflict
// with the cell, so is one of v's neighbours in T(Q): lifted, Q is in the convex cone that v's edges and the upward
// vertical span; the cell's hyperplane passes through v, and no way up leads below it. A region's triangulation is at
// any time one of all its own points and some more, so v's neighbours there, at whatever time, decide for all of its
// points. They are few also near surfaces, which large spheres touch so that boxes rule out little. Regions tell each
// other the neighbours of the points that they have from each other; while one looks at another's cells, none changes.

// Cells around a vertex
enum {
    PARADT__AROUND = 256, // at most, and some that are found with the last
    PARADT__AROUND_PLACES = 512
};

typedef struct paradt__around {
    size_t count;
    paradt_index cells[PARADT__AROUND + PARADT_MAX_DIM + 1];
    paradt_index table[PARADT__AROUND_PLACES]; // the same by their numbers; -1: free
} paradt__around;

// Adds a cell; 0 if it is there.
PARADT__INLINE int paradt__around_add(paradt__around *around, paradt_index cell) {
    size_t place = (uint32_t)cell * 0x9E3779B1u >> 23;
    while (around->table[place] != cell) {
        if (around->table[place] < 0) {
            around->table[place] = around->cells[around->count++] = cell;
            return 1;
        }
        place = (place + 1) % PARADT__AROUND_PLACES;
    }
    return 0;
}

// Makes ready to be looked at by others.
static paradt_status paradt__patch_show(paradt__patch *patch) {
    size_t own = patch->fields[patch->own].set.count, corners = (size_t)patch->bw.cells.corners, cell;
    patch->around = (paradt_index *)paradt__alloc(patch->memory, own, sizeof *patch->around);
    if (!patch->around) return PARADT_ERROR_MEMORY;
    paradt__bw_mark_free(&patch->bw);
    for (cell = 0; cell < patch->bw.cells.count; cell++) {
        if (patch->bw.cells.vertices[cell * corners] != PARADT__DEAD)
            paradt__patch_note_around(patch, (paradt_index)cell);
    }
    return PARADT_OK;
}

// Notes a neighbour of a point of another region, by its number there.
PARADT__INLINE paradt_status paradt__patch_note_near(paradt__patch *patch, const paradt__patch *other,
                                                     paradt_index neighbor) {
    return neighbor < 0 ? PARADT_OK : PARADT__PATCH_LIST(patch, nearby, paradt__patch_position(other, neighbor));
}

// Lists the neighbours of another region's own point in its triangulation, each at least once.
static paradt_status paradt__patch_hear(paradt__patch *patch, const paradt__patch *other, paradt_index vertex) {
    const paradt_index *vertices = other->bw.cells.vertices, *links = other->bw.cells.neighbors;
    paradt_index corners = (paradt_index)other->bw.cells.corners, first = other->around[vertex] * corners, i;
    size_t before = patch->nearby_count, next;
    paradt__around around;
    paradt_status status = PARADT_OK;
    around.count = 0;
    memset(around.table, -1, sizeof around.table);
    paradt__around_add(&around, other->around[vertex]);
    for (i = first; i < first + corners && !status; i++) {
        if (vertices[i] != vertex) status = paradt__patch_note_near(patch, other, vertices[i]);
    }
    for (next = 0; next < around.count && around.count <= PARADT__AROUND; next++) {
        first = around.cells[next] * corners;
        for (i = first; i < first + corners && !status; i++) { // beyond each facet with the vertex
            if (vertices[i] != vertex && paradt__around_add(&around, links[i] / corners))
                status = paradt__patch_note_near(patch, other, vertices[links[i]]);
        }
    }
    if (around.count > PARADT__AROUND) patch->nearby_count = before;
    patch->looked += PARADT__LANES + around.count / 4;
    return status;
}

// Gives back what only the building needs: all patches wait together for the last step.
static void paradt__patch_rest(paradt__patch *patch) {
    paradt__spheres3_free(patch->bw.spheres, patch->memory);
    paradt__release(patch->memory, patch->order);
    if (!patch->lent) paradt__release(patch->memory, patch->records);
    paradt__release(patch->memory, patch->bw.marks);
    paradt__release(patch->memory, patch->around);
    paradt__release(patch->memory, patch->late);
    paradt__release(patch->memory, patch->told);
    paradt__release(patch->memory, patch->nearby);
    paradt__release(patch->memory, patch->border);
    patch->bw.spheres = NULL;
    patch->bw.order = patch->order = NULL;
    patch->records = NULL;
    patch->around = patch->late = patch->told = patch->nearby = patch->border = NULL;
    patch->bw.marks = NULL;
}

static void paradt__patch_end(paradt__patch *patch) {
    paradt__patch_rest(patch);
    paradt__release(patch->memory, patch->list);
    paradt__release(patch->memory, patch->fringe);
    paradt__release(patch->memory, patch->seam);
    paradt__bw_end(&patch->bw);
    paradt__release(patch->memory, patch->others);
    paradt__release(patch->memory, patch->table);
    paradt__cells_free(&patch->bw.cells, patch->memory);
}

static void paradt__patch_begin(paradt__patch *patch, const paradt__set *set, const paradt__field *fields,
                                size_t field_count, size_t own, paradt__memory *memory) {
    size_t i;
    memset(patch, 0, sizeof *patch);
    patch->set = set;
    patch->everyone = *set;
    patch->everyone.count = (size_t)PARADT__NOWHERE;
    patch->fields = fields;
    patch->field_count = field_count;
    patch->own = own;
    patch->memory = patch->bw.memory = memory;
    patch->bw.cells.corners = set->space.dim + 1;
    patch->bw.space = set->space;
    memset(&patch->bw.space.counters, 0, sizeof patch->bw.space.counters);
    paradt__bw_layout(&patch->bw, set);
    paradt__search_begin(&patch->search, &fields[own].set, &fields[own].grid);
    for (i = 0; i < field_count; i++) {
        patch->search.heaviest = paradt__larger(patch->search.heaviest, fields[i].grid.heaviest);
    }
}

// What is on the other side of a facet is dropped.
PARADT__INLINE void paradt__patch_cut(paradt__patch *patch, paradt_index handle, paradt_index becomes) {
    if (handle >= 0) patch->bw.cells.neighbors[handle] = becomes; // else its cell was dropped before
}

// Drops a ghost, or a cell of another region. share: how many vertices are the region's; 0 too if it is wrong. The
// links to what is dropped: a facet of S's hull that has a vertex of the region is one of T(P)'s hull; the others are
// open.
static void paradt__patch_drop(paradt__patch *patch, size_t cell, int share) {
    int corners = patch->bw.cells.corners, ghost, j;
    paradt_index *vertices = patch->bw.cells.vertices + cell * (size_t)corners;
    const paradt_index *links = patch->bw.cells.neighbors + cell * (size_t)corners;
    ghost = paradt__bw_ghost(vertices, corners);
    if (ghost >= 0) {
        patch->hull_facets += (uint64_t)(share && paradt__patch_owns(patch, (paradt_index)cell));
        paradt__patch_cut(patch, links[ghost], share ? PARADT__HULL : PARADT__OPEN);
    } else {
        patch->made++;
        for (j = 0; j < corners; j++) paradt__patch_cut(patch, links[j], PARADT__OPEN);
    }
    vertices[0] = PARADT__DEAD;
    patch->dropped++;
}

// Drops what the region does not own, all of it in the fringe.
PARADT__INLINE void paradt__patch_drop_fringe(paradt__patch *patch, size_t corners) {
    const paradt__cells cells = patch->bw.cells; // a copy, which nothing that is written can change
    const paradt_index *fringe = patch->fringe, own = (paradt_index)patch->fields[patch->own].set.count;
    size_t count = patch->fringe_count, i;
    for (i = 0; i < count; i++) {
        const paradt_index *vertices = cells.vertices + (size_t)fringe[i] * corners;
        int share;
        paradt__fetch_listed(&cells, fringe, count, i);
        if (vertices[0] == PARADT__DEAD) continue;
        share = paradt__vertices_below(vertices, corners, own);
        if (!share || !paradt__vertices_among(vertices, (int)corners, 0, PARADT__NOWHERE) ||
            !paradt__patch_owns(patch, fringe[i]))
            paradt__patch_drop(patch, (size_t)fringe[i], share);
    }
}

// Leaves only the cells of the region, which are the first then. Points of later regions have no index: a cell with one
// of them is not the region's.
static paradt_status paradt__patch_compact(paradt__patch *patch) {
    const paradt__field *own = patch->fields + patch->own;
    paradt__bw *bw = &patch->bw;
    paradt_status status = paradt__patch_translate(patch, (paradt_index)(own->begin + own->set.count));
    size_t end = bw->cells.count, i;
    if (status) return status;
    paradt__bw_mark_free(bw);
    for (i = 0; i < patch->list_count; i++) paradt__patch_drop(patch, (size_t)patch->list[i], 0);
    if (bw->cells.corners == 4) paradt__patch_drop_fringe(patch, 4);
    else paradt__patch_drop_fringe(patch, (size_t)bw->cells.corners);
    bw->cells.count -= bw->spare_count + patch->dropped;
    paradt__bw_fill_gaps(bw, bw->spare, bw->spare_count, &end);
    paradt__bw_fill_gaps(bw, patch->list, patch->list_count, &end);
    paradt__bw_fill_gaps(bw, patch->fringe, patch->fringe_count, &end);
    patch->list_count = 0;
    paradt__release(patch->memory, patch->fringe);
    patch->fringe = NULL;
    patch->made += bw->cells.count;
    return PARADT_OK;
}

// Lists the open facets of the cell with that number.
static paradt_status paradt__patch_open_cell(paradt__patch *patch, const paradt__rows *to, size_t cell) {
    size_t corners = (size_t)patch->bw.cells.corners, j;
    paradt_status status = PARADT_OK;
    for (j = 0; j < corners && !status; j++) {
        if (to->neighbors[cell * corners + j] == PARADT__OPEN)
            status = PARADT__PATCH_LIST(patch, list, (paradt_index)(((size_t)to->offset + cell) * corners + j));
    }
    return status;
}

// Writes the region's cells, which are compact, to where they go: with the caller's vertices and numbered neighbours.
// That may be where they are, or before it. Lists the facets that are open.
PARADT__INLINE paradt_status paradt__patch_emit_cells(paradt__patch *patch, const paradt__rows *place, size_t corners) {
    const paradt__cells cells = patch->bw.cells; // copies, which nothing that is written can change
    const paradt__rows to = *place;
    const paradt_index *origin = patch->origin;
    size_t i;
    paradt_status status = PARADT_OK;
    for (i = 0; i < cells.count; i++) {
        int bare = paradt__bw_number(&cells, i, corners, origin, &to);
        paradt__fetch_row(to.vertices, to.neighbors, i + PARADT__ROWS_AHEAD, corners);
        if (!PARADT__LIKELY(!bare) && !status) status = paradt__patch_open_cell(patch, &to, i);
    }
    return status;
}

static paradt_status paradt__patch_emit(paradt__patch *patch, const paradt__rows *to) {
    if (patch->bw.cells.corners == 4) return paradt__patch_emit_cells(patch, to, 4);
    return paradt__patch_emit_cells(patch, to, (size_t)patch->bw.cells.corners);
}

// Looks for answers so far
static uint64_t paradt__patch_looked(const paradt__patch *patch) {
    const paradt__counters *c = &patch->search.space.counters;
    return patch->search.grid_cells_visited + patch->looked + c->insphere_calls + c->orient_calls;
}

// Would it be sooner to be told by others? To hear of a point takes as long as some looks.
static int paradt__patch_is_hasty(const paradt__patch *patch) {
    size_t others = patch->bw.count - patch->fields[patch->own].set.count;
    return paradt__patch_looked(patch) > 10000 + patch->bw.cells.count / 32 + 8 * others;
}

// Do the questions, with what is inserted for them, take longer than to insert another region's points, or two others'
// where there are more? To make a cell takes as long as two looks or more, with the dimension many. A set may be all
// seam: exactly cospherical points are.
static int paradt__patch_is_stuck(const paradt__patch *patch) {
    uint64_t looked = paradt__patch_looked(patch) / (patch->bw.cells.corners <= 4 ? 2 : 4);
    return looked + patch->late_cells > patch->bw.cells.count * (patch->field_count > 2 ? 2 : 1) + 5000;
}

// Builds the triangulation of the points that the region begins with. When it has paused, it goes on.
static paradt_status paradt__patch_build(paradt__patch *patch, const paradt__progress *progress) {
    paradt__bw *bw = &patch->bw;
    paradt_status status = patch->order ? PARADT_OK : paradt__patch_sort(patch);
    if (!status) status = bw->inserted ? paradt__bw_insert_rest(bw, progress) : paradt__bw_build(bw, progress);
    if (!status && bw->inserted < bw->count) return PARADT_OK;
    paradt__release(patch->memory, patch->order);
    bw->order = patch->order = NULL;
    patch->asks = 1;
    return status || patch->trusts ? status : paradt__patch_suspects(patch);
}

// So many questions, with what is inserted for them, take as long as to insert a point.
enum { PARADT__QUESTIONS_A_POINT = 2 };

// Asks about the cells that wait, until all cells of T(P) with a vertex of the region are there, but for those that
// wait for what others have to tell; or until it pauses. If it is hasty, no longer than others would take to tell.
static paradt_status paradt__patch_complete(paradt__patch *patch, int hasty, const paradt__progress *progress) {
    paradt_status status = PARADT_OK;
    while (!status && patch->list_count && !(hasty && paradt__patch_is_hasty(patch))) {
        paradt_index cell = patch->list[--patch->list_count];
        if (patch->bw.marks[cell] & PARADT__WAITING) status = paradt__patch_settle(patch, cell);
        if (!status && paradt__patch_is_stuck(patch)) status = PARADT__GAVE_UP;
        if (++patch->asked % 1024 == 0 && paradt__progress_cancels(progress, 1.0)) return PARADT_ERROR_CANCELLED;
        if (paradt__relay_pauses(patch->bw.relay, patch->asked, 64 / PARADT__QUESTIONS_A_POINT)) break;
    }
    return status;
}

// Has it paused, inserting or asking?
static int paradt__patch_pauses(const paradt__patch *patch, int hasty) {
    return !patch->asks || (patch->list_count && !(hasty && paradt__patch_is_hasty(patch)));
}

// Hears of all points that it has from others. The cells that waited for that go on.
static paradt_status paradt__patch_hear_all(paradt__patch *patch) {
    size_t own = patch->fields[patch->own].set.count, i;
    paradt_status status = PARADT_OK;
    while (own + patch->told_count < patch->bw.count && !status) {
        paradt_index position = patch->others[patch->told_count];
        const paradt__field *field = patch->fields;
        while ((size_t)position - field->begin >= field->set.count) field++;
        if (field->patch) status = paradt__patch_hear(patch, field->patch, position - (paradt_index)field->begin);
        if (!status) status = PARADT__PATCH_LIST(patch, told, (paradt_index)patch->nearby_count);
    }
    for (i = 0; i < patch->late_count && !status; i++) status = PARADT__PATCH_LIST(patch, list, patch->late[i]);
    patch->late_count = 0;
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>seam
//
// Doors: to be listed.

// --- the seam
//
// The first region has built T(S) of its own points S, and lacks nothing: a cell of T(P) with vertices in S alone is
// one of T(S). But which of T(S)'s cells are of T(P), and which are wrong, in conflict with others' points? The others
// list the seam: the facets with vertices in S alone of those cells of T(P) that have one vertex more, the apex. Cells
// are all here that are ghosts too. A facet listed twice has others' cells on both sides. Behind one listed once is a
// cell of T(P) that has its vertices in S alone; it is right. On the apex's side of the facet T(S) has a wrong cell: if
// the apex q were inserted into T(S) alone, the facet would get the cell with q, as it has it in T(P). The cells of
// T(S) in conflict with q, all wrong, are connected through facets. So from the one that contains q all wrong cells
// around can be reached without passing the facets listed once, and no right one: a facet between a right and a wrong
// cell is of T(P), where the cell on the wrong side has others' vertices, one of them, so it is listed, once.
//
// All wrong cells are reached from some facet so, since the cells of T(S) are connected through facets, unless there
// is no facet listed once. Then all cells are wrong if any cell of T(P) has a vertex that is not in S, and else all are
// right.

// Lists the facets of the seam, when all cells have been asked about.
static paradt_status paradt__patch_list_seam(paradt__patch *patch) {
    int corners = patch->bw.cells.corners, i;
    size_t at;
    paradt_status status = PARADT_OK;
    for (at = 0; at < patch->border_count && !status; at++) {
        paradt_index cell = patch->border[at], apex = -1;
        const paradt_index *vertices = paradt__patch_cell(patch, cell);
        if (!(patch->bw.marks[cell] & PARADT__ASKED) || !paradt__patch_on_seam(patch, cell)) continue;
        patch->bw.marks[cell] = 0; // it may be there twice
        for (i = 0; i < corners && !status; i++) {
            paradt_index position = vertices[i] < 0 ? vertices[i] : paradt__patch_position(patch, vertices[i]);
            if (vertices[i] >= 0 && paradt__patch_has(patch, vertices[i])) apex = position;
            else status = PARADT__PATCH_LIST(patch, seam, position);
        }
        if (!status) status = PARADT__PATCH_LIST(patch, seam, apex);
    }
    return status;
}

// Has any cell or ghost a vertex of the region?
static int paradt__patch_has_cells(paradt__patch *patch) {
    size_t cell;
    paradt__bw_mark_free(&patch->bw);
    for (cell = 0; cell < patch->bw.cells.count; cell++) {
        if (*paradt__patch_cell(patch, (paradt_index)cell) != PARADT__DEAD &&
            paradt__patch_share(patch, (paradt_index)cell))
            return 1;
    }
    return 0;
}

// What the other regions say of the seam
typedef struct paradt__seam {
    size_t dim;           // vertices of a facet; the infinite one is among them where two ghosts meet
    paradt_index *facets; // [count][dim + 1] the vertices in order, and the apex; or what follows
    paradt_index *table;  // [capacity] hash table of facets; -1: free
    size_t count, capacity;
    size_t single; // facets that have been listed once
} paradt__seam;

enum {
    PARADT__MET = -1,  // the wrong cell on its side has been reached
    PARADT__TWICE = -2 // it has been listed twice
};

// Puts a vertex among those before it, which are in order.
PARADT__INLINE void paradt__facet_add(paradt_index *facet, size_t count, paradt_index vertex) {
    for (; count > 0 && facet[count - 1] > vertex; count--) facet[count] = facet[count - 1];
    facet[count] = vertex;
}

// Where the table has the facet, or would have it. dim: the seam's; inlined with a constant.
PARADT__INLINE paradt_index *paradt__seam_place(const paradt__seam *seam, const paradt_index *facet, size_t dim) {
    size_t mask = seam->capacity - 1, i;
    size_t place = paradt__facet_key(paradt__cell_sum(facet, (int)dim)) & mask;
    for (; seam->table[place] >= 0; place = (place + 1) & mask) {
        const paradt_index *other = seam->facets + (size_t)seam->table[place] * (dim + 1);
        for (i = 0; i < dim && other[i] == facet[i];) i++;
        if (i == dim) break;
    }
    return seam->table + place;
}

static void paradt__seam_add(paradt__seam *seam, const paradt_index *listed) {
    paradt_index *facet = seam->facets + seam->count * (seam->dim + 1), *place;
    size_t i;
    for (i = 0; i < seam->dim; i++) paradt__facet_add(facet, i, listed[i]);
    facet[seam->dim] = listed[seam->dim];
    place = paradt__seam_place(seam, facet, seam->dim);
    if (*place >= 0) {
        seam->facets[(size_t)*place * (seam->dim + 1) + seam->dim] = PARADT__TWICE;
        seam->single--;
        return;
    }
    *place = (paradt_index)seam->count++;
    seam->single++;
}

static void paradt__seam_free(paradt__seam *seam, paradt__memory *memory) {
    paradt__release(memory, seam->facets);
    paradt__release(memory, seam->table);
}

static paradt_status paradt__seam_begin(paradt__seam *seam, const paradt__patch *patch) {
    const paradt__field *end = patch->fields + patch->field_count, *field;
    size_t count = 0, i;
    memset(seam, 0, sizeof *seam);
    seam->dim = (size_t)patch->bw.cells.corners - 1;
    for (field = patch->fields + 1; field < end; field++) count += field->seam_count;
    for (seam->capacity = 16; seam->capacity < 2 * count;) seam->capacity *= 2;
    seam->facets = (paradt_index *)paradt__alloc(patch->memory, count, (seam->dim + 1) * sizeof *seam->facets);
    seam->table = (paradt_index *)paradt__alloc(patch->memory, seam->capacity, sizeof *seam->table);
    if (!seam->facets || !seam->table) return PARADT_ERROR_MEMORY;
    memset(seam->table, -1, seam->capacity * sizeof *seam->table);
    for (field = patch->fields + 1; field < end; field++) {
        for (i = 0; i < field->seam_count; i++) paradt__seam_add(seam, field->seam + i * (seam->dim + 1));
    }
    return PARADT_OK;
}

// Has the facet of a wrong cell, of so many corners, been listed once, so that the cell on its other side is right? It
// is met then.
PARADT__INLINE int paradt__seam_meets(const paradt__seam *seam, const paradt_index *vertices, size_t corners,
                                      size_t without) {
    paradt_index facet[PARADT_MAX_DIM], place, *apex;
    size_t count = 0, i;
    for (i = 0; i < corners; i++) {
        if (i != without) paradt__facet_add(facet, count++, vertices[i]);
    }
    place = *paradt__seam_place(seam, facet, corners - 1);
    if (place < 0) return 0;
    apex = seam->facets + (size_t)place * corners + corners - 1;
    if (*apex == PARADT__TWICE) return 0;
    *apex = PARADT__MET;
    return 1;
}

// Lists those cells that are reached without passing the seam from those in the list, the first `next` apart.
PARADT__INLINE paradt_status paradt__patch_spread_wrong(paradt__patch *patch, const paradt__seam *seam, size_t next,
                                                        size_t corners) {
    paradt_status status = PARADT_OK;
    size_t i;
    for (; next < patch->list_count && !status; next++) {
        size_t base = (size_t)patch->list[next] * corners;
        paradt__fetch_listed(&patch->bw.cells, patch->list, patch->list_count, next);
        for (i = 0; i < corners && !status; i++) {
            size_t other = (size_t)patch->bw.cells.neighbors[base + i] / corners;
            if (!(patch->bw.marks[other] & PARADT__WAITING) &&
                !paradt__seam_meets(seam, patch->bw.cells.vertices + base, corners, i))
                status = paradt__patch_wait(patch, (paradt_index)other);
        }
    }
    return status;
}

// Lists a wrong cell, and those that are reached from it without passing the seam.
static paradt_status paradt__patch_list_wrong(paradt__patch *patch, const paradt__seam *seam, paradt_index first) {
    size_t next = patch->list_count;
    paradt_status status = paradt__patch_wait(patch, first);
    if (status) return status;
    if (seam->dim == 3) return paradt__patch_spread_wrong(patch, seam, next, 4);
    return paradt__patch_spread_wrong(patch, seam, next, seam->dim + 1);
}

// Lists all cells and ghosts.
static paradt_status paradt__patch_list_all(paradt__patch *patch) {
    size_t cell;
    paradt_status status = PARADT_OK;
    paradt__bw_mark_free(&patch->bw);
    for (cell = 0; cell < patch->bw.cells.count && !status; cell++) {
        if (*paradt__patch_cell(patch, (paradt_index)cell) != PARADT__DEAD)
            status = paradt__patch_wait(patch, (paradt_index)cell);
    }
    return status;
}

// Lists the cells and ghosts of the first region that are not of T(P).
static paradt_status paradt__patch_find_wrong(paradt__patch *patch, paradt__seam *seam) {
    paradt__bw *bw = &patch->bw;
    paradt_index cell = bw->spheres ? bw->spheres->start : bw->last;
    size_t i;
    int others = 0;
    paradt_status status = PARADT_OK;
    for (i = 1; i < patch->field_count; i++) others |= patch->fields[i].has_cells;
    if (others && !seam->single) return paradt__patch_list_all(patch);
    for (i = 0; i < seam->count && !status; i++) {
        paradt_index apex = seam->facets[i * (seam->dim + 1) + seam->dim];
        if (apex < 0) continue;
        cell = paradt__bw_walk(bw, cell, paradt__record(patch->set, apex));
        status = paradt__patch_list_wrong(patch, seam, cell);
    }
    return status;
}

// Lists the ghosts that are reached from those in the fringe, through facets.
static paradt_status paradt__patch_spread_ghosts(paradt__patch *patch) {
    paradt_index corners = (paradt_index)patch->bw.cells.corners, i;
    size_t next;
    paradt_status status = PARADT_OK;
    for (next = 0; next < patch->fringe_count && !status; next++) {
        paradt_index base = patch->fringe[next] * corners;
        paradt__fetch_listed(&patch->bw.cells, patch->fringe, patch->fringe_count, next);
        for (i = base; i < base + corners && !status; i++) {
            paradt_index other = patch->bw.cells.neighbors[i] / corners;
            if (patch->bw.cells.vertices[i] == PARADT__INFINITE || patch->bw.marks[other] & PARADT__LISTED) continue;
            patch->bw.marks[other] |= PARADT__LISTED;
            status = PARADT__PATCH_LIST(patch, fringe, other);
        }
    }
    return status;
}

// The fringe of the first region are the ghosts. If any is wrong, so is the first that was listed. Else they are looked
// for everywhere.
static paradt_status paradt__patch_list_ghosts(paradt__patch *patch) {
    const paradt__cells *cells = &patch->bw.cells;
    int corners = cells->corners;
    size_t cell;
    paradt_status status = PARADT_OK;
    if (patch->list_count && paradt__bw_ghost(paradt__patch_cell(patch, patch->list[0]), corners) >= 0) {
        patch->bw.marks[patch->list[0]] |= PARADT__LISTED;
        status = PARADT__PATCH_LIST(patch, fringe, patch->list[0]);
        return status ? status : paradt__patch_spread_ghosts(patch);
    }
    paradt__bw_mark_free(&patch->bw);
    cell = paradt__bw_fringe_from(cells, (size_t)corners, PARADT__NOWHERE, 0);
    for (; cell < cells->count && !status;
         cell = paradt__bw_fringe_from(cells, (size_t)corners, PARADT__NOWHERE, cell + 1))
        status = PARADT__PATCH_LIST(patch, fringe, (paradt_index)cell);
    return status;
}

// Lists what of the first region's cells and ghosts is not of T(P), and its fringe.
static paradt_status paradt__patch_judge(paradt__patch *patch) {
    paradt__seam seam;
    paradt_status status = paradt__seam_begin(&seam, patch);
    if (!status) status = paradt__patch_find_wrong(patch, &seam);
    if (!status) status = paradt__patch_list_ghosts(patch);
    paradt__seam_free(&seam, patch->memory);
    return status;
}

// --- all points

// Adds all points that the patch has not got, behind those inserted, and their order.
static paradt_status paradt__patch_add_all(paradt__patch *patch) {
    const paradt__field *last = patch->fields + patch->field_count - 1, *field;
    size_t before = patch->bw.count, end = last->begin + last->set.count, i;
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
    if (status || patch->bw.count == before) return status;
    paradt__release(patch->memory, patch->order);
    patch->order = (paradt_index *)paradt__alloc(patch->memory, patch->bw.count, sizeof *patch->order);
    order = paradt__round_order(patch->bw.count - before, patch->memory);
    if (!patch->order || !order) status = PARADT_ERROR_MEMORY;
    for (i = before; i < patch->bw.count && !status; i++) patch->order[i] = order[i - before] + (paradt_index)before;
    paradt__release(patch->memory, order);
    return status;
}

// Makes the patch the triangulation of the whole set, with the caller's indices.
static paradt_status paradt__patch_take_all(paradt__patch *patch, const paradt__progress *progress) {
    paradt__bw *bw = &patch->bw;
    paradt_status status;
    bw->inserted = bw->count;
    bw->later = 0;
    status = paradt__patch_add_all(patch);
    bw->order = patch->order;
    if (!status && bw->inserted < bw->count)
        status = paradt__bw_go_on(bw, paradt__bw_point(bw, bw->inserted), bw->count, -1);
    if (!status) status = paradt__bw_insert_rest(bw, progress);
    if (status) return status;
    status = paradt__patch_translate(patch, PARADT__NOWHERE);
    if (!status) patch->hull_facets = paradt__bw_close(bw, patch->origin);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>triangulate

// How a method builds: facet by facet from a front, or (NULL) by insertion; both for any region.
typedef paradt_status (*paradt__front_method)(paradt__front *front);

static paradt__front_method paradt__choose_front(paradt_method method) {
    static const paradt__front_method methods[PARADT_METHOD_COUNT] = {NULL, paradt__incode, paradt__dewall, NULL};
    return methods[method];
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
}

static paradt_status paradt__check_arguments(const paradt_points *points, const paradt_options *options) {
    size_t size = points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double);
    if (points->dim < 2 || points->dim > PARADT_MAX_DIM || (unsigned)points->scalar > PARADT_F32)
        return PARADT_ERROR_ARGUMENT;
    if (points->count && !points->data) return PARADT_ERROR_ARGUMENT;
    if (points->stride && points->stride < size * (size_t)points->dim) return PARADT_ERROR_ARGUMENT;
    if (options) {
        if ((unsigned)options->method >= PARADT_METHOD_COUNT || (unsigned)options->partition > PARADT_UNIFORM)
            return PARADT_ERROR_ARGUMENT;
        if (options->flags & ~(unsigned)PARADT_NO_NEIGHBORS) return PARADT_ERROR_ARGUMENT;
        if (!options->allocator.alloc != !options->allocator.free) return PARADT_ERROR_ARGUMENT;
    }
    if (points->count > (sizeof(paradt_index) == 4 ? (size_t)INT32_MAX : SIZE_MAX / 16) / 2)
        return PARADT_ERROR_TOO_LARGE;
    if (points->count > SIZE_MAX / (points->stride ? points->stride : size * (size_t)points->dim))
        return PARADT_ERROR_TOO_LARGE;
    return PARADT_OK;
}

enum { PARADT__AUTO_INCODE_DIM = 4 }; // AUTO tries InCoDe from here on

// Is insertion the first method that is tried?
static int paradt__inserts(paradt_method method, int dim) {
    return !paradt__choose_front(method) && (method != PARADT_AUTO || dim < PARADT__AUTO_INCODE_DIM);
}

// All that one call works with.
typedef struct paradt__work {
    paradt__memory memory;
    paradt__set set;
    paradt__grid grid;
    paradt_options options;
    paradt_method method; // that is tried; AUTO has become one
    int impatient;        // 1: it may give up
    double done;          // part of the work that one that gave up has reported
    size_t regions;
    int in_turn; // 1: insertion builds one after another, without neighbours
    int hollow;  // 1: the points may be on a surface or a curve
    paradt_stats *stats;
    paradt__cells cells;
    paradt__cuts cuts;                      // between the regions
    uint32_t *owner;                        // [set.count] with a front: the region of each point
    paradt__field *fields;                  // [regions] with insertion
    struct paradt__region *region;          // [regions]
    paradt__cells slices;                   // with insertion: each region's cells in a part of it, while they fit
    paradt__active seam;                    // with insertion: open facets of regions, in the end
    int trusts;                             // with insertion: the first region has its own points alone
    paradt__relay relay;                    // with insertion
    int translated;                         // the cells have the caller's indices already
    paradt_index basis[PARADT_MAX_DIM + 1]; // with insertion: points that span the set
} paradt__work;

// What one region leaves behind.
typedef struct paradt__region {
    paradt__memory memory;
    paradt_status status;
    paradt__cells cells; // of a front, or
    paradt__patch patch; // what insertion builds,
    size_t offset;       // with the number of its first cell
    uint64_t hull_facets;
    int built;   // it has ended the third step
    int open;    // it waits for what others have to tell
    size_t runs; // in a leg of the relay, the region that the task with this one's number goes on with,
    size_t ran;  // and what this task has done, in points inserted
    double done; // what a front has reported of the whole work, at most
    paradt_stats stats;
} paradt__region;

static void paradt__count_predicates(paradt_stats *stats, const paradt__counters *c) {
    stats->orient_calls += c->orient_calls;
    stats->insphere_calls += c->insphere_calls;
    stats->exact_small += c->exact_small;
    stats->exact_fixed += c->exact_fixed;
    stats->exact_general += c->exact_general;
    stats->perturbed += c->perturbed;
}

static void paradt__count_front(paradt_stats *stats, const paradt__front *front) {
    stats->distance_evaluations += front->search.distance_evaluations;
    stats->grid_cells_visited += front->search.grid_cells_visited;
    if (front->active.peak > stats->active_peak) stats->active_peak = front->active.peak;
    paradt__count_predicates(stats, &front->search.space.counters);
}

// Adds what a region counted.
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

static paradt__progress paradt__part_of_progress(const paradt__work *work, size_t index, size_t parts) {
    paradt__progress progress;
    progress.call = work->options.progress;
    progress.user = work->options.user;
    progress.length = (1.0 - work->done) / (double)parts;
    progress.begin = work->done + (double)index * progress.length;
    return progress;
}

static double paradt__front_done(const paradt__front *front) {
    double part = (double)front->cells.count / front->expected;
    return front->progress.begin + (part < 1.0 ? part : 1.0) * front->progress.length;
}

static paradt_status paradt__build_undivided(paradt__work *work) {
    paradt__front front;
    paradt__region_view view = {NULL, NULL, 0};
    paradt_status status = paradt__front_begin(&front, &work->set, &work->grid, &work->memory, view, 1.0);
    front.progress = paradt__part_of_progress(work, 0, 1);
    front.impatient = work->impatient;
    if (!status) status = paradt__choose_front(work->method)(&front);
    paradt__count_front(work->stats, &front);
    paradt__front_end(&front);
    work->cells = front.cells;
    work->stats->hull_facets = front.hull_facets;
    work->done = paradt__front_done(&front);
    return status;
}

static paradt_status paradt__build_by_insertion(paradt__work *work) {
    paradt__progress progress = paradt__part_of_progress(work, 0, 1);
    paradt__counters counters;
    paradt_status status;
    memset(&counters, 0, sizeof counters);
    status =
        paradt__bowyer_watson(&work->set, &work->memory, &work->cells, !(work->options.flags & PARADT_NO_NEIGHBORS),
                              &progress, &counters, &work->stats->hull_facets);
    paradt__count_predicates(work->stats, &counters);
    work->translated = !status;
    return status;
}

// --- regions: the work of one is a task

static paradt__region_view paradt__view_of(const paradt__work *work, size_t index) {
    paradt__region_view view;
    view.owner = work->owner;
    view.cuts = &work->cuts;
    view.region = (uint32_t)index;
    return view;
}

// Points of a region
static size_t paradt__region_count(const paradt__work *work, size_t index) {
    return paradt__cuts_end(&work->cuts, index, work->set.count) - (index ? work->cuts.cut[index].begin : 0);
}

// By InCoDe or DeWall.
static void paradt__front_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__region_view view = paradt__view_of(work, index);
    paradt__front front;
    region->status =
        paradt__front_begin(&front, &work->set, &work->grid, &region->memory, view, 1.0 / (double)work->regions);
    front.progress = paradt__part_of_progress(work, index, work->regions);
    front.impatient = work->impatient;
    if (!region->status) region->status = paradt__choose_front(work->method)(&front);
    paradt__count_front(&region->stats, &front);
    paradt__front_end(&front);
    region->done = paradt__front_done(&front);
    region->cells = front.cells;
    if (!region->status)
        region->status =
            paradt__region_compact(&region->cells, &work->set, &view, &region->memory, &region->stats.cells_recomputed);
}

// By insertion, first step: the grid of the region's points. Of two regions of which the first trusts the other, only
// that one looks for points of the other.
static void paradt__grid_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__field *field = work->fields + index;
    int asked = !work->trusts || work->regions > 2 || index == 0;
    region->status = PARADT_OK;
    if (asked && field->set.count) region->status = paradt__grid_lay(&field->grid, &field->set, &region->memory);
}

// By insertion, second step: the points to begin with.
static void paradt__points_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__patch_begin(&region->patch, &work->set, work->fields, work->regions, index, &region->memory);
    region->patch.trusts = work->trusts && index == 0;
    region->status = paradt__patch_points(&region->patch, work->basis);
}

// Can regions be asked by the cells around their vertices? Up to three dimensions these are few, and without weights
// there are some.
static int paradt__asks_around(const paradt__work *work) {
    return !work->in_turn && work->set.space.dim <= 3 && !work->set.space.weighted;
}

static void paradt__count_patch(paradt__region *region) {
    const paradt__patch *patch = &region->patch;
    memset(&region->stats, 0, sizeof region->stats);
    paradt__count_predicates(&region->stats, &patch->bw.space.counters);
    paradt__count_predicates(&region->stats, &patch->search.space.counters);
    region->stats.distance_evaluations = patch->search.distance_evaluations;
    region->stats.grid_cells_visited = patch->search.grid_cells_visited;
}

// All cells of T(P) with a vertex of the region are there.
static void paradt__end_questions(paradt__work *work, size_t index) {
    paradt__region *region = work->region + index;
    paradt__patch *patch = &region->patch;
    paradt__field *field = work->fields + index;
    region->open = 0;
    region->status = paradt__patch_list_seam(patch);
    field->seam = patch->seam;
    field->seam_count = patch->seam_count / (size_t)patch->bw.cells.corners;
    field->has_cells = field->seam_count || paradt__patch_has_cells(patch);
    patch->seam = NULL;
}

// By insertion, third step: the cells, unless it pauses. The region remains open if it would rather be told by others
// what it lacks.
static void paradt__patch_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__patch *patch = &region->patch;
    int hasty = paradt__asks_around(work);
    size_t turn = work->in_turn ? work->regions - 1 - index : index;
    paradt__progress progress = paradt__part_of_progress(work, turn, work->regions);
    region->status = patch->asks ? PARADT_OK : paradt__patch_build(patch, &progress);
    if (!region->status && patch->asks) region->status = paradt__patch_complete(patch, hasty, &progress);
    if (!region->status && paradt__patch_pauses(patch, hasty)) return;
    region->built = 1;
    region->done = progress.begin + progress.length;
    region->open = !region->status && patch->list_count;
    paradt__count_patch(region);
    if (region->status || region->open || patch->trusts) return;
    paradt__end_questions(work, index);
    paradt__patch_rest(patch);
}

// Fourth step: leaves only the region's cells.
static void paradt__compact_task(void *context, size_t index) {
    paradt__region *region = ((paradt__work *)context)->region + index;
    paradt__patch *patch = &region->patch;
    region->status = patch->trusts ? paradt__patch_judge(patch) : PARADT_OK;
    paradt__count_patch(region);
    if (!region->status) region->status = paradt__patch_compact(patch);
    region->stats.cells_recomputed = patch->made - patch->bw.cells.count;
    region->hull_facets = patch->hull_facets;
    paradt__patch_rest(patch);
}

// Regions that are open look at others' cells while none of them changes.
static void paradt__show_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    region->status = paradt__patch_show(&region->patch);
    work->fields[index].patch = &region->patch;
}

static void paradt__hear_task(void *context, size_t index) {
    paradt__region *region = ((paradt__work *)context)->region + index;
    if (region->open) region->status = paradt__patch_hear_all(&region->patch);
}

static void paradt__complete_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    paradt__progress progress = paradt__part_of_progress(work, 0, 1); // all regions have come to its end
    if (!region->open) return;
    region->status = paradt__patch_complete(&region->patch, 0, &progress);
    region->done = progress.begin + progress.length;
    paradt__count_patch(region);
    if (!region->status && !region->patch.late_count) paradt__end_questions(work, index);
}

// Are the cells of the region in a slice of the result that they are not moved from yet? The second slice's cells can
// go to their places while they are written: nobody reads what is between them and the first's.
static int paradt__stays_in_slice(const paradt__work *work, size_t index) {
    return index > 1 && work->cells.vertices == work->slices.vertices;
}

// Links those of a region's open facets to their twins that have been seen, and the others wait for theirs.
static paradt_status paradt__join_patch(paradt__work *work, size_t index, paradt__memory *memory) {
    const paradt__patch *patch = &work->region[index].patch;
    paradt_status status = PARADT_OK;
    size_t i, j, end;
    for (i = 0; i < patch->list_count && !status; i = end) {
        end = patch->list_count - i < PARADT__JOINED ? patch->list_count : i + PARADT__JOINED;
        for (j = end; j < patch->list_count && j < end + PARADT__JOINED; j++) {
            PARADT__PREFETCH(work->cells.vertices + patch->list[j]);
            PARADT__PREFETCH(work->cells.neighbors + patch->list[j]);
        }
        status = paradt__join_facets(&work->seam, &work->cells, patch->list + i, end - i, memory);
    }
    return status;
}

// What is left to be done takes no coordinates.
static void paradt__release_records(paradt__work *work, paradt__memory *memory) {
    paradt__release(memory, work->set.records);
    work->set.records = NULL;
}

// By insertion, last step: into the result, or numbered at the begin of the region's slice. The first region's cells
// are where they are to be then, so its open facets can wait for others'.
static void paradt__emit_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *region = work->region + index;
    size_t first = region->offset * (size_t)work->cells.corners;
    int stays = paradt__stays_in_slice(work, index);
    paradt__rows to;
    to.vertices = stays ? region->patch.bw.cells.vertices : work->cells.vertices + first;
    to.neighbors = stays ? region->patch.bw.cells.neighbors : work->cells.neighbors + first;
    to.offset = (paradt_index)region->offset;
    if (!index) paradt__release_records(work, &region->memory); // before others' cells need new pages
    region->status = paradt__patch_emit(&region->patch, &to);
    if (index || region->status) return;
    region->status = paradt__active_begin(&work->seam, region->patch.list_count, &region->memory);
    if (!region->status) region->status = paradt__join_patch(work, 0, &region->memory);
}

// Runs a task for each region; the first status that is not PARADT_OK.
static paradt_status paradt__run_regions(paradt__work *work, void (*task)(void *context, size_t index)) {
    paradt_status status = PARADT_OK;
    size_t i;
    if (work->options.parallel_for) {
        work->options.parallel_for(work->options.user, work->regions, task, work);
    } else {
        for (i = 0; i < work->regions; i++) {
            task(work, i);
            if (work->region[i].status) break;
        }
    }
    for (i = 0; i < work->regions; i++) { // an error, or that it was cancelled, before that one gave up
        if (!status || (status == PARADT__GAVE_UP && work->region[i].status)) status = work->region[i].status;
    }
    return status;
}

// --- the relay
//
// The third step takes most of the time, and threads are not equally fast: processors differ, and others use them, too.
// So the regions change hands: it is done in legs, each of which ends for all when together they have done a part of
// what is left. In the next the region that has most left goes to the task that did most, since that is likely to be on
// the same thread again. What a region builds does not depend on where it pauses.

typedef struct paradt__ranked {
    size_t amount, number;
} paradt__ranked;

// The largest amounts first.
static void paradt__rank(paradt__ranked *list, size_t count) {
    size_t i, j;
    for (i = 1; i < count; i++) {
        paradt__ranked one = list[i];
        for (j = i; j > 0 && list[j - 1].amount < one.amount; j--) list[j] = list[j - 1];
        list[j] = one;
    }
}

// What a region still has to do, in points inserted. The questions take as long as the insertion of the margin.
static size_t paradt__region_left(const paradt__work *work, size_t index) {
    const paradt__patch *patch = &work->region[index].patch;
    const paradt__bw *bw = &patch->bw;
    if (work->region[index].built) return 0;
    if (patch->asks) return patch->list_count / PARADT__QUESTIONS_A_POINT;
    return bw->count - bw->inserted + bw->count - work->fields[index].set.count;
}

// What it has done, likewise
static size_t paradt__region_done(const paradt__patch *patch) {
    return patch->bw.inserted + patch->asked / PARADT__QUESTIONS_A_POINT;
}

static void paradt__leg_task(void *context, size_t index) {
    paradt__work *work = (paradt__work *)context;
    paradt__region *task = work->region + index, *region = work->region + task->runs;
    size_t before = paradt__region_done(&region->patch);
    if (!region->built) paradt__patch_task(work, task->runs);
    task->ran = paradt__region_done(&region->patch) - before;
}

// Who runs which region in the next leg. Returns how much is left of them all.
static size_t paradt__assign_leg(paradt__work *work, paradt__ranked *regions, paradt__ranked *tasks) {
    size_t left = 0, i;
    for (i = 0; i < work->regions; i++) {
        regions[i].number = tasks[i].number = i;
        tasks[i].amount = work->region[i].ran;
        regions[i].amount = paradt__region_left(work, i);
        left += regions[i].amount;
    }
    paradt__rank(regions, work->regions);
    paradt__rank(tasks, work->regions);
    for (i = 0; i < work->regions; i++) work->region[tasks[i].number].runs = regions[i].number;
    return left;
}

// The third step. No leg should be so short that to begin it matters. Where regions are many, threads even out their
// work by taking one after another.
static paradt_status paradt__run_relay(paradt__work *work) {
    enum { MOST = 64, PART = 4, FEWEST = 1 << 14 /* cells a region */ };
    paradt__ranked regions[MOST], tasks[MOST];
    double fewest = (double)(work->regions * FEWEST) / paradt__cells_a_point(work->set.space.dim);
    paradt_status status;
    int last;
    if (!work->options.parallel_for || work->regions > MOST) return paradt__run_regions(work, paradt__patch_task);
    do {
        size_t left = paradt__assign_leg(work, regions, tasks), i;
        last = (double)left < fewest;
        work->relay.stop = work->relay.done + (ptrdiff_t)(left / PART);
        for (i = 0; i < work->regions; i++) work->region[i].patch.bw.relay = last ? NULL : &work->relay;
        status = paradt__run_regions(work, paradt__leg_task);
    } while (!last && (!status || status == PARADT__GAVE_UP));
    return status;
}

// --- regions together

// Puts the cells of the regions together, giving their memory back one by one.
static paradt_status paradt__collect_regions(paradt__work *work, paradt__cells *cells, paradt_status status) {
    uint64_t peaks = work->memory.held;
    size_t total = 0, i;
    for (i = 0; i < work->regions; i++) {
        paradt__region *region = work->region + i;
        total += region->cells.count;
        paradt__count_region(work->stats, &region->stats);
        paradt__memory_join(&work->memory, &region->memory, &peaks);
    }
    if (work->memory.peak < peaks) work->memory.peak = peaks;
    cells->corners = work->set.space.dim + 1;
    if (!status) status = paradt__cells_reserve(cells, total, total, &work->memory);
    for (i = 0; i < work->regions; i++) {
        if (!status) paradt__cells_append(cells, &work->region[i].cells);
        paradt__cells_free(&work->region[i].cells, &work->memory);
    }
    return status;
}

// Links the open facets that the patches have listed, when the first region's wait for theirs. What finds no partner is
// the hull.
static paradt_status paradt__join_patches(paradt__work *work) {
    size_t i, j;
    paradt_status status = PARADT_OK;
    for (i = 1; i < work->regions && !status; i++) status = paradt__join_patch(work, i, &work->memory);
    for (i = 0; i < work->regions && !status && work->seam.count; i++) {
        const paradt__patch *patch = &work->region[i].patch;
        for (j = 0; j < patch->list_count; j++) {
            paradt_index *link = work->cells.neighbors + patch->list[j];
            if (*link == PARADT__OPEN) *link = PARADT__HULL;
        }
    }
    return status;
}

// What the regions hold becomes the call's, and what is left of the limit is shared among them again: between the
// steps, when none of them runs.
static void paradt__share_memory(paradt__work *work) {
    uint64_t peaks = work->memory.held;
    size_t i;
    for (i = 0; i < work->regions; i++) paradt__memory_join(&work->memory, &work->region[i].memory, &peaks);
    if (work->memory.peak < peaks) work->memory.peak = peaks;
    for (i = 0; i < work->regions; i++) work->region[i].memory = paradt__memory_fork(&work->memory, work->regions);
}

// Places of a slice: somewhat more than what uniform points need, since one that is too small costs a copy, though the
// gap that is left has to be closed; and more of the last one, behind which nothing has to be moved. Surfaces may have
// a tenth more cells a point, solids nothing but what shaken lattices have, 2 %. Not where there are so many points of
// others that a quarter could be left.
static size_t paradt__slice_places(const paradt__work *work, size_t index) {
    const paradt__patch *patch = &work->region[index].patch;
    size_t count = patch->bw.count, own = patch->fields[index].set.count;
    if (count - own <= own / 8) count += count / (index + 1 == work->regions ? 6 : work->hollow ? 9 : 32);
    return paradt__bw_places(count, work->set.space.dim);
}

// Gives each patch a slice of the result's arrays for its cells, where their number can be foreseen: in two and three
// dimensions. A patch whose cells don't fit takes arrays of its own.
static paradt_status paradt__lend_slices(paradt__work *work) {
    paradt__cells *slices = &work->slices;
    int dim = work->set.space.dim;
    size_t total = 0, first = 0, i;
    paradt_status status;
    slices->corners = dim + 1;
    if (dim < 2 || dim > 3) return PARADT_OK;
    for (i = 0; i < work->regions; i++) total += paradt__slice_places(work, i);
    status = paradt__cells_reserve(slices, total, total, &work->memory);
    if (status) {
        paradt__cells_free(slices, &work->memory);
        return status == PARADT_ERROR_TOO_LARGE ? PARADT_OK : status; // the cells that come may be fewer
    }
    paradt__share_memory(work);
    for (i = 0; i < work->regions && !status; i++) {
        paradt__patch *patch = &work->region[i].patch;
        size_t capacity = paradt__slice_places(work, i);
        status = paradt__bw_lend(&patch->bw, slices->vertices + first * (size_t)slices->corners,
                                 slices->neighbors + first * (size_t)slices->corners, capacity);
        first += capacity;
    }
    return status;
}

// Other slices' cells are at their begins: closes the gaps between them.
static void paradt__close_slices(paradt__work *work) {
    size_t corners = (size_t)work->cells.corners, i;
    for (i = 0; i < work->regions; i++) {
        const paradt__patch *patch = &work->region[i].patch;
        size_t first = work->region[i].offset * corners, bytes = patch->bw.cells.count * corners * sizeof(paradt_index);
        if (!bytes || !paradt__stays_in_slice(work, i)) continue;
        memmove(work->cells.vertices + first, patch->bw.cells.vertices, bytes);
        memmove(work->cells.neighbors + first, patch->bw.cells.neighbors, bytes);
    }
}

// Puts the cells of the patches together.
static paradt_status paradt__collect_patches(paradt__work *work) {
    paradt__cells *cells = &work->cells;
    size_t total = 0, i;
    int in_place = work->slices.vertices != NULL, lent = 0;
    paradt_status status = PARADT_OK;
    for (i = 0; i < work->regions; i++) {
        work->region[i].offset = total;
        total += work->region[i].patch.bw.cells.count;
        in_place = in_place && work->region[i].patch.bw.cells.lent;
        lent = lent || work->region[i].patch.bw.cells.lent;
    }
    if (!lent) paradt__cells_free(&work->slices, &work->memory);
    // Slices of which more than a quarter would be left empty don't become the result. To copy it takes as much again.
    in_place = in_place && work->slices.capacity <= total + total / 3 + 64;
    if (in_place) {
        *cells = work->slices;
    } else {
        paradt__release_records(work, &work->memory);
        status = paradt__cells_reserve(cells, total, total, &work->memory);
    }
    cells->count = total;
    paradt__share_memory(work);
    if (!status) status = paradt__run_regions(work, paradt__emit_task);
    paradt__share_memory(work);
    if (!status && in_place) paradt__close_slices(work);
    if (in_place) memset(&work->slices, 0, sizeof work->slices);
    return status ? status : paradt__join_patches(work);
}

// Where the points of the regions are to be in the set, each but the first's with room for what others' points it is
// likely to need, if there is to be any. Returns how many positions that takes.
static size_t paradt__place_fields(paradt__work *work, int roomy) {
    size_t total = 0, i;
    for (i = 0; i < work->regions; i++) {
        size_t count = paradt__region_count(work, i);
        work->fields[i].begin = total;
        work->fields[i].room = roomy && i > 0 ? count + count / 8 + 64 : count;
        total += work->fields[i].room;
    }
    return total;
}

// Moves the points of a region.
static void paradt__move_points(paradt__work *work, size_t index, size_t from, size_t to) {
    paradt__set *set = &work->set;
    size_t count = paradt__region_count(work, index);
    if (from == to) return;
    memmove(set->records + to * set->width, set->records + from * set->width, count * set->width * sizeof(double));
    memmove(set->origin + to, set->origin + from, count * sizeof *set->origin);
}

// Points that span the set, as positions in it once it is open.
static void paradt__find_basis(paradt__work *work) {
    paradt__set *set = &work->set, view = *set;
    const double *basis[PARADT_MAX_DIM + 1];
    int axes[PARADT_MAX_DIM + 1], k;
    view.space.ambient = set->space.dim; // only the axes that orient
    basis[0] = set->records;
    paradt__span(&view, NULL, basis, axes, 0, 0);
    set->space.counters = view.space.counters;
    for (k = 0; k <= set->space.dim; k++) {
        size_t point = (size_t)(basis[k] - set->records) / set->width, region = 0;
        while (point >= paradt__cuts_end(&work->cuts, region, set->count)) region++;
        if (region) point += work->fields[region].begin - work->cuts.cut[region].begin;
        work->basis[k] = (paradt_index)point;
    }
}

// Gaps between the regions' points make room for others'. The first region trusts the others if its points span.
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
    work->trusts = work->regions > 1 && paradt__spans(&work->fields[0].set);
}

// The set without them
static void paradt__close_set(paradt__work *work) {
    size_t i;
    for (i = 1; i < work->regions; i++) paradt__move_points(work, i, work->fields[i].begin, work->cuts.cut[i].begin);
}

// Completes the regions that are open with what they tell each other.
static paradt_status paradt__complete_together(paradt__work *work) {
    paradt_status status = paradt__run_regions(work, paradt__show_task);
    size_t open, i;
    do {
        if (!status) status = paradt__run_regions(work, paradt__hear_task);
        if (!status) status = paradt__run_regions(work, paradt__complete_task);
        for (i = open = 0; i < work->regions; i++) open += (size_t)work->region[i].open;
    } while (!status && open);
    return status;
}

// All regions at once, each step a task for each.
static paradt_status paradt__build_together(paradt__work *work) {
    size_t open, i;
    paradt_status status = paradt__run_regions(work, paradt__points_task);
    paradt__share_memory(work);
    if (!status) status = paradt__lend_slices(work);
    paradt__share_memory(work);
    if (!status) status = paradt__run_relay(work);
    for (i = open = 0; i < work->regions; i++) open += (size_t)work->region[i].open;
    paradt__share_memory(work);
    if (!status && open) status = paradt__complete_together(work);
    paradt__share_memory(work);
    if (!status) status = paradt__run_regions(work, paradt__compact_task);
    for (i = work->regions; i-- > 0 && status == PARADT__GAVE_UP;) {
        if (work->region[i].status == PARADT__GAVE_UP) work->done = work->region[i].done;
    }
    paradt__share_memory(work);
    if (!status) status = paradt__collect_patches(work);
    paradt__share_memory(work);
    return status;
}

// --- regions in turn: without neighbours, a region's links are given back before the next one begins

// Room for `count` cells' vertices behind those that the result has, and for what is expected after them.
static paradt_status paradt__turn_room(paradt__work *work, size_t count, size_t expected) {
    paradt__cells *cells = &work->cells;
    size_t corners = (size_t)cells->corners;
    void *vertices = cells->vertices;
    if (cells->count + count <= cells->capacity) return PARADT_OK;
    count += cells->count + expected;
    if (!paradt__grow(&work->memory, &vertices, cells->count * corners, count * corners, sizeof(paradt_index)))
        return PARADT_ERROR_MEMORY;
    cells->vertices = (paradt_index *)vertices;
    cells->capacity = count;
    return PARADT_OK;
}

// Builds a region, at the end of the result while its cells fit there.
static paradt_status paradt__build_turn(paradt__work *work, size_t index) {
    paradt__patch *patch = &work->region[index].patch;
    paradt__cells *cells = &work->cells, *own = &patch->bw.cells, *lent = &work->slices;
    size_t corners = (size_t)cells->corners, capacity, rest;
    paradt__rows to;
    paradt_status status;
    paradt__patch_begin(patch, &work->set, work->fields, work->regions, index, &work->memory);
    patch->trusts = work->trusts && index == 0;
    status = paradt__patch_points(patch, work->basis);
    capacity = paradt__bw_places(patch->bw.count, work->set.space.dim);
    if (capacity > paradt__most_cells(cells->corners)) capacity = paradt__most_cells(cells->corners);
    rest = paradt__bw_places(index ? work->cuts.cut[index].begin : 0, work->set.space.dim);
    if (!status) status = paradt__turn_room(work, capacity, rest);
    if (status) return status;
    lent->neighbors = (paradt_index *)paradt__alloc(&work->memory, capacity * corners, sizeof(paradt_index));
    if (!lent->neighbors) return PARADT_ERROR_MEMORY;
    status = paradt__bw_lend(&patch->bw, cells->vertices + cells->count * corners, lent->neighbors, capacity);
    if (!status) {
        paradt__patch_task(work, index);
        if (!work->region[index].status) paradt__compact_task(work, index);
        status = work->region[index].status;
    }
    if (!status && !own->lent) status = paradt__turn_room(work, own->count, rest);
    to.vertices = cells->vertices + cells->count * corners;
    to.neighbors = own->neighbors;
    to.offset = 0;
    if (!status) status = paradt__patch_emit(patch, &to);
    if (status) return status;
    cells->count += own->count;
    paradt__patch_end(patch);
    memset(patch, 0, sizeof *patch);
    paradt__cells_free(lent, &work->memory);
    return PARADT_OK;
}

static paradt_status paradt__build_in_turn(paradt__work *work) {
    paradt__cells *cells = &work->cells;
    size_t corners = (size_t)cells->corners, i;
    paradt_status status = PARADT_OK;
    for (i = work->regions; i-- > 0 && !status;) { // the first is told by all the others
        status = paradt__build_turn(work, i);
        work->done = work->region[i].done;
    }
    if (!status && cells->capacity > cells->count + cells->count / 4 + 64) {
        void *vertices = cells->vertices;
        size_t used = cells->count * corners;
        if (!paradt__grow(&work->memory, &vertices, used, used, sizeof(paradt_index))) return PARADT_ERROR_MEMORY;
        cells->vertices = (paradt_index *)vertices;
    }
    return status;
}

// --- regions given up

// The largest region that gave up: its triangulation takes in all that is missing, and is the result. Others' are given
// back.
static paradt_status paradt__take_over(paradt__work *work) {
    paradt__progress progress = paradt__part_of_progress(work, 0, 1);
    paradt__region *largest = NULL, *region;
    paradt__patch *patch;
    paradt_status status;
    for (region = work->region; region < work->region + work->regions; region++) {
        region->patch.memory = region->patch.bw.memory = &work->memory;
        if (region->status == PARADT__GAVE_UP && (!largest || region->patch.bw.count > largest->patch.bw.count))
            largest = region;
    }
    for (region = work->region; region < work->region + work->regions; region++) {
        region->stats.cells_recomputed = region->hull_facets = 0;
        if (region == largest) continue;
        paradt__patch_end(&region->patch);
        memset(&region->patch, 0, sizeof region->patch);
    }
    patch = &largest->patch;
    if (!patch->bw.cells.lent) paradt__cells_free(&work->slices, &work->memory);
    status = paradt__patch_take_all(patch, &progress);
    paradt__count_patch(largest);
    largest->hull_facets = patch->hull_facets;
    if (!status && patch->bw.cells.lent) {
        work->cells.corners = patch->bw.cells.corners;
        status = paradt__cells_reserve(&work->cells, patch->bw.cells.count, patch->bw.cells.count, &work->memory);
        if (!status) paradt__cells_append(&work->cells, &patch->bw.cells);
    } else if (!status) {
        work->cells = patch->bw.cells;
        memset(&patch->bw.cells, 0, sizeof patch->bw.cells);
    }
    return status;
}

// Regions by insertion.
static paradt_status paradt__build_patches(paradt__work *work) {
    int taken;
    paradt_status status;
    size_t i;
    work->fields = (paradt__field *)paradt__alloc(&work->memory, work->regions, sizeof *work->fields);
    if (!work->fields) return PARADT_ERROR_MEMORY;
    memset(work->fields, 0, work->regions * sizeof *work->fields);
    paradt__open_set(work);
    paradt__share_memory(work);
    status = paradt__run_regions(work, paradt__grid_task);
    paradt__share_memory(work);
    if (!status) status = work->in_turn ? paradt__build_in_turn(work) : paradt__build_together(work);
    taken = status == PARADT__GAVE_UP && !work->in_turn;
    if (taken) status = paradt__take_over(work);
    work->translated = !status;
    for (i = 0; i < work->regions; i++) {
        paradt__region *region = work->region + i;
        paradt__count_region(work->stats, &region->stats);
        work->stats->hull_facets += region->hull_facets;
        region->patch.memory = region->patch.bw.memory = &work->memory;
        paradt__patch_end(&region->patch);
        paradt__grid_free(&work->fields[i].grid, &work->memory);
        paradt__release(&work->memory, work->fields[i].seam);
    }
    paradt__cells_free(&work->slices, &work->memory);
    paradt__active_free(&work->seam, &work->memory);
    if (taken) work->regions = 1;
    return status;
}

static paradt_status paradt__build_fronts(paradt__work *work) {
    paradt_status status = paradt__run_regions(work, paradt__front_task);
    size_t i;
    for (i = 0; i < work->regions; i++) work->done = paradt__larger(work->done, work->region[i].done);
    status = paradt__collect_regions(work, &work->cells, status);
    return status ? status : paradt__regions_join(&work->cells, &work->memory, &work->stats->hull_facets);
}

static paradt_status paradt__build_regions(paradt__work *work) {
    paradt__memory *memory = &work->memory;
    int front = paradt__choose_front(work->method) != NULL;
    size_t i;
    if (front) work->owner = (uint32_t *)paradt__alloc(memory, work->set.count, sizeof *work->owner);
    work->region = (paradt__region *)paradt__alloc(memory, work->regions, sizeof *work->region);
    if ((front && !work->owner) || !work->region) return PARADT_ERROR_MEMORY;
    memset(work->region, 0, work->regions * sizeof *work->region);
    if (front) paradt__regions_assign(&work->set, &work->cuts, work->owner);
    for (i = 0; i < work->regions; i++) {
        work->region[i].memory = paradt__memory_fork(memory, work->regions);
        work->region[i].cells.corners = work->set.space.dim + 1;
    }
    work->cells.corners = work->set.space.dim + 1;
    return front ? paradt__build_fronts(work) : paradt__build_patches(work);
}

// The cell of a set of one point, or of none.
static paradt_status paradt__build_trivial(paradt__work *work) {
    paradt__cells *cells = &work->cells;
    paradt_status status;
    work->regions = 1;
    cells->corners = 1;
    status = paradt__cells_reserve(cells, 1, 1, &work->memory);
    if (status) return status;
    cells->count = work->set.count;
    cells->vertices[0] = 0;
    cells->neighbors[0] = PARADT__HULL;
    return PARADT_OK;
}

// Marks the representatives that are no vertex, and those they stand for, as hidden.
static paradt_status paradt__find_hidden(paradt__work *work, paradt_triangulation *out) {
    const paradt__cells *cells = &work->cells;
    size_t words = out->point_count / 64 + 1, corners = (size_t)cells->corners, i;
    uint64_t *used;
    if (!work->set.space.weighted) return PARADT_OK;
    used = (uint64_t *)paradt__alloc(&work->memory, words, sizeof *used);
    if (!used) return PARADT_ERROR_MEMORY;
    memset(used, 0, words * sizeof *used);
    for (i = 0; i < cells->count * corners; i++) {
        size_t point = (size_t)cells->vertices[i];
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

// Positions become the caller's indices.
static void paradt__translate(paradt__work *work) {
    paradt_index *vertices = work->cells.vertices;
    const paradt_index *origin = work->set.origin;
    size_t count = work->translated ? 0 : work->cells.count * (size_t)work->cells.corners, i;
    for (i = 0; i < count; i++) vertices[i] = origin[vertices[i]];
}

// Gives back what the building of cells needs beside the set.
static void paradt__release_helpers(paradt__work *work) {
    paradt__memory *memory = &work->memory;
    paradt__grid_free(&work->grid, memory);
    paradt__release(memory, work->owner);
    paradt__release(memory, work->fields);
    paradt__release(memory, work->region);
    memset(&work->grid, 0, sizeof work->grid);
    work->owner = NULL;
    work->fields = NULL;
    work->region = NULL;
}

// Forgets what a way that gave up has built.
static void paradt__begin_again(paradt__work *work) {
    paradt__release_helpers(work);
    paradt__cells_free(&work->cells, &work->memory);
    work->stats->cells_recomputed = work->stats->hull_facets = 0;
}

// Will insertion build regions one after another? Without neighbours it does, in three dimensions and less, and of many
// points makes regions for that: five need 190 bytes a point where one needs 280, and a tenth to a fifth more time.
static void paradt__choose_turns(paradt__work *work, const paradt_points *points) {
    enum { TURNS = 5, LEAST_POINTS = 500000 };
    work->in_turn = work->options.flags & PARADT_NO_NEIGHBORS && points->dim <= 3 &&
                    !paradt__choose_front(work->options.method) && (work->regions == 1 || !work->options.parallel_for);
    if (work->in_turn && work->regions == 1 && points->count >= LEAST_POINTS) work->regions = TURNS;
}

// --- do regions pay?
//
// On some surfaces and curves many points have neighbours far away: what a region builds of its own points is wrong
// nearly everywhere then, and it would give up after some time. A sample tells. Points spread in all dimensions need no
// such look: few of them have neighbours beyond a cut.

enum { PARADT__FORETELLING = 2048 }; // points of the sample

// Are points spread in fewer dimensions than they have? One in 64 is four times as far from its neighbours in three
// dimensions, and eight times on a surface; in two dimensions eight times, and 64 times on a curve.
static int paradt__is_hollow(const paradt__set *set) {
    enum { EVERY = 64 };
    int dim = set->space.dim;
    double all = paradt__spacing(set->records, set->width, dim, NULL, set->count);
    double some = paradt__spacing(set->records, set->width * EVERY, dim, NULL, set->count / EVERY);
    return dim >= 2 && dim <= 3 && some > (dim == 3 ? 5.6 : 11.2) * all;
}

// Points of the sample that have a neighbour on the other side of the first cut. cells: of the sample; side:
// [FORETELLING]
static size_t paradt__count_across(const paradt__cells *cells, unsigned char *side) {
    enum { UPPER = 1, ACROSS = 2 };
    size_t corners = (size_t)cells->corners, i, j, count = 0;
    for (i = 0; i < cells->count; i++) {
        const paradt_index *cell = cells->vertices + i * corners;
        size_t upper = 0;
        for (j = 0; j < corners; j++) upper += side[cell[j]] & UPPER;
        for (j = 0; j < corners && upper % corners; j++) side[cell[j]] |= ACROSS;
    }
    for (i = 0; i < PARADT__FORETELLING; i++) count += side[i] >= ACROSS;
    return count;
}

// Would the regions give up? Of a sample's points 0.1 to 0.33 have such neighbours where regions pay (scans, a sphere,
// a Gaussian, Plummer's cluster), 0.42 on a torus and nearly all on a cylinder or a helix, where they don't.
static paradt_status paradt__foretell(paradt__work *work, int *in_vain) {
    const paradt__set *set = &work->set;
    paradt__set sample = *set;
    paradt__cells cells;
    paradt__counters counters;
    paradt__progress progress;
    uint64_t hull_facets;
    size_t i;
    unsigned char side[PARADT__FORETELLING];
    paradt_status status = PARADT_OK;
    *in_vain = 0;
    if (set->count < 4 * PARADT__FORETELLING || set->space.weighted) return PARADT_OK;
    memset(&cells, 0, sizeof cells);
    memset(&progress, 0, sizeof progress);
    sample.count = PARADT__FORETELLING;
    sample.records = (double *)paradt__alloc(&work->memory, sample.count, set->width * sizeof(double));
    sample.origin = (paradt_index *)paradt__alloc(&work->memory, sample.count, sizeof *sample.origin);
    if (!sample.records || !sample.origin) status = PARADT_ERROR_MEMORY;
    for (i = 0; i < sample.count && !status; i++) {
        size_t at = (size_t)((double)set->count / (double)sample.count * (double)i);
        paradt__copy_record(sample.records + i * set->width, paradt__record(set, (paradt_index)at), set->width);
        sample.origin[i] = (paradt_index)i;
        side[i] = at < work->cuts.cut[work->regions / 2].begin;
    }
    if (!status && paradt__spans(&sample))
        status = paradt__bowyer_watson(&sample, &work->memory, &cells, 0, &progress, &counters, &hull_facets);
    if (!status) *in_vain = paradt__count_across(&cells, side) > PARADT__FORETELLING / 8 * 3;
    paradt__cells_free(&cells, &work->memory);
    paradt__set_free(&sample, &work->memory);
    return status;
}

// By insertion. When regions in turn give up, the set is left in their order.
static paradt_status paradt__insert_all(paradt__work *work) {
    enum { WORTH = 512 }; // points: with fewer, a sphere is not looked for
    paradt_status status = PARADT_OK;
    int in_vain = 0;
    work->hollow = work->regions > 1 && paradt__is_hollow(&work->set);
    if (work->hollow) status = paradt__foretell(work, &in_vain);
    if (!status && in_vain) work->regions = 1;
    if (!status && work->regions > 1) // for the questions, too
        status = paradt__set_grade(&work->set, PARADT__NEAR_SPHERE, &work->memory);
    else if (!status && work->set.space.dim == 3 && work->set.count >= WORTH)
        status = paradt__set_grade(&work->set, PARADT__GRADE_PAYS, &work->memory);
    if (work->regions == 1) return status ? status : paradt__build_by_insertion(work);
    if (!status) status = paradt__build_regions(work);
    if (status != PARADT__GAVE_UP) return status;
    paradt__close_set(work);
    paradt__begin_again(work);
    work->regions = 1;
    return paradt__build_by_insertion(work);
}

// The cells, by work->method. *sorted: when the points were ready for it.
static paradt_status paradt__build_cells(paradt__work *work, double *sorted) {
    paradt_status status;
    if (work->set.space.dim <= 0) return paradt__build_trivial(work);
    if (!paradt__choose_front(work->method)) return paradt__insert_all(work);
    status = paradt__set_grade(&work->set, PARADT__NEAR_SPHERE, &work->memory);
    if (!status) status = paradt__grid_build(&work->grid, &work->set, &work->memory);
    *sorted = paradt__now();
    if (status) return status;
    return work->regions > 1 ? paradt__build_regions(work) : paradt__build_undivided(work);
}

// AUTO. In four dimensions and more, what insertion makes only to destroy it again costs more than InCoDe's searches,
// unless these have to decide ties.
static paradt_status paradt__build_by_any(paradt__work *work, double *sorted) {
    paradt_status status;
    work->method = work->options.method;
    if (paradt__inserts(work->method, work->set.space.dim) || work->method != PARADT_AUTO)
        return paradt__build_cells(work, sorted);
    work->method = PARADT_INCODE;
    work->impatient = 1;
    status = paradt__build_cells(work, sorted);
    if (status != PARADT__GAVE_UP) return status;
    paradt__begin_again(work);
    if (work->regions > 1) paradt__regions_deal(&work->set, &work->cuts, 0, work->set.count, 0, work->regions);
    work->method = PARADT_BOWYER_WATSON;
    return paradt__build_cells(work, sorted);
}

static paradt_status paradt__build(paradt__work *work, const paradt_points *points, paradt_triangulation *out) {
    double begun = paradt__now(), loaded, sorted;
    paradt__team team;
    paradt_status status;
    paradt__choose_turns(work, points);
    team = paradt__team_of(&work->options, work->regions);
    work->cuts.boxes = work->regions;
    work->cuts.partition = work->options.partition;
    work->cuts.spares = !work->in_turn && paradt__inserts(work->options.method, points->dim);
    work->cuts.opens = !paradt__choose_front(work->options.method);
    out->representative = (paradt_index *)paradt__alloc(&work->memory, points->count, sizeof(paradt_index));
    if (!out->representative) return PARADT_ERROR_MEMORY;
    status =
        paradt__set_load(&work->set, points, &work->cuts, &team, &work->memory, out->representative, &out->error_point);
    if (status) return status;
    work->stats->duplicates = points->count - work->set.count;
    loaded = sorted = paradt__now();
    status = paradt__build_by_any(work, &sorted);
    if (work->options.flags & PARADT_NO_NEIGHBORS && work->cells.neighbors) {
        paradt__release(&work->memory, work->cells.neighbors);
        work->cells.neighbors = NULL;
    }
    if (!status) paradt__translate(work);
    work->stats->seconds_points = loaded - begun;
    work->stats->seconds_grid = sorted - loaded;
    work->stats->seconds_build = paradt__now() - sorted;
    return status;
}

static void paradt__deliver(paradt__work *work, paradt_triangulation *out) {
    paradt__cells *cells = &work->cells;
    out->dim = work->set.space.dim;
    out->cell_count = cells->count;
    out->cells = cells->vertices;
    out->neighbors = cells->neighbors;
    cells->vertices = cells->neighbors = NULL;
}

PARADT_DEF paradt_status paradt_triangulate(paradt_triangulation *out, const paradt_points *points,
                                            const paradt_options *options) {
    paradt__work work;
    paradt_stats stats;
    paradt_status status;
    double begun = paradt__now(), built;
    if (!out) return PARADT_ERROR_ARGUMENT;
    memset(out, 0, sizeof *out);
    if (!points) return PARADT_ERROR_ARGUMENT;
    status = paradt__check_arguments(points, options);
    if (status) return status;
    memset(&work, 0, sizeof work);
    memset(&stats, 0, sizeof stats);
    if (options) work.options = *options;
    paradt__memory_begin(&work.memory, options);
    work.stats = &stats;
    out->point_count = points->count;
    work.regions = work.options.regions ? work.options.regions : 1;
    if (work.regions > points->count) work.regions = points->count ? points->count : 1;
    status = paradt__build(&work, points, out);
    built = paradt__now();
    paradt__release_helpers(&work);
    if (!status) status = paradt__find_hidden(&work, out);
    out->allocator = work.memory.allocator;
    if (!status) {
        paradt__deliver(&work, out);
        stats.cells = out->cell_count;
        stats.regions = work.regions;
    }
    paradt__cells_free(&work.cells, &work.memory);
    paradt__set_free(&work.set, &work.memory);
    paradt__release(&work.memory, work.cuts.cut);
    if (status) {
        size_t bad = out->error_point;
        paradt_free(out);
        out->error_point = bad;
        return status;
    }
    stats.peak_bytes = work.memory.peak;
    stats.seconds_finish = paradt__now() - built;
    stats.seconds = paradt__now() - begun;
    out->stats = stats;
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>remote
//
// What paradt_mpi.h stands on, beside the doors of the sections above: the searches of >>search for cells whose
// vertices need not be points of the set, and one region built alone. A facet or cell is given by the records of its
// vertices, laid out as those of the set (axes permuted alike, the same grade), and measured with it. `own` names those
// of them that are points of the set, or is PARADT__OPEN.
//
// It is only compiled where paradt_mpi.h is implemented.
//
// paradt__remote_cell and paradt__remote_facet set the question: points in conflict with a cell, or strictly beyond a
// hull facet. paradt__remote_boxes, paradt__remote_confined and paradt__remote_any answer it, the first two on the safe
// side, the last exactly. Doors: these, what begins with paradt__remote_engine, paradt__remote_late_order,
// paradt__remote_is_suspect, paradt__remote_owns, paradt__remote_region, paradt__remote_bytes.

#ifdef PARADT_MPI_IMPLEMENTATION
#define PARADT__REMOTE 1

// The question is the conflict with the positively oriented cell. corners, own: [dim + 1]
static void paradt__remote_cell(paradt__search *s, const double *const *corners, const paradt_index *own) {
    paradt_index vertices[PARADT_MAX_DIM + 1];
    int i;
    for (i = 0; i <= s->space.dim; i++) vertices[i] = own[i] >= 0 ? own[i] : (paradt_index)s->set->count;
    paradt__search_sphere(s, corners, vertices);
}

// The question is what lies strictly beyond the facet opposite vertex `opposite` of the positively oriented cell.
static void paradt__remote_facet(paradt__search *s, const double *const *corners, const paradt_index *own,
                                 int opposite) {
    int dim = s->space.dim, i, count = 0;
    for (i = 0; i <= dim; i++) {
        if (i == opposite) continue;
        s->facet[count] = own[i];
        s->corners[count++] = corners[i];
    }
    s->outside = (dim - opposite) % 2 ? 1 : -1;
    s->conflict = s->found = 0;
    s->apex = PARADT__OPEN;
    if (s->space.filtered) paradt__search_facet(s, corners[opposite]);
}

// Which of a group of eight boxes reach strictly beyond the facet? In a box N(u) + its error is at most the sum over
// the axes of the largest of normal_j u_j + reach_j |u_j|, which is convex in u_j. Where that is not positive, nothing
// in the box is beyond: so the many points in the plane of a facet on a flat hull are no candidates.
static unsigned paradt__remote_beyond(const paradt__search *s, const double *group) {
    unsigned mask = 0;
    int lane, j;
    for (lane = 0; lane < PARADT__LANES; lane++) {
        double most = 0.0;
        for (j = 0; j < s->space.dim; j++) {
            double low = group[2 * j * PARADT__LANES + lane] - s->q.origin[j];
            double high = group[(2 * j + 1) * PARADT__LANES + lane] - s->q.origin[j];
            double a = s->q.normal[j] * low + s->q.reach[j] * paradt__abs(low);
            double b = s->q.normal[j] * high + s->q.reach[j] * paradt__abs(high);
            most += a > b ? a : b;
        }
        mask |= (unsigned)(most > 0.0) << lane;
    }
    return mask;
}

// Which of a group of eight boxes, laid out as those of the grid, may hold an answer?
static unsigned paradt__remote_boxes(const paradt__search *s, const double *group) {
    paradt__lane_bounds bounds;
    unsigned mask;
    if (!s->space.filtered) return 255u;
    mask = s->test.group(&s->q, group, &bounds);
    return mask && !s->conflict && s->q.n_floor == 0.0 ? mask & paradt__remote_beyond(s, group) : mask;
}

// Lies the sphere of the cell in the room, so that points outside of it are no answers? room: low and high of each axis
static int paradt__remote_confined(const paradt__search *s, const double *room) {
    return s->space.filtered && paradt__search_within(s, room);
}

// Is the point strictly beyond the facet?
static int paradt__remote_is_beyond(paradt__search *s, size_t point) {
    const double *x = s->set->records + point * s->set->width;
    double n = 0.0, n_bound = 0.0;
    int j;
    for (j = 0; j < s->space.dim && s->space.filtered; j++) {
        double u = x[j] - s->q.origin[j];
        n += s->q.normal[j] * u;
        n_bound += s->q.reach[j] * paradt__abs(u);
    }
    if (s->space.filtered && n + n_bound < s->q.n_floor) return 0;
    if (s->space.filtered && n > n_bound && n > s->q.n_floor) return 1;
    return paradt__search_is_outside(s, x);
}

// A point beyond the facet in the boxes of a group.
static paradt_index paradt__remote_find_beyond(paradt__search *s, int level, size_t group) {
    unsigned mask = paradt__remote_boxes(s, s->grid->boxes[level] + group * s->grid->group_width);
    size_t lane, i, first;
    for (lane = 0; lane < PARADT__LANES && group * PARADT__LANES + lane < s->grid->box_count[level]; lane++) {
        if (!(mask >> lane & 1)) continue;
        first = group * PARADT__LANES + lane;
        if (level) {
            paradt_index found = paradt__remote_find_beyond(s, level - 1, first);
            if (found >= 0) return found;
            continue;
        }
        for (i = first * PARADT__LANES; i < (first + 1) * PARADT__LANES && i < s->set->count; i++) {
            if (paradt__remote_is_beyond(s, i)) return (paradt_index)i;
        }
    }
    return PARADT__OPEN;
}

// A point of the set that answers the question, or PARADT__OPEN: there is none.
static paradt_index paradt__remote_any(paradt__search *s) {
    size_t i;
    if (s->conflict) {
        paradt__search_down(s);
        return s->found ? s->apex : (paradt_index)PARADT__OPEN;
    }
    if (s->space.filtered) return paradt__remote_find_beyond(s, s->grid->levels - 1, 0);
    for (i = 0; i < s->set->count; i++) {
        if (paradt__remote_is_beyond(s, i)) return (paradt_index)i;
    }
    return PARADT__OPEN;
}

// Insertion that can be gone on with: the triangulation of the points so far, ghosts and all. Vertices are positions in
// the set.
typedef struct paradt__remote_engine {
    paradt__bw bw;
    paradt_index *order; // of the insertion of the first points
    // [fringe_capacity] once it is listed, the places of all ghosts and of all cells with others' points; some where
    // such ones have been, and few more than once
    paradt_index *fringe;
    size_t fringe_count, fringe_capacity;
} paradt__remote_engine;

static void paradt__remote_engine_free(paradt__remote_engine *engine, paradt__memory *memory) {
    engine->bw.memory = memory;
    paradt__bw_end(&engine->bw);
    paradt__cells_free(&engine->bw.cells, memory);
    paradt__release(memory, engine->fringe);
    paradt__release(memory, engine->order);
    memset(engine, 0, sizeof *engine);
}

// Inserts all points of the set, of which the first `own`, at least one, are in the order of a curve. It is measured
// with all points that are to come and spans them; if it has sagittas, theirs are known too. low, high: the own points'
// box, as ordered bits
static paradt_status paradt__remote_engine_begin(paradt__remote_engine *engine, const paradt__set *set, size_t own,
                                                 const int64_t *low, const int64_t *high, paradt__memory *memory,
                                                 const paradt__progress *progress) {
    paradt__curve curve;
    memset(engine, 0, sizeof *engine);
    curve.low = low;
    curve.high = high;
    curve.along = own;
    engine->order = paradt__merged_order(set, own, &curve, low, high, memory);
    if (!engine->order) return PARADT_ERROR_MEMORY;
    paradt__bw_begin(&engine->bw, set, engine->order, memory);
    engine->bw.later = (set->count - own) / 6; // of others' points, about so many are still missing
    return paradt__bw_build(&engine->bw, progress);
}

// The order in which to insert points that come late: by rounds, and in each along a curve. A new block, or NULL when
// there is no memory.
static paradt_index *paradt__remote_late_order(const paradt__set *set, paradt__memory *memory) {
    paradt__keyed *keyed = (paradt__keyed *)paradt__alloc(memory, set->count, sizeof *keyed);
    paradt__keyed *other = (paradt__keyed *)paradt__alloc(memory, set->count, sizeof *other);
    paradt_index *order = paradt__round_order(set->count, memory);
    paradt__hilbert hilbert;
    paradt__lattice lattice;
    int dim = set->space.dim, levels = paradt__levels_for(SIZE_MAX, dim);
    size_t i;
    if (keyed && other && order) {
        paradt__hilbert_begin(&hilbert, dim, set->count);
        paradt__lattice_begin(&lattice, dim, levels, 0, set->space.low, set->space.high);
        for (i = 0; i < set->count; i++) {
            keyed[i].point = (paradt_index)i;
            keyed[i].key = paradt__curve_key(&hilbert, &lattice, paradt__record(set, (paradt_index)i));
        }
        paradt__keyed_sort(keyed, other, set->count, dim * levels, 0);
        for (i = 0; i < set->count; i++) order[i] = keyed[order[i]].point;
    } else {
        paradt__release(memory, order);
        order = NULL;
    }
    paradt__release(memory, keyed);
    paradt__release(memory, other);
    return order;
}

// Puts a place on the list of the fringe.
PARADT__INLINE paradt_status paradt__remote_fringe_add(paradt__remote_engine *engine, size_t place) {
    size_t count = engine->fringe_count;
    paradt_status status = paradt__bw_list(&engine->bw, &engine->fringe, count, &engine->fringe_capacity, count + 1);
    if (status) return status;
    engine->bw.marks[place] |= PARADT__LISTED;
    engine->fringe[engine->fringe_count++] = (paradt_index)place;
    return PARADT_OK;
}

// Forgets the list of the fringe, to make it anew.
static void paradt__remote_engine_relist(paradt__remote_engine *engine) {
    size_t i;
    for (i = 0; i < engine->fringe_count; i++) engine->bw.marks[engine->fringe[i]] = 0;
    engine->fringe_count = 0;
    paradt__bw_mark_free(&engine->bw);
}

// Lists the first place of the fringe from *place on, or else makes *place the number of all places. own: so many
// positions are the own points'.
PARADT__INLINE paradt_status paradt__remote_engine_list(paradt__remote_engine *engine, paradt_index own,
                                                        size_t *place) {
    const paradt__cells *cells = &engine->bw.cells;
    *place = cells->corners == 4 ? paradt__bw_fringe_from(cells, 4, own, *place)
                                 : paradt__bw_fringe_from(cells, (size_t)cells->corners, own, *place);
    return *place < cells->count ? paradt__remote_fringe_add(engine, *place) : PARADT_OK;
}

// Lists all of it.
static paradt_status paradt__remote_engine_list_all(paradt__remote_engine *engine, paradt_index own) {
    paradt_status status = PARADT_OK;
    size_t place = 0;
    for (paradt__remote_engine_relist(engine); place < engine->bw.cells.count && !status; place++)
        status = paradt__remote_engine_list(engine, own, &place);
    return status;
}

// Inserts one more point of the set, whose records may have moved. All cells that it makes come to the fringe: many
// where such cells were.
static paradt_status paradt__remote_engine_insert(paradt__remote_engine *engine, const paradt__set *set,
                                                  paradt_index position) {
    paradt__bw *bw = &engine->bw;
    size_t i;
    paradt_status status;
    bw->records = set->records;
    bw->count++;
    status = paradt__bw_insert_one_more(bw, position, -1);
    for (i = 0; i < bw->rim_count && !status; i++) {
        paradt_index made = paradt__bw_made(bw, i);
        if (!(bw->marks[made] & PARADT__LISTED)) status = paradt__remote_fringe_add(engine, (size_t)made);
    }
    return status;
}

// Is a place in use? If by a ghost, *place becomes that of the cell behind its facet, and *facet the facet's number
// there; else *facet is -1.
PARADT__INLINE int paradt__remote_engine_place(const paradt__remote_engine *engine, size_t corners, size_t *place,
                                               int *facet) {
    const paradt__cells *cells = &engine->bw.cells;
    size_t base = *place * corners;
    int ghost;
    *facet = -1;
    if (PARADT__LIKELY(paradt__vertices_among(cells->vertices + base, (int)corners, 0, PARADT__NOWHERE))) return 1;
    if (cells->vertices[base] == PARADT__DEAD) return 0;
    ghost = paradt__bw_ghost(cells->vertices + base, (int)corners);
    *place = (size_t)cells->neighbors[base + (size_t)ghost] / corners;
    *facet = (int)((size_t)cells->neighbors[base + (size_t)ghost] % corners);
    return 1;
}

// May what is at a place of the fringe and has such vertices, `share` of them, be the first in conflict with a point
// that is missing? See >>patches: a ghost, or a cell that has just one of them, or a vertex that is marked. outer:
// the marks, [positions - own] and one more. Without branches, which nothing would foretell.
PARADT__INLINE int paradt__remote_is_suspect(const paradt_index *vertices, size_t corners, paradt_index own, int share,
                                             const unsigned char *outer) {
    int suspect = share == 1;
    size_t j;
    for (j = 0; j < corners; j++) {
        int other = vertices[j] >= own;
        suspect |= (vertices[j] < 0) | (other & outer[other ? vertices[j] - own : 0]);
    }
    return suspect;
}

// The place on the other side of a facet of what is at a place
PARADT__INLINE size_t paradt__remote_engine_across(const paradt__remote_engine *engine, size_t corners, size_t place,
                                                   size_t facet) {
    return (size_t)engine->bw.cells.neighbors[place * corners + facet] / corners;
}

// Marks a place as one to be looked at, until it is unmarked; 0: it is marked already.
PARADT__INLINE int paradt__remote_engine_mark(paradt__remote_engine *engine, size_t place) {
    unsigned char *mark = engine->bw.marks + place;
    if (*mark & PARADT__WAITING) return 0;
    *mark |= PARADT__WAITING;
    return 1;
}

static void paradt__remote_engine_unmark(paradt__remote_engine *engine, size_t place) {
    engine->bw.marks[place] &= (unsigned char)~PARADT__WAITING;
}

// Fetches what is at a place ahead of its use.
PARADT__INLINE void paradt__remote_engine_fetch(const paradt__remote_engine *engine, size_t corners, size_t place) {
    paradt__fetch_row(engine->bw.cells.vertices, engine->bw.cells.neighbors, place, corners);
}

// The same of its vertices' records, and of the marks of what is around it.
PARADT__INLINE void paradt__remote_engine_fetch_around(const paradt__remote_engine *engine, size_t corners,
                                                       size_t place) {
    const paradt_index *vertices = engine->bw.cells.vertices + place * corners;
    size_t i;
    for (i = 0; i < corners; i++) {
        if (vertices[i] >= 0) PARADT__PREFETCH(paradt__bw_record(&engine->bw, vertices[i]));
        PARADT__PREFETCH(engine->bw.marks + paradt__remote_engine_across(engine, corners, place, i));
    }
}

// The vertices of the cell at a place, as positions in the set, and their records.
PARADT__INLINE void paradt__remote_engine_cell(const paradt__remote_engine *engine, size_t corners, size_t place,
                                               paradt_index *vertices, const double **records) {
    size_t i;
    for (i = 0; i < corners; i++) {
        vertices[i] = engine->bw.cells.vertices[place * corners + i];
        records[i] = paradt__bw_record(&engine->bw, vertices[i]);
    }
}

// No more points come: gives all memory back but that of what is at the places, and the marks and lists of these.
static void paradt__remote_engine_rest(paradt__remote_engine *engine, paradt__memory *memory) {
    paradt_index *spare = engine->bw.spare;
    unsigned char *marks = engine->bw.marks;
    paradt__bw_mark_free(&engine->bw);
    engine->bw.spare = NULL;
    engine->bw.marks = NULL;
    paradt__bw_end(&engine->bw);
    paradt__release(memory, engine->order);
    engine->bw.marks = marks;
    engine->bw.cavity = engine->bw.rim = engine->order = NULL;
    engine->bw.ridges = NULL;
    engine->bw.spheres = NULL;
    engine->bw.spare = spare;
}

// What the cells make of a point, by bits: whether it is a vertex of any; of an own one; of none that is dropped, so
// that, if it is a vertex at all, it is one of own cells alone. And whether a later rank has it.
enum {
    PARADT__NO_VERTEX = 0,
    PARADT__VERTEX = 1,
    PARADT__OF_OWN_CELL = 2,
    PARADT__OF_NONE_DROPPED = 4,
    PARADT__OF_LATER_RANK = 8
};

PARADT__INLINE void paradt__mark_vertices(paradt_index *mark, const paradt_index *vertices, size_t corners,
                                          paradt_index bits) {
    size_t j;
    for (j = 0; j < corners; j++) mark[vertices[j]] |= bits;
}

// Is a cell an own one? It is owned by the rank of the highest number that has a vertex of it. own: so many positions
// are the own points'; mark: of all points, says which are a later rank's.
PARADT__INLINE int paradt__remote_owns(const paradt_index *vertices, size_t corners, paradt_index own,
                                       const paradt_index *mark) {
    paradt_index bits = 0;
    int share = 0;
    size_t j;
    for (j = 0; j < corners; j++) {
        share |= vertices[j] < own;
        bits |= mark[vertices[j]];
    }
    return share && !(bits & PARADT__OF_LATER_RANK);
}

// Finds the own cells in the fringe, which becomes the list of what else is there: ghosts and others' cells. These are
// marked as dropped. Returns how many are cells.
PARADT__INLINE uint64_t paradt__remote_engine_judge(paradt__remote_engine *engine, paradt_index own, size_t corners,
                                                    paradt_index *mark) {
    const paradt__cells *cells = &engine->bw.cells;
    size_t count = engine->fringe_count, i, j, left = 0;
    uint64_t others = 0;
    for (i = 0; i < count; i++) {
        paradt_index place = engine->fringe[i];
        const paradt_index *vertices = cells->vertices + (size_t)place * corners;
        int is_cell = paradt__vertices_among(vertices, (int)corners, 0, PARADT__NOWHERE);
        paradt__fetch_listed(cells, engine->fringe, count, i);
        if (vertices[0] == PARADT__DEAD) continue;
        if (is_cell && paradt__remote_owns(vertices, corners, own, mark)) {
            paradt__mark_vertices(mark, vertices, corners, PARADT__VERTEX | PARADT__OF_OWN_CELL);
            continue;
        }
        if (engine->bw.marks[place] & PARADT__DROPPED) continue; // it is in the list twice
        for (j = 0; j < corners && is_cell; j++)
            mark[vertices[j]] = (mark[vertices[j]] | PARADT__VERTEX) & ~PARADT__OF_NONE_DROPPED;
        others += (uint64_t)is_cell;
        engine->bw.marks[place] |= PARADT__DROPPED;
        engine->fringe[left++] = place;
    }
    engine->fringe_count = left;
    return others;
}

// Is a vertex of the cell an own point that was not found to be one of an own cell?
PARADT__INLINE int paradt__remote_engine_leaves(const paradt_index *vertices, size_t corners, paradt_index own,
                                                const paradt_index *mark) {
    int leaves = 0;
    size_t j;
    for (j = 0; j < corners; j++)
        leaves |= vertices[j] >= 0 && vertices[j] < own && mark[vertices[j]] == PARADT__VERTEX;
    return leaves;
}

// Drops what is in the list: behind its facets nothing is then. The cells around a vertex are connected through facets,
// so where some of them are dropped and some are not, two such share one; of those that are not dropped, the ones with
// others' points have had their vertices marked already.
PARADT__INLINE void paradt__remote_engine_drop(paradt__remote_engine *engine, paradt_index own, size_t corners,
                                               paradt_index *mark) {
    paradt__cells *cells = &engine->bw.cells;
    size_t i, j, count = engine->fringe_count;
    for (i = 0; i < count; i++) {
        size_t base = (size_t)engine->fringe[i] * corners;
        paradt__fetch_listed(cells, engine->fringe, count, i);
        for (j = 0; j < corners; j++) {
            paradt_index link = cells->neighbors[base + j];
            const paradt_index *across = cells->vertices + (size_t)link / corners * corners;
            if (PARADT__LIKELY(engine->bw.marks[(size_t)link / corners] & PARADT__DROPPED)) continue;
            cells->neighbors[link] = PARADT__OPEN;
            if (paradt__remote_engine_leaves(cells->vertices + base, corners, own, mark) &&
                paradt__vertices_among(across, (int)corners, 0, own))
                paradt__mark_vertices(mark, across, corners, PARADT__VERTEX | PARADT__OF_OWN_CELL);
        }
    }
    for (i = 0; i < count; i++) cells->vertices[(size_t)engine->fringe[i] * corners] = PARADT__DEAD;
}

PARADT__INLINE uint64_t paradt__remote_engine_drop_others(paradt__remote_engine *engine, paradt_index own,
                                                          size_t corners, paradt_index *mark) {
    uint64_t others = paradt__remote_engine_judge(engine, own, corners, mark);
    paradt__remote_engine_drop(engine, own, corners, mark);
    return others;
}

// Ends an insertion that rests and whose fringe is listed: the own cells, all facets without one on the other side
// open; neighbours are still handles, places * corners + facet. set: of the own points, the first; mark: [positions],
// gets what all cells make of each point; of others' points it says before which are a later rank's. Returns how many
// cells are dropped since others own them.
static uint64_t paradt__remote_engine_end(paradt__remote_engine *engine, const paradt__set *set, paradt__memory *memory,
                                          paradt__cells *cells, paradt_index *mark) {
    paradt__bw *bw = &engine->bw;
    paradt_index own = (paradt_index)set->count;
    size_t end = bw->cells.count, corners = (size_t)bw->cells.corners, i;
    uint64_t others;
    // of points without weights none is hidden
    for (i = 0; i < set->count; i++)
        mark[i] = set->space.weighted ? PARADT__NO_VERTEX : PARADT__VERTEX | PARADT__OF_NONE_DROPPED;
    others = corners == 4 ? paradt__remote_engine_drop_others(engine, own, 4, mark)
                          : paradt__remote_engine_drop_others(engine, own, corners, mark);
    bw->cells.count -= bw->spare_count + engine->fringe_count;
    paradt__bw_fill_gaps(bw, bw->spare, bw->spare_count, &end);
    paradt__bw_fill_gaps(bw, engine->fringe, engine->fringe_count, &end);
    for (i = 0; i < bw->cells.count && set->space.weighted; i++)
        paradt__mark_vertices(mark, bw->cells.vertices + i * corners, corners, PARADT__VERTEX | PARADT__OF_OWN_CELL);
    paradt__release(memory, bw->spare);
    paradt__release(memory, bw->marks);
    paradt__release(memory, engine->fringe);
    *cells = bw->cells;
    memset(engine, 0, sizeof *engine);
    return others;
}

// What paradt__remote_region works with
typedef struct paradt__remote_part {
    paradt__memory memory;
    paradt__set set;
    paradt__grid grid;
    paradt__cuts cuts;
    uint32_t *owner; // [set.count]
    paradt__cells cells;
} paradt__remote_part;

// Builds one region of a loaded set facet by facet.
static paradt_status paradt__remote_front(paradt__remote_part *part, const paradt_options *options, size_t region,
                                          paradt_stats *stats) {
    paradt__set *set = &part->set;
    paradt__memory *memory = &part->memory;
    paradt__region_view view;
    paradt__front front;
    paradt_method method = paradt__choose_front(options->method) ? options->method : PARADT_INCODE;
    paradt_status status;
    part->owner = (uint32_t *)paradt__alloc(memory, set->count, sizeof *part->owner);
    if (!part->owner) return PARADT_ERROR_MEMORY;
    status = paradt__set_grade(set, PARADT__NEAR_SPHERE, memory);
    if (!status) status = paradt__grid_build(&part->grid, set, memory);
    if (status) return status;
    paradt__regions_assign(set, &part->cuts, part->owner);
    view.owner = part->owner;
    view.cuts = &part->cuts;
    view.region = (uint32_t)region;
    status = paradt__front_begin(&front, set, &part->grid, memory, view, 1.0 / (double)options->regions);
    front.progress.call = options->progress;
    front.progress.user = options->user;
    front.progress.length = 1.0;
    if (!status) status = paradt__choose_front(method)(&front);
    paradt__count_front(stats, &front);
    paradt__front_end(&front);
    part->cells = front.cells;
    return status ? status : paradt__region_compact(&part->cells, set, &view, memory, &stats->cells_recomputed);
}

// The cell of a set of one point, in region 0.
static paradt_status paradt__remote_trivial(paradt__remote_part *part, size_t region) {
    paradt_status status;
    part->cells.corners = 1;
    status = paradt__cells_reserve(&part->cells, 1, 1, &part->memory);
    if (status) return status;
    part->cells.count = region ? 0 : part->set.count;
    part->cells.vertices[0] = 0;
    part->cells.neighbors[0] = PARADT__HULL;
    return PARADT_OK;
}

// The bytes that a result holds: each block begins with its size.
static size_t paradt__remote_bytes(const paradt_triangulation *t) {
    const void *blocks[3] = {t->cells, t->neighbors, t->representative};
    size_t bytes, sum = 0;
    int i;
    for (i = 0; i < 3; i++) {
        if (!blocks[i]) continue;
        memcpy(&bytes, (const char *)blocks[i] - PARADT__BLOCK_HEADER, sizeof bytes);
        sum += bytes;
    }
    return sum;
}

// paradt_triangulate for the region `region` of options->regions alone, by InCoDe where the method is neither that nor
// DeWall: `out` gets just the cells that it owns. Their neighbours in other regions are PARADT__OPEN. Hidden points are
// not found: that takes the cells of all regions.
static paradt_status paradt__remote_region(paradt_triangulation *out, const paradt_points *points,
                                           const paradt_options *options, size_t region) {
    paradt__remote_part part;
    paradt__cells *cells = &part.cells;
    paradt_stats stats;
    paradt_status status = PARADT_ERROR_MEMORY;
    double begun = paradt__now();
    size_t i;
    memset(out, 0, sizeof *out);
    memset(&part, 0, sizeof part);
    memset(&stats, 0, sizeof stats);
    paradt__memory_begin(&part.memory, options);
    out->point_count = points->count;
    out->allocator = part.memory.allocator;
    out->representative = (paradt_index *)paradt__alloc(&part.memory, points->count, sizeof(paradt_index));
    part.cuts.boxes = options->regions;
    part.cuts.partition = options->partition;
    if (out->representative)
        status = paradt__set_load(&part.set, points, &part.cuts, &paradt__alone, &part.memory, out->representative,
                                  &out->error_point);
    if (!status)
        status = part.set.space.dim > 0 ? paradt__remote_front(&part, options, region, &stats)
                                        : paradt__remote_trivial(&part, region);
    if (!status) {
        for (i = 0; i < cells->count * (size_t)cells->corners; i++)
            cells->vertices[i] = part.set.origin[cells->vertices[i]];
        out->dim = part.set.space.dim;
        out->cell_count = cells->count;
        out->cells = cells->vertices;
        out->neighbors = cells->neighbors;
        cells->vertices = cells->neighbors = NULL;
        stats.cells = out->cell_count;
        stats.duplicates = points->count - part.set.count;
        stats.peak_bytes = part.memory.peak;
        stats.seconds = paradt__now() - begun;
        out->stats = stats;
    }
    paradt__cells_free(cells, &part.memory);
    paradt__grid_free(&part.grid, &part.memory);
    paradt__release(&part.memory, part.owner);
    paradt__release(&part.memory, part.cuts.cut);
    paradt__set_free(&part.set, &part.memory);
    if (status) {
        i = out->error_point;
        paradt_free(out);
        out->error_point = i;
    }
    return status;
}

#endif // PARADT_MPI_IMPLEMENTATION

// ---------------------------------------------------------------------------------------------------------------------
// >>check
//
// The certificate: whatever the arrays of a triangulation hold, paradt_check accepts exactly those that are T(P). It
// shares with the methods only the reading of points, the predicates and the memory account; it builds nothing that it
// could get wrong in the same way, and it takes linear time (expected: hashing; hidden points are found by short
// walks). Program checking for geometry in this spirit: Mehlhorn, Naeher, Schilz, Schirra, Seel, Seidel and Uhrig,
// "Checking geometric programs or verification of geometric structures", Computational Geometry 12, 1999; Devillers,
// Liotta, Preparata and Tamassia, "Checking the convexity of polytopes and the planarity of subdivisions",
// Computational Geometry 11, 1998. Door: paradt_check.
//
// What is tested, all of it in exact signs (k: the affine dimension, counted anew; o: a place infinitesimally near the
// lexicographically smallest vertex, inside one of its cells):
//   (1) points of equal coordinates have the same representative, the right one, or all are hidden; each
//       representative is a vertex, each vertex is its own representative;
//   (2) each cell is positively oriented;
//   (3) adjacency is an involution on the facets of cells, two neighbours have all but one vertex in common, and their
//       other vertices lie on opposite sides of the facet (given (2), that is the parity of a permutation);
//   (4) across each facet with two cells, the other cell's vertex is no conflict of the cell under the perturbation;
//   (5) each hull facet (one without neighbour) has o strictly on its cell's side;
//   (6) at each ridge of the hull, where two hull facets meet when one turns around it through the cells, neither
//       facet's remaining vertex is beyond the other facet's hyperplane;
//   (7) one cell only contains o;
//   (8) each hidden point lies in a cell with which it is not in conflict.
//
// Why this proves T(P). Choose the infinitesimals of o and of the perturbation as real numbers so small that all the
// finitely many signs stay as they are; "generic" means off the hyperplanes of all facets. Let n(x) be the number of
// cells that contain a generic x. By (2) and (3) n does not change across a facet of two cells: one is lost, one
// gained. Across a hull facet it falls by one to the facet's outside. Facets of the hull are paired at ridges: turning
// around a ridge is an injective map of flags by (3), so it never runs in circles and ends at another hull facet, which
// by (2), (3) has the opposite orientation at the ridge. By (5) the hull is thus star-shaped about o: projected from o
// to the sphere, neighbouring facets lie on opposite sides of their ridge, so the projection covers the sphere equally
// often everywhere, and any generic ray from o crosses the hull n(o) times, each time outward. By (7) that is once, and
// the hull is the boundary of one star-shaped body Q with n = 1 in it and n = 0 outside. A section of Q by a generic
// plane through o is a star-shaped polygon, convex at each corner by (6), so convex; so is Q. Q contains all of P:
// vertices and duplicates by (1), hidden points by (8); so Q = conv(P), and the cells tile it. Let g be the function on
// Q that is affine on each cell and takes the lifted heights at the vertices. Along any generic segment g is
// continuous, as neighbours share a facet's vertices, and strictly convex at each facet crossed, by (4). So the plane
// of any cell lies below g on all of Q, hence below each lifted vertex; below each hidden one by (8), as it is a
// conflict or not by the plane over its own place. With perturbed heights "below" is strict but for the cell's own
// vertices: each cell is a facet of the lower hull of P. Together they tile conv(P), so none is missing; n = 1, so none
// is there twice. Conversely T(P) passes: each of (1) to (8) holds for the lower hull. (For (5), Q's interior contains
// o. Nothing else is needed: a second component would have its own hull around o, and n(o) would be 2.)

enum {
    PARADT__CHECK_PHASES = 5, // those that report progress
    PARADT__CHECK_PACE = 4096 // elements between two calls of it: some milliseconds
};

typedef struct paradt__check {
    const paradt_triangulation *t;
    const paradt_options *options; // may be NULL
    paradt_fault *fault;
    paradt__memory memory;
    paradt__set set;               // the records of all the caller's points, by the caller's index
    size_t corners;                // dim + 1, of a cell
    const paradt_index *neighbors; // t->neighbors or matched
    paradt_index *matched;         // [cell_count][corners] the neighbours found here, or NULL
    paradt_index *cell_of;         // [point_count] a cell of each vertex; -1: no vertex
    const double
        *origin[PARADT_MAX_DIM + 1]; // o: the first moved towards the second, by infinitely less to the third...
    int phase;
} paradt__check;

static paradt_status paradt__check_fail(paradt__check *check, const char *reason, paradt_index cell,
                                        paradt_index point) {
    check->fault->reason = reason;
    check->fault->cell = cell;
    check->fault->point = point;
    return PARADT_ERROR_INVALID;
}

// To be called for each element of a phase.
static paradt_status paradt__check_pace(const paradt__check *check, size_t done, size_t all) {
    const paradt_options *options = check->options;
    double fraction;
    if (done % PARADT__CHECK_PACE || !options || !options->progress) return PARADT_OK;
    fraction = (check->phase + (double)done / (double)all) / (double)PARADT__CHECK_PHASES;
    return options->progress(options->user, fraction) ? PARADT_ERROR_CANCELLED : PARADT_OK;
}

PARADT__INLINE const paradt_index *paradt__check_cell(const paradt__check *check, size_t cell) {
    return check->t->cells + cell * check->corners;
}

static void paradt__check_gather(const paradt__check *check, size_t cell, const double **corners) {
    const paradt_index *vertices = paradt__check_cell(check, cell);
    size_t i;
    for (i = 0; i < check->corners; i++) corners[i] = paradt__record(&check->set, vertices[i]);
}

// In dimension 0 a cell is a point and the empty determinant is 1.
static int paradt__check_orient(paradt__check *check, const double *const *corners) {
    return check->set.space.dim == 0 ? 1 : paradt__orient(&check->set.space, corners);
}

// On which side of the facet opposite `corner` x lies: 1 is the cell's. corners come back as they were.
static int paradt__check_side(paradt__check *check, const double **corners, size_t corner, const double *x) {
    const double *own = corners[corner];
    int side;
    size_t i;
    if (x == own) return 1;
    for (i = 0; i < check->corners; i++)
        if (x == corners[i]) return 0;
    corners[corner] = x;
    side = paradt__check_orient(check, corners);
    corners[corner] = own;
    return side;
}

// --- points: condition (1) up to "is a vertex"

// The predicates' error bounds are those of one dimension
static void paradt__check_set_dim(paradt__check *check, int dim) {
    check->set.space.dim = dim;
    if (dim > 0) paradt__space_end(&check->set.space);
}

// ... and of the coordinates that stand at their places.
static void paradt__check_measure(paradt__check *check, int dim) {
    paradt__space *space = &check->set.space;
    size_t i;
    paradt__space_begin(space, dim, space->ambient, space->weighted);
    for (i = 0; i < check->set.count; i++) paradt__space_add(space, check->set.records + i * check->set.width);
    paradt__check_set_dim(check, dim);
}

static paradt_status paradt__check_read(paradt__check *check, const paradt_points *points) {
    paradt__source source = paradt__source_of(points);
    paradt__set *set = &check->set;
    set->width = (size_t)points->dim + (points->weights != NULL);
    set->records = (double *)paradt__alloc(&check->memory, points->count, set->width * sizeof(double));
    paradt__space_begin(&set->space, points->dim, points->dim, points->weights != NULL);
    if (!set->records) return PARADT_ERROR_MEMORY;
    for (; set->count < points->count; set->count++) {
        int exponent = paradt__read_record(&source, set->count, set->records + set->count * set->width);
        if (exponent > set->exponent) set->exponent = exponent;
        if (exponent < 2047) continue;
        paradt__check_fail(check, "a coordinate or weight is NaN or infinite", -1, (paradt_index)set->count);
        return PARADT_ERROR_NOT_FINITE;
    }
    paradt__set_scale(set);
    paradt__check_measure(check, points->dim);
    return PARADT_OK;
}

// Takes the coordinate at place `axis` of all records to their end; `axis` of them orient.
static void paradt__check_pass_over(paradt__check *check, int axis) {
    size_t i, after = (size_t)(check->set.space.ambient - axis - 1);
    for (i = 0; i < check->set.count; i++) {
        double *record = check->set.records + i * check->set.width + axis, coordinate = *record;
        memmove(record, record + 1, after * sizeof(double));
        record[after] = coordinate;
    }
    paradt__check_measure(check, axis);
}

// The affine dimension. Axes are taken from the first to the last, each that makes the projection to the axes taken
// larger: one point out of the flat of the basis shows it. One that is passed over is an affine function of those
// taken, for all points are then exactly in that flat. In the end the records begin with the axes taken.
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

// The place in the table of the points that have the record's coordinates, or of an empty one.
static size_t paradt__check_place(const paradt__check *check, const paradt_index *table, size_t slots,
                                  const double *record) {
    int ambient = check->set.space.ambient;
    size_t slot = (size_t)paradt__hash_coordinates(record, ambient) & (slots - 1);
    while (table[slot] >= 0 &&
           memcmp(paradt__record(&check->set, table[slot]), record, (size_t)ambient * sizeof(double)))
        slot = (slot + 1) & (slots - 1);
    return slot;
}

// Fills the table with the point that has to stand for its place: the heaviest, then the first.
static void paradt__check_lead(const paradt__check *check, paradt_index *table, size_t slots) {
    const paradt__space *space = &check->set.space;
    size_t i;
    for (i = 0; i < check->set.count; i++) {
        const double *record = paradt__record(&check->set, (paradt_index)i);
        paradt_index *leader = table + paradt__check_place(check, table, slots, record);
        if (*leader < 0 ||
            (space->weighted && paradt__ordered_bits(record[space->ambient]) >
                                    paradt__ordered_bits(paradt__record(&check->set, *leader)[space->ambient])))
            *leader = (paradt_index)i;
    }
}

static paradt_status paradt__check_against_leaders(paradt__check *check, const paradt_index *table, size_t slots) {
    const paradt_index *representative = check->t->representative;
    size_t i;
    for (i = 0; i < check->set.count; i++) {
        paradt_index point = (paradt_index)i, stands = representative[i], leader;
        leader = table[paradt__check_place(check, table, slots, paradt__record(&check->set, point))];
        if ((stands < 0) != (representative[leader] < 0))
            return paradt__check_fail(check, "of points with equal coordinates some are called hidden, some not", -1,
                                      point);
        if (stands >= 0 && stands != leader)
            return paradt__check_fail(
                check, "the representative is not the first of the heaviest with these coordinates", -1, point);
    }
    return PARADT_OK;
}

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
    paradt__check_lead(check, table, slots);
    status = paradt__check_against_leaders(check, table, slots);
    paradt__release(&check->memory, table);
    return status;
}

// --- cells: condition (2), the rest of (1)

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

// The corner of the cell `other` that is not in the facet opposite `corner` of `cell`; -1 when they don't share it.
// place becomes where each vertex is found in the other cell, with the opposite one in the place of `corner`.
static int paradt__check_across(const paradt__check *check, size_t cell, size_t corner, size_t other, size_t *place) {
    const paradt_index *a = paradt__check_cell(check, cell), *b = paradt__check_cell(check, other);
    unsigned left = (1u << check->corners) - 1;
    size_t i, j;
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

// Given that both cells are positively oriented, the vertices opposite a shared facet are on different sides if and
// only if replacing one by the other turns the orientation over.
static int paradt__check_is_odd(const size_t *place, size_t corners) {
    size_t i, j;
    int odd = 0;
    for (i = 0; i < corners; i++)
        for (j = 0; j < i; j++) odd ^= place[j] > place[i];
    return odd;
}

static paradt_status paradt__check_facet(paradt__check *check, size_t cell, size_t corner, const double **corners) {
    paradt_index neighbor = check->neighbors[cell * check->corners + corner];
    size_t place[PARADT_MAX_DIM + 1], other = (size_t)neighbor;
    int opposite;
    if (neighbor < 0) return PARADT_OK;
    opposite = paradt__check_across(check, cell, corner, other, place);
    if (opposite < 0)
        return paradt__check_fail(check, "a cell does not share the facet with the neighbour across it",
                                  (paradt_index)cell, paradt__check_cell(check, cell)[corner]);
    if (check->neighbors[other * check->corners + (size_t)opposite] != (paradt_index)cell)
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

// Looks for the facet of the cell opposite `corner` in the table of facets (numbered cell * corners + corner, plus 1; 0
// is empty). Returns its place there, or the empty one where it belongs.
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

// Adjacency for a triangulation that comes without: cells with equal facets are neighbours.
static paradt_status paradt__check_match(paradt__check *check, size_t *table, size_t slots) {
    size_t cell, corner, corners = check->corners;
    for (cell = 0; cell < check->t->cell_count; cell++) {
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

static paradt_status paradt__check_adjacency(paradt__check *check) {
    size_t facets = check->t->cell_count * check->corners, slots = 16, i, *table;
    paradt_status status;
    check->neighbors = check->t->neighbors;
    if (check->neighbors) {
        for (i = 0; i < facets; i++)
            if (check->neighbors[i] < -1 || check->neighbors[i] >= (paradt_index)check->t->cell_count)
                return paradt__check_fail(check, "a neighbour is no cell", (paradt_index)(i / check->corners), -1);
        return PARADT_OK;
    }
    while (slots < facets + facets / 4) // most facets are there twice and take one place
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

// --- the hull and the covering: conditions (5) to (7)

// Is o on the cell's side of the facet opposite `corner`? The orientation is affine in o, so its sign is that of the
// first of o's vertices that is off the facet; they are not all on it, being those of a cell.
static int paradt__check_holds_origin(paradt__check *check, const double **corners, size_t corner) {
    size_t i;
    int side = 0;
    for (i = 0; i < check->corners && !side; i++) side = paradt__check_side(check, corners, corner, check->origin[i]);
    return side > 0;
}

// The lexicographically smallest vertex is o's first, so most cells are passed by on their first coordinates.
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

// Are all corners on one side of o's first vertex, strictly and along one axis?
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

// The vertex in which the hull facet opposite `corner` of the cell is met, across the ridge without the corner `aside`
// too, by the next hull facet: turns around the ridge from cell to cell. `leave` is the corner whose facet is left
// through, `stay` the one that is not of the ridge and stays. For each flag (cell, leave, stay) there is one before it
// at most, and none before the first, so this ends.
static paradt_index paradt__check_turn(const paradt__check *check, size_t cell, size_t corner, size_t aside) {
    size_t leave = aside, stay = corner, place[PARADT_MAX_DIM + 1];
    for (;;) {
        paradt_index next = check->neighbors[cell * check->corners + leave];
        int opposite;
        if (next < 0) return paradt__check_cell(check, cell)[stay];
        opposite = paradt__check_across(check, cell, leave, (size_t)next, place);
        leave = place[stay];
        stay = (size_t)opposite;
        cell = (size_t)next;
    }
}

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

// The place of x in a Morton order of a grid of 2^bits cells an axis over the box. Only the time of the walks depends
// on it. A box so thin that its width has no inverse is not divided.
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

// The vertices and hidden points, in no order yet. Returns how many there are.
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

// By key, in passes of a digit from the lowest; there are an even number, so the result is in keys again.
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

// Moves *cell to one that contains the point, across facets that have it on their other side. In a regular
// triangulation, which the cells are known to be by now, such a walk never comes back to a cell (Edelsbrunner, "An
// acyclicity theorem for cell complexes in d dimensions", Combinatorica 10, 1990).
static paradt_status paradt__check_walk(paradt__check *check, paradt_index point, paradt_index *cell) {
    const double *corners[PARADT_MAX_DIM + 2], *x = paradt__record(&check->set, point);
    for (;;) {
        size_t corner = 0;
        paradt__check_gather(check, (size_t)*cell, corners);
        while (corner < check->corners && paradt__check_side(check, corners, corner, x) >= 0) corner++;
        if (corner == check->corners) break;
        *cell = check->neighbors[(size_t)*cell * check->corners + corner];
        if (*cell < 0) return paradt__check_fail(check, "a hidden point lies outside of all cells", -1, point);
    }
    corners[check->corners] = x;
    if (paradt__conflict(&check->set.space, corners))
        return paradt__check_fail(check, "a point that is called hidden should be a vertex", *cell, point);
    return PARADT_OK;
}

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

static paradt_status paradt__check_all(paradt__check *check, const paradt_points *points) {
    const paradt_triangulation *t = check->t;
    paradt_status status;
    if (t->point_count != points->count)
        return paradt__check_fail(check, "the triangulation has another number of points", -1, -1);
    if (t->cell_count > (sizeof(paradt_index) == 4 ? (size_t)INT32_MAX : SIZE_MAX / 16))
        return paradt__check_fail(check, "there are more cells than an index can number", -1, -1);
    status = paradt__check_read(check, points);
    if (!status) status = paradt__check_dimension(check);
    if (status) return status;
    if (!points->count)
        return t->cell_count ? paradt__check_fail(check, "there are cells without points", -1, -1) : PARADT_OK;
    status = paradt__check_representatives(check);
    check->phase = 1;
    if (!status) status = paradt__check_cells(check);
    if (!status && !t->cell_count) status = paradt__check_fail(check, "there are points, but no cells", -1, -1);
    if (!status) status = paradt__check_adjacency(check);
    check->phase = 2;
    if (!status) status = paradt__check_facets(check);
    check->phase = 3;
    if (!status) status = paradt__check_hull(check);
    check->phase = 4;
    if (!status) status = paradt__check_hidden(check);
    return status;
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
    if (!triangulation || !points || (triangulation->cell_count && !triangulation->cells) ||
        (triangulation->point_count && !triangulation->representative))
        return PARADT_ERROR_ARGUMENT;
    status = paradt__check_arguments(points, options);
    if (status) return status;
    paradt__memory_begin(&check.memory, options);
    status = paradt__check_all(&check, points);
    paradt__release(&check.memory, check.set.records);
    paradt__release(&check.memory, check.matched);
    paradt__release(&check.memory, check.cell_of);
    return status;
}
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
