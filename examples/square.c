// cc -O2 -o square examples/square.c -lm && ./square
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <stdio.h>

int main(void) {
    const double places[5][2] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {1, 1}};
    paradt_points points = paradt_points_f64(places[0], 5, 2);
    paradt_triangulation t;
    if (paradt_triangulate(&t, &points, NULL) != PARADT_OK)
        return 1;
    const size_t k = (size_t)(t.dim + 1);
    for (size_t c = 0; c < t.cell_count; c++) {
        printf("triangle %zu:", c);
        for (size_t j = 0; j < k; j++)
            printf(" %d", (int)t.cells[k * c + j]);
        printf("   neighbours:");
        for (size_t j = 0; j < k; j++)
            printf(" %d", (int)t.neighbors[k * c + j]); // across the edge opposite vertex j; -1: none
        printf("\n");
    }
    paradt_free(&t);
    return 0;
}
