// Any bytes are decoded to points in 2 to 5 dimensions (fuzz.h says how). Then
//     - all methods, with one region and with several, and the points in reverse order have to give the same cells
//     - with PARADT_FACETS each facet of a cell has to lead to the same facet of another cell and back
//     - paradt_check has to certify each result
//     - after points have moved, repairing has to give the same as a new triangulation
//     - the furthest-site triangulation has to obey its definition
//     - a failing allocation has to be reported, and may not leak memory
//     - after an element of a result is overwritten, paradt_check has to return, and may only certify the same cells
// in->spoil is the number of the allocation that fails, and of the element that is overwritten; bits 0-1: how points move.
// A fuzzer does with an input one of the methods in one of three ways, and one of what follows them.
#include "fuzz.h"
#include "wide.h"

// Returns the input with the points in reverse order. The caller sets points.data and points.weights.
static decoded reversed(const decoded *in) {
    decoded out = *in;
    size_t i, count = in->points.count, dim = (size_t)in->points.dim;
    for (i = 0; i < count; i++) {
        memcpy(out.x + i * dim, in->x + (count - 1 - i) * dim, dim * sizeof(double));
        out.w[i] = in->w[count - 1 - i];
    }
    return out;
}

// --- the tests

// Calls paradt_check. flags: those that the result was made with
static paradt_status check(const paradt_triangulation *t, const paradt_points *points, unsigned flags,
                           paradt_fault *fault) {
    paradt_options options;
    memset(&options, 0, sizeof options);
    options.flags = flags & PARADT_FACETS;
    return paradt_check(t, points, &options, fault);
}

// The result has to be certified by paradt_check. what: the case, for an error
static void certify(const paradt_triangulation *t, const paradt_points *points, unsigned flags, const char *what) {
    paradt_fault fault;
    paradt_status status = check(t, points, flags, &fault);
    if (status)
        fail(what, fault.reason ? fault.reason : paradt_status_string(status));
}

// Is the vertex one of the facet's? f: (dim + 1) * cell + place
static int facet_has(const paradt_triangulation *t, size_t f, paradt_index vertex) {
    size_t corners = (size_t)(t->dim + 1), j;
    for (j = 0; j < corners; j++)
        if (j != f % corners && t->cells[f / corners * corners + j] == vertex)
            return 1;
    return 0;
}

// Each half-facet that is not on the hull has to have a mirror: the half-facet of another cell with the same vertices,
// whose mirror is the first one.
static void expect_mirrors(const paradt_triangulation *t, const char *what) {
    size_t corners = (size_t)(t->dim + 1), facets = t->neighbors ? t->cell_count * corners : 0, f, j;
    for (f = 0; f < facets; f++) {
        paradt_index mirror = t->neighbors[f];
        if (mirror == -1)
            continue;
        if (mirror < 0 || (size_t)mirror >= facets || t->neighbors[mirror] != (paradt_index)f)
            fail(what, "a facet is not its mirror's mirror");
        for (j = 0; j < corners; j++)
            if (j != f % corners && !facet_has(t, (size_t)mirror, t->cells[f / corners * corners + j]))
                fail(what, "a facet and its mirror have different vertices");
        if (t->cells[f] == t->cells[mirror])
            fail(what, "a facet and its mirror belong to cells with the same vertices");
    }
}

// Overwrites one element of an array of t, and restores it. paradt_check may certify the result only if the cells are
// still the same.
static void expect_no_false_certificate(const paradt_triangulation *t, const paradt_points *points, unsigned flags,
                                        paradt_index *array, size_t count, int spoil) {
    size_t place;
    paradt_index right;
    uint64_t hash = paradt_hash(t);
    if (!array || !count) // a single vertex has no neighbours
        return;
    place = (size_t)spoil * 7 % count;
    right = array[place];
    array[place] = (paradt_index)(spoil % 4 == 0 ? (uint32_t)spoil * 2654435761u : (uint32_t)(spoil % 67) - 2u);
    if (array[place] != right && check(t, points, flags, NULL) == PARADT_OK &&
        (array != t->cells || paradt_hash(t) != hash))
        fail("spoiled result", "it was certified");
    array[place] = right;
}

