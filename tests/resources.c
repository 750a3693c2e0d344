// Memory, cancelling and side effects: every allocation may fail, every call of progress may cancel, the memory limit is kept, all
// memory comes from the caller's allocator and goes back to it, and nothing else in the process changes.

#include "harness.h"

#include <errno.h>
#include <fenv.h>
#include <pthread.h>
#if defined(__linux__)
#include <sys/mman.h>
#endif

// --- what the library calls instead of malloc and its relatives (see the Makefile)

// Counts calls, which may come only when there is no allocator.
static int direct_allocations;

void *watched_malloc(size_t size);
void *watched_malloc(size_t size) {
    direct_allocations++;
    return malloc(size);
}

void *watched_realloc(void *memory, size_t size);
void *watched_realloc(void *memory, size_t size) {
    direct_allocations++;
    return realloc(memory, size);
}

void *watched_calloc(size_t count, size_t size);
void *watched_calloc(size_t count, size_t size) {
    direct_allocations++;
    return calloc(count, size);
}

// --- an allocator that keeps books and can refuse requests

typedef struct books {
    pthread_mutex_t lock;
    size_t calls;    // of alloc, refused ones included
    size_t fail_at;  // the number of the first refused call; 0: none
    int fail_after;  // 1: all later ones too
    size_t live;     // blocks
    size_t bytes, peak;
    int refused;
    int faults; // blocks freed that were not allocated, sizes of 0
    struct header *first; // of the blocks
} books;

enum { BLOCK_MARK = 0x5ca1ab1e, HEADER = 32 };
typedef struct header {
    size_t size;
    size_t mark;
    struct header *before, *next;
} header;

static void *books_alloc(void *user, size_t size) {
    books *b = (books *)user;
    char *block = NULL;
    pthread_mutex_lock(&b->lock);
    b->calls++;
    b->faults += size == 0;
    if (b->fail_at && (b->calls == b->fail_at || (b->fail_after && b->calls > b->fail_at)))
        b->refused++;
    else if ((block = (char *)malloc(size + HEADER)) != NULL) {
        header *h = (header *)(void *)block;
        memset(block, 0xcd, size + HEADER); // new memory may contain anything
        h->size = size;
        h->mark = BLOCK_MARK;
        h->before = NULL;
        h->next = b->first;
        if (b->first)
            b->first->before = h;
        b->first = h;
        b->live++;
        b->bytes += size;
        if (b->bytes > b->peak)
            b->peak = b->bytes;
    }
    pthread_mutex_unlock(&b->lock);
    return block ? block + HEADER : NULL;
}

static void books_free(void *user, void *memory) {
    books *b = (books *)user;
    header *h = (header *)(void *)((char *)memory - HEADER);
    if (!memory)
        return;
    pthread_mutex_lock(&b->lock);
    if (h->mark != BLOCK_MARK)
        b->faults++;
    else {
        b->live--;
        b->bytes -= h->size;
        if (h->next)
            h->next->before = h->before;
        if (h->before)
            h->before->next = h->next;
        else
            b->first = h->next;
        memset(h, 0xdd, h->size + HEADER);
        free(h);
    }
    pthread_mutex_unlock(&b->lock);
}

static books books_open(void) {
    books b = {PTHREAD_MUTEX_INITIALIZER, 0, 0, 0, 0, 0, 0, 0, 0, NULL};
    return b;
}

static void keep_books(paradt_options *options, books *b) {
    options->allocator.alloc = books_alloc;
    options->allocator.free = books_free;
    options->allocator.user = b;
}

// --- pages that are made ahead

// The books whose blocks must contain the pages; NULL: pages are not watched.
static books *watcher;
static int pages_made, pages_outside;

#if defined(__linux__)
// Counts the pages, and fails as on systems that do not know the advice.
int watched_madvise(void *address, size_t length, int advice);
int watched_madvise(void *address, size_t length, int advice) {
    const char *begin = (const char *)address;
    int inside = 0;
    if (!watcher)
        return madvise(address, length, advice);
    pthread_mutex_lock(&watcher->lock);
    for (const header *h = watcher->first; h && !inside; h = h->next) {
        const char *block = (const char *)h + HEADER;
        inside = begin >= block && begin + length <= block + h->size;
    }
    pages_made++;
    pages_outside += !inside;
    pthread_mutex_unlock(&watcher->lock);
    errno = EINVAL;
    return -1;
}
#endif

// --- the cases that the tests below go through

typedef struct scene {
    sample s;
    paradt_options options;
} scene;

static void run_on_threads(void *user, size_t count, void (*task)(void *context, size_t index), void *context);

// A paradt_parallel_for that uses the calling thread alone
static void run_in_turn(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    (void)user;
    while (count-- > 0)
        task(context, count);
}

// Sets that are large enough for DeWall to have tasks, of which those in four dimensions search for walls together
static int scene_of_walls(int number, scene *out) {
    static const struct {
        int family, weighting, dim, count, tasks;
    } sets[] = {{0, 0, 3, 150, 0}, {0, 0, 4, 140, 1}, {1, 1, 3, 150, 1},
                {5, 0, 4, 140, 1}, {1, 0, 5, 90, 1},  {0, 1, 2, 200, 1}};
    if (number >= (int)(sizeof sets / sizeof sets[0]))
        return 0;
    out->s = family_make(&families[sets[number].family], &weightings[sets[number].weighting], sets[number].dim,
                         sets[number].count, 6);
    out->options.method = PARADT_DEWALL;
    out->options.regions = 3;
    out->options.parallel_for = sets[number].tasks ? run_in_turn : NULL;
    return 1;
}

