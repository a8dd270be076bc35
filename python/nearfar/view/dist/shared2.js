import{$ as R,B as x,H as b,T as M,_ as V,a as s,ba as E,da as A,ea as O,h as m}from"./shared.js";var $={now:s(()=>performance.now()/1e3,"now"),later(o,t){let e=setTimeout(t,1e3*o);return()=>clearTimeout(e)}};var v=class extends Error{static{s(this,"FrameError")}},S=class{constructor(t){this.bytes=t;this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}bytes;static{s(this,"Reader")}at=0;view;get isAtEnd(){return this.at===this.bytes.length}u8(){return this.view.getUint8(this.step(1))}u16(){return this.view.getUint16(this.step(2),!0)}i16(){return this.view.getInt16(this.step(2),!0)}u32(){return this.view.getUint32(this.step(4),!0)}u64(){return this.view.getBigUint64(this.step(8),!0)}f32(){return this.view.getFloat32(this.step(4),!0)}take(t){let e=this.step(t);return this.bytes.subarray(e,e+t)}rest(t){let e=this.bytes.length-this.at;if(e>t)throw new v("a payload is too long");return this.take(e)}end(t="a frame is too long"){if(!this.isAtEnd)throw new v(t)}step(t){let e=this.at;if(e+t>this.bytes.length)throw new v("a frame is too short");return this.at=e+t,e}},_=class{static{s(this,"Writer")}bytes=[];view=new DataView(new ArrayBuffer(8));get length(){return this.bytes.length}u8(t){this.bytes.push(t&255)}u16(t){this.view.setUint16(0,t,!0),this.add(2)}i16(t){this.view.setInt16(0,t,!0),this.add(2)}u32(t){this.view.setUint32(0,t,!0),this.add(4)}u64(t){this.view.setBigUint64(0,t,!0),this.add(8)}f32(t){this.view.setFloat32(0,t,!0),this.add(4)}put(t){this.bytes.push(...t)}done(){return Uint8Array.from(this.bytes)}add(t){for(let e=0;e<t;e++)this.bytes.push(this.view.getUint8(e))}};function T(o,t){let[e,r,n,i]=[Math.sin(o/2),Math.cos(o/2),Math.sin(t/2),Math.cos(t/2)];return[r*n,e*i,-e*n,r*i]}s(T,"rotationOf");function Y([o,t,e]){return T(Math.atan2(-o,-e),Math.atan2(t,Math.hypot(o,e)))}s(Y,"rotationAlong");function K([o,t,e,r],[n,i,h]){let[u,c,a]=[2*(t*h-e*i),2*(e*n-o*h),2*(o*i-t*n)];return[n+r*u+t*a-e*c,i+r*c+e*u-o*a,h+r*a+o*c-t*u]}s(K,"rotated");function J(o,t,e){let r=o.reduce((a,p,f)=>a+p*(t[f]??0),0),n=r<0?-1:1,[i,h]=[1-e,e];if(Math.abs(r)<.9995){let a=Math.acos(Math.abs(r));[i,h]=[Math.sin((1-e)*a)/Math.sin(a),Math.sin(e*a)/Math.sin(a)]}let u=o.map((a,p)=>i*a+n*h*(t[p]??0)),c=Math.hypot(...u)||1;return u.map(a=>a/c)}s(J,"slerp");var B=.618034,[I,H]=[.75,.6];function g(o){return new x().setHSL(o*B%1,I,H)}s(g,"colorOf");function tt(o){return`#${g(o).getHexString()}`}s(tt,"cssOf");function at(o,t,e,r,n){let i=new M({...O,vertexShader:e,fragmentShader:E,defines:r,uniforms:{...t,...n,cut:{value:A}}}),h=new b(o,i);return h.frustumCulled=!1,h.matrixAutoUpdate=!1,h}s(at,"drawn");function ht({material:o},t,e){(o.uniforms[t]?.value).set(...e)}s(ht,"setPoint");function ct(o,t){let{r:e,g:r,b:n}=g(t);o.set(e,r,n,1)}s(ct,"paint");var[D,P,G]=[40,1e-5,1e-7];function l(o,{user:t,inner:e,radius:r,strength:n}){let i=m(o,t),h=Math.hypot(o[0],o[2]);if(n===1&&h<=e)return i;let u=n*(r>e?Math.min(Math.max((r-h)/(r-e),0),1):0),[c,a]=[Math.hypot(...i),Math.hypot(...o)],[p,f]=[u/Math.max(c,1e-30),(1-u)/Math.max(a,1e-30)],d=[p*i[0]+f*o[0],p*i[1]+f*o[1],p*i[2]+f*o[2]],w=(u*c+(1-u)*a)/(Math.hypot(...d)||1);return[w*d[0],w*d[1],w*d[2]]}s(l,"shownAt");function mt(o,t){let{user:e,inner:r,radius:n,strength:i}=t,h=[o[0]+e[0],o[1]+e[1],o[2]+e[2]];if(i===1&&Math.hypot(h[0],h[2])<=r)return h;if(Math.hypot(o[0],o[2])>=n)return o;let u=[h,o].sort((c,a)=>U(l(c,t),o)-U(l(a,t),o));for(let c of u){let a=C(c,o,t);if(a)return a}return null}s(mt,"pointShownAt");function C(o,t,e){let r=G*Math.max(Math.hypot(...t),1),n=o,i=m(t,l(n,e));for(let h=0;h<D&&Math.hypot(...i)>r;h++){let u=F(L(n,e),i);if(!u)return null;for(let c=1;c>.001;c/=2){let a=[n[0]+c*u[0],n[1]+c*u[1],n[2]+c*u[2]],p=m(t,l(a,e));if(!(Math.hypot(...p)>=Math.hypot(...i)&&c>.002)){[n,i]=[a,p];break}}}return Math.hypot(...i)<=r?n:null}s(C,"sought");function L(o,t){let e=P*Math.max(Math.hypot(...o),1),r=s(n=>{let i=s(a=>o.map((p,f)=>f===n?p+a:p),"moved"),[h,u,c]=m(l(i(e),t),l(i(-e),t));return[h/(2*e),u/(2*e),c/(2*e)]},"along");return[r(0),r(1),r(2)]}s(L,"slopes");function F([o,t,e],r){let n=y(o,t,e);return Math.abs(n)>1e-9?[y(r,t,e)/n,y(o,r,e)/n,y(o,t,r)/n]:null}s(F,"solved");function y(o,t,e){return o[0]*(t[1]*e[2]-t[2]*e[1])-t[0]*(o[1]*e[2]-o[2]*e[1])+e[0]*(o[1]*t[2]-o[2]*t[1])}s(y,"determinant");function U(o,t){return Math.hypot(...m(o,t))}s(U,"size");var k=`
mat3 facing(vec3 at) {
  vec3 toward = -normalize(at);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`,N=`
${V}
${R}
${k}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`,yt=`
${N}
// Share of the way, 2 for the spot; and how far to the side and up, in parts of the half width.
in vec3 position;
uniform vec3 begin;
uniform vec3 end;
// Tangent of the angle that a pixel covers.
uniform float pixel;
// Half widths: the least, metres, in pixels, so that no gaps are seen, and of the spot as the tangent of an angle.
const vec2 RIBBON = vec2(0.003, 0.75);
const vec3 SPOT = vec3(0.02, 2.5, 0.004);
// Part of the way to the spot by which it is drawn nearer, in front of the surface that it lies on.
const float BEFORE = 0.985;
// Share of the way to the point that tells which way the ribbon goes on.
const float ONWARDS = 0.004;

void main() {
  bool is_spot = position.x > 1.5;
  float share = min(position.x, 1.0);
  v_point = mix(begin, end, share);
  vec3 at = shown(v_point);
  float away = length(at);
  if (is_spot) {
    mat3 axes = facing(at);
    // From the centre, too, whose ranges the map holds.
    v_point *= BEFORE;
    v_shown = BEFORE * at;
    v_shown += (axes[0] * position.y + axes[1] * position.z) * max(SPOT.x, max(SPOT.y * pixel, SPOT.z) * away);
  } else {
    vec3 side = cross(shown(mix(begin, end, share + ONWARDS)) - at, at);
    side = dot(side, side) > 0.0 ? normalize(side) : vec3(0.0, 1.0, 0.0);
    v_shown = at + side * position.y * max(RIBBON.x, RIBBON.y * pixel * away);
  }
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`,wt=`
${N}
in vec3 position;
in vec2 uv;
out vec2 v_uv;
uniform vec3 begin;
// Width in parts of the height.
uniform float ratio;
// Least height, metres, and the tangent of the least angle.
const vec2 HEIGHT = vec2(0.08, 0.032);

void main() {
  v_point = begin;
  v_uv = uv;
  vec3 at = shown(v_point);
  mat3 axes = facing(at);
  v_shown = at + (axes[0] * position.x * ratio + axes[1] * position.y) * max(HEIGHT.x, HEIGHT.y * length(at));
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;export{$ as a,v as b,S as c,_ as d,g as e,tt as f,at as g,ht as h,ct as i,T as j,Y as k,K as l,J as m,N as n,yt as o,wt as p,l as q,mt as r};
