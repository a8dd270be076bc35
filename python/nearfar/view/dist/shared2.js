import{$ as R,B as b,H as x,T as M,_ as V,a as s,ba as E,da as A,ea as O,h as f}from"./shared.js";var $={now:s(()=>performance.now()/1e3,"now"),later(o,t){let e=setTimeout(t,1e3*o);return()=>clearTimeout(e)}};var d=class extends Error{static{s(this,"FrameError")}},S=class{constructor(t){this.bytes=t;this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}bytes;static{s(this,"Reader")}at=0;view;get isAtEnd(){return this.at===this.bytes.length}u8(){return this.view.getUint8(this.step(1))}u16(){return this.view.getUint16(this.step(2),!0)}i16(){return this.view.getInt16(this.step(2),!0)}u32(){return this.view.getUint32(this.step(4),!0)}u64(){return this.view.getBigUint64(this.step(8),!0)}f32(){return this.view.getFloat32(this.step(4),!0)}take(t){let e=this.step(t);return this.bytes.subarray(e,e+t)}rest(t){let e=this.bytes.length-this.at;if(e>t)throw new d("a payload is too long");return this.take(e)}end(t="a frame is too long"){if(!this.isAtEnd)throw new d(t)}step(t){let e=this.at;if(e+t>this.bytes.length)throw new d("a frame is too short");return this.at=e+t,e}},_=class{static{s(this,"Writer")}bytes=[];view=new DataView(new ArrayBuffer(8));get length(){return this.bytes.length}u8(t){this.bytes.push(t&255)}u16(t){this.view.setUint16(0,t,!0),this.add(2)}i16(t){this.view.setInt16(0,t,!0),this.add(2)}u32(t){this.view.setUint32(0,t,!0),this.add(4)}u64(t){this.view.setBigUint64(0,t,!0),this.add(8)}f32(t){this.view.setFloat32(0,t,!0),this.add(4)}put(t){this.bytes.push(...t)}done(){return Uint8Array.from(this.bytes)}add(t){for(let e=0;e<t;e++)this.bytes.push(this.view.getUint8(e))}};function B(o,t){let[e,n,r,i]=[Math.sin(o/2),Math.cos(o/2),Math.sin(t/2),Math.cos(t/2)];return[n*r,e*i,-e*r,n*i]}s(B,"rotationOf");function Y([o,t,e]){return B(Math.atan2(-o,-e),Math.atan2(t,Math.hypot(o,e)))}s(Y,"rotationAlong");function K([o,t,e,n],[r,i,a]){let[u,h,c]=[2*(t*a-e*i),2*(e*r-o*a),2*(o*i-t*r)];return[r+n*u+t*c-e*h,i+n*h+e*u-o*c,a+n*c+o*h-t*u]}s(K,"rotated");function J(o,t,e){let n=o.reduce((c,m,p)=>c+m*(t[p]??0),0),r=n<0?-1:1,[i,a]=[1-e,e];if(Math.abs(n)<.9995){let c=Math.acos(Math.abs(n));[i,a]=[Math.sin((1-e)*c)/Math.sin(c),Math.sin(e*c)/Math.sin(c)]}let u=o.map((c,m)=>i*c+r*a*(t[m]??0)),h=Math.hypot(...u)||1;return u.map(c=>c/h)}s(J,"slerp");function q(o,t,e){let[n,r]=[t,e()];function i(){let a=e();n=Math.min(n+o*Math.max(a-r,0),t),r=a}return s(i,"fill"),{take(a){return i(),n<a?!1:(n-=a,!0)},secondsTo(a){return i(),Math.max(Math.min(a,t)-n,0)/o}}}s(q,"createBucket");var N=.618034,[k,I]=[.75,.6];function g(o){return new b().setHSL(o*N%1,k,I)}s(g,"colorOf");function nt(o){return`#${g(o).getHexString()}`}s(nt,"cssOf");function ut(o,t,e,n,r){let i=new M({...O,vertexShader:e,fragmentShader:E,defines:n,uniforms:{...t,...r,cut:{value:A}}}),a=new x(o,i);return a.frustumCulled=!1,a.matrixAutoUpdate=!1,a}s(ut,"createMesh");function mt({material:o},t,e){(o.uniforms[t]?.value).set(...e)}s(mt,"setPoint");function pt(o,t){let{r:e,g:n,b:r}=g(t);o.set(e,n,r,1)}s(pt,"paint");var[H,D,C]=[40,1e-5,1e-7];function l(o,{user:t,inner:e,radius:n,strength:r}){let i=f(o,t),a=Math.hypot(o[0],o[2]);if(r===1&&a<=e)return i;let u=r*(n>e?Math.min(Math.max((n-a)/(n-e),0),1):0),[h,c]=[Math.hypot(...i),Math.hypot(...o)],[m,p]=[u/Math.max(h,1e-30),(1-u)/Math.max(c,1e-30)],v=[m*i[0]+p*o[0],m*i[1]+p*o[1],m*i[2]+p*o[2]],w=(u*h+(1-u)*c)/(Math.hypot(...v)||1);return[w*v[0],w*v[1],w*v[2]]}s(l,"shownAt");function vt(o,t){let{user:e,inner:n,radius:r,strength:i}=t,a=[o[0]+e[0],o[1]+e[1],o[2]+e[2]];if(i===1&&Math.hypot(a[0],a[2])<=n)return a;if(Math.hypot(o[0],o[2])>=r)return o;let u=[a,o].sort((h,c)=>T(l(h,t),o)-T(l(c,t),o));for(let h of u){let c=P(h,o,t);if(c)return c}return null}s(vt,"pointShownAt");function P(o,t,e){let n=C*Math.max(Math.hypot(...t),1),r=o,i=f(t,l(r,e));for(let a=0;a<H&&Math.hypot(...i)>n;a++){let u=L(G(r,e),i);if(!u)return null;for(let h=1;h>.001;h/=2){let c=[r[0]+h*u[0],r[1]+h*u[1],r[2]+h*u[2]],m=f(t,l(c,e));if(!(Math.hypot(...m)>=Math.hypot(...i)&&h>.002)){[r,i]=[c,m];break}}}return Math.hypot(...i)<=n?r:null}s(P,"sought");function G(o,t){let e=D*Math.max(Math.hypot(...o),1),n=s(r=>{let i=s(c=>o.map((m,p)=>p===r?m+c:m),"moved"),[a,u,h]=f(l(i(e),t),l(i(-e),t));return[a/(2*e),u/(2*e),h/(2*e)]},"along");return[n(0),n(1),n(2)]}s(G,"slopes");function L([o,t,e],n){let r=y(o,t,e);return Math.abs(r)>1e-9?[y(n,t,e)/r,y(o,n,e)/r,y(o,t,n)/r]:null}s(L,"solved");function y(o,t,e){return o[0]*(t[1]*e[2]-t[2]*e[1])-t[0]*(o[1]*e[2]-o[2]*e[1])+e[0]*(o[1]*t[2]-o[2]*t[1])}s(y,"determinant");function T(o,t){return Math.hypot(...f(o,t))}s(T,"size");var F=`
mat3 facing(vec3 at) {
  vec3 toward = -normalize(at);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`,U=`
${V}
${R}
${F}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`,bt=`
${U}
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
  vec3 at = displayed(v_point);
  float away = length(at);
  if (is_spot) {
    mat3 axes = facing(at);
    // From the centre, too, whose ranges the map holds.
    v_point *= BEFORE;
    v_shown = BEFORE * at;
    v_shown += (axes[0] * position.y + axes[1] * position.z) * max(SPOT.x, max(SPOT.y * pixel, SPOT.z) * away);
  } else {
    vec3 side = cross(displayed(mix(begin, end, share + ONWARDS)) - at, at);
    side = dot(side, side) > 0.0 ? normalize(side) : vec3(0.0, 1.0, 0.0);
    v_shown = at + side * position.y * max(RIBBON.x, RIBBON.y * pixel * away);
  }
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`,xt=`
${U}
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
  vec3 at = displayed(v_point);
  mat3 axes = facing(at);
  v_shown = at + (axes[0] * position.x * ratio + axes[1] * position.y) * max(HEIGHT.x, HEIGHT.y * length(at));
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;export{$ as a,d as b,S as c,_ as d,q as e,g as f,nt as g,ut as h,mt as i,pt as j,B as k,Y as l,K as m,J as n,U as o,bt as p,xt as q,l as r,vt as s};
