// A call that is cancelled ends soon: between two calls of the progress callback no method, query or check works for long,
// nor before the first one or after the last. Time is the thread's own, so that other programs hardly matter.
// WAITING_POINTS is the number of points, 250,000 if it is not set. WAITING_TELL prints the longest gaps.
#include "harness.h"

#include <time.h>

typedef struct watch_of_gaps {
    double last, longest, at; // seconds; at: the fraction at the end of the longest gap
    size_t calls;
    double stop_at; // cancels from this fraction on; negative: never
} watch_of_gaps;

static double thread_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int note(void *user, double fraction) {
    watch_of_gaps *w = (watch_of_gaps *)user;
    double now = thread_seconds();
    if (now - w->last > w->longest) {
        w->longest = now - w->last;
        w->at = fraction;
    }
    w->last = thread_seconds();
    w->calls++;
    return w->stop_at >= 0 && fraction >= w->stop_at;
}

static watch_of_gaps begin_watch(void) {
    watch_of_gaps w = {0, 0, 0, 0, -1};
    w.last = thread_seconds();
    return w;
}

static size_t points_wanted(void) {
    const char *text = getenv("WAITING_POINTS");
    return text ? (size_t)atol(text) : SANITIZED || is_quick() ? 3000 : 250000;
}

// What is allowed at a million points is 50 ms. A pass over all cells takes a quarter of that here.
static double limit_seconds(void) { return SANITIZED ? 1e9 : 0.03; }

static void end_watch(watch_of_gaps *w, const char *what) {
    note(w, 2);
    if (getenv("WAITING_TELL"))
        printf("# %-44s %7.1f ms at %.2f, %zu calls\n", what, 1e3 * w->longest, w->at, w->calls - 1), fflush(stdout);
}

static paradt_options watched_by(watch_of_gaps *w) {
    paradt_options options = {0};
    options.progress = note;
    options.user = w;
    return options;
}

static void expect(paradt_status status, const char *what) {
    if (status)
        fail_msg("%s: %s", what, paradt_status_string(status));
}

// What is watched: each makes its calls and reports them.
typedef struct task {
    const char *family;
    int dim, weighted;
} task;

static sample points_for(const task *t, size_t part) {
    return family_make(&families[family_named(t->family)], t->weighted ? &weightings[1] : NULL, t->dim,
                       (int)(points_wanted() / part), 1);
}

// Calls that took too long, and how often. A time that is too long once may be the machine's doing; three are the call's.
enum { MOST_LATE = 64, ATTEMPTS = 3 };
static struct {
    char name[128];
    int times;
} late[MOST_LATE];
static int late_count;

static void report(watch_of_gaps *w, const task *t, const char *what) {
    char name[128];
    int i = 0;
    snprintf(name, sizeof name, "%s, %s, %d%s", what, t->family, t->dim, t->weighted ? ", weighted" : "");
    end_watch(w, name);
    if (w->calls < 2 && points_wanted() >= 100000)
        fail_msg("%s: nobody asks whether the call is cancelled", name);
    if (w->longest <= limit_seconds())
        return;
    while (i < late_count && strcmp(late[i].name, name))
        i++;
    if (i == MOST_LATE)
        return;
    if (i == late_count)
        snprintf(late[late_count++].name, sizeof late->name, "%s", name);
    if (++late[i].times >= ATTEMPTS)
        fail_msg("%s: %.0f ms without a look at whether the call is cancelled, at %.2f of it", name, 1e3 * w->longest,
                 w->at);
}

static void watch_methods(const task *t) {
    for (int method = 0; method <= PARADT_METHOD_COUNT; method++) {
        const int furthest = method == PARADT_METHOD_COUNT, slow = method >= PARADT_FLIP;
        sample s = points_for(t, slow ? 2 : 1);
        paradt_points points = points_of(&s);
        for (size_t regions = 0; regions <= (method && method <= PARADT_BOWYER_WATSON ? 8 : 0); regions += 8) {
            watch_of_gaps w = begin_watch();
            paradt_options options = watched_by(&w);
            paradt_triangulation out;
            char name[64];
            snprintf(name, sizeof name, "%s%s", furthest ? "furthest site" : paradt_method_string((paradt_method)method),
                     regions ? ", regions" : "");
            options.method = furthest ? PARADT_LIFTED_HULL : (paradt_method)method;
            options.flags = furthest ? PARADT_FURTHEST_SITE : 0;
            options.regions = regions;
            expect(paradt_triangulate(&out, &points, &options), name);
            report(&w, t, name);
            paradt_free(&out);
        }
        sample_free(&s);
    }
}

static void watch_hulls(const task *t) {
    sample s = points_for(t, 1);
    paradt_points points = points_of(&s);
    watch_of_gaps w = begin_watch();
    paradt_options options = watched_by(&w);
    paradt_hull hull;
    expect(paradt_hull_compute(&hull, &points, &options), "hull");
    report(&w, t, "hull");
    w = begin_watch();
    expect(paradt_hull_check(&hull, &points, &options, NULL), "check of a hull");
    report(&w, t, "check of a hull");
    paradt_hull_free(&hull);
    sample_free(&s);
}

