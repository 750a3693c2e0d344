// Convex hulls: facets against those of triangulations, planes and extreme points against definitions in exact arithmetic,
// measures against exact ones, and what a caller may hand in.
#include "harness.h"
#include "runners.h"

static paradt_hull hull_of(const sample *s, const paradt_options *options) {
    paradt_points points = points_of(s);
    paradt_hull hull;
    memset(&hull, 0x5a, sizeof hull); // the earlier contents of the output have no influence
    watch(s, 60);
    paradt_status status = paradt_hull_compute(&hull, &points, options);
    watch(NULL, 0);
    if (status)
        fail_on_sample(s, paradt_status_string(status));
    return hull;
}

static cell_set facets_of(const paradt_hull *hull) {
    cell_set set = {0};
    int vertices[CELLS_MAX_DIM + 1];
    for (size_t f = 0; f < hull->facet_count; f++) {
        for (int i = 0; i < hull->dim; i++)
            vertices[i] = (int)hull->facets[f * (size_t)hull->dim + (size_t)i];
        cells_add(&set, cell_make(vertices, hull->dim));
    }
    cells_sort(&set);
    return set;
}

// The facets of a triangulation that have a cell on one side only
static cell_set boundary_of(const paradt_triangulation *t) {
    cell_set set = {0};
    int k = t->dim + 1, vertices[CELLS_MAX_DIM + 1];
    for (size_t c = 0; c < t->cell_count && t->dim > 0; c++)
        for (int i = 0; i < k; i++) {
            int n = 0;
            if (t->neighbors[c * (size_t)k + (size_t)i] >= 0)
                continue;
            for (int j = 0; j < k; j++)
                if (j != i)
                    vertices[n++] = (int)t->cells[c * (size_t)k + (size_t)j];
            cells_add(&set, cell_make(vertices, n));
        }
    cells_sort(&set);
    return set;
}

static const double *point_of(const sample *s, paradt_index i) { return s->x + (ptrdiff_t)i * s->dim; }

// The axes that orient points of a lower dimension
static int axes_of(const sample *s, int *axes) {
    exact_points e = exact_make(s);
    int *all = (int *)need((size_t)s->count, sizeof(int));
    for (int i = 0; i < s->count; i++)
        all[i] = i;
    int dim = exact_affine_dim(&e, all, s->count, axes);
    free(all);
    exact_free(&e);
    return dim;
}

// The exact orientation of points in the axes. dim 1: a comparison
static int orientation(int dim, const int *axes, const double *const *p) {
    double x[CELLS_MAX_DIM + 1][CELLS_MAX_DIM];
    const double *rows[CELLS_MAX_DIM + 1];
    for (int i = 0; i <= dim; i++) {
        for (int j = 0; j < dim; j++)
            x[i][j] = p[i][axes[j]];
        rows[i] = x[i];
    }
    return dim == 1 ? (x[1][0] > x[0][0]) - (x[1][0] < x[0][0]) : paradt_orient(dim, rows);
}

// On which side of a facet is a point? 1 inside, 0 on its plane, -1 beyond
static int side_of(const sample *s, const paradt_hull *hull, const int *axes, size_t number, paradt_index point) {
    const double *p[CELLS_MAX_DIM + 1];
    p[0] = point_of(s, point);
    for (int i = 0; i < hull->dim; i++)
        p[i + 1] = point_of(s, hull->facets[number * (size_t)hull->dim + (size_t)i]);
    if (hull->dim == 1) { // the other end is on the inner side
        int inner = compare_coordinates(point_of(s, hull->facets[!number]), p[1], s->dim);
        return inner * compare_coordinates(p[0], p[1], s->dim);
    }
    return orientation(hull->dim, axes, p);
}

// Neighbours share all vertices but one and see each other.
static const char *check_neighbors(const paradt_hull *hull) {
    size_t k = (size_t)hull->dim;
    for (size_t f = 0; f < hull->facet_count; f++)
        for (size_t i = 0; i < k; i++) {
            paradt_index other = hull->neighbors[f * k + i];
            if (other < 0 || (size_t)other >= hull->facet_count || (size_t)other == f)
                return "a neighbour is no facet";
            size_t back = 0;
            while (back < k && hull->neighbors[(size_t)other * k + back] != (paradt_index)f)
                back++;
            if (back == k)
                return "a neighbour does not see the facet";
            for (size_t a = 0; a < k; a++) {
                size_t b = 0;
                while (b < k && hull->facets[f * k + a] != hull->facets[(size_t)other * k + b])
                    b++;
                if ((a == i) != (b == k))
                    return "neighbours do not share a ridge";
            }
        }
    return NULL;
}

// Facets are outward and no point is beyond them; two are of one plane if and only if their vertices lie in it.
static const char *check_sides(const sample *s, const paradt_hull *hull, const int *axes) {
    size_t k = (size_t)hull->dim, planes = 0;
    for (size_t f = 0; f < hull->facet_count; f++) {
        int any = 0, first = 1;
        for (int p = 0; p < s->count; p++) {
            int side = side_of(s, hull, axes, f, p);
            if (side < 0)
                return "a point is beyond a facet";
            any |= side;
        }
        if (!any)
            return "a facet is flat";
        if (hull->plane[f] < 0 || (size_t)hull->plane[f] >= hull->plane_count)
            return "a plane is out of range";
        for (size_t g = f > 300 ? f : 0; g < hull->facet_count && g < f + 300; g++) {
            int same = 1;
            for (size_t i = 0; i < k; i++)
                same &= side_of(s, hull, axes, f, hull->facets[g * k + i]) == 0;
            if (same != (hull->plane[f] == hull->plane[g]))
                return "planes are wrong";
            first &= !same || g >= f;
        }
        planes += (size_t)first;
    }
    return hull->facet_count > 300 || planes == hull->plane_count ? NULL : "the number of planes is wrong";
}

