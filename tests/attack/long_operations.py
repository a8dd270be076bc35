"""Operations that take seconds if nothing stops them: one for each kernel and file format that grows with its input."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class LongOperation:
    """Setup statements, and statements that are repeated until a signal arrives."""

    name: str
    gigabytes: float
    """Maximum memory, bytes."""
    make: str
    work: str
    needs: str = ""
    """System feature that is required; see `tests.support.need`."""

    @property
    def code(self) -> str:
        """A script for an empty folder: it prints "ready" before it works, and "interrupted" at the end."""
        make, work = self.make or "pass", self.work
        return f"""{_BEGIN}
if __name__ == "__main__":
    {make}
    print("ready", flush=True)
    try:
        while True:
            {work}
    except KeyboardInterrupt:
        print("interrupted", flush=True)
"""


_BEGIN = """
import pathlib, numpy as np, nearfar as nf
draw = np.random.default_rng(0)

def triangle():
    return nf.Scene.from_arrays([[-9, -9, -5], [9, -9, -5], [0, 9, -5]], [[0, 1, 2]])

def soup(count):
    points = draw.uniform(-100, 100, (count, 1, 3)) + draw.normal(0, 0.1, (count, 3, 3))
    return nf.Scene.from_arrays(points.reshape(-1, 3), np.arange(3 * count).reshape(-1, 3))

def sheet(side):
    u, v = np.meshgrid(np.arange(side), np.arange(side))
    points = np.stack([u / side, np.sin(u / 40) * np.cos(v / 40) / 20, v / side], -1).reshape(-1, 3)
    first = (u[:-1, :-1] + side * v[:-1, :-1]).ravel()
    faces = np.stack([first, first + 1, first + side, first + 1, first + side + 1, first + side], -1).reshape(-1, 3)
    return points, faces

def camera(width, height=None):
    return nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(width, height or width))

def units(count):
    directions = draw.standard_normal((count, 3), np.float32)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return directions

def frame(side, **images):
    return nf.Frame(camera(side), **images)

