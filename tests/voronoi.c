// Voronoi and power diagrams against their definition in rational numbers: each cell is the box cut by the half-spaces of all
// other points and of all planes, by the double description method. Structure is compared exactly, measures within the stated
// errors.
#include "harness.h"
#include "runners.h"

// --- the definition, in rational numbers

enum { MOST_PLANES = 64 };

typedef struct place {
    mpq_t x[CELLS_MAX_DIM];
    uint64_t tight; // the planes that it is on
} place;

typedef struct halfspace {
    mpq_t normal[CELLS_MAX_DIM], offset; // normal . x <= offset
    int side;                            // a point, or -1 - k: wall k
    int far;                             // a wall that stands for infinity
} halfspace;

typedef struct true_cell {
    int dim, plane_count, vertex_count, capacity;
    halfspace plane[MOST_PLANES];
    place *vertex;
    int rank; // affine dimension of the vertices; -1: the cell is empty
} true_cell;

static void place_init(place *p, int dim) {
    for (int j = 0; j < dim; j++)
        mpq_init(p->x[j]);
    p->tight = 0;
}

static void place_clear(place *p, int dim) {
    for (int j = 0; j < dim; j++)
        mpq_clear(p->x[j]);
}

static place *cell_new_vertex(true_cell *c) {
    if (c->vertex_count == c->capacity) {
        c->capacity = 2 * c->capacity + 16;
        c->vertex = (place *)realloc(c->vertex, (size_t)c->capacity * sizeof *c->vertex);
        assert_non_null(c->vertex);
    }
    place_init(&c->vertex[c->vertex_count], c->dim);
    return &c->vertex[c->vertex_count++];
}

static halfspace *cell_new_plane(true_cell *c, int side) {
    assert_true(c->plane_count < MOST_PLANES);
    halfspace *h = &c->plane[c->plane_count++];
    for (int j = 0; j < c->dim; j++)
        mpq_init(h->normal[j]);
    mpq_init(h->offset);
    h->side = side;
    h->far = 0;
    return h;
}

static void cell_empty(true_cell *c) {
    for (int i = 0; i < c->vertex_count; i++)
        place_clear(&c->vertex[i], c->dim);
    c->vertex_count = 0;
}

static void cell_free(true_cell *c) {
    cell_empty(c);
    for (int i = 0; i < c->plane_count; i++) {
        for (int j = 0; j < c->dim; j++)
            mpq_clear(c->plane[i].normal[j]);
        mpq_clear(c->plane[i].offset);
    }
    free(c->vertex);
}

// value = normal . x - offset
static void cell_evaluate(mpq_t value, const halfspace *h, const place *p, int dim) {
    mpq_t term;
    mpq_init(term);
    mpq_neg(value, h->offset);
    for (int j = 0; j < dim; j++) {
        mpq_mul(term, h->normal[j], p->x[j]);
        mpq_add(value, value, term);
    }
    mpq_clear(term);
}

// Cuts off what is outside of the last plane.
static void cell_cut(true_cell *c) {
    int before = c->vertex_count, number = c->plane_count - 1;
    uint64_t bit = (uint64_t)1 << number;
    mpq_t *value = (mpq_t *)need((size_t)before + 1, sizeof *value);
    for (int i = 0; i < before; i++) {
        mpq_init(value[i]);
        cell_evaluate(value[i], &c->plane[number], &c->vertex[i], c->dim);
        if (mpq_sgn(value[i]) == 0)
            c->vertex[i].tight |= bit;
    }
    for (int a = 0; a < before; a++)
        for (int b = 0; b < before; b++) {
            uint64_t common = c->vertex[a].tight & c->vertex[b].tight;
            int edge = 1;
            if (mpq_sgn(value[a]) <= 0 || mpq_sgn(value[b]) >= 0)
                continue;
            for (int k = 0; k < before && edge; k++)
                edge = k == a || k == b || (common & ~c->vertex[k].tight);
            if (!edge)
                continue;
            place *made = cell_new_vertex(c);
            mpq_t t, u;
            mpq_inits(t, u, NULL);
            mpq_sub(t, value[a], value[b]);
            mpq_div(t, value[a], t); // of the way from a to b
            for (int j = 0; j < c->dim; j++) {
                mpq_sub(u, c->vertex[b].x[j], c->vertex[a].x[j]);
                mpq_mul(u, u, t);
                mpq_add(made->x[j], c->vertex[a].x[j], u);
            }
            made->tight = common | bit;
            mpq_clears(t, u, NULL);
        }
    int kept = 0;
    for (int i = 0; i < c->vertex_count; i++) {
        if (i < before && mpq_sgn(value[i]) > 0) {
            place_clear(&c->vertex[i], c->dim);
            continue;
        }
        c->vertex[kept++] = c->vertex[i];
    }
    c->vertex_count = kept;
    for (int i = 0; i < before; i++)
        mpq_clear(value[i]);
    free(value);
}

// The affine dimension of some vertices; -1 for none
static int rank_of(const true_cell *c, const int *list, int count) {
    int rank = 0, d = c->dim;
    mpq_t(*m)[CELLS_MAX_DIM] = (mpq_t(*)[CELLS_MAX_DIM])need((size_t)count + 1, sizeof *m), t;
    if (!count) {
        free(m);
        return -1;
    }
    mpq_init(t);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < d; j++) {
            mpq_init(m[i][j]);
            mpq_sub(m[i][j], c->vertex[list[i]].x[j], c->vertex[list[0]].x[j]);
        }
    for (int column = 0; column < d && rank < count; column++) {
        int pivot = rank;
        while (pivot < count && mpq_sgn(m[pivot][column]) == 0)
            pivot++;
        if (pivot == count)
            continue;
        for (int j = 0; j < d; j++)
            mpq_swap(m[pivot][j], m[rank][j]);
        for (int i = rank + 1; i < count; i++)
            for (int j = d - 1; j >= column; j--) {
                mpq_div(t, m[i][column], m[rank][column]);
                mpq_mul(t, t, m[rank][j]);
                mpq_sub(m[i][j], m[i][j], t);
            }
        rank++;
    }
    for (int i = 0; i < count; i++)
        for (int j = 0; j < d; j++)
            mpq_clear(m[i][j]);
    mpq_clear(t);
    free(m);
    return rank;
}

// The vertices of a list that are on a plane
static int vertices_on(const true_cell *c, const int *list, int count, int plane, int *out) {
    int found = 0;
    for (int i = 0; i < count; i++)
        if (c->vertex[list[i]].tight >> plane & 1)
            out[found++] = list[i];
    return found;
}

