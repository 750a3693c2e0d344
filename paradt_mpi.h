// paradt_mpi.h - v0.1.0 - exact Delaunay and regular triangulations on many machines - public domain or MIT-0
//
// paradt.h on the ranks of an MPI communicator. Each rank hands in some of the points and gets some of the cells. All
// ranks together get the cells of paradt_triangulate, each cell once, whatever the number of ranks and whichever rank
// handed in which point.
//
// DO THIS in one C or C++ file of the program. It includes the implementation of paradt.h, so no other file defines
// PARADT_IMPLEMENTATION:
//
//     #define PARADT_MPI_IMPLEMENTATION
//     #include "paradt_mpi.h"
//
// A whole program. Each rank makes a thousand points, and the points of all ranks are triangulated together:
//
//     #define PARADT_MPI_IMPLEMENTATION
//     #include "paradt_mpi.h"
//     #include <stdio.h>
//
//     int main(int argc, char **argv) {
//         static double x[1000][3];
//         paradt_points points = paradt_points_f64(x[0], 1000, 3);
//         paradt_mpi_triangulation t;
//         int rank, i, j;
//         MPI_Init(&argc, &argv);
//         MPI_Comm_rank(MPI_COMM_WORLD, &rank);
//         srand((unsigned)rank);
//         for (i = 0; i < 1000; i++)
//             for (j = 0; j < 3; j++) x[i][j] = rand() / (double)RAND_MAX;
//         if (paradt_mpi_triangulate(&t, MPI_COMM_WORLD, &points, NULL) == PARADT_OK)
//             printf("rank %d has %zu cells of %llu\n", rank, t.cell_count, (unsigned long long)t.cell_total);
//         paradt_mpi_free(&t);
//         MPI_Finalize();
//         return 0;
//     }
//
//     mpicc -O3 -o many many.c -lm && mpiexec -n 4 ./many
//
// It needs MPI 3 and what paradt.h needs. PARADT_STATIC, PARADT_INDEX64 and the other macros of paradt.h apply here
// too; PARADT_DEF stands before each public function.
//
// CONTENTS
//
//     points, result, how it is divided, why the cells are right, replicated points, errors, MPI, memory, cost, limits,
//     changes; the declarations; the implementation in sections marked "// >>name"; the licence
//
//
// POINTS
//
// A rank hands in any part of the points, as to paradt_triangulate: all of them, some, or none. Each point is handed in
// by one rank; if two ranks hand it in, it counts as two points with equal coordinates. Global ids number all points
// consecutively from 0: the points of rank 0 in their order, then those of rank 1, and so on. `dim` must be the same on
// all ranks, also on a rank without points; the type of the coordinates and the stride may differ. Either all ranks
// with points have weights or none has.
//
//
// RESULT
//
// A rank's cells are in `cells`, with k = t.dim + 1 vertices each. A vertex is a position in a table, which has the
// global ids and the coordinates of all vertices of the rank's cells:
//
//     t.cells[i * k + j]                    vertex j of cell i: a position in the table
//     t.vertices[v]                         the global id of vertex v
//     t.coordinates[v * t.ambient + a]      its coordinate on axis a
//     t.neighbors[i * k + j]                the cell opposite vertex j of cell i, or -1 on the hull; see below
//     t.first_cell + i                      the number of cell i
//     t.representative[p]                   of point p that this rank handed in: the global id of the vertex that
//                                           stands for it, or -1 if it is hidden
//
// Cells are numbered through all ranks: this rank has the numbers from first_cell to first_cell + cell_count - 1. A
// neighbour n < cell_count is cell n of this rank. A neighbour n >= cell_count is a cell of another rank, whose number
// is t.others[n - cell_count]. So an array with the values of the own cells, and behind them those of the others'
// cells, can be indexed by neighbours. The number of the cell opposite vertex j of cell i, on whatever rank it is, is
//
//     paradt_mpi_neighbor(&t, i * k + j)
//
// With PARADT_FACETS in options.local.flags, neighbors hold half-facets, as in paradt.h: the position in `neighbors` of
// the same facet as its other cell sees it. Through all ranks, the facet of cell number c opposite its vertex j is the
// half-facet c * k + j. A neighbour n < cell_count * k is a half-facet of this rank, so t.neighbors[n] leads back. A
// neighbour n >= cell_count * k is another rank's half-facet, whose number is t.others[n - cell_count * k], and
// paradt_mpi_neighbor returns the number of the half-facet. t.facets says in which form the neighbours are.
//
// In dimension 0 the only cell is a single vertex and has no facets: neighbors is NULL and hull_facets is 0.
//
// Which rank gets a cell depends on the number of ranks; the union of all ranks' cells does not. The rules for
// duplicates, hidden points, lower dimensions and orientation are those of paradt.h, with global ids in the place of
// indices.
//
// There are three sets of statistics: of this rank, summed over all ranks, and the largest of all ranks. The last two
// are the same on every rank. They are filled also when the call fails.
//
//
// HOW IT IS DIVIDED
//
// Space is cut into as many boxes as there are ranks. A box is halved across the longest extent of its points, in
// proportion to the ranks that its halves are for, until each rank has one: by the number of points (recursive
// coordinate bisection) or by length (PARADT_UNIFORM). Ranks whose boxes are unbounded on more sides have fewer
// neighbours and get some more points. The cut is found by counting, in rounds, so that no rank ever has all points. A
// point on a cut belongs to the upper side. Each rank receives the points of its box, its *own points*, and
// triangulates samples of them. If these predict that some rank has more than 1.25 times the mean work (say, a lattice
// on one rank and points in general position on another, or one point many times), each point gets a weight
// proportional to the work that it takes, at least a quarter of the mean, and space is cut again by weight. Then each
// rank:
//
//     1. sends other ranks those of its points that are close to theirs, and all that are within some margin of their
//        boxes. That is a guess that saves work. It widens the box in which a rank knows all points: its *complete
//        box*;
//     2. triangulates its own points and those it received. Where a cell has points of several ranks for vertices, it
//        sends those of them that are its own to the others. Then it examines the cells that have an own vertex, from
//        the hull and from others' points inwards as far as necessary. Where a point that the rank does not know may be
//        in the cell's sphere, or beyond its hull facet, the rank sends the cell to each rank that may have the point;
//     3. answers for itself: is one of its own points in conflict with a cell that it was sent, by the exact test? If
//        so, it adds those vertices of the cell that are the sender's own points;
//     4. inserts the points that came in steps 2 and 3, if any (by methods other than insertion, or with regions on the
//        rank, it triangulates again), and keeps the cells that have a vertex of its own and none of a rank with a
//        higher number.
//
//
// WHY THE CELLS ARE RIGHT
//
// Let O(r) be the own points of rank r, S(r) the points that it has in step 2, and T(X) the triangulation of X; P are
// all points. Claim: after step 3 each rank s has all points p that are joined to one of its own points q by an edge of
// T(P).
//
// Let p belong to rank r. An edge p q of T(P) is an edge of the triangulation of any subset of P that contains p and q,
// so also of T(S(r) + q).
//
// If q is in S(r), then a cell of T(S(r)) has the vertices p and q, and p was sent to s in step 2.
//
// If q is not in S(r), then inserting q into T(S(r)) makes an edge to p, so q is in conflict with a cell that has the
// vertex p. (The space beyond a hull facet counts as a cell: points strictly beyond the facet are in conflict with it.)
// This cell was sent to s, unless s had been sent all its vertices of O(r) already: floating-point arithmetic only ever
// decides that a point cannot be in a sphere, and a sphere inside the complete box of r does not contain q, as r knows
// all points there. On receipt s found q, or another own point, in conflict with the cell and kept p.
//
// So in step 4 rank s has all vertices of those cells of T(P) that have a vertex q in O(s). No point is in conflict
// with such a cell, so it is a cell of the triangulation on s; and as these cells fill the space around q, there are no
// others. Nothing depends on how much step 1 sent, and nothing is repeated.
//
// With weights, a point may be hidden by points that it has no edge to. Then cells with vertices of other ranks are
// asked about too, a rank also answers with a point that is in conflict with the cell, and steps 2 to 4 are repeated
// until no cell with an own vertex is in conflict with any point.
//
// Points almost on a sphere or in two parallel planes have huge empty spheres, which meet all boxes. Therefore ranks
// tell each other up to 64 boxes around parts of their points, and near a sphere they measure the points from it, as
// paradt.h does.
//
// For some sets the boxes of all ranks meet nearly every sphere, or no box can distinguish the spheres: points exactly
// on a sphere, almost on a line, on a cylinder, on a helix. Where a rank finds that its questions or answers would take
// longer than building all of T(P), all points are sent to all ranks, and each rank builds the whole and keeps its own
// cells. Only then does a rank have more than its own points and those near its border.
//
//
// REPLICATED POINTS
//
// With PARADT_MPI_REPLICATED every rank hands in all points, the same on each rank. No points are sent. Each rank makes
// the cells of its box by InCoDe (by DeWall if that is the method; all others are replaced by InCoDe), like a region of
// paradt.h. The ranks communicate only to agree on errors and to number and link the cells. That is the thesis'
// ParaInCoDe. Global ids are the indices, and representative is the same on all ranks. A build with PARADT_NO_FRONTS
// has no InCoDe, and refuses the flag.
//
//
// ERRORS
//
// All ranks return the same status, that of the first rank that failed. error_rank says which rank that was, error_text
// what went wrong there, and error_point, after PARADT_ERROR_NOT_FINITE, the index of the point there. The statuses are
// those of paradt.h, and also:
//
//     PARADT_ERROR_ARGUMENT    ranks differ in dim, in having weights, in options.flags, or in the flags or the
//                              partition of options.local; or replicated points are not the same
//     PARADT_ERROR_CANCELLED   the progress callback of some rank returned nonzero
//     PARADT_ERROR_FLAT        with PARADT_FULL_DIM in options.local.flags: the points of all ranks together lie in a
//                              flat of lower dimension; the points that one rank hands in may
//
// After an error the result is empty: dim is -1, the arrays are NULL, and there is nothing to free (paradt_mpi_free
// does no harm). error_rank, error_point, error_text and the statistics are filled. After PARADT_ERROR_MEMORY
// stats.needed_bytes is the memory_limit that would have admitted the block that was refused, on the rank that failed;
// largest.needed_bytes tells it to all.
//
// Ranks agree on the status at the end of each step, so a rank that fails waits until the others get there.
//
//
// MPI
//
// The communicator is duplicated at the beginning and the duplicate is freed at the end, so no message can meet one of
// yours. The duplicate has your communicator's error handler; if that lets MPI calls return, the behaviour after a
// failed call is undefined. Concurrent calls from several threads need MPI_THREAD_MULTIPLE and a communicator each. The
// header neither starts nor ends MPI, prints nothing and aborts nothing. Messages are cut into pieces of
// PARADT_MPI_PIECE bytes, so that their sizes fit into an int. All ranks must have the same byte order. Compilers,
// flags and processors may differ between ranks. With PARADT_MPI_REPLICATED the results of floating-point arithmetic
// must not differ, as each rank cuts space by itself.
//
// options.local is for what a rank does alone, which is a paradt_triangulate: method, regions and parallel_for (threads
// within a rank), progress, memory_limit, allocator. It may differ between ranks except for partition and flags. Where
// there are several ranks, PARADT_AUTO chooses insertion in four dimensions as well. A rank's progress callback is told
// how far that rank is in the whole call: a fraction that never falls and is 1 at the end. It is not called while the
// rank waits for others.
//
//
// MEMORY
//
// All memory except MPI's own comes from the rank's options.local.allocator, within its memory_limit. At any time a
// rank has at most its share of the points, those that it handed in, and those near its border. Its share may be up to
// five times the mean where its points weigh little, and more where many are equal or have a coordinate in common. If
// all points are sent to all ranks (see above), each rank has the memory use and the limits of a paradt_triangulate for
// all of them.
//
//
// COST
//
// With n points on p ranks, a rank triangulates its n / p points and those near its border: once by insertion, twice by
// other methods or with regions on the rank, and all n points once more where all are sent. Points are sent to their
// ranks once, or twice where they are weighed. The cuts take O(n / p log p) time and about 8 log2 p reductions each
// time. Each cell is examined once more. What is sent in steps 1 and 2 is proportional to the number of points near the
// border, if points are spread without structure. The number of rounds does not grow with the number of ranks. The
// timers of the statistics, seconds_*, say where the time goes.
//
//
// LIMITS
//
//     a rank    the limits of paradt.h, for its own points and those near its border; for all points where all are sent
//     points    2^63 - 1 in all
//     ranks     as MPI; each rank keeps 65 boxes of every other one
//
//
// CHANGES
//
//     0.1.0  the first version
//

#ifndef PARADT_MPI_H
#define PARADT_MPI_H

#if defined(PARADT_MPI_IMPLEMENTATION) && defined(PARADT_NO_REGIONS)
#error "PARADT_NO_REGIONS leaves out what ranks need"
#endif
#if defined(PARADT_MPI_IMPLEMENTATION) && !defined(PARADT_IMPLEMENTATION)
#define PARADT_IMPLEMENTATION
#endif
#include "paradt.h"

#include <mpi.h>

#ifdef PARADT_INDEX64 // see paradt.h
#define paradt_mpi_triangulate paradt_mpi_triangulate_64
#define paradt_mpi_free        paradt_mpi_free_64
#define paradt_mpi_neighbor    paradt_mpi_neighbor_64
#define paradt_mpi_hash        paradt_mpi_hash_64
#define paradt_mpi_gather      paradt_mpi_gather_64
#endif

#ifdef __cplusplus
extern "C" {
#endif

// paradt_mpi_options.flags
enum { PARADT_MPI_REPLICATED = 1 }; // every rank hands in all points; see REPLICATED POINTS

typedef struct paradt_mpi_options {
    paradt_options local; // for what each rank does alone (see MPI); flags and partition: the same on all ranks
    unsigned flags;       // 0 or PARADT_MPI_REPLICATED, the same on all ranks
} paradt_mpi_options;

// Fields of paradt_mpi_stats: name, meaning. Times are wall time in seconds.
#define PARADT_MPI_COUNTERS(X)                                                                                         \
    X(points, "own points, without duplicates; with replicated points on rank 0 only")                                 \
    X(points_guessed, "points received from others in step 1")                                                         \
    X(points_asked, "points received from others in steps 2 and 3")                                                    \
    X(cells, "cells that this rank owns")                                                                              \
    X(cells_recomputed, "cells of the last local triangulation that other ranks own")                                  \
    X(cells_asked, "questions to other ranks about cells")                                                             \
    X(rounds, "rounds of questions")                                                                                   \
    X(triangulations, "local triangulations made or extended")                                                         \
    X(duplicates, "points with the coordinates of another point")                                                      \
    X(hidden, "weighted points that are no vertex; of equal points one is counted")                                    \
    X(hull_facets, "facets with a cell on one side only; 0 with PARADT_NO_NEIGHBORS")                                  \
    X(bytes_sent, "bytes sent to other ranks in messages; reductions and broadcasts are not counted")                  \
    X(messages_sent, "messages sent to other ranks")                                                                   \
    X(peak_bytes, "largest memory held at one time")                                                                   \
    X(needed_bytes, "after PARADT_ERROR_MEMORY a limit that would have admitted the block refused; else 0")
#define PARADT_MPI_TIMERS(X)                                                                                           \
    X(seconds_partition, "reading the points, cutting space, sending the points to their ranks")                       \
    X(seconds_grid, "sorting the points, sampling, grid, boxes, step 1")                                               \
    X(seconds_build, "triangulating")                                                                                  \
    X(seconds_ask, "questions and answers, waiting for the slowest rank included")                                     \
    X(seconds_finish, "numbering and linking cells, representatives")                                                  \
    X(seconds, "the whole call")

#define PARADT_MPI__COUNTER(name, about) uint64_t name;
#define PARADT_MPI__TIMER(name, about)   double name;
typedef struct paradt_mpi_stats {
    PARADT_MPI_COUNTERS(PARADT_MPI__COUNTER)
    PARADT_MPI_TIMERS(PARADT_MPI__TIMER)
} paradt_mpi_stats;

typedef struct paradt_mpi_triangulation {
    int dim;                    // affine dimension of all points: dim + 1 vertices a cell; -1: no points, or an error
    int ambient;                // coordinates a point
    uint64_t cell_total;        // cells of all ranks
    uint64_t first_cell;        // number of this rank's first cell
    size_t cell_count;          // cells of this rank
    paradt_index *cells;        // [cell_count][dim + 1] positions in `vertices`; cells are positively oriented
    paradt_index *neighbors;    // [cell_count][dim + 1] the cell opposite each vertex: n < cell_count: cell n;
                                // n >= cell_count: others[n - cell_count]; -1: hull. With PARADT_FACETS the half-facet
                                // there: n < cell_count * (dim + 1): n; else others[n - cell_count * (dim + 1)].
                                // NULL with PARADT_NO_NEIGHBORS, in dimension 0, and perhaps where there are no cells
    int facets;                 // 1: neighbors and others are half-facets; 0: cells
    size_t other_count;         // facets with another rank's cell on the other side
    int64_t *others;            // [other_count] the number, through all ranks, of that cell or half-facet
    size_t vertex_count;        // vertices of this rank's cells
    size_t vertex_own;          // the first vertex_own vertices lie in this rank's box; 0 with PARADT_MPI_REPLICATED
    int64_t *vertices;          // [vertex_count] global ids
    double *coordinates;        // [vertex_count][ambient]
    uint64_t point_total;       // points handed in by all ranks; replicated points are counted once
    uint64_t first_point;       // global id of this rank's first point
    size_t point_count;         // points handed in by this rank
    int64_t *representative;    // [point_count] global id of the vertex that stands for the point; -1: hidden
    int error_rank;             // after an error: the first rank that failed
    size_t error_point;         // after PARADT_ERROR_NOT_FINITE: index of the first such point on that rank; else 0
    char error_text[128];       // what went wrong on that rank, the same on all ranks; for ARGUMENT which and why;
                                // empty without an error
    paradt_allocator allocator; // of the arrays
    paradt_mpi_stats stats;     // of this rank; all three are last, so that new counters move nothing
    paradt_mpi_stats sum;       // over all ranks
    paradt_mpi_stats largest;   // of all ranks
} paradt_mpi_triangulation;

// Triangulates the points of all ranks. Collective over comm.
//   out      overwritten, whatever it held; freed by paradt_mpi_free. After an error it is empty: dim is -1, the arrays
//            are NULL; but error_rank, error_point, error_text and the statistics are filled.
//   local    this rank's points; read during the call only; see POINTS.
//   options  NULL: the defaults. flags, local.flags and local.partition must be the same on all ranks.
// Errors, the same on all ranks: ARGUMENT, NOT_FINITE, MEMORY, TOO_LARGE, CANCELLED, FLAT.
// Thread safety: concurrent calls need MPI_THREAD_MULTIPLE, a communicator and an `out` each.
// Cost: see COST and MEMORY.
PARADT_DEF paradt_status paradt_mpi_triangulate(paradt_mpi_triangulation *out, MPI_Comm comm,
                                                const paradt_points *local, const paradt_mpi_options *options);

// Frees this rank's arrays and leaves the triangulation empty: all zero but dim, which is -1. NULL and a zeroed
// triangulation are allowed. Not collective.
// Thread safety: concurrent calls for different triangulations, if the allocator allows them.
PARADT_DEF void paradt_mpi_free(paradt_mpi_triangulation *triangulation);

// Returns the number, through all ranks, of the cell on the other side of a facet, with PARADT_FACETS that of the
// half-facet there; or -1 on the hull.
//   triangulation  with neighbors
//   facet          index in neighbors, i * (dim + 1) + j: the facet of cell i opposite its vertex j
// Not collective. Thread safety: any number of concurrent calls. Cost: constant.
PARADT_DEF int64_t paradt_mpi_neighbor(const paradt_mpi_triangulation *triangulation, size_t facet);

// Returns the hash of the cells of all ranks by global ids, the same on all ranks: that of paradt_hash for the same
// points in the order of their ids. Collective over comm, with the triangulations of all its ranks. No errors.
// Thread safety: concurrent calls need MPI_THREAD_MULTIPLE and a communicator each. Cost: linear in the rank's cells,
// and one reduction.
PARADT_DEF uint64_t paradt_mpi_hash(const paradt_mpi_triangulation *triangulation, MPI_Comm comm);

// Gathers the cells of all ranks on rank `root`, as paradt_triangulate would return them there for all points, in some
// order of cells and with few statistics. Neighbours are half-facets if they are that in the triangulation. Collective
// over comm, which has the ranks of paradt_mpi_triangulate.
//   out            overwritten; freed by paradt_free. Empty on the other ranks and after an error. Then error_text says
//                  what went wrong, and an argument's fault on the rank that has it.
//   triangulation  unchanged. Its allocator serves for *out.
//   root           the same on all ranks
// Errors, the same on all ranks: ARGUMENT, MEMORY, TOO_LARGE (more points or cells than paradt.h's limits allow).
// Thread safety: concurrent calls need MPI_THREAD_MULTIPLE and a communicator each. Cost: on the root linear in all
// cells and points, in time and memory.
PARADT_DEF paradt_status paradt_mpi_gather(paradt_triangulation *out, MPI_Comm comm,
                                           const paradt_mpi_triangulation *triangulation, int root);

#ifdef __cplusplus
}
#endif

#endif // PARADT_MPI_H

// The implementation follows; stop here if you only use the API.
//
// READING THE IMPLEMENTATION. A point's way through the sections, each of which uses only what stands above it:
//
//     rank that hands it in     read into a row (input), sent to the rank whose box it is in (partition)
//     its home                  a record of the set, under a grid (own); perhaps sent again (weigh)
//     other ranks               told which boxes the home has (directory); sent the point if they are close (guess)
//     home and other ranks      triangulated (local). The cells around it are asked about where they could be wrong
//                               (questions), other ranks answer (answers), and it is sent to whoever needs it and
//                               inserted there (others, rounds)
//     rank that owns a cell     a vertex of the result (result)
//
// Beneath are the state of a call (call), messages (talk) and lists of points (lists); replicated, triangulate and
// gather stand at the end. What several ranks must decide alike is said at the head of call, and the numbers that a
// point has there.
//
// Of paradt.h this file uses the ground (memory, numbers, tasks), points from reading to the reference sphere, mesh and
// scene, grid, search and questions, the order of late points, the fringe, methods and triangulate; and known points,
// which exists for this file. It reads the fields of a set and of its space, and writes those that all ranks must have
// alike.

#ifdef PARADT_MPI_IMPLEMENTATION
#ifndef PARADT_MPI__IMPLEMENTED
#define PARADT_MPI__IMPLEMENTED

#ifndef PARADT__RANKS
#error "PARADT_MPI_IMPLEMENTATION must be defined before paradt.h is included with PARADT_IMPLEMENTATION"
#endif

#include <limits.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PARADT_MPI_PIECE
#define PARADT_MPI_PIECE ((size_t)1 << 30) // bytes of a message at most
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>call
//
// The state of one call and what every step of it needs: the caller's options as a step of this rank sees them,
// progress, the account of memory.
//
// A function that calls MPI is collective, and so are its callers: all ranks call it together. A status is either this
// rank's own or agreed, that is, the same on all ranks. A rank that fails alone goes on to the next agreement (see
// >>talk), where the others wait for it. What all ranks must decide alike is decided in integers, from the results of
// reductions; where floating-point arithmetic is needed, rank 0 decides for all.
//
// A point has several numbers:
//
//     id         its global id, the same on all ranks
//     position   the index of its record on this rank, in set.records: the own points first, [0, set.count), then the
//                points received from other ranks, [set.count, known)
//     home       the rank whose box contains it, and its position there: how messages name a point
//     received   its index among the points that this rank received for its box, duplicates included, by ascending id
//     vertex     its index in the result's table of vertices
//
// A place is the index of a cell in the local triangulation, and while points are inserted also of a ghost. The handle
// of a facet is place * (dim + 1) + the number of the opposite vertex. k is the number of vertices a cell, dim + 1;
// inlined functions are called with the constant 4 in three dimensions, so that loops over vertices are unrolled.
//
// Doors: paradt_mpi__begin_step, paradt_mpi__check_cancel, paradt_mpi__local_options, paradt_mpi__add_peak,
// paradt_mpi__refuse.

typedef struct paradt_mpi__home { // what a point is called in messages
    uint64_t id;
    int rank;
    paradt_index position; // among the own points of that rank
} paradt_mpi__home;

typedef struct paradt_mpi__slot { // a point of a rank and a value; rank < 0: free
    int rank;
    paradt_index position;
    paradt_index value;
} paradt_mpi__slot;

typedef struct paradt_mpi__table { // a hash table, by rank and position
    paradt_mpi__slot *slots;
    size_t size, count; // size: 0 or a power of two; count: slots taken
} paradt_mpi__table;

typedef struct paradt_mpi__list { // own points to be sent: `position` to `rank`
    size_t count, capacity;
    paradt_mpi__slot *items; // value is not used
} paradt_mpi__list;

typedef struct paradt_mpi__nearby_rank {
    int rank;
    unsigned beyond; // bit j: all its points lie beyond bound j of this rank's points (order of bounds: low, high of
                     // each axis)
} paradt_mpi__nearby_rank;

typedef struct paradt_mpi__directory {   // what each rank knows of all ranks; boxes in groups of eight, as in >>grid
    double *groups;                      // [ranks][PARADT_MPI__GROUPS][width] boxes around each rank's points
    int *box_count;                      // [ranks] boxes of each
    double *rank_boxes;                  // [ranks / 8, rounded up][width] bounding box of each rank's points
    double *wanted;                      // [ranks][2 dim + 1] each rank's own box, low and high of each axis, and the
                                         // margin around it within which it wants to know all points
    size_t width;                        // doubles a group
    paradt_mpi__nearby_rank *nearby;     // [nearby_count] ranks with points in the vicinity of this rank's
    int nearby_count;                    //
    int *candidates;                     // [ranks] scratch: ranks that may have to be asked about a cell
    double own[2 * PARADT_MAX_DIM];      // bounding box of this rank's points: low and high of each axis
    double vicinity[2 * PARADT_MAX_DIM]; // that box, widened
} paradt_mpi__directory;

