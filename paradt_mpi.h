// paradt_mpi.h - v0.1.0 - exact Delaunay and regular triangulations on many machines - public domain or MIT-0
//
// paradt.h spread over the ranks of an MPI communicator. Each rank hands in some of the points and gets some of the
// cells: together those of paradt_triangulate, each once, whatever the number of ranks and whoever had which point.
//
// DO THIS in one C or C++ file of the program; it brings the implementation of paradt.h with it, so that no other file
// defines PARADT_IMPLEMENTATION:
//
//     #define PARADT_MPI_IMPLEMENTATION
//     #include "paradt_mpi.h"
//
// A whole program. Every rank makes a thousand points, and all of them together are triangulated:
//
//     #define PARADT_MPI_IMPLEMENTATION
//     #include "paradt_mpi.h"
//     #include <stdio.h>
//
//     int main(int argc, char **argv) {
//         static double x[1000][3];
//         paradt_points points = paradt_points_f64(x, 1000, 3);
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
// It needs MPI 3 and what paradt.h needs. PARADT_STATIC, PARADT_INDEX64 and the other macros of paradt.h hold here too;
// PARADT_DEF stands before each public function.
//
// CONTENTS
//
//     points, result, how it is divided, why the cells are right, replicated points, errors, MPI, memory, cost, limits,
//     changes; the declarations; the implementation in sections marked "// >>name"; the licence
//
//
// POINTS
//
// A rank hands in any share of the points, as to paradt_triangulate: all of them, some, or none. Each point is handed
// in by one rank. Global ids number them through, from 0: those of rank 0 in their order, then those of rank 1, and so
// on. `dim` must be the same on all ranks, also on one without points; the type of the coordinates and the stride may
// differ. Weights are for all points or for none; where a rank has no points, they do not matter.
//
//
// RESULT
//
// The cells of a rank are `cells`, with k = t.dim + 1 vertices each. These are positions in a table of vertices, which
// has their global ids and coordinates:
//
//     t.cells[i * k + j]        vertex j of cell i, a position in the table
//     t.vertices[v]             its global id
//     t.coordinates[v * t.ambient + a]
//     t.neighbors[i * k + j]    the cell opposite that vertex: a position too, see below, or -1 on the hull
//     t.first_cell + i          the number of cell i
//     t.representative[p]       of the points that this rank handed in: the global id of the vertex that stands for it
//
// Numbers of cells run through all ranks: rank r has those from first_cell to first_cell + cell_count - 1. A neighbour
// n < cell_count is that cell of this rank; from there on it is another rank's, whose number is
// t.others[n - cell_count]. So values by cell, of the own cells and behind them of the others, can be read at a
// neighbour's position; and
//
//     paradt_mpi_neighbor(&t, i * k + j)
//
// is the number of the cell opposite vertex j of cell i, whoever has it. Which rank a cell belongs to depends on the
// number of ranks; the union does not. The rules for duplicates, hidden points, lower dimensions and orientation are
// those of paradt.h, with global ids in the place of indices.
//
// Statistics come three times: of this rank, summed over all, and the largest of all. Those of all are the same on
// every rank.
//
//
// HOW IT IS DIVIDED
//
// Space is cut into as many boxes as there are ranks: a box is halved across the longest side of its points, so that
// each side gets its share of the points, until one rank is left for each (recursive coordinate bisection), or its
// share of space (PARADT_UNIFORM). A rank's share is larger where its box has sides beyond which there is nothing. The
// cut is found by counting, in parts that are divided again, so that no rank has all points at any time. A point on a
// cut belongs to the upper side. Each rank gets the points of its box, its own points, and triangulates a few of them:
// where that makes expect that a rank has more than 1.25 times the mean work, as with a lattice here and points in
// general position there, or the same point often, points weigh what they take, at least a quarter of the mean, and
// space is cut anew. Then each rank:
//
//     1. sends to others those of its points that are near to theirs, and all that are within some margin of their
//        boxes: a guess that saves work; so each knows a room around its box in which it has all points;
//     2. triangulates its own points and those it got. Where a cell has points of several ranks for vertices, it sends
//        the own ones to the others. Then it looks at the cells that have an own vertex, from the hull and from others'
//        points inwards as far as need be: where a point that it does not have may lie in the cell's sphere, or beyond
//        its facet on the hull, it sends the rank that may have it the cell;
//     3. answers for itself: has it a point in conflict with a cell that it got, by the exact test? Then it adds those
//        of the cell's vertices that are the sender's own points;
//     4. inserts what came in steps 2 and 3, if there was anything (by a method other than insertion, or in regions of
//        its own, it triangulates again), and keeps the cells with vertices of its own and none of a rank with a higher
//        number.
//
//
// WHY THE CELLS ARE RIGHT
//
// Let O(r) be the points of rank r, S(r) those it has in step 2, and T(X) the triangulation of X. Claim: after step 3
// every rank s has all points p that are joined to one of its own points q by an edge in T(P). Let p belong to rank r.
// The edge p q is one in the triangulation of any subset of P that holds p and q, so of S(r) and q. If q is in S(r), a
// cell around p in T(S(r)) has q for a vertex, and p was sent to s. If not, the cells around p change when q comes, so
// that q is in conflict with one of them; the cells beyond the hull count, which have points strictly outside of a
// facet in conflict. That cell was sent to s, unless s had all its vertices of O(r) already, for floating point only
// ever decides that a point can't be in a sphere, and r has all points of its room; and s kept p. So in step 4 the
// cells of T(P) around a point q of O(s) have all their vertices on rank s. No point is in conflict with them, so they
// are cells of its triangulation, and as they fill the space around q there are no others. Nothing depends on how much
// step 1 sent, and there is nothing to repeat.
//
// With weights a point may be hidden by others that it has no edge to. Then cells with vertices of other ranks are sent
// as well, steps 2 to 4 are repeated, and a rank answers a cell with a point that is in conflict with it, until no cell
// around an own vertex is in conflict with anything.
//
// Points that are nearly on a sphere or in two parallel planes have spheres that reach all boxes and are empty. So the
// ranks tell each other more than one box: up to 64 of them, around parts of their points; and near a sphere they
// measure the points from there, as paradt.h does.
//
// There are sets of which the boxes of all ranks share nearly every cell, or whose spheres no box can tell from each
// other: points exactly on a sphere, almost on a line, on a cylinder or a helix. Where a rank finds that its questions
// or answers would take longer than building all of T(P), all points are sent to all ranks, and each builds the whole
// and keeps its own cells: only then a rank has more than its own points and a seam.
//
//
// REPLICATED POINTS
//
// With PARADT_MPI_REPLICATED every rank hands in all points, the same on each. They are not sent anywhere: each rank
// makes the cells of its box by InCoDe (by DeWall if that is the method; any other is taken for InCoDe), as the regions
// of paradt.h do, and they talk only to agree on errors and to number and link the cells. That is the thesis'
// ParaInCoDe. Global ids are the indices, and representative is filled on all ranks alike.
//
//
// ERRORS
//
// All ranks return the same status, that of the first rank that failed; error_rank says which, and error_point the
// index of the point there (PARADT_ERROR_NOT_FINITE). The statuses are those of paradt.h, and also
//
//     PARADT_ERROR_ARGUMENT    ranks that differ in dim, in having weights, in options.flags, in the flags or the
//                              partition of options.local; replicated points that are not the same
//     PARADT_ERROR_CANCELLED   a rank's progress callback returned nonzero
//
// They are agreed on at the end of each step, so a rank that fails waits for the others to get there.
//
//
// MPI
//
// The communicator is duplicated at the beginning and the duplicate freed at the end, so that no message meets one of
// yours. Its error handler is that of your communicator; where that lets MPI calls return, what follows a failed one is
// undefined. Calls from several threads at once need MPI_THREAD_MULTIPLE and a communicator each. The header neither
// starts nor ends MPI, prints nothing and aborts nothing. Messages are cut into pieces of PARADT_MPI_PIECE bytes, so
// that none has too many for an int. All ranks have the same byte order. Their compilers, flags and processors may
// differ, but with PARADT_MPI_REPLICATED not the results of floating-point arithmetic: there each cuts space by itself.
//
// options.local is for what a rank does alone, which is a paradt_triangulate: method, regions and parallel_for (threads
// within a rank), progress, memory_limit, allocator. It may differ between ranks but for the partition and the flags.
// PARADT_AUTO inserts in four dimensions, too, where there are several ranks.
//
//
// MEMORY
//
// All memory but that of MPI itself comes from the rank's options.local.allocator, within its memory_limit. At no time
// has a rank more than its share of the points (up to five times as many where its points weigh little; more where many
// are equal or have a coordinate in common), those it handed in, and those near its border, unless all points are sent
// to all ranks (see above): then each has the memory and the limits of a call of its own for all of them.
//
//
// COST
//
// A rank triangulates its n / p points and those near its border, once by insertion, twice by other methods or where
// options.local has regions; all points once more where all are sent. Beside that, points are sent once, to their
// ranks, or twice where they weigh what they take; the cuts take O(n / p log p) time and about 8 log2 p reductions each
// time; each cell is looked at once more; and what is sent in steps 1 and 2 is proportional to the number of points
// near the border, for points spread without structure. The rounds do not grow with the number of ranks.
// stats.seconds_* tell where the time goes.
//
//
// LIMITS
//
//     a rank    the limits of paradt.h, for its own points and those near its border; for all where all are sent
//     points    2^63 - 1 in all
//     ranks     as MPI; each keeps 65 boxes of every other one
//
//
// CHANGES
//
//     0.1.0  the first version
//

#ifndef PARADT_MPI_H
#define PARADT_MPI_H

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
enum { PARADT_MPI_REPLICATED = 1 }; // every rank hands in all points

typedef struct paradt_mpi_options {
    paradt_options local; // what each rank does alone (see MPI); flags and partition: for all of it
    unsigned flags;       // 0; PARADT_MPI_REPLICATED
} paradt_mpi_options;

// Fields of paradt_mpi_stats: name, what it counts. Times are wall time, and the sum and maximum of times are too.
#define PARADT_MPI_COUNTERS(X)                                                                                         \
    X(points, "own points, without duplicates; replicated, rank 0 counts them")                                        \
    X(points_guessed, "points got from others by the guess")                                                           \
    X(points_asked, "points got from others because of an edge or a conflict")                                         \
    X(cells, "cells that this rank owns")                                                                              \
    X(cells_recomputed, "cells made last that are not the rank's own: the duplication")                                \
    X(cells_asked, "cells sent to others in question")                                                                 \
    X(rounds, "times that cells were sent in question")                                                                \
    X(triangulations, "times that this rank triangulated")                                                             \
    X(duplicates, "points at the place of another")                                                                    \
    X(hidden, "places of weighted points that are no vertex")                                                          \
    X(hull_facets, "facets with a cell on one side only; 0 with PARADT_NO_NEIGHBORS")                                  \
    X(bytes_sent, "to other ranks, in messages that cut space, of steps 1 to 4, and that link cells")                  \
    X(messages_sent, "their number")                                                                                   \
    X(peak_bytes, "most memory held at once")
#define PARADT_MPI_TIMERS(X)                                                                                           \
    X(seconds_partition, "reading, cutting, sending the points")                                                       \
    X(seconds_grid, "sorting them, the samples, the boxes, the guess")                                                 \
    X(seconds_build, "triangulating")                                                                                  \
    X(seconds_ask, "asking, answering, and the wait for the slowest")                                                  \
    X(seconds_finish, "numbering and linking cells, representatives")                                                  \
    X(seconds, "all of it")

#define PARADT_MPI__COUNTER(name, about) uint64_t name;
#define PARADT_MPI__TIMER(name, about)   double name;
typedef struct paradt_mpi_stats {
    PARADT_MPI_COUNTERS(PARADT_MPI__COUNTER)
    PARADT_MPI_TIMERS(PARADT_MPI__TIMER)
} paradt_mpi_stats;

typedef struct paradt_mpi_triangulation {
    int dim;                  // affine dimension of all points: dim + 1 vertices a cell; -1: no points
    int ambient;              // coordinates a point
    uint64_t cell_total;      // cells of all ranks
    uint64_t first_cell;      // number of this rank's first cell
    size_t cell_count;        // cells of this rank
    paradt_index *cells;      // [cell_count][dim + 1] positions in `vertices`, positively oriented
    paradt_index *neighbors;  // [cell_count][dim + 1] cell opposite each vertex, cell_count + i: others[i]; or NULL
    size_t other_count;       // facets across which another rank's cell lies
    int64_t *others;          // [other_count] the number of that cell
    size_t vertex_count;      // vertices of this rank's cells
    size_t vertex_own;        // so many of them, the first, lie in this rank's box; replicated: 0
    int64_t *vertices;        // [vertex_count] global ids
    double *coordinates;      // [vertex_count][ambient]
    uint64_t point_total;     // points of all ranks, as handed in
    uint64_t first_point;     // global id of this rank's first point
    size_t point_count;       // points of this rank, as handed in
    int64_t *representative;  // [point_count] global id of the point itself, or of what stands for it; -1: hidden
    paradt_mpi_stats stats;   // of this rank
    paradt_mpi_stats sum;     // over all ranks
    paradt_mpi_stats largest; // of all ranks
    int error_rank;           // after an error: the first rank that had it
    size_t error_point;       // PARADT_ERROR_NOT_FINITE: index of the first such point of that rank; else 0
    paradt_allocator allocator;
} paradt_mpi_triangulation;

// Computes the triangulation of the points of all ranks. Collective over comm.
//   out      is overwritten, whatever it held. After an error it is empty but for error_rank and error_point.
//   local    this rank's points, read during the call only; see POINTS.
//   options  NULL: the defaults. flags, local.flags and local.partition are the same on all ranks.
// Errors: ARGUMENT, NOT_FINITE, MEMORY, TOO_LARGE, CANCELLED, the same on all ranks. Thread safety: as MPI allows, with
// a communicator and an `out` for each call.
PARADT_DEF paradt_status paradt_mpi_triangulate(paradt_mpi_triangulation *out, MPI_Comm comm,
                                                const paradt_points *local, const paradt_mpi_options *options);

// Gives this rank's arrays back to the allocator they came from, and makes the triangulation all zero. NULL and all
// zero are fine. Not collective. Thread safety: as free.
PARADT_DEF void paradt_mpi_free(paradt_mpi_triangulation *triangulation);

// The number, through all ranks, of the cell behind the facet of cell facet / (dim + 1) opposite its vertex
// facet % (dim + 1), or -1 on the hull; for a triangulation with neighbours. Not collective. Thread safety: any number
// of calls at once.
PARADT_DEF int64_t paradt_mpi_neighbor(const paradt_mpi_triangulation *triangulation, size_t facet);

// The hash of the cells of all ranks, by their global ids: that of paradt_hash for the same points in the order of
// their ids. Collective over comm; the same on all ranks.
PARADT_DEF uint64_t paradt_mpi_hash(const paradt_mpi_triangulation *triangulation, MPI_Comm comm);

// Puts the cells together on the rank `root`, as paradt_triangulate would return them for all points there, but for the
// statistics. On the other ranks *out is empty. Collective over comm, that of paradt_mpi_triangulate; root is the same
// on all ranks. Memory comes from the allocator of the triangulation. Errors, the same on all ranks: ARGUMENT, MEMORY,
// TOO_LARGE (more points or cells than paradt.h's limits allow).
PARADT_DEF paradt_status paradt_mpi_gather(paradt_triangulation *out, MPI_Comm comm,
                                           const paradt_mpi_triangulation *triangulation, int root);

#ifdef __cplusplus
}
#endif

#endif // PARADT_MPI_H

// The implementation follows; stop here if you only use the API. Its sections are marked "// >>name", and each uses
// only what stands above it, and of paradt.h the doors of >>remote, >>memory, >>bits, >>points and >>grid, and of
// >>bowyer-watson the orders of insertion and what fetches and numbers the rows of cells.

#ifdef PARADT_MPI_IMPLEMENTATION
#ifndef PARADT_MPI__IMPLEMENTED
#define PARADT_MPI__IMPLEMENTED

#ifndef PARADT__REMOTE
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
// >>talk
//
// What one call works with, agreement on errors, and the one way in which ranks send each other anything of variable
// size. Functions that call MPI are collective, and so are those that call one of them. What is decided in integers
// from the results of reductions is decided alike on all ranks; what takes floating point, rank 0 decides for all.
// Doors: paradt_mpi__agree, paradt_mpi__exchange, paradt_mpi__begin_sorting, paradt_mpi__smallest, paradt_mpi__sum; the
// tables and lists; paradt_mpi__local_options, paradt_mpi__add_peak, paradt_mpi__go_on.

typedef struct paradt_mpi__home { // where a point that a rank knows is at home
    uint64_t id;
    int rank;
    paradt_index place; // among the own points of that rank
} paradt_mpi__home;

typedef struct paradt_mpi__slot { // of a hash table of points of other ranks; rank < 0: free
    int rank;
    paradt_index place;
    paradt_index value;
} paradt_mpi__slot;

typedef struct paradt_mpi__table {
    paradt_mpi__slot *slots;
    size_t size, count; // size is a power of two, or 0
} paradt_mpi__table;

typedef struct paradt_mpi__neighbor {
    int rank;
    unsigned beyond; // the sides of this rank's box that all points of that one are beyond: bits, as the bounds' places
} paradt_mpi__neighbor;

typedef struct paradt_mpi__directory {   // boxes around all points of all ranks, in groups of eight as in >>grid
    double *groups;                      // [ranks][PARADT_MPI__GROUPS][width]
    int *count;                          // [ranks] boxes of each
    double *ranks;                       // [ranks / 8, rounded up][width] one box a rank
    double *rooms;                       // [ranks][2 dim + 1] low and high of each axis, and how far beyond them each
                                         // rank wants to know all points
    size_t width;                        // doubles a group
    paradt_mpi__neighbor *nearby;        // [nearby_count] other ranks that have points in the vicinity
    int nearby_count;                    //
    int *listeners;                      // [ranks] those who may have to be asked about a cell
    double own[2 * PARADT_MAX_DIM];      // around this rank's points: low and high of each axis
    double vicinity[2 * PARADT_MAX_DIM]; // some way around that
} paradt_mpi__directory;

typedef struct paradt_mpi__places { // to be looked at, in this order; marked
    size_t *items;                  // [capacity] those that were looked at stay
    size_t count, capacity;
} paradt_mpi__places;

typedef struct paradt_mpi__question { // a cell, or a facet on the hull of it, that a rank is to be asked about
    int rank;
    int opposite;      // vertex opposite the facet; -1: the cell
    paradt_index cell; // its place
} paradt_mpi__question;

typedef struct paradt_mpi__list { // own points to be sent: `place` to `rank`
    size_t count, capacity;
    paradt_mpi__slot *items; // value: not used
} paradt_mpi__list;

