// Insertion: stars of all sizes; in two and three dimensions also the numbers of their vertices, and the errors of powers.
// Living sets: where searches start.
#define PARADT_STATIC // functions that are not called are not compiled
#define PARADT_IMPLEMENTATION
#include "harness.h"

#include <gmp.h>

enum { POINTS = 4000, MOST_POINTS = 30001 };

typedef struct building {
    paradt__memory memory;
    paradt__set set;
    paradt__insertion build;
    paradt_index *order, *representative;
} building;

static int stops(void *user, double fraction) {
    (void)user;
    return fraction > 0;
}

// Inserts points in the given order: all of them, or those before the first report of progress. weights: may be NULL
static void begin_any(building *b, int dim, const double *x, const double *weights, size_t points, int all) {
    paradt_points given = paradt_points_f64(x, points, dim);
    paradt_options options = {0};
    paradt__meter meter;
    uint32_t told = 0;
    paradt__progress progress;
    size_t bad;
    given.weights = weights;
    options.progress = all ? NULL : stops;
    paradt__meter_begin(&meter, &options);
    progress = paradt__progress_of(&meter, &told, 1.0);
    memset(b, 0, sizeof *b);
    paradt__memory_begin(&b->memory, NULL);
    b->order = malloc(points * sizeof *b->order);
    b->representative = malloc(points * sizeof *b->representative);
    assert_int_equal(paradt__set_load(&b->set, &given, NULL, &paradt__alone, &b->memory, b->representative, &bad),
                     PARADT_OK);
    assert_int_equal(b->set.count, points);
    assert_int_equal(paradt__set_grade(&b->set, PARADT__NEAR_SPHERE, NULL, &b->memory), PARADT_OK);
    // The set is sorted along a curve; set.origin[i] is the caller's index of point i.
    for (size_t i = 0; i < points; i++) b->order[b->set.origin[i]] = (paradt_index)i;
    paradt__insertion_begin(&b->build, &b->set, b->order, &b->memory);
    assert_int_equal(paradt__insertion_run(&b->build, &progress), all ? PARADT_OK : PARADT_ERROR_CANCELLED);
}

static void begin(building *b, const double *x, size_t points, int all) {
    begin_any(b, 3, x, NULL, points, all);
}

static void end(building *b) {
    paradt__insertion_end(&b->build);
    paradt__set_free(&b->set, &b->memory);
    free(b->order);
    free(b->representative);
}

static double random_coordinate(uint64_t i) {
    return (double)(paradt__mix(i) >> 11) * 0x1p-53;
}

// Numbers that approach their limit begin again from the start. The result is the same as without that.
static void numbers_of_vertices_begin_again(void **state) {
    static double x[3 * POINTS];
    building plain, again;
    paradt__progress silent = {NULL, NULL, 0};
    uint32_t before;
    (void)state;
    for (size_t i = 0; i < 3 * POINTS; i++) x[i] = random_coordinate(i);
    begin(&plain, x, POINTS, 1);
    begin(&again, x, POINTS, 0);
    assert_in_range(again.build.inserted, 1000, POINTS - 1000);
    before = again.build.kept->next_number;
    again.build.kept->next_number = PARADT__LAST_NUMBER - 40000;
    assert_int_equal(paradt__insertion_go(&again.build, &silent), PARADT_OK);
    assert_true(again.build.kept->next_number > before);
    assert_true(again.build.kept->next_number < PARADT__LAST_NUMBER - 40000); // they began again after some 70 insertions
    assert_int_equal(again.build.scene.mesh.count, plain.build.scene.mesh.count);
    assert_memory_equal(again.build.scene.mesh.vertices, plain.build.scene.mesh.vertices,
                        plain.build.scene.mesh.count * 4 * sizeof(paradt_index));
    assert_memory_equal(again.build.scene.mesh.links, plain.build.scene.mesh.links,
                        plain.build.scene.mesh.count * 4 * sizeof(paradt_index));
    end(&plain);
    end(&again);
}

// Makes a point on the unit sphere, up to rounding.
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

