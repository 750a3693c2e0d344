// The definition itself as an oracle: computes T(P) by testing every (k+1)-subset of the points against every other point in
// GMP integers. It uses neither orientation nor in-sphere determinants. Let b[i] be the barycentric coordinates of q in the
// cell: q = sum b[i] p[i], sum b[i] = 1. With the heights h(x) = |x|^2 - w + e(x), q lies below the cell's lifted hyperplane
// exactly when h(q) - sum b[i] h(p[i]) < 0. If this difference is 0 without the e, its sign is that of the largest e whose
// coefficient is not 0; e(q) has the coefficient 1, e(p[i]) has -b[i]. Barycentric coordinates are the same in every
// projection that keeps the dimension of the affine hull, so points of affine dimension k < d need no rule of their own.
#ifndef ORACLE_H
#define ORACLE_H

#include "cells.h"

#include <gmp.h>
#include <math.h>

// The points as integers: coordinates are scaled by a power of two, heights by its square.
typedef struct exact_points {
    int dim, count;
    mpz_t *x;      // [count][dim]
    mpz_t *height; // [count]: |x|^2 - w
} exact_points;

// value != 0
static inline int exponent_of_lowest_bit(double value) {
    int exponent;
    uint64_t mantissa = (uint64_t)ldexp(frexp(fabs(value), &exponent), 53);
    exponent -= 53;
    while (mantissa % 2 == 0) {
        mantissa /= 2;
        exponent++;
    }
    return exponent;
}

// Sets z to value * 2^shift, which must be an integer.
static inline void mpz_set_scaled(mpz_t z, double value, int shift) {
    int exponent;
    double mantissa = ldexp(frexp(value, &exponent), 53);
    exponent += shift - 53;
    mpz_set_d(z, mantissa);
    if (exponent >= 0)
        mpz_mul_2exp(z, z, (mp_bitcnt_t)exponent);
    else
        mpz_tdiv_q_2exp(z, z, (mp_bitcnt_t)-exponent);
}

static inline mpz_t *mpz_array(int count) {
    mpz_t *z = (mpz_t *)need((size_t)count, sizeof(mpz_t));
    for (int i = 0; i < count; i++)
        mpz_init(z[i]);
    return z;
}

static inline void mpz_array_free(mpz_t *z, int count) {
    for (int i = 0; i < count; i++)
        mpz_clear(z[i]);
    free(z);
}

static inline exact_points exact_make(const sample *s) {
    exact_points e = {s->dim, s->count, mpz_array(s->count * s->dim), mpz_array(s->count)};
    int lowest = 1024;
    for (int i = 0; i < s->count * s->dim; i++)
        if (s->x[i] != 0 && exponent_of_lowest_bit(s->x[i]) < lowest)
            lowest = exponent_of_lowest_bit(s->x[i]);
    for (int i = 0; s->w && i < s->count; i++)
        if (s->w[i] != 0 && exponent_of_lowest_bit(s->w[i]) < 2 * lowest)
            lowest = (exponent_of_lowest_bit(s->w[i]) - 1) / 2;
    for (int i = 0; i < s->count; i++) {
        for (int k = 0; k < s->dim; k++) {
            mpz_set_scaled(e.x[i * s->dim + k], s->x[i * s->dim + k], -lowest);
            mpz_addmul(e.height[i], e.x[i * s->dim + k], e.x[i * s->dim + k]);
        }
        if (s->w) {
            mpz_t weight;
            mpz_init(weight);
            mpz_set_scaled(weight, s->w[i], -2 * lowest);
            mpz_sub(e.height[i], e.height[i], weight);
            mpz_clear(weight);
        }
    }
    return e;
}

static inline void exact_free(exact_points *e) {
    mpz_array_free(e->x, e->count * e->dim);
    mpz_array_free(e->height, e->count);
}

// Returns the affine dimension k of the listed points, -1 without points. Fills axes[0..k-1] with coordinate axes on which the
// points can be projected without losing dimensions.
static inline int exact_affine_dim(const exact_points *e, const int *points, int count, int *axes) {
    int d = e->dim, rank = 0;
    mpz_t *basis = mpz_array(d * d), *row = mpz_array(d), t;
    mpz_init(t);
    for (int i = 1; i < count && rank < d; i++) {
        for (int k = 0; k < d; k++)
            mpz_sub(row[k], e->x[points[i] * d + k], e->x[points[0] * d + k]);
        // Once a basis row has been used, its axis is zero in this row and stays zero.
        for (int r = 0; r < rank; r++) {
            mpz_set(t, row[axes[r]]);
            for (int k = 0; k < d; k++) {
                mpz_mul(row[k], row[k], basis[r * d + axes[r]]);
                mpz_submul(row[k], t, basis[r * d + k]);
            }
        }
        for (int k = 0; k < d; k++)
            if (mpz_sgn(row[k]) != 0) {
                for (int j = 0; j < d; j++)
                    mpz_set(basis[rank * d + j], row[j]);
                axes[rank++] = k;
                break;
            }
    }
    mpz_clear(t);
    mpz_array_free(row, d);
    mpz_array_free(basis, d * d);
    qsort(axes, (size_t)rank, sizeof(int), compare_ints); // ascending, so that a projection on all axes keeps orientations
    return count == 0 ? -1 : rank;
}

