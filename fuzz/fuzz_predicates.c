// Any bytes are decoded to dim + 2 points and weights in 2 to 8 dimensions, in any rounding mode. Then
//     - paradt_orient and paradt_insphere, with and without weights, have to be the signs of determinants of wide integers
//     - so have their forms for two and three dimensions, of doubles and of floats
//     - exchanging two points has to turn each sign over, of whichever points
//     - paradt_insphere_perturbed has to follow the rule that the manual states
//     - measures of a cell have to have the signs of the predicates, and the same bits whatever the order of the vertices
//
// The first four bytes are a header:
//     0  bits 0-2: dimension - 2; bits 3-4: encoding; bit 5: numbers are rounded to floats; bits 6-7: rounding mode
//     1  parameter of the encoding
//     2  bits 0-3, 4-7: the points that are exchanged
//     3  bit 0: measures, too; bits 1-2: a point is made degenerate: the mean of two others, a copy of one, or its mirror
//        image in the mean of others; bits 3-7: of which one
// The points follow: the coordinates of each, and its weight.
#include "fuzz.h"
#include "wide.h"

#include <fenv.h>

enum { MOST_DIM = PARADT_MAX_DIM, MOST_POINTS = MOST_DIM + 2 };

typedef struct few {
    int dim;
    double x[MOST_POINTS][MOST_DIM], w[MOST_POINTS];
    const double *p[MOST_POINTS];
} few;

// --- the signs by wide integers

// Sets row[i][k] to p[i + 1][k] - p[0][k], in units of 2^scale.
static void differences(wide (*row)[WIDE_COLUMNS], int dim, const double *const *p, int rows, int scale) {
    static wide start;
    int i, k;
    for (i = 0; i < rows; i++)
        for (k = 0; k < dim; k++) {
            wide_of(&row[i][k], p[i + 1][k], scale);
            wide_of(&start, p[0][k], scale);
            wide_add(&row[i][k], &start, -1);
        }
}

// Sets *sum to |x|^2, in units of 2^lift. scale: units of the coordinates
static void square_of_length(wide *sum, int dim, const double *x, int scale, int lift) {
    static wide number, factor, square;
    int k;
    sum->sign = sum->count = 0;
    for (k = 0; k < dim; k++) { // x^2 2^-lift is (x 2^-scale) (x 2^(scale - lift))
        wide_of(&number, x[k], scale);
        wide_of(&factor, x[k], lift - scale);
        wide_multiply(&square, &number, &factor);
        wide_add(sum, &square, 1);
    }
}

static int least_scale(int dim, const double *const *p, int points) {
    int scale = 1000, i;
    for (i = 0; i < points; i++)
        scale = wide_least_scale(p[i], (size_t)dim, scale);
    return scale;
}

static int exact_orient(int dim, const double *const *p) {
    static wide row[WIDE_COLUMNS][WIDE_COLUMNS], determinant;
    differences(row, dim, p, dim, least_scale(dim, p, dim + 1));
    wide_determinant(&determinant, row, dim);
    return determinant.sign;
}

typedef struct signs {
    int orient, insphere, power;
} signs;

// The lifted query is below the hyperplane of the cell, if this is positively oriented, where the determinant of differences and
// lifts is negative. All signs are from the same minors of the differences.
static signs exact_signs(int dim, const double *const *p, const double *weights) {
    static wide row[WIDE_COLUMNS][WIDE_COLUMNS], minors[1 << (MOST_DIM + 1)], lifted, base, weight, product;
    static wide round, power; // the determinants without and with weights
    int scale = least_scale(dim, p, dim + 2), lift = wide_least_scale(weights, (size_t)dim + 2, 2 * scale), i;
    signs s;
    differences(row, dim, p, dim + 1, scale);
    wide_minors(minors, row, dim + 1, dim);
    square_of_length(&base, dim, p[0], scale, lift);
    round.sign = round.count = power.sign = power.count = 0;
    for (i = 0; i <= dim; i++) {
        const wide *minor = &minors[((1u << (dim + 1)) - 1) & ~(1u << i)];
        int sign = (dim - i) % 2 ? -1 : 1;
        square_of_length(&lifted, dim, p[i + 1], scale, lift);
        wide_add(&lifted, &base, -1);
        wide_multiply(&product, &lifted, minor);
        wide_add(&round, &product, sign);
        wide_of(&weight, weights[i + 1], lift);
        wide_add(&lifted, &weight, -1);
        wide_of(&weight, weights[0], lift);
        wide_add(&lifted, &weight, 1);
        wide_multiply(&product, &lifted, minor);
        wide_add(&power, &product, sign);
    }
    s.orient = minors[(1u << dim) - 1].sign;
    s.insphere = -round.sign;
    s.power = -power.sign;
    return s;
}