// Adds the simplices of a face of dimension k to the volume times dim!, and to the moment times (dim + 1)!.
static void add_simplices(const true_cell *c, const int *list, int count, int k, int *apexes, mpq_t volume,
                          mpq_t *moment) {
    int d = c->dim;
    apexes[d - k] = list[0];
    if (k == 0) {
        mpq_t m[CELLS_MAX_DIM][CELLS_MAX_DIM], det, t;
        mpq_inits(det, t, NULL);
        mpq_set_si(det, 1, 1);
        for (int i = 0; i < d; i++)
            for (int j = 0; j < d; j++) {
                mpq_init(m[i][j]);
                mpq_sub(m[i][j], c->vertex[apexes[i + 1]].x[j], c->vertex[apexes[0]].x[j]);
            }
        for (int i = 0; i < d; i++) {
            int pivot = i;
            while (pivot < d && mpq_sgn(m[pivot][i]) == 0)
                pivot++;
            if (pivot == d) {
                mpq_set_si(det, 0, 1);
                break;
            }
            for (int j = 0; j < d && pivot != i; j++)
                mpq_swap(m[pivot][j], m[i][j]);
            mpq_mul(det, det, m[i][i]);
            for (int r = i + 1; r < d; r++)
                for (int j = d - 1; j >= i; j--) {
                    mpq_div(t, m[r][i], m[i][i]);
                    mpq_mul(t, t, m[i][j]);
                    mpq_sub(m[r][j], m[r][j], t);
                }
        }
        mpq_abs(det, det);
        mpq_add(volume, volume, det);
        for (int j = 0; j < d && moment; j++)
            for (int i = 0; i <= d; i++) {
                mpq_mul(t, det, c->vertex[apexes[i]].x[j]);
                mpq_add(moment[j], moment[j], t);
            }
        for (int i = 0; i < d; i++)
            for (int j = 0; j < d; j++)
                mpq_clear(m[i][j]);
        mpq_clears(det, t, NULL);
        return;
    }
    int *sub = (int *)need((size_t)count, sizeof *sub), *other = (int *)need((size_t)count, sizeof *other);
    for (int h = 0; h < c->plane_count; h++) {
        int n = vertices_on(c, list, count, h, sub), seen = 0;
        if (!n || n == count || c->vertex[list[0]].tight >> h & 1)
            continue;
        for (int g = 0; g < h && !seen; g++) // another plane with the same vertices
            seen = vertices_on(c, list, count, g, other) == n && !memcmp(sub, other, (size_t)n * sizeof *sub);
        if (!seen && rank_of(c, sub, n) == k - 1)
            add_simplices(c, sub, n, k - 1, apexes, volume, moment);
    }
    free(sub);
    free(other);
}

// --- a case: points, and what clips their cells

typedef struct clip {
    const char *name;
    double *box;
    double *planes;
    size_t plane_count;
} clip;

// The cell of point p. `far` is the exponent of the size of what stands for infinity.
static true_cell cell_of(const sample *s, const clip *k, int p, int far) {
    true_cell c = {0};
    int d = c.dim = s->dim;
    mpq_t t, infinity;
    mpq_inits(t, infinity, NULL);
    mpq_set_si(infinity, 1, 1);
    mpq_mul_2exp(infinity, infinity, (mp_bitcnt_t)far);
    for (int i = 0; i < 2 * d; i++) {
        halfspace *h = cell_new_plane(&c, -1 - i);
        int open = !k->box || isinf(k->box[i]);
        mpq_set_si(h->normal[i % d], i < d ? -1 : 1, 1);
        if (open)
            mpq_set(h->offset, infinity);
        else
            mpq_set_d(h->offset, i < d ? -k->box[i] : k->box[i]);
        h->far = open;
    }
    for (int corner = 0; corner < 1 << d; corner++) {
        place *v = cell_new_vertex(&c);
        for (int j = 0; j < d; j++) {
            int wall = j + (corner >> j & 1 ? d : 0);
            mpq_set(v->x[j], c.plane[wall].offset);
            if (wall < d)
                mpq_neg(v->x[j], v->x[j]);
            v->tight |= (uint64_t)1 << wall;
        }
    }
    for (int j = 0; j < d; j++) { // a box of no width has its corners twice
        mpq_add(t, c.plane[j].offset, c.plane[j + d].offset);
        if (mpq_sgn(t) < 0)
            cell_empty(&c);
    }
    for (size_t i = 0; i < k->plane_count; i++) {
        halfspace *h = cell_new_plane(&c, -1 - 2 * d - (int)i);
        for (int j = 0; j < d; j++)
            mpq_set_d(h->normal[j], k->planes[i * (size_t)(d + 1) + (size_t)j]);
        mpq_set_d(h->offset, k->planes[i * (size_t)(d + 1) + (size_t)d]);
        cell_cut(&c);
    }
    for (int q = 0; q < s->count; q++) { // |x - p|^2 - w_p <= |x - q|^2 - w_q
        const double *from = s->x + p * d, *to = s->x + q * d;
        if (!compare_coordinates(from, to, d)) {
            if (s->w && q != p && (s->w[q] > s->w[p] || (s->w[q] == s->w[p] && q < p)))
                cell_empty(&c);
            if (!s->w && q < p)
                cell_empty(&c);
            continue;
        }
        halfspace *h = cell_new_plane(&c, q);
        for (int j = 0; j < d; j++) {
            mpq_t a, b;
            mpq_inits(a, b, NULL);
            mpq_set_d(a, from[j]);
            mpq_set_d(b, to[j]);
            mpq_sub(h->normal[j], b, a);
            mpq_mul_2exp(h->normal[j], h->normal[j], 1);
            mpq_mul(a, a, a);
            mpq_mul(b, b, b);
            mpq_add(h->offset, h->offset, b);
            mpq_sub(h->offset, h->offset, a);
            mpq_clears(a, b, NULL);
        }
        if (s->w) {
            mpq_set_d(t, s->w[p]);
            mpq_add(h->offset, h->offset, t);
            mpq_set_d(t, s->w[q]);
            mpq_sub(h->offset, h->offset, t);
        }
        cell_cut(&c);
    }
    int *all = (int *)need((size_t)c.vertex_count + 1, sizeof *all);
    for (int i = 0; i < c.vertex_count; i++)
        all[i] = i;
    c.rank = rank_of(&c, all, c.vertex_count);
    free(all);
    mpq_clears(t, infinity, NULL);
    return c;
}

static int is_far(const true_cell *c, const place *v) {
    for (int h = 0; h < c->plane_count; h++)
        if (c->plane[h].far && v->tight >> h & 1)
            return 1;
    return 0;
}

// --- comparing

