// Families of points, one row each: name, generator, what is special about them. Every generator works in 2 to 8 dimensions and
// depends on the seed alone, so a failing sample can be made again. Lattices keep a random subset of their sites in random order.
#ifndef FAMILIES_H
#define FAMILIES_H

#include "cells.h"

#include <math.h>

// splitmix64
static inline uint64_t random_bits(uint64_t *state) {
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline double random_unit(uint64_t *state) { return (double)(random_bits(state) >> 11) * 0x1p-53; }

static inline int random_below(uint64_t *state, int bound) { return (int)(random_bits(state) % (uint64_t)bound); }

static inline double random_gauss(uint64_t *state) {
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += random_unit(state);
    return sum;
}

static inline void shuffle(int *order, int count, uint64_t *state) {
    for (int i = 0; i < count; i++)
        order[i] = i;
    for (int i = count - 1; i > 0; i--) {
        int j = random_below(state, i + 1), t = order[i];
        order[i] = order[j];
        order[j] = t;
    }
}

// Loops over the points of a sample; x is the address of the point's coordinates.
#define FOR_EACH_POINT(s, x)                                                                                           \
    for (double *x = (s)->x; x < (s)->x + (s)->count * (s)->dim; x += (s)->dim)

static inline void points_uniform(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = random_unit(seed);
}

static inline void points_gauss(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = random_gauss(seed);
}

static inline void direction(double *x, int dim, uint64_t *seed) {
    double norm = 0;
    for (int k = 0; k < dim; k++) {
        x[k] = random_gauss(seed);
        norm += x[k] * x[k];
    }
    for (int k = 0; k < dim; k++)
        x[k] /= sqrt(norm);
}

static inline void points_sphere(sample *s, uint64_t *seed) {
    FOR_EACH_POINT(s, x)
    direction(x, s->dim, seed);
}

// Points in a thin shell around a sphere: 2^-11 to 2^-50 of the radius, thinner on one half. Its centre is not the origin.
static inline void points_rough_sphere(sample *s, uint64_t *seed) {
    double roughness = ldexp(1, -11 - random_below(seed, 40));
    FOR_EACH_POINT(s, x) {
        direction(x, s->dim, seed);
        double radius = 1 + (x[0] > 0 ? roughness : roughness / 64) * (random_unit(seed) - 0.5);
        for (int k = 0; k < s->dim; k++)
            x[k] = 0.25 * k + radius * x[k];
    }
}

static inline void points_clusters(sample *s, uint64_t *seed) {
    double centres[10][CELLS_MAX_DIM];
    for (int i = 0; i < 10; i++)
        for (int k = 0; k < s->dim; k++)
            centres[i][k] = random_unit(seed);
    FOR_EACH_POINT(s, x) {
        int centre = random_below(seed, 10);
        for (int k = 0; k < s->dim; k++)
            x[k] = centres[centre][k] + 0.001 * random_gauss(seed);
    }
}

static inline void points_plummer(sample *s, uint64_t *seed) {
    FOR_EACH_POINT(s, x) {
        double radius = 1 / sqrt(pow(1 - random_unit(seed) * 0.999, -2.0 / 3) - 0.999);
        direction(x, s->dim, seed);
        for (int k = 0; k < s->dim; k++)
            x[k] *= radius;
    }
}

// Fills s with a random choice of the integer points in [0, side)^dim that keep() accepts, for the smallest side that has enough.
static inline void fill_from_lattice(sample *s, uint64_t *seed, int (*keep)(const int *at, int dim, int side)) {
    for (int side = 2;; side++) {
        int at[CELLS_MAX_DIM] = {0}, found = 0, k;
        double *sites;
        for (int pass = 0; pass < 2; pass++) {
            sites = pass ? (double *)need((size_t)found * (size_t)s->dim, sizeof(double)) : NULL;
            found = 0;
            do {
                if (keep(at, s->dim, side)) {
                    for (k = 0; pass && k < s->dim; k++)
                        sites[found * s->dim + k] = at[k];
                    found++;
                }
                for (k = 0; k < s->dim && ++at[k] == side; k++)
                    at[k] = 0;
            } while (k < s->dim);
            if (found < s->count)
                break;
        }
        if (found >= s->count) {
            int *order = (int *)need((size_t)found, sizeof(int));
            shuffle(order, found, seed);
            for (int i = 0; i < s->count; i++)
                memcpy(s->x + i * s->dim, sites + order[i] * s->dim, sizeof(double) * (size_t)s->dim);
            free(order);
            free(sites);
            return;
        }
    }
}

static inline int keep_all(const int *at, int dim, int side) {
    (void)at, (void)dim, (void)side;
    return 1;
}

static inline int keep_even(const int *at, int dim, int side) {
    int sum = 0;
    (void)side;
    for (int k = 0; k < dim; k++)
        sum += at[k];
    return sum % 2 == 0;
}

static inline int keep_surface(const int *at, int dim, int side) {
    for (int k = 0; k < dim; k++)
        if (at[k] == 0 || at[k] == side - 1)
            return 1;
    return 0;
}

static inline void points_lattice(sample *s, uint64_t *seed) { fill_from_lattice(s, seed, keep_all); }
static inline void points_fcc(sample *s, uint64_t *seed) { fill_from_lattice(s, seed, keep_even); }
static inline void points_lattice_surface(sample *s, uint64_t *seed) { fill_from_lattice(s, seed, keep_surface); }

// Lattice sites with some coordinates moved by one ulp: almost cospherical everywhere.
static inline void points_lattice_off_by_ulps(sample *s, uint64_t *seed) {
    fill_from_lattice(s, seed, keep_all);
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = (s->x[i] + 1) * (1 + (random_below(seed, 3) - 1) * 0x1p-52);
}

// A lattice turned in the plane of each two axes: cospherical and coplanar but for rounding errors.
static inline void points_tilted_lattice(sample *s, uint64_t *seed) {
    fill_from_lattice(s, seed, keep_all);
    FOR_EACH_POINT(s, x)
    for (int k = 0; k + 1 < s->dim; k++) {
        double a = x[k], b = x[k + 1];
        x[k] = cos(0.3) * a - sin(0.3) * b;
        x[k + 1] = sin(0.3) * a + cos(0.3) * b;
    }
}

// Points in two hyperplanes at right angles to an axis.
static inline void points_two_hyperplanes(sample *s, uint64_t *seed) {
    FOR_EACH_POINT(s, x)
    for (int k = 0; k < s->dim; k++)
        x[k] = k == s->dim - 1 ? random_below(seed, 2) : random_unit(seed);
}

// Integer points x of equal |x|^2, moved by an offset: all exactly on one sphere. The plane has only few of them.
static inline int count_cospherical(int dim, int rest, int *at, int k, sample *s, int *found) {
    for (int v = 0, r = 0; (r = rest - v * v) >= 0; v++) {
        if (k < dim - 1) {
            at[k] = v;
            count_cospherical(dim, r, at, k + 1, s, found);
        } else if (r == 0) {
            at[k] = v;
            for (int signs = 0; signs < 1 << dim; signs++) {
                int skip = 0;
                for (int j = 0; j < dim; j++)
                    skip |= at[j] == 0 && (signs >> j & 1);
                if (skip)
                    continue;
                for (int j = 0; s && *found < s->count && j < dim; j++)
                    s->x[*found * dim + j] = signs >> j & 1 ? -at[j] : at[j];
                ++*found;
            }
        }
    }
    return *found;
}

static inline void points_cospherical(sample *s, uint64_t *seed) {
    static const int best_in_the_plane = 5 * 5 * 13 * 17 * 29; // 96 points
    int at[CELLS_MAX_DIM], norm = s->dim == 2 ? best_in_the_plane : s->dim, found = 0, *order;
    double offset = (double)random_below(seed, 1000);
    while (count_cospherical(s->dim, norm, at, 0, NULL, &found) < s->count && s->dim > 2)
        found = 0, norm++;
    sample all = sample_make(s->name, s->dim, found);
    order = (int *)need((size_t)found, sizeof(int));
    if (found < s->count)
        s->count = found;
    found = 0;
    count_cospherical(s->dim, norm, at, 0, &all, &found);
    shuffle(order, found, seed);
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < s->dim; k++)
            s->x[i * s->dim + k] = all.x[order[i] * s->dim + k] + offset;
    free(order);
    sample_free(&all);
}

