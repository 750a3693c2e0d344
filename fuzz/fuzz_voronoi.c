// Any bytes are decoded to points in 2 to 4 dimensions (fuzz.h says how). Then of their Voronoi or power diagram
//     - the volumes in a box have to add up to the box, within the errors stated, by wide integers
//     - a plane and its opposite have to cut each cell in two parts that add up to the cell
//     - each face has to be listed by both of its cells, and each two cells may have one face at most
//     - faces that nothing clips have to belong to edges of the triangulation
//     - cells that nothing clips have to be unbounded where their point is on the hull
//     - areas, normals and polygons have to be sound, and the number of tasks may not change a bit
// A failing allocation has to be reported, and may not leak memory. in->spoil is its number.
// A fuzzer does a third of this with an input: the box, what nothing clips, or the failing allocation.
#include "fuzz.h"
#include "wide.h"

enum { MOST_DIM = 4 };

// Adds `sign` times a sum of doubles.
static void add_all(wide *sum, const double *x, size_t count, int scale, int sign) {
    static wide number;
    size_t i;
    for (i = 0; i < count; i++) {
        wide_of(&number, x[i], scale);
        wide_add(sum, &number, sign);
    }
}

static int all_finite(const double *x, size_t count) {
    size_t i;
    for (i = 0; i < count && is_finite(x[i]); i++)
        ;
    return i == count;
}

// Is the difference of two sums at most a third one, exactly?
static int adds_up(const double *parts, const double *errors, size_t count, const double *whole, size_t whole_count) {
    static wide difference, bound;
    int scale = wide_least_scale(parts, count, wide_least_scale(errors, count, wide_least_scale(whole, whole_count, 0)));
    difference.sign = bound.sign = difference.count = bound.count = 0;
    add_all(&difference, parts, count, scale, 1);
    add_all(&difference, whole, whole_count, scale, -1);
    add_all(&bound, errors, count, scale, 1);
    return wide_compare_sizes(&difference, &bound) <= 0;
}

// The volumes have to add up to the box: low, then high bounds, which are integers small enough for an exact product.
static void expect_box(const paradt_voronoi *v, const double *box) {
    double volume = 1;
    int k;
    for (k = 0; k < v->dim; k++)
        volume *= box[v->dim + k] - box[k];
    if (!all_finite(v->volumes, v->cell_count))
        fail("box", "a volume is not finite");
    if (v->cell_count && all_finite(v->volume_errors, v->cell_count) && !adds_up(v->volumes, v->volume_errors, v->cell_count, &volume, 1))
        fail("box", "the volumes do not add up to it");
}

// --- faces

// Does the cell of a point list the face?
static int lists(const paradt_voronoi *v, size_t cell, size_t face) {
    size_t i;
    for (i = v->first_face[cell]; i < v->first_face[cell + 1]; i++)
        if (v->faces[i] == (paradt_index)face)
            return 1;
    return 0;
}

// walls: how many there are
static void expect_faces(const paradt_voronoi *v, int walls) {
    size_t listed = 0, f, g;
    for (f = 0; f < v->face_count; f++) {
        paradt_index a = v->sides[2 * f], b = v->sides[2 * f + 1];
        if (a < 0 || (size_t)a >= v->cell_count || b >= (paradt_index)v->cell_count || b < -walls || a == b)
            fail("faces", "a side is neither a point nor a wall");
        if (!lists(v, (size_t)a, f) || (b >= 0 && !lists(v, (size_t)b, f)))
            fail("faces", "a cell does not list its face");
        listed += b >= 0 ? 2 : 1;
        for (g = 0; g < f; g++)
            if ((v->sides[2 * g] == a && v->sides[2 * g + 1] == b) || (v->sides[2 * g] == b && v->sides[2 * g + 1] == a))
                fail("faces", "two cells have two faces");
    }
    if (v->first_face[0] != 0 || v->first_face[v->cell_count] != listed)
        fail("faces", "cells list faces that are not theirs");
}

