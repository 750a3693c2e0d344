// Small random sets of every family, with and without weights, in 2 to 6 dimensions, through every method and beside it through
// regions, repair, hulls, living sets and furthest sites: each result is certified, or compared with one that is: cells, neighbours
// and representatives alike.
//
// Usage: soak FIRST COUNT [SECONDS]. Goes through the sets number FIRST to FIRST + COUNT - 1, or as many as the time allows, so
// that a long soak can be done in pieces, on several machines. Set i is of family i modulo their number; everything else about it
// follows from i. Prints how many of each family were done. A set that fails is named, and the exit status is 1.
#include "paradt.h" // before what names types as its variables are named

#include "families.h"

#include <time.h>

static uint64_t failed, results;

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void fails(const sample *s, uint64_t number, const char *what, const char *why) {
    printf("set %llu (%s): %s: %s\n", (unsigned long long)number, s->name, what, why);
    fflush(stdout);
    failed++;
}

static paradt_points points_of(const sample *s) {
    paradt_points points = paradt_points_f64(s->x, (size_t)s->count, s->dim);
    points.weights = s->w;
    return points;
}

// Does the result have this hash? Counts it.
static void expect(const sample *s, uint64_t number, const char *what, paradt_status status, uint64_t hash,
                   uint64_t expected) {
    results++;
    if (status)
        fails(s, number, what, paradt_status_string(status));
    else if (hash != expected)
        fails(s, number, what, "another result");
}

static uint64_t mixed(uint64_t x) {
    x = (x ^ x >> 31) * 0x9e3779b97f4a7c15u;
    return x ^ x >> 29;
}

// A hash of all that a result says, whatever the order of its cells and of their vertices: the cells, who is whose neighbour across
// which vertex, and representatives. 0: a neighbour is no cell, or a facet not its mirror's mirror. flags: those of the result
static uint64_t signature(const paradt_triangulation *t, unsigned flags) {
    size_t corners = (size_t)t->dim + 1, facets = t->neighbors ? t->cell_count * corners : 0, c, f, j;
    uint64_t sum = (uint64_t)t->dim + 2, *hash = (uint64_t *)need(t->cell_count + 1, sizeof *hash);
    for (c = 0; c < t->cell_count; c++) {
        uint64_t vertices[PARADT_MAX_DIM + 1];
        for (j = 0; j < corners; j++)
            vertices[j] = (uint64_t)t->cells[c * corners + j];
        hash[c] = paradt_hash_cell(vertices, (int)corners);
        sum += hash[c];
    }
    for (f = 0; f < facets && sum; f++) {
        paradt_index other = t->neighbors[f];
        size_t place = (size_t)other;
        int mirrors = (flags & PARADT_FACETS) != 0;
        uint64_t side = mixed(hash[f / corners] + (uint64_t)t->cells[f]);
        if (other < 0)
            sum += other == -1 ? side : 1;
        else if (place >= (mirrors ? facets : t->cell_count) || (mirrors && t->neighbors[place] != (paradt_index)f))
            sum = 0;
        else
            sum += mixed(side + 3 * hash[mirrors ? place / corners : place]);
    }
    for (c = 0; c < t->point_count && sum; c++)
        sum += mixed(c * 0x100000001b3u + (uint64_t)t->representative[c] + 5);
    free(hash);
    return sum;
}

// Each method undivided or in regions, which takes turns. expected: the signature of a certified result
static void try_methods(const sample *s, uint64_t number, const paradt_points *points, uint64_t expected) {
    for (int method = 0; method < PARADT_METHOD_COUNT; method++) {
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = (paradt_method)method;
        options.regions = ((uint64_t)method + number) % 2 ? 2 + number % 7 : 1;
        options.partition = number % 3 ? PARADT_BISECTION : PARADT_UNIFORM;
        options.flags = number / 2 % 2 ? PARADT_FACETS : 0;
        paradt_status status = paradt_triangulate(&t, points, &options);
        expect(s, number, paradt_method_string(options.method), status, signature(&t, options.flags), expected);
        paradt_free(&t);
    }
}

// Half of the points move to where others of the family are.
static void try_repair(const sample *s, uint64_t number, const sample *other) {
    paradt_points points = points_of(s);
    sample moved = sample_pick(s, NULL, s->count);
    for (int i = 0; i < s->count * s->dim && i < other->count * s->dim; i++)
        if (i / s->dim % 4 == (int)(number % 4))
            moved.x[i] = other->x[i];
    paradt_points after = points_of(&moved);
    paradt_triangulation t, u;
    paradt_status status = paradt_triangulate(&t, &points, NULL);
    if (!status)
        status = paradt_repair(&t, &after, NULL, NULL);
    paradt_status again = paradt_triangulate(&u, &after, NULL);
    expect(s, number, "repair", status ? status : again, paradt_hash(&t), paradt_hash(&u));
    paradt_free(&t);
    paradt_free(&u);
    sample_free(&moved);
}