// Makes scene `number`; returns 0 when there is none. Families, weights, dimensions, methods and regions are chosen so that all
// code that allocates runs. Every second one is made, or every fourth by a sanitized program: these have all inputs, ways and
// methods, but not in all combinations.
static int next_scene(int number, scene *out) {
    static const struct {
        int family, weighting, dim, count;
    } inputs[] = {{0, 0, 3, 60}, {5, 3, 3, 50}, {17, 1, 3, 60}, {0, 2, 2, 60},   {12, 0, 3, 40},
                  {15, 1, 3, 20}, {16, 1, 3, 5}, {0, 0, 5, 14},  {9, 0, 4, 20}, {21, 0, 3, 20},
                  {5, 0, 4, 50}};
    static const struct {
        size_t regions;
        paradt_partition partition;
        int threads;
        unsigned flags;
    } ways[] = {{0, PARADT_BISECTION, 0, 0},
                {3, PARADT_BISECTION, 0, 0},
                {3, PARADT_BISECTION, 0, PARADT_NO_NEIGHBORS},
                {4, PARADT_UNIFORM, 0, 0},
                {3, PARADT_BISECTION, 1, 0}};
    enum { INPUTS = sizeof inputs / sizeof inputs[0], WAYS = sizeof ways / sizeof ways[0] };
    int each = (SANITIZED ? 6 : 2) * number;
    int input = each % INPUTS, way = each / INPUTS % WAYS, method = each / INPUTS / WAYS;
    memset(out, 0, sizeof *out);
    if (method >= PARADT_METHOD_COUNT)
        return scene_of_walls(each - INPUTS * WAYS * PARADT_METHOD_COUNT, out);
    out->s = family_make(&families[inputs[input].family], &weightings[inputs[input].weighting], inputs[input].dim,
                         inputs[input].count, 6);
    out->options.method = (paradt_method)method;
    out->options.regions = ways[way].regions;
    out->options.partition = ways[way].partition;
    out->options.parallel_for = ways[way].threads ? run_on_threads : NULL;
    out->options.flags = ways[way].flags;
    return 1;
}

typedef struct job {
    void (*task)(void *context, size_t index);
    void *context;
    size_t index;
    pthread_t thread;
} job;

static void *run_job(void *argument) {
    job *j = (job *)argument;
    j->task(j->context, j->index);
    return NULL;
}

static void run_on_threads(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    job *jobs = (job *)need(count, sizeof *jobs);
    (void)user;
    for (size_t i = 0; i < count; i++) {
        job j = {task, context, i, pthread_self()};
        jobs[i] = j;
        assert_int_equal(pthread_create(&jobs[i].thread, NULL, run_job, &jobs[i]), 0);
    }
    for (size_t i = 0; i < count; i++)
        pthread_join(jobs[i].thread, NULL);
    free(jobs);
}

static void assert_empty(const paradt_triangulation *t) {
    assert_null(t->cells);
    assert_null(t->neighbors);
    assert_null(t->representative);
    assert_int_equal(t->cell_count, 0);
    assert_int_equal(t->point_count, 0);
}

// --- memory

static void all_memory_is_the_allocators_and_goes_back(void **state) {
    scene c;
    (void)state;
    for (int number = 0; next_scene(number, &c); number++) {
        books b = books_open();
        paradt_points points = points_of(&c.s);
        paradt_triangulation t;
        keep_books(&c.options, &b);
        direct_allocations = 0;
        assert_int_equal(paradt_triangulate(&t, &points, &c.options), PARADT_OK);
        assert_true(b.calls > 0);
        // Only the result's own arrays are left: cells, neighbours, representatives.
        assert_true(b.live <= 3);
        assert_int_equal(paradt_check(&t, &points, &c.options, NULL), PARADT_OK);
        assert_true(b.live <= 3);
        paradt_free(&t);
        assert_int_equal(b.live, 0);
        assert_int_equal(b.faults, 0);
        assert_int_equal(direct_allocations, 0);
        assert_empty(&t);
        sample_free(&c.s);
    }
}

static void every_failing_allocation_is_an_error_and_leaks_nothing(void **state) {
    scene c;
    size_t tried = 0;
    (void)state;
    for (int number = 0; next_scene(number, &c); number++) {
        paradt_points points = points_of(&c.s);
        int serial = c.options.parallel_for != run_on_threads;
        // A sanitized program lets either one allocation fail or all later ones too.
        for (int after = SANITIZED ? number % 2 : 0; after < (SANITIZED ? number % 2 + 1 : 2); after++)
            for (size_t k = 1;; k += SANITIZED && k > 50 ? 3 : 1) {
                books b = books_open();
                paradt_triangulation t;
                b.fail_at = k;
                b.fail_after = after;
                keep_books(&c.options, &b);
                memset(&t, 0xa5, sizeof t);
                paradt_status status = paradt_triangulate(&t, &points, &c.options);
                if (!b.refused) {
                    // The run makes fewer than k calls. With threads, their number may vary.
                    assert_int_equal(status, PARADT_OK);
                    paradt_free(&t);
                    assert_int_equal(b.live, 0);
                    break;
                }
                if (status != PARADT_ERROR_MEMORY || b.live || b.faults) {
                    char text[256];
                    snprintf(text, sizeof text, "%s, allocation %u refused: %s, %u blocks leaked, %d faults",
                             how_text(&c.options), (unsigned)k, paradt_status_string(status), (unsigned)b.live, b.faults);
                    fail_on_sample(&c.s, text);
                }
                assert_empty(&t);
                paradt_free(&t);
                tried++;
                if (!serial && k > 200)
                    break;
            }
        sample_free(&c.s);
    }
    assert_true(tried > 1000);
}