static inline void points_cube_surface(sample *s, uint64_t *seed) {
    FOR_EACH_POINT(s, x) {
        for (int k = 0; k < s->dim; k++)
            x[k] = random_unit(seed);
        x[random_below(seed, s->dim)] = random_below(seed, 2);
    }
}

// Circles of points at Pythagorean angles, which are exactly cocircular. The other coordinates are small integers.
static inline void points_cylinder(sample *s, uint64_t *seed) {
    static const int circle[12][2] = {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4},
                                      {0, -5}, {3, -4}, {4, -3}};
    int layers = s->count / 12 + 2;
    FOR_EACH_POINT(s, x) {
        int angle = random_below(seed, 12);
        x[0] = circle[angle][0];
        x[1] = circle[angle][1];
        for (int k = 2; k < s->dim; k++)
            x[k] = random_below(seed, layers);
    }
}

// Integer combinations of `rank` integer vectors: a slanted lattice of lower affine dimension.
static inline void points_in_subspace(sample *s, uint64_t *seed, int rank) {
    int basis[CELLS_MAX_DIM][CELLS_MAX_DIM], range = (int)pow(2.0 * s->count, 1.0 / rank) + 2;
    for (int r = 0; r < rank; r++)
        for (int k = 0; k < s->dim; k++)
            basis[r][k] = r == k ? 1 : random_below(seed, 7) - 3;
    FOR_EACH_POINT(s, x) {
        for (int k = 0; k < s->dim; k++)
            x[k] = 17;
        for (int r = 0; r < rank; r++) {
            int times = random_below(seed, range);
            for (int k = 0; k < s->dim; k++)
                x[k] += times * basis[r][k];
        }
    }
}

