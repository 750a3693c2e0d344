// paradt_locator and paradt_adjacency: every answer is compared with what exact arithmetic says of all points or cells.
#include "harness.h"

#include "runners.h"

enum { LARGEST_DIM = SANITIZED ? 3 : 5 };
static const int points_in[] = {0, 0, 60, 50, 30, 18, 14, 13, 13};
static const int few_points_in[] = {0, 0, 20, 14, 10, 9};

// A sample with its triangulation and locator, and places that are asked about, all of them as integers
typedef struct scene {
    sample s;
    paradt_points points;
    paradt_triangulation t;
    paradt_locator *locator;
    sample all; // the points, then the places
    int places;
    exact_points e; // of all
    int axes[CELLS_MAX_DIM];
    mpz_t *work, *adjugate, *b, *c, determinant, x, y;
} scene;

static const double *place_of(const scene *c, int place) { return c->all.x + (c->s.count + place) * c->s.dim; }

// Fills a place: a vertex, the middle of some vertices of a cell, anywhere in the box, outside of it, or beside a vertex.
static void choose_place(const scene *c, double *x, uint64_t *seed) {
    const int dim = c->s.dim, corners = c->t.dim + 1, kind = random_below(seed, 10);
    const double *p = c->s.x + random_below(seed, c->s.count) * dim;
    const double *q = c->s.x + random_below(seed, c->s.count) * dim;
    for (int k = 0; k < dim; k++)
        x[k] = p[k];
    if (kind < 5 && c->t.cell_count) {
        const paradt_index *row =
            c->t.cells + random_below(seed, (int)c->t.cell_count) * corners;
        int some = 1 + random_below(seed, corners);
        for (int k = 0; k < dim; k++) {
            x[k] = 0;
            for (int i = 0; i < some; i++)
                x[k] += c->s.x[row[i] * dim + k] / some;
        }
    } else if (kind == 5) {
        for (int k = 0; k < dim; k++)
            x[k] = p[k] + (q[k] - p[k]) * (2 * random_unit(seed) - 0.5);
    } else if (kind == 6) {
        for (int k = 0; k < dim; k++)
            x[k] = p[k] * (1 + 3 * random_unit(seed)) + (q[k] - p[k]) * random_gauss(seed);
    } else if (kind == 7) {
        int k = random_below(seed, dim);
        x[k] = nextafter(x[k], random_below(seed, 2) ? 1e308 : -1e308);
    } else if (kind == 8) {
        for (int k = 0; k < dim; k++)
            x[k] = 2 * p[k] - q[k];
    } else if (kind == 9) {
        for (int k = 0; k < dim; k++)
            x[k] = 0.5 * p[k] + 0.5 * q[k];
    }
    for (int k = 0; k < dim; k++)
        if (!isfinite(x[k]))
            x[k] = p[k];
}

// places: how many; radii: more of them, whose first coordinates are distances of the places before
static scene scene_make(const family *f, const weighting *w, int dim, int count, int places, unsigned flags,
                        uint64_t seed) {
    scene c;
    paradt_options options = {0};
    memset(&c, 0, sizeof c);
    options.flags = flags;
    c.s = family_make(f, w, dim, count, seed);
    c.points = points_of(&c.s);
    c.places = places;
    watch(&c.s, 60);
    assert_int_equal(paradt_triangulate(&c.t, &c.points, &options), PARADT_OK);
    assert_int_equal(paradt_locator_create(&c.locator, &c.t, &c.points, &options), PARADT_OK);
    c.all = sample_make(c.s.name, dim, c.s.count + places);
    memcpy(c.all.x, c.s.x, (size_t)(c.s.count * dim) * sizeof(double));
    if (c.s.w) {
        c.all.w = (double *)need((size_t)c.all.count, sizeof(double));
        memcpy(c.all.w, c.s.w, (size_t)c.s.count * sizeof(double));
    }
    for (int i = 0; i < places; i++)
        choose_place(&c, c.all.x + (c.s.count + i) * dim, &seed);
    return c;
}

// Makes the integers, when all places are there.
static void scene_prepare(scene *c) {
    int *order = (int *)need((size_t)c->s.count, sizeof(int)), n = c->t.dim + 1;
    c->e = exact_make(&c->all);
    for (int i = 0; i < c->s.count; i++)
        order[i] = i;
    assert_int_equal(exact_affine_dim(&c->e, order, c->s.count, c->axes), c->t.dim);
    free(order);
    c->work = mpz_array(2 * n * n + 1);
    c->adjugate = mpz_array(n * n + 1);
    c->b = mpz_array(n + 1);
    c->c = mpz_array(n + 1);
    mpz_inits(c->determinant, c->x, c->y, NULL);
}

static void scene_free(scene *c) {
    int n = c->t.dim + 1;
    watch(NULL, 0);
    if (c->work) {
        mpz_array_free(c->work, 2 * n * n + 1);
        mpz_array_free(c->adjugate, n * n + 1);
        mpz_array_free(c->b, n + 1);
        mpz_array_free(c->c, n + 1);
        mpz_clears(c->determinant, c->x, c->y, NULL);
        exact_free(&c->e);
    }
    paradt_locator_free(c->locator);
    paradt_free(&c->t);
    sample_free(&c->s);
    sample_free(&c->all);
}

// Fills b with the barycentric coordinates of a point of `all` in the cell whose adjugate is there, times |determinant|.
static void barycentric(scene *c, int n, int point, mpz_t *b) {
    for (int i = 0; i < n; i++) {
        mpz_set(b[i], c->adjugate[(n - 1) * n + i]);
        for (int k = 0; k < n - 1; k++)
            mpz_addmul(b[i], c->e.x[point * c->e.dim + c->axes[k]], c->adjugate[k * n + i]);
        if (mpz_sgn(c->determinant) < 0)
            mpz_neg(b[i], b[i]);
    }
}