static void the_memory_limit_is_kept(void **state) {
    scene c;
    (void)state;
    for (int number = 0; next_scene(number, &c); number++) {
        books b = books_open();
        paradt_points points = points_of(&c.s);
        paradt_triangulation t;
        uint64_t hash;
        keep_books(&c.options, &b);
        assert_int_equal(paradt_triangulate(&t, &points, &c.options), PARADT_OK);
        // The reported peak is at least what the allocator was asked for, and with one region hardly more.
        if (t.stats.peak_bytes < b.peak || (c.options.regions <= 1 && t.stats.peak_bytes > b.peak + b.peak / 4 + 4096))
            fail_on_sample(&c.s, "stats.peak_bytes is not the peak that the allocator saw");
        size_t peak = (size_t)t.stats.peak_bytes, measured = b.peak;
        hash = paradt_hash(&t);
        paradt_free(&t);
        for (int step = 1; step <= 40; step += SANITIZED ? 3 : 1) {
            size_t limit = peak * (size_t)step / 20 + 1;
            b = books_open();
            c.options.memory_limit = limit;
            paradt_status status = paradt_triangulate(&t, &points, &c.options);
            if (b.peak > limit)
                fail_on_sample(&c.s, "more memory was held than memory_limit allows");
            if (status == PARADT_OK) {
                assert_true(paradt_hash(&t) == hash);
            } else {
                assert_int_equal(status, PARADT_ERROR_MEMORY);
                assert_empty(&t);
                if (c.options.regions <= 1 && limit > peak)
                    fail_on_sample(&c.s, "a limit above stats.peak_bytes is refused");
            }
            if (status == PARADT_OK && limit < measured / 2)
                fail_on_sample(&c.s, "half the memory was enough: the limit was not looked at");
            paradt_free(&t);
            assert_int_equal(b.live, 0);
        }
        sample_free(&c.s);
    }
}

// --- progress

typedef struct reports {
    pthread_mutex_t lock;
    size_t calls, cancel_at;
    double last;
    int ordered, in_range;
} reports;

static int note_progress(void *user, double fraction) {
    reports *r = (reports *)user;
    pthread_mutex_lock(&r->lock);
    r->calls++;
    if (!(fraction >= 0 && fraction <= 1))
        r->in_range = 0;
    if (fraction < r->last)
        r->ordered = 0;
    r->last = fraction;
    int cancel = r->cancel_at && r->calls >= r->cancel_at;
    pthread_mutex_unlock(&r->lock);
    return cancel ? 7 : 0;
}

static reports reports_open(size_t cancel_at) {
    reports r = {PTHREAD_MUTEX_INITIALIZER, 0, cancel_at, 0, 1, 1};
    return r;
}

static void every_progress_call_can_cancel(void **state) {
    int reported = 0;
    (void)state;
    for (int method = 0; method < PARADT_METHOD_COUNT; method++)
        for (int way = SANITIZED ? method % 2 : 0; way < 8; way += SANITIZED ? 2 : 1) {
            sample s = family_make(&families[way % 2 ? 0 : 5], &weightings[way % 3], 2 + way % 3,
                                   way % 3 == 2 ? 400 : SANITIZED ? 2000 : 8000, 3);
            paradt_points points = points_of(&s);
            paradt_options options = {0};
            paradt_triangulation t;
            size_t calls = 0;
            options.method = (paradt_method)method;
            options.regions = way < 4 ? 0 : 3;
            options.parallel_for = way == 7 ? run_on_threads : NULL;
            options.progress = note_progress;
            for (size_t k = 0; k == 0 || k <= calls; k += 1 + calls / (SANITIZED ? 15 : 30)) {
                reports r = reports_open(k);
                books b = books_open();
                keep_books(&options, &b);
                options.user = &r;
                paradt_status status = paradt_triangulate(&t, &points, &options);
                if (!r.in_range || !r.ordered)
                    fail_on_sample(&s, "progress goes back or leaves 0..1");
                if (k == 0) {
                    assert_int_equal(status, PARADT_OK);
                    calls = r.calls;
                    if (calls == 0 && t.cell_count > 10000)
                        fail_on_sample(&s, "no progress is reported in 10,000 cells");
                    reported += calls > 1;
                } else if (r.calls >= k) {
                    assert_int_equal(status, PARADT_ERROR_CANCELLED);
                    assert_empty(&t);
                    if (!options.parallel_for && r.calls > k)
                        fail_on_sample(&s, "the work goes on after it was cancelled");
                }
                paradt_free(&t);
                assert_int_equal(b.live, 0);
            }
            sample_free(&s);
        }
    assert_true(reported > 0);
}

