// paradt_io.h - reads point sets and writes triangulations, for the command-line tools
//
// In one file: #define PARADT_IO_IMPLEMENTATION, then #include "paradt_io.h". Needs C99 and POSIX with XSI: include
// this header before any system header, or define _XOPEN_SOURCE as 700. The process has to be in the "C" locale.
//
//     paradt_io_points points;
//     paradt_io_error  error;
//     if (!paradt_io_read(&points, "cloud.ply", NULL, &error)) fprintf(stderr, "%s\n", error.text);
//
// Inputs: see paradt_read.h, which this header includes.
//
// Outputs, by extension (paradt_io_outputs lists them):
//   .ele            cells, with .node (points; the first index is 0) and .neigh (neighbours) beside the file
//   .vtu            a binary unstructured grid for ParaView
//   .off .ply .obj  the surface: the facets of the hull if the result has three dimensions or more, its cells if it has
//                   fewer. .off has all points (as nOFF from four dimensions on), .ply and .obj those of the surface.
//   .stl            the same surface as text, from two dimensions on
//   .vtk            a binary legacy file, of the cells as in .vtu
//   .npy .csv       the array of cells; .csv has a title, v0,v1,...
//   .svg .png       a picture (paradt_picture.h)
// A hull alone is written as .off, .ply, .obj or .stl, with all its facets for faces, or as .npy or .csv, the array of
// facets.
//
// Outputs of a Voronoi diagram, a row a point:
//   .csv -          index, volume, centroid and number of faces, below a title. Unbounded cells have the volume inf;
//   what
//                   has no centroid, or more than three dimensions, nan.
//   .npy            the same columns, as float64
//   .vtu            the bounded cells as polyhedra, in the plane as polygons, with their points' indices and volumes
//   .svg .png       a picture
// Outputs of answers to queries, a row a query, integers: .csv and - without a title, .npy, and .vtu: the queries as
// points with the answers as their data. Files are written under temporary names and renamed when all are complete: see
// paradt_io_stage.

#ifndef PARADT_IO_H
#define PARADT_IO_H

#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700
#endif

#ifdef PARADT_IO_IMPLEMENTATION
#define PARADT_READ_IMPLEMENTATION
#endif
#include "paradt_read.h"

#include <signal.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// An output file. It has a temporary name in the folder of its final name until all outputs are complete.
typedef struct paradt_io_staged {
    char *name;
    char *temporary;
    char *former; // during the commit: a second name of the file that has `name`; NULL: there is no such file
} paradt_io_staged;

// All output files of a run
typedef struct paradt_io_stage {
    paradt_io_staged *files;
    size_t capacity;
    volatile sig_atomic_t count;
} paradt_io_stage;

enum { PARADT_IO_FILES_PER_OUTPUT = 3 }; // most files that one paradt_io_write adds to a stage

// Makes an empty stage for `capacity` files. Returns 1, or 0 with the error filled in.
int paradt_io_stage_init(paradt_io_stage *stage, size_t capacity, paradt_io_error *error);
// Gives all files their final names. Returns 1, or 0 with the error filled in: then no new file is left, and files that
// were replaced already are back.
int paradt_io_stage_commit(paradt_io_stage *stage, paradt_io_error *error);
// Removes the temporary files. May be called by a signal handler.
void paradt_io_stage_abort(paradt_io_stage *stage);
// Frees the memory of the stage. Leaves the files alone.
void paradt_io_stage_free(paradt_io_stage *stage);
// Installs signal handlers: a signal that ends the program removes the temporary files of this stage. The stage may
// still be all zero.
void paradt_io_stage_guard(paradt_io_stage *stage);

// Checks that a file of this name can be written and is not the input. input: NULL: none. Returns 1, or 0 with the
// error filled in.
int paradt_io_check_place(const char *name, const char *input, paradt_io_error *error);
// Checks, too, that the extension is known and that the format can hold points of this dimension (0: not known yet).
int paradt_io_check_output(const char *name, int dim, const char *input, paradt_io_error *error);
// Writes one output, of up to PARADT_IO_FILES_PER_OUTPUT files, into the stage. The triangulation has to have
// neighbours as half-facets (PARADT_FACETS), except for .vtu and .npy. Returns 1, or 0 with the error filled in.
int paradt_io_write(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                    const paradt_triangulation *triangulation, paradt_io_error *error);
// The same for the facets of a hull. facets: [count][corners]
int paradt_io_check_hull_output(const char *name, int dim, const char *input, paradt_io_error *error);
int paradt_io_write_hull(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                         const paradt_index *facets, size_t count, int corners, paradt_io_error *error);
#ifndef PARADT_NO_VORONOI
// The same for a Voronoi diagram with volumes and what paradt_io_voronoi_needs says. clipped: 1: to a box
int paradt_io_check_voronoi_output(const char *name, int dim, const char *input, paradt_io_error *error);
int paradt_io_write_voronoi(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                            const paradt_voronoi *voronoi, int clipped, paradt_io_error *error);
unsigned paradt_io_voronoi_needs(const char *name,
                                 int dim); // paradt_voronoi_request.outputs, for an output of this name
#endif

// Answers to queries
typedef struct paradt_io_answers {
    const paradt_io_points *queries;
    const char *const *titles;  // [columns]
    int columns;                // numbers an answer
    const paradt_index *values; // [queries->count][columns]
} paradt_io_answers;

// The same for answers. The name "-" is standard output, which is not of the stage.
int paradt_io_check_answers_output(const char *name, int dim, const char *input, paradt_io_error *error);
int paradt_io_write_answers(paradt_io_stage *stage, const char *name, const paradt_io_answers *answers,
                            paradt_io_error *error);
// Writes a text into the stage as a file. Returns 1, or 0 with the error filled in.
int paradt_io_write_text(paradt_io_stage *stage, const char *name, const char *text, paradt_io_error *error);

const char *paradt_io_outputs(void); // ".ele .vtu ..."

// A progress bar on standard error, for one thread at a time. It appears after a second and is drawn at most ten times
// a second.
typedef struct paradt_io_bar {
    double begun; // time of paradt_io_bar_begin
    double shown; // time when the bar was last drawn; 0: never
} paradt_io_bar;

double paradt_io_now(void); // seconds of a clock that never goes back
void paradt_io_bar_begin(paradt_io_bar *bar);
void paradt_io_bar_draw(paradt_io_bar *bar, double fraction); // fraction: 0 to 1
void paradt_io_bar_clear(const paradt_io_bar *bar);           // removes the bar from the terminal

#ifdef __cplusplus
}
#endif

#endif // PARADT_IO_H

#ifdef PARADT_IO_IMPLEMENTATION
#ifndef PARADT_IO_IMPLEMENTATION_DONE
#define PARADT_IO_IMPLEMENTATION_DONE

#define PARADT_PICTURE_IMPLEMENTATION
#include "paradt_picture.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

// ---------------------------------------------------------------------------------------------------------------------
// >>stage: outputs under temporary names

// Blocks all signals, so that a handler never finds a stage half changed. before: receives the mask to restore
static void paradt_io__hold_signals(sigset_t *before) {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, before);
}

int paradt_io_stage_init(paradt_io_stage *stage, size_t capacity, paradt_io_error *error) {
    stage->count = 0;
    stage->capacity = capacity;
    stage->files = NULL;
    if (capacity <= SIZE_MAX / sizeof *stage->files)
        stage->files = (paradt_io_staged *)malloc((capacity ? capacity : 1) * sizeof *stage->files);
    return stage->files ? 1 : paradt_io__no_memory(error, "output");
}

// Returns the name of the file behind a symbolic link, or else a copy of the name; from malloc.
static char *paradt_io__target(const char *name) {
    struct stat about;
    char *target = NULL;
    if (lstat(name, &about) == 0 && S_ISLNK(about.st_mode))
        target = realpath(name, NULL);
    if (target)
        return target;
    target = (char *)malloc(strlen(name) + 1);
    return target ? strcpy(target, name) : NULL;
}

static int paradt_io__is_staged(const paradt_io_stage *stage, const char *target) {
    size_t i, count = (size_t)stage->count;
    for (i = 0; i < count; i++)
        if (strcmp(stage->files[i].name, target) == 0)
            return 1;
    return 0;
}

