// Every method gives exactly the cells of the definition (oracle.h), in every dimension, with and without weights, in any input
// order, divided into regions or not.
#include "harness.h"

enum { LARGEST_DIM = SANITIZED ? 5 : 8 };
static const int points_in[] = {0, 0, 14, 14, 12, 11, 10, 10, 11};
static const int few_points_in[] = {0, 0, 10, 10, 10, 10, 10, 10, 11}; // where determinants have thousands of bits

// A sample and its cells by the definition. Made when first needed, and used for all methods.
typedef struct answer {
    sample s;
    cell_set cells;
    int dim;
    int made;
} answer;
static answer answers[FAMILY_COUNT][WEIGHTING_COUNT][LARGEST_DIM + 1];

static const answer *answer_to(int f, int w, int dim) {
    answer *a = &answers[f][w][dim];
    if (!a->made) {
        int count = families[f].extremes || weightings[w].extremes ? few_points_in[dim] : points_in[dim];
        a->s = family_make(&families[f], &weightings[w], dim, count, (uint64_t)(1 + f + 100 * w));
        a->dim = oracle_triangulate(&a->s, &a->cells, NULL);
        a->made = 1;
    }
    return a;
}

static void expect_answer(const answer *a, const paradt_options *options) {
    const char *how = how_text(options);
    paradt_triangulation t = triangulate_and_verify(&a->s, options, how);
    cell_set found = cells_of(&t, NULL);
    if (t.dim != a->dim)
        fail_on_sample(&a->s, "the affine dimension is wrong");
    fail_if_different(&a->s, how, &a->cells, &found);
    cells_free(&found);
    paradt_free(&t);
}

// Expects the same cells of the same points in another order.
static void expect_answer_shuffled(const answer *a, const paradt_options *options) {
    int *order = (int *)need((size_t)a->s.count, sizeof(int)), *leader = (int *)need((size_t)a->s.count, sizeof(int));
    uint64_t seed = 77;
    shuffle(order, a->s.count, &seed);
    sample_leaders(&a->s, leader, NULL);
    sample shuffled = sample_pick(&a->s, order, a->s.count);
    for (int i = 0; i < a->s.count; i++)
        order[i] = leader[order[i]];
    paradt_triangulation t = triangulate_and_verify(&shuffled, options, how_text(options));
    cell_set found = cells_of(&t, order);
    fail_if_different(&a->s, "shuffled input", &a->cells, &found);
    cells_free(&found);
    paradt_free(&t);
    sample_free(&shuffled);
    free(leader);
    free(order);
}

// state: method * FAMILY_COUNT + family
static void equals_the_definition(void **state) {
    int row = (int)(intptr_t)*state, f = row % FAMILY_COUNT;
    for (int w = 0; w < WEIGHTING_COUNT; w++)
        for (int dim = 2; dim <= LARGEST_DIM; dim++) {
            // Determinants of thousands of bits are slow, so high dimensions get few of the weightings.
            int extremes = families[f].extremes || weightings[w].extremes;
            if (extremes && ((dim > 5 && (w != 2 * (dim % 3) || (f + dim) % 3)) || (dim > 3 && dim <= 5 && (f + w + dim) % 3) ||
                             (is_quick() && dim > 3)))
                continue;
            if (dim > 5 && (row / FAMILY_COUNT + f + w + dim) % 3) // some methods in each of the highest dimensions
                continue;
            const answer *a = answer_to(f, w, dim);
            paradt_options options = {0};
            options.method = (paradt_method)(row / FAMILY_COUNT);
            expect_answer(a, &options);
            expect_answer_shuffled(a, &options);
            options.regions = (size_t)(2 + (f + w + dim) % 8);
            options.partition = (paradt_partition)((f + w + dim / 2 + options.method) % 2);
            expect_answer(a, &options);
        }
}

// Up to dim + 2 points, in every dimension: random corners of a cube, or random sites of a small lattice.
static void a_few_points_equal_the_definition(void **state) {
    paradt_options options = {0};
    (void)state;
    for (int method = 0; method < PARADT_METHOD_COUNT; method++)
        for (int dim = 2; dim <= LARGEST_DIM; dim++)
            for (int count = 0; count <= dim + 2; count++)
                for (uint64_t seed = 1; seed <= 12; seed++) {
                    answer a = {{{0}, 0, 0, NULL, NULL}, {0, 0, NULL}, 0, 1};
                    snprintf(a.s.name, sizeof a.s.name, "%d points of a small lattice, d = %d, seed %d", count, dim, (int)seed);
                    sample s = sample_make(a.s.name, dim, count);
                    uint64_t random = seed;
                    if (seed % 2)
                        s.w = (double *)need((size_t)count, sizeof(double));
                    for (int i = 0; i < count * dim; i++)
                        s.x[i] = random_below(&random, seed % 3 ? 2 : 3);
                    for (int i = 0; s.w && i < count; i++)
                        s.w[i] = random_below(&random, 2);
                    a.s = s;
                    a.dim = oracle_triangulate(&s, &a.cells, NULL);
                    options.method = (paradt_method)method;
                    for (options.regions = 0; options.regions <= 3; options.regions += 3)
                        expect_answer(&a, &options);
                    cells_free(&a.cells);
                    sample_free(&a.s);
                }
}

int main(void) {
    static struct CMUnitTest tests[PARADT_METHOD_COUNT * FAMILY_COUNT + 1];
    size_t count = 0;
    tests[count++] = named_test(a_few_points_equal_the_definition, NULL, "a_few_points_equal_the_definition");
    for (int row = 0; row < PARADT_METHOD_COUNT * FAMILY_COUNT; row++)
        tests[count++] = named_test(equals_the_definition, (void *)(intptr_t)row, "%s_equals_the_definition_on_%s",
                                    paradt_method_string((paradt_method)(row / FAMILY_COUNT)),
                                    families[row % FAMILY_COUNT].name);
    return run_named_tests("definition", tests, count);
}
