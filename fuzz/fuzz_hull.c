// Any bytes are decoded to points in 2 to 5 dimensions (fuzz.h says how; weights are not used). Then their convex hull
//     - has to be certified by paradt_hull_check, and made alike by several tasks and from the points in reverse order
//     - has to have outward facets: no point may be beyond one, by exact orientations
//     - has to have facets that are those of the triangulation with a cell on one side only
//     - has to have the triangulation's volume, within the error that is stated, by wide integers
//     - has to have extreme points that are its corners: each is beyond a facet of the hull of the others
// A failing allocation has to be reported, and may not leak memory. in->spoil is its number, and that of the element of a
// result that is overwritten: paradt_hull_check may only certify the same facets then.
// A fuzzer does a fourth of this with an input.
#include "fuzz.h"
#include "wide.h"

// The hull has to be certified.
static void certify(const paradt_hull *hull, const paradt_points *points, unsigned flags, const char *what) {
    paradt_options options;
    paradt_fault fault;
    paradt_status status;
    memset(&options, 0, sizeof options);
    options.flags = flags;
    status = paradt_hull_check(hull, points, &options, &fault);
    if (status)
        fail(what, fault.reason ? fault.reason : paradt_status_string(status));
}

// No point may be beyond a facet. Only where the points span their dimension.
static void expect_outward(const decoded *in, const paradt_hull *hull) {
    const double *p[MAX_DIM + 1];
    size_t dim = (size_t)hull->dim, f, q, i;
    for (f = 0; f < hull->facet_count; f++) {
        int inside = 0;
        for (i = 0; i < dim; i++)
            p[i + 1] = in->x + (size_t)hull->facets[f * dim + i] * dim;
        for (q = 0; q < in->points.count; q++) {
            int side;
            p[0] = in->x + q * dim;
            side = paradt_orient((int)dim, p);
            if (side < 0)
                fail("hull", "a point is beyond a facet");
            inside |= side;
        }
        if (!inside)
            fail("hull", "a facet is flat");
    }
}

// Each ridge has to lead to the facet that leads back by it.
static void expect_mirrors(const paradt_hull *hull) {
    size_t ridges = hull->neighbors ? hull->facet_count * (size_t)hull->dim : 0, r;
    for (r = 0; r < ridges; r++) {
        paradt_index mirror = hull->neighbors[r];
        if (mirror < 0 || (size_t)mirror >= ridges || hull->neighbors[mirror] != (paradt_index)r)
            fail("hull", "a ridge is not its mirror's mirror");
    }
}

static void expect_facets_of_triangulation(const paradt_hull *hull, const paradt_triangulation *t) {
    uint64_t sum = 0;
    size_t corners = (size_t)t->dim + 1, f, j;
    for (f = 0; t->dim > 0 && f < t->cell_count * corners; f++) {
        uint64_t vertices[MAX_DIM + 1];
        int count = 0;
        if (t->neighbors[f] >= 0)
            continue;
        for (j = 0; j < corners; j++)
            if (j != f % corners)
                vertices[count++] = (uint64_t)t->cells[f / corners * corners + j];
        sum += paradt_hash_cell(vertices, count);
    }
    if (hull->dim != t->dim || sum != paradt_hull_hash(hull))
        fail("hull", "its facets are not those of the triangulation");
}

// The exact volume, times dim!, has to be within the error of the one that is stated.
static void expect_volume(const decoded *in, const paradt_hull *hull, const paradt_triangulation *t) {
    static wide edges[WIDE_COLUMNS][WIDE_COLUMNS], volume, cell, number, bound, factor;
    int dim = t->dim, scale = 1000, i, k, least;
    uint32_t factorial = 1;
    size_t c;
    if (!is_finite(hull->volume) || !is_finite(hull->volume_error))
        return;
    for (i = 0; i < (int)in->points.count * dim; i++)
        if (in->x[i] != 0 && wide_scale(in->x[i]) < scale)
            scale = wide_scale(in->x[i]);
    volume.sign = volume.count = 0;
    for (c = 0; c < t->cell_count; c++) {
        const paradt_index *v = t->cells + c * (size_t)(dim + 1);
        for (i = 0; i < dim; i++)
            for (k = 0; k < dim; k++) {
                wide_of(&edges[i][k], in->x[v[i + 1] * dim + k], scale);
                wide_of(&number, in->x[v[0] * dim + k], scale);
                wide_add(&edges[i][k], &number, -1);
            }
        wide_determinant(&cell, edges, dim);
        wide_add(&volume, &cell, 1);
    }
    // Now with the scale of the numbers that are stated, which may be less: volume - dim! * stated, at most dim! * error
    least = dim * scale;
    if (hull->volume != 0 && wide_scale(hull->volume) < least)
        least = wide_scale(hull->volume);
    if (hull->volume_error != 0 && wide_scale(hull->volume_error) < least)
        least = wide_scale(hull->volume_error);
    for (i = 2; i <= dim; i++)
        factorial *= (uint32_t)i;
    wide_power(&factor, dim * scale - least);
    wide_multiply(&cell, &volume, &factor);
    wide_small(&factor, factorial);
    wide_of(&number, hull->volume, least);
    wide_multiply(&bound, &number, &factor);
    wide_add(&cell, &bound, -1);
    wide_of(&number, hull->volume_error, least);
    wide_multiply(&bound, &number, &factor);
    if (wide_compare_sizes(&cell, &bound) > 0)
        fail("hull", "the volume is further from the true one than its error");
}

