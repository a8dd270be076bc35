// Declarations for drawing views as splats, shared by all kernels of a picture.

struct View {
    // Changes of the projector's X, Y, W per column, row and depth step.
    steps: array<vec4<f32>, 3>,
    // Gradients of X, Y, W by world position, scaled by (radius of a ball) / (radius of a surfel's ellipse).
    gradients: array<vec4<f32>, 3>,
    // Right, up, towards the viewer; the first two in depth steps per pixel.
    axes: array<vec4<f32>, 3>,
    // Scale of a normal's components, minimum visible distance.
    rest: vec4<f32>,
    // Number of its first block among the blocks of all views, page, first words of its headers and of its bits.
    place: vec4<u32>,
}

struct Piece {
    start: vec3<f32>,
    nearness_bits: u32,
    low: vec2<i32>,
    high: vec2<i32>,
    corner: vec2<u32>,
    view: u32,
    // First block, number of blocks from bit 24 on, and DRAWN.
    blocks: u32,
    // Number of splats.
    count: u32,
}

struct Draw {
    // Width and height of the drawn samples, first row in the picture, samples along each axis of a pixel.
    size: vec4<u32>,
    // First piece, number of pieces, number of the pass, number of views.
    work: vec4<u32>,
    // First words of the output: colours, samples that show `before`, keys of centres; NONE if not requested.
    outputs: vec4<u32>,
    // Number of half-spaces, whether anything is clipped, whether the background is black, whether there is a
    // `before`.
    limits: vec4<u32>,
    // Rays of the samples: start relative to the eye and direction, at the picture's corner, and their changes.
    start: array<vec4<f32>, 3>,
    direction: array<vec4<f32>, 3>,
    // Visible segment of each ray: start, end.
    segment: vec4<f32>,
    planes: array<vec4<f32>, 8>,
}

@group(0) @binding(0) var<uniform> draw: Draw;
@group(0) @binding(1) var<storage, read> views: array<View>;

const NONE: u32 = 0xffffffffu;
// Width and height of a tile of samples with a farthest order.
const TILE: u32 = 16u;
// Side of a block, pixels.
const BLOCK: u32 = 8u;
// Fraction bits of slopes.
const FRACTION: u32 = 3u;
// A surfel inside a surface; other kinds are balls (0) and surfels at a border (1).
const INNER: u32 = 2u;

fn tile_columns() -> u32 {
    return (draw.size.x + TILE - 1u) / TILE;
}
