"""Long operations on scenes, points and numbers."""

from __future__ import annotations

from tests.support.long_operation import LongOperation

ARRAYS = (
    LongOperation(
        "import of trimesh",
        "pathlib.Path('one.off').write_text('OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n3 0 1 2\\n')",
        "while True:\n    nf.Scene.load('one.off')",
        1.0,
    ),
    LongOperation(
        "load an OBJ",
        "points, faces = sheet(1500)\n"
        "lines = [f'v {x:.6f} {y:.6f} {z:.6f}' for x, y, z in points]\n"
        "lines += [f'f {a} {b} {c}' for a, b, c in faces + 1]\n"
        "pathlib.Path('sheet.obj').write_text('\\n'.join(lines))",
        "nf.Scene.load('sheet.obj')",
        6.0,
    ),
    LongOperation(
        "load an OBJ with normals",
        "points, faces = sheet(1200)\n"
        "lines = [f'v {x:.6f} {y:.6f} {z:.6f}' for x, y, z in points] + ['vn 0 1 0', 'vn 0 0 1']\n"
        "lines += [f'f {a}//1 {b}//2 {c}//1' for a, b, c in faces + 1]\n"
        "pathlib.Path('sheet.obj').write_text('\\n'.join(lines))",
        "nf.Scene.load('sheet.obj')",
        6.0,
    ),
    LongOperation(
        "load a GLB",
        "import trimesh\n"
        "points, faces = sheet(2500)\n"
        "trimesh.Trimesh(points, faces, process=False).export('sheet.glb')",
        "while True:\n    nf.Scene.load('sheet.glb')",
        6.0,
    ),
    LongOperation(
        "load a PLY",
        "import trimesh\n"
        "points, faces = sheet(2500)\n"
        "trimesh.Trimesh(points, faces, process=False).export('sheet.ply')",
        "while True:\n    nf.Scene.load('sheet.ply')",
        6.0,
    ),
    LongOperation(
        "load an STL",
        "import trimesh\n"
        "points, faces = sheet(1500)\n"
        "trimesh.Trimesh(points, faces, process=False).export('sheet.stl')",
        "while True:\n    nf.Scene.load('sheet.stl')",
        6.0,
    ),
    LongOperation(
        "scene from arrays",
        "points, faces = sheet(5000)",
        "while True:\n    nf.Scene.from_arrays(points, faces)",
        8.0,
    ),
    LongOperation(
        "scene from trimesh",
        "import trimesh\npoints, faces = sheet(3000)\nmesh = trimesh.Trimesh(points, faces, process=False)",
        "while True:\n    nf.Scene.from_trimesh(mesh)",
        8.0,
    ),
    LongOperation(
        "subset",
        "scene = soup(10_000_000)",
        "while True:\n    scene.subset(triangles=np.arange(9_000_000))",
        6.0,
    ),
    LongOperation(
        "triangles",
        "scene = soup(20_000_000)",
        "while True:\n    scene.triangles()",
        8.0,
    ),
    LongOperation(
        "trees",
        "scene = soup(8_000_000)",
        "nf.cast_rays(scene, (0, 0, 0), [[0, 0, 1]])",
        6.0,
    ),
    LongOperation(
        "rays",
        "",
        "while True:\n    camera(8000).rays()",
        6.0,
    ),
    LongOperation(
        "project",
        "points = draw.uniform(-9, 9, (30_000_000, 3))",
        "while True:\n    camera(8000).project(points)",
        4.0,
    ),
    LongOperation(
        "range from depth",
        "depth = draw.random((20_000, 10_000), np.float32)",
        "while True:\n    nf.range_from_depth(depth, nf.Fov.symmetric(90), near=0.1, reverse=True)",
        6.0,
    ),
    LongOperation(
        "cube lookup",
        "faces, directions = draw.random((6, 512, 512, 3), np.float32), units(30_000_000)",
        "while True:\n    nf.cube_lookup(faces, directions, filter='linear')",
        4.0,
    ),
    LongOperation(
        "cube lookup of a footprint",
        "faces, directions = draw.random((6, 512, 512, 3), np.float32), units(5_000_000)",
        "nf.cube_lookup(faces, directions, filter='max', radius=0.5)",
        4.0,
    ),
    LongOperation(
        "cube mips",
        "faces = draw.random((6, 8192, 8192, 1), np.float32)",
        "while True:\n    nf.cube_mips(faces)",
        6.0,
    ),
    LongOperation(
        "cube solid angles",
        "",
        "while True:\n    nf.cube_solid_angles(10_000)",
        6.0,
    ),
    LongOperation(
        "map directions",
        "",
        "while True:\n    nf.envmap_directions(6_000)",
        8.0,
    ),
    LongOperation(
        "map texels",
        "directions = units(40_000_000)",
        "while True:\n    nf.envmap_texels(directions, size=4096)",
        6.0,
    ),
    LongOperation(
        "map conversion",
        "faces = draw.random((6, 2048, 2048, 3), np.float32)",
        "nf.convert_envmap(faces, source='cube', target='equirectangular', size=(16384, 8192), samples=4)",
        6.0,
    ),
    LongOperation(
        "nearest points",
        "scene, points = soup(200_000), draw.uniform(-120, 120, (20_000_000, 3))\nnf.nearest_points(scene, points[:9])",
        "nf.nearest_points(scene, points)",
        4.0,
    ),
    LongOperation(
        "cast rays",
        "scene, directions = soup(200_000), units(30_000_000)\nnf.cast_rays(scene, (0, 0, 0), directions[:9])",
        "nf.cast_rays(scene, np.zeros(3), directions)",
        6.0,
    ),
    LongOperation(
        "partition",
        "scene = soup(10_000_000)",
        "while True:\n    nf.partition(scene, **zones).validate()",
        6.0,
    ),
    LongOperation(
        "load curve",
        "scene = soup(10_000_000)",
        "while True:\n    nf.load_curve(scene, center=(0, 0, 0))",
        6.0,
    ),
    LongOperation(
        "radii of load curve",
        "curve, radii = nf.load_curve(soup(1_000_000), center=(0, 0, 0)), draw.uniform(0, 99, 20_000_000)",
        "while True:\n    curve.radius(curve.count(radii))",
        4.0,
    ),
    LongOperation(
        "triangle radii",
        "points = draw.random((30_000_000, 3, 3), np.float32)",
        "while True:\n    nf.triangle_radii(points, center=(0, 0, 0))",
        6.0,
    ),
    LongOperation(
        "morph",
        "points = draw.uniform(-40, 40, (60_000_000, 3)).astype(np.float32)",
        "while True:\n    nf.morph(points, user=(1, 0, 1), **zones)",
        6.0,
    ),
    LongOperation(
        "bend rays",
        "directions = units(5_000_000).astype(np.float64)",
        "nf.bend_rays(directions, user=(1, 0, 1), tolerance=1e-6, **zones)",
        8.0,
    ),
    LongOperation(
        "tessellate",
        "scene = soup(2_000_000)",
        "nf.tessellate(scene, user_region=4.0, tolerance_px=0.2, camera=camera(2000), **zones)",
        12.0,
    ),
    LongOperation(
        "bounding sphere",
        "points = draw.normal(size=(30_000_000, 3))\npoints /= np.linalg.norm(points, axis=1, keepdims=True)",
        "while True:\n    nf.bounding_sphere(points)",
        6.0,
    ),
    LongOperation(
        "Ritter's sphere",
        "points = draw.normal(size=(60_000_000, 3))",
        "while True:\n    nf.bounding_sphere(points, method='ritter')",
        4.0,
    ),
    LongOperation(
        "bounding spheres, one of them large",
        "points = draw.normal(size=(30_000_000, 3))\npoints /= np.linalg.norm(points, axis=1, keepdims=True)",
        "while True:\n    nf.bounding_spheres(points, [0, 10, len(points)])",
        6.0,
    ),
    LongOperation(
        "solid angles",
        "centers, radii = draw.normal(size=(30_000_000, 3)), draw.random(30_000_000)",
        "while True:\n    nf.solid_angle(centers, radii, eye=(0, 0, 0))",
        4.0,
    ),
    LongOperation(
        "warp",
        "picture = draw.random((8_000, 8_000, 3), np.float32)",
        "while True:\n    lens.warp(picture, inverse=True, fov='symmetric', filter='cubic')",
        4.0,
    ),
    LongOperation(
        "warp mesh",
        "",
        "while True:\n    lens.warp_mesh((2000, 2000), fov='symmetric', cells=(4096, 4096))",
        8.0,
    ),
    LongOperation(
        "undistort points",
        "points = draw.uniform(-0.6, 0.6, (40_000_000, 2))\n"
        "tilted = nf.RadialLens((0.22, 0.24), tangential=(1e-3, 1e-3))",
        "while True:\n    tilted.undistort_points(points)",
        4.0,
    ),
    LongOperation(
        "undistort radii",
        "radii = draw.uniform(0, 0.9, 100_000_000)",
        "while True:\n    lens.undistort(radii, method='fixed_point', iterations=100)",
        4.0,
    ),
    LongOperation(
        "solid angles through a lens",
        "centers = draw.uniform(-1, 1, (10_000_000, 3)) - (0, 0, 9)\nradii = draw.uniform(0.1, 0.2, 10_000_000)",
        "while True:\n    nf.corrected_solid_angle(centers, radii, camera=camera(100), lens=lens, exact=True)",
        4.0,
    ),
    LongOperation(
        "fit_4pl",
        "x = draw.uniform(0.1, 9, 10_000_000)\ny = 1 / (1 + x**2) + draw.normal(0, 0.1, len(x))",
        "nf.lod.fit_4pl(x, y)",
        4.0,
    ),
    LongOperation(
        "fit_4pl of many curves",
        "x = np.linspace(0.1, 9, 20)\ny = 1 / (1 + x**2) + draw.normal(0, 0.1, (1_000_000, len(x)))",
        "nf.lod.fit_4pl(x, y)",
        4.0,
    ),
    LongOperation(
        "simplify with meshoptimizer",
        "points, faces = sheet(2000)\nscene = nf.Scene.from_arrays(points, faces)",
        "nf.lod.simplify(scene, (1.0, 0.1), method='meshopt')",
        8.0,
    ),
    LongOperation(
        "select",
        "from tests.support.lod_oracle import usual\n"
        "models = [usual()]\n"
        "centers, radii = draw.uniform(-99, 99, (5_000_000, 3)), draw.uniform(0.1, 1, 5_000_000)\n"
        "index = np.zeros(len(radii), int)",
        "while True:\n    nf.lod.select(models, index, centers, radii, camera=camera(100), k=0.9, d=1.0)",
        4.0,
    ),
)
