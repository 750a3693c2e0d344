// paradt - the command-line tool of ParaDT
//
//     cc -O3 -o paradt examples/paradt.c -pthread -lm
//     paradt gen:plummer:100000:1 -o cluster.vtu -o cluster.png --check
//
// `paradt --help` lists the inputs, outputs and options; paradt_read.h and paradt_io.h describe the file formats.

#define PARADT_IO_IMPLEMENTATION
#include "paradt_io.h"

#define PARADT_IMPLEMENTATION
#include "../paradt.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <pthread.h>

enum { EXIT_DONE, EXIT_FAILED, EXIT_USAGE, EXIT_INPUT };
enum { MAX_JOBS = 1024 };
enum { POINTS_PER_REGION = 20000 }; // in smaller regions, cells that are made twice cost more than threads gain

// ---------------------------------------------------------------------------------------------------------------------
// >>settings

typedef enum query { LOCATE, NEAREST, QUERIES } query;

typedef struct settings {
    const char *input;
    const char **outputs;
    size_t output_count;
    const char **voronoi; // files of the Voronoi diagram
    size_t voronoi_count;
    double box[2 * PARADT_MAX_DIM]; // lower, then upper bounds
    int box_count;                  // numbers in it; 0: no box
    char *queries[QUERIES];         // input of each kind of queries, from malloc; NULL: none
    const char *answers[QUERIES];   // and its output
    const char *stats; // file to write; "-": standard output; NULL: no statistics
    paradt_io_want want;
    paradt_method method;
    paradt_partition partition;
    size_t regions; // 0: plan() chooses
    size_t jobs;    // 0: one a processor
    int check, hash, quiet, help, version;
    int hull;     // the convex hull instead of the triangulation
    int furthest; // the furthest-site triangulation
} settings;

// Prints an error. Returns the status.
static int fail(int status, const char *text) {
    fprintf(stderr, "paradt: %s\n", text);
    return status;
}

// Prints an error of the command line. value: of the option, NULL if it is not to be named. Returns 0.
static int wrong(const char *option, const char *value, const char *reason) {
    fprintf(stderr, "paradt: %s%s%s: %s (paradt --help lists the options)\n", option, value ? " " : "",
            value ? value : "", reason);
    return 0;
}

// Reads a whole number from 1 to `high`. Returns 1, or 0 if the text is something else.
static int take_number(const char *text, uintmax_t high, size_t *value) {
    char *end;
    uintmax_t number;
    errno = 0;
    number = strtoumax(text, &end, 10);
    if (!isdigit((unsigned char)*text) || *end || errno || number < 1 || number > high)
        return 0;
    *value = (size_t)number;
    return 1;
}

// Each take_... function stores the value of an option. It returns NULL, or what is wrong with the value.

static const char *take_output(settings *s, const char *value) {
    s->outputs[s->output_count++] = value;
    return NULL;
}

static const char *take_dim(settings *s, const char *value) {
    size_t dim;
    if (!take_number(value, PARADT_MAX_DIM, &dim) || dim < 2)
        return "the dimension is a number from 2 to 8";
    s->want.dim = (int)dim;
    return NULL;
}

static const char *take_method(settings *s, const char *value) {
    int m;
    for (m = 0; m < PARADT_METHOD_COUNT; m++)
        if (strcmp(value, paradt_method_string((paradt_method)m)) == 0) {
            s->method = (paradt_method)m;
            return NULL;
        }
    return "no such method";
}

static const char *take_regions(settings *s, const char *value) {
    return take_number(value, SIZE_MAX, &s->regions) ? NULL : "the number of regions is a whole number from 1";
}

static const char *take_jobs(settings *s, const char *value) {
    return take_number(value, MAX_JOBS, &s->jobs) ? NULL : "the number of jobs is a whole number from 1 to 1024";
}

static const char *take_partition(settings *s, const char *value) {
    s->partition = strcmp(value, "uniform") == 0 ? PARADT_UNIFORM : PARADT_BISECTION;
    return s->partition == PARADT_UNIFORM || strcmp(value, "bisection") == 0 ? NULL
                                                                             : "a partition is bisection or uniform";
}

static const char *take_voronoi(settings *s, const char *value) {
    s->voronoi[s->voronoi_count++] = value;
    return NULL;
}

static const char *take_box(settings *s, const char *value) {
    static const char *const reason = "a box is its lower bounds, then its upper ones: LO,..,HI,..";
    char *end;
    s->box_count = 0;
    for (;;) {
        if (s->box_count == 2 * PARADT_MAX_DIM || isspace((unsigned char)*value))
            return reason;
        s->box[s->box_count] = strtod(value, &end);
        if (end == value || !paradt_io__finite(s->box[s->box_count]))
            return reason;
        s->box_count++;
        if (*end != ',')
            return *end ? reason : NULL;
        value = end + 1;
    }
}

// Takes QUERIES=ANSWERS. The last "=" counts, so names of queries may have some.
static const char *take_queries(settings *s, const char *value, query which) {
    const char *equals = strrchr(value, '=');
    if (!equals || equals == value || !equals[1])
        return "queries and answers are QUERIES=ANSWERS";
    if (s->queries[which])
        return "given twice";
    s->queries[which] = (char *)malloc((size_t)(equals - value) + 1);
    if (!s->queries[which])
        return "not enough memory";
    memcpy(s->queries[which], value, (size_t)(equals - value));
    s->queries[which][equals - value] = '\0';
    s->answers[which] = equals + 1;
    return NULL;
}

static const char *take_locate(settings *s, const char *value) {
    return take_queries(s, value, LOCATE);
}

static const char *take_nearest(settings *s, const char *value) {
    return take_queries(s, value, NEAREST);
}

