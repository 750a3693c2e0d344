// paradt_picture.h - draws a triangulation, or a Voronoi diagram, in two or three dimensions as an SVG or PNG picture
//
// In one file: #define PARADT_PICTURE_IMPLEMENTATION, then #include "paradt_picture.h". Needs C99, and sqrt and log of
// libm.
//
// Triangles are drawn flat. A large set of tetrahedra is cut open: a plane through the centre of the points hides those
// in front of it, so that the picture shows the inside. A small set is drawn whole, with its cells pulled apart. The
// colour shows the size of a cell: small cells are bright, large ones dark.
//
// Voronoi cells are drawn flat in the plane. In space a block of them lacks the eighth that faces the viewer; a few
// cells are drawn all, pulled apart. Unbounded cells are left out, in space those that reach far beyond the points,
// too.

#ifndef PARADT_PICTURE_H
#define PARADT_PICTURE_H

#include "../paradt.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct paradt_picture {
    unsigned char *bytes; // the file, from malloc
    size_t size;
} paradt_picture;

// Draw the triangulation. coordinates: [point_count][dim]; dim: 2 or 3. Neighbours are needed in three dimensions.
// Return 1, or 0 if there is no memory.
int paradt_picture_svg(paradt_picture *picture, const double *coordinates, int dim, const paradt_triangulation *t);
int paradt_picture_png(paradt_picture *picture, const double *coordinates, int dim, const paradt_triangulation *t);

#ifndef PARADT_NO_VORONOI
// Draw a Voronoi diagram with its vertices and polygons (PARADT_VORONOI_VOLUMES, _FACES and _POLYGONS). clipped: 1: to
// a box, which the picture shows all of. Return 1, or 0 if there is no memory.
int paradt_picture_voronoi_svg(paradt_picture *picture, const double *coordinates, const paradt_voronoi *v,
                               int clipped);
int paradt_picture_voronoi_png(paradt_picture *picture, const double *coordinates, const paradt_voronoi *v,
                               int clipped);

// Chains the edges of a cell of a Voronoi diagram in the plane. outline: receives the cell's vertices,
// counterclockwise; room for one a face of the cell. Returns their number; 0: the cell is empty or unbounded; -1: there
// is no memory.
long paradt_picture_outline(const paradt_voronoi *v, size_t cell, paradt_index *outline);
#endif

#ifdef __cplusplus
}
#endif

#endif // PARADT_PICTURE_H

#ifdef PARADT_PICTURE_IMPLEMENTATION
#ifndef PARADT_PICTURE_IMPLEMENTATION_DONE
#define PARADT_PICTURE_IMPLEMENTATION_DONE

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------------------------------
// >>drawing: the faces to draw, in pixels, from back to front

enum { PARADT_PICTURE__WIDTH = 1200, PARADT_PICTURE__HEIGHT = 1000, PARADT_PICTURE__MARGIN = 40 };

typedef struct paradt_picture__face {
    size_t first; // number of its first corner
    int corners;  // 1: a point, 2: a segment, more: a convex polygon
    float depth;  // mean z
    unsigned char rgb[3];
} paradt_picture__face;

typedef struct paradt_picture__drawing {
    paradt_picture__face *faces;
    size_t count, capacity;
    float (*corners)[3]; // x, y, z; z grows away from the viewer
    size_t corner_count, corner_capacity;
} paradt_picture__drawing;

// Directions in the object's axes. The viewer's axes point right, down and away. The object's z axis points up, and the
// viewer stands in front of the object, to the left and above.
static const float paradt_picture__view[3][3] = {
    {0.8660254f, 0.5f, 0.0f}, {0.1710101f, -0.2961981f, -0.9396926f}, {-0.4698463f, 0.8137977f, -0.3420201f}};
static const float paradt_picture__light[3] = {-0.45f, -0.65f, 0.6123f}; // towards the light

