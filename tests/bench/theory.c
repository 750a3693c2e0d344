// theory [small] [sons-only]: does the Delaunay tree have the size that the theory of randomised incremental
// construction says? Ends with 1 if a prediction and what was counted differ by more than 3 %.
//   small      few points and permutations: seconds instead of a minute
//   sons-only  conflicts are looked for among sons, and not among stepsons: too few are found
//
// THE THEORY is that of theorems 1.4 to 1.6 of the thesis (Clarkson and Shor, "Applications of random sampling in
// computational geometry, II", DCG 4, 1989; Boissonnat, Devillers, Schott, Teillaud and Yvinec, "Applications of random
// sampling to on-line algorithms in computational geometry", DCG 8, 1992; backwards analysis is Seidel's). The objects
// are n points, inserted in random order; the regions are the cells and ghosts of their triangulation. A cell is
// defined by dim + 1 points, a ghost by dim. R_r are the first r points: a random sample of size r. What the theory
// asks of the points is told by random samples alone:
//
//     f0(r)    the expected number of regions of T(R_r), those that have no point of R_r in conflict
//     D(r)     the average degree: how many of them a random point of R_r defines; ((dim + 1) cells + dim ghosts) / r
//     E(r)     the average pair degree: how many of them two random points define together;
//              ((dim + 1) dim cells + dim (dim - 1) ghosts) / (r (r - 1))
//
// Every point of R_r is equally likely to be the one inserted last, so the insertion of the r-th makes D(r) regions.
//     (1) History. The first dim + 1 points make dim + 2 regions, so after r insertions there have been
//             H(r) = dim + 2 + D(dim + 2) + ... + D(r).
//     (2) Conflicts of the next point. The next insertion makes D(r + 1) regions, and there are f0(r + 1) - f0(r) more
//         afterwards. The difference is what it kills:
//             C(r) = D(r + 1) - (f0(r + 1) - f0(r)).
//     (3) Conflict history: regions ever made that are in conflict with a point x inserted after R_r. Let p be the s-th
//         point. Of the D(s) regions of T(R_s) with p, the insertion of x right after p would leave those that T(R_s,
//         x) has with p and without x: D(s + 1) - E(s + 1), for p and x are random points of s + 1. So it kills D(s) -
//         D(s + 1) + E(s + 1) regions made at step s, and these are the ones in conflict with x:
//             W(r) = C(dim + 1) + D(dim + 2) - D(r + 1) + E(dim + 3) + ... + E(r + 1).
//
// f0 is estimated from samples of all sizes up to a few dozen and then of sizes in geometric progression, between which
// it is interpolated as a power. f0(r + 1) - f0(r) is the slope of f0 between sizes well below and well above r: the
// difference of two estimates would drown in their noise. Samples and permutations are of the same n points, but drawn
// independently. The numbers are the same on all machines.
#define PARADT_STATIC // functions that are not called are not compiled
#define PARADT_IMPLEMENTATION
#include "paradt.h"

#include <stdio.h>

#define TOLERANCE 0.03

enum { MOST_SIZES = 200, STAGES = 3, EVERY_SIZE = 40, MORE_FOR_FEW = 30 };

// Points, and how much is spent on them
typedef struct subject {
    const char *name;
    int dim, count;
    int curve;    // on the moment curve; else uniform in a cube
    size_t drawn; // points in all samples of one size
    int permutations;
    int queries; // at each stage of a permutation, at most
} subject;

static const subject subjects[] = {{"uniform in the plane", 2, 3000, 0, 40000, 200, 60},
                                   {"uniform in space", 3, 1500, 0, 30000, 200, 60},
                                   {"uniform in 4 dimensions", 4, 500, 0, 8000, 200, 60},
                                   {"on the moment curve in space", 3, 160, 1, 4000, 400, 30}};
static const subject small_subjects[] = {{"uniform in the plane", 2, 400, 0, 12000, 200, 40},
                                         {"uniform in space", 3, 200, 0, 12000, 200, 40},
                                         {"uniform in 4 dimensions", 4, 80, 0, 4000, 200, 40},
                                         {"on the moment curve in space", 3, 60, 1, 2000, 200, 20}};