static inline void points_hyperplane(sample *s, uint64_t *seed) { points_in_subspace(s, seed, s->dim - 1); }
static inline void points_line(sample *s, uint64_t *seed) { points_in_subspace(s, seed, 1); }
static inline void points_plane(sample *s, uint64_t *seed) { points_in_subspace(s, seed, s->dim > 2 ? 2 : 1); }

static inline void points_axis_plane(sample *s, uint64_t *seed) {
    int flat = random_below(seed, s->dim);
    FOR_EACH_POINT(s, x)
    for (int k = 0; k < s->dim; k++)
        x[k] = k == flat ? 0.7 : random_unit(seed);
}

static inline void points_duplicates(sample *s, uint64_t *seed) {
    points_uniform(s, seed);
    for (int i = 1; i < s->count; i++)
        if (random_below(seed, 3))
            memcpy(s->x + i * s->dim, s->x + random_below(seed, i) * s->dim, sizeof(double) * (size_t)s->dim);
}

static inline void points_signed_zeros(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++) {
        int v = random_below(seed, 5);
        s->x[i] = v == 0 ? 0.0 : v == 1 ? -0.0 : v - 3;
    }
}

static inline void points_all_equal(sample *s, uint64_t *seed) {
    double at = random_gauss(seed);
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = at;
}

static inline void points_ulp_lattice(sample *s, uint64_t *seed) {
    fill_from_lattice(s, seed, keep_all);
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = 1 + s->x[i] * 0x1p-52;
}

static inline double random_sign(uint64_t *seed) { return random_below(seed, 2) ? 1 : -1; }

static inline void points_mixed_magnitudes(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = random_sign(seed) * ldexp(1 + random_unit(seed), random_below(seed, 601) - 300);
}

static inline void points_all_magnitudes(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = random_sign(seed) * ldexp(1 + random_unit(seed), random_below(seed, 2090) - 1066);
}

static inline void points_subnormal(sample *s, uint64_t *seed) {
    fill_from_lattice(s, seed, keep_all);
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = (s->x[i] - 1) * 0x1p-1074;
}

static inline void points_around_smallest_normal(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = random_sign(seed) * ldexp(random_unit(seed), -1020);
}

static inline void points_huge(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = random_sign(seed) * 1.7e308 * (0.5 + 0.5 * random_unit(seed));
}

static inline void points_huge_lattice(sample *s, uint64_t *seed) {
    fill_from_lattice(s, seed, keep_all);
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = ldexp(s->x[i] - 1, 1020);
}

static inline void points_far_away(sample *s, uint64_t *seed) {
    fill_from_lattice(s, seed, keep_all);
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] += 0x1p52;
}

static inline void points_near_plane(sample *s, uint64_t *seed) {
    FOR_EACH_POINT(s, x)
    for (int k = 0; k < s->dim; k++)
        x[k] = k == s->dim - 1 ? 1e-15 * random_gauss(seed) : random_unit(seed);
}

static inline void points_helix(sample *s, uint64_t *seed) {
    FOR_EACH_POINT(s, x) {
        double t = 20 * random_unit(seed);
        for (int k = 0; k < s->dim; k++)
            x[k] = k == s->dim - 1 && s->dim % 2 ? 0.1 * t : k % 2 ? sin((k + 1) / 2 * t) : cos((k + 2) / 2 * t);
    }
}