static const char *check_cell_measures(const paradt_voronoi *v, const true_cell *c, int p, int ordinary) {
    int d = c->dim, unbounded = 0, *all = (int *)need((size_t)c->vertex_count + 1, sizeof *all), apexes[CELLS_MAX_DIM + 1];
    const char *wrong = NULL;
    for (int i = 0; i < c->vertex_count; i++) {
        all[i] = i;
        unbounded |= is_far(c, &c->vertex[i]);
    }
    mpq_t volume, t, moment[CELLS_MAX_DIM];
    mpq_inits(volume, t, NULL);
    for (int j = 0; j < d; j++)
        mpq_init(moment[j]);
    if (c->rank == d && !unbounded)
        add_simplices(c, all, c->vertex_count, d, apexes, volume, moment);
    for (int i = 2; i <= d; i++) {
        mpq_set_si(t, i, 1);
        mpq_div(volume, volume, t);
    }
    if (c->rank == d && unbounded != v->unbounded[p])
        wrong = "a cell is unbounded and is not said to be, or the other way round";
    else if (v->volumes && c->rank < d && v->volumes[p] != 0 && !unbounded)
        wrong = "an empty cell has a volume";
    else if (v->volumes && c->rank == d && unbounded && !isinf(v->volumes[p]))
        wrong = "an unbounded cell has a finite volume";
    else if (v->volumes && c->rank == d && !unbounded && !isinf(v->volume_errors[p])) {
        mpq_set_d(t, v->volumes[p]);
        mpq_sub(t, t, volume);
        mpq_abs(t, t);
        double off = mpq_get_d(t), true_volume = mpq_get_d(volume);
        mpq_t error;
        mpq_init(error);
        mpq_set_d(error, v->volume_errors[p]);
        if (mpq_cmp(t, error) > 0) {
            print_message("# volume %.17g, true %.17g, off %g, error %g\n", v->volumes[p], true_volume, off, v->volume_errors[p]);
            wrong = "a volume's error is larger than it says";
        }
        mpq_clear(error);
        if (ordinary && !strncmp(watched->name, "uniform, unweighted", 19) && v->volume_errors[p] > 1e-9 * true_volume + 1e-14) {
            print_message("# volume %g, error %g\n", v->volumes[p], v->volume_errors[p]);
            wrong = "a volume's error is large";
        }
        for (int j = 0; j < d && v->centroids && !wrong && ordinary && v->volumes[p] > 1e6 * v->volume_errors[p]; j++) {
            // moment / (d + 1)! / volume
            double centroid;
            mpq_set(t, moment[j]);
            mpq_div(t, t, volume);
            centroid = mpq_get_d(t);
            for (int i = 2; i <= d + 1; i++)
                centroid /= i;
            if (!(fabs(v->centroids[p * d + j] - centroid) <= 1e-5 * (1 + fabs(centroid))))
                wrong = "a centroid is wrong";
        }
    }
    for (int j = 0; j < d; j++)
        mpq_clear(moment[j]);
    mpq_clears(volume, t, NULL);
    free(all);
    return wrong;
}

// The distance of a vertex of the diagram from a true one, in the largest coordinate
static double vertex_distance(const double *x, const place *v, int d) {
    double most = 0;
    mpq_t t;
    mpq_init(t);
    for (int j = 0; j < d; j++) {
        mpq_set_d(t, x[j]);
        mpq_sub(t, t, v->x[j]);
        most = fmax(most, fabs(mpq_get_d(t)));
    }
    mpq_clear(t);
    return most;
}

// Compares the polygon of a face with the vertices that it has in truth.
static const char *check_polygon(const paradt_voronoi *v, const true_cell *c, const int *list, int count, size_t f,
                                 double reach) {
    int d = c->dim, far = 0, near = 0, listed_far = 0;
    size_t begin = v->first_vertex[f], end = v->first_vertex[f + 1];
    const char *wrong = NULL;
    for (int i = 0; i < count; i++)
        far |= is_far(c, &c->vertex[list[i]]);
    for (size_t i = begin; i < end && !wrong; i++) {
        paradt_index number = v->polygons[i];
        if (number < 0) {
            listed_far++;
            continue;
        }
        int best = -1;
        double least = HUGE_VAL;
        for (int j = 0; j < count; j++) {
            if (is_far(c, &c->vertex[list[j]]))
                continue;
            double distance = vertex_distance(v->vertices + (size_t)number * (size_t)d, &c->vertex[list[j]], d);
            if (distance < least)
                least = distance, best = j;
        }
        double size = 0;
        for (int j = 0; j < d; j++)
            size = fmax(size, fabs(v->vertices[(size_t)number * (size_t)d + (size_t)j]));
        if (best < 0 || least > 1e-11 * (size + reach))
            wrong = "a vertex of a polygon is none of the face's";
        near++;
    }
    int true_near = 0;
    for (int j = 0; j < count; j++)
        true_near += !is_far(c, &c->vertex[list[j]]);
    if (!wrong && near != true_near) {
        print_message("# %d corners, %d in truth\n", near, true_near);
        wrong = "a polygon has too few or too many vertices";
    }
    if (!wrong && listed_far != far)
        wrong = "a polygon does not tell that its face is unbounded, or the other way round";
    return wrong;
}

// The turns of a polygon are to the left when it is seen from the second side.
static const char *check_turns(const paradt_voronoi *v, size_t f, double reach) {
    size_t begin = v->first_vertex[f], count = v->first_vertex[f + 1] - begin;
    const paradt_index *p = v->polygons + begin;
    int d = v->dim;
    for (size_t i = 0; i < count && d == 3; i++) {
        double a[3], b[3], turn = 0, size = reach;
        if (p[i] < 0 || p[(i + 1) % count] < 0 || p[(i + 2) % count] < 0)
            continue;
        for (int j = 0; j < 3; j++) {
            a[j] = v->vertices[3 * p[(i + 1) % count] + j] - v->vertices[3 * p[i] + j];
            b[j] = v->vertices[3 * p[(i + 2) % count] + j] - v->vertices[3 * p[(i + 1) % count] + j];
            for (size_t k = i; k < i + 3; k++)
                size = fmax(size, fabs(v->vertices[3 * p[k % count] + j]));
        }
        for (int j = 0; j < 3; j++)
            turn += v->normals[3 * f + (size_t)j] * (a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3]);
        if (turn < -1e-12 * size * size)
            return "a polygon turns the wrong way";
    }
    if (d == 2 && count == 2 && p[0] >= 0 && p[1] >= 0) {
        double turn = v->normals[2 * f] * (v->vertices[2 * p[1] + 1] - v->vertices[2 * p[0] + 1]) -
                      v->normals[2 * f + 1] * (v->vertices[2 * p[1]] - v->vertices[2 * p[0]]);
        double size = reach;
        for (int k = 0; k < 4; k++)
            size = fmax(size, fabs(v->vertices[2 * p[k / 2] + k % 2]));
        if (turn < -1e-12 * size)
            return "a segment goes the wrong way";
    }
    return NULL;
}

// The measure of a true face in space or in the plane
static double area_of(const true_cell *c, const int *list, int count, int plane) {
    int d = c->dim;
    mpq_t square, volume, distance, t;
    double area;
    mpq_inits(square, volume, distance, t, NULL);
    for (int j = 0; j < d; j++) {
        mpq_mul(t, c->plane[plane].normal[j], c->plane[plane].normal[j]);
        mpq_add(square, square, t);
    }
    if (d == 2) {
        mpq_set_si(square, 0, 1);
        for (int j = 0; j < 2; j++) {
            mpq_sub(t, c->vertex[list[1]].x[j], c->vertex[list[0]].x[j]);
            mpq_mul(t, t, t);
            mpq_add(square, square, t);
        }
        area = sqrt(mpq_get_d(square));
    } else { // the volume of the cone from a place beside it
        true_cell beside = *c;
        int apexes[CELLS_MAX_DIM + 1], *all = (int *)need((size_t)count, sizeof *all);
        beside.vertex = (place *)need((size_t)c->vertex_count + 1, sizeof *beside.vertex);
        memcpy(beside.vertex, c->vertex, (size_t)c->vertex_count * sizeof *beside.vertex);
        place_init(&beside.vertex[c->vertex_count], d);
        for (int j = 0; j < d; j++)
            mpq_add(beside.vertex[c->vertex_count].x[j], c->vertex[list[0]].x[j], c->plane[plane].normal[j]);
        apexes[0] = c->vertex_count;
        memcpy(all, list, (size_t)count * sizeof *all);
        add_simplices(&beside, all, count, d - 1, apexes, volume, NULL);
        area = mpq_get_d(volume) / (2 * sqrt(mpq_get_d(square))); // 3! volume = area 2 |normal|
        place_clear(&beside.vertex[c->vertex_count], d);
        free(beside.vertex);
        free(all);
    }
    mpq_clears(square, volume, distance, t, NULL);
    return area;
}

