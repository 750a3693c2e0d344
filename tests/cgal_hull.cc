// CGAL's convex hulls in the plane and in space: their extreme points
#include "cgal.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <map>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;

// Marks the points of the hull by their leaders.
template <class Point> static void mark(const std::map<Point, int> &index, const Point &point, char *extreme) {
    extreme[index.at(point)] = 1;
}

void cgal_extreme(const sample *s, char *extreme) {
    std::vector<int> leader(s->count);
    sample_leaders(s, leader.data(), nullptr);
    if (s->dim == 2) {
        std::map<K::Point_2, int> index;
        std::vector<K::Point_2> points, hull;
        for (int i = 0; i < s->count; i++) {
            points.emplace_back(s->x[2 * i], s->x[2 * i + 1]);
            index[points.back()] = leader[i];
        }
        CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
        for (const auto &point : hull)
            mark(index, point, extreme);
    } else {
        std::map<K::Point_3, int> index;
        std::vector<K::Point_3> points;
        CGAL::Surface_mesh<K::Point_3> hull;
        for (int i = 0; i < s->count; i++) {
            points.emplace_back(s->x[3 * i], s->x[3 * i + 1], s->x[3 * i + 2]);
            index[points.back()] = leader[i];
        }
        CGAL::convex_hull_3(points.begin(), points.end(), hull);
        for (auto v : hull.vertices())
            mark(index, hull.point(v), extreme);
    }
}
