// What callers hand in: floats, strides, negative zeros, NaN and infinity, duplicates, arguments out of range.
#include "harness.h"

#include <float.h>

static void expect_status(paradt_status expected, const paradt_points *points, const paradt_options *options) {
    paradt_triangulation t;
    memset(&t, 0xa5, sizeof t);
    paradt_status status = paradt_triangulate(&t, points, options);
    assert_int_equal(status, expected);
    if (status != PARADT_OK) {
        // The output is empty: no arrays, no counts, nothing for paradt_free to release.
        assert_null(t.cells);
        assert_null(t.neighbors);
        assert_null(t.representative);
        assert_int_equal(t.cell_count, 0);
        assert_int_equal(t.point_count, 0);
    }
    paradt_free(&t);
}

// Triangulates the points and returns the cells as a set.
static cell_set triangulate_points(const paradt_points *points, const paradt_options *options) {
    paradt_triangulation t;
    memset(&t, 0x5a, sizeof t); // the earlier contents of the output have no influence
    assert_int_equal(paradt_triangulate(&t, points, options), PARADT_OK);
    cell_set cells = cells_of(&t, NULL);
    paradt_free(&t);
    return cells;
}

static void floats_give_what_their_doubles_give(void **state) {
    (void)state;
    for (int dim = 2; dim <= 5; dim++)
        for (int f = 0; f < FAMILY_COUNT; f++) {
            sample s = family_make(&families[f], &weightings[f % 3], dim, dim < 4 ? 60 : 20, 4);
            float *x = (float *)need((size_t)(s.count * dim), sizeof(float));
            for (int i = 0; i < s.count * dim; i++) {
                if (fabs(s.x[i]) > FLT_MAX) // huge doubles become huge floats
                    s.x[i] = ldexp(s.x[i], -896);
                if (s.x[i] != 0 && fabs(s.x[i]) < 0x1p-1000) // subnormal doubles become subnormal floats
                    s.x[i] = ldexp(s.x[i], 925);
                x[i] = (float)s.x[i];
                s.x[i] = (double)x[i];
            }
            paradt_points points = points_of(&s);
            watch(&s, 60);
            cell_set doubles = triangulate_points(&points, NULL);
            points.data = x;
            points.scalar = PARADT_F32;
            cell_set floats = triangulate_points(&points, NULL);
            fail_if_different(&s, "floats", &doubles, &floats);
            watch(NULL, 0);
            cells_free(&doubles);
            cells_free(&floats);
            free(x);
            sample_free(&s);
        }
}

// Bytes between the points are not read, and points need not be aligned.
static void any_stride_is_read(void **state) {
    static const size_t gaps[] = {0, 4, 8, 1, 3, 24, 1000};
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (int scalar = 0; scalar < 2; scalar++) {
            sample s = family_make(&families[5], NULL, dim, 50, 8); // small integers: the same as floats
            paradt_points points = points_of(&s);
            cell_set packed = triangulate_points(&points, NULL);
            for (size_t g = 0; g < sizeof gaps / sizeof gaps[0]; g++) {
                size_t size = (scalar ? sizeof(float) : sizeof(double)) * (size_t)dim, stride = size + gaps[g];
                unsigned char *bytes = (unsigned char *)malloc(stride * (size_t)s.count);
                assert_non_null(bytes);
                memset(bytes, 0xff, stride * (size_t)s.count); // 0xff...: NaN
                for (int i = 0; i < s.count; i++)
                    for (int k = 0; k < dim; k++) {
                        float narrow = (float)s.x[i * dim + k];
                        if (scalar)
                            memcpy(bytes + (size_t)i * stride + (size_t)k * sizeof narrow, &narrow, sizeof narrow);
                        else
                            memcpy(bytes + (size_t)i * stride + (size_t)k * sizeof(double), &s.x[i * dim + k], sizeof(double));
                    }
                points.data = bytes;
                points.stride = stride;
                points.scalar = scalar ? PARADT_F32 : PARADT_F64;
                cell_set strided = triangulate_points(&points, NULL);
                fail_if_different(&s, "with a stride", &packed, &strided);
                cells_free(&strided);
                free(bytes);
            }
            cells_free(&packed);
            sample_free(&s);
        }
}

