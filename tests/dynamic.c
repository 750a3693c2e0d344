// Living sets: after any changes the cells are those of a new triangulation of the points that are there.
#include "harness.h"

enum { LARGEST_DIM = SANITIZED ? 4 : 5 };
static const int points_in[] = {0, 0, 120, 90, 36, 20};

// The points that ought to be in a set, by id
typedef struct shadow {
    int dim, weighted, ids, count;
    double *x, *w;
    char *there;
} shadow;

static void shadow_room(shadow *s, paradt_index id) {
    if (id < s->ids)
        return;
    int ids = (int)id + 1;
    s->x = (double *)realloc(s->x, sizeof(double) * (size_t)(ids * s->dim));
    s->w = (double *)realloc(s->w, sizeof(double) * (size_t)ids);
    s->there = (char *)realloc(s->there, (size_t)ids);
    assert_true(s->x && s->w && s->there);
    memset(s->there + s->ids, 0, (size_t)(ids - s->ids));
    s->ids = ids;
}

static void shadow_put(shadow *s, paradt_index id, const double *x, double w) {
    shadow_room(s, id);
    s->count += !s->there[id];
    s->there[id] = 1;
    memcpy(s->x + (int)id * s->dim, x, sizeof(double) * (size_t)s->dim);
    s->w[id] = w;
}

static void shadow_take(shadow *s, paradt_index id) {
    s->count -= s->there[id];
    s->there[id] = 0;
}

static void shadow_free(shadow *s) {
    free(s->x);
    free(s->w);
    free(s->there);
}

// Returns a random id that is there.
static paradt_index shadow_any(const shadow *s, uint64_t *seed) {
    paradt_index id;
    do
        id = (paradt_index)random_below(seed, s->ids);
    while (!s->there[id]);
    return id;
}

// The points that are there, as a sample; id: [count] of each
static sample shadow_sample(const shadow *s, int *id, const char *name) {
    sample points = {0};
    snprintf(points.name, sizeof points.name, "%s", name);
    points.dim = s->dim;
    points.x = (double *)need((size_t)(s->count * s->dim + 1), sizeof(double));
    points.w = s->weighted ? (double *)need((size_t)s->count + 1, sizeof(double)) : NULL;
    for (int i = 0; i < s->ids; i++) {
        if (!s->there[i])
            continue;
        memcpy(points.x + points.count * s->dim, s->x + i * s->dim, sizeof(double) * (size_t)s->dim);
        if (points.w)
            points.w[points.count] = s->w[i];
        id[points.count++] = i;
    }
    return points;
}

// Fails unless cells, neighbours and star of the set agree with each other and with the export.
static void expect_readable(const paradt_dynamic *d, const paradt_triangulation *t, const sample *s) {
    paradt_dynamic_info info;
    paradt_index vertices[PARADT_MAX_DIM + 1], links[PARADT_MAX_DIM + 1], other[PARADT_MAX_DIM + 1];
    uint64_t hash = 0, row[PARADT_MAX_DIM + 1];
    size_t cells = 0, stars = 0;
    paradt_dynamic_get_info(d, &info);
    for (paradt_index cell = -1; cell <= (paradt_index)info.cell_end; cell++) {
        if (!paradt_dynamic_cell(d, cell, vertices, links))
            continue;
        cells++;
        for (int i = 0; i <= info.dim; i++) {
            row[i] = (uint64_t)vertices[i];
            if (links[i] < 0)
                continue;
            assert_true(paradt_dynamic_cell(d, links[i] / (info.dim + 1), NULL, other));
            assert_int_equal(other[links[i] % (info.dim + 1)], (info.dim + 1) * cell + i);
        }
        hash += paradt_hash_cell(row, info.dim + 1);
    }
    if (cells != info.cell_count || hash != paradt_hash(t))
        fail_on_sample(s, "cells that are read are not those of the export");
    for (paradt_index id = 0; id < (paradt_index)info.id_count; id++)
        stars += paradt_dynamic_star(d, id, NULL, 0);
    if (stars != cells * (size_t)(info.dim + 1))
        fail_on_sample(s, "stars do not have all cells");
}

