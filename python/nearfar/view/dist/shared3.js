import{k as O}from"./shared4.js";import{A as R,G as N,I as G,J as _,M as I,S as F,T as H,V as U,X as k,Y as D,a as s,da as C,ea as L,ga as W,i as B,ia as X,j as S,ja as $,l as b,m as d}from"./shared.js";var Kt={now:s(()=>performance.now()/1e3,"now"),later(t,e){let n=setTimeout(e,1e3*t);return()=>clearTimeout(n)}};function Yt(t,e,n){let[o,r]=[e,n()];function i(){let a=n();o=Math.min(o+t*Math.max(a-r,0),e),r=a}return s(i,"fill"),{take(a){return i(),o<a?!1:(o-=a,!0)},secondsTo(a){return i(),Math.max(Math.min(a,e)-o,0)/t}}}s(Yt,"createBucket");var m=class extends Error{static{s(this,"FrameError")}},j=class{constructor(e){this.bytes=e;this.view=new DataView(e.buffer,e.byteOffset,e.byteLength)}bytes;static{s(this,"Reader")}offset=0;view;get isAtEnd(){return this.offset===this.bytes.length}u8(){return this.view.getUint8(this.advance(1))}u16(){return this.view.getUint16(this.advance(2),!0)}i16(){return this.view.getInt16(this.advance(2),!0)}u32(){return this.view.getUint32(this.advance(4),!0)}u64(){return this.view.getBigUint64(this.advance(8),!0)}f32(){return this.view.getFloat32(this.advance(4),!0)}take(e){let n=this.advance(e);return this.bytes.subarray(n,n+e)}takeRest(e){let n=this.bytes.length-this.offset;if(n>e)throw new m("a payload is too long");return this.take(n)}expectEnd(e="a frame is too long"){if(!this.isAtEnd)throw new m(e)}advance(e){let n=this.offset;if(n+e>this.bytes.length)throw new m("a frame is too short");return this.offset=n+e,n}},z=class{static{s(this,"Writer")}bytes=[];view=new DataView(new ArrayBuffer(8));get length(){return this.bytes.length}u8(e){this.bytes.push(e&255)}u16(e){this.view.setUint16(0,e,!0),this.flush(2)}i16(e){this.view.setInt16(0,e,!0),this.flush(2)}u32(e){this.view.setUint32(0,e,!0),this.flush(4)}u64(e){this.view.setBigUint64(0,e,!0),this.flush(8)}f32(e){this.view.setFloat32(0,e,!0),this.flush(4)}put(e){this.bytes.push(...e)}toBytes(){return Uint8Array.from(this.bytes)}flush(e){for(let n=0;n<e;n++)this.bytes.push(this.view.getUint8(n))}};function Zt(t,e){try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(t)}catch{throw new m(e)}}s(Zt,"textOf");var Y=["head","left","right"],v=1e6,J=32767,[ft,dt]=[Math.fround(.81),Math.fround(1.21)],y={acknowledged:1,stops:2,left:4,right:8},[Q,pt]=[4,63];function ne(t){let[e,n,o]=[t.u32(),t.u64(),t.u8()];if((o&~pt)!==0)throw new m("a pose has unknown flags");let r=V(t),i=o&y.left?V(t):null,a=o&y.right?V(t):null,u=Y[(o>>Q)-1],l={head:r,left:i,right:a};if(u&&!l[u])throw new m("a pointer begins at a missing hand");let c=u?{begin:u,length:yt(t)}:null;t.expectEnd("a pose is too long");let[h,f]=[(o&y.acknowledged)!==0,(o&y.stops)!==0];return{sequence:e,clock:n,isAcknowledged:h,stops:f,...l,pointer:c}}s(ne,"readPose");function oe(t,e){let{left:n,right:o,pointer:r}=e,i=[e.isAcknowledged?y.acknowledged:0,e.stops?y.stops:0,n?y.left:0,o?y.right:0,r?1+Y.indexOf(r.begin)<<Q:0];t.u32(e.sequence),t.u64(e.clock),t.u8(i.reduce((a,u)=>a|u));for(let a of[e.head,n,o])a&&gt(t,a);r&&t.f32(r.length)}s(oe,"writePose");function mt(t){return t.every(e=>Math.abs(e)<=v)}s(mt,"isWithin");function V(t){let e=[t.f32(),t.f32(),t.f32()],n=[t.i16(),t.i16(),t.i16(),t.i16()];if(!mt(e))throw new m("a position is out of range");let o=n.map(i=>Math.fround(i/J)),r=o.reduce((i,a)=>Math.fround(i+Math.fround(a*a)),0);if(!(r>=ft&&r<=dt))throw new m("a rotation is not a unit quaternion");return{position:e,rotation:o}}s(V,"readPlaced");function gt(t,{position:e,rotation:n}){for(let o of e)t.f32(o);for(let o of n)t.i16(Math.round(J*o))}s(gt,"writePlaced");function yt(t){let e=t.f32();if(!(e>=0&&e<=v))throw new m("a pointer's length is out of range");return e}s(yt,"readLength");var bt=.9995;function x(t,e){let[n,o,r,i]=[Math.sin(t/2),Math.cos(t/2),Math.sin(e/2),Math.cos(e/2)];return[o*r,n*i,-n*r,o*i]}s(x,"rotationOf");function E([t,e,n]){return x(Math.atan2(-t,-n),Math.atan2(e,Math.hypot(t,n)))}s(E,"rotationAlong");function Z([t,e,n,o],[r,i,a]){let[u,l,c]=[2*(e*a-n*i),2*(n*r-t*a),2*(t*i-e*r)];return[r+o*u+e*c-n*l,i+o*l+n*u-t*c,a+o*c+t*l-e*u]}s(Z,"rotate");function wt(t,e,n){let o=t.reduce((c,h,f)=>c+h*(e[f]??0),0),r=o<0?-1:1,[i,a]=[1-n,n];if(Math.abs(o)<bt){let c=Math.acos(Math.abs(o));[i,a]=[Math.sin((1-n)*c)/Math.sin(c),Math.sin(n*c)/Math.sin(c)]}let u=t.map((c,h)=>i*c+r*a*(e[h]??0)),l=Math.hypot(...u)||1;return u.map(c=>c/l)}s(wt,"slerp");function re(t,e,n){let o=n<.5?t:e,r=s(i=>{let[a,u]=[t[i],e[i]];return a&&u?K(a,u,Math.min(n,1)):o[i]},"hand");return{head:K(t.head,e.head,n),left:r("left"),right:r("right"),pointer:vt(t.pointer,e.pointer,Math.min(n,1))}}s(re,"between");function K(t,e,n){return{position:t.position.map((r,i)=>r+n*((e.position[i]??0)-r)),rotation:wt(t.rotation,e.rotation,n)}}s(K,"placedBetween");function vt(t,e,n){return t?.begin!==e?.begin||!t||!e?n<.5?t:e:{begin:e.begin,length:t.length+n*(e.length-t.length)}}s(vt,"pointerBetween");var[xt,Mt,Rt]=[40,1e-5,1e-7];function w(t,{user:e,inner:n,radius:o,strength:r}){let i=d(t,e),a=Math.hypot(t[0],t[2]);if(r===1&&a<=n)return i;let u=r*(o>n?Math.min(Math.max((o-a)/(o-n),0),1):0),[l,c]=[Math.hypot(...i),Math.hypot(...t)],[h,f]=[u/Math.max(l,1e-30),(1-u)/Math.max(c,1e-30)],p=[h*i[0]+f*t[0],h*i[1]+f*t[1],h*i[2]+f*t[2]],g=(u*l+(1-u)*c)/(Math.hypot(...p)||1);return[g*p[0],g*p[1],g*p[2]]}s(w,"shownAt");function tt(t,e){let{user:n,inner:o,radius:r,strength:i}=e,a=[t[0]+n[0],t[1]+n[1],t[2]+n[2]];if(i===1&&Math.hypot(a[0],a[2])<=o)return a;if(Math.hypot(t[0],t[2])>=r)return t;let u=[a,t].sort((l,c)=>q(w(l,e),t)-q(w(c,e),t));for(let l of u){let c=Vt(l,t,e);if(c)return c}return null}s(tt,"pointShownAt");function Vt(t,e,n){let o=Rt*Math.max(Math.hypot(...e),1),r=t,i=d(e,w(r,n));for(let a=0;a<xt&&Math.hypot(...i)>o;a++){let u=Pt(Et(r,n),i);if(!u)return null;for(let l=1;l>.001;l/=2){let c=[r[0]+l*u[0],r[1]+l*u[1],r[2]+l*u[2]],h=d(e,w(c,n));if(!(Math.hypot(...h)>=Math.hypot(...i)&&l>.002)){[r,i]=[c,h];break}}}return Math.hypot(...i)<=o?r:null}s(Vt,"solveFrom");function Et(t,e){let n=Mt*Math.max(Math.hypot(...t),1),o=s(r=>{let i=s(c=>t.map((h,f)=>f===r?h+c:h),"moved"),[a,u,l]=d(w(i(n),e),w(i(-n),e));return[a/(2*n),u/(2*n),l/(2*n)]},"along");return[o(0),o(1),o(2)]}s(Et,"jacobian");function Pt([t,e,n],o){let r=M(t,e,n);return Math.abs(r)>1e-9?[M(o,e,n)/r,M(t,o,n)/r,M(t,e,o)/r]:null}s(Pt,"solve");function M(t,e,n){return t[0]*(e[1]*n[2]-e[2]*n[1])-e[0]*(t[1]*n[2]-t[2]*n[1])+n[0]*(t[1]*e[2]-t[2]*e[1])}s(M,"determinant");function q(t,e){return Math.hypot(...d(t,e))}s(q,"size");var et=1/36;function pe(t,e,n,o,r){let[i,a]=[ot(et),ot(et)];function u(l,c){let{point:h}=n;return h?i.at(c,()=>r()?.targetAt(l,h)??_t(t,e,l,h)):(i.forget(),null)}return s(u,"targetOf"),(l,c)=>{let h=o();return n.isAlways=r()?.isPointing??!1,!n.isAlways&&!h?.some(({isPointing:f})=>f)&&a.forget(),h?Ot(l,h,n.isAlways,({origin:f,direction:p})=>a.at(c,()=>t.along(f,p)??rt)):St(l,u(l,c))}}s(pe,"createPointing");var[At,Tt,Bt]=[.22,.28,.4];function St(t,e){let n={position:t.position,rotation:x(t.yaw,t.pitch)};if(!e)return{head:n,left:null,right:null,pointer:null};let o=b(t.position,S(t.yaw),At),r=b(b(o,B({yaw:t.yaw,pitch:0}),Bt),[0,-1,0],Tt),i=d(e,r),a={position:r,rotation:E(i)};return{head:n,left:null,right:a,pointer:{begin:"right",length:Math.min(Math.hypot(...i),v)}}}s(St,"atScreen");function Ot(t,e,n,o){let r=s(u=>{let l=e.find(c=>c.side===u);return l?{position:l.origin,rotation:E(l.direction)}:null},"placed"),i=n?e.find(({side:u})=>u==="right")??e[0]:void 0,a=e.find(u=>u.isPointing)??i;return{head:{position:t.position,rotation:x(t.yaw,t.pitch)},left:r("left"),right:r("right"),pointer:a?{begin:a.side,length:Math.min(o(a),v)}:null}}s(Ot,"inHeadset");var rt=100,Nt=2;function Gt({facts:t},e,n){let{radius:o,strength:r}=t.shown?.grown??{radius:0,strength:0},i=t.entry?.center??n.position;return{center:i,morph:{user:d(n.position,i),inner:e*o,radius:o,strength:r}}}s(Gt,"morphOf");function _t(t,e,n,[o,r]){let{center:i,morph:a}=Gt(t,e,n),u=t.pointAt(o,r);if(u&&!t.isMorphedAt(o))return u;if(u){let g=tt(d(u,n.position),a);return g?b(i,g,1):u}let{camera:l,renderer:c,shared:h}=t,f=O(n,[o,r],l),p=Ft(c,h,f)??Math.max(rt,Nt*a.radius);return b(i,f,p)}s(_t,"targetAt");var nt=65535;function It([t,e,n],o){let[r,i,a]=[Math.abs(t),Math.abs(e),Math.abs(n)],u=Math.max(r,i,a),[l,c,h]=r===u?t>0?[0,-n,-e]:[1,n,-e]:i===u?e>0?[2,t,n]:[3,t,-n]:n>0?[4,t,-e]:[5,-t,-e],f=s(p=>Math.min(Math.floor((p/u+1)*.5*o),o-1),"place");return{face:l,x:f(c),y:f(h)}}s(It,"texelOf");function Ft(t,{codes:e,coding:n},o){let{x:r,y:i,z:a,w:u}=n.value,{__webglTexture:l}=t.properties.get(e.value);if(u===0||!l)return null;let c=t.getContext(),{face:h,x:f,y:p}=It(o,a),g=c.createFramebuffer(),A=new Uint32Array(4);t.state.bindFramebuffer(c.FRAMEBUFFER,g),c.framebufferTexture2D(c.FRAMEBUFFER,c.COLOR_ATTACHMENT0,c.TEXTURE_CUBE_MAP_POSITIVE_X+h,l,0),c.readPixels(f,p,1,1,c.RGBA_INTEGER,c.UNSIGNED_INT,A),t.state.bindFramebuffer(c.FRAMEBUFFER,null),c.deleteFramebuffer(g);let[T=nt]=A;return T===nt?null:r*Math.exp(T*i)}s(Ft,"rangeIn");function ot(t){let[e,n]=[null,0];return{at(o,r){return(!e||o>=n)&&(e={value:r()},n=o+t),e.value},forget(){e=null}}}s(ot,"createThrottled");var Ht=`
mat3 facing(vec3 at) {
  vec3 toward = -normalize(at);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`,it=`
${C}
${L}
${Ht}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`,at=`
${it}
// Share of the pointer's length, 2 for the spot; offsets to the side and up, in half widths.
in vec3 position;
uniform vec3 begin;
uniform vec3 end;
// Tangent of the angle that a pixel covers.
uniform float pixel;
// Half widths: the least, metres, in pixels, so that no gaps are seen, and of the spot as the tangent of an angle.
const vec2 RIBBON = vec2(0.003, 0.75);
const vec3 SPOT = vec3(0.02, 2.5, 0.004);
// Share of its distance at which the spot is drawn, in front of the surface that it lies on.
const float BEFORE = 0.985;
// Step along the pointer, as a share of its length, that gives the ribbon's direction.
const float ONWARDS = 0.004;

void main() {
  bool is_spot = position.x > 1.5;
  float share = min(position.x, 1.0);
  v_point = mix(begin, end, share);
  vec3 at = displayed(v_point);
  float away = length(at);
  if (is_spot) {
    mat3 axes = facing(at);
    // Also relative to the centre, because the map stores ranges from there.
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
`,be=`
${it}
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
`;function Ut(t,e,n,o,r){let i=new D({...$,vertexShader:n,fragmentShader:W,defines:o,uniforms:{...e,...r,cut:{value:X}}}),a=new I(t,i);return a.frustumCulled=!1,a.matrixAutoUpdate=!1,a}s(Ut,"createMesh");function st({material:t},e,n){(t.uniforms[e]?.value).set(...n)}s(st,"setPoint");function Pe(t,e){let{r:n,g:o,b:r}=ht(e);t.set(n,o,r,1)}s(Pe,"paint");var kt=.618034,[Dt,Ct]=[.75,.6];function ht(t){return new N().setHSL(t*kt%1,Dt,Ct)}s(ht,"colorOf");function Ae(t){return`#${ht(t).getHexString()}`}s(Ae,"cssOf");var Lt=160,P=20,[ct,Wt,ut]=[.085,.13,.105],lt=.06;function Te(){return{head:new k(1,24,16).scale(ct,Wt,ut).translate(0,0,lt),visor:new F(2*ct,.07,.07).translate(0,0,lt-ut+.02),hand:new H(.025,.1,4,12).rotateX(Math.PI/2).translate(0,0,.05),pointer:Xt(),name:new U(1,1).translate(0,.5,0)}}s(Te,"createShapes");function Xt(){let{places:t,corners:e}=$t(Lt,-1),n=t.length/3;t.push(2,0,0);for(let o=0;o<P;o++){let r=2*Math.PI*o/P;t.push(2,Math.cos(r),Math.sin(r)),e.push(n,n+1+o,n+1+(o+1)%P)}return jt({places:t,corners:e})}s(Xt,"pointer");function $t(t,e){let[n,o]=[[],[]];for(let r=0;r<=t;r++){n.push(r/t,e,0,r/t,1,0);let i=2*r;r<t&&o.push(i,i+1,i+2,i+2,i+1,i+3)}return{places:n,corners:o}}s($t,"ribbon");function jt({places:t,corners:e}){let n=new _;return n.setAttribute("position",new G(new Float32Array(t),3)),n.setIndex(e),n}s(jt,"geometryOf");function Be(t,e,n){let o=Ut(t.pointer,e,at,{UNLIT:""},{base_color:{value:n},begin:{value:new R},end:{value:new R}});return{mesh:o,place(r,i){let a=zt(r);a&&(st(o,"begin",d(a.begin,i)),st(o,"end",d(a.end,i)))}}}s(Be,"createRay");function zt({head:t,left:e,right:n,pointer:o}){let r=o&&{head:t,left:e,right:n}[o.begin];if(!r)return null;let[i,a,u]=r.position,[l,c,h]=Z(r.rotation,[0,0,-o.length]);return{begin:r.position,end:[i+l,a+c,u+h]}}s(zt,"endsOf");export{Kt as a,Yt as b,m as c,j as d,z as e,Zt as f,ne as g,oe as h,mt as i,Z as j,re as k,it as l,be as m,Ut as n,st as o,Pe as p,ht as q,Ae as r,Te as s,$t as t,jt as u,Be as v,w,pe as x,Gt as y};