// Prepares the cell for barycentric coordinates.
static void take_cell(scene *c, size_t number) {
    int corner[CELLS_MAX_DIM + 1], n = c->t.dim + 1;
    for (int i = 0; i < n; i++)
        corner[i] = (int)c->t.cells[number * (size_t)n + (size_t)i];
    assert_int_not_equal(exact_invert(&c->e, corner, n, c->axes, c->work, c->adjugate, c->determinant), 0);
}

// Is a point of `all` off the flat of the points? b: its coordinates in the cell that was taken
static int is_off_flat(scene *c, size_t number, int point, mpz_t *b) {
    int n = c->t.dim + 1, off = 0;
    for (int k = 0; k < c->e.dim; k++) {
        mpz_abs(c->x, c->determinant);
        mpz_mul(c->x, c->x, c->e.x[point * c->e.dim + k]);
        for (int i = 0; i < n; i++)
            mpz_submul(c->x, b[i], c->e.x[(int)c->t.cells[number * (size_t)n + (size_t)i] * c->e.dim + k]);
        off |= mpz_sgn(c->x) != 0;
    }
    return off;
}

// Returns what is wrong with the location of a place, or NULL.
static const char *location_fault(scene *c, int place, paradt_location found) {
    int n = c->t.dim + 1, off, seen = 0;
    if (!c->t.cell_count)
        return found.cell == -1 && !found.face ? NULL : "there are no cells, but one was found";
    if (found.cell < 0 || (size_t)found.cell >= c->t.cell_count)
        return "no cell was found";
    take_cell(c, (size_t)found.cell);
    barycentric(c, n, c->s.count + place, c->b);
    off = is_off_flat(c, (size_t)found.cell, c->s.count + place, c->b);
    for (int i = 0; i < n; i++)
        seen |= c->t.dim > 0 && c->t.neighbors[(size_t)found.cell * (size_t)n + (size_t)i] < 0 && mpz_sgn(c->b[i]) < 0;
    if (!found.face)
        return off || seen ? NULL : "a place inside was said to be outside";
    if (off)
        return "a place off the flat was said to be inside";
    for (int i = 0; i < n; i++)
        if (mpz_sgn(c->b[i]) != (int)(found.face >> i & 1))
            return "the face does not hold the place";
    return found.face >> n ? "the face has more vertices than the cell" : NULL;
}

// The sign of the power, or the distance, of a place to the point p less that to q; then the lexicographic order
static int compare_points(scene *c, int place, int p, int q, int weighted) {
    const int dim = c->e.dim;
    mpz_set_ui(c->y, 0);
    for (int k = 0; k < dim; k++) {
        mpz_sub(c->x, c->e.x[(c->s.count + place) * dim + k], c->e.x[p * dim + k]);
        mpz_addmul(c->y, c->x, c->x);
        mpz_sub(c->x, c->e.x[(c->s.count + place) * dim + k], c->e.x[q * dim + k]);
        mpz_submul(c->y, c->x, c->x);
    }
    for (int side = 0; side < 2 && weighted; side++) { // a weight is |x|^2 less the height
        int i = side ? q : p;
        mpz_set(c->x, c->e.height[i]);
        for (int k = 0; k < dim; k++)
            mpz_submul(c->x, c->e.x[i * dim + k], c->e.x[i * dim + k]);
        if (side) mpz_sub(c->y, c->y, c->x);
        else mpz_add(c->y, c->y, c->x);
    }
    if (mpz_sgn(c->y))
        return mpz_sgn(c->y);
    for (int k = 0; k < dim; k++) {
        int sign = mpz_cmp(c->e.x[p * dim + k], c->e.x[q * dim + k]);
        if (sign)
            return sign;
    }
    return 0;
}

// Fills order with the vertices, the nearest to the place first. Returns their number.
static int rank_vertices(scene *c, int place, int *order) {
    int count = 0;
    for (int i = 0; i < c->s.count; i++) {
        int at = count;
        if (c->t.representative[i] != i)
            continue;
        for (; at > 0 && compare_points(c, place, order[at - 1], i, 1) > 0; at--)
            order[at] = order[at - 1];
        order[at] = i;
        count++;
    }
    return count;
}

static void expect_locations(scene *c, const paradt_options *options) {
    paradt_location *found = (paradt_location *)need((size_t)c->places, sizeof *found);
    paradt_points queries = paradt_points_f64(c->all.x + c->s.count * c->s.dim, (size_t)c->places, c->s.dim);
    const char *fault;
    assert_int_equal(paradt_locate(c->locator, &queries, found, options), PARADT_OK);
    for (int i = 0; i < c->places; i++) {
        paradt_index hint = (paradt_index)(i % 3 ? (i * 7) % c->s.count : -1);
        if ((fault = location_fault(c, i, found[i])))
            fail_on_sample(&c->s, fault);
        if ((fault = location_fault(c, i, paradt_locate_one(c->locator, place_of(c, i), hint))))
            fail_on_sample(&c->s, fault);
    }
    free(found);
}

static void expect_nearest(scene *c, const paradt_options *options, paradt_work *work) {
    paradt_index *found = (paradt_index *)need((size_t)(c->places + c->s.count + 3), sizeof *found);
    int *order = (int *)need((size_t)c->s.count, sizeof *order);
    paradt_points queries = paradt_points_f64(c->all.x + c->s.count * c->s.dim, (size_t)c->places, c->s.dim);
    paradt_index *some = found + c->places;
    assert_int_equal(paradt_nearest(c->locator, &queries, found, options), PARADT_OK);
    for (int i = 0; i < c->places; i++) {
        int count = rank_vertices(c, i, order), most = i % 5 ? (i * 3) % (count + 2) : count + 3;
        paradt_index hint = (paradt_index)(i % 3 ? (i * 5) % c->s.count : -1);
        if (found[i] != (count ? order[0] : -1))
            fail_on_sample(&c->s, "a batch finds another nearest vertex");
        if (paradt_nearest_one(c->locator, place_of(c, i), hint) != found[i])
            fail_on_sample(&c->s, "one query finds another nearest vertex than a batch");
        assert_int_equal(paradt_nearest_some(c->locator, place_of(c, i), (size_t)most, some, work), PARADT_OK);
        for (int k = 0; k < most; k++)
            if (some[k] != (k < count ? order[k] : -1))
                fail_on_sample(&c->s, "the k nearest are others");
    }
    free(order);
    free(found);
}