// Fails unless the set is the triangulation of the points that ought to be there.
static void expect_canonical(const paradt_dynamic *d, const shadow *s, const char *name) {
    int *id = (int *)need((size_t)s->ids + 1, sizeof(int)), *compact = (int *)need((size_t)s->ids + 1, sizeof(int));
    sample points = shadow_sample(s, id, name);
    paradt_points given = points_of(&points);
    paradt_triangulation t, fresh;
    paradt_dynamic_info info;
    paradt_fault fault;
    watch(&points, 60);
    assert_int_equal(paradt_triangulate(&fresh, &given, NULL), PARADT_OK);
    assert_int_equal(paradt_dynamic_export(d, &t), PARADT_OK);
    paradt_dynamic_get_info(d, &info);
    expect_readable(d, &t, &points);
    for (int i = 0; i < points.count; i++)
        compact[id[i]] = i;
    for (int i = 0; i < s->ids; i++) {
        paradt_index r = i < (int)info.id_count ? paradt_dynamic_representative(d, i) : -2;
        const double *x = i < (int)info.id_count ? paradt_dynamic_point(d, i, NULL) : NULL;
        if (s->there[i] ? r != (fresh.representative[compact[i]] < 0 ? -1 : id[fresh.representative[compact[i]]]) : r != -2)
            fail_on_sample(&points, "another point stands for a place");
        if (!x != !s->there[i])
            fail_on_sample(&points, "a point is there that ought not to be, or is not");
        for (int k = 0; x && k < s->dim; k++)
            if (x[k] != s->x[i * s->dim + k])
                fail_on_sample(&points, "a point is not where it was put");
    }
    for (size_t i = 0; i < t.cell_count * (size_t)(t.dim + 1); i++)
        t.cells[i] = compact[t.cells[i]];
    for (size_t i = 0; i < t.point_count; i++) {
        if (t.representative[i] == -2)
            continue;
        t.representative[compact[i]] = t.representative[i] < 0 ? -1 : compact[t.representative[i]];
    }
    t.point_count = (size_t)points.count;
    if (t.dim != fresh.dim || info.dim != fresh.dim)
        fail_on_sample(&points, "the dimension differs");
    if (paradt_hash(&t) != paradt_hash(&fresh))
        fail_on_sample(&points, "cells differ");
    if (t.stats.hull_facets != fresh.stats.hull_facets || t.stats.hidden != fresh.stats.hidden ||
        t.stats.duplicates != fresh.stats.duplicates || info.point_count != (size_t)points.count)
        fail_on_sample(&points, "counts differ");
    if (paradt_check(&t, &given, NULL, &fault))
        fail_on_sample(&points, fault.reason);
    watch(NULL, 0);
    paradt_free(&t);
    paradt_free(&fresh);
    sample_free(&points);
    free(id);
    free(compact);
}

// A set, what ought to be in it, and where points come from
typedef struct game {
    paradt_dynamic *d;
    shadow s;
    const sample *pool;
    uint64_t seed;
} game;

static game game_begin(const sample *pool, int first, const paradt_options *options, uint64_t seed) {
    game g = {0};
    sample part = *pool;
    g.pool = pool;
    g.seed = seed;
    g.s.dim = pool->dim;
    g.s.weighted = pool->w != NULL;
    part.count = first;
    paradt_points points = points_of(&part);
    assert_int_equal(paradt_dynamic_create(&g.d, &points, options), PARADT_OK);
    for (int i = 0; i < first; i++)
        shadow_put(&g.s, i, pool->x + i * pool->dim, pool->w ? pool->w[i] : 0.0);
    return g;
}

static void game_end(game *g) {
    paradt_dynamic_free(g->d);
    shadow_free(&g->s);
}

// Makes a point: one of the pool, at the place of another, or near one.
static void game_point(game *g, double *x, double *w) {
    int at = random_below(&g->seed, g->pool->count), dim = g->pool->dim, how = random_below(&g->seed, 8);
    memcpy(x, g->pool->x + at * dim, sizeof(double) * (size_t)dim);
    *w = g->pool->w ? g->pool->w[random_below(&g->seed, g->pool->count)] : 0.0;
    if (how == 0 && g->s.count) {
        paradt_index other = shadow_any(&g->s, &g->seed);
        memcpy(x, g->s.x + (int)other * dim, sizeof(double) * (size_t)dim);
    } else if (how == 1) {
        for (int k = 0; k < dim; k++) {
            double moved = x[k] + 0.01 * random_unit(&g->seed) * x[k];
            if (isfinite(moved))
                x[k] = moved;
        }
    }
}

static void game_insert(game *g) {
    double x[CELLS_MAX_DIM], w;
    paradt_index id = -7, hint = g->s.count && random_below(&g->seed, 2) ? shadow_any(&g->s, &g->seed) : -1;
    game_point(g, x, &w);
    assert_int_equal(paradt_dynamic_insert(g->d, x, w, hint, &id), PARADT_OK);
    assert_true(id >= 0 && (id >= g->s.ids || !g->s.there[id]));
    shadow_put(&g->s, id, x, w);
}

