// The checks of tests/claims.h, behind the implementation: exact values, and what they tell of a claim.
#ifndef CLAIMS_EXACT_H
#define CLAIMS_EXACT_H

#include "claims.h"

// Numbers to compute with, initialized when they are first needed
static dyadic *claim_number(int i) {
    static dyadic numbers[16];
    static int ready;
    for (; ready < 16; ready++)
        dy_init(&numbers[ready]);
    return &numbers[i];
}

// --- predicates

static void claim_determinant_of_kind(int kind, const paradt__space *s, const double *const *row, const double *base,
                                      int n, int k, int d, int weighted, double value, double largest,
                                      const paradt__bounds *b) {
    dyadic *det = claim_number(0), *error = claim_number(1);
    dy_rows(det, row, base, n, k, d, weighted);
    if (n > k && k % 2)
        mpz_neg(det->m, det->m);
    if (dy_sign(det) && b->quantum > 0) {
        dy_set(error, b->quantum);
        mpz_abs(claim_number(2)->m, det->m);
        claim_number(2)->e = det->e;
        if (dy_compare(claim_number(2), error) < 0)
            claim_broken(kind, "a determinant is less than its quantum", 0);
    }
    dy_set(error, value);
    dy_add(error, error, det, -1);
    claim_ratio(kind, error, largest > 0 ? paradt__filter_error(s, largest, b) : b->certain, NULL);
}

// largest: 0: the bound is that of the set
static void claim_determinant(const paradt__space *s, const double *const *row, const double *base, int n, int k, int d,
                              int weighted, double value, double largest, const paradt__bounds *b) {
    int kind = (n > k ? INSPHERE : ORIENT) + (largest > 0 ? 0 : (int)SET_ORIENT) + k;
    claim_determinant_of_kind(kind, s, row, base, n, k, d, weighted, value, largest, b);
}

static void claim_monomials(const paradt__space *s, const double *const *row, const double *base, int n, int k, int d,
                            int weighted, double value, double largest, const paradt__bounds *b) {
    claim_determinant_of_kind(MONOMIALS, s, row, base, n, k, d, weighted, value, largest, b);
}

// --- kept spheres

// *numerator / *denominator = the power of x with regard to the sphere of p[0..k], with coordinates and weights in records
static void claim_true_power(dyadic *numerator, dyadic *denominator, const double *const *p, const double *x, int k,
                             int d, int weighted) {
    dy_rows(denominator, p + 1, p[0], k, k, d, 0);
    dy_rows(numerator, p, x, k + 1, k, d, weighted);
    if (k % 2 == 0)
        mpz_neg(numerator->m, numerator->m);
}

static void claim_power_of(const paradt__kept *kept, int weighted, const paradt__sphere *sphere, const double *const *p,
                           int ghost, const double *x, double value) {
    const int k = kept->corners - 1;
    const paradt__centred seen = paradt__centred_of(kept, x);
    const double bound = paradt__kept_error(sphere, &seen, paradt__kept_is_near(kept, kept->corners));
    dyadic *a = claim_number(3), *b = claim_number(4), *error = claim_number(5), *t = claim_number(6);
    if (ghost < 0) {
        claim_true_power(a, b, p, x, k, k, weighted);
        dy_set(error, value);
        dy_mul(error, error, b);
        dy_add(error, error, a, -1);
        claim_ratio((k == 3 ? SPHERE_POWER : CIRCLE_POWER) + (int)kept->making, error, bound, b);
        return;
    }
    // p: the facet's vertices such that (p, x) is positively oriented for x beyond. The function is -t N (x - p).
    if (bound >= 0x1p499)
        return;
    {
        const double *edge[3];
        edge[0] = p[1], edge[1] = k == 3 ? p[2] : x, edge[2] = x;
        dy_rows(a, edge, p[0], k, k, k, 0);
    }
    if (fabs(value) > bound)
        claim_decision(k == 3 ? GHOST_SPACE : GHOST_PLANE, (value < 0 ? 1 : -1) == dy_sign(a));
    if (!(claim_steepness > 0))
        return;
    dy_set(t, claim_steepness);
    dy_mul(t, t, a);
    dy_difference(error, value, claim_lift);
    dy_add(error, error, t, 1);
    claim_ratio(k == 3 ? GHOST_SPACE : GHOST_PLANE, error, bound, NULL);
}