typedef struct paradt_mpi__work {
    // the call
    MPI_Comm comm;
    int rank, ranks;
    paradt__memory memory;
    paradt_mpi_options options;
    paradt_mpi_triangulation *out;
    paradt_mpi_stats stats;
    size_t error_point;
    const char *error_text; // of this rank's own error; NULL: what the status says
    paradt_status failed;   // what all ranks agreed on
    double progress_begin;  // the step at hand does this part of the whole work: it begins here,
    double progress_length; // and takes so much
    double progress_told;   // what the callback was told last
    // an exchange
    size_t *to, *from; // [ranks] elements for each rank, and from each
    size_t *next;      // [ranks] where the next element for each rank goes
    // the points
    uint64_t *first;                 // [ranks + 1] id of the first point that each rank handed in
    int dim, weighted;               // as handed in
    int shift;                       // coordinates in the set are multiplied by 2^shift
    uint64_t *received;              // [received_count] ids of the points that this rank got for its box, ascending
    paradt_index *representative;    // [received_count] which of them stands for each
    size_t received_count;           //
    double box_low[PARADT_MAX_DIM];  // this rank's box, on the caller's axes; -FAR and FAR: unbounded
    double box_high[PARADT_MAX_DIM]; //
    paradt__set set;                 // the own points along a curve; others' records stand behind theirs
    int64_t low[PARADT_MAX_DIM];     // bounding box of the own points, as ordered bits
    int64_t high[PARADT_MAX_DIM];    //
    paradt__grid grid;               // over the own points
    paradt__search search;           // in the grid
    int has_grid;                    // there are other ranks, and own points that are not all equal
    // points of other ranks
    size_t known, capacity;              // points in set.records, and places
    paradt_mpi__home *homes;             // [capacity - set.count] of others' points
    paradt_mpi__table lookup;            // others' points: the value is the position
    double complete[2 * PARADT_MAX_DIM]; // low and high of each axis: this rank knows every point inside (strictly)
    // what this rank sent
    int *first_sent;        // [set.count] the first rank that each own point was sent to, or -1
    paradt_mpi__table sent; // further ranks: (rank, position of an own point); no value
    // questions
    paradt_mpi__directory directory;
    uint64_t budget; // work that questions may take: about the number of all ranks' cells
    int too_costly;  // questions or answers exceed it
    // the local triangulation of the known points
    paradt__known engine; // while `inserting`
    int inserting;
    paradt_triangulation local; // made by another method, or at last taken from the engine
    size_t local_bytes;         // that it holds in an account of its own
    paradt__meter meter;        // of the insertion on this rank,
    uint32_t meter_reported;    // all of which is one share
} paradt_mpi__work;

// Begins the next step. end: part of the whole call's work that is done when the step ends, 0..1
static void paradt_mpi__begin_step(paradt_mpi__work *w, double end) {
    w->progress_begin += w->progress_length;
    w->progress_length = end - w->progress_begin;
    PARADT_ASSERT(w->progress_length >= 0.0);
}

// The progress callback of a local triangulation: passes the caller's the fraction of the whole call, which never
// falls, though one step may have several triangulations.
static int paradt_mpi__progress(void *user, double fraction) {
    paradt_mpi__work *w = (paradt_mpi__work *)user;
    fraction = w->progress_begin + fraction * w->progress_length;
    if (fraction > w->progress_told) w->progress_told = fraction < 1.0 ? fraction : 1.0;
    return w->options.local.progress(w->options.local.user, w->progress_told);
}

// Calls the caller's parallel_for with the caller's user pointer: in the options of a local triangulation `user` is the
// work, as the progress callback needs it.
static void paradt_mpi__parallel_for(void *user, size_t count, void (*task)(void *context, size_t index),
                                     void *context) {
    paradt_mpi__work *w = (paradt_mpi__work *)user;
    w->options.local.parallel_for(w->options.local.user, count, task, context);
}

// Reports that a fraction of the step is done. Returns PARADT_ERROR_CANCELLED if the caller wants to stop. Not
// collective.
static paradt_status paradt_mpi__check_cancel(paradt_mpi__work *w, double fraction) {
    return w->options.local.progress && paradt_mpi__progress(w, fraction) ? PARADT_ERROR_CANCELLED : PARADT_OK;
}

// Returns the options of a triangulation on this rank alone: the caller's, with the memory that is left.
static paradt_options paradt_mpi__local_options(paradt_mpi__work *w) {
    paradt_options options = w->options.local;
    if (options.progress) options.progress = paradt_mpi__progress;
    if (options.parallel_for) options.parallel_for = paradt_mpi__parallel_for;
    options.user = w;
    options.flags = PARADT_FACETS; // with neighbours: hull facets are known by them
    if (options.memory_limit) {
        uint64_t left = w->memory.limit > w->memory.held ? w->memory.limit - w->memory.held : 0;
        options.memory_limit = left ? (size_t)left : 1;
    }
    return options;
}

// Raises the rank's peak by that of a triangulation that was made with an account of its own, and adopts what it would
// have needed.
static void paradt_mpi__add_peak(paradt_mpi__work *w, const paradt_triangulation *t) {
    uint64_t peak = w->memory.held + t->stats.peak_bytes;
    if (peak > w->memory.peak) w->memory.peak = peak;
    if (t->stats.needed_bytes) w->memory.needed = w->memory.held + t->stats.needed_bytes;
}

// Returns an error of this rank's own, of which the result will say why.
static paradt_status paradt_mpi__refuse(paradt_mpi__work *w, paradt_status status, const char *text) {
    w->error_text = text;
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>talk
//
// How ranks agree on errors and send each other data of variable size. All functions are collective except those that
// move bits and paradt_mpi__set_offsets. Once an agreement fails, every later one returns the same status without
// communication; nothing is sent in an exchange after any rank has failed. Ids and other integers travel among doubles
// as their bits, which are only ever copied. An exchange is one all-to-all of counts and then point-to-point messages,
// as only few pairs of ranks have data for each other.
//
// Doors: paradt_mpi__agree, paradt_mpi__reduce_min, paradt_mpi__reduce_sum, paradt_mpi__exchange,
// paradt_mpi__exchange_into, paradt_mpi__set_offsets, paradt_mpi__load_bits, paradt_mpi__store_bits.

// Returns the status of the first rank whose status is an error, on all ranks; PARADT_OK if there is none. After an
// error the result says which rank that is, and what is wrong there. status: of this rank.
static paradt_status paradt_mpi__agree(paradt_mpi__work *w, paradt_status status) {
    int mine = status ? w->rank : INT_MAX, first;
    const char *text = w->error_text ? w->error_text : paradt_status_string(status);
    int64_t error[2];
    PARADT_ASSERT(w->rank >= 0 && w->rank < w->ranks);
    if (w->failed) return w->failed;
    MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, w->comm);
    if (first == INT_MAX) return PARADT_OK;
    error[0] = status;
    error[1] = (int64_t)w->error_point;
    MPI_Bcast(error, 2, MPI_INT64_T, first, w->comm);
    w->out->error_rank = first;
    w->out->error_point = (size_t)error[1];
    PARADT_ASSERT(strlen(text) < sizeof w->out->error_text);
    strncpy(w->out->error_text, text, sizeof w->out->error_text - 1);
    MPI_Bcast(w->out->error_text, (int)sizeof w->out->error_text, MPI_BYTE, first, w->comm);
    w->failed = (paradt_status)error[0];
    return w->failed;
}

// Replaces each of the `count` facts by the smallest that any rank has.
static void paradt_mpi__reduce_min(paradt_mpi__work *w, int64_t *facts, int count) {
    MPI_Allreduce(MPI_IN_PLACE, facts, count, MPI_INT64_T, MPI_MIN, w->comm);
}

// Returns the sum of all ranks' x.
static uint64_t paradt_mpi__reduce_sum(paradt_mpi__work *w, uint64_t x) {
    MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_UINT64_T, MPI_SUM, w->comm);
    return x;
}

// Returns the number of messages for so many bytes.
static size_t paradt_mpi__piece_count(size_t bytes) {
    return bytes / PARADT_MPI_PIECE + (bytes % PARADT_MPI_PIECE != 0);
}

// Starts to send the data to rank `other`, or to receive them from there, in pieces; MPI keeps messages between two
// ranks in order. Returns the next free request.
static MPI_Request *paradt_mpi__start_pieces(paradt_mpi__work *w, char *data, size_t bytes, int other, int sends,
                                             MPI_Request *request) {
    while (bytes) {
        size_t piece = bytes < PARADT_MPI_PIECE ? bytes : PARADT_MPI_PIECE;
        if (sends) MPI_Isend(data, (int)piece, MPI_BYTE, other, 0, w->comm, request);
        else MPI_Irecv(data, (int)piece, MPI_BYTE, other, 0, w->comm, request);
        w->stats.bytes_sent += sends ? piece : 0;
        w->stats.messages_sent += (uint64_t)sends;
        request++;
        data += piece;
        bytes -= piece;
    }
    return request;
}

// Sends and receives all elements of an exchange, w->to and w->from. requests: one a piece, own data excepted.
static void paradt_mpi__transfer(paradt_mpi__work *w, const char *send, char *receive, size_t size,
                                 MPI_Request *requests) {
    MPI_Request *next = requests;
    size_t out = 0, in = 0;
    int r;
    for (r = 0; r < w->ranks; r++) {
        size_t sent = w->to[r] * size, got = w->from[r] * size;
        if (r == w->rank) {
            if (sent) memcpy(receive + in, send + out, sent);
        } else {
            next = paradt_mpi__start_pieces(w, receive + in, got, r, 0, next);
            next = paradt_mpi__start_pieces(w, (char *)(uintptr_t)(send + out), sent, r, 1, next);
        }
        out += sent;
        in += got;
    }
    while (next > requests) MPI_Wait(--next, MPI_STATUS_IGNORE);
}

// Sends w->to[r] elements of `size` bytes to each rank r and receives w->from[r] elements from each. Returns the agreed
// status.
//   status    of this rank so far. If any rank has failed, nothing is sent.
//   send      the elements, those for rank 0 first
//   *receive  NULL, or a block for *count elements that may be used; replaced by the elements received, those from
//             rank 0 first, in a block that the caller releases; NULL after an error. The given block is used unless it
//             is too small or more than twice as large as needed.
//   *count    replaced by the number of elements received
static paradt_status paradt_mpi__exchange_into(paradt_mpi__work *w, paradt_status status, const void *send, size_t size,
                                               void **receive, size_t *count) {
    MPI_Request *requests = NULL;
    size_t pieces = 0, total = 0;
    int r;
    PARADT_ASSERT(size > 0);
    for (r = 0; r < w->ranks && status; r++) w->to[r] = 0;
    MPI_Alltoall(w->to, (int)sizeof *w->to, MPI_BYTE, w->from, (int)sizeof *w->from, MPI_BYTE, w->comm);
    for (r = 0; r < w->ranks; r++) {
        total += w->from[r];
        if (r != w->rank)
            pieces += paradt_mpi__piece_count(w->to[r] * size) + paradt_mpi__piece_count(w->from[r] * size);
    }
    if (*receive && (total > *count || total < *count / 2)) {
        paradt__release(&w->memory, *receive);
        *receive = NULL;
    }
    if (!status) {
        if (!*receive) *receive = paradt__alloc(&w->memory, total, size);
        if (*receive) paradt__make_pages(*receive, 0, total * size);
        requests = (MPI_Request *)paradt__alloc(&w->memory, pieces, sizeof *requests);
        if (!*receive || !requests) status = PARADT_ERROR_MEMORY;
    }
    status = paradt_mpi__agree(w, status);
    if (!status) paradt_mpi__transfer(w, (const char *)send, (char *)*receive, size, requests);
    paradt__release(&w->memory, requests);
    *count = total;
    if (status) {
        paradt__release(&w->memory, *receive);
        *receive = NULL;
    }
    return status;
}

// As paradt_mpi__exchange_into, always with a new block.
static paradt_status paradt_mpi__exchange(paradt_mpi__work *w, paradt_status status, const void *send, size_t size,
                                          void **receive, size_t *count) {
    *receive = NULL;
    return paradt_mpi__exchange_into(w, status, send, size, receive, count);
}

// Sets w->next[r] to the number of elements for ranks before r, from w->to: a counting sort by rank starts with this.
static void paradt_mpi__set_offsets(paradt_mpi__work *w) {
    size_t next = 0;
    int r;
    PARADT_ASSERT(w->to && w->next);
    for (r = 0; r < w->ranks; r++) {
        w->next[r] = next;
        next += w->to[r];
    }
}

// Returns the integer whose bits are at x.
static uint64_t paradt_mpi__load_bits(const double *x) {
    uint64_t bits;
    memcpy(&bits, x, sizeof bits);
    return bits;
}

