// What the fuzz harnesses share: bytes to numbers and points, an allocator that fails, small checks, and a main for replays.
//
// A harness defines LLVMFuzzerTestOneInput, which AFL++ (in persistent mode), libFuzzer and the main below take. By hand, for
// one of them (`make fuzz` does it for all):
//
//     AFL_USE_ASAN=1 AFL_USE_UBSAN=1 afl-clang-fast -g -O1 -fsanitize=fuzzer -I. -o build/fuzz_afl fuzz/fuzz_hull.c -lm
//     afl-fuzz -i fuzz/corpus/hull -o build/afl -- build/fuzz_afl
//
//     clang -g -O1 -fsanitize=fuzzer,address,undefined -I. -o build/fuzz fuzz/fuzz_hull.c -lm
//     mkdir -p build/found && build/fuzz build/found fuzz/corpus/hull
//
//     cc -g -DPARADT_FUZZ_STANDALONE -I. -o build/replay fuzz/fuzz_hull.c -lm && build/replay fuzz/corpus/hull/*
//     build/replay --random 0 100000
#ifndef PARADT_FUZZ_H
#define PARADT_FUZZ_H

#ifndef _XOPEN_SOURCE
#define _XOPEN_SOURCE 700 // the readers of the tool want it before any system header
#endif
#ifndef PARADT_FUZZ_LINKED // defined if another object has the implementation
#define PARADT_IMPLEMENTATION
#endif
#include "paradt.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// A replay does with an input all that a harness can do. A fuzzer, for which many inputs are worth more, does a part, which the
// input chooses: so what it finds shows in a replay.
#ifdef PARADT_FUZZ_STANDALONE
enum { ASKS_ALL = 1 };
#else
enum { ASKS_ALL = 0 };
#endif

// Prints an error and aborts, which fuzzers notice.
static inline void fail(const char *what, const char *detail) {
    fprintf(stderr, "%s: %s\n", what, detail);
    abort();
}

// The status has to be PARADT_OK.
static inline void expect_ok(paradt_status status, const char *what) {
    if (status)
        fail(what, paradt_status_string(status));
}

// --- bytes to numbers

typedef struct source {
    const uint8_t *data;
    size_t left;
} source;

// Returns the next byte; 0 at the end.
static inline int next_byte(source *b) {
    if (!b->left)
        return 0;
    b->left--;
    return *b->data++;
}

static inline int next_signed(source *b) {
    int byte = next_byte(b);
    return byte < 128 ? byte : byte - 256;
}

