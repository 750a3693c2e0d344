// Any bytes are decoded to a stream of operations on a living set in 2 to 5 dimensions: points come, go and move, one at a time
// and many, and some allocations fail. After each operation
//     - the cells and representatives have to be those of paradt_triangulate for the points that are there: a replay compares
//       them each time, a fuzzer now and then and at the end
//     - the cells that the update lists say were killed and made have to be the difference to the cells before
//     - after an error, and after what such a set refuses, it has to be what it was before
//     - neighbours have to be each other's, and places have to be found where exact orientations say
//     - the nearest vertex has to be the nearest by wide integers
// At the end no memory may be held.
//
// The first three bytes are a header:
//     0  bits 0-1: dimension - 2; bits 2-3: encoding; bit 4: the points have weights; bits 5-7: number of points at first
//     1  parameter of the encoding
//     2  bits 0-1: points are flat, until an operation says otherwise: 1: the last axis is 0; 2: it is the first one;
//        bit 2: also the last but one is constant; bits 3-4: how points are located: 1: by the Delaunay tree, 2: by flips,
//        else by a walk. Only with a walk points may go and move.
// After the first points come operations: a byte, of which bits 0-2 say what is done, bit 3 that the next allocation but as
// many as the next byte says fails, bit 4 that points leave the flat, and bits 5-7 how many points a batch has.
#include "fuzz.h"
#include "wide.h"

enum { MOST_IDS = 64 };

typedef struct living {
    paradt_dynamic *set;
    account blocks;
    source bytes;
    int dim, encoding, parameter, weighted, flat;
    paradt_method method;
    double x[MOST_IDS][MAX_DIM], w[MOST_IDS]; // by id
    int there[MOST_IDS];
    // after the last operation:
    paradt_index stands[MOST_IDS]; // the vertex that stands for an id; -1: hidden, -2: free
    size_t cells;                  // their number,
    uint64_t hash;                 // ... and their hash
    int alone;                     // 1: no two points are at one place
} living;

// --- what has to be there

// Triangulates the points that are there. id[i]: the id of its point i
static void triangulate_those_there(const living *l, paradt_triangulation *t, int *id) {
    static double x[MOST_IDS * MAX_DIM], w[MOST_IDS];
    paradt_points points = paradt_points_f64(x, 0, l->dim);
    int i;
    for (i = 0; i < MOST_IDS; i++)
        if (l->there[i]) {
            memcpy(x + points.count * (size_t)l->dim, l->x[i], (size_t)l->dim * sizeof *x);
            w[points.count] = l->w[i];
            id[points.count++] = i;
        }
    if (l->weighted)
        points.weights = w;
    expect_ok(paradt_triangulate(t, &points, NULL), "triangulation of those there");
}

static uint64_t hash_of(const paradt_index *vertices, int count) {
    uint64_t wide_indices[MAX_DIM + 1];
    int i;
    for (i = 0; i < count; i++)
        wide_indices[i] = (uint64_t)vertices[i];
    return paradt_hash_cell(wide_indices, count);
}

// Returns the hash of a triangulation's cells when their vertices are translated.
static uint64_t hash_of_ids(const paradt_triangulation *t, const int *id) {
    uint64_t sum = 0;
    paradt_index v[MAX_DIM + 1];
    size_t c;
    int i;
    for (c = 0; c < t->cell_count; c++) {
        for (i = 0; i <= t->dim; i++)
            v[i] = id[t->cells[c * (size_t)(t->dim + 1) + (size_t)i]];
        sum += hash_of(v, t->dim + 1);
    }
    return sum;
}

static int no_two_share_a_place(const living *l) {
    int i, j;
    for (i = 0; i < MOST_IDS; i++)
        for (j = 0; j < i && l->there[i]; j++)
            if (l->there[j] && is_same_place(l->x[i], l->x[j], (size_t)l->dim))
                return 0;
    return 1;
}

