// CGAL's classes for the plane and for space: Delaunay_triangulation_2/3 and Regular_triangulation_2/3. The points may span a
// lower dimension.
#include "cgal.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_vertex_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<
                                              CGAL::Triangulation_vertex_base_with_info_2<int, K>>>
    Delaunay2;
typedef CGAL::Regular_triangulation_2<
    K, CGAL::Triangulation_data_structure_2<
           CGAL::Triangulation_vertex_base_with_info_2<int, K, CGAL::Regular_triangulation_vertex_base_2<K>>,
           CGAL::Regular_triangulation_face_base_2<K>>>
    Regular2;
typedef CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<
                                              CGAL::Triangulation_vertex_base_with_info_3<int, K>,
                                              CGAL::Delaunay_triangulation_cell_base_3<K>>>
    Delaunay3;
typedef CGAL::Regular_triangulation_3<
    K, CGAL::Triangulation_data_structure_3<
           CGAL::Triangulation_vertex_base_with_info_3<int, K, CGAL::Regular_triangulation_vertex_base_3<K>>,
           CGAL::Regular_triangulation_cell_base_3<K>>>
    Regular3;

K::Point_2 point2(const double *x) { return K::Point_2(x[0], x[1]); }
K::Point_3 point3(const double *x) { return K::Point_3(x[0], x[1], x[2]); }

template <class Point, class Place> std::vector<std::pair<Point, int>> distinct(const sample *s, Place place) {
    std::vector<int> leader(s->count);
    std::vector<std::pair<Point, int>> points;
    sample_leaders(s, leader.data(), nullptr);
    for (int i = 0; i < s->count; i++)
        if (leader[i] == i)
            points.emplace_back(place(i), i);
    return points;
}

void add(cell_set *cells, std::initializer_list<int> vertices) {
    cells_add(cells, cell_make(vertices.begin(), (int)vertices.size()));
}

template <class T> void vertices_alone(const T &t, cell_set *cells) {
    for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v)
        add(cells, {v->info()});
}

template <class T> int collect2(const T &t, cell_set *cells) {
    if (t.dimension() == 0)
        vertices_alone(t, cells);
    if (t.dimension() == 1)
        for (auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
            add(cells, {e->first->vertex(t.cw(e->second))->info(), e->first->vertex(t.ccw(e->second))->info()});
    if (t.dimension() == 2)
        for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
            add(cells, {f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    cells_sort(cells);
    return t.dimension();
}

template <class T> int collect3(const T &t, cell_set *cells) {
    if (t.dimension() == 0)
        vertices_alone(t, cells);
    if (t.dimension() == 1)
        for (auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
            add(cells, {e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info()});
    if (t.dimension() == 2)
        for (auto f = t.finite_facets_begin(); f != t.finite_facets_end(); ++f)
            add(cells, {f->first->vertex(t.vertex_triple_index(f->second, 0))->info(),
                        f->first->vertex(t.vertex_triple_index(f->second, 1))->info(),
                        f->first->vertex(t.vertex_triple_index(f->second, 2))->info()});
    if (t.dimension() == 3)
        for (auto c = t.finite_cells_begin(); c != t.finite_cells_end(); ++c)
            add(cells, {c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
    cells_sort(cells);
    return t.dimension();
}

} // namespace

int cgal_triangulate_2(const sample *s, cell_set *cells) {
    memset(cells, 0, sizeof *cells);
    if (s->w) {
        Regular2 t;
        auto points = distinct<K::Weighted_point_2>(
            s, [s](int i) { return K::Weighted_point_2(point2(s->x + 2 * i), s->w[i]); });
        t.insert(points.begin(), points.end());
        return collect2(t, cells);
    }
    Delaunay2 t;
    auto points = distinct<K::Point_2>(s, [s](int i) { return point2(s->x + 2 * i); });
    t.insert(points.begin(), points.end());
    return collect2(t, cells);
}

int cgal_triangulate_3(const sample *s, cell_set *cells) {
    memset(cells, 0, sizeof *cells);
    if (s->w) {
        Regular3 t;
        auto points = distinct<K::Weighted_point_3>(
            s, [s](int i) { return K::Weighted_point_3(point3(s->x + 3 * i), s->w[i]); });
        t.insert(points.begin(), points.end());
        return collect3(t, cells);
    }
    Delaunay3 t;
    auto points = distinct<K::Point_3>(s, [s](int i) { return point3(s->x + 3 * i); });
    t.insert(points.begin(), points.end());
    return collect3(t, cells);
}
