// Living sets: after any changes the cells are those of a new triangulation of the points that are there.
#include "harness.h"
#include "runners.h"

#include <time.h>

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
    for (paradt_index number = -1; number <= (paradt_index)info.cell_end; number++) {
        if (!paradt_dynamic_cell(d, number, vertices, links))
            continue;
        cells++;
        for (int i = 0; i <= info.dim; i++) {
            row[i] = (uint64_t)vertices[i];
            if (links[i] < 0)
                continue;
            assert_true(paradt_dynamic_cell(d, links[i] / (info.dim + 1), NULL, other));
            assert_int_equal(other[links[i] % (info.dim + 1)], (info.dim + 1) * number + i);
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

// Changes `count` points at once. kind: 0: inserts, 1: moves, 2: removes
static void game_batch(game *g, int count, int kind) {
    int dim = g->s.dim, n = 0;
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
        game_batch(g, 1 + random_below(&g->seed, 12), random_below(&g->seed, 3));
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
            if ((extremes && dim > 4) || (SANITIZED && (f + dim + w / 2) % 3))
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


// What points of a set are located by; the first one's points go and move, too
static const paradt_method ways[] = {PARADT_AUTO, PARADT_DELAUNAY_TREE, PARADT_FLIP};
enum { WAYS = 3 };

// Points that are located by all cells that there were only come, one by one and some at once. state: family
static void located_by_what_was_is_new(void **state) {
    int f = (int)(intptr_t)*state;
    for (int dim = 2; dim <= 4; dim++)
        for (int w = 0; w < WEIGHTING_COUNT; w++)
            for (int way = 1; way < WAYS; way++) {
                int extremes = families[f].extremes || weightings[w].extremes;
                int count = extremes ? points_in[dim] / 3 : points_in[dim], steps = SANITIZED ? 10 : extremes ? 20 : 40;
                if (SANITIZED && (f + dim + w / 2) % 3)
                    continue;
                sample pool = family_make(&families[f], &weightings[w], dim, count, (uint64_t)(3 + f + 50 * w));
                paradt_options options = {0};
                options.method = ways[way];
                game g = game_begin(&pool, (w + way) % 2 ? 0 : pool.count / 2, &options, (uint64_t)(f + w + dim));
                expect_canonical(g.d, &g.s, pool.name);
                for (int step = 0; step < steps; step++) {
                    if (step % 10 == 9)
                        game_batch(&g, 1 + random_below(&g.seed, 12), 0);
                    else
                        game_insert(&g);
                    expect_canonical(g.d, &g.s, pool.name);
                }
                game_end(&g);
                sample_free(&pool);
            }
}

// Removing and moving is refused there, and leaves the set.
static void located_by_what_was_stays(void **state) {
    (void)state;
    for (int way = 1; way < WAYS; way++) {
        sample pool = family_make(&families[family_named("uniform")], NULL, 3, 100, 4);
        paradt_options options = {0};
        paradt_dynamic_info info;
        paradt_points two = paradt_points_f64(pool.x + 3 * 98, 2, 3);
        paradt_index ids[] = {3, 5};
        options.method = ways[way];
        game g = game_begin(&pool, 90, &options, 3);
        assert_int_equal(paradt_dynamic_remove(g.d, 3), PARADT_ERROR_ARGUMENT);
        assert_int_equal(paradt_dynamic_remove_points(g.d, ids, 2), PARADT_ERROR_ARGUMENT);
        assert_int_equal(paradt_dynamic_move(g.d, 3, pool.x + 3 * 95, 0.0), PARADT_ERROR_ARGUMENT);
        assert_int_equal(paradt_dynamic_move_points(g.d, ids, &two), PARADT_ERROR_ARGUMENT);
        paradt_dynamic_get_info(g.d, &info);
        assert_non_null(strstr(info.error_text, "insertion"));
        expect_canonical(g.d, &g.s, pool.name);
        game_insert(&g);
        expect_canonical(g.d, &g.s, pool.name);
        game_end(&g);
        sample_free(&pool);
    }
}

// Thousands of points come one by one to a set of thousands, at random and along a line.
static void located_by_what_was_goes_on(void **state) {
    (void)state;
    for (int way = 1; way < WAYS; way++)
        for (int dim = 2; dim <= 3; dim++)
            for (int w = 0; w < 2; w++) {
                int count = SANITIZED ? 600 : 6000;
                sample pool = family_make(&families[family_named("uniform")], &weightings[w], dim, count, 4);
                paradt_options options = {0};
                options.method = ways[way];
                game g = game_begin(&pool, count / 2, &options, 3);
                for (int i = count / 2; i < count; i++) {
                    double x[CELLS_MAX_DIM];
                    paradt_index id;
                    double weight = pool.w ? pool.w[i] : 0.0;
                    for (int k = 0; k < dim; k++)
                        x[k] = i % 3 ? pool.x[i * dim + k] : (double)i / (double)count;
                    assert_int_equal(paradt_dynamic_insert(g.d, x, weight, -1, &id), PARADT_OK);
                    shadow_put(&g.s, id, x, weight);
                }
                expect_canonical(g.d, &g.s, pool.name);
                game_end(&g);
                sample_free(&pool);
            }
}

// --- growing

// Points that come one by one: all at one place, then on a line, in a plane, and so on; and that go in an order of
// their own. The dimension rises and falls with them.
static void dimension_rises_and_falls(void **state) {
    (void)state;
    for (int dim = 2; dim <= LARGEST_DIM; dim++)
        for (int order = 0; order < 2 + WAYS; order++) {
            uint64_t seed = (uint64_t)(7 * dim + order);
            paradt_points none = paradt_points_f64(NULL, 0, dim);
            paradt_options options = {0};
            paradt_dynamic_info info;
            game g = {0};
            g.s.dim = dim;
            options.method = ways[order < 3 ? 0 : order - 2];
            assert_int_equal(paradt_dynamic_create(&g.d, &none, &options), PARADT_OK);
            expect_canonical(g.d, &g.s, "nothing");
            for (int flat = 0; flat <= dim; flat++)
                for (int i = 0; i < 5; i++) {
                    double x[CELLS_MAX_DIM];
                    paradt_index id;
                    for (int k = 0; k < dim; k++) // on a slanted flat through (1, ..., 1)
                        x[dim - 1 - k] = 1.0 + (k < flat ? (double)random_below(&seed, 64) / 8.0 : 0.0);
                    if (flat && flat < dim)
                        x[dim - 1 - flat] = x[dim - flat];
                    assert_int_equal(paradt_dynamic_insert(g.d, x, 0.0, -1, &id), PARADT_OK);
                    shadow_put(&g.s, id, x, 0.0);
                    expect_canonical(g.d, &g.s, "growing");
                }
            paradt_dynamic_get_info(g.d, &info);
            assert_int_equal(info.dim, dim);
            while (g.s.count && order < 3) {
                paradt_index id = order == 0 ? g.s.ids - 1 : 0;
                while (order < 2 && !g.s.there[id])
                    id += order == 0 ? -1 : 1;
                if (order == 2)
                    id = shadow_any(&g.s, &seed);
                assert_int_equal(paradt_dynamic_remove(g.d, id), PARADT_OK);
                shadow_take(&g.s, id);
                expect_canonical(g.d, &g.s, "shrinking");
            }
            game_end(&g);
        }
}

// Points that come from farther and farther away, up to where numbers end.
static void range_grows(void **state) {
    (void)state;
    for (int run = 0; run < 2 * WAYS; run++) {
        int dim = 2 + run % 2;
        paradt_options options = {0};
        options.method = ways[run / 2];
        sample pool = family_make(&families[family_named("uniform")], NULL, dim, 40, 5);
        game g = game_begin(&pool, 40, &options, 3);
        for (int e = 1; e < 1023; e += e < 12 ? 1 : 90) {
            double x[CELLS_MAX_DIM];
            paradt_index id;
            for (int k = 0; k < dim; k++)
                x[k] = ldexp(random_unit(&g.seed) - 0.5, k ? e : -e);
            assert_int_equal(paradt_dynamic_insert(g.d, x, 0.0, -1, &id), PARADT_OK);
            shadow_put(&g.s, id, x, 0.0);
            expect_canonical(g.d, &g.s, "farther and farther");
            if (options.method)
                game_insert(&g);
            else if (e % 2)
                game_remove(&g);
            else
                game_move(&g);
            expect_canonical(g.d, &g.s, "farther and farther");
        }
        game_end(&g);
        sample_free(&pool);
    }
}

// A point with very many neighbours goes, and comes again: time does not grow as the square of their number.
static double time_of_removal(int dim, int count, int spread) {
    sample pool = family_make(&families[family_named("sphere")], NULL, dim, count, 9);
    double centre[CELLS_MAX_DIM] = {0}, best = 1e9;
    for (int k = 0; k < dim; k++)
        centre[k] = spread ? 0.001 * (k + 1) : 0.0;
    memcpy(pool.x, centre, sizeof(double) * (size_t)dim);
    paradt_points points = points_of(&pool);
    paradt_triangulation t, u;
    paradt_dynamic *d;
    paradt_index id = 0;
    assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_dynamic_export(d, &t), PARADT_OK);
    for (int again = 0; again < 3; again++) {
        clock_t begun = clock();
        assert_int_equal(paradt_dynamic_remove(d, id), PARADT_OK);
        double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
        best = seconds < best ? seconds : best;
        assert_int_equal(paradt_dynamic_insert(d, centre, 0.0, -1, &id), PARADT_OK);
    }
    assert_int_equal(id, 0);
    assert_int_equal(paradt_dynamic_export(d, &u), PARADT_OK);
    assert_true(paradt_hash(&t) == paradt_hash(&u));
    paradt_free(&t);
    paradt_free(&u);
    paradt_dynamic_free(d);
    sample_free(&pool);
    return best;
}

// A point high above many others, which lie in a hyperplane: where it goes there are no cells left.
static void a_summit_above_a_flat_goes_and_comes(void **state) {
    static const int sides[] = {0, 0, 100, 10, 5};
    (void)state;
    for (int dim = 2; dim <= 4; dim++) {
        enum { BELOW = 20 };
        int side = sides[dim], flat = 1, summit = 0;
        for (int k = 1; k < dim; k++)
            flat *= side;
        sample pool = sample_make("flat", dim, flat + BELOW + 1);
        uint64_t seed = 3;
        for (int i = 0; i < pool.count; i++) {
            double *x = pool.x + i * dim;
            for (int k = 1, rest = i; k < dim; k++, rest /= side)
                x[k] = i < flat ? rest % side : 0.5 * (side - 1) + (i == flat + BELOW ? 0.0 : random_unit(&seed) - 0.5);
            x[0] = i < flat ? 0.0 : i == flat + BELOW ? 1e6 : -random_unit(&seed);
        }
        summit = flat + BELOW;
        game g = game_begin(&pool, pool.count, NULL, 5);
        paradt_triangulation t;
        assert_int_equal(paradt_dynamic_export(g.d, &t), PARADT_OK);
        for (size_t i = 0; i < t.cell_count * (size_t)(dim + 1); i++) // its neighbours are in the flat
            for (int j = 0; j <= dim && t.cells[i] == summit; j++) {
                paradt_index other = t.cells[i / (size_t)(dim + 1) * (size_t)(dim + 1) + (size_t)j];
                assert_true(other < flat || other == summit);
            }
        paradt_free(&t);
        for (int again = 0; again < 2; again++) {
            assert_int_equal(paradt_dynamic_remove(g.d, summit), PARADT_OK);
            shadow_take(&g.s, summit);
            expect_canonical(g.d, &g.s, pool.name);
            paradt_index id;
            assert_int_equal(paradt_dynamic_insert(g.d, pool.x + summit * dim, 0.0, -1, &id), PARADT_OK);
            assert_int_equal(id, summit);
            shadow_put(&g.s, summit, pool.x + summit * dim, 0.0);
            expect_canonical(g.d, &g.s, pool.name);
        }
        game_end(&g);
        sample_free(&pool);
    }
}

static void many_neighbours_take_no_square(void **state) {
    (void)state;
    int count = SANITIZED ? 2000 : 10000;
    for (int dim = 2; dim <= 3; dim++) {
        double half = time_of_removal(dim, count, 1), whole = time_of_removal(dim, 2 * count, 1);
        print_message("# %d dimensions: %.1f ms for %d neighbours, %.1f ms for twice as many\n", dim, 1e3 * half, count,
                      1e3 * whole);
        if (!SANITIZED)
            assert_true(whole < 3.5 * half);
    }
}

// --- errors

typedef struct failing {
    size_t calls, fail_at, live;
} failing;

static void *failing_alloc(void *user, size_t size) {
    failing *f = (failing *)user;
    void *block = ++f->calls == f->fail_at ? NULL : malloc(size);
    f->live += block != NULL;
    return block;
}

static void failing_free(void *user, void *memory) {
    ((failing *)user)->live -= memory != NULL;
    free(memory);
}

// Counts the cells of a vertex by looking at all, and fails unless the star is these, each once.
static int expect_star(const paradt_dynamic *d, paradt_index id, paradt_index *cells, size_t room) {
    paradt_dynamic_info info;
    paradt_index row[PARADT_MAX_DIM + 1];
    int count = 0;
    paradt_dynamic_get_info(d, &info);
    char *seen = (char *)need(info.cell_end, 1);
    size_t stars = paradt_dynamic_star(d, id, cells, room);
    assert_true(stars <= room);
    for (size_t i = 0; i < stars; i++) {
        assert_true(!seen[cells[i]]);
        seen[cells[i]] = 1;
    }
    for (paradt_index place = 0; place < (paradt_index)info.cell_end; place++) {
        int has = 0;
        if (!paradt_dynamic_cell(d, place, row, NULL))
            continue;
        for (int i = 0; i <= info.dim; i++)
            has |= row[i] == id;
        assert_int_equal(seen[place], has);
        count += has;
    }
    assert_int_equal(stars, count);
    free(seen);
    return count;
}

// A point with very many cells: its star is whole, with and without memory, and takes the time that it takes to read so
// many cells, however many others there are.
static void large_stars_are_whole(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        int count = SANITIZED ? 16000 : 40000, many;
        failing memory = {0, 0, 0};
        paradt_options options = {0};
        paradt_dynamic *d;
        options.allocator.alloc = failing_alloc;
        options.allocator.free = failing_free;
        options.allocator.user = &memory;
        sample pool = family_make(&families[family_named("uniform")], NULL, dim, count, 9);
        for (int i = 0; i < count; i++) { // those near the centre go to a sphere around it
            double square = 0.0, *x = pool.x + i * dim, radius = dim == 2 ? 0.08 : 0.2;
            for (int k = 0; k < dim; k++)
                square += (x[k] - 0.5) * (x[k] - 0.5);
            for (int k = 0; k < dim; k++)
                x[k] = !i ? 0.5 : square < radius * radius ? 0.5 + (x[k] - 0.5) * radius / sqrt(square) : x[k];
        }
        paradt_points points = points_of(&pool);
        assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_OK);
        size_t live = memory.live;
        paradt_index *cells = (paradt_index *)need(20000, sizeof *cells), few[3] = {-1, -1, -1};
        many = expect_star(d, 0, cells, 20000);
        assert_true(many > 257);
        for (size_t at = 1; at < 20; at++) {
            memory.calls = 0;
            memory.fail_at = at;
            assert_int_equal(expect_star(d, 0, cells, 20000), many);
            memory.fail_at = 0;
        }
        assert_int_equal(paradt_dynamic_star(d, 0, few, 2), many);
        assert_true(few[1] >= 0 && few[2] == -1);
        assert_int_equal(memory.live, live);
        if (!SANITIZED) {
            paradt_dynamic_info info;
            double star = 1e9, all = 1e9;
            paradt_dynamic_get_info(d, &info);
            for (int again = 0; again < 5; again++) {
                clock_t begun = clock();
                for (int i = 0; i < 20; i++)
                    paradt_dynamic_star(d, 0, cells, 20000);
                star = fmin(star, (double)(clock() - begun));
                begun = clock();
                for (int i = 0; i < 20; i++)
                    for (paradt_index place = 0; place < (paradt_index)info.cell_end; place++)
                        paradt_dynamic_cell(d, place, cells, NULL);
                all = fmin(all, (double)(clock() - begun));
            }
            print_message("# %d dimensions: star of %d cells, reading all %d times as many: %.3f of the time\n", dim, many,
                          (int)info.cell_count / many, star / all);
            assert_true(star < 0.5 * all);
        }
        paradt_dynamic_free(d);
        sample_free(&pool);
        free(cells);
    }
}