// The first calls of progress come while many points are read and sorted, many of them equal or near a sphere. Each can cancel.
static void reading_many_points_can_be_cancelled(void **state) {
    (void)state;
    for (int equal = 0; equal < 2; equal++) {
        sample s = family_make(&families[family_named("sphere")], NULL, 3, 70000, 3);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        size_t k;
        for (int i = 0; i < 3 * 69000 && equal; i++)
            s.x[i] = s.x[i % 3];
        options.progress = note_progress;
        for (k = 1; k < 60; k++) {
            reports r = reports_open(k);
            books b = books_open();
            paradt_triangulation t;
            keep_books(&options, &b);
            options.user = &r;
            paradt_status status = paradt_triangulate(&t, &points, &options);
            assert_int_equal(status, r.calls < k ? PARADT_OK : PARADT_ERROR_CANCELLED);
            paradt_free(&t);
            assert_true(r.ordered && r.in_range && b.live == 0 && b.faults == 0);
            if (!status)
                break;
        }
        assert_true(k > 5);
        sample_free(&s);
    }
}

// With many cells and many hidden points, walks and hash chains are long, and each phase reports progress several times.
static void a_triangulation_of_thousands_of_points_is_accepted(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++)
        for (int weighted = 0; weighted < 2; weighted++) {
            sample s = family_make(&families[0], &weightings[weighted], dim, 20000, 11);
            for (int i = 0; weighted && i < s.count; i++)
                s.w[i] *= 0.08;
            paradt_points points = points_of(&s);
            paradt_options options = {0};
            paradt_triangulation t;
            reports r = reports_open(0);
            assert_int_equal(paradt_triangulate(&t, &points, NULL), PARADT_OK);
            assert_true(weighted ? t.stats.hidden > 1000 : t.cell_count > points.count);
            options.progress = note_progress;
            options.user = &r;
            assert_int_equal(paradt_check(&t, &points, &options, NULL), PARADT_OK);
            assert_true(r.calls > 4 && r.ordered && r.in_range);
            paradt_index *neighbors = t.neighbors;
            t.neighbors = NULL;
            assert_int_equal(paradt_check(&t, &points, NULL, NULL), PARADT_OK);
            t.neighbors = neighbors;
            paradt_free(&t);
            sample_free(&s);
        }
}

// --- flags and side effects

static void without_neighbors_the_cells_are_the_same(void **state) {
    scene c;
    (void)state;
    for (int number = 0; next_scene(number, &c); number++) {
        paradt_points points = points_of(&c.s);
        paradt_triangulation with, without;
        paradt_fault fault;
        c.options.flags = 0;
        assert_int_equal(paradt_triangulate(&with, &points, &c.options), PARADT_OK);
        c.options.flags = PARADT_NO_NEIGHBORS;
        assert_int_equal(paradt_triangulate(&without, &points, &c.options), PARADT_OK);
        assert_true((with.neighbors != NULL) == (with.dim > 0)); // a single vertex has none
        assert_null(without.neighbors);
        assert_int_equal(with.cell_count, without.cell_count);
        assert_true(paradt_hash(&with) == paradt_hash(&without));
        assert_true(with.stats.hull_facets == without.stats.hull_facets);
        assert_int_equal(paradt_check(&without, &points, NULL, &fault), PARADT_OK);
        paradt_free(&with);
        paradt_free(&without);
        sample_free(&c.s);
    }
}

// Makes a slightly perturbed lattice. It has more cells than uniform points, which shows only after most points are inserted.
static sample points_of_a_shaken_lattice(int side) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, side * side * side, 1);
    for (int i = 0; i < s.count; i++) {
        const int place[3] = {i % side, i / side % side, i / side / side};
        for (int axis = 0; axis < 3; axis++)
            s.x[3 * i + axis] = place[axis] + (s.x[3 * i + axis] - 0.5) * 1e-6;
    }
    return s;
}

// Only pages within the allocator's blocks are made ahead. If the system refuses that, there is no error.
static void pages_are_made_within_blocks(void **state) {
    static const size_t regions[] = {0, 1, 2, 3};
    sample s = family_make(&families[family_named("uniform")], NULL, 3, SANITIZED ? 20000 : 100000, 1);
    paradt_points points = points_of(&s);
    (void)state;
    for (size_t i = 0; i < sizeof regions / sizeof regions[0]; i++) {
        paradt_options options = {0};
        paradt_triangulation t;
        books b = books_open();
        int status, number_after;
        keep_books(&options, &b);
        options.regions = regions[i];
        options.parallel_for = i > 1 ? run_on_threads : NULL;
        pages_made = pages_outside = 0;
        watcher = &b;
        errno = 4321;
        status = paradt_triangulate(&t, &points, &options);
        number_after = errno;
        watcher = NULL;
        assert_int_equal(status, PARADT_OK);
        assert_int_equal(number_after, 4321);
        assert_int_equal(pages_outside, 0);
#if defined(__linux__)
        assert_true(pages_made > 10);
#endif
        assert_int_equal(paradt_check(&t, &points, &options, NULL), PARADT_OK);
        paradt_free(&t);
        assert_int_equal(b.faults, 0);
    }
    sample_free(&s);
}