enum {
    PARADT_MPI__GROUPS = 8, // of boxes a rank tells the others
    PARADT_MPI__PART_BITS = 8,
    PARADT_MPI__PARTS = 1 << PARADT_MPI__PART_BITS // into which space is divided where it is to be cut
};

typedef struct paradt_mpi__work {
    MPI_Comm comm;
    int rank, ranks;
    paradt__memory memory;
    paradt_mpi_options options;
    paradt_mpi_triangulation *out;
    paradt_mpi_stats stats;
    size_t error_point;
    paradt_status failed;              // what all ranks have agreed on
    size_t *to, *from;                 // [ranks] elements of an exchange
    size_t *next;                      // [ranks] where the next element for a rank goes
    uint64_t *first;                   // [ranks + 1] first global id of each rank's points
    int dim, weighted;                 // of the points as handed in
    int shift;                         // the coordinates were multiplied by 2^shift
    paradt__set set;                   // own points along a curve; behind them in records those of others
    paradt__grid grid;                 // of the own points
    int64_t low[PARADT_MAX_DIM];       // around the own points, as ordered bits
    int64_t high[PARADT_MAX_DIM];      //
    double inside[2 * PARADT_MAX_DIM]; // low and high of each axis: no point in there is unknown to this rank
    paradt__search search;             // in the grid
    int ready;                         // the grid is there: there are points here, not all equal, and other ranks
    uint64_t patience;                 // so much work questions are worth: about the number of all ranks' cells
    int stuck;                         // questions or answers would take longer
    size_t known, room;                // points in set.records, and places for them
    paradt_mpi__home *home;            // [room - set.count] of others' points
    paradt_mpi__table others;          // points of others that are known: value is the place in set.records
    int *audience;                     // [set.count] the first rank that was told of each own point, or -1
    paradt_mpi__table told;            // other ranks, and the own points that they were told
    paradt_index *twin;                // [received] of each point received the one that stands for it
    uint64_t *received;                // [received] their ids
    size_t received_count;             //
    double below[PARADT_MAX_DIM], above[PARADT_MAX_DIM]; // this rank's box, on the caller's axes; -FAR, FAR: unbounded
    paradt_mpi__directory directory;
    paradt__remote_engine engine; // insertion, while it goes on
    int inserting;                // it does
    int handles;                  // it did, so that neighbours of the local cells are places * (dim + 1) + facet
    paradt_triangulation local;   // of the points known when it was made
    size_t local_bytes;           // that it holds, if it was made by a call with an account of its own
    double progress_begin, progress_length;
    paradt__meter meter;     // of the insertion on this rank,
    uint32_t meter_told;     // all of which is one share
} paradt_mpi__work;

// The status of the first rank that has one, on all.
static paradt_status paradt_mpi__agree(paradt_mpi__work *w, paradt_status status) {
    int mine = status ? w->rank : INT_MAX, first;
    int64_t told[2];
    if (w->failed) return w->failed;
    MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, w->comm);
    if (first == INT_MAX) return PARADT_OK;
    told[0] = status;
    told[1] = (int64_t)w->error_point;
    MPI_Bcast(told, 2, MPI_INT64_T, first, w->comm);
    w->out->error_rank = first;
    w->out->error_point = (size_t)told[1];
    w->failed = (paradt_status)told[0];
    return w->failed;
}

static void paradt_mpi__smallest(paradt_mpi__work *w, int64_t *facts, int count) {
    MPI_Allreduce(MPI_IN_PLACE, facts, count, MPI_INT64_T, MPI_MIN, w->comm);
}

static uint64_t paradt_mpi__sum(paradt_mpi__work *w, uint64_t x) {
    MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_UINT64_T, MPI_SUM, w->comm);
    return x;
}

static size_t paradt_mpi__pieces(size_t bytes) {
    return bytes / PARADT_MPI_PIECE + (bytes % PARADT_MPI_PIECE != 0);
}

// Starts to send or receive what goes between this rank and `other`, in pieces. They do not overtake each other.
static MPI_Request *paradt_mpi__start(paradt_mpi__work *w, char *data, size_t bytes, int other, int sends,
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
            next = paradt_mpi__start(w, receive + in, got, r, 0, next);
            next = paradt_mpi__start(w, (char *)(uintptr_t)(send + out), sent, r, 1, next);
        }
        out += sent;
        in += got;
    }
    while (next > requests) MPI_Wait(--next, MPI_STATUS_IGNORE);
}

