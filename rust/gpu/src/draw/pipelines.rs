//! Shaders and pipelines, each compiled once per device, and their bind group layouts.

use std::collections::HashMap;
use std::num::NonZeroU32;
use std::sync::{Mutex, OnceLock};

use nearfar_core::base::Result;
use nearfar_core::render::shade;
use wgpu::{
    BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry, BindingType, BufferBindingType, ColorTargetState,
    ColorWrites, CompareFunction, ComputePipeline, ComputePipelineDescriptor, DepthStencilState, FragmentState,
    MultisampleState, PipelineCompilationOptions, PipelineLayout, PipelineLayoutDescriptor, RenderPipeline,
    RenderPipelineDescriptor, ShaderModule, ShaderModuleDescriptor, ShaderSource, ShaderStages, TextureFormat,
    TextureSampleType, TextureViewDimension, VertexState,
};

use super::style::{Cut, Style};
use crate::device::{Device, PipelineCache, VISIBILITY_FORMAT, lock};

/// Depth format; depth is reversed.
pub(super) const DEPTH: TextureFormat = TextureFormat::Depth32Float;

/// Settings of a layer's raster pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct RasterKey {
    pub style: Style,
    pub cut: Cut,
    pub cutout: bool,
    /// Whether fragments outside the visible volume are discarded.
    pub limited: bool,
    /// Whether the adapter clips triangles at planes; whole triangles only.
    pub clipped: bool,
    pub one_record: bool,
    pub samples: u32,
    /// Number of views per pass, 1 or 2.
    pub views: u32,
}

impl RasterKey {
    /// Returns the entry points of vertex and fragment shader.
    fn entries(&self, writes_depth: bool) -> [&'static str; 2] {
        let plain = self.cut == Cut::NONE && !self.cutout && !self.limited;
        let plain_vertex = match (self.clipped, self.views) {
            (false, 1) => "plain_vertex",
            (false, _) => "plain_vertex_of_two",
            (true, _) => "clipped_vertex",
        };
        match (plain, writes_depth) {
            (true, false) => [plain_vertex, "plain_fragment"],
            (true, true) => [plain_vertex, "plain_fragment_with_depth"],
            (false, false) => ["vertex", "fragment"],
            (false, true) => ["vertex", "fragment_with_depth"],
        }
    }
}

/// Settings of a layer's resolve pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct ResolveKey {
    pub style: Style,
    pub mapped: bool,
    /// Whether the map is visible only on a segment of each ray.
    pub limited: bool,
    pub bare: bool,
    pub color: bool,
    pub surface: bool,
    pub one_record: bool,
    pub textured: bool,
    pub colored: bool,
    pub smooth: bool,
    /// Whether some material emits light or is unlit.
    pub glowing: bool,
    pub samples: u32,
}

#[derive(Default)]
pub(crate) struct Pipelines {
    layouts: OnceLock<Layouts>,
    modules: Mutex<HashMap<String, ShaderModule>>,
    raster: PipelineCache<RasterKey, RenderPipeline>,
    resolve: PipelineCache<ResolveKey, ComputePipeline>,
    /// By the number of samples.
    masks: PipelineCache<u32, RenderPipeline>,
}

pub(super) struct Layouts {
    /// Tables of a scene and the order of its records.
    pub raster_scene: BindGroupLayout,
    /// Tables of a scene.
    pub resolve_scene: BindGroupLayout,
    /// Pass, batch and environment map.
    pub view: BindGroupLayout,
    /// Visible faces, single-sampled or multisampled, and the output.
    pub target: [BindGroupLayout; 2],
    pub mask: BindGroupLayout,
}

/// Settings in which the render pipelines of layers and of masks differ.
struct RenderSettings<'a> {
    label: &'static str,
    source: &'a str,
    entries: [&'static str; 2],
    /// Layout of bind group 0.
    layout: &'a BindGroupLayout,
    constants: &'a [(&'a str, f64)],
    depth_compare: CompareFunction,
    write_mask: ColorWrites,
    samples: u32,
    views: u32,
}

impl Pipelines {
    pub(super) fn layouts(&self, device: &Device) -> &Layouts {
        self.layouts.get_or_init(|| Layouts::new(device))
    }