// One change of each kind; returns its status.
static paradt_status change_once(game *g, int kind, const double *x, const double *w, paradt_index *ids, int n) {
    paradt_points points = paradt_points_f64(x, (size_t)n, g->s.dim);
    points.weights = g->s.weighted ? w : NULL;
    if (kind == 0)
        return paradt_dynamic_insert_points(g->d, &points, ids);
    if (kind == 1)
        return paradt_dynamic_move_points(g->d, ids, &points);
    return paradt_dynamic_remove_points(g->d, ids, (size_t)n);
}

// state: family
static void failing_allocations_leave_the_set(void **state) {
    int f = (int)(intptr_t)*state, failed_of_one = 0;
    for (int dim = 2; dim <= 4; dim++)
        for (int w = 0; w < 3; w++)
            for (int run = 0; run < 6 + 2 * (WAYS - 1); run++) { // one point or some: inserted, moved, removed; inserted
                int kind = run < 6 ? run : 3 * (run % 2), way = run < 6 ? 0 : (run - 4) / 2;
                int count = dim < 4 ? 40 : 14, n = kind < 3 ? 1 : 9, failed = 0;
                double x[9 * CELLS_MAX_DIM], weight[9];
                paradt_index ids[9];
                failing memory = {0, 0, 0};
                paradt_options options = {0};
                options.allocator.alloc = failing_alloc;
                options.allocator.free = failing_free;
                options.allocator.user = &memory;
                options.method = ways[way];
                sample pool = family_make(&families[f], &weightings[w], dim, count, (uint64_t)(8 + w));
                game g = game_begin(&pool, pool.count / 2, &options, (uint64_t)(kind + 8 * w));
                paradt_status status = PARADT_ERROR_MEMORY;
                for (int i = 0; i < n; i++) {
                    game_point(&g, x + i * dim, weight + i);
                    do
                        ids[i] = shadow_any(&g.s, &g.seed);
                    while (i && kind % 3 && ids[i] <= ids[i - 1] && ids[i - 1] + 2 < g.s.ids - n + i && g.s.count > 9);
                    if (i && kind % 3 && ids[i] <= ids[i - 1])
                        n = i;
                }
                for (size_t at = 1; status; at += SANITIZED ? 3 : 1) {
                    memory.calls = 0;
                    memory.fail_at = at;
                    status = change_once(&g, kind % 3, x, weight, ids, n);
                    memory.fail_at = 0;
                    if (!status)
                        break;
                    failed++;
                    assert_int_equal(status, PARADT_ERROR_MEMORY);
                    if (at % 3 == 1 || at < 12)
                        expect_canonical(g.d, &g.s, pool.name);
                }
                assert_true(failed > 0 || n == 1); // what one point takes may be there
                failed_of_one += n == 1 ? failed : 0;
                for (int i = 0; i < n; i++)
                    if (kind % 3 < 2)
                        shadow_put(&g.s, ids[i], x + i * dim, weight[i]);
                    else
                        shadow_take(&g.s, ids[i]);
                expect_canonical(g.d, &g.s, pool.name);
                for (int i = 0; i < 4; i++)
                    game_insert(&g);
                expect_canonical(g.d, &g.s, pool.name);
                game_end(&g);
                assert_int_equal(memory.live, 0);
                sample_free(&pool);
            }
    assert_true(failed_of_one > 0);
}