// Compares the faces of a cell that is not flat with those that it has in truth. used: which faces were found
static const char *check_cell_faces(const paradt_voronoi *v, const true_cell *c, int p, unsigned outputs, double reach,
                                    int ordinary, char *used) {
    int d = c->dim, *list = (int *)need((size_t)c->vertex_count + 1, sizeof *list);
    int *other = (int *)need((size_t)c->vertex_count + 1, sizeof *other), expected = 0;
    const char *wrong = NULL;
    for (int h = 0; h < c->plane_count && !wrong; h++) {
        int n = 0, seen = 0;
        for (int i = 0; i < c->vertex_count; i++)
            if (c->vertex[i].tight >> h & 1)
                list[n++] = i;
        if (c->plane[h].far || rank_of(c, list, n) != d - 1)
            continue;
        size_t f = 0, at;
        int found = 0, wall = 0;
        for (int g = 0; g < c->plane_count; g++) { // planes that coincide: one of the sides is named, a wall first
            int m = 0;
            for (int i = 0; i < c->vertex_count; i++)
                if (c->vertex[i].tight >> g & 1)
                    other[m++] = i;
            if (m != n || memcmp(list, other, (size_t)n * sizeof *list))
                continue;
            seen |= g < h;
            if (wall)
                continue;
            wall = c->plane[g].side < 0;
            for (at = v->first_face[p]; at < v->first_face[p + 1]; at++) {
                size_t number = (size_t)v->faces[at];
                paradt_index a = v->sides[2 * number], b = v->sides[2 * number + 1];
                if ((a == p && b == c->plane[g].side) || (b == p && a == c->plane[g].side))
                    found++, f = number;
            }
            if (wall && !found)
                break;
        }
        if (seen)
            continue;
        expected++;
        if (found != 1) {
            print_message("# cell %d, side %d: %d faces\n", p, c->plane[h].side, found);
            wrong = "a face is missing, or is there twice";
            break;
        }
        used[f] = 1;
        int far = 0;
        for (int i = 0; i < n; i++)
            far |= is_far(c, &c->vertex[list[i]]);
        if (outputs & PARADT_VORONOI_AREAS && (ordinary || far) && far != !!isinf(v->areas[f]))
            wrong = "a face is unbounded and is not said to be, or the other way round";
        if (outputs & PARADT_VORONOI_AREAS && !far && ordinary) {
            double area = area_of(c, list, n, h), size = reach;
            for (int i = 0; i < n; i++)
                for (int j = 0; j < d; j++)
                    size = fmax(size, fabs(mpq_get_d(c->vertex[list[i]].x[j])));
            if (fabs(area - v->areas[f]) > 1e-9 * area + 1e-12 * (d == 3 ? size * size : size)) {
                print_message("# area %g, true %g\n", v->areas[f], area);
                wrong = "an area is wrong";
            }
        }
        if (!wrong && outputs & PARADT_VORONOI_POLYGONS && ordinary)
            wrong = check_polygon(v, c, list, n, f, reach);
    }
    if (!wrong && (size_t)expected != v->first_face[p + 1] - v->first_face[p]) {
        print_message("# cell %d: %d faces, %d in truth\n", p, (int)(v->first_face[p + 1] - v->first_face[p]), expected);
        wrong = "a cell has too many faces";
    }
    free(list);
    free(other);
    return wrong;
}

static size_t count_vertices(mpq_t (*x)[CELLS_MAX_DIM], size_t count, int d) {
    size_t different = 0;
    for (size_t i = 0; i < count; i++) {
        size_t k = 0;
        for (; k < i; k++) {
            int j = 0;
            while (j < d && mpq_equal(x[i][j], x[k][j]))
                j++;
            if (j == d)
                break;
        }
        different += k == i;
    }
    return different;
}

static void check_diagram(const sample *s, const clip *k, unsigned outputs, int ordinary) {
    paradt_points points = points_of(s);
    paradt_triangulation t;
    paradt_voronoi v;
    paradt_voronoi_request request = {0};
    const char *wrong = NULL;
    int d = s->dim, flat_cells = 0, far = ordinary ? 2000 : 30000;
    double reach = 0;
    char text[200];
    size_t places = 0, room = 0;
    mpq_t(*place_of)[CELLS_MAX_DIM] = NULL;
    request.outputs = outputs;
    request.box = k->box;
    request.planes = k->planes;
    request.plane_count = k->plane_count;
    memset(&v, 0x5a, sizeof v);
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    watch(s, 120);
    paradt_status status = paradt_voronoi_compute(&v, &t, &points, &request, NULL);
    if (status) {
        fail_on_sample(s, v.error_text);
        return;
    }
    for (int i = 0; i < s->count * d; i++)
        reach = fmax(reach, fabs(s->x[i]));
    for (int i = 0; i < 2 * d && k->box; i++)
        if (!isinf(k->box[i]))
            reach = fmax(reach, fabs(k->box[i]));
    char *used = (char *)need(v.face_count + 1, 1);
    for (int p = 0; p < s->count && !wrong; p++) {
        true_cell c = cell_of(s, k, p, far);
        wrong = check_cell_measures(&v, &c, p, ordinary);
        if (c.rank >= 0 && c.rank < d)
            flat_cells++;
        if (!wrong && c.rank == d && v.faces)
            wrong = check_cell_faces(&v, &c, p, outputs, reach, ordinary, used);
        for (int i = 0; i < c.vertex_count && outputs & PARADT_VORONOI_POLYGONS && c.rank == d; i++) {
            if (is_far(&c, &c.vertex[i]))
                continue;
            if (places == room) {
                room = 2 * room + 64;
                place_of = (mpq_t(*)[CELLS_MAX_DIM])realloc(place_of, room * sizeof *place_of);
                assert_non_null(place_of);
            }
            for (int j = 0; j < d; j++) {
                mpq_init(place_of[places][j]);
                mpq_set(place_of[places][j], c.vertex[i].x[j]);
            }
            places++;
        }
        cell_free(&c);
    }
    for (size_t f = 0; f < v.face_count && !wrong && v.faces; f++)
        if (!used[f] && !flat_cells)
            wrong = "a face is none";
    for (size_t f = 0; f < v.face_count && !wrong && v.polygons && v.normals && ordinary; f++)
        wrong = check_turns(&v, f, reach);
    if (!wrong && outputs & PARADT_VORONOI_POLYGONS && ordinary && !flat_cells) {
        size_t expected = count_vertices(place_of, places, d);
        if (v.vertex_count != expected) {
            print_message("# %d vertices, %d in truth\n", (int)v.vertex_count, (int)expected);
            wrong = "there are too few or too many vertices";
        }
    }
    watch(NULL, 0);
    if (wrong) {
        snprintf(text, sizeof text, "clipped by %s, outputs %u: %s", k->name, outputs, wrong);
        fail_on_sample(s, text);
    }
    for (size_t i = 0; i < places; i++)
        for (int j = 0; j < d; j++)
            mpq_clear(place_of[i][j]);
    free(place_of);
    free(used);
    paradt_voronoi_free(&v);
    paradt_free(&t);
}

