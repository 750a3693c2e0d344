// Small sets in many regions, by DeWall, and by every method. The limits are so low that every way is gone: neighbours are learned
// at once, many lists of neighbours are too long, and a few points are divided by walls.
#define PARADT_STATIC // functions that are not called are not compiled
#define PARADT_IMPLEMENTATION
#define PARADT__STAR_CELLS  14
#define PARADT__LEARN_AFTER 0
#define PARADT__WALL_SMALL  8
#include "harness.h"
#include "runners.h"

enum { CASES = 4000, MOST_POINTS = 90 };

static uint64_t state;

static int below(int bound) { return random_below(&state, bound); }

// Points of a small box of a lattice, dense and sparse parts of a cube, a slab, or a set of one of the families.
static sample small_set(uint64_t number) {
    sample s;
    int dim, count, kind, sides[3];
    state = number * 0x9e3779b97f4a7c15u;
    dim = below(4) ? 3 : 2;
    count = 6 + below(MOST_POINTS - 6);
    kind = below(5);
    if (kind == 4)
        return family_make(&families[below(FAMILY_COUNT)], NULL, dim, count < 40 ? count : 40, number);
    s = sample_make("small set", dim, count);
    for (int k = 0; k < 3; k++)
        sides[k] = 1 + below(kind ? 9 : 4);
    for (int i = 0; i < count; i++) {
        double *x = s.x + i * dim;
        for (int k = 0; k < dim; k++) {
            x[k] = kind < 2 ? below(sides[k] + 1) : random_unit(&state);
            if (kind == 3 && i % 3)
                x[k] *= 0.125;
        }
        if (kind == 2)
            x[dim - 1] = below(3) ? 0 : x[dim - 1];
    }
    return s;
}

static void small_sets_in_regions_have_the_cells_of_one(void **unused) {
    (void)unused;
    for (uint64_t number = 1; number <= CASES / (SANITIZED ? 10 : 1); number++) {
        sample s = small_set(number);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        paradt_triangulation whole, t;
        uint64_t hash;
        options.method = PARADT_BOWYER_WATSON;
        assert_int_equal(paradt_triangulate(&whole, &points, &options), PARADT_OK);
        hash = paradt_hash(&whole);
        if (below(3) == 0)
            options.method = below(2) ? PARADT_INCODE : PARADT_DEWALL;
        options.regions = 2 + (size_t)below(8);
        options.partition = below(2) ? PARADT_UNIFORM : PARADT_BISECTION;
        options.parallel_for = below(2) ? run_backwards : NULL;
        watch(&s, 60);
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        watch(NULL, 0);
        if (paradt_hash(&t) != hash)
            fail_on_sample(&s, "other cells in regions");
        if (t.stats.hull_facets != whole.stats.hull_facets)
            fail_on_sample(&s, "other hull facets in regions");
        if (verify_neighbors(&t))
            fail_on_sample(&s, verify_neighbors(&t));
        paradt_free(&t);
        paradt_free(&whole);
        sample_free(&s);
    }
}

static void small_sets_between_walls_have_the_cells_of_insertion(void **unused) {
    (void)unused;
    for (uint64_t number = 1; number <= CASES / (SANITIZED ? 10 : 1); number++) {
        sample s = small_set(number);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        paradt_triangulation inserted, t;
        options.method = PARADT_BOWYER_WATSON;
        assert_int_equal(paradt_triangulate(&inserted, &points, &options), PARADT_OK);
        options.method = PARADT_DEWALL;
        watch(&s, 60);
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        watch(NULL, 0);
        if (paradt_hash(&t) != paradt_hash(&inserted))
            fail_on_sample(&s, "other cells by walls");
        paradt_free(&t);
        paradt_free(&inserted);
        sample_free(&s);
    }
}

// The cell that is made first, in no wall, may be all that crosses a later plane: then nothing is missing there.
static void a_dense_part_by_walls_that_are_tasks_has_the_cells_of_insertion(void **unused) {
    (void)unused;
    for (uint64_t number = 1; number <= 3000 / (SANITIZED ? 10 : 1); number++) {
        sample s;
        paradt_options options = {0};
        paradt_triangulation inserted, t;
        paradt_points points;
        state = number * 0x9e3779b97f4a7c15u;
        s = sample_make("a dense part", 2, 70 + below(100));
        for (int i = 0; i < 2 * s.count; i++)
            s.x[i] = random_unit(&state) * (i / 2 % 3 ? 0.3 : 1);
        points = points_of(&s);
        options.method = PARADT_BOWYER_WATSON;
        assert_int_equal(paradt_triangulate(&inserted, &points, &options), PARADT_OK);
        options.method = PARADT_DEWALL;
        options.regions = 5 + (size_t)below(5);
        options.partition = below(2) ? PARADT_UNIFORM : PARADT_BISECTION;
        watch(&s, 60);
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        watch(NULL, 0);
        if (paradt_hash(&t) != paradt_hash(&inserted))
            fail_on_sample(&s, "other cells by walls that are tasks");
        paradt_free(&t);
        paradt_free(&inserted);
        sample_free(&s);
    }
}