// Cells that share a facet must link to each other and share the facet's vertices.
static void check_links(const paradt__insertion *build) {
    size_t corners = (size_t)build->scene.mesh.corners;
    for (size_t c = 0; c < build->scene.mesh.count; c++) {
        const paradt_index *vertices = build->scene.mesh.vertices + corners * c;
        if (vertices[0] == PARADT__DEAD) continue;
        for (size_t i = 0; i < corners; i++) {
            size_t across = (size_t)build->scene.mesh.links[corners * c + i], opposite = across % corners, shared = 0;
            const paradt_index *other = build->scene.mesh.vertices + (across - opposite);
            assert_int_equal(build->scene.mesh.links[across], corners * c + i);
            for (size_t j = 0; j < corners; j++) {
                for (size_t k = 0; k < corners && j != opposite; k++) shared += k != i && vertices[k] == other[j];
            }
            assert_int_equal(shared, corners - 1);
        }
    }
}

// The middle of a sphere makes a cell for each of 49,996 facets. The stars of later points share some of its vertices.
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
    check_links(&b.build);
    end(&b);
}

// The middle of a rounded sphere comes last: it replaces all cells by one cell for each hull facet.
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
        check_links(&b.build);
        size_t facets = 2 * n - 4, cells = 0, ghosts = 0;
        paradt_index middle = b.order[n];
        for (size_t c = 0; c < b.build.scene.mesh.count; c++) {
            const paradt_index *vertices = b.build.scene.mesh.vertices + 4 * c;
            if (vertices[0] == PARADT__DEAD) continue;
            int is_ghost = paradt__ghost_place(vertices, 4) >= 0, has = 0;
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

// Points that hide all others within their reach have small stars, whose cavities have many vertices inside.
static void heavy_points_hide_those_around_them(void **state) {
    static const size_t sizes[] = {40, 130, 600, 1500, 4000, 30000};
    static double x[3 * MOST_POINTS], weights[MOST_POINTS];
    (void)state;
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        size_t n = sizes[k], hidden = 0;
        for (size_t i = 0; i < 3 * n + 3; i++) x[i] = random_coordinate(i);
        for (size_t i = 0; i <= n; i++) weights[i] = 0;
        for (size_t j = 0; j < 3; j++) x[3 * n + j] = 0.5;
        weights[n] = 0.3;
        for (size_t i = n / 2; i < n; i += n / 10 + 1) weights[i] = 0.01;
        building b;
        begin_any(&b, 3, x, weights, n + 1, 1);
        check_links(&b.build);
        unsigned char *seen = calloc(n + 1, 1);
        for (size_t c = 0; c < b.build.scene.mesh.count; c++) {
            const paradt_index *vertices = b.build.scene.mesh.vertices + 4 * c;
            for (int i = 0; i < 4 && vertices[0] != PARADT__DEAD; i++)
                if (vertices[i] >= 0) seen[vertices[i]] = 1;
        }
        assert_true(seen[b.order[n]]);
        for (size_t i = 0; i < n; i++) {
            double distance2 = 0;
            for (size_t j = 0; j < 3; j++) distance2 += (x[3 * i + j] - 0.5) * (x[3 * i + j] - 0.5);
            hidden += !seen[b.order[i]];
            if (weights[i] == 0 && distance2 < 0.04) assert_false(seen[b.order[i]]);
        }
        assert_in_range(hidden, n / 10, n);
        free(seen);
        end(&b);
    }
}

// --- errors

typedef struct exact_vector {
    mpq_t at[3], square;
} exact_vector;

// Sets v to `to` - `from`, in the plane with 0 for the third coordinate.
static void exact_begin(exact_vector *v, const double *from, const double *to, int dim) {
    mpq_t x;
    mpq_init(x);
    mpq_init(v->square);
    for (int j = 0; j < 3; j++) {
        mpq_init(v->at[j]);
        if (j >= dim) continue;
        mpq_set_d(v->at[j], to[j]);
        mpq_set_d(x, from[j]);
        mpq_sub(v->at[j], v->at[j], x);
        mpq_mul(x, v->at[j], v->at[j]);
        mpq_add(v->square, v->square, x);
    }
    mpq_clear(x);
}

static void exact_end(exact_vector *v) {
    mpq_clear(v->square);
    for (int j = 0; j < 3; j++) mpq_clear(v->at[j]);
}

