// cc -O2 -o cube examples/cube.c -lm && ./cube
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <stdio.h>

int main(void) {
    const double corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    paradt_points points = paradt_points_f64(corners[0], 8, 3);
    paradt_triangulation t;
    if (paradt_triangulate(&t, &points, NULL) != PARADT_OK)
        return 1;
    const size_t k = (size_t)(t.dim + 1); // vertices a cell
    for (size_t c = 0; c < t.cell_count; c++)
        for (size_t j = 0; j < k; j++)
            printf("%d%c", (int)t.cells[k * c + j], j + 1 < k ? ' ' : '\n');
    paradt_free(&t);
    return 0;
}