// Creating either works or leaves nothing behind.
static void failing_allocations_while_creating(void **state) {
    (void)state;
    for (int run = 0; run < 2 * WAYS; run++) {
        sample pool = family_make(&families[family_named("duplicates")], &weightings[run % 2], 3, 60, 4);
        paradt_points points = points_of(&pool);
        paradt_status status = PARADT_ERROR_MEMORY;
        for (size_t at = 1; status; at++) {
            failing memory = {0, at, 0};
            paradt_options options = {0};
            paradt_dynamic *d;
            options.method = ways[run / 2];
            options.allocator.alloc = failing_alloc;
            options.allocator.free = failing_free;
            options.allocator.user = &memory;
            status = paradt_dynamic_create(&d, &points, &options);
            assert_true(status == PARADT_OK || (status == PARADT_ERROR_MEMORY && !d));
            paradt_dynamic_free(d);
            assert_int_equal(memory.live, 0);
        }
        sample_free(&pool);
    }
}

// Regions, far away and tiny scales, and points near a sphere: whatever way builds the cells, the set goes on from them.
static void every_way_of_creating_leads_on(void **state) {
    static const char *const names[] = {"uniform", "sphere", "rough sphere", "duplicates"};
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (int w = 0; w < 2; w++)
            for (int name = 0; name < 4; name++)
                for (int e = -400; e <= 400; e += 400) {
                    if (SANITIZED && (e || w))
                        continue;
                    sample pool = family_make(&families[family_named(names[name])], &weightings[w], dim,
                                              dim < 4 ? 2500 : 300, (uint64_t)(8 + w));
                    paradt_options options = {0};
                    options.regions = (size_t)(1 + name);
                    options.parallel_for = run_backwards;
                    for (int i = 0; i < pool.count * dim; i++)
                        pool.x[i] = ldexp(pool.x[i], e);
                    for (int i = 0; i < pool.count && pool.w; i++)
                        pool.w[i] = ldexp(pool.w[i], 2 * e);
                    game g = game_begin(&pool, pool.count, &options, 5);
                    expect_canonical(g.d, &g.s, pool.name);
                    for (int step = 0; step < 60; step++)
                        game_step(&g, pool.count);
                    expect_canonical(g.d, &g.s, pool.name);
                    game_end(&g);
                    sample_free(&pool);
                }
}

