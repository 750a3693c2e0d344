// The predicates are compared with an independent oracle: it computes determinants of homogeneous coordinates, without
// differences, in GMP integers by fraction-free elimination, and applies the perturbed rule to them directly.
//
// Built with PREDICATES_HASH, the program needs neither cmocka nor GMP. It prints one hash of the signs of all cases, for
// comparison between compilers, flags and modes of the FPU (tests/predicates_flags.sh). Cases are made from integers and
// bits alone, so that they are the same everywhere. The argument is the mode: nearest, up, down, zero, or flush
// (subnormal operands and results are zeros).

#define PARADT_IMPLEMENTATION
#define PARADT_STATIC
#include "../paradt.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_POINTS = PARADT_MAX_DIM + 2, RECORD = PARADT_MAX_DIM + 1 };

// k + 2 points in d dimensions
typedef struct sample {
    int k, d, weighted;
    double memory[MAX_POINTS][RECORD]; // coordinates, then the weight
    const double *points[MAX_POINTS];
} sample;

static uint64_t random_state;

// splitmix64 (Steele, Lea, Flood 2014)
static uint64_t random_bits(void) {
    uint64_t z = random_state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static int random_below(int n) {
    return (int)(random_bits() % (uint64_t)n);
}

static int random_between(int low, int high) {
    return low + random_below(high - low + 1);
}

// Returns i * 2^e; i has at most 53 bits.
static double shifted(int64_t i, int e) {
    int exact = 1;
    return paradt__scale((double)i, e, &exact);
}

// No expression may draw two random numbers, because compilers would draw them in different orders.

static double random_fraction(void) {
    return (double)(random_bits() >> 11) * 0x1p-53;
}

// Returns a number of either sign with 53 random bits, the first of which stands for 2^e.
static double random_with_exponent(int e) {
    int64_t mantissa = (int64_t)(random_bits() >> 12 | (uint64_t)1 << 52);
    return shifted(random_below(2) ? -mantissa : mantissa, e - 52);
}

static double with_random_sign(uint64_t bits) {
    return paradt__from_bits(bits | random_bits() << 63);
}

static double random_finite(void) {
    for (;;) {
        double x = paradt__from_bits(random_bits());
        if (paradt__is_finite(x))
            return x;
    }
}

// Returns x moved by `ulps` units in the last place; x is not 0.
static double by_ulps(double x, int ulps) {
    double y = paradt__from_bits(paradt__bits(x) + (uint64_t)(int64_t)ulps);
    return paradt__is_finite(y) ? y : x;
}

static int64_t square_root(uint64_t x) {
    uint64_t root = 0;
    for (int bit = 31; bit >= 0; bit--)
        if ((root | (uint64_t)1 << bit) * (root | (uint64_t)1 << bit) <= x)
            root |= (uint64_t)1 << bit;
    return (int64_t)root;
}

// --- families of samples: each function fills the coordinates

static void make_uniform(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = shifted((int64_t)(random_bits() >> 11), -53);
}

static void make_spread(sample *s) { // full mantissas, a few exponents
    int spread = random_between(1, 80);
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = random_with_exponent(-random_below(spread));
}

static void make_lattice(sample *s) {
    static const int sides[] = {1, 2, 3, 5, 9, 33, 200, 1000, 30000, 1 << 20, 1 << 29};
    int side = sides[random_below(11)], e = random_between(-60, 20);
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = shifted(random_between(-side, side), e);
}

static void make_far_lattice(sample *s) { // far from the origin
    int side = random_between(1, 40), e = random_between(-30, 30);
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = shifted(((int64_t)(j + 3) << 33) + random_between(-side, side), e);
}

static void make_cospherical(sample *s) { // one vector's coordinates permuted and negated, all moved
    int64_t vector[PARADT_MAX_DIM], origin[PARADT_MAX_DIM];
    int size = random_below(2) ? 5 : 100000, e = random_between(-40, 10);
    for (int j = 0; j < s->d; j++)
        vector[j] = random_between(0, size), origin[j] = random_between(-size, size);
    for (int i = 0; i < s->k + 2; i++) {
        for (int j = s->d - 1; j > 0; j--) {
            int other = random_below(j + 1);
            int64_t swap = vector[j];
            vector[j] = vector[other], vector[other] = swap;
        }
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = shifted(origin[j] + (random_below(2) ? vector[j] : -vector[j]), e);
    }
}

static void make_flat(sample *s) { // integer combinations of too few vectors
    int64_t vector[PARADT_MAX_DIM][PARADT_MAX_DIM];
    int rank = random_between(0, s->k - 1), size = random_below(2) ? 3 : 1000;
    for (int t = 0; t < s->k; t++)
        for (int j = 0; j < s->d; j++)
            vector[t][j] = random_between(-size, size);
    for (int i = 0; i < s->k + 2; i++) {
        int64_t x[PARADT_MAX_DIM] = {0};
        for (int t = 0; t < rank; t++) {
            int64_t factor = random_between(-size, size);
            for (int j = 0; j < s->d; j++)
                x[j] += factor * vector[t][j];
        }
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = shifted(x[j], -7);
    }
}

static void nudge(sample *s) { // moves coordinates by units in the last place, zeros by a tiny number
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++) {
            double *x = &s->memory[i][j];
            if (random_below(3))
                continue;
            if (*x == 0)
                *x = with_random_sign(random_below(2) ? paradt__bits(shifted(1, -90)) : 1);
            else
                *x = by_ulps(*x, random_between(-3, 3));
        }
}

static void make_nearly_cospherical(sample *s) {
    make_cospherical(s);
    nudge(s);
}

static void make_nearly_flat(sample *s) {
    make_flat(s);
    nudge(s);
}

static void make_nearly_lattice(sample *s) {
    make_lattice(s);
    nudge(s);
}

static void make_sphere(sample *s) { // the unit sphere, rounded
    for (int i = 0; i < s->k + 2; i++) {
        uint64_t square = 1;
        int64_t x[PARADT_MAX_DIM], root;
        for (int j = 0; j < s->d; j++) {
            x[j] = random_between(-(1 << 29), 1 << 29);
            square += (uint64_t)(x[j] * x[j]);
        }
        root = square_root(square);
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = shifted(x[j] * ((int64_t)1 << 31) / root, -31);
    }
}

static void make_magnitudes(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = random_with_exponent(random_between(-300, 300));
}

static void make_axis_magnitudes(sample *s) { // every axis has its own magnitude
    for (int j = 0; j < s->d; j++) {
        int e = random_between(-300, 300);
        for (int i = 0; i < s->k + 2; i++)
            s->memory[i][j] = random_with_exponent(e + random_between(-2, 2));
    }
}