// Points so near a tilted plane that the next vertex is all but in the facet's plane: floating point knows a limit of its sphere.
static void points_near_a_tilted_plane_have_the_cells_of_insertion(void **unused) {
    (void)unused;
    for (uint64_t number = 1; number <= 4000 / (SANITIZED ? 10 : 1); number++) {
        sample s;
        paradt_options options = {0};
        paradt_triangulation inserted, t;
        paradt_points points;
        int a, b, lattice;
        state = number * 0x9e3779b97f4a7c15u;
        s = sample_make("near a tilted plane", 3, 5 + below(60));
        a = below(8), b = 1 + below(8), lattice = below(2);
        for (int i = 0; i < s.count; i++) {
            double *x = s.x + 3 * i;
            for (int k = 0; k < 2; k++)
                x[k] = lattice ? below(256) : random_unit(&state);
            x[2] = a * x[0] + b * x[1];
            if (below(3))
                x[2] += (x[2] + 1) * ldexp(random_unit(&state) - 0.5, -below(52));
        }
        points = points_of(&s);
        options.method = PARADT_BOWYER_WATSON;
        assert_int_equal(paradt_triangulate(&inserted, &points, &options), PARADT_OK);
        options.method = PARADT_INCODE;
        watch(&s, 60);
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        watch(NULL, 0);
        if (paradt_hash(&t) != paradt_hash(&inserted))
            fail_on_sample(&s, "other cells facet by facet");
        paradt_free(&t);
        paradt_free(&inserted);
        sample_free(&s);
    }
}

// The first simplex has points on its border, while some of its ghosts are still alive.
static void few_points_of_a_lattice_have_the_same_cells_by_flips(void **unused) {
    (void)unused;
    for (uint64_t number = 1; number <= 4000 / (SANITIZED ? 10 : 1); number++) {
        const int dim = 2 + (int)(number % 2);
        sample s;
        paradt_options options = {0};
        paradt_triangulation inserted, t;
        paradt_points points;
        state = number * 0x9e3779b97f4a7c15u;
        s = sample_make("few points", dim, dim + 2 + below(6));
        for (int i = 0; i < s.count * dim; i++)
            s.x[i] = below(3);
        points = points_of(&s);
        options.method = PARADT_BOWYER_WATSON;
        assert_int_equal(paradt_triangulate(&inserted, &points, &options), PARADT_OK);
        options.method = PARADT_FLIP;
        watch(&s, 60);
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        watch(NULL, 0);
        if (paradt_hash(&t) != paradt_hash(&inserted))
            fail_on_sample(&s, "other cells by flips");
        paradt_free(&t);
        paradt_free(&inserted);
        sample_free(&s);
    }
}

// With and without weights, by which many points are hidden when they come, or later.
static void small_sets_have_the_same_cells_by_every_method(void **unused) {
    (void)unused;
    for (uint64_t number = 1; number <= CASES / (SANITIZED ? 80 : 8); number++) {
        sample s = sample_make("small set", 2 + (int)(number % 4), 8 + (int)(number * 7 % 33));
        uint64_t first = 0;
        state = number;
        for (int i = 0, lattice = below(2); i < s.count * s.dim; i++)
            s.x[i] = lattice ? below(3) : random_unit(&state);
        if (number & 4) {
            s.w = (double *)need((size_t)s.count, sizeof(double));
            for (int i = 0; i < s.count; i++)
                s.w[i] = number & 8 ? 2 * random_unit(&state) : below(3);
        }
        for (int method = PARADT_INCODE; method < PARADT_METHOD_COUNT; method++) {
            paradt_points points = points_of(&s);
            paradt_options options = {0};
            paradt_triangulation t;
            options.method = (paradt_method)method;
            watch(&s, 60);
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            watch(NULL, 0);
            if (method == PARADT_INCODE)
                first = paradt_hash(&t);
            if (paradt_hash(&t) != first)
                fail_on_sample(&s, paradt_method_string(options.method));
            if (verify_neighbors(&t))
                fail_on_sample(&s, verify_neighbors(&t));
            paradt_free(&t);
        }
        sample_free(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_sets_in_regions_have_the_cells_of_one),
        cmocka_unit_test(small_sets_between_walls_have_the_cells_of_insertion),
        cmocka_unit_test(a_dense_part_by_walls_that_are_tasks_has_the_cells_of_insertion),
        cmocka_unit_test(points_near_a_tilted_plane_have_the_cells_of_insertion),
        cmocka_unit_test(few_points_of_a_lattice_have_the_same_cells_by_flips),
        cmocka_unit_test(small_sets_have_the_same_cells_by_every_method),
    };
    return cmocka_run_group_tests_name("small_sets", tests, NULL, NULL);
}