// The nearest vertex has more neighbours than are kept on the stack; without memory for them all vertices are looked at.
static void the_nearest_of_many_neighbours_is_found(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int refuse = 0; refuse < 2; refuse++) {
            sample s = family_make(&families[family_named("sphere")], NULL, dim, 600, 9);
            for (int k = 0; k < dim; k++)
                s.x[k] = 0.001 * (k + 1);
            double weights[600]; // with weights all neighbours are looked at in space, too
            for (int i = 0; i < s.count; i++)
                weights[i] = 0.25;
            paradt_points points = points_of(&s);
            points.weights = dim == 3 ? weights : NULL;
            failing memory = {0, 0, 0};
            paradt_options options = {0};
            paradt_dynamic *d;
            uint64_t seed = 7;
            options.allocator.alloc = failing_alloc;
            options.allocator.free = failing_free;
            options.allocator.user = &memory;
            assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_OK);
            size_t made = memory.calls;
            for (int turn = 0; turn < 100; turn++) {
                double x[3], least = 1e300;
                int nearest = 0;
                for (int k = 0; k < dim; k++)
                    x[k] = 2 * random_unit(&seed) - 1;
                for (int i = 0; i < s.count; i++) {
                    double distance = 0;
                    for (int k = 0; k < dim; k++)
                        distance += (s.x[i * dim + k] - x[k]) * (s.x[i * dim + k] - x[k]);
                    if (distance < least)
                        least = distance, nearest = i;
                }
                memory.fail_at = refuse ? memory.calls + 1 : 0;
                assert_int_equal(paradt_dynamic_nearest(d, x, -1), nearest);
            }
            assert_true(memory.calls > made);
            paradt_dynamic_free(d);
            sample_free(&s);
        }
}

// Blocks of malloc's are enlarged, those of other allocators replaced: the account is the same.
static void a_set_that_grows_holds_as_much_by_malloc_as_by_an_allocator(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        sample s = family_make(&families[family_named("uniform")], NULL, dim, 600, 3);
        size_t bytes[2], least = 0;
        for (int own = 0; own < 2; own++) {
            failing memory = {0, 0, 0};
            paradt_options options = {0};
            paradt_points none = paradt_points_f64(NULL, 0, (size_t)dim);
            paradt_dynamic_info info;
            paradt_dynamic *d;
            paradt_index id;
            options.allocator.alloc = own ? failing_alloc : NULL;
            options.allocator.free = own ? failing_free : NULL;
            options.allocator.user = &memory;
            assert_int_equal(paradt_dynamic_create(&d, &none, &options), PARADT_OK);
            for (int i = 0; i < s.count; i++)
                assert_int_equal(paradt_dynamic_insert(d, s.x + i * dim, 0, -1, &id), PARADT_OK);
            paradt_dynamic_get_info(d, &info);
            bytes[own] = info.bytes;
            least = info.cell_count * 2 * (size_t)(dim + 1) * sizeof(paradt_index);
            paradt_dynamic_free(d);
        }
        assert_true(bytes[0] == bytes[1] && bytes[0] > least);
        sample_free(&s);
    }
}

static int cancel_later(void *user, double done) {
    int *calls = (int *)user;
    (void)done;
    return --*calls < 0;
}

// An export either works or leaves nothing behind, if memory is refused or the call is cancelled.
static void failing_exports_leave_nothing(void **state) {
    (void)state;
    for (int dim = 0; dim <= 3; dim += dim ? 1 : 2) { // in three dimensions; 0: all points are at one place
        sample pool = family_make(&families[family_named("uniform")], NULL, dim ? dim : 2, dim ? 60 : 2, 4);
        for (int i = 0; i < 2 * pool.count && !dim; i++)
            pool.x[i] = 1;
        paradt_points points = points_of(&pool);
        failing memory = {0, 0, 0};
        int calls = 1 << 30;
        paradt_options options = {0};
        paradt_dynamic *d;
        paradt_triangulation t;
        paradt_status status = PARADT_ERROR_MEMORY;
        options.allocator.alloc = failing_alloc;
        options.allocator.free = failing_free;
        options.allocator.user = &memory;
        options.progress = cancel_later;
        options.user = &calls;
        assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_OK);
        size_t live = memory.live;
        for (size_t at = 1; status; at++) {
            memory.calls = 0;
            memory.fail_at = at;
            status = paradt_dynamic_export(d, &t);
            assert_true(status == PARADT_OK || (status == PARADT_ERROR_MEMORY && t.dim == -1 && !t.cells && memory.live == live));
        }
        assert_true(memory.fail_at > memory.calls && memory.calls > 1);
        paradt_free(&t);
        memory.fail_at = 0;
        calls = 0;
        assert_int_equal(paradt_dynamic_export(d, &t), PARADT_ERROR_CANCELLED);
        assert_true(t.dim == -1 && !t.cells && memory.live == live);
        calls = 1 << 30;
        paradt_dynamic_free(d);
        assert_int_equal(memory.live, 0);
        sample_free(&pool);
    }
}

