// Sets that are too large for the definition: all methods, numbers of regions, partitions, input orders and ways of running the
// regions give the same cells, which paradt_check certifies.
#include "harness.h"
#include "runners.h"

#include <pthread.h>

enum { LARGEST_DIM = SANITIZED ? 3 : 8, MOST_REGIONS = 9, REGIONS_STEP = SANITIZED ? 3 : 2 };
static const int points_in[] = {0, 0, 300, 250, 45, 20, 16, 14, 13};
// Of families whose predicates mostly take thousands of bits
static const int few_points_in[] = {0, 0, SANITIZED ? 30 : 40, SANITIZED ? 20 : 28, 12, 9};

// A sample and its cells by InCoDe without regions, verified and certified.
typedef struct reference {
    sample s;
    cell_set cells;
    uint64_t hash;
    int dim;
} reference;

static reference reference_make(int f, int w, int dim, int count) {
    reference r;
    paradt_options options = {0};
    options.method = PARADT_INCODE;
    r.s = family_make(&families[f], &weightings[w], dim, count, (uint64_t)(1 + f + 100 * w));
    paradt_triangulation t = triangulate_and_verify(&r.s, &options, how_text(&options));
    r.cells = cells_of(&t, NULL);
    r.hash = paradt_hash(&t);
    r.dim = t.dim;
    if (t.stats.cells_recomputed)
        fail_on_sample(&r.s, "an undivided run says that it recomputed cells");
    paradt_free(&t);
    return r;
}

static void reference_free(reference *r) {
    cells_free(&r->cells);
    sample_free(&r->s);
}

// Without neighbours, insertion builds the regions in another way, one after another. Returns what differs, or NULL.
static const char *differs_without_neighbors(const reference *r, paradt_options options, const paradt_triangulation *with) {
    paradt_points points = points_of(&r->s);
    paradt_triangulation without;
    options.flags = PARADT_NO_NEIGHBORS;
    watch(&r->s, 20);
    paradt_status status = paradt_triangulate(&without, &points, &options);
    watch(NULL, 0);
    if (status)
        return paradt_status_string(status);
    int equal = paradt_hash(&without) == r->hash && without.stats.hull_facets == with->stats.hull_facets;
    paradt_free(&without);
    return equal ? NULL : "other cells or hull facets without neighbours";
}

static void expect_reference(const reference *r, const paradt_options *options, const char *how) {
    paradt_points points = points_of(&r->s);
    paradt_triangulation t;
    watch(&r->s, 20);
    paradt_status status = paradt_triangulate(&t, &points, options);
    watch(NULL, 0);
    if (status)
        fail_on_sample(&r->s, paradt_status_string(status));
    const char *wrong = t.dim != r->dim ? "another affine dimension" : verify_records(&t, &r->s);
    if (!wrong)
        wrong = verify_neighbors(&t);
    if (!wrong && (t.stats.regions < 1 || t.stats.regions > (options->regions ? options->regions : 1)))
        wrong = "stats.regions is more than was asked for";
    cell_set found = cells_of(&t, NULL);
    fail_if_different(&r->s, how, &r->cells, &found);
    if (!wrong && paradt_hash(&t) != r->hash)
        wrong = "equal cells have different hashes";
    if (!wrong && options->regions > 1 && options->method == PARADT_BOWYER_WATSON && r->dim <= 3)
        wrong = differs_without_neighbors(r, *options, &t);
    if (wrong) {
        char text[256];
        snprintf(text, sizeof text, "%s: %s", how, wrong);
        fail_on_sample(&r->s, text);
    }
    cells_free(&found);
    paradt_free(&t);
}