// sum += factor * det(a, b, c)
static void exact_add_determinant(mpq_t sum, const mpq_t factor, const exact_vector *a, const exact_vector *b,
                                  const exact_vector *c) {
    mpq_t x, y;
    mpq_init(x);
    mpq_init(y);
    for (int j = 0; j < 3; j++) {
        int k = (j + 1) % 3, l = (j + 2) % 3;
        mpq_mul(x, b->at[k], c->at[l]);
        mpq_mul(y, b->at[l], c->at[k]);
        mpq_sub(x, x, y);
        mpq_mul(x, x, a->at[j]);
        mpq_mul(x, x, factor);
        mpq_add(sum, sum, x);
    }
    mpq_clear(x);
    mpq_clear(y);
}

// Subtracts the difference of two points' weights.
static void exact_weigh(exact_vector *v, const double *from, const double *to, int dim) {
    mpq_t w;
    mpq_init(w);
    mpq_set_d(w, to[dim]);
    mpq_sub(v->square, v->square, w);
    mpq_set_d(w, from[dim]);
    mpq_add(v->square, v->square, w);
    mpq_clear(w);
}

// Returns the error of `power`: its distance from the exact power of x with regard to the sphere through the points v. In the
// plane the third edge is a unit vector across it, with the square 0: then the formulas are those of the plane.
static double error_of_power(double power, const double *const *v, const double *x, const paradt__space *space) {
    int dim = space->dim;
    const double *p = v[dim];
    exact_vector a, b, c, f;
    mpq_t one, det, sum, said;
    exact_begin(&a, p, v[0], dim);
    exact_begin(&b, p, v[1], dim);
    exact_begin(&c, p, dim == 3 ? v[2] : p, dim);
    exact_begin(&f, p, x, dim);
    if (dim == 2) mpq_set_ui(c.at[2], 1, 1);
    if (space->weighted) {
        exact_weigh(&a, p, v[0], dim);
        exact_weigh(&b, p, v[1], dim);
        if (dim == 3) exact_weigh(&c, p, v[2], dim);
        exact_weigh(&f, p, x, dim);
    }
    mpq_inits(one, det, sum, said, NULL);
    mpq_set_ui(one, 1, 1);
    exact_add_determinant(det, one, &a, &b, &c);
    // |f|^2 - w . f, w = (|a|^2 b x c + |b|^2 c x a + |c|^2 a x b) / det
    exact_add_determinant(sum, a.square, &f, &b, &c);
    exact_add_determinant(sum, b.square, &f, &c, &a);
    exact_add_determinant(sum, c.square, &f, &a, &b);
    mpq_div(sum, sum, det);
    mpq_sub(sum, f.square, sum);
    mpq_set_d(said, power);
    mpq_sub(sum, said, sum);
    double error = fabs(mpq_get_d(sum));
    mpq_clears(one, det, sum, said, NULL);
    exact_end(&a);
    exact_end(&b);
    exact_end(&c);
    exact_end(&f);
    return error;
}

// Computed powers are within their error bounds, and few of the bounds are too large to tell a power's sign.
static void check_powers(const building *b) {
    enum { OTHERS = 4 };
    size_t asked = 0, vague = 0, corners = (size_t)b->build.scene.mesh.corners;
    for (size_t at = 0; at < b->build.scene.mesh.count; at += corners == 4 ? 23 : 7) {
        const paradt_index *vertices = b->build.scene.mesh.vertices + corners * at;
        const double *v[4];
        if (vertices[0] == PARADT__DEAD || paradt__ghost_place(vertices, (int)corners) >= 0) continue;
        for (size_t i = 0; i < corners; i++) v[i] = paradt__scene_record(&b->build.scene, vertices[i]);
        for (size_t k = 0; k < corners + OTHERS; k++) { // the apexes of the neighbours, and some other points
            int is_vertex = 0;
            paradt_index other = (paradt_index)(paradt__mix(at + k) % b->set.count);
            if (k < corners) other = b->build.scene.mesh.vertices[b->build.scene.mesh.links[corners * at + k]];
            if (other < 0) continue;
            const double *x = paradt__scene_record(&b->build.scene, other);
            paradt__centred seen = paradt__centred_of(b->build.kept, x);
            const paradt__sphere *sphere = paradt__kept_sphere(&b->build, (paradt_index)at);
            int nearby = paradt__kept_is_near(b->build.kept, (int)corners);
            double power = paradt__kept_power(sphere, &seen, (int)corners, nearby);
            double error = paradt__kept_error(sphere, &seen, nearby);
            assert_true(error_of_power(power, v, x, &b->build.scene.space) <= error);
            asked++;
            for (size_t i = 0; i < corners; i++) is_vertex |= other == vertices[i];
            vague += !is_vertex && !(fabs(power) > error);
        }
    }
    assert_true(asked > 500);
    assert_in_range(vague, 0, asked / 50);
}