// The points have to be triangulated, with these options, to cells of this hash.
static void expect_hash(const decoded *in, const paradt_options *options, uint64_t hash, const char *what) {
    paradt_triangulation t;
    paradt_status status = paradt_triangulate(&t, &in->points, options);
    if (status)
        fail(what, paradt_status_string(status));
    if (paradt_hash(&t) != hash)
        fail(what, "the cells are not InCoDe's");
    certify(&t, &in->points, options->flags, what);
    if (options->flags & PARADT_FACETS) {
        expect_mirrors(&t, what);
        expect_no_false_certificate(&t, &in->points, options->flags, t.neighbors,
                                    t.cell_count * (size_t)(t.dim + 1), in->spoil);
    }
    paradt_free(&t);
}

// Triangulates the points in reverse order. The cells have to be those of t: each vertex is translated to the point
// that stands for it in t.
static void expect_same_reversed(const decoded *in, const paradt_triangulation *t) {
    decoded back = reversed(in);
    paradt_triangulation u;
    paradt_status status;
    uint64_t sum = 0;
    size_t c;
    int i, hidden = 0;
    back.points.data = back.x;
    back.points.weights = in->points.weights ? back.w : NULL;
    status = paradt_triangulate(&u, &back.points, NULL);
    if (status)
        fail("reversed", paradt_status_string(status));
    for (c = 0; c < u.cell_count; c++) {
        uint64_t vertices[MAX_DIM + 1];
        for (i = 0; i <= u.dim; i++)
            vertices[i] =
                (uint64_t)t->representative[u.point_count - 1 - (size_t)u.cells[c * (size_t)(u.dim + 1) + (size_t)i]];
        sum += paradt_hash_cell(vertices, u.dim + 1);
    }
    for (c = 0; c < u.point_count; c++)
        hidden += (u.representative[c] < 0) != (t->representative[t->point_count - 1 - c] < 0);
    if (sum != paradt_hash(t) || hidden)
        fail("reversed", "the cells or the hidden points are others");
    certify(&u, &back.points, 0, "reversed");
    paradt_free(&u);
}

// Moves points. kind: 0: each a little, in the last bits of its coordinates; 1: each by up to a 64th of its size; 2: every
// third to the place of another; 3: none, but their weights
static void move(decoded *in, int kind) {
    size_t count = in->points.count, dim = (size_t)in->points.dim, i;
    for (i = 0; i < count * dim && kind < 2; i++)
        in->x[i] = from_bits(to_bits(in->x[i]) ^ (i * 0x9e3779b97f4a7c15u + 1) >> (kind ? 18 : 54));
    for (i = 0; i < count && kind == 2; i += 3)
        memcpy(in->x + i * dim, in->x + i * 7 % count * dim, dim * sizeof(double));
    for (i = 0; i < count / 2 && kind == 3; i++)
        in->w[i] = in->w[count - 1 - i];
}

// A triangulation has to become that of the points where they are now. flags: those that it is made with
static void expect_repair(const decoded *in, unsigned flags) {
    decoded moved = *in;
    paradt_options options;
    paradt_triangulation t, u;
    paradt_status status;
    memset(&options, 0, sizeof options);
    options.flags = flags;
    move(&moved, in->spoil % 4);
    moved.points.data = moved.x;
    moved.points.weights = in->points.weights ? moved.w : NULL;
    status = paradt_triangulate(&t, &in->points, &options);
    if (!status)
        status = paradt_repair(&t, &moved.points, &options, NULL);
    if (!status)
        status = paradt_triangulate(&u, &moved.points, &options);
    if (status)
        fail("repair", paradt_status_string(status));
    if (paradt_hash(&t) != paradt_hash(&u))
        fail("repair", "the cells are not those of a new triangulation");
    if (u.point_count && memcmp(t.representative, u.representative, u.point_count * sizeof *u.representative))
        fail("repair", "the representatives are not those of a new triangulation");
    certify(&t, &moved.points, flags, "repair");
    if (flags & PARADT_FACETS)
        expect_mirrors(&t, "repair");
    paradt_free(&t);
    paradt_free(&u);
}

