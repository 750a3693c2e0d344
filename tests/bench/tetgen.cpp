// TetGen 1.5, called as a library: Delaunay triangulation only, default order of insertion (BRIO and Hilbert), exact
// arithmetic.
#include <tetgen.h>

#include "bench.h"

int main(int argc, char **argv) {
    bench_arguments arguments = bench_parse(argc, argv);
    bench_points points = bench_read(arguments.path);
    if (points.dim != 3 || points.weights || points.count > INT32_MAX)
        bench_fail(arguments.path, "not 3 coordinates without weights");
    tetgenio in, out;
    in.firstnumber = 0;
    in.numberofpoints = (int)points.count;
    in.pointlist = new double[3 * points.count];
    memcpy(in.pointlist, points.coordinates, 3 * points.count * sizeof(double));
    // Q: print nothing; N, F, B: return the cells only.
    char switches[] = "QNFB";
    bench_clock clock = bench_start(&points);
    try {
        tetrahedralize(switches, &in, &out);
    } catch (int error) {
        bench_fail("TetGen", error == 1 ? "out of memory" : "failed");
    }
    bench_stop(&clock);
    uint64_t hash = 0;
    if (arguments.hash) {
        bench_index index = bench_index_make(&points);
        for (int c = 0; c < out.numberoftetrahedra; c++) {
            uint64_t vertices[4];
            for (int i = 0; i < 4; i++)
                vertices[i] = bench_index_of(&index, points.coordinates + 3 * (size_t)out.tetrahedronlist[4 * c + i]);
            hash += paradt_hash_cell(vertices, 4);
        }
        bench_index_free(&index);
    }
    bench_print(&arguments, &points, &clock, (uint64_t)out.numberoftetrahedra, arguments.hash ? &hash : NULL, "");
    return 0;
}