static void powers_are_as_exact_as_they_say(void **state) {
    static double x[3 * POINTS];
    building b;
    (void)state;
    for (int sharp = 0; sharp < 2; sharp++) {
        for (size_t i = 0; i < 3 * POINTS; i++) x[i] = random_coordinate(i) * (sharp && i % 3 == 2 ? 0x1p-10 : 1);
        begin(&b, x, POINTS, 1);
        assert_int_equal(b.build.kept->making, PARADT__MAKE_QUICKLY);
        if (sharp) {
            b.build.kept->making = PARADT__MAKE_SHARP;
            for (size_t i = 0; i <= b.build.kept->mask; i++) b.build.kept->table[i].tag = PARADT__NO_SPHERE;
        }
        check_powers(&b);
        end(&b);
    }
}

// In the plane, where bounds are always sharp
static void powers_in_the_plane_are_as_exact_as_they_say(void **state) {
    static double x[2 * POINTS];
    building b;
    (void)state;
    for (int thin = 0; thin < 2; thin++) {
        for (size_t i = 0; i < 2 * POINTS; i++) x[i] = random_coordinate(i) * (thin && i % 2 ? 0x1p-10 : 1);
        begin_any(&b, 2, x, NULL, POINTS, 1);
        assert_int_equal(b.build.kept->making, PARADT__MAKE_SHARP);
        check_links(&b.build);
        check_powers(&b);
        end(&b);
    }
}

// With weights of all sizes, positive and negative
static void powers_with_weights_are_as_exact_as_they_say(void **state) {
    static const double sizes[] = {1e-300, 1e-9, 0.002, 1.0, 1e9};
    static double x[3 * POINTS], weights[POINTS];
    building b;
    (void)state;
    for (size_t k = 0; k < 2 * sizeof sizes / sizeof *sizes; k++) {
        size_t d = k % 2 ? 2 : 3;
        double size = sizes[k / 2];
        // large weights are such that all lifted points are in convex position
        for (size_t i = 0; i < d * POINTS; i++) x[i] = random_coordinate(i);
        for (size_t i = 0; i < POINTS; i++) {
            double square = 0;
            for (size_t j = 0; j < d; j++) square += (x[d * i + j] - 0.3) * (x[d * i + j] - 0.3);
            weights[i] = size * (size < 1 ? random_coordinate(i + 77) - 0.5 : -square);
        }
        begin_any(&b, (int)d, x, weights, POINTS, 1);
        if (size > 1e-200) { // else they are out of the filters' range
            assert_int_equal(b.build.kept->making, PARADT__MAKE_WEIGHTED);
            check_powers(&b);
        } else {
            assert_null(b.build.kept);
        }
        end(&b);
    }
}

// Near a sphere of any place and size, with or without noise, powers decide what the in-sphere filter can't.
static void powers_by_sagittas_tell_more(void **state) {
    static const struct {
        double centre[3], radius, noise;
    } cases[] = {{{0, 0, 0}, 1, 0},           {{0, 0, 0}, 1, 1e-13},       {{0, 0, 0}, 3, 1e-9},
                 {{3.3, -2.1, 0.7}, 1, 0},    {{3.3, -2.1, 0.7}, 1, 1e-9}, {{100, 0, 7}, 1, 0},
                 {{0, 0, 1e-31}, 1e-30, 0},   {{1e30, 0, 0}, 1e30, 1e-12}};
    static double x[3 * POINTS];
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        for (size_t i = 0; i < POINTS; i++) {
            double *p = x + 3 * i, factor = cases[k].radius * (1 + cases[k].noise * random_coordinate(i));
            on_sphere(p, i);
            for (size_t j = 0; j < 3; j++) p[j] = cases[k].centre[j] + factor * p[j];
        }
        building b;
        begin(&b, x, POINTS, 1);
        assert_int_equal(b.build.kept->making, PARADT__MAKE_GRADED);
        assert_in_range(b.build.scene.space.counters.insphere_calls, 0, POINTS / 20);
        check_powers(&b);
        end(&b);
    }
}

