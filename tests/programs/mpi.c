// Compares the distributed triangulation with the serial one, on the families of the serial tests and several numbers
// of ranks. Runs under mpiexec and prints TAP on rank 0.
//
//     mpiexec -n 8 mpi [families | many | shares | options | weights | errors]
//
// Samples are small, so every rank makes the whole sample and hands in its share.

#define PARADT_MPI_PIECE ((size_t)1000) // splits messages into pieces
// In the group "errors", and for other methods, space is cut anew for every set. Otherwise the bounds are those of
// paradt_mpi.h.
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

// Returns the points that rank `mine` of `size` hands in, in the order of the sample. Fills order[count] with the
// sample's index of each global id.
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

// Does each entry of the table of others' cells, or half-facets, belong to exactly one facet, and to another rank?
static int others_are_others(const paradt_mpi_triangulation *t) {
    char *met = (char *)need(t->other_count, 1);
    size_t facet, i, found = 0, each = t->facets ? (size_t)(t->dim + 1) : 1, own = t->cell_count * each;
    int good = 1;
    memset(met, 0, t->other_count);
    for (facet = 0; t->neighbors && facet < t->cell_count * (size_t)(t->dim + 1); facet++) {
        if (t->neighbors[facet] < 0 || (size_t)t->neighbors[facet] < own) continue;
        i = (size_t)t->neighbors[facet] - own;
        good = good && i < t->other_count && !met[i];
        if (!good) break;
        met[i] = 1;
        found++;
    }
    for (i = 0; i < t->other_count; i++) {
        uint64_t number = (uint64_t)t->others[i] / each;
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

// Gathers 64-bit numbers of all ranks on every rank, in the order of ranks. Returns a new array.
static int64_t *gather_everywhere(const int64_t *mine, size_t count, MPI_Comm comm) {
    int size, me, r, own = (int)count, *counts, *begins;
    int64_t *all;
    MPI_Comm_size(comm, &size);
    MPI_Comm_rank(comm, &me);
    counts = (int *)need((size_t)size + 1, sizeof *counts);
    begins = (int *)need((size_t)size + 1, sizeof *begins);
    MPI_Allgather(&own, 1, MPI_INT, counts, 1, MPI_INT, comm);
    begins[0] = 0;
    for (r = 0; r < size; r++) begins[r + 1] = begins[r] + counts[r];
    all = (int64_t *)need((size_t)begins[size], sizeof *all);
    MPI_Allgatherv(mine, own, MPI_INT64_T, all, counts, begins, MPI_INT64_T, comm);
    free(counts);
    free(begins);
    return all;
}

// Do the half-facets f and g, given with the vertices of all cells, have the same vertices?
static int same_facet(const int64_t *cells, size_t k, size_t f, size_t g) {
    size_t i, j;
    for (i = f / k * k; i < f / k * k + k; i++) {
        for (j = g / k * k; j < g / k * k + k && (j == g || cells[j] != cells[i]);) j++;
        if (i != f && j == g / k * k + k) return 0;
    }
    return f / k != g / k;
}

// Is each facet the mirror of its mirror, on whatever ranks they are, with the same vertices? Collective.
static int mirrors_lead_back(const paradt_mpi_triangulation *t, MPI_Comm comm) {
    size_t k = (size_t)(t->dim + 1), count = t->dim > 0 ? t->cell_count * k : 0, f, all = t->cell_total * k;
    int64_t *own = (int64_t *)need(count, sizeof *own), *mirrors, *cells;
    int good = 1;
    for (f = 0; f < count; f++) {
        int64_t g = paradt_mpi_neighbor(t, f);
        good = good && g < (int64_t)all;
        if (t->neighbors[f] >= 0 && (size_t)t->neighbors[f] < count) // this rank's
            good = good && t->neighbors[t->neighbors[f]] == (paradt_index)f;
        own[f] = g;
    }
    mirrors = gather_everywhere(own, count, comm);
    for (f = 0; f < count; f++) own[f] = t->vertices[t->cells[f]];
    cells = gather_everywhere(own, count, comm);
    MPI_Allreduce(MPI_IN_PLACE, &good, 1, MPI_INT, MPI_MIN, comm);
    for (f = 0; f < all && good && t->dim > 0; f++) {
        size_t g = (size_t)mirrors[f];
        if (mirrors[f] >= 0) good = mirrors[g] == (int64_t)f && same_facet(cells, k, f, g);
    }
    free(own);
    free(mirrors);
    free(cells);
    return good;
}

// Does each cell belong to the highest rank among those that own its vertices? Nobody owns replicated points.
// Collective; count is the number of points of all ranks.
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
    paradt_options facets;
    paradt_fault fault;
    size_t i;
    int j, me, owned = highest_rank_owns(t, comm, s->count), mirrored = !t->facets || mirrors_lead_back(t, comm);
    uint64_t hash = paradt_mpi_hash(t, comm);
    const char *wrong = NULL;
    memset(&facets, 0, sizeof facets);
    facets.flags = t->facets ? PARADT_FACETS : 0;
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
    if (!wrong && !mirrored) wrong = "mirrors";
    if (!wrong && t->dim == 0 && (t->neighbors || t->other_count)) wrong = "neighbours of a single vertex";
    if (!wrong && t->sum.hull_facets != expected->stats.hull_facets) wrong = "hull facets";
    if (!wrong && t->sum.hidden != expected->stats.hidden) wrong = "hidden";
    if (!wrong && t->sum.duplicates != expected->stats.duplicates) wrong = "duplicates";
    if (paradt_mpi_gather(&gathered, comm, t, 0) != PARADT_OK) wrong = "gathering fails";
    if (!wrong && me == 0 && paradt_check(&gathered, &points, &facets, &fault) != PARADT_OK)
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
            same_cells_on_family(&families[f], NULL, dim, counts[dim], (uint64_t)f, 3);
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
            for (int v = 1 + (dim + i) % 2; v < WEIGHTING_COUNT; v += 2) // weightings take turns
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

// A paradt_parallel_for that uses the calling thread alone
static void run_backwards(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    (void)user;
    while (count-- > 0) task(context, count);
}

static void same_cells_by_other_options(void) {
    for (int m = 0; m < PARADT_METHOD_COUNT; m++) {
        paradt_mpi_options options;
        sample s = family_make(&families[family_named("lattice off by ulps")], NULL, 3, 500, 1);
        memset(&options, 0, sizeof options);
        options.local.method = (paradt_method)m;
        options.local.partition = m % 2 ? PARADT_UNIFORM : PARADT_BISECTION;
        options.local.regions = (size_t)m;
        options.local.parallel_for = run_backwards;
        check_sample(&s, comms[3], DEALT, &options);
        sample_free(&s);
        finish_test("same cells by %s", paradt_method_string((paradt_method)m));
    }
}

// Half-facets instead of cells, on one to four ranks.
static void mirrors_of_mirrors_across_ranks(void) {
    static const char *const names[] = {"uniform", "lattice",   "duplicates", "hyperplane",
                                        "line",    "all equal", "sphere"};
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++) {
        for (int way = 0; way < 8 * 4; way++) {
            int weighted = way & 1, dim = 2 + (way >> 1) % 3;
            paradt_mpi_options options;
            if (((way + (way >> 2) + (way >> 3) + i) & 1) != 0) continue; // each set has half of the ways
            sample s = family_make(&families[family_named(names[i])], weighted ? &weightings[1] : NULL, dim,
                                   dim == 4 ? 60 : 250, (uint64_t)i);
            memset(&options, 0, sizeof options);
            options.local.flags = PARADT_FACETS;
            options.local.method = (paradt_method)(way >> 3);
            options.flags = way & 4 ? PARADT_MPI_REPLICATED : 0;
            for (int j = 0; j < 4; j++) check_sample(&s, comms[j], (sharing)((way + j) % SHARINGS), &options);
            sample_free(&s);
        }
        finish_test("mirrors of mirrors lead back: %s", names[i]);
    }
}

// Weights and coordinates are members of structures on some ranks, and floats on some.
static void weights_are_read_by_type_and_stride(void) {
    typedef struct atom {
        double place[3];
        float radius, weight;
        double heavy;
    } atom;
    sample s = family_make(&families[family_named("uniform")], &weightings[1], 3, 200, 3);
    int order[200];
    if (comms[3] != MPI_COMM_NULL) {
        sample share;
        atom *atoms = (atom *)need(200, sizeof *atoms);
        float *narrow = (float *)need(200, sizeof *narrow);
        paradt_points points;
        paradt_mpi_triangulation t;
        paradt_triangulation expected;
        for (int i = 0; i < s.count; i++) s.w[i] = (double)(float)s.w[i];
        share = share_of(&s, DEALT, rank, 4, order);
        points = points_of(&share);
        for (int i = 0; i < share.count; i++) {
            memcpy(atoms[i].place, share.x + 3 * i, sizeof atoms[i].place);
            atoms[i].weight = narrow[i] = (float)share.w[i];
            atoms[i].heavy = share.w[i];
        }
        if (rank == 1 || rank == 2) {
            points = paradt_points_f64(atoms[0].place, (size_t)share.count, 3);
            points.stride = points.weight_stride = sizeof *atoms;
            points.weights = rank == 1 ? (const void *)&atoms[0].weight : (const void *)&atoms[0].heavy;
            points.weight_scalar = rank == 1 ? PARADT_F32 : PARADT_F64;
        }
        if (rank == 3) {
            points.weights = narrow;
            points.weight_scalar = PARADT_F32;
        }
        expected = serial(&s, order);
        if (paradt_mpi_triangulate(&t, comms[3], &points, NULL)) note(&s, 4, DEALT, t.error_text);
        else if (paradt_mpi_hash(&t, comms[3]) != paradt_hash(&expected)) note(&s, 4, DEALT, "other cells");
        paradt_mpi_free(&t);
        paradt_free(&expected);
        sample_free(&share);
        free(atoms);
        free(narrow);
    }
    sample_free(&s);
    finish_test("weights are read by type and stride");
}

typedef struct bar { // what a progress callback was told
    double last;
    int calls, falls;
} bar;

static int draw_bar(void *user, double fraction) {
    bar *b = (bar *)user;
    b->falls += !(fraction >= b->last && fraction <= 1.0);
    b->last = fraction;
    b->calls++;
    return 0;
}

// The weighted sphere takes several rounds, and by other methods than insertion several triangulations.
static void progress_never_falls_and_ends_at_one(void) {
    for (int way = 0; way < (PARADT_FLIP + 1) * 4; way++) { // the methods after it go the same way
        sample s = family_make(&families[family_named(way & 1 ? "sphere" : "uniform")], way & 1 ? &weightings[1] : NULL,
                               3, 3000, 3);
        paradt_mpi_options options;
        bar told;
        memset(&told, 0, sizeof told);
        memset(&options, 0, sizeof options);
        options.local.method = (paradt_method)(way >> 2);
        options.local.progress = draw_bar;
        options.local.user = &told;
        options.flags = way & 2 ? PARADT_MPI_REPLICATED : 0;
        if (comms[3] != MPI_COMM_NULL) {
            check_sample(&s, comms[3], BLOCKS, &options);
            if (told.falls) note(&s, 4, BLOCKS, "progress falls");
            if (told.calls < 3 || told.last < 1.0) note(&s, 4, BLOCKS, "progress does not end at 1");
        }
        sample_free(&s);
    }
    finish_test("progress never falls and ends at 1");
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
    char first[sizeof t->error_text];
    int good = status == expected && (!status || (t->error_rank == culprit && t->error_point == point && !t->cells));
    if (status) { // the same sentence on all ranks, and statistics
        memcpy(first, t->error_text, sizeof first);
        MPI_Bcast(first, (int)sizeof first, MPI_BYTE, 0, comms[3]);
        good = good && t->dim == -1 && first[0] && strcmp(first, t->error_text) == 0 && t->stats.seconds > 0;
    }
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
            good &= paradt_mpi_triangulate(rank == culprit ? NULL : &t, comms[3], &points, NULL) == PARADT_ERROR_ARGUMENT;
            if (rank != culprit) good &= t.error_rank == culprit && strstr(t.error_text, "out is NULL");
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

static void arguments_are_explained(void) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 400, 5);
    int order[400];
    sample share = share_of(&s, BLOCKS, rank % 4, 4, order);
    if (comms[3] != MPI_COMM_NULL) {
        static const char *const texts[] = {"points.dim is out of",
                                            "points.dim is not that of rank 0",
                                            "points.stride",
                                            "options.local.flags are not",
                                            "options.local.partition is",
                                            "points.weights is NULL",
                                            "other than PARADT_MPI",
                                            "points.data is NULL",
                                            "PARADT_FURTHEST_SITE, which ranks",
                                            "points.count is not that of rank 0",
                                            "the points are not those of rank 0"};
        for (int i = 0; i < (int)(sizeof texts / sizeof *texts); i++) {
            paradt_points points = points_of(&share);
            paradt_mpi_options options;
            paradt_mpi_triangulation t;
            memset(&options, 0, sizeof options);
            if (i == 5 && rank != 2) points.weights = share.x;
            if (i > 8) { // all ranks have all points
                points.data = s.x;
                points.count = 399;
                options.flags = PARADT_MPI_REPLICATED;
            }
            if (rank == 2) {
                if (i == 0) points.dim = 9;
                if (i == 1) points.dim = 2;
                if (i == 2) points.stride = 3;
                if (i == 3) options.local.flags = PARADT_FACETS;
                if (i == 4) options.local.partition = PARADT_UNIFORM;
                if (i == 6) options.flags = 8;
                if (i == 7) points.data = NULL;
                if (i == 8) options.local.flags = PARADT_FURTHEST_SITE;
                if (i == 9) points.count = 398;
                if (i == 10) points.data = s.x + 3;
            }
            if (paradt_mpi_triangulate(&t, comms[3], &points, &options) != PARADT_ERROR_ARGUMENT || t.error_rank != 2 ||
                !strstr(t.error_text, texts[i]))
                note(&s, 4, BLOCKS, texts[i]);
            paradt_mpi_free(&t);
        }
    }
    sample_free(&share);
    sample_free(&s);
    finish_test("each wrong argument is explained on all ranks");
}

