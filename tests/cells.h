// A sample of points, a set of cells and the comparison of two such sets. Shared by all tests; needs nothing but the C library.
#ifndef CELLS_H
#define CELLS_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CELLS_MAX_DIM 8

// Points with or without weights, made by a family of tests/families.h or by a test.
typedef struct sample {
    char name[96];
    int dim;
    int count;
    double *x; // [count][dim]
    double *w; // [count], or NULL
} sample;

// Vertices in ascending order, then -1, so that cells of different dimensions can be compared.
typedef struct cell {
    int v[CELLS_MAX_DIM + 1];
} cell;

// The cells are in lexicographic order after cells_sort.
typedef struct cell_set {
    size_t count, capacity;
    cell *cells;
} cell_set;

// Returns zeroed memory, or ends the program.
static inline void *need(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) {
        fprintf(stderr, "the test ran out of memory\n");
        exit(99);
    }
    return memory;
}

// --- samples

static inline sample sample_make(const char *name, int dim, int count) {
    sample s = {{0}, dim, count, NULL, NULL};
    snprintf(s.name, sizeof s.name, "%s", name);
    s.x = (double *)need((size_t)count * (size_t)dim, sizeof(double));
    return s;
}

static inline void sample_free(sample *s) {
    free(s->x);
    free(s->w);
    memset(s, 0, sizeof *s);
}

// Returns a sample of the `count` points order[0], order[1], ... of s. order may be NULL: the first points.
static inline sample sample_pick(const sample *s, const int *order, int count) {
    sample t = sample_make(s->name, s->dim, count);
    if (s->w)
        t.w = (double *)need((size_t)count, sizeof(double));
    for (int i = 0; i < count; i++) {
        int from = order ? order[i] : i;
        memcpy(t.x + i * s->dim, s->x + from * s->dim, sizeof(double) * (size_t)s->dim);
        if (s->w)
            t.w[i] = s->w[from];
    }
    return t;
}

// Prints one point a line, its coordinates and then its weight in hexadecimal, which is exact and can be read by C and Python.
static inline void sample_print(FILE *file, const sample *s) {
    fprintf(file, "# %s: %d points, dim %d%s\n", s->name, s->count, s->dim, s->w ? ", the last column is the weight" : "");
    for (int i = 0; i < s->count; i++) {
        for (int k = 0; k < s->dim; k++)
            fprintf(file, "%a%s", s->x[i * s->dim + k], k + 1 < s->dim ? ", " : "");
        if (s->w)
            fprintf(file, ", %a", s->w[i]);
        fprintf(file, "\n");
    }
}

static inline int compare_coordinates(const double *a, const double *b, int dim) {
    for (int k = 0; k < dim; k++)
        if (a[k] != b[k])
            return a[k] < b[k] ? -1 : 1;
    return 0;
}

typedef struct placed {
    const double *x;
    double w;
    int dim, index;
} placed;

static inline int compare_placed(const void *a, const void *b) {
    const placed *p = (const placed *)a, *q = (const placed *)b;
    int c = compare_coordinates(p->x, q->x, p->dim);
    if (c)
        return c;
    if (p->w != q->w)
        return p->w > q->w ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

// Fills leader with the point that represents each point: among equal points the heaviest one, then the one with the smallest
// index. Fills rank, unless it is NULL, with each point's place in the lexicographic order of distinct points. Returns the
// number of distinct points.
static inline int sample_leaders(const sample *s, int *leader, int *rank) {
    placed *order = (placed *)need((size_t)s->count, sizeof *order);
    int distinct = 0;
    for (int i = 0; i < s->count; i++) {
        placed p = {s->x + i * s->dim, s->w ? s->w[i] : 0, s->dim, i};
        order[i] = p;
    }
    qsort(order, (size_t)s->count, sizeof *order, compare_placed);
    for (int i = 0, first = 0; i < s->count; i++) {
        if (i == 0 || compare_coordinates(order[i].x, order[first].x, s->dim) != 0) {
            first = i;
            distinct++;
        }
        leader[order[i].index] = order[first].index;
        if (rank)
            rank[order[i].index] = distinct - 1;
    }
    free(order);
    return distinct;
}

// --- sets of cells

static inline int compare_ints(const void *a, const void *b) {
    return *(const int *)a < *(const int *)b ? -1 : *(const int *)a > *(const int *)b;
}

static inline int compare_cells(const void *a, const void *b) {
    const cell *p = (const cell *)a, *q = (const cell *)b;
    for (int i = 0; i <= CELLS_MAX_DIM; i++)
        if (p->v[i] != q->v[i])
            return p->v[i] < q->v[i] ? -1 : 1;
    return 0;
}

static inline cell cell_make(const int *vertices, int width) {
    cell c;
    for (int i = 0; i <= CELLS_MAX_DIM; i++)
        c.v[i] = i < width ? vertices[i] : -1;
    qsort(c.v, (size_t)width, sizeof(int), compare_ints);
    return c;
}

static inline void cells_add(cell_set *set, cell c) {
    if (set->count == set->capacity) {
        cell *grown = (cell *)need(set->capacity * 2 + 64, sizeof(cell));
        if (set->count)
            memcpy(grown, set->cells, set->count * sizeof(cell));
        free(set->cells);
        set->cells = grown;
        set->capacity = set->capacity * 2 + 64;
    }
    set->cells[set->count++] = c;
}

static inline void cells_sort(cell_set *set) {
    if (set->count)
        qsort(set->cells, set->count, sizeof(cell), compare_cells);
}

static inline void cells_free(cell_set *set) {
    free(set->cells);
    memset(set, 0, sizeof *set);
}

static inline void cell_print(FILE *file, const char *prefix, const cell *c) {
    fprintf(file, "%s {", prefix);
    for (int i = 0; i <= CELLS_MAX_DIM && c->v[i] >= 0; i++)
        fprintf(file, "%s%d", i ? " " : "", c->v[i]);
    fprintf(file, "}\n");
}

// Returns the number of cells that are in only one of two sorted sets. Prints the first few to file unless it is NULL.
static inline size_t cells_difference(const cell_set *a, const char *name_a, const cell_set *b, const char *name_b,
                                      FILE *file) {
    size_t i = 0, j = 0, different = 0;
    while (i < a->count || j < b->count) {
        int c = i == a->count ? 1 : j == b->count ? -1 : compare_cells(&a->cells[i], &b->cells[j]);
        if (c != 0 && different++ < 6 && file)
            cell_print(file, c < 0 ? name_a : name_b, c < 0 ? &a->cells[i] : &b->cells[j]);
        i += c <= 0;
        j += c >= 0;
    }
    return different;
}

#endif