// M is the matrix of the rows (x projected on the axes, 1) of n = k + 1 points. Computes its determinant and its adjugate,
// inverse * determinant, by fraction-free Gauss-Jordan elimination (Bareiss), in which every division is exact. Returns the
// sign of the determinant.
static inline int exact_invert(const exact_points *e, const int *points, int n, const int *axes, mpz_t *work,
                               mpz_t *adjugate, mpz_t determinant) {
    int width = 2 * n, sign = 1;
    mpz_t previous, t;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < width; j++)
            if (j < n - 1)
                mpz_set(work[i * width + j], e->x[points[i] * e->dim + axes[j]]);
            else
                mpz_set_si(work[i * width + j], j == n - 1 || j - n == i);
    mpz_init_set_ui(previous, 1);
    mpz_init(t);
    for (int c = 0; c < n && sign; c++) {
        int pivot = c;
        while (pivot < n && mpz_sgn(work[pivot * width + c]) == 0)
            pivot++;
        if (pivot == n) {
            sign = 0;
            break;
        }
        if (pivot != c)
            for (int j = 0; j < width; j++)
                mpz_swap(work[pivot * width + j], work[c * width + j]);
        for (int i = 0; i < n; i++) {
            if (i == c)
                continue;
            mpz_set(t, work[i * width + c]);
            for (int j = 0; j < width; j++) {
                mpz_mul(work[i * width + j], work[i * width + j], work[c * width + c]);
                mpz_submul(work[i * width + j], t, work[c * width + j]);
                mpz_divexact(work[i * width + j], work[i * width + j], previous);
            }
        }
        mpz_set(previous, work[c * width + c]);
    }
    if (sign) {
        // All diagonal entries now equal the determinant, up to the sign of the row exchanges. The right half has the same
        // sign, so the quotient of the two is the inverse.
        mpz_set(determinant, previous);
        sign = mpz_sgn(determinant);
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                mpz_set(adjugate[i * n + j], work[i * width + n + j]);
    }
    mpz_clear(t);
    mpz_clear(previous);
    return sign;
}

// Computes T(P) of a small sample, or where furthest is 1 its furthest-site triangulation, whose cells have all points below
// their hyperplanes: the cells, sorted and with leaders for vertices (see sample_leaders), and, unless representative is NULL,
// the leader of each point, or -1 where the leader is hidden. Returns the affine dimension.
static inline int oracle_triangulate_side(const sample *s, int furthest, cell_set *cells, int *representative) {
    int *leader = (int *)need((size_t)s->count, sizeof(int)), *rank = (int *)need((size_t)s->count, sizeof(int));
    int *points = (int *)need((size_t)s->count, sizeof(int)), *used = (int *)need((size_t)s->count, sizeof(int));
    int axes[CELLS_MAX_DIM], choice[CELLS_MAX_DIM + 1], corner[CELLS_MAX_DIM + 1], distinct = 0, k, n;
    exact_points e = exact_make(s);
    sample_leaders(s, leader, rank);
    for (int i = 0; i < s->count; i++)
        if (leader[i] == i)
            points[distinct++] = i;
    k = exact_affine_dim(&e, points, distinct, axes);
    n = k + 1;
    memset(cells, 0, sizeof *cells);

    mpz_t *work = mpz_array(2 * n * n), *adjugate = mpz_array(n * n), *b = mpz_array(n), determinant, difference;
    mpz_init(determinant);
    mpz_init(difference);
    for (int i = 0; i < n; i++)
        choice[i] = i;
    for (int more = n > 0; more;) {
        for (int i = 0; i < n; i++)
            corner[i] = points[choice[i]];
        int sign = exact_invert(&e, corner, n, axes, work, adjugate, determinant);
        int empty = sign != 0;
        for (int j = 0; j < distinct && empty; j++) {
            int q = points[j], mine = 0;
            for (int i = 0; i < n; i++)
                mine |= corner[i] == q;
            if (mine)
                continue;
            // b * determinant = (q, 1) * adjugate
            mpz_mul(difference, determinant, e.height[q]);
            for (int i = 0; i < n; i++) {
                mpz_set(b[i], adjugate[(n - 1) * n + i]);
                for (int c = 0; c < n - 1; c++)
                    mpz_addmul(b[i], e.x[q * e.dim + axes[c]], adjugate[c * n + i]);
                mpz_submul(difference, b[i], e.height[corner[i]]);
            }
            int side = mpz_sgn(difference) * sign;
            for (int below = rank[q] + s->count + 1; side == 0;) {
                // Takes the largest e that is left. The coefficient of e(q) is not 0, so the loop ends at q at the latest.
                int largest = -1;
                for (int i = 0; i < n; i++)
                    if (rank[corner[i]] < below && (largest < 0 || rank[corner[i]] > rank[corner[largest]]))
                        largest = i;
                if (largest < 0 || rank[corner[largest]] < rank[q])
                    side = 1;
                else {
                    side = -mpz_sgn(b[largest]) * sign;
                    below = rank[corner[largest]];
                }
            }
            empty = furthest ? side < 0 : side > 0;
        }
        if (empty) {
            cells_add(cells, cell_make(corner, n));
            for (int i = 0; i < n; i++)
                used[corner[i]] = 1;
        }
        int i = n - 1;
        while (i >= 0 && choice[i] == distinct - n + i)
            i--;
        more = i >= 0;
        if (more) {
            choice[i]++;
            while (++i < n)
                choice[i] = choice[i - 1] + 1;
        }
    }
    cells_sort(cells);
    for (int i = 0; representative && i < s->count; i++)
        representative[i] = used[leader[i]] ? leader[i] : -1;

    mpz_clear(difference);
    mpz_clear(determinant);
    mpz_array_free(b, n);
    mpz_array_free(adjugate, n * n);
    mpz_array_free(work, 2 * n * n);
    exact_free(&e);
    free(used);
    free(points);
    free(rank);
    free(leader);
    return k;
}

static inline int oracle_triangulate(const sample *s, cell_set *cells, int *representative) {
    return oracle_triangulate_side(s, 0, cells, representative);
}

#endif
