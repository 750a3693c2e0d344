// Measures of a cell are compared with rational arithmetic (GMP); then what the thesis proves with them is tested on
// triangulations of the same points that random flips lead to: of all triangulations T(P) has the smallest largest
// min-containment sphere (theorem 1.2), every triangulation of self-centred cells is Delaunay (theorem 1.3), and the
// power of a place with regard to the sphere of the cell around it is nowhere smaller than by T(P) (lemma 1.5).
#include "harness.h"

#include <float.h>

enum { LARGEST_DIM = PARADT_MAX_DIM, MOST = LARGEST_DIM + 1 };

// --- rational arithmetic

static mpq_t *rationals(int count) {
    mpq_t *q = (mpq_t *)need((size_t)count, sizeof(mpq_t));
    for (int i = 0; i < count; i++)
        mpq_init(q[i]);
    return q;
}

static void rationals_free(mpq_t *q, int count) {
    for (int i = 0; i < count; i++)
        mpq_clear(q[i]);
    free(q);
}

// sum += a * b
static void add_product(mpq_t sum, const mpq_t a, const mpq_t b) {
    mpq_t t;
    mpq_init(t);
    mpq_mul(t, a, b);
    mpq_add(sum, sum, t);
    mpq_clear(t);
}

// Solves n equations, m[n][n + 1], in place: the last column becomes the solution. Returns 0 if they are dependent. The
// determinant, which may be NULL, is that of the first n columns.
static int solve(mpq_t *m, int n, mpq_t *determinant) {
    int width = n + 1, regular = 1;
    mpq_t factor, product;
    mpq_init(factor);
    mpq_init(product);
    mpq_set_ui(product, 1, 1);
    for (int c = 0; c < n && regular; c++) {
        int pivot = c;
        while (pivot < n && mpq_sgn(m[pivot * width + c]) == 0)
            pivot++;
        regular = pivot < n;
        for (int j = 0; j < width && regular && pivot != c; j++)
            mpq_swap(m[pivot * width + j], m[c * width + j]);
        if (regular && pivot != c)
            mpq_neg(product, product);
        if (!regular)
            break;
        mpq_mul(product, product, m[c * width + c]);
        for (int j = width - 1; j >= c; j--)
            mpq_div(m[c * width + j], m[c * width + j], m[c * width + c]);
        for (int i = 0; i < n; i++) {
            if (i == c)
                continue;
            mpq_neg(factor, m[i * width + c]);
            for (int j = c; j < width; j++)
                add_product(m[i * width + j], factor, m[c * width + j]);
        }
    }
    if (determinant) {
        if (!regular)
            mpq_set_ui(product, 0, 1);
        mpq_set(*determinant, product);
    }
    mpq_clear(factor);
    mpq_clear(product);
    return regular;
}

// Is x the double nearest to the value, of two the even one?
static int is_nearest(double x, const mpq_t value) {
    mpq_t here, there, bound;
    int right = 1;
    mpq_init(here);
    mpq_init(there);
    mpq_init(bound);
    mpq_set_ui(bound, 1, 1);
    mpz_mul_2exp(mpq_numref(bound), mpq_numref(bound), 54);
    mpz_sub_ui(mpq_numref(bound), mpq_numref(bound), 1);
    mpz_mul_2exp(mpq_numref(bound), mpq_numref(bound), 970); // halfway between the largest double and 2^1024
    mpq_abs(there, value);
    if (isinf(x)) {
        right = mpq_cmp(there, bound) >= 0 && mpq_sgn(value) == (x > 0 ? 1 : -1);
    } else if (mpq_cmp(there, bound) >= 0 || isnan(x)) {
        right = 0;
    } else {
        mpq_set_d(here, x);
        mpq_sub(here, here, value);
        mpq_abs(here, here);
        for (int side = -1; side <= 1; side += 2) {
            double next = nextafter(x, side * INFINITY);
            uint64_t bits;
            memcpy(&bits, &x, sizeof bits);
            if (isinf(next))
                continue;
            mpq_set_d(there, next);
            mpq_sub(there, there, value);
            mpq_abs(there, there);
            int order = mpq_cmp(here, there);
            right &= order < 0 || (order == 0 && bits % 2 == 0);
        }
    }
    mpq_clear(here);
    mpq_clear(there);
    mpq_clear(bound);
    return right && !(x == 0 && signbit(x));
}

