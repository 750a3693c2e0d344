// Voro++: volumes, faces with their areas, and neighbours of all Voronoi cells in the unit cube. See use.h.
#include <cmath>
#include <vector>

#include <voro++/voro++.hh>

#include "use.h"

static void build(use *) {}

// Grid cells with about five points each, as Voro++'s manual recommends.
static void voronoi(use *u) {
    int side = (int)std::ceil(std::cbrt((double)u->points.count / 5));
    std::vector<int> neighbors;
    std::vector<double> areas;
    double volume = 0;
    uint64_t faces = 0;
    use_start(u);
    voro::container box(0, 1, 0, 1, 0, 1, side, side, side, false, false, false, 8);
    for (size_t i = 0; i < u->points.count; i++) {
        const double *x = u->points.coordinates + 3 * i;
        box.put((int)i, x[0], x[1], x[2]);
    }
    voro::c_loop_all loop(box);
    voro::voronoicell_neighbor cell;
    if (loop.start())
        do {
            if (!box.compute_cell(cell, loop))
                continue;
            volume += cell.volume();
            cell.neighbors(neighbors);
            cell.face_areas(areas);
            faces += neighbors.size();
        } while (loop.inc());
    use_stop(u);
    fprintf(stderr, "Voro++: volume 1 %+.3g, %" PRIu64 " faces of cells\n", volume - 1, faces);
}

int main(int argc, char **argv) {
    const use_operation operations[] = {{"voronoi", voronoi}};
    return use_main(argc, argv, build, operations, 1);
}
