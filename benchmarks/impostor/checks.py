"""Impostors among geometry: tear along r₂, disparity between the eyes, and a car that drives from near to far.

A pixel's position is the scene point whose colour it shows: the texel's point on the surface that it was baked from,
not the quad's. "Along r₂" is the boundary of the published methods; "along the quads" is where geometry and quads
adjoin.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness import scenes
from benchmarks.harness.report import start, table
from benchmarks.harness.views import Point, center_for
from benchmarks.impostor.quality import Case, bake, cases
from benchmarks.impostor.texels import AROUND, Floats, Mask, Texels, texel_coordinates
from benchmarks.reduce import dynamic
from benchmarks.reduce.tear import REACH, views
from nearfar.metrics._tear import EPSILON, _tears

R2 = 50.0
MIN_EDGE = 200
"""Least number of boundary pixels of a view that counts, as in `benchmarks.reduce.tear`."""
IPD = 0.063
NEAREST, FARTHEST = 55.0, 65.0
"""Distances in metres at which disparity is measured."""
WINDOW, SHIFTS = 40, 8
"""Width of a matched window and greatest disparity, pixels."""


def shown_points(texels: Texels, camera: nf.Camera) -> tuple[nf.Frame, Mask, Floats]:
    """Return positions of the scene points whose colours a picture shows, where quads are, and the drawn positions.

    The scene point of a pixel lies in the direction of its place in the texture, on the triangle that the nearest baked
    texel of the quad was baked from.
    """
    impostors = texels.impostors
    origins, directions = (rays.reshape(-1, 3) for rays in camera.rays())
    assert impostors.far is not None
    hits = nf.cast_rays(impostors.far, origins, directions)
    positions = hits.position - np.array(impostors.center)
    is_quad = hits.hit
    if impostors.near is not None:
        near = nf.cast_rays(impostors.near, origins, directions)
        is_quad = hits.hit & ~(near.t_hit <= hits.t_hit)
        positions = np.where(is_quad[:, None], positions, near.position - np.array(impostors.center))
    drawn = positions.copy()
    order = np.argsort(texels.quads.masked[texels.quads.owners], kind="stable")
    triangles = order[hits.triangle_index[is_quad]]
    second, third = hits.barycentric[is_quad].astype(np.float64).T
    weights = np.stack([1.0 - second - third, second, third], axis=-1)
    corners = texel_coordinates(texels.quads)[texels.quads.faces[triangles]]
    quad = texels.quads.owners[triangles].astype(np.int64)
    places = (weights[..., None] * corners).sum(axis=1) - texels.quads.rectangles[quad, :2]
    positions[is_quad] = baked_points(texels, quad, places)
    height, width = camera.size[1], camera.size[0]
    frame = nf.Frame(camera, impostors.center, position=positions.reshape(height, width, 3).astype(np.float32))
    return frame, is_quad.reshape(height, width), drawn.reshape(height, width, 3)


def baked_points(texels: Texels, quad: NDArray[np.int64], places: Floats) -> Floats:
    """Return the scene points (N, 3), relative to O, that quads show at places (N, 2) in texels."""
    left, top, right, bottom = texels.quads.rectangles[quad].T
    last = np.stack([right - left, bottom - top], axis=-1) - 1
    nearest = np.clip(np.floor(places).astype(np.int64), 0, last)
    found = np.full((len(quad), 3), np.nan)
    todo = np.arange(len(quad))
    for offset in AROUND:
        texel = nearest[todo] + offset
        inside = ((texel >= 0) & (texel <= last[todo])).all(axis=1)
        todo_in, texel = todo[inside], texel[inside]
        column, row = (texel + texels.quads.rectangles[quad[todo_in], :2]).T
        is_shown = texels.quads.atlas[row, column, 3] >= 128
        todo_in, texel = todo_in[is_shown], texel[is_shown]
        _, points = texels.scene_points(quad[todo_in], texel)
        is_baked = texels.are_within(quad[todo_in], points)
        chosen = todo_in[is_baked]
        rays, _ = texels.faces.directions(quad[chosen], places[chosen], texels.size)
        center = texels.faces.center[quad[chosen]]
        normal, point = points.normal[is_baked], points.far[is_baked]
        with np.errstate(all="ignore"):
            t = ((point - center) * normal).sum(axis=1) / (rays * normal).sum(axis=1)
        same = (center + rays * t[:, None]) if len(chosen) else point
        # A triangle seen edge-on says little about the texels beside it.
        distance = np.linalg.norm(point - center, axis=1)
        is_far_off = ~(np.linalg.norm(same - point, axis=1) < 0.1 * distance)
        found[chosen] = np.where(is_far_off[:, None], point, same)
        todo = todo[np.isnan(found[todo, 0])]
        if not len(todo):
            break
    rays, w = texels.faces.directions(quad[todo], places[todo], texels.size)
    found[todo] = texels.faces.center[quad[todo]] + rays / w[:, None]
    return found


def tears(case: Case, count: int) -> list[list[Any]]:
    """Rows: tear along r₂ and where geometry and quads adjoin, means over all pixels of all views."""
    cylinder: dict[str, Any] = {"center": case.center, "radius": case.r2}
    impostors = bake(case.scene, case.center, case.r2, nf.ImpostorSettings(**case.settings))
    texels, sums, used = Texels(case.scene, impostors), np.zeros((3, 2)), 0
    worst = 0.0
    for camera in views(case.center, 7, impostors.reach):
        frame, is_quad, _ = shown_points(texels, camera)
        one = nf.metrics.boundary_tear(frame, **cylinder)
        if one.pixels * (one.shared or 0.0) < MIN_EDGE:
            continue
        used += 1
        same = nf.metrics.boundary_tear(frame, **cylinder, surfaces=True)
        for row, tear in enumerate((one, same)):
            pixels = tear.pixels * (tear.shared or 0.0)
            sums[row] += pixels, pixels * (tear.tear or 0.0)
        worst = max(worst, one.tear or 0.0)
        values, is_two_sided = _tears(frame, camera, EPSILON, side=is_quad, mask=edge(is_quad))
        kept = edge(is_quad) & is_two_sided & ~np.isnan(values)
        sums[2] += kept.sum(), values[kept].sum()
        if used == count:
            break
    places = ("along r₂", "along r₂, surfaces that cross it", "where geometry and quads adjoin")
    return [
        [case.label, place, used, pixels, total / pixels if pixels else None, worst if row == 0 else None]
        for row, (place, (pixels, total)) in enumerate(zip(places, sums.tolist(), strict=True))
    ]


def edge(inside: Mask) -> Mask:
    """Return pixels within two of a border, as `nf.metrics.boundary_mask` does."""
    found = np.zeros_like(inside)
    found[1:] |= inside[1:] ^ inside[:-1]
    found[:, 1:] |= inside[:, 1:] ^ inside[:, :-1]
    for _ in range(2):
        grown = found.copy()
        for part, other in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
            grown[part] |= found[other]
            grown[other] |= found[part]
        found = grown
    return found


def eyes(user: Floats, toward: Floats, size: int) -> list[nf.Camera]:
    """Return parallel views of 20° for both eyes."""
    middle = nf.Camera.look_at(user, toward, fov=nf.Fov.symmetric(20.0), size=(size, size))
    ahead = np.subtract(toward, user)
    right = np.cross(ahead, (0.0, 1.0, 0.0))
    right /= np.linalg.norm(right)
    return [
        nf.Camera(tuple(user + side * 0.5 * IPD * right), middle.orientation, fov=middle.fov, size=middle.size)
        for side in (-1.0, 1.0)
    ]


def match(left: Floats, right: Floats, corner: tuple[int, int]) -> float:
    """Return the disparity in pixels of a window of the left picture: the least squared difference, between pixels."""
    row, column = corner
    window = left[row : row + WINDOW, column : column + WINDOW]
    costs = np.array(
        [
            ((right[row : row + WINDOW, column - shift : column - shift + WINDOW] - window) ** 2).mean()
            for shift in range(-2, SHIFTS)
        ]
    )
    best = int(np.clip(np.argmin(costs), 1, len(costs) - 2))
    before, here, after = costs[best - 1 : best + 2].tolist()
    return float(best - 2 + 0.5 * (before - after) / max(before - 2.0 * here + after, 1e-12))


def disparities(
    scene: nf.Scene, impostors: nf.Impostors, cameras: list[nf.Camera]
) -> Iterator[tuple[float, float, float]]:
    """Yield for windows on quads some 60 m away the true disparity, and those that matching finds, in pixels.

    Windows count if matching finds the true disparity within 5 % in the truth's pictures: others have no texture.
    """
    pictures = [
        [nf.render(source, camera, samples=4, channels=("color", "range")) for camera in cameras]
        for source in (scene, impostors)
    ]
    (truth, _), (frame, _) = pictures
    near = nf.render(impostors.near, cameras[0], channels=("range",))
    is_quad = frame.require("range") < near.require("range")
    grey = [[picture.to_image().astype(np.float64).mean(axis=2) for picture in pair] for pair in pictures]
    camera = cameras[0]
    ahead = camera.rays()[1][camera.height // 2, camera.width // 2]
    depth = truth.require("range") * (camera.rays()[1] @ (ahead / np.linalg.norm(ahead)))
    focal = camera.width / (2.0 * np.tan(np.radians(10.0)))
    for row in range(0, camera.height - WINDOW, WINDOW // 2):
        for column in range(SHIFTS, camera.width - WINDOW - SHIFTS, WINDOW // 2):
            part = np.s_[row : row + WINDOW, column : column + WINDOW]
            low, high = depth[part].min(), depth[part].max()
            if not (low > NEAREST and high < FARTHEST and high - low < 2.0 and is_quad[part].all()):
                continue
            true = focal * IPD / float(depth[part].mean())
            by_truth, by_quads = (match(left, right, (row, column)) for left, right in grey)
            if abs(by_truth / true - 1.0) < 0.05:
                yield true, by_truth, by_quads


def disparity(name: str, scene: nf.Scene, center: Point, users: int, size: int) -> list[Any]:
    """Row: disparity of both eyes of users at half to full reach who look at surfaces some 60 m away."""
    impostors = bake(scene, center, R2, nf.ImpostorSettings(reach=REACH, face_size=size))
    draw = np.random.default_rng(3)
    found: list[tuple[float, float, float]] = []
    for _ in range(users):
        turn = draw.uniform(0.0, 2.0 * np.pi)
        user = np.add(center, draw.uniform(0.5, 1.0) * REACH * np.array([np.cos(turn), 0.0, np.sin(turn)]))
        for toward in directions_to(scene, user):
            found += disparities(scene, impostors, eyes(user, user + toward, 600))
    true, _, quads = np.array(found or np.full((1, 3), np.nan)).T
    ratio = quads / true
    return [
        name,
        len(found),
        float(true.mean()),
        float(np.median(ratio)),
        100.0 * float((abs(ratio - 1.0) < 0.1).mean()),
    ]


def directions_to(scene: nf.Scene, user: Floats) -> Floats:
    """Return the three directions, out of a ring, in which most of a user's view is some 60 m away."""
    turns = np.linspace(0.0, 2.0 * np.pi, 720, endpoint=False)
    ring = np.stack([np.cos(turns), np.full(720, 0.08), np.sin(turns)], axis=-1)
    distances = nf.cast_rays(scene, np.tile(user, (720, 1)), ring).t_hit
    fits = ((distances > NEAREST) & (distances < FARTHEST)).astype(float)
    share = np.array([np.roll(fits, shift).reshape(18, 40).mean(axis=1) for shift in range(0, 40, 10)])
    best = np.argsort(-share, axis=None)[:3]
    return ring[[(40 * (n % 18) + 20 - 10 * (n // 18)) % 720 for n in best]]


def car(turn: str, scene: nf.Scene, impostors: nf.Impostors, stride: int) -> list[Any]:
    """Row: pixels of a driving car that differ from the truth's along its path."""
    number, view = scene.object_names.index(dynamic.CAR), dynamic.camera(960)
    counts = np.zeros(4, np.int64)
    for pose in dynamic.drive(turn)[::stride]:
        at = {dynamic.CAR: pose}
        truth, shown = (
            nf.render(source.at(at), view, channels=("object_id",)).require("object_id") == number
            for source in (scene, impostors)
        )
        counts += 1, truth.sum(), (shown & ~truth).sum(), (truth & ~shown).sum()
    return [dynamic.TURNS[turn], *counts.tolist(), 100.0 * float(counts[2:].sum() / max(counts[1], 1))]


def main() -> None:
    arguments = start(__doc__, "--quick", views=6, users=4)
    quick = arguments.quick
    size = 128 if quick else 1024
    cities = [("procedural city", scenes.city(quick), nf.datasets.street_view()[0])]
    if not quick:
        cities += [(name, scene, center_for(scene, R2)) for name, scene in scenes.present("Tokyo core")]
    places = [case for case in cases((240, 136), 2, quick) if case.far_triangles is None]
    rows = [row for case in places for row in tears(case, 1 if quick else arguments.views)]
    print(
        table(
            "Tear, 20 pixels a degree",
            "scene | where | views | pixels {:,.0f} | tear, px {:.2f} | worst view {:.2f}",
            rows,
        ),
        flush=True,
    )
    header = "scene | windows | disparity, px {:.2f} | median of shown / true {:.3f} | within 10 %, % {:.1f}"
    rows = [disparity(*case, arguments.users, size) for case in cities]
    print(
        table(
            f"Disparity between eyes {IPD * 1e3:.0f} mm apart, {NEAREST:g} to {FARTHEST:g} m away, by matching",
            header,
            rows,
        ),
        flush=True,
    )
    city = dynamic.city(4, 1) if quick else dynamic.city(12, 2)
    impostors = nf.reduce(city, far="impostors", center=dynamic.CENTER, reach=REACH, r2=R2, face_size=size)
    header = "car | pictures | its pixels {:,} | too many {:,} | too few {:,} | differ, % {:.2f}"
    print(
        table(
            "A car that drives from 15 to 80 m",
            header,
            [car(turn, city, impostors, 8 if quick else 1) for turn in dynamic.TURNS],
        )
    )


if __name__ == "__main__":
    main()