// A sphere of some of a cell's vertices
typedef struct exact_sphere {
    mpq_t *centre, *bary; // [dim], [dim + 1]
    mpq_t radius2;
} exact_sphere;

static exact_sphere sphere_make(int dim) {
    exact_sphere s = {rationals(dim), rationals(dim + 1), {{{0, 0, NULL}, {0, 0, NULL}}}};
    mpq_init(s.radius2);
    return s;
}

static void sphere_free(exact_sphere *s, int dim) {
    rationals_free(s->centre, dim);
    rationals_free(s->bary, dim + 1);
    mpq_clear(s->radius2);
}

// The power of a place: |x - centre|^2 - radius^2 - weight
static void power_of(mpq_t power, const exact_sphere *s, int dim, mpq_t *x, double weight) {
    mpq_t t;
    mpq_init(t);
    mpq_set_d(power, weight);
    mpq_neg(power, power);
    mpq_sub(power, power, s->radius2);
    for (int j = 0; j < dim; j++) {
        mpq_sub(t, x[j], s->centre[j]);
        add_product(power, t, t);
    }
    mpq_clear(t);
}

// The unknowns are barycentric coordinates b and a number z: for each vertex i, sum b_j p_j . p_i = (|p_i|^2 - w_i + z)
// / 2. Returns 0 if the vertices are dependent.
static int sphere_of(exact_sphere *s, int dim, const double *const *points, const double *weights, unsigned vertices) {
    int v[MOST], n = 0, regular;
    for (int i = 0; i <= dim; i++)
        if (vertices >> i & 1)
            v[n++] = i;
    int size = n + 1, width = n + 2;
    mpq_t *m = rationals(size * width), *p = rationals(n * dim), t;
    mpq_init(t);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < dim; k++)
            mpq_set_d(p[i * dim + k], points[v[i]][k]);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            for (int k = 0; k < dim; k++)
                add_product(m[i * width + j], p[i * dim + k], p[j * dim + k]);
            mpq_add(m[i * width + j], m[i * width + j], m[i * width + j]);
        }
        mpq_set_si(m[i * width + n], -1, 1);
        for (int k = 0; k < dim; k++)
            add_product(m[i * width + n + 1], p[i * dim + k], p[i * dim + k]);
        mpq_set_d(t, weights ? weights[v[i]] : 0);
        mpq_sub(m[i * width + n + 1], m[i * width + n + 1], t);
        mpq_set_ui(m[n * width + i], 1, 1);
    }
    mpq_set_ui(m[n * width + n + 1], 1, 1);
    regular = solve(m, size, NULL);
    for (int i = 0; i <= dim; i++)
        mpq_set_ui(s->bary[i], 0, 1);
    for (int k = 0; k < dim; k++)
        mpq_set_ui(s->centre[k], 0, 1);
    for (int i = 0; i < n && regular; i++) {
        mpq_set(s->bary[v[i]], m[i * width + n + 1]);
        for (int k = 0; k < dim; k++)
            add_product(s->centre[k], m[i * width + n + 1], p[i * dim + k]);
    }
    mpq_set_ui(s->radius2, 0, 1);
    power_of(t, s, dim, p, weights ? weights[v[0]] : 0);
    mpq_set(s->radius2, t);
    mpq_clear(t);
    rationals_free(m, size * width);
    rationals_free(p, n * dim);
    return regular;
}

// --- cells

typedef struct simplex {
    int dim;
    double x[MOST][LARGEST_DIM], w[MOST];
    const double *p[MOST];
} simplex;

typedef enum kind { UNIT, LATTICE, SLIVER, FAR, SCALES, EXTREMES, FLAT, REGULAR, KINDS } kind;

static double any_double(uint64_t *random, int low, int high) {
    double x = 2 * random_unit(random) - 1;
    return ldexp(x, low + (int)(random_unit(random) * (high - low)));
}

