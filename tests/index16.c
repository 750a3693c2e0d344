// The limits on points and cells, met for real: the library is built with indices of 16 bits (PARADT__INDEX16, for tests alone), so
// that there are at most 16,383 points, and cells * (dim + 1) is below 32,768. Where a result is larger, each method says so; up to
// there each is right.
#define PARADT__INDEX16
#if defined(__SANITIZE_ADDRESS__)
#define PARADT_NO_SIMD // other sanitized programs have the code for vectors
#define WAYS 1         // a method is called with regions or without them
#else
#define WAYS 2
#endif
#define PARADT_IMPLEMENTATION
#include "paradt.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
// The headers above come before cmocka's.
#include <cmocka.h>

enum { MOST_POINTS = INT16_MAX / 2, PLACES = INT16_MAX, MOST_DIM = 4 };

static double coordinates[(MOST_POINTS + 2) * MOST_DIM];

static uint64_t drawn;
static double draw(void) {
    drawn = drawn * 6364136223846793005u + 1442695040888963407u;
    return (double)(drawn >> 11) * 0x1p-53;
}

// Uniform points; the first n of them are the same for every n.
static paradt_points uniform(size_t count, int dim) {
    size_t i;
    drawn = 1;
    for (i = 0; i < count * (size_t)dim; i++)
        coordinates[i] = draw();
    return paradt_points_f64(coordinates, count, dim);
}

// Points near a sphere: nearly all are vertices of the hull.
static paradt_points spherical(size_t count, int dim) {
    size_t i;
    int k;
    drawn = 2;
    for (i = 0; i < count; i++) {
        double *x = coordinates + i * (size_t)dim, length;
        do
            for (k = 0, length = 0; k < dim; k++) {
                x[k] = 2 * draw() - 1;
                length += x[k] * x[k];
            }
        while (length > 1 || length < 0.01);
        for (k = 0; k < dim; k++)
            x[k] /= sqrt(length);
    }
    return paradt_points_f64(coordinates, count, dim);
}

// Triangulates and certifies, and returns how many numbers the cells have; 0: they are too many.
static size_t places_of(size_t count, int dim, const paradt_options *options) {
    paradt_points points = uniform(count, dim);
    paradt_triangulation t;
    paradt_fault fault;
    size_t places;
    paradt_status status = paradt_triangulate(&t, &points, options);
    if (status == PARADT_ERROR_TOO_LARGE) {
        assert_null(t.cells);
        assert_int_equal(t.cell_count, 0);
        return 0;
    }
    assert_int_equal(status, PARADT_OK);
    places = t.cell_count * (size_t)(dim + 1);
    assert_true(places <= PLACES);
    assert_int_equal(paradt_check(&t, &points, options, &fault), PARADT_OK);
    paradt_free(&t);
    return places;
}

// A number of points that is not too large, though one more is.
static size_t largest(int dim, const paradt_options *options, size_t *places) {
    size_t low = (size_t)dim + 1, high = MOST_POINTS + 1;
    *places = places_of(low, dim, options);
    assert_true(*places > 0);
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2, got = places_of(middle, dim, options);
        if (got) {
            low = middle;
            *places = got;
        } else
            high = middle;
    }
    return low;
}

static void each_method_is_right_up_to_its_limit(void **state) {
    int dim, method;
    (void)state;
    for (dim = 2; dim <= MOST_DIM; dim++)
        for (method = WAYS == 1 ? dim % 2 : 0; method < 2 * PARADT_METHOD_COUNT; method += 3 - WAYS) {
            paradt_options options;
            size_t count, places;
            memset(&options, 0, sizeof options);
            options.method = (paradt_method)(method / 2);
            options.regions = method % 2 ? 3 : 0;
            count = largest(dim, &options, &places);
            print_message("%dD, %s, %d regions: %lu points, %lu of %d\n", dim, paradt_method_string(options.method),
                          (int)options.regions, (unsigned long)count, (unsigned long)places, (int)PLACES);
            // Cells that are infinite, and for some methods all that there were, also need numbers.
            assert_true(3 * places > PLACES);
        }
}

static void more_points_than_an_index_numbers_are_refused(void **state) {
    paradt_points points = uniform(MOST_POINTS + 1, 2);
    paradt_triangulation t;
    paradt_dynamic *set;
    (void)state;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_ERROR_TOO_LARGE);
    assert_non_null(strstr(t.error_text, "points.count"));
    assert_int_equal(paradt_dynamic_create(&set, &points, NULL), PARADT_ERROR_TOO_LARGE);
    assert_null(set);
}