// The last places are no places: their first coordinates are radii around those before.
static void choose_radii(scene *c) {
    for (int i = 0; i < c->places / 2; i++) {
        double *radius = c->all.x + (c->s.count + c->places - 1 - i) * c->s.dim, sum = 0;
        const double *x = place_of(c, i), *p = c->s.x + (i * 11) % c->s.count * c->s.dim;
        for (int k = 0; k < c->s.dim; k++)
            sum = hypot(sum, x[k] - p[k]);
        if (!isfinite(sum))
            sum = 1e308;
        for (int k = 0; k < c->s.dim; k++)
            radius[k] = 0;
        radius[0] = i % 7 ? sum : floor(sum);
    }
}

static void expect_within(scene *c, paradt_work *work) {
    paradt_index *found = (paradt_index *)need((size_t)c->s.count, sizeof *found);
    for (int i = 0; i < c->places / 2; i++) {
        const int dim = c->s.dim, radius = c->s.count + c->places - 1 - i;
        size_t capacity = (size_t)(i % 3 ? c->s.count : 2), count, expected = 0;
        assert_int_equal(paradt_within(c->locator, place_of(c, i), c->all.x[radius * dim], found, capacity, &count, work),
                         PARADT_OK);
        for (int p = 0; p < c->s.count; p++) {
            if (c->t.representative[p] != p)
                continue;
            mpz_mul(c->y, c->e.x[radius * dim], c->e.x[radius * dim]);
            for (int k = 0; k < dim; k++) {
                mpz_sub(c->x, c->e.x[(c->s.count + i) * dim + k], c->e.x[p * dim + k]);
                mpz_submul(c->y, c->x, c->x);
            }
            if (mpz_sgn(c->y) < 0)
                continue;
            if (expected < capacity && (expected >= count || found[expected] != p))
                fail_on_sample(&c->s, "the vertices in a ball are others");
            expected++;
        }
        if (expected != count)
            fail_on_sample(&c->s, "the number of vertices in a ball is another");
    }
    free(found);
}

// The part of a segment that is in a cell, as fractions of it
typedef struct stretch {
    mpq_t begin, end;
    int interior; // it runs in the interior
} stretch;

// Fills the part of the segment between two places that is in a cell. Returns whether it is more than one place.
static int stretch_in(scene *c, size_t number, int from, int to, stretch *part) {
    int n = c->t.dim + 1, empty = 0;
    mpq_t at;
    mpq_init(at);
    take_cell(c, number);
    barycentric(c, n, c->s.count + from, c->b);
    barycentric(c, n, c->s.count + to, c->c);
    empty = is_off_flat(c, number, c->s.count + from, c->b) || is_off_flat(c, number, c->s.count + to, c->c);
    mpq_set_ui(part->begin, 0, 1);
    mpq_set_ui(part->end, 1, 1);
    part->interior = 1;
    for (int i = 0; i < n; i++) {
        int b = mpz_sgn(c->b[i]), e = mpz_sgn(c->c[i]);
        if (!b && !e)
            part->interior = 0;
        empty |= b <= 0 && e <= 0 && (b || e);
        if (b * e >= 0)
            continue;
        mpz_sub(c->x, c->b[i], c->c[i]); // b + at (e - b) = 0
        mpq_set_num(at, c->b[i]);
        mpq_set_den(at, c->x);
        mpq_canonicalize(at);
        if (b < 0 && mpq_cmp(at, part->begin) > 0)
            mpq_set(part->begin, at);
        if (b > 0 && mpq_cmp(at, part->end) < 0)
            mpq_set(part->end, at);
    }
    mpq_clear(at);
    return !empty && mpq_cmp(part->begin, part->end) < 0;
}

// Returns what is wrong with the cells along a segment, or NULL.
static const char *along_fault(scene *c, int from, int to, const paradt_index *found, size_t count) {
    stretch part;
    const char *fault = NULL;
    char *listed = (char *)need(c->t.cell_count, 1);
    mpq_t at, first, last;
    int any = 0;
    mpq_inits(part.begin, part.end, at, first, last, NULL);
    for (size_t i = 0; i < count && !fault; i++) {
        if (found[i] < 0 || (size_t)found[i] >= c->t.cell_count || listed[found[i]])
            fault = "no cell, or one twice";
        else if (!stretch_in(c, (size_t)found[i], from, to, &part))
            fault = "the segment does not run in a cell that is listed";
        else if (i && mpq_cmp(at, part.begin) != 0)
            fault = "the cells are not in order, or leave a gap";
        if (fault)
            break;
        if (!i)
            mpq_set(first, part.begin);
        mpq_set(at, part.end);
        listed[found[i]] = 1;
    }
    mpq_set(last, at);
    for (size_t i = 0; i < c->t.cell_count && !fault; i++) {
        if (!stretch_in(c, i, from, to, &part))
            continue;
        any = 1;
        if (part.interior && !listed[i])
            fault = "a cell whose interior is met is not listed";
        else if (count && (mpq_cmp(part.begin, first) < 0 || mpq_cmp(part.end, last) > 0))
            fault = "the cells do not reach from end to end";
    }
    if (!fault && any && !count)
        fault = "no cell is listed";
    mpq_clears(part.begin, part.end, at, first, last, NULL);
    free(listed);
    return fault;
}

