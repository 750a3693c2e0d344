// Randomized incremental construction in parallel: what the other tests of all methods do not cover. Furthest-site
// triangulations equal their definition; the facets of a set's hull are those of its triangulation; any number of
// tasks, on threads or not, makes the same cells; and they give all memory back when one of them fails.
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wunused-function"
#elif defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define PARADT_IMPLEMENTATION
#include <fenv.h>

#include "harness.h"
#include "runners.h"

enum { LARGEST_DIM = SANITIZED ? 4 : 6 };

static const paradt_parallel_for runners[] = {NULL, run_backwards, run_on_threads};

// --- the furthest-site triangulation

static void expect_furthest(const sample *s, const cell_set *expected, const int *representative, int dim,
                            const paradt_options *options, const char *how) {
    paradt_points points = points_of(s);
    paradt_triangulation t;
    watch(s, 60);
    if (paradt_triangulate(&t, &points, options)) fail_on_sample(s, t.error_text);
    watch(NULL, 0);
    cell_set found = cells_of(&t, NULL);
    fail_if_different(s, how, expected, &found);
    if (t.dim != dim || verify_neighbors(&t)) fail_on_sample(s, "the dimension or the neighbours are wrong");
    for (int i = 0; i < s->count; i++)
        if (t.representative[i] != representative[i]) fail_on_sample(s, "a representative is wrong");
    cells_free(&found);
    paradt_free(&t);
}

// state: family
static void furthest_site_triangulations_equal_the_definition(void **state) {
    static const int points_in[] = {0, 0, 14, 13, 11, 11, 11};
    int f = (int)(intptr_t)*state;
    for (int w = 0; w < WEIGHTING_COUNT; w++)
        for (int dim = 2; dim <= LARGEST_DIM; dim++) {
            int extremes = families[f].extremes || weightings[w].extremes;
            if (extremes && dim > 4) continue;
            sample s = family_make(&families[f], &weightings[w], dim, points_in[dim], (uint64_t)(3 + f + 100 * w));
            int *representative = (int *)need((size_t)s.count, sizeof(int));
            cell_set cells;
            int k = oracle_triangulate_side(&s, 1, &cells, representative);
            paradt_options options = {0};
            options.flags = PARADT_FURTHEST_SITE;
            expect_furthest(&s, &cells, representative, k, &options, "furthest-site by auto");
            options.method = PARADT_LIFTED_HULL;
            options.parallel_for = run_backwards;
            options.regions = 3;
            expect_furthest(&s, &cells, representative, k, &options, "furthest-site by tasks");
            cells_free(&cells);
            free(representative);
            sample_free(&s);
        }
}

static void furthest_sites_are_asked_of_those_who_have_them(void **state) {
    static const double x[] = {0, 0, 1, 0, 0, 1, 1, 1, 0.5, 0.25};
    paradt_points points = paradt_points_f64(x, 5, 2);
    paradt_options options = {0};
    paradt_triangulation t;
    paradt_fault fault;
    (void)state;
    options.flags = PARADT_FURTHEST_SITE;
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
    assert_int_equal(t.cell_count, 2);
    assert_int_equal(t.stats.hidden, 1);
    assert_int_equal(t.representative[4], -1);
    assert_int_equal(paradt_check(&t, &points, &options, &fault), PARADT_ERROR_ARGUMENT);
    assert_non_null(fault.reason);
    paradt_free(&t);
    options.method = PARADT_BOWYER_WATSON;
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_ARGUMENT);
    assert_non_null(t.error_text);
}

// --- planes

