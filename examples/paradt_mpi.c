// paradt_mpi - the command-line tool of ParaDT over MPI
//
//     mpicc -O3 -o paradt_mpi examples/paradt_mpi.c -lm
//     mpiexec -n 8 paradt_mpi gen:plummer:1000000:1 -o cluster.pvtu
//
// `paradt_mpi --help` lists the options. They and the inputs are those of `paradt`, as far as they make sense here.
//
// Each rank generates its part of gen:... and reads its part of a .npy or binary .ply. Rank 0 reads all other inputs
// and hands in all points. Each rank writes its piece of a .pvtu: points and cells, without weights. For other outputs
// and for --check the cells are gathered on rank 0. Rank 0 alone prints, and its progress bar shows its own work. An
// error of reading or writing is printed by the first rank that has one.

#define PARADT_IO_IMPLEMENTATION
#include "paradt_io.h"

#define PARADT_MPI_IMPLEMENTATION
#include "../paradt_mpi.h"

#include <inttypes.h>

enum { EXIT_DONE, EXIT_FAILED, EXIT_USAGE, EXIT_INPUT };

static int rank, ranks;
static paradt_io_stage stage; // the temporary files of this rank, which a signal handler removes

// ---------------------------------------------------------------------------------------------------------------------
// >>settings

typedef struct settings {
    const char *input;
    const char **outputs;
    size_t output_count;
    const char *stats; // file to write; "-": standard output; NULL: no statistics
    paradt_io_want want;
    paradt_method method;
    paradt_partition partition;
    int replicated, check, hash, progress, quiet, help, version;
} settings;

// Prints an error on rank 0. Returns the status.
static int fail(int status, const char *format, ...) PARADT_IO__FORMAT(2, 3);

static int fail(int status, const char *format, ...) {
    va_list arguments;
    if (rank == 0) {
        va_start(arguments, format);
        fputs("paradt_mpi: ", stderr);
        vfprintf(stderr, format, arguments);
        fputc('\n', stderr);
        va_end(arguments);
    }
    return status;
}

// Each take_... function stores the value of an option. It returns NULL, or what is wrong with the value.

static const char *take_output(settings *s, const char *value) {
    s->outputs[s->output_count++] = value;
    return NULL;
}