// Polygons name vertices that are there, once each, and their number fits the dimension; areas are not negative.
static void expect_polygons(const paradt_voronoi *v) {
    size_t f, i, j;
    for (f = 0; f < v->face_count; f++) {
        const paradt_index *polygon = v->polygons + v->first_vertex[f];
        size_t count = v->first_vertex[f + 1] - v->first_vertex[f];
        int open = 0;
        for (i = 0; i < count; i++) {
            open |= polygon[i] == -1;
            if (polygon[i] < -1 || polygon[i] >= (paradt_index)v->vertex_count)
                fail("polygons", "a vertex is out of range");
            for (j = 0; j < i; j++)
                if (polygon[i] == polygon[j])
                    fail("polygons", "a vertex comes twice");
        }
        if (count < (open ? 2 : (size_t)v->dim))
            fail("polygons", "a face has too few vertices");
        if (v->areas && (!(v->areas[f] >= 0) || (open && is_finite(v->areas[f]))))
            fail("areas", "an area is negative, or finite where its face is unbounded");
        if (open && !v->unbounded[v->sides[2 * f]])
            fail("polygons", "a bounded cell has a face that is not");
        for (i = 0; v->normals && i < (size_t)v->dim; i++)
            if (v->normals[f * (size_t)v->dim + i] < -1.0000001 || v->normals[f * (size_t)v->dim + i] > 1.0000001)
                fail("normals", "a normal is longer than 1");
    }
}

// Without walls a face belongs to an edge, and a cell is unbounded where its point is on the hull.
static void expect_dual(const paradt_voronoi *v, const paradt_triangulation *t) {
    paradt_adjacency edges;
    size_t corners = (size_t)t->dim + 1, f, e, i, j;
    unsigned char on_hull[MAX_POINTS] = {0};
    expect_ok(paradt_adjacency_compute(&edges, t, PARADT_VERTEX_VERTICES, NULL), "adjacency");
    for (f = 0; f < v->face_count; f++) {
        size_t a = (size_t)v->sides[2 * f];
        for (e = edges.first[a]; e < edges.first[a + 1] && edges.items[e] != v->sides[2 * f + 1]; e++)
            ;
        if (e == edges.first[a + 1])
            fail("dual", "a face is between points that no edge joins");
    }
    paradt_adjacency_free(&edges);
    for (f = 0; f < t->cell_count * corners; f++)
        for (j = 0; j < corners && t->neighbors[f] < 0; j++)
            if (j != f % corners)
                on_hull[t->cells[f / corners * corners + j]] = 1;
    for (i = 0; i < v->cell_count; i++) {
        if (!(v->volumes[i] >= 0) || !(v->volume_errors[i] >= 0))
            fail("dual", "a volume or its error is no number");
        if (v->unbounded[i] && !on_hull[i])
            fail("dual", "a cell is unbounded and its point not on the hull");
        if ((v->volumes[i] == 0) < (t->representative[i] != (paradt_index)i))
            fail("dual", "the cell of a point that is no vertex has a volume");
    }
}

// --- what is asked

static paradt_status diagram(paradt_voronoi *v, const paradt_triangulation *t, const decoded *in, unsigned outputs,
                             const double *box, const double *plane, size_t tasks) {
    paradt_voronoi_request request;
    paradt_options options;
    memset(&request, 0, sizeof request);
    memset(&options, 0, sizeof options);
    request.outputs = outputs;
    request.box = box;
    request.planes = plane;
    request.plane_count = plane != NULL;
    options.regions = tasks;
    return paradt_voronoi_compute(v, t, &in->points, &request, &options);
}

static int same(const void *a, const void *b, size_t size) {
    return !a == !b && (!a || !size || !memcmp(a, b, size));
}

static void expect_same_bits(const paradt_voronoi *a, const paradt_voronoi *b) {
    size_t n = a->cell_count, dim = (size_t)a->dim, faces = a->face_count;
    if (a->dim != b->dim || n != b->cell_count || faces != b->face_count || a->vertex_count != b->vertex_count ||
        !same(a->volumes, b->volumes, n * sizeof(double)) || !same(a->volume_errors, b->volume_errors, n * sizeof(double)) ||
        !same(a->unbounded, b->unbounded, n) || !same(a->sides, b->sides, 2 * faces * sizeof(paradt_index)) ||
        !same(a->areas, b->areas, faces * sizeof(double)) || !same(a->vertices, b->vertices, a->vertex_count * dim * 8))
        fail("tasks", "they change the diagram");
}

