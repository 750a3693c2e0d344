// CGAL's Regular_triangulation_3, sequential. Exact predicates, insertion of a range.
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include "bench.h"

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Regular_triangulation_3<Kernel> Regular;

static uint64_t hash_of(const Regular &regular, const bench_points &points) {
    bench_index index = bench_index_make(&points);
    uint64_t hash = 0;
    for (auto cell : regular.finite_cell_handles()) {
        uint64_t vertices[4];
        for (int i = 0; i < 4; i++) {
            const Kernel::Weighted_point_3 &p = cell->vertex(i)->point();
            const double x[3] = {p.x(), p.y(), p.z()};
            vertices[i] = bench_index_of(&index, x);
        }
        hash += paradt_hash_cell(vertices, 4);
    }
    bench_index_free(&index);
    return hash;
}

int main(int argc, char **argv) {
    bench_arguments arguments = bench_parse(argc, argv);
    bench_points points = bench_read(arguments.path);
    if (points.dim != 3)
        bench_fail(arguments.path, "not 3 coordinates");
    std::vector<Kernel::Weighted_point_3> input;
    input.reserve(points.count);
    for (size_t i = 0; i < points.count; i++) {
        const double *x = points.coordinates + 3 * i;
        input.emplace_back(Kernel::Point_3(x[0], x[1], x[2]), points.weights ? points.weights[i] : 0);
    }
    bench_clock clock = bench_start(&points);
    Regular regular(input.begin(), input.end());
    bench_stop(&clock);
    uint64_t hash = arguments.hash ? hash_of(regular, points) : 0;
    char extra[64];
    snprintf(extra, sizeof extra, ",\"hidden\":%zu", points.count - regular.number_of_vertices());
    bench_print(&arguments, &points, &clock, regular.number_of_finite_cells(), arguments.hash ? &hash : NULL, extra);
    return 0;
}