// Creates a temporary file in the folder of the file that `name` leads to, with the permissions of a new file. Returns
// its descriptor, or -1 after an error.
static int paradt_io__create(paradt_io_stage *stage, const char *name, paradt_io_error *error) {
    char *copy = paradt_io__target(name), *temporary = copy ? (char *)malloc(strlen(copy) + 8) : NULL;
    size_t n = copy ? strlen(copy) + 1 : 0, at = (size_t)stage->count;
    sigset_t before;
    mode_t mask;
    int fd, reason, twice = copy && paradt_io__is_staged(stage, copy);
    if (!temporary || twice || at == stage->capacity) {
        free(copy);
        free(temporary);
        if (twice)
            paradt_io__error(error, PARADT_IO_BAD_NAME, "%.900s: two outputs of one name", name);
        else
            paradt_io__no_memory(error, name);
        return -1;
    }
    memcpy(temporary, copy, n - 1);
    temporary[n - 1] = '.'; // six letters follow, which mkstemp replaces
    memset(temporary + n, 'X', 6);
    temporary[n + 6] = '\0';
    paradt_io__hold_signals(&before);
    fd = mkstemp(temporary);
    reason = errno;
    if (fd >= 0) {
        stage->files[at].name = copy;
        stage->files[at].temporary = temporary;
        stage->files[at].former = NULL;
        stage->count = (sig_atomic_t)(at + 1);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    if (fd < 0) {
        paradt_io__error(error, PARADT_IO_FAILED, "%.900s: %s", name, strerror(reason));
        free(copy);
        free(temporary);
        return -1;
    }
    mask = umask(0);
    umask(mask);
    fchmod(fd, 0666 & ~mask);
    return fd;
}

// Gives the file that is going to be replaced a second name. If that fails, or there is no such file, `former` is NULL.
static void paradt_io__keep_former(paradt_io_staged *file) {
    size_t size = strlen(file->temporary) + 2;
    file->former = (char *)malloc(size);
    if (!file->former)
        return;
    snprintf(file->former, size, "%s~", file->temporary);
    if (link(file->name, file->former) != 0) {
        free(file->former);
        file->former = NULL;
    }
}

// Removes the second name.
static void paradt_io__drop_former(paradt_io_staged *file) {
    if (file->former)
        unlink(file->former);
    free(file->former);
    file->former = NULL;
}

int paradt_io_stage_commit(paradt_io_stage *stage, paradt_io_error *error) {
    size_t i, count = (size_t)stage->count;
    int good = 1;
    sigset_t before;
    paradt_io__hold_signals(&before);
    for (i = 0; i < count; i++)
        paradt_io__keep_former(stage->files + i);
    for (i = 0; i < count && good; i++)
        if (rename(stage->files[i].temporary, stage->files[i].name) != 0)
            good = paradt_io__error(error, PARADT_IO_FAILED, "%.900s: %s", stage->files[i].name, strerror(errno));
    if (good)
        stage->count = 0;
    else { // file i - 1 could not be renamed; the files before it have their final names
        size_t k;
        for (k = 0; k + 1 < i; k++)
            if (!stage->files[k].former || rename(stage->files[k].former, stage->files[k].name) != 0)
                unlink(stage->files[k].name);
        paradt_io_stage_abort(stage);
    }
    for (i = 0; i < count; i++)
        paradt_io__drop_former(stage->files + i);
    for (i = 0; good && i < count; i++) {
        free(stage->files[i].name);
        free(stage->files[i].temporary);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    return good;
}

void paradt_io_stage_abort(paradt_io_stage *stage) {
    size_t i;
    for (i = 0; i < (size_t)stage->count; i++)
        unlink(stage->files[i].temporary);
}

static paradt_io_stage *paradt_io__guarded;

static void paradt_io__interrupted(int number) {
    static const char said[] = "interrupted\n";
    paradt_io_stage_abort(paradt_io__guarded);
    if (write(STDERR_FILENO, said, sizeof said - 1) < 0) {
        // nobody hears it
    }
    signal(number, SIG_DFL);
    raise(number);
}

void paradt_io_stage_guard(paradt_io_stage *stage) {
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action;
    size_t i;
    paradt_io__guarded = stage;
    memset(&action, 0, sizeof action);
    action.sa_handler = paradt_io__interrupted;
    for (i = 0; i < sizeof numbers / sizeof *numbers; i++)
        sigaction(numbers[i], &action, NULL);
    signal(SIGXFSZ, SIG_IGN); // write reports a file that gets too large
}

void paradt_io_stage_free(paradt_io_stage *stage) {
    size_t count = (size_t)stage->count, i;
    stage->count = 0; // from here on a signal handler finds no files
    for (i = 0; i < count; i++) {
        free(stage->files[i].name);
        free(stage->files[i].temporary);
    }
    free(stage->files);
    stage->files = NULL;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>out: a buffered output file. The first failure is kept, and reported by paradt_io__close.

typedef struct paradt_io__out {
    const char *name;
    int fd;
    int reason;  // errno of the first failure; 0: none
    size_t used; // bytes in the buffer
    unsigned char bytes[1 << 16];
} paradt_io__out;

// name: "-": standard output, to which nothing may be left to be written
static int paradt_io__open(paradt_io__out *out, paradt_io_stage *stage, const char *name, paradt_io_error *error) {
    out->name = name;
    out->reason = 0;
    out->used = 0;
    out->fd = strcmp(name, "-") == 0 ? dup(STDOUT_FILENO) : paradt_io__create(stage, name, error);
    if (out->fd >= 0 || strcmp(name, "-") != 0)
        return out->fd >= 0;
    return paradt_io__error(error, PARADT_IO_FAILED, "standard output: %s", strerror(errno));
}

// Writes to the file, past the buffer.
static void paradt_io__store(paradt_io__out *out, const unsigned char *bytes, size_t size) {
    while (size && !out->reason) {
        ssize_t n = write(out->fd, bytes, size);
        if (n < 0) {
            if (errno != EINTR)
                out->reason = errno;
            continue;
        }
        bytes += n;
        size -= (size_t)n;
    }
}

static void paradt_io__flush(paradt_io__out *out) {
    paradt_io__store(out, out->bytes, out->used);
    out->used = 0;
}

// Closes the file. Returns 1, or 0 after an error of this or an earlier call.
static int paradt_io__close(paradt_io__out *out, paradt_io_error *error) {
    paradt_io__flush(out);
    if (close(out->fd) != 0 && !out->reason)
        out->reason = errno;
    if (!out->reason)
        return 1;
    return paradt_io__error(error, PARADT_IO_FAILED, "%.900s: %s", out->name, strerror(out->reason));
}

static void paradt_io__put(paradt_io__out *out, const void *bytes, size_t size) {
    if (size > sizeof out->bytes - out->used)
        paradt_io__flush(out);
    if (size > sizeof out->bytes) {
        paradt_io__store(out, (const unsigned char *)bytes, size);
        return;
    }
    memcpy(out->bytes + out->used, bytes, size);
    out->used += size;
}

static void paradt_io__put_text(paradt_io__out *out, const char *text) {
    paradt_io__put(out, text, strlen(text));
}

static void paradt_io__putf(paradt_io__out *out, const char *format, ...) PARADT_IO__FORMAT(2, 3);

static void paradt_io__putf(paradt_io__out *out, const char *format, ...) {
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    paradt_io__put_text(out, text);
}

// Writes a character and then the integer in decimal.
static void paradt_io__put_int(paradt_io__out *out, char before, int64_t value) {
    char text[24], *at = text + sizeof text;
    uint64_t rest = value < 0 ? UINT64_C(0) - (uint64_t)value : (uint64_t)value;
    do
        *--at = (char)('0' + rest % 10);
    while (rest /= 10);
    if (value < 0)
        *--at = '-';
    *--at = before;
    paradt_io__put(out, at, (size_t)(text + sizeof text - at));
}

// Writes a character and then a decimal that reads back as the same double; -0 is written as 0. Compares bits, because
// a processor that flushes subnormal numbers to zero would find them equal to zero.
static void paradt_io__put_real(paradt_io__out *out, char before, double value) {
    int64_t whole = value > -1e15 && value < 1e15 ? (int64_t)value : 0;
    double back = (double)whole, negative_zero = -0.0;
    if (memcmp(&back, &value, sizeof value) == 0 || memcmp(&negative_zero, &value, sizeof value) == 0)
        paradt_io__put_int(out, before, whole);
    else
        paradt_io__putf(out, "%c%.17g", before, value);
}

// Writes an integer of 1 to 8 bytes, little-endian.
static void paradt_io__put_bits(paradt_io__out *out, uint64_t bits, int size) {
    unsigned char bytes[8];
    int i;
    for (i = 0; i < size; i++)
        bytes[i] = (unsigned char)(bits >> 8 * i & 0xff);
    paradt_io__put(out, bytes, (size_t)size);
}

static void paradt_io__put_double(paradt_io__out *out, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    paradt_io__put_bits(out, bits, 8);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>writers: one function a format

typedef struct paradt_io__writer {
    paradt_io_stage *stage;
    const char *name; // of the output, as the caller gave it
    const paradt_io_points *points;
    const paradt_triangulation *t; // of a hull: facets for cells
    int hull;                      // 1: of a hull
#ifndef PARADT_NO_VORONOI
    const paradt_voronoi *voronoi;
    int clipped; // 1: the diagram is clipped to a box
#endif
    const paradt_io_answers *answers; // then `points` are the queries
    paradt_io_error *error;
    paradt_io__out out;
} paradt_io__writer;

// Returns coordinate k of a point; zero from the dimension on.
static double paradt_io__coordinate(const paradt_io__writer *w, size_t point, int k) {
    return k < w->points->dim ? w->points->coordinates[point * (size_t)w->points->dim + (size_t)k] : 0.0;
}

// Returns the name with another extension, from malloc; NULL after an error.
static char *paradt_io__beside(const char *name, const char *extension, paradt_io_error *error) {
    size_t stem = (size_t)(paradt_io__extension(name) - name), n = strlen(extension) + 1;
    char *other = (char *)malloc(stem + n);
    if (!other) {
        paradt_io__no_memory(error, name);
        return NULL;
    }
    memcpy(other, name, stem);
    memcpy(other + stem, extension, n);
    return other;
}

static void paradt_io__put_node(paradt_io__writer *w) {
    const paradt_io_points *points = w->points;
    size_t i;
    int k;
    paradt_io__putf(&w->out, "%zu %d %d 0\n", points->count, points->dim, points->weights != NULL);
    for (i = 0; i < points->count; i++) {
        paradt_io__put_int(&w->out, ' ', (int64_t)i);
        for (k = 0; k < points->dim; k++)
            paradt_io__put_real(&w->out, ' ', paradt_io__coordinate(w, i, k));
        if (points->weights)
            paradt_io__put_real(&w->out, ' ', points->weights[i]);
        paradt_io__put(&w->out, "\n", 1);
    }
}

// Writes one line a cell: the number of the cell and its row, each value of it that is not negative over the divisor.
// rows: [cell_count][dim + 1]
static void paradt_io__put_table(paradt_io__writer *w, const paradt_index *rows, int divisor) {
    size_t i, columns = (size_t)(w->t->dim + 1), k;
    for (i = 0; i < w->t->cell_count; i++) {
        paradt_io__put_int(&w->out, ' ', (int64_t)i);
        for (k = 0; k < columns; k++) {
            paradt_index value = rows[i * columns + k];
            paradt_io__put_int(&w->out, ' ', (int64_t)(value < 0 ? value : value / divisor));
        }
        paradt_io__put(&w->out, "\n", 1);
    }
}

static void paradt_io__put_ele(paradt_io__writer *w) {
    paradt_io__putf(&w->out, "%zu %d 0\n", w->t->cell_count, w->t->dim + 1);
    paradt_io__put_table(w, w->t->cells, 1);
}

static void paradt_io__put_neigh(paradt_io__writer *w) {
    size_t rows = w->t->neighbors ? w->t->cell_count : 0; // a single point has none
    paradt_io__putf(&w->out, "%zu %d\n", rows, w->t->dim + 1);
    if (rows)
        paradt_io__put_table(w, w->t->neighbors, w->t->dim + 1); // the cells of half-facets
}

static int paradt_io__write_ele(paradt_io__writer *w) {
    static const struct {
        const char *extension;
        void (*put)(paradt_io__writer *w);
    } files[] = {{".node", paradt_io__put_node}, {".ele", paradt_io__put_ele}, {".neigh", paradt_io__put_neigh}};
    size_t i;
    for (i = 0; i < sizeof files / sizeof *files; i++) {
        char *name = paradt_io__beside(w->name, files[i].extension, w->error);
        int good = name && paradt_io__open(&w->out, w->stage, name, w->error);
        if (good) {
            files[i].put(w);
            good = paradt_io__close(&w->out, w->error);
        }
        free(name);
        if (!good)
            return 0;
    }
    return 1;
}

// Announces an array of the .vtu. *offset: position of its block, advanced past the block; bytes: of the array
static void paradt_io__put_array(paradt_io__out *out, const char *type, const char *name, int components,
                                 uint64_t *offset, uint64_t bytes) {
    paradt_io__putf(out,
                    "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" "
                    "offset=\"%llu\"/>\n",
                    type, name, components, (unsigned long long)*offset);
    *offset += 8 + bytes; // a block begins with its size
}

// Begins a file of VTK's XML format with arrays appended as raw bytes. The arrays are announced first.
static void paradt_io__begin_vtu(paradt_io__out *out, size_t points, size_t cells) {
    paradt_io__putf(out,
                    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                    "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n<Points>\n",
                    points, cells);
}

static const unsigned char paradt_io__vtk_types[] = {1, 3, 5, 10}; // vertex, line, triangle, tetrahedron
static const char *const paradt_io__vtu_bytes =
    "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
static const char *const paradt_io__vtu_end = "\n</AppendedData>\n</VTKFile>\n";
static const char *const paradt_io__vtu_index = sizeof(paradt_index) == 8 ? "Int64" : "Int32";

// Announces the arrays. sizes: bytes of the points, weights, vertices, ends of cells, and types
static void paradt_io__put_vtu_header(paradt_io__writer *w, const uint64_t *sizes) {
    paradt_io__out *out = &w->out;
    uint64_t offset = 0;
    paradt_io__begin_vtu(out, w->points->count, w->t->cell_count);
    paradt_io__put_array(out, "Float64", "Points", 3, &offset, sizes[0]);
    paradt_io__put_text(out, "</Points>\n<PointData>\n");
    if (w->points->weights)
        paradt_io__put_array(out, "Float64", "weight", 1, &offset, sizes[1]);
    paradt_io__put_text(out, "</PointData>\n<Cells>\n");
    paradt_io__put_array(out, paradt_io__vtu_index, "connectivity", 1, &offset, sizes[2]);
    paradt_io__put_array(out, "Int64", "offsets", 1, &offset, sizes[3]);
    paradt_io__put_array(out, "UInt8", "types", 1, &offset, sizes[4]);
    paradt_io__put_text(out, paradt_io__vtu_bytes);
}

// Writes the array of the points.
static void paradt_io__put_vtu_points(paradt_io__writer *w) {
    size_t i;
    paradt_io__put_bits(&w->out, 24 * (uint64_t)w->points->count, 8);
    for (i = 0; i < 3 * w->points->count; i++)
        paradt_io__put_double(&w->out, paradt_io__coordinate(w, i / 3, (int)(i % 3)));
}

static void paradt_io__put_vtu(paradt_io__writer *w) {
    paradt_io__out *out = &w->out;
    size_t points = w->points->count, cells = w->t->cell_count, i;
    size_t corners = (size_t)(w->t->dim + 1);
    uint64_t sizes[5] = {24 * points, 8 * points, cells * corners * sizeof(paradt_index), 8 * cells, cells};
    paradt_io__put_vtu_header(w, sizes);
    paradt_io__put_vtu_points(w);
    if (w->points->weights) {
        paradt_io__put_bits(out, sizes[1], 8);
        for (i = 0; i < points; i++)
            paradt_io__put_double(out, w->points->weights[i]);
    }
    paradt_io__put_bits(out, sizes[2], 8);
    for (i = 0; i < cells * corners; i++)
        paradt_io__put_bits(out, (uint64_t)w->t->cells[i], (int)sizeof(paradt_index));
    paradt_io__put_bits(out, sizes[3], 8);
    for (i = 1; i <= cells; i++)
        paradt_io__put_bits(out, i * corners, 8);
    paradt_io__put_bits(out, sizes[4], 8);
    for (i = 0; i < cells; i++)
        paradt_io__put_bits(out, paradt_io__vtk_types[corners - 1], 1);
    paradt_io__put_text(out, paradt_io__vtu_end);
}

// kind: i: integers, f: doubles
static void paradt_io__put_npy_header(paradt_io__out *out, char kind, int size, size_t rows, int columns) {
    char header[118];
    int n = snprintf(header, sizeof header, "{'descr': '<%c%d', 'fortran_order': False, 'shape': (%zu, %d), }", kind,
                     size, rows, columns);
    memset(header + n, ' ', sizeof header - (size_t)n);
    header[sizeof header - 1] = '\n';
    paradt_io__put(out, "\x93NUMPY\1\0\x76\0", 10); // 10 + 118 is a multiple of 64, as the format asks for
    paradt_io__put(out, header, sizeof header);
}

static void paradt_io__put_npy_integers(paradt_io__out *out, const paradt_index *values, size_t rows, int columns) {
    size_t i;
    paradt_io__put_npy_header(out, 'i', (int)sizeof(paradt_index), rows, columns);
    for (i = 0; i < rows * (size_t)columns; i++)
        paradt_io__put_bits(out, (uint64_t)values[i], (int)sizeof(paradt_index));
}

static void paradt_io__put_npy(paradt_io__writer *w) {
    paradt_io__put_npy_integers(&w->out, w->t->cells, w->t->cell_count, w->t->dim + 1);
}

// The facets of the hull, turned outward, of a result of three dimensions or more; the cells of other results.
typedef struct paradt_io__surface {
    const paradt_index *faces; // [count][corners]
    size_t count;              // number of faces
    size_t corners;            // vertices of a face
    paradt_index *own;         // the array to be freed: `faces`, or NULL if that belongs to the triangulation
} paradt_io__surface;

// Writes the facet opposite vertex number `opposite` of a cell, turned outward. In the cell's order the facet looks
// inward if an even number of swaps moves that vertex to the end.
static void paradt_io__facet(const paradt_index *cell, size_t corners, size_t opposite, paradt_index *facet) {
    size_t k, n = 0;
    for (k = 0; k < corners; k++)
        if (k != opposite)
            facet[n++] = cell[k];
    if ((corners - 1 - opposite) % 2 == 0) {
        paradt_index first = facet[0];
        facet[0] = facet[1];
        facet[1] = first;
    }
}

// Makes the surface. Returns 1, or 0 after an error.
static int paradt_io__surface_of(paradt_io__writer *w, paradt_io__surface *surface) {
    const paradt_triangulation *t = w->t;
    size_t corners = (size_t)(t->dim + 1), i, n = 0, total = t->cell_count * corners;
    surface->faces = t->cells;
    surface->count = t->cell_count;
    surface->corners = corners;
    surface->own = NULL;
    if (w->hull || t->dim < 3)
        return 1;
    for (i = 0; i < total; i++)
        n += t->neighbors[i] < 0;
    surface->own = (paradt_index *)malloc((n + 1) * (corners - 1) * sizeof *surface->own);
    if (!surface->own)
        return paradt_io__no_memory(w->error, w->name);
    surface->faces = surface->own;
    surface->count = n;
    surface->corners = corners - 1;
    for (n = i = 0; i < total; i++)
        if (t->neighbors[i] < 0)
            paradt_io__facet(t->cells + i / corners * corners, corners, i % corners,
                             surface->own + n++ * surface->corners);
    return 1;
}

static void paradt_io__put_point(paradt_io__writer *w, size_t point) {
    int k, dim = w->points->dim > 3 ? w->points->dim : 3;
    for (k = 0; k < dim; k++)
        paradt_io__put_real(&w->out, ' ', paradt_io__coordinate(w, point, k));
    paradt_io__put(&w->out, "\n", 1);
}

static void paradt_io__put_off(paradt_io__writer *w, const paradt_io__surface *surface) {
    size_t i, k;
    if (w->points->dim > 3)
        paradt_io__putf(&w->out, "nOFF\n%d\n", w->points->dim);
    else
        paradt_io__put_text(&w->out, "OFF\n");
    paradt_io__putf(&w->out, "%zu %zu 0\n", w->points->count, surface->count);
    for (i = 0; i < w->points->count; i++)
        paradt_io__put_point(w, i);
    for (i = 0; i < surface->count; i++) {
        paradt_io__putf(&w->out, "%zu", surface->corners);
        for (k = 0; k < surface->corners; k++)
            paradt_io__put_int(&w->out, ' ', (int64_t)surface->faces[i * surface->corners + k]);
        paradt_io__put(&w->out, "\n", 1);
    }
}

// Numbers the points of the surface from `first` on, in the order of their indices. *used: number of these points.
// Returns [count] numbers, from malloc; -1: not on the surface. NULL if there is no memory.
static int64_t *paradt_io__renumber(paradt_io__writer *w, const paradt_io__surface *surface, int64_t first,
                                    int64_t *used) {
    size_t i, count = w->points->count;
    int64_t *numbers = (int64_t *)malloc((count + 1) * sizeof *numbers);
    if (!numbers)
        return NULL;
    for (i = 0; i < count; i++)
        numbers[i] = -1;
    for (i = 0; i < surface->count * surface->corners; i++)
        numbers[surface->faces[i]] = 0;
    for (*used = 0, i = 0; i < count; i++)
        if (numbers[i] == 0)
            numbers[i] = first + (*used)++;
    return numbers;
}

static void paradt_io__put_ply(paradt_io__writer *w, const paradt_io__surface *surface, const int64_t *numbers,
                               int64_t used) {
    paradt_io__out *out = &w->out;
    int edges = surface->corners < 3;
    size_t i, k;
    paradt_io__putf(out,
                    "ply\nformat binary_little_endian 1.0\nelement vertex %lld\nproperty double x\nproperty double y\n"
                    "property double z\nelement %s %zu\n%s\nend_header\n",
                    (long long)used, edges ? "edge" : "face", surface->corners > 1 ? surface->count : 0,
                    edges ? "property int vertex1\nproperty int vertex2" : "property list uchar int vertex_indices");
    for (i = 0; i < w->points->count; i++)
        for (k = 0; k < 3 && numbers[i] >= 0; k++)
            paradt_io__put_double(out, paradt_io__coordinate(w, i, (int)k));
    for (i = 0; surface->corners > 1 && i < surface->count; i++) {
        if (!edges)
            paradt_io__put_bits(out, surface->corners, 1);
        for (k = 0; k < surface->corners; k++)
            paradt_io__put_bits(out, (uint64_t)numbers[surface->faces[i * surface->corners + k]], 4);
    }
}

static void paradt_io__put_obj(paradt_io__writer *w, const paradt_io__surface *surface, const int64_t *numbers,
                               int64_t used) {
    static const char *const words[] = {"p", "l", "f"};
    size_t i, k;
    (void)used;
    for (i = 0; i < w->points->count; i++)
        if (numbers[i] >= 0) {
            paradt_io__put_text(&w->out, "v");
            paradt_io__put_point(w, i);
        }
    for (i = 0; i < surface->count; i++) {
        paradt_io__put_text(&w->out, words[surface->corners - 1]);
        for (k = 0; k < surface->corners; k++)
            paradt_io__put_int(&w->out, ' ', numbers[surface->faces[i * surface->corners + k]]);
        paradt_io__put(&w->out, "\n", 1);
    }
}

// Writes a file that has the surface.
static int paradt_io__write_surface(paradt_io__writer *w,
                                    void (*put)(paradt_io__writer *w, const paradt_io__surface *surface)) {
    paradt_io__surface surface;
    int good = paradt_io__surface_of(w, &surface);
    good = good && paradt_io__open(&w->out, w->stage, w->name, w->error);
    if (good) {
        put(w, &surface);
        good = paradt_io__close(&w->out, w->error);
    }
    free(surface.own);
    return good;
}

static int paradt_io__write_off(paradt_io__writer *w) {
    return paradt_io__write_surface(w, paradt_io__put_off);
}

// Writes a file that has only the points of the surface. first: number of the first point in the file
static int paradt_io__write_mesh(paradt_io__writer *w, int64_t first,
                                 void (*put)(paradt_io__writer *w, const paradt_io__surface *surface,
                                             const int64_t *numbers, int64_t used)) {
    paradt_io__surface surface;
    int64_t *numbers = NULL, used = 0;
    int good = paradt_io__surface_of(w, &surface);
    if (good && !(numbers = paradt_io__renumber(w, &surface, first, &used)))
        good = paradt_io__no_memory(w->error, w->name);
    good = good && paradt_io__open(&w->out, w->stage, w->name, w->error);
    if (good) {
        put(w, &surface, numbers, used);
        good = paradt_io__close(&w->out, w->error);
    }
    free(surface.own);
    free(numbers);
    return good;
}

static int paradt_io__write_ply(paradt_io__writer *w) {
    return paradt_io__write_mesh(w, 0, paradt_io__put_ply);
}

static int paradt_io__write_obj(paradt_io__writer *w) {
    return paradt_io__write_mesh(w, 1, paradt_io__put_obj);
}

// Writes a file by a function that can't fail.
static int paradt_io__write_plain(paradt_io__writer *w, void (*put)(paradt_io__writer *w)) {
    if (!paradt_io__open(&w->out, w->stage, w->name, w->error))
        return 0;
    put(w);
    return paradt_io__close(&w->out, w->error);
}

static int paradt_io__write_vtu(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_vtu);
}

static int paradt_io__write_npy(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_npy);
}

static void paradt_io__put_csv(paradt_io__writer *w) {
    size_t corners = (size_t)(w->t->dim + 1), i, k;
    for (k = 0; k < corners; k++) paradt_io__putf(&w->out, "%sv%zu", k ? "," : "", k);
    paradt_io__put(&w->out, "\n", 1);
    for (i = 0; i < w->t->cell_count; i++) {
        paradt_io__putf(&w->out, "%lld", (long long)w->t->cells[i * corners]);
        for (k = 1; k < corners; k++) paradt_io__put_int(&w->out, ',', (int64_t)w->t->cells[i * corners + k]);
        paradt_io__put(&w->out, "\n", 1);
    }
}

static int paradt_io__write_csv(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_csv);
}

// Writes an integer of 4 bytes or a double as VTK's legacy files have them, the highest byte first.
static void paradt_io__put_swapped(paradt_io__out *out, uint64_t bits, int size) {
    unsigned char bytes[8];
    int i;
    for (i = 0; i < size; i++) bytes[i] = (unsigned char)(bits >> 8 * (size - 1 - i) & 0xff);
    paradt_io__put(out, bytes, (size_t)size);
}

static void paradt_io__put_swapped_double(paradt_io__out *out, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    paradt_io__put_swapped(out, bits, 8);
}

static void paradt_io__put_vtk(paradt_io__writer *w) {
    paradt_io__out *out = &w->out;
    size_t points = w->points->count, cells = w->t->cell_count, corners = (size_t)(w->t->dim + 1), i;
    paradt_io__putf(out, "# vtk DataFile Version 3.0\nParaDT\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS %zu double\n",
                    points);
    for (i = 0; i < 3 * points; i++) paradt_io__put_swapped_double(out, paradt_io__coordinate(w, i / 3, (int)(i % 3)));
    paradt_io__putf(out, "\nCELLS %zu %zu\n", cells, cells * (corners + 1));
    for (i = 0; i < cells * corners; i++) {
        if (i % corners == 0) paradt_io__put_swapped(out, corners, 4);
        paradt_io__put_swapped(out, (uint64_t)w->t->cells[i], 4);
    }
    paradt_io__putf(out, "\nCELL_TYPES %zu\n", cells);
    for (i = 0; i < cells; i++) paradt_io__put_swapped(out, paradt_io__vtk_types[corners - 1], 4);
    if (w->points->weights) {
        paradt_io__putf(out, "\nPOINT_DATA %zu\nSCALARS weight double 1\nLOOKUP_TABLE default\n", points);
        for (i = 0; i < points; i++) paradt_io__put_swapped_double(out, w->points->weights[i]);
    }
    paradt_io__put_text(out, "\n");
}

static int paradt_io__write_vtk(paradt_io__writer *w) {
    if (w->points->count > INT32_MAX || w->t->cell_count > INT32_MAX / 5)
        return paradt_io__error(w->error, PARADT_IO_FAILED, "%.900s: too many cells for a legacy file; write a .vtu",
                                w->name);
    return paradt_io__write_plain(w, paradt_io__put_vtk);
}

// Writes the unit normal of a triangle. It is only for the eye: the corners have the geometry.
static void paradt_io__put_normal(paradt_io__writer *w, const paradt_index *face) {
    double a[3], b[3], n[3], length;
    int k;
    for (k = 0; k < 3; k++) {
        double origin = paradt_io__coordinate(w, (size_t)face[0], k);
        a[k] = paradt_io__coordinate(w, (size_t)face[1], k) - origin;
        b[k] = paradt_io__coordinate(w, (size_t)face[2], k) - origin;
    }
    for (k = 0; k < 3; k++) n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (k = 0; k < 3; k++)
        paradt_io__putf(&w->out, " %.9g", paradt_io__finite(length) && length > 0 ? n[k] / length : 0.0);
}

static void paradt_io__put_stl(paradt_io__writer *w, const paradt_io__surface *surface) {
    size_t i, k;
    paradt_io__put_text(&w->out, "solid ParaDT\n");
    for (i = 0; surface->corners == 3 && i < surface->count; i++) {
        const paradt_index *face = surface->faces + 3 * i;
        paradt_io__put_text(&w->out, "facet normal");
        paradt_io__put_normal(w, face);
        paradt_io__put_text(&w->out, "\nouter loop\n");
        for (k = 0; k < 3; k++) {
            paradt_io__put_text(&w->out, "vertex");
            paradt_io__put_point(w, (size_t)face[k]);
        }
        paradt_io__put_text(&w->out, "endloop\nendfacet\n");
    }
    paradt_io__put_text(&w->out, "endsolid ParaDT\n");
}

static int paradt_io__write_stl(paradt_io__writer *w) {
    return paradt_io__write_surface(w, paradt_io__put_stl);
}

static int paradt_io__write_bytes(paradt_io__writer *w, const void *bytes, size_t size) {
    if (!paradt_io__open(&w->out, w->stage, w->name, w->error))
        return 0;
    paradt_io__put(&w->out, bytes, size);
    return paradt_io__close(&w->out, w->error);
}

static int paradt_io__write_picture(paradt_io__writer *w,
                                    int (*draw)(paradt_picture *picture, const double *coordinates, int dim,
                                                const paradt_triangulation *t)) {
    paradt_picture picture;
    int good = draw(&picture, w->points->coordinates, w->points->dim, w->t);
    good = good ? paradt_io__write_bytes(w, picture.bytes, picture.size) : paradt_io__no_memory(w->error, w->name);
    free(picture.bytes);
    return good;
}

static int paradt_io__write_svg(paradt_io__writer *w) {
    return paradt_io__write_picture(w, paradt_picture_svg);
}

static int paradt_io__write_png(paradt_io__writer *w) {
    return paradt_io__write_picture(w, paradt_picture_png);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>answers: writers of answers to queries

static void paradt_io__put_answers_csv(paradt_io__writer *w) {
    const paradt_io_answers *a = w->answers;
    size_t i;
    int k;
    for (i = 0; i < a->queries->count; i++) {
        for (k = 0; k < a->columns; k++) {
            if (k)
                paradt_io__put_int(&w->out, ',', (int64_t)a->values[i * (size_t)a->columns + (size_t)k]);
            else
                paradt_io__putf(&w->out, "%lld", (long long)a->values[i * (size_t)a->columns]);
        }
        paradt_io__put(&w->out, "\n", 1);
    }
}

static void paradt_io__put_answers_npy(paradt_io__writer *w) {
    paradt_io__put_npy_integers(&w->out, w->answers->values, w->answers->queries->count, w->answers->columns);
}

// Each query is a point and a cell of one vertex.
static void paradt_io__put_answers_vtu(paradt_io__writer *w) {
    const paradt_io_answers *a = w->answers;
    paradt_io__out *out = &w->out;
    size_t count = a->queries->count, i;
    uint64_t offset = 0;
    int k;
    paradt_io__begin_vtu(out, count, count);
    paradt_io__put_array(out, "Float64", "Points", 3, &offset, 24 * count);
    paradt_io__put_text(out, "</Points>\n<PointData>\n");
    for (k = 0; k < a->columns; k++)
        paradt_io__put_array(out, paradt_io__vtu_index, a->titles[k], 1, &offset, count * sizeof(paradt_index));
    paradt_io__put_text(out, "</PointData>\n<Cells>\n");
    paradt_io__put_array(out, "Int64", "connectivity", 1, &offset, 8 * count);
    paradt_io__put_array(out, "Int64", "offsets", 1, &offset, 8 * count);
    paradt_io__put_array(out, "UInt8", "types", 1, &offset, count);
    paradt_io__put_text(out, paradt_io__vtu_bytes);
    paradt_io__put_vtu_points(w);
    for (k = 0; k < a->columns; k++) {
        paradt_io__put_bits(out, count * sizeof(paradt_index), 8);
        for (i = 0; i < count; i++)
            paradt_io__put_bits(out, (uint64_t)a->values[i * (size_t)a->columns + (size_t)k],
                                (int)sizeof(paradt_index));
    }
    for (k = 0; k < 2; k++) {
        paradt_io__put_bits(out, 8 * count, 8);
        for (i = 0; i < count; i++)
            paradt_io__put_bits(out, i + (size_t)k, 8);
    }
    paradt_io__put_bits(out, count, 8);
    for (i = 0; i < count; i++)
        paradt_io__put_bits(out, 1, 1);
    paradt_io__put_text(out, paradt_io__vtu_end);
}

static int paradt_io__write_answers_csv(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_answers_csv);
}

static int paradt_io__write_answers_npy(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_answers_npy);
}

