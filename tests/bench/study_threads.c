// study_threads RUNS gen:KIND:N:SEED THREADS...: measures on one processor how paradt_triangulate would scale with
// threads, each of which gets a region. Prints a table with a column for each number of threads, of which the first
// should be 1: that call is undivided and has no parallel_for. The rows are milliseconds, in the order of the work:
//   a step            the parallel_for of the call has run it: its slowest task, where there are as many threads as
//                     tasks; else tasks in their order, each on the thread that is free first
//   after a step      what one thread does up to the next step
// and, at the end:
//   serial, steps     the sums of both kinds
//   time              the sum of these
//   times one thread  the first column's time / time
//   work              of all tasks and the serial parts: time of one thread with so many regions
//   cells again       cells made and not owned, in percent of the cells
//   bytes a point     peak_bytes / points
//
// What is emulated. The parallel_for below runs the tasks of a step one after another, in the calling thread, and times
// each of them by the CPU time of the thread. So nothing is said of memory bandwidth and caches that threads share, of
// waking them (STEP microseconds are added for each step), nor of page faults that wait for each other. The legs of the
// relay are run as one: regions are not exchanged, as they are where threads are not equally fast.
//
// Several runs. Each call does the same work in the same order, so it is divided into stretches, which end with a step,
// a task, or a report of progress. (The library reports after every thousand insertions.) Of each stretch the least
// time of all runs counts, which leaves out what else the machine did meanwhile.
//
// With `real` instead of a number of threads: two threads that exist, in the same rows; `time` is then followed by the
// wall time, of the run with the least. The other runs are there to compare the emulation with.
#define PARADT_IMPLEMENTATION
#include "paradt.h"
#define PARADT_POINTS_IMPLEMENTATION
#include "examples/paradt_points.h"

#include <pthread.h>
#include <sched.h>
#include <stdio.h>

enum { DIM = 3, MOST_SEGMENTS = 256, MOST_COLUMNS = 16 };
static const double STEP = 10e-6; // seconds to wake threads for a step

// A part of the call: a step, or what follows one
typedef struct segment {
    const char *name;
    int is_step;
    size_t tasks;
    size_t first, end; // its stretches
} segment;

typedef struct stretch {
    double least; // seconds
    size_t task;
} stretch;

typedef struct column {
    size_t threads; // 1: undivided
    int real;
    int runs;
    segment segments[MOST_SEGMENTS];
    size_t segment_count;
    stretch *stretches;
    size_t count, capacity;
    double wall; // of the best run
    paradt_stats stats;
} column;

static struct {
    column *now;    // the column that runs
    size_t segment; // the segment that runs
    size_t task;    // the task that runs
    size_t at;      // number of the stretch that runs
    double began;   // CPU time when it began
    uint64_t hash;  // that of all runs
} study;

static void fail(const char *what) {
    fprintf(stderr, "study_threads: %s\n", what);
    exit(1);
}

static double cpu_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// --- stretches

static void record(size_t task, double seconds) {
    column *c = study.now;
    if (study.at == c->capacity) {
        c->capacity = 2 * c->capacity + 1024;
        c->stretches = (stretch *)realloc(c->stretches, c->capacity * sizeof *c->stretches);
        if (!c->stretches) fail("no memory");
    }
    if (study.at == c->count) {
        if (c->runs) fail("the runs do not have the same stretches");
        c->stretches[c->count].least = seconds;
        c->stretches[c->count++].task = task;
    } else if (seconds < c->stretches[study.at].least) {
        c->stretches[study.at].least = seconds;
    }
    study.at++;
}

static void end_stretch(void) {
    double now = cpu_now();
    record(study.task, now - study.began);
    study.began = cpu_now();
}

static void begin_segment(const char *name, int is_step, size_t tasks) {
    column *c = study.now;
    segment *s = c->segments + study.segment;
    if (study.segment == MOST_SEGMENTS) fail("too many steps");
    s->name = name;
    s->is_step = is_step;
    s->tasks = tasks;
    s->first = study.at;
    c->segment_count = study.segment + 1;
    study.task = 0;
}