static void expect_reference_from_shuffled(const reference *r, const paradt_options *options) {
    int *order = (int *)need((size_t)r->s.count, sizeof(int)), *leader = (int *)need((size_t)r->s.count, sizeof(int));
    uint64_t seed = 5;
    paradt_triangulation t;
    sample_leaders(&r->s, leader, NULL);
    shuffle(order, r->s.count, &seed);
    sample shuffled = sample_pick(&r->s, order, r->s.count);
    for (int i = 0; i < r->s.count; i++)
        order[i] = leader[order[i]];
    paradt_points points = points_of(&shuffled);
    watch(&r->s, 20);
    assert_int_equal(paradt_triangulate(&t, &points, options), PARADT_OK);
    watch(NULL, 0);
    cell_set found = cells_of(&t, order);
    fail_if_different(&r->s, "shuffled input", &r->cells, &found);
    cells_free(&found);
    paradt_free(&t);
    sample_free(&shuffled);
    free(leader);
    free(order);
}

// The others build one region, whatever options.regions asks for.
static int divides(int method) {
    return method <= PARADT_BOWYER_WATSON;
}

// The other methods only read and sort the points by tasks.
static int has_tasks(int method) {
    return divides(method) || method == PARADT_LIFTED_HULL;
}

// state: family
static void methods_and_regions_agree(void **state) {
    int f = (int)(intptr_t)*state;
    for (int dim = 2; dim <= LARGEST_DIM; dim++)
        for (int turn = 0; turn < 2; turn++) {
            int w = turn ? 1 + (f + dim) % (WEIGHTING_COUNT - 1) : 0;
            int extremes = families[f].extremes || weightings[w].extremes;
            if ((extremes && dim > (is_quick() ? 3 : 5)) || (SANITIZED && turn != (f + dim) % 2))
                continue;
            if (dim > 5 && (f + dim) % 3) // a family has one of the highest dimensions
                continue;
            reference r = reference_make(f, w, dim, extremes ? few_points_in[dim] : points_in[dim]);
            for (int method = 0; method < PARADT_METHOD_COUNT; method++) {
                paradt_options options = {0};
                options.method = (paradt_method)method;
                expect_reference(&r, &options, how_text(&options));
                expect_reference_from_shuffled(&r, &options);
                for (int partition = SANITIZED ? f % 2 : 0; partition < (divides(method) ? 2 : 0); partition += SANITIZED ? 2 : 1)
                    for (options.regions = (size_t)(2 + (f + partition) % 2); options.regions <= MOST_REGIONS;
                         options.regions += REGIONS_STEP) {
                        options.partition = (paradt_partition)partition;
                        if (dim <= 3 || (options.regions / 2 + (size_t)(dim + f)) % 2 == 0)
                            expect_reference(&r, &options, how_text(&options));
                    }
            }
            reference_free(&r);
        }
}

// Many regions have one point or none, and some cells are found by no region alone.
static void more_regions_than_points_agree(void **state) {
    static const struct {
        int dim, count;
    } sizes[] = {{3, 1}, {3, 2}, {3, 5}, {3, 40}, {2, 30}, {2, 150}, {3, 120}, {4, 25}};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (int f = (int)i % (SANITIZED ? 6 : 2); f < FAMILY_COUNT; f += SANITIZED ? 6 : 2) {
            if (families[f].extremes && sizes[i].count > 40)
                continue;
            reference r = reference_make(f, f % 2, sizes[i].dim, sizes[i].count);
            for (int way = 0; way < 2 * PARADT_METHOD_COUNT; way++) {
                paradt_options options = {0};
                options.method = (paradt_method)(way / 2);
                if (way % 2 && !divides(way / 2))
                    continue;
                options.partition = (paradt_partition)(way % 2);
                options.regions = 64;
                expect_reference(&r, &options, how_text(&options));
            }
            reference_free(&r);
        }
}

// --- ways of running the regions

// These count in *user how often they are called.
static void count_on_threads(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    ++*(int *)user;
    run_on_threads(NULL, count, task, context);
}

static void count_backwards(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    ++*(int *)user;
    run_backwards(NULL, count, task, context);
}