static const char *take_dim(settings *s, const char *value) {
    if (value[0] < '2' || value[0] > '0' + PARADT_MAX_DIM || value[1]) return "the dimension is a number from 2 to 8";
    s->want.dim = value[0] - '0';
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

static const char *take_partition(settings *s, const char *value) {
    s->partition = strcmp(value, "uniform") == 0 ? PARADT_UNIFORM : PARADT_BISECTION;
    return s->partition == PARADT_UNIFORM || strcmp(value, "bisection") == 0 ? NULL
                                                                             : "a partition is bisection or uniform";
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
    {"--method", "NAME", take_method, 0, "algorithm of each rank; every method gives the same result"},
    {"--dim", "D", take_dim, 0, "dimension, 2 to 8; the first D columns are the coordinates"},
    {"--weights", NULL, NULL, offsetof(settings, want.weights), "the next column is a weight: regular triangulation"},
    {"--radii", NULL, NULL, offsetof(settings, want.radii), "like --weights, but it is a radius, which is squared"},
    {"--columns", "LIST", take_columns, 0, "columns of text or .npy to read, then the weight's: 2-4, or titles: x,y,r"},
    {"--format", "NAME", take_format, 0, "read INPUT as a file of this extension, whatever its name; for - too"},
    {"--partition", "HOW", take_partition, 0, "bisection (default: equal numbers of points) or uniform (equal boxes)"},
    {"--replicated", NULL, NULL, offsetof(settings, replicated), "give every rank all points; incode or dewall only"},
    {"--check", NULL, NULL, offsetof(settings, check), "certify the result on rank 0 in exact arithmetic"},
    {"--stats", "FILE", take_stats, 0, "write statistics as JSON; -: to standard output, instead of the summary"},
    {"--hash", NULL, NULL, offsetof(settings, hash), "print the hash of the set of cells as the last line"},
    {"--progress", NULL, NULL, offsetof(settings, progress), "draw a progress bar, though mpiexec hides the terminal"},
    {"--quiet", NULL, NULL, offsetof(settings, quiet), "print neither summary nor progress bar"},
    {"--help", NULL, NULL, offsetof(settings, help), "print this text"},
    {"--version", NULL, NULL, offsetof(settings, version), "print the version"},
};

enum { OPTIONS = sizeof options_table / sizeof *options_table };

static void print_help(void) {
    int i;
    printf("mpiexec -n RANKS paradt_mpi [options] INPUT\n\n"
           "Computes the Delaunay or regular triangulation of points in 2 to 8 dimensions, exactly, on many ranks.\n\n"
           "INPUT: a file, by extension or content (%s; also .gz),\n"
           "       - (standard input, by content or --format), or gen:KIND:N:SEED (paradt --help lists the kinds)\n\n",
           paradt_io_inputs());
    for (i = 0; i < OPTIONS; i++) {
        char left[40];
        snprintf(left, sizeof left, "%s%s%s", options_table[i].name, options_table[i].value ? " " : "",
                 options_table[i].value ? options_table[i].value : "");
        printf("  %-16s  %s\n", left, options_table[i].about);
    }
    printf("\nOutputs, by extension: .pvtu %s\n  .pvtu comes with one .vtu a rank\n\nMethods:", paradt_io_outputs());
    for (i = 0; i < PARADT_METHOD_COUNT; i++) printf(" %s", paradt_method_string((paradt_method)i));
    printf("\n\nExit status: 0 done, 1 failed, 2 wrong usage, 3 input that can't be read or is not finite\n");
}

// Prints an error of the command line. value: of the option, NULL if it is not to be named. Returns 0.
static int wrong(const char *option, const char *value, const char *reason) {
    fail(EXIT_USAGE, "%s%s%s: %s (paradt_mpi --help lists the options)", option, value ? " " : "", value ? value : "",
         reason);
    return 0;
}

// Reads the first of the `left` arguments as an option. Its value follows "=" or is the next argument. Returns the
// number of arguments read, or 0 after an error.
static int take_option(settings *s, int left, char **arguments) {
    const char *text = arguments[0], *equals = strncmp(text, "--", 2) == 0 ? strchr(text, '=') : NULL, *value, *reason;
    size_t n = equals ? (size_t)(equals - text) : strlen(text);
    int i;
    for (i = 0; i < OPTIONS; i++)
        if (strlen(options_table[i].name) == n && memcmp(options_table[i].name, text, n) == 0) break;
    if (i == OPTIONS) return wrong(text, NULL, "no such option");
    if (!options_table[i].take) {
        if (equals) return wrong(text, NULL, "this option takes no value");
        *(int *)((char *)s + options_table[i].flag) = 1;
        return 1;
    }
    value = equals ? equals + 1 : left > 1 ? arguments[1] : NULL;
    if (!value) return wrong(text, NULL, "its value is missing");
    reason = options_table[i].take(s, value);
    if (reason) return wrong(text, equals ? NULL : value, reason);
    return equals ? 1 : 2;
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
            if (!taken) return 0;
            i += taken;
        } else if (s->input) return wrong(text, NULL, "a second input; there can be only one");
        else s->input = arguments[i++];
    }
    if (!s->input && !s->help && !s->version) return wrong("no input", NULL, "name a file, - or gen:KIND:N:SEED");
    if (s->want.radii) s->want.weights = 1;
    if (s->replicated && s->method == PARADT_BOWYER_WATSON)
        return wrong("--replicated", NULL, "the method has to be incode or dewall");
    return 1;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>parts: the part of the input that a rank hands in

typedef struct part {
    void *rows;      // coordinates, or rows of the file with other columns; from malloc
    double *weights; // [points.count], from malloc; NULL: no weights
    int whole;       // 1: rank 0 has all points, and `rows` are coordinates alone; the same on all ranks
    uint64_t first;  // index of the part's first point in the input
    paradt_points points;
} part;

static void part_free(part *p) {
    free(p->rows);
    free(p->weights);
    memset(p, 0, sizeof *p);
}