static inline double from_bits(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline uint64_t to_bits(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline int is_finite(double x) {
    return (to_bits(x) >> 52 & 2047) != 2047;
}

// Returns m * 2^e, |m| < 2^8. Stops multiplying beyond 2^1000, and dividing below 2^-1000.
static inline double scaled(int m, int e) {
    double x = m;
    for (; e > 0 && x < 0x1p1000 && x > -0x1p1000; e--)
        x *= 2;
    for (; e < 0 && (x > 0x1p-1000 || x < -0x1p-1000); e++)
        x *= 0.5;
    return x;
}

enum { LATTICE, ULPS, SCALED, RAW };

// Decodes a number. keep: 1: it may be a NaN or infinity
// LATTICE: a signed byte, reduced modulo the parameter's bits 0-4 plus 1 (if these bits are 0, not reduced), times a
//          power of two that bits 5-7 choose
// ULPS:    a signed byte n: the nth representable number after a base that the parameter chooses
// SCALED:  two signed bytes m, e: m * 2^(8 e)
// RAW:     the eight bytes of the double, least significant first
static inline double next_number(source *b, int encoding, int parameter, int keep) {
    static const double bases[] = {
        1.0,   0.0, 0x1p-1022, 0x1p-1060, 0x1.fffffffffffp1023, 0x1p300, 0x1p-300, 0x1.8p52, 0x1.999999999999ap-4,
        1024.0};
    static const int shifts[8] = {0, 20, -20, 40, -60, 500, -500, 900};
    uint64_t bits = 0;
    int i, value;
    if (encoding == LATTICE) {
        value = next_signed(b);
        return scaled(parameter & 31 ? value % ((parameter & 31) + 1) : value, shifts[parameter >> 5]);
    }
    if (encoding == ULPS) {
        value = next_signed(b);
        bits = to_bits(bases[(unsigned)parameter % (sizeof bases / sizeof *bases)]);
        if (value < 0 && (uint64_t)-value > bits)
            return -from_bits((uint64_t)-value - bits);
        return from_bits(bits + (uint64_t)(int64_t)value);
    }
    if (encoding == SCALED) {
        value = next_signed(b);
        return scaled(value, 8 * next_signed(b));
    }
    for (i = 0; i < 8; i++)
        bits |= (uint64_t)next_byte(b) << (8 * i);
    if (!keep && !is_finite(from_bits(bits)))
        bits &= ~((uint64_t)1 << 62);
    return from_bits(bits);
}

// --- bytes to points

enum { MAX_POINTS = 64, MAX_DIM = 5, MAX_REGIONS = 9 };

typedef struct decoded {
    double x[MAX_POINTS * MAX_DIM], w[MAX_POINTS];
    paradt_points points;
    size_t regions;
    paradt_partition partition;
    int choice;    // from byte 1 of the header
    int far_apart; // 1: numbers may be of very different sizes
    int spoil;     // byte 3 of the header
    int first_bad; // index of the first point that is not finite, or -1
} decoded;

// Returns how many points an input may have, so that most take much less than a millisecond. Two thirds of the choices stay
// small. In some encodings predicates need thousands of bits, the more the higher the dimension.
static inline int room(const int *most_points, int dim, int choice, int far_apart) {
    int most = choice == 0 || choice > 20 ? most_points[dim] : most_points[dim] / 2; // all, of seeds without a choice
    int bound = most_points[dim] / 3 > dim + 2 ? most_points[dim] / 3 : dim + 2;
    return far_apart && most > bound ? bound : most;
}

// Decodes the points of an input. Its first five bytes are a header:
//     0  bits 0-1: dimension - 2; bits 2-3: encoding; bit 4: the points have weights; bit 5: every third point is a
//        copy; bit 6: numbers that are not finite are kept; bit 7: uniform partition
//     1  regions - 1, modulo 9; and divided by 9, which is 0-28, for the harness: in->choice
//     2  parameter of the encoding
//     3  for the harness: in->spoil
//     4  0, or the points are flat: bit 0: 1: an axis equals the next one, 0: it is constant; bits 1-7: this axis
// The points follow, until the input or the room ends: the coordinates of each and, if there are weights, its weight.
//   most_points  [MAX_DIM + 1] by dimension: fewer in higher ones, where a point costs more; see room.
static inline void decode(decoded *in, source *b, const int *most_points) {
    int flags = next_byte(b), regions = next_byte(b), parameter = next_byte(b), dim = 2 + (flags & 3), count = 0, i;
    int encoding = flags >> 2 & 3, weighted = flags >> 4 & 1, copies = flags >> 5 & 1, keep = flags >> 6 & 1;
    int flat, axis, most;
    in->spoil = next_byte(b);
    flat = next_byte(b);
    axis = (flat >> 1) % dim;
    in->first_bad = -1;
    in->choice = regions / MAX_REGIONS;
    in->far_apart = encoding >= SCALED || (weighted && parameter >> 5);
    most = room(most_points, dim, in->choice, in->far_apart);
    for (; b->left && count < most; count++) {
        double *x = in->x + count * dim;
        int from = copies && count % 3 == 2 ? next_byte(b) % count : -1, bad;
        for (i = 0; i < dim; i++)
            x[i] = from >= 0 ? in->x[from * dim + i] : next_number(b, encoding, parameter, keep);
        if (flat)
            x[axis] = flat & 1 ? x[(axis + 1) % dim] : 3;
        in->w[count] = weighted ? next_number(b, encoding, 0, keep) : 0;
        for (i = 0, bad = !is_finite(in->w[count]); i < dim; i++)
            bad |= !is_finite(x[i]);
        if (bad && in->first_bad < 0)
            in->first_bad = count;
    }
    memset(&in->points, 0, sizeof in->points);
    in->points.data = in->x;
    in->points.count = (size_t)count;
    in->points.dim = dim;
    in->points.weights = weighted ? in->w : NULL;
    in->regions = (size_t)(regions % MAX_REGIONS + 1);
    in->partition = flags >> 7 ? PARADT_UNIFORM : PARADT_BISECTION;
}

// Is a part of what can be done with an input to be done: number `part` of so many?
static inline int asks(const decoded *in, int part, int parts) {
    return ASKS_ALL || in->choice % parts == part;
}

static inline int is_same_place(const double *a, const double *b, size_t dim) {
    size_t i;
    for (i = 0; i < dim && a[i] == b[i]; i++) // 0.0 and -0.0 are one
        ;
    return i == dim;
}

// --- an allocator that fails

typedef struct account {
    int held;    // blocks that were allocated and not freed
    int calls;   // allocations so far
    int fail_at; // number of the allocation that fails; -1: none
} account;

static inline void *failing_alloc(void *user, size_t size) {
    account *b = (account *)user;
    if (b->calls++ == b->fail_at)
        return NULL;
    b->held++;
    return malloc(size);
}

static inline void failing_free(void *user, void *memory) {
    ((account *)user)->held--;
    free(memory);
}

// Returns default options with an allocator that counts in *b, none of whose calls fails yet.
static inline paradt_options counted_options(account *b) {
    paradt_options options;
    memset(&options, 0, sizeof options);
    b->held = b->calls = 0;
    b->fail_at = -1;
    options.allocator.alloc = failing_alloc;
    options.allocator.free = failing_free;
    options.allocator.user = b;
    return options;
}

// Did an allocation fail?
static inline int has_failed(const account *b) {
    return b->fail_at >= 0 && b->calls > b->fail_at;
}

// --- replay

#ifdef PARADT_FUZZ_STANDALONE
#include <signal.h>

// The number of the random bytes that are run, for a report
static unsigned long long running_number;

static void report(int number) {
    fprintf(stderr, "in random bytes %llu\n", running_number);
    signal(number, SIG_DFL);
    raise(number);
}

static uint64_t next_random(uint64_t *state) { // Steele, Lea and Flood, OOPSLA 2014
    uint64_t x = *state += 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

// Fills random bytes, mostly few, all of which follow from a number. Half of them are small numbers. Returns how many there are.
static size_t random_bytes(uint8_t *data, uint64_t number) {
    uint64_t state = number << 16;
    size_t size = 5 + next_random(&state) % (next_random(&state) % 4 ? 90 : 400), i;
    int small = (int)(next_random(&state) % 2);
    for (i = 0; i < size; i++) {
        uint64_t random = next_random(&state);
        data[i] = (uint8_t)(small && i > 8 ? random % 8 - 3 : random);
    }
    return size;
}

// From the heap and of this size, so that sanitizers see what is read beyond it.
static void run_copy(const uint8_t *data, size_t size) {
    uint8_t *copy = (uint8_t *)malloc(size + !size);
    if (!copy)
        exit(2);
    memcpy(copy, data, size);
    LLVMFuzzerTestOneInput(copy, size);
    free(copy);
}

// Usage: FILE... runs files. --random FIRST COUNT runs random bytes number FIRST to FIRST + COUNT - 1; --write NUMBER FILE
// writes those of a number. With sanitizers ASAN_OPTIONS and UBSAN_OPTIONS have to be abort_on_error=1 for the number to be named.
int main(int argc, char **argv) {
    static uint8_t data[1 << 20];
    size_t size;
    FILE *file;
    int i;
    if (argc == 4 && !strcmp(argv[1], "--random")) {
        unsigned long long first = strtoull(argv[2], NULL, 10), count = strtoull(argv[3], NULL, 10);
        signal(SIGABRT, report);
        for (running_number = first; running_number < first + count; running_number++)
            run_copy(data, random_bytes(data, running_number));
        return 0;
    }
    if (argc == 4 && !strcmp(argv[1], "--write")) {
        size = random_bytes(data, strtoull(argv[2], NULL, 10));
        file = fopen(argv[3], "wb");
        return !file || fwrite(data, 1, size, file) != size || fclose(file);
    }
    for (i = 1; i < argc; i++) {
        file = fopen(argv[i], "rb");
        if (!file) {
            perror(argv[i]);
            return 2;
        }
        size = fread(data, 1, sizeof data, file);
        fclose(file);
        fprintf(stderr, "%s\n", argv[i]);
        run_copy(data, size);
    }
    return 0;
}
#endif

#endif