// Near a circle of any place and size
static void powers_by_sagittas_tell_more_in_the_plane(void **state) {
    static const double cases[][4] = {{0, 0, 1, 0}, {0, 0, 1, 1e-13}, {3.3, -2.1, 3, 1e-9}, {100, 7, 1, 0}, {1e30, 0, 1e30, 0}};
    static double x[2 * POINTS];
    (void)state;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        for (size_t i = 0; i < POINTS; i++) {
            double angle = 6.283185307 * random_coordinate(i);
            double radius = cases[k][2] * (1 + cases[k][3] * random_coordinate(i + POINTS));
            x[2 * i] = cases[k][0] + radius * cos(angle);
            x[2 * i + 1] = cases[k][1] + radius * sin(angle);
        }
        building b;
        begin_any(&b, 2, x, NULL, POINTS, 1);
        assert_int_equal(b.build.kept->making, PARADT__MAKE_GRADED);
        check_links(&b.build);
        check_powers(&b);
        end(&b);
    }
}

// Stars and cavities of all sizes in the plane: around the middle of a circle, and then inside that star.
static void large_stars_in_the_plane_are_whole(void **state) {
    static const size_t sizes[] = {10, 59, 61, 62, 63, 65, 300, 2047, 2048, 2049, 5000};
    static double x[2 * MOST_POINTS];
    (void)state;
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        size_t n = sizes[k], points = n + 1 + n / 2, at_middle = 0;
        for (size_t i = 0; i < n; i++) {
            double angle = 6.283185307 * ((double)i + 0.3 * random_coordinate(i)) / (double)n;
            x[2 * i] = cos(angle);
            x[2 * i + 1] = sin(angle);
        }
        for (size_t i = n; i < points; i++) {
            x[2 * i] = i > n ? random_coordinate(2 * i) - 0.5 : 0;
            x[2 * i + 1] = i > n ? random_coordinate(2 * i + 1) - 0.5 : 0;
        }
        building b;
        begin_any(&b, 2, x, NULL, n + 1, 1);
        check_links(&b.build);
        for (size_t c = 0; c < b.build.scene.mesh.count; c++) {
            const paradt_index *vertices = b.build.scene.mesh.vertices + 3 * c;
            for (int i = 0; i < 3 && vertices[0] != PARADT__DEAD; i++) at_middle += vertices[i] == b.order[n];
        }
        assert_in_range(at_middle, n - n / 8, n); // rounded points may be inside of the hull
        end(&b);
        begin_any(&b, 2, x, NULL, points, 1);
        check_links(&b.build);
        end(&b);
    }
}

// Points near a plane, far from the origin or not, are not taken for points near a large sphere.
static void near_a_plane_there_are_no_sagittas(void **state) {
    static double x[3 * POINTS];
    (void)state;
    for (int far = 0; far < 2; far++) {
        for (size_t i = 0; i < 3 * POINTS; i++)
            x[i] = random_coordinate(i) * (i % 3 == 2 ? 0x1p-20 : 1) + (far ? 5.0 + (double)(i % 3) : 0.0);
        building b;
        begin(&b, x, POINTS, 1);
        assert_int_equal(b.set.grade, PARADT__UNGRADED);
        end(&b);
    }
}