// A failing allocation has to be reported, and no memory may be leaked.
static void expect_clean_failure(const decoded *in, uint64_t hash) {
    account b;
    paradt_options options = counted_options(&b);
    paradt_triangulation t;
    paradt_status status;
    b.fail_at = in->spoil % 32;
    options.regions = in->regions;
    status = paradt_triangulate(&t, &in->points, &options);
    if (status != (has_failed(&b) ? PARADT_ERROR_MEMORY : PARADT_OK))
        fail("failing allocation", paradt_status_string(status));
    if (!status && paradt_hash(&t) != hash)
        fail("own allocator", "the cells are others");
    paradt_free(&t);
    if (b.held)
        fail("failing allocation", "memory was leaked");
}

// Sets *sum to the cells' volume times dim!, in units of 2^(dim * scale). scale: the least of all coordinates
static void add_volumes(wide *sum, const paradt_triangulation *t, const double *x, int scale) {
    static wide edges[WIDE_COLUMNS][WIDE_COLUMNS], start, volume;
    size_t c;
    int dim = t->dim, i, k;
    sum->sign = sum->count = 0;
    for (c = 0; c < t->cell_count; c++) {
        const paradt_index *v = t->cells + c * (size_t)(dim + 1);
        for (i = 0; i < dim; i++)
            for (k = 0; k < dim; k++) {
                wide_of(&edges[i][k], x[v[i + 1] * dim + k], scale);
                wide_of(&start, x[v[0] * dim + k], scale);
                wide_add(&edges[i][k], &start, -1);
            }
        wide_determinant(&volume, edges, dim);
        if (volume.sign <= 0)
            fail("volume", "a cell is flat or turned over");
        wide_add(sum, &volume, 1);
    }
}

// The cells of both triangulations have to fill the same hull.
static void expect_same_volume(const decoded *in, const paradt_triangulation *t, const paradt_triangulation *u) {
    static wide volume, other;
    int scale = 2000;
    size_t i;
    for (i = 0; i < in->points.count * (size_t)in->points.dim; i++)
        if (in->x[i] != 0 && wide_scale(in->x[i]) < scale)
            scale = wide_scale(in->x[i]);
    add_volumes(&volume, t, in->x, scale);
    add_volumes(&other, u, in->x, scale);
    if (wide_compare_sizes(&volume, &other))
        fail("volume", "two triangulations fill different hulls");
}

// Is another point at the place of point q, and heavier?
static int stands_behind(const decoded *in, size_t q) {
    size_t dim = (size_t)in->points.dim, i;
    for (i = 0; i < in->points.count; i++)
        if (in->w[i] > in->w[q] && is_same_place(in->x + i * dim, in->x + q * dim, dim))
            return 1;
    return 0;
}

// Each point that is not at the place of one of the cell's vertices has to be in conflict with it.
static void expect_all_in_conflict(const decoded *in, const paradt_triangulation *u, size_t cell) {
    const double *p[MAX_DIM + 2];
    double weights[MAX_DIM + 2];
    size_t dim = (size_t)in->points.dim, q, i;
    for (i = 0; i <= dim; i++) {
        size_t v = (size_t)u->cells[cell * (dim + 1) + i];
        p[i] = in->x + v * dim;
        weights[i] = in->w[v];
    }
    if (paradt_orient((int)dim, p) != 1)
        fail("furthest site", "a cell is not positively oriented");
    for (q = 0; q < in->points.count; q++) {
        p[dim + 1] = in->x + q * dim;
        weights[dim + 1] = in->w[q];
        for (i = 0; i <= dim && !is_same_place(p[i], p[dim + 1], dim); i++)
            ;
        if (i > dim && !stands_behind(in, q) && paradt_insphere_perturbed((int)dim, p, weights) != 1)
            fail("furthest site", "a point is not in conflict with a cell");
    }
}

