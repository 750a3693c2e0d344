// CGAL's Delaunay_triangulation_3, used as its manual recommends: exact predicates, and insertion of a range, which
// sorts the points in space. With CGAL_LINKED_WITH_TBB: the same with the parallel tag.
#include <algorithm>
#include <optional>
#include <vector>

#include <CGAL/Bbox_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

#include "bench.h"

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

#ifdef CGAL_LINKED_WITH_TBB
typedef CGAL::Parallel_tag Concurrency;
#else
typedef CGAL::Sequential_tag Concurrency;
#endif
typedef CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
                                             CGAL::Delaunay_triangulation_cell_base_3<Kernel>, Concurrency>
    Structure;
typedef CGAL::Delaunay_triangulation_3<Kernel, Structure> Delaunay;
typedef std::vector<Kernel::Point_3> Points;

// Replaces the previous triangulation.
static void build(std::optional<Delaunay> &delaunay, const Points &points) {
#ifdef CGAL_LINKED_WITH_TBB
    const int grid = 50; // lock cells per axis, as in CGAL's own example
    const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
    Delaunay::Lock_data_structure locks(box, grid);
    delaunay.emplace(points.begin(), points.end(), &locks);
    delaunay->set_lock_data_structure(nullptr);
#else
    delaunay.emplace(points.begin(), points.end());
#endif
}

static uint64_t hash_of(const Delaunay &delaunay, const bench_points &points) {
    bench_index index = bench_index_make(&points);
    uint64_t hash = 0;
    for (auto cell : delaunay.finite_cell_handles()) {
        uint64_t vertices[4];
        for (int i = 0; i < 4; i++) {
            const Kernel::Point_3 &p = cell->vertex(i)->point();
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
    if (points.dim != 3 || points.weights)
        bench_fail(arguments.path, "not 3 coordinates without weights");
#ifdef CGAL_LINKED_WITH_TBB
    tbb::global_control threads(tbb::global_control::max_allowed_parallelism, arguments.jobs);
#endif
    std::vector<Points> sets(arguments.calls);
    for (size_t i = 0; i < arguments.calls; i++) {
        bench_points set = bench_set(&points, arguments.calls, i);
        sets[i].reserve(set.count);
        for (size_t k = 0; k < set.count; k++) {
            const double *x = set.coordinates + 3 * k;
            sets[i].emplace_back(x[0], x[1], x[2]);
        }
    }
    std::optional<Delaunay> delaunay; // of the last set; destroying the previous one is part of the time
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(size_t(0), arguments.jobs, [](size_t) { bench_warm_up(); });
#endif
    bench_clock clock = bench_start(&points);
    for (const Points &set : sets)
        build(delaunay, set);
    bench_stop(&clock);
    bench_points last = bench_set(&points, arguments.calls, arguments.calls - 1);
    uint64_t hash = arguments.hash ? hash_of(*delaunay, last) : 0;
    bench_print(&arguments, &points, &clock, delaunay->number_of_finite_cells(), arguments.hash ? &hash : NULL, "");
    return 0;
}
