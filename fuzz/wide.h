// Integers of many words, for the fuzz harnesses: exact signs and sums that share no code with the library. Slow and short on
// purpose. A number is an integer times 2^scale, with a scale that the caller chooses for all numbers that meet: see wide_of.
#ifndef PARADT_FUZZ_WIDE_H
#define PARADT_FUZZ_WIDE_H

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { WIDE_WORDS = 700, WIDE_COLUMNS = 10 };

typedef struct wide {
    int sign;                 // -1, 0, 1
    int count;                // words in use; the last one is not 0
    uint32_t word[WIDE_WORDS]; // least significant first
} wide;

static inline uint64_t wide_bits(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

// Returns the exponent of the last bit of the double's format that its significand may use: |x| is a multiple of 2^this.
static inline int wide_scale(double x) {
    int exponent = (int)(wide_bits(x) >> 52 & 2047);
    return (exponent ? exponent : 1) - 1075;
}

// Returns the least of the scale and those of the numbers that are not 0.
static inline int wide_least_scale(const double *x, size_t count, int scale) {
    size_t i;
    for (i = 0; i < count; i++)
        if (x[i] != 0 && wide_scale(x[i]) < scale)
            scale = wide_scale(x[i]);
    return scale;
}

static inline void wide_trim(wide *a) {
    while (a->count && !a->word[a->count - 1])
        a->count--;
    if (!a->count)
        a->sign = 0;
}

// Sets a to x / 2^scale. x: finite; scale: at most wide_scale(x) if x is not 0
static inline void wide_of(wide *a, double x, int scale) {
    uint64_t bits = wide_bits(x), m = bits & (((uint64_t)1 << 52) - 1);
    int shift = wide_scale(x) - scale, i;
    if (bits >> 52 & 2047)
        m |= (uint64_t)1 << 52;
    a->sign = m ? bits >> 63 ? -1 : 1 : 0;
    a->count = 0;
    if (!m)
        return;
    if (shift < 0 || shift / 32 + 3 > WIDE_WORDS)
        abort();
    for (i = 0; i < shift / 32; i++)
        a->word[i] = 0;
    shift %= 32;
    a->word[i] = (uint32_t)(m << shift);
    a->word[i + 1] = (uint32_t)(m >> (32 - shift));
    a->word[i + 2] = (uint32_t)(m >> 32 >> (32 - shift));
    a->count = i + 3;
    wide_trim(a);
}

static inline void wide_small(wide *a, uint32_t value) {
    a->sign = a->count = value != 0;
    a->word[0] = value;
}

// Sets a to 2^exponent.
static inline void wide_power(wide *a, int exponent) {
    if (exponent < 0 || exponent / 32 >= WIDE_WORDS)
        abort();
    memset(a->word, 0, (size_t)(exponent / 32) * sizeof *a->word);
    a->word[exponent / 32] = (uint32_t)1 << exponent % 32;
    a->count = exponent / 32 + 1;
    a->sign = 1;
}

static inline int wide_compare_sizes(const wide *a, const wide *b) {
    int i;
    if (a->count != b->count)
        return a->count < b->count ? -1 : 1;
    for (i = a->count - 1; i >= 0; i--)
        if (a->word[i] != b->word[i])
            return a->word[i] < b->word[i] ? -1 : 1;
    return 0;
}

// a += sign * b
static inline void wide_add(wide *a, const wide *b, int sign) {
    uint64_t carry = 0;
    int64_t borrow = 0;
    int i, order;
    sign *= b->sign;
    if (!sign)
        return;
    if (!a->sign) {
        memcpy(a->word, b->word, (size_t)b->count * sizeof *a->word);
        a->count = b->count;
        a->sign = sign;
        return;
    }
    if (a->sign == sign) {
        for (i = 0; i < a->count || i < b->count || carry; i++) {
            if (i == WIDE_WORDS)
                abort();
            carry += (i < a->count ? a->word[i] : 0);
            carry += (i < b->count ? b->word[i] : 0);
            a->word[i] = (uint32_t)carry;
            carry >>= 32;
        }
        a->count = i > a->count ? i : a->count;
        return;
    }
    order = wide_compare_sizes(a, b);
    for (i = 0; i < a->count || i < b->count; i++) {
        int64_t x = i < a->count ? a->word[i] : 0, y = i < b->count ? b->word[i] : 0;
        borrow += order < 0 ? y - x : x - y;
        a->word[i] = (uint32_t)borrow;
        borrow = borrow < 0 ? -1 : 0;
    }
    a->count = i;
    if (order < 0)
        a->sign = sign;
    wide_trim(a);
}

// out = a * b; out is neither of them
static inline void wide_multiply(wide *out, const wide *a, const wide *b) {
    int i, j;
    out->sign = a->sign * b->sign;
    out->count = 0;
    if (!out->sign)
        return;
    out->count = a->count + b->count;
    if (out->count > WIDE_WORDS)
        abort();
    memset(out->word, 0, (size_t)out->count * sizeof *out->word);
    for (i = 0; i < a->count; i++) {
        uint64_t carry = 0;
        for (j = 0; j < b->count; j++) {
            carry += (uint64_t)a->word[i] * b->word[j] + out->word[i + j];
            out->word[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        out->word[i + j] = (uint32_t)carry;
    }
    wide_trim(out);
}

// Sets minors[set], for each set of at most `columns` rows, to the determinant of these rows' first elements, as many as there
// are rows: along the last of the columns, from smaller sets.
static inline void wide_minors(wide *minors, wide (*row)[WIDE_COLUMNS], int rows, int columns) {
    static wide product;
    unsigned set;
    wide_small(&minors[0], 1);
    for (set = 1; set < 1u << rows; set++) {
        int column = -1, sign = 1, r;
        for (r = 0; r < rows; r++)
            column += (int)(set >> r & 1);
        if (column >= columns)
            continue;
        minors[set].sign = minors[set].count = 0;
        for (r = rows - 1; r >= 0; r--) // from the last element of the column on
            if (set >> r & 1) {
                wide_multiply(&product, &row[r][column], &minors[set & ~(1u << r)]);
                wide_add(&minors[set], &product, sign);
                sign = -sign;
            }
    }
}

// Sets out to the determinant of row[n][n].
static inline void wide_determinant(wide *out, wide (*row)[WIDE_COLUMNS], int n) {
    static wide minors[1 << WIDE_COLUMNS];
    wide_minors(minors, row, n, n);
    out->sign = out->count = 0;
    wide_add(out, &minors[(1u << n) - 1], 1);
}

#endif