// Is a larger than b in lexicographic order?
static int is_larger(const double *a, const double *b, int dim) {
    int k;
    for (k = 0; k < dim && a[k] == b[k]; k++)
        ;
    return k < dim && a[k] > b[k];
}

// The rule that the manual states under DEGENERATE INPUT: 1 in conflict, -1 not. sign: without perturbation
static int exact_perturbed(int dim, const double *const *p, int sign) {
    const double *other[MOST_POINTS];
    int done = 0, i, largest;
    while (!sign) {
        for (i = 0, largest = -1; i < dim + 2; i++)
            if (!(done >> i & 1) && (largest < 0 || is_larger(p[i], p[largest], dim)))
                largest = i;
        if (largest == dim + 1)
            return -1;
        memcpy(other, p, sizeof other);
        other[largest] = p[dim + 1];
        sign = exact_orient(dim, other);
        done |= 1 << largest;
    }
    return sign;
}

// --- the tests

static void expect_sign(int found, int expected, const char *what) {
    char text[64];
    if (found == expected)
        return;
    snprintf(text, sizeof text, "%d instead of %d", found, expected);
    fail(what, text);
}

static void expect_few_dimensions(const few *f, const double *const *p, int orient, int insphere) {
    float y[MOST_POINTS][3];
    int i, k, floats = f->dim <= 3;
    for (i = 0; i < f->dim + 2 && floats; i++)
        for (k = 0; k < f->dim; k++) {
            float narrow = p[i][k] > 3e38 || p[i][k] < -3e38 ? 0 : (float)p[i][k];
            floats &= (double)narrow == p[i][k];
            y[i][k] = narrow;
        }
    if (f->dim == 2) {
        expect_sign(paradt_orient2(p[0], p[1], p[2]), orient, "orient2");
        expect_sign(paradt_insphere2(p[0], p[1], p[2], p[3]), insphere, "insphere2");
    }
    if (f->dim == 2 && floats) {
        expect_sign(paradt_orient2f(y[0], y[1], y[2]), orient, "orient2f");
        expect_sign(paradt_insphere2f(y[0], y[1], y[2], y[3]), insphere, "insphere2f");
    }
    if (f->dim == 3) {
        expect_sign(paradt_orient3(p[0], p[1], p[2], p[3]), orient, "orient3");
        expect_sign(paradt_insphere3(p[0], p[1], p[2], p[3], p[4]), insphere, "insphere3");
    }
    if (f->dim == 3 && floats) {
        expect_sign(paradt_orient3f(y[0], y[1], y[2], y[3]), orient, "orient3f");
        expect_sign(paradt_insphere3f(y[0], y[1], y[2], y[3], y[4]), insphere, "insphere3f");
    }
}

// All predicates of the points in this order have to have these signs, times `sign`.
static void expect_signs(const few *f, const double *const *p, const double *w, signs s, int sign, const char *what) {
    expect_sign(paradt_orient(f->dim, p), sign * s.orient, what);
    expect_sign(paradt_insphere(f->dim, p, NULL), sign * s.insphere, what);
    expect_sign(paradt_insphere(f->dim, p, w), sign * s.power, what);
    expect_few_dimensions(f, p, sign * s.orient, sign * s.insphere);
}

static void exchange(few *f, int i, int j) {
    const double *p = f->p[i];
    double w = f->w[i];
    f->p[i] = f->p[j];
    f->w[i] = f->w[j];
    f->p[j] = p;
    f->w[j] = w;
}

// Is the query at the place of another point?
static int query_is_a_vertex(const few *f) {
    int i = 0;
    while (i <= f->dim && !is_same_place(f->p[i], f->p[f->dim + 1], (size_t)f->dim))
        i++;
    return i <= f->dim;
}

static void expect_perturbed(few *f, signs s) {
    if (!s.orient || query_is_a_vertex(f))
        return;
    if (s.orient < 0)
        exchange(f, 0, 1);
    expect_sign(paradt_insphere_perturbed(f->dim, f->p, NULL), exact_perturbed(f->dim, f->p, s.orient * s.insphere), "perturbed");
    expect_sign(paradt_insphere_perturbed(f->dim, f->p, f->w), exact_perturbed(f->dim, f->p, s.orient * s.power),
                "perturbed, weights");
    if (s.orient < 0)
        exchange(f, 0, 1);
}