static void a_negative_zero_is_a_zero(void **state) {
    (void)state;
    for (int dim = 2; dim <= 5; dim++)
        for (uint64_t seed = 1; seed < 20; seed++) {
            int f = family_named("signed zeros");
            sample s = family_make(&families[f], NULL, dim, 24, seed);
            paradt_points points = points_of(&s);
            cell_set with = triangulate_points(&points, NULL);
            for (int i = 0; i < s.count * dim; i++)
                if (s.x[i] == 0)
                    s.x[i] = 0;
            cell_set without = triangulate_points(&points, NULL);
            fail_if_different(&s, "without negative zeros", &with, &without);
            cells_free(&with);
            cells_free(&without);
            // A weight of negative zero is zero too.
            s.w = (double *)need((size_t)s.count, sizeof(double));
            for (int i = 0; i < s.count; i++)
                s.w[i] = i % 2 ? -0.0 : 0.0;
            points.weights = s.w;
            cell_set weighted = triangulate_points(&points, NULL);
            for (int i = 0; i < s.count; i++)
                s.w[i] = 0.0;
            cell_set unweighted = triangulate_points(&points, NULL);
            fail_if_different(&s, "weights of negative zero", &unweighted, &weighted);
            cells_free(&weighted);
            cells_free(&unweighted);
            sample_free(&s);
        }
}

static void the_first_point_that_is_not_finite_is_named(void **state) {
    static const uint64_t doubles[] = {0x7ff0000000000000u, 0xfff0000000000000u, 0x7ff8000000000000u,
                                       0x7ff0000000000001u, 0xffffffffffffffffu};
    static const uint32_t floats[] = {0x7f800000u, 0xff800000u, 0x7fc00000u, 0x7f800001u, 0xffffffffu};
    enum { N = 40, DIM = 3 };
    (void)state;
    for (int kind = 0; kind < 5; kind++)
        for (int at = 0; at < N; at++)
            for (int what = 0; what < 3; what++) { // a double, a float, a weight
                sample s = family_make(&families[0], &weightings[1], DIM, N, 2);
                float narrow[N * DIM];
                paradt_points points = points_of(&s);
                paradt_options options = {0};
                paradt_triangulation t;
                options.regions = (size_t)(at % 3);
                options.method = (paradt_method)(at % PARADT_METHOD_COUNT);
                for (int i = 0; i < N * DIM; i++)
                    narrow[i] = (float)s.x[i];
                // A second point that is not finite follows the first, here and there.
                for (int i = at; i < N; i += 1 + (N - at) / 2) {
                    memcpy(&s.x[i * DIM + (i + kind) % DIM], &doubles[kind], what == 0 ? sizeof(double) : 0);
                    memcpy(&narrow[i * DIM + (i + kind) % DIM], &floats[kind], what == 1 ? sizeof(float) : 0);
                    memcpy(&s.w[i], &doubles[kind], what == 2 ? sizeof(double) : 0);
                }
                if (what == 1) {
                    points.data = narrow;
                    points.scalar = PARADT_F32;
                    points.weights = NULL;
                }
                memset(&t, 0xa5, sizeof t);
                assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_ERROR_NOT_FINITE);
                assert_int_equal(t.error_point, at);
                assert_null(t.cells);
                assert_null(t.neighbors);
                assert_null(t.representative);
                assert_int_equal(t.cell_count, 0);
                paradt_free(&t);
                sample_free(&s);
            }
}