// Makes the largest and smallest integers of some length, so that differences are about as long as the integers of some stage.
static void make_edges(sample *s) {
    int parts = random_between(1, 2), length = parts * random_between(56, 62);
    int least = random_below(4) ? -30 : -1074, below = random_below(2);
    uint64_t low = paradt__bits(shifted(1, least)), high = paradt__bits(shifted(1, least + length)) - (uint64_t)below;
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = with_random_sign(random_below(3) ? high : random_below(4) ? low : 0);
}

static void make_any(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = random_finite();
}

static void make_subnormal(sample *s) {
    int bits = random_below(3) ? random_between(1, 6) : 54;
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = with_random_sign(random_bits() >> (64 - bits));
}

static void make_huge(sample *s) { // also the largest double and its neighbours
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++) {
            s->memory[i][j] = random_below(3) ? with_random_sign(0x7fefffffffffffffu - (uint64_t)random_below(3))
                                              : random_with_exponent(random_between(1015, 1023));
        }
}

static void make_extremes(sample *s) { // 0, the smallest double, 1, the largest double
    static const uint64_t values[] = {0, 1, 0x0010000000000000u, 0x3ff0000000000000u, 0x7fefffffffffffffu};
    for (int i = 0; i < s->k + 2; i++)
        for (int j = 0; j < s->d; j++)
            s->memory[i][j] = with_random_sign(values[random_below(5)]);
}

static void make_repeated(sample *s) { // equal points, zeros of both signs
    make_lattice(s);
    for (int i = 0; i < s->k + 2; i++) {
        if (random_below(3) == 0)
            memcpy(s->memory[i], s->memory[random_below(s->k + 2)], sizeof s->memory[i]);
        for (int j = 0; j < s->d; j++)
            if (s->memory[i][j] == 0 || random_below(6) == 0)
                s->memory[i][j] = paradt__from_bits(random_bits() << 63);
    }
}

// --- weights

static void weigh_nothing(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        s->memory[i][s->d] = paradt__from_bits(random_bits() << 63);
}

static void weigh_lattice(sample *s) {
    int e = random_between(-80, 20);
    for (int i = 0; i < s->k + 2; i++)
        s->memory[i][s->d] = shifted(random_between(-20, 20), e);
}

static void weigh_unit(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        s->memory[i][s->d] = random_with_exponent(-random_below(20));
}

static void weigh_tiny(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        s->memory[i][s->d] = random_with_exponent(random_between(-1000, -200));
}

static void weigh_huge(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        s->memory[i][s->d] = random_with_exponent(random_between(200, 1023));
}

static void weigh_any(sample *s) {
    for (int i = 0; i < s->k + 2; i++)
        s->memory[i][s->d] = random_finite();
}

// The lifted points lie in a plane: the weight is |x|^2 if that is a small number, else 1.
static void weigh_flat(sample *s) {
    for (int i = 0; i < s->k + 2; i++) {
        int64_t square = 0;
        for (int j = 0; j < s->d; j++) {
            double x = s->memory[i][j];
            if (x > -1000 && x < 1000 && x == (double)(int)x)
                square += (int64_t)x * (int64_t)x;
        }
        s->memory[i][s->d] = (double)(square ? square : 1);
    }
}

typedef void (*maker)(sample *s);

typedef struct family {
    const char *name;
    maker make;
} family;

static const family families[] = {
    {"uniform", make_uniform},
    {"spread", make_spread},
    {"lattice", make_lattice},
    {"far lattice", make_far_lattice},
    {"cospherical", make_cospherical},
    {"flat", make_flat},
    {"nearly cospherical", make_nearly_cospherical},
    {"nearly flat", make_nearly_flat},
    {"nearly lattice", make_nearly_lattice},
    {"sphere", make_sphere},
    {"magnitudes", make_magnitudes},
    {"axis magnitudes", make_axis_magnitudes},
    {"edges", make_edges},
    {"any", make_any},
    {"subnormal", make_subnormal},
    {"huge", make_huge},
    {"extremes", make_extremes},
    {"repeated", make_repeated},
};
enum { FAMILIES = sizeof families / sizeof families[0] };

static const maker weighings[] = {weigh_nothing, weigh_lattice, weigh_unit, weigh_tiny,
                                  weigh_huge,    weigh_any,     weigh_flat};
enum { WEIGHINGS = sizeof weighings / sizeof weighings[0] };

// Makes points of a k-flat in d dimensions: all further coordinates are integer combinations of the first k.
static void make_in_flat(sample *s) {
    int factor[PARADT_MAX_DIM][PARADT_MAX_DIM], size = random_below(2) ? 4 : 50000;
    int64_t stretch = random_below(2) ? 1 : 0x1000001; // odd and long, so that differences have many bits
    for (int j = s->k; j < s->d; j++)
        for (int t = 0; t < s->k; t++)
            factor[j][t] = random_between(-3, 3);
    for (int i = 0; i < s->k + 2; i++) {
        int whole[PARADT_MAX_DIM];
        for (int j = 0; j < s->d; j++) {
            whole[j] = j < s->k ? random_between(-size, size) : 0;
            for (int t = 0; t < s->k && j >= s->k; t++)
                whole[j] += factor[j][t] * whole[t];
            s->memory[i][j] = shifted(whole[j] * stretch, -3);
        }
    }
}

static void make_sample(sample *s, maker make, int k, int d, maker weigh) {
    memset(s, 0, sizeof *s);
    s->k = k;
    s->d = d;
    s->weighted = weigh != NULL;
    for (int i = 0; i < MAX_POINTS; i++)
        s->points[i] = s->memory[i];
    make(s);
    if (weigh)
        weigh(s);
}

static void swap_points(sample *s, int i, int j) {
    const double *swap = s->points[i];
    s->points[i] = s->points[j];
    s->points[j] = swap;
}

// --- what the predicates say of a sample

typedef struct verdict {
    int orient, insphere, conflict; // conflict: -1 when the cell is flat
} verdict;

// Orients the cell of the sample positively first.
static verdict judge(paradt__space *space, sample *s) {
    verdict v = {paradt__orient(space, s->points), 0, -1};
    if (v.orient < 0) {
        swap_points(s, 0, 1);
        v.orient = -paradt__orient(space, s->points);
    }
    v.insphere = paradt__insphere(space, s->points);
    if (v.orient)
        v.conflict = paradt__conflict(space, s->points);
    return v;
}

static verdict judge_publicly(sample *s) {
    double weights[MAX_POINTS];
    verdict v = {paradt_orient(s->k, s->points), 0, -1};
    for (int i = 0; i < s->k + 2; i++)
        weights[i] = s->points[i][s->d];
    v.insphere = paradt_insphere(s->k, s->points, s->weighted ? weights : NULL);
    if (v.orient > 0)
        v.conflict = paradt_insphere_perturbed(s->k, s->points, s->weighted ? weights : NULL) > 0;
    return v;
}

enum { BATCH = 8 };

// Samples that share a space: what it knows of its points holds for all of them.
typedef struct batch {
    paradt__space space;
    sample samples[BATCH];
} batch;