// Returns the largest status of all ranks; collective.
static int agree(int status) {
    MPI_Allreduce(MPI_IN_PLACE, &status, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return status;
}

// The same; the first rank that has an error prints it.
static int agree_on(int status, const paradt_io_error *error) {
    int first = status ? rank : ranks;
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (first == rank) fprintf(stderr, "paradt_mpi: %s\n", error->text);
    return agree(status);
}

// A table of numbers in a file: what rank 0 reads from the header and sends to the other ranks. OFFSET: of the first
// row, in bytes; STRIDE: bytes of a row; FLOATS: 1: the numbers are floats, 0: doubles
enum { TABLE_OFFSET, TABLE_ROWS, TABLE_STRIDE, TABLE_COLUMNS, TABLE_FLOATS, TABLE_FIELDS };

// Fills the table if the file is a .npy of little-endian floating-point numbers stored by rows, and returns 1; else 0.
//   head  the first `size` bytes of the file, and a NUL
static int npy_table(const char *head, size_t size, int64_t *table) {
    const char *text = head + 10, *shape;
    unsigned length;
    int closed = 0;
    long long rows, columns;
    if (size < 128 || memcmp(head, "\x93NUMPY\x01", 7) != 0) return 0;
    length = (unsigned char)head[8] | (unsigned)(unsigned char)head[9] << 8;
    shape = strstr(text, "'shape': (");
    if (10 + length >= size || !strstr(text, "'fortran_order': False") || !shape || shape > text + length ||
        sscanf(shape, "'shape': (%lld, %lld)%n", &rows, &columns, &closed) != 2 || !closed || rows < 0 || columns < 1 ||
        columns > 1 << 20)
        return 0;
    table[TABLE_FLOATS] = strstr(text, "'descr': '<f4'") != NULL;
    if (!table[TABLE_FLOATS] && !strstr(text, "'descr': '<f8'")) return 0;
    table[TABLE_OFFSET] = 10 + (int64_t)length;
    table[TABLE_ROWS] = rows;
    table[TABLE_COLUMNS] = columns;
    table[TABLE_STRIDE] = columns * (table[TABLE_FLOATS] ? 4 : 8);
    return 1;
}

// Returns the size of a PLY type; 0: a list, or unknown.
static int ply_size(const char *type) {
    static const struct {
        const char *name;
        int size;
    } types[] = {{"char", 1},  {"uchar", 1},  {"short", 2},   {"ushort", 2}, {"int", 4},   {"uint", 4},
                 {"float", 4}, {"double", 8}, {"int8", 1},    {"uint8", 1},  {"int16", 2}, {"uint16", 2},
                 {"int32", 4}, {"uint32", 4}, {"float32", 4}, {"float64", 8}};
    size_t i;
    for (i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(type, types[i].name) == 0) return types[i].size;
    return 0;
}

// Fills the table if the file is a little-endian .ply whose first element is the vertices, and their first properties
// are x, y, z of one floating-point type, and returns 1; else 0. head: the first bytes of the file, and a NUL
static int ply_table(const char *head, int64_t *table) {
    const char *end = strstr(head, "\nend_header\n"), *line = strstr(head, "\nelement "), *next;
    char type[16], name[16];
    long long rows;
    int place = 0, first = 0;
    if (strncmp(head, "ply\nformat binary_little_endian 1.0\n", 36) != 0 || !end || !line || line > end ||
        sscanf(line, "\nelement vertex %lld", &rows) != 1 || rows < 0)
        return 0;
    table[TABLE_STRIDE] = 0;
    for (line = strchr(line + 1, '\n') + 1; strncmp(line, "property ", 9) == 0; line = next) {
        int size;
        next = strchr(line, '\n') + 1;
        if (sscanf(line, "property %15s %15s", type, name) != 2 || (size = ply_size(type)) == 0) return 0;
        if (place < 3 && (strlen(name) != 1 || name[0] != 'x' + place || (type[0] != 'f' && type[0] != 'd') ||
                          (place && size != first)))
            return 0;
        first = place ? first : size;
        place++;
        table[TABLE_STRIDE] += size;
    }
    if (line != end + 1 && strncmp(line, "element ", 8) != 0) return 0; // more properties may follow a comment
    table[TABLE_OFFSET] = end + 12 - head;
    table[TABLE_ROWS] = rows;
    table[TABLE_COLUMNS] = 3;
    table[TABLE_FLOATS] = first == 4;
    return place >= 3;
}

static int has_extension(const char *name, const char *extension) {
    size_t n = strlen(name), m = strlen(extension);
    return n > m && strcasecmp(name + n - m, extension) == 0;
}

// Is the file, of `bytes` bytes, a table that has all its rows? A file that ends early is left to paradt_io_read, which
// reports the error. Bytes after the rows are ignored.
static int is_table(const settings *s, FILE *file, int64_t bytes, int64_t *table) {
    char head[4097];
    size_t size = fread(head, 1, sizeof head - 1, file);
    int found;
    int64_t dim;
    head[size] = '\0';
    if (has_extension(s->input, ".npy")) found = npy_table(head, size, table);
    else found = !s->want.weights && ply_table(head, table);
    dim = s->want.dim ? s->want.dim : table[TABLE_COLUMNS] - s->want.weights;
    return found && bytes >= table[TABLE_OFFSET] &&
           table[TABLE_ROWS] <= (bytes - table[TABLE_OFFSET]) / table[TABLE_STRIDE] && dim >= 2 &&
           dim <= PARADT_MAX_DIM && dim + s->want.weights <= table[TABLE_COLUMNS];
}

// Can the input be read only once? A missing file is left to paradt_io_read, which reports the error.
static int is_stream(const char *input) {
    struct stat about;
    return strcmp(input, "-") == 0 || (stat(input, &about) == 0 && !S_ISREG(about.st_mode));
}

// Finds out on rank 0 whether the input is a table, which the ranks can read in parts; collective. Returns 1 if it is.
// MPI takes a name before a colon for a file system, so a name with a colon is left to paradt_io_read.
static int find_table(const settings *s, int64_t *table) {
    static const union {
        unsigned short number;
        unsigned char bytes[2];
    } order = {1};
    struct stat about;
    int found = 0, plain = !s->want.columns && !s->want.format && !s->want.radii;
    if (rank == 0 && plain && order.bytes[0] && (has_extension(s->input, ".npy") || has_extension(s->input, ".ply")) &&
        !strchr(s->input, ':') && stat(s->input, &about) == 0 && S_ISREG(about.st_mode)) {
        FILE *file = fopen(s->input, "rb");
        found = file && is_table(s, file, (int64_t)about.st_size, table);
        if (file) fclose(file);
    }
    MPI_Bcast(&found, 1, MPI_INT, 0, MPI_COMM_WORLD);
    MPI_Bcast(table, TABLE_FIELDS, MPI_INT64_T, 0, MPI_COMM_WORLD);
    return found;
}

// Returns the index of the first element of rank r, if `count` elements are dealt out in blocks.
static int64_t first_of(int64_t count, int r) {
    return count / ranks * r + count % ranks * r / ranks;
}

// Reads `bytes` bytes at the offset, which differ between ranks; collective. Returns 0 after an error.
static int read_bytes(MPI_File file, int64_t offset, char *to, int64_t bytes) {
    const int64_t piece = 1 << 30;
    int64_t most = bytes, done;
    int good = 1;
    MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);
    for (done = 0; done < most; done += piece) {
        int64_t left = bytes - done;
        MPI_Status status;
        int count = left <= 0 ? 0 : left < piece ? (int)left : (int)piece, got = 0;
        good &= MPI_File_read_at_all(file, offset + done, to + done, count, MPI_BYTE, &status) == MPI_SUCCESS;
        MPI_Get_count(&status, MPI_BYTE, &got);
        good &= got == count;
    }
    return good;
}