// Writes the bits of an integer to x.
static void paradt_mpi__store_bits(double *x, uint64_t bits) {
    memcpy(x, &bits, sizeof bits);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>lists
//
// Lists of own points to be sent and hash tables of points by (rank, position), with linear probing and at most half of
// the slots taken. They also keep account of which own points were sent to which rank: nearly every point near a border
// goes to one rank only, which is noted in an array; the table has the further ones. Nothing here is collective.
//
// Doors: paradt_mpi__reserve_one, paradt_mpi__list_add, paradt_mpi__list_unsent, paradt_mpi__was_sent,
// paradt_mpi__table_reserve, paradt_mpi__table_put.

// Makes sure that a list can take one more item. Returns the items, or NULL when there is no memory.
static void *paradt_mpi__reserve_one(paradt_mpi__work *w, void *items, size_t count, size_t *capacity, size_t size) {
    size_t larger = *capacity * 2 + 64;
    PARADT_ASSERT(count <= *capacity);
    if (count < *capacity) return items;
    if (!paradt__grow(&w->memory, &items, count, larger, size)) return NULL;
    *capacity = larger;
    return items;
}

// Adds an own point to a list of points to be sent.
static paradt_status paradt_mpi__list_add(paradt_mpi__work *w, paradt_mpi__list *list, int rank,
                                          paradt_index position) {
    void *items = paradt_mpi__reserve_one(w, list->items, list->count, &list->capacity, sizeof *list->items);
    PARADT_ASSERT(rank >= 0 && rank < w->ranks && (size_t)position < w->set.count);
    if (!items) return PARADT_ERROR_MEMORY;
    list->items = (paradt_mpi__slot *)items;
    list->items[list->count].rank = rank;
    list->items[list->count++].position = position;
    return PARADT_OK;
}

// Returns the slot of a point, or the free slot where the point belongs. The table is not empty.
static paradt_mpi__slot *paradt_mpi__table_find(const paradt_mpi__table *table, int rank, paradt_index position) {
    size_t i = (size_t)paradt__mix((uint64_t)rank << 40 ^ (uint64_t)position) & (table->size - 1);
    PARADT_ASSERT(table->count < table->size);
    for (;; i = (i + 1) & (table->size - 1)) {
        paradt_mpi__slot *slot = table->slots + i;
        if (slot->rank < 0 || (slot->rank == rank && slot->position == position)) return slot;
    }
}

// Enlarges a table so that `more` points leave at least half of its slots free.
static paradt_status paradt_mpi__table_reserve(paradt_mpi__work *w, paradt_mpi__table *table, size_t more) {
    paradt_mpi__table larger;
    size_t i;
    if ((table->count + more) * 2 < table->size) return PARADT_OK;
    larger.count = table->count;
    for (larger.size = 64; larger.size < (table->count + more) * 3;) larger.size *= 2;
    larger.slots = (paradt_mpi__slot *)paradt__alloc(&w->memory, larger.size, sizeof *larger.slots);
    if (!larger.slots) return PARADT_ERROR_MEMORY;
    for (i = 0; i < larger.size; i++) larger.slots[i].rank = -1;
    for (i = 0; i < table->size; i++) {
        const paradt_mpi__slot *slot = table->slots + i;
        if (slot->rank >= 0) *paradt_mpi__table_find(&larger, slot->rank, slot->position) = *slot;
    }
    paradt__release(&w->memory, table->slots);
    *table = larger;
    return PARADT_OK;
}

// Adds a point to a table that has a slot for it. Returns 1 if the point was there already; its value stays then.
static int paradt_mpi__table_put(paradt_mpi__table *table, int rank, paradt_index position, paradt_index value) {
    paradt_mpi__slot *slot = paradt_mpi__table_find(table, rank, position);
    PARADT_ASSERT(rank >= 0);
    if (slot->rank >= 0) return 1;
    slot->rank = rank;
    slot->position = position;
    slot->value = value;
    table->count++;
    return 0;
}

// Was the own point sent to the rank, or listed to be sent?
static int paradt_mpi__was_sent(const paradt_mpi__work *w, int rank, paradt_index position) {
    int first = w->first_sent[position];
    return first == rank || (first >= 0 && w->sent.size && paradt_mpi__table_find(&w->sent, rank, position)->rank >= 0);
}

// Lists an own point for a rank unless it was sent or listed before.
static paradt_status paradt_mpi__list_unsent(paradt_mpi__work *w, paradt_mpi__list *list, int rank,
                                             paradt_index position) {
    paradt_status status;
    if (w->first_sent[position] == rank) return PARADT_OK;
    if (w->first_sent[position] < 0) {
        w->first_sent[position] = rank;
        return paradt_mpi__list_add(w, list, rank, position);
    }
    status = paradt_mpi__table_reserve(w, &w->sent, 1);
    if (!status && !paradt_mpi__table_put(&w->sent, rank, position, 0))
        status = paradt_mpi__list_add(w, list, rank, position);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>input
//
// From the caller's arguments to rows: checks that the ranks agree, numbers the points, and reads each into a row of
// dim + weighted + 1 doubles: the coordinates, the weight if there are weights, and the bits of the id.
//
// Doors: paradt_mpi__check_arguments, paradt_mpi__number_points, paradt_mpi__read_points.

// Checks this rank's arguments. Not collective.
static paradt_status paradt_mpi__check_own(paradt_mpi__work *w, const paradt_points *local) {
    const char *text;
    paradt_status status = paradt__check_arguments(local, &w->options.local, &text);
    if (status) return paradt_mpi__refuse(w, status, text);
    if (w->options.flags & ~(unsigned)PARADT_MPI_REPLICATED)
        return paradt_mpi__refuse(w, PARADT_ERROR_ARGUMENT, "options.flags has a bit other than PARADT_MPI_REPLICATED");
    if (w->options.local.flags & PARADT_FURTHEST_SITE)
        return paradt_mpi__refuse(w, PARADT_ERROR_ARGUMENT,
                                  "options.local.flags has PARADT_FURTHEST_SITE, which ranks do not build");
#ifdef PARADT_NO_FRONTS
    if (w->options.flags & PARADT_MPI_REPLICATED)
        return paradt_mpi__refuse(w, PARADT_ERROR_ARGUMENT,
                                  "PARADT_MPI_REPLICATED is left out of this build, by PARADT_NO_FRONTS");
#endif
    return PARADT_OK;
}

// Returns what differs from the arguments of rank 0 and must not; NULL: nothing. Collective.
static const char *paradt_mpi__difference(paradt_mpi__work *w, const paradt_points *local) {
    int64_t facts[5];
    facts[0] = local->dim;
    facts[1] = w->options.flags;
    facts[2] = w->options.local.flags;
    facts[3] = w->options.local.partition;
    facts[4] = (int64_t)local->count;
    MPI_Bcast(facts, 5, MPI_INT64_T, 0, w->comm);
    if (facts[0] != local->dim) return "points.dim is not that of rank 0";
    if (facts[1] != (int64_t)w->options.flags) return "options.flags are not those of rank 0";
    if (facts[2] != (int64_t)w->options.local.flags) return "options.local.flags are not those of rank 0";
    if (facts[3] != (int64_t)w->options.local.partition) return "options.local.partition is not that of rank 0";
    if (w->options.flags & PARADT_MPI_REPLICATED && facts[4] != (int64_t)local->count)
        return "points.count is not that of rank 0, but the points are to be replicated";
    return NULL;
}

// Checks the arguments of all ranks and sets w->dim and w->weighted. Returns the agreed status: ARGUMENT where ranks
// differ in what must be the same. status: of this rank so far.
static paradt_status paradt_mpi__check_arguments(paradt_mpi__work *w, const paradt_points *local,
                                                 paradt_status status) {
    int64_t weights;
    const char *difference;
    if (!status) status = paradt_mpi__check_own(w, local);
    status = paradt_mpi__agree(w, status);
    if (status) return status;
    difference = paradt_mpi__difference(w, local);
    weights = local->count && local->weights ? -1 : 0;
    paradt_mpi__reduce_min(w, &weights, 1);
    w->dim = local->dim;
    w->weighted = weights < 0;
    if (!difference && w->weighted && local->count && !local->weights)
        difference = "points.weights is NULL, but points of other ranks have weights";
    return paradt_mpi__agree(w, difference ? paradt_mpi__refuse(w, PARADT_ERROR_ARGUMENT, difference) : PARADT_OK);
}

// Sets w->first, [ranks + 1], from the number of points that each rank handed in. Collective.
static void paradt_mpi__number_points(paradt_mpi__work *w, size_t count) {
    uint64_t mine = count, next = 0;
    int r;
    MPI_Allgather(&mine, 1, MPI_UINT64_T, w->first, 1, MPI_UINT64_T, w->comm);
    for (r = 0; r <= w->ranks; r++) {
        uint64_t here = r < w->ranks ? w->first[r] : 0;
        w->first[r] = next;
        next += here;
    }
    PARADT_ASSERT(w->first[w->rank + 1] - w->first[w->rank] == count);
}

// Reads this rank's points into *rows, which the caller releases. Not collective.
static paradt_status paradt_mpi__read_points(paradt_mpi__work *w, const paradt_points *local, double **rows) {
    paradt__source source = paradt__source_of(local);
    size_t width = (size_t)w->dim + (size_t)w->weighted, i;
    PARADT_ASSERT(local->dim == w->dim);
    *rows = (double *)paradt__alloc_filled(&w->memory, local->count, (width + 1) * sizeof **rows);
    if (!*rows) return PARADT_ERROR_MEMORY;
    for (i = 0; i < local->count; i++) {
        double *row = *rows + i * (width + 1);
        if (i % PARADT__PACE == 0 && paradt_mpi__check_cancel(w, (double)i / (double)local->count))
            return PARADT_ERROR_CANCELLED;
        if (paradt__read_record(&source, i, row) == 2047) {
            w->error_point = i;
            return PARADT_ERROR_NOT_FINITE;
        }
        paradt_mpi__store_bits(row + width, w->first[w->rank] + i);
    }
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>partition
//
// Cuts space into a box a rank and sends each row to the rank of its box (recursive coordinate bisection, the adaptive
// partition of the thesis, chapter 6). In each step all boxes with several ranks are halved together. A cut is the
// coordinate below which the lower half's ranks have the weight that they should have: a proportional share of the
// points' weight, corrected where they border on fewer neighbours than the upper half's ranks or on more.
//
// A cut is found in rounds, as a radix search over all ranks: the interval that contains the cut is divided into 256
// parts, the weight in each part is summed over all ranks, and the part with the cut is the interval of the next round.
// The rows in it are the undecided ones. The search ends when their weight is within the tolerance or they all have one
// coordinate; then all of them go to the side that comes nearer to what is wanted. The parts of the first round have
// equal length; those of later rounds have equally many values of the ordered bits, so that nine rounds suffice for any
// coordinates.
//
// Each rank keeps its rows in the order of the boxes, so that those of a box are contiguous; the final order is that of
// the ranks.
//
// Door: paradt_mpi__partition.

enum {
    PARADT_MPI__PART_BITS = 8,
    PARADT_MPI__PARTS = 1 << PARADT_MPI__PART_BITS // into which an interval is divided in a round
};

typedef struct paradt_mpi__box {
    int first, ranks;             // it becomes the boxes of the ranks [first, first + ranks)
    int64_t from[PARADT_MAX_DIM]; // the box: from <= ordered bits < to; INT64_MIN and INT64_MAX: unbounded
    int64_t to[PARADT_MAX_DIM];   //
    int64_t low[PARADT_MAX_DIM];  // bounding box of all ranks' points in it; on the axis, of the undecided ones alone
    int64_t high[PARADT_MAX_DIM]; //
    int axis;                     // across which it is cut
    double origin, scale;         // part of x in the first round: (x / 2 - origin) * scale; scale 0: by ordered bits
    uint64_t weight_wanted;       // of the lower half's points
    uint64_t weight_below;        // of the points known to be below the cut
    uint64_t weight_undecided;    // of the points that may be on either side
    uint64_t tolerance;           // the search ends when no more weight than this is undecided
    unsigned part;                // the part with the cut, in the last round
    int64_t cut;                  // ordered bits of the upper half's first coordinate; PARADT_UNIFORM sets it directly
    size_t begin, end;            // this rank's rows in the box
    size_t undecided;             // how many of these may be on either side
    int listed;                   // the undecided rows are listed in the cutter; else they are all of these
} paradt_mpi__box;

// Cost of a side of a rank's box that borders on others, in layers of own points: points received across the side,
// questions about them, and cells that are dropped in the end. Measured.
#define PARADT_MPI__LAYERS 1.6

// The tolerance of a cut is a rank's proportional weight divided by this: with less, another round would cost more than
// it saves.
enum { PARADT_MPI__PRECISION = 1024 };

typedef struct paradt_mpi__cutter {
    double *rows;           // [count][width]
    double *spare;          // [capacity][width] rows above the cut while a box is halved; in the end the rows received
    size_t capacity;        // rows of `spare`
    size_t paged;           // rows of `spare` whose memory pages exist
    size_t count, width;    //
    uint64_t weight, mean;  // weight of each row of this rank, and of a row that takes the mean work
    size_t *undecided;      // [count] the undecided rows of each listed box, from the box's `begin` on
    unsigned char *parts;   // [count] the part of each undecided row, likewise
    paradt_mpi__box *boxes; // [ranks]
    int box_count;          //
    uint64_t *counts;       // [ranks][PARADT_MPI__PARTS] weight of each part of each box; or [ranks] of each box
    int64_t *facts;         // [ranks][2 * PARADT_MAX_DIM] scratch of reductions: bounds of points, or aims
} paradt_mpi__cutter;

// Prefetches a row: its first and last double, as these may lie in two cache lines.
PARADT__INLINE void paradt_mpi__fetch_row(const paradt_mpi__cutter *c, size_t point) {
    PARADT__FETCH(c->rows, point * c->width);
    PARADT__FETCH(c->rows, (point + 1) * c->width - 1);
}

// Widens bounds by x. bounds[0] is the smallest of the ordered bits, bounds[1] is ~ of the largest: ~ reverses the
// order and cannot overflow, so that one reduction by minimum serves both.
PARADT__INLINE void paradt_mpi__bound_bits(int64_t *bounds, int64_t x) {
    bounds[0] = x < bounds[0] ? x : bounds[0];
    bounds[1] = ~x < bounds[1] ? ~x : bounds[1];
}

// Widens bounds by the rows of a box on one axis, comparing bits.
static void paradt_mpi__bound_axis(const paradt_mpi__cutter *c, const paradt_mpi__box *box, size_t axis,
                                   int64_t *bounds) {
    size_t i;
    for (i = box->begin; i < box->end; i++)
        paradt_mpi__bound_bits(bounds, paradt__ordered_bits(c->rows[i * c->width + axis]));
}

// Sets bounds, [dim][2], to those of this rank's rows in a box. Where the processor takes subnormals for zero,
// comparisons of doubles cannot tell them apart; so an axis with a bound near zero is bounded by bits.
PARADT__INLINE void paradt_mpi__bound_rows(const paradt_mpi__cutter *c, const paradt_mpi__box *box, size_t dim,
                                           int64_t *bounds) {
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    size_t i, j;
    for (j = 0; j < 2 * dim; j++) bounds[j] = INT64_MAX;
    if (box->begin == box->end) return;
    for (j = 0; j < dim; j++) low[j] = high[j] = c->rows[box->begin * c->width + j];
    for (i = box->begin + 1; i < box->end; i++) {
        const double *row = c->rows + i * c->width;
        paradt_mpi__fetch_row(c, i + PARADT__POINTS_AHEAD);
        for (j = 0; j < dim; j++) {
            low[j] = row[j] < low[j] ? row[j] : low[j];
            high[j] = row[j] > high[j] ? row[j] : high[j];
        }
    }
    for (j = 0; j < dim; j++) {
        bounds[2 * j] = paradt__ordered_bits(low[j]);
        bounds[2 * j + 1] = ~paradt__ordered_bits(high[j]);
        if (!paradt__biased_exponent(low[j]) || !paradt__biased_exponent(high[j]))
            paradt_mpi__bound_axis(c, box, j, bounds + 2 * j);
    }
}

// Moves the rows of a box that are below its cut before the others; both keep their order. Returns the first row above
// the cut. The side is unpredictable, so instead of branching each row is written to both.
PARADT__INLINE size_t paradt_mpi__split_rows(paradt_mpi__cutter *c, const paradt_mpi__box *box, size_t width) {
    enum { PAGED = 1 << 12 };
    double *rows = c->rows + box->begin * width;
    size_t i = 0, lower = 0, upper = 0, count = box->end - box->begin;
    const int64_t cut = box->cut;
    while (i < count) {
        size_t end = count - i < PAGED ? count : i + PAGED, above_at_most = upper + end - i;
        if (above_at_most > c->paged) {
            paradt__make_pages(c->spare, c->paged * width * sizeof *rows, above_at_most * width * sizeof *rows);
            c->paged = above_at_most;
        }
        for (; i < end; i++) {
            const double *row = rows + i * width;
            double *above = c->spare + upper * width;
            size_t is_above = paradt__ordered_bits(row[box->axis]) >= cut;
            paradt_mpi__fetch_row(c, box->begin + i + PARADT__POINTS_AHEAD);
            memcpy(above, row, width * sizeof *row);
            memcpy(rows + lower * width, above, width * sizeof *row);
            upper += is_above;
            lower += is_above ^ 1;
        }
    }
    if (upper) memcpy(rows + lower * width, c->spare, upper * width * sizeof *rows);
    return box->begin + lower;
}

// Sets low and high of all boxes from the ranks' bounds, c->facts. Collective.
static void paradt_mpi__agree_bounds(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    size_t dim = (size_t)w->dim, j;
    int b;
    paradt_mpi__reduce_min(w, c->facts, (int)((size_t)c->box_count * 2 * dim));
    for (b = 0; b < c->box_count; b++) {
        for (j = 0; j < dim; j++) {
            c->boxes[b].low[j] = c->facts[((size_t)b * dim + j) * 2];
            c->boxes[b].high[j] = ~c->facts[((size_t)b * dim + j) * 2 + 1];
        }
    }
}

// Returns how many sides the ranks of a box would have on the box's unbounded sides, if it were divided into cubes.
// length: extent of the box on each axis
static double paradt_mpi__bare_sides(const paradt_mpi__box *box, int ranks, const double *length, int dim) {
    double volume = 1.0, cube, bare = 0.0;
    int axis, axes = 0;
    for (axis = 0; axis < dim; axis++) {
        if (!(length[axis] > 0.0)) continue;
        volume *= length[axis];
        axes++;
    }
    cube = axes ? pow(volume / ranks, 1.0 / axes) : 0.0;
    for (axis = 0; axis < dim; axis++) {
        int sides = (box->from[axis] == INT64_MIN) + (box->to[axis] == INT64_MAX);
        if (length[axis] > 0.0) bare += sides * ranks / paradt__larger(1.0, length[axis] / cube);
    }
    return bare;
}

// Returns how many points beyond its proportional share the lower half should get, because its ranks border on fewer
// neighbours and would finish early. Negative where they border on more.
//
// A rank with p points, of whose 2 dim sides s are bare (unbounded), takes the time p + (2 dim - s) cost. If all ranks
// take the same time, p - mean(p) = cost (s - mean(s)). Summed over the lower half's ranks, which are the fraction
// `part` of all, this is cost (bare_below - part (bare_below + bare_above)).
//   points  mean number of points a rank
//   length  extent of the box on each axis; overwritten
static double paradt_mpi__extra_for_lower(const paradt_mpi__box *box, double points, double *length, int dim) {
    paradt_mpi__box half = *box;
    int lower = box->ranks / 2, axis = box->axis;
    double part = (double)lower / box->ranks, whole = length[axis], bare_below, bare_above, cost;
    half.to[axis] = 0;
    length[axis] = whole * part;
    bare_below = paradt_mpi__bare_sides(&half, lower, length, dim);
    half.from[axis] = 0;
    half.to[axis] = box->to[axis];
    length[axis] = whole - length[axis];
    bare_above = paradt_mpi__bare_sides(&half, box->ranks - lower, length, dim);
    cost = PARADT_MPI__LAYERS * pow(points, 1.0 - 1.0 / dim);
    if (cost > points / (4 * dim)) cost = points / (4 * dim); // so that 2 dim sides cost at most half of the points
    return cost * (bare_below - part * (bare_below + bare_above));
}

// Chooses the axis and the weight wanted below the cut, or with PARADT_UNIFORM the cut itself. total: weight of all
// ranks' points in the box
static void paradt_mpi__aim(const paradt_mpi__work *w, const paradt_mpi__cutter *c, paradt_mpi__box *box,
                            uint64_t total) {
    uint64_t lower = (uint64_t)(box->ranks / 2), all = (uint64_t)box->ranks;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM], length[PARADT_MAX_DIM], longest, mean = (double)c->mean;
    int axis;
    box->weight_wanted = total / all * lower + total % all * lower / all;
    box->weight_below = 0;
    box->axis = box->listed = 0;
    box->undecided = box->end - box->begin;
    box->weight_undecided = total;
    box->tolerance = total / all / PARADT_MPI__PRECISION;
    if (!total) return;
    for (axis = 0; axis < w->dim; axis++) {
        low[axis] = paradt__from_ordered_bits(box->low[axis]);
        high[axis] = paradt__from_ordered_bits(box->high[axis]);
        length[axis] = high[axis] * 0.5 - low[axis] * 0.5;
    }
    box->axis = paradt__longest_axis(low, high, w->dim, 0);
    longest = length[box->axis];
    if (w->options.local.partition == PARADT_UNIFORM) {
        double part = (double)lower / (double)all;
        box->cut = paradt__ordered_bits(paradt__from_ordered_bits(box->low[box->axis]) * (1.0 - part) +
                                        paradt__from_ordered_bits(box->high[box->axis]) * part);
    }
    box->origin = paradt__from_ordered_bits(box->low[box->axis]) * 0.5;
    box->scale = longest > 0.0 ? (double)PARADT_MPI__PARTS / longest : 0.0;
    if (!(box->scale < PARADT__FAR)) box->scale = 0.0;
    for (axis = 0; axis < w->dim && longest > 0.0; axis++) length[axis] /= longest;
    if (box->ranks > 1)
        box->weight_wanted +=
            (uint64_t)(int64_t)(paradt_mpi__extra_for_lower(box, (double)total / (mean * box->ranks), length, w->dim) *
                                mean);
}

// Replaces the aims of all ranks by those of rank 0. Aims are computed in floating-point arithmetic, whose results may
// differ between ranks (compiler, library, processor, its mode). Collective.
static void paradt_mpi__broadcast_aims(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    enum { FACTS = 5 };
    int b;
    for (b = 0; b < c->box_count; b++) {
        const paradt_mpi__box *box = c->boxes + b;
        int64_t *facts = c->facts + (size_t)b * FACTS;
        facts[0] = box->axis;
        facts[1] = (int64_t)box->weight_wanted;
        facts[2] = box->cut;
        facts[3] = (int64_t)paradt_mpi__load_bits(&box->origin);
        facts[4] = (int64_t)paradt_mpi__load_bits(&box->scale);
    }
    MPI_Bcast(c->facts, c->box_count * FACTS, MPI_INT64_T, 0, w->comm);
    for (b = 0; b < c->box_count; b++) {
        paradt_mpi__box *box = c->boxes + b;
        const int64_t *facts = c->facts + (size_t)b * FACTS;
        box->axis = (int)facts[0];
        box->weight_wanted = (uint64_t)facts[1];
        box->cut = facts[2];
        paradt_mpi__store_bits(&box->origin, (uint64_t)facts[3]);
        paradt_mpi__store_bits(&box->scale, (uint64_t)facts[4]);
    }
}

// Does the cut of the box need another round?
static int paradt_mpi__is_searching(const paradt_mpi__work *w, const paradt_mpi__box *box) {
    return box->ranks > 1 && w->options.local.partition != PARADT_UNIFORM && box->weight_undecided > box->tolerance &&
           box->low[box->axis] < box->high[box->axis];
}

// Adds the weight of this rank's undecided rows of a box to counts, [PARADT_MPI__PARTS], and notes each row's part.
// even: parts of equal length; else of equally many ordered bits. The smallest coordinate is in the first part and the
// largest in a later one, so every round leaves fewer values.
PARADT__INLINE void paradt_mpi__count_parts(const paradt_mpi__cutter *c, const paradt_mpi__box *box, int even,
                                            uint64_t *counts) {
    const size_t *list = box->listed ? c->undecided + box->begin : NULL;
    const double *rows = c->rows + box->axis, origin = box->origin, scale = box->scale;
    unsigned char *parts = c->parts + box->begin;
    size_t begin = box->begin, count = box->undecided, width = c->width, i;
    uint64_t low = (uint64_t)box->low[box->axis], weight = c->weight;
    int bits = paradt__bit_length((uint64_t)box->high[box->axis] - low);
    int shift = bits > PARADT_MPI__PART_BITS ? bits - PARADT_MPI__PART_BITS : 0;
    for (i = 0; i < count; i++) {
        double x = rows[(list ? list[i] : begin + i) * width];
        unsigned part = even ? (unsigned)(int)((x * 0.5 - origin) * scale)
                             : (unsigned)(((uint64_t)paradt__ordered_bits(x) - low) >> shift);
        PARADT__FETCH(rows, (begin + i + PARADT__POINTS_AHEAD) * width);
        if (part >= PARADT_MPI__PARTS) part = PARADT_MPI__PARTS - 1;
        parts[i] = (unsigned char)part;
        counts[part] += weight;
    }
}

// Sets the part with the cut, and the weight below it and in it. counts: weight of each part, of all ranks
static void paradt_mpi__find_part(paradt_mpi__box *box, const uint64_t *counts) {
    box->part = 0;
    while (box->part + 1 < PARADT_MPI__PARTS && box->weight_below + counts[box->part] <= box->weight_wanted)
        box->weight_below += counts[box->part++];
    box->weight_undecided = counts[box->part];
    box->scale = 0.0;
}

// Lists this rank's undecided rows, those in that part, and sets bounds, [2], to theirs on the axis.
static void paradt_mpi__list_part(const paradt_mpi__cutter *c, paradt_mpi__box *box, int64_t *bounds) {
    const unsigned char *parts = c->parts + box->begin, part = (unsigned char)box->part;
    const double *rows = c->rows + box->axis;
    size_t *list = c->undecided + box->begin, count = box->undecided, kept = 0, i;
    bounds[0] = bounds[1] = INT64_MAX;
    for (i = 0; i < count; i++) {
        if (parts[i] == part) list[kept++] = box->listed ? list[i] : box->begin + i;
    }
    for (i = 0; i < kept; i++) paradt_mpi__bound_bits(bounds, paradt__ordered_bits(rows[list[i] * c->width]));
    box->listed = 1;
    box->undecided = kept;
}

// Does one round of the search for all boxes that need it. Returns 0 when there was none. Collective.
static int paradt_mpi__narrow_cuts(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    int b, several = 0;
    memset(c->counts, 0, (size_t)c->box_count * PARADT_MPI__PARTS * sizeof *c->counts);
    for (b = 0; b < c->box_count; b++) {
        const paradt_mpi__box *box = c->boxes + b;
        uint64_t *counts = c->counts + (size_t)b * PARADT_MPI__PARTS;
        if (!paradt_mpi__is_searching(w, box)) continue;
        if (box->scale > 0.0) paradt_mpi__count_parts(c, box, 1, counts);
        else paradt_mpi__count_parts(c, box, 0, counts);
        several = 1;
    }
    if (!several) return 0;
    MPI_Allreduce(MPI_IN_PLACE, c->counts, c->box_count * PARADT_MPI__PARTS, MPI_UINT64_T, MPI_SUM, w->comm);
    for (b = 0; b < c->box_count; b++) {
        c->facts[2 * b] = c->facts[2 * b + 1] = INT64_MAX;
        if (!paradt_mpi__is_searching(w, c->boxes + b)) continue;
        paradt_mpi__find_part(c->boxes + b, c->counts + (size_t)b * PARADT_MPI__PARTS);
        paradt_mpi__list_part(c, c->boxes + b, c->facts + 2 * b);
    }
    paradt_mpi__reduce_min(w, c->facts, 2 * c->box_count);
    for (b = 0; b < c->box_count; b++) {
        paradt_mpi__box *box = c->boxes + b;
        if (c->facts[2 * b] == INT64_MAX) continue; // this box took no part
        box->low[box->axis] = c->facts[2 * b];
        box->high[box->axis] = ~c->facts[2 * b + 1];
    }
    return 1;
}

// Sets the cut below or above the undecided points, whichever comes nearer to the weight wanted.
static void paradt_mpi__choose_cut(paradt_mpi__box *box) {
    uint64_t above = box->weight_below + box->weight_undecided, missing = box->weight_wanted - box->weight_below;
    int64_t low = box->low[box->axis], high = box->high[box->axis];
    box->cut = above - box->weight_wanted < missing ? high + 1 : low;
}

// Computes the bounds and the weight of this rank's rows in all boxes, in c->facts and c->counts.
static void paradt_mpi__measure_boxes(const paradt_mpi__work *w, paradt_mpi__cutter *c) {
    size_t dim = (size_t)w->dim;
    int b;
    for (b = 0; b < c->box_count; b++) {
        const paradt_mpi__box *box = c->boxes + b;
        int64_t *bounds = c->facts + (size_t)b * 2 * dim;
        if (dim == 3) paradt_mpi__bound_rows(c, box, 3, bounds);
        else paradt_mpi__bound_rows(c, box, dim, bounds);
        c->counts[b] = (box->end - box->begin) * c->weight;
    }
}

// Divides a box: its lower half stays in its place, the upper half is appended.
static void paradt_mpi__cut_box(const paradt_mpi__work *w, paradt_mpi__cutter *c, paradt_mpi__box *box) {
    paradt_mpi__box *upper = c->boxes + c->box_count++;
    if (w->options.local.partition != PARADT_UNIFORM) paradt_mpi__choose_cut(box);
    *upper = *box;
    upper->from[box->axis] = box->to[box->axis] = box->cut;
    upper->first += box->ranks / 2;
    upper->ranks -= box->ranks / 2;
    box->ranks /= 2;
    PARADT_ASSERT(box->ranks > 0 && upper->ranks > 0 && c->box_count <= w->ranks);
    upper->begin = c->width == 4 ? paradt_mpi__split_rows(c, box, 4) : paradt_mpi__split_rows(c, box, c->width);
    box->end = upper->begin;
    PARADT_ASSERT(box->begin <= box->end && upper->begin <= upper->end);
}

// Halves all boxes that have several ranks. Returns 0 when there was none. Collective.
static int paradt_mpi__halve(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    int b, boxes = c->box_count, several = 0;
    for (b = 0; b < boxes; b++) several |= c->boxes[b].ranks > 1;
    if (!several) return 0;
    paradt_mpi__measure_boxes(w, c);
    paradt_mpi__agree_bounds(w, c);
    MPI_Allreduce(MPI_IN_PLACE, c->counts, boxes, MPI_UINT64_T, MPI_SUM, w->comm);
    for (b = 0; b < boxes; b++) paradt_mpi__aim(w, c, c->boxes + b, c->counts[b]);
    paradt_mpi__broadcast_aims(w, c);
    while (paradt_mpi__narrow_cuts(w, c)) continue;
    for (b = 0; b < boxes; b++) {
        if (c->boxes[b].ranks > 1) paradt_mpi__cut_box(w, c, c->boxes + b);
    }
    return 1;
}

// Copies this rank's box to w->box_low and w->box_high.
static void paradt_mpi__note_own_box(paradt_mpi__work *w, const paradt_mpi__cutter *c) {
    int b, axis;
    for (b = 0; b < c->box_count; b++) {
        const paradt_mpi__box *box = c->boxes + b;
        if (box->first != w->rank) continue;
        for (axis = 0; axis < w->dim; axis++) {
            w->box_low[axis] = box->from[axis] == INT64_MIN ? -PARADT__FAR : paradt__from_ordered_bits(box->from[axis]);
            w->box_high[axis] = box->to[axis] == INT64_MAX ? PARADT__FAR : paradt__from_ordered_bits(box->to[axis]);
        }
    }
}

// Cuts space and sends each row to the rank whose box it is in. Sets w->box_low and w->box_high. Collective.
//   weight  of each row of this rank
//   mean    weight of a row that takes the mean work
//   *rows   [*count]; replaced by the rows received, in the order of the ranks that they come from. The caller releases
//           it, after an error too.
static paradt_status paradt_mpi__partition(paradt_mpi__work *w, uint64_t weight, uint64_t mean, double **rows,
                                           size_t *count) {
    paradt_mpi__cutter c;
    void *got = NULL;
    size_t ranks = (size_t)w->ranks;
    paradt_status status = PARADT_OK;
    int axis, b;
    c.rows = *rows;
    c.count = *count;
    c.width = (size_t)w->dim + (size_t)w->weighted + 1;
    c.weight = weight;
    c.mean = mean;
    c.box_count = 1;
    PARADT_ASSERT(weight > 0 && mean > 0);
    c.undecided = (size_t *)paradt__alloc(&w->memory, c.count, sizeof *c.undecided);
    c.parts = (unsigned char *)paradt__alloc(&w->memory, c.count, 1);
    c.boxes = (paradt_mpi__box *)paradt__alloc(&w->memory, ranks, sizeof *c.boxes);
    c.counts = (uint64_t *)paradt__alloc(&w->memory, ranks, PARADT_MPI__PARTS * sizeof *c.counts);
    c.facts = (int64_t *)paradt__alloc(&w->memory, ranks, 2 * PARADT_MAX_DIM * sizeof *c.facts);
    c.paged = 0;
    c.capacity = c.count + c.count / 16;
    c.spare = (double *)paradt__alloc(&w->memory, c.capacity, c.width * sizeof *c.spare);
    if (!c.undecided || !c.parts || !c.boxes || !c.counts || !c.facts || !c.spare) status = PARADT_ERROR_MEMORY;
    status = paradt_mpi__agree(w, status);
    if (!status) {
        memset(c.boxes, 0, sizeof *c.boxes);
        c.boxes[0].ranks = w->ranks;
        c.boxes[0].end = c.count;
        for (axis = 0; axis < w->dim; axis++) {
            c.boxes[0].from[axis] = INT64_MIN;
            c.boxes[0].to[axis] = INT64_MAX;
        }
        while (paradt_mpi__halve(w, &c)) continue;
        paradt_mpi__note_own_box(w, &c);
        for (b = 0; b < c.box_count; b++) w->to[c.boxes[b].first] = c.boxes[b].end - c.boxes[b].begin;
    }
    paradt__release(&w->memory, c.facts);
    paradt__release(&w->memory, c.counts);
    paradt__release(&w->memory, c.boxes);
    paradt__release(&w->memory, c.parts);
    paradt__release(&w->memory, c.undecided);
    got = c.spare;
    if (status) {
        paradt__release(&w->memory, got);
        return status;
    }
    *count = c.capacity;
    status = paradt_mpi__exchange_into(w, PARADT_OK, c.rows, c.width * sizeof *c.rows, &got, count);
    paradt__release(&w->memory, c.rows);
    *rows = (double *)got;
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>others
//
// Points of other ranks: their records stand behind the own ones in set.records, from position set.count on, each once,
// and w->homes says where each is at home. On the wire a point is its record, the bits of its id and the bits of its
// position at home; the home is the sender.
//
// Doors: paradt_mpi__wire_width, paradt_mpi__put_wire, paradt_mpi__home_of, paradt_mpi__reserve_others,
// paradt_mpi__add_other, paradt_mpi__exchange_points.

// Returns the doubles that a point takes on the wire.
static size_t paradt_mpi__wire_width(const paradt_mpi__work *w) {
    return w->set.width + 2;
}

// Makes room for `more` points of other ranks. Records may move, also for an insertion that goes on.
static paradt_status paradt_mpi__reserve_others(paradt_mpi__work *w, size_t more) {
    size_t capacity = w->known + more;
    void *array;
    PARADT_ASSERT(w->set.count <= w->known && w->known <= w->capacity);
    if (capacity > (size_t)INT32_MAX && sizeof(paradt_index) == 4) return PARADT_ERROR_TOO_LARGE;
    if (capacity <= w->capacity) return PARADT_OK;
    capacity += capacity / 16; // more come soon
    array = w->set.records;
    if (!paradt__grow(&w->memory, &array, w->known * w->set.width, capacity * w->set.width, sizeof(double)))
        return PARADT_ERROR_MEMORY;
    w->set.records = (double *)array;
    if (w->inserting) paradt__known_move_records(&w->engine, w->set.records);
    array = w->homes;
    if (!paradt__grow(&w->memory, &array, w->known - w->set.count, capacity - w->set.count, sizeof *w->homes))
        return PARADT_ERROR_MEMORY;
    w->homes = (paradt_mpi__home *)array;
    w->capacity = capacity;
    return PARADT_OK;
}

// Adds a point of another rank to the known ones, for which there is room. Returns 0 if it was known, else 1. wire: its
// row
static size_t paradt_mpi__add_other(paradt_mpi__work *w, int rank, const double *wire) {
    paradt_mpi__home *home = w->homes + (w->known - w->set.count);
    paradt_index position = (paradt_index)paradt_mpi__load_bits(wire + w->set.width + 1);
    PARADT_ASSERT(rank != w->rank && position >= 0);
    if (paradt_mpi__table_put(&w->lookup, rank, position, (paradt_index)w->known)) return 0;
    PARADT_ASSERT(w->known < w->capacity);
    memcpy(w->set.records + w->known * w->set.width, wire, w->set.width * sizeof *wire);
    home->id = paradt_mpi__load_bits(wire + w->set.width);
    home->rank = rank;
    home->position = position;
    w->known++;
    return 1;
}

// Returns where a known point is at home. point: its position
PARADT__INLINE paradt_mpi__home paradt_mpi__home_of(const paradt_mpi__work *w, paradt_index point) {
    paradt_mpi__home home;
    PARADT_ASSERT(point >= 0 && (size_t)point < w->known);
    if ((size_t)point >= w->set.count) return w->homes[(size_t)point - w->set.count];
    home.id = w->received[w->set.origin[point]];
    home.rank = w->rank;
    home.position = point;
    return home;
}

// Writes the row of a known point, paradt_mpi__wire_width doubles.
static void paradt_mpi__put_wire(const paradt_mpi__work *w, double *wire, paradt_index point) {
    paradt_mpi__home home = paradt_mpi__home_of(w, point);
    memcpy(wire, paradt__record(&w->set, point), w->set.width * sizeof *wire);
    paradt_mpi__store_bits(wire + w->set.width, home.id);
    paradt_mpi__store_bits(wire + w->set.width + 1, (uint64_t)home.position);
}

// Sends the listed points to their ranks and adds those that arrive to the known ones. Collective; the status returned
// is this rank's own. *added: how many of them were not known
static paradt_status paradt_mpi__exchange_points(paradt_mpi__work *w, paradt_status status,
                                                 const paradt_mpi__list *list, size_t *added) {
    size_t width = paradt_mpi__wire_width(w), i, count, row = 0;
    double *rows = NULL;
    void *got = NULL;
    int r;
    *added = 0;
    if (!status) rows = (double *)paradt__alloc(&w->memory, list->count, width * sizeof *rows);
    if (!status && !rows) status = PARADT_ERROR_MEMORY;
    memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
    for (i = 0; i < list->count; i++) w->to[list->items[i].rank]++;
    paradt_mpi__set_offsets(w);
    for (i = 0; i < list->count && !status; i++)
        paradt_mpi__put_wire(w, rows + w->next[list->items[i].rank]++ * width, list->items[i].position);
    status = paradt_mpi__exchange(w, status, rows, width * sizeof *rows, &got, &count);
    paradt__release(&w->memory, rows);
    if (!status) status = paradt_mpi__reserve_others(w, count);
    if (!status) status = paradt_mpi__table_reserve(w, &w->lookup, count);
    for (r = 0; r < w->ranks && !status; r++) {
        for (i = 0; i < w->from[r]; i++) *added += paradt_mpi__add_other(w, r, (double *)got + row++ * width);
    }
    paradt__release(&w->memory, got);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>own
//
// From the rows of a rank's box to its own points: a paradt__set without duplicates, along a curve, and a grid over it.
// Scale, axes, measure and reference sphere are agreed on by all ranks, so that the record of a point is the same
// everywhere, and a search on one rank can be asked about cells of another. Only order and grid are the rank's own
// affair. A point set of lower dimension has the same dimension on every rank: each rank knows points that span it.
//
// Doors: paradt_mpi__adopt_rows, paradt_mpi__free_points, paradt_mpi__free_question_data.

// Returns how many points of other ranks this rank is likely to receive: one and a quarter layers around a cube of its
// own points.
static size_t paradt_mpi__expect_others(const paradt_mpi__work *w, size_t count) {
    size_t side = 1, power, others;
    int axis;
    if (w->ranks == 1) return 0;
    for (power = 1; power < count; side++) {
        for (power = 1, axis = 0; axis < w->dim; axis++) power *= side;
    }
    others = count / side * (size_t)w->dim * 5 / 2 + 64;
    return others < count / 4 + 64 ? others : count / 4 + 64;
}

// Makes the set of the rows, in the order of ids: without duplicates, along a curve, with room for others' points. Sets
// received and representative. Not collective.
static paradt_status paradt_mpi__load_set(paradt_mpi__work *w, const double *rows, size_t count) {
    size_t i, width = (size_t)w->dim + (size_t)w->weighted, bad;
    paradt__source source;
    if (count > (size_t)INT32_MAX / 2 && sizeof(paradt_index) == 4) return PARADT_ERROR_TOO_LARGE;
    w->received = (uint64_t *)paradt__alloc_filled(&w->memory, count, sizeof *w->received);
    w->representative = (paradt_index *)paradt__alloc_filled(&w->memory, count, sizeof *w->representative);
    if (!w->received || !w->representative) return PARADT_ERROR_MEMORY;
    for (i = 0; i < count; i++) w->received[i] = paradt_mpi__load_bits(rows + i * (width + 1) + width);
    w->received_count = count;
    memset(&source, 0, sizeof source);
    source.points.data = rows;
    source.points.count = count;
    source.points.dim = w->dim;
    source.points.stride = source.weight_stride = (width + 1) * sizeof *rows;
    source.points.weights = w->weighted ? rows + w->dim : NULL;
    source.reserve = paradt_mpi__expect_others(w, count);
    w->capacity = count + source.reserve;
    // Of equal points the set keeps the one with the smallest index, which is the smallest id, as ids ascend.
    return paradt__set_gather(&w->set, &source, NULL, &paradt__alone, &w->memory, w->representative, &bad);
}

// Multiplies the coordinates of all ranks by one power of two that brings the largest near 1, unless it is near 1
// already or a coordinate of any rank would lose a bit. Returns 1 if coordinates were changed. Collective.
static int paradt_mpi__scale(paradt_mpi__work *w) {
    paradt__set *set = &w->set;
    int64_t largest = -set->exponent, fine = 1;
    size_t i;
    int shift, exact = 1;
    paradt_mpi__reduce_min(w, &largest, 1);
    shift = 1023 + (int)largest;
    if (shift >= -32 && shift <= 32) return 0;
    for (i = 0; i < set->count * set->width && exact; i++)
        paradt__scale(set->records[i], i % set->width < (size_t)w->dim ? shift : 2 * shift, &exact);
    fine = exact;
    paradt_mpi__reduce_min(w, &fine, 1);
    if (!fine) return 0;
    for (i = 0; i < set->count * set->width; i++)
        set->records[i] = paradt__scale(set->records[i], i % set->width < (size_t)w->dim ? shift : 2 * shift, &exact);
    w->shift = shift;
    return 1;
}

// Finds points of all ranks that span all points, and sets the order of the axes by them. Returns the affine dimension,
// -1: there are no points. Collective.
//
// Points that span each rank's own points are gathered on every rank; those that span these span all.
//   gathered  [ranks][dim + 1][width], overwritten
//   counts    [ranks], overwritten
//   origins   [dim + 1] of each spanning point: its received number on the rank that has it, -1 on the other ranks
static int paradt_mpi__span(paradt_mpi__work *w, double *gathered, size_t *counts, paradt_index *origins) {
    paradt_index basis[PARADT_MAX_DIM + 1];
    double mine[(PARADT_MAX_DIM + 1) * (PARADT_MAX_DIM + 1)];
    paradt_index own[PARADT_MAX_DIM + 1];
    paradt__set *set = &w->set, all;
    size_t width = set->width, most = (size_t)w->dim + 1, i, total = 0, before = 0;
    int axes[PARADT_MAX_DIM], found, r;
    size_t count = (size_t)paradt__set_basis(set, NULL, 0, basis, axes, &set->space.counters, NULL);
    memset(mine, 0, sizeof mine);
    for (i = 0; i < count; i++) {
        memcpy(mine + i * width, paradt__record(set, basis[i]), width * sizeof *mine);
        own[i] = set->origin[basis[i]];
    }
    MPI_Allgather(&count, (int)sizeof count, MPI_BYTE, counts, (int)sizeof count, MPI_BYTE, w->comm);
    MPI_Allgather(mine, (int)(most * width), MPI_DOUBLE, gathered, (int)(most * width), MPI_DOUBLE, w->comm);
    for (r = 0; r < w->ranks; r++) {
        if (r < w->rank) before += counts[r];
        memmove(gathered + total * width, gathered + (size_t)r * most * width, counts[r] * width * sizeof *mine);
        total += counts[r];
    }
    all = *set;
    all.records = gathered;
    all.count = total;
    found = paradt__set_basis(&all, NULL, 0, basis, set->axes, &all.space.counters, NULL);
    for (i = 0; i < (size_t)found; i++) {
        size_t position = (size_t)basis[i];
        origins[i] = position >= before && position < before + count ? own[position - before] : -1;
    }
    return found - 1;
}

// Sets the measure of the set to that of all ranks' points, and w->low and w->high to the own points' box. Collective.
// as_read: the own points still are as they were measured on reading
static void paradt_mpi__measure(paradt_mpi__work *w, int dim, int as_read) {
    paradt__space *space = &w->set.space;
    int64_t facts[6 + 2 * PARADT_MAX_DIM];
    paradt__range *ranges[2];
    paradt__space measured;
    int j;
    if (as_read) paradt__set_measured(&w->set, dim);
    else paradt__set_measure(&w->set, &paradt__alone, &measured, dim);
    memcpy(w->low, space->low, sizeof w->low);
    memcpy(w->high, space->high, sizeof w->high);
    ranges[0] = &space->coordinates;
    ranges[1] = &space->weights;
    for (j = 0; j < 2; j++) {
        facts[3 * j] = ranges[j]->unit;
        facts[3 * j + 1] = ranges[j]->bottom;
        facts[3 * j + 2] = -ranges[j]->top;
    }
    for (j = 0; j < w->dim; j++) {
        facts[6 + 2 * j] = space->low[j];
        facts[7 + 2 * j] = ~space->high[j];
    }
    paradt_mpi__reduce_min(w, facts, 6 + 2 * w->dim);
    for (j = 0; j < 2; j++) {
        ranges[j]->unit = (int)facts[3 * j];
        ranges[j]->bottom = (int)facts[3 * j + 1];
        ranges[j]->top = -(int)facts[3 * j + 2];
    }
    for (j = 0; j < w->dim; j++) {
        space->low[j] = facts[6 + 2 * j];
        space->high[j] = ~facts[7 + 2 * j];
    }
    if (dim > 0) paradt__space_end(space);
}

// Gathers a sample of all points on every rank: at most 64 of each, one behind the other. Returns its size. Collective.
//   sample  [ranks][64][dim]
//   counts  [ranks], overwritten
static size_t paradt_mpi__sample(paradt_mpi__work *w, double *sample, size_t *counts) {
    const paradt__set *set = &w->set;
    size_t width = set->width, i, total = 0;
    size_t count = set->count < 64 ? set->count : 64;
    double mine[64 * PARADT_MAX_DIM];
    int r;
    memset(mine, 0, sizeof mine);
    for (i = 0; i < count; i++)
        memcpy(mine + i * width, set->records + set->count / count * i * width, width * sizeof *mine);
    MPI_Allgather(&count, (int)sizeof count, MPI_BYTE, counts, (int)sizeof count, MPI_BYTE, w->comm);
    MPI_Allgather(mine, (int)(64 * width), MPI_DOUBLE, sample, (int)(64 * width), MPI_DOUBLE, w->comm);
    for (r = 0; r < w->ranks; r++) {
        memmove(sample + total * width, sample + (size_t)r * 64 * width, counts[r] * width * sizeof *mine);
        total += counts[r];
    }
    return total;
}

// Takes the sagittas out of the records, because another rank's points are not near the sphere.
static void paradt_mpi__ungrade(paradt__set *set) {
    size_t i;
    set->width--;
    set->grade = PARADT__UNGRADED;
    for (i = 0; i < set->count; i++)
        memmove(set->records + i * set->width, set->records + i * (set->width + 1), set->width * sizeof(double));
}

// Grades the points by one reference sphere, if those of all ranks are near it. Rank 0 fits the sphere to a sample.
// Collective.
static paradt_status paradt_mpi__grade(paradt_mpi__work *w) {
    paradt__set *set = &w->set, all = *set;
    double sphere[PARADT_MAX_DIM + 2] = {0.0}, limit; // centre, squared radius, whether there is one
    double *sample;
    size_t *counts;
    int64_t all_near;
    int nearby = 0, dim = w->dim;
    paradt_status status = PARADT_OK;
    if (set->grade || set->space.dim < dim || !set->space.filtered) return PARADT_OK;
    sample = (double *)paradt__alloc(&w->memory, (size_t)w->ranks * 64 * set->width, sizeof *sample);
    counts = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *counts);
    if (!sample || !counts) status = PARADT_ERROR_MEMORY;
    status = paradt_mpi__agree(w, status);
    if (!status) {
        all.records = sample;
        all.count = paradt_mpi__sample(w, sample, counts);
        if (w->rank == 0 && all.count >= 64)
            sphere[dim + 1] = paradt__fit_sphere(&all, PARADT__NEAR_SPHERE, sphere, sphere + dim);
        MPI_Bcast(sphere, dim + 2, MPI_DOUBLE, 0, w->comm);
    }
    paradt__release(&w->memory, sample);
    paradt__release(&w->memory, counts);
    if (status || !(sphere[dim + 1] > 0.0)) return status;
    memcpy(set->centre, sphere, (size_t)dim * sizeof *sphere);
    status = paradt__set_sagittas(set, sphere[dim], PARADT__NEAR_SPHERE, set->count, NULL, &w->memory, &nearby);
    all_near = nearby;
    status = paradt_mpi__agree(w, status);
    if (status) return status;
    paradt_mpi__reduce_min(w, &all_near, 1);
    if (nearby) w->capacity = set->count; // paradt__set_sagittas made new records, of the own points alone
    if (nearby && !all_near) paradt_mpi__ungrade(set);
    if (!all_near) return PARADT_OK;
    MPI_Allreduce(&set->grade_limit, &limit, 1, MPI_DOUBLE, MPI_MAX, w->comm);
    paradt__set_grade_bounds(set, limit);
    return PARADT_OK;
}

// Lays the grid over the own points and begins the account of others' points. The box that is complete is this rank's
// box; it is empty where coordinates are scaled, or the box is bounded on an axis that does not orient. Not collective.
static paradt_status paradt_mpi__lay_grid(paradt_mpi__work *w) {
    paradt__set *set = &w->set;
    int axis, bounded = w->shift != 0;
    size_t i;
    paradt_status status;
    w->homes = (paradt_mpi__home *)paradt__alloc(&w->memory, w->capacity - set->count, sizeof *w->homes);
    w->first_sent = (int *)paradt__alloc_filled(&w->memory, set->count, sizeof *w->first_sent);
    if (!w->homes || !w->first_sent) return PARADT_ERROR_MEMORY;
    w->known = set->count;
    PARADT_ASSERT(w->capacity >= w->known);
    w->has_grid = w->ranks > 1 && set->count && set->space.dim > 0;
    if (w->has_grid) {
        status = paradt__grid_lay(&w->grid, set, &w->memory);
        if (status) return status;
        for (axis = set->space.dim; axis < w->dim; axis++)
            bounded |= w->box_low[set->axes[axis]] > -PARADT__FAR || w->box_high[set->axes[axis]] < PARADT__FAR;
        for (axis = 0; axis < w->dim; axis++) {
            w->complete[2 * axis] = bounded ? PARADT__FAR : w->box_low[set->axes[axis]];
            w->complete[2 * axis + 1] = bounded ? -PARADT__FAR : w->box_high[set->axes[axis]];
        }
        paradt__search_begin(&w->search, set, &w->grid);
    }
    for (i = 0; i < set->count; i++) w->first_sent[i] = -1;
    return PARADT_OK;
}

// Makes points that span all points known to every rank, so that each local triangulation has the dimension of the
// whole. One reduction by sum serves as broadcast from several ranks. Collective. origins: see paradt_mpi__span
static paradt_status paradt_mpi__spread_basis(paradt_mpi__work *w, const paradt_index *origins) {
    enum { MOST = PARADT_MAX_DIM + 5 };          // words a point at most: its row on the wire and its rank
    uint64_t words[(PARADT_MAX_DIM + 1) * MOST]; // of each point nonzero on the rank that has it
    double wire[MOST];
    size_t count = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), i, k;
    paradt_status status;
    memset(words, 0, sizeof words);
    for (k = 0; k < count; k++) {
        if (origins[k] < 0) continue;
        for (i = 0; w->set.origin[i] != origins[k];) i++;
        paradt_mpi__put_wire(w, wire, (paradt_index)i);
        memcpy(words + k * MOST, wire, width * sizeof *wire);
        words[k * MOST + width] = (uint64_t)w->rank;
    }
    MPI_Allreduce(MPI_IN_PLACE, words, (int)(count * MOST), MPI_UINT64_T, MPI_SUM, w->comm);
    status = paradt_mpi__reserve_others(w, count);
    if (!status) status = paradt_mpi__table_reserve(w, &w->lookup, count);
    for (k = 0; k < count && !status; k++) {
        int rank = (int)words[k * MOST + width];
        memcpy(wire, words + k * MOST, width * sizeof *wire);
        if (rank != w->rank) (void)paradt_mpi__add_other(w, rank, wire);
    }
    return paradt_mpi__agree(w, status);
}

// Makes the rows, which are in the order of ids, this rank's own points, and sets the dimension of the result.
// Collective.
static paradt_status paradt_mpi__adopt_rows(paradt_mpi__work *w, const double *rows, size_t count) {
    size_t most = (size_t)w->dim + 1;
    double *gathered;
    size_t *counts;
    paradt_index origins[PARADT_MAX_DIM + 1];
    int dim = -1, as_read = 0;
    paradt_status status = paradt_mpi__load_set(w, rows, count);
    PARADT_ASSERT(!w->inserting && !w->known);
    gathered = (double *)paradt__alloc(&w->memory, (size_t)w->ranks * most * most, sizeof *gathered);
    counts = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *counts);
    if (!status && (!gathered || !counts)) status = PARADT_ERROR_MEMORY;
    status = paradt_mpi__agree(w, status);
    if (!status) {
        as_read = !paradt_mpi__scale(w);
        dim = paradt_mpi__span(w, gathered, counts, origins);
    }
    paradt__release(&w->memory, gathered);
    paradt__release(&w->memory, counts);
    if (status) return status;
    if (paradt__set_permute(&w->set, &paradt__alone)) as_read = 0;
    paradt_mpi__measure(w, dim, as_read);
    w->out->dim = dim;
    w->stats.points = w->set.count;
    w->stats.duplicates = count - w->set.count;
    if (w->options.local.flags & PARADT_FULL_DIM && dim < w->dim) // on all ranks
        return paradt_mpi__agree(w, paradt_mpi__refuse(w, PARADT_ERROR_FLAT, paradt__flat_text(dim)));
    if (dim > 0) status = paradt_mpi__grade(w);
    if (!status) status = paradt_mpi__agree(w, paradt_mpi__lay_grid(w));
    return status || dim <= 0 ? status : paradt_mpi__spread_basis(w, origins);
}

// Frees what only questions and answers need: grid, lookup, and the account of what was sent.
static void paradt_mpi__free_question_data(paradt_mpi__work *w) {
    if (w->grid.levels) paradt__grid_free(&w->grid, &w->memory);
    paradt__release(&w->memory, w->lookup.slots);
    paradt__release(&w->memory, w->sent.slots);
    paradt__release(&w->memory, w->first_sent);
    w->first_sent = NULL;
    memset(&w->grid, 0, sizeof w->grid);
    memset(&w->lookup, 0, sizeof w->lookup);
    memset(&w->sent, 0, sizeof w->sent);
}

// Frees the own points and others'.
static void paradt_mpi__free_points(paradt_mpi__work *w) {
    PARADT_ASSERT(!w->inserting);
    paradt_mpi__free_question_data(w);
    paradt__set_free(&w->set, &w->memory);
    paradt__release(&w->memory, w->homes);
    paradt__release(&w->memory, w->representative);
    paradt__release(&w->memory, w->received);
    memset(&w->set, 0, sizeof w->set);
    w->homes = NULL;
    w->representative = NULL;
    w->received = NULL;
    w->known = w->capacity = w->received_count = 0;
    w->shift = 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>weigh
//
// Distributes the points so that ranks have equal work. Points of a lattice take more time than points in general
// position, points near a sphere still more, and duplicates hardly any. So space is cut by the number of points first.
// Then each rank triangulates small samples of its points. Where these predict that some rank has much more work than
// the mean, each point gets the weight of the work that it is expected to take, and space is cut again. The decision is
// made from sums of integers, alike on all ranks.
//
// Door: paradt_mpi__distribute_points.

enum {
    PARADT_MPI__SAMPLES = 3,   // samples a rank
    PARADT_MPI__SAMPLED = 128, // points a sample, one behind the other along the curve
    PARADT_MPI__MEAN = 64,     // weight of a point that takes the mean work
    PARADT_MPI__LIGHTEST = 16  // smallest weight of a point: a rank gets at most about five times the mean of points
};

// PARADT_MPI__WORTH: points a rank from which cutting again can pay. PARADT_MPI__MUCH: the largest work of a rank, over
// the mean, above which it does. The tests define both, so that all sets are cut again.
#ifndef PARADT_MPI__WORTH
#define PARADT_MPI__WORTH 8192
#define PARADT_MPI__MUCH  1.25
#endif
// Work to read and compare a point, and to evaluate an in-sphere predicate, relative to that of making a cell. Measured
// for insertion in three dimensions; from four on, nearly all work is in the cells.
#define PARADT_MPI__READING   0.6
#define PARADT_MPI__PREDICATE 0.7

// Estimates the work for the own points, in cells made, by triangulating samples. Not collective.
static paradt_status paradt_mpi__estimate_work(paradt_mpi__work *w, double *work) {
    const paradt__set *set = &w->set;
    paradt_options options = paradt_mpi__local_options(w);
    double weights[PARADT_MPI__SAMPLED], sum = 0.0;
    size_t count = PARADT_MPI__SAMPLED, sample, i;
    paradt_status status = PARADT_OK;
    if (set->count < count) count = set->count;
    options.progress = NULL;
    options.parallel_for = NULL;
    options.regions = 1;
    for (sample = 0; sample < PARADT_MPI__SAMPLES && count && !status; sample++) {
        const double *first = set->records + (set->count - count) / PARADT_MPI__SAMPLES * sample * set->width;
        paradt_points points = paradt_points_f64(first, count, w->dim);
        paradt_triangulation t;
        points.stride = set->width * sizeof *first;
        for (i = 0; i < count && w->weighted; i++) weights[i] = first[i * set->width + (size_t)w->dim];
        if (w->weighted) points.weights = weights;
        status = paradt_triangulate(&t, &points, &options);
        if (!status) sum += (double)t.stats.cells + PARADT_MPI__PREDICATE * (double)t.stats.insphere_calls;
        paradt_mpi__add_peak(w, &t);
        paradt_free(&t);
    }
    *work = (double)w->received_count * PARADT_MPI__READING;
    if (count) *work += sum / (double)(count * PARADT_MPI__SAMPLES) * (double)set->count;
    return status;
}

// Sets *weight to what each row of this rank should weigh; to 0, on all ranks, where the work is even enough.
// Collective; returns the agreed status.
static paradt_status paradt_mpi__point_weight(paradt_mpi__work *w, uint64_t *weight) {
    double work = 0.0, units;
    uint64_t all, most;
    paradt_status status;
    *weight = 0;
    if (w->ranks == 1 || w->options.local.partition == PARADT_UNIFORM || w->out->dim <= 0 ||
        w->first[w->ranks] / (uint64_t)w->ranks < PARADT_MPI__WORTH)
        return PARADT_OK;
    status = paradt_mpi__agree(w, paradt_mpi__estimate_work(w, &work));
    if (status) return status;
    all = paradt_mpi__reduce_sum(w, (uint64_t)work);
    most = (uint64_t)work;
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_UINT64_T, MPI_MAX, w->comm);
    if (!((double)most * w->ranks > PARADT_MPI__MUCH * (double)all)) return PARADT_OK;
    units = PARADT_MPI__MEAN;
    if (w->received_count) units *= work / (double)w->received_count * (double)w->first[w->ranks] / (double)all;
    if (!(units > (double)PARADT_MPI__LIGHTEST)) units = (double)PARADT_MPI__LIGHTEST;
    *weight = units < 1048576.0 ? (uint64_t)units : 1048576;
    return PARADT_OK;
}

// Sorts the rows by id: *rows is replaced. Not collective.
static paradt_status paradt_mpi__sort_by_id(paradt_mpi__work *w, double **rows, size_t count) {
    size_t width = (size_t)w->dim + (size_t)w->weighted + 1, i;
    paradt__keyed *keyed, *other;
    double *sorted;
    enum { ID_BITS = 56 }; // no id has more
    paradt_status status = PARADT_ERROR_MEMORY;
    if (count > (size_t)INT32_MAX && sizeof(paradt_index) == 4) return PARADT_ERROR_TOO_LARGE;
    keyed = (paradt__keyed *)paradt__alloc(&w->memory, count, sizeof *keyed);
    other = (paradt__keyed *)paradt__alloc(&w->memory, count, sizeof *other);
    sorted = (double *)paradt__alloc(&w->memory, count, width * sizeof *sorted);
    if (keyed && other && sorted) {
        for (i = 0; i < count; i++) {
            keyed[i].key = paradt_mpi__load_bits(*rows + (i + 1) * width - 1);
            keyed[i].item = (paradt_index)i;
        }
        paradt__keyed_sort(keyed, other, count, ID_BITS, 0);
        for (i = 0; i < count; i++)
            memcpy(sorted + i * width, *rows + (size_t)keyed[i].item * width, width * sizeof *sorted);
        paradt__release(&w->memory, *rows);
        *rows = sorted;
        sorted = NULL;
        status = PARADT_OK;
    }
    paradt__release(&w->memory, sorted);
    paradt__release(&w->memory, other);
    paradt__release(&w->memory, keyed);
    return status;
}

// Makes the points of each rank's box its own points. rows: those that this rank handed in; released. Collective.
static paradt_status paradt_mpi__distribute_points(paradt_mpi__work *w, double *rows) {
    size_t count = w->out->point_count;
    double begun = paradt__now(), cut, weighed;
    uint64_t weight = 0;
    paradt_status status = paradt_mpi__partition(w, 1, 1, &rows, &count);
    cut = paradt__now();
    w->stats.seconds_partition += cut - begun;
    if (!status) status = paradt_mpi__adopt_rows(w, rows, count);
    if (!status) status = paradt_mpi__point_weight(w, &weight);
    weighed = paradt__now();
    w->stats.seconds_grid += weighed - cut;
    if (!status && weight) {
        paradt_mpi__free_points(w);
        status = paradt_mpi__partition(w, weight, PARADT_MPI__MEAN, &rows, &count);
        if (!status) status = paradt_mpi__agree(w, paradt_mpi__sort_by_id(w, &rows, count));
        cut = paradt__now();
        w->stats.seconds_partition += cut - weighed;
        if (!status) status = paradt_mpi__adopt_rows(w, rows, count);
        w->stats.seconds_grid += paradt__now() - cut;
    }
    paradt__release(&w->memory, rows);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>directory
//
// What every rank knows about all others: up to 64 boxes that contain a rank's points (those of the finest level of its
// grid that has no more), their common bounding box, and the rank's own box with the margin around it within which the
// rank wants to know all points. The directory alone decides which ranks may have a point somewhere, on the safe side:
// every point of a rank is in one of its boxes. A rank without a grid has no boxes and is never asked.
//
// Doors: paradt_mpi__exchange_boxes, paradt_mpi__may_have, paradt_mpi__rank_box, paradt_mpi__padded_box,
// paradt_mpi__directory_free.

enum { PARADT_MPI__GROUPS = 8 }; // groups of eight boxes that a rank publishes at most

// The margin that a rank wants, in sizes of a grid cell. Points that are asked for cost more than points that are
// guessed, so the margin is as wide as more guessed points still take less time than they save.
#define PARADT_MPI__MARGIN 0.5
// In margins: most spheres that a rank may have to ask about end within this distance of its points.
#define PARADT_MPI__VICINITY 4

// Sets each rank's bounding box to that of its boxes.
static void paradt_mpi__bound_ranks(paradt_mpi__work *w) {
    paradt_mpi__directory *d = &w->directory;
    size_t rows = d->width / PARADT__LANES, row;
    int r, b;
    for (r = 0; r < w->ranks; r++) {
        const double *boxes = d->groups + (size_t)r * PARADT_MPI__GROUPS * d->width;
        double *box = d->rank_boxes + (size_t)(r / PARADT__LANES) * d->width + r % PARADT__LANES;
        for (row = 0; row < rows && d->box_count[r]; row++) {
            int lower = row < 2 * (size_t)w->dim && row % 2 == 0; // the last row is the largest grade
            double *to = box + row * PARADT__LANES;
            *to = boxes[row * PARADT__LANES];
            for (b = 1; b < d->box_count[r]; b++) {
                double x =
                    boxes[(size_t)(b / PARADT__LANES) * d->width + row * PARADT__LANES + (size_t)(b % PARADT__LANES)];
                if (lower ? x < *to : x > *to) *to = x;
            }
        }
    }
}

// Returns the first bound of a rank's bounding box; the others follow at intervals of PARADT__LANES.
static const double *paradt_mpi__rank_box(const paradt_mpi__directory *d, int rank) {
    return d->rank_boxes + (size_t)(rank / PARADT__LANES) * d->width + rank % PARADT__LANES;
}

// May the rank have points in the box? Asks its bounding box alone. box: low and high of each axis that orients
static int paradt_mpi__may_have(const paradt_mpi__work *w, int rank, const double *box) {
    const paradt_mpi__directory *d = &w->directory;
    const double *bounds = paradt_mpi__rank_box(d, rank);
    int j = 0;
    PARADT_ASSERT(rank >= 0 && rank < w->ranks);
    if (!d->box_count[rank]) return 0;
    for (; j < w->set.space.dim && bounds[0] <= box[1] && bounds[PARADT__LANES] >= box[0]; j++, box += 2)
        bounds += 2 * PARADT__LANES;
    return j == w->set.space.dim;
}

// Lists the ranks that may have points no farther than `margin` from this rank's bounding box, and on which sides of it
// these lie.
static void paradt_mpi__list_nearby(paradt_mpi__work *w, double margin) {
    paradt_mpi__directory *d = &w->directory;
    const double *mine = paradt_mpi__rank_box(d, w->rank), *theirs;
    int sides = 2 * w->set.space.dim, r, j;
    for (j = 0; j < sides; j++) {
        d->own[j] = mine[j * PARADT__LANES];
        d->vicinity[j] = d->own[j] + (j % 2 ? margin : -margin);
    }
    d->nearby_count = 0;
    for (r = 0; r < w->ranks; r++) {
        paradt_mpi__nearby_rank *found = d->nearby + d->nearby_count;
        if (r == w->rank || !paradt_mpi__may_have(w, r, d->vicinity)) continue;
        theirs = paradt_mpi__rank_box(d, r);
        found->rank = r;
        found->beyond = 0;
        for (j = 0; j < sides; j += 2) {
            found->beyond |= (unsigned)(theirs[(j + 1) * PARADT__LANES] < d->own[j]) << j;
            found->beyond |= (unsigned)(theirs[j * PARADT__LANES] > d->own[j + 1]) << (j + 1);
        }
        d->nearby_count++;
    }
}

// Returns the margin around this rank's box within which it wants to know all points: about as far as most spheres at
// its border reach. That is estimated by the size of the grid cells at the border, whose harmonic mean favours small
// ones.
static double paradt_mpi__wanted_margin(const paradt_mpi__work *w) {
    size_t box, nearby = 0;
    double inverse = 0.0;
    int j;
    for (box = 0; box < w->grid.box_count[0]; box++) {
        const double *group = w->grid.boxes[0] + box / PARADT__LANES * w->grid.group_width + box % PARADT__LANES;
        double side = 0.0, gap = PARADT__FAR;
        for (j = 0; j < w->dim; j++) {
            double low = group[2 * j * PARADT__LANES], high = group[(2 * j + 1) * PARADT__LANES];
            side = paradt__larger(side, high - low);
            gap = -paradt__larger(-gap, paradt__larger(w->complete[2 * j] - low, high - w->complete[2 * j + 1]));
        }
        if (gap > side || !(side > 0.0)) continue;
        inverse += 1.0 / side;
        nearby++;
    }
    return nearby ? PARADT_MPI__MARGIN * (double)nearby / inverse : 0.0;
}

// Fills the directory. Collective.
static paradt_status paradt_mpi__exchange_boxes(paradt_mpi__work *w) {
    paradt_mpi__directory *d = &w->directory;
    size_t ranks = (size_t)w->ranks, size, capacity;
    double *mine, margin;
    int count = 0, level = 0;
    paradt_status status = PARADT_OK;
    d->width = (size_t)(2 * w->dim + (w->set.grade != PARADT__UNGRADED)) * PARADT__LANES;
    size = PARADT_MPI__GROUPS * d->width;
    capacity = (ranks + PARADT__LANES - 1) / PARADT__LANES * d->width;
    d->groups = (double *)paradt__alloc(&w->memory, ranks * size, sizeof *d->groups);
    d->box_count = (int *)paradt__alloc(&w->memory, ranks, sizeof *d->box_count);
    d->rank_boxes = (double *)paradt__alloc(&w->memory, capacity, sizeof *d->rank_boxes);
    d->wanted = (double *)paradt__alloc(&w->memory, ranks, (2 * (size_t)w->dim + 1) * sizeof *d->wanted);
    d->nearby = (paradt_mpi__nearby_rank *)paradt__alloc(&w->memory, ranks, sizeof *d->nearby);
    d->candidates = (int *)paradt__alloc(&w->memory, ranks, sizeof *d->candidates);
    mine = (double *)paradt__alloc(&w->memory, size, sizeof *mine);
    if (!d->groups || !d->box_count || !d->rank_boxes || !d->wanted || !d->nearby || !d->candidates || !mine)
        status = PARADT_ERROR_MEMORY;
    status = paradt_mpi__agree(w, status);
    if (!status) {
        memset(mine, 0, size * sizeof *mine);
        if (w->has_grid) {
            while (w->grid.box_count[level] > (size_t)PARADT_MPI__GROUPS * PARADT__LANES) level++;
            PARADT_ASSERT(level < w->grid.levels && w->grid.group_width == d->width);
            count = (int)w->grid.box_count[level];
            size = ((size_t)count + PARADT__LANES - 1) / PARADT__LANES * d->width;
            memcpy(mine, w->grid.boxes[level], size * sizeof *mine);
        }
        size = PARADT_MPI__GROUPS * d->width;
        MPI_Allgather(mine, (int)size, MPI_DOUBLE, d->groups, (int)size, MPI_DOUBLE, w->comm);
        MPI_Allgather(&count, 1, MPI_INT, d->box_count, 1, MPI_INT, w->comm);
        memset(d->rank_boxes, 0, capacity * sizeof *d->rank_boxes);
        paradt_mpi__bound_ranks(w);
        size = 2 * (size_t)w->dim + 1;
        memcpy(mine, w->complete, (size - 1) * sizeof *mine);
        mine[size - 1] = margin = w->has_grid && w->set.space.filtered ? paradt_mpi__wanted_margin(w) : 0.0;
        MPI_Allgather(mine, (int)size, MPI_DOUBLE, d->wanted, (int)size, MPI_DOUBLE, w->comm);
        paradt_mpi__list_nearby(w, PARADT_MPI__VICINITY * margin);
    }
    paradt__release(&w->memory, mine);
    return status;
}

// Sets *box to a rank's own box, widened by `part` of the margin that it wants.
static void paradt_mpi__padded_box(const paradt_mpi__work *w, int rank, double part, double *box) {
    const double *own = w->directory.wanted + (size_t)rank * (2 * (size_t)w->dim + 1);
    double margin = own[2 * w->dim] * part;
    int j;
    PARADT_ASSERT(part >= 0.0 && part <= 1.0 && margin >= 0.0);
    for (j = 0; j < w->dim; j++) {
        box[2 * j] = own[2 * j] - margin;
        box[2 * j + 1] = own[2 * j + 1] + margin;
    }
}

// Frees the directory.
static void paradt_mpi__directory_free(paradt_mpi__work *w) {
    paradt_mpi__directory *d = &w->directory;
    paradt__release(&w->memory, d->groups);
    paradt__release(&w->memory, d->box_count);
    paradt__release(&w->memory, d->rank_boxes);
    paradt__release(&w->memory, d->wanted);
    paradt__release(&w->memory, d->nearby);
    paradt__release(&w->memory, d->candidates);
    memset(d, 0, sizeof *d);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>guess
//
// Step 1: each rank sends others those of its points that they will probably need. A guess only saves questions; no
// result depends on it. A point goes to a rank that has a box nearer than some multiple of the size of the point's grid
// cell: a cell has eight points, so its size adapts to their density. All points in a margin around a rank's own box go
// there as well, if they are not too many; where all ranks sent them, no sphere that ends in the margin needs a
// question.
//
// Door: paradt_mpi__guess.

// How far the guess reaches, in sizes of a grid cell; with the margin about one layer of uniform points. With less,
// most of the points that are needed are left to be asked for.
#define PARADT_MPI__REACH 0.4

// Is the box low..high nearer than `reach` to box `lane` of a group? low and high may be the same point.
PARADT__INLINE int paradt_mpi__is_near(const double *group, int lane, const double *low, const double *high, int dim,
                                       double reach) {
    double sum = 0.0;
    int j;
    for (j = 0; j < dim; j++) {
        double below = group[2 * j * PARADT__LANES + lane] - high[j];
        double above = low[j] - group[(2 * j + 1) * PARADT__LANES + lane];
        double away = paradt__larger(paradt__larger(below, above), 0.0);
        sum += away * away;
    }
    return sum < reach * reach;
}

typedef struct paradt_mpi__near_boxes {                       // some of a rank's boxes
    const double *groups;                                     // all boxes of the rank
    size_t width;                                             // of a group
    int count;                                                //
    unsigned char number[PARADT_MPI__GROUPS * PARADT__LANES]; // [count] which boxes
} paradt_mpi__near_boxes;

// Is the box low..high nearer than `reach` to the i-th of the boxes?
PARADT__INLINE int paradt_mpi__is_near_box(const paradt_mpi__near_boxes *boxes, int i, const double *low,
                                           const double *high, int dim, double reach) {
    int number = boxes->number[i];
    const double *group = boxes->groups + (size_t)(number / PARADT__LANES) * boxes->width;
    return paradt_mpi__is_near(group, number % PARADT__LANES, low, high, dim, reach);
}

// Lists in *found those of the boxes that are nearer than `reach` to the box low..high. Returns their number.
static int paradt_mpi__list_near_boxes(const paradt_mpi__near_boxes *boxes, const double *low, const double *high,
                                       int dim, double reach, paradt_mpi__near_boxes *found) {
    int i;
    found->groups = boxes->groups;
    found->width = boxes->width;
    found->count = 0;
    for (i = 0; i < boxes->count; i++) {
        found->number[found->count] = boxes->number[i];
        found->count += paradt_mpi__is_near_box(boxes, i, low, high, dim, reach);
    }
    return found->count;
}

// Is the point nearer than `reach` to any of the boxes?
static int paradt_mpi__is_near_any(const paradt_mpi__near_boxes *boxes, const double *x, int dim, double reach) {
    int i = 0;
    while (i < boxes->count && !paradt_mpi__is_near_box(boxes, i, x, x, dim, reach)) i++;
    return i < boxes->count;
}

// Returns slightly more than the smallest distance between the first point of a grid cell and its others: in a lattice,
// just above the step.
static double paradt_mpi__lattice_step(const paradt_mpi__work *w, size_t box) {
    const double *first = w->set.records + box * PARADT__LANES * w->set.width;
    double least = PARADT__FAR;
    size_t i;
    int j;
    for (i = 1; i < PARADT__LANES && box * PARADT__LANES + i < w->set.count; i++) {
        double sum = 0.0;
        for (j = 0; j < w->dim; j++) {
            double away = first[i * w->set.width + (size_t)j] - first[j];
            sum += away * away;
        }
        if (sum < least) least = sum;
    }
    return least < PARADT__FAR ? 1.01 * sqrt(least) : 0.0;
}

// Returns how near to another rank's box a box of the grid must be for its points to be sent there. low, high: set to
// the box's bounds
static double paradt_mpi__guess_reach(const paradt_mpi__work *w, int level, size_t box, double *low, double *high) {
    const double *group = w->grid.boxes[level] + box / PARADT__LANES * w->grid.group_width + box % PARADT__LANES;
    double side = 0.0;
    int j;
    for (j = 0; j < w->dim; j++) {
        low[j] = group[2 * j * PARADT__LANES];
        high[j] = group[(2 * j + 1) * PARADT__LANES];
        side = paradt__larger(side, high[j] - low[j]);
    }
    side *= PARADT_MPI__REACH;
    return level ? side : paradt__larger(side, paradt_mpi__lattice_step(w, box));
}

// Lists for a rank those points in one box of the grid that are near to the rank's boxes. boxes: those of its boxes
// that are near to the parent of this box. Where a lattice's step exceeds the parent's reach, points are missed; they
// will be asked for.
static paradt_status paradt_mpi__guess_box(paradt_mpi__work *w, paradt_mpi__list *list, int rank, int level, size_t box,
                                           const paradt_mpi__near_boxes *boxes) {
    size_t i, end = (box + 1) * PARADT__LANES, below = level ? w->grid.box_count[level - 1] : w->set.count;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM], reach = paradt_mpi__guess_reach(w, level, box, low, high);
    paradt_mpi__near_boxes nearby;
    paradt_status status = PARADT_OK;
    if (!paradt_mpi__list_near_boxes(boxes, low, high, w->dim, reach, &nearby)) return PARADT_OK;
    for (i = box * PARADT__LANES; i < end && i < below && !status; i++) {
        const double *x = w->set.records + i * w->set.width;
        if (level) status = paradt_mpi__guess_box(w, list, rank, level - 1, i, &nearby);
        else if (paradt_mpi__is_near_any(&nearby, x, w->dim, reach))
            status = paradt_mpi__list_unsent(w, list, rank, (paradt_index)i);
    }
    return status;
}

// Lists for a rank the points that are near to its boxes.
static paradt_status paradt_mpi__guess_for(paradt_mpi__work *w, paradt_mpi__list *list, int rank) {
    const paradt_mpi__directory *d = &w->directory;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM], reach;
    paradt_mpi__near_boxes all;
    paradt_status status = PARADT_OK;
    int top = w->grid.levels - 1, i;
    size_t box;
    all.groups = d->groups + (size_t)rank * PARADT_MPI__GROUPS * d->width;
    all.width = d->width;
    all.count = d->box_count[rank];
    for (i = 0; i < all.count; i++) all.number[i] = (unsigned char)i;
    for (box = 0; box < w->grid.box_count[top] && !status; box++) {
        reach = paradt_mpi__guess_reach(w, top, box, low, high);
        if (paradt_mpi__is_near(paradt_mpi__rank_box(d, rank), 0, low, high, w->dim, reach))
            status = paradt_mpi__guess_box(w, list, rank, top, box, &all);
    }
    return status;
}

// Lists the points in one box of the grid that lie within the bounds and were not sent to the rank, until the list has
// `most` points.
static paradt_status paradt_mpi__list_in_box(paradt_mpi__work *w, paradt_mpi__list *list, int rank,
                                             const double *bounds, int level, size_t box, size_t most) {
    const double *group = w->grid.boxes[level] + box / PARADT__LANES * w->grid.group_width + box % PARADT__LANES;
    size_t i, end = (box + 1) * PARADT__LANES, below = level ? w->grid.box_count[level - 1] : w->set.count;
    paradt_status status = PARADT_OK;
    int j;
    for (j = 0; j < w->dim; j++) {
        if (group[2 * j * PARADT__LANES] > bounds[2 * j + 1] || group[(2 * j + 1) * PARADT__LANES] < bounds[2 * j])
            return PARADT_OK;
    }
    for (i = box * PARADT__LANES; i < end && i < below && !status && list->count < most; i++) {
        const double *x = w->set.records + i * w->set.width;
        if (level) {
            status = paradt_mpi__list_in_box(w, list, rank, bounds, level - 1, i, most);
            continue;
        }
        for (j = 0; j < w->dim && x[j] >= bounds[2 * j] && x[j] <= bounds[2 * j + 1];) j++;
        if (j == w->dim && !paradt_mpi__was_sent(w, rank, (paradt_index)i))
            status = paradt_mpi__list_add(w, list, rank, (paradt_index)i);
    }
    return status;
}

// Lists for a rank all points in the margin that it wants, or in half or a quarter of that: the widest with at most a
// third as many points as were guessed, plus a few. *kept: set to the part of the margin, 0: none
static paradt_status paradt_mpi__fill_margin(paradt_mpi__work *w, paradt_mpi__list *list, int rank, size_t guessed,
                                             double *kept) {
    double bounds[2 * PARADT_MAX_DIM];
    paradt_mpi__list found;
    size_t most = guessed / 3 + 64, box, i;
    int top = w->grid.levels - 1;
    paradt_status status = PARADT_OK;
    memset(&found, 0, sizeof found);
    for (*kept = 1.0; *kept > 0.0 && !status; *kept = *kept > 0.25 ? 0.5 * *kept : 0.0) {
        found.count = 0;
        paradt_mpi__padded_box(w, rank, *kept, bounds);
        for (box = 0; box < w->grid.box_count[top] && !status; box++)
            status = paradt_mpi__list_in_box(w, &found, rank, bounds, top, box, most);
        if (found.count < most) break;
    }
    if (!(*kept > 0.0)) found.count = 0;
    for (i = 0; i < found.count && !status; i++)
        status = paradt_mpi__list_unsent(w, list, rank, found.items[i].position);
    paradt__release(&w->memory, found.items);
    return status;
}

// Widens the box that is complete by the part of the margin that all other ranks sent. Collective. kept: [ranks] the
// part that this rank sent to each; of_others: [ranks], overwritten
static void paradt_mpi__set_complete(paradt_mpi__work *w, const double *kept, double *of_others) {
    double least = 1.0;
    int r;
    MPI_Alltoall(kept, (int)sizeof *kept, MPI_BYTE, of_others, (int)sizeof *kept, MPI_BYTE, w->comm);
    for (r = 0; r < w->ranks; r++) least = of_others[r] < least ? of_others[r] : least;
    paradt_mpi__padded_box(w, w->rank, least, w->complete);
}

// Sends and receives the guessed points and sets w->complete. Collective.
static paradt_status paradt_mpi__guess(paradt_mpi__work *w) {
    paradt_mpi__list list;
    paradt_status status = PARADT_OK;
    size_t added, ranks = (size_t)w->ranks;
    double *kept = (double *)paradt__alloc(&w->memory, 2 * ranks, sizeof *kept);
    int r;
    PARADT_ASSERT(w->directory.groups && !w->inserting);
    memset(&list, 0, sizeof list);
    if (!kept) status = PARADT_ERROR_MEMORY;
    for (r = 0; r < w->ranks && !status; r++) {
        size_t before = list.count;
        kept[r] = 1.0;
        if (r == w->rank || !w->directory.box_count[r] || !w->has_grid) continue;
        status = paradt_mpi__guess_for(w, &list, r);
        if (!status) status = paradt_mpi__fill_margin(w, &list, r, list.count - before, kept + r);
    }
    status = paradt_mpi__agree(w, paradt_mpi__exchange_points(w, status, &list, &added));
    if (!status) paradt_mpi__set_complete(w, kept, kept + ranks);
    w->stats.points_guessed = added;
    paradt__release(&w->memory, list.items);
    paradt__release(&w->memory, kept);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>local
//
// The local triangulation: of all points known to this rank, made by the caller's method. By insertion, undivided, it
// goes on when more points arrive, and its cells stand in the engine (>>known points), ghosts included, until the
// result is taken. Any other method makes it from the beginning each time. Cells have places in both: see
// paradt_mpi__place_count, paradt_mpi__topics and paradt_mpi__cell. Nothing here is collective.
//
// Doors: paradt_mpi__triangulate_known, paradt_mpi__place_count, paradt_mpi__topics, paradt_mpi__cell,
// paradt_mpi__account_local, paradt_mpi__free_local.

// Adds what the making of w->local held, and what w->local holds, to the rank's account.
static void paradt_mpi__account_local(paradt_mpi__work *w) {
    paradt_mpi__add_peak(w, &w->local);
    PARADT_ASSERT(!w->local_bytes);
    w->local_bytes = paradt__block_bytes(w->local.cells) + paradt__block_bytes(w->local.neighbors) +
                     paradt__block_bytes(w->local.representative);
    w->memory.held += w->local_bytes;
}

// Frees w->local, whoever accounts for it.
static void paradt_mpi__free_local(paradt_mpi__work *w) {
    PARADT_ASSERT(w->memory.held >= w->local_bytes);
    if (w->local_bytes) {
        paradt_free(&w->local);
    } else {
        paradt__release(&w->memory, w->local.cells);
        paradt__release(&w->memory, w->local.neighbors);
        memset(&w->local, 0, sizeof w->local);
    }
    w->memory.held -= w->local_bytes;
    w->local_bytes = 0;
}

// Triangulates all known points from the beginning, by any method.
static paradt_status paradt_mpi__triangulate_anew(paradt_mpi__work *w) {
    paradt_points points;
    paradt_options options;
    double *weights = NULL;
    size_t i;
    paradt_status status;
    paradt_mpi__free_local(w);
    memset(&points, 0, sizeof points);
    if (w->weighted) {
        weights = (double *)paradt__alloc(&w->memory, w->known, sizeof *weights);
        if (!weights) return PARADT_ERROR_MEMORY;
        for (i = 0; i < w->known; i++) weights[i] = w->set.records[i * w->set.width + (size_t)w->dim];
    }
    points.data = w->set.records;
    points.count = w->known;
    points.dim = w->dim;
    points.stride = w->set.width * sizeof(double);
    points.weights = weights;
    options = paradt_mpi__local_options(w);
    status = paradt_triangulate(&w->local, &points, &options);
    paradt_mpi__account_local(w);
    paradt__release(&w->memory, weights);
    return status;
}

// Inserts the known points that are not inserted yet. They are sorted along a curve, as the walk to each starts at the
// one before, within rounds of growing size: neighbouring points inserted one after another beyond a flat hull would
// make very large stars.
static paradt_status paradt_mpi__insert_new(paradt_mpi__work *w) {
    paradt__set all = w->set, added = w->set;
    size_t first = paradt__known_count(&w->engine), i;
    paradt_index *order;
    paradt_status status = PARADT_OK;
    PARADT_ASSERT(w->inserting && w->set.count <= first && first <= w->known);
    all.count = w->known;
    added.records = w->set.records + first * w->set.width;
    added.count = w->known - first;
    order = paradt__late_order(&added, &w->memory);
    if (!order) return PARADT_ERROR_MEMORY;
    for (i = 0; i < added.count && !status; i++) {
        if (i % PARADT__REPORT_STEP == 0) status = paradt_mpi__check_cancel(w, (double)i / (double)added.count);
        if (!status) status = paradt__known_insert(&w->engine, &all, (paradt_index)first + order[i]);
    }
    paradt__release(&w->memory, order);
    return status;
}

// Inserts the known points: all of them the first time, later those that are new.
static paradt_status paradt_mpi__insert(paradt_mpi__work *w) {
    paradt__set all = w->set;
    paradt_options options;
    paradt__progress progress;
    if (w->inserting) return paradt_mpi__insert_new(w);
    all.count = w->known;
    options = paradt_mpi__local_options(w);
    paradt__meter_begin(&w->meter, &options);
    w->meter_reported = 0;
    progress = paradt__progress_of(&w->meter, &w->meter_reported, 1.0);
    w->inserting = 1;
    return paradt__known_begin(&w->engine, &all, w->set.count, w->low, w->high, &w->memory, &progress);
}

// Is the local triangulation made by insertion that goes on when points arrive? PARADT_AUTO prefers it in one dimension
// more where there are several ranks, as other methods triangulate twice then.
static int paradt_mpi__can_insert(const paradt_mpi__work *w) {
    int dim = w->set.space.dim;
    const paradt__method *method = paradt__choose_method(w->options.local.method, dim - (w->ranks > 1), 0);
    return dim > 0 && method->can & PARADT__CAN_LIVE && w->options.local.regions <= 1;
}

// Triangulates the known points. A rank without own points makes nothing.
static paradt_status paradt_mpi__triangulate_known(paradt_mpi__work *w) {
    double begun = paradt__now();
    paradt_status status = paradt_mpi__check_cancel(w, 0.0);
    PARADT_ASSERT(w->known >= w->set.count);
    if (status || !w->set.count) return status;
    status = paradt_mpi__can_insert(w) ? paradt_mpi__insert(w) : paradt_mpi__triangulate_anew(w);
    w->stats.triangulations++;
    w->stats.seconds_build += paradt__now() - begun;
    return status;
}

// Returns the number of places, of which some may be free or have ghosts while points are inserted.
static size_t paradt_mpi__place_count(const paradt_mpi__work *w) {
    return w->inserting ? paradt__known_mesh(&w->engine)->count : w->local.cell_count;
}

enum { PARADT_MPI__SPHERE = 1 << (PARADT_MAX_DIM + 1) }; // beside a bit for each facet

// Returns what there is to ask about a place: PARADT_MPI__SPHERE for the sphere of its cell, bit j for the hull facet
// opposite vertex j; 0: nothing, the place is free. While points are inserted, a ghost stands for its hull facet, and
// *place is replaced by the place of the cell behind it.
PARADT__INLINE unsigned paradt_mpi__topics(const paradt_mpi__work *w, size_t k, size_t *place) {
    size_t j;
    unsigned topics = PARADT_MPI__SPHERE;
    int facet;
    PARADT_ASSERT(k == (size_t)w->set.space.dim + 1 && *place < paradt_mpi__place_count(w));
    if (w->inserting) {
        if (!paradt__mesh_behind_ghost(paradt__known_mesh(&w->engine), k, place, &facet)) return 0;
        return facet < 0 ? topics : 1u << facet;
    }
    for (j = 0; j < k; j++) topics |= (unsigned)(w->local.neighbors[*place * k + j] < 0) << j;
    return topics;
}

// Copies the vertices of the cell at a place, as positions, and pointers to their records.
PARADT__INLINE void paradt_mpi__cell(const paradt_mpi__work *w, size_t k, size_t place, paradt_index *cell,
                                     const double **corners) {
    size_t j;
    PARADT_ASSERT(k == (size_t)w->set.space.dim + 1 && place < paradt_mpi__place_count(w));
    if (w->inserting) {
        paradt__scene_cell(paradt__known_scene(&w->engine), k, place, cell, corners);
        return;
    }
    for (j = 0; j < k; j++) {
        cell[j] = w->local.cells[place * k + j];
        corners[j] = paradt__record(&w->set, cell[j]);
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// >>questions
//
// Step 2, on the rank that asks: which cells of the local triangulation could be wrong, and which ranks may know
// better? A cell or hull facet with an own vertex is right unless a point that this rank does not know is in conflict
// with it. It is asked about where such a point may lie in its sphere, or beyond the facet, by the boxes of the
// directory. Where a cell has points of several ranks for vertices, its own vertices are sent to the others' ranks
// without a question, unless there are weights. A rank that was sent all own vertices of a cell need not be asked about
// it.
//
// While points are inserted, not all cells need be looked at. Let K be the box in which all points are known
// (w->complete) and q a point that is not known. K is convex, so q is outside K. As shown in >>fringe of paradt.h, if
// q is in conflict with any cell that has an own vertex, it is in conflict with a suspect: a ghost, a cell with a
// vertex outside K, or a cell with just one own vertex, all of which are in the fringe. The search starts at the ghosts
// and the cells with just one own vertex, and goes on through facets from each cell that is exposed: one whose sphere
// is not inside K. So it comes to all suspects. For cells with own vertices and vertices outside K are exposed. Suppose
// that from one of them none of those where the search starts is reached through such cells. Each facet of theirs has
// an own vertex then, hence all cells around each of their vertices outside K are such cells, and no ghost is. Let x be
// the one of these vertices that is farthest beyond one side of K. The cells around x surround it, so one of them has a
// vertex that is still farther, and it is one of these vertices, too. (Where K is empty, and with weights, all cells
// with own and others' vertices are exposed; then the own points' bounding box takes the place of K here.)
//
// Errors of floating-point arithmetic only add questions. Nothing here is collective but paradt_mpi__set_budget.
//
// Doors: paradt_mpi__collect_questions, paradt_mpi__set_budget, paradt_mpi__is_over_budget.

typedef struct paradt_mpi__question { // about a cell, or one of its facets on the hull
    int rank;                         // that is asked
    int opposite;                     // vertex opposite the facet; -1: about the cell
    paradt_index cell;                // its place
} paradt_mpi__question;

typedef struct paradt_mpi__questions {
    size_t count, capacity;
    paradt_mpi__question *items;
    paradt_mpi__list to_send; // own points to be sent without a question
} paradt_mpi__questions;

// Sets own[j] to vertex j of the cell if that is an own point, else to PARADT__OPEN. Returns the number of own points.
PARADT__INLINE int paradt_mpi__own_vertices(const paradt_mpi__work *w, size_t k, const paradt_index *cell,
                                            paradt_index *own) {
    size_t i;
    int count = 0;
    for (i = 0; i < k; i++) {
        own[i] = (size_t)cell[i] < w->set.count ? cell[i] : (paradt_index)PARADT__OPEN;
        count += own[i] >= 0;
    }
    return count;
}

// Lists a question.
static paradt_status paradt_mpi__ask(paradt_mpi__work *w, paradt_mpi__questions *q, int rank, paradt_index cell,
                                     int opposite) {
    void *items = paradt_mpi__reserve_one(w, q->items, q->count, &q->capacity, sizeof *q->items);
    PARADT_ASSERT(rank != w->rank && w->directory.box_count[rank] && opposite <= w->set.space.dim);
    if (!items) return PARADT_ERROR_MEMORY;
    q->items = (paradt_mpi__question *)items;
    q->items[q->count].rank = rank;
    q->items[q->count].cell = cell;
    q->items[q->count++].opposite = opposite;
    return PARADT_OK;
}

// Was the rank sent all own vertices of the cell? Without weights it need not be asked then; with weights the answer is
// always no.
static int paradt_mpi__was_sent_cell(const paradt_mpi__work *w, int rank, const paradt_index *cell) {
    int i;
    if (w->weighted) return 0;
    for (i = 0; i <= w->set.space.dim; i++) {
        if ((size_t)cell[i] < w->set.count && !paradt_mpi__was_sent(w, rank, cell[i])) return 0;
    }
    return 1;
}

// May one of the rank's boxes contain an answer to the question that the search is set to?
static int paradt_mpi__boxes_may_answer(const paradt_mpi__work *w, int rank) {
    const paradt_mpi__directory *d = &w->directory;
    const double *groups = d->groups + (size_t)rank * PARADT_MPI__GROUPS * d->width;
    int left;
    for (left = d->box_count[rank]; left > 0; left -= PARADT__LANES, groups += d->width) {
        unsigned valid = left < PARADT__LANES ? (1u << left) - 1 : 255u;
        if (paradt__question_boxes(&w->search, groups) & valid) return 1;
    }
    return 0;
}

// Returns the ranks of a group of eight whose bounding boxes may contain an answer to the question that the search is
// set to, as bits.
static unsigned paradt_mpi__ranks_may_answer(const paradt_mpi__work *w, int group) {
    return paradt__question_boxes(&w->search, w->directory.rank_boxes + (size_t)group * w->directory.width);
}

// Lists the question that the search is set to for a rank whose bounding box may contain an answer, if the rank must be
// asked.
static paradt_status paradt_mpi__ask_rank(paradt_mpi__work *w, paradt_mpi__questions *q, int rank,
                                          const paradt_index *cell, size_t place, int opposite) {
    // A rank with a vertex of the cell, which is on its sphere, has a box that may contain an answer.
    if (paradt_mpi__was_sent_cell(w, rank, cell) || !paradt_mpi__boxes_may_answer(w, rank)) return PARADT_OK;
    return paradt_mpi__ask(w, q, rank, (paradt_index)place, opposite);
}

// Lists the question that the search is set to for all ranks that must be asked.
static paradt_status paradt_mpi__ask_ranks(paradt_mpi__work *w, paradt_mpi__questions *q, const paradt_index *cell,
                                           size_t place, int opposite) {
    paradt_status status = PARADT_OK;
    int group, lane;
    for (group = 0; group * PARADT__LANES < w->ranks; group++) {
        unsigned mask = paradt_mpi__ranks_may_answer(w, group);
        for (lane = 0; lane < PARADT__LANES && !status; lane++) {
            int r = group * PARADT__LANES + lane;
            if (!(mask >> lane & 1) || r >= w->ranks || r == w->rank || !w->directory.box_count[r]) continue;
            status = paradt_mpi__ask_rank(w, q, r, cell, place, opposite);
        }
    }
    return status;
}

// Sets box (low and high of each axis) to one that surely contains the sphere of a tetrahedron. Returns 0 if the
// tetrahedron is too flat for that.
//
// Let a, b, c be the edges from p[0], m the largest magnitude of their components, and u = 2^-52. The centre is
// p[0] + N / (2 det) with N = |a|^2 b x c + |b|^2 c x a + |c|^2 a x b. Computed in any order, fused or not, det has an
// error below 64 u m^3 and N one below 512 u m^4. Where |det| > 2^-20 m^3, the centre's error is therefore below
// 2^-24 m + 2^-25 |centre - p[0]|. The radius is enlarged by 2^-20 (m + radius) + 10^-15 times the largest coordinate,
// which covers the roundings of radius and bounds as well.
static int paradt_mpi__sphere_box3(const double *const *p, double *box) {
    double e[3][3], square[3], n[3], cross[3], det, m = 0.0, radius, extent = 0.0;
    int i, j;
    for (i = 0; i < 3; i++) {
        for (j = 0; j < 3; j++) {
            e[i][j] = p[i + 1][j] - p[0][j];
            m = paradt__larger(m, paradt__abs(e[i][j]));
        }
        square[i] = e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2];
    }
    for (j = 0; j < 3; j++) {
        int k = j == 2 ? 0 : j + 1, l = j == 0 ? 2 : j - 1;
        cross[j] = e[1][k] * e[2][l] - e[1][l] * e[2][k];
        n[j] = square[0] * cross[j] + square[1] * (e[2][k] * e[0][l] - e[2][l] * e[0][k]) +
               square[2] * (e[0][k] * e[1][l] - e[0][l] * e[1][k]);
    }
    det = e[0][0] * cross[0] + e[0][1] * cross[1] + e[0][2] * cross[2];
    if (!(paradt__abs(det) > 9.5367431640625e-07 * m * m * m)) return 0;
    for (j = 0; j < 3; j++) {
        n[j] *= 0.5 / det;
        extent = paradt__larger(extent, paradt__abs(p[0][j]));
    }
    radius = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    radius += 9.5367431640625e-07 * (m + radius) + 1e-15 * extent;
    for (j = 0; j < 3; j++) {
        box[2 * j] = p[0][j] + (n[j] - radius);
        box[2 * j + 1] = p[0][j] + (n[j] + radius);
    }
    return 1;
}

// Is the box strictly inside the outer one?
static int paradt_mpi__is_within(const double *box, const double *outer, int dim) {
    int j = 0;
    while (j < dim && box[2 * j] > outer[2 * j] && box[2 * j + 1] < outer[2 * j + 1]) j++;
    return j == dim;
}

// Adds the rank to d->candidates if it may have points in the box and was not sent all own vertices of the cell.
PARADT__INLINE void paradt_mpi__try_candidate(paradt_mpi__work *w, int rank, const paradt_index *cell,
                                              const double *box, int *found) {
    if (rank != w->rank && paradt_mpi__may_have(w, rank, box) && !paradt_mpi__was_sent_cell(w, rank, cell))
        w->directory.candidates[(*found)++] = rank;
}

// Lists in d->candidates all ranks that may have points in the box and were not sent all own vertices of the cell.
// Returns their number. A box within the vicinity needs few tests: it can meet a nearby rank's points only if it
// reaches beyond each bound of the own points that separates them.
static int paradt_mpi__find_candidates(paradt_mpi__work *w, const paradt_index *cell, const double *box) {
    const paradt_mpi__directory *d = &w->directory;
    int found = 0, i;
    unsigned beyond = 0;
    if (!paradt_mpi__is_within(box, d->vicinity, w->set.space.dim)) {
        for (i = 0; i < w->ranks; i++) paradt_mpi__try_candidate(w, i, cell, box, &found);
        return found;
    }
    for (i = 0; i < 2 * w->set.space.dim; i += 2)
        beyond |= (unsigned)(box[i] < d->own[i]) << i | (unsigned)(box[i + 1] > d->own[i + 1]) << (i + 1);
    for (i = 0; i < d->nearby_count; i++) {
        if (!(d->nearby[i].beyond & ~beyond)) paradt_mpi__try_candidate(w, d->nearby[i].rank, cell, box, &found);
    }
    return found;
}

// Lists the questions about the sphere of a cell. *exposed: set to whether a point that is not known here may be in it.
static paradt_status paradt_mpi__ask_about_sphere(paradt_mpi__work *w, paradt_mpi__questions *q, size_t place,
                                                  const paradt_index *cell, const double **corners,
                                                  const paradt_index *own, int count, int *exposed) {
    double box[6];
    int plain = w->set.space.dim == 3 && w->set.space.ambient == 3 && w->set.grade == PARADT__UNGRADED;
    int certain = plain && w->set.space.filtered && paradt_mpi__sphere_box3(corners, box), candidates = 0, i;
    paradt_status status = PARADT_OK;
    *exposed = !certain || !paradt_mpi__is_within(box, w->complete, 3);
    if (*exposed && certain) candidates = paradt_mpi__find_candidates(w, cell, box);
    if (!*exposed || (certain && !candidates)) return PARADT_OK;
    paradt__question_cell(&w->search, corners, own);
    // A cell with a heavy vertex may be in conflict with a point far from its sphere, and others' points may be heavier
    // than all own ones; so with weights all cells that have such vertices are exposed.
    *exposed = (w->weighted && count <= w->set.space.dim) || !paradt__question_is_confined(&w->search, w->complete);
    if (*exposed && !certain) return paradt_mpi__ask_ranks(w, q, cell, place, -1);
    for (i = 0; i < candidates && *exposed && !status; i++) {
        int r = w->directory.candidates[i];
        if (paradt_mpi__ranks_may_answer(w, r / PARADT__LANES) >> r % PARADT__LANES & 1)
            status = paradt_mpi__ask_rank(w, q, r, cell, place, -1);
    }
    return status;
}

// Lists the questions about a place. *exposed: set to whether a point that is not known here may be in conflict with
// the cell or ghost there, and the cell has own vertices, so that it matters. A free place counts as exposed.
PARADT__INLINE paradt_status paradt_mpi__ask_about_place(paradt_mpi__work *w, paradt_mpi__questions *q, size_t k,
                                                         size_t place, int *exposed) {
    const double *corners[PARADT_MAX_DIM + 1];
    paradt_index cell[PARADT_MAX_DIM + 1], own[PARADT_MAX_DIM + 1];
    unsigned topics = paradt_mpi__topics(w, k, &place);
    paradt_status status = PARADT_OK;
    int count, j;
    *exposed = 1;
    if (!topics) return PARADT_OK;
    paradt_mpi__cell(w, k, place, cell, corners);
    count = paradt_mpi__own_vertices(w, k, cell, own);
    *exposed = count > 0;
    if (!count) return PARADT_OK;
    if (topics & PARADT_MPI__SPHERE)
        status = paradt_mpi__ask_about_sphere(w, q, place, cell, corners, own, count, exposed);
    for (topics &= ~(unsigned)PARADT_MPI__SPHERE, j = 0; topics >> j && !status; j++) {
        if (!(topics >> j & 1) || count == (own[j] >= 0)) continue;
        paradt__question_facet(&w->search, corners, own, j, 1);
        status = paradt_mpi__ask_ranks(w, q, cell, place, j);
    }
    return status;
}

// Added to the number of cells for the sake of small sets, whose questions take milliseconds at most.
enum { PARADT_MPI__SPARE_BUDGET = 100000 };

// Sets the work that questions may take, in cells. Collective.
static void paradt_mpi__set_budget(paradt_mpi__work *w) {
    w->budget = paradt_mpi__reduce_sum(w, paradt_mpi__place_count(w)) + PARADT_MPI__SPARE_BUDGET;
}

// Have answers taken more work than building all of T(P) would?
static int paradt_mpi__is_over_budget(const paradt_mpi__work *w) {
    return paradt__search_effort(&w->search) > 2 * w->budget;
}

// Gives up (w->too_costly) where a cell asks half of all ranks on average, as ranks then need nearly all points.
static void paradt_mpi__limit_questions(paradt_mpi__work *w, paradt_mpi__questions *q) {
    if (q->count <= ((uint64_t)paradt_mpi__place_count(w) * (uint64_t)w->ranks + PARADT_MPI__SPARE_BUDGET) / 2) return;
    w->too_costly = 1;
    q->count = 0;
}

typedef struct paradt_mpi__queue { // places to be asked about, in this order; places asked about stay in it
    size_t *items;                 // [capacity] all are marked in the engine
    size_t count, capacity;
} paradt_mpi__queue;

// Appends a place to the queue unless it is or was in it.
static paradt_status paradt_mpi__enqueue(paradt_mpi__work *w, paradt_mpi__queue *list, size_t place) {
    void *items;
    PARADT_ASSERT(w->inserting && place < paradt_mpi__place_count(w));
    if (!paradt__known_wait(&w->engine, place)) return PARADT_OK;
    items = paradt_mpi__reserve_one(w, list->items, list->count, &list->capacity, sizeof *list->items);
    if (!items) return PARADT_ERROR_MEMORY;
    list->items = (size_t *)items;
    list->items[list->count++] = place;
    return PARADT_OK;
}

// May there be an own vertex of a cell that was not sent to the rank of another vertex? For nearly all cells there is
// none: their other vertices are of one rank, which is the first that all own vertices were sent to. That is decided
// without branches, on the safe side. k: number of vertices, not all of which are own
PARADT__INLINE int paradt_mpi__may_have_unsent(const paradt_mpi__work *w, size_t k, const paradt_index *cell) {
    paradt_index own = (paradt_index)w->set.count;
    int lowest = INT_MAX, highest = -1, unsent = 0;
    size_t j;
    for (j = 0; j < k; j++) {
        int other = cell[j] >= own, rank = w->homes[other ? cell[j] - own : 0].rank;
        lowest = other && rank < lowest ? rank : lowest;
        highest = other && rank > highest ? rank : highest;
    }
    for (j = 0; j < k; j++) unsent |= (cell[j] < own) & (w->first_sent[cell[j] < own ? cell[j] : 0] != lowest);
    return unsent | (lowest < highest);
}

// Lists the own vertices of a cell for the ranks of its other vertices, unless they were sent before.
PARADT__NOINLINE paradt_status paradt_mpi__list_cell_unsent(paradt_mpi__work *w, paradt_mpi__list *list, size_t k,
                                                            const paradt_index *cell) {
    const paradt_index *end = cell + k, *v, *u;
    paradt_index own = (paradt_index)w->set.count;
    int rank = w->rank;
    paradt_status status = PARADT_OK;
    for (v = cell; v < end; v++) {
        if (*v < own || w->homes[*v - own].rank == rank) continue; // own, or of the rank just served
        rank = w->homes[*v - own].rank;
        for (u = cell; u < end && !status; u++) {
            if (*u < own && w->first_sent[*u] != rank) status = paradt_mpi__list_unsent(w, list, rank, *u);
        }
    }
    return status;
}

// Lists the own vertices of what is at a place for the ranks of its other vertices, if it is a cell of own and others'
// points. With weights such cells are asked about instead, because of hidden points.
PARADT__INLINE paradt_status paradt_mpi__list_cell_vertices(paradt_mpi__work *w, paradt_mpi__list *list, size_t k,
                                                            const paradt_index *cell) {
    if (w->weighted || !paradt__is_finite_cell(cell, (int)k) ||
        paradt__vertices_among(cell, (int)k, 0, (paradt_index)w->set.count) || !paradt_mpi__may_have_unsent(w, k, cell))
        return PARADT_OK;
    return paradt_mpi__list_cell_unsent(w, list, k, cell);
}

// Prefetches what the queue's next entries need: their rows first, and later what the rows refer to.
PARADT__INLINE void paradt_mpi__fetch_ahead(const paradt_mpi__work *w, size_t k, const paradt_mpi__queue *list,
                                            size_t at) {
    enum { SOON = 4, LATER = 8 };
    const paradt__mesh *cells = paradt__known_mesh(&w->engine);
    if (at + LATER < list->count) paradt__fetch_row(cells->vertices, cells->links, list->items[at + LATER], k);
    if (at + SOON < list->count) paradt__scene_fetch_around(paradt__known_scene(&w->engine), k, list->items[at + SOON]);
}

// Lists the fringe in the engine. Of the cells and ghosts in it that have own vertices, queues those where the search
// starts and lists vertices to be sent. k: vertices a cell
PARADT__INLINE paradt_status paradt_mpi__scan_fringe(paradt_mpi__work *w, paradt_mpi__questions *q, size_t k,
                                                     paradt_mpi__queue *list) {
    const paradt__mesh *cells = paradt__known_mesh(&w->engine);
    paradt_index own = (paradt_index)w->set.count;
    paradt_status status = PARADT_OK;
    size_t at = 0;
    for (paradt__known_relist(&w->engine); !status; at++) {
        const paradt_index *cell;
        int own_count;
        status = paradt__known_list(&w->engine, own, &at);
        if (status || at == cells->count) break;
        cell = cells->vertices + at * k;
        own_count = paradt__vertices_below(cell, k, own);
        if (!own_count) continue;
        status = paradt_mpi__list_cell_vertices(w, &q->to_send, k, cell);
        if (!status && paradt__is_suspect(cell, k, own, PARADT__NOWHERE)) status = paradt_mpi__enqueue(w, list, at);
    }
    return status;
}

// Lists the questions while points are inserted: about ghosts and cells with just one own vertex, and about what is
// reached from them through exposed cells (see the head of this section). No sphere in conflict with an unknown point
// is inside the complete box; cells without own vertices do not matter and are not passed.
PARADT__INLINE paradt_status paradt_mpi__ask_from_fringe(paradt_mpi__work *w, paradt_mpi__questions *q, size_t k,
                                                         paradt_mpi__queue *list) {
    paradt_status status = paradt_mpi__scan_fringe(w, q, k, list);
    size_t at, j;
    int exposed;
    for (at = 0; at < list->count && !status && !w->too_costly; at++) {
        paradt_mpi__fetch_ahead(w, k, list, at);
        status = paradt_mpi__ask_about_place(w, q, k, list->items[at], &exposed);
        paradt_mpi__limit_questions(w, q);
        for (j = 0; j < k && exposed && !status; j++)
            status = paradt_mpi__enqueue(w, list,
                                         paradt__mesh_across(paradt__known_mesh(&w->engine), k, list->items[at], j));
    }
    return status;
}

// Calls paradt_mpi__ask_from_fringe, and takes its marks away.
static paradt_status paradt_mpi__collect_from_fringe(paradt_mpi__work *w, paradt_mpi__questions *q) {
    paradt_mpi__queue list;
    paradt_status status;
    size_t at;
    memset(&list, 0, sizeof list);
    if (w->set.space.dim == 3) status = paradt_mpi__ask_from_fringe(w, q, 4, &list);
    else status = paradt_mpi__ask_from_fringe(w, q, (size_t)w->set.space.dim + 1, &list);
    for (at = 0; at < list.count; at++) paradt__known_wait_no_more(&w->engine, list.items[at]);
    paradt__release(&w->memory, list.items);
    return status;
}

// Lists all questions about cells with own vertices and about their hull facets, and the points to be sent without a
// question. Sets w->too_costly where there are too many.
static paradt_status paradt_mpi__collect_questions(paradt_mpi__work *w, paradt_mpi__questions *q) {
    size_t count = w->has_grid ? paradt_mpi__place_count(w) : 0, k = (size_t)w->set.space.dim + 1, place;
    paradt_status status = PARADT_OK;
    int exposed;
    if (w->inserting) return paradt_mpi__collect_from_fringe(w, q);
    for (place = 0; place < count && !status; place++)
        status = paradt_mpi__list_cell_vertices(w, &q->to_send, k, w->local.cells + place * k);
    for (place = 0; place < count && !status && !w->too_costly; place++) {
        status = paradt_mpi__ask_about_place(w, q, k, place, &exposed);
        paradt_mpi__limit_questions(w, q);
    }
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>answers
//
// Step 3: questions are packed, exchanged and answered. A rank that is asked searches its own points for one in
// conflict with the cell, or beyond the facet, exactly. If there is one, or the cell has one for a vertex, the cell is
// relevant, and the rank adds those of its vertices that are the sender's own points to the known ones. With weights it
// also answers with the point that it found.
//
// Door: paradt_mpi__ask_and_answer.

// The role of a vertex on the wire, in the place of the position: p >= 0: own point p of the rank that is asked;
// PARADT_MPI__STRANGER: a point of a third rank; STRANGER - 1 - p: own point p of the rank that asks.
enum { PARADT_MPI__STRANGER = -1 };

typedef struct paradt_mpi__packets { // questions to all ranks, or from all ranks; rank 0's first
    double *points;                  // the vertices as on the wire, each once a rank, with its role
    int32_t *cells;                  // a cell: dim + 1 numbers of points among those of the rank, then the vertex
                                     // opposite the facet asked about, or -1
    size_t *point_count;             // [ranks]
    size_t *cell_count;              // [ranks]
} paradt_mpi__packets;

// Sorts the questions by rank and counts them in w->to.
static paradt_status paradt_mpi__sort_questions(paradt_mpi__work *w, paradt_mpi__questions *q) {
    paradt_mpi__question *sorted = (paradt_mpi__question *)paradt__alloc(&w->memory, q->count, sizeof *sorted);
    size_t i;
    PARADT_ASSERT(q->count <= q->capacity);
    if (!sorted) return PARADT_ERROR_MEMORY;
    memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
    for (i = 0; i < q->count; i++) w->to[q->items[i].rank]++;
    paradt_mpi__set_offsets(w);
    for (i = 0; i < q->count; i++) sorted[w->next[q->items[i].rank]++] = q->items[i];
    paradt__release(&w->memory, q->items);
    q->items = sorted;
    q->capacity = q->count;
    return PARADT_OK;
}

// Packs the questions to rank r. Returns the number of points packed.
//   q              [count] the questions to r
//   index          [known] -1 for each point, also on return; meanwhile its number among the points packed
//   points, cells  where to pack
static size_t paradt_mpi__pack_for(paradt_mpi__work *w, const paradt_mpi__question *q, size_t count, int r,
                                   int32_t *index, double *points, int32_t *cells) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), used = 0, i, j;
    paradt_index cell[PARADT_MAX_DIM + 1];
    const double *corners[PARADT_MAX_DIM + 1];
    for (i = 0; i < count; i++) {
        paradt_mpi__cell(w, k, (size_t)q[i].cell, cell, corners);
        for (j = 0; j < k; j++) {
            const paradt_mpi__home home = paradt_mpi__home_of(w, cell[j]);
            if (index[cell[j]] < 0) {
                double *wire = points + used * width;
                int64_t role = home.rank == r         ? (int64_t)home.position
                               : home.rank == w->rank ? PARADT_MPI__STRANGER - 1 - (int64_t)home.position
                                                      : (int64_t)PARADT_MPI__STRANGER;
                paradt_mpi__put_wire(w, wire, cell[j]);
                paradt_mpi__store_bits(wire + w->set.width + 1, (uint64_t)role);
                index[cell[j]] = (int32_t)used++;
            }
            *cells++ = index[cell[j]];
        }
        *cells++ = q[i].opposite;
    }
    for (i = 0; i < count; i++) {
        paradt_mpi__cell(w, k, (size_t)q[i].cell, cell, corners);
        for (j = 0; j < k; j++) index[cell[j]] = -1;
    }
    return used;
}

// Frees the packets.
static void paradt_mpi__packets_free(paradt_mpi__work *w, paradt_mpi__packets *packets) {
    paradt__release(&w->memory, packets->points);
    paradt__release(&w->memory, packets->cells);
    paradt__release(&w->memory, packets->point_count);
    paradt__release(&w->memory, packets->cell_count);
    memset(packets, 0, sizeof *packets);
}

// Packs the sorted questions into empty *packets. Not collective.
static paradt_status paradt_mpi__pack(paradt_mpi__work *w, const paradt_mpi__questions *q,
                                      paradt_mpi__packets *packets) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), ranks = (size_t)w->ranks;
    size_t i, points = 0, cells = 0, capacity = 0;
    int32_t *index;
    int r;
    for (r = 0; r < w->ranks; r++) {
        size_t most = w->to[r] * k < w->known ? w->to[r] * k : w->known;
        if (most > (size_t)INT32_MAX) return PARADT_ERROR_TOO_LARGE; // for their positions on the wire
        capacity += most;
    }
    index = (int32_t *)paradt__alloc(&w->memory, w->known, sizeof *index);
    packets->points = (double *)paradt__alloc(&w->memory, capacity, width * sizeof *packets->points);
    packets->cells = (int32_t *)paradt__alloc(&w->memory, q->count, (k + 1) * sizeof *packets->cells);
    packets->point_count = (size_t *)paradt__alloc(&w->memory, ranks, sizeof *packets->point_count);
    packets->cell_count = (size_t *)paradt__alloc(&w->memory, ranks, sizeof *packets->cell_count);
    if (index && packets->points && packets->cells && packets->point_count && packets->cell_count) {
        for (i = 0; i < w->known; i++) index[i] = -1;
        for (r = 0; r < w->ranks; r++) {
            packets->cell_count[r] = w->to[r];
            packets->point_count[r] =
                paradt_mpi__pack_for(w, q->items + cells, w->to[r], r, index, packets->points + points * width,
                                     packets->cells + cells * (k + 1));
            cells += w->to[r];
            points += packets->point_count[r];
        }
    }
    i = index && packets->points && packets->cells && packets->point_count && packets->cell_count;
    paradt__release(&w->memory, index);
    return i ? PARADT_OK : PARADT_ERROR_MEMORY;
}

