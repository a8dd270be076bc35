import{$ as G,B as I,H as D,K as H,T as L,_ as P,a as h,aa as C,ba as F,da as z,ea as $,h as m,p as O,q as _,s as B,u as U,v as y,x,z as N}from"./shared.js";var w=class extends Error{static{h(this,"FrameError")}},j=class{constructor(t){this.bytes=t;this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}bytes;static{h(this,"Reader")}at=0;view;get isAtEnd(){return this.at===this.bytes.length}u8(){return this.view.getUint8(this.step(1))}u16(){return this.view.getUint16(this.step(2),!0)}i16(){return this.view.getInt16(this.step(2),!0)}u32(){return this.view.getUint32(this.step(4),!0)}u64(){return this.view.getBigUint64(this.step(8),!0)}f32(){return this.view.getFloat32(this.step(4),!0)}take(t){let e=this.step(t);return this.bytes.subarray(e,e+t)}rest(t){let e=this.bytes.length-this.at;if(e>t)throw new w("a payload is too long");return this.take(e)}end(t="a frame is too long"){if(!this.isAtEnd)throw new w(t)}step(t){let e=this.at;if(e+t>this.bytes.length)throw new w("a frame is too short");return this.at=e+t,e}},X=class{static{h(this,"Writer")}bytes=[];view=new DataView(new ArrayBuffer(8));get length(){return this.bytes.length}u8(t){this.bytes.push(t&255)}u16(t){this.view.setUint16(0,t,!0),this.add(2)}i16(t){this.view.setInt16(0,t,!0),this.add(2)}u32(t){this.view.setUint32(0,t,!0),this.add(4)}u64(t){this.view.setBigUint64(0,t,!0),this.add(8)}f32(t){this.view.setFloat32(0,t,!0),this.add(4)}put(t){this.bytes.push(...t)}done(){return Uint8Array.from(this.bytes)}add(t){for(let e=0;e<t;e++)this.bytes.push(this.view.getUint8(e))}};function rt(o,t){let[e,n,r,i]=[Math.sin(o/2),Math.cos(o/2),Math.sin(t/2),Math.cos(t/2)];return[n*r,e*i,-e*r,n*i]}h(rt,"rotationOf");function Et([o,t,e]){return rt(Math.atan2(-o,-e),Math.atan2(t,Math.hypot(o,e)))}h(Et,"rotationAlong");function k([o,t,e,n],[r,i,c]){let[u,a,s]=[2*(t*c-e*i),2*(e*r-o*c),2*(o*i-t*r)];return[r+n*u+t*s-e*a,i+n*a+e*u-o*s,c+n*s+o*a-t*u]}h(k,"rotated");function Rt(o,t,e){let n=o.reduce((s,l,p)=>s+l*(t[p]??0),0),r=n<0?-1:1,[i,c]=[1-e,e];if(Math.abs(n)<.9995){let s=Math.acos(Math.abs(n));[i,c]=[Math.sin((1-e)*s)/Math.sin(s),Math.sin(e*s)/Math.sin(s)]}let u=o.map((s,l)=>i*s+r*c*(t[l]??0)),a=Math.hypot(...u)||1;return u.map(s=>s/a)}h(Rt,"slerp");var[it,at,st]=[40,1e-5,1e-7];function g(o,{user:t,inner:e,radius:n,strength:r}){let i=m(o,t),c=Math.hypot(o[0],o[2]);if(r===1&&c<=e)return i;let u=r*(n>e?Math.min(Math.max((n-c)/(n-e),0),1):0),[a,s]=[Math.hypot(...i),Math.hypot(...o)],[l,p]=[u/Math.max(a,1e-30),(1-u)/Math.max(s,1e-30)],v=[l*i[0]+p*o[0],l*i[1]+p*o[1],l*i[2]+p*o[2]],f=(u*a+(1-u)*s)/(Math.hypot(...v)||1);return[f*v[0],f*v[1],f*v[2]]}h(g,"shownAt");function Ot(o,t){let{user:e,inner:n,radius:r,strength:i}=t,c=[o[0]+e[0],o[1]+e[1],o[2]+e[2]];if(i===1&&Math.hypot(c[0],c[2])<=n)return c;if(Math.hypot(o[0],o[2])>=r)return o;let u=[c,o].sort((a,s)=>W(g(a,t),o)-W(g(s,t),o));for(let a of u){let s=ct(a,o,t);if(s)return s}return null}h(Ot,"pointShownAt");function ct(o,t,e){let n=st*Math.max(Math.hypot(...t),1),r=o,i=m(t,g(r,e));for(let c=0;c<it&&Math.hypot(...i)>n;c++){let u=ut(ht(r,e),i);if(!u)return null;for(let a=1;a>.001;a/=2){let s=[r[0]+a*u[0],r[1]+a*u[1],r[2]+a*u[2]],l=m(t,g(s,e));if(!(Math.hypot(...l)>=Math.hypot(...i)&&a>.002)){[r,i]=[s,l];break}}}return Math.hypot(...i)<=n?r:null}h(ct,"sought");function ht(o,t){let e=at*Math.max(Math.hypot(...o),1),n=h(r=>{let i=h(s=>o.map((l,p)=>p===r?l+s:l),"moved"),[c,u,a]=m(g(i(e),t),g(i(-e),t));return[c/(2*e),u/(2*e),a/(2*e)]},"along");return[n(0),n(1),n(2)]}h(ht,"slopes");function ut([o,t,e],n){let r=M(o,t,e);return Math.abs(r)>1e-9?[M(n,t,e)/r,M(o,n,e)/r,M(o,t,n)/r]:null}h(ut,"solved");function M(o,t,e){return o[0]*(t[1]*e[2]-t[2]*e[1])-t[0]*(o[1]*e[2]-o[2]*e[1])+e[0]*(o[1]*t[2]-o[2]*t[1])}h(M,"determinant");function W(o,t){return Math.hypot(...m(o,t))}h(W,"size");var lt=.618034,[ft,pt]=[.75,.6];function R(o){return new I().setHSL(o*lt%1,ft,pt)}h(R,"colorOf");function Nt(o){return`#${R(o).getHexString()}`}h(Nt,"cssOf");var[b,mt,dt]=[64,40,22],[Y,vt]=[24,640];function Q(o,t){let e=document.createElement("canvas"),n=e.getContext("2d"),r=[...o],i=r.length>Y?`${r.slice(0,Y-1).join("")}\u2026`:o,c=`600 ${mt}px system-ui, sans-serif`;n&&(n.font=c);let u=Math.min(Math.ceil(n?.measureText(i).width??0),vt);e.width=u+2*dt,e.height=b,n&&(n.beginPath(),n.roundRect(0,0,e.width,b,b/2),n.fillStyle=`#${t.getHexString()}`,n.fill(),Object.assign(n,{font:c,textAlign:"center",textBaseline:"middle",fillStyle:"#0b0e12"}),n.fillText(i,e.width/2,b/2+2,u));let a=new H(e);return a.colorSpace=B,a.minFilter=_,a.magFilter=O,{texture:a,ratio:e.width/b}}h(Q,"createLabel");var yt=`
mat3 facing(vec3 at) {
  vec3 toward = -normalize(at);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`,J=`
${P}
${G}
${yt}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`,K=`
${J}
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
`,Z=`
${J}
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
`;var gt=.2,wt=new x(.03,.035,.045,1);function Qt(o,t,e,n){let r=R(o),i=new x(r.r,r.g,r.b,1),c=Q(t,r),u=h((f,d)=>{let V={base_color:{value:d},placement:{value:new N}};return S(f,n,C,{SMOOTH:""},V)},"solid"),a={head:u(e.head,i),visor:u(e.visor,wt),left:u(e.hand,i),right:u(e.hand,i)},s=S(e.pointer,n,K,{UNLIT:""},{base_color:{value:i},begin:{value:new y},end:{value:new y}}),l=S(e.name,n,Z,{TEXTURED:"",CUTOUT:"",UNLIT:""},{base_color:{value:new x(1,1,1,1)},image:{value:c.texture},cutoff:{value:.5},begin:{value:new y},ratio:{value:c.ratio}}),p=null,v=[];return{get meshes(){return v},show(f,d){p=f,v=[...d?[a.head,a.visor,l]:[],...d&&f.left?[a.left]:[],...d&&f.right?[a.right]:[],...f.pointer?[s]:[]]},place(f){if(!p)return;let{head:d,left:V,right:q}=p,[tt,et,ot]=m(d.position,f);for(let[nt,A]of[["head",d],["visor",d],["left",V],["right",q]])A&&xt(a[nt],A,f);T(l,"begin",[tt,et+gt,ot]);let E=bt(p);E&&(T(s,"begin",m(E.begin,f)),T(s,"end",m(E.end,f)))},dispose(){c.texture.dispose();for(let{material:f}of[...Object.values(a),s,l])f.dispose()}}}h(Qt,"createAvatar");function bt({head:o,left:t,right:e,pointer:n}){let r=n&&{head:o,left:t,right:e}[n.begin];if(!r)return null;let[i,c,u]=r.position,[a,s,l]=k(r.rotation,[0,0,-n.length]);return{begin:r.position,end:[i+a,c+s,u+l]}}h(bt,"rayOf");function S(o,t,e,n,r){let i=new L({...$,vertexShader:e,fragmentShader:F,defines:n,uniforms:{...t,...r,cut:{value:z}}}),c=new D(o,i);return c.frustumCulled=!1,c.matrixAutoUpdate=!1,c}h(S,"drawn");function xt({material:o},{position:t,rotation:e},n){let r=o.uniforms.placement?.value,i=new y(...m(t,n));r.compose(i,new U(...e).normalize(),new y(1,1,1))}h(xt,"compose");function T({material:o},t,e){(o.uniforms[t]?.value).set(...e)}h(T,"set");export{w as a,j as b,X as c,g as d,Ot as e,Nt as f,rt as g,Et as h,k as i,Rt as j,J as k,Qt as l,S as m};
