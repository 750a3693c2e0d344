// paradt_points.h - point sets by name: gen:KIND:N:SEED
//
// In one file: #define PARADT_POINTS_IMPLEMENTATION, then #include "paradt_points.h". Needs C99 and nothing else.
//
// The same name gives the same bits on every machine, under every compiler flag and rounding mode: all arithmetic is on
// 64-bit integers, and only the last step assembles a double, from an integer and a power of two. Each point has its
// own random stream, so any part of a set can be generated without the rest, for instance by one MPI rank.

#ifndef PARADT_POINTS_H
#define PARADT_POINTS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { PARADT_GEN_MAX_DIM = 8 };

typedef struct paradt_gen_spec {
    int kind;      // row of the table of kinds
    size_t count;  // points in the whole set
    uint64_t seed; // 1 if the text has none
} paradt_gen_spec;

int paradt_gen_kinds(void);             // number of kinds
const char *paradt_gen_name(int kind);  // name of the kind in gen:KIND:N:SEED
const char *paradt_gen_about(int kind); // description of the kind in one line
int paradt_gen_find(const char *name);  // row of the kind with this name, or -1

// Reads "gen:KIND:N:SEED" or "gen:KIND:N" (N as 1000000 or 1e6). Returns NULL, or what is wrong with the text.
const char *paradt_gen_parse(paradt_gen_spec *spec, const char *text);

// Generates points first .. first + count - 1 of the set. dim: 2..8; coordinates: [count][dim]
void paradt_gen_points(const paradt_gen_spec *spec, int dim, size_t first, size_t count, double *coordinates);
// Generates the weights of these points, about as large as the squared distance of neighbours. weights: [count]
void paradt_gen_weights(const paradt_gen_spec *spec, int dim, size_t first, size_t count, double *weights);

#ifdef __cplusplus
}
#endif

#endif // PARADT_POINTS_H

#ifdef PARADT_POINTS_IMPLEMENTATION
#ifndef PARADT_POINTS_IMPLEMENTATION_DONE
#define PARADT_POINTS_IMPLEMENTATION_DONE

#include <string.h>

