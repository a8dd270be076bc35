var je=Object.defineProperty;var n=(e,t)=>je(e,"name",{value:t,configurable:!0});function de(e,t){let r=1e6;for(let{layer:a}of e)r=Math.min(r,Math.max(a.model.pitch[0],a.model.pitch[1]));return t?Math.min(r/2,.05):r/2}n(de,"nearDistanceOf");function me(e,t,r){return Math.max(Math.min(e,Math.floor(r/t)),1)}n(me,"gridOf");function te({right:e,up:t,back:r,fov:a,width:i,height:o},s,l){let u=a.left+(a.right-a.left)*s/i,c=a.up+(a.down-a.up)*l/o,f=n(d=>u*e[d]+c*t[d]-r[d],"component");return[f(0),f(1),f(2)]}n(te,"directionAt");function ne(e,t){return[e[0]-t[0],e[1]-t[1],e[2]-t[2]]}n(ne,"subtract");function oe(e,t){return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}n(oe,"dot");function le({cell:e},t){return e*2**t}n(le,"sideAt");function ye(e,t,[r,a,i]){let[o,[s,l,u]]=[le(e,t),e.origin];return[s+r*o,l+a*o,u+i*o]}n(ye,"cornerOf");var ue=1.27,J=.5,ce=.25,qe=8,ee=10;function ge(e,t){return[e[0]*t,e[1]*t,e[2]*t]}n(ge,"scaled");function be(e){let{position:t,right:r,up:a,back:i,fov:o,width:s,height:l}=e,[u,c]=[s/(o.right-o.left),l/(o.up-o.down)],f=n(b=>[b(0),b(1),b(2)],"gradient"),d=[f(b=>u*(r[b]+o.left*i[b])),f(b=>-c*(a[b]+o.up*i[b])),f(b=>-i[b])],w=te(e,0,0),[g,_]=[te(e,1,0),te(e,0,1)];return{eye:t,rows:d,rays:[w,ne(g,w),ne(_,w)],width:s,height:l}}n(be,"projectorOf");function he(e,{eye:t,rows:r}){let{start:a,steps:i,pitch:o}=e,s=n(d=>[oe(r[0],d),oe(r[1],d),oe(r[2],d)],"project"),[l,u]=[ue*Math.sqrt(J),xe(e)],c=n(d=>Math.max(l,u/d)-.5,"marginOf"),f=l*(o[0]+o[1])/ce;return{start:s(ne(a,t)),steps:[s(i[0]),s(i[1]),s(i[2])],minW:Math.max(o[0],o[1]),margin:[c(o[0]),c(o[1]),Math.max(f,u)/o[2]]}}n(he,"sightOf");function xe({pitch:e}){return Math.hypot(e[0],e[1])/2}n(xe,"ballRadius");function we(e,{low:t,high:r},a,i){let{start:o,steps:s,minW:l,margin:u}=e,[c,f,d,w,g]=[!0,!0,!0,!0,!0],_=Number.POSITIVE_INFINITY,b=[Number.POSITIVE_INFINITY,Number.POSITIVE_INFINITY],G=[Number.NEGATIVE_INFINITY,Number.NEGATIVE_INFINITY];for(let z=0;z<8;z++){let N=n(p=>z>>p&1?r[p]+u[p]:t[p]-u[p],"coordinate"),[h,S,M]=[N(0),N(1),N(2)],P=n(p=>o[p]+h*s[0][p]+S*s[1][p]+M*s[2][p],"valueOf"),[U,y,m]=[P(0),P(1),P(2)];c&&=U<-m,f&&=U>(a+1)*m,d&&=y<-m,w&&=y>(i+1)*m,g&&=m<l,_=Math.min(_,m),b[0]=Math.min(b[0],U/m),b[1]=Math.min(b[1],y/m),G[0]=Math.max(G[0],U/m),G[1]=Math.max(G[1],y/m)}if(c||f||d||w||g)return null;let I=_<l?Number.POSITIVE_INFINITY:1/_;return _<qe*l?{low:[0,0],high:[a,i],nearness:I}:{low:[Math.max(Math.floor(b[0])-1,0),Math.max(Math.floor(b[1])-1,0)],high:[Math.min(Math.floor(G[0])+2,a),Math.min(Math.floor(G[1])+2,i)],nearness:I}}n(we,"boundsOf");function ve(e,{low:t,high:r}){return e.every(([a,i,o,s])=>{let[l,u]=[s,s];return[a,i,o].forEach((c,f)=>{let d=[c*t[f],c*r[f]];l+=Math.min(...d),u+=Math.max(...d)}),l<1&&u>=0})}n(ve,"mayLieIn");function _e(e,t,r){if(!r)return[0,1,2].map(()=>[0,0,0,.5]);let a=le(t,r.level),i=ye(t,r.level,r.place);return[0,1,2].map(o=>{let[s,l,u]=e.steps.map(c=>c[o]/a);return[s,l,u,(e.start[o]-i[o])/a]})}n(_e,"boxFunctionsOf");function Pe(e,t,r,a){let{frame:i,pitch:o}=t,[s,l,u]=i.axes,c=2/(2**t.normalBits-2),f=n((d,[w,g,_],b)=>e.set([w,g,_,b],4*d),"put");f(0,r.start,r.minW),f(1,r.steps[0],c),f(2,r.steps[1],xe(t)/Math.sqrt(J)),f(3,r.steps[2],0),f(4,ge(s,o[0]/o[2]),0),f(5,ge(l,o[1]/o[2]),0),f(6,u,0),a.forEach((d,w)=>e.set(d,4*(7+w)))}n(Pe,"writeView");var W=class{constructor(t,r,a){this.device=t;this.label=r;this.usage=a}device;label;usage;static{n(this,"GrowingBuffer")}#e=null;ofSize(t){if(this.#e&&this.#e.size>=t)return this.#e;this.#e?.destroy();let r=Math.max(2**Math.ceil(Math.log2(Math.max(t,1))),256),a=this.usage|GPUBufferUsage.COPY_DST;return this.#e=this.device.createBuffer({label:this.label,size:r,usage:a}),this.#e}write(t){let r=this.ofSize(t.byteLength);return this.device.queue.writeBuffer(r,0,t),r}},Xe=1<<23,ae=64,se=class{constructor(t){this.device=t}device;static{n(this,"Arena")}#e=[];put(t){let r=Math.max(Math.ceil(t.length/ae),1)*ae,{page:a,gap:i}=this.#t(r)??this.#n(r),o={page:a,first:i.first,words:r,bytes:4*r};return i.first+=r,i.words-=r,i.words===0&&a.gaps.splice(a.gaps.indexOf(i),1),this.device.queue.writeBuffer(a.buffer,4*o.first,t),o}free({page:t,first:r,words:a}){let{gaps:i}=t,o=i.findIndex(l=>l.first>r),s=o<0?i.length:o;i.splice(s,0,{first:r,words:a}),this.#r(i,s),this.#r(i,s-1),i[0]?.words===t.words&&(t.buffer.destroy(),this.#e.splice(this.#e.indexOf(t),1))}#r(t,r){let[a,i]=[t[r],t[r+1]];!a||!i||a.first+a.words!==i.first||(a.words+=i.words,t.splice(r+1,1))}#t(t){for(let r of this.#e){let a=r.gaps.find(i=>i.words>=t);if(a)return{page:r,gap:a}}return null}#n(t){let{maxBufferSize:r,maxStorageBufferBindingSize:a}=this.device.limits,i=Math.min(r,a),o=Math.floor(i/4/ae)*ae;if(t>o)throw new Error(`a view of ${4*t} bytes is larger than the graphics allow`);let s=Math.min(Math.max(t,Xe),o),l=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_DST,u=this.device.createBuffer({label:"page of views",size:4*s,usage:l}),c={first:0,words:s},f={buffer:u,words:s,gaps:[c]};return this.#e.push(f),{page:f,gap:c}}};var Ze={SUN_DIRECTION:[.5263158,.7894737,.3157895],SUN:[.6,.56,.5],SKY_DIRECTION:[-.2062843,.9282791,.3094264],SKY_LOW:[.13,.135,.15],SKY_HIGH:[.38,.42,.48],HORIZON:[.66,.74,.82],ZENITH:[.16,.34,.66],NADIR:[.24,.25,.26]},Te=["SUN_DIRECTION","SUN","SKY_DIRECTION","SKY_LOW","SKY_HIGH"],Oe=["HORIZON","ZENITH","NADIR"],j=n(e=>Number.isInteger(e)?e.toFixed(1):String(e),"float"),Se=n(e=>Ze[e].map(j).join(", "),"vector"),Ge=n(e=>e.map(t=>`const vec3 ${t} = vec3(${Se(t)});`).join(`
`),"glsl"),Qe=n(e=>e.map(t=>`const ${t} = vec3<f32>(${Se(t)});`).join(`
`),"wgsl"),Fr=`
${Ge(Te)}

vec3 irradiance(vec3 n) {
float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`;var Dr=`
${Ge(Oe)}

vec3 background(vec3 direction) {
return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`;var q=`
${Qe([...Te,...Oe])}

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
`;var $=64,X=16384,re=16,Z=`
struct Draw {
gradients: array<vec4<f32>, 3>,
rays: array<vec4<f32>, 3>,
size: vec4<u32>,
work: vec4<u32>,
all: vec4<u32>,
nearest: f32,
}

@group(0) @binding(0) var<uniform> draw: Draw;
`,Ue=`
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
farthest = min(farthest, atomicLoad(&orders[y * draw.size.x + x]));
}
}
atomicStore(&tiles[1u + number], farthest);
}
`,Ee=`
${Z}
@group(0) @binding(1) var depths: texture_depth_2d;
@group(0) @binding(2) var<storage, read_write> orders: array<u32>;