static void a_hull_is_right_up_to_its_limit(void **state) {
    int dim;
    (void)state;
    for (dim = 3; dim <= MOST_DIM; dim++) {
        size_t low = (size_t)dim + 1, high = MOST_POINTS + 1, most = 0;
        while (high - low > 1) {
            size_t middle = low + (high - low) / 2;
            paradt_points points = spherical(middle, dim);
            paradt_hull hull;
            paradt_fault fault;
            paradt_status status = paradt_hull_compute(&hull, &points, NULL);
            if (status == PARADT_OK) {
                assert_int_equal(paradt_hull_check(&hull, &points, NULL, &fault), PARADT_OK);
                low = middle;
                most = hull.facet_count * (size_t)dim;
            } else {
                assert_int_equal(status, PARADT_ERROR_TOO_LARGE);
                high = middle;
            }
            paradt_hull_free(&hull);
        }
        print_message("hull, %dD: %lu points, %lu of %d\n", dim, (unsigned long)low, (unsigned long)most, (int)PLACES);
        assert_true(most <= PLACES && 3 * most > PLACES);
    }
}

// Certifies what a living set holds. All its points are there, with ids from 0 on.
static void expect_proved(const paradt_dynamic *set, const paradt_points *points) {
    paradt_triangulation t;
    paradt_fault fault;
    assert_int_equal(paradt_dynamic_export(set, &t), PARADT_OK);
    assert_int_equal(t.point_count, points->count);
    assert_int_equal(paradt_check(&t, points, NULL, &fault), PARADT_OK);
    paradt_free(&t);
}

static void a_living_set_at_its_limit_stays_what_it_was(void **state) {
    static const paradt_method methods[] = {PARADT_AUTO, PARADT_DELAUNAY_TREE, PARADT_FLIP};
    int dim, m;
    (void)state;
    for (dim = 2; dim <= 3; dim++)
        for (m = 0; m < 3; m++) {
            paradt_points all = uniform(MOST_POINTS + 1, dim), points = paradt_points_f64(coordinates, 50, dim);
            paradt_options options;
            paradt_dynamic *set;
            paradt_status status = PARADT_OK;
            paradt_index id;
            memset(&options, 0, sizeof options);
            options.method = methods[m];
            assert_int_equal(paradt_dynamic_create(&set, &points, &options), PARADT_OK);
            while (!status && points.count < all.count) {
                status = paradt_dynamic_insert(set, coordinates + points.count * (size_t)dim, 0, -1, &id);
                if (!status)
                    assert_int_equal(id, points.count++);
            }
            assert_int_equal(status, PARADT_ERROR_TOO_LARGE);
            print_message("living set, %dD, %s: %lu points\n", dim, paradt_method_string(methods[m]),
                          (unsigned long)points.count);
            assert_true(points.count > 150);
            expect_proved(set, &points);
            if (!m) { // points can leave, though not every one at once: the new cells come before the old ones go
                paradt_index left = 0, at;
                for (at = 0; at < (paradt_index)points.count && left < 20; at++) {
                    status = paradt_dynamic_remove(set, at);
                    assert_true(status == PARADT_OK || status == PARADT_ERROR_TOO_LARGE);
                    left = (paradt_index)(left + !status);
                }
                assert_int_equal(left, 20);
            }
            paradt_dynamic_free(set);
        }
}

// Locators, lists of cells and Voronoi diagrams of the largest triangulations
static void uses_of_the_largest_triangulation_are_right(void **state) {
    int dim;
    (void)state;
    for (dim = 2; dim <= 3; dim++) {
        size_t places, count = largest(dim, NULL, &places), i;
        paradt_points points = uniform(count, dim);
        paradt_triangulation t;
        paradt_locator *locator;
        paradt_adjacency cells;
        paradt_voronoi_request request;
        paradt_voronoi v;
        paradt_status status;
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
        for (i = 0; i < count; i++) {
            assert_int_equal(paradt_nearest_one(locator, coordinates + i * (size_t)dim, -1), i);
            assert_int_equal(__builtin_popcount(paradt_locate_one(locator, coordinates + i * (size_t)dim, -1).face), 1);
        }
        paradt_locator_free(locator);
        assert_int_equal(paradt_adjacency_compute(&cells, &t, PARADT_VERTEX_CELLS, NULL), PARADT_OK);
        assert_int_equal(cells.count, count);
        assert_int_equal(cells.first[count], places);
        paradt_adjacency_free(&cells);
        memset(&request, 0, sizeof request);
        request.outputs = PARADT_VORONOI_VOLUMES;
        status = paradt_voronoi_compute(&v, &t, &points, &request, NULL);
        assert_int_equal(status, PARADT_OK); // it has fewer faces than the triangulation has places
        for (i = 0; i < count; i++)
            assert_true(v.volumes[i] > 0 && (v.volumes[i] > 1e300) == v.unbounded[i]);
        paradt_voronoi_free(&v);
        paradt_free(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_method_is_right_up_to_its_limit),
        cmocka_unit_test(more_points_than_an_index_numbers_are_refused),
        cmocka_unit_test(a_hull_is_right_up_to_its_limit),
        cmocka_unit_test(a_living_set_at_its_limit_stays_what_it_was),
        cmocka_unit_test(uses_of_the_largest_triangulation_are_right),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
