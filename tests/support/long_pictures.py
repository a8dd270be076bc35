"""Long operations on pictures and their files, on the processor and on adapters."""

from __future__ import annotations

from tests.support.long_operation import LongOperation

PICTURES = (
    LongOperation(
        "render 30000²",
        "scene = triangle()",
        "nf.render(scene, camera(30_000), channels=('range',))",
        8.0,
    ),
    LongOperation(
        "render 16000² in colour",
        "scene = triangle()",
        "while True:\n    nf.render(scene, camera(16_000), channels=('color',))",
        12.0,
    ),
    LongOperation(
        "render 1024 samples",
        "scene = triangle()",
        "nf.render(scene, camera(4096), samples=1024, channels=('color',))",
        2.0,
    ),
    LongOperation(
        "frame of a reduced scene",
        "reduced = nf.reduce(soup(100_000), face_size=64, **zones)",
        "nf.render(reduced, camera(6_000), samples=64)",
        8.0,
    ),
    LongOperation(
        "reduce",
        "scene = soup(500_000)",
        "nf.reduce(scene, face_size=4096, samples=16, **zones)",
        6.0,
    ),
    LongOperation(
        "frame to image",
        "shown = frame(16_000, color=draw.random((16_000, 16_000, 3), np.float32))",
        "while True:\n    shown.to_image()",
        8.0,
    ),
    LongOperation(
        "save a PNG",
        "shown = frame(12_000, color=draw.random((12_000, 12_000, 3), np.float32))",
        "shown.save('frame.png')",
        6.0,
    ),
    LongOperation(
        "save an EXR",
        "shown = frame(12_000, color=draw.random((12_000, 12_000, 3), np.float32))",
        "shown.save('frame.exr')",
        12.0,
    ),
    LongOperation(
        "load an EXR",
        "shown = frame(8_000, color=draw.random((8_000, 8_000, 3), np.float32))\nshown.save('frame.exr')",
        "while True:\n    nf.Frame.load('frame.exr')",
        8.0,
    ),
    LongOperation(
        "save a reduced scene",
        "reduced = nf.reduce(soup(1_000_000), face_size=4096, samples=1, **zones)",
        "reduced.save('reduced')",
        10.0,
    ),
    LongOperation(
        "load a reduced scene",
        "reduced = nf.reduce(soup(1_000_000), face_size=4096, samples=1, **zones)\nreduced.save('reduced')",
        "while True:\n    nf.ReducedScene.load('reduced')",
        10.0,
    ),
    LongOperation(
        "discontinuity",
        "shown = frame(8_000, position=draw.random((8_000, 8_000, 3), np.float32))",
        "while True:\n    nf.discontinuity(shown)",
        8.0,
    ),
    LongOperation(
        "boundary",
        "shown = frame(12_000, position=draw.random((12_000, 12_000, 3), np.float32))",
        "while True:\n    nf.boundary(shown, center=(0, 0, 0), radius=0.5)",
        8.0,
    ),
    LongOperation(
        "ssim",
        "one, two = (draw.random((10_000, 10_000, 3), np.float32) for _ in range(2))",
        "while True:\n    nf.ssim(one, two, data_range=1.0, channel_axis=-1)",
        8.0,
    ),
    LongOperation(
        "ssim with its map",
        "one, two = (draw.random((10_000, 10_000), np.float32) for _ in range(2))",
        "while True:\n    nf.ssim(one, two, data_range=1.0, full=True)",
        8.0,
    ),
    LongOperation(
        "ms_ssim",
        "one, two = (draw.random((10_000, 10_000), np.float32) for _ in range(2))",
        "while True:\n    nf.ms_ssim(one, two, data_range=1.0)",
        8.0,
    ),
    LongOperation(
        "psnr",
        "one, two = (draw.random((20_000, 20_000), np.float32) for _ in range(2))",
        "while True:\n    nf.psnr(one, two, data_range=1.0)",
        8.0,
    ),
    LongOperation(
        "object completion",
        "one, two = (draw.integers(0, 9, (20_000, 20_000), np.int32) for _ in range(2))",
        "while True:\n    nf.object_completion(one, two)",
        8.0,
    ),
    LongOperation(
        "measure",
        "from tests.support.lod_cases import levels\nfov, ball = nf.Fov.symmetric(90), levels(200, 90, 40)",
        "nf.lod.measure(ball, fov=fov, size=(512, 512), views=10_000, step=None, samples=4, cache=False)",
        2.0,
    ),
    LongOperation(
        "measure with workers",
        "from tests.support.lod_cases import levels\n"
        "fov, balls = nf.Fov.symmetric(90), [levels(n, 90) for n in (199, 200)]",
        "nf.lod.measure(balls, fov=fov, size=(512, 512), views=10_000, step=None, samples=4, cache=False, workers=2)",
        4.0,
    ),
    LongOperation(
        "load a model of many levels",
        "x = np.linspace(0.1, 0.9, 100_000)\n"
        "curve = nf.lod.Curve4PL(x, x, x, x, x, np.full(len(x), 'fitted'), np.full(len(x), ''))\n"
        "model = nf.lod.LodModel(triangles=np.ones(len(x) + 1, int), curves=curve, center=np.zeros(3), radius=1.0,\n"
        "    sigma=(1e-4, 0.18), errors=np.zeros(len(x) + 1))\n"
        "model.save('model.json')",
        "while True:\n    nf.lod.LodModel.load('model.json').save('copy.json')",
        2.0,
    ),
    LongOperation(
        "render on an adapter, 16 samples",
        "nf.gpu.select('vulkan')\nscene = nf.datasets.forest(seed=3)\nnf.render(scene, camera(9), backend='gpu')",
        "nf.render(scene, camera(3000), samples=16, backend='gpu')",
        4.0,
        "vulkan",
    ),
    LongOperation(
        "keep a frame on an adapter",
        "nf.gpu.select('vulkan')\nscene = nf.datasets.forest(seed=3)\nnf.render(scene, camera(9), backend='gpu')",
        "nf.gpu.render(scene, camera(3000), samples=16, channels=('color',))",
        4.0,
        "vulkan",
    ),
    LongOperation(
        "large frame on an adapter",
        "nf.gpu.select('vulkan')\nscene = nf.datasets.forest(seed=3)\nnf.render(scene, camera(9), backend='gpu')",
        "nf.render(scene, camera(9000), backend='gpu')",
        6.0,
        "vulkan",
    ),
    LongOperation(
        "reduce on an adapter",
        "nf.gpu.select('vulkan')\nscene = nf.datasets.forest(seed=3)\nnf.render(scene, camera(9), backend='gpu')",
        "nf.reduce(scene, face_size=2048, samples=16, backend='gpu', **zones)",
        6.0,
        "vulkan",
    ),
    LongOperation(
        "kernels on an adapter",
        "nf.gpu.select('vulkan')\n"
        "scene = nf.datasets.forest(seed=3)\n"
        "shown = nf.gpu.render(scene, camera(2000), channels=('color', 'position'))\n"
        "faces, directions = draw.random((6, 512, 512, 3), np.float32), units(10_000_000)",
        "while True:\n"
        "    nf.gpu.ssim(shown, shown)\n"
        "    nf.gpu.discontinuity(shown)\n"
        "    nf.gpu.morph(directions, user=(1, 0, 1), **zones)\n"
        "    nf.gpu.cube_lookup(faces, directions, filter='linear')",
        6.0,
        "vulkan",
    ),
)