// Copies the column after the coordinates to the weights.
static void take_weights(part *p) {
    size_t i, size = p->points.scalar == PARADT_F32 ? 4 : 8;
    for (i = 0; i < p->points.count; i++) {
        const char *at = (const char *)p->rows + i * p->points.stride + (size_t)p->points.dim * size;
        float narrow;
        if (size == 4) {
            memcpy(&narrow, at, size);
            p->weights[i] = narrow;
        } else memcpy(p->weights + i, at, size);
    }
    p->points.weights = p->weights;
}

// Reads this rank's rows of the table; collective. Returns the exit status.
static int read_table(const settings *s, const int64_t *table, part *p) {
    int64_t first = first_of(table[TABLE_ROWS], rank), count = first_of(table[TABLE_ROWS], rank + 1) - first;
    MPI_File file;
    int status = EXIT_DONE;
    p->first = (uint64_t)first;
    p->points.count = (size_t)count;
    p->points.dim = s->want.dim ? s->want.dim : (int)table[TABLE_COLUMNS] - s->want.weights;
    p->points.stride = (size_t)table[TABLE_STRIDE];
    p->points.scalar = table[TABLE_FLOATS] ? PARADT_F32 : PARADT_F64;
    p->rows = malloc((size_t)(count * table[TABLE_STRIDE]) + 1);
    p->weights = s->want.weights ? (double *)malloc((size_t)count * sizeof(double) + 1) : NULL;
    p->points.data = p->rows;
    if (agree(!p->rows || (s->want.weights && !p->weights)))
        return fail(EXIT_FAILED, "%s: not enough memory", s->input);
    if (MPI_File_open(MPI_COMM_WORLD, s->input, MPI_MODE_RDONLY, MPI_INFO_NULL, &file) != MPI_SUCCESS)
        return fail(EXIT_INPUT, "%s: can't be opened by all ranks", s->input);
    if (!read_bytes(file, table[TABLE_OFFSET] + first * table[TABLE_STRIDE], (char *)p->rows,
                    count * table[TABLE_STRIDE]))
        status = EXIT_INPUT;
    MPI_File_close(&file);
    if (agree(status)) return fail(EXIT_INPUT, "%s: can't be read", s->input);
    if (p->weights) take_weights(p);
    return EXIT_DONE;
}