// Exports the set, and notes its cells and which ids stand for which.
static void look(living *l) {
    paradt_triangulation u;
    paradt_dynamic_info info;
    size_t i;
    l->blocks.fail_at = -1;
    paradt_dynamic_get_info(l->set, &info);
    expect_ok(paradt_dynamic_export(l->set, &u), "export");
    if (u.dim != info.dim)
        fail("living set", "it is exported in another dimension");
    l->hash = paradt_hash(&u);
    l->cells = u.cell_count;
    l->alone = no_two_share_a_place(l);
    for (i = 0; i < MOST_IDS; i++) {
        l->stands[i] = i < u.point_count ? u.representative[i] : -2;
        if (paradt_dynamic_representative(l->set, (paradt_index)i) != l->stands[i])
            fail("living set", "a representative is another one when exported");
        if ((l->stands[i] == -2) != !l->there[i])
            fail("living set", "an id is free that should not be, or the other way round");
    }
    for (; i < u.point_count; i++)
        if (u.representative[i] != -2)
            fail("living set", "an id is not free that should be");
    paradt_free(&u);
}

// What the last look saw has to be what a new triangulation says.
static void expect_same_result(const living *l) {
    paradt_triangulation t;
    paradt_dynamic_info info;
    int id[MOST_IDS];
    size_t i;
    triangulate_those_there(l, &t, id);
    paradt_dynamic_get_info(l->set, &info);
    if (info.dim != t.dim || l->cells != t.cell_count || l->hash != hash_of_ids(&t, id))
        fail("living set", "the cells are not those of a new triangulation");
    for (i = 0; i < t.point_count; i++)
        if (l->stands[id[i]] != (t.representative[i] < 0 ? -1 : id[t.representative[i]]))
            fail("living set", "a representative is not that of a new triangulation");
    paradt_free(&t);
}

static void expect_as_before(const living *l, const living *before) {
    if (l->hash != before->hash || l->cells != before->cells || memcmp(l->stands, before->stands, sizeof l->stands))
        fail("living set", "it is not what it was before an error");
}

// Each facet has to be the mirror of its mirror, and stars have to count the cells of their vertex.
static void expect_sound_cells(const living *l) {
    paradt_dynamic_info info;
    paradt_index v[MAX_DIM + 1], n[MAX_DIM + 1], w[MAX_DIM + 1], m[MAX_DIM + 1], c;
    size_t in_star[MOST_IDS] = {0}, cells = 0;
    uint64_t hash = 0;
    int j, i;
    paradt_dynamic_get_info(l->set, &info);
    for (c = 0; (size_t)c < info.cell_end; c++) {
        if (!paradt_dynamic_cell(l->set, c, v, n))
            continue;
        cells++;
        hash += hash_of(v, info.dim + 1);
        for (j = 0; j <= info.dim; j++) {
            in_star[v[j]]++;
            if (info.dim == 0 || n[j] < 0)
                continue;
            if (!paradt_dynamic_cell(l->set, n[j] / (info.dim + 1), w, m) ||
                m[n[j] % (info.dim + 1)] != c * (info.dim + 1) + j)
                fail("living set", "a facet is not its mirror's mirror");
        }
    }
    if (cells != info.cell_count || hash != l->hash)
        fail("living set", "cells read one by one are not those exported");
    for (i = 0; i < MOST_IDS; i++)
        if (paradt_dynamic_star(l->set, i, NULL, 0) != in_star[i])
            fail("living set", "a star has another number of cells");
}