// A point is extreme if the hull of the others does not contain it: they lose it as a point of the hull, or a facet of them
// has it beyond.
static const char *check_extreme(const sample *s, const paradt_hull *hull) {
    char *listed = (char *)calloc((size_t)s->count + 1, 1);
    const char *wrong = NULL;
    if (hull->extreme_count > hull->vertex_count)
        wrong = "there are more extreme points than vertices";
    for (size_t i = 0; i < hull->vertex_count; i++) {
        listed[hull->vertices[i]] = i < hull->extreme_count ? 2 : 1;
        if (i && i != hull->extreme_count && hull->vertices[i] <= hull->vertices[i - 1])
            wrong = "vertices are not ascending";
    }
    for (size_t f = 0; f < hull->facet_count * (size_t)hull->dim; f++)
        if (!listed[hull->facets[f]])
            wrong = "a vertex is not listed";
    for (size_t v = 0; v < hull->vertex_count && !wrong && hull->dim > 0; v++) {
        int *order = (int *)need((size_t)s->count, sizeof(int)), count = 0, axes[CELLS_MAX_DIM], outside = 0;
        const double *x = point_of(s, hull->vertices[v]);
        for (int i = 0; i < s->count; i++)
            if (compare_coordinates(point_of(s, i), x, s->dim))
                order[count++] = i;
        sample others = sample_pick(s, order, count);
        paradt_hull rest = hull_of(&others, NULL);
        outside = rest.dim < hull->dim; // then all others are in a flat, and this point is not
        if (!outside) {
            axes_of(&others, axes);
            for (size_t f = 0; f < rest.facet_count; f++) {
                const double *p[CELLS_MAX_DIM + 1];
                p[0] = x;
                for (int i = 0; i < rest.dim; i++)
                    p[i + 1] = point_of(&others, rest.facets[f * (size_t)rest.dim + (size_t)i]);
                if (rest.dim == 1)
                    outside |= compare_coordinates(x, p[1], s->dim) *
                                   compare_coordinates(point_of(&others, rest.facets[!f]), p[1], s->dim) < 0;
                else
                    outside |= orientation(rest.dim, axes, p) < 0;
            }
        }
        if (outside != (v < hull->extreme_count))
            wrong = outside ? "an extreme point is not called extreme" : "a point is called extreme and is not";
        paradt_hull_free(&rest);
        sample_free(&others);
        free(order);
    }
    free(listed);
    return wrong;
}

// The volume times dim!, by determinants of integers, for points of full dimension. Returns whether |volume - it| is within
// the error that the hull states.
static const char *check_volume(const sample *s, const paradt_hull *hull) {
    exact_points e = exact_make(s);
    int d = s->dim;
    const char *wrong = NULL;
    mpq_t sum, term, scale;
    mpq_inits(sum, term, scale, NULL);
    for (size_t f = 0; f < hull->facet_count; f++) {
        mpq_t m[CELLS_MAX_DIM][CELLS_MAX_DIM];
        mpq_set_si(term, 1, 1);
        for (int i = 0; i < d; i++)
            for (int j = 0; j < d; j++) {
                mpq_t a;
                mpq_init(a);
                mpq_init(m[i][j]);
                mpq_set_d(m[i][j], point_of(s, hull->facets[f * (size_t)d + (size_t)i])[j]);
                mpq_set_d(a, s->x[j]);
                mpq_sub(m[i][j], m[i][j], a);
                mpq_clear(a);
            }
        for (int i = 0; i < d; i++) { // elimination
            int pivot = i;
            while (pivot < d && mpq_sgn(m[pivot][i]) == 0)
                pivot++;
            if (pivot == d) {
                mpq_set_si(term, 0, 1);
                break;
            }
            if (pivot != i) {
                mpq_neg(term, term);
                for (int j = 0; j < d; j++)
                    mpq_swap(m[pivot][j], m[i][j]);
            }
            mpq_mul(term, term, m[i][i]);
            for (int r = i + 1; r < d; r++) {
                mpq_div(scale, m[r][i], m[i][i]);
                for (int j = d - 1; j >= i; j--) {
                    mpq_t a;
                    mpq_init(a);
                    mpq_mul(a, scale, m[i][j]);
                    mpq_sub(m[r][j], m[r][j], a);
                    mpq_clear(a);
                }
            }
        }
        mpq_add(sum, sum, term);
        for (int i = 0; i < d; i++)
            for (int j = 0; j < d; j++)
                mpq_clear(m[i][j]);
    }
    for (int i = 2; i <= d; i++) {
        mpq_set_si(scale, i, 1);
        mpq_div(sum, sum, scale);
    }
    if (hull->volume <= 1.7e308 && hull->volume_error <= 1.7e308) {
        mpq_set_d(term, hull->volume);
        mpq_sub(sum, sum, term);
        mpq_abs(sum, sum);
        mpq_set_d(term, hull->volume_error);
        if (mpq_cmp(sum, term) > 0)
            wrong = "the volume's error is larger than it says";
    }
    mpq_clears(sum, term, scale, NULL);
    exact_free(&e);
    return wrong;
}

