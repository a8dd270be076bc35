//! Compute shaders, each compiled once per device, and command encoding for them.

use nearfar_core::base::{Progress, Result};
use wgpu::{
    BindingResource, CommandEncoder, CommandEncoderDescriptor, ComputePassDescriptor, ComputePipeline,
    ComputePipelineDescriptor, PipelineCompilationOptions, ShaderModuleDescriptor, ShaderSource,
};

use crate::device::{Device, PipelineCache, Scope, Submission};

/// Maximum number of workgroups in one row of a dispatch; larger dispatches have several rows.
pub(crate) const ROW: u32 = 1 << 15;
/// Rows, pixels or points per workgroup.
pub(crate) const GROUP: u32 = 256;

/// An entry point of a shader with its constants.
pub(crate) struct Program<'a> {
    pub text: &'a [&'a str],
    pub entry: &'static str,
    pub constants: &'a [(&'static str, u32)],
    pub group: u32,
}

/// Compiled programs, by entry point and constants; entry points have unique names.
type Programs = PipelineCache<(&'static str, Vec<(&'static str, u32)>), ComputePipeline>;

impl Program<'_> {
    fn compile(&self, device: &Device) -> ComputePipeline {
        let constants = [("ROW", ROW), ("GROUP", GROUP)];
        let constants = constants.iter().chain(self.constants);
        let mut text: String = constants.map(|(name, value)| format!("const {name}: u32 = {value}u;\n")).collect();
        text.extend([include_str!("../shaders/compute.wgsl")].iter().chain(self.text).copied());
        let (label, source) = (Some(self.entry), ShaderSource::Wgsl(text.into()));
        let module = device.wgpu.create_shader_module(ShaderModuleDescriptor { label, source });
        device.wgpu.create_compute_pipeline(&ComputePipelineDescriptor {
            label,
            layout: None,
            module: &module,
            entry_point: label,
            // Not needed, because every kernel writes its workgroup memory before it reads it. On OpenGL it would be
            // one constant of thousands of numbers, which Mesa takes a minute to compile.
            compilation_options: PipelineCompilationOptions {
                zero_initialize_workgroup_memory: false,
                ..PipelineCompilationOptions::default()
            },
            cache: None,
        })
    }
}

/// Commands of one submission.
pub(crate) struct Work<'a> {
    device: &'a Device,
    pub encoder: CommandEncoder,
    scope: Scope<'a>,
}

impl<'a> Work<'a> {
    pub fn new(device: &'a Device) -> Self {
        let encoder = device.wgpu.create_command_encoder(&CommandEncoderDescriptor { label: Some("compute") });
        Self { device, encoder, scope: Scope::open(device) }
    }

    /// Encodes a program; resources come with their binding numbers.
    pub fn run(
        &mut self,
        program: &Program<'_>,
        resources: &[(u32, BindingResource<'_>)],
        groups: [u32; 2],
    ) -> Result<()> {
        let key = (program.entry, program.constants.to_vec());
        let pipeline = self.device.state::<Programs>().get(self.device, key, |_| program.compile(self.device))?;
        let layout = pipeline.get_bind_group_layout(program.group);
        let bindings = self.device.bind_group(&layout, resources.iter().cloned());
        let descriptor = ComputePassDescriptor { label: Some(program.entry), ..ComputePassDescriptor::default() };
        let mut pass = self.encoder.begin_compute_pass(&descriptor);
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(program.group, &bindings, &[]);
        pass.dispatch_workgroups(groups[0], groups[1], 1);
        Ok(())
    }

    /// Submits the commands; fails if the caller cancels the work.
    pub fn submit(self, progress: &Progress) -> Result<Submission> {
        let submission = self.device.submit(self.encoder.finish(), progress)?;
        self.scope.close()?;
        Ok(submission)
    }
}

/// Returns the workgroups for a number of rows, points or pixels.
pub(crate) fn groups(count: u32) -> [u32; 2] {
    let groups = count.div_ceil(GROUP).max(1);
    [groups.min(ROW), groups.div_ceil(ROW)]
}