static void regions_may_run_in_any_order_and_on_threads(void **state) {
    static const paradt_parallel_for runners[] = {count_on_threads, count_backwards};
    (void)state;
    for (int f = 0; f < FAMILY_COUNT; f++)
        for (int dim = SANITIZED ? 2 + f % 3 : 2; dim <= 4; dim += SANITIZED ? 3 : 1) {
            reference r = reference_make(f, f % 2, dim, families[f].extremes ? few_points_in[dim] : points_in[dim]);
            for (int method = 0; method < PARADT_METHOD_COUNT; method++)
                for (int runner = 0; runner < (RACES_ONLY ? 1 : 2); runner++) {
                    int calls = 0;
                    paradt_options options = {0};
                    // A method runs in one of the ways, and where races are looked for only if it has tasks.
                    if (RACES_ONLY ? !has_tasks(method) : (f + dim + method + runner) % 2)
                        continue;
                    options.method = (paradt_method)method;
                    options.regions = 7;
                    options.partition = (paradt_partition)(f % 2);
                    options.parallel_for = runners[runner];
                    options.user = &calls;
                    expect_reference(&r, &options, runner ? "regions run backwards" : "regions run on threads");
                    if (r.dim > 0 && r.cells.count > 100 && divides(method))
                        assert_true(calls > 0);
                }
            reference_free(&r);
        }
}

// Regions of many points are built in legs: all of them pause together, and other tasks may continue them. The result's arrays
// are the same as without pauses, whoever continues.
static void regions_that_change_hands_build_what_they_build_alone(void **state) {
    static const struct {
        const char *family;
        int dim, count;
        size_t regions;
    } sets[] = {{"plummer", 3, 100000, 5}, // some of its regions also pause while they ask for foreign points
                {"uniform", 3, 45000, 2},
                {"clusters", 3, 80000, 3},
                {"lattice", 3, 45000, 2},
                {"uniform", 2, 150000, 2}};
    static const paradt_parallel_for runners[] = {NULL, count_on_threads, count_backwards};
    (void)state;
    for (size_t i = 0; i < (SANITIZED ? 1 : sizeof sets / sizeof sets[0]); i++) {
        sample s = family_make(&families[family_named(sets[i].family)], NULL, sets[i].dim, sets[i].count, 1);
        paradt_points points = points_of(&s);
        paradt_triangulation alone = {0}, t;
        for (size_t runner = 0; runner < (RACES_ONLY ? 2 : sizeof runners / sizeof runners[0]); runner++) {
            int calls = 0;
            paradt_options options = {0};
            options.method = PARADT_BOWYER_WATSON;
            options.regions = sets[i].regions;
            options.parallel_for = runners[runner];
            options.user = &calls;
            watch(&s, 60);
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            watch(NULL, 0);
            if (!runner) {
                alone = t;
                continue;
            }
            size_t indices = t.cell_count * (size_t)(t.dim + 1);
            if (calls < 12) // there are 10 steps, and one of them has several legs
                fail_on_sample(&s, "regions do not change hands");
            assert_int_equal(t.cell_count, alone.cell_count);
            assert_memory_equal(t.cells, alone.cells, indices * sizeof *t.cells);
            assert_memory_equal(t.neighbors, alone.neighbors, indices * sizeof *t.neighbors);
            paradt_free(&t);
        }
        paradt_free(&alone);
        sample_free(&s);
    }
}

static void large_sets_agree(void **state) {
    static const char *const chosen[] = {"uniform", "sphere", "clusters", "lattice", "near plane", "duplicates"};
    (void)state;
    for (size_t i = 0; i < sizeof chosen / sizeof chosen[0]; i++) {
        int f = family_named(chosen[i]), calls = 0;
        reference r = reference_make(f, (int)i % 2, 3, SANITIZED ? 1000 : 5000);
        for (int method = 0; method < PARADT_METHOD_COUNT; method++) {
            paradt_options options = {0};
            options.method = (paradt_method)method;
            if (RACES_ONLY && !has_tasks(method))
                continue;
            if (!RACES_ONLY)
                expect_reference(&r, &options, how_text(&options));
            options.parallel_for = count_on_threads;
            options.user = &calls;
            options.regions = 5;
            expect_reference(&r, &options, how_text(&options));
            options.partition = PARADT_UNIFORM;
            options.regions = 30;
            if (divides(method))
                expect_reference(&r, &options, how_text(&options));
        }
        reference_free(&r);
    }
}