// paradt_hull_check accepts the hull, with and without neighbours.
static const char *check_certificate(const sample *s, const paradt_hull *hull) {
    paradt_points points = points_of(s);
    paradt_fault fault;
    paradt_hull bare = *hull;
    bare.neighbors = NULL;
    watch(s, 60);
    if (paradt_hull_check(hull, &points, NULL, &fault) || paradt_hull_check(&bare, &points, NULL, &fault))
        return fault.reason;
    watch(NULL, 0);
    return NULL;
}

static void check_all(const sample *s, const paradt_hull *hull, int deeply) {
    int axes[CELLS_MAX_DIM] = {0};
    const char *wrong = NULL;
    deeply &= hull->vertex_count < 50;
    if (axes_of(s, axes) != hull->dim)
        wrong = "the dimension is wrong";
    if (!wrong)
        wrong = check_certificate(s, hull);
    if (!wrong && hull->dim > 0)
        wrong = check_neighbors(hull);
    if (!wrong && hull->dim > 0)
        wrong = check_sides(s, hull, axes);
    if (!wrong && deeply)
        wrong = check_extreme(s, hull);
    if (!wrong && hull->dim == s->dim)
        wrong = check_volume(s, hull);
    if (wrong)
        fail_on_sample(s, wrong);
}

// --- tests

static void hulls_are_the_boundaries_of_triangulations(void **state) {
    (void)state;
    static const int counts[] = {0, 0, 40, 36, 24, 16, 12, 11, 11};
    for (int dim = 2; dim <= (SANITIZED ? 4 : is_quick() ? 5 : 8); dim++)
        for (int f = 0; f < FAMILY_COUNT; f++)
            for (uint64_t seed = 1; seed <= (SANITIZED || is_quick() || dim > 3 ? 1 : 2); seed++) {
                if ((SANITIZED && (f + dim) % 2) || (dim > 5 && (f + dim) % 3)) // a family has one of the highest dimensions
                    continue;
                sample s = family_make(&families[f], NULL, dim, counts[dim] * (int)seed, seed);
                paradt_options facets = {0};
                facets.method = PARADT_BOWYER_WATSON;
                paradt_points points = points_of(&s);
                paradt_triangulation t;
                assert_int_equal(paradt_triangulate(&t, &points, &facets), PARADT_OK);
                paradt_hull hull = hull_of(&s, NULL);
                cell_set expected = boundary_of(&t), found = facets_of(&hull);
                assert_int_equal(hull.dim, t.dim);
                fail_if_different(&s, "hull", &expected, &found);
                check_all(&s, &hull, seed == 1 && dim <= 4);
                cells_free(&expected);
                cells_free(&found);
                paradt_free(&t);
                paradt_hull_free(&hull);
                sample_free(&s);
            }
}

// Enough points that most of them are dropped early
static void many_points_have_the_hull_of_their_triangulation(void **state) {
    (void)state;
    for (int dim = 2; dim <= (SANITIZED ? 3 : 4); dim++)
        for (int f = 0; f < FAMILY_COUNT; f++) {
            static const char *const chosen[] = {"uniform", "gauss", "plummer", "lattice", "cube surface", "clusters",
                                                 "lattice off by ulps", "far away", "ulp lattice", "hyperplane"};
            size_t c = 0;
            while (c < sizeof chosen / sizeof *chosen && strcmp(chosen[c], families[f].name) != 0)
                c++;
            if (c == sizeof chosen / sizeof *chosen)
                continue;
            sample s = family_make(&families[f], NULL, dim, SANITIZED ? 2500 : dim == 4 ? 8500 : 17000, 7);
            paradt_options options = {0};
            options.method = PARADT_BOWYER_WATSON;
            paradt_points points = points_of(&s);
            paradt_triangulation t;
            watch(&s, 60);
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            paradt_hull hull = hull_of(&s, NULL);
            cell_set expected = boundary_of(&t), found = facets_of(&hull);
            fail_if_different(&s, "hull", &expected, &found);
            cells_free(&expected);
            cells_free(&found);
            paradt_free(&t);
            paradt_hull_free(&hull);
            sample_free(&s);
        }
}

// So many points that samples of samples sift them. The certificate looks at all of them.
static void samples_of_samples_drop_no_point_of_the_hull(void **state) {
    (void)state;
    static const struct {
        const char *family;
        int dim;
    } rows[] = {{"uniform", 2}, {"gauss", 2}, {"lattice", 2}, {"uniform", 3}, {"gauss", 3}, {"clusters", 3}, {"uniform", 4}};
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        sample s = family_make(&families[family_named(rows[r].family)], NULL, rows[r].dim, 600000, 1);
        paradt_points points = points_of(&s);
        paradt_fault fault;
        paradt_hull hull = hull_of(&s, NULL);
        watch(&s, 60);
        if (paradt_hull_check(&hull, &points, NULL, &fault))
            fail_on_sample(&s, fault.reason);
        watch(NULL, 0);
        // Most points were not sorted.
        if (s.dim < 4 && hull.stats.peak_bytes >= (uint64_t)s.count * 16)
            fail_on_sample(&s, "takes too much memory");
        paradt_hull_free(&hull);
        sample_free(&s);
        if (SANITIZED)
            break;
    }
}

