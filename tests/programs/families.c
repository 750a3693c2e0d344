// Writes samples of every family to a file, bit for bit. Programs built with hostile flags read them instead of computing points.
// Usage: families FILE. A record is {dim, count, weighted, single} as int32, the name, the coordinates as floats or doubles, and
// the weights.
#include "families.h"

static void put(FILE *file, const void *data, size_t size) {
    if (size && fwrite(data, size, 1, file) != 1) {
        perror("families");
        exit(1);
    }
}

static void put_sample(FILE *file, const sample *s, int single) {
    int32_t head[4] = {s->dim, s->count, s->w != NULL, single};
    size_t coordinates = (size_t)(s->dim * s->count);
    put(file, head, sizeof head);
    put(file, s->name, sizeof s->name);
    for (size_t i = 0; single && i < coordinates; i++) {
        float x = (float)s->x[i];
        put(file, &x, sizeof x);
    }
    if (!single)
        put(file, s->x, coordinates * sizeof(double));
    if (s->w)
        put(file, s->w, (size_t)s->count * sizeof(double));
}

int main(int argc, char **argv) {
    static const int points_in[] = {0, 0, 60, 60, 20, 14, 11, 10, 10}, few[] = {0, 0, 40, 30, 14, 10, 9, 9, 10};
    FILE *file = argc == 2 ? fopen(argv[1], "wb") : NULL;
    if (!file) {
        fprintf(stderr, "usage: families FILE\n");
        return 2;
    }
    for (int f = 0; f < FAMILY_COUNT; f++)
        for (int dim = 2; dim <= CELLS_MAX_DIM; dim++)
            for (int turn = 0; turn < 2; turn++) {
                const weighting *w = &weightings[turn ? 1 + (f + dim) % (WEIGHTING_COUNT - 1) : 0];
                int extremes = families[f].extremes || w->extremes;
                if (extremes && dim > 6)
                    continue;
                sample s = family_make(&families[f], w, dim, extremes ? few[dim] : points_in[dim], 3);
                put_sample(file, &s, 0);
                sample_free(&s);
            }
    // Floats, some of them subnormal: a flag can spoil their conversion to double.
    for (int f = 0; f < FAMILY_COUNT; f++)
        for (int dim = 2; dim <= 3; dim++) {
            sample s = family_make(&families[f], NULL, dim, few[dim], 4);
            for (int i = 0; i < s.count * dim; i++)
                s.x[i] = families[f].extremes ? ldexp(frexp(s.x[i], &(int){0}), -130) : s.x[i];
            snprintf(s.name, sizeof s.name, "floats of %s, d = %d", families[f].name, dim);
            put_sample(file, &s, 1);
            sample_free(&s);
        }
    return fclose(file) == 0 ? 0 : 1;
}