// --- tests

enum { CLIPS = 6 };

// Makes what clips number `kind`: of walls many go through points, or halfway between two.
static clip clip_make(const sample *s, int kind, uint64_t *seed) {
    static const char *const names[] = {"nothing", "the box of the points", "a box through points", "a box between points",
                                        "planes through points", "a box and planes"};
    clip k = {names[kind], NULL, NULL, 0};
    int d = s->dim;
    if (kind == 1 || kind == 2 || kind == 3 || kind == 5) {
        k.box = (double *)need((size_t)(2 * d), sizeof(double));
        for (int j = 0; j < d; j++) {
            double low = HUGE_VAL, high = -HUGE_VAL;
            for (int i = 0; i < s->count && kind == 1; i++) {
                low = fmin(low, s->x[i * d + j]);
                high = fmax(high, s->x[i * d + j]);
            }
            if (kind > 1) {
                low = s->x[random_below(seed, s->count) * d + j];
                high = s->x[random_below(seed, s->count) * d + j];
                if (kind == 3) {
                    low = low / 2 + s->x[random_below(seed, s->count) * d + j] / 2;
                    high = high / 2 + s->x[random_below(seed, s->count) * d + j] / 2;
                }
                if (low > high && random_below(seed, 8)) {
                    double swap = low;
                    low = high;
                    high = swap;
                }
                if (random_below(seed, 6) == 0)
                    high = HUGE_VAL;
            }
            k.box[j] = low;
            k.box[d + j] = high;
        }
    }
    if (kind >= 4) {
        k.plane_count = 1 + (size_t)random_below(seed, 3);
        k.planes = (double *)need(k.plane_count * (size_t)(d + 1), sizeof(double));
        for (size_t i = 0; i < k.plane_count; i++) {
            double *plane = k.planes + i * (size_t)(d + 1);
            const double *through = s->x + random_below(seed, s->count) * d;
            do
                for (int j = 0; j < d; j++)
                    plane[j] = random_below(seed, 5) - 2;
            while (!memcmp(plane, (double[CELLS_MAX_DIM]){0}, (size_t)d * sizeof(double)));
            for (int j = 0; j < d; j++) {
                if (plane[j] == 0)
                    plane[j] = 0;
                plane[d] += plane[j] * through[j]; // rounded, so that it may miss the point by little
            }
            if (isinf(plane[d]) || isnan(plane[d]))
                plane[d] = 0;
        }
    }
    return k;
}

// Each family gets every `step`-th way of clipping, families next to each other different ones.
static void compare_families(int dim, int count, unsigned outputs, const weighting *w, int seeds, int step) {
    for (int f = 0; f < FAMILY_COUNT; f++) {
        // Rational arithmetic on all magnitudes takes seconds a set in high dimensions.
        int most = families[f].extremes && dim > 3 ? dim + 2 : count;
        for (int kind = f % step; kind < CLIPS; kind += step)
            for (uint64_t seed = 1; seed <= (uint64_t)seeds; seed++) {
                if (SANITIZED && w && (f + dim + (int)(w - weightings)) % 2) // weightings take turns
                    continue;
                sample s = family_make(&families[f], w, dim, most, seed * 7 + (uint64_t)kind);
                uint64_t state = seed * 1000 + (uint64_t)kind;
                clip k = clip_make(&s, kind, &state);
                check_diagram(&s, &k, outputs, !families[f].extremes && !(w && w->extremes));
                free(k.box);
                free(k.planes);
                sample_free(&s);
            }
    }
}

enum { EVERYTHING = 63 };

static void cells_in_the_plane_are_those_of_the_definition(void **state) {
    (void)state;
    compare_families(2, 12, EVERYTHING, NULL, 1, SANITIZED ? 2 : 1);
}

static void cells_in_space_are_those_of_the_definition(void **state) {
    (void)state;
    compare_families(3, 14, EVERYTHING, NULL, 1, SANITIZED ? 3 : 2);
}

static void power_diagrams_are_those_of_the_definition(void **state) {
    (void)state;
    for (size_t w = 1; w < sizeof weightings / sizeof *weightings; w++) {
        compare_families(2, 10, EVERYTHING, &weightings[w], 1, is_quick() || SANITIZED ? CLIPS : 2);
        compare_families(3, 10, EVERYTHING, &weightings[w], 1, is_quick() || SANITIZED ? CLIPS : 3);
    }
}

static void cells_of_higher_dimensions_are_those_of_the_definition(void **state) {
    (void)state;
    const unsigned outputs = PARADT_VORONOI_VOLUMES | PARADT_VORONOI_FACES | PARADT_VORONOI_POLYGONS;
    compare_families(4, 9, outputs, NULL, 1, CLIPS);
    if (is_quick() || SANITIZED)
        return;
    compare_families(4, 9, outputs, &weightings[3], 1, CLIPS);
    compare_families(5, 8, outputs, NULL, 1, CLIPS);
}

// --- many points

static paradt_voronoi diagram_of(const sample *s, const paradt_voronoi_request *request, const paradt_options *options) {
    paradt_points points = points_of(s);
    paradt_triangulation t;
    paradt_voronoi v;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    watch(s, 120);
    paradt_status status = paradt_voronoi_compute(&v, &t, &points, request, options);
    watch(NULL, 0);
    if (status)
        fail_on_sample(s, v.error_text);
    paradt_free(&t);
    return v;
}

// The faces of a cell close it, and the cones over them make up its volume.
static const char *check_closed(const sample *s, const paradt_voronoi *v, double tolerance) {
    int d = s->dim;
    for (int p = 0; p < s->count; p++) {
        double sum[3] = {0}, area = 0, volume = 0;
        if (v->unbounded[p])
            continue;
        for (size_t at = v->first_face[p]; at < v->first_face[p + 1]; at++) {
            size_t f = (size_t)v->faces[at];
            double sign = v->sides[2 * f] == p ? 1 : -1, height = 0;
            area += v->areas[f];
            for (int j = 0; j < d; j++) {
                sum[j] += sign * v->areas[f] * v->normals[f * (size_t)d + (size_t)j];
                height += sign * v->normals[f * (size_t)d + (size_t)j] *
                          (v->face_centroids[f * (size_t)d + (size_t)j] - s->x[p * d + j]);
            }
            volume += height * v->areas[f] / d;
        }
        for (int j = 0; j < d; j++)
            if (fabs(sum[j]) > tolerance * (area + 1e-3))
                return "a cell's faces do not close it";
        if (fabs(volume - v->volumes[p]) > tolerance * (volume + 1e-3))
            return "a cell's volume is not that of the cones over its faces";
    }
    return NULL;
}