zones = {"center": (0, 0, 0), "r1": 10.0, "r2": 30.0}
lens = nf.RadialLens((0.22, 0.24))
"""

_ROWS: tuple[tuple[str | float, ...], ...] = (
    ("import of trimesh", 1,
     "pathlib.Path('one.off').write_text('OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n3 0 1 2\\n')",
     "nf.Scene.load('one.off')"),
    ("load an OBJ", 6,
     "points, faces = sheet(1500); lines = [f'v {x:.6f} {y:.6f} {z:.6f}' for x, y, z in points]; lines += [f'f {a} "
     "{b} {c}' for a, b, c in faces + 1]; pathlib.Path('sheet.obj').write_text('\\n'.join(lines))",
     "nf.Scene.load('sheet.obj')"),
    ("load an OBJ with normals", 6,
     "points, faces = sheet(1200); lines = [f'v {x:.6f} {y:.6f} {z:.6f}' for x, y, z in points] + ['vn 0 1 0', 'vn "
     "0 0 1']; lines += [f'f {a}//1 {b}//2 {c}//1' for a, b, c in faces + 1]; "
     "pathlib.Path('sheet.obj').write_text('\\n'.join(lines))",
     "nf.Scene.load('sheet.obj')"),
    ("load a GLB", 6,
     "import trimesh; points, faces = sheet(2500); trimesh.Trimesh(points, faces, "
     "process=False).export('sheet.glb')",
     "nf.Scene.load('sheet.glb')"),
    ("load a PLY", 6,
     "import trimesh; points, faces = sheet(2500); trimesh.Trimesh(points, faces, "
     "process=False).export('sheet.ply')",
     "nf.Scene.load('sheet.ply')"),
    ("load an STL", 6,
     "import trimesh; points, faces = sheet(1500); trimesh.Trimesh(points, faces, "
     "process=False).export('sheet.stl')",
     "nf.Scene.load('sheet.stl')"),
    ("scene from arrays", 8, "points, faces = sheet(5000)", "nf.Scene.from_arrays(points, faces)"),
    ("scene from trimesh", 8,
     "import trimesh; points, faces = sheet(3000); mesh = trimesh.Trimesh(points, faces, process=False)",
     "nf.Scene.from_trimesh(mesh)"),
    ("subset", 6, "scene = soup(10_000_000)", "scene.subset(triangles=np.arange(9_000_000))"),
    ("triangles", 8, "scene = soup(20_000_000)", "scene.triangles()"),
    ("trees", 6, "scene = soup(8_000_000)", "nf.cast_rays(scene, (0, 0, 0), [[0, 0, 1]])"),
    ("rays", 6, "", "camera(8000).rays()"),
    ("project", 4, "points = draw.uniform(-9, 9, (30_000_000, 3))", "camera(8000).project(points)"),
    ("range from depth", 6,
     "depth = draw.random((20_000, 10_000), np.float32)",
     "nf.range_from_depth(depth, nf.Fov.symmetric(90), near=0.1, reverse=True)"),
    ("cube lookup", 4,
     "faces, directions = draw.random((6, 512, 512, 3), np.float32), units(30_000_000)",
     "nf.cube_lookup(faces, directions, filter='linear')"),
    ("cube lookup of a footprint", 4,
     "faces, directions = draw.random((6, 512, 512, 3), np.float32), units(5_000_000)",
     "nf.cube_lookup(faces, directions, filter='max', radius=0.5)"),
    ("cube mips", 6, "faces = draw.random((6, 8192, 8192, 1), np.float32)", "nf.cube_mips(faces)"),
    ("cube solid angles", 6, "", "nf.cube_solid_angles(10_000)"),
    ("map directions", 8, "", "nf.envmap_directions(6_000)"),
    ("map texels", 6, "directions = units(40_000_000)", "nf.envmap_texels(directions, size=4096)"),
    ("map conversion", 6,
     "faces = draw.random((6, 2048, 2048, 3), np.float32)",
     "nf.convert_envmap(faces, source='cube', target='equirectangular', size=(16384, 8192), samples=4)"),
    ("nearest points", 4,
     "scene, points = soup(200_000), draw.uniform(-120, 120, (20_000_000, 3)); nf.nearest_points(scene, points[:9])",
     "nf.nearest_points(scene, points)"),
    ("cast rays", 6,
     "scene, directions = soup(200_000), units(30_000_000); nf.cast_rays(scene, (0, 0, 0), directions[:9])",
     "nf.cast_rays(scene, np.zeros(3), directions)"),
    ("partition", 6, "scene = soup(10_000_000)", "nf.partition(scene, **zones).validate()"),
    ("load curve", 6, "scene = soup(10_000_000)", "nf.load_curve(scene, center=(0, 0, 0))"),
    ("radii of load curve", 4,
     "curve, radii = nf.load_curve(soup(1_000_000), center=(0, 0, 0)), draw.uniform(0, 99, 20_000_000)",
     "curve.radius(curve.count(radii))"),
    ("triangle radii", 6,
     "points = draw.random((30_000_000, 3, 3), np.float32)", "nf.triangle_radii(points, center=(0, 0, 0))"),
    ("morph", 6,
     "points = draw.uniform(-40, 40, (60_000_000, 3)).astype(np.float32)",
     "nf.morph(points, user=(1, 0, 1), **zones)"),
    ("bend rays", 8,
     "directions = units(5_000_000).astype(np.float64)",
     "nf.bend_rays(directions, user=(1, 0, 1), tolerance=1e-6, **zones)"),
    ("tessellate", 12,
     "scene = soup(2_000_000)",
     "nf.tessellate(scene, user_region=4.0, tolerance_px=0.2, camera=camera(2000), **zones)"),
    ("bounding sphere", 6,
     "points = draw.normal(size=(30_000_000, 3)); points /= np.linalg.norm(points, axis=1, keepdims=True)",
     "nf.bounding_sphere(points)"),
    ("Ritter's sphere", 4,
     "points = draw.normal(size=(60_000_000, 3))", "nf.bounding_sphere(points, method='ritter')"),
    ("bounding spheres, one of them large", 6,
     "points = draw.normal(size=(30_000_000, 3)); points /= np.linalg.norm(points, axis=1, keepdims=True)",
     "nf.bounding_spheres(points, [0, 10, len(points)])"),
    ("solid angles", 4,
     "centers, radii = draw.normal(size=(30_000_000, 3)), draw.random(30_000_000)",
     "nf.solid_angle(centers, radii, eye=(0, 0, 0))"),
    ("warp", 4,
     "picture = draw.random((8_000, 8_000, 3), np.float32)",
     "lens.warp(picture, inverse=True, fov='symmetric', filter='cubic')"),
    ("warp mesh", 8, "", "lens.warp_mesh((2000, 2000), fov='symmetric', cells=(4096, 4096))"),
    ("undistort points", 4,
     "points = draw.uniform(-0.6, 0.6, (40_000_000, 2)); tilted = nf.RadialLens((0.22, 0.24), tangential=(1e-3, "
     "1e-3))",
     "tilted.undistort_points(points)"),
    ("undistort radii", 4,
     "radii = draw.uniform(0, 0.9, 100_000_000)", "lens.undistort(radii, method='fixed_point', iterations=100)"),
    ("solid angles through a lens", 4,
     "centers = draw.uniform(-1, 1, (10_000_000, 3)) - (0, 0, 9); radii = draw.uniform(0.1, 0.2, 10_000_000)",
     "nf.corrected_solid_angle(centers, radii, camera=camera(100), lens=lens, exact=True)"),
    ("fit_4pl", 4,
     "x = draw.uniform(0.1, 9, 10_000_000); y = 1 / (1 + x**2) + draw.normal(0, 0.1, len(x))",
     "nf.lod.fit_4pl(x, y)"),
    ("fit_4pl of many curves", 4,
     "x = np.linspace(0.1, 9, 20); y = 1 / (1 + x**2) + draw.normal(0, 0.1, (1_000_000, len(x)))",
     "nf.lod.fit_4pl(x, y)"),
    ("simplify with meshoptimizer", 8,
     "points, faces = sheet(2000); scene = nf.Scene.from_arrays(points, faces)",
     "nf.lod.simplify(scene, (1.0, 0.1), method='meshopt')"),
    ("select", 4,
     "from tests.support.lod_oracle import usual; models = [usual()]; centers, radii = draw.uniform(-99, 99, "
     "(5_000_000, 3)), draw.uniform(0.1, 1, 5_000_000); index = np.zeros(len(radii), int)",
     "nf.lod.select(models, index, centers, radii, camera=camera(100), k=0.9, d=1.0)"),
    ("render 30000²", 8, "scene = triangle()", "nf.render(scene, camera(30_000), channels=('range',))"),
    ("render 16000² in colour", 12, "scene = triangle()", "nf.render(scene, camera(16_000), channels=('color',))"),
    ("render 1024 samples", 2,
     "scene = triangle()", "nf.render(scene, camera(4096), samples=1024, channels=('color',))"),
    ("frame of a reduced scene", 8,
     "reduced = nf.reduce(soup(100_000), face_size=64, **zones)", "nf.render(reduced, camera(6_000), samples=64)"),
    ("bake impostors", 6, "scene = soup(200_000)",
     "nf.reduce(scene, far='impostors', center=(0, 0, 0), r2=30.0)"),
    ("reduce", 6, "scene = soup(500_000)", "nf.reduce(scene, face_size=4096, samples=16, **zones)"),
    ("frame to image", 8,
     "shown = frame(16_000, color=draw.random((16_000, 16_000, 3), np.float32))", "shown.to_image()"),
    ("save a PNG", 6,
     "shown = frame(12_000, color=draw.random((12_000, 12_000, 3), np.float32))", "shown.save('frame.png')"),
    ("save an EXR", 12,
     "shown = frame(12_000, color=draw.random((12_000, 12_000, 3), np.float32))", "shown.save('frame.exr')"),
    ("load an EXR", 8,
     "shown = frame(8_000, color=draw.random((8_000, 8_000, 3), np.float32)); shown.save('frame.exr')",
     "nf.Frame.load('frame.exr')"),
    ("save a reduced scene", 10,
     "reduced = nf.reduce(soup(1_000_000), face_size=4096, samples=1, **zones)", "reduced.save('reduced')"),
    ("load a reduced scene", 10,
     "reduced = nf.reduce(soup(1_000_000), face_size=4096, samples=1, **zones); reduced.save('reduced')",
     "nf.ReducedScene.load('reduced')"),
    ("discontinuity", 8,
     "shown = frame(8_000, position=draw.random((8_000, 8_000, 3), np.float32))", "nf.metrics.discontinuity(shown)"),
    ("boundary", 8,
     "shown = frame(12_000, position=draw.random((12_000, 12_000, 3), np.float32))",
     "nf.metrics.boundary_mask(shown, center=(0, 0, 0), radius=0.5)"),
    ("ssim", 8,
     "one, two = (draw.random((10_000, 10_000, 3), np.float32) for _ in range(2))",
     "nf.ssim(one, two, data_range=1.0, channel_axis=-1)"),
    ("ssim with its map", 8,
     "one, two = (draw.random((10_000, 10_000), np.float32) for _ in range(2))",
     "nf.ssim(one, two, data_range=1.0, full=True)"),
    ("ms_ssim", 8,
     "one, two = (draw.random((10_000, 10_000), np.float32) for _ in range(2))",
     "nf.metrics.ms_ssim(one, two, data_range=1.0)"),
    ("psnr", 8,
     "one, two = (draw.random((20_000, 20_000), np.float32) for _ in range(2))", "nf.psnr(one, two, data_range=1.0)"),
    ("object completion", 8,
     "one, two = (draw.integers(0, 9, (20_000, 20_000), np.int32) for _ in range(2))",
     "nf.metrics.object_completion(one, two)"),
    ("measure", 2,
     "from tests.support.lod_cases import levels; fov, ball = nf.Fov.symmetric(90), levels(200, 90, 40)",
     "nf.lod.measure(ball, fov=fov, size=(512, 512), views=10_000, step=None, samples=4, cache=False)"),
    ("measure with workers", 4,
     "from tests.support.lod_cases import levels; fov, balls = nf.Fov.symmetric(90), [levels(n, 90) for n in (199, "
     "200)]",
     "nf.lod.measure(balls, fov=fov, size=(512, 512), views=10_000, step=None, samples=4, cache=False, workers=2)"),
    ("load a model of many levels", 2,
     "x = np.linspace(0.1, 0.9, 100_000); texts = [np.full(len(x), text) for text in ('fitted', '')]; "
     "curve = nf.lod.Curve4PL(x, x, x, x, x, *texts); sigma, errors = (1e-4, 0.18), np.zeros(len(x) + 1); "
     "model = nf.lod.LodModel(triangles=np.ones(len(x) + 1, int), curves=curve, center=np.zeros(3), radius=1.0, "
     "sigma=sigma, errors=errors); model.save('model.json')",
     "nf.lod.LodModel.load('model.json').save('copy.json')"),
    ("render on an adapter, 16 samples", 4,
     "nf.gpu.select('vulkan'); scene = nf.datasets.forest(seed=3); nf.render(scene, camera(9), backend='gpu')",
     "nf.render(scene, camera(3000), samples=16, backend='gpu')", "vulkan"),
    ("keep a frame on an adapter", 4,
     "nf.gpu.select('vulkan'); scene = nf.datasets.forest(seed=3); nf.render(scene, camera(9), backend='gpu')",
     "nf.gpu.render(scene, camera(3000), samples=16, channels=('color',))", "vulkan"),
    ("large frame on an adapter", 6,
     "nf.gpu.select('vulkan'); scene = nf.datasets.forest(seed=3); nf.render(scene, camera(9), backend='gpu')",
     "nf.render(scene, camera(9000), backend='gpu')", "vulkan"),
    ("reduce on an adapter", 6,
     "nf.gpu.select('vulkan'); scene = nf.datasets.forest(seed=3); nf.render(scene, camera(9), backend='gpu')",
     "nf.reduce(scene, face_size=2048, samples=16, backend='gpu', **zones)", "vulkan"),
    ("kernels on an adapter", 6,
     "nf.gpu.select('vulkan'); scene = nf.datasets.forest(seed=3); shown = nf.gpu.render(scene, camera(2000), "
     "channels=('color', 'position')); faces, directions = draw.random((6, 512, 512, 3), np.float32), "
     "units(10_000_000)",
     "nf.gpu.ssim(shown, shown); nf.gpu.discontinuity(shown); nf.gpu.morph(directions, user=(1, 0, 1), **zones); "
     "nf.gpu.cube_lookup(faces, directions, filter='linear')", "vulkan"),
)  # fmt: skip

OPERATIONS = tuple(LongOperation(*row) for row in _ROWS)  # type: ignore[arg-type]