static void simplex_of_kind(simplex *c, kind k, int dim, uint64_t *random) {
    memset(c, 0, sizeof *c);
    c->dim = dim;
    for (int i = 0; i <= dim; i++) {
        c->p[i] = c->x[i];
        for (int j = 0; j < dim; j++) {
            double x = random_unit(random);
            if (k == LATTICE || k == FLAT)
                x = floor(4 * x);
            if (k == SLIVER && j == dim - 1)
                x *= 1e-9;
            if (k == FAR)
                x += 1e6;
            if (k == SCALES)
                x = any_double(random, -40, 40);
            if (k == EXTREMES)
                x = any_double(random, -1070, 1024);
            if (k == FLAT && j == dim - 1)
                x = c->x[i][0];
            if (k == REGULAR)
                x = i == j;
            c->x[i][j] = x;
        }
        c->w[i] = k == EXTREMES  ? any_double(random, -1070, 1024)
                  : k == LATTICE ? floor(4 * random_unit(random))
                                 : random_unit(random) - 0.5;
    }
}

// Exchanges the vertices of places i and j.
static void exchange(simplex *c, int i, int j) {
    const double *p = c->p[i];
    double w = c->w[i];
    c->p[i] = c->p[j];
    c->p[j] = p;
    c->w[i] = c->w[j];
    c->w[j] = w;
}

static void fail_on_cell(const simplex *c, const char *what) {
    for (int i = 0; i <= c->dim; i++) {
        for (int j = 0; j < c->dim; j++)
            print_message("%a ", c->p[i][j]);
        print_message("| %a\n", c->w[i]);
    }
    fail_msg("%s", what);
}

static void expect_circumsphere(const simplex *c, const double *weights, exact_sphere *s) {
    double centre[LARGEST_DIM], radius2 = 0;
    int regular = sphere_of(s, c->dim, c->p, weights, (2u << c->dim) - 1), inside = regular;
    if (paradt_circumsphere(c->dim, c->p, weights, centre, &radius2) != regular)
        fail_on_cell(c, "paradt_circumsphere is wrong about whether the cell is flat");
    for (int j = 0; j < c->dim && regular; j++)
        if (!is_nearest(centre[j], s->centre[j]))
            fail_on_cell(c, "a circumcentre is not the nearest double");
    if (regular && !is_nearest(radius2, s->radius2))
        fail_on_cell(c, "a circumsphere's radius is not the nearest double");
    for (int i = 0; i <= c->dim; i++)
        inside &= mpq_sgn(s->bary[i]) >= 0;
    if (paradt_is_self_centred(c->dim, c->p, weights) != inside)
        fail_on_cell(c, "paradt_is_self_centred is wrong");
}

// The smallest of the spheres, of all sets of vertices, that have all vertices inside.
static void expect_enclosing_sphere(const simplex *c, exact_sphere *s, exact_sphere *best) {
    int dim = c->dim, found = 0;
    unsigned on = 0, all = (2u << dim) - 1;
    mpq_t power, *x = rationals(dim);
    mpq_init(power);
    for (unsigned vertices = 1; vertices <= all; vertices++) {
        unsigned touched = 0;
        int encloses = sphere_of(s, dim, c->p, NULL, vertices);
        for (int i = 0; i <= dim && encloses; i++) {
            for (int j = 0; j < dim; j++)
                mpq_set_d(x[j], c->p[i][j]);
            power_of(power, s, dim, x, 0);
            encloses = mpq_sgn(power) <= 0;
            touched |= (unsigned)(mpq_sgn(power) == 0) << i;
        }
        if (!encloses || (found && mpq_cmp(s->radius2, best->radius2) >= 0))
            continue;
        found = 1;
        on = touched;
        mpq_set(best->radius2, s->radius2);
        for (int j = 0; j < dim; j++)
            mpq_set(best->centre[j], s->centre[j]);
    }
    double centre[LARGEST_DIM], radius2;
    if (paradt_enclosing_sphere(dim, c->p, centre, &radius2) != on)
        fail_on_cell(c, "paradt_enclosing_sphere is wrong about which vertices are on the sphere");
    for (int j = 0; j < dim; j++)
        if (!is_nearest(centre[j], best->centre[j]))
            fail_on_cell(c, "an enclosing sphere's centre is not the nearest double");
    if (!is_nearest(radius2, best->radius2))
        fail_on_cell(c, "an enclosing sphere's radius is not the nearest double");
    mpq_clear(power);
    rationals_free(x, dim);
}

