var Ke=Object.defineProperty;var n=(e,t)=>Ke(e,"name",{value:t,configurable:!0});function fe(e,t){let r=1e6;for(let{layer:a}of e)r=Math.min(r,Math.max(a.model.pitch[0],a.model.pitch[1]));return t?Math.min(r/2,.05):r/2}n(fe,"nearDistanceOf");function pe(e,t,r){return Math.max(Math.min(e,Math.floor(r/t)),1)}n(pe,"gridOf");function ee({right:e,up:t,back:r,fov:a,width:i,height:o},s,l){let u=a.left+(a.right-a.left)*s/i,c=a.up+(a.down-a.up)*l/o,f=n(p=>u*e[p]+c*t[p]-r[p],"component");return[f(0),f(1),f(2)]}n(ee,"directionAt");function re(e,t){return[e[0]-t[0],e[1]-t[1],e[2]-t[2]]}n(re,"subtract");function te(e,t){return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}n(te,"dot");function se({cell:e},t){return e*2**t}n(se,"sideAt");function de(e,t,[r,a,i]){let[o,[s,l,u]]=[se(e,t),e.origin];return[s+r*o,l+a*o,u+i*o]}n(de,"cornerOf");var ie=1.27,Z=.5,le=.25,Ye=8,Q=10;function me(e,t){return[e[0]*t,e[1]*t,e[2]*t]}n(me,"scaleVector");function ye(e){let{position:t,right:r,up:a,back:i,fov:o,width:s,height:l}=e,[u,c]=[s/(o.right-o.left),l/(o.up-o.down)],f=n(v=>[v(0),v(1),v(2)],"gradient"),p=[f(v=>u*(r[v]+o.left*i[v])),f(v=>-c*(a[v]+o.up*i[v])),f(v=>-i[v])],_=ee(e,0,0),[w,T]=[ee(e,1,0),ee(e,0,1)];return{eye:t,rows:p,rays:[_,re(w,_),re(T,_)],width:s,height:l}}n(ye,"projectorOf");function ge(e,{eye:t,rows:r}){let{start:a,steps:i,pitch:o}=e,s=n(p=>[te(r[0],p),te(r[1],p),te(r[2],p)],"project"),[l,u]=[ie*Math.sqrt(Z),be(e)],c=n(p=>Math.max(l,u/p)-.5,"marginOf"),f=l*(o[0]+o[1])/le;return{start:s(re(a,t)),steps:[s(i[0]),s(i[1]),s(i[2])],minW:Math.max(o[0],o[1]),margin:[c(o[0]),c(o[1]),Math.max(f,u)/o[2]]}}n(ge,"projectView");function be({pitch:e}){return Math.hypot(e[0],e[1])/2}n(be,"ballRadius");function he(e,{low:t,high:r},a,i){let{start:o,steps:s,minW:l,margin:u}=e,[c,f,p,_,w]=[!0,!0,!0,!0,!0],T=Number.POSITIVE_INFINITY,v=[Number.POSITIVE_INFINITY,Number.POSITIVE_INFINITY],E=[Number.NEGATIVE_INFINITY,Number.NEGATIVE_INFINITY];for(let A=0;A<8;A++){let z=n(y=>A>>y&1?r[y]+u[y]:t[y]-u[y],"coordinate"),[N,h,O]=[z(0),z(1),z(2)],d=n(y=>o[y]+N*s[0][y]+h*s[1][y]+O*s[2][y],"valueOf"),[m,g,b]=[d(0),d(1),d(2)];c&&=m<-b,f&&=m>(a+1)*b,p&&=g<-b,_&&=g>(i+1)*b,w&&=b<l,T=Math.min(T,b),v[0]=Math.min(v[0],m/b),v[1]=Math.min(v[1],g/b),E[0]=Math.max(E[0],m/b),E[1]=Math.max(E[1],g/b)}if(c||f||p||_||w)return null;let B=T<l?Number.POSITIVE_INFINITY:1/T;return T<Ye*l?{low:[0,0],high:[a,i],nearness:B}:{low:[Math.max(Math.floor(v[0])-1,0),Math.max(Math.floor(v[1])-1,0)],high:[Math.min(Math.floor(E[0])+2,a),Math.min(Math.floor(E[1])+2,i)],nearness:B}}n(he,"boundsOf");function xe(e,{low:t,high:r}){return e.every(([a,i,o,s])=>{let[l,u]=[s,s];return[a,i,o].forEach((c,f)=>{let p=[c*t[f],c*r[f]];l+=Math.min(...p),u+=Math.max(...p)}),l<1&&u>=0})}n(xe,"mayLieIn");function we(e,t,r){if(!r)return[0,1,2].map(()=>[0,0,0,.5]);let a=se(t,r.level),i=de(t,r.level,r.place);return[0,1,2].map(o=>{let[s,l,u]=e.steps.map(c=>c[o]/a);return[s,l,u,(e.start[o]-i[o])/a]})}n(we,"boxFunctionsOf");function ve(e,t,r,a){let{frame:i,pitch:o}=t,[s,l,u]=i.axes,c=2/(2**t.normalBits-2),f=n((p,[_,w,T],v)=>e.set([_,w,T,v],4*p),"put");f(0,r.start,r.minW),f(1,r.steps[0],c),f(2,r.steps[1],be(t)/Math.sqrt(Z)),f(3,r.steps[2],0),f(4,me(s,o[0]/o[2]),0),f(5,me(l,o[1]/o[2]),0),f(6,u,0),a.forEach((p,_)=>e.set(p,4*(7+_)))}n(ve,"writeView");var D=class{constructor(t,r,a){this.device=t;this.label=r;this.usage=a}device;label;usage;static{n(this,"GrowingBuffer")}#e=null;reserve(t){if(this.#e&&this.#e.size>=t)return this.#e;this.#e?.destroy();let r=Math.max(2**Math.ceil(Math.log2(Math.max(t,1))),256),a=this.usage|GPUBufferUsage.COPY_DST;return this.#e=this.device.createBuffer({label:this.label,size:r,usage:a}),this.#e}write(t){let r=this.reserve(t.byteLength);return this.device.queue.writeBuffer(r,0,t),r}},qe=1<<23,ne=64,oe=class{constructor(t){this.device=t}device;static{n(this,"Arena")}#e=[];put(t){let r=Math.max(Math.ceil(t.length/ne),1)*ne,{page:a,gap:i}=this.#t(r)??this.#n(r),o={page:a,first:i.first,words:r,bytes:4*r};return i.first+=r,i.words-=r,i.words===0&&a.gaps.splice(a.gaps.indexOf(i),1),this.device.queue.writeBuffer(a.buffer,4*o.first,t),o}free({page:t,first:r,words:a}){let{gaps:i}=t,o=i.findIndex(l=>l.first>r),s=o<0?i.length:o;i.splice(s,0,{first:r,words:a}),this.#r(i,s),this.#r(i,s-1),i[0]?.words===t.words&&(t.buffer.destroy(),this.#e.splice(this.#e.indexOf(t),1))}#r(t,r){let[a,i]=[t[r],t[r+1]];!a||!i||a.first+a.words!==i.first||(a.words+=i.words,t.splice(r+1,1))}#t(t){for(let r of this.#e){let a=r.gaps.find(i=>i.words>=t);if(a)return{page:r,gap:a}}return null}#n(t){let{maxBufferSize:r,maxStorageBufferBindingSize:a}=this.device.limits,i=Math.min(r,a),o=Math.floor(i/4/ne)*ne;if(t>o)throw new Error(`a view of ${4*t} bytes is larger than the graphics device allows`);let s=Math.min(Math.max(t,qe),o),l=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_DST,u=this.device.createBuffer({label:"page of views",size:4*s,usage:l}),c={first:0,words:s},f={buffer:u,words:s,gaps:[c]};return this.#e.push(f),{page:f,gap:c}}};var Xe={SUN_DIRECTION:[.5263158,.7894737,.3157895],SUN:[.6,.56,.5],SKY_DIRECTION:[-.2062843,.9282791,.3094264],SKY_LOW:[.13,.135,.15],SKY_HIGH:[.38,.42,.48],HORIZON:[.66,.74,.82],ZENITH:[.16,.34,.66],NADIR:[.24,.25,.26]},_e=["SUN_DIRECTION","SUN","SKY_DIRECTION","SKY_LOW","SKY_HIGH"],Pe=["HORIZON","ZENITH","NADIR"],j=n(e=>Number.isInteger(e)?e.toFixed(1):String(e),"float"),Te=n(e=>Xe[e].map(j).join(", "),"vector"),Oe=n(e=>e.map(t=>`const vec3 ${t} = vec3(${Te(t)});`).join(`
`),"glsl"),Ze=n(e=>e.map(t=>`const ${t} = vec3<f32>(${Te(t)});`).join(`
`),"wgsl"),Fr=`
${Oe(_e)}

vec3 irradiance(vec3 n) {
float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`;var Dr=`
${Oe(Pe)}

vec3 background(vec3 direction) {
return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`;var K=`
${Ze([..._e,...Pe])}

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
`,Ue=`
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
`,Ge=`
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
`;var Qe=256,Ee=`
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
if extent.x * extent.y > ${Qe}u {
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
${Se}`;function Re(e,t){let r=n((E,B)=>{let A=[{buffer:{hasDynamicOffset:!0}},...B];return e.createBindGroupLayout({entries:A.map((z,N)=>({binding:N,visibility:E,...z}))})},"layoutOf"),{COMPUTE:a,FRAGMENT:i,VERTEX:o}=GPUShaderStage,s={buffer:{type:"read-only-storage"}},l={buffer:{type:"storage"}},u=r(o|i,[]),c=r(a,[s,s,s,s,l,l,l]),f=r(a,[{texture:{sampleType:"depth"}},l]),p=r(i,[{texture:{sampleType:"unfilterable-float"}},s,s]),_=n((E,B)=>e.createShaderModule({label:E,code:B}),"moduleOf"),w=n((E,B,A)=>e.createComputePipeline({label:A,layout:e.createPipelineLayout({bindGroupLayouts:[E]}),compute:{module:B,entryPoint:A}}),"computePipeline"),[T,v]=[_("splats",Ee),_("resolve",Ge)];return{uniformLayout:u,splatLayout:c,beginLayout:f,resolveLayout:p,splats:w(c,T,"splats"),tiles:w(c,T,"farthest_of_tiles"),shade:w(c,T,"shade"),begin:w(f,_("begin",Ue),"begin"),resolve:e.createRenderPipeline({label:"resolve",layout:e.createPipelineLayout({bindGroupLayouts:[p]}),vertex:{module:v},fragment:{module:v,targets:[{format:t}]}})}}n(Re,"kernelsOf");var ae=class{constructor(t,r){this.common=t;this.#e=new ArrayBuffer(256*r)}common;static{n(this,"Uniforms")}#e;#r=0;get all(){return new Uint32Array(this.#e)}put(t,{first:r=0,count:a=0,round:i=0,page:o=0}){let{projector:s,grid:l,nearest:u,parts:c}=this.common,f=256*this.#r,p=new Float32Array(this.#e,f,256/4);return[...s.rows,...s.rays].forEach((_,w)=>p.set(_,4*w)),new Uint32Array(this.#e,f+96,12).set([s.width,t.rows,t.first,l,r,a,i,0,c,o,0,0]),p[36]=u,this.#r+=1,f}};var Me=`
${q}
struct Mesh {
offset: vec4<f32>,
base: vec4<f32>,
emission: vec4<f32>,
}

@group(1) @binding(0) var<uniform> mesh: Mesh;
@group(2) @binding(0) var image: texture_2d<f32>;
@group(2) @binding(1) var glow: texture_2d<f32>;
@group(2) @binding(2) var image_sampler: sampler;
@group(2) @binding(3) var glow_sampler: sampler;
${K}
struct Varyings {
@builtin(position) clip_position: vec4<f32>,
@location(0) from_eye: vec3<f32>,
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
) -> Varyings {
let at = vec4<f32>(position, 1.0);
var out: Varyings;
out.from_eye = vec3<f32>(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + mesh.offset.xyz;
let cofactors = mat3x3<f32>(cross(row_y.xyz, row_z.xyz), cross(row_z.xyz, row_x.xyz), cross(row_x.xyz, row_y.xyz));
out.normal = normal * cofactors;
out.uv = uv;
out.color = color.rgb;
let p = out.from_eye;
let xyw = vec3<f32>(dot(draw.gradients[0].xyz, p), dot(draw.gradients[1].xyz, p), dot(draw.gradients[2].xyz, p));
let row = xyw.y - f32(draw.size.z) * xyw.z;
let clip = vec2<f32>(2.0 * xyw.x / f32(draw.size.x) - xyw.z, xyw.z - 2.0 * row / f32(draw.size.y));
out.clip_position = vec4<f32>(clip, draw.nearest, xyw.z);
return out;
}

fn shading_normal(varyings: Varyings, face_normal: vec3<f32>) -> vec3<f32> {
let toward = -normalize(varyings.from_eye);
let face_length = length(face_normal);
var face = select(toward, face_normal / face_length, face_length > 0.0);
face = select(face, -face, dot(face, toward) < 0.0);
let vertex_length = length(varyings.normal);
if vertex_length == 0.0 {
return face;
}
let n = varyings.normal / vertex_length;
return select(n, -n, dot(n, face) < 0.0);
}

fn level_of(texture: texture_2d<f32>, right: vec2<f32>, down: vec2<f32>) -> f32 {
let size = vec2<f32>(textureDimensions(texture));
let dx = right * size;
let dy = down * size;
return 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
}

@fragment
fn shade(varyings: Varyings) -> @location(0) vec4<f32> {
let normal = shading_normal(varyings, cross(dpdx(varyings.from_eye), dpdy(varyings.from_eye)));
let right = dpdx(varyings.uv);
let down = dpdy(varyings.uv);
let texel = textureSampleLevel(image, image_sampler, varyings.uv, level_of(image, right, down));
let light = textureSampleLevel(glow, glow_sampler, varyings.uv, level_of(glow, right, down)).rgb;
let alpha = mesh.base.a * textureSampleLevel(image, image_sampler, varyings.uv, 0.0).a;
if alpha < mesh.offset.w {
discard;
}
let albedo = mesh.base.rgb * varyings.color * texel.rgb;
return vec4<f32>(albedo * mix(irradiance(normal), vec3<f32>(1.0), mesh.emission.w) + mesh.emission.rgb * light, 1.0);
}
`,Be=`
@group(0) @binding(0) var finer: texture_2d<f32>;
@group(0) @binding(1) var smooth_texels: sampler;

struct Varyings {
@builtin(position) clip_position: vec4<f32>,
@location(0) uv: vec2<f32>,
}

@vertex
fn cover_picture(@builtin(vertex_index) n: u32) -> Varyings {
let at = vec2<f32>(f32(n & 1u) * 2.0, f32(n >> 1u) * 2.0);
return Varyings(vec4<f32>(at.x * 2.0 - 1.0, 1.0 - at.y * 2.0, 0.0, 1.0), at);
}

@fragment
fn level(varyings: Varyings) -> @location(0) vec4<f32> {
return textureSampleLevel(finer, smooth_texels, varyings.uv, 0.0);
}
`;var $="rgba8unorm-srgb",ue="depth32float",Je=[{format:"float32x3",stride:12},{format:"float32x3",stride:12},{format:"float32x2",stride:8},{format:"unorm16x4",stride:8}],Ie={10497:"repeat",33648:"mirror-repeat",33071:"clamp-to-edge"},er=9728,rr=0,tr=12;function ze(e,t){let r=e.createShaderModule({label:"meshes",code:Me}),a=GPUShaderStage.FRAGMENT,o=[{texture:{}},{texture:{}},{sampler:{}},{sampler:{}}].map((h,O)=>({binding:O,visibility:a,...h})),s=e.createBindGroupLayout({entries:o}),l=[t,t,s],u=e.createPipelineLayout({bindGroupLayouts:l}),c=or(e),f=new Map,p=N(new Uint32Array([0,0,0,4294967295,4294967295]),GPUBufferUsage.VERTEX),_=new Map,w=new D(e,"meshes",GPUBufferUsage.UNIFORM);z(!0,!0,!0,!0);function T(h){let{positions:O,normals:d,uvs:m,colors:g,placements:b,indices:y}=h,x=[O,d,m,g,b].map(S=>S&&N(S,GPUBufferUsage.VERTEX)),G=[h.image,h.glow],P=[...x,N(y,GPUBufferUsage.INDEX)],U=P.reduce((S,R)=>S+(R?.size??0),0);for(let S of G)U+=S?Math.ceil(16*S.width*S.height/3):0;let M=G.map(S=>S&&c.upload(S));return{origin:h.origin,material:h.material,pipeline:z(!0,d!==null,m!==null,g!==null),buffers:x,indices:P.at(-1),format:y instanceof Uint16Array?"uint16":"uint32",corners:y.length,instances:b.length/12,textures:M,group:B(M,h.material),bytes:U}}n(T,"upload");function v({buffers:h,indices:O,textures:d}){for(let m of[...h,O,...d])m?.destroy()}n(v,"drop");function E(h,O,d){let m=new Float32Array(256/4*O.length);O.forEach((y,x)=>m.set(nr(y,d),256/4*x));let g={buffer:w.write(m),size:256},b=e.createBindGroup({layout:t,entries:[{binding:0,resource:g}]});return O.reduce((y,x,G)=>(h.setPipeline(x.pipeline),h.setBindGroup(1,b,[256*G]),h.setBindGroup(2,x.group),x.buffers.forEach((P,U)=>{P?h.setVertexBuffer(U,P):h.setVertexBuffer(U,p,U===3?tr:rr)}),h.setIndexBuffer(x.indices,x.format),h.drawIndexed(x.corners,x.instances),y+x.corners/3*x.instances),0)}n(E,"record");function B(h,O){let d=h.map(b=>(b??c.white).createView()),m=[O.imageSampler,O.glowSampler].map(A),g=[...d,...m].map((b,y)=>({binding:y,resource:b}));return e.createBindGroup({layout:s,entries:g})}n(B,"groupOf");function A(h){let O=f.get(h.join());if(O)return O;let[d,m,g]=h,b=e.createSampler({addressModeU:Ie[d]??"repeat",addressModeV:Ie[m]??"repeat",minFilter:"linear",magFilter:g===er?"nearest":"linear",mipmapFilter:"linear"});return f.set(h.join(),b),b}n(A,"samplerOf");function z(...h){let O=h.join(),d=_.get(O);if(d)return d;let m=Je.map(({format:x,stride:G},P)=>({arrayStride:h[P]?G:0,attributes:[{shaderLocation:P,offset:0,format:x}]})),g=[0,1,2].map(x=>({shaderLocation:4+x,offset:16*x,format:"float32x4"})),b={arrayStride:48,stepMode:"instance",attributes:g},y=e.createRenderPipeline({label:"meshes",layout:u,vertex:{module:r,buffers:[...m,b]},fragment:{module:r,targets:[{format:$}]},depthStencil:{format:ue,depthWriteEnabled:!0,depthCompare:"greater"}});return _.set(O,y),y}n(z,"pipelineOf");function N(h,O){let d=4*Math.ceil(Math.max(h.byteLength,4)/4),m=e.createBuffer({label:"mesh",size:d,usage:O,mappedAtCreation:!0});return new Uint8Array(m.getMappedRange()).set(new Uint8Array(h.buffer,h.byteOffset,h.byteLength)),m.unmap(),m}return n(N,"bufferOf"),{upload:T,drop:v,record:E}}n(ze,"createMeshes");function nr({origin:e,material:t},r){let{color:a,cutoff:i,emission:o,isUnlit:s}=t;return[...[e[0]-r[0],e[1]-r[1],e[2]-r[2]],i??-1,...a,...o??[0,0,0],s?1:0]}n(nr,"uniformsOf");function or(e){let t=e.createShaderModule({label:"mipmaps",code:Be}),r=e.createRenderPipeline({label:"mipmaps",layout:"auto",vertex:{module:t},fragment:{module:t,targets:[{format:$}]}}),a=e.createSampler({minFilter:"linear",magFilter:"linear"}),i=s(1,1);e.queue.writeTexture({texture:i},new Uint8Array([255,255,255,255]),{},[1,1]);function o(u){let{width:c,height:f}=u,p=s(c,f);e.queue.copyExternalImageToTexture({source:u},{texture:p},[c,f]),u.close();let _=e.createCommandEncoder();for(let w=1;w<p.mipLevelCount;w++)l(_,p,w);return e.queue.submit([_.finish()]),p}n(o,"upload");function s(u,c){return e.createTexture({label:"image",size:[u,c],format:$,mipLevelCount:1+Math.floor(Math.log2(Math.max(u,c))),usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST|GPUTextureUsage.RENDER_ATTACHMENT})}n(s,"createTexture");function l(u,c,f){let p=n(v=>c.createView({baseMipLevel:v,mipLevelCount:1}),"view"),_={view:p(f),loadOp:"clear",storeOp:"store"},w=u.beginRenderPass({colorAttachments:[_]});w.setPipeline(r);let T=[{binding:0,resource:p(f-1)},{binding:1,resource:a}];w.setBindGroup(0,e.createBindGroup({layout:r.getBindGroupLayout(0),entries:T})),w.draw(3),w.end()}return n(l,"drawMipmap"),{white:i,upload:o}}n(or,"createTextures");var ar=1<<26;function Le(e,t,r,a){let{maxStorageBufferBindingSize:i,maxTextureDimension2D:o}=e.limits,s=Math.min(Math.min(i,ar)/(4*t),o),l=Math.max(Math.floor(s/a),1)*a;return Array.from({length:Math.ceil(r/l)},(u,c)=>({number:c,first:c*l,rows:Math.min(l,r-c*l)}))}n(Le,"bandsOf");function ce(e,t){return Math.ceil(e/J)*Math.ceil(t/J)}n(ce,"tilesOf");function Ne(e){let t=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_SRC,r=n(l=>new D(e,l,t),"storage"),[a,i,o]=[r("depthBits"),r("colors"),r("tiles")],s=null;return{get counts(){return o.reserve(0)},buffers(l,u){let c=4*l*u,f=4*(1+ce(l,u));return{depthBits:a.reserve(c),colors:i.reserve(c),tiles:o.reserve(f)}},targets(l,u){if(s&&s.color.width===l&&s.color.height===u)return s;s?.color.destroy(),s?.depth.destroy();let c=GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.TEXTURE_BINDING,f=n(p=>e.createTexture({label:"samples",size:[l,u],format:p,usage:c}),"create");return s={color:f($),depth:f(ue)},s}}}n(Ne,"createSamples");var Ce=3;var Fe=8,sr=[1/16,1/8,1/4,1/2];function De(e,t,r,a){let i=[],o=[],s=new Float32Array(4*Q),l=0;for(let{layer:u,box:c}of e){let f=ge(u.model,t),p=we(u.model,r,c),_=i.length/(4*Q),w=o.length;for(let T of u.parts){let v=he(f,T,t.width,t.height);if(!v||c&&!xe(p,T))continue;let E=u.first+Ce*T.first;o.push({view:_,firstWord:E,firstSplat:l,count:T.count,bounds:v,page:u.page}),l+=T.count}o.length!==w&&(ve(s,u.model,f,p),i.push(...s))}return{views:new Float32Array(i),splats:l,...cr(o,l,a)}}n(De,"workOf");var[ir,lr]=(e=>[new Float32Array(e),new Uint32Array(e)])(new ArrayBuffer(4));function ur(e){return ir[0]=e,lr[0]+(Number.isFinite(e)?1:0)}n(ur,"upperBitsOf");function cr(e,t,r){let a=[...e].sort((c,f)=>fr(f.bounds.nearness,c.bounds.nearness)),i=[...new Set(e.map(({page:c})=>c))],o=new Uint32Array(Fe*e.length),s=new Map,l=[];for(let c of dr(a,t)){let f=!0;for(let p of i){let _=c.filter(w=>w.page===p);if(_.length!==0){l.push({page:p,startsBatch:f,first:s.size,count:_.length}),f=!1;for(let w of _)o.set(pr(w,i.indexOf(p),r),Fe*s.size),s.set(w,s.size)}}}let u=new Uint32Array(e.map(c=>s.get(c)));return{parts:o,partOrder:u,pages:i,calls:l}}n(cr,"assignCalls");function fr(e,t){return+(e>t)-+(e<t)}n(fr,"compareNumbers");function pr(e,t,r){let{view:a,firstWord:i,firstSplat:o,count:s,bounds:l}=e,[u,c]=[l.low,l.high].map(([f,p])=>f|p<<16);return[a,i,s,o,ur(r*l.nearness),u,c,t]}n(pr,"wordsOf");function dr(e,t){let r=[[]],[a,i]=[0,0];for(let o of e){let s=sr.filter(l=>a>=t*l).length;s>i&&r.push([]),i=s,r.at(-1)?.push(o),a+=o.count}return r.filter(o=>o.length>0)}n(dr,"batchesOf");function Ve(e,t,r,a,i){let o=new oe(r),s=Ne(r),l=new D(r,"calls",GPUBufferUsage.UNIFORM),u=n(d=>new D(r,d,GPUBufferUsage.STORAGE),"storage"),[c,f,p]=[u("views"),u("parts"),u("partOrder")],_=r.createTexture({size:[1,1],format:$,usage:GPUTextureUsage.TEXTURE_BINDING}),w=Promise.resolve(),T=0,v=null;function E(d,m,g,b){let y=pe(b,g.width,r.limits.maxTextureDimension2D),x=ye({...g,width:g.width*y,height:g.height*y}),G=fe(m,d.length>0),P=De(m,x,t,G),U=Le(r,x.width,x.height,y),M=U.length*(1+4*P.calls.length+P.pages.length),S=r.createCommandEncoder(),R={encoder:S,meshes:d,projector:x,grid:y,rows:U[0]?.rows??0,work:P,uniforms:new ae({projector:x,grid:y,nearest:G,parts:P.partOrder.length},M),uniformBinding:{buffer:l.reserve(256*M),size:256},views:c.write(P.views),parts:f.write(P.parts),partOrder:p.write(P.partOrder),target:e.getCurrentTexture().createView()},C=0;for(let X of U)C=B(R,X);l.write(R.uniforms.all),h(S,U);let V=2*P.calls.length+P.pages.length+d.length;return{splats:P.splats,triangles:C,calls:U.length*V}}n(E,"draw");function B(d,m){let{encoder:g,meshes:b,projector:y}=d,x=4*y.width*m.rows,{depthBits:G,colors:P,tiles:U}=s.buffers(y.width,m.rows),M=b.length>0?s.targets(y.width,d.rows):null;m.number===0&&g.clearBuffer(U,0,4),g.clearBuffer(P,0,x);let S=d.uniforms.put(m,{}),R=0;if(M){R=A(d,m,S,M);let X=[d.uniformBinding,M.depth.createView(),{buffer:G}],H=g.beginComputePass({label:"begin"});H.setPipeline(a.begin),H.setBindGroup(0,O(a.beginLayout,X),[S]),ke(H,Math.ceil(y.width*m.rows/k)),H.end()}else g.clearBuffer(G,0,x);z(d,m,[{buffer:U},{buffer:G},{buffer:P}]);let C=(M?.color??_).createView(),V=[d.uniformBinding,C,{buffer:G},{buffer:P}];return N(d,m,S,O(a.resolveLayout,V)),R}n(B,"drawBand");function A(d,{rows:m},g,{color:b,depth:y}){let{encoder:x,meshes:G,projector:P,uniformBinding:U}=d,M=y.createView(),S=x.beginRenderPass({label:"meshes",colorAttachments:[{view:b.createView(),loadOp:"clear",storeOp:"store"}],depthStencilAttachment:{view:M,depthClearValue:0,depthLoadOp:"clear",depthStoreOp:"store"}});S.setViewport(0,0,P.width,m,0,1),S.setBindGroup(0,O(a.uniformLayout,[U]),[g]);let R=i.record(S,G,P.eye);return S.end(),R}n(A,"drawMeshes");function z(d,m,g){let{encoder:b,projector:y,work:x,uniforms:G,uniformBinding:P,views:U,parts:M,partOrder:S}=d,R=new Map;for(let F of x.pages){let W=[U,M,S,F.buffer].map(L=>({buffer:L}));R.set(F,O(a.splatLayout,[P,...W,...g]))}let C=b.beginComputePass({label:"splats"}),V=n((F,W,L,je)=>{C.setPipeline(F),C.setBindGroup(0,R.get(W),[G.put(m,je)]),ke(C,L)},"call"),{splats:X,tiles:H,shade:We}=a,$e=Math.ceil(ce(y.width,m.rows)/k);for(let F of[0,1])for(let[W,L]of x.calls.entries())L.startsBatch&&(F===0||W===0)&&V(H,L.page,$e,{}),V(X,L.page,L.count,{first:L.first,count:L.count,round:F});let He=Math.ceil(y.width*m.rows/k);for(let[F,W]of x.pages.entries())V(We,W,He,{page:F});C.end()}n(z,"drawSplats");function N(d,{number:m,first:g,rows:b},y,x){let{encoder:G,projector:P,grid:U,target:M}=d,S={view:M,loadOp:m===0?"clear":"load",storeOp:"store"},R=G.beginRenderPass({label:"show",colorAttachments:[S]});R.setPipeline(a.resolve),R.setBindGroup(0,x,[y]),R.setScissorRect(0,g/U,P.width/U,b/U),R.draw(3),R.end()}n(N,"show");function h(d,m){let g=r.createBuffer({size:4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST});m.length>0&&d.copyBufferToBuffer(s.counts,0,g,0,4),r.queue.submit([d.finish()]),T+=1;let b=n(()=>{v=new Uint32Array(g.getMappedRange())[0]??0,g.destroy()},"read");w=g.mapAsync(GPUMapMode.READ).then(b,()=>{}).finally(()=>T-=1)}n(h,"submit");function O(d,m){let g=m.map((b,y)=>({binding:y,resource:b}));return r.createBindGroup({layout:d,entries:g})}return n(O,"createGroup"),{upload:n((d,{words:m,parts:g})=>({model:d,parts:g,...o.put(m)}),"upload"),drop:n(d=>o.free(d),"drop"),meshes:i,draw:E,get isDone(){return T===0},finish:n(()=>w,"finish"),get drawnSplats(){return v}}}n(Ve,"createWebgpuDrawer");function ke(e,t){e.dispatchWorkgroups(Math.min(t,Y),Math.ceil(t/Y))}n(ke,"dispatch");var mr="there is too little graphics memory: set a lower limit by ?megabytes= in the address";async function Lt(e,t,r,a){let i=navigator.gpu.getPreferredCanvasFormat();r.pushErrorScope("validation");let o=Re(r,i),s=ze(r,o.uniformLayout),l=await r.popErrorScope();if(l)throw new Error(l.message);let u=e.getContext("webgpu");if(!u)throw new Error("this browser has no WebGPU for canvases");return u.configure({device:r,format:i,alphaMode:"opaque"}),yr(r,a),Ve(u,t,r,o,s)}n(Lt,"start");function yr(e,t){let[r,a]=[!1,!1],i=n(o=>{r||t(o,!0),r=!0},"reportLoss");e.lost.then(({message:o,reason:s})=>{s!=="destroyed"&&i(`the graphics device is lost: ${o}`)}),e.onuncapturederror=({error:o})=>{o instanceof GPUOutOfMemoryError?a||t(mr,!1):i(`the graphics fail: ${o.message}`),a||=o instanceof GPUOutOfMemoryError}}n(yr,"reportFailures");export{Lt as start};