static void claim_power(const paradt__insertion *build, const paradt__sphere *sphere, size_t cell, const double *x,
                        double value) {
    const paradt__scene *scene = &build->scene;
    const int corners = build->kept->corners;
    const paradt_index *row = scene->mesh.vertices + cell * (size_t)corners;
    const double *p[4];
    int ghost, count = 0;
    if ((sphere->tag & ~PARADT__IN_CAVITY) != (paradt__tag)cell)
        return; // another cell's
    ghost = paradt__ghost_place(row, corners);
    for (int i = 0; i < corners; i++) {
        int place = ghost < 0 ? i : corners == 4 ? paradt__facet_order[ghost][i % 3] : (ghost + 1 + i) % 3;
        if (ghost >= 0 && i == corners - 1)
            break;
        p[count++] = paradt__scene_record(scene, row[place]);
    }
    claim_power_of(build->kept, scene->space.weighted, sphere, p, ghost, x, value);
}

static void claim_powers(const paradt__insertion *build, const paradt__sphere *table, size_t mask,
                         const paradt_index *links, const double *x, const double *values) {
    for (int i = 0; i < 4; i++) {
        size_t cell = (size_t)links[i] >> 2;
        claim_power(build, table + (cell & mask), cell, x, values[i]);
    }
}

static void claim_sides(const paradt__scene *scene, const paradt_index *row, const double *x, const double *values,
                        double certain, int corners) {
    for (int i = 0; i < corners; i++) {
        const double *p[4];
        dyadic *det = claim_number(3), *error = claim_number(5);
        for (int j = 0; j < corners; j++)
            p[j] = j == i ? x : paradt__scene_record(scene, row[j]);
        dy_rows(det, p + 1, p[0], corners - 1, corners - 1, corners - 1, 0);
        dy_set(error, values[i]);
        dy_add(error, error, det, -1);
        claim_ratio(SIDES, error, certain, NULL);
    }
}

static void claim_look(const paradt__insertion *build, const paradt_index *bases, const paradt_index *asked,
                       unsigned found) {
    const paradt__scene *scene = &build->scene;
    paradt__space space = scene->space;
    for (int lane = 0; lane < PARADT__TOGETHER; lane++) {
        const double *p[5];
        if (!(found >> lane & 1))
            continue;
        for (int i = 0; i < 4; i++)
            p[i] = paradt__scene_record(scene, scene->mesh.vertices[bases[lane] + i]);
        claim_decision(LOOK, paradt__exact_orient(&space, p) > 0);
        for (int i = 0; i < 4; i++) {
            const paradt_index vertex = asked[4 * lane + i];
            const int within = (int)(found >> (4 + 4 * lane + i) & 1);
            if (vertex == scene->mesh.vertices[bases[lane] + i])
                continue;
            p[4] = paradt__scene_record(scene, vertex);
            claim_decision(LOOK, (paradt__exact_insphere(&space, p) > 0) == within);
        }
    }
}

// --- the search