// Without neighbours, the links of only one region in five are held at a time. Eight regions drop a tenth of their cells.
// A lattice has fewer cells than uniform points, a perturbed one has more.
static void large_sets_take_few_bytes_a_point(void **state) {
    static const struct {
        const char *family; // NULL: a perturbed lattice
        unsigned flags;
        size_t regions, bytes;
    } cases[] = {{"uniform", 0, 0, 300}, {"uniform", PARADT_NO_NEIGHBORS, 0, 220}, {"uniform", 0, 8, 350},
                 {"lattice", 0, 0, 300}, {"lattice", PARADT_NO_NEIGHBORS, 0, 220}, {NULL, 0, 0, 300},
                 {NULL, 0, 2, 350}};
    (void)state;
    if (SANITIZED)
        skip(); // smaller sets show as much in less time
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *name = cases[i].family;
        sample s = name ? family_make(&families[family_named(name)], NULL, 3, 500000, 1)
                        : points_of_a_shaken_lattice(60);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        paradt_triangulation t;
        books b = books_open();
        keep_books(&options, &b);
        options.flags = cases[i].flags;
        options.regions = cases[i].regions;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        assert_true(t.stats.peak_bytes >= b.peak);
        if (!b.peak || b.peak > cases[i].bytes * points.count)
            fail_msg("%s, %zu regions: %zu bytes a point", name ? name : "shaken lattice", cases[i].regions,
                     b.peak / points.count);
        paradt_free(&t);
        assert_int_equal(b.live, 0);
        sample_free(&s);
    }
}

// Regions are given up on sets where their questions to other regions would take longer than everything else, with and without
// neighbours, one after another and on threads. On other sets they are kept.
static void regions_give_up_where_questions_abound(void **state) {
    static const struct {
        const char *family;
        size_t count;
        int gives_up;
    } cases[] = {{"cospherical", 3000, 1}, {"helix", 3000, 1},    {"cylinder", 3000, 1},
                 {"uniform", 3000, 0},     {"clusters", 3000, 0}, {"lattice", 3000, 0},
                 {"lattice", 32768, 0},    {"sphere", 3000, 0},   {"plummer", 3000, 0}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        sample s = family_make(&families[family_named(cases[i].family)], NULL, 3, cases[i].count, 1);
        paradt_points points = points_of(&s);
        paradt_triangulation whole;
        assert_int_equal(paradt_triangulate(&whole, &points, NULL), PARADT_OK);
        for (unsigned way = 0; way < 4; way += SANITIZED ? 3 : 1) {
            paradt_options options = {0};
            paradt_triangulation t;
            options.regions = 4;
            options.flags = way & 1 ? PARADT_NO_NEIGHBORS : 0;
            options.parallel_for = way & 2 ? run_on_threads : NULL;
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            assert_true(paradt_hash(&t) == paradt_hash(&whole));
            assert_true(t.stats.hull_facets == whole.stats.hull_facets);
            if (t.stats.regions != (cases[i].gives_up ? 1 : 4))
                fail_on_sample(&s, "the number of regions built");
            paradt_free(&t);
        }
        paradt_free(&whole);
        sample_free(&s);
    }
}

// Makes points on the curved surface of a cylinder, whose cells reach across all of it.
static sample points_of_a_cylinder(int count) {
    sample s = sample_make("surface of a cylinder", 3, count);
    uint64_t random = 1;
    for (int i = 0; i < s.count; i++) {
        double angle = 6.28318530717958648 * random_unit(&random);
        s.x[3 * i] = cos(angle);
        s.x[3 * i + 1] = sin(angle);
        s.x[3 * i + 2] = random_unit(&random);
    }
    return s;
}

// If there are enough points, a sample of them shows before anything is built that regions would be given up. An allocation that
// fails meanwhile leaks nothing.
static void regions_that_would_give_up_are_not_begun(void **state) {
    static const struct {
        const char *family;
        size_t regions;
    } cases[] = {{NULL, 1}, {"sphere", 3}, {"plummer", 3}, {"lattice", 3}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (unsigned way = 0; way < 2; way++) {
            const char *name = cases[i].family;
            sample s = name ? family_make(&families[family_named(name)], NULL, 3, 9000, 1) : points_of_a_cylinder(9000);
            paradt_points points = points_of(&s);
            paradt_options options = {0};
            paradt_triangulation whole, t;
            assert_int_equal(paradt_triangulate(&whole, &points, NULL), PARADT_OK);
            options.regions = 3;
            options.flags = way ? PARADT_NO_NEIGHBORS : 0;
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            uint64_t hash = paradt_hash(&whole);
            assert_true(paradt_hash(&t) == hash);
            if (t.stats.regions != cases[i].regions || (t.stats.grid_cells_visited > 0) != (cases[i].regions > 1))
                fail_on_sample(&s, "regions were begun, or were not");
            paradt_free(&whole);
            paradt_free(&t);
            for (size_t k = 1; i == 0 && k < 100; k += SANITIZED ? 5 : 1) {
                books b = books_open();
                b.fail_at = k;
                keep_books(&options, &b);
                if (paradt_triangulate(&t, &points, &options) == PARADT_OK) {
                    assert_true(paradt_hash(&t) == hash); // the refused memory was only needed for speed
                    assert_true(k > 20 || b.refused);
                    paradt_free(&t);
                    if (!b.refused) k = 100;
                }
                assert_true(b.live == 0 && b.faults == 0);
            }
            sample_free(&s);
        }
}

static void points_that_are_all_equal_make_one_region(void **state) {
    enum { COUNT = 100 };
    static const double x[COUNT * 5];
    (void)state;
    for (int dim = 2; dim <= 5; dim++)
        for (int method = 0; method < PARADT_METHOD_COUNT; method++) {
            paradt_points points = paradt_points_f64(x, COUNT, dim);
            paradt_options options = {0};
            paradt_triangulation t;
            options.method = (paradt_method)method;
            options.regions = 4;
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            assert_true(t.cell_count == 1 && t.stats.duplicates == COUNT - 1);
            assert_true(t.stats.regions == 1);
            paradt_free(&t);
        }
}

// Makes points of a thick wavy sheet. Many of its cells have large spheres, which touch the sheet again far away.
static sample points_of_a_sheet(int count) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, count, 1);
    for (int i = 0; i < count; i++) {
        double *x = s.x + 3 * i;
        x[2] = 0.3 * sin(6 * x[0]) * cos(5 * x[1]) + 0.01 * x[2];
    }
    return s;
}

