var bm=Object.defineProperty;var a=(n,e)=>bm(n,"name",{value:e,configurable:!0});var Ce=class extends Error{constructor(t,i="damaged"){super(t);this.kind=i}kind;static{a(this,"BundleError")}name="BundleError"};function wu({message:n}){return/^(files\/[\w.]+):/.exec(n)?.[1]??null}a(wu,"damagedFile");var wn={right:0,ahead:0,turn:0,look:0,isHasty:!1};function As(...n){let e=a(o=>n.reduce((l,c)=>l+o(c),0),"sum"),[t,i]=Ts(e(o=>o.right),e(o=>o.ahead)),[r,s]=Ts(e(o=>o.turn),e(o=>o.look));return{right:t,ahead:i,turn:r,look:s,isHasty:n.some(o=>o.isHasty)}}a(As,"together");function Ts(n,e){let t=Math.max(Math.hypot(n,e),1);return[n/t,e/t]}a(Ts,"within");function Mi(n,e,t){let i=Math.hypot(n,e);if(!(i>t))return[0,0];let r=Math.min((i-t)/(1-t),1)/i;return[n*r,e*r]}a(Mi,"beyondRest");var Eu=.18,Sm=[4,10];function Tu(n){let e=n.filter(t=>t!==null&&t.connected&&t.mapping==="standard");return e.length===0?wn:As(...e.map(t=>t?Mm(t):wn))}a(Tu,"readPads");function Mm({axes:n,buttons:e}){let[t,i]=Mi(n[0]??0,n[1]??0,Eu),[r,s]=Mi(n[2]??0,n[3]??0,Eu),o=Sm.some(l=>e[l]?.pressed??!1);return{right:t,ahead:0-i,turn:0-r,look:0-s,isHasty:o}}a(Mm,"wishOf");var Au={KeyW:[0,1,0,0],KeyS:[0,-1,0,0],KeyA:[-1,0,0,0],KeyD:[1,0,0,0],ArrowUp:[0,1,0,0],ArrowDown:[0,-1,0,0],ArrowLeft:[0,0,1,0],ArrowRight:[0,0,-1,0],PageUp:[0,0,0,1],PageDown:[0,0,0,-1]};function sl(n){return Object.hasOwn(Au,n)}a(sl,"isMoving");function ol(n){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return!0;let{target:e}=n;return typeof Element<"u"&&e instanceof Element&&e.closest(wm)!==null}a(ol,"isElsewhere");var wm="input, textarea, select, [contenteditable], dialog[open]";function Ru(n){let e=new Set,t=new AbortController,i=a((s,o)=>n.addEventListener(s,o,{signal:t.signal}),"listen"),r=!1;return i("keydown",s=>{let o=s;r=o.shiftKey,!(!sl(o.code)||ol(o))&&(e.add(o.code),o.preventDefault())}),i("keyup",s=>{r=s.shiftKey,e.delete(s.code),s.key==="Meta"&&e.clear()}),i("blur",()=>{e.clear(),r=!1}),{get drive(){let s=[0,0,0,0];for(let d of e)Au[d]?.forEach((f,_)=>s[_]=(s[_]??0)+f);let[o=0,l=0,c=0,u=0]=s,[h,p]=Ts(o,l);return{right:h,ahead:p,turn:Math.sign(c),look:Math.sign(u),isHasty:r}},dispose:a(()=>t.abort(),"dispose")}}a(Ru,"createKeys");function Rs(n,e,t){let i=t&&ll(e,t.open),r=i?Pu(n,e,i):e;for(let s of t?.shown??[]){let o=Math.max(Mt(n,s),s.metres),l=Mt(r,s);l>o&&(r=Is(r,o,l,s))}return r}a(Rs,"confine");function al(n,e,t){let i=t&&ll(e,t.open),r=i?Cu(n,e,Mt(Pu(n,e,i),i),i):1,s=(t?.shown??[]).map(o=>Cu(n,e,o.metres,o));return Math.min(r,...s)}a(al,"allowedShare");function Cs(n,e,t){let i=e&&ll(n,e.open),r=n;for(let s of new Set([...i?[i]:[],...e?.shown??[]])){let o=Mt(r,s);o<=s.metres||(r=Is(r,s.metres+(o-s.metres)*Math.exp(-3*t),o,s))}return r}a(Cs,"settle");function Mt([n,,e],{center:t}){return Math.hypot(n-t[0],e-t[2])}a(Mt,"distance");function Ps(n,e){let t=Mt(n,e);return t<=e.metres?n:Is(n,e.metres,t,e)}a(Ps,"within");function ll(n,e){let t=a(i=>i.metres-Mt(n,i),"room");return e.reduce((i,r)=>i&&t(i)>=t(r)?i:r,null)}a(ll,"roomiest");function Pu(n,e,t){let[i,r]=[Mt(n,t),Mt(e,t)],s=.8*t.metres,o=Math.max(i,s);if(r<=o)return e;let l=t.metres-s,c=o>=t.metres?o:t.metres-(t.metres-o)*Math.exp((o-r)/l);return Is(e,c,r,t)}a(Pu,"slowed");function Cu(n,e,t,i){let[r,s]=[Mt(n,i),Mt(e,i)];return s<=r||s<=t?1:Math.max(t-r,0)/(s-r)}a(Cu,"shareOf");function Is([n,e,t],i,r,{center:s}){let o=i/r;return[s[0]+o*(n-s[0]),e,s[2]+o*(t-s[2])]}a(Is,"atDistance");function En(n,e,t){return Math.min(Math.max(n,e),t)}a(En,"bounded");function Gi(n){return n-2*Math.PI*Math.round(n/(2*Math.PI))}a(Gi,"wrapped");function wi({yaw:n,pitch:e}){return[-Math.sin(n)*Math.cos(e),Math.sin(e),-Math.cos(n)*Math.cos(e)]}a(wi,"ahead");function Vi(n){return[Math.cos(n),0,-Math.sin(n)]}a(Vi,"rightOf");function Ls({yaw:n,pitch:e}){return[Math.sin(n)*Math.sin(e),Math.cos(e),Math.cos(n)*Math.sin(e)]}a(Ls,"upOf");function Yt(n,e,t){return[n[0]+t*e[0],n[1]+t*e[1],n[2]+t*e[2]]}a(Yt,"moved");function Iu(n,e){return n.yaw===e.yaw&&n.pitch===e.pitch&&n.position.every((t,i)=>t===e.position[i])}a(Iu,"isSamePose");var[Lu,Nu,Du]=[.3,2e3,4],[Uu,Em,Ou]=[1.4,1.2,.8];function Fu(n,e){let t=n,i=Du,r=a(()=>Yt(t.position,wi(t),i),"target");function s(u,h){let[p,d,f]=Yt(h,u,-1),_=Math.hypot(p,f);i=En(Math.hypot(_,d),Lu,Nu);let v=_>1e-9?Tm(Math.atan2(-p,-f),t.yaw):t.yaw;t={position:u,yaw:v,pitch:En(Math.atan2(d,_),-1.5,1.5)}}a(s,"put");function o(u,h){if(u===0&&h===0)return;let p=r(),d={yaw:t.yaw+u,pitch:En(t.pitch+h,-1.5,1.5)},f=Yt(p,wi(d),-i),_=Rs(t.position,f,e());_===f?t={...d,position:f}:s(_,p)}a(o,"rotate");function l(u){if(!(u>0)||u===1)return;let h=En(i*u,Lu,Nu),p=Yt(r(),wi(t),-h),d=al(t.position,p,e()),f=Yt(t.position,wi(t),d*(i-h));i+=d*(h-i),t={...t,position:f}}a(l,"zoom");function c(u,h){let p=Yt(Yt([0,0,0],Vi(t.yaw),u*i),Ls(t),h*i),d=al(t.position,Yt(t.position,p,1),e());t={...t,position:Yt(t.position,p,d)}}return a(c,"pan"),{get pose(){return t},update(u,{right:h,ahead:p,turn:d,look:f,isHasty:_}){_?c(Ou*u*h,Ou*u*p):l(Math.exp(-Em*u*p));let v=_?d:d-h;o(Uu*u*v,Uu*u*f),t={...t,position:Cs(t.position,e(),u)}},rotate:o,zoom:l,pan:c,setPose(u){t=u,i=Du}}}a(Fu,"createOrbit");function Tm(n,e){return n+2*Math.PI*Math.round((e-n)/(2*Math.PI))}a(Tm,"nearest");var[Am,Rm,Cm]=[300,400,16];function Bu(n){let e=new Map,t=null,i=a((r,s)=>Math.hypot(r.clientX-s.clientX,r.clientY-s.clientY)<=Cm,"isNear");return{down(r){e.size>0&&(t=null),e.set(r.pointerId,r)},up(r){let s=e.get(r.pointerId),o=e.size===1;if(e.delete(r.pointerId),!(s&&o&&r.timeStamp-s.timeStamp<=Am&&i(s,r))){t=null;return}let c=t!==null&&r.timeStamp-t.timeStamp<=Rm&&i(t,r);t=c?null:r,c&&n(r)}}}a(Bu,"createTaps");var[Ns,ku]=[1.6,Math.PI],cl=1.5,Pm=.0015,Im=[1,16,400],Ds=56,Lm=.12;function zu(n,e){let t=new Map,i=new AbortController,r=wn,s=Bu(u),o=!1,l=a(()=>1/Math.max(n.clientHeight,1),"scale"),c=a(()=>n.ownerDocument.pointerLockElement===n,"isLocked");function u({clientX:b,clientY:w}){let{left:y,top:T,width:L,height:C}=n.getBoundingClientRect();c()?e.go(.5,.5):e.go((b-y)/Math.max(L,1),(w-T)/Math.max(C,1))}a(u,"go");function h(b){if(c())return;o=b.pointerType==="touch";let w=b.pointerType==="mouse",y=b.button===0&&!b.shiftKey;if(e.mode()==="walk"&&w&&!y)return;n.setPointerCapture(b.pointerId),o&&s.down(b);let T=p(b)?"step":y?"turn":"pan";t.set(b.pointerId,{x:b.clientX,y:b.clientY,task:T}),T==="step"&&f({x:b.clientX,y:b.clientY},b)}a(h,"down");function p({pointerType:b,clientX:w}){if(e.mode()!=="walk"||b!=="touch"||[...t.values()].some(({task:L})=>L==="step"))return!1;let{left:y,width:T}=n.getBoundingClientRect();return w-y<T/2}a(p,"isThumb");function d(b){let w=t.get(b.pointerId);if(!w){c()&&e.look(-b.movementX*Ns*l(),-b.movementY*Ns*l());return}if(w.task==="step"){f(w,b);return}let y={...w,x:b.clientX,y:b.clientY},T=[...t].find(([D,{task:N}])=>D!==b.pointerId&&N!=="step")?.[1],[L,C]=[(y.x-w.x)*l(),(y.y-w.y)*l()];t.set(b.pointerId,y),e.mode()==="walk"?e.look(L*Ns,C*Ns):T?_(w,y,T):w.task==="pan"?e.pan(-L*cl,C*cl):e.rotate(-L*ku,-C*ku)}a(d,"move");function f({x:b,y:w},{clientX:y,clientY:T}){let[L,C]=Mi((y-b)/Ds,(T-w)/Ds,Lm);r={...wn,right:L,ahead:0-C},e.thumb({x:b,y:w,right:y-b,down:T-w})}a(f,"step");function _(b,w,y){let[T,L]=[b,w].map(({x:D,y:N})=>Math.hypot(D-y.x,N-y.y));T&&L&&e.zoom(T/L);let C=.5*cl*l();e.pan(-(w.x-b.x)*C,(w.y-b.y)*C)}a(_,"pinch");function v(b){b.pointerType==="touch"&&s.up(b),t.get(b.pointerId)?.task==="step"&&g(),t.delete(b.pointerId)}a(v,"up");function g(){r=wn,e.thumb(null)}a(g,"rest");function m(b){e.mode()==="orbit"&&(b.preventDefault(),e.zoom(Math.exp(Pm*b.deltaY*(Im[b.deltaMode]??1)*(b.ctrlKey?6:1))))}a(m,"wheel");function S(){e.mode()==="walk"&&Promise.resolve(n.requestPointerLock()).catch(()=>{})}a(S,"lock");let{signal:A}=i;n.addEventListener("pointerdown",h,{signal:A}),n.addEventListener("pointermove",d,{signal:A}),n.addEventListener("pointerup",v,{signal:A}),n.addEventListener("pointercancel",v,{signal:A}),n.addEventListener("dblclick",b=>o||u(b),{signal:A}),n.addEventListener("wheel",m,{signal:A,passive:!1}),n.addEventListener("contextmenu",b=>b.preventDefault(),{signal:A});function x(){t.clear(),g(),c()&&n.ownerDocument.exitPointerLock()}return a(x,"release"),{get drive(){return r},lock:S,release:x,dispose(){x(),i.abort()}}}a(zu,"createPointers");var[Nm,Dm]=[1.6,3],Gu=1.4,[Vu,Um]=[.09,.25],Om=1/120;function Us(n,e,t){let{position:i,yaw:r,pitch:s}=n,o=i[1],l=[0,0];function c(h,p){let d=Gu*p.turn*h,f=r+d/2;r+=d,s=En(s+Gu*p.look*h,-1.5,1.5);let _=Nm*(p.isHasty?Dm:1),[v,g]=Hu(l[0],_*p.right,h,t()),[m,S]=Hu(l[1],_*p.ahead,h,t());l=[g,S];let[A,,x]=Vi(f),b=t()?0:(i[1]-o)*Math.exp(-h/Um),w=[i[0]+A*v+x*m,o+b,i[2]+x*v-A*m];i=Cs(Rs(i,w,e()),e(),h)}a(c,"step");function u(h){({position:i,yaw:r,pitch:s}=h),o=i[1]}return a(u,"follow"),{get pose(){return{position:i,yaw:r,pitch:s}},update(h,p){let d=Math.ceil(h/Om);for(let f=0;f<d;f++)c(h/d,p)},look(h,p){r+=h,s=En(s+p,-1.5,1.5)},setPose(h){u(h),l=[0,0]},follow:u,resume(h){({position:i,yaw:r,pitch:s}=h),l=[0,0]}}}a(Us,"createWalk");function Hu(n,e,t,i){if(i)return[e*t,e];let r=Math.exp(-t/Vu);return[e*t+(n-e)*Vu*(1-r),e+(n-e)*r]}a(Hu,"glide");var Fm=.5;function Wu(n,e){let{start:t,onChange:i,onThumb:r,onGo:s,pads:o=Bm,isSudden:l=km()}=e,c="walk",u=null,h=t,p=Us(t,()=>u,l),d=Fu(t,()=>u),f=Ru(e.keys??window),_=zu(n,{mode:a(()=>c,"mode"),look:p.look,rotate:d.rotate,pan:d.pan,zoom:d.zoom,thumb:a(g=>r?.(g),"thumb"),go:a((g,m)=>s?.(g,m),"go")}),v=a(()=>c==="walk"?p.pose:d.pose,"current");return{update(g){let m=As(f.drive,_.drive,Tu(o())),S=g>0?Math.min(g,Fm):0;c==="walk"?p.update(S,m):d.update(S,m);let A=v();return Iu(A,h)||i?.(A),h=A,A},get mode(){return c},setMode(g){if(g===c)return;let m=v();_.release(),c=g,c==="walk"?p.resume(m):d.setPose(m)},setPose(g){p.setPose(g),d.setPose(g)},lookAround:_.lock,setBounds(g){u=g},dispose(){f.dispose(),_.dispose()}}}a(Wu,"createControls");function Bm(){try{return navigator.getGamepads?.()??[]}catch{return[]}}a(Bm,"browserPads");function km(){let n=window.matchMedia("(prefers-reduced-motion: reduce)");return()=>n.matches}a(km,"reducedMotion");var zm=512,Gm=3e7,Vm=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;function fl(n){if(n.length>zm)return null;let e=new URLSearchParams(n.replace(/^#/,"")),[t,i,r,...s]=(e.get("p")??"").split(",").map(ul);if(!hl(t)||!hl(i)||!hl(r)||s.length>0)return null;let[o,l]=[ul(e.get("yaw")??"0"),ul(e.get("pitch")??"0")];return o===null||l===null?null:{position:[t,i,r],yaw:Gi(o),pitch:En(l,-1.5,1.5)}}a(fl,"readLink");function pl({position:n,yaw:e,pitch:t}){return`#p=${n.map(r=>dl(r,3)).join(",")}&yaw=${dl(Gi(e),4)}&pitch=${dl(t,4)}`}a(pl,"writeLink");function ul(n){let e=Vm.test(n)?Number(n):Number.NaN;return Number.isFinite(e)?e:null}a(ul,"numberIn");function hl(n){return n!=null&&Math.abs(n)<=Gm}a(hl,"isPlace");function dl(n,e){return String(Number(n.toFixed(e)))}a(dl,"rounded");var[Xu,Hm]=[1.7,.5],Wm=1,Xm=15;function qu(n,[e,t],i,r){let s=Yt(wi(n),Vi(n.yaw),(2*e-1)*i*r),[o,l,c]=Yt(s,Ls(n),(1-2*t)*i),u=Math.hypot(o,l,c);return[o/u,l/u,c/u]}a(qu,"directionTo");function Yu(n,e,t){let i=n[1]-Xu;if(t&&t[1]<=i+Hm)return[t[0],n[1],t[2]];let r=Math.hypot(e[0],e[2]);if(r===0)return n;let s=t?Math.hypot(t[0]-n[0],t[2]-n[2])-Wm:Xm,o=e[1]<0?Xu*r/-e[1]:Number.POSITIVE_INFINITY,l=Math.max(Math.min(s,o),0);return[n[0]+l*e[0]/r,n[1],n[2]+l*e[2]/r]}a(Yu,"placeFor");function ti(n,e,t){let i=JSON.stringify(t)??"nothing";return new Ce(`manifest.json: ${n}: expected ${e}, got ${i.slice(0,60)}`)}a(ti,"wrong");function ht(n,e){if(typeof e!="object"||e===null||Array.isArray(e))throw ti(n,"an object",e);return e}a(ht,"object");function Pt(n,e,t,i=Number.MAX_VALUE){if(!(typeof e=="number"&&e>=t&&e<=i))throw ti(n,`a number of at least ${t}`,e);return e}a(Pt,"number");function pt(n,e,t,i=Number.MAX_SAFE_INTEGER){let r=Pt(n,e,t,i);if(!Number.isSafeInteger(r))throw ti(n,"a whole number",e);return r}a(pt,"integer");function Tn(n,e){if(typeof e!="string")throw ti(n,"text",e);return e}a(Tn,"text");function wr(n,e,t){let i=t.find(r=>r===e);if(i===void 0)throw ti(n,t.join(" or "),e);return i}a(wr,"choice");function Nt(n,e,t,i){if(!Array.isArray(e)||i!==void 0&&e.length!==i)throw ti(n,i===void 0?"a list":`a list of ${i}`,e);return e.map((r,s)=>t(`${n}[${s}]`,r,s))}a(Nt,"list");function Bn(n,e,t){return e==null?null:t(n,e)}a(Bn,"optional");function $u(n,e){let t=Tn(n,e);if(!/^[0-9a-f]{64}$/.test(t))throw ti(n,"a SHA-256",e);return t}a($u,"hash");function pn(n,e){let t=Tn(n,e);if(!/^files\/[0-9a-f]{16}\.[a-z]+$/.test(t))throw ti(n,"the name of a file of the bundle",e);return t}a(pn,"fileName");function Er({geometry:n,parts:e}){return n===null?[]:[n,...e]}a(Er,"filesOfGeometry");function Os(n){return n?[n.color,n.range].flat().filter(e=>e!==null):[]}a(Os,"filesOfMap");function Tr(n){return[...Er(n),...Os(n.map),...(n.sharper?.maps??[]).flatMap(Os)]}a(Tr,"filesOfRing");function ml({dynamic:n},{rings:e}){let t=n?Er(n):[];return new Set([...t,...e.flatMap(Tr)])}a(ml,"filesOfRegion");function Ju({files:n},e){let t=0;for(let i of e)t+=n[i]?.bytes??0;return t}a(Ju,"bytesOf");var Zu="nearfar.bundle",Ku=1,qm=4096,Ym=16383,[gl,ju,$m]=[6,1e3,1e3],Jm=2**31-1,[Zm,Km]=[65534,600],Hi=1e12;function Ei(n,e){try{return JSON.parse(e)}catch{throw new Ce(`${n}: expected JSON, got something else`)}}a(Ei,"parseJson");function Wi(n,e=xl){let t=ht("manifest",n);if(t.format!==Zu)throw new Ce(`manifest.json: expected the format ${Zu}, got another one`);let i=pt("version",t.version,1);if(i>Ku){let g=`it has version ${i}, this page reads ${Ku}`;throw new Ce(`this bundle was written by a newer nearfar (${g}): update the page`,"newer")}let[r,s,o]=["morph","growth","map"].map(g=>ht(g,t[g])),l=pt("map.face_size",o?.face_size,1,qm),c=pt("map.tile",o?.tile,1,l);if(l%c!==0)throw new Ce(`manifest.json: map.tile: expected a divisor of ${l}, got ${c}`);let u=wr("morph.kind",r?.kind,["blend","cylinder"]),h=wr("unit",t.unit??"object",["object","triangle"]),p=pt("map.across",o?.across,1,Math.floor(Ym/c)),d=yl({face_size:l,tile:c,across:p}),f=ht("files",t.files),_=Nt("regions",t.regions,ht);if(_.length===0||_.length>ju)throw new Ce(`manifest.json: regions: expected 1 to ${ju}, got ${_.length}`);let v={version:i,morph:{kind:u,near_share:Pt("morph.near_share",r?.near_share,0,1-1e-9)},growth:{speed:Pt("growth.speed",s?.speed,1e-9),reach:Pt("growth.reach",s?.reach,1e-9),fade:Pt("growth.fade",s?.fade,0)},triangles:pt("triangles",t.triangles,0),bounds:Nt("bounds",t.bounds,Fs,2),map:{face_size:l,tile:c,across:p},regions:_.map((g,m)=>{let S=`regions[${m}]`;return tg(h,S,eg(S,g,d,m,_.length,e))}),dynamic:Bn("dynamic",t.dynamic,rg),notes:Nt("notes",t.notes,Tn),files:_l(f)};return Qm(v),v}a(Wi,"readManifest");function _l(n){return Object.fromEntries(Object.entries(n).map(([e,t])=>[pn("files",e),jm(e,t)]))}a(_l,"readFiles");function yl({face_size:n,tile:e}){return gl*(n/e)**2}a(yl,"tilesOf");function jm(n,e){let t=ht(n,e);return{bytes:pt(`${n}.bytes`,t.bytes,0,Jm),sha256:$u(`${n}.sha256`,t.sha256)}}a(jm,"described");function Qm({regions:n,dynamic:e,files:t}){let i=[...n.flatMap(({rings:r})=>r.flatMap(Tr)),...n.flatMap(({by_footprint:r})=>r?[...r.portions.flatMap(Er),...Os(r.map)]:[]),...e?Er(e):[]];for(let r of i)if(!Object.hasOwn(t,r))throw new Ce(`manifest.json: files: expected ${r}, which is used, among them`)}a(Qm,"checkListed");function Fs(n,e){return Nt(n,e,(t,i)=>Pt(t,i,-Hi,Hi),3)}a(Fs,"point");function eg(n,e,t,i,r,s){let o=ht(`${n}.range`,e.range),l=Nt(`${n}.rings`,e.rings,(_,v,g)=>s(_,v,g,t)),c=l.map(({radius:_})=>_),u=c[0]===0&&c.every((_,v)=>v===0||_>(c[v-1]??0));if(l.length<2||l.length>$m||!u)throw new Ce(`manifest.json: ${n}.rings: expected radii that ascend from 0`);let h=a((_,v)=>pt(_,v,0,r-1),"other"),p=Nt(`${n}.neighbours`,e.neighbours,h);if(p.includes(i))throw new Ce(`manifest.json: ${n}.neighbours: expected other regions`);let[d,f]=["least","step"].map(_=>Pt(`${n}.range.${_}`,o[_],Number.MIN_VALUE));if(!(Math.abs(Math.log(d))+Zm*f<=Km))throw new Ce(`manifest.json: ${n}.range: expected ranges that are finite`);return{center:Fs(`${n}.center`,e.center),fold_margin:Pt(`${n}.fold_margin`,e.fold_margin,0),neighbours:p,range:{least:d,step:f},rings:l,cut:1/0,by_footprint:Bn(`${n}.by_footprint`,e.by_footprint,ng)}}a(eg,"region");function tg(n,e,t){if(n==="object")return t;if(t.rings.length!==2)throw new Ce(`manifest.json: ${e}.rings: expected two with unit triangle`);return{...t,cut:t.rings[1]?.radius??1/0}}a(tg,"cutBy");function xl(n,e,t,i){let r=ht(n,e);return{...bl(n,r),radius:Pt(`${n}.radius`,r.radius,0,Hi),map:ig(`${n}.map`,r.map,t,i)}}a(xl,"ring");function vl(n,e){let{objects:t,triangles:i}=bl(n,e),r=Pt(`${n}.radius`,ht(n,e).radius,0,Hi);return{objects:t,triangles:i,geometry:null,parts:[],radius:r,map:null}}a(vl,"outlinedRing");function bl(n,e){let t=ht(n,e);return{objects:pt(`${n}.objects`,t.objects,0),triangles:pt(`${n}.triangles`,t.triangles,0),geometry:Bn(`${n}.geometry`,t.geometry,pn),parts:Nt(`${n}.parts`,t.parts,pn)}}a(bl,"group");function ng(n,e){let t=ht(n,e),i=ht(`${n}.map`,t.map),r=a(s=>Nt(`${n}.map.${s}`,i[s],pn,gl),"faces");return{portions:Nt(`${n}.portions`,t.portions,bl),map:{tiles:[],color:r("color"),range:r("range")}}}a(ng,"footprints");function ig(n,e,t,i){let r=ht(n,e),s=a((u,h)=>Array.isArray(h)?Nt(u,h,pn,gl):pn(u,h),"names"),o={tiles:Nt(`${n}.tiles`,r.tiles??[],(u,h)=>pt(u,h,0,i-1)),color:Bn(`${n}.color`,r.color,s),range:Bn(`${n}.range`,r.range,s)},l=a(u=>new Ce(`manifest.json: ${n}: expected ${u}`),"wrong");if(t===0){if(!Array.isArray(o.color))throw l("six pictures for ring 0");return o}if(o.tiles.some((u,h)=>h>0&&u<=(o.tiles[h-1]??0)))throw l("numbers of tiles that ascend");let c=o.tiles.length>0;if(c!==(typeof o.color=="string"))throw l("a picture exactly where tiles change");if(t===1&&!Array.isArray(o.range))throw l("six files of ranges for ring 1");if(t>1&&c!==(typeof o.range=="string"))throw l("ranges exactly where tiles change");return o}a(ig,"mapOf");function rg(n,e){let t=ht(n,e);return{geometry:pn(`${n}.geometry`,t.geometry),parts:Nt(`${n}.parts`,t.parts,pn),triangles:pt(`${n}.triangles`,t.triangles,0),instances:Nt(`${n}.instances`,t.instances,sg)}}a(rg,"moving");function sg(n,e){let t=ht(n,e),i=a((r,s)=>Nt(r,s,(o,l)=>Pt(o,l,-Hi,Hi),4),"row");return{object:Tn(`${n}.object`,t.object),transform:Bn(`${n}.transform`,t.transform,(r,s)=>Nt(r,s,i,4))}}a(sg,"movingEntry");function Qu(n){let e=new Map;function t(i){let r=new AbortController,s=new Set,o={askers:s,stop:r,size:0,result:Promise.resolve().then(()=>n(i,r.signal,c=>{o.size+=c;for(let u of s)u(c)}))};e.set(i,o);let l=a(()=>{e.get(i)===o&&e.delete(i)},"forget");return o.result.then(l,l),o}return a(t,"begin"),async(i,r,s)=>{r.throwIfAborted();let o=e.get(i)??t(i),l=o.askers.size===0,c=a(h=>s(h),"own");o.askers.add(c),o.size>0&&c(o.size);let u=a(()=>{o.askers.delete(c),!(o.askers.size>0)&&(e.get(i)===o&&e.delete(i),o.stop.abort(r.reason))},"leave");return new Promise((h,p)=>{let d=a(()=>{u(),p(r.reason)},"stopped");r.addEventListener("abort",d,{once:!0});let f=a(_=>h(l?_:_.slice(0)),"copied");o.result.then(f,p).finally(()=>r.removeEventListener("abort",d))})}}a(Qu,"createShared");function eh(n){let e=n,t=new Set;function i(r){return new Promise((s,o)=>{let l=a(()=>{t.delete(c),o(r.reason)},"leave"),c=a(()=>{r.removeEventListener("abort",l),s()},"enter");t.add(c),r.addEventListener("abort",l,{once:!0})})}return a(i,"place"),async(r,s)=>{r.throwIfAborted(),e===0?await i(r):e-=1;try{return await s()}finally{let[o]=t;o?(t.delete(o),o()):e+=1}}}a(eh,"createSlots");var th=10,og=new Set([408,425,429]),Xi={fetch:a((n,e,t)=>fetch(n,{signal:e,credentials:"same-origin",cache:t?"reload":"default"}),"fetch"),wait:a((n,e)=>new Promise((t,i)=>{e.throwIfAborted();let r=a(()=>{clearTimeout(s),i(e.reason)},"stop"),s=setTimeout(()=>{e.removeEventListener("abort",r),t()},1e3*n);e.addEventListener("abort",r,{once:!0})}),"wait")};async function Sl(n,e,t,i,r,s){let o=new AbortController,l=AbortSignal.any([i,o.signal]),c=!0;a(async()=>{for(;c;)c=!1,await s.wait(th,l);o.abort(new Error(`the server sends nothing for ${th} s`))},"watch")().catch(()=>{});let h=0;try{let p=await s.fetch(n,l,r);ag(e.name,p);let d=[];for(let f=p.body?.getReader();f;){let{done:_,value:v}=await f.read();if(_)break;if(c=!0,d.push(v),h+=v.length,t(v.length),h>e.most)throw lg(e,"more")}if(e.bytes!==null&&h<e.bytes)throw new Error(`expected ${e.bytes} bytes, got ${h}`);return await new Blob(d).arrayBuffer()}catch(p){throw t(-h),p}finally{o.abort(new Error("over"))}}a(Sl,"transfer");function ag(n,{ok:e,status:t,statusText:i}){if(e)return;let r=`the server answers ${t} ${i}`.trim();throw t>=500||og.has(t)?new Error(r):new Ce(`${n}: ${r}`,"network")}a(ag,"refuse");function lg({name:n,bytes:e,most:t},i){let r=e===null?`at most ${t} bytes`:`${e} bytes, as the manifest lists it`;return new Ce(`${n}: expected ${r}, got ${i}`)}a(lg,"wrongSize");var cg=[.5,1,2,4],ug=6,Ml="manifest.json",wl=64*2**20;async function nh(n,e,t,i=Xi){let r={name:Ml,bytes:null,most:wl},s=await ih(Ml,t,i,o=>Sl(new URL(Ml,n),r,e,t,o,i));return new TextDecoder().decode(s)}a(nh,"readDocument");function Bs(n,e,t,i=Xi){let r=new Set,s=eh(ug),o=Qu((l,c,u)=>{let h=e(l);if(h===void 0)throw new Ce(`${l}: the manifest does not list this file`);let p=a(d=>{t(d),u(d)},"both");return s(c,()=>ih(l,c,i,d=>{let f=r.delete(l)||d;return Sl(new URL(l,n),{name:l,bytes:h,most:h},p,c,f,i)}))});return{fetch:a((l,c,u=()=>{})=>o(l,c,u),"fetch"),distrust:a(l=>r.add(l),"distrust")}}a(Bs,"createFiles");async function ih(n,e,t,i){for(let r=0;;r++){e.throwIfAborted();try{return await i(r>0)}catch(s){if(e.aborted||s instanceof Ce)throw s;let o=cg[r],l=s instanceof Error?s.message:String(s);if(o===void 0)throw new Ce(`${n} does not come: ${l}`,"network");await t.wait(o,e)}}}a(ih,"withTrials");function Ar(n,e){if(n===null)return e;if(!/^\d{1,4}$/.test(n))throw new Ce(`rings: expected the number of a ring, got ${n}`,"address");let t=Number(n)+1;return{...e,regions:e.regions.map(i=>({...i,rings:i.rings.slice(0,t)}))}}a(Ar,"upTo");function ks(n,e){let t=n.regions[e];if(!t)throw new Error(`there is no region ${e}`);return{manifest:n,entry:t,ring(i){let r=t.rings[i];if(!r)throw new Error(`region ${e} has no ring ${i}`);return r}}}a(ks,"thereOf");function rh(){let n=null,[e,t]=[r=>{},r=>{}],i=new Promise((r,s)=>{[e,t]=[r,s]});return i.catch(()=>{}),{promise:i,get now(){return n},done(r){n=r,e(r)},failed:a(r=>t(r),"failed")}}a(rh,"createAwaited");var hg=["waiting","begin","ring","end","whole","failed"],[El,sh]=[0,1],oh={objects:0,triangles:0,geometry:null,parts:[],map:null};async function ah(n,e,t){let{event:i,told:r}=await lh(n,t);if(i==="whole"){let l=Ar(e,Wi(r.manifest));return t.listed(l.files),t.making({stage:"full"}),ks(l,0)}if(i!=="begin")throw zs(i);let s=Ar(e,Wi(r.manifest,vl)),o=fg(s,t);return t.making({stage:"coarse"}),dg(n,o,t).catch(o.fail),o.coming}a(ah,"readPlace");async function dg(n,e,t){for(;;){let{event:i,told:r}=await lh(n,t);if(i==="begin")e.beginFull(Wi(r.manifest,vl));else if(i==="ring")e.add(r);else if(i==="end"){e.end(),t.making({stage:"full"});return}else throw zs(i)}}a(dg,"readOn");async function lh(n,e){for(;;){let{done:t,value:i}=await n.next();if(t)throw new Ce("the server broke off before the place was there","network");let r=ht("parts",i),s=wr("parts.event",r.event,hg);if(s==="failed")throw new Ce(Tn("parts.reason",r.reason),"place");if(s!=="waiting")return{event:s,told:r};e.making({stage:"waiting",before:pt("parts.before",r.before,0)})}}a(lh,"nextLine");function fg(n,e){let[t]=n.regions;if(!t)throw new Error("a manifest has regions");let i={},r=t.rings.length,s=[...t.rings,{...oh,radius:t.rings.at(-1)?.radius??0}],o={...t,rings:s,isCoarse:!0},l={...n,files:i,regions:[o]},c=s.map(()=>rh()),u=[],h=null;function p(f){Object.assign(i,f),e.listed(f)}a(p,"list");function d(f,_){s[f]=_,c[f]?.done(_)}return a(d,"put"),p(n.files),{coming:{manifest:l,entry:o,ring(f){let _=c[f];if(!_)throw new Error(`the place has no ring ${f}`);return _.now??_.promise}},beginFull(f){h=f,p(f.files)},add(f){let _=pt("parts.stage",f.stage,El,sh),v=pt("parts.ring",f.ring,0),g=_===El?n.map:h?.map;if(!g||_===sh&&v!==u.length&&v<r)throw zs("ring");if(v>=r)return;let m=xl(`ring ${v}`,f.entry,v,yl(g));p(_l(ht("parts.files",f.files))),_===El?d(v,m):m.map&&u.push(m.map)},end(){let[f]=h?.regions??[];if(!h||!f||u.length!==r)throw zs("end");let _={layout:h.map,range:f.range,maps:u};d(r,{...oh,radius:s[r]?.radius??0,sharper:_})},fail(f){for(let _ of c)_.failed(f)}}}a(fg,"createPlace");function zs(n){return new Ce(`parts: expected another event, got ${n}`)}a(zs,"unexpected");var pg=[.5,1,2,4],[ch,mg]=[2,60],gg=[429,503],_g=300;async function Gs(n,e,t,i,r){for(let s=0;;){i.throwIfAborted();let o=await r.fetch(n,i,!1).catch(c=>c);if(o instanceof Response&&o.ok)return o;let l;if(o instanceof Response)if(gg.includes(o.status))l=yg(o),t(l);else throw new Ce(await xg(o),e);else{l=pg[s++];let c=o instanceof Error?o.message:String(o);if(l===void 0)throw new Ce(`the server cannot be reached: ${c}`,"network")}await r.wait(l,i)}}a(Gs,"ask");function yg({headers:n}){let e=Number(n.get("retry-after")??ch);return Number.isFinite(e)?Math.min(Math.max(e,1),mg):ch}a(yg,"pauseOf");async function xg(n){return(await n.text()).trim().slice(0,_g).replace(/^\d{3} [^:]*: /,"")||`the server answers ${n.status} ${n.statusText}`.trim()}a(xg,"reasonOf");var[vg,uh,hh]=["nearfar.on_demand","nearfar.scene",1];function dh(n){return typeof n=="object"&&n!==null&&n.format===vg}a(dh,"isSite");function fh(n){let e=ht("manifest",n);return mh(e.version),{title:Tn("title",e.title),grid:Pt("grid",e.grid,.001,1e6),scene:pn("scene",e.scene)}}a(fh,"readSite");async function ph(n,{scene:e},t,i){let r=await Gs(new URL(e,n),"scene",()=>{},t,i),s=ht("scene",Ei("scene",await r.text()));if(s.format!==uh)throw new Ce(`${e}: expected the format ${uh}, got another one`);mh(s.version);let o=Bn("failed",s.failed,Tn);if(o!==null)throw new Ce(o,"scene");let[l,c]=[ht("start",s.start),ht("growth",s.growth)];return{triangles:pt("triangles",s.triangles,0),start:{position:Fs("start.position",l.position),yaw:Pt("start.yaw",l.yaw,-7,7)},faceSize:pt("face_size",s.face_size,1,4096),nearShare:Pt("near_share",s.near_share,0,1-1e-9),fade:Pt("growth.fade",c.fade,0),isStatic:s.is_static===!0}}a(ph,"readScene");function mh(n){let e=pt("version",n,1);if(e>hh){let t=`it has version ${e}, this page reads ${hh}`;throw new Ce(`this server runs a newer nearfar (${t}): reload the page`,"newer")}}a(mh,"checkVersion");var bg=1/8,[Sg,Mg]=[.5,.6],wg=.6;function gh(n){let e=new Map,t=[],i=a(s=>t[s],"of");function r([s,o,l]){let c=[Tl(s,n),Tl(o,bg),Tl(l,n)],u=c.join(),h=e.get(u);return h!==void 0?h:(t.push({center:c,fold_margin:n}),e.set(u,t.length-1),t.length-1)}return a(r,"nearest"),{of:i,nearest:r,ahead({place:s,current:o,ahead:l,limit:c}){if(c.metres-Mt(s,c)>(l===null?Sg:Mg)*c.metres)return null;let h=a(d=>Mt(s,{center:i(d).center,metres:0}),"far");if(l!==null&&l!==o&&h(l)<=wg*h(o))return l;let p=r(s);return p===o?null:p},know(s,o){t[s]=o}}}a(gh,"createGrid");function Tl(n,e){return e*Math.round(n/e)+0}a(Tl,"snapped");async function*_h(n,e,t){let i=e.body?.getReader();if(!i)return;let r=new TextDecoder,s="";for(;;){let{done:o,value:l}=await i.read(),c=(s+r.decode(l,{stream:!o})).split(`
`);s=c.pop()??"";for(let u of c)yield Ei(n,u);if(s.length>t)throw new Ce(`${n}: expected lines of at most ${t} characters`);if(o)break}s!==""&&(yield Ei(n,s))}a(_h,"linesOf");function yh({base:n,site:e,scene:t,last:i,received:r,network:s}){let o=gh(e.grid),l=new Map,c=new Map;return{places:o,faceSize:t.faceSize,nearShare:t.nearShare,marginShare:t.nearShare,fade:t.fade,files:Bs(n,u=>c.get(u)?.bytes,r,s),async open(u,h){let p=a(v=>{h.aborted||l.set(u,v)},"told"),d=`at/${o.of(u).center.join()}/parts`;p({stage:"asked"}),h.addEventListener("abort",()=>l.delete(u),{once:!0});let f=await Gs(new URL(d,n),"place",v=>p({stage:"busy",seconds:v}),h,s),_=await ah(_h("parts",f,wl),i,{listed(v){for(let[g,m]of Object.entries(v))c.set(g,m)},making:p});return o.know(u,_.entry),_},makingOf:a(u=>l.get(u)??null,"makingOf")}}a(yh,"createDemandWorld");var[Eg,Tg,Ag]=[.5,4,.9],xh=.25;function Ti(n,e){return Math.hypot(n[0]-e[0],n[1]-e[1],n[2]-e[2])}a(Ti,"apartOf");function vh(n,e,t){let i=Math.max(Ti(e,n),1e-6);return{apart:i,border:(Ti(e,t)**2-Ti(n,t)**2)/(2*i)}}a(vh,"borderOf");function bh(n,e,t=-1){let i=null,r=Number.POSITIVE_INFINITY;return n.forEach(({center:s},o)=>{let l=Ti(s,e);o!==t&&l<r&&([i,r]=[o,l])}),i}a(bh,"nearestOf");function Sh(n){let e=a(t=>n[t],"of");return{of:e,nearest:a(t=>bh(n,t)??0,"nearest"),ahead({place:t,current:i,ahead:r}){let s=bh(n,t,i);if(s===null)return null;let o=e(i).center,l=a(p=>Ti(e(p).center,t),"far"),{apart:c,border:u}=vh(o,e(s).center,t),h=Math.max(Eg*c/2,Math.min(Ag*c/2,Tg));if(r!==null&&r!==i){let p=l(r)<l(s)+xh*c,d=vh(o,e(r).center,t).border;if(p&&d<h+xh*c/2)return r}return u<h?s:null}}}a(Sh,"knownPlaces");function Mh(n){return{places:Sh(n.regions),faceSize:n.map.face_size,nearShare:n.morph.near_share,marginShare:Rg(n),fade:n.growth.fade,open:a(e=>Promise.resolve(ks(n,e)),"open")}}a(Mh,"worldOf");function Rg({morph:n,regions:e}){let[t]=e;return!t||!Number.isFinite(t.cut)?n.near_share:Math.max(t.fold_margin/t.cut,Number.EPSILON)}a(Rg,"marginShareOf");async function wh(n,e,t,i,r){let{signal:s}=new AbortController,o=Ei("manifest.json",await nh(n,i,s));return dh(o)?Pg(n,o,e.get("rings"),t,i,r):Cg(n,o,e.get("rings"),t,i)}a(wh,"openAddress");function Cg(n,e,t,i,r){let s=Wi(e),o=Ar(t,i.arrange(s)),{dynamic:l,regions:c,triangles:u}=o,[h]=c;if(!h)throw new Ce("manifest.json: expected a region, got none");return{world:Mh(o),files:Bs(n,p=>s.files[p]?.bytes,r),title:null,triangles:u,isStatic:l===null,start:{position:h.center,yaw:0,pitch:0},centers:c.map(({center:p})=>p),makingOf:a(()=>null,"makingOf")}}a(Cg,"openBundle");async function Pg(n,e,t,{isByRings:i},r,s){if(!i)throw new Ce("strategy: expected clovr or clovrd with a scene whose regions are made on demand","address");let o=fh(e);s();let l=await ph(n,o,new AbortController().signal,Xi),c=yh({base:n,site:o,scene:l,last:t,received:r,network:Xi});return{world:c,files:c.files,title:o.title,triangles:l.triangles,isStatic:l.isStatic,start:{...l.start,pitch:0},centers:null,makingOf:c.makingOf}}a(Pg,"openScene");function Eh(n=()=>performance.now()/1e3){let e=0,t=[],i=[];return{receive(r){e+=r,t.push({time:n(),bytes:r})},frame(r){i.push(r);let s=i.reduce((o,l)=>o+l,0);for(;i.length>1&&s>1;)s-=i.shift()??0},restart(){e=0,t=[],i=[]},read(){let r=n()-1;t=t.filter(({time:l})=>l>r);let s=t.reduce((l,c)=>l+c.bytes,0),o=i.reduce((l,c)=>l+c,0)/Math.max(i.length,1);return{received:e,rate:s>0?8*s/1:null,frame:1e3*o,longest:1e3*Math.max(0,...i)}}}}a(Eh,"createMeter");function Al(n){return{...n,regions:n.regions.map(Ig)}}a(Al,"byFootprint");function Ig(n,e){let{by_footprint:t,rings:i}=n;if(!t){let l=`manifest.json: regions[${e}].by_footprint`;throw new Ce(`${l}: expected objects by footprint, got none: export the scene with by_footprint=True`,"address")}let r=i[i.length-1]?.radius??0,s={objects:0,triangles:0,geometry:null,parts:[]},o=t.portions.map(l=>({...l,radius:r,map:null}));return{...n,rings:[{...s,radius:0,map:null},...o,{...s,radius:r,map:t.map}]}}a(Ig,"inPortions");var Th=a(n=>n,"asItIs"),Rl={clovr:{isSmooth:!0,isWhole:!1,arrange:Th,isByRings:!0},clovrd:{isSmooth:!1,isWhole:!1,arrange:Th,isByRings:!0},vis0:{isSmooth:!1,isWhole:!0,arrange:Al,isByRings:!1},vis1:{isSmooth:!1,isWhole:!1,arrange:Al,isByRings:!1}};function Ah(n){let e=Object.hasOwn(Rl,n??"clovr")?Rl[n??"clovr"]:void 0;if(!e)throw new Ce(`strategy: expected ${Object.keys(Rl).join(", ")}, got ${n??""}`,"address");return e}a(Ah,"strategyOf");var Kh=0,nc=1,jh=2;var os=1,Qh=2,pr=3,fi=0,Ht=1,hn=2,Yn=0,mr=1,ic=2,rc=3,sc=4,gr=5;var Di=100,ed=101,td=102,nd=103,id=104,rd=200,_r=201,sd=202,od=203,as=204,pi=205,ad=206,ld=207,cd=208,ud=209,hd=210,dd=211,fd=212,pd=213,md=214,ho=0,fo=1,po=2,ar=3,mo=4,go=5,_o=6,yo=7,Wo=0,gd=1,_d=2,Nn=0,oc=1,ac=2,lc=3,cc=4,uc=5,hc=6,dc=7;var fc=300,Ui=301,yr=302,Xo=303,qo=304,xo=1e3,Rn=1001,vo=1002,Et=1003,yd=1004;var ls=1005;var Vt=1006,Yo=1007;var $n=1008;var en=1009,pc=1010,mc=1011,xr=1012,$o=1013,tn=1014,dn=1015,bn=1016,Jo=1017,Zo=1018,Oi=1020,gc=35902,_c=35899,yc=1021,xc=1022,Sn=1023,Xn=1026,Jn=1027,Ko=1028,jo=1029,mi=1030,Qo=1031;var ea=1033,cs=33776,us=33777,hs=33778,ds=33779,ta=35840,na=35841,ia=35842,ra=35843,sa=36196,oa=37492,aa=37496,la=37488,ca=37489,fs=37490,ua=37491,ha=37808,da=37809,fa=37810,pa=37811,ma=37812,ga=37813,_a=37814,ya=37815,xa=37816,va=37817,ba=37818,Sa=37819,Ma=37820,wa=37821,Ea=36492,Ta=36494,Aa=36495,Ra=36283,Ca=36284,ps=36285,Pa=36286;var Ur=2300,bo=2301,co=2302,Zl=2303,Kl=2400,jl=2401,Ql=2402;var xd=3200;var Ia=0,vd=1,Zn="",Zt="srgb",Or="srgb-linear",Fr="linear",Ze="srgb";var uo=7680;var bd=519,Sd=512,Md=513,wd=514,vc=515,Ed=516,Td=517,bc=518,Sc=519,Ad=35044;var Kn="300 es",un=2e3,Br=2001;function Lg(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}a(Lg,"arrayNeedsUint32");function Ng(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}a(Ng,"isTypedArray");function kr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}a(kr,"createElementNS");function Rd(){let n=kr("canvas");return n.style.display="block",n}a(Rd,"createCanvasElement");var Rh={},lr=null;function zr(...n){let e="THREE."+n.shift();lr?lr("log",e,...n):console.log(e,...n)}a(zr,"log");function Cd(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}a(Cd,"enhanceLogMessage");function Le(...n){n=Cd(n);let e="THREE."+n.shift();if(lr)lr("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}a(Le,"warn");function De(...n){n=Cd(n);let e="THREE."+n.shift();if(lr)lr("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}a(De,"error");function Dr(...n){let e=n.join(" ");e in Rh||(Rh[e]=!0,Le(...n))}a(Dr,"warnOnce");function Pd(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}a(s,"probe"),setTimeout(s,t)})}a(Pd,"probeAsync");var Id={[ho]:ho,[po]:_o,[mo]:mo,[ar]:go,[fo]:fo,[_o]:po,[yo]:yo,[go]:ar},Cn=class{static{a(this,"EventDispatcher")}addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},Dt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Cl=Math.PI/180,So=180/Math.PI;function ms(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Dt[n&255]+Dt[n>>8&255]+Dt[n>>16&255]+Dt[n>>24&255]+"-"+Dt[e&255]+Dt[e>>8&255]+"-"+Dt[e>>16&15|64]+Dt[e>>24&255]+"-"+Dt[t&63|128]+Dt[t>>8&255]+"-"+Dt[t>>16&255]+Dt[t>>24&255]+Dt[i&255]+Dt[i>>8&255]+Dt[i>>16&255]+Dt[i>>24&255]).toLowerCase()}a(ms,"generateUUID");function Ye(n,e,t){return Math.max(e,Math.min(t,n))}a(Ye,"clamp");function Dg(n,e){return(n%e+e)%e}a(Dg,"euclideanModulo");function Pl(n,e,t){return(1-t)*n+t*e}a(Pl,"lerp");function Ld(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}a(Ld,"floorPowerOfTwo");function La(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}a(La,"getNormalizationScale");function Nd(n,e){if(e.constructor===Float32Array)return n;let t=La(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}a(Nd,"denormalize");function Dd(n,e){if(e.constructor===Float32Array)return n;let t=La(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}a(Dd,"normalize");var Ve=class{static{a(this,"Vector2")}static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ye(this.x,e.x,t.x),this.y=Ye(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ye(this.x,e,t),this.y=Ye(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ye(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ye(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Pn=class{static{a(this,"Quaternion")}constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,l){let c=i[r+0],u=i[r+1],h=i[r+2],p=i[r+3],d=s[o+0],f=s[o+1],_=s[o+2],v=s[o+3];if(p!==v||c!==d||u!==f||h!==_){let g=c*d+u*f+h*_+p*v;g<0&&(d=-d,f=-f,_=-_,v=-v,g=-g);let m=1-l;if(g<.9995){let S=Math.acos(g),A=Math.sin(S);m=Math.sin(m*S)/A,l=Math.sin(l*S)/A,c=c*m+d*l,u=u*m+f*l,h=h*m+_*l,p=p*m+v*l}else{c=c*m+d*l,u=u*m+f*l,h=h*m+_*l,p=p*m+v*l;let S=1/Math.sqrt(c*c+u*u+h*h+p*p);c*=S,u*=S,h*=S,p*=S}}e[t]=c,e[t+1]=u,e[t+2]=h,e[t+3]=p}static multiplyQuaternionsFlat(e,t,i,r,s,o){let l=i[r],c=i[r+1],u=i[r+2],h=i[r+3],p=s[o],d=s[o+1],f=s[o+2],_=s[o+3];return e[t]=l*_+h*p+c*f-u*d,e[t+1]=c*_+h*d+u*p-l*f,e[t+2]=u*_+h*f+l*d-c*p,e[t+3]=h*_-l*p-c*d-u*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,l=Math.cos,c=Math.sin,u=l(i/2),h=l(r/2),p=l(s/2),d=c(i/2),f=c(r/2),_=c(s/2);switch(o){case"XYZ":this._x=d*h*p+u*f*_,this._y=u*f*p-d*h*_,this._z=u*h*_+d*f*p,this._w=u*h*p-d*f*_;break;case"YXZ":this._x=d*h*p+u*f*_,this._y=u*f*p-d*h*_,this._z=u*h*_-d*f*p,this._w=u*h*p+d*f*_;break;case"ZXY":this._x=d*h*p-u*f*_,this._y=u*f*p+d*h*_,this._z=u*h*_+d*f*p,this._w=u*h*p-d*f*_;break;case"ZYX":this._x=d*h*p-u*f*_,this._y=u*f*p+d*h*_,this._z=u*h*_-d*f*p,this._w=u*h*p+d*f*_;break;case"YZX":this._x=d*h*p+u*f*_,this._y=u*f*p+d*h*_,this._z=u*h*_-d*f*p,this._w=u*h*p-d*f*_;break;case"XZY":this._x=d*h*p-u*f*_,this._y=u*f*p-d*h*_,this._z=u*h*_+d*f*p,this._w=u*h*p+d*f*_;break;default:Le("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],l=t[5],c=t[9],u=t[2],h=t[6],p=t[10],d=i+l+p;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(s-u)*f,this._z=(o-r)*f}else if(i>l&&i>p){let f=2*Math.sqrt(1+i-l-p);this._w=(h-c)/f,this._x=.25*f,this._y=(r+o)/f,this._z=(s+u)/f}else if(l>p){let f=2*Math.sqrt(1+l-i-p);this._w=(s-u)/f,this._x=(r+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+p-i-l);this._w=(o-r)/f,this._x=(s+u)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ye(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,l=t._x,c=t._y,u=t._z,h=t._w;return this._x=i*h+o*l+r*u-s*c,this._y=r*h+o*c+s*l-i*u,this._z=s*h+o*u+i*c-r*l,this._w=o*h-i*l-r*c-s*u,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,l=this.dot(e);l<0&&(i=-i,r=-r,s=-s,o=-o,l=-l);let c=1-t;if(l<.9995){let u=Math.acos(l),h=Math.sin(u);c=Math.sin(c*u)/h,t=Math.sin(t*u)/h,this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+i*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{a(this,"Vector3")}static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Ch.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Ch.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,l=e.z,c=e.w,u=2*(o*r-l*i),h=2*(l*t-s*r),p=2*(s*i-o*t);return this.x=t+c*u+o*p-l*h,this.y=i+c*h+l*u-s*p,this.z=r+c*p+s*h-o*u,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ye(this.x,e.x,t.x),this.y=Ye(this.y,e.y,t.y),this.z=Ye(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ye(this.x,e,t),this.y=Ye(this.y,e,t),this.z=Ye(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ye(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,l=t.y,c=t.z;return this.x=r*c-s*l,this.y=s*o-i*c,this.z=i*l-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Il.copy(this).projectOnVector(e),this.sub(Il)}reflect(e){return this.sub(Il.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Ye(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Il=new G,Ch=new Pn,Ue=class{static{a(this,"Matrix3")}static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,l,c,u){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,l,c,u)}set(e,t,i,r,s,o,l,c,u){let h=this.elements;return h[0]=e,h[1]=r,h[2]=l,h[3]=t,h[4]=s,h[5]=c,h[6]=i,h[7]=o,h[8]=u,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],l=i[3],c=i[6],u=i[1],h=i[4],p=i[7],d=i[2],f=i[5],_=i[8],v=r[0],g=r[3],m=r[6],S=r[1],A=r[4],x=r[7],b=r[2],w=r[5],y=r[8];return s[0]=o*v+l*S+c*b,s[3]=o*g+l*A+c*w,s[6]=o*m+l*x+c*y,s[1]=u*v+h*S+p*b,s[4]=u*g+h*A+p*w,s[7]=u*m+h*x+p*y,s[2]=d*v+f*S+_*b,s[5]=d*g+f*A+_*w,s[8]=d*m+f*x+_*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],l=e[5],c=e[6],u=e[7],h=e[8];return t*o*h-t*l*u-i*s*h+i*l*c+r*s*u-r*o*c}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],l=e[5],c=e[6],u=e[7],h=e[8],p=h*o-l*u,d=l*c-h*s,f=u*s-o*c,_=t*p+i*d+r*f;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/_;return e[0]=p*v,e[1]=(r*u-h*i)*v,e[2]=(l*i-r*o)*v,e[3]=d*v,e[4]=(h*t-r*c)*v,e[5]=(r*s-l*t)*v,e[6]=f*v,e[7]=(i*c-u*t)*v,e[8]=(o*t-i*s)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,l){let c=Math.cos(s),u=Math.sin(s);return this.set(i*c,i*u,-i*(c*o+u*l)+o+e,-r*u,r*c,-r*(-u*o+c*l)+l+t,0,0,1),this}scale(e,t){return Dr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ll.makeScale(e,t)),this}rotate(e){return Dr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ll.makeRotation(-e)),this}translate(e,t){return Dr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ll.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ll=new Ue,Ph=new Ue().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ih=new Ue().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ug(){let n={enabled:!0,workingColorSpace:Or,spaces:{},convert:a(function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Ze&&(r.r=Wn(r.r),r.g=Wn(r.g),r.b=Wn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ze&&(r.r=or(r.r),r.g=or(r.g),r.b=or(r.b))),r},"convert"),workingToColorSpace:a(function(r,s){return this.convert(r,this.workingColorSpace,s)},"workingToColorSpace"),colorSpaceToWorking:a(function(r,s){return this.convert(r,s,this.workingColorSpace)},"colorSpaceToWorking"),getPrimaries:a(function(r){return this.spaces[r].primaries},"getPrimaries"),getTransfer:a(function(r){return r===Zn?Fr:this.spaces[r].transfer},"getTransfer"),getToneMappingMode:a(function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},"getToneMappingMode"),getLuminanceCoefficients:a(function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},"getLuminanceCoefficients"),define:a(function(r){Object.assign(this.spaces,r)},"define"),_getMatrix:a(function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},"_getMatrix"),_getDrawingBufferColorSpace:a(function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},"_getDrawingBufferColorSpace"),_getUnpackColorSpace:a(function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace},"_getUnpackColorSpace")},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Or]:{primaries:e,whitePoint:i,transfer:Fr,toXYZ:Ph,fromXYZ:Ih,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Zt},outputColorSpaceConfig:{drawingBufferColorSpace:Zt}},[Zt]:{primaries:e,whitePoint:i,transfer:Ze,toXYZ:Ph,fromXYZ:Ih,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Zt}}}),n}a(Ug,"createColorManagement");var qe=Ug();function Wn(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}a(Wn,"SRGBToLinear");function or(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}a(or,"LinearToSRGB");var qi,Mo=class{static{a(this,"ImageUtils")}static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{qi===void 0&&(qi=kr("canvas")),qi.width=e.width,qi.height=e.height;let r=qi.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=qi}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=kr("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Wn(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Wn(t[i]/255)*255):t[i]=Wn(t[i]);return{data:t,width:e.width,height:e.height}}else return Le("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Og=0,cr=class{static{a(this,"TextureSource")}constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Og++}),this.uuid=ms(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,l=r.length;o<l;o++)r[o].isDataTexture?s.push(Nl(r[o].image)):s.push(Nl(r[o]))}else s=Nl(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function Nl(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Mo.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Le("Texture: Unable to serialize Texture."),{})}a(Nl,"serializeImage");var Fg=0,Dl=new G,Ot=class n extends Cn{static{a(this,"Texture")}constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Rn,r=Rn,s=Vt,o=$n,l=Sn,c=en,u=n.DEFAULT_ANISOTROPY,h=Zn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Fg++}),this.uuid=ms(),this.name="",this.source=new cr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=u,this.format=l,this.internalFormat=null,this.type=c,this.offset=new Ve(0,0),this.repeat=new Ve(1,1),this.center=new Ve(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ue,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Dl).x}get height(){return this.source.getSize(Dl).y}get depth(){return this.source.getSize(Dl).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Le(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Le(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==fc)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case xo:e.x=e.x-Math.floor(e.x);break;case Rn:e.x=e.x<0?0:1;break;case vo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case xo:e.y=e.y-Math.floor(e.y);break;case Rn:e.y=e.y<0?0:1;break;case vo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Ot.DEFAULT_IMAGE=null;Ot.DEFAULT_MAPPING=fc;Ot.DEFAULT_ANISOTROPY=1;var nt=class{static{a(this,"Vector4")}static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,c=e.elements,u=c[0],h=c[4],p=c[8],d=c[1],f=c[5],_=c[9],v=c[2],g=c[6],m=c[10];if(Math.abs(h-d)<.01&&Math.abs(p-v)<.01&&Math.abs(_-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(p+v)<.1&&Math.abs(_+g)<.1&&Math.abs(u+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(u+1)/2,x=(f+1)/2,b=(m+1)/2,w=(h+d)/4,y=(p+v)/4,T=(_+g)/4;return A>x&&A>b?A<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(A),r=w/i,s=y/i):x>b?x<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(x),i=w/r,s=T/r):b<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(b),i=y/s,r=T/s),this.set(i,r,s,t),this}let S=Math.sqrt((g-_)*(g-_)+(p-v)*(p-v)+(d-h)*(d-h));return Math.abs(S)<.001&&(S=1),this.x=(g-_)/S,this.y=(p-v)/S,this.z=(d-h)/S,this.w=Math.acos((u+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ye(this.x,e.x,t.x),this.y=Ye(this.y,e.y,t.y),this.z=Ye(this.z,e.z,t.z),this.w=Ye(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ye(this.x,e,t),this.y=Ye(this.y,e,t),this.z=Ye(this.z,e,t),this.w=Ye(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Ye(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},wo=class extends Cn{static{a(this,"RenderTarget")}constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Vt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new nt(0,0,e,t),this.scissorTest=!1,this.viewport=new nt(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new Ot({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Vt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new cr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ft=class extends wo{static{a(this,"WebGLRenderTarget")}constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Gr=class extends Ot{static{a(this,"DataArrayTexture")}constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Et,this.minFilter=Et,this.wrapR=Rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Eo=class extends Ot{static{a(this,"Data3DTexture")}constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=Et,this.minFilter=Et,this.wrapR=Rn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Qe=class n{static{a(this,"Matrix4")}static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,l,c,u,h,p,d,f,_,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,l,c,u,h,p,d,f,_,v,g)}set(e,t,i,r,s,o,l,c,u,h,p,d,f,_,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=r,m[1]=s,m[5]=o,m[9]=l,m[13]=c,m[2]=u,m[6]=h,m[10]=p,m[14]=d,m[3]=f,m[7]=_,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/Yi.setFromMatrixColumn(e,0).length(),s=1/Yi.setFromMatrixColumn(e,1).length(),o=1/Yi.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),l=Math.sin(i),c=Math.cos(r),u=Math.sin(r),h=Math.cos(s),p=Math.sin(s);if(e.order==="XYZ"){let d=o*h,f=o*p,_=l*h,v=l*p;t[0]=c*h,t[4]=-c*p,t[8]=u,t[1]=f+_*u,t[5]=d-v*u,t[9]=-l*c,t[2]=v-d*u,t[6]=_+f*u,t[10]=o*c}else if(e.order==="YXZ"){let d=c*h,f=c*p,_=u*h,v=u*p;t[0]=d+v*l,t[4]=_*l-f,t[8]=o*u,t[1]=o*p,t[5]=o*h,t[9]=-l,t[2]=f*l-_,t[6]=v+d*l,t[10]=o*c}else if(e.order==="ZXY"){let d=c*h,f=c*p,_=u*h,v=u*p;t[0]=d-v*l,t[4]=-o*p,t[8]=_+f*l,t[1]=f+_*l,t[5]=o*h,t[9]=v-d*l,t[2]=-o*u,t[6]=l,t[10]=o*c}else if(e.order==="ZYX"){let d=o*h,f=o*p,_=l*h,v=l*p;t[0]=c*h,t[4]=_*u-f,t[8]=d*u+v,t[1]=c*p,t[5]=v*u+d,t[9]=f*u-_,t[2]=-u,t[6]=l*c,t[10]=o*c}else if(e.order==="YZX"){let d=o*c,f=o*u,_=l*c,v=l*u;t[0]=c*h,t[4]=v-d*p,t[8]=_*p+f,t[1]=p,t[5]=o*h,t[9]=-l*h,t[2]=-u*h,t[6]=f*p+_,t[10]=d-v*p}else if(e.order==="XZY"){let d=o*c,f=o*u,_=l*c,v=l*u;t[0]=c*h,t[4]=-p,t[8]=u*h,t[1]=d*p+v,t[5]=o*h,t[9]=f*p-_,t[2]=_*p-f,t[6]=l*h,t[10]=v*p+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Bg,e,kg)}lookAt(e,t,i){let r=this.elements;return $t.subVectors(e,t),$t.lengthSq()===0&&($t.z=1),$t.normalize(),ni.crossVectors(i,$t),ni.lengthSq()===0&&(Math.abs(i.z)===1?$t.x+=1e-4:$t.z+=1e-4,$t.normalize(),ni.crossVectors(i,$t)),ni.normalize(),Vs.crossVectors($t,ni),r[0]=ni.x,r[4]=Vs.x,r[8]=$t.x,r[1]=ni.y,r[5]=Vs.y,r[9]=$t.y,r[2]=ni.z,r[6]=Vs.z,r[10]=$t.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],l=i[4],c=i[8],u=i[12],h=i[1],p=i[5],d=i[9],f=i[13],_=i[2],v=i[6],g=i[10],m=i[14],S=i[3],A=i[7],x=i[11],b=i[15],w=r[0],y=r[4],T=r[8],L=r[12],C=r[1],D=r[5],N=r[9],B=r[13],P=r[2],q=r[6],$=r[10],O=r[14],j=r[3],H=r[7],Q=r[11],te=r[15];return s[0]=o*w+l*C+c*P+u*j,s[4]=o*y+l*D+c*q+u*H,s[8]=o*T+l*N+c*$+u*Q,s[12]=o*L+l*B+c*O+u*te,s[1]=h*w+p*C+d*P+f*j,s[5]=h*y+p*D+d*q+f*H,s[9]=h*T+p*N+d*$+f*Q,s[13]=h*L+p*B+d*O+f*te,s[2]=_*w+v*C+g*P+m*j,s[6]=_*y+v*D+g*q+m*H,s[10]=_*T+v*N+g*$+m*Q,s[14]=_*L+v*B+g*O+m*te,s[3]=S*w+A*C+x*P+b*j,s[7]=S*y+A*D+x*q+b*H,s[11]=S*T+A*N+x*$+b*Q,s[15]=S*L+A*B+x*O+b*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],l=e[5],c=e[9],u=e[13],h=e[2],p=e[6],d=e[10],f=e[14],_=e[3],v=e[7],g=e[11],m=e[15],S=c*f-u*d,A=l*f-u*p,x=l*d-c*p,b=o*f-u*h,w=o*d-c*h,y=o*p-l*h;return t*(v*S-g*A+m*x)-i*(_*S-g*b+m*w)+r*(_*A-v*b+m*y)-s*(_*x-v*w+g*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],l=e[9],c=e[2],u=e[6],h=e[10];return t*(o*h-l*u)-i*(s*h-l*c)+r*(s*u-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],l=e[5],c=e[6],u=e[7],h=e[8],p=e[9],d=e[10],f=e[11],_=e[12],v=e[13],g=e[14],m=e[15],S=t*l-i*o,A=t*c-r*o,x=t*u-s*o,b=i*c-r*l,w=i*u-s*l,y=r*u-s*c,T=h*v-p*_,L=h*g-d*_,C=h*m-f*_,D=p*g-d*v,N=p*m-f*v,B=d*m-f*g,P=S*B-A*N+x*D+b*C-w*L+y*T;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let q=1/P;return e[0]=(l*B-c*N+u*D)*q,e[1]=(r*N-i*B-s*D)*q,e[2]=(v*y-g*w+m*b)*q,e[3]=(d*w-p*y-f*b)*q,e[4]=(c*C-o*B-u*L)*q,e[5]=(t*B-r*C+s*L)*q,e[6]=(g*x-_*y-m*A)*q,e[7]=(h*y-d*x+f*A)*q,e[8]=(o*N-l*C+u*T)*q,e[9]=(i*C-t*N-s*T)*q,e[10]=(_*w-v*x+m*S)*q,e[11]=(p*x-h*w-f*S)*q,e[12]=(l*L-o*D-c*T)*q,e[13]=(t*D-i*L+r*T)*q,e[14]=(v*A-_*b-g*S)*q,e[15]=(h*b-p*A+d*S)*q,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,l=e.y,c=e.z,u=s*o,h=s*l;return this.set(u*o+i,u*l-r*c,u*c+r*l,0,u*l+r*c,h*l+i,h*c-r*o,0,u*c-r*l,h*c+r*o,s*c*c+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,l=t._z,c=t._w,u=s+s,h=o+o,p=l+l,d=s*u,f=s*h,_=s*p,v=o*h,g=o*p,m=l*p,S=c*u,A=c*h,x=c*p,b=i.x,w=i.y,y=i.z;return r[0]=(1-(v+m))*b,r[1]=(f+x)*b,r[2]=(_-A)*b,r[3]=0,r[4]=(f-x)*w,r[5]=(1-(d+m))*w,r[6]=(g+S)*w,r[7]=0,r[8]=(_+A)*y,r[9]=(g-S)*y,r[10]=(1-(d+v))*y,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=Yi.set(r[0],r[1],r[2]).length(),l=Yi.set(r[4],r[5],r[6]).length(),c=Yi.set(r[8],r[9],r[10]).length();s<0&&(o=-o),mn.copy(this);let u=1/o,h=1/l,p=1/c;return mn.elements[0]*=u,mn.elements[1]*=u,mn.elements[2]*=u,mn.elements[4]*=h,mn.elements[5]*=h,mn.elements[6]*=h,mn.elements[8]*=p,mn.elements[9]*=p,mn.elements[10]*=p,t.setFromRotationMatrix(mn),i.x=o,i.y=l,i.z=c,this}makePerspective(e,t,i,r,s,o,l=un,c=!1){let u=this.elements,h=2*s/(t-e),p=2*s/(i-r),d=(t+e)/(t-e),f=(i+r)/(i-r),_,v;if(c)_=s/(o-s),v=o*s/(o-s);else if(l===un)_=-(o+s)/(o-s),v=-2*o*s/(o-s);else if(l===Br)_=-o/(o-s),v=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+l);return u[0]=h,u[4]=0,u[8]=d,u[12]=0,u[1]=0,u[5]=p,u[9]=f,u[13]=0,u[2]=0,u[6]=0,u[10]=_,u[14]=v,u[3]=0,u[7]=0,u[11]=-1,u[15]=0,this}makeOrthographic(e,t,i,r,s,o,l=un,c=!1){let u=this.elements,h=2/(t-e),p=2/(i-r),d=-(t+e)/(t-e),f=-(i+r)/(i-r),_,v;if(c)_=1/(o-s),v=o/(o-s);else if(l===un)_=-2/(o-s),v=-(o+s)/(o-s);else if(l===Br)_=-1/(o-s),v=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+l);return u[0]=h,u[4]=0,u[8]=0,u[12]=d,u[1]=0,u[5]=p,u[9]=0,u[13]=f,u[2]=0,u[6]=0,u[10]=_,u[14]=v,u[3]=0,u[7]=0,u[11]=0,u[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Yi=new G,mn=new Qe,Bg=new G(0,0,0),kg=new G(1,1,1),ni=new G,Vs=new G,$t=new G,Lh=new Qe,Nh=new Pn,qn=class n{static{a(this,"Euler")}constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],l=r[8],c=r[1],u=r[5],h=r[9],p=r[2],d=r[6],f=r[10];switch(t){case"XYZ":this._y=Math.asin(Ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(d,u),this._z=0);break;case"YXZ":this._x=Math.asin(-Ye(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(l,f),this._z=Math.atan2(c,u)):(this._y=Math.atan2(-p,s),this._z=0);break;case"ZXY":this._x=Math.asin(Ye(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-p,f),this._z=Math.atan2(-o,u)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-Ye(p,-1,1)),Math.abs(p)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,u));break;case"YZX":this._z=Math.asin(Ye(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,u),this._y=Math.atan2(-p,s)):(this._x=0,this._y=Math.atan2(l,f));break;case"XZY":this._z=Math.asin(-Ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,u),this._y=Math.atan2(l,s)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Le("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Lh.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Lh,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Nh.setFromEuler(this),this.setFromQuaternion(Nh,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};qn.DEFAULT_ORDER="XYZ";var Vr=class{static{a(this,"Layers")}constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},zg=0,Dh=new G,$i=new Pn,kn=new Qe,Hs=new G,Rr=new G,Gg=new G,Vg=new Pn,Uh=new G(1,0,0),Oh=new G(0,1,0),Fh=new G(0,0,1),Bh={type:"added"},Hg={type:"removed"},Ji={type:"childadded",child:null},Ul={type:"childremoved",child:null},qt=class n extends Cn{static{a(this,"Object3D")}constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:zg++}),this.uuid=ms(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new G,t=new qn,i=new Pn,r=new G(1,1,1);function s(){i.setFromEuler(t,!1)}a(s,"onRotationChange");function o(){t.setFromQuaternion(i,void 0,!1)}a(o,"onQuaternionChange"),t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Qe},normalMatrix:{value:new Ue}}),this.matrix=new Qe,this.matrixWorld=new Qe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Vr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return $i.setFromAxisAngle(e,t),this.quaternion.multiply($i),this}rotateOnWorldAxis(e,t){return $i.setFromAxisAngle(e,t),this.quaternion.premultiply($i),this}rotateX(e){return this.rotateOnAxis(Uh,e)}rotateY(e){return this.rotateOnAxis(Oh,e)}rotateZ(e){return this.rotateOnAxis(Fh,e)}translateOnAxis(e,t){return Dh.copy(e).applyQuaternion(this.quaternion),this.position.add(Dh.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Uh,e)}translateY(e){return this.translateOnAxis(Oh,e)}translateZ(e){return this.translateOnAxis(Fh,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(kn.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Hs.copy(e):Hs.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),Rr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?kn.lookAt(Rr,Hs,this.up):kn.lookAt(Hs,Rr,this.up),this.quaternion.setFromRotationMatrix(kn),r&&(kn.extractRotation(r.matrixWorld),$i.setFromRotationMatrix(kn),this.quaternion.premultiply($i.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(De("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Bh),Ji.child=e,this.dispatchEvent(Ji),Ji.child=null):De("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Hg),Ul.child=e,this.dispatchEvent(Ul),Ul.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),kn.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),kn.multiply(e.parent.matrixWorld)),e.applyMatrix4(kn),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Bh),Ji.child=e,this.dispatchEvent(Ji),Ji.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Rr,e,Gg),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Rr,Vg,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,l=s.length;o<l;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(l=>({...l,boundingBox:l.boundingBox?l.boundingBox.toJSON():void 0,boundingSphere:l.boundingSphere?l.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(l=>({...l})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(l,c){return l[c.uuid]===void 0&&(l[c.uuid]=c.toJSON(e)),c.uuid}if(a(s,"serialize"),this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let l=this.geometry.parameters;if(l!==void 0&&l.shapes!==void 0){let c=l.shapes;if(Array.isArray(c))for(let u=0,h=c.length;u<h;u++){let p=c[u];s(e.shapes,p)}else s(e.shapes,c)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let l=[];for(let c=0,u=this.material.length;c<u;c++)l.push(s(e.materials,this.material[c]));r.material=l}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let l=0;l<this.children.length;l++)r.children.push(this.children[l].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let l=0;l<this.animations.length;l++){let c=this.animations[l];r.animations.push(s(e.animations,c))}}if(t){let l=o(e.geometries),c=o(e.materials),u=o(e.textures),h=o(e.images),p=o(e.shapes),d=o(e.skeletons),f=o(e.animations),_=o(e.nodes);l.length>0&&(i.geometries=l),c.length>0&&(i.materials=c),u.length>0&&(i.textures=u),h.length>0&&(i.images=h),p.length>0&&(i.shapes=p),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),_.length>0&&(i.nodes=_)}return i.object=r,i;function o(l){let c=[];for(let u in l){let h=l[u];delete h.metadata,c.push(h)}return c}a(o,"extractFromCache")}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};qt.DEFAULT_UP=new G(0,1,0);qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Kt=class extends qt{static{a(this,"Group")}constructor(){super(),this.isGroup=!0,this.type="Group"}},Wg={type:"move"},ur=class{static{a(this,"WebXRController")}constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Kt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Kt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Kt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,l=this._targetRay,c=this._grip,u=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(u&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,i),m=this._getHandJoint(u,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=u.joints["index-finger-tip"],p=u.joints["thumb-tip"],d=h.position.distanceTo(p.position),f=.02,_=.005;u.inputState.pinching&&d>f+_?(u.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!u.inputState.pinching&&d<=f-_&&(u.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));l!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,this.dispatchEvent(Wg)))}return l!==null&&(l.visible=r!==null),c!==null&&(c.visible=s!==null),u!==null&&(u.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Kt;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Ud={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ii={h:0,s:0,l:0},Ws={h:0,s:0,l:0};function Ol(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}a(Ol,"hue2rgb");var ze=class{static{a(this,"Color")}constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Zt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,qe.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=qe.workingColorSpace){return this.r=e,this.g=t,this.b=i,qe.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=qe.workingColorSpace){if(e=Dg(e,1),t=Ye(t,0,1),i=Ye(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=Ol(o,s,e+1/3),this.g=Ol(o,s,e),this.b=Ol(o,s,e-1/3)}return qe.colorSpaceToWorking(this,r),this}setStyle(e,t=Zt){function i(s){s!==void 0&&parseFloat(s)<1&&Le("Color: Alpha component of "+e+" will be ignored.")}a(i,"handleAlpha");let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],l=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(l))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(l))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(l))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Le("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Le("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Zt){let i=Ud[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Le("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Wn(e.r),this.g=Wn(e.g),this.b=Wn(e.b),this}copyLinearToSRGB(e){return this.r=or(e.r),this.g=or(e.g),this.b=or(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Zt){return qe.workingToColorSpace(Ut.copy(this),e),Math.round(Ye(Ut.r*255,0,255))*65536+Math.round(Ye(Ut.g*255,0,255))*256+Math.round(Ye(Ut.b*255,0,255))}getHexString(e=Zt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=qe.workingColorSpace){qe.workingToColorSpace(Ut.copy(this),t);let i=Ut.r,r=Ut.g,s=Ut.b,o=Math.max(i,r,s),l=Math.min(i,r,s),c,u,h=(l+o)/2;if(l===o)c=0,u=0;else{let p=o-l;switch(u=h<=.5?p/(o+l):p/(2-o-l),o){case i:c=(r-s)/p+(r<s?6:0);break;case r:c=(s-i)/p+2;break;case s:c=(i-r)/p+4;break}c/=6}return e.h=c,e.s=u,e.l=h,e}getRGB(e,t=qe.workingColorSpace){return qe.workingToColorSpace(Ut.copy(this),t),e.r=Ut.r,e.g=Ut.g,e.b=Ut.b,e}getStyle(e=Zt){qe.workingToColorSpace(Ut.copy(this),e);let t=Ut.r,i=Ut.g,r=Ut.b;return e!==Zt?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(ii),this.setHSL(ii.h+e,ii.s+t,ii.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(ii),e.getHSL(Ws);let i=Pl(ii.h,Ws.h,t),r=Pl(ii.s,Ws.s,t),s=Pl(ii.l,Ws.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Ut=new ze;ze.NAMES=Ud;var jt=class extends qt{static{a(this,"Scene")}constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new qn,this.environmentIntensity=1,this.environmentRotation=new qn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},gn=new G,zn=new G,Fl=new G,Gn=new G,Zi=new G,Ki=new G,kh=new G,Bl=new G,kl=new G,zl=new G,Gl=new nt,Vl=new nt,Hl=new nt,ai=class n{static{a(this,"Triangle")}constructor(e=new G,t=new G,i=new G){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),gn.subVectors(e,t),r.cross(gn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){gn.subVectors(r,t),zn.subVectors(i,t),Fl.subVectors(e,t);let o=gn.dot(gn),l=gn.dot(zn),c=gn.dot(Fl),u=zn.dot(zn),h=zn.dot(Fl),p=o*u-l*l;if(p===0)return s.set(0,0,0),null;let d=1/p,f=(u*c-l*h)*d,_=(o*h-l*c)*d;return s.set(1-f-_,_,f)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Gn)===null?!1:Gn.x>=0&&Gn.y>=0&&Gn.x+Gn.y<=1}static getInterpolation(e,t,i,r,s,o,l,c){return this.getBarycoord(e,t,i,r,Gn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,Gn.x),c.addScaledVector(o,Gn.y),c.addScaledVector(l,Gn.z),c)}static getInterpolatedAttribute(e,t,i,r,s,o){return Gl.setScalar(0),Vl.setScalar(0),Hl.setScalar(0),Gl.fromBufferAttribute(e,t),Vl.fromBufferAttribute(e,i),Hl.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Gl,s.x),o.addScaledVector(Vl,s.y),o.addScaledVector(Hl,s.z),o}static isFrontFacing(e,t,i,r){return gn.subVectors(i,t),zn.subVectors(e,t),gn.cross(zn).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return gn.subVectors(this.c,this.b),zn.subVectors(this.a,this.b),gn.cross(zn).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,l;Zi.subVectors(r,i),Ki.subVectors(s,i),Bl.subVectors(e,i);let c=Zi.dot(Bl),u=Ki.dot(Bl);if(c<=0&&u<=0)return t.copy(i);kl.subVectors(e,r);let h=Zi.dot(kl),p=Ki.dot(kl);if(h>=0&&p<=h)return t.copy(r);let d=c*p-h*u;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),t.copy(i).addScaledVector(Zi,o);zl.subVectors(e,s);let f=Zi.dot(zl),_=Ki.dot(zl);if(_>=0&&f<=_)return t.copy(s);let v=f*u-c*_;if(v<=0&&u>=0&&_<=0)return l=u/(u-_),t.copy(i).addScaledVector(Ki,l);let g=h*_-f*p;if(g<=0&&p-h>=0&&f-_>=0)return kh.subVectors(s,r),l=(p-h)/(p-h+(f-_)),t.copy(r).addScaledVector(kh,l);let m=1/(g+v+d);return o=v*m,l=d*m,t.copy(i).addScaledVector(Zi,o).addScaledVector(Ki,l)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},In=class{static{a(this,"Box3")}constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(_n.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(_n.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=_n.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,l=s.count;o<l;o++)e.isMesh===!0?e.getVertexPosition(o,_n):_n.fromBufferAttribute(s,o),_n.applyMatrix4(e.matrixWorld),this.expandByPoint(_n);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Xs.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Xs.copy(i.boundingBox)),Xs.applyMatrix4(e.matrixWorld),this.union(Xs)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,_n),_n.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Cr),qs.subVectors(this.max,Cr),ji.subVectors(e.a,Cr),Qi.subVectors(e.b,Cr),er.subVectors(e.c,Cr),ri.subVectors(Qi,ji),si.subVectors(er,Qi),Ai.subVectors(ji,er);let t=[0,-ri.z,ri.y,0,-si.z,si.y,0,-Ai.z,Ai.y,ri.z,0,-ri.x,si.z,0,-si.x,Ai.z,0,-Ai.x,-ri.y,ri.x,0,-si.y,si.x,0,-Ai.y,Ai.x,0];return!Wl(t,ji,Qi,er,qs)||(t=[1,0,0,0,1,0,0,0,1],!Wl(t,ji,Qi,er,qs))?!1:(Ys.crossVectors(ri,si),t=[Ys.x,Ys.y,Ys.z],Wl(t,ji,Qi,er,qs))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,_n).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(_n).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Vn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Vn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Vn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Vn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Vn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Vn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Vn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Vn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Vn),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Vn=[new G,new G,new G,new G,new G,new G,new G,new G],_n=new G,Xs=new In,ji=new G,Qi=new G,er=new G,ri=new G,si=new G,Ai=new G,Cr=new G,qs=new G,Ys=new G,Ri=new G;function Wl(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){Ri.fromArray(n,s);let l=r.x*Math.abs(Ri.x)+r.y*Math.abs(Ri.y)+r.z*Math.abs(Ri.z),c=e.dot(Ri),u=t.dot(Ri),h=i.dot(Ri);if(Math.max(-Math.max(c,u,h),Math.min(c,u,h))>l)return!1}return!0}a(Wl,"satForAxes");var mt=new G,$s=new Ve,Xg=0,Xt=class extends Cn{static{a(this,"BufferAttribute")}constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Xg++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Ad,this.updateRanges=[],this.gpuType=dn,this.version=0,this._normalizationScale=e!==void 0?La(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)$s.fromBufferAttribute(this,t),$s.applyMatrix3(e),this.setXY(t,$s.x,$s.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)mt.fromBufferAttribute(this,t),mt.applyMatrix3(e),this.setXYZ(t,mt.x,mt.y,mt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)mt.fromBufferAttribute(this,t),mt.applyMatrix4(e),this.setXYZ(t,mt.x,mt.y,mt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)mt.fromBufferAttribute(this,t),mt.applyNormalMatrix(e),this.setXYZ(t,mt.x,mt.y,mt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)mt.fromBufferAttribute(this,t),mt.transformDirection(e),this.setXYZ(t,mt.x,mt.y,mt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Nd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Dd(e,this.array)}};var Hr=class extends Xt{static{a(this,"Uint16BufferAttribute")}constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Wr=class extends Xt{static{a(this,"Uint32BufferAttribute")}constructor(e,t,i){super(new Uint32Array(e),t,i)}};var dt=class extends Xt{static{a(this,"Float32BufferAttribute")}constructor(e,t,i){super(new Float32Array(e),t,i)}},qg=new In,Pr=new G,Xl=new G,li=class{static{a(this,"Sphere")}constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):qg.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Pr.subVectors(e,this.center);let t=Pr.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(Pr,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Xl.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Pr.copy(e.center).add(Xl)),this.expandByPoint(Pr.copy(e.center).sub(Xl))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Yg=0,cn=new Qe,ql=new qt,tr=new G,Jt=new In,Ir=new In,wt=new G,Tt=class n extends Cn{static{a(this,"BufferGeometry")}constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Yg++}),this.uuid=ms(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Lg(e)?Wr:Hr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new Ue().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return cn.makeRotationFromQuaternion(e),this.applyMatrix4(cn),this}rotateX(e){return cn.makeRotationX(e),this.applyMatrix4(cn),this}rotateY(e){return cn.makeRotationY(e),this.applyMatrix4(cn),this}rotateZ(e){return cn.makeRotationZ(e),this.applyMatrix4(cn),this}translate(e,t,i){return cn.makeTranslation(e,t,i),this.applyMatrix4(cn),this}scale(e,t,i){return cn.makeScale(e,t,i),this.applyMatrix4(cn),this}lookAt(e){return ql.lookAt(e),ql.updateMatrix(),this.applyMatrix4(ql.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(tr).negate(),this.translate(tr.x,tr.y,tr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new dt(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Le("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new In);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];Jt.setFromBufferAttribute(s),this.morphTargetsRelative?(wt.addVectors(this.boundingBox.min,Jt.min),this.boundingBox.expandByPoint(wt),wt.addVectors(this.boundingBox.max,Jt.max),this.boundingBox.expandByPoint(wt)):(this.boundingBox.expandByPoint(Jt.min),this.boundingBox.expandByPoint(Jt.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&De('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new li);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let i=this.boundingSphere.center;if(Jt.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let l=t[s];Ir.setFromBufferAttribute(l),this.morphTargetsRelative?(wt.addVectors(Jt.min,Ir.min),Jt.expandByPoint(wt),wt.addVectors(Jt.max,Ir.max),Jt.expandByPoint(wt)):(Jt.expandByPoint(Ir.min),Jt.expandByPoint(Ir.max))}Jt.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)wt.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(wt));if(t)for(let s=0,o=t.length;s<o;s++){let l=t[s],c=this.morphTargetsRelative;for(let u=0,h=l.count;u<h;u++)wt.fromBufferAttribute(l,u),c&&(tr.fromBufferAttribute(e,u),wt.add(tr)),r=Math.max(r,i.distanceToSquared(wt))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&De('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){De("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Xt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let l=[],c=[],u=new Uint8Array(i.count);for(let L=0;L<i.count;L++)l[L]=new G,c[L]=new G;let h=new G,p=new G,d=new G,f=new Ve,_=new Ve,v=new Ve,g=new G,m=new G;function S(L,C,D){u[L]=u[C]=u[D]=1,h.fromBufferAttribute(i,L),p.fromBufferAttribute(i,C),d.fromBufferAttribute(i,D),f.fromBufferAttribute(s,L),_.fromBufferAttribute(s,C),v.fromBufferAttribute(s,D),p.sub(h),d.sub(h),_.sub(f),v.sub(f);let N=1/(_.x*v.y-v.x*_.y);isFinite(N)&&(g.copy(p).multiplyScalar(v.y).addScaledVector(d,-_.y).multiplyScalar(N),m.copy(d).multiplyScalar(_.x).addScaledVector(p,-v.x).multiplyScalar(N),l[L].add(g),l[C].add(g),l[D].add(g),c[L].add(m),c[C].add(m),c[D].add(m))}a(S,"handleTriangle");let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let L=0,C=A.length;L<C;++L){let D=A[L],N=D.start,B=D.count;for(let P=N,q=N+B;P<q;P+=3)S(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let x=new G,b=new G,w=new G,y=new G;function T(L){w.fromBufferAttribute(r,L),y.copy(w);let C=l[L];x.copy(C),x.sub(w.multiplyScalar(w.dot(C))).normalize(),b.crossVectors(y,C);let N=b.dot(c[L])<0?-1:1;o.setXYZW(L,x.x,x.y,x.z,N)}a(T,"handleVertex");for(let L=0,C=i.count;L<C;++L)u[L]&&T(L);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Xt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let r=new G,s=new G,o=new G,l=new G,c=new G,u=new G,h=new G,p=new G;if(e)for(let d=0,f=e.count;d<f;d+=3){let _=e.getX(d+0),v=e.getX(d+1),g=e.getX(d+2);r.fromBufferAttribute(t,_),s.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),h.subVectors(o,s),p.subVectors(r,s),h.cross(p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,v),u.fromBufferAttribute(i,g),l.add(h),c.add(h),u.add(h),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(v,c.x,c.y,c.z),i.setXYZ(g,u.x,u.y,u.z)}else for(let d=0,f=t.count;d<f;d+=3)r.fromBufferAttribute(t,d+0),s.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,s),p.subVectors(r,s),h.cross(p),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)wt.fromBufferAttribute(e,t),wt.normalize(),e.setXYZ(t,wt.x,wt.y,wt.z)}toNonIndexed(){function e(l,c){let u=l.array,h=l.itemSize,p=l.normalized,d=new u.constructor(c.length*h),f=0,_=0;for(let v=0,g=c.length;v<g;v++){l.isInterleavedBufferAttribute?f=c[v]*l.data.stride+l.offset:f=c[v]*h;for(let m=0;m<h;m++)d[_++]=u[f++]}return new Xt(d,h,p)}if(a(e,"convertBufferAttribute"),this.index===null)return Le("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let l in r){let c=r[l],u=e(c,i);t.setAttribute(l,u)}let s=this.morphAttributes;for(let l in s){let c=[],u=s[l];for(let h=0,p=u.length;h<p;h++){let d=u[h],f=e(d,i);c.push(f)}t.morphAttributes[l]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let l=0,c=o.length;l<c;l++){let u=o[l];t.addGroup(u.start,u.count,u.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let u in c)c[u]!==void 0&&(e[u]=c[u]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let c in i){let u=i[c];e.data.attributes[c]=u.toJSON(e.data)}let r={},s=!1;for(let c in this.morphAttributes){let u=this.morphAttributes[c],h=[];for(let p=0,d=u.length;p<d;p++){let f=u[p];h.push(f.toJSON(e.data))}h.length>0&&(r[c]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let l=this.boundingSphere;return l!==null&&(e.data.boundingSphere=l.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let u in r){let h=r[u];this.setAttribute(u,h.clone(t))}let s=e.morphAttributes;for(let u in s){let h=[],p=s[u];for(let d=0,f=p.length;d<f;d++)h.push(p[d].clone(t));this.morphAttributes[u]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let u=0,h=o.length;u<h;u++){let p=o[u];this.addGroup(p.start,p.count,p.materialIndex)}let l=e.boundingBox;l!==null&&(this.boundingBox=l.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var zt=new G,Xr=class n{static{a(this,"InterleavedBufferAttribute")}constructor(e,t,i,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=r,this._normalizationScale=e!==void 0?La(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)zt.fromBufferAttribute(this,t),zt.applyMatrix4(e),this.setXYZ(t,zt.x,zt.y,zt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)zt.fromBufferAttribute(this,t),zt.applyNormalMatrix(e),this.setXYZ(t,zt.x,zt.y,zt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)zt.fromBufferAttribute(this,t),zt.transformDirection(e),this.setXYZ(t,zt.x,zt.y,zt.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){zr("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new Xt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){zr("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Nd(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Dd(e,this.data.array)}},Yl=new G,$g=new G,Jg=new Ue,yn=class{static{a(this,"Plane")}constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Yl.subVectors(i,t).cross($g.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Yl),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||Jg.getNormalMatrix(e),r=this.coplanarPoint(Yl).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Zg=0,ci=class extends Cn{static{a(this,"Material")}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Zg++}),this.uuid=ms(),this.name="",this.type="Material",this.blending=mr,this.side=fi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=as,this.blendDst=pi,this.blendEquation=Di,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ze(0,0,0),this.blendAlpha=0,this.depthFunc=ar,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=bd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=uo,this.stencilZFail=uo,this.stencilZPass=uo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Le(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Le(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let l in s){let c=s[l];delete c.metadata,o.push(c)}return o}if(a(r,"extractFromCache"),t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ze().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new yn().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ve().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ve().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Hn=new G,$l=new G,Js=new G,Zs=new G,To=class{static{a(this,"Ray")}constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Hn)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Hn.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Hn.copy(this.origin).addScaledVector(this.direction,t),Hn.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){$l.copy(e).add(t).multiplyScalar(.5),Js.copy(t).sub(e).normalize(),Zs.copy(this.origin).sub($l);let s=e.distanceTo(t)*.5,o=-this.direction.dot(Js),l=Zs.dot(this.direction),c=-Zs.dot(Js),u=Zs.lengthSq(),h=Math.abs(1-o*o),p,d,f,_;if(h>0)if(p=o*c-l,d=o*l-c,_=s*h,p>=0)if(d>=-_)if(d<=_){let v=1/h;p*=v,d*=v,f=p*(p+o*d+2*l)+d*(o*p+d+2*c)+u}else d=s,p=Math.max(0,-(o*d+l)),f=-p*p+d*(d+2*c)+u;else d=-s,p=Math.max(0,-(o*d+l)),f=-p*p+d*(d+2*c)+u;else d<=-_?(p=Math.max(0,-(-o*s+l)),d=p>0?-s:Math.min(Math.max(-s,-c),s),f=-p*p+d*(d+2*c)+u):d<=_?(p=0,d=Math.min(Math.max(-s,-c),s),f=d*(d+2*c)+u):(p=Math.max(0,-(o*s+l)),d=p>0?s:Math.min(Math.max(-s,-c),s),f=-p*p+d*(d+2*c)+u);else d=o>0?-s:s,p=Math.max(0,-(o*d+l)),f=-p*p+d*(d+2*c)+u;return i&&i.copy(this.origin).addScaledVector(this.direction,p),r&&r.copy($l).addScaledVector(Js,d),f}intersectSphere(e,t){if(e.radius<0)return null;Hn.subVectors(e.center,this.origin);let i=Hn.dot(this.direction),r=Hn.dot(Hn)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),l=i-o,c=i+o;return c<0?null:l<0?this.at(c,t):this.at(l,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,l,c,u=1/this.direction.x,h=1/this.direction.y,p=1/this.direction.z,d=this.origin;return u>=0?(i=(e.min.x-d.x)*u,r=(e.max.x-d.x)*u):(i=(e.max.x-d.x)*u,r=(e.min.x-d.x)*u),h>=0?(s=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(s=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),p>=0?(l=(e.min.z-d.z)*p,c=(e.max.z-d.z)*p):(l=(e.max.z-d.z)*p,c=(e.min.z-d.z)*p),i>c||l>r)||((l>i||i!==i)&&(i=l),(c<r||r!==r)&&(r=c),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Hn)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,l=this.direction,c=l.x,u=l.y,h=l.z,p=e.x-o.x,d=e.y-o.y,f=e.z-o.z,_=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=i.x-o.x,S=i.y-o.y,A=i.z-o.z,x=Math.abs(c),b=Math.abs(u),w=Math.abs(h),y,T,L,C,D,N,B,P,q,$,O,j;if(x>=b&&x>=w?(L=c,N=p,q=_,j=m,c>=0?(y=u,T=h,C=d,D=f,B=v,P=g,$=S,O=A):(y=h,T=u,C=f,D=d,B=g,P=v,$=A,O=S)):b>=w?(L=u,N=d,q=v,j=S,u>=0?(y=h,T=c,C=f,D=p,B=g,P=_,$=A,O=m):(y=c,T=h,C=p,D=f,B=_,P=g,$=m,O=A)):(L=h,N=f,q=g,j=A,h>=0?(y=c,T=u,C=p,D=d,B=_,P=v,$=m,O=S):(y=u,T=c,C=d,D=p,B=v,P=_,$=S,O=m)),L===0)return null;let H=y/L,Q=T/L,te=1/L,ne=C-H*N,he=D-Q*N,X=B-H*q,me=P-Q*q,be=$-H*j,Re=O-Q*j,ge=be*me-Re*X,Ne=ne*Re-he*be,ot=X*he-me*ne;if(r){if(ge<0||Ne<0||ot<0)return null}else if((ge<0||Ne<0||ot<0)&&(ge>0||Ne>0||ot>0))return null;let Ie=ge+Ne+ot;if(Ie===0)return null;let Ke=te*(ge*N+Ne*q+ot*j);return(Ie>0?Ke<0:Ke>0)?null:this.at(Ke/Ie,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hr=class extends ci{static{a(this,"MeshBasicMaterial")}constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ze(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new qn,this.combine=Wo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},zh=new Qe,Ci=new To,Ks=new li,Gh=new G,js=new G,Qs=new G,eo=new G,Jl=new G,to=new G,Vh=new G,no=new G,st=class extends qt{static{a(this,"Mesh")}constructor(e=new Tt,t=new hr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let l=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[l]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let l=this.morphTargetInfluences;if(s&&l){to.set(0,0,0);for(let c=0,u=s.length;c<u;c++){let h=l[c],p=s[c];h!==0&&(Jl.fromBufferAttribute(p,e),o?to.addScaledVector(Jl,h):to.addScaledVector(Jl.sub(t),h))}t.add(to)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ks.copy(i.boundingSphere),Ks.applyMatrix4(s),Ci.copy(e.ray).recast(e.near),!(Ks.containsPoint(Ci.origin)===!1&&(Ci.intersectSphere(Ks,Gh)===null||Ci.origin.distanceToSquared(Gh)>(e.far-e.near)**2))&&(zh.copy(s).invert(),Ci.copy(e.ray).applyMatrix4(zh),!(i.boundingBox!==null&&Ci.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ci)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,l=s.index,c=s.attributes.position,u=s.attributes.uv,h=s.attributes.uv1,p=s.attributes.normal,d=s.groups,f=s.drawRange;if(l!==null)if(Array.isArray(o))for(let _=0,v=d.length;_<v;_++){let g=d[_],m=o[g.materialIndex],S=Math.max(g.start,f.start),A=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let x=S,b=A;x<b;x+=3){let w=l.getX(x),y=l.getX(x+1),T=l.getX(x+2);r=io(this,m,e,i,u,h,p,w,y,T),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let _=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=_,m=v;g<m;g+=3){let S=l.getX(g),A=l.getX(g+1),x=l.getX(g+2);r=io(this,o,e,i,u,h,p,S,A,x),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}else if(c!==void 0)if(Array.isArray(o))for(let _=0,v=d.length;_<v;_++){let g=d[_],m=o[g.materialIndex],S=Math.max(g.start,f.start),A=Math.min(c.count,Math.min(g.start+g.count,f.start+f.count));for(let x=S,b=A;x<b;x+=3){let w=x,y=x+1,T=x+2;r=io(this,m,e,i,u,h,p,w,y,T),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let _=Math.max(0,f.start),v=Math.min(c.count,f.start+f.count);for(let g=_,m=v;g<m;g+=3){let S=g,A=g+1,x=g+2;r=io(this,o,e,i,u,h,p,S,A,x),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}}};function Kg(n,e,t,i,r,s,o,l){let c;if(e.side===Ht?c=i.intersectTriangle(o,s,r,!0,l):c=i.intersectTriangle(r,s,o,e.side===fi,l),c===null)return null;no.copy(l),no.applyMatrix4(n.matrixWorld);let u=t.ray.origin.distanceTo(no);return u<t.near||u>t.far?null:{distance:u,point:no.clone(),object:n}}a(Kg,"checkIntersection$1");function io(n,e,t,i,r,s,o,l,c,u){n.getVertexPosition(l,js),n.getVertexPosition(c,Qs),n.getVertexPosition(u,eo);let h=Kg(n,e,t,i,js,Qs,eo,Vh);if(h){let p=new G;ai.getBarycoord(Vh,js,Qs,eo,p),r&&(h.uv=ai.getInterpolatedAttribute(r,l,c,u,p,new Ve)),s&&(h.uv1=ai.getInterpolatedAttribute(s,l,c,u,p,new Ve)),o&&(h.normal=ai.getInterpolatedAttribute(o,l,c,u,p,new G),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a:l,b:c,c:u,normal:new G,materialIndex:0};ai.getNormal(js,Qs,eo,d.normal),h.face=d,h.barycoord=p}return h}a(io,"checkGeometryIntersection");var qr=class extends Ot{static{a(this,"DataTexture")}constructor(e=null,t=1,i=1,r,s,o,l,c,u=Et,h=Et,p,d){super(null,o,l,c,u,h,r,s,p,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Yr=class extends Xt{static{a(this,"InstancedBufferAttribute")}constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},nr=new Qe,Hh=new Qe,ro=[],Wh=new In,jg=new Qe,Lr=new st,Nr=new li,$r=class extends st{static{a(this,"InstancedMesh")}constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Yr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<i;r++)this.setMatrixAt(r,jg)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new In),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,nr),Wh.copy(e.boundingBox).applyMatrix4(nr),this.boundingBox.union(Wh)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new li),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,nr),Nr.copy(e.boundingSphere).applyMatrix4(nr),this.boundingSphere.union(Nr)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=i.length+1,o=e*s+1;for(let l=0;l<i.length;l++)i[l]=r[o+l]}raycast(e,t){let i=this.matrixWorld,r=this.count;if(Lr.geometry=this.geometry,Lr.material=this.material,Lr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Nr.copy(this.boundingSphere),Nr.applyMatrix4(i),e.ray.intersectsSphere(Nr)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,nr),Hh.multiplyMatrices(i,nr),Lr.matrixWorld=Hh,Lr.raycast(e,ro);for(let o=0,l=ro.length;o<l;o++){let c=ro[o];c.instanceId=s,c.object=this,t.push(c)}ro.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Yr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,r=i.length+1;this.morphTexture===null&&(this.morphTexture=new qr(new Float32Array(r*this.count),r,this.count,Ko,dn));let s=this.morphTexture.source.data.data,o=0;for(let u=0;u<i.length;u++)o+=i[u];let l=this.geometry.morphTargetsRelative?1:1-o,c=r*e;return s[c]=l,s.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Pi=new li,Qg=new Ve(.5,.5),so=new G,Ii=class{static{a(this,"Frustum")}constructor(e=new yn,t=new yn,i=new yn,r=new yn,s=new yn,o=new yn){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let l=this.planes;return l[0].copy(e),l[1].copy(t),l[2].copy(i),l[3].copy(r),l[4].copy(s),l[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=un,i=!1){let r=this.planes,s=e.elements,o=s[0],l=s[1],c=s[2],u=s[3],h=s[4],p=s[5],d=s[6],f=s[7],_=s[8],v=s[9],g=s[10],m=s[11],S=s[12],A=s[13],x=s[14],b=s[15];if(r[0].setComponents(u-o,f-h,m-_,b-S).normalize(),r[1].setComponents(u+o,f+h,m+_,b+S).normalize(),r[2].setComponents(u+l,f+p,m+v,b+A).normalize(),r[3].setComponents(u-l,f-p,m-v,b-A).normalize(),i)r[4].setComponents(c,d,g,x).normalize(),r[5].setComponents(u-c,f-d,m-g,b-x).normalize();else if(r[4].setComponents(u-c,f-d,m-g,b-x).normalize(),t===un)r[5].setComponents(u+c,f+d,m+g,b+x).normalize();else if(t===Br)r[5].setComponents(c,d,g,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Pi.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Pi.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Pi)}intersectsSprite(e){Pi.center.set(0,0,0);let t=Qg.distanceTo(e.center);return Pi.radius=.7071067811865476+t,Pi.applyMatrix4(e.matrixWorld),this.intersectsSphere(Pi)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(so.x=r.normal.x>0?e.max.x:e.min.x,so.y=r.normal.y>0?e.max.y:e.min.y,so.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(so)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Xh=new Qe,Ao=class n{static{a(this,"FrustumArray")}constructor(){this.coordinateSystem=un,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];Xh.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new Ii),i[r].setFromProjectionMatrix(Xh,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Ii),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Li=class extends Ot{static{a(this,"CubeTexture")}constructor(e=[],t=Ui,i,r,s,o,l,c,u,h){super(e,t,i,r,s,o,l,c,u,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var xn=class extends Ot{static{a(this,"DepthTexture")}constructor(e,t,i=tn,r,s,o,l=Et,c=Et,u,h=Xn,p=1){if(h!==Xn&&h!==Jn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:p};super(d,r,s,o,l,c,h,i,u),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new cr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Jr=class extends xn{static{a(this,"CubeDepthTexture")}constructor(e,t=tn,i=Ui,r,s,o=Et,l=Et,c,u=Xn){let h={width:e,height:e,depth:1},p=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,l,c,u),this.image=p,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ni=class extends Ot{static{a(this,"ExternalTexture")}constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},dr=class n extends Tt{static{a(this,"BoxGeometry")}constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let l=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let c=[],u=[],h=[],p=[],d=0,f=0;_("z","y","x",-1,-1,i,t,e,o,s,0),_("z","y","x",1,-1,i,t,-e,o,s,1),_("x","z","y",1,1,e,i,t,r,o,2),_("x","z","y",1,-1,e,i,-t,r,o,3),_("x","y","z",1,-1,e,t,i,r,s,4),_("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(c),this.setAttribute("position",new dt(u,3)),this.setAttribute("normal",new dt(h,3)),this.setAttribute("uv",new dt(p,2));function _(v,g,m,S,A,x,b,w,y,T,L){let C=x/y,D=b/T,N=x/2,B=b/2,P=w/2,q=y+1,$=T+1,O=0,j=0,H=new G;for(let Q=0;Q<$;Q++){let te=Q*D-B;for(let ne=0;ne<q;ne++){let he=ne*C-N;H[v]=he*S,H[g]=te*A,H[m]=P,u.push(H.x,H.y,H.z),H[v]=0,H[g]=0,H[m]=w>0?1:-1,h.push(H.x,H.y,H.z),p.push(ne/y),p.push(1-Q/T),O+=1}}for(let Q=0;Q<T;Q++)for(let te=0;te<y;te++){let ne=d+te+q*Q,he=d+te+q*(Q+1),X=d+(te+1)+q*(Q+1),me=d+(te+1)+q*Q;c.push(ne,he,me),c.push(he,X,me),j+=6}l.addGroup(f,j,L),f+=j,d+=O}a(_,"buildPlane")}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},Zr=class n extends Tt{static{a(this,"CapsuleGeometry")}constructor(e=1,t=1,i=4,r=8,s=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:i,radialSegments:r,heightSegments:s},t=Math.max(0,t),i=Math.max(1,Math.floor(i)),r=Math.max(3,Math.floor(r)),s=Math.max(1,Math.floor(s));let o=[],l=[],c=[],u=[],h=t/2,p=Math.PI/2*e,d=t,f=2*p+d,_=i*2+s,v=r+1,g=new G,m=new G;for(let S=0;S<=_;S++){let A=0,x=0,b=0,w=0;if(S<=i){let L=S/i,C=L*Math.PI/2;x=-h-e*Math.cos(C),b=e*Math.sin(C),w=-e*Math.cos(C),A=L*p}else if(S<=i+s){let L=(S-i)/s;x=-h+L*t,b=e,w=0,A=p+L*d}else{let L=(S-i-s)/i,C=L*Math.PI/2;x=h+e*Math.sin(C),b=e*Math.cos(C),w=e*Math.sin(C),A=p+d+L*p}let y=Math.max(0,Math.min(1,A/f)),T=0;S===0?T=.5/r:S===_&&(T=-.5/r);for(let L=0;L<=r;L++){let C=L/r,D=C*Math.PI*2,N=Math.sin(D),B=Math.cos(D);m.x=-b*B,m.y=x,m.z=b*N,l.push(m.x,m.y,m.z),g.set(-b*B,w,b*N),g.normalize(),c.push(g.x,g.y,g.z),u.push(C+T,y)}if(S>0){let L=(S-1)*v;for(let C=0;C<r;C++){let D=L+C,N=L+C+1,B=S*v+C,P=S*v+C+1;o.push(D,N,B),o.push(N,P,B)}}}this.setIndex(o),this.setAttribute("position",new dt(l,3)),this.setAttribute("normal",new dt(c,3)),this.setAttribute("uv",new dt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var Ro=class n extends Tt{static{a(this,"PolyhedronGeometry")}constructor(e=[],t=[],i=1,r=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:i,detail:r};let s=[],o=[];l(r),u(i),h(),this.setAttribute("position",new dt(s,3)),this.setAttribute("normal",new dt(s.slice(),3)),this.setAttribute("uv",new dt(o,2)),r===0?this.computeVertexNormals():this.normalizeNormals();function l(S){let A=new G,x=new G,b=new G;for(let w=0;w<t.length;w+=3)f(t[w+0],A),f(t[w+1],x),f(t[w+2],b),c(A,x,b,S)}a(l,"subdivide");function c(S,A,x,b){let w=b+1,y=[];for(let T=0;T<=w;T++){y[T]=[];let L=S.clone().lerp(x,T/w),C=A.clone().lerp(x,T/w),D=w-T;for(let N=0;N<=D;N++)N===0&&T===w?y[T][N]=L:y[T][N]=L.clone().lerp(C,N/D)}for(let T=0;T<w;T++)for(let L=0;L<2*(w-T)-1;L++){let C=Math.floor(L/2);L%2===0?(d(y[T][C+1]),d(y[T+1][C]),d(y[T][C])):(d(y[T][C+1]),d(y[T+1][C+1]),d(y[T+1][C]))}}a(c,"subdivideFace");function u(S){let A=new G;for(let x=0;x<s.length;x+=3)A.x=s[x+0],A.y=s[x+1],A.z=s[x+2],A.normalize().multiplyScalar(S),s[x+0]=A.x,s[x+1]=A.y,s[x+2]=A.z}a(u,"applyRadius");function h(){let S=new G;for(let A=0;A<s.length;A+=3){S.x=s[A+0],S.y=s[A+1],S.z=s[A+2];let x=g(S)/2/Math.PI+.5,b=m(S)/Math.PI+.5;o.push(x,1-b)}_(),p()}a(h,"generateUVs");function p(){for(let S=0;S<o.length;S+=6){let A=o[S+0],x=o[S+2],b=o[S+4],w=Math.max(A,x,b),y=Math.min(A,x,b);w>.9&&y<.1&&(A<.2&&(o[S+0]+=1),x<.2&&(o[S+2]+=1),b<.2&&(o[S+4]+=1))}}a(p,"correctSeam");function d(S){s.push(S.x,S.y,S.z)}a(d,"pushVertex");function f(S,A){let x=S*3;A.x=e[x+0],A.y=e[x+1],A.z=e[x+2]}a(f,"getVertexByIndex");function _(){let S=new G,A=new G,x=new G,b=new G,w=new Ve,y=new Ve,T=new Ve;for(let L=0,C=0;L<s.length;L+=9,C+=6){S.set(s[L+0],s[L+1],s[L+2]),A.set(s[L+3],s[L+4],s[L+5]),x.set(s[L+6],s[L+7],s[L+8]),w.set(o[C+0],o[C+1]),y.set(o[C+2],o[C+3]),T.set(o[C+4],o[C+5]),b.copy(S).add(A).add(x).divideScalar(3);let D=g(b);v(w,C+0,S,D),v(y,C+2,A,D),v(T,C+4,x,D)}}a(_,"correctUVs");function v(S,A,x,b){b<0&&S.x===1&&(o[A]=S.x-1),x.x===0&&x.z===0&&(o[A]=b/2/Math.PI+.5)}a(v,"correctUV");function g(S){return Math.atan2(S.z,-S.x)}a(g,"azimuth");function m(S){return Math.atan2(-S.y,Math.sqrt(S.x*S.x+S.z*S.z))}a(m,"inclination")}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.vertices,e.indices,e.radius,e.detail)}};var Kr=class n extends Ro{static{a(this,"IcosahedronGeometry")}constructor(e=1,t=0){let i=(1+Math.sqrt(5))/2,r=[-1,i,0,1,i,0,-1,-i,0,1,-i,0,0,-1,i,0,1,i,0,-1,-i,0,1,-i,i,0,-1,i,0,1,-i,0,-1,-i,0,1],s=[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1];super(r,s,e,t),this.type="IcosahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new n(e.radius,e.detail)}};var jr=class n extends Tt{static{a(this,"PlaneGeometry")}constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,l=Math.floor(i),c=Math.floor(r),u=l+1,h=c+1,p=e/l,d=t/c,f=[],_=[],v=[],g=[];for(let m=0;m<h;m++){let S=m*d-o;for(let A=0;A<u;A++){let x=A*p-s;_.push(x,-S,0),v.push(0,0,1),g.push(A/l),g.push(1-m/c)}}for(let m=0;m<c;m++)for(let S=0;S<l;S++){let A=S+u*m,x=S+u*(m+1),b=S+1+u*(m+1),w=S+1+u*m;f.push(A,x,w),f.push(x,b,w)}this.setIndex(f),this.setAttribute("position",new dt(_,3)),this.setAttribute("normal",new dt(v,3)),this.setAttribute("uv",new dt(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}},Qr=class n extends Tt{static{a(this,"RingGeometry")}constructor(e=.5,t=1,i=32,r=1,s=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:i,phiSegments:r,thetaStart:s,thetaLength:o},i=Math.max(3,i),r=Math.max(1,r);let l=[],c=[],u=[],h=[],p=e,d=(t-e)/r,f=new G,_=new Ve;for(let v=0;v<=r;v++){for(let g=0;g<=i;g++){let m=s+g/i*o;f.x=p*Math.cos(m),f.y=p*Math.sin(m),c.push(f.x,f.y,f.z),u.push(0,0,1),_.x=(f.x/t+1)/2,_.y=(f.y/t+1)/2,h.push(_.x,_.y)}p+=d}for(let v=0;v<r;v++){let g=v*(i+1);for(let m=0;m<i;m++){let S=m+g,A=S,x=S+i+1,b=S+i+2,w=S+1;l.push(A,x,w),l.push(x,b,w)}}this.setIndex(l),this.setAttribute("position",new dt(c,3)),this.setAttribute("normal",new dt(u,3)),this.setAttribute("uv",new dt(h,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};function Fi(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(qh(r))r.isRenderTargetTexture?(Le("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(qh(r[0])){let s=[];for(let o=0,l=r.length;o<l;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}a(Fi,"cloneUniforms");function Bt(n){let e={};for(let t=0;t<n.length;t++){let i=Fi(n[t]);for(let r in i)e[r]=i[r]}return e}a(Bt,"mergeUniforms");function qh(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}a(qh,"isThreeObject");function e0(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}a(e0,"cloneUniformsGroups");function Mc(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:qe.workingColorSpace}a(Mc,"getUnlitUniformColorSpace");var Od={clone:Fi,merge:Bt},t0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,n0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ln=class extends ci{static{a(this,"ShaderMaterial")}constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=t0,this.fragmentShader=n0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Fi(e.uniforms),this.uniformsGroups=e0(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new ze().setHex(r.value);break;case"v2":this.uniforms[i].value=new Ve().fromArray(r.value);break;case"v3":this.uniforms[i].value=new G().fromArray(r.value);break;case"v4":this.uniforms[i].value=new nt().fromArray(r.value);break;case"m3":this.uniforms[i].value=new Ue().fromArray(r.value);break;case"m4":this.uniforms[i].value=new Qe().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},vn=class extends Ln{static{a(this,"RawShaderMaterial")}constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var es=class extends ci{static{a(this,"MeshLambertMaterial")}constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ze(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ze(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ia,this.normalScale=new Ve(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new qn,this.combine=Wo,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Co=class extends ci{static{a(this,"MeshDepthMaterial")}constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=xd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Po=class extends ci{static{a(this,"MeshDistanceMaterial")}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ir(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}a(ir,"convertArray");function oo(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}a(oo,"hasTangents");var ui=class{static{a(this,"Interpolant")}constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],s=t[i-1];n:{e:{let o;t:{i:if(!(e<r)){for(let l=i+2;;){if(r===void 0){if(e<s)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===l)break;if(s=r,r=t[++i],e<r)break e}o=t.length;break t}if(!(e>=s)){let l=t[1];e<l&&(i=2,s=l);for(let c=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(r=s,s=t[--i-1],e>=s)break e}o=i,i=0;break t}break n}for(;i<o;){let l=i+o>>>1;e<t[l]?o=l:i=l+1}if(r=t[i],s=t[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=i[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Io=class extends ui{static{a(this,"CubicInterpolant")}constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Kl,endingEnd:Kl}}intervalChanged_(e,t,i){let r=this.parameterPositions,s=e-2,o=e+1,l=r[s],c=r[o];if(l===void 0)switch(this.getSettings_().endingStart){case jl:s=e,l=2*t-i;break;case Ql:s=r.length-2,l=t+r[s]-r[s+1];break;default:s=e,l=i}if(c===void 0)switch(this.getSettings_().endingEnd){case jl:o=e,c=2*i-t;break;case Ql:o=1,c=i+r[1]-r[0];break;default:o=e-1,c=t}let u=(i-t)*.5,h=this.valueSize;this._weightPrev=u/(t-l),this._weightNext=u/(c-i),this._offsetPrev=s*h,this._offsetNext=o*h}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=e*l,u=c-l,h=this._offsetPrev,p=this._offsetNext,d=this._weightPrev,f=this._weightNext,_=(i-t)/(r-t),v=_*_,g=v*_,m=-d*g+2*d*v-d*_,S=(1+d)*g+(-1.5-2*d)*v+(-.5+d)*_+1,A=(-1-f)*g+(1.5+f)*v+.5*_,x=f*g-f*v;for(let b=0;b!==l;++b)s[b]=m*o[h+b]+S*o[u+b]+A*o[c+b]+x*o[p+b];return s}},Lo=class extends ui{static{a(this,"LinearInterpolant")}constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=e*l,u=c-l,h=(i-t)/(r-t),p=1-h;for(let d=0;d!==l;++d)s[d]=o[u+d]*p+o[c+d]*h;return s}},No=class extends ui{static{a(this,"DiscreteInterpolant")}constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Do=class extends ui{static{a(this,"BezierInterpolant")}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=e*l,u=c-l,h=this.inTangents,p=this.outTangents;if(!h||!p){let _=(i-t)/(r-t),v=1-_;for(let g=0;g!==l;++g)s[g]=o[u+g]*v+o[c+g]*_;return s}let d=l*2,f=e-1;for(let _=0;_!==l;++_){let v=o[u+_],g=o[c+_],m=f*d+_*2,S=p[m],A=p[m+1],x=e*d+_*2,b=h[x],w=h[x+1],y=r0(i,t,S,b,r);s[_]=Fd(y,v,A,w,g)}return s}};function Fd(n,e,t,i,r){let s=1-n;return s*s*s*e+3*s*s*n*t+3*s*n*n*i+n*n*n*r}a(Fd,"cubicBezier");function i0(n,e,t,i,r){let s=1-n;return 3*s*s*(t-e)+6*s*n*(i-t)+3*n*n*(r-i)}a(i0,"cubicBezierSlope");function r0(n,e,t,i,r){let s=(n-e)/(r-e);for(let o=0;o<8;o++){let l=Fd(s,e,t,i,r)-n;if(Math.abs(l)<1e-10)break;let c=i0(s,e,t,i,r);if(Math.abs(c)<1e-10)break;s=Math.max(0,Math.min(1,s-l/c))}return s}a(r0,"solveBezierParameter");var Qt=class{static{a(this,"KeyframeTrack")}constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ir(t,this.TimeBufferType),this.values=ir(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:ir(e.times,Array),values:ir(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),oo(e.settings)&&(i.settings={inTangents:ir(e.settings.inTangents,Array),outTangents:ir(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new No(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Lo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Io(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Do(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ur:t=this.InterpolantFactoryMethodDiscrete;break;case bo:t=this.InterpolantFactoryMethodLinear;break;case co:t=this.InterpolantFactoryMethodSmooth;break;case Zl:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Le("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ur;case this.InterpolantFactoryMethodLinear:return bo;case this.InterpolantFactoryMethodSmooth:return co;case this.InterpolantFactoryMethodBezier:return Zl}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;oo(this.settings)&&(Yh(this.settings.inTangents,e),Yh(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;oo(this.settings)&&($h(this.settings.inTangents,e),$h(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<e;)++s;for(;o!==-1&&i[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let l=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*l,o*l)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(De("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,s=i.length;s===0&&(De("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let l=0;l!==s;l++){let c=i[l];if(typeof c=="number"&&isNaN(c)){De("KeyframeTrack: Time is not a valid number.",this,l,c),e=!1;break}if(o!==null&&o>c){De("KeyframeTrack: Out of order keys.",this,l,c,o),e=!1;break}o=c}if(r!==void 0&&Ng(r))for(let l=0,c=r.length;l!==c;++l){let u=r[l];if(isNaN(u)){De("KeyframeTrack: Value is not a valid number.",this,l,u),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===co,s=e.length-1,o=1;for(let l=1;l<s;++l){let c=!1,u=e[l],h=e[l+1];if(u!==h&&(l!==1||u!==e[0]))if(r)c=!0;else{let p=l*i,d=p-i,f=p+i;for(let _=0;_!==i;++_){let v=t[p+_];if(v!==t[d+_]||v!==t[f+_]){c=!0;break}}}if(c){if(l!==o){e[o]=e[l];let p=l*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[p+f]}++o}}if(s>0){e[o]=e[s];for(let l=s*i,c=o*i,u=0;u!==i;++u)t[c+u]=t[l+u];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,oo(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Yh(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}a(Yh,"shiftTangentTimes");function $h(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}a($h,"scaleTangentTimes");Qt.prototype.ValueTypeName="";Qt.prototype.TimeBufferType=Float32Array;Qt.prototype.ValueBufferType=Float32Array;Qt.prototype.DefaultInterpolation=bo;var hi=class extends Qt{static{a(this,"BooleanKeyframeTrack")}constructor(e,t,i){super(e,t,i)}};hi.prototype.ValueTypeName="bool";hi.prototype.ValueBufferType=Array;hi.prototype.DefaultInterpolation=Ur;hi.prototype.InterpolantFactoryMethodLinear=void 0;hi.prototype.InterpolantFactoryMethodSmooth=void 0;var Uo=class extends Qt{static{a(this,"ColorKeyframeTrack")}constructor(e,t,i,r){super(e,t,i,r)}};Uo.prototype.ValueTypeName="color";var Oo=class extends Qt{static{a(this,"NumberKeyframeTrack")}constructor(e,t,i,r){super(e,t,i,r)}};Oo.prototype.ValueTypeName="number";var Fo=class extends ui{static{a(this,"QuaternionLinearInterpolant")}constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=(i-t)/(r-t),u=e*l;for(let h=u+l;u!==h;u+=4)Pn.slerpFlat(s,0,o,u-l,o,u,c);return s}},ts=class extends Qt{static{a(this,"QuaternionKeyframeTrack")}constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new Fo(this.times,this.values,this.getValueSize(),e)}};ts.prototype.ValueTypeName="quaternion";ts.prototype.InterpolantFactoryMethodSmooth=void 0;var di=class extends Qt{static{a(this,"StringKeyframeTrack")}constructor(e,t,i){super(e,t,i)}};di.prototype.ValueTypeName="string";di.prototype.ValueBufferType=Array;di.prototype.DefaultInterpolation=Ur;di.prototype.InterpolantFactoryMethodLinear=void 0;di.prototype.InterpolantFactoryMethodSmooth=void 0;var Bo=class extends Qt{static{a(this,"VectorKeyframeTrack")}constructor(e,t,i,r){super(e,t,i,r)}};Bo.prototype.ValueTypeName="vector";var ko=class{static{a(this,"LoadingManager")}constructor(e,t,i){let r=this,s=!1,o=0,l=0,c,u=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){l++,s===!1&&r.onStart!==void 0&&r.onStart(h,o,l),s=!0},this.itemEnd=function(h){o++,r.onProgress!==void 0&&r.onProgress(h,o,l),o===l&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,p){return u.push(h,p),this},this.removeHandler=function(h){let p=u.indexOf(h);return p!==-1&&u.splice(p,2),this},this.getHandler=function(h){for(let p=0,d=u.length;p<d;p+=2){let f=u[p],_=u[p+1];if(f.global&&(f.lastIndex=0),f.test(h))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Bd=new ko,zo=class{static{a(this,"Loader")}constructor(e){this.manager=e!==void 0?e:Bd,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,s){i.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};zo.DEFAULT_MATERIAL_NAME="__DEFAULT";var Go=class extends qt{static{a(this,"Light")}static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ze(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ns=class extends Go{static{a(this,"HemisphereLight")}constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(qt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ze(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var ao=new G,lo=new Pn,An=new G,is=class extends qt{static{a(this,"Camera")}constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qe,this.projectionMatrix=new Qe,this.projectionMatrixInverse=new Qe,this.coordinateSystem=un,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ao,lo,An),An.x===1&&An.y===1&&An.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ao,lo,An.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(ao,lo,An),An.x===1&&An.y===1&&An.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ao,lo,An.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},oi=new G,Jh=new Ve,Zh=new Ve,Gt=class extends is{static{a(this,"PerspectiveCamera")}constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=So*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Cl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return So*2*Math.atan(Math.tan(Cl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){oi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(oi.x,oi.y).multiplyScalar(-e/oi.z),oi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(oi.x,oi.y).multiplyScalar(-e/oi.z)}getViewSize(e,t){return this.getViewBounds(e,Jh,Zh),t.subVectors(Zh,Jh)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Cl*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,u=o.fullHeight;s+=o.offsetX*r/c,t-=o.offsetY*i/u,r*=o.width/c,i*=o.height/u}let l=this.filmOffset;l!==0&&(s+=e*l/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Vo=class extends is{static{a(this,"OrthographicCamera")}constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,l=r+t,c=r-t;if(this.view!==null&&this.view.enabled){let u=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=u*this.view.offsetX,o=s+u*this.view.width,l-=h*this.view.offsetY,c=l-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,l,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var rs=class extends Tt{static{a(this,"InstancedBufferGeometry")}constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var rr=-90,sr=1,fr=class extends qt{static{a(this,"CubeCamera")}constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Gt(rr,sr,e,t);r.layers=this.layers,this.add(r);let s=new Gt(rr,sr,e,t);s.layers=this.layers,this.add(s);let o=new Gt(rr,sr,e,t);o.layers=this.layers,this.add(o);let l=new Gt(rr,sr,e,t);l.layers=this.layers,this.add(l);let c=new Gt(rr,sr,e,t);c.layers=this.layers,this.add(c);let u=new Gt(rr,sr,e,t);u.layers=this.layers,this.add(u)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,l,c]=t;for(let u of t)this.remove(u);if(e===un)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),l.up.set(0,1,0),l.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Br)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),l.up.set(0,-1,0),l.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let u of t)this.add(u),u.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,l,c,u,h]=this.children,p=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,3,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(i,4,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(p,d,f),e.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},Ho=class extends Gt{static{a(this,"ArrayCamera")}constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var wc="\\[\\]\\.:\\/",s0=new RegExp("["+wc+"]","g"),Ec="[^"+wc+"]",o0="[^"+wc.replace("\\.","")+"]",a0=/((?:WC+[\/:])*)/.source.replace("WC",Ec),l0=/(WCOD+)?/.source.replace("WCOD",o0),c0=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ec),u0=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ec),h0=new RegExp("^"+a0+l0+c0+u0+"$"),d0=["material","materials","bones","map"],ec=class{static{a(this,"Composite")}constructor(e,t,i){let r=i||rt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},rt=class n{static{a(this,"PropertyBinding")}constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(s0,"")}static parseTrackName(e){let t=h0.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);d0.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=a(function(s){for(let o=0;o<s.length;o++){let l=s[o];if(l.name===t||l.uuid===t)return l;let c=i(l.children);if(c)return c}return null},"searchNodeSubtree"),r=i(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)e[t++]=i[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Le("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let u=t.objectIndex;switch(i){case"materials":if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){De("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){De("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===u){u=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){De("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){De("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(u!==void 0){if(e[u]===void 0){De("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[u]}}let o=e[r];if(o===void 0){let u=t.nodeName;De("PropertyBinding: Trying to update property for track: "+u+"."+r+" but it wasn't found.",e);return}let l=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?l=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(l=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][l]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};rt.Composite=ec;rt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};rt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};rt.prototype.GetterByBindingType=[rt.prototype._getValue_direct,rt.prototype._getValue_array,rt.prototype._getValue_arrayElement,rt.prototype._getValue_toArray];rt.prototype.SetterByBindingTypeAndVersioning=[[rt.prototype._setValue_direct,rt.prototype._setValue_direct_setNeedsUpdate,rt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[rt.prototype._setValue_array,rt.prototype._setValue_array_setNeedsUpdate,rt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[rt.prototype._setValue_arrayElement,rt.prototype._setValue_arrayElement_setNeedsUpdate,rt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[rt.prototype._setValue_fromArray,rt.prototype._setValue_fromArray_setNeedsUpdate,rt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Kw=new Float32Array(1);var ss=class{static{a(this,"GLBufferAttribute")}constructor(e,t,i,r,s,o=!1){this.isGLBufferAttribute=!0,this.name="",this.buffer=e,this.type=t,this.itemSize=i,this.elementSize=r,this.count=s,this.normalized=o,this.version=0}set needsUpdate(e){e===!0&&this.version++}setBuffer(e){return this.buffer=e,this}setType(e,t){return this.type=e,this.elementSize=t,this}setItemSize(e){return this.itemSize=e,this}setCount(e){return this.count=e,this}};var tc=class{static{a(this,"Matrix2")}static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=r,this}};function Tc(n,e,t,i){let r=f0(i);switch(t){case yc:return n*e;case Ko:return n*e/r.components*r.byteLength;case jo:return n*e/r.components*r.byteLength;case mi:return n*e*2/r.components*r.byteLength;case Qo:return n*e*2/r.components*r.byteLength;case xc:return n*e*3/r.components*r.byteLength;case Sn:return n*e*4/r.components*r.byteLength;case ea:return n*e*4/r.components*r.byteLength;case cs:case us:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case hs:case ds:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case na:case ra:return Math.max(n,16)*Math.max(e,8)/4;case ta:case ia:return Math.max(n,8)*Math.max(e,8)/2;case sa:case oa:case la:case ca:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case aa:case fs:case ua:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ha:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case da:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case fa:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case pa:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ma:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case ga:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case _a:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case ya:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case xa:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case va:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case ba:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Sa:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Ma:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case wa:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Ea:case Ta:case Aa:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Ra:case Ca:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ps:case Pa:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}a(Tc,"getByteLength");function f0(n){switch(n){case en:case pc:return{byteLength:1,components:1};case xr:case mc:case bn:return{byteLength:2,components:1};case Jo:case Zo:return{byteLength:2,components:4};case tn:case $o:case dn:return{byteLength:4,components:1};case gc:case _c:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}a(f0,"getTextureTypeByteLength");typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Le("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function af(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return a(r,"onAnimationFrame"),{start:a(function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},"start"),stop:a(function(){n!==null&&n.cancelAnimationFrame(i),e=!1},"stop"),setAnimationLoop:a(function(s){t=s},"setAnimationLoop"),setContext:a(function(s){n=s},"setContext")}}a(af,"WebGLAnimation");function m0(n){let e=new WeakMap;function t(l,c){let u=l.array,h=l.usage,p=u.byteLength,d=n.createBuffer();n.bindBuffer(c,d),n.bufferData(c,u,h),l.onUploadCallback();let f;if(u instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&u instanceof Float16Array)f=n.HALF_FLOAT;else if(u instanceof Uint16Array)l.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(u instanceof Int16Array)f=n.SHORT;else if(u instanceof Uint32Array)f=n.UNSIGNED_INT;else if(u instanceof Int32Array)f=n.INT;else if(u instanceof Int8Array)f=n.BYTE;else if(u instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(u instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+u);return{buffer:d,type:f,bytesPerElement:u.BYTES_PER_ELEMENT,version:l.version,size:p}}a(t,"createBuffer");function i(l,c,u){let h=c.array,p=c.updateRanges;if(n.bindBuffer(u,l),p.length===0)n.bufferSubData(u,0,h);else{p.sort((f,_)=>f.start-_.start);let d=0;for(let f=1;f<p.length;f++){let _=p[d],v=p[f];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++d,p[d]=v)}p.length=d+1;for(let f=0,_=p.length;f<_;f++){let v=p[f];n.bufferSubData(u,v.start*h.BYTES_PER_ELEMENT,h,v.start,v.count)}c.clearUpdateRanges()}c.onUploadCallback()}a(i,"updateBuffer");function r(l){return l.isInterleavedBufferAttribute&&(l=l.data),e.get(l)}a(r,"get");function s(l){l.isInterleavedBufferAttribute&&(l=l.data);let c=e.get(l);c&&(n.deleteBuffer(c.buffer),e.delete(l))}a(s,"remove");function o(l,c){if(l.isInterleavedBufferAttribute&&(l=l.data),l.isGLBufferAttribute){let h=e.get(l);(!h||h.version<l.version)&&e.set(l,{buffer:l.buffer,type:l.type,bytesPerElement:l.elementSize,version:l.version});return}let u=e.get(l);if(u===void 0)e.set(l,t(l,c));else if(u.version<l.version){if(u.size!==l.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(u.buffer,l,c),u.version=l.version}}return a(o,"update"),{get:r,remove:s,update:o}}a(m0,"WebGLAttributes");var g0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_0=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,y0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,x0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,v0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,b0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,S0=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,M0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,w0=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,E0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,T0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,A0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,R0=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,C0=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,P0=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,I0=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,L0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,N0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,D0=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,U0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,O0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,F0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,B0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,k0=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,z0=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,G0=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,V0=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,H0=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,W0=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,X0="gl_FragColor = linearToOutputTexel( gl_FragColor );",q0=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Y0=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,$0=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,J0=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Z0=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,K0=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,j0=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Q0=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,e_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,t_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,n_=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,i_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,r_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,s_=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,o_=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,a_=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,l_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,c_=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,u_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,h_=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,d_=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,f_=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,p_=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,m_=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,g_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,__=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,y_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,x_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,v_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,b_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,S_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,M_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,w_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,E_=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,T_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,A_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,R_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,C_=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,P_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,I_=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,L_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,N_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,D_=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,U_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,O_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,F_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,B_=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,k_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,z_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,G_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,V_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,H_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,W_=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,X_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,q_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Y_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,$_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,J_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Z_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,K_=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,j_=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Q_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,ey=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,ty=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ny=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,iy=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ry=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,sy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,oy=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ay=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ly=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,cy=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,uy=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,hy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,dy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,fy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,py=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,my=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gy=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_y=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,yy=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,by=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Sy=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,My=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,wy=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Ey=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ty=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ay=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Ry=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Cy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Py=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Iy=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ly=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ny=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Dy=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Uy=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Oy=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Fy=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,By=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ky=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,zy=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Gy=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Vy=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Hy=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Wy=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Xy=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,qy=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Yy=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,$y=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Ge={alphahash_fragment:g0,alphahash_pars_fragment:_0,alphamap_fragment:y0,alphamap_pars_fragment:x0,alphatest_fragment:v0,alphatest_pars_fragment:b0,aomap_fragment:S0,aomap_pars_fragment:M0,batching_pars_vertex:w0,batching_vertex:E0,begin_vertex:T0,beginnormal_vertex:A0,bsdfs:R0,iridescence_fragment:C0,bumpmap_pars_fragment:P0,clipping_planes_fragment:I0,clipping_planes_pars_fragment:L0,clipping_planes_pars_vertex:N0,clipping_planes_vertex:D0,color_fragment:U0,color_pars_fragment:O0,color_pars_vertex:F0,color_vertex:B0,common:k0,defaultnormal_vertex:z0,displacementmap_pars_vertex:G0,displacementmap_vertex:V0,emissivemap_fragment:H0,emissivemap_pars_fragment:W0,colorspace_fragment:X0,colorspace_pars_fragment:q0,envmap_fragment:Y0,envmap_common_pars_fragment:$0,envmap_pars_fragment:J0,envmap_pars_vertex:Z0,envmap_physical_pars_fragment:a_,envmap_vertex:K0,fog_vertex:j0,fog_pars_vertex:Q0,fog_fragment:e_,fog_pars_fragment:t_,gradientmap_pars_fragment:n_,lightmap_pars_fragment:i_,lights_lambert_fragment:r_,lights_lambert_pars_fragment:s_,lights_pars_begin:o_,lights_toon_fragment:l_,lights_toon_pars_fragment:c_,lights_phong_fragment:u_,lights_phong_pars_fragment:h_,lights_physical_fragment:d_,lights_physical_pars_fragment:f_,lights_fragment_begin:p_,lights_fragment_maps:m_,lights_fragment_end:g_,lightprobes_pars_fragment:__,logdepthbuf_fragment:y_,logdepthbuf_pars_fragment:x_,logdepthbuf_pars_vertex:v_,logdepthbuf_vertex:b_,map_fragment:S_,map_pars_fragment:M_,map_particle_fragment:w_,map_particle_pars_fragment:E_,metalnessmap_fragment:T_,metalnessmap_pars_fragment:A_,morphinstance_vertex:R_,morphcolor_vertex:C_,morphnormal_vertex:P_,morphtarget_pars_vertex:I_,morphtarget_vertex:L_,normal_fragment_begin:N_,normal_fragment_maps:D_,normal_pars_fragment:U_,normal_pars_vertex:O_,normal_vertex:F_,normalmap_pars_fragment:B_,clearcoat_normal_fragment_begin:k_,clearcoat_normal_fragment_maps:z_,clearcoat_pars_fragment:G_,iridescence_pars_fragment:V_,opaque_fragment:H_,packing:W_,premultiplied_alpha_fragment:X_,project_vertex:q_,dithering_fragment:Y_,dithering_pars_fragment:$_,roughnessmap_fragment:J_,roughnessmap_pars_fragment:Z_,shadowmap_pars_fragment:K_,shadowmap_pars_vertex:j_,shadowmap_vertex:Q_,shadowmask_pars_fragment:ey,skinbase_vertex:ty,skinning_pars_vertex:ny,skinning_vertex:iy,skinnormal_vertex:ry,specularmap_fragment:sy,specularmap_pars_fragment:oy,tonemapping_fragment:ay,tonemapping_pars_fragment:ly,transmission_fragment:cy,transmission_pars_fragment:uy,uv_pars_fragment:hy,uv_pars_vertex:dy,uv_vertex:fy,worldpos_vertex:py,background_vert:my,background_frag:gy,backgroundCube_vert:_y,backgroundCube_frag:yy,cube_vert:xy,cube_frag:vy,depth_vert:by,depth_frag:Sy,distance_vert:My,distance_frag:wy,equirect_vert:Ey,equirect_frag:Ty,linedashed_vert:Ay,linedashed_frag:Ry,meshbasic_vert:Cy,meshbasic_frag:Py,meshlambert_vert:Iy,meshlambert_frag:Ly,meshmatcap_vert:Ny,meshmatcap_frag:Dy,meshnormal_vert:Uy,meshnormal_frag:Oy,meshphong_vert:Fy,meshphong_frag:By,meshphysical_vert:ky,meshphysical_frag:zy,meshtoon_vert:Gy,meshtoon_frag:Vy,points_vert:Hy,points_frag:Wy,shadow_vert:Xy,shadow_frag:qy,sprite_vert:Yy,sprite_frag:$y},ye={common:{diffuse:{value:new ze(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ue},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ue}},envmap:{envMap:{value:null},envMapRotation:{value:new Ue},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ue}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ue}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ue},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ue},normalScale:{value:new Ve(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ue},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ue}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ue}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ue}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ze(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ze(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0},uvTransform:{value:new Ue}},sprite:{diffuse:{value:new ze(16777215)},opacity:{value:1},center:{value:new Ve(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ue},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0}}},Un={basic:{uniforms:Bt([ye.common,ye.specularmap,ye.envmap,ye.aomap,ye.lightmap,ye.fog]),vertexShader:Ge.meshbasic_vert,fragmentShader:Ge.meshbasic_frag},lambert:{uniforms:Bt([ye.common,ye.specularmap,ye.envmap,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.fog,ye.lights,{emissive:{value:new ze(0)},envMapIntensity:{value:1}}]),vertexShader:Ge.meshlambert_vert,fragmentShader:Ge.meshlambert_frag},phong:{uniforms:Bt([ye.common,ye.specularmap,ye.envmap,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.fog,ye.lights,{emissive:{value:new ze(0)},specular:{value:new ze(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ge.meshphong_vert,fragmentShader:Ge.meshphong_frag},standard:{uniforms:Bt([ye.common,ye.envmap,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.roughnessmap,ye.metalnessmap,ye.fog,ye.lights,{emissive:{value:new ze(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ge.meshphysical_vert,fragmentShader:Ge.meshphysical_frag},toon:{uniforms:Bt([ye.common,ye.aomap,ye.lightmap,ye.emissivemap,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.gradientmap,ye.fog,ye.lights,{emissive:{value:new ze(0)}}]),vertexShader:Ge.meshtoon_vert,fragmentShader:Ge.meshtoon_frag},matcap:{uniforms:Bt([ye.common,ye.bumpmap,ye.normalmap,ye.displacementmap,ye.fog,{matcap:{value:null}}]),vertexShader:Ge.meshmatcap_vert,fragmentShader:Ge.meshmatcap_frag},points:{uniforms:Bt([ye.points,ye.fog]),vertexShader:Ge.points_vert,fragmentShader:Ge.points_frag},dashed:{uniforms:Bt([ye.common,ye.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ge.linedashed_vert,fragmentShader:Ge.linedashed_frag},depth:{uniforms:Bt([ye.common,ye.displacementmap]),vertexShader:Ge.depth_vert,fragmentShader:Ge.depth_frag},normal:{uniforms:Bt([ye.common,ye.bumpmap,ye.normalmap,ye.displacementmap,{opacity:{value:1}}]),vertexShader:Ge.meshnormal_vert,fragmentShader:Ge.meshnormal_frag},sprite:{uniforms:Bt([ye.sprite,ye.fog]),vertexShader:Ge.sprite_vert,fragmentShader:Ge.sprite_frag},background:{uniforms:{uvTransform:{value:new Ue},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ge.background_vert,fragmentShader:Ge.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ue}},vertexShader:Ge.backgroundCube_vert,fragmentShader:Ge.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ge.cube_vert,fragmentShader:Ge.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ge.equirect_vert,fragmentShader:Ge.equirect_frag},distance:{uniforms:Bt([ye.common,ye.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ge.distance_vert,fragmentShader:Ge.distance_frag},shadow:{uniforms:Bt([ye.lights,ye.fog,{color:{value:new ze(0)},opacity:{value:1}}]),vertexShader:Ge.shadow_vert,fragmentShader:Ge.shadow_frag}};Un.physical={uniforms:Bt([Un.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ue},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ue},clearcoatNormalScale:{value:new Ve(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ue},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ue},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ue},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ue},sheen:{value:0},sheenColor:{value:new ze(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ue},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ue},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ue},transmissionSamplerSize:{value:new Ve},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ue},attenuationDistance:{value:0},attenuationColor:{value:new ze(0)},specularColor:{value:new ze(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ue},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ue},anisotropyVector:{value:new Ve},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ue}}]),vertexShader:Ge.meshphysical_vert,fragmentShader:Ge.meshphysical_frag};var Na={r:0,b:0,g:0},Jy=new Qe,lf=new Ue;lf.set(-1,0,0,0,1,0,0,0,1);function Zy(n,e,t,i,r,s){let o=new ze(0),l=r===!0?0:1,c,u,h=null,p=0,d=null;function f(S){let A=S.isScene===!0?S.background:null;if(A&&A.isTexture){let x=S.backgroundBlurriness>0;A=e.get(A,x)}return A}a(f,"getBackground");function _(S){let A=!1,x=f(S);x===null?g(o,l):x&&x.isColor&&(g(x,1),A=!0);let b=n.xr.getEnvironmentBlendMode();b==="additive"?t.buffers.color.setClear(0,0,0,1,s):b==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}a(_,"render");function v(S,A){let x=f(A);x&&x.isCubeTexture?(u===void 0&&(u=new st(new dr(1,1,1),new Ln({name:"BackgroundCubeMaterial",uniforms:Fi(Un.backgroundCube.uniforms),vertexShader:Un.backgroundCube.vertexShader,fragmentShader:Un.backgroundCube.fragmentShader,side:Ht,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(b,w,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:a(function(){return this.uniforms.envMap.value},"get")}),i.update(u)),u.material.uniforms.envMap.value=x,u.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(Jy.makeRotationFromEuler(A.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&u.material.uniforms.backgroundRotation.value.premultiply(lf),u.material.toneMapped=qe.getTransfer(x.colorSpace)!==Ze,(h!==x||p!==x.version||d!==n.toneMapping)&&(u.material.needsUpdate=!0,h=x,p=x.version,d=n.toneMapping),u.layers.enableAll(),S.unshift(u,u.geometry,u.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new st(new jr(2,2),new Ln({name:"BackgroundMaterial",uniforms:Fi(Un.background.uniforms),vertexShader:Un.background.vertexShader,fragmentShader:Un.background.fragmentShader,side:fi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:a(function(){return this.uniforms.t2D.value},"get")}),i.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=qe.getTransfer(x.colorSpace)!==Ze,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(h!==x||p!==x.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=x,p=x.version,d=n.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}a(v,"addToRenderList");function g(S,A){S.getRGB(Na,Mc(n)),t.buffers.color.setClear(Na.r,Na.g,Na.b,A,s)}a(g,"setClear");function m(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return a(m,"dispose"),{getClearColor:a(function(){return o},"getClearColor"),setClearColor:a(function(S,A=1){o.set(S),l=A,g(o,l)},"setClearColor"),getClearAlpha:a(function(){return l},"getClearAlpha"),setClearAlpha:a(function(S){l=S,g(o,l)},"setClearAlpha"),render:_,addToRenderList:v,dispose:m}}a(Zy,"WebGLBackground");function Ky(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=d(null),s=r,o=!1;function l(D,N,B,P,q){let $=!1,O=p(D,P,B,N);s!==O&&(s=O,u(s.object)),$=f(D,P,B,q),$&&_(D,P,B,q),q!==null&&e.update(q,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,x(D,N,B,P),q!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(q).buffer))}a(l,"setup");function c(){return n.createVertexArray()}a(c,"createVertexArrayObject");function u(D){return n.bindVertexArray(D)}a(u,"bindVertexArrayObject");function h(D){return n.deleteVertexArray(D)}a(h,"deleteVertexArrayObject");function p(D,N,B,P){let q=P.wireframe===!0,$=i[N.id];$===void 0&&($={},i[N.id]=$);let O=D.isInstancedMesh===!0?D.id:0,j=$[O];j===void 0&&(j={},$[O]=j);let H=j[B.id];H===void 0&&(H={},j[B.id]=H);let Q=H[q];return Q===void 0&&(Q=d(c()),H[q]=Q),Q}a(p,"getBindingState");function d(D){let N=[],B=[],P=[];for(let q=0;q<t;q++)N[q]=0,B[q]=0,P[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:B,attributeDivisors:P,object:D,attributes:{},index:null}}a(d,"createBindingState");function f(D,N,B,P){let q=s.attributes,$=N.attributes,O=0,j=B.getAttributes();for(let H in j)if(j[H].location>=0){let te=q[H],ne=$[H];if(ne===void 0&&(H==="instanceMatrix"&&D.instanceMatrix&&(ne=D.instanceMatrix),H==="instanceColor"&&D.instanceColor&&(ne=D.instanceColor)),te===void 0||te.attribute!==ne||ne&&te.data!==ne.data)return!0;O++}return s.attributesNum!==O||s.index!==P}a(f,"needsUpdate");function _(D,N,B,P){let q={},$=N.attributes,O=0,j=B.getAttributes();for(let H in j)if(j[H].location>=0){let te=$[H];te===void 0&&(H==="instanceMatrix"&&D.instanceMatrix&&(te=D.instanceMatrix),H==="instanceColor"&&D.instanceColor&&(te=D.instanceColor));let ne={};ne.attribute=te,te&&te.data&&(ne.data=te.data),q[H]=ne,O++}s.attributes=q,s.attributesNum=O,s.index=P}a(_,"saveCache");function v(){let D=s.newAttributes;for(let N=0,B=D.length;N<B;N++)D[N]=0}a(v,"initAttributes");function g(D){m(D,0)}a(g,"enableAttribute");function m(D,N){let B=s.newAttributes,P=s.enabledAttributes,q=s.attributeDivisors;B[D]=1,P[D]===0&&(n.enableVertexAttribArray(D),P[D]=1),q[D]!==N&&(n.vertexAttribDivisor(D,N),q[D]=N)}a(m,"enableAttributeAndDivisor");function S(){let D=s.newAttributes,N=s.enabledAttributes;for(let B=0,P=N.length;B<P;B++)N[B]!==D[B]&&(n.disableVertexAttribArray(B),N[B]=0)}a(S,"disableUnusedAttributes");function A(D,N,B,P,q,$,O){O===!0?n.vertexAttribIPointer(D,N,B,q,$):n.vertexAttribPointer(D,N,B,P,q,$)}a(A,"vertexAttribPointer");function x(D,N,B,P){v();let q=P.attributes,$=B.getAttributes(),O=N.defaultAttributeValues;for(let j in $){let H=$[j];if(H.location>=0){let Q=q[j];if(Q===void 0&&(j==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),j==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let te=Q.normalized,ne=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let X=he.buffer,me=he.type,be=he.bytesPerElement,Re=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===$o;if(Q.isInterleavedBufferAttribute){let ge=Q.data,Ne=ge.isInterleavedBuffer===!0?ge.stride:ge.itemSize,ot=Q.offset;if(ge.isInstancedInterleavedBuffer||ge.isInstancedBufferAttribute){for(let Ie=0;Ie<H.locationSize;Ie++)m(H.location+Ie,ge.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=ge.meshPerAttribute*ge.count)}else for(let Ie=0;Ie<H.locationSize;Ie++)g(H.location+Ie);n.bindBuffer(n.ARRAY_BUFFER,X);for(let Ie=0;Ie<H.locationSize;Ie++)A(H.location+Ie,ne/H.locationSize,me,te,Ne*be,(ot+ne/H.locationSize*Ie)*be,Re)}else{if(Q.isInstancedBufferAttribute){for(let ge=0;ge<H.locationSize;ge++)m(H.location+ge,Q.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ge=0;ge<H.locationSize;ge++)g(H.location+ge);n.bindBuffer(n.ARRAY_BUFFER,X);for(let ge=0;ge<H.locationSize;ge++)A(H.location+ge,ne/H.locationSize,me,te,ne*be,ne/H.locationSize*ge*be,Re)}}else if(O!==void 0){let te=O[j];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv(H.location,te);break;case 3:n.vertexAttrib3fv(H.location,te);break;case 4:n.vertexAttrib4fv(H.location,te);break;default:n.vertexAttrib1fv(H.location,te)}}}}S()}a(x,"setupVertexAttributes");function b(){L();for(let D in i){let N=i[D];for(let B in N){let P=N[B];for(let q in P){let $=P[q];for(let O in $)h($[O].object),delete $[O];delete P[q]}}delete i[D]}}a(b,"dispose");function w(D){if(i[D.id]===void 0)return;let N=i[D.id];for(let B in N){let P=N[B];for(let q in P){let $=P[q];for(let O in $)h($[O].object),delete $[O];delete P[q]}}delete i[D.id]}a(w,"releaseStatesOfGeometry");function y(D){for(let N in i){let B=i[N];for(let P in B){let q=B[P];if(q[D.id]===void 0)continue;let $=q[D.id];for(let O in $)h($[O].object),delete $[O];delete q[D.id]}}}a(y,"releaseStatesOfProgram");function T(D){for(let N in i){let B=i[N],P=D.isInstancedMesh===!0?D.id:0,q=B[P];if(q!==void 0){for(let $ in q){let O=q[$];for(let j in O)h(O[j].object),delete O[j];delete q[$]}delete B[P],Object.keys(B).length===0&&delete i[N]}}}a(T,"releaseStatesOfObject");function L(){C(),o=!0,s!==r&&(s=r,u(s.object))}a(L,"reset");function C(){r.geometry=null,r.program=null,r.wireframe=!1}return a(C,"resetDefaultState"),{setup:l,reset:L,resetDefaultState:C,dispose:b,releaseStatesOfGeometry:w,releaseStatesOfObject:T,releaseStatesOfProgram:y,initAttributes:v,enableAttribute:g,disableUnusedAttributes:S}}a(Ky,"WebGLBindingStates");function jy(n,e,t){let i;function r(c){i=c}a(r,"setMode");function s(c,u){n.drawArrays(i,c,u),t.update(u,i,1)}a(s,"render");function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),t.update(u,i,h))}a(o,"renderInstances");function l(c,u,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let d=0;for(let f=0;f<h;f++)d+=u[f];t.update(d,i,1)}a(l,"renderMultiDraw"),this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=l}a(jy,"WebGLBufferRenderer");function Qy(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}a(s,"getMaxAnisotropy");function o(y){return!(y!==Sn&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}a(o,"textureFormatReadable");function l(y){let T=y===bn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==en&&y!==dn&&!T&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}a(l,"textureTypeReadable");function c(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}a(c,"getMaxPrecision");let u=t.precision!==void 0?t.precision:"highp",h=c(u);h!==u&&(Le("WebGLRenderer:",u,"not supported, using",h,"instead."),u=h);let p=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&p===!1;t.reversedDepthBuffer===!0&&p===!1&&Le("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&p===!0&&Le("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),S=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),b=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:l,precision:u,logarithmicDepthBuffer:d,reversedDepthBuffer:p,maxTextures:f,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:S,maxVaryings:A,maxFragmentUniforms:x,maxSamples:b,samples:w}}a(Qy,"WebGLCapabilities");function ex(n){let e=this,t=null,i=0,r=!1,s=!1,o=new yn,l=new Ue,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(p,d){let f=p.length!==0||d||i!==0||r;return r=d,i=p.length,f},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(p,d){t=h(p,d,0)},this.setState=function(p,d,f){let _=p.clippingPlanes,v=p.clipIntersection,g=p.clipShadows,m=n.get(p);if(!r||_===null||_.length===0||s&&!g)s?h(null):u();else{let S=s?0:i,A=S*4,x=m.clippingState||null;c.value=x,x=h(_,d,A,f);for(let b=0;b!==A;++b)x[b]=t[b];m.clippingState=x,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=S}};function u(){c.value!==t&&(c.value=t,c.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}a(u,"resetGlobalState");function h(p,d,f,_){let v=p!==null?p.length:0,g=null;if(v!==0){if(g=c.value,_!==!0||g===null){let m=f+v*4,S=d.matrixWorldInverse;l.getNormalMatrix(S),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,x=f;A!==v;++A,x+=4)o.copy(p[A]).applyMatrix4(S,l),o.normal.toArray(g,x),g[x+3]=o.constant}c.value=g,c.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}a(h,"projectPlanes")}a(ex,"WebGLClipping");var ys=class extends Ft{static{a(this,"WebGLCubeRenderTarget")}constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new Li(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new dr(5,5,5),s=new Ln({name:"CubemapFromEquirect",uniforms:Fi(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ht,blending:Yn});s.uniforms.tEquirect.value=t;let o=new st(r,s),l=t.minFilter;return t.minFilter===$n&&(t.minFilter=Vt),new fr(1,10,this).update(e,o),t.minFilter=l,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}},kd=256,tx=3,nx=20,cf=256,uf=16,ix=3,rx=new G,sx=new ze,Ua=class n{static{a(this,"PMREMGenerator")}constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new fr(1,10,null),this._boxMesh=new st(new dr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:l=rx}=s,c=this._renderer;this._setSize(o);let u=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let p=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,_=c.autoClearStencil,v=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,v===null&&(e.background=c.getClearColor(sx));let g=new fr(i,r,h);return g.position.copy(l),g.update(c,e),c.autoClear=p,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=_,e.background=v,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(u,t)),this._applyPMREM(u),u}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Vd(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Gd(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(kd,Ld(e))}_fromTexture(e,t){e.mapping===Ui||e.mapping===yr?this._setSize(e.image.length===0?kd:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=zd(e,!1,!1),i=Math.log2(e)-tx;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=zd(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ui||e.mapping===yr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Vd()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Gd()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=ox(),this._integrationMaterial=ax());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/uf);for(let o=0;o<=i;o++){let l=n.lodToRoughness(o,i);if(o>i-ix)s.roughness.value=l,this._renderCube(e,o,this._integrationMaterial);else{let c=l>0?Math.log2(t)+.5*Math.log2(6/(cf*Math.pow(l,4)))+.5:0;r.roughness.value=l,r.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=lx());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function zd(n,e,t){return new ys(n,{minFilter:$n,generateMipmaps:e,type:bn,colorSpace:Or,depthBuffer:t})}a(zd,"_createRenderTarget");function xs(n,e,t){return new Ln({name:n,uniforms:e,vertexShader:Ge.cube_vert,fragmentShader:t,side:Ht,blending:Yn,depthTest:!1,depthWrite:!1})}a(xs,"_getMaterial");function ox(){return xs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${cf}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}a(ox,"_getGGXMaterial");function ax(){return xs("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:uf}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}a(ax,"_getIntegrationMaterial");function lx(){return xs("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${nx}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}a(lx,"_getBlurMaterial");function Gd(){return xs("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}a(Gd,"_getEquirectMaterial");function Vd(){return xs("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}a(Vd,"_getCubemapMaterial");function cx(n){let e=new WeakMap,t=new WeakMap,i=null;function r(d,f=!1){return d==null?null:f?o(d):s(d)}a(r,"get");function s(d){if(d&&d.isTexture){let f=d.mapping;if(f===Xo||f===qo)if(e.has(d)){let _=e.get(d).texture;return l(_,d.mapping)}else{let _=d.image;if(_&&_.height>0){let v=new ys(_.height);return v.fromEquirectangularTexture(n,d),e.set(d,v),d.addEventListener("dispose",u),l(v.texture,d.mapping)}else return null}}return d}a(s,"getCube");function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,_=f===Xo||f===qo,v=f===Ui||f===yr;if(_||v){let g=t.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new Ua(n)),g=_?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let S=d.image;return _&&S&&S.height>0||v&&S&&c(S)?(i===null&&(i=new Ua(n)),g=_?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}a(o,"getPMREM");function l(d,f){return f===Xo?d.mapping=Ui:f===qo&&(d.mapping=yr),d}a(l,"mapTextureMapping");function c(d){let f=0,_=6;for(let v=0;v<_;v++)d[v]!==void 0&&f++;return f===_}a(c,"isCubeTextureComplete");function u(d){let f=d.target;f.removeEventListener("dispose",u);let _=e.get(f);_!==void 0&&(e.delete(f),_.dispose())}a(u,"onCubemapDispose");function h(d){let f=d.target;f.removeEventListener("dispose",h);let _=t.get(f);_!==void 0&&(t.delete(f),_.dispose())}a(h,"onPMREMDispose");function p(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return a(p,"dispose"),{get:r,dispose:p}}a(cx,"WebGLEnvironments");function ux(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return a(t,"getExtension"),{has:a(function(i){return t(i)!==null},"has"),init:a(function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},"init"),get:a(function(i){let r=t(i);return r===null&&Dr("WebGLRenderer: "+i+" extension not supported."),r},"get")}}a(ux,"WebGLExtensions");function hx(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(_=>delete r[_]);function l(_){c(_.target)}a(l,"onGeometryDispose");function c(_){_.index!==null&&e.remove(_.index);for(let g in _.attributes)e.remove(_.attributes[g]);_.removeEventListener("dispose",l),delete r[_.id],o.unregister(_);let v=s.get(_);v&&(e.remove(v),s.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}a(c,"destroyGeometry");function u(_,v){return r[v.id]!==void 0||(v.addEventListener("dispose",l),r[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}a(u,"get");function h(_){let v=_.attributes;for(let g in v)e.update(v[g],n.ARRAY_BUFFER)}a(h,"update");function p(_){let v=_.index,g=_.attributes.position,m=0;if(g===void 0)return;let S=v!==null?v.array.length:g.array.length/3-1,A=g.count>=65535?Wr:Hr,x=new A(Math.ceil(S/3)*6,1),b=x.array;if(v!==null){let y=v.array;m=v.version;for(let T=0,L=0;T<S;T+=3){let C=y[T+0],D=y[T+1],N=y[T+2];b[L++]=C,b[L++]=D,b[L++]=D,b[L++]=N,b[L++]=N,b[L++]=C}}else{m=g.version;for(let y=0,T=0;y<S;y+=3){let L=y+0,C=y+1,D=y+2;b[T++]=L,b[T++]=C,b[T++]=C,b[T++]=D,b[T++]=D,b[T++]=L}}x.version=m;let w=s.get(_);w&&e.remove(w),s.set(_,x)}a(p,"updateWireframeAttribute");function d(_){let v=s.get(_);if(v){let g=_.index;g!==null&&v.version<g.version&&p(_)}else p(_);return s.get(_)}a(d,"getWireframeAttribute");function f(){for(let _ in r){let v=r[_].deref();v!==void 0&&c(v)}}return a(f,"dispose"),{get:u,update:h,getWireframeAttribute:d,dispose:f}}a(hx,"WebGLGeometries");function dx(n,e,t){let i;function r(p){i=p}a(r,"setMode");let s,o;function l(p){s=p.type,o=p.bytesPerElement}a(l,"setIndex");function c(p,d){n.drawElements(i,d,s,p*o),t.update(d,i,1)}a(c,"render");function u(p,d,f){f!==0&&(n.drawElementsInstanced(i,d,s,p*o,f),t.update(d,i,f))}a(u,"renderInstances");function h(p,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,s,p,0,f);let v=0;for(let g=0;g<f;g++)v+=d[g];t.update(v,i,1)}a(h,"renderMultiDraw"),this.setMode=r,this.setIndex=l,this.render=c,this.renderInstances=u,this.renderMultiDraw=h}a(dx,"WebGLIndexedBufferRenderer");function fx(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,l){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=l*(s/3);break;case n.LINES:t.lines+=l*(s/2);break;case n.LINE_STRIP:t.lines+=l*(s-1);break;case n.LINE_LOOP:t.lines+=l*s;break;case n.POINTS:t.points+=l*s;break;default:De("WebGLInfo: Unknown draw mode:",o);break}}a(i,"update");function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return a(r,"reset"),{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}a(fx,"WebGLInfo");function px(n,e,t){let i=new WeakMap,r=new nt;function s(o,l,c){let u=o.morphTargetInfluences,h=l.morphAttributes.position||l.morphAttributes.normal||l.morphAttributes.color,p=h!==void 0?h.length:0,d=i.get(l);if(d===void 0||d.count!==p){let L=function(){y.dispose(),i.delete(l),l.removeEventListener("dispose",L)};a(L,"disposeTexture"),d!==void 0&&d.texture.dispose();let f=l.morphAttributes.position!==void 0,_=l.morphAttributes.normal!==void 0,v=l.morphAttributes.color!==void 0,g=l.morphAttributes.position||[],m=l.morphAttributes.normal||[],S=l.morphAttributes.color||[],A=0;f===!0&&(A=1),_===!0&&(A=2),v===!0&&(A=3);let x=l.attributes.position.count*A,b=1;x>e.maxTextureSize&&(b=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let w=new Float32Array(x*b*4*p),y=new Gr(w,x,b,p);y.type=dn,y.needsUpdate=!0;let T=A*4;for(let C=0;C<p;C++){let D=g[C],N=m[C],B=S[C],P=x*b*4*C;for(let q=0;q<D.count;q++){let $=q*T;f===!0&&(r.fromBufferAttribute(D,q),w[P+$+0]=r.x,w[P+$+1]=r.y,w[P+$+2]=r.z,w[P+$+3]=0),_===!0&&(r.fromBufferAttribute(N,q),w[P+$+4]=r.x,w[P+$+5]=r.y,w[P+$+6]=r.z,w[P+$+7]=0),v===!0&&(r.fromBufferAttribute(B,q),w[P+$+8]=r.x,w[P+$+9]=r.y,w[P+$+10]=r.z,w[P+$+11]=B.itemSize===4?r.w:1)}}d={count:p,texture:y,size:new Ve(x,b)},i.set(l,d),l.addEventListener("dispose",L)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<u.length;v++)f+=u[v];let _=l.morphTargetsRelative?1:1-f;c.getUniforms().setValue(n,"morphTargetBaseInfluence",_),c.getUniforms().setValue(n,"morphTargetInfluences",u)}c.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),c.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return a(s,"update"),{update:s}}a(px,"WebGLMorphtargets");function mx(n,e,t,i,r){let s=new WeakMap;function o(u){let h=r.render.frame,p=u.geometry,d=e.get(u,p);if(s.get(d)!==h&&(e.update(d),s.set(d,h)),u.isInstancedMesh&&(u.hasEventListener("dispose",c)===!1&&u.addEventListener("dispose",c),s.get(u)!==h&&(t.update(u.instanceMatrix,n.ARRAY_BUFFER),u.instanceColor!==null&&t.update(u.instanceColor,n.ARRAY_BUFFER),s.set(u,h))),u.isSkinnedMesh){let f=u.skeleton;s.get(f)!==h&&(f.update(),s.set(f,h))}return d}a(o,"update");function l(){s=new WeakMap}a(l,"dispose");function c(u){let h=u.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return a(c,"onInstancedMeshDispose"),{update:o,dispose:l}}a(mx,"WebGLObjects");var gx={[oc]:"LINEAR_TONE_MAPPING",[ac]:"REINHARD_TONE_MAPPING",[lc]:"CINEON_TONE_MAPPING",[cc]:"ACES_FILMIC_TONE_MAPPING",[hc]:"AGX_TONE_MAPPING",[dc]:"NEUTRAL_TONE_MAPPING",[uc]:"CUSTOM_TONE_MAPPING"};function _x(n,e,t,i,r,s){let o=new Ft(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),l=null,c=null,u=null,h=new Tt;h.setAttribute("position",new dt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new dt([0,2,0,0,2,0],2));let p=new vn({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new st(h,p),f=new Vo(-1,1,1,-1,0,1),_=null,v=null,g=!1,m,S=null,A=[],x=!1;this.setSize=function(b,w){o.setSize(b,w),l!==null&&l.setSize(b,w),c!==null&&c.setSize(b,w);for(let y=0;y<A.length;y++){let T=A[y];T.setSize&&T.setSize(b,w)}},this.setEffects=function(b){A=b,x=A.length>0&&A[0].isRenderPass===!0;let w=o.width,y=o.height;A.length>0&&l===null&&(l=new Ft(w,y,{type:bn,depthBuffer:!1,stencilBuffer:!1}),c=new Ft(w,y,{type:bn,depthBuffer:!1,stencilBuffer:!1}));let T=r===!0&&A.some(L=>L.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&u===null&&(u=new xn(w,y),s===!0&&(u.format=Jn,u.type=Oi)),o.dispose(),o.depthTexture=T?u:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let L=0;L<A.length;L++){let C=A[L];C.setSize&&C.setSize(w,y),T&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(u)}},this.begin=function(b,w){if(g||b.toneMapping===Nn&&A.length===0)return!1;if(S=w,w!==null){let y=w.width,T=w.height;(o.width!==y||o.height!==T)&&this.setSize(y,T)}return x===!1&&b.setRenderTarget(o),m=b.toneMapping,b.toneMapping=Nn,!0},this.hasRenderPass=function(){return x},this.end=function(b,w){b.toneMapping=m,g=!0;let y=o,T=l;for(let L=0;L<A.length;L++){let C=A[L];C.enabled!==!1&&(C.render(b,T,y,w),C.needsSwap!==!1&&(y=T,T=T===l?c:l))}if(_!==b.outputColorSpace||v!==b.toneMapping){_=b.outputColorSpace,v=b.toneMapping,p.defines={},qe.getTransfer(_)===Ze&&(p.defines.SRGB_TRANSFER="");let L=gx[v];L&&(p.defines[L]=""),p.needsUpdate=!0}p.uniforms.tDiffuse.value=y.texture,b.setRenderTarget(S),b.render(d,f),S=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),l!==null&&l.dispose(),c!==null&&c.dispose(),h.dispose(),p.dispose()}}a(_x,"WebGLOutput");var hf=new Ot,df=new xn(1,1),ff=new Jr(1),pf=new Gr,mf=new Eo,gf=new Li,Hd=[],Wd=[],Xd=new Float32Array(16),qd=new Float32Array(9),Yd=new Float32Array(4);function br(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=Hd[r];if(s===void 0&&(s=new Float32Array(r),Hd[r]=s),e!==0){i.toArray(s,0);for(let o=1,l=0;o!==e;++o)l+=t,n[o].toArray(s,l)}return s}a(br,"flatten");function yt(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}a(yt,"arraysEqual");function xt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}a(xt,"copyArray");function Fa(n,e){let t=Wd[e];t===void 0&&(t=new Int32Array(e),Wd[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}a(Fa,"allocTexUnits");function yx(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}a(yx,"setValueV1f");function xx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yt(t,e))return;n.uniform2fv(this.addr,e),xt(t,e)}}a(xx,"setValueV2f");function vx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(yt(t,e))return;n.uniform3fv(this.addr,e),xt(t,e)}}a(vx,"setValueV3f");function bx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yt(t,e))return;n.uniform4fv(this.addr,e),xt(t,e)}}a(bx,"setValueV4f");function Sx(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yt(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),xt(t,e)}else{if(yt(t,i))return;Yd.set(i),n.uniformMatrix2fv(this.addr,!1,Yd),xt(t,i)}}a(Sx,"setValueM2");function Mx(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yt(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),xt(t,e)}else{if(yt(t,i))return;qd.set(i),n.uniformMatrix3fv(this.addr,!1,qd),xt(t,i)}}a(Mx,"setValueM3");function wx(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(yt(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),xt(t,e)}else{if(yt(t,i))return;Xd.set(i),n.uniformMatrix4fv(this.addr,!1,Xd),xt(t,i)}}a(wx,"setValueM4");function Ex(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}a(Ex,"setValueV1i");function Tx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yt(t,e))return;n.uniform2iv(this.addr,e),xt(t,e)}}a(Tx,"setValueV2i");function Ax(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yt(t,e))return;n.uniform3iv(this.addr,e),xt(t,e)}}a(Ax,"setValueV3i");function Rx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yt(t,e))return;n.uniform4iv(this.addr,e),xt(t,e)}}a(Rx,"setValueV4i");function Cx(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}a(Cx,"setValueV1ui");function Px(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(yt(t,e))return;n.uniform2uiv(this.addr,e),xt(t,e)}}a(Px,"setValueV2ui");function Ix(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(yt(t,e))return;n.uniform3uiv(this.addr,e),xt(t,e)}}a(Ix,"setValueV3ui");function Lx(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(yt(t,e))return;n.uniform4uiv(this.addr,e),xt(t,e)}}a(Lx,"setValueV4ui");function Ba(n){return n.version===0&&(n.compareFunction=Sc,n.needsUpdate=!0),n}a(Ba,"initShadowTexture");function Nx(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Ba(df):s=hf,t.setTexture2D(e||s,r)}a(Nx,"setValueT1");function Dx(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||mf,r)}a(Dx,"setValueT3D1");function Ux(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Ba(ff):s=gf,t.setTextureCube(e||s,r)}a(Ux,"setValueT6");function Ox(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||pf,r)}a(Ox,"setValueT2DArray1");function Fx(n){switch(n){case 5126:return yx;case 35664:return xx;case 35665:return vx;case 35666:return bx;case 35674:return Sx;case 35675:return Mx;case 35676:return wx;case 5124:case 35670:return Ex;case 35667:case 35671:return Tx;case 35668:case 35672:return Ax;case 35669:case 35673:return Rx;case 5125:return Cx;case 36294:return Px;case 36295:return Ix;case 36296:return Lx;case 35678:case 36198:case 36298:case 36306:case 35682:return Nx;case 35679:case 36299:case 36307:return Dx;case 35680:case 36300:case 36308:case 36293:return Ux;case 36289:case 36303:case 36311:case 36292:return Ox}}a(Fx,"getSingularSetter");function Bx(n,e){n.uniform1fv(this.addr,e)}a(Bx,"setValueV1fArray");function kx(n,e){let t=br(e,this.size,2);n.uniform2fv(this.addr,t)}a(kx,"setValueV2fArray");function zx(n,e){let t=br(e,this.size,3);n.uniform3fv(this.addr,t)}a(zx,"setValueV3fArray");function Gx(n,e){let t=br(e,this.size,4);n.uniform4fv(this.addr,t)}a(Gx,"setValueV4fArray");function Vx(n,e){let t=br(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}a(Vx,"setValueM2Array");function Hx(n,e){let t=br(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}a(Hx,"setValueM3Array");function Wx(n,e){let t=br(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}a(Wx,"setValueM4Array");function Xx(n,e){n.uniform1iv(this.addr,e)}a(Xx,"setValueV1iArray");function qx(n,e){n.uniform2iv(this.addr,e)}a(qx,"setValueV2iArray");function Yx(n,e){n.uniform3iv(this.addr,e)}a(Yx,"setValueV3iArray");function $x(n,e){n.uniform4iv(this.addr,e)}a($x,"setValueV4iArray");function Jx(n,e){n.uniform1uiv(this.addr,e)}a(Jx,"setValueV1uiArray");function Zx(n,e){n.uniform2uiv(this.addr,e)}a(Zx,"setValueV2uiArray");function Kx(n,e){n.uniform3uiv(this.addr,e)}a(Kx,"setValueV3uiArray");function jx(n,e){n.uniform4uiv(this.addr,e)}a(jx,"setValueV4uiArray");function Qx(n,e,t){let i=this.cache,r=e.length,s=Fa(t,r);yt(i,s)||(n.uniform1iv(this.addr,s),xt(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ba(df):o=hf;for(let l=0;l!==r;++l)t.setTexture2D(e[l]||o,s[l])}a(Qx,"setValueT1Array");function ev(n,e,t){let i=this.cache,r=e.length,s=Fa(t,r);yt(i,s)||(n.uniform1iv(this.addr,s),xt(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||mf,s[o])}a(ev,"setValueT3DArray");function tv(n,e,t){let i=this.cache,r=e.length,s=Fa(t,r);yt(i,s)||(n.uniform1iv(this.addr,s),xt(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ba(ff):o=gf;for(let l=0;l!==r;++l)t.setTextureCube(e[l]||o,s[l])}a(tv,"setValueT6Array");function nv(n,e,t){let i=this.cache,r=e.length,s=Fa(t,r);yt(i,s)||(n.uniform1iv(this.addr,s),xt(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||pf,s[o])}a(nv,"setValueT2DArrayArray");function iv(n){switch(n){case 5126:return Bx;case 35664:return kx;case 35665:return zx;case 35666:return Gx;case 35674:return Vx;case 35675:return Hx;case 35676:return Wx;case 5124:case 35670:return Xx;case 35667:case 35671:return qx;case 35668:case 35672:return Yx;case 35669:case 35673:return $x;case 5125:return Jx;case 36294:return Zx;case 36295:return Kx;case 36296:return jx;case 35678:case 36198:case 36298:case 36306:case 35682:return Qx;case 35679:case 36299:case 36307:return ev;case 35680:case 36300:case 36308:case 36293:return tv;case 36289:case 36303:case 36311:case 36292:return nv}}a(iv,"getPureArraySetter");var Cc=class{static{a(this,"SingleUniform")}constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Fx(t.type)}},Pc=class{static{a(this,"PureArrayUniform")}constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=iv(t.type)}},Ic=class{static{a(this,"StructuredUniform")}constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let l=r[s];l.setValue(e,t[l.id],i)}}},Ac=/(\w+)(\])?(\[|\.)?/g;function $d(n,e){n.seq.push(e),n.map[e.id]=e}a($d,"addUniform");function rv(n,e,t){let i=n.name,r=i.length;for(Ac.lastIndex=0;;){let s=Ac.exec(i),o=Ac.lastIndex,l=s[1],c=s[2]==="]",u=s[3];if(c&&(l=l|0),u===void 0||u==="["&&o+2===r){$d(t,u===void 0?new Cc(l,n,e):new Pc(l,n,e));break}else{let p=t.map[l];p===void 0&&(p=new Ic(l),$d(t,p)),t=p}}}a(rv,"parseUniform");var vr=class{static{a(this,"WebGLUniforms")}constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let l=e.getActiveUniform(t,o),c=e.getUniformLocation(t,l.name);rv(l,c,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let l=t[s],c=i[l.id];c.needsUpdate!==!1&&l.setValue(e,c.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Jd(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}a(Jd,"WebGLShader");var sv=37297,ov=0;function av(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let l=o+1;i.push(`${l===e?">":" "} ${l}: ${t[o]}`)}return i.join(`
`)}a(av,"handleSource");var Zd=new Ue;function lv(n){qe._getMatrix(Zd,qe.workingColorSpace,n);let e=`mat3( ${Zd.elements.map(t=>t.toFixed(4))} )`;switch(qe.getTransfer(n)){case Fr:return[e,"LinearTransferOETF"];case Ze:return[e,"sRGBTransferOETF"];default:return Le("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}a(lv,"getEncodingComponents");function Kd(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let l=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+av(n.getShaderSource(e),l)}else return s}a(Kd,"getShaderErrors");function cv(n,e){let t=lv(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}a(cv,"getTexelEncodingFunction");var uv={[oc]:"Linear",[ac]:"Reinhard",[lc]:"Cineon",[cc]:"ACESFilmic",[hc]:"AgX",[dc]:"Neutral",[uc]:"Custom"};function hv(n,e){let t=uv[e];return t===void 0?(Le("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}a(hv,"getToneMappingFunction");var Da=new G;function dv(){qe.getLuminanceCoefficients(Da);let n=Da.x.toFixed(4),e=Da.y.toFixed(4),t=Da.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}a(dv,"getLuminanceFunction");function fv(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(_s).join(`
`)}a(fv,"generateVertexExtensions");function pv(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}a(pv,"generateDefines");function mv(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,l=1;s.type===n.FLOAT_MAT2&&(l=2),s.type===n.FLOAT_MAT3&&(l=3),s.type===n.FLOAT_MAT4&&(l=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:l}}return t}a(mv,"fetchAttributeLocations");function _s(n){return n!==""}a(_s,"filterEmptyLine");function jd(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}a(jd,"replaceLightNums");function Qd(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}a(Qd,"replaceClippingPlaneNums");var gv=/^[ \t]*#include +<([\w\d./]+)>/gm;function Lc(n){return n.replace(gv,_v)}a(Lc,"resolveIncludes");function _v(n,e){let t=Ge[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Lc(t)}a(_v,"includeReplacer");var yv=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function ef(n){return n.replace(yv,xv)}a(ef,"unrollLoops");function xv(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}a(xv,"loopReplacer");function tf(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}a(tf,"generatePrecision");var vv={[os]:"SHADOWMAP_TYPE_PCF",[pr]:"SHADOWMAP_TYPE_VSM"};function bv(n){return vv[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}a(bv,"generateShadowMapTypeDefine");var Sv={[yr]:"ENVMAP_MODE_REFRACTION"};function Mv(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Sv[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}a(Mv,"generateEnvMapModeDefine");var wv={[Wo]:"ENVMAP_BLENDING_MULTIPLY",[gd]:"ENVMAP_BLENDING_MIX",[_d]:"ENVMAP_BLENDING_ADD"};function Ev(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":wv[n.combine]||"ENVMAP_BLENDING_NONE"}a(Ev,"generateEnvMapBlendingDefine");function Tv(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,l=t.fragmentShader,c=bv(t),u=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Mv(t),p=Ev(t),d=fv(t),f=pv(s),_=r.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(_s).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(_s).join(`
`),g.length>0&&(g+=`
`)):(v=[tf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(_s).join(`
`),g=[tf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMap?"#define "+p:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Nn?"#define TONE_MAPPING":"",t.toneMapping!==Nn?Ge.tonemapping_pars_fragment:"",t.toneMapping!==Nn?hv("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Ge.colorspace_pars_fragment,cv("linearToOutputTexel",t.outputColorSpace),dv(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(_s).join(`
`)),o=Lc(o),o=jd(o,t),o=Qd(o,t),l=Lc(l),l=jd(l,t),l=Qd(l,t),o=ef(o),l=ef(l),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===Kn?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Kn?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let S=m+v+o,A=m+g+l,x=Jd(r,r.VERTEX_SHADER,S),b=Jd(r,r.FRAGMENT_SHADER,A);r.attachShader(_,x),r.attachShader(_,b),t.index0AttributeName!==void 0?r.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(_,0,"position"),r.linkProgram(_);function w(C){if(n.debug.checkShaderErrors){let D=r.getProgramInfoLog(_)||"",N=r.getShaderInfoLog(x)||"",B=r.getShaderInfoLog(b)||"",P=D.trim(),q=N.trim(),$=B.trim(),O=!0,j=!0;if(r.getProgramParameter(_,r.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,_,x,b);else{let H=Kd(r,x,"vertex"),Q=Kd(r,b,"fragment");De("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(_,r.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+P+`
`+H+`
`+Q)}else P!==""?Le("WebGLProgram: Program Info Log:",P):(q===""||$==="")&&(j=!1);j&&(C.diagnostics={runnable:O,programLog:P,vertexShader:{log:q,prefix:v},fragmentShader:{log:$,prefix:g}})}r.deleteShader(x),r.deleteShader(b),y=new vr(r,_),T=mv(r,_)}a(w,"onFirstUse");let y;this.getUniforms=function(){return y===void 0&&w(this),y};let T;this.getAttributes=function(){return T===void 0&&w(this),T};let L=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return L===!1&&(L=r.getProgramParameter(_,sv)),L},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=ov++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=x,this.fragmentShader=b,this}a(Tv,"WebGLProgram");var Av=0,Nc=class{static{a(this,"WebGLShaderCache")}constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Dc(e),t.set(e,i)),i}},Dc=class{static{a(this,"WebGLShaderStage")}constructor(e){this.id=Av++,this.code=e,this.usedTimes=0}};function Rv(n){return n===mi||n===fs||n===ps}a(Rv,"isPackedRGFormat");function Cv(n,e,t,i,r,s){let o=new Vr,l=new Nc,c=new Set,u=[],h=new Map,p=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return c.add(y),y===0?"uv":`uv${y}`}a(f,"getChannel");function _(y,T,L,C,D,N){let B=C.fog,P=D.geometry,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?C.environment:null,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,O=e.get(y.envMap||q,$),j=d[y.type],H=i.precision;y.precision!==null&&(H=i.getMaxPrecision(y.precision),H!==y.precision&&Le("WebGLProgram.getParameters:",y.precision,"not supported, using",H,"instead."));let Q=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,te=Q!==void 0?Q.length:0,ne=0;P.morphAttributes.position!==void 0&&(ne=1),P.morphAttributes.normal!==void 0&&(ne=2),P.morphAttributes.color!==void 0&&(ne=3);let he,X,me,be;if(j){let _e=Un[j];he=_e.vertexShader,X=_e.fragmentShader}else{he=y.vertexShader,X=y.fragmentShader;let _e=l.getVertexShaderStage(y),je=l.getFragmentShaderStage(y);l.update(y,_e,je),me=_e.id,be=je.id}let Re=n.getRenderTarget(),ge=n.state.buffers.depth.getReversed(),Ne=D.isInstancedMesh===!0,ot=D.isBatchedMesh===!0,Ie=!!y.map,Ke=!!y.matcap,et=!!O,He=et&&O.isPMREMTexture===!0,Rt=!!y.aoMap,gt=!!y.lightMap,Wt=!!y.bumpMap&&y.wireframe===!1,ct=!!y.normalMap,Mn=!!y.displacementMap,vt=!!y.emissiveMap,rn=!!y.metalnessMap,sn=!!y.roughnessMap,on=y.anisotropy>0,F=y.clearcoat>0,an=y.diffuseRoughness>0,at=y.dispersion>0,lt=y.retroreflectivity>0,pe=y.iridescence>0,_t=y.sheen>0,Pe=y.transmission>0,Oe=on&&!!y.anisotropyMap,R=F&&!!y.clearcoatMap,M=F&&!!y.clearcoatNormalMap,z=F&&!!y.clearcoatRoughnessMap,ie=an&&!!y.diffuseRoughnessMap,ee=pe&&!!y.iridescenceMap,oe=pe&&!!y.iridescenceThicknessMap,de=_t&&!!y.sheenColorMap,J=_t&&!!y.sheenRoughnessMap,Z=!!y.specularMap,le=!!y.specularColorMap,I=!!y.specularIntensityMap,K=Pe&&!!y.transmissionMap,Y=Pe&&!!y.thicknessMap,ce=!!y.gradientMap,se=!!y.alphaMap,ae=y.alphaTest>0,Te=!!y.alphaHash,ke=!!y.extensions,re=Nn;y.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(re=n.toneMapping);let Ae=He?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,Be={shaderID:j,shaderType:y.type,shaderName:y.name,vertexShader:he,fragmentShader:X,defines:y.defines,customVertexShaderID:me,customFragmentShaderID:be,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:H,batching:ot,batchingColor:ot&&D._colorsTexture!==null,instancing:Ne,instancingColor:Ne&&D.instanceColor!==null,instancingMorph:Ne&&D.morphTexture!==null,outputColorSpace:Re===null?n.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:qe.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Ie,matcap:Ke,envMap:et,envMapMode:et&&O.mapping,envMapPMREM:He,envMapMaxLod:He?Ae.length-1:null,envMapSize:He?Ae[0].width:null,aoMap:Rt,lightMap:gt,bumpMap:Wt,normalMap:ct,displacementMap:Mn,emissiveMap:vt,normalMapObjectSpace:ct&&y.normalMapType===vd,normalMapTangentSpace:ct&&y.normalMapType===Ia,packedNormalMap:ct&&y.normalMapType===Ia&&Rv(y.normalMap.format),metalnessMap:rn,roughnessMap:sn,anisotropy:on,anisotropyMap:Oe,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:z,diffuseRoughness:an,diffuseRoughnessMap:ie,dispersion:at,retroreflection:lt,iridescence:pe,iridescenceMap:ee,iridescenceThicknessMap:oe,sheen:_t,sheenColorMap:de,sheenRoughnessMap:J,specularMap:Z,specularColorMap:le,specularIntensityMap:I,transmission:Pe,transmissionMap:K,thicknessMap:Y,gradientMap:ce,opaque:y.transparent===!1&&y.blending===mr&&y.alphaToCoverage===!1,alphaMap:se,alphaTest:ae,alphaHash:Te,combine:y.combine,mapUv:Ie&&f(y.map.channel),aoMapUv:Rt&&f(y.aoMap.channel),lightMapUv:gt&&f(y.lightMap.channel),bumpMapUv:Wt&&f(y.bumpMap.channel),normalMapUv:ct&&f(y.normalMap.channel),displacementMapUv:Mn&&f(y.displacementMap.channel),emissiveMapUv:vt&&f(y.emissiveMap.channel),metalnessMapUv:rn&&f(y.metalnessMap.channel),roughnessMapUv:sn&&f(y.roughnessMap.channel),anisotropyMapUv:Oe&&f(y.anisotropyMap.channel),clearcoatMapUv:R&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ie&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ee&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:oe&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:de&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:J&&f(y.sheenRoughnessMap.channel),specularMapUv:Z&&f(y.specularMap.channel),specularColorMapUv:le&&f(y.specularColorMap.channel),specularIntensityMapUv:I&&f(y.specularIntensityMap.channel),transmissionMapUv:K&&f(y.transmissionMap.channel),thicknessMapUv:Y&&f(y.thicknessMap.channel),alphaMapUv:se&&f(y.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(ct||on),vertexNormals:!!P.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!P.attributes.uv&&(Ie||se),fog:!!B,useFog:y.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||P.attributes.normal===void 0&&ct===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:p,reversedDepthBuffer:ge,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ne,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:N.filter(_e=>_e.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&L.length>0,shadowMapType:n.shadowMap.type,toneMapping:re,decodeVideoTexture:Ie&&y.map.isVideoTexture===!0&&qe.getTransfer(y.map.colorSpace)===Ze,decodeVideoTextureEmissive:vt&&y.emissiveMap.isVideoTexture===!0&&qe.getTransfer(y.emissiveMap.colorSpace)===Ze,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===hn,flipSided:y.side===Ht,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:ke&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ke&&y.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Be.vertexUv1s=c.has(1),Be.vertexUv2s=c.has(2),Be.vertexUv3s=c.has(3),c.clear(),Be}a(_,"getParameters");function v(y){let T=[];if(y.shaderID?T.push(y.shaderID):(T.push(y.customVertexShaderID),T.push(y.customFragmentShaderID)),y.defines!==void 0)for(let L in y.defines)T.push(L),T.push(y.defines[L]);return y.isRawShaderMaterial===!1&&(g(T,y),m(T,y),T.push(n.outputColorSpace)),T.push(y.customProgramCacheKey),T.join()}a(v,"getProgramCacheKey");function g(y,T){y.push(T.precision),y.push(T.outputColorSpace),y.push(T.envMapMode),y.push(T.envMapPMREM),y.push(T.envMapMaxLod),y.push(T.envMapSize),y.push(T.mapUv),y.push(T.alphaMapUv),y.push(T.lightMapUv),y.push(T.aoMapUv),y.push(T.bumpMapUv),y.push(T.normalMapUv),y.push(T.displacementMapUv),y.push(T.emissiveMapUv),y.push(T.metalnessMapUv),y.push(T.roughnessMapUv),y.push(T.anisotropyMapUv),y.push(T.clearcoatMapUv),y.push(T.clearcoatNormalMapUv),y.push(T.clearcoatRoughnessMapUv),y.push(T.diffuseRoughnessMapUv),y.push(T.iridescenceMapUv),y.push(T.iridescenceThicknessMapUv),y.push(T.sheenColorMapUv),y.push(T.sheenRoughnessMapUv),y.push(T.specularMapUv),y.push(T.specularColorMapUv),y.push(T.specularIntensityMapUv),y.push(T.transmissionMapUv),y.push(T.thicknessMapUv),y.push(T.combine),y.push(T.fogExp2),y.push(T.sizeAttenuation),y.push(T.morphTargetsCount),y.push(T.numSunLights),y.push(T.numDirLights),y.push(T.numPointLights),y.push(T.numSpotLights),y.push(T.numSpotLightMaps),y.push(T.numHemiLights),y.push(T.numRectAreaLights),y.push(T.numSunLightShadows),y.push(T.numDirLightShadows),y.push(T.numPointLightShadows),y.push(T.numSpotLightShadows),y.push(T.numSpotLightShadowsWithMaps),y.push(T.numLightProbes),y.push(T.numLightProbeGrids),y.push(T.shadowMapType),y.push(T.toneMapping),y.push(T.numClippingPlanes),y.push(T.numClipIntersection),y.push(T.depthPacking)}a(g,"getProgramCacheKeyParameters");function m(y,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),y.push(o.mask)}a(m,"getProgramCacheKeyBooleans");function S(y){let T=d[y.type],L;if(T){let C=Un[T];L=Od.clone(C.uniforms)}else L=y.uniforms;return L}a(S,"getUniforms");function A(y,T){let L=h.get(T);return L!==void 0?++L.usedTimes:(L=new Tv(n,T,y,r),u.push(L),h.set(T,L)),L}a(A,"acquireProgram");function x(y){if(--y.usedTimes===0){let T=u.indexOf(y);u[T]=u[u.length-1],u.pop(),h.delete(y.cacheKey),y.destroy()}}a(x,"releaseProgram");function b(y){l.remove(y)}a(b,"releaseShaderCache");function w(){l.dispose()}return a(w,"dispose"),{getParameters:_,getProgramCacheKey:v,getUniforms:S,acquireProgram:A,releaseProgram:x,releaseShaderCache:b,programs:u,dispose:w}}a(Cv,"WebGLPrograms");function Pv(){let n=new WeakMap;function e(o){return n.has(o)}a(e,"has");function t(o){let l=n.get(o);return l===void 0&&(l={},n.set(o,l)),l}a(t,"get");function i(o){n.delete(o)}a(i,"remove");function r(o,l,c){n.get(o)[l]=c}a(r,"update");function s(){n=new WeakMap}return a(s,"dispose"),{has:e,get:t,remove:i,update:r,dispose:s}}a(Pv,"WebGLProperties");function Iv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}a(Iv,"painterSortStable");function nf(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}a(nf,"reversePainterSortStable");function rf(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}a(s,"init");function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}a(o,"materialVariant");function l(d,f,_,v,g,m){let S=n[e];return S===void 0?(S={id:d.id,object:d,geometry:f,material:_,materialVariant:o(d),groupOrder:v,renderOrder:d.renderOrder,z:g,group:m},n[e]=S):(S.id=d.id,S.object=d,S.geometry=f,S.material=_,S.materialVariant=o(d),S.groupOrder=v,S.renderOrder=d.renderOrder,S.z=g,S.group=m),e++,S}a(l,"getNextRenderItem");function c(d,f,_,v,g,m,S){S.reversedDepth===!0&&(g=-g);let A=l(d,f,_,v,g,m);_.transmission>0?i.push(A):_.transparent===!0?r.push(A):t.push(A)}a(c,"push");function u(d,f,_,v,g,m){let S=l(d,f,_,v,g,m);_.transmission>0?i.unshift(S):_.transparent===!0?r.unshift(S):t.unshift(S)}a(u,"unshift");function h(d,f){t.length>1&&t.sort(d||Iv),i.length>1&&i.sort(f||nf),r.length>1&&r.sort(f||nf)}a(h,"sort");function p(){for(let d=e,f=n.length;d<f;d++){let _=n[d];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return a(p,"finish"),{opaque:t,transmissive:i,transparent:r,init:s,push:c,unshift:u,finish:p,sort:h}}a(rf,"WebGLRenderList");function Lv(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new rf,n.set(i,[o])):r>=s.length?(o=new rf,s.push(o)):o=s[r],o}a(e,"get");function t(){n=new WeakMap}return a(t,"dispose"),{get:e,dispose:t}}a(Lv,"WebGLRenderLists");function Nv(){let n={};return{get:a(function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new ze};break;case"SpotLight":t={position:new G,direction:new G,color:new ze,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new ze,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new ze,groundColor:new ze};break;case"RectAreaLight":t={color:new ze,position:new G,halfWidth:new G,halfHeight:new G};break}return n[e.id]=t,t},"get")}}a(Nv,"UniformsCache");function Dv(){let n={};return{get:a(function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ve};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ve};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ve,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t},"get")}}a(Dv,"ShadowUniformsCache");var Uv=0;function Ov(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}a(Ov,"shadowCastingAndTexturingLightsFirst");function Fv(n){let e=new Nv,t=Dv(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let u=0;u<9;u++)i.probe.push(new G);let r=new G,s=new Qe,o=new Qe;function l(u){let h=0,p=0,d=0;for(let N=0;N<9;N++)i.probe[N].set(0,0,0);let f=0,_=0,v=0,g=0,m=0,S=0,A=0,x=0,b=0,w=0,y=0,T=0,L=0,C=0;u.sort(Ov);for(let N=0,B=u.length;N<B;N++){let P=u[N],q=P.color,$=P.intensity,O=P.distance,j=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===mi?j=P.shadow.map.texture:j=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=q.r*$,p+=q.g*$,d+=q.b*$;else if(P.isLightProbe){for(let H=0;H<9;H++)i.probe[H].addScaledVector(P.sh.coefficients[H],$);C++}else if(P.isSunLight){let H=e.get(P);if(H.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[_]=te,i.sunShadowMap[_]=j;let ne=Q.getViewportCount();for(let he=0;he<ne;he++)i.sunShadowMatrix[v+he]=Q.getMatrix(he),i.sunShadowCascade[v+he]=Q._cascadeData[he];v+=ne,_++}i.sun[f]=H,f++}else if(P.isDirectionalLight){let H=e.get(P);if(H.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,i.directionalShadow[g]=te,i.directionalShadowMap[g]=j,i.directionalShadowMatrix[g]=P.shadow.matrix,b++}i.directional[g]=H,g++}else if(P.isSpotLight){let H=e.get(P);H.position.setFromMatrixPosition(P.matrixWorld),H.color.copy(q).multiplyScalar($),H.distance=O,H.coneCos=Math.cos(P.angle),H.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),H.decay=P.decay,i.spot[S]=H;let Q=P.shadow;if(P.map&&(i.spotLightMap[T]=P.map,T++,Q.updateMatrices(P),P.castShadow&&L++),i.spotLightMatrix[S]=Q.matrix,P.castShadow){let te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,i.spotShadow[S]=te,i.spotShadowMap[S]=j,y++}S++}else if(P.isRectAreaLight){let H=e.get(P);H.color.copy(q).multiplyScalar($),H.halfWidth.set(P.width*.5,0,0),H.halfHeight.set(0,P.height*.5,0),i.rectArea[A]=H,A++}else if(P.isPointLight){let H=e.get(P);if(H.color.copy(P.color).multiplyScalar(P.intensity),H.distance=P.distance,H.decay=P.decay,P.castShadow){let Q=P.shadow,te=t.get(P);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,te.shadowCameraNear=Q.camera.near,te.shadowCameraFar=Q.camera.far,i.pointShadow[m]=te,i.pointShadowMap[m]=j,i.pointShadowMatrix[m]=P.shadow.matrix,w++}i.point[m]=H,m++}else if(P.isHemisphereLight){let H=e.get(P);H.skyColor.copy(P.color).multiplyScalar($),H.groundColor.copy(P.groundColor).multiplyScalar($),i.hemi[x]=H,x++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=ye.LTC_FLOAT_1,i.rectAreaLTC2=ye.LTC_FLOAT_2):(i.rectAreaLTC1=ye.LTC_HALF_1,i.rectAreaLTC2=ye.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=p,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==g||D.pointLength!==m||D.spotLength!==S||D.rectAreaLength!==A||D.hemiLength!==x||D.numSunShadows!==_||D.numDirectionalShadows!==b||D.numPointShadows!==w||D.numSpotShadows!==y||D.numSpotMaps!==T||D.numLightProbes!==C)&&(i.sun.length=f,i.directional.length=g,i.spot.length=S,i.rectArea.length=A,i.point.length=m,i.hemi.length=x,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=b,i.directionalShadowMap.length=b,i.directionalShadowMatrix.length=b,i.pointShadow.length=w,i.pointShadowMap.length=w,i.pointShadowMatrix.length=w,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+T-L,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=L,i.numLightProbes=C,D.sunLength=f,D.directionalLength=g,D.pointLength=m,D.spotLength=S,D.rectAreaLength=A,D.hemiLength=x,D.numSunShadows=_,D.numDirectionalShadows=b,D.numPointShadows=w,D.numSpotShadows=y,D.numSpotMaps=T,D.numLightProbes=C,i.version=Uv++)}a(l,"setup");function c(u,h){let p=0,d=0,f=0,_=0,v=0,g=0,m=h.matrixWorldInverse;for(let S=0,A=u.length;S<A;S++){let x=u[S];if(x.isSunLight){let b=i.sun[p];b.direction.setFromMatrixPosition(x.matrixWorld),b.direction.transformDirection(m),p++}else if(x.isDirectionalLight){let b=i.directional[d];b.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),b.direction.sub(r),b.direction.transformDirection(m),d++}else if(x.isSpotLight){let b=i.spot[_];b.position.setFromMatrixPosition(x.matrixWorld),b.position.applyMatrix4(m),b.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),b.direction.sub(r),b.direction.transformDirection(m),_++}else if(x.isRectAreaLight){let b=i.rectArea[v];b.position.setFromMatrixPosition(x.matrixWorld),b.position.applyMatrix4(m),o.identity(),s.copy(x.matrixWorld),s.premultiply(m),o.extractRotation(s),b.halfWidth.set(x.width*.5,0,0),b.halfHeight.set(0,x.height*.5,0),b.halfWidth.applyMatrix4(o),b.halfHeight.applyMatrix4(o),v++}else if(x.isPointLight){let b=i.point[f];b.position.setFromMatrixPosition(x.matrixWorld),b.position.applyMatrix4(m),f++}else if(x.isHemisphereLight){let b=i.hemi[g];b.direction.setFromMatrixPosition(x.matrixWorld),b.direction.transformDirection(m),g++}}}return a(c,"setupView"),{setup:l,setupView:c,state:i}}a(Fv,"WebGLLights");function sf(n){let e=new Fv(n),t=[],i=[],r=[];function s(p){h.camera=p,t.length=0,i.length=0,r.length=0}a(s,"init");function o(p){p.isLightProbeGrid?r.push(p):t.push(p)}a(o,"pushLight");function l(p){i.push(p)}a(l,"pushShadow");function c(){e.setup(t),r.sort((p,d)=>p.priority-d.priority||p.id-d.id)}a(c,"setupLights");function u(p){e.setupView(t,p)}a(u,"setupLightsView");let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:c,setupLightsView:u,pushLight:o,pushShadow:l}}a(sf,"WebGLRenderState");function Bv(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),l;return o===void 0?(l=new sf(n),e.set(r,[l])):s>=o.length?(l=new sf(n),o.push(l)):l=o[s],l}a(t,"get");function i(){e=new WeakMap}return a(i,"dispose"),{get:t,dispose:i}}a(Bv,"WebGLRenderStates");var kv=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zv=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Gv=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],Vv=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],of=new Qe,gs=new G,Rc=new G;function Hv(n,e,t){let i=new Ii,r=new Ve,s=new Ve,o=new nt,l=new Co,c=new Po,u={},h=t.maxTextureSize,p={[fi]:Ht,[Ht]:fi,[hn]:hn},d=new Ln({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ve},radius:{value:4}},vertexShader:kv,fragmentShader:zv}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let _=new Tt;_.setAttribute("position",new Xt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new st(_,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=os;let m=this.type;this.render=function(w,y,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||w.length===0)return;this.type===Qh&&(Le("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=os);let L=n.getRenderTarget(),C=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),N=n.state;N.setBlending(Yn),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let B=m!==this.type;B&&y.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(q=>q.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,q=w.length;P<q;P++){let $=w[P],O=$.shadow;if(O===void 0){Le("WebGLShadowMap:",$,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;r.copy(O.mapSize);let j=O.getFrameExtents();r.multiply(j),s.copy(O.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/j.x),r.x=s.x*j.x,O.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/j.y),r.y=s.y*j.y,O.mapSize.y=s.y));let H=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=H,O.map===null||B===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===pr){if($.isPointLight){Le("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new Ft(r.x,r.y,{format:mi,type:bn,minFilter:Vt,magFilter:Vt,generateMipmaps:!1}),O.map.texture.name=$.name+".shadowMap",O.map.depthTexture=new xn(r.x,r.y,dn),O.map.depthTexture.name=$.name+".shadowMapDepth",O.map.depthTexture.format=Xn,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=Et,O.map.depthTexture.magFilter=Et}else $.isPointLight?(O.map=new ys(r.x),O.map.depthTexture=new Jr(r.x,tn)):(O.map=new Ft(r.x,r.y),O.map.depthTexture=new xn(r.x,r.y,tn)),O.map.depthTexture.name=$.name+".shadowMap",O.map.depthTexture.format=Xn,this.type===os?(O.map.depthTexture.compareFunction=H?bc:vc,O.map.depthTexture.minFilter=Vt,O.map.depthTexture.magFilter=Vt):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=Et,O.map.depthTexture.magFilter=Et);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==r.x||O.map.height!==r.y)&&O.map.setSize(r.x,r.y);let Q=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();$.isPointLight!==!0&&O.updateMatrices($,T);let te=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:T.layers;for(let ne=0;ne<Q;ne++){let he=O.getCamera(ne);if($.isPointLight){let X=O.camera,me=O.matrix,be=$.distance||X.far;be!==X.far&&(X.far=be,X.updateProjectionMatrix()),gs.setFromMatrixPosition($.matrixWorld),X.position.copy(gs),Rc.copy(X.position),Rc.add(Gv[ne]),X.up.copy(Vv[ne]),X.lookAt(Rc),X.updateMatrixWorld(),me.makeTranslation(-gs.x,-gs.y,-gs.z),of.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),O._frustum.setFromProjectionMatrix(of,X.coordinateSystem,X.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,ne),n.clear();else{ne===0&&(n.setRenderTarget(O.map),n.clear());let X=O.getViewport(ne);o.set(s.x*X.x,s.y*X.y,s.x*X.z,s.y*X.w),N.viewport(o)}i=O.getFrustum(ne),x(y,T,he,$,te,this.type)}O.isPointLightShadow!==!0&&this.type===pr&&S(O,T),O.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(L,C,D)};function S(w,y){let T=e.update(v);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new Ft(r.x,r.y,{format:mi,type:bn}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(y,null,T,d,v,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(y,null,T,f,v,null)}a(S,"VSMPass");function A(w,y,T,L){let C=null,D=T.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(D!==void 0)C=D;else if(C=T.isPointLight===!0?c:l,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let N=C.uuid,B=y.uuid,P=u[N];P===void 0&&(P={},u[N]=P);let q=P[B];q===void 0&&(q=C.clone(),P[B]=q,y.addEventListener("dispose",b)),C=q}if(C.visible=y.visible,C.wireframe=y.wireframe,L===pr?C.side=y.shadowSide!==null?y.shadowSide:y.side:C.side=y.shadowSide!==null?y.shadowSide:p[y.side],C.alphaMap=y.alphaMap,C.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,C.map=y.map,C.clipShadows=y.clipShadows,C.clippingPlanes=y.clippingPlanes,C.clipIntersection=y.clipIntersection,C.displacementMap=y.displacementMap,C.displacementScale=y.displacementScale,C.displacementBias=y.displacementBias,C.wireframeLinewidth=y.wireframeLinewidth,C.linewidth=y.linewidth,T.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let N=n.properties.get(C);N.light=T}return C}a(A,"getDepthMaterial");function x(w,y,T,L,C,D){if(w.visible===!1)return;if(w.layers.test(C)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&D===pr)&&(!w.frustumCulled||w.intersectsFrustum(i))){w.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,w.matrixWorld);let P=e.update(w),q=w.material;if(Array.isArray(q)){let $=P.groups;for(let O=0,j=$.length;O<j;O++){let H=$[O],Q=q[H.materialIndex];if(Q&&Q.visible){let te=A(w,Q,L,D);w.onBeforeShadow(n,w,y,T,P,te,H),n.renderBufferDirect(T,null,P,te,w,H),w.onAfterShadow(n,w,y,T,P,te,H)}}}else if(q.visible){let $=A(w,q,L,D);w.onBeforeShadow(n,w,y,T,P,$,null),n.renderBufferDirect(T,null,P,$,w,null),w.onAfterShadow(n,w,y,T,P,$,null)}}let B=w.children;for(let P=0,q=B.length;P<q;P++)x(B[P],y,T,L,C,D)}a(x,"renderObject");function b(w){w.target.removeEventListener("dispose",b);for(let T in u){let L=u[T],C=w.target.uuid;C in L&&(L[C].dispose(),delete L[C])}}a(b,"onMaterialDispose")}a(Hv,"WebGLShadowMap");function Wv(n,e){function t(){let I=!1,K=new nt,Y=null,ce=new nt(0,0,0,0);return{setMask:a(function(se){Y!==se&&!I&&(n.colorMask(se,se,se,se),Y=se)},"setMask"),setLocked:a(function(se){I=se},"setLocked"),setClear:a(function(se,ae,Te,ke,re){re===!0&&(se*=ke,ae*=ke,Te*=ke),K.set(se,ae,Te,ke),ce.equals(K)===!1&&(n.clearColor(se,ae,Te,ke),ce.copy(K))},"setClear"),reset:a(function(){I=!1,Y=null,ce.set(-1,0,0,0)},"reset")}}a(t,"ColorBuffer");function i(){let I=!1,K=!1,Y=null,ce=null,se=null;return{setReversed:a(function(ae){if(K!==ae){let Te=e.get("EXT_clip_control");ae?Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.ZERO_TO_ONE_EXT):Te.clipControlEXT(Te.LOWER_LEFT_EXT,Te.NEGATIVE_ONE_TO_ONE_EXT),K=ae;let ke=se;se=null,this.setClear(ke)}},"setReversed"),getReversed:a(function(){return K},"getReversed"),setTest:a(function(ae){ae?ge(n.DEPTH_TEST):Ne(n.DEPTH_TEST)},"setTest"),setMask:a(function(ae){Y!==ae&&!I&&(n.depthMask(ae),Y=ae)},"setMask"),setFunc:a(function(ae){if(K&&(ae=Id[ae]),ce!==ae){switch(ae){case ho:n.depthFunc(n.NEVER);break;case fo:n.depthFunc(n.ALWAYS);break;case po:n.depthFunc(n.LESS);break;case ar:n.depthFunc(n.LEQUAL);break;case mo:n.depthFunc(n.EQUAL);break;case go:n.depthFunc(n.GEQUAL);break;case _o:n.depthFunc(n.GREATER);break;case yo:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}ce=ae}},"setFunc"),setLocked:a(function(ae){I=ae},"setLocked"),setClear:a(function(ae){se!==ae&&(se=ae,K&&(ae=1-ae),n.clearDepth(ae))},"setClear"),reset:a(function(){I=!1,Y=null,ce=null,se=null,K=!1},"reset")}}a(i,"DepthBuffer");function r(){let I=!1,K=null,Y=null,ce=null,se=null,ae=null,Te=null,ke=null,re=null;return{setTest:a(function(Ae){I||(Ae?ge(n.STENCIL_TEST):Ne(n.STENCIL_TEST))},"setTest"),setMask:a(function(Ae){K!==Ae&&!I&&(n.stencilMask(Ae),K=Ae)},"setMask"),setFunc:a(function(Ae,Be,_e){(Y!==Ae||ce!==Be||se!==_e)&&(n.stencilFunc(Ae,Be,_e),Y=Ae,ce=Be,se=_e)},"setFunc"),setOp:a(function(Ae,Be,_e){(ae!==Ae||Te!==Be||ke!==_e)&&(n.stencilOp(Ae,Be,_e),ae=Ae,Te=Be,ke=_e)},"setOp"),setLocked:a(function(Ae){I=Ae},"setLocked"),setClear:a(function(Ae){re!==Ae&&(n.clearStencil(Ae),re=Ae)},"setClear"),reset:a(function(){I=!1,K=null,Y=null,ce=null,se=null,ae=null,Te=null,ke=null,re=null},"reset")}}a(r,"StencilBuffer");let s=new t,o=new i,l=new r,c={},u=new WeakMap,h={},p={},d={},f=new WeakMap,_=[],v=null,g=!1,m=null,S=null,A=null,x=null,b=null,w=null,y=null,T=new ze(0,0,0),L=0,C=!1,D=null,N=null,B=null,P=null,q=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,j=0,H=n.getParameter(n.VERSION);H.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(H)[1]),O=j>=1):H.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(H)[1]),O=j>=2);let Q=null,te={},ne=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),X=new nt().fromArray(ne),me=new nt().fromArray(he);function be(I,K,Y,ce){let se=new Uint8Array(4),ae=n.createTexture();n.bindTexture(I,ae),n.texParameteri(I,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(I,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Te=0;Te<Y;Te++)I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY?n.texImage3D(K,0,n.RGBA,1,1,ce,0,n.RGBA,n.UNSIGNED_BYTE,se):n.texImage2D(K+Te,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,se);return ae}a(be,"createTexture");let Re={};Re[n.TEXTURE_2D]=be(n.TEXTURE_2D,n.TEXTURE_2D,1),Re[n.TEXTURE_CUBE_MAP]=be(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[n.TEXTURE_2D_ARRAY]=be(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Re[n.TEXTURE_3D]=be(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),l.setClear(0),ge(n.DEPTH_TEST),o.setFunc(ar),Wt(!1),ct(nc),ge(n.CULL_FACE),Rt(Yn);function ge(I){h[I]!==!0&&(n.enable(I),h[I]=!0)}a(ge,"enable");function Ne(I){h[I]!==!1&&(n.disable(I),h[I]=!1)}a(Ne,"disable");function ot(I,K){return d[I]!==K?(n.bindFramebuffer(I,K),d[I]=K,I===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=K),I===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=K),!0):!1}a(ot,"bindFramebuffer");function Ie(I,K){let Y=_,ce=!1;if(I){Y=f.get(K),Y===void 0&&(Y=[],f.set(K,Y));let se=I.textures;if(Y.length!==se.length||Y[0]!==n.COLOR_ATTACHMENT0){for(let ae=0,Te=se.length;ae<Te;ae++)Y[ae]=n.COLOR_ATTACHMENT0+ae;Y.length=se.length,ce=!0}}else Y[0]!==n.BACK&&(Y[0]=n.BACK,ce=!0);ce&&n.drawBuffers(Y)}a(Ie,"drawBuffers");function Ke(I){return v!==I?(n.useProgram(I),v=I,!0):!1}a(Ke,"useProgram");let et={[Di]:n.FUNC_ADD,[ed]:n.FUNC_SUBTRACT,[td]:n.FUNC_REVERSE_SUBTRACT};et[nd]=n.MIN,et[id]=n.MAX;let He={[rd]:n.ZERO,[_r]:n.ONE,[sd]:n.SRC_COLOR,[as]:n.SRC_ALPHA,[hd]:n.SRC_ALPHA_SATURATE,[cd]:n.DST_COLOR,[ad]:n.DST_ALPHA,[od]:n.ONE_MINUS_SRC_COLOR,[pi]:n.ONE_MINUS_SRC_ALPHA,[ud]:n.ONE_MINUS_DST_COLOR,[ld]:n.ONE_MINUS_DST_ALPHA,[dd]:n.CONSTANT_COLOR,[fd]:n.ONE_MINUS_CONSTANT_COLOR,[pd]:n.CONSTANT_ALPHA,[md]:n.ONE_MINUS_CONSTANT_ALPHA};function Rt(I,K,Y,ce,se,ae,Te,ke,re,Ae){if(I===Yn){g===!0&&(Ne(n.BLEND),g=!1);return}if(g===!1&&(ge(n.BLEND),g=!0),I!==gr){if(I!==m||Ae!==C){if((S!==Di||b!==Di)&&(n.blendEquation(n.FUNC_ADD),S=Di,b=Di),Ae)switch(I){case mr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ic:n.blendFunc(n.ONE,n.ONE);break;case rc:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case sc:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:De("WebGLState: Invalid blending: ",I);break}else switch(I){case mr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ic:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case rc:De("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case sc:De("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:De("WebGLState: Invalid blending: ",I);break}A=null,x=null,w=null,y=null,T.set(0,0,0),L=0,m=I,C=Ae}return}se=se||K,ae=ae||Y,Te=Te||ce,(K!==S||se!==b)&&(n.blendEquationSeparate(et[K],et[se]),S=K,b=se),(Y!==A||ce!==x||ae!==w||Te!==y)&&(n.blendFuncSeparate(He[Y],He[ce],He[ae],He[Te]),A=Y,x=ce,w=ae,y=Te),(ke.equals(T)===!1||re!==L)&&(n.blendColor(ke.r,ke.g,ke.b,re),T.copy(ke),L=re),m=I,C=!1}a(Rt,"setBlending");function gt(I,K){I.side===hn?Ne(n.CULL_FACE):ge(n.CULL_FACE);let Y=I.side===Ht;K&&(Y=!Y),Wt(Y),I.blending===mr&&I.transparent===!1?Rt(Yn):Rt(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),o.setFunc(I.depthFunc),o.setTest(I.depthTest),o.setMask(I.depthWrite),s.setMask(I.colorWrite);let ce=I.stencilWrite;l.setTest(ce),ce&&(l.setMask(I.stencilWriteMask),l.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),l.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),vt(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?ge(n.SAMPLE_ALPHA_TO_COVERAGE):Ne(n.SAMPLE_ALPHA_TO_COVERAGE)}a(gt,"setMaterial");function Wt(I){D!==I&&(I?n.frontFace(n.CW):n.frontFace(n.CCW),D=I)}a(Wt,"setFlipSided");function ct(I){I!==Kh?(ge(n.CULL_FACE),I!==N&&(I===nc?n.cullFace(n.BACK):I===jh?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ne(n.CULL_FACE),N=I}a(ct,"setCullFace");function Mn(I){I!==B&&(O&&n.lineWidth(I),B=I)}a(Mn,"setLineWidth");function vt(I,K,Y){I?(ge(n.POLYGON_OFFSET_FILL),(P!==K||q!==Y)&&(P=K,q=Y,o.getReversed()&&(K=-K,Y=-Y),n.polygonOffset(K,Y))):Ne(n.POLYGON_OFFSET_FILL)}a(vt,"setPolygonOffset");function rn(I){I?ge(n.SCISSOR_TEST):Ne(n.SCISSOR_TEST)}a(rn,"setScissorTest");function sn(I){I===void 0&&(I=n.TEXTURE0+$-1),Q!==I&&(n.activeTexture(I),Q=I)}a(sn,"activeTexture");function on(I,K,Y){Y===void 0&&(Q===null?Y=n.TEXTURE0+$-1:Y=Q);let ce=te[Y];ce===void 0&&(ce={type:void 0,texture:void 0},te[Y]=ce),(ce.type!==I||ce.texture!==K)&&(Q!==Y&&(n.activeTexture(Y),Q=Y),n.bindTexture(I,K||Re[I]),ce.type=I,ce.texture=K)}a(on,"bindTexture");function F(){let I=te[Q];I!==void 0&&I.type!==void 0&&(n.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}a(F,"unbindTexture");function an(){try{n.compressedTexImage2D(...arguments)}catch(I){De("WebGLState:",I)}}a(an,"compressedTexImage2D");function at(){try{n.compressedTexImage3D(...arguments)}catch(I){De("WebGLState:",I)}}a(at,"compressedTexImage3D");function lt(){try{n.texSubImage2D(...arguments)}catch(I){De("WebGLState:",I)}}a(lt,"texSubImage2D");function pe(){try{n.texSubImage3D(...arguments)}catch(I){De("WebGLState:",I)}}a(pe,"texSubImage3D");function _t(){try{n.compressedTexSubImage2D(...arguments)}catch(I){De("WebGLState:",I)}}a(_t,"compressedTexSubImage2D");function Pe(){try{n.compressedTexSubImage3D(...arguments)}catch(I){De("WebGLState:",I)}}a(Pe,"compressedTexSubImage3D");function Oe(){try{n.texStorage2D(...arguments)}catch(I){De("WebGLState:",I)}}a(Oe,"texStorage2D");function R(){try{n.texStorage3D(...arguments)}catch(I){De("WebGLState:",I)}}a(R,"texStorage3D");function M(){try{n.texImage2D(...arguments)}catch(I){De("WebGLState:",I)}}a(M,"texImage2D");function z(){try{n.texImage3D(...arguments)}catch(I){De("WebGLState:",I)}}a(z,"texImage3D");function ie(I){return p[I]!==void 0?p[I]:n.getParameter(I)}a(ie,"getParameter");function ee(I,K){p[I]!==K&&(n.pixelStorei(I,K),p[I]=K)}a(ee,"pixelStorei");function oe(I){X.equals(I)===!1&&(n.scissor(I.x,I.y,I.z,I.w),X.copy(I))}a(oe,"scissor");function de(I){me.equals(I)===!1&&(n.viewport(I.x,I.y,I.z,I.w),me.copy(I))}a(de,"viewport");function J(I,K){let Y=u.get(K);Y===void 0&&(Y=new WeakMap,u.set(K,Y));let ce=Y.get(I);ce===void 0&&(ce=n.getUniformBlockIndex(K,I.name),n.uniformBlockBinding(K,ce,ce),Y.set(I,ce))}a(J,"updateUBOMapping");function Z(I,K,Y){let se=u.get(K).get(I);c[se]!==Y&&(n.bindBufferBase(n.UNIFORM_BUFFER,se,Y),c[se]=Y)}a(Z,"uniformBlockBinding");function le(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},p={},Q=null,te={},d={},c={},f=new WeakMap,_=[],v=null,g=!1,m=null,S=null,A=null,x=null,b=null,w=null,y=null,T=new ze(0,0,0),L=0,C=!1,D=null,N=null,B=null,P=null,q=null,X.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),l.reset()}return a(le,"reset"),{buffers:{color:s,depth:o,stencil:l},enable:ge,disable:Ne,bindFramebuffer:ot,drawBuffers:Ie,useProgram:Ke,setBlending:Rt,setMaterial:gt,setFlipSided:Wt,setCullFace:ct,setLineWidth:Mn,setPolygonOffset:vt,setScissorTest:rn,activeTexture:sn,bindTexture:on,unbindTexture:F,compressedTexImage2D:an,compressedTexImage3D:at,texImage2D:M,texImage3D:z,pixelStorei:ee,getParameter:ie,updateUBOMapping:J,uniformBlockBinding:Z,texStorage2D:Oe,texStorage3D:R,texSubImage2D:lt,texSubImage3D:pe,compressedTexSubImage2D:_t,compressedTexSubImage3D:Pe,scissor:oe,viewport:de,reset:le}}a(Wv,"WebGLState");function Xv(n,e,t,i,r,s,o){let l=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),u=new Ve,h=new WeakMap,p=new Set,d,f=new WeakMap,_=new Set,v=new FinalizationRegistry(R=>_.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,M){return g?new OffscreenCanvas(R,M):kr("canvas")}a(m,"createCanvas");function S(R,M,z){let ie=1,ee=Oe(R);if((ee.width>z||ee.height>z)&&(ie=z/Math.max(ee.width,ee.height)),ie<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let oe=Math.floor(ie*ee.width),de=Math.floor(ie*ee.height);d===void 0&&(d=m(oe,de));let J=M?m(oe,de):d;return J.width=oe,J.height=de,J.getContext("2d").drawImage(R,0,0,oe,de),Le("WebGLRenderer: Texture has been resized from ("+ee.width+"x"+ee.height+") to ("+oe+"x"+de+")."),J}else return"data"in R&&Le("WebGLRenderer: Image in DataTexture is too big ("+ee.width+"x"+ee.height+")."),R;return R}a(S,"resizeImage");function A(R){return R.generateMipmaps}a(A,"textureNeedsGenerateMipmaps");function x(R){n.generateMipmap(R)}a(x,"generateMipmap");function b(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}a(b,"getTargetType");function w(R,M,z,ie,ee,oe=!1){if(R!==null){if(n[R]!==void 0)return n[R];Le("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let de;ie&&(de=e.get("EXT_texture_norm16"),de||Le("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let J=M;if(M===n.RED&&(z===n.FLOAT&&(J=n.R32F),z===n.HALF_FLOAT&&(J=n.R16F),z===n.UNSIGNED_BYTE&&(J=n.R8),z===n.UNSIGNED_SHORT&&de&&(J=de.R16_EXT),z===n.SHORT&&de&&(J=de.R16_SNORM_EXT)),M===n.RED_INTEGER&&(z===n.UNSIGNED_BYTE&&(J=n.R8UI),z===n.UNSIGNED_SHORT&&(J=n.R16UI),z===n.UNSIGNED_INT&&(J=n.R32UI),z===n.BYTE&&(J=n.R8I),z===n.SHORT&&(J=n.R16I),z===n.INT&&(J=n.R32I)),M===n.RG&&(z===n.FLOAT&&(J=n.RG32F),z===n.HALF_FLOAT&&(J=n.RG16F),z===n.UNSIGNED_BYTE&&(J=n.RG8),z===n.UNSIGNED_SHORT&&de&&(J=de.RG16_EXT),z===n.SHORT&&de&&(J=de.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(z===n.UNSIGNED_BYTE&&(J=n.RG8UI),z===n.UNSIGNED_SHORT&&(J=n.RG16UI),z===n.UNSIGNED_INT&&(J=n.RG32UI),z===n.BYTE&&(J=n.RG8I),z===n.SHORT&&(J=n.RG16I),z===n.INT&&(J=n.RG32I)),M===n.RGB_INTEGER&&(z===n.UNSIGNED_BYTE&&(J=n.RGB8UI),z===n.UNSIGNED_SHORT&&(J=n.RGB16UI),z===n.UNSIGNED_INT&&(J=n.RGB32UI),z===n.BYTE&&(J=n.RGB8I),z===n.SHORT&&(J=n.RGB16I),z===n.INT&&(J=n.RGB32I)),M===n.RGBA_INTEGER&&(z===n.UNSIGNED_BYTE&&(J=n.RGBA8UI),z===n.UNSIGNED_SHORT&&(J=n.RGBA16UI),z===n.UNSIGNED_INT&&(J=n.RGBA32UI),z===n.BYTE&&(J=n.RGBA8I),z===n.SHORT&&(J=n.RGBA16I),z===n.INT&&(J=n.RGBA32I)),M===n.RGB&&(z===n.UNSIGNED_SHORT&&de&&(J=de.RGB16_EXT),z===n.SHORT&&de&&(J=de.RGB16_SNORM_EXT),z===n.UNSIGNED_INT_5_9_9_9_REV&&(J=n.RGB9_E5),z===n.UNSIGNED_INT_10F_11F_11F_REV&&(J=n.R11F_G11F_B10F)),M===n.RGBA){let Z=oe?Fr:qe.getTransfer(ee);z===n.FLOAT&&(J=n.RGBA32F),z===n.HALF_FLOAT&&(J=n.RGBA16F),z===n.UNSIGNED_BYTE&&(J=Z===Ze?n.SRGB8_ALPHA8:n.RGBA8),z===n.UNSIGNED_SHORT&&de&&(J=de.RGBA16_EXT),z===n.SHORT&&de&&(J=de.RGBA16_SNORM_EXT),z===n.UNSIGNED_SHORT_4_4_4_4&&(J=n.RGBA4),z===n.UNSIGNED_SHORT_5_5_5_1&&(J=n.RGB5_A1)}return(J===n.R16F||J===n.R32F||J===n.RG16F||J===n.RG32F||J===n.RGBA16F||J===n.RGBA32F)&&e.get("EXT_color_buffer_float"),J}a(w,"getInternalFormat");function y(R,M){let z;return R?M===null||M===tn||M===Oi?z=n.DEPTH24_STENCIL8:M===dn?z=n.DEPTH32F_STENCIL8:M===xr&&(z=n.DEPTH24_STENCIL8,Le("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===tn||M===Oi?z=n.DEPTH_COMPONENT24:M===dn?z=n.DEPTH_COMPONENT32F:M===xr&&(z=n.DEPTH_COMPONENT16),z}a(y,"getInternalDepthFormat");function T(R,M){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Et&&R.minFilter!==Vt?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}a(T,"getMipLevels");function L(R){let M=new WeakRef(R);i.get(R).__ref=M,_.add(M),v.register(R,M,M)}a(L,"track");function C(R){let M=i.get(R).__ref;M!==void 0&&(_.delete(M),v.unregister(M))}a(C,"untrack");function D(R){B(R.target)}a(D,"onTextureDispose");function N(R){P(R.target)}a(N,"onRenderTargetDispose");function B(R){R.removeEventListener("dispose",D),C(R),$(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&p.delete(R)}a(B,"destroyTexture");function P(R){R.removeEventListener("dispose",N),C(R),j(R)}a(P,"destroyRenderTarget");function q(){for(let R of _){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?P(M):B(M))}_.clear(),p.clear()}a(q,"dispose");function $(R){let M=i.get(R);if(M.__webglInit===void 0)return;let z=R.source,ie=f.get(z);if(ie){let ee=ie[M.__cacheKey];ee.usedTimes--,ee.usedTimes===0&&O(R),Object.keys(ie).length===0&&f.delete(z)}i.remove(R)}a($,"deallocateTexture");function O(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let z=R.source,ie=f.get(z);delete ie[M.__cacheKey],o.memory.textures--}a(O,"deleteTexture");function j(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let z=R.depthTexture;if(z&&z.renderTarget===R&&B(z),R.isWebGLCubeRenderTarget)for(let ee=0;ee<6;ee++){if(Array.isArray(M.__webglFramebuffer[ee]))for(let oe=0;oe<M.__webglFramebuffer[ee].length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[ee][oe]);else n.deleteFramebuffer(M.__webglFramebuffer[ee]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[ee])}else{if(Array.isArray(M.__webglFramebuffer))for(let ee=0;ee<M.__webglFramebuffer.length;ee++)n.deleteFramebuffer(M.__webglFramebuffer[ee]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ee=0;ee<M.__webglColorRenderbuffer.length;ee++)M.__webglColorRenderbuffer[ee]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[ee]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ie=R.textures;for(let ee=0,oe=ie.length;ee<oe;ee++){let de=i.get(ie[ee]);de.__webglTexture&&(n.deleteTexture(de.__webglTexture),o.memory.textures--),i.remove(ie[ee])}i.remove(R)}a(j,"deallocateRenderTarget");let H=0;function Q(){H=0}a(Q,"resetTextureUnits");function te(){return H}a(te,"getTextureUnits");function ne(R){H=R}a(ne,"setTextureUnits");function he(){let R=H;return R>=r.maxTextures&&Le("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),H+=1,R}a(he,"allocateTextureUnit");function X(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}a(X,"getTextureCacheKey");function me(R,M){let z=i.get(R);if(R.isVideoTexture&&_t(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&z.__version!==R.version){let ie=R.image;if(ie===null)Le("WebGLRenderer: Texture marked for update but no image data found.");else if(ie.complete===!1)Le("WebGLRenderer: Texture marked for update but image is incomplete");else{gt(z,R,M);return}}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,z.__webglTexture,n.TEXTURE0+M)}a(me,"setTexture2D");function be(R,M){let z=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){gt(z,R,M);return}else R.isExternalTexture&&(z.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,z.__webglTexture,n.TEXTURE0+M)}a(be,"setTexture2DArray");function Re(R,M){let z=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&z.__version!==R.version){gt(z,R,M);return}t.bindTexture(n.TEXTURE_3D,z.__webglTexture,n.TEXTURE0+M)}a(Re,"setTexture3D");function ge(R,M){let z=i.get(R);if(R.version>0&&z.__version!==R.version){Wt(z,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,z.__webglTexture,n.TEXTURE0+M)}a(ge,"setTextureCube");let Ne={[xo]:n.REPEAT,[Rn]:n.CLAMP_TO_EDGE,[vo]:n.MIRRORED_REPEAT},ot={[Et]:n.NEAREST,[yd]:n.NEAREST_MIPMAP_NEAREST,[ls]:n.NEAREST_MIPMAP_LINEAR,[Vt]:n.LINEAR,[Yo]:n.LINEAR_MIPMAP_NEAREST,[$n]:n.LINEAR_MIPMAP_LINEAR},Ie={[Sd]:n.NEVER,[Sc]:n.ALWAYS,[Md]:n.LESS,[vc]:n.LEQUAL,[wd]:n.EQUAL,[bc]:n.GEQUAL,[Ed]:n.GREATER,[Td]:n.NOTEQUAL};function Ke(R,M){if(M.type===dn&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Vt||M.magFilter===Yo||M.magFilter===ls||M.magFilter===$n||M.minFilter===Vt||M.minFilter===Yo||M.minFilter===ls||M.minFilter===$n)&&Le("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Ne[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Ne[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Ne[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ot[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ot[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ie[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Et||M.minFilter!==ls&&M.minFilter!==$n||M.type===dn&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let z=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,r.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}a(Ke,"setTextureParameters");function et(R,M){let z=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",D),L(M));let ie=M.source,ee=f.get(ie);ee===void 0&&(ee={},f.set(ie,ee));let oe=X(M);if(oe!==R.__cacheKey){ee[oe]===void 0&&(ee[oe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,z=!0),ee[oe].usedTimes++;let de=ee[R.__cacheKey];de!==void 0&&(ee[R.__cacheKey].usedTimes--,de.usedTimes===0&&O(M)),R.__cacheKey=oe,R.__webglTexture=ee[oe].texture}return z}a(et,"initTexture");function He(R,M,z){return Math.floor(Math.floor(R/z)/M)}a(He,"getRow");function Rt(R,M,z,ie){let oe=R.updateRanges;if(oe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,z,ie,M.data);else{oe.sort((I,K)=>I.start-K.start);let de=0;for(let I=1;I<oe.length;I++){let K=oe[de],Y=oe[I],ce=K.start+K.count,se=He(Y.start,M.width,4),ae=He(K.start,M.width,4);Y.start<=ce+1&&se===ae&&He(Y.start+Y.count-1,M.width,4)===se?K.count=Math.max(K.count,Y.start+Y.count-K.start):(++de,oe[de]=Y)}oe.length=de+1;let J=t.getParameter(n.UNPACK_ROW_LENGTH),Z=t.getParameter(n.UNPACK_SKIP_PIXELS),le=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let I=0,K=oe.length;I<K;I++){let Y=oe[I],ce=Math.floor(Y.start/4),se=Math.ceil(Y.count/4),ae=ce%M.width,Te=Math.floor(ce/M.width),ke=se,re=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,ae),t.pixelStorei(n.UNPACK_SKIP_ROWS,Te),t.texSubImage2D(n.TEXTURE_2D,0,ae,Te,ke,re,z,ie,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,J),t.pixelStorei(n.UNPACK_SKIP_PIXELS,Z),t.pixelStorei(n.UNPACK_SKIP_ROWS,le)}}a(Rt,"updateTexture");function gt(R,M,z){let ie=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ie=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ie=n.TEXTURE_3D);let ee=et(R,M),oe=M.source;t.bindTexture(ie,R.__webglTexture,n.TEXTURE0+z);let de=i.get(oe);if(oe.version!==de.__version||ee===!0){if(t.activeTexture(n.TEXTURE0+z),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let re=qe.getPrimaries(qe.workingColorSpace),Ae=M.colorSpace===Zn?null:qe.getPrimaries(M.colorSpace),Be=M.colorSpace===Zn||re===Ae?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Be)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let Z=S(M.image,!1,r.maxTextureSize);Z=Pe(M,Z);let le=s.convert(M.format,M.colorSpace),I=s.convert(M.type),K=w(M.internalFormat,le,I,M.normalized,M.colorSpace,M.isVideoTexture);Ke(ie,M);let Y,ce=M.mipmaps,se=M.isVideoTexture!==!0,ae=de.__version===void 0||ee===!0,Te=oe.dataReady,ke=T(M,Z);if(M.isDepthTexture)K=y(M.format===Jn,M.type),ae&&(se?t.texStorage2D(n.TEXTURE_2D,1,K,Z.width,Z.height):t.texImage2D(n.TEXTURE_2D,0,K,Z.width,Z.height,0,le,I,null));else if(M.isDataTexture)if(ce.length>0){se&&ae&&t.texStorage2D(n.TEXTURE_2D,ke,K,ce[0].width,ce[0].height);for(let re=0,Ae=ce.length;re<Ae;re++)Y=ce[re],se?Te&&t.texSubImage2D(n.TEXTURE_2D,re,0,0,Y.width,Y.height,le,I,Y.data):t.texImage2D(n.TEXTURE_2D,re,K,Y.width,Y.height,0,le,I,Y.data);M.generateMipmaps=!1}else se?(ae&&t.texStorage2D(n.TEXTURE_2D,ke,K,Z.width,Z.height),Te&&Rt(M,Z,le,I)):t.texImage2D(n.TEXTURE_2D,0,K,Z.width,Z.height,0,le,I,Z.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){se&&ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ke,K,ce[0].width,ce[0].height,Z.depth);for(let re=0,Ae=ce.length;re<Ae;re++)if(Y=ce[re],M.format!==Sn)if(le!==null)if(se){if(Te)if(M.layerUpdates.size>0){let Be=Tc(Y.width,Y.height,M.format,M.type);for(let _e of M.layerUpdates){let je=Y.data.subarray(_e*Be/Y.data.BYTES_PER_ELEMENT,(_e+1)*Be/Y.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,re,0,0,_e,Y.width,Y.height,1,le,je)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,re,0,0,0,Y.width,Y.height,Z.depth,le,Y.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,re,K,Y.width,Y.height,Z.depth,0,Y.data,0,0);else Le("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Te&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,re,0,0,0,Y.width,Y.height,Z.depth,le,I,Y.data):t.texImage3D(n.TEXTURE_2D_ARRAY,re,K,Y.width,Y.height,Z.depth,0,le,I,Y.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{se&&ae&&t.texStorage2D(n.TEXTURE_2D,ke,K,ce[0].width,ce[0].height);for(let re=0,Ae=ce.length;re<Ae;re++)Y=ce[re],M.format!==Sn?le!==null?se?Te&&t.compressedTexSubImage2D(n.TEXTURE_2D,re,0,0,Y.width,Y.height,le,Y.data):t.compressedTexImage2D(n.TEXTURE_2D,re,K,Y.width,Y.height,0,Y.data):Le("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Te&&t.texSubImage2D(n.TEXTURE_2D,re,0,0,Y.width,Y.height,le,I,Y.data):t.texImage2D(n.TEXTURE_2D,re,K,Y.width,Y.height,0,le,I,Y.data)}else if(M.isDataArrayTexture)if(se){if(ae&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ke,K,Z.width,Z.height,Z.depth),Te)if(M.layerUpdates.size>0){let re=Tc(Z.width,Z.height,M.format,M.type);for(let Ae of M.layerUpdates){let Be=Z.data.subarray(Ae*re/Z.data.BYTES_PER_ELEMENT,(Ae+1)*re/Z.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ae,Z.width,Z.height,1,le,I,Be)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Z.width,Z.height,Z.depth,le,I,Z.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,K,Z.width,Z.height,Z.depth,0,le,I,Z.data);else if(M.isData3DTexture)se?(ae&&t.texStorage3D(n.TEXTURE_3D,ke,K,Z.width,Z.height,Z.depth),Te&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Z.width,Z.height,Z.depth,le,I,Z.data)):t.texImage3D(n.TEXTURE_3D,0,K,Z.width,Z.height,Z.depth,0,le,I,Z.data);else if(M.isFramebufferTexture){if(ae)if(se)t.texStorage2D(n.TEXTURE_2D,ke,K,Z.width,Z.height);else{let re=Z.width,Ae=Z.height;for(let Be=0;Be<ke;Be++)t.texImage2D(n.TEXTURE_2D,Be,K,re,Ae,0,le,I,null),re>>=1,Ae>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let re=n.canvas;if(re.hasAttribute("layoutsubtree")||re.setAttribute("layoutsubtree","true"),Z.parentNode!==re){re.appendChild(Z),p.add(M),re.onpaint=Ae=>{let Be=Ae.changedElements;for(let _e of p)Be.includes(_e.image)&&(_e.needsUpdate=!0)},re.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Z);else{let Be=n.RGBA,_e=n.RGBA,je=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Be,_e,je,Z)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(ce.length>0){if(se&&ae){let re=Oe(ce[0]);t.texStorage2D(n.TEXTURE_2D,ke,K,re.width,re.height)}for(let re=0,Ae=ce.length;re<Ae;re++)Y=ce[re],se?Te&&t.texSubImage2D(n.TEXTURE_2D,re,0,0,le,I,Y):t.texImage2D(n.TEXTURE_2D,re,K,le,I,Y);M.generateMipmaps=!1}else if(se){if(ae){let re=Oe(Z);t.texStorage2D(n.TEXTURE_2D,ke,K,re.width,re.height)}Te&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,le,I,Z)}else t.texImage2D(n.TEXTURE_2D,0,K,le,I,Z);A(M)&&M.mipmapsAutoUpdate===!0&&x(ie),de.__version=oe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}a(gt,"uploadTexture");function Wt(R,M,z){if(M.image.length!==6)return;let ie=et(R,M),ee=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+z);let oe=i.get(ee);if(ee.version!==oe.__version||ie===!0){t.activeTexture(n.TEXTURE0+z);let de=qe.getPrimaries(qe.workingColorSpace),J=M.colorSpace===Zn?null:qe.getPrimaries(M.colorSpace),Z=M.colorSpace===Zn||de===J?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Z);let le=M.isCompressedTexture||M.image[0].isCompressedTexture,I=M.image[0]&&M.image[0].isDataTexture,K=[];for(let _e=0;_e<6;_e++)!le&&!I?K[_e]=S(M.image[_e],!0,r.maxCubemapSize):K[_e]=I?M.image[_e].image:M.image[_e],K[_e]=Pe(M,K[_e]);let Y=K[0],ce=s.convert(M.format,M.colorSpace),se=s.convert(M.type),ae=w(M.internalFormat,ce,se,M.normalized,M.colorSpace),Te=M.isVideoTexture!==!0,ke=oe.__version===void 0||ie===!0,re=ee.dataReady,Ae=T(M,Y);Ke(n.TEXTURE_CUBE_MAP,M);let Be;if(M.isDepthTexture){if(ae=y(M.format===Jn,M.type),ke)if(Te)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,ae,Y.width,Y.height);else for(let _e=0;_e<6;_e++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,ae,Y.width,Y.height,0,ce,se,null)}else if(le){Te&&ke&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ae,ae,Y.width,Y.height);for(let _e=0;_e<6;_e++){Be=K[_e].mipmaps;for(let je=0;je<Be.length;je++){let bt=Be[je];M.format!==Sn?ce!==null?Te?re&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je,0,0,bt.width,bt.height,ce,bt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je,ae,bt.width,bt.height,0,bt.data):Le("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je,0,0,bt.width,bt.height,ce,se,bt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je,ae,bt.width,bt.height,0,ce,se,bt.data)}}}else{if(Be=M.mipmaps,Te&&ke){Be.length>0&&Ae++;let _e=Oe(K[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ae,ae,_e.width,_e.height)}for(let _e=0;_e<6;_e++)if(I){Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,0,0,K[_e].width,K[_e].height,ce,se,K[_e].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,ae,K[_e].width,K[_e].height,0,ce,se,K[_e].data);for(let je=0;je<Be.length;je++){let Qn=Be[je].image[_e].image;Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je+1,0,0,Qn.width,Qn.height,ce,se,Qn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je+1,ae,Qn.width,Qn.height,0,ce,se,Qn.data)}}else{Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,0,0,ce,se,K[_e]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,0,ae,ce,se,K[_e]);for(let je=0;je<Be.length;je++){let bt=Be[je];Te?re&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je+1,0,0,ce,se,bt.image[_e]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_e,je+1,ae,ce,se,bt.image[_e])}}}A(M)&&M.mipmapsAutoUpdate===!0&&x(n.TEXTURE_CUBE_MAP),oe.__version=ee.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}a(Wt,"uploadCubeTexture");function ct(R,M,z,ie,ee,oe){let de=s.convert(z.format,z.colorSpace),J=s.convert(z.type),Z=w(z.internalFormat,de,J,z.normalized,z.colorSpace),le=i.get(M),I=i.get(z);if(I.__renderTarget=M,!le.__hasExternalTextures){let K=Math.max(1,M.width>>oe),Y=Math.max(1,M.height>>oe);ee===n.TEXTURE_3D||ee===n.TEXTURE_2D_ARRAY?t.texImage3D(ee,oe,Z,K,Y,M.depth,0,de,J,null):t.texImage2D(ee,oe,Z,K,Y,0,de,J,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),pe(M)?l.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ie,ee,I.__webglTexture,0,lt(M)):(ee===n.TEXTURE_2D||ee>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ee<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ie,ee,I.__webglTexture,oe),t.bindFramebuffer(n.FRAMEBUFFER,null)}a(ct,"setupFrameBufferTexture");function Mn(R,M,z){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ie=M.depthTexture,ee=ie&&ie.isDepthTexture?ie.type:null,oe=y(M.stencilBuffer,ee),de=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;pe(M)?l.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),oe,M.width,M.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),oe,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,oe,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,de,n.RENDERBUFFER,R)}else{let ie=M.textures;for(let ee=0;ee<ie.length;ee++){let oe=ie[ee],de=s.convert(oe.format,oe.colorSpace),J=s.convert(oe.type),Z=w(oe.internalFormat,de,J,oe.normalized,oe.colorSpace);pe(M)?l.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),Z,M.width,M.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),Z,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,Z,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}a(Mn,"setupRenderBufferStorage");function vt(R,M,z){let ie=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ee=i.get(M.depthTexture);ee.__renderTarget=M;let oe=ie?M.depthTexture.image[0]:M.depthTexture.image;(!ee.__webglTexture||oe.width!==M.width||oe.height!==M.height)&&(oe.width=M.width,oe.height=M.height,M.depthTexture.needsUpdate=!0),ie?ge(M.depthTexture,0):me(M.depthTexture,0);let de=ee.__webglTexture,J=lt(M),Z=ie?n.TEXTURE_CUBE_MAP_POSITIVE_X+z:n.TEXTURE_2D,le=M.depthTexture.format===Jn?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Xn)pe(M)?l.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,le,Z,de,0,J):n.framebufferTexture2D(n.FRAMEBUFFER,le,Z,de,0);else if(M.depthTexture.format===Jn)pe(M)?l.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,le,Z,de,0,J):n.framebufferTexture2D(n.FRAMEBUFFER,le,Z,de,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}a(vt,"setupDepthTexture");function rn(R){let M=i.get(R),z=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ie=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ie){let ee=a(()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ie.removeEventListener("dispose",ee)},"disposeEvent");ie.addEventListener("dispose",ee),M.__depthDisposeCallback=ee}M.__boundDepthTexture=ie}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(z)for(let ie=0;ie<6;ie++)vt(M.__webglFramebuffer[ie],R,ie);else R.texture.mipmaps.length>0?vt(M.__webglFramebuffer[0],R,0):vt(M.__webglFramebuffer,R,0);else if(z){M.__webglDepthbuffer=[];for(let ie=0;ie<6;ie++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ie]),M.__webglDepthbuffer[ie]===void 0)M.__webglDepthbuffer[ie]=n.createRenderbuffer(),Mn(M.__webglDepthbuffer[ie],R,!1);else{let ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,oe=M.__webglDepthbuffer[ie];n.bindRenderbuffer(n.RENDERBUFFER,oe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,oe)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Mn(M.__webglDepthbuffer,R,!1);else{let ee=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,oe=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,oe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ee,n.RENDERBUFFER,oe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}a(rn,"setupDepthRenderbuffer");function sn(R,M,z){let ie=i.get(R);M!==void 0&&ct(ie.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),z!==void 0&&rn(R)}a(sn,"rebindTextures");function on(R){let M=R.texture,z=i.get(R),ie=i.get(M);R.addEventListener("dispose",N),L(R);let ee=R.textures,oe=R.isWebGLCubeRenderTarget===!0,de=ee.length>1;if(de||(ie.__webglTexture===void 0&&(ie.__webglTexture=n.createTexture()),ie.__version=M.version,o.memory.textures++),oe){z.__webglFramebuffer=[];for(let J=0;J<6;J++)if(M.mipmaps.length>0){z.__webglFramebuffer[J]=[];for(let Z=0;Z<M.mipmaps.length;Z++)z.__webglFramebuffer[J][Z]=n.createFramebuffer()}else z.__webglFramebuffer[J]=n.createFramebuffer()}else{if(M.mipmaps.length>0){z.__webglFramebuffer=[];for(let J=0;J<M.mipmaps.length;J++)z.__webglFramebuffer[J]=n.createFramebuffer()}else z.__webglFramebuffer=n.createFramebuffer();if(de)for(let J=0,Z=ee.length;J<Z;J++){let le=i.get(ee[J]);le.__webglTexture===void 0&&(le.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&pe(R)===!1){z.__webglMultisampledFramebuffer=n.createFramebuffer(),z.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let J=0;J<ee.length;J++){let Z=ee[J];z.__webglColorRenderbuffer[J]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,z.__webglColorRenderbuffer[J]);let le=s.convert(Z.format,Z.colorSpace),I=s.convert(Z.type),K=w(Z.internalFormat,le,I,Z.normalized,Z.colorSpace,R.isXRRenderTarget===!0),Y=lt(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,Y,K,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+J,n.RENDERBUFFER,z.__webglColorRenderbuffer[J])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(z.__webglDepthRenderbuffer=n.createRenderbuffer(),Mn(z.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(oe){t.bindTexture(n.TEXTURE_CUBE_MAP,ie.__webglTexture),Ke(n.TEXTURE_CUBE_MAP,M);for(let J=0;J<6;J++)if(M.mipmaps.length>0)for(let Z=0;Z<M.mipmaps.length;Z++)ct(z.__webglFramebuffer[J][Z],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+J,Z);else ct(z.__webglFramebuffer[J],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+J,0);A(M)?x(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(de){for(let J=0,Z=ee.length;J<Z;J++){let le=ee[J],I=i.get(le),K=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(K=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(K,I.__webglTexture),Ke(K,le),ct(z.__webglFramebuffer,R,le,n.COLOR_ATTACHMENT0+J,K,0),A(le)&&x(K)}t.unbindTexture()}else{let J=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(J=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(J,ie.__webglTexture),Ke(J,M),M.mipmaps.length>0)for(let Z=0;Z<M.mipmaps.length;Z++)ct(z.__webglFramebuffer[Z],R,M,n.COLOR_ATTACHMENT0,J,Z);else ct(z.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,J,0);A(M)?x(J):M.mipmaps.length>0&&n.texParameteri(J,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&rn(R)}a(on,"setupRenderTarget");function F(R){let M=R.textures;for(let z=0,ie=M.length;z<ie;z++){let ee=M[z];if(A(ee)&&ee.mipmapsAutoUpdate===!0){let oe=b(R),de=i.get(ee).__webglTexture;t.bindTexture(oe,de),x(oe),t.unbindTexture()}}}a(F,"updateRenderTargetMipmap");let an=[];function at(R){if(R.samples>0){if(pe(R)===!1){let M=R.textures,z=R.width,ie=R.height,ee=n.COLOR_BUFFER_BIT,oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,de=i.get(R),J=M.length>1;if(J)for(let le=0;le<M.length;le++)t.bindFramebuffer(n.FRAMEBUFFER,de.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,de.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,de.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,de.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,de.__webglFramebuffer);for(let le=0;le<M.length;le++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ee|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ee|=n.STENCIL_BUFFER_BIT)),J){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,de.__webglColorRenderbuffer[le]);let I=i.get(M[le]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,I,0)}n.blitFramebuffer(0,0,z,ie,0,0,z,ie,ee,n.NEAREST),c===!0&&(an.length=0,an.push(n.COLOR_ATTACHMENT0+le),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&an.push(oe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,an))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),J)for(let le=0;le<M.length;le++){t.bindFramebuffer(n.FRAMEBUFFER,de.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.RENDERBUFFER,de.__webglColorRenderbuffer[le]);let I=i.get(M[le]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,de.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+le,n.TEXTURE_2D,I,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,de.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&c){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}a(at,"updateMultisampleRenderTarget");function lt(R){return Math.min(r.maxSamples,R.samples)}a(lt,"getRenderTargetSamples");function pe(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}a(pe,"useMultisampledRTT");function _t(R){let M=o.render.frame;h.get(R)!==M&&(h.set(R,M),R.update())}a(_t,"updateVideoTexture");function Pe(R,M){let z=R.colorSpace,ie=R.format,ee=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||z!==Or&&z!==Zn&&(qe.getTransfer(z)===Ze?(ie!==Sn||ee!==en)&&Le("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):De("WebGLTextures: Unsupported texture color space:",z)),M}a(Pe,"verifyColorSpace");function Oe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(u.width=R.naturalWidth||R.width,u.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(u.width=R.displayWidth,u.height=R.displayHeight):(u.width=R.width,u.height=R.height),u}a(Oe,"getDimensions"),this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=te,this.setTextureUnits=ne,this.setTexture2D=me,this.setTexture2DArray=be,this.setTexture3D=Re,this.setTextureCube=ge,this.rebindTextures=sn,this.setupRenderTarget=on,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=at,this.setupDepthRenderbuffer=rn,this.setupFrameBufferTexture=ct,this.useMultisampledRTT=pe,this.dispose=q}a(Xv,"WebGLTextures");function qv(n,e){function t(i,r=Zn){let s,o=qe.getTransfer(r);if(i===en)return n.UNSIGNED_BYTE;if(i===Jo)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Zo)return n.UNSIGNED_SHORT_5_5_5_1;if(i===gc)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===_c)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===pc)return n.BYTE;if(i===mc)return n.SHORT;if(i===xr)return n.UNSIGNED_SHORT;if(i===$o)return n.INT;if(i===tn)return n.UNSIGNED_INT;if(i===dn)return n.FLOAT;if(i===bn)return n.HALF_FLOAT;if(i===yc)return n.ALPHA;if(i===xc)return n.RGB;if(i===Sn)return n.RGBA;if(i===Xn)return n.DEPTH_COMPONENT;if(i===Jn)return n.DEPTH_STENCIL;if(i===Ko)return n.RED;if(i===jo)return n.RED_INTEGER;if(i===mi)return n.RG;if(i===Qo)return n.RG_INTEGER;if(i===ea)return n.RGBA_INTEGER;if(i===cs||i===us||i===hs||i===ds)if(o===Ze)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===cs)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===us)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===hs)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ds)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===cs)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===us)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===hs)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ds)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ta||i===na||i===ia||i===ra)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===ta)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===na)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ia)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ra)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===sa||i===oa||i===aa||i===la||i===ca||i===fs||i===ua)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===sa||i===oa)return o===Ze?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===aa)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===la)return s.COMPRESSED_R11_EAC;if(i===ca)return s.COMPRESSED_SIGNED_R11_EAC;if(i===fs)return s.COMPRESSED_RG11_EAC;if(i===ua)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===ha||i===da||i===fa||i===pa||i===ma||i===ga||i===_a||i===ya||i===xa||i===va||i===ba||i===Sa||i===Ma||i===wa)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===ha)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===da)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===fa)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===pa)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ma)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ga)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===_a)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===ya)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===xa)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===va)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ba)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Sa)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ma)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===wa)return o===Ze?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Ea||i===Ta||i===Aa)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Ea)return o===Ze?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ta)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Aa)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ra||i===Ca||i===ps||i===Pa)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Ra)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Ca)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ps)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Pa)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Oi?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return a(t,"convert"),{convert:t}}a(qv,"WebGLUtils");var Yv=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,$v=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Uc=class{static{a(this,"WebXRDepthSensing")}constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Ni(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ln({vertexShader:Yv,fragmentShader:$v,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new st(new jr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Oc=class extends Cn{static{a(this,"WebXRManager")}constructor(e,t){super();let i=this,r=null,s=1,o=null,l="local-floor",c=1,u=null,h=null,p=null,d=null,f=null,_=null,v=typeof XRWebGLBinding<"u",g=new Uc,m={},S=t.getContextAttributes(),A=null,x=null,b=[],w=[],y=new Ve,T=null,L=null,C=new Gt;C.viewport=new nt;let D=new Gt;D.viewport=new nt;let N=[C,D],B=new Ho,P=null,q=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(X){let me=b[X];return me===void 0&&(me=new ur,b[X]=me),me.getTargetRaySpace()},this.getControllerGrip=function(X){let me=b[X];return me===void 0&&(me=new ur,b[X]=me),me.getGripSpace()},this.getHand=function(X){let me=b[X];return me===void 0&&(me=new ur,b[X]=me),me.getHandSpace()};function $(X){let me=w.indexOf(X.inputSource);if(me===-1)return;let be=b[me];be!==void 0&&(be.update(X.inputSource,X.frame,u||o),be.dispatchEvent({type:X.type,data:X.inputSource}))}a($,"onSessionEvent");function O(){r.removeEventListener("select",$),r.removeEventListener("selectstart",$),r.removeEventListener("selectend",$),r.removeEventListener("squeeze",$),r.removeEventListener("squeezestart",$),r.removeEventListener("squeezeend",$),r.removeEventListener("end",O),r.removeEventListener("inputsourceschange",j);for(let X=0;X<b.length;X++){let me=w[X];me!==null&&(w[X]=null,b[X].disconnect(me))}P=null,q=null,g.reset();for(let X in m)delete m[X];if(e.setRenderTarget(A),f=null,d=null,p=null,r=null,x=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(y.width,y.height,!1),L!==null){let X=L.camera;X.fov=L.fov,X.zoom=L.zoom,X.updateProjectionMatrix(),L=null}i.dispatchEvent({type:"sessionend"})}a(O,"onSessionEnd"),this.setFramebufferScaleFactor=function(X){s=X,i.isPresenting===!0&&Le("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(X){l=X,i.isPresenting===!0&&Le("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return u||o},this.setReferenceSpace=function(X){u=X},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return p===null&&v&&(p=new XRWebGLBinding(r,t)),p},this.getFrame=function(){return _},this.getSession=function(){return r},this.setSession=async function(X){if(r=X,r!==null){if(A=e.getRenderTarget(),r.addEventListener("select",$),r.addEventListener("selectstart",$),r.addEventListener("selectend",$),r.addEventListener("squeeze",$),r.addEventListener("squeezestart",$),r.addEventListener("squeezeend",$),r.addEventListener("end",O),r.addEventListener("inputsourceschange",j),S.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(y),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let be=null,Re=null,ge=null;S.depth&&(ge=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,be=S.stencil?Jn:Xn,Re=S.stencil?Oi:tn);let Ne={colorFormat:t.RGBA8,depthFormat:ge,scaleFactor:s};p=this.getBinding(),d=p.createProjectionLayer(Ne),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),x=new Ft(d.textureWidth,d.textureHeight,{format:Sn,type:en,depthTexture:new xn(d.textureWidth,d.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,be),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let be={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:s};f=new XRWebGLLayer(r,t,be),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),x=new Ft(f.framebufferWidth,f.framebufferHeight,{format:Sn,type:en,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(c),u=null,o=await r.requestReferenceSpace(l),he.setContext(r),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function j(X){for(let me=0;me<X.removed.length;me++){let be=X.removed[me],Re=w.indexOf(be);Re>=0&&(w[Re]=null,b[Re].disconnect(be))}for(let me=0;me<X.added.length;me++){let be=X.added[me],Re=w.indexOf(be);if(Re===-1){for(let Ne=0;Ne<b.length;Ne++)if(Ne>=w.length){w.push(be),Re=Ne;break}else if(w[Ne]===null){w[Ne]=be,Re=Ne;break}if(Re===-1)break}let ge=b[Re];ge&&ge.connect(be)}}a(j,"onInputSourcesChange");function H(X,me){me===null?X.matrixWorld.copy(X.matrix):X.matrixWorld.multiplyMatrices(me.matrixWorld,X.matrix),X.matrixWorldInverse.copy(X.matrixWorld).invert()}a(H,"updateCamera"),this.updateCamera=function(X){if(r===null)return;let me=X.near,be=X.far;g.texture!==null&&(g.depthNear>0&&(me=g.depthNear),g.depthFar>0&&(be=g.depthFar)),B.near=D.near=C.near=me,B.far=D.far=C.far=be,(P!==B.near||q!==B.far)&&(r.updateRenderState({depthNear:B.near,depthFar:B.far}),P=B.near,q=B.far),B.layers.mask=X.layers.mask|6,C.layers.mask=B.layers.mask&-5,D.layers.mask=B.layers.mask&-3;let Re=X.parent,ge=B.cameras;H(B,Re);for(let Ne=0;Ne<ge.length;Ne++)H(ge[Ne],Re);B.projectionMatrix.copy(C.projectionMatrix),B.projectionMatrixInverse.copy(C.projectionMatrixInverse),L===null&&X.isPerspectiveCamera&&(L={camera:X,fov:X.fov,zoom:X.zoom}),Q(X,B,Re)};function Q(X,me,be){be===null?X.matrix.copy(me.matrixWorld):(X.matrix.copy(be.matrixWorld),X.matrix.invert(),X.matrix.multiply(me.matrixWorld)),X.matrix.decompose(X.position,X.quaternion,X.scale),X.updateMatrixWorld(!0),X.projectionMatrix.copy(me.projectionMatrix),X.projectionMatrixInverse.copy(me.projectionMatrixInverse),X.isPerspectiveCamera&&(X.fov=So*2*Math.atan(1/X.projectionMatrix.elements[5]),X.zoom=1)}a(Q,"updateUserCamera"),this.getCamera=function(){return B},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(X){c=X,d!==null&&(d.fixedFoveation=X),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=X)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(B)},this.getCameraTexture=function(X){return m[X]};let te=null;function ne(X,me){if(h=me.getViewerPose(u||o),_=me,h!==null){let be=h.views;f!==null&&(e.setRenderTargetFramebuffer(x,f.framebuffer),e.setRenderTarget(x));let Re=!1;be.length!==B.cameras.length&&(B.cameras.length=0,Re=!0);for(let Ie=0;Ie<be.length;Ie++){let Ke=be[Ie],et=null;if(f!==null)et=f.getViewport(Ke);else{let Rt=p.getViewSubImage(d,Ke);et=Rt.viewport,Ie===0&&(e.setRenderTargetTextures(x,Rt.colorTexture,Rt.depthStencilTexture),e.setRenderTarget(x))}let He=N[Ie];He===void 0&&(He=new Gt,He.layers.enable(Ie),He.viewport=new nt,N[Ie]=He),He.matrix.fromArray(Ke.transform.matrix),He.matrix.decompose(He.position,He.quaternion,He.scale),He.projectionMatrix.fromArray(Ke.projectionMatrix),He.projectionMatrixInverse.copy(He.projectionMatrix).invert(),He.viewport.set(et.x,et.y,et.width,et.height),Ie===0&&(B.matrix.copy(He.matrix),B.matrix.decompose(B.position,B.quaternion,B.scale)),Re===!0&&B.cameras.push(He)}let ge=r.enabledFeatures;if(ge&&ge.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&v){p=i.getBinding();let Ie=p.getDepthInformation(be[0]);Ie&&Ie.isValid&&Ie.texture&&g.init(Ie,r.renderState)}if(ge&&ge.includes("camera-access")&&v){e.state.unbindTexture(),p=i.getBinding();for(let Ie=0;Ie<be.length;Ie++){let Ke=be[Ie].camera;if(Ke){let et=m[Ke];et||(et=new Ni,m[Ke]=et);let He=p.getCameraImage(Ke);et.sourceTexture=He}}}}for(let be=0;be<b.length;be++){let Re=w[be],ge=b[be];Re!==null&&ge!==void 0&&ge.update(Re,me,u||o)}te&&te(X,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),_=null}a(ne,"onAnimationFrame");let he=new af;he.setAnimationLoop(ne),this.setAnimationLoop=function(X){te=X},this.dispose=function(){}}},Jv=new Qe,_f=new Ue;_f.set(-1,0,0,0,1,0,0,0,1);function Zv(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}a(t,"refreshTransformUniform");function i(g,m){m.color.getRGB(g.fogColor.value,Mc(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}a(i,"refreshFogUniforms");function r(g,m,S,A,x){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?s(g,m):m.isMeshLambertMaterial?(s(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(s(g,m),p(g,m)):m.isMeshPhongMaterial?(s(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(s(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,x)):m.isMeshMatcapMaterial?(s(g,m),_(g,m)):m.isMeshDepthMaterial?s(g,m):m.isMeshDistanceMaterial?(s(g,m),v(g,m)):m.isMeshNormalMaterial?s(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&l(g,m)):m.isPointsMaterial?c(g,m,S,A):m.isSpriteMaterial?u(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}a(r,"refreshMaterialUniforms");function s(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Ht&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Ht&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let S=e.get(m),A=S.envMap,x=S.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(Jv.makeRotationFromEuler(x)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(_f),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}a(s,"refreshUniformsCommon");function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}a(o,"refreshUniformsLine");function l(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}a(l,"refreshUniformsDash");function c(g,m,S,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*S,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}a(c,"refreshUniformsPoints");function u(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}a(u,"refreshUniformsSprites");function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}a(h,"refreshUniformsPhong");function p(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}a(p,"refreshUniformsToon");function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}a(d,"refreshUniformsStandard");function f(g,m,S){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Ht&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=S.texture,g.transmissionSamplerSize.value.set(S.width,S.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}a(f,"refreshUniformsPhysical");function _(g,m){m.matcap&&(g.matcap.value=m.matcap)}a(_,"refreshUniformsMatcap");function v(g,m){let S=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(S.matrixWorld),g.nearDistance.value=S.shadow.camera.near,g.farDistance.value=S.shadow.camera.far}return a(v,"refreshUniformsDistance"),{refreshFogUniforms:i,refreshMaterialUniforms:r}}a(Zv,"WebGLMaterials");function Kv(n,e,t,i){let r={},s={};function o(S,A){let x=A.program;i.uniformBlockBinding(S,x,r[S.id])}a(o,"bind");function l(S,A){let x=r[S.id];x===void 0&&(_(S),x=c(S),r[S.id]=x,S.addEventListener("dispose",g));let b=A.program;i.updateUBOMapping(S,b);let w=e.render.frame;s[S.id]!==w&&(u(S),s[S.id]=w)}a(l,"update");function c(S){let A=n.createBuffer(),x=S.__size,b=S.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,x,b),n.bindBuffer(n.UNIFORM_BUFFER,null),A}a(c,"createBuffer");function u(S){let A=r[S.id],x=S.uniforms,b=S.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let w=0,y=x.length;w<y;w++){let T=x[w];if(Array.isArray(T))for(let L=0,C=T.length;L<C;L++)h(T[L],w,L,b);else h(T,w,0,b)}n.bindBuffer(n.UNIFORM_BUFFER,null)}a(u,"updateBufferData");function h(S,A,x,b){if(d(S,A,x,b)===!0){let w=S.__offset,y=S.value;if(Array.isArray(y)){let T=0;for(let L=0;L<y.length;L++){let C=y[L],D=v(C,!0);p(C,S.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else p(y,S.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,w,S.__data)}}a(h,"updateUniform");function p(S,A,x){typeof S=="number"||typeof S=="boolean"?A[x]=S:S.isMatrix3?(A[x]=S.elements[0],A[x+1]=S.elements[1],A[x+2]=S.elements[2],A[x+3]=0,A[x+4]=S.elements[3],A[x+5]=S.elements[4],A[x+6]=S.elements[5],A[x+7]=0,A[x+8]=S.elements[6],A[x+9]=S.elements[7],A[x+10]=S.elements[8],A[x+11]=0):ArrayBuffer.isView(S)?A.set(S.subarray(0,A.length-x),x):S.toArray(A,x)}a(p,"writeUniformValue");function d(S,A,x,b){let w=S.value,y=A+"_"+x;if(Array.isArray(w)){b[y]===void 0&&(b[y]=[]);let T=b[y],L=!1;for(let C=0;C<w.length;C++)f(w[C],T,C)===!0&&(L=!0);return L}return f(w,b,y)}a(d,"hasUniformChanged");function f(S,A,x){if(A[x]===void 0)return typeof S=="number"||typeof S=="boolean"?A[x]=S:ArrayBuffer.isView(S)?A[x]=S.slice():A[x]=S.clone(),!0;{let b=A[x];if(typeof S=="number"||typeof S=="boolean"){if(b!==S)return A[x]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(b.equals(S)===!1)return b.copy(S),!0}}return!1}a(f,"hasValueChanged");function _(S){let A=S.uniforms,x=0,b=16;for(let y=0,T=A.length;y<T;y++){let L=Array.isArray(A[y])?A[y]:[A[y]];for(let C=0,D=L.length;C<D;C++){let N=L[C],B=Array.isArray(N.value)?N.value:[N.value],P=Array.isArray(A[y])||Array.isArray(N.value),q=x;for(let O=0,j=B.length;O<j;O++){let H=B[O],Q=v(H,P),te=x%b,ne=te%Q.boundary,he=te+ne;x+=ne,he!==0&&b-he<Q.storage&&(x+=b-he),O===0&&(q=x),x+=Q.storage}let $=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new $((x-q)/Float32Array.BYTES_PER_ELEMENT),N.__offset=q}}let w=x%b;return w>0&&(x+=b-w),S.__size=x,S.__cache={},this}a(_,"prepareUniformsGroup");function v(S,A){let x={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(x.boundary=4,x.storage=4):S.isVector2?(x.boundary=8,x.storage=8):S.isVector3||S.isColor?(x.boundary=16,x.storage=12):S.isVector4?(x.boundary=16,x.storage=16):S.isMatrix3?(x.boundary=16,x.storage=48):S.isMatrix4?(x.boundary=16,x.storage=64):S.isTexture?Le("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(x.boundary=16,x.storage=S.byteLength):Le("WebGLRenderer: Unsupported uniform value type.",S),A===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}a(v,"getUniformSize");function g(S){let A=S.target;A.removeEventListener("dispose",g),n.deleteBuffer(r[A.id]),delete r[A.id],delete s[A.id]}a(g,"onUniformsGroupsDispose");function m(){for(let S in r)n.deleteBuffer(r[S]);r={},s={}}return a(m,"dispose"),{bind:o,update:l,dispose:m}}a(Kv,"WebGLUniformsGroups");var jv=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Dn=null;function Qv(){return Dn===null&&(Dn=new qr(jv,16,16,mi,bn),Dn.name="DFG_LUT",Dn.minFilter=Vt,Dn.magFilter=Vt,Dn.wrapS=Rn,Dn.wrapT=Rn,Dn.generateMipmaps=!1,Dn.needsUpdate=!0),Dn}a(Qv,"getDFGLUT");var Oa=class{static{a(this,"WebGLRenderer")}constructor(e={}){let{canvas:t=Rd(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:l=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:u=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:p=!1,reversedDepthBuffer:d=!1,outputBufferType:f=en}=e;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let v=f,g=new Set([ea,Qo,jo]),m=new Set([en,tn,xr,Oi,Jo,Zo]),S=new Uint32Array(4),A=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},b=null,w=null,y=[],T=[],L=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Nn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,D=!1,N=null,B=null,P=null,q=null;this._outputColorSpace=Zt;let $=0,O=0,j=null,H=-1,Q=null,te=new nt,ne=new nt,he=null,X=new ze(0),me=0,be=t.width,Re=t.height,ge=1,Ne=null,ot=null,Ie=new nt(0,0,be,Re),Ke=new nt(0,0,be,Re),et=!1,He=new Ii,Rt=new Ao,gt=!1,Wt=!1,ct=new Qe,Mn=new G,vt=new nt,rn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function on(){return j===null?ge:1}a(on,"getTargetPixelRatio");let F=i;function an(E,U){return t.getContext(E,U)}a(an,"getContext");let at,lt,pe,_t,Pe,Oe,R,M,z,ie,ee,oe,de,J,Z,le,I,K,Y,ce,se,ae,Te;try{let E={alpha:!0,depth:r,stencil:s,antialias:l,premultipliedAlpha:c,preserveDrawingBuffer:u,powerPreference:h,failIfMajorPerformanceCaveat:p};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ae,!1),t.addEventListener("webglcontextrestored",Be,!1),t.addEventListener("webglcontextcreationerror",_e,!1),F===null){let U="webgl2";if(F=an(U,E),F===null)throw an(U)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}ke()}catch(E){throw t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",Be,!1),t.removeEventListener("webglcontextcreationerror",_e,!1),De("WebGLRenderer: "+E.message),E}function ke(){at=new ux(F),at.init(),se=new qv(F,at),lt=new Qy(F,at,e,se),pe=new Wv(F,at),lt.reversedDepthBuffer&&d&&pe.buffers.depth.setReversed(!0),B=F.createFramebuffer(),P=F.createFramebuffer(),q=F.createFramebuffer(),_t=new fx(F),Pe=new Pv,Oe=new Xv(F,at,pe,Pe,lt,se,_t),R=new cx(C),M=new m0(F),ae=new Ky(F,M),z=new hx(F,M,_t,ae),ie=new mx(F,z,M,ae,_t),K=new px(F,lt,Oe),Z=new ex(Pe),ee=new Cv(C,R,at,lt,ae,Z),oe=new Zv(C,Pe),de=new Lv,J=new Bv(at),I=new Zy(C,R,pe,ie,_,c),le=new Hv(C,ie,lt),Te=new Kv(F,_t,lt,pe),Y=new jy(F,at,_t),ce=new dx(F,at,_t),_t.programs=ee.programs,C.capabilities=lt,C.extensions=at,C.properties=Pe,C.renderLists=de,C.shadowMap=le,C.state=pe,C.info=_t}a(ke,"initGLContext"),v!==en&&(L=new _x(v,t.width,t.height,l,r,s));let re=new Oc(C,F);this.xr=re,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let E=at.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=at.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return ge},this.setPixelRatio=function(E){E!==void 0&&(ge=E,this.setSize(be,Re,!1))},this.getSize=function(E){return E.set(be,Re)},this.setSize=function(E,U,W=!0){if(re.isPresenting){Le("WebGLRenderer: Can't change size while VR device is presenting.");return}be=E,Re=U,t.width=Math.floor(E*ge),t.height=Math.floor(U*ge),W===!0&&(t.style.width=E+"px",t.style.height=U+"px"),L!==null&&L.setSize(t.width,t.height),this.setViewport(0,0,E,U)},this.getDrawingBufferSize=function(E){return E.set(be*ge,Re*ge).floor()},this.setDrawingBufferSize=function(E,U,W){be=E,Re=U,ge=W,t.width=Math.floor(E*W),t.height=Math.floor(U*W),this.setViewport(0,0,E,U)},this.setEffects=function(E){if(v===en){De("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let U=0;U<E.length;U++)if(E[U].isOutputPass===!0){Le("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}L.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(te)},this.getViewport=function(E){return E.copy(Ie)},this.setViewport=function(E,U,W,k){E.isVector4?Ie.set(E.x,E.y,E.z,E.w):Ie.set(E,U,W,k),pe.viewport(te.copy(Ie).multiplyScalar(on()).round())},this.getScissor=function(E){return E.copy(Ke)},this.setScissor=function(E,U,W,k){E.isVector4?Ke.set(E.x,E.y,E.z,E.w):Ke.set(E,U,W,k),pe.scissor(ne.copy(Ke).multiplyScalar(on()).round())},this.getScissorTest=function(){return et},this.setScissorTest=function(E){pe.setScissorTest(et=E)},this.setOpaqueSort=function(E){Ne=E},this.setTransparentSort=function(E){ot=E},this.getClearColor=function(E){return E.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(E=!0,U=!0,W=!0){let k=0;if(E){let V=!1;if(j!==null){let fe=j.texture.format;V=g.has(fe)}if(V){let fe=j.texture.type,Se=m.has(fe),ue=I.getClearColor(),xe=I.getClearAlpha(),Ee=ue.r,Fe=ue.g,We=ue.b;Se?(S[0]=Ee,S[1]=Fe,S[2]=We,S[3]=xe,F.clearBufferuiv(F.COLOR,0,S)):(A[0]=Ee,A[1]=Fe,A[2]=We,A[3]=xe,F.clearBufferiv(F.COLOR,0,A))}else k|=F.COLOR_BUFFER_BIT}U&&(k|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),W&&(k|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&F.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),N=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Ae,!1),t.removeEventListener("webglcontextrestored",Be,!1),t.removeEventListener("webglcontextcreationerror",_e,!1),I.dispose(),de.dispose(),J.dispose(),Oe.dispose(),Pe.dispose(),R.dispose(),ie.dispose(),z.dispose(),ae.dispose(),Te.dispose(),ee.dispose(),re.dispose(),re.removeEventListener("sessionstart",pu),re.removeEventListener("sessionend",mu),vi.stop()};function Ae(E){E.preventDefault(),zr("WebGLRenderer: Context Lost."),D=!0}a(Ae,"onContextLost");function Be(){zr("WebGLRenderer: Context Restored."),D=!1;let E=_t.autoReset,U=le.enabled,W=le.autoUpdate,k=le.needsUpdate,V=le.type;ke(),_t.autoReset=E,le.enabled=U,le.autoUpdate=W,le.needsUpdate=k,le.type=V}a(Be,"onContextRestore");function _e(E){De("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}a(_e,"onContextCreationError");function je(E){let U=E.target;U.removeEventListener("dispose",je),bt(U)}a(je,"onMaterialDispose");function bt(E){Qn(E),Pe.remove(E)}a(bt,"deallocateMaterial");function Qn(E){let U=Pe.get(E).programs;U!==void 0&&(U.forEach(function(W){ee.releaseProgram(W)}),E.isShaderMaterial&&ee.releaseShaderCache(E))}a(Qn,"releaseMaterialProgramReferences"),this.renderBufferDirect=function(E,U,W,k,V,fe){U===null&&(U=rn);let Se=V.isMesh&&V.matrixWorld.determinantAffine()<0,ue=ym(E,U,W,k,V);pe.setMaterial(k,Se);let xe=W.index,Ee=1;if(k.wireframe===!0){if(xe=z.getWireframeAttribute(W),xe===void 0)return;Ee=2}let Fe=W.drawRange,We=W.attributes.position,Me=Fe.start*Ee,Xe=(Fe.start+Fe.count)*Ee;fe!==null&&(Me=Math.max(Me,fe.start*Ee),Xe=Math.min(Xe,(fe.start+fe.count)*Ee)),xe!==null?(Me=Math.max(Me,0),Xe=Math.min(Xe,xe.count)):We!=null&&(Me=Math.max(Me,0),Xe=Math.min(Xe,We.count));let ft=Xe-Me;if(ft<0||ft===1/0)return;ae.setup(V,k,ue,W,xe);let it,tt=Y;if(xe!==null&&(it=M.get(xe),tt=ce,tt.setIndex(it)),V.isMesh)k.wireframe===!0?(pe.setLineWidth(k.wireframeLinewidth*on()),tt.setMode(F.LINES)):tt.setMode(F.TRIANGLES);else if(V.isLine){let It=k.linewidth;It===void 0&&(It=1),pe.setLineWidth(It*on()),V.isLineSegments?tt.setMode(F.LINES):V.isLineLoop?tt.setMode(F.LINE_LOOP):tt.setMode(F.LINE_STRIP)}else V.isPoints?tt.setMode(F.POINTS):V.isSprite&&tt.setMode(F.TRIANGLES);if(V.isBatchedMesh)if(at.get("WEBGL_multi_draw"))tt.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let It=V._multiDrawStarts,we=V._multiDrawCounts,kt=V._multiDrawCount,Je=xe?M.get(xe).bytesPerElement:1,bi=Pe.get(k).currentProgram.getUniforms();for(let Lt=0;Lt<kt;Lt++)bi.setValue(F,"_gl_DrawID",Lt),tt.render(It[Lt]/Je,we[Lt])}else if(V.isInstancedMesh)tt.renderInstances(Me,ft,V.count);else if(W.isInstancedBufferGeometry){let It=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,we=Math.min(W.instanceCount,It);tt.renderInstances(Me,ft,we)}else tt.render(Me,ft)};function fu(E,U,W,k){N!==null&&E.isNodeMaterial&&N.setObject(k,E),gt===!0&&Z.setState(E,W,!1),E.transparent===!0&&E.side===hn&&E.forceSinglePass===!1?(E.side=Ht,E.needsUpdate=!0,Mr(E,U,k),E.side=fi,E.needsUpdate=!0,Mr(E,U,k),E.side=hn):Mr(E,U,k)}a(fu,"prepareMaterial"),this.compile=function(E,U,W=null){W===null&&(W=E),N!==null&&N.renderStart(E,U,W),w=J.get(W),w.init(U),T.push(w),W.traverseVisible(function(V){V.isLight&&V.layers.test(U.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),E!==W&&E.traverseVisible(function(V){V.isLight&&V.layers.test(U.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),w.setupLights(),N!==null&&N.updateLights(w.state.lightsArray),Wt=this.localClippingEnabled,gt=Z.init(this.clippingPlanes,Wt),gt===!0&&Z.setGlobalState(this.clippingPlanes,U),N!==null&&le.render(w.state.shadowsArray,W,U);let k=new Set;return E.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let fe=V.material;if(fe)if(Array.isArray(fe))for(let Se=0;Se<fe.length;Se++){let ue=fe[Se];fu(ue,W,U,V),k.add(ue)}else fu(fe,W,U,V),k.add(fe)}),w=T.pop(),N!==null&&N.renderEnd(),k},this.compileAsync=function(E,U,W=null){let k=this.compile(E,U,W);return new Promise(V=>{function fe(){if(k.forEach(function(Se){let xe=Pe.get(Se).currentProgram;(xe===void 0||xe.isReady())&&k.delete(Se)}),k.size===0){V(E);return}setTimeout(fe,10)}a(fe,"checkMaterialsReady"),at.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let il=null;function gm(E){il&&il(E)}a(gm,"onAnimationFrame");function pu(){vi.stop()}a(pu,"onXRSessionStart");function mu(){vi.start()}a(mu,"onXRSessionEnd");let vi=new af;vi.setAnimationLoop(gm),typeof self<"u"&&vi.setContext(self),this.setAnimationLoop=function(E){il=E,re.setAnimationLoop(E),E===null?vi.stop():vi.start()},re.addEventListener("sessionstart",pu),re.addEventListener("sessionend",mu),this.render=function(E,U){if(U!==void 0&&U.isCamera!==!0){De("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;N!==null&&N.renderStart(E,U);let W=re.enabled===!0&&re.isPresenting===!0,k=L!==null&&(j===null||W)&&L.begin(C,j);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),re.enabled===!0&&re.isPresenting===!0&&(L===null||L.isCompositing()===!1)&&(re.cameraAutoUpdate===!0&&re.updateCamera(U),U=re.getCamera()),E.isScene===!0&&E.onBeforeRender(C,E,U,j),w=J.get(E,T.length),w.init(U),w.state.textureUnits=Oe.getTextureUnits(),T.push(w),ct.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),U.isArrayCamera?Rt.setFromArrayCamera(U):He.setFromProjectionMatrix(ct,un,U.reversedDepth),Wt=this.localClippingEnabled,gt=Z.init(this.clippingPlanes,Wt),b=de.get(E,y.length),b.init(),y.push(b),this.info.render.frame++,re.enabled===!0&&re.isPresenting===!0){let Se=C.xr.getDepthSensingMesh();Se!==null&&rl(Se,U,-1/0,C.sortObjects)}rl(E,U,0,C.sortObjects),b.finish(),N!==null&&N.updateLights(w.state.lightsArray),C.sortObjects===!0&&b.sort(Ne,ot),sn=re.enabled===!1||re.isPresenting===!1||re.hasDepthSensing()===!1,sn&&I.addToRenderList(b,E),this.info.autoReset===!0&&this.info.reset(),gt===!0&&Z.beginShadows();let V=w.state.shadowsArray;if(le.render(V,E,U),gt===!0&&Z.endShadows(),(k&&L.hasRenderPass())===!1){let Se=b.opaque,ue=b.transmissive;if(w.setupLights(),U.isArrayCamera){let xe=U.cameras;if(ue.length>0)for(let Ee=0,Fe=xe.length;Ee<Fe;Ee++){let We=xe[Ee];_u(Se,ue,E,We)}sn&&I.render(E);for(let Ee=0,Fe=xe.length;Ee<Fe;Ee++){let We=xe[Ee];gu(b,E,We,We.viewport)}}else ue.length>0&&_u(Se,ue,E,U),sn&&I.render(E),gu(b,E,U)}j!==null&&O===0&&(Oe.updateMultisampleRenderTarget(j),Oe.updateRenderTargetMipmap(j)),k&&L.end(C),E.isScene===!0&&E.onAfterRender(C,E,U),ae.resetDefaultState(),H=-1,Q=null,T.pop(),T.length>0?(w=T[T.length-1],Oe.setTextureUnits(w.state.textureUnits),gt===!0&&Z.setGlobalState(C.clippingPlanes,w.state.camera)):w=null,y.pop(),y.length>0?b=y[y.length-1]:b=null,N!==null&&N.renderEnd()};function rl(E,U,W,k){if(E.visible===!1)return;if(E.layers.test(U.layers)){if(E.isGroup)W=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(U);else if(E.isLight)w.pushLight(E),E.castShadow&&w.pushShadow(E);else if(E.isSprite){let Se=U.isArrayCamera?Rt:He;if(!E.frustumCulled||E.intersectsFrustum(Se)){k&&vt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(ct);let ue=ie.update(E),xe=E.material;xe.visible&&b.push(E,ue,xe,W,vt.z,null,U)}}else if(E.isMesh||E.isLine||E.isPoints){let Se=U.isArrayCamera?Rt:He;if(!E.frustumCulled||E.intersectsFrustum(Se)){let ue=ie.update(E),xe=E.material;if(k&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),vt.copy(E.boundingSphere.center)):(ue.boundingSphere===null&&ue.computeBoundingSphere(),vt.copy(ue.boundingSphere.center)),vt.applyMatrix4(E.matrixWorld).applyMatrix4(ct)),Array.isArray(xe)){let Ee=ue.groups;for(let Fe=0,We=Ee.length;Fe<We;Fe++){let Me=Ee[Fe],Xe=xe[Me.materialIndex];Xe&&Xe.visible&&b.push(E,ue,Xe,W,vt.z,Me,U)}}else xe.visible&&b.push(E,ue,xe,W,vt.z,null,U)}}}let fe=E.children;for(let Se=0,ue=fe.length;Se<ue;Se++)rl(fe[Se],U,W,k)}a(rl,"projectObject");function gu(E,U,W,k){let{opaque:V,transmissive:fe,transparent:Se}=E;w.setupLightsView(W),gt===!0&&Z.setGlobalState(C.clippingPlanes,W),k&&pe.viewport(te.copy(k)),V.length>0&&ws(V,U,W),fe.length>0&&ws(fe,U,W),Se.length>0&&ws(Se,U,W),pe.buffers.depth.setTest(!0),pe.buffers.depth.setMask(!0),pe.buffers.color.setMask(!0),pe.setPolygonOffset(!1)}a(gu,"renderScene");function _u(E,U,W,k){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[k.id]===void 0){let Me=at.has("EXT_color_buffer_half_float")||at.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[k.id]=new Ft(1,1,{generateMipmaps:!0,type:Me?bn:en,minFilter:$n,samples:Math.max(4,lt.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:qe.workingColorSpace})}let fe=w.state.transmissionRenderTarget[k.id],Se=k.viewport||te;fe.setSize(Se.z*C.transmissionResolutionScale,Se.w*C.transmissionResolutionScale);let ue=C.getRenderTarget(),xe=C.getActiveCubeFace(),Ee=C.getActiveMipmapLevel();C.setRenderTarget(fe),C.getClearColor(X),me=C.getClearAlpha(),me<1&&C.setClearColor(16777215,.5),C.clear(),sn&&I.render(W);let Fe=C.toneMapping;C.toneMapping=Nn;let We=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),w.setupLightsView(k),gt===!0&&Z.setGlobalState(C.clippingPlanes,k),ws(E,W,k),Oe.updateMultisampleRenderTarget(fe),Oe.updateRenderTargetMipmap(fe),at.has("WEBGL_multisampled_render_to_texture")===!1){let Me=!1;for(let Xe=0,ft=U.length;Xe<ft;Xe++){let it=U[Xe],{object:tt,geometry:It,material:we,group:kt}=it;if(we.side===hn&&tt.layers.test(k.layers)){let Je=we.side;we.side=Ht,we.needsUpdate=!0,yu(tt,W,k,It,we,kt),we.side=Je,we.needsUpdate=!0,Me=!0}}Me===!0&&(Oe.updateMultisampleRenderTarget(fe),Oe.updateRenderTargetMipmap(fe))}C.setRenderTarget(ue,xe,Ee),C.setClearColor(X,me),We!==void 0&&(k.viewport=We),C.toneMapping=Fe}a(_u,"renderTransmissionPass");function ws(E,U,W){let k=U.isScene===!0?U.overrideMaterial:null;for(let V=0,fe=E.length;V<fe;V++){let Se=E[V],{object:ue,geometry:xe,group:Ee}=Se,Fe=Se.material;Fe.allowOverride===!0&&k!==null&&(Fe=k),ue.layers.test(W.layers)&&yu(ue,U,W,xe,Fe,Ee)}}a(ws,"renderObjects");function yu(E,U,W,k,V,fe){N!==null&&V.isNodeMaterial&&N.setObject(E,V),E.onBeforeRender(C,U,W,k,V,fe),E.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),V.onBeforeRender(C,U,W,k,E,fe),V.transparent===!0&&V.side===hn&&V.forceSinglePass===!1?(V.side=Ht,V.needsUpdate=!0,C.renderBufferDirect(W,U,k,V,E,fe),V.side=fi,V.needsUpdate=!0,C.renderBufferDirect(W,U,k,V,E,fe),V.side=hn):C.renderBufferDirect(W,U,k,V,E,fe),E.onAfterRender(C,U,W,k,V,fe)}a(yu,"renderObject");function xu(E){let U=0;for(let W of E)W.texture!==null&&U++;return U}a(xu,"countLightProbeGrids");function Mr(E,U,W){U.isScene!==!0&&(U=rn);let k=Pe.get(E),V=w.state.lights,fe=w.state.shadowsArray,Se=V.state.version,ue=ee.getParameters(E,V.state,fe,U,W,w.state.lightProbeGridArray),xe=ee.getProgramCacheKey(ue),Ee=k.programs;k.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?U.environment:null,k.fog=U.fog;let Fe=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;k.envMap=R.get(E.envMap||k.environment,Fe),k.envMapRotation=k.environment!==null&&E.envMap===null?U.environmentRotation:E.envMapRotation,Ee===void 0&&(E.addEventListener("dispose",je),Ee=new Map,k.programs=Ee,k.programVariants=new Map);let We=Ee.get(xe);if(We!==void 0){if(k.currentProgram===We&&k.lightsStateVersion===Se)return bu(E,ue),We}else ue.uniforms=ee.getUniforms(E),N!==null&&E.isNodeMaterial&&N.build(E,W,ue),E.onBeforeCompile(ue,C),We=ee.acquireProgram(ue,xe),Ee.set(xe,We),k.uniforms=ue.uniforms;let Me=k.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Me.clippingPlanes=Z.uniform),bu(E,ue),k.needsLights=vm(E),k.lightsStateVersion=Se,k.needsLights&&(Me.ambientLightColor.value=V.state.ambient,Me.lightProbe.value=V.state.probe,Me.sunLights.value=V.state.sun,Me.sunLightShadows.value=V.state.sunShadow,Me.directionalLights.value=V.state.directional,Me.directionalLightShadows.value=V.state.directionalShadow,Me.spotLights.value=V.state.spot,Me.spotLightShadows.value=V.state.spotShadow,Me.rectAreaLights.value=V.state.rectArea,Me.ltc_1.value=V.state.rectAreaLTC1,Me.ltc_2.value=V.state.rectAreaLTC2,Me.pointLights.value=V.state.point,Me.pointLightShadows.value=V.state.pointShadow,Me.hemisphereLights.value=V.state.hemi,Me.sunShadowMatrix.value=V.state.sunShadowMatrix,Me.sunShadowCascade.value=V.state.sunShadowCascade,Me.directionalShadowMatrix.value=V.state.directionalShadowMatrix,Me.spotLightMatrix.value=V.state.spotLightMatrix,Me.spotLightMap.value=V.state.spotLightMap,Me.pointShadowMatrix.value=V.state.pointShadowMatrix),k.numLightProbeGrids=xu(w.state.lightProbeGridArray),k.currentProgram=We,k.uniformsList=null,We}a(Mr,"getProgram");function _m(E,U,W,k,V){let fe=Pe.get(E),Se=fe.currentProgram.id+","+k+","+V,ue=fe.programVariants.get(Se);return ue===void 0?(ue=Mr(E,U,W),fe.programVariants.set(Se,ue)):(fe.currentProgram=ue,fe.uniformsList=null,fe.outputColorSpace=k,fe.toneMapping=V),ue}a(_m,"getProgramVariant");function vu(E){if(E.uniformsList===null){let U=E.currentProgram.getUniforms();E.uniformsList=vr.seqWithValue(U.seq,E.uniforms)}return E.uniformsList}a(vu,"getUniformList");function bu(E,U){let W=Pe.get(E);W.outputColorSpace=U.outputColorSpace,W.batching=U.batching,W.batchingColor=U.batchingColor,W.instancing=U.instancing,W.instancingColor=U.instancingColor,W.instancingMorph=U.instancingMorph,W.skinning=U.skinning,W.morphTargets=U.morphTargets,W.morphNormals=U.morphNormals,W.morphColors=U.morphColors,W.morphTargetsCount=U.morphTargetsCount,W.numClippingPlanes=U.numClippingPlanes,W.numIntersection=U.numClipIntersection,W.vertexAlphas=U.vertexAlphas,W.vertexTangents=U.vertexTangents,W.toneMapping=U.toneMapping}a(bu,"updateCommonMaterialProperties");function ym(E,U,W,k,V){U.isScene!==!0&&(U=rn),Oe.resetTextureUnits();let fe=U.fog,Se=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?U.environment:null,ue=j===null?C.outputColorSpace:j.isXRRenderTarget===!0?j.texture.colorSpace:qe.workingColorSpace,xe=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Ee=R.get(k.envMap||Se,xe),Fe=k.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,We=!!W.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),Me=!!W.morphAttributes.position,Xe=!!W.morphAttributes.normal,ft=!!W.morphAttributes.color,it=Nn;k.toneMapped&&(j===null||j.isXRRenderTarget===!0)&&(it=C.toneMapping);let tt=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,It=tt!==void 0?tt.length:0,we=Pe.get(k),kt=w.state.lights;if(gt===!0&&(Wt===!0||E!==Q)){let ut=E===Q&&k.id===H;Z.setState(k,E,ut)}let Je=!1,bi=!1;k.version===we.__version?we.needsLights&&we.lightsStateVersion!==kt.state.version||V.isBatchedMesh&&we.batching===!1||!V.isBatchedMesh&&we.batching===!0||V.isBatchedMesh&&we.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&we.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&we.instancing===!1||!V.isInstancedMesh&&we.instancing===!0||V.isSkinnedMesh&&we.skinning===!1||!V.isSkinnedMesh&&we.skinning===!0||V.isInstancedMesh&&we.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&we.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&we.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&we.instancingMorph===!1&&V.morphTexture!==null||we.envMap!==Ee||k.fog===!0&&we.fog!==fe||we.numClippingPlanes!==void 0&&(we.numClippingPlanes!==Z.numPlanes||we.numIntersection!==Z.numIntersection)||we.vertexAlphas!==Fe||we.vertexTangents!==We||we.morphTargets!==Me||we.morphNormals!==Xe||we.morphColors!==ft||we.morphTargetsCount!==It||we.numLightProbeGrids!==xu(w.state.lightProbeGridArray)?Je=!0:(we.outputColorSpace!==ue||we.toneMapping!==it)&&(bi=!0):(Je=!0,we.__version=k.version);let Lt=we.currentProgram;(Je===!0||bi===!0)&&(Lt=bi===!0?_m(k,U,V,ue,it):Mr(k,U,V),N&&k.isNodeMaterial&&N.onUpdateProgram(k,Lt,we));let Es=!1,ei=!1,Si=!1,$e=Lt.getUniforms(),Ct=we.uniforms;if(pe.useProgram(Lt.program)&&(Es=!0,ei=!0,Si=!0),k.id!==H&&(H=k.id,ei=!0),Es||Q!==E){pe.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),$e.setValue(F,"projectionMatrix",E.projectionMatrix),$e.setValue(F,"viewMatrix",E.matrixWorldInverse);let St=$e.map.cameraPosition;St!==void 0&&St.setValue(F,Mn.setFromMatrixPosition(E.matrixWorld)),lt.logarithmicDepthBuffer&&$e.setValue(F,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&$e.setValue(F,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,ei=!0,Si=!0)}if(we.needsLights&&(kt.state.sunShadowMap.length>0&&$e.setValue(F,"sunShadowMap",kt.state.sunShadowMap,Oe),kt.state.directionalShadowMap.length>0&&$e.setValue(F,"directionalShadowMap",kt.state.directionalShadowMap,Oe),kt.state.spotShadowMap.length>0&&$e.setValue(F,"spotShadowMap",kt.state.spotShadowMap,Oe),kt.state.pointShadowMap.length>0&&$e.setValue(F,"pointShadowMap",kt.state.pointShadowMap,Oe)),V.isSkinnedMesh){$e.setOptional(F,V,"bindMatrix"),$e.setOptional(F,V,"bindMatrixInverse");let ut=V.skeleton;ut&&(ut.boneTexture===null&&ut.computeBoneTexture(),$e.setValue(F,"boneTexture",ut.boneTexture,Oe))}V.isBatchedMesh&&($e.setOptional(F,V,"batchingTexture"),$e.setValue(F,"batchingTexture",V._matricesTexture,Oe),$e.setOptional(F,V,"batchingIdTexture"),$e.setValue(F,"batchingIdTexture",V._indirectTexture,Oe),$e.setOptional(F,V,"batchingColorTexture"),V._colorsTexture!==null&&$e.setValue(F,"batchingColorTexture",V._colorsTexture,Oe));let fn=W.morphAttributes;if((fn.position!==void 0||fn.normal!==void 0||fn.color!==void 0)&&K.update(V,W,Lt),(ei||we.receiveShadow!==V.receiveShadow)&&(we.receiveShadow=V.receiveShadow,$e.setValue(F,"receiveShadow",V.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&U.environment!==null&&(Ct.envMapIntensity.value=U.environmentIntensity),Ct.dfgLUT!==void 0&&(Ct.dfgLUT.value=Qv()),ei){if($e.setValue(F,"toneMappingExposure",C.toneMappingExposure),we.needsLights&&xm(Ct,Si),fe&&k.fog===!0&&oe.refreshFogUniforms(Ct,fe),oe.refreshMaterialUniforms(Ct,k,ge,Re,w.state.transmissionRenderTarget[E.id]),we.needsLights&&we.numLightProbeGrids>0){let ut=x,St=0;for(let Fn of w.state.lightProbeGridArray)Fn.texture!==null&&(ut.textures[St]=Fn.texture,ut.min[St]=Fn.boundingBox.min,ut.max[St]=Fn.boundingBox.max,ut.resolution[St]=Fn.resolution,St++);for(let Fn in ut)ut[Fn].length=St;Ct.probesSH.value=ut.textures,Ct.probesMin.value=ut.min,Ct.probesMax.value=ut.max,Ct.probesResolution.value=ut.resolution}vr.upload(F,vu(we),Ct,Oe)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(vr.upload(F,vu(we),Ct,Oe),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&$e.setValue(F,"center",V.center),$e.setValue(F,"modelViewMatrix",V.modelViewMatrix),$e.setValue(F,"normalMatrix",V.normalMatrix),$e.setValue(F,"modelMatrix",V.matrixWorld),k.uniformsGroups!==void 0){let ut=k.uniformsGroups;for(let St=0,Fn=ut.length;St<Fn;St++){let Mu=ut[St];Te.update(Mu,Lt),Te.bind(Mu,Lt)}}return Lt}a(ym,"setProgram");function xm(E,U){E.ambientLightColor.needsUpdate=U,E.lightProbe.needsUpdate=U,E.sunLights.needsUpdate=U,E.sunLightShadows.needsUpdate=U,E.directionalLights.needsUpdate=U,E.directionalLightShadows.needsUpdate=U,E.pointLights.needsUpdate=U,E.pointLightShadows.needsUpdate=U,E.spotLights.needsUpdate=U,E.spotLightShadows.needsUpdate=U,E.rectAreaLights.needsUpdate=U,E.hemisphereLights.needsUpdate=U}a(xm,"markUniformsLightsNeedsUpdate");function vm(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}a(vm,"materialNeedsLights"),this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return j},this.setRenderTargetTextures=function(E,U,W){let k=Pe.get(E);k.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Pe.get(E.texture).__webglTexture=U,Pe.get(E.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:W,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,U){let W=Pe.get(E);W.__webglFramebuffer=U,W.__useDefaultFramebuffer=U===void 0},this.setRenderTarget=function(E,U=0,W=0){j=E,$=U,O=W;let k=null,V=!1,fe=!1;if(E){let ue=Pe.get(E);if(ue.__useDefaultFramebuffer!==void 0){pe.bindFramebuffer(F.FRAMEBUFFER,ue.__webglFramebuffer),te.copy(E.viewport),ne.copy(E.scissor),he=E.scissorTest,pe.viewport(te),pe.scissor(ne),pe.setScissorTest(he),H=-1;return}else if(ue.__webglFramebuffer===void 0)Oe.setupRenderTarget(E);else if(ue.__hasExternalTextures)Oe.rebindTextures(E,Pe.get(E.texture).__webglTexture,Pe.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Fe=E.depthTexture;if(ue.__boundDepthTexture!==Fe){if(Fe!==null&&Pe.has(Fe)&&(E.width!==Fe.image.width||E.height!==Fe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Oe.setupDepthRenderbuffer(E)}}let xe=E.texture;(xe.isData3DTexture||xe.isDataArrayTexture||xe.isCompressedArrayTexture)&&(fe=!0);let Ee=Pe.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ee[U])?k=Ee[U][W]:k=Ee[U],V=!0):E.samples>0&&Oe.useMultisampledRTT(E)===!1?k=Pe.get(E).__webglMultisampledFramebuffer:Array.isArray(Ee)?k=Ee[W]:k=Ee,te.copy(E.viewport),ne.copy(E.scissor),he=E.scissorTest}else te.copy(Ie).multiplyScalar(ge).floor(),ne.copy(Ke).multiplyScalar(ge).floor(),he=et;if(W!==0&&(k=B),pe.bindFramebuffer(F.FRAMEBUFFER,k)&&pe.drawBuffers(E,k),pe.viewport(te),pe.scissor(ne),pe.setScissorTest(he),V){let ue=Pe.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+U,ue.__webglTexture,W)}else if(fe){let ue=U;for(let xe=0;xe<E.textures.length;xe++){let Ee=Pe.get(E.textures[xe]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+xe,Ee.__webglTexture,W,ue)}}else if(E!==null&&W!==0){let ue=Pe.get(E.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ue.__webglTexture,W)}H=-1};function Su(E){let U=Pe.get(E);return(U.__readFormat!==E.format||U.__readType!==E.type)&&(U.__readFormat=E.format,U.__readType=E.type,U.__formatReadable=lt.textureFormatReadable(E.format),U.__typeReadable=lt.textureTypeReadable(E.type)),U}a(Su,"getReadableState"),this.readRenderTargetPixels=function(E,U,W,k,V,fe,Se,ue=0){if(!(E&&E.isWebGLRenderTarget)){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xe=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(xe=xe[Se],Array.isArray(xe)&&(xe=xe[0])),xe){pe.bindFramebuffer(F.FRAMEBUFFER,xe);try{let Ee=E.textures[ue],Fe=Ee.format,We=Ee.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ue);let Me=Su(Ee);if(Me.__formatReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Me.__typeReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=E.width-k&&W>=0&&W<=E.height-V&&F.readPixels(U,W,k,V,se.convert(Fe),se.convert(We),fe)}finally{let Ee=j!==null?Pe.get(j).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,Ee)}}},this.readRenderTargetPixelsAsync=async function(E,U,W,k,V,fe,Se,ue=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xe=Pe.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(xe=xe[Se],Array.isArray(xe)&&(xe=xe[0])),xe)if(U>=0&&U<=E.width-k&&W>=0&&W<=E.height-V){pe.bindFramebuffer(F.FRAMEBUFFER,xe);let Ee=E.textures[ue],Fe=Ee.format,We=Ee.type;E.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+ue);let Me=Su(Ee);if(Me.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Me.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Xe=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,Xe),F.bufferData(F.PIXEL_PACK_BUFFER,fe.byteLength,F.STREAM_READ),F.readPixels(U,W,k,V,se.convert(Fe),se.convert(We),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let ft=j!==null?Pe.get(j).__webglFramebuffer:null;pe.bindFramebuffer(F.FRAMEBUFFER,ft);let it=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await Pd(F,it,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,Xe),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,fe),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(Xe),F.deleteSync(it),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,U=null,W=0){let k=Math.pow(2,-W),V=Math.floor(E.image.width*k),fe=Math.floor(E.image.height*k),Se=U!==null?U.x:0,ue=U!==null?U.y:0;Oe.setTexture2D(E,0),F.copyTexSubImage2D(F.TEXTURE_2D,W,0,0,Se,ue,V,fe),pe.unbindTexture()},this.copyTextureToTexture=function(E,U,W=null,k=null,V=0,fe=0){let Se,ue,xe,Ee,Fe,We,Me,Xe,ft,it=E.isCompressedTexture?E.mipmaps[fe]:E.image;if(W!==null)Se=W.max.x-W.min.x,ue=W.max.y-W.min.y,xe=W.isBox3?W.max.z-W.min.z:1,Ee=W.min.x,Fe=W.min.y,We=W.isBox3?W.min.z:0;else{let $e=Math.pow(2,-V);Se=Math.floor(it.width*$e),ue=Math.floor(it.height*$e),E.isDataArrayTexture?xe=it.depth:E.isData3DTexture?xe=Math.floor(it.depth*$e):xe=1,Ee=0,Fe=0,We=0}k!==null?(Me=k.x,Xe=k.y,ft=k.z):(Me=0,Xe=0,ft=0);let tt=se.convert(U.format),It=se.convert(U.type),we;U.isData3DTexture?(Oe.setTexture3D(U,0),we=F.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Oe.setTexture2DArray(U,0),we=F.TEXTURE_2D_ARRAY):(Oe.setTexture2D(U,0),we=F.TEXTURE_2D),pe.activeTexture(F.TEXTURE0),pe.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,U.flipY),pe.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),pe.pixelStorei(F.UNPACK_ALIGNMENT,U.unpackAlignment);let kt=pe.getParameter(F.UNPACK_ROW_LENGTH),Je=pe.getParameter(F.UNPACK_IMAGE_HEIGHT),bi=pe.getParameter(F.UNPACK_SKIP_PIXELS),Lt=pe.getParameter(F.UNPACK_SKIP_ROWS),Es=pe.getParameter(F.UNPACK_SKIP_IMAGES);pe.pixelStorei(F.UNPACK_ROW_LENGTH,it.width),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,it.height),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,Ee),pe.pixelStorei(F.UNPACK_SKIP_ROWS,Fe),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,We);let ei=E.isDataArrayTexture||E.isData3DTexture,Si=U.isDataArrayTexture||U.isData3DTexture;if(E.isDepthTexture){let $e=Pe.get(E),Ct=Pe.get(U),fn=Pe.get($e.__renderTarget),ut=Pe.get(Ct.__renderTarget);pe.bindFramebuffer(F.READ_FRAMEBUFFER,fn.__webglFramebuffer),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,ut.__webglFramebuffer);for(let St=0;St<xe;St++)ei&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(E).__webglTexture,V,We+St),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Pe.get(U).__webglTexture,fe,ft+St)),F.blitFramebuffer(Ee,Fe,Ee+Se,Fe+ue,Me,Xe,Me+Se,Xe+ue,F.DEPTH_BUFFER_BIT,F.NEAREST);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(V!==0||E.isRenderTargetTexture||Pe.has(E)){let $e=Pe.get(E),Ct=Pe.get(U);pe.bindFramebuffer(F.READ_FRAMEBUFFER,P),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,q);for(let fn=0;fn<xe;fn++)ei?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,$e.__webglTexture,V,We+fn):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,$e.__webglTexture,V),Si?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Ct.__webglTexture,fe,ft+fn):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ct.__webglTexture,fe),V!==0?F.blitFramebuffer(Ee,Fe,Ee+Se,Fe+ue,Me,Xe,Me+Se,Xe+ue,F.COLOR_BUFFER_BIT,F.NEAREST):Si?F.copyTexSubImage3D(we,fe,Me,Xe,ft+fn,Ee,Fe,Se,ue):F.copyTexSubImage2D(we,fe,Me,Xe,Ee,Fe,Se,ue);pe.bindFramebuffer(F.READ_FRAMEBUFFER,null),pe.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Si?E.isDataTexture||E.isData3DTexture?F.texSubImage3D(we,fe,Me,Xe,ft,Se,ue,xe,tt,It,it.data):U.isCompressedArrayTexture?F.compressedTexSubImage3D(we,fe,Me,Xe,ft,Se,ue,xe,tt,it.data):F.texSubImage3D(we,fe,Me,Xe,ft,Se,ue,xe,tt,It,it):E.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,fe,Me,Xe,Se,ue,tt,It,it.data):E.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,fe,Me,Xe,it.width,it.height,tt,it.data):F.texSubImage2D(F.TEXTURE_2D,fe,Me,Xe,Se,ue,tt,It,it);pe.pixelStorei(F.UNPACK_ROW_LENGTH,kt),pe.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Je),pe.pixelStorei(F.UNPACK_SKIP_PIXELS,bi),pe.pixelStorei(F.UNPACK_SKIP_ROWS,Lt),pe.pixelStorei(F.UNPACK_SKIP_IMAGES,Es),fe===0&&U.generateMipmaps===!0&&U.mipmapsAutoUpdate===!0&&F.generateMipmap(we),pe.unbindTexture()},this.initRenderTarget=function(E){Pe.get(E).__webglFramebuffer===void 0&&Oe.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Oe.setTextureCube(E,0):E.isData3DTexture?Oe.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Oe.setTexture2DArray(E,0):Oe.setTexture2D(E,0),pe.unbindTexture()},this.resetState=function(){$=0,O=0,j=null,pe.reset(),ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return un}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=qe._getDrawingBufferColorSpace(e),t.unpackColorSpace=qe._getUnpackColorSpace()}};function yf(n,e,t=16777216){let i=new Map,r=0;return{fetch(s,o){let l=i.get(s);return l?(i.delete(s),r-=e(s),l):n(s,o)},want(s,o){for(let l of s){if(i.has(l)||r+e(l)>t)continue;let c=n(l,o);c.catch(()=>{}),i.set(l,c),r+=e(l)}},get bytes(){return r}}}a(yf,"createAhead");function Bi(n,e){let t=e===null?[]:typeof e=="string"?[e]:e;return Promise.all(t.map(i=>ka(n,i)))}a(Bi,"filesOf");async function ka({ahead:n,manifest:e,signal:t},i){let r=e.files[i];if(!r)throw new Error(`${i} is not listed in the manifest`);return{name:i,data:await n.fetch(i,t),bytes:r.bytes,sha256:r.sha256}}a(ka,"fileOf");var eb={map:.2,picture:.2,arrays:.1,mesh:.5,program:2.5},tb=.15,nb=4;function xf(){let n=new Map,e=a(i=>n.get(i)??eb[i],"unit"),t=a(i=>1+i/65536,"units");return{expected:a(({kind:i,bytes:r})=>e(i)*t(r),"expected"),learn({kind:i,bytes:r},s){let o=e(i),l=Math.min(s/t(r),nb*o);n.set(i,o+tb*(l-o))}}}a(xf,"createCosts");function za(n){let e=[],t=0;function i(r){for(let s=e[0];s;s=e[0]){if(r.getSyncParameter(s.sync,r.SYNC_STATUS)!==r.SIGNALED)return;r.deleteSync(s.sync),e.shift()}}return a(i,"settle"),{send(r){t+=r},hasRoom(r){if(!n||r===0)return!0;i(n);let s=e.reduce((o,l)=>o+l.bytes,t);return s===0||s+r<=8388608},mark(){if(n&&t>0){let r=n.fenceSync(n.SYNC_GPU_COMMANDS_COMPLETE,0);r&&e.push({sync:r,bytes:t}),n.flush()}t=0},forget(){e=[],t=0}}}a(za,"createFlight");var vs=2**18;function vf(n=()=>performance.now(),e=za(null)){let t=[],i=xf(),r=0;function s(){for(let u=t[0];u;u=t[0])try{if(u.signal.throwIfAborted(),u.next??=ib(u),u.next)return{job:u,step:u.next};o(u),u.done()}catch(h){l(u,h)}return null}a(s,"next");function o(u){t.splice(t.indexOf(u),1)}a(o,"end");function l(u,h){o(u),u.steps.return?.(),u.failed(h)}a(l,"fail");function c({job:u,step:h}){let p=n();u.next=null,e.send(h.bytes);try{h.run()}catch(d){l(u,d)}i.learn(h,n()-p)}return a(c,"take"),{add(u,h,p=!1){return new Promise((d,f)=>{let _={steps:u[Symbol.iterator](),signal:h,done:d,failed:f,next:null};p?t.unshift(_):t.push(_)})},spend(u){r+=u},run(u){let h=n()-r,p=r===0;r=0;for(let d=s();d;d=s()){let{step:f}=d;if(n()-h+i.expected(f)>u&&!p||!e.hasRoom(f.bytes))break;c(d),p=!1}return e.mark(),n()-h},forget:e.forget}}a(vf,"createUploads");function ib(n){let{done:e,value:t}=n.steps.next();return e?null:t}a(ib,"following");var Fc=6,rb={least:1,step:1};function ki(n,e,t=rb){let i=n.getContext(),r=Sf(n,bf(i,e,i.SRGB8_ALPHA8,i.LINEAR)),s=Sf(n,bf(i,e,i.R16UI,i.NEAREST));return n.resetState(),{color:r,codes:s,holds:null,hasRange:!1,size:e,scale:t,dispose(){for(let o of[r,s])i.deleteTexture(Bc(n,o)),n.properties.remove(o)}}}a(ki,"createCube");function bf(n,e,t,i){let r=n.createTexture();return n.bindTexture(n.TEXTURE_CUBE_MAP,r),n.texStorage2D(n.TEXTURE_CUBE_MAP,1,t,e,e),n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MIN_FILTER,i),n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAG_FILTER,i),r}a(bf,"allocated");function Sf(n,e){let t=new Li;return n.properties.get(t).__webglTexture=e,t}a(Sf,"wrapped");function Bc(n,e){return n.properties.get(e).__webglTexture}a(Bc,"handleOf");function wf(n,{color:e}){return Bc(n,e)}a(wf,"colorOf");function*Va(n,e,t,i,r){let s=n.getContext(),{face_size:o,tile:l}=r;if(e.holds=null,t.whole){for(let c=0;c<Fc;c++){let u={face:c,x:0,y:0,width:o,height:o};yield*Ga(n,s,e.color,u,Mf(t.color,c)),t.codes&&(yield*Ga(n,s,e.codes,u,Mf(t.codes,c)))}e.hasRange=t.codes!==null}else{let c=o/l,u=l*l;for(let h=0;h<t.tiles.length;h++){let p=t.tiles[h]??0,d=Math.floor(p/(c*c)),f=p%(c*c),_={face:d,x:f%c*l,y:Math.floor(f/c)*l,width:l,height:l};yield*Ga(n,s,e.color,_,t.color.subarray(4*h*u,4*(h+1)*u)),yield*Ga(n,s,e.codes,_,t.codes.subarray(h*u,(h+1)*u))}}e.holds=i}a(Va,"cubeSteps");function Mf(n,e){let t=n[e];if(!t)throw new Error("a map has fewer than six faces");return t}a(Mf,"faceOf");function*Ga(n,e,t,i,r){let s=r.length/i.height,o=Math.max(Math.floor(vs/(s*r.BYTES_PER_ELEMENT)),1);for(let l=0;l<i.height;l+=o){let c={...i,y:i.y+l,height:Math.min(o,i.height-l)},u=r.subarray(l*s,(l+c.height)*s);yield{kind:"map",bytes:u.byteLength,run:a(()=>sb(n,e,t,c,u),"run")}}}a(Ga,"boxSteps");function sb(n,e,t,{face:i,x:r,y:s,width:o,height:l},c){let{state:u}=n;u.activeTexture(e.TEXTURE0),u.bindTexture(e.TEXTURE_CUBE_MAP,Bc(n,t)),u.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),u.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),u.pixelStorei(e.UNPACK_ALIGNMENT,1);let h=e.TEXTURE_CUBE_MAP_POSITIVE_X+i,[p,d]=c instanceof Uint8Array?[e.RGBA,e.UNSIGNED_BYTE]:[e.RED_INTEGER,e.UNSIGNED_SHORT];e.texSubImage2D(h,0,r,s,o,l,p,d,c),u.pixelStorei(e.UNPACK_ALIGNMENT,4)}a(sb,"put");var ob={SUN_DIRECTION:[.5263158,.7894737,.3157895],SUN:[.6,.56,.5],SKY_DIRECTION:[-.2062843,.9282791,.3094264],SKY_LOW:[.13,.135,.15],SKY_HIGH:[.38,.42,.48],HORIZON:[.66,.74,.82],ZENITH:[.16,.34,.66],NADIR:[.24,.25,.26]},Ef=["SUN_DIRECTION","SUN","SKY_DIRECTION","SKY_LOW","SKY_HIGH"],Tf=["HORIZON","ZENITH","NADIR"],ab=a(n=>Number.isInteger(n)?n.toFixed(1):String(n),"float"),Af=a(n=>ob[n].map(ab).join(", "),"vector"),Rf=a(n=>n.map(e=>`const vec3 ${e} = vec3(${Af(e)});`).join(`
`),"glsl"),lb=a(n=>n.map(e=>`const ${e} = vec3<f32>(${Af(e)});`).join(`
`),"wgsl"),Cf=`
${Rf(Ef)}

vec3 irradiance(vec3 n) {
  float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
  return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`,$1=`
${Rf(Tf)}

vec3 background(vec3 direction) {
  return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`,Ha=`
vec3 srgb_of(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
`;var J1=`
${lb([...Ef,...Tf])}

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
`;var Pf=`// The morph of nearfar in GLSL: where the user is shown a point of the world. Licence: MIT or Apache-2.0.
// Written by \`python -m scripts.shaders.write\` from morph.wgsl and world.wgsl; docs/engines.md tells how to use it.
//
// Call nearfar_morph or nearfar_morph_cylinder in the vertex stage; and, if points are morphed by the cylinder,
// nearfar_range_cylinder where the far map's range is read. Their parameters:
//   p              a point of the world, any unit of length; y is up
//   user           the position U of the eye that the picture is for, same unit and axes; each eye has its own
//   center         the centre O of the reduction, from which the far map was baked, same unit and axes
//   r1, r2         radii of the near zone and of all geometry, same unit
//   strength       1; below it, near points move to where the centre sees them (0), so that they can appear smoothly
//   direction      a unit vector, in which the map is looked up
//   range          what the map holds there: the distance from the centre, same unit

// The morph: Popescu, Lee, Choi, Fahmy (2022), Eq. 1-3, and CloVR (2024), Alg. 1. The renderer and the kernel of arrays
// share these functions, so that what the kernel is tested with tests the renderer too.

// A blend of unit vectors below this has no digits left.
const float OPPOSED = 1e-6;

// Weight of the user's view at full strength, at a distance from the axis: 1 within r1 and 0 beyond r2; slope is 1 / (r2 - r1).
float user_weight(float rho, float r2, float slope) {
    return clamp((r2 - rho) * slope, 0.0, 1.0);
}

// Eq. 1-3 as written: the direction in which the user is shown a point, and in w its distance.
vec4 blended(vec3 from_user, vec3 from_center, float w) {
    float by_user = length(from_user);
    float by_center = length(from_center);
    vec3 user_direction = from_user / max(by_user, 1e-30);
    vec3 mixed = w * user_direction + (1.0 - w) * from_center / max(by_center, 1e-30);
    float size = length(mixed);
    vec3 direction = user_direction;
    if (size > OPPOSED) {
        direction = mixed / size;
    }
    return vec4(direction, w * by_user + (1.0 - w) * by_center);
}

// The user's place on the ground relative to the axis, and its distance from it.
struct Place {
    vec2 at;
    float rho;
};

// Of a user relative to the centre.
Place ground_place(vec3 offset) {
    return Place(offset.xz, length(offset.xz));
}

// Distance from the user along a unit direction to where it leaves the cylinder of radius rho about the axis; negative
// where the user stands outside or the direction never leaves. The larger root in the form that does not cancel.
float leave_cylinder(Place user, vec3 direction, float rho) {
    float a = dot(direction.xz, direction.xz);
    if (rho <= user.rho || a == 0.0) {
        return -1.0;
    }
    float b = dot(direction.xz, user.at);
    // Negative inside the cylinder, so that the discriminant is not.
    float c = (user.rho - rho) * (user.rho + rho);
    float q = sqrt(b * b - a * c);
    if (b > 0.0) {
        return -c / (b + q);
    }
    return (q - b) / a;
}

// The blended direction, and in w the distance at which it leaves the point's own cylinder, if it does.
vec4 on_cylinder(Place user, vec3 from_user, vec3 from_center, float w, float rho) {
    vec4 to = blended(from_user, from_center, w);
    float exit = leave_cylinder(user, to.xyz, rho);
    return vec4(to.xyz, ((exit >= 0.0) ? exit : to.w));
}

// How far away the user is shown along a unit direction what the centre sees there at a distance beyond r2, if points
// are shown on their cylinders. (Blended points keep that distance.) Infinite distances stay.
float range_on_cylinder(Place user, vec3 direction, float from_center) {
    if (from_center > 1e30) {
        return from_center;
    }
    float exit = leave_cylinder(user, direction, from_center * length(direction.xz));
    return ((exit >= 0.0) ? exit : from_center);
}

// The morph of a point of the world, for the kernel of arrays and for engines. Lengths in one unit, y up, either hand.

// Squares beyond this come near to float32's end.
const float FAR_SQUARED = 1e28;

// Radius within which points stay (negative: none does), r2, 1 / (r2 - r1), and the strength of the morph.
struct Zones {
    float stays;
    float r2;
    float slope;
    float strength;
};

// At strengths below 1 no point stays where it is. Where r2 is 0 nothing is near.
Zones zones_of(float r1, float r2, float strength) {
    Zones zones = Zones(-1.0, r2, 0.0, strength);
    if (r2 > r1) {
        zones.slope = 1.0 / (r2 - r1);
    }
    if (r2 > 0.0 && strength >= 1.0) {
        zones.stays = r1;
    }
    return zones;
}

// Q - P of the blend. With A = |P-U|, B = |P-O|, v = U-O, e = (A-B)^2, h = w(1-w)/(AB) and n^2 = 1 - h (|v|^2 - e) (the
// squared length of the blend of both directions), Q = P + a (P-O) + b v, where a = h (e + (|v|^2-e)/(1+n))/n and
// b = 1 - w (w + (1-w) B/A)/n. Both are of the size of |v|, so that rounding is relative to the user's offset.
vec3 shift_of_blend(vec3 from_center, vec3 offset, float w) {
    float b_squared = dot(from_center, from_center);
    // The limit for points far above: both directions are one.
    if (w == 0.0 || b_squared > FAR_SQUARED) {
        return (1.0 - w) * offset;
    }
    vec3 from_user = from_center - offset;
    float offset_squared = dot(offset, offset);
    float a = length(from_user);
    float b = sqrt(b_squared);
    if (offset_squared > a * b) {
        vec4 to = blended(from_user, from_center, w);
        return offset + to.w * to.xyz - from_center;
    }
    float difference = (offset_squared - 2.0 * dot(from_center, offset)) / (a + b);
    float e = difference * difference;
    float turn = offset_squared - e;
    float h = w * (1.0 - w) / (a * b);
    float n = sqrt(1.0 - h * turn);
    float along = h * (e + turn / (1.0 + n)) / n;
    float by_offset = 1.0 - w * (w + (1.0 - w) * b / a) / n;
    return along * from_center + by_offset * offset;
}

// Q - P on the cylinder of radius rho.
vec3 shift_on_cylinder(vec3 from_center, vec3 offset, float w, float rho) {
    if (dot(from_center, from_center) > FAR_SQUARED) {
        return offset;
    }
    vec4 to = on_cylinder(ground_place(offset), from_center - offset, from_center, w, rho);
    return offset + to.w * to.xyz - from_center;
}

// Where the user is shown a point p of the world: on its own cylinder, or by the blend. The point and the user are given
// relative to the centre, too: where coordinates are large, subtract in more digits than float32 has.
vec3 shown_in_world(vec3 p, vec3 from_center, vec3 offset, Zones zones, bool keeps_rho) {
    float rho = length(from_center.xz);
    if (rho <= zones.stays) {
        return p;
    }
    float w = zones.strength * user_weight(rho, zones.r2, zones.slope);
    if (keeps_rho) {
        return p + shift_on_cylinder(from_center, offset, w, rho);
    }
    return p + shift_of_blend(from_center, offset, w);
}

// Where the user is shown the point p of the world, by the blend (2022).
vec3 nearfar_morph(vec3 p, vec3 user, vec3 center, float r1, float r2, float strength) {
    return shown_in_world(p, p - center, user - center, zones_of(r1, r2, strength), false);
}

// The same by the cylinder (CloVR, 2024), which keeps each point's distance from the centre's axis.
vec3 nearfar_morph_cylinder(vec3 p, vec3 user, vec3 center, float r1, float r2, float strength) {
    return shown_in_world(p, p - center, user - center, zones_of(r1, r2, strength), true);
}

// How far away the user is shown what the far map holds in a unit direction at a range, with the cylinder.
float nearfar_range_cylinder(vec3 direction, float range, vec3 user, vec3 center) {
    return range_on_cylinder(ground_place(user - center), direction, range);
}
`;var kc=`
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`,cb=`
// The eye, from the centre: each eye of a headset has its own.
uniform vec3 cameraPosition;
// r1, r2, 1 / (r2 - r1), and the strength of the morph; a strength below 0 stands for no morph at all.
uniform vec4 radii;

bool is_morphed() {
  return radii.w >= 0.0;
}
`,zc=kc+Pf+cb;var If=`
precision highp float;
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
in vec3 position;
out vec3 v_direction;

void main() {
  // On the far plane, where the depth is still that of an empty picture.
  gl_Position = vec4(position.xy, 1.0, 1.0);
  vec4 place = inverse(projectionMatrix) * vec4(position.xy, 1.0, 1.0);
  v_direction = transpose(mat3(viewMatrix)) * (place.xyz / place.w);
}
`,Lf=`
${kc}
${Ha}
uniform samplerCube map;
uniform float opacity;
in vec3 v_direction;
out vec4 shade;

void main() {
  shade = vec4(srgb_of(textureLod(map, v_direction, 0.0).rgb), opacity);
}
`;var Nf=`
#if defined(TEXTURED) || defined(GLOWING)
#define MAPPED
#endif
`,Df=`
${zc}
${Nf}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
in vec3 position;
#ifdef SMOOTH
in vec3 normal;
out vec3 v_normal;
#endif
#ifdef MAPPED
in vec2 uv;
out vec2 v_uv;
#endif
#ifdef COLORED
in vec4 color;
out vec3 v_color;
#endif
#ifdef PLACED
// Rows of the matrix from the mesh to metres from the centre.
in vec4 row_x;
in vec4 row_y;
in vec4 row_z;
#else
uniform mat4 placement;
#endif
// From the centre, where it is; from the eye, where it is shown. A picture shows directions, which are the same for both
// kinds of the morph; at the distance of the blend, what is flat beyond R stays flat, however large its triangles are.
out vec3 v_point;
out vec3 v_shown;

vec3 shown(vec3 p) {
  vec3 from_user = p - cameraPosition;
  float rho = length(p.xz);
  if (!is_morphed() || (radii.w == 1.0 && rho <= radii.x)) {
    return from_user;
  }
  float w = radii.w * user_weight(rho, radii.y, radii.z);
  vec4 to = blended(from_user, p, w);
  return to.w * to.xyz;
}

void main() {
#ifdef PLACED
  mat4 placement = transpose(mat4(row_x, row_y, row_z, vec4(0.0, 0.0, 0.0, 1.0)));
#endif
  v_point = (placement * vec4(position, 1.0)).xyz;
  v_shown = shown(v_point);
#ifdef SMOOTH
  // Normals go by the cofactors of the matrix, whatever its scale and handedness.
  mat3 m = mat3(placement);
  v_normal = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])) * normal;
#endif
#ifdef MAPPED
  v_uv = uv;
#endif
#ifdef COLORED
  v_color = color.rgb;
#endif
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`,Uf=`
${zc}
${Ha}
${Nf}
uniform vec4 base_color;
// Share of this picture over the one before, 1 for all.
uniform float opacity;
#ifdef TEXTURED
uniform sampler2D image;
#endif
#if defined(EMISSIVE) || defined(GLOWING)
uniform vec3 emission;
#endif
#ifdef GLOWING
uniform sampler2D glow;
#endif
#ifdef CUTOUT
uniform float cutoff;
#endif
#ifdef SMOOTH
in vec3 v_normal;
#endif
#ifdef MAPPED
in vec2 v_uv;
#endif
#ifdef COLORED
in vec3 v_color;
#endif
in vec3 v_point;
in vec3 v_shown;
out vec4 shade;

// Codes of range, and how codes stand for metres: least, step, texels along a face, and 1 where there are ranges.
uniform usamplerCube codes;
uniform vec4 coding;
const uint NOTHING = 65535u;
// Share of its range by which a fragment may lie behind the map before it counts as hidden.
const float BIAS = 4e-3;

// The farthest of the four texels whose centres enclose a direction.
float farthest_range(vec3 d) {
  vec3 size = abs(d);
  float longest = max(size.x, max(size.y, size.z));
  vec3 at = d / longest;
  float half_texel = 1.0 / coding.z;
  vec3 right = size.x == longest ? vec3(0.0, half_texel, 0.0) : vec3(half_texel, 0.0, 0.0);
  vec3 down = size.z == longest ? vec3(0.0, half_texel, 0.0) : vec3(0.0, 0.0, half_texel);
  if (size.z == longest) {
    right = vec3(half_texel, 0.0, 0.0);
  }
  uint code = max(
    max(texture(codes, at - right - down).r, texture(codes, at + right - down).r),
    max(texture(codes, at - right + down).r, texture(codes, at + right + down).r));
  return code == NOTHING ? 1e38 : coding.x * exp(float(code) * coding.y);
}

// Radius at which static geometry ends and the map begins.
uniform float cut;

bool is_hidden() {
  if (length(v_point.xz) > cut) {
    return true;
  }
  if (coding.w == 0.0 || length(v_point.xz) <= radii.y) {
    return false;
  }
  // Beyond R the morph shows things in the direction in which the centre sees them, so its ranges can be compared.
  float range = length(is_morphed() ? v_point : v_shown);
  return range > farthest_range(normalize(v_shown)) * (1.0 + BIAS);
}

${Cf}
// The face's normal towards the viewer; the vertices' one on its side.
vec3 shading_normal() {
  vec3 face = cross(dFdx(v_point), dFdy(v_point));
  float size = length(face);
  vec3 toward = -normalize(v_shown);
  face = size > 0.0 ? face / size : toward;
  face = dot(face, toward) < 0.0 ? -face : face;
#ifdef SMOOTH
  float long_normal = length(v_normal);
  if (long_normal > 0.0) {
    vec3 n = v_normal / long_normal;
    return dot(n, face) < 0.0 ? -n : n;
  }
#endif
  return face;
}

#ifdef MAPPED
// The level at which a texel is as large as a pixel, by areas.
float level_of(ivec2 size) {
  vec2 dx = dFdx(v_uv) * vec2(size);
  vec2 dy = dFdy(v_uv) * vec2(size);
  return 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
}
#endif

void main() {
#ifdef TEXTURED
  float level = level_of(textureSize(image, 0));
#endif
#ifdef GLOWING
  float glow_level = level_of(textureSize(glow, 0));
#endif
#ifndef UNLIT
  vec3 normal = shading_normal();
#endif
  if (is_hidden()) {
    discard;
  }
  vec3 albedo = base_color.rgb;
#ifdef COLORED
  albedo *= v_color;
#endif
#ifdef TEXTURED
  albedo *= textureLod(image, v_uv, level).rgb;
#endif
#ifdef CUTOUT
#ifdef TEXTURED
  float alpha = base_color.a * textureLod(image, v_uv, 0.0).a;
#else
  float alpha = base_color.a;
#endif
  if (alpha < cutoff) {
    discard;
  }
#endif
#ifdef UNLIT
  vec3 color = albedo;
#else
  vec3 color = albedo * irradiance(normal);
#endif
#ifdef EMISSIVE
  color += emission;
#endif
#ifdef GLOWING
  color += emission * textureLod(glow, v_uv, glow_level).rgb;
#endif
  shade = vec4(srgb_of(color), opacity);
}
`;function Of(n,e){return{radii:{value:new nt},opacity:{value:1},map:{value:n},codes:{value:e},coding:{value:new nt}}}a(Of,"createShared");var ub=1e30,Ff={blending:gr,blendSrc:as,blendDst:pi,blendSrcAlpha:_r,blendDstAlpha:pi,transparent:!1,depthTest:!0,side:hn,glslVersion:Kn};function bs({image:n,glow:e},t){return{image:n===null?null:t(n),glow:e===null?null:t(e)}}a(bs,"texturesOf");function Wa(n,{image:e,glow:t}){let{material:i}=n,r={};return n.normals&&(r.SMOOTH=""),n.colors&&(r.COLORED=""),n.placements&&(r.PLACED=""),e&&n.uvs&&(r.TEXTURED=""),i.cutoff!==null&&(r.CUTOUT=""),i.emission&&(i.glow===null||t&&n.uvs)&&(r[i.glow===null?"EMISSIVE":"GLOWING"]=""),i.isUnlit&&(r.UNLIT=""),r}a(Wa,"definesOf");function Gc(n,e,t,i){let{material:r}=n;return new vn({...Ff,vertexShader:Df,fragmentShader:Uf,defines:Wa(n,e),uniforms:{...t,...hb(r,e),cut:{value:Math.min(i,ub)}}})}a(Gc,"nearMaterial");function Bf(n){let e=new Map;return{of(t,i,r){let s=Object.keys(Wa(t,i)),o=JSON.stringify([s,t.material,String(r)]),l=e.get(o)??Gc(t,i,n,r);return e.set(o,l),l},dispose(){for(let t of e.values())t.dispose();e.clear()}}}a(Bf,"createMaterials");function hb(n,{image:e,glow:t}){return{base_color:{value:new nt(...n.color)},cutoff:{value:n.cutoff??0},image:{value:e},emission:{value:new G(...n.emission??[0,0,0])},glow:{value:t},placement:{value:new Qe}}}a(hb,"ownUniforms");function kf(n){return new vn({...Ff,vertexShader:If,fragmentShader:Lf,depthWrite:!1,uniforms:{map:n.map,opacity:n.opacity}})}a(kf,"farMaterial");function Vc(n,e){let t=Object.entries(e).flatMap(([r,s])=>s?[{name:r,rows:s.rows,attribute:db(n,s,r==="index")}]:[]),i={};for(let{name:r,attribute:s}of t)i[r]=s;return{attributes:i,*steps(){for(let r of _b(t.flatMap(({rows:s,attribute:o})=>[...gb(s,o.buffer)])))yield{kind:"arrays",bytes:r.reduce((o,{data:l})=>o+l.byteLength,0),run:a(()=>{for(let{buffer:o,data:l,start:c}of r)n.bindBuffer(Xa,o),n.bufferSubData(Xa,c,l)},"run")}},dispose(){for(let{attribute:r}of t)n.deleteBuffer(r.buffer)}}}a(Vc,"createBuffers");var Xa=36663;function db(n,{rows:e,width:t,isShare:i=!1},r){let s=n.createBuffer();return r&&fb(n,s),n.bindBuffer(Xa,s),n.bufferData(Xa,e.byteLength,n.STATIC_DRAW),new ss(s,pb(n,e),t,mb(e),e.length/t,i)}a(db,"attributeOf");function fb(n,e){let t=n.getParameter(n.VERTEX_ARRAY_BINDING);n.bindVertexArray(null),n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e),n.bindVertexArray(t)}a(fb,"markIndex");function pb(n,e){return e instanceof Float32Array?n.FLOAT:e instanceof Uint16Array?n.UNSIGNED_SHORT:n.UNSIGNED_INT}a(pb,"typeOf");function mb(n){return n instanceof Uint16Array?2:4}a(mb,"bytesEach");function*gb(n,e){let t=vs/n.BYTES_PER_ELEMENT;for(let i=0;i<n.length;i+=t)yield{buffer:e,data:n.subarray(i,i+t),start:i*n.BYTES_PER_ELEMENT}}a(gb,"partsOf");function*_b(n){let e=[],t=0;for(let i of n)e.length>0&&t+i.data.byteLength>vs&&(yield e,[e,t]=[[],0]),e.push(i),t+=i.data.byteLength;e.length>0&&(yield e)}a(_b,"bundled");var yb=12,Hc=new WeakMap;function zf(n,{gl:e,store:t}){let{same:i}=n,r=!1,s=t.take(i,()=>(r=!0,vb(e,n))),o=n.placements?Vc(e,{placement:Sr(n.placements,yb)}):null,l={arrays:s,placements:o,same:i};return{*steps(){r&&(yield*s.steps()),o&&(yield*o.steps())},make(c){let u=xb(n.name,l,c);return Hc.set(u,l),u},free:a(()=>Vf(l,t),"free")}}a(zf,"prepare");function xb(n,{arrays:e,placements:t},i){let r=t?bb(t):new Tt,{index:s,...o}=e.attributes;for(let[c,u]of Object.entries(o))r.setAttribute(c,u);r.setIndex(s);let l=new st(r,i);return l.name=n,l.frustumCulled=!1,l.matrixAutoUpdate=!1,l}a(xb,"meshOf");function Gf(n,e){let{geometry:t}=n;for(let r of Object.keys(t.attributes))t.deleteAttribute(r);t.setIndex(null),t.dispose();let i=Hc.get(n);i&&Vf(i,e),Hc.delete(n)}a(Gf,"disposeMesh");function Vf({arrays:n,placements:e,same:t},i){i.give(t)&&n.dispose(),e?.dispose()}a(Vf,"free");function vb(n,{positions:e,normals:t,uvs:i,colors:r,indices:s}){return Vc(n,{position:Sr(e,3),normal:t&&Sr(t,3),uv:i&&Sr(i,2),color:r&&{...Sr(r,4),isShare:!0},index:Sr(s,1)})}a(vb,"arraysOf");function Sr(n,e){return{rows:n,width:e}}a(Sr,"columnOf");function bb({attributes:n}){let e=new rs,t=Object.assign(n.placement,{isInstancedBufferAttribute:!0,meshPerAttribute:1,array:new Float32Array(0)});return["row_x","row_y","row_z"].forEach((i,r)=>{e.setAttribute(i,new Xr(t,4,4*r))}),e.instanceCount=t.count,e}a(bb,"placedGeometry");var Sb=4;function Hf(n,e,t,i,r){let s=e.rings.map(()=>Object.assign(new Kt,{visible:!1})),o=Bf(r),l=a(()=>ki(n,t,e.range),"make"),c=[l(),l()];return{entry:e,groups:s,materials:o,triangles:e.rings.map(()=>({own:0,drawn:0})),cubes:c,dispose(){for(let u of s){for(let h of Xc(u))Gf(h,i);u.clear()}o.dispose();for(let u of c)u.dispose()}}}a(Hf,"createRegion");function qa(n,e){let t=n.cubes.find(i=>i.holds===e);if(!t)throw new Error(`the map of ring ${e} is not there`);return t}a(qa,"cubeOf");function Wf({entry:n},e){let{map:t,sharper:i}=n.rings[e]??{};return!!(t??i)}a(Wf,"hasMap");function Wc(n){return n%2===0?0:1}a(Wc,"turnOf");function Xc(n){return n.children}a(Xc,"meshesOf");function Xf(n,e){let t=n.groups[e];if(!t)throw new Error(`there is no ring ${e}`);return t}a(Xf,"groupOf");function qf(n,e,t){Xf(n,e).visible=!0,n.triangles[e]=t}a(qf,"complete");function Yf(n,e){let t={own:0,drawn:0};for(let{own:i,drawn:r}of n.triangles.slice(0,e+1))t.own+=i,t.drawn+=r;return t}a(Yf,"trianglesShown");function*$f(n,e,{bands:t,pieces:i},r,s){let o=e===0?1/0:n.entry.cut,l=Xf(n,e),c=[],u=a(()=>{let h=c.splice(0).map(({piece:p,prepared:d})=>{let f=bs(p.material,_=>r.store.textures.get(_)??null);return d.make(n.materials.of(p,f,o))});r.warm(h),l.add(...h)},"make");try{for(let h of t)yield*s.steps(h);for(let[h,p]of i.entries()){let d=zf(p,r);c.push({piece:p,prepared:d}),yield*d.steps(),(c.length===Sb||h===i.length-1)&&(yield{kind:"mesh",bytes:0,run:u})}}finally{for(let{prepared:h}of c)h.free();for(let{rows:h}of t)h.close()}}a($f,"partSteps");async function Jf(n,e){let{manifest:t,region:i,renderer:r,signal:s,uploads:o}=n,l=await n.maps(qc(n,t.map,i.entry.range,await Bi(n,e.color)));s.throwIfAborted(),await o.add(Va(r,i.cubes[0],l,0,t.map),s)}a(Jf,"loadFirstMap");async function Zf(n,e,{tiles:t,color:i,range:r}){let{manifest:s,maps:o,number:l,region:c,renderer:u,signal:h,uploads:p}=n,[d,f]=await Promise.all([Bi(n,i),Bi(n,r)]),_=Array.isArray(i),v=c.cubes[Wc(e)];await n.mayReplace(e),h.throwIfAborted(),_&&await o(qc(n,s.map,c.entry.range,d)),h.throwIfAborted();let g=v.holds!==null&&v.hasRange?v.holds:null,m=await o({kind:"next-map",region:l,ring:_?1:e,tiles:t,color:_?null:d[0]??null,range:f,since:g});h.throwIfAborted(),await p.add(Va(u,v,m,e,s.map),h)}a(Zf,"loadMap");function qc({number:n,signal:e},{face_size:t,tile:i,across:r},{step:s},o){return e.throwIfAborted(),{kind:"first-map",region:n,faceSize:t,tile:i,across:r,step:s,color:o}}a(qc,"firstRequest");async function Kf(n,e,{layout:t,maps:i,range:r}){let{region:s,renderer:o,signal:l,uploads:c}=n,[u,...h]=i;if(!u||h.length===0)throw new Error("maps of full size: expected those of all rings");let p=await n.maps(qc(n,t,r,await Bi(n,u.color)));for(let[f,_]of h.entries()){let v=f===h.length-1;p=await Mb(n,f+1,_,v)}await n.mayReplace(e),l.throwIfAborted();let d=Wc(e);s.cubes[d].dispose(),s.cubes[d]=ki(o,t.face_size,r),await c.add(Va(o,s.cubes[d],p,e,t),l)}a(Kf,"loadSharper");async function Mb(n,e,{tiles:t,color:i,range:r},s){let[[o],l]=await Promise.all([Bi(n,i),Bi(n,r)]);n.signal.throwIfAborted();let c=s?null:e-1;return n.maps({kind:"next-map",region:n.number,ring:e,tiles:t,color:o??null,range:l,since:c})}a(Mb,"changed");function jf(n,e){let t=n.getContext(),i=new Map;function r(c){n.state.activeTexture(t.TEXTURE0),n.state.bindTexture(t.TEXTURE_2D,c)}a(r,"bind");function s({name:c,width:u,height:h}){let p=t.createTexture();i.set(c,p),r(p);let d=1+Math.floor(Math.log2(Math.max(u,h)));return t.texStorage2D(t.TEXTURE_2D,d,t.SRGB8_ALPHA8,u,h),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,t.LINEAR),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,t.LINEAR_MIPMAP_LINEAR),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_S,t.REPEAT),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.REPEAT),p}a(s,"begin");function o(c){r(i.get(c.name)??s(c));let{state:u}=n;u.pixelStorei(t.UNPACK_FLIP_Y_WEBGL,!1),u.pixelStorei(t.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),u.pixelStorei(t.UNPACK_COLORSPACE_CONVERSION_WEBGL,t.NONE),t.texSubImage2D(t.TEXTURE_2D,0,0,c.y,t.RGBA,t.UNSIGNED_BYTE,c.rows),c.rows.close()}a(o,"send");function l(c){let u=i.get(c);if(!u)return;i.delete(c),r(u),t.generateMipmap(t.TEXTURE_2D);let h=new Ni(u);h.addEventListener("dispose",()=>t.deleteTexture(u)),e(c,h)}return a(l,"finish"),{*steps(c){let{name:u,y:h,rows:p,height:d}=c,f=h+p.height===d;yield{kind:"picture",bytes:4*p.width*p.height,run:a(()=>o(c),"run")},f&&(yield{kind:"picture",bytes:0,run:a(()=>l(u),"run")})},dispose(){for(let c of i.values())t.deleteTexture(c);i.clear()}}}a(jf,"createPictures");async function Qf(n,e,t,{number:i,parts:r,samples:s,triangles:o},l){let{renderer:c,store:u,uploads:h,geometry:p,programs:d,warm:f}=n,_={gl:c.getContext(),store:u,warm:f},v=jf(c,(g,m)=>{u.textures.has(g)?m.dispose():u.textures.set(g,m)});try{l.throwIfAborted(),await d.ready(s);let g=Promise.resolve();for(let m=0;m<r;m++){let S=await p({kind:"part",of:i,part:m}),A=h.add($f(e,t,S,_,v),l);A.catch(()=>{}),await g,g=A}await g,qf(e,t,o)}finally{v.dispose(),p({kind:"drop",of:i}).catch(()=>{})}}a(Qf,"receiveParts");async function tp(n,e){let{manifest:t,region:i,received:r,signal:s,turn:o}=e,u={...n,...e,ahead:yf(a((f,_)=>n.fetch(f,_,r),"fetch"),a(f=>t.files[f]?.bytes??0,"sizeOf")),had:new Set},{rings:h}=i.entry,{map:p}=await o(0,s);p&&await Jf(u,p),e.arrived(0);let{dynamic:d}=t;d&&await ep(u,0,d.geometry,d.parts);for(let f=1;f<h.length;f++){let _=await o(f,s),v=[];_.map&&v.push(Zf(u,f,_.map)),_.sharper&&v.push(Kf(u,f,_.sharper)),_.geometry!==null&&v.push(ep(u,f,_.geometry,_.parts));let g=h[f+1],m=a(S=>!Yc(n,S)&&!u.had.has(S),"isNew");g&&u.ahead.want(Tr(g).filter(m),s),await Promise.all(v),e.arrived(f)}}a(tp,"loadRegion");function Yc({store:n},e){return n.textures.has(e)||n.buffers.has(e)}a(Yc,"isHere");async function ep(n,e,t,i){let{manifest:r,region:s,signal:o,store:l}=n,c=i.filter(f=>!Yc(n,f));for(let f of i)Yc(n,f)&&!n.had.has(f)&&n.received(r.files[f]?.bytes??0),n.had.add(f);let u=l.buffers.has(t);u&&n.received(r.files[t]?.bytes??0);let[h,...p]=await Promise.all([u?{name:t,data:null}:ka(n,t),...c.map(f=>ka(n,f))]);o.throwIfAborted();let d=await n.geometry({kind:"geometry",glb:h,parts:p,known:[...l.textures.keys()],center:s.entry.center,growth:{radii:s.entry.rings.slice(1).map(({radius:f})=>f),nearShare:r.morph.near_share,reach:r.growth.reach},isDynamic:e===0});for(let f of c)f.endsWith(".bin")&&l.buffers.add(f);e===0&&l.buffers.add(t),await Qf(n,s,e,d,o)}a(ep,"loadGeometry");var nn={radius:0,strength:0};function np(n,e,t,i,r=0){let s=i.radii[e-1];if(s===void 0)return nn;let o=i.speed*Math.PI/180/i.reach,l=t,c=n.radius===0?0:n.strength,u=i.radii.find(d=>d>=r)??Number.POSITIVE_INFINITY;if(c===0&&u>s)return{radius:s,strength:c};let h=c===0?u:n.radius;if(c<1){let d=1/(Math.max(i.nearShare,.05)*h*o),f=(1-c)*d;c=l>=f?1:c+l/d,l=Math.max(0,l-f)}if(c<1||h>=s)return{radius:Math.min(h,s),strength:c};let p=1/h-(1-i.nearShare)*o*l;return{radius:p<=1/s?s:1/p,strength:c}}a(np,"grow");function ip(n,{isSmooth:e,isWhole:t}){let i=-1,r=-1,s=0,o=!1,l=!1,c=nn,u=[];function h(){return r>=(t?n.radii.length:0)}a(h,"isThere");function p(v){let[g,m]=[n.radii[0],n.radii[r-1]];return h()?g===void 0||m===void 0?nn:{radius:Math.min(Math.max(v.radius,g),m),strength:v.radius>0?v.strength:0}:null}a(p,"offer");function d(v){let g=n.radii[r-1];return g===void 0?nn:{radius:g,strength:c.strength===1||g>=v?1:0}}a(d,"atOnce");function f(){let v=u.filter(g=>_(g.ring));u=u.filter(g=>!_(g.ring));for(let{done:g}of v)g()}a(f,"release");function _(v){return r>=v-1||i<1}return a(_,"isFree"),{arrive(v){i=v,!(l&&e&&r>=0)&&(r=v,f())},offer:p,enter(v){c=p(v)??nn,l=!0},leave(){l=o=!1,r=i,f()},advance(v,g=0){if(!h())return null;if(c=e?np(c,r,o?0:v,n,g):d(g),!o&&i>r)return o=!0,s=0,{ring:r,grown:c,fading:{ring:r+1,share:0}};if(!o)return{ring:r,grown:c,fading:null};s+=v;let m=n.fade>0?Math.min(s/n.fade,1):1;return m<1?{ring:r,grown:c,fading:{ring:r+1,share:m}}:(r+=1,o=!1,f(),{ring:r,grown:c,fading:null})},replaceable(v){return new Promise(g=>{_(v)?g():u.push({ring:v,done:g})})}}}a(ip,"createStage");function $c(n,e,t){performance.mark(`nearfar:${n}`,{detail:{region:e,ring:t}})}a($c,"tell");function op({world:n,loading:e,manner:t,failed:i}){let{renderer:r,store:s}=e,{nearShare:o}=n,l=new Map,c=new Map,u=[],h=[],p=[];function d(){let x=u.find(w=>wb(l.get(w))),b=h.filter(({region:w})=>w===x);h=h.filter(({region:w})=>w!==x);for(let{done:w}of b)w()}a(d,"call");function f(x,b){return new Promise((w,y)=>{b.addEventListener("abort",()=>y(b.reason),{once:!0}),h.push({region:x,done:w}),d()})}a(f,"turn");async function _(x,b,w,y){let T=b.ring(w);return T instanceof Promise&&(x.isIdle=!0,d(),await T,x.isIdle=!1),await f(x.number,y),T}a(_,"ready");function v(x){let b={stop:new AbortController,from:null,hasFailed:!1},{signal:w}=b.stop;c.set(x,b),n.open(x,w).then(y=>{w.aborted||(c.delete(x),g(x,y,b.stop),b.from&&A(x).stage.enter(b.from))},y=>{w.aborted||(b.hasFailed=!0,i(x,rp(y)))})}a(v,"ask");function g(x,b,w){let{entry:y,manifest:T}=b,L=y.rings.slice(1).map(P=>P.radius),C=ip({...T.growth,radii:L,nearShare:o},t),D=Hf(r,y,T.map.face_size,s,e.shared),N={number:x,region:D,stage:C,stop:w,arrived:-1,shown:null,received:0,get expected(){return Ju(T,ml(T,y))},state:"loading",isIdle:!1,needed:a(()=>ml(T,y),"needed")};l.set(x,N);let B=a(P=>{N.state=P,d()},"ended");tp(e,{manifest:T,region:D,number:x,arrived(P){N.arrived=P,$c("arrived",x,P),C.arrive(P)},received:a(P=>{N.received+=P},"received"),turn:a((P,q)=>_(N,b,P,q),"turn"),mayReplace:a(P=>C.replaceable(P),"mayReplace"),signal:w.signal}).then(()=>B("complete"),P=>{w.signal.aborted||(B("failed"),i(x,rp(P)))})}a(g,"begin");function m(x){l.delete(x.number),x.stop.abort(),x.region.dispose(),h=h.filter(({region:y})=>y!==x.number);let b=[...l.values()].flatMap(y=>[...y.needed()]),w={kind:"forget",buffers:s.keep(new Set(b)),region:x.number};Promise.all([e.geometry(w),e.maps(w)]).then(y=>{p=y},()=>{})}a(m,"end");function S(x,b){v(x);let w=c.get(x);w&&(w.from=b)}a(S,"again");function A(x){let b=l.get(x);if(!b)throw new Error(`region ${x} is not open`);return b}return a(A,"found"),{find:a(x=>l.get(x)??null,"find"),open(x){!l.has(x)&&!c.has(x)&&v(x)},close(x){c.get(x)?.stop.abort(),c.delete(x);let b=l.get(x);b&&m(b)},prefer(x){u=x,d()},offer:a((x,b)=>l.get(x)?.stage.offer(b)??null,"offer"),isComplete:a(x=>l.get(x)?.state==="complete","isComplete"),isCoarse:a(x=>l.get(x)?.region.entry.isCoarse??!1,"isCoarse"),enter(x,b){let w=c.get(x);if(w){w.from=b;return}let y=A(x);y.stage.enter(b),y.shown=null},leave(x){let b=l.get(x);b?.stage.leave(),b&&(b.shown=null)},grown:a(x=>l.get(x)?.shown?.grown??null,"grown"),advance(x,b,w){let y=l.get(x);if(!y)return null;let T=sp(y.shown);y.shown=y.stage.advance(b,w);let L=sp(y.shown);return L>T&&$c("shown",x,L),y.shown},retry(){for(let x of[...l.values()].filter(({state:b})=>b==="failed")){let{grown:b}=x.shown??{};m(x),S(x.number,b??null)}for(let[x,{hasFailed:b,from:w}]of c)b&&S(x,w)},get holding(){let x=[...c.values()].some(({hasFailed:w})=>!w),b=[...l.values()].some(({state:w})=>w==="loading");return{regions:[...l.keys(),...c.keys()],isLoading:x||b,kept:p}},dispose(){for(let{stop:x}of c.values())x.abort();c.clear();for(let x of[...l.values()])m(x)}}}a(op,"createAtlas");function wb(n){return n?.state==="loading"&&!n.isIdle}a(wb,"isLoading");function rp(n){return n instanceof Error?n:new Error(String(n))}a(rp,"asError");function sp(n){return n?.fading?.ring??n?.ring??-1}a(sp,"lastOf");function ap(n,e,t,{camera:i,rig:r,setPose:s}){let o=null,l=null;function c(f,_,v,g=!0){let m=e.find(f);if(!m?.shown||_===0)return;let{ring:S,grown:A,fading:x}=m.shown,b={region:m.region,radius:A.radius,strength:v?A.strength:null};t.draw({...b,ring:S},i,_,g),_===1&&x&&x.share>0&&t.draw({...b,ring:x.ring},i,x.share)}a(c,"paint");function u({region:f,leaving:_},v,g){let m=_?.pose??v;_&&m&&(s(m),c(_.region,1,g)),v&&s(v),c(f,_?.share??1,g)}a(u,"paintLeg");function h({region:f,leaving:_}){_&&!_.pose&&c(_.region,1,!0),c(f,_?.share??1,!0,_!==null||!p(f))}a(h,"paintEyes");function p(f){let _=e.find(f);return!_?.shown||_.shown.fading?!1:l?.show(qa(_.region,_.shown.ring),r.rotation.y)??!1}a(p,"isApart");function d(f,_,v){let{clientWidth:g,clientHeight:m}=n.domElement,S=Math.round(v*g);n.setScissorTest(!0),n.setScissor(0,0,S,m),u(f,_,!1),n.setScissor(S,0,g-S,m),u(f,_,!0),n.setScissorTest(!1)}return a(d,"paintSides"),{draw(f,_){e.find(f.region)?.shown&&(n.xr.isPresenting?h(f):o===null?u(f,_,!0):d(f,_,o))},setDivider(f){o=f},setMapLayer(f){l=f}}}a(ap,"createComposer");function lp(n,e){let t=new Worker(n,{type:"module"}),i=new Map,r=0,s=null;return t.onmessage=l=>{let c=performance.now(),{data:u}=l,h=i.get(u.id);i.delete(u.id),"error"in u?h?.failed(new Ce(u.error)):h?.done(u.result),e(performance.now()-c)},t.onerror=l=>{s=new Ce(`the decoder stopped: ${l.message||"the browser gives no reason"}`,"other");for(let{failed:c}of i.values())c(s);i.clear()},{decode:a(l=>new Promise((c,u)=>{if(s){u(s);return}let h=++r;i.set(h,{done:c,failed:u}),t.postMessage({...l,id:h},Eb(l))}),"decode"),dispose:a(()=>t.terminate(),"dispose")}}a(lp,"startDecoder");function Eb(n){switch(n.kind){case"geometry":return[n.glb,...n.parts].flatMap(({data:e})=>e??[]);case"first-map":return n.color.map(e=>e.data);case"next-map":return[...n.color?[n.color]:[],...n.range].map(e=>e.data);case"part":case"drop":case"forget":return[]}}a(Eb,"buffersOf");var[Tb,Ab]=[.1,2],Rb=.3,Cb=.5,Pb=1-1e-9,[Ib,Lb]=[.9,.5];function up(n,e,t){let i=t,r=null,s=null,o=null,l=null,c=[t],{places:u}=n;function h(A,x){let{center:b,fold_margin:w}=u.of(A);return{center:b,metres:x&&x.strength>0?n.marginShare*x.radius:w}}a(h,"limitOf");function p(A,x){return A.metres-Mt(x,A)}a(p,"room");let d=a((A,x)=>Ti(u.of(A).center,x),"far");function f(A){let x=e.grown(i),b=x&&e.offer(A,x);return!x||!b||x.strength>0&&b.strength===0?null:b}a(f,"offered");function _(A,x){let[b,w]=[e.grown(i),f(A)];if(!b||!w)return!1;let y=Math.min(Tb*d(A,u.of(i).center),Ab),[T,L]=[h(i,b),h(A,w)],C=d(A,x)+y<=d(i,x),D=w.radius>=b.radius&&!e.isCoarse(A),N=b.strength===0||D||e.isComplete(A);return C&&N&&p(L,x)>=Rb*L.metres?!0:p(T,x)<(1-.8)*T.metres&&p(L,x)>=Math.max(p(T,x),0)+y}a(_,"mayCross");function v(A,x,b){s={region:i,pose:b,since:0},A!==i&&(e.enter(A,x),i=A)}a(v,"take");function g(A,x,b){let{center:w,metres:y}=h(A,x);return{...b,position:Ps(b.position,{center:w,metres:Ib*y})}}a(g,"landing");function m(A){if(!o)return;let{region:x,target:b}=o,w=e.grown(i),y=x===i,T=y?w:e.offer(x,w??nn);if(!T)return;let L=y||p(h(x,T),b.position)>(1-.8)*h(x,T).metres,C=g(x,L?T:nn,b);o=null,v(x,L&&w?w:nn,w?A:null),w||(s=null),l=C,n.moved(C)}a(m,"depart");function S(A){let x=o?.region??null;s?r=s.region===i?null:s.region:r=x===null?u.ahead({place:A,current:i,ahead:r,limit:h(i,e.grown(i))}):null;let b=s?r:x??r,w=[...new Set([i,b??i])];b!==null&&(x!==null&&!s||d(b,A)<d(i,A))&&w.reverse();for(let T of c)w.includes(T)||e.close(T);for(let T of w)e.open(T);c=w,e.prefer(w)}return a(S,"arrange"),e.open(t),e.enter(t,nn),{advance(A,x){l=x,s&&(s.since+=A,s.since>=n.fade&&(s.region!==i&&e.leave(s.region),s=null)),s||m(x),S(l.position),!s&&!o&&r!==null&&_(r,l.position)&&(v(r,e.grown(i)??nn,null),S(l.position));let b=s&&n.fade>0?s.since/n.fade:1;return{region:i,leaving:s&&{region:s.region,pose:s.pose,share:b}}},go(A){let x=u.nearest(A.position),b=h(i,e.grown(i));o={region:p(b,A.position)>=Lb*b.metres?i:x,target:A}},failed(A){o?.region===A&&A!==i&&e.offer(A,nn)===null&&(o=null)},get bounds(){let A=h(i,e.grown(i)),x=s&&!s.pose?[A,h(s.region,e.grown(s.region))]:[A],b=!s&&r!==null?f(r):null;return{shown:x,open:b&&r!==null?[A,h(r,b)]:[A]}},get region(){return i},get goal(){return o?.region??null},get least(){let{center:A,fold_margin:x}=u.of(i),b=l?Mt(l.position,{center:A,metres:x}):0;return Pb*Math.min(b+Cb,x)/n.marginShare}}}a(up,"createJourney");function hp(n,e,t){let i=!1,r=new AbortController,{signal:s}=r,o=a(c=>{c.preventDefault(),i=!0,e()},"went"),l=a(()=>{i=!1,t()},"came");return n.addEventListener("webglcontextlost",o,{signal:s}),n.addEventListener("webglcontextrestored",l,{signal:s}),{get isLost(){return i},dispose:a(()=>r.abort(),"dispose")}}a(hp,"watchLoss");var Nb=`
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,Db=`
precision mediump float;
uniform float darkness;
out vec4 shade;

void main() {
  shade = vec4(0.0, 0.0, 0.0, darkness);
}
`;function dp(){let n={value:0},e=new vn({vertexShader:Nb,fragmentShader:Db,glslVersion:Kn,uniforms:{darkness:n},blending:gr,blendSrc:_r,blendDst:pi,depthTest:!1,depthWrite:!1,transparent:!0}),t=new st(Ss(),e);return t.frustumCulled=!1,t.visible=!1,{mesh:t,set(i){n.value=i,t.visible=i>0}}}a(dp,"createVeil");function Ss(){let n=new Tt;return n.setAttribute("position",new Xt(new Float32Array([-1,-1,0,3,-1,0,-1,3,0]),3)),n}a(Ss,"covering");var Ub=`
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,Ob=`
precision highp float;
precision highp sampler2D;
uniform sampler2D depth;
out vec4 digits;

void main() {
  float value = texelFetch(depth, ivec2(0), 0).r;
  vec3 scaled = fract(value * vec3(1.0, 255.0, 65025.0));
  digits = vec4(scaled - vec3(scaled.yz / 255.0, 0.0), value < 1.0 ? 1.0 : 0.0);
}
`;function fp(n,e,[t,i],r){let s=new Ft(1,1,{depthTexture:new xn(1,1,tn)}),o=new Ft(1,1),l=new vn({vertexShader:Ub,fragmentShader:Ob,glslVersion:Kn,blending:Yn,depthTest:!1,uniforms:{depth:{value:s.depthTexture}}}),c=new st(Ss(),l);c.frustumCulled=!1;let u=new jt;u.add(c);let h=n.getRenderTarget(),[p,d]=[n.domElement.width,n.domElement.height];e.setViewOffset(p,d,Math.floor(t*p),Math.floor(i*d),1,1);try{n.setRenderTarget(s),r(),n.setRenderTarget(o),n.render(u,e);let f=new Uint8Array(4);if(n.readRenderTargetPixels(o,0,0,1,1,f),f[3]===0)return null;let _=((f[2]??0)/65025+(f[1]??0)/255+(f[0]??0))/255;return new G(0,0,2*_-1).unproject(e)}finally{e.clearViewOffset(),n.setRenderTarget(h),c.geometry.dispose(),l.dispose(),s.depthTexture?.dispose(),s.dispose(),o.dispose()}}a(fp,"pick");function pp(n,e,t,i,r){let s=new jt,o=new jt;return o.add(Fb(e)),{prepare(l){n.compile(o,l)},draw(l,c,u,h=!0){let{region:p,ring:d,radius:f,strength:_}=l;r(p.entry.center);let v=Wf(p,d)?qa(p,d):i(),g=t*f,m=f>0?1/(f-g):1;e.radii.value.set(g,f,m,_??-1),e.map.value=v.color,e.codes.value=v.codes;let{least:S,step:A}=v.scale;e.coding.value.set(S,A,v.size,v.hasRange?1:0),e.opacity.value=u,s.children=p.groups.slice(0,d+1),n.clearDepth(),u<1&&(Jc(p,d,!1,!0),n.render(s,c),Jc(p,d,!0,!1)),n.render(s,c),u<1&&Jc(p,d,!0,!0),h&&n.render(o,c),s.children=[]}}}a(pp,"createPainter");function Jc(n,e,t,i){for(let r of n.groups.slice(0,e+1).flatMap(Xc))r.material.colorWrite=t,r.material.depthWrite=i}a(Jc,"setWrites");function Fb(n){let e=new st(Ss(),kf(n));return e.frustumCulled=!1,e}a(Fb,"screen");function mp(n,e,t,i){let r=new Map,s=new Ot;async function o(c){let u=Gc(c,bs(c.material,()=>s),t,1/0),h=new jt().add(new st(new Tt,u)),p=Promise.resolve(),d=a(()=>{p=zb(n,h,e)},"begin");await i.add([{kind:"program",bytes:0,run:d}],new AbortController().signal,!0),await p,await Gb(n);let f=performance.now();Vb(n,u),i.spend(performance.now()-f)}a(o,"make");function l(c){return Object.keys(Wa(c,bs(c.material,()=>s))).join(" ")}return a(l,"kindOf"),{async ready(c){let u=c.map(h=>{let p=l(h),d=r.get(p)??o(h);return r.set(p,d),d});await Promise.all(u)},forget(){r.clear()}}}a(mp,"createPrograms");var[Bb,kb]=[10,3];async function zb(n,e,t){if(n.extensions.has("KHR_parallel_shader_compile")){await n.compileAsync(e,t);return}n.compile(e,t),await gp(n)}a(zb,"compile");async function gp(n){let e=n.getContext(),t=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0);for(e.flush();t&&!e.isContextLost()&&e.getSyncParameter(t,e.SYNC_STATUS)!==e.SIGNALED;)await new Promise(i=>setTimeout(i,Bb));e.deleteSync(t)}a(gp,"passed");async function Gb(n){for(let e=0;e<kb;e++){let{frame:t}=n.info.render;if(await gp(n),n.info.render.frame===t)return}}a(Gb,"idle");function Vb(n,e){let t=n.getContext(),{currentProgram:i}=n.properties.get(e);if(!(!i||t.isContextLost())){if(t.getProgramParameter(i.program,t.LINK_STATUS)!==!0){let r=[i.vertexShader,i.fragmentShader].map(s=>t.getShaderInfoLog(s));throw new Error(`the browser refuses a program: ${[t.getProgramInfoLog(i.program),...r].join(" ")}`)}i.getUniforms(),i.getAttributes()}}a(Vb,"look");function _p(){let n=new Map,e=new Set,t=new Map;return{textures:n,buffers:e,take(i,r){if(i===null)return r();let s=t.get(i)??{arrays:r(),users:0};return t.set(i,s),s.users+=1,s.arrays},give(i){let r=i===null?void 0:t.get(i);return!r||i===null?!0:(r.users-=1,r.users>0?!1:(t.delete(i),!0))},keep(i){for(let[s,o]of n)i.has(s)||(o.dispose(),n.delete(s));let r=[...e].filter(s=>!i.has(s));for(let s of r)e.delete(s);return r},get shared(){return[...t.values()].filter(({users:i})=>i>1).length}}}a(_p,"createStore");var Hb=.05,Wb=3e4;function yp(n){let e=new Gt(n,1,Hb,Wb);e.rotation.order="YXZ";let t=new Kt;t.add(e);let i={x:0,y:0,z:0};function r({position:[s,o,l],yaw:c}){Object.assign(i,{x:s,y:o,z:l}),t.rotation.y=c}return a(r,"stand"),{camera:e,rig:t,place(s){t.position.set(i.x-s[0],i.y-s[1],i.z-s[2]),t.updateMatrixWorld(!0)},setPose({position:[s,o,l],yaw:c,pitch:u}){r({position:[s,o,l],yaw:0}),e.position.set(0,0,0),e.rotation.set(u,c,0)},stand:r}}a(yp,"createViewpoint");function xp(n,e){n.clear();let t=n.getRenderTarget(),i=t?.samples??0;t&&(t.samples=0),e(),t&&(t.samples=i)}a(xp,"resolveOnce");var Xb=3;function vp(n,e){let{faceSize:t,fade:i,marginShare:r,nearShare:s,places:o}=e.world,l=qb(n,e.antialias),c=yp(e.angle),{camera:u,rig:h,setPose:p,stand:d}=c,f=dp(),_=new jt;_.add(h,f.mesh);let v=ki(l,1),g=Of(v.color,v.codes),m=za(l.getContext()),S=vf(()=>performance.now(),m),A=a(()=>lp(e.worker,S.spend),"start"),x=[A(),A()],b=pp(l,g,s,()=>v,c.place);b.prepare(u);let w=mp(l,u,g,S),y=new jt,T=_p(),L={renderer:l,shared:g,store:T,uploads:S,geometry:x[0].decode,maps:x[1].decode,fetch:e.fetch,programs:w,warm(ne){for(let{geometry:he}of ne)he.setDrawRange(0,0);y.children=[...ne],l.render(y,u),y.children=[];for(let{geometry:he}of ne)he.setDrawRange(0,1/0)}},C=op({world:e.world,loading:L,manner:e,failed(ne,he){N?.failed(ne),e.failed(he)}}),D=ap(l,C,b,c),N=null,B=null,P=null,q=0,$=null,O=hp(n,()=>{$=N?.region??null,j(),v.dispose(),w.forget(),S.forget(),e.lost(!0)},()=>{l.setClearAlpha(0),v=ki(l,1),[g.map.value,g.codes.value]=[v.color,v.codes],b.prepare(u),$!==null&&H($),e.lost(!1)});function j(){for(let ne of C.holding.regions)C.close(ne);N=B=null}a(j,"close");function H(ne){j(),N=up({places:o,marginShare:r,fade:i,moved:a(X=>{P=X,e.moved(X)},"moved")},C,ne)}a(H,"begin");function Q(){if(l.xr.isPresenting)return;let{clientWidth:ne,clientHeight:he}=n,X=Math.min(window.devicePixelRatio,2);n.width===Math.floor(ne*X)&&n.height===Math.floor(he*X)||(l.setPixelRatio(X),l.setSize(ne,he,!1),u.aspect=ne/he,u.updateProjectionMatrix())}a(Q,"fit");function te(ne,he){q=S.run(Xb),N&&(B=N.advance(he,ne),C.advance(B.region,B.leaving?0:he,N.least),D.draw(B,P))}return a(te,"advance"),{uploads:S,renderer:l,camera:u,rig:h,faceSize:t,open:H,go:a(ne=>N?.go(ne),"go"),pointAt(ne,he){let X=B&&C.find(B.region);if(!X?.shown||!P)return null;let{region:me,shown:be}=X;p(P);let{radius:Re,strength:ge}=be.grown,Ne=fp(l,u,[ne,he],()=>{b.draw({region:me,ring:be.ring,radius:Re,strength:ge},u,1,!1)}),{center:ot}=me.entry;return Ne&&[Ne.x+ot[0],Ne.y+ot[1],Ne.z+ot[2]]},retry:C.retry,frame(ne,he){if(P=ne,O.isLost)return;Q();let{isPresenting:X}=l.xr;X?xp(l,()=>te(ne,he)):te(ne,he),(X||f.mesh.visible)&&l.render(_,u)},stand:d,setMapLayer:D.setMapLayer,setVeil:f.set,still(ne,he){let X=N&&C.find(N.region);if(!X)throw new Error("no region is open");p(he),b.draw({...ne,region:X.region},u,1)},setDivider:D.setDivider,photo(){return l.xr.isPresenting?Promise.reject(new Error("Pictures are saved outside the headset")):O.isLost||!B||!C.find(B.region)?.shown?Promise.reject(new Error("There is no picture yet")):(D.draw(B,P),new Promise((ne,he)=>{n.toBlob(X=>X?ne(X):he(new Error("The browser gives no picture")),"image/png")}))},get facts(){let ne=N?.region??0,he=C.find(ne),X=he?.shown?.fading?.ring??he?.shown?.ring??0;return{region:ne,entry:he?.region.entry??null,goal:N?.goal??null,leaving:B?.leaving?.region??null,shown:he?.shown??null,arrived:he?.arrived??-1,received:he?.received??0,expected:he?.expected??0,triangles:he?Yf(he.region,X):{own:0,drawn:0},upload:q,bounds:N?.bounds??null,...C.holding,shared:T.shared}},dispose(){C.dispose();for(let ne of x)ne.dispose();v.dispose(),O.dispose(),l.dispose(),l.forceContextLoss()}}}a(vp,"createViewer");function qb(n,e){let t;try{t=new Oa({canvas:n,antialias:e,powerPreference:"high-performance"})}catch(i){throw new Ce(i instanceof Error?i.message:String(i),"webgl")}return t.autoClear=!1,t.setClearAlpha(0),t.sortObjects=!1,t.debug.checkShaderErrors=!1,t}a(qb,"createRenderer");function ve(n,e={},...t){let i=document.createElement(n);return Zc(i,e),i.append(...t),i}a(ve,"make");var bp="http://www.w3.org/2000/svg";function jn(n){let e=document.createElementNS(bp,"svg");Zc(e,{viewBox:"0 0 24 24",class:"icon","aria-hidden":"true",focusable:"false"});let t=document.createElementNS(bp,"path");return Zc(t,{d:n}),e.append(t),e}a(jn,"icon");function gi(n,e){n.textContent!==e&&(n.textContent=e)}a(gi,"write");function Zc(n,e){for(let[t,i]of Object.entries(e))i!==void 0&&i!==!1&&n.setAttribute(t,i===!0?"":i)}a(Zc,"setAll");var At={walk:"M13 4.5a1.5 1.5 0 1 0 0-.01M9.5 21l2-5.5-2-3 1-4.5 3 .5 2 3 2.5 1M7 12.5l.5-3 3-1.5M12.5 13l2.5 3.5.5 4.5",orbit:"M12 14a2 2 0 1 0 0-4 2 2 0 0 0 0 4M17 8c2.5.8 4 2.2 4 4 0 2.8-4 5-9 5s-9-2.2-9-5 4-5 9-5M9.5 4L13 7l-3.5 3",split:"M12 3v18M4 6h5M4 6v12h5M20 6h-5M20 6v12h-5",photo:"M4 8h3.5L9 5.5h6L16.5 8H20v11H4zM12 16.5a3.25 3.25 0 1 0 0-6.5 3.25 3.25 0 0 0 0 6.5",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",home:"M4 11.5L12 5l8 6.5M6 10v9h4v-5h4v5h4v-9",next:"M12 21c-4-4.6-6-7.9-6-10.5a6 6 0 0 1 12 0C18 13.1 16 16.4 12 21M10 8.5l2.5 2-2.5 2",panel:"M4 5h16v14H4zM7 9h6M7 12h10M7 15h8",help:"M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.5v.01M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18",headset:"M3 8.5h18v8h-5.5L13.5 14h-3l-2 2.5H3zM7.5 12v.01M16.5 12v.01",close:"M6 6l12 12M18 6L6 18",grip:"M9 7l-5 5 5 5M15 7l5 5-5 5"};var[Ya,Sp]=[.01,.1],Mp=40,$a=.5;function wp(n,e){let t=a((d,f)=>ve("span",{class:`divider-label divider-${d}`,"aria-hidden":"true"},f),"label"),[i,r]=[t("left","Conventional"),t("right","Continuous")],s=ve("div",{class:"divider",role:"slider",tabindex:"0","aria-label":"Divider between the conventional picture, left, and the continuous one, right","aria-orientation":"horizontal","aria-valuemin":"0","aria-valuemax":"100"},i,ve("span",{class:"divider-grip"},jn(At.grip)),r),o=ve("div",{class:"divider-layer",hidden:!0},s);n.prepend(o);let l=new ResizeObserver(h);l.observe(o);let c=null;function u(d){let f=d===null||Number.isNaN(d)?null:Math.min(Math.max(d,0),1);if(f!==c){if(c=f,o.hidden=c===null,c!==null){let _=String(Math.round(100*c));o.style.setProperty("--share",String(c)),s.setAttribute("aria-valuenow",_),s.setAttribute("aria-valuetext",`${_} percent conventional`),h()}e(c)}}a(u,"set");function h(){let[d,f]=[o.clientWidth,c??$a];i.classList.toggle("is-cut",i.offsetWidth+Mp>f*d),r.classList.toggle("is-cut",r.offsetWidth+Mp>(1-f)*d)}a(h,"arrange");function p(d){if(!s.hasPointerCapture(d.pointerId))return;let{left:f,width:_}=o.getBoundingClientRect();u((d.clientX-f)/Math.max(_,1))}return a(p,"drag"),s.addEventListener("pointerdown",d=>{d.button===0&&(s.setPointerCapture(d.pointerId),s.focus({preventScroll:!0}),d.preventDefault())}),s.addEventListener("pointermove",p),s.addEventListener("keydown",d=>{let f=Yb(d.key,c??$a);f===void 0||d.ctrlKey||d.metaKey||d.altKey||(u(f),d.preventDefault(),d.stopPropagation())}),{get share(){return c},set:u,dispose(){l.disconnect(),o.remove()}}}a(wp,"createDivider");function Yb(n,e){let i=new Map([["ArrowLeft",e-Ya],["ArrowDown",e-Ya],["ArrowRight",e+Ya],["ArrowUp",e+Ya],["PageDown",e-Sp],["PageUp",e+Sp],["Home",0],["End",1],["Escape",null]]).get(n);return typeof i=="number"?Math.min(Math.max(i,0),1):i}a(Yb,"nextShare");var Kc=3,Ep={scene:{title:"The server cannot load the scene",text:"Tell whoever runs the server what stands below. The page shows the scene as soon as the server has it."},place:{title:"The server cannot show this place",text:"Remove the place from the address of this page, or tell whoever sent you here what stands below."},webgl:{title:"This browser cannot draw the scene",text:"The page needs WebGL 2. Switch on hardware acceleration in the settings of the browser, or open the page in a current Chrome, Edge, Firefox or Safari."},damaged:{title:"The scene is damaged",text:"A file is not what the manifest says. Export the scene again, or tell whoever sent you here."},newer:{title:"The scene needs a newer nearfar",text:"It was written in a later format than this page reads. Update nearfar and reload the page."},network:{title:"The scene cannot be reached",text:"The server does not answer, or does not have it. Check the connection and the address, and try again."},address:{title:"The address asks for what is not there",text:"Mend or remove what stands behind the question mark in the address of this page."},other:{title:"The scene cannot be shown",text:"Reload the page. If that does not help, tell whoever sent you here what stands below."}};function Tp(n,e,{detail:t,retry:i}={}){let r=ve("h1",{tabindex:"-1",id:"message-title"},n),s=ve("div",{class:"fatal-card"},ve("p",{class:"fatal-brand"},"nearfar"),r);s.append(ve("p",{},e)),t&&s.append(ve("p",{class:"fatal-detail"},t)),i&&s.append(Rp("Try again","button-main",i));let o=jc();o.replaceChildren(s),o.dataset.kind="fatal";for(let l of document.querySelectorAll("canvas, [data-behind]"))l.setAttribute("inert","");r.focus({preventScroll:!0})}a(Tp,"showFatal");function Ap(n,e){let t=jc();if(t.dataset.kind==="fatal")return;let i=ve("ul",{},...n.slice(0,Kc).map(o=>ve("li",{},o)));n.length>Kc&&i.append(ve("li",{},`and ${n.length-Kc} more`));let r=ve("button",{type:"button",class:"button-icon","aria-label":"Dismiss",title:"Dismiss"});r.append(jn(At.close)),r.addEventListener("click",Ja);let s=ve("div",{class:"banner-text"},ve("strong",{},"Not all of the scene is shown"),i);n.length===0?Ja():(t.replaceChildren(s,Rp("Try again","button-main",e),r),t.dataset.kind="banner")}a(Ap,"showProblems");function Ja(){let n=jc();n.replaceChildren(),delete n.dataset.kind;for(let e of document.querySelectorAll("canvas, [data-behind]"))e.removeAttribute("inert")}a(Ja,"clearMessage");function Rp(n,e,t){let i=ve("button",{type:"button",class:e},n);return i.addEventListener("click",t),i}a(Rp,"button");function jc(){let n=document.getElementById("message");if(n)return n;let e=ve("div",{id:"message",role:"alert"});return document.body.append(e),e}a(jc,"message");var eu=["","k","M","G","T"];function Cp(n,e){if(!_i(n)||!_i(e))return"\u2013";let t=Ip(Math.max(n,e));return`${Qc(n,t)} of ${Qc(e,t)}\xA0${eu[t]}B`}a(Cp,"bytesOf");function Pp(n){return n===null?"idle":$b(n,"b/s")}a(Pp,"rate");function Za(n){return _i(n)?n>=9995e5?`${(n/1e9).toFixed(2)}\xA0billion`:n>=999999.5?`${(n/1e6).toFixed(2)}\xA0million`:Math.round(n).toLocaleString("en"):"\u2013"}a(Za,"count");function tu(n,e){if(!_i(n)||!_i(e))return"\u2013";let t=e>0?100*n/e:100;return t>0&&t<1?"<\xA01\xA0%":`${Math.min(Math.floor(t),100)}\xA0%`}a(tu,"percent");function nu(n){return _i(n)?`${n.toFixed(n<99.95?1:0)}\xA0ms`:"\u2013"}a(nu,"milliseconds");function Ka(n){return _i(n)?n>=999.5?`${(n/1e3).toFixed(1)}\xA0km`:`${n.toFixed(n<.995?2:n<99.95?1:0)}\xA0m`:"\u2013"}a(Ka,"metres");function $b(n,e){if(!_i(n))return"\u2013";let t=Ip(n);return`${Qc(n,t)}\xA0${eu[t]}${e}`}a($b,"scaled");function Ip(n){let e=0;for(;e<eu.length-1&&n/1e3**e>=999.5;)e+=1;return e}a(Ip,"powerOf");function Qc(n,e){let t=n/1e3**e;return t.toFixed(e>1&&t<99.95?1:0)}a(Qc,"digits");function _i(n){return Number.isFinite(n)&&n>=0}a(_i,"isAmount");function Jb(n){let{ring:e,rings:t,radius:i,received:r,expected:s,frame:o,longest:l,triangles:c,drawn:u,sceneTriangles:h}=n;return{Loaded:`${Cp(r,s)} (${tu(r,s)})`,Speed:iu(n)?"all is here":Pp(n.rate),Ring:e===0?`map only, of ${t}`:`${e} of ${t}`,Radius:e===0?Lp:Ka(i),Triangles:`${Za(c)} of ${Za(h)}`,"Split into":u>c?Za(u):Lp,Frame:`${nu(o)}, at most ${nu(l)}`,...Zb(n),"From centre":`${Ka(n.away)} of ${Ka(n.foldMargin)}`}}a(Jb,"linesOf");var Lp="\u2013";function iu({ring:n,rings:e,received:t,expected:i,isSharp:r}){return n>=e&&t>=i&&r}a(iu,"isComplete");function ja({making:n,isSharp:e}){if(!n)return null;let{stage:t}=n;return t==="waiting"?n.before>0?`waiting, ${n.before} before`:"being made":t==="busy"?`server busy, again in ${n.seconds} s`:t==="asked"?"asked for":e?"refined":"coarse, being refined"}a(ja,"madeOf");function Np({making:n}){return n?.stage==="busy"||n?.stage==="waiting"&&n.before>0}a(Np,"isHeld");function Zb(n){let e=ja(n);return e!==null?{Place:e}:{Region:`${n.region+1} of ${n.regions??1}`}}a(Zb,"placeOf");function Dp(n){let e=ja(n);return n.rings===0&&e!==null?`place: ${e}`:`${tu(n.received,n.expected)} loaded, ring ${n.ring} of ${n.rings}`}a(Dp,"shortly");function Up(){let n=new Map,e=ve("dl",{class:"figures"}),t=ve("div",{class:"reach","aria-hidden":"true"},ve("span",{})),i=ve("ul",{class:"problems"});function r(s){let o=n.get(s);if(o)return o;let l=ve("dd",{});return e.append(ve("div",{},ve("dt",{},s),l)),n.set(s,l),l}return a(r,"line"),{element:ve("div",{class:"panel-body"},e,t,i),update(s){for(let[c,u]of Object.entries(Jb(s)))gi(r(c),u);let o=s.foldMargin>0?Math.min(s.away/s.foldMargin,1):0;t.style.setProperty("--share",o.toFixed(3)),t.dataset.near=String(o>.8);let l=s.problems;l.join(`
`)!==[...i.children].map(({textContent:c})=>c).join(`
`)&&i.replaceChildren(...l.map(c=>ve("li",{},c)))}}}a(Up,"createFigures");var zi={walk:{key:"1",label:"1",does:"walk"},orbit:{key:"2",label:"2",does:"orbit around what lies ahead"},split:{key:"c",label:"C",does:"compare with the conventional picture"},photo:{key:"p",label:"P",does:"save the picture"},link:{key:"l",label:"L",does:"copy a link to this view"},home:{key:"home",label:"Home",does:"go back to the centre"},next:{key:"n",label:"N",does:"go to the next place"},look:{key:"f",label:"F",does:"look around with the mouse without a button, until Esc"},panel:{key:"i",label:"I",does:"show or hide the figures"},retry:{key:"r",label:"R",does:"load again what failed"},headset:{key:"v",label:"V",does:"enter the headset, and leave it"},help:{key:"?",label:"?",does:"show or hide this help"}};function Op(n,e,t){let i=new Map(Object.entries(zi).map(([r,{key:s}])=>[s,r]));n.addEventListener("keydown",r=>{let s=r;if(ol(s)||s.repeat||sl(s.code))return;let o=i.get(s.key.toLowerCase());o&&(s.preventDefault(),e(o))},{signal:t})}a(Op,"listen");var Kb=[[["W","A","S","D"],"walk"],[["\u2191","\u2193"],"walk ahead and back"],[["\u2190","\u2192"],"turn"],[["Page \u2191","Page \u2193"],"look up and down"],[["Shift"],"run"],[["Drag"],"look around"],[["Double click"],"go to a place"]],jb=[[["Drag"],"go around"],[["Shift","Drag"],"move; so does the right button"],[["Wheel"],"nearer and farther"],[["W","S"],"nearer and farther"],[["A","D","\u2190","\u2192"],"go around"],[["Shift","WASD"],"move"]],Qb=[[["Left thumb"],"walk"],[["Right thumb"],"look around"],[["Two taps"],"go to a place"],[["One finger"],"orbit: go around"],[["Two fingers"],"orbit: pinch for the distance, drag to move"]],eS=[[["Left stick"],"walk; press it to run"],[["Right stick"],"look around"]];function Fp(n,e){let t=ve("button",{type:"button",class:"button-icon","aria-label":"Close",title:"Close (Esc)"});t.append(jn(At.close));let i=ve("section",{}),r=ve("dialog",{class:"help","aria-labelledby":"help-title",tabindex:"-1"},ve("header",{},ve("h1",{id:"help-title"},"How to move"),t),ve("div",{class:"help-parts"},Ms("Walk",Kb),Ms("Orbit",jb),i,ve("div",{class:"help-touch"},Ms("Touch",Qb),Ms("Gamepad",eS))));return t.addEventListener("click",()=>r.close()),r.addEventListener("click",s=>{s.target===r&&r.close()}),r.addEventListener("keydown",s=>{s.key==="?"&&(r.close(),s.preventDefault())}),n.append(r),{toggle(){if(r.open){r.close();return}let s=e(),l=Object.keys(zi).filter(c=>!s.includes(c)).map(c=>[[zi[c].label],zi[c].does]);i.replaceChildren(...Ms("Commands",l).childNodes),r.showModal(),r.scrollTop=0},dispose:a(()=>r.remove(),"dispose")}}a(Fp,"createHelp");function Ms(n,e){let t=ve("dl",{});for(let[i,r]of e)t.append(ve("dt",{},...i.map(s=>ve("kbd",{},s))),ve("dd",{},r));return ve("section",{},ve("h2",{},n),t)}a(Ms,"part");function Bp(n,e){let t=URL.createObjectURL(n);ve("a",{href:t,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}a(Bp,"saveFile");async function kp(n){try{return await navigator.clipboard.writeText(n),!0}catch{return tS(n)}}a(kp,"copyText");function tS(n){let e=ve("textarea",{class:"unseen","aria-hidden":"true",tabindex:"-1"});e.value=n;let t=document.activeElement;document.body.append(e),e.select();let i=document.execCommand("copy");return e.remove(),t instanceof HTMLElement&&t.focus({preventScroll:!0}),i}a(tS,"copyMarked");var nS=3,iS="(min-width: 48rem) and (min-height: 34rem)";function zp(n,e,t={}){let i=new AbortController,{keys:r=window,isOpen:s=window.matchMedia(iS).matches}=t,o=!1,l=-1,c=!1,u=null,h="",p=0,d={walk:On("walk","Walk",At.walk),orbit:On("orbit","Orbit",At.orbit),split:On("split","Split",At.split),home:On("home","Home",At.home),next:On("next","Next",At.next),photo:On("photo","Photo",At.photo),link:On("link","Link",At.link),panel:On("panel","Info",At.panel),help:On("help","Help",At.help),headset:On("headset","Enter VR",At.headset)},{headset:f,..._}=d;f.classList.add("tool-main"),f.hidden=!0,d.next.hidden=!e.next;let v=ve("div",{class:"tools",role:"group","aria-label":"Commands"},...Object.values(_));v.classList.toggle("tools-many",e.next!==void 0);let g=Up(),m=ve("p",{class:"quiet",hidden:!0}),S=ve("section",{class:"panel card",id:"panel","aria-label":"Figures"},ve("header",{},ve("h1",{},"nearfar"),N()),g.element,m),A=ve("button",{type:"button",class:"chip card",title:"Show the figures (I)",hidden:!0});A.addEventListener("click",()=>L("panel"));let x=ve("div",{class:"load",role:"progressbar","aria-label":"Loading","aria-valuemin":"0","aria-valuemax":"100"},ve("span",{})),b=ve("p",{class:"note card",hidden:!0}),w=ve("p",{class:"unseen",role:"status"}),y=ve("div",{class:"frame","data-behind":!0},ve("div",{class:"top"},S,A),ve("div",{class:"bottom"},b,f,v));n.append(x,y,w);let T=Fp(n,()=>[...ru(e)?[]:["headset"],...h?[]:["retry"],...e.next?[]:["next"]]);S.hidden=!s;for(let[O,j]of Object.entries(d))j.addEventListener("click",()=>L(O));Op(r,L,i.signal),D({mode:"walk"});function L(O){C(O).catch(j=>B(j instanceof Error?j.message:String(j)))}a(L,"run");async function C(O){if(O==="walk"||O==="orbit")e.setMode(O),D({mode:O}),P(O==="walk"?"Walking":"Orbiting");else if(O==="split"){let j=!o;D({isDivided:j}),e.setDivider(j?$a:null),P(j?"Left conventional, right continuous":"Continuous")}else if(O==="photo")Bp(await e.screenshot(),`nearfar ${new Date().toISOString().slice(0,19).replace(/\D/g,"-")}.png`),B("Picture saved");else if(O==="link"){let j=e.link();await kp(j)?B("Link copied"):(history.replaceState(null,"",j),B("The link stands in the address bar"))}else O==="home"?e.home():O==="next"?e.next?.():O==="look"?e.lookAround():O==="panel"?(S.hidden=!S.hidden,D({})):O==="help"?T.toggle():O==="retry"&&h?(e.retry(),h="",B("Trying again")):O==="headset"&&await ru(e)?.toggle()}a(C,"perform");function D({mode:O,isDivided:j}){O&&(Qa(d.walk,O==="walk"),Qa(d.orbit,O==="orbit")),o=j??o,Qa(d.split,o),Qa(d.panel,!S.hidden),A.hidden=!S.hidden||c||l<0}a(D,"reflect");function N(){let O=ve("button",{type:"button",class:"button-icon","aria-label":"Hide the figures",title:"Hide the figures (I)"},jn(At.close));return O.addEventListener("click",()=>{L("panel"),d.panel.focus({preventScroll:!0})}),O}a(N,"dismiss");function B(O){gi(b,O),P(O),b.hidden=!1,window.clearTimeout(p),p=window.setTimeout(()=>{b.hidden=!0,P("")},1e3*nS)}a(B,"announce");function P(O){gi(w,O)}a(P,"speak");function q(O){let j=iu(O);j&&!c?P("All rings are shown"):O.ring!==l&&P(`Ring ${O.ring} of ${O.rings} is shown`),[l,c]=[O.ring,j];let H=ja(O);H!==null&&H!==u&&Np(O)&&B(`The place is not there yet: ${H}`),u=H;let Q=O.problems.join(`
`);Q!==h&&Ap(O.problems,()=>L("retry")),h=Q}a(q,"tell");function $(){let O=ru(e);f.hidden=!O,rS(f,O?.isPresenting?"Leave VR":"Enter VR"),gi(m,typeof e.headset=="string"?e.headset:""),m.hidden=typeof e.headset!="string"}return a($,"tellHeadset"),{update(O){q(O),g.update(O);let j=O.making?0:1,H=O.expected>0?Math.min(O.received/O.expected,1):j;x.hidden=c,x.dataset.stuck=String(h!==""),x.style.setProperty("--share",H.toFixed(4)),x.setAttribute("aria-valuenow",String(Math.floor(100*H))),gi(A,Dp(O)),$(),D({})},announce:B,reflect:D,dispose(){i.abort(),window.clearTimeout(p),T.dispose();for(let O of[x,y,w])O.remove()}}}a(zp,"createPanel");function On(n,e,t){let{label:i,does:r}=zi[n],s=`${r.charAt(0).toUpperCase()}${r.slice(1)} (${i})`,o=ve("span",{class:"tool-label"},e);return ve("button",{type:"button",class:"tool",title:s,"aria-keyshortcuts":i},jn(t),o)}a(On,"tool");function rS(n,e){let t=n.querySelector(".tool-label");t&&gi(t,e)}a(rS,"label");function ru({headset:n}){return typeof n=="object"?n:null}a(ru,"headsetOf");function Qa(n,e){n.setAttribute("aria-pressed",String(e))}a(Qa,"press");function Gp(n){let e=ve("div",{class:"thumb",hidden:!0,"aria-hidden":"true"},ve("span",{}));return n.append(e),{show(t){if(e.hidden=t===null,!t)return;let{x:i,y:r,right:s,down:o}=t,l=Math.min(1,Ds/Math.max(Math.hypot(s,o),1)),c={"--x":i,"--y":r,"--right":s*l,"--down":o*l};for(let[u,h]of Object.entries(c))e.style.setProperty(u,`${h}px`)},dispose:a(()=>e.remove(),"dispose")}}a(Gp,"createThumbMark");function Vp(n){let e=ve("p",{class:"wait card",role:"status"},"The server loads the scene\u2026");return{begin:a(()=>n.append(e),"begin"),end:a(()=>e.remove(),"end")}}a(Vp,"createWait");var[el,su]=[7.5,9.81],tl=24,yi=.12;function ou({origin:[n,e,t],direction:[i,r,s]}){let o=Wp(e,r);return[n+el*i*o,0,t+el*s*o]}a(ou,"landing");function Hp(n,e){let{origin:t,direction:i}=n,r=Wp(t[1],i[1]),s=ou(n);return Array.from({length:tl},(o,l)=>{let c=l/(tl-1),u=c*r,h=a(p=>t[p]+el*i[p]*u+c*c*(e[p]-s[p]),"at");return[h(0),h(1)-su/2*u*u,h(2)]})}a(Hp,"arc");function Wp(n,e){let t=el*e;return(t+Math.sqrt(t*t+2*su*Math.max(n,0)))/su}a(Wp,"fall");function Xp(){let n=2*yi,e=null;function t(){let i=e;e=null,i?.()}return a(t,"act"),{start(i){e=i,n=Math.min(n,Math.max(2*yi-n,0))},advance(i){let r=n;return n=Math.min(n+i,2*yi),e&&n>=yi&&(r<yi&&(n=yi),t()),1-Math.abs(n-yi)/yi}}}a(Xp,"createJump");var sS=.01;function qp(n,e){let t=new AbortController,i=null,r=null;n.addEventListener("selectstart",({inputSource:o})=>i=o,{signal:t.signal}),n.addEventListener("selectend",({inputSource:o})=>{if(o!==i)return;let l=r?.target;s(),l&&e(l)},{signal:t.signal});function s(){i=null,r=null}return a(s,"drop"),{update(o,l){if(!i)return null;let c=o.find(({source:d})=>d===i)?.ray;if(!c)return r=null,null;let u=ou(c),h=l(u),p=Math.hypot(h[0]-u[0],h[2]-u[2])>sS;return r={arc:Hp(c,h),target:h,isHeld:p},r},dispose:a(()=>t.abort(),"dispose")}}a(qp,"createAiming");var au=1.7,oS=.04;function xi({position:n,yaw:e},[t,i,r]){let[s,o]=[Math.cos(e),Math.sin(e)];return[n[0]+s*t+o*r,n[1]+i,n[2]-o*t+s*r]}a(xi,"worldOf");function Yp({position:n,yaw:e},[t,i,r]){return xi({position:[0,0,0],yaw:-e},[t-n[0],i-n[1],r-n[2]])}a(Yp,"localOf");function nl(n,e){return{position:xi(n,e.position),yaw:Gi(n.yaw+e.yaw),pitch:e.pitch}}a(nl,"inWorld");function lu(n,e,t){let i={position:[0,0,0],yaw:Gi(e-t.yaw)},[r,,s]=xi(i,t.position);return{position:[n[0]-r,n[1],n[2]-s],yaw:i.yaw}}a(lu,"floorUnder");function $p(n,e,t){let{position:i,yaw:r}=nl(n,e);return lu([i[0],n.position[1],i[2]],r+t,e)}a($p,"turned");function cu(n,e,[t,,i]){let[r,,s]=xi(n,e.position),[o,l,c]=n.position;return{...n,position:[o+t-r,l,c+i-s]}}a(cu,"moved");function uu(n,e){let t=e?.shown??[];return[...t,...t].reduce((i,r)=>Ps(i,r),n)}a(uu,"inside");function Jp(n){let e=a(t=>t.map(i=>({...i,metres:Math.max(i.metres-oS,0)})),"inner");return n&&{open:e(n.open),shown:e(n.shown)}}a(Jp,"headBounds");function Zp(n){let e=a(c=>n[c]??0,"at"),[t,i,r]=[-e(8),-e(9),-e(10)],s=Math.hypot(t,r)<aS,[o,l]=s?[-Math.sign(i)*e(4),-Math.sign(i)*e(6)]:[t,r];return{position:[e(12),e(13),e(14)],yaw:Math.atan2(-o,-l),pitch:Math.atan2(i,Math.hypot(t,r))}}a(Zp,"headOf");var aS=.05;var[lS,Kp,cS]=[2,3,3],uS=16;function jp(n,e){let{session:t}=n;return t.visibilityState!=="visible"?[]:[...t.inputSources].filter(({targetRayMode:i})=>i==="tracked-pointer"||i==="transient-pointer").map(i=>{let{targetRaySpace:r,gripSpace:s,hand:o,gamepad:l}=i,c=n.getPose(r,e),u=s&&!o?n.getPose(s,e):void 0;return{source:i,ray:c?hS(c.transform.matrix):null,grip:u?u.transform.matrix:null,stick:l?dS(l):null,joints:o?fS(o,n,e):null}})}a(jp,"readInputs");function hS(n){let e=a(o=>n[o]??0,"at"),[t,i,r]=[-e(8),-e(9),-e(10)],s=Math.hypot(t,i,r)||1;return{origin:[e(12),e(13),e(14)],direction:[t/s,i/s,r/s]}}a(hS,"rayOf");function dS({axes:n,buttons:e,mapping:t}){return t!=="xr-standard"||n.length<=Kp?null:{x:n[lS]??0,y:n[Kp]??0,isPressed:e[cS]?.pressed??!1}}a(dS,"stickOf");function fS(n,e,t){let i=[...n.values()],[r,s]=[new Float32Array(uS*i.length),new Float32Array(i.length)];return e.fillPoses?.(i,t,r)&&e.fillJointRadii?.(i,s)?{matrices:r,radii:s}:null}a(fS,"jointsOf");function Qp(n,e){let{xr:t}=n,[i,r]=[t.getSession(),t.getReferenceSpace()];if(!i?.enabledFeatures?.includes("layers")||!r)return null;let s=t.getBinding();if(typeof s.createCubeLayer!="function")return null;let o=n.getContext(),l=s.createCubeLayer({space:r,layout:"mono",viewPixelWidth:e,viewPixelHeight:e,colorFormat:o.SRGB8_ALPHA8}),c=t.getBaseLayer();i.updateRenderState({layers:[l,c]});let u=pS(o,e),h=null,p=null;function d(_){return h?.cube===_&&h.ring===_.holds&&!l.needsRedraw?!1:(u(wf(n,_),s.getSubImage(l,t.getFrame()).colorTexture),h={cube:_,ring:_.holds},!0)}a(d,"hold");function f(_){return p===_?!1:(p=_,l.orientation=new DOMPointReadOnly(0,Math.sin(-_/2),0,Math.cos(_/2)),!0)}return a(f,"orient"),{show(_,v){return _.size!==e?!1:![d(_),f(v),!i.renderState.layers?.includes(l)].includes(!0)}}}a(Qp,"createMapLayer");function pS(n,e){let[t,i]=[n.createFramebuffer(),n.createFramebuffer()],r=a((s,o,l)=>n.framebufferTexture2D(s,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+o,l,0),"attach");return(s,o)=>{let l=[n.READ_FRAMEBUFFER_BINDING,n.DRAW_FRAMEBUFFER_BINDING].map(c=>n.getParameter(c));n.bindFramebuffer(n.READ_FRAMEBUFFER,t),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,i);for(let c=0;c<Fc;c++)r(n.READ_FRAMEBUFFER,c,s),r(n.DRAW_FRAMEBUFFER,c,o),n.blitFramebuffer(0,0,e,e,0,0,e,e,n.COLOR_BUFFER_BIT,n.NEAREST);n.bindFramebuffer(n.READ_FRAMEBUFFER,l[0]),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,l[1])}}a(pS,"createCopy");var[hu,em]=[2,25],[mS,gS,du]=[.018,.05,.012],_S=[.22,.3],[tm,yS]=[5030655,16758860];function rm(){let n=new Kt,e=new es({color:14015459}),t=new hr({color:tm,depthTest:!1}),i=nm(hu*em,e),r=nm(tl,t),s=new st(new Qr(..._S,48).rotateX(-Math.PI/2),t),o=Array.from({length:hu},()=>{let v=new st(new Zr(mS,2*gS,4,12).rotateX(Math.PI/2),e);return v.matrixAutoUpdate=!1,v}),l=new ns(16777215,6711920,2.5),c=[...o,i,r,s];for(let v of c)v.frustumCulled=!1;n.add(l,...c);let u={free:new ze(tm),held:new ze(yS)},[h,p]=[new Qe,new G];function d(v){let g=v.map(({grip:m})=>m).filter(m=>m!==null);o.forEach((m,S)=>{let A=g[S];m.visible=A!==void 0,A&&m.matrix.fromArray(A)})}a(d,"showControllers");function f(v){let g=0;for(let{joints:m}of v)if(m)for(let S=0;S<m.radii.length&&g<hu*em;S++){h.fromArray(m.matrices,16*S);let A=m.radii[S]??0;i.setMatrixAt(g++,h.scale(p.setScalar(A)))}im(i,g)}a(f,"showJoints");function _(v){v?.arc.forEach(([g,m,S],A)=>{r.setMatrixAt(A,h.makeScale(du,du,du).setPosition(g,m,S))}),im(r,v?.arc.length??0),s.visible=v!==null,v&&(s.position.set(...v.target),t.color.copy(v.isHeld?u.held:u.free))}return a(_,"showAim"),{group:n,update(v,g){d(v),f(v),_(g)},dispose(){for(let v of c)v.geometry.dispose();for(let v of[i,r])v.dispose();for(let v of[e,t])v.dispose();n.removeFromParent()}}}a(rm,"createLook");function nm(n,e){return new $r(new Kr(1,2),e,n)}a(nm,"beads");function im(n,e){n.count=e,n.visible=e>0,n.instanceMatrix.needsUpdate=!0}a(im,"show");var xS=Math.PI/6,vS=.18,[bS,SS]=[.7,.35];function sm(){let n=!0;function e(t){return Math.abs(t)<SS&&(n=!0),!n||Math.abs(t)<bS?0:(n=!1,-Math.sign(t)*xS)}return a(e,"snap"),{read(t,i){let r=t??i,s=i??t,o=e(s?.x??0);if(!r)return{drive:wn,turn:o};let[l,c]=Mi(r===s?0:r.x,r.y,vS);return{drive:{...wn,right:l,ahead:0-c,isHasty:r.isPressed},turn:o}}}}a(sm,"createSteering");var MS=a(()=>!1,"glides");function am(n,e,t){let{renderer:i,rig:r}=n,s=null,o=null;i.xr.enabled=!0;async function l(){let p=await e.requestSession("immersive-vr",{requiredFeatures:["local-floor"],optionalFeatures:["hand-tracking","layers"]});p.addEventListener("end",u);try{await i.xr.setSession(p)}catch(f){throw await p.end(),f}let d=c(p);o=d,r.add(d.look.group),i.xr.getReferenceSpace()?.addEventListener("reset",()=>d.isMoved=!0),t.isStatic&&n.setMapLayer(Qp(i,n.faceSize))}a(l,"enter");function c(p){let d=t.pose(),f={look:rm(),aiming:qp(p,_=>{let{floor:v,jump:g}=f,m=v&&xi(v,_);g.start(()=>f.goal=m)}),steering:sm(),jump:Xp(),walk:Us(d,()=>s,MS),floor:null,pose:d,goal:null,isMoved:!1};return f}a(c,"begin");function u(){if(!o)return;let{look:p,aiming:d,floor:f,pose:_}=o;o=null,p.dispose(),d.dispose(),n.setMapLayer(null),n.setVeil(0);let[v,g,m]=_.position;t.left({position:[v,f?f.position[1]+au:g,m],yaw:_.yaw,pitch:0})}a(u,"leave");function h(p,d,f,_){let{position:[v,g,m],yaw:S}=p.pose,A=[v,p.floor?.position[1]??g-au,m],x=p.floor&&!p.isMoved?p.floor:lu(A,S,d);p.isMoved=!1;let{drive:b,turn:w}=p.steering.read(om(f,"left"),om(f,"right"));return w!==0&&(x=$p(x,d,w)),p.walk.follow(nl(x,d)),p.walk.update(_,b),x=cu(x,d,p.goal??p.walk.pose.position),p.goal=null,cu(x,d,uu(xi(x,d.position),s))}return a(h,"floorOf"),{get isPresenting(){return o!==null},toggle(){let p=i.xr.getSession();return p?p.end():l()},place(p){o&&Object.assign(o,{floor:null,pose:p})},update(p){let[d,f]=[i.xr.getFrame(),i.xr.getReferenceSpace()];if(!o||!d||!f)return null;let _=d.getViewerPose(f);if(!_)return o.pose;s=Jp(t.bounds());let v=Zp(_.transform.matrix),g=jp(d,f);n.setVeil(o.jump.advance(p));let m=h(o,v,g,p);o.floor=m,o.pose=nl(m,v),n.stand(m);let S=a(A=>Yp(m,uu(xi(m,A),s)),"allowed");return o.look.update(g,o.aiming.update(g,S)),o.pose}}}a(am,"createHeadset");function om(n,e){return n.find(({source:t})=>t.handedness===e)?.stick??null}a(om,"stickOf");async function lm(n,e){if(!e)return"A headset can be entered where the page comes over https.";if(!n)return"This browser knows no headsets.";try{return await n.isSessionSupported("immersive-vr")?null:"No headset is connected."}catch{return"Headsets cannot be used from here."}}a(lm,"whyNoHeadset");function cm(n,e,t){let{xr:i}=navigator,r=null;async function s(){let o=await lm(i,window.isSecureContext);if(o!==null||!i){t(o??"");return}r??=am(n,i,e),t(r)}a(s,"seek"),s(),i?.addEventListener("devicechange",()=>{s()})}a(cm,"offerHeadset");var um=75,hm=.1,dm=.25,fm="The browser has taken the graphics away. The picture comes back as soon as they do.";async function wS(){let n=new URLSearchParams(location.search),[e,t]=[pm("canvas",HTMLCanvasElement),pm("#ui",HTMLElement)],i=Eh(),r=new URL(n.get("bundle")??".",location.href),s=Ah(n.get("strategy")),o=Vp(t),l=await wh(r,n,s,i.receive,o.begin).finally(o.end);i.restart();let{centers:c,files:u,world:h}=l;l.title!==null&&(document.title=`${l.title} \u2013 nearfar`);let p=null,d=[],[f,_]=[null,null],v=a(N=>{f=N,m.go(N)},"go"),g=a(()=>{if(d.includes(fm)){history.replaceState(null,"",pl(w)),location.reload();return}d=[],Ja(),m.retry(),_&&v(_),_=null},"retry"),m=vp(e,{world:h,fetch:u.fetch,worker:new URL("worker.js",import.meta.url),angle:um,antialias:n.get("aa")!=="0",isSmooth:s.isSmooth,isWhole:s.isWhole,failed(N){d=[N.message],m.facts.goal===null&&([f,_]=[null,f]);let B=wu(N);B!==null&&u.distrust(B),m.facts.arrived<0&&mm(N)},lost(N){d=N?[fm]:[],N&&p?.isPresenting&&p.toggle()},moved(N){_&&(d=[]),f=_=null,b.setPose(N),p?.place(N)}}),S=a(N=>({...w,position:h.places.of(N).center}),"homeOf"),A=fl(location.hash)??l.start,x=Gp(t),b=Wu(e,{start:A,onThumb:x.show,onGo(N,B){let P=qu(w,[N,B],Math.tan(um*Math.PI/360),m.camera.aspect);v({...w,position:Yu(w.position,P,m.pointAt(N,B))})}}),w=b.update(0);window.nearfar={viewer:m,setPose:b.setPose,get pose(){return w}},window.addEventListener("hashchange",()=>v(fl(location.hash)??w));let T={setDivider:wp(t,N=>{m.setDivider(N),L.reflect({isDivided:N!==null})}).set,setMode:b.setMode,home:a(()=>v(S(m.facts.region)),"home"),lookAround:b.lookAround,screenshot:m.photo,link:a(()=>new URL(pl(w),location.href).href,"link"),retry:g};c&&c.length>1&&(T.next=()=>{let N=(h.places.nearest(w.position)+1)%c.length;v(S(N)),L.announce(`Place ${N+1} of ${c.length}`)});let L=zp(t,T);cm(m,{pose:a(()=>w,"pose"),bounds:a(()=>m.facts.bounds,"bounds"),left:b.setPose,isStatic:l.isStatic},N=>{p=typeof N=="string"?null:N,T.headset=N}),m.open(h.places.nearest(A.position));let C=performance.now(),D=dm;m.renderer.setAnimationLoop(N=>{let B=Math.max(N-C,0)/1e3;if(C=N,w=p?.update(Math.min(B,hm))??b.update(B),m.frame(w,Math.min(B,hm)),b.setBounds(m.facts.bounds),i.frame(B),D+=B,D<dm)return;D=0;let{shown:P,triangles:q,region:$,entry:O,goal:j,received:H,expected:Q}=m.facts,{center:te,fold_margin:ne}=h.places.of($),he=ES(O);L.update({ring:Math.min(P?.ring??0,he),rings:he,isSharp:O!==null&&(!O.isCoarse||(P?.ring??0)>he),making:l.makingOf(j??$),radius:P?.grown.radius??0,...i.read(),received:H,expected:Q,triangles:q.own,drawn:q.drawn,sceneTriangles:l.triangles,region:$,regions:c?.length??null,away:Mt(w.position,{center:te,metres:ne}),foldMargin:ne,problems:d})})}a(wS,"main");function ES(n){return(n?.rings.length??1)-1-(n?.isCoarse?1:0)}a(ES,"ringsOf");function pm(n,e){let t=document.querySelector(n);if(!(t instanceof e))throw new Error(`the page has no ${n}`);return t}a(pm,"element");function mm(n){let e=n instanceof Error?n.message:String(n),{title:t,text:i}=Ep[n instanceof Ce?n.kind:"other"];Tp(t,i,{detail:e,retry:a(()=>location.reload(),"retry")})}a(mm,"tell");wS().catch(mm);
