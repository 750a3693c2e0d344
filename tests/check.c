// paradt_check certifies triangulations found by brute force, and refuses each kind of fault for the right reason. Whatever the
// arrays contain, it ends, and it accepts nothing but T(P).
#define PARADT_STATIC // functions that are not called are not compiled
#define PARADT_IMPLEMENTATION
#include "paradt.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MAX_POINTS = 16, MAX_CELLS = 1024, MAX_CORNERS = PARADT_MAX_DIM + 1 };

// --- scenes: a few points and T(P), by brute force

typedef struct scene {
    char name[64];
    double x[MAX_POINTS * PARADT_MAX_DIM];
    double w[MAX_POINTS];
    paradt_index cells[MAX_CELLS * MAX_CORNERS], neighbors[MAX_CELLS * MAX_CORNERS], representative[MAX_POINTS];
    paradt_points points;
    paradt_triangulation t;
} scene;

static uint64_t random_state;

static uint64_t random_bits(void) {
    uint64_t z = random_state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

static int random_below(int n) {
    return (int)(random_bits() % (uint64_t)n);
}

static double random_unit(void) {
    return (double)(random_bits() >> 11) * 0x1p-53;
}

// Advances to the next choice of k ascending numbers below n. Returns 0 when there is none.
static int next_choice(int *choice, int k, int n) {
    int i = k - 1;
    while (i >= 0 && choice[i] == n - k + i)
        i--;
    if (i < 0)
        return 0;
    choice[i]++;
    while (++i < k)
        choice[i] = choice[i - 1] + 1;
    return 1;
}

static void first_choice(int *choice, int k) {
    for (int i = 0; i < k; i++)
        choice[i] = i;
}

static const double *point_at(const scene *s, int i) {
    return s->x + i * s->points.dim;
}

// Returns the point that represents a point and its equals: the heaviest, then the first.
static int leader_of(const scene *s, int point) {
    int leader = point;
    for (int i = 0; i < (int)s->points.count; i++) {
        for (int j = 0; j < s->points.dim; j++)
            if (point_at(s, i)[j] != point_at(s, point)[j])
                goto different;
        if (s->points.weights ? s->w[i] > s->w[leader] || (s->w[i] == s->w[leader] && i < leader) : i < leader)
            leader = i;
    different:;
    }
    return leader;
}

typedef struct brute {
    paradt__space space;
    int count, index[MAX_POINTS];                   // the distinct points
    double records[MAX_POINTS][PARADT_MAX_DIM + 1]; // of the distinct points, as the predicates take them
} brute;

static void brute_records(brute *b, const scene *s, const int *axes, int dim) {
    int ambient = s->points.dim;
    paradt__space_begin(&b->space, dim, ambient, s->points.weights != NULL);
    for (int i = 0; i < b->count; i++) {
        int place = 0;
        for (int j = 0; j < dim; j++)
            b->records[i][place++] = point_at(s, b->index[i])[axes[j]];
        for (int axis = 0; axis < ambient; axis++) {
            int taken = 0;
            for (int j = 0; j < dim; j++)
                taken |= axes[j] == axis;
            if (!taken)
                b->records[i][place++] = point_at(s, b->index[i])[axis];
        }
        b->records[i][place] = s->points.weights ? s->w[b->index[i]] : 0;
        for (int j = 0; j <= place; j++)
            if (b->records[i][j] == 0)
                b->records[i][j] = 0.0; // replaces -0.0
        paradt__space_add(&b->space, b->records[i]);
    }
    if (dim > 0)
        paradt__space_end(&b->space);
}

static int brute_orient(brute *b, const int *choice) {
    const double *corners[MAX_CORNERS];
    for (int i = 0; i <= b->space.dim; i++)
        corners[i] = b->records[choice[i]];
    return b->space.dim ? paradt__orient(&b->space, corners) : 1;
}

// Finds the largest k such that the projection of the points on some k axes has affine dimension k, and the first such axes.
// Returns k.
static int brute_axes(brute *b, const scene *s, int *axes) {
    int choice[MAX_CORNERS];
    for (int k = s->points.dim < b->count - 1 ? s->points.dim : b->count - 1; k > 0; k--) {
        first_choice(axes, k);
        do {
            brute_records(b, s, axes, k);
            first_choice(choice, k + 1);
            do
                if (brute_orient(b, choice))
                    return k;
            while (next_choice(choice, k + 1, b->count));
        } while (next_choice(axes, k, s->points.dim));
    }
    brute_records(b, s, axes, 0);
    return 0;
}

static int brute_is_empty(brute *b, const int *choice) {
    const double *corners[MAX_CORNERS + 1];
    int n = b->space.dim + 1;
    for (int i = 0; i < n; i++)
        corners[i] = b->records[choice[i]];
    for (int q = 0; q < b->count; q++) {
        int own = 0;
        for (int i = 0; i < n; i++)
            own |= choice[i] == q;
        corners[n] = b->records[q];
        if (!own && b->space.dim && paradt__conflict(&b->space, corners))
            return 0;
    }
    return 1;
}

static int find_vertex(const paradt_index *cell, int corners, paradt_index v) {
    for (int i = 0; i < corners; i++)
        if (cell[i] == v)
            return i;
    return -1;
}

// Fills the neighbours by comparing every cell with every other.
static void match_naively(const paradt_triangulation *t, paradt_index *neighbors) {
    int corners = t->dim + 1;
    for (size_t a = 0; a < t->cell_count; a++)
        for (int i = 0; i < corners; i++) {
            neighbors[a * (size_t)corners + (size_t)i] = -1;
            for (size_t b = 0; b < t->cell_count; b++) {
                int common = 0;
                for (int j = 0; j < corners; j++)
                    common += j != i && find_vertex(t->cells + b * (size_t)corners, corners,
                                                    t->cells[a * (size_t)corners + (size_t)j]) >= 0;
                if (a != b && common == corners - 1)
                    neighbors[a * (size_t)corners + (size_t)i] = (paradt_index)b;
            }
        }
}

static void triangulate_by_brute_force(scene *s) {
    static brute b;
    int axes[PARADT_MAX_DIM], choice[MAX_CORNERS], used[MAX_POINTS] = {0}, n = (int)s->points.count;
    memset(&s->t, 0, sizeof s->t);
    s->t.cells = s->cells;
    s->t.neighbors = s->neighbors;
    s->t.representative = s->representative;
    s->t.point_count = s->points.count;
    s->t.dim = -1;
    if (n == 0)
        return;
    b.count = 0;
    for (int i = 0; i < n; i++)
        if (leader_of(s, i) == i)
            b.index[b.count++] = i;
    s->t.dim = brute_axes(&b, s, axes);
    int corners = s->t.dim + 1;
    first_choice(choice, corners);
    do {
        int sign = brute_orient(&b, choice), cell[MAX_CORNERS];
        if (!sign)
            continue;
        memcpy(cell, choice, sizeof cell);
        if (sign < 0) {
            cell[0] = choice[1];
            cell[1] = choice[0];
        }
        if (!brute_is_empty(&b, cell))
            continue;
        assert_true(s->t.cell_count < MAX_CELLS);
        for (int i = 0; i < corners; i++) {
            s->cells[s->t.cell_count * (size_t)corners + (size_t)i] = b.index[cell[i]];
            used[b.index[cell[i]]] = 1;
        }
        s->t.cell_count++;
    } while (next_choice(choice, corners, b.count));
    match_naively(&s->t, s->neighbors);
    for (int i = 0; i < n; i++) {
        int leader = leader_of(s, i);
        assert_true(used[leader] || s->points.weights);
        s->representative[i] = used[leader] ? leader : -1;
    }
}

typedef enum kind { UNIFORM, LATTICE, ULPS, SUBNORMAL, FLAT, LINE, THIN, EQUAL, KIND_COUNT } kind;
static const char *const kind_names[] = {"uniform", "lattice", "ulps", "subnormal", "flat", "line", "thin", "equal"};

static double draw(kind which, int axis, int dim, const double *before) {
    double sum = 0;
    switch (which) {
    case UNIFORM:
        return random_unit();
    case LATTICE: // with duplicates, cospherical points, -0.0
        return random_below(8) ? (double)random_below(3) : -0.0;
    case ULPS:
        return 1 + random_below(6) * 0x1p-52;
    case SUBNORMAL:
        return (random_below(9) - 4) * 0x1p-1074;
    case THIN: // in a hyperplane, and within rounding errors of a line in it
        return axis == 0 ? 1 : axis == 1 ? random_below(12) * 0.1 : before[axis - 1] * 3.3 + random_below(2) * 0x1p-54;
    case EQUAL:
        return axis;
    default: // the first coordinate is constant, the last one is the sum of the others; LINE: of one other
        if (axis == 0)
            return 3;
        if (axis == 1 || (which == FLAT && axis < dim - 1))
            return random_below(5);
        for (int i = 1; i < axis; i++)
            sum += before[i];
        return sum;
    }
}

static double draw_weight(kind which) {
    switch (which) {
    case UNIFORM:
        return random_unit() * 3;
    case ULPS:
        return random_below(3) * 0x1p-104;
    case SUBNORMAL: // far more than the squares of the coordinates, which underflow
        return random_below(3) * 0x1p-1074;
    default:
        return random_below(20);
    }
}

static scene *make_scene(kind which, int dim, int count, int weighted, uint64_t seed) {
    scene *s = (scene *)calloc(1, sizeof *s);
    assert_non_null(s);
    assert_true(count <= MAX_POINTS);
    random_state = seed * 1000003 + (uint64_t)((int)which * 64 + dim * 2 + weighted);
    snprintf(s->name, sizeof s->name, "%s d%d n%d%s seed %d", kind_names[which], dim, count,
             weighted ? " weighted" : "", (int)seed);
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < dim; j++)
            s->x[i * dim + j] = draw(which, j, dim, s->x + i * dim);
        s->w[i] = draw_weight(which);
    }
    s->points.data = s->x;
    s->points.count = (size_t)count;
    s->points.dim = dim;
    s->points.weights = weighted ? s->w : NULL;
    triangulate_by_brute_force(s);
    return s;
}