static void the_first_of_equal_points_stands_for_them(void **state) {
    static const double x[][3] = {{1, 1, 1},  {0, 0, 0}, {1, 0, 0},   {0, 1, 0}, {-0.0, 0, 0},
                                  {1, -0., 0}, {0, 0, 1}, {0, 0, -0.}, {0, 1, 0}, {1, 1, 1}};
    static const int expected[] = {0, 1, 2, 3, 1, 2, 6, 1, 3, 0};
    (void)state;
    for (int method = 0; method < PARADT_METHOD_COUNT; method++) {
        paradt_points points = {0};
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = (paradt_method)method;
        points.data = x;
        points.count = 10;
        points.dim = 3;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        for (int i = 0; i < 10; i++)
            assert_int_equal(t.representative[i], expected[i]);
        assert_int_equal(t.stats.duplicates, 5);
        assert_int_equal(t.stats.hidden, 0);
        paradt_free(&t);
    }
}

static void the_heaviest_of_equal_points_stands_for_them(void **state) {
    static const double x[][2] = {{0, 0}, {4, 0}, {0, 4}, {4, 4}, {0, 0}, {4, 0}, {0, 4}, {2, 2}, {2, 2}};
    static const double w[] = {1, 2, 3, 0, 1.5, 2, -3, -90, -80};
    static const int expected[] = {4, 1, 2, 3, 4, 1, 2, -1, -1}; // the last two are equal and hidden
    (void)state;
    for (int method = 0; method < PARADT_METHOD_COUNT; method++) {
        paradt_points points = {0};
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = (paradt_method)method;
        points.data = x;
        points.count = 9;
        points.dim = 2;
        points.weights = w;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        for (int i = 0; i < 9; i++)
            assert_int_equal(t.representative[i], expected[i]);
        assert_int_equal(t.cell_count, 2);
        assert_int_equal(t.stats.duplicates, 4);
        assert_int_equal(t.stats.hidden, 1);
        paradt_free(&t);
    }
}

// Points of lower affine dimension have a result: its dim is that dimension, and its cells are those within the affine hull.
static void points_of_lower_dimension_are_no_error(void **state) {
    (void)state;
    for (int dim = 2; dim <= 8; dim++)
        for (int rank = 0; rank <= dim; rank++)
            for (uint64_t seed = 1; seed <= 3; seed++) {
                sample s = sample_make("integers in a subspace", dim, 2 * dim + 6);
                uint64_t random = seed;
                points_in_subspace(&s, &random, rank > 0 ? rank : 1);
                for (int i = 0; rank == 0 && i < s.count * dim; i++)
                    s.x[i] = s.x[i % dim];
                paradt_triangulation t = triangulate_and_verify(&s, NULL, "in a subspace");
                assert_true(t.dim <= rank);
                if (rank == 0) {
                    assert_int_equal(t.dim, 0);
                    assert_int_equal(t.cell_count, 1);
                }
                paradt_free(&t);
                sample_free(&s);
            }
}

static void no_points_give_an_empty_result(void **state) {
    paradt_points points = {0};
    paradt_triangulation t;
    paradt_fault fault;
    (void)state;
    points.dim = 3;
    memset(&t, 0xa5, sizeof t);
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    assert_int_equal(t.dim, -1);
    assert_int_equal(t.cell_count, 0);
    assert_int_equal(t.point_count, 0);
    assert_int_equal(paradt_check(&t, &points, NULL, &fault), PARADT_OK);
    paradt_free(&t);
}

// Returns a block that free() would not accept.
static void *take(void *user, size_t size) {
    char *block = (char *)malloc(size + 64);
    (void)user;
    return block ? block + 64 : NULL;
}

static void give_back(void *user, void *memory) {
    (void)user;
    free(memory ? (char *)memory - 64 : NULL);
}

