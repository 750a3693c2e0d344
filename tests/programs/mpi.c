// Compares the distributed triangulation with the serial one, on the families of the serial tests and several numbers of
// ranks. Runs under mpiexec and prints TAP on rank 0.
//
//     mpiexec -n 8 mpi [families | many | weights | errors]
//
// Samples are small, so every rank makes the whole sample and hands in its share.

#define PARADT_MPI_PIECE ((size_t)1000) // splits messages into pieces
// In the group "errors" space is cut anew for every set. Otherwise the bounds are those of paradt_mpi.h.
static int always_cut_anew;
#define PARADT_MPI__WORTH (always_cut_anew ? 0u : 8192u)
#define PARADT_MPI__MUCH  (always_cut_anew ? 0.0 : 1.25)
#define PARADT_MPI_IMPLEMENTATION
#include "paradt_mpi.h"

#include "families.h"
#include "mpi_polite.h"

#include <stdarg.h>
#include <unistd.h>

static int rank, ranks; // of MPI_COMM_WORLD
static int tests, failures;

// --- reporting

static void report(int good, const char *format, ...) {
    char text[300];
    va_list arguments;
    int all = good;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    MPI_Allreduce(&good, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    tests++;
    failures += !all;
    if (rank == 0) {
        printf("%s %d - %s\n", all ? "ok" : "not ok", tests, text);
        fflush(stdout);
    }
    if (!good) {
        printf("# rank %d: %s\n", rank, text);
        fflush(stdout);
    }
}

// --- shares of the points

typedef enum sharing { BLOCKS, DEALT, ALL_ON_LAST, SOME_EMPTY, SHARINGS } sharing;
static const char *const sharing_names[] = {"in blocks", "dealt out", "all on the last rank", "every other rank empty"};

static int holder(sharing how, int point, int count, int size) {
    switch (how) {
    case BLOCKS: return (int)((long long)point * size / count);
    case DEALT: return point % size;
    case ALL_ON_LAST: return size - 1;
    default: return point % ((size + 1) / 2) * 2;
    }
}

// Returns the points that rank `mine` of `size` hands in, in the order of the sample. Fills order[count] with the sample's
// index of each global id.
static sample share_of(const sample *s, sharing how, int mine, int size, int *order) {
    int *picked = (int *)need((size_t)s->count, sizeof *picked), count = 0, next = 0, r, i;
    sample share;
    for (r = 0; r < size; r++) {
        for (i = 0; i < s->count; i++) {
            if (holder(how, i, s->count, size) != r) continue;
            if (r == mine) picked[count++] = i;
            order[next++] = i;
        }
    }
    share = sample_pick(s, picked, count);
    free(picked);
    return share;
}

static paradt_points points_of(const sample *s) {
    paradt_points points;
    memset(&points, 0, sizeof points);
    points.data = s->x;
    points.count = (size_t)s->count;
    points.dim = s->dim;
    points.weights = s->w;
    return points;
}

// --- comparing

// Triangulates the sample serially, in the order of global ids.
static paradt_triangulation serial(const sample *s, const int *order) {
    sample all = sample_pick(s, order, s->count);
    paradt_points points = points_of(&all);
    paradt_triangulation t;
    if (paradt_triangulate(&t, &points, NULL) != PARADT_OK) {
        printf("# the serial triangulation failed: %s\n", s->name);
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    sample_free(&all);
    return t;
}

// Does each entry of the table of others' cells belong to exactly one facet, and to a cell of another rank?
static int others_are_others(const paradt_mpi_triangulation *t) {
    char *met = (char *)need(t->other_count, 1);
    size_t facet, i, found = 0;
    int good = 1;
    memset(met, 0, t->other_count);
    for (facet = 0; t->neighbors && facet < t->cell_count * (size_t)(t->dim + 1); facet++) {
        if (t->neighbors[facet] < 0 || (size_t)t->neighbors[facet] < t->cell_count) continue;
        i = (size_t)t->neighbors[facet] - t->cell_count;
        good = good && i < t->other_count && !met[i];
        if (!good) break;
        met[i] = 1;
        found++;
    }
    for (i = 0; i < t->other_count; i++) {
        uint64_t number = (uint64_t)t->others[i];
        good = good && number < t->cell_total && (number < t->first_cell || number >= t->first_cell + t->cell_count);
    }
    free(met);
    return good && found == t->other_count;
}

// Does the table of vertices have exactly the vertices of the rank's cells?
static int table_is_of_vertices(const paradt_mpi_triangulation *t) {
    char *met = (char *)need(t->vertex_count, 1);
    size_t i, found = 0;
    int good = t->vertex_own <= t->vertex_count;
    memset(met, 0, t->vertex_count);
    for (i = 0; i < t->cell_count * (size_t)(t->dim + 1) && good; i++) {
        good = t->cells[i] >= 0 && (size_t)t->cells[i] < t->vertex_count;
        if (!good || met[t->cells[i]]) continue;
        met[t->cells[i]] = 1;
        found++;
    }
    free(met);
    return good && found == t->vertex_count;
}

// Does each cell belong to the highest rank among those that own its vertices? Nobody owns replicated points. Collective; count
// is the number of points of all ranks.
static int highest_rank_owns(const paradt_mpi_triangulation *t, MPI_Comm comm, int count) {
    int *home = (int *)need((size_t)count, sizeof *home), me, point, somewhere = 0, good = 1;
    size_t corners = (size_t)(t->dim + 1), i, j;
    MPI_Comm_rank(comm, &me);
    for (point = 0; point < count; point++) home[point] = -1;
    for (i = 0; i < t->vertex_own; i++) home[t->vertices[i]] = me;
    MPI_Allreduce(MPI_IN_PLACE, home, count, MPI_INT, MPI_MAX, comm);
    for (point = 0; point < count; point++) somewhere |= home[point] >= 0;
    for (i = 0; i < t->cell_count && somewhere; i++) {
        int highest = -1;
        for (j = 0; j < corners; j++) {
            int rank_of = home[t->vertices[t->cells[i * corners + j]]];
            highest = rank_of > highest ? rank_of : highest;
        }
        good = good && highest == me;
    }
    free(home);
    return good;
}

// Returns NULL, or what is wrong with the distributed result.
static const char *compare(const paradt_mpi_triangulation *t, MPI_Comm comm, const sample *s, const int *order,
                           const paradt_triangulation *expected) {
    sample all = sample_pick(s, order, s->count);
    paradt_points points = points_of(&all);
    paradt_triangulation gathered;
    paradt_fault fault;
    size_t i;
    int j, me, owned = highest_rank_owns(t, comm, s->count);
    uint64_t hash = paradt_mpi_hash(t, comm);
    const char *wrong = NULL;
    MPI_Comm_rank(comm, &me);
    if (t->dim != expected->dim) wrong = "dim";
    else if (t->cell_total != expected->cell_count) wrong = "number of cells";
    else if (hash != paradt_hash(expected)) wrong = "cells";
    else if (!table_is_of_vertices(t)) wrong = "table of vertices";
    for (i = 0; i < t->vertex_count && !wrong; i++) {
        for (j = 0; j < s->dim; j++)
            if (t->coordinates[i * (size_t)s->dim + (size_t)j] !=
                all.x[(size_t)t->vertices[i] * (size_t)s->dim + (size_t)j])
                wrong = "coordinates";
    }
    for (i = 0; i < t->point_count && !wrong; i++) {
        if (t->representative[i] != expected->representative[t->first_point + i]) wrong = "representatives";
    }
    if (!wrong && !others_are_others(t)) wrong = "cells of others";
    if (!wrong && !owned) wrong = "owners";
    if (!wrong && t->sum.hull_facets != expected->stats.hull_facets) wrong = "hull facets";
    if (!wrong && t->sum.hidden != expected->stats.hidden) wrong = "hidden";
    if (!wrong && t->sum.duplicates != expected->stats.duplicates) wrong = "duplicates";
    if (paradt_mpi_gather(&gathered, comm, t, 0) != PARADT_OK) wrong = "gathering fails";
    if (!wrong && me == 0 && paradt_check(&gathered, &points, NULL, &fault) != PARADT_OK)
        wrong = fault.reason ? fault.reason : "the check fails";
    paradt_free(&gathered);
    sample_free(&all);
    return wrong;
}

static char failure[300]; // what failed on this rank in the current test

static void note(const sample *s, int size, sharing how, const char *wrong) {
    if (!failure[0])
        snprintf(failure, sizeof failure, "%s on %d ranks, %s: %s", s->name, size, sharing_names[how], wrong);
}

// Tests a sample on the ranks of comm. Other ranks do nothing.
static void check_sample(const sample *s, MPI_Comm comm, sharing how, const paradt_mpi_options *options) {
    int size, me, *order;
    sample share;
    paradt_points points;
    paradt_mpi_triangulation t;
    paradt_triangulation expected;
    paradt_status status;
    const char *wrong;
    if (comm == MPI_COMM_NULL) return;
    MPI_Comm_size(comm, &size);
    MPI_Comm_rank(comm, &me);
    order = (int *)need((size_t)s->count, sizeof *order);
    share = share_of(s, how, me, size, order);
    if (options && options->flags & PARADT_MPI_REPLICATED) {
        sample_free(&share);
        share = sample_pick(s, order, s->count);
    }
    points = points_of(&share);
    expected = serial(s, order);
    status = paradt_mpi_triangulate(&t, comm, &points, options);
    wrong = status ? paradt_status_string(status) : compare(&t, comm, s, order, &expected);
    if (wrong) note(s, size, how, wrong);
    paradt_mpi_free(&t);
    paradt_free(&expected);
    sample_free(&share);
    free(order);
}

static void finish_test(const char *format, ...) {
    char text[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (failure[0]) printf("# %s\n", failure);
    report(!failure[0], "%s", text);
    failure[0] = 0;
}

// --- the tests

static const int sizes[] = {1, 2, 3, 4, 5, 7, 8};
enum { SIZES = sizeof sizes / sizeof *sizes };
static MPI_Comm comms[SIZES]; // the first sizes[i] ranks; MPI_COMM_NULL on the others

static void make_comms(void) {
    for (int i = 0; i < SIZES; i++)
        MPI_Comm_split(MPI_COMM_WORLD, rank < sizes[i] && sizes[i] <= ranks ? 0 : MPI_UNDEFINED, rank, &comms[i]);
}

// Tests a family on every `step`th of the numbers of ranks. The seed and the dimension choose the first.
// Where predicates take thousands of bits there are fewer points.
static void same_cells_on_family(const family *f, const weighting *w, int dim, int count, uint64_t seed, int step) {
    int extremes = f->extremes || (w && w->extremes);
    sample s = family_make(f, w, dim, extremes && count > 25 ? count / 4 + 10 : count, seed);
    for (int i = (int)(seed + (uint64_t)dim) % step; i < SIZES; i += step)
        check_sample(&s, comms[i], (sharing)((i + (int)seed) % SHARINGS), NULL);
    sample_free(&s);
}

static void same_cells_on_families(void) {
    static const int counts[] = {0, 0, 250, 200, 60, 25};
    for (int dim = 2; dim <= 5; dim++) {
        for (int f = 0; f < FAMILY_COUNT; f++) {
            same_cells_on_family(&families[f], NULL, dim, counts[dim], (uint64_t)f, 2);
            finish_test("same cells: %s, d = %d", families[f].name, dim);
        }
    }
}

static void same_cells_with_weights(void) {
    static const char *const names[] = {"uniform",    "clusters",         "lattice",    "sphere",   "line",
                                        "hyperplane", "mixed magnitudes", "duplicates", "all equal"};
    static const int counts[] = {0, 0, 300, 200, 50, 20};
    for (int dim = 2; dim <= 5; dim++) {
        for (int i = 0; i < (int)(sizeof names / sizeof *names); i++) {
            for (int v = 1; v < WEIGHTING_COUNT; v++)
                same_cells_on_family(&families[family_named(names[i])], &weightings[v], dim, counts[dim],
                                     (uint64_t)(v + i), 4);
            finish_test("same cells with weights: %s, d = %d", names[i], dim);
        }
    }
}

// These sets have regions with an interior, or surfaces whose spheres reach all ranks.
static void same_cells_of_many_points(void) {
    static const char *const names[] = {"uniform", "clusters",     "plummer",    "lattice",    "sphere",
                                        "fcc",     "cube surface", "near plane", "duplicates", "cylinder"};
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++) {
        for (int dim = 2; dim <= 3; dim++) {
            sample s = family_make(&families[family_named(names[i])], NULL, dim, 4000, (uint64_t)i);
            for (int j = 1; j < SIZES; j += 2) check_sample(&s, comms[j], (sharing)(j % SHARINGS), NULL);
            check_sample(&s, comms[SIZES - 1], DEALT, NULL);
            sample_free(&s);
        }
        finish_test("same cells of 4,000 points: %s", names[i]);
    }
}

static void same_cells_of_few_points(void) {
    for (int count = 0; count <= 9; count++) {
        for (int dim = 2; dim <= 4; dim++) {
            for (int seed = 0; seed < 3; seed++) {
                const family *f = &families[family_named(seed ? "lattice" : "uniform")];
                sample s = family_make(f, NULL, dim, count, (uint64_t)seed);
                check_sample(&s, comms[SIZES - 1], (sharing)(seed + 1), NULL);
                check_sample(&s, comms[2], (sharing)seed, NULL);
                sample_free(&s);
            }
        }
        finish_test("same cells of %d points", count);
    }
}

static void same_cells_of_replicated_points(void) {
    static const char *const names[] = {"uniform", "lattice", "hyperplane", "all equal", "duplicates", "line"};
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++) {
        for (int v = 0; v < 4; v += 3) {
            for (int j = 0; j < SIZES; j++) {
                paradt_mpi_options options;
                sample s = family_make(&families[family_named(names[i])], &weightings[v], 2 + j % 3, 200, (uint64_t)i);
                memset(&options, 0, sizeof options);
                options.flags = PARADT_MPI_REPLICATED;
                options.local.method = j % 2 ? PARADT_DEWALL : PARADT_INCODE;
                options.local.partition = j % 4 < 2 ? PARADT_BISECTION : PARADT_UNIFORM;
                check_sample(&s, comms[j], BLOCKS, &options);
                sample_free(&s);
            }
        }
        finish_test("same cells of replicated points: %s", names[i]);
    }
}

static void same_cells_by_other_options(void) {
    for (int m = 0; m < PARADT_METHOD_COUNT; m++) {
        paradt_mpi_options options;
        sample s = family_make(&families[family_named("lattice off by ulps")], NULL, 3, 500, 1);
        memset(&options, 0, sizeof options);
        options.local.method = (paradt_method)m;
        options.local.partition = m % 2 ? PARADT_UNIFORM : PARADT_BISECTION;
        options.local.regions = (size_t)m;
        check_sample(&s, comms[3], DEALT, &options);
        sample_free(&s);
        finish_test("same cells by %s", paradt_method_string((paradt_method)m));
    }
}

// --- errors: the same status on all ranks, and the rank at fault

typedef struct meter { // of an allocator: the calls that are left until it fails, and the bytes that are held
    long left;
    size_t held, peak;
} meter;

enum { METER_SIZE = 64 }; // in front of a block

static void *meter_alloc(void *user, size_t size) {
    meter *m = (meter *)user;
    char *block = m->left-- <= 0 ? NULL : (char *)malloc(size + METER_SIZE);
    if (!block) return NULL;
    memcpy(block, &size, sizeof size);
    m->held += size;
    if (m->held > m->peak) m->peak = m->held;
    return block + METER_SIZE;
}

static void meter_free(void *user, void *memory) {
    char *block = memory ? (char *)memory - METER_SIZE : NULL;
    size_t size = 0;
    if (block) memcpy(&size, block, sizeof size);
    ((meter *)user)->held -= size;
    free(block);
}

static void keep_meter(paradt_mpi_options *options, meter *m, long allowed) {
    memset(m, 0, sizeof *m);
    m->left = allowed;
    options->local.allocator.alloc = meter_alloc;
    options->local.allocator.free = meter_free;
    options->local.allocator.user = m;
}

static int cancels_at_once(void *user, double fraction) {
    (void)fraction;
    return *(int *)user;
}

// Triangulates on four ranks; the arguments are wrong on rank `culprit`. Returns 1 if all ranks get the expected error.
static int agreed(paradt_mpi_triangulation *t, const paradt_points *points, const paradt_mpi_options *options,
                  paradt_status expected, int culprit, size_t point) {
    paradt_status status = paradt_mpi_triangulate(t, comms[3], points, options);
    int good = status == expected && (!status || (t->error_rank == culprit && t->error_point == point && !t->cells));
    paradt_mpi_free(t);
    return good;
}

static void errors_are_agreed_on(void) {
    paradt_mpi_triangulation t;
    for (int culprit = 0; culprit < 4; culprit++) {
        int order[400], good = 1, cancel = rank == culprit;
        sample s = family_make(&families[family_named("uniform")], NULL, 3, 400, 5),
               share = share_of(&s, BLOCKS, rank % 4, 4, order);
        paradt_points points = points_of(&share), wrong = points;
        paradt_mpi_options options;
        memset(&options, 0, sizeof options);
        if (comms[3] != MPI_COMM_NULL) {
            double kept = share.x[3 * 17 + 1];
            if (rank == culprit) share.x[3 * 17 + 1] = NAN;
            good &= agreed(&t, &points, NULL, PARADT_ERROR_NOT_FINITE, culprit, 17);
            if (rank == culprit) share.x[3 * 17 + 1] = -INFINITY;
            good &= agreed(&t, &points, NULL, PARADT_ERROR_NOT_FINITE, culprit, 17);
            share.x[3 * 17 + 1] = kept;
        }
        if (!good) note(&s, 4, BLOCKS, "a point that is not finite");
        if (comms[3] != MPI_COMM_NULL) {
            if (rank == culprit) wrong.dim = 2;
            good &=
                agreed(&t, &wrong, NULL, PARADT_ERROR_ARGUMENT, culprit ? culprit : 1, 0); // others differ from rank 0
            if (rank == culprit) wrong.dim = 99;
            good &= agreed(&t, &wrong, NULL, PARADT_ERROR_ARGUMENT, culprit, 0);
            wrong.dim = 3;
            if (rank == culprit) wrong.data = NULL;
            good &= agreed(&t, &wrong, NULL, PARADT_ERROR_ARGUMENT, culprit, 0);
            good &= agreed(&t, rank == culprit ? NULL : &points, NULL, PARADT_ERROR_ARGUMENT, culprit, 0);
            if (rank == culprit) options.local.allocator.alloc = meter_alloc; // without a function that frees
            good &= agreed(&t, &points, &options, PARADT_ERROR_ARGUMENT, culprit, 0);
            options.local.allocator.alloc = NULL;
        }
        if (!good) note(&s, 4, BLOCKS, "a wrong argument");
        if (comms[3] != MPI_COMM_NULL) {
            options.local.progress = cancels_at_once;
            options.local.user = &cancel;
            good &= agreed(&t, &points, &options, PARADT_ERROR_CANCELLED, culprit, 0);
        }
        if (!good) note(&s, 4, BLOCKS, "cancelled");
        sample_free(&share);
        sample_free(&s);
        finish_test("rank %d errs, all return the same status", culprit);
    }
}

// Every allocation of one rank fails once. No memory is kept, and no rank waits forever.
static void failing_allocations_are_agreed_on(int culprit, int weighted, unsigned flags) {
    sample s = family_make(&families[family_named("uniform")], &weightings[weighted], 3, 120, 5);
    int order[120];
    sample share = share_of(&s, BLOCKS, rank % 3, 3, order);
    paradt_points points = flags ? points_of(&s) : points_of(&share);
    long allowed;
    paradt_status status = PARADT_ERROR_MEMORY;
    for (allowed = 0; status && comms[2] != MPI_COMM_NULL; allowed++) {
        paradt_mpi_triangulation t;
        paradt_mpi_options options;
        meter m;
        memset(&options, 0, sizeof options);
        keep_meter(&options, &m, rank == culprit ? allowed : LONG_MAX);
        options.flags = flags;
        status = paradt_mpi_triangulate(&t, comms[2], &points, &options);
        if (status && (status != PARADT_ERROR_MEMORY || t.error_rank != culprit))
            note(&s, 3, BLOCKS, "another status or rank");
        paradt_mpi_free(&t);
        if (m.held) note(&s, 3, BLOCKS, "memory is kept");
    }
    sample_free(&share);
    sample_free(&s);
    finish_test("each allocation of rank %d fails%s%s", culprit, weighted ? ", weighted" : "", flags ? ", replicated" : "");
}

// No rank holds more memory than it reports, nor more than its limit, whether the limit suffices or not.
static void memory_stays_within_its_limit(int weighted, unsigned flags) {
    enum { PARTS = 16 };
    sample s = family_make(&families[family_named("uniform")], weighted ? &weightings[1] : NULL, 3, 4000, 5);
    int order[4000], sixteenth;
    sample share = share_of(&s, BLOCKS, rank % 3, 3, order);
    paradt_points points = flags ? points_of(&s) : points_of(&share);
    size_t said = 0;
    for (sixteenth = PARTS + 1; sixteenth > 2 && comms[2] != MPI_COMM_NULL; sixteenth--) {
        paradt_mpi_triangulation t;
        paradt_mpi_options options;
        paradt_status status;
        meter m;
        memset(&options, 0, sizeof options);
        keep_meter(&options, &m, LONG_MAX);
        options.flags = flags;
        options.local.memory_limit = sixteenth > PARTS ? 0 : said / PARTS * (size_t)sixteenth;
        status = paradt_mpi_triangulate(&t, comms[2], &points, &options);
        if (sixteenth > PARTS) said = (size_t)t.stats.peak_bytes;
        if (status != (sixteenth > PARTS ? PARADT_OK : PARADT_ERROR_MEMORY) && sixteenth != PARTS)
            note(&s, 3, BLOCKS, "another status");
        if (!status && m.peak > t.stats.peak_bytes) note(&s, 3, BLOCKS, "more was held than is said");
        if (options.local.memory_limit && m.peak > options.local.memory_limit)
            note(&s, 3, BLOCKS, "more was held than is allowed");
        paradt_mpi_free(&t);
    }
    sample_free(&share);
    sample_free(&s);
    finish_test("memory stays within its limit%s%s", weighted ? ", weighted" : "", flags ? ", replicated" : "");
}

// What a rank holds beyond its eighth is for points near its border.
static void eight_ranks_hold_less_than_double_an_eighth(void) {
    enum { COUNT = 200000 };
    if (comms[SIZES - 1] != MPI_COMM_NULL) {
        sample s = family_make(&families[family_named("uniform")], NULL, 3, COUNT, 5);
        int size = sizes[SIZES - 1], *order = (int *)need(COUNT, sizeof *order);
        sample share = share_of(&s, BLOCKS, rank, size, order);
        paradt_points points = points_of(&share);
        paradt_mpi_triangulation t;
        if (paradt_mpi_triangulate(&t, comms[SIZES - 1], &points, NULL) != PARADT_OK)
            note(&s, size, BLOCKS, "it fails");
        if (rank == 0 && t.cell_total) {
            paradt_triangulation all = serial(&s, order);
            if ((double)t.largest.peak_bytes * size > 1.8 * (double)all.stats.peak_bytes)
                note(&s, size, BLOCKS, "more is held");
            if (all.cell_count != t.cell_total) note(&s, size, BLOCKS, "number of cells");
            paradt_free(&all);
        }
        paradt_mpi_free(&t);
        sample_free(&share);
        sample_free(&s);
        free(order);
    }
    finish_test("eight ranks hold less than double an eighth");
}

// Fills own[i] with the number of points that rank i of comms[with] owns. All are 0 on ranks outside of it.
static void share_out(const sample *s, int with, uint64_t *own) {
    memset(own, 0, (size_t)sizes[with] * sizeof *own);
    if (comms[with] == MPI_COMM_NULL) return;
    int *order = (int *)need((size_t)s->count, sizeof *order);
    sample share = share_of(s, DEALT, rank, sizes[with], order);
    paradt_points points = points_of(&share);
    paradt_mpi_triangulation t;
    if (paradt_mpi_triangulate(&t, comms[with], &points, NULL)) note(s, sizes[with], DEALT, "no triangulation");
    MPI_Allgather(&t.stats.points, 1, MPI_UINT64_T, own, 1, MPI_UINT64_T, comms[with]);
    paradt_mpi_free(&t);
    sample_free(&share);
    free(order);
}

static void two_ranks_have_half_of_the_points_each(void) {
    static const char *const names[] = {"uniform", "plummer", "clusters", "mixed magnitudes", "huge", "rough sphere"};
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++) {
        sample s = family_make(&families[family_named(names[i])], NULL, 3, 500, 3);
        uint64_t own[2];
        share_out(&s, 1, own);
        if (own[0] > own[1] + 1 || own[1] > own[0] + 1) note(&s, 2, DEALT, "the shares differ");
        sample_free(&s);
    }
    finish_test("two ranks have half of the points each");
}

