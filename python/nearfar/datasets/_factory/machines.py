"""Machine tools: lathes and machining centres, prototypes on y = 0 with their fronts towards +z."""

from __future__ import annotations

from nearfar.datasets._factory import parts
from nearfar.datasets._palette import materials
from nearfar.datasets._random import xyz
from nearfar.datasets._shapes import Soup, bars, boxes, join, lathe, ring

PAINTS = materials("machine_green", "machine_blue", "machine_grey", "machine_cream")


def lathe_machine(variant: int, detail: int) -> Soup:
    """A large open lathe: bed, headstock with chuck, carriage, tailstock, chip tray, guard."""
    paint, steel = PAINTS[variant % len(PAINTS)], "metal_light"
    soups = [
        parts.casing([-2.3, 0.08, -0.55], [-1.2, 0.72, 0.5], 0.05, paint, detail),
        parts.casing([1.2, 0.08, -0.5], [2.3, 0.72, 0.45], 0.05, paint, detail),
        parts.casing([-2.35, 0.7, -0.55], [2.35, 1.0, 0.42], 0.05, paint, detail),
        parts.casing([-2.4, 0.98, -0.6], [-1.0, 1.85, 0.52], 0.08, paint, detail),
        boxes([-1.25, 0.28, -0.6], [1.25, 0.36, 0.75], "steel_grey"),
        bars([[-1.02, 0.99, -0.42], [-1.02, 0.99, 0.12]], [3.3, 0.09, 0.18], steel),
        _chuck(detail).translate([-1.0, 1.42, 0.0]),
        _carriage(paint, detail).translate([0.1 + 0.2 * (variant % 3), 1.0, 0.0]),
        _tailstock(paint, detail).translate([1.75, 1.0, 0.0]),
        parts.panel(detail).translate([-1.75, 1.55, 0.66]),
        parts.signal_tower(1.84, detail).translate([-2.1, 0.0, -0.3]),
    ]
    workpiece = parts.drum(0.11 + 0.03 * (variant % 3), 0.0, 1.9, steel, detail, 0.02).laid_x()
    soups.append(workpiece.translate([-0.75, 1.42, 0.0]))
    if detail >= 1:
        rear = boxes([-1.1, 1.02, -0.75], [2.3, 1.9, -0.68], "machine_grey")
        soups += [rear, parts.casing([-2.2, 0.1, -1.5], [-0.9, 1.3, -0.6], 0.05, "steel_grey", detail)]
        soups.append(parts.grille(0.9, 0.6, detail).pitched(0.5).translate([-1.55, 0.75, -1.5]))
    if detail >= 2:
        soups += _lathe_trimmings(detail)
    return join(soups)


def _chuck(detail: int) -> Soup:
    """A chuck about the x axis, with three jaws."""
    soups = [parts.drum(0.32, -0.04, 0.2, "metal", detail, 0.02)]
    if detail >= 1:
        soups += [boxes([0.19, 0.1, -0.05], [0.31, 0.3, 0.05], "metal_dark").rotated(k / 3.0) for k in range(3)]
    if detail >= 2:
        soups.append(parts.bolt_circle(12, 0.27, 0.014, 0.21, "metal_dark"))
    return join(soups).laid_x()


def _carriage(paint: int, detail: int) -> Soup:
    """The tool carriage on the bed, with its handwheels."""
    soups = [
        parts.casing([-0.35, -0.3, 0.38], [0.35, 0.16, 0.62], 0.03, paint, detail),
        boxes([-0.38, 0.07, -0.5], [0.38, 0.17, 0.6], "steel_grey"),
        boxes([-0.16, 0.16, -0.05], [0.16, 0.27, 0.5], "metal_light"),
        boxes([-0.1, 0.26, 0.16], [0.1, 0.45, 0.36], "metal_dark"),
    ]
    soups.append(parts.handwheel(0.13, "metal_dark", detail).laid_z().translate([-0.2, -0.1, 0.68]))
    if detail >= 1:
        soups.append(parts.handwheel(0.08, "metal_dark", detail).laid_z().translate([0.1, 0.05, 0.66]))
        soups.append(boxes([-0.04, 0.34, -0.1], [0.04, 0.38, 0.2], "metal_light"))
    if detail >= 2:
        knob = parts.drum(0.02, 0.0, 0.16, "metal_light", detail, 0.008)
        soups.append(knob.laid_z().copies([[0.05, -0.2, 0.6], [0.2, -0.2, 0.6], [0.28, 0.0, 0.6]]))
    return join(soups)


