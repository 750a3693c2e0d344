// Usage: ranks CASES [weights]. Sets that are made for one step of the ranks' way each, and then small sets of all kinds, whole,
// thinned out on one side, or flattened, have the same cells on two to twelve ranks as by a serial call, and what is gathered is
// certified: in odd cases with half-facets for neighbours. The ranks run one after another, by the MPI of the benchmark's study, so
// a case takes milliseconds with any number of ranks. The exit status is 1 if a case differs, which is then named.
#define PARADT_MPI_IMPLEMENTATION
#include "paradt_mpi.h"
#define PARADT_POINTS_IMPLEMENTATION
#include "examples/paradt_points.h"

#include <stdio.h>

enum { MOST_POINTS = 400, MOST_RANKS = 12 };

static struct {
    paradt_gen_spec spec;
    double x[MOST_POINTS * 3], weights[MOST_POINTS];
    paradt_points points;
    paradt_options options;
    uint64_t hash; // of the ranks' cells
    paradt_status status;
} at_hand;

static uint64_t state;
static int heavy; // all have weights

static size_t below(size_t bound) {
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (size_t)(state >> 33) % bound;
}

// Keeps the points beyond the middle of an axis, and every sixteenth of the others.
static void thin_out(void) {
    size_t dim = (size_t)at_hand.points.dim, kept = 0, i;
    for (i = 0; i < at_hand.points.count; i++) {
        if (i % 16 && at_hand.x[i * dim + 1] <= 0.5) continue;
        memmove(at_hand.x + kept * dim, at_hand.x + i * dim, dim * sizeof *at_hand.x);
        at_hand.weights[kept++] = at_hand.weights[i];
    }
    at_hand.points.count = kept;
}

static void make_case(unsigned number) {
    size_t i;
    int dim;
    state = number;
    memset(&at_hand.options, 0, sizeof at_hand.options);
    at_hand.options.flags = number % 2 ? PARADT_FACETS : 0;
    below(2); // skips the first value, which hardly depends on the number
    at_hand.spec.kind = (int)below((size_t)paradt_gen_kinds());
    at_hand.spec.count = 4 + below(MOST_POINTS - 4);
    at_hand.spec.seed = number;
    dim = below(4) ? 2 : 3;
    memset(&at_hand.points, 0, sizeof at_hand.points);
    at_hand.points.data = at_hand.x;
    at_hand.points.count = at_hand.spec.count;
    at_hand.points.dim = dim;
    at_hand.points.weights = below(6) && !heavy ? NULL : at_hand.weights;
    paradt_gen_points(&at_hand.spec, dim, 0, at_hand.spec.count, at_hand.x);
    paradt_gen_weights(&at_hand.spec, dim, 0, at_hand.spec.count, at_hand.weights);
    for (i = 0; i < at_hand.spec.count && heavy; i++)
        at_hand.weights[i] = (double)below(1000) * (i % 7 ? 1e-5 : 2e-4) * (double)(1 + below(3));
    switch (below(4)) {
    case 1:
        for (i = 0; i < at_hand.spec.count; i++) at_hand.x[i * (size_t)dim] /= 64;
        break;
    case 2: thin_out(); break;
    }
}

// --- sets that are made

static double between(double low, double high) { return low + (high - low) * (double)below(1u << 30) / (double)(1u << 30); }

// Adds so many points in a box.
static void add(size_t count, double x0, double x1, double y0, double y1, double z0, double z1) {
    for (; count; count--) {
        double *x = at_hand.x + at_hand.points.count++ * (size_t)at_hand.points.dim;
        x[0] = between(x0, x1);
        x[1] = between(y0, y1);
        if (at_hand.points.dim == 3) x[2] = between(z0, z1);
    }
}

// A rank of sparse points, and a dense clump of as many that is the other rank's. It is beside the margin that the clump's rank
// fills, or in it. So the sparse rank knows none of the clump's points, and may not take its box with the whole margin for
// complete; and spheres in it reach the clump without reaching beyond all its sides.
static void sparse_and_clump(unsigned number) {
    double away = between(0, 8);
    at_hand.points.dim = number % 2 ? 2 : 3;
    add(150, -30, 0, 0, 10, 0, 10);
    add(150, away, away + 0.01, 5, 5.01, 5, 5.01);
}