// A set whose axes are not the caller's grows, or stays as it is.
static void failing_allocations_while_a_flat_set_grows(void **state) {
    enum { FIRST = 10, ALL = 90 };
    sample s = family_make(&families[family_named("uniform")], NULL, 3, ALL, 4);
    paradt_points first = points_of(&s), all = first, rest = first;
    failing memory = {0, 0, 0};
    paradt_options options = {0};
    paradt_dynamic *d;
    paradt_triangulation grown, fresh;
    paradt_status status = PARADT_ERROR_MEMORY;
    (void)state;
    for (int i = 0; i < ALL; i++)
        s.x[3 * i] = 0.5;
    first.count = FIRST;
    rest.count = ALL - FIRST;
    rest.data = s.x + 3 * FIRST;
    options.allocator.alloc = failing_alloc;
    options.allocator.free = failing_free;
    options.allocator.user = &memory;
    assert_int_equal(paradt_dynamic_create(&d, &first, &options), PARADT_OK);
    for (size_t at = 1; status; at++) {
        paradt_dynamic_info info;
        memory.calls = 0;
        memory.fail_at = at;
        status = paradt_dynamic_insert_points(d, &rest, NULL);
        paradt_dynamic_get_info(d, &info);
        assert_int_equal(info.point_count, status ? FIRST : ALL);
        assert_true(!status || status == PARADT_ERROR_MEMORY);
    }
    assert_true(memory.fail_at > 5);
    memory.fail_at = 0;
    assert_int_equal(paradt_dynamic_export(d, &grown), PARADT_OK);
    assert_int_equal(paradt_triangulate(&fresh, &all, NULL), PARADT_OK);
    assert_int_equal(grown.dim, 2);
    assert_true(paradt_hash(&grown) == paradt_hash(&fresh));
    paradt_free(&grown);
    paradt_free(&fresh);
    paradt_dynamic_free(d);
    assert_int_equal(memory.live, 0);
    sample_free(&s);
}

// What finds places quickly is made before a point comes to 64 vertices or more. Without memory for it they are found all the same.
static void places_are_found_without_memory_for_starts(void **state) {
    enum { COUNT = 65 };
    sample s = family_make(&families[family_named("uniform")], NULL, 3, COUNT, 4);
    paradt_points points = points_of(&s);
    int done = 0, without = 0;
    (void)state;
    points.count = COUNT - 1;
    for (size_t at = 1; !done; at++) {
        failing memory = {0, 0, 0};
        paradt_options options = {0};
        paradt_dynamic *d;
        paradt_index id;
        options.allocator.alloc = failing_alloc;
        options.allocator.free = failing_free;
        options.allocator.user = &memory;
        assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_OK);
        memory.calls = 0;
        memory.fail_at = at;
        paradt_status status = paradt_dynamic_insert(d, s.x + 3 * (COUNT - 1), 0.0, -1, &id);
        assert_true(!status || status == PARADT_ERROR_MEMORY);
        without += !status && memory.calls >= at;
        done = memory.calls < at;
        for (int i = 0; i < COUNT - (status != PARADT_OK); i++)
            assert_int_equal(paradt_dynamic_nearest(d, s.x + 3 * i, -1), i);
        paradt_dynamic_free(d);
        assert_int_equal(memory.live, 0);
    }
    assert_true(without > 0);
    sample_free(&s);
}

static void memory_limit_is_kept(void **state) {
    (void)state;
    sample pool = family_make(&families[family_named("uniform")], NULL, 3, 4000, 4);
    paradt_options options = {0};
    paradt_status status = PARADT_OK;
    paradt_dynamic_info info;
    options.memory_limit = 5 << 18;
    game g = game_begin(&pool, 1000, &options, 2);
    for (int i = 1000; i < pool.count && !status; i++) {
        paradt_index id;
        status = paradt_dynamic_insert(g.d, pool.x + 3 * i, 0.0, -1, &id);
        if (!status)
            shadow_put(&g.s, id, pool.x + 3 * i, 0.0);
        paradt_dynamic_get_info(g.d, &info);
        assert_true(info.bytes <= options.memory_limit);
    }
    assert_int_equal(status, PARADT_ERROR_MEMORY);
    expect_canonical(g.d, &g.s, pool.name);
    game_end(&g);
    sample_free(&pool);
}

static void cancelled_batches_leave_the_set(void **state) {
    (void)state;
    sample pool = family_make(&families[family_named("uniform")], NULL, SANITIZED ? 2 : 3, 6000, 4);
    int calls = 1 << 30, dim = pool.dim;
    paradt_options options = {0};
    options.progress = cancel_later;
    options.user = &calls;
    for (int large = 0; large < 2; large++)
        for (int run = 0; run < 2 + WAYS; run++) { // all kinds, then insertion in other ways
            int kind = run < 3 ? run : 0, n = large ? 2000 : 300, cancelled = 0;
            paradt_index *ids = (paradt_index *)need((size_t)n, sizeof *ids);
            calls = 1 << 30;
            options.method = ways[run < 3 ? 0 : run - 2];
            game g = game_begin(&pool, 4000, &options, 2);
            for (int i = 0; i < n; i++)
                ids[i] = 2 * i;
            for (int after = 0;; after = 2 * after + 1) {
                calls = after;
                paradt_status status = change_once(&g, kind, pool.x + dim * 4000, NULL, ids, n);
                calls = 1 << 30;
                if (!status)
                    break;
                cancelled++;
                assert_int_equal(status, PARADT_ERROR_CANCELLED);
                expect_canonical(g.d, &g.s, pool.name);
            }
            assert_true(cancelled > 1);
            for (int i = 0; i < n; i++)
                if (kind < 2)
                    shadow_put(&g.s, ids[i], pool.x + dim * (4000 + i), 0.0);
                else
                    shadow_take(&g.s, ids[i]);
            expect_canonical(g.d, &g.s, pool.name);
            game_end(&g);
            free(ids);
        }
    sample_free(&pool);
}