// Sends w->to[r] elements of `size` bytes to each rank r, those for rank 0 first, and gets w->from[r] from each, in
// *receive, which is to be released. *receive: NULL, or a block with room for *count elements, which is taken unless
// that is too little, or twice too much. *count: how many came. status: of this rank so far; nothing is sent if one has
// failed.
static paradt_status paradt_mpi__exchange_into(paradt_mpi__work *w, paradt_status status, const void *send, size_t size,
                                               void **receive, size_t *count) {
    MPI_Request *requests = NULL;
    size_t pieces = 0, total = 0;
    int r;
    for (r = 0; r < w->ranks && status; r++) w->to[r] = 0;
    MPI_Alltoall(w->to, (int)sizeof *w->to, MPI_BYTE, w->from, (int)sizeof *w->from, MPI_BYTE, w->comm);
    for (r = 0; r < w->ranks; r++) {
        total += w->from[r];
        if (r != w->rank) pieces += paradt_mpi__pieces(w->to[r] * size) + paradt_mpi__pieces(w->from[r] * size);
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

static paradt_status paradt_mpi__exchange(paradt_mpi__work *w, paradt_status status, const void *send, size_t size,
                                          void **receive, size_t *count) {
    *receive = NULL;
    return paradt_mpi__exchange_into(w, status, send, size, receive, count);
}

// Elements are sorted by rank, those for rank 0 first: w->next becomes where those for each rank begin, by w->to.
static void paradt_mpi__begin_sorting(paradt_mpi__work *w) {
    size_t next = 0;
    int r;
    for (r = 0; r < w->ranks; r++) {
        w->next[r] = next;
        next += w->to[r];
    }
}

static int paradt_mpi__progress(void *user, double fraction) {
    paradt_mpi__work *w = (paradt_mpi__work *)user;
    return w->options.local.progress(w->options.local.user, w->progress_begin + fraction * w->progress_length);
}

// A paradt_parallel_for takes the same user pointer as the progress callback; so this one hands on the caller's.
static void paradt_mpi__parallel_for(void *user, size_t count, void (*task)(void *context, size_t index),
                                     void *context) {
    paradt_mpi__work *w = (paradt_mpi__work *)user;
    w->options.local.parallel_for(w->options.local.user, count, task, context);
}

// Asks for the caller's wish between steps: the engines ask only now and then. Not collective.
static paradt_status paradt_mpi__go_on(paradt_mpi__work *w, double fraction) {
    return w->options.local.progress && paradt_mpi__progress(w, fraction) ? PARADT_ERROR_CANCELLED : PARADT_OK;
}

// The options of a triangulation on this rank alone.
static paradt_options paradt_mpi__local_options(paradt_mpi__work *w) {
    paradt_options options = w->options.local;
    if (options.progress) options.progress = paradt_mpi__progress;
    if (options.parallel_for) options.parallel_for = paradt_mpi__parallel_for;
    options.user = w;
    options.flags = 0; // hull facets are known by their neighbours
    if (options.memory_limit) {
        uint64_t left = w->memory.limit > w->memory.held ? w->memory.limit - w->memory.held : 0;
        options.memory_limit = left ? (size_t)left : 1;
    }
    return options;
}

// A triangulation that is made alone has an account of its own, whose peak is added to the rank's.
static void paradt_mpi__add_peak(paradt_mpi__work *w, const paradt_triangulation *t) {
    uint64_t peak = w->memory.held + t->stats.peak_bytes;
    if (peak > w->memory.peak) w->memory.peak = peak;
}

// Room for one more item in a list: returns the items, or NULL when there is no memory.
static void *paradt_mpi__one_more(paradt_mpi__work *w, void *items, size_t count, size_t *capacity, size_t size) {
    size_t larger = *capacity * 2 + 64;
    if (count < *capacity) return items;
    if (!paradt__grow(&w->memory, &items, count, larger, size)) return NULL;
    *capacity = larger;
    return items;
}

// Adds an item to a list of own points to be sent.
static paradt_status paradt_mpi__list_add(paradt_mpi__work *w, paradt_mpi__list *list, int rank, paradt_index place) {
    void *items = paradt_mpi__one_more(w, list->items, list->count, &list->capacity, sizeof *list->items);
    if (!items) return PARADT_ERROR_MEMORY;
    list->items = (paradt_mpi__slot *)items;
    list->items[list->count].rank = rank;
    list->items[list->count++].place = place;
    return PARADT_OK;
}

// The slot of a point, or a free one. The table has room.
static paradt_mpi__slot *paradt_mpi__find(const paradt_mpi__table *table, int rank, paradt_index place) {
    size_t i = (size_t)paradt__mix((uint64_t)rank << 40 ^ (uint64_t)place) & (table->size - 1);
    for (;; i = (i + 1) & (table->size - 1)) {
        paradt_mpi__slot *slot = table->slots + i;
        if (slot->rank < 0 || (slot->rank == rank && slot->place == place)) return slot;
    }
}

// Makes room for `more` points: at most half of the slots are taken.
static paradt_status paradt_mpi__table_room(paradt_mpi__work *w, paradt_mpi__table *table, size_t more) {
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
        if (slot->rank >= 0) *paradt_mpi__find(&larger, slot->rank, slot->place) = *slot;
    }
    paradt__release(&w->memory, table->slots);
    *table = larger;
    return PARADT_OK;
}

// Is the point in the table? If not, it is now.
static int paradt_mpi__table_put(paradt_mpi__table *table, int rank, paradt_index place, paradt_index value) {
    paradt_mpi__slot *slot = paradt_mpi__find(table, rank, place);
    if (slot->rank >= 0) return 1;
    slot->rank = rank;
    slot->place = place;
    slot->value = value;
    table->count++;
    return 0;
}

// Was the rank told of the own point?
static int paradt_mpi__knows(const paradt_mpi__work *w, int rank, paradt_index place) {
    int first = w->audience[place];
    return first == rank || (first >= 0 && w->told.size && paradt_mpi__find(&w->told, rank, place)->rank >= 0);
}

// Lists a point for a rank unless it was told of it already.
static paradt_status paradt_mpi__list_news(paradt_mpi__work *w, paradt_mpi__list *list, int rank, paradt_index place) {
    paradt_status status;
    if (w->audience[place] == rank) return PARADT_OK;
    if (w->audience[place] < 0) {
        w->audience[place] = rank;
        return paradt_mpi__list_add(w, list, rank, place);
    }
    status = paradt_mpi__table_room(w, &w->told, 1);
    if (!status && !paradt_mpi__table_put(&w->told, rank, place, 0))
        status = paradt_mpi__list_add(w, list, rank, place);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>input
//
// A rank's points as rows of doubles: the coordinates, the weight if there are weights, and the bits of the global id,
// which are only copied. Doors: paradt_mpi__check, paradt_mpi__read.

static uint64_t paradt_mpi__bits_at(const double *x) {
    uint64_t bits;
    memcpy(&bits, x, sizeof bits);
    return bits;
}

static void paradt_mpi__put_bits(double *x, uint64_t bits) {
    memcpy(x, &bits, sizeof bits);
}

// Agrees on the arguments: dim, weights, flags.
static paradt_status paradt_mpi__check(paradt_mpi__work *w, const paradt_points *local, paradt_status status) {
    int64_t facts[5], weights;
    const char *text;
    if (!status) status = paradt__check_arguments(local, &w->options.local, &text);
    if (!status && w->options.flags & ~(unsigned)PARADT_MPI_REPLICATED) status = PARADT_ERROR_ARGUMENT;
    status = paradt_mpi__agree(w, status);
    if (status) return status;
    facts[0] = local->dim;
    facts[1] = w->options.flags;
    facts[2] = w->options.local.flags;
    facts[3] = w->options.local.partition;
    facts[4] = w->options.flags & PARADT_MPI_REPLICATED ? (int64_t)local->count : 0;
    MPI_Bcast(facts, 5, MPI_INT64_T, 0, w->comm);
    if (facts[0] != local->dim || facts[1] != (int64_t)w->options.flags ||
        facts[2] != (int64_t)w->options.local.flags || facts[3] != (int64_t)w->options.local.partition ||
        (w->options.flags & PARADT_MPI_REPLICATED && facts[4] != (int64_t)local->count))
        status = PARADT_ERROR_ARGUMENT;
    weights = local->count && local->weights ? -1 : 0;
    paradt_mpi__smallest(w, &weights, 1);
    w->dim = local->dim;
    w->weighted = weights < 0;
    if (w->weighted && local->count && !local->weights) status = PARADT_ERROR_ARGUMENT;
    return paradt_mpi__agree(w, status);
}

// Numbers the points: w->first.
static void paradt_mpi__number(paradt_mpi__work *w, size_t count) {
    uint64_t mine = count, next = 0;
    int r;
    MPI_Allgather(&mine, 1, MPI_UINT64_T, w->first, 1, MPI_UINT64_T, w->comm);
    for (r = 0; r <= w->ranks; r++) {
        uint64_t here = r < w->ranks ? w->first[r] : 0;
        w->first[r] = next;
        next += here;
    }
}

// Reads this rank's points into rows of dim + weighted + 1 doubles; not collective.
static paradt_status paradt_mpi__read(paradt_mpi__work *w, const paradt_points *local, double **rows) {
    paradt__source source = paradt__source_of(local);
    size_t width = (size_t)w->dim + (size_t)w->weighted, i;
    *rows = (double *)paradt__alloc_filled(&w->memory, local->count, (width + 1) * sizeof **rows);
    if (!*rows) return PARADT_ERROR_MEMORY;
    for (i = 0; i < local->count; i++) {
        double *row = *rows + i * (width + 1);
        if (paradt__read_record(&source, i, row) == 2047) {
            w->error_point = i;
            return PARADT_ERROR_NOT_FINITE;
        }
        paradt_mpi__put_bits(row + width, w->first[w->rank] + i);
    }
    return PARADT_OK;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>partition
//
// Boxes with more than one rank are halved, all at once, until each has one. The cut is the coordinate below which the
// lower half's ranks have their share of the points, or of what these weigh, and some more or less where they have
// fewer or more sides towards others than the upper half's. It is found by rounds: the coordinates between which it
// lies are divided into 256, the points in each part are counted, and those in the part with the cut are looked at in
// the next round, until few are left or all have one coordinate: then they all go to the side that is nearer to its
// share. Parts have the same length in the first round; then as many values of the ordered bits, so that nine rounds do
// for any coordinates. A rank's rows are kept in the order of the boxes, so that each pass over those of a box has
// nothing to look up; in the end it is that of the ranks. Doors: paradt_mpi__partition.

typedef struct paradt_mpi__box {
    int first, ranks;              // ranks that share the box
    int64_t from[PARADT_MAX_DIM];  // the box: from <= ordered bits < to; INT64_MIN and INT64_MAX: unbounded
    int64_t to[PARADT_MAX_DIM];    //
    int64_t low[PARADT_MAX_DIM];   // around its points; at last, across the axis, around those that may be on the cut
    int64_t high[PARADT_MAX_DIM];  //
    int axis;                      // across which it is cut
    double origin, scale;          // of half the coordinates, the first and parts a unit; 0: parts of the ordered bits
    uint64_t wanted, below, equal; // what points weigh: for the lower half; below those that may be on the cut; these
    uint64_t enough;               // of the last: so few need not be told apart
    unsigned part;                 // that the cut is in
    int64_t cut;                   // ordered bits of the first coordinate of the upper half; PARADT_UNIFORM aims at it
    size_t begin, end;             // the rows that are this rank's
    size_t open;                   // of these, that may be on the cut: all, or if they are `listed`, so many
    int listed;
} paradt_mpi__box;

// What a side with others' points beyond costs a rank, in layers of own points: those that it gets from there, with its
// questions about them, and what is dropped of the cells in the end. Measured for 125,000 uniform points in space.
#define PARADT_MPI__LAYERS 1.6

// A cut is as near to what is wanted as this part of a rank's share: nearer, a round would cost more than it saves.
enum { PARADT_MPI__PRECISION = 1024 };

typedef struct paradt_mpi__cutter {
    double *rows;       // [count][width]
    double *spare;      // [room][width] what is above the cut of a box that is halved; in the end, what came
    size_t room, paged; // so many of these have their pages
    size_t count, width;
    uint64_t weight, mean;  // of each point of this rank, and of a point that takes the mean work
    size_t *open;           // [count] rows that may be on the cut of their box, where its rows begin
    unsigned char *parts;   // [count] that these are in
    paradt_mpi__box *boxes; // [ranks]
    int box_count;
    uint64_t *counts; // [ranks][PARADT_MPI__PARTS]
    int64_t *facts;   // [ranks][2 * PARADT_MAX_DIM] bounds of points, or aims, for all ranks to agree on
} paradt_mpi__cutter;

// Fetches a point ahead of its use, by its first and last coordinate: they may be in two of the cache's lines.
PARADT__INLINE void paradt_mpi__fetch_row(const paradt_mpi__cutter *c, size_t point) {
    PARADT__FETCH(c->rows, point * c->width);
    PARADT__FETCH(c->rows, (point + 1) * c->width - 1);
}

// Widens bounds: the smallest of the ordered bits, and ~ that of the largest, which turns the order and does not
// overflow.
PARADT__INLINE void paradt_mpi__bound_bits(int64_t *bounds, int64_t x) {
    bounds[0] = x < bounds[0] ? x : bounds[0];
    bounds[1] = ~x < bounds[1] ? ~x : bounds[1];
}

// Bounds the points of a box across one axis by their bits.
static void paradt_mpi__bound_axis(const paradt_mpi__cutter *c, const paradt_mpi__box *box, size_t axis,
                                   int64_t *bounds) {
    size_t i;
    for (i = box->begin; i < box->end; i++)
        paradt_mpi__bound_bits(bounds, paradt__ordered_bits(c->rows[i * c->width + axis]));
}

// Bounds the points of a box. Where subnormals are taken for zero, comparisons can't tell them apart, but the bits do.
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

// Puts the rows of a box that are below its cut before the others, all in the order that they had. Which side cannot be
// foreseen, so there is no branch: a row is written to both. Returns where the others begin.
PARADT__INLINE size_t paradt_mpi__part(paradt_mpi__cutter *c, const paradt_mpi__box *box, size_t width) {
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

// Bounding boxes of the points of all boxes, of those of all ranks.
static void paradt_mpi__bound(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    size_t dim = (size_t)w->dim, j;
    int b;
    paradt_mpi__smallest(w, c->facts, (int)((size_t)c->box_count * 2 * dim));
    for (b = 0; b < c->box_count; b++) {
        for (j = 0; j < dim; j++) {
            c->boxes[b].low[j] = c->facts[((size_t)b * dim + j) * 2];
            c->boxes[b].high[j] = ~c->facts[((size_t)b * dim + j) * 2 + 1];
        }
    }
}

// Of the sides that the ranks of a box have, were they cubes, so many are on sides of the box beyond which there is
// nothing. length: the box's
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

// So many points more than their share the lower half's ranks should get: with as many points each as the others they
// would be done sooner, having fewer sides towards others. Let a rank with p points and s of its 2 dim sides bare take
// the time p + (2 dim - s) cost; where all take the same, a rank has the mean of the points and cost times what its s
// exceeds the mean of s by. points: a rank's; length: the box's, which is used up
static double paradt_mpi__lean(const paradt_mpi__box *box, double points, double *length, int dim) {
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
    if (cost > points / (4 * dim)) cost = points / (4 * dim); // a rank keeps half of its points
    return cost * (bare_below - part * (bare_below + bare_above));
}

// Chooses the axis and what is wanted below the cut, or, for boxes of equal size, the cut.
static void paradt_mpi__aim(const paradt_mpi__work *w, const paradt_mpi__cutter *c, paradt_mpi__box *box,
                            uint64_t total) {
    uint64_t lower = (uint64_t)(box->ranks / 2), all = (uint64_t)box->ranks;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM], length[PARADT_MAX_DIM], longest, mean = (double)c->mean;
    int axis;
    box->wanted = total / all * lower + total % all * lower / all;
    box->below = 0;
    box->axis = box->listed = 0;
    box->open = box->end - box->begin;
    box->equal = total;
    box->enough = total / all / PARADT_MPI__PRECISION;
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
        box->wanted +=
            (uint64_t)(int64_t)(paradt_mpi__lean(box, (double)total / (mean * box->ranks), length, w->dim) * mean);
}

// Rank 0's aims become those of all. They are chosen in floating-point arithmetic, which may differ from rank to rank:
// by the compiler, its library, the processor and its mode.
static void paradt_mpi__share_aims(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    enum { FACTS = 5 };
    int b;
    for (b = 0; b < c->box_count; b++) {
        const paradt_mpi__box *box = c->boxes + b;
        int64_t *facts = c->facts + (size_t)b * FACTS;
        facts[0] = box->axis;
        facts[1] = (int64_t)box->wanted;
        facts[2] = box->cut;
        facts[3] = (int64_t)paradt_mpi__bits_at(&box->origin);
        facts[4] = (int64_t)paradt_mpi__bits_at(&box->scale);
    }
    MPI_Bcast(c->facts, c->box_count * FACTS, MPI_INT64_T, 0, w->comm);
    for (b = 0; b < c->box_count; b++) {
        paradt_mpi__box *box = c->boxes + b;
        const int64_t *facts = c->facts + (size_t)b * FACTS;
        box->axis = (int)facts[0];
        box->wanted = (uint64_t)facts[1];
        box->cut = facts[2];
        paradt_mpi__put_bits(&box->origin, (uint64_t)facts[3]);
        paradt_mpi__put_bits(&box->scale, (uint64_t)facts[4]);
    }
}

// Has a box to be cut by counting once more?
static int paradt_mpi__seeks(const paradt_mpi__work *w, const paradt_mpi__box *box) {
    return box->ranks > 1 && w->options.local.partition != PARADT_UNIFORM && box->equal > box->enough &&
           box->low[box->axis] < box->high[box->axis];
}

// Counts the points of a box that may be on its cut, part by part. even: in parts of one length. The smallest
// coordinate is in the first part and the largest in a later one, so less remains each time.
PARADT__INLINE void paradt_mpi__count_parts(const paradt_mpi__cutter *c, const paradt_mpi__box *box, int even,
                                            uint64_t *counts) {
    const size_t *list = box->listed ? c->open + box->begin : NULL;
    const double *rows = c->rows + box->axis, origin = box->origin, scale = box->scale;
    unsigned char *parts = c->parts + box->begin;
    size_t begin = box->begin, count = box->open, width = c->width, i;
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

// Finds the part with the cut.
static void paradt_mpi__find_part(paradt_mpi__box *box, const uint64_t *counts) {
    box->part = 0;
    while (box->part + 1 < PARADT_MPI__PARTS && box->below + counts[box->part] <= box->wanted)
        box->below += counts[box->part++];
    box->equal = counts[box->part];
    box->scale = 0.0;
}

// Lists the points in that part. bounds: as those of a box, but across its axis alone
static void paradt_mpi__list_part(const paradt_mpi__cutter *c, paradt_mpi__box *box, int64_t *bounds) {
    const unsigned char *parts = c->parts + box->begin, part = (unsigned char)box->part;
    const double *rows = c->rows + box->axis;
    size_t *list = c->open + box->begin, count = box->open, kept = 0, i;
    bounds[0] = bounds[1] = INT64_MAX;
    for (i = 0; i < count; i++) {
        if (parts[i] == part) list[kept++] = box->listed ? list[i] : box->begin + i;
    }
    for (i = 0; i < kept; i++) paradt_mpi__bound_bits(bounds, paradt__ordered_bits(rows[list[i] * c->width]));
    box->listed = 1;
    box->open = kept;
}

// One round for all boxes whose cut is not found. 0: there are none.
static int paradt_mpi__divide(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    int b, several = 0;
    memset(c->counts, 0, (size_t)c->box_count * PARADT_MPI__PARTS * sizeof *c->counts);
    for (b = 0; b < c->box_count; b++) {
        const paradt_mpi__box *box = c->boxes + b;
        uint64_t *counts = c->counts + (size_t)b * PARADT_MPI__PARTS;
        if (!paradt_mpi__seeks(w, box)) continue;
        if (box->scale > 0.0) paradt_mpi__count_parts(c, box, 1, counts);
        else paradt_mpi__count_parts(c, box, 0, counts);
        several = 1;
    }
    if (!several) return 0;
    MPI_Allreduce(MPI_IN_PLACE, c->counts, c->box_count * PARADT_MPI__PARTS, MPI_UINT64_T, MPI_SUM, w->comm);
    for (b = 0; b < c->box_count; b++) {
        c->facts[2 * b] = c->facts[2 * b + 1] = INT64_MAX;
        if (!paradt_mpi__seeks(w, c->boxes + b)) continue;
        paradt_mpi__find_part(c->boxes + b, c->counts + (size_t)b * PARADT_MPI__PARTS);
        paradt_mpi__list_part(c, c->boxes + b, c->facts + 2 * b);
    }
    paradt_mpi__smallest(w, c->facts, 2 * c->box_count);
    for (b = 0; b < c->box_count; b++) {
        paradt_mpi__box *box = c->boxes + b;
        if (c->facts[2 * b] == INT64_MAX) continue; // it was not narrowed
        box->low[box->axis] = c->facts[2 * b];
        box->high[box->axis] = ~c->facts[2 * b + 1];
    }
    return 1;
}

// The cut of a box that is found by counting: before or behind the points that may be on it.
static void paradt_mpi__cut(paradt_mpi__box *box) {
    uint64_t above = box->below + box->equal, missing = box->wanted - box->below;
    int64_t low = box->low[box->axis], high = box->high[box->axis];
    box->cut = above - box->wanted < missing ? high + 1 : low;
}

// Bounds and weighs the points of all boxes, on this rank.
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

// Makes two boxes of one, the upper half behind all others.
static void paradt_mpi__cut_box(const paradt_mpi__work *w, paradt_mpi__cutter *c, paradt_mpi__box *box) {
    paradt_mpi__box *upper = c->boxes + c->box_count++;
    if (w->options.local.partition != PARADT_UNIFORM) paradt_mpi__cut(box);
    *upper = *box;
    upper->from[box->axis] = box->to[box->axis] = box->cut;
    upper->first += box->ranks / 2;
    upper->ranks -= box->ranks / 2;
    box->ranks /= 2;
    upper->begin = c->width == 4 ? paradt_mpi__part(c, box, 4) : paradt_mpi__part(c, box, c->width);
    box->end = upper->begin;
}

// Halves all boxes that have several ranks. 0: there are none.
static int paradt_mpi__halve(paradt_mpi__work *w, paradt_mpi__cutter *c) {
    int b, boxes = c->box_count, several = 0;
    for (b = 0; b < boxes; b++) several |= c->boxes[b].ranks > 1;
    if (!several) return 0;
    paradt_mpi__measure_boxes(w, c);
    paradt_mpi__bound(w, c);
    MPI_Allreduce(MPI_IN_PLACE, c->counts, boxes, MPI_UINT64_T, MPI_SUM, w->comm);
    for (b = 0; b < boxes; b++) paradt_mpi__aim(w, c, c->boxes + b, c->counts[b]);
    paradt_mpi__share_aims(w, c);
    while (paradt_mpi__divide(w, c)) continue;
    for (b = 0; b < boxes; b++) {
        if (c->boxes[b].ranks > 1) paradt_mpi__cut_box(w, c, c->boxes + b);
    }
    return 1;
}

static void paradt_mpi__keep_box(paradt_mpi__work *w, const paradt_mpi__cutter *c) {
    int b, axis;
    for (b = 0; b < c->box_count; b++) {
        const paradt_mpi__box *box = c->boxes + b;
        if (box->first != w->rank) continue;
        for (axis = 0; axis < w->dim; axis++) {
            w->below[axis] = box->from[axis] == INT64_MIN ? -PARADT__FAR : paradt__from_ordered_bits(box->from[axis]);
            w->above[axis] = box->to[axis] == INT64_MAX ? PARADT__FAR : paradt__from_ordered_bits(box->to[axis]);
        }
    }
}

// Sends the rows, which each weigh so much, to the ranks whose boxes they are in. mean: the weight of a row that takes
// the mean work. *rows: [*count], replaced by those that this rank got, in the order of the ranks that they come from.
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
    c.open = (size_t *)paradt__alloc(&w->memory, c.count, sizeof *c.open);
    c.parts = (unsigned char *)paradt__alloc(&w->memory, c.count, 1);
    c.boxes = (paradt_mpi__box *)paradt__alloc(&w->memory, ranks, sizeof *c.boxes);
    c.counts = (uint64_t *)paradt__alloc(&w->memory, ranks, PARADT_MPI__PARTS * sizeof *c.counts);
    c.facts = (int64_t *)paradt__alloc(&w->memory, ranks, 2 * PARADT_MAX_DIM * sizeof *c.facts);
    c.paged = 0;
    c.room = c.count + c.count / 16;
    c.spare = (double *)paradt__alloc(&w->memory, c.room, c.width * sizeof *c.spare);
    if (!c.open || !c.parts || !c.boxes || !c.counts || !c.facts || !c.spare) status = PARADT_ERROR_MEMORY;
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
        paradt_mpi__keep_box(w, &c);
        for (b = 0; b < c.box_count; b++) w->to[c.boxes[b].first] = c.boxes[b].end - c.boxes[b].begin;
    }
    paradt__release(&w->memory, c.facts);
    paradt__release(&w->memory, c.counts);
    paradt__release(&w->memory, c.boxes);
    paradt__release(&w->memory, c.parts);
    paradt__release(&w->memory, c.open);
    got = c.spare;
    if (status) {
        paradt__release(&w->memory, got);
        return status;
    }
    *count = c.room;
    status = paradt_mpi__exchange_into(w, PARADT_OK, c.rows, c.width * sizeof *c.rows, &got, count);
    paradt__release(&w->memory, c.rows);
    *rows = (double *)got;
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>home
//
// A rank's own points as a paradt__set: without duplicates, scaled, with axes, measure and reference sphere agreed on
// by all ranks, so that the record of a point is the same everywhere and a search on any rank may be asked about cells
// of any other. Records of other ranks' points stand behind the own ones. Doors: paradt_mpi__settle,
// paradt_mpi__unsettle, paradt_mpi__learn.

// What goes over the wire for a point: its record, its id, its place at home.
static size_t paradt_mpi__wire_width(const paradt_mpi__work *w) {
    return w->set.width + 2;
}

// Room for `more` points of other ranks.
static paradt_status paradt_mpi__make_room(paradt_mpi__work *w, size_t more) {
    size_t room = w->known + more;
    void *array;
    if (room > (size_t)INT32_MAX && sizeof(paradt_index) == 4) return PARADT_ERROR_TOO_LARGE;
    if (room <= w->room) return PARADT_OK;
    room += room / 16; // more come soon
    array = w->set.records;
    if (!paradt__grow(&w->memory, &array, w->known * w->set.width, room * w->set.width, sizeof(double)))
        return PARADT_ERROR_MEMORY;
    w->set.records = (double *)array;
    if (w->inserting) w->engine.bw.records = w->set.records;
    array = w->home;
    if (!paradt__grow(&w->memory, &array, w->known - w->set.count, room - w->set.count, sizeof *w->home))
        return PARADT_ERROR_MEMORY;
    w->home = (paradt_mpi__home *)array;
    w->room = room;
    return PARADT_OK;
}

// Adds a point of another rank, unless it is known. wire: its row. There is room for it.
static size_t paradt_mpi__add_other(paradt_mpi__work *w, int rank, const double *wire) {
    paradt_mpi__home *home = w->home + (w->known - w->set.count);
    paradt_index place = (paradt_index)paradt_mpi__bits_at(wire + w->set.width + 1);
    if (paradt_mpi__table_put(&w->others, rank, place, (paradt_index)w->known)) return 0;
    memcpy(w->set.records + w->known * w->set.width, wire, w->set.width * sizeof *wire);
    home->id = paradt_mpi__bits_at(wire + w->set.width);
    home->rank = rank;
    home->place = place;
    w->known++;
    return 1;
}

// Where any point that is known is at home
PARADT__INLINE paradt_mpi__home paradt_mpi__home_of(const paradt_mpi__work *w, paradt_index point) {
    paradt_mpi__home home;
    if ((size_t)point >= w->set.count) return w->home[(size_t)point - w->set.count];
    home.id = w->received[w->set.origin[point]];
    home.rank = w->rank;
    home.place = point;
    return home;
}

static void paradt_mpi__put_wire(const paradt_mpi__work *w, double *wire, paradt_index point) {
    paradt_mpi__home home = paradt_mpi__home_of(w, point);
    memcpy(wire, paradt__record(&w->set, point), w->set.width * sizeof *wire);
    paradt_mpi__put_bits(wire + w->set.width, home.id);
    paradt_mpi__put_bits(wire + w->set.width + 1, (uint64_t)home.place);
}

// Sends the points of the list to their ranks and learns those that come. *news: how many of them were not known.
static paradt_status paradt_mpi__learn(paradt_mpi__work *w, paradt_status status, const paradt_mpi__list *list,
                                       size_t *news) {
    size_t width = paradt_mpi__wire_width(w), i, count, row = 0;
    double *rows = NULL;
    void *got = NULL;
    int r;
    *news = 0;
    if (!status) rows = (double *)paradt__alloc(&w->memory, list->count, width * sizeof *rows);
    if (!status && !rows) status = PARADT_ERROR_MEMORY;
    memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
    for (i = 0; i < list->count; i++) w->to[list->items[i].rank]++;
    paradt_mpi__begin_sorting(w);
    for (i = 0; i < list->count && !status; i++)
        paradt_mpi__put_wire(w, rows + w->next[list->items[i].rank]++ * width, list->items[i].place);
    status = paradt_mpi__exchange(w, status, rows, width * sizeof *rows, &got, &count);
    paradt__release(&w->memory, rows);
    if (!status) status = paradt_mpi__make_room(w, count);
    if (!status) status = paradt_mpi__table_room(w, &w->others, count);
    for (r = 0; r < w->ranks && !status; r++) {
        for (i = 0; i < w->from[r]; i++) *news += paradt_mpi__add_other(w, r, (double *)got + row++ * width);
    }
    paradt__release(&w->memory, got);
    return status;
}

// So many points of others one rank is likely to learn: a layer and a quarter around a cube of its own points.
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

// The set of the rows this rank got, without duplicates, along a curve, with room for points of others behind them; not
// collective.
static paradt_status paradt_mpi__load(paradt_mpi__work *w, const double *rows, size_t count) {
    size_t i, width = (size_t)w->dim + (size_t)w->weighted, bad;
    paradt__source source;
    if (count > (size_t)INT32_MAX / 2 && sizeof(paradt_index) == 4) return PARADT_ERROR_TOO_LARGE;
    w->received = (uint64_t *)paradt__alloc_filled(&w->memory, count, sizeof *w->received);
    w->twin = (paradt_index *)paradt__alloc_filled(&w->memory, count, sizeof *w->twin);
    if (!w->received || !w->twin) return PARADT_ERROR_MEMORY;
    for (i = 0; i < count; i++) w->received[i] = paradt_mpi__bits_at(rows + i * (width + 1) + width);
    w->received_count = count;
    memset(&source, 0, sizeof source);
    source.points.data = rows;
    source.points.count = count;
    source.points.dim = w->dim;
    source.points.stride = source.weight_stride = (width + 1) * sizeof *rows;
    source.points.weights = w->weighted ? rows + w->dim : NULL;
    source.reserve = paradt_mpi__expect_others(w, count);
    w->room = count + source.reserve;
    // ids ascend, so the smallest index is the smallest id
    return paradt__set_gather(&w->set, &source, NULL, &paradt__alone, &w->memory, w->twin, &bad);
}

// Multiplies all coordinates by a power of two that brings the largest near 1, if no rank loses a bit by that. Returns
// whether it has.
static int paradt_mpi__scale(paradt_mpi__work *w) {
    paradt__set *set = &w->set;
    int64_t largest = -set->exponent, fine = 1;
    size_t i;
    int shift, exact = 1;
    paradt_mpi__smallest(w, &largest, 1);
    shift = 1023 + (int)largest;
    if (shift >= -32 && shift <= 32) return 0;
    for (i = 0; i < set->count * set->width && exact; i++)
        paradt__scale(set->records[i], i % set->width < (size_t)w->dim ? shift : 2 * shift, &exact);
    fine = exact;
    paradt_mpi__smallest(w, &fine, 1);
    if (!fine) return 0;
    for (i = 0; i < set->count * set->width; i++)
        set->records[i] = paradt__scale(set->records[i], i % set->width < (size_t)w->dim ? shift : 2 * shift, &exact);
    w->shift = shift;
    return 1;
}

// Points that span all, and the axes in which they do. origins: of those that are this rank's, in the places they have
// among them; the others are -1. Returns the affine dimension.
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

// Measures the points of all ranks. as_read: the own ones have been, as they are, while they were read.
static void paradt_mpi__measure(paradt_mpi__work *w, int dim, int as_read) {
    paradt__space *space = &w->set.space;
    int64_t facts[6 + 2 * PARADT_MAX_DIM];
    paradt__range *ranges[2];
    int j;
    if (as_read) paradt__set_measured(&w->set, dim);
    else paradt__set_measure(&w->set, &paradt__alone, dim);
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
    paradt_mpi__smallest(w, facts, 6 + 2 * w->dim);
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

// A sample of all points: at most 64 of each rank, in `sample`, [ranks][64][dim], closed up. Returns their number.
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

// Takes the sagittas away again: the points of another rank are not near to the sphere.
static void paradt_mpi__ungrade(paradt__set *set) {
    size_t i;
    set->width--;
    set->grade = PARADT__UNGRADED;
    for (i = 0; i < set->count; i++)
        memmove(set->records + i * set->width, set->records + i * (set->width + 1), set->width * sizeof(double));
}

// Grades the points by one reference sphere, if those of all ranks are near it.
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
    status = paradt__set_sagittas(set, sphere[dim], PARADT__NEAR_SPHERE, set->count, &w->memory, &nearby);
    all_near = nearby;
    status = paradt_mpi__agree(w, status);
    if (status) return status;
    paradt_mpi__smallest(w, &all_near, 1);
    if (nearby) w->room = set->count; // the records are others now
    if (nearby && !all_near) paradt_mpi__ungrade(set);
    if (!all_near) return PARADT_OK;
    MPI_Allreduce(&set->grade_limit, &limit, 1, MPI_DOUBLE, MPI_MAX, w->comm);
    paradt__set_grade_bounds(set, limit);
    return PARADT_OK;
}

// Lays the grid over the own points, in their order. Their room is this rank's box, where that is known on the axes
// that orient.
static paradt_status paradt_mpi__lay(paradt_mpi__work *w) {
    paradt__set *set = &w->set;
    int axis, bounded = w->shift != 0;
    size_t i;
    paradt_status status;
    w->home = (paradt_mpi__home *)paradt__alloc(&w->memory, w->room - set->count, sizeof *w->home);
    w->audience = (int *)paradt__alloc_filled(&w->memory, set->count, sizeof *w->audience);
    if (!w->home || !w->audience) return PARADT_ERROR_MEMORY;
    w->known = set->count;
    w->ready = w->ranks > 1 && set->count && set->space.dim > 0;
    if (w->ready) {
        status = paradt__grid_lay(&w->grid, set, &w->memory);
        if (status) return status;
        for (axis = set->space.dim; axis < w->dim; axis++)
            bounded |= w->below[set->axes[axis]] > -PARADT__FAR || w->above[set->axes[axis]] < PARADT__FAR;
        for (axis = 0; axis < w->dim; axis++) {
            w->inside[2 * axis] = bounded ? PARADT__FAR : w->below[set->axes[axis]];
            w->inside[2 * axis + 1] = bounded ? -PARADT__FAR : w->above[set->axes[axis]];
        }
        paradt__search_begin(&w->search, set, &w->grid);
    }
    for (i = 0; i < set->count; i++) w->audience[i] = -1;
    return PARADT_OK;
}

// Every rank learns the points that span all: so every local triangulation has the dimension of the whole. origins: see
// paradt_mpi__span
static paradt_status paradt_mpi__share_basis(paradt_mpi__work *w, const paradt_index *origins) {
    enum { MOST = PARADT_MAX_DIM + 5 };          // words a point: its row on the wire and, last, its rank
    uint64_t words[(PARADT_MAX_DIM + 1) * MOST]; // zero but for one rank's
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
    status = paradt_mpi__make_room(w, count);
    if (!status) status = paradt_mpi__table_room(w, &w->others, count);
    for (k = 0; k < count && !status; k++) {
        int rank = (int)words[k * MOST + width];
        memcpy(wire, words + k * MOST, width * sizeof *wire);
        if (rank != w->rank) (void)paradt_mpi__add_other(w, rank, wire);
    }
    return paradt_mpi__agree(w, status);
}

// Makes the rows this rank got, in the order of their ids, its own points.
static paradt_status paradt_mpi__settle(paradt_mpi__work *w, const double *rows, size_t count) {
    size_t most = (size_t)w->dim + 1;
    double *gathered;
    size_t *counts;
    paradt_index origins[PARADT_MAX_DIM + 1];
    int dim = -1, as_read = 0;
    paradt_status status = paradt_mpi__load(w, rows, count);
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
    if (paradt__set_permute(&w->set)) as_read = 0;
    paradt_mpi__measure(w, dim, as_read);
    w->out->dim = dim;
    w->stats.points = w->set.count;
    w->stats.duplicates = count - w->set.count;
    if (dim > 0) status = paradt_mpi__grade(w);
    if (!status) status = paradt_mpi__agree(w, paradt_mpi__lay(w));
    return status || dim <= 0 ? status : paradt_mpi__share_basis(w, origins);
}

// Gives back what is for asking and being asked.
static void paradt_mpi__unsettle_questions(paradt_mpi__work *w) {
    if (w->grid.levels) paradt__grid_free(&w->grid, &w->memory);
    paradt__release(&w->memory, w->others.slots);
    paradt__release(&w->memory, w->told.slots);
    paradt__release(&w->memory, w->audience);
    w->audience = NULL;
    memset(&w->grid, 0, sizeof w->grid);
    memset(&w->others, 0, sizeof w->others);
    memset(&w->told, 0, sizeof w->told);
}

// Gives back what was settled.
static void paradt_mpi__unsettle(paradt_mpi__work *w) {
    paradt_mpi__unsettle_questions(w);
    paradt__set_free(&w->set, &w->memory);
    paradt__release(&w->memory, w->home);
    paradt__release(&w->memory, w->twin);
    paradt__release(&w->memory, w->received);
    memset(&w->set, 0, sizeof w->set);
    w->home = NULL;
    w->twin = NULL;
    w->received = NULL;
    w->known = w->room = w->received_count = 0;
    w->shift = 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>weigh
//
// Points do not take the same time: one of a lattice takes twice that of one in general position, one that is nearly on
// a sphere three times, and one that is handed in again next to none. So once it has its points, each rank triangulates
// some of them, here and there a few that are near to each other. Where that makes expect that a rank has much more to
// do than others, points weigh what they take, and space is cut anew. Doors: paradt_mpi__place_points.

enum {
    PARADT_MPI__SAMPLES = 3,   // so often
    PARADT_MPI__SAMPLED = 128, // so many points
    PARADT_MPI__MEAN = 64,     // weight of a point that takes the mean work
    PARADT_MPI__LIGHTEST = 16  // so that no rank gets more than five times its share of the points
};

// Points a rank for which it is worth it, and how many times the mean work is much more: to cut anew takes a tenth of
// the time. The tests define both, so as to cut all sets anew.
#ifndef PARADT_MPI__WORTH
#define PARADT_MPI__WORTH 8192
#define PARADT_MPI__MUCH  1.25
#endif
// Work to read and compare a point, and that of an in-sphere predicate, in cells that are made: by insertion in three
// dimensions these take a quarter of a microsecond, predicates 0.13 (lattice) to 0.26 (cospherical). From four
// dimensions on nearly all is in the cells.
#define PARADT_MPI__READING   0.6
#define PARADT_MPI__PREDICATE 0.7

// The work that the own points are expected to take; not collective.
static paradt_status paradt_mpi__expect(paradt_mpi__work *w, double *work) {
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

// How much a point of this rank should weigh where the work is uneven; 0: it is not. Ranks agree, as they add integers.
static paradt_status paradt_mpi__weigh(paradt_mpi__work *w, uint64_t *weight) {
    double work = 0.0, units;
    uint64_t all, most;
    paradt_status status;
    *weight = 0;
    if (w->ranks == 1 || w->options.local.partition == PARADT_UNIFORM || w->out->dim <= 0 ||
        w->first[w->ranks] / (uint64_t)w->ranks < PARADT_MPI__WORTH)
        return PARADT_OK;
    status = paradt_mpi__agree(w, paradt_mpi__expect(w, &work));
    if (status) return status;
    all = paradt_mpi__sum(w, (uint64_t)work);
    most = (uint64_t)work;
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_UINT64_T, MPI_MAX, w->comm);
    if (!((double)most * w->ranks > PARADT_MPI__MUCH * (double)all)) return PARADT_OK;
    units = PARADT_MPI__MEAN;
    if (w->received_count) units *= work / (double)w->received_count * (double)w->first[w->ranks] / (double)all;
    if (!(units > (double)PARADT_MPI__LIGHTEST)) units = (double)PARADT_MPI__LIGHTEST;
    *weight = units < 1048576.0 ? (uint64_t)units : 1048576;
    return PARADT_OK;
}

// The rows in the order of their ids; not collective.
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
            keyed[i].key = paradt_mpi__bits_at(*rows + (i + 1) * width - 1);
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

// Makes the points of its box each rank's own. Releases the rows.
static paradt_status paradt_mpi__place_points(paradt_mpi__work *w, double *rows) {
    size_t count = w->out->point_count;
    double begun = paradt__now(), cut, weighed;
    uint64_t weight = 0;
    paradt_status status = paradt_mpi__partition(w, 1, 1, &rows, &count);
    cut = paradt__now();
    w->stats.seconds_partition += cut - begun;
    if (!status) status = paradt_mpi__settle(w, rows, count);
    if (!status) status = paradt_mpi__weigh(w, &weight);
    weighed = paradt__now();
    w->stats.seconds_grid += weighed - cut;
    if (!status && weight) {
        paradt_mpi__unsettle(w);
        status = paradt_mpi__partition(w, weight, PARADT_MPI__MEAN, &rows, &count);
        if (!status) status = paradt_mpi__agree(w, paradt_mpi__sort_by_id(w, &rows, count));
        cut = paradt__now();
        w->stats.seconds_partition += cut - weighed;
        if (!status) status = paradt_mpi__settle(w, rows, count);
        w->stats.seconds_grid += paradt__now() - cut;
    }
    paradt__release(&w->memory, rows);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>directory
//
// What every rank knows of all others: up to 64 boxes around their points, those of the finest level of their grid that
// has no more, and one around them all. Only that decides whom to ask, on the safe side. The guess uses it too: it
// sends a point to a rank that has a box nearer than the size of the grid cell it is in, which has eight points, so a
// size that adapts to them. And each rank asks for all points within some margin of its own box: where the others send
// these, a sphere that ends there needs no question. Doors: paradt_mpi__tell, paradt_mpi__guess.

// Of the guess and of the margin, in sizes of a grid cell; together about one layer of uniform points. With half the
// first, more than half of what is needed is left to be asked for. Points that come late take four times as long as
// those that are guessed: the margin is where more of these would take as long as fewer of those save.
#define PARADT_MPI__REACH  0.4
#define PARADT_MPI__MARGIN 0.5
// In margins: how far from a rank's points most spheres end that it may have to ask about.
#define PARADT_MPI__VICINITY 4

// One box a rank, around its boxes.
static void paradt_mpi__bound_ranks(paradt_mpi__work *w) {
    paradt_mpi__directory *d = &w->directory;
    size_t rows = d->width / PARADT__LANES, row;
    int r, b;
    for (r = 0; r < w->ranks; r++) {
        const double *boxes = d->groups + (size_t)r * PARADT_MPI__GROUPS * d->width;
        double *box = d->ranks + (size_t)(r / PARADT__LANES) * d->width + r % PARADT__LANES;
        for (row = 0; row < rows && d->count[r]; row++) {
            int lower = row < 2 * (size_t)w->dim && row % 2 == 0; // the last row is the largest grade
            double *to = box + row * PARADT__LANES;
            *to = boxes[row * PARADT__LANES];
            for (b = 1; b < d->count[r]; b++) {
                double x =
                    boxes[(size_t)(b / PARADT__LANES) * d->width + row * PARADT__LANES + (size_t)(b % PARADT__LANES)];
                if (lower ? x < *to : x > *to) *to = x;
            }
        }
    }
}

// The box of a rank; from one bound to the next it is PARADT__LANES.
static const double *paradt_mpi__rank_box(const paradt_mpi__directory *d, int rank) {
    return d->ranks + (size_t)(rank / PARADT__LANES) * d->width + rank % PARADT__LANES;
}

// May the rank have points in the box (low and high of each axis that orients)?
static int paradt_mpi__may_have(const paradt_mpi__work *w, int rank, const double *box) {
    const paradt_mpi__directory *d = &w->directory;
    const double *bounds = paradt_mpi__rank_box(d, rank);
    int j = 0;
    if (!d->count[rank]) return 0;
    for (; j < w->set.space.dim && bounds[0] <= box[1] && bounds[PARADT__LANES] >= box[0]; j++, box += 2)
        bounds += 2 * PARADT__LANES;
    return j == w->set.space.dim;
}

// Lists the ranks that have points up to `margin` away from this one's.
static void paradt_mpi__list_near(paradt_mpi__work *w, double margin) {
    paradt_mpi__directory *d = &w->directory;
    const double *mine = paradt_mpi__rank_box(d, w->rank), *theirs;
    int sides = 2 * w->set.space.dim, r, j;
    for (j = 0; j < sides; j++) {
        d->own[j] = mine[j * PARADT__LANES];
        d->vicinity[j] = d->own[j] + (j % 2 ? margin : -margin);
    }
    d->nearby_count = 0;
    for (r = 0; r < w->ranks; r++) {
        paradt_mpi__neighbor *neighbor = d->nearby + d->nearby_count;
        if (r == w->rank || !paradt_mpi__may_have(w, r, d->vicinity)) continue;
        theirs = paradt_mpi__rank_box(d, r);
        neighbor->rank = r;
        neighbor->beyond = 0;
        for (j = 0; j < sides; j += 2) {
            neighbor->beyond |= (unsigned)(theirs[(j + 1) * PARADT__LANES] < d->own[j]) << j;
            neighbor->beyond |= (unsigned)(theirs[j * PARADT__LANES] > d->own[j + 1]) << (j + 1);
        }
        d->nearby_count++;
    }
}

// How far beyond its box this rank wants to know all points: so far as most spheres at its border reach. That is
// measured by the grid cells there, by their harmonic mean, to which small ones count more.
static double paradt_mpi__margin(const paradt_mpi__work *w) {
    size_t box, nearby = 0;
    double inverse = 0.0;
    int j;
    for (box = 0; box < w->grid.box_count[0]; box++) {
        const double *group = w->grid.boxes[0] + box / PARADT__LANES * w->grid.group_width + box % PARADT__LANES;
        double side = 0.0, gap = PARADT__FAR;
        for (j = 0; j < w->dim; j++) {
            double low = group[2 * j * PARADT__LANES], high = group[(2 * j + 1) * PARADT__LANES];
            side = paradt__larger(side, high - low);
            gap = -paradt__larger(-gap, paradt__larger(w->inside[2 * j] - low, high - w->inside[2 * j + 1]));
        }
        if (gap > side || !(side > 0.0)) continue;
        inverse += 1.0 / side;
        nearby++;
    }
    return nearby ? PARADT_MPI__MARGIN * (double)nearby / inverse : 0.0;
}

static paradt_status paradt_mpi__tell(paradt_mpi__work *w) {
    paradt_mpi__directory *d = &w->directory;
    size_t ranks = (size_t)w->ranks, size, room;
    double *mine, margin;
    int count = 0, level = 0;
    paradt_status status = PARADT_OK;
    d->width = (size_t)(2 * w->dim + (w->set.grade != PARADT__UNGRADED)) * PARADT__LANES;
    size = PARADT_MPI__GROUPS * d->width;
    room = (ranks + PARADT__LANES - 1) / PARADT__LANES * d->width;
    d->groups = (double *)paradt__alloc(&w->memory, ranks * size, sizeof *d->groups);
    d->count = (int *)paradt__alloc(&w->memory, ranks, sizeof *d->count);
    d->ranks = (double *)paradt__alloc(&w->memory, room, sizeof *d->ranks);
    d->rooms = (double *)paradt__alloc(&w->memory, ranks, (2 * (size_t)w->dim + 1) * sizeof *d->rooms);
    d->nearby = (paradt_mpi__neighbor *)paradt__alloc(&w->memory, ranks, sizeof *d->nearby);
    d->listeners = (int *)paradt__alloc(&w->memory, ranks, sizeof *d->listeners);
    mine = (double *)paradt__alloc(&w->memory, size, sizeof *mine);
    if (!d->groups || !d->count || !d->ranks || !d->rooms || !d->nearby || !d->listeners || !mine)
        status = PARADT_ERROR_MEMORY;
    status = paradt_mpi__agree(w, status);
    if (!status) {
        memset(mine, 0, size * sizeof *mine);
        if (w->ready) {
            while (w->grid.box_count[level] > (size_t)PARADT_MPI__GROUPS * PARADT__LANES) level++;
            count = (int)w->grid.box_count[level];
            size = ((size_t)count + PARADT__LANES - 1) / PARADT__LANES * d->width;
            memcpy(mine, w->grid.boxes[level], size * sizeof *mine);
        }
        size = PARADT_MPI__GROUPS * d->width;
        MPI_Allgather(mine, (int)size, MPI_DOUBLE, d->groups, (int)size, MPI_DOUBLE, w->comm);
        MPI_Allgather(&count, 1, MPI_INT, d->count, 1, MPI_INT, w->comm);
        memset(d->ranks, 0, room * sizeof *d->ranks);
        paradt_mpi__bound_ranks(w);
        size = 2 * (size_t)w->dim + 1;
        memcpy(mine, w->inside, (size - 1) * sizeof *mine);
        mine[size - 1] = margin = w->ready && w->set.space.filtered ? paradt_mpi__margin(w) : 0.0;
        MPI_Allgather(mine, (int)size, MPI_DOUBLE, d->rooms, (int)size, MPI_DOUBLE, w->comm);
        paradt_mpi__list_near(w, PARADT_MPI__VICINITY * margin);
    }
    paradt__release(&w->memory, mine);
    return status;
}

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

// Of a rank's boxes, by their numbers, those that are near to something
typedef struct paradt_mpi__near_boxes {
    const double *groups;
    size_t width; // of a group
    int count;
    unsigned char number[PARADT_MPI__GROUPS * PARADT__LANES];
} paradt_mpi__near_boxes;

PARADT__INLINE int paradt_mpi__is_near_box(const paradt_mpi__near_boxes *boxes, int i, const double *low,
                                           const double *high, int dim, double reach) {
    int number = boxes->number[i];
    const double *group = boxes->groups + (size_t)(number / PARADT__LANES) * boxes->width;
    return paradt_mpi__is_near(group, number % PARADT__LANES, low, high, dim, reach);
}

// Lists in *found those of the boxes that are nearer than `reach`. Returns how many.
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

static int paradt_mpi__is_near_any(const paradt_mpi__near_boxes *boxes, const double *x, int dim, double reach) {
    int i = 0;
    while (i < boxes->count && !paradt_mpi__is_near_box(boxes, i, x, x, dim, reach)) i++;
    return i < boxes->count;
}

// A bit more than the smallest distance of the first point of a grid cell from its others: in a lattice, the step.
static double paradt_mpi__step(const paradt_mpi__work *w, size_t box) {
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

// The bounds of a box of the grid. Returns how near it must be to another rank's box for its points to be sent there.
static double paradt_mpi__bounds(const paradt_mpi__work *w, int level, size_t box, double *low, double *high) {
    const double *group = w->grid.boxes[level] + box / PARADT__LANES * w->grid.group_width + box % PARADT__LANES;
    double side = 0.0;
    int j;
    for (j = 0; j < w->dim; j++) {
        low[j] = group[2 * j * PARADT__LANES];
        high[j] = group[(2 * j + 1) * PARADT__LANES];
        side = paradt__larger(side, high[j] - low[j]);
    }
    side *= PARADT_MPI__REACH;
    return level ? side : paradt__larger(side, paradt_mpi__step(w, box));
}

// Lists the points for a rank that are in one box of the grid. boxes: the rank's that are near to what it is in. (Where
// a lattice's step reaches farther than the level above, some are left out; they are asked for then.)
static paradt_status paradt_mpi__guess_box(paradt_mpi__work *w, paradt_mpi__list *list, int rank, int level, size_t box,
                                           const paradt_mpi__near_boxes *boxes) {
    size_t i, end = (box + 1) * PARADT__LANES, below = level ? w->grid.box_count[level - 1] : w->set.count;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM], reach = paradt_mpi__bounds(w, level, box, low, high);
    paradt_mpi__near_boxes nearby;
    paradt_status status = PARADT_OK;
    if (!paradt_mpi__list_near_boxes(boxes, low, high, w->dim, reach, &nearby)) return PARADT_OK;
    for (i = box * PARADT__LANES; i < end && i < below && !status; i++) {
        const double *x = w->set.records + i * w->set.width;
        if (level) status = paradt_mpi__guess_box(w, list, rank, level - 1, i, &nearby);
        else if (paradt_mpi__is_near_any(&nearby, x, w->dim, reach))
            status = paradt_mpi__list_news(w, list, rank, (paradt_index)i);
    }
    return status;
}

// Lists the points for a rank that are near to its boxes.
static paradt_status paradt_mpi__guess_for(paradt_mpi__work *w, paradt_mpi__list *list, int rank) {
    const paradt_mpi__directory *d = &w->directory;
    double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM], reach;
    paradt_mpi__near_boxes all;
    paradt_status status = PARADT_OK;
    int top = w->grid.levels - 1, i;
    size_t box;
    all.groups = d->groups + (size_t)rank * PARADT_MPI__GROUPS * d->width;
    all.width = d->width;
    all.count = d->count[rank];
    for (i = 0; i < all.count; i++) all.number[i] = (unsigned char)i;
    for (box = 0; box < w->grid.box_count[top] && !status; box++) {
        reach = paradt_mpi__bounds(w, top, box, low, high);
        if (paradt_mpi__is_near(paradt_mpi__rank_box(d, rank), 0, low, high, w->dim, reach))
            status = paradt_mpi__guess_box(w, list, rank, top, box, &all);
    }
    return status;
}

// The box of a rank, and around it `part` of the margin that it wants.
static void paradt_mpi__room_of(const paradt_mpi__work *w, int rank, double part, double *room) {
    const double *wish = w->directory.rooms + (size_t)rank * (2 * (size_t)w->dim + 1);
    double margin = wish[2 * w->dim] * part;
    int j;
    for (j = 0; j < w->dim; j++) {
        room[2 * j] = wish[2 * j] - margin;
        room[2 * j + 1] = wish[2 * j + 1] + margin;
    }
}

// Lists the points in a room that a rank was not told of and that are in one box of the grid, up to `most` points.
static paradt_status paradt_mpi__list_room(paradt_mpi__work *w, paradt_mpi__list *list, int rank, const double *room,
                                           int level, size_t box, size_t most) {
    const double *group = w->grid.boxes[level] + box / PARADT__LANES * w->grid.group_width + box % PARADT__LANES;
    size_t i, end = (box + 1) * PARADT__LANES, below = level ? w->grid.box_count[level - 1] : w->set.count;
    paradt_status status = PARADT_OK;
    int j;
    for (j = 0; j < w->dim; j++) {
        if (group[2 * j * PARADT__LANES] > room[2 * j + 1] || group[(2 * j + 1) * PARADT__LANES] < room[2 * j])
            return PARADT_OK;
    }
    for (i = box * PARADT__LANES; i < end && i < below && !status && list->count < most; i++) {
        const double *x = w->set.records + i * w->set.width;
        if (level) {
            status = paradt_mpi__list_room(w, list, rank, room, level - 1, i, most);
            continue;
        }
        for (j = 0; j < w->dim && x[j] >= room[2 * j] && x[j] <= room[2 * j + 1];) j++;
        if (j == w->dim && !paradt_mpi__knows(w, rank, (paradt_index)i))
            status = paradt_mpi__list_add(w, list, rank, (paradt_index)i);
    }
    return status;
}

// Lists all points around the room of a rank, as far as it wants or half or a quarter as far, so that they are no more
// than a third of those guessed before, or few; else none. *kept: how far, of what it wants.
static paradt_status paradt_mpi__keep_room(paradt_mpi__work *w, paradt_mpi__list *list, int rank, size_t guessed,
                                           double *kept) {
    double room[2 * PARADT_MAX_DIM];
    paradt_mpi__list found;
    size_t most = guessed / 3 + 64, box, i;
    int top = w->grid.levels - 1;
    paradt_status status = PARADT_OK;
    memset(&found, 0, sizeof found);
    for (*kept = 1.0; *kept > 0.0 && !status; *kept = *kept > 0.25 ? 0.5 * *kept : 0.0) {
        found.count = 0;
        paradt_mpi__room_of(w, rank, *kept, room);
        for (box = 0; box < w->grid.box_count[top] && !status; box++)
            status = paradt_mpi__list_room(w, &found, rank, room, top, box, most);
        if (found.count < most) break;
    }
    if (!(*kept > 0.0)) found.count = 0;
    for (i = 0; i < found.count && !status; i++) status = paradt_mpi__list_news(w, list, rank, found.items[i].place);
    paradt__release(&w->memory, found.items);
    return status;
}

// The room that this rank knows all points of, after how far the others kept to its wish.
static void paradt_mpi__widen(paradt_mpi__work *w, const double *kept, double *of_others) {
    double least = 1.0;
    int r;
    MPI_Alltoall(kept, (int)sizeof *kept, MPI_BYTE, of_others, (int)sizeof *kept, MPI_BYTE, w->comm);
    for (r = 0; r < w->ranks; r++) least = of_others[r] < least ? of_others[r] : least;
    paradt_mpi__room_of(w, w->rank, least, w->inside);
}

static paradt_status paradt_mpi__guess(paradt_mpi__work *w) {
    paradt_mpi__list list;
    paradt_status status = PARADT_OK;
    size_t news, ranks = (size_t)w->ranks;
    double *kept = (double *)paradt__alloc(&w->memory, 2 * ranks, sizeof *kept);
    int r;
    memset(&list, 0, sizeof list);
    if (!kept) status = PARADT_ERROR_MEMORY;
    for (r = 0; r < w->ranks && !status; r++) {
        size_t before = list.count;
        kept[r] = 1.0;
        if (r == w->rank || !w->directory.count[r] || !w->ready) continue;
        status = paradt_mpi__guess_for(w, &list, r);
        if (!status) status = paradt_mpi__keep_room(w, &list, r, list.count - before, kept + r);
    }
    status = paradt_mpi__agree(w, paradt_mpi__learn(w, status, &list, &news));
    if (!status) paradt_mpi__widen(w, kept, kept + ranks);
    w->stats.points_guessed = news;
    paradt__release(&w->memory, list.items);
    paradt__release(&w->memory, kept);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>questions
//
// Steps 2 to 4. Doors: paradt_mpi__rounds.

// What a vertex of a cell in question is to the rank that is asked: a place among its own points, or that of a point it
// may want to keep, or neither.
enum { PARADT_MPI__STRANGER = -1 }; // below it: an own point of the asking rank, STRANGER - 1 - place

typedef struct paradt_mpi__questions {
    size_t count, capacity;
    paradt_mpi__question *items;
    paradt_mpi__list to_tell; // points to be sent without a question
} paradt_mpi__questions;

// What the local triangulation goes on to hold is added to the rank's account.
static void paradt_mpi__account(paradt_mpi__work *w) {
    paradt_mpi__add_peak(w, &w->local);
    w->local_bytes = paradt__remote_bytes(&w->local);
    w->memory.held += w->local_bytes;
}

static void paradt_mpi__forget(paradt_mpi__work *w) {
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

// Triangulates all that this rank knows by any method, from the beginning.
static paradt_status paradt_mpi__triangulate_anew(paradt_mpi__work *w) {
    paradt_points points;
    paradt_options options;
    double *weights = NULL;
    size_t i;
    paradt_status status;
    paradt_mpi__forget(w);
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
    if (!status) paradt_mpi__account(w);
    paradt__release(&w->memory, weights);
    return status;
}

// Inserts what this rank knows and has not inserted yet, along a curve, as each is searched for from the one before;
// but by rounds, as points that come one beside the other outside of a flat hull make very large stars.
static paradt_status paradt_mpi__insert_late(paradt_mpi__work *w) {
    paradt__set all = w->set, late = w->set;
    size_t first = w->engine.bw.count, i;
    paradt_index *order;
    paradt_status status = PARADT_OK;
    all.count = w->known;
    late.records = w->set.records + first * w->set.width;
    late.count = w->known - first;
    order = paradt__remote_late_order(&late, &w->memory);
    if (!order) return PARADT_ERROR_MEMORY;
    for (i = 0; i < late.count && !status; i++)
        status = paradt__remote_engine_insert(&w->engine, &all, (paradt_index)first + order[i]);
    paradt__release(&w->memory, order);
    return status;
}

// Inserts what this rank knows, at first or after more came.
static paradt_status paradt_mpi__insert(paradt_mpi__work *w) {
    paradt__set all = w->set;
    paradt_options options;
    paradt__progress progress;
    if (w->inserting) return paradt_mpi__insert_late(w);
    all.count = w->known;
    options = paradt_mpi__local_options(w);
    paradt__meter_begin(&w->meter, &options);
    w->meter_told = 0;
    progress = paradt__progress_of(&w->meter, &w->meter_told, 1.0);
    w->inserting = 1;
    return paradt__remote_engine_begin(&w->engine, &all, w->set.count, w->low, w->high, &w->memory, &progress);
}

// Can the triangulation be gone on with when more points come? Insertion can, undivided. Other methods build it twice
// then, so where there are several ranks insertion pays in one dimension more.
static int paradt_mpi__can_insert(const paradt_mpi__work *w) {
    int dim = w->set.space.dim;
    return dim > 0 && paradt__inserts(w->options.local.method, dim - (w->ranks > 1)) && w->options.local.regions <= 1;
}

// The local engine: triangulates all that this rank knows. Not collective.
static paradt_status paradt_mpi__triangulate_known(paradt_mpi__work *w) {
    double begun = paradt__now();
    paradt_status status = paradt_mpi__go_on(w, 0.0);
    if (status || !w->set.count) return status;
    status = paradt_mpi__can_insert(w) ? paradt_mpi__insert(w) : paradt_mpi__triangulate_anew(w);
    w->stats.triangulations++;
    w->stats.seconds_build += paradt__now() - begun;
    return status;
}

// Places of cells, for paradt_mpi__cell.
static size_t paradt_mpi__place_count(const paradt_mpi__work *w) {
    return w->inserting ? w->engine.bw.cells.count : w->local.cell_count;
}

// What is to be asked for the sake of a place: about a sphere, that of the cell at *place then, and about the facets on
// the hull whose bits are set. 0: nothing. While points are inserted a ghost stands for its facet.
enum { PARADT_MPI__SPHERE = 1 << (PARADT_MAX_DIM + 1) };

PARADT__INLINE unsigned paradt_mpi__topics(const paradt_mpi__work *w, size_t k, size_t *place) {
    size_t j;
    unsigned topics = PARADT_MPI__SPHERE;
    int facet;
    if (w->inserting) {
        if (!paradt__remote_engine_place(&w->engine, k, place, &facet)) return 0;
        return facet < 0 ? topics : 1u << facet;
    }
    for (j = 0; j < k; j++) topics |= (unsigned)(w->local.neighbors[*place * k + j] < 0) << j;
    return topics;
}

// The vertices of the cell at a place, and their records.
PARADT__INLINE void paradt_mpi__cell(const paradt_mpi__work *w, size_t k, size_t place, paradt_index *cell,
                                     const double **corners) {
    size_t j;
    if (w->inserting) {
        paradt__remote_engine_cell(&w->engine, k, place, cell, corners);
        return;
    }
    for (j = 0; j < k; j++) {
        cell[j] = w->local.cells[place * k + j];
        corners[j] = paradt__record(&w->set, cell[j]);
    }
}

// Which of a cell's vertices are own points. Returns how many.
PARADT__INLINE int paradt_mpi__own_corners(const paradt_mpi__work *w, size_t k, const paradt_index *cell,
                                           paradt_index *own) {
    size_t i;
    int count = 0;
    for (i = 0; i < k; i++) {
        own[i] = (size_t)cell[i] < w->set.count ? cell[i] : (paradt_index)PARADT__OPEN;
        count += own[i] >= 0;
    }
    return count;
}

static paradt_status paradt_mpi__ask(paradt_mpi__work *w, paradt_mpi__questions *q, int rank, paradt_index cell,
                                     int opposite) {
    void *items = paradt_mpi__one_more(w, q->items, q->count, &q->capacity, sizeof *q->items);
    if (!items) return PARADT_ERROR_MEMORY;
    q->items = (paradt_mpi__question *)items;
    q->items[q->count].rank = rank;
    q->items[q->count].cell = cell;
    q->items[q->count++].opposite = opposite;
    return PARADT_OK;
}

// Does the rank know all own vertices of the cell already? Without weights, it need not be asked then.
static int paradt_mpi__is_told(const paradt_mpi__work *w, int rank, const paradt_index *cell) {
    int i;
    if (w->weighted) return 0;
    for (i = 0; i <= w->set.space.dim; i++) {
        if ((size_t)cell[i] < w->set.count && !paradt_mpi__knows(w, rank, cell[i])) return 0;
    }
    return 1;
}

static int paradt_mpi__has_vertex_of(const paradt_mpi__work *w, int rank, const paradt_index *cell) {
    int i;
    for (i = 0; i <= w->set.space.dim; i++) {
        if (paradt_mpi__home_of(w, cell[i]).rank == rank) return 1;
    }
    return 0;
}

static int paradt_mpi__boxes_hit(const paradt_mpi__work *w, int rank) {
    const paradt_mpi__directory *d = &w->directory;
    const double *groups = d->groups + (size_t)rank * PARADT_MPI__GROUPS * d->width;
    int left;
    for (left = d->count[rank]; left > 0; left -= PARADT__LANES, groups += d->width) {
        unsigned valid = left < PARADT__LANES ? (1u << left) - 1 : 255u;
        if (paradt__remote_boxes(&w->search, groups) & valid) return 1;
    }
    return 0;
}

// Which ranks of a group of eight may have an answer to the question that the search is set to?
static unsigned paradt_mpi__ranks_hit(const paradt_mpi__work *w, int group) {
    return paradt__remote_boxes(&w->search, w->directory.ranks + (size_t)group * w->directory.width);
}

// Lists the question for such a rank, if it has to be asked.
static paradt_status paradt_mpi__ask_rank(paradt_mpi__work *w, paradt_mpi__questions *q, int rank,
                                          const paradt_index *cell, size_t place, int opposite) {
    if (paradt_mpi__is_told(w, rank, cell)) return PARADT_OK;
    // The first is for weights: without them such a rank was told all vertices.
    if ((opposite < 0 && paradt_mpi__has_vertex_of(w, rank, cell)) || paradt_mpi__boxes_hit(w, rank))
        return paradt_mpi__ask(w, q, rank, (paradt_index)place, opposite);
    return PARADT_OK;
}

// Lists it for all ranks that have to be asked.
static paradt_status paradt_mpi__ask_ranks(paradt_mpi__work *w, paradt_mpi__questions *q, const paradt_index *cell,
                                           size_t place, int opposite) {
    paradt_status status = PARADT_OK;
    int group, lane;
    for (group = 0; group * PARADT__LANES < w->ranks; group++) {
        unsigned mask = paradt_mpi__ranks_hit(w, group);
        for (lane = 0; lane < PARADT__LANES && !status; lane++) {
            int r = group * PARADT__LANES + lane;
            if (!(mask >> lane & 1) || r >= w->ranks || r == w->rank || !w->directory.count[r]) continue;
            status = paradt_mpi__ask_rank(w, q, r, cell, place, opposite);
        }
    }
    return status;
}

// A box that surely holds the sphere of a tetrahedron: low and high of each axis. 0: there is none to be had. With the
// edges a, b, c from one vertex, m the largest size of their components and u = 2^-52, the centre is N / (2 det) from
// there, N = |a|^2 b x c + ... Computed in any order, fused or not, det is wrong by less than 64 u m^3, N by less than
// 512 u m^4. Where |det| > 2^-20 m^3 the centre so is wrong by less than 2^-24 m and 2^-25 of its distance; 2^-20 of
// both, and 10^-15 of the coordinates, leave room for the rest.
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

static int paradt_mpi__is_within(const double *box, const double *room, int dim) {
    int j = 0;
    while (j < dim && box[2 * j] > room[2 * j] && box[2 * j + 1] < room[2 * j + 1]) j++;
    return j == dim;
}

// Lists in d->listeners a rank that may have points in the box and doesn't know all own vertices of the cell.
PARADT__INLINE void paradt_mpi__try_listener(paradt_mpi__work *w, int rank, const paradt_index *cell, const double *box,
                                             int *found) {
    if (rank != w->rank && paradt_mpi__may_have(w, rank, box) && !paradt_mpi__is_told(w, rank, cell))
        w->directory.listeners[(*found)++] = rank;
}

// Lists all such ranks. Of those in the vicinity few need be tried: the box has to reach beyond all sides that keep a
// rank's points from the own ones. Returns how many.
static int paradt_mpi__find_listeners(paradt_mpi__work *w, const paradt_index *cell, const double *box) {
    const paradt_mpi__directory *d = &w->directory;
    int found = 0, i;
    unsigned beyond = 0;
    if (!paradt_mpi__is_within(box, d->vicinity, w->set.space.dim)) {
        for (i = 0; i < w->ranks; i++) paradt_mpi__try_listener(w, i, cell, box, &found);
        return found;
    }
    for (i = 0; i < 2 * w->set.space.dim; i += 2)
        beyond |= (unsigned)(box[i] < d->own[i]) << i | (unsigned)(box[i + 1] > d->own[i + 1]) << (i + 1);
    for (i = 0; i < d->nearby_count; i++) {
        if (!(d->nearby[i].beyond & ~beyond)) paradt_mpi__try_listener(w, d->nearby[i].rank, cell, box, &found);
    }
    return found;
}

// Lists the questions about the sphere of a cell. *open: may a point that is not known here be in it?
static paradt_status paradt_mpi__look_at_sphere(paradt_mpi__work *w, paradt_mpi__questions *q, size_t place,
                                                const paradt_index *cell, const double **corners,
                                                const paradt_index *own, int count, int *open) {
    double box[6];
    int certain = w->search.plain3 && w->set.space.filtered && paradt_mpi__sphere_box3(corners, box), listeners = 0, i;
    paradt_status status = PARADT_OK;
    *open = !certain || !paradt_mpi__is_within(box, w->inside, 3);
    if (*open && certain) listeners = paradt_mpi__find_listeners(w, cell, box);
    if (!*open || (certain && !listeners)) return PARADT_OK;
    paradt__remote_cell(&w->search, corners, own);
    // With weights a point of another rank may be heavier than all own ones; so cells with such vertices count as open.
    *open = (w->weighted && count <= w->set.space.dim) || !paradt__remote_confined(&w->search, w->inside);
    if (*open && !certain) return paradt_mpi__ask_ranks(w, q, cell, place, -1);
    for (i = 0; i < listeners && *open && !status; i++) {
        int r = w->directory.listeners[i];
        if (paradt_mpi__ranks_hit(w, r / PARADT__LANES) >> r % PARADT__LANES & 1)
            status = paradt_mpi__ask_rank(w, q, r, cell, place, -1);
    }
    return status;
}

// Lists the questions for the sake of a place. *open: may a point that is not known here be in conflict with what is
// there, and does that matter?
PARADT__INLINE paradt_status paradt_mpi__look(paradt_mpi__work *w, paradt_mpi__questions *q, size_t k, size_t place,
                                              int *open) {
    const double *corners[PARADT_MAX_DIM + 1];
    paradt_index cell[PARADT_MAX_DIM + 1], own[PARADT_MAX_DIM + 1];
    unsigned topics = paradt_mpi__topics(w, k, &place);
    paradt_status status = PARADT_OK;
    int count, j;
    *open = 1;
    if (!topics) return PARADT_OK;
    paradt_mpi__cell(w, k, place, cell, corners);
    count = paradt_mpi__own_corners(w, k, cell, own);
    *open = count > 0;
    if (!count) return PARADT_OK;
    if (topics & PARADT_MPI__SPHERE) status = paradt_mpi__look_at_sphere(w, q, place, cell, corners, own, count, open);
    for (topics &= ~(unsigned)PARADT_MPI__SPHERE, j = 0; topics >> j && !status; j++) {
        if (!(topics >> j & 1) || count == (own[j] >= 0)) continue;
        paradt__remote_facet(&w->search, corners, own, j);
        status = paradt_mpi__ask_ranks(w, q, cell, place, j);
    }
    return status;
}

// Cells more than there are, for the sake of small sets: their questions take milliseconds at most.
enum { PARADT_MPI__PATIENCE = 100000 };

// Collective.
static void paradt_mpi__take_patience(paradt_mpi__work *w) {
    w->patience = paradt_mpi__sum(w, paradt_mpi__place_count(w)) + PARADT_MPI__PATIENCE;
}

// Does looking for answers take longer than building everything?
static int paradt_mpi__answers_too_long(const paradt_mpi__work *w) {
    const paradt__counters *c = &w->search.space.counters;
    return w->search.grid_cells_visited + c->insphere_calls + c->orient_calls > 2 * w->patience;
}

// Does each cell ask half of all ranks? Then the ranks need nearly all points.
static void paradt_mpi__limit_questions(paradt_mpi__work *w, paradt_mpi__questions *q) {
    if (q->count <= ((uint64_t)paradt_mpi__place_count(w) * (uint64_t)w->ranks + PARADT_MPI__PATIENCE) / 2) return;
    w->stuck = 1;
    q->count = 0;
}

// Puts a place on the list unless it was there already.
static paradt_status paradt_mpi__wait(paradt_mpi__work *w, paradt_mpi__places *list, size_t place) {
    void *items;
    if (!paradt__remote_engine_mark(&w->engine, place)) return PARADT_OK;
    items = paradt_mpi__one_more(w, list->items, list->count, &list->capacity, sizeof *list->items);
    if (!items) return PARADT_ERROR_MEMORY;
    list->items = (size_t *)items;
    list->items[list->count++] = place;
    return PARADT_OK;
}

// Is there an own vertex of a cell that the rank of another vertex was not told of first? Most cells' other vertices
// are of one rank, which was told long before: that is found out without branches. k: vertices, not all of them own.
PARADT__INLINE int paradt_mpi__may_tell(const paradt_mpi__work *w, size_t k, const paradt_index *cell) {
    paradt_index own = (paradt_index)w->set.count;
    int lowest = INT_MAX, highest = -1, news = 0;
    size_t j;
    for (j = 0; j < k; j++) {
        int other = cell[j] >= own, rank = w->home[other ? cell[j] - own : 0].rank;
        lowest = other && rank < lowest ? rank : lowest;
        highest = other && rank > highest ? rank : highest;
    }
    for (j = 0; j < k; j++) news |= (cell[j] < own) & (w->audience[cell[j] < own ? cell[j] : 0] != lowest);
    return news | (lowest < highest);
}

// What paradt_mpi__tell_vertices does where there may be something to tell.
PARADT__NOINLINE paradt_status paradt_mpi__list_told(paradt_mpi__work *w, paradt_mpi__list *list, size_t k,
                                                     const paradt_index *cell) {
    const paradt_index *end = cell + k, *v, *u;
    paradt_index own = (paradt_index)w->set.count;
    int rank = w->rank;
    paradt_status status = PARADT_OK;
    for (v = cell; v < end; v++) {
        if (*v < own || w->home[*v - own].rank == rank) continue; // own, or told already
        rank = w->home[*v - own].rank;
        for (u = cell; u < end && !status; u++) {
            if (*u < own && w->audience[*u] != rank) status = paradt_mpi__list_news(w, list, rank, *u);
        }
    }
    return status;
}

// Lists the own vertices of a cell of k vertices, no ghost, for the ranks of its other vertices. With weights cells are
// asked about instead, for the sake of points that are hidden.
PARADT__INLINE paradt_status paradt_mpi__tell_vertices(paradt_mpi__work *w, paradt_mpi__list *list, size_t k,
                                                       const paradt_index *cell) {
    if (w->weighted || !paradt__vertices_among(cell, (int)k, 0, PARADT__NOWHERE) ||
        paradt__vertices_among(cell, (int)k, 0, (paradt_index)w->set.count) || !paradt_mpi__may_tell(w, k, cell))
        return PARADT_OK;
    return paradt_mpi__list_told(w, list, k, cell);
}

// Marks the points of others that are not inside the room that this rank knows. With weights it marks all: a cell with
// one of them for a vertex may be in conflict with a point far from its sphere then, if that is heavy. The array has
// one place more, so that it has one.
static unsigned char *paradt_mpi__mark_far(paradt_mpi__work *w) {
    size_t others = w->known - w->set.count, i;
    unsigned char *outer = (unsigned char *)paradt__alloc(&w->memory, others + 1, 1);
    for (i = 0; outer && i < others; i++) {
        const double *x = paradt__record(&w->set, (paradt_index)(w->set.count + i));
        int j = 0;
        while (j < w->set.space.dim && x[j] > w->inside[2 * j] && x[j] < w->inside[2 * j + 1]) j++;
        outer[i] = w->weighted || j < w->set.space.dim;
    }
    return outer;
}

// Fetches what is looked at next: what is at the places first, then what that leads to.
PARADT__INLINE void paradt_mpi__fetch_ahead(const paradt_mpi__work *w, size_t k, const paradt_mpi__places *list,
                                            size_t at) {
    enum { SOON = 4, LATER = 8 };
    if (at + LATER < list->count) paradt__remote_engine_fetch(&w->engine, k, list->items[at + LATER]);
    if (at + SOON < list->count) paradt__remote_engine_fetch_around(&w->engine, k, list->items[at + SOON]);
}

// Lists the fringe, and of what has own vertices in it the places of suspects; tells of vertices. k: of a cell.
PARADT__INLINE paradt_status paradt_mpi__list_fringe(paradt_mpi__work *w, paradt_mpi__questions *q, size_t k,
                                                     paradt_mpi__places *suspects, const unsigned char *outer) {
    const paradt__cells *cells = &w->engine.bw.cells;
    paradt_index own = (paradt_index)w->set.count;
    paradt_status status = PARADT_OK;
    size_t at = 0;
    for (paradt__remote_engine_relist(&w->engine); !status; at++) {
        const paradt_index *cell;
        int share;
        status = paradt__remote_engine_list(&w->engine, own, &at);
        if (status || at == cells->count) break;
        cell = cells->vertices + at * k;
        share = paradt__vertices_below(cell, k, own);
        if (!share) continue;
        status = paradt_mpi__tell_vertices(w, &q->to_tell, k, cell);
        if (!status && paradt__remote_is_suspect(cell, k, own, share, outer))
            status = paradt_mpi__wait(w, suspects, at);
    }
    return status;
}

// Lists the questions while points are inserted, when not all cells need be looked at. What is in conflict with a point
// p that is not known here is connected through facets. Where it has own vertices, some of it is a ghost or a cell with
// a vertex that is far, or just one that is own, by the reasons given in >>patches of paradt.h: this rank's box and the
// room make a convex set, and p is not in it. Such suspects are looked at first, then what is reached from them through
// cells whose spheres are not inside of the room: no sphere in conflict with p is, and with weights cells with others'
// vertices never count as such. What has no own vertex does not matter.
PARADT__INLINE paradt_status paradt_mpi__look_along(paradt_mpi__work *w, paradt_mpi__questions *q, size_t k,
                                                    paradt_mpi__places *list, const unsigned char *outer) {
    paradt_status status = paradt_mpi__list_fringe(w, q, k, list, outer);
    size_t at, j;
    int open;
    for (at = 0; at < list->count && !status && !w->stuck; at++) {
        paradt_mpi__fetch_ahead(w, k, list, at);
        status = paradt_mpi__look(w, q, k, list->items[at], &open);
        paradt_mpi__limit_questions(w, q);
        for (j = 0; j < k && open && !status; j++)
            status = paradt_mpi__wait(w, list, paradt__remote_engine_across(&w->engine, k, list->items[at], j));
    }
    return status;
}

// The same, with the marks for it made and taken away again.
static paradt_status paradt_mpi__collect_from_seam(paradt_mpi__work *w, paradt_mpi__questions *q) {
    unsigned char *outer = paradt_mpi__mark_far(w);
    paradt_mpi__places list;
    paradt_status status;
    size_t at;
    memset(&list, 0, sizeof list);
    if (!outer) status = PARADT_ERROR_MEMORY;
    else if (w->set.space.dim == 3) status = paradt_mpi__look_along(w, q, 4, &list, outer);
    else status = paradt_mpi__look_along(w, q, (size_t)w->set.space.dim + 1, &list, outer);
    for (at = 0; at < list.count; at++) paradt__remote_engine_unmark(&w->engine, list.items[at]);
    paradt__release(&w->memory, list.items);
    paradt__release(&w->memory, outer);
    return status;
}

// Lists all questions: about cells around own points, and their facets on the hull.
static paradt_status paradt_mpi__collect(paradt_mpi__work *w, paradt_mpi__questions *q) {
    size_t count = w->ready ? paradt_mpi__place_count(w) : 0, k = (size_t)w->set.space.dim + 1, place;
    paradt_status status = PARADT_OK;
    int open;
    if (w->inserting) return paradt_mpi__collect_from_seam(w, q);
    for (place = 0; place < count && !status; place++)
        status = paradt_mpi__tell_vertices(w, &q->to_tell, k, w->local.cells + place * k);
    for (place = 0; place < count && !status && !w->stuck; place++) {
        status = paradt_mpi__look(w, q, k, place, &open);
        paradt_mpi__limit_questions(w, q);
    }
    return status;
}

// The questions in the order of ranks, counted in w->to.
static paradt_status paradt_mpi__sort_questions(paradt_mpi__work *w, paradt_mpi__questions *q) {
    paradt_mpi__question *sorted = (paradt_mpi__question *)paradt__alloc(&w->memory, q->count, sizeof *sorted);
    size_t i;
    if (!sorted) return PARADT_ERROR_MEMORY;
    memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
    for (i = 0; i < q->count; i++) w->to[q->items[i].rank]++;
    paradt_mpi__begin_sorting(w);
    for (i = 0; i < q->count; i++) sorted[w->next[q->items[i].rank]++] = q->items[i];
    paradt__release(&w->memory, q->items);
    q->items = sorted;
    q->capacity = q->count;
    return PARADT_OK;
}

// What the questions to all ranks, or those from them, look like on the wire: the vertices, each once a rank; and for
// each cell dim + 1 positions among the vertices of the same rank, and the vertex opposite its facet or -1.
typedef struct paradt_mpi__mail {
    double *points;
    int32_t *cells;
    size_t *point_count; // [ranks]
    size_t *cell_count;  // [ranks]
} paradt_mpi__mail;

// Packs the questions to rank r. place: [known], of each point that r is sent its position; reset at the end. Returns
// how many points.
static size_t paradt_mpi__pack_for(paradt_mpi__work *w, const paradt_mpi__question *q, size_t count, int r,
                                   int32_t *place, double *points, int32_t *cells) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), used = 0, i, j;
    paradt_index cell[PARADT_MAX_DIM + 1];
    const double *corners[PARADT_MAX_DIM + 1];
    for (i = 0; i < count; i++) {
        paradt_mpi__cell(w, k, (size_t)q[i].cell, cell, corners);
        for (j = 0; j < k; j++) {
            const paradt_mpi__home home = paradt_mpi__home_of(w, cell[j]);
            if (place[cell[j]] < 0) {
                double *wire = points + used * width;
                int64_t role = home.rank == r         ? (int64_t)home.place
                               : home.rank == w->rank ? PARADT_MPI__STRANGER - 1 - (int64_t)home.place
                                                      : (int64_t)PARADT_MPI__STRANGER;
                paradt_mpi__put_wire(w, wire, cell[j]);
                paradt_mpi__put_bits(wire + w->set.width + 1, (uint64_t)role);
                place[cell[j]] = (int32_t)used++;
            }
            *cells++ = place[cell[j]];
        }
        *cells++ = q[i].opposite;
    }
    for (i = 0; i < count; i++) {
        paradt_mpi__cell(w, k, (size_t)q[i].cell, cell, corners);
        for (j = 0; j < k; j++) place[cell[j]] = -1;
    }
    return used;
}

static void paradt_mpi__mail_free(paradt_mpi__work *w, paradt_mpi__mail *mail) {
    paradt__release(&w->memory, mail->points);
    paradt__release(&w->memory, mail->cells);
    paradt__release(&w->memory, mail->point_count);
    paradt__release(&w->memory, mail->cell_count);
    memset(mail, 0, sizeof *mail);
}

// Packs the sorted questions; not collective.
static paradt_status paradt_mpi__pack(paradt_mpi__work *w, const paradt_mpi__questions *q, paradt_mpi__mail *mail) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), ranks = (size_t)w->ranks;
    size_t i, points = 0, cells = 0, room = 0;
    int32_t *place;
    int r;
    for (r = 0; r < w->ranks; r++) {
        size_t most = w->to[r] * k < w->known ? w->to[r] * k : w->known;
        if (most > (size_t)INT32_MAX) return PARADT_ERROR_TOO_LARGE; // for their positions on the wire
        room += most;
    }
    place = (int32_t *)paradt__alloc(&w->memory, w->known, sizeof *place);
    mail->points = (double *)paradt__alloc(&w->memory, room, width * sizeof *mail->points);
    mail->cells = (int32_t *)paradt__alloc(&w->memory, q->count, (k + 1) * sizeof *mail->cells);
    mail->point_count = (size_t *)paradt__alloc(&w->memory, ranks, sizeof *mail->point_count);
    mail->cell_count = (size_t *)paradt__alloc(&w->memory, ranks, sizeof *mail->cell_count);
    if (place && mail->points && mail->cells && mail->point_count && mail->cell_count) {
        for (i = 0; i < w->known; i++) place[i] = -1;
        for (r = 0; r < w->ranks; r++) {
            mail->cell_count[r] = w->to[r];
            mail->point_count[r] = paradt_mpi__pack_for(w, q->items + cells, w->to[r], r, place,
                                                        mail->points + points * width, mail->cells + cells * (k + 1));
            cells += w->to[r];
            points += mail->point_count[r];
        }
    }
    i = place && mail->points && mail->cells && mail->point_count && mail->cell_count;
    paradt__release(&w->memory, place);
    return i ? PARADT_OK : PARADT_ERROR_MEMORY;
}

// Exchanges the questions: *mail becomes those for this rank.
static paradt_status paradt_mpi__post(paradt_mpi__work *w, paradt_status status, paradt_mpi__mail *mail) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), bytes, count;
    size_t counts = (size_t)w->ranks * sizeof *w->to;
    void *points = NULL, *cells = NULL;
    bytes = width * sizeof *mail->points;
    if (!status) memcpy(w->to, mail->point_count, counts);
    status = paradt_mpi__exchange(w, status, mail->points, bytes, &points, &count);
    if (!status) {
        memcpy(w->to, mail->cell_count, counts);
        memcpy(mail->point_count, w->from, counts);
    }
    paradt__release(&w->memory, mail->points);
    mail->points = (double *)points;
    if (!status) status = paradt_mpi__exchange(w, status, mail->cells, (k + 1) * sizeof *mail->cells, &cells, &count);
    if (!status) memcpy(mail->cell_count, w->from, counts);
    paradt__release(&w->memory, mail->cells);
    mail->cells = (int32_t *)cells;
    return status;
}

