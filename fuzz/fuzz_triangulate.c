// Any bytes are decoded to points in 2 to 5 dimensions. Then
//     - all methods, with one region and with several, and the points in reverse order have to give the same cells
//     - with PARADT_FACETS each facet of a cell has to lead to the same facet of another cell and back
//     - paradt_check has to certify each result
//     - after points have moved, repairing has to give the same as a new triangulation
//     - a failing allocation has to be reported, and may not leak memory
//     - after an element of a result is overwritten, paradt_check has to return, and may only certify the same cells
//
//     mkdir -p build/corpus # receives the inputs that the fuzzer finds
//     clang -g -O1 -fsanitize=fuzzer,address,undefined -I. -o build/fuzz fuzz/fuzz_triangulate.c -lm
//     build/fuzz build/corpus fuzz/corpus
//
//     cc -g -DPARADT_FUZZ_STANDALONE -I. -o build/replay fuzz/fuzz_triangulate.c -lm && build/replay fuzz/corpus/*
//
// The first five bytes are a header:
//     0  bits 0-1: dimension - 2; bits 2-3: encoding; bit 4: the points have weights; bit 5: every third point is a
//        copy; bit 6: numbers that are not finite are kept; bit 7: uniform partition
//     1  regions - 1
//     2  parameter of the encoding
//     3  number of the allocation that fails, and of the element that is overwritten; bits 0-1: how points move
//     4  0, or the points are flat: bit 0: 1: an axis equals the next one, 0: it is constant; bits 1-7: this axis
// The points follow: the coordinates of each and, if there are weights, its weight. next_number has the encodings.
#ifndef PARADT_FUZZ_LINKED // defined if another object has the implementation
#define PARADT_IMPLEMENTATION
#endif
#include "paradt.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_POINTS = 64, MAX_DIM = 5, MAX_REGIONS = 9 };

// Prints an error and aborts, which fuzzers notice.
static void fail(const char *what, const char *detail) {
    fprintf(stderr, "%s: %s\n", what, detail);
    abort();
}

// --- bytes to points

typedef struct bytes {
    const uint8_t *data;
    size_t left;
} bytes;

// Returns the next byte; 0 at the end.
static int next_byte(bytes *b) {
    if (!b->left)
        return 0;
    b->left--;
    return *b->data++;
}

static int next_signed(bytes *b) {
    int byte = next_byte(b);
    return byte < 128 ? byte : byte - 256;
}