static void expect_volume(const simplex *c) {
    int dim = c->dim, width = dim + 1;
    mpq_t *m = rationals(dim * width), volume, t;
    mpq_init(volume);
    mpq_init(t);
    for (int i = 0; i < dim; i++)
        for (int j = 0; j < dim; j++) {
            mpq_set_d(m[i * width + j], c->p[i + 1][j]);
            mpq_set_d(t, c->p[0][j]);
            mpq_sub(m[i * width + j], m[i * width + j], t);
        }
    solve(m, dim, &volume);
    for (int i = 2; i <= dim; i++) {
        mpq_set_ui(t, (unsigned)i, 1);
        mpq_div(volume, volume, t);
    }
    if (!is_nearest(paradt_volume(dim, c->p), volume))
        fail_on_cell(c, "a volume is not the nearest double");
    mpq_clear(volume);
    mpq_clear(t);
    rationals_free(m, dim * width);
}

// state: dimension
static void numbers_are_those_of_rational_arithmetic(void **state) {
    int dim = (int)(intptr_t)*state;
    uint64_t random = (uint64_t)dim;
    exact_sphere s = sphere_make(dim), best = sphere_make(dim);
    for (int k = 0; k < KINDS; k++) {
        int extreme = k == EXTREMES, turns = (extreme ? 40 : 200) / (dim * dim * (dim > 5 ? 4 : 1)) / (SANITIZED ? 8 : 1) + 1;
        for (int turn = 0; turn < turns; turn++) {
            simplex c;
            simplex_of_kind(&c, (kind)k, dim, &random);
            expect_circumsphere(&c, NULL, &s);
            expect_circumsphere(&c, c.w, &s);
            expect_volume(&c);
            if (!extreme || dim <= 5)
                expect_enclosing_sphere(&c, &s, &best);
        }
    }
    sphere_free(&s, dim);
    sphere_free(&best, dim);
}

// Faces that two cells have in common are measured alike by both, so bits must not depend on the order.
static void the_order_of_the_vertices_changes_no_bit(void **state) {
    uint64_t random = 7;
    (void)state;
    for (int dim = 2; dim <= 5; dim++)
        for (int k = 0; k < KINDS; k++)
            for (int turn = 0; turn < 20; turn++) {
                simplex c;
                simplex_of_kind(&c, (kind)k, dim, &random);
                double centre[2][2 * LARGEST_DIM], radius2[2][2] = {{0, 0}, {0, 0}}, volume[2];
                memset(centre, 0, sizeof centre);
                for (int again = 0; again < 2; again++) {
                    paradt_circumsphere(dim, c.p, c.w, centre[again], &radius2[again][0]);
                    paradt_enclosing_sphere(dim, c.p, centre[again] + dim, &radius2[again][1]);
                    volume[again] = fabs(paradt_volume(dim, c.p));
                    exchange(&c, 0, dim);
                    exchange(&c, 1, dim);
                }
                if (memcmp(centre[0], centre[1], sizeof centre[0]) || memcmp(radius2[0], radius2[1], sizeof radius2[0]) ||
                    memcmp(&volume[0], &volume[1], sizeof volume[0]))
                    fail_on_cell(&c, "the order of the vertices changes a number");
            }
}

