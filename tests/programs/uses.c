// Prints, for every small sample in a file, what comes of a living set whose points come, move and go, of locating, of nearest
// points, and of Voronoi diagrams: what is decided, not the numbers. The output must be the same when it is built with flags, or
// run in modes, that break careless floating-point code.
// Usage: uses FILE SHARE [MODE...]
//   SHARE            -1: prints all lines; 0 and more: every third line, beginning with this one modulo three
//   MODE             see modes.h
#ifndef USES_LINKED // else the implementation is in another object
#define PARADT_IMPLEMENTATION
#define PARADT_NO_FRONTS // not called here
#define PARADT_NO_REGIONS
#define PARADT_NO_HULLS
#define PARADT_NO_MEASURES
#endif
#include "paradt.h"

#include "modes.h"

enum { MOST_POINTS = 160, MOST_DIM = 3, SHARES = 3 };

static void print_number(const char *what, paradt_status status, uint64_t hash) {
    printf("%s %s %08lx%08lx", what, paradt_status_string(status), (unsigned long)(hash >> 32),
           (unsigned long)(hash & 0xffffffffu));
}

// A set of half of the points, into which the others are inserted; then some move to where two others have their coordinates,
// and some go. wanted: the hash, where points only come
static void print_living(const double *x, const double *w, size_t count, int dim, paradt_method method, uint64_t wanted) {
    paradt_points points = paradt_points_f64(x, count / 2, dim);
    paradt_options options = {0};
    paradt_dynamic *set;
    paradt_triangulation t;
    paradt_status status;
    size_t i;
    options.method = method;
    points.weights = w;
    status = paradt_dynamic_create(&set, &points, &options);
    for (i = count / 2; i < count && !status; i++)
        status = paradt_dynamic_insert(set, x + i * (size_t)dim, w ? w[i] : 0.0, -1, NULL);
    for (i = 0; i + 7 < count && !status && !method; i += 5) {
        double to[MOST_DIM];
        int k;
        for (k = 0; k < dim; k++)
            to[k] = x[(i + (k ? 3 : 7)) * (size_t)dim + (size_t)k];
        status = paradt_dynamic_move(set, (paradt_index)i, to, w ? w[i + 1] : 0.0);
    }
    for (i = 1; i < count && !status && !method; i += 4)
        status = paradt_dynamic_remove(set, (paradt_index)i);
    if (!status)
        status = paradt_dynamic_export(set, &t);
    print_number(method == PARADT_FLIP ? ", flips" : method ? ", tree" : ": living", status, status ? 0 : paradt_hash(&t));
    if (!status && method && paradt_hash(&t) != wanted) {
        fprintf(stderr, "a living set is not the triangulation of its points\n");
        exit(1);
    }
    if (!status)
        paradt_free(&t);
    paradt_dynamic_free(set);
}

// Places whose coordinates are those of different points
static void print_queries(const paradt_triangulation *t, const paradt_points *points, const double *x) {
    size_t dim = (size_t)points->dim, count = points->count, i, k;
    double *places = (double *)malloc((count * dim + 1) * sizeof(double));
    paradt_location *found = (paradt_location *)malloc((count + 1) * sizeof *found);
    paradt_index *nearest = (paradt_index *)malloc((count + 1) * sizeof *nearest);
    paradt_points queries = paradt_points_f64(places, count, points->dim);
    paradt_locator *locator;
    uint64_t hash = 0, vertices[MOST_DIM + 1];
    paradt_status status = paradt_locator_create(&locator, t, points, NULL);
    if (!places || !found || !nearest)
        exit(1);
    for (i = 0; i < count; i++)
        for (k = 0; k < dim; k++)
            places[i * dim + k] = x[(i + k * (i % 3)) % count * dim + k];
    if (!status)
        status = paradt_locate(locator, &queries, found, NULL);
    for (i = 0; i < count && !status; i++) { // the face that holds a place is the same, whatever cell it is told of
        int face = 0, j;
        for (j = 0; j <= t->dim && found[i].cell >= 0; j++)
            if (found[i].face >> j & 1)
                vertices[face++] = (uint64_t)t->cells[found[i].cell * (t->dim + 1) + j];
        hash += (i + 1) * paradt_hash_cell(vertices, face);
    }
    print_number(", located", status, hash);
    if (!status)
        status = paradt_nearest(locator, &queries, nearest, NULL);
    for (i = 0, hash = 0; i < count && !status; i++)
        hash = hash * 31 + (uint64_t)nearest[i];
    print_number(", nearest", status, hash);
    paradt_locator_free(locator);
    free(places);
    free(found);
    free(nearest);
}