// Of four ranks in a row, the inner two have neighbours on both sides, and get fewer points for that.
static void ranks_between_others_have_fewer_points(void) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 4000, 5);
    uint64_t own[4];
    for (int i = 0; i < s.count; i++) s.x[3 * i] *= 4;
    share_out(&s, 3, own);
    if (comms[3] != MPI_COMM_NULL) {
        if (own[0] + own[1] + own[2] + own[3] != 4000) note(&s, 4, DEALT, "points are missing");
        if (own[0] > own[3] + 20 || own[3] > own[0] + 20 || own[1] > own[2] + 20 || own[2] > own[1] + 20)
            note(&s, 4, DEALT, "ranks that have as many sides differ");
        for (int inner = 1; inner <= 2; inner++) {
            if (own[inner] + 40 > own[0] || own[inner] + 130 < own[0]) note(&s, 4, DEALT, "the shares are wrong");
        }
    }
    sample_free(&s);
    finish_test("ranks between others have fewer points");
}

static void wrong_arguments_of_gathering_are_agreed_on(void) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 100, 5);
    int order[100], culprit = 1;
    sample share = share_of(&s, BLOCKS, rank % 3, 3, order);
    paradt_points points = points_of(&share);
    if (comms[2] != MPI_COMM_NULL) {
        int wrong = rank == culprit;
        paradt_mpi_triangulation t;
        paradt_triangulation out;
        paradt_status status = paradt_mpi_triangulate(&t, comms[2], &points, NULL);
        if (status || paradt_mpi_gather(&out, comms[2], wrong ? NULL : &t, 0) != PARADT_ERROR_ARGUMENT)
            note(&s, 3, BLOCKS, "no triangulation");
        if (paradt_mpi_gather(wrong ? NULL : &out, comms[2], &t, 0) != PARADT_ERROR_ARGUMENT)
            note(&s, 3, BLOCKS, "nowhere to gather");
        if (paradt_mpi_gather(&out, comms[2], &t, wrong ? 3 : 0) != PARADT_ERROR_ARGUMENT)
            note(&s, 3, BLOCKS, "no such root");
        paradt_mpi_free(&t);
    }
    sample_free(&share);
    sample_free(&s);
    finish_test("wrong arguments of gathering are agreed on");
}