// Sends the packets and replaces them by those received. Collective. status: of this rank so far
static paradt_status paradt_mpi__exchange_packets(paradt_mpi__work *w, paradt_status status,
                                                  paradt_mpi__packets *packets) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), bytes, count;
    size_t counts = (size_t)w->ranks * sizeof *w->to;
    void *points = NULL, *cells = NULL;
    bytes = width * sizeof *packets->points;
    if (!status) memcpy(w->to, packets->point_count, counts);
    status = paradt_mpi__exchange(w, status, packets->points, bytes, &points, &count);
    if (!status) {
        memcpy(w->to, packets->cell_count, counts);
        memcpy(packets->point_count, w->from, counts);
    }
    paradt__release(&w->memory, packets->points);
    packets->points = (double *)points;
    if (!status)
        status = paradt_mpi__exchange(w, status, packets->cells, (k + 1) * sizeof *packets->cells, &cells, &count);
    if (!status) memcpy(packets->cell_count, w->from, counts);
    paradt__release(&w->memory, packets->cells);
    packets->cells = (int32_t *)cells;
    return status;
}

// Is an own point in conflict with the cell, or beyond its facet, or a vertex of the cell? *found: such a point in
// conflict or beyond, or PARADT__OPEN. cell: as packed
static int paradt_mpi__is_relevant(paradt_mpi__work *w, const double *points, const int32_t *cell,
                                   paradt_index *found) {
    size_t width = paradt_mpi__wire_width(w);
    const double *corners[PARADT_MAX_DIM + 1];
    paradt_index own[PARADT_MAX_DIM + 1];
    int dim = w->set.space.dim, i, has_own = 0;
    for (i = 0; i <= dim; i++) {
        int64_t role = (int64_t)paradt_mpi__load_bits(points + (size_t)cell[i] * width + w->set.width + 1);
        corners[i] = points + (size_t)cell[i] * width;
        own[i] = role >= 0 ? (paradt_index)role : (paradt_index)PARADT__OPEN;
        has_own |= role >= 0;
    }
    *found = PARADT__OPEN;
    if (cell[dim + 1] < 0) paradt__question_cell(&w->search, corners, own);
    else paradt__question_facet(&w->search, corners, own, cell[dim + 1], 1);
    *found = paradt__question_answer(&w->search);
    return has_own || *found >= 0;
}