// Beyond the numbers that samples of points are sifted by, all points are looked at.
static void huge_and_tiny_scales_have_the_same_facets(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        sample s = family_make(&families[family_named("uniform")], NULL, dim, dim == 2 ? 5000 : 40000, 4);
        paradt_hull hull = hull_of(&s, NULL);
        for (int e = -1; e <= 1; e += 2) {
            sample scaled = sample_make("scaled", dim, s.count);
            for (int i = 0; i < s.count * dim; i++)
                scaled.x[i] = ldexp(s.x[i], 1000 * e);
            paradt_hull other = hull_of(&scaled, NULL);
            assert_true(paradt_hull_hash(&other) == paradt_hull_hash(&hull));
            paradt_hull_free(&other);
            sample_free(&scaled);
        }
        paradt_hull_free(&hull);
        sample_free(&s);
    }
}

static double power_of(double x, int n) { return n ? x * power_of(x, n - 1) : 1; }

static double factorial(int n) { return n > 1 ? n * factorial(n - 1) : 1; }

static void expect_measures(const sample *s, double area, double volume, size_t planes, size_t extreme) {
    paradt_hull hull = hull_of(s, NULL);
    if (!(fabs(hull.area - area) <= hull.area_error + 1e-15 * area) ||
        !(fabs(hull.volume - volume) <= hull.volume_error + 1e-15 * volume) || hull.area_error > 1e-12 * area ||
        hull.volume_error > 1e-12 * volume)
        fail_on_sample(s, "area or volume is wrong");
    if (hull.plane_count != planes || hull.extreme_count != extreme)
        fail_on_sample(s, "the number of planes or of extreme points is wrong");
    paradt_hull_free(&hull);
}

static void cubes_simplices_and_cross_polytopes_have_their_measures(void **state) {
    (void)state;
    for (int d = 2; d <= (SANITIZED ? 6 : 8); d++) {
        int side = d < 5 ? 4 : d < 6 ? 3 : 2, count = (int)power_of(side, d);
        sample cube = sample_make("cube", d, count), simplex = sample_make("simplex", d, d + 1);
        sample cross = sample_make("cross-polytope", d, 2 * d + 1);
        for (int i = 0; i < count; i++)
            for (int k = 0, rest = i; k < d; k++, rest /= side)
                cube.x[i * d + k] = rest % side;
        memset(simplex.x, 0, sizeof(double) * (size_t)((d + 1) * d));
        memset(cross.x, 0, sizeof(double) * (size_t)((2 * d + 1) * d));
        for (int k = 0; k < d; k++) {
            simplex.x[k * d + k] = 1;
            cross.x[2 * k * d + k] = 1;
            cross.x[(2 * k + 1) * d + k] = -1;
        }
        expect_measures(&cube, 2 * d * power_of(side - 1, d - 1), power_of(side - 1, d), (size_t)(2 * d), (size_t)1 << d);
        expect_measures(&simplex, (d + sqrt(d)) / factorial(d - 1), 1 / factorial(d), (size_t)(d + 1), (size_t)(d + 1));
        expect_measures(&cross, power_of(2, d) * sqrt(d) / factorial(d - 1), power_of(2, d) / factorial(d), (size_t)1 << d,
                        (size_t)(2 * d));
        sample_free(&cube);
        sample_free(&simplex);
        sample_free(&cross);
    }
}

// Points on the facets of a cross-polytope, with integers for coordinates that are so large that products are rounded:
// no facet of the hull is seen to be flat or not by its signs in floating point. One of them is then moved outward by 1.
static void planes_are_those_of_exact_arithmetic(void **state) {
    const int64_t size = ((int64_t)1 << 40) + 1;
    (void)state;
    for (int d = 2; d <= 5; d++) {
        const int each = 24, count = 2 * d + (each << d);
        sample s = sample_make("cross-polytope with points on its facets", d, count);
        uint64_t seed = (uint64_t)d;
        paradt_hull hull;
        memset(s.x, 0, sizeof(double) * (size_t)(count * d));
        for (int k = 0; k < 2 * d; k++)
            s.x[k * d + k / 2] = (double)(k % 2 ? -size : size);
        for (int i = 2 * d; i < count; i++) {
            int64_t left = size - d;
            for (int k = 0; k < d; k++) {
                int64_t part = k + 1 < d ? (int64_t)(random_below(&seed, 1 << 20) * (left >> 21)) : left;
                s.x[i * d + k] = (double)(part + 1) * (i >> k & 1 ? -1 : 1);
                left -= part;
            }
        }
        hull = hull_of(&s, NULL);
        if (hull.plane_count != (size_t)1 << d || hull.extreme_count != (size_t)(2 * d))
            fail_on_sample(&s, "points on facets are seen outside of them");
        paradt_hull_free(&hull);
        s.x[2 * d * d] += s.x[2 * d * d] > 0 ? 1 : -1;
        hull = hull_of(&s, NULL);
        if (hull.plane_count != ((size_t)1 << d) - 1 + (size_t)d || hull.extreme_count != (size_t)(2 * d + 1))
            fail_on_sample(&s, "a point is not seen outside of a facet");
        paradt_hull_free(&hull);
        sample_free(&s);
    }
}

