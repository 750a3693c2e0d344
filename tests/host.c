// What host programs rely on: the result after errors, the sentences about errors, arguments, points, flags, progress, cancelling.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "paradt.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifndef SANITIZED
#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1 // the program is several times slower, so sets are smaller
#else
#define SANITIZED 0
#endif
#endif

static double *uniform(size_t count, int dim) {
    double *x = (double *)malloc(count * (size_t)dim * sizeof *x + 1);
    uint64_t state = 1;
    assert_non_null(x);
    for (size_t i = 0; i < count * (size_t)dim; i++) {
        state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        x[i] = (double)(state >> 11) * 0x1p-53;
    }
    return x;
}

static paradt_points packed(const double *x, size_t count, int dim) {
    paradt_points points = {0};
    points.data = x;
    points.count = count;
    points.dim = dim;
    return points;
}

typedef struct job {
    void (*task)(void *context, size_t index);
    void *context;
    size_t index;
} job;

static void *run_job(void *argument) {
    job *j = (job *)argument;
    j->task(j->context, j->index);
    return NULL;
}

static void on_threads(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    enum { MOST = 64 };
    job jobs[MOST];
    pthread_t threads[MOST];
    (void)user;
    assert_true(count <= MOST);
    for (size_t i = 0; i < count; i++) {
        job j = {task, context, i};
        jobs[i] = j;
        assert_int_equal(pthread_create(&threads[i], NULL, run_job, &jobs[i]), 0);
    }
    for (size_t i = 0; i < count; i++)
        pthread_join(threads[i], NULL);
}

static void assert_empty(const paradt_triangulation *t) {
    assert_int_equal(t->dim, -1);
    assert_null(t->cells);
    assert_null(t->neighbors);
    assert_null(t->representative);
    assert_true(t->cell_count == 0 && t->point_count == 0);
}

// --- what the result says

static void the_version_is_that_of_the_header(void **state) {
    (void)state;
    assert_int_equal(paradt_version(), PARADT_VERSION);
}

// Bindings to other languages copy the layout of the structure, so fields that may be added come last.
static void statistics_come_last_in_the_result(void **state) {
    (void)state;
    assert_true(offsetof(paradt_triangulation, stats) + sizeof(paradt_stats) == sizeof(paradt_triangulation));
}

static int cancel_at_once(void *user, double fraction) {
    (void)user, (void)fraction;
    return 1;
}

static void results_are_empty_after_every_error(void **state) {
    double *x = uniform(5000, 3);
    paradt_points points = packed(x, 5000, 3), none = packed(NULL, 0, 3);
    paradt_options options = {0};
    paradt_triangulation t;
    (void)state;
    memset(&t, 0xa5, sizeof t);
    assert_int_equal(paradt_triangulate(&t, NULL, NULL), PARADT_ERROR_ARGUMENT);
    assert_empty(&t);
    points.dim = 9;
    memset(&t, 0xa5, sizeof t);
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_ERROR_ARGUMENT);
    assert_empty(&t);
    points.dim = 3;
    options.progress = cancel_at_once;
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_CANCELLED);
    assert_empty(&t);
    assert_true(t.stats.peak_bytes > 0 && t.stats.seconds > 0);
    x[3 * 77 + 1] = x[0] / 0.0;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_ERROR_NOT_FINITE);
    assert_empty(&t);
    assert_int_equal(t.error_point, 77);
    assert_int_equal(paradt_triangulate(&t, &none, NULL), PARADT_OK);
    assert_int_equal(t.dim, -1);
    assert_int_equal(t.cell_count, 0);
    paradt_free(&t);
    assert_empty(&t);
    free(x);
}