// Answers the questions of rank r: adds vertices of relevant cells to the known points, which have room for all of
// them, and with weights lists points to answer with. Gives up where that takes too much work. Returns how many points
// were not known.
static size_t paradt_mpi__answer_rank(paradt_mpi__work *w, int r, double *points, const int32_t *cells, size_t count,
                                      paradt_mpi__list *answers, paradt_status *status) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), i, j, added = 0;
    for (i = 0; i < count && !w->too_costly; i++, cells += k + 1) {
        paradt_index found;
        w->too_costly = paradt_mpi__is_over_budget(w);
        if (!paradt_mpi__is_relevant(w, points, cells, &found)) continue;
        if (found >= 0 && w->weighted && !*status) *status = paradt_mpi__list_add(w, answers, r, found);
        for (j = 0; j < k; j++) {
            double *wire = points + (size_t)cells[j] * width, *role = wire + w->set.width + 1;
            int64_t value = (int64_t)paradt_mpi__load_bits(role);
            if (value >= PARADT_MPI__STRANGER) continue;
            paradt_mpi__store_bits(role, (uint64_t)(PARADT_MPI__STRANGER - 1 - value));
            added += paradt_mpi__add_other(w, r, wire);
            paradt_mpi__store_bits(role, (uint64_t)(int64_t)PARADT_MPI__STRANGER);
        }
    }
    return added;
}