static void many_cells_fill_the_box(void **state) {
    (void)state;
    static const char *const chosen[] = {"uniform", "clusters", "lattice", "fcc", "sphere", "duplicates", "lattice off by ulps"};
    for (int dim = 2; dim <= 3; dim++)
        for (size_t c = 0; c < sizeof chosen / sizeof *chosen; c++) {
            sample s = family_make(&families[family_named(chosen[c])], NULL, dim, SANITIZED || is_quick() ? 2000 : 6000, 5);
            double low = HUGE_VAL, high = -HUGE_VAL, box[6], whole = 1;
            const char *wrong;
            for (int i = 0; i < s.count * dim; i++) {
                low = fmin(low, s.x[i]);
                high = fmax(high, s.x[i]);
            }
            for (int j = 0; j < dim; j++) {
                box[j] = c % 2 ? low : (3 * low + high) / 4; // walls through points, or between them
                box[dim + j] = high;
                whole *= box[dim + j] - box[j];
            }
            paradt_voronoi_request request = {0};
            request.outputs = EVERYTHING;
            request.box = box;
            paradt_voronoi v = diagram_of(&s, &request, NULL);
            if (!(fabs(v.volume - whole) <= 1e-12 * whole))
                fail_on_sample(&s, "the volumes do not sum up to the box's");
            wrong = check_closed(&s, &v, 1e-9);
            if (wrong)
                fail_on_sample(&s, wrong);
            for (int i = 0; i < 12; i++) { // with their neighbours alone, some cells are what they are
                int p = (int)((long)i * s.count / 12), order[MOST_PLANES], count = 1;
                if (v.first_face[p + 1] - v.first_face[p] > 40 || v.volumes[p] == 0)
                    continue;
                order[0] = p;
                for (size_t at = v.first_face[p]; at < v.first_face[p + 1]; at++) {
                    paradt_index other = v.sides[2 * v.faces[at]] == p ? v.sides[2 * v.faces[at] + 1] : v.sides[2 * v.faces[at]];
                    if (other >= 0)
                        order[count++] = other;
                }
                clip k = {"the box", box, NULL, 0};
                sample few = sample_pick(&s, order, count);
                true_cell exact = cell_of(&few, &k, 0, 100);
                int all[256], apexes[CELLS_MAX_DIM + 1];
                mpq_t volume, error;
                mpq_inits(volume, error, NULL);
                assert_true(exact.vertex_count <= 256);
                for (int j = 0; j < exact.vertex_count; j++)
                    all[j] = j;
                add_simplices(&exact, all, exact.vertex_count, dim, apexes, volume, NULL);
                mpq_set_si(error, dim == 2 ? 2 : 6, 1);
                mpq_div(volume, volume, error);
                mpq_set_d(error, v.volumes[p]);
                mpq_sub(volume, volume, error);
                mpq_abs(volume, volume);
                mpq_set_d(error, v.volume_errors[p]);
                if (mpq_cmp(volume, error) > 0)
                    fail_on_sample(&s, "a volume's error is larger than it says");
                mpq_clears(volume, error, NULL);
                cell_free(&exact);
                sample_free(&few);
            }
            paradt_voronoi_free(&v);
            sample_free(&s);
        }
}

// A point with very many neighbours, inside and on the hull
static void cells_may_have_thousands_of_faces(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int inside = 0; inside < 2; inside++) {
            int count = SANITIZED ? 300 : 3000;
            sample s = family_make(&families[family_named("sphere")], NULL, dim, count, 1);
            double box[6] = {-2, -2, -2, 2, 2, 2}, plane[] = {1, 0.5, dim == 3 ? 0.25 : 0.4, 0.4};
            if (dim == 2)
                box[2] = 2, box[3] = 2, plane[2] = 0.4;
            for (int j = 0; j < dim; j++)
                s.x[j] = inside || j ? 0 : -100;
            for (int i = 1; i < count && !inside; i++) // a cap, seen from afar
                s.x[i * dim] = fabs(s.x[i * dim]) * 1e-3;
            paradt_voronoi_request request = {0};
            request.outputs = EVERYTHING;
            request.box = box;
            request.planes = plane;
            request.plane_count = 1;
            paradt_voronoi v = diagram_of(&s, &request, NULL);
            const char *wrong = check_closed(&s, &v, 1e-8);
            if (wrong)
                fail_on_sample(&s, wrong);
            paradt_voronoi_free(&v);
            request.box = NULL;
            request.plane_count = 0;
            v = diagram_of(&s, &request, NULL);
            wrong = check_closed(&s, &v, 1e-8);
            if (wrong)
                fail_on_sample(&s, wrong);
            paradt_voronoi_free(&v);
            sample_free(&s);
        }
}

// --- threads

#define SAME(one, many, array, count)                                                                                  \
    do {                                                                                                               \
        assert_true(!(one).array == !(many).array);                                                                    \
        if ((one).array)                                                                                               \
            assert_memory_equal((one).array, (many).array, (size_t)(count) * sizeof *(one).array);                    \
    } while (0)

static void threads_give_the_same_bits(void **state) {
    (void)state;
    static const char *const chosen[] = {"uniform", "lattice", "clusters"};
    for (int dim = 2; dim <= 4; dim++)
        for (size_t c = 0; c < 3; c++)
            for (unsigned outputs = dim < 4 ? EVERYTHING : 21u; outputs; outputs = outputs > 1 ? 1 : 0) {
                sample s = family_make(&families[family_named(chosen[c])], NULL, dim, dim == 4 ? 2100 / (SANITIZED ? 10 : 4) : SANITIZED ? 3000 : 12000, 3);
                paradt_options options = {0};
                double box[] = {0.1, 0.1, 0.1, 0.1, 0.7, 0.8, 0.9, 0.9};
                for (int j = 0; j < dim && dim < 4; j++)
                    box[dim + j] = c == 1 ? 4 : 0.9;
                paradt_voronoi_request request = {0};
                request.outputs = outputs;
                request.box = box;
                paradt_voronoi one = diagram_of(&s, &request, NULL), many;
                for (size_t tasks = 2; tasks <= 4; tasks += 1 + RACES_ONLY) { // three of them run backwards
                    options.parallel_for = tasks == 3 ? run_backwards : run_on_threads;
                    options.regions = tasks;
                    many = diagram_of(&s, &request, &options);
                    assert_int_equal(one.face_count, many.face_count);
                    assert_int_equal(one.vertex_count, many.vertex_count);
                    assert_true(one.volume == many.volume);
                    SAME(one, many, volumes, one.cell_count);
                    SAME(one, many, volume_errors, one.cell_count);
                    SAME(one, many, unbounded, one.cell_count);
                    SAME(one, many, sides, 2 * one.face_count);
                    SAME(one, many, areas, one.face_count);
                    SAME(one, many, normals, one.face_count * (size_t)dim);
                    SAME(one, many, faces, one.first_face[one.cell_count]);
                    SAME(one, many, vertices, one.vertex_count * (size_t)dim);
                    SAME(one, many, polygons, one.first_vertex[one.face_count]);
                    paradt_voronoi_free(&many);
                }
                paradt_voronoi_free(&one);
                sample_free(&s);
            }
}

// --- memory, cancelling, arguments

typedef struct books {
    size_t calls, fail_at, live;
} books;

static void *books_alloc(void *user, size_t size) {
    books *b = (books *)user;
    void *block = ++b->calls == b->fail_at ? NULL : malloc(size);
    b->live += block != NULL;
    return block;
}

static void books_free(void *user, void *memory) {
    ((books *)user)->live--;
    free(memory);
}