// Each call gets the memory that the call before said was needed, and gets further, until the memory is enough.
static void after_memory_the_result_says_how_much_was_needed(void **state) {
    const char *quick = getenv("QUICK");
    const size_t count = SANITIZED ? 1500 : quick && *quick ? 5000 : 6000;
    double *x = uniform(count, 3);
    paradt_points points = packed(x, count, 3);
    (void)state;
    for (int method = 0; method < PARADT_METHOD_COUNT; method++)
        for (int regions = 1; regions <= 3; regions += 2) {
            paradt_options options = {0};
            paradt_triangulation t;
            paradt_status status;
            int tries = 0;
            options.method = (paradt_method)method;
            options.regions = (size_t)regions;
            options.parallel_for = regions > 1 ? on_threads : NULL;
            options.memory_limit = 1000;
            while ((status = paradt_triangulate(&t, &points, &options)) == PARADT_ERROR_MEMORY) {
                assert_empty(&t);
                assert_true(t.stats.peak_bytes <= options.memory_limit);
                assert_true(t.stats.needed_bytes > options.memory_limit);
                assert_true(++tries < 400);
                options.memory_limit = (size_t)t.stats.needed_bytes;
            }
            assert_int_equal(status, PARADT_OK);
            assert_true(tries > 2);
            assert_true(t.stats.needed_bytes == 0);
            assert_true(t.stats.peak_bytes <= options.memory_limit);
            paradt_free(&t);
        }
    free(x);
}

static void the_estimate_is_near_what_is_held(void **state) {
    static const struct {
        int dim;
        size_t count, regions;
        paradt_method method;
        unsigned flags;
    } calls[] = {{2, 50000, 1, PARADT_AUTO, 0},          {2, 50000, 4, PARADT_AUTO, 0},
                 {3, 50000, 1, PARADT_AUTO, 0},          {3, 50000, 1, PARADT_AUTO, PARADT_NO_NEIGHBORS},
                 {3, 90000, 2, PARADT_AUTO, 0},          {3, 50000, 8, PARADT_AUTO, 0},
                 {3, 50000, 8, PARADT_AUTO, PARADT_NO_NEIGHBORS}, {3, 10000, 1, PARADT_INCODE, 0},
                 {3, 10000, 4, PARADT_DEWALL, 0},        {4, 2000, 1, PARADT_AUTO, 0},
                 {4, 2000, 4, PARADT_AUTO, 0},           {5, 500, 1, PARADT_BOWYER_WATSON, 0},
                 {2, 20000, 1, PARADT_DELAUNAY_TREE, 0}, {3, 20000, 1, PARADT_DELAUNAY_TREE, 0},
                 {5, 500, 1, PARADT_DELAUNAY_TREE, 0},
                 {3, 20000, 1, PARADT_FLIP, 0},          {4, 2000, 1, PARADT_FLIP, 0},
                 {3, 20000, 1, PARADT_LIFTED_HULL, 0}};
    paradt_points points = {0};
    paradt_options options = {0};
    paradt_triangulation t;
    (void)state;
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; i += SANITIZED ? 3 : 1) {
        double *x = uniform(calls[i].count, calls[i].dim);
        points = packed(x, calls[i].count, calls[i].dim);
        options.regions = calls[i].regions;
        options.method = calls[i].method;
        options.flags = calls[i].flags;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        points.data = NULL;
        double ratio = (double)paradt_memory_estimate(&points, &options) / (double)t.stats.peak_bytes;
        if (!(ratio > 0.9 && ratio < 2.2))
            fail_msg("call %u: the estimate is %.2f of what was held", (unsigned)i, ratio);
        paradt_free(&t);
        free(x);
    }
    points.dim = 9;
    assert_true(paradt_memory_estimate(&points, NULL) == 0);
    assert_true(paradt_memory_estimate(NULL, NULL) == 0);
}

// Half a million points are built one region after another, where no neighbours are wanted.
static void without_neighbours_many_points_take_fewer_bytes(void **state) {
    paradt_points fewer = packed(NULL, 499999, 3), more = packed(NULL, 500000, 3);
    paradt_options options = {0};
    (void)state;
    assert_true(paradt_memory_estimate(&more, &options) > paradt_memory_estimate(&fewer, &options));
    options.flags = PARADT_NO_NEIGHBORS;
    assert_true(paradt_memory_estimate(&more, &options) < paradt_memory_estimate(&fewer, &options));
}

static void one_point_has_no_facets(void **state) {
    static const double x[] = {1, 2, 3, 1, 2, 3};
    paradt_index none[] = {-1};
    (void)state;
    for (size_t count = 1; count <= 2; count++) {
        paradt_points points = packed(x, count, 3);
        paradt_triangulation t;
        paradt_fault fault;
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        assert_int_equal(t.dim, 0);
        assert_int_equal(t.cell_count, 1);
        assert_int_equal(t.cells[0], 0);
        assert_null(t.neighbors);
        assert_true(t.stats.hull_facets == 0);
        assert_int_equal(paradt_check(&t, &points, NULL, &fault), PARADT_OK);
        t.neighbors = none; // other programs may say explicitly that there is no neighbour
        assert_int_equal(paradt_check(&t, &points, NULL, &fault), PARADT_OK);
        t.neighbors = NULL;
        paradt_free(&t);
    }
}

