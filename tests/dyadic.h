// Exact numbers m * 2^e, for sums and products of doubles, in GMP integers: neither rounding modes nor exponents matter.
#ifndef DYADIC_H
#define DYADIC_H

#include <gmp.h>
#include <math.h>
#include <stdlib.h>

typedef struct dyadic {
    mpz_t m;
    long e;
} dyadic;

static inline void dy_init(dyadic *a) {
    mpz_init(a->m);
    a->e = 0;
}

static inline void dy_clear(dyadic *a) { mpz_clear(a->m); }

static inline void dy_copy(dyadic *a, const dyadic *b) {
    mpz_set(a->m, b->m);
    a->e = b->e;
}

// x: finite
static inline void dy_set(dyadic *a, double x) {
    int e;
    int64_t mantissa = (int64_t)ldexp(frexp(x, &e), 53); // exact in any rounding mode
    mpz_set_si(a->m, (long)mantissa);
    a->e = e - 53;
}

// *sum = a + sign * b; sum may be a or b
static inline void dy_add(dyadic *sum, const dyadic *a, const dyadic *b, int sign) {
    static mpz_t shifted;
    static int ready;
    if (!ready)
        mpz_init(shifted), ready = 1;
    if (!mpz_sgn(b->m)) {
        dy_copy(sum, a);
        return;
    }
    if (!mpz_sgn(a->m)) {
        dy_copy(sum, b);
        if (sign < 0)
            mpz_neg(sum->m, sum->m);
        return;
    }
    if (a->e >= b->e) {
        long e = b->e;
        mpz_mul_2exp(shifted, a->m, (mp_bitcnt_t)(a->e - b->e));
        if (sign < 0)
            mpz_sub(sum->m, shifted, b->m);
        else
            mpz_add(sum->m, shifted, b->m);
        sum->e = e;
    } else {
        long e = a->e;
        mpz_mul_2exp(shifted, b->m, (mp_bitcnt_t)(b->e - a->e));
        if (sign < 0)
            mpz_sub(sum->m, a->m, shifted);
        else
            mpz_add(sum->m, a->m, shifted);
        sum->e = e;
    }
}

static inline void dy_mul(dyadic *product, const dyadic *a, const dyadic *b) {
    mpz_mul(product->m, a->m, b->m);
    product->e = a->e + b->e;
}

// *difference = x - y of two doubles
static inline void dy_difference(dyadic *difference, double x, double y) {
    static dyadic b;
    static int ready;
    if (!ready)
        dy_init(&b), ready = 1;
    dy_set(difference, x);
    dy_set(&b, y);
    dy_add(difference, difference, &b, -1);
}

static inline int dy_sign(const dyadic *a) { return mpz_sgn(a->m); }

// The size of a / b, to a few roundings; HUGE_VAL where b is 0 and a is not, 0 where a is 0
static inline double dy_ratio(const dyadic *a, const dyadic *b) {
    long i, j;
    double x, y;
    if (!mpz_sgn(a->m))
        return 0;
    if (!mpz_sgn(b->m))
        return HUGE_VAL;
    x = mpz_get_d_2exp(&i, a->m);
    y = mpz_get_d_2exp(&j, b->m);
    i += a->e - b->e - j;
    return fabs(x / y) * ldexp(1, i > 1000 ? 1000 : i < -1000 ? -1000 : (int)i);
}

static inline int dy_compare(const dyadic *a, const dyadic *b) {
    static dyadic difference;
    static int ready;
    if (!ready)
        dy_init(&difference), ready = 1;
    dy_add(&difference, a, b, -1);
    return dy_sign(&difference);
}

enum { DY_MOST = 9 };

// The determinant of the first n <= DY_MOST rows and columns, by minors: minor[mask] is that of the rows in the mask and
// of as many first columns.
static inline void dy_determinant(dyadic *det, dyadic (*a)[DY_MOST], int n) {
    static dyadic minor[1 << DY_MOST], term;
    static int ready;
    if (!ready) {
        for (int i = 0; i < 1 << DY_MOST; i++)
            dy_init(&minor[i]);
        dy_init(&term);
        ready = 1;
    }
    dy_set(&minor[0], 1);
    for (unsigned mask = 1; mask < 1u << n; mask++) {
        int column = -1, sign = 1;
        for (unsigned rest = mask; rest; rest &= rest - 1)
            column++;
        dy_set(&minor[mask], 0);
        for (int i = n - 1; i >= 0; i--) { // along the last column: the sign of its last row is positive
            if (!(mask >> i & 1))
                continue;
            dy_mul(&term, &a[i][column], &minor[mask ^ 1u << i]);
            dy_add(&minor[mask], &minor[mask], &term, sign);
            sign = -sign;
        }
    }
    dy_copy(det, &minor[(1u << n) - 1]);
}

// The determinant of the n rows row[i] - base: k columns of coordinates and, if n > k, the lift over d coordinates, less
// the weights' difference where `weighted`
static inline void dy_rows(dyadic *det, const double *const *row, const double *base, int n, int k, int d, int weighted) {
    static dyadic a[DY_MOST][DY_MOST], t, square;
    static int ready;
    if (!ready) {
        for (int i = 0; i < DY_MOST; i++)
            for (int j = 0; j < DY_MOST; j++)
                dy_init(&a[i][j]);
        dy_init(&t);
        dy_init(&square);
        ready = 1;
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < k; j++)
            dy_difference(&a[i][j], row[i][j], base[j]);
        if (n == k)
            continue;
        dy_set(&a[i][k], 0);
        for (int j = 0; j < d; j++) {
            dy_difference(&t, row[i][j], base[j]);
            dy_mul(&square, &t, &t);
            dy_add(&a[i][k], &a[i][k], &square, 1);
        }
        if (weighted) {
            dy_difference(&t, row[i][d], base[d]);
            dy_add(&a[i][k], &a[i][k], &t, -1);
        }
    }
    dy_determinant(det, a, n);
}

#endif