static int paradt_io__write_answers_vtu(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_answers_vtu);
}

#ifndef PARADT_NO_VORONOI
// ---------------------------------------------------------------------------------------------------------------------
// >>voronoi: writers of Voronoi diagrams

// Returns what the row of a cell has in a column: index, volume, centroid, number of faces.
static double paradt_io__voronoi_number(const paradt_io__writer *w, size_t cell, int column) {
    const paradt_voronoi *v = w->voronoi;
    if (column == 0)
        return (double)cell;
    if (column == 1)
        return v->volumes[cell];
    if (column == w->points->dim + 2)
        return (double)(v->first_face[cell + 1] - v->first_face[cell]);
    return v->centroids ? v->centroids[cell * (size_t)v->dim + (size_t)(column - 2)] : nan("");
}

static void paradt_io__put_voronoi_csv(paradt_io__writer *w) {
    size_t i;
    int k, dim = w->points->dim;
    paradt_io__put_text(&w->out, "index,volume");
    for (k = 0; k < dim; k++)
        if (dim <= 3)
            paradt_io__putf(&w->out, ",c%c", "xyz"[k]);
        else
            paradt_io__putf(&w->out, ",c%d", k + 1);
    paradt_io__put_text(&w->out, ",faces\n");
    for (i = 0; i < w->points->count; i++) {
        paradt_io__putf(&w->out, "%zu", i);
        for (k = 1; k < dim + 3; k++) {
            double value = paradt_io__voronoi_number(w, i, k);
            if (paradt_io__finite(value))
                paradt_io__put_real(&w->out, ',', value);
            else
                paradt_io__put_text(&w->out, k == 1 ? ",inf" : ",nan");
        }
        paradt_io__put(&w->out, "\n", 1);
    }
}

