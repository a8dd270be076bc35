//! Bindings of nearfar-core and nearfar-gpu: each function converts, releases the interpreter, calls, and maps the error.

mod convert;

mod base;
mod scene;
mod cubemap;
mod camera;
mod trace;
mod partition;
mod morph;
mod bend;
mod tessellate;
mod render;
mod metrics;
mod bounds;
mod lens;
mod lod;
mod exr;
mod gpu;

use pyo3::prelude::*;

/// The extension module, stage by stage.
#[pymodule]
mod _core {
    use super::*;

    #[pymodule_export]
    use base::{probe, thread_count, uniform};
    #[pymodule_export]
    use bend::{bend_rays, fold_margin};
    #[pymodule_export]
    use bounds::{bounding_sphere, bounding_spheres, solid_angles};
    #[pymodule_export]
    use camera::{Camera, DepthBuffer};
    #[pymodule_export]
    use cubemap::layouts::{convert_envmap, convert_envmap_nearest, envmap_directions, envmap_texels};
    #[pymodule_export]
    use cubemap::lookup::{cube_footprint, cube_lookup, cube_nearest, cube_next_level, cube_solid_angles};
    #[pymodule_export]
    use exr::{decode_exr, encode_exr};
    #[pymodule_export]
    use gpu::compute::{gpu_cube_lookup, gpu_discontinuity, gpu_morph, gpu_similarity};
    #[pymodule_export]
    use gpu::device::{GpuDevice, gpu_adapters, gpu_forked, gpu_is_hardware};
    #[pymodule_export]
    use gpu::frame::{GpuFrame, GpuJob, gpu_keep};
    #[pymodule_export]
    use lens::{RadialLens, corrected_solid_angles, warp, warp_mesh};
    #[pymodule_export]
    use lod::fit::fit_4pl;
    #[pymodule_export]
    use lod::select::select_levels;
    #[pymodule_export]
    use lod::simplify::{carry, collapse, first_alike, pieces};
    #[pymodule_export]
    use metrics::{discontinuity, mean_squared_errors, multiscale, object_completion, similarity};
    #[pymodule_export]
    use morph::morph;
    #[pymodule_export]
    use partition::{LoadCurve, Partition, triangle_radii};
    #[pymodule_export]
    use render::bake::bake_map;
    #[pymodule_export]
    use render::frame::encode_srgb;
    #[pymodule_export]
    use render::reduced::Reduced;
    #[pymodule_export]
    use render::truth::render_truth;
    #[pymodule_export]
    use scene::levels::{Levels, placements_of, with_instances, with_surfaces};
    #[pymodule_export]
    use scene::parts::{mesh_parts, scene_parts};
    #[pymodule_export]
    use scene::{Mesh, Scene};
    #[pymodule_export]
    use tessellate::{tessellate_arrays, tessellate_scene};
    #[pymodule_export]
    use trace::{cast_rays, instruction_sets, nearest_points, use_instruction_set};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        convert::errors::register(module)
    }
}