    pub(super) fn raster(&self, device: &Device, key: RasterKey) -> Result<RenderPipeline> {
        self.raster.get(device, key, |key| {
            let constants = [
                ("STYLE", f64::from(key.style.0.variant)),
                ("CUT", f64::from(key.cut.snippet.variant)),
                ("FACE_NORMALS", f64::from(key.cut.face_normals)),
                ("CUTOUT", f64::from(key.cutout)),
                ("LIMITED", f64::from(key.limited)),
                ("ONE_RECORD", f64::from(key.one_record)),
            ];
            let settings = RenderSettings {
                label: "raster",
                source: &raster_source(key),
                entries: key.entries(device.writes_depth),
                layout: &self.layouts(device).raster_scene,
                constants: &constants,
                // At equal depths the first fragment stays, which is the lower triangle, as in the tracer.
                depth_compare: CompareFunction::Greater,
                write_mask: ColorWrites::ALL,
                samples: key.samples,
                views: key.views,
            };
            self.compile_render(device, &settings)
        })
    }

    pub(super) fn resolve(&self, device: &Device, key: ResolveKey) -> Result<ComputePipeline> {
        self.resolve.get(device, key, |key| {
            let layouts = self.layouts(device);
            let target = &layouts.target[usize::from(key.samples > 1)];
            let groups = [Some(&layouts.resolve_scene), Some(&layouts.view), Some(target)];
            let constants = [
                ("STYLE", f64::from(key.style.0.variant)),
                ("MAPPED", f64::from(key.mapped)),
                ("LIMITED", f64::from(key.limited)),
                ("BARE", f64::from(key.bare)),
                ("COLOR", f64::from(key.color)),
                ("SURFACE", f64::from(key.surface)),
                ("ONE_RECORD", f64::from(key.one_record)),
                ("TEXTURED", f64::from(key.textured)),
                ("COLORED", f64::from(key.colored)),
                ("SMOOTH", f64::from(key.smooth)),
                ("GLOWING", f64::from(key.glowing)),
            ];
            device.wgpu.create_compute_pipeline(&ComputePipelineDescriptor {
                label: Some("resolve"),
                layout: Some(&pipeline_layout(device, "resolve", &groups)),
                module: &self.module(device, &resolve_source(key.style, key.samples)),
                entry_point: Some("resolve"),
                compilation_options: options(&constants),
                cache: None,
            })
        })
    }

    /// Returns the pipeline that hides pixels by writing the nearest depth to them.
    pub(super) fn mask(&self, device: &Device, samples: u32) -> Result<RenderPipeline> {
        self.masks.get(device, samples, |&samples| {
            let settings = RenderSettings {
                label: "mask",
                source: MASK,
                entries: ["whole_window", "hide"],
                layout: &self.layouts(device).mask,
                constants: &[],
                depth_compare: CompareFunction::Always,
                write_mask: ColorWrites::empty(),
                samples,
                views: 1,
            };
            self.compile_render(device, &settings)
        })
    }