static void empty_communicator_of_one(void) {
    sample s = family_make(&families[family_named("uniform")], NULL, 2, 50, 1);
    check_sample(&s, MPI_COMM_SELF, BLOCKS, NULL);
    sample_free(&s);
    finish_test("all ranks alone at once");
}

// --- groups

static void weights_and_replicas(void) {
    same_cells_with_weights();
    same_cells_of_replicated_points();
}

static void options_and_errors(void) {
    always_cut_anew = 1;
    same_cells_of_few_points();
    same_cells_by_other_options();
    empty_communicator_of_one();
    errors_are_agreed_on();
    for (int culprit = 0; culprit < 3; culprit++) {
        failing_allocations_are_agreed_on(culprit, 0, 0);
        failing_allocations_are_agreed_on(culprit, 1, 0);
        failing_allocations_are_agreed_on(culprit, 1, PARADT_MPI_REPLICATED);
    }
    for (int way = 0; way < 4; way++) memory_stays_within_its_limit(way & 1, way & 2 ? PARADT_MPI_REPLICATED : 0);
    eight_ranks_hold_less_than_double_an_eighth();
    wrong_arguments_of_gathering_are_agreed_on();
    always_cut_anew = 0;
}

static void shares(void) {
    two_ranks_have_half_of_the_points_each();
    ranks_between_others_have_fewer_points();
}

static const struct {
    const char *name;
    void (*run)(void);
} groups[] = {
    {"families", same_cells_on_families},
    {"many", same_cells_of_many_points},
    {"shares", shares},
    {"weights", weights_and_replicas},
    {"errors", options_and_errors},
};

int main(int argc, char **argv) {
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    alarm(600); // ends the run if a rank waits forever
    make_comms();
    for (size_t g = 0; g < sizeof groups / sizeof *groups; g++)
        if (argc < 2 || strcmp(argv[1], groups[g].name) == 0) groups[g].run();
    if (rank == 0) printf("1..%d\n", tests);
    MPI_Finalize();
    return failures != 0;
}