def _tailstock(paint: int, detail: int) -> Soup:
    """The tailstock with its centre and handwheel."""
    body = parts.casing([-0.3, 0.06, -0.24], [0.3, 0.6, 0.24], 0.05, paint, detail)
    sleeve = parts.drum(0.09, -0.7, 0.0, "metal_light", detail, 0.02).laid_x()
    wheel = parts.handwheel(0.16, "metal_dark", detail).laid_x().translate([0.38, 0.42, 0.0])
    return join([body, sleeve.translate([0.0, 0.42, 0.0]), wheel])


def _lathe_trimmings(detail: int) -> list[Soup]:
    """Feed rods, feet, coolant hose, switches, a lamp, chips in the tray."""
    soups = [parts.rod((-1.15, h, 0.52), (2.2, h, 0.52), 0.022, "metal_light", detail) for h in (0.78, 0.86, 0.94)]
    foot = parts.drum(0.09, -0.01, 0.09, "metal_dark", detail, 0.02)
    soups.append(foot.copies([[x, 0.0, z] for x in (-2.15, -1.35, 1.35, 2.15) for z in (-0.4, 0.35)]))
    hose = [[0.6, 1.2, -0.66], [0.6, 2.05, -0.66], [0.6, 2.05, -0.1], [0.6, 1.72, -0.1]]
    soups.append(parts.piping(hose, 0.018, 0.12, "rubber", detail, thin=True))
    lamp = lathe([(0.09, 0.0), (0.1, 0.02), (0.05, 0.14), (0.04, 0.15)], parts.ROUND[detail], "daylight")
    soups.append(lamp.translate([-0.3, 1.95, -0.45]))
    arm = [[-0.3, 1.3, -0.66], [-0.3, 2.07, -0.66], [-0.3, 2.07, -0.42]]
    soups.append(parts.piping(arm, 0.015, 0.08, "metal_dark", detail, thin=True))
    soups.append(parts.grille(0.8, 0.35, detail).copies([[-1.75, 0.4, 0.5], [1.75, 0.4, 0.45]]))
    lever = parts.drum(0.05, -0.02, 0.05, "metal_dark", detail, 0.01).laid_z()
    return [*soups, lever.copies([[-1.3, 1.2, 0.53], [-1.5, 1.15, 0.53], [-1.15, 1.35, 0.53]])]


def mill(variant: int, detail: int) -> Soup:
    """A machining centre in its housing, with a window, a tool magazine, tanks and a swivelling panel."""
    paint, grey = PAINTS[(variant + 1) % len(PAINTS)], "machine_grey"
    soups = [
        parts.casing([-1.7, 0.12, -1.2], [1.7, 2.35, 1.0], 0.09, grey, detail),
        parts.casing([-1.72, 0.1, -1.22], [1.72, 0.62, 1.04], 0.05, paint, detail),
        parts.casing([-0.85, 2.2, -1.15], [0.85, 3.0, 0.2], 0.08, paint, detail),
        parts.casing([1.66, 0.1, -0.9], [2.25, 1.9, 0.2], 0.06, grey, detail),
        boxes([-1.1, 0.85, 0.95], [0.75, 2.05, 1.03], paint),
        boxes([-0.95, 1.0, 0.97], [0.6, 1.9, 1.045], "glass_steel"),
        boxes([-0.2, 0.86, 0.98], [-0.14, 2.04, 1.07], "metal_light"),
        parts.panel(detail).translate([1.3, 1.5, 1.25]),
        boxes([1.1, 1.74, 0.9], [1.3, 1.8, 1.22], "metal_dark"),
        parts.signal_tower(2.3, detail).translate([1.4, 0.0, 0.3]),
        parts.casing([-2.2, 0.05, -1.0], [-1.68, 0.75, 0.8], 0.04, "steel_grey", detail),
        boxes([-1.6, -0.01, -1.1], [1.6, 0.13, 0.9], "metal_dark"),
    ]
    if detail >= 1:
        soups += [_magazine(detail).translate([-1.72, 1.55, -0.3]), _chip_conveyor(detail).translate([-1.9, 0.0, 0.0])]
    if detail >= 2:
        soups += _mill_trimmings(detail)
    return join(soups)