static void expect_along(scene *c, paradt_work *work) {
    paradt_index *found = (paradt_index *)need(c->t.cell_count, sizeof *found);
    for (int i = 0; i + 1 < c->places / 2 && c->t.dim > 0; i++) {
        size_t count;
        const char *fault;
        if (!memcmp(place_of(c, i), place_of(c, i + 1), (size_t)c->s.dim * sizeof(double)))
            continue;
        assert_int_equal(
            paradt_along(c->locator, place_of(c, i), place_of(c, i + 1), found, c->t.cell_count, &count, work), PARADT_OK);
        if (count > c->t.cell_count)
            fail_on_sample(&c->s, "more cells than there are");
        if ((fault = along_fault(c, i, i + 1, found, count)))
            fail_on_sample(&c->s, fault);
    }
    free(found);
}

static void expect_all(scene *c, paradt_work *work) {
    paradt_options options = {0};
    options.parallel_for = run_backwards;
    choose_radii(c);
    scene_prepare(c);
    expect_locations(c, NULL);
    expect_locations(c, &options);
    expect_nearest(c, NULL, work);
    expect_within(c, work);
    expect_along(c, work);
    scene_free(c);
}

// state: family
static void answers_are_those_of_exact_arithmetic(void **state) {
    int f = (int)(intptr_t)*state;
    paradt_work work = {0};
    for (int dim = 2; dim <= LARGEST_DIM; dim++)
        for (int w = 0; w < WEIGHTING_COUNT; w++) {
            int extremes = families[f].extremes || weightings[w].extremes;
            if (dim > 3 && (extremes || (f + dim + w) % 3))
                continue;
            scene c = scene_make(&families[f], &weightings[w], dim, extremes ? few_points_in[dim] : points_in[dim],
                                 SANITIZED ? 16 : 30, w % 2 ? PARADT_FACETS : 0, (uint64_t)(31 + f + 100 * w));
            expect_all(&c, &work);
        }
    paradt_work_free(&work);
}

static void so_they_are_in_six_to_eight_dimensions(void **state) {
    static const char *const names[] = {"uniform", "lattice", "hyperplane", "plane"};
    paradt_work work = {0};
    (void)state;
    for (int dim = 6; dim <= 8; dim++)
        for (int f = 0; f < 4; f++) {
            scene c = scene_make(&families[family_named(names[f])], f == 1 ? &weightings[1] : NULL, dim, points_in[dim], 16, 0,
                                 (uint64_t)(dim + f));
            expect_all(&c, &work);
        }
    paradt_work_free(&work);
}

// --- large sets, by other means

// Returns a vertex that is nearest by doubles, which is certain for random places.
static paradt_index nearest_by_doubles(const sample *s, const paradt_triangulation *t, const double *x) {
    paradt_index best = -1;
    double least = INFINITY;
    for (int i = 0; i < s->count; i++) {
        double sum = s->w ? -s->w[i] : 0;
        for (int k = 0; k < s->dim; k++)
            sum += (x[k] - s->x[i * s->dim + k]) * (x[k] - s->x[i * s->dim + k]);
        if (t->representative[i] == i && sum < least) {
            least = sum;
            best = (paradt_index)i;
        }
    }
    return best;
}

static void large_sets_are_searched_rightly(void **state) {
    static const char *const names[] = {"uniform", "plummer", "clusters", "sphere", "graded", "duplicates"};
    enum { POINTS = SANITIZED ? 3000 : 30000, PLACES = SANITIZED ? 60 : 300 };
    (void)state;
    for (int f = 0; f < 6; f++)
        for (int dim = 2; dim <= 3; dim++)
            for (int w = 0; w < 2; w++) {
                scene c = scene_make(&families[family_named(names[f])], &weightings[w], dim, POINTS, PLACES, 0, (uint64_t)f);
                paradt_points queries = paradt_points_f64(place_of(&c, 0), PLACES, dim);
                paradt_index found[PLACES];
                paradt_location located[PLACES];
                assert_int_equal(paradt_nearest(c.locator, &queries, found, NULL), PARADT_OK);
                assert_int_equal(paradt_locate(c.locator, &queries, located, NULL), PARADT_OK);
                for (int i = 0; i < PLACES; i++) {
                    const double *x = place_of(&c, i), *p[PARADT_MAX_DIM + 1];
                    paradt_index best = nearest_by_doubles(&c.s, &c.t, x);
                    double difference = 0, size = 0;
                    int outside = 0;
                    for (int k = 0; k < dim; k++) {
                        double a = x[k] - c.s.x[best * dim + k], b = x[k] - c.s.x[found[i] * dim + k];
                        difference += a * a - b * b;
                        size += a * a + b * b;
                    }
                    if (c.s.w) {
                        difference -= c.s.w[best] - c.s.w[found[i]];
                        size += fabs(c.s.w[best]) + fabs(c.s.w[found[i]]);
                    }
                    assert_true(fabs(difference) <= 1e-13 * size);
                    for (int j = 0; j <= dim; j++) {
                        const paradt_index *row = c.t.cells + located[i].cell * (dim + 1);
                        for (int v = 0; v <= dim; v++)
                            p[v] = v == j ? x : c.s.x + row[v] * dim;
                        int side = paradt_orient(dim, p);
                        if (located[i].face)
                            assert_int_equal(side, (int)(located[i].face >> j & 1));
                        else
                            outside |= side < 0 && c.t.neighbors[located[i].cell * (dim + 1) + j] < 0;
                    }
                    assert_true(located[i].face || outside);
                }
                scene_free(&c);
            }
}

// --- adjacency