static float paradt_picture__dot(const float *a, const float *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Computes the colour of a cell by its place, from 0 to 1, between the smallest and the largest. light: brightness of
// the face. The steps, from small to large cells, look about equally far apart.
static void paradt_picture__colour(float place, float light, unsigned char *rgb) {
    static const float steps[][3] = {{255, 244, 214}, {255, 209, 120}, {247, 153, 84}, {221, 98, 96},
                                     {166, 76, 132},  {112, 76, 154},  {80, 82, 156}};
    const int last = (int)(sizeof steps / sizeof *steps) - 1;
    float at = place * (float)last;
    int i, k;
    at = at < 0 ? 0 : at > (float)last ? (float)last : at;
    i = at < (float)last ? (int)at : last - 1;
    for (k = 0; k < 3; k++) {
        float shade = (steps[i][k] + (steps[i + 1][k] - steps[i][k]) * (at - (float)i)) * light;
        rgb[k] = (unsigned char)(shade < 0 ? 0 : shade > 255 ? 255 : shade);
    }
}

// Returns the place of a size in a range.
static float paradt_picture__place_in(float size, float least, float largest) {
    return largest - least > 1e-3f ? (size - least) / (largest - least) : 0.5f;
}

// Returns the brightness of a polygon; a number below 0 if it faces away from the viewer. p: corners in the object's
// axes; solid: the polygon bounds a cell, so only its outer side is seen
static float paradt_picture__brightness(float (*p)[3], int corners, int solid) {
    float n[3] = {0, 0, 0}, length, towards, lit;
    int i, k;
    for (i = 1; i + 1 < corners; i++) {
        float u[3], v[3];
        for (k = 0; k < 3; k++) {
            u[k] = p[i][k] - p[0][k];
            v[k] = p[i + 1][k] - p[0][k];
        }
        n[0] += u[1] * v[2] - u[2] * v[1];
        n[1] += u[2] * v[0] - u[0] * v[2];
        n[2] += u[0] * v[1] - u[1] * v[0];
    }
    length = (float)sqrt((double)paradt_picture__dot(n, n));
    if (!(length > 0))
        return solid ? -1.0f : 1.0f;
    towards = -paradt_picture__dot(n, paradt_picture__view[2]) / length;
    if (solid && towards <= 0)
        return -1;
    lit = paradt_picture__dot(n, paradt_picture__light) / length;
    if (towards < 0)
        lit = -lit;
    return 0.68f + 0.34f * lit;
}

// Makes room for a face. Returns 0 if there is no memory.
static int paradt_picture__reserve(paradt_picture__drawing *d, size_t corners) {
    if (d->count == d->capacity) {
        size_t capacity = d->capacity ? 2 * d->capacity : 1024;
        paradt_picture__face *faces = (paradt_picture__face *)realloc(d->faces, capacity * sizeof *faces);
        if (!faces)
            return 0;
        d->faces = faces;
        d->capacity = capacity;
    }
    if (corners > d->corner_capacity - d->corner_count) {
        size_t capacity = 2 * d->corner_capacity + corners + 1024;
        float(*larger)[3] = (float(*)[3])realloc(d->corners, capacity * sizeof *larger);
        if (!larger)
            return 0;
        d->corners = larger;
        d->corner_capacity = capacity;
    }
    return 1;
}

// Adds a face. p: its corners in the object's axes; dim: 2: seen from above, as it lies. Returns 0 if there is no
// memory.
static int paradt_picture__push(paradt_picture__drawing *d, float (*p)[3], int corners, int dim,
                                const unsigned char *rgb) {
    paradt_picture__face *face;
    int i;
    if (!paradt_picture__reserve(d, (size_t)corners))
        return 0;
    face = &d->faces[d->count++];
    face->first = d->corner_count;
    face->corners = corners;
    face->depth = 0;
    memcpy(face->rgb, rgb, 3);
    for (i = 0; i < corners; i++) {
        float *at = d->corners[d->corner_count++];
        at[0] = dim == 3 ? paradt_picture__dot(p[i], paradt_picture__view[0]) : p[i][0];
        at[1] = dim == 3 ? paradt_picture__dot(p[i], paradt_picture__view[1]) : -p[i][1];
        at[2] = dim == 3 ? paradt_picture__dot(p[i], paradt_picture__view[2]) : p[i][2];
        face->depth += at[2] / (float)corners;
    }
    return 1;
}

// Finds the least and the largest x and y of the corners.
static void paradt_picture__bounds(const paradt_picture__drawing *d, float *low, float *high) {
    size_t i;
    int k;
    for (k = 0; k < 2; k++)
        for (low[k] = high[k] = 0, i = 0; i < d->corner_count; i++) {
            const float x = d->corners[i][k];
            if (i == 0 || x < low[k])
                low[k] = x;
            if (i == 0 || x > high[k])
                high[k] = x;
        }
}

// Moves and scales the faces so that what lies between the bounds fills the picture.
static void paradt_picture__fit(paradt_picture__drawing *d, const float *low, const float *high) {
    float across = (float)(PARADT_PICTURE__WIDTH - 2 * PARADT_PICTURE__MARGIN) / (high[0] - low[0] + 1e-6f);
    float down = (float)(PARADT_PICTURE__HEIGHT - 2 * PARADT_PICTURE__MARGIN) / (high[1] - low[1] + 1e-6f);
    float scale = across < down ? across : down;
    size_t i;
    for (i = 0; i < d->corner_count; i++) {
        d->corners[i][0] = (d->corners[i][0] - (low[0] + high[0]) / 2) * scale + PARADT_PICTURE__WIDTH / 2;
        d->corners[i][1] = (d->corners[i][1] - (low[1] + high[1]) / 2) * scale + PARADT_PICTURE__HEIGHT / 2;
    }
}

static int paradt_picture__compare_depths(const void *a, const void *b) {
    const float x = ((const paradt_picture__face *)a)->depth, y = ((const paradt_picture__face *)b)->depth;
    return (x < y) - (x > y);
}

static void paradt_picture__sort(paradt_picture__drawing *d) {
    if (d->count)
        qsort(d->faces, d->count, sizeof *d->faces, paradt_picture__compare_depths);
}

static void paradt_picture__free(paradt_picture__drawing *d) {
    free(d->faces);
    free(d->corners);
    memset(d, 0, sizeof *d);
}

static int paradt_picture__compare_sizes(const void *a, const void *b) {
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

// Sorts a sample of sizes, and finds the range of its middle nine tenths.
static void paradt_picture__range(float *sample, size_t n, float *least, float *largest) {
    if (!n)
        return;
    qsort(sample, n, sizeof *sample, paradt_picture__compare_sizes);
    *least = sample[n / 20];
    *largest = sample[n - 1 - n / 20];
}

// ---------------------------------------------------------------------------------------------------------------------
// >>scene: the cells of a triangulation that are seen

enum { PARADT_PICTURE__FEW = 150 }; // up to this number, tetrahedra are pulled apart instead of cut open

typedef struct paradt_picture__scene {
    const paradt_triangulation *t;
    int dim;
    float *points;        // [point_count][3], moved and scaled into the unit ball, with the centre at 0
    float *sizes;         // [cell_count] log of the longest edge
    unsigned char *shown; // [cell_count] 1: drawn, 0: cut off
    float least;          // size of the brightest cells
    float largest;        // size of the darkest cells
    float shrink;         // size at which cells are drawn; below 1 they are pulled apart, too
    paradt_picture__drawing drawing;
} paradt_picture__scene;

static const float paradt_picture__cut[3] = {-0.25f, -0.93f, 0.27f}; // normal of the cut, towards what is cut off

// Finds the middle of the points and returns their largest distance from it along an axis, both for halved coordinates:
// differences of coordinates up to 1.7e308 would overflow. Dividing by the result lets subnormals survive.
static double paradt_picture__extent(const double *coordinates, size_t count, int dim, double *middle) {
    double extent = 0;
    size_t i;
    int k;
    for (k = 0; k < dim; k++) {
        double low = 0, high = 0, sum = 0;
        for (i = 0; i < count; i++) {
            double x = coordinates[i * (size_t)dim + (size_t)k] / 2;
            if (!i || x < low)
                low = x;
            if (!i || x > high)
                high = x;
            sum += x / (double)count;
        }
        middle[k] = dim == 3 ? sum : low / 2 + high / 2;
        if (high - middle[k] > extent)
            extent = high - middle[k];
        if (middle[k] - low > extent)
            extent = middle[k] - low;
    }
    return extent;
}

// Moves and scales the points into the unit ball. Returns 0 if there is no memory.
static int paradt_picture__place(paradt_picture__scene *s, const double *coordinates) {
    size_t i, count = s->t->point_count;
    double middle[3] = {0, 0, 0}, extent = paradt_picture__extent(coordinates, count, s->dim, middle), reach = 0;
    int k;
    s->points = (float *)malloc((count + 1) * 3 * sizeof *s->points);
    if (!s->points)
        return 0;
    for (i = 0; i < count; i++) {
        float *p = s->points + 3 * i;
        for (k = 0; k < 3; k++)
            p[k] = k < s->dim && extent > 0
                       ? (float)((coordinates[i * (size_t)s->dim + (size_t)k] / 2 - middle[k]) / extent)
                       : 0;
        if (paradt_picture__dot(p, p) > reach)
            reach = paradt_picture__dot(p, p);
    }
    reach = reach > 0 ? sqrt(reach) : 1;
    for (i = 0; i < 3 * count; i++)
        s->points[i] = (float)(s->points[i] / reach);
    return 1;
}

// Measures the cells. Returns 0 if there is no memory.
static int paradt_picture__measure(paradt_picture__scene *s) {
    size_t corners = (size_t)(s->t->dim + 1), cells = s->t->cell_count, c, i, j, n = 0, step = cells / 5000 + 1;
    float *sample;
    s->sizes = (float *)malloc((cells + 1) * sizeof *s->sizes);
    sample = (float *)malloc((cells / step + 2) * sizeof *sample);
    for (c = 0; s->sizes && sample && c < cells; c++) {
        const paradt_index *cell = s->t->cells + c * corners;
        float longest = 1e-30f, edge[3];
        int k;
        for (i = 0; i < corners; i++)
            for (j = 0; j < i; j++) {
                for (k = 0; k < 3; k++)
                    edge[k] = s->points[3 * (size_t)cell[i] + (size_t)k] - s->points[3 * (size_t)cell[j] + (size_t)k];
                if (paradt_picture__dot(edge, edge) > longest)
                    longest = paradt_picture__dot(edge, edge);
            }
        s->sizes[c] = (float)log((double)longest) / 2;
        if (c % step == 0)
            sample[n++] = s->sizes[c];
    }
    if (sample)
        paradt_picture__range(sample, n, &s->least, &s->largest);
    free(sample);
    return s->sizes && sample;
}

static void paradt_picture__centre(const paradt_picture__scene *s, const paradt_index *cell, float *centre) {
    size_t corners = (size_t)(s->t->dim + 1), i;
    int k;
    for (k = 0; k < 3; k++)
        for (centre[k] = 0, i = 0; i < corners; i++)
            centre[k] += s->points[3 * (size_t)cell[i] + (size_t)k] / (float)corners;
}

// Is the cell behind the cut? Its centre has to be behind the plane, and its corners, so that flat cells of the hull
// don't stick out, at least not far in front of the plane.
static int paradt_picture__behind(const paradt_picture__scene *s, const paradt_index *cell) {
    float centre[3];
    int i;
    paradt_picture__centre(s, cell, centre);
    if (paradt_picture__dot(centre, paradt_picture__cut) > 0)
        return 0;
    for (i = 0; i <= s->t->dim; i++)
        if (paradt_picture__dot(s->points + 3 * (size_t)cell[i], paradt_picture__cut) > 0.2f)
            return 0;
    return 1;
}

// Chooses the cells to draw. Returns 0 if there is no memory.
static int paradt_picture__choose(paradt_picture__scene *s) {
    size_t corners = (size_t)(s->t->dim + 1), c;
    s->shown = (unsigned char *)malloc(s->t->cell_count + 1);
    if (!s->shown)
        return 0;
    s->shrink = s->t->dim == 3 && s->t->cell_count <= PARADT_PICTURE__FEW ? 0.85f : 1.0f;
    for (c = 0; c < s->t->cell_count; c++)
        s->shown[c] = s->t->dim < 3 || s->shrink < 1 || paradt_picture__behind(s, s->t->cells + c * corners);
    return 1;
}

// Adds a face of the cell to the drawing, unless the face can't be seen. Returns 0 if there is no memory.
static int paradt_picture__add(paradt_picture__scene *s, size_t cell, const paradt_index *vertices, int corners,
                               int solid) {
    float p[3][3], centre[3], light = 1;
    unsigned char rgb[3];
    int i, k;
    paradt_picture__centre(s, s->t->cells + cell * (size_t)(s->t->dim + 1), centre);
    for (i = 0; i < corners; i++)
        for (k = 0; k < 3; k++) {
            float at = s->points[3 * (size_t)vertices[i] + (size_t)k];
            p[i][k] = s->shrink < 1 ? centre[k] * 1.3f + (at - centre[k]) * s->shrink : at;
        }
    if (corners == 3 && s->dim == 3)
        light = paradt_picture__brightness(p, 3, solid);
    if (light < 0)
        return 1;
    paradt_picture__colour(paradt_picture__place_in(s->sizes[cell], s->least, s->largest), light, rgb);
    return paradt_picture__push(&s->drawing, p, corners, s->dim, rgb);
}

// Collects the faces: of tetrahedra the facets, turned outward, that separate shown cells from the outside or from
// cells that are cut off; otherwise the cells themselves. Returns 0 if there is no memory.
static int paradt_picture__collect(paradt_picture__scene *s) {
    size_t corners = (size_t)(s->t->dim + 1), c, i;
    for (c = 0; c < s->t->cell_count; c++) {
        const paradt_index *cell = s->t->cells + c * corners;
        if (corners < 4 && !paradt_picture__add(s, c, cell, (int)corners, 0))
            return 0;
        for (i = 0; corners == 4 && s->shown[c] && i < 4; i++) {
            static const int outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
            const paradt_index beyond = s->t->neighbors[c * 4 + i]; // a half-facet
            paradt_index face[3];
            int k;
            if (s->shrink == 1 && beyond >= 0 && s->shown[beyond / 4])
                continue;
            for (k = 0; k < 3; k++)
                face[k] = cell[outward[i][k]];
            if (!paradt_picture__add(s, c, face, 3, 1))
                return 0;
        }
    }
    return 1;
}

// Makes the drawing. Returns 0 if there is no memory.
static int paradt_picture__triangulation(paradt_picture__drawing *drawing, const double *coordinates, int dim,
                                         const paradt_triangulation *t) {
    paradt_picture__scene s;
    float low[2], high[2];
    int good;
    memset(&s, 0, sizeof s);
    s.t = t;
    s.dim = dim;
    good = paradt_picture__place(&s, coordinates) && paradt_picture__measure(&s) && paradt_picture__choose(&s) &&
           paradt_picture__collect(&s);
    if (good) {
        paradt_picture__bounds(&s.drawing, low, high);
        paradt_picture__fit(&s.drawing, low, high);
        paradt_picture__sort(&s.drawing);
    }
    free(s.points);
    free(s.sizes);
    free(s.shown);
    *drawing = s.drawing;
    return good;
}

#ifndef PARADT_NO_VORONOI
// ---------------------------------------------------------------------------------------------------------------------
// >>voronoi: the cells of a Voronoi diagram that are seen

enum { PARADT_PICTURE__FEW_VORONOI = 40 }; // up to this number, cells in space are pulled apart
enum { PARADT_PICTURE__DOTS = 2000 };      // up to this number, points in the plane are drawn with their cells

typedef struct paradt_picture__end {
    paradt_index vertex;
    size_t edge; // of the cell, counted from 0
} paradt_picture__end;

static int paradt_picture__compare_ends(const void *a, const void *b) {
    const paradt_picture__end *s = (const paradt_picture__end *)a, *t = (const paradt_picture__end *)b;
    return s->vertex != t->vertex ? (s->vertex > t->vertex) - (s->vertex < t->vertex)
                                  : (s->edge > t->edge) - (s->edge < t->edge);
}

// Returns the two vertices of an edge of a cell in the plane.
static const paradt_index *paradt_picture__edge(const paradt_voronoi *v, size_t cell, size_t edge) {
    return v->polygons + v->first_vertex[v->faces[v->first_face[cell] + edge]];
}

// Goes from edge to edge. ends: the ends of all edges, sorted. Returns 0 if the edges do not close.
static int paradt_picture__chain(const paradt_voronoi *v, size_t cell, size_t count, const paradt_picture__end *ends,
                                 paradt_index *outline) {
    size_t n, edge = 0;
    paradt_index at = paradt_picture__edge(v, cell, 0)[0];
    for (n = 0; n < count; n++) {
        const paradt_index *pair = paradt_picture__edge(v, cell, edge);
        size_t low = 0, high = 2 * count;
        outline[n] = at;
        at = pair[pair[0] == at];
        while (high - low > 1) {
            size_t middle = low + (high - low) / 2;
            if (ends[middle].vertex > at ||
                (ends[middle].vertex == at && low != middle && ends[middle - 1].vertex == at))
                high = middle;
            else
                low = middle;
        }
        if (ends[low].vertex != at || low + 1 == 2 * count || ends[low + 1].vertex != at)
            return 0;
        edge = ends[low].edge == edge ? ends[low + 1].edge : ends[low].edge;
    }
    return at == outline[0];
}

// Turns an outline that goes clockwise.
static void paradt_picture__turn(const paradt_voronoi *v, paradt_index *outline, size_t count) {
    const double *first = v->vertices + 2 * (size_t)outline[0];
    double area = 0;
    size_t i;
    for (i = 1; i + 1 < count; i++) {
        const double *a = v->vertices + 2 * (size_t)outline[i], *b = v->vertices + 2 * (size_t)outline[i + 1];
        area += (a[0] / 2 - first[0] / 2) * (b[1] / 2 - first[1] / 2) -
                (a[1] / 2 - first[1] / 2) * (b[0] / 2 - first[0] / 2);
    }
    for (i = 0; area < 0 && i < count / 2; i++) {
        paradt_index other = outline[i];
        outline[i] = outline[count - 1 - i];
        outline[count - 1 - i] = other;
    }
}

long paradt_picture_outline(const paradt_voronoi *v, size_t cell, paradt_index *outline) {
    size_t count = v->first_face[cell + 1] - v->first_face[cell], i;
    paradt_picture__end *ends;
    int closed;
    if (v->unbounded[cell] || count < 3)
        return 0;
    ends = (paradt_picture__end *)malloc(2 * count * sizeof *ends);
    if (!ends)
        return -1;
    for (i = 0; i < 2 * count; i++) {
        ends[i].vertex = paradt_picture__edge(v, cell, i / 2)[i % 2];
        ends[i].edge = i / 2;
    }
    qsort(ends, 2 * count, sizeof *ends, paradt_picture__compare_ends);
    closed = paradt_picture__chain(v, cell, count, ends, outline);
    free(ends);
    if (closed)
        paradt_picture__turn(v, outline, count);
    return closed ? (long)count : 0;
}

typedef struct paradt_picture__block {
    const paradt_voronoi *v;
    const double *coordinates;
    double middle[3], extent; // of what is shown; for halved coordinates
    unsigned char *shown;     // [cell_count]
    float least, largest;     // range of the sizes
    float (*corners)[3];      // room for the largest face
    paradt_index *outline;    // room for the largest outline
    int apart;                // 1: cells are pulled apart
    paradt_picture__drawing drawing;
} paradt_picture__block;

// Returns the size of a cell: of logarithms, as an edge's.
static float paradt_picture__size(const paradt_voronoi *v, size_t cell) {
    return (float)(log(v->volumes[cell] > 1e-300 ? v->volumes[cell] : 1e-300) / v->dim);
}

static void paradt_picture__scaled(const paradt_picture__block *b, const double *x, float *at) {
    int k;
    for (k = 0; k < 3; k++)
        at[k] = k < b->v->dim && b->extent > 0 ? (float)((x[k] / 2 - b->middle[k]) / b->extent) : 0;
}

// Does the cell reach beyond the box of what is shown? In space it may by a tenth; in the plane it may by what floats
// of the picture can hold, because the picture's frame cuts it.
static int paradt_picture__reaches_out(const paradt_picture__block *b, size_t cell) {
    const float reach = b->v->dim == 3 ? 1.1f : 1e6f;
    const paradt_voronoi *v = b->v;
    size_t i, j;
    int k;
    for (i = v->first_face[cell]; i < v->first_face[cell + 1]; i++) {
        size_t face = (size_t)v->faces[i];
        for (j = v->first_vertex[face]; j < v->first_vertex[face + 1]; j++) {
            float at[3];
            paradt_picture__scaled(b, v->vertices + (size_t)v->polygons[j] * (size_t)v->dim, at);
            for (k = 0; k < 3; k++)
                if (!(at[k] <= reach && at[k] >= -reach))
                    return 1;
        }
    }
    return 0;
}

// Chooses the cells to draw. Returns 0 if there is no memory.
static int paradt_picture__choose_cells(paradt_picture__block *b, int clipped) {
    const paradt_voronoi *v = b->v;
    size_t c, n = 0, step = v->cell_count / 5000 + 1;
    float *sample = (float *)malloc((v->cell_count / step + 2) * sizeof *sample), at[3];
    b->shown = (unsigned char *)malloc(v->cell_count + 1);
    if (!sample || !b->shown) {
        free(sample);
        return 0;
    }
    for (c = 0; c < v->cell_count; c++) {
        b->shown[c] = !v->unbounded[c] && v->volumes[c] > 0 && (clipped || !paradt_picture__reaches_out(b, c));
        if (b->shown[c] && c % step == 0)
            sample[n++] = paradt_picture__size(v, c);
    }
    paradt_picture__range(sample, n, &b->least, &b->largest);
    free(sample);
    b->apart = v->dim == 3 && v->cell_count <= PARADT_PICTURE__FEW_VORONOI;
    for (c = 0; v->dim == 3 && !b->apart && c < v->cell_count; c++) { // the eighth towards the viewer
        paradt_picture__scaled(b, b->coordinates + 3 * c, at);
        if (at[0] > 0 && at[1] < 0 && at[2] > 0)
            b->shown[c] = 0;
    }
    return 1;
}

// Adds the side of a face that belongs to a cell. Returns 0 if there is no memory.
static int paradt_picture__add_side(paradt_picture__block *b, size_t face, size_t cell, int turned) {
    const paradt_voronoi *v = b->v;
    size_t first = v->first_vertex[face], corners = v->first_vertex[face + 1] - first, i;
    unsigned char rgb[3];
    float centre[3], light;
    int k;
    paradt_picture__scaled(b, b->coordinates + 3 * cell, centre);
    for (i = 0; i < corners; i++) {
        paradt_index vertex = v->polygons[turned ? first + corners - 1 - i : first + i];
        if (vertex < 0)
            return 1;
        paradt_picture__scaled(b, v->vertices + 3 * (size_t)vertex, b->corners[i]);
        for (k = 0; b->apart && k < 3; k++)
            b->corners[i][k] = centre[k] * 1.3f + (b->corners[i][k] - centre[k]) * 0.85f;
    }
    light = paradt_picture__brightness(b->corners, (int)corners, 1);
    if (light < 0)
        return 1;
    paradt_picture__colour(paradt_picture__place_in(paradt_picture__size(v, cell), b->least, b->largest), light, rgb);
    return paradt_picture__push(&b->drawing, b->corners, (int)corners, 3, rgb);
}

// Adds the faces that separate shown cells from the outside or from cells that are not shown.
static int paradt_picture__add_faces(paradt_picture__block *b) {
    const paradt_voronoi *v = b->v;
    size_t face;
    int side;
    for (face = 0; face < v->face_count; face++) {
        const paradt_index *sides = v->sides + 2 * face;
        int shown[2];
        shown[0] = b->shown[sides[0]];
        shown[1] = sides[1] >= 0 && b->shown[sides[1]];
        for (side = 0; side < 2; side++)
            if (shown[side] && (b->apart || !shown[1 - side]) &&
                !paradt_picture__add_side(b, face, (size_t)sides[side], side))
                return 0;
    }
    return 1;
}

// Adds the cells in the plane, and dots for the points of a few.
static int paradt_picture__add_outlines(paradt_picture__block *b) {
    static const unsigned char dark[3] = {20, 22, 31};
    const paradt_voronoi *v = b->v;
    size_t c;
    long i, n;
    for (c = 0; c < v->cell_count; c++) {
        unsigned char rgb[3];
        if (!b->shown[c])
            continue;
        n = paradt_picture_outline(v, c, b->outline);
        for (i = 0; i < n; i++)
            paradt_picture__scaled(b, v->vertices + 2 * (size_t)b->outline[i], b->corners[i]);
        paradt_picture__colour(paradt_picture__place_in(paradt_picture__size(v, c), b->least, b->largest), 1, rgb);
        if (n < 0 || (n > 2 && !paradt_picture__push(&b->drawing, b->corners, (int)n, 2, rgb)))
            return 0;
    }
    for (c = 0; v->cell_count <= PARADT_PICTURE__DOTS && c < v->cell_count; c++) {
        if (!b->shown[c])
            continue;
        paradt_picture__scaled(b, b->coordinates + 2 * c, b->corners[0]);
        b->corners[0][2] = -1; // in front of the cells
        if (!paradt_picture__push(&b->drawing, b->corners, 1, 2, dark))
            return 0;
    }
    return 1;
}

// Makes room for the largest face or outline. Returns 0 if there is no memory.
static int paradt_picture__room(paradt_picture__block *b) {
    const paradt_voronoi *v = b->v;
    size_t most = 3, i;
    for (i = 0; i < v->face_count; i++)
        if (v->first_vertex[i + 1] - v->first_vertex[i] > most)
            most = v->first_vertex[i + 1] - v->first_vertex[i];
    for (i = 0; i < v->cell_count; i++)
        if (v->dim == 2 && v->first_face[i + 1] - v->first_face[i] > most)
            most = v->first_face[i + 1] - v->first_face[i];
    b->corners = (float(*)[3])malloc(most * sizeof *b->corners);
    b->outline = (paradt_index *)malloc(most * sizeof *b->outline);
    return b->corners && b->outline;
}

// Makes the drawing. What is clipped fills the picture; else the box of the points does, and a tenth around it. Returns
// 0 if there is no memory.
static int paradt_picture__voronoi(paradt_picture__drawing *drawing, const double *coordinates, const paradt_voronoi *v,
                                   int clipped) {
    paradt_picture__block b;
    float low[2], high[2];
    int good;
    memset(&b, 0, sizeof b);
    b.v = v;
    b.coordinates = coordinates;
    b.extent = clipped ? paradt_picture__extent(v->vertices, v->vertex_count, v->dim, b.middle)
                       : paradt_picture__extent(coordinates, v->cell_count, v->dim, b.middle);
    good = paradt_picture__room(&b) && paradt_picture__choose_cells(&b, clipped) &&
           (v->dim == 2 ? paradt_picture__add_outlines(&b) : paradt_picture__add_faces(&b));
    if (good) {
        paradt_picture__bounds(&b.drawing, low, high);
        if (v->dim == 2 && !clipped) {
            low[0] = low[1] = -1.1f;
            high[0] = high[1] = 1.1f;
        }
        paradt_picture__fit(&b.drawing, low, high);
        paradt_picture__sort(&b.drawing);
    }
    free(b.shown);
    free(b.corners);
    free(b.outline);
    *drawing = b.drawing;
    return good;
}
#endif
// ---------------------------------------------------------------------------------------------------------------------
// >>bytes: a growing file in memory

typedef struct paradt_picture__bytes {
    unsigned char *data;
    size_t size;
    size_t capacity;
    int failed; // there was no memory; `data` is incomplete
} paradt_picture__bytes;

static void paradt_picture__put(paradt_picture__bytes *out, const void *data, size_t size) {
    if (size > out->capacity - out->size) {
        size_t capacity = 2 * (out->capacity + size);
        unsigned char *larger = out->failed ? NULL : (unsigned char *)realloc(out->data, capacity);
        if (!larger) {
            out->failed = 1;
            return;
        }
        out->data = larger;
        out->capacity = capacity;
    }
    memcpy(out->data + out->size, data, size);
    out->size += size;
}

// Hands the file out. Returns 0 if there was no memory.
static int paradt_picture__finish(paradt_picture__bytes *out, paradt_picture *picture) {
    if (out->failed) {
        free(out->data);
        out->data = NULL;
        out->size = 0;
    }
    picture->bytes = out->data;
    picture->size = out->size;
    return !out->failed;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>svg

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
paradt_picture__putf(paradt_picture__bytes *out, const char *format, ...) {
    char text[400];
    int n;
    va_list arguments;
    va_start(arguments, format);
    n = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    paradt_picture__put(out, text, (size_t)n);
}

static void paradt_picture__put_face(paradt_picture__bytes *out, const paradt_picture__drawing *d,
                                     const paradt_picture__face *face) {
    float(*at)[3] = d->corners + face->first;
    const int r = face->rgb[0], g = face->rgb[1], b = face->rgb[2];
    int i;
    if (face->corners == 1) {
        paradt_picture__putf(out, "<circle fill=\"#%02x%02x%02x\" cx=\"%.1f\" cy=\"%.1f\" r=\"3\"/>\n", r, g, b,
                             (double)at[0][0], (double)at[0][1]);
        return;
    }
    if (face->corners == 2)
        paradt_picture__putf(out, "<path stroke=\"#%02x%02x%02x\" stroke-width=\"2\" d=\"", r, g, b);
    else
        paradt_picture__putf(out, "<path fill=\"#%02x%02x%02x\" d=\"", r, g, b);
    for (i = 0; i < face->corners; i++)
        paradt_picture__putf(out, "%c%.1f %.1f", i ? 'L' : 'M', (double)at[i][0], (double)at[i][1]);
    paradt_picture__putf(out, face->corners == 2 ? "\"/>\n" : "Z\"/>\n");
}

static void paradt_picture__put_svg(paradt_picture__bytes *out, const paradt_picture__drawing *d) {
    size_t i;
    paradt_picture__putf(out,
                         "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\">\n<rect width=\"%d\" "
                         "height=\"%d\" fill=\"#14161f\"/>\n<g stroke=\"#14161f\" stroke-width=\"%.2f\" "
                         "stroke-linejoin=\"round\">\n",
                         PARADT_PICTURE__WIDTH, PARADT_PICTURE__HEIGHT, PARADT_PICTURE__WIDTH, PARADT_PICTURE__HEIGHT,
                         d->count < 2000    ? 1.0
                         : d->count < 20000 ? 0.5
                                            : 0.2);
    for (i = 0; i < d->count; i++)
        paradt_picture__put_face(out, d, &d->faces[i]);
    paradt_picture__putf(out, "</g>\n</svg>\n");
}

// ---------------------------------------------------------------------------------------------------------------------
// >>raster: faces to pixels of 2 x 2 samples, with a depth buffer

enum { PARADT_PICTURE__SAMPLES = 2 }; // width and height of a pixel in samples

typedef struct paradt_picture__raster {
    int width, height;  // in samples; after paradt_picture__average, in pixels
    float *depth;       // [height][width]
    unsigned char *rgb; // [height][width][3]
} paradt_picture__raster;

// Returns twice the area of the triangle (a, b, p), positive if p is to the right of a -> b on the screen.
static float paradt_picture__side(const float *x, const float *y, int a, int b, float px, float py) {
    return (x[b] - x[a]) * (py - y[a]) - (y[b] - y[a]) * (px - x[a]);
}

// Returns the value, rounded down, within 0..bound.
static int paradt_picture__clamp(float value, int bound) {
    return value < 0 ? 0 : value > (float)bound ? bound : (int)value;
}

// Draws a triangle with dark edges. lines: their width in samples; edges: bit i: the edge opposite corner i is drawn
// dark
static void paradt_picture__triangle(paradt_picture__raster *raster, const float *x, const float *y, const float *z,
                                     const unsigned char *rgb, float lines, unsigned edges) {
    float area = paradt_picture__side(x, y, 0, 1, x[2], y[2]), high[3];
    float left = x[0], right = x[0], top = y[0], bottom = y[0];
    int i, px, py;
    if (!(area > 1e-12f || area < -1e-12f))
        return;
    for (i = 0; i < 3; i++) { // high[i]: height of corner i over the opposite edge
        int b = (i + 1) % 3, c = (i + 2) % 3;
        float dx = x[c] - x[b], dy = y[c] - y[b];
        high[i] = (float)sqrt((double)(area * area / (dx * dx + dy * dy)));
        if (x[i] < left)
            left = x[i];
        if (x[i] > right)
            right = x[i];
        if (y[i] < top)
            top = y[i];
        if (y[i] > bottom)
            bottom = y[i];
    }
    for (py = paradt_picture__clamp(top, raster->height - 1); py <= paradt_picture__clamp(bottom, raster->height - 1);
         py++)
        for (px = paradt_picture__clamp(left, raster->width - 1); px <= paradt_picture__clamp(right, raster->width - 1);
             px++) {
            float at[3], deep = 0, rim = 1e30f, dark;
            size_t pixel = (size_t)py * (size_t)raster->width + (size_t)px;
            for (i = 0; i < 3; i++) {
                at[i] = paradt_picture__side(x, y, (i + 1) % 3, (i + 2) % 3, (float)px + 0.5f, (float)py + 0.5f) / area;
                deep += at[i] * z[i];
                if (edges >> i & 1 && at[i] * high[i] < rim)
                    rim = at[i] * high[i];
            }
            if (at[0] < 0 || at[1] < 0 || at[2] < 0 || deep > raster->depth[pixel])
                continue;
            raster->depth[pixel] = deep;
            dark = rim < lines ? 0.45f : 1.0f;
            for (i = 0; i < 3; i++)
                raster->rgb[3 * pixel + (size_t)i] = (unsigned char)((float)rgb[i] * dark);
        }
}

// Returns the width of a polygon's dark edges in samples. Small and thin polygons get thinner ones: a tenth of twice
// the area over the longest edge.
static float paradt_picture__lines(float (*at)[3], int corners) {
    float twice = 0, longest = 0, thin;
    int i;
    for (i = 0; i < corners; i++) {
        const float *a = at[i], *b = at[(i + 1) % corners];
        float dx = b[0] - a[0], dy = b[1] - a[1];
        twice += (a[0] - at[0][0]) * (b[1] - at[0][1]) - (a[1] - at[0][1]) * (b[0] - at[0][0]);
        longest = dx * dx + dy * dy > longest ? dx * dx + dy * dy : longest;
    }
    twice = twice < 0 ? -twice : twice;
    thin = longest > 0 ? twice / (float)sqrt((double)longest) / 10 * PARADT_PICTURE__SAMPLES : 0;
    return thin < 1 ? thin : 1;
}

// Draws a convex polygon as triangles around its first corner.
static void paradt_picture__polygon(paradt_picture__raster *raster, float (*at)[3], int corners,
                                    const unsigned char *rgb) {
    float lines = paradt_picture__lines(at, corners);
    int i, k;
    for (i = 1; i + 1 < corners; i++) {
        const int which[3] = {0, i, i + 1};
        float x[3], y[3], z[3];
        for (k = 0; k < 3; k++) {
            x[k] = at[which[k]][0] * PARADT_PICTURE__SAMPLES;
            y[k] = at[which[k]][1] * PARADT_PICTURE__SAMPLES;
            z[k] = at[which[k]][2];
        }
        paradt_picture__triangle(raster, x, y, z, rgb, lines, 1u | (i + 2 == corners ? 2u : 0) | (i == 1 ? 4u : 0));
    }
}

// Draws a point as a square, or a segment as a bar, of two triangles.
static void paradt_picture__bar(paradt_picture__raster *raster, float (*at)[3], int corners, const unsigned char *rgb) {
    const float z[3] = {at[0][2], at[0][2], at[0][2]}, half = corners == 1 ? 6.0f : 2.0f;
    const float *a = at[0], *b = at[corners - 1];
    float dx = b[0] - a[0], dy = b[1] - a[1], length = (float)sqrt((double)(dx * dx + dy * dy));
    float x[2] = {a[0] * PARADT_PICTURE__SAMPLES, b[0] * PARADT_PICTURE__SAMPLES};
    float y[2] = {a[1] * PARADT_PICTURE__SAMPLES, b[1] * PARADT_PICTURE__SAMPLES};
    float bx[4], by[4];
    dx = length > 0 ? dx / length * half : half;
    dy = length > 0 ? dy / length * half : 0;
    bx[0] = x[0] - dx - dy, by[0] = y[0] - dy + dx;
    bx[1] = x[0] - dx + dy, by[1] = y[0] - dy - dx;
    bx[2] = x[1] + dx + dy, by[2] = y[1] + dy - dx;
    bx[3] = x[1] + dx - dy, by[3] = y[1] + dy + dx;
    paradt_picture__triangle(raster, bx, by, z, rgb, 0, 0);
    bx[1] = bx[3], by[1] = by[3];
    paradt_picture__triangle(raster, bx, by, z, rgb, 0, 0);
}

static void paradt_picture__background(paradt_picture__raster *raster) {
    size_t i, pixels = (size_t)raster->width * (size_t)raster->height;
    for (i = 0; i < pixels; i++) {
        raster->depth[i] = 1e30f;
        raster->rgb[3 * i] = 20;
        raster->rgb[3 * i + 1] = 22;
        raster->rgb[3 * i + 2] = 31;
    }
}

// Draws all faces into a new raster. Returns 0 if there is no memory.
static int paradt_picture__draw(paradt_picture__raster *raster, const paradt_picture__drawing *d) {
    size_t pixels = (size_t)raster->width * (size_t)raster->height, i;
    raster->depth = (float *)malloc(pixels * sizeof *raster->depth);
    raster->rgb = (unsigned char *)malloc(3 * pixels);
    if (!raster->depth || !raster->rgb)
        return 0;
    paradt_picture__background(raster);
    for (i = 0; i < d->count; i++) {
        const paradt_picture__face *face = &d->faces[i];
        if (face->corners > 2)
            paradt_picture__polygon(raster, d->corners + face->first, face->corners, face->rgb);
        else
            paradt_picture__bar(raster, d->corners + face->first, face->corners, face->rgb);
    }
    return 1;
}

// Replaces the samples of each pixel by their average, in place.
static void paradt_picture__average(paradt_picture__raster *raster) {
    const int n = PARADT_PICTURE__SAMPLES, width = raster->width / n, height = raster->height / n;
    int x, y, i, j, k;
    for (y = 0; y < height; y++)
        for (x = 0; x < width; x++)
            for (k = 0; k < 3; k++) {
                int sum = n * n / 2;
                for (j = 0; j < n; j++)
                    for (i = 0; i < n; i++)
                        sum += raster->rgb[((size_t)(y * n + j) * (size_t)raster->width + (size_t)(x * n + i)) * 3 +
                                           (size_t)k];
                raster->rgb[((size_t)y * (size_t)width + (size_t)x) * 3 + (size_t)k] = (unsigned char)(sum / (n * n));
            }
    raster->width = width;
    raster->height = height;
}

// ---------------------------------------------------------------------------------------------------------------------
// >>png: RFC 2083. Deflate (RFC 1951) with its fixed codes; a small hash table finds the matches.

typedef struct paradt_picture__deflate {
    paradt_picture__bytes *out;
    uint32_t bits; // bits not written yet, the first one lowest
    int held;      // number of these bits, below 8
} paradt_picture__deflate;

// Writes up to 16 bits, the lowest first.
static void paradt_picture__put_bits(paradt_picture__deflate *d, uint32_t bits, int count) {
    d->bits |= bits << d->held;
    for (d->held += count; d->held >= 8; d->held -= 8) {
        unsigned char byte = (unsigned char)(d->bits & 255);
        paradt_picture__put(d->out, &byte, 1);
        d->bits >>= 8;
    }
}

// Writes a Huffman code, whose bits are stored highest first.
static void paradt_picture__put_code(paradt_picture__deflate *d, uint32_t code, int count) {
    uint32_t turned = 0;
    int i;
    for (i = 0; i < count; i++)
        turned |= (code >> i & 1) << (count - 1 - i);
    paradt_picture__put_bits(d, turned, count);
}

// Writes a symbol of the fixed code: a byte, 256 for the end, or a length.
static void paradt_picture__put_symbol(paradt_picture__deflate *d, unsigned symbol) {
    if (symbol < 144)
        paradt_picture__put_code(d, 0x30 + symbol, 8);
    else if (symbol < 256)
        paradt_picture__put_code(d, 0x190 + symbol - 144, 9);
    else if (symbol < 280)
        paradt_picture__put_code(d, symbol - 256, 7);
    else
        paradt_picture__put_code(d, 0xc0 + symbol - 280, 8);
}

// Lengths and distances are coded alike: the code stands for the position of the leading bit and a few bits after it,
// and the remaining bits follow as extra bits. value: counted from 0; bits: number of the bits after the leading one;
// *extra: receives the number of extra bits. Returns the code.
static unsigned paradt_picture__class(unsigned value, int bits, int *extra) {
    int top = bits;
    while (value >> (top + 1))
        top++;
    *extra = value >> bits ? top - bits : 0;
    return value >> bits ? ((unsigned)(top - bits) << bits) + (value >> (top - bits)) : value;
}

// Writes a match: copies `length` bytes from `distance` bytes before.
static void paradt_picture__put_match(paradt_picture__deflate *d, unsigned length, unsigned distance) {
    int extra;
    unsigned code = paradt_picture__class(length - 3, 2, &extra);
    paradt_picture__put_symbol(d, 257 + code);
    paradt_picture__put_bits(d, (length - 3) & ((1u << extra) - 1), extra);
    code = paradt_picture__class(distance - 1, 1, &extra);
    paradt_picture__put_code(d, code, 5);
    paradt_picture__put_bits(d, (distance - 1) & ((1u << extra) - 1), extra);
}

// Appends the data as a zlib stream. Matches are at most 257 bytes long, because 258 has a code outside the scheme.
static void paradt_picture__compress(paradt_picture__bytes *out, const unsigned char *data, size_t size) {
    static const unsigned char head[2] = {0x78, 0x01};
    paradt_picture__deflate d = {out, 0, 0};
    size_t *heads = (size_t *)calloc(1 << 15, sizeof *heads), i = 0; // last place with a key, plus 1; 0: none
    uint32_t a = 1, b = 0, check;
    unsigned char tail[4];
    out->failed |= !heads;
    paradt_picture__put(out, head, 2);
    paradt_picture__put_bits(&d, 3, 3); // the last block, with fixed codes
    while (heads && i < size) {
        size_t length = 0, from = 0;
        if (i + 4 <= size) {
            uint32_t key = (uint32_t)data[i] | (uint32_t)data[i + 1] << 8 | (uint32_t)data[i + 2] << 16 |
                           (uint32_t)data[i + 3] << 24;
            size_t *slot = &heads[key * 2654435761u >> 17];
            from = *slot;
            *slot = i + 1;
            if (from && i + 1 - from <= 32768)
                while (length < 257 && i + length < size && data[from - 1 + length] == data[i + length])
                    length++;
        }
        if (length >= 4)
            paradt_picture__put_match(&d, (unsigned)length, (unsigned)(i + 1 - from));
        else {
            paradt_picture__put_symbol(&d, data[i]);
            length = 1;
        }
        for (; length; length--, i++) {
            a = (a + data[i]) % 65521;
            b = (b + a) % 65521;
        }
    }
    paradt_picture__put_symbol(&d, 256);
    paradt_picture__put_bits(&d, 0, 7);
    check = b << 16 | a;
    for (i = 0; i < 4; i++)
        tail[i] = (unsigned char)(check >> (24 - 8 * i) & 255);
    paradt_picture__put(out, tail, 4);
    free(heads);
}

static void paradt_picture__big_endian(unsigned char *bytes, uint32_t value) {
    int i;
    for (i = 0; i < 4; i++)
        bytes[i] = (unsigned char)(value >> (24 - 8 * i) & 255);
}

static void paradt_picture__put_chunk(paradt_picture__bytes *out, const char *type, const unsigned char *data,
                                      size_t size) {
    unsigned char word[4];
    size_t begin, i;
    uint32_t crc = 0xffffffffu;
    int k;
    paradt_picture__big_endian(word, (uint32_t)size);
    paradt_picture__put(out, word, 4);
    begin = out->size;
    paradt_picture__put(out, type, 4);
    paradt_picture__put(out, data, size);
    for (i = begin; !out->failed && i < out->size; i++)
        for (crc ^= out->data[i], k = 0; k < 8; k++)
            crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    paradt_picture__big_endian(word, ~crc);
    paradt_picture__put(out, word, 4);
}

// Returns the rows as PNG wants them, from malloc: the filter's number, 2, and then the differences to the row above.
// NULL if there is no memory.
static unsigned char *paradt_picture__filter(const paradt_picture__raster *raster, size_t *size) {
    size_t row = 3 * (size_t)raster->width, i, y;
    unsigned char *bytes = (unsigned char *)malloc((row + 1) * (size_t)raster->height);
    *size = (row + 1) * (size_t)raster->height;
    for (y = 0; bytes && y < (size_t)raster->height; y++) {
        bytes[y * (row + 1)] = 2;
        for (i = 0; i < row; i++)
            bytes[y * (row + 1) + 1 + i] =
                (unsigned char)(raster->rgb[y * row + i] - (y ? raster->rgb[(y - 1) * row + i] : 0));
    }
    return bytes;
}

static void paradt_picture__encode(paradt_picture__bytes *out, const paradt_picture__raster *raster) {
    unsigned char header[13] = {0, 0, 0, 0, 0, 0, 0, 0, 8, 2, 0, 0, 0}; // 8 bits of red, green and blue
    paradt_picture__bytes packed = {NULL, 0, 0, 0};
    size_t size;
    unsigned char *rows = paradt_picture__filter(raster, &size);
    out->failed |= !rows;
    if (rows)
        paradt_picture__compress(&packed, rows, size);
    out->failed |= packed.failed;
    paradt_picture__big_endian(header, (uint32_t)raster->width);
    paradt_picture__big_endian(header + 4, (uint32_t)raster->height);
    paradt_picture__put(out, "\x89PNG\r\n\x1a\n", 8);
    paradt_picture__put_chunk(out, "IHDR", header, sizeof header);
    if (packed.data)
        paradt_picture__put_chunk(out, "IDAT", packed.data, packed.size);
    paradt_picture__put_chunk(out, "IEND", header, 0);
    free(packed.data);
    free(rows);
}

static void paradt_picture__put_png(paradt_picture__bytes *out, const paradt_picture__drawing *d) {
    paradt_picture__raster raster = {PARADT_PICTURE__WIDTH * PARADT_PICTURE__SAMPLES,
                                     PARADT_PICTURE__HEIGHT * PARADT_PICTURE__SAMPLES, NULL, NULL};
    out->failed |= !paradt_picture__draw(&raster, d);
    free(raster.depth);
    if (!out->failed) {
        paradt_picture__average(&raster);
        paradt_picture__encode(out, &raster);
    }
    free(raster.rgb);
}

// ---------------------------------------------------------------------------------------------------------------------
// >>pictures

// Writes a drawing into a file and frees it. good: 0: it could not be made
static int paradt_picture__write(paradt_picture *picture, paradt_picture__drawing *d, int good,
                                 void (*put)(paradt_picture__bytes *out, const paradt_picture__drawing *d)) {
    paradt_picture__bytes out = {NULL, 0, 0, 0};
    out.failed = !good;
    if (good)
        put(&out, d);
    paradt_picture__free(d);
    return paradt_picture__finish(&out, picture);
}

int paradt_picture_svg(paradt_picture *picture, const double *coordinates, int dim, const paradt_triangulation *t) {
    paradt_picture__drawing d;
    int good = paradt_picture__triangulation(&d, coordinates, dim, t);
    return paradt_picture__write(picture, &d, good, paradt_picture__put_svg);
}

int paradt_picture_png(paradt_picture *picture, const double *coordinates, int dim, const paradt_triangulation *t) {
    paradt_picture__drawing d;
    int good = paradt_picture__triangulation(&d, coordinates, dim, t);
    return paradt_picture__write(picture, &d, good, paradt_picture__put_png);
}

#ifndef PARADT_NO_VORONOI
int paradt_picture_voronoi_svg(paradt_picture *picture, const double *coordinates, const paradt_voronoi *v,
                               int clipped) {
    paradt_picture__drawing d;
    int good = paradt_picture__voronoi(&d, coordinates, v, clipped);
    return paradt_picture__write(picture, &d, good, paradt_picture__put_svg);
}

int paradt_picture_voronoi_png(paradt_picture *picture, const double *coordinates, const paradt_voronoi *v,
                               int clipped) {
    paradt_picture__drawing d;
    int good = paradt_picture__voronoi(&d, coordinates, v, clipped);
    return paradt_picture__write(picture, &d, good, paradt_picture__put_png);
}
#endif

#endif // PARADT_PICTURE_IMPLEMENTATION_DONE
#endif // PARADT_PICTURE_IMPLEMENTATION