// Points in a flat: a square in space, slanted, with points inside and on its sides
static void flat_sets_have_the_measures_of_their_flat(void **state) {
    (void)state;
    sample s = sample_make("slanted square", 3, 25);
    for (int i = 0; i < 25; i++) {
        s.x[3 * i] = i % 5;
        s.x[3 * i + 1] = i / 5;
        s.x[3 * i + 2] = i % 5;
    }
    expect_measures(&s, 8 + 8 * sqrt(2), 16 * sqrt(2), 4, 4);
    paradt_hull hull = hull_of(&s, NULL);
    assert_int_equal(hull.dim, 2);
    assert_int_equal(hull.facet_count, 16); // the points on the sides are vertices
    assert_int_equal(hull.vertex_count, 16);
    paradt_hull_free(&hull);
    s.count = 5;
    hull = hull_of(&s, NULL);
    assert_int_equal(hull.dim, 1);
    assert_int_equal(hull.facet_count, 2);
    assert_int_equal(hull.vertex_count, 2);
    assert_true(hull.area == 2 && fabs(hull.volume - 4 * sqrt(2)) <= hull.volume_error);
    paradt_hull_free(&hull);
    s.count = 1;
    hull = hull_of(&s, NULL);
    assert_int_equal(hull.dim, 0);
    assert_int_equal(hull.facet_count, 0);
    assert_int_equal(hull.vertex_count, 1);
    paradt_hull_free(&hull);
    s.count = 0;
    hull = hull_of(&s, NULL);
    assert_int_equal(hull.dim, -1);
    assert_int_equal(hull.vertex_count, 0);
    paradt_hull_free(&hull);
    sample_free(&s);
}

static void huge_and_tiny_measures_are_scaled(void **state) {
    (void)state;
    for (int exponent = -1000; exponent <= 1000; exponent += 250) {
        sample s = sample_make("scaled cube", 3, 8);
        for (int i = 0; i < 24; i++)
            s.x[i] = ldexp(i / 3 >> i % 3 & 1, exponent);
        paradt_hull hull = hull_of(&s, NULL);
        double volume = ldexp(1, 3 * exponent), area = 6 * ldexp(1, 2 * exponent);
        if (volume > 1e308)
            assert_true(hull.volume > 1.7e308 && hull.volume_error > 1.7e308);
        else
            assert_true(fabs(hull.volume - volume) <= hull.volume_error && hull.volume_error <= 1e-12 * volume + 1e-290);
        if (area > 1e308)
            assert_true(hull.area > 1.7e308);
        else
            assert_true(fabs(hull.area - area) <= hull.area_error && hull.area_error <= 1e-12 * area + 1e-290);
        paradt_hull_free(&hull);
        sample_free(&s);
    }
}

// --- threads

// Of a needle the measure may be less than 2^-511 of what its length suggests.
static void needles_have_a_measure(void **state) {
    static const double plane[] = {0, 0, 0x1p700, 0, 0, 1}, space[] = {0, 0, 0, 0x1p300, 0, 0, 0, 1, 0, 0, 0, 1};
    paradt_points points = paradt_points_f64(plane, 3, 2);
    paradt_hull hull;
    (void)state;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_OK);
    assert_true(hull.volume_error < 1e-12 * 0x1p699 && fabs(hull.volume - 0x1p699) <= hull.volume_error);
    paradt_hull_free(&hull);
    points = paradt_points_f64(space, 4, 3);
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_OK);
    assert_true(hull.volume_error < 1e-12 * 0x1p300 && fabs(6 * hull.volume - 0x1p300) <= 7 * hull.volume_error);
    assert_true(hull.area_error < 1e-12 * 0x1p300 && fabs(hull.area / (1 + sqrt(0.5)) - 0x1p300) <= 0x1p260);
    paradt_hull_free(&hull);
}

// Beyond all doubles, of which the bound is one, too: it is not cut off there.
static void errors_beyond_all_doubles_are_infinite(void **state) {
    static const double x[] = {-0x1p-15, -1, -0x1p1000, 0x1p9, 0x1p-7, 0, 0x1p16, -0x1p40, 0x1.f8p14, -0x1p9, 0, 0};
    paradt_points points = paradt_points_f64(x, 4, 3);
    paradt_hull hull;
    (void)state;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_OK);
    assert_true(hull.volume_error > 1.7976931348623157e308);
    paradt_hull_free(&hull);
}

static void threads_give_the_same_hull(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (size_t tasks = 0; tasks <= 4; tasks += 2) {
            sample s = family_make(&families[family_named(tasks == 4 ? "lattice" : "sphere")], NULL, dim,
                                   dim == 4 ? (SANITIZED ? 4500 : 10500) : 30000, 3);
            paradt_options options = {0};
            paradt_hull one = hull_of(&s, NULL), many;
            options.parallel_for = run_on_threads;
            options.regions = tasks;
            many = hull_of(&s, &options);
            assert_true(paradt_hull_hash(&one) == paradt_hull_hash(&many));
            assert_int_equal(one.plane_count, many.plane_count);
            assert_int_equal(one.extreme_count, many.extreme_count);
            assert_memory_equal(one.vertices, many.vertices, one.vertex_count * sizeof *one.vertices);
            assert_true(fabs(one.volume - many.volume) <= one.volume_error + many.volume_error);
            paradt_hull_free(&one);
            paradt_hull_free(&many);
            sample_free(&s);
        }
}

// --- memory, cancelling, arguments

typedef struct books {
    size_t calls, fail_at, live, held, peak;
} books;

static void *books_alloc(void *user, size_t size) {
    books *b = (books *)user;
    size_t *block;
    if (++b->calls == b->fail_at || !(block = (size_t *)malloc(size + 64)))
        return NULL;
    *block = size;
    b->live++;
    b->held += size;
    b->peak = b->held > b->peak ? b->held : b->peak;
    return (char *)block + 64;
}

static void books_free(void *user, void *memory) {
    books *b = (books *)user;
    size_t *block = (size_t *)(void *)((char *)memory - 64);
    b->live--;
    b->held -= *block;
    free(block);
}

