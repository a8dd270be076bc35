import{k as K}from"./shared4.js";import{$ as P,F as A,G as x,H as W,M as $,O as Q,Q as Y,R as Z,U as z,Y as J,Z as q,a,ba as ee,ca as te,g as D,i as L,j as X,ja as ne,ka as re,l as y,m,ma as oe,u as j,wa as ae,xa as ie}from"./shared.js";var nt={now:a(()=>performance.now()/1e3,"now"),later(e,t){let n=setTimeout(t,1e3*e);return()=>clearTimeout(n)}};function rt(e,t,n){let[r,o]=[t,n()];function i(){let s=n();r=Math.min(r+e*Math.max(s-o,0),t),o=s}return a(i,"fill"),{take(s){return i(),r<s?!1:(r-=s,!0)},secondsTo(s){return i(),Math.max(Math.min(s,t)-r,0)/e}}}a(rt,"createBucket");var h=class extends Error{static{a(this,"FrameError")}},O=class{constructor(t){this.bytes=t}bytes;static{a(this,"Reader")}offset=0;get remaining(){return this.bytes.length-this.offset}take(t){if(t>this.remaining)throw new h("a frame is too short");return this.offset+=t,this.bytes.subarray(this.offset-t,this.offset)}expectEnd(t="a frame is too long"){if(this.remaining>0)throw new h(t)}},C=class{static{a(this,"Writer")}parts=[];put(t){this.parts.push(t)}toBytes(){return j(this.parts)}};function st(e,t){let n=new C;return e.write(n,t),n.toBytes()}a(st,"encode");function ct(e,t,n){let r=new O(t),o=e.read(r);return r.expectEnd(n),o}a(ct,"decode");var g=M(1,"Uint8"),ut=M(2,"Uint16"),S=M(2,"Int16"),N=M(4,"Uint32"),I=M(8,"BigUint64"),T=M(4,"Float32");function M(e,t){let n=a(r=>new DataView(r.buffer,r.byteOffset,e),"accessors");return{read:a(r=>n(r.take(e))[`get${t}`]?.(0,!0),"read"),write(r,o){let i=new Uint8Array(e);n(i)[`set${t}`]?.(0,o,!0),r.put(i)}}}a(M,"numberCodec");function lt(e,t="a payload is too long"){let n=a(r=>{if(r>e)throw new h(t)},"check");return{read(r){return n(r.remaining),r.take(r.remaining).slice()},write(r,o){n(o.length),r.put(o)}}}a(lt,"payload");function dt(e){return{read:a(t=>t.take(g.read(t)).slice(),"read"),write(t,n){if(n.length>255)throw new h(e);g.write(t,n.length),t.put(n)}}}a(dt,"shortBytes");function ft(e,t){return{read(n){let r=e.read(n);try{return new TextDecoder("utf-8",{fatal:!0,ignoreBOM:!0}).decode(r)}catch{throw new h(t)}},write:a((n,r)=>e.write(n,new TextEncoder().encode(r)),"write")}}a(ft,"utf8");function B(e,t){return{read(n){let r=e.read(n);return t(r),r},write:e.write}}a(B,"withCheck");function pt(e,t){return{read(n){let r=e[g.read(n)];if(r===void 0)throw new h(t);return r},write:a((n,r)=>g.write(n,e.indexOf(r)),"write")}}a(pt,"choiceOf");function se(e){let t=Object.entries(e);return{read:a(n=>Object.fromEntries(t.map(([r,o])=>[r,o.read(n)])),"read"),write(n,r){for(let[o,i]of t)i.write(n,r[o])}}}a(se,"record");function U(...e){return{read:a(t=>e.map(n=>n.read(t)),"read"),write:a((t,n)=>e.forEach((r,o)=>r.write(t,n[o])),"write")}}a(U,"tuple");function ht(e){return{read:a(t=>Array.from({length:g.read(t)},()=>e.read(t)),"read"),write(t,n){g.write(t,n.length);for(let r of n)e.write(t,r)}}}a(ht,"shortList");function mt(e,t,n){return{read(r){if(g.read(r)!==e)throw new h(t);return n.read(r)},write(r,o){g.write(r,e),n.write(r,o)}}}a(mt,"withPrefix");function yt(e,t){return{read(n){let r=g.read(n),o=Object.entries(e).find(([,[c]])=>c===r);if(!o)throw new h(t);let[i,[,s]]=o;return{kind:i,...s.read(n)}},write(n,r){let[o,i]=e[r.kind];g.write(n,o),i.write(n,r)}}}a(yt,"kindsOf");var ce=["head","left","right"],V=1e6,ue=32767,[Re,_e]=[Math.fround(.81),Math.fround(1.21)],w={acknowledged:1,stops:2,left:4,right:8},[le,Pe]=[4,63];function Oe(e){return e.every(t=>Math.abs(t)<=V)}a(Oe,"isInRange");var E={read:a(e=>Math.fround(S.read(e)/ue),"read"),write:a((e,t)=>S.write(e,Math.round(ue*t)),"write")},Ce=se({position:U(T,T,T),rotation:U(E,E,E,E)}),R=B(Ce,({position:e,rotation:t})=>{if(!Oe(e))throw new h("a position is out of range");let n=t.reduce((r,o)=>Math.fround(r+Math.fround(o*o)),0);if(!(n>=Re&&n<=_e))throw new h("a rotation is not a unit quaternion")}),de=B(T,e=>{if(!(e>=0&&e<=V))throw new h("a pointer's length is out of range")}),At={read(e){let[t,n,r]=[N.read(e),I.read(e),g.read(e)];if((r&~Pe)!==0)throw new h("a pose has unknown flags");let o=R.read(e),i=r&w.left?R.read(e):null,s=r&w.right?R.read(e):null,c=ce[(r>>le)-1],l={head:o,left:i,right:s};if(c&&!l[c])throw new h("a pointer begins at a missing hand");let u=c?{begin:c,length:de.read(e)}:null,[d,f]=[(r&w.acknowledged)!==0,(r&w.stops)!==0];return{sequence:t,clock:n,isAcknowledged:d,stops:f,...l,pointer:u}},write(e,t){let{left:n,right:r,pointer:o}=t,i=[t.isAcknowledged?w.acknowledged:0,t.stops?w.stops:0,n?w.left:0,r?w.right:0,o?1+ce.indexOf(o.begin)<<le:0];N.write(e,t.sequence),I.write(e,t.clock),g.write(e,i.reduce((s,c)=>s|c));for(let s of[t.head,n,r])s&&R.write(e,s);o&&de.write(e,o.length)}};function _(e,t){return new A().setFromEuler(new $(t,e,0,"YXZ")).toArray()}a(_,"rotationOf");function k([e,t,n]){return _(Math.atan2(-e,-n),Math.atan2(t,Math.hypot(e,n)))}a(k,"rotationAlong");function pe(e,t){return new x(...t).applyQuaternion(new A(...e)).toArray()}a(pe,"rotate");function Se(e,t,n){return new A(...e).slerp(new A(...t),n).normalize().toArray()}a(Se,"slerp");function Tt(e,t,n){let r=n<.5?e:t,o=a(u=>{let[d,f]=[e[u],t[u]];return d&&f?fe(d,f,Math.min(n,1)):r[u]},"hand"),[i,s]=[e.pointer,t.pointer],c=i!==null&&s!==null&&i.begin===s.begin,l=(i?.length??0)+Math.min(n,1)*((s?.length??0)-(i?.length??0));return{head:fe(e.head,t.head,n),left:o("left"),right:o("right"),pointer:c?{begin:s.begin,length:l}:r.pointer}}a(Tt,"interpolateBodies");function fe(e,t,n){return{position:y(e.position,m(t.position,e.position),n),rotation:Se(e.rotation,t.rotation,n)}}a(fe,"interpolatePlacements");var[Ne,he]=[40,.001],[Ie,Be]=[1e-5,1e-7];function v(e,{user:t,inner:n,radius:r,strength:o}){let i=m(e,t),s=Math.hypot(e[0],e[2]);if(o===1&&s<=n)return i;let c=o*(r>n?D((r-s)/(r-n),0,1):0),[l,u]=[Math.hypot(...i),Math.hypot(...e)],[d,f]=[c/Math.max(l,1e-30),(1-c)/Math.max(u,1e-30)],p=[d*i[0]+f*e[0],d*i[1]+f*e[1],d*i[2]+f*e[2]],b=(c*l+(1-c)*u)/(Math.hypot(...p)||1);return[b*p[0],b*p[1],b*p[2]]}a(v,"applyMorph");function ye(e,t){let{user:n,inner:r,radius:o,strength:i}=t,s=y(e,n,1);if(i===1&&Math.hypot(s[0],s[2])<=r)return s;if(Math.hypot(e[0],e[2])>=o)return e;let c=a(d=>Math.hypot(...m(v(d,t),e)),"error"),[l,u]=c(s)<=c(e)?[s,e]:[e,s];return me(l,e,t)??me(u,e,t)}a(ye,"invertMorph");function me(e,t,n){let r=Be*Math.max(Math.hypot(...t),1),o=e,i=m(t,v(o,n));for(let s=0;s<Ne&&Math.hypot(...i)>r;s++){let c=Ue(o,n);if(!(Math.abs(c.determinant())>1e-9))return null;let l=new x(...i).applyMatrix3(c.invert()).toArray();for(let u=1;u>he;u/=2){let d=y(o,l,u),f=m(t,v(d,n)),p=u<=2*he;if(!(Math.hypot(...f)>=Math.hypot(...i)&&!p)){[o,i]=[d,f];break}}}return Math.hypot(...i)<=r?o:null}a(me,"solveFrom");function Ue(e,t){let n=Ie*Math.max(Math.hypot(...e),1),r=[[1,0,0],[0,1,0],[0,0,1]].map(o=>{let[i,s]=[v(y(e,o,n),t),v(y(e,o,-n),t)];return m(i,s).map(c=>c/(2*n))});return new W().fromArray(r.flat())}a(Ue,"jacobian");var ge=1/36;function It(e,t,n,r,o){let[i,s]=[we(ge),we(ge)];function c(l,u){let{point:d}=n;if(d){let f=a(()=>o()?.targetAt(l,d)??Ke(e,t,l,d),"findTarget");return i.get(u,f)}return i.forget(),null}return a(c,"targetOf"),(l,u)=>{let d=r();return n.isAlwaysPointing=o()?.isPointing??!1,!n.isAlwaysPointing&&!d?.some(({isPointing:f})=>f)&&s.forget(),d?De(l,d,n.isAlwaysPointing,({origin:f,direction:p})=>s.get(u,()=>e.along(f,p)??xe)):Fe(l,c(l,u))}}a(It,"createPointing");var[ke,He,Ge]=[.22,.28,.4];function Fe(e,t){let n={position:e.position,rotation:_(e.yaw,e.pitch)};if(!t)return{head:n,left:null,right:null,pointer:null};let r=y(e.position,X(e.yaw),ke),o=y(y(r,L({yaw:e.yaw,pitch:0}),Ge),[0,-1,0],He),i=m(t,o),s={position:o,rotation:k(i)};return{head:n,left:null,right:s,pointer:{begin:"right",length:Math.min(Math.hypot(...i),V)}}}a(Fe,"bodyAtScreen");function De(e,t,n,r){let o=a(l=>t.find(u=>u.side===l),"handOf"),i=a(l=>l?{position:l.origin,rotation:k(l.direction)}:null,"placementOf"),s=n?o("right")??t[0]:void 0,c=t.find(({isPointing:l})=>l)??s;return{head:{position:e.position,rotation:_(e.yaw,e.pitch)},left:i(o("left")),right:i(o("right")),pointer:c?{begin:c.side,length:Math.min(r(c),V)}:null}}a(De,"bodyInHeadset");var xe=100,Le=2;function Xe({facts:e},t,n){let{radius:r,strength:o}=e.shown?.grown??{radius:0,strength:0},i=e.entry?.center??n.position,s={user:m(n.position,i),inner:t*r,radius:r,strength:o};return{center:i,morph:s}}a(Xe,"morphOf");function Ke(e,t,n,[r,o]){let{center:i,morph:s}=Xe(e,t,n),c=e.pointAt(r,o);if(c){let b=e.isMorphedAt(r)?ye(m(c,n.position),s):null;return b?y(i,b,1):c}let{camera:l,renderer:u,shared:d}=e,f=K(n,[r,o],l),p=We(u,d,f)??Math.max(xe,Le*s.radius);return y(i,f,p)}a(Ke,"targetAt");var be=65535;function je([e,t,n],r){let[o,i,s]=[Math.abs(e),Math.abs(t),Math.abs(n)],c=Math.max(o,i,s),[l,u,d]=o===c?e>0?[0,-n,-t]:[1,n,-t]:i===c?t>0?[2,e,n]:[3,e,-n]:n>0?[4,e,-t]:[5,-e,-t],f=a(p=>Math.min(Math.floor((p/c+1)*.5*r),r-1),"place");return{face:l,x:f(u),y:f(d)}}a(je,"texelOf");function We(e,{codes:t,coding:n},r){let{x:o,y:i,z:s,w:c}=n.value,{__webglTexture:l}=e.properties.get(t.value);if(c===0||!l)return null;let u=e.getContext(),{face:d,x:f,y:p}=je(r,s),b=u.createFramebuffer(),G=new Uint32Array(4);e.state.bindFramebuffer(u.FRAMEBUFFER,b),u.framebufferTexture2D(u.FRAMEBUFFER,u.COLOR_ATTACHMENT0,u.TEXTURE_CUBE_MAP_POSITIVE_X+d,l,0),u.readPixels(f,p,1,1,u.RGBA_INTEGER,u.UNSIGNED_INT,G),e.state.bindFramebuffer(u.FRAMEBUFFER,null),u.deleteFramebuffer(b);let[F=be]=G;return F===be?null:o*Math.exp(F*i)}a(We,"readRange");function we(e){let t=null;return{get(n,r){return(!t||n>=t.end)&&(t={value:r(),end:n+e}),t.value},forget(){t=null}}}a(we,"createThrottled");var $e=`
mat3 facing(vec3 from_eye) {
  vec3 toward = -normalize(from_eye);
  vec3 right = cross(vec3(0.0, 1.0, 0.0), toward);
  right = dot(right, right) > 1e-6 ? normalize(right) : vec3(1.0, 0.0, 0.0);
  return mat3(right, cross(toward, right), toward);
}
`,Me=`
${ne}
${re}
${$e}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
out vec3 v_point;
out vec3 v_shown;
`,Ae=`
${Me}
// Share of the pointer's length, 2 for the spot; offsets to the side and up, in half widths.
in vec3 position;
uniform vec3 begin;
uniform vec3 end;
// Tangent of the angle that a pixel covers.
uniform float pixel;
// Least half widths: in metres; in pixels, so that there are no gaps; for the spot also as the tangent of an angle.
const vec2 RIBBON = vec2(0.003, 0.75);
const vec3 SPOT = vec3(0.02, 2.5, 0.004);
// Factor of the spot's distance, so that it is drawn in front of its surface.
const float SPOT_DISTANCE = 0.985;
// Step along the pointer from which the ribbon's direction is computed, as a share of the length.
const float DIRECTION_STEP = 0.004;

void main() {
  bool is_spot = position.x > 1.5;
  float share = min(position.x, 1.0);
  v_point = mix(begin, end, share);
  vec3 from_eye = displayed(v_point);
  float range = length(from_eye);
  if (is_spot) {
    mat3 axes = facing(from_eye);
    // The map's ranges are measured from the centre, so that the point moves relative to the centre, too.
    v_point *= SPOT_DISTANCE;
    v_shown = SPOT_DISTANCE * from_eye;
    v_shown += (axes[0] * position.y + axes[1] * position.z) * max(SPOT.x, max(SPOT.y * pixel, SPOT.z) * range);
  } else {
    vec3 side = cross(displayed(mix(begin, end, share + DIRECTION_STEP)) - from_eye, from_eye);
    side = dot(side, side) > 0.0 ? normalize(side) : vec3(0.0, 1.0, 0.0);
    v_shown = from_eye + side * position.y * max(RIBBON.x, RIBBON.y * pixel * range);
  }
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`,Ht=`
${Me}
in vec3 position;
in vec2 uv;
out vec2 v_uv;
uniform vec3 begin;
// Width divided by height.
uniform float ratio;
// Least height in metres, and as the tangent of an angle.
const vec2 HEIGHT = vec2(0.08, 0.032);

void main() {
  v_point = begin;
  v_uv = uv;
  vec3 from_eye = displayed(v_point);
  mat3 axes = facing(from_eye);
  v_shown = from_eye + (axes[0] * position.x * ratio + axes[1] * position.y) * max(HEIGHT.x, HEIGHT.y * length(from_eye));
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;function Qe(e,t,n,r,o){let i=new te({...ie,vertexShader:n,fragmentShader:oe,defines:r,uniforms:{...t,...o,cut:{value:ae}}}),s=new z(e,i);return s.frustumCulled=!1,s.matrixAutoUpdate=!1,s}a(Qe,"createMesh");function Wt(e,t){let{r:n,g:r,b:o}=Ee(t);e.set(n,r,o,1)}a(Wt,"setUserColor");var Ye=.618034,[Ze,ze]=[.75,.6];function Ee(e){return new Q().setHSL(e*Ye%1,Ze,ze)}a(Ee,"colorOf");function $t(e){return`#${Ee(e).getHexString()}`}a($t,"cssOf");var Je=160,H=20,[Te,qe,Ve]=[.085,.13,.105],ve=.06;function Qt(){return{head:new ee(1,24,16).scale(Te,qe,Ve).translate(0,0,ve),visor:new J(2*Te,.07,.07).translate(0,0,ve-Ve+.02),hand:new q(.025,.1,4,12).rotateX(Math.PI/2).translate(0,0,.05),pointer:et(),name:new P(1,1).translate(0,.5,0)}}a(Qt,"createShapes");function et(){let e=tt(Je,-1),t=[...e.getAttribute("position").array],n=[...e.index?.array??[]],r=t.length/3;t.push(2,0,0);for(let i=0;i<H;i++){let s=2*Math.PI*i/H;t.push(2,Math.cos(s),Math.sin(s)),n.push(r,r+1+i,r+1+(i+1)%H)}let o=new Y(new Float32Array(t),3);return new Z().setAttribute("position",o).setIndex(n)}a(et,"createPointerShape");function tt(e,t){return new P(1,1-t,e,1).scale(1,-1,1).translate(.5,(1+t)/2,0)}a(tt,"createRibbon");function Yt(e,t,n){let[r,o]=[new x,new x],i={base_color:{value:n},begin:{value:r},end:{value:o}};return{mesh:Qe(e.pointer,t,Ae,{UNLIT:""},i),place({head:c,left:l,right:u,pointer:d},f){let p=d&&{head:c,left:l,right:u}[d.begin];p&&(r.set(...m(p.position,f)),o.set(...pe(p.rotation,[0,0,-d.length])).add(r))}}}a(Yt,"createRay");export{nt as a,rt as b,h as c,O as d,st as e,ct as f,g,ut as h,N as i,T as j,lt as k,dt as l,ft as m,B as n,pt as o,se as p,U as q,ht as r,mt as s,yt as t,Oe as u,At as v,pe as w,Tt as x,Me as y,Ht as z,Qe as A,Wt as B,Ee as C,$t as D,Qt as E,tt as F,Yt as G,v as H,It as I,Xe as J};