// Is a < b? Looks at their bits, so that subnormal numbers differ in all modes.
static int is_less(double a, double b) {
    uint64_t x, y;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    if (x >> 63 != y >> 63)
        return (int)(x >> 63) && (x | y) << 1 != 0;
    return x >> 63 ? x > y : x < y;
}

enum { WHOLE, CLIPPED, CUT };

// Which points share faces, how many corners these have, and which cells are unbounded: of the whole diagram, clipped to a box
// with two points at corners, and cut by a plane of numbers that are coordinates
static void print_voronoi(const paradt_triangulation *t, const paradt_points *points, const double *x, int by) {
    static const char *const names[] = {", Voronoi", ", clipped", ", cut"};
    paradt_voronoi_request request;
    paradt_voronoi v;
    paradt_status status;
    double box[2 * MOST_DIM];
    uint64_t hash = 0, sides[2];
    size_t i;
    int k;
    memset(&request, 0, sizeof request);
    request.outputs = PARADT_VORONOI_FACES | PARADT_VORONOI_POLYGONS;
    for (k = 0; k < points->dim; k++) {
        double low = x[k], high = x[points->dim + k];
        int ordered = is_less(low, high);
        box[k] = ordered ? low : high;
        box[points->dim + k] = ordered ? high : low;
    }
    if (by == CLIPPED)
        request.box = box;
    if (by == CUT) {
        request.planes = x + 3 * points->dim;
        request.plane_count = 1;
    }
    status = paradt_voronoi_compute(&v, t, points, &request, NULL);
    for (i = 0; i < v.face_count && !status; i++) {
        sides[0] = (uint64_t)v.sides[2 * i];
        sides[1] = (uint64_t)(int64_t)v.sides[2 * i + 1];
        hash += paradt_hash_cell(sides, 2) * (2 * (v.first_vertex[i + 1] - v.first_vertex[i]) + 1);
    }
    for (i = 0; i < v.cell_count && !status; i++)
        hash = hash * 31 + v.unbounded[i];
    print_number(names[by], status, hash + v.vertex_count);
    paradt_voronoi_free(&v);
}

int main(int argc, char **argv) {
    int32_t head[4];
    FILE *file = argc > 1 ? fopen(argv[1], "rb") : NULL;
    int share = argc > 2 ? atoi(argv[2]) : -1, line = 0, i;
    if (!file || argc < 3) {
        fprintf(stderr, "usage: uses FILE SHARE [MODE...]\n");
        return 2;
    }
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // if the run is stopped, the output shows where
    for (i = 3; i < argc; i++)
        enter(argv[i]);
    while (get_head(file, head)) {
        char *name = (char *)get(file, 96, 1);
        size_t count = (size_t)head[1];
        void *data = get(file, count * (size_t)head[0], head[3] ? sizeof(float) : sizeof(double));
        double *weights = head[2] ? (double *)get(file, count, sizeof(double)) : NULL;
        int is_small = !head[3] && head[0] <= MOST_DIM && count > 8;
        if (is_small && (share < 0 || line % SHARES == share % SHARES)) {
            const double *x = (const double *)data;
            size_t most = count < MOST_POINTS ? count : (size_t)MOST_POINTS;
            paradt_points points = paradt_points_f64(x, most, head[0]);
            paradt_triangulation t;
            points.weights = weights;
            if (paradt_triangulate(&t, &points, NULL))
                exit(1);
            printf("%s", name);
            print_living(x, weights, most, head[0], PARADT_AUTO, 0);
            print_living(x, weights, most, head[0], PARADT_DELAUNAY_TREE, paradt_hash(&t));
            print_living(x, weights, most, head[0], PARADT_FLIP, paradt_hash(&t));
            print_queries(&t, &points, x);
            print_voronoi(&t, &points, x, WHOLE);
            print_voronoi(&t, &points, x, CLIPPED);
            print_voronoi(&t, &points, x, CUT);
            printf("\n");
            paradt_free(&t);
        }
        line += is_small;
        free(weights);
        free(data);
        free(name);
    }
    fclose(file);
    return 0;
}
