// Shared by the programs that use.sh compares: those that locate, insert, remove and compute Voronoi diagrams.
//
//     PROGRAM NAME POINTS QUERIES
//
// builds what it needs of the points, prints a line, and then obeys the lines "OPERATION COUNT ROUND" of its standard
// input. For each it prints a line of JSON: the operation, the count, CPU seconds, a check and the growth of the resident
// set. Two programs that get the same lines do the same to the same points, so their checks are equal if their answers
// are. So use.sh runs two programs by turns, each with its own triangulation in memory. A program that does not know an
// operation says so; with a count of 0 nothing is done.
//
// Locating takes other queries in each round, from the end of the file; inserting takes them from its beginning, and
// removing and moving go on where they ended, too.
#ifndef BENCH_USE_H
#define BENCH_USE_H

#include <math.h>

#include "bench.h"

typedef struct use {
    bench_points points;
    bench_points queries;
    size_t *order;     // [points.count] the order in which points are removed, and from the end moved
    size_t asked;      // the first query that locating takes
    size_t inserted;   // queries inserted
    size_t removed;    // points removed
    size_t moved;      // points moved
    size_t count;      // of the current operation
    size_t *which;     // [count] queries or points of the current operation
    double *places;    // [count][dim] their coordinates; of a move: new ones
    bench_clock clock; // of the current operation
    uint64_t check;
    uint64_t state; // of random numbers
} use;

// An operation: prepares, calls use_start, works, calls use_stop, and computes u->check.
typedef struct use_operation {
    const char *name;
    void (*run)(use *u);
} use_operation;

static inline uint64_t use_random(use *u) {
    uint64_t z = u->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

static inline void *use_memory(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory)
        bench_fail("use", "no memory");
    return memory;
}

static inline void use_start(use *u) { u->clock = bench_start(&u->queries); }
static inline void use_stop(use *u) { bench_stop(&u->clock); }

static inline const double *use_place(const use *u, size_t i) { return u->places + i * (size_t)u->points.dim; }

// --- which points ----------------------------------------------------------------------------------------------------

// Fills which and places with the next queries. cursor: number of queries used before; moves on
static inline void use_queries(use *u, size_t *cursor) {
    size_t d = (size_t)u->queries.dim;
    for (size_t i = 0; i < u->count; i++) {
        u->which[i] = (*cursor)++ % u->queries.count;
        memcpy(u->places + i * d, u->queries.coordinates + u->which[i] * d, d * sizeof(double));
    }
}

// Fills which with the next points to remove.
static inline void use_removals(use *u) {
    if (u->removed + u->moved + u->count > u->points.count)
        bench_fail("use", "no points are left to remove");
    for (size_t i = 0; i < u->count; i++)
        u->which[i] = u->order[u->removed++];
}

// Fills which with the next points to move, and places with where they go: each coordinate by up to a tenth of the
// spacing.
static inline void use_moves(use *u) {
    int d = u->points.dim;
    double spacing = pow((double)u->points.count, -1.0 / d);
    if (u->removed + u->moved + u->count > u->points.count)
        bench_fail("use", "no points are left to move");
    for (size_t i = 0; i < u->count; i++) {
        u->which[i] = u->order[u->points.count - ++u->moved];
        for (int k = 0; k < d; k++) {
            double way = (double)(use_random(u) >> 11) * 0x1p-53 * 2 - 1;
            u->places[i * (size_t)d + (size_t)k] =
                u->points.coordinates[u->which[i] * (size_t)d + (size_t)k] + 0.1 * spacing * way;
        }
    }
}

typedef struct use_key {
    uint64_t key;
    size_t which;
} use_key;

static inline int use_compare(const void *a, const void *b) {
    const use_key *s = (const use_key *)a, *t = (const use_key *)b;
    return s->key < t->key ? -1 : s->key > t->key ? 1 : s->which < t->which ? -1 : s->which > t->which;
}