// ---------------------------------------------------------------------------------------------------------------------
// >>numbers: random and fixed-point arithmetic in 64-bit integers
// "Qn" means that an integer i stands for i * 2^-n.

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014), a bijection whose output shows no pattern of the input.
static uint64_t paradt_gen__mix(uint64_t z) {
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static uint64_t paradt_gen__next(uint64_t *state) {
    *state += UINT64_C(0x9e3779b97f4a7c15);
    return paradt_gen__mix(*state);
}

// Returns the stream of element `index` of the set `seed`. use: separates the streams of points, weights and centres
static uint64_t paradt_gen__stream(uint64_t seed, uint64_t use, uint64_t index) {
    return paradt_gen__mix(paradt_gen__mix(seed * 8 + use) + index);
}

// Returns a random number from 0 to bound - 1.
static uint64_t paradt_gen__below(uint64_t *state, uint64_t bound) {
    return paradt_gen__next(state) % bound;
}

// Returns magnitude * 2^exponent with the sign, truncated to 53 bits, or to the multiples of 2^-1074.
static double paradt_gen__real(int negative, uint64_t magnitude, int exponent) {
    uint64_t bits = magnitude;
    double value;
    while (bits >> 53 || (bits && exponent < -1074)) {
        bits >>= 1;
        exponent++;
    }
    while (bits && bits < UINT64_C(1) << 52 && exponent > -1074) {
        bits <<= 1;
        exponent--;
    }
    if (bits >> 52) // a normal number: its leading bit is implied
        bits = (bits & ((UINT64_C(1) << 52) - 1)) | ((uint64_t)(exponent + 1075) << 52);
    bits |= (uint64_t)(negative != 0) << 63;
    if (magnitude == 0)
        bits = 0;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static double paradt_gen__signed(int64_t value, int exponent) {
    return paradt_gen__real(value < 0, value < 0 ? UINT64_C(0) - (uint64_t)value : (uint64_t)value, exponent);
}

// Returns the upper 64 bits of the product.
static uint64_t paradt_gen__high(uint64_t a, uint64_t b) {
    uint64_t low = (a & 0xffffffff) * (b & 0xffffffff);
    uint64_t left = (a >> 32) * (b & 0xffffffff) + (low >> 32);
    uint64_t right = (a & 0xffffffff) * (b >> 32) + (left & 0xffffffff);
    return (a >> 32) * (b >> 32) + (left >> 32) + (right >> 32);
}

// Returns the upper 64 bits of the product, rounded towards zero.
static int64_t paradt_gen__times(int64_t a, uint64_t b) {
    return a < 0 ? -(int64_t)paradt_gen__high((uint64_t)-a, b) : (int64_t)paradt_gen__high((uint64_t)a, b);
}

// Returns the square root: the largest root below 2^63 with root * root / 2^64 <= square. Of a number in Qn the root is
// in Q(n / 2 + 32).
static uint64_t paradt_gen__root(uint64_t square) {
    uint64_t root = 0, bit;
    for (bit = UINT64_C(1) << 62; bit; bit >>= 1)
        if (paradt_gen__high(root | bit, root | bit) <= square)
            root |= bit;
    return root;
}

// Returns a / b in Q60. a <= b < 2^63
static uint64_t paradt_gen__ratio(uint64_t a, uint64_t b) {
    uint64_t quotient = a == b;
    int i;
    if (a == b)
        return UINT64_C(1) << 60;
    for (i = 0; i < 60; i++) {
        a <<= 1;
        quotient = quotient << 1 | (a >= b);
        if (a >= b)
            a -= b;
    }
    return quotient;
}

// Returns 1 with probability exp(-1/2): if a decreasing run of uniform numbers, begun below 1/2, has even length.
static int paradt_gen__half(uint64_t *state) {
    uint64_t last = UINT64_C(1) << 63, u;
    int even = 1;
    while ((u = paradt_gen__next(state)) < last) {
        last = u;
        even = !even;
    }
    return even;
}

// Returns 1 with probability exp(-x (2k + x) / (2k + 2)). x: in Q64
static int paradt_gen__fits(uint64_t *state, uint64_t k, uint64_t x) {
    uint64_t y = x, z, side;
    int even = 1;
    while ((z = paradt_gen__next(state)) < y) {
        side = paradt_gen__below(state, 2 * k + 2);
        if (side > 2 * k || (side == 2 * k && paradt_gen__next(state) >= x))
            break;
        y = z;
        even = !even;
    }
    return even;
}

// Returns a normal deviate in Q60. This is Karney's algorithm N ("Sampling exactly from the normal distribution", TOMS
// 42, 2016), which only compares random integers. A deviate of 8 or more, one in 10^15, is rejected.
static int64_t paradt_gen__gauss(uint64_t *state) {
    for (;;) {
        uint64_t k = 0, i, x;
        while (paradt_gen__half(state))
            k++;
        for (i = 0; i < k * (k - 1) && k > 1 && paradt_gen__half(state);)
            i++;
        if (k > 7 || (k > 1 && i < k * (k - 1)))
            continue;
        x = paradt_gen__next(state);
        for (i = 0; i <= k && paradt_gen__fits(state, k, x);)
            i++;
        if (i <= k)
            continue;
        x = (k << 60) | (x >> 4);
        return paradt_gen__next(state) >> 63 ? -(int64_t)x : (int64_t)x;
    }
}

// Generates a uniformly distributed unit vector, in Q60: a vector of normal deviates divided by its length.
static void paradt_gen__direction(uint64_t *state, int dim, int64_t *unit) {
    uint64_t square, length;
    int k;
    do { // rejects long vectors, which overflow, and those below 1/2, which lose digits; the direction is independent
        for (square = 0, k = 0; k < dim; k++) {
            uint64_t part;
            unit[k] = paradt_gen__gauss(state);
            part = (uint64_t)(unit[k] < 0 ? -unit[k] : unit[k]);
            square += paradt_gen__high(part, part); // Q56
            if (square >> 62)
                break;
        }
    } while (square >> 62 || square < UINT64_C(1) << 54);
    length = paradt_gen__root(square); // Q60, rounded down, so a single part may be longer
    for (k = 0; k < dim; k++) {
        uint64_t part = (uint64_t)(unit[k] < 0 ? -unit[k] : unit[k]);
        int64_t ratio = (int64_t)paradt_gen__ratio(part < length ? part : length, length);
        unit[k] = unit[k] < 0 ? -ratio : ratio;
    }
}

// Returns the sine in Q61 of a fraction of a quarter turn, by the Taylor series. fraction: in Q64
static int64_t paradt_gen__sine(uint64_t fraction) {
    uint64_t x = paradt_gen__high(fraction, UINT64_C(0xc90fdaa22168c234)) >> 2; // times pi / 2, which is in Q63: Q61
    uint64_t square = paradt_gen__high(x, x) << 3;                              // Q61
    uint64_t term = x;
    int64_t sum = (int64_t)x;
    unsigned k;
    for (k = 2; term; k += 2) {
        term = (paradt_gen__high(term, square) << 3) / (k * (k + 1));
        sum += k % 4 == 2 ? -(int64_t)term : (int64_t)term;
    }
    return sum;
}

// Computes the cosine and sine, in Q61, of an angle. turn: the angle in turns, in Q64
static void paradt_gen__circle(uint64_t turn, int64_t *cosine, int64_t *sine) {
    uint64_t fraction = turn << 2;
    int64_t rise = paradt_gen__sine(fraction), fall = paradt_gen__sine(~fraction);
    switch (turn >> 62) {
    case 0:
        *cosine = fall, *sine = rise;
        break;
    case 1:
        *cosine = -rise, *sine = fall;
        break;
    case 2:
        *cosine = -fall, *sine = -rise;
        break;
    default:
        *cosine = rise, *sine = -fall;
        break;
    }
}

// ---------------------------------------------------------------------------------------------------------------------
// >>kinds: one function and one row of the table each

typedef struct paradt_gen__point {
    int dim;
    size_t count; // points in the whole set
    size_t index; // of this point in the set
    uint64_t seed;
    uint64_t state; // random stream of this point
} paradt_gen__point;

enum { PARADT_GEN__POINTS, PARADT_GEN__WEIGHTS, PARADT_GEN__CENTRES };

// Returns the smallest side with side^dim >= count.
static uint64_t paradt_gen__side(size_t count, int dim) {
    uint64_t side = 1, volume;
    for (;; side++) {
        int k;
        for (volume = 1, k = 0; k < dim && volume < count; k++)
            volume *= side;
        if (volume >= count)
            return side;
    }
}

// digits: [dim], lowest first
static void paradt_gen__digits(uint64_t number, uint64_t base, int dim, uint64_t *digits) {
    int k;
    for (k = 0; k < dim; k++) {
        digits[k] = number % base;
        number /= base;
    }
}

// Fills coordinates from .. to - 1 with uniform numbers of the unit interval.
static void paradt_gen__fill(uint64_t *state, int from, int to, double *x) {
    for (; from < to; from++)
        x[from] = paradt_gen__real(0, paradt_gen__next(state) >> 11, -53);
}

static void paradt_gen__uniform(paradt_gen__point *p, double *x) {
    paradt_gen__fill(&p->state, 0, p->dim, x);
}

static void paradt_gen__normal(paradt_gen__point *p, double *x) {
    int k;
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__signed(paradt_gen__gauss(&p->state), -60);
}

static void paradt_gen__sphere(paradt_gen__point *p, double *x) {
    int64_t unit[PARADT_GEN_MAX_DIM];
    int k;
    paradt_gen__direction(&p->state, p->dim, unit);
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__signed(unit[k], -60);
}

// Returns the radius, in Q64, of a uniform point of the unit ball. It is distributed as the largest of dim uniform
// numbers.
static uint64_t paradt_gen__radius(uint64_t *state, int dim) {
    uint64_t largest = 0, u;
    for (; dim > 0; dim--)
        if ((u = paradt_gen__next(state)) > largest)
            largest = u;
    return largest;
}

static void paradt_gen__ball(paradt_gen__point *p, double *x) {
    int64_t unit[PARADT_GEN_MAX_DIM];
    uint64_t radius = paradt_gen__radius(&p->state, p->dim);
    int k;
    paradt_gen__direction(&p->state, p->dim, unit);
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__signed(paradt_gen__times(unit[k], radius), -60);
}

static void paradt_gen__clusters(paradt_gen__point *p, double *x) {
    uint64_t centre = paradt_gen__stream(p->seed, PARADT_GEN__CENTRES, paradt_gen__below(&p->state, 100));
    int k;
    for (k = 0; k < p->dim; k++) {
        int64_t away = paradt_gen__times(paradt_gen__gauss(&p->state), UINT64_C(18446744073709552)); // 0.001 in Q64
        x[k] = paradt_gen__signed((int64_t)(paradt_gen__next(&centre) >> 4) + away, -60);
    }
}

// Plummer's star cluster (1911), cut off at ten scale radii. A fraction y^3 of the mass is within y / sqrt(1 - y^2).
static void paradt_gen__plummer(paradt_gen__point *p, double *x) {
    int64_t unit[PARADT_GEN_MAX_DIM];
    uint64_t y, square, rest, radius;
    int k;
    do {
        y = paradt_gen__radius(&p->state, p->dim) >> 2; // Q62
        square = paradt_gen__high(y, y);                // Q60
        rest = (UINT64_C(1) << 60) - square;
    } while (rest < square / 100);
    radius = paradt_gen__ratio(y >> 4, paradt_gen__root(rest)) << 4; // Q60, at most 10
    paradt_gen__direction(&p->state, p->dim, unit);
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__signed(paradt_gen__times(unit[k] * 4, radius), -58);
}

static void paradt_gen__lattice(paradt_gen__point *p, double *x) {
    uint64_t digits[PARADT_GEN_MAX_DIM];
    int k;
    paradt_gen__digits(p->index, paradt_gen__side(p->count, p->dim), p->dim, digits);
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__real(0, digits[k], 0);
}

// Integer points whose coordinates have an even sum; in 3D the face-centred cubic lattice.
static void paradt_gen__fcc(paradt_gen__point *p, double *x) {
    uint64_t digits[PARADT_GEN_MAX_DIM], sum = 0;
    int k;
    paradt_gen__digits(p->index, paradt_gen__side(2 * p->count, p->dim), p->dim, digits);
    for (k = 0; k + 1 < p->dim; k++) {
        sum += digits[k];
        x[k] = paradt_gen__real(0, digits[k], 0);
    }
    x[k] = paradt_gen__real(0, 2 * digits[k] + sum % 2, 0);
}

// Integer points whose coordinates are all even or all odd; in 3D the body-centred cubic lattice.
static void paradt_gen__bcc(paradt_gen__point *p, double *x) {
    uint64_t digits[PARADT_GEN_MAX_DIM];
    int k;
    paradt_gen__digits(p->index / 2, paradt_gen__side(p->count / 2 + 1, p->dim), p->dim, digits);
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__real(0, 2 * digits[k] + p->index % 2, 0);
}

static void paradt_gen__jitter(paradt_gen__point *p, double *x) {
    uint64_t digits[PARADT_GEN_MAX_DIM];
    int k;
    paradt_gen__digits(p->index, paradt_gen__side(p->count, p->dim), p->dim, digits);
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__real(0, (digits[k] << 40) + (paradt_gen__next(&p->state) >> 44), -40);
}

static void paradt_gen__plane(paradt_gen__point *p, double *x) {
    paradt_gen__fill(&p->state, 0, p->dim - 1, x);
    x[p->dim - 1] = paradt_gen__real(0, paradt_gen__next(&p->state) >> 11, -73);
}

// Fifty turns; in two dimensions a spiral. From the fourth on the coordinates are uniform.
static void paradt_gen__helix(paradt_gen__point *p, double *x) {
    uint64_t t = paradt_gen__next(&p->state);
    int64_t cosine, sine;
    paradt_gen__circle(t * 50, &cosine, &sine);
    if (p->dim == 2) {
        cosine = paradt_gen__times(cosine, t);
        sine = paradt_gen__times(sine, t);
    }
    x[0] = paradt_gen__signed(cosine, -61);
    x[1] = paradt_gen__signed(sine, -61);
    if (p->dim > 2)
        x[2] = paradt_gen__real(0, t >> 11, -53);
    paradt_gen__fill(&p->state, 3, p->dim, x);
}

static void paradt_gen__cube_surface(paradt_gen__point *p, double *x) {
    uint64_t facet = paradt_gen__below(&p->state, 2 * (uint64_t)p->dim);
    paradt_gen__fill(&p->state, 0, p->dim, x);
    x[facet / 2] = paradt_gen__real(0, facet % 2, 0);
}

static void paradt_gen__cylinder(paradt_gen__point *p, double *x) {
    int64_t unit[2];
    paradt_gen__direction(&p->state, 2, unit);
    x[0] = paradt_gen__signed(unit[0], -60);
    x[1] = paradt_gen__signed(unit[1], -60);
    paradt_gen__fill(&p->state, 2, p->dim, x);
}

// Rotates (1, 0, ..., 0) by the angles of Pythagorean triples in random coordinate planes, and multiplies by the
// hypotenuse after each rotation. The points are integer and all have the same distance from the origin: the product of
// the hypotenuses, which is below 2^38.
static void paradt_gen__cospherical(paradt_gen__point *p, double *x) {
    static const int triples[8][3] = {{3, 4, 5},    {5, 12, 13}, {8, 15, 17},  {20, 21, 29},
                                      {12, 35, 37}, {9, 40, 41}, {28, 45, 53}, {11, 60, 61}};
    int64_t v[PARADT_GEN_MAX_DIM] = {1};
    int i, k;
    for (i = 0; i < 8; i++) {
        int one = (int)paradt_gen__below(&p->state, (uint64_t)p->dim);
        int other = (one + 1 + (int)paradt_gen__below(&p->state, (uint64_t)p->dim - 1)) % p->dim;
        int swap = (int)paradt_gen__below(&p->state, 2);
        int64_t c = triples[i][swap], s = triples[i][1 - swap], a = v[one], b = v[other];
        if (paradt_gen__below(&p->state, 2))
            c = -c;
        for (k = 0; k < p->dim; k++)
            v[k] *= triples[i][2];
        v[one] = c * a - s * b;
        v[other] = s * a + c * b;
    }
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__signed(v[k], 0);
}

static void paradt_gen__collinear(paradt_gen__point *p, double *x) {
    int64_t t = (int64_t)(paradt_gen__next(&p->state) >> 40);
    int k;
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__signed((k + 1) * t - 1000, 0);
}

static void paradt_gen__line(paradt_gen__point *p, double *x) {
    int64_t t = (int64_t)(paradt_gen__next(&p->state) >> 2);
    int k;
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__signed(paradt_gen__times(t, UINT64_MAX / (2 * (uint64_t)k + 3)), -62);
}

static void paradt_gen__coplanar(paradt_gen__point *p, double *x) {
    int64_t last = 0;
    int k;
    for (k = 0; k + 1 < p->dim; k++) {
        int64_t t = (int64_t)(paradt_gen__next(&p->state) >> 44);
        x[k] = paradt_gen__signed(t, 0);
        last += (k + 1) * t;
    }
    x[k] = paradt_gen__signed(last, 0);
}

static void paradt_gen__duplicates(paradt_gen__point *p, double *x) {
    uint64_t which = paradt_gen__below(&p->state, p->count / 10 + 1);
    uint64_t state = paradt_gen__stream(p->seed, PARADT_GEN__CENTRES, which);
    paradt_gen__fill(&state, 0, p->dim, x);
}

static void paradt_gen__ulp(paradt_gen__point *p, double *x) {
    uint64_t side = 2 * paradt_gen__side(p->count, p->dim);
    int k;
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__real(0, (UINT64_C(1) << 52) + paradt_gen__below(&p->state, side), -52);
}

static double paradt_gen__wide(uint64_t *state) {
    uint64_t draw = paradt_gen__next(state);
    return paradt_gen__real((int)(draw & 1), draw >> 11 | UINT64_C(1) << 52,
                            (int)paradt_gen__below(state, 601) - 300 - 52);
}

static void paradt_gen__mixed(paradt_gen__point *p, double *x) {
    int k;
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__wide(&p->state);
}

static void paradt_gen__subnormal(paradt_gen__point *p, double *x) {
    int k;
    for (k = 0; k < p->dim; k++) {
        uint64_t draw = paradt_gen__next(&p->state);
        x[k] = paradt_gen__real((int)(draw & 1), draw >> 44, -1074);
    }
}

static void paradt_gen__huge(paradt_gen__point *p, double *x) {
    int k;
    for (k = 0; k < p->dim; k++) {
        uint64_t draw = paradt_gen__next(&p->state);
        uint64_t size = paradt_gen__high(draw, UINT64_C(0xf21ad68ec3279800)); // 1.7e308 / 2^1024 in Q64
        x[k] = paradt_gen__real((int)(draw & 1), size, 1024 - 64);
    }
}

static void paradt_gen__moment(paradt_gen__point *p, double *x) {
    uint64_t t = paradt_gen__next(&p->state), power = t;
    int k;
    for (k = 0; k < p->dim; k++) {
        x[k] = paradt_gen__real(0, power, -64);
        power = paradt_gen__high(power, t);
    }
}

// In 3D any segment of one line and any segment of the other span a cell.
static void paradt_gen__skew_lines(paradt_gen__point *p, double *x) {
    int k, odd = (int)(p->index % 2);
    for (k = 0; k < p->dim; k++)
        x[k] = paradt_gen__real(0, (uint64_t)(odd && k == p->dim - 1), 0);
    paradt_gen__fill(&p->state, p->dim > 2 ? odd : 0, (p->dim > 2 ? odd : 0) + 1, x);
}

enum { PARADT_GEN__SPACING = INT32_MAX, PARADT_GEN__WIDE = INT32_MAX - 1 };

static const struct {
    const char *name;
    const char *about;
    void (*make)(paradt_gen__point *point, double *x);
    int weight; // weights are 0..15 times 2^weight; SPACING: times the squared spacing; WIDE: of all magnitudes
} paradt_gen__table[] = {
    {"uniform", "uniform in the unit cube", paradt_gen__uniform, PARADT_GEN__SPACING},
    {"gauss", "normal, of deviation 1", paradt_gen__normal, PARADT_GEN__SPACING},
    {"ball", "uniform in the unit ball", paradt_gen__ball, PARADT_GEN__SPACING},
    {"sphere", "on the unit sphere, rounded", paradt_gen__sphere, PARADT_GEN__SPACING},
    {"clusters", "100 normal clusters of deviation 0.001 in the unit cube", paradt_gen__clusters, PARADT_GEN__SPACING},
    {"plummer", "a star cluster: Plummer's model up to ten scale radii", paradt_gen__plummer, PARADT_GEN__SPACING},
    {"lattice", "the integer lattice", paradt_gen__lattice, -2},
    {"fcc", "integer points of even sum: face-centred cubic", paradt_gen__fcc, -2},
    {"bcc", "integer points all even or all odd: body-centred cubic", paradt_gen__bcc, -2},
    {"jitter", "the integer lattice shaken by up to 2^-20", paradt_gen__jitter, -2},
    {"plane", "uniform within 2^-20 of a coordinate plane", paradt_gen__plane, PARADT_GEN__SPACING},
    {"helix", "fifty turns of a helix, rounded", paradt_gen__helix, PARADT_GEN__SPACING},
    {"cube-surface", "on the facets of the unit cube, exactly", paradt_gen__cube_surface, PARADT_GEN__SPACING},
    {"cylinder", "on a unit circle times a cube, rounded", paradt_gen__cylinder, PARADT_GEN__SPACING},
    {"cospherical", "integer points exactly on one sphere", paradt_gen__cospherical, 0},
    {"collinear", "integer points exactly on one line", paradt_gen__collinear, 0},
    {"line", "on a slanting line, rounded", paradt_gen__line, PARADT_GEN__SPACING},
    {"coplanar", "integer points exactly in one hyperplane", paradt_gen__coplanar, 0},
    {"duplicates", "uniform, each about ten times", paradt_gen__duplicates, PARADT_GEN__SPACING},
    {"ulp", "1 plus a few units in the last place", paradt_gen__ulp, -106},
    {"mixed", "magnitudes from 2^-300 to 2^300, both signs", paradt_gen__mixed, PARADT_GEN__WIDE},
    {"subnormal", "multiples of the smallest positive double", paradt_gen__subnormal, -1074},
    {"huge", "uniform up to 1.7e308, both signs", paradt_gen__huge, 1000},
    {"moment", "the moment curve (t, t^2, ...): most cells a point", paradt_gen__moment, PARADT_GEN__SPACING},
    {"skew-lines", "two skew lines: quadratically many cells in 3D", paradt_gen__skew_lines, PARADT_GEN__SPACING},
};

int paradt_gen_kinds(void) {
    return (int)(sizeof paradt_gen__table / sizeof paradt_gen__table[0]);
}

const char *paradt_gen_name(int kind) {
    return paradt_gen__table[kind].name;
}

const char *paradt_gen_about(int kind) {
    return paradt_gen__table[kind].about;
}

static int paradt_gen__find(const char *name, size_t length) {
    int kind;
    for (kind = 0; kind < paradt_gen_kinds(); kind++)
        if (strlen(paradt_gen_name(kind)) == length && memcmp(paradt_gen_name(kind), name, length) == 0)
            return kind;
    return -1;
}

int paradt_gen_find(const char *name) {
    return paradt_gen__find(name, strlen(name));
}

// Reads a decimal integer. Returns the number of digits; 0 if there are none or the number does not fit.
static size_t paradt_gen__natural(const char *text, uint64_t *value) {
    size_t n = 0;
    for (*value = 0; text[n] >= '0' && text[n] <= '9'; n++) {
        uint64_t digit = (uint64_t)(text[n] - '0');
        if (*value > (UINT64_MAX - digit) / 10)
            return 0;
        *value = *value * 10 + digit;
    }
    return n;
}

const char *paradt_gen_parse(paradt_gen_spec *spec, const char *text) {
    uint64_t value, power = 0;
    size_t n;
    const char *name = text + 4, *at;
    if (strncmp(text, "gen:", 4) != 0 || !strchr(name, ':'))
        return "not of the form gen:KIND:N:SEED";
    at = strchr(name, ':');
    spec->kind = paradt_gen__find(name, (size_t)(at - name));
    spec->seed = 1;
    if (spec->kind < 0)
        return "no such kind of points (--help lists them)";
    n = paradt_gen__natural(++at, &value);
    at += n;
    if (n && (*at == 'e' || *at == 'E'))
        at += 1 + (n = paradt_gen__natural(at + 1, &power));
    if (!n)
        return "the number of points is not a whole number, or is too large";
    for (; power && value; power--) {
        if (value > UINT64_MAX / 10)
            return "the number of points is too large";
        value *= 10;
    }
    if (value > SIZE_MAX / (sizeof(double) * (PARADT_GEN_MAX_DIM + 1)))
        return "the number of points is too large";
    spec->count = (size_t)value;
    if (*at == ':')
        at += 1 + (n = paradt_gen__natural(at + 1, &spec->seed));
    return n && !*at ? NULL : "the seed is not a whole number below 2^64";
}

void paradt_gen_points(const paradt_gen_spec *spec, int dim, size_t first, size_t count, double *coordinates) {
    paradt_gen__point point = {0, 0, 0, 0, 0};
    size_t i;
    point.dim = dim;
    point.count = spec->count;
    point.seed = spec->seed;
    for (i = 0; i < count; i++) {
        point.index = first + i;
        point.state = paradt_gen__stream(spec->seed, PARADT_GEN__POINTS, point.index);
        paradt_gen__table[spec->kind].make(&point, coordinates + i * (size_t)dim);
    }
}

// Returns an exponent of 2: the power is about 1/16 of the squared mean distance of `count` points in a unit cube.
static int paradt_gen__spacing(size_t count, int dim) {
    int log = 0;
    for (; count > 1; count /= 2)
        log++;
    return -2 * (log / dim) - 4;
}

void paradt_gen_weights(const paradt_gen_spec *spec, int dim, size_t first, size_t count, double *weights) {
    int unit = paradt_gen__table[spec->kind].weight;
    size_t i;
    if (unit == PARADT_GEN__SPACING)
        unit = paradt_gen__spacing(spec->count, dim);
    for (i = 0; i < count; i++) {
        uint64_t state = paradt_gen__stream(spec->seed, PARADT_GEN__WEIGHTS, first + i);
        if (unit == PARADT_GEN__WIDE)
            weights[i] = paradt_gen__wide(&state);
        else
            weights[i] = paradt_gen__real(0, paradt_gen__below(&state, 16), unit);
    }
}

#endif // PARADT_POINTS_IMPLEMENTATION_DONE
#endif // PARADT_POINTS_IMPLEMENTATION