// The last change has to be the one that the update lists. Where points share a place, before, after or within a batch of
// moves, a vertex may get another id without its cells being listed; then only numbers are compared.
//   before  what was there before the change
//   alone   0: points may have shared a place in between
static void expect_update(const living *l, const living *before, int alone) {
    paradt_dynamic_update update;
    paradt_dynamic_info info;
    paradt_index v[MAX_DIM + 1];
    uint64_t hash = before->hash;
    size_t i, j;
    paradt_dynamic_get_update(l->set, &update);
    paradt_dynamic_get_info(l->set, &info);
    if (update.rebuilt)
        return;
    for (i = 0; i < update.killed_count; i++) {
        size_t corners = (size_t)update.dim_before + 1;
        const paradt_index *killed = update.killed_vertices + i * corners;
        for (j = 0; j < corners; j++)
            if (killed[j] < 0 || killed[j] >= MOST_IDS || before->stands[killed[j]] != killed[j])
                fail("update", "a killed cell has a vertex that was none before");
        hash -= hash_of(killed, update.dim_before + 1);
    }
    for (i = 0; i < update.made_count; i++) {
        if (!paradt_dynamic_cell(l->set, update.made[i], v, NULL))
            fail("update", "a cell that was made is not there");
        hash += hash_of(v, info.dim + 1);
    }
    if (before->cells - update.killed_count + update.made_count != l->cells)
        fail("update", "the numbers of cells killed and made are not the difference");
    if (alone && before->alone && l->alone && hash != l->hash)
        fail("update", "the cells killed and made are not the difference");
}

// --- queries

// Sets *distance to |x - p|^2 - w in units of 2^(2 * scale).
static void power_distance(const living *l, const double *x, int id, int scale, wide *distance) {
    static wide difference, number, square;
    int k;
    distance->sign = distance->count = 0;
    for (k = 0; k < l->dim; k++) {
        wide_of(&difference, x[k], scale);
        wide_of(&number, l->x[id][k], scale);
        wide_add(&difference, &number, -1);
        wide_multiply(&square, &difference, &difference);
        wide_add(distance, &square, 1);
    }
    wide_of(&number, l->w[id], 2 * scale);
    wide_add(distance, &number, -1);
}

// No vertex may be nearer than the one that was found, or as near and before it in lexicographic order.
static void expect_nearest(const living *l, const double *x, int found) {
    static wide least, other;
    int scale = 500, i, k;
    for (k = 0; k < l->dim; k++)
        scale = x[k] != 0 && wide_scale(x[k]) < scale ? wide_scale(x[k]) : scale;
    for (i = 0; i < MOST_IDS; i++)
        for (k = 0; k < l->dim && l->there[i]; k++) {
            scale = l->x[i][k] != 0 && wide_scale(l->x[i][k]) < scale ? wide_scale(l->x[i][k]) : scale;
            while (l->w[i] != 0 && wide_scale(l->w[i]) < 2 * scale)
                scale--;
        }
    power_distance(l, x, found, scale, &least);
    for (i = 0; i < MOST_IDS; i++) {
        if (i == found || paradt_dynamic_representative(l->set, i) != i)
            continue;
        power_distance(l, x, i, scale, &other);
        wide_add(&other, &least, -1);
        for (k = 0; k < l->dim && l->x[i][k] == l->x[found][k]; k++)
            ;
        if (other.sign < 0 || (!other.sign && k < l->dim && l->x[i][k] < l->x[found][k]))
            fail("nearest", "another vertex is nearer");
    }
}

// The orientations of the cell with the place for each vertex have to say the same.
static void expect_location(const living *l, const double *x, paradt_location at) {
    paradt_index v[MAX_DIM + 1], n[MAX_DIM + 1];
    const double *p[MAX_DIM + 1];
    int i, j, sees = 0;
    if (!paradt_dynamic_cell(l->set, at.cell, v, n))
        fail("locate", "there is no such cell");
    for (j = 0; j <= l->dim; j++) {
        int sign;
        for (i = 0; i <= l->dim; i++)
            p[i] = i == j ? x : paradt_dynamic_point(l->set, v[i], NULL);
        sign = paradt_orient(l->dim, p);
        sees |= sign < 0 && n[j] < 0;
        if (at.face && (sign < 0 || (sign > 0) != (int)(at.face >> j & 1)))
            fail("locate", "the place is not in that face");
    }
    if (!at.face && !sees)
        fail("locate", "the place is said to be outside, and no facet sees it");
}

