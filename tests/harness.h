// Runs the library on a sample and reports what went wrong; shared by the cmocka programs. They are linked with the
// implementation, except for those that test its internals and define PARADT_IMPLEMENTATION themselves.
#ifndef HARNESS_H
#define HARNESS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "paradt.h"

#include "families.h"
#include "oracle.h"
#include "verify.h"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#define RACES_ONLY 1 // 1: built to find data races; tests of a single thread are left to the other builds
#else
#define RACES_ONLY 0
#endif
#ifndef SANITIZED
#define SANITIZED 0 // 1: the program is several times slower, so tests take fewer seeds
#endif

// Is only the core of the tests to run (make check)?
static inline int is_quick(void) {
    const char *quick = getenv("QUICK");
    return quick && *quick;
}

static inline paradt_points points_of(const sample *s) {
    paradt_points points = {0};
    points.data = s->x;
    points.count = (size_t)s->count;
    points.dim = s->dim;
    points.weights = s->w;
    return points;
}

// Returns the cells as a sorted set. original[v] is the number that vertex v gets in it; NULL: its own index.
static inline cell_set cells_of(const paradt_triangulation *t, const int *original) {
    cell_set set = {0};
    int n = t->dim + 1, vertices[CELLS_MAX_DIM + 1];
    for (size_t c = 0; c < t->cell_count; c++) {
        for (int i = 0; i < n; i++) {
            int v = (int)t->cells[c * (size_t)n + (size_t)i];
            vertices[i] = original ? original[v] : v;
        }
        cells_add(&set, cell_make(vertices, n));
    }
    cells_sort(&set);
    return set;
}

// Writes the sample to a file under build/tests/failures and prints what failed.
static inline void report_sample(const sample *s, const char *what) {
    static int written;
    char path[64];
    mkdir("build", 0777);
    mkdir("build/tests", 0777);
    mkdir("build/tests/failures", 0777);
    snprintf(path, sizeof path, "build/tests/failures/%d-%d.txt", (int)getpid(), written++);
    FILE *file = fopen(path, "w");
    if (file) {
        sample_print(file, s);
        fprintf(file, "# %s\n", what);
        fclose(file);
    }
    print_message("# %s: %s (points in %s)\n", s->name, what, path);
}

static inline void fail_on_sample(const sample *s, const char *what) {
    report_sample(s, what);
    fail();
}

// The sample that is being triangulated. If the run does not end in time, the sample is written down before the program ends.
static const sample *watched;

static inline void watch_ended(int number) {
    (void)number;
    report_sample(watched, "does not end");
    fflush(stdout);
    _exit(1);
}

static inline void watch(const sample *s, unsigned seconds) {
    watched = s;
    signal(SIGALRM, watch_ended);
    alarm(seconds);
}

static inline void fail_if_different(const sample *s, const char *how, const cell_set *expected, const cell_set *found) {
    size_t different = cells_difference(expected, "# missing", found, "# too many", NULL);
    if (different) {
        char text[256];
        cells_difference(expected, "# missing", found, "# too many", stdout);
        snprintf(text, sizeof text, "%s: %u cells differ", how, (unsigned)different);
        fail_on_sample(s, text);
    }
}

// Triangulates the sample. The test fails on an error and on any fault found by verify.h or paradt_check. The caller frees
// the result.
static inline paradt_triangulation triangulate_and_verify(const sample *s, const paradt_options *options,
                                                          const char *how) {
    paradt_points points = points_of(s);
    paradt_triangulation t;
    paradt_fault fault;
    const char *wrong = NULL;
    char text[256];
    watch(s, 60);
    paradt_status status = paradt_triangulate(&t, &points, options);
    if (status)
        wrong = paradt_status_string(status);
    if (!wrong)
        wrong = verify_triangulation(&t, s);
    if (!wrong && paradt_check(&t, &points, options, &fault) != PARADT_OK)
        wrong = fault.reason ? fault.reason : "paradt_check refuses it without a reason";
    watch(NULL, 0);
    if (wrong) {
        snprintf(text, sizeof text, "%s: %s", how, wrong);
        fail_on_sample(s, text);
    }
    return t;
}

// Returns the name of a run in messages of failures.
static inline const char *how_text(const paradt_options *options) {
    static char text[96];
    snprintf(text, sizeof text, "%s, %u %s regions", paradt_method_string(options->method),
             (unsigned)(options->regions ? options->regions : 1),
             options->partition == PARADT_UNIFORM ? "uniform" : "bisection");
    return text;
}

// Makes a test whose name is formatted. row is passed to the test as its state.
static inline struct CMUnitTest named_test(CMUnitTestFunction run, void *row, const char *format, ...) {
    struct CMUnitTest test = {NULL, run, NULL, NULL, row};
    char *name = (char *)need(1, 128);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(name, 128, format, arguments);
    va_end(arguments);
    for (char *c = name; *c; c++)
        if (*c == ' ' || *c == '-')
            *c = '_';
    test.name = name;
    return test;
}

// cmocka's own macro needs an array of known size. The names are never freed.
static inline int run_named_tests(const char *group, const struct CMUnitTest *tests, size_t count) {
    return _cmocka_run_group_tests(group, tests, count, NULL, NULL);
}

#endif
