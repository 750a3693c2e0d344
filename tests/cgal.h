// CGAL as an oracle: it perturbs by the same rule, so its cells and hidden points must equal ParaDT's.
// Each function fills cells, sorted and with leaders for vertices, and returns the affine dimension.
#ifndef CGAL_H
#define CGAL_H

#include "cells.h"

#ifdef __cplusplus
extern "C" {
#endif
int cgal_triangulate_2(const sample *s, cell_set *cells);
int cgal_triangulate_3(const sample *s, cell_set *cells);
int cgal_triangulate_d(const sample *s, cell_set *cells);
// Marks the leaders of the extreme points: extreme[s->count], 0 at first. The points span the plane or space.
void cgal_extreme(const sample *s, char *extreme);
#ifdef __cplusplus
}
#endif

#endif
