// Voro++ as an oracle for Voronoi and power cells in a box in space: it cuts each cell by planes in floating point.
#ifndef VORO_H
#define VORO_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
typedef struct voro_cell {
    double volume;
    double area;        // of the whole surface
    double centroid[3];
    int faces;          // number of faces that are larger than `least`
    double neighbors;   // sum over these of 1 + the neighbour's index; walls count 0
} voro_cell;

// weights: not negative; NULL: none. box: lower, then upper bounds; holds all points. cells: [count]; empty cells stay 0
void voro_cells(const double *points, const double *weights, size_t count, const double *box, double least,
                voro_cell *cells);
#ifdef __cplusplus
}
#endif

#endif