static void fail(const char *what) {
    fprintf(stderr, "theory: %s\n", what);
    exit(2);
}

static void expect(paradt_status status) {
    if (status) fail(paradt_status_string(status));
}

static void *need(size_t count, size_t size) {
    void *block = calloc(count ? count : 1, size);
    if (!block) fail("no memory");
    return block;
}

// --- chance

static uint64_t random_state = 1;

static double random_unit(void) {
    return (double)(paradt__mix(random_state++) >> 11) * 0x1p-53;
}

// Brings `drawn` random items of the order to its front.
static void draw(paradt_index *order, size_t drawn, size_t count) {
    size_t i;
    for (i = 0; i < drawn && i + 1 < count; i++) {
        size_t j = i + (size_t)(random_unit() * (double)(count - i));
        paradt_index swap = order[i];
        order[i] = order[j];
        order[j] = swap;
    }
}

static double *make_points(const subject *s) {
    double *x = (double *)need((size_t)(s->count * s->dim), sizeof *x);
    int i, k;
    for (i = 0; i < s->count; i++) {
        double t = random_unit(), power = 1;
        for (k = 0; k < s->dim; k++) x[i * s->dim + k] = s->curve ? (power *= t) : random_unit();
    }
    return x;
}

// --- what random samples say

typedef struct sampled {
    int dim, sizes, size[MOST_SIZES];
    double cells[MOST_SIZES], ghosts[MOST_SIZES];
} sampled;

// Averages the numbers of cells and ghosts over samples of one size.
static void sample_size(const subject *s, const double *x, paradt_index *order, int size, double *cells,
                        double *ghosts) {
    size_t runs = (s->drawn + MORE_FOR_FEW * s->drawn / (size_t)size) / (size_t)size + 1, run, i,
           bytes = (size_t)s->dim * sizeof *x;
    double *chosen = (double *)need((size_t)size, bytes);
    paradt_points points = paradt_points_f64(chosen, (size_t)size, s->dim);
    *cells = *ghosts = 0;
    for (run = 0; run < runs; run++) {
        paradt_triangulation t;
        draw(order, (size_t)size, (size_t)s->count);
        for (i = 0; i < (size_t)size; i++) memcpy(chosen + i * (size_t)s->dim, x + order[i] * s->dim, bytes);
        expect(paradt_triangulate(&t, &points, NULL));
        *cells += (double)t.cell_count / (double)runs;
        *ghosts += (double)t.stats.hull_facets / (double)runs;
        paradt_free(&t);
    }
    free(chosen);
}

static void sample_all(const subject *s, const double *x, paradt_index *order, sampled *f) {
    int size = s->dim + 1;
    f->dim = s->dim;
    for (f->sizes = 0; f->sizes < MOST_SIZES; f->sizes++) {
        f->size[f->sizes] = size;
        sample_size(s, x, order, size, f->cells + f->sizes, f->ghosts + f->sizes);
        if (size == s->count) break;
        size += size < EVERY_SIZE ? 1 : size / 12;
        if (size > s->count) size = s->count;
    }
    f->sizes++;
}

// Interpolates what was averaged at the sizes.
static double at_size(const sampled *f, const double *values, double r) {
    int k = 1;
    double part;
    while (k < f->sizes - 1 && f->size[k] < r) k++;
    part = log(r / f->size[k - 1]) / log((double)f->size[k] / f->size[k - 1]);
    return values[k - 1] * pow(values[k] / values[k - 1], part);
}

static double regions(const sampled *f, double r) { // f0
    return at_size(f, f->cells, r) + at_size(f, f->ghosts, r);
}

static double degree(const sampled *f, double r) { // D
    return ((f->dim + 1) * at_size(f, f->cells, r) + f->dim * at_size(f, f->ghosts, r)) / r;
}

static double pair_degree(const sampled *f, double r) { // E
    double twice = (f->dim + 1) * f->dim * at_size(f, f->cells, r) + f->dim * (f->dim - 1) * at_size(f, f->ghosts, r);
    return twice / (r * (r - 1));
}

