// paradt_io.h - reads point sets and writes triangulations, for the command-line tools
//
// In one file: #define PARADT_IO_IMPLEMENTATION, then #include "paradt_io.h". C99 and POSIX with XSI; include it before
// any system header or define _XOPEN_SOURCE as 700 yourself. Numbers are read and written for the "C" locale.
//
//     paradt_io_points points;
//     paradt_io_error  error;
//     if (!paradt_io_read(&points, "cloud.ply", NULL, &error)) fprintf(stderr, "%s\n", error.text);
//
// Input, by extension (paradt_io_inputs lists them); every number is correctly rounded, NaN and infinities are refused:
//   .xyz .txt .csv  a point a line; blanks, tabs, a comma or a semicolon between numbers; blank lines and comments,
//                   from # on, are skipped. .xyz: three coordinates. .txt, .csv: every column is a coordinate. .csv: a
//                   first line without numbers is a title.
//   .node           TetGen and Triangle: first index 0 or 1, attributes, markers. The weight is the first attribute.
//   .off            OFF and its relatives with normals, colours or n dimensions, in ASCII.
//   .ply            ASCII, binary little- or big-endian; properties x, y, z of any type in any order. The weight is the
//                   property "weight" or "w", else the one that follows the last coordinate.
//   .npy            arrays of float32 or float64, (points, columns), of either byte order and memory order.
//   .pdb            ATOM and HETATM records of the first model; the weight is the squared van der Waals radius.
//   -               standard input, as .txt
//   gen:KIND:N:SEED points made by paradt_points.h
//
// Output, by extension (paradt_io_outputs lists them):
//   .ele            cells; with .node (points, first index 0) and .neigh (neighbours) beside it
//   .vtu            an unstructured grid for ParaView, binary
//   .off .ply .obj  the surface: facets of the hull when the result is 3-dimensional or more, the cells when less.
//                   .off has all the points (as nOFF beyond three dimensions), the others only those of the surface.
//   .npy            the array of cells
//   .svg .png       a picture (paradt_picture.h)
// Files are written under temporary names and get their own when all are complete: see paradt_io_stage.

#ifndef PARADT_IO_H
#define PARADT_IO_H

#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700
#endif

#include "../paradt.h"

#include <signal.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum paradt_io_status {
    PARADT_IO_OK,
    PARADT_IO_BAD_INPUT, // the input can't be read, or a number is not finite
    PARADT_IO_BAD_NAME,  // the name of an input or output says nothing usable
    PARADT_IO_FAILED     // out of memory, or the output can't be written
} paradt_io_status;

typedef struct paradt_io_error {
    paradt_io_status status;
    char text[1024]; // "FILE:LINE: reason", without a newline
} paradt_io_error;

typedef struct paradt_io_want {
    int dim;     // coordinates to take of each point; 0: as the file has it
    int weights; // nonzero: the column after the coordinates is a weight
} paradt_io_want;

typedef struct paradt_io_points {
    int dim;
    size_t count;
    double *coordinates; // [count][dim], from malloc
    double *weights;     // [count], from malloc; NULL: none
} paradt_io_points;

// Reads a file, "-" or "gen:...". Returns 1, or 0 with the error filled in and the points empty. want: NULL is zero.
int paradt_io_read(paradt_io_points *points, const char *input, const paradt_io_want *want, paradt_io_error *error);
void paradt_io_free(paradt_io_points *points);

// Output files that exist under temporary names beside their own until all of them are complete.
typedef struct paradt_io_staged {
    char *name;
    char *temporary;
    char *former; // another name of what stood there, while the files get their names; NULL: none
} paradt_io_staged;

typedef struct paradt_io_stage {
    paradt_io_staged *files;
    size_t capacity;
    volatile sig_atomic_t count;
} paradt_io_stage;

enum { PARADT_IO_FILES_PER_OUTPUT = 3 }; // capacity that one paradt_io_write takes

int paradt_io_stage_init(paradt_io_stage *stage, size_t capacity, paradt_io_error *error);
int paradt_io_stage_commit(paradt_io_stage *stage,
                           paradt_io_error *error); // all files get their names, or none is left
void paradt_io_stage_abort(paradt_io_stage *stage); // removes the temporary files; may be called by a signal handler
void paradt_io_stage_free(paradt_io_stage *stage);
// From now on a signal that ends the program removes the temporary files of this stage, which may be all zero yet.
void paradt_io_stage_guard(paradt_io_stage *stage);

// Can a file of this name be made, and without replacing the input (NULL: any)?
int paradt_io_check_place(const char *name, const char *input, paradt_io_error *error);
// Is there a writer for this name, for points of this dimension (0: not known yet), and a place to write to?
int paradt_io_check_output(const char *name, int dim, const char *input, paradt_io_error *error);
// Writes one output (PARADT_IO_FILES_PER_OUTPUT files at most) into the stage. Returns 1, or 0 with the error filled
// in.
int paradt_io_write(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                    const paradt_triangulation *triangulation, paradt_io_error *error);
// Writes a text into the stage as a file of its own.
int paradt_io_write_text(paradt_io_stage *stage, const char *name, const char *text, paradt_io_error *error);

const char *paradt_io_inputs(void);  // ".xyz .txt ..."
const char *paradt_io_outputs(void); // ".ele .vtu ..."

// A progress bar on standard error, drawn when a second has passed and then ten times a second at most; for one thread
// at a time. fraction: 0 to 1.
typedef struct paradt_io_bar {
    double begun, shown; // seconds; shown 0: never
} paradt_io_bar;

double paradt_io_now(void); // seconds since some time
void paradt_io_bar_begin(paradt_io_bar *bar);
void paradt_io_bar_draw(paradt_io_bar *bar, double fraction);
void paradt_io_bar_clear(const paradt_io_bar *bar);

#ifdef __cplusplus
}
#endif

#endif // PARADT_IO_H

#ifdef PARADT_IO_IMPLEMENTATION
#ifndef PARADT_IO_IMPLEMENTATION_DONE
#define PARADT_IO_IMPLEMENTATION_DONE

#define PARADT_POINTS_IMPLEMENTATION
#include "paradt_points.h"
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
// >>errors
// Every function that can fail returns 1 for success, or 0 after it has filled in the error.

#if defined(__GNUC__)
#define PARADT_IO__FORMAT(text, first) __attribute__((format(printf, text, first)))
#else
#define PARADT_IO__FORMAT(text, first)
#endif

static int paradt_io__error(paradt_io_error *error, paradt_io_status status, const char *format, ...)
    PARADT_IO__FORMAT(3, 4);

static int paradt_io__error(paradt_io_error *error, paradt_io_status status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    error->status = status;
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return 0;
}

