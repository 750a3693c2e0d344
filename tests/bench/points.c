// points gen:KIND:N:SEED DIM WEIGHTED FILE: a set of points as a point file (see bench.h); WEIGHTED: 0 or 1.
#define PARADT_POINTS_IMPLEMENTATION
#include "examples/paradt_points.h"

#include "bench.h"

enum { BLOCK = 4096 };

static void write_or_fail(const void *data, size_t size, size_t count, FILE *file, const char *path) {
    if (fwrite(data, size, count, file) != count)
        bench_fail(path, "can't be written");
}

int main(int argc, char **argv) {
    if (argc != 5)
        bench_fail("usage", "points gen:KIND:N:SEED DIM WEIGHTED FILE");
    const char *path = argv[4];
    paradt_gen_spec spec;
    const char *wrong = paradt_gen_parse(&spec, argv[1]);
    int dim = atoi(argv[2]);
    if (wrong || dim < 2 || dim > PARADT_GEN_MAX_DIM)
        bench_fail(argv[1], wrong ? wrong : "the dimension is not 2 to 8");
    bench_header header = {BENCH_MAGIC_BYTES, spec.count, (uint64_t)dim, atoi(argv[3]) ? spec.count : 0};
    FILE *file = fopen(path, "wb");
    if (!file)
        bench_fail(path, "can't be written");
    write_or_fail(&header, sizeof header, 1, file, path);
    static double block[BLOCK * PARADT_GEN_MAX_DIM];
    for (size_t first = 0; first < spec.count; first += BLOCK) {
        size_t count = spec.count - first < BLOCK ? spec.count - first : BLOCK;
        paradt_gen_points(&spec, dim, first, count, block);
        write_or_fail(block, (size_t)dim * sizeof(double), count, file, path);
    }
    for (size_t first = 0; first < header.weight_count; first += BLOCK) {
        size_t count = spec.count - first < BLOCK ? spec.count - first : BLOCK;
        paradt_gen_weights(&spec, dim, first, count, block);
        write_or_fail(block, sizeof(double), count, file, path);
    }
    if (fclose(file))
        bench_fail(path, "can't be written");
    return 0;
}