// Returns a copy of the scene, to be damaged.
static scene *copy_scene(const scene *from) {
    scene *s = (scene *)malloc(sizeof *s);
    assert_non_null(s);
    *s = *from;
    s->points.data = s->x;
    s->points.weights = from->points.weights ? s->w : NULL;
    s->t.cells = s->cells;
    s->t.neighbors = from->t.neighbors ? s->neighbors : NULL;
    s->t.representative = s->representative;
    return s;
}

// Returns the scene of this number, NULL after the last: all kinds in all dimensions, with and without weights.
static scene *scene_number(int index) {
    static const int counts[PARADT_MAX_DIM + 1] = {0, 0, 12, 11, 10, 10, 10, 10, 11};
    int weighted = index % 2, kind_index = index / 2 % KIND_COUNT, dim = 2 + index / 2 / KIND_COUNT % 7,
        seed = index / 2 / KIND_COUNT / 7;
    if (seed > 2)
        return NULL;
    return make_scene((kind)kind_index, dim, counts[dim] - seed, weighted, (uint64_t)seed);
}

// --- expectations

static void expect_accepted(const scene *s) {
    paradt_fault fault = {"not written", 7, 7};
    paradt_status status = paradt_check(&s->t, &s->points, NULL, &fault);
    if (status)
        print_error("%s: %s, cell %d, point %d\n", s->name, fault.reason ? fault.reason : paradt_status_string(status),
                    (int)fault.cell, (int)fault.point);
    assert_int_equal(status, PARADT_OK);
    assert_null(fault.reason);
    assert_int_equal(fault.cell, 0);
    assert_int_equal(fault.point, 0);
}