// The numbers have to have the same bits when two vertices are exchanged; the volume turns over.
static void expect_measures(few *f, int orient, int i, int j) {
    double centre[3][MOST_DIM], radius2[3], other[3][MOST_DIM], other2[3];
    double volume = paradt_volume(f->dim, f->p), turned;
    int round = paradt_circumsphere(f->dim, f->p, NULL, centre[0], &radius2[0]);
    int power = paradt_circumsphere(f->dim, f->p, f->w, centre[1], &radius2[1]);
    int centred = paradt_is_self_centred(f->dim, f->p, f->w);
    unsigned on = paradt_enclosing_sphere(f->dim, f->p, centre[2], &radius2[2]), moved = on;
    size_t size = (size_t)f->dim * sizeof(double);
    if (volume * orient < 0 || (volume != 0 && !orient))
        fail("volume", "it has another sign than the orientation");
    if (round != (orient != 0) || power != round)
        fail("circumsphere", "it is there where the cell is flat, or the other way round");
    exchange(f, i, j);
    turned = paradt_volume(f->dim, f->p);
    if (turned != -volume)
        fail("volume", "it depends on the order of the vertices");
    if (paradt_circumsphere(f->dim, f->p, NULL, other[0], &other2[0]) != round ||
        (round && (memcmp(centre[0], other[0], size) || radius2[0] != other2[0])))
        fail("circumsphere", "it depends on the order of the vertices");
    if (paradt_circumsphere(f->dim, f->p, f->w, other[1], &other2[1]) != power ||
        (power && (memcmp(centre[1], other[1], size) || radius2[1] != other2[1])))
        fail("circumsphere with weights", "it depends on the order of the vertices");
    if (paradt_is_self_centred(f->dim, f->p, f->w) != centred)
        fail("self-centred", "it depends on the order of the vertices");
    moved &= ~(1u << i | 1u << j);
    moved |= (on >> i & 1) << j | (on >> j & 1) << i;
    if (paradt_enclosing_sphere(f->dim, f->p, other[2], &other2[2]) != moved || memcmp(centre[2], other[2], size) ||
        radius2[2] != other2[2])
        fail("enclosing sphere", "it depends on the order of the vertices");
    exchange(f, i, j);
}

// Makes a point depend on others: `kind` 1: their mean; 2: a copy; 3: a mirror image, as on lattices
static void degenerate(few *f, int kind, int which) {
    int count = f->dim + 2, at = which % count, a = (at + 1) % count, b = (at + 2) % count, c = (at + 3) % count, k;
    for (k = 0; k < f->dim && kind; k++) {
        double x = f->x[a][k], y = f->x[b][k], z = f->x[c][k];
        double made = kind == 1 ? x / 2 + y / 2 : kind == 2 ? x : x + y - z;
        f->x[at][k] = is_finite(made) ? made : x;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const int modes[4] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    source b = {data, size};
    few f;
    int flags = next_byte(&b), parameter = next_byte(&b), swap = next_byte(&b), extras = next_byte(&b), i, k;
    int encoding = flags >> 3 & 3, first, second;
    signs exact;
    f.dim = 2 + (flags & 7) % (MOST_DIM - 1);
    if (f.dim > 4 && encoding >= SCALED) // numbers of thousands of bits take too long there
        encoding -= SCALED;
    for (i = 0; i < f.dim + 2; i++) {
        for (k = 0; k < f.dim; k++)
            f.x[i][k] = next_number(&b, encoding, parameter, 0);
        f.w[i] = next_number(&b, encoding, parameter, 0);
        for (k = 0; k < f.dim && flags >> 5 & 1; k++)
            f.x[i][k] = f.x[i][k] > 3e38 || f.x[i][k] < -3e38 ? 0 : (double)(float)f.x[i][k];
        f.p[i] = f.x[i];
    }
    degenerate(&f, extras >> 1 & 3, extras >> 3);
    exact = exact_signs(f.dim, f.p, f.w);

    fesetround(modes[flags >> 6]);
    expect_signs(&f, f.p, f.w, exact, 1, "as decoded");
    expect_perturbed(&f, exact);
    first = (swap & 15) % (f.dim + 1);
    second = (swap >> 4) % (f.dim + 1);
    if (first != second) {
        exchange(&f, first, second);
        expect_signs(&f, f.p, f.w, exact, -1, "two vertices exchanged");
        exchange(&f, first, second);
    }
    exchange(&f, first, f.dim + 1); // the orientation is that of other points then
    expect_sign(paradt_insphere(f.dim, f.p, NULL), -exact.insphere, "query and vertex exchanged");
    expect_sign(paradt_insphere(f.dim, f.p, f.w), -exact.power, "query and vertex exchanged, weights");
    exchange(&f, first, f.dim + 1);
    if (extras & 1 && first != second && f.dim <= 5)
        expect_measures(&f, exact.orient, first, second);
    fesetround(FE_TONEAREST);
    return 0;
}