// A ghost's function decides as the side of its hull facet does, and leaves points in the facet's plane to the predicates.
static void check_ghosts(const building *b) {
    size_t corners = (size_t)b->build.scene.mesh.corners, sides[3] = {0, 0, 0};
    paradt__scene scene = b->build.scene;
    for (size_t at = 0; at < b->build.scene.mesh.count; at++) {
        const paradt_index *vertices = b->build.scene.mesh.vertices + corners * at;
        int ghost = vertices[0] == PARADT__DEAD ? -1 : paradt__ghost_place(vertices, (int)corners);
        for (size_t i = 0; i < b->set.count && ghost >= 0; i++) {
            const double *x = paradt__record(&b->set, (paradt_index)i);
            paradt__centred seen = paradt__centred_of(b->build.kept, x);
            const paradt__sphere *sphere = paradt__kept_sphere(&b->build, (paradt_index)at);
            double power = paradt__sphere_power(sphere, &seen);
            int side = paradt__side(&scene, (paradt_index)at, ghost, x);
            sides[1 + side]++;
            if (!(fabs(power) > sphere->error)) continue;
            assert_true(side != 0);
            assert_int_equal(power < 0, side > 0);
        }
    }
    assert_true(sides[0] && sides[1] && !sides[2]); // the hull is complete
}

// Points exactly in a plane, and one that is off it by as little as rounding errors, or much less.
static void ghosts_leave_points_in_their_planes_to_the_predicates(void **state) {
    enum { COPLANAR = 400 };
    static double x[3 * COPLANAR];
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int e = 14; e <= 100; e += 43) {
            size_t d = (size_t)dim;
            for (size_t i = 0; i < COPLANAR * d; i++) x[i] = i % d == d - 1 ? 0 : random_coordinate(i + 77);
            x[COPLANAR / 3 * d + d - 1] = ldexp(1, -e);
            building b;
            begin_any(&b, dim, x, NULL, COPLANAR, 1);
            check_links(&b.build);
            check_ghosts(&b);
            end(&b);
        }
}

// The in-sphere determinant of five integer points relative to the last, with weights in units of 2^-20. *volume: what it changes
// by with a unit of the last weight
static int64_t integer_insphere(int (*p)[3], const int64_t *weight, int64_t *volume) {
    int64_t d[4][4], pair[4][4], det = 0;
    for (int i = 0; i < 4; i++) {
        d[i][3] = weight[4] - weight[i];
        for (int j = 0; j < 3; j++) d[i][j] = p[i][j] - p[4][j], d[i][3] += d[i][j] * d[i][j] * 1048576;
    }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) pair[i][j] = d[i][0] * d[j][1] - d[j][0] * d[i][1];
    *volume = 0;
    for (int i = 0, sign = 1; i < 4; i++, sign = -sign) {
        int a = i == 0, b = 1 + (i <= 1), c = 2 + (i <= 2);
        int64_t minor = d[a][2] * pair[b][c] - d[b][2] * pair[a][c] + d[c][2] * pair[a][b];
        *volume += sign * minor;
        det += sign * minor * d[i][3];
    }
    return det;
}

// Five integer points of which the last has just the weight that makes its power next to nothing. A sixth is so light that powers
// are not exact, and then one may be taken for zero that is not.
static void powers_near_zero_are_told_from_zero(void **state) {
    enum { SETS = 400 };
    (void)state;
    for (uint64_t draw = 0, found = 0; found < SETS; draw++) {
        int p[6][3];
        int64_t weight[6], volume, det;
        double x[18], w[6];
        for (int i = 0; i < 18; i++) p[i / 3][i % 3] = (int)(paradt__mix(18 * draw + (uint64_t)i) % 9);
        for (int i = 0; i < 6; i++) weight[i] = (int64_t)(paradt__mix(draw + 1000000 * (uint64_t)i) % 1048576);
        for (int j = 0; j < 3; j++) p[5][j] = 8 * (int)(draw >> j & 1);
        weight[4] = 0;
        weight[5] = -((int64_t)524287 << 20);
        det = integer_insphere(p, weight, &volume);
        if (volume < 200 && volume > -200) continue;
        weight[4] = -(det / volume);
        det = integer_insphere(p, weight, &volume);
        if (!det || det < -5 || det > 5) continue;
        for (int i = 0; i < 18; i++) x[i] = p[i / 3][i % 3];
        for (int i = 0; i < 6; i++) w[i] = (double)weight[i] * 0x1p-20;
        paradt_points points = paradt_points_f64(x, 6, 3);
        paradt_options options = {0};
        paradt_triangulation inserted, searched;
        points.weights = w;
        options.method = PARADT_BOWYER_WATSON;
        assert_int_equal(paradt_triangulate(&inserted, &points, &options), PARADT_OK);
        options.method = PARADT_INCODE;
        assert_int_equal(paradt_triangulate(&searched, &points, &options), PARADT_OK);
        assert_true(paradt_hash(&inserted) == paradt_hash(&searched));
        paradt_free(&inserted);
        paradt_free(&searched);
        found++;
    }
}

