import{A as x,G as R,I as B,J as E,M as P,S,T as A,V as O,X as T,Y as N,a as s,da as G,ea as I,ga as _,ia as k,ja as U,m as p}from"./shared.js";var Rt={now:s(()=>performance.now()/1e3,"now"),later(e,t){let n=setTimeout(t,1e3*e);return()=>clearTimeout(n)}};function Bt(e,t,n){let[r,o]=[t,n()];function i(){let a=n();r=Math.min(r+e*Math.max(a-o,0),t),o=a}return s(i,"fill"),{take(a){return i(),r<a?!1:(r-=a,!0)},secondsTo(a){return i(),Math.max(Math.min(a,t)-r,0)/e}}}s(Bt,"createBucket");var f=class extends Error{static{s(this,"FrameError")}},H=class{constructor(t){this.bytes=t;this.view=new DataView(t.buffer,t.byteOffset,t.byteLength)}bytes;static{s(this,"Reader")}at=0;view;get isAtEnd(){return this.at===this.bytes.length}u8(){return this.view.getUint8(this.step(1))}u16(){return this.view.getUint16(this.step(2),!0)}i16(){return this.view.getInt16(this.step(2),!0)}u32(){return this.view.getUint32(this.step(4),!0)}u64(){return this.view.getBigUint64(this.step(8),!0)}f32(){return this.view.getFloat32(this.step(4),!0)}take(t){let n=this.step(t);return this.bytes.subarray(n,n+t)}rest(t){let n=this.bytes.length-this.at;if(n>t)throw new f("a payload is too long");return this.take(n)}end(t="a frame is too long"){if(!this.isAtEnd)throw new f(t)}step(t){let n=this.at;if(n+t>this.bytes.length)throw new f("a frame is too short");return this.at=n+t,n}},C=class{static{s(this,"Writer")}bytes=[];view=new DataView(new ArrayBuffer(8));get length(){return this.bytes.length}u8(t){this.bytes.push(t&255)}u16(t){this.view.setUint16(0,t,!0),this.add(2)}i16(t){this.view.setInt16(0,t,!0),this.add(2)}u32(t){this.view.setUint32(0,t,!0),this.add(4)}u64(t){this.view.setBigUint64(0,t,!0),this.add(8)}f32(t){this.view.setFloat32(0,t,!0),this.add(4)}put(t){this.bytes.push(...t)}done(){return Uint8Array.from(this.bytes)}add(t){for(let n=0;n<t;n++)this.bytes.push(this.view.getUint8(n))}};var L=["head","left","right"],F=1e6,W=32767,[tt,et]=[Math.fround(.81),Math.fround(1.21)],m={acknowledged:1,stops:2,left:4,right:8},[z,nt]=[4,63];function Tt(e){let[t,n,r]=[e.u32(),e.u64(),e.u8()];if((r&~nt)!==0)throw new f("a pose has flags without a meaning");let o=M(e),i=r&m.left?M(e):null,a=r&m.right?M(e):null,c=L[(r>>z)-1],h={head:o,left:i,right:a};if(c&&!h[c])throw new f("a pointer begins at no hand");let u=c?{begin:c,length:it(e)}:null;e.end("a pose is too long");let[l,d]=[(r&m.acknowledged)!==0,(r&m.stops)!==0];return{sequence:t,clock:n,isAcknowledged:l,stops:d,...h,pointer:u}}s(Tt,"readPose");function Nt(e,t){let{left:n,right:r,pointer:o}=t,i=[t.isAcknowledged?m.acknowledged:0,t.stops?m.stops:0,n?m.left:0,r?m.right:0,o?1+L.indexOf(o.begin)<<z:0];e.u32(t.sequence),e.u64(t.clock),e.u8(i.reduce((a,c)=>a|c));for(let a of[t.head,n,r])a&&rt(e,a);o&&e.f32(o.length)}s(Nt,"writePose");function ot(e){return e.every(t=>Math.abs(t)<=F)}s(ot,"isWithin");function M(e){let t=[e.f32(),e.f32(),e.f32()],n=[e.i16(),e.i16(),e.i16(),e.i16()];if(!ot(t))throw new f("a position is none");let r=n.map(i=>Math.fround(i/W)),o=r.reduce((i,a)=>Math.fround(i+Math.fround(a*a)),0);if(!(o>=tt&&o<=et))throw new f("a rotation is no unit quaternion");return{position:t,rotation:r}}s(M,"readPlaced");function rt(e,{position:t,rotation:n}){for(let r of t)e.f32(r);for(let r of n)e.i16(Math.round(W*r))}s(rt,"writePlaced");function it(e){let t=e.f32();if(!(t>=0&&t<=F))throw new f("a pointer's length is none");return t}s(it,"readLength");var at=.9995;function st(e,t){let[n,r,o,i]=[Math.sin(e/2),Math.cos(e/2),Math.sin(t/2),Math.cos(t/2)];return[r*o,n*i,-n*o,r*i]}s(st,"rotationOf");function Gt([e,t,n]){return st(Math.atan2(-e,-n),Math.atan2(t,Math.hypot(e,n)))}s(Gt,"rotationAlong");function $([e,t,n,r],[o,i,a]){let[c,h,u]=[2*(t*a-n*i),2*(n*o-e*a),2*(e*i-t*o)];return[o+r*c+t*u-n*h,i+r*h+n*c-e*u,a+r*u+e*h-t*c]}s($,"rotated");function ct(e,t,n){let r=e.reduce((u,l,d)=>u+l*(t[d]??0),0),o=r<0?-1:1,[i,a]=[1-n,n];if(Math.abs(r)<at){let u=Math.acos(Math.abs(r));[i,a]=[Math.sin((1-n)*u)/Math.sin(u),Math.sin(n*u)/Math.sin(u)]}let c=e.map((u,l)=>i*u+o*a*(t[l]??0)),h=Math.hypot(...c)||1;return c.map(u=>u/h)}s(ct,"slerp");function It(e,t,n){let r=n<.5?e:t,o=s(i=>{let[a,c]=[e[i],t[i]];return a&&c?D(a,c,Math.min(n,1)):r[i]},"hand");return{head:D(e.head,t.head,n),left:o("left"),right:o("right"),pointer:ut(e.pointer,t.pointer,Math.min(n,1))}}s(It,"between");function D(e,t,n){return{position:e.position.map((o,i)=>o+n*((t.position[i]??0)-o)),rotation:ct(e.rotation,t.rotation,n)}}s(D,"placedBetween");function ut(e,t,n){return e?.begin!==t?.begin||!e||!t?n<.5?e:t:{begin:t.begin,length:e.length+n*(t.length-e.length)}}s(ut,"pointerBetween");var ht=`
mat3 facing(vec3 at) {
  vec3 toward = -normalize(at);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`,X=`
${G}
${I}
${ht}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`,j=`
${X}
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
`,Ht=`
${X}
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
`;function lt(e,t,n,r,o){let i=new N({...U,vertexShader:n,fragmentShader:_,defines:r,uniforms:{...t,...o,cut:{value:k}}}),a=new P(e,i);return a.frustumCulled=!1,a.matrixAutoUpdate=!1,a}s(lt,"createMesh");function K({material:e},t,n){(e.uniforms[t]?.value).set(...n)}s(K,"setPoint");function Xt(e,t){let{r:n,g:r,b:o}=Z(t);e.set(n,r,o,1)}s(Xt,"paint");var ft=.618034,[dt,pt]=[.75,.6];function Z(e){return new R().setHSL(e*ft%1,dt,pt)}s(Z,"colorOf");function jt(e){return`#${Z(e).getHexString()}`}s(jt,"cssOf");var w=160,V=20,[Y,mt,J]=[.085,.13,.105],Q=.06;function Kt(){return{head:new T(1,24,16).scale(Y,mt,J).translate(0,0,Q),visor:new S(2*Y,.07,.07).translate(0,0,Q-J+.02),hand:new A(.025,.1,4,12).rotateX(Math.PI/2).translate(0,0,.05),pointer:gt(),name:new O(1,1).translate(0,.5,0)}}s(Kt,"createShapes");function gt(){let[e,t]=[[],[]];for(let o=0;o<=w;o++){e.push(o/w,-1,0,o/w,1,0);let i=2*o;o<w&&t.push(i,i+1,i+2,i+2,i+1,i+3)}let n=e.length/3;e.push(2,0,0);for(let o=0;o<V;o++){let i=2*Math.PI*o/V;e.push(2,Math.cos(i),Math.sin(i)),t.push(n,n+1+o,n+1+(o+1)%V)}let r=new E;return r.setAttribute("position",new B(new Float32Array(e),3)),r.setIndex(t),r}s(gt,"pointer");function Yt(e,t,n){let r=lt(e.pointer,t,j,{UNLIT:""},{base_color:{value:n},begin:{value:new x},end:{value:new x}});return{mesh:r,place(o,i){let a=yt(o);a&&(K(r,"begin",p(a.begin,i)),K(r,"end",p(a.end,i)))}}}s(Yt,"createRay");function yt({head:e,left:t,right:n,pointer:r}){let o=r&&{head:e,left:t,right:n}[r.begin];if(!o)return null;let[i,a,c]=o.position,[h,u,l]=$(o.rotation,[0,0,-r.length]);return{begin:o.position,end:[i+h,a+u,c+l]}}s(yt,"endsOf");var[wt,vt,bt]=[40,1e-5,1e-7];function g(e,{user:t,inner:n,radius:r,strength:o}){let i=p(e,t),a=Math.hypot(e[0],e[2]);if(o===1&&a<=n)return i;let c=o*(r>n?Math.min(Math.max((r-a)/(r-n),0),1):0),[h,u]=[Math.hypot(...i),Math.hypot(...e)],[l,d]=[c/Math.max(h,1e-30),(1-c)/Math.max(u,1e-30)],y=[l*i[0]+d*e[0],l*i[1]+d*e[1],l*i[2]+d*e[2]],b=(c*h+(1-c)*u)/(Math.hypot(...y)||1);return[b*y[0],b*y[1],b*y[2]]}s(g,"shownAt");function qt(e,t){let{user:n,inner:r,radius:o,strength:i}=t,a=[e[0]+n[0],e[1]+n[1],e[2]+n[2]];if(i===1&&Math.hypot(a[0],a[2])<=r)return a;if(Math.hypot(e[0],e[2])>=o)return e;let c=[a,e].sort((h,u)=>q(g(h,t),e)-q(g(u,t),e));for(let h of c){let u=xt(h,e,t);if(u)return u}return null}s(qt,"pointShownAt");function xt(e,t,n){let r=bt*Math.max(Math.hypot(...t),1),o=e,i=p(t,g(o,n));for(let a=0;a<wt&&Math.hypot(...i)>r;a++){let c=Vt(Mt(o,n),i);if(!c)return null;for(let h=1;h>.001;h/=2){let u=[o[0]+h*c[0],o[1]+h*c[1],o[2]+h*c[2]],l=p(t,g(u,n));if(!(Math.hypot(...l)>=Math.hypot(...i)&&h>.002)){[o,i]=[u,l];break}}}return Math.hypot(...i)<=r?o:null}s(xt,"sought");function Mt(e,t){let n=vt*Math.max(Math.hypot(...e),1),r=s(o=>{let i=s(u=>e.map((l,d)=>d===o?l+u:l),"moved"),[a,c,h]=p(g(i(n),t),g(i(-n),t));return[a/(2*n),c/(2*n),h/(2*n)]},"along");return[r(0),r(1),r(2)]}s(Mt,"slopes");function Vt([e,t,n],r){let o=v(e,t,n);return Math.abs(o)>1e-9?[v(r,t,n)/o,v(e,r,n)/o,v(e,t,r)/o]:null}s(Vt,"solved");function v(e,t,n){return e[0]*(t[1]*n[2]-t[2]*n[1])-t[0]*(e[1]*n[2]-e[2]*n[1])+n[0]*(e[1]*t[2]-e[2]*t[1])}s(v,"determinant");function q(e,t){return Math.hypot(...p(e,t))}s(q,"size");export{Rt as a,Bt as b,f as c,H as d,C as e,F as f,Tt as g,Nt as h,ot as i,st as j,Gt as k,$ as l,It as m,X as n,Ht as o,lt as p,K as q,Xt as r,Z as s,jt as t,Kt as u,Yt as v,g as w,qt as x};
