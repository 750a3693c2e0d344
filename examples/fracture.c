// A block breaks where it is hit: the Voronoi cells of points around the blow, clipped to the block, are closed convex
// pieces that fit together exactly. Writes fracture.obj, an object a piece, and fracture.svg, the pieces pulled apart.
//
//     cc -O2 -o fracture examples/fracture.c -lm && ./fracture
#define PARADT_IMPLEMENTATION
#include "../paradt.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { PIECES = 60 };

static const double towards[3] = {0.55, -0.7, 0.46}, right[3] = {0.79, 0.62, 0}, up[3] = {-0.28, 0.36, 0.89}; // of a viewer
static double sites[PIECES][3];
static double chance(void) { return rand() / (RAND_MAX + 1.0); }

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static int by_depth(const void *a, const void *b) { // Voronoi cells hide each other in the order of their points
    double x = dot(sites[*(const size_t *)a], towards), y = dot(sites[*(const size_t *)b], towards);
    return (x > y) - (x < y);
}

// Writes one face of a piece. The face looks away from its first side, so it is turned for a piece on the second.
static void put_face(const paradt_voronoi *v, size_t face, size_t piece, FILE *obj, FILE *svg) {
    const size_t first = v->first_vertex[face], n = v->first_vertex[face + 1] - first;
    const int turned = v->sides[2 * face] != (paradt_index)piece;
    const double *normal = v->normals + 3 * face, way = turned ? -1 : 1;
    const int seen = way * dot(normal, towards) > 0;
    fprintf(obj, "f");
    if (seen)
        fprintf(svg, "<path fill='hsl(30,25%%,%.0f%%)' d='M", 45 + 40 * way * (0.3 * normal[0] + 0.8 * normal[2]));
    for (size_t i = 0; i < n; i++) {
        const size_t vertex = (size_t)v->polygons[turned ? first + n - 1 - i : first + i];
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = v->vertices[3 * vertex + (size_t)k] + 0.3 * (sites[piece][k] - 0.5);
        fprintf(obj, " %zu", vertex + 1);
        if (seen)
            fprintf(svg, "%.1f %.1f ", 60 + 200 * dot(x, right), 300 - 200 * dot(x, up));
    }
    fprintf(obj, "\n");
    if (seen)
        fprintf(svg, "Z'/>\n");
}

int main(void) {
    static const double box[6] = {0, 0, 0, 1, 1, 1}, blow[3] = {0.9, 0.1, 0.9};
    const paradt_points points = paradt_points_f64(sites[0], PIECES, 3);
    const paradt_voronoi_request want = {PARADT_VORONOI_VOLUMES | PARADT_VORONOI_FACES | PARADT_VORONOI_NORMALS |
                                             PARADT_VORONOI_POLYGONS, box, NULL, 0};
    paradt_triangulation t;
    paradt_voronoi v;
    size_t order[PIECES];
    FILE *obj = fopen("fracture.obj", "w"), *svg = fopen("fracture.svg", "w");
    for (size_t i = 0; i < PIECES; i++) { // the denser, the nearer to the blow
        double near = pow(chance(), 2);
        order[i] = i;
        for (int k = 0; k < 3; k++)
            sites[i][k] = near * chance() + (1 - near) * (0.7 * blow[k] + 0.3 * chance());
    }
    if (!obj || !svg || paradt_triangulate(&t, &points, NULL) || paradt_voronoi_compute(&v, &t, &points, &want, NULL))
        return 1;
    fprintf(svg, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 400' stroke='#432' stroke-width='.5'>\n");
    for (size_t i = 0; i < v.vertex_count; i++)
        fprintf(obj, "v %.17g %.17g %.17g\n", v.vertices[3 * i], v.vertices[3 * i + 1], v.vertices[3 * i + 2]);
    qsort(order, PIECES, sizeof *order, by_depth);
    for (size_t i = 0; i < PIECES; i++) {
        fprintf(obj, "o piece_%zu\n", order[i]);
        for (size_t k = v.first_face[order[i]]; k < v.first_face[order[i] + 1]; k++)
            put_face(&v, (size_t)v.faces[k], order[i], obj, svg);
    }
    fprintf(svg, "</svg>\n");
    printf("%d pieces, volume %.12f\n", PIECES, v.volume);
    fclose(obj);
    fclose(svg);
    paradt_voronoi_free(&v);
    paradt_free(&t);
    return 0;
}