// Points whose coordinates are of very different sizes. An overflow would make infinities and no numbers, which a
// compiler may take for impossible.
static void planes_do_not_overflow(void **state) {
    enum { ROUNDS = 2000 };
    uint64_t seed = 1;
    (void)state;
    for (int dim = 2; dim <= PARADT_MAX_DIM; dim++)
        for (int round = 0; round < ROUNDS; round++) {
            double x[PARADT_MAX_DIM + 1][PARADT_MAX_DIM];
            const double *p[PARADT_MAX_DIM + 1];
            paradt__space space;
            paradt__planes planes;
            paradt__plane plane;
            paradt__space_begin(&space, dim, dim, 0);
            for (int i = 0; i <= dim; i++) {
                p[i] = x[i];
                for (int j = 0; j < dim; j++) {
                    seed = paradt__mix(seed + 1);
                    x[i][j] = ldexp(1.0 + (double)(seed >> 40) / 16777216.0, round % 2 && j == i - 1 ? -100
                                                                             : round % 2 && i && j >= i
                                                                                 ? -119
                                                                                 : (int)(seed % 238) - 119);
                }
                paradt__space_add(&space, x[i]);
            }
            paradt__space_end(&space);
            assert_true(space.filtered);
            feclearexcept(FE_ALL_EXCEPT);
            for (int lifted = 0; lifted < 2; lifted++) {
                paradt__planes_begin(&planes, &space, lifted);
                paradt__planes_inner(&planes, p);
                paradt__plane_of_facet(&planes, p, &plane, dim, planes.terms);
                if (lifted) paradt__plane_of_cell(&planes, p, 1.0, &plane, dim, dim);
            }
            assert_int_equal(fetestexcept(FE_OVERFLOW | FE_INVALID | FE_DIVBYZERO), 0);
        }
}

// --- the facets of a hull

// Returns the facets of the hull of a sample, with indices of points, and checks links and orientations.
static cell_set facets_of_hull(const sample *s, size_t tasks, paradt_parallel_for runner) {
    paradt_points points = points_of(s);
    paradt_options options = {0};
    paradt__memory memory;
    paradt__meter meter;
    paradt__counters counters;
    paradt__cuts cuts;
    paradt__set set;
    paradt__mesh facets;
    cell_set found = {0};
    size_t bad;
    uint32_t reported = 0;
    paradt_index *representative = (paradt_index *)need((size_t)s->count, sizeof *representative);
    memset(&set, 0, sizeof set);
    memset(&cuts, 0, sizeof cuts);
    memset(&counters, 0, sizeof counters);
    cuts.boxes = 1;
    options.parallel_for = runner;
    paradt__memory_begin(&memory, &options);
    paradt__meter_begin(&meter, &options);
    paradt__team team = paradt__few_of(&options, tasks, paradt__progress_of(&meter, &reported, 1.0));
    assert_int_equal(paradt__set_load(&set, &points, &cuts, &team, &memory, representative, &bad), PARADT_OK);
    if (set.space.dim > 0) {
        int k = set.space.dim, vertices[CELLS_MAX_DIM + 1];
        assert_int_equal(paradt__hull_facets(&set, &team, &memory, &facets, &counters), PARADT_OK);
        for (size_t i = 0; i < facets.count; i++) {
            const double *p[CELLS_MAX_DIM + 1];
            for (int j = 0; j < k; j++) {
                paradt_index handle = (paradt_index)i * k + j, mirror = facets.links[handle];
                vertices[j] = (int)set.origin[facets.vertices[handle]];
                p[j] = paradt__record(&set, facets.vertices[handle]);
                assert_true(mirror >= 0 && facets.links[mirror] == handle);
                if (k > 1 && !paradt__same_facet(facets.vertices, handle, facets.vertices, mirror, k))
                    fail_on_sample(s, "a link leads to another ridge");
            }
            cells_add(&found, cell_make(vertices, k));
            for (size_t q = 0; q < set.count && k > 1; q += 1 + set.count / 300) {
                p[k] = paradt__record(&set, (paradt_index)q);
                if (paradt__orient(&set.space, p) > 0) fail_on_sample(s, "a point is beyond a facet");
            }
        }
        paradt__mesh_free(&facets, &memory);
    }
    paradt__set_free(&set, &memory);
    paradt__release(&memory, cuts.cut);
    assert_int_equal(memory.held, 0);
    cells_sort(&found);
    free(representative);
    return found;
}

