// Any bytes are decoded to points in 2 to 5 dimensions (fuzz.h says how), repeated on a lattice so that regions have something
// to divide, and to a call with options: a method, regions, a partition, tasks run in some order or on threads, flags, a limit
// of memory, an allocation that fails, and a call of progress that cancels. Then
//     - the status has to say what happened: MEMORY after a failed allocation or at the limit, CANCELLED after a cancel
//     - after an error the result has to be empty, and nothing may be held
//     - without one it has to be that of an undivided call without limits
//
// Behind the header of the points, of which in->spoil has the call in its bits 0-2, the repetitions in bits 3-5, and the way
// that tasks run in bits 6-7, come four bytes, and then the points:
//     0  bits 0-2: the method; bits 3-4: flags
//     1  0-199: the number of the allocation that fails, and so on in steps of three; 200 and more: none fails
//     2  0: no limit; else it is so many 256ths of twice what an unlimited call holds
//     3  0-63: the call of progress that cancels; else none does
#include "fuzz.h"

#include <pthread.h>

enum { MOST_REPEATED = 512, CALLS = 8 };
enum { TRIANGULATE, TRIANGULATE_TOO, REPAIR, HULL, VORONOI, LOCATOR, DYNAMIC, CHECK };

typedef struct surroundings {
    account blocks;
    pthread_mutex_t lock;
    int way;       // how tasks run: 0: in turn, 1: backwards, 2: odd ones first, 3: on two threads
    int progress;  // calls so far
    int cancel_at; // number of the call that cancels; -1: none
    int cancelled;
    int several; // 1: what is done is more than one call, each with a progress of its own
    double fraction;
} surroundings;

static void *locked_alloc(void *user, size_t size) {
    surroundings *s = (surroundings *)user;
    void *memory;
    pthread_mutex_lock(&s->lock);
    memory = failing_alloc(&s->blocks, size);
    pthread_mutex_unlock(&s->lock);
    return memory;
}

static void locked_free(void *user, void *memory) {
    surroundings *s = (surroundings *)user;
    pthread_mutex_lock(&s->lock);
    failing_free(&s->blocks, memory);
    pthread_mutex_unlock(&s->lock);
}

static int progress(void *user, double fraction) {
    surroundings *s = (surroundings *)user;
    if (!((s->several || fraction >= s->fraction) && fraction >= 0 && fraction <= 1))
        fail("progress", "it falls, or is more than 1");
    s->fraction = fraction;
    s->cancelled |= s->progress == s->cancel_at;
    return s->progress++ == s->cancel_at;
}

typedef struct half {
    void (*task)(void *context, size_t index);
    void *context;
    size_t begin, count;
} half;

static void *run_half(void *argument) {
    half *h = (half *)argument;
    size_t i;
    for (i = h->begin; i < h->count; i += 2)
        h->task(h->context, i);
    return NULL;
}

static void parallel_for(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    surroundings *s = (surroundings *)user;
    half odd = {task, context, 1, count}, even = {task, context, 0, count};
    pthread_t thread;
    size_t i;
    if (s->way < 2) {
        for (i = 0; i < count; i++)
            task(context, s->way ? count - 1 - i : i);
    } else if (s->way == 2 || pthread_create(&thread, NULL, run_half, &odd)) {
        run_half(&odd);
        run_half(&even);
    } else {
        run_half(&even);
        pthread_join(thread, NULL);
    }
}

typedef struct repeated {
    double x[MOST_REPEATED * MAX_DIM], w[MOST_REPEATED];
    paradt_points points;
} repeated;