static const char *refusal(const scene *s) {
    paradt_fault fault;
    paradt_status status = paradt_check(&s->t, &s->points, NULL, &fault);
    if (status != PARADT_ERROR_INVALID)
        print_error("%s: status %d\n", s->name, (int)status);
    assert_int_equal(status, PARADT_ERROR_INVALID);
    assert_non_null(fault.reason);
    assert_in_range(fault.cell + 1, 0, s->t.cell_count);
    assert_in_range(fault.point + 1, 0, s->t.point_count);
    return fault.reason;
}

static void expect_refused(const scene *s, const char *reason) {
    const char *given = refusal(s);
    if (strcmp(given, reason) != 0)
        print_error("%s\n", s->name);
    assert_string_equal(given, reason);
}

// --- T(P) is accepted

static void every_brute_force_triangulation_is_accepted(void **state) {
    (void)state;
    int hidden = 0, duplicates = 0, flat = 0;
    for (int index = 0;; index++) {
        scene *s = scene_number(index);
        if (!s)
            break;
        expect_accepted(s);
        s->t.neighbors = NULL;
        expect_accepted(s);
        for (int i = 0; i < (int)s->points.count; i++) {
            hidden += s->representative[i] < 0;
            duplicates += s->representative[i] >= 0 && s->representative[i] != i;
        }
        flat += s->t.dim < s->points.dim;
        free(s);
    }
    assert_true(hidden > 50 && duplicates > 50 && flat > 50);
}

static void few_points_are_accepted(void **state) {
    (void)state;
    for (int count = 0; count < 5; count++)
        for (int weighted = 0; weighted < 2; weighted++)
            for (int k = 0; k < KIND_COUNT; k++) {
                scene *s = make_scene((kind)k, 3, count, weighted, 5);
                expect_accepted(s);
                s->t.neighbors = NULL;
                expect_accepted(s);
                if (count == 0)
                    s->t.cells = s->t.representative = NULL;
                expect_accepted(s);
                free(s);
            }
}

static void floats_and_strides_are_read(void **state) {
    (void)state;
    scene *s = make_scene(LATTICE, 3, 12, 0, 1);
    float packed[MAX_POINTS][5];
    memset(packed, 0x7f, sizeof packed);
    for (int i = 0; i < 12; i++)
        for (int j = 0; j < 3; j++)
            packed[i][j] = (float)point_at(s, i)[j];
    s->points.data = packed;
    s->points.scalar = PARADT_F32;
    s->points.stride = sizeof packed[0];
    expect_accepted(s);
    free(s);
}

typedef struct reports {
    int calls, cancel_at;
    double last;
} reports;

static int note_progress(void *user, double fraction) {
    reports *r = (reports *)user;
    assert_true(fraction >= r->last && fraction <= 1);
    r->last = fraction;
    return ++r->calls == r->cancel_at;
}

// --- anything else is refused: faults of representatives

static void a_wrong_dim_is_refused(void **state) {
    (void)state;
    for (int index = 0; index < 2 * KIND_COUNT * 4; index++) {
        scene *s = scene_number(index);
        int right = s->t.dim;
        for (s->t.dim = -2; s->t.dim < 12; s->t.dim++)
            if (s->t.dim != right)
                expect_refused(s, "dim is not the affine dimension of the points");
        free(s);
    }
}

static void a_wrong_number_of_points_is_refused(void **state) {
    (void)state;
    scene *s = make_scene(UNIFORM, 3, 8, 0, 1);
    s->points.count = 7;
    expect_refused(s, "the triangulation has another number of points");
    free(s);
}

static void cells_without_points_are_refused(void **state) {
    (void)state;
    scene *s = make_scene(UNIFORM, 3, 0, 0, 1);
    s->t.cell_count = 1;
    expect_refused(s, "there are cells without points");
    free(s);
}

static void points_without_cells_are_refused(void **state) {
    (void)state;
    for (int count = 1; count <= 5; count++) { // every point is called hidden
        scene *s = make_scene(UNIFORM, 3, count, 1, 1);
        s->t.cell_count = 0;
        for (int i = 0; i < count; i++)
            s->representative[i] = -1;
        expect_refused(s, "there are points, but no cells");
        free(s);
    }
}

static void a_wrong_representative_is_refused(void **state) {
    (void)state;
    int tried = 0;
    for (int index = 0;; index++) {
        scene *s = scene_number(index);
        if (!s)
            break;
        for (int i = 0; i < (int)s->points.count; i++) {
            paradt_index right = s->representative[i];
            for (paradt_index wrong = i % 3; right >= 0 && wrong < (paradt_index)s->points.count; wrong += 3) {
                if (wrong == right)
                    continue;
                s->representative[i] = wrong;
                expect_refused(s, "the representative is not the first of the heaviest with these coordinates");
                tried++;
            }
            s->representative[i] = (paradt_index)s->points.count;
            expect_refused(s, "a representative is no point");
            s->representative[i] = -2;
            expect_refused(s, "a representative is no point");
            s->representative[i] = right;
        }
        free(s);
    }
    assert_true(tried > 1000);
}

