# vtk_cells.py VTU CSV: reads Voronoi cells with VTK and compares them with the table of --voronoi: which cells there are,
# and their volumes, as their data say and as VTK measures them: in the plane vtkCellSizeFilter, in space vtkMassProperties
# from a cell's surface, which has to be closed. (vtkCellSizeFilter divides polyhedra by a Delaunay triangulation with
# tolerances, and misses the volumes of some by far.) Prints the first difference.
import csv
import sys

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import VTK_POLYGON, VTK_POLYHEDRON
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersExtraction import vtkExtractCells
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def surface_of(grid, cell):
    cells = vtkIdList()
    cells.InsertNextId(cell)
    extract = vtkExtractCells()
    extract.SetInputData(grid)
    extract.SetCellList(cells)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(extract.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def open_edges(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


def check(condition, *words):
    if not condition:
        print(*words)
        sys.exit(1)


def close(a, b):
    return abs(a - b) <= 1e-6 * abs(b)


rows = list(csv.DictReader(open(sys.argv[2])))
due = {int(r["index"]): r for r in rows if r["volume"] not in ("inf", "0")}
reader = vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.Update()
size = vtkCellSizeFilter()
size.SetInputConnection(reader.GetOutputPort())
size.Update()
grid = size.GetOutput()
check(grid.GetNumberOfCells() == len(due), grid.GetNumberOfCells(), "cells where", len(due), "are due")
flat = "cz" not in rows[0]
areas = grid.GetCellData().GetArray("Area")
points, volumes = grid.GetCellData().GetArray("point"), grid.GetCellData().GetArray("volume")
check(len({points.GetValue(i) for i in range(len(due))}) == len(due), "a cell comes twice")
for i in range(len(due)):
    row = due[int(points.GetValue(i))]
    volume = float(row["volume"])
    cell = grid.GetCell(i)
    check(cell.GetCellType() == (VTK_POLYGON if flat else VTK_POLYHEDRON), "cell", i, "is of type", cell.GetCellType())
    check((cell.GetNumberOfEdges() if flat else cell.GetNumberOfFaces()) == int(row["faces"]), "faces of", row)
    check(close(volumes.GetValue(i), volume), "data", volumes.GetValue(i), row)
    if flat:
        check(close(areas.GetValue(i), volume), "vtkCellSizeFilter", areas.GetValue(i), row)
    else:
        surface = surface_of(grid, i)
        mass = vtkMassProperties()
        mass.SetInputData(surface)
        check(open_edges(surface) == 0, "the surface is open", row)
        check(close(mass.GetVolume(), volume), "vtkMassProperties", mass.GetVolume(), row)
print(len(due), "cells")