// Integer points on two skew lines: one cell for each pair of gaps.
static inline void points_skew_lines(sample *s, uint64_t *seed) {
    int at = 0;
    (void)seed;
    FOR_EACH_POINT(s, x) {
        for (int k = 0; k < s->dim; k++)
            x[k] = 0;
        x[at % s->dim] = at / s->dim + 1;
        x[(at + 1) % s->dim] = at % 2;
        at++;
    }
}

// (t, t^2, t^3, ...): a neighbourly set, which has the most cells for its number of points.
static inline void points_moment_curve(sample *s, uint64_t *seed) {
    int t = -s->count / 2;
    (void)seed;
    FOR_EACH_POINT(s, x) {
        for (int k = 0; k < s->dim; k++)
            x[k] = k ? x[k - 1] * t : t;
        t++;
    }
}

// Steps towards a corner, each half of the one before: every scale from 1 to 2^-n, and rows of equal coordinates.
static inline void points_graded(sample *s, uint64_t *seed) {
    for (int i = 0; i < s->count * s->dim; i++)
        s->x[i] = ldexp(1, -random_below(seed, s->count / 2 + 2) % 60);
}

// Exactly in the plane of the last axis but for one point, so near to it that only exact arithmetic sees it off the plane
static inline void points_plane_but_one(sample *s, uint64_t *seed) {
    int one = s->count ? random_below(seed, s->count) : 0, i = 0;
    double off = random_sign(seed) * ldexp(1, -14 - random_below(seed, 87));
    FOR_EACH_POINT(s, x) {
        for (int k = 0; k < s->dim; k++)
            x[k] = k == s->dim - 1 ? 0 : random_unit(seed);
        if (i++ == one)
            x[s->dim - 1] = off;
    }
}

// The same with one in eight of the points off the plane, each by a power of two of its own
static inline void points_plane_but_few(sample *s, uint64_t *seed) {
    FOR_EACH_POINT(s, x) {
        for (int k = 0; k < s->dim; k++)
            x[k] = k == s->dim - 1 ? 0 : random_unit(seed);
        if (random_below(seed, 8) == 0)
            x[s->dim - 1] = random_sign(seed) * ldexp(1, -14 - random_below(seed, 87));
    }
}

typedef struct family {
    const char *name;
    void (*fill)(sample *s, uint64_t *seed);
    int at_most;  // points, where the number of cells grows faster than that of the points; 0: any number
    int extremes; // 1: coordinates whose squares over- or underflow
} family;

static const family families[] = {
    {"uniform", points_uniform, 0, 0},                           // general position
    {"gauss", points_gauss, 0, 0},                               // a hull far from the bulk
    {"sphere", points_sphere, 0, 0},                             // nearly cospherical, all on the hull
    {"clusters", points_clusters, 0, 0},                         // two scales
    {"plummer", points_plummer, 0, 0},                           // a dense core and a halo
    {"lattice", points_lattice, 0, 0},                           // cospherical everywhere
    {"fcc", points_fcc, 0, 0},                                   // cospherical, more points on a sphere
    {"lattice surface", points_lattice_surface, 0, 0},           // coplanar hull, cospherical
    {"lattice off by ulps", points_lattice_off_by_ulps, 0, 0},   // almost cospherical
    {"tilted lattice", points_tilted_lattice, 0, 0},             // cospherical and coplanar but for rounding errors
    {"two hyperplanes", points_two_hyperplanes, 0, 0},           // coplanar hull facets on two sides
    {"cospherical", points_cospherical, 200, 0},                 // every point on one sphere, exactly
    {"cube surface", points_cube_surface, 0, 0},                 // coplanar hull facets
    {"cylinder", points_cylinder, 0, 0},                         // cocircular layers, duplicates
    {"hyperplane", points_hyperplane, 0, 0},                     // affine dimension d - 1, slanted
    {"axis plane", points_axis_plane, 0, 0},                     // affine dimension d - 1, one coordinate constant
    {"plane", points_plane, 0, 0},                               // affine dimension 2, slanted
    {"line", points_line, 0, 0},                                 // collinear
    {"all equal", points_all_equal, 0, 0},                       // a single vertex
    {"duplicates", points_duplicates, 0, 0},                     // three times as many points as vertices
    {"signed zeros", points_signed_zeros, 0, 0},                 // -0.0 beside 0.0
    {"ulp lattice", points_ulp_lattice, 0, 0},                   // neighbouring doubles
    {"far away", points_far_away, 0, 0},                         // a lattice at 2^52
    {"mixed magnitudes", points_mixed_magnitudes, 500, 1},       // 2^-300 to 2^300
    {"all magnitudes", points_all_magnitudes, 100, 1},           // subnormal to 1e308
    {"subnormal", points_subnormal, 500, 1},                     // a lattice of subnormals
    {"smallest normal", points_around_smallest_normal, 500, 1},  // subnormal and normal beside each other
    {"huge", points_huge, 500, 1},                               // differences overflow
    {"huge lattice", points_huge_lattice, 500, 1},               // squares overflow, cospherical
    {"near plane", points_near_plane, 0, 0},                     // as thin as rounding errors
    {"helix", points_helix, 1000, 0},                            // a curve: long thin cells
    {"skew lines", points_skew_lines, 200, 0},                   // quadratically many cells
    {"moment curve", points_moment_curve, 40, 0},                // neighbourly
    {"graded", points_graded, 1000, 0},                          // every scale, coplanar and cospherical
    {"rough sphere", points_rough_sphere, 0, 0},                 // off a sphere by much more than rounding errors
    {"plane but one", points_plane_but_one, 0, 0},               // coplanar, exactly, but for one point
    {"plane but few", points_plane_but_few, 0, 0},               // coplanar, exactly, but for one in eight
};
enum { FAMILY_COUNT = sizeof families / sizeof families[0] };

