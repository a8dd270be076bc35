//! The morph for engines: naga translates morph.wgsl and world.wgsl to GLSL and HLSL, which docs/engines/ and the page
//! include. `NEARFAR_WRITE=1 cargo test -p nearfar-gpu --test engines` writes the files, without it the test compares.

use std::{env, fs, path::Path};

use naga::back::{glsl, hlsl};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, ShaderStage};

const MORPH: &str = concat!(include_str!("../src/shaders/morph.wgsl"), "\n", include_str!("../src/shaders/world.wgsl"));

/// Calls the functions for engines: naga writes GLSL only for an entry point.
const ENTRY: &str = "@vertex fn main(@location(0) p: vec3<f32>) -> @builtin(position) vec4<f32> {
    let q = nearfar_morph(p, p, p, 1.0, 2.0, 1.0) + nearfar_morph_cylinder(p, p, p, 1.0, 2.0, 1.0);
    return vec4<f32>(q, nearfar_range_cylinder(p, 1.0, p, p));
}";

const HEADER: &str = "\
// The morph of nearfar in LANGUAGE: displayed position of a point of the world. Licence: MIT or Apache-2.0.
// Written by `NEARFAR_WRITE=1 cargo test -p nearfar-gpu --test engines`; docs/engines.md says how to use it, and
// docs/engines/morph.wgsl, from which naga translates it, has the comments.
//
// Call nearfar_morph or nearfar_morph_cylinder in the vertex stage; and, if points are morphed by the cylinder,
// nearfar_range_cylinder where the far map's range is read. Their parameters, in this order:
//   p              point of the world, any unit of length; y is up
//   user           position U of the eye that the picture is for, same unit and axes; each eye has its own
//   center         centre O of the reduction, from which the far map was baked, same unit and axes
//   r1, r2         radii of the near zone and of all geometry, same unit
//   strength       1 for the full morph. With less, near points move towards the direction in which the centre sees them,
//                  and reach it at 0; a client raises it from 0 to 1, so that geometry appears without a jump
// and of nearfar_range_cylinder:
//   direction      unit vector in which the map is looked up
//   range          value of the map: distance from the centre, same unit
//   user, center   as above
";

fn parse(text: &str) -> (Module, ModuleInfo) {
    let module = naga::front::wgsl::parse_str(text).unwrap();
    let info = Validator::new(ValidationFlags::all(), Capabilities::all()).validate(&module).unwrap();
    (module, info)
}

/// Returns functions for GLSL ES 3.00 and desktop GLSL, without version, precision and entry point.
fn to_glsl() -> String {
    let (module, info) = parse(&format!("{MORPH}\n{ENTRY}"));
    let options = glsl::Options { version: glsl::Version::new_gles(300), ..glsl::Options::default() };
    let pipeline =
        glsl::PipelineOptions { shader_stage: ShaderStage::Vertex, entry_point: "main".into(), multiview: None };
    let mut text = String::new();
    glsl::Writer::new(&mut text, &module, &info, &options, &pipeline, naga::proc::BoundsCheckPolicies::default())
        .unwrap()
        .write()
        .unwrap();
    let interface = text.find("\nlayout(").unwrap();
    let functions = text.find("float user_weight(").unwrap();
    let declarations = &text[text.find("struct ").unwrap()..interface];
    format!("{}\n\n{}", declarations.trim_end(), text[functions..text.find("void main()").unwrap()].trim_end())
}

fn to_hlsl() -> String {
    let (module, info) = parse(MORPH);
    let (mut text, options, pipeline) = (String::new(), hlsl::Options::default(), hlsl::PipelineOptions::default());
    hlsl::Writer::new(&mut text, &options, &pipeline).write(&module, &info, None).unwrap();
    text.trim_end().into()
}

/// Guards a text against a second inclusion.
fn once(language: &str, text: &str) -> String {
    format!("#ifndef NEARFAR_MORPH\n#define NEARFAR_MORPH\n{}\n{text}\n#endif\n", HEADER.replace("LANGUAGE", language))
}

#[test]
fn files_for_engines_are_the_translation_of_the_kernels() {
    let glsl = to_glsl();
    assert!(!glsl.contains(['`', '$', '\\']), "a template literal of TypeScript holds the text");
    let wgsl = HEADER.replace("LANGUAGE", "WGSL").replace(
        "docs/engines/morph.wgsl, from which naga translates it, has the comments",
        "rust/gpu/src/shaders has its two parts",
    );
    let page = format!(
        "// Written by `NEARFAR_WRITE=1 cargo test -p nearfar-gpu --test engines`.\n\n\
         /** docs/engines/morph.glsl, for GLSL ES 3.00; the shader around it states the precision of float. */\n\
         export const MORPH = `\\\n{glsl}\n`;\n"
    );
    let files = [
        ("docs/engines/morph.wgsl", format!("{wgsl}\n{MORPH}")),
        ("docs/engines/morph.glsl", once("GLSL", &glsl)),
        ("docs/engines/morph.hlsl", once("HLSL", &to_hlsl())),
        ("web/src/shaders/morph.ts", page),
    ];
    let checkout = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for (name, text) in files {
        if env::var_os("NEARFAR_WRITE").is_some() {
            fs::write(checkout.join(name), &text).unwrap();
        }
        let found = fs::read_to_string(checkout.join(name)).unwrap();
        assert!(found.replace("\r\n", "\n") == text, "{name} is out of date: set NEARFAR_WRITE=1 to write it");
    }
}