// Is an own point in conflict with the cell, or beyond its facet? Which one: *found; PARADT__OPEN: an own point is a
// vertex, so that the cell matters in any case.
static int paradt_mpi__matters(paradt_mpi__work *w, const double *points, const int32_t *cell, paradt_index *found) {
    size_t width = paradt_mpi__wire_width(w);
    const double *corners[PARADT_MAX_DIM + 1];
    paradt_index own[PARADT_MAX_DIM + 1];
    int dim = w->set.space.dim, i, shared = 0;
    for (i = 0; i <= dim; i++) {
        int64_t role = (int64_t)paradt_mpi__bits_at(points + (size_t)cell[i] * width + w->set.width + 1);
        corners[i] = points + (size_t)cell[i] * width;
        own[i] = role >= 0 ? (paradt_index)role : (paradt_index)PARADT__OPEN;
        shared |= role >= 0;
    }
    *found = PARADT__OPEN;
    if (cell[dim + 1] < 0) paradt__remote_cell(&w->search, corners, own);
    else paradt__remote_facet(&w->search, corners, own, cell[dim + 1]);
    *found = paradt__remote_any(&w->search);
    return shared || *found >= 0;
}

// Answers the questions of rank r: keeps vertices of cells that matter, and lists what is to be answered. There is room
// for all the points. Returns how many were not known.
static size_t paradt_mpi__answer_rank(paradt_mpi__work *w, int r, double *points, const int32_t *cells, size_t count,
                                      paradt_mpi__list *answers, paradt_status *status) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), i, j, news = 0;
    for (i = 0; i < count && !w->stuck; i++, cells += k + 1) {
        paradt_index found;
        w->stuck = paradt_mpi__answers_too_long(w);
        if (!paradt_mpi__matters(w, points, cells, &found)) continue;
        if (found >= 0 && w->weighted && !*status) *status = paradt_mpi__list_add(w, answers, r, found);
        for (j = 0; j < k; j++) {
            double *wire = points + (size_t)cells[j] * width, *role = wire + w->set.width + 1;
            int64_t value = (int64_t)paradt_mpi__bits_at(role);
            if (value >= PARADT_MPI__STRANGER) continue;
            paradt_mpi__put_bits(role, (uint64_t)(PARADT_MPI__STRANGER - 1 - value));
            news += paradt_mpi__add_other(w, r, wire);
            paradt_mpi__put_bits(role, (uint64_t)(int64_t)PARADT_MPI__STRANGER);
        }
    }
    return news;
}