// Returns the place of a point of the unit cube on Hilbert's curve (Skilling, "Programming the Hilbert curve", 2004).
static inline uint64_t use_hilbert(const double *place, int d) {
    const int bits = d == 2 ? 24 : d == 3 ? 20 : 60 / d;
    uint32_t x[PARADT_MAX_DIM], top = (uint32_t)1 << (bits - 1), flip = 0;
    uint64_t key = 0;
    for (int k = 0; k < d; k++) {
        double scaled = place[k] * (double)top * 2;
        x[k] = scaled < 0 ? 0 : scaled >= (double)top * 2 ? 2 * top - 1 : (uint32_t)scaled;
    }
    for (uint32_t q = top; q > 1; q >>= 1)
        for (int k = 0; k < d; k++) {
            uint32_t low = q - 1, t = (x[0] ^ x[k]) & low;
            if (x[k] & q) {
                x[0] ^= low;
            } else {
                x[0] ^= t;
                x[k] ^= t;
            }
        }
    for (int k = 1; k < d; k++)
        x[k] ^= x[k - 1];
    for (uint32_t q = top; q > 1; q >>= 1)
        if (x[d - 1] & q)
            flip ^= q - 1;
    for (int b = bits - 1; b >= 0; b--)
        for (int k = 0; k < d; k++)
            key = key << 1 | ((x[k] ^ flip) >> b & 1);
    return key;
}

// Sorts which and places along the curve.
static inline void use_sort(use *u) {
    size_t d = (size_t)u->points.dim;
    use_key *keys = (use_key *)use_memory(u->count, sizeof *keys);
    for (size_t i = 0; i < u->count; i++) {
        keys[i].key = use_hilbert(use_place(u, i), u->points.dim);
        keys[i].which = u->which[i];
    }
    qsort(keys, u->count, sizeof *keys, use_compare);
    for (size_t i = 0; i < u->count; i++) {
        u->which[i] = keys[i].which;
        memcpy(u->places + i * d, u->queries.coordinates + u->which[i] * d, d * sizeof(double));
    }
    free(keys);
}

// --- the checks ------------------------------------------------------------------------------------------------------

// Adds a cell, or any set of points, to the check, whatever the order of its points.
static inline void use_check_cell(use *u, const double *const *vertices, int count) {
    uint64_t names[PARADT_MAX_DIM + 1];
    for (int i = 0; i < count; i++)
        names[i] = bench_mix(vertices[i], u->points.dim);
    u->check += paradt_hash_cell(names, count);
}

// --- the program -----------------------------------------------------------------------------------------------------

static inline void use_obey(use *u, const char *name, const use_operation *operations, size_t operation_count,
                            const char *line) {
    char wanted[64] = "";
    size_t i;
    if (sscanf(line, "%63s %zu %zu", wanted, &u->count, &u->asked) != 3)
        bench_fail("not an operation, a count and a round", line);
    u->asked = u->queries.count - u->asked * u->count % u->queries.count;
    u->check = 0;
    memset(&u->clock, 0, sizeof u->clock);
    for (i = 0; i < operation_count && strcmp(operations[i].name, wanted); i++)
        continue;
    if (i == operation_count) {
        printf("{\"unknown\":\"%s\"}\n", wanted);
        fflush(stdout);
        return;
    }
    if (u->count) {
        u->which = (size_t *)use_memory(u->count, sizeof *u->which);
        u->places = (double *)use_memory(u->count * (size_t)u->points.dim, sizeof *u->places);
        operations[i].run(u);
        free(u->which);
        free(u->places);
    }
    printf("{\"name\":\"%s\",\"operation\":\"%s\",\"count\":%zu,\"seconds\":%.6f,\"check\":\"%016" PRIx64
           "\",\"bytes\":%" PRIu64 "}\n",
           name, wanted, u->count, u->clock.cpu_seconds, u->check, u->clock.rss_peak - u->clock.rss_before);
    fflush(stdout);
}

// build: of the points; the program exits when standard input ends
static inline int use_main(int argc, char **argv, void (*build)(use *u), const use_operation *operations,
                           size_t operation_count) {
    use u;
    char line[128];
    memset(&u, 0, sizeof u);
    if (argc != 4)
        bench_fail(argv[0], "usage: NAME POINTS QUERIES");
    u.points = bench_read(argv[2]);
    u.queries = bench_read(argv[3]);
    if (u.points.dim != u.queries.dim || !u.queries.count)
        bench_fail(argv[3], "not of the dimension of the points");
    u.order = (size_t *)use_memory(u.points.count, sizeof *u.order);
    for (size_t i = 0; i < u.points.count; i++) {
        size_t k = (size_t)(use_random(&u) % (i + 1));
        u.order[i] = u.order[k];
        u.order[k] = i;
    }
    build(&u);
    printf("ready\n");
    fflush(stdout);
    while (fgets(line, sizeof line, stdin))
        use_obey(&u, argv[1], operations, operation_count, line);
    return 0;
}

#endif
