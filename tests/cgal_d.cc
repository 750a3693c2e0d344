// CGAL's triangulations of any dimension.
#include "cgal.h"

#include <CGAL/Delaunay_triangulation.h>
#include <CGAL/Epick_d.h>
#include <CGAL/Regular_triangulation.h>
#include <CGAL/Regular_triangulation_traits_adapter.h>
#include <vector>

namespace {

typedef CGAL::Epick_d<CGAL::Dynamic_dimension_tag> K;
typedef CGAL::Delaunay_triangulation<
    K, CGAL::Triangulation_data_structure<CGAL::Dynamic_dimension_tag, CGAL::Triangulation_vertex<K, int>,
                                          CGAL::Triangulation_full_cell<K>>>
    Delaunay;
typedef CGAL::Regular_triangulation_traits_adapter<K> W;
typedef CGAL::Regular_triangulation<
    K, CGAL::Triangulation_data_structure<CGAL::Dynamic_dimension_tag, CGAL::Triangulation_vertex<W, int>,
                                          CGAL::Triangulation_full_cell<W>>>
    Regular;

template <class T, class Place> int triangulate(const sample *s, cell_set *cells, T &t, Place place) {
    std::vector<int> leader(s->count), order(s->count);
    sample_leaders(s, leader.data(), nullptr);
    for (int i = 0; i < s->count; i++) {
        if (leader[i] != i)
            continue;
        auto v = t.insert(place(i));
        if (v != typename T::Vertex_handle())
            v->data() = i;
    }
    int k = t.current_dimension();
    for (auto c = t.finite_full_cells_begin(); k > 0 && c != t.finite_full_cells_end(); ++c) {
        int vertices[CELLS_MAX_DIM + 1];
        for (int i = 0; i <= k; i++)
            vertices[i] = c->vertex(i)->data();
        cells_add(cells, cell_make(vertices, k + 1));
    }
    if (k == 0)
        for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v)
            cells_add(cells, cell_make(&v->data(), 1));
    cells_sort(cells);
    return k;
}

} // namespace

int cgal_triangulate_d(const sample *s, cell_set *cells) {
    memset(cells, 0, sizeof *cells);
    auto point = [s](int i) { return K::Point_d(s->dim, s->x + i * s->dim, s->x + (i + 1) * s->dim); };
    if (s->w) {
        Regular t(s->dim);
        return triangulate(s, cells, t, [&](int i) { return Regular::Weighted_point(point(i), s->w[i]); });
    }
    Delaunay t(s->dim);
    return triangulate(s, cells, t, point);
}
