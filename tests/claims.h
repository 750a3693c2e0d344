// What paradt.h claims where floating point decides (PARADT_CLAIM), compared with the exact values. A claim is a value and
// a bound of its error, or a decision. Each kind of claim has a tally: how many there were, the largest ratio of an error
// to its bound, which must not exceed 1, and how many claims were wrong. For one thread. The implementation follows this
// file, and tests/claims_exact.h the implementation.
#ifndef CLAIMS_H
#define CLAIMS_H

#include "dyadic.h"

#include <stdio.h>

// Kinds of claims that hold for several dimensions have one tally for each.
typedef enum claim_kind {
    ORIENT = 0,         // [dim] second filter: the bound of the points
    INSPHERE = 10,      // [dim]
    SET_ORIENT = 20,    // [dim] first filter: the bound of the set
    SET_INSPHERE = 30,  // [dim]
    SPHERE_POWER = 40,  // [making] powers by kept spheres
    CIRCLE_POWER = 44,  // [making]
    MONOMIALS = 48,     // in-sphere tests in space by the sum of all monomials
    GHOST_SPACE,        // powers of ghosts
    GHOST_PLANE,        //
    SIDES,              // of the facets of a cell
    LOOK,               // what the spheres of cells tell
    SEARCH_F,           // the search's F,
    SEARCH_N,           // its N,
    SEARCH_SIDE,        // what they decide of a point,
    RULED_OUT,          // and of boxes and points in lanes
    PLANE_CELL,         // planes of cells,
    PLANE_GHOST,        // of ghosts,
    PLANE_FACET,        // and of facets
    PLANE_SIDE,         // what they decide
    DISTANCE,           // powers of places
    CENTRE,             // of cells
    CORNER,             // where planes meet
    ABOVE,              // on which side of a plane a corner is
    MINORS,             // of the sieve
    SAGITTAS,           //
    LEAN,               // of a vertex, from another towards a place
    CLAIM_KINDS
} claim_kind;

typedef struct claim_tally {
    size_t count, wrong;
    double largest;
} claim_tally;

static claim_tally claims[CLAIM_KINDS];

// The adversary asks about ghosts by their vertices: then it is known by what their normals have been multiplied.
static double claim_steepness; // 0: not known
static double claim_lift;      // of the point that is asked about, to be left out

// What is wrong, once a kind
static void claim_broken(int kind, const char *what, double ratio) {
    if (!claims[kind].wrong++)
        printf("# claim of kind %d: %s, ratio %g\n", kind, what, ratio);
}

static void claim_decision(int kind, int right) {
    claims[kind].count++;
    if (!right)
        claim_broken(kind, "a wrong decision", 0);
}

// error: times `scale`; the bound is that of the error itself
static void claim_ratio(int kind, const dyadic *error, double bound, const dyadic *scale) {
    static dyadic b;
    static int ready;
    double ratio;
    if (!(bound < 0x1p499)) // nothing is claimed
        return;
    if (!ready)
        dy_init(&b), ready = 1;
    dy_set(&b, bound);
    if (scale)
        dy_mul(&b, &b, scale);
    ratio = dy_ratio(error, &b);
    claims[kind].count++;
    if (ratio > claims[kind].largest)
        claims[kind].largest = ratio;
    if (ratio > 1)
        claim_broken(kind, "the error exceeds its bound", ratio);
}

#undef PARADT_IMPLEMENTATION // the types first
#include "../paradt.h"

struct paradt__space;
struct paradt__bounds;
struct paradt__insertion;
struct paradt__sphere;
struct paradt__scene;
struct paradt__search;
struct paradt__graph;
struct paradt__plane;
struct paradt__diagram;
struct paradt__convex;
struct paradt__halfspace;
struct paradt__minors_table;
struct paradt__set;
static void claim_determinant(const struct paradt__space *s, const double *const *row, const double *base, int n, int k,
                              int d, int weighted, double value, double largest, const struct paradt__bounds *b);
static void claim_monomials(const struct paradt__space *s, const double *const *row, const double *base, int n, int k,
                            int d, int weighted, double value, double largest, const struct paradt__bounds *b);
static void claim_power(const struct paradt__insertion *build, const struct paradt__sphere *sphere, size_t cell,
                        const double *x, double value);
#if defined(__GNUC__)
__attribute__((unused)) // without vector code
#endif
static void claim_powers(const struct paradt__insertion *build, const struct paradt__sphere *table, size_t mask,
                         const paradt_index *links, const double *x, const double *values);
static void claim_sides(const struct paradt__scene *scene, const paradt_index *row, const double *x,
                        const double *values, double certain, int corners);
static void claim_look(const struct paradt__insertion *build, const paradt_index *bases, const paradt_index *asked,
                       unsigned found);
static void claim_search(const struct paradt__search *s, const double *x, double f, double f_bound, double n,
                         double n_bound);
static void claim_lanes(const struct paradt__search *s, size_t first, size_t span, unsigned out);
static void claim_plane(const struct paradt__graph *g, const paradt_index *row, const struct paradt__plane *plane,
                        const double *x, double value, int terms);
static void claim_distance(const struct paradt__scene *scene, const double *x, const double *p, int ambient,
                           int weighted, double value, double error);
static void claim_meet(const struct paradt__diagram *g, const paradt_index *vertices, const double *y, int d);
static void claim_lean(const double *v, const double *x, const double *w, double value, double bound);
static void claim_corner(struct paradt__convex *c, const struct paradt__halfspace *const *h, const double *y,
                         int distant);
static void claim_above(struct paradt__convex *c, size_t vertex, const struct paradt__halfspace *plane, int sign);
static void claim_minors(const double *const *x, const double *scale, const struct paradt__minors_table *table, int d);
static void claim_sagittas(const struct paradt__set *set);

#define PARADT_CLAIM(kind, ...) claim_##kind(__VA_ARGS__)

#endif
