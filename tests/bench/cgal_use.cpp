// CGAL's living triangulations: Delaunay_triangulation_3 with Fast_location in space, Delaunay_triangulation_2 with a
// hierarchy in the plane, Delaunay_triangulation of the dD package in 4 dimensions. See use.h.
//
// With a hint the walk starts there; without one the hierarchy finds its start. "batch" is a range: CGAL sorts it where
// it is to be inserted; queries are sorted by spatial_sort here, as its manual recommends.
#include <algorithm>
#include <memory>
#include <vector>

#include <CGAL/Delaunay_triangulation.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Epick_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/spatial_sort.h>

#include "use.h"

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

// --- one face for the three of them ----------------------------------------------------------------------------------

struct Space {
    typedef CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location> Triangulation;
    // Delaunay_triangulation_3 itself, without the hierarchy, which has no move of its own
    typedef CGAL::Delaunay_triangulation_3<Kernel, Triangulation::Triangulation_data_structure> Level;
    typedef Kernel::Point_3 Point;
    typedef Triangulation::Vertex_handle Vertex;
    typedef Triangulation::Cell_handle Cell;
    Triangulation t;
    static Point point(const double *x) { return Point(x[0], x[1], x[2]); }
    auto vertices() { return t.finite_vertex_handles(); }
    auto cells() { return t.finite_cell_handles(); }
    bool finite(Cell c) { return !t.is_infinite(c); }
    Vertex some_vertex(Cell c) { return c->vertex(t.is_infinite(c->vertex(0))); }
    Cell locate(const Point &p, Cell start) { return t.locate(p, start); }
    Vertex nearest(const Point &p, Cell start) { return t.nearest_vertex(p, start); }
    Vertex insert(const Point &p, Cell start) { return t.insert(p, start); }
    void insert(const std::vector<Point> &range) { t.insert(range.begin(), range.end()); }
    Cell cell(Vertex v) { return v->cell(); }
    void remove(Vertex v) { t.remove(v); }
    Vertex move(Vertex v, const Point &p) { return static_cast<Level &>(t).move(v, p); }
};

struct Plane {
    typedef CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>> Base;
    typedef CGAL::Triangulation_data_structure_2<Base, CGAL::Triangulation_face_base_2<Kernel>> Structure;
    typedef CGAL::Delaunay_triangulation_2<Kernel, Structure> Level;
    typedef CGAL::Triangulation_hierarchy_2<Level> Triangulation;
    typedef Kernel::Point_2 Point;
    typedef Triangulation::Vertex_handle Vertex;
    typedef Triangulation::Face_handle Cell;
    Triangulation t;
    static Point point(const double *x) { return Point(x[0], x[1]); }
    auto vertices() { return t.finite_vertex_handles(); }
    auto cells() { return t.finite_face_handles(); }
    bool finite(Cell c) { return !t.is_infinite(c); }
    Vertex some_vertex(Cell c) { return c->vertex(t.is_infinite(c->vertex(0))); }
    // The hierarchy would go down all its levels, in spite of the hint.
    Cell locate(const Point &p, Cell start) { return start == Cell() ? t.locate(p) : t.Level::locate(p, start); }
    Vertex nearest(const Point &p, Cell start) {
        return start == Cell() ? t.nearest_vertex(p) : t.Level::nearest_vertex(p, start);
    }
    Vertex insert(const Point &p, Cell start) { return start == Cell() ? t.insert(p) : t.Level::insert(p, start); }
    void insert(const std::vector<Point> &range) { t.insert(range.begin(), range.end()); }
    Cell cell(Vertex v) { return v->face(); }
    void remove(Vertex v) { t.remove(v); }
    Vertex move(Vertex v, const Point &p) { return static_cast<Level &>(t).move(v, p); }
};