static double history(const sampled *f, int r) { // H
    double sum = f->dim + 2;
    int s;
    for (s = f->dim + 2; s <= r; s++) sum += degree(f, s);
    return sum;
}

static double conflicts(const sampled *f, int r) { // C
    double low = r / 1.3, high = r * 1.3, growth;
    if (r < 4 * f->dim) {
        growth = regions(f, r + 1) - regions(f, r);
    } else {
        double exponent = log(regions(f, high) / regions(f, low)) / log(high / low);
        growth = regions(f, r + 0.5) * exponent / (r + 0.5);
    }
    return degree(f, r + 1) - growth;
}

static double conflict_history(const sampled *f, int r) { // W
    double sum = conflicts(f, f->dim + 1) + degree(f, f->dim + 2) - degree(f, r + 1);
    int s;
    for (s = f->dim + 2; s <= r; s++) sum += pair_degree(f, s + 1);
    return sum;
}

// --- what the Delaunay tree has

enum { HISTORY, CONFLICTS, CONFLICT_HISTORY, COUNTED };
static const char *const counted_names[] = {"history", "in conflict with the next point", "conflict history"};

typedef struct counted {
    double sum, squares; // over permutations
} counted;

// Counts the nodes in conflict with x, all of them and those that live.
static void traverse(paradt__tree *tree, paradt__scene *scene, const double *x, int sons_only, paradt_index *waiting,
                     double *all, double *live) {
    size_t count = 0, i;
    paradt__tree_begin_search(tree);
    for (i = 0; i < tree->roots; i++) waiting[count++] = (paradt_index)i;
    while (count) {
        paradt__tree_node *node = paradt__tree_at(tree, waiting[--count]);
        paradt_index next;
        if (node->seen == tree->searches) continue;
        node->seen = tree->searches;
        if (!paradt__tree_conflicts(scene, node, x)) continue;
        *all += 1;
        *live += node->place != PARADT__NOWHERE;
        for (next = node->son; next >= 0; next = paradt__tree_at(tree, next)->brother) waiting[count++] = next;
        for (next = node->stepson; next >= 0 && !sons_only; next = paradt__tree_at(tree, next)->stepbrother)
            waiting[count++] = next;
    }
}

// Inserts points until there are so many.
static void insert_up_to(paradt__tree *tree, paradt__insertion *build, size_t count) {
    while (build->inserted < count) {
        paradt_index point = paradt__insertion_point(build, build->inserted), place;
        expect(paradt__tree_locate(tree, &build->scene, paradt__insertion_start(build),
                                   paradt__scene_record(&build->scene, point), &place));
        expect(paradt__insert_next(build, place));
        expect(paradt__tree_record(tree, build, point));
    }
}

// Inserts the points in a random order up to each stage, and lets later points count their conflicts there.
static void count_permutation(const subject *s, const paradt__set *set, paradt__memory *memory, paradt_index *order,
                              const int *stages, int sons_only, counted (*results)[COUNTED]) {
    paradt_index first;
    paradt__insertion build;
    paradt__tree tree;
    int stage, queries, i;
    draw(order, (size_t)s->count, (size_t)s->count);
    first = order[0];
    paradt__insertion_begin(&build, set, order, memory);
    if (order[0] != first) fail("the first points do not span the space");
    expect(paradt__insertion_first(&build));
    expect(paradt__tree_begin(&tree, &build.scene.mesh, memory));
    for (stage = 0; stage < STAGES; stage++) {
        double value[COUNTED] = {0};
        paradt_index *waiting;
        insert_up_to(&tree, &build, (size_t)stages[stage]);
        waiting = (paradt_index *)need(2 * tree.nodes.count + tree.roots, sizeof *waiting); // each is in two lists at most
        queries = s->queries < s->count - stages[stage] ? s->queries : s->count - stages[stage];
        for (i = 0; i < queries; i++)
            traverse(&tree, &build.scene, paradt__scene_record(&build.scene, order[stages[stage] + i]), sons_only,
                     waiting, value + CONFLICT_HISTORY, value + CONFLICTS);
        free(waiting);
        value[CONFLICTS] /= queries;
        value[CONFLICT_HISTORY] /= queries;
        value[HISTORY] = (double)tree.nodes.count;
        for (i = 0; i < COUNTED; i++) {
            results[stage][i].sum += value[i];
            results[stage][i].squares += value[i] * value[i];
        }
    }
    paradt__tree_free(&tree);
    paradt__insertion_end(&build);
}