// Of two points at the same place, the lighter one, or the second one of the same weight, is made to represent both.
static void a_light_or_late_representative_is_refused(void **state) {
    (void)state;
    for (int lighter = 0; lighter < 2; lighter++) {
        scene *s = make_scene(UNIFORM, 3, 8, 1, 3);
        for (int i = 0; i < 8; i++)
            s->w[i] = 0;
        memcpy(s->x + 7 * 3, s->x + 2 * 3, 3 * sizeof(double));
        s->w[7] = lighter ? -0.25 : -0.0;
        triangulate_by_brute_force(s);
        expect_accepted(s);
        for (size_t i = 0; i < s->t.cell_count * 4; i++)
            s->cells[i] = s->cells[i] == 2 ? 7 : s->cells[i];
        s->representative[2] = s->representative[7] = 7;
        expect_refused(s, "the representative is not the first of the heaviest with these coordinates");
        free(s);
    }
}

static void a_vertex_called_hidden_is_refused(void **state) {
    (void)state;
    for (int weighted = 0; weighted < 2; weighted++)
        for (int i = 0; i < 9; i++) {
            scene *s = make_scene(UNIFORM, 3, 9, weighted, 2);
            if (s->representative[i] == i) {
                s->representative[i] = -1;
                expect_refused(s, weighted ? "a vertex is called hidden" : "a point is called hidden without weights");
            }
            free(s);
        }
}

// Tries T(P without v) with v called hidden, for each vertex v.
static void a_vertex_left_out_and_called_hidden_is_refused(void **state) {
    (void)state;
    int inner = 0, outer = 0;
    for (int seed = 0; seed < 12; seed++)
        for (int v = 0; v < 12; v++) {
            scene *s = make_scene(UNIFORM, 2 + seed % 2, 12, 1, (uint64_t)seed), *less = copy_scene(s);
            if (s->representative[v] == v) {
                // v moves to the place of another point and becomes lighter, so that the brute force leaves it out.
                memcpy(less->x + v * s->points.dim, s->x + (v + 1) % 12 * s->points.dim,
                       (size_t)s->points.dim * sizeof(double));
                less->w[v] = -1;
                triangulate_by_brute_force(less);
                memcpy(less->x, s->x, sizeof s->x);
                memcpy(less->w, s->w, sizeof s->w);
                less->representative[v] = -1;
                const char *reason = refusal(less);
                if (strcmp(reason, "a hidden point lies outside of all cells") == 0)
                    outer++;
                else {
                    assert_string_equal(reason, "a point that is called hidden should be a vertex");
                    inner++;
                }
            }
            free(less);
            free(s);
        }
    assert_true(inner > 5 && outer > 5);
}

static void a_hidden_point_that_is_not_recorded_is_refused(void **state) {
    (void)state;
    int tried = 0;
    for (int index = 1;; index += 2) {
        scene *s = scene_number(index);
        if (!s)
            break;
        for (int i = 0; i < (int)s->points.count; i++)
            if (s->representative[i] < 0 && leader_of(s, i) == i) {
                int equals = 0;
                for (int j = 0; j < (int)s->points.count; j++)
                    equals += leader_of(s, j) == i;
                s->representative[i] = i;
                expect_refused(s, equals > 1 ? "of points with equal coordinates some are called hidden, some not"
                                             : "a point that is not hidden is a vertex of no cell");
                s->representative[i] = -1;
                tried++;
            }
        free(s);
    }
    assert_true(tried > 20);
}

// --- faults of cells

static void swapped_vertices_are_refused(void **state) {
    (void)state;
    for (int index = 0;; index++) {
        scene *s = scene_number(index);
        if (!s)
            break;
        size_t corners = (size_t)(s->t.dim + 1);
        for (size_t c = 0; c < s->t.cell_count && corners > 1; c++) {
            paradt_index *cell = s->cells + c * corners, swap = cell[0];
            cell[0] = cell[1];
            cell[1] = swap;
            expect_refused(s, "a cell is negatively oriented");
            cell[1] = cell[0];
            expect_refused(s, "a cell has a vertex twice");
            cell[1] = (paradt_index)s->points.count;
            expect_refused(s, "a vertex is no point");
            cell[1] = -1;
            expect_refused(s, "a vertex is no point");
            cell[1] = cell[0];
            cell[0] = swap;
        }
        free(s);
    }
}

static void a_flat_cell_is_refused(void **state) {
    (void)state;
    scene *s = make_scene(UNIFORM, 3, 8, 0, 1);
    for (int i = 0; i < 8; i++)
        for (int j = 0; j < 3; j++)
            s->x[i * 3 + j] = i >> j & 1;
    triangulate_by_brute_force(s);
    expect_accepted(s);
    for (int i = 0; i < 4; i++)
        s->cells[i] = i;
    expect_refused(s, "a cell is flat");
    free(s);
}

static void a_duplicate_as_vertex_is_refused(void **state) {
    (void)state;
    scene *s = make_scene(UNIFORM, 3, 8, 0, 3);
    memcpy(s->x + 7 * 3, s->x + 2 * 3, 3 * sizeof(double));
    triangulate_by_brute_force(s);
    expect_accepted(s);
    for (size_t i = 0; i < s->t.cell_count * 4; i++)
        s->cells[i] = s->cells[i] == 2 ? 7 : s->cells[i];
    expect_refused(s, "a vertex is represented by another point");
    free(s);
}

// Returns a copy without cell c, whose place the last cell takes. The neighbours are correct for the cells that remain.
static scene *without_cell(const scene *from, size_t c) {
    scene *s = copy_scene(from);
    size_t corners = (size_t)(s->t.dim + 1);
    s->t.cell_count--;
    memmove(s->cells + c * corners, s->cells + s->t.cell_count * corners, corners * sizeof(paradt_index));
    match_naively(&s->t, s->neighbors);
    return s;
}

