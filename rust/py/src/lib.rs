//! Bindings of nearfar-core, nearfar-gpu and nearfar-serve. Each function converts its arguments, releases the
//! interpreter, calls a kernel and maps its error.

mod convert;

mod base;
mod scene;
mod cubemap;
mod camera;
mod trace;
mod partition;
mod morph;
mod tessellate;
mod render;
mod impostor;
mod stereo;
mod export;
mod gpu;
mod orthoview;
mod metrics;
mod bounds;
mod lens;
mod lod;
mod exr;
mod serve;

use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

/// The extension module, ordered by stage.
#[pymodule]
mod _core {
    use super::*;

    #[pymodule_export]
    use crate::{
        base::{exchange_paths, probe, thread_count, uniform},
        bounds::{bounding_sphere, bounding_spheres, solid_angles},
        camera::{Camera, DepthBuffer},
        cubemap::{
            convert_envmap, convert_envmap_nearest, cube_lookup, cube_nearest, cube_next_level, cube_solid_angles,
            envmap_directions, envmap_texels,
        },
        export::{Export, decode_ranges, encode_ranges, halved_texture, texels_per_radian},
        exr::{decode_exr, encode_exr},
        gpu::compute::{gpu_cube_lookup, gpu_discontinuity, gpu_morph, gpu_similarity},
        gpu::device::{GpuDevice, gpu_adapters, gpu_close, gpu_forked, gpu_is_hardware},
        gpu::frame::{GpuFrame, GpuJob, gpu_keep},
        impostor::{ImpostorSheets, bake_impostors},
        lens::{RadialLens, corrected_solid_angles, warp, warp_mesh},
        lod::select::{check_weights, select_levels, spend_triangles},
        lod::simplify::{carry, collapse, first_alike, fit_4pl, pieces},
        metrics::{discontinuity, mean_squared_errors, multiscale, object_completion, similarity, tear},
        morph::{bend_rays, fold_margin, morph},
        orthoview::cut::{OrthoCells, OrthoRule},
        orthoview::splat::{OrthoSplats, blend_orthoviews, expected_orthoviews, splat_orthoviews},
        orthoview::splat::{gpu_keep_orthoviews, gpu_orthoview_bytes},
        orthoview::steady::{blend_past, blur_motion},
        orthoview::views::{OrthoParent, OrthoViews, orthoview_axes, orthoview_steps, orthoview_surfels},
        partition::{LoadCurve, Partition, object_radii, ring_loads, triangle_radii},
        render::bake::{bake_map, bake_rings, luma_near, silhouettes},
        render::frame::{encode_srgb, gather_frames, irradiance, render_truth, sample_offsets},
        render::reduced::Reduced,
        scene::decode::{
            decode_meshopt, encode_meshopt_rows, encode_meshopt_triangles, parse_numbers, polygon_prisms,
            read_ply_rows, read_wavefront, read_wkb, triangulate_faces, triangulate_polygons,
        },
        scene::levels::{Levels, mesh_parts, placements_of, scene_parts, with_instances, with_surfaces},
        scene::stored::StoredMeshes,
        scene::{Mesh, Scene},
        serve::{Server, begin_log, certificate, room_token, self_signed},
        stereo::HybridRig,
        tessellate::{tessellate_arrays, tessellate_scene},
        trace::{cast_rays, instruction_sets, nearest_points, use_instruction_set},
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        // rust-numpy looks up NumPy's functions at the first array. In a thread that outlives the interpreter this
        // would panic and print a backtrace.
        drop(PyArray1::<u8>::zeros(module.py(), 0, false).readonly());
        convert::errors::register(module)
    }
}