// --- weights: a second table, to be combined with the families

static inline void weights_small(sample *s, uint64_t *seed) { // some points hidden
    double extent = 0;
    for (int i = 0; i < s->count * s->dim; i++)
        extent = fmax(extent, fabs(s->x[i]));
    for (int i = 0; i < s->count; i++)
        s->w[i] = random_unit(seed) * fmin(extent, 1e150) * fmin(extent, 1e150) * 0.05;
}

static inline void weights_wild(sample *s, uint64_t *seed) { // most points hidden, some weights negative
    weights_small(s, seed);
    for (int i = 0; i < s->count; i++)
        s->w[i] *= random_gauss(seed) * 200;
}

static inline void weights_integer(sample *s, uint64_t *seed) { // ties on lattices
    for (int i = 0; i < s->count; i++)
        s->w[i] = random_below(seed, 3);
}

static inline void weights_constant(sample *s, uint64_t *seed) { // the same as no weights
    (void)seed;
    for (int i = 0; i < s->count; i++)
        s->w[i] = 12.25;
}

static inline void weights_flat(sample *s, uint64_t *seed) { // all heights 0: the perturbation alone decides
    (void)seed;
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < s->dim; k++)
            s->w[i] += s->x[i * s->dim + k] * s->x[i * s->dim + k];
}

static inline void weights_extreme(sample *s, uint64_t *seed) { // every exponent that a double has
    for (int i = 0; i < s->count; i++)
        s->w[i] = random_sign(seed) * ldexp(1 + random_unit(seed), random_below(seed, 2090) - 1066);
}

typedef struct weighting {
    const char *name;
    void (*fill)(sample *s, uint64_t *seed); // NULL: no weights
    int extremes;
} weighting;

static const weighting weightings[] = {
    {"unweighted", NULL, 0},
    {"small weights", weights_small, 0},
    {"wild weights", weights_wild, 0},
    {"integer weights", weights_integer, 0},
    {"constant weights", weights_constant, 0},
    {"flat weights", weights_flat, 0},
    {"extreme weights", weights_extreme, 1},
};
enum { WEIGHTING_COUNT = sizeof weightings / sizeof weightings[0] };

// Returns the place of a family in the table, or FAMILY_COUNT.
static inline int family_named(const char *name) {
    int f = 0;
    while (f < FAMILY_COUNT && strcmp(families[f].name, name) != 0)
        f++;
    return f;
}

// w may be NULL: no weights.
static inline sample family_make(const family *f, const weighting *w, int dim, int count, uint64_t seed) {
    uint64_t state = seed * 1000003u + (uint64_t)dim;
    char name[96];
    snprintf(name, sizeof name, "%s, %s, d = %d, n = %d, seed %u", f->name, w ? w->name : "unweighted", dim, count,
             (unsigned)seed);
    sample s = sample_make(name, dim, f->at_most && count > f->at_most ? f->at_most : count);
    f->fill(&s, &state);
    if (w && w->fill) {
        s.w = (double *)need((size_t)s.count, sizeof(double));
        w->fill(&s, &state);
        for (int i = 0; i < s.count; i++) // |x|^2 of a huge point overflows
            if (!(fabs(s.w[i]) <= 1.7e308))
                s.w[i] = 1.7e308;
    }
    return s;
}

#endif