static const char *take_columns(settings *s, const char *value) {
    s->want.columns = value;
    return paradt_io_check_columns(value);
}

static const char *take_format(settings *s, const char *value) {
    s->want.format = value;
    return paradt_io_check_format(value);
}

static const char *take_stats(settings *s, const char *value) {
    s->stats = value;
    return NULL;
}

static const struct {
    const char *name;
    const char *value;                                   // name of the argument in --help; NULL: no argument
    const char *(*take)(settings *s, const char *value); // stores the argument; NULL: no argument
    size_t flag;                                         // of an option without argument: offset of the int to set
    const char *about;                                   // description in --help
} options_table[] = {
    {"-o", "FILE", take_output, 0, "write the result; may be repeated"},
    {"--method", "NAME", take_method, 0, "algorithm; every method gives the same result"},
    {"--dim", "D", take_dim, 0, "dimension, 2 to 8; the first D columns are the coordinates"},
    {"--weights", NULL, NULL, offsetof(settings, want.weights), "the next column is a weight: regular triangulation"},
    {"--radii", NULL, NULL, offsetof(settings, want.radii), "like --weights, but it is a radius, which is squared"},
    {"--columns", "LIST", take_columns, 0, "columns of text or .npy to read, then the weight's: 2-4, or titles: x,y,r"},
    {"--format", "NAME", take_format, 0, "read INPUT as a file of this extension, whatever its name; for - too"},
    {"--regions", "K", take_regions, 0, "divide space into K regions (default: one a job, fewer for small sets)"},
    {"--jobs", "J", take_jobs, 0, "number of threads (default: one a processor)"},
    {"--partition", "HOW", take_partition, 0, "bisection (default: equal numbers of points) or uniform (equal boxes)"},
    {"--hull", NULL, NULL, offsetof(settings, hull), "compute the convex hull alone"},
    {"--furthest", NULL, NULL, offsetof(settings, furthest), "the furthest-site triangulation: spheres around all points"},
    {"--voronoi", "FILE", take_voronoi, 0, "write the Voronoi diagram, with --weights the power diagram; may be repeated"},
    {"--box", "LO,..,HI,..", take_box, 0, "clip Voronoi cells to a box: its lower bounds, then its upper ones"},
    {"--locate", "Q=A", take_locate, 0, "find the cells that hold the points of file Q; write cell,face of each to A"},
    {"--nearest", "Q=A", take_nearest, 0, "find the vertices nearest to the points of file Q; write their indices to A"},
    {"--check", NULL, NULL, offsetof(settings, check), "certify the result in exact arithmetic"},
    {"--stats", "FILE", take_stats, 0, "write statistics as JSON; -: to standard output, instead of the summary"},
    {"--hash", NULL, NULL, offsetof(settings, hash), "print the hash of the set of cells as the last line"},
    {"--quiet", NULL, NULL, offsetof(settings, quiet), "print neither summary nor progress bar"},
    {"--help", NULL, NULL, offsetof(settings, help), "print this text"},
    {"--version", NULL, NULL, offsetof(settings, version), "print the version"},
};

enum { OPTIONS = sizeof options_table / sizeof *options_table };

static void print_help(void) {
    int i;
    printf("paradt [options] INPUT\n\n"
           "Computes the Delaunay or regular triangulation of points in 2 to 8 dimensions, or their convex hull, exactly.\n\n"
           "INPUT: a file, by extension or content (%s; also .gz),\n"
           "       - (standard input, by content or --format), or gen:KIND:N:SEED (generated points)\n\n",
           paradt_io_inputs());
    for (i = 0; i < OPTIONS; i++) {
        char left[40];
        snprintf(left, sizeof left, "%s%s%s", options_table[i].name, options_table[i].value ? " " : "",
                 options_table[i].value ? options_table[i].value : "");
        printf("  %-18s  %s\n", left, options_table[i].about);
    }
    printf(
        "\nOutputs, by extension: %s\n"
        "  .ele comes with .node and .neigh; .off, .ply, .obj and .stl hold the hull in 3D, the triangles in 2D\n"
        "  with --hull: .off, .ply, .obj and .stl, and .npy and .csv, the array of facets\n"
        "  of --voronoi: .csv, .npy (a row a point: index, volume, centroid, number of faces), .vtu, .svg and .png;\n"
        "  of --locate and --nearest, whose Q is as INPUT: .csv, .npy (a row a query) and .vtu;\n"
        "  for these three - is a .csv on standard output, instead of the summary\n\nMethods:",
        paradt_io_outputs());
    for (i = 0; i < PARADT_METHOD_COUNT; i++)
        printf(" %s", paradt_method_string((paradt_method)i));
    printf("\n\nKinds of points for gen:KIND:N:SEED:\n");
    for (i = 0; i < paradt_gen_kinds(); i++)
        printf("  %-18s  %s\n", paradt_gen_name(i), paradt_gen_about(i));
    printf("\nExit status: 0 done, 1 failed, 2 wrong usage, 3 input that can't be read or is not finite\n");
}

// Reads the first of the `left` arguments as an option. Its value follows "=" or is the next argument. Returns the
// number of arguments read, or 0 after an error.
static int take_option(settings *s, int left, char **arguments) {
    const char *text = arguments[0], *equals = strncmp(text, "--", 2) == 0 ? strchr(text, '=') : NULL, *value, *reason;
    size_t n = equals ? (size_t)(equals - text) : strlen(text);
    int i;
    for (i = 0; i < OPTIONS; i++)
        if (strlen(options_table[i].name) == n && memcmp(options_table[i].name, text, n) == 0)
            break;
    if (i == OPTIONS)
        return wrong(text, NULL, "no such option");
    if (!options_table[i].take) {
        if (equals)
            return wrong(text, NULL, "this option takes no value");
        *(int *)((char *)s + options_table[i].flag) = 1;
        return 1;
    }
    value = equals ? equals + 1 : left > 1 ? arguments[1] : NULL;
    if (!value)
        return wrong(text, NULL, "its value is missing");
    reason = options_table[i].take(s, value);
    if (reason)
        return wrong(text, equals ? NULL : value, reason);
    return equals ? 1 : 2;
}