// --- arguments: each error has its sentence

typedef struct call {
    paradt_points points;
    paradt_options options;
} call;

static void *some_alloc(void *user, size_t size) {
    (void)user;
    return malloc(size);
}

static void some_free(void *user, void *memory) {
    (void)user;
    free(memory);
}

static void dim_9(call *c) { c->points.dim = 9; }
static void dim_0(call *c) { c->points.dim = 0; }
static void no_data(call *c) { c->points.data = NULL; }
static void scalar_2(call *c) { c->points.scalar = (paradt_scalar)2; }
static void stride_in_elements(call *c) { c->points.stride = 3; }
static void weight_scalar_9(call *c) { c->points.weight_scalar = (paradt_scalar)9; }
static void weight_stride_in_elements(call *c) { c->points.weight_stride = 1; }
static void method_77(call *c) { c->options.method = (paradt_method)77; }
static void partition_2(call *c) { c->options.partition = (paradt_partition)2; }
static void facets_of_nothing(call *c) { c->options.flags = PARADT_NO_NEIGHBORS | PARADT_FACETS; }
static void flags_not_zeroed(call *c) { c->options.flags = 0xcdcdcdcd; }
static void alloc_alone(call *c) { c->options.allocator.alloc = some_alloc; }
static void free_alone(call *c) { c->options.allocator.free = some_free; }

static const struct {
    void (*spoil)(call *c);
    const char *says;
} spoilers[] = {{dim_9, "dim"},
                {dim_0, "dim"},
                {no_data, "data"},
                {scalar_2, "scalar"},
                {stride_in_elements, "bytes"},
                {weight_scalar_9, "weight_scalar"},
                {weight_stride_in_elements, "weight_stride"},
                {method_77, "method"},
                {partition_2, "partition"},
                {flags_not_zeroed, "flags"},
                {facets_of_nothing, "PARADT_FACETS"},
                {alloc_alone, "has alloc but not free"},
                {free_alone, "has free but not alloc"}};

static void every_argument_error_says_which_and_why(void **state) {
    double *x = uniform(10, 3);
    const call good = {packed(x, 10, 3), {0}};
    paradt_triangulation made, t;
    paradt_fault fault;
    (void)state;
    assert_int_equal(paradt_triangulate(&made, &good.points, NULL), PARADT_OK);
    assert_null(made.error_text);
    for (size_t i = 0; i < sizeof spoilers / sizeof spoilers[0]; i++) {
        call c = good;
        spoilers[i].spoil(&c);
        assert_int_equal(paradt_triangulate(&t, &c.points, &c.options), PARADT_ERROR_ARGUMENT);
        assert_non_null(t.error_text);
        assert_non_null(strstr(t.error_text, spoilers[i].says));
        assert_int_equal(paradt_check(&made, &c.points, &c.options, &fault), PARADT_ERROR_ARGUMENT);
        assert_string_equal(fault.reason, t.error_text);
        assert_true(fault.cell == -1 && fault.point == -1);
    }
    assert_int_equal(paradt_triangulate(&t, NULL, NULL), PARADT_ERROR_ARGUMENT);
    assert_string_equal(t.error_text, "points is NULL");
    assert_int_equal(paradt_check(NULL, &good.points, NULL, &fault), PARADT_ERROR_ARGUMENT);
    assert_string_equal(fault.reason, "triangulation is NULL");
    t = made;
    t.cells = NULL;
    assert_int_equal(paradt_check(&t, &good.points, NULL, &fault), PARADT_ERROR_ARGUMENT);
    assert_non_null(strstr(fault.reason, "cells"));
    t = made;
    t.representative = NULL;
    assert_int_equal(paradt_check(&t, &good.points, NULL, &fault), PARADT_ERROR_ARGUMENT);
    assert_non_null(strstr(fault.reason, "representative"));
    paradt_free(&made);
    free(x);
}