static void expect_facets_of_hull(const sample *s) {
    paradt_points points = points_of(s);
    paradt_triangulation t;
    cell_set expected = {0};
    int vertices[CELLS_MAX_DIM + 1];
    watch(s, 60);
    paradt_options options = {0};
    options.method = PARADT_BOWYER_WATSON;
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
    for (size_t i = 0; i < t.cell_count * (size_t)(t.dim + 1) && t.dim > 0; i++) {
        size_t place = i % (size_t)(t.dim + 1), first = i - place;
        int count = 0;
        if (t.neighbors[i] >= 0) continue;
        for (size_t j = 0; j <= (size_t)t.dim; j++)
            if (j != place) vertices[count++] = (int)t.cells[first + j];
        cells_add(&expected, cell_make(vertices, count));
    }
    cells_sort(&expected);
    for (size_t runner = 0; runner < sizeof runners / sizeof runners[0]; runner++) {
        cell_set found = facets_of_hull(s, 1 + 2 * runner, runners[runner]);
        fail_if_different(s, "facets of the hull", &expected, &found);
        cells_free(&found);
    }
    watch(NULL, 0);
    cells_free(&expected);
    paradt_free(&t);
}

// state: family
static void facets_of_hulls_are_those_of_the_triangulation(void **state) {
    static const int points_in[] = {0, 0, 400, 300, 60, 30, 20}, few_points_in[] = {0, 0, 30, 20, 12, 9, 9};
    int f = (int)(intptr_t)*state;
    for (int dim = 2; dim <= LARGEST_DIM; dim++) {
        int w = dim % 2 ? 0 : 1 + (f + dim) % (WEIGHTING_COUNT - 1);
        int extremes = families[f].extremes || weightings[w].extremes;
        if (extremes && dim > 4) continue;
        sample s = family_make(&families[f], &weightings[w], dim, extremes ? few_points_in[dim] : points_in[dim],
                               (uint64_t)(5 + f));
        expect_facets_of_hull(&s);
        sample_free(&s);
    }
}

// Of so many points most are dropped before by a sample's hull, where it is not too flat for that.
static void facets_of_the_hulls_of_many_points_are_those_of_the_triangulation(void **state) {
    static const struct {
        const char *family;
        int dim, count;
    } sets[] = {{"uniform", 2, 40000}, {"uniform", 3, 30000}, {"clusters", 3, 20000}, {"lattice", 3, 20000},
                {"sphere", 3, 9000},   {"lattice", 2, 9000},  {"uniform", 4, 9000}};
    (void)state;
    for (size_t i = 0; i < (SANITIZED ? 2 : sizeof sets / sizeof sets[0]); i++) {
        sample s = family_make(&families[family_named(sets[i].family)], NULL, sets[i].dim, sets[i].count, 1);
        expect_facets_of_hull(&s);
        sample_free(&s);
    }
}

// --- tasks

// So many points that there are several rounds, and tasks that wait for each other's facets
static void any_number_of_tasks_makes_the_same_cells(void **state) {
    static const struct {
        const char *family;
        int dim, count;
        unsigned flags;
    } sets[] = {{"uniform", 2, 30000, 0},
                {"uniform", 3, 8000, 0},
                {"clusters", 3, 5000, 0},
                {"lattice", 3, 4000, 0},
                {"uniform", 4, 900, 0},
                {"uniform", 5, 250, 0},
                {"uniform", 3, 20000, PARADT_FURTHEST_SITE},
                {"sphere", 3, 1500, 0},
                {"sphere", 3, 1500, PARADT_FURTHEST_SITE}};
    (void)state;
    for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++) {
        int count = SANITIZED ? sets[i].count / 4 : sets[i].count;
        sample s = family_make(&families[family_named(sets[i].family)], NULL, sets[i].dim, count, 1);
        paradt_points points = points_of(&s);
        uint64_t hash = 0;
        for (size_t way = 0; way < 7; way++) {
            paradt_options options = {0};
            paradt_triangulation t;
            if (RACES_ONLY && way && runners[(way + 1) / 2 % 3] != run_on_threads)
                continue;
            options.method = PARADT_LIFTED_HULL;
            options.flags = sets[i].flags;
            options.parallel_for = runners[(way + 1) / 2 % 3];
            options.regions = 1 + way;
            if (way == 0 && !sets[i].flags) {
                options.method = PARADT_BOWYER_WATSON;
                options.regions = 1;
            }
            watch(&s, 120);
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            watch(NULL, 0);
            assert_int_equal(t.stats.regions, 1);
            if (!way) hash = paradt_hash(&t);
            else if (paradt_hash(&t) != hash) fail_on_sample(&s, "other cells with another number of tasks");
            paradt_free(&t);
        }
        sample_free(&s);
    }
}

// --- failures

typedef struct account {
    pthread_mutex_t lock;
    size_t calls, fail_at, live;
    int refused;
} account;