// Near a surface the boxes alone do not show which cells are right, so regions tell each other their points.
static void regions_near_a_surface_tell_each_other(void **state) {
    sample s = points_of_a_sheet(20000);
    paradt_points points = points_of(&s);
    paradt_triangulation whole;
    (void)state;
    assert_int_equal(paradt_triangulate(&whole, &points, NULL), PARADT_OK);
    for (size_t way = 0; way < 6; way += SANITIZED ? 5 : 1) {
        paradt_options options = {0};
        paradt_triangulation t;
        options.regions = 2 + way / 2;
        options.parallel_for = way & 1 ? run_on_threads : NULL;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        assert_true(paradt_hash(&t) == paradt_hash(&whole));
        assert_true(t.stats.hull_facets == whole.stats.hull_facets);
        assert_true(t.stats.regions == options.regions);
        assert_int_equal(paradt_check(&t, &points, &options, NULL), PARADT_OK);
        paradt_free(&t);
    }
    paradt_free(&whole);
    sample_free(&s);
}

// Some of these regions have finished, and released memory of an earlier step, when others need to see their cells.
static void some_regions_of_a_lattice_tell_others(void **state) {
    enum { SIDE = 36 };
    sample s = sample_make("lattice", 3, SIDE * SIDE * SIDE);
    (void)state;
    for (int i = 0; i < s.count; i++) {
        s.x[3 * i] = i / (SIDE * SIDE);
        s.x[3 * i + 1] = i / SIDE % SIDE;
        s.x[3 * i + 2] = i % SIDE;
    }
    paradt_points points = points_of(&s);
    paradt_triangulation whole, t;
    paradt_options options = {0};
    options.regions = 4;
    options.parallel_for = run_on_threads;
    assert_int_equal(paradt_triangulate(&whole, &points, NULL), PARADT_OK);
    assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
    assert_true(paradt_hash(&t) == paradt_hash(&whole));
    assert_true(t.stats.regions == options.regions);
    paradt_free(&whole);
    paradt_free(&t);
    sample_free(&s);
}

// Regions that are built facet by facet compute few cells twice: little more than those that have two vertices on either side of
// a border.
static void regions_make_few_cells_again(void **state) {
    static const struct {
        int dim, count;
        size_t regions;
        double share;
    } cases[] = {{2, 8000, 5, 0.005}, {3, 8000, 4, 0.06}, {3, 100000, 2, 0.015}, {4, 3000, 2, 0.15}};
    (void)state;
    for (size_t i = 0; i < 2 * sizeof cases / sizeof cases[0]; i++) {
        if (SANITIZED && cases[i / 2].count > 10000)
            continue;
        sample s = family_make(&families[family_named("uniform")], NULL, cases[i / 2].dim, cases[i / 2].count, 1);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = i % 2 ? PARADT_DEWALL : PARADT_INCODE;
        options.regions = cases[i / 2].regions;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        double share = (double)t.stats.cells_recomputed / (double)t.cell_count;
        if (i % 2) // divided by its walls
            assert_int_equal(t.stats.cells_recomputed, 0);
        assert_int_equal(t.stats.regions, options.regions);
        if (share > cases[i / 2].share)
            fail_msg("%d points in %zu regions, d = %d: %.4f of the cells made again", cases[i / 2].count, options.regions,
                     cases[i / 2].dim, share);
        paradt_free(&t);
        sample_free(&s);
    }
}

// The first of two regions hears of the other's points and gives up. Then it takes in the other's points.
static void memory_may_run_out_where_regions_are_given_up(void **state) {
    sample s = points_of_a_sheet(5000);
    paradt_points points = points_of(&s);
    paradt_triangulation whole;
    size_t k = 1, tried = 0, refused = 1;
    (void)state;
    assert_int_equal(paradt_triangulate(&whole, &points, NULL), PARADT_OK);
    uint64_t hash = paradt_hash(&whole);
    paradt_free(&whole);
    for (; refused; k += 1 + k / 50, tried++) {
        paradt_options options = {0};
        paradt_triangulation t;
        books b = books_open();
        options.regions = 2;
        b.fail_at = k;
        keep_books(&options, &b);
        paradt_status status = paradt_triangulate(&t, &points, &options);
        assert_true(status == PARADT_OK || (b.refused && status == PARADT_ERROR_MEMORY));
        if (status)
            assert_empty(&t);
        else
            assert_true(t.stats.regions == 1 && paradt_hash(&t) == hash); // the refused memory was only needed for speed
        paradt_free(&t);
        assert_int_equal(b.live, 0);
        assert_int_equal(b.faults, 0);
        refused = b.refused;
    }
    assert_true(tried > 50);
    sample_free(&s);
}

