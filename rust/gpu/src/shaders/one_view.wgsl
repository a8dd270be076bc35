// Pass of the view that is drawn.
@group(1) @binding(0) var<uniform> view: Pass;