// Checks that what is asked of the cells goes together. Returns 1, or 0 after an error.
static int check_questions(const settings *s) {
    static const char *const names[] = {"--locate", "--nearest"};
    size_t texts = s->stats && strcmp(s->stats, "-") == 0, inputs = strcmp(s->input, "-") == 0, i;
    const char *question = s->voronoi_count ? "--voronoi" : NULL;
    for (i = 0; i < s->voronoi_count; i++)
        texts += strcmp(s->voronoi[i], "-") == 0;
    for (i = 0; i < QUERIES; i++)
        if (s->queries[i]) {
            question = names[i];
            inputs += strcmp(s->queries[i], "-") == 0;
            texts += strcmp(s->answers[i], "-") == 0;
        }
    if (question && s->hull)
        return wrong(question, NULL, "a hull has no cells; leave --hull out");
    if (question && s->furthest)
        return wrong(question, NULL, "not of a furthest-site triangulation; leave --furthest out");
    if (s->box_count && !s->voronoi_count)
        return wrong("--box", NULL, "it clips what --voronoi writes, which is missing");
    if (texts > 1)
        return wrong("-", NULL, "standard output can take one of the statistics, the cells and the answers");
    if (inputs > 1)
        return wrong("-", NULL, "standard input can be read once");
    return 1;
}