static int paradt_io__no_memory(paradt_io_error *error, const char *name) {
    return paradt_io__error(error, PARADT_IO_FAILED, "%.900s: not enough memory", name);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>reader: a file in memory, the line that is being read, and the rows read so far

typedef struct paradt_io__reader {
    const char *name;                      // what errors call the input
    const struct paradt_io__input *format; // its row of the table of formats
    const char *next;                      // first byte that has not been read
    const char *end;                       // a NUL stands here
    const char *cur;                       // rest of the current line
    const char *stop;                      // its end
    size_t line;                           // its number; 0: the data is binary
    int dim;                               // coordinates wanted; 0: as the file has it
    int weighted;                          // 1: and a weight after them
    double *rows;                          // [count][dim + weighted]
    size_t count;                          //
    size_t capacity;                       //
    paradt_io_error *error;                //
} paradt_io__reader;

typedef struct paradt_io__input {
    const char *extension;
    int (*read)(paradt_io__reader *reader);
    int dim;    // of text: how many coordinates when nothing is said; 0: all columns
    int titled; // of text: the first line may be a title
} paradt_io__input;

static int paradt_io__bad(paradt_io__reader *r, const char *format, ...) PARADT_IO__FORMAT(2, 3);

static int paradt_io__bad(paradt_io__reader *r, const char *format, ...) {
    char reason[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(reason, sizeof reason, format, arguments);
    va_end(arguments);
    if (r->line)
        return paradt_io__error(r->error, PARADT_IO_BAD_INPUT, "%.700s:%zu: %s", r->name, r->line, reason);
    return paradt_io__error(r->error, PARADT_IO_BAD_INPUT, "%.700s: %s", r->name, reason);
}

// Tested on the bits: a compiler that assumes finite mathematics may not take this away.
static int paradt_io__finite(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return (bits >> 52 & 0x7ff) != 0x7ff;
}

static int paradt_io__grow(paradt_io__reader *r, size_t columns) {
    size_t capacity = r->capacity ? 2 * r->capacity : 1024;
    double *rows = NULL;
    if (capacity <= SIZE_MAX / (columns * sizeof *rows))
        rows = (double *)realloc(r->rows, capacity * columns * sizeof *rows);
    if (!rows)
        return paradt_io__no_memory(r->error, r->name);
    r->rows = rows;
    r->capacity = capacity;
    return 1;
}

// Adds a point. row: dim coordinates, and the weight when one is wanted
static int paradt_io__push(paradt_io__reader *r, const double *row) {
    size_t columns = (size_t)(r->dim + r->weighted), k;
    for (k = 0; k < columns; k++)
        if (!paradt_io__finite(row[k])) {
            const char *what = k < (size_t)r->dim ? "coordinate" : "weight, number";
            if (r->line)
                return paradt_io__bad(r, "%s %zu is not finite", what, k + 1);
            return paradt_io__bad(r, "point %zu: %s %zu is not finite", r->count, what, k + 1);
        }
    if (r->count == r->capacity && !paradt_io__grow(r, columns))
        return 0;
    memcpy(r->rows + r->count++ * columns, row, columns * sizeof *row);
    return 1;
}

// Settles how many coordinates are taken of the `available` ones.
static int paradt_io__settle_dim(paradt_io__reader *r, int available) {
    if (available < 0)
        return paradt_io__bad(r, "no column is left for the weight");
    if (r->dim > available)
        return paradt_io__bad(r, "%d coordinates where %d are wanted", available, r->dim);
    if (!r->dim)
        r->dim = available;
    if (r->dim > PARADT_MAX_DIM)
        return paradt_io__bad(r, "more than %d coordinates", PARADT_MAX_DIM);
    if (r->dim < 2)
        return paradt_io__bad(r, "2 to %d coordinates are wanted, not %d", PARADT_MAX_DIM, r->dim);
    return 1;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>lines

// Makes the next line the current one; lines end with LF, CR or both. Returns 0 at the end of the file.
static int paradt_io__next_line(paradt_io__reader *r) {
    const char *at = r->next;
    if (at == r->end)
        return 0;
    r->cur = at;
    while (at < r->end && *at != '\n' && *at != '\r')
        at++;
    r->stop = at;
    if (at + 1 < r->end && at[0] == '\r' && at[1] == '\n')
        at++;
    r->next = at < r->end ? at + 1 : at;
    r->line++;
    return 1;
}

static void paradt_io__skip_blanks(paradt_io__reader *r) {
    while (r->cur < r->stop && (*r->cur == ' ' || *r->cur == '\t' || *r->cur == '\v' || *r->cur == '\f'))
        r->cur++;
}

static int paradt_io__at_end_of_line(const paradt_io__reader *r) {
    return r->cur == r->stop || *r->cur == '#';
}

// The next line that holds more than blanks and a comment.
static int paradt_io__next_content(paradt_io__reader *r) {
    while (paradt_io__next_line(r)) {
        paradt_io__skip_blanks(r);
        if (!paradt_io__at_end_of_line(r))
            return 1;
    }
    return 0;
}

static int paradt_io__delimits(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r') || c == ',' || c == ';' || c == '#';
}

// The rest of the current token, made printable for an error message.
static const char *paradt_io__quote(const paradt_io__reader *r, char *text, size_t size) {
    size_t n = 0;
    for (; n + 1 < size && r->cur + n < r->stop && !paradt_io__delimits(r->cur[n]); n++)
        text[n] = (char)(r->cur[n] > ' ' && r->cur[n] < 127 ? r->cur[n] : '?');
    text[n] = '\0';
    return text;
}

// Takes the token (letters, digits, _ ...) at the beginning of the rest of the line.
static size_t paradt_io__token(paradt_io__reader *r, const char **token) {
    paradt_io__skip_blanks(r);
    *token = r->cur;
    while (r->cur < r->stop && !paradt_io__delimits(*r->cur))
        r->cur++;
    return (size_t)(r->cur - *token);
}

static int paradt_io__is(const char *token, size_t length, const char *word) {
    return strlen(word) == length && memcmp(token, word, length) == 0;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>numbers: decimal text to the nearest double, ties to even

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 paradt_io__u128;

static const uint64_t paradt_io__fives[] = {1u,
                                            5u,
                                            25u,
                                            125u,
                                            625u,
                                            3125u,
                                            15625u,
                                            78125u,
                                            390625u,
                                            1953125u,
                                            9765625u,
                                            48828125u,
                                            244140625u,
                                            1220703125u,
                                            UINT64_C(6103515625),
                                            UINT64_C(30517578125),
                                            UINT64_C(152587890625),
                                            UINT64_C(762939453125),
                                            UINT64_C(3814697265625),
                                            UINT64_C(19073486328125),
                                            UINT64_C(95367431640625),
                                            UINT64_C(476837158203125),
                                            UINT64_C(2384185791015625),
                                            UINT64_C(11920928955078125),
                                            UINT64_C(59604644775390625),
                                            UINT64_C(298023223876953125),
                                            UINT64_C(1490116119384765625),
                                            UINT64_C(7450580596923828125)};

// digits * 10^power, exactly rounded in integers, so that neither flags nor the rounding mode touch it. 5^27 < 2^63,
// hence the product, or the quotient with its remainder, of a 64-bit integer and a power of five tells everything.
// Returns 0 for larger powers. The result is a normal number: its exponent stays within +-160.
static int paradt_io__scale(uint64_t digits, int power, double *value) {
    paradt_io__u128 wide, rest, half;
    uint64_t bits;
    int exponent = power, drop, sticky = 0;
    *value = 0;
    if (power < -27 || power > 27)
        return 0;
    if (!digits)
        return 1;
    while (!(digits >> 63)) {
        digits <<= 1;
        exponent--;
    }
    if (power >= 0)
        wide = (paradt_io__u128)digits * paradt_io__fives[power];
    else {
        wide = (paradt_io__u128)digits << 64;
        sticky = wide % paradt_io__fives[-power] != 0;
        wide /= paradt_io__fives[-power];
        exponent -= 64;
    }
    for (drop = 11; wide >> (drop + 53);) // wide >= 2^63: at least 11 bits go
        drop++;
    rest = wide & (((paradt_io__u128)1 << drop) - 1);
    half = (paradt_io__u128)1 << (drop - 1);
    bits = (uint64_t)(wide >> drop);
    if (rest > half || (rest == half && (sticky || bits & 1)))
        bits++;                                       // 2^53 carries into the exponent, as it should
    bits += (uint64_t)(exponent + drop + 1074) << 52; // the implied bit adds the missing 1
    memcpy(value, &bits, sizeof bits);
    return 1;
}
#else
static int paradt_io__scale(uint64_t digits, int power, double *value) {
    (void)digits, (void)power, (void)value;
    return 0;
}
#endif

typedef struct paradt_io__decimal {
    uint64_t digits; // the first 19 significant ones
    int power;       // of ten
    int exact;       // no digit was left out
} paradt_io__decimal;

// Scans "12.5e-3" without its sign. Returns its end, or NULL when there is no digit.
static const char *paradt_io__scan(const char *at, paradt_io__decimal *number) {
    int seen = 0, point = 0, power = 0, negative, used = 0;
    long exponent = 0;
    number->digits = 0;
    number->exact = 1;
    for (;; at++) {
        if (*at == '.' && !point) {
            point = 1;
            continue;
        }
        if (*at < '0' || *at > '9')
            break;
        seen = 1;
        if (used < 19) {
            number->digits = number->digits * 10 + (uint64_t)(*at - '0');
            used += number->digits != 0;
            power -= point;
        } else {
            number->exact &= *at == '0';
            power += !point;
        }
        if (power > 100000 || power < -100000)
            number->exact = 0, power = 0;
    }
    if (!seen)
        return NULL;
    if (*at == 'e' || *at == 'E') {
        const char *sign = at + 1, *digit = sign + (*sign == '-' || *sign == '+');
        negative = *sign == '-';
        for (at = digit; *at >= '0' && *at <= '9'; at++)
            if (exponent < 100000)
                exponent = exponent * 10 + (*at - '0');
        if (at == digit)
            return NULL;
        power += (int)(negative ? -exponent : exponent);
    }
    number->power = power;
    return at;
}

// Reads the number at the beginning of the rest of the line. Returns 0, and takes nothing, when the token is none.
// NaN and infinities are numbers here; the reader refuses them with a better reason.
static int paradt_io__number(paradt_io__reader *r, double *value) {
    paradt_io__decimal number;
    const char *begin = r->cur, *at = begin + (*begin == '-' || *begin == '+'), *stop;
    char *end;
    if (begin == r->stop)
        return 0;
    stop = paradt_io__scan(at, &number);
    if (stop && (stop == r->stop || paradt_io__delimits(*stop)) && number.exact &&
        paradt_io__scale(number.digits, number.power, value)) {
        if (*begin == '-')
            *value = -*value;
        r->cur = stop;
        return 1;
    }
    *value = strtod(begin, &end); // long or extreme decimals, hexadecimal, "nan", "inf"
    if (end == begin || (end != r->stop && !paradt_io__delimits(*end)))
        return 0;
    r->cur = end;
    return 1;
}

// Reads up to `limit` numbers from the current line. Returns how many there were, or -1 after an error.
static int paradt_io__fields(paradt_io__reader *r, double *values, int limit) {
    char quote[24];
    int n = 0;
    for (paradt_io__skip_blanks(r); n < limit && !paradt_io__at_end_of_line(r); n++) {
        if (!paradt_io__number(r, &values[n])) {
            if (paradt_io__delimits(*r->cur))
                paradt_io__bad(r, "a number is missing before '%c'", *r->cur);
            else
                paradt_io__bad(r, "'%s' is not a number", paradt_io__quote(r, quote, sizeof quote));
            return -1;
        }
        paradt_io__skip_blanks(r);
        if (r->cur < r->stop && (*r->cur == ',' || *r->cur == ';')) {
            r->cur++;
            paradt_io__skip_blanks(r);
        }
    }
    return n;
}

// Reads exactly `wanted` numbers from the current line; more may follow.
static int paradt_io__exactly(paradt_io__reader *r, double *values, int wanted) {
    int n = paradt_io__fields(r, values, wanted);
    if (n >= 0 && n < wanted)
        return paradt_io__bad(r, "%d number%s where %d are needed", n, n == 1 ? "" : "s", wanted);
    return n == wanted;
}

// Whole numbers up to 2^53, as counts in headers are.
static int paradt_io__natural(double value, uint64_t *number) {
    if (!paradt_io__finite(value) || value < 0 || value > 9007199254740992.0)
        return 0;
    *number = (uint64_t)value;
    return (double)*number == value;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>text: .xyz .txt .csv

static int paradt_io__is_title(paradt_io__reader *r) {
    const char *begin = r->cur;
    double value;
    int numbers = 0;
    while (r->cur < r->stop) {
        numbers += paradt_io__number(r, &value);
        while (r->cur < r->stop && !paradt_io__delimits(*r->cur))
            r->cur++;
        while (r->cur < r->stop && paradt_io__delimits(*r->cur))
            r->cur++;
    }
    r->cur = begin;
    return !numbers;
}

static int paradt_io__read_text(paradt_io__reader *r) {
    double row[PARADT_MAX_DIM + 2];
    int all = !r->dim && !r->format->dim, first = 1, columns;
    if (!r->dim)
        r->dim = r->format->dim;
    columns = all ? PARADT_MAX_DIM + 2 : r->dim + r->weighted;
    for (; paradt_io__next_content(r); first = 0) {
        int n;
        if (first && r->format->titled && paradt_io__is_title(r))
            continue;
        n = paradt_io__fields(r, row, columns);
        if (n < 0)
            return 0;
        if (all && !r->dim) {
            if (!paradt_io__settle_dim(r, n - r->weighted))
                return 0;
            columns = n;
        } else if (n < columns)
            return paradt_io__bad(r, "%d number%s where %d are needed", n, n == 1 ? "" : "s", columns);
        if (all && !paradt_io__at_end_of_line(r))
            return paradt_io__bad(r, "more than the first point's %d numbers", n);
        if (!paradt_io__push(r, row))
            return 0;
    }
    if (!r->dim)
        r->dim = 3;
    return 1;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>node and off: text with a header that says how many points follow

// Reads the announced points. skip: numbers before the coordinates, the first of which counts from 0 or 1
static int paradt_io__read_announced(paradt_io__reader *r, uint64_t count, int skip, int available) {
    double row[2 * PARADT_MAX_DIM + 2];
    uint64_t i, base = 0, index;
    for (i = 0; i < count; i++) {
        if (!paradt_io__next_content(r)) {
            r->line = 0;
            return paradt_io__bad(r, "%llu points announced, but the file ends after %llu", (unsigned long long)count,
                                  (unsigned long long)i);
        }
        if (!paradt_io__exactly(r, row, skip + available + r->weighted))
            return 0;
        if (skip) {
            if (i == 0 && row[0] == 1)
                base = 1;
            if (!paradt_io__natural(row[0], &index) || index != i + base)
                return paradt_io__bad(r, "the point's index is %.17g where %llu is due", row[0],
                                      (unsigned long long)(i + base));
        }
        if (r->weighted)
            row[skip + r->dim] = row[skip + available];
        if (!paradt_io__push(r, row + skip))
            return 0;
    }
    return 1;
}

static int paradt_io__read_node(paradt_io__reader *r) {
    double header[4] = {0, 0, 0, 0};
    uint64_t count, dim, attributes;
    int n;
    if (!paradt_io__next_content(r))
        return paradt_io__bad(r, "no header (points, dimension, attributes, markers)");
    if ((n = paradt_io__fields(r, header, 4)) < 0)
        return 0;
    if (n < 2 || !paradt_io__natural(header[0], &count) || !paradt_io__natural(header[1], &dim) ||
        !paradt_io__natural(header[2], &attributes))
        return paradt_io__bad(r, "the header is not: points, dimension, attributes, markers");
    if (dim < 2 || dim > PARADT_MAX_DIM)
        return paradt_io__bad(r, "dimension %.17g is not 2 to 8", header[1]);
    if (!paradt_io__settle_dim(r, (int)dim))
        return 0;
    if (r->weighted && !attributes)
        return paradt_io__bad(r, "the points have no attribute to be their weight");
    if (!paradt_io__read_announced(r, count, 1, (int)dim))
        return 0;
    if (paradt_io__next_content(r))
        return paradt_io__bad(r, "more than the announced points");
    return 1;
}

// The keyword [ST][C][N][4][n]OFF: sets the dimension, 0 when a line of its own tells it. A file may lack the keyword.
static int paradt_io__off_keyword(paradt_io__reader *r, uint64_t *dim) {
    const char *word = r->cur, *begin = word;
    size_t n;
    *dim = 3;
    if (isdigit((unsigned char)*word) && *word != '4')
        return 1;
    n = paradt_io__token(r, &word);
    if (n >= 3 && memcmp(word + n - 3, "OFF", 3) == 0) {
        static const char *const prefixes[] = {"ST", "C", "N", "4", "n"};
        const char *last = word + n - 3;
        size_t i;
        for (i = 0; i < sizeof prefixes / sizeof *prefixes; i++) {
            size_t length = strlen(prefixes[i]);
            if ((size_t)(last - word) < length || memcmp(word, prefixes[i], length) != 0)
                continue;
            if (*word == '4')
                return paradt_io__bad(r, "OFF files of homogeneous coordinates are not supported");
            if (*word == 'n')
                *dim = 0;
            word += length;
        }
        paradt_io__skip_blanks(r);
        if (word != last)
            return paradt_io__bad(r, "an unknown kind of OFF file");
        if (r->stop - r->cur >= 6 && memcmp(r->cur, "BINARY", 6) == 0)
            return paradt_io__bad(r, "binary OFF files are not supported");
        return 1;
    }
    r->cur = begin;
    return isdigit((unsigned char)*begin) ? 1 : paradt_io__bad(r, "not an OFF file: it does not begin with OFF");
}

// The next number of a header that may run over several lines
static int paradt_io__off_count(paradt_io__reader *r, uint64_t *number) {
    double value;
    paradt_io__skip_blanks(r);
    if (paradt_io__at_end_of_line(r) && !paradt_io__next_content(r))
        return paradt_io__bad(r, "the file ends within its header");
    if (!paradt_io__exactly(r, &value, 1))
        return 0;
    return paradt_io__natural(value, number) ? 1 : paradt_io__bad(r, "%.17g is not a count", value);
}

// Passes over the number of edges where it has a line of its own. No point has just one coordinate.
static void paradt_io__skip_off_edges(paradt_io__reader *r) {
    paradt_io__reader here;
    const char *number;
    paradt_io__skip_blanks(r);
    if (!paradt_io__at_end_of_line(r))
        return;
    here = *r;
    if (paradt_io__next_content(r)) {
        paradt_io__token(r, &number);
        paradt_io__skip_blanks(r);
        if (paradt_io__at_end_of_line(r))
            return;
    }
    *r = here;
}

static int paradt_io__read_off(paradt_io__reader *r) {
    uint64_t dim, points, faces;
    if (!paradt_io__next_content(r))
        return paradt_io__bad(r, "not an OFF file: it is empty");
    if (!paradt_io__off_keyword(r, &dim))
        return 0;
    if (!dim && !paradt_io__off_count(r, &dim))
        return 0;
    if (dim < 2 || dim > PARADT_MAX_DIM)
        return paradt_io__bad(r, "dimension %llu is not 2 to %d", (unsigned long long)dim, PARADT_MAX_DIM);
    if (!paradt_io__off_count(r, &points) || !paradt_io__off_count(r, &faces))
        return 0;
    paradt_io__skip_off_edges(r);
    if (!paradt_io__settle_dim(r, (int)dim))
        return 0;
    return paradt_io__read_announced(r, points, 0, (int)dim);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>binary numbers

static uint64_t paradt_io__bits(const char *bytes, int size, int big_endian) {
    uint64_t bits = 0;
    int i;
    for (i = 0; i < size; i++)
        bits |= (uint64_t)(unsigned char)bytes[i] << 8 * (big_endian ? size - 1 - i : i);
    return bits;
}

typedef enum paradt_io__kind { PARADT_IO__UNSIGNED, PARADT_IO__SIGNED, PARADT_IO__FLOAT } paradt_io__kind;

static double paradt_io__value(const char *bytes, paradt_io__kind kind, int size, int big_endian) {
    uint64_t bits = paradt_io__bits(bytes, size, big_endian);
    uint32_t narrow = (uint32_t)bits;
    float f;
    double d;
    if (kind == PARADT_IO__FLOAT && size == 8) {
        memcpy(&d, &bits, sizeof d);
        return d;
    }
    if (kind == PARADT_IO__FLOAT) {
        memcpy(&f, &narrow, sizeof f);
        return (double)f;
    }
    if (kind == PARADT_IO__SIGNED && bits >> (8 * size - 1)) // at most four bytes
        return (double)bits - (double)(UINT64_C(1) << 8 * size);
    return (double)bits;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>ply

enum { PARADT_IO__PLY_ELEMENTS = 64, PARADT_IO__PLY_PROPERTIES = 512 };
enum { PARADT_IO__PLY_ASCII = 1, PARADT_IO__PLY_LITTLE, PARADT_IO__PLY_BIG };
enum { PARADT_IO__PLY_IGNORED = -1, PARADT_IO__PLY_WEIGHT = 3 }; // roles besides the coordinates 0, 1, 2

typedef struct paradt_io__ply_type {
    const char *name;
    const char *alias;
    paradt_io__kind kind;
    int size;
} paradt_io__ply_type;

static const paradt_io__ply_type paradt_io__ply_types[] = {
    {"char", "int8", PARADT_IO__SIGNED, 1},    {"uchar", "uint8", PARADT_IO__UNSIGNED, 1},
    {"short", "int16", PARADT_IO__SIGNED, 2},  {"ushort", "uint16", PARADT_IO__UNSIGNED, 2},
    {"int", "int32", PARADT_IO__SIGNED, 4},    {"uint", "uint32", PARADT_IO__UNSIGNED, 4},
    {"float", "float32", PARADT_IO__FLOAT, 4}, {"double", "float64", PARADT_IO__FLOAT, 8},
};

typedef struct paradt_io__ply {
    int coding; // PARADT_IO__PLY_ASCII ...; 0: not told yet
    struct {
        uint64_t count;
        int first; // its properties
        int vertex;
    } elements[PARADT_IO__PLY_ELEMENTS + 1]; // one more that says where the properties end
    struct {
        const paradt_io__ply_type *list; // type of the count; NULL: a scalar
        const paradt_io__ply_type *type;
        const char *name;
        size_t length;
        int role;
    } properties[PARADT_IO__PLY_PROPERTIES];
    int element_count;
    int property_count;
} paradt_io__ply;

static int paradt_io__ply_type_of(paradt_io__reader *r, const paradt_io__ply_type **type) {
    const char *word;
    size_t n = paradt_io__token(r, &word), i;
    for (i = 0; i < sizeof paradt_io__ply_types / sizeof *paradt_io__ply_types; i++) {
        *type = &paradt_io__ply_types[i];
        if (paradt_io__is(word, n, (*type)->name) || paradt_io__is(word, n, (*type)->alias))
            return 1;
    }
    return paradt_io__bad(r, "'%.*s' is not a type of property", n < 32 ? (int)n : 32, word);
}

static int paradt_io__ply_format(paradt_io__reader *r, paradt_io__ply *ply) {
    static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const char *word;
    size_t n = paradt_io__token(r, &word), i;
    for (i = 0; i < 3; i++)
        if (paradt_io__is(word, n, names[i])) {
            ply->coding = PARADT_IO__PLY_ASCII + (int)i;
            return 1;
        }
    return paradt_io__bad(r, "an unknown format");
}

static int paradt_io__ply_element(paradt_io__reader *r, paradt_io__ply *ply) {
    const char *word;
    size_t n = paradt_io__token(r, &word);
    double count;
    int i = ply->element_count++;
    if (i == PARADT_IO__PLY_ELEMENTS)
        return paradt_io__bad(r, "more than %d elements", PARADT_IO__PLY_ELEMENTS);
    ply->elements[i].vertex = paradt_io__is(word, n, "vertex");
    ply->elements[i].first = ply->property_count;
    if (!paradt_io__exactly(r, &count, 1))
        return 0;
    if (!paradt_io__natural(count, &ply->elements[i].count))
        return paradt_io__bad(r, "%.17g is not a number of elements", count);
    return 1;
}

static int paradt_io__ply_property(paradt_io__reader *r, paradt_io__ply *ply) {
    const paradt_io__ply_type *list = NULL, *type;
    const char *word, *begin;
    int i = ply->property_count++;
    size_t n;
    if (!ply->element_count)
        return paradt_io__bad(r, "a property before the first element");
    if (i == PARADT_IO__PLY_PROPERTIES)
        return paradt_io__bad(r, "more than %d properties", PARADT_IO__PLY_PROPERTIES);
    paradt_io__skip_blanks(r);
    begin = r->cur;
    n = paradt_io__token(r, &word);
    if (!paradt_io__is(word, n, "list"))
        r->cur = begin;
    else if (!paradt_io__ply_type_of(r, &list))
        return 0;
    if (!paradt_io__ply_type_of(r, &type))
        return 0;
    if (list && list->kind == PARADT_IO__FLOAT)
        return paradt_io__bad(r, "the length of a list is not a whole number");
    ply->properties[i].list = list;
    ply->properties[i].type = type;
    ply->properties[i].length = paradt_io__token(r, &ply->properties[i].name);
    ply->properties[i].role = PARADT_IO__PLY_IGNORED;
    return 1;
}

static int paradt_io__ply_header(paradt_io__reader *r, paradt_io__ply *ply) {
    memset(ply, 0, sizeof *ply);
    if (!paradt_io__next_line(r) || !paradt_io__is(r->cur, (size_t)(r->stop - r->cur), "ply"))
        return paradt_io__bad(r, "not a PLY file: it does not begin with ply");
    while (paradt_io__next_line(r)) {
        const char *word;
        size_t n = paradt_io__token(r, &word);
        int good = 1;
        if (paradt_io__is(word, n, "format"))
            good = paradt_io__ply_format(r, ply);
        else if (paradt_io__is(word, n, "element"))
            good = paradt_io__ply_element(r, ply);
        else if (paradt_io__is(word, n, "property"))
            good = paradt_io__ply_property(r, ply);
        else if (paradt_io__is(word, n, "end_header")) {
            ply->elements[ply->element_count].first = ply->property_count;
            return ply->coding ? 1 : paradt_io__bad(r, "the header names no format");
        } else if (n && !paradt_io__is(word, n, "comment") && !paradt_io__is(word, n, "obj_info"))
            return paradt_io__bad(r, "'%.*s' is unknown in a header", n < 32 ? (int)n : 32, word);
        if (!good)
            return 0;
    }
    return paradt_io__bad(r, "the file ends within its header");
}

// Finds the property of the element with this name; returns the end of the element's properties when there is none.
static int paradt_io__ply_find(const paradt_io__ply *ply, int element, const char *name) {
    int i = ply->elements[element].first, end = ply->elements[element + 1].first;
    while (i < end &&
           (ply->properties[i].list || !paradt_io__is(ply->properties[i].name, ply->properties[i].length, name)))
        i++;
    return i;
}

// Says of each property of the vertices what it is.
static int paradt_io__ply_roles(paradt_io__reader *r, paradt_io__ply *ply, int element) {
    static const char *const axes[] = {"x", "y", "z"};
    int end = ply->elements[element + 1].first, last = 0, axis, weight;
    for (axis = 0; axis < 3; axis++) {
        int i = paradt_io__ply_find(ply, element, axes[axis]);
        if (i == end)
            break;
        ply->properties[i].role = axis;
        if (i > last)
            last = i;
    }
    if (axis < 2)
        return paradt_io__bad(r, "the vertices have no property %s", axes[axis]);
    if (!paradt_io__settle_dim(r, axis))
        return 0;
    if (!r->weighted)
        return 1;
    weight = paradt_io__ply_find(ply, element, "weight");
    if (weight == end)
        weight = paradt_io__ply_find(ply, element, "w");
    if (weight == end)
        weight = last + 1;
    if (weight >= end || ply->properties[weight].list)
        return paradt_io__bad(r, "the vertices have no weight");
    ply->properties[weight].role = PARADT_IO__PLY_WEIGHT;
    return 1;
}

static int paradt_io__ply_value(paradt_io__reader *r, const paradt_io__ply *ply, const paradt_io__ply_type *type,
                                double *value) {
    if (ply->coding == PARADT_IO__PLY_ASCII)
        return paradt_io__exactly(r, value, 1);
    if (r->end - r->next < type->size)
        return paradt_io__bad(r, "the file ends within its data");
    *value = paradt_io__value(r->next, type->kind, type->size, ply->coding == PARADT_IO__PLY_BIG);
    r->next += type->size;
    return 1;
}

// Reads one element's properties; those with a role go into row.
static int paradt_io__ply_row(paradt_io__reader *r, const paradt_io__ply *ply, int element, double *row) {
    int i;
    if (ply->coding == PARADT_IO__PLY_ASCII && !paradt_io__next_content(r))
        return paradt_io__bad(r, "the file ends before its last element");
    for (i = ply->elements[element].first; i < ply->elements[element + 1].first; i++) {
        double value;
        uint64_t length = 1;
        if (ply->properties[i].list) {
            if (!paradt_io__ply_value(r, ply, ply->properties[i].list, &value))
                return 0;
            if (!paradt_io__natural(value, &length))
                return paradt_io__bad(r, "%.17g is no length of a list", value);
        }
        for (; length; length--)
            if (!paradt_io__ply_value(r, ply, ply->properties[i].type, &value))
                return 0;
        if (ply->properties[i].role >= 0)
            row[ply->properties[i].role] = value;
    }
    return 1;
}

static int paradt_io__ply_elements(paradt_io__reader *r, const paradt_io__ply *ply, int element) {
    const int vertex = ply->elements[element].vertex;
    uint64_t i, count = ply->elements[element].count;
    double row[4] = {0, 0, 0, 0};
    if (ply->elements[element].first == ply->elements[element + 1].first)
        return 1; // nothing is stored of these
    for (i = 0; i < count; i++) {
        if (!paradt_io__ply_row(r, ply, element, row))
            return 0;
        if (!vertex)
            continue;
        row[r->dim] = row[r->weighted ? PARADT_IO__PLY_WEIGHT : r->dim];
        if (!paradt_io__push(r, row))
            return 0;
    }
    return 1;
}

static int paradt_io__read_ply(paradt_io__reader *r) {
    paradt_io__ply ply;
    int element, vertices = 0;
    if (!paradt_io__ply_header(r, &ply))
        return 0;
    for (element = 0; element < ply.element_count; element++) {
        if (!ply.elements[element].vertex)
            continue;
        if (vertices++)
            return paradt_io__bad(r, "two elements are called vertex");
        if (!paradt_io__ply_roles(r, &ply, element))
            return 0;
    }
    if (!vertices)
        return paradt_io__bad(r, "no element is called vertex");
    if (ply.coding != PARADT_IO__PLY_ASCII)
        r->line = 0;
    for (element = 0; element < ply.element_count; element++)
        if (!paradt_io__ply_elements(r, &ply, element))
            return 0;
    return 1;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>npy

typedef struct paradt_io__npy {
    int size; // bytes of a number
    int big_endian;
    int fortran; // a column after the other
    uint64_t points;
    uint64_t columns;
} paradt_io__npy;

// Where the value of a key of the header's dictionary begins; NULL: the key is missing.
static const char *paradt_io__npy_key(const char *at, const char *end, const char *key) {
    size_t n = strlen(key);
    for (; at + n + 2 < end; at++) {
        if ((*at != '\'' && *at != '"') || memcmp(at + 1, key, n) != 0 || at[n + 1] != *at)
            continue;
        for (at += n + 2; at < end && (*at == ' ' || *at == ':');)
            at++;
        return at;
    }
    return NULL;
}

static int paradt_io__npy_type(paradt_io__reader *r, paradt_io__npy *npy, const char *at) {
    if (!at || (*at != '\'' && *at != '"') || (at[1] != '<' && at[1] != '>') || at[2] != 'f' ||
        (at[3] != '4' && at[3] != '8') || at[4] != at[0])
        return paradt_io__bad(r, "the array's type is not float32 or float64");
    npy->big_endian = at[1] == '>';
    npy->size = at[3] - '0';
    return 1;
}

static int paradt_io__npy_shape(paradt_io__reader *r, paradt_io__npy *npy, const char *at) {
    uint64_t sides[3];
    int n = 0;
    for (at = at && *at == '(' ? at + 1 : ""; n < 3; n++) {
        size_t digits = paradt_gen__natural(at, &sides[n]);
        if (!digits)
            break;
        for (at += digits; *at == ' ' || *at == ',';)
            at++;
    }
    if (n != 2 || *at != ')')
        return paradt_io__bad(r, "the array is not two-dimensional: (points, columns)");
    npy->points = sides[0];
    npy->columns = sides[1];
    return 1;
}

static int paradt_io__npy_header(paradt_io__reader *r, paradt_io__npy *npy) {
    static const char magic[] = "\x93NUMPY";
    size_t left = (size_t)(r->end - r->next), length, start;
    const char *text, *end, *order;
    if (left < 12 || memcmp(r->next, magic, 6) != 0)
        return paradt_io__bad(r, "not an NPY file");
    if (r->next[6] < 1 || r->next[6] > 3)
        return paradt_io__bad(r, "an unknown version of the NPY format");
    start = r->next[6] == 1 ? 10 : 12;
    length = (size_t)paradt_io__bits(r->next + 8, (int)start - 8, 0);
    if (length > left - start)
        return paradt_io__bad(r, "the file ends within its header");
    text = r->next + start;
    end = text + length;
    order = paradt_io__npy_key(text, end, "fortran_order");
    if (!order)
        return paradt_io__bad(r, "the header is not one of an array");
    npy->fortran = *order == 'T';
    r->next = end;
    return paradt_io__npy_type(r, npy, paradt_io__npy_key(text, end, "descr")) &&
           paradt_io__npy_shape(r, npy, paradt_io__npy_key(text, end, "shape"));
}

static int paradt_io__read_npy(paradt_io__reader *r) {
    paradt_io__npy npy = {0, 0, 0, 0, 0};
    uint64_t i, k, left;
    double row[PARADT_MAX_DIM + 1];
    if (!paradt_io__npy_header(r, &npy))
        return 0;
    left = (uint64_t)(r->end - r->next) / (uint64_t)npy.size;
    if (npy.columns > INT32_MAX)
        return paradt_io__bad(r, "too many columns");
    if (!r->dim && !paradt_io__settle_dim(r, (int)npy.columns - r->weighted))
        return 0;
    if (npy.columns < (uint64_t)(r->dim + r->weighted))
        return paradt_io__bad(r, "%llu columns where %d are needed", (unsigned long long)npy.columns,
                              r->dim + r->weighted);
    if (npy.points > left / npy.columns)
        return paradt_io__bad(r, "the file ends within its data");
    for (i = 0; i < npy.points; i++) {
        for (k = 0; k < (uint64_t)(r->dim + r->weighted); k++) {
            uint64_t at = npy.fortran ? k * npy.points + i : i * npy.columns + k;
            row[k] = paradt_io__value(r->next + at * (uint64_t)npy.size, PARADT_IO__FLOAT, npy.size, npy.big_endian);
        }
        if (!paradt_io__push(r, row))
            return 0;
    }
    return 1;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>pdb: fixed columns, counted from 1

// Radii in angstrom: Bondi, "Van der Waals volumes and radii", J. Phys. Chem. 68, 1964. Elements that he does not list
// count 2.00, as is usual.
static double paradt_io__radius(const char *element) {
    static const struct {
        char symbol[3];
        double radius;
    } radii[] = {{"H", 1.20},  {"D", 1.20},  {"HE", 1.40}, {"LI", 1.82}, {"C", 1.70},  {"N", 1.55},  {"O", 1.52},
                 {"F", 1.47},  {"NE", 1.54}, {"NA", 2.27}, {"MG", 1.73}, {"SI", 2.10}, {"P", 1.80},  {"S", 1.80},
                 {"CL", 1.75}, {"AR", 1.88}, {"K", 2.75},  {"NI", 1.63}, {"CU", 1.40}, {"ZN", 1.39}, {"GA", 1.87},
                 {"AS", 1.85}, {"SE", 1.90}, {"BR", 1.85}, {"KR", 2.02}, {"PD", 1.63}, {"AG", 1.72}, {"CD", 1.58},
                 {"IN", 1.93}, {"SN", 2.17}, {"TE", 2.06}, {"I", 1.98},  {"XE", 2.16}, {"PT", 1.75}, {"AU", 1.66},
                 {"HG", 1.55}, {"TL", 1.96}, {"PB", 2.02}, {"U", 1.86}};
    size_t i;
    for (i = 0; i < sizeof radii / sizeof *radii; i++)
        if (strcmp(element, radii[i].symbol) == 0)
            return radii[i].radius;
    return 2.00;
}

static char paradt_io__pdb_char(const paradt_io__reader *r, int column) {
    return column <= r->stop - r->cur ? (char)toupper((unsigned char)r->cur[column - 1]) : ' ';
}

// The element's symbol: columns 77 and 78, or else what the atom's name says: there the symbol is right-justified in
// columns 13 and 14, but for hydrogens with names of four letters.
static void paradt_io__pdb_element(const paradt_io__reader *r, char *symbol) {
    int column = 77, n = 0;
    if (!isalpha((unsigned char)paradt_io__pdb_char(r, 78))) {
        column = 13;
        if (paradt_io__pdb_char(r, 13) == 'H' && paradt_io__pdb_char(r, 16) != ' ') {
            strcpy(symbol, "H");
            return;
        }
    }
    for (; n < 2; column++, n += symbol[n] != '\0') {
        char c = paradt_io__pdb_char(r, column);
        symbol[n] = (char)(isalpha((unsigned char)c) ? c : '\0');
        if (column == 78 || column == 14)
            break;
    }
    symbol[n + (n < 2 && symbol[n])] = '\0';
}

static int paradt_io__pdb_coordinate(paradt_io__reader *r, int column, double *value) {
    char text[9];
    paradt_io__reader field = *r;
    memcpy(text, r->cur + column - 1, 8);
    text[8] = '\0';
    field.cur = text;
    field.stop = text + 8;
    paradt_io__skip_blanks(&field);
    if (!paradt_io__number(&field, value))
        return paradt_io__bad(r, "'%.8s' is not a coordinate", text);
    paradt_io__skip_blanks(&field);
    return field.cur == field.stop ? 1 : paradt_io__bad(r, "'%.8s' is not a coordinate", text);
}

static int paradt_io__read_pdb(paradt_io__reader *r) {
    double row[4];
    char element[3];
    int k;
    if (!paradt_io__settle_dim(r, 3))
        return 0;
    while (paradt_io__next_line(r)) {
        size_t n = (size_t)(r->stop - r->cur);
        if (n >= 6 && memcmp(r->cur, "ENDMDL", 6) == 0)
            break;
        if (n < 6 || (memcmp(r->cur, "ATOM  ", 6) != 0 && memcmp(r->cur, "HETATM", 6) != 0))
            continue;
        if (n < 54)
            return paradt_io__bad(r, "the line ends before the coordinates do, in column 54");
        for (k = 0; k < r->dim; k++)
            if (!paradt_io__pdb_coordinate(r, 31 + 8 * k, &row[k]))
                return 0;
        paradt_io__pdb_element(r, element);
        row[r->dim] = paradt_io__radius(element) * paradt_io__radius(element);
        if (!paradt_io__push(r, row))
            return 0;
    }
    return 1;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>reading

// Extension, reader, coordinates when nothing is said, whether a title is allowed. The row of .txt also reads "-".
static const paradt_io__input paradt_io__formats[] = {
    {".txt", paradt_io__read_text, 0, 0},  {".csv", paradt_io__read_text, 0, 1}, {".xyz", paradt_io__read_text, 3, 0},
    {".node", paradt_io__read_node, 0, 0}, {".off", paradt_io__read_off, 0, 0},  {".ply", paradt_io__read_ply, 0, 0},
    {".npy", paradt_io__read_npy, 0, 0},   {".pdb", paradt_io__read_pdb, 0, 0},
};

const char *paradt_io_inputs(void) {
    return ".xyz .txt .csv .node .off .ply .npy .pdb";
}

// What follows the last dot of the file's own name; "" when nothing does.
static const char *paradt_io__extension(const char *name) {
    const char *slash = strrchr(name, '/'), *dot = strrchr(slash ? slash : name, '.');
    return dot ? dot : "";
}

static const paradt_io__input *paradt_io__format_of(const char *name) {
    const char *extension = strcmp(name, "-") == 0 ? ".txt" : paradt_io__extension(name);
    size_t i;
    for (i = 0; i < sizeof paradt_io__formats / sizeof *paradt_io__formats; i++)
        if (strcasecmp(extension, paradt_io__formats[i].extension) == 0)
            return &paradt_io__formats[i];
    return NULL;
}

// Reads all that the descriptor gives. Returns malloc'ed text with a NUL behind it, or NULL with errno set.
static char *paradt_io__slurp(int fd, size_t hint, size_t *size) {
    size_t capacity = hint + 2, used = 0;
    char *text = (char *)malloc(capacity);
    while (text) {
        ssize_t n = read(fd, text + used, capacity - 1 - used);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0) {
            text[used] = '\0';
            *size = used;
            if (n == 0)
                return text;
            free(text);
            return NULL;
        }
        used += (size_t)n;
        if (used + 1 == capacity) {
            char *larger = capacity < SIZE_MAX / 2 ? (char *)realloc(text, capacity * 2) : NULL;
            if (!larger)
                free(text);
            text = larger;
            capacity *= 2;
        }
    }
    errno = ENOMEM;
    return NULL;
}

// The file's bytes: malloc'ed, with a NUL behind them; NULL after an error.
static char *paradt_io__load(const char *name, size_t *size, paradt_io_error *error) {
    struct stat about;
    int fd = strcmp(name, "-") == 0 ? STDIN_FILENO : open(name, O_RDONLY), reason;
    char *text;
    if (fd < 0 || fstat(fd, &about) != 0) {
        paradt_io__error(error, PARADT_IO_BAD_INPUT, "%.900s: %s", name, strerror(errno));
        return NULL;
    }
    text = paradt_io__slurp(fd, S_ISREG(about.st_mode) && about.st_size > 0 ? (size_t)about.st_size : 1 << 16, size);
    reason = errno;
    if (fd != STDIN_FILENO)
        close(fd);
    if (!text && reason == ENOMEM)
        paradt_io__no_memory(error, name);
    else if (!text)
        paradt_io__error(error, PARADT_IO_BAD_INPUT, "%.900s: %s", name, strerror(reason));
    return text;
}

// Takes the weights out of the rows, which stay as coordinates alone.
static int paradt_io__split(paradt_io__reader *r, paradt_io_points *points) {
    size_t i, dim = (size_t)r->dim;
    double *shrunk;
    if (r->weighted) {
        points->weights = (double *)malloc((r->count ? r->count : 1) * sizeof *points->weights);
        if (!points->weights)
            return paradt_io__no_memory(r->error, r->name);
        for (i = 0; i < r->count; i++) {
            points->weights[i] = r->rows[i * (dim + 1) + dim];
            memmove(r->rows + i * dim, r->rows + i * (dim + 1), dim * sizeof *r->rows);
        }
    }
    shrunk = (double *)realloc(r->rows, (r->count ? r->count : 1) * dim * sizeof *r->rows);
    points->coordinates = shrunk ? shrunk : r->rows;
    points->count = r->count;
    points->dim = r->dim;
    r->rows = NULL;
    return points->coordinates ? 1 : paradt_io__no_memory(r->error, r->name);
}

static int paradt_io__read_file(paradt_io_points *points, const char *name, const paradt_io_want *want,
                                paradt_io_error *error) {
    paradt_io__reader r;
    size_t size = 0;
    char *text;
    int good;
    memset(&r, 0, sizeof r);
    r.name = strcmp(name, "-") == 0 ? "standard input" : name;
    r.format = paradt_io__format_of(name);
    r.dim = want->dim;
    r.weighted = want->weights != 0;
    r.error = error;
    if (!r.format)
        return paradt_io__bad(&r, "the name does not end in one of %s", paradt_io_inputs());
    text = paradt_io__load(name, &size, error);
    if (!text)
        return 0;
    r.next = text;
    r.end = text + size;
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        r.next += 3; // a byte order mark
    good = size ? r.format->read(&r) : paradt_io__bad(&r, "the file is empty");
    good = good && paradt_io__split(&r, points);
    free(r.rows);
    free(text);
    return good;
}

static int paradt_io__generate(paradt_io_points *points, const char *name, const paradt_io_want *want,
                               paradt_io_error *error) {
    paradt_gen_spec spec;
    const char *reason = paradt_gen_parse(&spec, name);
    size_t room;
    if (reason)
        return paradt_io__error(error, PARADT_IO_BAD_NAME, "%.700s: %s", name, reason);
    points->dim = want->dim ? want->dim : 3;
    points->count = spec.count;
    room = spec.count ? spec.count : 1;
    points->coordinates = (double *)malloc(room * (size_t)points->dim * sizeof(double));
    if (want->weights)
        points->weights = (double *)malloc(room * sizeof(double));
    if (!points->coordinates || (want->weights && !points->weights))
        return paradt_io__no_memory(error, name);
    paradt_gen_points(&spec, points->dim, 0, spec.count, points->coordinates);
    if (want->weights)
        paradt_gen_weights(&spec, points->dim, 0, spec.count, points->weights);
    return 1;
}

int paradt_io_read(paradt_io_points *points, const char *input, const paradt_io_want *want, paradt_io_error *error) {
    static const paradt_io_want nothing = {0, 0};
    int generated = strncmp(input, "gen:", 4) == 0, good;
    memset(points, 0, sizeof *points);
    if (!want)
        want = &nothing;
    good =
        generated ? paradt_io__generate(points, input, want, error) : paradt_io__read_file(points, input, want, error);
    if (!good)
        paradt_io_free(points);
    return good;
}

void paradt_io_free(paradt_io_points *points) {
    free(points->coordinates);
    free(points->weights);
    memset(points, 0, sizeof *points);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>stage: outputs under temporary names

// Keeps the signals that end the program away, so that a handler that aborts the stage finds it whole.
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

// The file that a name leads to, through symbolic links; malloc'ed
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

// Creates a file beside what `name` leads to, with a name of its own and the permissions that a new file gets.
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
    temporary[n - 1] = '.'; // then six letters that mkstemp replaces
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

// Gives what stands where a file is to be another name, where that can be.
static void paradt_io__keep_former(paradt_io_staged *file) {
    size_t room = strlen(file->temporary) + 2;
    file->former = (char *)malloc(room);
    if (!file->former)
        return;
    snprintf(file->former, room, "%s~", file->temporary);
    if (link(file->name, file->former) != 0) {
        free(file->former);
        file->former = NULL;
    }
}

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
    else { // i - 1 is the one that could not be renamed; those before it have their names already
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
    paradt_io_stage_abort(paradt_io__guarded);
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
    signal(SIGXFSZ, SIG_IGN); // too large a file is an error of write
}

void paradt_io_stage_free(paradt_io_stage *stage) {
    size_t count = (size_t)stage->count, i;
    stage->count = 0; // a signal handler looks no further
    for (i = 0; i < count; i++) {
        free(stage->files[i].name);
        free(stage->files[i].temporary);
    }
    free(stage->files);
    stage->files = NULL;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>out: a file being written; the first failure stays until paradt_io__close reports it

typedef struct paradt_io__out {
    const char *name;
    int fd;
    int reason; // errno of the first failure
    size_t used;
    unsigned char bytes[1 << 16];
} paradt_io__out;

static int paradt_io__open(paradt_io__out *out, paradt_io_stage *stage, const char *name, paradt_io_error *error) {
    out->name = name;
    out->reason = 0;
    out->used = 0;
    out->fd = paradt_io__create(stage, name, error);
    return out->fd >= 0;
}

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

// The integer in decimal, with a character before it.
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

// A number that reads back as the same double, with a blank before it; -0 is 0. Compared by bits: where subnormal
// numbers are flushed to zero, they still are not zero here.
static void paradt_io__put_real(paradt_io__out *out, double value) {
    int64_t whole = value > -1e15 && value < 1e15 ? (int64_t)value : 0;
    double back = (double)whole, negative_zero = -0.0;
    if (memcmp(&back, &value, sizeof value) == 0 || memcmp(&negative_zero, &value, sizeof value) == 0)
        paradt_io__put_int(out, ' ', whole);
    else
        paradt_io__putf(out, " %.17g", value);
}

// An integer of 1 to 8 bytes, little-endian
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
// >>writers: one a format; each gets the stage and the name of its first file

typedef struct paradt_io__scene {
    paradt_io_stage *stage;
    const char *name;
    const paradt_io_points *points;
    const paradt_triangulation *t;
    paradt_io_error *error;
    paradt_io__out out;
} paradt_io__scene;

// Coordinate k of a point; zero beyond its dimension
static double paradt_io__coordinate(const paradt_io__scene *scene, size_t point, int k) {
    return k < scene->points->dim ? scene->points->coordinates[point * (size_t)scene->points->dim + (size_t)k] : 0.0;
}

// name with its extension replaced; malloc'ed
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

static void paradt_io__put_node(paradt_io__scene *scene) {
    const paradt_io_points *points = scene->points;
    size_t i;
    int k;
    paradt_io__putf(&scene->out, "%zu %d %d 0\n", points->count, points->dim, points->weights != NULL);
    for (i = 0; i < points->count; i++) {
        paradt_io__put_int(&scene->out, ' ', (int64_t)i);
        for (k = 0; k < points->dim; k++)
            paradt_io__put_real(&scene->out, paradt_io__coordinate(scene, i, k));
        if (points->weights)
            paradt_io__put_real(&scene->out, points->weights[i]);
        paradt_io__put(&scene->out, "\n", 1);
    }
}

// Rows of indices, each begun by its own number
static void paradt_io__put_table(paradt_io__scene *scene, const paradt_index *rows) {
    size_t i, columns = (size_t)(scene->t->dim + 1), k;
    for (i = 0; i < scene->t->cell_count; i++) {
        paradt_io__put_int(&scene->out, ' ', (int64_t)i);
        for (k = 0; k < columns; k++)
            paradt_io__put_int(&scene->out, ' ', (int64_t)rows[i * columns + k]);
        paradt_io__put(&scene->out, "\n", 1);
    }
}

static void paradt_io__put_ele(paradt_io__scene *scene) {
    paradt_io__putf(&scene->out, "%zu %d 0\n", scene->t->cell_count, scene->t->dim + 1);
    paradt_io__put_table(scene, scene->t->cells);
}

static void paradt_io__put_neigh(paradt_io__scene *scene) {
    size_t rows = scene->t->neighbors ? scene->t->cell_count : 0; // a single point has none
    paradt_io__putf(&scene->out, "%zu %d\n", rows, scene->t->dim + 1);
    if (rows)
        paradt_io__put_table(scene, scene->t->neighbors);
}

static int paradt_io__write_ele(paradt_io__scene *scene) {
    static const struct {
        const char *extension;
        void (*put)(paradt_io__scene *scene);
    } files[] = {{".node", paradt_io__put_node}, {".ele", paradt_io__put_ele}, {".neigh", paradt_io__put_neigh}};
    size_t i;
    for (i = 0; i < sizeof files / sizeof *files; i++) {
        char *name = paradt_io__beside(scene->name, files[i].extension, scene->error);
        int good = name && paradt_io__open(&scene->out, scene->stage, name, scene->error);
        if (good) {
            files[i].put(scene);
            good = paradt_io__close(&scene->out, scene->error);
        }
        free(name);
        if (!good)
            return 0;
    }
    return 1;
}

static void paradt_io__put_array(paradt_io__out *out, const char *type, const char *name, int components,
                                 uint64_t *offset, uint64_t bytes) {
    paradt_io__putf(out,
                    "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" "
                    "offset=\"%llu\"/>\n",
                    type, name, components, (unsigned long long)*offset);
    *offset += 8 + bytes; // each block is begun by its size
}

// VTK's XML format with its arrays appended as raw bytes. Sizes: of points, weights, vertices, ends of cells, types
static void paradt_io__put_vtu_header(paradt_io__scene *scene, const uint64_t *sizes) {
    paradt_io__out *out = &scene->out;
    uint64_t offset = 0;
    paradt_io__putf(out,
                    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                    "<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n<Points>\n",
                    scene->points->count, scene->t->cell_count);
    paradt_io__put_array(out, "Float64", "Points", 3, &offset, sizes[0]);
    paradt_io__put_text(out, "</Points>\n<PointData>\n");
    if (scene->points->weights)
        paradt_io__put_array(out, "Float64", "weight", 1, &offset, sizes[1]);
    paradt_io__put_text(out, "</PointData>\n<Cells>\n");
    paradt_io__put_array(out, sizeof(paradt_index) == 8 ? "Int64" : "Int32", "connectivity", 1, &offset, sizes[2]);
    paradt_io__put_array(out, "Int64", "offsets", 1, &offset, sizes[3]);
    paradt_io__put_array(out, "UInt8", "types", 1, &offset, sizes[4]);
    paradt_io__put_text(out, "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
}

static void paradt_io__put_vtu(paradt_io__scene *scene) {
    static const unsigned char types[] = {1, 3, 5, 10}; // vertex, line, triangle, tetrahedron
    paradt_io__out *out = &scene->out;
    size_t points = scene->points->count, cells = scene->t->cell_count, i;
    size_t corners = (size_t)(scene->t->dim + 1);
    uint64_t sizes[5] = {24 * points, 8 * points, cells * corners * sizeof(paradt_index), 8 * cells, cells};
    paradt_io__put_vtu_header(scene, sizes);
    paradt_io__put_bits(out, sizes[0], 8);
    for (i = 0; i < 3 * points; i++)
        paradt_io__put_double(out, paradt_io__coordinate(scene, i / 3, (int)(i % 3)));
    if (scene->points->weights) {
        paradt_io__put_bits(out, sizes[1], 8);
        for (i = 0; i < points; i++)
            paradt_io__put_double(out, scene->points->weights[i]);
    }
    paradt_io__put_bits(out, sizes[2], 8);
    for (i = 0; i < cells * corners; i++)
        paradt_io__put_bits(out, (uint64_t)scene->t->cells[i], (int)sizeof(paradt_index));
    paradt_io__put_bits(out, sizes[3], 8);
    for (i = 1; i <= cells; i++)
        paradt_io__put_bits(out, i * corners, 8);
    paradt_io__put_bits(out, sizes[4], 8);
    for (i = 0; i < cells; i++)
        paradt_io__put_bits(out, types[corners - 1], 1);
    paradt_io__put_text(out, "\n</AppendedData>\n</VTKFile>\n");
}

static void paradt_io__put_npy(paradt_io__scene *scene) {
    char header[118];
    int n = snprintf(header, sizeof header, "{'descr': '<i%d', 'fortran_order': False, 'shape': (%zu, %d), }",
                     (int)sizeof(paradt_index), scene->t->cell_count, scene->t->dim + 1);
    size_t i;
    memset(header + n, ' ', sizeof header - (size_t)n);
    header[sizeof header - 1] = '\n';
    paradt_io__put(&scene->out, "\x93NUMPY\1\0\x76\0", 10); // 10 + 118 is a multiple of 64, as the format asks for
    paradt_io__put(&scene->out, header, sizeof header);
    for (i = 0; i < scene->t->cell_count * (size_t)(scene->t->dim + 1); i++)
        paradt_io__put_bits(&scene->out, (uint64_t)scene->t->cells[i], (int)sizeof(paradt_index));
}

// What bounds the result when it is 3-dimensional or more: the facets of the hull, turned outward; else the cells.
typedef struct paradt_io__surface {
    const paradt_index *faces; // [count][corners]
    size_t count;              //
    size_t corners;            //
    paradt_index *own;         // what is to be freed
} paradt_io__surface;

// The facet opposite a cell's vertex. Taken in the cell's order it looks inward when an even number of swaps moves the
// vertex to the end.
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

static int paradt_io__surface_of(paradt_io__scene *scene, paradt_io__surface *surface) {
    const paradt_triangulation *t = scene->t;
    size_t corners = (size_t)(t->dim + 1), i, n = 0, total = t->cell_count * corners;
    surface->faces = t->cells;
    surface->count = t->cell_count;
    surface->corners = corners;
    surface->own = NULL;
    if (t->dim < 3)
        return 1;
    for (i = 0; i < total; i++)
        n += t->neighbors[i] < 0;
    surface->own = (paradt_index *)malloc((n + 1) * (corners - 1) * sizeof *surface->own);
    if (!surface->own)
        return paradt_io__no_memory(scene->error, scene->name);
    surface->faces = surface->own;
    surface->count = n;
    surface->corners = corners - 1;
    for (n = i = 0; i < total; i++)
        if (t->neighbors[i] < 0)
            paradt_io__facet(t->cells + i / corners * corners, corners, i % corners,
                             surface->own + n++ * surface->corners);
    return 1;
}

static void paradt_io__put_point(paradt_io__scene *scene, size_t point) {
    int k, dim = scene->points->dim > 3 ? scene->points->dim : 3;
    for (k = 0; k < dim; k++)
        paradt_io__put_real(&scene->out, paradt_io__coordinate(scene, point, k));
    paradt_io__put(&scene->out, "\n", 1);
}

static void paradt_io__put_off(paradt_io__scene *scene, const paradt_io__surface *surface) {
    size_t i, k;
    if (scene->points->dim > 3)
        paradt_io__putf(&scene->out, "nOFF\n%d\n", scene->points->dim);
    else
        paradt_io__put_text(&scene->out, "OFF\n");
    paradt_io__putf(&scene->out, "%zu %zu 0\n", scene->points->count, surface->count);
    for (i = 0; i < scene->points->count; i++)
        paradt_io__put_point(scene, i);
    for (i = 0; i < surface->count; i++) {
        paradt_io__putf(&scene->out, "%zu", surface->corners);
        for (k = 0; k < surface->corners; k++)
            paradt_io__put_int(&scene->out, ' ', (int64_t)surface->faces[i * surface->corners + k]);
        paradt_io__put(&scene->out, "\n", 1);
    }
}

// Numbers the points of the surface from `first` in the order of their indices; -1 for the others. used: how many;
// malloc'ed
static int64_t *paradt_io__renumber(paradt_io__scene *scene, const paradt_io__surface *surface, int64_t first,
                                    int64_t *used) {
    size_t i, count = scene->points->count;
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

static void paradt_io__put_ply(paradt_io__scene *scene, const paradt_io__surface *surface, const int64_t *numbers,
                               int64_t used) {
    paradt_io__out *out = &scene->out;
    int edges = surface->corners < 3;
    size_t i, k;
    paradt_io__putf(out,
                    "ply\nformat binary_little_endian 1.0\nelement vertex %lld\nproperty double x\nproperty double y\n"
                    "property double z\nelement %s %zu\n%s\nend_header\n",
                    (long long)used, edges ? "edge" : "face", surface->corners > 1 ? surface->count : 0,
                    edges ? "property int vertex1\nproperty int vertex2" : "property list uchar int vertex_indices");
    for (i = 0; i < scene->points->count; i++)
        for (k = 0; k < 3 && numbers[i] >= 0; k++)
            paradt_io__put_double(out, paradt_io__coordinate(scene, i, (int)k));
    for (i = 0; surface->corners > 1 && i < surface->count; i++) {
        if (!edges)
            paradt_io__put_bits(out, surface->corners, 1);
        for (k = 0; k < surface->corners; k++)
            paradt_io__put_bits(out, (uint64_t)numbers[surface->faces[i * surface->corners + k]], 4);
    }
}

static void paradt_io__put_obj(paradt_io__scene *scene, const paradt_io__surface *surface, const int64_t *numbers,
                               int64_t used) {
    static const char *const words[] = {"p", "l", "f"};
    size_t i, k;
    (void)used;
    for (i = 0; i < scene->points->count; i++)
        if (numbers[i] >= 0) {
            paradt_io__put_text(&scene->out, "v");
            paradt_io__put_point(scene, i);
        }
    for (i = 0; i < surface->count; i++) {
        paradt_io__put_text(&scene->out, words[surface->corners - 1]);
        for (k = 0; k < surface->corners; k++)
            paradt_io__put_int(&scene->out, ' ', numbers[surface->faces[i * surface->corners + k]]);
        paradt_io__put(&scene->out, "\n", 1);
    }
}

static int paradt_io__write_off(paradt_io__scene *scene) {
    paradt_io__surface surface;
    int good = paradt_io__surface_of(scene, &surface);
    good = good && paradt_io__open(&scene->out, scene->stage, scene->name, scene->error);
    if (good) {
        paradt_io__put_off(scene, &surface);
        good = paradt_io__close(&scene->out, scene->error);
    }
    free(surface.own);
    return good;
}

static int paradt_io__write_mesh(paradt_io__scene *scene, int64_t first,
                                 void (*put)(paradt_io__scene *scene, const paradt_io__surface *surface,
                                             const int64_t *numbers, int64_t used)) {
    paradt_io__surface surface;
    int64_t *numbers = NULL, used = 0;
    int good = paradt_io__surface_of(scene, &surface);
    if (good && !(numbers = paradt_io__renumber(scene, &surface, first, &used)))
        good = paradt_io__no_memory(scene->error, scene->name);
    good = good && paradt_io__open(&scene->out, scene->stage, scene->name, scene->error);
    if (good) {
        put(scene, &surface, numbers, used);
        good = paradt_io__close(&scene->out, scene->error);
    }
    free(surface.own);
    free(numbers);
    return good;
}

static int paradt_io__write_ply(paradt_io__scene *scene) {
    return paradt_io__write_mesh(scene, 0, paradt_io__put_ply);
}

static int paradt_io__write_obj(paradt_io__scene *scene) {
    return paradt_io__write_mesh(scene, 1, paradt_io__put_obj);
}

static int paradt_io__write_plain(paradt_io__scene *scene, void (*put)(paradt_io__scene *scene)) {
    if (!paradt_io__open(&scene->out, scene->stage, scene->name, scene->error))
        return 0;
    put(scene);
    return paradt_io__close(&scene->out, scene->error);
}

static int paradt_io__write_vtu(paradt_io__scene *scene) {
    return paradt_io__write_plain(scene, paradt_io__put_vtu);
}

static int paradt_io__write_npy(paradt_io__scene *scene) {
    return paradt_io__write_plain(scene, paradt_io__put_npy);
}

static int paradt_io__write_bytes(paradt_io__scene *scene, const void *bytes, size_t size) {
    if (!paradt_io__open(&scene->out, scene->stage, scene->name, scene->error))
        return 0;
    paradt_io__put(&scene->out, bytes, size);
    return paradt_io__close(&scene->out, scene->error);
}

static int paradt_io__write_picture(paradt_io__scene *scene,
                                    int (*draw)(paradt_picture *picture, const double *coordinates, int dim,
                                                const paradt_triangulation *t)) {
    paradt_picture picture;
    int good = draw(&picture, scene->points->coordinates, scene->points->dim, scene->t);
    good = good ? paradt_io__write_bytes(scene, picture.bytes, picture.size)
                : paradt_io__no_memory(scene->error, scene->name);
    free(picture.bytes);
    return good;
}

static int paradt_io__write_svg(paradt_io__scene *scene) {
    return paradt_io__write_picture(scene, paradt_picture_svg);
}

static int paradt_io__write_png(paradt_io__scene *scene) {
    return paradt_io__write_picture(scene, paradt_picture_png);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>writing

static const struct paradt_io__output {
    const char *extension;
    int (*write)(paradt_io__scene *scene);
    int max_dim;
} paradt_io__outputs[] = {
    {".ele", paradt_io__write_ele, PARADT_MAX_DIM},
    {".vtu", paradt_io__write_vtu, 3},
    {".off", paradt_io__write_off, PARADT_MAX_DIM},
    {".ply", paradt_io__write_ply, 3},
    {".obj", paradt_io__write_obj, 3},
    {".npy", paradt_io__write_npy, PARADT_MAX_DIM},
    {".svg", paradt_io__write_svg, 3},
    {".png", paradt_io__write_png, 3},
};

const char *paradt_io_outputs(void) {
    return ".ele .vtu .off .ply .obj .npy .svg .png";
}

static const struct paradt_io__output *paradt_io__output_of(const char *name) {
    size_t i;
    for (i = 0; i < sizeof paradt_io__outputs / sizeof *paradt_io__outputs; i++)
        if (strcasecmp(paradt_io__extension(name), paradt_io__outputs[i].extension) == 0)
            return &paradt_io__outputs[i];
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
        good = paradt_io__error(error, PARADT_IO_FAILED, "%.900s: %s", name, strerror(errno));
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

int paradt_io_check_output(const char *name, int dim, const char *input, paradt_io_error *error) {
    static const char *const companions[] = {".node", ".neigh"};
    const struct paradt_io__output *output = paradt_io__output_of(name);
    size_t i;
    if (!output)
        return paradt_io__error(error, PARADT_IO_BAD_NAME, "%.700s: the name does not end in one of %s", name,
                                paradt_io_outputs());
    if (dim > output->max_dim)
        return paradt_io__error(error, PARADT_IO_BAD_NAME, "%.700s: %s files hold at most %d dimensions, not %d", name,
                                output->extension, output->max_dim, dim);
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

static paradt_io__scene *paradt_io__scene_of(paradt_io_stage *stage, const char *name, paradt_io_error *error) {
    paradt_io__scene *scene = (paradt_io__scene *)malloc(sizeof *scene);
    if (!scene) {
        paradt_io__no_memory(error, name);
        return NULL;
    }
    scene->stage = stage;
    scene->name = name;
    scene->error = error;
    return scene;
}

int paradt_io_write(paradt_io_stage *stage, const char *name, const paradt_io_points *points,
                    const paradt_triangulation *triangulation, paradt_io_error *error) {
    paradt_io__scene *scene;
    int good;
    if (!paradt_io_check_output(name, points->dim, NULL, error))
        return 0;
    scene = paradt_io__scene_of(stage, name, error);
    if (!scene)
        return 0;
    scene->points = points;
    scene->t = triangulation;
    good = paradt_io__output_of(name)->write(scene);
    free(scene);
    return good;
}

int paradt_io_write_text(paradt_io_stage *stage, const char *name, const char *text, paradt_io_error *error) {
    paradt_io__scene *scene = paradt_io__scene_of(stage, name, error);
    int good = scene && paradt_io__write_bytes(scene, text, strlen(text));
    free(scene);
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