static void some_cells_are_known_by_heart(void **state) {
    static const double corner[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}},
                        far[3][2] = {{1e308, 0}, {-1e308, 0}, {0, 1e308}};
    static const double obtuse[3][2] = {{0, 0}, {4, 0}, {1, 1}}, point[3][2] = {{3, -0.0}, {3, 0}, {3, 0}};
    const double *p[4] = {corner[0], corner[1], corner[2], corner[3]};
    double centre[3], radius2;
    (void)state;
    assert_int_equal(paradt_circumsphere(3, p, NULL, centre, &radius2), 1);
    assert_true(centre[0] == 1 && centre[1] == 1 && centre[2] == 1 && radius2 == 3);
    assert_int_equal(paradt_is_self_centred(3, p, NULL), 0);
    assert_true(paradt_volume(3, p) == 4.0 / 3);
    assert_int_equal(paradt_enclosing_sphere(3, p, centre, &radius2), 14); // the triangle of the three others
    assert_true(centre[0] == 2.0 / 3 && centre[1] == 2.0 / 3 && radius2 == 8.0 / 3);
    for (int i = 0; i < 3; i++)
        p[i] = obtuse[i];
    assert_int_equal(paradt_enclosing_sphere(2, p, centre, &radius2), 3);
    assert_true(centre[0] == 2 && centre[1] == 0 && radius2 == 4);
    for (int i = 0; i < 3; i++)
        p[i] = point[i];
    assert_int_equal(paradt_enclosing_sphere(2, p, centre, &radius2), 7);
    assert_true(centre[0] == 3 && centre[1] == 0 && !signbit(centre[1]) && radius2 == 0);
    assert_int_equal(paradt_circumsphere(2, p, NULL, centre, &radius2), 0);
    assert_int_equal(paradt_is_self_centred(2, p, NULL), 0);
    assert_true(paradt_volume(2, p) == 0);
    for (int i = 0; i < 3; i++)
        p[i] = far[i];
    assert_int_equal(paradt_circumsphere(2, p, NULL, centre, &radius2), 1);
    assert_true(centre[0] == 0 && centre[1] == 0 && isinf(radius2) && isinf(paradt_volume(2, p)));
    assert_int_equal(paradt_enclosing_sphere(2, p, centre, &radius2), 7);
    assert_true(centre[0] == 0 && centre[1] == 0 && isinf(radius2));
    // A volume of (2^53 - 0.54) 2^971: the largest double is nearest.
    const double most[4][3] = {{0, 0, 0}, {ldexp(41, 400), 0, 0}, {0, ldexp(5272506880823995, 400), 0}, {0, 0, ldexp(1, 169)}};
    for (int i = 0; i < 4; i++)
        p[i] = most[i];
    assert_true(paradt_volume(3, p) == DBL_MAX);
}

// --- flips

// A triangulation as a list of cells, sorted rows of dim + 1 vertices
typedef struct flipped {
    const sample *s;
    int n, count, capacity;
    int *cells;
} flipped;

static int find_cell(const flipped *t, const int *row) {
    for (int i = 0; i < t->count; i++)
        if (memcmp(t->cells + i * t->n, row, (size_t)t->n * sizeof(int)) == 0)
            return i;
    return -1;
}

static const double *place(const flipped *t, int vertex) {
    return t->s->x + vertex * t->s->dim;
}

// Fills the cell of the points but for one.
static void all_but(const int *points, int count, int without, int *row) {
    for (int i = 0, n = 0; i < count; i++)
        if (i != without)
            row[n++] = points[i];
}

// Flips the cells of d + 2 points, if they are all there: one of the two triangulations of these points becomes the
// other. The sign of a point in their affine dependence is that of the orientation of the others, alternating. Flips
// that need fewer points, because some are in a plane of fewer dimensions, or lose a vertex are not made. Returns
// whether it flipped.
static int flip(flipped *t, const int *points) {
    int n = t->n, sign[MOST + 1], row[MOST], counts[2] = {0, 0}, there[2] = {0, 0};
    for (int i = 0; i <= n; i++) {
        const double *p[MOST];
        all_but(points, n + 1, i, row);
        for (int j = 0; j < n; j++)
            p[j] = place(t, row[j]);
        sign[i] = paradt_orient(n - 1, p) * (i % 2 ? -1 : 1);
        if (sign[i] == 0)
            return 0;
        counts[sign[i] > 0]++;
        there[sign[i] > 0] += find_cell(t, row) >= 0;
    }
    int from = there[1] > there[0];
    if (there[from] != counts[from] || counts[0] < 2 || counts[1] < 2)
        return 0;
    for (int i = 0; i <= n; i++) {
        all_but(points, n + 1, i, row);
        if ((sign[i] > 0) == from) {
            int at = find_cell(t, row);
            memcpy(t->cells + at * n, t->cells + --t->count * n, (size_t)n * sizeof(int));
        } else {
            if (t->count == t->capacity)
                fail_msg("more cells than there is room for");
            memcpy(t->cells + t->count++ * n, row, (size_t)n * sizeof(int));
        }
    }
    return 1;
}