static void game_remove(game *g) {
    paradt_index id = shadow_any(&g->s, &g->seed);
    assert_int_equal(paradt_dynamic_remove(g->d, id), PARADT_OK);
    shadow_take(&g->s, id);
    assert_int_equal(paradt_dynamic_remove(g->d, id), PARADT_ERROR_ARGUMENT);
}

static void game_move(game *g) {
    double x[CELLS_MAX_DIM], w;
    paradt_index id = shadow_any(&g->s, &g->seed);
    game_point(g, x, &w);
    if (random_below(&g->seed, 3)) { // not far
        double part = random_below(&g->seed, 2) ? 1e-3 : 0.05;
        for (int k = 0; k < g->s.dim; k++) {
            double here = g->s.x[(int)id * g->s.dim + k], to = here + part * (x[k] - here);
            x[k] = isfinite(to) ? to : here;
        }
        if (random_below(&g->seed, 2))
            w = g->s.w[id];
    }
    assert_int_equal(paradt_dynamic_move(g->d, id, x, w), PARADT_OK);
    shadow_put(&g->s, id, x, w);
}

// Changes `count` points at once.
static void game_batch(game *g, int count) {
    int dim = g->s.dim, kind = random_below(&g->seed, 3), n = 0;
    double *x = (double *)need((size_t)(count * dim), sizeof(double)), *w = (double *)need((size_t)count, sizeof(double));
    paradt_index *ids = (paradt_index *)need((size_t)count, sizeof(paradt_index));
    for (int i = 0; kind && i < g->s.ids && n < count; i++)
        if (g->s.there[i] && random_below(&g->seed, 3))
            ids[n++] = i;
    if (!kind)
        n = count;
    for (int i = 0; i < n; i++)
        game_point(g, x + i * dim, w + i);
    paradt_points points = paradt_points_f64(x, (size_t)n, dim);
    points.weights = g->s.weighted ? w : NULL;
    if (kind == 0)
        assert_int_equal(paradt_dynamic_insert_points(g->d, &points, ids), PARADT_OK);
    else if (kind == 1)
        assert_int_equal(paradt_dynamic_move_points(g->d, ids, &points), PARADT_OK);
    else
        assert_int_equal(paradt_dynamic_remove_points(g->d, ids, (size_t)n), PARADT_OK);
    for (int i = 0; i < n; i++)
        if (kind < 2)
            shadow_put(&g->s, ids[i], x + i * dim, w[i]);
        else
            shadow_take(&g->s, ids[i]);
    free(x);
    free(w);
    free(ids);
}

static void game_step(game *g, int wanted) {
    int draw = random_below(&g->seed, 20);
    if (draw == 0)
        game_batch(g, 1 + random_below(&g->seed, 12));
    else if (!g->s.count || draw < (g->s.count < wanted ? 10 : 4))
        game_insert(g);
    else if (draw < 14)
        game_remove(g);
    else
        game_move(g);
}

// state: family
static void changed_is_new(void **state) {
    int f = (int)(intptr_t)*state;
    for (int dim = 2; dim <= LARGEST_DIM; dim++)
        for (int w = 0; w < WEIGHTING_COUNT; w++) {
            int extremes = families[f].extremes || weightings[w].extremes;
            int count = extremes ? points_in[dim] / 3 : points_in[dim], steps = SANITIZED ? 20 : extremes ? 30 : 80;
            if (extremes && dim > 4)
                continue;
            sample pool = family_make(&families[f], &weightings[w], dim, count, (uint64_t)(3 + f + 50 * w));
            game g = game_begin(&pool, w % 2 ? 0 : pool.count / 2, NULL, (uint64_t)(f + w + dim));
            expect_canonical(g.d, &g.s, pool.name);
            for (int step = 0; step < steps; step++) {
                game_step(&g, count / 2);
                expect_canonical(g.d, &g.s, pool.name);
            }
            while (g.s.count) { // back to nothing
                game_remove(&g);
                if (g.s.count % 4 == 0 || g.s.count < 8)
                    expect_canonical(g.d, &g.s, pool.name);
            }
            game_end(&g);
            sample_free(&pool);
        }
}

int main(void) {
    struct CMUnitTest tests[FAMILY_COUNT + 16];
    size_t count = 0;
    for (int f = 0; f < FAMILY_COUNT; f++)
        tests[count++] = named_test(changed_is_new, (void *)(intptr_t)f, "changed_is_new_%s", families[f].name);
    return run_named_tests("dynamic", tests, count);
}