static void wrong_arguments_are_refused(void **state) {
    double x[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, bad[] = {0.5, NAN, 0.5};
    paradt_points points = paradt_points_f64(x, 5, 3), flat = paradt_points_f64(x, 5, 2), two = paradt_points_f64(x, 2, 3);
    paradt_points mixed = paradt_points_f64(bad, 1, 3);
    paradt_options options = {0};
    paradt_dynamic *d = NULL;
    paradt_dynamic_info info;
    paradt_index ids[] = {1, 1}, id = 7;
    (void)state;
    assert_int_equal(paradt_dynamic_create(NULL, &points, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_create(&d, NULL, NULL), PARADT_ERROR_ARGUMENT);
    assert_null(d);
    options.flags = PARADT_FACETS;
    assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_ERROR_ARGUMENT);
    options.flags = 0;
    options.method = PARADT_INCODE;
    assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_create(&d, &mixed, NULL), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_dynamic_insert(NULL, x, 0.0, -1, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_insert(d, NULL, 0.0, -1, &id), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_insert(d, x, 1.0, -1, &id), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_insert(d, bad, 0.0, -1, &id), PARADT_ERROR_NOT_FINITE);
    assert_int_equal(paradt_dynamic_insert_points(d, &flat, NULL), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_remove(d, -1), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_remove(d, 5), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_remove_points(d, ids, 2), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_move_points(d, ids, &two), PARADT_ERROR_ARGUMENT);
    assert_int_equal(paradt_dynamic_move(d, 3, bad, 0.0), PARADT_ERROR_NOT_FINITE);
    paradt_dynamic_get_info(d, &info);
    assert_true(info.point_count == 5 && info.error_text != NULL && info.error_point == 0);
    assert_int_equal(id, 7);
    assert_int_equal(paradt_dynamic_remove_points(d, NULL, 0), PARADT_OK);
    assert_int_equal(paradt_dynamic_insert(d, x, 0.0, 1 << 30, &id), PARADT_OK);
    assert_int_equal(paradt_dynamic_representative(d, id), 0);
    assert_int_equal(paradt_dynamic_representative(d, 100), -2);
    assert_null(paradt_dynamic_point(d, -1, NULL));
    paradt_dynamic_free(d);
    paradt_dynamic_free(NULL);
}

// --- what changed

// The cells by their numbers, as who follows updates has them
typedef struct mirror {
    int room, corners;
    paradt_index *rows; // [room][corners] -1: there is no such cell
} mirror;

static void mirror_put(mirror *m, paradt_index number, const paradt_index *row) {
    for (; (int)number >= m->room; m->room++) {
        m->rows = (paradt_index *)realloc(m->rows, sizeof *row * (size_t)((m->room + 1) * m->corners));
        assert_non_null(m->rows);
        m->rows[m->room * m->corners] = -1;
    }
    memcpy(m->rows + (int)number * m->corners, row, sizeof *row * (size_t)m->corners);
}

static void mirror_all(mirror *m, const paradt_dynamic *d) {
    paradt_dynamic_info info;
    paradt_index row[PARADT_MAX_DIM + 1];
    paradt_dynamic_get_info(d, &info);
    free(m->rows);
    m->rows = NULL;
    m->room = 0;
    m->corners = info.dim + 1;
    for (paradt_index number = 0; number < (paradt_index)info.cell_end; number++)
        if (paradt_dynamic_cell(d, number, row, NULL))
            mirror_put(m, number, row);
}

static void updates_tell_what_changed(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (int w = 0; w < 3; w++) {
            sample pool = family_make(&families[family_named("lattice")], &weightings[w], dim, points_in[dim], 4);
            game g = game_begin(&pool, pool.count / 2, NULL, 2);
            mirror m = {0, 0, NULL};
            mirror_all(&m, g.d);
            for (int step = 0; step < 300; step++) {
                paradt_dynamic_update u;
                paradt_dynamic_info info;
                paradt_index row[PARADT_MAX_DIM + 1];
                size_t cells = 0;
                game_step(&g, pool.count / 2);
                paradt_dynamic_get_update(g.d, &u);
                paradt_dynamic_get_info(g.d, &info);
                if (u.rebuilt) {
                    mirror_all(&m, g.d);
                    continue;
                }
                assert_int_equal(u.dim_before, info.dim);
                for (size_t i = 0; i < u.killed_count; i++) {
                    paradt_index *was = m.rows + (int)u.killed[i] * m.corners;
                    assert_true((int)u.killed[i] < m.room && *was >= 0);
                    *was = -1;
                }
                for (size_t i = 0; i < u.made_count; i++) {
                    assert_true((int)u.made[i] >= m.room || m.rows[(int)u.made[i] * m.corners] < 0);
                    assert_true(paradt_dynamic_cell(g.d, u.made[i], row, NULL));
                    mirror_put(&m, u.made[i], row);
                }
                for (int number = 0; number < m.room || number < (int)info.cell_end; number++) {
                    int is = paradt_dynamic_cell(g.d, number, row, NULL), was = number < m.room && m.rows[number * m.corners] >= 0;
                    assert_int_equal(is, was);
                    cells += (size_t)is;
                }
                assert_int_equal(cells, info.cell_count);
            }
            free(m.rows);
            game_end(&g);
            sample_free(&pool);
        }
}

// Places are found by hints and without them; the nearest is that of all points.
static void places_are_found(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++) {
        sample pool = family_make(&families[family_named("lattice")], NULL, dim, 4 * points_in[dim], 4);
        game g = game_begin(&pool, pool.count / 2, NULL, 2);
        for (int step = 0; step < 400; step++) {
            double x[CELLS_MAX_DIM], w, best = 1e300;
            paradt_index hint = step % 2 ? shadow_any(&g.s, &g.seed) : -1, vertices[PARADT_MAX_DIM + 1], nearest;
            game_step(&g, pool.count / 2);
            if (g.s.count < 2 * dim)
                continue;
            game_point(&g, x, &w);
            paradt_location at = paradt_dynamic_locate(g.d, x, hint);
            assert_true(paradt_dynamic_cell(g.d, at.cell, vertices, NULL));
            nearest = paradt_dynamic_nearest(g.d, x, hint);
            for (int i = 0; i < g.s.ids; i++) {
                double distance = 0.0;
                for (int k = 0; k < dim; k++)
                    distance += (g.s.x[i * dim + k] - x[k]) * (g.s.x[i * dim + k] - x[k]);
                if (g.s.there[i] && distance < best)
                    best = distance;
            }
            for (int k = 0; k < dim; k++)
                best -= (g.s.x[nearest * dim + k] - x[k]) * (g.s.x[nearest * dim + k] - x[k]);
            assert_true(fabs(best) < 1e-9);
            if (at.face && !(at.face & (at.face - 1))) // on a vertex
                for (int i = 0; i <= dim; i++)
                    if (at.face >> i & 1)
                        assert_memory_equal(g.s.x + vertices[i] * dim, x, sizeof(double) * (size_t)dim);
        }
        game_end(&g);
        sample_free(&pool);
    }
}

