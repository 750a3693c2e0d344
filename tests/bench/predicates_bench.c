// Prints the nanoseconds a call of each stage of the predicates, on inputs that this stage decides.

#define PARADT_IMPLEMENTATION
#define PARADT_STATIC
#include "../../paradt.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { TUPLES = 512, POINTS = PARADT_MAX_DIM + 2, REPEATS = 7 };

typedef struct tuple {
    double memory[POINTS][PARADT_MAX_DIM + 1];
    const double *points[POINTS];
} tuple;

static tuple tuples[TUPLES];
static paradt__space space;
static volatile int sink;

static uint64_t random_bits(void) {
    static uint64_t state = 1;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state * 0x2545f4914f6cdd1du;
}

static double uniform(void) {
    return (double)(random_bits() >> 11) / 9007199254740992.0;
}

static double make_uniform(int size) {
    (void)size;
    return uniform();
}

static double make_lattice(int size) {
    return (double)(random_bits() % (uint64_t)size);
}

// Returns a number with a full mantissa and one of `size` exponents.
static double make_spread(int size) {
    return (1 + uniform()) * paradt__power(-(int)(random_bits() % (uint64_t)size));
}

// The points of each tuple are mirror images of one point, so they are on a sphere.
static void make_cospherical(int d, int size) {
    for (int n = 0; n < TUPLES; n++)
        for (int j = 0; j < d; j++) {
            double x = 1 + make_lattice(size);
            for (int i = 0; i < d + 2; i++)
                tuples[n].memory[i][j] = random_bits() & 1 << 20 ? x : -x;
        }
}

// Lets the space measure the coordinates of the tuples.
static void measure_tuples(int d, int weighted) {
    paradt__space_begin(&space, d, d, weighted);
    for (int n = 0; n < TUPLES; n++)
        for (int i = 0; i < POINTS; i++) {
            tuples[n].points[i] = tuples[n].memory[i];
            if (i < d + 2)
                paradt__space_add(&space, tuples[n].points[i]);
        }
    paradt__space_end(&space);
}

static void make_tuples(int d, int weighted, double (*make)(int), int size) {
    memset(tuples, 0, sizeof tuples);
    for (int n = 0; n < TUPLES; n++)
        for (int i = 0; i < d + 2; i++)
            for (int j = 0; j < d + weighted; j++)
                tuples[n].memory[i][j] = make(size);
    measure_tuples(d, weighted);
}

static double seconds(void) {
    return (double)clock() / CLOCKS_PER_SEC;
}

typedef enum question { ORIENT, INSPHERE, CONFLICT, EXACT_ORIENT, EXACT_INSPHERE } question;

static int ask(question what, const double *const *p) {
    switch (what) {
    case ORIENT:
        return paradt__orient(&space, p);
    case INSPHERE:
        return paradt__insphere(&space, p);
    case CONFLICT:
        return paradt__conflict(&space, p);
    case EXACT_ORIENT:
        return paradt__exact_orient(&space, p);
    default:
        return paradt__exact_insphere(&space, p);
    }
}

// Prints one line: the least time of several repeats, and the share of each exact stage.
static void run(const char *name, int d, question what) {
    static const char *const names[] = {"orient", "in-sphere", "conflict", "orient, exact", "in-sphere, exact"};
    double best = 1e9;
    paradt__counters *c = &space.counters;
    memset(c, 0, sizeof *c);
    for (int repeat = 0; repeat < REPEATS; repeat++) {
        int rounds = 0, sum = 0;
        double start = seconds(), end = start;
        do {
            for (int n = 0; n < TUPLES; n++)
                sum += ask(what, tuples[n].points);
            rounds++;
            end = seconds();
        } while (end - start < 0.02);
        sink = sum;
        double ns = (end - start) * 1e9 / rounds / TUPLES;
        if (ns < best)
            best = ns;
    }
    double total = (double)(c->orient_calls + c->insphere_calls);
    double settled = (double)(c->exact_small + c->exact_fixed + c->exact_general);
    if (what == EXACT_ORIENT || what == EXACT_INSPHERE)
        total = settled;
    printf("%dD  %-34s %-18s %9.1f ns   small %3.0f%%  fixed %3.0f%%  general %3.0f%%\n", d, name, names[what], best,
           100 * (double)c->exact_small / total, 100 * (double)c->exact_fixed / total,
           100 * (double)c->exact_general / total);
}

int main(int argc, char **argv) {
    static const int dims[] = {2, 3, 4, 6};
    for (int n = 0; n < 4; n++) {
        int d = dims[n];
        if (argc > 1 && atoi(argv[1]) != d)
            continue;
        make_tuples(d, 0, make_uniform, 0);
        run("uniform", d, ORIENT);
        run("uniform", d, INSPHERE);
        run("uniform", d, EXACT_ORIENT);
        run("uniform", d, EXACT_INSPHERE);
        make_tuples(d, 1, make_uniform, 0);
        run("uniform, weighted", d, INSPHERE);
        run("uniform, weighted", d, EXACT_INSPHERE);
        make_cospherical(d, 30);
        measure_tuples(d, 0);
        run("cospherical, 30", d, INSPHERE);
        run("cospherical, 30", d, CONFLICT);
        make_cospherical(d, 3000);
        measure_tuples(d, 0);
        run("cospherical, 3000", d, INSPHERE);
        run("cospherical, 3000", d, CONFLICT);
        make_tuples(d, 0, make_lattice, 1 << 20);
        run("lattice, 2^20", d, EXACT_ORIENT);
        run("lattice, 2^20", d, EXACT_INSPHERE);
        make_tuples(d, 0, make_spread, 40);
        run("exponents 40 apart", d, EXACT_ORIENT);
        run("exponents 40 apart", d, EXACT_INSPHERE);
        make_tuples(d, 0, make_spread, 200);
        run("exponents 200 apart", d, EXACT_ORIENT);
        run("exponents 200 apart", d, EXACT_INSPHERE);
        make_tuples(d, 0, make_spread, 1000);
        run("exponents 1000 apart", d, EXACT_INSPHERE);
    }
    return 0;
}