static void a_missing_cell_is_refused(void **state) {
    (void)state;
    int dents = 0, holes = 0, lost = 0;
    for (int index = 0;; index++) {
        scene *s = scene_number(index);
        if (!s)
            break;
        for (size_t c = 0; c < s->t.cell_count; c += 1 + s->t.cell_count / 20) {
            scene *less = without_cell(s, c);
            const char *reason = refusal(less);
            if (strcmp(reason, "the hull is not convex") == 0)
                dents++;
            else if (strcmp(reason, "a hull facet has cells beyond it") == 0)
                holes++;
            else {
                assert_string_equal(reason, "a point that is not hidden is a vertex of no cell");
                lost++;
            }
            less->t.neighbors = NULL;
            expect_refused(less, reason);
            free(less);
        }
        free(s);
    }
    assert_true(dents > 50 && holes > 50 && lost > 50);
}

// Removes an inner cell: no vertex is lost, and the outer hull does not change.
static void a_hole_is_refused(void **state) {
    (void)state;
    int tried = 0;
    for (int index = 0; index < 2 * KIND_COUNT * 2; index++) {
        scene *s = scene_number(index);
        for (size_t c = 0; c < s->t.cell_count; c++) {
            int corners = s->t.dim + 1, inner = 1;
            for (int i = 0; i < corners; i++)
                inner &= s->neighbors[c * (size_t)corners + (size_t)i] >= 0;
            if (!inner)
                continue;
            scene *less = without_cell(s, c);
            const char *reason = refusal(less);
            if (strcmp(reason, "the hull is not convex") != 0)
                assert_string_equal(reason, "a hull facet has cells beyond it");
            tried++;
            free(less);
        }
        free(s);
    }
    assert_true(tried > 10);
}

static void a_doubled_cell_is_refused(void **state) {
    (void)state;
    for (int index = 0; index < 2 * KIND_COUNT * 4; index++) {
        scene *s = scene_number(index);
        size_t corners = (size_t)(s->t.dim + 1), end = s->t.cell_count * corners;
        int single = s->t.cell_count == 1;
        memcpy(s->cells + end, s->cells, corners * sizeof(paradt_index));
        memcpy(s->neighbors + end, s->neighbors, corners * sizeof(paradt_index));
        s->t.cell_count++;
        if (single)
            expect_refused(s, "the cells cover a place twice");
        else
            expect_refused(s, "a neighbour's neighbour is another cell");
        for (size_t i = 0; i < corners; i++)
            s->neighbors[end + i] = -1;
        refusal(s);
        s->t.neighbors = NULL;
        refusal(s);
        free(s);
    }
}

static void a_facet_of_three_cells_is_refused(void **state) {
    (void)state;
    scene *s = make_scene(UNIFORM, 2, 6, 0, 4);
    memcpy(s->cells + s->t.cell_count * 3, s->cells, 3 * sizeof(paradt_index));
    s->t.cell_count++;
    s->t.neighbors = NULL;
    expect_refused(s, "a facet belongs to three cells");
    free(s);
}

// --- faults of neighbours

static void a_wrong_neighbour_is_refused(void **state) {
    (void)state;
    for (int index = 0; index < 2 * KIND_COUNT * 5; index++) {
        scene *s = scene_number(index);
        size_t facets = s->t.cell_count * (size_t)(s->t.dim + 1);
        for (size_t f = 0; f < facets; f++) {
            paradt_index right = s->neighbors[f];
            s->neighbors[f] = (paradt_index)s->t.cell_count;
            expect_refused(s, "a neighbour is no cell");
            s->neighbors[f] = -2;
            expect_refused(s, "a neighbour is no cell");
            for (int round = 0; round < 5; round++) {
                paradt_index wrong = round ? random_below((int)s->t.cell_count) : -1;
                if (wrong == right)
                    continue;
                s->neighbors[f] = wrong;
                const char *reason = refusal(s);
                if (strcmp(reason, "a cell does not share the facet with the neighbour across it") != 0)
                    assert_string_equal(reason, "a neighbour's neighbour is another cell");
            }
            s->neighbors[f] = right;
        }
        free(s);
    }
}

// Two neighbours are separated: each says that their facet is on the hull.
static void a_slit_is_refused(void **state) {
    (void)state;
    int tried = 0;
    for (int index = 0; index < 2 * KIND_COUNT * 4; index++) {
        scene *s = scene_number(index);
        size_t corners = (size_t)(s->t.dim + 1);
        for (size_t f = 0; f < s->t.cell_count * corners; f++) {
            paradt_index right = s->neighbors[f];
            for (size_t i = 0; right >= 0 && i < corners; i++)
                if (s->neighbors[(size_t)right * corners + i] == (paradt_index)(f / corners)) {
                    s->neighbors[f] = s->neighbors[(size_t)right * corners + i] = -1;
                    expect_refused(s, "a hull facet has cells beyond it");
                    s->neighbors[(size_t)right * corners + i] = (paradt_index)(f / corners);
                    s->neighbors[f] = right;
                    tried++;
                }
        }
        free(s);
    }
    assert_true(tried > 100);
}

// Two triangles lie on the same side of an edge that they claim to share.
static void a_fold_is_refused(void **state) {
    (void)state;
    static const double x[] = {0, 0, 4, 0, 2, 3, 2, 1};
    static const paradt_index cells[] = {0, 1, 2, 0, 1, 3}, neighbors[] = {-1, -1, 1, -1, -1, 0};
    scene *s = make_scene(UNIFORM, 2, 4, 0, 1);
    memcpy(s->x, x, sizeof x);
    memcpy(s->cells, cells, sizeof cells);
    memcpy(s->neighbors, neighbors, sizeof neighbors);
    s->t.cell_count = 2;
    expect_refused(s, "neighbours lie on the same side of their facet");
    s->t.neighbors = NULL;
    expect_refused(s, "neighbours lie on the same side of their facet");
    free(s);
}

// --- faults of geometry

static int orientation(const scene *s, const paradt_index *cell) {
    const double *corners[MAX_CORNERS];
    for (int i = 0; i <= s->t.dim; i++)
        corners[i] = point_at(s, cell[i]);
    return paradt_orient(s->t.dim, corners);
}