static void expect_empty(const paradt_hull *hull) {
    assert_int_equal(hull->dim, -1);
    assert_true(!hull->facets && !hull->neighbors && !hull->plane && !hull->vertices && hull->error_text);
    assert_true(hull->facet_count + hull->vertex_count + hull->extreme_count + hull->plane_count + hull->point_count == 0);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (int large = 0; large <= (dim == 2); large++) {
            sample s = family_make(&families[family_named("lattice")], NULL, dim, large ? 20000 : 80, 3);
            paradt_points points = points_of(&s);
            for (size_t at = 1;; at++) {
                books b = {0};
                paradt_options options = {0};
                paradt_hull hull;
                paradt_fault fault;
                b.fail_at = at;
                options.allocator.alloc = books_alloc;
                options.allocator.free = books_free;
                options.allocator.user = &b;
                paradt_status status = paradt_hull_compute(&hull, &points, &options);
                if (!status) {
                    assert_true(b.calls < at && hull.stats.peak_bytes == b.peak);
                    for (size_t k = 1; k < 20; k++) {
                        books c = {0};
                        c.fail_at = k;
                        options.allocator.user = &c;
                        status = paradt_hull_check(&hull, &points, &options, &fault);
                        assert_true(status == PARADT_OK ? c.calls < k : status == PARADT_ERROR_MEMORY);
                        assert_int_equal(c.live, 0);
                    }
                    paradt_hull_free(&hull);
                    assert_int_equal(b.live, 0);
                    break;
                }
                assert_int_equal(status, PARADT_ERROR_MEMORY);
                assert_int_equal(b.live, 0);
                expect_empty(&hull);
            }
            sample_free(&s);
        }
}

static void the_memory_limit_is_kept(void **state) {
    (void)state;
    sample s = family_make(&families[family_named("sphere")], NULL, 3, 3000, 3);
    paradt_points points = points_of(&s);
    paradt_hull hull = hull_of(&s, NULL);
    uint64_t peak = hull.stats.peak_bytes;
    paradt_hull_free(&hull);
    for (int i = 1; i <= 16; i++) {
        books b = {0};
        paradt_options options = {0};
        options.allocator.alloc = books_alloc;
        options.allocator.free = books_free;
        options.allocator.user = &b;
        options.memory_limit = (size_t)(peak * (uint64_t)i / 8);
        paradt_status status = paradt_hull_compute(&hull, &points, &options);
        assert_true(b.peak <= options.memory_limit);
        if (status) {
            assert_int_equal(status, PARADT_ERROR_MEMORY);
            assert_true(hull.stats.needed_bytes > options.memory_limit);
            expect_empty(&hull);
        } else
            assert_true(i >= 8);
        paradt_hull_free(&hull);
        assert_int_equal(b.live, 0);
    }
    sample_free(&s);
}

typedef struct stop {
    int calls, at;
    double last;
} stop;

static int stop_at(void *user, double fraction) {
    stop *s = (stop *)user;
    assert_true(fraction >= s->last && fraction <= 1);
    s->last = fraction;
    return ++s->calls == s->at;
}

static void every_call_of_progress_may_cancel(void **state) {
    (void)state;
    sample s = family_make(&families[family_named("lattice")], NULL, 3, 20000, 3);
    paradt_points points = points_of(&s);
    for (int at = 1;; at += SANITIZED ? 3 : 1) {
        stop counter = {0, at, 0};
        books b = {0};
        paradt_options options = {0};
        paradt_hull hull;
        options.allocator.alloc = books_alloc;
        options.allocator.free = books_free;
        options.allocator.user = &b;
        options.progress = stop_at;
        options.user = &counter;
        paradt_status status = paradt_hull_compute(&hull, &points, &options);
        if (!status) {
            assert_true(counter.calls < at && at > 5 && counter.last == 1);
            paradt_hull_free(&hull);
            break;
        }
        assert_int_equal(status, PARADT_ERROR_CANCELLED);
        assert_int_equal(counter.calls, at);
        assert_int_equal(b.live, 0);
        expect_empty(&hull);
    }
    sample_free(&s);
}

static void wrong_arguments_are_named(void **state) {
    (void)state;
    double x[] = {0, 0, 1, 0, 0, 1, 1, 1};
    paradt_points points = paradt_points_f64(x, 4, 2);
    paradt_options options = {0};
    paradt_hull hull;
    assert_int_equal(paradt_hull_compute(NULL, &points, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_hull_compute(&hull, NULL, NULL), PARADT_ERROR_ARGUMENT);
    expect_empty(&hull);
    points.weights = x;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_ERROR_ARGUMENT);
    assert_non_null(strstr(hull.error_text, "weights"));
    points.weights = NULL;
    options.flags = 1u << 20;
    assert_int_equal(paradt_hull_compute(&hull, &points, &options), PARADT_ERROR_ARGUMENT);
    options.flags = PARADT_FURTHEST_SITE;
    assert_int_equal(paradt_hull_compute(&hull, &points, &options), PARADT_ERROR_ARGUMENT);
    options.flags = PARADT_FULL_DIM;
    points.count = 2;
    assert_int_equal(paradt_hull_compute(&hull, &points, &options), PARADT_ERROR_FLAT);
    expect_empty(&hull);
    points.count = 4;
    x[5] = NAN;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(hull.error_point, 2);
    x[5] = INFINITY;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(hull.error_point, 2);
    paradt_hull_free(&hull);
    paradt_hull_free(NULL);
}

