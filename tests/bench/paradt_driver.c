// ParaDT: --method NAME (hull: the convex hull), --regions K, --jobs J (threads of the parallel_for), --no-neighbors. The line has the
// statistics. --copies C shows what C processors achieve if no process waits for another.
#include <pthread.h>
#include <stdatomic.h>
#include <sys/wait.h>

#include "bench.h"

// --- a parallel_for over permanent threads, as host programs have them -----------------------------------------------
//
// The first call creates the threads. Between calls a thread polls for work, as often as a thread of GNU's OpenMP,
// which HXT uses, and then sleeps.

enum { MAX_JOBS = 256, LOOKS = 300000 }; // LOOKS: polls before a thread sleeps

static struct {
    pthread_mutex_t lock;
    pthread_cond_t wake;
    pthread_t thread[MAX_JOBS];
    size_t workers; // threads created
    size_t count;   // number of tasks
    void (*task)(void *context, size_t index);
    void *context;
    atomic_size_t next; // first task that has not begun
    atomic_size_t busy; // workers that have not finished the call
    atomic_uint call;   // number of calls so far
} team = {.lock = PTHREAD_MUTEX_INITIALIZER, .wake = PTHREAD_COND_INITIALIZER};

static void relax(void) {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

static void team_work(void) {
    for (size_t index; (index = atomic_fetch_add(&team.next, 1)) < team.count;)
        team.task(team.context, index);
}

// Waits for the call after number `call`.
static void team_await(unsigned call) {
    for (int look = 0; look < LOOKS; look++) {
        if (atomic_load(&team.call) != call)
            return;
        relax();
    }
    pthread_mutex_lock(&team.lock);
    while (atomic_load(&team.call) == call)
        pthread_cond_wait(&team.wake, &team.lock);
    pthread_mutex_unlock(&team.lock);
}

// The function of each thread. seen: number of calls when the thread was created
static void *team_member(void *seen) {
    for (unsigned call = (unsigned)(uintptr_t)seen;; call++) {
        team_await(call);
        team_work();
        atomic_fetch_sub(&team.busy, 1);
    }
    return NULL;
}

// A paradt_parallel_for. user: number of jobs, the calling thread's among them
static void team_for(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    size_t jobs = *(const size_t *)user;
    void *seen = (void *)(uintptr_t)atomic_load(&team.call);
    while (team.workers + 1 < jobs && !pthread_create(&team.thread[team.workers], NULL, team_member, seen))
        team.workers++;
    team.count = count;
    team.task = task;
    team.context = context;
    atomic_store(&team.next, 0);
    atomic_store(&team.busy, team.workers);
    pthread_mutex_lock(&team.lock);
    atomic_fetch_add(&team.call, 1);
    pthread_cond_broadcast(&team.wake);
    pthread_mutex_unlock(&team.lock);
    team_work();
    while (atomic_load(&team.busy))
        relax();
}

static void team_warm_up(void *context, size_t index) {
    (void)context, (void)index;
    bench_warm_up();
}

// --- the measurement -------------------------------------------------------------------------------------------------

static paradt_method method_named(const char *name) {
    for (int m = 0; m < (int)PARADT_METHOD_COUNT; m++)
        if (!strcmp(paradt_method_string((paradt_method)m), name))
            return (paradt_method)m;
    bench_fail(name, "no such method");
    return PARADT_AUTO;
}

static int is_hull(const bench_arguments *a) { return !strcmp(a->method, "hull"); }

static void describe(char *text, size_t size, const paradt_triangulation *t, const bench_arguments *a) {
    const paradt_stats *s = &t->stats;
    snprintf(text, size,
             ",\"method\":\"%s\",\"regions\":%zu,\"dim\":%d,\"hull_facets\":%" PRIu64 ",\"duplicates\":%" PRIu64
             ",\"hidden\":%" PRIu64 ",\"distance_evaluations\":%" PRIu64 ",\"grid_cells_visited\":%" PRIu64
             ",\"active_peak\":%" PRIu64 ",\"orient_calls\":%" PRIu64 ",\"insphere_calls\":%" PRIu64
             ",\"exact_small\":%" PRIu64 ",\"exact_fixed\":%" PRIu64 ",\"exact_general\":%" PRIu64
             ",\"perturbed\":%" PRIu64 ",\"cells_recomputed\":%" PRIu64 ",\"peak_bytes\":%" PRIu64
             ",\"seconds_points\":%.6f,\"seconds_grid\":%.6f,\"seconds_build\":%.6f,\"seconds_finish\":%.6f",
             a->method, a->regions, t->dim, s->hull_facets, s->duplicates, s->hidden, s->distance_evaluations,
             s->grid_cells_visited, s->active_peak, s->orient_calls, s->insphere_calls, s->exact_small, s->exact_fixed,
             s->exact_general, s->perturbed, s->cells_recomputed, s->peak_bytes, s->seconds_points, s->seconds_grid,
             s->seconds_build, s->seconds_finish);
}

static void triangulate(paradt_triangulation *result, const bench_arguments *a, const bench_points *set,
                        const paradt_options *options) {
    paradt_points input = paradt_points_f64(set->coordinates, set->count, set->dim);
    paradt_status status;
    input.weights = set->weights;
    if (is_hull(a)) { // its facets are the result's cells
        paradt_hull hull;
        status = paradt_hull_compute(&hull, &input, options);
        memset(result, 0, sizeof *result);
        result->dim = hull.dim - 1;
        result->cell_count = hull.facet_count;
        result->cells = hull.facets;
        result->neighbors = hull.neighbors;
        result->representative = hull.plane;
        result->allocator = hull.allocator;
        result->stats = hull.stats;
        hull.facets = hull.neighbors = hull.plane = NULL;
        paradt_hull_free(&hull);
    } else {
        status = paradt_triangulate(result, &input, options);
    }
    if (status != PARADT_OK)
        bench_fail(a->path, paradt_status_string(status));
}

// Triangulates each part of the points in a process of its own. The results are dropped.
static void run_copies(const bench_arguments *a, const bench_points *points, const paradt_options *options) {
    for (size_t i = 0; i < a->copies; i++) {
        pid_t child = fork();
        if (child < 0)
            bench_fail("--copies", "no more processes");
        if (child == 0) {
            bench_points set = bench_set(points, a->copies, i);
            paradt_triangulation result;
            triangulate(&result, a, &set, options);
            _exit(0);
        }
    }
    for (size_t i = 0; i < a->copies; i++) {
        int status;
        if (wait(&status) < 0 || !WIFEXITED(status) || WEXITSTATUS(status))
            bench_fail("--copies", "a process failed");
    }
}

int main(int argc, char **argv) {
    bench_arguments arguments = bench_parse(argc, argv);
    bench_points points = bench_read(arguments.path);
    paradt_options options;
    memset(&options, 0, sizeof options);
    options.method = is_hull(&arguments) ? PARADT_AUTO : method_named(arguments.method);
    options.regions = arguments.regions;
    options.flags = arguments.no_neighbors ? PARADT_NO_NEIGHBORS : 0;
    if (arguments.jobs > MAX_JOBS || arguments.copies > MAX_JOBS)
        bench_fail("--jobs, --copies", "too many");
    if (arguments.jobs > 1) {
        options.parallel_for = team_for;
        options.user = &arguments.jobs;
    }
    paradt_triangulation result;
    memset(&result, 0, sizeof result);
    if (arguments.jobs > 1 && arguments.copies == 1) // a copy would inherit the team without its threads
        team_for(&arguments.jobs, arguments.jobs, team_warm_up, NULL);
    bench_clock clock = bench_start(&points);
    if (arguments.copies > 1)
        run_copies(&arguments, &points, &options);
    for (size_t i = 0; i < arguments.calls && arguments.copies == 1; i++) {
        bench_points set = bench_set(&points, arguments.calls, i);
        paradt_free(&result); // the result of the previous set; freeing it is part of the time
        triangulate(&result, &arguments, &set, &options);
    }
    bench_stop(&clock);
    char extra[1024];
    int hashed = arguments.hash && arguments.copies == 1;
    uint64_t hash = hashed ? paradt_hash(&result) : 0;
    describe(extra, sizeof extra, &result, &arguments);
    bench_print(&arguments, &points, &clock, result.cell_count, hashed ? &hash : NULL, extra);
    paradt_free(&result);
    return 0;
}