// Errors without a sentence of their own have that of paradt_status_string.
static void every_other_error_has_a_sentence_too(void **state) {
    static const double places[3][6] = {{1, 1, 1, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, {0}};
    double *x = uniform(5000, 3);
    paradt_points points = packed(x, SIZE_MAX / 2, 3), none = packed(NULL, 0, 3);
    paradt_options options = {0};
    paradt_triangulation t;
    paradt_fault fault;
    (void)state;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_ERROR_TOO_LARGE);
    assert_non_null(strstr(t.error_text, "points.count"));
    points.count = 5000;
    points.stride = SIZE_MAX / 16;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_ERROR_TOO_LARGE);
    assert_non_null(strstr(t.error_text, "points.stride"));
    points.stride = 0;
    points.weights = x;
    points.weight_stride = SIZE_MAX / 16;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_ERROR_TOO_LARGE);
    assert_non_null(strstr(t.error_text, "points.weight_stride"));
    points.weights = NULL;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    options.memory_limit = 100;
    assert_int_equal(paradt_check(&t, &points, &options, &fault), PARADT_ERROR_MEMORY);
    assert_string_equal(fault.reason, paradt_status_string(PARADT_ERROR_MEMORY));
    paradt_free(&t);
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_MEMORY);
    assert_string_equal(t.error_text, paradt_status_string(PARADT_ERROR_MEMORY));
    options.memory_limit = 0;
    options.flags = PARADT_FULL_DIM;
    for (size_t count = 1; count <= 2; count++)
        for (int i = 0; i < 2; i++) {
            points = packed(places[i], count, 3);
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_FLAT);
            assert_string_equal(t.error_text, i && count == 2 ? "all points lie on a line" : "all points are at one place");
        }
    assert_int_equal(paradt_triangulate(&t, &none, &options), PARADT_ERROR_FLAT);
    assert_string_equal(t.error_text, "there are no points");
    free(x);
}

// --- flags

static void half_facets_lead_there_and_back(void **state) {
    (void)state;
    for (int dim = 2; dim <= 5; dim++)
        for (int method = 0; method < PARADT_METHOD_COUNT; method++)
            for (size_t regions = 1; regions <= 3; regions += 2) {
                size_t count = dim < 4 ? (SANITIZED ? 500 : 2000) : SANITIZED ? 60 : 150, k = (size_t)dim + 1, hull = 0;
                double *x = uniform(count, dim);
                paradt_points points = packed(x, count, dim);
                paradt_options options = {0};
                paradt_triangulation t;
                paradt_fault fault;
                options.method = (paradt_method)method;
                options.regions = regions;
                options.flags = PARADT_FACETS;
                assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
                for (size_t f = 0; f < t.cell_count * k; f++) {
                    paradt_index g = t.neighbors[f];
                    hull += g < 0;
                    if (g < 0)
                        continue;
                    assert_true((size_t)g < t.cell_count * k && (size_t)g / k != f / k);
                    assert_true(t.neighbors[g] == (paradt_index)f);
                    for (size_t i = 0; i < k; i++) { // the facet's vertices are all but one of the neighbour's
                        const paradt_index *other = t.cells + (size_t)g / k * k;
                        size_t j = 0;
                        while (j < k && (j == (size_t)g % k || other[j] != t.cells[f / k * k + i]))
                            j++;
                        assert_true((j == k) == (i == f % k));
                    }
                }
                assert_true(hull == t.stats.hull_facets);
                assert_int_equal(paradt_check(&t, &points, &options, &fault), PARADT_OK);
                for (int change = 0; change < 40; change++) {
                    size_t f = (size_t)change * 37 % (t.cell_count * k);
                    paradt_index right = t.neighbors[f];
                    // Another facet of the right neighbour, a facet of another cell, none, one that does not exist
                    const paradt_index wrong[] = {right < 0 ? 0 : right / (paradt_index)k * (paradt_index)k +
                                                                      (right % (paradt_index)k + 1) % (paradt_index)k,
                                                  (paradt_index)((f + 3 * k) % (t.cell_count * k)), right < 0 ? 1 : -1,
                                                  (paradt_index)(t.cell_count * k), -2};
                    t.neighbors[f] = wrong[change % 5];
                    if (t.neighbors[f] != right)
                        assert_int_equal(paradt_check(&t, &points, &options, &fault), PARADT_ERROR_INVALID);
                    t.neighbors[f] = right;
                }
                assert_int_equal(paradt_check(&t, &points, NULL, &fault), PARADT_ERROR_INVALID); // facets are not cells
                paradt_free(&t);
                free(x);
            }
}