// Reads the command line. Returns 1, or 0 after an error.
static int parse(settings *s, int count, char **arguments) {
    int i, only_names = 0;
    for (i = 1; i < count;) {
        const char *text = arguments[i];
        if (!only_names && strcmp(text, "--") == 0) {
            only_names = 1;
            i++;
        } else if (!only_names && text[0] == '-' && text[1]) {
            int taken = take_option(s, count - i, arguments + i);
            if (!taken)
                return 0;
            i += taken;
        } else if (s->input)
            return wrong(text, NULL, "a second input; there can be only one");
        else
            s->input = arguments[i++];
    }
    if (!s->input && !s->help && !s->version)
        return wrong("no input", NULL, "name a file, - or gen:KIND:N:SEED");
    if (s->want.radii)
        s->want.weights = 1;
    if (s->hull && s->want.weights)
        return wrong("--hull", NULL, "a hull has no weights; --dim leaves the column of weights out");
    if (s->hull && s->method != PARADT_AUTO)
        return wrong("--hull", NULL, "--method is for triangulations");
    if (s->furthest && s->hull)
        return wrong("--furthest", NULL, "a hull has no sites; give --hull or --furthest");
    if (s->furthest && s->method != PARADT_AUTO && s->method != PARADT_LIFTED_HULL)
        return wrong("--furthest", NULL, "only the method lifted-hull makes furthest-site triangulations");
    if (s->furthest && s->check)
        return wrong("--furthest", NULL, "--check certifies Delaunay and regular triangulations and hulls");
    return s->help || s->version || check_questions(s);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>work: threads, progress, time

// The threads of parallel_for, which a triangulation calls some dozens of times. A thread is created by the first call
// that needs one and then waits from call to call: waking a thread takes less time than creating one.
typedef struct team {
    size_t jobs;    // threads wanted, the caller's among them
    size_t started; // threads created
    pthread_t threads[MAX_JOBS];
    pthread_mutex_t lock;  // guards the members below
    pthread_cond_t called; // there are tasks, or `over` is set
    pthread_cond_t done;   // the last task has ended
    void (*task)(void *context, size_t index);
    void *context;
    size_t count; // of tasks
    size_t next;  // first task that has not begun
    size_t left;  // tasks that have not ended
    int over;     // the threads have to end
} team;

// The `user` of the callbacks
typedef struct work {
    team team;
    pthread_mutex_t lock; // guards the bar
    paradt_io_bar bar;
} work;

// Runs tasks until all have begun. The caller holds the lock, which is released while a task runs.
static void run_tasks(team *t) {
    while (t->next < t->count) {
        size_t index = t->next++;
        pthread_mutex_unlock(&t->lock);
        t->task(t->context, index);
        pthread_mutex_lock(&t->lock);
        if (--t->left == 0)
            pthread_cond_signal(&t->done);
    }
}

// The function of each created thread
static void *take_part(void *argument) {
    team *t = (team *)argument;
    pthread_mutex_lock(&t->lock);
    while (!t->over) {
        run_tasks(t);
        if (!t->over)
            pthread_cond_wait(&t->called, &t->lock);
    }
    pthread_mutex_unlock(&t->lock);
    return NULL;
}

// A paradt_parallel_for. If threads can't be created, fewer share the tasks; the calling thread always takes part.
static void parallel_for(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    team *t = &((work *)user)->team;
    size_t wanted = t->jobs < count ? t->jobs : count;
    pthread_mutex_lock(&t->lock);
    t->task = task;
    t->context = context;
    t->next = 0;
    t->count = t->left = count;
    while (t->started + 1 < wanted && pthread_create(&t->threads[t->started], NULL, take_part, t) == 0)
        t->started++;
    pthread_cond_broadcast(&t->called);
    run_tasks(t);
    while (t->left)
        pthread_cond_wait(&t->done, &t->lock);
    pthread_mutex_unlock(&t->lock);
}

static void work_begin(work *w, size_t jobs) {
    memset(w, 0, sizeof *w);
    w->team.jobs = jobs;
    pthread_mutex_init(&w->lock, NULL);
    pthread_mutex_init(&w->team.lock, NULL);
    pthread_cond_init(&w->team.called, NULL);
    pthread_cond_init(&w->team.done, NULL);
    paradt_io_bar_begin(&w->bar);
}

static void work_end(work *w) {
    team *t = &w->team;
    size_t i;
    paradt_io_bar_clear(&w->bar);
    pthread_mutex_lock(&t->lock);
    t->over = 1;
    pthread_cond_broadcast(&t->called);
    pthread_mutex_unlock(&t->lock);
    for (i = 0; i < t->started; i++)
        pthread_join(t->threads[i], NULL);
    pthread_cond_destroy(&t->done);
    pthread_cond_destroy(&t->called);
    pthread_mutex_destroy(&t->lock);
    pthread_mutex_destroy(&w->lock);
}

// A paradt_progress
static int show_progress(void *user, double fraction) {
    work *w = (work *)user;
    pthread_mutex_lock(&w->lock);
    paradt_io_bar_draw(&w->bar, fraction);
    pthread_mutex_unlock(&w->lock);
    return 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>report

typedef struct job {
    const settings *s;
    paradt_io_points points;
    paradt_triangulation t;
    paradt_hull hull; // with --hull; then `t` is empty but for its dimension and statistics
    paradt_voronoi voronoi;             // with --voronoi
    paradt_io_points queries[QUERIES];  // with --locate, --nearest
    paradt_io_answers answers[QUERIES]; // their values are from malloc
    size_t regions;
    size_t jobs;
    double seconds; // wall time of the triangulation, without reading, writing and checking
    double check_seconds;
    double voronoi_seconds;
    double locator_seconds;
    double query_seconds[QUERIES];
} job;

// The fields of paradt_stats that the JSON has under their own names. `seconds` is not among them: the JSON's is
// measured here, around the call.
// clang-format off
#define COUNTERS(X)                                                                                                    \
    X(cells) X(hull_facets) X(duplicates) X(hidden) X(distance_evaluations) X(grid_cells_visited) X(active_peak)       \
    X(orient_calls) X(insphere_calls) X(exact_small) X(exact_fixed) X(exact_general) X(perturbed) X(regions)           \
    X(cells_recomputed) X(history_nodes) X(peak_bytes)
// clang-format on
#define TIMERS(X) X(seconds_points) X(seconds_grid) X(seconds_build) X(seconds_finish)

typedef struct text {
    char *at;    // where the next character goes
    size_t left; // bytes from there to the end of the buffer
} text;

// Appends to a text. The buffer has to be large enough.
static void say(text *out, const char *format, ...) PARADT_IO__FORMAT(2, 3);

static void say(text *out, const char *format, ...) {
    va_list arguments;
    int n;
    va_start(arguments, format);
    n = vsnprintf(out->at, out->left, format, arguments);
    va_end(arguments);
    out->at += n;
    out->left -= (size_t)n;
}

// Appends a JSON string.
static void say_string(text *out, const char *string) {
    say(out, "\"");
    for (; *string; string++)
        if ((unsigned char)*string < 32 || *string == '"' || *string == '\\' || *string == 127)
            say(out, "\\u%04x", (unsigned)(unsigned char)*string);
        else
            say(out, "%c", *string);
    say(out, "\"");
}

// How well the cells are shaped, of points that span their dimension
typedef struct shapes {
    double radius;       // of the largest min-containment sphere
    size_t self_centred; // cells that hold the centres of their circumspheres; with weights, of their power spheres
} shapes;

// Finds the vertices of a cell and their weights. Returns the square of its longest edge.
static double cell_vertices(const job *j, size_t cell, const double **vertices, double *weights) {
    int dim = j->t.dim, i, k, axis;
    double longest = 0;
    for (i = 0; i <= dim; i++) {
        size_t vertex = (size_t)j->t.cells[cell * (size_t)(dim + 1) + (size_t)i];
        vertices[i] = j->points.coordinates + vertex * (size_t)dim;
        weights[i] = j->points.weights ? j->points.weights[vertex] : 0;
        for (k = 0; k < i; k++) {
            double square = 0;
            for (axis = 0; axis < dim; axis++) {
                double x = vertices[i][axis] - vertices[k][axis];
                square += x * x;
            }
            longest = square > longest ? square : longest;
        }
    }
    return longest;
}

// A sphere around a cell whose longest edge is e has a radius of e / 2 at least, and of e sqrt(d / (2 d + 2)) at most
// (Jung). So few cells are measured.
static shapes measure_shapes(const job *j) {
    const double rounded = 1 + 1e-12, most = j->t.dim / (2.0 * j->t.dim + 2) * rounded;
    const double *vertices[PARADT_MAX_DIM + 1];
    double weights[PARADT_MAX_DIM + 1], centre[PARADT_MAX_DIM], longest = 0, largest = 0, square;
    shapes found = {0, 0};
    size_t cell;
    for (cell = 0; cell < j->t.cell_count; cell++) {
        square = cell_vertices(j, cell, vertices, weights);
        longest = square > longest ? square : longest;
        found.self_centred += (size_t)paradt_is_self_centred(j->t.dim, vertices, j->points.weights ? weights : NULL);
    }
    for (cell = 0; cell < j->t.cell_count; cell++) {
        double possible = cell_vertices(j, cell, vertices, weights) * most;
        if (possible < longest / 4 / rounded || possible < largest)
            continue;
        paradt_enclosing_sphere(j->t.dim, vertices, centre, &square);
        largest = square > largest ? square : largest;
    }
    found.radius = sqrt(largest);
    return found;
}

// Appends a number, or null if it is too large for a double.
static void say_number(text *out, const char *name, double value) {
    if (value <= DBL_MAX)
        say(out, "  \"%s\": %.17g,\n", name, value);
    else
        say(out, "  \"%s\": null,\n", name);
}

// Appends what the JSON says of a hull.
static void say_hull(text *out, const paradt_hull *hull) {
    static const char *const names[] = {"hull_area", "hull_area_error", "hull_volume", "hull_volume_error"};
    const double values[] = {hull->area, hull->area_error, hull->volume, hull->volume_error};
    int i;
    say(out, "  \"hull_vertices\": %zu,\n  \"hull_points\": %zu,\n  \"hull_planes\": %zu,\n", hull->extreme_count,
        hull->vertex_count, hull->plane_count);
    for (i = 0; i < 4; i++)
        say_number(out, names[i], values[i]);
}

// Appends what the JSON says of the Voronoi diagram and of the queries.
static void say_questions(text *out, const job *j) {
    static const char *const names[] = {"seconds_locate", "seconds_nearest"};
    int i;
    if (j->s->voronoi_count) {
        say_number(out, "voronoi_volume", j->voronoi.volume);
        say(out, "  \"voronoi_faces\": %zu,\n  \"seconds_voronoi\": %.6f,\n", j->voronoi.face_count,
            j->voronoi_seconds);
    }
    if (j->s->queries[LOCATE] || j->s->queries[NEAREST])
        say(out, "  \"seconds_locator\": %.6f,\n", j->locator_seconds);
    for (i = 0; i < QUERIES; i++)
        if (j->s->queries[i])
            say(out, "  \"%s\": %.6f,\n", names[i], j->query_seconds[i]);
}

// Appends how many flips replaced one simplex of a circuit, two simplices, and so on.
static void say_flips(text *out, const paradt_stats *stats) {
    size_t i, last = sizeof stats->flips / sizeof *stats->flips - 1;
    while (last > 1 && !stats->flips[last]) last--;
    say(out, "  \"flips\": [");
    for (i = 1; i <= last; i++)
        say(out, "%s%" PRIu64, i > 1 ? ", " : "", stats->flips[i]);
    say(out, "],\n");
}

static uint64_t hash_of(const job *j) {
    return j->s->hull ? paradt_hull_hash(&j->hull) : paradt_hash(&j->t);
}

// Returns the statistics as JSON, from malloc; NULL if there is no memory.
static char *make_stats(const job *j) {
    size_t capacity = 8192 + 6 * strlen(j->s->input); // an escaped character takes 6
    char *result = (char *)malloc(capacity);
    text out;
    if (!result)
        return NULL;
    out.at = result;
    out.left = capacity;
    say(&out, "{\n  \"version\": \"%d.%d.%d\",\n  \"input\": ", PARADT_VERSION / 10000, PARADT_VERSION / 100 % 100,
        PARADT_VERSION % 100);
    say_string(&out, j->s->input);
    say(&out, ",\n  \"points\": %zu,\n  \"dim\": %d,\n  \"affine_dim\": %d,\n  \"weights\": %s,\n", j->points.count,
        j->points.dim, j->t.dim, j->points.weights ? "true" : "false");
    say(&out, "  \"method\": \"%s\",\n  \"partition\": \"%s\",\n  \"jobs\": %zu,\n  \"certified\": %s,\n",
        paradt_method_string(j->s->method), j->s->partition == PARADT_UNIFORM ? "uniform" : "bisection", j->jobs,
        j->s->check ? "true" : "false");
    if (j->s->hash)
        say(&out, "  \"hash\": \"%016" PRIx64 "\",\n", hash_of(j));
    if (j->s->hull)
        say_hull(&out, &j->hull);
#define SAY_COUNTER(field) say(&out, "  \"%s\": %" PRIu64 ",\n", #field, j->t.stats.field);
#define SAY_TIMER(field)   say(&out, "  \"%s\": %.6f,\n", #field, j->t.stats.field);
    COUNTERS(SAY_COUNTER)
    TIMERS(SAY_TIMER)
    if (j->s->method == PARADT_FLIP)
        say_flips(&out, &j->t.stats);
    if (!j->s->hull && j->t.dim == j->points.dim) {
        shapes found = measure_shapes(j);
        say(&out, "  \"max_min_containment_radius\": ");
        say(&out, isfinite(found.radius) ? "%.17g" : "null", found.radius);
        say(&out, ",\n  \"self_centred_cells\": %zu,\n", found.self_centred);
    }
    say_questions(&out, j);
    say(&out, "  \"seconds\": %.6f\n}\n", j->seconds);
    return result;
}

static void print_points(const job *j) {
    static const char *const flats[] = {"at one place", "on one line", "in one plane"};
    printf("points       %zu in %d dimensions", j->points.count, j->points.dim);
    if (j->t.dim >= 0 && j->t.dim < j->points.dim) {
        if (j->t.dim <= 2)
            printf(", all %s", flats[j->t.dim]);
        else
            printf(", all in a flat of dimension %d", j->t.dim);
    }
    printf("\n");
}

static void print_outputs(const job *j) {
    size_t i;
    if (j->s->check)
        printf("certified    in %.3f s\n", j->check_seconds);
    if (j->s->voronoi_count)
        printf("voronoi      %zu faces, volume %.15g, in %.3f s\n", j->voronoi.face_count, j->voronoi.volume,
               j->voronoi_seconds);
    if (j->s->queries[LOCATE])
        printf("located      %zu queries in %.3f s\n", j->queries[LOCATE].count, j->query_seconds[LOCATE]);
    if (j->s->queries[NEAREST])
        printf("nearest      of %zu queries in %.3f s\n", j->queries[NEAREST].count, j->query_seconds[NEAREST]);
    for (i = 0; i < j->s->output_count; i++)
        printf("wrote        %s\n", j->s->outputs[i]);
    for (i = 0; i < j->s->voronoi_count; i++)
        printf("wrote        %s\n", j->s->voronoi[i]);
    for (i = 0; i < QUERIES; i++)
        if (j->s->queries[i])
            printf("wrote        %s\n", j->s->answers[i]);
}

static void print_hull_summary(const job *j) {
    const paradt_hull *hull = &j->hull;
    print_points(j);
    printf("hull facets  %zu in %zu planes\nvertices     %zu, %zu of them extreme\n", hull->facet_count,
           hull->plane_count, hull->vertex_count, hull->extreme_count);
    printf("area         %.15g\nvolume       %.15g\n", hull->area, hull->volume);
    printf("time         %.3f s (%zu job%s)\n", j->seconds, j->jobs, j->jobs == 1 ? "" : "s");
    print_outputs(j);
}

static void print_summary(const job *j) {
    const paradt_stats *stats = &j->t.stats;
    print_points(j);
    printf("cells        %zu\nhull facets  %" PRIu64 "\nduplicates   %" PRIu64 "\n", j->t.cell_count,
           stats->hull_facets, stats->duplicates);
    if (j->points.weights)
        printf("hidden       %" PRIu64 "\n", stats->hidden);
    printf("time         %.3f s", j->seconds);
    if (j->seconds > 0 && j->t.cell_count)
        printf(", %.0f cells a second", (double)j->t.cell_count / j->seconds);
    printf(" (%s, %zu job%s, %" PRIu64 " region%s)\n", paradt_method_string(j->s->method), j->jobs,
           j->jobs == 1 ? "" : "s", stats->regions, stats->regions == 1 ? "" : "s");
    print_outputs(j);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>main

static paradt_io_stage stage; // the temporary files, which a signal handler removes

static int exit_status(paradt_io_status status) {
    static const int statuses[] = {EXIT_DONE, EXIT_INPUT, EXIT_USAGE, EXIT_FAILED};
    return statuses[status];
}

static int io_failed(const paradt_io_error *error) {
    return fail(exit_status(error->status), error->text);
}

// Checks that the box has the points' dimension and an inside. Returns 1, or 0 after an error.
static int check_box(const settings *s, int dim, paradt_io_error *error) {
    int k;
    error->status = PARADT_IO_BAD_NAME;
    if (s->box_count != 2 * dim) {
        snprintf(error->text, sizeof error->text, "--box: %d numbers where %d are needed, two a dimension",
                 s->box_count, 2 * dim);
        return 0;
    }
    for (k = 0; k < dim; k++)
        if (!(s->box[k] < s->box[dim + k])) {
            snprintf(error->text, sizeof error->text, "--box: the lower bound %d is not below the upper one", k + 1);
            return 0;
        }
    return 1;
}

// Checks that all outputs can be written. dim: of the points; 0: not known yet. Returns 1, or 0 after an error.
static int check_outputs(const settings *s, int dim, paradt_io_error *error) {
    size_t i;
    for (i = 0; i < s->output_count; i++)
        if (!(s->hull ? paradt_io_check_hull_output : paradt_io_check_output)(s->outputs[i], dim, s->input, error))
            return 0;
    for (i = 0; i < s->voronoi_count; i++)
        if (!paradt_io_check_voronoi_output(s->voronoi[i], dim, s->input, error))
            return 0;
    for (i = 0; i < QUERIES; i++)
        if (s->queries[i] && (!paradt_io_check_answers_output(s->answers[i], dim, s->input, error) ||
                              !paradt_io_check_answers_output(s->answers[i], dim, s->queries[i], error)))
            return 0;
    if (s->box_count && dim && !check_box(s, dim, error))
        return 0;
    return !s->stats || strcmp(s->stats, "-") == 0 || paradt_io_check_place(s->stats, s->input, error);
}

// Chooses the numbers of threads and regions that the settings leave open.
static void plan(job *j) {
    const settings *s = j->s;
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    j->jobs = s->jobs ? s->jobs : processors < 1 ? 1 : processors > MAX_JOBS ? MAX_JOBS : (size_t)processors;
    j->regions = j->points.count / POINTS_PER_REGION;
    if (j->regions > j->jobs || s->hull) // the tasks of a hull divide no space
        j->regions = j->jobs;
    if (j->regions < 1)
        j->regions = 1;
    if (s->regions)
        j->regions = s->regions;
}

// Writes what the check found. cell: what the result is made of
static void describe_fault(char *reason, size_t size, const paradt_fault *fault, const char *cell) {
    text out;
    out.at = reason;
    out.left = size;
    say(&out, "the check found: %.200s", fault->reason);
    if (fault->cell >= 0)
        say(&out, ", %s %lld", cell, (long long)fault->cell);
    if (fault->point >= 0)
        say(&out, ", point %lld", (long long)fault->point);
}

// Triangulates the points, or computes their hull. Returns the status.
static paradt_status compute(job *j, const paradt_points *points, const paradt_options *options) {
    paradt_status status;
    if (!j->s->hull)
        return paradt_triangulate(&j->t, points, options);
    status = paradt_hull_compute(&j->hull, points, options);
    j->t.dim = j->hull.dim;
    j->t.stats = j->hull.stats;
    return status;
}

static paradt_status certify(const job *j, const paradt_points *points, const paradt_options *options,
                             paradt_fault *fault) {
    if (j->s->hull)
        return paradt_hull_check(&j->hull, points, options, fault);
    return paradt_check(&j->t, points, options, fault);
}

// Computes the Voronoi diagram: what the files need, and the volumes. Returns the status.
static paradt_status compute_voronoi(job *j, const paradt_points *points, const paradt_options *options) {
    paradt_voronoi_request request;
    paradt_options own = *options;
    paradt_status status;
    double begun = paradt_io_now();
    size_t i;
    memset(&request, 0, sizeof request);
    request.outputs = PARADT_VORONOI_VOLUMES | PARADT_VORONOI_FACES;
    for (i = 0; i < j->s->voronoi_count; i++)
        request.outputs |= paradt_io_voronoi_needs(j->s->voronoi[i], points->dim);
    request.box = j->s->box_count ? j->s->box : NULL;
    own.regions = 4 * j->jobs;
    status = paradt_voronoi_compute(&j->voronoi, &j->t, points, &request, &own);
    j->voronoi_seconds = paradt_io_now() - begun;
    return status;
}

// Answers the queries of one kind. Returns the status.
static paradt_status answer(job *j, query which, const paradt_locator *locator, const paradt_options *options) {
    static const char *const titles[QUERIES][2] = {{"cell", "face"}, {"nearest", NULL}};
    const paradt_io_points *queries = &j->queries[which];
    size_t count = queries->count, i;
    int columns = which == LOCATE ? 2 : 1;
    paradt_points places = paradt_points_f64(queries->coordinates, count, queries->dim);
    paradt_location *found = which == LOCATE ? (paradt_location *)malloc((count + 1) * sizeof *found) : NULL;
    paradt_index *values = (paradt_index *)malloc((count + 1) * (size_t)columns * sizeof *values);
    paradt_status status = PARADT_ERROR_MEMORY;
    double begun = paradt_io_now();
    j->answers[which].queries = queries;
    j->answers[which].titles = titles[which];
    j->answers[which].columns = columns;
    j->answers[which].values = values;
    if (values && which == NEAREST)
        status = paradt_nearest(locator, &places, values, options);
    else if (values && found)
        status = paradt_locate(locator, &places, found, options);
    j->query_seconds[which] = paradt_io_now() - begun;
    for (i = 0; !status && which == LOCATE && i < count; i++) {
        values[2 * i] = found[i].cell;
        values[2 * i + 1] = (paradt_index)found[i].face;
    }
    free(found);
    return status;
}

// Answers all queries. Returns the status.
static paradt_status answer_all(job *j, const paradt_points *points, const paradt_options *options) {
    paradt_locator *locator;
    double begun = paradt_io_now();
    paradt_status status = paradt_locator_create(&locator, &j->t, points, options);
    j->locator_seconds = paradt_io_now() - begun;
    if (!status && j->s->queries[LOCATE])
        status = answer(j, LOCATE, locator, options);
    if (!status && j->s->queries[NEAREST])
        status = answer(j, NEAREST, locator, options);
    paradt_locator_free(locator);
    return status;
}

// Computes what is asked of the triangulation. reason: receives the text of an error. Returns the status.
static paradt_status ask(job *j, const paradt_points *points, const paradt_options *options, char *reason,
                         size_t size) {
    paradt_status status = PARADT_OK;
    if (j->s->voronoi_count && (status = compute_voronoi(j, points, options)) != PARADT_OK)
        snprintf(reason, size, "the Voronoi diagram: %s",
                 j->voronoi.error_text ? j->voronoi.error_text : paradt_status_string(status));
    else if ((j->s->queries[LOCATE] || j->s->queries[NEAREST]) &&
             (status = answer_all(j, points, options)) != PARADT_OK)
        snprintf(reason, size, "the queries: %s", paradt_status_string(status));
    return status;
}

// Triangulates the points; if asked to, certifies the result, makes the Voronoi diagram, and answers queries. Returns the
// exit status.
static int triangulate(job *j) {
    paradt_points points;
    paradt_options options;
    paradt_fault fault = {NULL, -1, -1};
    paradt_status status;
    work w;
    char reason[300];
    memset(&points, 0, sizeof points);
    memset(&options, 0, sizeof options);
    points.data = j->points.coordinates;
    points.count = j->points.count;
    points.dim = j->points.dim;
    points.weights = j->points.weights;
    options.method = j->s->method;
    options.partition = j->s->partition;
    options.regions = j->regions;
    options.flags = PARADT_FACETS; // which spares paradt_check the matching of facets
    if (j->s->furthest)
        options.flags |= PARADT_FURTHEST_SITE;
    options.parallel_for = j->jobs > 1 ? parallel_for : NULL;
    options.progress = !j->s->quiet && isatty(STDERR_FILENO) ? show_progress : NULL;
    options.user = &w;
    work_begin(&w, j->jobs);
    status = compute(j, &points, &options);
    j->seconds = paradt_io_now() - w.bar.begun;
    snprintf(reason, sizeof reason, "%s", paradt_status_string(status));
    if (!status && j->s->check) {
        status = certify(j, &points, &options, &fault);
        j->check_seconds = paradt_io_now() - w.bar.begun - j->seconds;
        snprintf(reason, sizeof reason, "the check can't be done: %s", paradt_status_string(status));
        if (fault.reason)
            describe_fault(reason, sizeof reason, &fault, j->s->hull ? "facet" : "cell");
    }
    if (!status)
        status = ask(j, &points, &options, reason, sizeof reason);
    work_end(&w);
    if (!status)
        return EXIT_DONE;
    fprintf(stderr, "paradt: %s: %s\n", j->s->input, reason);
    return EXIT_FAILED;
}

// Writes all outputs into the stage. stats: the JSON; NULL: not wanted. Returns 1, or 0 after an error.
static int write_all(const job *j, const char *stats, paradt_io_error *error) {
    const settings *s = j->s;
    size_t i;
    for (i = 0; i < s->output_count; i++)
        if (!(s->hull ? paradt_io_write_hull(&stage, s->outputs[i], &j->points, j->hull.facets, j->hull.facet_count,
                                             j->hull.dim, error)
                      : paradt_io_write(&stage, s->outputs[i], &j->points, &j->t, error)))
            return 0;
    for (i = 0; i < s->voronoi_count; i++)
        if (strcmp(s->voronoi[i], "-") != 0 &&
            !paradt_io_write_voronoi(&stage, s->voronoi[i], &j->points, &j->voronoi, s->box_count > 0, error))
            return 0;
    for (i = 0; i < QUERIES; i++)
        if (s->queries[i] && strcmp(s->answers[i], "-") != 0 &&
            !paradt_io_write_answers(&stage, s->answers[i], &j->answers[i], error))
            return 0;
    if (stats && strcmp(s->stats, "-") != 0 && !paradt_io_write_text(&stage, s->stats, stats, error))
        return 0;
    return 1;
}

// Returns the exit status.
static int flush_output(void) {
    return fflush(stdout) == 0 && !ferror(stdout) ? EXIT_DONE : fail(EXIT_FAILED, "standard output can't be written");
}

// Prints cells or answers, if they go to standard output. *printed: set to 1 if so. Returns 1, or 0 after an error.
static int print_questions(const job *j, int *printed, paradt_io_error *error) {
    const settings *s = j->s;
    size_t i;
    for (i = 0; i < s->voronoi_count; i++)
        if (strcmp(s->voronoi[i], "-") == 0) {
            *printed = 1;
            return paradt_io_write_voronoi(&stage, "-", &j->points, &j->voronoi, s->box_count > 0, error);
        }
    for (i = 0; i < QUERIES; i++)
        if (s->queries[i] && strcmp(s->answers[i], "-") == 0) {
            *printed = 1;
            return paradt_io_write_answers(&stage, "-", &j->answers[i], error);
        }
    return 1;
}

// Prints what goes to standard output. Returns the exit status.
static int print_all(const job *j, const char *stats) {
    const settings *s = j->s;
    paradt_io_error error;
    int printed = 0;
    if (!print_questions(j, &printed, &error))
        return io_failed(&error);
    if (stats && strcmp(s->stats, "-") == 0)
        fputs(stats, stdout);
    else if (!s->quiet && s->hull)
        print_hull_summary(j);
    else if (!s->quiet && !printed)
        print_summary(j);
    if (s->hash)
        printf("%016" PRIx64 "\n", hash_of(j));
    return flush_output();
}

// Writes and prints the result. The outputs get their names only after everything is written and printed. Returns the
// exit status.
static int finish(const job *j) {
    paradt_io_error error;
    char *stats = NULL;
    int status;
    if (j->s->stats && !(stats = make_stats(j)))
        return fail(EXIT_FAILED, "not enough memory");
    if (!paradt_io_stage_init(&stage, j->s->output_count * PARADT_IO_FILES_PER_OUTPUT + j->s->voronoi_count + QUERIES + 1,
                              &error) ||
        !write_all(j, stats, &error))
        status = io_failed(&error);
    else {
        status = print_all(j, stats);
        if (!status && !paradt_io_stage_commit(&stage, &error))
            status = io_failed(&error);
    }
    if (status)
        paradt_io_stage_abort(&stage);
    paradt_io_stage_free(&stage);
    free(stats);
    return status;
}

// Reads an input, and prints what is to be known of it. Returns 1, or 0 after an error.
static int read_input(paradt_io_points *points, const char *input, const paradt_io_want *want, paradt_io_error *error) {
    if (!paradt_io_read(points, input, want, error))
        return 0;
    if (*points->note)
        fprintf(stderr, "paradt: %s: %s\n", strcmp(input, "-") == 0 ? "standard input" : input, points->note);
    return 1;
}

// Reads the points and the queries. Returns 1, or 0 after an error.
static int read_all(job *j, paradt_io_error *error) {
    const settings *s = j->s;
    paradt_io_want want = {0, 0, 0, NULL, NULL};
    int i;
    if (!check_outputs(s, s->want.dim, error) || !read_input(&j->points, s->input, &s->want, error) ||
        !check_outputs(s, j->points.dim, error))
        return 0;
    want.dim = j->points.dim;
    for (i = 0; i < QUERIES; i++)
        if (s->queries[i] && !read_input(&j->queries[i], s->queries[i], &want, error))
            return 0;
    return 1;
}

static void job_free(job *j) {
    int i;
    for (i = 0; i < QUERIES; i++) {
        free((void *)(uintptr_t)j->answers[i].values);
        paradt_io_free(&j->queries[i]);
    }
    paradt_voronoi_free(&j->voronoi);
    paradt_free(&j->t);
    paradt_hull_free(&j->hull);
    paradt_io_free(&j->points);
}

static int run(const settings *s) {
    paradt_io_error error;
    job j;
    int status;
    memset(&j, 0, sizeof j);
    j.s = s;
    if (!read_all(&j, &error))
        status = io_failed(&error);
    else {
        plan(&j);
        status = triangulate(&j);
        if (!status)
            status = finish(&j);
    }
    job_free(&j);
    return status;
}

int main(int count, char **arguments) {
    settings s;
    int status, i;
    memset(&s, 0, sizeof s);
    s.outputs = (const char **)malloc(2 * (size_t)count * sizeof *s.outputs);
    if (!s.outputs)
        return fail(EXIT_FAILED, "not enough memory");
    s.voronoi = s.outputs + count;
    paradt_io_stage_guard(&stage);
    status = parse(&s, count, arguments) ? EXIT_DONE : EXIT_USAGE;
    if (!status && s.help)
        print_help();
    else if (!status && s.version)
        printf("paradt %d.%d.%d\n", PARADT_VERSION / 10000, PARADT_VERSION / 100 % 100, PARADT_VERSION % 100);
    else if (!status)
        status = run(&s);
    if (!status)
        status = flush_output();
    free(s.outputs);
    for (i = 0; i < QUERIES; i++)
        free(s.queries[i]);
    return status;
}