static void paradt_io__put_voronoi_npy(paradt_io__writer *w) {
    size_t i;
    int k, columns = w->points->dim + 3;
    paradt_io__put_npy_header(&w->out, 'f', 8, w->points->count, columns);
    for (i = 0; i < w->points->count; i++)
        for (k = 0; k < columns; k++)
            paradt_io__put_double(&w->out, paradt_io__voronoi_number(w, i, k));
}

// The bounded cells as VTK wants them: of each cell its vertices, none twice, in the plane in order around it; in space
// the stream of its faces, too: their number, and of each face the number of its vertices and these.
typedef struct paradt_io__polyhedra {
    size_t cells;           // number of cells
    paradt_index *which;    // [cells] the cells
    size_t *vertex_ends;    // [cells] where the vertices of each cell end
    size_t *face_ends;      // [cells] where the face stream of each cell ends
    paradt_index *numbers;  // [vertex_count] of the diagram's vertices, among those that are used
    size_t used;            // number of vertices that are used
    paradt_index *vertices; // [vertex_ends[cells - 1]] numbers of the diagram
} paradt_io__polyhedra;

static int paradt_io__compare_indices(const void *a, const void *b) {
    const paradt_index x = *(const paradt_index *)a, y = *(const paradt_index *)b;
    return (x > y) - (x < y);
}