// The first of four regions has points on a sphere; two others have a dense cluster each, close to that sphere. The cells of the
// first region's own points are wrong in two separate places.
static void a_first_region_that_is_wrong_in_two_places_agrees(void **state) {
    enum { LEFT = 396, BELOW = 198, SPHERE = 206 }; // put the cuts close to the lowest points of the sphere
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        sample s = sample_make("sphere and clusters", dim, LEFT + BELOW + SPHERE);
        uint64_t random = 1, expected = 0;
        for (int i = 0; i < s.count; i++) {
            double *x = s.x + i * dim, norm = 2;
            while (norm > 1) {
                norm = 0;
                for (int k = 0; k < dim; k++) {
                    x[k] = 2 * random_unit(&random) - 1;
                    norm += x[k] * x[k];
                }
            }
            for (int k = 0; k < dim; k++)
                x[k] = i < LEFT + BELOW ? 1 + 0.01 * x[k] : 1 + 0.9 * x[k] / sqrt(norm);
            if (i < LEFT + BELOW)
                x[i >= LEFT] -= 0.95;
        }
        for (int regions = 1; regions <= 4; regions += 3) {
            paradt_options options = {0};
            options.method = PARADT_BOWYER_WATSON;
            options.regions = (size_t)regions;
            paradt_triangulation t = triangulate_and_verify(&s, &options, how_text(&options));
            assert_int_equal(t.stats.regions, regions);
            if (regions == 1)
                expected = paradt_hash(&t);
            assert_true(paradt_hash(&t) == expected);
            paradt_free(&t);
        }
        sample_free(&s);
    }
}

// DeWall has a task for each range between walls; in four dimensions and more all tasks search for the first walls
// together.
static void tasks_between_walls_agree(void **state) {
    static const struct {
        const char *family;
        int w, dim, count;
    } sets[] = {{"uniform", 0, 4, 700},  {"uniform", 1, 5, 220},  {"lattice", 0, 4, 625}, {"gauss", 2, 4, 500},
                {"sphere", 0, 4, 300},   {"plane", 0, 5, 500},    {"uniform", 0, 6, 90},  {"clusters", 1, 3, 3000},
                {"lattice", 0, 3, 1000}, {"clusters", 0, 2, 3000}};
    static const paradt_parallel_for runners[] = {NULL, count_on_threads, count_backwards};
    (void)state;
    for (size_t i = 0; i < (SANITIZED ? 3 : sizeof sets / sizeof sets[0]); i++) {
        reference r = reference_make(family_named(sets[i].family), sets[i].w, sets[i].dim, sets[i].count);
        for (size_t regions = 2; regions <= 17; regions = 3 * regions - 1)
            for (int runner = RACES_ONLY; runner < (RACES_ONLY ? 2 : 3); runner++) {
                int calls = 0;
                paradt_options options = {0};
                options.method = PARADT_DEWALL;
                options.regions = regions;
                options.parallel_for = runners[runner];
                options.user = &calls;
                expect_reference(&r, &options, how_text(&options));
            }
        reference_free(&r);
    }
}

// The longest axis of the plane is a multiple of its first axis, and not one of the axes that its cells are oriented in.
static void regions_cut_across_an_axis_that_does_not_orient_agree(void **state) {
    static const paradt_method methods[] = {PARADT_BOWYER_WATSON, PARADT_INCODE, PARADT_DEWALL};
    sample s = sample_make("leaning plane", 3, 2000);
    uint64_t random = 1, expected = 0;
    (void)state;
    for (int i = 0; i < s.count; i++) {
        double *x = s.x + 3 * i;
        x[0] = random_unit(&random);
        x[1] = -4 * x[0];
        x[2] = random_unit(&random);
    }
    for (int m = 0; m < 3; m++)
        for (size_t regions = 1; regions <= 7; regions += 2) {
            paradt_options options = {0};
            options.method = methods[m];
            options.regions = regions;
            paradt_triangulation t = triangulate_and_verify(&s, &options, how_text(&options));
            assert_int_equal(t.dim, 2);
            assert_int_equal(t.stats.regions, regions);
            if (!expected)
                expected = paradt_hash(&t);
            assert_true(paradt_hash(&t) == expected);
            paradt_free(&t);
        }
    sample_free(&s);
}