static void end_segment(void) {
    study.now->segments[study.segment++].end = study.at;
}

static int progress(void *user, double fraction) {
    (void)user, (void)fraction;
    if (!study.now->real) end_stretch();
    return 0;
}

// --- steps

static const char *name_of(void (*task)(void *context, size_t index)) {
    static const struct {
        void (*task)(void *context, size_t index);
        const char *name;
    } names[] = {
        {paradt__survey_task, "survey"}, {paradt__key_task, "keys"},          {paradt__scatter_task, "scatter"},
        {paradt__sort_task, "sort"},     {paradt__gather_task, "gather"},     {paradt__measure_task, "measure"},
        {paradt__grid_task, "grid"},     {paradt__points_task, "points"},     {paradt__lend_task, "lend"},
        {paradt__build_task, "build"},   {paradt__leg_task, "build"},         {paradt__publish_task, "publish"},
        {paradt__learn_task, "learn"},   {paradt__complete_task, "complete"}, {paradt__compact_task, "compact"},
        {paradt__emit_task, "emit"},     {paradt__join_task, "join"},         {paradt__box_task, "boxes"},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i].task == task) return names[i].name;
    return "other";
}

static const char *after(const char *name) {
    static char texts[MOST_SEGMENTS][32];
    static size_t count;
    char text[32];
    snprintf(text, sizeof text, "after %s", name);
    for (size_t i = 0; i < count; i++)
        if (!strcmp(texts[i], text)) return texts[i];
    if (count == MOST_SEGMENTS) fail("too many names");
    return strcpy(texts[count++], text);
}

// The two threads of a real step
typedef struct real_step {
    void (*task)(void *context, size_t index);
    void *context;
    size_t next, count;
    double seconds[2]; // of the CPU, by thread
} real_step;

static struct {
    real_step step;
    unsigned long number; // of the step that the second thread is to run next
    unsigned long ended;  // steps that it has run
    int stop;
} real;

static void real_run(int thread) {
    real_step *s = &real.step;
    double began = cpu_now();
    size_t i;
    while ((i = __atomic_fetch_add(&s->next, 1, __ATOMIC_RELAXED)) < s->count) s->task(s->context, i);
    s->seconds[thread] = cpu_now() - began;
}

static void *real_thread(void *unused) {
    unsigned long number = 0;
    (void)unused;
    for (;;) {
        for (long spins = 0; __atomic_load_n(&real.number, __ATOMIC_ACQUIRE) == number; spins++) {
            if (__atomic_load_n(&real.stop, __ATOMIC_ACQUIRE)) return NULL;
            if (spins > 100000) sched_yield();
        }
        real_run(1);
        __atomic_store_n(&real.ended, ++number, __ATOMIC_RELEASE);
    }
}

static void real_for(size_t count, void (*task)(void *context, size_t index), void *context) {
    real.step.task = task;
    real.step.context = context;
    real.step.next = 0;
    real.step.count = count;
    __atomic_add_fetch(&real.number, 1, __ATOMIC_RELEASE);
    real_run(0);
    for (long spins = 0; __atomic_load_n(&real.ended, __ATOMIC_ACQUIRE) != real.number; spins++)
        if (spins > 100000) sched_yield();
    record(0, real.step.seconds[0]);
    record(1, real.step.seconds[1]);
}

static void parallel_for(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    const char *name = name_of(task);
    (void)user;
    end_stretch();
    end_segment();
    begin_segment(name, 1, count);
    if (study.now->real) {
        real_for(count, task, context);
    } else {
        if (task == paradt__leg_task) ((paradt__work *)context)->relay.stop = PTRDIFF_MAX;
        for (study.task = 0; study.task < count; study.task++) {
            study.began = cpu_now();
            task(context, study.task);
            end_stretch();
        }
    }
    end_segment();
    begin_segment(after(name), 0, 1);
    study.began = cpu_now();
}

