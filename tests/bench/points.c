// points gen:KIND:N:SEED|INPUT DIM WEIGHTED FILE: writes a set of points as a point file (see bench.h). INPUT: a file
// that paradt reads, with DIM coordinates or more; WEIGHTED: 0 or 1
#define PARADT_IO_IMPLEMENTATION
#include "examples/paradt_io.h"

#include "bench.h"

enum { BLOCK = 4096 };

static void write_or_fail(const void *data, size_t size, size_t count, FILE *file, const char *path) {
    if (fwrite(data, size, count, file) != count)
        bench_fail(path, "can't be written");
}

// Generates the points block by block, so that large sets need little memory.
static void write_generated(const paradt_gen_spec *spec, int dim, int weighted, FILE *file, const char *path) {
    static double block[BLOCK * PARADT_GEN_MAX_DIM];
    bench_header header = {BENCH_MAGIC_BYTES, spec->count, (uint64_t)dim, weighted ? spec->count : 0};
    write_or_fail(&header, sizeof header, 1, file, path);
    for (size_t first = 0; first < spec->count; first += BLOCK) {
        size_t count = spec->count - first < BLOCK ? spec->count - first : BLOCK;
        paradt_gen_points(spec, dim, first, count, block);
        write_or_fail(block, (size_t)dim * sizeof(double), count, file, path);
    }
    for (size_t first = 0; first < header.weight_count; first += BLOCK) {
        size_t count = spec->count - first < BLOCK ? spec->count - first : BLOCK;
        paradt_gen_weights(spec, dim, first, count, block);
        write_or_fail(block, sizeof(double), count, file, path);
    }
}

static void write_read(const char *input, int dim, int weighted, FILE *file, const char *path) {
    paradt_io_points points;
    paradt_io_error error;
    paradt_io_want want = {dim, weighted};
    if (!paradt_io_read(&points, input, &want, &error))
        bench_fail(input, error.text);
    bench_header header = {BENCH_MAGIC_BYTES, points.count, (uint64_t)dim, points.weights ? points.count : 0};
    write_or_fail(&header, sizeof header, 1, file, path);
    write_or_fail(points.coordinates, (size_t)dim * sizeof(double), points.count, file, path);
    if (points.weights)
        write_or_fail(points.weights, sizeof(double), points.count, file, path);
    free(points.coordinates);
    free(points.weights);
}

int main(int argc, char **argv) {
    if (argc != 5)
        bench_fail("usage", "points gen:KIND:N:SEED|INPUT DIM WEIGHTED FILE");
    const char *path = argv[4];
    int dim = atoi(argv[2]), weighted = atoi(argv[3]), generated = !strncmp(argv[1], "gen:", 4);
    paradt_gen_spec spec;
    const char *wrong = generated ? paradt_gen_parse(&spec, argv[1]) : NULL;
    if (wrong || dim < 2 || dim > PARADT_GEN_MAX_DIM)
        bench_fail(argv[1], wrong ? wrong : "the dimension is not 2 to 8");
    FILE *file = fopen(path, "wb");
    if (!file)
        bench_fail(path, "can't be written");
    if (generated)
        write_generated(&spec, dim, weighted, file, path);
    else
        write_read(argv[1], dim, weighted, file, path);
    if (fclose(file))
        bench_fail(path, "can't be written");
    return 0;
}