// Tries to flip the points of two random neighbours.
static int flip_somewhere(flipped *t, uint64_t *random) {
    int n = t->n, a = (int)(random_unit(random) * t->count), without = (int)(random_unit(random) * n), points[MOST + 1];
    const int *row = t->cells + a * n;
    for (int i = 0; i < t->count; i++) {
        int common = 0, other = -1;
        for (int j = 0; j < n; j++) {
            int met = 0;
            for (int k = 0; k < n; k++)
                met |= k != without && row[k] == t->cells[i * n + j];
            common += met;
            other = met ? other : t->cells[i * n + j];
        }
        if (common < n - 1 || i == a)
            continue;
        memcpy(points, row, (size_t)n * sizeof(int));
        points[n] = other;
        qsort(points, (size_t)n + 1, sizeof(int), compare_ints);
        return flip(t, points);
    }
    return 0;
}

static flipped flipped_make(const sample *s) {
    enum { ROOM = 4000 };
    paradt_points points = points_of(s);
    paradt_triangulation t;
    flipped f = {s, s->dim + 1, 0, ROOM, NULL};
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    assert_int_equal(t.dim, s->dim);
    f.cells = (int *)need(ROOM * (size_t)f.n, sizeof(int));
    f.count = (int)t.cell_count;
    for (int i = 0; i < f.count * f.n; i++)
        f.cells[i] = (int)t.cells[i];
    for (int i = 0; i < f.count; i++)
        qsort(f.cells + i * f.n, (size_t)f.n, sizeof(int), compare_ints);
    paradt_free(&t);
    return f;
}

static void records_of(const flipped *t, int c, const double **p) {
    for (int j = 0; j < t->n; j++)
        p[j] = place(t, t->cells[c * t->n + j]);
}

// --- what the thesis proves

static double largest_enclosing(const flipped *t) {
    double largest = 0;
    for (int i = 0; i < t->count; i++) {
        const double *p[MOST];
        double centre[LARGEST_DIM], radius2;
        records_of(t, i, p);
        paradt_enclosing_sphere(t->n - 1, p, centre, &radius2);
        largest = fmax(largest, radius2);
    }
    return largest;
}

static int all_self_centred(const flipped *t) {
    for (int i = 0; i < t->count; i++) {
        const double *p[MOST];
        records_of(t, i, p);
        if (!paradt_is_self_centred(t->n - 1, p, NULL))
            return 0;
    }
    return 1;
}

// Is no point inside the sphere of a cell?
static int is_delaunay(const flipped *t) {
    for (int i = 0; i < t->count; i++) {
        const double *p[MOST + 1];
        records_of(t, i, p);
        int sign = paradt_orient(t->n - 1, p);
        for (int q = 0; q < t->s->count; q++) {
            p[t->n] = place(t, q);
            if (sign * paradt_insphere(t->n - 1, p, NULL) > 0)
                return 0;
        }
    }
    return 1;
}

// Sets the power of a place with regard to the sphere of a cell around it: of several they are equal.
static void power_in(mpq_t power, const flipped *t, mpq_t *x, const double *near_x) {
    int dim = t->n - 1;
    exact_sphere s = sphere_make(dim);
    int found = 0;
    for (int i = 0; i < t->count && !found; i++) {
        const double *p[MOST], *q[MOST];
        records_of(t, i, p);
        int sign = paradt_orient(dim, p);
        found = 1;
        for (int j = 0; j < t->n && found; j++) {
            memcpy(q, p, sizeof q);
            q[j] = near_x;
            found = sign * paradt_orient(dim, q) >= 0;
        }
        if (found) {
            sphere_of(&s, dim, p, NULL, (2u << dim) - 1);
            power_of(power, &s, dim, x, 0);
        }
    }
    if (!found)
        fail_on_sample(t->s, "a place within the hull is in no cell");
    sphere_free(&s, dim);
}