// Generates this rank's part of a gen: input; collective. Returns the exit status.
static int generate(const settings *s, part *p) {
    paradt_gen_spec spec;
    const char *reason = paradt_gen_parse(&spec, s->input);
    int dim = s->want.dim ? s->want.dim : 3;
    int64_t first, end;
    double *x;
    if (reason) return fail(EXIT_USAGE, "%s: %s", s->input, reason);
    first = s->replicated ? 0 : first_of((int64_t)spec.count, rank);
    end = s->replicated ? (int64_t)spec.count : first_of((int64_t)spec.count, rank + 1);
    p->first = (uint64_t)first;
    p->points.count = (size_t)(end - first);
    p->points.dim = dim;
    p->rows = x = (double *)malloc(p->points.count * (size_t)dim * sizeof *x + 1);
    p->weights = s->want.weights ? (double *)malloc(p->points.count * sizeof(double) + 1) : NULL;
    if (agree(!x || (s->want.weights && !p->weights))) return fail(EXIT_FAILED, "%s: not enough memory", s->input);
    paradt_gen_points(&spec, dim, (size_t)first, p->points.count, x);
    if (p->weights) paradt_gen_weights(&spec, dim, (size_t)first, p->points.count, p->weights);
    p->points.data = x;
    p->points.weights = p->weights;
    p->whole = s->replicated;
    return EXIT_DONE;
}

static int exit_status(paradt_io_status status) {
    static const int statuses[] = {EXIT_DONE, EXIT_INPUT, EXIT_USAGE, EXIT_FAILED};
    return statuses[status];
}

// Reads the whole input on rank 0, or on all ranks; collective. Without on_all the other ranks get no points. Returns
// the exit status.
static int read_whole(const settings *s, int on_all, part *p) {
    paradt_io_points points;
    paradt_io_error error;
    int status = EXIT_DONE, dim = 0;
    memset(&points, 0, sizeof points);
    if (rank == 0 && on_all && ranks > 1 && is_stream(s->input)) {
        paradt_io__error(&error, PARADT_IO_BAD_NAME,
                         "%.900s: --replicated reads the input on every rank, so it has to be a file", s->input);
        status = EXIT_USAGE;
    } else if (rank == 0 && !paradt_io_read(&points, s->input, &s->want, &error)) status = exit_status(error.status);
    if (rank == 0 && !status && *points.note) fprintf(stderr, "paradt_mpi: %s: %s\n", s->input, points.note);
    status = agree_on(status, &error);
    if (!status) { // the other ranks read only what rank 0 could read
        if (on_all && rank > 0 && !paradt_io_read(&points, s->input, &s->want, &error))
            status = exit_status(error.status);
        status = agree_on(status, &error);
    }
    dim = points.dim;
    MPI_Bcast(&dim, 1, MPI_INT, 0, MPI_COMM_WORLD);
    p->whole = 1;
    p->rows = points.coordinates;
    p->weights = points.weights;
    p->points.data = points.coordinates;
    p->points.count = points.count;
    p->points.dim = dim;
    p->points.weights = points.weights;
    return status;
}