static void claim_search(const paradt__search *s, const double *x, double f, double f_bound, double n, double n_bound) {
    paradt__pencil pencil = s->pencil;
    const paradt__space *space = &pencil.space;
    const int k = space->dim, d = space->ambient;
    const double *p[PARADT_MAX_DIM + 1];
    dyadic *a = claim_number(3), *b = claim_number(4), *error = claim_number(5);
    int outside;
    for (int i = 0; i < k; i++)
        p[i] = pencil.corners[i];
    p[k] = x;
    dy_rows(b, p + 1, p[0], k, k, d, 0);
    outside = dy_sign(b) * pencil.outside > 0;
    if (s->aim != PARADT__AIM_CONFLICT) {
        if (n < -n_bound)
            claim_decision(SEARCH_SIDE, !outside);
        else if (n > n_bound)
            claim_decision(SEARCH_SIDE, outside);
        if (!pencil.certain && n_bound < PARADT__NO_BOUND) {
            // The true N is normal . v times v . u, v the unit vector perpendicular to the facet.
            dyadic *along = claim_number(7), *square = claim_number(8), *t = claim_number(9);
            dyadic v[PARADT_MAX_DIM];
            dy_set(along, 0);
            dy_set(square, 0);
            for (int j = 0; j < k; j++) { // the cofactors of the last row
                double other[PARADT_MAX_DIM][PARADT_MAX_DIM - 1];
                const double *q[PARADT_MAX_DIM];
                for (int i = 0; i < k; i++) {
                    for (int c = 0, l = 0; c < k; c++)
                        if (c != j)
                            other[i][l++] = p[i][c];
                    q[i] = other[i];
                }
                dy_init(&v[j]);
                dy_rows(&v[j], q + 1, q[0], k - 1, k - 1, k - 1, 0);
                if ((k - 1 + j) % 2)
                    mpz_neg(v[j].m, v[j].m);
                dy_mul(t, &v[j], &v[j]);
                dy_add(square, square, t, 1);
                dy_set(t, pencil.q.normal[j]);
                dy_mul(t, t, &v[j]);
                dy_add(along, along, t, 1);
                dy_clear(&v[j]);
            }
            dy_mul(along, along, b);
            dy_set(error, n);
            dy_mul(error, error, square);
            dy_add(error, error, along, -1);
            claim_ratio(SEARCH_N, error, n_bound + pencil.q.n_floor, square);
        }
    }
    if (s->apex < 0 || (s->aim != PARADT__AIM_CONFLICT && !outside))
        return;
    p[k] = pencil.corners[k];
    claim_true_power(a, b, p, x, k, d, space->weighted);
    if (f > f_bound)
        claim_decision(SEARCH_SIDE, dy_sign(a) * dy_sign(b) > 0);
    if (pencil.limit)
        return;
    if (f < -f_bound)
        claim_decision(SEARCH_SIDE, dy_sign(a) * dy_sign(b) < 0);
    dy_set(error, f);
    dy_mul(error, error, b);
    dy_add(error, error, a, -1);
    claim_ratio(SEARCH_F, error, f_bound, b);
}

// The boxes or points of some lanes, `span` points each, are out of the question.
static void claim_lanes(const paradt__search *s, size_t first, size_t span, unsigned out) {
    for (int lane = 0; lane < PARADT__LANES; lane++) {
        if (!(out >> lane & 1))
            continue;
        for (size_t at = first + (size_t)lane * span; at < first + ((size_t)lane + 1) * span; at++) {
            paradt__pencil pencil = s->pencil;
            const double *x;
            int known = at < s->begin || at >= s->end || at >= s->set->count || (paradt_index)at == s->apex;
            for (int i = 0; i < pencil.space.dim; i++)
                known |= (paradt_index)at == s->facet[i];
            if (known)
                continue;
            x = paradt__record(s->set, at);
            if (s->aim != PARADT__AIM_CONFLICT && !paradt__pencil_is_outside(&pencil, x))
                claim_decision(RULED_OUT, 1);
            else
                claim_decision(RULED_OUT, s->aim != PARADT__AIM_BEYOND && s->apex >= 0 &&
                                              !paradt__pencil_is_inside(&pencil, x));
        }
    }
}

// --- planes

static void claim_plane_of(const paradt__planes *f, const double *const *p, int corners, const paradt__plane *plane,
                           const double *x, double value, int terms) {
    const int k = f->dim, d = f->ambient;
    dyadic *a = claim_number(3), *b = claim_number(4), *error = claim_number(5);
    if (corners == k + 1) {
        claim_true_power(a, b, p, x, k, d, f->weighted);
        if (plane->factor[d] < 0)
            mpz_neg(a->m, a->m);
        dy_set(error, value);
        dy_mul(error, error, b);
        dy_add(error, error, a, -1);
        claim_ratio(PLANE_CELL, error, plane->error, b);
    } else {
        int axis = -1, units = 0;
        const double *q[PARADT_MAX_DIM];
        double without[PARADT_MAX_DIM][PARADT_MAX_DIM];
        for (int j = 0; j < k; j++)
            if (fabs(plane->factor[j]) == 1)
                axis = j, units++;
        if (units != 1)
            return; // not known which factor is 1 by definition
        for (int i = 0; i < k; i++) {
            int n = 0;
            for (int j = 0; j < k; j++)
                if (j != axis)
                    without[i][n++] = p[i][j];
            q[i] = without[i];
        }
        dy_set(b, 1);
        if (k > 1)
            dy_rows(b, q + 1, q[0], k - 1, k - 1, k - 1, 0);
        for (int i = 0; i < k; i++)
            q[i] = i + 1 < k ? p[i + 1] : x;
        dy_rows(a, q, p[0], k, k, k, 0);
        dy_set(error, f->scale[axis] * plane->factor[axis] * ((k - 1 + axis) % 2 ? -1 : 1));
        dy_mul(a, a, error);
        dy_set(error, value);
        dy_mul(error, error, b);
        dy_add(error, error, a, -1);
        claim_ratio(terms == k ? PLANE_FACET : PLANE_GHOST, error, plane->error, b);
    }
}