static void *account_alloc(void *user, size_t size) {
    account *a = (account *)user;
    void *block = NULL;
    pthread_mutex_lock(&a->lock);
    if (++a->calls == a->fail_at) a->refused = 1;
    else if ((block = malloc(size)) != NULL) a->live++;
    pthread_mutex_unlock(&a->lock);
    return block;
}

static void account_free(void *user, void *memory) {
    account *a = (account *)user;
    pthread_mutex_lock(&a->lock);
    a->live--;
    pthread_mutex_unlock(&a->lock);
    free(memory);
}

static void tasks_that_run_out_of_memory_give_all_back(void **state) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 700, 1);
    paradt_points points = points_of(&s);
    (void)state;
    for (unsigned flags = 0; flags <= PARADT_FURTHEST_SITE; flags += PARADT_FURTHEST_SITE)
        for (size_t runner = 1; runner < sizeof runners / sizeof runners[0]; runner++) {
            int refused = 1;
            for (size_t fail_at = 1; refused; fail_at += SANITIZED ? 5 : 1) {
                account a = {PTHREAD_MUTEX_INITIALIZER, 0, fail_at, 0, 0};
                paradt_options options = {0};
                paradt_triangulation t;
                options.method = PARADT_LIFTED_HULL;
                options.regions = 4;
                options.flags = flags;
                options.parallel_for = runners[runner];
                options.allocator.alloc = account_alloc;
                options.allocator.free = account_free;
                options.allocator.user = &a;
                paradt_status status = paradt_triangulate(&t, &points, &options);
                assert_int_equal(status, a.refused ? PARADT_ERROR_MEMORY : PARADT_OK);
                paradt_free(&t);
                assert_int_equal(a.live, 0);
                refused = a.refused;
            }
        }
    sample_free(&s);
}

static int cancel_after(void *user, double fraction) {
    int *left = (int *)user;
    (void)fraction;
    return --*left < 0;
}

static void tasks_can_be_cancelled(void **state) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 3000, 1);
    paradt_points points = points_of(&s);
    (void)state;
    for (int calls = 0; calls < 40; calls += SANITIZED ? 7 : 1) {
        int left = calls;
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = PARADT_LIFTED_HULL;
        options.regions = 4;
        options.parallel_for = run_on_threads;
        options.progress = cancel_after;
        options.user = &left;
        paradt_status status = paradt_triangulate(&t, &points, &options);
        assert_int_equal(status, left < 0 ? PARADT_ERROR_CANCELLED : PARADT_OK);
        paradt_free(&t);
    }
    sample_free(&s);
}

int main(void) {
    static struct CMUnitTest tests[2 * FAMILY_COUNT + 6];
    size_t count = 0;
    tests[count++] =
        named_test(any_number_of_tasks_makes_the_same_cells, NULL, "any_number_of_tasks_makes_the_same_cells");
    tests[count++] =
        named_test(tasks_that_run_out_of_memory_give_all_back, NULL, "tasks_that_run_out_of_memory_give_all_back");
    tests[count++] = named_test(facets_of_the_hulls_of_many_points_are_those_of_the_triangulation, NULL,
                                "facets_of_the_hulls_of_many_points_are_those_of_the_triangulation");
    tests[count++] = named_test(tasks_can_be_cancelled, NULL, "tasks_can_be_cancelled");
    if (!RACES_ONLY) tests[count++] = named_test(planes_do_not_overflow, NULL, "planes_do_not_overflow");
    if (!RACES_ONLY)
        tests[count++] = named_test(furthest_sites_are_asked_of_those_who_have_them, NULL,
                                    "furthest_sites_are_asked_of_those_who_have_them");
    for (int f = 0; f < FAMILY_COUNT; f++) {
        tests[count++] = named_test(facets_of_hulls_are_those_of_the_triangulation, (void *)(intptr_t)f,
                                    "facets_of_hulls_are_those_of_the_triangulation_on_%s", families[f].name);
        if (!RACES_ONLY)
            tests[count++] = named_test(furthest_site_triangulations_equal_the_definition, (void *)(intptr_t)f,
                                        "furthest_site_triangulations_equal_the_definition_on_%s", families[f].name);
    }
    return run_named_tests("lifted_hull", tests, count);
}