struct Four {
    typedef CGAL::Delaunay_triangulation<CGAL::Epick_d<CGAL::Dimension_tag<4>>> Triangulation;
    typedef Triangulation::Point Point;
    typedef Triangulation::Vertex_handle Vertex;
    typedef Triangulation::Full_cell_handle Cell;
    Triangulation t;
    Four() : t(4) {}
    static Point point(const double *x) { return Point(x, x + 4); }
    std::vector<Vertex> vertices() {
        std::vector<Vertex> list;
        for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v)
            list.push_back(v.base());
        return list;
    }
    std::vector<Cell> cells() {
        std::vector<Cell> list;
        for (auto c = t.finite_full_cells_begin(); c != t.finite_full_cells_end(); ++c)
            list.push_back(c.base());
        return list;
    }
    bool finite(Cell c) { return !t.is_infinite(c); }
    Vertex some_vertex(Cell c) { return c->vertex(t.is_infinite(c->vertex(0))); }
    Cell locate(const Point &p, Cell start) { return t.locate(p, start); }
    Vertex insert(const Point &p, Cell start) { return t.insert(p, start); }
    void insert(const std::vector<Point> &range) { t.insert(range.begin(), range.end()); }
    Cell cell(Vertex v) { return v->full_cell(); }
    void remove(Vertex v) { t.remove(v); }
};

// --- the operations --------------------------------------------------------------------------------------------------

template <class T> struct Uses {
    typedef typename T::Point Point;
    typedef typename T::Vertex Vertex;
    typedef typename T::Cell Cell;
    static std::unique_ptr<T> held;
    static std::vector<Vertex> vertex_of; // a point's vertex

    static void build(use *u) {
        held = std::make_unique<T>();
        std::vector<Point> points;
        for (size_t i = 0; i < u->points.count; i++)
            points.push_back(T::point(u->points.coordinates + i * (size_t)u->points.dim));
        held->insert(points);
        vertex_of.assign(u->points.count, Vertex());
        bench_index index = bench_index_make(&u->points);
        for (Vertex v : held->vertices()) {
            double x[PARADT_MAX_DIM];
            coordinates(u, v, x);
            vertex_of[bench_index_of(&index, x)] = v;
        }
        bench_index_free(&index);
    }

    static void coordinates(const use *u, Vertex v, double *x) {
        for (int k = 0; k < u->points.dim; k++)
            x[k] = v->point()[k];
    }

    static void check(use *u, Cell c) {
        double x[PARADT_MAX_DIM + 1][PARADT_MAX_DIM];
        const double *vertices[PARADT_MAX_DIM + 1];
        if (!held->finite(c))
            return;
        for (int i = 0; i <= u->points.dim; i++) {
            coordinates(u, c->vertex(i), x[i]);
            vertices[i] = x[i];
        }
        use_check_cell(u, vertices, u->points.dim + 1);
    }

    static std::vector<Point> places(const use *u) {
        std::vector<Point> list;
        for (size_t i = 0; i < u->count; i++)
            list.push_back(T::point(use_place(u, i)));
        return list;
    }

    static std::vector<Point> queries(use *u, size_t *cursor, bool sorted) {
        use_queries(u, cursor);
        if (sorted)
            use_sort(u);
        return places(u);
    }

    static void locate(use *u, bool sorted, bool batch) {
        std::vector<Point> list = queries(u, &u->asked, sorted);
        std::vector<Cell> found;
        found.reserve(u->count);
        use_start(u);
        if (batch)
            sort(list);
        Cell start;
        for (const Point &p : list) {
            found.push_back(held->locate(p, start));
            if (sorted || batch)
                start = found.back();
        }
        use_stop(u);
        for (Cell c : found)
            check(u, c);
    }
    static void locate_sorted(use *u) { locate(u, true, false); }
    static void locate_batch(use *u) { locate(u, false, true); }
    static void locate_random(use *u) { locate(u, false, false); }

    static void nearest(use *u, bool sorted, bool batch) {
        std::vector<Point> list = queries(u, &u->asked, sorted);
        std::vector<Vertex> found;
        found.reserve(u->count);
        use_start(u);
        if (batch)
            sort(list);
        Cell start;
        for (const Point &p : list) {
            found.push_back(held->nearest(p, start));
            if (sorted || batch)
                start = held->cell(found.back());
        }
        use_stop(u);
        for (Vertex v : found) {
            double x[PARADT_MAX_DIM];
            const double *vertices[1] = {x};
            coordinates(u, v, x);
            use_check_cell(u, vertices, 1);
        }
    }
    static void nearest_sorted(use *u) { nearest(u, true, false); }
    static void nearest_batch(use *u) { nearest(u, false, true); }
    static void nearest_random(use *u) { nearest(u, false, false); }

    static void insert(use *u, bool sorted) {
        std::vector<Point> list = queries(u, &u->inserted, sorted);
        Cell start;
        use_start(u);
        for (const Point &p : list) {
            Vertex v = held->insert(p, start);
            if (sorted)
                start = held->cell(v);
        }
        use_stop(u);
    }
    static void insert_sorted(use *u) { insert(u, true); }
    static void insert_random(use *u) { insert(u, false); }
    static void insert_batch(use *u) {
        std::vector<Point> list = queries(u, &u->inserted, false);
        use_start(u);
        held->insert(list);
        use_stop(u);
    }

    // CGAL removes a range one by one.
    static void remove(use *u) {
        use_removals(u);
        use_start(u);
        for (size_t i = 0; i < u->count; i++)
            held->remove(vertex_of[u->which[i]]);
        use_stop(u);
    }

    static void move(use *u) {
        use_moves(u);
        std::vector<Point> list = places(u);
        use_start(u);
        for (size_t i = 0; i < u->count; i++)
            vertex_of[u->which[i]] = held->move(vertex_of[u->which[i]], list[i]);
        use_stop(u);
    }

    // Builds a second triangulation.
    static void triangulate(use *u) {
        std::vector<Point> points;
        for (size_t i = 0; i < u->points.count; i++)
            points.push_back(T::point(u->points.coordinates + i * (size_t)u->points.dim));
        T second;
        use_start(u);
        second.insert(points);
        use_stop(u);
    }

    static void cells(use *u) {
        for (Cell c : held->cells())
            check(u, c);
    }

    static void sort(std::vector<Point> &list) { CGAL::spatial_sort(list.begin(), list.end()); }
};
template <class T> std::unique_ptr<T> Uses<T>::held;
template <class T> std::vector<typename T::Vertex> Uses<T>::vertex_of;