static void expect_empty(const paradt_voronoi *v) {
    assert_int_equal(v->dim, -1);
    assert_true(!v->volumes && !v->sides && !v->unbounded && !v->vertices && !v->polygons && v->error_text);
    assert_true(v->cell_count + v->face_count + v->vertex_count == 0);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (int large = 0; large <= (dim < 4); large++) {
            sample s = family_make(&families[family_named(large ? "uniform" : "lattice")], NULL, dim, large ? 2500 : 40, 3);
            paradt_points points = points_of(&s);
            paradt_triangulation t;
            double box[] = {0.1, 0.1, 0.1, 0.1, 0.9, 0.9, 0.9, 0.9};
            for (int j = 0; j < dim; j++)
                box[dim + j] = 0.9;
            assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
            for (int parallel = 0; parallel < 2; parallel++)
                for (size_t at = 1;; at += large && (SANITIZED || at > 50) ? 23 : SANITIZED ? 7 : 1) {
                    books b = {0};
                    paradt_options options = {0};
                    paradt_voronoi v;
                    paradt_voronoi_request request = {0};
                    b.fail_at = at;
                    request.outputs = dim > 3 ? 21 : EVERYTHING;
                    request.box = box;
                    options.allocator.alloc = books_alloc;
                    options.allocator.free = books_free;
                    options.allocator.user = &b;
                    if (parallel)
                        options.parallel_for = run_backwards;
                    paradt_status status = paradt_voronoi_compute(&v, &t, &points, &request, &options);
                    if (!status) {
                        assert_true(b.calls < at);
                        paradt_voronoi_free(&v);
                        assert_int_equal(b.live, 0);
                        break;
                    }
                    assert_int_equal(status, PARADT_ERROR_MEMORY);
                    expect_empty(&v);
                    assert_int_equal(b.live, 0);
                }
            paradt_free(&t);
            sample_free(&s);
        }
}

typedef struct cancelling {
    size_t calls, cancel_at;
    double last;
} cancelling;

static int cancel_at(void *user, double fraction) {
    cancelling *c = (cancelling *)user;
    assert_true(fraction >= c->last && fraction <= 1);
    c->last = fraction;
    return ++c->calls == c->cancel_at;
}

static void every_call_of_progress_may_cancel(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++) {
        sample s = family_make(&families[family_named("uniform")], NULL, dim, dim == 4 ? 300 : 5000, 3);
        paradt_points points = points_of(&s);
        paradt_triangulation t;
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        for (size_t at = 1;; at += SANITIZED ? 5 : at > 20 ? 3 : 1) {
            cancelling c = {0};
            paradt_options options = {0};
            paradt_voronoi v;
            paradt_voronoi_request request = {0};
            request.outputs = dim > 3 ? 21 : EVERYTHING;
            c.cancel_at = at;
            options.progress = cancel_at;
            options.user = &c;
            paradt_status status = paradt_voronoi_compute(&v, &t, &points, &request, &options);
            if (!status) {
                assert_true(at > 3 && c.calls < at);
                paradt_voronoi_free(&v);
                break;
            }
            assert_int_equal(status, PARADT_ERROR_CANCELLED);
            expect_empty(&v);
        }
        paradt_free(&t);
        sample_free(&s);
    }
}

static void expect_error(const paradt_triangulation *t, const paradt_points *points, const paradt_voronoi_request *request,
                         const paradt_options *options, paradt_status expected) {
    paradt_voronoi v;
    assert_int_equal(paradt_voronoi_compute(&v, t, points, request, options), expected);
    expect_empty(&v);
}

static void wrong_arguments_are_refused(void **state) {
    (void)state;
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 50, 3);
    paradt_points points = points_of(&s), fewer = points, flat = points;
    paradt_triangulation t, bare, broken;
    paradt_options options = {0};
    double box[] = {0, 0, 0, 1, 1, 1}, planes[] = {0, 0, 0, 1};
    paradt_voronoi_request request = {0};
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    fewer.count--;
    flat.dim = 2;
    bare = broken = t;
    bare.neighbors = NULL;
    assert_int_equal(paradt_voronoi_compute(NULL, &t, &points, NULL, NULL), PARADT_ERROR_ARGUMENT);
    expect_error(NULL, &points, NULL, NULL, PARADT_ERROR_ARGUMENT);
    expect_error(&t, NULL, NULL, NULL, PARADT_ERROR_ARGUMENT);
    expect_error(&t, &fewer, NULL, NULL, PARADT_ERROR_ARGUMENT);
    expect_error(&t, &flat, NULL, NULL, PARADT_ERROR_ARGUMENT);
    expect_error(&bare, &points, NULL, NULL, PARADT_ERROR_ARGUMENT);
    request.outputs = 64;
    expect_error(&t, &points, &request, NULL, PARADT_ERROR_ARGUMENT);
    request.outputs = 0;
    request.plane_count = 1;
    expect_error(&t, &points, &request, NULL, PARADT_ERROR_ARGUMENT);
    request.planes = planes;
    expect_error(&t, &points, &request, NULL, PARADT_ERROR_ARGUMENT); // no normal
    planes[0] = NAN;
    expect_error(&t, &points, &request, NULL, PARADT_ERROR_ARGUMENT);
    request.plane_count = 0;
    request.box = box;
    box[1] = NAN;
    expect_error(&t, &points, &request, NULL, PARADT_ERROR_ARGUMENT);
    box[1] = HUGE_VAL; // a lower bound without an end is one; an upper one is not
    expect_error(&t, &points, &request, NULL, PARADT_ERROR_ARGUMENT);
    options.flags = PARADT_FACETS; // but they are cells
    expect_error(&t, &points, NULL, &options, PARADT_ERROR_INVALID);
    double kept = s.x[30];
    s.x[30] = NAN;
    paradt_voronoi v;
    assert_int_equal(paradt_voronoi_compute(&v, &t, &points, NULL, NULL), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(v.error_point, 10);
    s.x[30] = kept;
    // arrays that do not fit together
    for (size_t i = 0; i < t.cell_count * 4; i++) {
        paradt_index before = t.neighbors[i];
        t.neighbors[i] = (paradt_index)(i % 3 ? 1000000 : t.cell_count / 2);
        if (t.neighbors[i] != before)
            expect_error(&t, &points, NULL, NULL, PARADT_ERROR_INVALID);
        t.neighbors[i] = before;
        before = t.cells[i];
        t.cells[i] = i % 2 ? 50 : -1;
        expect_error(&t, &points, NULL, NULL, PARADT_ERROR_INVALID);
        t.cells[i] = before;
    }
    for (int i = 0; i < s.count; i++) // all cells become flat
        s.x[3 * i + 2] = 0.5;
    expect_error(&t, &points, NULL, NULL, PARADT_ERROR_INVALID);
    paradt_voronoi_free(NULL);
    paradt_free(&t);
    sample_free(&s);
}

static void centroids_are_there_up_to_three_dimensions(void **state) {
    sample s = family_make(&families[family_named("uniform")], NULL, 4, 20, 3);
    paradt_points points = points_of(&s);
    paradt_voronoi_request request = {0};
    paradt_triangulation t;
    (void)state;
    assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
    request.outputs = PARADT_VORONOI_VOLUMES | PARADT_VORONOI_CENTROIDS;
    expect_error(&t, &points, &request, NULL, PARADT_ERROR_ARGUMENT);
    paradt_free(&t);
    sample_free(&s);
}