static void count_all(const subject *s, const double *x, paradt_index *order, const int *stages, int sons_only,
                      counted (*results)[COUNTED]) {
    paradt_points points = paradt_points_f64(x, (size_t)s->count, s->dim);
    paradt_index *representative = (paradt_index *)need((size_t)s->count, sizeof *representative);
    paradt__memory memory;
    paradt__set set;
    size_t bad;
    int i;
    paradt__memory_begin(&memory, NULL);
    memset(&set, 0, sizeof set);
    expect(paradt__set_load(&set, &points, NULL, &paradt__alone, &memory, representative, &bad));
    if ((int)set.count != s->count || set.space.dim != s->dim) fail("the points are not in general position");
    for (i = 0; i < s->permutations; i++) count_permutation(s, &set, &memory, order, stages, sons_only, results);
    paradt__set_free(&set, &memory);
    free(representative);
}

// --- beside each other

// Prints a prediction and what was counted, with its standard error. Returns whether they agree.
static int compare(int r, const char *name, double predicted, const counted *c, int permutations) {
    double mean = c->sum / permutations, variance = c->squares / permutations - mean * mean;
    double error = sqrt((variance > 0 ? variance : 0) / (permutations - 1));
    int agree = fabs(mean - predicted) <= TOLERANCE * predicted;
    printf("  r = %4d  %-32s %12.2f %12.2f  %+6.2f %%  (+- %.2f %%)%s\n", r, name, predicted, mean,
           100 * (mean / predicted - 1), 100 * error / mean, agree ? "" : "  DIFFERENT");
    return agree;
}

// Returns whether all of a subject's predictions agree with what was counted.
static int study(const subject *s, int sons_only) {
    const int stages[STAGES] = {s->count / 5, s->count / 2, s->count * 3 / 4};
    counted results[STAGES][COUNTED];
    sampled f;
    double *x = make_points(s);
    paradt_index *order = (paradt_index *)need((size_t)s->count, sizeof *order);
    int i, agree = 1;
    for (i = 0; i < s->count; i++) order[i] = (paradt_index)i;
    memset(results, 0, sizeof results);
    sample_all(s, x, order, &f);
    count_all(s, x, order, stages, sons_only, results);
    printf("%d points %s, %d permutations\n", s->count, s->name, s->permutations);
    for (i = 0; i < STAGES; i++)
        printf("  r = %4d  samples: f0 = %.1f, average degree %.3f, average pair degree %.4f\n", stages[i],
               regions(&f, stages[i]), degree(&f, stages[i]), pair_degree(&f, stages[i]));
    printf("  %-8s  %-32s %12s %12s\n", "", "", "predicted", "counted");
    for (i = 0; i < STAGES; i++) {
        int r = stages[i], k;
        const double predicted[COUNTED] = {history(&f, r), conflicts(&f, r), conflict_history(&f, r)};
        for (k = 0; k < COUNTED; k++)
            agree &= compare(r, counted_names[k], predicted[k], &results[i][k], s->permutations);
    }
    free(order);
    free(x);
    return agree;
}

int main(int argc, char **argv) {
    const subject *chosen = subjects;
    int sons_only = 0, agree = 1, i;
    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "small")) chosen = small_subjects;
        else if (!strcmp(argv[i], "sons-only")) sons_only = 1;
        else fail("usage: theory [small] [sons-only]");
    }
    for (i = 0; i < (int)(sizeof subjects / sizeof subjects[0]); i++) agree &= study(chosen + i, sons_only);
    printf("Predictions and counts %s within %.0f %%.\n", agree ? "agree" : "do NOT agree", 100 * TOLERANCE);
    return !agree;
}
