// study RUNS gen:KIND:N:SEED RANKS...: measures on one processor how paradt_mpi_triangulate would scale. The MPI of
// alone/mpi.h runs the ranks one at a time, measures the work of each, and models the messages. The study prints a row
// of a table for each number of ranks, of which the first should be 1. The columns, after the points and the ranks:
//   work            seconds of all ranks together
//   slowest         seconds of the rank with the most work
//   time            seconds of the whole: the slowest rank of each step, and the messages
//   messages        seconds of the messages
//   efficiency      time of one rank / (ranks * time)
//   guessed, asked  points received from other ranks, in percent of the points
//   cells again     cells made and not owned, in percent of the cells
//   bytes a point   peak of the largest rank * ranks / points
//   sent            bytes sent by all ranks / points
#define PARADT_MPI_IMPLEMENTATION
#include "paradt_mpi.h"
#define PARADT_POINTS_IMPLEMENTATION
#include "examples/paradt_points.h"

#include <stdio.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

enum { DIM = 3 };

// A row of the table
typedef struct study_row {
    int ranks;
    alone_record record;
    paradt_mpi_stats sum, largest;
    unsigned long steps; // of the triangulation; the hash takes further steps
} study_row;

static struct {
    paradt_gen_spec spec;
    uint64_t cells, hash; // of the first run; those of all other runs have to be equal
    study_row *row;       // the current one
} study;

static void fail(const char *what) {
    fprintf(stderr, "study: %s\n", what);
    exit(1);
}

// The program of each rank. It generates the rank's points, which is not timed, and triangulates.
static void rank_program(int rank) {
    size_t ranks = (size_t)alone.ranks, n = (size_t)study.spec.count;
    size_t first = n / ranks * (size_t)rank, end = rank + 1 == alone.ranks ? n : first + n / ranks;
    double *coordinates = (double *)malloc((end - first + 1) * DIM * sizeof(double));
    paradt_points points;
    paradt_mpi_options options;
    paradt_mpi_triangulation t;
    uint64_t hash;
    memset(&options, 0, sizeof options);
    options.local.progress = alone_progress;
    options.local.allocator.alloc = alone_alloc;
    options.local.allocator.free = alone_free;
    if (!coordinates) fail("no memory");
    paradt_gen_points(&study.spec, DIM, first, end - first, coordinates);
    points = paradt_points_f64(coordinates, end - first, DIM);
    alone_leave(); // starts the clock
    if (paradt_mpi_triangulate(&t, MPI_COMM_WORLD, &points, &options)) fail("the triangulation failed");
    alone_enter();
    if (rank == 0) {
        study.row->sum = t.sum;
        study.row->largest = t.largest;
        study.row->steps = alone.calls;
    }
    hash = paradt_mpi_hash(&t, MPI_COMM_WORLD);
    if (rank == 0 && study.cells && (study.cells != t.cell_total || study.hash != hash))
        fail("the cells are not those of the first run");
    if (rank == 0) {
        study.cells = t.cell_total;
        study.hash = hash;
    }
    paradt_mpi_free(&t);
    free(coordinates);
}

// Lets the process keep freed memory for later runs. Otherwise new pages would decide which rank is the slowest: they
// may take far longer for one rank than for another.
static void keep_memory(void) {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

// Prints a row of the table. one: time of one rank
static void print_row(const char *points, const study_row *row, double one) {
    alone_sum sum = alone_add_up(&row->record, row->steps);
    double n = (double)study.spec.count, ranks = row->ranks, time = sum.computing + sum.messaging;
    printf("| %s | %d | %.2f | %.3f | %.3f | %.4f | %.2f | %.2f %% | %.3f %% | %.1f %% | %.0f | %.0f |\n", points,
           row->ranks, sum.all_work, sum.most_work, time, sum.messaging, one / (ranks * time),
           100 * (double)row->sum.points_guessed / n, 100 * (double)row->sum.points_asked / n,
           100 * (double)row->sum.cells_recomputed / (double)study.cells, (double)row->largest.peak_bytes * ranks / n,
           (double)row->sum.bytes_sent / n);
}

int main(int argc, char **argv) {
    const char *wrong = argc < 4 ? "study RUNS gen:KIND:N:SEED RANKS..." : paradt_gen_parse(&study.spec, argv[2]);
    int count = argc - 3, runs;
    study_row *rows;
    alone_sum first;
    if (wrong) fail(wrong);
    if ((runs = atoi(argv[1])) < 1) fail("RUNS has to be 1 or more");
    keep_memory();
    if (!(rows = (study_row *)calloc((size_t)count, sizeof *rows))) fail("no memory");
    for (int i = 0; i < count; i++) {
        rows[i].ranks = atoi(argv[3 + i]);
        if (rows[i].ranks < 1 || rows[i].ranks > ALONE_MOST_RANKS) fail("the number of ranks has to be 1 to 1024");
    }
    for (int run = 0; run < runs; run++) {
        for (int i = 0; i < count; i++) {
            study.row = &rows[i];
            alone_run(&rows[i].record, rows[i].ranks, rank_program);
        }
    }
    first = alone_add_up(&rows[0].record, rows[0].steps);
    for (int i = 0; i < count; i++) {
        print_row(argv[2], &rows[i], (first.computing + first.messaging) * rows[0].ranks);
        alone_forget(&rows[i].record);
    }
    free(rows);
    return 0;
}