static void wrong_arguments_of_the_certificate_are_named(void **state) {
    static const double x[] = {0, 0, 1, 0, 0, 1, 1, 1};
    static const char *const reasons[] = {"points is NULL", "points.weights is not NULL, but a hull has no weights", "hull is NULL",
                                          "hull.facets or hull.plane is NULL", "hull.vertices is NULL",
                                          "hull.facet_count is larger than an index can number"};
    paradt_points points = paradt_points_f64(x, 4, 2), weighted = points;
    paradt_hull hull, wrong;
    (void)state;
    weighted.weights = x;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_OK);
    for (size_t i = 0; i < sizeof reasons / sizeof reasons[0]; i++) {
        paradt_fault fault;
        wrong = hull;
        if (i == 3)
            wrong.plane = NULL;
        if (i == 4)
            wrong.vertices = NULL;
        if (i == 5)
            wrong.facet_count = SIZE_MAX / 8;
        assert_int_equal(paradt_hull_check(i == 2 ? NULL : &wrong, i == 0 ? NULL : i == 1 ? &weighted : &points, NULL, &fault),
                         PARADT_ERROR_ARGUMENT);
        assert_string_equal(fault.reason, reasons[i]);
        assert_true(fault.cell == -1 && fault.point == -1);
    }
    paradt_hull_free(&hull);
}

static void flags_choose_the_neighbours(void **state) {
    (void)state;
    for (int dim = 2; dim <= 5; dim++) {
        sample s = family_make(&families[family_named("lattice")], NULL, dim, 40, 3);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        paradt_hull plain = hull_of(&s, NULL), halves, bare;
        options.flags = PARADT_FACETS;
        halves = hull_of(&s, &options);
        assert_int_equal(paradt_hull_check(&halves, &points, &options, NULL), PARADT_OK);
        for (size_t i = 0; i < halves.facet_count * (size_t)dim; i++)
            assert_int_equal(halves.neighbors[halves.neighbors[i]], (paradt_index)i);
        options.flags = PARADT_NO_NEIGHBORS;
        bare = hull_of(&s, &options);
        assert_null(bare.neighbors);
        assert_true(paradt_hull_hash(&plain) == paradt_hull_hash(&halves) && paradt_hull_hash(&plain) == paradt_hull_hash(&bare));
        paradt_hull_free(&plain);
        paradt_hull_free(&halves);
        paradt_hull_free(&bare);
        sample_free(&s);
    }
}

// The certificate refuses whatever is changed in a hull.
static void changed_hulls_are_refused(void **state) {
    (void)state;
    uint64_t seed = 5;
    for (int dim = 2; dim <= 4; dim++)
        for (int i = 0; i < 300; i++) {
            sample s = family_make(&families[family_named(i % 2 ? "lattice" : "uniform")], NULL, dim, 30, 3);
            paradt_points points = points_of(&s);
            paradt_hull hull = hull_of(&s, NULL);
            paradt_fault fault;
            size_t all = hull.facet_count * (size_t)dim, at = (size_t)random_below(&seed, (int)all), other;
            paradt_index before, *changed = i % 5 == 0 ? hull.facets + at : i % 5 == 1 ? hull.neighbors + at
                                           : i % 5 == 2 ? hull.plane + at / (size_t)dim
                                           : i % 5 == 3 ? hull.vertices + at % hull.vertex_count : NULL;
            if (changed) {
                before = *changed;
                *changed = random_below(&seed, s.count + 2) - 1;
                if (*changed != before)
                    assert_int_equal(paradt_hull_check(&hull, &points, NULL, &fault), PARADT_ERROR_INVALID);
                *changed = before;
            } else { // a point moves beyond a facet, or is somewhere else
                double *x = s.x + random_below(&seed, s.count * dim);
                *x += 100;
                assert_int_equal(paradt_hull_check(&hull, &points, NULL, &fault), PARADT_ERROR_INVALID);
                *x -= 100;
                other = (at + (size_t)dim) % all; // two vertices of different facets change places
                before = hull.facets[at];
                hull.facets[at] = hull.facets[other];
                hull.facets[other] = before;
                if (hull.facets[at] != before)
                    assert_int_equal(paradt_hull_check(&hull, &points, NULL, NULL), PARADT_ERROR_INVALID);
            }
            paradt_hull_free(&hull);
            sample_free(&s);
        }
}

static void refuses(const paradt_hull *hull, const paradt_points *points, const char *reason) {
    paradt_fault fault;
    assert_int_equal(paradt_hull_check(hull, points, NULL, &fault), PARADT_ERROR_INVALID);
    assert_string_equal(fault.reason, reason);
}

static void exchange(paradt_index *a, paradt_index *b) {
    paradt_index before = *a;
    *a = *b;
    *b = before;
}