static void arguments_out_of_range_are_refused(void **state) {
    static const double x[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    paradt_points good = {0}, points;
    paradt_options options = {0};
    paradt_triangulation t;
    (void)state;
    good.data = x;
    good.count = 4;
    good.dim = 3;
    expect_status(PARADT_OK, &good, &options);
    expect_status(PARADT_OK, &good, NULL);
    assert_int_equal(paradt_triangulate(NULL, &good, NULL), PARADT_ERROR_ARGUMENT);
    expect_status(PARADT_ERROR_ARGUMENT, NULL, NULL);
    static const int dims[] = {-1, 0, 1, 9, 1000000};
    for (int i = 0; i < 5; i++) {
        points = good;
        points.dim = dims[i];
        expect_status(PARADT_ERROR_ARGUMENT, &points, NULL);
    }
    points = good;
    points.data = NULL;
    expect_status(PARADT_ERROR_ARGUMENT, &points, NULL);
    points = good;
    points.stride = 3 * sizeof(double) - 1;
    expect_status(PARADT_ERROR_ARGUMENT, &points, NULL);
    points = good;
    points.scalar = (paradt_scalar)2;
    expect_status(PARADT_ERROR_ARGUMENT, &points, NULL);
    options.method = PARADT_METHOD_COUNT;
    expect_status(PARADT_ERROR_ARGUMENT, &good, &options);
    memset(&options, 0, sizeof options);
    options.partition = (paradt_partition)2;
    expect_status(PARADT_ERROR_ARGUMENT, &good, &options);
    memset(&options, 0, sizeof options);
    options.allocator.alloc = take;
    expect_status(PARADT_ERROR_ARGUMENT, &good, &options);
    options.allocator.alloc = NULL;
    options.allocator.free = give_back;
    expect_status(PARADT_ERROR_ARGUMENT, &good, &options);
    memset(&t, 0, sizeof t);
    paradt_free(&t); // does nothing to an empty result
    paradt_free(&t);
    paradt_free(NULL);
}

// The error comes before anything is read or allocated.
static void counts_that_no_index_can_number_are_refused(void **state) {
    static const double x[3] = {0, 0, 0};
    static const size_t counts[] = {(size_t)INT32_MAX + 1, (size_t)INT32_MAX * 2, SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 8,
                                    SIZE_MAX / 24 + 1};
    (void)state;
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++)
        for (int scalar = 0; scalar < 2; scalar++) {
            paradt_points points = {0};
            points.data = x;
            points.count = counts[i];
            points.dim = 3;
            points.scalar = (paradt_scalar)scalar;
            if (sizeof(paradt_index) == 4)
                expect_status(PARADT_ERROR_TOO_LARGE, &points, NULL);
        }
}

static void statuses_and_methods_have_names(void **state) {
    (void)state;
    for (int i = 0; i < PARADT_STATUS_COUNT; i++)
        for (int j = 0; j < i; j++)
            assert_string_not_equal(paradt_status_string((paradt_status)i), paradt_status_string((paradt_status)j));
    for (int i = 0; i < PARADT_METHOD_COUNT; i++)
        for (int j = 0; j < i; j++)
            assert_string_not_equal(paradt_method_string((paradt_method)i), paradt_method_string((paradt_method)j));
    assert_non_null(paradt_status_string(PARADT_STATUS_COUNT));
    assert_non_null(paradt_status_string((paradt_status)-1));
    assert_string_equal(paradt_method_string(PARADT_INCODE), "incode");
    assert_string_equal(paradt_method_string(PARADT_DEWALL), "dewall");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floats_give_what_their_doubles_give),
        cmocka_unit_test(any_stride_is_read),
        cmocka_unit_test(a_negative_zero_is_a_zero),
        cmocka_unit_test(the_first_point_that_is_not_finite_is_named),
        cmocka_unit_test(the_first_of_equal_points_stands_for_them),
        cmocka_unit_test(the_heaviest_of_equal_points_stands_for_them),
        cmocka_unit_test(points_of_lower_dimension_are_no_error),
        cmocka_unit_test(no_points_give_an_empty_result),
        cmocka_unit_test(arguments_out_of_range_are_refused),
        cmocka_unit_test(counts_that_no_index_can_number_are_refused),
        cmocka_unit_test(statuses_and_methods_have_names),
    };
    return cmocka_run_group_tests_name("input", tests, NULL, NULL);
}