// With PARADT_FULL_DIM points that lie in a flat are an error, but not where only some ranks' points do.
static void flat_points_can_be_an_error(void) {
    static const char *const names[] = {"hyperplane", "line", "all equal", "uniform"};
    for (int i = 0; i < 4; i++) {
        for (int way = 0; way < 4; way++) {
            sample s = family_make(&families[family_named(names[i])], way & 1 ? &weightings[1] : NULL, 3, 100, 5);
            int order[100], flat = i < 3;
            sample share = share_of(&s, ALL_ON_LAST, rank % 4, 4, order);
            paradt_points points = way & 2 ? points_of(&s) : points_of(&share);
            paradt_mpi_options options;
            paradt_mpi_triangulation t;
            memset(&options, 0, sizeof options);
            options.local.flags = PARADT_FULL_DIM;
            options.flags = way & 2 ? PARADT_MPI_REPLICATED : 0;
            if (comms[3] != MPI_COMM_NULL) {
                paradt_status status = paradt_mpi_triangulate(&t, comms[3], &points, &options);
                if (status != (flat ? PARADT_ERROR_FLAT : PARADT_OK)) note(&s, 4, ALL_ON_LAST, "another status");
                if (flat && !strstr(t.error_text, "all points")) note(&s, 4, ALL_ON_LAST, "no reason");
                if (t.dim != (flat ? -1 : 3)) note(&s, 4, ALL_ON_LAST, "another dimension");
                paradt_mpi_free(&t);
            }
            sample_free(&share);
            sample_free(&s);
        }
    }
    finish_test("flat points can be an error");
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
    finish_test("each allocation of rank %d fails%s%s", culprit, weighted ? ", weighted" : "",
                flags ? ", replicated" : "");
}

