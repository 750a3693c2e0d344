// Prints, for every sample in a file, the hash of its triangulation by every method, and after its points have moved and it has been
// repaired, and what the certificate says. The output must be the same when it is built with flags, or run in modes, that break careless floating-point code.
// Usage: hashes FILE SHARE [MODE...]
//   SHARE            -1: prints all lines; 0 to 10: every eleventh line, beginning with this one
//   MODE             see modes.h
#ifndef HASHES_LINKED // else the implementation is in another object
#define PARADT_IMPLEMENTATION
#define PARADT_NO_LOCATOR // not called here, and compiled with many sets of flags
#define PARADT_NO_DYNAMIC
#define PARADT_NO_VORONOI
#define PARADT_NO_MEASURES
#endif
#include "paradt.h"

#include "modes.h"

// Eleven has no common divisor with the number of lines of a sample, so every share has lines of all methods.
enum { SHARES = 11 };

// Prints the end of a line, what came of a call, and frees the triangulation.
static void print_result(paradt_triangulation *t, paradt_status status, const paradt_points *points,
                         const paradt_options *options) {
    paradt_fault fault;
    printf("%s", paradt_status_string(status));
    if (status == PARADT_OK) {
        uint64_t hash = paradt_hash(t);
        status = paradt_check(t, points, options, &fault);
        printf(", dim %d, %lu cells, hash %08lx%08lx, certificate: %s", t->dim, (unsigned long)t->cell_count,
               (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu), paradt_status_string(status));
        paradt_free(t);
    }
    printf("\n");
}

static void print_hash(const char *name, const paradt_points *points, int method, int regions) {
    paradt_options options;
    paradt_triangulation t;
    memset(&options, 0, sizeof options);
    options.method = (paradt_method)method;
    options.regions = (size_t)regions;
    printf("%s, %s, %d regions: ", name, paradt_method_string(options.method), regions);
    print_result(&t, paradt_triangulate(&t, points, &options), points, &options);
}

// Moves coordinates by less than 2^-exponent of their size: in their bits, so that the mode plays no part.
static void move(void *data, size_t coordinates, int single, int exponent) {
    uint64_t moved = 1, bits;
    uint32_t few;
    size_t i;
    for (i = 0; i < coordinates; i++) {
        moved = moved * 6364136223846793005u + 1442695040888963407u;
        if (single) {
            memcpy(&few, (float *)data + i, sizeof few);
            few ^= (uint32_t)(moved >> (41 + exponent));
            memcpy((float *)data + i, &few, sizeof few);
        } else {
            memcpy(&bits, (double *)data + i, sizeof bits);
            bits ^= moved >> (12 + exponent);
            memcpy((double *)data + i, &bits, sizeof bits);
        }
    }
}

enum { MOVES = 2 };

static void print_repaired(const char *name, const paradt_points *points, size_t coordinates, int number) {
    static const int exponents[MOVES] = {8, 20};
    size_t size = coordinates * (points->scalar == PARADT_F32 ? sizeof(float) : sizeof(double));
    void *data = malloc(size + 1);
    paradt_points moved = *points;
    paradt_options options;
    paradt_triangulation t;
    paradt_status status;
    if (!data)
        exit(1);
    memset(&options, 0, sizeof options);
    options.flags = number ? PARADT_FACETS : 0;
    memcpy(data, points->data, size);
    move(data, coordinates, points->scalar == PARADT_F32, exponents[number]);
    moved.data = data;
    status = paradt_triangulate(&t, points, &options);
    if (!status)
        status = paradt_repair(&t, &moved, &options, NULL);
    printf("%s, repaired after a move by 2^-%d: ", name, exponents[number]);
    print_result(&t, status, &moved, &options);
    free(data);
}

int main(int argc, char **argv) {
    int32_t head[4];
    FILE *file = argc > 1 ? fopen(argv[1], "rb") : NULL;
    int share = argc > 2 ? atoi(argv[2]) : -1, line = 0, i;
    if (!file || argc < 3) {
        fprintf(stderr, "usage: hashes FILE SHARE [MODE...]\n");
        return 2;
    }
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // if the run is stopped, the output shows where
    for (i = 3; i < argc; i++)
        enter(argv[i]);
    while (get_head(file, head)) {
        paradt_points points = {0};
        char *name = (char *)get(file, 96, 1);
        size_t count = (size_t)head[1];
        void *data = get(file, count * (size_t)head[0], head[3] ? sizeof(float) : sizeof(double));
        double *weights = head[2] ? (double *)get(file, count, sizeof(double)) : NULL;
        points.data = data;
        points.count = count;
        points.dim = head[0];
        points.scalar = head[3] ? PARADT_F32 : PARADT_F64;
        points.weights = weights;
        for (i = 0; i < 2 * PARADT_METHOD_COUNT + MOVES; i++, line++) {
            if (share >= 0 && line % SHARES != share)
                continue;
            if (i < 2 * PARADT_METHOD_COUNT)
                print_hash(name, &points, i / 2, i % 2 ? 3 : 0);
            else
                print_repaired(name, &points, count * (size_t)head[0], i - 2 * PARADT_METHOD_COUNT);
        }
        free(weights);
        free(data);
        free(name);
    }
    fclose(file);
    return 0;
}
