// study RUNS gen:KIND:N:SEED RANKS...: how paradt_mpi_triangulate would scale, on one processor. The ranks' work is
// measured alone, one after another, by the MPI of alone/mpi.h, which tells what the model of messages is. A line of a
// table for each number of ranks, from that of one on:
//   work      seconds of all ranks together; slowest: of the rank with most
//   time      of the whole: of each step the slowest rank, and the messages
//   talking   the messages' part of it
//   efficiency  the time of one rank / (ranks * time)
//   guessed, asked  points got from others, of all
//   again     cells made for others' sake, of all
//   bytes     a point: the largest rank's peak, * ranks / points, and sent by all ranks
#define PARADT_MPI_IMPLEMENTATION
#include "paradt_mpi.h"
#define PARADT_POINTS_IMPLEMENTATION
#include "examples/paradt_points.h"

#include <stdio.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

enum { DIM = 3 };

// One number of ranks
typedef struct study_row {
    int ranks;
    alone_record record;
    paradt_mpi_stats sum, largest;
    unsigned long steps; // without those of the check
} study_row;

static struct {
    paradt_gen_spec spec;
    uint64_t cells, hash; // of the first run; all others must have the same
    study_row *row;       // that is run
} study;

static void fail(const char *what) {
    fprintf(stderr, "study: %s\n", what);
    exit(1);
}

// Each rank makes its share, which is in no time.
static void rank_program(int rank) {
    size_t ranks = (size_t)alone.ranks, n = (size_t)study.spec.count;
    size_t first = n / ranks * (size_t)rank, end = rank + 1 == alone.ranks ? n : first + n / ranks;
    double *coordinates = (double *)malloc((end - first + 1) * DIM * sizeof(double));
    paradt_points points = paradt_points_f64(coordinates, end - first, DIM);
    paradt_mpi_options options;
    paradt_mpi_triangulation t;
    uint64_t hash;
    memset(&options, 0, sizeof options);
    options.local.progress = alone_progress;
    options.local.allocator.alloc = alone_alloc;
    options.local.allocator.free = alone_free;
    if (!coordinates) fail("no memory");
    paradt_gen_points(&study.spec, DIM, first, end - first, coordinates);
    alone_leave(); // the time begins
    if (paradt_mpi_triangulate(&t, MPI_COMM_WORLD, &points, &options)) fail("it was not triangulated");
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

// The process keeps the memory that ranks give back, for the runs that follow. Else new pages, which may take ten times
// as long for one rank as for another of the same process, decide which rank is the slowest.
static void keep_memory(void) {
#ifdef __GLIBC__
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

// one: the time of one rank
static void print_row(const char *points, const study_row *row, double one) {
    alone_sum sum = alone_add_up(&row->record, row->steps);
    double n = (double)study.spec.count, ranks = row->ranks, time = sum.computing + sum.talking;
    printf("| %s | %d | %.2f | %.3f | %.3f | %.4f | %.2f | %.2f %% | %.3f %% | %.1f %% | %.0f | %.0f |\n", points,
           row->ranks, sum.all_work, sum.most_work, time, sum.talking, one / (ranks * time),
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
    if ((runs = atoi(argv[1])) < 1) fail("RUNS is a number from 1 on");
    keep_memory();
    if (!(rows = (study_row *)calloc((size_t)count, sizeof *rows))) fail("no memory");
    for (int i = 0; i < count; i++) {
        rows[i].ranks = atoi(argv[3 + i]);
        if (rows[i].ranks < 1 || rows[i].ranks > ALONE_MOST_RANKS) fail("so many ranks can't be");
    }
    for (int run = 0; run < runs; run++) {
        for (int i = 0; i < count; i++) {
            study.row = &rows[i];
            alone_run(&rows[i].record, rows[i].ranks, rank_program);
        }
    }
    first = alone_add_up(&rows[0].record, rows[0].steps);
    for (int i = 0; i < count; i++) {
        print_row(argv[2], &rows[i], (first.computing + first.talking) * rows[0].ranks);
        alone_forget(&rows[i].record);
    }
    free(rows);
    return 0;
}