// The furthest-site triangulation has to obey its definition, with one task and with several. t: the other one
static void expect_furthest_site(const decoded *in, const paradt_triangulation *t) {
    paradt_options options;
    paradt_triangulation u, v;
    size_t c;
    memset(&options, 0, sizeof options);
    options.flags = PARADT_FURTHEST_SITE;
    expect_ok(paradt_triangulate(&u, &in->points, &options), "furthest site");
    options.method = PARADT_LIFTED_HULL;
    options.regions = in->regions;
    options.flags |= PARADT_FACETS;
    expect_ok(paradt_triangulate(&v, &in->points, &options), "furthest site, tasks");
    if (u.dim != t->dim || v.dim != t->dim || paradt_hash(&u) != paradt_hash(&v))
        fail("furthest site", "the tasks change the result");
    expect_mirrors(&v, "furthest site");
    if (u.dim == in->points.dim) {
        for (c = 0; c < u.cell_count; c++)
            expect_all_in_conflict(in, &u, c);
        if (u.dim <= 3)
            expect_same_volume(in, t, &u);
    }
    paradt_free(&u);
    paradt_free(&v);
}

static void expect_no_false_certificates(const decoded *in, const paradt_triangulation *t) {
    size_t facets = t->cell_count * (size_t)(t->dim + 1);
    expect_no_false_certificate(t, &in->points, 0, t->cells, facets, in->spoil);
    expect_no_false_certificate(t, &in->points, 0, t->neighbors, facets, in->spoil);
    expect_no_false_certificate(t, &in->points, 0, t->representative, t->point_count, in->spoil);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const int most_points[MAX_DIM + 1] = {0, 0, 64, 40, 20, 12};
    source b = {data, size};
    decoded in;
    paradt_options options;
    paradt_triangulation t;
    paradt_status status;
    uint64_t hash;
    int method, way;
    decode(&in, &b, most_points);
    memset(&options, 0, sizeof options);
    options.method = PARADT_INCODE;
    status = paradt_triangulate(&t, &in.points, &options);
    if (in.first_bad >= 0) {
        if (status != PARADT_ERROR_NOT_FINITE || t.error_point != (size_t)in.first_bad)
            fail("not finite", "the point was not reported");
        return 0;
    }
    if (status)
        fail("InCoDe", paradt_status_string(status));
    certify(&t, &in.points, 0, "InCoDe");
    hash = paradt_hash(&t);

    for (method = 0; method < PARADT_METHOD_COUNT; method++) {
        if (!asks(&in, method, PARADT_METHOD_COUNT))
            continue;
        options.method = (paradt_method)method;
        for (way = 0; way < 3; way++) {
            if (!ASKS_ALL && way != in.choice / PARADT_METHOD_COUNT % 3)
                continue;
            options.flags = way == 0 ? PARADT_NO_NEIGHBORS : way == 1 ? 0 : PARADT_FACETS;
            options.regions = way == 0 ? 1 : in.regions;
            options.partition = way == 0 ? PARADT_BISECTION : in.partition;
            expect_hash(&in, &options, hash, paradt_method_string(options.method));
        }
    }
    if (asks(&in, 0, 5))
        expect_repair(&in, in.regions % 2 ? PARADT_FACETS : 0);
    if (asks(&in, 1, 5))
        expect_same_reversed(&in, &t);
    if (asks(&in, 2, 5))
        expect_clean_failure(&in, hash);
    if (asks(&in, 3, 5))
        expect_furthest_site(&in, &t);
    if (asks(&in, 4, 5))
        expect_no_false_certificates(&in, &t);
    paradt_free(&t);
    return 0;
}