// Answers all questions. Not collective. *added: how many points were not known
static paradt_status paradt_mpi__answer(paradt_mpi__work *w, paradt_mpi__packets *packets, paradt_mpi__list *answers,
                                        size_t *added) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), points = 0, cells = 0;
    paradt_status status;
    int r;
    for (r = 0; r < w->ranks; r++) points += packets->point_count[r];
    status = paradt_mpi__reserve_others(w, points);
    if (!status) status = paradt_mpi__table_reserve(w, &w->lookup, points);
    points = *added = 0;
    for (r = 0; r < w->ranks && !status && w->has_grid; r++) {
        *added += paradt_mpi__answer_rank(w, r, packets->points + points * width, packets->cells + cells * (k + 1),
                                          packets->cell_count[r], answers, &status);
        points += packets->point_count[r];
        cells += packets->cell_count[r];
    }
    return status;
}

// Sends the questions and answers those that arrive. Collective; returns the agreed status.
//   status     of this rank so far
//   questions  its items are released
//   answers    set to the points to answer with; empty without weights
//   *added     set to how many points were not known
static paradt_status paradt_mpi__ask_and_answer(paradt_mpi__work *w, paradt_status status,
                                                paradt_mpi__questions *questions, paradt_mpi__list *answers,
                                                size_t *added) {
    paradt_mpi__packets packets;
    memset(&packets, 0, sizeof packets);
    if (!status) status = paradt_mpi__sort_questions(w, questions);
    if (!status) status = paradt_mpi__pack(w, questions, &packets);
    paradt__release(&w->memory, questions->items);
    status = paradt_mpi__exchange_packets(w, status, &packets);
    if (!status) status = paradt_mpi__answer(w, &packets, answers, added);
    paradt_mpi__packets_free(w, &packets);
    return paradt_mpi__agree(w, status);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>rounds
//
// Steps 2 to 4 in order: the local triangulation, one round of questions and answers, the insertion of the points that
// arrived. With weights this is repeated until no rank receives a point. Where a rank has given up, all points are sent
// to all ranks instead. A rank does all work between two exchanges without a pause for agreement, so that it waits for
// the slowest rank once a round.
//
// Door: paradt_mpi__run_rounds.

// Does one round of questions and answers. Collective. status: of this rank so far; *added: how many points of others
// became known
static paradt_status paradt_mpi__round(paradt_mpi__work *w, paradt_status status, size_t *added) {
    paradt_mpi__questions questions;
    paradt_mpi__list answers;
    size_t sent = 0, answered = 0;
    double begun = paradt__now();
    memset(&questions, 0, sizeof questions);
    memset(&answers, 0, sizeof answers);
    *added = 0;
    if (!status) status = paradt_mpi__collect_questions(w, &questions);
    w->stats.cells_asked += questions.count;
    w->stats.rounds++;
    status = paradt_mpi__agree(w, paradt_mpi__exchange_points(w, status, &questions.to_send, &sent));
    paradt__release(&w->memory, questions.to_send.items);
    paradt_mpi__set_budget(w);
    status = paradt_mpi__ask_and_answer(w, status, &questions, &answers, added);
    if (!status && w->weighted)
        status = paradt_mpi__agree(w, paradt_mpi__exchange_points(w, status, &answers, &answered));
    *added += sent + answered;
    w->stats.points_asked += *added;
    paradt__release(&w->memory, answers.items);
    w->stats.seconds_ask += paradt__now() - begun;
    return status;
}

// Sends all points to all ranks and drops the insertion so far, where any rank has given up. Collective. *added: how
// many points became known
static paradt_status paradt_mpi__send_all(paradt_mpi__work *w, size_t *added) {
    paradt_mpi__list list;
    paradt_status status = PARADT_OK;
    size_t i;
    int r;
    memset(&list, 0, sizeof list);
    for (r = 0; r < w->ranks && !status; r++) {
        if (r == w->rank || !w->directory.box_count[r]) continue;
        for (i = 0; i < w->set.count && !status; i++) status = paradt_mpi__list_add(w, &list, r, (paradt_index)i);
    }
    status = paradt_mpi__agree(w, paradt_mpi__exchange_points(w, status, &list, added));
    w->stats.points_asked += *added;
    paradt__release(&w->memory, list.items);
    if (w->inserting) paradt__known_free(&w->engine, &w->memory);
    w->inserting = 0;
    return status;
}

// Triangulates and asks until all cells with own vertices are right. Collective. The status returned is this rank's
// alone, as no agreement follows the last triangulation.
static paradt_status paradt_mpi__run_rounds(paradt_mpi__work *w) {
    uint64_t added_by_all = 1;
    size_t added;
    paradt_status status;
    PARADT_ASSERT(!w->inserting && !w->too_costly);
    paradt_mpi__begin_step(w, 0.8);
    status = paradt_mpi__triangulate_known(w);
    while (w->set.space.dim > 0 && w->ranks > 1 && added_by_all) {
        status = paradt_mpi__round(w, status, &added);
        if (status) break;
        w->too_costly = paradt_mpi__reduce_sum(w, (uint64_t)w->too_costly) > 0;
        if (w->too_costly) status = paradt_mpi__send_all(w, &added);
        if (status) break;
        added_by_all = w->weighted && !w->too_costly ? paradt_mpi__reduce_sum(w, added) : 0;
        paradt_mpi__begin_step(w, 0.7 * (w->progress_begin + w->progress_length) + 0.3 * 0.95); // how many more come?
        if (added || w->too_costly) status = paradt_mpi__triangulate_known(w);
    }
    if (!status && w->inserting && (w->ranks == 1 || w->too_costly)) // else the questions have listed the fringe
        status = paradt__known_list_all(&w->engine, (paradt_index)w->set.count);
    if (!status && w->inserting) paradt__known_rest(&w->engine, &w->memory);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>result
//
// From the last local triangulation to the result. The own cells are kept and numbered through all ranks; a cell is
// owned by the rank of the highest number that has a vertex of it. A facet that no own cell is behind is open: it is
// sent, with the ids of its vertices, to the home rank of one of them, chosen by hash, so that both ranks choose alike.
// There it meets the facet of the cell on the other side; a facet that meets none is on the hull. Representatives that
// are not the point itself are sent to the rank that handed the point in.
//
// Arrays of the local triangulation, and of the records, become arrays of the result without a copy where they can.
//
// Doors: paradt_mpi__deliver, paradt_mpi__own_links.

typedef struct paradt_mpi__facets { // the open facets
    size_t count;
    size_t width;    // words a row: the ids of the facet's vertices in ascending order, and what its neighbour needs:
                     // the number of its cell, or of its half-facet
    uint64_t *rows;  // [count][width], in the order of the ranks they are sent to
    size_t *handles; // [count] indices in out->neighbors; in the order of the rows once there are rows
    size_t capacity; // of handles
    int *homes;      // [vertex_count - vertex_own] home ranks of the vertices that are others' points
} paradt_mpi__facets;

// Lists an open facet. Returns 0 when there is no memory.
static int paradt_mpi__facet_add(paradt_mpi__work *w, paradt_mpi__facets *f, size_t handle) {
    void *items = paradt_mpi__reserve_one(w, f->handles, f->count, &f->capacity, sizeof *f->handles);
    if (!items) return 0;
    f->handles = (size_t *)items;
    f->handles[f->count++] = handle;
    return 1;
}

// Does this rank own the cell? Replicated cells are owned, as there are no others. mark: see paradt__remote_owns
PARADT__INLINE int paradt_mpi__is_own(const paradt_mpi__work *w, size_t k, const paradt_index *cell,
                                      const paradt_index *mark) {
    paradt_index own = (paradt_index)w->set.count;
    if (PARADT__LIKELY(paradt__vertices_among(cell, (int)k, 0, own))) return 1;
    return w->options.flags & PARADT_MPI_REPLICATED || paradt__remote_owns(cell, k, own, mark);
}

// Drops the cells that other ranks own and fills the gaps with cells from the end, so that nearly all cells keep their
// places. Returns how many are left. mark: [known] PARADT__OF_LATER_RANK or nothing for each point; bits are added that
// say what the cells make of it (see >>known points)
PARADT__INLINE size_t paradt_mpi__compact_own(const paradt_mpi__work *w, const paradt__mesh *mesh, size_t k,
                                              paradt_index *mark) {
    size_t end = mesh->count, c;
    for (c = 0; c < end; c++) {
        const paradt_index *cell = mesh->vertices + c * k;
        paradt__fetch_row(mesh->vertices, mesh->links, c + PARADT__ROWS_AHEAD, k);
        while (!PARADT__LIKELY(paradt_mpi__is_own(w, k, cell, mark))) {
            paradt__mark_vertices(mark, cell, k, PARADT__VERTEX);
            paradt__mesh_drop(mesh, c, k, PARADT__OPEN);
            if (--end == c) return end;
            paradt__mesh_move(mesh, c, end, k, 0);
        }
        paradt__mark_vertices(mark, cell, k, PARADT__VERTEX | PARADT__OF_OWN_CELL);
    }
    return end;
}

// Returns the local cells as a mesh.
static paradt__mesh paradt_mpi__local_mesh(const paradt_mpi__work *w, size_t count) {
    paradt__mesh mesh;
    paradt__mesh_begin(&mesh, w->out->dim + 1, 0);
    mesh.count = count;
    mesh.vertices = w->local.cells;
    mesh.links = w->local.neighbors;
    return mesh;
}

// Keeps the own cells alone, in w->local, and ends the insertion. mark: [known] set to what the cells make of each
// point (see >>known points). Not collective.
static void paradt_mpi__keep_own_cells(paradt_mpi__work *w, paradt_index *mark) {
    size_t k = (size_t)w->out->dim + 1, made = w->local.cell_count, own = w->set.count, i;
    paradt__mesh cells;
    for (i = own; i < w->known; i++)
        mark[i] = w->homes[i - own].rank > w->rank ? PARADT__OF_LATER_RANK : PARADT__NO_VERTEX;
    if (!w->inserting) {
        for (i = 0; i < own; i++) mark[i] = PARADT__NO_VERTEX;
        cells = paradt_mpi__local_mesh(w, made);
        w->local.cell_count =
            k == 4 ? paradt_mpi__compact_own(w, &cells, 4, mark) : paradt_mpi__compact_own(w, &cells, k, mark);
        w->stats.cells_recomputed += made - w->local.cell_count;
        return;
    }
    PARADT_ASSERT(!w->local_bytes && !w->local.cells);
    w->inserting = 0;
    w->stats.cells_recomputed += paradt__known_end(&w->engine, &w->set, &w->memory, &cells, mark);
    w->local.dim = w->set.space.dim;
    w->local.cell_count = cells.count;
    w->local.cells = cells.vertices;
    w->local.neighbors = cells.links;
}

// Numbers the own cells through all ranks. Collective.
static void paradt_mpi__number_cells(paradt_mpi__work *w) {
    uint64_t mine = w->out->cell_count, before = 0;
    MPI_Exscan(&mine, &before, 1, MPI_UINT64_T, MPI_SUM, w->comm);
    w->out->first_cell = w->rank ? before : 0;
    w->out->cell_total = paradt_mpi__reduce_sum(w, mine);
}

// Lists the open facets of an own cell. A facet on the hull of the local triangulation is open too, unless the hull is
// known to be that of all points.
PARADT__NOINLINE paradt_status paradt_mpi__list_open_facets(paradt_mpi__work *w, size_t k, size_t c,
                                                            paradt_mpi__facets *f) {
    paradt_index *neighbors = w->out->neighbors;
    int final = (w->options.flags & PARADT_MPI_REPLICATED) != 0; // the local hull is that of all points
    size_t j;
    PARADT_ASSERT(k > 1);
    for (j = c * k; j < (c + 1) * k; j++) {
        if (neighbors[j] == PARADT__HULL && !final) neighbors[j] = PARADT__OPEN;
        w->stats.hull_facets += neighbors[j] == PARADT__HULL;
        if (neighbors[j] == PARADT__OPEN && !paradt_mpi__facet_add(w, f, j)) return PARADT_ERROR_MEMORY;
    }
    return PARADT_OK;
}

// Replaces positions by vertices in all own cells, and handles by cell numbers unless half-facets are wanted; lists the
// open facets.
//   own     the cells; passed by value, so that the compiler knows that writing to rows does not change it
//   number  [known] the vertex of each position
PARADT__INLINE paradt_status paradt_mpi__number_rows(paradt_mpi__work *w, const paradt__mesh own, size_t k,
                                                     const paradt_index *number, paradt_mpi__facets *f) {
    const paradt__rows in_place = paradt__mesh_rows((int)k, w->out->facets, own.vertices, own.links, 0);
    paradt_status status = PARADT_OK;
    size_t c;
    for (c = 0; c < own.count && !own.links; c++) own.vertices[c] = number[own.vertices[c]]; // a vertex without facets
    for (c = 0; c < own.count && own.links && !status; c++) {
        int open = paradt__mesh_emit_row(&own, c, k, number, &in_place);
        if (!PARADT__LIKELY(!open) && w->out->neighbors) status = paradt_mpi__list_open_facets(w, k, c, f);
    }
    return status;
}

// Makes the own cells those of the result and lists the open facets. Not collective. number: [known] the vertex of each
// position
static paradt_status paradt_mpi__take_cells(paradt_mpi__work *w, const paradt_index *number, paradt_mpi__facets *f) {
    size_t k = (size_t)w->out->dim + 1;
    paradt__mesh own = paradt_mpi__local_mesh(w, w->out->cell_count);
    w->out->cells = w->local.cells;
    w->local.cells = NULL;
    if (!(w->options.local.flags & PARADT_NO_NEIGHBORS)) {
        w->out->neighbors = w->local.neighbors;
        w->local.neighbors = NULL;
    }
    return k == 4 ? paradt_mpi__number_rows(w, own, 4, number, f) : paradt_mpi__number_rows(w, own, k, number, f);
}

// Writes the row of an open facet. Returns the rank that it is sent to: the home of the vertex whose id has the
// smallest hash.
PARADT__INLINE int paradt_mpi__facet_row(const paradt_mpi__work *w, size_t k, const paradt_mpi__facets *f,
                                         size_t handle, uint64_t *row) {
    size_t base = handle / k * k, own = w->out->vertex_own, chosen = 0, i, j, count = 0;
    uint64_t least = UINT64_MAX;
    for (i = 0; i < k; i++) {
        size_t vertex = (size_t)w->out->cells[base + i];
        uint64_t id = (uint64_t)w->out->vertices[vertex], h = paradt__mix(id);
        if (base + i == handle) continue;
        for (j = count++; j > 0 && row[j - 1] > id; j--) row[j] = row[j - 1];
        row[j] = id;
        if (h <= least) least = h, chosen = vertex;
    }
    row[count] = w->out->facets ? w->out->first_cell * k + handle : w->out->first_cell + handle / k;
    return chosen < own ? w->rank : f->homes[chosen - own];
}

// Writes the rows of all open facets, and the ranks that they are sent to. They are in the order of their cells, which
// lie far apart, so these are prefetched.
PARADT__INLINE void paradt_mpi__facet_rows(const paradt_mpi__work *w, size_t k, const paradt_mpi__facets *f,
                                           uint64_t *rows, int *rank) {
    enum { AHEAD = 16 };
    size_t i;
    for (i = 0; i < f->count; i++) {
        if (i + AHEAD < f->count) PARADT__PREFETCH(w->out->cells + f->handles[i + AHEAD]);
        rank[i] = paradt_mpi__facet_row(w, k, f, f->handles[i], rows + i * k);
    }
}

// Sets the rows of the open facets, sorts rows and handles by the rank that they are sent to, and fills w->to. Not
// collective.
static paradt_status paradt_mpi__sort_facets(paradt_mpi__work *w, paradt_mpi__facets *f) {
    size_t width = (size_t)w->out->dim + 1, i;
    size_t *handles = (size_t *)paradt__alloc(&w->memory, f->count, sizeof *handles);
    uint64_t *rows = (uint64_t *)paradt__alloc(&w->memory, f->count, width * sizeof *rows);
    int *rank = (int *)paradt__alloc(&w->memory, f->count, sizeof *rank);
    paradt_status status = PARADT_ERROR_MEMORY;
    f->width = width;
    f->rows = (uint64_t *)paradt__alloc(&w->memory, f->count, width * sizeof *f->rows);
    if (handles && rows && rank && f->rows) {
        size_t *unsorted = f->handles;
        memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
        if (width == 4) paradt_mpi__facet_rows(w, 4, f, rows, rank);
        else paradt_mpi__facet_rows(w, width, f, rows, rank);
        for (i = 0; i < f->count; i++) w->to[rank[i]]++;
        paradt_mpi__set_offsets(w);
        for (i = 0; i < f->count; i++) {
            size_t at = w->next[rank[i]]++;
            handles[at] = unsorted[i];
            memcpy(f->rows + at * width, rows + i * width, width * sizeof *rows);
        }
        f->handles = handles;
        handles = unsorted;
        status = PARADT_OK;
    }
    paradt__release(&w->memory, handles);
    paradt__release(&w->memory, rows);
    paradt__release(&w->memory, rank);
    paradt__release(&w->memory, f->homes);
    f->homes = NULL;
    return status;
}

// Matches the facets that were sent to this rank. rows: [count][width]; across: [count] set to the number of the cell
// or half-facet on the other side of each, or to PARADT__HULL
static paradt_status paradt_mpi__match_facets(paradt_mpi__work *w, const uint64_t *rows, size_t count, size_t width,
                                              int64_t *across) {
    size_t slots = 16, i, bytes = (width - 1) * sizeof *rows, *table;
    while (slots < count * 2) slots *= 2;
    table = (size_t *)paradt__alloc(&w->memory, slots, sizeof *table);
    if (!table) return PARADT_ERROR_MEMORY;
    memset(table, 0xff, slots * sizeof *table);
    for (i = 0; i < count; i++) {
        const uint64_t *row = rows + i * width;
        uint64_t h = 0;
        size_t slot, j;
        for (j = 0; j + 1 < width; j++) h = paradt__mix(h ^ row[j]) + row[j];
        across[i] = PARADT__HULL;
        for (slot = (size_t)paradt__mix(h) & (slots - 1); table[slot] != SIZE_MAX; slot = (slot + 1) & (slots - 1)) {
            const uint64_t *other = rows + table[slot] * width;
            if (memcmp(other, row, bytes)) continue;
            across[i] = (int64_t)other[width - 1];
            across[table[slot]] = (int64_t)row[width - 1];
            break;
        }
        if (across[i] < 0) table[slot] = i;
    }
    paradt__release(&w->memory, table);
    return PARADT_OK;
}

// Returns how many neighbours are this rank's: cells, or half-facets. Larger neighbours refer to out->others.
static size_t paradt_mpi__own_links(const paradt_mpi_triangulation *t) {
    return t->facets ? t->cell_count * (size_t)(t->dim + 1) : t->cell_count;
}

// Sets the neighbours across the open facets. answers: [f->count] the numbers of the cells or half-facets across, or
// PARADT__HULL; the array becomes out->others. Not collective.
static void paradt_mpi__set_others(paradt_mpi__work *w, int64_t *answers, const paradt_mpi__facets *f) {
    paradt_mpi_triangulation *out = w->out;
    size_t own = paradt_mpi__own_links(out), i;
    out->others = answers;
    for (i = 0; i < f->count; i++) {
        paradt_index *neighbor = &out->neighbors[f->handles[i]];
        PARADT_ASSERT(*neighbor == PARADT__OPEN);
        PARADT_ASSERT(answers[i] < (int64_t)(out->facets ? out->cell_total * f->width : out->cell_total));
        if (answers[i] == PARADT__HULL) {
            *neighbor = PARADT__HULL;
            w->stats.hull_facets++;
        } else {
            *neighbor = (paradt_index)(own + out->other_count);
            out->others[out->other_count++] = answers[i];
        }
    }
}

// Finds the neighbours across the open facets. Collective; returns the agreed status.
static paradt_status paradt_mpi__link_cells(paradt_mpi__work *w, paradt_mpi__facets *f) {
    void *rows = NULL, *answers = NULL;
    int64_t *across = NULL;
    size_t count = 0, back;
    paradt_status status = PARADT_OK;
    if (f->count > (size_t)PARADT__NOWHERE - paradt_mpi__own_links(w->out)) status = PARADT_ERROR_TOO_LARGE;
    if (!status) status = paradt_mpi__sort_facets(w, f);
    status = paradt_mpi__exchange(w, status, f->rows, f->width * sizeof *f->rows, &rows, &count);
    if (!status) {
        across = (int64_t *)paradt__alloc(&w->memory, count, sizeof *across);
        status =
            across ? paradt_mpi__match_facets(w, (const uint64_t *)rows, count, f->width, across) : PARADT_ERROR_MEMORY;
        memcpy(w->to, w->from, (size_t)w->ranks * sizeof *w->to); // the answers go back where the rows came from
        status = paradt_mpi__exchange(w, status, across, sizeof *across, &answers, &back);
    }
    if (!status) paradt_mpi__set_others(w, (int64_t *)answers, f);
    else paradt__release(&w->memory, answers);
    paradt__release(&w->memory, across);
    paradt__release(&w->memory, rows);
    return status;
}

// Sets out->coordinates to an array for `count` vertices: that of the records if it is hardly larger. Not collective.
static paradt_status paradt_mpi__take_coordinates(paradt_mpi__work *w, size_t count) {
    size_t ambient = (size_t)w->dim;
    if (w->set.records && w->capacity * w->set.width <= count * ambient + count) {
        w->out->coordinates = w->set.records;
        w->set.records = NULL;
    } else {
        w->out->coordinates = (double *)paradt__alloc(&w->memory, count, ambient * sizeof(double));
    }
    return w->out->coordinates ? PARADT_OK : PARADT_ERROR_MEMORY;
}

// Makes the table of vertices, in the order of positions, and notes where others' points are at home. Not collective.
// number: [known] the mark of each position; replaced by its vertex, or PARADT__OPEN
static paradt_status paradt_mpi__list_vertices(paradt_mpi__work *w, paradt_index *number, paradt_mpi__facets *f) {
    paradt_mpi_triangulation *out = w->out;
    const double *records = w->set.records;
    size_t i, count = 0, ambient = (size_t)w->dim;
    int axis, exact = 1;
    paradt_status status;
    for (i = 0; i < w->known; i++) {
        int used = (number[i] & (PARADT__OF_OWN_CELL | PARADT__OF_NONE_DROPPED)) != 0;
        number[i] = used ? (paradt_index)count++ : (paradt_index)PARADT__OPEN;
        if (i + 1 == w->set.count) out->vertex_own = count;
    }
    PARADT_ASSERT(out->vertex_own <= count);
    out->vertex_count = count;
    out->vertices = (int64_t *)paradt__alloc_filled(&w->memory, count, sizeof *out->vertices);
    f->homes = (int *)paradt__alloc(&w->memory, count - out->vertex_own, sizeof *f->homes);
    status = out->vertices && f->homes ? paradt_mpi__take_coordinates(w, count) : PARADT_ERROR_MEMORY;
    for (i = 0; i < w->known && !status; i++) {
        double *to, x[PARADT_MAX_DIM];
        paradt_mpi__home home;
        if (i + PARADT__POINTS_AHEAD < w->set.count) // received numbers are not in the order of positions
            PARADT__FETCH(w->received, w->set.origin[i + PARADT__POINTS_AHEAD]);
        if (number[i] < 0) continue;
        to = out->coordinates + (size_t)number[i] * ambient;
        home = paradt_mpi__home_of(w, (paradt_index)i);
        out->vertices[number[i]] = (int64_t)home.id;
        if (i >= w->set.count) f->homes[(size_t)number[i] - out->vertex_own] = home.rank;
        memcpy(x, records + i * w->set.width, ambient * sizeof *x);
        for (axis = 0; axis < w->dim; axis++)
            to[w->set.axes[axis]] = w->shift ? paradt__scale(x[axis], -w->shift, &exact) : x[axis];
    }
    return status;
}

// Returns the rank that handed in a point.
static int paradt_mpi__handed_in_by(const paradt_mpi__work *w, uint64_t id) {
    int low = 0, high = w->ranks;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (w->first[middle] <= id) low = middle;
        else high = middle;
    }
    return low;
}

// Lists the points of this rank's box that do not represent themselves: rows of two ids, the point's and its
// representative's (-1: hidden), in the order of the ranks that handed them in; fills w->to. A point of this rank's box
// is a vertex of T(P) if it is one of the last local triangulation. Not collective.
//   mark   [known] what the cells make of each point
//   used   [received_count] overwritten
//   *rows  set to a new array
static paradt_status paradt_mpi__list_exceptions(paradt_mpi__work *w, const paradt_index *mark, uint8_t *used,
                                                 int64_t **rows) {
    size_t i, count = 0, pass;
    memset(used, 0, w->received_count);
    for (i = 0; i < w->set.count; i++) used[w->set.origin[i]] = mark[i] != PARADT__NO_VERTEX;
    memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
    for (pass = 0; pass < 2; pass++) {
        for (i = 0; i < w->received_count; i++) { // ids ascend, and so do the ranks
            size_t representative = (size_t)w->representative[i];
            if (representative == i && used[representative]) continue;
            if (pass) {
                (*rows)[2 * count] = (int64_t)w->received[i];
                (*rows)[2 * count + 1] = used[representative] ? (int64_t)w->received[representative] : -1;
            } else {
                w->to[paradt_mpi__handed_in_by(w, w->received[i])]++;
                w->stats.hidden += representative == i;
            }
            count++;
        }
        if (pass) break;
        *rows = (int64_t *)paradt__alloc(&w->memory, count, 2 * sizeof **rows);
        if (!*rows) return PARADT_ERROR_MEMORY;
        count = 0;
    }
    return PARADT_OK;
}

// As paradt_mpi__list_exceptions, with memory for `used`.
static paradt_status paradt_mpi__exceptions(paradt_mpi__work *w, const paradt_index *mark, int64_t **rows) {
    uint8_t *used = (uint8_t *)paradt__alloc(&w->memory, w->received_count, 1);
    paradt_status status = used ? paradt_mpi__list_exceptions(w, mark, used, rows) : PARADT_ERROR_MEMORY;
    paradt__release(&w->memory, used);
    return status;
}

// Sends the representatives to the ranks that handed the points in, and sets those received. Collective. rows: see
// paradt_mpi__list_exceptions
static paradt_status paradt_mpi__send_representatives(paradt_mpi__work *w, const int64_t *rows) {
    void *got = NULL;
    size_t count = 0, i;
    paradt_status status = paradt_mpi__exchange(w, PARADT_OK, rows, 2 * sizeof *rows, &got, &count);
    for (i = 0; i < count && !status; i++) {
        const int64_t *row = (const int64_t *)got + 2 * i;
        PARADT_ASSERT((uint64_t)row[0] - w->out->first_point < w->out->point_count);
        w->out->representative[(uint64_t)row[0] - w->out->first_point] = row[1];
    }
    paradt__release(&w->memory, got);
    return status;
}

// Makes what a rank can make alone: own cells and vertices, points that represent themselves. Lists what is to be sent:
// the open facets and the rows of representatives. Not collective.
static paradt_status paradt_mpi__take_result(paradt_mpi__work *w, paradt_mpi__facets *facets, int64_t **rows) {
    paradt_mpi_triangulation *out = w->out;
    paradt_index *number = (paradt_index *)paradt__alloc_filled(&w->memory, w->known, sizeof *number);
    paradt_status status = PARADT_ERROR_MEMORY;
    size_t i;
    out->representative = (int64_t *)paradt__alloc_filled(&w->memory, out->point_count, sizeof *out->representative);
    if (number && out->representative) {
        paradt_mpi__keep_own_cells(w, number);
        out->cell_count = w->local.cell_count;
        for (i = 0; i < out->point_count; i++) out->representative[i] = (int64_t)(out->first_point + i);
        status = paradt_mpi__exceptions(w, number, rows);
    }
    if (!status) status = paradt_mpi__list_vertices(w, number, facets);
    if (!status) status = paradt_mpi__take_cells(w, number, facets);
    paradt__release(&w->memory, number);
    return status;
}

// Makes the result from the last local triangulation. Collective; returns the agreed status. status: of this rank so
// far
static paradt_status paradt_mpi__deliver(paradt_mpi__work *w, paradt_status status) {
    paradt_mpi__facets facets;
    int64_t *rows = NULL;
    int wanted = !(w->options.local.flags & PARADT_NO_NEIGHBORS);
    double begun = paradt__now();
    memset(&facets, 0, sizeof facets);
    paradt_mpi__free_question_data(w);
    paradt_mpi__begin_step(w, 1.0);
    if (!status) status = paradt_mpi__check_cancel(w, 0.0);
    if (!status) status = paradt_mpi__take_result(w, &facets, &rows);
    if (!status) status = paradt_mpi__check_cancel(w, 0.5);
    status = paradt_mpi__agree(w, status);
    if (!status) {
        paradt_mpi__number_cells(w);
        status = paradt_mpi__send_representatives(w, rows);
    }
    if (!status && wanted && w->out->dim > 0) status = paradt_mpi__link_cells(w, &facets);
    PARADT_ASSERT(status || w->out->first_cell + w->out->cell_count <= w->out->cell_total);
    PARADT_ASSERT(status || w->out->vertex_own <= w->out->vertex_count);
    paradt__release(&w->memory, facets.rows);
    paradt__release(&w->memory, facets.homes);
    paradt__release(&w->memory, facets.handles);
    paradt__release(&w->memory, rows);
    w->stats.seconds_finish = paradt__now() - begun;
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>replicated
//
// PARADT_MPI_REPLICATED: every rank has all points and builds its region of them, as the regions of paradt.h are built;
// only errors, the numbers of cells and their links need communication. That is ParaInCoDe of the thesis. All points
// are others' points here (set.count is 0), with homes chosen by hash: every rank knows each, and homes only decide
// where open facets meet.
//
// Door: paradt_mpi__replicated.

#ifndef PARADT_NO_FRONTS

// Returns ARGUMENT on all ranks unless the points are the same on all. Collective.
static paradt_status paradt_mpi__compare_points(paradt_mpi__work *w, const double *rows) {
    size_t width = (size_t)w->dim + (size_t)w->weighted + 1, i;
    uint64_t h = 0, first;
    for (i = 0; i < w->out->point_count; i++)
        h = paradt__mix(h ^ paradt__hash_coordinates(rows + i * width, (int)width - 1));
    first = h;
    MPI_Bcast(&first, 1, MPI_UINT64_T, 0, w->comm);
    if (h == first) return paradt_mpi__agree(w, PARADT_OK);
    return paradt_mpi__agree(w, paradt_mpi__refuse(w, PARADT_ERROR_ARGUMENT,
                                                   "the points are not those of rank 0, but are to be replicated"));
}

// Sets used[i], [count], where point i is a vertex of any rank's cells. Collective.
static void paradt_mpi__unite_used(paradt_mpi__work *w, uint8_t *used, size_t count) {
    size_t i;
    for (i = 0; i < w->out->vertex_count; i++) used[w->out->vertices[i]] = 1;
    for (i = 0; i < count; i += (size_t)1 << 30) {
        size_t part = count - i < (size_t)1 << 30 ? count - i : (size_t)1 << 30;
        MPI_Allreduce(MPI_IN_PLACE, used + i, (int)part, MPI_UINT8_T, MPI_MAX, w->comm);
    }
}

// Builds this rank's region. rows: all points; becomes set.records. Not collective.
static paradt_status paradt_mpi__build_region(paradt_mpi__work *w, double *rows) {
    size_t count = w->out->point_count, width = (size_t)w->dim + (size_t)w->weighted + 1, i;
    paradt_options options;
    paradt_points points;
    double *weights = NULL;
    paradt_status status;
    double begun = paradt__now();
    int axis;
    w->set.records = rows;
    w->set.width = width;
    w->set.count = w->known = w->capacity = count;
    for (axis = 0; axis < w->dim; axis++) w->set.axes[axis] = axis;
    w->homes = (paradt_mpi__home *)paradt__alloc(&w->memory, count, sizeof *w->homes);
    if (!w->homes) return PARADT_ERROR_MEMORY;
    paradt_mpi__begin_step(w, 0.9);
    status = paradt_mpi__check_cancel(w, 0.0);
    if (status) return status;
    if (w->weighted) {
        weights = (double *)paradt__alloc(&w->memory, count, sizeof *weights);
        if (!weights) return PARADT_ERROR_MEMORY;
    }
    for (i = 0; i < count; i++) {
        w->homes[i].id = i;
        w->homes[i].rank = (int)((paradt__mix(i) >> 32) * (uint64_t)w->ranks >> 32);
        if (weights) weights[i] = rows[i * width + (size_t)w->dim];
    }
    memset(&points, 0, sizeof points);
    points.data = rows;
    points.count = count;
    points.dim = w->dim;
    points.stride = width * sizeof *rows;
    points.weights = weights;
    options = paradt_mpi__local_options(w);
    options.regions = (size_t)w->ranks;
    options.parallel_for = NULL;
    options.flags |= w->options.local.flags & PARADT_FULL_DIM;
    status = paradt__triangulate_region(&w->local, &points, &options, (size_t)w->rank);
    if (status) w->error_text = w->local.error_text;
    paradt_mpi__account_local(w);
    paradt__release(&w->memory, weights);
    w->stats.triangulations = 1;
    if (w->rank == 0) w->stats.points = count - (size_t)w->local.stats.duplicates;
    w->stats.cells_recomputed = w->local.stats.cells_recomputed;
    w->stats.seconds_build = paradt__now() - begun;
    return status;
}

// Sets the representatives. All ranks know them, except which points are hidden. Collective.
static paradt_status paradt_mpi__represent_replicated(paradt_mpi__work *w) {
    size_t count = w->out->point_count, i;
    uint8_t *used = (uint8_t *)paradt__alloc(&w->memory, count, 1);
    paradt_status status = paradt_mpi__agree(w, used ? PARADT_OK : PARADT_ERROR_MEMORY);
    if (!status) {
        memset(used, !w->weighted, count);
        if (w->weighted) paradt_mpi__unite_used(w, used, count);
        for (i = 0; i < count; i++) {
            size_t representative = (size_t)w->local.representative[i];
            w->out->representative[i] = used[representative] ? (int64_t)representative : -1;
            if (w->rank) continue;
            w->stats.hidden += representative == i && !used[i];
            w->stats.duplicates += representative != i;
        }
    }
    paradt__release(&w->memory, used);
    return status;
}

// Triangulates replicated points. rows: all points; taken over. Collective.
static paradt_status paradt_mpi__replicated(paradt_mpi__work *w, double *rows) {
    paradt_status status = paradt_mpi__compare_points(w, rows);
    PARADT_ASSERT(w->options.flags & PARADT_MPI_REPLICATED);
    if (status) {
        paradt__release(&w->memory, rows);
        return status;
    }
    status = paradt_mpi__agree(w, paradt_mpi__build_region(w, rows));
    if (status) return status;
    w->out->dim = w->local.dim;
    w->out->point_total = w->out->point_count;
    w->set.count = 0; // no own points: paradt_mpi__deliver sends no representatives
    status = paradt_mpi__deliver(w, PARADT_OK);
    return status ? status : paradt_mpi__represent_replicated(w);
}

#endif // PARADT_NO_FRONTS

// ---------------------------------------------------------------------------------------------------------------------
// >>triangulate
//
// The course of a call, and the public functions that need no more. Every rank takes part in every step, even without
// points or with wrong arguments, as the others wait for it.
//
// Doors: paradt_mpi__end, paradt_mpi_neighbor.

PARADT_DEF void paradt_mpi_free(paradt_mpi_triangulation *t) {
    paradt__memory memory;
    paradt_options options;
    if (!t) return;
    memset(&options, 0, sizeof options);
    options.allocator = t->allocator;
    paradt__memory_begin(&memory, &options);
    paradt__release(&memory, t->cells);
    paradt__release(&memory, t->neighbors);
    paradt__release(&memory, t->others);
    paradt__release(&memory, t->vertices);
    paradt__release(&memory, t->coordinates);
    paradt__release(&memory, t->representative);
    memset(t, 0, sizeof *t);
    t->dim = -1;
}

// Frees all that a call holds except the result. Collective.
static void paradt_mpi__end(paradt_mpi__work *w) {
    if (w->inserting) paradt__known_free(&w->engine, &w->memory);
    w->inserting = 0;
    paradt_mpi__free_local(w);
    paradt_mpi__free_points(w);
    paradt_mpi__directory_free(w);
    paradt__release(&w->memory, w->first);
    paradt__release(&w->memory, w->from);
    paradt__release(&w->memory, w->next);
    paradt__release(&w->memory, w->to);
    MPI_Comm_free(&w->comm);
}

// Triangulates distributed points. rows: those that this rank handed in; released. Collective.
static paradt_status paradt_mpi__distributed(paradt_mpi__work *w, double *rows) {
    paradt_status status;
    double begun;
    paradt_mpi__begin_step(w, 0.15);
    status = paradt_mpi__distribute_points(w, rows);
    begun = paradt__now();
    if (!status && w->out->dim > 0) status = paradt_mpi__exchange_boxes(w);
    if (!status && w->out->dim > 0 && w->ranks > 1) status = paradt_mpi__guess(w);
    w->stats.seconds_grid += paradt__now() - begun;
    return status ? status : paradt_mpi__deliver(w, paradt_mpi__run_rounds(w));
}

// Sets the statistics of the result: own, sum and maximum. Collective, also after an error.
static void paradt_mpi__reduce_stats(paradt_mpi__work *w) {
    enum { FIELDS = 24 };
    uint64_t counts[FIELDS], count_sum[FIELDS], count_most[FIELDS];
    double times[FIELDS], time_sum[FIELDS], time_most[FIELDS];
    paradt_mpi_triangulation *out = w->out;
    int c = 0, t = 0;
    out->stats = w->stats;
#define PARADT_MPI__TAKE_COUNT(name, about) counts[c++] = w->stats.name;
#define PARADT_MPI__TAKE_TIME(name, about)  times[t++] = w->stats.name;
    PARADT_MPI_COUNTERS(PARADT_MPI__TAKE_COUNT)
    PARADT_MPI_TIMERS(PARADT_MPI__TAKE_TIME)
    PARADT_ASSERT(c <= FIELDS && t <= FIELDS);
    MPI_Allreduce(counts, count_sum, c, MPI_UINT64_T, MPI_SUM, w->comm);
    MPI_Allreduce(counts, count_most, c, MPI_UINT64_T, MPI_MAX, w->comm);
    MPI_Allreduce(times, time_sum, t, MPI_DOUBLE, MPI_SUM, w->comm);
    MPI_Allreduce(times, time_most, t, MPI_DOUBLE, MPI_MAX, w->comm);
    c = t = 0;
#define PARADT_MPI__GIVE_COUNT(name, about) out->sum.name = count_sum[c], out->largest.name = count_most[c++];
#define PARADT_MPI__GIVE_TIME(name, about)  out->sum.name = time_sum[t], out->largest.name = time_most[t++];
    PARADT_MPI_COUNTERS(PARADT_MPI__GIVE_COUNT)
    PARADT_MPI_TIMERS(PARADT_MPI__GIVE_TIME)
}

// Triangulates: checks and reads the points, then does what the flags say. Collective. status: of this rank so far
static paradt_status paradt_mpi__run(paradt_mpi__work *w, const paradt_points *local, paradt_status status) {
    double *rows = NULL, begun = paradt__now();
    status = paradt_mpi__check_arguments(w, local, status);
    if (status) return status;
    w->to = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->to);
    w->from = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->from);
    w->next = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->next);
    w->first = (uint64_t *)paradt__alloc(&w->memory, (size_t)w->ranks + 1, sizeof *w->first);
    status = paradt_mpi__agree(w, w->to && w->from && w->next && w->first ? PARADT_OK : PARADT_ERROR_MEMORY);
    if (status) return status;
    paradt_mpi__number_points(w, local->count);
    w->out->ambient = w->dim;
    w->out->facets = (w->options.local.flags & PARADT_FACETS) != 0;
    w->out->point_count = local->count;
    w->out->point_total = w->first[w->ranks];
    w->out->first_point = w->options.flags & PARADT_MPI_REPLICATED ? 0 : w->first[w->rank];
    paradt_mpi__begin_step(w, 0.05);
    status = paradt_mpi__agree(w, paradt_mpi__read_points(w, local, &rows));
    if (status) {
        paradt__release(&w->memory, rows);
        return status;
    }
    w->stats.seconds_partition = paradt__now() - begun;