// Without an extreme point the hull has to be another; without another vertex its corners are the same.
static void expect_extreme(const decoded *in, const paradt_hull *hull) {
    size_t dim = (size_t)in->points.dim, v;
    size_t chosen = hull->vertex_count ? (size_t)in->spoil % hull->vertex_count : 0, i;
    decoded less = *in;
    paradt_hull other;
    int reaches = 0;
    if (hull->dim != in->points.dim)
        return;
    for (v = 1; v < hull->vertex_count; v++)
        if (v != hull->extreme_count && hull->vertices[v] <= hull->vertices[v - 1])
            fail("hull", "its vertices are not ascending");
    less.points.data = less.x;
    less.points.weights = NULL;
    for (i = 0; i < in->points.count; i++) // to the place of another vertex, with all that are there
        if (is_same_place(in->x + i * dim, in->x + (size_t)hull->vertices[chosen] * dim, dim))
            memcpy(less.x + i * dim, in->x + (size_t)hull->vertices[!chosen] * dim, dim * sizeof(double));
    expect_ok(paradt_hull_compute(&other, &less.points, NULL), "hull without a point");
    for (i = 0; i < other.facet_count && other.dim == (int)dim; i++) {
        const double *p[MAX_DIM + 1];
        for (v = 0; v < dim; v++)
            p[v + 1] = less.x + (size_t)other.facets[i * dim + v] * dim;
        p[0] = in->x + (size_t)hull->vertices[chosen] * dim;
        reaches |= paradt_orient((int)dim, p) < 0;
    }
    reaches |= other.dim < (int)dim;
    if (reaches != (chosen < hull->extreme_count))
        fail("hull", "a vertex is called extreme that is not, or the other way round");
    paradt_hull_free(&other);
}

static void expect_same_by_tasks(const decoded *in, const paradt_hull *hull) {
    paradt_options options;
    paradt_hull other;
    memset(&options, 0, sizeof options);
    options.regions = in->regions;
    options.flags = PARADT_FACETS;
    expect_ok(paradt_hull_compute(&other, &in->points, &options), "hull by tasks");
    if (other.dim != hull->dim || paradt_hull_hash(&other) != paradt_hull_hash(hull) ||
        other.plane_count != hull->plane_count || other.extreme_count != hull->extreme_count ||
        other.vertex_count != hull->vertex_count ||
        (hull->vertex_count && memcmp(other.vertices, hull->vertices, hull->vertex_count * sizeof *hull->vertices)))
        fail("hull", "the tasks change it");
    expect_mirrors(&other);
    certify(&other, &in->points, PARADT_FACETS, "hull by tasks");
    paradt_hull_free(&other);
}

// Overwrites one element of an array, and restores it. The hull may be certified only if the facets are still the same.
static void expect_no_false_certificate(const decoded *in, const paradt_hull *hull, paradt_index *array, size_t count) {
    size_t place;
    paradt_index right;
    uint64_t hash = paradt_hull_hash(hull);
    if (!array || !count)
        return;
    place = (size_t)in->spoil * 7 % count;
    right = array[place];
    array[place] = (paradt_index)(in->spoil % 4 == 0 ? (uint32_t)in->spoil * 2654435761u : (uint32_t)(in->spoil % 67) - 2u);
    if (array[place] != right && paradt_hull_check(hull, &in->points, NULL, NULL) == PARADT_OK &&
        (array != hull->facets || paradt_hull_hash(hull) != hash))
        fail("spoiled hull", "it was certified");
    array[place] = right;
}

static void expect_clean_failure(const decoded *in, const paradt_hull *hull) {
    account b;
    paradt_options options = counted_options(&b);
    paradt_hull other;
    paradt_status status;
    b.fail_at = in->spoil % 64;
    status = paradt_hull_compute(&other, &in->points, &options);
    if (status != (has_failed(&b) ? PARADT_ERROR_MEMORY : PARADT_OK))
        fail("failing allocation", paradt_status_string(status));
    if (!status && paradt_hull_hash(&other) != paradt_hull_hash(hull))
        fail("own allocator", "the facets are others");
    paradt_hull_free(&other);
    if (b.held)
        fail("failing allocation", "memory was leaked");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const int most_points[MAX_DIM + 1] = {0, 0, 64, 40, 20, 12};
    source b = {data, size};
    decoded in;
    paradt_hull hull;
    paradt_triangulation t;
    paradt_status status;
    size_t ridges;
    decode(&in, &b, most_points);
    in.points.weights = NULL;
    status = paradt_hull_compute(&hull, &in.points, NULL);
    if (in.first_bad >= 0) {
        if (status == PARADT_ERROR_NOT_FINITE || (!status && !is_finite(in.w[in.first_bad]))) {
            paradt_hull_free(&hull);
            return 0;
        }
        fail("not finite", "the point was not reported");
    }
    expect_ok(status, "hull");
    expect_ok(paradt_triangulate(&t, &in.points, NULL), "triangulation");
    certify(&hull, &in.points, 0, "hull");
    expect_facets_of_triangulation(&hull, &t);
    if (asks(&in, 0, 4))
        expect_same_by_tasks(&in, &hull);
    if (asks(&in, 1, 4) && hull.dim == in.points.dim) {
        expect_outward(&in, &hull);
        expect_extreme(&in, &hull);
    }
    if (asks(&in, 2, 4) && hull.dim == in.points.dim && hull.dim <= 3)
        expect_volume(&in, &hull, &t);
    if (asks(&in, 3, 4)) {
        ridges = hull.facet_count * (size_t)(hull.dim > 0 ? hull.dim : 0);
        expect_no_false_certificate(&in, &hull, hull.facets, ridges);
        expect_no_false_certificate(&in, &hull, hull.neighbors, ridges);
        expect_clean_failure(&in, &hull);
    }
    paradt_free(&t);
    paradt_hull_free(&hull);
    return 0;
}