// A place in the hull: a mean of points that is a double, the exact one
static void expect_smallest_powers(const flipped *best, const flipped *other, uint64_t *random) {
    int dim = best->n - 1;
    mpq_t here, there, *x = rationals(dim);
    mpq_init(here);
    mpq_init(there);
    for (int turn = 0; turn < 5; turn++) {
        double near_x[LARGEST_DIM];
        const double *p[MOST];
        double total = 0, part[MOST];
        records_of(best, (int)(random_unit(random) * best->count), p);
        for (int i = 0; i <= dim; i++)
            total += part[i] = 0.05 + random_unit(random);
        for (int j = 0; j < dim; j++) {
            near_x[j] = 0;
            for (int i = 0; i <= dim; i++)
                near_x[j] += part[i] / total * p[i][j];
            mpq_set_d(x[j], near_x[j]);
        }
        power_in(here, best, x, near_x);
        power_in(there, other, x, near_x);
        if (mpq_cmp(here, there) < 0 || mpq_sgn(here) > 0)
            fail_on_sample(best->s, "a place has a smaller power in T(P) than in another triangulation");
    }
    mpq_clear(here);
    mpq_clear(there);
    rationals_free(x, dim);
}

static sample points_for_flips(const char *name, int dim, int count, uint64_t seed) {
    sample s = family_make(&families[family_named(strcmp(name, "triangles") ? name : "uniform")], NULL, dim, count, seed);
    if (strcmp(name, "triangles") == 0) { // nearly equilateral: all cells are self-centred
        enum { SIDE = 5 };
        for (int i = 0; i < s.count; i++) {
            s.x[2 * i] = i % SIDE + 0.5 * (i / SIDE % 2) + 0.02 * s.x[2 * i];
            s.x[2 * i + 1] = 0.866 * (i / SIDE) + 0.02 * s.x[2 * i + 1];
        }
    }
    return s;
}

static void no_triangulation_by_flips_is_better(void **state) {
    static const struct {
        const char *name;
        int dim, count;
    } sets[] = {{"uniform", 2, 20}, {"triangles", 2, 25}, {"lattice", 2, 16}, {"uniform", 3, 14},
                {"sphere", 3, 16},  {"lattice", 3, 27},   {"gauss", 4, 12},   {"uniform", 5, 11}};
    long flips = 0, self_centred = 0, others = 0, worse = 0;
    uint64_t random = 3;
    (void)state;
    for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++)
        for (uint64_t seed = 1; seed <= (SANITIZED ? 2 : 12); seed++) {
            sample s = points_for_flips(sets[i].name, sets[i].dim, sets[i].count, seed);
            flipped best = flipped_make(&s), t = flipped_make(&s);
            double bound = largest_enclosing(&best);
            for (int tried = 0, made = 0; tried < 800 && made < 40; tried++) {
                if (!flip_somewhere(&t, &random))
                    continue;
                made++;
                double largest = largest_enclosing(&t);
                if (largest < bound)
                    fail_on_sample(&s, "a triangulation has a smaller largest min-containment sphere than T(P)");
                worse += largest > bound;
                if (all_self_centred(&t)) {
                    self_centred++;
                    if (!is_delaunay(&t))
                        fail_on_sample(&s, "a triangulation of self-centred cells is not Delaunay");
                } else {
                    others += !is_delaunay(&t);
                }
                expect_smallest_powers(&best, &t, &random);
                flips++;
            }
            if (all_self_centred(&best))
                self_centred++;
            free(best.cells);
            free(t.cells);
            sample_free(&s);
        }
    print_message("# %ld flips, %ld triangulations of self-centred cells, %ld not Delaunay, %ld with larger spheres\n", flips,
                  self_centred, others, worse);
    assert_true(flips > 300 && self_centred > (SANITIZED ? 2 : 10) && others > 100 && worse > 100);
}

int main(void) {
    static struct CMUnitTest tests[LARGEST_DIM + 8];
    size_t count = 0;
    for (int dim = 2; dim <= LARGEST_DIM; dim++)
        tests[count++] = named_test(numbers_are_those_of_rational_arithmetic, (void *)(intptr_t)dim,
                                    "numbers are those of rational arithmetic, d = %d", dim);
    tests[count++] = named_test(the_order_of_the_vertices_changes_no_bit, NULL, "the order of the vertices changes no bit");
    tests[count++] = named_test(some_cells_are_known_by_heart, NULL, "some cells are known by heart");
    tests[count++] = named_test(no_triangulation_by_flips_is_better, NULL, "no triangulation by flips is better");
    return run_named_tests("optimality", tests, count);
}