static paradt_status paradt_mpi__answer(paradt_mpi__work *w, paradt_mpi__mail *mail, paradt_mpi__list *answers,
                                        size_t *news) {
    size_t k = (size_t)w->set.space.dim + 1, width = paradt_mpi__wire_width(w), points = 0, cells = 0;
    paradt_status status;
    int r;
    for (r = 0; r < w->ranks; r++) points += mail->point_count[r];
    status = paradt_mpi__make_room(w, points);
    if (!status) status = paradt_mpi__table_room(w, &w->others, points);
    points = *news = 0;
    for (r = 0; r < w->ranks && !status && w->ready; r++) {
        *news += paradt_mpi__answer_rank(w, r, mail->points + points * width, mail->cells + cells * (k + 1),
                                         mail->cell_count[r], answers, &status);
        points += mail->point_count[r];
        cells += mail->cell_count[r];
    }
    return status;
}

// One round of questions and answers. *news: how many points of others this rank learned.
static paradt_status paradt_mpi__round(paradt_mpi__work *w, paradt_status status, size_t *news) {
    paradt_mpi__questions questions;
    paradt_mpi__mail mail;
    paradt_mpi__list answers;
    size_t told = 0, answered = 0;
    double begun = paradt__now();
    memset(&questions, 0, sizeof questions);
    memset(&mail, 0, sizeof mail);
    memset(&answers, 0, sizeof answers);
    *news = 0;
    if (!status) status = paradt_mpi__collect(w, &questions);
    w->stats.cells_asked += questions.count;
    w->stats.rounds++;
    status = paradt_mpi__agree(w, paradt_mpi__learn(w, status, &questions.to_tell, &told));
    paradt__release(&w->memory, questions.to_tell.items);
    paradt_mpi__take_patience(w);
    if (!status) status = paradt_mpi__sort_questions(w, &questions);
    if (!status) status = paradt_mpi__pack(w, &questions, &mail);
    paradt__release(&w->memory, questions.items);
    status = paradt_mpi__post(w, status, &mail);
    if (!status) status = paradt_mpi__answer(w, &mail, &answers, news);
    paradt_mpi__mail_free(w, &mail);
    status = paradt_mpi__agree(w, status);
    if (!status && w->weighted) status = paradt_mpi__agree(w, paradt_mpi__learn(w, status, &answers, &answered));
    *news += told + answered;
    w->stats.points_asked += *news;
    paradt__release(&w->memory, answers.items);
    w->stats.seconds_ask += paradt__now() - begun;
    return status;
}