// Reads or generates this rank's part of the input; collective. Returns the exit status.
static int read_part(const settings *s, part *p) {
    int64_t table[TABLE_FIELDS] = {0};
    if (strncmp(s->input, "gen:", 4) == 0) return generate(s, p);
    if (!s->replicated && find_table(s, table)) return read_table(s, table, p);
    return read_whole(s, s->replicated, p);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>report

static void print_json(FILE *out, const settings *s, const part *p, const paradt_mpi_triangulation *t, uint64_t hash) {
    fprintf(out, "{\n  \"ranks\": %d,\n  \"points_given\": %" PRIu64 ",\n  \"dim\": %d,\n  \"affine_dim\": %d,\n",
            ranks, t->point_total, p->points.dim, t->dim);
    fprintf(out, "  \"method\": \"%s\",\n  \"hash\": \"%016" PRIx64 "\",\n", paradt_method_string(s->method), hash);
#define PRINT_COUNTER(name, about)                                                                                     \
    fprintf(out, "  \"%s\": %" PRIu64 ",\n  \"%s_largest\": %" PRIu64 ",\n", #name, t->sum.name, #name,                \
            t->largest.name);
#define PRINT_TIMER(name, about)                                                                                       \
    fprintf(out, "  \"%s_sum\": %.6f,\n  \"%s_largest\": %.6f,\n", #name, t->sum.name, #name, t->largest.name);
    PARADT_MPI_COUNTERS(PRINT_COUNTER)
    PARADT_MPI_TIMERS(PRINT_TIMER)
    fprintf(out, "  \"seconds\": %.6f\n}\n", t->largest.seconds);
}

static void print_summary(const settings *s, const part *p, const paradt_mpi_triangulation *t) {
    static const char *const flats[] = {"at one place", "on one line", "in one plane"};
    double cells = (double)t->cell_total;
    size_t i;
    printf("points       %" PRIu64 " in %d dimensions", t->point_total, p->points.dim);
    if (t->dim >= 0 && t->dim <= 2 && t->dim < p->points.dim) printf(", all %s", flats[t->dim]);
    else if (t->dim > 2 && t->dim < p->points.dim) printf(", all in a flat of dimension %d", t->dim);
    printf("\ncells        %" PRIu64 " (%" PRIu64 " a rank, at most %" PRIu64 ")\nhull facets  %" PRIu64 "\n",
           t->cell_total, t->cell_total / (uint64_t)ranks, t->largest.cells, t->sum.hull_facets);
    printf("duplicates   %" PRIu64 "\n", t->sum.duplicates);
    if (s->want.weights) printf("hidden       %" PRIu64 "\n", t->sum.hidden);
    printf("time         %.3f s on %d rank%s (%s), %.2f %% more cells made\n", t->largest.seconds, ranks,
           ranks == 1 ? "" : "s", s->replicated ? "replicated" : "distributed",
           cells > 0 ? 100.0 * (double)t->sum.cells_recomputed / cells : 0.0);
    printf("exchanged    %" PRIu64 " points, %.1f MB in %" PRIu64 " messages\n",
           t->sum.points_guessed + t->sum.points_asked, (double)t->sum.bytes_sent * 1e-6, t->sum.messages_sent);
    for (i = 0; i < s->output_count; i++) printf("wrote        %s\n", s->outputs[i]);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>output

static int is_pvtu(const char *name) {
    size_t n = strlen(name);
    return n > 5 && strcasecmp(name + n - 5, ".pvtu") == 0;
}

// Returns the name of rank r's piece, "cluster_3.vtu" for "cluster.pvtu", from malloc; NULL if there is no memory.
static char *piece_name(const char *name, int r) {
    size_t size = strlen(name) + 24;
    char *piece = (char *)malloc(size);
    if (piece) snprintf(piece, size, "%.*s_%d.vtu", (int)strlen(name) - 5, name, r);
    return piece;
}

// Returns the first n characters of a name, escaped for an attribute of XML, from malloc; NULL if there is no memory.
static char *escaped(const char *name, size_t n) {
    char *text = (char *)malloc(6 * n + 1), *to = text;
    size_t i;
    for (i = 0; text && i < n; i++) {
        const char *as = name[i] == '&' ? "&amp;" : name[i] == '<' ? "&lt;" : name[i] == '"' ? "&quot;" : NULL;
        if (as) to += sprintf(to, "%s", as);
        else *to++ = name[i];
    }
    if (text) *to = '\0';
    return text;
}

// Returns the contents of the .pvtu, which lists the pieces, from malloc; NULL if there is no memory.
static char *pvtu_text(const char *name) {
    const char *slash = strrchr(name, '/'), *base = slash ? slash + 1 : name;
    char *pieces = escaped(base, strlen(base) - 5), *text;
    size_t capacity = 1024 + (size_t)ranks * (pieces ? strlen(pieces) + 64 : 0), used;
    int r;
    text = pieces ? (char *)malloc(capacity) : NULL;
    if (!text) {
        free(pieces);
        return NULL;
    }
    used =
        (size_t)snprintf(text, capacity,
                         "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
                         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n"
                         "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
                         "</PPoints>\n");
    for (r = 0; r < ranks; r++)
        used += (size_t)snprintf(text + used, capacity - used, "<Piece Source=\"%s_%d.vtu\"/>\n", pieces, r);
    free(pieces);
    snprintf(text + used, capacity - used, "</PUnstructuredGrid>\n</VTKFile>\n");
    return text;
}

// Writes this rank's piece and, on rank 0, the .pvtu. Returns 1, or 0 with the error filled in.
static int write_pieces(const char *name, const paradt_mpi_triangulation *t, paradt_io_error *error) {
    char *piece = piece_name(name, rank), *text = rank == 0 ? pvtu_text(name) : NULL;
    paradt_io_points points;
    paradt_triangulation own;
    int good;
    memset(&points, 0, sizeof points);
    memset(&own, 0, sizeof own);
    points.dim = t->ambient;
    points.count = t->vertex_count;
    points.coordinates = t->coordinates;
    own.dim = t->dim;
    own.cell_count = t->cell_count;
    own.cells = t->cells;
    own.point_count = t->vertex_count;
    if (!piece || (rank == 0 && !text)) good = paradt_io__no_memory(error, name);
    else {
        good = paradt_io_write(&stage, piece, &points, &own, error);
        if (good && rank == 0) good = paradt_io_write_text(&stage, name, text, error);
    }
    free(piece);
    free(text);
    return good;
}

// Checks and writes the gathered result on rank 0. Returns 1, or 0 with the error filled in.
//   all  all points
//   t    all cells
static int finish_whole(const settings *s, const part *all, const paradt_triangulation *t, paradt_io_error *error) {
    paradt_io_points points;
    paradt_options options;
    paradt_fault fault = {NULL, -1, -1};
    size_t i;
    memset(&points, 0, sizeof points);
    points.dim = all->points.dim;
    points.count = all->points.count;
    points.coordinates = (double *)all->rows;
    points.weights = all->weights;
    memset(&options, 0, sizeof options);
    options.flags = PARADT_FACETS;
    paradt_status status = s->check ? paradt_check(t, &all->points, &options, &fault) : PARADT_OK;
    if (status)
        return paradt_io__error(error, PARADT_IO_FAILED, "%.900s: the check %s: %s", s->input,
                                fault.reason ? "found" : "can't be done",
                                fault.reason ? fault.reason : paradt_status_string(status));
    for (i = 0; i < s->output_count; i++)
        if (!is_pvtu(s->outputs[i]) && !paradt_io_write(&stage, s->outputs[i], &points, t, error)) return 0;
    return 1;
}

// Gathers the cells on rank 0, checks and writes them there; collective. Returns the exit status.
static int finish_gathered(const settings *s, const part *p, const paradt_mpi_triangulation *t) {
    paradt_io_error error;
    paradt_triangulation whole;
    paradt_status gathered = paradt_mpi_gather(&whole, MPI_COMM_WORLD, t, 0);
    part again;
    int status;
    if (gathered) return fail(EXIT_FAILED, "%s: %s", s->input, paradt_status_string(gathered));
    memset(&again, 0, sizeof again);
    status = p->whole ? EXIT_DONE : read_whole(s, 0, &again);
    if (!status) {
        if (rank == 0 && !finish_whole(s, p->whole ? p : &again, &whole, &error))
            status = exit_status(error.status);
        status = agree_on(status, &error);
    }
    paradt_free(&whole);
    part_free(&again);
    return status;
}

// Writes all outputs under temporary names and checks the result; collective. Returns the exit status.
static int finish(const settings *s, const part *p, const paradt_mpi_triangulation *t) {
    paradt_io_error error;
    int status = EXIT_DONE, gathers = s->check;
    size_t i;
    for (i = 0; i < s->output_count; i++) {
        gathers |= !is_pvtu(s->outputs[i]);
        if (is_pvtu(s->outputs[i]) && !status && !write_pieces(s->outputs[i], t, &error))
            status = exit_status(error.status);
    }
    status = agree_on(status, &error);
    return !status && gathers ? finish_gathered(s, p, t) : status;
}

// Do the statistics go to a file?
static int has_stats_file(const settings *s) {
    return s->stats && strcmp(s->stats, "-") != 0;
}

// Returns 1, or 0 with the error filled in.
static int write_stats(const settings *s, const part *p, const paradt_mpi_triangulation *t, uint64_t hash,
                       paradt_io_error *error) {
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    int good = out != NULL;
    if (out) {
        print_json(out, s, p, t, hash);
        good = !ferror(out);
        good &= fclose(out) == 0;
    }
    good = good ? paradt_io_write_text(&stage, s->stats, text, error) : paradt_io__no_memory(error, s->stats);
    free(text);
    return good;
}

// Prints and writes the statistics on rank 0. Returns the exit status.
static int report(const settings *s, const part *p, const paradt_mpi_triangulation *t, uint64_t hash) {
    paradt_io_error error;
    if (rank) return EXIT_DONE;
    if (has_stats_file(s) && !write_stats(s, p, t, hash, &error))
        return fail(exit_status(error.status), "%s", error.text);
    if (s->stats && !has_stats_file(s)) print_json(stdout, s, p, t, hash);
    else if (!s->quiet) print_summary(s, p, t);
    if (s->hash) printf("%016" PRIx64 "\n", hash);
    return fflush(stdout) == 0 && !ferror(stdout) ? EXIT_DONE : fail(EXIT_FAILED, "standard output can't be written");
}

// ---------------------------------------------------------------------------------------------------------------------
// >>main

// Is the name that of a piece of the .pvtu?
static int is_piece_of(const char *name, const char *pvtu) {
    size_t stem = strlen(pvtu) - 5, digits;
    if (strncmp(name, pvtu, stem) != 0 || name[stem] != '_') return 0;
    digits = strspn(name + stem + 1, "0123456789");
    return digits && strcasecmp(name + stem + 1 + digits, ".vtu") == 0 && atol(name + stem + 1) < ranks;
}

// Checks on rank 0 that all outputs can be written. dim: of the points; 0: not known yet. Returns the exit status.
static int check_outputs(const settings *s, int dim) {
    paradt_io_error error;
    const char *piece = NULL;
    size_t i, j;
    for (i = 0; i < s->output_count && rank == 0; i++) {
        int good = is_pvtu(s->outputs[i]) ? paradt_io_check_place(s->outputs[i], s->input, &error)
                                          : paradt_io_check_output(s->outputs[i], dim, s->input, &error);
        if (good && is_pvtu(s->outputs[i]) && dim > 3)
            return fail(EXIT_USAGE, "%s: .pvtu files hold at most 3 dimensions, not %d", s->outputs[i], dim);
        if (!good) return fail(exit_status(error.status), "%s", error.text);
        if (!is_pvtu(s->outputs[i])) continue;
        for (j = 0; j < s->output_count; j++)
            if (is_piece_of(s->outputs[j], s->outputs[i])) piece = s->outputs[j];
        if (has_stats_file(s) && is_piece_of(s->stats, s->outputs[i])) piece = s->stats;
        if (piece) return fail(EXIT_USAGE, "%s: %s has a piece of that name", piece, s->outputs[i]);
    }
    if (rank == 0 && has_stats_file(s) && !paradt_io_check_place(s->stats, s->input, &error))
        return fail(exit_status(error.status), "%s", error.text);
    return EXIT_DONE;
}

// A paradt_progress
static int show_progress(void *user, double fraction) {
    paradt_io_bar_draw((paradt_io_bar *)user, fraction);
    return 0;
}

// Triangulates the points of all ranks; collective. Returns the exit status.
static int triangulate(const settings *s, const part *p, paradt_mpi_triangulation *t) {
    paradt_mpi_options options;
    paradt_io_bar bar;
    paradt_status status;
    memset(&options, 0, sizeof options);
    paradt_io_bar_begin(&bar);
    if (rank == 0 && (s->progress || (!s->quiet && isatty(STDERR_FILENO)))) options.local.progress = show_progress;
    options.local.user = &bar;
    options.local.flags = PARADT_FACETS;
    options.local.method = s->method;
    options.local.partition = s->partition;
    options.flags = s->replicated ? PARADT_MPI_REPLICATED : 0;
    status = paradt_mpi_triangulate(t, MPI_COMM_WORLD, &p->points, &options);
    paradt_io_bar_clear(&bar);
    if (status == PARADT_ERROR_NOT_FINITE) {
        uint64_t first = p->first;
        MPI_Bcast(&first, 1, MPI_UINT64_T, t->error_rank, MPI_COMM_WORLD);
        return fail(EXIT_INPUT, "%s: point %" PRIu64 " is not finite", s->input, first + (uint64_t)t->error_point);
    }
    if (status) return fail(EXIT_FAILED, "%s: rank %d: %s", s->input, t->error_rank, t->error_text);
    return EXIT_DONE;
}

static int run(const settings *s) {
    part p;
    paradt_mpi_triangulation t;
    paradt_io_error error;
    int status = agree(check_outputs(s, s->want.dim));
    memset(&p, 0, sizeof p);
    memset(&t, 0, sizeof t);
    if (!status) status = agree(read_part(s, &p));
    if (!status) status = agree(check_outputs(s, p.points.dim));
    if (!status) status = agree(triangulate(s, &p, &t));
    if (!status) {
        uint64_t hash = paradt_mpi_hash(&t, MPI_COMM_WORLD);
        int staged = paradt_io_stage_init(&stage, s->output_count * PARADT_IO_FILES_PER_OUTPUT + 1, &error);
        status = agree(staged ? EXIT_DONE : EXIT_FAILED);
        if (!status) status = finish(s, &p, &t);
        if (!status) status = agree(report(s, &p, &t, hash));
        if (!status) {
            if (!paradt_io_stage_commit(&stage, &error)) status = exit_status(error.status);
            status = agree_on(status, &error);
        }
        if (status && staged) paradt_io_stage_abort(&stage);
        if (staged) paradt_io_stage_free(&stage);
    }
    paradt_mpi_free(&t);
    part_free(&p);
    return status;
}

int main(int count, char **arguments) {
    settings s;
    int status;
    MPI_Init(&count, &arguments);
    paradt_io_stage_guard(&stage);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    memset(&s, 0, sizeof s);
    s.outputs = (const char **)malloc((size_t)count * sizeof *s.outputs);
    status = agree(s.outputs ? EXIT_DONE : EXIT_FAILED);
    if (!status) status = parse(&s, count, arguments) ? EXIT_DONE : EXIT_USAGE;
    if (!status && s.help) {
        if (rank == 0) print_help();
    } else if (!status && s.version) {
        if (rank == 0)
            printf("paradt_mpi %d.%d.%d\n", PARADT_VERSION / 10000, PARADT_VERSION / 100 % 100, PARADT_VERSION % 100);
    } else if (!status) status = run(&s);
    free(s.outputs);
    MPI_Finalize();
    return status;
}