static void try_hull(const sample *s, uint64_t number) {
    paradt_points points = points_of(s);
    paradt_hull hull;
    paradt_triangulation t;
    uint64_t sum = 0;
    points.weights = NULL;
    paradt_status status = paradt_hull_compute(&hull, &points, NULL), other = paradt_triangulate(&t, &points, NULL);
    size_t corners = (size_t)t.dim + 1;
    for (size_t f = 0; t.dim > 0 && f < t.cell_count * corners; f++) {
        uint64_t vertices[PARADT_MAX_DIM + 1];
        int count = 0;
        if (t.neighbors[f] >= 0)
            continue;
        for (size_t j = 0; j < corners; j++)
            if (j != f % corners)
                vertices[count++] = (uint64_t)t.cells[f / corners * corners + j];
        sum += paradt_hash_cell(vertices, count);
    }
    expect(s, number, "hull", status ? status : other, paradt_hull_hash(&hull), sum);
    if (!status && paradt_hull_check(&hull, &points, NULL, NULL))
        fails(s, number, "hull", "not certified");
    paradt_free(&t);
    paradt_hull_free(&hull);
}

// Some points from the beginning, the others one by one, a quarter of the sets by the Delaunay tree and a quarter by flips. In
// others some go then and come back, which may give them other ids.
static void try_living(const sample *s, uint64_t number, uint64_t hash) {
    static const paradt_method methods[4] = {PARADT_AUTO, PARADT_DELAUNAY_TREE, PARADT_AUTO, PARADT_FLIP};
    paradt_points points = points_of(s);
    paradt_options options = {0};
    paradt_dynamic *d;
    paradt_triangulation t;
    int first = s->count / 3;
    options.method = methods[number % 4];
    points.count = (size_t)first;
    paradt_status status = paradt_dynamic_create(&d, &points, &options);
    for (int i = first; i < s->count && !status; i++)
        status = paradt_dynamic_insert(d, s->x + i * s->dim, s->w ? s->w[i] : 0, -1, NULL);
    for (int i = (int)(number % 3); i < s->count && !status && options.method == PARADT_AUTO; i += 3) {
        paradt_index id;
        status = paradt_dynamic_remove(d, i);
        if (!status)
            status = paradt_dynamic_insert(d, s->x + i * s->dim, s->w ? s->w[i] : 0, -1, &id);
        if (!status && id != i)
            fails(s, number, "living set", "a free id was not used again");
    }
    memset(&t, 0, sizeof t);
    if (!status)
        status = paradt_dynamic_export(d, &t);
    expect(s, number, "living set", status, paradt_hash(&t), hash);
    paradt_free(&t);
    paradt_dynamic_free(d);
}

static void try_furthest(const sample *s, uint64_t number) {
    paradt_points points = points_of(s);
    paradt_options options = {0};
    paradt_triangulation t, u;
    options.flags = PARADT_FURTHEST_SITE;
    paradt_status status = paradt_triangulate(&t, &points, &options);
    options.regions = 2 + number % 5;
    paradt_status other = paradt_triangulate(&u, &points, &options);
    expect(s, number, "furthest site", status ? status : other, paradt_hash(&t), paradt_hash(&u));
    paradt_free(&t);
    paradt_free(&u);
}

static void try_set(uint64_t number) {
    static const int most[] = {0, 0, 40, 30, 16, 12, 10}, most_extreme[] = {0, 0, 16, 12, 7};
    uint64_t state = number * 0x9e3779b97f4a7c15u + 1;
    const family *f = &families[number % FAMILY_COUNT];
    const weighting *w = &weightings[random_below(&state, 2) ? 0 : random_below(&state, WEIGHTING_COUNT)];
    int extremes = f->extremes || w->extremes, dim = 2 + random_below(&state, extremes ? 3 : 5);
    dim = random_below(&state, 2) && dim > 3 ? dim - 2 : dim;
    int count = 1 + random_below(&state, extremes ? most_extreme[dim] : most[dim]);
    sample s = family_make(f, w, dim, count, random_bits(&state) >> 32);
    sample other = family_make(f, NULL, dim, count, random_bits(&state) >> 32);
    paradt_points points = points_of(&s);
    paradt_options options = {0};
    paradt_triangulation t;
    paradt_fault fault = {0};
    options.method = PARADT_INCODE;
    paradt_status status = paradt_triangulate(&t, &points, &options);
    uint64_t hash = paradt_hash(&t), whole = status ? 0 : signature(&t, 0);
    results++;
    if (status)
        fails(&s, number, "triangulation", paradt_status_string(status));
    else if (paradt_check(&t, &points, NULL, &fault))
        fails(&s, number, "triangulation", fault.reason ? fault.reason : "not certified");
    paradt_free(&t);
    try_methods(&s, number, &points, whole);
    try_repair(&s, number, &other);
    try_hull(&s, number);
    try_living(&s, number, hash);
    try_furthest(&s, number);
    sample_free(&s);
    sample_free(&other);
}

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr, "usage: soak FIRST COUNT [SECONDS]\n");
        return 2;
    }
    uint64_t first = strtoull(argv[1], NULL, 10), count = strtoull(argv[2], NULL, 10), i;
    double until = argc > 3 ? now() + atof(argv[3]) : 1e300, begun = now();
    for (i = 0; i < count && now() < until; i++)
        try_set(first + i);
    printf("%llu sets, from number %llu on: %llu of each of %d families, %llu results; %llu failed; %.0f seconds\n",
           (unsigned long long)i, (unsigned long long)first, (unsigned long long)(i / FAMILY_COUNT), (int)FAMILY_COUNT,
           (unsigned long long)results, (unsigned long long)failed, now() - begun);
    return failed != 0;
}