static void watch_uses(const task *t) {
    sample s = points_for(t, 1), q = points_for(t, 1);
    paradt_points points = points_of(&s), queries = points_of(&q);
    paradt_triangulation made;
    paradt_locator *locator;
    paradt_location *places = (paradt_location *)need(points.count, sizeof *places);
    paradt_index *found = (paradt_index *)need(points.count, sizeof *found);
    watch_of_gaps w;
    paradt_options options = watched_by(&w);
    paradt_voronoi voronoi;
    paradt_voronoi_request request = {0};
    double box[6] = {0.1, 0.1, 0.1, 0.9, 0.9, 0.9};
    uint64_t state = 3;
    for (int i = 0; i < q.count * q.dim; i++)
        q.x[i] = 0.5 * q.x[i] + 0.5 * q.x[random_below(&state, q.count) * q.dim + i % q.dim];
    w = begin_watch();
    expect(paradt_triangulate(&made, &points, &options), "auto");

    w = begin_watch();
    expect(paradt_check(&made, &points, &options, NULL), "check");
    report(&w, t, "check");

    w = begin_watch();
    expect(paradt_locator_create(&locator, &made, &points, &options), "locator");
    report(&w, t, "locator");
    w = begin_watch();
    expect(paradt_locate(locator, &queries, places, &options), "locate");
    report(&w, t, "locate");
    w = begin_watch();
    expect(paradt_nearest(locator, &queries, found, &options), "nearest");
    report(&w, t, "nearest");
    paradt_locator_free(locator);

    w = begin_watch();
    expect(paradt_voronoi_compute(&voronoi, &made, &points, NULL, &options), "Voronoi volumes");
    report(&w, t, "Voronoi volumes");
    paradt_voronoi_free(&voronoi);
    request.outputs = 63;
    request.box = box;
    if (t->dim == 2)
        memmove(box + 2, box + 3, 2 * sizeof *box);
    w = begin_watch();
    expect(paradt_voronoi_compute(&voronoi, &made, &points, &request, &options), "Voronoi, all");
    report(&w, t, "Voronoi, all");
    paradt_voronoi_free(&voronoi);

    for (int i = 0; i < s.count * s.dim; i++)
        s.x[i] *= 1 + 0x1p-16 * random_unit(&state);
    w = begin_watch();
    expect(paradt_repair(&made, &points, &options, NULL), "repair");
    report(&w, t, "repair");
    paradt_free(&made);
    free(places);
    free(found);
    sample_free(&s);
    sample_free(&q);
}

static void watch_living_sets(const task *t) {
    sample s = points_for(t, 1);
    paradt_points points = points_of(&s), part = points;
    watch_of_gaps w = begin_watch();
    paradt_options options = watched_by(&w);
    paradt_dynamic *d;
    paradt_triangulation out;
    paradt_index *ids = (paradt_index *)need(points.count, sizeof *ids);
    expect(paradt_dynamic_create(&d, &points, &options), "living set");
    report(&w, t, "living set");
    for (size_t i = 0; i < points.count; i++)
        ids[i] = (paradt_index)i;
    for (int some = 0; some < 2; some++) { // many, so that all is made anew; and few
        part.count = points.count / (some ? 50 : 2);
        w = begin_watch();
        expect(paradt_dynamic_move_points(d, ids, &part), "move points");
        report(&w, t, some ? "move some points" : "move points");
        w = begin_watch();
        expect(paradt_dynamic_remove_points(d, ids, part.count), "remove points");
        report(&w, t, some ? "remove some points" : "remove points");
        w = begin_watch();
        expect(paradt_dynamic_insert_points(d, &part, ids), "insert points");
        report(&w, t, some ? "insert some points" : "insert points");
    }
    w = begin_watch();
    expect(paradt_dynamic_export(d, &out), "export");
    report(&w, t, "export");
    paradt_free(&out);
    paradt_dynamic_free(d);
    free(ids);
    sample_free(&s);
}

// Tries again while a call has taken too long each time.
static void keep_watch(void (*what)(const task *t), const char *points, int dim, int weighted) {
    const task t = {points, dim, weighted};
    int again = 1;
    late_count = 0;
    for (int attempt = 1; again; attempt++) {
        what(&t);
        again = 0;
        for (int i = 0; i < late_count; i++)
            again |= late[i].times == attempt;
    }
}

static void methods_look_up_often(void **state) {
    (void)state;
    keep_watch(watch_methods, "uniform", 3, 0);
    keep_watch(watch_methods, "sphere", 3, 0);
}

static void hulls_look_up_often(void **state) {
    (void)state;
    keep_watch(watch_hulls, "uniform", 2, 0);
    keep_watch(watch_hulls, "uniform", 3, 0);
    keep_watch(watch_hulls, "sphere", 3, 0);
}

static void checks_queries_and_diagrams_look_up_often(void **state) {
    (void)state;
    keep_watch(watch_uses, "uniform", 2, 0);
    keep_watch(watch_uses, "uniform", 3, 0);
    keep_watch(watch_uses, "uniform", 3, 1);
}

static void living_sets_look_up_often(void **state) {
    (void)state;
    keep_watch(watch_living_sets, "uniform", 2, 0);
    keep_watch(watch_living_sets, "uniform", 3, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(methods_look_up_often),
        cmocka_unit_test(hulls_look_up_often),
        cmocka_unit_test(checks_queries_and_diagrams_look_up_often),
        cmocka_unit_test(living_sets_look_up_often),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
