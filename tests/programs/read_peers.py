"""Writes point sets by other programs, in every way that they have, and compares what ./read reads, to the bit. Usage:
read_peers.py numpy|meshio|vtk|gemmi [1: with zlib]. Prints "ok NAME" or "no NAME" for each file."""
import subprocess
import sys

import numpy as np

peer, zlib = sys.argv[1], sys.argv[2:] == ['1']
rng = np.random.default_rng(1)
points = np.round(rng.random((40, 3)), 12)
singles = points.astype(np.float32)
tetrahedra = np.arange(40).reshape(10, 4)
triangles = np.arange(39).reshape(13, 3)
failed = 0


def read(*arguments):
    run = subprocess.run(['./read', *arguments], capture_output=True, text=True)
    if run.returncode:
        return run.stderr
    rows = run.stdout.split(' [')[0].strip().rstrip(';').split(';')
    return np.array([[float(x) for x in row.split()] for row in rows])


def check(name, due, *arguments):
    global failed
    found = read(*arguments)
    good = isinstance(found, np.ndarray) and found.shape == due.shape and (found == due.astype(np.float64)).all()
    if not good:
        failed += 1
        print(name, arguments, found if isinstance(found, str) else (found.shape, due.shape), file=sys.stderr)
    print('ok' if good else 'no', f'as_{peer}_{name}')


def by_numpy():
    for kind in 'i1 u1 i2 u2 i4 u4 i8 u8 f2 f4 f8'.split():
        for order in '<>':
            for layout in 'CF':
                values = (rng.random((5, 3)) * 200 - (0 if kind[0] == 'u' else 100)).astype(order + kind)
                np.save('n.npy', np.asarray(values, order=layout))
                check(f'{"little" if order == "<" else "big"}_{kind}_{layout}', values, 'n.npy')
    np.savetxt('n.txt', points)
    check('savetxt', points, 'n.txt')
    np.savetxt('n.csv', points, delimiter=',', header='x,y,z')
    check('savetxt_with_a_header', points, 'n.csv')


def by_meshio():
    import meshio
    solid = meshio.Mesh(points, [('tetra', tetrahedra)])
    single = meshio.Mesh(singles, [('tetra', tetrahedra)])
    surface = meshio.Mesh(points, [('triangle', triangles)])
    ways = [('ply', 'p.ply', {'binary': False}), ('ply', 'p.ply', {'binary': True}), ('medit', 'p.mesh', {}),
            ('off', 'p.off', {}), ('obj', 'p.obj', {}), ('gmsh22', 'p.msh', {'binary': False}),
            ('gmsh22', 'p.msh', {'binary': True}), ('gmsh', 'p.msh', {'binary': False}), ('gmsh', 'p.msh', {'binary': True}),
            ('vtk42', 'p.vtk', {'binary': False}), ('vtk42', 'p.vtk', {'binary': True}), ('vtk', 'p.vtk', {'binary': False}),
            ('vtk', 'p.vtk', {'binary': True}), ('vtu', 'p.vtu', {'binary': False}),
            ('vtu', 'p.vtu', {'binary': True, 'compression': None})]
    if zlib:
        ways.append(('vtu', 'p.vtu', {'binary': True, 'compression': 'zlib'}))
    for form, name, options in ways:
        mesh = surface if form in ('off', 'obj', 'ply') else solid
        try:
            meshio.write(name, mesh, file_format=form, **options)
        except Exception as reason:
            print(form, options, 'is not written here:', reason, file=sys.stderr)
            continue
        label = '_'.join([form] + [f'{k}_{v}' for k, v in options.items()]).lower()
        check(label, meshio.read(name, file_format='gmsh' if form == 'gmsh22' else 'vtk' if form == 'vtk42' else form).points, name)
    meshio.write('s.vtu', single, binary=True, compression=None)
    check('vtu_of_singles', singles, 's.vtu')
    for binary in (False, True):
        meshio.write('p.stl', surface, binary=binary)
        found, due = read('p.stl'), meshio.read('p.stl').points
        good = isinstance(found, np.ndarray) and {tuple(p) for p in found} == {tuple(np.float64(p)) for p in due} and len(found) == 39
        global failed
        failed += not good
        print('ok' if good else 'no', f'as_meshio_stl_{"binary" if binary else "text"}')