static void expect_adjacency(const sample *s, const paradt_triangulation *t) {
    int n = t->dim + 1, count = s->count;
    char *joined = (char *)need((size_t)(count * count), 1);
    size_t edges = 0, at;
    paradt_adjacency a;
    for (size_t c = 0; c < t->cell_count; c++)
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                joined[t->cells[c * (size_t)n + (size_t)i] * count + t->cells[c * (size_t)n + (size_t)j]] = 1;
    assert_int_equal(paradt_adjacency_compute(&a, t, PARADT_VERTEX_CELLS, NULL), PARADT_OK);
    assert_int_equal(a.count, t->point_count);
    for (int v = 0; v < count; v++) {
        at = a.first[v];
        for (size_t c = 0; c < t->cell_count; c++)
            for (int i = 0; i < n; i++)
                if (t->cells[c * (size_t)n + (size_t)i] == v) {
                    assert_true(at < a.first[v + 1]);
                    assert_int_equal(a.items[at++], c);
                }
        assert_int_equal(at, a.first[v + 1]);
    }
    paradt_adjacency_free(&a);
    assert_int_equal(paradt_adjacency_compute(&a, t, PARADT_VERTEX_VERTICES, NULL), PARADT_OK);
    assert_int_equal(a.count, t->point_count);
    for (int v = 0; v < count; v++) {
        at = a.first[v];
        for (int u = 0; u < count; u++)
            if (u != v && joined[v * count + u]) {
                assert_true(at < a.first[v + 1]);
                assert_int_equal(a.items[at++], u);
                edges += u > v;
            }
        assert_int_equal(at, a.first[v + 1]);
    }
    paradt_adjacency_free(&a);
    assert_int_equal(paradt_adjacency_compute(&a, t, PARADT_EDGES, NULL), PARADT_OK);
    assert_int_equal(a.count, edges);
    for (size_t e = 0; e < edges; e++) {
        assert_int_equal(a.first[e], 2 * e);
        assert_true(a.items[2 * e] < a.items[2 * e + 1] && joined[a.items[2 * e] * count + a.items[2 * e + 1]]);
        assert_true(!e || a.items[2 * e - 2] < a.items[2 * e] ||
                    (a.items[2 * e - 2] == a.items[2 * e] && a.items[2 * e - 1] < a.items[2 * e + 1]));
    }
    assert_int_equal(a.first[edges], 2 * edges);
    paradt_adjacency_free(&a);
    paradt_adjacency_free(NULL);
    free(joined);
}

static void adjacency_is_what_the_cells_say(void **state) {
    (void)state;
    for (int f = 0; f < FAMILY_COUNT; f++)
        for (int dim = 2; dim <= 4; dim++)
            for (int w = 0; w < 2; w++) {
                sample s = family_make(&families[f], &weightings[w], dim, points_in[dim], (uint64_t)f);
                paradt_points points = points_of(&s);
                paradt_options options = {0};
                paradt_triangulation t;
                options.flags = w ? PARADT_NO_NEIGHBORS : 0;
                assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
                expect_adjacency(&s, &t);
                paradt_free(&t);
                sample_free(&s);
            }
}

static void adjacency_of_a_bad_index_is_invalid(void **state) {
    sample s = family_make(&families[0], NULL, 3, 20, 1);
    paradt_points points = points_of(&s);
    paradt_triangulation t;
    paradt_adjacency a;
    (void)state;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_adjacency_compute(NULL, &t, PARADT_EDGES, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_adjacency_compute(&a, NULL, PARADT_EDGES, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_adjacency_compute(&a, &t, (paradt_adjacent)3, NULL), PARADT_ERROR_ARGUMENT);
    for (int bad = 0; bad < 2; bad++) {
        t.cells[5] = bad ? -1 : 20;
        for (int what = 0; what < 3; what++) {
            assert_int_equal(paradt_adjacency_compute(&a, &t, (paradt_adjacent)what, NULL), PARADT_ERROR_INVALID);
            assert_true(!a.first && !a.items && !a.count);
        }
    }
    paradt_free(&t);
    sample_free(&s);
}

// --- manners

static void few_points_are_no_exception(void **state) {
    const double x[3][3] = {{1, 2, 3}, {1, 2, 3}, {3, 2, 3}}, far[3] = {9, 9, 9}, middle[3] = {2, 2, 3};
    paradt_work work = {0};
    (void)state;
    for (size_t count = 0; count <= 3; count++) {
        paradt_points points = paradt_points_f64(x[0], count, 3), queries = paradt_points_f64(far, 1, 3);
        paradt_triangulation t;
        paradt_locator *locator;
        paradt_location location, one;
        paradt_index nearest, some[2];
        size_t found;
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
        assert_int_equal(paradt_locate(locator, &queries, &location, NULL), PARADT_OK);
        assert_int_equal(paradt_nearest(locator, &queries, &nearest, NULL), PARADT_OK);
        one = paradt_locate_one(locator, far, -1);
        assert_int_equal(location.cell, count ? 0 : -1);
        assert_int_equal(one.cell, location.cell);
        assert_int_equal(location.face | one.face, 0);
        assert_int_equal(nearest, count == 3 ? 2 : count ? 0 : -1);
        assert_int_equal(paradt_nearest_one(locator, far, 1), nearest);
        assert_int_equal(paradt_nearest_some(locator, far, 2, some, &work), PARADT_OK);
        assert_int_equal(some[0], nearest);
        assert_int_equal(some[1], count == 3 ? 0 : -1);
        one = paradt_locate_one(locator, x[0], -1);
        assert_int_equal(one.face != 0, count > 0);
        assert_int_equal(paradt_within(locator, x[0], INFINITY, NULL, 0, &found, &work), PARADT_OK);
        assert_int_equal(found, count == 3 ? 2 : count ? 1 : 0);
        assert_int_equal(paradt_within(locator, x[0], -1, NULL, 0, &found, &work), PARADT_OK);
        assert_int_equal(found, 0);
        assert_int_equal(paradt_within(locator, x[0], 0, some, 1, &found, &work), PARADT_OK);
        assert_int_equal(found, count ? 1 : 0);
        assert_int_equal(paradt_along(locator, x[0], middle, some, 1, &found, &work), PARADT_OK);
        assert_int_equal(found, count == 3 ? 1 : 0);
        assert_int_equal(paradt_along(locator, x[0], x[0], some, 1, &found, &work), PARADT_OK);
        assert_int_equal(found, count ? 1 : 0);
        paradt_locator_free(locator);
        paradt_free(&t);
    }
    paradt_work_free(&work);
    paradt_work_free(&work);
    paradt_work_free(NULL);
    paradt_locator_free(NULL);
}

static void floats_and_strides_are_read(void **state) {
    enum { COUNT = 500 };
    sample s = family_make(&families[0], NULL, 3, COUNT, 3);
    struct {
        float x[3];
        int other;
    } queries[COUNT];
    double wide[COUNT][3];
    paradt_points points = points_of(&s), narrow = paradt_points_f32(queries[0].x, COUNT, 3);
    paradt_points same = paradt_points_f64(wide[0], COUNT, 3);
    paradt_location a[COUNT], b[COUNT];
    paradt_triangulation t;
    paradt_locator *locator;
    (void)state;
    for (int i = 0; i < COUNT; i++)
        for (int k = 0; k < 3; k++) {
            queries[i].x[k] = (float)(s.x[(i * 3 + k + 1) % (3 * COUNT)] - (i % 2) * 0.25);
            wide[i][k] = queries[i].x[k];
        }
    narrow.stride = sizeof queries[0];
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_locate(locator, &narrow, a, NULL), PARADT_OK);
    assert_int_equal(paradt_locate(locator, &same, b, NULL), PARADT_OK);
    assert_memory_equal(a, b, sizeof a);
    paradt_locator_free(locator);
    paradt_free(&t);
    sample_free(&s);
}

