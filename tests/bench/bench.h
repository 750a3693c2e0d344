// Shared by the programs of the benchmark: arguments, point files, clocks, the peak of the resident set, the way from
// coordinates to point indices, and the line of JSON that each program prints. For Linux, because of the resident set.
//
//     PROGRAM [options] POINTS
//         --name NAME      name of the program in the line
//         --jobs J         number of threads, in programs that have threads
//         --calls K        cut the points into K sets of equal size and triangulate each, to time small sets; cells and
//                          hash are those of the last set
//         --hash           add the hash of the cells, which is computed after the measurement
//         --method NAME, --regions K, --no-neighbors (paradt only)
//         --copies C       run C processes concurrently, each with 1/C of the points (paradt only)
//
// A point file has a header of 32 bytes: "paradtp1", then the number of points, the dimension and the number of weights
// as little-endian 64-bit integers. The coordinates follow, point by point, and then the weights, as little-endian
// doubles.
#ifndef BENCH_H
#define BENCH_H

#include <fcntl.h>
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "paradt.h"

#define BENCH_MAGIC_BYTES                                                                                              \
    { 'p', 'a', 'r', 'a', 'd', 't', 'p', '1' }

typedef struct bench_header {
    char magic[8];
    uint64_t count;
    uint64_t dim;
    uint64_t weight_count; // 0 or count
} bench_header;

typedef struct bench_points {
    size_t count;
    int dim;
    const double *coordinates; // [count][dim]
    const double *weights;     // [count] or NULL
} bench_points;

typedef struct bench_arguments {
    const char *name;
    const char *path;
    const char *method;
    size_t regions;
    size_t jobs;
    size_t calls;
    size_t copies;
    int hash;
    int no_neighbors;
} bench_arguments;

typedef struct bench_clock {
    double seconds;
    double cpu_seconds;  // of all threads
    uint64_t rss_before; // resident bytes just before the work, including the input
    uint64_t rss_peak;   // largest number of resident bytes during the work
} bench_clock;

// Prints an error and exits.
static inline void bench_fail(const char *what, const char *detail) {
    fprintf(stderr, "%s: %s\n", what, detail);
    exit(1);
}

static inline bench_arguments bench_parse(int argc, char **argv) {
    bench_arguments a;
    memset(&a, 0, sizeof a);
    a.name = argv[0];
    a.method = "auto";
    a.jobs = 1;
    a.calls = 1;
    a.copies = 1;
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (!strcmp(argv[i], "--hash")) {
            a.hash = 1;
        } else if (!strcmp(argv[i], "--no-neighbors")) {
            a.no_neighbors = 1;
        } else if (strncmp(argv[i], "--", 2)) {
            a.path = argv[i];
        } else {
            i++;
            if (!strcmp(argv[i - 1], "--name"))
                a.name = value;
            else if (!strcmp(argv[i - 1], "--method"))
                a.method = value;
            else if (!strcmp(argv[i - 1], "--jobs"))
                a.jobs = (size_t)strtoull(value, NULL, 10);
            else if (!strcmp(argv[i - 1], "--calls"))
                a.calls = (size_t)strtoull(value, NULL, 10);
            else if (!strcmp(argv[i - 1], "--copies"))
                a.copies = (size_t)strtoull(value, NULL, 10);
            else if (!strcmp(argv[i - 1], "--regions"))
                a.regions = (size_t)strtoull(value, NULL, 10);
            else
                bench_fail(argv[i - 1], "no such option");
        }
    }
    if (!a.path || !a.jobs || !a.calls || !a.copies)
        bench_fail(argv[0], "usage: [options] POINTS");
    return a;
}

// Maps a point file. The file is never unmapped, so the input is in rss_before.
static inline bench_points bench_read(const char *path) {
    int file = open(path, O_RDONLY);
    struct stat status;
    if (file < 0 || fstat(file, &status))
        bench_fail(path, "can't be read");
    size_t bytes = (size_t)status.st_size;
    void *map = bytes ? mmap(NULL, bytes, PROT_READ, MAP_PRIVATE, file, 0) : MAP_FAILED;
    close(file);
    static const char magic[8] = BENCH_MAGIC_BYTES;
    bench_header header;
    if (map == MAP_FAILED || bytes < sizeof header)
        bench_fail(path, "is not a point file");
    memcpy(&header, map, sizeof header);
    if (memcmp(header.magic, magic, sizeof magic) || header.dim < 1 || header.dim > PARADT_MAX_DIM ||
        bytes != sizeof header + (header.count * header.dim + header.weight_count) * sizeof(double))
        bench_fail(path, "is not a point file");
    bench_points points;
    points.count = (size_t)header.count;
    points.dim = (int)header.dim;
    points.coordinates = (const double *)map + sizeof header / sizeof(double);
    points.weights = header.weight_count ? points.coordinates + header.count * header.dim : NULL;
    return points;
}

// Returns the ith of `calls` sets of equal size.
static inline bench_points bench_set(const bench_points *points, size_t calls, size_t i) {
    bench_points set = *points;
    set.count = points->count / calls;
    set.coordinates += i * set.count * (size_t)points->dim;
    if (set.weights)
        set.weights += i * set.count;
    return set;
}

