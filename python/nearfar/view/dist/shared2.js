import{$ as R,B as b,H as x,T as M,_ as V,a,ba as E,da as A,ea as S,h as p}from"./shared.js";var v=class extends Error{static{a(this,"FrameError")}},O=class{constructor(t){this.bytes=t;this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}bytes;static{a(this,"Reader")}at=0;view;get isAtEnd(){return this.at===this.bytes.length}u8(){return this.view.getUint8(this.step(1))}u16(){return this.view.getUint16(this.step(2),!0)}i16(){return this.view.getInt16(this.step(2),!0)}u32(){return this.view.getUint32(this.step(4),!0)}u64(){return this.view.getBigUint64(this.step(8),!0)}f32(){return this.view.getFloat32(this.step(4),!0)}take(t){let e=this.step(t);return this.bytes.subarray(e,e+t)}rest(t){let e=this.bytes.length-this.at;if(e>t)throw new v("a payload is too long");return this.take(e)}end(t="a frame is too long"){if(!this.isAtEnd)throw new v(t)}step(t){let e=this.at;if(e+t>this.bytes.length)throw new v("a frame is too short");return this.at=e+t,e}},_=class{static{a(this,"Writer")}bytes=[];view=new DataView(new ArrayBuffer(8));get length(){return this.bytes.length}u8(t){this.bytes.push(t&255)}u16(t){this.view.setUint16(0,t,!0),this.add(2)}i16(t){this.view.setInt16(0,t,!0),this.add(2)}u32(t){this.view.setUint32(0,t,!0),this.add(4)}u64(t){this.view.setBigUint64(0,t,!0),this.add(8)}f32(t){this.view.setFloat32(0,t,!0),this.add(4)}put(t){this.bytes.push(...t)}done(){return Uint8Array.from(this.bytes)}add(t){for(let e=0;e<t;e++)this.bytes.push(this.view.getUint8(e))}};function N(o,t){let[e,n,r,i]=[Math.sin(o/2),Math.cos(o/2),Math.sin(t/2),Math.cos(t/2)];return[n*r,e*i,-e*r,n*i]}a(N,"rotationOf");function W([o,t,e]){return N(Math.atan2(-o,-e),Math.atan2(t,Math.hypot(o,e)))}a(W,"rotationAlong");function j([o,t,e,n],[r,i,s]){let[u,c,h]=[2*(t*s-e*i),2*(e*r-o*s),2*(o*i-t*r)];return[r+n*u+t*h-e*c,i+n*c+e*u-o*h,s+n*h+o*c-t*u]}a(j,"rotated");function X(o,t,e){let n=o.reduce((h,f,m)=>h+f*(t[m]??0),0),r=n<0?-1:1,[i,s]=[1-e,e];if(Math.abs(n)<.9995){let h=Math.acos(Math.abs(n));[i,s]=[Math.sin((1-e)*h)/Math.sin(h),Math.sin(e*h)/Math.sin(h)]}let u=o.map((h,f)=>i*h+r*s*(t[f]??0)),c=Math.hypot(...u)||1;return u.map(h=>h/c)}a(X,"slerp");function K(o,t,e){let[n,r]=[t,e()];function i(){let s=e();n=Math.min(n+o*Math.max(s-r,0),t),r=s}return a(i,"fill"),{take(s){return i(),n<s?!1:(n-=s,!0)},secondsTo(s){return i(),Math.max(Math.min(s,t)-n,0)/o}}}a(K,"createBucket");var T=.618034,[I,H]=[.75,.6];function g(o){return new b().setHSL(o*T%1,I,H)}a(g,"colorOf");function tt(o){return`#${g(o).getHexString()}`}a(tt,"cssOf");function at(o,t,e,n,r){let i=new M({...S,vertexShader:e,fragmentShader:E,defines:n,uniforms:{...t,...r,cut:{value:A}}}),s=new x(o,i);return s.frustumCulled=!1,s.matrixAutoUpdate=!1,s}a(at,"drawn");function ht({material:o},t,e){(o.uniforms[t]?.value).set(...e)}a(ht,"setPoint");function ct(o,t){let{r:e,g:n,b:r}=g(t);o.set(e,n,r,1)}a(ct,"paint");var[k,D,P]=[40,1e-5,1e-7];function l(o,{user:t,inner:e,radius:n,strength:r}){let i=p(o,t),s=Math.hypot(o[0],o[2]);if(r===1&&s<=e)return i;let u=r*(n>e?Math.min(Math.max((n-s)/(n-e),0),1):0),[c,h]=[Math.hypot(...i),Math.hypot(...o)],[f,m]=[u/Math.max(c,1e-30),(1-u)/Math.max(h,1e-30)],d=[f*i[0]+m*o[0],f*i[1]+m*o[1],f*i[2]+m*o[2]],w=(u*c+(1-u)*h)/(Math.hypot(...d)||1);return[w*d[0],w*d[1],w*d[2]]}a(l,"shownAt");function pt(o,t){let{user:e,inner:n,radius:r,strength:i}=t,s=[o[0]+e[0],o[1]+e[1],o[2]+e[2]];if(i===1&&Math.hypot(s[0],s[2])<=n)return s;if(Math.hypot(o[0],o[2])>=r)return o;let u=[s,o].sort((c,h)=>U(l(c,t),o)-U(l(h,t),o));for(let c of u){let h=G(c,o,t);if(h)return h}return null}a(pt,"pointShownAt");function G(o,t,e){let n=P*Math.max(Math.hypot(...t),1),r=o,i=p(t,l(r,e));for(let s=0;s<k&&Math.hypot(...i)>n;s++){let u=L(F(r,e),i);if(!u)return null;for(let c=1;c>.001;c/=2){let h=[r[0]+c*u[0],r[1]+c*u[1],r[2]+c*u[2]],f=p(t,l(h,e));if(!(Math.hypot(...f)>=Math.hypot(...i)&&c>.002)){[r,i]=[h,f];break}}}return Math.hypot(...i)<=n?r:null}a(G,"sought");function F(o,t){let e=D*Math.max(Math.hypot(...o),1),n=a(r=>{let i=a(h=>o.map((f,m)=>m===r?f+h:f),"moved"),[s,u,c]=p(l(i(e),t),l(i(-e),t));return[s/(2*e),u/(2*e),c/(2*e)]},"along");return[n(0),n(1),n(2)]}a(F,"slopes");function L([o,t,e],n){let r=y(o,t,e);return Math.abs(r)>1e-9?[y(n,t,e)/r,y(o,n,e)/r,y(o,t,n)/r]:null}a(L,"solved");function y(o,t,e){return o[0]*(t[1]*e[2]-t[2]*e[1])-t[0]*(o[1]*e[2]-o[2]*e[1])+e[0]*(o[1]*t[2]-o[2]*t[1])}a(y,"determinant");function U(o,t){return Math.hypot(...p(o,t))}a(U,"size");var C=`
mat3 facing(vec3 at) {
  vec3 toward = -normalize(at);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`,B=`
${V}
${R}
${C}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`,yt=`
${B}
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
${B}
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
`;export{v as a,O as b,_ as c,K as d,g as e,tt as f,at as g,ht as h,ct as i,N as j,W as k,j as l,X as m,B as n,yt as o,wt as p,l as q,pt as r};