#ifndef PARADT_NO_FRONTS
    if (w->options.flags & PARADT_MPI_REPLICATED) return paradt_mpi__replicated(w, rows);
#endif
    return paradt_mpi__distributed(w, rows);
}

// After an error: leaves nothing in `out` but what says which.
static void paradt_mpi__withdraw(paradt_mpi_triangulation *out) {
    paradt_mpi_triangulation error = *out;
    paradt_mpi_free(out);
    out->error_rank = error.error_rank;
    out->error_point = error.error_point;
    memcpy(out->error_text, error.error_text, sizeof out->error_text);
}

PARADT_DEF paradt_status paradt_mpi_triangulate(paradt_mpi_triangulation *out, MPI_Comm comm,
                                                const paradt_points *local, const paradt_mpi_options *options) {
    paradt_mpi__work w;
    paradt_mpi_triangulation nowhere; // of a rank without `out`
    paradt_status status = PARADT_OK;
    double begun = paradt__now();
    memset(&w, 0, sizeof w);
    if (options) w.options = *options;
    if (!out) {
        out = &nowhere;
        status = paradt_mpi__refuse(&w, PARADT_ERROR_ARGUMENT, "out is NULL");
    }
    memset(out, 0, sizeof *out);
    out->dim = -1;
    w.out = out;
    paradt__memory_begin(&w.memory, &w.options.local);
    MPI_Comm_dup(comm, &w.comm);
    MPI_Comm_rank(w.comm, &w.rank);
    MPI_Comm_size(w.comm, &w.ranks);
    status = paradt_mpi__run(&w, local, status);
    if (!status) status = paradt_mpi__agree(&w, paradt_mpi__check_cancel(&w, 1.0));
    out->allocator = w.memory.allocator;
    if (status) paradt_mpi__withdraw(out);
    w.stats.cells = out->cell_count;
    w.stats.peak_bytes = w.memory.peak;
    if (status == PARADT_ERROR_MEMORY) w.stats.needed_bytes = w.memory.needed;
    w.stats.seconds = paradt__now() - begun;
    paradt_mpi__reduce_stats(&w);
    paradt_mpi__end(&w);
    return status;
}