static void a_lower_dimension_is_an_error_if_asked_for(void **state) {
    static const double flat[] = {0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 5, 6, 1};
    static const double solid[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    paradt_points points = packed(flat, 5, 3), spanning = packed(solid, 4, 3), none = packed(NULL, 0, 3);
    (void)state;
    for (int method = 0; method < PARADT_METHOD_COUNT; method++)
        for (size_t regions = 1; regions <= 2; regions++) {
            paradt_options options = {0};
            paradt_triangulation t;
            options.method = (paradt_method)method;
            options.regions = regions;
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            assert_int_equal(t.dim, 2);
            options.flags = PARADT_FULL_DIM;
            // paradt_check accepts the same options.
            assert_int_equal(paradt_check(&t, &points, &options, NULL), PARADT_OK);
            paradt_free(&t);
            memset(&t, 0xa5, sizeof t);
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_FLAT);
            assert_empty(&t);
            assert_int_equal(paradt_triangulate(&t, &none, &options), PARADT_ERROR_FLAT);
            assert_empty(&t);
            assert_int_equal(paradt_triangulate(&t, &spanning, &options), PARADT_OK);
            assert_int_equal(t.dim, 3);
            assert_int_equal(t.cell_count, 1);
            paradt_free(&t);
        }
}

// --- points and predicates

static void weights_may_be_members_and_floats(void **state) {
    enum { COUNT = 500 };
    static struct {
        char tag;
        double place[3];
        float radius, weight;
        double wide;
    } atoms[COUNT];
    static double weights[COUNT];
    static float narrow[COUNT];
    double *x = uniform(COUNT, 4);
    paradt_points points = paradt_points_f64(x, COUNT, 3);
    paradt_triangulation t;
    paradt_fault fault;
    uint64_t hash;
    (void)state;
    for (size_t i = 0; i < COUNT; i++) {
        narrow[i] = (float)(x[3 * COUNT + i] * 0.02 - 0.005);
        weights[i] = (double)narrow[i];
        atoms[i].weight = narrow[i];
        atoms[i].wide = weights[i];
        atoms[i].radius = -1e30f;
        memcpy(atoms[i].place, x + 3 * i, sizeof atoms[i].place);
    }
    points.weights = weights;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    hash = paradt_hash(&t);
    assert_true(t.stats.hidden > 0);
    for (int way = 0; way < 4; way++) {
        if (way >= 2)
            points.data = atoms[0].place;
        points.stride = way < 2 ? 0 : sizeof atoms[0];
        points.weights = way == 0 ? (const void *)narrow : way % 2 ? (const void *)&atoms[0].weight : &atoms[0].wide;
        points.weight_stride = way == 0 ? 0 : sizeof atoms[0];
        points.weight_scalar = way == 2 ? PARADT_F64 : PARADT_F32;
        assert_int_equal(paradt_check(&t, &points, NULL, &fault), PARADT_OK);
        paradt_triangulation other;
        assert_int_equal(paradt_triangulate(&other, &points, NULL), PARADT_OK);
        assert_true(paradt_hash(&other) == hash);
        paradt_free(&other);
    }
    paradt_free(&t);
    atoms[7].weight = (float)x[0] / 0.0f;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(t.error_point, 7);
    free(x);
}

static void typed_helpers_fill_the_points(void **state) {
    enum { COUNT = 300 };
    static float narrow[COUNT][2];
    static double wide[COUNT][2];
    double *x = uniform(COUNT, 2);
    paradt_triangulation t;
    paradt_points points;
    (void)state;
    for (int i = 0; i < 2 * COUNT; i++)
        wide[i / 2][i % 2] = (double)(narrow[i / 2][i % 2] = (float)x[i]);
    points = paradt_points_f32(narrow[0], COUNT, 2);
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    points = paradt_points_f64(wide[0], COUNT, 2);
    assert_int_equal(paradt_check(&t, &points, NULL, NULL), PARADT_OK);
    paradt_free(&t);
    free(x);
}

static uint64_t random_state = 1;

static uint64_t random_bits(void) {
    random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return random_state >> 24 ^ random_state << 40;
}