// Copies the vertices of a cell, none twice, to `into`, if there is room. Returns how much room they take before those
// that come twice are dropped. *count: their number; 0: the cell is not drawn
static size_t paradt_io__cell_vertices(const paradt_voronoi *v, size_t cell, paradt_index *into, size_t room,
                                       size_t *count) {
    size_t first = v->first_face[cell], last = v->first_face[cell + 1], total = 0, i, j, n = 0;
    *count = 0;
    for (i = first; i < last; i++)
        total += v->first_vertex[v->faces[i] + 1] - v->first_vertex[v->faces[i]];
    if (total > room || v->unbounded[cell])
        return v->unbounded[cell] ? 0 : total;
    for (i = first; i < last; i++)
        for (j = v->first_vertex[v->faces[i]]; j < v->first_vertex[v->faces[i] + 1]; j++)
            into[n++] = v->polygons[j];
    if (n)
        qsort(into, n, sizeof *into, paradt_io__compare_indices);
    for (i = 0; i < n; i++)
        if (i == 0 || into[i] != into[i - 1])
            into[(*count)++] = into[i];
    return total;
}

// Fills the vertices of all cells, from number 0 on. Returns 0 if there is no memory.
static int paradt_io__fill_polyhedra(paradt_io__polyhedra *p, const paradt_voronoi *v) {
    size_t capacity = 0, n = 0, stream = 0, cell, i;
    for (cell = 0; cell < v->cell_count; cell++) {
        size_t count, total = v->dim == 2 ? v->first_face[cell + 1] - v->first_face[cell]
                                          : paradt_io__cell_vertices(v, cell, NULL, 0, &count);
        if (n + total > capacity) {
            paradt_index *larger;
            capacity = 2 * (n + total) + 1024;
            larger = (paradt_index *)realloc(p->vertices, capacity * sizeof *larger);
            if (!larger)
                return 0;
            p->vertices = larger;
        }
        if (v->dim == 2) {
            long outline = paradt_picture_outline(v, cell, p->vertices + n);
            if (outline < 0)
                return 0;
            count = (size_t)outline;
        } else
            paradt_io__cell_vertices(v, cell, p->vertices + n, total, &count);
        if (!count)
            continue;
        n += count;
        stream += 1 + v->first_face[cell + 1] - v->first_face[cell] + total;
        p->which[p->cells] = (paradt_index)cell;
        p->vertex_ends[p->cells] = n;
        p->face_ends[p->cells++] = stream;
    }
    for (i = 0; i < v->vertex_count; i++)
        p->numbers[i] = -1;
    for (i = 0; i < n; i++)
        p->numbers[p->vertices[i]] = 0;
    for (i = 0; i < v->vertex_count; i++)
        if (p->numbers[i] == 0)
            p->numbers[i] = (paradt_index)p->used++;
    return 1;
}