// --- runs

static void run(column *c, const paradt_points *points) {
    paradt_options options;
    paradt_triangulation t;
    struct timespec from, to;
    double wall;
    memset(&options, 0, sizeof options);
    options.progress = progress;
    if (c->threads > 1) {
        options.parallel_for = parallel_for;
        options.regions = c->threads;
    }
    study.now = c;
    study.segment = study.at = 0;
    begin_segment(c->threads > 1 ? "begin" : "undivided", 0, 1);
    clock_gettime(CLOCK_MONOTONIC, &from);
    study.began = cpu_now();
    if (paradt_triangulate(&t, points, &options)) fail("the triangulation failed");
    end_stretch();
    clock_gettime(CLOCK_MONOTONIC, &to);
    end_segment();
    wall = (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
    if (!c->runs && !study.hash) study.hash = paradt_hash(&t);
    else if (!c->runs && study.hash != paradt_hash(&t)) fail("the cells are not those of the first run");
    if (!c->runs || wall < c->wall) c->wall = wall;
    if (study.at != c->count) fail("the runs do not have the same stretches");
    c->stats = t.stats;
    c->runs++;
    paradt_free(&t);
}

// Runs on two threads that exist. Their stretches are not the same in each run: those of the fastest run are kept.
static void run_real(column *c, const paradt_points *points) {
    static column once;
    pthread_t thread;
    once.threads = c->threads;
    once.real = 1;
    memset(&real, 0, sizeof real);
    if (pthread_create(&thread, NULL, real_thread, NULL)) fail("no thread");
    run(&once, points);
    __atomic_store_n(&real.stop, 1, __ATOMIC_RELEASE);
    pthread_join(thread, NULL);
    if (!c->runs || once.wall < c->wall) {
        free(c->stretches);
        *c = once;
    } else {
        free(once.stretches);
    }
    memset(&once, 0, sizeof once);
}

// Seconds of a segment: the time until its last task has ended
static double segment_seconds(const column *c, const segment *s, double *work) {
    double *tasks = (double *)calloc(s->tasks + c->threads + 2, sizeof *tasks), *threads = tasks + s->tasks, last = 0;
    size_t count = s->is_step ? c->threads : 1, i, j;
    if (!tasks) fail("no memory");
    if (c->real && s->is_step) threads = tasks; // the stretches are the threads'
    for (i = s->first; i < s->end; i++) {
        tasks[c->stretches[i].task] += c->stretches[i].least;
        *work += c->stretches[i].least;
    }
    for (i = 0; i < s->tasks && threads != tasks; i++) {
        size_t first = 0;
        for (j = 1; j < count; j++)
            if (threads[j] < threads[first]) first = j;
        threads[first] += tasks[i];
    }
    for (j = 0; j < count; j++) last = threads[j] > last ? threads[j] : last;
    free(tasks);
    return last;
}

// --- the table

typedef struct row {
    const char *name;
    double seconds[MOST_COLUMNS];
    int is_step;
} row;

static void print_row(const char *name, const double *values, size_t count, const char *format, double factor) {
    printf("| %s |", name);
    for (size_t i = 0; i < count; i++) {
        if (values[i] == 0.0) printf(" |");
        else printf(format, values[i] * factor);
    }
    printf("\n");
}

static void print_table(const char *points, const column *columns, size_t count, double n) {
    row rows[MOST_SEGMENTS];
    size_t row_count = 0, i, j, k;
    double serial[MOST_COLUMNS] = {0}, steps[MOST_COLUMNS] = {0}, work[MOST_COLUMNS] = {0}, time[MOST_COLUMNS],
           ratio[MOST_COLUMNS], again[MOST_COLUMNS], bytes[MOST_COLUMNS], calls[MOST_COLUMNS] = {0};
    memset(rows, 0, sizeof rows);
    printf("| %s, threads |", points);
    for (i = 0; i < count; i++) printf(columns[i].real ? " %zu real |" : " %zu |", columns[i].threads);
    printf("\n|---|");
    for (i = 0; i < count; i++) printf("---|");
    printf("\n");
    for (i = 0; i < count; i++) {
        const column *c = columns + i;
        size_t place = 0;
        for (j = 0; j < c->segment_count; j++) {
            const segment *s = c->segments + j;
            double seconds = segment_seconds(c, s, &work[i]) + (s->is_step ? STEP : 0.0);
            for (k = 0; k < row_count && strcmp(rows[k].name, s->name); k++) {
            }
            if (k == row_count) { // where this column has it
                for (k = row_count++; k > place; k--) rows[k] = rows[k - 1];
                memset(&rows[k], 0, sizeof rows[k]);
                rows[k].name = s->name;
                rows[k].is_step = s->is_step;
            }
            place = k + 1;
            rows[k].seconds[i] += seconds;
            *(s->is_step ? &steps[i] : &serial[i]) += seconds;
            calls[i] += s->is_step;
        }
        time[i] = serial[i] + steps[i];
        ratio[i] = time[0] / time[i];
        again[i] = (double)c->stats.cells_recomputed / (double)c->stats.cells;
        bytes[i] = (double)c->stats.peak_bytes / n;
    }
    for (k = 0; k < row_count; k++) print_row(rows[k].name, rows[k].seconds, count, " %.2f |", 1e3);
    print_row("serial", serial, count, " %.2f |", 1e3);
    print_row("steps", steps, count, " %.2f |", 1e3);
    print_row("calls of parallel_for", calls, count, " %.0f |", 1);
    print_row("time", time, count, " %.1f |", 1e3);
    for (i = 0; i < count && !columns[i].real; i++) {
    }
    if (i < count) {
        double wall[MOST_COLUMNS] = {0};
        for (i = 0; i < count; i++) wall[i] = columns[i].real || i == 0 ? columns[i].wall : 0.0;
        print_row("wall", wall, count, " %.1f |", 1e3);
    }
    print_row("times one thread", ratio, count, " **%.2f** |", 1);
    print_row("work", work, count, " %.1f |", 1e3);
    print_row("cells again", again, count, " %.1f %% |", 100);
    print_row("bytes a point", bytes, count, " %.0f |", 1);
}

int main(int argc, char **argv) {
    static column columns[MOST_COLUMNS];
    paradt_gen_spec spec;
    const char *wrong = argc < 4 ? "study_threads RUNS gen:KIND:N:SEED THREADS..." : paradt_gen_parse(&spec, argv[2]);
    int count = argc - 3, runs;
    double *coordinates;
    paradt_points points;
    if (wrong) fail(wrong);
    if ((runs = atoi(argv[1])) < 1) fail("RUNS has to be 1 or more");
    if (count > MOST_COLUMNS) fail("too many numbers of threads");
    for (int i = 0; i < count; i++) {
        columns[i].real = !strcmp(argv[3 + i], "real");
        columns[i].threads = columns[i].real ? 2 : (size_t)atoi(argv[3 + i]);
        if (columns[i].threads < 1 || columns[i].threads > 1024) fail("the number of threads has to be 1 to 1024");
    }
    coordinates = (double *)malloc((size_t)spec.count * DIM * sizeof(double));
    if (!coordinates) fail("no memory");
    paradt_gen_points(&spec, DIM, 0, (size_t)spec.count, coordinates);
    points = paradt_points_f64(coordinates, (size_t)spec.count, DIM);
    for (int r = 0; r < runs; r++)
        for (int i = 0; i < count; i++) {
            if (columns[i].real) run_real(&columns[i], &points);
            else run(&columns[i], &points);
        }
    print_table(argv[2], columns, (size_t)count, (double)spec.count);
    free(coordinates);
    return 0;
}