// Returns a coordinate of a kind: any float, near 1, a small integer (many ties), huge, subnormal, mixed.
static double coordinate(int kind) {
    double u = (double)(random_bits() >> 11) * 0x1p-53, any;
    uint64_t bits = random_bits();
    switch (kind) {
    case 0: return u;
    case 1: return (double)(int)(u * 3);
    case 2: return 1 + (double)(int)(u * 3) * 0x1p-52;
    case 3: return u * 1e300;
    case 4: return (double)(int)(u * 4) * 0x1p-1074;
    case 5: return (double)(int)(u * 3) * 0x1p99 + (double)(int)(u * 7) * 0x1p47;
    case 6: return u * 1e-200;
    default:
        memcpy(&any, &bits, sizeof any);
        return any - any == 0 ? any : u;
    }
}

static float narrow_coordinate(int kind) {
    uint32_t bits = (uint32_t)random_bits();
    float any;
    if (kind == 3 || kind == 4 || kind > 5) {
        memcpy(&any, &bits, sizeof any);
        if (kind == 4) // subnormal
            any = (float)(int)(bits % 4) * 0x1p-149f;
        return any - any == 0 ? any : 1;
    }
    return (float)coordinate(kind);
}

static void predicates_of_coordinates_have_the_signs_of_those_of_pointers(void **state) {
    enum { KINDS = 8, ROUNDS = 20000 };
    int zeros = 0;
    (void)state;
    for (int round = 0; round < ROUNDS; round++) {
        double x[5][3], wide[5][3];
        float narrow[5][3];
        const double *p2[] = {x[0], x[1], x[2], x[3]}, *p3[] = {x[0], x[1], x[2], x[3], x[4]};
        const double *w2[] = {wide[0], wide[1], wide[2], wide[3]}, *w3[] = {wide[0], wide[1], wide[2], wide[3], wide[4]};
        for (int i = 0; i < 15; i++) {
            x[i / 3][i % 3] = coordinate(round % KINDS);
            narrow[i / 3][i % 3] = narrow_coordinate(round % KINDS);
            wide[i / 3][i % 3] = (double)narrow[i / 3][i % 3];
        }
        int signs[] = {paradt_orient2(x[0], x[1], x[2]),
                       paradt_orient3(x[0], x[1], x[2], x[3]),
                       paradt_insphere2(x[0], x[1], x[2], x[3]),
                       paradt_insphere3(x[0], x[1], x[2], x[3], x[4]),
                       paradt_orient2f(narrow[0], narrow[1], narrow[2]),
                       paradt_orient3f(narrow[0], narrow[1], narrow[2], narrow[3]),
                       paradt_insphere2f(narrow[0], narrow[1], narrow[2], narrow[3]),
                       paradt_insphere3f(narrow[0], narrow[1], narrow[2], narrow[3], narrow[4])};
        int expected[] = {paradt_orient(2, p2), paradt_orient(3, p3), paradt_insphere(2, p2, NULL),
                          paradt_insphere(3, p3, NULL), paradt_orient(2, w2), paradt_orient(3, w3),
                          paradt_insphere(2, w2, NULL), paradt_insphere(3, w3, NULL)};
        for (int i = 0; i < 8; i++) {
            assert_int_equal(signs[i], expected[i]);
            zeros += signs[i] == 0;
        }
    }
    assert_true(zeros > ROUNDS / 10);
}

// --- progress

typedef struct watch {
    double last, longest, called; // fraction; longest time between calls; time of the last one
    size_t calls, cancel_at;
    int inside, overlapped, fell, outside;
} watch;