static void claim_plane(const paradt__graph *g, const paradt_index *row, const paradt__plane *plane, const double *x,
                        double value, int terms) {
    const int k = g->planes.dim;
    paradt__space space = g->set->space;
    const double *p[PARADT_MAX_DIM + 1];
    int count = 0;
    if (!g->rows || plane->error >= 0x1p499)
        return;
    for (int i = 0; i < g->mesh.corners; i++)
        if (row[i] != PARADT__INFINITE && count < (terms == k ? k : k + 1))
            p[count++] = paradt__record(g->set, row[i]);
    claim_plane_of(&g->planes, p, count, plane, x, value, terms);
    if (fabs(value) > plane->error)
        claim_decision(PLANE_SIDE, paradt__graph_decide(g, &space, row, x) == (value < 0));
}

// --- queries, hulls and diagrams

static void claim_distance(const paradt__scene *scene, const double *x, const double *p, int ambient, int weighted,
                           double value, double bound) {
    dyadic *sum = claim_number(3), *t = claim_number(4);
    if (!scene->space.bounded)
        return; // not used
    dy_set(sum, 0);
    for (int j = 0; j < ambient; j++) {
        dy_difference(t, x[j], p[j]);
        dy_mul(t, t, t);
        dy_add(sum, sum, t, 1);
    }
    if (weighted) {
        dy_set(t, p[ambient]);
        dy_add(sum, sum, t, -1);
    }
    dy_set(t, value);
    dy_add(t, t, sum, -1);
    claim_ratio(DISTANCE, t, bound, NULL);
}

static void claim_lean(const double *v, const double *x, const double *w, double value, double bound) {
    dyadic *dot = claim_number(3), *square = claim_number(4), *a = claim_number(5), *t = claim_number(6);
    dy_set(dot, 0);
    dy_set(square, 0);
    for (int j = 0; j < 3; j++) {
        dy_difference(a, w[j], v[j]);
        dy_difference(t, x[j], v[j]);
        dy_mul(t, t, a);
        dy_add(dot, dot, t, 1);
        dy_mul(a, a, a);
        dy_add(square, square, a, 1);
    }
    dy_set(t, value);
    dy_mul(t, t, square);
    dy_add(t, t, dot, -1);
    claim_ratio(LEAN, t, bound, square);
}

// y: the centre of a cell relative to its first vertex, and the bound
static void claim_meet(const paradt__diagram *g, const paradt_index *vertices, const double *y, int d) {
    static dyadic a[DY_MOST][DY_MOST], row[DY_MOST], side[DY_MOST];
    static int ready;
    dyadic *det = claim_number(3), *numerator = claim_number(4), *error = claim_number(5), *t = claim_number(6);
    const double *base = paradt__diagram_point(g, vertices[0]);
    if (!(y[d] < 0x1p499))
        return;
    for (int i = 0; i < DY_MOST && !ready; i++) {
        for (int j = 0; j < DY_MOST; j++)
            dy_init(&a[i][j]);
        dy_init(&row[i]);
        dy_init(&side[i]);
    }
    ready = 1;
    for (int i = 0; i < d; i++) {
        const double *x = paradt__diagram_point(g, vertices[i + 1]);
        dy_set(&side[i], 0);
        for (int j = 0; j < d; j++) {
            dy_difference(&a[i][j], x[j], base[j]);
            dy_mul(t, &a[i][j], &a[i][j]);
            dy_add(&side[i], &side[i], t, 1);
        }
        if (g->weighted) {
            dy_difference(t, x[d], base[d]);
            dy_add(&side[i], &side[i], t, -1);
        }
        side[i].e--; // half of it
    }
    dy_determinant(det, a, d);
    for (int j = 0; j < d; j++) {
        for (int i = 0; i < d; i++) {
            dy_copy(&row[i], &a[i][j]);
            dy_copy(&a[i][j], &side[i]);
        }
        dy_determinant(numerator, a, d);
        for (int i = 0; i < d; i++)
            dy_copy(&a[i][j], &row[i]);
        dy_set(error, y[j]);
        dy_mul(error, error, det);
        dy_add(error, error, numerator, -1);
        claim_ratio(CENTRE, error, y[d], det);
    }
}