// So many points in six dimensions could have a million cells, but all except the corners of a cube are hidden. Memory for the
// expected cells is not required.
static void room_that_is_only_expected_is_not_needed(void **state) {
    enum { CORNERS = 64, COUNT = CORNERS + 1000, DIM = 6 };
    static double x[COUNT * DIM], weights[COUNT];
    paradt_points points = paradt_points_f64(x, COUNT, DIM);
    uint64_t random = 1;
    (void)state;
    points.weights = weights;
    for (int i = 0; i < COUNT; i++) {
        weights[i] = i < CORNERS ? 100.0 : 0.0;
        for (int axis = 0; axis < DIM; axis++)
            x[i * DIM + axis] = i < CORNERS ? (i >> axis & 1) * 3.0 : 1.0 + random_unit(&random);
    }
    for (int method = 0; method < PARADT_METHOD_COUNT; method += SANITIZED ? 3 : 1) {
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = (paradt_method)method;
        options.memory_limit = method == PARADT_FLIP            ? 64 << 20 // these two keep the cells that there were
                               : method == PARADT_DELAUNAY_TREE ? 20 << 20
                                                                : 8 << 20;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        assert_true(t.stats.hidden == COUNT - CORNERS && t.cell_count >= 500 && t.cell_count <= 720);
        paradt_free(&t);
    }
}

// Makes integer points on a sphere around the origin. The library measures points near a sphere from that sphere.
static sample points_exactly_on_a_sphere(int radius2) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, 3000, 1);
    int count = 0, side = (int)sqrt(radius2);
    for (int x = -side; x <= side; x++)
        for (int y = -side; y <= side; y++) {
            int rest = radius2 - x * x - y * y, z = rest < 0 ? -1 : (int)sqrt(rest);
            if (z < 0 || z * z != rest || count + 2 > s.count)
                continue;
            for (int sign = -1; sign <= (z ? 1 : -1); sign += 2, count++) {
                s.x[3 * count] = x;
                s.x[3 * count + 1] = y;
                s.x[3 * count + 2] = sign * z;
            }
        }
    s.count = count;
    return s;
}

static void regions_give_up_on_points_measured_from_a_sphere(void **state) {
    static const int radii2[] = {9425, 99449, 801125};
    (void)state;
    for (size_t i = 0; i < sizeof radii2 / sizeof radii2[0]; i++) {
        sample s = points_exactly_on_a_sphere(radii2[i]);
        paradt_points points = points_of(&s);
        paradt_triangulation whole;
        assert_true(s.count > 100);
        assert_int_equal(paradt_triangulate(&whole, &points, NULL), PARADT_OK);
        for (unsigned way = 0; way < 4; way++) {
            paradt_options options = {0};
            paradt_triangulation t;
            options.regions = 2 + way / 2 * 2;
            options.flags = way & 1 ? PARADT_NO_NEIGHBORS : 0;
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            assert_true(paradt_hash(&t) == paradt_hash(&whole));
            // Only the first set has all integer points of its sphere. With two regions, the second need not ask about most ghosts.
            if (s.count > 1000)
                assert_int_equal(t.stats.regions, i == 0 && way == 0 ? 2 : 1);
            paradt_free(&t);
        }
        paradt_free(&whole);
        sample_free(&s);
    }
}

static void errno_the_rounding_mode_and_the_input_are_left_alone(void **state) {
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    scene c;
    (void)state;
    for (int number = 0; next_scene(number, &c); number++) {
        books b = books_open();
        paradt_points points = points_of(&c.s), points_before = points;
        paradt_triangulation t;
        sample before = sample_pick(&c.s, NULL, c.s.count);
        size_t bytes = sizeof(double) * (size_t)(c.s.count * c.s.dim);
        int mode = modes[number % 4], status, number_after, mode_after;
        keep_books(&c.options, &b);
        fesetround(mode);
        errno = 4321;
        status = paradt_triangulate(&t, &points, &c.options);
        number_after = errno;
        mode_after = fegetround();
        fesetround(FE_TONEAREST);
        assert_int_equal(status, PARADT_OK);
        assert_int_equal(number_after, 4321);
        assert_int_equal(mode_after, mode);
        assert_memory_equal(before.x, c.s.x, bytes);
        if (c.s.w)
            assert_memory_equal(before.w, c.s.w, sizeof(double) * (size_t)c.s.count);
        assert_memory_equal(&points, &points_before, sizeof points);
        paradt_free(&t);
        sample_free(&before);
        sample_free(&c.s);
    }
}

typedef struct small_stack_call {
    sample s;
    paradt_options options;
    paradt_status status;
} small_stack_call;

static void *call_on_small_stack(void *argument) {
    small_stack_call *c = (small_stack_call *)argument;
    paradt_points points = points_of(&c->s);
    paradt_triangulation t;
    c->status = paradt_triangulate(&t, &points, &c->options);
    paradt_free(&t);
    return NULL;
}

