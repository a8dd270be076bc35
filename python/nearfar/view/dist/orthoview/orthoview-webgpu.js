var Ue=Object.defineProperty;var u=(a,e)=>Ue(a,"name",{value:e,configurable:!0});function Q(a,e){let r=1e6;for(let{layer:t}of a)r=Math.min(r,Math.max(t.model.pitch[0],t.model.pitch[1]));return e?Math.min(r/2,.05):r/2}u(Q,"nearDistanceOf");function J(a,e,r){return Math.max(Math.min(a,Math.floor(r/e)),1)}u(J,"gridOf");function V({right:a,up:e,back:r,fov:t,width:n,height:o},s,i){let l=t.left+(t.right-t.left)*s/n,c=t.up+(t.down-t.up)*i/o;return[0,1,2].map(d=>{let[f,m,y]=[a[d],e[d],r[d]];return l*f+c*m-y})}u(V,"directionAt");function N(a,e){return a[0]*e[0]+a[1]*e[1]+a[2]*e[2]}u(N,"dot");function Y({cell:a},e){return a*2**e}u(Y,"sideAt");function ee(a,e,[r,t,n]){let[o,[s,i,l]]=[Y(a,e),a.origin];return[s+r*o,i+t*o,l+n*o]}u(ee,"cornerOf");var[j,z]=[1.27,.5],q=.25,Se=8,L=10;function re(a){let{position:e,right:r,up:t,back:n,fov:o,width:s,height:i}=a,[l,c]=[s/(o.right-o.left),i/(o.up-o.down)],d=u(p=>[p(0),p(1),p(2)],"row"),f=[d(p=>l*(r[p]+o.left*n[p])),d(p=>-c*(t[p]+o.up*n[p])),d(p=>-n[p])],m=V(a,0,0),y=u((p,h)=>{let b=V(a,p,h);return[b[0]-m[0],b[1]-m[1],b[2]-m[2]]},"step");return{eye:e,rows:f,rays:[m,y(1,0),y(0,1)],width:s,height:i}}u(re,"projectorOf");function te(a,{eye:e,rows:r}){let{start:t,steps:n,pitch:o}=a,s=[t[0]-e[0],t[1]-e[1],t[2]-e[2]],i=u(m=>[N(r[0],m),N(r[1],m),N(r[2],m)],"along"),[l,c]=[j*Math.sqrt(z),ne(a)],d=u(m=>Math.max(l,c/m)-.5,"across"),f=l*(o[0]+o[1])/q;return{start:i(s),steps:[i(n[0]),i(n[1]),i(n[2])],least:Math.max(o[0],o[1]),margin:[d(o[0]),d(o[1]),Math.max(f,c)/o[2]]}}u(te,"sightOf");function ne({pitch:a}){return Math.hypot(a[0],a[1])/2}u(ne,"ballOf");function oe({start:a,steps:e,least:r,margin:t},{low:n,high:o},s,i){let[l,c,d,f,m]=[!0,!0,!0,!0,!0],y=Number.POSITIVE_INFINITY,p=[Number.POSITIVE_INFINITY,Number.POSITIVE_INFINITY],h=[Number.NEGATIVE_INFINITY,Number.NEGATIVE_INFINITY];for(let P=0;P<8;P++){let _=n.map((S,I)=>P>>I&1?o[I]+t[I]:S-t[I]),w=u(S=>a[S]+_[0]*e[0][S]+_[1]*e[1][S]+_[2]*e[2][S],"value"),[x,g,v]=[w(0),w(1),w(2)];l&&=x<-v,c&&=x>(s+1)*v,d&&=g<-v,f&&=g>(i+1)*v,m&&=v<r,y=Math.min(y,v),p[0]=Math.min(p[0],x/v),p[1]=Math.min(p[1],g/v),h[0]=Math.max(h[0],x/v),h[1]=Math.max(h[1],g/v)}if(l||c||d||f||m)return null;let b=y<r?Number.POSITIVE_INFINITY:1/y;return y<Se*r?{low:[0,0],high:[s,i],nearness:b}:{low:[Math.max(Math.floor(p[0])-1,0),Math.max(Math.floor(p[1])-1,0)],high:[Math.min(Math.floor(h[0])+2,s),Math.min(Math.floor(h[1])+2,i)],nearness:b}}u(oe,"seenOf");function ae(a,{low:e,high:r}){return a.every(([t,n,o,s])=>{let i=[t,n,o].map((c,d)=>{let[f,m]=[c*e[d],c*r[d]];return[Math.min(f,m),Math.max(f,m)]}),l=u(c=>i.reduce((d,f)=>d+f[c],s),"sum");return l(0)<1&&l(1)>=0})}u(ae,"isIn");function se(a,e,r){if(!r)return[0,1,2].map(()=>[0,0,0,.5]);let t=Y(e,r.level),n=ee(e,r.level,r.place);return[0,1,2].map(o=>{let s=u(i=>a.steps[i][o]/t,"factor");return[s(0),s(1),s(2),(a.start[o]-n[o])/t]})}u(se,"rowsOf");function ie(a,e,r,t){let{frame:n,pitch:o}=e,[s,i,l]=n.axes,c=2/(2**e.normalBits-2),d=u((m,[y,p,h],b)=>a.set([y,p,h,b],4*m),"put"),f=u((m,y)=>[m[0]*y,m[1]*y,m[2]*y],"scaled");d(0,r.start,r.least),d(1,r.steps[0],c),d(2,r.steps[1],ne(e)/Math.sqrt(z)),d(3,r.steps[2],0),d(4,f(s,o[0]/o[2]),0),d(5,f(i,o[1]/o[2]),0),d(6,l,0),t.forEach((m,y)=>a.set(m,4*(7+y)))}u(ie,"writeView");var G=class{constructor(e,r,t){this.device=e;this.label=r;this.usage=t}device;label;usage;static{u(this,"Room")}#e=null;ofSize(e){if(this.#e&&this.#e.size>=e)return this.#e;this.#e?.destroy();let r=Math.max(2**Math.ceil(Math.log2(Math.max(e,1))),256),t=this.usage|GPUBufferUsage.COPY_DST;return this.#e=this.device.createBuffer({label:this.label,size:r,usage:t}),this.#e}with(e){let r=this.ofSize(e.byteLength);return this.device.queue.writeBuffer(r,0,e),r}},Oe=1<<23,C=64,k=class{constructor(e){this.device=e}device;static{u(this,"Arena")}#e=[];put(e){let r=Math.max(Math.ceil(e.length/C),1)*C,{page:t,gap:n}=this.#t(r)??this.#n(r),o={page:t,first:n.first,words:r,bytes:4*r};return n.first+=r,n.words-=r,n.words===0&&t.gaps.splice(t.gaps.indexOf(n),1),this.device.queue.writeBuffer(t.buffer,4*o.first,e),o}free({page:e,first:r,words:t}){let{gaps:n}=e,o=n.findIndex(i=>i.first>r),s=o<0?n.length:o;n.splice(s,0,{first:r,words:t}),this.#r(n,s),this.#r(n,s-1),n[0]?.words===e.words&&(e.buffer.destroy(),this.#e.splice(this.#e.indexOf(e),1))}#r(e,r){let[t,n]=[e[r],e[r+1]];!t||!n||t.first+t.words!==n.first||(t.words+=n.words,e.splice(r+1,1))}#t(e){for(let r of this.#e){let t=r.gaps.find(n=>n.words>=e);if(t)return{page:r,gap:t}}return null}#n(e){let{maxBufferSize:r,maxStorageBufferBindingSize:t}=this.device.limits,n=Math.floor(Math.min(r,t)/4/C)*C;if(e>n)throw new Error(`a view of ${4*e} bytes is larger than the graphics allow`);let o=Math.min(Math.max(e,Oe),n),s=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_DST,i=this.device.createBuffer({label:"page of views",size:4*o,usage:s}),l={first:0,words:o},c={buffer:i,words:o,gaps:[l]};return this.#e.push(c),{page:c,gap:l}}};var Ee={SUN_DIRECTION:[.5263158,.7894737,.3157895],SUN:[.6,.56,.5],SKY_DIRECTION:[-.2062843,.9282791,.3094264],SKY_LOW:[.13,.135,.15],SKY_HIGH:[.38,.42,.48],HORIZON:[.66,.74,.82],ZENITH:[.16,.34,.66],NADIR:[.24,.25,.26]},le=["SUN_DIRECTION","SUN","SKY_DIRECTION","SKY_LOW","SKY_HIGH"],ue=["HORIZON","ZENITH","NADIR"],O=u(a=>Number.isInteger(a)?a.toFixed(1):String(a),"float"),ce=u(a=>Ee[a].map(O).join(", "),"vector"),de=u(a=>a.map(e=>`const vec3 ${e} = vec3(${ce(e)});`).join(`
`),"glsl"),Me=u(a=>a.map(e=>`const ${e} = vec3<f32>(${ce(e)});`).join(`
`),"wgsl"),yr=`
${de(le)}

vec3 irradiance(vec3 n) {
float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`;var hr=`
${de(ue)}

vec3 background(vec3 direction) {
return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`;var E=`
${Me([...le,...ue])}

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
`;var[U,M]=[64,16384],A=16,R=`
struct Draw {
gradients: array<vec4<f32>, 3>,
rays: array<vec4<f32>, 3>,
size: vec4<u32>,
work: vec4<u32>,
all: vec4<u32>,
nearest: f32,
}

@group(0) @binding(0) var<uniform> draw: Draw;
`,fe=`
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
`,me=`
${R}
@group(0) @binding(1) var depths: texture_depth_2d;
@group(0) @binding(2) var<storage, read_write> orders: array<u32>;

@compute @workgroup_size(${U})
fn begin(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
let sample = (group.y * ${M}u + group.x) * ${U}u + lane;
if sample >= draw.size.x * draw.size.y {
return;
}
let at = vec2<u32>(sample % draw.size.x, sample / draw.size.x);
orders[sample] = bitcast<u32>(textureLoad(depths, at, 0));
}
`,pe=`
${R}
@group(0) @binding(1) var geometry: texture_2d<f32>;
@group(0) @binding(2) var<storage, read> orders: array<u32>;
@group(0) @binding(3) var<storage, read> colors: array<u32>;
${E}
@vertex
fn whole(@builtin(vertex_index) n: u32) -> @builtin(position) vec4<f32> {
return vec4<f32>(f32(n & 1u) * 4.0 - 1.0, f32(n >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn resolve(@builtin(position) place: vec4<f32>) -> @location(0) vec4<f32> {
let grid = draw.size.w;
let first = vec2<u32>(place.xy) * grid;
var sum = vec3<f32>(0.0);
for (var row = 0u; row < grid; row++) {
for (var column = 0u; column < grid; column++) {
let at = first + vec2<u32>(column, row);
let own = vec2<u32>(at.x, at.y - draw.size.z);
let sample = own.y * draw.size.x + own.x;
let code = colors[sample];
if code != 0u {
let bits = vec3<u32>(code >> 20u, code >> 10u, code) & vec3<u32>(1023u);
sum += linear_of(vec3<f32>(bits) / 1023.0);
} else if orders[sample] != 0u {
sum += textureLoad(geometry, own, 0).rgb;
} else {
let middle = vec2<f32>(at) + 0.5;
sum += background(normalize(draw.rays[0].xyz + middle.x * draw.rays[1].xyz + middle.y * draw.rays[2].xyz));
}
}
}
return vec4<f32>(srgb_of(sum / f32(grid * grid)), 1.0);
}
`;var Re=256,ye=`
${R}
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
@group(0) @binding(3) var<storage, read> listed: array<u32>;
@group(0) @binding(4) var<storage, read> words: array<u32>;
@group(0) @binding(5) var<storage, read_write> tiles: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> orders: array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> colors: array<atomic<u32>>;
${E}
const TILE = ${A}u;
const GROUP = ${U}u;
const ROW = ${M}u;
const TURN = 1024u;
const RADIUS = ${O(Math.sqrt(z))};
const SQUARED_RADIUS = ${O(z)};

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

fn column_of(view: u32, n: u32) -> vec4<f32> {
return views[view * ${L}u + n];
}

fn disc(view: u32, own: vec3<f32>, place: f32, over: f32) -> f32 {
return length((own - place * draw.gradients[2].xyz) * over) * column_of(view, 2u).w;
}

fn normal_of(codes: u32, scale: f32) -> vec3<f32> {
let flat = vec2<f32>(f32(codes & 4095u), f32((codes >> 12u) & 4095u)) * scale - 1.0;
let z = 1.0 - abs(flat.x) - abs(flat.y);
let fold = max(-z, 0.0);
return normalize(vec3<f32>(flat - select(vec2<f32>(fold), vec2<f32>(-fold), flat < vec2<f32>(0.0)), z));
}

fn ellipse_of(part: Part, number: u32) -> Ellipse {
let at_word = part.first + 3u * number;
let word = vec3<u32>(words[at_word], words[at_word + 1u], words[at_word + 2u]);
let own = part.view;
let column = column_of(own, 1u);
let row = column_of(own, 2u);
let step = column_of(own, 3u).xyz;
let depth = f32(((word.x >> 24u) << 8u) | (word.y >> 24u)) - 0.5;
let at = vec3<f32>(f32(word.z & 4095u) + 0.5, f32((word.z >> 12u) & 4095u) + 0.5, depth);
let box_x = column_of(own, 7u);
let box_y = column_of(own, 8u);
let box_z = column_of(own, 9u);
let inside = vec3<f32>(dot(box_x.xyz, at) + box_x.w, dot(box_y.xyz, at) + box_y.w, dot(box_z.xyz, at) + box_z.w);
let start = column_of(own, 0u);
let function = start.xyz + at.x * column.xyz + at.y * row.xyz + at.z * step;
let over = 1.0 / function.z;
let middle = function.xy * over;

var normal = normal_of(word.y, column.w);
let facing = 1.0 / max(dot(column_of(own, 6u).xyz, normal), ${O(q)});
let u = column.xyz + dot(column_of(own, 4u).xyz, normal) * facing * step;
let v = row.xyz - dot(column_of(own, 5u).xyz, normal) * facing * step;
let is_surfel = ((word.z >> 24u) & 1u) == 1u;
let factor = select(0.0, select(${O(j)}, 1.0, ((word.z >> 25u) & 1u) == 1u), is_surfel);

var found: Ellipse;
found.middle = middle;
found.nearness = vec3<f32>(over, 0.0, 0.0);
let du = (u.xy - middle * u.z) * over * factor;
let dv = (v.xy - middle * v.z) * over * factor;
let slope = -vec2<f32>(u.z, v.z) * over * over * factor;
var half_size = vec2<f32>(0.0);
if is_surfel {
let determinant = du.x * dv.y - dv.x * du.y;
let is_flat = abs(determinant) <= 1.2e-7 * (abs(du.x) + abs(dv.x)) * (abs(du.y) + abs(dv.y));
if is_flat {
found.inverse = vec4<f32>(1e9);
} else {
let inverse = vec4<f32>(dv.y, -dv.x, -du.y, du.x) / determinant;
found.inverse = inverse;
found.nearness.y = slope.x * inverse.x + slope.y * inverse.z;
found.nearness.z = slope.x * inverse.y + slope.y * inverse.w;
half_size = RADIUS * sqrt(vec2<f32>(du.x * du.x + dv.x * dv.x, du.y * du.y + dv.y * dv.y));
}
} else {
let ball = vec2<f32>(
disc(own, draw.gradients[0].xyz, middle.x, over),
disc(own, draw.gradients[1].xyz, middle.y, over),
);
found.inverse = vec4<f32>(1.0 / ball.x, 0.0, 0.0, 1.0 / ball.y);
half_size = RADIUS * ball;
}
let first = f32(draw.size.z);
let least = vec2<f32>(0.0, first);
let most = vec2<f32>(f32(draw.size.x), first + f32(draw.size.y)) - 1.0;
found.low = vec2<i32>(max(min(ceil(middle - half_size - 0.5), floor(middle)), least));
found.high = vec2<i32>(min(max(floor(middle + half_size - 0.5), floor(middle)), most));
found.code = word.x & 0xffffffu;
found.normal = normal;
let is_shown = function.z - RADIUS * factor * length(vec2<f32>(u.z, v.z)) >= start.w
&& all(inside >= vec3<f32>(0.0)) && all(inside < vec3<f32>(1.0));
if !is_shown {
found.low = vec2<i32>(0);
found.high = vec2<i32>(-1);
}
return found;
}

fn cover(own: Ellipse, at: vec2<i32>, number: u32) {
let p = vec2<f32>(at) + 0.5 - own.middle;
let q = vec2<f32>(dot(own.inverse.xy, p), dot(own.inverse.zw, p));
let is_inside = dot(q, q) <= SQUARED_RADIUS;
if !is_inside && any(at != vec2<i32>(floor(own.middle))) {
return;
}
let nearness = own.nearness.x + select(0.0, dot(own.nearness.yz, p), is_inside);
let order = bitcast<u32>(clamp(draw.nearest * nearness, 1e-30, 1.0));
let sample = (u32(at.y) - draw.size.z) * draw.size.x + u32(at.x);
if draw.work.z == 0u {
atomicMax(&orders[sample], order);
} else if order + SLACK >= atomicLoad(&orders[sample]) {
atomicMax(&colors[sample], LAST - number);
}
}

fn extent_of(own: Ellipse) -> vec2<u32> {
return vec2<u32>(max(own.high - own.low + 1, vec2<i32>(0)));
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

var<workgroup> reached: atomic<u32>;
var<workgroup> is_seen: u32;
var<workgroup> large_count: atomic<u32>;
var<workgroup> large: array<u32, TURN>;

@compute @workgroup_size(GROUP)
fn splats(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
let number = group.y * ROW + group.x;
if number >= draw.work.y {
return;
}
let part = parts[draw.work.x + number];
let around = tiles_of(part);
for (var n = lane; n < around.z * around.w; n += GROUP) {
let tile = (around.y + n / around.z) * tile_columns() + around.x + n % around.z;
if atomicLoad(&tiles[1u + tile]) <= part.order {
atomicStore(&reached, 1u);
}
}
workgroupBarrier();
if lane == 0u {
is_seen = atomicLoad(&reached);
if is_seen == 1u && draw.work.z == 0u {
atomicAdd(&tiles[0], part.count);
}
}
if workgroupUniformLoad(&is_seen) == 0u {
return;
}
for (var first = 0u; first < part.count; first += TURN) {
let end = min(first + TURN, part.count);
for (var n = first + lane; n < end; n += GROUP) {
let own = ellipse_of(part, n);
let extent = extent_of(own);
if extent.x * extent.y > ${Re}u {
large[atomicAdd(&large_count, 1u)] = n;
continue;
}
for (var y = own.low.y; y <= own.high.y; y++) {
for (var x = own.low.x; x <= own.high.x; x++) {
cover(own, vec2<i32>(x, y), part.number + n);
}
}
}
workgroupBarrier();
let count = atomicLoad(&large_count);
for (var turn = 0u; turn < count; turn++) {
let n = large[turn];
let own = ellipse_of(part, n);
let extent = extent_of(own);
for (var at = lane; at < extent.x * extent.y; at += GROUP) {
cover(own, own.low + vec2<i32>(vec2<u32>(at % extent.x, at / extent.x)), part.number + n);
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
if parts[listed[middle]].number <= splat {
low = middle;
} else {
high = middle;
}
}
return listed[low];
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
let own = ellipse_of(part, LAST - code - part.number);
let ray = draw.rays[0].xyz + own.middle.x * draw.rays[1].xyz + own.middle.y * draw.rays[2].xyz;
let normal = select(own.normal, -own.normal, dot(own.normal, ray) > 0.0);
let albedo = linear_of(vec3<f32>(vec3<u32>(own.code, own.code >> 8u, own.code >> 16u) & vec3<u32>(255u)) / 255.0);
let bits = vec3<u32>(srgb_of(albedo * irradiance(normal)) * 1023.0 + 0.5);
atomicStore(&colors[sample], COLOR | (bits.x << 20u) | (bits.y << 10u) | bits.z);
}
${fe}`;function he(a,e){let r=u((b,P)=>{let w=[{buffer:{hasDynamicOffset:!0}},...P].map((x,g)=>({binding:g,visibility:b,...x}));return a.createBindGroupLayout({entries:w})},"layoutOf"),{COMPUTE:t,FRAGMENT:n,VERTEX:o}=GPUShaderStage,s={buffer:{type:"read-only-storage"}},i={buffer:{type:"storage"}},l=r(o|n,[]),c=r(t,[s,s,s,s,i,i,i]),d=r(t,[{texture:{sampleType:"depth"}},i]),f=r(n,[{texture:{sampleType:"unfilterable-float"}},s,s]),m=u((b,P)=>a.createShaderModule({label:b,code:P}),"moduleOf"),y=u((b,P,_)=>a.createComputePipeline({label:_,layout:a.createPipelineLayout({bindGroupLayouts:[b]}),compute:{module:P,entryPoint:_}}),"computed"),[p,h]=[m("splats",ye),m("resolve",pe)];return{numbered:l,splatLayout:c,beginLayout:d,resolveLayout:f,splats:y(c,p,"splats"),tiles:y(c,p,"farthest_of_tiles"),shade:y(c,p,"shade"),begin:y(d,m("begin",me),"begin"),resolve:a.createRenderPipeline({label:"resolve",layout:a.createPipelineLayout({bindGroupLayouts:[f]}),vertex:{module:h},fragment:{module:h,targets:[{format:e}]}})}}u(he,"kernelsOf");var F=class{constructor(e,r){this.common=e;this.#e=new ArrayBuffer(256*r)}common;static{u(this,"Numbers")}#e;#r=0;get all(){return new Uint32Array(this.#e)}put(e,{first:r=0,count:t=0,round:n=0,page:o=0}){let{projector:s,grid:i,nearest:l,parts:c}=this.common,d=256*this.#r,f=new Float32Array(this.#e,d,256/4);return[...s.rows,...s.rays].forEach((m,y)=>f.set(m,4*y)),new Uint32Array(this.#e,d+96,12).set([s.width,e.rows,e.first,i,r,t,n,0,c,o,0,0]),f[36]=l,this.#r+=1,d}};var be=`
${R}
struct Mesh {
offset: vec4<f32>,
base: vec4<f32>,
emission: vec4<f32>,
}

@group(1) @binding(0) var<uniform> mesh: Mesh;
@group(2) @binding(0) var image: texture_2d<f32>;
@group(2) @binding(1) var glow: texture_2d<f32>;
@group(2) @binding(2) var smooth_texels: sampler;
${E}
struct Corner {
@builtin(position) place: vec4<f32>,
@location(0) point: vec3<f32>,
@location(1) normal: vec3<f32>,
@location(2) uv: vec2<f32>,
@location(3) color: vec3<f32>,
}

@vertex
fn corner(
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
let x = cross(row_y.xyz, row_z.xyz);
let y = cross(row_z.xyz, row_x.xyz);
let z = cross(row_x.xyz, row_y.xyz);
out.normal = vec3<f32>(dot(x, normal), dot(y, normal), dot(z, normal));
out.uv = uv;
out.color = color.rgb;
let gradients = draw.gradients;
let shown = vec3<f32>(
dot(gradients[0].xyz, out.point),
dot(gradients[1].xyz, out.point),
dot(gradients[2].xyz, out.point),
);
let row = shown.y - f32(draw.size.z) * shown.z;
out.place = vec4<f32>(
2.0 * shown.x / f32(draw.size.x) - shown.z,
shown.z - 2.0 * row / f32(draw.size.y),
draw.nearest,
shown.z,
);
return out;
}

fn shading_normal(own: Corner, face_vector: vec3<f32>) -> vec3<f32> {
let toward = -normalize(own.point);
let size = length(face_vector);
var face = select(toward, face_vector / size, size > 0.0);
face = select(face, -face, dot(face, toward) < 0.0);
let long_normal = length(own.normal);
if long_normal == 0.0 {
return face;
}
let n = own.normal / long_normal;
return select(n, -n, dot(n, face) < 0.0);
}

fn level_of(texture: texture_2d<f32>, right: vec2<f32>, down: vec2<f32>) -> f32 {
let size = vec2<f32>(textureDimensions(texture));
let dx = right * size;
let dy = down * size;
return 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
}

@fragment
fn shade(own: Corner) -> @location(0) vec4<f32> {
let normal = shading_normal(own, cross(dpdx(own.point), dpdy(own.point)));
let right = dpdx(own.uv);
let down = dpdy(own.uv);
let texel = textureSampleLevel(image, smooth_texels, own.uv, level_of(image, right, down));
let light = textureSampleLevel(glow, smooth_texels, own.uv, level_of(glow, right, down)).rgb;
let alpha = mesh.base.a * textureSampleLevel(image, smooth_texels, own.uv, 0.0).a;
if alpha < mesh.offset.w {
discard;
}
let albedo = mesh.base.rgb * own.color * texel.rgb;
return vec4<f32>(albedo * mix(irradiance(normal), vec3<f32>(1.0), mesh.emission.w) + mesh.emission.rgb * light, 1.0);
}
`,ge=`
@group(0) @binding(0) var finer: texture_2d<f32>;
@group(0) @binding(1) var smooth_texels: sampler;

struct Corner {
@builtin(position) place: vec4<f32>,
@location(0) uv: vec2<f32>,
}

@vertex
fn whole(@builtin(vertex_index) n: u32) -> Corner {
let at = vec2<f32>(f32(n & 1u) * 2.0, f32(n >> 1u) * 2.0);
return Corner(vec4<f32>(at.x * 2.0 - 1.0, 1.0 - at.y * 2.0, 0.0, 1.0), at);
}

@fragment
fn level(own: Corner) -> @location(0) vec4<f32> {
return textureSampleLevel(finer, smooth_texels, own.uv, 0.0);
}
`;var B="rgba8unorm-srgb",X="depth32float",ze=[{format:"float32x3",stride:12},{format:"float32x3",stride:12},{format:"float32x2",stride:8},{format:"unorm16x4",stride:8}],Le=0,Ae=12,D=class{constructor(e,r){this.device=e;this.uniformLayout=r;this.#e=e.createShaderModule({label:"meshes",code:be});let t=GPUShaderStage.FRAGMENT;this.#r=e.createBindGroupLayout({entries:[{binding:0,visibility:t,texture:{}},{binding:1,visibility:t,texture:{}},{binding:2,visibility:t,sampler:{}}]}),this.#t=e.createPipelineLayout({bindGroupLayouts:[r,r,this.#r]}),this.#n=new K(e),this.#o=e.createSampler({addressModeU:"repeat",addressModeV:"repeat",minFilter:"linear",magFilter:"linear",mipmapFilter:"linear"}),this.#a=this.#u(new Uint32Array([0,0,0,4294967295,4294967295]),GPUBufferUsage.VERTEX),this.#i=new G(e,"meshes",GPUBufferUsage.UNIFORM),this.#c(!0,!0,!0,!0)}device;uniformLayout;static{u(this,"Meshes")}#e;#r;#t;#n;#o;#a;#s=new Map;#i;upload(e){let{positions:r,normals:t,uvs:n,colors:o,placements:s,indices:i}=e,l=u(p=>p&&this.#u(p,GPUBufferUsage.VERTEX),"fill"),c=[r,t,n,o,s].map(l),d=[e.image,e.glow],f=[...c,this.#u(i,GPUBufferUsage.INDEX)],m=f.reduce((p,h)=>p+(h?.size??0),0);for(let p of d)m+=p?Math.ceil(16*p.width*p.height/3):0;let y=d.map(p=>p&&this.#n.upload(p));return{origin:e.origin,material:e.material,pipeline:this.#c(!0,t!==null,n!==null,o!==null),buffers:c,indices:f.at(-1),format:i instanceof Uint16Array?"uint16":"uint32",corners:i.length,instances:s.length/12,textures:y,group:this.#l(y),bytes:m}}drop({buffers:e,indices:r,textures:t}){for(let n of[...e,r,...t])n?.destroy()}record(e,r,t){let n=new Float32Array(256/4*r.length);r.forEach((i,l)=>n.set(Be(i,t),256/4*l));let o={buffer:this.#i.with(n),size:256},s=this.device.createBindGroup({layout:this.uniformLayout,entries:[{binding:0,resource:o}]});return r.reduce((i,l,c)=>(e.setPipeline(l.pipeline),e.setBindGroup(1,s,[256*c]),e.setBindGroup(2,l.group),l.buffers.forEach((d,f)=>{d?e.setVertexBuffer(f,d):e.setVertexBuffer(f,this.#a,f===3?Ae:Le)}),e.setIndexBuffer(l.indices,l.format),e.drawIndexed(l.corners,l.instances),i+l.corners/3*l.instances),0)}#l(e){let t=[...e.map((n,o)=>({binding:o,resource:(n??this.#n.white).createView()})),{binding:2,resource:this.#o}];return this.device.createBindGroup({layout:this.#r,entries:t})}#c(...e){let r=e.join(),t=this.#s.get(r);if(t)return t;let n=ze.map(({format:l,stride:c},d)=>({arrayStride:e[d]?c:0,attributes:[{shaderLocation:d,offset:0,format:l}]})),o=[0,1,2].map(l=>({shaderLocation:4+l,offset:16*l,format:"float32x4"})),s={arrayStride:48,stepMode:"instance",attributes:o},i=this.device.createRenderPipeline({label:"meshes",layout:this.#t,vertex:{module:this.#e,buffers:[...n,s]},fragment:{module:this.#e,targets:[{format:B}]},depthStencil:{format:X,depthWriteEnabled:!0,depthCompare:"greater"}});return this.#s.set(r,i),i}#u(e,r){let t=4*Math.ceil(Math.max(e.byteLength,4)/4),n=this.device.createBuffer({label:"mesh",size:t,usage:r,mappedAtCreation:!0});return new Uint8Array(n.getMappedRange()).set(new Uint8Array(e.buffer,e.byteOffset,e.byteLength)),n.unmap(),n}};function Be({origin:a,material:e},r){let{color:t,cutoff:n,emission:o,isUnlit:s}=e;return[...[a[0]-r[0],a[1]-r[1],a[2]-r[2]],n??-1,...t,...o??[0,0,0],s?1:0]}u(Be,"uniformsOf");var xe="rgba8unorm-srgb",K=class{constructor(e){this.device=e;let r=e.createShaderModule({label:"mipmaps",code:ge});this.#e=e.createRenderPipeline({label:"mipmaps",layout:"auto",vertex:{module:r},fragment:{module:r,targets:[{format:xe}]}}),this.#r=e.createSampler({minFilter:"linear",magFilter:"linear"}),this.white=this.#t(1,1),e.queue.writeTexture({texture:this.white},new Uint8Array([255,255,255,255]),{},[1,1])}device;static{u(this,"Textures")}#e;#r;white;upload(e){let{width:r,height:t}=e,n=this.#t(r,t);this.device.queue.copyExternalImageToTexture({source:e},{texture:n},[r,t]),e.close();let o=this.device.createCommandEncoder();for(let s=1;s<n.mipLevelCount;s++)this.#n(o,n,s);return this.device.queue.submit([o.finish()]),n}#t(e,r){return this.device.createTexture({label:"image",size:[e,r],format:xe,mipLevelCount:1+Math.floor(Math.log2(Math.max(e,r))),usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST|GPUTextureUsage.RENDER_ATTACHMENT})}#n(e,r,t){let n=u(i=>r.createView({baseMipLevel:i,mipLevelCount:1}),"view"),o=e.beginRenderPass({colorAttachments:[{view:n(t),loadOp:"clear",storeOp:"store"}]});o.setPipeline(this.#e);let s=[{binding:0,resource:n(t-1)},{binding:1,resource:this.#r}];o.setBindGroup(0,this.device.createBindGroup({layout:this.#e.getBindGroupLayout(0),entries:s})),o.draw(3),o.end()}};var Ie=1<<26;function ve(a,e,r,t){let{maxStorageBufferBindingSize:n,maxTextureDimension2D:o}=a.limits,s=Math.min(Math.min(n,Ie)/(4*e),o),i=Math.max(Math.floor(s/t),1)*t;return Array.from({length:Math.ceil(r/i)},(l,c)=>({number:c,first:c*i,rows:Math.min(i,r-c*i)}))}u(ve,"bandsOf");function Z(a,e){return Math.ceil(a/A)*Math.ceil(e/A)}u(Z,"tilesOf");var $=class{constructor(e){this.device=e;let r=u(t=>new G(e,t,GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_SRC),"room");[this.#e,this.#r,this.#t]=[r("orders"),r("colors"),r("tiles")]}device;static{u(this,"Samples")}#e;#r;#t;#n=null;get counts(){return this.#t.ofSize(0)}buffers(e,r){let t=4*e*r,n=this.#t.ofSize(4*(1+Z(e,r)));return{orders:this.#e.ofSize(t),colors:this.#r.ofSize(t),tiles:n}}targets(e,r){let t=this.#n;if(t&&t.color.width===e&&t.color.height===r)return t;t?.color.destroy(),t?.depth.destroy();let n=GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.TEXTURE_BINDING,o=u(s=>this.device.createTexture({label:"samples",size:[e,r],format:s,usage:n}),"made");return this.#n={color:o(B),depth:o(X)},this.#n}};var Pe=3;var Te=8,W=[1/16,1/8,1/4,1/2];function _e(a,e,r,t){let n=[],o=[],s=new Float32Array(4*L),i=0;for(let{layer:l,box:c}of a){let d=te(l.model,e),f=se(l.model,r,c),m=n.length/(4*L),y=o.length;for(let p of l.parts){let h=oe(d,p,e.width,e.height);if(!h||c&&!ae(f,p))continue;let{count:b}=p;o.push({view:m,first:l.first+Pe*p.first,number:i,count:b,place:h,page:l.page}),i+=b}o.length!==y&&(ie(s,l.model,d,f),n.push(...s))}return{views:new Float32Array(n),splats:i,...Fe(o,i,t)}}u(_e,"workOf");var[Ne,Ce]=(a=>[new Float32Array(a),new Uint32Array(a)])(new ArrayBuffer(4));function ke(a){return Ne[0]=a,Ce[0]+(Number.isFinite(a)?1:0)}u(ke,"orderOf");function Fe(a,e,r){let t=[...a].sort((c,d)=>De(d.place.nearness,c.place.nearness)),n=[...new Set(a.map(({page:c})=>c))],o=new Uint32Array(Te*a.length),s=new Map,i=[];for(let c of We(t,e)){let d=!0;for(let f of n){let m=c.filter(y=>y.page===f);if(m.length!==0){i.push({page:f,begins:d,first:s.size,count:m.length}),d=!1;for(let y of m)o.set($e(y,n.indexOf(f),r),Te*s.size),s.set(y,s.size)}}}let l=new Uint32Array(a.map(c=>s.get(c)));return{parts:o,listed:l,pages:n,calls:i}}u(Fe,"assignCalls");function De(a,e){return+(a>e)-+(a<e)}u(De,"compareNumbers");function $e({view:a,first:e,number:r,count:t,place:n},o,s){let{low:i,high:l,nearness:c}=n,d=ke(s*c);return[a,e,t,r,d,i[0]|i[1]<<16,l[0]|l[1]<<16,o]}u($e,"numbersOf");function We(a,e){let r=[],[t,n,o]=[[],0,0];for(let s of a)if(t.push(s),n+=s.count,!(o>=W.length||n<e*W[o])){for(;o<W.length&&n>=e*W[o];)o+=1;r.push(t),t=[]}return t.length>0&&r.push(t),r}u(We,"batchesOf");var H=class{constructor(e,r,t,n,o){this.context=e;this.layout=r;this.device=t;this.kernels=n;this.meshes=o;this.#e=new k(t),this.#r=new $(t),this.#t=new G(t,"calls",GPUBufferUsage.UNIFORM);let s=u(i=>new G(t,i,GPUBufferUsage.STORAGE),"room");[this.#n,this.#o,this.#a]=[s("views"),s("parts"),s("listed")],this.#s=t.createTexture({size:[1,1],format:B,usage:GPUTextureUsage.TEXTURE_BINDING})}context;layout;device;kernels;meshes;static{u(this,"WebgpuDrawer")}#e;#r;#t;#n;#o;#a;#s;#i=Promise.resolve();#l=0;unhidden=null;upload(e,{words:r,parts:t}){let n=this.#e.put(r);return{model:e,parts:t,page:n.page,first:n.first,place:n,bytes:n.bytes}}drop({place:e}){this.#e.free(e)}uploadMesh(e){return this.meshes.upload(e)}dropMesh(e){this.meshes.drop(e)}draw(e,r,t,n){let o=J(n,t.width,this.device.limits.maxTextureDimension2D),s=re({...t,width:t.width*o,height:t.height*o}),i=Q(r,e.length>0),l=_e(r,s,this.layout,i),c=ve(this.device,s.width,s.height,o),d=c.length*(1+4*l.calls.length+l.pages.length),f={meshes:e,projector:s,grid:o,rows:c[0]?.rows??0,work:l,numbers:new F({projector:s,grid:o,nearest:i,parts:l.listed.length},d),bound:{buffer:this.#t.ofSize(256*d),size:256},views:this.#n.with(l.views),parts:this.#o.with(l.parts),listed:this.#a.with(l.listed),target:this.context.getCurrentTexture().createView()},m=this.device.createCommandEncoder(),y=0;for(let h of c)y=this.#c(m,f,h);this.#t.with(f.numbers.all),this.#p(m,c);let p=2*l.calls.length+l.pages.length+e.length;return{splats:l.splats,triangles:y,calls:c.length*p}}get isDone(){return this.#l===0}finish(){return this.#i}#c(e,r,t){let{meshes:n,projector:o}=r,s=4*o.width*t.rows,{orders:i,colors:l,tiles:c}=this.#r.buffers(o.width,t.rows),d=n.length>0?this.#r.targets(o.width,r.rows):null;t.number===0&&e.clearBuffer(c,0,4),e.clearBuffer(l,0,s);let f=r.numbers.put(t,{}),m=0;if(d){m=this.#u(e,r,t,f,d);let p=this.#d(this.kernels.beginLayout,[r.bound,d.depth.createView(),{buffer:i}]),h=e.beginComputePass({label:"begin"});h.setPipeline(this.kernels.begin),h.setBindGroup(0,p,[f]),Ge(h,Math.ceil(o.width*t.rows/U)),h.end()}else e.clearBuffer(i,0,s);this.#f(e,r,t,[{buffer:c},{buffer:i},{buffer:l}]);let y=[r.bound,(d?.color??this.#s).createView(),{buffer:i},{buffer:l}];return this.#m(e,r,t,f,this.#d(this.kernels.resolveLayout,y)),m}#u(e,{meshes:r,projector:t,bound:n},{rows:o},s,{color:i,depth:l}){let c=e.beginRenderPass({label:"meshes",colorAttachments:[{view:i.createView(),loadOp:"clear",storeOp:"store"}],depthStencilAttachment:{view:l.createView(),depthClearValue:0,depthLoadOp:"clear",depthStoreOp:"store"}});c.setViewport(0,0,t.width,o,0,1),c.setBindGroup(0,this.#d(this.kernels.numbered,[n]),[s]);let d=this.meshes.record(c,r,t.eye);return c.end(),d}#f(e,{projector:r,work:t,numbers:n,bound:o,views:s,parts:i,listed:l},c,d){let f=new Map;for(let w of t.pages){let x=[s,i,l,w.buffer].map(g=>({buffer:g}));f.set(w,this.#d(this.kernels.splatLayout,[o,...x,...d]))}let m=e.beginComputePass({label:"splats"}),y=u((w,x,g,v)=>{m.setPipeline(w),m.setBindGroup(0,f.get(x),[n.put(c,v)]),Ge(m,g)},"call"),{splats:p,tiles:h,shade:b}=this.kernels,P=Math.ceil(Z(r.width,c.rows)/U);for(let w of[0,1])for(let[x,g]of t.calls.entries())g.begins&&(w===0||x===0)&&y(h,g.page,P,{}),y(p,g.page,g.count,{first:g.first,count:g.count,round:w});let _=Math.ceil(r.width*c.rows/U);for(let[w,x]of t.pages.entries())y(b,x,_,{page:w});m.end()}#m(e,{projector:r,grid:t,target:n},{number:o,first:s,rows:i},l,c){let d=o===0?"clear":"load",f=e.beginRenderPass({label:"show",colorAttachments:[{view:n,loadOp:d,storeOp:"store"}]});f.setPipeline(this.kernels.resolve),f.setBindGroup(0,c,[l]),f.setScissorRect(0,s/t,r.width/t,i/t),f.draw(3),f.end()}#p(e,r){let t=this.device.createBuffer({size:4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST});r.length>0&&e.copyBufferToBuffer(this.#r.counts,0,t,0,4),this.device.queue.submit([e.finish()]),this.#l+=1;let n=u(()=>{this.unhidden=new Uint32Array(t.getMappedRange())[0]??0,t.destroy()},"read");this.#i=t.mapAsync(GPUMapMode.READ).then(n,()=>{}).finally(()=>this.#l-=1)}#d(e,r){let t=r.map((n,o)=>({binding:o,resource:n}));return this.device.createBindGroup({layout:e,entries:t})}};function Ge(a,e){a.dispatchWorkgroups(Math.min(e,M),Math.ceil(e/M))}u(Ge,"dispatch");var He="there is too little graphics memory: ?megabytes= in the address sets the limit";async function ft(a,e,r,t){let n=navigator.gpu.getPreferredCanvasFormat();r.pushErrorScope("validation");let o=he(r,n),s=new D(r,o.numbered),i=await r.popErrorScope();if(i)throw new Error(i.message);let l=a.getContext("webgpu");if(!l)throw new Error("this browser has no WebGPU for pictures");return l.configure({device:r,format:n,alphaMode:"opaque"}),Ve(r,t),new H(l,e,r,o,s)}u(ft,"start");function Ve(a,e){let[r,t]=[!1,!1],n=u(o=>{r||e(o,!0),r=!0},"lose");a.lost.then(({message:o,reason:s})=>s!=="destroyed"&&n(`the graphics device is lost: ${o}`)),a.onuncapturederror=({error:o})=>{o instanceof GPUOutOfMemoryError?t||e(He,!1):n(`the graphics fail: ${o.message}`),t||=o instanceof GPUOutOfMemoryError}}u(Ve,"tellFailures");export{ft as start};