// A segment with two equal points at its first end, with one thing wrong in each turn
static void what_is_wrong_with_the_ends_of_a_line_is_named(void **state) {
    static const double x[] = {0, 0, 1, 1, 2, 2, 0, 0};
    paradt_points points = paradt_points_f64(x, 4, 2);
    paradt_hull hull, wrong;
    paradt_index facets[2], neighbors[2], plane[2], vertices[2];
    (void)state;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_OK);
    assert_true(hull.dim == 1 && hull.facets[0] == 0 && hull.facets[1] == 2);
    for (int turn = 0; turn < 10; turn++) {
        wrong = hull;
        wrong.facets = (paradt_index *)memcpy(facets, hull.facets, sizeof facets);
        wrong.neighbors = (paradt_index *)memcpy(neighbors, hull.neighbors, sizeof neighbors);
        wrong.plane = (paradt_index *)memcpy(plane, hull.plane, sizeof plane);
        wrong.vertices = (paradt_index *)memcpy(vertices, hull.vertices, sizeof vertices);
        switch (turn) {
        case 0: assert_int_equal(paradt_hull_check(&wrong, &points, NULL, NULL), PARADT_OK); break;
        case 1:
            wrong.facet_count = wrong.plane_count = 1;
            refuses(&wrong, &points, "a line has two facets, and a place none");
            break;
        case 2:
            wrong.vertex_count = 1;
            refuses(&wrong, &points, "vertex_count is not the number of vertices");
            break;
        case 3:
            facets[0] = 4;
            refuses(&wrong, &points, "a vertex is no point");
            break;
        case 4:
            plane[1] = 0;
            refuses(&wrong, &points, "the number of a plane is wrong");
            break;
        case 5:
            neighbors[1] = 1;
            refuses(&wrong, &points, "the ends are not neighbours");
            break;
        case 6:
            vertices[0] = 1;
            refuses(&wrong, &points, "a vertex is not listed");
            break;
        case 7:
            facets[1] = vertices[1] = 1;
            refuses(&wrong, &points, "a point is beyond an end");
            break;
        case 8:
            facets[0] = vertices[0] = 3;
            refuses(&wrong, &points, "a vertex is not the smallest index at its place");
            break;
        default:
            wrong.point_count = 3;
            refuses(&wrong, &points, "the hull is of another number of points");
        }
    }
    paradt_hull_free(&hull);
}

// The corners of a cube, one of them twice
static void what_is_wrong_with_a_cube_is_named(void **state) {
    static const double x[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 0, 0, 0};
    paradt_points points = paradt_points_f64(x, 9, 3), none = paradt_points_f64(x, 0, 3);
    paradt_hull hull, empty;
    size_t other;
    (void)state;
    assert_int_equal(paradt_hull_compute(&hull, &points, NULL), PARADT_OK);
    hull.vertex_count--;
    refuses(&hull, &points, "vertex_count is not the number of vertices");
    hull.vertex_count++;
    for (int turn = 0; turn < 2; turn++) { // the larger of two equal points takes the place of the other, and goes
        for (size_t i = 0; i < hull.facet_count * 3; i++)
            if (hull.facets[i] == (turn ? 8 : 0))
                hull.facets[i] = turn ? 0 : 8;
        if (!turn)
            refuses(&hull, &points, "a vertex is not the smallest index at its place");
    }
    other = 3 * (size_t)hull.neighbors[0]; // a facet is turned over, with its links
    exchange(&hull.facets[other], &hull.facets[other + 1]);
    exchange(&hull.neighbors[other], &hull.neighbors[other + 1]);
    refuses(&hull, &points, "neighbours lie on the same side of their ridge");
    paradt_hull_free(&hull);
    assert_int_equal(paradt_hull_compute(&empty, &none, NULL), PARADT_OK);
    assert_int_equal(paradt_hull_check(&empty, &none, NULL, NULL), PARADT_OK);
    empty.vertices = &(paradt_index){0};
    empty.vertex_count = 1;
    refuses(&empty, &none, "there are facets or vertices without points");
}

static void floats_and_strides_are_read(void **state) {
    (void)state;
    struct { char c; float x[3]; } rows[200];
    double x[600];
    uint64_t seed = 1;
    memset(rows, 0, sizeof rows);
    for (int i = 0; i < 600; i++)
        x[i] = rows[i / 3].x[i % 3] = (float)random_unit(&seed);
    paradt_points points = paradt_points_f32(rows[0].x, 200, 3), doubles = paradt_points_f64(x, 200, 3);
    paradt_hull a, b;
    points.stride = sizeof *rows;
    assert_int_equal(paradt_hull_compute(&a, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_hull_compute(&b, &doubles, NULL), PARADT_OK);
    assert_true(paradt_hull_hash(&a) == paradt_hull_hash(&b) && a.volume == b.volume);
    paradt_hull_free(&a);
    paradt_hull_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hulls_are_the_boundaries_of_triangulations),
        cmocka_unit_test(many_points_have_the_hull_of_their_triangulation),
        cmocka_unit_test(samples_of_samples_drop_no_point_of_the_hull),
        cmocka_unit_test(huge_and_tiny_scales_have_the_same_facets),
        cmocka_unit_test(cubes_simplices_and_cross_polytopes_have_their_measures),
        cmocka_unit_test(planes_are_those_of_exact_arithmetic),
        cmocka_unit_test(flat_sets_have_the_measures_of_their_flat),
        cmocka_unit_test(huge_and_tiny_measures_are_scaled),
        cmocka_unit_test(needles_have_a_measure),
        cmocka_unit_test(errors_beyond_all_doubles_are_infinite),
        cmocka_unit_test(threads_give_the_same_hull),
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(the_memory_limit_is_kept),
        cmocka_unit_test(every_call_of_progress_may_cancel),
        cmocka_unit_test(wrong_arguments_are_named),
        cmocka_unit_test(wrong_arguments_of_the_certificate_are_named),
        cmocka_unit_test(flags_choose_the_neighbours),
        cmocka_unit_test(changed_hulls_are_refused),
        cmocka_unit_test(what_is_wrong_with_the_ends_of_a_line_is_named),
        cmocka_unit_test(what_is_wrong_with_a_cube_is_named),
        cmocka_unit_test(floats_and_strides_are_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