// Of equally near vertices the lexicographically smallest is the nearest: places halfway between those of a lattice that has
// lost some of its points have up to 2^dim.
static void of_equally_near_vertices_the_first_is_found(void **state) {
    static const int sides[] = {0, 0, 9, 5, 3};
    (void)state;
    for (int dim = 2; dim <= 4; dim++) {
        double points_at[125 * 4], x[4];
        char there[125];
        int side = sides[dim], count = 1, places = 1;
        uint64_t seed = 11;
        paradt_dynamic *d;
        for (int k = 0; k < dim; k++)
            count *= side, places *= 2 * side - 1;
        for (int i = 0; i < count; i++)
            for (int k = 0, rest = i; k < dim; k++, rest /= side)
                points_at[i * dim + k] = rest % side;
        memset(there, 1, sizeof there);
        paradt_points points = paradt_points_f64(points_at, (size_t)count, (size_t)dim);
        assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
        for (int lost = 0; lost <= count / 4; lost++) {
            int gone = random_below(&seed, count), nearest = -1;
            double least = 1e300;
            for (int place = random_below(&seed, 7); place < places; place += lost ? 7 : 1, least = 1e300) {
                for (int k = 0, rest = place; k < dim; k++, rest /= 2 * side - 1)
                    x[k] = 0.5 * (rest % (2 * side - 1));
                for (int i = 0; i < count; i++) {
                    double distance = 0;
                    int first = 0;
                    for (int k = 0; k < dim; k++) {
                        double a = points_at[i * dim + k], b = points_at[(nearest < 0 ? 0 : nearest) * dim + k];
                        distance += (a - x[k]) * (a - x[k]);
                        if (!first)
                            first = (a < b) - (a > b);
                    }
                    if (there[i] && (distance < least || (distance == least && first > 0)))
                        least = distance, nearest = i;
                }
                assert_int_equal(paradt_dynamic_nearest(d, x, -1), nearest);
            }
            if (there[gone])
                assert_int_equal(paradt_dynamic_remove(d, gone), PARADT_OK);
            there[gone] = 0;
        }
        paradt_dynamic_free(d);
    }
}

// A set that nothing has changed knows where to start, too: else a search would go through the set from where it was last.
static void places_are_found_soon_in_a_new_set(void **state) {
    enum { COUNT = SANITIZED ? 10000 : 40000, QUERIES = 1000 };
    sample s = family_make(&families[family_named("uniform")], NULL, 2, COUNT, 1);
    paradt_points points = paradt_points_f64(s.x, (size_t)s.count, 2);
    uint64_t seed = 3;
    double seconds[2];
    paradt_dynamic *d;
    (void)state;
    assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
    for (int turn = 0; turn < 2; turn++) {
        clock_t begin = clock();
        for (int i = 0; i < QUERIES; i++) {
            int at = random_below(&seed, s.count), other = random_below(&seed, s.count);
            double x[2] = {s.x[2 * at], s.x[2 * other + 1]};
            assert_true(paradt_dynamic_locate(d, x, -1).cell >= 0);
        }
        seconds[turn] = (double)(clock() - begin) / CLOCKS_PER_SEC;
        if (!turn) // makes the starts that all later changes have
            assert_int_equal(paradt_dynamic_insert(d, (const double[2]){0.3, 0.7}, 0, -1, NULL), PARADT_OK);
    }
    if (seconds[0] > 6 * seconds[1] + 0.001)
        fail_msg("%g s in the new set, %g s after a change", seconds[0], seconds[1]);
    paradt_dynamic_free(d);
    sample_free(&s);
}

// A walk may begin outside, at the ghost of a hull facet that the place is on.
static void vertices_on_the_hull_are_found_from_anywhere(void **state) {
    static const double x[] = {1, -0x1.4p504, 0x1p501, -0x1p500, 1, 0};
    paradt_points points = paradt_points_f64(x, 3, 2);
    paradt_dynamic *d;
    (void)state;
    assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
    for (int turn = 0; turn < 2; turn++) { // in the second the set's hint is a ghost
        for (int i = 0; i < 3; i++)
            for (paradt_index hint = -1; hint < 3; hint++) {
                paradt_location at = paradt_dynamic_locate(d, x + 2 * i, hint);
                paradt_index v[3];
                assert_true(paradt_dynamic_cell(d, at.cell, v, NULL));
                for (int j = 0; j < 3; j++)
                    assert_int_equal(at.face >> j & 1, v[j] == i);
            }
        assert_int_equal(paradt_dynamic_move(d, 0, x, 0), PARADT_OK);
    }
    paradt_dynamic_free(d);
}

// In a batch points come to the places of vertices, for which they stand then, before these vertices' cells die.
// A short move, by which no other facet ceases to be locally regular: the cell at the hull turns over.
static void a_short_move_over_the_hull_changes_the_cells(void **state) {
    double x[] = {0, 0, 1, 0, 0.5, 0x1p-10, 0.5, 2};
    const double out[] = {0.5, -0x1p-10};
    paradt_points points = paradt_points_f64(x, 4, 2);
    paradt_dynamic *d;
    paradt_triangulation moved, anew;
    (void)state;
    assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_dynamic_move(d, 2, out, 0), PARADT_OK);
    assert_int_equal(paradt_dynamic_export(d, &moved), PARADT_OK);
    memcpy(x + 4, out, sizeof out);
    assert_int_equal(paradt_triangulate(&anew, &points, NULL), PARADT_OK);
    assert_int_equal(moved.cell_count, 2);
    assert_true(paradt_hash(&moved) == paradt_hash(&anew));
    paradt_free(&anew);
    paradt_free(&moved);
    paradt_dynamic_free(d);
}

static void killed_cells_have_the_ids_that_they_had(void **state) {
    static const double x[] = {9, 9, 0, 0, 4, 0, 0, 4}, more[] = {0, 0, 0, 0, 1, 1, 1, 1};
    paradt_points points = paradt_points_f64(x, 4, 2), come = paradt_points_f64(more, 4, 2);
    paradt_dynamic *d;
    paradt_dynamic_update u;
    (void)state;
    assert_int_equal(paradt_dynamic_create(&d, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_dynamic_remove(d, 0), PARADT_OK); // its id is that of the first to come
    assert_int_equal(paradt_dynamic_insert_points(d, &come, NULL), PARADT_OK);
    paradt_dynamic_get_update(d, &u);
    assert_int_equal(paradt_dynamic_representative(d, 1), 0);
    if (!u.rebuilt)
        for (size_t i = 0; i < 3 * u.killed_count; i++)
            assert_true(u.killed_vertices[i] >= 1 && u.killed_vertices[i] <= 3);
    paradt_dynamic_free(d);
}

static int progress_never_falls(void *user, double fraction) {
    double *last = (double *)user;
    assert_true(fraction >= *last && fraction <= 1);
    *last = fraction;
    return 0;
}

// Where the first point is hidden its place is searched for after the triangulation has been made.
static void progress_of_creating_never_falls(void **state) {
    (void)state;
    for (uint64_t seed = 0; seed < 40; seed++) {
        sample s = family_make(&families[family_named("lattice")], &weightings[2], 2, 50, seed);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        paradt_dynamic *d;
        double last = 0;
        options.progress = progress_never_falls;
        options.user = &last;
        assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_OK);
        paradt_dynamic_free(d);
        sample_free(&s);
    }
}