def by_vtk():
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkPolyData, vtkUnstructuredGrid
    from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkUnstructuredGridWriter
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter
    for kind, values in (('doubles', points), ('singles', singles)):
        places = vtkPoints()
        places.SetData(numpy_to_vtk(values, deep=1))
        grid, surface = vtkUnstructuredGrid(), vtkPolyData()
        weights = numpy_to_vtk(np.arange(40) / 8, deep=1)
        weights.SetName('weight')
        for data in (grid, surface):
            data.SetPoints(places)
            data.GetPointData().AddArray(weights)
        for cell in tetrahedra:
            grid.InsertNextCell(VTK_TETRA, 4, cell.tolist())
        corners = vtkCellArray()
        for cell in triangles:
            corners.InsertNextCell(3, cell.tolist())
        surface.SetPolys(corners)
        weighted = np.column_stack([values, np.arange(40) / 8])
        for data, xml, legacy, name in ((grid, vtkXMLUnstructuredGridWriter, vtkUnstructuredGridWriter, 'v.vtu'),
                                        (surface, vtkXMLPolyDataWriter, vtkPolyDataWriter, 'v.vtp')):
            for mode in ('Ascii', 'Binary', 'Appended'):
                for raw in (False, True) if mode == 'Appended' else (False, ):
                    for packed in (False, True) if zlib and mode != 'Ascii' else (False, ):
                        for header in (32, 64):
                            for order in ('LittleEndian', 'BigEndian'):
                                writer = xml()
                                writer.SetInputData(data)
                                writer.SetFileName(name)
                                getattr(writer, f'SetDataModeTo{mode}')()
                                getattr(writer, f'SetByteOrderTo{order}')()
                                getattr(writer, f'SetHeaderTypeToUInt{header}')()
                                writer.SetEncodeAppendedData(not raw)
                                writer.SetBlockSize(64 if packed else 32768)
                                (writer.SetCompressorTypeToZLib if packed else writer.SetCompressorTypeToNone)()
                                writer.Write()
                                check(f'{name[2:]}_{kind}_{mode}{"_raw" if raw else ""}{"_packed" if packed else ""}_{header}_{order}',
                                      weighted, '--weights', name)
            for binary in (False, True):
                writer = legacy()
                writer.SetInputData(data)
                writer.SetFileName('v.vtk')
                (writer.SetFileTypeToBinary if binary else writer.SetFileTypeToASCII)()
                writer.Write()
                due = values
                if not binary:  # VTK writes text with fewer digits
                    from vtkmodules.util.numpy_support import vtk_to_numpy
                    from vtkmodules.vtkIOLegacy import vtkGenericDataObjectReader
                    reader = vtkGenericDataObjectReader()
                    reader.SetFileName('v.vtk')
                    reader.Update()
                    due = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
                    if kind == 'singles':
                        found = read('v.vtk')
                        due = found if (found.astype(np.float32) == due).all() else due
                check(f'vtk_of_{name[2:]}_{kind}_{"binary" if binary else "text"}', due, 'v.vtk')


def by_gemmi():
    import gemmi
    structure = gemmi.Structure()
    for number in (1, 2):
        model = gemmi.Model(str(number))
        chain = gemmi.Chain('A')
        for place in range(1, 12):
            alternates = {4: 'AB', 7: 'BCA'}.get(place, '\0')
            for residue_name in ('SER', 'THR') if place == 9 else ('ALA', ):
                residue = gemmi.Residue()
                residue.name = residue_name
                residue.seqid = gemmi.SeqId(str(place))
                for name, element in (('N', 'N'), ('CA', 'C'), ('SD', 'S'), ('H', 'H')):
                    for sign in ('A' if residue_name == 'SER' else 'B') if place == 9 else alternates:
                        atom = gemmi.Atom()
                        atom.name, atom.element, atom.altloc = name, gemmi.Element(element), sign
                        atom.pos = gemmi.Position(*np.round(rng.random(3) * 100 - 50, 3))
                        residue.add_atom(atom)
                chain.add_residue(residue)
        model.add_chain(chain)
        structure.add_model(model)
    structure.setup_entities()
    structure.write_pdb('g.pdb')
    structure.make_mmcif_document().write_file('g.cif')
    radii = {'N': 1.55, 'C': 1.7, 'S': 1.8, 'H': 1.2}
    for name in ('g.pdb', 'g.cif'):
        other = gemmi.read_structure(name)
        other.remove_alternative_conformations()
        due = [[*a.pos.tolist(), radii[a.element.name] * radii[a.element.name]] for c in other[0] for r in c for a in r]
        check(name[2:], np.array(due), '--weights', name)


{'numpy': by_numpy, 'meshio': by_meshio, 'vtk': by_vtk, 'gemmi': by_gemmi}[peer]()
sys.exit(failed > 0)
