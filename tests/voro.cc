// Voro++ as an oracle: see voro.h.
#include "voro.h"

#include <cmath>
#include <vector>

#include <voro++/voro++.hh>

static void measure(voro::voronoicell_neighbor &cell, const double *point, double least, voro_cell *out) {
    std::vector<int> neighbors;
    std::vector<double> areas;
    out->volume = cell.volume();
    out->area = cell.surface_area();
    cell.centroid(out->centroid[0], out->centroid[1], out->centroid[2]);
    for (int k = 0; k < 3; k++)
        out->centroid[k] += point[k];
    cell.neighbors(neighbors);
    cell.face_areas(areas);
    for (std::size_t i = 0; i < neighbors.size(); i++)
        if (areas[i] > least) {
            out->faces++;
            out->neighbors += neighbors[i] < 0 ? 0 : 1 + neighbors[i];
        }
}

template <class Container>
static void run(Container &container, const double *points, double least, voro_cell *cells) {
    voro::c_loop_all loop(container);
    voro::voronoicell_neighbor cell;
    if (loop.start())
        do {
            if (container.compute_cell(cell, loop))
                measure(cell, points + 3 * loop.pid(), least, &cells[loop.pid()]);
        } while (loop.inc());
}

void voro_cells(const double *points, const double *weights, size_t count, const double *box, double least,
                voro_cell *cells) {
    const int n = (int)std::ceil(std::cbrt((double)count / 5));
    for (size_t i = 0; i < count; i++)
        cells[i] = voro_cell();
    if (weights) {
        voro::container_poly container(box[0], box[3], box[1], box[4], box[2], box[5], n, n, n, false, false, false, 8);
        for (size_t i = 0; i < count; i++)
            container.put((int)i, points[3 * i], points[3 * i + 1], points[3 * i + 2], std::sqrt(weights[i]));
        run(container, points, least, cells);
    } else {
        voro::container container(box[0], box[3], box[1], box[4], box[2], box[5], n, n, n, false, false, false, 8);
        for (size_t i = 0; i < count; i++)
            container.put((int)i, points[3 * i], points[3 * i + 1], points[3 * i + 2]);
        run(container, points, least, cells);
    }
}