static void make_batch(batch *b, maker make, int k, int d, maker weigh) {
    paradt__space_begin(&b->space, k, d, weigh != NULL);
    for (int n = 0; n < BATCH; n++) {
        make_sample(&b->samples[n], make, k, d, weigh);
        for (int i = 0; i < k + 2; i++)
            paradt__space_add(&b->space, b->samples[n].points[i]);
    }
    paradt__space_end(&b->space);
}

// Calls visit for batches of all families, dimensions and weights. They depend on the number of rounds alone.
static void for_all_batches(int rounds, void (*visit)(batch *b, const char *name, void *context), void *context) {
    static batch b;
    random_state = 1;
    for (int round = 0; round < rounds; round++)
        for (int k = 1; k <= PARADT_MAX_DIM; k++)
            for (int w = -4; w < WEIGHINGS; w++) {
                maker weigh = w < 0 ? NULL : weighings[w];
                // The oracle is slow in high dimensions.
                for (int f = 0; f < FAMILIES; f++) {
                    if (w >= 0 && (f + w + round) % 3)
                        continue;
                    if ((k > 4 && (f + w + k + round) % 4) || (k > 6 && (f + w + round) % 5))
                        continue;
                    make_batch(&b, families[f].make, k, k, weigh);
                    visit(&b, families[f].name, context);
                }
                if (k == PARADT_MAX_DIM)
                    continue;
                make_batch(&b, make_in_flat, k, random_between(k + 1, PARADT_MAX_DIM), weigh);
                visit(&b, "in a flat", context);
            }
}

#ifdef PREDICATES_HASH

#include <fenv.h>
#if defined(__SSE2__) && !defined(__TINYC__)
#include <xmmintrin.h>
#define CAN_FLUSH
#endif

static void add_to_hash(uint64_t *hash, verdict v) {
    *hash = (*hash ^ (uint64_t)(v.orient + 1 + 3 * (v.insphere + 1) + 9 * (v.conflict + 1))) * 0x100000001b3u;
    *hash ^= *hash >> 29;
}

static void hash_batch(batch *b, const char *name, void *context) {
    (void)name;
    for (int n = 0; n < BATCH; n++) {
        sample *s = &b->samples[n];
        add_to_hash(context, judge(&b->space, s));
        if (s->k == s->d)
            add_to_hash(context, judge_publicly(s));
        for (int i = 0; i <= s->k; i++)
            add_to_hash(context, (verdict){paradt__compare(&b->space, s->points[i], s->points[i + 1]), 0, 0});
    }
}