// Insertion has one table for small stars, one for large stars, and a general method for the largest.
static void stars_of_thousands_of_cells_agree(void **state) {
    family many = families[family_named("moment curve")];
    (void)state;
    many.at_most = 0;
    paradt_options options = {0};
    sample s = family_make(&many, NULL, 3, SANITIZED ? 400 : 1200, 1);
    options.method = PARADT_BOWYER_WATSON;
    paradt_triangulation t = triangulate_and_verify(&s, &options, how_text(&options));
    uint64_t hash = paradt_hash(&t);
    paradt_free(&t);
    for (int method = 0; method < PARADT_METHOD_COUNT; method++) {
        paradt_points points = points_of(&s);
        options.method = (paradt_method)method;
        watch(&s, 60);
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        watch(NULL, 0);
        assert_true(paradt_hash(&t) == hash);
        paradt_free(&t);
    }
    sample_free(&s);
}

// A thread that calls the library several times, with its own points and method.
typedef struct caller {
    pthread_t thread;
    sample s;
    paradt_options options;
    uint64_t alone;
    int failures;
} caller;

static void *call_often(void *argument) {
    caller *c = (caller *)argument;
    paradt_points points = points_of(&c->s);
    for (int i = 0; i < 5; i++) {
        paradt_triangulation t;
        paradt_fault fault;
        if (paradt_triangulate(&t, &points, &c->options) != PARADT_OK || paradt_hash(&t) != c->alone ||
            paradt_check(&t, &points, NULL, &fault) != PARADT_OK)
            c->failures++;
        paradt_free(&t);
    }
    return NULL;
}

static void many_calls_at_once_do_not_disturb_each_other(void **state) {
    enum { CALLERS = 8 };
    static caller callers[CALLERS];
    (void)state;
    for (int i = 0; i < CALLERS; i++) {
        caller *c = &callers[i];
        c->s = family_make(&families[i % 2 ? 5 : i], &weightings[i % 3], 2 + i % 3, points_in[2 + i % 3], 3);
        c->options.method = (paradt_method)(i % PARADT_METHOD_COUNT);
        c->options.regions = (size_t)(i % 4);
        paradt_points points = points_of(&c->s);
        paradt_triangulation t;
        assert_int_equal(paradt_triangulate(&t, &points, &c->options), PARADT_OK);
        c->alone = paradt_hash(&t);
        paradt_free(&t);
    }
    for (int i = 0; i < CALLERS; i++)
        assert_int_equal(pthread_create(&callers[i].thread, NULL, call_often, &callers[i]), 0);
    for (int i = 0; i < CALLERS; i++)
        pthread_join(callers[i].thread, NULL);
    for (int i = 0; i < CALLERS; i++) {
        assert_int_equal(callers[i].failures, 0);
        sample_free(&callers[i].s);
    }
}

// The hash is the sum of the hashes of the cells. It does not depend on the order of a cell's vertices, and differs for other sets.
static void the_hash_is_one_of_a_set(void **state) {
    sample s = family_make(&families[0], NULL, 3, 100, 9);
    paradt_points points = points_of(&s);
    paradt_triangulation t;
    uint64_t sum = 0, whole;
    (void)state;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    whole = paradt_hash(&t);
    for (size_t c = 0; c < t.cell_count; c++) {
        uint64_t v[4], turned[4];
        for (size_t i = 0; i < 4; i++) {
            v[i] = (uint64_t)t.cells[4 * c + i];
            turned[(i + c + 1) % 4] = v[i];
        }
        uint64_t one = paradt_hash_cell(v, 4);
        assert_true(one == paradt_hash_cell(turned, 4));
        sum += one;
        v[c % 4] += 1000;
        assert_true(one != paradt_hash_cell(v, 4));
    }
    assert_true(sum == whole);
    t.cell_count--;
    assert_true(paradt_hash(&t) != whole);
    t.cell_count++;
    paradt_free(&t);
    sample_free(&s);
}