// The depth of recursion does not grow with the input: 256 KB of stack are enough for the sets with the deepest recursion.
static void a_small_stack_is_enough(void **state) {
    static const int deep[] = {0, 3, 5, 13, 15, 24, 31};
    (void)state;
    if (SANITIZED)
        skip(); // its stack frames are many times larger
    for (int method = 0; method < PARADT_METHOD_COUNT; method++)
        for (size_t i = 0; i < sizeof deep / sizeof deep[0]; i++) {
            small_stack_call c;
            pthread_attr_t attributes;
            pthread_t thread;
            memset(&c, 0, sizeof c);
            c.s = family_make(&families[deep[i]], NULL, 3, 8000, 1);
            c.options.method = (paradt_method)method;
            c.options.regions = i % 2 ? 5 : 0;
            pthread_attr_init(&attributes);
            pthread_attr_setstacksize(&attributes, 256 * 1024);
            assert_int_equal(pthread_create(&thread, &attributes, call_on_small_stack, &c), 0);
            pthread_join(thread, NULL);
            pthread_attr_destroy(&attributes);
            assert_int_equal(c.status, PARADT_OK);
            sample_free(&c.s);
        }
}

// A search looks at a bounded number of points, whether they fill space, clusters or a surface, with one region and with several.
// Without the bounds for surfaces it would look at thousands of points for each cell of a sphere.
static void searches_look_at_few_points(void **state) {
    enum { MOST = 120 }; // points a cell, half as many again as the worst case has
    static const int kinds[] = {0, 1, 2, 3, 5};
    (void)state;
    for (int method = 0; method < PARADT_METHOD_COUNT; method++)
        for (size_t i = 0; i < (SANITIZED ? 1 : sizeof kinds / sizeof kinds[0]); i++)
            for (size_t regions = 1; regions <= 4; regions += 3) {
                sample s = family_make(&families[kinds[i]], NULL, 3, 6000, 1);
                paradt_points points = points_of(&s);
                paradt_options options = {0};
                paradt_triangulation t;
                options.method = (paradt_method)method;
                options.regions = regions;
                assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
                if (t.stats.distance_evaluations > MOST * t.stats.cells)
                    fail_msg("%s, %s, %zu regions: %.0f points a cell", families[kinds[i]].name,
                             paradt_method_string((paradt_method)method), regions,
                             (double)t.stats.distance_evaluations / (double)t.stats.cells);
                paradt_free(&t);
                sample_free(&s);
            }
}

// In four and more dimensions AUTO begins with InCoDe, but gives it up on lattices, with one region and with several. In some of
// the uniform sets the first cells of regions take more predicates than AUTO allows for cells with ties.
static void auto_gives_up_searching_where_ties_abound(void **state) {
    static const struct {
        const char *family;
        int dim, count;
        size_t regions;
    } cases[] = {{"uniform", 4, 600, 1}, {"uniform", 5, 1012, 3}, {"uniform", 6, 200, 5}, {"uniform", 6, 300, 4},
                 {"lattice", 4, 600, 1}, {"lattice", 5, 600, 1}, {"lattice", 5, 300, 3}};
    (void)state;
    for (size_t i = SANITIZED ? 4 : 0; i < sizeof cases / sizeof cases[0]; i += SANITIZED ? 2 : 1) {
        int f = family_named(cases[i].family), ties = strcmp(cases[i].family, "lattice") == 0;
        sample s = family_make(&families[f], NULL, cases[i].dim, cases[i].count, 2);
        paradt_points points = points_of(&s);
        uint64_t hashes[2], looked_at[2];
        for (int method = 0; method < 2; method++) { // AUTO, INCODE
            paradt_options options = {0};
            paradt_triangulation t;
            options.method = (paradt_method)method;
            options.regions = cases[i].regions;
            assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
            hashes[method] = paradt_hash(&t);
            looked_at[method] = t.stats.distance_evaluations;
            paradt_free(&t);
        }
        assert_true(hashes[0] == hashes[1]);
        if (!ties && looked_at[0] != looked_at[1])
            fail_on_sample(&s, "AUTO gave InCoDe up");
        if (ties && cases[i].regions == 1 && looked_at[0] > looked_at[1] / 2)
            fail_on_sample(&s, "AUTO went on with InCoDe");
        sample_free(&s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_memory_is_the_allocators_and_goes_back),
        cmocka_unit_test(pages_are_made_within_blocks),
        cmocka_unit_test(every_failing_allocation_is_an_error_and_leaks_nothing),
        cmocka_unit_test(the_memory_limit_is_kept),
        cmocka_unit_test(every_progress_call_can_cancel),
        cmocka_unit_test(reading_many_points_can_be_cancelled),
        cmocka_unit_test(a_triangulation_of_thousands_of_points_is_accepted),
        cmocka_unit_test(without_neighbors_the_cells_are_the_same),
        cmocka_unit_test(large_sets_take_few_bytes_a_point),
        cmocka_unit_test(regions_give_up_where_questions_abound),
        cmocka_unit_test(regions_that_would_give_up_are_not_begun),
        cmocka_unit_test(points_that_are_all_equal_make_one_region),
        cmocka_unit_test(regions_near_a_surface_tell_each_other),
        cmocka_unit_test(some_regions_of_a_lattice_tell_others),
        cmocka_unit_test(regions_make_few_cells_again),
        cmocka_unit_test(memory_may_run_out_where_regions_are_given_up),
        cmocka_unit_test(room_that_is_only_expected_is_not_needed),
        cmocka_unit_test(regions_give_up_on_points_measured_from_a_sphere),
        cmocka_unit_test(errno_the_rounding_mode_and_the_input_are_left_alone),
        cmocka_unit_test(a_small_stack_is_enough),
        cmocka_unit_test(searches_look_at_few_points),
        cmocka_unit_test(auto_gives_up_searching_where_ties_abound),
    };
    return cmocka_run_group_tests_name("resources", tests, NULL, NULL);
}