int main(int argc, char **argv) {
    const char *mode = argc > 1 ? argv[1] : "nearest";
    uint64_t hash = 0xcbf29ce484222325u;
    if (!strcmp(mode, "up"))
        fesetround(FE_UPWARD);
    if (!strcmp(mode, "down"))
        fesetround(FE_DOWNWARD);
    if (!strcmp(mode, "zero"))
        fesetround(FE_TOWARDZERO);
    if (!strcmp(mode, "flush")) {
#ifdef CAN_FLUSH
        _mm_setcsr(_mm_getcsr() | 0x8040); // FTZ, DAZ
#else
        return 0;
#endif
    }
    for_all_batches(argc > 2 ? atoi(argv[2]) : 1, hash_batch, &hash);
    fesetround(FE_TONEAREST);
    printf("%08lx%08lx\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    return 0;
}

#else

#include <fenv.h>
#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>
#include <gmp.h>

// --- the oracle

enum { SCALE = 1074 }; // all doubles times 2^SCALE are integers

static void set_scaled(mpz_t z, double x, int scale) {
    int e;
    uint64_t mantissa = paradt__split(x, &e);
    mpz_set_ui(z, (unsigned long)mantissa);
    if (paradt__bits(x) >> 63)
        mpz_neg(z, z);
    mpz_mul_2exp(z, z, (mp_bitcnt_t)(e + scale));
}

// Returns the sign of the determinant of n rows by fraction-free elimination (Bareiss), which overwrites them.
static int sign_of_determinant(mpz_t (*a)[MAX_POINTS], int n) {
    int sign = 1;
    mpz_t last, t;
    mpz_init_set_ui(last, 1);
    mpz_init(t);
    for (int c = 0; c < n && sign; c++) {
        int pivot = c;
        while (pivot < n && !mpz_sgn(a[pivot][c]))
            pivot++;
        if (pivot == n) {
            sign = 0;
            break;
        }
        if (pivot != c) {
            sign = -sign;
            for (int j = 0; j < n; j++)
                mpz_swap(a[c][j], a[pivot][j]);
        }
        for (int i = c + 1; i < n; i++)
            for (int j = c + 1; j < n; j++) {
                mpz_mul(a[i][j], a[i][j], a[c][c]);
                mpz_mul(t, a[i][c], a[c][j]);
                mpz_sub(a[i][j], a[i][j], t);
                mpz_divexact(a[i][j], a[i][j], last);
            }
        mpz_set(last, a[c][c]);
    }
    sign *= mpz_sgn(a[n - 1][n - 1]);
    mpz_clear(last);
    mpz_clear(t);
    return sign;
}

static mpz_t oracle_matrix[MAX_POINTS][MAX_POINTS];

static int oracle_orient(const double *const *p, int k) {
    for (int i = 0; i <= k; i++) {
        mpz_set_ui(oracle_matrix[i][0], 1);
        for (int j = 0; j < k; j++)
            set_scaled(oracle_matrix[i][j + 1], p[i][j], SCALE);
    }
    return sign_of_determinant(oracle_matrix, k + 1);
}

// A point is inside a positively oriented cell's sphere when its lift is below the cell's lifted hyperplane.
static int oracle_insphere(const double *const *p, int k, int d, int weighted) {
    mpz_t x;
    mpz_init(x);
    for (int i = 0; i < k + 2; i++) {
        mpz_t *row = oracle_matrix[i];
        mpz_set_ui(row[0], 1);
        for (int j = 0; j < k; j++)
            set_scaled(row[j + 1], p[i][j], SCALE);
        mpz_set_ui(row[k + 1], 0);
        for (int j = 0; j < d; j++) {
            set_scaled(x, p[i][j], SCALE);
            mpz_addmul(row[k + 1], x, x);
        }
        set_scaled(x, p[i][d], 2 * SCALE);
        if (weighted)
            mpz_sub(row[k + 1], row[k + 1], x);
    }
    mpz_clear(x);
    return -sign_of_determinant(oracle_matrix, k + 2);
}

// Compares two points lexicographically in rational numbers.
static int oracle_compare(const double *a, const double *b, int k) {
    int sign = 0;
    mpq_t x, y;
    mpq_init(x);
    mpq_init(y);
    for (int j = 0; j < k && !sign; j++) {
        mpq_set_d(x, a[j]);
        mpq_set_d(y, b[j]);
        sign = mpq_cmp(x, y);
        sign = (sign > 0) - (sign < 0);
    }
    mpq_clear(x);
    mpq_clear(y);
    return sign;
}

static int oracle_conflict(const double *const *p, int k, int d, int weighted) {
    int sign = oracle_insphere(p, k, d, weighted), order[MAX_POINTS];
    if (sign)
        return sign > 0;
    for (int i = 0; i < k + 2; i++) { // insertion sort: the largest first, the query before points equal to it
        int at = i;
        for (; at > 0; at--) {
            int c = oracle_compare(p[order[at - 1]], p[i], k);
            if (c > 0 || (c == 0 && i != k + 1))
                break;
            order[at] = order[at - 1];
        }
        order[at] = i;
    }
    for (int i = 0; order[i] != k + 1; i++) {
        const double *replaced[MAX_POINTS];
        memcpy(replaced, p, (size_t)(k + 1) * sizeof *p);
        replaced[order[i]] = p[k + 1];
        sign = oracle_orient(replaced, k);
        if (sign)
            return sign > 0;
    }
    return 0;
}

static void start_oracle(void) {
    for (int i = 0; i < MAX_POINTS; i++)
        for (int j = 0; j < MAX_POINTS; j++)
            mpz_init(oracle_matrix[i][j]);
}

static void stop_oracle(void) {
    for (int i = 0; i < MAX_POINTS; i++)
        for (int j = 0; j < MAX_POINTS; j++)
            mpz_clear(oracle_matrix[i][j]);
}

// Prints what differs, and the whole sample, and fails.
static void expect(int actual, int expected, const char *what, const sample *s, const char *name) {
    if (actual == expected)
        return;
    print_error("%s: %d, should be %d; family %s, k %d, d %d, weighted %d\n", what, actual, expected, name, s->k, s->d,
                s->weighted);
    for (int i = 0; i < s->k + 2; i++) {
        for (int j = 0; j < s->d + s->weighted; j++)
            print_error(" %a", s->points[i][j]);
        print_error("\n");
    }
    fail();
}

// --- tests

static uint64_t zero_orients, zero_inspheres, conflicts;

static void check_predicates(batch *b, const char *name, void *context) {
    paradt__counters *total = context;
    for (int n = 0; n < BATCH; n++) {
        sample *s = &b->samples[n];
        int k = s->k, d = s->d, orient = oracle_orient(s->points, k);
        verdict v = judge(&b->space, s);
        expect(v.orient, orient, "orientation", s, name);
        int insphere = oracle_insphere(s->points, k, d, s->weighted);
        expect(v.insphere, insphere, "in-sphere", s, name);
        if (orient)
            expect(v.conflict, oracle_conflict(s->points, k, d, s->weighted), "conflict", s, name);
        zero_orients += orient == 0;
        zero_inspheres += insphere == 0;
        conflicts += v.conflict > 0;
        if (d > k)
            continue;
        verdict own = judge_publicly(s);
        if (orient < 0)
            orient = 1; // judge has oriented the cell positively
        expect(own.orient, orient, "paradt_orient", s, name);
        expect(own.insphere, insphere, "paradt_insphere", s, name);
        if (orient)
            expect(own.conflict, v.conflict, "paradt_insphere_perturbed", s, name);
    }
    const paradt__counters *c = &b->space.counters;
    total->orient_calls += c->orient_calls;
    total->insphere_calls += c->insphere_calls;
    total->exact_small += c->exact_small;
    total->exact_fixed += c->exact_fixed;
    total->exact_general += c->exact_general;
    total->perturbed += c->perturbed;
}

static void predicates_agree_with_the_oracle(void **state) {
    paradt__counters total = {0};
    (void)state;
    start_oracle();
    for_all_batches(4, check_predicates, &total);
    stop_oracle();
    print_message(
        "%llu orientations (%llu flat), %llu in-spheres (%llu on the sphere), settled small %llu, fixed %llu, "
        "general %llu, perturbed %llu\n",
        (unsigned long long)total.orient_calls, (unsigned long long)zero_orients,
        (unsigned long long)total.insphere_calls, (unsigned long long)zero_inspheres,
        (unsigned long long)total.exact_small, (unsigned long long)total.exact_fixed,
        (unsigned long long)total.exact_general, (unsigned long long)total.perturbed);
    assert_true(total.exact_small && total.exact_general && total.perturbed);
#ifdef __SIZEOF_INT128__
    assert_true(total.exact_fixed > 0);
#endif
    assert_true(zero_orients && zero_inspheres && conflicts);
}

// Expects the same sign from every exact stage that can take the determinant. Counts in seen[] how often each could.
static void check_stages(const paradt__determinant *q, int expected, const sample *s, const char *name, int *seen) {
    static paradt__digit work[1 << 20];
    static paradt__wide sum[1 << 12];
    paradt__space space;
    paradt__fixed f;
    paradt__layout y;
    paradt__minors m = {q, &y, work, 0};
    int lifted = q->n > q->k, digits;
    paradt__space_begin(&space, q->k, q->d, q->weighted);
    space.coordinates.unit = -1074, space.coordinates.top = 1024; // nothing is known about the set
    y = paradt__lay_out(&space, q);
    digits = paradt__minor_digits(&m, q->n);
    paradt__digit *rest = work + q->n * (q->k * y.digits + y.lift_digits);
    expect(paradt__general_large(q, &y), expected, "general stage, large", s, name);
    if (paradt__general_fits(q, &y, PARADT__SMALL_DIGITS, PARADT__SMALL_SUM)) {
        expect(paradt__general_small(q, &y), expected, "general stage, small", s, name);
        seen[0]++;
    } else {
        assert_true(q->k > 3); // all of 2 and 3 dimensions fits
    }
    if (q->n >= 2) {
        paradt__load_rows(work, sum, q, &y);
        expect(paradt__sign(paradt__general_halves(&m, rest, sum, digits), digits), expected, "general stage, halves", s, name);
        m.first = 0;
        const paradt__digit *det = paradt__minor(&m, (1u << q->n) - 1, rest, sum, &digits);
        expect(paradt__sign(det, digits), expected, "general stage, whole", s, name);
        seen[1]++;
    }
    if (paradt__fix_rows(&f, &space, q)) {
        int bits = q->k * f.bits + (lifted ? f.lift_bits : 0) + paradt__log_factorial[q->n];
        if (lifted && f.lift_bits <= PARADT__WIDE_BITS - 5)
            paradt__fix_lifts(&f, q);
        if (bits <= PARADT__WIDE_BITS && (!lifted || f.lift_bits <= PARADT__WIDE_BITS - 5)) {
            paradt__wide det = paradt__wide_any(&f, q->n, q->k);
            expect((det > 0) - (det < 0), expected, "small stage", s, name);
            expect(paradt__small_sign(&f, q->n, q->k, q->k == 2 || q->k == 3), expected, "small stage", s, name);
            seen[2]++;
        }
#ifdef __SIZEOF_INT128__
        if ((q->k == 2 || q->k == 3) && (!lifted || f.lift_bits <= 122)) {
            expect(paradt__fixed_one(&f, q->n, q->k), expected, "fixed stage, one digit", s, name);
            seen[3]++;
        }
#endif
    }
#ifdef __SIZEOF_INT128__
    if (paradt__two_fit(&y, q->n, q->k)) {
        expect(paradt__fixed_two(q, &y), expected, "fixed stage, two digits", s, name);
        seen[4]++;
    }
#endif
}

static void check_batch_stages(batch *b, const char *name, void *context) {
    for (int n = 0; n < BATCH; n++) {
        sample *s = &b->samples[n];
        int k = s->k, d = s->d;
        paradt__determinant orient = {k, k, d, s->weighted, s->points + 1, s->points[0]};
        paradt__determinant insphere = {k + 1, k, d, s->weighted, s->points, s->points[k + 1]};
        expect(paradt__exact_orient(&b->space, s->points), oracle_orient(s->points, k), "exact orientation", s, name);
        expect(paradt__exact_insphere(&b->space, s->points), oracle_insphere(s->points, k, d, s->weighted),
               "exact in-sphere", s, name);
        check_stages(&orient, oracle_orient(s->points, k), s, name, context);
        int sign = oracle_insphere(s->points, k, d, s->weighted);
        check_stages(&insphere, k & 1 ? -sign : sign, s, name, context);
    }
}

static void every_exact_stage_agrees_with_the_oracle(void **state) {
    int seen[5] = {0};
    (void)state;
    start_oracle();
    for_all_batches(1, check_batch_stages, seen);
    stop_oracle();
    print_message("stages: general in little space %d, in halves %d, small %d, fixed one %d, two %d\n", seen[0],
                  seen[1], seen[2], seen[3], seen[4]);
    for (int i = 0; i < 3; i++)
        assert_true(seen[i] > 0);
#ifdef __SIZEOF_INT128__
    assert_true(seen[3] > 0 && seen[4] > 0);
#endif
}

static void swap_any(sample *s, int n) {
    int i = random_below(n), j = (i + 1 + random_below(n - 1)) % n;
    swap_points(s, i, j);
}

static void check_antisymmetry(batch *b, const char *name, void *context) {
    (void)context;
    for (int n = 0; n < BATCH; n++) {
        sample *s = &b->samples[n];
        int orient = paradt__orient(&b->space, s->points), insphere = paradt__insphere(&b->space, s->points);
        for (int round = 0; round < 4; round++) {
            swap_any(s, s->k + 1); // swaps two vertices of the cell: both signs change
            orient = -orient, insphere = -insphere;
            expect(paradt__orient(&b->space, s->points), orient, "orientation of swapped points", s, name);
            expect(paradt__insphere(&b->space, s->points), insphere, "in-sphere of swapped points", s, name);
        }
        for (int round = 0; round < 4; round++) {
            swap_any(s, s->k + 2); // swaps any two points: the orientation of the lifted simplex changes
            insphere = -insphere;
            expect(paradt__insphere(&b->space, s->points), insphere, "in-sphere of swapped points", s, name);
        }
    }
}

static void swapping_two_points_turns_the_sign(void **state) {
    (void)state;
    for_all_batches(2, check_antisymmetry, NULL);
}

// Two cells share a facet. Each is in conflict with the other's apex, or neither is: the perturbation is a property of the
// points, so it gives consistent answers.
static void check_both_sides(batch *b, const char *name, void *context) {
    for (int n = 0; n < BATCH; n++) {
        sample *s = &b->samples[n];
        if (paradt__orient(&b->space, s->points) < 0)
            swap_points(s, 0, 1);
        if (s->k == 1 || paradt__orient(&b->space, s->points) <= 0)
            continue;
        int here = paradt__conflict(&b->space, s->points);
        swap_points(s, 0, s->k + 1); // the other cell of the facet opposite to point 0
        if (paradt__orient(&b->space, s->points) >= 0)
            continue;
        swap_points(s, 1, 2); // orients it positively
        expect(paradt__conflict(&b->space, s->points), here, "conflict from the other side", s, name);
        ++*(int *)context;
    }
}

static void conflicts_look_the_same_from_both_sides_of_a_facet(void **state) {
    int seen = 0;
    (void)state;
    for_all_batches(2, check_both_sides, &seen);
    assert_true(seen > 1000);
}

static void run_uniform(int k, int weighted, paradt__counters *counters) {
    enum { POINTS = 4096, TESTS = 20000 };
    static double points[POINTS][RECORD];
    paradt__space s;
    paradt__space_begin(&s, k, k, weighted);
    for (int i = 0; i < POINTS; i++) {
        for (int j = 0; j < k; j++)
            points[i][j] = shifted((int64_t)(random_bits() >> 11), -53);
        points[i][k] = shifted(random_below(1 << 20), -30);
        paradt__space_add(&s, points[i]);
    }
    paradt__space_end(&s);
    for (int n = 0; n < TESTS; n++) {
        const double *p[MAX_POINTS];
        for (int i = 0; i < k + 2; i++)
            p[i] = points[random_below(POINTS)];
        for (int i = 0; i < k + 2; i++)
            for (int j = 0; j < i; j++)
                if (p[i] == p[j])
                    goto next;
        paradt__orient(&s, p);
        paradt__insphere(&s, p);
    next:;
    }
    *counters = s.counters;
}

static void uniform_points_stay_in_the_filter(void **state) {
    (void)state;
    for (int k = 1; k <= PARADT_MAX_DIM; k++)
        for (int weighted = 0; weighted < 2; weighted++) {
            paradt__counters c;
            run_uniform(k, weighted, &c);
            // In 7 and 8 dimensions the bound of the elimination fails about once in 10^5.
            assert_in_range(c.exact_small + c.exact_fixed + c.exact_general, 0, k < 7 ? 0 : 3);
        }
}

// The points are neighbours on lattices of several sizes, far from the origin.
static void lattices_stay_in_the_filter(void **state) {
    (void)state;
    for (int k = 2; k <= 3; k++)
        for (int e = -100; e <= 100; e += 50) {
            paradt__space s;
            double far[RECORD] = {0}, points[MAX_POINTS][RECORD];
            const double *p[MAX_POINTS];
            int zeros = 0;
            paradt__space_begin(&s, k, k, 0);
            for (int j = 0; j < k; j++)
                far[j] = shifted(2000, e);
            paradt__space_add(&s, far);
            far[0] = shifted(1, e);
            paradt__space_add(&s, far);
            paradt__space_end(&s);
            for (int n = 0; n < 5000; n++) {
                for (int i = 0; i < k + 2; i++) {
                    for (int j = 0; j < k; j++)
                        points[i][j] = shifted(1500 + random_between(-3, 3), e);
                    p[i] = points[i];
                }
                zeros += paradt__orient(&s, p) == 0;
                zeros += paradt__insphere(&s, p) == 0;
            }
            assert_true(zeros > 0);
            assert_int_equal(s.counters.exact_small, zeros);
            assert_int_equal(s.counters.exact_fixed + s.counters.exact_general, 0);
        }
}

// The space is measured in d dimensions, and the predicates are asked about projections on some of the axes. The sets are flat,
// and their units are above and below 1.
static void facts_hold_for_any_fewer_axes(void **state) {
    (void)state;
    start_oracle();
    for (int round = 0; round < 4000; round++) {
        paradt__space s;
        sample whole, part;
        int d = random_between(2, PARADT_MAX_DIM), e = random_between(-20, 20);
        make_sample(&whole, make_lattice, d, d, NULL);
        for (int i = 0; i < d + 2; i++)
            for (int j = 0; j < d; j++) {
                int flat = j % 3 == round % 3, side = random_below(2) ? 3 : 1 << 25;
                whole.memory[i][j] = flat ? 0 : shifted(random_between(-side, side), e);
            }
        if (random_below(2))
            nudge(&whole);
        paradt__space_begin(&s, d, d, 0);
        for (int i = 0; i < d + 2; i++)
            paradt__space_add(&s, whole.memory[i]);
        paradt__space_end(&s);
        make_sample(&part, make_lattice, random_between(1, d), d, NULL);
        part.d = s.ambient = s.dim = part.k;
        for (int j = 0; j < part.k; j++) {
            int axis = (j + round) % d;
            for (int i = 0; i < part.k + 2; i++)
                part.memory[i][j] = whole.memory[i][axis];
        }
        expect(paradt__orient(&s, part.points), oracle_orient(part.points, part.k), "orientation", &part, "fewer axes");
        expect(paradt__insphere(&s, part.points), oracle_insphere(part.points, part.k, part.k, 0), "in-sphere", &part,
               "fewer axes");
    }
    stop_oracle();
}

// Makes an integer simplex whose determinant is 0 to 3, by row and column operations on a diagonal matrix. The filter's error
// bound reaches the smallest nonzero determinant.
static void make_unimodular(sample *s, int k) {
    int64_t a[PARADT_MAX_DIM][PARADT_MAX_DIM] = {{0}}, largest = 1, size = (int64_t)1 << random_between(1, 26);
    memset(s, 0, sizeof *s);
    s->k = s->d = k;
    for (int i = 0; i < k; i++)
        a[i][i] = i ? 1 : random_below(4);
    while (largest < size) {
        int i = random_below(k), j = (i + 1 + random_below(k - 1)) % k, factor = random_between(-3, 3),
            rows = random_below(2);
        for (int t = 0; t < k; t++) {
            int64_t *to = rows ? &a[i][t] : &a[t][i];
            *to += factor * (rows ? a[j][t] : a[t][j]);
            largest = *to > largest ? *to : -*to > largest ? -*to : largest;
        }
    }
    for (int i = 0; i < k + 2; i++) {
        s->points[i] = s->memory[i];
        for (int j = 0; j < k && i > 0 && i <= k; j++)
            s->memory[i][j] = (double)a[i - 1][j];
    }
}

static void the_least_determinants_are_told_from_zero(void **state) {
    uint64_t settled = 0;
    (void)state;
    start_oracle();
    for (int round = 0; round < 40000; round++) {
        sample s;
        paradt__space space;
        int k = round % 4 ? random_between(2, 4) : random_between(5, PARADT_MAX_DIM);
        make_unimodular(&s, k);
        paradt__space_begin(&space, k, k, 0);
        for (int i = 0; i <= k; i++)
            paradt__space_add(&space, s.points[i]);
        paradt__space_end(&space);
        expect(paradt__orient(&space, s.points), oracle_orient(s.points, k), "orientation", &s, "unimodular");
        settled += space.counters.exact_small;
    }
    stop_oracle();
    assert_true(settled > 0);
}

// Three points almost on a line. Rounded upward, their determinant errs by a fourth of the bound, and has the wrong sign.
static void filters_keep_their_bound_rounding_upward(void **state) {
    static const double points[3][2] = {{-0x1.24f1928ad4edfp-1, 0x1.54488f0729af1p-1},
                                        {0x1.3eb839b990a1ap-1, -0x1.28b6ffd14fa38p-1},
                                        {-0x1.b4d51578b336fp+0, 0x1.d88768d77bd75p+0}};
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    (void)state;
    start_oracle();
    for (int mode = 0; mode < 4; mode++)
        for (int swapped = 0; swapped < 2; swapped++) {
            sample s = {2, 2, 0, {{0}}, {0}};
            int sign;
            for (int i = 0; i < 3; i++) {
                volatile double x = points[i][0], y = points[i][1]; // not for the compiler, which rounds to nearest
                s.memory[i][0] = x, s.memory[i][1] = y;
                s.points[i] = s.memory[swapped && i ? 3 - i : i];
            }
            s.points[3] = s.memory[3];
            fesetround(modes[mode]);
            sign = paradt_orient(2, s.points);
            fesetround(FE_TONEAREST);
            expect(sign, oracle_orient(s.points, 2), "orientation", &s, "almost on a line");
        }
    stop_oracle();
}

// Cells on a cube's corners, whose determinants are the largest of their columns. The corners are so far apart that two digits
// just suffice, or just do not; a small coordinate sets the unit.
static void two_digits_suffice_for_117_bits(void **state) {
    int seen[5] = {0};
    batch b;
    (void)state;
    start_oracle();
    for (int round = 0; round < 300; round++) {
        int length = random_between(113, 122);
        double high = paradt__from_bits(paradt__bits(shifted(1, length)) - 1);
        paradt__space_begin(&b.space, 2 + round % 2, 2 + round % 2, 0);
        for (int n = 0; n < BATCH; n++) {
            sample *s = &b.samples[n];
            memset(s, 0, sizeof *s);
            s->k = s->d = 2 + round % 2;
            for (int i = 0; i < s->k + 2; i++) {
                s->points[i] = s->memory[i];
                for (int j = 0; j < s->k; j++) {
                    int base = i == 0 || i == s->k + 1, kind = random_below(8);
                    s->memory[i][j] = base || kind < 4 ? -high : kind < 7 ? high : 1;
                }
                paradt__space_add(&b.space, s->memory[i]);
            }
        }
        paradt__space_end(&b.space);
        check_batch_stages(&b, "corners", seen);
    }
    stop_oracle();
#ifdef __SIZEOF_INT128__
    assert_true(seen[4] > 0);
#endif
}

// Products of these coordinates are about as small as the least doubles. Rounding moves them by as much as they are.
static void determinants_that_underflow_keep_their_signs(void **state) {
    (void)state;
    start_oracle();
    for (int round = 0; round < 60000; round++) {
        sample s = {2 + round % 3, 2 + round % 3, 0, {{0}}, {0}};
        int columns = s.k + (round / 3 % 2 ? 2 : 0), e = -1074 / columns - random_between(0, 3);
        for (int i = 0; i < s.k + 2; i++) {
            s.points[i] = s.memory[i];
            for (int j = 0; j < s.k; j++)
                s.memory[i][j] = shifted(random_between(-15, 15), e);
        }
        expect(paradt_orient(s.k, s.points), oracle_orient(s.points, s.k), "orientation", &s, "underflow");
        expect(paradt_insphere(s.k, s.points, NULL), oracle_insphere(s.points, s.k, s.k, 0), "in-sphere", &s, "underflow");
    }
    stop_oracle();
}

// Filters and lengths hold for what was measured: no point beyond it may be asked about, nor one of more digits.
static void only_what_was_measured_is_admitted(void **state) {
    static const double corners[2][2] = {{1, -2}, {3, 0.5}};
    static const double inside[3][2] = {{1, 0.5}, {2, -1}, {1.5, 0}};
    static const double outside[6][2] = {{0.5, 0}, {3.5, 0}, {2, -2.5}, {2, 1}, {1.25, 0}, {2, 0.25}};
    paradt__space s;
    (void)state;
    paradt__space_begin(&s, 2, 2, 0);
    for (int i = 0; i < 2; i++)
        paradt__space_add(&s, corners[i]);
    paradt__space_end(&s);
    for (int i = 0; i < 3; i++)
        assert_true(paradt__space_admits(&s, inside[i]));
    for (int i = 0; i < 6; i++)
        assert_false(paradt__space_admits(&s, outside[i]));
}

static void ordered_bits_order_like_the_doubles(void **state) {
    (void)state;
    assert_true(paradt__ordered_bits(0.0) == 0 && paradt__ordered_bits(paradt__from_bits((uint64_t)1 << 63)) == 0);
    for (int n = 0; n < 20000; n++) {
        double x = random_finite(), y = random_below(2) ? random_finite() : by_ulps(x, random_between(-1, 1));
        int64_t a = paradt__ordered_bits(x), b = paradt__ordered_bits(y);
        assert_int_equal((a > b) - (a < b), oracle_compare(&x, &y, 1));
        assert_true(paradt__bits(paradt__from_ordered_bits(a)) == paradt__bits(x));
    }
}

static void only_finite_doubles_are_finite(void **state) {
    (void)state;
    for (int sign = 0; sign < 2; sign++) {
        uint64_t bit = (uint64_t)sign << 63;
        assert_true(paradt__is_finite(paradt__from_bits(bit)));
        assert_true(paradt__is_finite(paradt__from_bits(bit | 1)));
        assert_true(paradt__is_finite(paradt__from_bits(bit | 0x7fefffffffffffffu)));
        assert_false(paradt__is_finite(paradt__from_bits(bit | 0x7ff0000000000000u)));
        assert_false(paradt__is_finite(paradt__from_bits(bit | 0x7ff0000000000001u)));
        assert_false(paradt__is_finite(paradt__from_bits(bit | 0x7fffffffffffffffu)));
    }
}

// The oracle is the rational number x * 2^e, which GMP truncates to a double.
static void scaling_is_exact_or_says_so(void **state) {
    mpq_t q, r;
    int inexact = 0, overflows = 0;
    mpz_t largest;
    (void)state;
    mpq_init(q);
    mpq_init(r);
    mpz_init(largest);
    mpz_ui_pow_ui(largest, 2, 1024);
    for (int n = 0; n < 50000; n++) {
        double x = random_below(4) ? random_finite() : paradt__from_bits(random_bits() >> random_between(12, 63));
        int e = random_below(2) ? random_between(-2200, 2200) : random_between(-60, 60), exact = 1;
        double y = paradt__scale(x, e, &exact);
        mpq_set_d(q, x);
        if (e > 0)
            mpq_mul_2exp(q, q, (mp_bitcnt_t)e);
        else
            mpq_div_2exp(q, q, (mp_bitcnt_t)-e);
        mpq_set_d(r, y);
        assert_int_equal(exact, mpq_equal(q, r));
        assert_int_equal(paradt__bits(x) >> 63, paradt__bits(y) >> 63);
        mpq_abs(q, q);
        if (mpq_cmp_z(q, largest) >= 0) {
            assert_true((paradt__bits(y) << 1) == 0x7fefffffffffffffu << 1);
            overflows++;
        } else {
            // |y| <= |q| < the next double
            double next = paradt__from_bits((paradt__bits(y) & 0x7fffffffffffffffu) + 1);
            mpq_abs(r, r);
            assert_true(mpq_cmp(r, q) <= 0);
            mpq_set_d(r, paradt__is_finite(next) ? next : 0);
            if (paradt__is_finite(next))
                assert_true(mpq_cmp(q, r) < 0);
        }
        inexact += !exact;
    }
    assert_true(inexact > overflows && overflows > 0);
    mpq_clear(q);
    mpq_clear(r);
    mpz_clear(largest);
}

// Makes four points in the cube [-1, 1]^3, and a fifth near their sphere. The four come in two pairs, whose points are the closer
// the larger shortness is; then the tetrahedron is long and thin, as those of points on a curve.
static void take_near_a_sphere(sample *s, int shortness) {
    double centre[3], radius = random_fraction() / 2;
    for (int j = 0; j < 3; j++)
        centre[j] = random_fraction() - 0.5;
    for (int i = 0; i < 5; i++) {
        double v[3], length = 0;
        for (int j = 0; j < 3; j++) {
            double step = 2 * random_fraction() - 1;
            v[j] = i % 2 && i < 4 ? s->memory[i - 1][j] + shifted(1, -shortness) * step - centre[j] : step;
            length += v[j] * v[j];
        }
        length = sqrt(length);
        if (i == 4)
            length *= 1 + (2 * random_fraction() - 1) * shifted(1, -random_between(30, 50));
        for (int j = 0; j < 3; j++)
            s->memory[i][j] = centre[j] + v[j] / length * radius;
        s->points[i] = s->memory[i];
    }
}

// The sphere through four of a sample's points, and the bound on the errors of its powers
typedef struct sphere {
    double normal[3], constant, error;
} sphere;

static const paradt__frame unit_cube = {{1, 1, 1}, 3, 0};

static sphere plain_sphere(const sample *s, int sharp) {
    const double *a = s->points[1], *b = s->points[0], *c = s->points[2], *p = s->points[3];
    const paradt__centred at = {{p[0], p[1], p[2]}, p[0] * p[0] + p[1] * p[1] + p[2] * p[2]};
    const paradt__making making = sharp ? PARADT__MAKE_SHARP : PARADT__MAKE_QUICKLY;
    sphere made;
    const paradt__spoke to_a = paradt__spoke_of(making, 4, p, a), to_b = paradt__spoke_of(making, 4, p, b);
    const paradt__spoke to_c = paradt__spoke_of(making, 4, p, c);
    paradt__sphere_make(making, &unit_cube, &at, to_a.edge, to_b.edge, to_c.edge, made.normal, &made.constant,
                         &made.error);
    return made;
}

#if defined(PARADT__KEPT_AVX2)
// Makes the same sphere by the AVX2 copy of the code, which makes four at a time, here four equal ones.
PARADT__AVX2 static sphere avx2_sphere(const sample *s, int sharp) {
    __m256d corner[3][4], at[4], four[4], error;
    sphere made;
    for (int axis = 0; axis < 3; axis++) {
        at[axis] = _mm256_set1_pd(s->points[3][axis]);
        for (int i = 0; i < 3; i++)
            corner[i][axis] = _mm256_set1_pd(s->points[i][axis] - s->points[3][axis]);
    }
    for (int i = 0; i < 3; i++)
        corner[i][3] = paradt__dot_avx2(corner[i], corner[i]);
    at[3] = paradt__dot_avx2(at, at);
    paradt__four_spheres(sharp, &unit_cube, at, corner[1], corner[0], corner[2], four, &error);
    for (int axis = 0; axis < 3; axis++)
        made.normal[axis] = _mm256_cvtsd_f64(four[axis]);
    made.constant = _mm256_cvtsd_f64(four[3]);
    made.error = _mm256_cvtsd_f64(error);
    return made;
}

static int has_avx2(void) { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#else
static sphere avx2_sphere(const sample *s, int sharp) { return plain_sphere(s, sharp); }

static int has_avx2(void) { return 0; }
#endif

// A power that is larger than its error bound has the sign of the in-sphere determinant, for both bounds and both copies of the
// code. The sharp bound is not the larger one.
static void powers_are_as_exact_as_they_claim(void **state) {
    uint64_t settled[2] = {0, 0}, doubtful = 0;
    (void)state;
    start_oracle();
    for (int round = 0; round < 60000; round++) {
        sample s = {3, 3, 0, {{0}}, {0}};
        take_near_a_sphere(&s, round % 25);
        if (oracle_orient(s.points, 3) < 0) {
            const double *first = s.points[0];
            s.points[0] = s.points[1], s.points[1] = first;
        }
        if (oracle_orient(s.points, 3) == 0)
            continue;
        const double *x = s.points[4];
        int sign = oracle_insphere(s.points, 3, 3, 0);
        for (int copy = 0; copy < 1 + has_avx2(); copy++) {
            double error[2];
            for (int sharp = 0; sharp < 2; sharp++) {
                sphere made = copy ? avx2_sphere(&s, sharp) : plain_sphere(&s, sharp);
                double power = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + made.constant +
                               (made.normal[0] * x[0] + made.normal[1] * x[1] + made.normal[2] * x[2]);
                error[sharp] = made.error;
                if (!(fabs(power) > made.error)) {
                    doubtful++;
                    continue;
                }
                settled[sharp]++;
                expect(power < 0 ? 1 : -1, sign, sharp ? "power, sharp bound" : "power", &s, "near a sphere");
            }
            assert_true(error[1] <= error[0] * (1 + 1e-9));
        }
    }
    stop_oracle();
    print_message("%llu and %llu powers settled, %llu not, %s\n", (unsigned long long)settled[0],
                  (unsigned long long)settled[1], (unsigned long long)doubtful,
                  has_avx2() ? "with AVX2 and without" : "without AVX2");
    assert_true(settled[0] > 0 && settled[1] > settled[0] && doubtful > 0);
}

// The longest numbers fit into the space that the header reserves for them.
static void the_general_stage_keeps_its_room(void **state) {
    (void)state;
    for (int k = 1; k <= PARADT_MAX_DIM; k++)
        for (int weighted = 0; weighted < 2; weighted++) {
            double memory[MAX_POINTS][RECORD];
            const double *p[MAX_POINTS] = {0};
            paradt__space space;
            paradt__determinant q = {k + 1, k, k, weighted, p, p[0]};
            paradt__minors m = {&q, NULL, NULL, 0};
            for (int i = 0; i < k + 2; i++) {
                for (int j = 0; j <= k; j++)
                    memory[i][j] = paradt__from_bits(random_below(2) ? 1 : 0x7fefffffffffffffu);
                p[i] = memory[i];
            }
            memory[0][0] = paradt__from_bits(1), memory[1][0] = paradt__from_bits(0x7fefffffffffffffu);
            q.base = p[k + 1];
            paradt__space_begin(&space, k, k, weighted);
            for (int i = 0; i < k + 2; i++)
                paradt__space_add(&space, p[i]);
            paradt__space_end(&space);
            paradt__layout y = paradt__lay_out(&space, &q);
            m.layout = &y;
            assert_int_equal(y.bits, 2099);
            if (paradt__general_fits(&q, &y, PARADT__LARGE_DIGITS, PARADT__LARGE_SUM))
                continue;
            int room = (k + 1) * (k * y.digits + y.lift_digits), half = (k + 1) / 2, other = k + 1 - half;
            int sums = paradt__minor_digits(&m, k + 1);
            room += paradt__minors_space(&m, half, 0) + paradt__minors_space(&m, half, 1);
            m.first = half;
            room += paradt__minors_space(&m, other, 0) + paradt__minors_space(&m, other, 1);
            sums += paradt__minor_digits(&m, other);
            assert_in_range(room, 1, PARADT__LARGE_DIGITS);
            assert_in_range(sums, 1, PARADT__LARGE_SUM);
            assert_true(k > 5); // up to 5 dimensions the whole determinant fits
            if (k == PARADT_MAX_DIM)
                print_message("largest: %d digits, sums of %d\n", room, sums);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ordered_bits_order_like_the_doubles),
        cmocka_unit_test(only_finite_doubles_are_finite),
        cmocka_unit_test(scaling_is_exact_or_says_so),
        cmocka_unit_test(predicates_agree_with_the_oracle),
        cmocka_unit_test(every_exact_stage_agrees_with_the_oracle),
        cmocka_unit_test(swapping_two_points_turns_the_sign),
        cmocka_unit_test(conflicts_look_the_same_from_both_sides_of_a_facet),
        cmocka_unit_test(uniform_points_stay_in_the_filter),
        cmocka_unit_test(lattices_stay_in_the_filter),
        cmocka_unit_test(facts_hold_for_any_fewer_axes),
        cmocka_unit_test(the_least_determinants_are_told_from_zero),
        cmocka_unit_test(two_digits_suffice_for_117_bits),
        cmocka_unit_test(determinants_that_underflow_keep_their_signs),
        cmocka_unit_test(only_what_was_measured_is_admitted),
        cmocka_unit_test(filters_keep_their_bound_rounding_upward),
        cmocka_unit_test(powers_are_as_exact_as_they_claim),
        cmocka_unit_test(the_general_stage_keeps_its_room),
    };
    return cmocka_run_group_tests_name("predicates", tests, NULL, NULL);
}

#endif