static void queries_that_are_not_finite_are_named(void **state) {
    sample s = family_make(&families[0], NULL, 3, 100, 3);
    double x[5][3] = {{0.5, 0.5, 0.5}, {0.1, 0.2, 0.3}, {0.5, NAN, 0.5}, {INFINITY, 0, 0}, {0.4, 0.4, 0.4}};
    paradt_points points = points_of(&s), queries = paradt_points_f64(x[0], 5, 3);
    paradt_location located[5];
    paradt_index nearest[5], some[3];
    paradt_triangulation t;
    paradt_locator *locator;
    paradt_work work = {0};
    size_t count;
    (void)state;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
    located[2].cell = nearest[2] = 7;
    assert_int_equal(paradt_locate(locator, &queries, located, NULL), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(paradt_nearest(locator, &queries, nearest, NULL), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(located[2].cell, -1);
    assert_int_equal(nearest[2], -1);
    assert_int_equal(paradt_locate_one(locator, x[2], 0).cell, -1);
    assert_int_equal(paradt_nearest_one(locator, x[3], 0), -1);
    assert_int_equal(paradt_nearest_some(locator, x[2], 3, some, &work), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(paradt_within(locator, x[2], 1, NULL, 0, &count, &work), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(paradt_within(locator, x[0], NAN, NULL, 0, &count, &work), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(paradt_along(locator, x[0], x[3], NULL, 0, &count, &work), PARADT_ERROR_NOT_FINITE);
    paradt_work_free(&work);
    paradt_locator_free(locator);
    s.x[200] = NAN;
    assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_ERROR_NOT_FINITE);
    assert_null(locator);
    paradt_free(&t);
    sample_free(&s);
}

static void wrong_arguments_are_refused(void **state) {
    sample s = family_make(&families[0], NULL, 3, 100, 3);
    paradt_points points = points_of(&s), fewer = points, plane = points, empty = points;
    paradt_options options = {0};
    paradt_triangulation t, bare;
    paradt_locator *locator;
    paradt_location location;
    paradt_work work = {0};
    paradt_index some[1];
    size_t count;
    (void)state;
    fewer.count = 99;
    plane.dim = 2;
    empty.count = 0;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    options.flags = PARADT_NO_NEIGHBORS;
    assert_int_equal(paradt_triangulate(&bare, &points, &options), PARADT_OK);
    assert_int_equal(paradt_locator_create(NULL, &t, &points, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locator_create(&locator, NULL, &points, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locator_create(&locator, &t, NULL, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locator_create(&locator, &t, &fewer, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locator_create(&locator, &t, &plane, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locator_create(&locator, &t, &points, &options), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locator_create(&locator, &bare, &points, NULL), PARADT_ERROR_ARGUMENT);
    assert_null(locator);
    assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_locate(NULL, &points, &location, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locate(locator, NULL, &location, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locate(locator, &plane, &location, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locate(locator, &points, NULL, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locate(locator, &empty, NULL, NULL), PARADT_OK);
    assert_int_equal(paradt_nearest_some(locator, s.x, 1, NULL, &work), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_nearest_some(locator, s.x, 1, some, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_within(locator, s.x, 1, NULL, 1, &count, &work), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_within(locator, s.x, 1, some, 1, NULL, &work), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_along(locator, s.x, NULL, some, 1, &count, &work), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_locate_one(NULL, s.x, -1).cell, -1);
    assert_int_equal(paradt_nearest_one(locator, NULL, -1), -1);
    paradt_locator_free(locator);
    paradt_free(&bare);
    paradt_free(&t);
    sample_free(&s);
}

// What is no triangulation, of points that are at one place, or on a line
static void wrong_cells_of_flat_sets_are_invalid(void **state) {
    static const double x[] = {1, 1, 1, 1, 2, 2, 4, 4};
    (void)state;
    for (size_t count = 2; count <= 4; count += 2) {
        paradt_points points = paradt_points_f64(x, count, 2);
        paradt_triangulation t;
        paradt_locator *locator;
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        assert_int_equal(t.dim, count == 2 ? 0 : 1);
        assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
        paradt_locator_free(locator);
        t.cells[0] = t.dim ? t.cells[1] : 2;
        assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_ERROR_INVALID);
        assert_null(locator);
        paradt_free(&t);
    }
}

// The points that have gone from a living set need not be finite.
static void gaps_of_a_living_set_are_passed_over(void **state) {
    sample s = family_make(&families[0], NULL, 3, 100, 3);
    paradt_points points = points_of(&s);
    paradt_triangulation t;
    paradt_dynamic *d;
    paradt_locator *locator;
    (void)state;
    assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
    for (paradt_index id = 0; id < 100; id += 9) {
        assert_int_equal(paradt_dynamic_remove(d, id), PARADT_OK);
        s.x[3 * id] = NAN;
    }
    assert_int_equal(paradt_dynamic_export(d, &t), PARADT_OK);
    assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
    for (paradt_index id = 0; id < 100; id++)
        if (id % 9)
            assert_int_equal(paradt_nearest_one(locator, s.x + 3 * id, -1), id);
    paradt_locator_free(locator);
    paradt_free(&t);
    paradt_dynamic_free(d);
    sample_free(&s);
}

// Whatever the arrays hold: an error or a locator, and queries that end
static void bad_arrays_are_invalid_or_harmless(void **state) {
    sample s = family_make(&families[0], NULL, 3, 200, 3);
    paradt_points points = points_of(&s);
    paradt_work work = {0};
    uint64_t seed = 5;
    (void)state;
    watch(&s, 60);
    for (int round = 0; round < (SANITIZED ? 300 : 2000); round++) {
        paradt_options options = {0};
        paradt_triangulation t;
        paradt_locator *locator;
        options.flags = round % 2 ? PARADT_FACETS : 0;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        for (int i = 0; i <= round % 3; i++) {
            size_t at = random_bits(&seed) % (4 * t.cell_count);
            paradt_index *items = random_below(&seed, 2) ? t.cells : t.neighbors;
            items[at] = random_below(&seed, 2) ? items[random_bits(&seed) % (4 * t.cell_count)]
                                               : (paradt_index)random_below(&seed, 3000) - 3;
        }
        paradt_status status = paradt_locator_create(&locator, &t, &points, &options);
        assert_true(status == PARADT_OK || status == PARADT_ERROR_INVALID);
        for (int i = 0; i < 20 && !status; i++) {
            size_t count;
            const double *a = s.x + 3 * random_below(&seed, 200), *b = s.x + 3 * random_below(&seed, 200);
            paradt_locate_one(locator, a, (paradt_index)i);
            paradt_nearest_one(locator, b, -1);
            assert_int_equal(paradt_along(locator, a, b, NULL, 0, &count, &work), PARADT_OK);
        }
        paradt_locator_free(locator);
        paradt_free(&t);
    }
    // points that have moved since: the cells overlap, and walks must not go in circles
    for (int round = 0; round < 100; round++) {
        paradt_triangulation t;
        paradt_locator *locator;
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        for (int i = 0; i < 600; i++)
            s.x[i] = random_unit(&seed);
        assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
        for (int i = 0; i < 100; i++) {
            paradt_location l = paradt_locate_one(locator, s.x + 3 * random_below(&seed, 200), -1);
            assert_true(l.cell >= -1 && l.cell < (paradt_index)t.cell_count);
        }
        paradt_locator_free(locator);
        paradt_free(&t);
    }
    watch(NULL, 0);
    paradt_work_free(&work);
    sample_free(&s);
}

// An allocator that fails at one call, and counts what is not freed
typedef struct purse {
    int calls, fail_at, live;
} purse;

static void *purse_alloc(void *user, size_t size) {
    purse *p = (purse *)user;
    if (++p->calls == p->fail_at)
        return NULL;
    p->live++;
    return malloc(size);
}

static void purse_free(void *user, void *memory) {
    ((purse *)user)->live--;
    free(memory);
}

// One of the calls that allocate, by number; -1: there are no more
static int run_step(int step, const sample *s, const paradt_triangulation *t, paradt_locator **locator,
                    const paradt_options *options, paradt_work *work) {
    paradt_points points = points_of(s);
    paradt_location located[300];
    paradt_index found[300];
    paradt_adjacency a;
    size_t count;
    int status = -1;
    if (step == 0) {
        paradt_locator *second;
        status = paradt_locator_create(&second, t, &points, options);
        assert_true(!status == (second != NULL));
        paradt_locator_free(second);
    } else if (step == 1) {
        status = paradt_locate(*locator, &points, located, options);
    } else if (step == 2) {
        status = paradt_nearest(*locator, &points, found, options);
    } else if (step < 6) {
        status = paradt_adjacency_compute(&a, t, (paradt_adjacent)(step - 3), options);
        paradt_adjacency_free(&a);
    } else if (step == 6) {
        status = paradt_nearest_some(*locator, s->x, 200, found, work);
    } else if (step == 7) {
        status = paradt_within(*locator, s->x, 0.5, found, 300, &count, work);
    } else if (step == 8) {
        status = paradt_along(*locator, s->x, s->x + s->dim, found, 300, &count, work);
    }
    return status;
}

static void any_allocation_may_fail(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int w = 0; w < 2; w++) {
            sample s = family_make(&families[family_named("uniform")], &weightings[w], dim, 300, 7);
            paradt_points points = points_of(&s);
            paradt_options options = {0};
            paradt_triangulation t;
            paradt_locator *locator;
            purse p = {0, 0, 0};
            options.allocator.alloc = purse_alloc;
            options.allocator.free = purse_free;
            options.allocator.user = &p;
            assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
            assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
            for (int step = 0; step < 9; step++) {
                int refused = 1;
                for (int at = 1; refused; at++) {
                    paradt_work work = {0};
                    work.allocator = options.allocator;
                    p.calls = 0;
                    p.fail_at = at;
                    int status = run_step(step, &s, &t, &locator, &options, &work);
                    refused = p.calls >= at;
                    assert_int_equal(status, refused ? PARADT_ERROR_MEMORY : PARADT_OK);
                    p.fail_at = 0;
                    assert_int_equal(run_step(step, &s, &t, &locator, &options, &work), PARADT_OK);
                    paradt_work_free(&work);
                    assert_int_equal(p.live, 0);
                }
            }
            options.allocator.user = NULL;
            memset(&options.allocator, 0, sizeof options.allocator);
            options.memory_limit = 20000;
            assert_int_equal(run_step(0, &s, &t, &locator, &options, NULL), PARADT_ERROR_MEMORY);
            paradt_locator_free(locator);
            paradt_free(&t);
            sample_free(&s);
        }
}

static int cancel_after(void *user, double fraction) {
    assert_true(fraction >= 0.0 && fraction <= 1.0);
    return --*(int *)user <= 0;
}

static void any_call_of_progress_may_cancel(void **state) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 300, 4);
    paradt_points points = points_of(&s);
    paradt_options options = {0};
    paradt_triangulation t;
    paradt_locator *locator;
    (void)state;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
    options.progress = cancel_after;
    for (int step = 0; step < 3; step++)
        for (int at = 1, status = PARADT_ERROR_CANCELLED; status; at++) {
            int calls = at;
            options.user = &calls;
            status = run_step(step, &s, &t, &locator, &options, NULL);
            assert_true(status == PARADT_OK || status == PARADT_ERROR_CANCELLED);
            assert_true(status || at > 3);
        }
    paradt_locator_free(locator);
    paradt_free(&t);
    sample_free(&s);
}

// What one of several threads does with a locator
typedef struct asker {
    const paradt_locator *locator;
    const sample *s;
    int from, wrong;
    const paradt_index *nearest;
    const paradt_location *located;
} asker;

static int bits_of(unsigned face) {
    int count = 0;
    for (; face; face &= face - 1)
        count++;
    return count;
}

static void *ask(void *argument) {
    asker *a = (asker *)argument;
    paradt_work work = {0};
    paradt_points points = points_of(a->s);
    paradt_index *found = (paradt_index *)need((size_t)a->s->count, sizeof *found);
    size_t count;
    for (int k = 0; k < a->s->count; k++) {
        int i = (k + a->from) % a->s->count;
        double x[3] = {a->s->x[3 * i] + 0.001, a->s->x[3 * i + 1], a->s->x[3 * i + 2] * 1.5};
        a->wrong += paradt_nearest_one(a->locator, x, -1) != a->nearest[i];
        a->wrong += bits_of(paradt_locate_one(a->locator, x, -1).face) != bits_of(a->located[i].face);
        a->wrong += paradt_nearest_some(a->locator, x, 5, found, &work) || found[0] != a->nearest[i];
        a->wrong += paradt_within(a->locator, x, 0.05, found, 10, &count, &work) != PARADT_OK;
        a->wrong += paradt_along(a->locator, x, a->s->x, found, 10, &count, &work) != PARADT_OK;
    }
    a->wrong += paradt_nearest(a->locator, &points, found, NULL) != PARADT_OK;
    paradt_work_free(&work);
    free(found);
    return NULL;
}

static void threads_ask_one_locator_at_once(void **state) {
    enum { THREADS = 4, COUNT = 1000 };
    sample s = family_make(&families[family_named("lattice")], NULL, 3, COUNT, 4);
    paradt_points points = points_of(&s), queries;
    paradt_options options = {0};
    paradt_triangulation t;
    paradt_locator *locator;
    paradt_index nearest[COUNT];
    paradt_location located[COUNT];
    double x[COUNT][3];
    asker askers[THREADS];
    pthread_t threads[THREADS];
    (void)state;
    for (int i = 0; i < s.count; i++) {
        x[i][0] = s.x[3 * i] + 0.001;
        x[i][1] = s.x[3 * i + 1];
        x[i][2] = s.x[3 * i + 2] * 1.5;
    }
    queries = paradt_points_f64(x[0], (size_t)s.count, 3);
    options.parallel_for = run_on_threads;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_locator_create(&locator, &t, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_nearest(locator, &queries, nearest, &options), PARADT_OK);
    assert_int_equal(paradt_locate(locator, &queries, located, &options), PARADT_OK);
    for (int i = 0; i < THREADS; i++) {
        asker a = {locator, &s, i * 100, 0, nearest, located};
        askers[i] = a;
        assert_int_equal(pthread_create(&threads[i], NULL, ask, &askers[i]), 0);
    }
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        assert_int_equal(askers[i].wrong, 0);
    }
    paradt_locator_free(locator);
    paradt_free(&t);
    sample_free(&s);
}

int main(void) {
    static struct CMUnitTest tests[FAMILY_COUNT];
    static const struct CMUnitTest races[] = {cmocka_unit_test(threads_ask_one_locator_at_once)};
    static const struct CMUnitTest others[] = {
        cmocka_unit_test(so_they_are_in_six_to_eight_dimensions),
        cmocka_unit_test(large_sets_are_searched_rightly),
        cmocka_unit_test(adjacency_is_what_the_cells_say),
        cmocka_unit_test(adjacency_of_a_bad_index_is_invalid),
        cmocka_unit_test(few_points_are_no_exception),
        cmocka_unit_test(floats_and_strides_are_read),
        cmocka_unit_test(queries_that_are_not_finite_are_named),
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(wrong_cells_of_flat_sets_are_invalid),
        cmocka_unit_test(gaps_of_a_living_set_are_passed_over),
        cmocka_unit_test(bad_arrays_are_invalid_or_harmless),
        cmocka_unit_test(any_allocation_may_fail),
        cmocka_unit_test(any_call_of_progress_may_cancel),
        cmocka_unit_test(threads_ask_one_locator_at_once),
    };
    if (RACES_ONLY)
        return cmocka_run_group_tests(races, NULL, NULL);
    for (int f = 0; f < FAMILY_COUNT; f++) {
        tests[f].name = families[f].name;
        tests[f].test_func = answers_are_those_of_exact_arithmetic;
        tests[f].initial_state = (void *)(intptr_t)f;
    }
    return cmocka_run_group_tests(tests, NULL, NULL) + cmocka_run_group_tests(others, NULL, NULL);
}