static void ask(living *l) {
    double x[MAX_DIM];
    int k, hint = next_byte(&l->bytes) % (MOST_IDS + 1) - 1;
    paradt_dynamic_info info;
    paradt_location at;
    paradt_index nearest;
    for (k = 0; k < l->dim; k++)
        x[k] = next_number(&l->bytes, l->encoding, l->parameter, 0);
    paradt_dynamic_get_info(l->set, &info);
    at = paradt_dynamic_locate(l->set, x, hint);
    nearest = paradt_dynamic_nearest(l->set, x, hint);
    if ((nearest < 0) != (info.vertex_count == 0) || (at.cell < 0) != (info.cell_count == 0))
        fail("query", "nothing was found among points, or something among none");
    if (nearest >= 0)
        expect_nearest(l, x, (int)nearest);
    if (info.dim == l->dim)
        expect_location(l, x, at);
}

// --- operations

static void next_point(living *l, double *x, double *w) {
    int k;
    for (k = 0; k < l->dim; k++)
        x[k] = next_number(&l->bytes, l->encoding, l->parameter, 0);
    if (l->flat & 3)
        x[l->dim - 1] = l->flat & 1 ? 0 : x[0];
    if (l->flat & 4)
        x[l->dim - 2] = 1;
    *w = l->weighted ? next_number(&l->bytes, l->encoding, 0, 0) : 0;
}

// Returns the id from a place on, round and round, that is there or, if `there` is 0, free; -1: none
static int id_from(const living *l, int from, int there) {
    int i;
    for (i = 0; i < MOST_IDS; i++)
        if (l->there[(from + i) % MOST_IDS] == there)
            return (from + i) % MOST_IDS;
    return -1;
}

static void put(living *l, paradt_index id, const double *x, double w) {
    if (id < 0 || id >= MOST_IDS)
        fail("living set", "an id is beyond the number of points");
    memcpy(l->x[id], x, (size_t)l->dim * sizeof *x);
    l->w[id] = w;
    l->there[id] = 1;
}

// An error has to be that of a failed allocation, or to say what such a set refuses. Returns 1 if the change was made.
// kind: 0: remove, 1: insert, 2: move
static int was_done(const living *l, int kind, paradt_status status, const char *what) {
    if (kind != 1 && l->method != PARADT_AUTO) {
        if (status != PARADT_ERROR_ARGUMENT)
            fail(what, "points went or moved where they only come");
    } else if (status && !(status == PARADT_ERROR_MEMORY && has_failed(&l->blocks))) {
        fail(what, paradt_status_string(status));
    }
    return !status;
}

// kind: 0: remove, 1: insert, 2: move. Returns 1 if the change was made.
static int one(living *l, int kind) {
    double x[MAX_DIM] = {0}, w = 0;
    int id = id_from(l, next_byte(&l->bytes) % MOST_IDS, 1), done;
    paradt_index made = id;
    if (kind)
        next_point(l, x, &w);
    if (kind == 1) {
        done = id_from(l, 0, 0) >= 0 && was_done(l, kind, paradt_dynamic_insert(l->set, x, w, id, &made), "insert");
    } else if (id < 0) {
        if (paradt_dynamic_remove(l->set, 0) != PARADT_ERROR_ARGUMENT)
            fail("remove", "a point that is not there was removed");
        done = 0;
    } else if (kind == 0) {
        done = was_done(l, kind, paradt_dynamic_remove(l->set, id), "remove");
    } else {
        done = was_done(l, kind, paradt_dynamic_move(l->set, id, x, w), "move");
    }
    if (done && kind)
        put(l, made, x, w);
    else if (done)
        l->there[id] = 0;
    return done;
}