// Adds a dense group behind a tip, which alone is seen from the other side. side: -1: the group is on the left of the tip
static void add_group(size_t count, double tip, double side) {
    add(1, tip, tip, 0, 0, 0, 0);
    for (; count > 1; count--) {
        double depth = between(0.001, 0.01);
        add(1, tip + side * depth, tip + side * depth, -0.3 * depth, 0.3 * depth, 0, 0);
    }
}

// Three ranks side by side. One point of the first and one of the last see each other through the rank between, which has
// points above and below. Each is the tip of a dense group, so that nobody guesses that the other rank wants it; but the first
// rank's margin is wide. Both cells with the two have a point of the rank between, to which the one of the first was sent.
static void hole_between(unsigned number) {
    double gap = between(2, 4);
    (void)number;
    at_hand.points.dim = 2;
    add_group(24, 0, -1);
    add(38, -60, -4, -25, 25, 0, 0);
    add(28, 1, 2, gap, 25, 0, 0);
    add(28, 1, 2, -25, -gap, 0, 0);
    add_group(24, 3, 1);
    add(38, 6, 60, -25, 25, 0, 0);
}

static const struct {
    const char *name;
    void (*make)(unsigned number);
    int ranks;
} made[] = {{"sparse points and a clump", sparse_and_clump, 2}, {"a hole in the rank between", hole_between, 3}};

enum { MADE = 40 }; // sets, of each kind in turns

static int make_set(unsigned number) {
    unsigned kind = number % (unsigned)(sizeof made / sizeof made[0]);
    state = number;
    below(2);
    memset(&at_hand.points, 0, sizeof at_hand.points);
    memset(&at_hand.options, 0, sizeof at_hand.options);
    at_hand.points.data = at_hand.x;
    made[kind].make(number / 2);
    return made[kind].ranks;
}

static void rank_program(int rank) {
    size_t ranks = (size_t)alone.ranks, count = at_hand.points.count;
    size_t first = count * (size_t)rank / ranks, end = count * ((size_t)rank + 1) / ranks;
    paradt_points share = at_hand.points;
    paradt_mpi_options options;
    paradt_mpi_triangulation t;
    paradt_triangulation whole;
    paradt_status status;
    uint64_t hash;
    memset(&options, 0, sizeof options);
    options.local = at_hand.options;
    share.data = at_hand.x + first * (size_t)share.dim;
    share.weights = share.weights ? at_hand.weights + first : NULL;
    share.count = end - first;
    status = paradt_mpi_triangulate(&t, MPI_COMM_WORLD, &share, &options);
    hash = status ? 0 : paradt_mpi_hash(&t, MPI_COMM_WORLD);
    if (!status) status = paradt_mpi_gather(&whole, MPI_COMM_WORLD, &t, 0);
    if (rank == 0) {
        at_hand.status = status ? status : paradt_check(&whole, &at_hand.points, &at_hand.options, NULL);
        at_hand.hash = hash;
    }
    if (!status) paradt_free(&whole);
    paradt_mpi_free(&t);
}

// Compares the cells of the set at hand on some ranks with those of a serial call. Returns 0 if they differ.
static int compare(const char *name, unsigned number, int ranks) {
    static alone_record record;
    paradt_triangulation t;
    uint64_t expected;
    if (paradt_triangulate(&t, &at_hand.points, NULL) != PARADT_OK) {
        printf("case %u: one call failed\n", number);
        return 0;
    }
    expected = paradt_hash(&t);
    paradt_free(&t);
    alone_run(&record, ranks, rank_program);
    alone_forget(&record);
    if (at_hand.status == PARADT_OK && at_hand.hash == expected) return 1;
    printf("case %u: %s, %d dimensions, %d ranks, %s weights: %s\n", number, name, at_hand.points.dim, ranks,
           at_hand.points.weights ? "with" : "without",
           at_hand.status ? paradt_status_string(at_hand.status) : "other cells");
    return 0;
}

int main(int argc, char **argv) {
    unsigned cases = argc > 1 ? (unsigned)atoi(argv[1]) : 0, number;
    int failed = !cases;
    heavy = argc > 2;
    for (number = 0; number < MADE && !heavy; number++) {
        int ranks = make_set(number);
        failed |= !compare(made[number % 2].name, number, ranks);
    }
    for (number = 0; number < cases; number++) {
        make_case(number);
        failed |= !compare(paradt_gen_name(at_hand.spec.kind), number, 2 + (int)below(MOST_RANKS - 1));
    }
    return failed;
}