@compute @workgroup_size(${$})
fn begin(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
let sample = (group.y * ${X}u + group.x) * ${$}u + lane;
if sample >= draw.size.x * draw.size.y {
return;
}
let position = vec2<u32>(sample % draw.size.x, sample / draw.size.x);
orders[sample] = bitcast<u32>(textureLoad(depths, position, 0));
}
`,Me=`
${Z}
@group(0) @binding(1) var geometry: texture_2d<f32>;
@group(0) @binding(2) var<storage, read> orders: array<u32>;
@group(0) @binding(3) var<storage, read> colors: array<u32>;
${q}
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
} else if orders[sample] != 0u {
sum += textureLoad(geometry, in_band, 0).rgb;
} else {
let center = vec2<f32>(position) + 0.5;
sum += background(normalize(draw.rays[0].xyz + center.x * draw.rays[1].xyz + center.y * draw.rays[2].xyz));
}
}
}
return vec4<f32>(srgb_of(sum / f32(grid * grid)), 1.0);
}
`;var Je=256,Be=`
${Z}
struct Part {
view: u32,
first: u32,
count: u32,
number: u32,
order: u32,
low: u32,
high: u32,
page: u32,
}

@group(0) @binding(1) var<storage, read> views: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> parts: array<Part>;
@group(0) @binding(3) var<storage, read> part_order: array<u32>;
@group(0) @binding(4) var<storage, read> words: array<u32>;
@group(0) @binding(5) var<storage, read_write> tiles: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> orders: array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> colors: array<atomic<u32>>;
${q}
const TILE = ${re}u;
const GROUP = ${$}u;
const ROW = ${X}u;
const BATCH = 1024u;
const RADIUS = ${j(Math.sqrt(J))};
const SQUARED_RADIUS = ${j(J)};

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
return views[view * ${ee}u + n];
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
let facing = 1.0 / max(dot(view_vector(view, 6u).xyz, normal), ${j(ce)});
let u = column.xyz + dot(view_vector(view, 4u).xyz, normal) * facing * step;
let v = row.xyz - dot(view_vector(view, 5u).xyz, normal) * facing * step;
let is_surfel = ((word.z >> 24u) & 1u) == 1u;
let factor = select(0.0, select(${j(ue)}, 1.0, ((word.z >> 25u) & 1u) == 1u), is_surfel);

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
let order = bitcast<u32>(clamp(draw.nearest * nearness, 1e-30, 1.0));
let sample = (u32(position.y) - draw.size.z) * draw.size.x + u32(position.x);
if draw.work.z == 0u {
atomicMax(&orders[sample], order);
} else if order + SLACK >= atomicLoad(&orders[sample]) {
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
if atomicLoad(&tiles[1u + tile]) <= part.order {
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
if extent.x * extent.y > ${Je}u {
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
${Ue}`;function Ae(e,t){let r=n((G,I)=>{let z=[{buffer:{hasDynamicOffset:!0}},...I];return e.createBindGroupLayout({entries:z.map((N,h)=>({binding:h,visibility:G,...N}))})},"layoutOf"),{COMPUTE:a,FRAGMENT:i,VERTEX:o}=GPUShaderStage,s={buffer:{type:"read-only-storage"}},l={buffer:{type:"storage"}},u=r(o|i,[]),c=r(a,[s,s,s,s,l,l,l]),f=r(a,[{texture:{sampleType:"depth"}},l]),d=r(i,[{texture:{sampleType:"unfilterable-float"}},s,s]),w=n((G,I)=>e.createShaderModule({label:G,code:I}),"moduleOf"),g=n((G,I,z)=>e.createComputePipeline({label:z,layout:e.createPipelineLayout({bindGroupLayouts:[G]}),compute:{module:I,entryPoint:z}}),"computePipeline"),[_,b]=[w("splats",Be),w("resolve",Me)];return{uniformLayout:u,splatLayout:c,beginLayout:f,resolveLayout:d,splats:g(c,_,"splats"),tiles:g(c,_,"farthest_of_tiles"),shade:g(c,_,"shade"),begin:g(f,w("begin",Ee),"begin"),resolve:e.createRenderPipeline({label:"resolve",layout:e.createPipelineLayout({bindGroupLayouts:[d]}),vertex:{module:b},fragment:{module:b,targets:[{format:t}]}})}}n(Ae,"kernelsOf");var ie=class{constructor(t,r){this.common=t;this.#e=new ArrayBuffer(256*r)}common;static{n(this,"Numbers")}#e;#r=0;get all(){return new Uint32Array(this.#e)}put(t,{first:r=0,count:a=0,round:i=0,page:o=0}){let{projector:s,grid:l,nearest:u,parts:c}=this.common,f=256*this.#r,d=new Float32Array(this.#e,f,256/4);return[...s.rows,...s.rays].forEach((w,g)=>d.set(w,4*g)),new Uint32Array(this.#e,f+96,12).set([s.width,t.rows,t.first,l,r,a,i,0,c,o,0,0]),d[36]=u,this.#r+=1,f}};var Re=`
${Z}
struct Mesh {
offset: vec4<f32>,
base: vec4<f32>,
emission: vec4<f32>,
}

@group(1) @binding(0) var<uniform> mesh: Mesh;
@group(2) @binding(0) var image: texture_2d<f32>;
@group(2) @binding(1) var glow: texture_2d<f32>;
@group(2) @binding(2) var smooth_texels: sampler;
${q}
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
`,ze=`
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
`;var K="rgba8unorm-srgb",fe="depth32float",er=[{format:"float32x3",stride:12},{format:"float32x3",stride:12},{format:"float32x2",stride:8},{format:"unorm16x4",stride:8}],rr=0,tr=12;function Ie(e,t){let r=e.createShaderModule({label:"meshes",code:Re}),a=GPUShaderStage.FRAGMENT,o=[{texture:{}},{texture:{}},{sampler:{}}].map((h,S)=>({binding:S,visibility:a,...h})),s=e.createBindGroupLayout({entries:o}),l=[t,t,s],u=e.createPipelineLayout({bindGroupLayouts:l}),c=or(e),f=e.createSampler({addressModeU:"repeat",addressModeV:"repeat",minFilter:"linear",magFilter:"linear",mipmapFilter:"linear"}),d=N(new Uint32Array([0,0,0,4294967295,4294967295]),GPUBufferUsage.VERTEX),w=new Map,g=new W(e,"meshes",GPUBufferUsage.UNIFORM);z(!0,!0,!0,!0);function _(h){let{positions:S,normals:M,uvs:P,colors:U,placements:y,indices:m}=h,p=[S,M,P,U,y].map(x=>x&&N(x,GPUBufferUsage.VERTEX)),O=[h.image,h.glow],v=[...p,N(m,GPUBufferUsage.INDEX)],T=v.reduce((x,E)=>x+(E?.size??0),0);for(let x of O)T+=x?Math.ceil(16*x.width*x.height/3):0;let B=O.map(x=>x&&c.upload(x));return{origin:h.origin,material:h.material,pipeline:z(!0,M!==null,P!==null,U!==null),buffers:p,indices:v.at(-1),format:m instanceof Uint16Array?"uint16":"uint32",corners:m.length,instances:y.length/12,textures:B,group:I(B),bytes:T}}n(_,"upload");function b({buffers:h,indices:S,textures:M}){for(let P of[...h,S,...M])P?.destroy()}n(b,"drop");function G(h,S,M){let P=new Float32Array(256/4*S.length);S.forEach((m,p)=>P.set(nr(m,M),256/4*p));let U={buffer:g.write(P),size:256},y=e.createBindGroup({layout:t,entries:[{binding:0,resource:U}]});return S.reduce((m,p,O)=>(h.setPipeline(p.pipeline),h.setBindGroup(1,y,[256*O]),h.setBindGroup(2,p.group),p.buffers.forEach((v,T)=>{v?h.setVertexBuffer(T,v):h.setVertexBuffer(T,d,T===3?tr:rr)}),h.setIndexBuffer(p.indices,p.format),h.drawIndexed(p.corners,p.instances),m+p.corners/3*p.instances),0)}n(G,"record");function I(h){let M=[...h.map(P=>(P??c.white).createView()),f].map((P,U)=>({binding:U,resource:P}));return e.createBindGroup({layout:s,entries:M})}n(I,"groupOf");function z(...h){let S=h.join(),M=w.get(S);if(M)return M;let P=er.map(({format:p,stride:O},v)=>({arrayStride:h[v]?O:0,attributes:[{shaderLocation:v,offset:0,format:p}]})),U=[0,1,2].map(p=>({shaderLocation:4+p,offset:16*p,format:"float32x4"})),y={arrayStride:48,stepMode:"instance",attributes:U},m=e.createRenderPipeline({label:"meshes",layout:u,vertex:{module:r,buffers:[...P,y]},fragment:{module:r,targets:[{format:K}]},depthStencil:{format:fe,depthWriteEnabled:!0,depthCompare:"greater"}});return w.set(S,m),m}n(z,"pipelineOf");function N(h,S){let M=4*Math.ceil(Math.max(h.byteLength,4)/4),P=e.createBuffer({label:"mesh",size:M,usage:S,mappedAtCreation:!0});return new Uint8Array(P.getMappedRange()).set(new Uint8Array(h.buffer,h.byteOffset,h.byteLength)),P.unmap(),P}return n(N,"bufferOf"),{upload:_,drop:b,record:G}}n(Ie,"createMeshes");function nr({origin:e,material:t},r){let{color:a,cutoff:i,emission:o,isUnlit:s}=t;return[...[e[0]-r[0],e[1]-r[1],e[2]-r[2]],i??-1,...a,...o??[0,0,0],s?1:0]}n(nr,"uniformsOf");function or(e){let t=e.createShaderModule({label:"mipmaps",code:ze}),r=e.createRenderPipeline({label:"mipmaps",layout:"auto",vertex:{module:t},fragment:{module:t,targets:[{format:K}]}}),a=e.createSampler({minFilter:"linear",magFilter:"linear"}),i=s(1,1);e.queue.writeTexture({texture:i},new Uint8Array([255,255,255,255]),{},[1,1]);function o(u){let{width:c,height:f}=u,d=s(c,f);e.queue.copyExternalImageToTexture({source:u},{texture:d},[c,f]),u.close();let w=e.createCommandEncoder();for(let g=1;g<d.mipLevelCount;g++)l(w,d,g);return e.queue.submit([w.finish()]),d}n(o,"upload");function s(u,c){return e.createTexture({label:"image",size:[u,c],format:K,mipLevelCount:1+Math.floor(Math.log2(Math.max(u,c))),usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST|GPUTextureUsage.RENDER_ATTACHMENT})}n(s,"createTexture");function l(u,c,f){let d=n(b=>c.createView({baseMipLevel:b,mipLevelCount:1}),"view"),w={view:d(f),loadOp:"clear",storeOp:"store"},g=u.beginRenderPass({colorAttachments:[w]});g.setPipeline(r);let _=[{binding:0,resource:d(f-1)},{binding:1,resource:a}];g.setBindGroup(0,e.createBindGroup({layout:r.getBindGroupLayout(0),entries:_})),g.draw(3),g.end()}return n(l,"drawMipmap"),{white:i,upload:o}}n(or,"createTextures");var ar=1<<26;function Ne(e,t,r,a){let{maxStorageBufferBindingSize:i,maxTextureDimension2D:o}=e.limits,s=Math.min(Math.min(i,ar)/(4*t),o),l=Math.max(Math.floor(s/a),1)*a;return Array.from({length:Math.ceil(r/l)},(u,c)=>({number:c,first:c*l,rows:Math.min(l,r-c*l)}))}n(Ne,"bandsOf");function pe(e,t){return Math.ceil(e/re)*Math.ceil(t/re)}n(pe,"tilesOf");function Ce(e){let t=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_SRC,r=n(l=>new W(e,l,t),"storage"),[a,i,o]=[r("orders"),r("colors"),r("tiles")],s=null;return{get counts(){return o.ofSize(0)},buffers(l,u){let c=4*l*u,f=4*(1+pe(l,u));return{orders:a.ofSize(c),colors:i.ofSize(c),tiles:o.ofSize(f)}},targets(l,u){if(s&&s.color.width===l&&s.color.height===u)return s;s?.color.destroy(),s?.depth.destroy();let c=GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.TEXTURE_BINDING,f=n(d=>e.createTexture({label:"samples",size:[l,u],format:d,usage:c}),"create");return s={color:f(K),depth:f(fe)},s}}}n(Ce,"createSamples");var Fe=3;var De=8,sr=[1/16,1/8,1/4,1/2];function ke(e,t,r,a){let i=[],o=[],s=new Float32Array(4*ee),l=0;for(let{layer:u,box:c}of e){let f=he(u.model,t),d=_e(u.model,r,c),w=i.length/(4*ee),g=o.length;for(let _ of u.parts){let b=we(f,_,t.width,t.height);if(!b||c&&!ve(d,_))continue;let G=u.first+Fe*_.first;o.push({view:w,firstWord:G,firstSplat:l,count:_.count,bounds:b,page:u.page}),l+=_.count}o.length!==g&&(Pe(s,u.model,f,d),i.push(...s))}return{views:new Float32Array(i),splats:l,...cr(o,l,a)}}n(ke,"workOf");var[ir,lr]=(e=>[new Float32Array(e),new Uint32Array(e)])(new ArrayBuffer(4));function ur(e){return ir[0]=e,lr[0]+(Number.isFinite(e)?1:0)}n(ur,"orderOf");function cr(e,t,r){let a=[...e].sort((c,f)=>fr(f.bounds.nearness,c.bounds.nearness)),i=[...new Set(e.map(({page:c})=>c))],o=new Uint32Array(De*e.length),s=new Map,l=[];for(let c of dr(a,t)){let f=!0;for(let d of i){let w=c.filter(g=>g.page===d);if(w.length!==0){l.push({page:d,startsBatch:f,first:s.size,count:w.length}),f=!1;for(let g of w)o.set(pr(g,i.indexOf(d),r),De*s.size),s.set(g,s.size)}}}let u=new Uint32Array(e.map(c=>s.get(c)));return{parts:o,partOrder:u,pages:i,calls:l}}n(cr,"assignCalls");function fr(e,t){return+(e>t)-+(e<t)}n(fr,"compareNumbers");function pr(e,t,r){let{view:a,firstWord:i,firstSplat:o,count:s,bounds:l}=e,[u,c]=[l.low,l.high].map(([f,d])=>f|d<<16);return[a,i,s,o,ur(r*l.nearness),u,c,t]}n(pr,"wordsOf");function dr(e,t){let r=[[]],[a,i]=[0,0];for(let o of e){let s=sr.filter(l=>a>=t*l).length;s>i&&r.push([]),i=s,r.at(-1)?.push(o),a+=o.count}return r.filter(o=>o.length>0)}n(dr,"batchesOf");function $e(e,t,r,a,i){let o=new se(r),s=Ce(r),l=new W(r,"calls",GPUBufferUsage.UNIFORM),u=n(y=>new W(r,y,GPUBufferUsage.STORAGE),"storage"),[c,f,d]=[u("views"),u("parts"),u("partOrder")],w=r.createTexture({size:[1,1],format:K,usage:GPUTextureUsage.TEXTURE_BINDING}),g=Promise.resolve(),_=0,b=null;function G(y,{words:m,parts:p}){return{model:y,parts:p,...o.put(m)}}n(G,"upload");function I(y){o.free(y)}n(I,"drop");function z(y,m,p,O){let v=me(O,p.width,r.limits.maxTextureDimension2D),T=be({...p,width:p.width*v,height:p.height*v}),B=de(m,y.length>0),x=ke(m,T,t,B),E=Ne(r,T.width,T.height,v),L=E.length*(1+4*x.calls.length+x.pages.length),R=r.createCommandEncoder(),A={encoder:R,meshes:y,projector:T,grid:v,rows:E[0]?.rows??0,work:x,numbers:new ie({projector:T,grid:v,nearest:B,parts:x.partOrder.length},L),uniformBinding:{buffer:l.ofSize(256*L),size:256},views:c.write(x.views),parts:f.write(x.parts),partOrder:d.write(x.partOrder),target:e.getCurrentTexture().createView()},D=0;for(let Q of E)D=N(A,Q);l.write(A.numbers.all),P(R,E);let H=2*x.calls.length+x.pages.length+y.length;return{splats:x.splats,triangles:D,calls:E.length*H}}n(z,"draw");function N(y,m){let{encoder:p,meshes:O,projector:v}=y,T=4*v.width*m.rows,{orders:B,colors:x,tiles:E}=s.buffers(v.width,m.rows),L=O.length>0?s.targets(v.width,y.rows):null;m.number===0&&p.clearBuffer(E,0,4),p.clearBuffer(x,0,T);let R=y.numbers.put(m,{}),A=0;if(L){A=h(y,m,R,L);let Q=[y.uniformBinding,L.depth.createView(),{buffer:B}],Y=p.beginComputePass({label:"begin"});Y.setPipeline(a.begin),Y.setBindGroup(0,U(a.beginLayout,Q),[R]),We(Y,Math.ceil(v.width*m.rows/$)),Y.end()}else p.clearBuffer(B,0,T);S(y,m,[{buffer:E},{buffer:B},{buffer:x}]);let D=(L?.color??w).createView(),H=[y.uniformBinding,D,{buffer:B},{buffer:x}];return M(y,m,R,U(a.resolveLayout,H)),A}n(N,"drawBand");function h(y,{rows:m},p,{color:O,depth:v}){let{encoder:T,meshes:B,projector:x,uniformBinding:E}=y,L=v.createView(),R=T.beginRenderPass({label:"meshes",colorAttachments:[{view:O.createView(),loadOp:"clear",storeOp:"store"}],depthStencilAttachment:{view:L,depthClearValue:0,depthLoadOp:"clear",depthStoreOp:"store"}});R.setViewport(0,0,x.width,m,0,1),R.setBindGroup(0,U(a.uniformLayout,[E]),[p]);let A=i.record(R,B,x.eye);return R.end(),A}n(h,"drawMeshes");function S(y,m,p){let{encoder:O,projector:v,work:T,numbers:B,uniformBinding:x,views:E,parts:L,partOrder:R}=y,A=new Map;for(let k of T.pages){let V=[E,L,R,k.buffer].map(F=>({buffer:F}));A.set(k,U(a.splatLayout,[x,...V,...p]))}let D=O.beginComputePass({label:"splats"}),H=n((k,V,F,Ye)=>{D.setPipeline(k),D.setBindGroup(0,A.get(V),[B.put(m,Ye)]),We(D,F)},"call"),{splats:Q,tiles:Y,shade:He}=a,Ve=Math.ceil(pe(v.width,m.rows)/$);for(let k of[0,1])for(let[V,F]of T.calls.entries())F.startsBatch&&(k===0||V===0)&&H(Y,F.page,Ve,{}),H(Q,F.page,F.count,{first:F.first,count:F.count,round:k});let Ke=Math.ceil(v.width*m.rows/$);for(let[k,V]of T.pages.entries())H(He,V,Ke,{page:k});D.end()}n(S,"drawSplats");function M(y,{number:m,first:p,rows:O},v,T){let{encoder:B,projector:x,grid:E,target:L}=y,R={view:L,loadOp:m===0?"clear":"load",storeOp:"store"},A=B.beginRenderPass({label:"show",colorAttachments:[R]});A.setPipeline(a.resolve),A.setBindGroup(0,T,[v]),A.setScissorRect(0,p/E,x.width/E,O/E),A.draw(3),A.end()}n(M,"show");function P(y,m){let p=r.createBuffer({size:4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST});m.length>0&&y.copyBufferToBuffer(s.counts,0,p,0,4),r.queue.submit([y.finish()]),_+=1;let O=n(()=>{b=new Uint32Array(p.getMappedRange())[0]??0,p.destroy()},"read");g=p.mapAsync(GPUMapMode.READ).then(O,()=>{}).finally(()=>_-=1)}n(P,"submit");function U(y,m){let p=m.map((O,v)=>({binding:v,resource:O}));return r.createBindGroup({layout:y,entries:p})}return n(U,"createGroup"),{upload:G,drop:I,meshes:i,draw:z,get isDone(){return _===0},finish:n(()=>g,"finish"),get unhidden(){return b}}}n($e,"createWebgpuDrawer");function We(e,t){e.dispatchWorkgroups(Math.min(t,X),Math.ceil(t/X))}n(We,"dispatch");var mr="there is too little graphics memory: ?megabytes= in the address sets the limit";async function It(e,t,r,a){let i=navigator.gpu.getPreferredCanvasFormat();r.pushErrorScope("validation");let o=Ae(r,i),s=Ie(r,o.uniformLayout),l=await r.popErrorScope();if(l)throw new Error(l.message);let u=e.getContext("webgpu");if(!u)throw new Error("this browser has no WebGPU for pictures");return u.configure({device:r,format:i,alphaMode:"opaque"}),yr(r,a),$e(u,t,r,o,s)}n(It,"start");function yr(e,t){let[r,a]=[!1,!1],i=n(o=>{r||t(o,!0),r=!0},"lose");e.lost.then(({message:o,reason:s})=>{s!=="destroyed"&&i(`the graphics device is lost: ${o}`)}),e.onuncapturederror=({error:o})=>{o instanceof GPUOutOfMemoryError?a||t(mr,!1):i(`the graphics fail: ${o.message}`),a||=o instanceof GPUOutOfMemoryError}}n(yr,"reportFailures");export{It as start};