// The same for up to eight points
static int many(living *l, int kind, int count) {
    double x[8 * MAX_DIM], w[8];
    paradt_index ids[8];
    paradt_points points;
    paradt_status status;
    int used[MOST_IDS] = {0}, free_ids = 0, found = 0, i;
    for (i = 0; i < MOST_IDS; i++)
        free_ids += !l->there[i];
    for (i = 0; i < count; i++) {
        int id = id_from(l, next_byte(&l->bytes) % MOST_IDS, 1);
        if (kind != 1 && (id < 0 || used[id]))
            continue;
        if (kind == 1 && found == free_ids)
            break;
        if (kind != 1)
            used[id] = 1;
        ids[found] = id;
        next_point(l, x + found * l->dim, w + found);
        found++;
    }
    points = paradt_points_f64(x, (size_t)found, l->dim);
    points.weights = l->weighted ? w : NULL;
    status = kind == 0   ? paradt_dynamic_remove_points(l->set, ids, (size_t)found)
             : kind == 1 ? paradt_dynamic_insert_points(l->set, &points, ids)
                         : paradt_dynamic_move_points(l->set, ids, &points);
    if (!was_done(l, kind, status, "batch"))
        return 0;
    for (i = 0; i < found; i++) {
        if (kind)
            put(l, ids[i], x + i * l->dim, w[i]);
        else
            l->there[ids[i]] = 0;
    }
    return 1;
}

// compares: 1: the result is compared with a new triangulation
static void operate(living *l, int compares) {
    int operation = next_byte(&l->bytes), kind = operation & 7, done;
    static living before;
    if (operation >> 4 & 1)
        l->flat = 0;
    if (kind >= 6) {
        ask(l);
        return;
    }
    before = *l;
    l->blocks.fail_at = operation >> 3 & 1 ? l->blocks.calls + next_byte(&l->bytes) : -1;
    done = kind < 3 ? one(l, kind) : many(l, kind - 3, 1 + (operation >> 5));
    look(l);
    if (done)
        expect_update(l, &before, kind < 5);
    else
        expect_as_before(l, &before);
    if (compares) {
        expect_same_result(l);
        expect_sound_cells(l);
    }
}

// Returns 0 where an allocation failed.
static int create(living *l, int count) {
    double x[8 * MAX_DIM], w[8];
    paradt_options options = counted_options(&l->blocks);
    paradt_points points = paradt_points_f64(x, (size_t)count, l->dim);
    int i;
    for (i = 0; i < count; i++)
        next_point(l, x + i * l->dim, w + i);
    if (l->weighted)
        points.weights = w;
    options.method = l->method;
    l->blocks.fail_at = next_byte(&l->bytes) < 32 ? next_byte(&l->bytes) : -1;
    if (!was_done(l, 1, paradt_dynamic_create(&l->set, &points, &options), "create")) {
        if (l->set)
            fail("create", "there is a set after an error");
        return 0;
    }
    for (i = 0; i < count; i++)
        put(l, i, x + i * l->dim, w[i]);
    return 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    enum { MOST_OPERATIONS = 60, COMPARED = ASKS_ALL ? 1 : 8 }; // every so many-th result is compared with a new one
    static const paradt_method methods[4] = {PARADT_AUTO, PARADT_DELAUNAY_TREE, PARADT_FLIP, PARADT_AUTO};
    static living l;
    int flags, operations;
    memset(&l, 0, sizeof l);
    l.bytes.data = data;
    l.bytes.left = size;
    flags = next_byte(&l.bytes);
    l.dim = 2 + (flags & 3);
    l.encoding = flags >> 2 & 3;
    l.weighted = flags >> 4 & 1;
    l.parameter = next_byte(&l.bytes);
    l.flat = next_byte(&l.bytes);
    l.method = methods[l.flat >> 3 & 3];
    l.flat &= 7;
    if (create(&l, flags >> 5)) {
        look(&l);
        for (operations = l.dim > 3 ? MOST_OPERATIONS / 2 : MOST_OPERATIONS; l.bytes.left && operations > 0; operations--)
            operate(&l, operations % COMPARED == 0);
        expect_same_result(&l);
        expect_sound_cells(&l);
    }
    paradt_dynamic_free(l.set);
    if (l.blocks.held)
        fail("living set", "memory was leaked");
    return 0;
}