// Repeats points, each time moved by the difference of two of them. In four dimensions diagrams cost more than anything else.
static void repeat(repeated *r, const decoded *in, int times, int which) {
    static const int most[MAX_DIM + 1] = {0, 0, MOST_REPEATED, MOST_REPEATED / 2, 40, 20};
    size_t dim = (size_t)in->points.dim, n = in->points.count, i, k;
    size_t limit = (size_t)room(most, in->points.dim, in->choice, 0);
    if (in->far_apart && limit > 2 * n)
        limit = 2 * n;
    if (which == VORONOI && dim > 3)
        limit = 8;
    r->points = in->points;
    r->points.data = r->x;
    r->points.weights = in->points.weights ? r->w : NULL;
    r->points.count = n * (size_t)times < limit ? n * (size_t)times : limit;
    for (i = 0; i < r->points.count; i++) {
        size_t round = i / n, from = round % n, to = (round * round + 1) % n;
        r->w[i] = in->w[i % n];
        for (k = 0; k < dim; k++) {
            double step = in->x[to * dim + k] - in->x[from * dim + k];
            double moved = in->x[i % n * dim + k] + (double)round * step;
            r->x[i * dim + k] = round && is_finite(moved) ? moved : in->x[i % n * dim + k];
        }
    }
}

// What a call gave: its hash, and whether it is empty as after an error
typedef struct outcome {
    paradt_status status;
    uint64_t hash;
    uint64_t peak;
    int empty;
} outcome;

static uint64_t hash_bytes(const void *data, size_t size) {
    const unsigned char *at = (const unsigned char *)data;
    uint64_t hash = size;
    size_t i;
    for (i = 0; i < size && data; i++)
        hash = (hash ^ at[i]) * 0x9e3779b97f4a7c15u;
    return hash;
}

// One of the calls. t: the triangulation of the points, without neighbours as facets
static outcome call(int which, const paradt_triangulation *t, const paradt_points *points, const paradt_options *options) {
    outcome o = {PARADT_OK, 0, 0, 1};
    memset(&o, 0, sizeof o);
    if (which == TRIANGULATE || which == TRIANGULATE_TOO) {
        paradt_triangulation u;
        o.status = paradt_triangulate(&u, points, options);
        o.hash = paradt_hash(&u);
        o.empty = u.dim == -1 && !u.cells && !u.neighbors && !u.representative && !u.cell_count;
        o.peak = u.stats.peak_bytes;
        paradt_free(&u);
    } else if (which == HULL) {
        paradt_hull hull;
        o.status = paradt_hull_compute(&hull, points, options);
        o.hash = paradt_hull_hash(&hull);
        o.empty = hull.dim == -1 && !hull.facets && !hull.neighbors && !hull.plane && !hull.vertices;
        paradt_hull_free(&hull);
    } else if (which == VORONOI) {
        paradt_voronoi v;
        paradt_voronoi_request request;
        memset(&request, 0, sizeof request);
        request.outputs = points->dim < 4 ? 63 : 1;
        o.status = paradt_voronoi_compute(&v, t, points, &request, options);
        o.hash = hash_bytes(v.volumes, v.cell_count * sizeof(double)) ^
                 hash_bytes(v.sides, 2 * v.face_count * sizeof(paradt_index));
        o.empty = v.dim == -1 && !v.volumes && !v.unbounded && !v.sides && !v.polygons && !v.vertices;
        paradt_voronoi_free(&v);
    } else if (which == LOCATOR) {
        paradt_locator *l;
        paradt_index nearest[MOST_REPEATED];
        o.status = paradt_locator_create(&l, t, points, options);
        o.empty = !l;
        if (!o.status) {
            o.status = paradt_nearest(l, points, nearest, options);
            o.empty = 1; // of the nearest points nothing is kept
        }
        if (!o.status)
            o.hash = hash_bytes(nearest, points->count * sizeof *nearest);
        paradt_locator_free(l);
    } else if (which == DYNAMIC) {
        paradt_dynamic *d;
        paradt_triangulation u;
        o.status = paradt_dynamic_create(&d, points, options);
        o.empty = !d;
        if (!o.status) {
            o.status = paradt_dynamic_export(d, &u);
            o.hash = paradt_hash(&u);
            o.empty = u.dim == -1 && !u.cells && !u.neighbors && !u.representative && !u.cell_count;
            paradt_free(&u);
        }
        paradt_dynamic_free(d);
    } else if (which == CHECK) {
        o.status = paradt_check(t, points, options, NULL);
    } else { // REPAIR
        paradt_triangulation u;
        o.status = paradt_triangulate(&u, points, options);
        if (!o.status)
            o.status = paradt_repair(&u, points, options, NULL);
        o.hash = paradt_hash(&u);
        o.empty = u.dim == -1 && !u.cells && !u.neighbors && !u.representative && !u.cell_count;
        paradt_free(&u);
    }
    return o;
}