// Writes one number a cell.
static void paradt_io__put_cell_data(paradt_io__out *out, const paradt_io__polyhedra *p, const paradt_voronoi *v) {
    size_t i;
    paradt_io__put_bits(out, 8 * (uint64_t)p->cells, 8);
    for (i = 0; i < p->cells; i++)
        paradt_io__put_bits(out, (uint64_t)p->which[i], 8);
    paradt_io__put_bits(out, 8 * (uint64_t)p->cells, 8);
    for (i = 0; i < p->cells; i++)
        paradt_io__put_double(out, v->volumes[p->which[i]]);
}

static void paradt_io__put_ends(paradt_io__out *out, const size_t *ends, size_t count) {
    size_t i;
    paradt_io__put_bits(out, 8 * (uint64_t)count, 8);
    for (i = 0; i < count; i++)
        paradt_io__put_bits(out, ends[i], 8);
}

// Writes the stream of the faces. Those of a cell that is their second side are turned, so all look outward.
static void paradt_io__put_face_stream(paradt_io__out *out, const paradt_io__polyhedra *p, const paradt_voronoi *v) {
    const int size = (int)sizeof(paradt_index);
    size_t i, j, k;
    paradt_io__put_bits(out, (uint64_t)(p->cells ? p->face_ends[p->cells - 1] : 0) * sizeof(paradt_index), 8);
    for (i = 0; i < p->cells; i++) {
        size_t cell = (size_t)p->which[i];
        paradt_io__put_bits(out, v->first_face[cell + 1] - v->first_face[cell], size);
        for (j = v->first_face[cell]; j < v->first_face[cell + 1]; j++) {
            size_t face = (size_t)v->faces[j], first = v->first_vertex[face], count = v->first_vertex[face + 1] - first;
            int turned = v->sides[2 * face] != p->which[i];
            paradt_io__put_bits(out, count, size);
            for (k = 0; k < count; k++)
                paradt_io__put_bits(out, (uint64_t)p->numbers[v->polygons[turned ? first + count - 1 - k : first + k]],
                                    size);
        }
    }
}