// Returns a copy in which the two cells of facet f are replaced by the d cells around the segment between their apexes; NULL if
// the two cells together are not convex.
static scene *flip(const scene *from, size_t f) {
    size_t corners = (size_t)(from->t.dim + 1), c = f / corners, apex = f % corners, other;
    paradt_index neighbor = from->neighbors[f], b = -1, cell[MAX_CORNERS];
    if (neighbor <= (paradt_index)c)
        return NULL;
    other = (size_t)neighbor;
    for (size_t i = 0; i < corners; i++)
        if (find_vertex(from->cells + c * corners, (int)corners, from->cells[other * corners + i]) < 0)
            b = from->cells[other * corners + i];
    scene *s = without_cell(from, other);
    s->t.cell_count--; // c < other: the last remaining cell takes the place of c
    memmove(s->cells + c * corners, s->cells + s->t.cell_count * corners, corners * sizeof(paradt_index));
    for (size_t v = 0; v < corners; v++) {
        if (v == apex)
            continue;
        memcpy(cell, from->cells + c * corners, corners * sizeof(paradt_index));
        cell[v] = b;
        if (orientation(from, cell) <= 0) {
            free(s);
            return NULL;
        }
        memcpy(s->cells + s->t.cell_count++ * corners, cell, corners * sizeof(paradt_index));
    }
    match_naively(&s->t, s->neighbors);
    return s;
}

static void a_flip_is_refused(void **state) {
    (void)state;
    int tried[PARADT_MAX_DIM + 1] = {0};
    for (int index = 0;; index++) {
        scene *s = scene_number(index);
        if (!s)
            break;
        for (size_t f = 0; s->t.dim == s->points.dim && f < s->t.cell_count * (size_t)(s->t.dim + 1); f++) {
            scene *flipped = flip(s, f);
            if (!flipped)
                continue;
            // This holds for ties too, which the perturbation decides.
            expect_refused(flipped, "a facet is not locally Delaunay");
            flipped->t.neighbors = NULL;
            expect_refused(flipped, "a facet is not locally Delaunay");
            tried[s->t.dim]++;
            free(flipped);
        }
        free(s);
    }
    for (int d = 2; d <= 6; d++)
        assert_true(tried[d] > 0);
}

static scene *doubled(const scene *from) {
    scene *s = copy_scene(from);
    size_t end = s->t.cell_count * (size_t)(s->t.dim + 1);
    for (size_t i = 0; i < end; i++) {
        s->cells[end + i] = s->cells[i];
        s->neighbors[end + i] = s->neighbors[i] < 0 ? -1 : s->neighbors[i] + (paradt_index)s->t.cell_count;
    }
    s->t.cell_count *= 2;
    return s;
}

static void a_second_sheet_is_refused(void **state) {
    (void)state;
    for (int index = 0; index < 2 * KIND_COUNT * 5; index++) {
        scene *s = scene_number(index), *two = doubled(s);
        expect_refused(two, "the cells cover a place twice");
        free(two);
        free(s);
    }
}

// Two copies of the triangulation are joined crosswise at one facet: all cells and facets are correct, and all are connected.
static void a_branched_sheet_is_refused(void **state) {
    (void)state;
    int tried = 0;
    for (int index = 0; index < 2 * KIND_COUNT * 4; index++) {
        scene *s = scene_number(index);
        size_t corners = (size_t)(s->t.dim + 1), n = s->t.cell_count, end = n * corners;
        for (size_t f = 0; f < end; f++) {
            paradt_index across = s->neighbors[f];
            if (across < 0)
                continue;
            scene *two = doubled(s);
            for (size_t i = (size_t)across * corners; i < (size_t)(across + 1) * corners; i++)
                if (s->neighbors[i] == (paradt_index)(f / corners)) {
                    two->neighbors[i] += (paradt_index)n;
                    two->neighbors[i + end] -= (paradt_index)n;
                }
            two->neighbors[f] += (paradt_index)n;
            two->neighbors[f + end] -= (paradt_index)n;
            expect_refused(two, "the cells cover a place twice");
            tried++;
            free(two);
        }
        free(s);
    }
    assert_true(tried > 100);
}

// A fan winds twice around its middle, each time over other points, so that no cell occurs twice.
static void a_fan_that_winds_twice_is_refused(void **state) {
    (void)state;
    static const double ring[10][2] = {{100, 0}, {31, 95}, {-81, 59}, {-81, -59}, {31, -95},
                                       {101, 1}, {30, 96}, {-82, 58}, {-80, -60}, {32, -94}};
    scene *s = make_scene(UNIFORM, 2, 11, 0, 1);
    memset(s->x, 0, sizeof s->x);
    memcpy(s->x + 2, ring, sizeof ring);
    for (int i = 0; i < 10; i++) {
        s->cells[i * 3] = 0;
        s->cells[i * 3 + 1] = 1 + i;
        s->cells[i * 3 + 2] = 1 + (i + 1) % 10;
        s->neighbors[i * 3] = -1;
        s->neighbors[i * 3 + 1] = (i + 1) % 10;
        s->neighbors[i * 3 + 2] = (i + 9) % 10;
    }
    s->t.cell_count = 10;
    const char *reason = refusal(s);
    if (strcmp(reason, "a hull facet has cells beyond it") != 0 && strcmp(reason, "the hull is not convex") != 0)
        assert_string_equal(reason, "the cells cover a place twice");
    free(s);
}

static void cells_of_other_points_are_refused(void **state) {
    (void)state;
    for (int dim = 2; dim <= 5; dim++)
        for (int seed = 0; seed < 20; seed++) {
            scene *a = make_scene(UNIFORM, dim, 10, 0, (uint64_t)seed),
                  *b = make_scene(UNIFORM, dim, 10, 0, (uint64_t)seed + 100);
            memcpy(a->x, b->x, sizeof a->x);
            refusal(a);
            free(b);
            free(a);
        }
}