// What the searches of a front look at, a cell
static double effort_of(const char *name, paradt_method method, size_t regions, int count) {
    sample s = family_make(&families[family_named(name)], NULL, 2, count, 5);
    paradt_points points = points_of(&s);
    paradt_options options = {0};
    paradt_triangulation t;
    options.method = method;
    options.regions = regions;
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
    double effort = (double)(t.stats.grid_cells_visited + t.stats.orient_calls + t.stats.insphere_calls) / (double)t.cell_count;
    paradt_free(&t);
    sample_free(&s);
    return effort;
}

// Where many points are on the hull's facets, or off them by rounding errors, a search must not look at all of them.
static void fronts_take_as_much_a_cell_in_larger_sets(void **state) {
    static const char *const in[] = {"tilted lattice", "two hyperplanes"};
    (void)state;
    for (size_t i = 0; i < 2; i++)
        for (int m = PARADT_INCODE; m <= PARADT_DEWALL; m++)
            for (size_t regions = 1; regions <= 2; regions++) {
                double few = effort_of(in[i], (paradt_method)m, regions, 2500), many = effort_of(in[i], (paradt_method)m, regions, 10000);
                if (many > 1.5 * few + 10)
                    fail_msg("%s in %s, %d regions: %.0f steps a cell among 2500 points, %.0f among 10000",
                             paradt_method_string((paradt_method)m), in[i], (int)regions, few, many);
            }
}

int main(void) {
    static struct CMUnitTest tests[FAMILY_COUNT + 11];
    size_t count = 0;
    for (int f = 0; f < FAMILY_COUNT && !RACES_ONLY; f++)
        tests[count++] = named_test(methods_and_regions_agree, (void *)(intptr_t)f, "methods_and_regions_agree_on_%s",
                                    families[f].name);
    if (!RACES_ONLY) {
        tests[count++] = named_test(more_regions_than_points_agree, NULL, "more_regions_than_points_agree");
        tests[count++] = named_test(a_first_region_that_is_wrong_in_two_places_agrees, NULL,
                                    "a_first_region_that_is_wrong_in_two_places_agrees");
        tests[count++] = named_test(regions_cut_across_an_axis_that_does_not_orient_agree, NULL,
                                    "regions_cut_across_an_axis_that_does_not_orient_agree");
        tests[count++] = named_test(stars_of_thousands_of_cells_agree, NULL, "stars_of_thousands_of_cells_agree");
        tests[count++] = named_test(fronts_take_as_much_a_cell_in_larger_sets, NULL,
                                    "fronts_take_as_much_a_cell_in_larger_sets");
        tests[count++] = named_test(the_hash_is_one_of_a_set, NULL, "the_hash_is_one_of_a_set");
    }
    tests[count++] = named_test(regions_may_run_in_any_order_and_on_threads, NULL,
                                "regions_may_run_in_any_order_and_on_threads");
    tests[count++] = named_test(regions_that_change_hands_build_what_they_build_alone, NULL,
                                "regions_that_change_hands_build_what_they_build_alone");
    tests[count++] = named_test(tasks_between_walls_agree, NULL, "tasks_between_walls_agree");
    tests[count++] = named_test(large_sets_agree, NULL, "large_sets_agree");
    tests[count++] = named_test(many_calls_at_once_do_not_disturb_each_other, NULL,
                                "many_calls_at_once_do_not_disturb_each_other");
    return run_named_tests("methods_agree", tests, count);
}