static inline double bench_now(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Keeps a processor busy. All threads of a program do this concurrently before the clock starts: a system may start a
// new thread on the processor of its creator, and leave it there for tens of milliseconds.
static inline void bench_warm_up(void) {
    double end = bench_now(CLOCK_MONOTONIC) + 0.05;
    while (bench_now(CLOCK_MONOTONIC) < end)
        continue;
}

// Returns the value of a line of /proc/self/status, in bytes. field: the name with its colon
static inline uint64_t bench_memory(const char *field) {
    FILE *file = fopen("/proc/self/status", "r");
    char line[256];
    unsigned long long kilobytes = 0;
    while (file && fgets(line, sizeof line, file))
        if (!strncmp(line, field, strlen(field)))
            kilobytes = strtoull(line + strlen(field), NULL, 10);
    if (file)
        fclose(file);
    return (uint64_t)kilobytes * 1024;
}

// Starts the clock. Touches the mapped points before, so that the time does not include reading the file.
static inline bench_clock bench_start(const bench_points *points) {
    bench_clock clock;
    volatile double touched = 0;
    for (size_t i = 0; i < points->count * (size_t)points->dim; i += 256)
        touched = touched + points->coordinates[i];
    FILE *file = fopen("/proc/self/clear_refs", "w");
    if (file) {
        fputs("5", file); // resets VmHWM
        fclose(file);
    }
    clock.rss_before = bench_memory("VmRSS:");
    clock.rss_peak = 0;
    clock.cpu_seconds = -bench_now(CLOCK_PROCESS_CPUTIME_ID);
    clock.seconds = -bench_now(CLOCK_MONOTONIC);
    return clock;
}

static inline void bench_stop(bench_clock *clock) {
    clock->seconds += bench_now(CLOCK_MONOTONIC);
    clock->cpu_seconds += bench_now(CLOCK_PROCESS_CPUTIME_ID);
    clock->rss_peak = bench_memory("VmHWM:");
}

// --- from coordinates to point indices -------------------------------------------------------------------------------
// Libraries sort, merge and number points in their own ways, so each vertex is found by its coordinates. Of points with
// equal coordinates the index is that of the largest weight, and of equal weights the smallest.

typedef struct bench_index {
    const bench_points *points;
    size_t *slots; // hash table with open addressing: index of a point + 1; 0: empty
    size_t mask;   // number of slots - 1
} bench_index;

// Returns a hash of the coordinates.
static inline uint64_t bench_mix(const double *x, int dim) {
    uint64_t h = 0;
    for (int i = 0; i < dim; i++) {
        double value = x[i] + 0.0; // -0.0 becomes 0.0
        uint64_t bits;
        memcpy(&bits, &value, sizeof bits);
        h = (h ^ bits) * UINT64_C(0x9e3779b97f4a7c15);
        h ^= h >> 29;
    }
    return h;
}

// Returns the slot of the point with these coordinates, or the empty slot where it belongs.
static inline size_t *bench_slot(const bench_index *index, const double *x) {
    int dim = index->points->dim;
    size_t slot = (size_t)bench_mix(x, dim) & index->mask;
    for (; index->slots[slot]; slot = (slot + 1) & index->mask) {
        const double *y = index->points->coordinates + (index->slots[slot] - 1) * (size_t)dim;
        int k = 0;
        while (k < dim && x[k] == y[k])
            k++;
        if (k == dim)
            break;
    }
    return &index->slots[slot];
}

static inline bench_index bench_index_make(const bench_points *points) {
    bench_index index;
    index.points = points;
    index.mask = 15;
    while (index.mask < 2 * points->count)
        index.mask = 2 * index.mask + 1;
    index.slots = (size_t *)calloc(index.mask + 1, sizeof *index.slots);
    if (!index.slots)
        bench_fail("index", "no memory");
    for (size_t i = 0; i < points->count; i++) {
        size_t *slot = bench_slot(&index, points->coordinates + i * (size_t)points->dim);
        if (!*slot || (points->weights && points->weights[i] > points->weights[*slot - 1]))
            *slot = i + 1;
    }
    return index;
}

// Returns the index of the point with these coordinates.
static inline uint64_t bench_index_of(const bench_index *index, const double *x) {
    size_t slot = *bench_slot(index, x);
    if (!slot)
        bench_fail("hash", "a vertex is not one of the points");
    return (uint64_t)(slot - 1);
}

static inline void bench_index_free(bench_index *index) {
    free(index->slots);
}

// --- the line --------------------------------------------------------------------------------------------------------

// Prints the line. hash: NULL: not wanted; extra: further fields, each after a comma
static inline void bench_print(const bench_arguments *a, const bench_points *points, const bench_clock *clock,
                               uint64_t cells, const uint64_t *hash, const char *extra) {
    printf("{\"name\":\"%s\",\"n\":%zu,\"d\":%d,\"jobs\":%zu,\"calls\":%zu,\"cells\":%" PRIu64 ",\"seconds\":%.6f,"
           "\"cpu_seconds\":%.6f,\"peak_rss_bytes\":%" PRIu64 ",\"rss_before_bytes\":%" PRIu64,
           a->name, points->count / a->calls, points->dim, a->jobs, a->calls, cells, clock->seconds, clock->cpu_seconds,
           clock->rss_peak, clock->rss_before);
    if (hash)
        printf(",\"hash\":\"%016" PRIx64 "\"", *hash);
    printf("%s}\n", extra);
}

#endif
