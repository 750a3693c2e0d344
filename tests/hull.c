// Convex hulls: facets against those of triangulations, planes and extreme points against definitions in exact arithmetic,
// measures against exact ones, and what a caller may hand in.
#include "harness.h"

#include <pthread.h>

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
    for (int dim = 2; dim <= (SANITIZED ? 5 : 8); dim++)
        for (int f = 0; f < FAMILY_COUNT; f++)
            for (uint64_t seed = 1; seed <= (SANITIZED || is_quick() || dim > 3 ? 1 : 3); seed++) {
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
    for (int dim = 2; dim <= 4; dim++)
        for (int f = 0; f < FAMILY_COUNT; f++) {
            static const char *const chosen[] = {"uniform", "gauss", "plummer", "lattice", "cube surface", "clusters",
                                                 "lattice off by ulps", "far away", "ulp lattice", "hyperplane"};
            size_t c = 0;
            while (c < sizeof chosen / sizeof *chosen && strcmp(chosen[c], families[f].name) != 0)
                c++;
            if (c == sizeof chosen / sizeof *chosen)
                continue;
            sample s = family_make(&families[f], NULL, dim, dim == 4 ? 8500 : 17000, 7);
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hulls_are_the_boundaries_of_triangulations),
        cmocka_unit_test(many_points_have_the_hull_of_their_triangulation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