// Does each bucket name a vertex in it, or a bucket that does, at some hops?
static void check_starts(const paradt_dynamic *d) {
    const paradt__starts *starts = &d->starts;
    assert_true(starts->bucket_count > 100);
    for (size_t i = 0; i < starts->bucket_count; i++) {
        size_t bucket = i, hops = 0;
        if (paradt__starts_is_grid(starts, starts->buckets[i])) continue;
        while (starts->buckets[bucket] < 0) {
            bucket = (size_t)(PARADT__START_GRID - starts->buckets[bucket]) - starts->grid_count;
            assert_true(bucket < starts->bucket_count && ++hops < starts->bucket_count);
        }
        paradt_index vertex = starts->buckets[bucket];
        assert_true((size_t)vertex < d->now.positions && d->column[PARADT__OWNER][vertex] >= 0);
        assert_true(paradt__starts_bucket_of(starts, paradt__living_record(d, vertex)) == bucket);
    }
}

// However many come and go. The first sample is in clusters, so that there are grids in buckets, and empty buckets.
static void searches_start_at_vertices_that_are_there(void **state) {
    enum { COUNT = 2000, OPERATIONS = 12000 };
    static double x[3 * COUNT], weights[COUNT];
    static paradt_index ids[COUNT];
    uint64_t seed = 5;
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int weighted = 0; weighted < 2; weighted++) {
            paradt_points points = paradt_points_f64(x, COUNT, (size_t)dim);
            paradt_dynamic *d;
            for (int i = 0; i < COUNT; i++) {
                weights[i] = 0.001 * random_unit(&seed);
                for (int j = 0; j < dim; j++) x[i * dim + j] = i % 7 * 0.125 + (i % 3 ? 0.001 : 0.25) * random_unit(&seed);
                ids[i] = i;
            }
            points.weights = weighted ? weights : NULL;
            assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
            for (int k = 0; k < OPERATIONS; k++) {
                int i = random_below(&seed, COUNT), all = k < OPERATIONS / 2;
                double to[3];
                for (int j = 0; j < dim; j++)
                    to[j] = all ? 1.5 * random_unit(&seed) - 0.25 : x[i * dim + j] + 0.0001 * random_unit(&seed);
                if (ids[i] < 0)
                    assert_int_equal(paradt_dynamic_insert(d, to, weighted ? weights[i] : 0, -1, &ids[i]), PARADT_OK);
                else if (k % 3)
                    assert_int_equal(paradt_dynamic_move(d, ids[i], to, weighted ? weights[i] : 0), PARADT_OK);
                else {
                    assert_int_equal(paradt_dynamic_remove(d, ids[i]), PARADT_OK);
                    ids[i] = -1;
                }
                memcpy(x + i * dim, to, (size_t)dim * sizeof *to);
                if (k % 1000 == 999) check_starts(d);
            }
            paradt_dynamic_free(d);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_vertices_begin_again),
        cmocka_unit_test(stars_after_a_very_large_one_are_whole),
        cmocka_unit_test(the_middle_of_a_sphere_has_a_cell_for_each_facet),
        cmocka_unit_test(heavy_points_hide_those_around_them),
        cmocka_unit_test(powers_are_as_exact_as_they_say),
        cmocka_unit_test(powers_with_weights_are_as_exact_as_they_say),
        cmocka_unit_test(powers_in_the_plane_are_as_exact_as_they_say),
        cmocka_unit_test(powers_by_sagittas_tell_more),
        cmocka_unit_test(powers_by_sagittas_tell_more_in_the_plane),
        cmocka_unit_test(large_stars_in_the_plane_are_whole),
        cmocka_unit_test(near_a_plane_there_are_no_sagittas),
        cmocka_unit_test(ghosts_leave_points_in_their_planes_to_the_predicates),
        cmocka_unit_test(powers_near_zero_are_told_from_zero),
        cmocka_unit_test(searches_start_at_vertices_that_are_there),
    };
    return cmocka_run_group_tests_name("insertion", tests, NULL, NULL);
}
