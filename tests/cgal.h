// CGAL as an oracle: its triangulations are perturbed by the same rule, so the sets of cells must be equal, hidden points included.
// Each call fills cells (sorted, vertices are leaders) and returns the affine dimension.
#ifndef CGAL_H
#define CGAL_H

#include "cells.h"

#ifdef __cplusplus
extern "C" {
#endif
int cgal_triangulate_2(const sample *s, cell_set *cells);
int cgal_triangulate_3(const sample *s, cell_set *cells);
int cgal_triangulate_d(const sample *s, cell_set *cells);
#ifdef __cplusplus
}
#endif

#endif
