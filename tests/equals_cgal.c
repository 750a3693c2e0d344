// CGAL perturbs by the same rule. On small sets CGAL is compared with the definition, on larger ones ParaDT with CGAL. The sets of
// cells must be equal, and with them the hidden points.
#include "harness.h"

#include "cgal.h"

enum { LARGEST_DIM = 6 };
static const int small[] = {0, 0, 14, 14, 11, 10, 9}, large[] = {0, 0, 1200, 1200, 100, 40, 24};

// For the plane and for space CGAL has special classes beside the general one.
typedef int (*cgal_call)(const sample *s, cell_set *cells);
static cgal_call cgal_for(int dim, int general) {
    return general || dim > 3 ? cgal_triangulate_d : dim == 2 ? cgal_triangulate_2 : cgal_triangulate_3;
}

// CGAL's exact stage takes minutes for weights and coordinates of all magnitudes in many dimensions.
static int takes_cgal_too_long(int f, int w, int dim) {
    return weightings[w].extremes && dim > (families[f].extremes ? 2 : 3);
}

// state: family
static void cgal_equals_the_definition(void **state) {
    int f = (int)(intptr_t)*state;
    for (int w = 0; w < WEIGHTING_COUNT; w++)
        for (int dim = 2; dim <= LARGEST_DIM; dim++)
            for (int general = 0; general < (dim > 3 ? 1 : 2); general++) {
                if (takes_cgal_too_long(f, w, dim) || (families[f].extremes && dim > 4))
                    continue;
                if (w && (f + w + dim) % 2) // weightings take turns
                    continue;
                sample s = family_make(&families[f], &weightings[w], dim, small[dim], (uint64_t)(7 + f));
                cell_set definition, cgal;
                int k = oracle_triangulate(&s, &definition, NULL);
                if (k != cgal_for(dim, general)(&s, &cgal))
                    fail_on_sample(&s, "CGAL finds another affine dimension");
                fail_if_different(&s, general ? "CGAL in any dimension" : "CGAL", &definition, &cgal);
                cells_free(&definition);
                cells_free(&cgal);
                sample_free(&s);
            }
}

static void expect_cgals_cells(const sample *s, int method, int general) {
    paradt_options options = {0};
    options.method = (paradt_method)method;
    options.regions = (size_t)(method == PARADT_AUTO ? 3 : 1);
    paradt_triangulation t = triangulate_and_verify(s, &options, how_text(&options));
    cell_set found = cells_of(&t, NULL), expected;
    watch(s, 300);
    if (t.dim != cgal_for(s->dim, general)(s, &expected))
        fail_on_sample(s, "CGAL finds another affine dimension");
    watch(NULL, 0);
    fail_if_different(s, "compared with CGAL", &expected, &found);
    cells_free(&expected);
    cells_free(&found);
    paradt_free(&t);
}

// state: family
static void cells_equal_cgals(void **state) {
    int f = (int)(intptr_t)*state;
    for (int w = 0; w < WEIGHTING_COUNT; w++)
        for (int dim = 2; dim <= LARGEST_DIM; dim++) {
            int count = large[dim];
            if (takes_cgal_too_long(f, w, dim))
                continue;
            if (families[f].extremes || weightings[w].extremes)
                count = dim <= 3 ? 60 : dim + 10;
            else if (w > 0) // only unweighted sets have their full size
                count /= 2;
            sample s = family_make(&families[f], &weightings[w], dim, count, (uint64_t)(11 + f + w));
            expect_cgals_cells(&s, (f + w + dim) % PARADT_METHOD_COUNT, dim == 2 && w % 2);
            sample_free(&s);
        }
}

static void large_sets_equal_cgals(void **state) {
    static const char *const chosen[] = {"uniform", "sphere",       "clusters",    "lattice",
                                         "fcc",     "cube surface", "rough sphere"};
    (void)state;
    for (size_t i = 0; i < sizeof chosen / sizeof chosen[0]; i++)
        for (int w = 0; w < 2; w++) {
            int f = family_named(chosen[i]);
            sample s = family_make(&families[f], &weightings[w], 3, 8000, 5);
            expect_cgals_cells(&s, (int)(i + (size_t)w) % PARADT_METHOD_COUNT, 0);
            if (w == 0) expect_cgals_cells(&s, PARADT_BOWYER_WATSON, 0);
            sample_free(&s);
        }
}

// The extreme points of hulls
static void extreme_points_equal_cgals(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int f = 0; f < FAMILY_COUNT; f++)
            for (int n = 30; n <= 3000; n *= 100) {
                if (families[f].extremes)
                    continue;
                sample s = family_make(&families[f], NULL, dim, n, 4);
                paradt_points points = points_of(&s);
                paradt_hull hull;
                watch(&s, 60);
                assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_OK);
                if (hull.dim == dim) {
                    char *extreme = (char *)calloc((size_t)s.count, 1);
                    size_t count = 0;
                    cgal_extreme(&s, extreme);
                    for (int i = 0; i < s.count; i++)
                        count += (size_t)extreme[i];
                    for (size_t i = 0; i < hull.extreme_count; i++)
                        if (!extreme[hull.vertices[i]])
                            fail_on_sample(&s, "a point is extreme that is none for CGAL");
                    if (count != hull.extreme_count)
                        fail_on_sample(&s, "the number of extreme points is not CGAL's");
                    free(extreme);
                }
                watch(NULL, 0);
                paradt_hull_free(&hull);
                sample_free(&s);
                if (families[f].at_most)
                    break;
            }
}

int main(void) {
    static struct CMUnitTest tests[2 * FAMILY_COUNT + 2];
    size_t count = 0;
    for (int f = 0; f < FAMILY_COUNT; f++)
        tests[count++] = named_test(cgal_equals_the_definition, (void *)(intptr_t)f, "cgal_equals_the_definition_on_%s",
                                    families[f].name);
    for (int f = 0; f < FAMILY_COUNT; f++)
        tests[count++] = named_test(cells_equal_cgals, (void *)(intptr_t)f, "cells_equal_cgals_on_%s", families[f].name);
    tests[count++] = named_test(large_sets_equal_cgals, NULL, "large_sets_equal_cgals");
    tests[count++] = named_test(extreme_points_equal_cgals, NULL, "extreme_points_equal_cgals");
    return run_named_tests("equals_cgal", tests, count);
}
