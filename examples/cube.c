// cc -o cube examples/cube.c -lm && ./cube
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <stdio.h>

int main(void) {
    const double corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    paradt_points points = {.data = corners, .count = 8, .dim = 3};
    paradt_triangulation t;
    if (paradt_triangulate(&t, &points, NULL) != PARADT_OK)
        return 1;
    for (size_t c = 0; c < t.cell_count; c++)
        printf("%d %d %d %d\n", (int)t.cells[4 * c], (int)t.cells[4 * c + 1], (int)t.cells[4 * c + 2],
               (int)t.cells[4 * c + 3]);
    paradt_free(&t);
    return 0;
}