// Where a rank is stuck: all points come to all ranks, to be triangulated from the beginning.
static paradt_status paradt_mpi__share_all(paradt_mpi__work *w, size_t *news) {
    paradt_mpi__list list;
    paradt_status status = PARADT_OK;
    size_t i;
    int r;
    memset(&list, 0, sizeof list);
    for (r = 0; r < w->ranks && !status; r++) {
        if (r == w->rank || !w->directory.count[r]) continue;
        for (i = 0; i < w->set.count && !status; i++) status = paradt_mpi__list_add(w, &list, r, (paradt_index)i);
    }
    status = paradt_mpi__agree(w, paradt_mpi__learn(w, status, &list, news));
    w->stats.points_asked += *news;
    paradt__release(&w->memory, list.items);
    if (w->inserting) paradt__remote_engine_free(&w->engine, &w->memory);
    w->inserting = 0;
    return status;
}

// Triangulates until the cells around own points are final. What ranks do between two exchanges they do at once, so
// that they wait for the slowest once: the status that is returned is that of this rank alone.
static paradt_status paradt_mpi__rounds(paradt_mpi__work *w) {
    uint64_t news_of_all = 1;
    size_t news;
    paradt_status status;
    w->progress_length = 0.9;
    status = paradt_mpi__triangulate_known(w);
    while (w->set.space.dim > 0 && w->ranks > 1 && news_of_all) {
        status = paradt_mpi__round(w, status, &news);
        if (status) break;
        w->stuck = paradt_mpi__sum(w, (uint64_t)w->stuck) > 0;
        if (w->stuck) status = paradt_mpi__share_all(w, &news);
        if (status) break;
        news_of_all = w->weighted && !w->stuck ? paradt_mpi__sum(w, news) : 0;
        w->progress_begin += w->progress_length;
        w->progress_length = 0.9 * (1.0 - w->progress_begin);
        if (news || w->stuck) status = paradt_mpi__triangulate_known(w);
    }
    if (!status && w->inserting && (w->ranks == 1 || w->stuck)) // else the fringe was listed for the questions
        status = paradt__remote_engine_list_all(&w->engine, (paradt_index)w->set.count);
    if (!status && w->inserting) paradt__remote_engine_rest(&w->engine, &w->memory);
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>result
//
// From the last local triangulation to the arrays that are handed out: the own cells get numbers that run through all
// ranks; a facet whose other cell is not an own one is sent, with the ids of its vertices, to the rank where one of
// them, which their hashes choose, is at home. There it meets its twin; one that meets none is on the hull.
// Representatives that are not the point itself are sent to the rank that handed the point in. Doors:
// paradt_mpi__deliver.

typedef struct paradt_mpi__facets { // that look for the cell on their other side
    size_t count;
    size_t width;    // words: the ids of the vertices in ascending order, the number of the cell
    uint64_t *rows;  // [count][width], in the order of the ranks they are sent to
    size_t *handles; // [count] place in the neighbors, in the order of the rows when there are any
    size_t capacity; // of handles
    int *home;       // [vertex_count - vertex_own] the ranks where others' vertices are at home
} paradt_mpi__facets;

static int paradt_mpi__facet_add(paradt_mpi__work *w, paradt_mpi__facets *f, size_t handle) {
    void *items = paradt_mpi__one_more(w, f->handles, f->count, &f->capacity, sizeof *f->handles);
    if (!items) return 0;
    f->handles = (size_t *)items;
    f->handles[f->count++] = handle;
    return 1;
}

// Is a cell of k vertices an own one? Replicated, others' cells are not among them. mark: see paradt__remote_owns.
PARADT__INLINE int paradt_mpi__owns(const paradt_mpi__work *w, size_t k, const paradt_index *cell,
                                    const paradt_index *mark) {
    paradt_index own = (paradt_index)w->set.count;
    if (PARADT__LIKELY(paradt__vertices_among(cell, (int)k, 0, own))) return 1;
    return w->options.flags & PARADT_MPI_REPLICATED || paradt__remote_owns(cell, k, own, mark);
}

// In the neighbours of a cell, if it is one, the number of a cell becomes another. It is there once; where cannot be
// foreseen, so there is no branch.
PARADT__INLINE void paradt_mpi__rename_across(paradt_index *neighbors, size_t k, paradt_index cell, paradt_index was,
                                              paradt_index is) {
    paradt_index *links;
    size_t j;
    if (cell < 0) return;
    links = neighbors + (size_t)cell * k;
    for (j = 0; j < k; j++) links[j] = links[j] == was ? is : links[j];
}

// Takes an other's cell out. mark: see paradt_mpi__keep_own.
PARADT__INLINE void paradt_mpi__drop_cell(paradt_mpi__work *w, size_t k, size_t c, paradt_index *mark) {
    size_t j;
    for (j = c * k; j < (c + 1) * k; j++) {
        mark[w->local.cells[j]] |= PARADT__VERTEX;
        paradt_mpi__rename_across(w->local.neighbors, k, w->local.neighbors[j], (paradt_index)c, PARADT__OPEN);
    }
}

PARADT__INLINE void paradt_mpi__move_cell(paradt_mpi__work *w, size_t k, size_t from, size_t to) {
    size_t j;
    paradt_index *neighbors = w->local.neighbors;
    memcpy(w->local.cells + to * k, w->local.cells + from * k, k * sizeof *neighbors);
    memcpy(neighbors + to * k, neighbors + from * k, k * sizeof *neighbors);
    for (j = to * k; j < (to + 1) * k; j++)
        paradt_mpi__rename_across(neighbors, k, neighbors[j], (paradt_index)from, (paradt_index)to);
}

// Drops others' cells of k vertices, and fills the gaps that they leave from the end, so that nearly all cells keep
// their numbers. mark: [known], gets what the cells make of each point; says before which are a later rank's. Returns
// how many are left.
PARADT__INLINE size_t paradt_mpi__keep_own(paradt_mpi__work *w, size_t k, paradt_index *mark) {
    size_t end = w->local.cell_count, c;
    const paradt_index *cells = w->local.cells;
    for (c = 0; c < end; c++) {
        paradt__fetch_row(cells, w->local.neighbors, c + PARADT__ROWS_AHEAD, k);
        if (!PARADT__LIKELY(paradt_mpi__owns(w, k, cells + c * k, mark))) {
            paradt_mpi__drop_cell(w, k, c, mark);
            for (end--; end > c && !paradt_mpi__owns(w, k, cells + end * k, mark); end--)
                paradt_mpi__drop_cell(w, k, end, mark);
            if (end == c) break;
            paradt_mpi__move_cell(w, k, end, c);
        }
        paradt__mark_vertices(mark, cells + c * k, k, PARADT__VERTEX | PARADT__OF_OWN_CELL);
    }
    return end;
}

// Leaves the own cells in w->local, and in mark, [known], what all cells make of each point. Not collective.
static void paradt_mpi__take_own(paradt_mpi__work *w, paradt_index *mark) {
    size_t k = (size_t)w->out->dim + 1, made = w->local.cell_count, own = w->set.count, i;
    paradt__cells cells;
    for (i = own; i < w->known; i++)
        mark[i] = w->home[i - own].rank > w->rank ? PARADT__OF_LATER_RANK : PARADT__NO_VERTEX;
    if (!w->inserting) {
        for (i = 0; i < own; i++) mark[i] = PARADT__NO_VERTEX;
        w->local.cell_count = k == 4 ? paradt_mpi__keep_own(w, 4, mark) : paradt_mpi__keep_own(w, k, mark);
        w->stats.cells_recomputed += made - w->local.cell_count;
        return;
    }
    w->inserting = 0;
    w->handles = 1;
    w->stats.cells_recomputed += paradt__remote_engine_end(&w->engine, &w->set, &w->memory, &cells, mark);
    w->local.dim = w->set.space.dim;
    w->local.cell_count = cells.count;
    w->local.cells = cells.vertices;
    w->local.neighbors = cells.neighbors;
}

// Numbers the own cells of all ranks.
static void paradt_mpi__number_cells(paradt_mpi__work *w) {
    uint64_t mine = w->out->cell_count, before = 0;
    MPI_Exscan(&mine, &before, 1, MPI_UINT64_T, MPI_SUM, w->comm);
    w->out->first_cell = w->rank ? before : 0;
    w->out->cell_total = paradt_mpi__sum(w, mine);
    w->stats.cells = mine;
}

// Lists the facets of a cell that no own cell is behind: another rank's is, or the hull.
PARADT__NOINLINE paradt_status paradt_mpi__close_open(paradt_mpi__work *w, size_t k, size_t c, paradt_mpi__facets *f) {
    paradt_index *neighbors = w->out->neighbors;
    int final = k == 1 || w->options.flags & PARADT_MPI_REPLICATED; // the hull is that of all points
    size_t j;
    for (j = c * k; j < (c + 1) * k; j++) {
        if (neighbors[j] == PARADT__HULL && !final) neighbors[j] = PARADT__OPEN;
        w->stats.hull_facets += neighbors[j] == PARADT__HULL && k > 1;
        if (neighbors[j] == PARADT__OPEN && !paradt_mpi__facet_add(w, f, j)) return PARADT_ERROR_MEMORY;
    }
    return PARADT_OK;
}

// Numbers the vertices of all own cells, of k each, and their neighbours where these are handles; lists their facets
// whose other side is not known, or the hull. own: the cells; a copy, which nothing that is written can change.
PARADT__INLINE paradt_status paradt_mpi__number_rows(paradt_mpi__work *w, const paradt__cells own, size_t k,
                                                     const paradt_index *number, paradt_mpi__facets *f) {
    const paradt__rows in_place = paradt__rows_in_place(&own);
    const int handles = w->handles;
    paradt_status status = PARADT_OK;
    size_t c, j;
    for (c = 0; c < own.count && !status; c++) {
        paradt_index *vertices = own.vertices + c * k;
        int open;
        if (handles) {
            open = paradt__bw_number(&own, c, k, number, &in_place);
        } else {
            paradt__fetch_row(own.vertices, own.neighbors, c + PARADT__ROWS_AHEAD, k);
            for (j = 0; j < k; j++) vertices[j] = number[vertices[j]];
            open = own.neighbors && !paradt__vertices_among(own.neighbors + c * k, (int)k, 0, PARADT__NOWHERE);
        }
        if (!PARADT__LIKELY(!open) && w->out->neighbors) status = paradt_mpi__close_open(w, k, c, f);
    }
    return status;
}

// The own cells become those of the result. Not collective.
static paradt_status paradt_mpi__close_cells(paradt_mpi__work *w, const paradt_index *number, paradt_mpi__facets *f) {
    size_t k = (size_t)w->out->dim + 1;
    paradt__cells own;
    memset(&own, 0, sizeof own);
    own.count = w->out->cell_count;
    own.vertices = w->out->cells = w->local.cells;
    own.neighbors = w->local.neighbors;
    w->local.cells = NULL;
    if (!(w->options.local.flags & PARADT_NO_NEIGHBORS)) {
        w->out->neighbors = w->local.neighbors;
        w->local.neighbors = NULL;
    }
    return k == 4 ? paradt_mpi__number_rows(w, own, 4, number, f) : paradt_mpi__number_rows(w, own, k, number, f);
}

// The row of a facet of a cell of k vertices: returns the rank that it is sent to.
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
    row[count] = w->out->first_cell + handle / k;
    return chosen < own ? w->rank : f->home[chosen - own];
}