static double seconds(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

// Takes no lock, so it notices calls by several threads at a time.
static int look(void *user, double fraction) {
    watch *w = (watch *)user;
    w->overlapped += w->inside++;
    w->fell += fraction < w->last;
    w->outside += !(fraction >= 0 && fraction <= 1);
    w->last = fraction;
    w->calls++;
    if (seconds() - w->called > w->longest)
        w->longest = seconds() - w->called;
    w->called = seconds();
    w->inside--;
    return w->cancel_at && w->calls >= w->cancel_at;
}

static watch begin_watch(paradt_options *options) {
    watch w = {0};
    options->progress = look;
    w.called = seconds();
    return w;
}

// The fraction is that of the whole call, into however many parts the work is divided.
static void progress_is_one_fraction_that_never_falls(void **state) {
    enum { PART = SANITIZED ? 3 : 1 };
    static const struct {
        int dim, method;
        size_t count, regions;
        int threads;
        unsigned flags;
    } ways[] = {{3, PARADT_AUTO, 60000, 1, 0, 0},        {3, PARADT_AUTO, 60000, 3, 0, 0},
                {3, PARADT_AUTO, 60000, 3, 0, PARADT_NO_NEIGHBORS}, {3, PARADT_AUTO, 60000, 4, 1, 0},
                {2, PARADT_AUTO, 60000, 4, 1, 0},        {3, PARADT_INCODE, 20000, 1, 0, 0},
                {3, PARADT_INCODE, 20000, 3, 0, 0},      {3, PARADT_DEWALL, 20000, 4, 1, 0},
                {4, PARADT_AUTO, 5000, 1, 0, 0},         {4, PARADT_AUTO, 5000, 3, 1, 0}};
    (void)state;
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++)
        for (int lattice = 0; lattice < 2; lattice++) {
            size_t count = ways[i].count / PART;
            double *x = uniform(count, ways[i].dim);
            paradt_points points = packed(x, count, ways[i].dim);
            paradt_options options = {0};
            paradt_triangulation t;
            for (size_t j = 0; lattice && j < count * (size_t)ways[i].dim; j++)
                x[j] = (double)(int)(x[j] * 16); // a lattice, on which some methods give up
            options.method = (paradt_method)ways[i].method;
            options.regions = ways[i].regions;
            options.flags = ways[i].flags;
            options.parallel_for = ways[i].threads ? on_threads : NULL;
            watch w = begin_watch(&options);
            options.user = &w;
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            assert_true(w.calls > 5);
            assert_int_equal(w.overlapped + w.fell + w.outside, 0);
            assert_true(w.last == 1);
            w = begin_watch(&options);
            assert_int_equal(paradt_check(&t, &points, &options, NULL), PARADT_OK);
            assert_true(w.calls > 5);
            assert_int_equal(w.overlapped + w.fell + w.outside, 0);
            assert_true(w.last == 1);
            paradt_free(&t);
            free(x);
        }
}

// Cancels after the points are read and sorted. Until then the calls must follow each other quickly.
static int look_while_reading(void *user, double fraction) {
    watch *w = (watch *)user;
    double now = (double)clock() / CLOCKS_PER_SEC;
    w->calls++;
    if (now - w->called > w->longest)
        w->longest = now - w->called;
    w->called = now;
    return fraction >= 0.1;
}

static void points_are_read_in_short_steps(void **state) {
    enum { COUNT = 2000000 };
    double *x = uniform(COUNT, 3);
    paradt_points points = packed(x, COUNT, 3);
    paradt_options options = {0};
    paradt_triangulation t;
    watch w = {0};
    (void)state;
    options.progress = look_while_reading;
    options.user = &w;
    w.called = (double)clock() / CLOCKS_PER_SEC;
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_CANCELLED);
    assert_true(w.calls > 200);
    assert_true(w.longest < 0.1); // processor time, several times that of an idle machine, because other programs lengthen it
    free(x);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_version_is_that_of_the_header),
        cmocka_unit_test(statistics_come_last_in_the_result),
        cmocka_unit_test(results_are_empty_after_every_error),
        cmocka_unit_test(after_memory_the_result_says_how_much_was_needed),
        cmocka_unit_test(the_estimate_is_near_what_is_held),
        cmocka_unit_test(without_neighbours_many_points_take_fewer_bytes),
        cmocka_unit_test(one_point_has_no_facets),
        cmocka_unit_test(every_argument_error_says_which_and_why),
        cmocka_unit_test(every_other_error_has_a_sentence_too),
        cmocka_unit_test(half_facets_lead_there_and_back),
        cmocka_unit_test(a_lower_dimension_is_an_error_if_asked_for),
        cmocka_unit_test(weights_may_be_members_and_floats),
        cmocka_unit_test(typed_helpers_fill_the_points),
        cmocka_unit_test(predicates_of_coordinates_have_the_signs_of_those_of_pointers),
        cmocka_unit_test(progress_is_one_fraction_that_never_falls),
        cmocka_unit_test(points_are_read_in_short_steps),
    };
    return cmocka_run_group_tests_name("host", tests, NULL, NULL);
}