// Cells that are known: of a lattice in its box, and around two points
static void cells_of_lattices_are_cubes(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++) {
        int side = dim == 4 ? 3 : 6, count = 1;
        for (int j = 0; j < dim; j++)
            count *= side;
        sample s = sample_make("cube", dim, count);
        double box[8];
        for (int i = 0; i < count; i++)
            for (int j = 0, rest = i; j < dim; j++, rest /= side)
                s.x[i * dim + j] = rest % side;
        for (int j = 0; j < dim; j++) {
            box[j] = -0.5;
            box[dim + j] = side - 0.5;
        }
        paradt_voronoi_request request = {0};
        request.box = box;
        request.outputs = dim > 3 ? 21 : EVERYTHING;
        paradt_voronoi v = diagram_of(&s, &request, NULL);
        for (int i = 0; i < count; i++) {
            assert_true(fabs(v.volumes[i] - 1) <= v.volume_errors[i] && v.volume_errors[i] < 1e-10);
            assert_int_equal(v.first_face[i + 1] - v.first_face[i], 2 * dim);
            for (int j = 0; j < dim && v.centroids; j++)
                assert_true(fabs(v.centroids[i * dim + j] - s.x[i * dim + j]) < 1e-12);
        }
        int corners = 1;
        for (int j = 0; j < dim; j++)
            corners *= side + 1;
        assert_int_equal(v.vertex_count, corners);
        for (size_t f = 0; f < v.face_count; f++)
            assert_int_equal(v.first_vertex[f + 1] - v.first_vertex[f], 1 << (dim - 1));
        paradt_voronoi_free(&v);
        sample_free(&s);
    }
}

static void no_point_and_one_point_have_their_cells(void **state) {
    (void)state;
    sample s = sample_make("points", 3, 3);
    double box[] = {-1, -1, -1, 1, 2, 3};
    paradt_voronoi_request request = {0};
    request.outputs = EVERYTHING;
    s.count = 0;
    paradt_voronoi v = diagram_of(&s, &request, NULL);
    assert_int_equal(v.dim, 3);
    assert_int_equal(v.cell_count, 0);
    paradt_voronoi_free(&v);
    s.count = 3; // all at one place
    v = diagram_of(&s, &request, NULL);
    assert_true(isinf(v.volumes[0]) && v.unbounded[0] && v.volumes[1] == 0 && !v.unbounded[2]);
    assert_int_equal(v.face_count, 0);
    paradt_voronoi_free(&v);
    request.box = box;
    v = diagram_of(&s, &request, NULL);
    assert_true(fabs(v.volumes[0] - 24) <= v.volume_errors[0] && v.volume_errors[0] < 1e-10);
    assert_int_equal(v.face_count, 6);
    assert_int_equal(v.vertex_count, 8);
    paradt_voronoi_free(&v);
    box[0] = 2; // above the upper bound
    v = diagram_of(&s, &request, NULL);
    assert_true(v.volumes[0] == 0 && v.face_count == 0);
    paradt_voronoi_free(&v);
    sample_free(&s);
}

// The squares of the difference are 0, or the difference itself is, beside what else there is.
static void faces_between_points_that_almost_coincide_have_areas(void **state) {
    static const double gaps[] = {0x1p-400, 0x1p-600, 0x1p-1000, 0x1p-1074}, far[] = {0, 0x1p917};
    (void)state;
    for (int g = 0; g < 8; g++) {
        const double x[] = {3, 0, 3, gaps[g % 4], 3, -far[g / 4] - 5}, box[] = {-1, -1, 2, 2};
        paradt_points points = paradt_points_f64(x, 3, 2);
        paradt_voronoi_request request = {PARADT_VORONOI_AREAS | PARADT_VORONOI_FACES, box, NULL, 0};
        paradt_triangulation t;
        paradt_voronoi v;
        double between = 0;
        assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
        assert_int_equal(paradt_voronoi_compute(&v, &t, &points, &request, NULL), PARADT_OK);
        for (size_t f = 0; f < v.face_count; f++) {
            assert_true(v.areas[f] > 0 && v.areas[f] <= 3);
            if (v.sides[2 * f] == 0 && v.sides[2 * f + 1] == 1)
                between = v.areas[f];
        }
        assert_true(between == 3);
        paradt_voronoi_free(&v);
        paradt_free(&t);
    }
}

// Points are far from all others: beside their distance the others' are so small that products of a few of them underflow. The
// cells of the others in a box around them have the volumes that they have without the far points.
static void volumes_do_not_suffer_from_points_far_away(void **state) {
    static const double far[] = {1e20, 1e60, 1e70, 1e77, 1e80, 1e120, 1e140};
    enum { NEAR = 40 };
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int weighted = 0; weighted < 2; weighted++)
            for (size_t i = 0; i < sizeof far / sizeof far[0]; i++) {
                static const double boxes[2][6] = {{-2, -2, 3, 3}, {-2, -2, -2, 3, 3, 3}};
                sample s = sample_make("far", dim, NEAR + 3);
                uint64_t seed = i + 1;
                double weights[NEAR + 3];
                paradt_voronoi_request request = {0};
                request.outputs = PARADT_VORONOI_VOLUMES;
                request.box = boxes[dim - 2];
                for (int j = 0; j < (NEAR + 3) * dim; j++)
                    s.x[j] = (j / dim < NEAR ? 1.0 : far[i]) * (random_unit(&seed) - 0.5);
                for (int j = 0; j < NEAR + 3; j++)
                    weights[j] = 0.01 * random_unit(&seed);
                s.w = weighted ? weights : NULL;
                paradt_voronoi with = diagram_of(&s, &request, NULL), without;
                s.count = NEAR;
                without = diagram_of(&s, &request, NULL);
                for (int j = 0; j < NEAR; j++) {
                    double error = with.volume_errors[j] + without.volume_errors[j];
                    assert_true(fabs(with.volumes[j] - without.volumes[j]) <= error);
                    assert_true(error < 1e-9 || far[i] > 1e100); // beyond that what underflow may take is a part of the volume
                }
                paradt_voronoi_free(&with);
                paradt_voronoi_free(&without);
                s.w = NULL;
                sample_free(&s);
            }
}

int main(void) {
    const struct CMUnitTest races[] = {cmocka_unit_test(threads_give_the_same_bits)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_in_the_plane_are_those_of_the_definition),
        cmocka_unit_test(cells_in_space_are_those_of_the_definition),
        cmocka_unit_test(power_diagrams_are_those_of_the_definition),
        cmocka_unit_test(cells_of_higher_dimensions_are_those_of_the_definition),
        cmocka_unit_test(cells_of_lattices_are_cubes),
        cmocka_unit_test(no_point_and_one_point_have_their_cells),
        cmocka_unit_test(many_cells_fill_the_box),
        cmocka_unit_test(cells_may_have_thousands_of_faces),
        cmocka_unit_test(threads_give_the_same_bits),
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(faces_between_points_that_almost_coincide_have_areas),
        cmocka_unit_test(volumes_do_not_suffer_from_points_far_away),
        cmocka_unit_test(every_call_of_progress_may_cancel),
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(centroids_are_there_up_to_three_dimensions),
    };
    return RACES_ONLY ? cmocka_run_group_tests_name("voronoi", races, NULL, NULL)
                      : cmocka_run_group_tests_name("voronoi", tests, NULL, NULL);
}