static void paradt_io__put_polyhedra(paradt_io__writer *w, const paradt_io__polyhedra *p) {
    const paradt_voronoi *v = w->voronoi;
    paradt_io__out *out = &w->out;
    size_t ends = p->cells ? p->vertex_ends[p->cells - 1] : 0, stream = p->cells ? p->face_ends[p->cells - 1] : 0, i;
    uint64_t offset = 0;
    int k;
    paradt_io__begin_vtu(out, p->used, p->cells);
    paradt_io__put_array(out, "Float64", "Points", 3, &offset, 24 * p->used);
    paradt_io__put_text(out, "</Points>\n<CellData>\n");
    paradt_io__put_array(out, "Int64", "point", 1, &offset, 8 * p->cells);
    paradt_io__put_array(out, "Float64", "volume", 1, &offset, 8 * p->cells);
    paradt_io__put_text(out, "</CellData>\n<Cells>\n");
    paradt_io__put_array(out, paradt_io__vtu_index, "connectivity", 1, &offset, ends * sizeof(paradt_index));
    paradt_io__put_array(out, "Int64", "offsets", 1, &offset, 8 * p->cells);
    paradt_io__put_array(out, "UInt8", "types", 1, &offset, p->cells);
    if (v->dim == 3) {
        paradt_io__put_array(out, paradt_io__vtu_index, "faces", 1, &offset, stream * sizeof(paradt_index));
        paradt_io__put_array(out, "Int64", "faceoffsets", 1, &offset, 8 * p->cells);
    }
    paradt_io__put_text(out, paradt_io__vtu_bytes);
    paradt_io__put_bits(out, 24 * (uint64_t)p->used, 8);
    for (i = 0; i < v->vertex_count; i++)
        for (k = 0; p->numbers[i] >= 0 && k < 3; k++)
            paradt_io__put_double(out, k < v->dim ? v->vertices[i * (size_t)v->dim + (size_t)k] : 0);
    paradt_io__put_cell_data(out, p, v);
    paradt_io__put_bits(out, (uint64_t)ends * sizeof(paradt_index), 8);
    for (i = 0; i < ends; i++)
        paradt_io__put_bits(out, (uint64_t)p->numbers[p->vertices[i]], (int)sizeof(paradt_index));
    paradt_io__put_ends(out, p->vertex_ends, p->cells);
    paradt_io__put_bits(out, p->cells, 8);
    for (i = 0; i < p->cells; i++)
        paradt_io__put_bits(out, v->dim == 3 ? 42 : 7, 1); // polyhedron, polygon
    if (v->dim == 3) {
        paradt_io__put_face_stream(out, p, v);
        paradt_io__put_ends(out, p->face_ends, p->cells);
    }
    paradt_io__put_text(out, paradt_io__vtu_end);
}

static int paradt_io__write_voronoi_vtu(paradt_io__writer *w) {
    const paradt_voronoi *v = w->voronoi;
    paradt_io__polyhedra p;
    int good;
    memset(&p, 0, sizeof p);
    p.which = (paradt_index *)malloc((v->cell_count + 1) * sizeof *p.which);
    p.vertex_ends = (size_t *)malloc((v->cell_count + 1) * sizeof *p.vertex_ends);
    p.face_ends = (size_t *)malloc((v->cell_count + 1) * sizeof *p.face_ends);
    p.numbers = (paradt_index *)malloc((v->vertex_count + 1) * sizeof *p.numbers);
    if (!p.which || !p.vertex_ends || !p.face_ends || !p.numbers || !paradt_io__fill_polyhedra(&p, v))
        good = paradt_io__no_memory(w->error, w->name);
    else if ((good = paradt_io__open(&w->out, w->stage, w->name, w->error))) {
        paradt_io__put_polyhedra(w, &p);
        good = paradt_io__close(&w->out, w->error);
    }
    free(p.which);
    free(p.vertex_ends);
    free(p.face_ends);
    free(p.numbers);
    free(p.vertices);
    return good;
}

static int paradt_io__write_voronoi_csv(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_voronoi_csv);
}

static int paradt_io__write_voronoi_npy(paradt_io__writer *w) {
    return paradt_io__write_plain(w, paradt_io__put_voronoi_npy);
}

static int paradt_io__write_voronoi_picture(paradt_io__writer *w,
                                            int (*draw)(paradt_picture *picture, const double *coordinates,
                                                        const paradt_voronoi *v, int clipped)) {
    paradt_picture picture;
    int good = draw(&picture, w->points->coordinates, w->voronoi, w->clipped);
    good = good ? paradt_io__write_bytes(w, picture.bytes, picture.size) : paradt_io__no_memory(w->error, w->name);
    free(picture.bytes);
    return good;
}

static int paradt_io__write_voronoi_svg(paradt_io__writer *w) {
    return paradt_io__write_voronoi_picture(w, paradt_picture_voronoi_svg);
}

static int paradt_io__write_voronoi_png(paradt_io__writer *w) {
    return paradt_io__write_voronoi_picture(w, paradt_picture_voronoi_png);
}
#endif

// ---------------------------------------------------------------------------------------------------------------------
// >>writing

typedef struct paradt_io__output {
    const char *extension; // NULL: the end of a table
    int (*write)(paradt_io__writer *w);
    int max_dim;    // of the points
    unsigned needs; // of a triangulation: 1: holds the facets of a hull, too; of a Voronoi diagram: outputs
} paradt_io__output;

static const paradt_io__output paradt_io__outputs[] = {
    {".ele", paradt_io__write_ele, PARADT_MAX_DIM, 0},
    {".vtu", paradt_io__write_vtu, 3, 0},
    {".off", paradt_io__write_off, PARADT_MAX_DIM, 1},
    {".ply", paradt_io__write_ply, 3, 1},
    {".obj", paradt_io__write_obj, 3, 1},
    {".stl", paradt_io__write_stl, 3, 1},
    {".vtk", paradt_io__write_vtk, 3, 0},
    {".npy", paradt_io__write_npy, PARADT_MAX_DIM, 1},
    {".csv", paradt_io__write_csv, PARADT_MAX_DIM, 1},
    {".svg", paradt_io__write_svg, 3, 0},
    {".png", paradt_io__write_png, 3, 0},
    {NULL, NULL, 0, 0},
};

static const paradt_io__output paradt_io__answers_outputs[] = {
    {".csv", paradt_io__write_answers_csv, PARADT_MAX_DIM, 0},
    {".npy", paradt_io__write_answers_npy, PARADT_MAX_DIM, 0},
    {".vtu", paradt_io__write_answers_vtu, 3, 0},
    {NULL, NULL, 0, 0},
};

#ifndef PARADT_NO_VORONOI
static const paradt_io__output paradt_io__voronoi_outputs[] = {
    {".csv", paradt_io__write_voronoi_csv, PARADT_MAX_DIM, PARADT_VORONOI_CENTROIDS | PARADT_VORONOI_FACES},
    {".npy", paradt_io__write_voronoi_npy, PARADT_MAX_DIM, PARADT_VORONOI_CENTROIDS | PARADT_VORONOI_FACES},
    {".vtu", paradt_io__write_voronoi_vtu, 3, PARADT_VORONOI_FACES | PARADT_VORONOI_POLYGONS},
    {".svg", paradt_io__write_voronoi_svg, 3, PARADT_VORONOI_FACES | PARADT_VORONOI_POLYGONS},
    {".png", paradt_io__write_voronoi_png, 3, PARADT_VORONOI_FACES | PARADT_VORONOI_POLYGONS},
    {NULL, NULL, 0, 0},
};
#endif

const char *paradt_io_outputs(void) {
    return ".ele .vtu .vtk .off .ply .obj .stl .npy .csv .svg .png";
}