// A plane and its opposite cut each cell of the box in two parts.
static void expect_halves(const decoded *in, const paradt_triangulation *t, const paradt_voronoi *whole, const double *box,
                          source *b) {
    double plane[MOST_DIM + 1];
    paradt_voronoi half[2];
    size_t i;
    int k, side;
    for (k = 0; k <= in->points.dim; k++)
        plane[k] = next_signed(b);
    if (plane[0] == 0 && plane[1] == 0)
        plane[in->spoil & 1] = 1;
    for (side = 0; side < 2; side++) {
        expect_ok(diagram(&half[side], t, in, PARADT_VORONOI_VOLUMES, box, plane, 1), "half");
        for (k = 0; k <= in->points.dim; k++)
            plane[k] = -plane[k];
    }
    for (i = 0; i < whole->cell_count; i++) {
        double parts[3], errors[3];
        parts[0] = half[0].volumes[i];
        parts[1] = half[1].volumes[i];
        parts[2] = 0;
        errors[0] = half[0].volume_errors[i];
        errors[1] = half[1].volume_errors[i];
        errors[2] = whole->volume_errors[i];
        if (all_finite(errors, 3) && !adds_up(parts, errors, 3, &whole->volumes[i], 1))
            fail("halves", "the parts of a cell do not add up to it");
    }
    paradt_voronoi_free(&half[0]);
    paradt_voronoi_free(&half[1]);
}

static void expect_clean_failure(const decoded *in, const paradt_triangulation *t, const double *box) {
    account b;
    paradt_options options = counted_options(&b);
    paradt_voronoi_request request;
    paradt_voronoi v;
    paradt_status status;
    memset(&request, 0, sizeof request);
    request.outputs = in->points.dim < 4 ? 63 : PARADT_VORONOI_VOLUMES | PARADT_VORONOI_FACES;
    request.box = in->spoil & 1 ? box : NULL;
    b.fail_at = in->spoil % 64;
    status = paradt_voronoi_compute(&v, t, &in->points, &request, &options);
    if (status != (has_failed(&b) ? PARADT_ERROR_MEMORY : PARADT_OK))
        fail("failing allocation", paradt_status_string(status));
    paradt_voronoi_free(&v);
    if (b.held)
        fail("failing allocation", "memory was leaked");
}

static void try_box(const decoded *in, const paradt_triangulation *t, unsigned outputs, const double *box, source *planes) {
    paradt_voronoi v;
    expect_ok(diagram(&v, t, in, outputs, box, NULL, 1), "diagram in a box");
    expect_box(&v, box);
    expect_faces(&v, 2 * in->points.dim);
    expect_polygons(&v);
    expect_halves(in, t, &v, box, planes);
    paradt_voronoi_free(&v);
}

static void try_unclipped(const decoded *in, const paradt_triangulation *t, unsigned outputs) {
    paradt_voronoi v, other;
    expect_ok(diagram(&v, t, in, outputs, NULL, NULL, 1), "diagram");
    expect_faces(&v, 0);
    if (t->dim == in->points.dim) {
        expect_polygons(&v);
        expect_dual(&v, t);
    }
    expect_ok(diagram(&other, t, in, outputs, NULL, NULL, in->regions), "diagram by tasks");
    expect_same_bits(&v, &other);
    paradt_voronoi_free(&other);
    paradt_voronoi_free(&v);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const int most_points[MAX_DIM + 1] = {0, 0, 32, 18, 8, 0};
    double box[2 * MOST_DIM];
    unsigned outputs;
    source b = {data, size}, header = {data, size};
    decoded in;
    paradt_triangulation t;
    int k;
    if (size && (data[0] & 3) == 3) // five dimensions
        return 0;
    decode(&in, &b, most_points);
    if (in.first_bad >= 0 || !in.points.count)
        return 0;
    expect_ok(paradt_triangulate(&t, &in.points, NULL), "triangulation");
    for (k = 0; k < in.points.dim; k++) { // of a size that the third byte chooses
        double unit = 1 << (in.spoil >> 2 & 15);
        box[k] = -unit * (1 + (in.spoil >> 6));
        box[in.points.dim + k] = unit * (2 + k);
    }
    outputs = in.points.dim < 4 ? 63 : PARADT_VORONOI_VOLUMES | PARADT_VORONOI_FACES | PARADT_VORONOI_POLYGONS;
    if (asks(&in, 0, 3))
        try_box(&in, &t, outputs, box, &header);
    if (asks(&in, 1, 3))
        try_unclipped(&in, &t, outputs);
    if (asks(&in, 2, 3))
        expect_clean_failure(&in, &t, box);
    paradt_free(&t);
    return 0;
}