    fn compile_render(&self, device: &Device, settings: &RenderSettings<'_>) -> RenderPipeline {
        let module = &self.module(device, settings.source);
        let groups = [Some(settings.layout), Some(&self.layouts(device).view)];
        let [vertices, fragments] = settings.entries;
        device.wgpu.create_render_pipeline(&RenderPipelineDescriptor {
            label: Some(settings.label),
            layout: Some(&pipeline_layout(device, settings.label, &groups)),
            vertex: VertexState {
                module,
                entry_point: Some(vertices),
                compilation_options: options(settings.constants),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(true),
                depth_compare: Some(settings.depth_compare),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: MultisampleState { count: settings.samples, ..MultisampleState::default() },
            fragment: Some(FragmentState {
                module,
                entry_point: Some(fragments),
                compilation_options: options(settings.constants),
                targets: &[Some(ColorTargetState { write_mask: settings.write_mask, ..VISIBILITY_FORMAT.into() })],
            }),
            multiview_mask: views_mask(settings.views),
            cache: None,
        })
    }

    fn module(&self, device: &Device, source: &str) -> ShaderModule {
        let create = || {
            let source = ShaderSource::Wgsl(source.to_string().into());
            device.wgpu.create_shader_module(ShaderModuleDescriptor { label: Some("nearfar"), source })
        };
        lock(&self.modules).entry(source.to_string()).or_insert_with(create).clone()
    }
}

fn options<'a>(constants: &'a [(&'a str, f64)]) -> PipelineCompilationOptions<'a> {
    PipelineCompilationOptions { constants, ..PipelineCompilationOptions::default() }
}

fn pipeline_layout(device: &Device, label: &str, groups: &[Option<&BindGroupLayout>]) -> PipelineLayout {
    device.wgpu.create_pipeline_layout(&PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: groups,
        immediate_size: 0,
    })
}

const SCENE: &str = include_str!("../shaders/scene.wgsl");
const CUBE: &str = include_str!("../shaders/cube.wgsl");
const SURFACE: &str = concat!(include_str!("../shaders/light.wgsl"), include_str!("../shaders/surface.wgsl"));
const RASTER: &str = include_str!("../shaders/raster.wgsl");
const CLIPPED: &str = include_str!("../shaders/clipped.wgsl");
const ONE_VIEW: &str = include_str!("../shaders/one_view.wgsl");
const TWO_VIEWS: &str = include_str!("../shaders/two_views.wgsl");
const MASK: &str = include_str!("../shaders/mask.wgsl");
const RESOLVE: &str = include_str!("../shaders/resolve.wgsl");

/// Returns the view mask of a pass that draws several views.
pub(super) fn views_mask(views: u32) -> Option<NonZeroU32> {
    NonZeroU32::new(if views > 1 { (1 << views) - 1 } else { 0 })
}

fn raster_source(key: &RasterKey) -> String {
    let (enable, clipped) = if key.clipped { ("enable clip_distances;\n", CLIPPED) } else { ("", "") };
    let views = if key.views == 1 { ONE_VIEW } else { TWO_VIEWS };
    let (style, cut) = (key.style.0.text, key.cut.snippet.text);
    [enable, &shading_constants(), SCENE, views, CUBE, SURFACE, style, cut, RASTER, clipped].concat()
}

fn resolve_source(style: Style, samples: u32) -> String {
    let (texture, index) = if samples > 1 { ("multisampled_2d", "i32(sample_index)") } else { ("2d", "0") };
    let load = format!(
        "const SAMPLES: u32 = {samples}u;\n@group(2) @binding(0) var visible: texture_{texture}<u32>;\n\
         fn load_visible(pixel: vec2<u32>, sample_index: u32) -> vec4<u32> {{ \
         return textureLoad(visible, vec2<i32>(pixel), {index}); }}\n"
    );
    [&shading_constants()[..], SCENE, ONE_VIEW, CUBE, SURFACE, style.0.text, &load, RESOLVE].concat()
}

/// Returns the constants of the shading formula, shared by all renderers.
pub(crate) fn shading_constants() -> String {
    let [nadir, horizon, zenith] = shade::BACKGROUND;
    let vectors = [
        ("SUN_DIRECTION", shade::SUN_DIRECTION.to_array()),
        ("SUN", shade::SUN),
        ("SKY_DIRECTION", shade::SKY_DIRECTION.to_array()),
        ("SKY_LOW", shade::SKY[0]),
        ("SKY_HIGH", shade::SKY[1]),
        ("NADIR", nadir),
        ("HORIZON", horizon),
        ("ZENITH", zenith),
    ];
    vectors.iter().map(|(name, [x, y, z])| format!("const {name} = vec3<f32>({x:?}, {y:?}, {z:?});\n")).collect()
}

impl Layouts {
    fn new(device: &Device) -> Self {
        let storage = |read_only| BufferBindingType::Storage { read_only };
        let buffer = |ty, has_dynamic_offset| BindingType::Buffer { ty, has_dynamic_offset, min_binding_size: None };
        let texture = |sample_type, view_dimension, multisampled| BindingType::Texture {
            sample_type,
            view_dimension,
            multisampled,
        };
        let layout = |label, stages: ShaderStages, types: &[BindingType]| {
            let entry = |(binding, &ty): (usize, &BindingType)| BindGroupLayoutEntry {
                binding: binding as u32,
                visibility: stages,
                ty,
                count: None,
            };
            let entries: Vec<_> = types.iter().enumerate().map(entry).collect();
            device.wgpu.create_bind_group_layout(&BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
        };
        let table = buffer(storage(true), false);
        let array = TextureViewDimension::D2Array;
        let texels = texture(TextureSampleType::Uint, array, false);
        let floats = texture(TextureSampleType::Float { filterable: false }, array, false);
        let uniform = buffer(BufferBindingType::Uniform, true);
        let drawing = ShaderStages::VERTEX_FRAGMENT;
        let target = |multisampled| {
            let visible = texture(TextureSampleType::Uint, TextureViewDimension::D2, multisampled);
            layout("target", ShaderStages::COMPUTE, &[visible, buffer(storage(false), false)])
        };
        Self {
            raster_scene: layout("scene", drawing, &[table, table, table, table, table, texels, table]),
            resolve_scene: layout("scene", ShaderStages::COMPUTE, &[table, table, table, table, table, texels]),
            view: layout("view", drawing | ShaderStages::COMPUTE, &[uniform, uniform, floats, floats]),
            target: [target(false), target(true)],
            mask: layout("mask", ShaderStages::FRAGMENT, &[table]),
        }
    }
}
