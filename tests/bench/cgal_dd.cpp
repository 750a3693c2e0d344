// CGAL in other dimensions than three: Delaunay_triangulation_2 in the plane, Delaunay_triangulation of the dD package
// in 4 to 6 dimensions. Exact predicates, insertion of a range.
#include <vector>

#include <CGAL/Delaunay_triangulation.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Epick_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "bench.h"

static void run_plane(const bench_arguments &arguments, bench_points points) {
    typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
    typedef CGAL::Delaunay_triangulation_2<Kernel> Delaunay;
    std::vector<std::vector<Kernel::Point_2>> sets(arguments.calls);
    for (size_t i = 0; i < arguments.calls; i++) {
        bench_points set = bench_set(&points, arguments.calls, i);
        sets[i].reserve(set.count);
        for (size_t j = 0; j < set.count; j++)
            sets[i].emplace_back(set.coordinates[2 * j], set.coordinates[2 * j + 1]);
    }
    bench_clock clock = bench_start(&points);
    for (size_t i = 0; i + 1 < arguments.calls; i++)
        Delaunay(sets[i].begin(), sets[i].end());
    Delaunay delaunay(sets.back().begin(), sets.back().end());
    bench_stop(&clock);
    points = bench_set(&points, arguments.calls, arguments.calls - 1);
    uint64_t hash = 0;
    if (arguments.hash) {
        bench_index index = bench_index_make(&points);
        for (auto face : delaunay.finite_face_handles()) {
            uint64_t vertices[3];
            for (int i = 0; i < 3; i++) {
                const double x[2] = {face->vertex(i)->point().x(), face->vertex(i)->point().y()};
                vertices[i] = bench_index_of(&index, x);
            }
            hash += paradt_hash_cell(vertices, 3);
        }
        bench_index_free(&index);
    }
    bench_print(&arguments, &points, &clock, delaunay.number_of_faces(), arguments.hash ? &hash : NULL, "");
}

template <int D> static void run(const bench_arguments &arguments, const bench_points &points) {
    typedef CGAL::Delaunay_triangulation<CGAL::Epick_d<CGAL::Dimension_tag<D>>> Delaunay;
    std::vector<typename Delaunay::Point> input;
    input.reserve(points.count);
    for (size_t i = 0; i < points.count; i++) {
        const double *x = points.coordinates + D * i;
        input.emplace_back(x, x + D);
    }
    bench_clock clock = bench_start(&points);
    Delaunay delaunay(D);
    delaunay.insert(input.begin(), input.end());
    bench_stop(&clock);
    uint64_t hash = 0, cells = 0;
    bench_index index = bench_index_make(&points);
    for (auto cell = delaunay.finite_full_cells_begin(); cell != delaunay.finite_full_cells_end(); ++cell) {
        cells++;
        if (!arguments.hash)
            continue;
        uint64_t vertices[D + 1];
        for (int i = 0; i <= D; i++) {
            double x[D];
            for (int k = 0; k < D; k++)
                x[k] = cell->vertex(i)->point()[k];
            vertices[i] = bench_index_of(&index, x);
        }
        hash += paradt_hash_cell(vertices, D + 1);
    }
    bench_index_free(&index);
    bench_print(&arguments, &points, &clock, cells, arguments.hash ? &hash : NULL, "");
}

int main(int argc, char **argv) {
    bench_arguments arguments = bench_parse(argc, argv);
    bench_points points = bench_read(arguments.path);
    if (points.weights)
        bench_fail(arguments.path, "has weights");
    switch (points.dim) {
    case 2:
        run_plane(arguments, points);
        break;
    case 4:
        run<4>(arguments, points);
        break;
    case 5:
        run<5>(arguments, points);
        break;
    case 6:
        run<6>(arguments, points);
        break;
    default:
        bench_fail(arguments.path, "not 2, 4, 5 or 6 coordinates");
    }
    return 0;
}