// A batch ends with 1. One whose last points leave the plane of the others is given up when they come, and the set made anew.
static void progress_of_a_batch_never_falls(void **state) {
    enum { BEFORE = 3000, BATCH = 300 };
    (void)state;
    for (int leave = 0; leave < 2; leave++) {
        sample s = family_make(&families[family_named("uniform")], NULL, 3, BEFORE + BATCH, 1);
        paradt_options options = {0};
        paradt_dynamic_info info;
        paradt_dynamic *d;
        double last = 0;
        for (int i = 0; i < s.count; i++)
            s.x[3 * i + 2] = leave && i >= BEFORE && s.x[3 * i] > 0.9 && s.x[3 * i + 1] > 0.9;
        paradt_points points = paradt_points_f64(s.x, BEFORE, 3), batch = paradt_points_f64(s.x + 3 * BEFORE, BATCH, 3);
        options.progress = progress_never_falls;
        options.user = &last;
        assert_int_equal(paradt_dynamic_create(&d, &points, &options), PARADT_OK);
        last = 0;
        assert_int_equal(paradt_dynamic_insert_points(d, &batch, NULL), PARADT_OK);
        paradt_dynamic_get_info(d, &info);
        assert_int_equal(info.dim, 2 + leave);
        assert_true(last >= 1);
        paradt_dynamic_free(d);
        sample_free(&s);
    }
}

// Many changes in a row; SOAK says how many.
static void soak(void **state) {
    const char *wanted = getenv("SOAK");
    long steps = wanted ? atol(wanted) : SANITIZED ? 5000 : 100000;
    static const char *const names[] = {"uniform", "lattice", "duplicates", "sphere"};
    (void)state;
    for (int run = 0; run < 8; run++) {
        int dim = 2 + run % 2;
        sample pool = family_make(&families[family_named(names[run / 2])], &weightings[run % 3 == 2 ? 3 : 0], dim, 2000, 4);
        game g = game_begin(&pool, 1000, NULL, (uint64_t)run);
        for (long step = 0; step < steps / 8; step++) {
            game_step(&g, 1000);
            if (step % (steps / 80) == 0)
                expect_canonical(g.d, &g.s, pool.name);
        }
        expect_canonical(g.d, &g.s, pool.name);
        game_end(&g);
        sample_free(&pool);
    }
}

int main(void) {
    static struct CMUnitTest tests[3 * FAMILY_COUNT + 25];
    static const char *const some[] = {"uniform", "lattice", "duplicates", "axis plane", "line"};
    size_t count = 0;
    for (int f = 0; f < FAMILY_COUNT; f++)
        tests[count++] = named_test(changed_is_new, (void *)(intptr_t)f, "changed_is_new_%s", families[f].name);
    for (size_t i = 0; i < sizeof some / sizeof *some; i++)
        tests[count++] = named_test(failing_allocations_leave_the_set, (void *)(intptr_t)family_named(some[i]),
                                    "failing_allocations_leave_the_set_%s", some[i]);
    for (int f = 0; f < FAMILY_COUNT; f++)
        tests[count++] = named_test(located_by_what_was_is_new, (void *)(intptr_t)f, "located_by_what_was_is_new_%s",
                                    families[f].name);
    tests[count++] = named_test(large_stars_are_whole, NULL, "large_stars_are_whole");
    tests[count++] = named_test(located_by_what_was_stays, NULL, "located_by_what_was_stays");
    tests[count++] = named_test(located_by_what_was_goes_on, NULL, "located_by_what_was_goes_on");
    tests[count++] = named_test(failing_allocations_while_creating, NULL, "failing_allocations_while_creating");
    tests[count++] = named_test(dimension_rises_and_falls, NULL, "dimension_rises_and_falls");
    tests[count++] = named_test(range_grows, NULL, "range_grows");
    tests[count++] = named_test(many_neighbours_take_no_square, NULL, "many_neighbours_take_no_square");
    tests[count++] = named_test(every_way_of_creating_leads_on, NULL, "every_way_of_creating_leads_on");
    tests[count++] = named_test(a_summit_above_a_flat_goes_and_comes, NULL, "a_summit_above_a_flat_goes_and_comes");
    tests[count++] = named_test(the_nearest_of_many_neighbours_is_found, NULL, "the_nearest_of_many_neighbours_is_found");
    tests[count++] = named_test(a_set_that_grows_holds_as_much_by_malloc_as_by_an_allocator, NULL, "a_set_that_grows_holds_as_much_by_malloc_as_by_an_allocator");
    tests[count++] = named_test(failing_exports_leave_nothing, NULL, "failing_exports_leave_nothing");
    tests[count++] = named_test(failing_allocations_while_a_flat_set_grows, NULL, "failing_allocations_while_a_flat_set_grows");
    tests[count++] = named_test(places_are_found_without_memory_for_starts, NULL, "places_are_found_without_memory_for_starts");
    tests[count++] = named_test(memory_limit_is_kept, NULL, "memory_limit_is_kept");
    tests[count++] = named_test(cancelled_batches_leave_the_set, NULL, "cancelled_batches_leave_the_set");
    tests[count++] = named_test(wrong_arguments_are_refused, NULL, "wrong_arguments_are_refused");
    tests[count++] = named_test(updates_tell_what_changed, NULL, "updates_tell_what_changed");
    tests[count++] = named_test(places_are_found, NULL, "places_are_found");
    tests[count++] = named_test(of_equally_near_vertices_the_first_is_found, NULL, "of_equally_near_vertices_the_first_is_found");
    tests[count++] = named_test(places_are_found_soon_in_a_new_set, NULL, "places_are_found_soon_in_a_new_set");
    tests[count++] = named_test(vertices_on_the_hull_are_found_from_anywhere, NULL,
                                "vertices_on_the_hull_are_found_from_anywhere");
    tests[count++] = named_test(a_short_move_over_the_hull_changes_the_cells, NULL,
                                "a_short_move_over_the_hull_changes_the_cells");
    tests[count++] = named_test(killed_cells_have_the_ids_that_they_had, NULL, "killed_cells_have_the_ids_that_they_had");
    tests[count++] = named_test(progress_of_creating_never_falls, NULL, "progress_of_creating_never_falls");
    tests[count++] = named_test(progress_of_a_batch_never_falls, NULL, "progress_of_a_batch_never_falls");
    tests[count++] = named_test(soak, NULL, "soak");
    return run_named_tests("dynamic", tests, count);
}
