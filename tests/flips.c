// Flips: the flip method makes the cells of insertion, counts its flips and the nodes of its history, and every kind of flip is
// needed somewhere.
#include "harness.h"

enum { LARGEST_DIM = SANITIZED ? 4 : 8 };
static const int points_in[] = {0, 0, 400, 300, 60, 25, 18, 15, 14};
static const int few_points_in[] = {0, 0, 40, 25, 12, 9};

static paradt_triangulation by(const sample *s, paradt_method method) {
    paradt_points points = points_of(s);
    paradt_options options = {0};
    paradt_triangulation t;
    options.method = method;
    watch(s, 60);
    paradt_status status = paradt_triangulate(&t, &points, &options);
    watch(NULL, 0);
    if (status)
        fail_on_sample(s, paradt_status_string(status));
    return t;
}

// Fails unless flips and insertion agree. Adds the flips to counts, by the number of simplices replaced.
static void expect_insertion(const sample *s, uint64_t *counts) {
    paradt_triangulation flipped = by(s, PARADT_FLIP), inserted = by(s, PARADT_BOWYER_WATSON);
    paradt_points points = points_of(s);
    paradt_fault fault;
    if (paradt_hash(&flipped) != paradt_hash(&inserted) || flipped.stats.hull_facets != inserted.stats.hull_facets)
        fail_on_sample(s, "flips give other cells than insertion");
    if (flipped.stats.hidden != inserted.stats.hidden || flipped.dim != inserted.dim)
        fail_on_sample(s, "flips hide other points than insertion");
    if (paradt_check(&flipped, &points, NULL, &fault))
        fail_on_sample(s, fault.reason);
    if (flipped.dim > 0 && flipped.stats.history_nodes < flipped.cell_count)
        fail_on_sample(s, "the history lacks cells");
    for (int k = 0; k < PARADT_MAX_DIM + 2; k++)
        counts[k] += flipped.stats.flips[k];
    paradt_free(&flipped);
    paradt_free(&inserted);
}

// state: family
static void flips_agree_with_insertion(void **state) {
    int f = (int)(intptr_t)*state;
    uint64_t counts[PARADT_MAX_DIM + 2] = {0};
    for (int dim = 2; dim <= LARGEST_DIM; dim++)
        for (int w = 0; w < WEIGHTING_COUNT; w++) {
            int extremes = families[f].extremes || weightings[w].extremes;
            if (extremes && dim > 5)
                continue;
            sample s = family_make(&families[f], &weightings[w], dim, extremes ? few_points_in[dim] : points_in[dim],
                                   (uint64_t)(7 + f + 100 * w));
            expect_insertion(&s, counts);
            sample_free(&s);
        }
}

// In general position a flip replaces 1 to dim simplices, with weights dim + 1; one flip a point inserts it.
static void every_kind_of_flip_occurs(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++) {
        uint64_t plain[PARADT_MAX_DIM + 2] = {0}, weighted[PARADT_MAX_DIM + 2] = {0};
        sample s = family_make(&families[family_named("uniform")], &weightings[0], dim, dim < 4 ? 3000 : 500, 3);
        expect_insertion(&s, plain);
        sample_free(&s);
        for (int w = 1; w < WEIGHTING_COUNT; w++) {
            if (weightings[w].extremes)
                continue;
            s = family_make(&families[family_named("uniform")], &weightings[w], dim, dim < 4 ? 1000 : 200, 3);
            expect_insertion(&s, weighted);
            sample_free(&s);
        }
        assert_true(plain[0] == 0 && weighted[0] == 0 && plain[dim + 1] == 0);
        for (int k = 1; k <= dim; k++)
            assert_true(plain[k] > 0 && weighted[k] > 0);
        assert_true(weighted[dim + 1] > 0);
    }
}

// The memory of the history counts: a limit just below the most that is held is refused, and what is refused is said.
static void the_history_keeps_within_the_limit(void **state) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 2000, 9);
    paradt_points points = points_of(&s);
    paradt_options options = {0};
    paradt_triangulation t = by(&s, PARADT_FLIP);
    (void)state;
    options.method = PARADT_FLIP;
    options.memory_limit = (size_t)t.stats.peak_bytes;
    assert_true(t.stats.peak_bytes > t.stats.history_nodes * 6 * sizeof(paradt_index));
    paradt_free(&t);
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
    paradt_free(&t);
    options.memory_limit--;
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_MEMORY);
    assert_true(t.stats.needed_bytes > options.memory_limit);
    sample_free(&s);
}

static int cancel_after(void *user, double fraction) {
    int *calls = (int *)user;
    (void)fraction;
    return --*calls <= 0;
}

static void flips_can_be_cancelled(void **state) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 3000, 9);
    paradt_points points = points_of(&s);
    paradt_options options = {0};
    paradt_triangulation t;
    int cancelled = 0;
    (void)state;
    options.method = PARADT_FLIP;
    options.progress = cancel_after;
    for (int after = 1; after < 40; after += 3) {
        int calls = after;
        options.user = &calls;
        paradt_status status = paradt_triangulate(&t, &points, &options);
        assert_true(status == PARADT_OK || status == PARADT_ERROR_CANCELLED);
        cancelled += status != PARADT_OK;
        paradt_free(&t);
    }
    assert_true(cancelled > 5);
    sample_free(&s);
}

int main(void) {
    static struct CMUnitTest tests[FAMILY_COUNT];
    static const struct CMUnitTest others[] = {
        cmocka_unit_test(every_kind_of_flip_occurs),
        cmocka_unit_test(the_history_keeps_within_the_limit),
        cmocka_unit_test(flips_can_be_cancelled),
    };
    for (int f = 0; f < FAMILY_COUNT; f++) {
        tests[f].name = families[f].name;
        tests[f].test_func = flips_agree_with_insertion;
        tests[f].initial_state = (void *)(intptr_t)f;
    }
    return cmocka_run_group_tests(tests, NULL, NULL) + cmocka_run_group_tests(others, NULL, NULL);
}