// Finds the row of a table for a name; NULL: none. The name "-" of what has a .csv is the row of that.
static const paradt_io__output *paradt_io__output_of(const paradt_io__output *table, const char *name) {
    const char *extension = strcmp(name, "-") == 0 ? ".csv" : paradt_io__extension(name);
    for (; table->extension; table++)
        if (strcasecmp(extension, table->extension) == 0)
            return table;
    return NULL;
}

int paradt_io_check_place(const char *name, const char *input, paradt_io_error *error) {
    const char *slash = strrchr(name, '/');
    struct stat here, there;
    char *folder = (char *)malloc(strlen(name) + 2);
    int good = 1;
    if (!folder)
        return paradt_io__no_memory(error, name);
    strcpy(folder, ".");
    if (slash) {
        memcpy(folder, name, (size_t)(slash - name) + 1);
        folder[slash - name + 1] = '\0';
    }
    if (access(folder, W_OK) != 0)
        good =
            paradt_io__error(error, PARADT_IO_FAILED, "%.450s: %s: the folder %.450s", name, strerror(errno), folder);
    else if (stat(name, &here) == 0) {
        if (S_ISDIR(here.st_mode))
            good = paradt_io__error(error, PARADT_IO_FAILED, "%.900s: %s", name, strerror(EISDIR));
        else if (!S_ISREG(here.st_mode))
            good = paradt_io__error(error, PARADT_IO_FAILED, "%.900s: no regular file, so it is not replaced", name);
        else if (input && stat(input, &there) == 0 && here.st_dev == there.st_dev && here.st_ino == there.st_ino)
            good = paradt_io__error(error, PARADT_IO_BAD_NAME, "%.900s: would replace the input", name);
    }
    free(folder);
    return good;
}

// Checks a name by a table. outputs: the extensions of the table, for an error
static int paradt_io__check(const paradt_io__output *table, const char *outputs, const char *name, int dim,
                            const char *input, paradt_io_error *error) {
    static const char *const companions[] = {".node", ".neigh"};
    const paradt_io__output *output = paradt_io__output_of(table, name);
    size_t i;
    if (!output)
        return paradt_io__error(error, PARADT_IO_BAD_NAME, "%.700s: the name does not end in one of %s", name, outputs);
    if (dim > output->max_dim)
        return paradt_io__error(error, PARADT_IO_BAD_NAME, "%.700s: %s files hold at most %d dimensions, not %d", name,
                                output->extension, output->max_dim, dim);
    if (strcmp(name, "-") == 0)
        return 1;
    if (!paradt_io_check_place(name, input, error))
        return 0;
    for (i = 0; output->write == paradt_io__write_ele && i < 2; i++) {
        char *other = paradt_io__beside(name, companions[i], error);
        int good = other && paradt_io_check_place(other, input, error);
        free(other);
        if (!good)
            return 0;
    }
    return 1;
}

int paradt_io_check_output(const char *name, int dim, const char *input, paradt_io_error *error) {
    if (strcmp(name, "-") == 0)
        return paradt_io__error(error, PARADT_IO_BAD_NAME, "-: standard output takes no cells; name a file");
    return paradt_io__check(paradt_io__outputs, paradt_io_outputs(), name, dim, input, error);
}

int paradt_io_check_hull_output(const char *name, int dim, const char *input, paradt_io_error *error) {
    const paradt_io__output *output = paradt_io__output_of(paradt_io__outputs, name);
    if (output && !output->needs)
        return paradt_io__error(error, PARADT_IO_BAD_NAME,
                                "%.700s: %s files hold no hull; .off, .ply, .obj, .stl, .npy and .csv do", name,
                                output->extension);
    return paradt_io_check_output(name, dim, input, error);
}

int paradt_io_check_answers_output(const char *name, int dim, const char *input, paradt_io_error *error) {
    return paradt_io__check(paradt_io__answers_outputs, ".csv .npy .vtu", name, dim, input, error);
}

#ifndef PARADT_NO_VORONOI
int paradt_io_check_voronoi_output(const char *name, int dim, const char *input, paradt_io_error *error) {
    return paradt_io__check(paradt_io__voronoi_outputs, ".csv .npy .vtu .svg .png", name, dim, input, error);
}

unsigned paradt_io_voronoi_needs(const char *name, int dim) {
    const paradt_io__output *output = paradt_io__output_of(paradt_io__voronoi_outputs, name);
    unsigned needs = output ? output->needs : 0;
    return dim > 3 ? needs & ~(unsigned)PARADT_VORONOI_CENTROIDS : needs;
}
#endif

// Allocates what a writer gets. Returns NULL after an error.
static paradt_io__writer *paradt_io__writer_of(paradt_io_stage *stage, const char *name, paradt_io_error *error) {
    paradt_io__writer *w = (paradt_io__writer *)malloc(sizeof *w);
    if (!w) {
        paradt_io__no_memory(error, name);
        return NULL;
    }
    w->stage = stage;
    w->name = name;
    w->error = error;
    w->hull = 0;
    return w;
}

int paradt_io_write(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                    const paradt_triangulation *triangulation, paradt_io_error *error) {
    paradt_io__writer *w;
    int good;
    if (!paradt_io_check_output(name, points->dim, NULL, error))
        return 0;
    w = paradt_io__writer_of(stage, name, error);
    if (!w)
        return 0;
    w->points = points;
    w->t = triangulation;
    good = paradt_io__output_of(paradt_io__outputs, name)->write(w);
    free(w);
    return good;
}

int paradt_io_write_hull(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                         const paradt_index *facets, size_t count, int corners, paradt_io_error *error) {
    paradt_triangulation cells;
    paradt_io__writer *w;
    int good;
    if (!paradt_io_check_hull_output(name, points->dim, NULL, error))
        return 0;
    w = paradt_io__writer_of(stage, name, error);
    if (!w)
        return 0;
    memset(&cells, 0, sizeof cells);
    cells.dim = corners - 1;
    cells.cell_count = count;
    cells.cells = (paradt_index *)(uintptr_t)facets; // which nothing writes to
    w->points = points;
    w->t = &cells;
    w->hull = 1;
    good = paradt_io__output_of(paradt_io__outputs, name)->write(w);
    free(w);
    return good;
}

int paradt_io_write_answers(paradt_io_stage *stage, const char *name, const paradt_io_answers *answers,
                            paradt_io_error *error) {
    paradt_io__writer *w;
    int good;
    if (!paradt_io_check_answers_output(name, answers->queries->dim, NULL, error))
        return 0;
    w = paradt_io__writer_of(stage, name, error);
    if (!w)
        return 0;
    w->points = answers->queries;
    w->answers = answers;
    good = paradt_io__output_of(paradt_io__answers_outputs, name)->write(w);
    free(w);
    return good;
}

#ifndef PARADT_NO_VORONOI
int paradt_io_write_voronoi(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                            const paradt_voronoi *voronoi, int clipped, paradt_io_error *error) {
    paradt_io__writer *w;
    int good;
    if (!paradt_io_check_voronoi_output(name, points->dim, NULL, error))
        return 0;
    w = paradt_io__writer_of(stage, name, error);
    if (!w)
        return 0;
    w->points = points;
    w->voronoi = voronoi;
    w->clipped = clipped;
    good = paradt_io__output_of(paradt_io__voronoi_outputs, name)->write(w);
    free(w);
    return good;
}
#endif

int paradt_io_write_text(paradt_io_stage *stage, const char *name, const char *text, paradt_io_error *error) {
    paradt_io__writer *w = paradt_io__writer_of(stage, name, error);
    int good = w && paradt_io__write_bytes(w, text, strlen(text));
    free(w);
    return good;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>progress

double paradt_io_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

void paradt_io_bar_begin(paradt_io_bar *bar) {
    bar->begun = paradt_io_now();
    bar->shown = 0;
}

void paradt_io_bar_draw(paradt_io_bar *bar, double fraction) {
    static const char full[] = "########################################";
    double time = paradt_io_now();
    if (time - bar->begun <= 1 || time - bar->shown <= 0.1)
        return;
    fprintf(stderr, "\r[%-40.*s] %3d%% %.0f s ", (int)(fraction * 40), full, (int)(fraction * 100), time - bar->begun);
    fflush(stderr);
    bar->shown = time;
}

void paradt_io_bar_clear(const paradt_io_bar *bar) {
    if (bar->shown > 0)
        fprintf(stderr, "\r%70s\r", "");
}

#endif // PARADT_IO_IMPLEMENTATION_DONE
#endif // PARADT_IO_IMPLEMENTATION