// Which options the call takes
static void fit_options(paradt_options *options, int which, int bits) {
    options->method = (paradt_method)((bits & 7) % PARADT_METHOD_COUNT);
    if (which == TRIANGULATE || which == TRIANGULATE_TOO)
        options->flags = (bits >> 3 & 3) % 3; // both would be an error
    if (which == DYNAMIC)
        options->method = PARADT_AUTO;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const int most_points[MAX_DIM + 1] = {0, 0, 64, 48, 16, 10};
    static repeated r;
    surroundings s;
    uint8_t rest[4] = {0, 255, 0, 255};
    source b = {data, size};
    decoded in;
    paradt_options plain, options;
    paradt_triangulation t;
    outcome expected, found;
    int which, limited;
    if (size < 9)
        return 0;
    memcpy(rest, data + 5, 4);
    { // the points are behind the four bytes
        static uint8_t joined[1 << 12];
        size_t length = size - 4 < sizeof joined ? size - 4 : sizeof joined;
        memcpy(joined, data, 5);
        memcpy(joined + 5, data + 9, length - 5);
        b.data = joined;
        b.left = length;
        decode(&in, &b, most_points);
    }
    if (in.first_bad >= 0 || !in.points.count)
        return 0;
    which = in.spoil & 7;
    if (which == VORONOI && in.points.dim > 4) // volumes take too long there
        which = TRIANGULATE;
    repeat(&r, &in, 1 + (in.spoil >> 3 & 7), which);
    if (which == HULL)
        r.points.weights = NULL;
    memset(&plain, 0, sizeof plain);
    memset(&t, 0, sizeof t);
    if (which == VORONOI || which == LOCATOR || which == CHECK)
        expect_ok(paradt_triangulate(&t, &r.points, NULL), "triangulation");
    fit_options(&plain, which, rest[0]);
    expected = call(which, &t, &r.points, &plain);
    expect_ok(expected.status, "undivided");

    options = plain;
    memset(&s, 0, sizeof s);
    pthread_mutex_init(&s.lock, NULL);
    s.way = in.spoil >> 6;
    s.cancel_at = rest[3] < 64 ? rest[3] : -1;
    s.blocks.fail_at = rest[1] < 200 ? rest[1] * (rest[1] < 60 ? 1 : 3) : -1;
    options.regions = in.regions;
    options.partition = in.partition;
    options.parallel_for = parallel_for;
    options.progress = progress;
    options.user = &s;
    options.allocator.alloc = locked_alloc;
    options.allocator.free = locked_free;
    options.allocator.user = &s;
    options.memory_limit = rest[2] ? (size_t)(expected.peak ? expected.peak : 60000) * 2 * rest[2] / 256 : 0;
    limited = options.memory_limit != 0;
    s.several = which == REPAIR || which == LOCATOR;
    found = call(which, &t, &r.points, &options);
    if (found.status == PARADT_ERROR_MEMORY && !limited && !has_failed(&s.blocks))
        fail("status", "it says that memory lacked, which did not");
    if (found.status == PARADT_ERROR_CANCELLED && !s.cancelled)
        fail("status", "it says cancelled, and nobody did");
    if (!found.status && s.cancelled)
        fail("status", "it was cancelled and does not say so");
    if (found.status && found.status != PARADT_ERROR_MEMORY && found.status != PARADT_ERROR_CANCELLED)
        fail("status", paradt_status_string(found.status));
    if (found.status && which != CHECK && which != REPAIR && !found.empty) // repairing may leave what there was
        fail("error", "the result is not empty");
    if (!found.status && found.hash != expected.hash)
        fail("regions", "the result is another");
    if (limited && found.peak > options.memory_limit)
        fail("memory", "more was held than the limit");
    if (s.blocks.held)
        fail("memory", "it was leaked");
    pthread_mutex_destroy(&s.lock);
    paradt_free(&t);
    return 0;
}