static void claim_corner(paradt__convex *c, const paradt__halfspace *const *h, const double *y, int distant) {
    const int d = c->g->d;
    double exact[PARADT_MAX_DIM + 1];
    for (int far = 0; far <= distant; far++, y += d + 1) {
        if (!(y[d] < 0x1p499))
            continue;
        paradt__exact_meet(&c->exact, c->g, c->p, h, far, 0, exact);
        for (int j = 0; j < d; j++) {
            dyadic *error = claim_number(5);
            dy_difference(error, y[j], exact[j]);
            claim_ratio(CORNER, error, y[d] + exact[d], NULL);
        }
    }
}

static void claim_above(paradt__convex *c, size_t vertex, const paradt__halfspace *plane, int sign) {
    const paradt__halfspace *h[PARADT_MAX_DIM + 1];
    const int d = c->g->d;
    if (sign == PARADT__UNDECIDED)
        return;
    for (int i = 0; i < d; i++)
        h[i] = paradt__convex_plane(c, vertex, i);
    h[d] = plane;
    claim_decision(ABOVE, paradt__exact_above(&c->exact, c->g, c->p, h) == sign);
}

static void claim_minors(const double *const *x, const double *scale, const paradt__minors_table *table, int d) {
    const unsigned all = (1u << d) - 1;
    for (int left = 0; left < d; left++) {
        dyadic *det = claim_number(3), *t = claim_number(4);
        const double *row[PARADT_MAX_DIM];
        double memory[PARADT_MAX_DIM][PARADT_MAX_DIM];
        dyadic *factor = claim_number(5);
        dy_set(factor, 1);
        for (int i = 0; i < d; i++) {
            int n = 0;
            for (int j = 0; j < d; j++)
                if (j != left)
                    memory[i][n++] = x[i][j];
            row[i] = memory[i];
        }
        for (int j = 0; j < d; j++) {
            dy_set(t, scale[j]);
            if (j != left)
                dy_mul(factor, factor, t);
        }
        dy_set(det, 1);
        if (d > 1)
            dy_rows(det, row + 1, row[0], d - 1, d - 1, d - 1, 0);
        dy_mul(det, det, factor);
        dy_set(t, table->minor[all ^ 1u << left]);
        dy_add(t, t, det, -1);
        claim_ratio(MINORS, t, paradt__minors_factor(d - 1) * table->size[all ^ 1u << left], NULL);
    }
}

// *sum = |x - o|^2
static void claim_square(dyadic *sum, const double *x, const double *o, int d) {
    dyadic *t = claim_number(6);
    dy_set(sum, 0);
    for (int j = 0; j < d; j++) {
        dy_difference(t, x[j], o[j]);
        dy_mul(t, t, t);
        dy_add(sum, sum, t, 1);
    }
}

// Differences of sagittas, as the radius is not kept
static void claim_sagittas(const paradt__set *set) {
    const int d = set->space.ambient;
    dyadic *first = claim_number(3), *square = claim_number(4), *error = claim_number(5);
    const double *base = set->records;
    claim_square(first, base, set->centre, d);
    for (size_t i = 1; i < set->count; i++) {
        const double *x = set->records + i * set->width;
        claim_square(square, x, set->centre, d);
        dy_difference(error, x[d], base[d]);
        dy_add(error, error, square, 1);
        dy_add(error, error, first, -1);
        claim_ratio(SAGITTAS, error, 2 * set->grade_error, NULL);
        if (fabs(x[d]) > set->grade_limit)
            claim_broken(SAGITTAS, "a sagitta exceeds the limit", 0);
    }
}

#endif