def _magazine(detail: int) -> Soup:
    """A disc of tools about the x axis, at the left wall."""
    disc = parts.drum(0.5, -0.3, 0.05, "metal", detail, 0.03)
    profile = [(0.03, -0.44), (0.045, -0.4), (0.045, -0.34), (0.03, -0.3), (0.03, -0.28)]
    tool = lathe(profile, parts.THIN[detail], "metal_light")
    x, z = ring((8, 12, 16, 24)[detail], 0.41).T
    return join([disc, tool.copies(xyz(x, 0.0, z))]).laid_x()


def _chip_conveyor(detail: int) -> Soup:
    """The chip conveyor on the left: a trough that rises to a chute over a bin."""
    trough = boxes([-0.2, 0.0, -0.12], [0.2, 1.6, 0.12], "steel_grey").pitched(0.12).translate([0.0, 0.2, 0.68])
    chute = boxes([-0.23, 1.1, 1.58], [0.23, 1.48, 1.95], "steel_grey")
    soups = [trough, chute, boxes([-0.35, 0.0, 1.45], [0.35, 0.75, 2.15], "rack_blue")]
    if detail >= 2:
        soups.append(boxes([-0.32, 0.72, 1.48], [0.32, 0.77, 2.12], "metal"))
    return join(soups)


def _mill_trimmings(detail: int) -> list[Soup]:
    """Grilles, hinges, feet, a cabinet's handle, hoses and motors on the roof."""
    side_grille = parts.grille(0.42, 0.5, detail).rotated(0.25)
    soups = [
        side_grille.copies([[2.25, 1.45, -0.35], [2.25, 0.55, -0.35]]),
        parts.grille(1.2, 0.7, detail).pitched(0.5).translate([0.0, 1.3, -1.2]),
        parts.drum(0.2, 2.95, 3.4, "machine_blue", detail, 0.03).translate([0.35, 0.0, -0.5]),
        parts.drum(0.14, 2.95, 3.25, "metal_dark", detail, 0.02).translate([-0.4, 0.0, -0.3]),
    ]
    fins = 12 if detail == 2 else 16
    fin = boxes([0.18, 2.99, -0.008], [0.225, 3.36, 0.008], "machine_blue")
    soups += [fin.rotated(k / fins).translate([0.35, 0.0, -0.5]) for k in range(fins)]
    hose = [[-0.4, 3.2, -0.3], [-0.4, 3.35, -0.3], [-1.5, 3.35, -0.3], [-1.5, 2.3, -0.3]]
    soups.append(parts.piping(hose, 0.03, 0.1, "rubber", detail, thin=True))
    hinge = parts.drum(0.025, -0.07, 0.07, "metal_light", detail, 0.008)
    soups.append(hinge.copies([[-1.12, h, 1.04] for h in (1.05, 1.45, 1.85)]))
    foot = parts.drum(0.08, -0.02, 0.14, "metal_dark", detail, 0.02)
    soups.append(foot.copies([[x, 0.0, z] for x in (-1.4, 0.0, 1.4) for z in (-0.95, 0.99)]))
    handle = [[0.3, 1.25, 1.03], [0.3, 1.25, 1.12], [0.3, 1.65, 1.12], [0.3, 1.65, 1.03]]
    soups.append(parts.piping(handle, 0.014, 0.04, "metal_light", detail, thin=True))
    return [*soups, parts.gauge(0.07, detail).copies([[-1.4, 1.7, 0.99], [-1.4, 1.5, 0.99]])]