// No rank holds more memory than it reports, nor more than its limit, whether the limit suffices or not.
static void memory_stays_within_its_limit(int weighted, unsigned flags) {
    enum { PARTS = 16 };
    sample s = family_make(&families[family_named("uniform")], weighted ? &weightings[1] : NULL, 3, 4000, 5);
    int order[4000], sixteenth;
    sample share = share_of(&s, BLOCKS, rank % 3, 3, order);
    paradt_points points = flags ? points_of(&s) : points_of(&share);
    size_t said = 0;
    for (sixteenth = PARTS + 1; sixteenth > 2 && comms[2] != MPI_COMM_NULL; sixteenth -= sixteenth > PARTS ? 1 : 3) {
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
        if (!t.largest.needed_bytes != !status) note(&s, 3, BLOCKS, "what was needed is not told");
        if (t.stats.needed_bytes && t.stats.needed_bytes <= options.local.memory_limit)
            note(&s, 3, BLOCKS, "no more was needed than was allowed");
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

static void errors(void) {
    always_cut_anew = 1;
    same_cells_of_few_points();
    empty_communicator_of_one();
    errors_are_agreed_on();
    flat_points_can_be_an_error();
    for (int culprit = 0; culprit < 3; culprit++) {
        if (culprit == 0) failing_allocations_are_agreed_on(culprit, 0, 0); // one of the three ways each
        if (culprit == 1) failing_allocations_are_agreed_on(culprit, 1, 0);
        if (culprit == 2) failing_allocations_are_agreed_on(culprit, 1, PARADT_MPI_REPLICATED);
    }
    for (int way = 0; way < 4; way++) memory_stays_within_its_limit(way & 1, way & 2 ? PARADT_MPI_REPLICATED : 0);
    wrong_arguments_of_gathering_are_agreed_on();
    always_cut_anew = 0;
}

// The ranks whose points are all near a sphere take their distances from it back, as one rank has a point off the sphere.
static void one_point_is_off_the_sphere_of_the_others(void) {
    for (uint64_t seed = 1; seed <= 6; seed++) {
        sample s = family_make(&families[family_named("sphere")], NULL, 3, 3000, seed);
        s.x[0] = 0.1 * (double)seed;
        s.x[1] = s.x[2] = 0.2;
        check_sample(&s, comms[3], BLOCKS, NULL);
        sample_free(&s);
    }
    finish_test("one point is off the sphere of the others");
}

static void shares(void) {
    one_point_is_off_the_sphere_of_the_others();
    two_ranks_have_half_of_the_points_each();
    ranks_between_others_have_fewer_points();
    eight_ranks_hold_less_than_double_an_eighth();
}

static void options_and_callbacks(void) {
    mirrors_of_mirrors_across_ranks();
    weights_are_read_by_type_and_stride();
    progress_never_falls_and_ends_at_one();
    always_cut_anew = 1;
    same_cells_by_other_options();
    arguments_are_explained();
    always_cut_anew = 0;
}

static const struct {
    const char *name;
    void (*run)(void);
} groups[] = {
    {"families", same_cells_on_families}, {"many", same_cells_of_many_points}, {"shares", shares},
    {"options", options_and_callbacks},   {"weights", weights_and_replicas},   {"errors", errors},
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
