// Usage: ranks CASES [weights]. Small sets of all kinds, whole, thinned out on one side, or flattened, have the same cells on two to twelve
// ranks as by a serial call, and what is gathered is certified: in odd cases with half-facets for neighbours. The ranks run one
// after another, by the MPI of the benchmark's study, so a case takes milliseconds with any number of ranks. The exit status is 1
// if a case differs, which is then named.
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

int main(int argc, char **argv) {
    static alone_record record;
    unsigned cases = argc > 1 ? (unsigned)atoi(argv[1]) : 0, number;
    int failed = !cases;
    heavy = argc > 2;
    for (number = 0; number < cases; number++) {
        paradt_triangulation t;
        uint64_t expected;
        int ranks;
        make_case(number);
        ranks = 2 + (int)below(MOST_RANKS - 1);
        if (paradt_triangulate(&t, &at_hand.points, NULL) != PARADT_OK) {
            printf("case %u: one call failed\n", number);
            return 1;
        }
        expected = paradt_hash(&t);
        paradt_free(&t);
        alone_run(&record, ranks, rank_program);
        alone_forget(&record);
        if (at_hand.status == PARADT_OK && at_hand.hash == expected) continue;
        printf("case %u: %s, %d dimensions, %d ranks, %s weights: %s\n", number, paradt_gen_name(at_hand.spec.kind),
               at_hand.points.dim, ranks, at_hand.points.weights ? "with" : "without",
               at_hand.status ? paradt_status_string(at_hand.status) : "other cells");
        failed = 1;
    }
    return failed;
}