PARADT_DEF uint64_t paradt_mpi_hash(const paradt_mpi_triangulation *t, MPI_Comm comm) {
    uint64_t sum = 0, vertices[PARADT_MAX_DIM + 1];
    size_t k = (size_t)t->dim + 1, i, j;
    for (i = 0; i < t->cell_count; i++) {
        for (j = 0; j < k; j++) vertices[j] = (uint64_t)t->vertices[t->cells[i * k + j]];
        sum += paradt_hash_cell(vertices, (int)k);
    }
    MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, comm);
    return sum;
}

PARADT_DEF int64_t paradt_mpi_neighbor(const paradt_mpi_triangulation *t, size_t facet) {
    size_t own = paradt_mpi__own_links(t), link;
    uint64_t first = t->facets ? t->first_cell * ((uint64_t)t->dim + 1) : t->first_cell;
    PARADT_ASSERT(facet < t->cell_count * ((size_t)t->dim + 1));
    if (t->neighbors[facet] < 0) return PARADT__HULL;
    link = (size_t)t->neighbors[facet];
    PARADT_ASSERT(link < own + t->other_count);
    return link < own ? (int64_t)(first + link) : t->others[link - own];
}

// ---------------------------------------------------------------------------------------------------------------------
// >>gather
//
// paradt_mpi_gather: all ranks send their cells, neighbours and representatives to the root, which joins them in the
// order of ranks: cells are numbered through all ranks in that order, and so are points as handed in. No other section
// uses this one.

// Sends `count` elements of `size` bytes to the root. Collective. *all: on the root those of all ranks, in the order of
// ranks, else none; the caller releases it. *total: their number
static paradt_status paradt_mpi__gather_at(paradt_mpi__work *w, paradt_status status, int root, const void *part,
                                           size_t count, size_t size, void **all, size_t *total) {
    if (!status) {
        memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
        w->to[root] = count;
    }
    return paradt_mpi__exchange(w, status, part, size, all, total);
}

// Makes copies of the own cells with ids for vertices, *ids, and of their neighbours with numbers of all ranks' cells
// or half-facets, *numbers, NULL if there are none. Both fit into an index, as was checked. Not collective.
static paradt_status paradt_mpi__name_cells(paradt_mpi__work *w, const paradt_mpi_triangulation *t, paradt_index **ids,
                                            paradt_index **numbers) {
    size_t values = t->cell_count * (size_t)(t->dim + 1), i;
    *ids = (paradt_index *)paradt__alloc(&w->memory, values, sizeof **ids);
    *numbers = t->neighbors ? (paradt_index *)paradt__alloc(&w->memory, values, sizeof **numbers) : NULL;
    if (!*ids || (t->neighbors && !*numbers)) return PARADT_ERROR_MEMORY;
    for (i = 0; i < values; i++) {
        (*ids)[i] = (paradt_index)t->vertices[t->cells[i]];
        if (*numbers) (*numbers)[i] = (paradt_index)paradt_mpi_neighbor(t, i);
    }
    return PARADT_OK;
}

// Copies 64-bit numbers to a new array of indices, into which they fit.
static paradt_status paradt_mpi__to_indices(paradt_mpi__work *w, const void *from, size_t count, paradt_index **to) {
    size_t i;
    *to = (paradt_index *)paradt__alloc(&w->memory, count, sizeof **to);
    if (!*to) return PARADT_ERROR_MEMORY;
    for (i = 0; i < count; i++) (*to)[i] = (paradt_index)((const int64_t *)from)[i];
    return PARADT_OK;
}

// Gathers the cells in *out on the root. Collective; returns the agreed status.
static paradt_status paradt_mpi__gather(paradt_mpi__work *w, paradt_triangulation *out,
                                        const paradt_mpi_triangulation *t, int root) {
    size_t k = t->dim < 0 ? 1 : (size_t)t->dim + 1, values = t->cell_count * k, cells = 0, neighbors = 0, points = 0,
           handed;
    void *all_cells = NULL, *all_neighbors = NULL, *all_points = NULL;
    paradt_index *ids = NULL, *numbers = NULL;
    const uint64_t most = (uint64_t)PARADT__NOWHERE;
    // Replicated, the ranks together handed in more points than there are, and the root's are enough.
    const uint64_t handed_in = paradt_mpi__reduce_sum(w, t->point_count);
    paradt_status status = t->cell_total > most / k || t->point_total > most ? PARADT_ERROR_TOO_LARGE : PARADT_OK;
    w->to = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->to);
    w->from = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->from);
    if (!status) status = w->to && w->from ? paradt_mpi__name_cells(w, t, &ids, &numbers) : PARADT_ERROR_MEMORY;
    handed = handed_in > t->point_total && w->rank != root ? 0 : t->point_count;
    status = paradt_mpi__agree(w, status);
    if (!status) status = paradt_mpi__gather_at(w, status, root, ids, values, sizeof *ids, &all_cells, &cells);
    if (!status)
        status = paradt_mpi__gather_at(w, status, root, numbers, numbers ? values : 0, sizeof *numbers, &all_neighbors,
                                       &neighbors);
    if (!status)
        status = paradt_mpi__gather_at(w, status, root, t->representative, handed, sizeof *t->representative,
                                       &all_points, &points);
    if (!status && w->rank == root) {
        out->dim = t->dim;
        out->cell_count = cells / k;
        out->point_count = points;
        out->cells = (paradt_index *)all_cells;
        all_cells = NULL;
        if (neighbors) {
            out->neighbors = (paradt_index *)all_neighbors;
            all_neighbors = NULL;
        }
        status = paradt_mpi__to_indices(w, all_points, points, &out->representative);
        out->stats.cells = t->sum.cells;
        out->stats.duplicates = t->sum.duplicates;
        out->stats.hidden = t->sum.hidden;
        out->stats.hull_facets = t->sum.hull_facets;
    }
    status = paradt_mpi__agree(w, status);
    paradt__release(&w->memory, all_cells);
    paradt__release(&w->memory, all_neighbors);
    paradt__release(&w->memory, all_points);
    paradt__release(&w->memory, numbers);
    paradt__release(&w->memory, ids);
    return status;
}

PARADT_DEF paradt_status paradt_mpi_gather(paradt_triangulation *out, MPI_Comm comm, const paradt_mpi_triangulation *t,
                                           int root) {
    paradt_mpi__work w;
    paradt_mpi_triangulation errors; // paradt_mpi__agree notes the error here
    paradt_triangulation nowhere;
    paradt_status status = PARADT_OK;
    if (!out) out = &nowhere;
    memset(out, 0, sizeof *out);
    out->dim = -1;
    memset(&w, 0, sizeof w);
    memset(&errors, 0, sizeof errors);
    w.out = &errors;
    if (t) w.options.local.allocator = t->allocator;
    paradt__memory_begin(&w.memory, &w.options.local);
    MPI_Comm_dup(comm, &w.comm);
    MPI_Comm_rank(w.comm, &w.rank);
    MPI_Comm_size(w.comm, &w.ranks);
    if (!t) status = paradt_mpi__refuse(&w, PARADT_ERROR_ARGUMENT, "triangulation is NULL");
    else if (out == &nowhere) status = paradt_mpi__refuse(&w, PARADT_ERROR_ARGUMENT, "out is NULL");
    else if (root < 0 || root >= w.ranks) status = paradt_mpi__refuse(&w, PARADT_ERROR_ARGUMENT, "root is no rank");
    status = paradt_mpi__agree(&w, status);
    if (!status) status = paradt_mpi__gather(&w, out, t, root);
    out->allocator = w.memory.allocator;
    if (status) {
        paradt_free(out);
        out->error_text = w.error_text ? w.error_text : paradt_status_string(status);
    }
    paradt_mpi__end(&w);
    return status;
}

#ifdef __cplusplus
}
#endif

#endif // PARADT_MPI__IMPLEMENTED
#endif // PARADT_MPI_IMPLEMENTATION

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