// The cells of the points without weights are offered for the weighted points.
static void cells_of_other_weights_are_refused(void **state) {
    (void)state;
    int refused = 0;
    for (int seed = 0; seed < 20; seed++) {
        scene *s = make_scene(UNIFORM, 3, 10, 0, (uint64_t)seed);
        s->points.weights = s->w;
        paradt_status status = paradt_check(&s->t, &s->points, NULL, NULL);
        scene *weighted = copy_scene(s);
        triangulate_by_brute_force(weighted);
        int same = weighted->t.cell_count == s->t.cell_count &&
                   memcmp(weighted->cells, s->cells, s->t.cell_count * 4 * sizeof(paradt_index)) == 0;
        assert_int_equal(status, same ? PARADT_OK : PARADT_ERROR_INVALID);
        refused += status != PARADT_OK;
        free(weighted);
        free(s);
    }
    assert_true(refused > 10);
}

// --- noise

static int compare_cells(const void *a, const void *b) {
    return memcmp(a, b, MAX_CORNERS * sizeof(paradt_index));
}

static size_t sorted_cells(const scene *s, paradt_index (*sorted)[MAX_CORNERS]) {
    memset(sorted, 0, MAX_CELLS * sizeof *sorted);
    for (size_t c = 0; c < s->t.cell_count; c++)
        for (int i = 0; i <= s->t.dim; i++) {
            paradt_index v = s->cells[c * (size_t)(s->t.dim + 1) + (size_t)i];
            int j = i;
            for (; j > 0 && sorted[c][j - 1] > v; j--)
                sorted[c][j] = sorted[c][j - 1];
            sorted[c][j] = v;
        }
    qsort(sorted, s->t.cell_count, sizeof *sorted, compare_cells);
    return s->t.cell_count;
}

static void spoil(paradt_index *array, size_t count, size_t cell_count) {
    if (!count)
        return;
    size_t i = (size_t)random_below((int)count), j = (size_t)random_below((int)count);
    paradt_index swap = array[i];
    switch (random_below(6)) {
    case 0:
        ((unsigned char *)(array + i))[random_below((int)sizeof *array)] = (unsigned char)random_bits();
        break;
    case 1:
        array[i] = random_below((int)cell_count + MAX_POINTS) - 1;
        break;
    case 2:
        array[i] = array[j];
        array[j] = swap;
        break;
    case 3:
        array[i] = (paradt_index)random_bits();
        break;
    case 4:
        array[i] = array[j];
        break;
    default:
        for (i = 0; i < count; i++)
            array[i] = random_below((int)cell_count + 2) - 1;
    }
}

static void noise_is_refused(void **state) {
    (void)state;
    static paradt_index before[MAX_CELLS][MAX_CORNERS], after[MAX_CELLS][MAX_CORNERS],
        neighbors[MAX_CELLS * MAX_CORNERS];
    int accepted = 0;
    for (int index = 0; index < 2 * KIND_COUNT * 6; index++) {
        scene *s = scene_number(index);
        size_t count = sorted_cells(s, before), facets = count * (size_t)(s->t.dim + 1);
        for (int round = 0; round < 200; round++) {
            scene *noisy = copy_scene(s);
            random_state = (uint64_t)(index * 1000 + round);
            for (int changes = 1 + random_below(3); changes > 0; changes--) {
                int which = random_below(3);
                paradt_index *array = which == 0 ? noisy->cells : which == 1 ? noisy->neighbors : noisy->representative;
                spoil(array, which == 2 ? s->points.count : facets, count);
            }
            if (random_below(4) == 0)
                noisy->t.neighbors = NULL;
            if (random_below(16) == 0 && count)
                noisy->t.cell_count = (size_t)random_below((int)count + 1);
            if (paradt_check(&noisy->t, &noisy->points, NULL, NULL) == PARADT_OK) {
                assert_int_equal(sorted_cells(noisy, after), count);
                assert_memory_equal(before, after, count * sizeof *before);
                assert_memory_equal(noisy->representative, s->representative, s->points.count * sizeof(paradt_index));
                match_naively(&noisy->t, neighbors);
                if (noisy->t.neighbors && facets)
                    assert_memory_equal(noisy->neighbors, neighbors, facets * sizeof(paradt_index));
                accepted++;
            }
            free(noisy);
        }
        free(s);
    }
    assert_true(accepted > 0); // some changes write the same value again
}

// --- manners

static void bad_arguments_are_refused(void **state) {
    (void)state;
    scene *s = make_scene(UNIFORM, 3, 8, 0, 1);
    paradt_points points = s->points;
    paradt_triangulation t = s->t;
    paradt_fault fault;
    assert_int_equal(paradt_check(NULL, &points, NULL, &fault), PARADT_ERROR_ARGUMENT);
    assert_string_equal(fault.reason, "triangulation is NULL");
    assert_int_equal(paradt_check(&t, NULL, NULL, NULL), PARADT_ERROR_ARGUMENT);
    points.dim = 1;
    assert_int_equal(paradt_check(&t, &points, NULL, NULL), PARADT_ERROR_ARGUMENT);
    points.dim = PARADT_MAX_DIM + 1;
    assert_int_equal(paradt_check(&t, &points, NULL, NULL), PARADT_ERROR_ARGUMENT);
    points = s->points;
    points.data = NULL;
    assert_int_equal(paradt_check(&t, &points, NULL, NULL), PARADT_ERROR_ARGUMENT);
    t.cells = NULL;
    assert_int_equal(paradt_check(&t, &s->points, NULL, NULL), PARADT_ERROR_ARGUMENT);
    t = s->t;
    t.representative = NULL;
    assert_int_equal(paradt_check(&t, &s->points, NULL, NULL), PARADT_ERROR_ARGUMENT);
    t = s->t;
    t.cell_count = SIZE_MAX / 8;
    assert_int_equal(paradt_check(&t, &s->points, NULL, &fault), PARADT_ERROR_INVALID);
    assert_string_equal(fault.reason, "there are more cells than an index can number");
    free(s);
}

