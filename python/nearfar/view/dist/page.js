var cp=Object.defineProperty;var a=(i,e)=>cp(i,"name",{value:e,configurable:!0});var Ye=class extends Error{constructor(t,n="damaged"){super(t);this.kind=n}kind;static{a(this,"BundleError")}name="BundleError"};function $c({message:i}){return/^(files\/[\w.]+):/.exec(i)?.[1]??null}a($c,"damagedFile");function Qn(i,e,t){let n=JSON.stringify(t)??"nothing";return new Ye(`manifest.json: ${i}: expected ${e}, got ${n.slice(0,60)}`)}a(Qn,"wrong");function Wt(i,e){if(typeof e!="object"||e===null||Array.isArray(e))throw Qn(i,"an object",e);return e}a(Wt,"object");function dn(i,e,t,n=Number.MAX_VALUE){if(!(typeof e=="number"&&e>=t&&e<=n))throw Qn(i,`a number of at least ${t}`,e);return e}a(dn,"number");function sn(i,e,t,n=Number.MAX_SAFE_INTEGER){let r=dn(i,e,t,n);if(!Number.isSafeInteger(r))throw Qn(i,"a whole number",e);return r}a(sn,"integer");function _r(i,e){if(typeof e!="string")throw Qn(i,"text",e);return e}a(_r,"text");function Ba(i,e,t){let n=t.find(r=>r===e);if(n===void 0)throw Qn(i,t.join(" or "),e);return n}a(Ba,"choice");function Pt(i,e,t,n){if(!Array.isArray(e)||n!==void 0&&e.length!==n)throw Qn(i,n===void 0?"a list":`a list of ${n}`,e);return e.map((r,s)=>t(`${i}[${s}]`,r,s))}a(Pt,"list");function Si(i,e,t){return e==null?null:t(i,e)}a(Si,"optional");function Jc(i,e){let t=_r(i,e);if(!/^[0-9a-f]{64}$/.test(t))throw Qn(i,"a SHA-256",e);return t}a(Jc,"hash");function On(i,e){let t=_r(i,e);if(!/^files\/[0-9a-f]{16}\.[a-z]+$/.test(t))throw Qn(i,"the name of a file of the bundle",e);return t}a(On,"fileName");function xr({geometry:i,parts:e}){return i===null?[]:[i,...e]}a(xr,"filesOfGeometry");function ka(i){return i?[i.color,i.range].flat().filter(e=>e!==null):[]}a(ka,"filesOfMap");function yr(i){return[...xr(i),...ka(i.map)]}a(yr,"filesOfRing");function za({dynamic:i},{rings:e},t){let n=i?xr(i):[];return new Set([...n,...e.slice(0,t+1).flatMap(yr)])}a(za,"filesOfRegion");function Zc({files:i},e){let t=0;for(let n of e)t+=i[n]?.bytes??0;return t}a(Zc,"bytesOf");var Kc="nearfar.bundle",jc=1,up=4096,hp=16383,[Ga,Qc,dp]=[6,1e3,1e3],fp=2**31-1,[pp,mp]=[65534,600],vr=1e12;function eu(i){let e;try{e=JSON.parse(i)}catch{throw new Ye("manifest.json: expected JSON, got something else")}let t=Wt("manifest",e);if(t.format!==Kc)throw new Ye(`manifest.json: expected the format ${Kc}, got another one`);let n=sn("version",t.version,1);if(n>jc){let f=`it has version ${n}, this page reads ${jc}`;throw new Ye(`this bundle was written by a newer nearfar (${f}): update the page`,"newer")}let[r,s,o]=["morph","growth","map"].map(f=>Wt(f,t[f])),l=sn("map.face_size",o?.face_size,1,up),c=sn("map.tile",o?.tile,1,l);if(l%c!==0)throw new Ye(`manifest.json: map.tile: expected a divisor of ${l}, got ${c}`);let u=Ba("morph.kind",r?.kind,["blend","cylinder"]),d=Ba("unit",t.unit??"object",["object","triangle"]),p=sn("map.across",o?.across,1,Math.floor(hp/c)),h=Ga*(l/c)**2,g=Wt("files",t.files),_=Pt("regions",t.regions,Wt);if(_.length===0||_.length>Qc)throw new Ye(`manifest.json: regions: expected 1 to ${Qc}, got ${_.length}`);let y={version:n,morph:{kind:u,near_share:dn("morph.near_share",r?.near_share,0,1-1e-9)},growth:{speed:dn("growth.speed",s?.speed,1e-9),reach:dn("growth.reach",s?.reach,1e-9),fade:dn("growth.fade",s?.fade,0)},triangles:sn("triangles",t.triangles,0),bounds:Pt("bounds",t.bounds,tu,2),map:{face_size:l,tile:c,across:p},regions:_.map((f,m)=>{let S=`regions[${m}]`;return yp(d,S,xp(S,f,h,m,_.length))}),dynamic:Si("dynamic",t.dynamic,bp),notes:Pt("notes",t.notes,_r),files:Object.fromEntries(Object.entries(g).map(([f,m])=>[On("files",f),gp(f,m)]))};return _p(y),y}a(eu,"parseManifest");function gp(i,e){let t=Wt(i,e);return{bytes:sn(`${i}.bytes`,t.bytes,0,fp),sha256:Jc(`${i}.sha256`,t.sha256)}}a(gp,"described");function _p({regions:i,dynamic:e,files:t}){let n=[...i.flatMap(({rings:r})=>r.flatMap(yr)),...i.flatMap(({by_footprint:r})=>r?[...r.portions.flatMap(xr),...ka(r.map)]:[]),...e?xr(e):[]];for(let r of n)if(!Object.hasOwn(t,r))throw new Ye(`manifest.json: files: expected ${r}, which is used, among them`)}a(_p,"checkListed");function tu(i,e){return Pt(i,e,(t,n)=>dn(t,n,-vr,vr),3)}a(tu,"point");function xp(i,e,t,n,r){let s=Wt(`${i}.range`,e.range),o=Pt(`${i}.rings`,e.rings,(g,_,y)=>vp(g,_,y,t)),l=o.map(({radius:g})=>g),c=l[0]===0&&l.every((g,_)=>_===0||g>(l[_-1]??0));if(o.length<2||o.length>dp||!c)throw new Ye(`manifest.json: ${i}.rings: expected radii that ascend from 0`);let u=a((g,_)=>sn(g,_,0,r-1),"other"),d=Pt(`${i}.neighbours`,e.neighbours,u);if(d.includes(n))throw new Ye(`manifest.json: ${i}.neighbours: expected other regions`);let[p,h]=["least","step"].map(g=>dn(`${i}.range.${g}`,s[g],Number.MIN_VALUE));if(!(Math.abs(Math.log(p))+pp*h<=mp))throw new Ye(`manifest.json: ${i}.range: expected ranges that are finite`);return{center:tu(`${i}.center`,e.center),fold_margin:dn(`${i}.fold_margin`,e.fold_margin,0),neighbours:d,range:{least:p,step:h},rings:o,cut:1/0,by_footprint:Si(`${i}.by_footprint`,e.by_footprint,Sp)}}a(xp,"region");function yp(i,e,t){if(i==="object")return t;if(t.rings.length!==2)throw new Ye(`manifest.json: ${e}.rings: expected two with unit triangle`);return{...t,cut:t.rings[1]?.radius??1/0}}a(yp,"cutBy");function vp(i,e,t,n){let r=Wt(i,e);return{...nu(i,r),radius:dn(`${i}.radius`,r.radius,0,vr),map:Mp(`${i}.map`,r.map,t,n)}}a(vp,"ring");function nu(i,e){let t=Wt(i,e);return{objects:sn(`${i}.objects`,t.objects,0),triangles:sn(`${i}.triangles`,t.triangles,0),geometry:Si(`${i}.geometry`,t.geometry,On),parts:Pt(`${i}.parts`,t.parts,On)}}a(nu,"group");function Sp(i,e){let t=Wt(i,e),n=Wt(`${i}.map`,t.map),r=a(s=>Pt(`${i}.map.${s}`,n[s],On,Ga),"faces");return{portions:Pt(`${i}.portions`,t.portions,nu),map:{tiles:[],color:r("color"),range:r("range")}}}a(Sp,"footprints");function Mp(i,e,t,n){let r=Wt(i,e),s=a((u,d)=>Array.isArray(d)?Pt(u,d,On,Ga):On(u,d),"names"),o={tiles:Pt(`${i}.tiles`,r.tiles??[],(u,d)=>sn(u,d,0,n-1)),color:Si(`${i}.color`,r.color,s),range:Si(`${i}.range`,r.range,s)},l=a(u=>new Ye(`manifest.json: ${i}: expected ${u}`),"wrong");if(t===0){if(!Array.isArray(o.color))throw l("six pictures for ring 0");return o}if(o.tiles.some((u,d)=>d>0&&u<=(o.tiles[d-1]??0)))throw l("numbers of tiles that ascend");let c=o.tiles.length>0;if(c!==(typeof o.color=="string"))throw l("a picture exactly where tiles change");if(t===1&&!Array.isArray(o.range))throw l("six files of ranges for ring 1");if(t>1&&c!==(typeof o.range=="string"))throw l("ranges exactly where tiles change");return o}a(Mp,"mapOf");function bp(i,e){let t=Wt(i,e);return{geometry:On(`${i}.geometry`,t.geometry),parts:Pt(`${i}.parts`,t.parts,On),triangles:sn(`${i}.triangles`,t.triangles,0),instances:Pt(`${i}.instances`,t.instances,wp)}}a(bp,"moving");function wp(i,e){let t=Wt(i,e),n=a((r,s)=>Pt(r,s,(o,l)=>dn(o,l,-vr,vr),4),"row");return{object:_r(`${i}.object`,t.object),transform:Si(`${i}.transform`,t.transform,(r,s)=>Pt(r,s,n,4))}}a(wp,"movingEntry");function iu(i){let e=new Map;function t(n){let r=new AbortController,s=new Set,o={askers:s,stop:r,size:0,result:Promise.resolve().then(()=>i(n,r.signal,c=>{o.size+=c;for(let u of s)u(c)}))};e.set(n,o);let l=a(()=>{e.get(n)===o&&e.delete(n)},"forget");return o.result.then(l,l),o}return a(t,"begin"),async(n,r,s)=>{r.throwIfAborted();let o=e.get(n)??t(n),l=o.askers.size===0,c=a(d=>s(d),"own");o.askers.add(c),o.size>0&&c(o.size);let u=a(()=>{o.askers.delete(c),!(o.askers.size>0)&&(e.get(n)===o&&e.delete(n),o.stop.abort(r.reason))},"leave");return new Promise((d,p)=>{let h=a(()=>{u(),p(r.reason)},"stopped");r.addEventListener("abort",h,{once:!0});let g=a(_=>d(l?_:_.slice(0)),"copied");o.result.then(g,p).finally(()=>r.removeEventListener("abort",h))})}}a(iu,"createShared");function ru(i){let e=i,t=new Set;function n(r){return new Promise((s,o)=>{let l=a(()=>{t.delete(c),o(r.reason)},"leave"),c=a(()=>{r.removeEventListener("abort",l),s()},"enter");t.add(c),r.addEventListener("abort",l,{once:!0})})}return a(n,"place"),async(r,s)=>{r.throwIfAborted(),e===0?await n(r):e-=1;try{return await s()}finally{let[o]=t;o?(t.delete(o),o()):e+=1}}}a(ru,"createSlots");var su=10,Ep=new Set([408,425,429]),ou={fetch:a((i,e,t)=>fetch(i,{signal:e,credentials:"same-origin",cache:t?"reload":"default"}),"fetch"),wait:a((i,e)=>new Promise((t,n)=>{e.throwIfAborted();let r=a(()=>{clearTimeout(s),n(e.reason)},"stop"),s=setTimeout(()=>{e.removeEventListener("abort",r),t()},1e3*i);e.addEventListener("abort",r,{once:!0})}),"wait")};async function au(i,e,t,n,r,s){let o=new AbortController,l=AbortSignal.any([n,o.signal]),c=!0;a(async()=>{for(;c;)c=!1,await s.wait(su,l);o.abort(new Error(`the server sends nothing for ${su} s`))},"watch")().catch(()=>{});let d=0;try{let p=await s.fetch(i,l,r);Tp(e.name,p);let h=[];for(let g=p.body?.getReader();g;){let{done:_,value:y}=await g.read();if(_)break;if(c=!0,h.push(y),d+=y.length,t(y.length),d>e.most)throw Ap(e,"more")}if(e.bytes!==null&&d<e.bytes)throw new Error(`expected ${e.bytes} bytes, got ${d}`);return await new Blob(h).arrayBuffer()}catch(p){throw t(-d),p}finally{o.abort(new Error("over"))}}a(au,"transfer");function Tp(i,{ok:e,status:t,statusText:n}){if(e)return;let r=`the server answers ${t} ${n}`.trim();throw t>=500||Ep.has(t)?new Error(r):new Ye(`${i}: ${r}`,"network")}a(Tp,"refuse");function Ap({name:i,bytes:e,most:t},n){let r=e===null?`at most ${t} bytes`:`${e} bytes, as the manifest lists it`;return new Ye(`${i}: expected ${r}, got ${n}`)}a(Ap,"wrongSize");var Rp=[.5,1,2,4],Cp=6,Pp=64*2**20;async function lu(i,e,t,n=ou){let r=new Set,s=a((d,p,h,g,_)=>{let y={name:d,bytes:p,most:h};return Ip(d,g,n,f=>{let m=r.delete(d)||f;return au(new URL(d,i),y,_,g,m,n)})},"load"),o=await s("manifest.json",null,Pp,t,e),l=eu(new TextDecoder().decode(o)),c=ru(Cp),u=iu((d,p,h)=>{let g=l.files[d]?.bytes;if(g===void 0)throw new Ye(`${d}: the manifest does not list this file`);return c(p,()=>s(d,g,g,p,_=>{e(_),h(_)}))});return{manifest:l,fetch:a((d,p,h=()=>{})=>u(d,p,h),"fetch"),distrust:a(d=>r.add(d),"distrust")}}a(lu,"openSource");async function Ip(i,e,t,n){for(let r=0;;r++){e.throwIfAborted();try{return await n(r>0)}catch(s){if(e.aborted||s instanceof Ye)throw s;let o=Rp[r],l=s instanceof Error?s.message:String(s);if(o===void 0)throw new Ye(`${i} does not come: ${l}`,"network");await t.wait(o,e)}}}a(Ip,"withTrials");var wn={right:0,ahead:0,turn:0,look:0,isHasty:!1};function ys(...i){let e=a(o=>i.reduce((l,c)=>l+o(c),0),"sum"),[t,n]=xs(e(o=>o.right),e(o=>o.ahead)),[r,s]=xs(e(o=>o.turn),e(o=>o.look));return{right:t,ahead:n,turn:r,look:s,isHasty:i.some(o=>o.isHasty)}}a(ys,"together");function xs(i,e){let t=Math.max(Math.hypot(i,e),1);return[i/t,e/t]}a(xs,"within");function Mi(i,e,t){let n=Math.hypot(i,e);if(!(n>t))return[0,0];let r=Math.min((n-t)/(1-t),1)/n;return[i*r,e*r]}a(Mi,"beyondRest");var cu=.18,Lp=[4,10];function uu(i){let e=i.filter(t=>t!==null&&t.connected&&t.mapping==="standard");return e.length===0?wn:ys(...e.map(t=>t?Np(t):wn))}a(uu,"readPads");function Np({axes:i,buttons:e}){let[t,n]=Mi(i[0]??0,i[1]??0,cu),[r,s]=Mi(i[2]??0,i[3]??0,cu),o=Lp.some(l=>e[l]?.pressed??!1);return{right:t,ahead:0-n,turn:0-r,look:0-s,isHasty:o}}a(Np,"wishOf");var hu={KeyW:[0,1,0,0],KeyS:[0,-1,0,0],KeyA:[-1,0,0,0],KeyD:[1,0,0,0],ArrowUp:[0,1,0,0],ArrowDown:[0,-1,0,0],ArrowLeft:[0,0,1,0],ArrowRight:[0,0,-1,0],PageUp:[0,0,0,1],PageDown:[0,0,0,-1]};function Va(i){return Object.hasOwn(hu,i)}a(Va,"isMoving");function Ha(i){if(i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey)return!0;let{target:e}=i;return typeof Element<"u"&&e instanceof Element&&e.closest(Dp)!==null}a(Ha,"isElsewhere");var Dp="input, textarea, select, [contenteditable], dialog";function du(i){let e=new Set,t=new AbortController,n=a((s,o)=>i.addEventListener(s,o,{signal:t.signal}),"listen"),r=!1;return n("keydown",s=>{let o=s;r=o.shiftKey,!(!Va(o.code)||Ha(o))&&(e.add(o.code),o.preventDefault())}),n("keyup",s=>{r=s.shiftKey,e.delete(s.code),s.key==="Meta"&&e.clear()}),n("blur",()=>{e.clear(),r=!1}),{get drive(){let s=[0,0,0,0];for(let h of e)hu[h]?.forEach((g,_)=>s[_]=(s[_]??0)+g);let[o=0,l=0,c=0,u=0]=s,[d,p]=xs(o,l);return{right:d,ahead:p,turn:Math.sign(c),look:Math.sign(u),isHasty:r}},dispose:a(()=>t.abort(),"dispose")}}a(du,"createKeys");function vs(i,e,t){let n=t&&Xa(e,t.open),r=n?pu(i,e,n):e;for(let s of t?.shown??[]){let o=Math.max(Bt(i,s),s.metres),l=Bt(r,s);l>o&&(r=bs(r,o,l,s))}return r}a(vs,"confine");function Wa(i,e,t){let n=t&&Xa(e,t.open),r=n?fu(i,e,Bt(pu(i,e,n),n),n):1,s=(t?.shown??[]).map(o=>fu(i,e,o.metres,o));return Math.min(r,...s)}a(Wa,"allowedShare");function Ss(i,e,t){let n=e&&Xa(i,e.open),r=i;for(let s of new Set([...n?[n]:[],...e?.shown??[]])){let o=Bt(r,s);o<=s.metres||(r=bs(r,s.metres+(o-s.metres)*Math.exp(-3*t),o,s))}return r}a(Ss,"settle");function Bt([i,,e],{center:t}){return Math.hypot(i-t[0],e-t[2])}a(Bt,"distance");function Ms(i,e){let t=Bt(i,e);return t<=e.metres?i:bs(i,e.metres,t,e)}a(Ms,"within");function Xa(i,e){let t=a(n=>n.metres-Bt(i,n),"room");return e.reduce((n,r)=>n&&t(n)>=t(r)?n:r,null)}a(Xa,"roomiest");function pu(i,e,t){let[n,r]=[Bt(i,t),Bt(e,t)],s=.8*t.metres,o=Math.max(n,s);if(r<=o)return e;let l=t.metres-s,c=o>=t.metres?o:t.metres-(t.metres-o)*Math.exp((o-r)/l);return bs(e,c,r,t)}a(pu,"slowed");function fu(i,e,t,n){let[r,s]=[Bt(i,n),Bt(e,n)];return s<=r||s<=t?1:Math.max(t-r,0)/(s-r)}a(fu,"shareOf");function bs([i,e,t],n,r,{center:s}){let o=n/r;return[s[0]+o*(i-s[0]),e,s[2]+o*(t-s[2])]}a(bs,"atDistance");function En(i,e,t){return Math.min(Math.max(i,e),t)}a(En,"bounded");function Fi(i){return i-2*Math.PI*Math.round(i/(2*Math.PI))}a(Fi,"wrapped");function bi({yaw:i,pitch:e}){return[-Math.sin(i)*Math.cos(e),Math.sin(e),-Math.cos(i)*Math.cos(e)]}a(bi,"ahead");function Oi(i){return[Math.cos(i),0,-Math.sin(i)]}a(Oi,"rightOf");function ws({yaw:i,pitch:e}){return[Math.sin(i)*Math.sin(e),Math.cos(e),Math.cos(i)*Math.sin(e)]}a(ws,"upOf");function qt(i,e,t){return[i[0]+t*e[0],i[1]+t*e[1],i[2]+t*e[2]]}a(qt,"moved");function mu(i,e){return i.yaw===e.yaw&&i.pitch===e.pitch&&i.position.every((t,n)=>t===e.position[n])}a(mu,"isSamePose");var[gu,_u,xu]=[.3,2e3,4],[yu,Up,vu]=[1.4,1.2,.8];function Su(i,e){let t=i,n=xu,r=a(()=>qt(t.position,bi(t),n),"target");function s(u,d){let[p,h,g]=qt(d,u,-1),_=Math.hypot(p,g);n=En(Math.hypot(_,h),gu,_u);let y=_>1e-9?Fp(Math.atan2(-p,-g),t.yaw):t.yaw;t={position:u,yaw:y,pitch:En(Math.atan2(h,_),-1.5,1.5)}}a(s,"put");function o(u,d){if(u===0&&d===0)return;let p=r(),h={yaw:t.yaw+u,pitch:En(t.pitch+d,-1.5,1.5)},g=qt(p,bi(h),-n),_=vs(t.position,g,e());_===g?t={...h,position:g}:s(_,p)}a(o,"rotate");function l(u){if(!(u>0)||u===1)return;let d=En(n*u,gu,_u),p=qt(r(),bi(t),-d),h=Wa(t.position,p,e()),g=qt(t.position,bi(t),h*(n-d));n+=h*(d-n),t={...t,position:g}}a(l,"zoom");function c(u,d){let p=qt(qt([0,0,0],Oi(t.yaw),u*n),ws(t),d*n),h=Wa(t.position,qt(t.position,p,1),e());t={...t,position:qt(t.position,p,h)}}return a(c,"pan"),{get pose(){return t},update(u,{right:d,ahead:p,turn:h,look:g,isHasty:_}){_?c(vu*u*d,vu*u*p):l(Math.exp(-Up*u*p));let y=_?h:h-d;o(yu*u*y,yu*u*g),t={...t,position:Ss(t.position,e(),u)}},rotate:o,zoom:l,pan:c,setPose(u){t=u,n=xu}}}a(Su,"createOrbit");function Fp(i,e){return i+2*Math.PI*Math.round((e-i)/(2*Math.PI))}a(Fp,"nearest");var[Op,Bp,kp]=[300,400,16];function Mu(i){let e=new Map,t=null,n=a((r,s)=>Math.hypot(r.clientX-s.clientX,r.clientY-s.clientY)<=kp,"isNear");return{down(r){e.size>0&&(t=null),e.set(r.pointerId,r)},up(r){let s=e.get(r.pointerId),o=e.size===1;if(e.delete(r.pointerId),!(s&&o&&r.timeStamp-s.timeStamp<=Op&&n(s,r))){t=null;return}let c=t!==null&&r.timeStamp-t.timeStamp<=Bp&&n(t,r);t=c?null:r,c&&i(r)}}}a(Mu,"createTaps");var[Es,bu]=[1.6,Math.PI],qa=1.5,zp=.0015,Gp=[1,16,400],Ts=56,Vp=.12;function wu(i,e){let t=new Map,n=new AbortController,r=wn,s=Mu(u),o=!1,l=a(()=>1/Math.max(i.clientHeight,1),"scale"),c=a(()=>i.ownerDocument.pointerLockElement===i,"isLocked");function u({clientX:M,clientY:T}){let{left:x,top:w,width:P,height:C}=i.getBoundingClientRect();c()?e.go(.5,.5):e.go((M-x)/Math.max(P,1),(T-w)/Math.max(C,1))}a(u,"go");function d(M){o=M.pointerType==="touch";let T=M.pointerType==="mouse",x=M.button===0&&!M.shiftKey;if(e.mode()==="walk"&&T&&!x)return;i.setPointerCapture(M.pointerId),o&&s.down(M);let w=p(M)?"step":x?"turn":"pan";t.set(M.pointerId,{x:M.clientX,y:M.clientY,task:w}),w==="step"&&g({x:M.clientX,y:M.clientY},M)}a(d,"down");function p({pointerType:M,clientX:T}){if(e.mode()!=="walk"||M!=="touch"||[...t.values()].some(({task:P})=>P==="step"))return!1;let{left:x,width:w}=i.getBoundingClientRect();return T-x<w/2}a(p,"isThumb");function h(M){let T=t.get(M.pointerId);if(!T){c()&&e.look(-M.movementX*Es*l(),-M.movementY*Es*l());return}if(T.task==="step"){g(T,M);return}let x={...T,x:M.clientX,y:M.clientY},w=[...t].find(([D,{task:B}])=>D!==M.pointerId&&B!=="step")?.[1],[P,C]=[(x.x-T.x)*l(),(x.y-T.y)*l()];t.set(M.pointerId,x),e.mode()==="walk"?e.look(P*Es,C*Es):w?_(T,x,w):T.task==="pan"?e.pan(-P*qa,C*qa):e.rotate(-P*bu,-C*bu)}a(h,"move");function g({x:M,y:T},{clientX:x,clientY:w}){let[P,C]=Mi((x-M)/Ts,(w-T)/Ts,Vp);r={...wn,right:P,ahead:0-C},e.thumb({x:M,y:T,right:x-M,down:w-T})}a(g,"step");function _(M,T,x){let[w,P]=[M,T].map(({x:D,y:B})=>Math.hypot(D-x.x,B-x.y));w&&P&&e.zoom(w/P);let C=.5*qa*l();e.pan(-(T.x-M.x)*C,(T.y-M.y)*C)}a(_,"pinch");function y(M){M.pointerType==="touch"&&s.up(M),t.get(M.pointerId)?.task==="step"&&f(),t.delete(M.pointerId)}a(y,"up");function f(){r=wn,e.thumb(null)}a(f,"rest");function m(M){e.mode()==="orbit"&&(M.preventDefault(),e.zoom(Math.exp(zp*M.deltaY*(Gp[M.deltaMode]??1)*(M.ctrlKey?6:1))))}a(m,"wheel");function S(){e.mode()==="walk"&&Promise.resolve(i.requestPointerLock()).catch(()=>{})}a(S,"lock");let{signal:A}=n;i.addEventListener("pointerdown",d,{signal:A}),i.addEventListener("pointermove",h,{signal:A}),i.addEventListener("pointerup",y,{signal:A}),i.addEventListener("pointercancel",y,{signal:A}),i.addEventListener("dblclick",M=>o||u(M),{signal:A}),i.addEventListener("wheel",m,{signal:A,passive:!1}),i.addEventListener("contextmenu",M=>M.preventDefault(),{signal:A});function v(){t.clear(),f(),c()&&i.ownerDocument.exitPointerLock()}return a(v,"release"),{get drive(){return r},lock:S,release:v,dispose(){v(),n.abort()}}}a(wu,"createPointers");var[Hp,Wp]=[1.6,3],Eu=1.4,[Tu,Xp]=[.09,.25],qp=1/120;function As(i,e,t){let{position:n,yaw:r,pitch:s}=i,o=n[1],l=[0,0];function c(d,p){let h=Eu*p.turn*d,g=r+h/2;r+=h,s=En(s+Eu*p.look*d,-1.5,1.5);let _=Hp*(p.isHasty?Wp:1),[y,f]=Au(l[0],_*p.right,d,t()),[m,S]=Au(l[1],_*p.ahead,d,t());l=[f,S];let[A,,v]=Oi(g),M=t()?0:(n[1]-o)*Math.exp(-d/Xp),T=[n[0]+A*y+v*m,o+M,n[2]+v*y-A*m];n=Ss(vs(n,T,e()),e(),d)}a(c,"step");function u(d){({position:n,yaw:r,pitch:s}=d),o=n[1]}return a(u,"follow"),{get pose(){return{position:n,yaw:r,pitch:s}},update(d,p){let h=Math.ceil(d/qp);for(let g=0;g<h;g++)c(d/h,p)},look(d,p){r+=d,s=En(s+p,-1.5,1.5)},setPose(d){u(d),l=[0,0]},follow:u,resume(d){({position:n,yaw:r,pitch:s}=d),l=[0,0]}}}a(As,"createWalk");function Au(i,e,t,n){if(n)return[e*t,e];let r=Math.exp(-t/Tu);return[e*t+(i-e)*Tu*(1-r),e+(i-e)*r]}a(Au,"glide");var Yp=.5;function Ru(i,e){let{start:t,onChange:n,onThumb:r,onGo:s,pads:o=$p,isSudden:l=Jp()}=e,c="walk",u=null,d=t,p=As(t,()=>u,l),h=Su(t,()=>u),g=du(e.keys??window),_=wu(i,{mode:a(()=>c,"mode"),look:p.look,rotate:h.rotate,pan:h.pan,zoom:h.zoom,thumb:a(f=>r?.(f),"thumb"),go:a((f,m)=>s?.(f,m),"go")}),y=a(()=>c==="walk"?p.pose:h.pose,"current");return{update(f){let m=ys(g.drive,_.drive,uu(o())),S=f>0?Math.min(f,Yp):0;c==="walk"?p.update(S,m):h.update(S,m);let A=y();return mu(A,d)||n?.(A),d=A,A},get mode(){return c},setMode(f){if(f===c)return;let m=y();_.release(),c=f,c==="walk"?p.resume(m):h.setPose(m)},setPose(f){p.setPose(f),h.setPose(f)},lookAround:_.lock,setBounds(f){u=f},dispose(){g.dispose(),_.dispose()}}}a(Ru,"createControls");function $p(){try{return navigator.getGamepads?.()??[]}catch{return[]}}a($p,"browserPads");function Jp(){let i=window.matchMedia("(prefers-reduced-motion: reduce)");return()=>i.matches}a(Jp,"reducedMotion");var Zp=512,Kp=3e7,jp=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;function Za(i){if(i.length>Zp)return null;let e=new URLSearchParams(i.replace(/^#/,"")),[t,n,r,...s]=(e.get("p")??"").split(",").map(Ya);if(!$a(t)||!$a(n)||!$a(r)||s.length>0)return null;let[o,l]=[Ya(e.get("yaw")??"0"),Ya(e.get("pitch")??"0")];return o===null||l===null?null:{position:[t,n,r],yaw:Fi(o),pitch:En(l,-1.5,1.5)}}a(Za,"readLink");function Cu({position:i,yaw:e,pitch:t}){return`#p=${i.map(r=>Ja(r,3)).join(",")}&yaw=${Ja(Fi(e),4)}&pitch=${Ja(t,4)}`}a(Cu,"writeLink");function Ya(i){let e=jp.test(i)?Number(i):Number.NaN;return Number.isFinite(e)?e:null}a(Ya,"numberIn");function $a(i){return i!=null&&Math.abs(i)<=Kp}a($a,"isPlace");function Ja(i,e){return String(Number(i.toFixed(e)))}a(Ja,"rounded");var[Pu,Qp]=[1.7,.5],em=1,tm=15;function Iu(i,[e,t],n,r){let s=qt(bi(i),Oi(i.yaw),(2*e-1)*n*r),[o,l,c]=qt(s,ws(i),(1-2*t)*n),u=Math.hypot(o,l,c);return[o/u,l/u,c/u]}a(Iu,"directionTo");function Lu(i,e,t){let n=i[1]-Pu;if(t&&t[1]<=n+Qp)return[t[0],i[1],t[2]];let r=Math.hypot(e[0],e[2]);if(r===0)return i;let s=t?Math.hypot(t[0]-i[0],t[2]-i[2])-em:tm,o=e[1]<0?Pu*r/-e[1]:Number.POSITIVE_INFINITY,l=Math.max(Math.min(s,o),0);return[i[0]+l*e[0]/r,i[1],i[2]+l*e[2]/r]}a(Lu,"placeFor");var Yt={radius:0,strength:0};function Nu(i,e,t,n,r=0){let s=n.radii[e-1];if(s===void 0)return Yt;let o=n.speed*Math.PI/180/n.reach,l=t,c=i.radius===0?0:i.strength,u=n.radii.find(h=>h>=r)??Number.POSITIVE_INFINITY;if(c===0&&u>s)return{radius:s,strength:c};let d=c===0?u:i.radius;if(c<1){let h=1/(Math.max(n.nearShare,.05)*d*o),g=(1-c)*h;c=l>=g?1:c+l/h,l=Math.max(0,l-g)}if(c<1||d>=s)return{radius:Math.min(d,s),strength:c};let p=1/d-(1-n.nearShare)*o*l;return{radius:p<=1/s?s:1/p,strength:c}}a(Nu,"grow");var[nm,im,rm]=[.5,4,.9],Uu=.25,[sm,om]=[.1,2],am=.3,lm=.5,cm=1-1e-9,[um,hm]=[.9,.5];function Sr(i,e,t=-1){let n=null,r=Number.POSITIVE_INFINITY;return i.forEach(({center:s},o)=>{let l=Fu(s,e);o===t||l>=r||([n,r]=[o,l])}),n}a(Sr,"nearestOf");function Fu(i,e){return Math.hypot(i[0]-e[0],i[1]-e[1],i[2]-e[2])}a(Fu,"apartOf");function Ou(i,e,t){let n=t,r=null,s=null,o=null,l=null,c=a(v=>i.regions[v],"entry");function u(v,M){let{center:T,fold_margin:x}=c(v);return{center:T,metres:M&&M.strength>0?i.marginShare*M.radius:x}}a(u,"limitOf");function d(v,M){return v.metres-Bt(M,v)}a(d,"room");let p=a((v,M)=>Fu(c(v).center,M),"far");function h(v,M){let T=Math.max(p(v,c(n).center),1e-6);return{apart:T,border:(p(v,M)**2-p(n,M)**2)/(2*T)}}a(h,"borderTo");function g(v){let M=Sr(i.regions,v,n);if(M===null)return null;let{apart:T,border:x}=h(M,v),w=Math.max(nm*T/2,Math.min(rm*T/2,im));return r!==null&&r!==n&&p(r,v)<p(M,v)+Uu*T&&h(r,v).border<w+Uu*T/2?r:x<w?M:null}a(g,"chooseAhead");function _(v){let M=e.grown(n),T=M&&e.offer(v,M);return!M||!T||M.strength>0&&T.strength===0?null:T}a(_,"offered");function y(v,M){let[T,x]=[e.grown(n),_(v)];if(!T||!x)return!1;let w=Math.min(sm*h(v,M).apart,om),[P,C]=[u(n,T),u(v,x)],D=p(v,M)+w<=p(n,M),B=T.strength===0||x.radius>=T.radius||e.isComplete(v);return D&&B&&d(C,M)>=am*C.metres?!0:d(P,M)<(1-.8)*P.metres&&d(C,M)>=Math.max(d(P,M),0)+w}a(y,"mayCross");function f(v,M,T){s={region:n,pose:T,since:0},v!==n&&(e.enter(v,M),n=v)}a(f,"take");function m(v,M,T){let{center:x,metres:w}=u(v,M);return{...T,position:Ms(T.position,{center:x,metres:um*w})}}a(m,"landing");function S(v){if(!o)return;let{region:M,target:T}=o,x=e.grown(n),w=M===n,P=w?x:e.offer(M,x??Yt);if(!P)return;let C=w||d(u(M,P),T.position)>(1-.8)*u(M,P).metres,D=m(M,C?P:Yt,T);o=null,f(M,C&&x?x:Yt,x?v:null),x||(s=null),l=D,i.moved(D)}a(S,"depart");function A(v){let M=o?.region??null;s?r=s.region===n?null:s.region:r=M===null?g(v):null;let T=s?r:M??r,x=[...new Set([n,T??n])];T!==null&&(M!==null&&!s||p(T,v)<p(n,v))&&x.reverse();for(let P=0;P<i.regions.length;P++)x.includes(P)||e.close(P);for(let P of x)e.open(P);e.prefer(x)}return a(A,"arrange"),e.open(t),e.enter(t,Yt),{advance(v,M){l=M,s&&(s.since+=v,s.since>=i.fade&&(s.region!==n&&e.leave(s.region),s=null)),s||S(M),A(l.position),!s&&!o&&r!==null&&y(r,l.position)&&(f(r,e.grown(n)??Yt,null),A(l.position));let T=s&&i.fade>0?s.since/i.fade:1;return{region:n,leaving:s&&{region:s.region,pose:s.pose,share:T}}},go(v){let M=Sr(i.regions,v.position)??n,T=u(n,e.grown(n));o={region:d(T,v.position)>=hm*T.metres?n:M,target:v}},failed(v){o?.region===v&&v!==n&&e.offer(v,Yt)===null&&(o=null)},get bounds(){let v=u(n,e.grown(n)),M=s&&!s.pose?[v,u(s.region,e.grown(s.region))]:[v],T=!s&&r!==null?_(r):null;return{shown:M,open:T&&r!==null?[v,u(r,T)]:[v]}},get region(){return n},get goal(){return o?.region??null},get least(){let{center:v,fold_margin:M}=c(n),T=l?Bt(l.position,{center:v,metres:M}):0;return cm*Math.min(T+lm,M)/i.marginShare}}}a(Ou,"createJourney");function Bu(i=()=>performance.now()/1e3){let e=0,t=[],n=[];return{receive(r){e+=r,t.push({time:i(),bytes:r})},frame(r){n.push(r);let s=n.reduce((o,l)=>o+l,0);for(;n.length>1&&s>1;)s-=n.shift()??0},restart(){e=0,t=[],n=[]},read(){let r=i()-1;t=t.filter(({time:l})=>l>r);let s=t.reduce((l,c)=>l+c.bytes,0),o=n.reduce((l,c)=>l+c,0)/Math.max(n.length,1);return{received:e,rate:s>0?8*s/1:null,frame:1e3*o,longest:1e3*Math.max(0,...n)}}}}a(Bu,"createMeter");function Ka(i){return{...i,regions:i.regions.map(dm)}}a(Ka,"byFootprint");function dm(i,e){let{by_footprint:t,rings:n}=i;if(!t){let l=`manifest.json: regions[${e}].by_footprint`;throw new Ye(`${l}: expected objects by footprint, got none: export the scene with by_footprint=True`,"other")}let r=n[n.length-1]?.radius??0,s={objects:0,triangles:0,geometry:null,parts:[]},o=t.portions.map(l=>({...l,radius:r,map:null}));return{...i,rings:[{...s,radius:0,map:null},...o,{...s,radius:r,map:t.map}]}}a(dm,"inPortions");var ku=a(i=>i,"asItIs"),ja={clovr:{isSmooth:!0,isWhole:!1,arrange:ku},clovrd:{isSmooth:!1,isWhole:!1,arrange:ku},vis0:{isSmooth:!1,isWhole:!0,arrange:Ka},vis1:{isSmooth:!1,isWhole:!1,arrange:Ka}};function zu(i){let e=Object.hasOwn(ja,i??"clovr")?ja[i??"clovr"]:void 0;if(!e)throw new Ye(`strategy: expected ${Object.keys(ja).join(", ")}, got ${i??""}`,"other");return e}a(zu,"strategyOf");var hh=0,Tl=1,dh=2;var ts=1,fh=2,ar=3,hi=0,Vt=1,cn=2,qn=0,lr=1,Al=2,Rl=3,Cl=4,cr=5;var Pi=100,ph=101,mh=102,gh=103,_h=104,xh=200,ur=201,yh=202,vh=203,ns=204,di=205,Sh=206,Mh=207,bh=208,wh=209,Eh=210,Th=211,Ah=212,Rh=213,Ch=214,Ks=0,js=1,Qs=2,Qi=3,eo=4,to=5,no=6,io=7,Po=0,Ph=1,Ih=2,Ln=0,Pl=1,Il=2,Ll=3,Nl=4,Dl=5,Ul=6,Fl=7;var Ol=300,Ii=301,hr=302,Io=303,Lo=304,er=1e3,An=1001,ro=1002,Mt=1003,Lh=1004;var is=1005;var At=1006,No=1007;var vn=1008;var jt=1009,Bl=1010,kl=1011,dr=1012,Do=1013,Qt=1014,un=1015,Sn=1016,Uo=1017,Fo=1018,Li=1020,zl=35902,Gl=35899,Vl=1021,Hl=1022,Mn=1023,Wn=1026,Yn=1027,Oo=1028,Bo=1029,fi=1030,ko=1031;var zo=1033,rs=33776,ss=33777,os=33778,as=33779,Go=35840,Vo=35841,Ho=35842,Wo=35843,Xo=36196,qo=37492,Yo=37496,$o=37488,Jo=37489,ls=37490,Zo=37491,Ko=37808,jo=37809,Qo=37810,ea=37811,ta=37812,na=37813,ia=37814,ra=37815,sa=37816,oa=37817,aa=37818,la=37819,ca=37820,ua=37821,ha=36492,da=36494,fa=36495,pa=36283,ma=36284,cs=36285,ga=36286;var Cr=2300,so=2301,Js=2302,vl=2303,Sl=2400,Ml=2401,bl=2402;var Nh=3200;var _a=0,Dh=1,$n="",zt="srgb",Pr="srgb-linear",Ir="linear",Ke="srgb";var Zs=7680;var Uh=519,Fh=512,Oh=513,Bh=514,Wl=515,kh=516,zh=517,Xl=518,ql=519,Yl=35044;var Jn="300 es",ln=2e3,Lr=2001;function fm(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}a(fm,"arrayNeedsUint32");function pm(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}a(pm,"isTypedArray");function Nr(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}a(Nr,"createElementNS");function Gh(){let i=Nr("canvas");return i.style.display="block",i}a(Gh,"createCanvasElement");var Gu={},tr=null;function Dr(...i){let e="THREE."+i.shift();tr?tr("log",e,...i):console.log(e,...i)}a(Dr,"log");function Vh(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}a(Vh,"enhanceLogMessage");function Pe(...i){i=Vh(i);let e="THREE."+i.shift();if(tr)tr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}a(Pe,"warn");function Ne(...i){i=Vh(i);let e="THREE."+i.shift();if(tr)tr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}a(Ne,"error");function Rr(...i){let e=i.join(" ");e in Gu||(Gu[e]=!0,Pe(...i))}a(Rr,"warnOnce");function Hh(i,e,t){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:n()}}a(s,"probe"),setTimeout(s,t)})}a(Hh,"probeAsync");var Wh={[Ks]:Ks,[Qs]:no,[eo]:eo,[Qi]:to,[js]:js,[no]:Qs,[io]:io,[to]:Qi},Rn=class{static{a(this,"EventDispatcher")}addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},It=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Qa=Math.PI/180,oo=180/Math.PI;function Ni(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(It[i&255]+It[i>>8&255]+It[i>>16&255]+It[i>>24&255]+"-"+It[e&255]+It[e>>8&255]+"-"+It[e>>16&15|64]+It[e>>24&255]+"-"+It[t&63|128]+It[t>>8&255]+"-"+It[t>>16&255]+It[t>>24&255]+It[n&255]+It[n>>8&255]+It[n>>16&255]+It[n>>24&255]).toLowerCase()}a(Ni,"generateUUID");function $e(i,e,t){return Math.max(e,Math.min(t,i))}a($e,"clamp");function mm(i,e){return(i%e+e)%e}a(mm,"euclideanModulo");function el(i,e,t){return(1-t)*i+t*e}a(el,"lerp");function Xh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}a(Xh,"floorPowerOfTwo");function xa(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}a(xa,"getNormalizationScale");function qh(i,e){if(e.constructor===Float32Array)return i;let t=xa(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}a(qh,"denormalize");function Yh(i,e){if(e.constructor===Float32Array)return i;let t=xa(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}a(Yh,"normalize");var Ge=class{static{a(this,"Vector2")}static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=$e(this.x,e.x,t.x),this.y=$e(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=$e(this.x,e,t),this.y=$e(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar($e(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos($e(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*n-o*r+e.x,this.y=s*r+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Cn=class{static{a(this,"Quaternion")}constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,s,o,l){let c=n[r+0],u=n[r+1],d=n[r+2],p=n[r+3],h=s[o+0],g=s[o+1],_=s[o+2],y=s[o+3];if(p!==y||c!==h||u!==g||d!==_){let f=c*h+u*g+d*_+p*y;f<0&&(h=-h,g=-g,_=-_,y=-y,f=-f);let m=1-l;if(f<.9995){let S=Math.acos(f),A=Math.sin(S);m=Math.sin(m*S)/A,l=Math.sin(l*S)/A,c=c*m+h*l,u=u*m+g*l,d=d*m+_*l,p=p*m+y*l}else{c=c*m+h*l,u=u*m+g*l,d=d*m+_*l,p=p*m+y*l;let S=1/Math.sqrt(c*c+u*u+d*d+p*p);c*=S,u*=S,d*=S,p*=S}}e[t]=c,e[t+1]=u,e[t+2]=d,e[t+3]=p}static multiplyQuaternionsFlat(e,t,n,r,s,o){let l=n[r],c=n[r+1],u=n[r+2],d=n[r+3],p=s[o],h=s[o+1],g=s[o+2],_=s[o+3];return e[t]=l*_+d*p+c*g-u*h,e[t+1]=c*_+d*h+u*p-l*g,e[t+2]=u*_+d*g+l*h-c*p,e[t+3]=d*_-l*p-c*h-u*g,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,s=e._z,o=e._order,l=Math.cos,c=Math.sin,u=l(n/2),d=l(r/2),p=l(s/2),h=c(n/2),g=c(r/2),_=c(s/2);switch(o){case"XYZ":this._x=h*d*p+u*g*_,this._y=u*g*p-h*d*_,this._z=u*d*_+h*g*p,this._w=u*d*p-h*g*_;break;case"YXZ":this._x=h*d*p+u*g*_,this._y=u*g*p-h*d*_,this._z=u*d*_-h*g*p,this._w=u*d*p+h*g*_;break;case"ZXY":this._x=h*d*p-u*g*_,this._y=u*g*p+h*d*_,this._z=u*d*_+h*g*p,this._w=u*d*p-h*g*_;break;case"ZYX":this._x=h*d*p-u*g*_,this._y=u*g*p+h*d*_,this._z=u*d*_-h*g*p,this._w=u*d*p+h*g*_;break;case"YZX":this._x=h*d*p+u*g*_,this._y=u*g*p+h*d*_,this._z=u*d*_-h*g*p,this._w=u*d*p-h*g*_;break;case"XZY":this._x=h*d*p-u*g*_,this._y=u*g*p-h*d*_,this._z=u*d*_+h*g*p,this._w=u*d*p+h*g*_;break;default:Pe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],s=t[8],o=t[1],l=t[5],c=t[9],u=t[2],d=t[6],p=t[10],h=n+l+p;if(h>0){let g=.5/Math.sqrt(h+1);this._w=.25/g,this._x=(d-c)*g,this._y=(s-u)*g,this._z=(o-r)*g}else if(n>l&&n>p){let g=2*Math.sqrt(1+n-l-p);this._w=(d-c)/g,this._x=.25*g,this._y=(r+o)/g,this._z=(s+u)/g}else if(l>p){let g=2*Math.sqrt(1+l-n-p);this._w=(s-u)/g,this._x=(r+o)/g,this._y=.25*g,this._z=(c+d)/g}else{let g=2*Math.sqrt(1+p-n-l);this._w=(o-r)/g,this._x=(s+u)/g,this._y=(c+d)/g,this._z=.25*g}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs($e(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,l=t._x,c=t._y,u=t._z,d=t._w;return this._x=n*d+o*l+r*u-s*c,this._y=r*d+o*c+s*l-n*u,this._z=s*d+o*u+n*c-r*l,this._w=o*d-n*l-r*c-s*u,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,l=this.dot(e);l<0&&(n=-n,r=-r,s=-s,o=-o,l=-l);let c=1-t;if(l<.9995){let u=Math.acos(l),d=Math.sin(u);c=Math.sin(c*u)/d,t=Math.sin(t*u)/d,this._x=this._x*c+n*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+r*t,this._z=this._z*c+s*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{a(this,"Vector3")}static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Vu.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Vu.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6]*r,this.y=s[1]*t+s[4]*n+s[7]*r,this.z=s[2]*t+s[5]*n+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*n+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*n+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*n+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,s=e.x,o=e.y,l=e.z,c=e.w,u=2*(o*r-l*n),d=2*(l*t-s*r),p=2*(s*n-o*t);return this.x=t+c*u+o*p-l*d,this.y=n+c*d+l*u-s*p,this.z=r+c*p+s*d-o*u,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*n+s[8]*r,this.y=s[1]*t+s[5]*n+s[9]*r,this.z=s[2]*t+s[6]*n+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=$e(this.x,e.x,t.x),this.y=$e(this.y,e.y,t.y),this.z=$e(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=$e(this.x,e,t),this.y=$e(this.y,e,t),this.z=$e(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar($e(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,s=e.z,o=t.x,l=t.y,c=t.z;return this.x=r*c-s*l,this.y=s*o-n*c,this.z=n*l-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return tl.copy(this).projectOnVector(e),this.sub(tl)}reflect(e){return this.sub(tl.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos($e(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},tl=new H,Vu=new Cn,De=class{static{a(this,"Matrix3")}static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,s,o,l,c,u){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,l,c,u)}set(e,t,n,r,s,o,l,c,u){let d=this.elements;return d[0]=e,d[1]=r,d[2]=l,d[3]=t,d[4]=s,d[5]=c,d[6]=n,d[7]=o,d[8]=u,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],l=n[3],c=n[6],u=n[1],d=n[4],p=n[7],h=n[2],g=n[5],_=n[8],y=r[0],f=r[3],m=r[6],S=r[1],A=r[4],v=r[7],M=r[2],T=r[5],x=r[8];return s[0]=o*y+l*S+c*M,s[3]=o*f+l*A+c*T,s[6]=o*m+l*v+c*x,s[1]=u*y+d*S+p*M,s[4]=u*f+d*A+p*T,s[7]=u*m+d*v+p*x,s[2]=h*y+g*S+_*M,s[5]=h*f+g*A+_*T,s[8]=h*m+g*v+_*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],l=e[5],c=e[6],u=e[7],d=e[8];return t*o*d-t*l*u-n*s*d+n*l*c+r*s*u-r*o*c}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],l=e[5],c=e[6],u=e[7],d=e[8],p=d*o-l*u,h=l*c-d*s,g=u*s-o*c,_=t*p+n*h+r*g;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/_;return e[0]=p*y,e[1]=(r*u-d*n)*y,e[2]=(l*n-r*o)*y,e[3]=h*y,e[4]=(d*t-r*c)*y,e[5]=(r*s-l*t)*y,e[6]=g*y,e[7]=(n*c-u*t)*y,e[8]=(o*t-n*s)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,s,o,l){let c=Math.cos(s),u=Math.sin(s);return this.set(n*c,n*u,-n*(c*o+u*l)+o+e,-r*u,r*c,-r*(-u*o+c*l)+l+t,0,0,1),this}scale(e,t){return Rr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(nl.makeScale(e,t)),this}rotate(e){return Rr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(nl.makeRotation(-e)),this}translate(e,t){return Rr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(nl.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},nl=new De,Hu=new De().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Wu=new De().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function gm(){let i={enabled:!0,workingColorSpace:Pr,spaces:{},convert:a(function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Ke&&(r.r=Hn(r.r),r.g=Hn(r.g),r.b=Hn(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ke&&(r.r=ji(r.r),r.g=ji(r.g),r.b=ji(r.b))),r},"convert"),workingToColorSpace:a(function(r,s){return this.convert(r,this.workingColorSpace,s)},"workingToColorSpace"),colorSpaceToWorking:a(function(r,s){return this.convert(r,s,this.workingColorSpace)},"colorSpaceToWorking"),getPrimaries:a(function(r){return this.spaces[r].primaries},"getPrimaries"),getTransfer:a(function(r){return r===$n?Ir:this.spaces[r].transfer},"getTransfer"),getToneMappingMode:a(function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},"getToneMappingMode"),getLuminanceCoefficients:a(function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},"getLuminanceCoefficients"),define:a(function(r){Object.assign(this.spaces,r)},"define"),_getMatrix:a(function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},"_getMatrix"),_getDrawingBufferColorSpace:a(function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},"_getDrawingBufferColorSpace"),_getUnpackColorSpace:a(function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace},"_getUnpackColorSpace")},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Pr]:{primaries:e,whitePoint:n,transfer:Ir,toXYZ:Hu,fromXYZ:Wu,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:zt},outputColorSpaceConfig:{drawingBufferColorSpace:zt}},[zt]:{primaries:e,whitePoint:n,transfer:Ke,toXYZ:Hu,fromXYZ:Wu,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:zt}}}),i}a(gm,"createColorManagement");var qe=gm();function Hn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}a(Hn,"SRGBToLinear");function ji(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}a(ji,"LinearToSRGB");var Bi,ao=class{static{a(this,"ImageUtils")}static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Bi===void 0&&(Bi=Nr("canvas")),Bi.width=e.width,Bi.height=e.height;let r=Bi.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=Bi}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Nr("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Hn(s[o]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Hn(t[n]/255)*255):t[n]=Hn(t[n]);return{data:t,width:e.width,height:e.height}}else return Pe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},_m=0,nr=class{static{a(this,"TextureSource")}constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:_m++}),this.uuid=Ni(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,l=r.length;o<l;o++)r[o].isDataTexture?s.push(il(r[o].image)):s.push(il(r[o]))}else s=il(r);n.url=s}return t||(e.images[this.uuid]=n),n}};function il(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ao.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Pe("Texture: Unable to serialize Texture."),{})}a(il,"serializeImage");var xm=0,rl=new H,Nt=class i extends Rn{static{a(this,"Texture")}constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=An,r=An,s=At,o=vn,l=Mn,c=jt,u=i.DEFAULT_ANISOTROPY,d=$n){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:xm++}),this.uuid=Ni(),this.name="",this.source=new nr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=u,this.format=l,this.internalFormat=null,this.type=c,this.offset=new Ge(0,0),this.repeat=new Ge(1,1),this.center=new Ge(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new De,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=d,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(rl).x}get height(){return this.source.getSize(rl).y}get depth(){return this.source.getSize(rl).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Pe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Pe(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Ol)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case er:e.x=e.x-Math.floor(e.x);break;case An:e.x=e.x<0?0:1;break;case ro:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case er:e.y=e.y-Math.floor(e.y);break;case An:e.y=e.y<0?0:1;break;case ro:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Nt.DEFAULT_IMAGE=null;Nt.DEFAULT_MAPPING=Ol;Nt.DEFAULT_ANISOTROPY=1;var nt=class{static{a(this,"Vector4")}static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*n+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*n+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*n+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,s,c=e.elements,u=c[0],d=c[4],p=c[8],h=c[1],g=c[5],_=c[9],y=c[2],f=c[6],m=c[10];if(Math.abs(d-h)<.01&&Math.abs(p-y)<.01&&Math.abs(_-f)<.01){if(Math.abs(d+h)<.1&&Math.abs(p+y)<.1&&Math.abs(_+f)<.1&&Math.abs(u+g+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(u+1)/2,v=(g+1)/2,M=(m+1)/2,T=(d+h)/4,x=(p+y)/4,w=(_+f)/4;return A>v&&A>M?A<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(A),r=T/n,s=x/n):v>M?v<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(v),n=T/r,s=w/r):M<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(M),n=x/s,r=w/s),this.set(n,r,s,t),this}let S=Math.sqrt((f-_)*(f-_)+(p-y)*(p-y)+(h-d)*(h-d));return Math.abs(S)<.001&&(S=1),this.x=(f-_)/S,this.y=(p-y)/S,this.z=(h-d)/S,this.w=Math.acos((u+g+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=$e(this.x,e.x,t.x),this.y=$e(this.y,e.y,t.y),this.z=$e(this.z,e.z,t.z),this.w=$e(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=$e(this.x,e,t),this.y=$e(this.y,e,t),this.z=$e(this.z,e,t),this.w=$e(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar($e(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},lo=class extends Rn{static{a(this,"RenderTarget")}constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:At,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new nt(0,0,e,t),this.scissorTest=!1,this.viewport=new nt(0,0,e,t),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new Nt({width:e,height:t,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:At,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new nr(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Dt=class extends lo{static{a(this,"WebGLRenderTarget")}constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Ur=class extends Nt{static{a(this,"DataArrayTexture")}constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Mt,this.minFilter=Mt,this.wrapR=An,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var co=class extends Nt{static{a(this,"Data3DTexture")}constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Mt,this.minFilter=Mt,this.wrapR=An,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Qe=class i{static{a(this,"Matrix4")}static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,s,o,l,c,u,d,p,h,g,_,y,f){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,l,c,u,d,p,h,g,_,y,f)}set(e,t,n,r,s,o,l,c,u,d,p,h,g,_,y,f){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=r,m[1]=s,m[5]=o,m[9]=l,m[13]=c,m[2]=u,m[6]=d,m[10]=p,m[14]=h,m[3]=g,m[7]=_,m[11]=y,m[15]=f,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/ki.setFromMatrixColumn(e,0).length(),s=1/ki.setFromMatrixColumn(e,1).length(),o=1/ki.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*s,t[5]=n[5]*s,t[6]=n[6]*s,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,s=e.z,o=Math.cos(n),l=Math.sin(n),c=Math.cos(r),u=Math.sin(r),d=Math.cos(s),p=Math.sin(s);if(e.order==="XYZ"){let h=o*d,g=o*p,_=l*d,y=l*p;t[0]=c*d,t[4]=-c*p,t[8]=u,t[1]=g+_*u,t[5]=h-y*u,t[9]=-l*c,t[2]=y-h*u,t[6]=_+g*u,t[10]=o*c}else if(e.order==="YXZ"){let h=c*d,g=c*p,_=u*d,y=u*p;t[0]=h+y*l,t[4]=_*l-g,t[8]=o*u,t[1]=o*p,t[5]=o*d,t[9]=-l,t[2]=g*l-_,t[6]=y+h*l,t[10]=o*c}else if(e.order==="ZXY"){let h=c*d,g=c*p,_=u*d,y=u*p;t[0]=h-y*l,t[4]=-o*p,t[8]=_+g*l,t[1]=g+_*l,t[5]=o*d,t[9]=y-h*l,t[2]=-o*u,t[6]=l,t[10]=o*c}else if(e.order==="ZYX"){let h=o*d,g=o*p,_=l*d,y=l*p;t[0]=c*d,t[4]=_*u-g,t[8]=h*u+y,t[1]=c*p,t[5]=y*u+h,t[9]=g*u-_,t[2]=-u,t[6]=l*c,t[10]=o*c}else if(e.order==="YZX"){let h=o*c,g=o*u,_=l*c,y=l*u;t[0]=c*d,t[4]=y-h*p,t[8]=_*p+g,t[1]=p,t[5]=o*d,t[9]=-l*d,t[2]=-u*d,t[6]=g*p+_,t[10]=h-y*p}else if(e.order==="XZY"){let h=o*c,g=o*u,_=l*c,y=l*u;t[0]=c*d,t[4]=-p,t[8]=u*d,t[1]=h*p+y,t[5]=o*d,t[9]=g*p-_,t[2]=_*p-g,t[6]=l*d,t[10]=y*p+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(ym,e,vm)}lookAt(e,t,n){let r=this.elements;return $t.subVectors(e,t),$t.lengthSq()===0&&($t.z=1),$t.normalize(),ei.crossVectors(n,$t),ei.lengthSq()===0&&(Math.abs(n.z)===1?$t.x+=1e-4:$t.z+=1e-4,$t.normalize(),ei.crossVectors(n,$t)),ei.normalize(),Rs.crossVectors($t,ei),r[0]=ei.x,r[4]=Rs.x,r[8]=$t.x,r[1]=ei.y,r[5]=Rs.y,r[9]=$t.y,r[2]=ei.z,r[6]=Rs.z,r[10]=$t.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],l=n[4],c=n[8],u=n[12],d=n[1],p=n[5],h=n[9],g=n[13],_=n[2],y=n[6],f=n[10],m=n[14],S=n[3],A=n[7],v=n[11],M=n[15],T=r[0],x=r[4],w=r[8],P=r[12],C=r[1],D=r[5],B=r[9],X=r[13],L=r[2],q=r[6],O=r[10],z=r[14],te=r[3],Y=r[7],ee=r[11],ne=r[15];return s[0]=o*T+l*C+c*L+u*te,s[4]=o*x+l*D+c*q+u*Y,s[8]=o*w+l*B+c*O+u*ee,s[12]=o*P+l*X+c*z+u*ne,s[1]=d*T+p*C+h*L+g*te,s[5]=d*x+p*D+h*q+g*Y,s[9]=d*w+p*B+h*O+g*ee,s[13]=d*P+p*X+h*z+g*ne,s[2]=_*T+y*C+f*L+m*te,s[6]=_*x+y*D+f*q+m*Y,s[10]=_*w+y*B+f*O+m*ee,s[14]=_*P+y*X+f*z+m*ne,s[3]=S*T+A*C+v*L+M*te,s[7]=S*x+A*D+v*q+M*Y,s[11]=S*w+A*B+v*O+M*ee,s[15]=S*P+A*X+v*z+M*ne,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[12],o=e[1],l=e[5],c=e[9],u=e[13],d=e[2],p=e[6],h=e[10],g=e[14],_=e[3],y=e[7],f=e[11],m=e[15],S=c*g-u*h,A=l*g-u*p,v=l*h-c*p,M=o*g-u*d,T=o*h-c*d,x=o*p-l*d;return t*(y*S-f*A+m*v)-n*(_*S-f*M+m*T)+r*(_*A-y*M+m*x)-s*(_*v-y*T+f*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[1],o=e[5],l=e[9],c=e[2],u=e[6],d=e[10];return t*(o*d-l*u)-n*(s*d-l*c)+r*(s*u-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],l=e[5],c=e[6],u=e[7],d=e[8],p=e[9],h=e[10],g=e[11],_=e[12],y=e[13],f=e[14],m=e[15],S=t*l-n*o,A=t*c-r*o,v=t*u-s*o,M=n*c-r*l,T=n*u-s*l,x=r*u-s*c,w=d*y-p*_,P=d*f-h*_,C=d*m-g*_,D=p*f-h*y,B=p*m-g*y,X=h*m-g*f,L=S*X-A*B+v*D+M*C-T*P+x*w;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let q=1/L;return e[0]=(l*X-c*B+u*D)*q,e[1]=(r*B-n*X-s*D)*q,e[2]=(y*x-f*T+m*M)*q,e[3]=(h*T-p*x-g*M)*q,e[4]=(c*C-o*X-u*P)*q,e[5]=(t*X-r*C+s*P)*q,e[6]=(f*v-_*x-m*A)*q,e[7]=(d*x-h*v+g*A)*q,e[8]=(o*B-l*C+u*w)*q,e[9]=(n*C-t*B-s*w)*q,e[10]=(_*T-y*v+m*S)*q,e[11]=(p*v-d*T-g*S)*q,e[12]=(l*P-o*D-c*w)*q,e[13]=(t*D-n*P+r*w)*q,e[14]=(y*A-_*M-f*S)*q,e[15]=(d*M-p*A+h*S)*q,this}scale(e){let t=this.elements,n=e.x,r=e.y,s=e.z;return t[0]*=n,t[4]*=r,t[8]*=s,t[1]*=n,t[5]*=r,t[9]*=s,t[2]*=n,t[6]*=r,t[10]*=s,t[3]*=n,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),s=1-n,o=e.x,l=e.y,c=e.z,u=s*o,d=s*l;return this.set(u*o+n,u*l-r*c,u*c+r*l,0,u*l+r*c,d*l+n,d*c-r*o,0,u*c-r*l,d*c+r*o,s*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,s,o){return this.set(1,n,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,s=t._x,o=t._y,l=t._z,c=t._w,u=s+s,d=o+o,p=l+l,h=s*u,g=s*d,_=s*p,y=o*d,f=o*p,m=l*p,S=c*u,A=c*d,v=c*p,M=n.x,T=n.y,x=n.z;return r[0]=(1-(y+m))*M,r[1]=(g+v)*M,r[2]=(_-A)*M,r[3]=0,r[4]=(g-v)*T,r[5]=(1-(h+m))*T,r[6]=(f+S)*T,r[7]=0,r[8]=(_+A)*x,r[9]=(f-S)*x,r[10]=(1-(h+y))*x,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),t.identity(),this;let o=ki.set(r[0],r[1],r[2]).length(),l=ki.set(r[4],r[5],r[6]).length(),c=ki.set(r[8],r[9],r[10]).length();s<0&&(o=-o),fn.copy(this);let u=1/o,d=1/l,p=1/c;return fn.elements[0]*=u,fn.elements[1]*=u,fn.elements[2]*=u,fn.elements[4]*=d,fn.elements[5]*=d,fn.elements[6]*=d,fn.elements[8]*=p,fn.elements[9]*=p,fn.elements[10]*=p,t.setFromRotationMatrix(fn),n.x=o,n.y=l,n.z=c,this}makePerspective(e,t,n,r,s,o,l=ln,c=!1){let u=this.elements,d=2*s/(t-e),p=2*s/(n-r),h=(t+e)/(t-e),g=(n+r)/(n-r),_,y;if(c)_=s/(o-s),y=o*s/(o-s);else if(l===ln)_=-(o+s)/(o-s),y=-2*o*s/(o-s);else if(l===Lr)_=-o/(o-s),y=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+l);return u[0]=d,u[4]=0,u[8]=h,u[12]=0,u[1]=0,u[5]=p,u[9]=g,u[13]=0,u[2]=0,u[6]=0,u[10]=_,u[14]=y,u[3]=0,u[7]=0,u[11]=-1,u[15]=0,this}makeOrthographic(e,t,n,r,s,o,l=ln,c=!1){let u=this.elements,d=2/(t-e),p=2/(n-r),h=-(t+e)/(t-e),g=-(n+r)/(n-r),_,y;if(c)_=1/(o-s),y=o/(o-s);else if(l===ln)_=-2/(o-s),y=-(o+s)/(o-s);else if(l===Lr)_=-1/(o-s),y=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+l);return u[0]=d,u[4]=0,u[8]=0,u[12]=h,u[1]=0,u[5]=p,u[9]=0,u[13]=g,u[2]=0,u[6]=0,u[10]=_,u[14]=y,u[3]=0,u[7]=0,u[11]=0,u[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},ki=new H,fn=new Qe,ym=new H(0,0,0),vm=new H(1,1,1),ei=new H,Rs=new H,$t=new H,Xu=new Qe,qu=new Cn,Xn=class i{static{a(this,"Euler")}constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,s=r[0],o=r[4],l=r[8],c=r[1],u=r[5],d=r[9],p=r[2],h=r[6],g=r[10];switch(t){case"XYZ":this._y=Math.asin($e(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-d,g),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(h,u),this._z=0);break;case"YXZ":this._x=Math.asin(-$e(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(l,g),this._z=Math.atan2(c,u)):(this._y=Math.atan2(-p,s),this._z=0);break;case"ZXY":this._x=Math.asin($e(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-p,g),this._z=Math.atan2(-o,u)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-$e(p,-1,1)),Math.abs(p)<.9999999?(this._x=Math.atan2(h,g),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-o,u));break;case"YZX":this._z=Math.asin($e(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-d,u),this._y=Math.atan2(-p,s)):(this._x=0,this._y=Math.atan2(l,g));break;case"XZY":this._z=Math.asin(-$e(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,u),this._y=Math.atan2(l,s)):(this._x=Math.atan2(-d,g),this._y=0);break;default:Pe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Xu.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Xu,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return qu.setFromEuler(this),this.setFromQuaternion(qu,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Xn.DEFAULT_ORDER="XYZ";var Fr=class{static{a(this,"Layers")}constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Sm=0,Yu=new H,zi=new Cn,Bn=new Qe,Cs=new H,Mr=new H,Mm=new H,bm=new Cn,$u=new H(1,0,0),Ju=new H(0,1,0),Zu=new H(0,0,1),Ku={type:"added"},wm={type:"removed"},Gi={type:"childadded",child:null},sl={type:"childremoved",child:null},Xt=class i extends Rn{static{a(this,"Object3D")}constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Sm++}),this.uuid=Ni(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new H,t=new Xn,n=new Cn,r=new H(1,1,1);function s(){n.setFromEuler(t,!1)}a(s,"onRotationChange");function o(){t.setFromQuaternion(n,void 0,!1)}a(o,"onQuaternionChange"),t._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Qe},normalMatrix:{value:new De}}),this.matrix=new Qe,this.matrixWorld=new Qe,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Fr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return zi.setFromAxisAngle(e,t),this.quaternion.multiply(zi),this}rotateOnWorldAxis(e,t){return zi.setFromAxisAngle(e,t),this.quaternion.premultiply(zi),this}rotateX(e){return this.rotateOnAxis($u,e)}rotateY(e){return this.rotateOnAxis(Ju,e)}rotateZ(e){return this.rotateOnAxis(Zu,e)}translateOnAxis(e,t){return Yu.copy(e).applyQuaternion(this.quaternion),this.position.add(Yu.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis($u,e)}translateY(e){return this.translateOnAxis(Ju,e)}translateZ(e){return this.translateOnAxis(Zu,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Bn.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Cs.copy(e):Cs.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),Mr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Bn.lookAt(Mr,Cs,this.up):Bn.lookAt(Cs,Mr,this.up),this.quaternion.setFromRotationMatrix(Bn),r&&(Bn.extractRotation(r.matrixWorld),zi.setFromRotationMatrix(Bn),this.quaternion.premultiply(zi.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ne("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Ku),Gi.child=e,this.dispatchEvent(Gi),Gi.child=null):Ne("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(wm),sl.child=e,this.dispatchEvent(sl),sl.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Bn.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Bn.multiply(e.parent.matrixWorld)),e.applyMatrix4(Bn),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Ku),Gi.child=e,this.dispatchEvent(Gi),Gi.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Mr,e,Mm),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Mr,bm,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*n-s[8]*r,s[13]+=n-s[1]*t-s[5]*n-s[9]*r,s[14]+=r-s[2]*t-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let s=this.children;for(let o=0,l=s.length;o<l;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(l=>({...l,boundingBox:l.boundingBox?l.boundingBox.toJSON():void 0,boundingSphere:l.boundingSphere?l.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(l=>({...l})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(l,c){return l[c.uuid]===void 0&&(l[c.uuid]=c.toJSON(e)),c.uuid}if(a(s,"serialize"),this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let l=this.geometry.parameters;if(l!==void 0&&l.shapes!==void 0){let c=l.shapes;if(Array.isArray(c))for(let u=0,d=c.length;u<d;u++){let p=c[u];s(e.shapes,p)}else s(e.shapes,c)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let l=[];for(let c=0,u=this.material.length;c<u;c++)l.push(s(e.materials,this.material[c]));r.material=l}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let l=0;l<this.children.length;l++)r.children.push(this.children[l].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let l=0;l<this.animations.length;l++){let c=this.animations[l];r.animations.push(s(e.animations,c))}}if(t){let l=o(e.geometries),c=o(e.materials),u=o(e.textures),d=o(e.images),p=o(e.shapes),h=o(e.skeletons),g=o(e.animations),_=o(e.nodes);l.length>0&&(n.geometries=l),c.length>0&&(n.materials=c),u.length>0&&(n.textures=u),d.length>0&&(n.images=d),p.length>0&&(n.shapes=p),h.length>0&&(n.skeletons=h),g.length>0&&(n.animations=g),_.length>0&&(n.nodes=_)}return n.object=r,n;function o(l){let c=[];for(let u in l){let d=l[u];delete d.metadata,c.push(d)}return c}a(o,"extractFromCache")}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Xt.DEFAULT_UP=new H(0,1,0);Xt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Xt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Zt=class extends Xt{static{a(this,"Group")}constructor(){super(),this.isGroup=!0,this.type="Group"}},Em={type:"move"},ir=class{static{a(this,"WebXRController")}constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Zt,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Zt,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Zt,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,s=null,o=null,l=this._targetRay,c=this._grip,u=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(u&&e.hand){o=!0;for(let y of e.hand.values()){let f=t.getJointPose(y,n),m=this._getHandJoint(u,y);f!==null&&(m.matrix.fromArray(f.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=f.radius),m.visible=f!==null}let d=u.joints["index-finger-tip"],p=u.joints["thumb-tip"],h=d.position.distanceTo(p.position),g=.02,_=.005;u.inputState.pinching&&h>g+_?(u.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!u.inputState.pinching&&h<=g-_&&(u.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,n),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));l!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,this.dispatchEvent(Em)))}return l!==null&&(l.visible=r!==null),c!==null&&(c.visible=s!==null),u!==null&&(u.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Zt;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},$h={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ti={h:0,s:0,l:0},Ps={h:0,s:0,l:0};function ol(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}a(ol,"hue2rgb");var ke=class{static{a(this,"Color")}constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=zt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,qe.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=qe.workingColorSpace){return this.r=e,this.g=t,this.b=n,qe.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=qe.workingColorSpace){if(e=mm(e,1),t=$e(t,0,1),n=$e(n,0,1),t===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+t):n+t-n*t,o=2*n-s;this.r=ol(o,s,e+1/3),this.g=ol(o,s,e),this.b=ol(o,s,e-1/3)}return qe.colorSpaceToWorking(this,r),this}setStyle(e,t=zt){function n(s){s!==void 0&&parseFloat(s)<1&&Pe("Color: Alpha component of "+e+" will be ignored.")}a(n,"handleAlpha");let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],l=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(l))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(l))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(l))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Pe("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Pe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=zt){let n=$h[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Pe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Hn(e.r),this.g=Hn(e.g),this.b=Hn(e.b),this}copyLinearToSRGB(e){return this.r=ji(e.r),this.g=ji(e.g),this.b=ji(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=zt){return qe.workingToColorSpace(Lt.copy(this),e),Math.round($e(Lt.r*255,0,255))*65536+Math.round($e(Lt.g*255,0,255))*256+Math.round($e(Lt.b*255,0,255))}getHexString(e=zt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=qe.workingColorSpace){qe.workingToColorSpace(Lt.copy(this),t);let n=Lt.r,r=Lt.g,s=Lt.b,o=Math.max(n,r,s),l=Math.min(n,r,s),c,u,d=(l+o)/2;if(l===o)c=0,u=0;else{let p=o-l;switch(u=d<=.5?p/(o+l):p/(2-o-l),o){case n:c=(r-s)/p+(r<s?6:0);break;case r:c=(s-n)/p+2;break;case s:c=(n-r)/p+4;break}c/=6}return e.h=c,e.s=u,e.l=d,e}getRGB(e,t=qe.workingColorSpace){return qe.workingToColorSpace(Lt.copy(this),t),e.r=Lt.r,e.g=Lt.g,e.b=Lt.b,e}getStyle(e=zt){qe.workingToColorSpace(Lt.copy(this),e);let t=Lt.r,n=Lt.g,r=Lt.b;return e!==zt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(ti),this.setHSL(ti.h+e,ti.s+t,ti.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ti),e.getHSL(Ps);let n=el(ti.h,Ps.h,t),r=el(ti.s,Ps.s,t),s=el(ti.l,Ps.l,t);return this.setHSL(n,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*n+s[6]*r,this.g=s[1]*t+s[4]*n+s[7]*r,this.b=s[2]*t+s[5]*n+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Lt=new ke;ke.NAMES=$h;var _n=class extends Xt{static{a(this,"Scene")}constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Xn,this.environmentIntensity=1,this.environmentRotation=new Xn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},pn=new H,kn=new H,al=new H,zn=new H,Vi=new H,Hi=new H,ju=new H,ll=new H,cl=new H,ul=new H,hl=new nt,dl=new nt,fl=new nt,si=class i{static{a(this,"Triangle")}constructor(e=new H,t=new H,n=new H){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),pn.subVectors(e,t),r.cross(pn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,n,r,s){pn.subVectors(r,t),kn.subVectors(n,t),al.subVectors(e,t);let o=pn.dot(pn),l=pn.dot(kn),c=pn.dot(al),u=kn.dot(kn),d=kn.dot(al),p=o*u-l*l;if(p===0)return s.set(0,0,0),null;let h=1/p,g=(u*c-l*d)*h,_=(o*d-l*c)*h;return s.set(1-g-_,_,g)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,zn)===null?!1:zn.x>=0&&zn.y>=0&&zn.x+zn.y<=1}static getInterpolation(e,t,n,r,s,o,l,c){return this.getBarycoord(e,t,n,r,zn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,zn.x),c.addScaledVector(o,zn.y),c.addScaledVector(l,zn.z),c)}static getInterpolatedAttribute(e,t,n,r,s,o){return hl.setScalar(0),dl.setScalar(0),fl.setScalar(0),hl.fromBufferAttribute(e,t),dl.fromBufferAttribute(e,n),fl.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(hl,s.x),o.addScaledVector(dl,s.y),o.addScaledVector(fl,s.z),o}static isFrontFacing(e,t,n,r){return pn.subVectors(n,t),kn.subVectors(e,t),pn.cross(kn).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return pn.subVectors(this.c,this.b),kn.subVectors(this.a,this.b),pn.cross(kn).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,s){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,s)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,s=this.c,o,l;Vi.subVectors(r,n),Hi.subVectors(s,n),ll.subVectors(e,n);let c=Vi.dot(ll),u=Hi.dot(ll);if(c<=0&&u<=0)return t.copy(n);cl.subVectors(e,r);let d=Vi.dot(cl),p=Hi.dot(cl);if(d>=0&&p<=d)return t.copy(r);let h=c*p-d*u;if(h<=0&&c>=0&&d<=0&&c-d>0)return o=c/(c-d),t.copy(n).addScaledVector(Vi,o);ul.subVectors(e,s);let g=Vi.dot(ul),_=Hi.dot(ul);if(_>=0&&g<=_)return t.copy(s);let y=g*u-c*_;if(y<=0&&u>=0&&_<=0)return l=u/(u-_),t.copy(n).addScaledVector(Hi,l);let f=d*_-g*p;if(f<=0&&p-d>=0&&g-_>=0)return ju.subVectors(s,r),l=(p-d)/(p-d+(g-_)),t.copy(r).addScaledVector(ju,l);let m=1/(f+y+h);return o=y*m,l=h*m,t.copy(n).addScaledVector(Vi,o).addScaledVector(Hi,l)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Pn=class{static{a(this,"Box3")}constructor(e=new H(1/0,1/0,1/0),t=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(mn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(mn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=mn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let s=n.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,l=s.count;o<l;o++)e.isMesh===!0?e.getVertexPosition(o,mn):mn.fromBufferAttribute(s,o),mn.applyMatrix4(e.matrixWorld),this.expandByPoint(mn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Is.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Is.copy(n.boundingBox)),Is.applyMatrix4(e.matrixWorld),this.union(Is)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,mn),mn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(br),Ls.subVectors(this.max,br),Wi.subVectors(e.a,br),Xi.subVectors(e.b,br),qi.subVectors(e.c,br),ni.subVectors(Xi,Wi),ii.subVectors(qi,Xi),wi.subVectors(Wi,qi);let t=[0,-ni.z,ni.y,0,-ii.z,ii.y,0,-wi.z,wi.y,ni.z,0,-ni.x,ii.z,0,-ii.x,wi.z,0,-wi.x,-ni.y,ni.x,0,-ii.y,ii.x,0,-wi.y,wi.x,0];return!pl(t,Wi,Xi,qi,Ls)||(t=[1,0,0,0,1,0,0,0,1],!pl(t,Wi,Xi,qi,Ls))?!1:(Ns.crossVectors(ni,ii),t=[Ns.x,Ns.y,Ns.z],pl(t,Wi,Xi,qi,Ls))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,mn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(mn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Gn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Gn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Gn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Gn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Gn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Gn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Gn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Gn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Gn),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Gn=[new H,new H,new H,new H,new H,new H,new H,new H],mn=new H,Is=new Pn,Wi=new H,Xi=new H,qi=new H,ni=new H,ii=new H,wi=new H,br=new H,Ls=new H,Ns=new H,Ei=new H;function pl(i,e,t,n,r){for(let s=0,o=i.length-3;s<=o;s+=3){Ei.fromArray(i,s);let l=r.x*Math.abs(Ei.x)+r.y*Math.abs(Ei.y)+r.z*Math.abs(Ei.z),c=e.dot(Ei),u=t.dot(Ei),d=n.dot(Ei);if(Math.max(-Math.max(c,u,d),Math.min(c,u,d))>l)return!1}return!0}a(pl,"satForAxes");var ft=new H,Ds=new Ge,Tm=0,Tt=class extends Rn{static{a(this,"BufferAttribute")}constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Tm++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Yl,this.updateRanges=[],this.gpuType=un,this.version=0,this._normalizationScale=e!==void 0?xa(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ds.fromBufferAttribute(this,t),Ds.applyMatrix3(e),this.setXY(t,Ds.x,Ds.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)ft.fromBufferAttribute(this,t),ft.applyMatrix3(e),this.setXYZ(t,ft.x,ft.y,ft.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)ft.fromBufferAttribute(this,t),ft.applyMatrix4(e),this.setXYZ(t,ft.x,ft.y,ft.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ft.fromBufferAttribute(this,t),ft.applyNormalMatrix(e),this.setXYZ(t,ft.x,ft.y,ft.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ft.fromBufferAttribute(this,t),ft.transformDirection(e),this.setXYZ(t,ft.x,ft.y,ft.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):qh(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Yh(e,this.array)}};var Or=class extends Tt{static{a(this,"Uint16BufferAttribute")}constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Br=class extends Tt{static{a(this,"Uint32BufferAttribute")}constructor(e,t,n){super(new Uint32Array(e),t,n)}};var ht=class extends Tt{static{a(this,"Float32BufferAttribute")}constructor(e,t,n){super(new Float32Array(e),t,n)}},Am=new Pn,wr=new H,ml=new H,oi=class{static{a(this,"Sphere")}constructor(e=new H,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Am.setFromPoints(e).getCenter(n);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,n.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;wr.subVectors(e,this.center);let t=wr.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector(wr,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ml.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(wr.copy(e.center).add(ml)),this.expandByPoint(wr.copy(e.center).sub(ml))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Rm=0,an=new Qe,gl=new Xt,Yi=new H,Jt=new Pn,Er=new Pn,St=new H,Ut=class i extends Rn{static{a(this,"BufferGeometry")}constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Rm++}),this.uuid=Ni(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(fm(e)?Br:Or)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new De().getNormalMatrix(e);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return an.makeRotationFromQuaternion(e),this.applyMatrix4(an),this}rotateX(e){return an.makeRotationX(e),this.applyMatrix4(an),this}rotateY(e){return an.makeRotationY(e),this.applyMatrix4(an),this}rotateZ(e){return an.makeRotationZ(e),this.applyMatrix4(an),this}translate(e,t,n){return an.makeTranslation(e,t,n),this.applyMatrix4(an),this}scale(e,t,n){return an.makeScale(e,t,n),this.applyMatrix4(an),this}lookAt(e){return gl.lookAt(e),gl.updateMatrix(),this.applyMatrix4(gl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Yi).negate(),this.translate(Yi.x,Yi.y,Yi.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ht(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Pe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Pn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ne("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let s=t[n];Jt.setFromBufferAttribute(s),this.morphTargetsRelative?(St.addVectors(this.boundingBox.min,Jt.min),this.boundingBox.expandByPoint(St),St.addVectors(this.boundingBox.max,Jt.max),this.boundingBox.expandByPoint(St)):(this.boundingBox.expandByPoint(Jt.min),this.boundingBox.expandByPoint(Jt.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ne('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new oi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ne("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(e){let n=this.boundingSphere.center;if(Jt.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let l=t[s];Er.setFromBufferAttribute(l),this.morphTargetsRelative?(St.addVectors(Jt.min,Er.min),Jt.expandByPoint(St),St.addVectors(Jt.max,Er.max),Jt.expandByPoint(St)):(Jt.expandByPoint(Er.min),Jt.expandByPoint(Er.max))}Jt.getCenter(n);let r=0;for(let s=0,o=e.count;s<o;s++)St.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(St));if(t)for(let s=0,o=t.length;s<o;s++){let l=t[s],c=this.morphTargetsRelative;for(let u=0,d=l.count;u<d;u++)St.fromBufferAttribute(l,u),c&&(Yi.fromBufferAttribute(e,u),St.add(Yi)),r=Math.max(r,n.distanceToSquared(St))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&Ne('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ne("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Tt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let l=[],c=[],u=new Uint8Array(n.count);for(let P=0;P<n.count;P++)l[P]=new H,c[P]=new H;let d=new H,p=new H,h=new H,g=new Ge,_=new Ge,y=new Ge,f=new H,m=new H;function S(P,C,D){u[P]=u[C]=u[D]=1,d.fromBufferAttribute(n,P),p.fromBufferAttribute(n,C),h.fromBufferAttribute(n,D),g.fromBufferAttribute(s,P),_.fromBufferAttribute(s,C),y.fromBufferAttribute(s,D),p.sub(d),h.sub(d),_.sub(g),y.sub(g);let B=1/(_.x*y.y-y.x*_.y);isFinite(B)&&(f.copy(p).multiplyScalar(y.y).addScaledVector(h,-_.y).multiplyScalar(B),m.copy(h).multiplyScalar(_.x).addScaledVector(p,-y.x).multiplyScalar(B),l[P].add(f),l[C].add(f),l[D].add(f),c[P].add(m),c[C].add(m),c[D].add(m))}a(S,"handleTriangle");let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let P=0,C=A.length;P<C;++P){let D=A[P],B=D.start,X=D.count;for(let L=B,q=B+X;L<q;L+=3)S(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let v=new H,M=new H,T=new H,x=new H;function w(P){T.fromBufferAttribute(r,P),x.copy(T);let C=l[P];v.copy(C),v.sub(T.multiplyScalar(T.dot(C))).normalize(),M.crossVectors(x,C);let B=M.dot(c[P])<0?-1:1;o.setXYZW(P,v.x,v.y,v.z,B)}a(w,"handleVertex");for(let P=0,C=n.count;P<C;++P)u[P]&&w(P);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Tt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let h=0,g=n.count;h<g;h++)n.setXYZ(h,0,0,0);let r=new H,s=new H,o=new H,l=new H,c=new H,u=new H,d=new H,p=new H;if(e)for(let h=0,g=e.count;h<g;h+=3){let _=e.getX(h+0),y=e.getX(h+1),f=e.getX(h+2);r.fromBufferAttribute(t,_),s.fromBufferAttribute(t,y),o.fromBufferAttribute(t,f),d.subVectors(o,s),p.subVectors(r,s),d.cross(p),l.fromBufferAttribute(n,_),c.fromBufferAttribute(n,y),u.fromBufferAttribute(n,f),l.add(d),c.add(d),u.add(d),n.setXYZ(_,l.x,l.y,l.z),n.setXYZ(y,c.x,c.y,c.z),n.setXYZ(f,u.x,u.y,u.z)}else for(let h=0,g=t.count;h<g;h+=3)r.fromBufferAttribute(t,h+0),s.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),d.subVectors(o,s),p.subVectors(r,s),d.cross(p),n.setXYZ(h+0,d.x,d.y,d.z),n.setXYZ(h+1,d.x,d.y,d.z),n.setXYZ(h+2,d.x,d.y,d.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)St.fromBufferAttribute(e,t),St.normalize(),e.setXYZ(t,St.x,St.y,St.z)}toNonIndexed(){function e(l,c){let u=l.array,d=l.itemSize,p=l.normalized,h=new u.constructor(c.length*d),g=0,_=0;for(let y=0,f=c.length;y<f;y++){l.isInterleavedBufferAttribute?g=c[y]*l.data.stride+l.offset:g=c[y]*d;for(let m=0;m<d;m++)h[_++]=u[g++]}return new Tt(h,d,p)}if(a(e,"convertBufferAttribute"),this.index===null)return Pe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let l in r){let c=r[l],u=e(c,n);t.setAttribute(l,u)}let s=this.morphAttributes;for(let l in s){let c=[],u=s[l];for(let d=0,p=u.length;d<p;d++){let h=u[d],g=e(h,n);c.push(g)}t.morphAttributes[l]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let l=0,c=o.length;l<c;l++){let u=o[l];t.addGroup(u.start,u.count,u.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let u in c)c[u]!==void 0&&(e[u]=c[u]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let u=n[c];e.data.attributes[c]=u.toJSON(e.data)}let r={},s=!1;for(let c in this.morphAttributes){let u=this.morphAttributes[c],d=[];for(let p=0,h=u.length;p<h;p++){let g=u[p];d.push(g.toJSON(e.data))}d.length>0&&(r[c]=d,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let l=this.boundingSphere;return l!==null&&(e.data.boundingSphere=l.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let u in r){let d=r[u];this.setAttribute(u,d.clone(t))}let s=e.morphAttributes;for(let u in s){let d=[],p=s[u];for(let h=0,g=p.length;h<g;h++)d.push(p[h].clone(t));this.morphAttributes[u]=d}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let u=0,d=o.length;u<d;u++){let p=o[u];this.addGroup(p.start,p.count,p.materialIndex)}let l=e.boundingBox;l!==null&&(this.boundingBox=l.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},uo=class{static{a(this,"InterleavedBuffer")}constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Yl,this.updateRanges=[],this.version=0,this.uuid=Ni()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[n+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Qu(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Qu(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Qu(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ni()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}a(Qu,"getArrayKey");var kt=new H,kr=class i{static{a(this,"InterleavedBufferAttribute")}constructor(e,t,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=r,this._normalizationScale=e!==void 0?xa(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)kt.fromBufferAttribute(this,t),kt.applyMatrix4(e),this.setXYZ(t,kt.x,kt.y,kt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)kt.fromBufferAttribute(this,t),kt.applyNormalMatrix(e),this.setXYZ(t,kt.x,kt.y,kt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)kt.fromBufferAttribute(this,t),kt.transformDirection(e),this.setXYZ(t,kt.x,kt.y,kt.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){Dr("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new Tt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Dr("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):qh(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Yh(e,this.data.array)}},_l=new H,Cm=new H,Pm=new De,gn=class{static{a(this,"Plane")}constructor(e=new H(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=_l.subVectors(n,t).cross(Cm.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(_l),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Pm.getNormalMatrix(e),r=this.coplanarPoint(_l).applyMatrix4(e),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Im=0,ai=class extends Rn{static{a(this,"Material")}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Im++}),this.uuid=Ni(),this.name="",this.type="Material",this.blending=lr,this.side=hi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ns,this.blendDst=di,this.blendEquation=Pi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ke(0,0,0),this.blendAlpha=0,this.depthFunc=Qi,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Uh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Zs,this.stencilZFail=Zs,this.stencilZPass=Zs,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Pe(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Pe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let o=[];for(let l in s){let c=s[l];delete c.metadata,o.push(c)}return o}if(a(r,"extractFromCache"),t){let s=r(e.textures),o=r(e.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ke().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new gn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ge().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ge().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=t[s].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Vn=new H,xl=new H,Us=new H,Fs=new H,ho=class{static{a(this,"Ray")}constructor(e=new H,t=new H(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Vn)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Vn.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Vn.copy(this.origin).addScaledVector(this.direction,t),Vn.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){xl.copy(e).add(t).multiplyScalar(.5),Us.copy(t).sub(e).normalize(),Fs.copy(this.origin).sub(xl);let s=e.distanceTo(t)*.5,o=-this.direction.dot(Us),l=Fs.dot(this.direction),c=-Fs.dot(Us),u=Fs.lengthSq(),d=Math.abs(1-o*o),p,h,g,_;if(d>0)if(p=o*c-l,h=o*l-c,_=s*d,p>=0)if(h>=-_)if(h<=_){let y=1/d;p*=y,h*=y,g=p*(p+o*h+2*l)+h*(o*p+h+2*c)+u}else h=s,p=Math.max(0,-(o*h+l)),g=-p*p+h*(h+2*c)+u;else h=-s,p=Math.max(0,-(o*h+l)),g=-p*p+h*(h+2*c)+u;else h<=-_?(p=Math.max(0,-(-o*s+l)),h=p>0?-s:Math.min(Math.max(-s,-c),s),g=-p*p+h*(h+2*c)+u):h<=_?(p=0,h=Math.min(Math.max(-s,-c),s),g=h*(h+2*c)+u):(p=Math.max(0,-(o*s+l)),h=p>0?s:Math.min(Math.max(-s,-c),s),g=-p*p+h*(h+2*c)+u);else h=o>0?-s:s,p=Math.max(0,-(o*h+l)),g=-p*p+h*(h+2*c)+u;return n&&n.copy(this.origin).addScaledVector(this.direction,p),r&&r.copy(xl).addScaledVector(Us,h),g}intersectSphere(e,t){if(e.radius<0)return null;Vn.subVectors(e.center,this.origin);let n=Vn.dot(this.direction),r=Vn.dot(Vn)-n*n,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),l=n-o,c=n+o;return c<0?null:l<0?this.at(c,t):this.at(l,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,s,o,l,c,u=1/this.direction.x,d=1/this.direction.y,p=1/this.direction.z,h=this.origin;return u>=0?(n=(e.min.x-h.x)*u,r=(e.max.x-h.x)*u):(n=(e.max.x-h.x)*u,r=(e.min.x-h.x)*u),d>=0?(s=(e.min.y-h.y)*d,o=(e.max.y-h.y)*d):(s=(e.max.y-h.y)*d,o=(e.min.y-h.y)*d),n>o||s>r||((s>n||isNaN(n))&&(n=s),(o<r||isNaN(r))&&(r=o),p>=0?(l=(e.min.z-h.z)*p,c=(e.max.z-h.z)*p):(l=(e.max.z-h.z)*p,c=(e.min.z-h.z)*p),n>c||l>r)||((l>n||n!==n)&&(n=l),(c<r||r!==r)&&(r=c),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,Vn)!==null}intersectTriangle(e,t,n,r,s){let o=this.origin,l=this.direction,c=l.x,u=l.y,d=l.z,p=e.x-o.x,h=e.y-o.y,g=e.z-o.z,_=t.x-o.x,y=t.y-o.y,f=t.z-o.z,m=n.x-o.x,S=n.y-o.y,A=n.z-o.z,v=Math.abs(c),M=Math.abs(u),T=Math.abs(d),x,w,P,C,D,B,X,L,q,O,z,te;if(v>=M&&v>=T?(P=c,B=p,q=_,te=m,c>=0?(x=u,w=d,C=h,D=g,X=y,L=f,O=S,z=A):(x=d,w=u,C=g,D=h,X=f,L=y,O=A,z=S)):M>=T?(P=u,B=h,q=y,te=S,u>=0?(x=d,w=c,C=g,D=p,X=f,L=_,O=A,z=m):(x=c,w=d,C=p,D=g,X=_,L=f,O=m,z=A)):(P=d,B=g,q=f,te=A,d>=0?(x=c,w=u,C=p,D=h,X=_,L=y,O=m,z=S):(x=u,w=c,C=h,D=p,X=y,L=_,O=S,z=m)),P===0)return null;let Y=x/P,ee=w/P,ne=1/P,Me=C-Y*B,Ie=D-ee*B,F=X-Y*q,J=L-ee*q,ie=O-Y*te,ve=z-ee*te,ae=ie*J-ve*F,Le=Me*ve-Ie*ie,rt=F*Ie-J*Me;if(r){if(ae<0||Le<0||rt<0)return null}else if((ae<0||Le<0||rt<0)&&(ae>0||Le>0||rt>0))return null;let Te=ae+Le+rt;if(Te===0)return null;let Ve=ne*(ae*B+Le*q+rt*te);return(Te>0?Ve<0:Ve>0)?null:this.at(Ve/Te,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},rr=class extends ai{static{a(this,"MeshBasicMaterial")}constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Xn,this.combine=Po,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},eh=new Qe,Ti=new ho,Os=new oi,th=new H,Bs=new H,ks=new H,zs=new H,yl=new H,Gs=new H,nh=new H,Vs=new H,ut=class extends Xt{static{a(this,"Mesh")}constructor(e=new Ut,t=new rr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let l=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[l]=s}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let l=this.morphTargetInfluences;if(s&&l){Gs.set(0,0,0);for(let c=0,u=s.length;c<u;c++){let d=l[c],p=s[c];d!==0&&(yl.fromBufferAttribute(p,e),o?Gs.addScaledVector(yl,d):Gs.addScaledVector(yl.sub(t),d))}t.add(Gs)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Os.copy(n.boundingSphere),Os.applyMatrix4(s),Ti.copy(e.ray).recast(e.near),!(Os.containsPoint(Ti.origin)===!1&&(Ti.intersectSphere(Os,th)===null||Ti.origin.distanceToSquared(th)>(e.far-e.near)**2))&&(eh.copy(s).invert(),Ti.copy(e.ray).applyMatrix4(eh),!(n.boundingBox!==null&&Ti.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ti)))}_computeIntersections(e,t,n){let r,s=this.geometry,o=this.material,l=s.index,c=s.attributes.position,u=s.attributes.uv,d=s.attributes.uv1,p=s.attributes.normal,h=s.groups,g=s.drawRange;if(l!==null)if(Array.isArray(o))for(let _=0,y=h.length;_<y;_++){let f=h[_],m=o[f.materialIndex],S=Math.max(f.start,g.start),A=Math.min(l.count,Math.min(f.start+f.count,g.start+g.count));for(let v=S,M=A;v<M;v+=3){let T=l.getX(v),x=l.getX(v+1),w=l.getX(v+2);r=Hs(this,m,e,n,u,d,p,T,x,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=f.materialIndex,t.push(r))}}else{let _=Math.max(0,g.start),y=Math.min(l.count,g.start+g.count);for(let f=_,m=y;f<m;f+=3){let S=l.getX(f),A=l.getX(f+1),v=l.getX(f+2);r=Hs(this,o,e,n,u,d,p,S,A,v),r&&(r.faceIndex=Math.floor(f/3),t.push(r))}}else if(c!==void 0)if(Array.isArray(o))for(let _=0,y=h.length;_<y;_++){let f=h[_],m=o[f.materialIndex],S=Math.max(f.start,g.start),A=Math.min(c.count,Math.min(f.start+f.count,g.start+g.count));for(let v=S,M=A;v<M;v+=3){let T=v,x=v+1,w=v+2;r=Hs(this,m,e,n,u,d,p,T,x,w),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=f.materialIndex,t.push(r))}}else{let _=Math.max(0,g.start),y=Math.min(c.count,g.start+g.count);for(let f=_,m=y;f<m;f+=3){let S=f,A=f+1,v=f+2;r=Hs(this,o,e,n,u,d,p,S,A,v),r&&(r.faceIndex=Math.floor(f/3),t.push(r))}}}};function Lm(i,e,t,n,r,s,o,l){let c;if(e.side===Vt?c=n.intersectTriangle(o,s,r,!0,l):c=n.intersectTriangle(r,s,o,e.side===hi,l),c===null)return null;Vs.copy(l),Vs.applyMatrix4(i.matrixWorld);let u=t.ray.origin.distanceTo(Vs);return u<t.near||u>t.far?null:{distance:u,point:Vs.clone(),object:i}}a(Lm,"checkIntersection$1");function Hs(i,e,t,n,r,s,o,l,c,u){i.getVertexPosition(l,Bs),i.getVertexPosition(c,ks),i.getVertexPosition(u,zs);let d=Lm(i,e,t,n,Bs,ks,zs,nh);if(d){let p=new H;si.getBarycoord(nh,Bs,ks,zs,p),r&&(d.uv=si.getInterpolatedAttribute(r,l,c,u,p,new Ge)),s&&(d.uv1=si.getInterpolatedAttribute(s,l,c,u,p,new Ge)),o&&(d.normal=si.getInterpolatedAttribute(o,l,c,u,p,new H),d.normal.dot(n.direction)>0&&d.normal.multiplyScalar(-1));let h={a:l,b:c,c:u,normal:new H,materialIndex:0};si.getNormal(Bs,ks,zs,h.normal),d.face=h,d.barycoord=p}return d}a(Hs,"checkGeometryIntersection");var zr=class extends Nt{static{a(this,"DataTexture")}constructor(e=null,t=1,n=1,r,s,o,l,c,u=Mt,d=Mt,p,h){super(null,o,l,c,u,d,r,s,p,h),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Gr=class extends Tt{static{a(this,"InstancedBufferAttribute")}constructor(e,t,n,r=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},$i=new Qe,ih=new Qe,Ws=[],rh=new Pn,Nm=new Qe,Tr=new ut,Ar=new oi,Vr=class extends ut{static{a(this,"InstancedMesh")}constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Gr(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<n;r++)this.setMatrixAt(r,Nm)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Pn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,$i),rh.copy(e.boundingBox).applyMatrix4($i),this.boundingBox.union(rh)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new oi),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,$i),Ar.copy(e.boundingSphere).applyMatrix4($i),this.boundingSphere.union(Ar)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=n.length+1,o=e*s+1;for(let l=0;l<n.length;l++)n[l]=r[o+l]}raycast(e,t){let n=this.matrixWorld,r=this.count;if(Tr.geometry=this.geometry,Tr.material=this.material,Tr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ar.copy(this.boundingSphere),Ar.applyMatrix4(n),e.ray.intersectsSphere(Ar)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,$i),ih.multiplyMatrices(n,$i),Tr.matrixWorld=ih,Tr.raycast(e,Ws);for(let o=0,l=Ws.length;o<l;o++){let c=Ws[o];c.instanceId=s,c.object=this,t.push(c)}Ws.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Gr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,r=n.length+1;this.morphTexture===null&&(this.morphTexture=new zr(new Float32Array(r*this.count),r,this.count,Oo,un));let s=this.morphTexture.source.data.data,o=0;for(let u=0;u<n.length;u++)o+=n[u];let l=this.geometry.morphTargetsRelative?1:1-o,c=r*e;return s[c]=l,s.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ai=new oi,Dm=new Ge(.5,.5),Xs=new H,Ri=class{static{a(this,"Frustum")}constructor(e=new gn,t=new gn,n=new gn,r=new gn,s=new gn,o=new gn){this.planes=[e,t,n,r,s,o]}set(e,t,n,r,s,o){let l=this.planes;return l[0].copy(e),l[1].copy(t),l[2].copy(n),l[3].copy(r),l[4].copy(s),l[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=ln,n=!1){let r=this.planes,s=e.elements,o=s[0],l=s[1],c=s[2],u=s[3],d=s[4],p=s[5],h=s[6],g=s[7],_=s[8],y=s[9],f=s[10],m=s[11],S=s[12],A=s[13],v=s[14],M=s[15];if(r[0].setComponents(u-o,g-d,m-_,M-S).normalize(),r[1].setComponents(u+o,g+d,m+_,M+S).normalize(),r[2].setComponents(u+l,g+p,m+y,M+A).normalize(),r[3].setComponents(u-l,g-p,m-y,M-A).normalize(),n)r[4].setComponents(c,h,f,v).normalize(),r[5].setComponents(u-c,g-h,m-f,M-v).normalize();else if(r[4].setComponents(u-c,g-h,m-f,M-v).normalize(),t===ln)r[5].setComponents(u+c,g+h,m+f,M+v).normalize();else if(t===Lr)r[5].setComponents(c,h,f,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ai.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ai.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ai)}intersectsSprite(e){Ai.center.set(0,0,0);let t=Dm.distanceTo(e.center);return Ai.radius=.7071067811865476+t,Ai.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ai)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(Xs.x=r.normal.x>0?e.max.x:e.min.x,Xs.y=r.normal.y>0?e.max.y:e.min.y,Xs.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Xs)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},sh=new Qe,fo=class i{static{a(this,"FrustumArray")}constructor(){this.coordinateSystem=ln,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];sh.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new Ri),n[r].setFromProjectionMatrix(sh,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Ri),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ci=class extends Nt{static{a(this,"CubeTexture")}constructor(e=[],t=Ii,n,r,s,o,l,c,u,d){super(e,t,n,r,s,o,l,c,u,d),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var xn=class extends Nt{static{a(this,"DepthTexture")}constructor(e,t,n=Qt,r,s,o,l=Mt,c=Mt,u,d=Wn,p=1){if(d!==Wn&&d!==Yn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:p};super(h,r,s,o,l,c,d,n,u),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new nr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Hr=class extends xn{static{a(this,"CubeDepthTexture")}constructor(e,t=Qt,n=Ii,r,s,o=Mt,l=Mt,c,u=Wn){let d={width:e,height:e,depth:1},p=[d,d,d,d,d,d];super(e,e,t,n,r,s,o,l,c,u),this.image=p,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Wr=class extends Nt{static{a(this,"ExternalTexture")}constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},sr=class i extends Ut{static{a(this,"BoxGeometry")}constructor(e=1,t=1,n=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:s,depthSegments:o};let l=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let c=[],u=[],d=[],p=[],h=0,g=0;_("z","y","x",-1,-1,n,t,e,o,s,0),_("z","y","x",1,-1,n,t,-e,o,s,1),_("x","z","y",1,1,e,n,t,r,o,2),_("x","z","y",1,-1,e,n,-t,r,o,3),_("x","y","z",1,-1,e,t,n,r,s,4),_("x","y","z",-1,-1,e,t,-n,r,s,5),this.setIndex(c),this.setAttribute("position",new ht(u,3)),this.setAttribute("normal",new ht(d,3)),this.setAttribute("uv",new ht(p,2));function _(y,f,m,S,A,v,M,T,x,w,P){let C=v/x,D=M/w,B=v/2,X=M/2,L=T/2,q=x+1,O=w+1,z=0,te=0,Y=new H;for(let ee=0;ee<O;ee++){let ne=ee*D-X;for(let Me=0;Me<q;Me++){let Ie=Me*C-B;Y[y]=Ie*S,Y[f]=ne*A,Y[m]=L,u.push(Y.x,Y.y,Y.z),Y[y]=0,Y[f]=0,Y[m]=T>0?1:-1,d.push(Y.x,Y.y,Y.z),p.push(Me/x),p.push(1-ee/w),z+=1}}for(let ee=0;ee<w;ee++)for(let ne=0;ne<x;ne++){let Me=h+ne+q*ee,Ie=h+ne+q*(ee+1),F=h+(ne+1)+q*(ee+1),J=h+(ne+1)+q*ee;c.push(Me,Ie,J),c.push(Ie,F,J),te+=6}l.addGroup(g,te,P),g+=te,h+=z}a(_,"buildPlane")}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}},Xr=class i extends Ut{static{a(this,"CapsuleGeometry")}constructor(e=1,t=1,n=4,r=8,s=1){super(),this.type="CapsuleGeometry",this.parameters={radius:e,height:t,capSegments:n,radialSegments:r,heightSegments:s},t=Math.max(0,t),n=Math.max(1,Math.floor(n)),r=Math.max(3,Math.floor(r)),s=Math.max(1,Math.floor(s));let o=[],l=[],c=[],u=[],d=t/2,p=Math.PI/2*e,h=t,g=2*p+h,_=n*2+s,y=r+1,f=new H,m=new H;for(let S=0;S<=_;S++){let A=0,v=0,M=0,T=0;if(S<=n){let P=S/n,C=P*Math.PI/2;v=-d-e*Math.cos(C),M=e*Math.sin(C),T=-e*Math.cos(C),A=P*p}else if(S<=n+s){let P=(S-n)/s;v=-d+P*t,M=e,T=0,A=p+P*h}else{let P=(S-n-s)/n,C=P*Math.PI/2;v=d+e*Math.sin(C),M=e*Math.cos(C),T=e*Math.sin(C),A=p+h+P*p}let x=Math.max(0,Math.min(1,A/g)),w=0;S===0?w=.5/r:S===_&&(w=-.5/r);for(let P=0;P<=r;P++){let C=P/r,D=C*Math.PI*2,B=Math.sin(D),X=Math.cos(D);m.x=-M*X,m.y=v,m.z=M*B,l.push(m.x,m.y,m.z),f.set(-M*X,T,M*B),f.normalize(),c.push(f.x,f.y,f.z),u.push(C+w,x)}if(S>0){let P=(S-1)*y;for(let C=0;C<r;C++){let D=P+C,B=P+C+1,X=S*y+C,L=S*y+C+1;o.push(D,B,X),o.push(B,L,X)}}}this.setIndex(o),this.setAttribute("position",new ht(l,3)),this.setAttribute("normal",new ht(c,3)),this.setAttribute("uv",new ht(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.height,e.capSegments,e.radialSegments,e.heightSegments)}};var po=class i extends Ut{static{a(this,"PolyhedronGeometry")}constructor(e=[],t=[],n=1,r=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:e,indices:t,radius:n,detail:r};let s=[],o=[];l(r),u(n),d(),this.setAttribute("position",new ht(s,3)),this.setAttribute("normal",new ht(s.slice(),3)),this.setAttribute("uv",new ht(o,2)),r===0?this.computeVertexNormals():this.normalizeNormals();function l(S){let A=new H,v=new H,M=new H;for(let T=0;T<t.length;T+=3)g(t[T+0],A),g(t[T+1],v),g(t[T+2],M),c(A,v,M,S)}a(l,"subdivide");function c(S,A,v,M){let T=M+1,x=[];for(let w=0;w<=T;w++){x[w]=[];let P=S.clone().lerp(v,w/T),C=A.clone().lerp(v,w/T),D=T-w;for(let B=0;B<=D;B++)B===0&&w===T?x[w][B]=P:x[w][B]=P.clone().lerp(C,B/D)}for(let w=0;w<T;w++)for(let P=0;P<2*(T-w)-1;P++){let C=Math.floor(P/2);P%2===0?(h(x[w][C+1]),h(x[w+1][C]),h(x[w][C])):(h(x[w][C+1]),h(x[w+1][C+1]),h(x[w+1][C]))}}a(c,"subdivideFace");function u(S){let A=new H;for(let v=0;v<s.length;v+=3)A.x=s[v+0],A.y=s[v+1],A.z=s[v+2],A.normalize().multiplyScalar(S),s[v+0]=A.x,s[v+1]=A.y,s[v+2]=A.z}a(u,"applyRadius");function d(){let S=new H;for(let A=0;A<s.length;A+=3){S.x=s[A+0],S.y=s[A+1],S.z=s[A+2];let v=f(S)/2/Math.PI+.5,M=m(S)/Math.PI+.5;o.push(v,1-M)}_(),p()}a(d,"generateUVs");function p(){for(let S=0;S<o.length;S+=6){let A=o[S+0],v=o[S+2],M=o[S+4],T=Math.max(A,v,M),x=Math.min(A,v,M);T>.9&&x<.1&&(A<.2&&(o[S+0]+=1),v<.2&&(o[S+2]+=1),M<.2&&(o[S+4]+=1))}}a(p,"correctSeam");function h(S){s.push(S.x,S.y,S.z)}a(h,"pushVertex");function g(S,A){let v=S*3;A.x=e[v+0],A.y=e[v+1],A.z=e[v+2]}a(g,"getVertexByIndex");function _(){let S=new H,A=new H,v=new H,M=new H,T=new Ge,x=new Ge,w=new Ge;for(let P=0,C=0;P<s.length;P+=9,C+=6){S.set(s[P+0],s[P+1],s[P+2]),A.set(s[P+3],s[P+4],s[P+5]),v.set(s[P+6],s[P+7],s[P+8]),T.set(o[C+0],o[C+1]),x.set(o[C+2],o[C+3]),w.set(o[C+4],o[C+5]),M.copy(S).add(A).add(v).divideScalar(3);let D=f(M);y(T,C+0,S,D),y(x,C+2,A,D),y(w,C+4,v,D)}}a(_,"correctUVs");function y(S,A,v,M){M<0&&S.x===1&&(o[A]=S.x-1),v.x===0&&v.z===0&&(o[A]=M/2/Math.PI+.5)}a(y,"correctUV");function f(S){return Math.atan2(S.z,-S.x)}a(f,"azimuth");function m(S){return Math.atan2(-S.y,Math.sqrt(S.x*S.x+S.z*S.z))}a(m,"inclination")}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.vertices,e.indices,e.radius,e.detail)}};var qr=class i extends po{static{a(this,"IcosahedronGeometry")}constructor(e=1,t=0){let n=(1+Math.sqrt(5))/2,r=[-1,n,0,1,n,0,-1,-n,0,1,-n,0,0,-1,n,0,1,n,0,-1,-n,0,1,-n,n,0,-1,n,0,1,-n,0,-1,-n,0,1],s=[0,11,5,0,5,1,0,1,7,0,7,10,0,10,11,1,5,9,5,11,4,11,10,2,10,7,6,7,1,8,3,9,4,3,4,2,3,2,6,3,6,8,3,8,9,4,9,5,2,4,11,6,2,10,8,6,7,9,8,1];super(r,s,e,t),this.type="IcosahedronGeometry",this.parameters={radius:e,detail:t}}static fromJSON(e){return new i(e.radius,e.detail)}};var Yr=class i extends Ut{static{a(this,"PlaneGeometry")}constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let s=e/2,o=t/2,l=Math.floor(n),c=Math.floor(r),u=l+1,d=c+1,p=e/l,h=t/c,g=[],_=[],y=[],f=[];for(let m=0;m<d;m++){let S=m*h-o;for(let A=0;A<u;A++){let v=A*p-s;_.push(v,-S,0),y.push(0,0,1),f.push(A/l),f.push(1-m/c)}}for(let m=0;m<c;m++)for(let S=0;S<l;S++){let A=S+u*m,v=S+u*(m+1),M=S+1+u*(m+1),T=S+1+u*m;g.push(A,v,T),g.push(v,M,T)}this.setIndex(g),this.setAttribute("position",new ht(_,3)),this.setAttribute("normal",new ht(y,3)),this.setAttribute("uv",new ht(f,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}},$r=class i extends Ut{static{a(this,"RingGeometry")}constructor(e=.5,t=1,n=32,r=1,s=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:e,outerRadius:t,thetaSegments:n,phiSegments:r,thetaStart:s,thetaLength:o},n=Math.max(3,n),r=Math.max(1,r);let l=[],c=[],u=[],d=[],p=e,h=(t-e)/r,g=new H,_=new Ge;for(let y=0;y<=r;y++){for(let f=0;f<=n;f++){let m=s+f/n*o;g.x=p*Math.cos(m),g.y=p*Math.sin(m),c.push(g.x,g.y,g.z),u.push(0,0,1),_.x=(g.x/t+1)/2,_.y=(g.y/t+1)/2,d.push(_.x,_.y)}p+=h}for(let y=0;y<r;y++){let f=y*(n+1);for(let m=0;m<n;m++){let S=m+f,A=S,v=S+n+1,M=S+n+2,T=S+1;l.push(A,v,T),l.push(v,M,T)}}this.setIndex(l),this.setAttribute("position",new ht(c,3)),this.setAttribute("normal",new ht(u,3)),this.setAttribute("uv",new ht(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.innerRadius,e.outerRadius,e.thetaSegments,e.phiSegments,e.thetaStart,e.thetaLength)}};function Di(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(oh(r))r.isRenderTargetTexture?(Pe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(oh(r[0])){let s=[];for(let o=0,l=r.length;o<l;o++)s[o]=r[o].clone();e[t][n]=s}else e[t][n]=r.slice();else e[t][n]=r}}return e}a(Di,"cloneUniforms");function Ft(i){let e={};for(let t=0;t<i.length;t++){let n=Di(i[t]);for(let r in n)e[r]=n[r]}return e}a(Ft,"mergeUniforms");function oh(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}a(oh,"isThreeObject");function Um(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}a(Um,"cloneUniformsGroups");function $l(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:qe.workingColorSpace}a($l,"getUnlitUniformColorSpace");var Jh={clone:Di,merge:Ft},Fm=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Om=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,In=class extends ai{static{a(this,"ShaderMaterial")}constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Fm,this.fragmentShader=Om,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Di(e.uniforms),this.uniformsGroups=Um(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new ke().setHex(r.value);break;case"v2":this.uniforms[n].value=new Ge().fromArray(r.value);break;case"v3":this.uniforms[n].value=new H().fromArray(r.value);break;case"v4":this.uniforms[n].value=new nt().fromArray(r.value);break;case"m3":this.uniforms[n].value=new De().fromArray(r.value);break;case"m4":this.uniforms[n].value=new Qe().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},yn=class extends In{static{a(this,"RawShaderMaterial")}constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Jr=class extends ai{static{a(this,"MeshLambertMaterial")}constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ke(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=_a,this.normalScale=new Ge(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Xn,this.combine=Po,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},mo=class extends ai{static{a(this,"MeshDepthMaterial")}constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Nh,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},go=class extends ai{static{a(this,"MeshDistanceMaterial")}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ji(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}a(Ji,"convertArray");function qs(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}a(qs,"hasTangents");var li=class{static{a(this,"Interpolant")}constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],s=t[n-1];n:{e:{let o;t:{i:if(!(e<r)){for(let l=n+2;;){if(r===void 0){if(e<s)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===l)break;if(s=r,r=t[++n],e<r)break e}o=t.length;break t}if(!(e>=s)){let l=t[1];e<l&&(n=2,s=l);for(let c=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(r=s,s=t[--n-1],e>=s)break e}o=n,n=0;break t}break n}for(;n<o;){let l=n+o>>>1;e<t[l]?o=l:n=l+1}if(r=t[n],s=t[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=n[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},_o=class extends li{static{a(this,"CubicInterpolant")}constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Sl,endingEnd:Sl}}intervalChanged_(e,t,n){let r=this.parameterPositions,s=e-2,o=e+1,l=r[s],c=r[o];if(l===void 0)switch(this.getSettings_().endingStart){case Ml:s=e,l=2*t-n;break;case bl:s=r.length-2,l=t+r[s]-r[s+1];break;default:s=e,l=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Ml:o=e,c=2*n-t;break;case bl:o=1,c=n+r[1]-r[0];break;default:o=e-1,c=t}let u=(n-t)*.5,d=this.valueSize;this._weightPrev=u/(t-l),this._weightNext=u/(c-n),this._offsetPrev=s*d,this._offsetNext=o*d}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=e*l,u=c-l,d=this._offsetPrev,p=this._offsetNext,h=this._weightPrev,g=this._weightNext,_=(n-t)/(r-t),y=_*_,f=y*_,m=-h*f+2*h*y-h*_,S=(1+h)*f+(-1.5-2*h)*y+(-.5+h)*_+1,A=(-1-g)*f+(1.5+g)*y+.5*_,v=g*f-g*y;for(let M=0;M!==l;++M)s[M]=m*o[d+M]+S*o[u+M]+A*o[c+M]+v*o[p+M];return s}},xo=class extends li{static{a(this,"LinearInterpolant")}constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=e*l,u=c-l,d=(n-t)/(r-t),p=1-d;for(let h=0;h!==l;++h)s[h]=o[u+h]*p+o[c+h]*d;return s}},yo=class extends li{static{a(this,"DiscreteInterpolant")}constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},vo=class extends li{static{a(this,"BezierInterpolant")}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=e*l,u=c-l,d=this.inTangents,p=this.outTangents;if(!d||!p){let _=(n-t)/(r-t),y=1-_;for(let f=0;f!==l;++f)s[f]=o[u+f]*y+o[c+f]*_;return s}let h=l*2,g=e-1;for(let _=0;_!==l;++_){let y=o[u+_],f=o[c+_],m=g*h+_*2,S=p[m],A=p[m+1],v=e*h+_*2,M=d[v],T=d[v+1],x=km(n,t,S,M,r);s[_]=Zh(x,y,A,T,f)}return s}};function Zh(i,e,t,n,r){let s=1-i;return s*s*s*e+3*s*s*i*t+3*s*i*i*n+i*i*i*r}a(Zh,"cubicBezier");function Bm(i,e,t,n,r){let s=1-i;return 3*s*s*(t-e)+6*s*i*(n-t)+3*i*i*(r-n)}a(Bm,"cubicBezierSlope");function km(i,e,t,n,r){let s=(i-e)/(r-e);for(let o=0;o<8;o++){let l=Zh(s,e,t,n,r)-i;if(Math.abs(l)<1e-10)break;let c=Bm(s,e,t,n,r);if(Math.abs(c)<1e-10)break;s=Math.max(0,Math.min(1,s-l/c))}return s}a(km,"solveBezierParameter");var Kt=class{static{a(this,"KeyframeTrack")}constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ji(t,this.TimeBufferType),this.values=Ji(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ji(e.times,Array),values:Ji(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),qs(e.settings)&&(n.settings={inTangents:Ji(e.settings.inTangents,Array),outTangents:Ji(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new yo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new xo(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new _o(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new vo(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Cr:t=this.InterpolantFactoryMethodDiscrete;break;case so:t=this.InterpolantFactoryMethodLinear;break;case Js:t=this.InterpolantFactoryMethodSmooth;break;case vl:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Pe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Cr;case this.InterpolantFactoryMethodLinear:return so;case this.InterpolantFactoryMethodSmooth:return Js;case this.InterpolantFactoryMethodBezier:return vl}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;qs(this.settings)&&(ah(this.settings.inTangents,e),ah(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;qs(this.settings)&&(lh(this.settings.inTangents,e),lh(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,s=0,o=r-1;for(;s!==r&&n[s]<e;)++s;for(;o!==-1&&n[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let l=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*l,o*l)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ne("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,s=n.length;s===0&&(Ne("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let l=0;l!==s;l++){let c=n[l];if(typeof c=="number"&&isNaN(c)){Ne("KeyframeTrack: Time is not a valid number.",this,l,c),e=!1;break}if(o!==null&&o>c){Ne("KeyframeTrack: Out of order keys.",this,l,c,o),e=!1;break}o=c}if(r!==void 0&&pm(r))for(let l=0,c=r.length;l!==c;++l){let u=r[l];if(isNaN(u)){Ne("KeyframeTrack: Value is not a valid number.",this,l,u),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===Js,s=e.length-1,o=1;for(let l=1;l<s;++l){let c=!1,u=e[l],d=e[l+1];if(u!==d&&(l!==1||u!==e[0]))if(r)c=!0;else{let p=l*n,h=p-n,g=p+n;for(let _=0;_!==n;++_){let y=t[p+_];if(y!==t[h+_]||y!==t[g+_]){c=!0;break}}}if(c){if(l!==o){e[o]=e[l];let p=l*n,h=o*n;for(let g=0;g!==n;++g)t[h+g]=t[p+g]}++o}}if(s>0){e[o]=e[s];for(let l=s*n,c=o*n,u=0;u!==n;++u)t[c+u]=t[l+u];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,qs(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function ah(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}a(ah,"shiftTangentTimes");function lh(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}a(lh,"scaleTangentTimes");Kt.prototype.ValueTypeName="";Kt.prototype.TimeBufferType=Float32Array;Kt.prototype.ValueBufferType=Float32Array;Kt.prototype.DefaultInterpolation=so;var ci=class extends Kt{static{a(this,"BooleanKeyframeTrack")}constructor(e,t,n){super(e,t,n)}};ci.prototype.ValueTypeName="bool";ci.prototype.ValueBufferType=Array;ci.prototype.DefaultInterpolation=Cr;ci.prototype.InterpolantFactoryMethodLinear=void 0;ci.prototype.InterpolantFactoryMethodSmooth=void 0;var So=class extends Kt{static{a(this,"ColorKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}};So.prototype.ValueTypeName="color";var Mo=class extends Kt{static{a(this,"NumberKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}};Mo.prototype.ValueTypeName="number";var bo=class extends li{static{a(this,"QuaternionLinearInterpolant")}constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,l=this.valueSize,c=(n-t)/(r-t),u=e*l;for(let d=u+l;u!==d;u+=4)Cn.slerpFlat(s,0,o,u-l,o,u,c);return s}},Zr=class extends Kt{static{a(this,"QuaternionKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new bo(this.times,this.values,this.getValueSize(),e)}};Zr.prototype.ValueTypeName="quaternion";Zr.prototype.InterpolantFactoryMethodSmooth=void 0;var ui=class extends Kt{static{a(this,"StringKeyframeTrack")}constructor(e,t,n){super(e,t,n)}};ui.prototype.ValueTypeName="string";ui.prototype.ValueBufferType=Array;ui.prototype.DefaultInterpolation=Cr;ui.prototype.InterpolantFactoryMethodLinear=void 0;ui.prototype.InterpolantFactoryMethodSmooth=void 0;var wo=class extends Kt{static{a(this,"VectorKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}};wo.prototype.ValueTypeName="vector";var Eo=class{static{a(this,"LoadingManager")}constructor(e,t,n){let r=this,s=!1,o=0,l=0,c,u=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(d){l++,s===!1&&r.onStart!==void 0&&r.onStart(d,o,l),s=!0},this.itemEnd=function(d){o++,r.onProgress!==void 0&&r.onProgress(d,o,l),o===l&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(d){r.onError!==void 0&&r.onError(d)},this.resolveURL=function(d){return d=d.normalize("NFC"),c?c(d):d},this.setURLModifier=function(d){return c=d,this},this.addHandler=function(d,p){return u.push(d,p),this},this.removeHandler=function(d){let p=u.indexOf(d);return p!==-1&&u.splice(p,2),this},this.getHandler=function(d){for(let p=0,h=u.length;p<h;p+=2){let g=u[p],_=u[p+1];if(g.global&&(g.lastIndex=0),g.test(d))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Kh=new Eo,To=class{static{a(this,"Loader")}constructor(e){this.manager=e!==void 0?e:Kh,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,s){n.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};To.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ao=class extends Xt{static{a(this,"Light")}static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ke(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Kr=class extends Ao{static{a(this,"HemisphereLight")}constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Xt.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ke(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}};var Ys=new H,$s=new Cn,Tn=new H,jr=class extends Xt{static{a(this,"Camera")}constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qe,this.projectionMatrix=new Qe,this.projectionMatrixInverse=new Qe,this.coordinateSystem=ln,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ys,$s,Tn),Tn.x===1&&Tn.y===1&&Tn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ys,$s,Tn.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Ys,$s,Tn),Tn.x===1&&Tn.y===1&&Tn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ys,$s,Tn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ri=new H,ch=new Ge,uh=new Ge,Gt=class extends jr{static{a(this,"PerspectiveCamera")}constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=oo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Qa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return oo*2*Math.atan(Math.tan(Qa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){ri.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ri.x,ri.y).multiplyScalar(-e/ri.z),ri.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ri.x,ri.y).multiplyScalar(-e/ri.z)}getViewSize(e,t){return this.getViewBounds(e,ch,uh),t.subVectors(uh,ch)}setViewOffset(e,t,n,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Qa*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,u=o.fullHeight;s+=o.offsetX*r/c,t-=o.offsetY*n/u,r*=o.width/c,n*=o.height/u}let l=this.filmOffset;l!==0&&(s+=e*l/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ro=class extends jr{static{a(this,"OrthographicCamera")}constructor(e=-1,t=1,n=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-e,o=n+e,l=r+t,c=r-t;if(this.view!==null&&this.view.enabled){let u=(this.right-this.left)/this.view.fullWidth/this.zoom,d=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=u*this.view.offsetX,o=s+u*this.view.width,l-=d*this.view.offsetY,c=l-d*this.view.height}this.projectionMatrix.makeOrthographic(s,o,l,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Qr=class extends Ut{static{a(this,"InstancedBufferGeometry")}constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Zi=-90,Ki=1,or=class extends Xt{static{a(this,"CubeCamera")}constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Gt(Zi,Ki,e,t);r.layers=this.layers,this.add(r);let s=new Gt(Zi,Ki,e,t);s.layers=this.layers,this.add(s);let o=new Gt(Zi,Ki,e,t);o.layers=this.layers,this.add(o);let l=new Gt(Zi,Ki,e,t);l.layers=this.layers,this.add(l);let c=new Gt(Zi,Ki,e,t);c.layers=this.layers,this.add(c);let u=new Gt(Zi,Ki,e,t);u.layers=this.layers,this.add(u)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,s,o,l,c]=t;for(let u of t)this.remove(u);if(e===ln)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),l.up.set(0,1,0),l.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Lr)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),l.up.set(0,-1,0),l.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let u of t)this.add(u),u.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,l,c,u,d]=this.children,p=e.getRenderTarget(),h=e.getActiveCubeFace(),g=e.getActiveMipmapLevel(),_=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let f=!1;e.isWebGLRenderer===!0?f=e.state.buffers.depth.getReversed():f=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,1,r),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,r),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,3,r),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,r),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,r),f&&e.autoClear===!1&&e.clearDepth(),e.render(t,d),e.setRenderTarget(p,h,g),e.xr.enabled=_,n.texture.needsPMREMUpdate=!0}},Co=class extends Gt{static{a(this,"ArrayCamera")}constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Jl="\\[\\]\\.:\\/",zm=new RegExp("["+Jl+"]","g"),Zl="[^"+Jl+"]",Gm="[^"+Jl.replace("\\.","")+"]",Vm=/((?:WC+[\/:])*)/.source.replace("WC",Zl),Hm=/(WCOD+)?/.source.replace("WCOD",Gm),Wm=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Zl),Xm=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Zl),qm=new RegExp("^"+Vm+Hm+Wm+Xm+"$"),Ym=["material","materials","bones","map"],wl=class{static{a(this,"Composite")}constructor(e,t,n){let r=n||st.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},st=class i{static{a(this,"PropertyBinding")}constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(zm,"")}static parseTrackName(e){let t=qm.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);Ym.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=a(function(s){for(let o=0;o<s.length;o++){let l=s[o];if(l.name===t||l.uuid===t)return l;let c=n(l.children);if(c)return c}return null},"searchNodeSubtree"),r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Pe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let u=t.objectIndex;switch(n){case"materials":if(!e.material){Ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ne("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ne("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let d=0;d<e.length;d++)if(e[d].name===u){u=d;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ne("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ne("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Ne("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(u!==void 0){if(e[u]===void 0){Ne("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[u]}}let o=e[r];if(o===void 0){let u=t.nodeName;Ne("PropertyBinding: Trying to update property for track: "+u+"."+r+" but it wasn't found.",e);return}let l=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?l=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(l=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){Ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ne("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][l]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};st.Composite=wl;st.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};st.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};st.prototype.GetterByBindingType=[st.prototype._getValue_direct,st.prototype._getValue_array,st.prototype._getValue_arrayElement,st.prototype._getValue_toArray];st.prototype.SetterByBindingTypeAndVersioning=[[st.prototype._setValue_direct,st.prototype._setValue_direct_setNeedsUpdate,st.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[st.prototype._setValue_array,st.prototype._setValue_array_setNeedsUpdate,st.prototype._setValue_array_setMatrixWorldNeedsUpdate],[st.prototype._setValue_arrayElement,st.prototype._setValue_arrayElement_setNeedsUpdate,st.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[st.prototype._setValue_fromArray,st.prototype._setValue_fromArray_setNeedsUpdate,st.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var aM=new Float32Array(1);var es=class extends uo{static{a(this,"InstancedInterleavedBuffer")}constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var El=class{static{a(this,"Matrix2")}static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=n,s[3]=r,this}};function Kl(i,e,t,n){let r=$m(n);switch(t){case Vl:return i*e;case Oo:return i*e/r.components*r.byteLength;case Bo:return i*e/r.components*r.byteLength;case fi:return i*e*2/r.components*r.byteLength;case ko:return i*e*2/r.components*r.byteLength;case Hl:return i*e*3/r.components*r.byteLength;case Mn:return i*e*4/r.components*r.byteLength;case zo:return i*e*4/r.components*r.byteLength;case rs:case ss:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case os:case as:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Vo:case Wo:return Math.max(i,16)*Math.max(e,8)/4;case Go:case Ho:return Math.max(i,8)*Math.max(e,8)/2;case Xo:case qo:case $o:case Jo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Yo:case ls:case Zo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ko:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case jo:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Qo:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ea:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ta:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case na:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case ia:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case ra:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case sa:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case oa:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case aa:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case la:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case ca:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case ua:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case ha:case da:case fa:return Math.ceil(i/4)*Math.ceil(e/4)*16;case pa:case ma:return Math.ceil(i/4)*Math.ceil(e/4)*8;case cs:case ga:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}a(Kl,"getByteLength");function $m(i){switch(i){case jt:case Bl:return{byteLength:1,components:1};case dr:case kl:case Sn:return{byteLength:2,components:1};case Uo:case Fo:return{byteLength:2,components:4};case Qt:case Do:case un:return{byteLength:4,components:1};case zl:case Gl:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}a($m,"getTextureTypeByteLength");typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Pe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function yd(){let i=null,e=!1,t=null,n=null;function r(s,o){n=i.requestAnimationFrame(r),t(s,o)}return a(r,"onAnimationFrame"),{start:a(function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},"start"),stop:a(function(){i!==null&&i.cancelAnimationFrame(n),e=!1},"stop"),setAnimationLoop:a(function(s){t=s},"setAnimationLoop"),setContext:a(function(s){i=s},"setContext")}}a(yd,"WebGLAnimation");function Zm(i){let e=new WeakMap;function t(l,c){let u=l.array,d=l.usage,p=u.byteLength,h=i.createBuffer();i.bindBuffer(c,h),i.bufferData(c,u,d),l.onUploadCallback();let g;if(u instanceof Float32Array)g=i.FLOAT;else if(typeof Float16Array<"u"&&u instanceof Float16Array)g=i.HALF_FLOAT;else if(u instanceof Uint16Array)l.isFloat16BufferAttribute?g=i.HALF_FLOAT:g=i.UNSIGNED_SHORT;else if(u instanceof Int16Array)g=i.SHORT;else if(u instanceof Uint32Array)g=i.UNSIGNED_INT;else if(u instanceof Int32Array)g=i.INT;else if(u instanceof Int8Array)g=i.BYTE;else if(u instanceof Uint8Array)g=i.UNSIGNED_BYTE;else if(u instanceof Uint8ClampedArray)g=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+u);return{buffer:h,type:g,bytesPerElement:u.BYTES_PER_ELEMENT,version:l.version,size:p}}a(t,"createBuffer");function n(l,c,u){let d=c.array,p=c.updateRanges;if(i.bindBuffer(u,l),p.length===0)i.bufferSubData(u,0,d);else{p.sort((g,_)=>g.start-_.start);let h=0;for(let g=1;g<p.length;g++){let _=p[h],y=p[g];y.start<=_.start+_.count+1?_.count=Math.max(_.count,y.start+y.count-_.start):(++h,p[h]=y)}p.length=h+1;for(let g=0,_=p.length;g<_;g++){let y=p[g];i.bufferSubData(u,y.start*d.BYTES_PER_ELEMENT,d,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}a(n,"updateBuffer");function r(l){return l.isInterleavedBufferAttribute&&(l=l.data),e.get(l)}a(r,"get");function s(l){l.isInterleavedBufferAttribute&&(l=l.data);let c=e.get(l);c&&(i.deleteBuffer(c.buffer),e.delete(l))}a(s,"remove");function o(l,c){if(l.isInterleavedBufferAttribute&&(l=l.data),l.isGLBufferAttribute){let d=e.get(l);(!d||d.version<l.version)&&e.set(l,{buffer:l.buffer,type:l.type,bytesPerElement:l.elementSize,version:l.version});return}let u=e.get(l);if(u===void 0)e.set(l,t(l,c));else if(u.version<l.version){if(u.size!==l.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(u.buffer,l,c),u.version=l.version}}return a(o,"update"),{get:r,remove:s,update:o}}a(Zm,"WebGLAttributes");var Km=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,jm=`#ifdef USE_ALPHAHASH
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
#endif`,Qm=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,eg=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,tg=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ng=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ig=`#ifdef USE_AOMAP
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
#endif`,rg=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,sg=`#ifdef USE_BATCHING
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
#endif`,og=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ag=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,lg=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,cg=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ug=`#ifdef USE_IRIDESCENCE
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
#endif`,hg=`#ifdef USE_BUMPMAP
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
#endif`,dg=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,fg=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,pg=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,mg=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,gg=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,_g=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,xg=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,yg=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,vg=`#define PI 3.141592653589793
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
} // validated`,Sg=`vec3 transformedNormal = objectNormal;
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
#endif`,Mg=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,bg=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,wg=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Eg=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Tg="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ag=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Rg=`#ifdef USE_ENVMAP
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
#endif`,Cg=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Pg=`#ifdef USE_ENVMAP
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
#endif`,Ig=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Lg=`#ifdef USE_ENVMAP
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
#endif`,Ng=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Dg=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ug=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Fg=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Og=`#ifdef USE_GRADIENTMAP
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
}`,Bg=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,kg=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,zg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Gg=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Vg=`#ifdef USE_ENVMAP
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
#endif`,Hg=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Wg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Xg=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,qg=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Yg=`PhysicalMaterial material;
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
#endif`,$g=`uniform sampler2D dfgLUT;
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
}`,Jg=`
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
#endif`,Zg=`#if defined( RE_IndirectDiffuse )
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
#endif`,Kg=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,jg=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Qg=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,e0=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,t0=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,n0=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,i0=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,r0=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,s0=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,o0=`#if defined( USE_POINTS_UV )
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
#endif`,a0=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,l0=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,c0=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,u0=`#if defined( USE_MORPHCOLORS )
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
#endif`,h0=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,d0=`#ifdef USE_MORPHTARGETS
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
#endif`,f0=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,p0=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,m0=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,g0=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_0=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,x0=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,y0=`#ifdef USE_NORMALMAP
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
#endif`,v0=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,S0=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,M0=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,b0=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,w0=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,E0=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,T0=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,A0=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,R0=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,C0=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,P0=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,I0=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,L0=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,N0=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,D0=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,U0=`float getShadowMask() {
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
}`,F0=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,O0=`#ifdef USE_SKINNING
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
#endif`,B0=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,k0=`#ifdef USE_SKINNING
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
#endif`,z0=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,G0=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,V0=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,H0=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,W0=`#ifdef USE_TRANSMISSION
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
#endif`,X0=`#ifdef USE_TRANSMISSION
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
#endif`,q0=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Y0=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,$0=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,J0=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Z0=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,K0=`uniform sampler2D t2D;
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
}`,j0=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Q0=`uniform float backgroundBlurriness;
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
}`,e_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,t_=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,n_=`#include <common>
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
}`,i_=`#if DEPTH_PACKING == 3200
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
}`,r_=`#define DISTANCE
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
}`,s_=`#define DISTANCE
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
}`,o_=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,a_=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,l_=`uniform float scale;
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
}`,c_=`uniform vec3 diffuse;
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
}`,u_=`#include <common>
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
}`,h_=`uniform vec3 diffuse;
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
}`,d_=`#define LAMBERT
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
}`,f_=`#define LAMBERT
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
}`,p_=`#define MATCAP
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
}`,m_=`#define MATCAP
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
}`,g_=`#define NORMAL
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
}`,__=`#define NORMAL
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
}`,x_=`#define PHONG
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
}`,y_=`#define PHONG
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
}`,v_=`#define STANDARD
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
}`,S_=`#define STANDARD
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
}`,M_=`#define TOON
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
}`,b_=`#define TOON
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
}`,w_=`uniform float size;
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
}`,E_=`uniform vec3 diffuse;
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
}`,T_=`#include <common>
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
}`,A_=`uniform vec3 color;
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
}`,R_=`uniform float rotation;
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
}`,C_=`uniform vec3 diffuse;
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
}`,ze={alphahash_fragment:Km,alphahash_pars_fragment:jm,alphamap_fragment:Qm,alphamap_pars_fragment:eg,alphatest_fragment:tg,alphatest_pars_fragment:ng,aomap_fragment:ig,aomap_pars_fragment:rg,batching_pars_vertex:sg,batching_vertex:og,begin_vertex:ag,beginnormal_vertex:lg,bsdfs:cg,iridescence_fragment:ug,bumpmap_pars_fragment:hg,clipping_planes_fragment:dg,clipping_planes_pars_fragment:fg,clipping_planes_pars_vertex:pg,clipping_planes_vertex:mg,color_fragment:gg,color_pars_fragment:_g,color_pars_vertex:xg,color_vertex:yg,common:vg,defaultnormal_vertex:Sg,displacementmap_pars_vertex:Mg,displacementmap_vertex:bg,emissivemap_fragment:wg,emissivemap_pars_fragment:Eg,colorspace_fragment:Tg,colorspace_pars_fragment:Ag,envmap_fragment:Rg,envmap_common_pars_fragment:Cg,envmap_pars_fragment:Pg,envmap_pars_vertex:Ig,envmap_physical_pars_fragment:Vg,envmap_vertex:Lg,fog_vertex:Ng,fog_pars_vertex:Dg,fog_fragment:Ug,fog_pars_fragment:Fg,gradientmap_pars_fragment:Og,lightmap_pars_fragment:Bg,lights_lambert_fragment:kg,lights_lambert_pars_fragment:zg,lights_pars_begin:Gg,lights_toon_fragment:Hg,lights_toon_pars_fragment:Wg,lights_phong_fragment:Xg,lights_phong_pars_fragment:qg,lights_physical_fragment:Yg,lights_physical_pars_fragment:$g,lights_fragment_begin:Jg,lights_fragment_maps:Zg,lights_fragment_end:Kg,lightprobes_pars_fragment:jg,logdepthbuf_fragment:Qg,logdepthbuf_pars_fragment:e0,logdepthbuf_pars_vertex:t0,logdepthbuf_vertex:n0,map_fragment:i0,map_pars_fragment:r0,map_particle_fragment:s0,map_particle_pars_fragment:o0,metalnessmap_fragment:a0,metalnessmap_pars_fragment:l0,morphinstance_vertex:c0,morphcolor_vertex:u0,morphnormal_vertex:h0,morphtarget_pars_vertex:d0,morphtarget_vertex:f0,normal_fragment_begin:p0,normal_fragment_maps:m0,normal_pars_fragment:g0,normal_pars_vertex:_0,normal_vertex:x0,normalmap_pars_fragment:y0,clearcoat_normal_fragment_begin:v0,clearcoat_normal_fragment_maps:S0,clearcoat_pars_fragment:M0,iridescence_pars_fragment:b0,opaque_fragment:w0,packing:E0,premultiplied_alpha_fragment:T0,project_vertex:A0,dithering_fragment:R0,dithering_pars_fragment:C0,roughnessmap_fragment:P0,roughnessmap_pars_fragment:I0,shadowmap_pars_fragment:L0,shadowmap_pars_vertex:N0,shadowmap_vertex:D0,shadowmask_pars_fragment:U0,skinbase_vertex:F0,skinning_pars_vertex:O0,skinning_vertex:B0,skinnormal_vertex:k0,specularmap_fragment:z0,specularmap_pars_fragment:G0,tonemapping_fragment:V0,tonemapping_pars_fragment:H0,transmission_fragment:W0,transmission_pars_fragment:X0,uv_pars_fragment:q0,uv_pars_vertex:Y0,uv_vertex:$0,worldpos_vertex:J0,background_vert:Z0,background_frag:K0,backgroundCube_vert:j0,backgroundCube_frag:Q0,cube_vert:e_,cube_frag:t_,depth_vert:n_,depth_frag:i_,distance_vert:r_,distance_frag:s_,equirect_vert:o_,equirect_frag:a_,linedashed_vert:l_,linedashed_frag:c_,meshbasic_vert:u_,meshbasic_frag:h_,meshlambert_vert:d_,meshlambert_frag:f_,meshmatcap_vert:p_,meshmatcap_frag:m_,meshnormal_vert:g_,meshnormal_frag:__,meshphong_vert:x_,meshphong_frag:y_,meshphysical_vert:v_,meshphysical_frag:S_,meshtoon_vert:M_,meshtoon_frag:b_,points_vert:w_,points_frag:E_,shadow_vert:T_,shadow_frag:A_,sprite_vert:R_,sprite_frag:C_},_e={common:{diffuse:{value:new ke(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new De}},envmap:{envMap:{value:null},envMapRotation:{value:new De},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new De}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new De}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new De},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new De},normalScale:{value:new Ge(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new De},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new De}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new De}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new De}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ke(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ke(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0},uvTransform:{value:new De}},sprite:{diffuse:{value:new ke(16777215)},opacity:{value:1},center:{value:new Ge(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}}},Dn={basic:{uniforms:Ft([_e.common,_e.specularmap,_e.envmap,_e.aomap,_e.lightmap,_e.fog]),vertexShader:ze.meshbasic_vert,fragmentShader:ze.meshbasic_frag},lambert:{uniforms:Ft([_e.common,_e.specularmap,_e.envmap,_e.aomap,_e.lightmap,_e.emissivemap,_e.bumpmap,_e.normalmap,_e.displacementmap,_e.fog,_e.lights,{emissive:{value:new ke(0)},envMapIntensity:{value:1}}]),vertexShader:ze.meshlambert_vert,fragmentShader:ze.meshlambert_frag},phong:{uniforms:Ft([_e.common,_e.specularmap,_e.envmap,_e.aomap,_e.lightmap,_e.emissivemap,_e.bumpmap,_e.normalmap,_e.displacementmap,_e.fog,_e.lights,{emissive:{value:new ke(0)},specular:{value:new ke(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ze.meshphong_vert,fragmentShader:ze.meshphong_frag},standard:{uniforms:Ft([_e.common,_e.envmap,_e.aomap,_e.lightmap,_e.emissivemap,_e.bumpmap,_e.normalmap,_e.displacementmap,_e.roughnessmap,_e.metalnessmap,_e.fog,_e.lights,{emissive:{value:new ke(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ze.meshphysical_vert,fragmentShader:ze.meshphysical_frag},toon:{uniforms:Ft([_e.common,_e.aomap,_e.lightmap,_e.emissivemap,_e.bumpmap,_e.normalmap,_e.displacementmap,_e.gradientmap,_e.fog,_e.lights,{emissive:{value:new ke(0)}}]),vertexShader:ze.meshtoon_vert,fragmentShader:ze.meshtoon_frag},matcap:{uniforms:Ft([_e.common,_e.bumpmap,_e.normalmap,_e.displacementmap,_e.fog,{matcap:{value:null}}]),vertexShader:ze.meshmatcap_vert,fragmentShader:ze.meshmatcap_frag},points:{uniforms:Ft([_e.points,_e.fog]),vertexShader:ze.points_vert,fragmentShader:ze.points_frag},dashed:{uniforms:Ft([_e.common,_e.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ze.linedashed_vert,fragmentShader:ze.linedashed_frag},depth:{uniforms:Ft([_e.common,_e.displacementmap]),vertexShader:ze.depth_vert,fragmentShader:ze.depth_frag},normal:{uniforms:Ft([_e.common,_e.bumpmap,_e.normalmap,_e.displacementmap,{opacity:{value:1}}]),vertexShader:ze.meshnormal_vert,fragmentShader:ze.meshnormal_frag},sprite:{uniforms:Ft([_e.sprite,_e.fog]),vertexShader:ze.sprite_vert,fragmentShader:ze.sprite_frag},background:{uniforms:{uvTransform:{value:new De},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ze.background_vert,fragmentShader:ze.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new De}},vertexShader:ze.backgroundCube_vert,fragmentShader:ze.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ze.cube_vert,fragmentShader:ze.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ze.equirect_vert,fragmentShader:ze.equirect_frag},distance:{uniforms:Ft([_e.common,_e.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ze.distance_vert,fragmentShader:ze.distance_frag},shadow:{uniforms:Ft([_e.lights,_e.fog,{color:{value:new ke(0)},opacity:{value:1}}]),vertexShader:ze.shadow_vert,fragmentShader:ze.shadow_frag}};Dn.physical={uniforms:Ft([Dn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new De},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new De},clearcoatNormalScale:{value:new Ge(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new De},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new De},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new De},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new De},sheen:{value:0},sheenColor:{value:new ke(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new De},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new De},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new De},transmissionSamplerSize:{value:new Ge},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new De},attenuationDistance:{value:0},attenuationColor:{value:new ke(0)},specularColor:{value:new ke(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new De},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new De},anisotropyVector:{value:new Ge},anisotropyMap:{value:null},anisotropyMapTransform:{value:new De}}]),vertexShader:ze.meshphysical_vert,fragmentShader:ze.meshphysical_frag};var ya={r:0,b:0,g:0},P_=new Qe,vd=new De;vd.set(-1,0,0,0,1,0,0,0,1);function I_(i,e,t,n,r,s){let o=new ke(0),l=r===!0?0:1,c,u,d=null,p=0,h=null;function g(S){let A=S.isScene===!0?S.background:null;if(A&&A.isTexture){let v=S.backgroundBlurriness>0;A=e.get(A,v)}return A}a(g,"getBackground");function _(S){let A=!1,v=g(S);v===null?f(o,l):v&&v.isColor&&(f(v,1),A=!0);let M=i.xr.getEnvironmentBlendMode();M==="additive"?t.buffers.color.setClear(0,0,0,1,s):M==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}a(_,"render");function y(S,A){let v=g(A);v&&v.isCubeTexture?(u===void 0&&(u=new ut(new sr(1,1,1),new In({name:"BackgroundCubeMaterial",uniforms:Di(Dn.backgroundCube.uniforms),vertexShader:Dn.backgroundCube.vertexShader,fragmentShader:Dn.backgroundCube.fragmentShader,side:Vt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(M,T,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:a(function(){return this.uniforms.envMap.value},"get")}),n.update(u)),u.material.uniforms.envMap.value=v,u.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(P_.makeRotationFromEuler(A.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&u.material.uniforms.backgroundRotation.value.premultiply(vd),u.material.toneMapped=qe.getTransfer(v.colorSpace)!==Ke,(d!==v||p!==v.version||h!==i.toneMapping)&&(u.material.needsUpdate=!0,d=v,p=v.version,h=i.toneMapping),u.layers.enableAll(),S.unshift(u,u.geometry,u.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new ut(new Yr(2,2),new In({name:"BackgroundMaterial",uniforms:Di(Dn.background.uniforms),vertexShader:Dn.background.vertexShader,fragmentShader:Dn.background.fragmentShader,side:hi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:a(function(){return this.uniforms.t2D.value},"get")}),n.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=qe.getTransfer(v.colorSpace)!==Ke,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(d!==v||p!==v.version||h!==i.toneMapping)&&(c.material.needsUpdate=!0,d=v,p=v.version,h=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null))}a(y,"addToRenderList");function f(S,A){S.getRGB(ya,$l(i)),t.buffers.color.setClear(ya.r,ya.g,ya.b,A,s)}a(f,"setClear");function m(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return a(m,"dispose"),{getClearColor:a(function(){return o},"getClearColor"),setClearColor:a(function(S,A=1){o.set(S),l=A,f(o,l)},"setClearColor"),getClearAlpha:a(function(){return l},"getClearAlpha"),setClearAlpha:a(function(S){l=S,f(o,l)},"setClearAlpha"),render:_,addToRenderList:y,dispose:m}}a(I_,"WebGLBackground");function L_(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=h(null),s=r,o=!1;function l(D,B,X,L,q){let O=!1,z=p(D,L,X,B);s!==z&&(s=z,u(s.object)),O=g(D,L,X,q),O&&_(D,L,X,q),q!==null&&e.update(q,i.ELEMENT_ARRAY_BUFFER),(O||o)&&(o=!1,v(D,B,X,L),q!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(q).buffer))}a(l,"setup");function c(){return i.createVertexArray()}a(c,"createVertexArrayObject");function u(D){return i.bindVertexArray(D)}a(u,"bindVertexArrayObject");function d(D){return i.deleteVertexArray(D)}a(d,"deleteVertexArrayObject");function p(D,B,X,L){let q=L.wireframe===!0,O=n[B.id];O===void 0&&(O={},n[B.id]=O);let z=D.isInstancedMesh===!0?D.id:0,te=O[z];te===void 0&&(te={},O[z]=te);let Y=te[X.id];Y===void 0&&(Y={},te[X.id]=Y);let ee=Y[q];return ee===void 0&&(ee=h(c()),Y[q]=ee),ee}a(p,"getBindingState");function h(D){let B=[],X=[],L=[];for(let q=0;q<t;q++)B[q]=0,X[q]=0,L[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:X,attributeDivisors:L,object:D,attributes:{},index:null}}a(h,"createBindingState");function g(D,B,X,L){let q=s.attributes,O=B.attributes,z=0,te=X.getAttributes();for(let Y in te)if(te[Y].location>=0){let ne=q[Y],Me=O[Y];if(Me===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(Me=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(Me=D.instanceColor)),ne===void 0||ne.attribute!==Me||Me&&ne.data!==Me.data)return!0;z++}return s.attributesNum!==z||s.index!==L}a(g,"needsUpdate");function _(D,B,X,L){let q={},O=B.attributes,z=0,te=X.getAttributes();for(let Y in te)if(te[Y].location>=0){let ne=O[Y];ne===void 0&&(Y==="instanceMatrix"&&D.instanceMatrix&&(ne=D.instanceMatrix),Y==="instanceColor"&&D.instanceColor&&(ne=D.instanceColor));let Me={};Me.attribute=ne,ne&&ne.data&&(Me.data=ne.data),q[Y]=Me,z++}s.attributes=q,s.attributesNum=z,s.index=L}a(_,"saveCache");function y(){let D=s.newAttributes;for(let B=0,X=D.length;B<X;B++)D[B]=0}a(y,"initAttributes");function f(D){m(D,0)}a(f,"enableAttribute");function m(D,B){let X=s.newAttributes,L=s.enabledAttributes,q=s.attributeDivisors;X[D]=1,L[D]===0&&(i.enableVertexAttribArray(D),L[D]=1),q[D]!==B&&(i.vertexAttribDivisor(D,B),q[D]=B)}a(m,"enableAttributeAndDivisor");function S(){let D=s.newAttributes,B=s.enabledAttributes;for(let X=0,L=B.length;X<L;X++)B[X]!==D[X]&&(i.disableVertexAttribArray(X),B[X]=0)}a(S,"disableUnusedAttributes");function A(D,B,X,L,q,O,z){z===!0?i.vertexAttribIPointer(D,B,X,q,O):i.vertexAttribPointer(D,B,X,L,q,O)}a(A,"vertexAttribPointer");function v(D,B,X,L){y();let q=L.attributes,O=X.getAttributes(),z=B.defaultAttributeValues;for(let te in O){let Y=O[te];if(Y.location>=0){let ee=q[te];if(ee===void 0&&(te==="instanceMatrix"&&D.instanceMatrix&&(ee=D.instanceMatrix),te==="instanceColor"&&D.instanceColor&&(ee=D.instanceColor)),ee!==void 0){let ne=ee.normalized,Me=ee.itemSize,Ie=e.get(ee);if(Ie===void 0)continue;let F=Ie.buffer,J=Ie.type,ie=Ie.bytesPerElement,ve=J===i.INT||J===i.UNSIGNED_INT||ee.gpuType===Do;if(ee.isInterleavedBufferAttribute){let ae=ee.data,Le=ae.isInterleavedBuffer===!0?ae.stride:ae.itemSize,rt=ee.offset;if(ae.isInstancedInterleavedBuffer||ae.isInstancedBufferAttribute){for(let Te=0;Te<Y.locationSize;Te++)m(Y.location+Te,ae.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let Te=0;Te<Y.locationSize;Te++)f(Y.location+Te);i.bindBuffer(i.ARRAY_BUFFER,F);for(let Te=0;Te<Y.locationSize;Te++)A(Y.location+Te,Me/Y.locationSize,J,ne,Le*ie,(rt+Me/Y.locationSize*Te)*ie,ve)}else{if(ee.isInstancedBufferAttribute){for(let ae=0;ae<Y.locationSize;ae++)m(Y.location+ae,ee.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let ae=0;ae<Y.locationSize;ae++)f(Y.location+ae);i.bindBuffer(i.ARRAY_BUFFER,F);for(let ae=0;ae<Y.locationSize;ae++)A(Y.location+ae,Me/Y.locationSize,J,ne,Me*ie,Me/Y.locationSize*ae*ie,ve)}}else if(z!==void 0){let ne=z[te];if(ne!==void 0)switch(ne.length){case 2:i.vertexAttrib2fv(Y.location,ne);break;case 3:i.vertexAttrib3fv(Y.location,ne);break;case 4:i.vertexAttrib4fv(Y.location,ne);break;default:i.vertexAttrib1fv(Y.location,ne)}}}}S()}a(v,"setupVertexAttributes");function M(){P();for(let D in n){let B=n[D];for(let X in B){let L=B[X];for(let q in L){let O=L[q];for(let z in O)d(O[z].object),delete O[z];delete L[q]}}delete n[D]}}a(M,"dispose");function T(D){if(n[D.id]===void 0)return;let B=n[D.id];for(let X in B){let L=B[X];for(let q in L){let O=L[q];for(let z in O)d(O[z].object),delete O[z];delete L[q]}}delete n[D.id]}a(T,"releaseStatesOfGeometry");function x(D){for(let B in n){let X=n[B];for(let L in X){let q=X[L];if(q[D.id]===void 0)continue;let O=q[D.id];for(let z in O)d(O[z].object),delete O[z];delete q[D.id]}}}a(x,"releaseStatesOfProgram");function w(D){for(let B in n){let X=n[B],L=D.isInstancedMesh===!0?D.id:0,q=X[L];if(q!==void 0){for(let O in q){let z=q[O];for(let te in z)d(z[te].object),delete z[te];delete q[O]}delete X[L],Object.keys(X).length===0&&delete n[B]}}}a(w,"releaseStatesOfObject");function P(){C(),o=!0,s!==r&&(s=r,u(s.object))}a(P,"reset");function C(){r.geometry=null,r.program=null,r.wireframe=!1}return a(C,"resetDefaultState"),{setup:l,reset:P,resetDefaultState:C,dispose:M,releaseStatesOfGeometry:T,releaseStatesOfObject:w,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:f,disableUnusedAttributes:S}}a(L_,"WebGLBindingStates");function N_(i,e,t){let n;function r(c){n=c}a(r,"setMode");function s(c,u){i.drawArrays(n,c,u),t.update(u,n,1)}a(s,"render");function o(c,u,d){d!==0&&(i.drawArraysInstanced(n,c,u,d),t.update(u,n,d))}a(o,"renderInstances");function l(c,u,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,d);let h=0;for(let g=0;g<d;g++)h+=u[g];t.update(h,n,1)}a(l,"renderMultiDraw"),this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=l}a(N_,"WebGLBufferRenderer");function D_(i,e,t,n){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}a(s,"getMaxAnisotropy");function o(x){return!(x!==Mn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}a(o,"textureFormatReadable");function l(x){let w=x===Sn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==jt&&x!==un&&!w&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}a(l,"textureTypeReadable");function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}a(c,"getMaxPrecision");let u=t.precision!==void 0?t.precision:"highp",d=c(u);d!==u&&(Pe("WebGLRenderer:",u,"not supported, using",d,"instead."),u=d);let p=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&p===!1;t.reversedDepthBuffer===!0&&p===!1&&Pe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&p===!0&&Pe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let g=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),f=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),S=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),M=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:l,precision:u,logarithmicDepthBuffer:h,reversedDepthBuffer:p,maxTextures:g,maxVertexTextures:_,maxTextureSize:y,maxCubemapSize:f,maxAttributes:m,maxVertexUniforms:S,maxVaryings:A,maxFragmentUniforms:v,maxSamples:M,samples:T}}a(D_,"WebGLCapabilities");function U_(i){let e=this,t=null,n=0,r=!1,s=!1,o=new gn,l=new De,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(p,h){let g=p.length!==0||h||n!==0||r;return r=h,n=p.length,g},this.beginShadows=function(){s=!0,d(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(p,h){t=d(p,h,0)},this.setState=function(p,h,g){let _=p.clippingPlanes,y=p.clipIntersection,f=p.clipShadows,m=i.get(p);if(!r||_===null||_.length===0||s&&!f)s?d(null):u();else{let S=s?0:n,A=S*4,v=m.clippingState||null;c.value=v,v=d(_,h,A,g);for(let M=0;M!==A;++M)v[M]=t[M];m.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=S}};function u(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}a(u,"resetGlobalState");function d(p,h,g,_){let y=p!==null?p.length:0,f=null;if(y!==0){if(f=c.value,_!==!0||f===null){let m=g+y*4,S=h.matrixWorldInverse;l.getNormalMatrix(S),(f===null||f.length<m)&&(f=new Float32Array(m));for(let A=0,v=g;A!==y;++A,v+=4)o.copy(p[A]).applyMatrix4(S,l),o.normal.toArray(f,v),f[v+3]=o.constant}c.value=f,c.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,f}a(d,"projectPlanes")}a(U_,"WebGLClipping");var ds=class extends Dt{static{a(this,"WebGLCubeRenderTarget")}constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new Ci(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new sr(5,5,5),s=new In({name:"CubemapFromEquirect",uniforms:Di(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Vt,blending:qn});s.uniforms.tEquirect.value=t;let o=new ut(r,s),l=t.minFilter;return t.minFilter===vn&&(t.minFilter=At),new or(1,10,this).update(e,o),t.minFilter=l,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,r);e.setRenderTarget(s)}},jh=256,F_=3,O_=20,Sd=256,Md=16,B_=3,k_=new H,z_=new ke,Sa=class i{static{a(this,"PMREMGenerator")}constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new or(1,10,null),this._boxMesh=new ut(new sr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,s={}){let{size:o=256,position:l=k_}=s,c=this._renderer;this._setSize(o);let u=this._allocateTarget(),d=this._getSourceTarget(!0);t>0&&(d.texture.mipmapsAutoUpdate=!1);let p=c.autoClear,h=c.autoClearColor,g=c.autoClearDepth,_=c.autoClearStencil,y=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,y===null&&(e.background=c.getClearColor(z_));let f=new or(n,r,d);return f.position.copy(l),f.update(c,e),c.autoClear=p,c.autoClearColor=h,c.autoClearDepth=g,c.autoClearStencil=_,e.background=y,t>0&&(d.texture.mipmapsAutoUpdate=!0,this._blur(u,t)),this._applyPMREM(u),u}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=td(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ed(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(jh,Xh(e))}_fromTexture(e,t){e.mapping===Ii||e.mapping===hr?this._setSize(e.image.length===0?jh:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Qh(e,!1,!1),n=Math.log2(e)-F_;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Qh(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Ii||e.mapping===hr?(this._cubemapMaterial===null&&(this._cubemapMaterial=td()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ed()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=G_(),this._integrationMaterial=V_());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/Md);for(let o=0;o<=n;o++){let l=i.lodToRoughness(o,n);if(o>n-B_)s.roughness.value=l,this._renderCube(e,o,this._integrationMaterial);else{let c=l>0?Math.log2(t)+.5*Math.log2(6/(Sd*Math.pow(l,4)))+.5:0;r.roughness.value=l,r.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=H_());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(s,0,n)}};function Qh(i,e,t){return new ds(i,{minFilter:vn,generateMipmaps:e,type:Sn,colorSpace:Pr,depthBuffer:t})}a(Qh,"_createRenderTarget");function fs(i,e,t){return new In({name:i,uniforms:e,vertexShader:ze.cube_vert,fragmentShader:t,side:Vt,blending:qn,depthTest:!1,depthWrite:!1})}a(fs,"_getMaterial");function G_(){return fs("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Sd}u

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
	`)}a(G_,"_getGGXMaterial");function V_(){return fs("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Md}},`

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
	`)}a(V_,"_getIntegrationMaterial");function H_(){return fs("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${O_}
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
	`)}a(H_,"_getBlurMaterial");function ed(){return fs("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}a(ed,"_getEquirectMaterial");function td(){return fs("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}a(td,"_getCubemapMaterial");function W_(i){let e=new WeakMap,t=new WeakMap,n=null;function r(h,g=!1){return h==null?null:g?o(h):s(h)}a(r,"get");function s(h){if(h&&h.isTexture){let g=h.mapping;if(g===Io||g===Lo)if(e.has(h)){let _=e.get(h).texture;return l(_,h.mapping)}else{let _=h.image;if(_&&_.height>0){let y=new ds(_.height);return y.fromEquirectangularTexture(i,h),e.set(h,y),h.addEventListener("dispose",u),l(y.texture,h.mapping)}else return null}}return h}a(s,"getCube");function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let g=h.mapping,_=g===Io||g===Lo,y=g===Ii||g===hr;if(_||y){let f=t.get(h),m=f!==void 0?f.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return n===null&&(n=new Sa(i)),f=_?n.fromEquirectangular(h,f):n.fromCubemap(h,f),f.texture.pmremVersion=h.pmremVersion,t.set(h,f),f.texture;if(f!==void 0)return f.texture;{let S=h.image;return _&&S&&S.height>0||y&&S&&c(S)?(n===null&&(n=new Sa(i)),f=_?n.fromEquirectangular(h):n.fromCubemap(h),f.texture.pmremVersion=h.pmremVersion,t.set(h,f),h.addEventListener("dispose",d),f.texture):null}}}return h}a(o,"getPMREM");function l(h,g){return g===Io?h.mapping=Ii:g===Lo&&(h.mapping=hr),h}a(l,"mapTextureMapping");function c(h){let g=0,_=6;for(let y=0;y<_;y++)h[y]!==void 0&&g++;return g===_}a(c,"isCubeTextureComplete");function u(h){let g=h.target;g.removeEventListener("dispose",u);let _=e.get(g);_!==void 0&&(e.delete(g),_.dispose())}a(u,"onCubemapDispose");function d(h){let g=h.target;g.removeEventListener("dispose",d);let _=t.get(g);_!==void 0&&(t.delete(g),_.dispose())}a(d,"onPMREMDispose");function p(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return a(p,"dispose"),{get:r,dispose:p}}a(W_,"WebGLEnvironments");function X_(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return a(t,"getExtension"),{has:a(function(n){return t(n)!==null},"has"),init:a(function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},"init"),get:a(function(n){let r=t(n);return r===null&&Rr("WebGLRenderer: "+n+" extension not supported."),r},"get")}}a(X_,"WebGLExtensions");function q_(i,e,t,n){let r={},s=new WeakMap,o=new FinalizationRegistry(_=>delete r[_]);function l(_){c(_.target)}a(l,"onGeometryDispose");function c(_){_.index!==null&&e.remove(_.index);for(let f in _.attributes)e.remove(_.attributes[f]);_.removeEventListener("dispose",l),delete r[_.id],o.unregister(_);let y=s.get(_);y&&(e.remove(y),s.delete(_)),n.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,t.memory.geometries--}a(c,"destroyGeometry");function u(_,y){return r[y.id]!==void 0||(y.addEventListener("dispose",l),r[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}a(u,"get");function d(_){let y=_.attributes;for(let f in y)e.update(y[f],i.ARRAY_BUFFER)}a(d,"update");function p(_){let y=_.index,f=_.attributes.position,m=0;if(f===void 0)return;let S=y!==null?y.array.length:f.array.length/3-1,A=f.count>=65535?Br:Or,v=new A(Math.ceil(S/3)*6,1),M=v.array;if(y!==null){let x=y.array;m=y.version;for(let w=0,P=0;w<S;w+=3){let C=x[w+0],D=x[w+1],B=x[w+2];M[P++]=C,M[P++]=D,M[P++]=D,M[P++]=B,M[P++]=B,M[P++]=C}}else{m=f.version;for(let x=0,w=0;x<S;x+=3){let P=x+0,C=x+1,D=x+2;M[w++]=P,M[w++]=C,M[w++]=C,M[w++]=D,M[w++]=D,M[w++]=P}}v.version=m;let T=s.get(_);T&&e.remove(T),s.set(_,v)}a(p,"updateWireframeAttribute");function h(_){let y=s.get(_);if(y){let f=_.index;f!==null&&y.version<f.version&&p(_)}else p(_);return s.get(_)}a(h,"getWireframeAttribute");function g(){for(let _ in r){let y=r[_].deref();y!==void 0&&c(y)}}return a(g,"dispose"),{get:u,update:d,getWireframeAttribute:h,dispose:g}}a(q_,"WebGLGeometries");function Y_(i,e,t){let n;function r(p){n=p}a(r,"setMode");let s,o;function l(p){s=p.type,o=p.bytesPerElement}a(l,"setIndex");function c(p,h){i.drawElements(n,h,s,p*o),t.update(h,n,1)}a(c,"render");function u(p,h,g){g!==0&&(i.drawElementsInstanced(n,h,s,p*o,g),t.update(h,n,g))}a(u,"renderInstances");function d(p,h,g){if(g===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,s,p,0,g);let y=0;for(let f=0;f<g;f++)y+=h[f];t.update(y,n,1)}a(d,"renderMultiDraw"),this.setMode=r,this.setIndex=l,this.render=c,this.renderInstances=u,this.renderMultiDraw=d}a(Y_,"WebGLIndexedBufferRenderer");function $_(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,l){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=l*(s/3);break;case i.LINES:t.lines+=l*(s/2);break;case i.LINE_STRIP:t.lines+=l*(s-1);break;case i.LINE_LOOP:t.lines+=l*s;break;case i.POINTS:t.points+=l*s;break;default:Ne("WebGLInfo: Unknown draw mode:",o);break}}a(n,"update");function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return a(r,"reset"),{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}a($_,"WebGLInfo");function J_(i,e,t){let n=new WeakMap,r=new nt;function s(o,l,c){let u=o.morphTargetInfluences,d=l.morphAttributes.position||l.morphAttributes.normal||l.morphAttributes.color,p=d!==void 0?d.length:0,h=n.get(l);if(h===void 0||h.count!==p){let P=function(){x.dispose(),n.delete(l),l.removeEventListener("dispose",P)};a(P,"disposeTexture"),h!==void 0&&h.texture.dispose();let g=l.morphAttributes.position!==void 0,_=l.morphAttributes.normal!==void 0,y=l.morphAttributes.color!==void 0,f=l.morphAttributes.position||[],m=l.morphAttributes.normal||[],S=l.morphAttributes.color||[],A=0;g===!0&&(A=1),_===!0&&(A=2),y===!0&&(A=3);let v=l.attributes.position.count*A,M=1;v>e.maxTextureSize&&(M=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);let T=new Float32Array(v*M*4*p),x=new Ur(T,v,M,p);x.type=un,x.needsUpdate=!0;let w=A*4;for(let C=0;C<p;C++){let D=f[C],B=m[C],X=S[C],L=v*M*4*C;for(let q=0;q<D.count;q++){let O=q*w;g===!0&&(r.fromBufferAttribute(D,q),T[L+O+0]=r.x,T[L+O+1]=r.y,T[L+O+2]=r.z,T[L+O+3]=0),_===!0&&(r.fromBufferAttribute(B,q),T[L+O+4]=r.x,T[L+O+5]=r.y,T[L+O+6]=r.z,T[L+O+7]=0),y===!0&&(r.fromBufferAttribute(X,q),T[L+O+8]=r.x,T[L+O+9]=r.y,T[L+O+10]=r.z,T[L+O+11]=X.itemSize===4?r.w:1)}}h={count:p,texture:x,size:new Ge(v,M)},n.set(l,h),l.addEventListener("dispose",P)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let g=0;for(let y=0;y<u.length;y++)g+=u[y];let _=l.morphTargetsRelative?1:1-g;c.getUniforms().setValue(i,"morphTargetBaseInfluence",_),c.getUniforms().setValue(i,"morphTargetInfluences",u)}c.getUniforms().setValue(i,"morphTargetsTexture",h.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return a(s,"update"),{update:s}}a(J_,"WebGLMorphtargets");function Z_(i,e,t,n,r){let s=new WeakMap;function o(u){let d=r.render.frame,p=u.geometry,h=e.get(u,p);if(s.get(h)!==d&&(e.update(h),s.set(h,d)),u.isInstancedMesh&&(u.hasEventListener("dispose",c)===!1&&u.addEventListener("dispose",c),s.get(u)!==d&&(t.update(u.instanceMatrix,i.ARRAY_BUFFER),u.instanceColor!==null&&t.update(u.instanceColor,i.ARRAY_BUFFER),s.set(u,d))),u.isSkinnedMesh){let g=u.skeleton;s.get(g)!==d&&(g.update(),s.set(g,d))}return h}a(o,"update");function l(){s=new WeakMap}a(l,"dispose");function c(u){let d=u.target;d.removeEventListener("dispose",c),n.releaseStatesOfObject(d),t.remove(d.instanceMatrix),d.instanceColor!==null&&t.remove(d.instanceColor)}return a(c,"onInstancedMeshDispose"),{update:o,dispose:l}}a(Z_,"WebGLObjects");var K_={[Pl]:"LINEAR_TONE_MAPPING",[Il]:"REINHARD_TONE_MAPPING",[Ll]:"CINEON_TONE_MAPPING",[Nl]:"ACES_FILMIC_TONE_MAPPING",[Ul]:"AGX_TONE_MAPPING",[Fl]:"NEUTRAL_TONE_MAPPING",[Dl]:"CUSTOM_TONE_MAPPING"};function j_(i,e,t,n,r,s){let o=new Dt(e,t,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),l=null,c=null,u=null,d=new Ut;d.setAttribute("position",new ht([-1,3,0,-1,-1,0,3,-1,0],3)),d.setAttribute("uv",new ht([0,2,0,0,2,0],2));let p=new yn({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new ut(d,p),g=new Ro(-1,1,1,-1,0,1),_=null,y=null,f=!1,m,S=null,A=[],v=!1;this.setSize=function(M,T){o.setSize(M,T),l!==null&&l.setSize(M,T),c!==null&&c.setSize(M,T);for(let x=0;x<A.length;x++){let w=A[x];w.setSize&&w.setSize(M,T)}},this.setEffects=function(M){A=M,v=A.length>0&&A[0].isRenderPass===!0;let T=o.width,x=o.height;A.length>0&&l===null&&(l=new Dt(T,x,{type:Sn,depthBuffer:!1,stencilBuffer:!1}),c=new Dt(T,x,{type:Sn,depthBuffer:!1,stencilBuffer:!1}));let w=r===!0&&A.some(P=>P.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&u===null&&(u=new xn(T,x),s===!0&&(u.format=Yn,u.type=Li)),o.dispose(),o.depthTexture=w?u:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let P=0;P<A.length;P++){let C=A[P];C.setSize&&C.setSize(T,x),w&&C.needsDepthTexture===!0&&C.setDepthTexture&&C.setDepthTexture(u)}},this.begin=function(M,T){if(f||M.toneMapping===Ln&&A.length===0)return!1;if(S=T,T!==null){let x=T.width,w=T.height;(o.width!==x||o.height!==w)&&this.setSize(x,w)}return v===!1&&M.setRenderTarget(o),m=M.toneMapping,M.toneMapping=Ln,!0},this.hasRenderPass=function(){return v},this.end=function(M,T){M.toneMapping=m,f=!0;let x=o,w=l;for(let P=0;P<A.length;P++){let C=A[P];C.enabled!==!1&&(C.render(M,w,x,T),C.needsSwap!==!1&&(x=w,w=w===l?c:l))}if(_!==M.outputColorSpace||y!==M.toneMapping){_=M.outputColorSpace,y=M.toneMapping,p.defines={},qe.getTransfer(_)===Ke&&(p.defines.SRGB_TRANSFER="");let P=K_[y];P&&(p.defines[P]=""),p.needsUpdate=!0}p.uniforms.tDiffuse.value=x.texture,M.setRenderTarget(S),M.render(h,g),S=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){o.dispose(),l!==null&&l.dispose(),c!==null&&c.dispose(),d.dispose(),p.dispose()}}a(j_,"WebGLOutput");var bd=new Nt,wd=new xn(1,1),Ed=new Hr(1),Td=new Ur,Ad=new co,Rd=new Ci,nd=[],id=[],rd=new Float32Array(16),sd=new Float32Array(9),od=new Float32Array(4);function pr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,s=nd[r];if(s===void 0&&(s=new Float32Array(r),nd[r]=s),e!==0){n.toArray(s,0);for(let o=1,l=0;o!==e;++o)l+=t,i[o].toArray(s,l)}return s}a(pr,"flatten");function gt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}a(gt,"arraysEqual");function _t(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}a(_t,"copyArray");function ba(i,e){let t=id[e];t===void 0&&(t=new Int32Array(e),id[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}a(ba,"allocTexUnits");function Q_(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}a(Q_,"setValueV1f");function ex(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(gt(t,e))return;i.uniform2fv(this.addr,e),_t(t,e)}}a(ex,"setValueV2f");function tx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(gt(t,e))return;i.uniform3fv(this.addr,e),_t(t,e)}}a(tx,"setValueV3f");function nx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(gt(t,e))return;i.uniform4fv(this.addr,e),_t(t,e)}}a(nx,"setValueV4f");function ix(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(gt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),_t(t,e)}else{if(gt(t,n))return;od.set(n),i.uniformMatrix2fv(this.addr,!1,od),_t(t,n)}}a(ix,"setValueM2");function rx(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(gt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),_t(t,e)}else{if(gt(t,n))return;sd.set(n),i.uniformMatrix3fv(this.addr,!1,sd),_t(t,n)}}a(rx,"setValueM3");function sx(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(gt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),_t(t,e)}else{if(gt(t,n))return;rd.set(n),i.uniformMatrix4fv(this.addr,!1,rd),_t(t,n)}}a(sx,"setValueM4");function ox(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}a(ox,"setValueV1i");function ax(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(gt(t,e))return;i.uniform2iv(this.addr,e),_t(t,e)}}a(ax,"setValueV2i");function lx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(gt(t,e))return;i.uniform3iv(this.addr,e),_t(t,e)}}a(lx,"setValueV3i");function cx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(gt(t,e))return;i.uniform4iv(this.addr,e),_t(t,e)}}a(cx,"setValueV4i");function ux(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}a(ux,"setValueV1ui");function hx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(gt(t,e))return;i.uniform2uiv(this.addr,e),_t(t,e)}}a(hx,"setValueV2ui");function dx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(gt(t,e))return;i.uniform3uiv(this.addr,e),_t(t,e)}}a(dx,"setValueV3ui");function fx(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(gt(t,e))return;i.uniform4uiv(this.addr,e),_t(t,e)}}a(fx,"setValueV4ui");function wa(i){return i.version===0&&(i.compareFunction=ql,i.needsUpdate=!0),i}a(wa,"initShadowTexture");function px(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=wa(wd):s=bd,t.setTexture2D(e||s,r)}a(px,"setValueT1");function mx(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||Ad,r)}a(mx,"setValueT3D1");function gx(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=wa(Ed):s=Rd,t.setTextureCube(e||s,r)}a(gx,"setValueT6");function _x(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||Td,r)}a(_x,"setValueT2DArray1");function xx(i){switch(i){case 5126:return Q_;case 35664:return ex;case 35665:return tx;case 35666:return nx;case 35674:return ix;case 35675:return rx;case 35676:return sx;case 5124:case 35670:return ox;case 35667:case 35671:return ax;case 35668:case 35672:return lx;case 35669:case 35673:return cx;case 5125:return ux;case 36294:return hx;case 36295:return dx;case 36296:return fx;case 35678:case 36198:case 36298:case 36306:case 35682:return px;case 35679:case 36299:case 36307:return mx;case 35680:case 36300:case 36308:case 36293:return gx;case 36289:case 36303:case 36311:case 36292:return _x}}a(xx,"getSingularSetter");function yx(i,e){i.uniform1fv(this.addr,e)}a(yx,"setValueV1fArray");function vx(i,e){let t=pr(e,this.size,2);i.uniform2fv(this.addr,t)}a(vx,"setValueV2fArray");function Sx(i,e){let t=pr(e,this.size,3);i.uniform3fv(this.addr,t)}a(Sx,"setValueV3fArray");function Mx(i,e){let t=pr(e,this.size,4);i.uniform4fv(this.addr,t)}a(Mx,"setValueV4fArray");function bx(i,e){let t=pr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}a(bx,"setValueM2Array");function wx(i,e){let t=pr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}a(wx,"setValueM3Array");function Ex(i,e){let t=pr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}a(Ex,"setValueM4Array");function Tx(i,e){i.uniform1iv(this.addr,e)}a(Tx,"setValueV1iArray");function Ax(i,e){i.uniform2iv(this.addr,e)}a(Ax,"setValueV2iArray");function Rx(i,e){i.uniform3iv(this.addr,e)}a(Rx,"setValueV3iArray");function Cx(i,e){i.uniform4iv(this.addr,e)}a(Cx,"setValueV4iArray");function Px(i,e){i.uniform1uiv(this.addr,e)}a(Px,"setValueV1uiArray");function Ix(i,e){i.uniform2uiv(this.addr,e)}a(Ix,"setValueV2uiArray");function Lx(i,e){i.uniform3uiv(this.addr,e)}a(Lx,"setValueV3uiArray");function Nx(i,e){i.uniform4uiv(this.addr,e)}a(Nx,"setValueV4uiArray");function Dx(i,e,t){let n=this.cache,r=e.length,s=ba(t,r);gt(n,s)||(i.uniform1iv(this.addr,s),_t(n,s));let o;this.type===i.SAMPLER_2D_SHADOW?o=wa(wd):o=bd;for(let l=0;l!==r;++l)t.setTexture2D(e[l]||o,s[l])}a(Dx,"setValueT1Array");function Ux(i,e,t){let n=this.cache,r=e.length,s=ba(t,r);gt(n,s)||(i.uniform1iv(this.addr,s),_t(n,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||Ad,s[o])}a(Ux,"setValueT3DArray");function Fx(i,e,t){let n=this.cache,r=e.length,s=ba(t,r);gt(n,s)||(i.uniform1iv(this.addr,s),_t(n,s));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=wa(Ed):o=Rd;for(let l=0;l!==r;++l)t.setTextureCube(e[l]||o,s[l])}a(Fx,"setValueT6Array");function Ox(i,e,t){let n=this.cache,r=e.length,s=ba(t,r);gt(n,s)||(i.uniform1iv(this.addr,s),_t(n,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||Td,s[o])}a(Ox,"setValueT2DArrayArray");function Bx(i){switch(i){case 5126:return yx;case 35664:return vx;case 35665:return Sx;case 35666:return Mx;case 35674:return bx;case 35675:return wx;case 35676:return Ex;case 5124:case 35670:return Tx;case 35667:case 35671:return Ax;case 35668:case 35672:return Rx;case 35669:case 35673:return Cx;case 5125:return Px;case 36294:return Ix;case 36295:return Lx;case 36296:return Nx;case 35678:case 36198:case 36298:case 36306:case 35682:return Dx;case 35679:case 36299:case 36307:return Ux;case 35680:case 36300:case 36308:case 36293:return Fx;case 36289:case 36303:case 36311:case 36292:return Ox}}a(Bx,"getPureArraySetter");var ec=class{static{a(this,"SingleUniform")}constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=xx(t.type)}},tc=class{static{a(this,"PureArrayUniform")}constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Bx(t.type)}},nc=class{static{a(this,"StructuredUniform")}constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let l=r[s];l.setValue(e,t[l.id],n)}}},jl=/(\w+)(\])?(\[|\.)?/g;function ad(i,e){i.seq.push(e),i.map[e.id]=e}a(ad,"addUniform");function kx(i,e,t){let n=i.name,r=n.length;for(jl.lastIndex=0;;){let s=jl.exec(n),o=jl.lastIndex,l=s[1],c=s[2]==="]",u=s[3];if(c&&(l=l|0),u===void 0||u==="["&&o+2===r){ad(t,u===void 0?new ec(l,i,e):new tc(l,i,e));break}else{let p=t.map[l];p===void 0&&(p=new nc(l),ad(t,p)),t=p}}}a(kx,"parseUniform");var fr=class{static{a(this,"WebGLUniforms")}constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let l=e.getActiveUniform(t,o),c=e.getUniformLocation(t,l.name);kx(l,c,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,n,r){let s=this.map[t];s!==void 0&&s.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let s=0,o=t.length;s!==o;++s){let l=t[s],c=n[l.id];c.needsUpdate!==!1&&l.setValue(e,c.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&n.push(o)}return n}};function ld(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}a(ld,"WebGLShader");var zx=37297,Gx=0;function Vx(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let l=o+1;n.push(`${l===e?">":" "} ${l}: ${t[o]}`)}return n.join(`
`)}a(Vx,"handleSource");var cd=new De;function Hx(i){qe._getMatrix(cd,qe.workingColorSpace,i);let e=`mat3( ${cd.elements.map(t=>t.toFixed(4))} )`;switch(qe.getTransfer(i)){case Ir:return[e,"LinearTransferOETF"];case Ke:return[e,"sRGBTransferOETF"];default:return Pe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}a(Hx,"getEncodingComponents");function ud(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),s=(i.getShaderInfoLog(e)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let l=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+Vx(i.getShaderSource(e),l)}else return s}a(ud,"getShaderErrors");function Wx(i,e){let t=Hx(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}a(Wx,"getTexelEncodingFunction");var Xx={[Pl]:"Linear",[Il]:"Reinhard",[Ll]:"Cineon",[Nl]:"ACESFilmic",[Ul]:"AgX",[Fl]:"Neutral",[Dl]:"Custom"};function qx(i,e){let t=Xx[e];return t===void 0?(Pe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}a(qx,"getToneMappingFunction");var va=new H;function Yx(){qe.getLuminanceCoefficients(va);let i=va.x.toFixed(4),e=va.y.toFixed(4),t=va.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}a(Yx,"getLuminanceFunction");function $x(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(hs).join(`
`)}a($x,"generateVertexExtensions");function Jx(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}a(Jx,"generateDefines");function Zx(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(e,r),o=s.name,l=1;s.type===i.FLOAT_MAT2&&(l=2),s.type===i.FLOAT_MAT3&&(l=3),s.type===i.FLOAT_MAT4&&(l=4),t[o]={type:s.type,location:i.getAttribLocation(e,o),locationSize:l}}return t}a(Zx,"fetchAttributeLocations");function hs(i){return i!==""}a(hs,"filterEmptyLine");function hd(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}a(hd,"replaceLightNums");function dd(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}a(dd,"replaceClippingPlaneNums");var Kx=/^[ \t]*#include +<([\w\d./]+)>/gm;function ic(i){return i.replace(Kx,jx)}a(ic,"resolveIncludes");function jx(i,e){let t=ze[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return ic(t)}a(jx,"includeReplacer");var Qx=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function fd(i){return i.replace(Qx,ey)}a(fd,"unrollLoops");function ey(i,e,t,n){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}a(ey,"loopReplacer");function pd(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}a(pd,"generatePrecision");var ty={[ts]:"SHADOWMAP_TYPE_PCF",[ar]:"SHADOWMAP_TYPE_VSM"};function ny(i){return ty[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}a(ny,"generateShadowMapTypeDefine");var iy={[hr]:"ENVMAP_MODE_REFRACTION"};function ry(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":iy[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}a(ry,"generateEnvMapModeDefine");var sy={[Po]:"ENVMAP_BLENDING_MULTIPLY",[Ph]:"ENVMAP_BLENDING_MIX",[Ih]:"ENVMAP_BLENDING_ADD"};function oy(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":sy[i.combine]||"ENVMAP_BLENDING_NONE"}a(oy,"generateEnvMapBlendingDefine");function ay(i,e,t,n){let r=i.getContext(),s=t.defines,o=t.vertexShader,l=t.fragmentShader,c=ny(t),u=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",d=ry(t),p=oy(t),h=$x(t),g=Jx(s),_=r.createProgram(),y,f,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(hs).join(`
`),y.length>0&&(y+=`
`),f=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(hs).join(`
`),f.length>0&&(f+=`
`)):(y=[pd(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+d:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(hs).join(`
`),f=[pd(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMap?"#define "+p:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Ln?"#define TONE_MAPPING":"",t.toneMapping!==Ln?ze.tonemapping_pars_fragment:"",t.toneMapping!==Ln?qx("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ze.colorspace_pars_fragment,Wx("linearToOutputTexel",t.outputColorSpace),Yx(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(hs).join(`
`)),o=ic(o),o=hd(o,t),o=dd(o,t),l=ic(l),l=hd(l,t),l=dd(l,t),o=fd(o),l=fd(l),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,f=["#define varying in",t.glslVersion===Jn?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Jn?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let S=m+y+o,A=m+f+l,v=ld(r,r.VERTEX_SHADER,S),M=ld(r,r.FRAGMENT_SHADER,A);r.attachShader(_,v),r.attachShader(_,M),t.index0AttributeName!==void 0?r.bindAttribLocation(_,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(_,0,"position"),r.linkProgram(_);function T(C){if(i.debug.checkShaderErrors){let D=r.getProgramInfoLog(_)||"",B=r.getShaderInfoLog(v)||"",X=r.getShaderInfoLog(M)||"",L=D.trim(),q=B.trim(),O=X.trim(),z=!0,te=!0;if(r.getProgramParameter(_,r.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,_,v,M);else{let Y=ud(r,v,"vertex"),ee=ud(r,M,"fragment");Ne("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(_,r.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+L+`
`+Y+`
`+ee)}else L!==""?Pe("WebGLProgram: Program Info Log:",L):(q===""||O==="")&&(te=!1);te&&(C.diagnostics={runnable:z,programLog:L,vertexShader:{log:q,prefix:y},fragmentShader:{log:O,prefix:f}})}r.deleteShader(v),r.deleteShader(M),x=new fr(r,_),w=Zx(r,_)}a(T,"onFirstUse");let x;this.getUniforms=function(){return x===void 0&&T(this),x};let w;this.getAttributes=function(){return w===void 0&&T(this),w};let P=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return P===!1&&(P=r.getProgramParameter(_,zx)),P},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(_),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Gx++,this.cacheKey=e,this.usedTimes=1,this.program=_,this.vertexShader=v,this.fragmentShader=M,this}a(ay,"WebGLProgram");var ly=0,rc=class{static{a(this,"WebGLShaderCache")}constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new sc(e),t.set(e,n)),n}},sc=class{static{a(this,"WebGLShaderStage")}constructor(e){this.id=ly++,this.code=e,this.usedTimes=0}};function cy(i){return i===fi||i===ls||i===cs}a(cy,"isPackedRGFormat");function uy(i,e,t,n,r,s){let o=new Fr,l=new rc,c=new Set,u=[],d=new Map,p=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function g(x){return c.add(x),x===0?"uv":`uv${x}`}a(g,"getChannel");function _(x,w,P,C,D,B){let X=C.fog,L=D.geometry,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?C.environment:null,O=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||q,O),te=h[x.type],Y=n.precision;x.precision!==null&&(Y=n.getMaxPrecision(x.precision),Y!==x.precision&&Pe("WebGLProgram.getParameters:",x.precision,"not supported, using",Y,"instead."));let ee=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ne=ee!==void 0?ee.length:0,Me=0;L.morphAttributes.position!==void 0&&(Me=1),L.morphAttributes.normal!==void 0&&(Me=2),L.morphAttributes.color!==void 0&&(Me=3);let Ie,F,J,ie;if(te){let ge=Dn[te];Ie=ge.vertexShader,F=ge.fragmentShader}else{Ie=x.vertexShader,F=x.fragmentShader;let ge=l.getVertexShaderStage(x),je=l.getFragmentShaderStage(x);l.update(x,ge,je),J=ge.id,ie=je.id}let ve=i.getRenderTarget(),ae=i.state.buffers.depth.getReversed(),Le=D.isInstancedMesh===!0,rt=D.isBatchedMesh===!0,Te=!!x.map,Ve=!!x.matcap,et=!!z,He=et&&z.isPMREMTexture===!0,wt=!!x.aoMap,pt=!!x.lightMap,Ht=!!x.bumpMap&&x.wireframe===!1,lt=!!x.normalMap,bn=!!x.displacementMap,xt=!!x.emissiveMap,en=!!x.metalnessMap,tn=!!x.roughnessMap,nn=x.anisotropy>0,U=x.clearcoat>0,rn=x.diffuseRoughness>0,ot=x.dispersion>0,at=x.retroreflectivity>0,me=x.iridescence>0,mt=x.sheen>0,Ce=x.transmission>0,Ue=nn&&!!x.anisotropyMap,R=U&&!!x.clearcoatMap,b=U&&!!x.clearcoatNormalMap,G=U&&!!x.clearcoatRoughnessMap,re=rn&&!!x.diffuseRoughnessMap,Q=me&&!!x.iridescenceMap,le=me&&!!x.iridescenceThicknessMap,fe=mt&&!!x.sheenColorMap,Z=mt&&!!x.sheenRoughnessMap,K=!!x.specularMap,ue=!!x.specularColorMap,I=!!x.specularIntensityMap,j=Ce&&!!x.transmissionMap,$=Ce&&!!x.thicknessMap,he=!!x.gradientMap,oe=!!x.alphaMap,ce=x.alphaTest>0,Ae=!!x.alphaHash,Be=!!x.extensions,se=Ln;x.toneMapped&&(ve===null||ve.isXRRenderTarget===!0)&&(se=i.toneMapping);let Re=He?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,Oe={shaderID:te,shaderType:x.type,shaderName:x.name,vertexShader:Ie,fragmentShader:F,defines:x.defines,customVertexShaderID:J,customFragmentShaderID:ie,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Y,batching:rt,batchingColor:rt&&D._colorsTexture!==null,instancing:Le,instancingColor:Le&&D.instanceColor!==null,instancingMorph:Le&&D.morphTexture!==null,outputColorSpace:ve===null?i.outputColorSpace:ve.isXRRenderTarget===!0?ve.texture.colorSpace:qe.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Te,matcap:Ve,envMap:et,envMapMode:et&&z.mapping,envMapPMREM:He,envMapMaxLod:He?Re.length-1:null,envMapSize:He?Re[0].width:null,aoMap:wt,lightMap:pt,bumpMap:Ht,normalMap:lt,displacementMap:bn,emissiveMap:xt,normalMapObjectSpace:lt&&x.normalMapType===Dh,normalMapTangentSpace:lt&&x.normalMapType===_a,packedNormalMap:lt&&x.normalMapType===_a&&cy(x.normalMap.format),metalnessMap:en,roughnessMap:tn,anisotropy:nn,anisotropyMap:Ue,clearcoat:U,clearcoatMap:R,clearcoatNormalMap:b,clearcoatRoughnessMap:G,diffuseRoughness:rn,diffuseRoughnessMap:re,dispersion:ot,retroreflection:at,iridescence:me,iridescenceMap:Q,iridescenceThicknessMap:le,sheen:mt,sheenColorMap:fe,sheenRoughnessMap:Z,specularMap:K,specularColorMap:ue,specularIntensityMap:I,transmission:Ce,transmissionMap:j,thicknessMap:$,gradientMap:he,opaque:x.transparent===!1&&x.blending===lr&&x.alphaToCoverage===!1,alphaMap:oe,alphaTest:ce,alphaHash:Ae,combine:x.combine,mapUv:Te&&g(x.map.channel),aoMapUv:wt&&g(x.aoMap.channel),lightMapUv:pt&&g(x.lightMap.channel),bumpMapUv:Ht&&g(x.bumpMap.channel),normalMapUv:lt&&g(x.normalMap.channel),displacementMapUv:bn&&g(x.displacementMap.channel),emissiveMapUv:xt&&g(x.emissiveMap.channel),metalnessMapUv:en&&g(x.metalnessMap.channel),roughnessMapUv:tn&&g(x.roughnessMap.channel),anisotropyMapUv:Ue&&g(x.anisotropyMap.channel),clearcoatMapUv:R&&g(x.clearcoatMap.channel),clearcoatNormalMapUv:b&&g(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:G&&g(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:re&&g(x.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&g(x.iridescenceMap.channel),iridescenceThicknessMapUv:le&&g(x.iridescenceThicknessMap.channel),sheenColorMapUv:fe&&g(x.sheenColorMap.channel),sheenRoughnessMapUv:Z&&g(x.sheenRoughnessMap.channel),specularMapUv:K&&g(x.specularMap.channel),specularColorMapUv:ue&&g(x.specularColorMap.channel),specularIntensityMapUv:I&&g(x.specularIntensityMap.channel),transmissionMapUv:j&&g(x.transmissionMap.channel),thicknessMapUv:$&&g(x.thicknessMap.channel),alphaMapUv:oe&&g(x.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(lt||nn),vertexNormals:!!L.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!L.attributes.uv&&(Te||oe),fog:!!X,useFog:x.fog===!0,fogExp2:!!X&&X.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||L.attributes.normal===void 0&&lt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:p,reversedDepthBuffer:ae,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ne,morphTextureStride:Me,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:B.filter(ge=>ge.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&P.length>0,shadowMapType:i.shadowMap.type,toneMapping:se,decodeVideoTexture:Te&&x.map.isVideoTexture===!0&&qe.getTransfer(x.map.colorSpace)===Ke,decodeVideoTextureEmissive:xt&&x.emissiveMap.isVideoTexture===!0&&qe.getTransfer(x.emissiveMap.colorSpace)===Ke,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===cn,flipSided:x.side===Vt,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Be&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Be&&x.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Oe.vertexUv1s=c.has(1),Oe.vertexUv2s=c.has(2),Oe.vertexUv3s=c.has(3),c.clear(),Oe}a(_,"getParameters");function y(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let P in x.defines)w.push(P),w.push(x.defines[P]);return x.isRawShaderMaterial===!1&&(f(w,x),m(w,x),w.push(i.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}a(y,"getProgramCacheKey");function f(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapPMREM),x.push(w.envMapMaxLod),x.push(w.envMapSize),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.diffuseRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.numSunLights),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numSunLightShadows),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.numLightProbeGrids),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}a(f,"getProgramCacheKeyParameters");function m(x,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),x.push(o.mask)}a(m,"getProgramCacheKeyBooleans");function S(x){let w=h[x.type],P;if(w){let C=Dn[w];P=Jh.clone(C.uniforms)}else P=x.uniforms;return P}a(S,"getUniforms");function A(x,w){let P=d.get(w);return P!==void 0?++P.usedTimes:(P=new ay(i,w,x,r),u.push(P),d.set(w,P)),P}a(A,"acquireProgram");function v(x){if(--x.usedTimes===0){let w=u.indexOf(x);u[w]=u[u.length-1],u.pop(),d.delete(x.cacheKey),x.destroy()}}a(v,"releaseProgram");function M(x){l.remove(x)}a(M,"releaseShaderCache");function T(){l.dispose()}return a(T,"dispose"),{getParameters:_,getProgramCacheKey:y,getUniforms:S,acquireProgram:A,releaseProgram:v,releaseShaderCache:M,programs:u,dispose:T}}a(uy,"WebGLPrograms");function hy(){let i=new WeakMap;function e(o){return i.has(o)}a(e,"has");function t(o){let l=i.get(o);return l===void 0&&(l={},i.set(o,l)),l}a(t,"get");function n(o){i.delete(o)}a(n,"remove");function r(o,l,c){i.get(o)[l]=c}a(r,"update");function s(){i=new WeakMap}return a(s,"dispose"),{has:e,get:t,remove:n,update:r,dispose:s}}a(hy,"WebGLProperties");function dy(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}a(dy,"painterSortStable");function md(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}a(md,"reversePainterSortStable");function gd(){let i=[],e=0,t=[],n=[],r=[];function s(){e=0,t.length=0,n.length=0,r.length=0}a(s,"init");function o(h){let g=0;return h.isInstancedMesh&&(g+=2),h.isSkinnedMesh&&(g+=1),g}a(o,"materialVariant");function l(h,g,_,y,f,m){let S=i[e];return S===void 0?(S={id:h.id,object:h,geometry:g,material:_,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:f,group:m},i[e]=S):(S.id=h.id,S.object=h,S.geometry=g,S.material=_,S.materialVariant=o(h),S.groupOrder=y,S.renderOrder=h.renderOrder,S.z=f,S.group=m),e++,S}a(l,"getNextRenderItem");function c(h,g,_,y,f,m,S){S.reversedDepth===!0&&(f=-f);let A=l(h,g,_,y,f,m);_.transmission>0?n.push(A):_.transparent===!0?r.push(A):t.push(A)}a(c,"push");function u(h,g,_,y,f,m){let S=l(h,g,_,y,f,m);_.transmission>0?n.unshift(S):_.transparent===!0?r.unshift(S):t.unshift(S)}a(u,"unshift");function d(h,g){t.length>1&&t.sort(h||dy),n.length>1&&n.sort(g||md),r.length>1&&r.sort(g||md)}a(d,"sort");function p(){for(let h=e,g=i.length;h<g;h++){let _=i[h];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return a(p,"finish"),{opaque:t,transmissive:n,transparent:r,init:s,push:c,unshift:u,finish:p,sort:d}}a(gd,"WebGLRenderList");function fy(){let i=new WeakMap;function e(n,r){let s=i.get(n),o;return s===void 0?(o=new gd,i.set(n,[o])):r>=s.length?(o=new gd,s.push(o)):o=s[r],o}a(e,"get");function t(){i=new WeakMap}return a(t,"dispose"),{get:e,dispose:t}}a(fy,"WebGLRenderLists");function py(){let i={};return{get:a(function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new H,color:new ke};break;case"SpotLight":t={position:new H,direction:new H,color:new ke,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new H,color:new ke,distance:0,decay:0};break;case"HemisphereLight":t={direction:new H,skyColor:new ke,groundColor:new ke};break;case"RectAreaLight":t={color:new ke,position:new H,halfWidth:new H,halfHeight:new H};break}return i[e.id]=t,t},"get")}}a(py,"UniformsCache");function my(){let i={};return{get:a(function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ge,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t},"get")}}a(my,"ShadowUniformsCache");var gy=0;function _y(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}a(_y,"shadowCastingAndTexturingLightsFirst");function xy(i){let e=new py,t=my(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let u=0;u<9;u++)n.probe.push(new H);let r=new H,s=new Qe,o=new Qe;function l(u){let d=0,p=0,h=0;for(let B=0;B<9;B++)n.probe[B].set(0,0,0);let g=0,_=0,y=0,f=0,m=0,S=0,A=0,v=0,M=0,T=0,x=0,w=0,P=0,C=0;u.sort(_y);for(let B=0,X=u.length;B<X;B++){let L=u[B],q=L.color,O=L.intensity,z=L.distance,te=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===fi?te=L.shadow.map.texture:te=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)d+=q.r*O,p+=q.g*O,h+=q.b*O;else if(L.isLightProbe){for(let Y=0;Y<9;Y++)n.probe[Y].addScaledVector(L.sh.coefficients[Y],O);C++}else if(L.isSunLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let ee=L.shadow,ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),n.sunShadow[_]=ne,n.sunShadowMap[_]=te;let Me=ee.getViewportCount();for(let Ie=0;Ie<Me;Ie++)n.sunShadowMatrix[y+Ie]=ee.getMatrix(Ie),n.sunShadowCascade[y+Ie]=ee._cascadeData[Ie];y+=Me,_++}n.sun[g]=Y,g++}else if(L.isDirectionalLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let ee=L.shadow,ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,n.directionalShadow[f]=ne,n.directionalShadowMap[f]=te,n.directionalShadowMatrix[f]=L.shadow.matrix,M++}n.directional[f]=Y,f++}else if(L.isSpotLight){let Y=e.get(L);Y.position.setFromMatrixPosition(L.matrixWorld),Y.color.copy(q).multiplyScalar(O),Y.distance=z,Y.coneCos=Math.cos(L.angle),Y.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),Y.decay=L.decay,n.spot[S]=Y;let ee=L.shadow;if(L.map&&(n.spotLightMap[w]=L.map,w++,ee.updateMatrices(L),L.castShadow&&P++),n.spotLightMatrix[S]=ee.matrix,L.castShadow){let ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,n.spotShadow[S]=ne,n.spotShadowMap[S]=te,x++}S++}else if(L.isRectAreaLight){let Y=e.get(L);Y.color.copy(q).multiplyScalar(O),Y.halfWidth.set(L.width*.5,0,0),Y.halfHeight.set(0,L.height*.5,0),n.rectArea[A]=Y,A++}else if(L.isPointLight){let Y=e.get(L);if(Y.color.copy(L.color).multiplyScalar(L.intensity),Y.distance=L.distance,Y.decay=L.decay,L.castShadow){let ee=L.shadow,ne=t.get(L);ne.shadowIntensity=ee.intensity,ne.shadowBias=ee.bias,ne.shadowNormalBias=ee.normalBias,ne.shadowRadius=ee.radius,ne.shadowMapSize=ee.mapSize,ne.shadowCameraNear=ee.camera.near,ne.shadowCameraFar=ee.camera.far,n.pointShadow[m]=ne,n.pointShadowMap[m]=te,n.pointShadowMatrix[m]=L.shadow.matrix,T++}n.point[m]=Y,m++}else if(L.isHemisphereLight){let Y=e.get(L);Y.skyColor.copy(L.color).multiplyScalar(O),Y.groundColor.copy(L.groundColor).multiplyScalar(O),n.hemi[v]=Y,v++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=_e.LTC_FLOAT_1,n.rectAreaLTC2=_e.LTC_FLOAT_2):(n.rectAreaLTC1=_e.LTC_HALF_1,n.rectAreaLTC2=_e.LTC_HALF_2)),n.ambient[0]=d,n.ambient[1]=p,n.ambient[2]=h;let D=n.hash;(D.sunLength!==g||D.directionalLength!==f||D.pointLength!==m||D.spotLength!==S||D.rectAreaLength!==A||D.hemiLength!==v||D.numSunShadows!==_||D.numDirectionalShadows!==M||D.numPointShadows!==T||D.numSpotShadows!==x||D.numSpotMaps!==w||D.numLightProbes!==C)&&(n.sun.length=g,n.directional.length=f,n.spot.length=S,n.rectArea.length=A,n.point.length=m,n.hemi.length=v,n.sunShadow.length=_,n.sunShadowMap.length=_,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=M,n.directionalShadowMap.length=M,n.directionalShadowMatrix.length=M,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+w-P,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=P,n.numLightProbes=C,D.sunLength=g,D.directionalLength=f,D.pointLength=m,D.spotLength=S,D.rectAreaLength=A,D.hemiLength=v,D.numSunShadows=_,D.numDirectionalShadows=M,D.numPointShadows=T,D.numSpotShadows=x,D.numSpotMaps=w,D.numLightProbes=C,n.version=gy++)}a(l,"setup");function c(u,d){let p=0,h=0,g=0,_=0,y=0,f=0,m=d.matrixWorldInverse;for(let S=0,A=u.length;S<A;S++){let v=u[S];if(v.isSunLight){let M=n.sun[p];M.direction.setFromMatrixPosition(v.matrixWorld),M.direction.transformDirection(m),p++}else if(v.isDirectionalLight){let M=n.directional[h];M.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),M.direction.sub(r),M.direction.transformDirection(m),h++}else if(v.isSpotLight){let M=n.spot[_];M.position.setFromMatrixPosition(v.matrixWorld),M.position.applyMatrix4(m),M.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),M.direction.sub(r),M.direction.transformDirection(m),_++}else if(v.isRectAreaLight){let M=n.rectArea[y];M.position.setFromMatrixPosition(v.matrixWorld),M.position.applyMatrix4(m),o.identity(),s.copy(v.matrixWorld),s.premultiply(m),o.extractRotation(s),M.halfWidth.set(v.width*.5,0,0),M.halfHeight.set(0,v.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),y++}else if(v.isPointLight){let M=n.point[g];M.position.setFromMatrixPosition(v.matrixWorld),M.position.applyMatrix4(m),g++}else if(v.isHemisphereLight){let M=n.hemi[f];M.direction.setFromMatrixPosition(v.matrixWorld),M.direction.transformDirection(m),f++}}}return a(c,"setupView"),{setup:l,setupView:c,state:n}}a(xy,"WebGLLights");function _d(i){let e=new xy(i),t=[],n=[],r=[];function s(p){d.camera=p,t.length=0,n.length=0,r.length=0}a(s,"init");function o(p){p.isLightProbeGrid?r.push(p):t.push(p)}a(o,"pushLight");function l(p){n.push(p)}a(l,"pushShadow");function c(){e.setup(t),r.sort((p,h)=>p.priority-h.priority||p.id-h.id)}a(c,"setupLights");function u(p){e.setupView(t,p)}a(u,"setupLightsView");let d={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:d,setupLights:c,setupLightsView:u,pushLight:o,pushShadow:l}}a(_d,"WebGLRenderState");function yy(i){let e=new WeakMap;function t(r,s=0){let o=e.get(r),l;return o===void 0?(l=new _d(i),e.set(r,[l])):s>=o.length?(l=new _d(i),o.push(l)):l=o[s],l}a(t,"get");function n(){e=new WeakMap}return a(n,"dispose"),{get:t,dispose:n}}a(yy,"WebGLRenderStates");var vy=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Sy=`uniform sampler2D shadow_pass;
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
}`,My=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],by=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],xd=new Qe,us=new H,Ql=new H;function wy(i,e,t){let n=new Ri,r=new Ge,s=new Ge,o=new nt,l=new mo,c=new go,u={},d=t.maxTextureSize,p={[hi]:Vt,[Vt]:hi,[cn]:cn},h=new In({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ge},radius:{value:4}},vertexShader:vy,fragmentShader:Sy}),g=h.clone();g.defines.HORIZONTAL_PASS=1;let _=new Ut;_.setAttribute("position",new Tt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new ut(_,h),f=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ts;let m=this.type;this.render=function(T,x,w){if(f.enabled===!1||f.autoUpdate===!1&&f.needsUpdate===!1||T.length===0)return;this.type===fh&&(Pe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ts);let P=i.getRenderTarget(),C=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),B=i.state;B.setBlending(qn),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let X=m!==this.type;X&&x.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(q=>q.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,q=T.length;L<q;L++){let O=T[L],z=O.shadow;if(z===void 0){Pe("WebGLShadowMap:",O,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;r.copy(z.mapSize);let te=z.getFrameExtents();r.multiply(te),s.copy(z.mapSize),(r.x>d||r.y>d)&&(r.x>d&&(s.x=Math.floor(d/te.x),r.x=s.x*te.x,z.mapSize.x=s.x),r.y>d&&(s.y=Math.floor(d/te.y),r.y=s.y*te.y,z.mapSize.y=s.y));let Y=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=Y,z.map===null||X===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===ar){if(O.isPointLight){Pe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new Dt(r.x,r.y,{format:fi,type:Sn,minFilter:At,magFilter:At,generateMipmaps:!1}),z.map.texture.name=O.name+".shadowMap",z.map.depthTexture=new xn(r.x,r.y,un),z.map.depthTexture.name=O.name+".shadowMapDepth",z.map.depthTexture.format=Wn,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Mt,z.map.depthTexture.magFilter=Mt}else O.isPointLight?(z.map=new ds(r.x),z.map.depthTexture=new Hr(r.x,Qt)):(z.map=new Dt(r.x,r.y),z.map.depthTexture=new xn(r.x,r.y,Qt)),z.map.depthTexture.name=O.name+".shadowMap",z.map.depthTexture.format=Wn,this.type===ts?(z.map.depthTexture.compareFunction=Y?Xl:Wl,z.map.depthTexture.minFilter=At,z.map.depthTexture.magFilter=At):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Mt,z.map.depthTexture.magFilter=Mt);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==r.x||z.map.height!==r.y)&&z.map.setSize(r.x,r.y);let ee=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();O.isPointLight!==!0&&z.updateMatrices(O,w);let ne=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:w.layers;for(let Me=0;Me<ee;Me++){let Ie=z.getCamera(Me);if(O.isPointLight){let F=z.camera,J=z.matrix,ie=O.distance||F.far;ie!==F.far&&(F.far=ie,F.updateProjectionMatrix()),us.setFromMatrixPosition(O.matrixWorld),F.position.copy(us),Ql.copy(F.position),Ql.add(My[Me]),F.up.copy(by[Me]),F.lookAt(Ql),F.updateMatrixWorld(),J.makeTranslation(-us.x,-us.y,-us.z),xd.multiplyMatrices(F.projectionMatrix,F.matrixWorldInverse),z._frustum.setFromProjectionMatrix(xd,F.coordinateSystem,F.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,Me),i.clear();else{Me===0&&(i.setRenderTarget(z.map),i.clear());let F=z.getViewport(Me);o.set(s.x*F.x,s.y*F.y,s.x*F.z,s.y*F.w),B.viewport(o)}n=z.getFrustum(Me),v(x,w,Ie,O,ne,this.type)}z.isPointLightShadow!==!0&&this.type===ar&&S(z,w),z.needsUpdate=!1}m=this.type,f.needsUpdate=!1,i.setRenderTarget(P,C,D)};function S(T,x){let w=e.update(y);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,g.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,g.needsUpdate=!0),T.mapPass===null?T.mapPass=new Dt(r.x,r.y,{format:fi,type:Sn}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value.set(T.map.width,T.map.height),h.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(x,null,w,h,y,null),g.uniforms.shadow_pass.value=T.mapPass.texture,g.uniforms.resolution.value.set(T.map.width,T.map.height),g.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(x,null,w,g,y,null)}a(S,"VSMPass");function A(T,x,w,P){let C=null,D=w.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(D!==void 0)C=D;else if(C=w.isPointLight===!0?c:l,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let B=C.uuid,X=x.uuid,L=u[B];L===void 0&&(L={},u[B]=L);let q=L[X];q===void 0&&(q=C.clone(),L[X]=q,x.addEventListener("dispose",M)),C=q}if(C.visible=x.visible,C.wireframe=x.wireframe,P===ar?C.side=x.shadowSide!==null?x.shadowSide:x.side:C.side=x.shadowSide!==null?x.shadowSide:p[x.side],C.alphaMap=x.alphaMap,C.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,C.map=x.map,C.clipShadows=x.clipShadows,C.clippingPlanes=x.clippingPlanes,C.clipIntersection=x.clipIntersection,C.displacementMap=x.displacementMap,C.displacementScale=x.displacementScale,C.displacementBias=x.displacementBias,C.wireframeLinewidth=x.wireframeLinewidth,C.linewidth=x.linewidth,w.isPointLight===!0&&C.isMeshDistanceMaterial===!0){let B=i.properties.get(C);B.light=w}return C}a(A,"getDepthMaterial");function v(T,x,w,P,C,D){if(T.visible===!1)return;if(T.layers.test(C)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&D===ar)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,T.matrixWorld);let L=e.update(T),q=T.material;if(Array.isArray(q)){let O=L.groups;for(let z=0,te=O.length;z<te;z++){let Y=O[z],ee=q[Y.materialIndex];if(ee&&ee.visible){let ne=A(T,ee,P,D);T.onBeforeShadow(i,T,x,w,L,ne,Y),i.renderBufferDirect(w,null,L,ne,T,Y),T.onAfterShadow(i,T,x,w,L,ne,Y)}}}else if(q.visible){let O=A(T,q,P,D);T.onBeforeShadow(i,T,x,w,L,O,null),i.renderBufferDirect(w,null,L,O,T,null),T.onAfterShadow(i,T,x,w,L,O,null)}}let X=T.children;for(let L=0,q=X.length;L<q;L++)v(X[L],x,w,P,C,D)}a(v,"renderObject");function M(T){T.target.removeEventListener("dispose",M);for(let w in u){let P=u[w],C=T.target.uuid;C in P&&(P[C].dispose(),delete P[C])}}a(M,"onMaterialDispose")}a(wy,"WebGLShadowMap");function Ey(i,e){function t(){let I=!1,j=new nt,$=null,he=new nt(0,0,0,0);return{setMask:a(function(oe){$!==oe&&!I&&(i.colorMask(oe,oe,oe,oe),$=oe)},"setMask"),setLocked:a(function(oe){I=oe},"setLocked"),setClear:a(function(oe,ce,Ae,Be,se){se===!0&&(oe*=Be,ce*=Be,Ae*=Be),j.set(oe,ce,Ae,Be),he.equals(j)===!1&&(i.clearColor(oe,ce,Ae,Be),he.copy(j))},"setClear"),reset:a(function(){I=!1,$=null,he.set(-1,0,0,0)},"reset")}}a(t,"ColorBuffer");function n(){let I=!1,j=!1,$=null,he=null,oe=null;return{setReversed:a(function(ce){if(j!==ce){let Ae=e.get("EXT_clip_control");ce?Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.ZERO_TO_ONE_EXT):Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.NEGATIVE_ONE_TO_ONE_EXT),j=ce;let Be=oe;oe=null,this.setClear(Be)}},"setReversed"),getReversed:a(function(){return j},"getReversed"),setTest:a(function(ce){ce?ae(i.DEPTH_TEST):Le(i.DEPTH_TEST)},"setTest"),setMask:a(function(ce){$!==ce&&!I&&(i.depthMask(ce),$=ce)},"setMask"),setFunc:a(function(ce){if(j&&(ce=Wh[ce]),he!==ce){switch(ce){case Ks:i.depthFunc(i.NEVER);break;case js:i.depthFunc(i.ALWAYS);break;case Qs:i.depthFunc(i.LESS);break;case Qi:i.depthFunc(i.LEQUAL);break;case eo:i.depthFunc(i.EQUAL);break;case to:i.depthFunc(i.GEQUAL);break;case no:i.depthFunc(i.GREATER);break;case io:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}he=ce}},"setFunc"),setLocked:a(function(ce){I=ce},"setLocked"),setClear:a(function(ce){oe!==ce&&(oe=ce,j&&(ce=1-ce),i.clearDepth(ce))},"setClear"),reset:a(function(){I=!1,$=null,he=null,oe=null,j=!1},"reset")}}a(n,"DepthBuffer");function r(){let I=!1,j=null,$=null,he=null,oe=null,ce=null,Ae=null,Be=null,se=null;return{setTest:a(function(Re){I||(Re?ae(i.STENCIL_TEST):Le(i.STENCIL_TEST))},"setTest"),setMask:a(function(Re){j!==Re&&!I&&(i.stencilMask(Re),j=Re)},"setMask"),setFunc:a(function(Re,Oe,ge){($!==Re||he!==Oe||oe!==ge)&&(i.stencilFunc(Re,Oe,ge),$=Re,he=Oe,oe=ge)},"setFunc"),setOp:a(function(Re,Oe,ge){(ce!==Re||Ae!==Oe||Be!==ge)&&(i.stencilOp(Re,Oe,ge),ce=Re,Ae=Oe,Be=ge)},"setOp"),setLocked:a(function(Re){I=Re},"setLocked"),setClear:a(function(Re){se!==Re&&(i.clearStencil(Re),se=Re)},"setClear"),reset:a(function(){I=!1,j=null,$=null,he=null,oe=null,ce=null,Ae=null,Be=null,se=null},"reset")}}a(r,"StencilBuffer");let s=new t,o=new n,l=new r,c={},u=new WeakMap,d={},p={},h={},g=new WeakMap,_=[],y=null,f=!1,m=null,S=null,A=null,v=null,M=null,T=null,x=null,w=new ke(0,0,0),P=0,C=!1,D=null,B=null,X=null,L=null,q=null,O=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,te=0,Y=i.getParameter(i.VERSION);Y.indexOf("WebGL")!==-1?(te=parseFloat(/^WebGL (\d)/.exec(Y)[1]),z=te>=1):Y.indexOf("OpenGL ES")!==-1&&(te=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),z=te>=2);let ee=null,ne={},Me=i.getParameter(i.SCISSOR_BOX),Ie=i.getParameter(i.VIEWPORT),F=new nt().fromArray(Me),J=new nt().fromArray(Ie);function ie(I,j,$,he){let oe=new Uint8Array(4),ce=i.createTexture();i.bindTexture(I,ce),i.texParameteri(I,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(I,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ae=0;Ae<$;Ae++)I===i.TEXTURE_3D||I===i.TEXTURE_2D_ARRAY?i.texImage3D(j,0,i.RGBA,1,1,he,0,i.RGBA,i.UNSIGNED_BYTE,oe):i.texImage2D(j+Ae,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,oe);return ce}a(ie,"createTexture");let ve={};ve[i.TEXTURE_2D]=ie(i.TEXTURE_2D,i.TEXTURE_2D,1),ve[i.TEXTURE_CUBE_MAP]=ie(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ve[i.TEXTURE_2D_ARRAY]=ie(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ve[i.TEXTURE_3D]=ie(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),l.setClear(0),ae(i.DEPTH_TEST),o.setFunc(Qi),Ht(!1),lt(Tl),ae(i.CULL_FACE),wt(qn);function ae(I){d[I]!==!0&&(i.enable(I),d[I]=!0)}a(ae,"enable");function Le(I){d[I]!==!1&&(i.disable(I),d[I]=!1)}a(Le,"disable");function rt(I,j){return h[I]!==j?(i.bindFramebuffer(I,j),h[I]=j,I===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=j),I===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=j),!0):!1}a(rt,"bindFramebuffer");function Te(I,j){let $=_,he=!1;if(I){$=g.get(j),$===void 0&&($=[],g.set(j,$));let oe=I.textures;if($.length!==oe.length||$[0]!==i.COLOR_ATTACHMENT0){for(let ce=0,Ae=oe.length;ce<Ae;ce++)$[ce]=i.COLOR_ATTACHMENT0+ce;$.length=oe.length,he=!0}}else $[0]!==i.BACK&&($[0]=i.BACK,he=!0);he&&i.drawBuffers($)}a(Te,"drawBuffers");function Ve(I){return y!==I?(i.useProgram(I),y=I,!0):!1}a(Ve,"useProgram");let et={[Pi]:i.FUNC_ADD,[ph]:i.FUNC_SUBTRACT,[mh]:i.FUNC_REVERSE_SUBTRACT};et[gh]=i.MIN,et[_h]=i.MAX;let He={[xh]:i.ZERO,[ur]:i.ONE,[yh]:i.SRC_COLOR,[ns]:i.SRC_ALPHA,[Eh]:i.SRC_ALPHA_SATURATE,[bh]:i.DST_COLOR,[Sh]:i.DST_ALPHA,[vh]:i.ONE_MINUS_SRC_COLOR,[di]:i.ONE_MINUS_SRC_ALPHA,[wh]:i.ONE_MINUS_DST_COLOR,[Mh]:i.ONE_MINUS_DST_ALPHA,[Th]:i.CONSTANT_COLOR,[Ah]:i.ONE_MINUS_CONSTANT_COLOR,[Rh]:i.CONSTANT_ALPHA,[Ch]:i.ONE_MINUS_CONSTANT_ALPHA};function wt(I,j,$,he,oe,ce,Ae,Be,se,Re){if(I===qn){f===!0&&(Le(i.BLEND),f=!1);return}if(f===!1&&(ae(i.BLEND),f=!0),I!==cr){if(I!==m||Re!==C){if((S!==Pi||M!==Pi)&&(i.blendEquation(i.FUNC_ADD),S=Pi,M=Pi),Re)switch(I){case lr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Al:i.blendFunc(i.ONE,i.ONE);break;case Rl:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Cl:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ne("WebGLState: Invalid blending: ",I);break}else switch(I){case lr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Al:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Rl:Ne("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cl:Ne("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ne("WebGLState: Invalid blending: ",I);break}A=null,v=null,T=null,x=null,w.set(0,0,0),P=0,m=I,C=Re}return}oe=oe||j,ce=ce||$,Ae=Ae||he,(j!==S||oe!==M)&&(i.blendEquationSeparate(et[j],et[oe]),S=j,M=oe),($!==A||he!==v||ce!==T||Ae!==x)&&(i.blendFuncSeparate(He[$],He[he],He[ce],He[Ae]),A=$,v=he,T=ce,x=Ae),(Be.equals(w)===!1||se!==P)&&(i.blendColor(Be.r,Be.g,Be.b,se),w.copy(Be),P=se),m=I,C=!1}a(wt,"setBlending");function pt(I,j){I.side===cn?Le(i.CULL_FACE):ae(i.CULL_FACE);let $=I.side===Vt;j&&($=!$),Ht($),I.blending===lr&&I.transparent===!1?wt(qn):wt(I.blending,I.blendEquation,I.blendSrc,I.blendDst,I.blendEquationAlpha,I.blendSrcAlpha,I.blendDstAlpha,I.blendColor,I.blendAlpha,I.premultipliedAlpha),o.setFunc(I.depthFunc),o.setTest(I.depthTest),o.setMask(I.depthWrite),s.setMask(I.colorWrite);let he=I.stencilWrite;l.setTest(he),he&&(l.setMask(I.stencilWriteMask),l.setFunc(I.stencilFunc,I.stencilRef,I.stencilFuncMask),l.setOp(I.stencilFail,I.stencilZFail,I.stencilZPass)),xt(I.polygonOffset,I.polygonOffsetFactor,I.polygonOffsetUnits),I.alphaToCoverage===!0?ae(i.SAMPLE_ALPHA_TO_COVERAGE):Le(i.SAMPLE_ALPHA_TO_COVERAGE)}a(pt,"setMaterial");function Ht(I){D!==I&&(I?i.frontFace(i.CW):i.frontFace(i.CCW),D=I)}a(Ht,"setFlipSided");function lt(I){I!==hh?(ae(i.CULL_FACE),I!==B&&(I===Tl?i.cullFace(i.BACK):I===dh?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Le(i.CULL_FACE),B=I}a(lt,"setCullFace");function bn(I){I!==X&&(z&&i.lineWidth(I),X=I)}a(bn,"setLineWidth");function xt(I,j,$){I?(ae(i.POLYGON_OFFSET_FILL),(L!==j||q!==$)&&(L=j,q=$,o.getReversed()&&(j=-j,$=-$),i.polygonOffset(j,$))):Le(i.POLYGON_OFFSET_FILL)}a(xt,"setPolygonOffset");function en(I){I?ae(i.SCISSOR_TEST):Le(i.SCISSOR_TEST)}a(en,"setScissorTest");function tn(I){I===void 0&&(I=i.TEXTURE0+O-1),ee!==I&&(i.activeTexture(I),ee=I)}a(tn,"activeTexture");function nn(I,j,$){$===void 0&&(ee===null?$=i.TEXTURE0+O-1:$=ee);let he=ne[$];he===void 0&&(he={type:void 0,texture:void 0},ne[$]=he),(he.type!==I||he.texture!==j)&&(ee!==$&&(i.activeTexture($),ee=$),i.bindTexture(I,j||ve[I]),he.type=I,he.texture=j)}a(nn,"bindTexture");function U(){let I=ne[ee];I!==void 0&&I.type!==void 0&&(i.bindTexture(I.type,null),I.type=void 0,I.texture=void 0)}a(U,"unbindTexture");function rn(){try{i.compressedTexImage2D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(rn,"compressedTexImage2D");function ot(){try{i.compressedTexImage3D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(ot,"compressedTexImage3D");function at(){try{i.texSubImage2D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(at,"texSubImage2D");function me(){try{i.texSubImage3D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(me,"texSubImage3D");function mt(){try{i.compressedTexSubImage2D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(mt,"compressedTexSubImage2D");function Ce(){try{i.compressedTexSubImage3D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(Ce,"compressedTexSubImage3D");function Ue(){try{i.texStorage2D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(Ue,"texStorage2D");function R(){try{i.texStorage3D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(R,"texStorage3D");function b(){try{i.texImage2D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(b,"texImage2D");function G(){try{i.texImage3D(...arguments)}catch(I){Ne("WebGLState:",I)}}a(G,"texImage3D");function re(I){return p[I]!==void 0?p[I]:i.getParameter(I)}a(re,"getParameter");function Q(I,j){p[I]!==j&&(i.pixelStorei(I,j),p[I]=j)}a(Q,"pixelStorei");function le(I){F.equals(I)===!1&&(i.scissor(I.x,I.y,I.z,I.w),F.copy(I))}a(le,"scissor");function fe(I){J.equals(I)===!1&&(i.viewport(I.x,I.y,I.z,I.w),J.copy(I))}a(fe,"viewport");function Z(I,j){let $=u.get(j);$===void 0&&($=new WeakMap,u.set(j,$));let he=$.get(I);he===void 0&&(he=i.getUniformBlockIndex(j,I.name),i.uniformBlockBinding(j,he,he),$.set(I,he))}a(Z,"updateUBOMapping");function K(I,j,$){let oe=u.get(j).get(I);c[oe]!==$&&(i.bindBufferBase(i.UNIFORM_BUFFER,oe,$),c[oe]=$)}a(K,"uniformBlockBinding");function ue(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),d={},p={},ee=null,ne={},h={},c={},g=new WeakMap,_=[],y=null,f=!1,m=null,S=null,A=null,v=null,M=null,T=null,x=null,w=new ke(0,0,0),P=0,C=!1,D=null,B=null,X=null,L=null,q=null,F.set(0,0,i.canvas.width,i.canvas.height),J.set(0,0,i.canvas.width,i.canvas.height),s.reset(),o.reset(),l.reset()}return a(ue,"reset"),{buffers:{color:s,depth:o,stencil:l},enable:ae,disable:Le,bindFramebuffer:rt,drawBuffers:Te,useProgram:Ve,setBlending:wt,setMaterial:pt,setFlipSided:Ht,setCullFace:lt,setLineWidth:bn,setPolygonOffset:xt,setScissorTest:en,activeTexture:tn,bindTexture:nn,unbindTexture:U,compressedTexImage2D:rn,compressedTexImage3D:ot,texImage2D:b,texImage3D:G,pixelStorei:Q,getParameter:re,updateUBOMapping:Z,uniformBlockBinding:K,texStorage2D:Ue,texStorage3D:R,texSubImage2D:at,texSubImage3D:me,compressedTexSubImage2D:mt,compressedTexSubImage3D:Ce,scissor:le,viewport:fe,reset:ue}}a(Ey,"WebGLState");function Ty(i,e,t,n,r,s,o){let l=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),u=new Ge,d=new WeakMap,p=new Set,h,g=new WeakMap,_=new Set,y=new FinalizationRegistry(R=>_.delete(R)),f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,b){return f?new OffscreenCanvas(R,b):Nr("canvas")}a(m,"createCanvas");function S(R,b,G){let re=1,Q=Ue(R);if((Q.width>G||Q.height>G)&&(re=G/Math.max(Q.width,Q.height)),re<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let le=Math.floor(re*Q.width),fe=Math.floor(re*Q.height);h===void 0&&(h=m(le,fe));let Z=b?m(le,fe):h;return Z.width=le,Z.height=fe,Z.getContext("2d").drawImage(R,0,0,le,fe),Pe("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+le+"x"+fe+")."),Z}else return"data"in R&&Pe("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),R;return R}a(S,"resizeImage");function A(R){return R.generateMipmaps}a(A,"textureNeedsGenerateMipmaps");function v(R){i.generateMipmap(R)}a(v,"generateMipmap");function M(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}a(M,"getTargetType");function T(R,b,G,re,Q,le=!1){if(R!==null){if(i[R]!==void 0)return i[R];Pe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let fe;re&&(fe=e.get("EXT_texture_norm16"),fe||Pe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=b;if(b===i.RED&&(G===i.FLOAT&&(Z=i.R32F),G===i.HALF_FLOAT&&(Z=i.R16F),G===i.UNSIGNED_BYTE&&(Z=i.R8),G===i.UNSIGNED_SHORT&&fe&&(Z=fe.R16_EXT),G===i.SHORT&&fe&&(Z=fe.R16_SNORM_EXT)),b===i.RED_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.R8UI),G===i.UNSIGNED_SHORT&&(Z=i.R16UI),G===i.UNSIGNED_INT&&(Z=i.R32UI),G===i.BYTE&&(Z=i.R8I),G===i.SHORT&&(Z=i.R16I),G===i.INT&&(Z=i.R32I)),b===i.RG&&(G===i.FLOAT&&(Z=i.RG32F),G===i.HALF_FLOAT&&(Z=i.RG16F),G===i.UNSIGNED_BYTE&&(Z=i.RG8),G===i.UNSIGNED_SHORT&&fe&&(Z=fe.RG16_EXT),G===i.SHORT&&fe&&(Z=fe.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.RG8UI),G===i.UNSIGNED_SHORT&&(Z=i.RG16UI),G===i.UNSIGNED_INT&&(Z=i.RG32UI),G===i.BYTE&&(Z=i.RG8I),G===i.SHORT&&(Z=i.RG16I),G===i.INT&&(Z=i.RG32I)),b===i.RGB_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),G===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),G===i.UNSIGNED_INT&&(Z=i.RGB32UI),G===i.BYTE&&(Z=i.RGB8I),G===i.SHORT&&(Z=i.RGB16I),G===i.INT&&(Z=i.RGB32I)),b===i.RGBA_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),G===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),G===i.UNSIGNED_INT&&(Z=i.RGBA32UI),G===i.BYTE&&(Z=i.RGBA8I),G===i.SHORT&&(Z=i.RGBA16I),G===i.INT&&(Z=i.RGBA32I)),b===i.RGB&&(G===i.UNSIGNED_SHORT&&fe&&(Z=fe.RGB16_EXT),G===i.SHORT&&fe&&(Z=fe.RGB16_SNORM_EXT),G===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),G===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),b===i.RGBA){let K=le?Ir:qe.getTransfer(Q);G===i.FLOAT&&(Z=i.RGBA32F),G===i.HALF_FLOAT&&(Z=i.RGBA16F),G===i.UNSIGNED_BYTE&&(Z=K===Ke?i.SRGB8_ALPHA8:i.RGBA8),G===i.UNSIGNED_SHORT&&fe&&(Z=fe.RGBA16_EXT),G===i.SHORT&&fe&&(Z=fe.RGBA16_SNORM_EXT),G===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),G===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}a(T,"getInternalFormat");function x(R,b){let G;return R?b===null||b===Qt||b===Li?G=i.DEPTH24_STENCIL8:b===un?G=i.DEPTH32F_STENCIL8:b===dr&&(G=i.DEPTH24_STENCIL8,Pe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Qt||b===Li?G=i.DEPTH_COMPONENT24:b===un?G=i.DEPTH_COMPONENT32F:b===dr&&(G=i.DEPTH_COMPONENT16),G}a(x,"getInternalDepthFormat");function w(R,b){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Mt&&R.minFilter!==At?Math.log2(Math.max(b.width,b.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?b.mipmaps.length:1}a(w,"getMipLevels");function P(R){let b=new WeakRef(R);n.get(R).__ref=b,_.add(b),y.register(R,b,b)}a(P,"track");function C(R){let b=n.get(R).__ref;b!==void 0&&(_.delete(b),y.unregister(b))}a(C,"untrack");function D(R){X(R.target)}a(D,"onTextureDispose");function B(R){L(R.target)}a(B,"onRenderTargetDispose");function X(R){R.removeEventListener("dispose",D),C(R),O(R),R.isVideoTexture&&d.delete(R),R.isHTMLTexture&&p.delete(R)}a(X,"destroyTexture");function L(R){R.removeEventListener("dispose",B),C(R),te(R)}a(L,"destroyRenderTarget");function q(){for(let R of _){let b=R.deref();b!==void 0&&(b.isRenderTarget===!0?L(b):X(b))}_.clear(),p.clear()}a(q,"dispose");function O(R){let b=n.get(R);if(b.__webglInit===void 0)return;let G=R.source,re=g.get(G);if(re){let Q=re[b.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&z(R),Object.keys(re).length===0&&g.delete(G)}n.remove(R)}a(O,"deallocateTexture");function z(R){let b=n.get(R);i.deleteTexture(b.__webglTexture);let G=R.source,re=g.get(G);delete re[b.__cacheKey],o.memory.textures--}a(z,"deleteTexture");function te(R){let b=n.get(R);b.__depthDisposeCallback&&b.__depthDisposeCallback();let G=R.depthTexture;if(G&&G.renderTarget===R&&X(G),R.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(b.__webglFramebuffer[Q]))for(let le=0;le<b.__webglFramebuffer[Q].length;le++)i.deleteFramebuffer(b.__webglFramebuffer[Q][le]);else i.deleteFramebuffer(b.__webglFramebuffer[Q]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[Q])}else{if(Array.isArray(b.__webglFramebuffer))for(let Q=0;Q<b.__webglFramebuffer.length;Q++)i.deleteFramebuffer(b.__webglFramebuffer[Q]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let Q=0;Q<b.__webglColorRenderbuffer.length;Q++)b.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[Q]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let re=R.textures;for(let Q=0,le=re.length;Q<le;Q++){let fe=n.get(re[Q]);fe.__webglTexture&&(i.deleteTexture(fe.__webglTexture),o.memory.textures--),n.remove(re[Q])}n.remove(R)}a(te,"deallocateRenderTarget");let Y=0;function ee(){Y=0}a(ee,"resetTextureUnits");function ne(){return Y}a(ne,"getTextureUnits");function Me(R){Y=R}a(Me,"setTextureUnits");function Ie(){let R=Y;return R>=r.maxTextures&&Pe("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),Y+=1,R}a(Ie,"allocateTextureUnit");function F(R){let b=[];return b.push(R.wrapS),b.push(R.wrapT),b.push(R.wrapR||0),b.push(R.magFilter),b.push(R.minFilter),b.push(R.anisotropy),b.push(R.internalFormat),b.push(R.format),b.push(R.type),b.push(R.generateMipmaps),b.push(R.mipmapsAutoUpdate),b.push(R.premultiplyAlpha),b.push(R.flipY),b.push(R.unpackAlignment),b.push(R.colorSpace),b.join()}a(F,"getTextureCacheKey");function J(R,b){let G=n.get(R);if(R.isVideoTexture&&mt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&G.__version!==R.version){let re=R.image;if(re===null)Pe("WebGLRenderer: Texture marked for update but no image data found.");else if(re.complete===!1)Pe("WebGLRenderer: Texture marked for update but image is incomplete");else{pt(G,R,b);return}}else R.isExternalTexture&&(G.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,G.__webglTexture,i.TEXTURE0+b)}a(J,"setTexture2D");function ie(R,b){let G=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&G.__version!==R.version){pt(G,R,b);return}else R.isExternalTexture&&(G.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,G.__webglTexture,i.TEXTURE0+b)}a(ie,"setTexture2DArray");function ve(R,b){let G=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&G.__version!==R.version){pt(G,R,b);return}t.bindTexture(i.TEXTURE_3D,G.__webglTexture,i.TEXTURE0+b)}a(ve,"setTexture3D");function ae(R,b){let G=n.get(R);if(R.version>0&&G.__version!==R.version){Ht(G,R,b);return}t.bindTexture(i.TEXTURE_CUBE_MAP,G.__webglTexture,i.TEXTURE0+b)}a(ae,"setTextureCube");let Le={[er]:i.REPEAT,[An]:i.CLAMP_TO_EDGE,[ro]:i.MIRRORED_REPEAT},rt={[Mt]:i.NEAREST,[Lh]:i.NEAREST_MIPMAP_NEAREST,[is]:i.NEAREST_MIPMAP_LINEAR,[At]:i.LINEAR,[No]:i.LINEAR_MIPMAP_NEAREST,[vn]:i.LINEAR_MIPMAP_LINEAR},Te={[Fh]:i.NEVER,[ql]:i.ALWAYS,[Oh]:i.LESS,[Wl]:i.LEQUAL,[Bh]:i.EQUAL,[Xl]:i.GEQUAL,[kh]:i.GREATER,[zh]:i.NOTEQUAL};function Ve(R,b){if(b.type===un&&e.has("OES_texture_float_linear")===!1&&(b.magFilter===At||b.magFilter===No||b.magFilter===is||b.magFilter===vn||b.minFilter===At||b.minFilter===No||b.minFilter===is||b.minFilter===vn)&&Pe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Le[b.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Le[b.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Le[b.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,rt[b.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,rt[b.minFilter]),b.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Te[b.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Mt||b.minFilter!==is&&b.minFilter!==vn||b.type===un&&e.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let G=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,r.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}a(Ve,"setTextureParameters");function et(R,b){let G=!1;R.__webglInit===void 0&&(R.__webglInit=!0,b.addEventListener("dispose",D),P(b));let re=b.source,Q=g.get(re);Q===void 0&&(Q={},g.set(re,Q));let le=F(b);if(le!==R.__cacheKey){Q[le]===void 0&&(Q[le]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,G=!0),Q[le].usedTimes++;let fe=Q[R.__cacheKey];fe!==void 0&&(Q[R.__cacheKey].usedTimes--,fe.usedTimes===0&&z(b)),R.__cacheKey=le,R.__webglTexture=Q[le].texture}return G}a(et,"initTexture");function He(R,b,G){return Math.floor(Math.floor(R/G)/b)}a(He,"getRow");function wt(R,b,G,re){let le=R.updateRanges;if(le.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,G,re,b.data);else{le.sort((I,j)=>I.start-j.start);let fe=0;for(let I=1;I<le.length;I++){let j=le[fe],$=le[I],he=j.start+j.count,oe=He($.start,b.width,4),ce=He(j.start,b.width,4);$.start<=he+1&&oe===ce&&He($.start+$.count-1,b.width,4)===oe?j.count=Math.max(j.count,$.start+$.count-j.start):(++fe,le[fe]=$)}le.length=fe+1;let Z=t.getParameter(i.UNPACK_ROW_LENGTH),K=t.getParameter(i.UNPACK_SKIP_PIXELS),ue=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let I=0,j=le.length;I<j;I++){let $=le[I],he=Math.floor($.start/4),oe=Math.ceil($.count/4),ce=he%b.width,Ae=Math.floor(he/b.width),Be=oe,se=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,ce),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ae),t.texSubImage2D(i.TEXTURE_2D,0,ce,Ae,Be,se,G,re,b.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Z),t.pixelStorei(i.UNPACK_SKIP_PIXELS,K),t.pixelStorei(i.UNPACK_SKIP_ROWS,ue)}}a(wt,"updateTexture");function pt(R,b,G){let re=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(re=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(re=i.TEXTURE_3D);let Q=et(R,b),le=b.source;t.bindTexture(re,R.__webglTexture,i.TEXTURE0+G);let fe=n.get(le);if(le.version!==fe.__version||Q===!0){if(t.activeTexture(i.TEXTURE0+G),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let se=qe.getPrimaries(qe.workingColorSpace),Re=b.colorSpace===$n?null:qe.getPrimaries(b.colorSpace),Oe=b.colorSpace===$n||se===Re?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Oe)}t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let K=S(b.image,!1,r.maxTextureSize);K=Ce(b,K);let ue=s.convert(b.format,b.colorSpace),I=s.convert(b.type),j=T(b.internalFormat,ue,I,b.normalized,b.colorSpace,b.isVideoTexture);Ve(re,b);let $,he=b.mipmaps,oe=b.isVideoTexture!==!0,ce=fe.__version===void 0||Q===!0,Ae=le.dataReady,Be=w(b,K);if(b.isDepthTexture)j=x(b.format===Yn,b.type),ce&&(oe?t.texStorage2D(i.TEXTURE_2D,1,j,K.width,K.height):t.texImage2D(i.TEXTURE_2D,0,j,K.width,K.height,0,ue,I,null));else if(b.isDataTexture)if(he.length>0){oe&&ce&&t.texStorage2D(i.TEXTURE_2D,Be,j,he[0].width,he[0].height);for(let se=0,Re=he.length;se<Re;se++)$=he[se],oe?Ae&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,$.width,$.height,ue,I,$.data):t.texImage2D(i.TEXTURE_2D,se,j,$.width,$.height,0,ue,I,$.data);b.generateMipmaps=!1}else oe?(ce&&t.texStorage2D(i.TEXTURE_2D,Be,j,K.width,K.height),Ae&&wt(b,K,ue,I)):t.texImage2D(i.TEXTURE_2D,0,j,K.width,K.height,0,ue,I,K.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){oe&&ce&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Be,j,he[0].width,he[0].height,K.depth);for(let se=0,Re=he.length;se<Re;se++)if($=he[se],b.format!==Mn)if(ue!==null)if(oe){if(Ae)if(b.layerUpdates.size>0){let Oe=Kl($.width,$.height,b.format,b.type);for(let ge of b.layerUpdates){let je=$.data.subarray(ge*Oe/$.data.BYTES_PER_ELEMENT,(ge+1)*Oe/$.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,ge,$.width,$.height,1,ue,je)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,$.width,$.height,K.depth,ue,$.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,se,j,$.width,$.height,K.depth,0,$.data,0,0);else Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else oe?Ae&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,$.width,$.height,K.depth,ue,I,$.data):t.texImage3D(i.TEXTURE_2D_ARRAY,se,j,$.width,$.height,K.depth,0,ue,I,$.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{oe&&ce&&t.texStorage2D(i.TEXTURE_2D,Be,j,he[0].width,he[0].height);for(let se=0,Re=he.length;se<Re;se++)$=he[se],b.format!==Mn?ue!==null?oe?Ae&&t.compressedTexSubImage2D(i.TEXTURE_2D,se,0,0,$.width,$.height,ue,$.data):t.compressedTexImage2D(i.TEXTURE_2D,se,j,$.width,$.height,0,$.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):oe?Ae&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,$.width,$.height,ue,I,$.data):t.texImage2D(i.TEXTURE_2D,se,j,$.width,$.height,0,ue,I,$.data)}else if(b.isDataArrayTexture)if(oe){if(ce&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Be,j,K.width,K.height,K.depth),Ae)if(b.layerUpdates.size>0){let se=Kl(K.width,K.height,b.format,b.type);for(let Re of b.layerUpdates){let Oe=K.data.subarray(Re*se/K.data.BYTES_PER_ELEMENT,(Re+1)*se/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Re,K.width,K.height,1,ue,I,Oe)}b.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,ue,I,K.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,j,K.width,K.height,K.depth,0,ue,I,K.data);else if(b.isData3DTexture)oe?(ce&&t.texStorage3D(i.TEXTURE_3D,Be,j,K.width,K.height,K.depth),Ae&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,ue,I,K.data)):t.texImage3D(i.TEXTURE_3D,0,j,K.width,K.height,K.depth,0,ue,I,K.data);else if(b.isFramebufferTexture){if(ce)if(oe)t.texStorage2D(i.TEXTURE_2D,Be,j,K.width,K.height);else{let se=K.width,Re=K.height;for(let Oe=0;Oe<Be;Oe++)t.texImage2D(i.TEXTURE_2D,Oe,j,se,Re,0,ue,I,null),se>>=1,Re>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let se=i.canvas;if(se.hasAttribute("layoutsubtree")||se.setAttribute("layoutsubtree","true"),K.parentNode!==se){se.appendChild(K),p.add(b),se.onpaint=Re=>{let Oe=Re.changedElements;for(let ge of p)Oe.includes(ge.image)&&(ge.needsUpdate=!0)},se.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,K);else{let Oe=i.RGBA,ge=i.RGBA,je=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Oe,ge,je,K)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(he.length>0){if(oe&&ce){let se=Ue(he[0]);t.texStorage2D(i.TEXTURE_2D,Be,j,se.width,se.height)}for(let se=0,Re=he.length;se<Re;se++)$=he[se],oe?Ae&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,ue,I,$):t.texImage2D(i.TEXTURE_2D,se,j,ue,I,$);b.generateMipmaps=!1}else if(oe){if(ce){let se=Ue(K);t.texStorage2D(i.TEXTURE_2D,Be,j,se.width,se.height)}Ae&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ue,I,K)}else t.texImage2D(i.TEXTURE_2D,0,j,ue,I,K);A(b)&&b.mipmapsAutoUpdate===!0&&v(re),fe.__version=le.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}a(pt,"uploadTexture");function Ht(R,b,G){if(b.image.length!==6)return;let re=et(R,b),Q=b.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+G);let le=n.get(Q);if(Q.version!==le.__version||re===!0){t.activeTexture(i.TEXTURE0+G);let fe=qe.getPrimaries(qe.workingColorSpace),Z=b.colorSpace===$n?null:qe.getPrimaries(b.colorSpace),K=b.colorSpace===$n||fe===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);let ue=b.isCompressedTexture||b.image[0].isCompressedTexture,I=b.image[0]&&b.image[0].isDataTexture,j=[];for(let ge=0;ge<6;ge++)!ue&&!I?j[ge]=S(b.image[ge],!0,r.maxCubemapSize):j[ge]=I?b.image[ge].image:b.image[ge],j[ge]=Ce(b,j[ge]);let $=j[0],he=s.convert(b.format,b.colorSpace),oe=s.convert(b.type),ce=T(b.internalFormat,he,oe,b.normalized,b.colorSpace),Ae=b.isVideoTexture!==!0,Be=le.__version===void 0||re===!0,se=Q.dataReady,Re=w(b,$);Ve(i.TEXTURE_CUBE_MAP,b);let Oe;if(b.isDepthTexture){if(ce=x(b.format===Yn,b.type),Be)if(Ae)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,ce,$.width,$.height);else for(let ge=0;ge<6;ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,ce,$.width,$.height,0,he,oe,null)}else if(ue){Ae&&Be&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Re,ce,$.width,$.height);for(let ge=0;ge<6;ge++){Oe=j[ge].mipmaps;for(let je=0;je<Oe.length;je++){let yt=Oe[je];b.format!==Mn?he!==null?Ae?se&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je,0,0,yt.width,yt.height,he,yt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je,ce,yt.width,yt.height,0,yt.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je,0,0,yt.width,yt.height,he,oe,yt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je,ce,yt.width,yt.height,0,he,oe,yt.data)}}}else{if(Oe=b.mipmaps,Ae&&Be){Oe.length>0&&Re++;let ge=Ue(j[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Re,ce,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(I){Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,j[ge].width,j[ge].height,he,oe,j[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,ce,j[ge].width,j[ge].height,0,he,oe,j[ge].data);for(let je=0;je<Oe.length;je++){let Kn=Oe[je].image[ge].image;Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je+1,0,0,Kn.width,Kn.height,he,oe,Kn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je+1,ce,Kn.width,Kn.height,0,he,oe,Kn.data)}}else{Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,he,oe,j[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,ce,he,oe,j[ge]);for(let je=0;je<Oe.length;je++){let yt=Oe[je];Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je+1,0,0,he,oe,yt.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,je+1,ce,he,oe,yt.image[ge])}}}A(b)&&b.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),le.__version=Q.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}a(Ht,"uploadCubeTexture");function lt(R,b,G,re,Q,le){let fe=s.convert(G.format,G.colorSpace),Z=s.convert(G.type),K=T(G.internalFormat,fe,Z,G.normalized,G.colorSpace),ue=n.get(b),I=n.get(G);if(I.__renderTarget=b,!ue.__hasExternalTextures){let j=Math.max(1,b.width>>le),$=Math.max(1,b.height>>le);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?t.texImage3D(Q,le,K,j,$,b.depth,0,fe,Z,null):t.texImage2D(Q,le,K,j,$,0,fe,Z,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),me(b)?l.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,re,Q,I.__webglTexture,0,at(b)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,re,Q,I.__webglTexture,le),t.bindFramebuffer(i.FRAMEBUFFER,null)}a(lt,"setupFrameBufferTexture");function bn(R,b,G){if(i.bindRenderbuffer(i.RENDERBUFFER,R),b.depthBuffer){let re=b.depthTexture,Q=re&&re.isDepthTexture?re.type:null,le=x(b.stencilBuffer,Q),fe=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;me(b)?l.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(b),le,b.width,b.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(b),le,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,le,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,fe,i.RENDERBUFFER,R)}else{let re=b.textures;for(let Q=0;Q<re.length;Q++){let le=re[Q],fe=s.convert(le.format,le.colorSpace),Z=s.convert(le.type),K=T(le.internalFormat,fe,Z,le.normalized,le.colorSpace);me(b)?l.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,at(b),K,b.width,b.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,at(b),K,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,K,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}a(bn,"setupRenderBufferStorage");function xt(R,b,G){let re=b.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(b.depthTexture);Q.__renderTarget=b;let le=re?b.depthTexture.image[0]:b.depthTexture.image;(!Q.__webglTexture||le.width!==b.width||le.height!==b.height)&&(le.width=b.width,le.height=b.height,b.depthTexture.needsUpdate=!0),re?ae(b.depthTexture,0):J(b.depthTexture,0);let fe=Q.__webglTexture,Z=at(b),K=re?i.TEXTURE_CUBE_MAP_POSITIVE_X+G:i.TEXTURE_2D,ue=b.depthTexture.format===Yn?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===Wn)me(b)?l.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,K,fe,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ue,K,fe,0);else if(b.depthTexture.format===Yn)me(b)?l.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ue,K,fe,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ue,K,fe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}a(xt,"setupDepthTexture");function en(R){let b=n.get(R),G=R.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==R.depthTexture){let re=R.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),re){let Q=a(()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,re.removeEventListener("dispose",Q)},"disposeEvent");re.addEventListener("dispose",Q),b.__depthDisposeCallback=Q}b.__boundDepthTexture=re}if(R.depthTexture&&!b.__autoAllocateDepthBuffer)if(G)for(let re=0;re<6;re++)xt(b.__webglFramebuffer[re],R,re);else R.texture.mipmaps.length>0?xt(b.__webglFramebuffer[0],R,0):xt(b.__webglFramebuffer,R,0);else if(G){b.__webglDepthbuffer=[];for(let re=0;re<6;re++)if(t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[re]),b.__webglDepthbuffer[re]===void 0)b.__webglDepthbuffer[re]=i.createRenderbuffer(),bn(b.__webglDepthbuffer[re],R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,le=b.__webglDepthbuffer[re];i.bindRenderbuffer(i.RENDERBUFFER,le),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,le)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),bn(b.__webglDepthbuffer,R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,le=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,le),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,le)}t.bindFramebuffer(i.FRAMEBUFFER,null)}a(en,"setupDepthRenderbuffer");function tn(R,b,G){let re=n.get(R);b!==void 0&&lt(re.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),G!==void 0&&en(R)}a(tn,"rebindTextures");function nn(R){let b=R.texture,G=n.get(R),re=n.get(b);R.addEventListener("dispose",B),P(R);let Q=R.textures,le=R.isWebGLCubeRenderTarget===!0,fe=Q.length>1;if(fe||(re.__webglTexture===void 0&&(re.__webglTexture=i.createTexture()),re.__version=b.version,o.memory.textures++),le){G.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(b.mipmaps.length>0){G.__webglFramebuffer[Z]=[];for(let K=0;K<b.mipmaps.length;K++)G.__webglFramebuffer[Z][K]=i.createFramebuffer()}else G.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(b.mipmaps.length>0){G.__webglFramebuffer=[];for(let Z=0;Z<b.mipmaps.length;Z++)G.__webglFramebuffer[Z]=i.createFramebuffer()}else G.__webglFramebuffer=i.createFramebuffer();if(fe)for(let Z=0,K=Q.length;Z<K;Z++){let ue=n.get(Q[Z]);ue.__webglTexture===void 0&&(ue.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&me(R)===!1){G.__webglMultisampledFramebuffer=i.createFramebuffer(),G.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){let K=Q[Z];G.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,G.__webglColorRenderbuffer[Z]);let ue=s.convert(K.format,K.colorSpace),I=s.convert(K.type),j=T(K.internalFormat,ue,I,K.normalized,K.colorSpace,R.isXRRenderTarget===!0),$=at(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,$,j,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,G.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(G.__webglDepthRenderbuffer=i.createRenderbuffer(),bn(G.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(le){t.bindTexture(i.TEXTURE_CUBE_MAP,re.__webglTexture),Ve(i.TEXTURE_CUBE_MAP,b);for(let Z=0;Z<6;Z++)if(b.mipmaps.length>0)for(let K=0;K<b.mipmaps.length;K++)lt(G.__webglFramebuffer[Z][K],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,K);else lt(G.__webglFramebuffer[Z],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);A(b)?v(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}else if(fe){for(let Z=0,K=Q.length;Z<K;Z++){let ue=Q[Z],I=n.get(ue),j=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(j=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(j,I.__webglTexture),Ve(j,ue),lt(G.__webglFramebuffer,R,ue,i.COLOR_ATTACHMENT0+Z,j,0),A(ue)&&v(j)}t.unbindTexture()}else{let Z=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Z=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Z,re.__webglTexture),Ve(Z,b),b.mipmaps.length>0)for(let K=0;K<b.mipmaps.length;K++)lt(G.__webglFramebuffer[K],R,b,i.COLOR_ATTACHMENT0,Z,K);else lt(G.__webglFramebuffer,R,b,i.COLOR_ATTACHMENT0,Z,0);A(b)?v(Z):b.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&en(R)}a(nn,"setupRenderTarget");function U(R){let b=R.textures;for(let G=0,re=b.length;G<re;G++){let Q=b[G];if(A(Q)&&Q.mipmapsAutoUpdate===!0){let le=M(R),fe=n.get(Q).__webglTexture;t.bindTexture(le,fe),v(le),t.unbindTexture()}}}a(U,"updateRenderTargetMipmap");let rn=[];function ot(R){if(R.samples>0){if(me(R)===!1){let b=R.textures,G=R.width,re=R.height,Q=i.COLOR_BUFFER_BIT,le=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,fe=n.get(R),Z=b.length>1;if(Z)for(let ue=0;ue<b.length;ue++)t.bindFramebuffer(i.FRAMEBUFFER,fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ue,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ue,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,fe.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,fe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,fe.__webglFramebuffer);for(let ue=0;ue<b.length;ue++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,fe.__webglColorRenderbuffer[ue]);let I=n.get(b[ue]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,I,0)}i.blitFramebuffer(0,0,G,re,0,0,G,re,Q,i.NEAREST),c===!0&&(rn.length=0,rn.push(i.COLOR_ATTACHMENT0+ue),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&rn.push(le),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,rn))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let ue=0;ue<b.length;ue++){t.bindFramebuffer(i.FRAMEBUFFER,fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ue,i.RENDERBUFFER,fe.__webglColorRenderbuffer[ue]);let I=n.get(b[ue]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ue,i.TEXTURE_2D,I,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,fe.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&c){let b=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}a(ot,"updateMultisampleRenderTarget");function at(R){return Math.min(r.maxSamples,R.samples)}a(at,"getRenderTargetSamples");function me(R){let b=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}a(me,"useMultisampledRTT");function mt(R){let b=o.render.frame;d.get(R)!==b&&(d.set(R,b),R.update())}a(mt,"updateVideoTexture");function Ce(R,b){let G=R.colorSpace,re=R.format,Q=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||G!==Pr&&G!==$n&&(qe.getTransfer(G)===Ke?(re!==Mn||Q!==jt)&&Pe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ne("WebGLTextures: Unsupported texture color space:",G)),b}a(Ce,"verifyColorSpace");function Ue(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(u.width=R.naturalWidth||R.width,u.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(u.width=R.displayWidth,u.height=R.displayHeight):(u.width=R.width,u.height=R.height),u}a(Ue,"getDimensions"),this.allocateTextureUnit=Ie,this.resetTextureUnits=ee,this.getTextureUnits=ne,this.setTextureUnits=Me,this.setTexture2D=J,this.setTexture2DArray=ie,this.setTexture3D=ve,this.setTextureCube=ae,this.rebindTextures=tn,this.setupRenderTarget=nn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=ot,this.setupDepthRenderbuffer=en,this.setupFrameBufferTexture=lt,this.useMultisampledRTT=me,this.dispose=q}a(Ty,"WebGLTextures");function Ay(i,e){function t(n,r=$n){let s,o=qe.getTransfer(r);if(n===jt)return i.UNSIGNED_BYTE;if(n===Uo)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Fo)return i.UNSIGNED_SHORT_5_5_5_1;if(n===zl)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Gl)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Bl)return i.BYTE;if(n===kl)return i.SHORT;if(n===dr)return i.UNSIGNED_SHORT;if(n===Do)return i.INT;if(n===Qt)return i.UNSIGNED_INT;if(n===un)return i.FLOAT;if(n===Sn)return i.HALF_FLOAT;if(n===Vl)return i.ALPHA;if(n===Hl)return i.RGB;if(n===Mn)return i.RGBA;if(n===Wn)return i.DEPTH_COMPONENT;if(n===Yn)return i.DEPTH_STENCIL;if(n===Oo)return i.RED;if(n===Bo)return i.RED_INTEGER;if(n===fi)return i.RG;if(n===ko)return i.RG_INTEGER;if(n===zo)return i.RGBA_INTEGER;if(n===rs||n===ss||n===os||n===as)if(o===Ke)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===rs)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ss)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===os)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===as)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===rs)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ss)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===os)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===as)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Go||n===Vo||n===Ho||n===Wo)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===Go)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Vo)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ho)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Wo)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Xo||n===qo||n===Yo||n===$o||n===Jo||n===ls||n===Zo)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(n===Xo||n===qo)return o===Ke?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===Yo)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===$o)return s.COMPRESSED_R11_EAC;if(n===Jo)return s.COMPRESSED_SIGNED_R11_EAC;if(n===ls)return s.COMPRESSED_RG11_EAC;if(n===Zo)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Ko||n===jo||n===Qo||n===ea||n===ta||n===na||n===ia||n===ra||n===sa||n===oa||n===aa||n===la||n===ca||n===ua)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(n===Ko)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===jo)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Qo)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ea)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ta)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===na)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===ia)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ra)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===sa)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===oa)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===aa)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===la)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ca)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ua)return o===Ke?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ha||n===da||n===fa)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(n===ha)return o===Ke?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===da)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===fa)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===pa||n===ma||n===cs||n===ga)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(n===pa)return s.COMPRESSED_RED_RGTC1_EXT;if(n===ma)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===cs)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ga)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Li?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return a(t,"convert"),{convert:t}}a(Ay,"WebGLUtils");var Ry=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Cy=`
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

}`,oc=class{static{a(this,"WebXRDepthSensing")}constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Wr(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new In({vertexShader:Ry,fragmentShader:Cy,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ut(new Yr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ac=class extends Rn{static{a(this,"WebXRManager")}constructor(e,t){super();let n=this,r=null,s=1,o=null,l="local-floor",c=1,u=null,d=null,p=null,h=null,g=null,_=null,y=typeof XRWebGLBinding<"u",f=new oc,m={},S=t.getContextAttributes(),A=null,v=null,M=[],T=[],x=new Ge,w=null,P=null,C=new Gt;C.viewport=new nt;let D=new Gt;D.viewport=new nt;let B=[C,D],X=new Co,L=null,q=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(F){let J=M[F];return J===void 0&&(J=new ir,M[F]=J),J.getTargetRaySpace()},this.getControllerGrip=function(F){let J=M[F];return J===void 0&&(J=new ir,M[F]=J),J.getGripSpace()},this.getHand=function(F){let J=M[F];return J===void 0&&(J=new ir,M[F]=J),J.getHandSpace()};function O(F){let J=T.indexOf(F.inputSource);if(J===-1)return;let ie=M[J];ie!==void 0&&(ie.update(F.inputSource,F.frame,u||o),ie.dispatchEvent({type:F.type,data:F.inputSource}))}a(O,"onSessionEvent");function z(){r.removeEventListener("select",O),r.removeEventListener("selectstart",O),r.removeEventListener("selectend",O),r.removeEventListener("squeeze",O),r.removeEventListener("squeezestart",O),r.removeEventListener("squeezeend",O),r.removeEventListener("end",z),r.removeEventListener("inputsourceschange",te);for(let F=0;F<M.length;F++){let J=T[F];J!==null&&(T[F]=null,M[F].disconnect(J))}L=null,q=null,f.reset();for(let F in m)delete m[F];if(e.setRenderTarget(A),g=null,h=null,p=null,r=null,v=null,Ie.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(x.width,x.height,!1),P!==null){let F=P.camera;F.fov=P.fov,F.zoom=P.zoom,F.updateProjectionMatrix(),P=null}n.dispatchEvent({type:"sessionend"})}a(z,"onSessionEnd"),this.setFramebufferScaleFactor=function(F){s=F,n.isPresenting===!0&&Pe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(F){l=F,n.isPresenting===!0&&Pe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return u||o},this.setReferenceSpace=function(F){u=F},this.getBaseLayer=function(){return h!==null?h:g},this.getBinding=function(){return p===null&&y&&(p=new XRWebGLBinding(r,t)),p},this.getFrame=function(){return _},this.getSession=function(){return r},this.setSession=async function(F){if(r=F,r!==null){if(A=e.getRenderTarget(),r.addEventListener("select",O),r.addEventListener("selectstart",O),r.addEventListener("selectend",O),r.addEventListener("squeeze",O),r.addEventListener("squeezestart",O),r.addEventListener("squeezeend",O),r.addEventListener("end",z),r.addEventListener("inputsourceschange",te),S.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ie=null,ve=null,ae=null;S.depth&&(ae=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ie=S.stencil?Yn:Wn,ve=S.stencil?Li:Qt);let Le={colorFormat:t.RGBA8,depthFormat:ae,scaleFactor:s};p=this.getBinding(),h=p.createProjectionLayer(Le),r.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),v=new Dt(h.textureWidth,h.textureHeight,{format:Mn,type:jt,depthTexture:new xn(h.textureWidth,h.textureHeight,ve,void 0,void 0,void 0,void 0,void 0,void 0,ie),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ie={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:s};g=new XRWebGLLayer(r,t,ie),r.updateRenderState({baseLayer:g}),e.setPixelRatio(1),e.setSize(g.framebufferWidth,g.framebufferHeight,!1),v=new Dt(g.framebufferWidth,g.framebufferHeight,{format:Mn,type:jt,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:g.ignoreDepthValues===!1,resolveStencilBuffer:g.ignoreDepthValues===!1,storeMultisampledDepthBuffer:g.ignoreDepthValues===!1,storeMultisampledStencilBuffer:g.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),u=null,o=await r.requestReferenceSpace(l),Ie.setContext(r),Ie.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return f.getDepthTexture()};function te(F){for(let J=0;J<F.removed.length;J++){let ie=F.removed[J],ve=T.indexOf(ie);ve>=0&&(T[ve]=null,M[ve].disconnect(ie))}for(let J=0;J<F.added.length;J++){let ie=F.added[J],ve=T.indexOf(ie);if(ve===-1){for(let Le=0;Le<M.length;Le++)if(Le>=T.length){T.push(ie),ve=Le;break}else if(T[Le]===null){T[Le]=ie,ve=Le;break}if(ve===-1)break}let ae=M[ve];ae&&ae.connect(ie)}}a(te,"onInputSourcesChange");function Y(F,J){J===null?F.matrixWorld.copy(F.matrix):F.matrixWorld.multiplyMatrices(J.matrixWorld,F.matrix),F.matrixWorldInverse.copy(F.matrixWorld).invert()}a(Y,"updateCamera"),this.updateCamera=function(F){if(r===null)return;let J=F.near,ie=F.far;f.texture!==null&&(f.depthNear>0&&(J=f.depthNear),f.depthFar>0&&(ie=f.depthFar)),X.near=D.near=C.near=J,X.far=D.far=C.far=ie,(L!==X.near||q!==X.far)&&(r.updateRenderState({depthNear:X.near,depthFar:X.far}),L=X.near,q=X.far),X.layers.mask=F.layers.mask|6,C.layers.mask=X.layers.mask&-5,D.layers.mask=X.layers.mask&-3;let ve=F.parent,ae=X.cameras;Y(X,ve);for(let Le=0;Le<ae.length;Le++)Y(ae[Le],ve);X.projectionMatrix.copy(C.projectionMatrix),X.projectionMatrixInverse.copy(C.projectionMatrixInverse),P===null&&F.isPerspectiveCamera&&(P={camera:F,fov:F.fov,zoom:F.zoom}),ee(F,X,ve)};function ee(F,J,ie){ie===null?F.matrix.copy(J.matrixWorld):(F.matrix.copy(ie.matrixWorld),F.matrix.invert(),F.matrix.multiply(J.matrixWorld)),F.matrix.decompose(F.position,F.quaternion,F.scale),F.updateMatrixWorld(!0),F.projectionMatrix.copy(J.projectionMatrix),F.projectionMatrixInverse.copy(J.projectionMatrixInverse),F.isPerspectiveCamera&&(F.fov=oo*2*Math.atan(1/F.projectionMatrix.elements[5]),F.zoom=1)}a(ee,"updateUserCamera"),this.getCamera=function(){return X},this.getFoveation=function(){if(!(h===null&&g===null))return c},this.setFoveation=function(F){c=F,h!==null&&(h.fixedFoveation=F),g!==null&&g.fixedFoveation!==void 0&&(g.fixedFoveation=F)},this.hasDepthSensing=function(){return f.texture!==null},this.getDepthSensingMesh=function(){return f.getMesh(X)},this.getCameraTexture=function(F){return m[F]};let ne=null;function Me(F,J){if(d=J.getViewerPose(u||o),_=J,d!==null){let ie=d.views;g!==null&&(e.setRenderTargetFramebuffer(v,g.framebuffer),e.setRenderTarget(v));let ve=!1;ie.length!==X.cameras.length&&(X.cameras.length=0,ve=!0);for(let Te=0;Te<ie.length;Te++){let Ve=ie[Te],et=null;if(g!==null)et=g.getViewport(Ve);else{let wt=p.getViewSubImage(h,Ve);et=wt.viewport,Te===0&&(e.setRenderTargetTextures(v,wt.colorTexture,wt.depthStencilTexture),e.setRenderTarget(v))}let He=B[Te];He===void 0&&(He=new Gt,He.layers.enable(Te),He.viewport=new nt,B[Te]=He),He.matrix.fromArray(Ve.transform.matrix),He.matrix.decompose(He.position,He.quaternion,He.scale),He.projectionMatrix.fromArray(Ve.projectionMatrix),He.projectionMatrixInverse.copy(He.projectionMatrix).invert(),He.viewport.set(et.x,et.y,et.width,et.height),Te===0&&(X.matrix.copy(He.matrix),X.matrix.decompose(X.position,X.quaternion,X.scale)),ve===!0&&X.cameras.push(He)}let ae=r.enabledFeatures;if(ae&&ae.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&y){p=n.getBinding();let Te=p.getDepthInformation(ie[0]);Te&&Te.isValid&&Te.texture&&f.init(Te,r.renderState)}if(ae&&ae.includes("camera-access")&&y){e.state.unbindTexture(),p=n.getBinding();for(let Te=0;Te<ie.length;Te++){let Ve=ie[Te].camera;if(Ve){let et=m[Ve];et||(et=new Wr,m[Ve]=et);let He=p.getCameraImage(Ve);et.sourceTexture=He}}}}for(let ie=0;ie<M.length;ie++){let ve=T[ie],ae=M[ie];ve!==null&&ae!==void 0&&ae.update(ve,J,u||o)}ne&&ne(F,J),J.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:J}),_=null}a(Me,"onAnimationFrame");let Ie=new yd;Ie.setAnimationLoop(Me),this.setAnimationLoop=function(F){ne=F},this.dispose=function(){}}},Py=new Qe,Cd=new De;Cd.set(-1,0,0,0,1,0,0,0,1);function Iy(i,e){function t(f,m){f.matrixAutoUpdate===!0&&f.updateMatrix(),m.value.copy(f.matrix)}a(t,"refreshTransformUniform");function n(f,m){m.color.getRGB(f.fogColor.value,$l(i)),m.isFog?(f.fogNear.value=m.near,f.fogFar.value=m.far):m.isFogExp2&&(f.fogDensity.value=m.density)}a(n,"refreshFogUniforms");function r(f,m,S,A,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?s(f,m):m.isMeshLambertMaterial?(s(f,m),m.envMap&&(f.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(s(f,m),p(f,m)):m.isMeshPhongMaterial?(s(f,m),d(f,m),m.envMap&&(f.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(s(f,m),h(f,m),m.isMeshPhysicalMaterial&&g(f,m,v)):m.isMeshMatcapMaterial?(s(f,m),_(f,m)):m.isMeshDepthMaterial?s(f,m):m.isMeshDistanceMaterial?(s(f,m),y(f,m)):m.isMeshNormalMaterial?s(f,m):m.isLineBasicMaterial?(o(f,m),m.isLineDashedMaterial&&l(f,m)):m.isPointsMaterial?c(f,m,S,A):m.isSpriteMaterial?u(f,m):m.isShadowMaterial?(f.color.value.copy(m.color),f.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}a(r,"refreshMaterialUniforms");function s(f,m){f.opacity.value=m.opacity,m.color&&f.diffuse.value.copy(m.color),m.emissive&&f.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(f.map.value=m.map,t(m.map,f.mapTransform)),m.alphaMap&&(f.alphaMap.value=m.alphaMap,t(m.alphaMap,f.alphaMapTransform)),m.bumpMap&&(f.bumpMap.value=m.bumpMap,t(m.bumpMap,f.bumpMapTransform),f.bumpScale.value=m.bumpScale,m.side===Vt&&(f.bumpScale.value*=-1)),m.normalMap&&(f.normalMap.value=m.normalMap,t(m.normalMap,f.normalMapTransform),f.normalScale.value.copy(m.normalScale),m.side===Vt&&f.normalScale.value.negate()),m.displacementMap&&(f.displacementMap.value=m.displacementMap,t(m.displacementMap,f.displacementMapTransform),f.displacementScale.value=m.displacementScale,f.displacementBias.value=m.displacementBias),m.emissiveMap&&(f.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,f.emissiveMapTransform)),m.specularMap&&(f.specularMap.value=m.specularMap,t(m.specularMap,f.specularMapTransform)),m.alphaTest>0&&(f.alphaTest.value=m.alphaTest);let S=e.get(m),A=S.envMap,v=S.envMapRotation;A&&(f.envMap.value=A,f.envMapRotation.value.setFromMatrix4(Py.makeRotationFromEuler(v)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&f.envMapRotation.value.premultiply(Cd),f.reflectivity.value=m.reflectivity,f.ior.value=m.ior,f.refractionRatio.value=m.refractionRatio),m.lightMap&&(f.lightMap.value=m.lightMap,f.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,f.lightMapTransform)),m.aoMap&&(f.aoMap.value=m.aoMap,f.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,f.aoMapTransform))}a(s,"refreshUniformsCommon");function o(f,m){f.diffuse.value.copy(m.color),f.opacity.value=m.opacity,m.map&&(f.map.value=m.map,t(m.map,f.mapTransform))}a(o,"refreshUniformsLine");function l(f,m){f.dashSize.value=m.dashSize,f.totalSize.value=m.dashSize+m.gapSize,f.scale.value=m.scale}a(l,"refreshUniformsDash");function c(f,m,S,A){f.diffuse.value.copy(m.color),f.opacity.value=m.opacity,f.size.value=m.size*S,f.scale.value=A*.5,m.map&&(f.map.value=m.map,t(m.map,f.uvTransform)),m.alphaMap&&(f.alphaMap.value=m.alphaMap,t(m.alphaMap,f.alphaMapTransform)),m.alphaTest>0&&(f.alphaTest.value=m.alphaTest)}a(c,"refreshUniformsPoints");function u(f,m){f.diffuse.value.copy(m.color),f.opacity.value=m.opacity,f.rotation.value=m.rotation,m.map&&(f.map.value=m.map,t(m.map,f.mapTransform)),m.alphaMap&&(f.alphaMap.value=m.alphaMap,t(m.alphaMap,f.alphaMapTransform)),m.alphaTest>0&&(f.alphaTest.value=m.alphaTest)}a(u,"refreshUniformsSprites");function d(f,m){f.specular.value.copy(m.specular),f.shininess.value=Math.max(m.shininess,1e-4)}a(d,"refreshUniformsPhong");function p(f,m){m.gradientMap&&(f.gradientMap.value=m.gradientMap)}a(p,"refreshUniformsToon");function h(f,m){f.metalness.value=m.metalness,m.metalnessMap&&(f.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,f.metalnessMapTransform)),f.roughness.value=m.roughness,m.roughnessMap&&(f.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,f.roughnessMapTransform)),m.envMap&&(f.envMapIntensity.value=m.envMapIntensity)}a(h,"refreshUniformsStandard");function g(f,m,S){f.ior.value=m.ior,m.diffuseRoughness>0&&(f.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(f.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,f.diffuseRoughnessMapTransform))),m.sheen>0&&(f.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),f.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(f.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,f.sheenColorMapTransform)),m.sheenRoughnessMap&&(f.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,f.sheenRoughnessMapTransform))),m.clearcoat>0&&(f.clearcoat.value=m.clearcoat,f.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(f.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,f.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(f.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,f.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(f.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,f.clearcoatNormalMapTransform),f.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Vt&&f.clearcoatNormalScale.value.negate())),m.dispersion>0&&(f.dispersion.value=m.dispersion),m.retroreflectivity>0&&(f.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(f.iridescence.value=m.iridescence,f.iridescenceIOR.value=m.iridescenceIOR,f.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,f.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(f.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,f.iridescenceMapTransform)),m.iridescenceThicknessMap&&(f.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,f.iridescenceThicknessMapTransform))),m.transmission>0&&(f.transmission.value=m.transmission,f.transmissionSamplerMap.value=S.texture,f.transmissionSamplerSize.value.set(S.width,S.height),m.transmissionMap&&(f.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,f.transmissionMapTransform)),f.thickness.value=m.thickness,m.thicknessMap&&(f.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,f.thicknessMapTransform)),f.attenuationDistance.value=m.attenuationDistance,f.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(f.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(f.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,f.anisotropyMapTransform))),f.specularIntensity.value=m.specularIntensity,f.specularColor.value.copy(m.specularColor),m.specularColorMap&&(f.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,f.specularColorMapTransform)),m.specularIntensityMap&&(f.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,f.specularIntensityMapTransform))}a(g,"refreshUniformsPhysical");function _(f,m){m.matcap&&(f.matcap.value=m.matcap)}a(_,"refreshUniformsMatcap");function y(f,m){let S=e.get(m).light;f.referencePosition.value.setFromMatrixPosition(S.matrixWorld),f.nearDistance.value=S.shadow.camera.near,f.farDistance.value=S.shadow.camera.far}return a(y,"refreshUniformsDistance"),{refreshFogUniforms:n,refreshMaterialUniforms:r}}a(Iy,"WebGLMaterials");function Ly(i,e,t,n){let r={},s={};function o(S,A){let v=A.program;n.uniformBlockBinding(S,v,r[S.id])}a(o,"bind");function l(S,A){let v=r[S.id];v===void 0&&(_(S),v=c(S),r[S.id]=v,S.addEventListener("dispose",f));let M=A.program;n.updateUBOMapping(S,M);let T=e.render.frame;s[S.id]!==T&&(u(S),s[S.id]=T)}a(l,"update");function c(S){let A=i.createBuffer(),v=S.__size,M=S.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,v,M),i.bindBuffer(i.UNIFORM_BUFFER,null),A}a(c,"createBuffer");function u(S){let A=r[S.id],v=S.uniforms,M=S.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let T=0,x=v.length;T<x;T++){let w=v[T];if(Array.isArray(w))for(let P=0,C=w.length;P<C;P++)d(w[P],T,P,M);else d(w,T,0,M)}i.bindBuffer(i.UNIFORM_BUFFER,null)}a(u,"updateBufferData");function d(S,A,v,M){if(h(S,A,v,M)===!0){let T=S.__offset,x=S.value;if(Array.isArray(x)){let w=0;for(let P=0;P<x.length;P++){let C=x[P],D=y(C,!0);p(C,S.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else p(x,S.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,S.__data)}}a(d,"updateUniform");function p(S,A,v){typeof S=="number"||typeof S=="boolean"?A[v]=S:S.isMatrix3?(A[v]=S.elements[0],A[v+1]=S.elements[1],A[v+2]=S.elements[2],A[v+3]=0,A[v+4]=S.elements[3],A[v+5]=S.elements[4],A[v+6]=S.elements[5],A[v+7]=0,A[v+8]=S.elements[6],A[v+9]=S.elements[7],A[v+10]=S.elements[8],A[v+11]=0):ArrayBuffer.isView(S)?A.set(S.subarray(0,A.length-v),v):S.toArray(A,v)}a(p,"writeUniformValue");function h(S,A,v,M){let T=S.value,x=A+"_"+v;if(Array.isArray(T)){M[x]===void 0&&(M[x]=[]);let w=M[x],P=!1;for(let C=0;C<T.length;C++)g(T[C],w,C)===!0&&(P=!0);return P}return g(T,M,x)}a(h,"hasUniformChanged");function g(S,A,v){if(A[v]===void 0)return typeof S=="number"||typeof S=="boolean"?A[v]=S:ArrayBuffer.isView(S)?A[v]=S.slice():A[v]=S.clone(),!0;{let M=A[v];if(typeof S=="number"||typeof S=="boolean"){if(M!==S)return A[v]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(M.equals(S)===!1)return M.copy(S),!0}}return!1}a(g,"hasValueChanged");function _(S){let A=S.uniforms,v=0,M=16;for(let x=0,w=A.length;x<w;x++){let P=Array.isArray(A[x])?A[x]:[A[x]];for(let C=0,D=P.length;C<D;C++){let B=P[C],X=Array.isArray(B.value)?B.value:[B.value],L=Array.isArray(A[x])||Array.isArray(B.value),q=v;for(let z=0,te=X.length;z<te;z++){let Y=X[z],ee=y(Y,L),ne=v%M,Me=ne%ee.boundary,Ie=ne+Me;v+=Me,Ie!==0&&M-Ie<ee.storage&&(v+=M-Ie),z===0&&(q=v),v+=ee.storage}let O=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new O((v-q)/Float32Array.BYTES_PER_ELEMENT),B.__offset=q}}let T=v%M;return T>0&&(v+=M-T),S.__size=v,S.__cache={},this}a(_,"prepareUniformsGroup");function y(S,A){let v={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(v.boundary=4,v.storage=4):S.isVector2?(v.boundary=8,v.storage=8):S.isVector3||S.isColor?(v.boundary=16,v.storage=12):S.isVector4?(v.boundary=16,v.storage=16):S.isMatrix3?(v.boundary=16,v.storage=48):S.isMatrix4?(v.boundary=16,v.storage=64):S.isTexture?Pe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(v.boundary=16,v.storage=S.byteLength):Pe("WebGLRenderer: Unsupported uniform value type.",S),A===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}a(y,"getUniformSize");function f(S){let A=S.target;A.removeEventListener("dispose",f),i.deleteBuffer(r[A.id]),delete r[A.id],delete s[A.id]}a(f,"onUniformsGroupsDispose");function m(){for(let S in r)i.deleteBuffer(r[S]);r={},s={}}return a(m,"dispose"),{bind:o,update:l,dispose:m}}a(Ly,"WebGLUniformsGroups");var Ny=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Nn=null;function Dy(){return Nn===null&&(Nn=new zr(Ny,16,16,fi,Sn),Nn.name="DFG_LUT",Nn.minFilter=At,Nn.magFilter=At,Nn.wrapS=An,Nn.wrapT=An,Nn.generateMipmaps=!1,Nn.needsUpdate=!0),Nn}a(Dy,"getDFGLUT");var Ma=class{static{a(this,"WebGLRenderer")}constructor(e={}){let{canvas:t=Gh(),context:n=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:l=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:u=!1,powerPreference:d="default",failIfMajorPerformanceCaveat:p=!1,reversedDepthBuffer:h=!1,outputBufferType:g=jt}=e;this.isWebGLRenderer=!0;let _;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=n.getContextAttributes().alpha}else _=o;let y=g,f=new Set([zo,ko,Bo]),m=new Set([jt,Qt,dr,Li,Uo,Fo]),S=new Uint32Array(4),A=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},M=null,T=null,x=[],w=[],P=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ln,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let C=this,D=!1,B=null,X=null,L=null,q=null;this._outputColorSpace=zt;let O=0,z=0,te=null,Y=-1,ee=null,ne=new nt,Me=new nt,Ie=null,F=new ke(0),J=0,ie=t.width,ve=t.height,ae=1,Le=null,rt=null,Te=new nt(0,0,ie,ve),Ve=new nt(0,0,ie,ve),et=!1,He=new Ri,wt=new fo,pt=!1,Ht=!1,lt=new Qe,bn=new H,xt=new nt,en={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function nn(){return te===null?ae:1}a(nn,"getTargetPixelRatio");let U=n;function rn(E,N){return t.getContext(E,N)}a(rn,"getContext");let ot,at,me,mt,Ce,Ue,R,b,G,re,Q,le,fe,Z,K,ue,I,j,$,he,oe,ce,Ae;try{let E={alpha:!0,depth:r,stencil:s,antialias:l,premultipliedAlpha:c,preserveDrawingBuffer:u,powerPreference:d,failIfMajorPerformanceCaveat:p};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Re,!1),t.addEventListener("webglcontextrestored",Oe,!1),t.addEventListener("webglcontextcreationerror",ge,!1),U===null){let N="webgl2";if(U=rn(N,E),U===null)throw rn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Be()}catch(E){throw t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",Oe,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),Ne("WebGLRenderer: "+E.message),E}function Be(){ot=new X_(U),ot.init(),oe=new Ay(U,ot),at=new D_(U,ot,e,oe),me=new Ey(U,ot),at.reversedDepthBuffer&&h&&me.buffers.depth.setReversed(!0),X=U.createFramebuffer(),L=U.createFramebuffer(),q=U.createFramebuffer(),mt=new $_(U),Ce=new hy,Ue=new Ty(U,ot,me,Ce,at,oe,mt),R=new W_(C),b=new Zm(U),ce=new L_(U,b),G=new q_(U,b,mt,ce),re=new Z_(U,G,b,ce,mt),j=new J_(U,at,Ue),K=new U_(Ce),Q=new uy(C,R,ot,at,ce,K),le=new Iy(C,Ce),fe=new fy,Z=new yy(ot),I=new I_(C,R,me,re,_,c),ue=new wy(C,re,at),Ae=new Ly(U,mt,at,me),$=new N_(U,ot,mt),he=new Y_(U,ot,mt),mt.programs=Q.programs,C.capabilities=at,C.extensions=ot,C.properties=Ce,C.renderLists=fe,C.shadowMap=ue,C.state=me,C.info=mt}a(Be,"initGLContext"),y!==jt&&(P=new j_(y,t.width,t.height,l,r,s));let se=new ac(C,U);this.xr=se,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let E=ot.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=ot.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return ae},this.setPixelRatio=function(E){E!==void 0&&(ae=E,this.setSize(ie,ve,!1))},this.getSize=function(E){return E.set(ie,ve)},this.setSize=function(E,N,W=!0){if(se.isPresenting){Pe("WebGLRenderer: Can't change size while VR device is presenting.");return}ie=E,ve=N,t.width=Math.floor(E*ae),t.height=Math.floor(N*ae),W===!0&&(t.style.width=E+"px",t.style.height=N+"px"),P!==null&&P.setSize(t.width,t.height),this.setViewport(0,0,E,N)},this.getDrawingBufferSize=function(E){return E.set(ie*ae,ve*ae).floor()},this.setDrawingBufferSize=function(E,N,W){ie=E,ve=N,ae=W,t.width=Math.floor(E*W),t.height=Math.floor(N*W),this.setViewport(0,0,E,N)},this.setEffects=function(E){if(y===jt){Ne("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let N=0;N<E.length;N++)if(E[N].isOutputPass===!0){Pe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}P.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(ne)},this.getViewport=function(E){return E.copy(Te)},this.setViewport=function(E,N,W,k){E.isVector4?Te.set(E.x,E.y,E.z,E.w):Te.set(E,N,W,k),me.viewport(ne.copy(Te).multiplyScalar(nn()).round())},this.getScissor=function(E){return E.copy(Ve)},this.setScissor=function(E,N,W,k){E.isVector4?Ve.set(E.x,E.y,E.z,E.w):Ve.set(E,N,W,k),me.scissor(Me.copy(Ve).multiplyScalar(nn()).round())},this.getScissorTest=function(){return et},this.setScissorTest=function(E){me.setScissorTest(et=E)},this.setOpaqueSort=function(E){Le=E},this.setTransparentSort=function(E){rt=E},this.getClearColor=function(E){return E.copy(I.getClearColor())},this.setClearColor=function(){I.setClearColor(...arguments)},this.getClearAlpha=function(){return I.getClearAlpha()},this.setClearAlpha=function(){I.setClearAlpha(...arguments)},this.clear=function(E=!0,N=!0,W=!0){let k=0;if(E){let V=!1;if(te!==null){let pe=te.texture.format;V=f.has(pe)}if(V){let pe=te.texture.type,Se=m.has(pe),de=I.getClearColor(),xe=I.getClearAlpha(),Ee=de.r,Fe=de.g,We=de.b;Se?(S[0]=Ee,S[1]=Fe,S[2]=We,S[3]=xe,U.clearBufferuiv(U.COLOR,0,S)):(A[0]=Ee,A[1]=Fe,A[2]=We,A[3]=xe,U.clearBufferiv(U.COLOR,0,A))}else k|=U.COLOR_BUFFER_BIT}N&&(k|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),W&&(k|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&U.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),B=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Re,!1),t.removeEventListener("webglcontextrestored",Oe,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),I.dispose(),fe.dispose(),Z.dispose(),Ue.dispose(),Ce.dispose(),R.dispose(),re.dispose(),G.dispose(),ce.dispose(),Ae.dispose(),Q.dispose(),se.dispose(),se.removeEventListener("sessionstart",Bc),se.removeEventListener("sessionend",kc),xi.stop()};function Re(E){E.preventDefault(),Dr("WebGLRenderer: Context Lost."),D=!0}a(Re,"onContextLost");function Oe(){Dr("WebGLRenderer: Context Restored."),D=!1;let E=mt.autoReset,N=ue.enabled,W=ue.autoUpdate,k=ue.needsUpdate,V=ue.type;Be(),mt.autoReset=E,ue.enabled=N,ue.autoUpdate=W,ue.needsUpdate=k,ue.type=V}a(Oe,"onContextRestore");function ge(E){Ne("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}a(ge,"onContextCreationError");function je(E){let N=E.target;N.removeEventListener("dispose",je),yt(N)}a(je,"onMaterialDispose");function yt(E){Kn(E),Ce.remove(E)}a(yt,"deallocateMaterial");function Kn(E){let N=Ce.get(E).programs;N!==void 0&&(N.forEach(function(W){Q.releaseProgram(W)}),E.isShaderMaterial&&Q.releaseShaderCache(E))}a(Kn,"releaseMaterialProgramReferences"),this.renderBufferDirect=function(E,N,W,k,V,pe){N===null&&(N=en);let Se=V.isMesh&&V.matrixWorld.determinantAffine()<0,de=op(E,N,W,k,V);me.setMaterial(k,Se);let xe=W.index,Ee=1;if(k.wireframe===!0){if(xe=G.getWireframeAttribute(W),xe===void 0)return;Ee=2}let Fe=W.drawRange,We=W.attributes.position,be=Fe.start*Ee,Xe=(Fe.start+Fe.count)*Ee;pe!==null&&(be=Math.max(be,pe.start*Ee),Xe=Math.min(Xe,(pe.start+pe.count)*Ee)),xe!==null?(be=Math.max(be,0),Xe=Math.min(Xe,xe.count)):We!=null&&(be=Math.max(be,0),Xe=Math.min(Xe,We.count));let dt=Xe-be;if(dt<0||dt===1/0)return;ce.setup(V,k,de,W,xe);let it,tt=$;if(xe!==null&&(it=b.get(xe),tt=he,tt.setIndex(it)),V.isMesh)k.wireframe===!0?(me.setLineWidth(k.wireframeLinewidth*nn()),tt.setMode(U.LINES)):tt.setMode(U.TRIANGLES);else if(V.isLine){let Rt=k.linewidth;Rt===void 0&&(Rt=1),me.setLineWidth(Rt*nn()),V.isLineSegments?tt.setMode(U.LINES):V.isLineLoop?tt.setMode(U.LINE_LOOP):tt.setMode(U.LINE_STRIP)}else V.isPoints?tt.setMode(U.POINTS):V.isSprite&&tt.setMode(U.TRIANGLES);if(V.isBatchedMesh)if(ot.get("WEBGL_multi_draw"))tt.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let Rt=V._multiDrawStarts,we=V._multiDrawCounts,Ot=V._multiDrawCount,Ze=xe?b.get(xe).bytesPerElement:1,yi=Ce.get(k).currentProgram.getUniforms();for(let Ct=0;Ct<Ot;Ct++)yi.setValue(U,"_gl_DrawID",Ct),tt.render(Rt[Ct]/Ze,we[Ct])}else if(V.isInstancedMesh)tt.renderInstances(be,dt,V.count);else if(W.isInstancedBufferGeometry){let Rt=W._maxInstanceCount!==void 0?W._maxInstanceCount:1/0,we=Math.min(W.instanceCount,Rt);tt.renderInstances(be,dt,we)}else tt.render(be,dt)};function Oc(E,N,W,k){B!==null&&E.isNodeMaterial&&B.setObject(k,E),pt===!0&&K.setState(E,W,!1),E.transparent===!0&&E.side===cn&&E.forceSinglePass===!1?(E.side=Vt,E.needsUpdate=!0,gr(E,N,k),E.side=hi,E.needsUpdate=!0,gr(E,N,k),E.side=cn):gr(E,N,k)}a(Oc,"prepareMaterial"),this.compile=function(E,N,W=null){W===null&&(W=E),B!==null&&B.renderStart(E,N,W),T=Z.get(W),T.init(N),w.push(T),W.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(T.pushLight(V),V.castShadow&&T.pushShadow(V))}),E!==W&&E.traverseVisible(function(V){V.isLight&&V.layers.test(N.layers)&&(T.pushLight(V),V.castShadow&&T.pushShadow(V))}),T.setupLights(),B!==null&&B.updateLights(T.state.lightsArray),Ht=this.localClippingEnabled,pt=K.init(this.clippingPlanes,Ht),pt===!0&&K.setGlobalState(this.clippingPlanes,N),B!==null&&ue.render(T.state.shadowsArray,W,N);let k=new Set;return E.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let pe=V.material;if(pe)if(Array.isArray(pe))for(let Se=0;Se<pe.length;Se++){let de=pe[Se];Oc(de,W,N,V),k.add(de)}else Oc(pe,W,N,V),k.add(pe)}),T=w.pop(),B!==null&&B.renderEnd(),k},this.compileAsync=function(E,N,W=null){let k=this.compile(E,N,W);return new Promise(V=>{function pe(){if(k.forEach(function(Se){let xe=Ce.get(Se).currentProgram;(xe===void 0||xe.isReady())&&k.delete(Se)}),k.size===0){V(E);return}setTimeout(pe,10)}a(pe,"checkMaterialsReady"),ot.get("KHR_parallel_shader_compile")!==null?pe():setTimeout(pe,10)})};let Fa=null;function rp(E){Fa&&Fa(E)}a(rp,"onAnimationFrame");function Bc(){xi.stop()}a(Bc,"onXRSessionStart");function kc(){xi.start()}a(kc,"onXRSessionEnd");let xi=new yd;xi.setAnimationLoop(rp),typeof self<"u"&&xi.setContext(self),this.setAnimationLoop=function(E){Fa=E,se.setAnimationLoop(E),E===null?xi.stop():xi.start()},se.addEventListener("sessionstart",Bc),se.addEventListener("sessionend",kc),this.render=function(E,N){if(N!==void 0&&N.isCamera!==!0){Ne("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;B!==null&&B.renderStart(E,N);let W=se.enabled===!0&&se.isPresenting===!0,k=P!==null&&(te===null||W)&&P.begin(C,te);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),se.enabled===!0&&se.isPresenting===!0&&(P===null||P.isCompositing()===!1)&&(se.cameraAutoUpdate===!0&&se.updateCamera(N),N=se.getCamera()),E.isScene===!0&&E.onBeforeRender(C,E,N,te),T=Z.get(E,w.length),T.init(N),T.state.textureUnits=Ue.getTextureUnits(),w.push(T),lt.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?wt.setFromArrayCamera(N):He.setFromProjectionMatrix(lt,ln,N.reversedDepth),Ht=this.localClippingEnabled,pt=K.init(this.clippingPlanes,Ht),M=fe.get(E,x.length),M.init(),x.push(M),this.info.render.frame++,se.enabled===!0&&se.isPresenting===!0){let Se=C.xr.getDepthSensingMesh();Se!==null&&Oa(Se,N,-1/0,C.sortObjects)}Oa(E,N,0,C.sortObjects),M.finish(),B!==null&&B.updateLights(T.state.lightsArray),C.sortObjects===!0&&M.sort(Le,rt),tn=se.enabled===!1||se.isPresenting===!1||se.hasDepthSensing()===!1,tn&&I.addToRenderList(M,E),this.info.autoReset===!0&&this.info.reset(),pt===!0&&K.beginShadows();let V=T.state.shadowsArray;if(ue.render(V,E,N),pt===!0&&K.endShadows(),(k&&P.hasRenderPass())===!1){let Se=M.opaque,de=M.transmissive;if(T.setupLights(),N.isArrayCamera){let xe=N.cameras;if(de.length>0)for(let Ee=0,Fe=xe.length;Ee<Fe;Ee++){let We=xe[Ee];Gc(Se,de,E,We)}tn&&I.render(E);for(let Ee=0,Fe=xe.length;Ee<Fe;Ee++){let We=xe[Ee];zc(M,E,We,We.viewport)}}else de.length>0&&Gc(Se,de,E,N),tn&&I.render(E),zc(M,E,N)}te!==null&&z===0&&(Ue.updateMultisampleRenderTarget(te),Ue.updateRenderTargetMipmap(te)),k&&P.end(C),E.isScene===!0&&E.onAfterRender(C,E,N),ce.resetDefaultState(),Y=-1,ee=null,w.pop(),w.length>0?(T=w[w.length-1],Ue.setTextureUnits(T.state.textureUnits),pt===!0&&K.setGlobalState(C.clippingPlanes,T.state.camera)):T=null,x.pop(),x.length>0?M=x[x.length-1]:M=null,B!==null&&B.renderEnd()};function Oa(E,N,W,k){if(E.visible===!1)return;if(E.layers.test(N.layers)){if(E.isGroup)W=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(N);else if(E.isLight)T.pushLight(E),E.castShadow&&T.pushShadow(E);else if(E.isSprite){let Se=N.isArrayCamera?wt:He;if(!E.frustumCulled||E.intersectsFrustum(Se)){k&&xt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(lt);let de=re.update(E),xe=E.material;xe.visible&&M.push(E,de,xe,W,xt.z,null,N)}}else if(E.isMesh||E.isLine||E.isPoints){let Se=N.isArrayCamera?wt:He;if(!E.frustumCulled||E.intersectsFrustum(Se)){let de=re.update(E),xe=E.material;if(k&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),xt.copy(E.boundingSphere.center)):(de.boundingSphere===null&&de.computeBoundingSphere(),xt.copy(de.boundingSphere.center)),xt.applyMatrix4(E.matrixWorld).applyMatrix4(lt)),Array.isArray(xe)){let Ee=de.groups;for(let Fe=0,We=Ee.length;Fe<We;Fe++){let be=Ee[Fe],Xe=xe[be.materialIndex];Xe&&Xe.visible&&M.push(E,de,Xe,W,xt.z,be,N)}}else xe.visible&&M.push(E,de,xe,W,xt.z,null,N)}}}let pe=E.children;for(let Se=0,de=pe.length;Se<de;Se++)Oa(pe[Se],N,W,k)}a(Oa,"projectObject");function zc(E,N,W,k){let{opaque:V,transmissive:pe,transparent:Se}=E;T.setupLightsView(W),pt===!0&&K.setGlobalState(C.clippingPlanes,W),k&&me.viewport(ne.copy(k)),V.length>0&&gs(V,N,W),pe.length>0&&gs(pe,N,W),Se.length>0&&gs(Se,N,W),me.buffers.depth.setTest(!0),me.buffers.depth.setMask(!0),me.buffers.color.setMask(!0),me.setPolygonOffset(!1)}a(zc,"renderScene");function Gc(E,N,W,k){if((W.isScene===!0?W.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[k.id]===void 0){let be=ot.has("EXT_color_buffer_half_float")||ot.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[k.id]=new Dt(1,1,{generateMipmaps:!0,type:be?Sn:jt,minFilter:vn,samples:Math.max(4,at.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:qe.workingColorSpace})}let pe=T.state.transmissionRenderTarget[k.id],Se=k.viewport||ne;pe.setSize(Se.z*C.transmissionResolutionScale,Se.w*C.transmissionResolutionScale);let de=C.getRenderTarget(),xe=C.getActiveCubeFace(),Ee=C.getActiveMipmapLevel();C.setRenderTarget(pe),C.getClearColor(F),J=C.getClearAlpha(),J<1&&C.setClearColor(16777215,.5),C.clear(),tn&&I.render(W);let Fe=C.toneMapping;C.toneMapping=Ln;let We=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),T.setupLightsView(k),pt===!0&&K.setGlobalState(C.clippingPlanes,k),gs(E,W,k),Ue.updateMultisampleRenderTarget(pe),Ue.updateRenderTargetMipmap(pe),ot.has("WEBGL_multisampled_render_to_texture")===!1){let be=!1;for(let Xe=0,dt=N.length;Xe<dt;Xe++){let it=N[Xe],{object:tt,geometry:Rt,material:we,group:Ot}=it;if(we.side===cn&&tt.layers.test(k.layers)){let Ze=we.side;we.side=Vt,we.needsUpdate=!0,Vc(tt,W,k,Rt,we,Ot),we.side=Ze,we.needsUpdate=!0,be=!0}}be===!0&&(Ue.updateMultisampleRenderTarget(pe),Ue.updateRenderTargetMipmap(pe))}C.setRenderTarget(de,xe,Ee),C.setClearColor(F,J),We!==void 0&&(k.viewport=We),C.toneMapping=Fe}a(Gc,"renderTransmissionPass");function gs(E,N,W){let k=N.isScene===!0?N.overrideMaterial:null;for(let V=0,pe=E.length;V<pe;V++){let Se=E[V],{object:de,geometry:xe,group:Ee}=Se,Fe=Se.material;Fe.allowOverride===!0&&k!==null&&(Fe=k),de.layers.test(W.layers)&&Vc(de,N,W,xe,Fe,Ee)}}a(gs,"renderObjects");function Vc(E,N,W,k,V,pe){B!==null&&V.isNodeMaterial&&B.setObject(E,V),E.onBeforeRender(C,N,W,k,V,pe),E.modelViewMatrix.multiplyMatrices(W.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),V.onBeforeRender(C,N,W,k,E,pe),V.transparent===!0&&V.side===cn&&V.forceSinglePass===!1?(V.side=Vt,V.needsUpdate=!0,C.renderBufferDirect(W,N,k,V,E,pe),V.side=hi,V.needsUpdate=!0,C.renderBufferDirect(W,N,k,V,E,pe),V.side=cn):C.renderBufferDirect(W,N,k,V,E,pe),E.onAfterRender(C,N,W,k,V,pe)}a(Vc,"renderObject");function Hc(E){let N=0;for(let W of E)W.texture!==null&&N++;return N}a(Hc,"countLightProbeGrids");function gr(E,N,W){N.isScene!==!0&&(N=en);let k=Ce.get(E),V=T.state.lights,pe=T.state.shadowsArray,Se=V.state.version,de=Q.getParameters(E,V.state,pe,N,W,T.state.lightProbeGridArray),xe=Q.getProgramCacheKey(de),Ee=k.programs;k.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?N.environment:null,k.fog=N.fog;let Fe=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;k.envMap=R.get(E.envMap||k.environment,Fe),k.envMapRotation=k.environment!==null&&E.envMap===null?N.environmentRotation:E.envMapRotation,Ee===void 0&&(E.addEventListener("dispose",je),Ee=new Map,k.programs=Ee,k.programVariants=new Map);let We=Ee.get(xe);if(We!==void 0){if(k.currentProgram===We&&k.lightsStateVersion===Se)return Xc(E,de),We}else de.uniforms=Q.getUniforms(E),B!==null&&E.isNodeMaterial&&B.build(E,W,de),E.onBeforeCompile(de,C),We=Q.acquireProgram(de,xe),Ee.set(xe,We),k.uniforms=de.uniforms;let be=k.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(be.clippingPlanes=K.uniform),Xc(E,de),k.needsLights=lp(E),k.lightsStateVersion=Se,k.needsLights&&(be.ambientLightColor.value=V.state.ambient,be.lightProbe.value=V.state.probe,be.sunLights.value=V.state.sun,be.sunLightShadows.value=V.state.sunShadow,be.directionalLights.value=V.state.directional,be.directionalLightShadows.value=V.state.directionalShadow,be.spotLights.value=V.state.spot,be.spotLightShadows.value=V.state.spotShadow,be.rectAreaLights.value=V.state.rectArea,be.ltc_1.value=V.state.rectAreaLTC1,be.ltc_2.value=V.state.rectAreaLTC2,be.pointLights.value=V.state.point,be.pointLightShadows.value=V.state.pointShadow,be.hemisphereLights.value=V.state.hemi,be.sunShadowMatrix.value=V.state.sunShadowMatrix,be.sunShadowCascade.value=V.state.sunShadowCascade,be.directionalShadowMatrix.value=V.state.directionalShadowMatrix,be.spotLightMatrix.value=V.state.spotLightMatrix,be.spotLightMap.value=V.state.spotLightMap,be.pointShadowMatrix.value=V.state.pointShadowMatrix),k.numLightProbeGrids=Hc(T.state.lightProbeGridArray),k.currentProgram=We,k.uniformsList=null,We}a(gr,"getProgram");function sp(E,N,W,k,V){let pe=Ce.get(E),Se=pe.currentProgram.id+","+k+","+V,de=pe.programVariants.get(Se);return de===void 0?(de=gr(E,N,W),pe.programVariants.set(Se,de)):(pe.currentProgram=de,pe.uniformsList=null,pe.outputColorSpace=k,pe.toneMapping=V),de}a(sp,"getProgramVariant");function Wc(E){if(E.uniformsList===null){let N=E.currentProgram.getUniforms();E.uniformsList=fr.seqWithValue(N.seq,E.uniforms)}return E.uniformsList}a(Wc,"getUniformList");function Xc(E,N){let W=Ce.get(E);W.outputColorSpace=N.outputColorSpace,W.batching=N.batching,W.batchingColor=N.batchingColor,W.instancing=N.instancing,W.instancingColor=N.instancingColor,W.instancingMorph=N.instancingMorph,W.skinning=N.skinning,W.morphTargets=N.morphTargets,W.morphNormals=N.morphNormals,W.morphColors=N.morphColors,W.morphTargetsCount=N.morphTargetsCount,W.numClippingPlanes=N.numClippingPlanes,W.numIntersection=N.numClipIntersection,W.vertexAlphas=N.vertexAlphas,W.vertexTangents=N.vertexTangents,W.toneMapping=N.toneMapping}a(Xc,"updateCommonMaterialProperties");function op(E,N,W,k,V){N.isScene!==!0&&(N=en),Ue.resetTextureUnits();let pe=N.fog,Se=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?N.environment:null,de=te===null?C.outputColorSpace:te.isXRRenderTarget===!0?te.texture.colorSpace:qe.workingColorSpace,xe=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Ee=R.get(k.envMap||Se,xe),Fe=k.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,We=!!W.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),be=!!W.morphAttributes.position,Xe=!!W.morphAttributes.normal,dt=!!W.morphAttributes.color,it=Ln;k.toneMapped&&(te===null||te.isXRRenderTarget===!0)&&(it=C.toneMapping);let tt=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,Rt=tt!==void 0?tt.length:0,we=Ce.get(k),Ot=T.state.lights;if(pt===!0&&(Ht===!0||E!==ee)){let ct=E===ee&&k.id===Y;K.setState(k,E,ct)}let Ze=!1,yi=!1;k.version===we.__version?we.needsLights&&we.lightsStateVersion!==Ot.state.version||V.isBatchedMesh&&we.batching===!1||!V.isBatchedMesh&&we.batching===!0||V.isBatchedMesh&&we.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&we.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&we.instancing===!1||!V.isInstancedMesh&&we.instancing===!0||V.isSkinnedMesh&&we.skinning===!1||!V.isSkinnedMesh&&we.skinning===!0||V.isInstancedMesh&&we.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&we.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&we.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&we.instancingMorph===!1&&V.morphTexture!==null||we.envMap!==Ee||k.fog===!0&&we.fog!==pe||we.numClippingPlanes!==void 0&&(we.numClippingPlanes!==K.numPlanes||we.numIntersection!==K.numIntersection)||we.vertexAlphas!==Fe||we.vertexTangents!==We||we.morphTargets!==be||we.morphNormals!==Xe||we.morphColors!==dt||we.morphTargetsCount!==Rt||we.numLightProbeGrids!==Hc(T.state.lightProbeGridArray)?Ze=!0:(we.outputColorSpace!==de||we.toneMapping!==it)&&(yi=!0):(Ze=!0,we.__version=k.version);let Ct=we.currentProgram;(Ze===!0||yi===!0)&&(Ct=yi===!0?sp(k,N,V,de,it):gr(k,N,V),B&&k.isNodeMaterial&&B.onUpdateProgram(k,Ct,we));let _s=!1,jn=!1,vi=!1,Je=Ct.getUniforms(),Et=we.uniforms;if(me.useProgram(Ct.program)&&(_s=!0,jn=!0,vi=!0),k.id!==Y&&(Y=k.id,jn=!0),_s||ee!==E){me.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),Je.setValue(U,"projectionMatrix",E.projectionMatrix),Je.setValue(U,"viewMatrix",E.matrixWorldInverse);let vt=Je.map.cameraPosition;vt!==void 0&&vt.setValue(U,bn.setFromMatrixPosition(E.matrixWorld)),at.logarithmicDepthBuffer&&Je.setValue(U,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&Je.setValue(U,"isOrthographic",E.isOrthographicCamera===!0),ee!==E&&(ee=E,jn=!0,vi=!0)}if(we.needsLights&&(Ot.state.sunShadowMap.length>0&&Je.setValue(U,"sunShadowMap",Ot.state.sunShadowMap,Ue),Ot.state.directionalShadowMap.length>0&&Je.setValue(U,"directionalShadowMap",Ot.state.directionalShadowMap,Ue),Ot.state.spotShadowMap.length>0&&Je.setValue(U,"spotShadowMap",Ot.state.spotShadowMap,Ue),Ot.state.pointShadowMap.length>0&&Je.setValue(U,"pointShadowMap",Ot.state.pointShadowMap,Ue)),V.isSkinnedMesh){Je.setOptional(U,V,"bindMatrix"),Je.setOptional(U,V,"bindMatrixInverse");let ct=V.skeleton;ct&&(ct.boneTexture===null&&ct.computeBoneTexture(),Je.setValue(U,"boneTexture",ct.boneTexture,Ue))}V.isBatchedMesh&&(Je.setOptional(U,V,"batchingTexture"),Je.setValue(U,"batchingTexture",V._matricesTexture,Ue),Je.setOptional(U,V,"batchingIdTexture"),Je.setValue(U,"batchingIdTexture",V._indirectTexture,Ue),Je.setOptional(U,V,"batchingColorTexture"),V._colorsTexture!==null&&Je.setValue(U,"batchingColorTexture",V._colorsTexture,Ue));let hn=W.morphAttributes;if((hn.position!==void 0||hn.normal!==void 0||hn.color!==void 0)&&j.update(V,W,Ct),(jn||we.receiveShadow!==V.receiveShadow)&&(we.receiveShadow=V.receiveShadow,Je.setValue(U,"receiveShadow",V.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&N.environment!==null&&(Et.envMapIntensity.value=N.environmentIntensity),Et.dfgLUT!==void 0&&(Et.dfgLUT.value=Dy()),jn){if(Je.setValue(U,"toneMappingExposure",C.toneMappingExposure),we.needsLights&&ap(Et,vi),pe&&k.fog===!0&&le.refreshFogUniforms(Et,pe),le.refreshMaterialUniforms(Et,k,ae,ve,T.state.transmissionRenderTarget[E.id]),we.needsLights&&we.numLightProbeGrids>0){let ct=v,vt=0;for(let Fn of T.state.lightProbeGridArray)Fn.texture!==null&&(ct.textures[vt]=Fn.texture,ct.min[vt]=Fn.boundingBox.min,ct.max[vt]=Fn.boundingBox.max,ct.resolution[vt]=Fn.resolution,vt++);for(let Fn in ct)ct[Fn].length=vt;Et.probesSH.value=ct.textures,Et.probesMin.value=ct.min,Et.probesMax.value=ct.max,Et.probesResolution.value=ct.resolution}fr.upload(U,Wc(we),Et,Ue)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(fr.upload(U,Wc(we),Et,Ue),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&Je.setValue(U,"center",V.center),Je.setValue(U,"modelViewMatrix",V.modelViewMatrix),Je.setValue(U,"normalMatrix",V.normalMatrix),Je.setValue(U,"modelMatrix",V.matrixWorld),k.uniformsGroups!==void 0){let ct=k.uniformsGroups;for(let vt=0,Fn=ct.length;vt<Fn;vt++){let Yc=ct[vt];Ae.update(Yc,Ct),Ae.bind(Yc,Ct)}}return Ct}a(op,"setProgram");function ap(E,N){E.ambientLightColor.needsUpdate=N,E.lightProbe.needsUpdate=N,E.sunLights.needsUpdate=N,E.sunLightShadows.needsUpdate=N,E.directionalLights.needsUpdate=N,E.directionalLightShadows.needsUpdate=N,E.pointLights.needsUpdate=N,E.pointLightShadows.needsUpdate=N,E.spotLights.needsUpdate=N,E.spotLightShadows.needsUpdate=N,E.rectAreaLights.needsUpdate=N,E.hemisphereLights.needsUpdate=N}a(ap,"markUniformsLightsNeedsUpdate");function lp(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}a(lp,"materialNeedsLights"),this.getActiveCubeFace=function(){return O},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return te},this.setRenderTargetTextures=function(E,N,W){let k=Ce.get(E);k.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Ce.get(E.texture).__webglTexture=N,Ce.get(E.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:W,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,N){let W=Ce.get(E);W.__webglFramebuffer=N,W.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(E,N=0,W=0){te=E,O=N,z=W;let k=null,V=!1,pe=!1;if(E){let de=Ce.get(E);if(de.__useDefaultFramebuffer!==void 0){me.bindFramebuffer(U.FRAMEBUFFER,de.__webglFramebuffer),ne.copy(E.viewport),Me.copy(E.scissor),Ie=E.scissorTest,me.viewport(ne),me.scissor(Me),me.setScissorTest(Ie),Y=-1;return}else if(de.__webglFramebuffer===void 0)Ue.setupRenderTarget(E);else if(de.__hasExternalTextures)Ue.rebindTextures(E,Ce.get(E.texture).__webglTexture,Ce.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Fe=E.depthTexture;if(de.__boundDepthTexture!==Fe){if(Fe!==null&&Ce.has(Fe)&&(E.width!==Fe.image.width||E.height!==Fe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ue.setupDepthRenderbuffer(E)}}let xe=E.texture;(xe.isData3DTexture||xe.isDataArrayTexture||xe.isCompressedArrayTexture)&&(pe=!0);let Ee=Ce.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Ee[N])?k=Ee[N][W]:k=Ee[N],V=!0):E.samples>0&&Ue.useMultisampledRTT(E)===!1?k=Ce.get(E).__webglMultisampledFramebuffer:Array.isArray(Ee)?k=Ee[W]:k=Ee,ne.copy(E.viewport),Me.copy(E.scissor),Ie=E.scissorTest}else ne.copy(Te).multiplyScalar(ae).floor(),Me.copy(Ve).multiplyScalar(ae).floor(),Ie=et;if(W!==0&&(k=X),me.bindFramebuffer(U.FRAMEBUFFER,k)&&me.drawBuffers(E,k),me.viewport(ne),me.scissor(Me),me.setScissorTest(Ie),V){let de=Ce.get(E.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+N,de.__webglTexture,W)}else if(pe){let de=N;for(let xe=0;xe<E.textures.length;xe++){let Ee=Ce.get(E.textures[xe]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+xe,Ee.__webglTexture,W,de)}}else if(E!==null&&W!==0){let de=Ce.get(E.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,de.__webglTexture,W)}Y=-1};function qc(E){let N=Ce.get(E);return(N.__readFormat!==E.format||N.__readType!==E.type)&&(N.__readFormat=E.format,N.__readType=E.type,N.__formatReadable=at.textureFormatReadable(E.format),N.__typeReadable=at.textureTypeReadable(E.type)),N}a(qc,"getReadableState"),this.readRenderTargetPixels=function(E,N,W,k,V,pe,Se,de=0){if(!(E&&E.isWebGLRenderTarget)){Ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xe=Ce.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(xe=xe[Se],Array.isArray(xe)&&(xe=xe[0])),xe){me.bindFramebuffer(U.FRAMEBUFFER,xe);try{let Ee=E.textures[de],Fe=Ee.format,We=Ee.type;E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+de);let be=qc(Ee);if(be.__formatReadable===!1){Ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(be.__typeReadable===!1){Ne("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=E.width-k&&W>=0&&W<=E.height-V&&U.readPixels(N,W,k,V,oe.convert(Fe),oe.convert(We),pe)}finally{let Ee=te!==null?Ce.get(te).__webglFramebuffer:null;me.bindFramebuffer(U.FRAMEBUFFER,Ee)}}},this.readRenderTargetPixelsAsync=async function(E,N,W,k,V,pe,Se,de=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xe=Ce.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Se!==void 0&&(xe=xe[Se],Array.isArray(xe)&&(xe=xe[0])),xe)if(N>=0&&N<=E.width-k&&W>=0&&W<=E.height-V){me.bindFramebuffer(U.FRAMEBUFFER,xe);let Ee=E.textures[de],Fe=Ee.format,We=Ee.type;E.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+de);let be=qc(Ee);if(be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Xe=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,Xe),U.bufferData(U.PIXEL_PACK_BUFFER,pe.byteLength,U.STREAM_READ),U.readPixels(N,W,k,V,oe.convert(Fe),oe.convert(We),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let dt=te!==null?Ce.get(te).__webglFramebuffer:null;me.bindFramebuffer(U.FRAMEBUFFER,dt);let it=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await Hh(U,it,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,Xe),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,pe),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(Xe),U.deleteSync(it),pe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,N=null,W=0){let k=Math.pow(2,-W),V=Math.floor(E.image.width*k),pe=Math.floor(E.image.height*k),Se=N!==null?N.x:0,de=N!==null?N.y:0;Ue.setTexture2D(E,0),U.copyTexSubImage2D(U.TEXTURE_2D,W,0,0,Se,de,V,pe),me.unbindTexture()},this.copyTextureToTexture=function(E,N,W=null,k=null,V=0,pe=0){let Se,de,xe,Ee,Fe,We,be,Xe,dt,it=E.isCompressedTexture?E.mipmaps[pe]:E.image;if(W!==null)Se=W.max.x-W.min.x,de=W.max.y-W.min.y,xe=W.isBox3?W.max.z-W.min.z:1,Ee=W.min.x,Fe=W.min.y,We=W.isBox3?W.min.z:0;else{let Je=Math.pow(2,-V);Se=Math.floor(it.width*Je),de=Math.floor(it.height*Je),E.isDataArrayTexture?xe=it.depth:E.isData3DTexture?xe=Math.floor(it.depth*Je):xe=1,Ee=0,Fe=0,We=0}k!==null?(be=k.x,Xe=k.y,dt=k.z):(be=0,Xe=0,dt=0);let tt=oe.convert(N.format),Rt=oe.convert(N.type),we;N.isData3DTexture?(Ue.setTexture3D(N,0),we=U.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(Ue.setTexture2DArray(N,0),we=U.TEXTURE_2D_ARRAY):(Ue.setTexture2D(N,0),we=U.TEXTURE_2D),me.activeTexture(U.TEXTURE0),me.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,N.flipY),me.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),me.pixelStorei(U.UNPACK_ALIGNMENT,N.unpackAlignment);let Ot=me.getParameter(U.UNPACK_ROW_LENGTH),Ze=me.getParameter(U.UNPACK_IMAGE_HEIGHT),yi=me.getParameter(U.UNPACK_SKIP_PIXELS),Ct=me.getParameter(U.UNPACK_SKIP_ROWS),_s=me.getParameter(U.UNPACK_SKIP_IMAGES);me.pixelStorei(U.UNPACK_ROW_LENGTH,it.width),me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,it.height),me.pixelStorei(U.UNPACK_SKIP_PIXELS,Ee),me.pixelStorei(U.UNPACK_SKIP_ROWS,Fe),me.pixelStorei(U.UNPACK_SKIP_IMAGES,We);let jn=E.isDataArrayTexture||E.isData3DTexture,vi=N.isDataArrayTexture||N.isData3DTexture;if(E.isDepthTexture){let Je=Ce.get(E),Et=Ce.get(N),hn=Ce.get(Je.__renderTarget),ct=Ce.get(Et.__renderTarget);me.bindFramebuffer(U.READ_FRAMEBUFFER,hn.__webglFramebuffer),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let vt=0;vt<xe;vt++)jn&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ce.get(E).__webglTexture,V,We+vt),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Ce.get(N).__webglTexture,pe,dt+vt)),U.blitFramebuffer(Ee,Fe,Ee+Se,Fe+de,be,Xe,be+Se,Xe+de,U.DEPTH_BUFFER_BIT,U.NEAREST);me.bindFramebuffer(U.READ_FRAMEBUFFER,null),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(V!==0||E.isRenderTargetTexture||Ce.has(E)){let Je=Ce.get(E),Et=Ce.get(N);me.bindFramebuffer(U.READ_FRAMEBUFFER,L),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,q);for(let hn=0;hn<xe;hn++)jn?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Je.__webglTexture,V,We+hn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Je.__webglTexture,V),vi?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Et.__webglTexture,pe,dt+hn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Et.__webglTexture,pe),V!==0?U.blitFramebuffer(Ee,Fe,Ee+Se,Fe+de,be,Xe,be+Se,Xe+de,U.COLOR_BUFFER_BIT,U.NEAREST):vi?U.copyTexSubImage3D(we,pe,be,Xe,dt+hn,Ee,Fe,Se,de):U.copyTexSubImage2D(we,pe,be,Xe,Ee,Fe,Se,de);me.bindFramebuffer(U.READ_FRAMEBUFFER,null),me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else vi?E.isDataTexture||E.isData3DTexture?U.texSubImage3D(we,pe,be,Xe,dt,Se,de,xe,tt,Rt,it.data):N.isCompressedArrayTexture?U.compressedTexSubImage3D(we,pe,be,Xe,dt,Se,de,xe,tt,it.data):U.texSubImage3D(we,pe,be,Xe,dt,Se,de,xe,tt,Rt,it):E.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,pe,be,Xe,Se,de,tt,Rt,it.data):E.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,pe,be,Xe,it.width,it.height,tt,it.data):U.texSubImage2D(U.TEXTURE_2D,pe,be,Xe,Se,de,tt,Rt,it);me.pixelStorei(U.UNPACK_ROW_LENGTH,Ot),me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Ze),me.pixelStorei(U.UNPACK_SKIP_PIXELS,yi),me.pixelStorei(U.UNPACK_SKIP_ROWS,Ct),me.pixelStorei(U.UNPACK_SKIP_IMAGES,_s),pe===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&U.generateMipmap(we),me.unbindTexture()},this.initRenderTarget=function(E){Ce.get(E).__webglFramebuffer===void 0&&Ue.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ue.setTextureCube(E,0):E.isData3DTexture?Ue.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ue.setTexture2DArray(E,0):Ue.setTexture2D(E,0),me.unbindTexture()},this.resetState=function(){O=0,z=0,te=null,me.reset(),ce.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ln}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=qe._getDrawingBufferColorSpace(e),t.unpackColorSpace=qe._getUnpackColorSpace()}};function Pd(i,e,t=16777216){let n=new Map,r=0;return{fetch(s,o){let l=n.get(s);return l?(n.delete(s),r-=e(s),l):i(s,o)},want(s,o){for(let l of s){if(n.has(l)||r+e(l)>t)continue;let c=i(l,o);c.catch(()=>{}),n.set(l,c),r+=e(l)}},get bytes(){return r}}}a(Pd,"createAhead");var Id=256,lc=6;function mr(i,e){let t=i.getContext(),n=Nd(i,Ld(t,e,t.SRGB8_ALPHA8,t.LINEAR)),r=Nd(i,Ld(t,e,t.R16UI,t.NEAREST));return i.resetState(),{color:n,codes:r,holds:null,hasRange:!1,dispose(){for(let s of[n,r])t.deleteTexture(cc(i,s)),i.properties.remove(s)}}}a(mr,"createCube");function Ld(i,e,t,n){let r=i.createTexture();return i.bindTexture(i.TEXTURE_CUBE_MAP,r),i.texStorage2D(i.TEXTURE_CUBE_MAP,1,t,e,e),i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MIN_FILTER,n),i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAG_FILTER,n),r}a(Ld,"allocated");function Nd(i,e){let t=new Ci;return i.properties.get(t).__webglTexture=e,t}a(Nd,"wrapped");function cc(i,e){return i.properties.get(e).__webglTexture}a(cc,"handleOf");function Dd(i,{color:e}){return cc(i,e)}a(Dd,"colorOf");function*uc(i,e,t,n,r){let s=i.getContext(),o=r.face_size,l=a((c,u,d,p)=>{i.state.activeTexture(s.TEXTURE0),i.state.bindTexture(s.TEXTURE_CUBE_MAP,cc(i,c)),s.pixelStorei(s.UNPACK_FLIP_Y_WEBGL,!1),s.pixelStorei(s.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),s.pixelStorei(s.UNPACK_ALIGNMENT,1);let h=s.TEXTURE_CUBE_MAP_POSITIVE_X+u,[g,_]=p instanceof Uint8Array?[s.RGBA,s.UNSIGNED_BYTE]:[s.RED_INTEGER,s.UNSIGNED_SHORT];s.texSubImage2D(h,0,d.x,d.y,d.width,d.height,g,_,p),s.pixelStorei(s.UNPACK_ALIGNMENT,4)},"put");if(e.holds=null,t.whole){for(let c=0;c<lc;c++)for(let u=0;u<o;u+=Id){let d={x:0,y:u,width:o,height:Math.min(Id,o-u)},p=a((g,_)=>{if(!g)throw new Error("a map has fewer than six faces");return g.subarray(u*o*_,(u+d.height)*o*_)},"rows");yield()=>l(e.color,c,d,p(t.color[c],4));let{codes:h}=t;h&&(yield()=>l(e.codes,c,d,p(h[c],1)))}e.hasRange=t.codes!==null}else{let{tile:c}=r,u=o/c,d=c*c;for(let p=0;p<t.tiles.length;p++){let h=t.tiles[p]??0,g=Math.floor(h/(u*u)),_=h%(u*u),y={x:_%u*c,y:Math.floor(_/u)*c,width:c,height:c};yield()=>{l(e.color,g,y,t.color.subarray(4*p*d,4*(p+1)*d)),l(e.codes,g,y,t.codes.subarray(p*d,(p+1)*d))}}}e.holds=n}a(uc,"cubeSteps");var Ud=`// The morph of nearfar in GLSL: where the user is shown a point of the world. Licence: MIT or Apache-2.0.
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
`;var hc=`
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`,Uy=`
// The eye, from the centre: each eye of a headset has its own.
uniform vec3 cameraPosition;
// r1, r2, 1 / (r2 - r1), and the strength of the morph; a strength below 0 stands for no morph at all.
uniform vec4 radii;

bool is_morphed() {
  return radii.w >= 0.0;
}
`,Ea=`
vec3 srgb_of(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
`,dc=hc+Ud+Uy;var Fd=`
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
`,Od=`
${hc}
${Ea}
uniform samplerCube map;
uniform float opacity;
in vec3 v_direction;
out vec4 shade;

void main() {
  shade = vec4(srgb_of(textureLod(map, v_direction, 0.0).rgb), opacity);
}
`;var Bd=`
${dc}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
in vec3 position;
#ifdef SMOOTH
in vec3 normal;
out vec3 v_normal;
#endif
#ifdef TEXTURED
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
#ifdef TEXTURED
  v_uv = uv;
#endif
#ifdef COLORED
  v_color = color.rgb;
#endif
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`,kd=`
${dc}
${Ea}
uniform vec4 base_color;
// Share of this picture over the one before, 1 for all.
uniform float opacity;
#ifdef TEXTURED
uniform sampler2D image;
#endif
#ifdef CUTOUT
uniform float cutoff;
#endif
#ifdef SMOOTH
in vec3 v_normal;
#endif
#ifdef TEXTURED
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

const vec3 SUN_DIRECTION = vec3(0.5263158, 0.7894737, 0.3157895);
const vec3 SUN = vec3(0.60, 0.56, 0.50);
const vec3 SKY_DIRECTION = vec3(-0.2062843, 0.9282791, 0.3094264);
const vec3 SKY_LOW = vec3(0.130, 0.135, 0.150);
const vec3 SKY_HIGH = vec3(0.380, 0.420, 0.480);

vec3 irradiance(vec3 n) {
  float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
  return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}

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

void main() {
#ifdef TEXTURED
  // The level at which a texel is as large as a pixel, by areas.
  vec2 texels = vec2(textureSize(image, 0));
  vec2 dx = dFdx(v_uv) * texels;
  vec2 dy = dFdy(v_uv) * texels;
  float level = 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
#endif
  vec3 normal = shading_normal();
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
  shade = vec4(srgb_of(albedo * irradiance(normal)), opacity);
}
`;function zd(i,e){return{radii:{value:new nt},opacity:{value:1},map:{value:i},codes:{value:e},coding:{value:new nt}}}a(zd,"createShared");var Fy=1e30,Gd={blending:cr,blendSrc:ns,blendDst:di,blendSrcAlpha:ur,blendDstAlpha:di,transparent:!1,depthTest:!0,side:cn,glslVersion:Jn};function Vd(i,e,t,n){let{material:r}=i,s={};return i.normals&&(s.SMOOTH=""),i.colors&&(s.COLORED=""),i.placements&&(s.PLACED=""),e&&i.uvs&&(s.TEXTURED=""),r.cutoff!==null&&(s.CUTOUT=""),new yn({...Gd,vertexShader:Bd,fragmentShader:kd,defines:s,uniforms:{...t,...Oy(r,e),cut:{value:Math.min(n,Fy)}}})}a(Vd,"nearMaterial");function Oy(i,e){return{base_color:{value:new nt(...i.color)},cutoff:{value:i.cutoff??0},image:{value:e},placement:{value:new Qe}}}a(Oy,"ownUniforms");function Hd(i){return new yn({...Gd,vertexShader:Fd,fragmentShader:Od,depthWrite:!1,uniforms:{map:i.map,opacity:i.opacity}})}a(Hd,"farMaterial");var fc=12;function Xd(i,e,t,n,r){let s=i.placements?zy(i.placements):new Ut,o=n.take(i.same,()=>By(i));for(let[c,u]of Object.entries(o.attributes))s.setAttribute(c,u);s.setIndex(o.index);let l=new ut(s,Vd(i,e,t,r));return l.name=i.name,l.frustumCulled=!1,l.matrixAutoUpdate=!1,l.userData.triangles=ky(i),l.userData.same=i.same,l}a(Xd,"meshOf");function pc({geometry:i,material:e,userData:t},n){if(!n.give(t.same)){for(let s of Object.keys(qd))i.deleteAttribute(s);i.setIndex(null)}i.dispose(),e.dispose()}a(pc,"disposeMesh");var qd={position:3,normal:3,uv:2,color:4};function By({positions:i,normals:e,uvs:t,colors:n,indices:r}){let s={position:i,normal:e,uv:t,color:n},o={};for(let[l,c]of Object.entries(qd)){let u=s[l];u&&(o[l]=Wd(new Tt(u,c,l==="color")))}return{attributes:o,index:Wd(new Tt(r,1))}}a(By,"arraysOf");function ky(i){return i.indices.length/3*(i.placements?i.placements.length/fc:1)}a(ky,"trianglesOf");function zy(i){let e=new Qr,t=new es(i,fc);return["row_x","row_y","row_z"].forEach((n,r)=>{e.setAttribute(n,new kr(t,4,4*r))}),e.instanceCount=i.length/fc,e}a(zy,"placed");function Wd(i){return i.onUpload(()=>{i.array=new i.array.constructor(0)}),i}a(Wd,"sent");function Yd(i){let e=new Nt(i);return e.colorSpace=zt,e.flipY=!1,e.wrapS=e.wrapT=er,e.magFilter=At,e.minFilter=vn,e.needsUpdate=!0,e}a(Yd,"textureOf");function $d(i,e,t,n){let r=e.rings.map(()=>new Zt),s=[mr(i,t),mr(i,t)];return{entry:e,groups:r,cubes:s,dispose(){for(let o of r){for(let l of Aa(o))pc(l,n);o.clear()}for(let o of s)o.dispose()}}}a($d,"createRegion");function Ta(i,e){let t=i.cubes.find(n=>n.holds===e);if(!t)throw new Error(`the map of ring ${e} is not there`);return t}a(Ta,"cubeOf");function Aa(i){return i.children}a(Aa,"meshesOf");function Jd(i,e){return i.groups.slice(0,e+1).flatMap(Aa).reduce((t,n)=>t+n.userData.triangles,0)}a(Jd,"trianglesShown");function*Zd(i,e,t,n,r,s,o){let l=t===0?1/0:e.entry.cut,c=e.groups[t];if(!c)throw new Error(`there is no ring ${t}`);let u=[];try{for(let[d,p]of Object.entries(n.images))yield()=>{if(s.textures.has(d))return;let h=Yd(p);i.initTexture(h),s.textures.set(d,h)};for(let d of n.pieces)yield()=>{let{image:p}=d.material,h=p===null?null:s.textures.get(p)??null,g=Xd(d,h,r,s,l);u.push(g),o(g)};yield()=>{c.add(...u.splice(0))}}finally{for(let d of Object.values(n.images))d.close();for(let d of u)pc(d,s)}}a(Zd,"geometrySteps");async function jd(i,e){let{number:t,region:n,received:r,signal:s,turn:o}=e,{manifest:l,last:c}=i,p={...i,...e,ahead:Pd(a((_,y)=>i.fetch(_,y,r),"fetch"),a(_=>l.files[_]?.bytes??0,"sizeOf")),had:new Set},{rings:h}=n.entry;await o(s),h[0]?.map&&await Gy(p,h[0].map),e.arrived(0);let{dynamic:g}=l;g&&await Kd(p,0,g.geometry,g.parts);for(let _=1;_<h.length&&_<=c;_++){let y=h[_];if(!y)throw new Error(`region ${t} has no ring ${_}`);await o(s);let f=[];y.map&&f.push(Vy(p,_,y.map)),y.geometry!==null&&f.push(Kd(p,_,y.geometry,y.parts));let m=_<c?h[_+1]:void 0,S=a(A=>!mc(i,A)&&!p.had.has(A),"isNew");m&&p.ahead.want(yr(m).filter(S),s),await Promise.all(f),e.arrived(_)}}a(jd,"loadRegion");function mc({store:i},e){return i.textures.has(e)||i.buffers.has(e)}a(mc,"isHere");async function Kd(i,e,t,n){let{manifest:r,region:s,signal:o,store:l}=i,c=n.filter(h=>!mc(i,h));for(let h of n)mc(i,h)&&!i.had.has(h)&&i.received(r.files[h]?.bytes??0),i.had.add(h);let[u,...d]=await Promise.all([t,...c].map(h=>ef(i,h)));if(!u)throw new Error(`${t} is not there`);o.throwIfAborted();let p=await i.geometry({kind:"geometry",glb:u,parts:d,known:[...l.textures.keys()],center:s.entry.center,growth:{radii:s.entry.rings.slice(1).map(({radius:h})=>h),nearShare:r.morph.near_share,reach:r.growth.reach},isDynamic:e===0});for(let h of c)h.endsWith(".bin")&&l.buffers.add(h);await i.uploads.add(Zd(i.renderer,s,e,p,i.shared,l,i.warm),o)}a(Kd,"loadGeometry");async function Gy(i,e){let{manifest:t,region:n,renderer:r,signal:s,uploads:o}=i,l=await i.maps(Qd(i,await gc(i,e.color)));s.throwIfAborted(),await o.add(uc(r,n.cubes[0],l,0,t.map),s)}a(Gy,"loadFirstMap");async function Vy(i,e,{tiles:t,color:n,range:r}){let{manifest:s,maps:o,number:l,region:c,renderer:u,signal:d,uploads:p}=i,[h,g]=await Promise.all([gc(i,n),gc(i,r)]),_=Array.isArray(n),y=c.cubes[e%2===0?0:1];await i.mayReplace(e),d.throwIfAborted(),_&&await o(Qd(i,h)),d.throwIfAborted();let f=y.holds!==null&&y.hasRange?y.holds:null,m=await o({kind:"next-map",region:l,ring:_?1:e,tiles:t,color:_?null:h[0]??null,range:g,since:f});d.throwIfAborted(),await p.add(uc(u,y,m,e,s.map),d)}a(Vy,"loadMap");function Qd({manifest:i,number:e,region:t,signal:n},r){n.throwIfAborted();let{face_size:s,tile:o,across:l}=i.map;return{kind:"first-map",region:e,faceSize:s,tile:o,across:l,step:t.entry.range.step,color:r}}a(Qd,"firstRequest");function gc(i,e){let t=e===null?[]:typeof e=="string"?[e]:e;return Promise.all(t.map(n=>ef(i,n)))}a(gc,"filesOf");async function ef({ahead:i,manifest:e,received:t,signal:n,store:r},s){let o=e.files[s];if(!o)throw new Error(`${s} is not listed in the manifest`);let l=r.moving.get(s);l&&t(o.bytes);let c=l??await i.fetch(s,n);return s===e.dynamic?.geometry&&r.moving.set(s,c.slice(0)),{name:s,data:c,bytes:o.bytes,sha256:o.sha256}}a(ef,"fileOf");function tf(i,{isSmooth:e,isWhole:t}){let n=-1,r=-1,s=0,o=!1,l=!1,c=Yt,u=[];function d(){return r>=(t?i.radii.length:0)}a(d,"isThere");function p(y){let[f,m]=[i.radii[0],i.radii[r-1]];return d()?f===void 0||m===void 0?Yt:{radius:Math.min(Math.max(y.radius,f),m),strength:y.radius>0?y.strength:0}:null}a(p,"offer");function h(y){let f=i.radii[r-1];return f===void 0?Yt:{radius:f,strength:c.strength===1||f>=y?1:0}}a(h,"atOnce");function g(){let y=u.filter(f=>_(f.ring));u=u.filter(f=>!_(f.ring));for(let{done:f}of y)f()}a(g,"release");function _(y){return r>=y-1||n<1}return a(_,"isFree"),{arrive(y){n=y,!(l&&e&&r>=0)&&(r=y,g())},offer:p,enter(y){c=p(y)??Yt,l=!0},leave(){l=o=!1,r=n,g()},advance(y,f=0){if(!d())return null;if(c=e?Nu(c,r,o?0:y,i,f):h(f),!o&&n>r)return o=!0,s=0,{ring:r,grown:c,fading:{ring:r+1,share:0}};if(!o)return{ring:r,grown:c,fading:null};s+=y;let m=i.fade>0?Math.min(s/i.fade,1):1;return m<1?{ring:r,grown:c,fading:{ring:r+1,share:m}}:(r+=1,o=!1,g(),{ring:r,grown:c,fading:null})},replaceable(y){return new Promise(f=>{_(y)?f():u.push({ring:y,done:f})})}}}a(tf,"createStage");function nf({loading:i,manner:e,failed:t}){let{manifest:n,renderer:r,store:s}=i,o=n.morph.near_share,l=new Map,c=[],u=[],d=[];function p(){let f=c.find(S=>l.get(S)?.state==="loading"),m=u.filter(({region:S})=>S===f);u=u.filter(({region:S})=>S!==f);for(let{done:S}of m)S()}a(p,"call");function h(f,m){return new Promise((S,A)=>{m.addEventListener("abort",()=>A(m.reason),{once:!0}),u.push({region:f,done:S}),p()})}a(h,"turn");function g(f){let m=n.regions[f];if(!m)throw new Error(`there is no region ${f}`);let S=m.rings.slice(1).map(w=>w.radius),A=tf({...n.growth,radii:S,nearShare:o},e),v=$d(r,m,n.map.face_size,s),M=new AbortController,T={number:f,region:v,stage:A,stop:M,arrived:-1,shown:null,received:0,expected:Zc(n,za(n,m,i.last)),state:"loading"};l.set(f,T);let x=a(w=>{T.state=w,p()},"ended");jd(i,{region:v,number:f,arrived(w){T.arrived=w,A.arrive(w)},received:a(w=>{T.received+=w},"received"),turn:a(w=>h(f,w),"turn"),mayReplace:a(w=>A.replaceable(w),"mayReplace"),signal:M.signal}).then(()=>x("complete"),w=>{M.signal.aborted||(x("failed"),t(f,w instanceof Error?w:new Error(String(w))))})}a(g,"begin");function _(f){l.delete(f.number),f.stop.abort(),f.region.dispose(),u=u.filter(({region:A})=>A!==f.number);let m=[...l.values()].flatMap(({region:A})=>[...za(n,A.entry,i.last)]),S={kind:"forget",buffers:s.keep(new Set(m)),region:f.number};Promise.all([i.geometry(S),i.maps(S)]).then(A=>{d=A},()=>{})}a(_,"end");function y(f){let m=l.get(f);if(!m)throw new Error(`region ${f} is not open`);return m}return a(y,"found"),{find:a(f=>l.get(f)??null,"find"),open(f){l.has(f)||g(f)},close(f){let m=l.get(f);m&&_(m)},prefer(f){c=f,p()},offer:a((f,m)=>l.get(f)?.stage.offer(m)??null,"offer"),isComplete:a(f=>l.get(f)?.state==="complete","isComplete"),enter(f,m){let S=y(f);S.stage.enter(m),S.shown=null},leave(f){let m=l.get(f);m?.stage.leave(),m&&(m.shown=null)},grown:a(f=>l.get(f)?.shown?.grown??null,"grown"),advance(f,m,S){let A=y(f);return A.shown=A.stage.advance(m,S),A.shown},retry(){for(let f of[...l.values()].filter(({state:m})=>m==="failed")){let{grown:m}=f.shown??{};_(f),g(f.number),m&&y(f.number).stage.enter(m)}},get holding(){let f=[...l.values()].some(({state:m})=>m==="loading");return{regions:[...l.keys()],isLoading:f,kept:d}},dispose(){for(let f of[...l.values()])_(f)}}}a(nf,"createAtlas");function _c(i){let e=new Worker(i,{type:"module"}),t=new Map,n=0;return e.onmessage=({data:s})=>{let o=t.get(s.id);t.delete(s.id),"error"in s?o?.failed(new Ye(s.error)):o?.done(s.result)},e.onerror=s=>{let o=new Ye(`the decoder stopped: ${s.message||"the browser gives no reason"}`,"other");for(let{failed:l}of t.values())l(o);t.clear()},{decode:a(s=>new Promise((o,l)=>{let c=++n;t.set(c,{done:o,failed:l}),e.postMessage({...s,id:c},Hy(s))}),"decode"),dispose:a(()=>e.terminate(),"dispose")}}a(_c,"startDecoder");function Hy(i){switch(i.kind){case"geometry":return[i.glb,...i.parts].map(e=>e.data);case"first-map":return i.color.map(e=>e.data);case"next-map":return[...i.color?[i.color]:[],...i.range].map(e=>e.data);case"forget":return[]}}a(Hy,"buffersOf");function rf(i,e,t){let n=!1,r=new AbortController,{signal:s}=r,o=a(c=>{c.preventDefault(),n=!0,e()},"went"),l=a(()=>{n=!1,t()},"came");return i.addEventListener("webglcontextlost",o,{signal:s}),i.addEventListener("webglcontextrestored",l,{signal:s}),{get isLost(){return n},dispose:a(()=>r.abort(),"dispose")}}a(rf,"watchLoss");var Wy=`
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,Xy=`
precision mediump float;
uniform float darkness;
out vec4 shade;

void main() {
  shade = vec4(0.0, 0.0, 0.0, darkness);
}
`;function sf(){let i={value:0},e=new yn({vertexShader:Wy,fragmentShader:Xy,glslVersion:Jn,uniforms:{darkness:i},blending:cr,blendSrc:ur,blendDst:di,depthTest:!1,depthWrite:!1,transparent:!0}),t=new ut(ps(),e);return t.frustumCulled=!1,t.visible=!1,{mesh:t,set(n){i.value=n,t.visible=n>0}}}a(sf,"createVeil");function ps(){let i=new Ut;return i.setAttribute("position",new Tt(new Float32Array([-1,-1,0,3,-1,0,-1,3,0]),3)),i}a(ps,"covering");var qy=`
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,Yy=`
precision highp float;
precision highp sampler2D;
uniform sampler2D depth;
out vec4 digits;

void main() {
  float value = texelFetch(depth, ivec2(0), 0).r;
  vec3 scaled = fract(value * vec3(1.0, 255.0, 65025.0));
  digits = vec4(scaled - vec3(scaled.yz / 255.0, 0.0), value < 1.0 ? 1.0 : 0.0);
}
`;function of(i,e,[t,n],r){let s=new Dt(1,1,{depthTexture:new xn(1,1,Qt)}),o=new Dt(1,1),l=new yn({vertexShader:qy,fragmentShader:Yy,glslVersion:Jn,blending:qn,depthTest:!1,uniforms:{depth:{value:s.depthTexture}}}),c=new ut(ps(),l);c.frustumCulled=!1;let u=new _n;u.add(c);let d=i.getRenderTarget(),[p,h]=[i.domElement.width,i.domElement.height];e.setViewOffset(p,h,Math.floor(t*p),Math.floor(n*h),1,1);try{i.setRenderTarget(s),r(),i.setRenderTarget(o),i.render(u,e);let g=new Uint8Array(4);if(i.readRenderTargetPixels(o,0,0,1,1,g),g[3]===0)return null;let _=((g[2]??0)/65025+(g[1]??0)/255+(g[0]??0))/255;return new H(0,0,2*_-1).unproject(e)}finally{e.clearViewOffset(),i.setRenderTarget(d),c.geometry.dispose(),l.dispose(),s.depthTexture?.dispose(),s.dispose(),o.dispose()}}a(of,"pick");function af(i,e,t,n,r,s){let o=new _n,l=new _n;return l.add($y(e)),{prepare(c){i.compile(l,c)},draw(c,u,d,p=!0){let{region:h,ring:g,radius:_,strength:y}=c;s(h.entry.center);let f=h.entry.rings[g]?.map?Ta(h,g):r(),m=t*_,S=_>0?1/(_-m):1;e.radii.value.set(m,_,S,y??-1),e.map.value=f.color,e.codes.value=f.codes;let{least:A,step:v}=h.entry.range;e.coding.value.set(A,v,n,f.hasRange?1:0),e.opacity.value=d,o.children=h.groups.slice(0,g+1),i.clearDepth(),d<1&&(xc(h,g,!1,!0),i.render(o,u),xc(h,g,!0,!1)),i.render(o,u),d<1&&xc(h,g,!0,!0),p&&i.render(l,u),o.children=[]}}}a(af,"createPainter");function xc(i,e,t,n){for(let r of i.groups.slice(0,e+1).flatMap(Aa))r.material.colorWrite=t,r.material.depthWrite=n}a(xc,"setWrites");function $y(i){let e=new ut(ps(),Hd(i));return e.frustumCulled=!1,e}a($y,"screen");function lf(){let i=new Map,e=new Set,t=new Map;return{textures:i,buffers:e,moving:new Map,take(n,r){if(n===null)return r();let s=t.get(n)??{arrays:r(),users:0};return t.set(n,s),s.users+=1,s.arrays},give(n){let r=n===null?void 0:t.get(n);return!r||n===null?!0:(r.users-=1,r.users>0?!1:(t.delete(n),!0))},keep(n){for(let[s,o]of i)n.has(s)||(o.dispose(),i.delete(s));let r=[...e].filter(s=>!n.has(s));for(let s of r)e.delete(s);return r},get shared(){return[...t.values()].filter(({users:n})=>n>1).length}}}a(lf,"createStore");function cf(i=()=>performance.now()){let e=[];function t(){let n=e[0];if(!n)return!1;try{n.signal.throwIfAborted();let r=n.steps.next();if(!r.done)return r.value(),!0;n.done()}catch(r){n.steps.return?.(),n.failed(r)}return e.shift(),!0}return a(t,"step"),{add(n,r){return new Promise((s,o)=>{e.push({steps:n[Symbol.iterator](),signal:r,done:s,failed:o})})},run(n){let r=i();for(;t()&&i()-r<n;);return i()-r}}}a(cf,"createUploads");function uf(i,e){i.clear();let t=i.getRenderTarget(),n=t?.samples??0;t&&(t.samples=0),e(),t&&(t.samples=n)}a(uf,"resolveOnce");var Jy=3,Zy=.05,Ky=3e4;function hf(i,e){let{manifest:t}=e,n=t.map.face_size,r=t.morph.near_share,s=jy(i,e.antialias),o=new Gt(e.angle,1,Zy,Ky);o.rotation.order="YXZ";let l=new Zt;l.add(o);let c=sf(),u=new _n;u.add(l,c.mesh);let d=mr(s,1),p=zd(d.color,d.codes),h=cf(),g=[_c(e.worker),_c(e.worker)],_={x:0,y:0,z:0};function y(F){l.position.set(_.x-F[0],_.y-F[1],_.z-F[2]),l.updateMatrixWorld(!0)}a(y,"place");let f=af(s,p,r,n,()=>d,y);f.prepare(o);let m=new _n,S=lf(),A={manifest:t,renderer:s,shared:p,store:S,uploads:h,geometry:g[0].decode,maps:g[1].decode,fetch:e.fetch,last:e.last,warm(F){let{count:J}=F.geometry.drawRange;F.geometry.setDrawRange(0,0),m.children=[F],s.render(m,o),m.children=[],F.geometry.setDrawRange(0,J)}},v=nf({loading:A,manner:e,failed(F,J){M?.failed(F),e.failed(J)}}),M=null,T=null,x=null,w=0,P=null,C=null,D=null,B=rf(i,()=>{D=M?.region??null,X(),d.dispose(),e.lost(!0)},()=>{s.setClearAlpha(0),d=mr(s,1),[p.map.value,p.codes.value]=[d.color,d.codes],f.prepare(o),D!==null&&L(D),e.lost(!1)});function X(){for(let F of v.holding.regions)v.close(F);M=T=null}a(X,"close");function L(F){X();let J=a(ae=>{x=ae,e.moved(ae)},"moved"),{regions:ie,growth:ve}=t;M=Ou({regions:ie,marginShare:Qy(t),fade:ve.fade,moved:J},v,F)}a(L,"begin");function q({position:[F,J,ie],yaw:ve,pitch:ae}){O({position:[F,J,ie],yaw:0}),o.position.set(0,0,0),o.rotation.set(ae,ve,0)}a(q,"setPose");function O({position:[F,J,ie],yaw:ve}){Object.assign(_,{x:F,y:J,z:ie}),l.rotation.y=ve}a(O,"stand");function z(){if(s.xr.isPresenting)return;let{clientWidth:F,clientHeight:J}=i,ie=Math.min(window.devicePixelRatio,2);i.width===Math.floor(F*ie)&&i.height===Math.floor(J*ie)||(s.setPixelRatio(ie),s.setSize(F,J,!1),o.aspect=F/J,o.updateProjectionMatrix())}a(z,"fit");function te(F,J,ie,ve=!0){let ae=v.find(F);if(!ae?.shown||J===0)return;let{ring:Le,grown:rt,fading:Te}=ae.shown,Ve={region:ae.region,radius:rt.radius,strength:ie?rt.strength:null};f.draw({...Ve,ring:Le},o,J,ve),J===1&&Te&&Te.share>0&&f.draw({...Ve,ring:Te.ring},o,Te.share)}a(te,"paint");function Y({region:F,leaving:J},ie){let ve=J?.pose??x;J&&ve&&(q(ve),te(J.region,1,ie)),x&&q(x),te(F,J?.share??1,ie)}a(Y,"paintLeg");function ee({region:F,leaving:J}){J&&!J.pose&&te(J.region,1,!0),te(F,J?.share??1,!0,J!==null||!ne(F))}a(ee,"paintEyes");function ne(F){let J=v.find(F);return!J?.shown||J.shown.fading?!1:C?.show(Ta(J.region,J.shown.ring),l.rotation.y)??!1}a(ne,"isApart");function Me(){if(!T||!v.find(T.region)?.shown)return;if(s.xr.isPresenting){ee(T);return}if(P===null){Y(T,!0);return}let[F,J]=[i.clientWidth,i.clientHeight],ie=Math.round(P*F);s.setScissorTest(!0),s.setScissor(0,0,ie,J),Y(T,!1),s.setScissor(ie,0,F-ie,J),Y(T,!0),s.setScissorTest(!1)}a(Me,"paintAll");function Ie(F,J){w=h.run(T&&v.find(T.region)?.shown?Jy:Number.POSITIVE_INFINITY),M&&(T=M.advance(J,F),v.advance(T.region,T.leaving?0:J,M.least),Me())}return a(Ie,"advance"),{renderer:s,camera:o,rig:l,faceSize:n,open:L,go:a(F=>M?.go(F),"go"),pointAt(F,J){let ie=T&&v.find(T.region);if(!ie?.shown||!x)return null;let{region:ve,shown:ae}=ie;q(x);let{radius:Le,strength:rt}=ae.grown,Te=of(s,o,[F,J],()=>{f.draw({region:ve,ring:ae.ring,radius:Le,strength:rt},o,1,!1)}),{center:Ve}=ve.entry;return Te&&[Te.x+Ve[0],Te.y+Ve[1],Te.z+Ve[2]]},retry:v.retry,frame(F,J){if(x=F,B.isLost)return;z();let{isPresenting:ie}=s.xr;ie?uf(s,()=>Ie(F,J)):Ie(F,J),(ie||c.mesh.visible)&&s.render(u,o)},stand:O,setMapLayer(F){C=F},setVeil:c.set,still(F,J){let ie=M&&v.find(M.region);if(!ie)throw new Error("no region is open");q(J),f.draw({...F,region:ie.region},o,1)},setDivider(F){P=F},photo(){return s.xr.isPresenting?Promise.reject(new Error("Pictures are saved outside the headset")):(Me(),new Promise((F,J)=>{i.toBlob(ie=>ie?F(ie):J(new Error("The browser gives no picture")),"image/png")}))},get facts(){let F=M?.region??0,J=v.find(F),ie=J?.shown?.fading?.ring??J?.shown?.ring??0;return{region:F,goal:M?.goal??null,leaving:T?.leaving?.region??null,shown:J?.shown??null,arrived:J?.arrived??-1,received:J?.received??0,expected:J?.expected??0,triangles:J?Jd(J.region,ie):0,upload:w,bounds:M?.bounds??null,...v.holding,shared:S.shared}},dispose(){v.dispose();for(let F of g)F.dispose();d.dispose(),B.dispose(),s.dispose(),s.forceContextLoss()}}}a(hf,"createViewer");function jy(i,e){let t;try{t=new Ma({canvas:i,antialias:e,powerPreference:"high-performance"})}catch(n){throw new Ye(n instanceof Error?n.message:String(n),"webgl")}return t.autoClear=!1,t.setClearAlpha(0),t.sortObjects=!1,t.debug.checkShaderErrors=!0,t}a(jy,"createRenderer");function Qy({morph:i,regions:e}){let[t]=e;return!t||!Number.isFinite(t.cut)?i.near_share:Math.max(t.fold_margin/t.cut,Number.EPSILON)}a(Qy,"marginShare");function ye(i,e={},...t){let n=document.createElement(i);return yc(n,e),n.append(...t),n}a(ye,"make");var df="http://www.w3.org/2000/svg";function Zn(i){let e=document.createElementNS(df,"svg");yc(e,{viewBox:"0 0 24 24",class:"icon","aria-hidden":"true",focusable:"false"});let t=document.createElementNS(df,"path");return yc(t,{d:i}),e.append(t),e}a(Zn,"icon");function pi(i,e){i.textContent!==e&&(i.textContent=e)}a(pi,"write");function yc(i,e){for(let[t,n]of Object.entries(e))n!==void 0&&n!==!1&&i.setAttribute(t,n===!0?"":n)}a(yc,"setAll");var bt={walk:"M13 4.5a1.5 1.5 0 1 0 0-.01M9.5 21l2-5.5-2-3 1-4.5 3 .5 2 3 2.5 1M7 12.5l.5-3 3-1.5M12.5 13l2.5 3.5.5 4.5",orbit:"M12 14a2 2 0 1 0 0-4 2 2 0 0 0 0 4M17 8c2.5.8 4 2.2 4 4 0 2.8-4 5-9 5s-9-2.2-9-5 4-5 9-5M9.5 4L13 7l-3.5 3",split:"M12 3v18M4 6h5M4 6v12h5M20 6h-5M20 6v12h-5",photo:"M4 8h3.5L9 5.5h6L16.5 8H20v11H4zM12 16.5a3.25 3.25 0 1 0 0-6.5 3.25 3.25 0 0 0 0 6.5",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",home:"M4 11.5L12 5l8 6.5M6 10v9h4v-5h4v5h4v-9",next:"M12 21c-4-4.6-6-7.9-6-10.5a6 6 0 0 1 12 0C18 13.1 16 16.4 12 21M10 8.5l2.5 2-2.5 2",panel:"M4 5h16v14H4zM7 9h6M7 12h10M7 15h8",help:"M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.5v.01M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18",headset:"M3 8.5h18v8h-5.5L13.5 14h-3l-2 2.5H3zM7.5 12v.01M16.5 12v.01",close:"M6 6l12 12M18 6L6 18",grip:"M9 7l-5 5 5 5M15 7l5 5-5 5"};var[Ra,ff]=[.01,.1],pf=40,Ca=.5;function mf(i,e){let t=a((h,g)=>ye("span",{class:`divider-label divider-${h}`,"aria-hidden":"true"},g),"label"),[n,r]=[t("left","Conventional"),t("right","Continuous")],s=ye("div",{class:"divider",role:"slider",tabindex:"0","aria-label":"Divider between the conventional picture, left, and the continuous one, right","aria-orientation":"horizontal","aria-valuemin":"0","aria-valuemax":"100"},n,ye("span",{class:"divider-grip"},Zn(bt.grip)),r),o=ye("div",{class:"divider-layer",hidden:!0},s);i.prepend(o);let l=new ResizeObserver(d);l.observe(o);let c=null;function u(h){let g=h===null||Number.isNaN(h)?null:Math.min(Math.max(h,0),1);if(g!==c){if(c=g,o.hidden=c===null,c!==null){let _=String(Math.round(100*c));o.style.setProperty("--share",String(c)),s.setAttribute("aria-valuenow",_),s.setAttribute("aria-valuetext",`${_} percent conventional`),d()}e(c)}}a(u,"set");function d(){let[h,g]=[o.clientWidth,c??Ca];n.classList.toggle("is-cut",n.offsetWidth+pf>g*h),r.classList.toggle("is-cut",r.offsetWidth+pf>(1-g)*h)}a(d,"arrange");function p(h){if(!s.hasPointerCapture(h.pointerId))return;let{left:g,width:_}=o.getBoundingClientRect();u((h.clientX-g)/Math.max(_,1))}return a(p,"drag"),s.addEventListener("pointerdown",h=>{h.button===0&&(s.setPointerCapture(h.pointerId),s.focus({preventScroll:!0}),h.preventDefault())}),s.addEventListener("pointermove",p),s.addEventListener("keydown",h=>{let g=ev(h.key,c??Ca);g===void 0||h.ctrlKey||h.metaKey||h.altKey||(u(g),h.preventDefault(),h.stopPropagation())}),{get share(){return c},set:u,dispose(){l.disconnect(),o.remove()}}}a(mf,"createDivider");function ev(i,e){let n=new Map([["ArrowLeft",e-Ra],["ArrowDown",e-Ra],["ArrowRight",e+Ra],["ArrowUp",e+Ra],["PageDown",e-ff],["PageUp",e+ff],["Home",0],["End",1],["Escape",null]]).get(i);return typeof n=="number"?Math.min(Math.max(n,0),1):n}a(ev,"nextShare");var vc=3,gf={webgl:{title:"This browser cannot draw the scene",text:"The page needs WebGL 2. Switch on hardware acceleration in the settings of the browser, or open the page in a current Chrome, Edge, Firefox or Safari."},damaged:{title:"The scene is damaged",text:"A file is not what the manifest says. Export the scene again, or tell whoever sent you here."},newer:{title:"The scene needs a newer nearfar",text:"It was written in a later format than this page reads. Update nearfar and reload the page."},network:{title:"The scene cannot be reached",text:"The server does not answer, or does not have it. Check the connection and the address, and try again."},other:{title:"The scene cannot be shown",text:"Reload the page. If that does not help, tell whoever sent you here what stands below."}};function _f(i,e,{detail:t,retry:n}={}){let r=ye("h1",{tabindex:"-1",id:"message-title"},i),s=ye("div",{class:"fatal-card"},ye("p",{class:"fatal-brand"},"nearfar"),r);s.append(ye("p",{},e)),t&&s.append(ye("p",{class:"fatal-detail"},t)),n&&s.append(yf("Try again","button-main",n));let o=Sc();o.replaceChildren(s),o.dataset.kind="fatal";for(let l of document.querySelectorAll("canvas, [data-behind]"))l.setAttribute("inert","");r.focus({preventScroll:!0})}a(_f,"showFatal");function xf(i,e){let t=Sc();if(t.dataset.kind==="fatal")return;let n=ye("ul",{},...i.slice(0,vc).map(o=>ye("li",{},o)));i.length>vc&&n.append(ye("li",{},`and ${i.length-vc} more`));let r=ye("button",{type:"button",class:"button-icon","aria-label":"Dismiss",title:"Dismiss"});r.append(Zn(bt.close)),r.addEventListener("click",Pa);let s=ye("div",{class:"banner-text"},ye("strong",{},"Not all of the scene is shown"),n);i.length===0?Pa():(t.replaceChildren(s,yf("Try again","button-main",e),r),t.dataset.kind="banner")}a(xf,"showProblems");function Pa(){let i=Sc();i.replaceChildren(),delete i.dataset.kind;for(let e of document.querySelectorAll("canvas, [data-behind]"))e.removeAttribute("inert")}a(Pa,"clearMessage");function yf(i,e,t){let n=ye("button",{type:"button",class:e},i);return n.addEventListener("click",t),n}a(yf,"button");function Sc(){let i=document.getElementById("message");if(i)return i;let e=ye("div",{id:"message",role:"alert"});return document.body.append(e),e}a(Sc,"message");var bc=["","k","M","G","T"];function vf(i,e){if(!mi(i)||!mi(e))return"\u2013";let t=Mf(Math.max(i,e));return`${Mc(i,t)} of ${Mc(e,t)}\xA0${bc[t]}B`}a(vf,"bytesOf");function Sf(i){return i===null?"idle":tv(i,"b/s")}a(Sf,"rate");function wc(i){return mi(i)?i>=9995e5?`${(i/1e9).toFixed(2)}\xA0billion`:i>=999999.5?`${(i/1e6).toFixed(2)}\xA0million`:Math.round(i).toLocaleString("en"):"\u2013"}a(wc,"count");function Ec(i,e){if(!mi(i)||!mi(e))return"\u2013";let t=e>0?100*i/e:100;return t>0&&t<1?"<\xA01\xA0%":`${Math.min(Math.floor(t),100)}\xA0%`}a(Ec,"percent");function Tc(i){return mi(i)?`${i.toFixed(i<99.95?1:0)}\xA0ms`:"\u2013"}a(Tc,"milliseconds");function Ia(i){return mi(i)?i>=999.5?`${(i/1e3).toFixed(1)}\xA0km`:`${i.toFixed(i<.995?2:i<99.95?1:0)}\xA0m`:"\u2013"}a(Ia,"metres");function tv(i,e){if(!mi(i))return"\u2013";let t=Mf(i);return`${Mc(i,t)}\xA0${bc[t]}${e}`}a(tv,"scaled");function Mf(i){let e=0;for(;e<bc.length-1&&i/1e3**e>=999.5;)e+=1;return e}a(Mf,"powerOf");function Mc(i,e){let t=i/1e3**e;return t.toFixed(e>1&&t<99.95?1:0)}a(Mc,"digits");function mi(i){return Number.isFinite(i)&&i>=0}a(mi,"isAmount");function nv(i){let{ring:e,rings:t,radius:n,received:r,expected:s,frame:o,longest:l,triangles:c,sceneTriangles:u}=i;return{Loaded:`${vf(r,s)} (${Ec(r,s)})`,Speed:Ac(i)?"all is here":Sf(i.rate),Ring:e===0?`map only, of ${t}`:`${e} of ${t}`,Radius:e===0?iv:Ia(n),Triangles:`${wc(c)} of ${wc(u)}`,Frame:`${Tc(o)}, at most ${Tc(l)}`,Region:`${i.region+1} of ${i.regions}`,"From centre":`${Ia(i.away)} of ${Ia(i.foldMargin)}`}}a(nv,"linesOf");var iv="\u2013";function Ac({ring:i,rings:e,received:t,expected:n}){return i>=e&&t>=n}a(Ac,"isComplete");function bf(i){return`${Ec(i.received,i.expected)} loaded, ring ${i.ring} of ${i.rings}`}a(bf,"shortly");function wf(){let i=new Map,e=ye("dl",{class:"figures"}),t=ye("div",{class:"reach","aria-hidden":"true"},ye("span",{})),n=ye("ul",{class:"problems"});function r(s){let o=i.get(s);if(o)return o;let l=ye("dd",{});return e.append(ye("div",{},ye("dt",{},s),l)),i.set(s,l),l}return a(r,"line"),{element:ye("div",{class:"panel-body"},e,t,n),update(s){for(let[c,u]of Object.entries(nv(s)))pi(r(c),u);let o=s.foldMargin>0?Math.min(s.away/s.foldMargin,1):0;t.style.setProperty("--share",o.toFixed(3)),t.dataset.near=String(o>.8);let l=s.problems;l.join(`
`)!==[...n.children].map(({textContent:c})=>c).join(`
`)&&n.replaceChildren(...l.map(c=>ye("li",{},c)))}}}a(wf,"createFigures");var Ui={walk:{key:"1",label:"1",does:"walk"},orbit:{key:"2",label:"2",does:"orbit around what lies ahead"},split:{key:"c",label:"C",does:"compare with the conventional picture"},photo:{key:"p",label:"P",does:"save the picture"},link:{key:"l",label:"L",does:"copy a link to this view"},home:{key:"home",label:"Home",does:"go back to the centre"},next:{key:"n",label:"N",does:"go to the next place"},look:{key:"f",label:"F",does:"look around with the mouse without a button, until Esc"},panel:{key:"i",label:"I",does:"show or hide the figures"},retry:{key:"r",label:"R",does:"load again what failed"},headset:{key:"v",label:"V",does:"enter the headset, and leave it"},help:{key:"?",label:"?",does:"show or hide this help"}};function Ef(i,e,t){let n=new Map(Object.entries(Ui).map(([r,{key:s}])=>[s,r]));i.addEventListener("keydown",r=>{let s=r;if(Ha(s)||s.repeat||Va(s.code))return;let o=n.get(s.key.toLowerCase());o&&(s.preventDefault(),e(o))},{signal:t})}a(Ef,"listen");var rv=[[["W","A","S","D"],"walk"],[["\u2191","\u2193"],"walk ahead and back"],[["\u2190","\u2192"],"turn"],[["Page \u2191","Page \u2193"],"look up and down"],[["Shift"],"run"],[["Drag"],"look around"],[["Double click"],"go to a place"]],sv=[[["Drag"],"go around"],[["Shift","Drag"],"move; so does the right button"],[["Wheel"],"nearer and farther"],[["W","S"],"nearer and farther"],[["A","D","\u2190","\u2192"],"go around"],[["Shift","WASD"],"move"]],ov=[[["Left thumb"],"walk"],[["Right thumb"],"look around"],[["Two taps"],"go to a place"],[["One finger"],"orbit: go around"],[["Two fingers"],"orbit: pinch for the distance, drag to move"]],av=[[["Left stick"],"walk; press it to run"],[["Right stick"],"look around"]];function Tf(i,e){let t=ye("button",{type:"button",class:"button-icon","aria-label":"Close",title:"Close (Esc)"});t.append(Zn(bt.close));let n=ye("section",{}),r=ye("dialog",{class:"help","aria-labelledby":"help-title",tabindex:"-1"},ye("header",{},ye("h1",{id:"help-title"},"How to move"),t),ye("div",{class:"help-parts"},ms("Walk",rv),ms("Orbit",sv),n,ye("div",{class:"help-touch"},ms("Touch",ov),ms("Gamepad",av))));return t.addEventListener("click",()=>r.close()),r.addEventListener("click",s=>{s.target===r&&r.close()}),r.addEventListener("keydown",s=>{s.key==="?"&&(r.close(),s.preventDefault())}),i.append(r),{toggle(){if(r.open){r.close();return}let s=e(),l=Object.keys(Ui).filter(c=>!s.includes(c)).map(c=>[[Ui[c].label],Ui[c].does]);n.replaceChildren(...ms("Commands",l).childNodes),r.showModal(),r.scrollTop=0},dispose:a(()=>r.remove(),"dispose")}}a(Tf,"createHelp");function ms(i,e){let t=ye("dl",{});for(let[n,r]of e)t.append(ye("dt",{},...n.map(s=>ye("kbd",{},s))),ye("dd",{},r));return ye("section",{},ye("h2",{},i),t)}a(ms,"part");function Af(i,e){let t=URL.createObjectURL(i);ye("a",{href:t,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}a(Af,"saveFile");async function Rf(i){try{return await navigator.clipboard.writeText(i),!0}catch{return lv(i)}}a(Rf,"copyText");function lv(i){let e=ye("textarea",{class:"unseen","aria-hidden":"true",tabindex:"-1"});e.value=i;let t=document.activeElement;document.body.append(e),e.select();let n=document.execCommand("copy");return e.remove(),t instanceof HTMLElement&&t.focus({preventScroll:!0}),n}a(lv,"copyMarked");var cv=3,uv="(min-width: 48rem) and (min-height: 34rem)";function Cf(i,e,t={}){let n=new AbortController,{keys:r=window,isOpen:s=window.matchMedia(uv).matches}=t,o=!1,l=-1,c=!1,u="",d=0,p={walk:Un("walk","Walk",bt.walk),orbit:Un("orbit","Orbit",bt.orbit),split:Un("split","Split",bt.split),home:Un("home","Home",bt.home),next:Un("next","Next",bt.next),photo:Un("photo","Photo",bt.photo),link:Un("link","Link",bt.link),panel:Un("panel","Info",bt.panel),help:Un("help","Help",bt.help),headset:Un("headset","Enter VR",bt.headset)},{headset:h,...g}=p;h.classList.add("tool-main"),h.hidden=!0,p.next.hidden=!e.next;let _=ye("div",{class:"tools",role:"group","aria-label":"Commands"},...Object.values(g));_.classList.toggle("tools-many",e.next!==void 0);let y=wf(),f=ye("p",{class:"quiet",hidden:!0}),m=ye("section",{class:"panel card",id:"panel","aria-label":"Figures"},ye("header",{},ye("h1",{},"nearfar"),D()),y.element,f),S=ye("button",{type:"button",class:"chip card",title:"Show the figures (I)",hidden:!0});S.addEventListener("click",()=>w("panel"));let A=ye("div",{class:"load",role:"progressbar","aria-label":"Loading","aria-valuemin":"0","aria-valuemax":"100"},ye("span",{})),v=ye("p",{class:"note card",hidden:!0}),M=ye("p",{class:"unseen",role:"status"}),T=ye("div",{class:"frame","data-behind":!0},ye("div",{class:"top"},m,S),ye("div",{class:"bottom"},v,h,_));i.append(A,T,M);let x=Tf(i,()=>[...Rc(e)?[]:["headset"],...u?[]:["retry"],...e.next?[]:["next"]]);m.hidden=!s;for(let[O,z]of Object.entries(p))z.addEventListener("click",()=>w(O));Ef(r,w,n.signal),C({mode:"walk"});function w(O){P(O).catch(z=>B(z instanceof Error?z.message:String(z)))}a(w,"run");async function P(O){if(O==="walk"||O==="orbit")e.setMode(O),C({mode:O}),X(O==="walk"?"Walking":"Orbiting");else if(O==="split"){let z=!o;C({isDivided:z}),e.setDivider(z?Ca:null),X(z?"Left conventional, right continuous":"Continuous")}else if(O==="photo")Af(await e.screenshot(),`nearfar ${new Date().toISOString().slice(0,19).replace(/\D/g,"-")}.png`),B("Picture saved");else if(O==="link"){let z=e.link();B(await Rf(z)?"Link copied":z)}else O==="home"?e.home():O==="next"?e.next?.():O==="look"?e.lookAround():O==="panel"?(m.hidden=!m.hidden,C({})):O==="help"?x.toggle():O==="retry"&&u?(e.retry(),B("Trying again")):O==="headset"&&await Rc(e)?.toggle()}a(P,"perform");function C({mode:O,isDivided:z}){O&&(La(p.walk,O==="walk"),La(p.orbit,O==="orbit")),o=z??o,La(p.split,o),La(p.panel,!m.hidden),S.hidden=!m.hidden||c||l<0}a(C,"reflect");function D(){let O=ye("button",{type:"button",class:"button-icon","aria-label":"Hide the figures",title:"Hide the figures (I)"},Zn(bt.close));return O.addEventListener("click",()=>{w("panel"),p.panel.focus({preventScroll:!0})}),O}a(D,"dismiss");function B(O){pi(v,O),X(O),v.hidden=!1,window.clearTimeout(d),d=window.setTimeout(()=>{v.hidden=!0,X("")},1e3*cv)}a(B,"announce");function X(O){pi(M,O)}a(X,"speak");function L(O){let z=Ac(O);z&&!c?X("All rings are shown"):O.ring!==l&&X(`Ring ${O.ring} of ${O.rings} is shown`),[l,c]=[O.ring,z];let te=O.problems.join(`
`);te!==u&&xf(O.problems,()=>w("retry")),u=te}a(L,"tell");function q(){let O=Rc(e);h.hidden=!O,hv(h,O?.isPresenting?"Leave VR":"Enter VR"),pi(f,typeof e.headset=="string"?e.headset:""),f.hidden=typeof e.headset!="string"}return a(q,"tellHeadset"),{update(O){L(O),y.update(O);let z=O.expected>0?Math.min(O.received/O.expected,1):1;A.hidden=c,A.dataset.stuck=String(u!==""),A.style.setProperty("--share",z.toFixed(4)),A.setAttribute("aria-valuenow",String(Math.floor(100*z))),pi(S,bf(O)),q(),C({})},announce:B,reflect:C,dispose(){n.abort(),window.clearTimeout(d),x.dispose();for(let O of[A,T,M])O.remove()}}}a(Cf,"createPanel");function Un(i,e,t){let{label:n,does:r}=Ui[i],s=`${r.charAt(0).toUpperCase()}${r.slice(1)} (${n})`,o=ye("span",{class:"tool-label"},e);return ye("button",{type:"button",class:"tool",title:s,"aria-keyshortcuts":n},Zn(t),o)}a(Un,"tool");function hv(i,e){let t=i.querySelector(".tool-label");t&&pi(t,e)}a(hv,"label");function Rc({headset:i}){return typeof i=="object"?i:null}a(Rc,"headsetOf");function La(i,e){i.setAttribute("aria-pressed",String(e))}a(La,"press");function Pf(i){let e=ye("div",{class:"thumb",hidden:!0,"aria-hidden":"true"},ye("span",{}));return i.append(e),{show(t){if(e.hidden=t===null,!t)return;let{x:n,y:r,right:s,down:o}=t,l=Math.min(1,Ts/Math.max(Math.hypot(s,o),1)),c={"--x":n,"--y":r,"--right":s*l,"--down":o*l};for(let[u,d]of Object.entries(c))e.style.setProperty(u,`${d}px`)},dispose:a(()=>e.remove(),"dispose")}}a(Pf,"createThumbMark");var[Na,Cc]=[7.5,9.81],Da=24,gi=.12;function Pc({origin:[i,e,t],direction:[n,r,s]}){let o=Lf(e,r);return[i+Na*n*o,0,t+Na*s*o]}a(Pc,"landing");function If(i,e){let{origin:t,direction:n}=i,r=Lf(t[1],n[1]),s=Pc(i);return Array.from({length:Da},(o,l)=>{let c=l/(Da-1),u=c*r,d=a(p=>t[p]+Na*n[p]*u+c*c*(e[p]-s[p]),"at");return[d(0),d(1)-Cc/2*u*u,d(2)]})}a(If,"arc");function Lf(i,e){let t=Na*e;return(t+Math.sqrt(t*t+2*Cc*Math.max(i,0)))/Cc}a(Lf,"fall");function Nf(){let i=2*gi,e=null;function t(){let n=e;e=null,n?.()}return a(t,"act"),{start(n){e=n,i=Math.min(i,Math.max(2*gi-i,0))},advance(n){let r=i;return i=Math.min(i+n,2*gi),e&&i>=gi&&(r<gi&&(i=gi),t()),1-Math.abs(i-gi)/gi}}}a(Nf,"createJump");var dv=.01;function Df(i,e){let t=new AbortController,n=null,r=null;i.addEventListener("selectstart",({inputSource:o})=>n=o,{signal:t.signal}),i.addEventListener("selectend",({inputSource:o})=>{if(o!==n)return;let l=r?.target;s(),l&&e(l)},{signal:t.signal});function s(){n=null,r=null}return a(s,"drop"),{update(o,l){if(!n)return null;let c=o.find(({source:h})=>h===n)?.ray;if(!c)return r=null,null;let u=Pc(c),d=l(u),p=Math.hypot(d[0]-u[0],d[2]-u[2])>dv;return r={arc:If(c,d),target:d,isHeld:p},r},dispose:a(()=>t.abort(),"dispose")}}a(Df,"createAiming");var Ic=1.7,fv=.04;function _i({position:i,yaw:e},[t,n,r]){let[s,o]=[Math.cos(e),Math.sin(e)];return[i[0]+s*t+o*r,i[1]+n,i[2]-o*t+s*r]}a(_i,"worldOf");function Uf({position:i,yaw:e},[t,n,r]){return _i({position:[0,0,0],yaw:-e},[t-i[0],n-i[1],r-i[2]])}a(Uf,"localOf");function Ua(i,e){return{position:_i(i,e.position),yaw:Fi(i.yaw+e.yaw),pitch:e.pitch}}a(Ua,"inWorld");function Lc(i,e,t){let n={position:[0,0,0],yaw:Fi(e-t.yaw)},[r,,s]=_i(n,t.position);return{position:[i[0]-r,i[1],i[2]-s],yaw:n.yaw}}a(Lc,"floorUnder");function Ff(i,e,t){let{position:n,yaw:r}=Ua(i,e);return Lc([n[0],i.position[1],n[2]],r+t,e)}a(Ff,"turned");function Nc(i,e,[t,,n]){let[r,,s]=_i(i,e.position),[o,l,c]=i.position;return{...i,position:[o+t-r,l,c+n-s]}}a(Nc,"moved");function Dc(i,e){let t=e?.shown??[];return[...t,...t].reduce((n,r)=>Ms(n,r),i)}a(Dc,"inside");function Of(i){let e=a(t=>t.map(n=>({...n,metres:Math.max(n.metres-fv,0)})),"inner");return i&&{open:e(i.open),shown:e(i.shown)}}a(Of,"headBounds");function Bf(i){let e=a(c=>i[c]??0,"at"),[t,n,r]=[-e(8),-e(9),-e(10)],s=Math.hypot(t,r)<pv,[o,l]=s?[-Math.sign(n)*e(4),-Math.sign(n)*e(6)]:[t,r];return{position:[e(12),e(13),e(14)],yaw:Math.atan2(-o,-l),pitch:Math.atan2(n,Math.hypot(t,r))}}a(Bf,"headOf");var pv=.05;var[mv,kf,gv]=[2,3,3],_v=16;function zf(i,e){let{session:t}=i;return t.visibilityState!=="visible"?[]:[...t.inputSources].filter(({targetRayMode:n})=>n==="tracked-pointer"||n==="transient-pointer").map(n=>{let{targetRaySpace:r,gripSpace:s,hand:o,gamepad:l}=n,c=i.getPose(r,e),u=s&&!o?i.getPose(s,e):void 0;return{source:n,ray:c?xv(c.transform.matrix):null,grip:u?u.transform.matrix:null,stick:l?yv(l):null,joints:o?vv(o,i,e):null}})}a(zf,"readInputs");function xv(i){let e=a(o=>i[o]??0,"at"),[t,n,r]=[-e(8),-e(9),-e(10)],s=Math.hypot(t,n,r)||1;return{origin:[e(12),e(13),e(14)],direction:[t/s,n/s,r/s]}}a(xv,"rayOf");function yv({axes:i,buttons:e,mapping:t}){return t!=="xr-standard"||i.length<=kf?null:{x:i[mv]??0,y:i[kf]??0,isPressed:e[gv]?.pressed??!1}}a(yv,"stickOf");function vv(i,e,t){let n=[...i.values()],[r,s]=[new Float32Array(_v*n.length),new Float32Array(n.length)];return e.fillPoses?.(n,t,r)&&e.fillJointRadii?.(n,s)?{matrices:r,radii:s}:null}a(vv,"jointsOf");function Gf(i,e){let{xr:t}=i,[n,r]=[t.getSession(),t.getReferenceSpace()];if(!n?.enabledFeatures?.includes("layers")||!r)return null;let s=t.getBinding();if(typeof s.createCubeLayer!="function")return null;let o=i.getContext(),l=s.createCubeLayer({space:r,layout:"mono",viewPixelWidth:e,viewPixelHeight:e,colorFormat:o.SRGB8_ALPHA8}),c=t.getBaseLayer();n.updateRenderState({layers:[l,c]});let u=Sv(o,e),d=null,p=null;function h(_){return d?.cube===_&&d.ring===_.holds&&!l.needsRedraw?!1:(u(Dd(i,_),s.getSubImage(l,t.getFrame()).colorTexture),d={cube:_,ring:_.holds},!0)}a(h,"hold");function g(_){return p===_?!1:(p=_,l.orientation=new DOMPointReadOnly(0,Math.sin(-_/2),0,Math.cos(_/2)),!0)}return a(g,"orient"),{show(_,y){return![h(_),g(y),!n.renderState.layers?.includes(l)].includes(!0)}}}a(Gf,"createMapLayer");function Sv(i,e){let[t,n]=[i.createFramebuffer(),i.createFramebuffer()],r=a((s,o,l)=>i.framebufferTexture2D(s,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+o,l,0),"attach");return(s,o)=>{let l=[i.READ_FRAMEBUFFER_BINDING,i.DRAW_FRAMEBUFFER_BINDING].map(c=>i.getParameter(c));i.bindFramebuffer(i.READ_FRAMEBUFFER,t),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,n);for(let c=0;c<lc;c++)r(i.READ_FRAMEBUFFER,c,s),r(i.DRAW_FRAMEBUFFER,c,o),i.blitFramebuffer(0,0,e,e,0,0,e,e,i.COLOR_BUFFER_BIT,i.NEAREST);i.bindFramebuffer(i.READ_FRAMEBUFFER,l[0]),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,l[1])}}a(Sv,"createCopy");var[Uc,Vf]=[2,25],[Mv,bv,Fc]=[.018,.05,.012],wv=[.22,.3],[Hf,Ev]=[5030655,16758860];function qf(){let i=new Zt,e=new Jr({color:14015459}),t=new rr({color:Hf,depthTest:!1}),n=Wf(Uc*Vf,e),r=Wf(Da,t),s=new ut(new $r(...wv,48).rotateX(-Math.PI/2),t),o=Array.from({length:Uc},()=>{let y=new ut(new Xr(Mv,2*bv,4,12).rotateX(Math.PI/2),e);return y.matrixAutoUpdate=!1,y}),l=new Kr(16777215,6711920,2.5),c=[...o,n,r,s];for(let y of c)y.frustumCulled=!1;i.add(l,...c);let u={free:new ke(Hf),held:new ke(Ev)},[d,p]=[new Qe,new H];function h(y){let f=y.map(({grip:m})=>m).filter(m=>m!==null);o.forEach((m,S)=>{let A=f[S];m.visible=A!==void 0,A&&m.matrix.fromArray(A)})}a(h,"showControllers");function g(y){let f=0;for(let{joints:m}of y)if(m)for(let S=0;S<m.radii.length&&f<Uc*Vf;S++){d.fromArray(m.matrices,16*S);let A=m.radii[S]??0;n.setMatrixAt(f++,d.scale(p.setScalar(A)))}Xf(n,f)}a(g,"showJoints");function _(y){y?.arc.forEach(([f,m,S],A)=>{r.setMatrixAt(A,d.makeScale(Fc,Fc,Fc).setPosition(f,m,S))}),Xf(r,y?.arc.length??0),s.visible=y!==null,y&&(s.position.set(...y.target),t.color.copy(y.isHeld?u.held:u.free))}return a(_,"showAim"),{group:i,update(y,f){h(y),g(y),_(f)},dispose(){for(let y of c)y.geometry.dispose();for(let y of[n,r])y.dispose();for(let y of[e,t])y.dispose();i.removeFromParent()}}}a(qf,"createLook");function Wf(i,e){return new Vr(new qr(1,2),e,i)}a(Wf,"beads");function Xf(i,e){i.count=e,i.visible=e>0,i.instanceMatrix.needsUpdate=!0}a(Xf,"show");var Tv=Math.PI/6,Av=.18,[Rv,Cv]=[.7,.35];function Yf(){let i=!0;function e(t){return Math.abs(t)<Cv&&(i=!0),!i||Math.abs(t)<Rv?0:(i=!1,-Math.sign(t)*Tv)}return a(e,"snap"),{read(t,n){let r=t??n,s=n??t,o=e(s?.x??0);if(!r)return{drive:wn,turn:o};let[l,c]=Mi(r===s?0:r.x,r.y,Av);return{drive:{...wn,right:l,ahead:0-c,isHasty:r.isPressed},turn:o}}}}a(Yf,"createSteering");var Pv=a(()=>!1,"glides");function Jf(i,e,t){let{renderer:n,rig:r}=i,s=null,o=null;n.xr.enabled=!0;async function l(){let p=await e.requestSession("immersive-vr",{requiredFeatures:["local-floor"],optionalFeatures:["hand-tracking","layers"]});p.addEventListener("end",u);try{await n.xr.setSession(p)}catch(g){throw await p.end(),g}let h=c(p);o=h,r.add(h.look.group),n.xr.getReferenceSpace()?.addEventListener("reset",()=>h.isMoved=!0),t.isStatic&&i.setMapLayer(Gf(n,i.faceSize))}a(l,"enter");function c(p){let h=t.pose(),g={look:qf(),aiming:Df(p,_=>{let{floor:y,jump:f}=g,m=y&&_i(y,_);f.start(()=>g.goal=m)}),steering:Yf(),jump:Nf(),walk:As(h,()=>s,Pv),floor:null,pose:h,goal:null,isMoved:!1};return g}a(c,"begin");function u(){if(!o)return;let{look:p,aiming:h,floor:g,pose:_}=o;o=null,p.dispose(),h.dispose(),i.setMapLayer(null),i.setVeil(0);let[y,f,m]=_.position;t.left({position:[y,g?g.position[1]+Ic:f,m],yaw:_.yaw,pitch:0})}a(u,"leave");function d(p,h,g,_){let{position:[y,f,m],yaw:S}=p.pose,A=[y,p.floor?.position[1]??f-Ic,m],v=p.floor&&!p.isMoved?p.floor:Lc(A,S,h);p.isMoved=!1;let{drive:M,turn:T}=p.steering.read($f(g,"left"),$f(g,"right"));return T!==0&&(v=Ff(v,h,T)),p.walk.follow(Ua(v,h)),p.walk.update(_,M),v=Nc(v,h,p.goal??p.walk.pose.position),p.goal=null,Nc(v,h,Dc(_i(v,h.position),s))}return a(d,"floorOf"),{get isPresenting(){return o!==null},toggle(){let p=n.xr.getSession();return p?p.end():l()},place(p){o&&Object.assign(o,{floor:null,pose:p})},update(p){let[h,g]=[n.xr.getFrame(),n.xr.getReferenceSpace()];if(!o||!h||!g)return null;let _=h.getViewerPose(g);if(!_)return o.pose;s=Of(t.bounds());let y=Bf(_.transform.matrix),f=zf(h,g);i.setVeil(o.jump.advance(p));let m=d(o,y,f,p);o.floor=m,o.pose=Ua(m,y),i.stand(m);let S=a(A=>Uf(m,Dc(_i(m,A),s)),"allowed");return o.look.update(f,o.aiming.update(f,S)),o.pose}}}a(Jf,"createHeadset");function $f(i,e){return i.find(({source:t})=>t.handedness===e)?.stick??null}a($f,"stickOf");async function Zf(i,e){if(!e)return"A headset can be entered where the page comes over https.";if(!i)return"This browser knows no headsets.";try{return await i.isSessionSupported("immersive-vr")?null:"No headset is connected."}catch{return"Headsets cannot be used from here."}}a(Zf,"whyNoHeadset");function Kf(i,e,t){let{xr:n}=navigator,r=null;async function s(){let o=await Zf(n,window.isSecureContext);if(o!==null||!n){t(o??"");return}r??=Jf(i,n,e),t(r)}a(s,"seek"),s(),n?.addEventListener("devicechange",()=>{s()})}a(Kf,"offerHeadset");var jf=75,Qf=.1,ep=.25,tp="The browser has taken the graphics away. The picture comes back as soon as they do.";async function Iv(){let i=new URLSearchParams(location.search),[e,t]=[np("canvas",HTMLCanvasElement),np("#ui",HTMLElement)],n=Bu(),r=new URL(i.get("bundle")??".",location.href),s=zu(i.get("strategy")),o=await lu(r,n.receive,new AbortController().signal);n.restart();let l=s.arrange(o.manifest),c=l.regions[0];if(!c)throw new Ye("manifest.json: expected a region, got none");let u=null,d=[],p=a(()=>{d.includes(tp)&&location.reload(),d=[],Pa(),h.retry()},"retry"),h=hf(e,{manifest:l,fetch:o.fetch,last:Number.parseInt(i.get("rings")??"",10)||c.rings.length,worker:new URL("worker.js",import.meta.url),angle:jf,antialias:i.get("aa")!=="0",isSmooth:s.isSmooth,isWhole:s.isWhole,failed(x){d=[x.message];let w=$c(x);w!==null&&o.distrust(w),h.facts.arrived<0&&ip(x)},lost(x){d=x?[tp]:[]},moved(x){f.setPose(x),u?.place(x)}}),g=a(x=>({position:l.regions[x]?.center??c.center,yaw:0,pitch:0}),"homeOf"),_=Za(location.hash)??g(0),y=Pf(t),f=Ru(e,{start:_,onThumb:y.show,onGo(x,w){let P=Iu(m,[x,w],Math.tan(jf*Math.PI/360),h.camera.aspect);h.go({...m,position:Lu(m.position,P,h.pointAt(x,w))})}}),m=f.update(0);window.nearfar={viewer:h,setPose:f.setPose,get pose(){return m}},window.addEventListener("hashchange",()=>h.go(Za(location.hash)??m));let A={setDivider:mf(t,x=>{h.setDivider(x),v.reflect({isDivided:x!==null})}).set,setMode:f.setMode,home:a(()=>h.go({...g(h.facts.region),yaw:m.yaw,pitch:m.pitch}),"home"),lookAround:f.lookAround,screenshot:h.photo,link:a(()=>new URL(Cu(m),location.href).href,"link"),retry:p};l.regions.length>1&&(A.next=()=>{let x=((Sr(l.regions,m.position)??0)+1)%l.regions.length;h.go({...g(x),yaw:m.yaw,pitch:m.pitch}),v.announce(`Place ${x+1} of ${l.regions.length}`)});let v=Cf(t,A);Kf(h,{pose:a(()=>m,"pose"),bounds:a(()=>h.facts.bounds,"bounds"),left:f.setPose,isStatic:l.dynamic===null},x=>{u=typeof x=="string"?null:x,A.headset=x}),h.open(Sr(l.regions,_.position)??0);let M=performance.now(),T=ep;h.renderer.setAnimationLoop(x=>{let w=Math.max(x-M,0)/1e3;if(M=x,m=u?.update(Math.min(w,Qf))??f.update(w),h.frame(m,Math.min(w,Qf)),f.setBounds(h.facts.bounds),n.frame(w),T+=w,T<ep)return;T=0;let{shown:P,triangles:C,region:D,received:B,expected:X}=h.facts,{center:L,fold_margin:q,rings:O}=l.regions[D]??c;v.update({ring:P?.ring??0,rings:O.length-1,radius:P?.grown.radius??0,...n.read(),received:B,expected:X,triangles:C,sceneTriangles:l.triangles,region:D,regions:l.regions.length,away:Bt(m.position,{center:L,metres:q}),foldMargin:q,problems:d})})}a(Iv,"main");function np(i,e){let t=document.querySelector(i);if(!(t instanceof e))throw new Error(`the page has no ${i}`);return t}a(np,"element");function ip(i){let e=i instanceof Error?i.message:String(i),{title:t,text:n}=gf[i instanceof Ye?i.kind:"other"];_f(t,n,{detail:e,retry:a(()=>location.reload(),"retry")})}a(ip,"tell");Iv().catch(ip);