// The rows of all facets, and the ranks that they are sent to. The facets are in the order of their cells, which are
// here and there.
PARADT__INLINE void paradt_mpi__facet_rows(const paradt_mpi__work *w, size_t k, const paradt_mpi__facets *f,
                                           uint64_t *rows, int *rank) {
    enum { AHEAD = 16 };
    size_t i;
    for (i = 0; i < f->count; i++) {
        if (i + AHEAD < f->count) PARADT__PREFETCH(w->out->cells + f->handles[i + AHEAD]);
        rank[i] = paradt_mpi__facet_row(w, k, f, f->handles[i], rows + i * k);
    }
}

// The rows of the facets, and these in the order of ranks; fills w->to. Not collective.
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
        paradt_mpi__begin_sorting(w);
        for (i = 0; i < f->count; i++) {
            size_t place = w->next[rank[i]]++;
            handles[place] = unsorted[i];
            memcpy(f->rows + place * width, rows + i * width, width * sizeof *rows);
        }
        f->handles = handles;
        handles = unsorted;
        status = PARADT_OK;
    }
    paradt__release(&w->memory, handles);
    paradt__release(&w->memory, rows);
    paradt__release(&w->memory, rank);
    paradt__release(&w->memory, f->home);
    f->home = NULL;
    return status;
}

// The facets that met here: twins[i] gets the number of the cell that row i has on its other side, or PARADT__HULL.
static paradt_status paradt_mpi__match(paradt_mpi__work *w, const uint64_t *rows, size_t count, size_t width,
                                       int64_t *twins) {
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
        twins[i] = PARADT__HULL;
        for (slot = (size_t)paradt__mix(h) & (slots - 1); table[slot] != SIZE_MAX; slot = (slot + 1) & (slots - 1)) {
            const uint64_t *other = rows + table[slot] * width;
            if (memcmp(other, row, bytes)) continue;
            twins[i] = (int64_t)other[width - 1];
            twins[table[slot]] = (int64_t)row[width - 1];
            break;
        }
        if (twins[i] < 0) table[slot] = i;
    }
    paradt__release(&w->memory, table);
    return PARADT_OK;
}

// The answers are what lies across the facets, or PARADT__HULL; they become the table of others' cells. Not collective.
static void paradt_mpi__set_across(paradt_mpi__work *w, int64_t *answers, const paradt_mpi__facets *f) {
    paradt_mpi_triangulation *out = w->out;
    size_t i;
    out->others = answers;
    for (i = 0; i < f->count; i++) {
        paradt_index *neighbor = &out->neighbors[f->handles[i]];
        if (answers[i] == PARADT__HULL) {
            *neighbor = PARADT__HULL;
            w->stats.hull_facets++;
        } else {
            *neighbor = (paradt_index)(out->cell_count + out->other_count);
            out->others[out->other_count++] = answers[i];
        }
    }
}

// Finds the neighbours on other ranks.
static paradt_status paradt_mpi__link(paradt_mpi__work *w, paradt_mpi__facets *f) {
    void *rows = NULL, *answers = NULL;
    int64_t *twins = NULL;
    size_t count = 0, back;
    paradt_status status = PARADT_OK;
    if (f->count > (size_t)PARADT__NOWHERE - w->out->cell_count) status = PARADT_ERROR_TOO_LARGE;
    if (!status) status = paradt_mpi__sort_facets(w, f);
    status = paradt_mpi__exchange(w, status, f->rows, f->width * sizeof *f->rows, &rows, &count);
    if (!status) {
        twins = (int64_t *)paradt__alloc(&w->memory, count, sizeof *twins);
        status = twins ? paradt_mpi__match(w, (const uint64_t *)rows, count, f->width, twins) : PARADT_ERROR_MEMORY;
        memcpy(w->to, w->from, (size_t)w->ranks * sizeof *w->to); // the answers go back where the rows came from
        status = paradt_mpi__exchange(w, status, twins, sizeof *twins, &answers, &back);
    }
    if (!status) paradt_mpi__set_across(w, (int64_t *)answers, f);
    else paradt__release(&w->memory, answers);
    paradt__release(&w->memory, twins);
    paradt__release(&w->memory, rows);
    return status;
}