static void a_nan_is_named(void **state) {
    (void)state;
    for (int weight = 0; weight < 2; weight++) {
        scene *s = make_scene(UNIFORM, 3, 8, 1, 1);
        paradt_fault fault;
        if (weight)
            s->w[5] = HUGE_VAL;
        else
            s->x[5 * 3 + 1] = NAN;
        assert_int_equal(paradt_check(&s->t, &s->points, NULL, &fault), PARADT_ERROR_NOT_FINITE);
        assert_non_null(fault.reason);
        assert_int_equal(fault.point, 5);
        free(s);
    }
}

typedef struct counting {
    int blocks, calls, fail_at;
} counting;

static void *counting_alloc(void *user, size_t size) {
    counting *c = (counting *)user;
    if (++c->calls == c->fail_at)
        return NULL;
    c->blocks++;
    return malloc(size);
}

static void counting_free(void *user, void *memory) {
    ((counting *)user)->blocks--;
    free(memory);
}

static void every_failing_allocation_is_survived(void **state) {
    (void)state;
    for (int with = 0; with < 2; with++) {
        scene *s = make_scene(UNIFORM, 3, 11, 1, 1);
        paradt_options options;
        paradt_status status = PARADT_ERROR_MEMORY;
        int failures = 0;
        memset(&options, 0, sizeof options);
        if (!with)
            s->t.neighbors = NULL;
        for (int fail_at = 1; status == PARADT_ERROR_MEMORY; fail_at++) {
            counting c = {0, 0, 0};
            c.fail_at = fail_at;
            options.allocator.alloc = counting_alloc;
            options.allocator.free = counting_free;
            options.allocator.user = &c;
            status = paradt_check(&s->t, &s->points, &options, NULL);
            assert_int_equal(c.blocks, 0);
            failures += status != PARADT_OK;
        }
        assert_int_equal(status, PARADT_OK);
        assert_true(failures >= (with ? 4 : 6));
        free(s);
    }
}

static void the_memory_limit_is_kept(void **state) {
    (void)state;
    scene *s = make_scene(UNIFORM, 3, 11, 0, 1);
    paradt_options options;
    memset(&options, 0, sizeof options);
    options.memory_limit = 256;
    assert_int_equal(paradt_check(&s->t, &s->points, &options, NULL), PARADT_ERROR_MEMORY);
    options.memory_limit = 1 << 20;
    assert_int_equal(paradt_check(&s->t, &s->points, &options, NULL), PARADT_OK);
    free(s);
}

static void every_report_can_cancel(void **state) {
    (void)state;
    scene *s = make_scene(LATTICE, 3, 12, 1, 1);
    paradt_options options;
    reports r = {0, 0, 0};
    memset(&options, 0, sizeof options);
    options.progress = note_progress;
    options.user = &r;
    assert_int_equal(paradt_check(&s->t, &s->points, &options, NULL), PARADT_OK);
    int calls = r.calls;
    assert_true(calls >= 3);
    for (int at = 1; at <= calls; at++) {
        reports again = {0, 0, 0};
        again.cancel_at = at;
        options.user = &again;
        assert_int_equal(paradt_check(&s->t, &s->points, &options, NULL), PARADT_ERROR_CANCELLED);
        assert_int_equal(again.calls, at);
    }
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_brute_force_triangulation_is_accepted),
        cmocka_unit_test(few_points_are_accepted),
        cmocka_unit_test(floats_and_strides_are_read),
        cmocka_unit_test(a_wrong_dim_is_refused),
        cmocka_unit_test(a_wrong_number_of_points_is_refused),
        cmocka_unit_test(cells_without_points_are_refused),
        cmocka_unit_test(points_without_cells_are_refused),
        cmocka_unit_test(a_wrong_representative_is_refused),
        cmocka_unit_test(a_light_or_late_representative_is_refused),
        cmocka_unit_test(a_vertex_called_hidden_is_refused),
        cmocka_unit_test(a_vertex_left_out_and_called_hidden_is_refused),
        cmocka_unit_test(a_hidden_point_that_is_not_recorded_is_refused),
        cmocka_unit_test(swapped_vertices_are_refused),
        cmocka_unit_test(a_flat_cell_is_refused),
        cmocka_unit_test(a_duplicate_as_vertex_is_refused),
        cmocka_unit_test(a_missing_cell_is_refused),
        cmocka_unit_test(a_hole_is_refused),
        cmocka_unit_test(a_doubled_cell_is_refused),
        cmocka_unit_test(a_facet_of_three_cells_is_refused),
        cmocka_unit_test(a_wrong_neighbour_is_refused),
        cmocka_unit_test(a_slit_is_refused),
        cmocka_unit_test(a_fold_is_refused),
        cmocka_unit_test(a_flip_is_refused),
        cmocka_unit_test(a_second_sheet_is_refused),
        cmocka_unit_test(a_branched_sheet_is_refused),
        cmocka_unit_test(a_fan_that_winds_twice_is_refused),
        cmocka_unit_test(cells_of_other_points_are_refused),
        cmocka_unit_test(cells_of_other_weights_are_refused),
        cmocka_unit_test(noise_is_refused),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(a_nan_is_named),
        cmocka_unit_test(every_failing_allocation_is_survived),
        cmocka_unit_test(the_memory_limit_is_kept),
        cmocka_unit_test(every_report_can_cancel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
