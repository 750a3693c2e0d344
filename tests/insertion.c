// Insertion in three dimensions: stars of all sizes, and the numbers that their vertices have.
#define PARADT_STATIC // what is not called is not compiled
#define PARADT_IMPLEMENTATION
#include "harness.h"

enum { POINTS = 4000, MOST_POINTS = 30001 };

typedef struct building {
    paradt__memory memory;
    paradt__set set;
    paradt__bw bw;
    paradt_index *order, *representative;
} building;

static int stops(void *user, double fraction) {
    (void)user;
    return fraction > 0;
}

// Points in the order in which they are given; all of them, or as many as come before the first report.
static void begin(building *b, const double *x, size_t points, int all) {
    paradt_points given = {x, points, 3, 0, PARADT_F64, NULL};
    paradt__progress progress = {all ? NULL : stops, NULL, 0, 1};
    size_t bad;
    memset(b, 0, sizeof *b);
    paradt__memory_begin(&b->memory, NULL);
    b->order = malloc(points * sizeof *b->order);
    b->representative = malloc(points * sizeof *b->representative);
    assert_int_equal(paradt__set_load(&b->set, &given, NULL, &paradt__alone, &b->memory, b->representative, &bad),
                     PARADT_OK);
    assert_int_equal(b->set.count, points);
    // the set is along a curve, set.origin says whose point each is
    for (size_t i = 0; i < points; i++) b->order[b->set.origin[i]] = (paradt_index)i;
    paradt__bw_begin(&b->bw, &b->set, b->order, &b->memory);
    assert_int_equal(paradt__bw_build(&b->bw, &progress), all ? PARADT_OK : PARADT_ERROR_CANCELLED);
}

static void end(building *b) {
    paradt__bw_end(&b->bw);
    paradt__cells_free(&b->bw.cells, &b->memory);
    paradt__set_free(&b->set, &b->memory);
    free(b->order);
    free(b->representative);
}

static double random_coordinate(uint64_t i) {
    return (double)(paradt__mix(i) >> 11) * 0x1p-53;
}

// Numbers that are about to reach their end begin again: all becomes as without that.
static void numbers_of_vertices_begin_again(void **state) {
    static double x[3 * POINTS];
    building plain, again;
    paradt__progress silent = {NULL, NULL, 0, 1};
    uint32_t before;
    (void)state;
    for (size_t i = 0; i < 3 * POINTS; i++) x[i] = random_coordinate(i);
    begin(&plain, x, POINTS, 1);
    begin(&again, x, POINTS, 0);
    assert_in_range(again.bw.inserted, 1000, POINTS - 1000);
    before = again.bw.spheres->next_number;
    again.bw.spheres->next_number = PARADT__LAST_NUMBER - 40000;
    assert_int_equal(paradt__bw_insert_rest(&again.bw, &silent), PARADT_OK);
    assert_true(again.bw.spheres->next_number > before);
    assert_true(again.bw.spheres->next_number < PARADT__LAST_NUMBER - 40000); // some 70 insertions took it there
    assert_int_equal(again.bw.cells.count, plain.bw.cells.count);
    assert_memory_equal(again.bw.cells.vertices, plain.bw.cells.vertices,
                        plain.bw.cells.count * 4 * sizeof(paradt_index));
    assert_memory_equal(again.bw.cells.neighbors, plain.bw.cells.neighbors,
                        plain.bw.cells.count * 4 * sizeof(paradt_index));
    end(&plain);
    end(&again);
}

// A point on a sphere, rounded
static void on_sphere(double *p, uint64_t i) {
    double length = 0;
    for (; length < 0.01 || length > 1; i += 1000000007) {
        length = 0;
        for (size_t j = 0; j < 3; j++) {
            p[j] = 2 * random_coordinate(3 * i + j + 7) - 1;
            length += p[j] * p[j];
        }
    }
    for (size_t j = 0; j < 3; j++) p[j] /= sqrt(length);
}

// Cells that share a facet must say so of each other, and have its vertices.
static void check_links(const paradt__bw *bw) {
    for (size_t c = 0; c < bw->cells.count; c++) {
        const paradt_index *vertices = bw->cells.vertices + 4 * c;
        if (vertices[0] == PARADT__DEAD) continue;
        for (size_t i = 0; i < 4; i++) {
            paradt_index across = bw->cells.neighbors[4 * c + i];
            const paradt_index *other = bw->cells.vertices + (across & ~3);
            int shared = 0;
            assert_int_equal(bw->cells.neighbors[across], 4 * c + i);
            for (int j = 0; j < 4; j++) {
                for (size_t k = 0; k < 4 && j != (across & 3); k++) shared += k != i && vertices[k] == other[j];
            }
            assert_int_equal(shared, 3);
        }
    }
}

// After the middle of a sphere, with a cell for each of 49,996 facets, come others, whose stars have some of its
// vertices.
static void stars_after_a_very_large_one_are_whole(void **state) {
    static double x[3 * MOST_POINTS];
    (void)state;
    for (size_t i = 0; i < MOST_POINTS; i++) {
        on_sphere(x + 3 * i, i);
        if (i >= 25000)
            for (size_t j = 0; j < 3; j++) x[3 * i + j] *= 0.99 * random_coordinate(i);
    }
    memset(x + 3 * 25000, 0, 3 * sizeof *x);
    building b;
    begin(&b, x, MOST_POINTS, 1);
    paradt__bw_mark_free(&b.bw);
    check_links(&b.bw);
    end(&b);
}

// The middle of a rounded sphere comes last: it drives out all cells there are and shares one with each hull facet.
static void the_middle_of_a_sphere_has_a_cell_for_each_facet(void **state) {
    static const size_t sizes[] = {20, 31, 33, 100, 129, 131, 500, 1025, 1027, 3000, 30000};
    static double x[3 * MOST_POINTS];
    (void)state;
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        size_t n = sizes[k];
        for (size_t i = 0; i < n; i++) on_sphere(x + 3 * i, i);
        memset(x + 3 * n, 0, 3 * sizeof *x);
        building b;
        begin(&b, x, n + 1, 1);
        paradt__bw_mark_free(&b.bw);
        check_links(&b.bw);
        size_t facets = 2 * n - 4, cells = 0, ghosts = 0;
        paradt_index middle = b.order[n];
        for (size_t c = 0; c < b.bw.cells.count; c++) {
            const paradt_index *vertices = b.bw.cells.vertices + 4 * c;
            if (vertices[0] == PARADT__DEAD) continue;
            int is_ghost = paradt__bw_ghost(vertices, 4) >= 0, has = 0;
            for (int i = 0; i < 4; i++) has += vertices[i] == middle;
            cells += (size_t)!is_ghost;
            ghosts += (size_t)is_ghost;
            assert_int_equal(has, !is_ghost);
        }
        assert_int_equal(cells, facets);
        assert_int_equal(ghosts, facets);
        end(&b);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_vertices_begin_again),
        cmocka_unit_test(stars_after_a_very_large_one_are_whole),
        cmocka_unit_test(the_middle_of_a_sphere_has_a_cell_for_each_facet),
    };
    return cmocka_run_group_tests_name("insertion", tests, NULL, NULL);
}