// Room for the coordinates of so many vertices: that of the records, where it is not much larger. Not collective.
static paradt_status paradt_mpi__place_coordinates(paradt_mpi__work *w, size_t count) {
    size_t ambient = (size_t)w->dim;
    if (w->set.records && w->room * w->set.width <= count * ambient + count) {
        w->out->coordinates = w->set.records;
        w->set.records = NULL;
    } else {
        w->out->coordinates = (double *)paradt__alloc(&w->memory, count, ambient * sizeof(double));
    }
    return w->out->coordinates ? PARADT_OK : PARADT_ERROR_MEMORY;
}

// The table of vertices, and where others' are at home. number: [known], the marks of the points; becomes their places
// in it. Not collective.
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
    out->vertex_count = count;
    out->vertices = (int64_t *)paradt__alloc_filled(&w->memory, count, sizeof *out->vertices);
    f->home = (int *)paradt__alloc(&w->memory, count - out->vertex_own, sizeof *f->home);
    status = out->vertices && f->home ? paradt_mpi__place_coordinates(w, count) : PARADT_ERROR_MEMORY;
    for (i = 0; i < w->known && !status; i++) {
        double *to, x[PARADT_MAX_DIM];
        paradt_mpi__home home;
        if (i + PARADT__POINTS_AHEAD < w->set.count) // the ids are in the order that the points came in
            PARADT__FETCH(w->received, w->set.origin[i + PARADT__POINTS_AHEAD]);
        if (number[i] < 0) continue;
        to = out->coordinates + (size_t)number[i] * ambient;
        home = paradt_mpi__home_of(w, (paradt_index)i);
        out->vertices[number[i]] = (int64_t)home.id;
        if (i >= w->set.count) f->home[(size_t)number[i] - out->vertex_own] = home.rank;
        memcpy(x, records + i * w->set.width, ambient * sizeof *x);
        for (axis = 0; axis < w->dim; axis++)
            to[w->set.axes[axis]] = w->shift ? paradt__scale(x[axis], -w->shift, &exact) : x[axis];
    }
    return status;
}

// The rank that handed in a point.
static int paradt_mpi__origin_of(const paradt_mpi__work *w, uint64_t id) {
    int low = 0, high = w->ranks;
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (w->first[middle] <= id) low = middle;
        else high = middle;
    }
    return low;
}

// What is not represented by itself: rows of two ids, the point's and its representative's, in the order of ranks;
// fills w->to. A point of this rank's box is a vertex of T(P) if it is one of the last local triangulation. mark:
// [known]; used: [received_count]; twin, received: of the points of this rank's box. Not collective.
static paradt_status paradt_mpi__list_exceptions(paradt_mpi__work *w, const paradt_index *mark, uint8_t *used,
                                                 int64_t **rows) {
    size_t i, count = 0, pass;
    memset(used, 0, w->received_count);
    for (i = 0; i < w->set.count; i++) used[w->set.origin[i]] = mark[i] != PARADT__NO_VERTEX;
    memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
    for (pass = 0; pass < 2; pass++) {
        for (i = 0; i < w->received_count; i++) { // ids ascend, and so do the ranks
            size_t twin = (size_t)w->twin[i];
            if (twin == i && used[twin]) continue;
            if (pass) {
                (*rows)[2 * count] = (int64_t)w->received[i];
                (*rows)[2 * count + 1] = used[twin] ? (int64_t)w->received[twin] : -1;
            } else {
                w->to[paradt_mpi__origin_of(w, w->received[i])]++;
                w->stats.hidden += twin == i;
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

static paradt_status paradt_mpi__exceptions(paradt_mpi__work *w, const paradt_index *mark, int64_t **rows) {
    uint8_t *used = (uint8_t *)paradt__alloc(&w->memory, w->received_count, 1);
    paradt_status status = used ? paradt_mpi__list_exceptions(w, mark, used, rows) : PARADT_ERROR_MEMORY;
    paradt__release(&w->memory, used);
    return status;
}

// Sends the representatives to those who handed the points in. rows: see paradt_mpi__list_exceptions.
static paradt_status paradt_mpi__represent(paradt_mpi__work *w, const int64_t *rows) {
    void *got = NULL;
    size_t count = 0, i;
    paradt_status status = paradt_mpi__exchange(w, PARADT_OK, rows, 2 * sizeof *rows, &got, &count);
    for (i = 0; i < count && !status; i++) {
        const int64_t *row = (const int64_t *)got + 2 * i;
        w->out->representative[(uint64_t)row[0] - w->out->first_point] = row[1];
    }
    paradt__release(&w->memory, got);
    return status;
}

// Reduces the statistics.
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

// The part of the result that takes no others: the own cells and their vertices. Lists what is to be sent. Not
// collective.
static paradt_status paradt_mpi__take_result(paradt_mpi__work *w, paradt_mpi__facets *facets, int64_t **rows) {
    paradt_mpi_triangulation *out = w->out;
    paradt_index *number = (paradt_index *)paradt__alloc_filled(&w->memory, w->known, sizeof *number);
    paradt_status status = PARADT_ERROR_MEMORY;
    size_t i;
    out->representative = (int64_t *)paradt__alloc_filled(&w->memory, out->point_count, sizeof *out->representative);
    if (number && out->representative) {
        paradt_mpi__take_own(w, number);
        out->cell_count = w->local.cell_count;
        for (i = 0; i < out->point_count; i++) out->representative[i] = (int64_t)(out->first_point + i);
        status = paradt_mpi__exceptions(w, number, rows);
    }
    if (!status) status = paradt_mpi__list_vertices(w, number, facets);
    if (!status) status = paradt_mpi__close_cells(w, number, facets);
    paradt__release(&w->memory, number);
    return status;
}

// Makes the result of the last local triangulation. status: of this rank so far.
static paradt_status paradt_mpi__deliver(paradt_mpi__work *w, paradt_status status) {
    paradt_mpi__facets facets; // whose other side is not known
    int64_t *rows = NULL;
    int wanted = !(w->options.local.flags & PARADT_NO_NEIGHBORS);
    double begun = paradt__now();
    memset(&facets, 0, sizeof facets);
    paradt_mpi__unsettle_questions(w);
    if (!status) status = paradt_mpi__take_result(w, &facets, &rows);
    status = paradt_mpi__agree(w, status);
    if (!status) {
        paradt_mpi__number_cells(w);
        status = paradt_mpi__represent(w, rows);
    }
    if (!status && wanted && w->out->dim > 0) status = paradt_mpi__link(w, &facets);
    paradt__release(&w->memory, facets.rows);
    paradt__release(&w->memory, facets.home);
    paradt__release(&w->memory, facets.handles);
    paradt__release(&w->memory, rows);
    w->stats.seconds_finish = paradt__now() - begun;
    return status;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>replicated
//
// Every rank has all points and builds its region of them. Doors: paradt_mpi__replicated.

// Are the points the same on all ranks?
static paradt_status paradt_mpi__compare_points(paradt_mpi__work *w, const double *rows) {
    size_t width = (size_t)w->dim + (size_t)w->weighted + 1, i;
    uint64_t h = 0, first;
    for (i = 0; i < w->out->point_count; i++)
        h = paradt__mix(h ^ paradt__hash_coordinates(rows + i * width, (int)width - 1));
    first = h;
    MPI_Bcast(&first, 1, MPI_UINT64_T, 0, w->comm);
    return paradt_mpi__agree(w, h == first ? PARADT_OK : PARADT_ERROR_ARGUMENT);
}

// Marks the vertices of all ranks' cells: used, [count].
static void paradt_mpi__unite(paradt_mpi__work *w, uint8_t *used, size_t count) {
    size_t i;
    for (i = 0; i < w->out->vertex_count; i++) used[w->out->vertices[i]] = 1;
    for (i = 0; i < count; i += (size_t)1 << 30) {
        size_t part = count - i < (size_t)1 << 30 ? count - i : (size_t)1 << 30;
        MPI_Allreduce(MPI_IN_PLACE, used + i, (int)part, MPI_UINT8_T, MPI_MAX, w->comm);
    }
}

// Builds this rank's region; not collective. `rows` becomes the records.
static paradt_status paradt_mpi__region(paradt_mpi__work *w, double *rows) {
    size_t count = w->out->point_count, width = (size_t)w->dim + (size_t)w->weighted + 1, i;
    paradt_options options;
    paradt_points points;
    double *weights = NULL;
    paradt_status status;
    double begun = paradt__now();
    int axis;
    w->set.records = rows;
    w->set.width = width;
    w->set.count = w->known = w->room = count;
    for (axis = 0; axis < w->dim; axis++) w->set.axes[axis] = axis;
    w->home = (paradt_mpi__home *)paradt__alloc(&w->memory, count, sizeof *w->home);
    if (!w->home) return PARADT_ERROR_MEMORY;
    status = paradt_mpi__go_on(w, 0.0);
    if (status) return status;
    if (w->weighted) {
        weights = (double *)paradt__alloc(&w->memory, count, sizeof *weights);
        if (!weights) return PARADT_ERROR_MEMORY;
    }
    for (i = 0; i < count; i++) {
        w->home[i].id = i;
        w->home[i].rank = (int)((paradt__mix(i) >> 32) * (uint64_t)w->ranks >> 32); // where facets meet: all have it
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
    status = paradt__remote_region(&w->local, &points, &options, (size_t)w->rank);
    if (!status) paradt_mpi__account(w);
    paradt__release(&w->memory, weights);
    w->stats.triangulations = 1;
    if (w->rank == 0) w->stats.points = count - (size_t)w->local.stats.duplicates;
    w->stats.cells_recomputed = w->local.stats.cells_recomputed;
    w->stats.seconds_build = paradt__now() - begun;
    return status;
}

// The representatives, which are known everywhere but for hidden points.
static paradt_status paradt_mpi__represent_replicated(paradt_mpi__work *w) {
    size_t count = w->out->point_count, i;
    uint8_t *used = (uint8_t *)paradt__alloc(&w->memory, count, 1);
    paradt_status status = paradt_mpi__agree(w, used ? PARADT_OK : PARADT_ERROR_MEMORY);
    if (!status) {
        memset(used, !w->weighted, count);
        if (w->weighted) paradt_mpi__unite(w, used, count);
        for (i = 0; i < count; i++) {
            size_t twin = (size_t)w->local.representative[i];
            w->out->representative[i] = used[twin] ? (int64_t)twin : -1;
            if (w->rank) continue;
            w->stats.hidden += twin == i && !used[i];
            w->stats.duplicates += twin != i;
        }
    }
    paradt__release(&w->memory, used);
    return status;
}

static paradt_status paradt_mpi__replicated(paradt_mpi__work *w, double *rows) {
    paradt_status status = paradt_mpi__compare_points(w, rows);
    if (status) {
        paradt__release(&w->memory, rows);
        return status;
    }
    status = paradt_mpi__agree(w, paradt_mpi__region(w, rows));
    if (status) return status;
    w->out->dim = w->local.dim;
    w->out->point_total = w->out->point_count;
    w->set.count = 0; // none are this rank's own: representatives are known without asking
    status = paradt_mpi__deliver(w, PARADT_OK);
    return status ? status : paradt_mpi__represent_replicated(w);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>triangulate

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
}

// Gives back all that a call holds beside the result.
static void paradt_mpi__end(paradt_mpi__work *w) {
    if (w->inserting) paradt__remote_engine_free(&w->engine, &w->memory);
    paradt_mpi__forget(w);
    paradt_mpi__unsettle(w);
    paradt__release(&w->memory, w->directory.groups);
    paradt__release(&w->memory, w->directory.count);
    paradt__release(&w->memory, w->directory.ranks);
    paradt__release(&w->memory, w->directory.rooms);
    paradt__release(&w->memory, w->directory.nearby);
    paradt__release(&w->memory, w->directory.listeners);
    paradt__release(&w->memory, w->first);
    paradt__release(&w->memory, w->from);
    paradt__release(&w->memory, w->next);
    paradt__release(&w->memory, w->to);
    MPI_Comm_free(&w->comm);
}

// The points of all ranks, each in its box.
static paradt_status paradt_mpi__distributed(paradt_mpi__work *w, double *rows) {
    paradt_status status = paradt_mpi__place_points(w, rows);
    double begun = paradt__now();
    if (!status && w->out->dim > 0) status = paradt_mpi__tell(w);
    if (!status && w->out->dim > 0 && w->ranks > 1) status = paradt_mpi__guess(w);
    w->stats.seconds_grid += paradt__now() - begun;
    return status ? status : paradt_mpi__deliver(w, paradt_mpi__rounds(w));
}

static paradt_status paradt_mpi__run(paradt_mpi__work *w, const paradt_points *local, paradt_status status) {
    double *rows = NULL, begun = paradt__now();
    status = paradt_mpi__check(w, local, status);
    if (status) return status;
    w->to = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->to);
    w->from = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->from);
    w->next = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->next);
    w->first = (uint64_t *)paradt__alloc(&w->memory, (size_t)w->ranks + 1, sizeof *w->first);
    status = paradt_mpi__agree(w, w->to && w->from && w->next && w->first ? PARADT_OK : PARADT_ERROR_MEMORY);
    if (status) return status;
    paradt_mpi__number(w, local->count);
    w->out->ambient = w->dim;
    w->out->point_count = local->count;
    w->out->point_total = w->first[w->ranks];
    w->out->first_point = w->options.flags & PARADT_MPI_REPLICATED ? 0 : w->first[w->rank];
    status = paradt_mpi__agree(w, paradt_mpi__read(w, local, &rows));
    if (status) {
        paradt__release(&w->memory, rows);
        return status;
    }
    w->stats.seconds_partition = paradt__now() - begun;
    return w->options.flags & PARADT_MPI_REPLICATED ? paradt_mpi__replicated(w, rows)
                                                    : paradt_mpi__distributed(w, rows);
}

PARADT_DEF paradt_status paradt_mpi_triangulate(paradt_mpi_triangulation *out, MPI_Comm comm,
                                                const paradt_points *local, const paradt_mpi_options *options) {
    paradt_mpi__work w;
    paradt_mpi_triangulation nowhere; // a rank without an `out` takes part, so that the others need not wait for it
    paradt_status status = out ? PARADT_OK : PARADT_ERROR_ARGUMENT;
    double begun = paradt__now();
    if (!out) out = &nowhere;
    memset(out, 0, sizeof *out);
    memset(&w, 0, sizeof w);
    if (options) w.options = *options;
    w.out = out;
    w.progress_length = 1.0;
    paradt__memory_begin(&w.memory, &w.options.local);
    MPI_Comm_dup(comm, &w.comm);
    MPI_Comm_rank(w.comm, &w.rank);
    MPI_Comm_size(w.comm, &w.ranks);
    status = paradt_mpi__run(&w, local, status);
    out->allocator = w.memory.allocator;
    if (status) {
        int rank = out->error_rank;
        size_t point = out->error_point;
        paradt_mpi_free(out);
        out->error_rank = rank;
        out->error_point = point;
    } else {
        w.stats.peak_bytes = w.memory.peak;
        w.stats.seconds = paradt__now() - begun;
        paradt_mpi__reduce_stats(&w);
    }
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
    size_t cell = (size_t)t->neighbors[facet];
    if (t->neighbors[facet] < 0) return PARADT__HULL;
    return cell < t->cell_count ? (int64_t)(t->first_cell + cell) : t->others[cell - t->cell_count];
}

// ---------------------------------------------------------------------------------------------------------------------
// >>gather

// Sends `count` elements of `size` bytes to the root; there *all gets those of all ranks, in their order.
static paradt_status paradt_mpi__collect_at(paradt_mpi__work *w, paradt_status status, int root, const void *part,
                                            size_t count, size_t size, void **all, size_t *total) {
    if (!status) {
        memset(w->to, 0, (size_t)w->ranks * sizeof *w->to);
        w->to[root] = count;
    }
    return paradt_mpi__exchange(w, status, part, size, all, total);
}

// The own cells as they are to be on the root: by global ids, and their neighbours, where there are any, by the numbers
// of all ranks' cells. An index holds both.
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

// 64-bit numbers as an array of indices.
static paradt_status paradt_mpi__narrow(paradt_mpi__work *w, const void *from, size_t count, paradt_index **to) {
    size_t i;
    *to = (paradt_index *)paradt__alloc(&w->memory, count, sizeof **to);
    if (!*to) return PARADT_ERROR_MEMORY;
    for (i = 0; i < count; i++) (*to)[i] = (paradt_index)((const int64_t *)from)[i];
    return PARADT_OK;
}

static paradt_status paradt_mpi__gather(paradt_mpi__work *w, paradt_triangulation *out,
                                        const paradt_mpi_triangulation *t, int root) {
    size_t k = t->dim < 0 ? 1 : (size_t)t->dim + 1, values = t->cell_count * k, cells = 0, neighbors = 0, points = 0,
           handed;
    void *all_cells = NULL, *all_neighbors = NULL, *all_points = NULL;
    paradt_index *ids = NULL, *numbers = NULL;
    const uint64_t most = (uint64_t)PARADT__NOWHERE;
    const uint64_t handed_in = paradt_mpi__sum(w, t->point_count); // more than there are if replicated: one rank's do
    paradt_status status = t->cell_total > most / k || t->point_total > most ? PARADT_ERROR_TOO_LARGE : PARADT_OK;
    w->to = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->to);
    w->from = (size_t *)paradt__alloc(&w->memory, (size_t)w->ranks, sizeof *w->from);
    if (!status) status = w->to && w->from ? paradt_mpi__name_cells(w, t, &ids, &numbers) : PARADT_ERROR_MEMORY;
    handed = handed_in > t->point_total && w->rank != root ? 0 : t->point_count;
    status = paradt_mpi__agree(w, status);
    if (!status) status = paradt_mpi__collect_at(w, status, root, ids, values, sizeof *ids, &all_cells, &cells);
    if (!status)
        status = paradt_mpi__collect_at(w, status, root, numbers, numbers ? values : 0, sizeof *numbers, &all_neighbors,
                                        &neighbors);
    if (!status)
        status = paradt_mpi__collect_at(w, status, root, t->representative, handed, sizeof *t->representative,
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
        status = paradt_mpi__narrow(w, all_points, points, &out->representative);
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
    paradt_mpi_triangulation errors; // agreeing notes the rank there
    paradt_triangulation nowhere;
    paradt_status status = PARADT_OK;
    if (!out) out = &nowhere;
    memset(out, 0, sizeof *out);
    memset(&w, 0, sizeof w);
    memset(&errors, 0, sizeof errors);
    w.out = &errors;
    if (t) w.options.local.allocator = t->allocator;
    paradt__memory_begin(&w.memory, &w.options.local);
    MPI_Comm_dup(comm, &w.comm);
    MPI_Comm_rank(w.comm, &w.rank);
    MPI_Comm_size(w.comm, &w.ranks);
    if (!t || out == &nowhere || root < 0 || root >= w.ranks) status = PARADT_ERROR_ARGUMENT;
    status = paradt_mpi__agree(&w, status);
    if (!status) status = paradt_mpi__gather(&w, out, t, root);
    out->allocator = w.memory.allocator;
    if (status) paradt_free(out);
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