static double from_bits(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static uint64_t to_bits(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static int is_finite(double x) {
    return (to_bits(x) >> 52 & 2047) != 2047;
}

// Returns m * 2^e, |m| < 2^8. Stops multiplying beyond 2^1000, and dividing below 2^-1000.
static double scaled(int m, int e) {
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
static double next_number(bytes *b, int encoding, int parameter, int keep) {
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

typedef struct input {
    double x[MAX_POINTS * MAX_DIM], w[MAX_POINTS];
    paradt_points points;
    size_t regions;
    paradt_partition partition;
    int spoil;     // byte 3 of the header: number of what fails or is overwritten, and how points move
    int first_bad; // index of the first point that is not finite, or -1
} input;

static void decode(input *in, const uint8_t *data, size_t size) {
    // Fewer points in higher dimensions, where a point costs more: an input takes well below a tenth of a second, with
    // sanitizers.
    static const int most[MAX_DIM + 1] = {0, 0, 64, 40, 24, 16};
    bytes b = {data, size};
    int flags = next_byte(&b), regions = next_byte(&b), parameter = next_byte(&b), dim = 2 + (flags & 3), count = 0, i;
    int encoding = flags >> 2 & 3, weighted = flags >> 4 & 1, copies = flags >> 5 & 1, keep = flags >> 6 & 1;
    int flat, axis;
    in->spoil = next_byte(&b);
    flat = next_byte(&b);
    axis = (flat >> 1) % dim;
    in->first_bad = -1;
    for (; b.left && count < most[dim]; count++) {
        double *x = in->x + count * dim;
        int from = copies && count % 3 == 2 ? next_byte(&b) % count : -1, bad;
        for (i = 0; i < dim; i++)
            x[i] = from >= 0 ? in->x[from * dim + i] : next_number(&b, encoding, parameter, keep);
        if (flat)
            x[axis] = flat & 1 ? x[(axis + 1) % dim] : 3;
        in->w[count] = weighted ? next_number(&b, encoding, 0, keep) : 0;
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

// Returns the input with the points in reverse order. The caller sets points.data and points.weights.
static input reversed(const input *in) {
    input out = *in;
    size_t i, count = in->points.count, dim = (size_t)in->points.dim;
    for (i = 0; i < count; i++) {
        memcpy(out.x + i * dim, in->x + (count - 1 - i) * dim, dim * sizeof(double));
        out.w[i] = in->w[count - 1 - i];
    }
    return out;
}

// --- the tests

// Calls paradt_check. flags: those that the result was made with
static paradt_status check(const paradt_triangulation *t, const paradt_points *points, unsigned flags,
                           paradt_fault *fault) {
    paradt_options options;
    memset(&options, 0, sizeof options);
    options.flags = flags & PARADT_FACETS;
    return paradt_check(t, points, &options, fault);
}

// The result has to be certified by paradt_check. what: the case, for an error
static void certify(const paradt_triangulation *t, const paradt_points *points, unsigned flags, const char *what) {
    paradt_fault fault;
    paradt_status status = check(t, points, flags, &fault);
    if (status)
        fail(what, fault.reason ? fault.reason : paradt_status_string(status));
}

// Is the vertex one of the facet's? f: (dim + 1) * cell + place
static int facet_has(const paradt_triangulation *t, size_t f, paradt_index vertex) {
    size_t corners = (size_t)(t->dim + 1), j;
    for (j = 0; j < corners; j++)
        if (j != f % corners && t->cells[f / corners * corners + j] == vertex)
            return 1;
    return 0;
}

// Each half-facet that is not on the hull has to have a mirror: the half-facet of another cell with the same vertices,
// whose mirror is the first one.
static void expect_mirrors(const paradt_triangulation *t, const char *what) {
    size_t corners = (size_t)(t->dim + 1), facets = t->neighbors ? t->cell_count * corners : 0, f, j;
    for (f = 0; f < facets; f++) {
        paradt_index mirror = t->neighbors[f];
        if (mirror == -1)
            continue;
        if (mirror < 0 || (size_t)mirror >= facets || t->neighbors[mirror] != (paradt_index)f)
            fail(what, "a facet is not its mirror's mirror");
        for (j = 0; j < corners; j++)
            if (j != f % corners && !facet_has(t, (size_t)mirror, t->cells[f / corners * corners + j]))
                fail(what, "a facet and its mirror have different vertices");
        if (t->cells[f] == t->cells[mirror])
            fail(what, "a facet and its mirror belong to cells with the same vertices");
    }
}

// Overwrites one element of an array of t, and restores it. paradt_check may certify the result only if the cells are
// still the same.
static void expect_no_false_certificate(const paradt_triangulation *t, const paradt_points *points, unsigned flags,
                                        paradt_index *array, size_t count, int spoil) {
    size_t place;
    paradt_index right;
    uint64_t hash = paradt_hash(t);
    if (!array || !count) // a single vertex has no neighbours
        return;
    place = (size_t)spoil * 7 % count;
    right = array[place];
    array[place] = (paradt_index)(spoil % 4 == 0 ? (uint32_t)spoil * 2654435761u : (uint32_t)(spoil % 67) - 2u);
    if (array[place] != right && check(t, points, flags, NULL) == PARADT_OK &&
        (array != t->cells || paradt_hash(t) != hash))
        fail("spoiled result", "it was certified");
    array[place] = right;
}

// The points have to be triangulated, with these options, to cells of this hash.
static void expect_hash(const input *in, const paradt_options *options, uint64_t hash, const char *what) {
    paradt_triangulation t;
    paradt_status status = paradt_triangulate(&t, &in->points, options);
    if (status)
        fail(what, paradt_status_string(status));
    if (paradt_hash(&t) != hash)
        fail(what, "the cells are not InCoDe's");
    certify(&t, &in->points, options->flags, what);
    if (options->flags & PARADT_FACETS) {
        expect_mirrors(&t, what);
        expect_no_false_certificate(&t, &in->points, options->flags, t.neighbors,
                                    t.cell_count * (size_t)(t.dim + 1), in->spoil);
    }
    paradt_free(&t);
}

// Triangulates the points in reverse order. The cells have to be those of t: each vertex is translated to the point
// that stands for it in t.
static void expect_same_reversed(const input *in, const paradt_triangulation *t) {
    input back = reversed(in);
    paradt_triangulation u;
    paradt_status status;
    uint64_t sum = 0;
    size_t c;
    int i, hidden = 0;
    back.points.data = back.x;
    back.points.weights = in->points.weights ? back.w : NULL;
    status = paradt_triangulate(&u, &back.points, NULL);
    if (status)
        fail("reversed", paradt_status_string(status));
    for (c = 0; c < u.cell_count; c++) {
        uint64_t vertices[MAX_DIM + 1];
        for (i = 0; i <= u.dim; i++)
            vertices[i] =
                (uint64_t)t->representative[u.point_count - 1 - (size_t)u.cells[c * (size_t)(u.dim + 1) + (size_t)i]];
        sum += paradt_hash_cell(vertices, u.dim + 1);
    }
    for (c = 0; c < u.point_count; c++)
        hidden += (u.representative[c] < 0) != (t->representative[t->point_count - 1 - c] < 0);
    if (sum != paradt_hash(t) || hidden)
        fail("reversed", "the cells or the hidden points are others");
    certify(&u, &back.points, 0, "reversed");
    paradt_free(&u);
}

// Moves points. kind: 0: each a little, in the last bits of its coordinates; 1: each by up to a 64th of its size; 2: every
// third to the place of another; 3: none, but their weights
static void move(input *in, int kind) {
    size_t count = in->points.count, dim = (size_t)in->points.dim, i;
    for (i = 0; i < count * dim && kind < 2; i++)
        in->x[i] = from_bits(to_bits(in->x[i]) ^ (i * 0x9e3779b97f4a7c15u + 1) >> (kind ? 18 : 54));
    for (i = 0; i < count && kind == 2; i += 3)
        memcpy(in->x + i * dim, in->x + i * 7 % count * dim, dim * sizeof(double));
    for (i = 0; i < count / 2 && kind == 3; i++)
        in->w[i] = in->w[count - 1 - i];
}

// A triangulation has to become that of the points where they are now. flags: those that it is made with
static void expect_repair(const input *in, unsigned flags) {
    input moved = *in;
    paradt_options options;
    paradt_triangulation t, u;
    paradt_status status;
    memset(&options, 0, sizeof options);
    options.flags = flags;
    move(&moved, in->spoil % 4);
    moved.points.data = moved.x;
    moved.points.weights = in->points.weights ? moved.w : NULL;
    status = paradt_triangulate(&t, &in->points, &options);
    if (!status)
        status = paradt_repair(&t, &moved.points, &options, NULL);
    if (!status)
        status = paradt_triangulate(&u, &moved.points, &options);
    if (status)
        fail("repair", paradt_status_string(status));
    if (paradt_hash(&t) != paradt_hash(&u))
        fail("repair", "the cells are not those of a new triangulation");
    if (u.point_count && memcmp(t.representative, u.representative, u.point_count * sizeof *u.representative))
        fail("repair", "the representatives are not those of a new triangulation");
    certify(&t, &moved.points, flags, "repair");
    if (flags & PARADT_FACETS)
        expect_mirrors(&t, "repair");
    paradt_free(&t);
    paradt_free(&u);
}

typedef struct blocks {
    int held;    // blocks that were allocated and not freed
    int calls;   // allocations so far
    int fail_at; // number of the allocation that fails
} blocks;

static void *failing_alloc(void *user, size_t size) {
    blocks *b = (blocks *)user;
    if (b->calls++ == b->fail_at)
        return NULL;
    b->held++;
    return malloc(size);
}

static void failing_free(void *user, void *memory) {
    ((blocks *)user)->held--;
    free(memory);
}

// A failing allocation has to be reported, and no memory may be leaked.
static void expect_clean_failure(const input *in, uint64_t hash) {
    blocks b = {0, 0, 0};
    paradt_options options;
    paradt_triangulation t;
    paradt_status status;
    memset(&options, 0, sizeof options);
    b.fail_at = in->spoil % 32;
    options.allocator.alloc = failing_alloc;
    options.allocator.free = failing_free;
    options.allocator.user = &b;
    options.regions = in->regions;
    status = paradt_triangulate(&t, &in->points, &options);
    if (status != (b.calls > b.fail_at ? PARADT_ERROR_MEMORY : PARADT_OK))
        fail("failing allocation", paradt_status_string(status));
    if (!status && paradt_hash(&t) != hash)
        fail("own allocator", "the cells are others");
    paradt_free(&t);
    if (b.held)
        fail("failing allocation", "memory was leaked");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    input in;
    paradt_options options;
    paradt_triangulation t;
    paradt_status status;
    uint64_t hash;
    int method;
    decode(&in, data, size);
    memset(&options, 0, sizeof options);
    options.method = PARADT_INCODE;
    status = paradt_triangulate(&t, &in.points, &options);
    if (in.first_bad >= 0) {
        if (status != PARADT_ERROR_NOT_FINITE || t.error_point != (size_t)in.first_bad)
            fail("not finite", "the point was not reported");
        return 0;
    }
    if (status)
        fail("InCoDe", paradt_status_string(status));
    certify(&t, &in.points, 0, "InCoDe");
    hash = paradt_hash(&t);

    for (method = 0; method < PARADT_METHOD_COUNT; method++) {
        options.method = (paradt_method)method;
        options.flags = PARADT_NO_NEIGHBORS;
        options.regions = 1;
        expect_hash(&in, &options, hash, paradt_method_string(options.method));
        options.flags = 0;
        options.regions = in.regions;
        options.partition = in.partition;
        expect_hash(&in, &options, hash, "regions");
        options.flags = PARADT_FACETS;
        expect_hash(&in, &options, hash, "facets");
    }
    expect_repair(&in, in.regions % 2 ? PARADT_FACETS : 0);
    expect_same_reversed(&in, &t);
    expect_clean_failure(&in, hash);
    expect_no_false_certificate(&t, &in.points, 0, t.cells, t.cell_count * (size_t)(t.dim + 1), in.spoil);
    expect_no_false_certificate(&t, &in.points, 0, t.neighbors, t.cell_count * (size_t)(t.dim + 1), in.spoil);
    expect_no_false_certificate(&t, &in.points, 0, t.representative, t.point_count, in.spoil);
    paradt_free(&t);
    return 0;
}

#ifdef PARADT_FUZZ_STANDALONE
int main(int argc, char **argv) {
    static uint8_t data[1 << 16];
    int i;
    for (i = 1; i < argc; i++) {
        FILE *file = fopen(argv[i], "rb");
        size_t size;
        if (!file) {
            perror(argv[i]);
            return 2;
        }
        size = fread(data, 1, sizeof data, file);
        fclose(file);
        fprintf(stderr, "%s\n", argv[i]);
        LLVMFuzzerTestOneInput(data, size);
    }
    return 0;
}
#endif