template <class T> static int run(int argc, char **argv) {
    typedef Uses<T> U;
    const use_operation operations[] = {
        {"locate-sorted", U::locate_sorted},   {"locate-batch", U::locate_batch},
        {"locate-random", U::locate_random},   {"nearest-sorted", U::nearest_sorted},
        {"nearest-batch", U::nearest_batch},   {"nearest-random", U::nearest_random},
        {"insert-sorted", U::insert_sorted},   {"insert-batch", U::insert_batch},
        {"insert-random", U::insert_random},   {"remove-random", U::remove},
        {"remove-batch", U::remove},           {"move-random", U::move},
        {"move-batch", U::move},               {"triangulate", U::triangulate},
        {"cells", U::cells},
    };
    return use_main(argc, argv, U::build, operations, sizeof operations / sizeof *operations);
}

// The dD package has neither nearest vertices nor moves, and its points can't be sorted by spatial_sort.
static int run_four(int argc, char **argv) {
    typedef Uses<Four> U;
    const use_operation operations[] = {
        {"locate-sorted", U::locate_sorted}, {"locate-random", U::locate_random}, {"insert-sorted", U::insert_sorted},
        {"insert-batch", U::insert_batch},   {"insert-random", U::insert_random}, {"remove-random", U::remove},
        {"remove-batch", U::remove},         {"triangulate", U::triangulate},     {"cells", U::cells},
    };
    return use_main(argc, argv, U::build, operations, sizeof operations / sizeof *operations);
}

int main(int argc, char **argv) {
    bench_points points = bench_read(argc > 2 ? argv[2] : "");
    switch (points.dim) {
    case 2:
        return run<Plane>(argc, argv);
    case 3:
        return run<Space>(argc, argv);
    case 4:
        return run_four(argc, argv);
    default:
        bench_fail(argv[2], "not 2, 3 or 4 coordinates");
    }
    return 1;
}
