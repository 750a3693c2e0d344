// Verifies the arrays of a triangulation without using ParaDT's code: orientations by determinants of GMP integers, neighbours
// by sorting facets, representatives and statistics by counting. It does not verify that the cells are the right ones.
#ifndef VERIFY_H
#define VERIFY_H

#include "oracle.h"
#include "paradt.h"

typedef struct facet {
    int v[CELLS_MAX_DIM];
    size_t cell;
    int opposite;
} facet;

static inline int compare_facets(const void *a, const void *b) {
    const facet *p = (const facet *)a, *q = (const facet *)b;
    for (int i = 0; i < CELLS_MAX_DIM; i++)
        if (p->v[i] != q->v[i])
            return p->v[i] < q->v[i] ? -1 : 1;
    return 0;
}

// Returns the sign of the determinant of m[n][n] by fraction-free elimination (Bareiss), which overwrites m.
static inline int exact_determinant_sign(mpz_t *m, int n) {
    int sign = 1;
    for (int c = 0; c < n; c++) {
        int pivot = c;
        while (pivot < n && mpz_sgn(m[pivot * n + c]) == 0)
            pivot++;
        if (pivot == n)
            return 0;
        if (pivot != c) {
            sign = -sign;
            for (int j = 0; j < n; j++)
                mpz_swap(m[pivot * n + j], m[c * n + j]);
        }
        for (int i = c + 1; i < n; i++)
            for (int j = c + 1; j < n; j++) {
                mpz_mul(m[i * n + j], m[i * n + j], m[c * n + c]);
                mpz_submul(m[i * n + j], m[i * n + c], m[c * n + j]);
                if (c > 0)
                    mpz_divexact(m[i * n + j], m[i * n + j], m[(c - 1) * n + c - 1]);
            }
    }
    return n ? sign * mpz_sgn(m[n * n - 1]) : 1;
}

// Returns the orientation of k + 1 points projected on k axes: the sign of det(p[1] - p[0], ..., p[k] - p[0]).
static inline int exact_orientation(const exact_points *e, const paradt_index *vertices, int k, const int *axes,
                                    mpz_t *work) {
    for (int i = 0; i < k; i++)
        for (int j = 0; j < k; j++)
            mpz_sub(work[i * k + j], e->x[(int)vertices[i + 1] * e->dim + axes[j]],
                    e->x[(int)vertices[0] * e->dim + axes[j]]);
    return exact_determinant_sign(work, k);
}

// No cell may be flat, and all must have the same orientation, in full dimension the positive one.
static inline const char *verify_orientations(const paradt_triangulation *t, const exact_points *e, const int *axes) {
    int k = t->dim, n = k + 1, first = k == e->dim ? 1 : 0;
    mpz_t *work = mpz_array(k * k);
    const char *wrong = NULL;
    for (size_t c = 0; c < t->cell_count && k > 0 && !wrong; c++) {
        int sign = exact_orientation(e, t->cells + c * (size_t)n, k, axes, work);
        if (first == 0)
            first = sign;
        if (sign == 0)
            wrong = "a cell is flat";
        else if (sign != first)
            wrong = "a cell is oriented the wrong way";
    }
    mpz_array_free(work, k * k);
    return wrong;
}

static inline const char *verify_neighbors(const paradt_triangulation *t) {
    size_t n = (size_t)t->dim + 1, count = t->cell_count * n, hull = 0;
    facet *facets = (facet *)need(count, sizeof *facets);
    const char *wrong = NULL;
    for (size_t f = 0; f < count; f++) {
        size_t c = f / n, at = 0;
        for (size_t i = 0; i < n; i++)
            if (i != f % n)
                facets[f].v[at++] = (int)t->cells[c * n + i];
        qsort(facets[f].v, at, sizeof(int), compare_ints);
        facets[f].cell = c;
        facets[f].opposite = (int)(f % n);
    }
    if (count)
        qsort(facets, count, sizeof *facets, compare_facets);
    for (size_t f = 0; f < count && !wrong;) {
        size_t same = 1;
        while (f + same < count && compare_facets(&facets[f], &facets[f + same]) == 0)
            same++;
        hull += same == 1;
        if (same > 2)
            wrong = "a facet belongs to more than two cells";
        for (size_t i = 0; i < same && t->neighbors && !wrong; i++) {
            const facet *mine = &facets[f + i], *other = &facets[f + same - 1 - i];
            paradt_index neighbor = t->neighbors[mine->cell * n + (size_t)mine->opposite];
            if (neighbor != (same == 2 ? (paradt_index)other->cell : -1))
                wrong = "a neighbour is not the cell on the facet's other side";
        }
        f += same;
    }
    if (t->dim == 0) // a single vertex has no facets
        hull = 0;
    if (!wrong && t->dim == 0 && t->neighbors)
        wrong = "a single vertex has neighbours";
    if (!wrong && t->stats.hull_facets != hull)
        wrong = "stats.hull_facets is not the number of facets with one cell";
    free(facets);
    return wrong;
}

static inline const char *verify_records(const paradt_triangulation *t, const sample *s) {
    int *leader = (int *)need((size_t)s->count, sizeof(int)), *used = (int *)need((size_t)s->count, sizeof(int));
    size_t distinct = (size_t)sample_leaders(s, leader, NULL), hidden = 0;
    const char *wrong = NULL;
    for (size_t i = 0; i < t->cell_count * ((size_t)t->dim + 1) && !wrong; i++) {
        if (t->cells[i] < 0 || t->cells[i] >= s->count)
            wrong = "a vertex is no point";
        else if (leader[t->cells[i]] != t->cells[i])
            wrong = "a vertex does not stand for itself";
        else
            used[t->cells[i]] = 1;
    }
    for (int i = 0; i < s->count && !wrong; i++) {
        hidden += leader[i] == i && !used[i];
        if (t->representative[i] != (used[leader[i]] ? leader[i] : -1))
            wrong = "a representative is wrong";
        else if (!s->w && !used[leader[i]])
            wrong = "an unweighted point is no vertex";
    }
    if (!wrong && (t->stats.cells != t->cell_count || t->stats.hidden != hidden ||
                   t->stats.duplicates != (size_t)s->count - distinct))
        wrong = "stats.cells, .hidden or .duplicates is not what the arrays say";
    free(used);
    free(leader);
    return wrong;
}

// Returns NULL, or a sentence about the first fault found.
static inline const char *verify_triangulation(const paradt_triangulation *t, const sample *s) {
    int axes[CELLS_MAX_DIM], *all = (int *)need((size_t)s->count, sizeof(int));
    exact_points e = exact_make(s);
    const char *wrong = NULL;
    for (int i = 0; i < s->count; i++)
        all[i] = i;
    if (t->point_count != (size_t)s->count)
        wrong = "the point count is wrong";
    else if (t->dim != exact_affine_dim(&e, all, s->count, axes))
        wrong = "the affine dimension is wrong";
    else if (t->dim >= 0 && t->cell_count == 0)
        wrong = "there are points and no cells";
    if (!wrong)
        wrong = verify_records(t, s);
    if (!wrong)
        wrong = verify_orientations(t, &e, axes);
    if (!wrong)
        wrong = verify_neighbors(t);
    exact_free(&e);
    free(all);
    return wrong;
}

#endif
