var je=Object.defineProperty;var n=(e,t)=>je(e,"name",{value:t,configurable:!0});function fe(e,t){let r=1e6;for(let{layer:a}of e)r=Math.min(r,Math.max(a.model.pitch[0],a.model.pitch[1]));return t?Math.min(r/2,.05):r/2}n(fe,"nearDistanceOf");function pe(e,t,r){return Math.max(Math.min(e,Math.floor(r/t)),1)}n(pe,"gridOf");function ee({right:e,up:t,back:r,fov:a,width:i,height:o},s,l){let u=a.left+(a.right-a.left)*s/i,c=a.up+(a.down-a.up)*l/o,f=n(d=>u*e[d]+c*t[d]-r[d],"component");return[f(0),f(1),f(2)]}n(ee,"directionAt");function re(e,t){return[e[0]-t[0],e[1]-t[1],e[2]-t[2]]}n(re,"subtract");function te(e,t){return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}n(te,"dot");function se({cell:e},t){return e*2**t}n(se,"sideAt");function de(e,t,[r,a,i]){let[o,[s,l,u]]=[se(e,t),e.origin];return[s+r*o,l+a*o,u+i*o]}n(de,"cornerOf");var ie=1.27,Z=.5,le=.25,Ke=8,Q=10;function me(e,t){return[e[0]*t,e[1]*t,e[2]*t]}n(me,"scaleVector");function ye(e){let{position:t,right:r,up:a,back:i,fov:o,width:s,height:l}=e,[u,c]=[s/(o.right-o.left),l/(o.up-o.down)],f=n(x=>[x(0),x(1),x(2)],"gradient"),d=[f(x=>u*(r[x]+o.left*i[x])),f(x=>-c*(a[x]+o.up*i[x])),f(x=>-i[x])],v=ee(e,0,0),[h,P]=[ee(e,1,0),ee(e,0,1)];return{eye:t,rows:d,rays:[v,re(h,v),re(P,v)],width:s,height:l}}n(ye,"projectorOf");function ge(e,{eye:t,rows:r}){let{start:a,steps:i,pitch:o}=e,s=n(d=>[te(r[0],d),te(r[1],d),te(r[2],d)],"project"),[l,u]=[ie*Math.sqrt(Z),be(e)],c=n(d=>Math.max(l,u/d)-.5,"marginOf"),f=l*(o[0]+o[1])/le;return{start:s(re(a,t)),steps:[s(i[0]),s(i[1]),s(i[2])],minW:Math.max(o[0],o[1]),margin:[c(o[0]),c(o[1]),Math.max(f,u)/o[2]]}}n(ge,"projectView");function be({pitch:e}){return Math.hypot(e[0],e[1])/2}n(be,"ballRadius");function he(e,{low:t,high:r},a,i){let{start:o,steps:s,minW:l,margin:u}=e,[c,f,d,v,h]=[!0,!0,!0,!0,!0],P=Number.POSITIVE_INFINITY,x=[Number.POSITIVE_INFINITY,Number.POSITIVE_INFINITY],E=[Number.NEGATIVE_INFINITY,Number.NEGATIVE_INFINITY];for(let A=0;A<8;A++){let z=n(m=>A>>m&1?r[m]+u[m]:t[m]-u[m],"coordinate"),[w,U,G]=[z(0),z(1),z(2)],p=n(m=>o[m]+w*s[0][m]+U*s[1][m]+G*s[2][m],"valueOf"),[y,g,b]=[p(0),p(1),p(2)];c&&=y<-b,f&&=y>(a+1)*b,d&&=g<-b,v&&=g>(i+1)*b,h&&=b<l,P=Math.min(P,b),x[0]=Math.min(x[0],y/b),x[1]=Math.min(x[1],g/b),E[0]=Math.max(E[0],y/b),E[1]=Math.max(E[1],g/b)}if(c||f||d||v||h)return null;let L=P<l?Number.POSITIVE_INFINITY:1/P;return P<Ke*l?{low:[0,0],high:[a,i],nearness:L}:{low:[Math.max(Math.floor(x[0])-1,0),Math.max(Math.floor(x[1])-1,0)],high:[Math.min(Math.floor(E[0])+2,a),Math.min(Math.floor(E[1])+2,i)],nearness:L}}n(he,"boundsOf");function xe(e,{low:t,high:r}){return e.every(([a,i,o,s])=>{let[l,u]=[s,s];return[a,i,o].forEach((c,f)=>{let d=[c*t[f],c*r[f]];l+=Math.min(...d),u+=Math.max(...d)}),l<1&&u>=0})}n(xe,"mayLieIn");function we(e,t,r){if(!r)return[0,1,2].map(()=>[0,0,0,.5]);let a=se(t,r.level),i=de(t,r.level,r.place);return[0,1,2].map(o=>{let[s,l,u]=e.steps.map(c=>c[o]/a);return[s,l,u,(e.start[o]-i[o])/a]})}n(we,"boxFunctionsOf");function ve(e,t,r,a){let{frame:i,pitch:o}=t,[s,l,u]=i.axes,c=2/(2**t.normalBits-2),f=n((d,[v,h,P],x)=>e.set([v,h,P,x],4*d),"put");f(0,r.start,r.minW),f(1,r.steps[0],c),f(2,r.steps[1],be(t)/Math.sqrt(Z)),f(3,r.steps[2],0),f(4,me(s,o[0]/o[2]),0),f(5,me(l,o[1]/o[2]),0),f(6,u,0),a.forEach((d,v)=>e.set(d,4*(7+v)))}n(ve,"writeView");var D=class{constructor(t,r,a){this.device=t;this.label=r;this.usage=a}device;label;usage;static{n(this,"GrowingBuffer")}#e=null;reserve(t){if(this.#e&&this.#e.size>=t)return this.#e;this.#e?.destroy();let r=Math.max(2**Math.ceil(Math.log2(Math.max(t,1))),256),a=this.usage|GPUBufferUsage.COPY_DST;return this.#e=this.device.createBuffer({label:this.label,size:r,usage:a}),this.#e}write(t){let r=this.reserve(t.byteLength);return this.device.queue.writeBuffer(r,0,t),r}},Ye=1<<23,ne=64,oe=class{constructor(t){this.device=t}device;static{n(this,"Arena")}#e=[];put(t){let r=Math.max(Math.ceil(t.length/ne),1)*ne,{page:a,gap:i}=this.#t(r)??this.#n(r),o={page:a,first:i.first,words:r,bytes:4*r};return i.first+=r,i.words-=r,i.words===0&&a.gaps.splice(a.gaps.indexOf(i),1),this.device.queue.writeBuffer(a.buffer,4*o.first,t),o}free({page:t,first:r,words:a}){let{gaps:i}=t,o=i.findIndex(l=>l.first>r),s=o<0?i.length:o;i.splice(s,0,{first:r,words:a}),this.#r(i,s),this.#r(i,s-1),i[0]?.words===t.words&&(t.buffer.destroy(),this.#e.splice(this.#e.indexOf(t),1))}#r(t,r){let[a,i]=[t[r],t[r+1]];!a||!i||a.first+a.words!==i.first||(a.words+=i.words,t.splice(r+1,1))}#t(t){for(let r of this.#e){let a=r.gaps.find(i=>i.words>=t);if(a)return{page:r,gap:a}}return null}#n(t){let{maxBufferSize:r,maxStorageBufferBindingSize:a}=this.device.limits,i=Math.min(r,a),o=Math.floor(i/4/ne)*ne;if(t>o)throw new Error(`a view of ${4*t} bytes is larger than the graphics device allows`);let s=Math.min(Math.max(t,Ye),o),l=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_DST,u=this.device.createBuffer({label:"page of views",size:4*s,usage:l}),c={first:0,words:s},f={buffer:u,words:s,gaps:[c]};return this.#e.push(f),{page:f,gap:c}}};var qe={SUN_DIRECTION:[.5263158,.7894737,.3157895],SUN:[.6,.56,.5],SKY_DIRECTION:[-.2062843,.9282791,.3094264],SKY_LOW:[.13,.135,.15],SKY_HIGH:[.38,.42,.48],HORIZON:[.66,.74,.82],ZENITH:[.16,.34,.66],NADIR:[.24,.25,.26]},_e=["SUN_DIRECTION","SUN","SKY_DIRECTION","SKY_LOW","SKY_HIGH"],Pe=["HORIZON","ZENITH","NADIR"],j=n(e=>Number.isInteger(e)?e.toFixed(1):String(e),"float"),Te=n(e=>qe[e].map(j).join(", "),"vector"),Oe=n(e=>e.map(t=>`const vec3 ${t} = vec3(${Te(t)});`).join(`
`),"glsl"),Xe=n(e=>e.map(t=>`const ${t} = vec3<f32>(${Te(t)});`).join(`
`),"wgsl"),Nr=`
${Oe(_e)}

vec3 irradiance(vec3 n) {
float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`;var Cr=`
${Oe(Pe)}

vec3 background(vec3 direction) {
return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`;var K=`
${Xe([..._e,...Pe])}

fn irradiance(n: vec3<f32>) -> vec3<f32> {
let sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}

fn background(direction: vec3<f32>) -> vec3<f32> {
return mix(HORIZON, select(ZENITH, NADIR, direction.y < 0.0), sqrt(abs(direction.y)));
}

fn srgb_of(linear: vec3<f32>) -> vec3<f32> {
let c = clamp(linear, vec3<f32>(0.0), vec3<f32>(1.0));
return select(1.055 * pow(c, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * c, c <= vec3<f32>(0.0031308));
}

fn linear_of(c: vec3<f32>) -> vec3<f32> {
return select(pow((c + 0.055) / 1.055, vec3<f32>(2.4)), c / 12.92, c <= vec3<f32>(0.04045));
}
`;var k=64,Y=16384,J=16,q=`
struct Draw {
gradients: array<vec4<f32>, 3>,
rays: array<vec4<f32>, 3>,
size: vec4<u32>,
work: vec4<u32>,
all: vec4<u32>,
nearest: f32,
}

@group(0) @binding(0) var<uniform> draw: Draw;
`,Se=`
@compute @workgroup_size(GROUP)
fn farthest_of_tiles(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
let number = (group.y * ROW + group.x) * GROUP + lane;
let rows = (draw.size.y + TILE - 1u) / TILE;
if number >= tile_columns() * rows {
return;
}
let first = vec2<u32>(number % tile_columns(), number / tile_columns()) * TILE;
let end = min(first + TILE, draw.size.xy);
var farthest = 0xffffffffu;
for (var y = first.y; y < end.y; y++) {
for (var x = first.x; x < end.x; x++) {
farthest = min(farthest, atomicLoad(&depth_bits[y * draw.size.x + x]));
}
}
atomicStore(&tiles[1u + number], farthest);
}
`,Ge=`
${q}
@group(0) @binding(1) var depths: texture_depth_2d;
@group(0) @binding(2) var<storage, read_write> depth_bits: array<u32>;

@compute @workgroup_size(${k})
fn begin(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
let sample = (group.y * ${Y}u + group.x) * ${k}u + lane;
if sample >= draw.size.x * draw.size.y {
return;
}
let position = vec2<u32>(sample % draw.size.x, sample / draw.size.x);
depth_bits[sample] = bitcast<u32>(textureLoad(depths, position, 0));
}
`,Ue=`
${q}
@group(0) @binding(1) var geometry: texture_2d<f32>;
@group(0) @binding(2) var<storage, read> depth_bits: array<u32>;
@group(0) @binding(3) var<storage, read> colors: array<u32>;
${K}
@vertex
fn cover_picture(@builtin(vertex_index) n: u32) -> @builtin(position) vec4<f32> {
return vec4<f32>(f32(n & 1u) * 4.0 - 1.0, f32(n >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn resolve(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
let grid = draw.size.w;
let first = vec2<u32>(pixel.xy) * grid;
var sum = vec3<f32>(0.0);
for (var row = 0u; row < grid; row++) {
for (var column = 0u; column < grid; column++) {
let position = first + vec2<u32>(column, row);
let in_band = vec2<u32>(position.x, position.y - draw.size.z);
let sample = in_band.y * draw.size.x + in_band.x;
let code = colors[sample];
if code != 0u {
let bits = vec3<u32>(code >> 20u, code >> 10u, code) & vec3<u32>(1023u);
sum += linear_of(vec3<f32>(bits) / 1023.0);
} else if depth_bits[sample] != 0u {
sum += textureLoad(geometry, in_band, 0).rgb;
} else {
let center = vec2<f32>(position) + 0.5;
sum += background(normalize(draw.rays[0].xyz + center.x * draw.rays[1].xyz + center.y * draw.rays[2].xyz));
}
}
}
return vec4<f32>(srgb_of(sum / f32(grid * grid)), 1.0);
}
`;var Ze=256,Be=`
${q}
struct Part {
view: u32,
first: u32,
count: u32,
number: u32,
nearest_bits: u32,
low: u32,
high: u32,
page: u32,
}

@group(0) @binding(1) var<storage, read> views: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> parts: array<Part>;
@group(0) @binding(3) var<storage, read> part_order: array<u32>;
@group(0) @binding(4) var<storage, read> words: array<u32>;
@group(0) @binding(5) var<storage, read_write> tiles: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> depth_bits: array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> colors: array<atomic<u32>>;
${K}
const TILE = ${J}u;
const GROUP = ${k}u;
const ROW = ${Y}u;
const BATCH = 1024u;
const RADIUS = ${j(Math.sqrt(Z))};
const SQUARED_RADIUS = ${j(Z)};

struct Ellipse {
middle: vec2<f32>,
inverse: vec4<f32>,
nearness: vec3<f32>,
low: vec2<i32>,
high: vec2<i32>,
normal: vec3<f32>,
code: u32,
}

const SLACK = 4u;
const LAST = 0x7fffffffu;
const COLOR = 0x80000000u;

fn view_vector(view: u32, n: u32) -> vec4<f32> {
return views[view * ${Q}u + n];
}

fn half_extent(view: u32, gradient: vec3<f32>, ratio: f32, inverse_w: f32) -> f32 {
return length((gradient - ratio * draw.gradients[2].xyz) * inverse_w) * view_vector(view, 2u).w;
}

fn normal_of(codes: u32, scale: f32) -> vec3<f32> {
let flat = vec2<f32>(f32(codes & 4095u), f32((codes >> 12u) & 4095u)) * scale - 1.0;
let z = 1.0 - abs(flat.x) - abs(flat.y);
let fold = max(-z, 0.0);
return normalize(vec3<f32>(flat - select(vec2<f32>(fold), vec2<f32>(-fold), flat < vec2<f32>(0.0)), z));
}

fn ellipse_of(part: Part, number: u32) -> Ellipse {
let word_index = part.first + 3u * number;
let word = vec3<u32>(words[word_index], words[word_index + 1u], words[word_index + 2u]);
let view = part.view;
let column = view_vector(view, 1u);
let row = view_vector(view, 2u);
let step = view_vector(view, 3u).xyz;
let depth = f32(((word.x >> 24u) << 8u) | (word.y >> 24u)) - 0.5;
let p = vec3<f32>(f32(word.z & 4095u) + 0.5, f32((word.z >> 12u) & 4095u) + 0.5, depth);
let box_x = view_vector(view, 7u);
let box_y = view_vector(view, 8u);
let box_z = view_vector(view, 9u);
let inside = vec3<f32>(dot(box_x.xyz, p) + box_x.w, dot(box_y.xyz, p) + box_y.w, dot(box_z.xyz, p) + box_z.w);
let start = view_vector(view, 0u);
let xyw = start.xyz + p.x * column.xyz + p.y * row.xyz + p.z * step;
let inverse_w = 1.0 / xyw.z;
let middle = xyw.xy * inverse_w;

var normal = normal_of(word.y, column.w);
let facing = 1.0 / max(dot(view_vector(view, 6u).xyz, normal), ${j(le)});
let u = column.xyz + dot(view_vector(view, 4u).xyz, normal) * facing * step;
let v = row.xyz - dot(view_vector(view, 5u).xyz, normal) * facing * step;
let is_surfel = ((word.z >> 24u) & 1u) == 1u;
let factor = select(0.0, select(${j(ie)}, 1.0, ((word.z >> 25u) & 1u) == 1u), is_surfel);

var ellipse: Ellipse;
ellipse.middle = middle;
ellipse.nearness = vec3<f32>(inverse_w, 0.0, 0.0);
let du = (u.xy - middle * u.z) * inverse_w * factor;
let dv = (v.xy - middle * v.z) * inverse_w * factor;
let slope = -vec2<f32>(u.z, v.z) * inverse_w * inverse_w * factor;
var half_size = vec2<f32>(0.0);
if is_surfel {
let determinant = du.x * dv.y - dv.x * du.y;
let is_flat = abs(determinant) <= 1.2e-7 * (abs(du.x) + abs(dv.x)) * (abs(du.y) + abs(dv.y));
if is_flat {
ellipse.inverse = vec4<f32>(1e9);
} else {
let inverse = vec4<f32>(dv.y, -dv.x, -du.y, du.x) / determinant;
ellipse.inverse = inverse;
ellipse.nearness.y = slope.x * inverse.x + slope.y * inverse.z;
ellipse.nearness.z = slope.x * inverse.y + slope.y * inverse.w;
half_size = RADIUS * sqrt(vec2<f32>(du.x * du.x + dv.x * dv.x, du.y * du.y + dv.y * dv.y));
}
} else {
let ball = vec2<f32>(
half_extent(view, draw.gradients[0].xyz, middle.x, inverse_w),
half_extent(view, draw.gradients[1].xyz, middle.y, inverse_w),
);
ellipse.inverse = vec4<f32>(1.0 / ball.x, 0.0, 0.0, 1.0 / ball.y);
half_size = RADIUS * ball;
}
let first = f32(draw.size.z);
let first_sample = vec2<f32>(0.0, first);
let last_sample = vec2<f32>(f32(draw.size.x), first + f32(draw.size.y)) - 1.0;
ellipse.low = vec2<i32>(max(min(ceil(middle - half_size - 0.5), floor(middle)), first_sample));
ellipse.high = vec2<i32>(min(max(floor(middle + half_size - 0.5), floor(middle)), last_sample));
ellipse.code = word.x & 0xffffffu;
ellipse.normal = normal;
let is_shown = xyw.z - RADIUS * factor * length(vec2<f32>(u.z, v.z)) >= start.w
&& all(inside >= vec3<f32>(0.0)) && all(inside < vec3<f32>(1.0));
if !is_shown {
ellipse.low = vec2<i32>(0);
ellipse.high = vec2<i32>(-1);
}
return ellipse;
}

fn cover(ellipse: Ellipse, position: vec2<i32>, number: u32) {
let p = vec2<f32>(position) + 0.5 - ellipse.middle;
let q = vec2<f32>(dot(ellipse.inverse.xy, p), dot(ellipse.inverse.zw, p));
let is_inside = dot(q, q) <= SQUARED_RADIUS;
if !is_inside && any(position != vec2<i32>(floor(ellipse.middle))) {
return;
}
let nearness = ellipse.nearness.x + select(0.0, dot(ellipse.nearness.yz, p), is_inside);
let bits = bitcast<u32>(clamp(draw.nearest * nearness, 1e-30, 1.0));
let sample = (u32(position.y) - draw.size.z) * draw.size.x + u32(position.x);
if draw.work.z == 0u {
atomicMax(&depth_bits[sample], bits);
} else if bits + SLACK >= atomicLoad(&depth_bits[sample]) {
atomicMax(&colors[sample], LAST - number);
}
}

fn extent_of(ellipse: Ellipse) -> vec2<u32> {
return vec2<u32>(max(ellipse.high - ellipse.low + 1, vec2<i32>(0)));
}

fn tiles_of(part: Part) -> vec4<u32> {
let low = vec2<u32>(part.low & 0xffffu, max(part.low >> 16u, draw.size.z) - draw.size.z);
let bottom = min(part.high >> 16u, draw.size.z + draw.size.y);
let high = vec2<u32>(part.high & 0xffffu, max(bottom, draw.size.z) - draw.size.z);
if any(high <= low) {
return vec4<u32>(0u);
}
return vec4<u32>(low / TILE, (high + TILE - 1u) / TILE - low / TILE);
}

fn tile_columns() -> u32 {
return (draw.size.x + TILE - 1u) / TILE;
}

var<workgroup> is_reached: atomic<u32>;
var<workgroup> is_visible: u32;
var<workgroup> large_count: atomic<u32>;
var<workgroup> large: array<u32, BATCH>;

@compute @workgroup_size(GROUP)
fn splats(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
let number = group.y * ROW + group.x;
if number >= draw.work.y {
return;
}
let part = parts[draw.work.x + number];
let part_tiles = tiles_of(part);
for (var n = lane; n < part_tiles.z * part_tiles.w; n += GROUP) {
let tile = (part_tiles.y + n / part_tiles.z) * tile_columns() + part_tiles.x + n % part_tiles.z;
if atomicLoad(&tiles[1u + tile]) <= part.nearest_bits {
atomicStore(&is_reached, 1u);
}
}
workgroupBarrier();
if lane == 0u {
is_visible = atomicLoad(&is_reached);
if is_visible == 1u && draw.work.z == 0u {
atomicAdd(&tiles[0], part.count);
}
}
if workgroupUniformLoad(&is_visible) == 0u {
return;
}
for (var first = 0u; first < part.count; first += BATCH) {
let end = min(first + BATCH, part.count);
for (var n = first + lane; n < end; n += GROUP) {
let ellipse = ellipse_of(part, n);
let extent = extent_of(ellipse);
if extent.x * extent.y > ${Ze}u {
large[atomicAdd(&large_count, 1u)] = n;
continue;
}
for (var y = ellipse.low.y; y <= ellipse.high.y; y++) {
for (var x = ellipse.low.x; x <= ellipse.high.x; x++) {
cover(ellipse, vec2<i32>(x, y), part.number + n);
}
}
}
workgroupBarrier();
let count = atomicLoad(&large_count);
for (var large_index = 0u; large_index < count; large_index++) {
let n = large[large_index];
let ellipse = ellipse_of(part, n);
let extent = extent_of(ellipse);
for (var position = lane; position < extent.x * extent.y; position += GROUP) {
cover(ellipse, ellipse.low + vec2<i32>(vec2<u32>(position % extent.x, position / extent.x)), part.number + n);
}
}
workgroupBarrier();
if lane == 0u {
atomicStore(&large_count, 0u);
}
workgroupBarrier();
}
}

fn part_of(splat: u32) -> u32 {
var low = 0u;
var high = draw.all.x;
while high - low > 1u {
let middle = (low + high) / 2u;
if parts[part_order[middle]].number <= splat {
low = middle;
} else {
high = middle;
}
}
return part_order[low];
}

@compute @workgroup_size(GROUP)
fn shade(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
let sample = (group.y * ROW + group.x) * GROUP + lane;
if sample >= draw.size.x * draw.size.y {
return;
}
let code = atomicLoad(&colors[sample]);
if code == 0u || (code & COLOR) != 0u {
return;
}
let part = parts[part_of(LAST - code)];
if part.page != draw.all.y {
return;
}
let ellipse = ellipse_of(part, LAST - code - part.number);
let ray = draw.rays[0].xyz + ellipse.middle.x * draw.rays[1].xyz + ellipse.middle.y * draw.rays[2].xyz;
let normal = select(ellipse.normal, -ellipse.normal, dot(ellipse.normal, ray) > 0.0);
let bytes = vec3<u32>(ellipse.code, ellipse.code >> 8u, ellipse.code >> 16u) & vec3<u32>(255u);
let albedo = linear_of(vec3<f32>(bytes) / 255.0);
let bits = vec3<u32>(srgb_of(albedo * irradiance(normal)) * 1023.0 + 0.5);
atomicStore(&colors[sample], COLOR | (bits.x << 20u) | (bits.y << 10u) | bits.z);
}
${Se}`;function Ee(e,t){let r=n((E,L)=>{let A=[{buffer:{hasDynamicOffset:!0}},...L];return e.createBindGroupLayout({entries:A.map((z,w)=>({binding:w,visibility:E,...z}))})},"layoutOf"),{COMPUTE:a,FRAGMENT:i,VERTEX:o}=GPUShaderStage,s={buffer:{type:"read-only-storage"}},l={buffer:{type:"storage"}},u=r(o|i,[]),c=r(a,[s,s,s,s,l,l,l]),f=r(a,[{texture:{sampleType:"depth"}},l]),d=r(i,[{texture:{sampleType:"unfilterable-float"}},s,s]),v=n((E,L)=>e.createShaderModule({label:E,code:L}),"moduleOf"),h=n((E,L,A)=>e.createComputePipeline({label:A,layout:e.createPipelineLayout({bindGroupLayouts:[E]}),compute:{module:L,entryPoint:A}}),"computePipeline"),[P,x]=[v("splats",Be),v("resolve",Ue)];return{uniformLayout:u,splatLayout:c,beginLayout:f,resolveLayout:d,splats:h(c,P,"splats"),tiles:h(c,P,"farthest_of_tiles"),shade:h(c,P,"shade"),begin:h(f,v("begin",Ge),"begin"),resolve:e.createRenderPipeline({label:"resolve",layout:e.createPipelineLayout({bindGroupLayouts:[d]}),vertex:{module:x},fragment:{module:x,targets:[{format:t}]}})}}n(Ee,"kernelsOf");var ae=class{constructor(t,r){this.common=t;this.#e=new ArrayBuffer(256*r)}common;static{n(this,"Uniforms")}#e;#r=0;get all(){return new Uint32Array(this.#e)}put(t,{first:r=0,count:a=0,round:i=0,page:o=0}){let{projector:s,grid:l,nearest:u,parts:c}=this.common,f=256*this.#r,d=new Float32Array(this.#e,f,256/4);return[...s.rows,...s.rays].forEach((v,h)=>d.set(v,4*h)),new Uint32Array(this.#e,f+96,12).set([s.width,t.rows,t.first,l,r,a,i,0,c,o,0,0]),d[36]=u,this.#r+=1,f}};var Me=`
${q}
struct Mesh {
offset: vec4<f32>,
base: vec4<f32>,
emission: vec4<f32>,
}

@group(1) @binding(0) var<uniform> mesh: Mesh;
@group(2) @binding(0) var image: texture_2d<f32>;
@group(2) @binding(1) var glow: texture_2d<f32>;
@group(2) @binding(2) var smooth_texels: sampler;
${K}
struct Corner {
@builtin(position) place: vec4<f32>,
@location(0) point: vec3<f32>,
@location(1) normal: vec3<f32>,
@location(2) uv: vec2<f32>,
@location(3) color: vec3<f32>,
}

@vertex
fn transform(
@location(0) position: vec3<f32>,
@location(1) normal: vec3<f32>,
@location(2) uv: vec2<f32>,
@location(3) color: vec4<f32>,
@location(4) row_x: vec4<f32>,
@location(5) row_y: vec4<f32>,
@location(6) row_z: vec4<f32>,
) -> Corner {
let at = vec4<f32>(position, 1.0);
var out: Corner;
out.point = vec3<f32>(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + mesh.offset.xyz;
let cofactors = mat3x3<f32>(cross(row_y.xyz, row_z.xyz), cross(row_z.xyz, row_x.xyz), cross(row_x.xyz, row_y.xyz));
out.normal = normal * cofactors;
out.uv = uv;
out.color = color.rgb;
let p = out.point;
let xyw = vec3<f32>(dot(draw.gradients[0].xyz, p), dot(draw.gradients[1].xyz, p), dot(draw.gradients[2].xyz, p));
let row = xyw.y - f32(draw.size.z) * xyw.z;
let clip = vec2<f32>(2.0 * xyw.x / f32(draw.size.x) - xyw.z, xyw.z - 2.0 * row / f32(draw.size.y));
out.place = vec4<f32>(clip, draw.nearest, xyw.z);
return out;
}

fn shading_normal(corner: Corner, face_normal: vec3<f32>) -> vec3<f32> {
let toward = -normalize(corner.point);
let face_length = length(face_normal);
var face = select(toward, face_normal / face_length, face_length > 0.0);
face = select(face, -face, dot(face, toward) < 0.0);
let vertex_length = length(corner.normal);
if vertex_length == 0.0 {
return face;
}
let n = corner.normal / vertex_length;
return select(n, -n, dot(n, face) < 0.0);
}

fn level_of(texture: texture_2d<f32>, right: vec2<f32>, down: vec2<f32>) -> f32 {
let size = vec2<f32>(textureDimensions(texture));
let dx = right * size;
let dy = down * size;
return 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
}

@fragment
fn shade(corner: Corner) -> @location(0) vec4<f32> {
let normal = shading_normal(corner, cross(dpdx(corner.point), dpdy(corner.point)));
let right = dpdx(corner.uv);
let down = dpdy(corner.uv);
let texel = textureSampleLevel(image, smooth_texels, corner.uv, level_of(image, right, down));
let light = textureSampleLevel(glow, smooth_texels, corner.uv, level_of(glow, right, down)).rgb;
let alpha = mesh.base.a * textureSampleLevel(image, smooth_texels, corner.uv, 0.0).a;
if alpha < mesh.offset.w {
discard;
}
let albedo = mesh.base.rgb * corner.color * texel.rgb;
return vec4<f32>(albedo * mix(irradiance(normal), vec3<f32>(1.0), mesh.emission.w) + mesh.emission.rgb * light, 1.0);
}
`,Re=`
@group(0) @binding(0) var finer: texture_2d<f32>;
@group(0) @binding(1) var smooth_texels: sampler;

struct Corner {
@builtin(position) place: vec4<f32>,
@location(0) uv: vec2<f32>,
}

@vertex
fn cover_picture(@builtin(vertex_index) n: u32) -> Corner {
let at = vec2<f32>(f32(n & 1u) * 2.0, f32(n >> 1u) * 2.0);
return Corner(vec4<f32>(at.x * 2.0 - 1.0, 1.0 - at.y * 2.0, 0.0, 1.0), at);
}

@fragment
fn level(corner: Corner) -> @location(0) vec4<f32> {
return textureSampleLevel(finer, smooth_texels, corner.uv, 0.0);
}
`;var V="rgba8unorm-srgb",ue="depth32float",Qe=[{format:"float32x3",stride:12},{format:"float32x3",stride:12},{format:"float32x2",stride:8},{format:"unorm16x4",stride:8}],Je=0,er=12;function Le(e,t){let r=e.createShaderModule({label:"meshes",code:Me}),a=GPUShaderStage.FRAGMENT,o=[{texture:{}},{texture:{}},{sampler:{}}].map((w,U)=>({binding:U,visibility:a,...w})),s=e.createBindGroupLayout({entries:o}),l=[t,t,s],u=e.createPipelineLayout({bindGroupLayouts:l}),c=tr(e),f=e.createSampler({addressModeU:"repeat",addressModeV:"repeat",minFilter:"linear",magFilter:"linear",mipmapFilter:"linear"}),d=z(new Uint32Array([0,0,0,4294967295,4294967295]),GPUBufferUsage.VERTEX),v=new Map,h=new D(e,"meshes",GPUBufferUsage.UNIFORM);A(!0,!0,!0,!0);function P(w){let{positions:U,normals:G,uvs:p,colors:y,placements:g,indices:b}=w,m=[U,G,p,y,g].map(T=>T&&z(T,GPUBufferUsage.VERTEX)),O=[w.image,w.glow],S=[...m,z(b,GPUBufferUsage.INDEX)],_=S.reduce((T,M)=>T+(M?.size??0),0);for(let T of O)_+=T?Math.ceil(16*T.width*T.height/3):0;let B=O.map(T=>T&&c.upload(T));return{origin:w.origin,material:w.material,pipeline:A(!0,G!==null,p!==null,y!==null),buffers:m,indices:S.at(-1),format:b instanceof Uint16Array?"uint16":"uint32",corners:b.length,instances:g.length/12,textures:B,group:L(B),bytes:_}}n(P,"upload");function x({buffers:w,indices:U,textures:G}){for(let p of[...w,U,...G])p?.destroy()}n(x,"drop");function E(w,U,G){let p=new Float32Array(256/4*U.length);U.forEach((b,m)=>p.set(rr(b,G),256/4*m));let y={buffer:h.write(p),size:256},g=e.createBindGroup({layout:t,entries:[{binding:0,resource:y}]});return U.reduce((b,m,O)=>(w.setPipeline(m.pipeline),w.setBindGroup(1,g,[256*O]),w.setBindGroup(2,m.group),m.buffers.forEach((S,_)=>{S?w.setVertexBuffer(_,S):w.setVertexBuffer(_,d,_===3?er:Je)}),w.setIndexBuffer(m.indices,m.format),w.drawIndexed(m.corners,m.instances),b+m.corners/3*m.instances),0)}n(E,"record");function L(w){let G=[...w.map(p=>(p??c.white).createView()),f].map((p,y)=>({binding:y,resource:p}));return e.createBindGroup({layout:s,entries:G})}n(L,"groupOf");function A(...w){let U=w.join(),G=v.get(U);if(G)return G;let p=Qe.map(({format:m,stride:O},S)=>({arrayStride:w[S]?O:0,attributes:[{shaderLocation:S,offset:0,format:m}]})),y=[0,1,2].map(m=>({shaderLocation:4+m,offset:16*m,format:"float32x4"})),g={arrayStride:48,stepMode:"instance",attributes:y},b=e.createRenderPipeline({label:"meshes",layout:u,vertex:{module:r,buffers:[...p,g]},fragment:{module:r,targets:[{format:V}]},depthStencil:{format:ue,depthWriteEnabled:!0,depthCompare:"greater"}});return v.set(U,b),b}n(A,"pipelineOf");function z(w,U){let G=4*Math.ceil(Math.max(w.byteLength,4)/4),p=e.createBuffer({label:"mesh",size:G,usage:U,mappedAtCreation:!0});return new Uint8Array(p.getMappedRange()).set(new Uint8Array(w.buffer,w.byteOffset,w.byteLength)),p.unmap(),p}return n(z,"bufferOf"),{upload:P,drop:x,record:E}}n(Le,"createMeshes");function rr({origin:e,material:t},r){let{color:a,cutoff:i,emission:o,isUnlit:s}=t;return[...[e[0]-r[0],e[1]-r[1],e[2]-r[2]],i??-1,...a,...o??[0,0,0],s?1:0]}n(rr,"uniformsOf");function tr(e){let t=e.createShaderModule({label:"mipmaps",code:Re}),r=e.createRenderPipeline({label:"mipmaps",layout:"auto",vertex:{module:t},fragment:{module:t,targets:[{format:V}]}}),a=e.createSampler({minFilter:"linear",magFilter:"linear"}),i=s(1,1);e.queue.writeTexture({texture:i},new Uint8Array([255,255,255,255]),{},[1,1]);function o(u){let{width:c,height:f}=u,d=s(c,f);e.queue.copyExternalImageToTexture({source:u},{texture:d},[c,f]),u.close();let v=e.createCommandEncoder();for(let h=1;h<d.mipLevelCount;h++)l(v,d,h);return e.queue.submit([v.finish()]),d}n(o,"upload");function s(u,c){return e.createTexture({label:"image",size:[u,c],format:V,mipLevelCount:1+Math.floor(Math.log2(Math.max(u,c))),usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST|GPUTextureUsage.RENDER_ATTACHMENT})}n(s,"createTexture");function l(u,c,f){let d=n(x=>c.createView({baseMipLevel:x,mipLevelCount:1}),"view"),v={view:d(f),loadOp:"clear",storeOp:"store"},h=u.beginRenderPass({colorAttachments:[v]});h.setPipeline(r);let P=[{binding:0,resource:d(f-1)},{binding:1,resource:a}];h.setBindGroup(0,e.createBindGroup({layout:r.getBindGroupLayout(0),entries:P})),h.draw(3),h.end()}return n(l,"drawMipmap"),{white:i,upload:o}}n(tr,"createTextures");var nr=1<<26;function ze(e,t,r,a){let{maxStorageBufferBindingSize:i,maxTextureDimension2D:o}=e.limits,s=Math.min(Math.min(i,nr)/(4*t),o),l=Math.max(Math.floor(s/a),1)*a;return Array.from({length:Math.ceil(r/l)},(u,c)=>({number:c,first:c*l,rows:Math.min(l,r-c*l)}))}n(ze,"bandsOf");function ce(e,t){return Math.ceil(e/J)*Math.ceil(t/J)}n(ce,"tilesOf");function Ie(e){let t=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_SRC,r=n(l=>new D(e,l,t),"storage"),[a,i,o]=[r("depthBits"),r("colors"),r("tiles")],s=null;return{get counts(){return o.reserve(0)},buffers(l,u){let c=4*l*u,f=4*(1+ce(l,u));return{depthBits:a.reserve(c),colors:i.reserve(c),tiles:o.reserve(f)}},targets(l,u){if(s&&s.color.width===l&&s.color.height===u)return s;s?.color.destroy(),s?.depth.destroy();let c=GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.TEXTURE_BINDING,f=n(d=>e.createTexture({label:"samples",size:[l,u],format:d,usage:c}),"create");return s={color:f(V),depth:f(ue)},s}}}n(Ie,"createSamples");var Ne=3;var Ce=8,or=[1/16,1/8,1/4,1/2];function Fe(e,t,r,a){let i=[],o=[],s=new Float32Array(4*Q),l=0;for(let{layer:u,box:c}of e){let f=ge(u.model,t),d=we(u.model,r,c),v=i.length/(4*Q),h=o.length;for(let P of u.parts){let x=he(f,P,t.width,t.height);if(!x||c&&!xe(d,P))continue;let E=u.first+Ne*P.first;o.push({view:v,firstWord:E,firstSplat:l,count:P.count,bounds:x,page:u.page}),l+=P.count}o.length!==h&&(ve(s,u.model,f,d),i.push(...s))}return{views:new Float32Array(i),splats:l,...lr(o,l,a)}}n(Fe,"workOf");var[ar,sr]=(e=>[new Float32Array(e),new Uint32Array(e)])(new ArrayBuffer(4));function ir(e){return ar[0]=e,sr[0]+(Number.isFinite(e)?1:0)}n(ir,"upperBitsOf");function lr(e,t,r){let a=[...e].sort((c,f)=>ur(f.bounds.nearness,c.bounds.nearness)),i=[...new Set(e.map(({page:c})=>c))],o=new Uint32Array(Ce*e.length),s=new Map,l=[];for(let c of fr(a,t)){let f=!0;for(let d of i){let v=c.filter(h=>h.page===d);if(v.length!==0){l.push({page:d,startsBatch:f,first:s.size,count:v.length}),f=!1;for(let h of v)o.set(cr(h,i.indexOf(d),r),Ce*s.size),s.set(h,s.size)}}}let u=new Uint32Array(e.map(c=>s.get(c)));return{parts:o,partOrder:u,pages:i,calls:l}}n(lr,"assignCalls");function ur(e,t){return+(e>t)-+(e<t)}n(ur,"compareNumbers");function cr(e,t,r){let{view:a,firstWord:i,firstSplat:o,count:s,bounds:l}=e,[u,c]=[l.low,l.high].map(([f,d])=>f|d<<16);return[a,i,s,o,ir(r*l.nearness),u,c,t]}n(cr,"wordsOf");function fr(e,t){let r=[[]],[a,i]=[0,0];for(let o of e){let s=or.filter(l=>a>=t*l).length;s>i&&r.push([]),i=s,r.at(-1)?.push(o),a+=o.count}return r.filter(o=>o.length>0)}n(fr,"batchesOf");function ke(e,t,r,a,i){let o=new oe(r),s=Ie(r),l=new D(r,"calls",GPUBufferUsage.UNIFORM),u=n(p=>new D(r,p,GPUBufferUsage.STORAGE),"storage"),[c,f,d]=[u("views"),u("parts"),u("partOrder")],v=r.createTexture({size:[1,1],format:V,usage:GPUTextureUsage.TEXTURE_BINDING}),h=Promise.resolve(),P=0,x=null;function E(p,y,g,b){let m=pe(b,g.width,r.limits.maxTextureDimension2D),O=ye({...g,width:g.width*m,height:g.height*m}),S=fe(y,p.length>0),_=Fe(y,O,t,S),B=ze(r,O.width,O.height,m),T=B.length*(1+4*_.calls.length+_.pages.length),M=r.createCommandEncoder(),R={encoder:M,meshes:p,projector:O,grid:m,rows:B[0]?.rows??0,work:_,uniforms:new ae({projector:O,grid:m,nearest:S,parts:_.partOrder.length},T),uniformBinding:{buffer:l.reserve(256*T),size:256},views:c.write(_.views),parts:f.write(_.parts),partOrder:d.write(_.partOrder),target:e.getCurrentTexture().createView()},C=0;for(let X of B)C=L(R,X);l.write(R.uniforms.all),U(M,B);let W=2*_.calls.length+_.pages.length+p.length;return{splats:_.splats,triangles:C,calls:B.length*W}}n(E,"draw");function L(p,y){let{encoder:g,meshes:b,projector:m}=p,O=4*m.width*y.rows,{depthBits:S,colors:_,tiles:B}=s.buffers(m.width,y.rows),T=b.length>0?s.targets(m.width,p.rows):null;y.number===0&&g.clearBuffer(B,0,4),g.clearBuffer(_,0,O);let M=p.uniforms.put(y,{}),R=0;if(T){R=A(p,y,M,T);let X=[p.uniformBinding,T.depth.createView(),{buffer:S}],H=g.beginComputePass({label:"begin"});H.setPipeline(a.begin),H.setBindGroup(0,G(a.beginLayout,X),[M]),De(H,Math.ceil(m.width*y.rows/k)),H.end()}else g.clearBuffer(S,0,O);z(p,y,[{buffer:B},{buffer:S},{buffer:_}]);let C=(T?.color??v).createView(),W=[p.uniformBinding,C,{buffer:S},{buffer:_}];return w(p,y,M,G(a.resolveLayout,W)),R}n(L,"drawBand");function A(p,{rows:y},g,{color:b,depth:m}){let{encoder:O,meshes:S,projector:_,uniformBinding:B}=p,T=m.createView(),M=O.beginRenderPass({label:"meshes",colorAttachments:[{view:b.createView(),loadOp:"clear",storeOp:"store"}],depthStencilAttachment:{view:T,depthClearValue:0,depthLoadOp:"clear",depthStoreOp:"store"}});M.setViewport(0,0,_.width,y,0,1),M.setBindGroup(0,G(a.uniformLayout,[B]),[g]);let R=i.record(M,S,_.eye);return M.end(),R}n(A,"drawMeshes");function z(p,y,g){let{encoder:b,projector:m,work:O,uniforms:S,uniformBinding:_,views:B,parts:T,partOrder:M}=p,R=new Map;for(let F of O.pages){let $=[B,T,M,F.buffer].map(N=>({buffer:N}));R.set(F,G(a.splatLayout,[_,...$,...g]))}let C=b.beginComputePass({label:"splats"}),W=n((F,$,N,He)=>{C.setPipeline(F),C.setBindGroup(0,R.get($),[S.put(y,He)]),De(C,N)},"call"),{splats:X,tiles:H,shade:We}=a,$e=Math.ceil(ce(m.width,y.rows)/k);for(let F of[0,1])for(let[$,N]of O.calls.entries())N.startsBatch&&(F===0||$===0)&&W(H,N.page,$e,{}),W(X,N.page,N.count,{first:N.first,count:N.count,round:F});let Ve=Math.ceil(m.width*y.rows/k);for(let[F,$]of O.pages.entries())W(We,$,Ve,{page:F});C.end()}n(z,"drawSplats");function w(p,{number:y,first:g,rows:b},m,O){let{encoder:S,projector:_,grid:B,target:T}=p,M={view:T,loadOp:y===0?"clear":"load",storeOp:"store"},R=S.beginRenderPass({label:"show",colorAttachments:[M]});R.setPipeline(a.resolve),R.setBindGroup(0,O,[m]),R.setScissorRect(0,g/B,_.width/B,b/B),R.draw(3),R.end()}n(w,"show");function U(p,y){let g=r.createBuffer({size:4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST});y.length>0&&p.copyBufferToBuffer(s.counts,0,g,0,4),r.queue.submit([p.finish()]),P+=1;let b=n(()=>{x=new Uint32Array(g.getMappedRange())[0]??0,g.destroy()},"read");h=g.mapAsync(GPUMapMode.READ).then(b,()=>{}).finally(()=>P-=1)}n(U,"submit");function G(p,y){let g=y.map((b,m)=>({binding:m,resource:b}));return r.createBindGroup({layout:p,entries:g})}return n(G,"createGroup"),{upload:n((p,{words:y,parts:g})=>({model:p,parts:g,...o.put(y)}),"upload"),drop:n(p=>o.free(p),"drop"),meshes:i,draw:E,get isDone(){return P===0},finish:n(()=>h,"finish"),get unhidden(){return x}}}n(ke,"createWebgpuDrawer");function De(e,t){e.dispatchWorkgroups(Math.min(t,Y),Math.ceil(t/Y))}n(De,"dispatch");var pr="there is too little graphics memory: set a lower limit by ?megabytes= in the address";async function Lt(e,t,r,a){let i=navigator.gpu.getPreferredCanvasFormat();r.pushErrorScope("validation");let o=Ee(r,i),s=Le(r,o.uniformLayout),l=await r.popErrorScope();if(l)throw new Error(l.message);let u=e.getContext("webgpu");if(!u)throw new Error("this browser has no WebGPU for canvases");return u.configure({device:r,format:i,alphaMode:"opaque"}),dr(r,a),ke(u,t,r,o,s)}n(Lt,"start");function dr(e,t){let[r,a]=[!1,!1],i=n(o=>{r||t(o,!0),r=!0},"reportLoss");e.lost.then(({message:o,reason:s})=>{s!=="destroyed"&&i(`the graphics device is lost: ${o}`)}),e.onuncapturederror=({error:o})=>{o instanceof GPUOutOfMemoryError?a||t(pr,!1):i(`the graphics fail: ${o.message}`),a||=o instanceof GPUOutOfMemoryError}}n(dr,"reportFailures");export{Lt as start};
