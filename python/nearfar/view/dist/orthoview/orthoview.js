var Rr=Object.defineProperty;var i=(r,e)=>Rr(r,"name",{value:e,configurable:!0});function V(r,e,t){return Math.min(Math.max(r,e),t)}i(V,"bounded");function De(r){return r-2*Math.PI*Math.round(r/(2*Math.PI))}i(De,"wrapped");function ut({yaw:r,pitch:e}){return[-Math.sin(r)*Math.cos(e),Math.sin(e),-Math.cos(r)*Math.cos(e)]}i(ut,"ahead");function ct(r){return[Math.cos(r),0,-Math.sin(r)]}i(ct,"rightOf");function se(r,e,t){return[r[0]+t*e[0],r[1]+t*e[1],r[2]+t*e[2]]}i(se,"moved");var Ar=512,Lr=3e7,Or=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;function We(r){if(r.length>Ar)return null;let e=new URLSearchParams(r.replace(/^#/,"")),[t,n,o,...s]=(e.get("p")??"").split(",").map(Fe);if(!He(t)||!He(n)||!He(o)||s.length>0)return null;let[a,l]=[Fe(e.get("yaw")??"0"),Fe(e.get("pitch")??"0")];return a===null||l===null?null:{position:[t,n,o],yaw:De(a),pitch:V(l,-1.5,1.5)}}i(We,"readLink");function dt({position:r,yaw:e,pitch:t}){return`#p=${r.map(o=>$e(o,3)).join(",")}&yaw=${$e(De(e),4)}&pitch=${$e(t,4)}`}i(dt,"writeLink");function Fe(r){let e=Or.test(r)?Number(r):Number.NaN;return Number.isFinite(e)?e:null}i(Fe,"numberIn");function He(r){return r!=null&&Math.abs(r)<=Lr}i(He,"isPlace");function $e(r,e){return String(Number(r.toFixed(e)))}i($e,"rounded");function ft(r=()=>performance.now()/1e3){let e=0,t=[],n=[];return{receive(o){e+=o,t.push({time:r(),bytes:o})},frame(o){n.push(o);let s=n.reduce((a,l)=>a+l,0);for(;n.length>1&&s>1;)s-=n.shift()??0},restart(){e=0,t=[],n=[]},read(){let o=r()-1;t=t.filter(({time:l})=>l>o);let s=t.reduce((l,u)=>l+u.bytes,0),a=n.reduce((l,u)=>l+u,0)/Math.max(n.length,1);return{received:e,rate:s>0?8*s/1:null,frame:1e3*a,longest:1e3*Math.max(0,...n)}}}}i(ft,"createMeter");function S(r,e={},...t){let n=document.createElement(r);return Ve(n,e),n.append(...t),n}i(S,"make");var mt="http://www.w3.org/2000/svg";function ae(r){let e=document.createElementNS(mt,"svg");Ve(e,{viewBox:"0 0 24 24",class:"icon","aria-hidden":"true",focusable:"false"});let t=document.createElementNS(mt,"path");return Ve(t,{d:r}),e.append(t),e}i(ae,"icon");function pt(r,e){r.textContent!==e&&(r.textContent=e)}i(pt,"write");function Ve(r,e){for(let[t,n]of Object.entries(e))n!==void 0&&n!==!1&&r.setAttribute(t,n===!0?"":n)}i(Ve,"setAll");var ie={walk:"M13 4.5a1.5 1.5 0 1 0 0-.01M9.5 21l2-5.5-2-3 1-4.5 3 .5 2 3 2.5 1M7 12.5l.5-3 3-1.5M12.5 13l2.5 3.5.5 4.5",orbit:"M12 14a2 2 0 1 0 0-4 2 2 0 0 0 0 4M17 8c2.5.8 4 2.2 4 4 0 2.8-4 5-9 5s-9-2.2-9-5 4-5 9-5M9.5 4L13 7l-3.5 3",split:"M12 3v18M4 6h5M4 6v12h5M20 6h-5M20 6v12h-5",photo:"M4 8h3.5L9 5.5h6L16.5 8H20v11H4zM12 16.5a3.25 3.25 0 1 0 0-6.5 3.25 3.25 0 0 0 0 6.5",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",home:"M4 11.5L12 5l8 6.5M6 10v9h4v-5h4v5h4v-9",next:"M12 21c-4-4.6-6-7.9-6-10.5a6 6 0 0 1 12 0C18 13.1 16 16.4 12 21M10 8.5l2.5 2-2.5 2",panel:"M4 5h16v14H4zM7 9h6M7 12h10M7 15h8",help:"M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.5v.01M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18",headset:"M3 8.5h18v8h-5.5L13.5 14h-3l-2 2.5H3zM7.5 12v.01M16.5 12v.01",close:"M6 6l12 12M18 6L6 18",grip:"M9 7l-5 5 5 5M15 7l5 5-5 5"};var Ke=3;function Ye(r,e,{detail:t,retry:n}={}){let o=S("h1",{tabindex:"-1",id:"message-title"},r),s=S("div",{class:"fatal-card"},S("p",{class:"fatal-brand"},"nearfar"),o);s.append(S("p",{},e)),t&&s.append(S("p",{class:"fatal-detail"},t)),n&&s.append(bt("Try again","button-main",n));let a=Xe();a.replaceChildren(s),a.dataset.kind="fatal";for(let l of document.querySelectorAll("canvas, [data-behind]"))l.setAttribute("inert","");o.focus({preventScroll:!0})}i(Ye,"showFatal");function yt(r,e){let t=Xe();if(t.dataset.kind==="fatal")return;let n=S("ul",{},...r.slice(0,Ke).map(a=>S("li",{},a)));r.length>Ke&&n.append(S("li",{},`and ${r.length-Ke} more`));let o=S("button",{type:"button",class:"button-icon","aria-label":"Dismiss",title:"Dismiss"});o.append(ae(ie.close)),o.addEventListener("click",ht);let s=S("div",{class:"banner-text"},S("strong",{},"Not all of the scene is shown"),n);r.length===0?ht():(t.replaceChildren(s,bt("Try again","button-main",e),o),t.dataset.kind="banner")}i(yt,"showProblems");function ht(){let r=Xe();r.replaceChildren(),delete r.dataset.kind;for(let e of document.querySelectorAll("canvas, [data-behind]"))e.removeAttribute("inert")}i(ht,"clearMessage");function bt(r,e,t){let n=S("button",{type:"button",class:e},r);return n.addEventListener("click",t),n}i(bt,"button");function Xe(){let r=document.getElementById("message");if(r)return r;let e=S("div",{id:"message",role:"alert"});return document.body.append(e),e}i(Xe,"message");var D={right:0,ahead:0,turn:0,look:0,isHasty:!1};function ue(...r){let e=i(a=>r.reduce((l,u)=>l+a(u),0),"sum"),[t,n]=le(e(a=>a.right),e(a=>a.ahead)),[o,s]=le(e(a=>a.turn),e(a=>a.look));return{right:t,ahead:n,turn:o,look:s,isHasty:r.some(a=>a.isHasty)}}i(ue,"together");function le(r,e){let t=Math.max(Math.hypot(r,e),1);return[r/t,e/t]}i(le,"within");function Y(r,e,t){let n=Math.hypot(r,e);if(!(n>t))return[0,0];let o=Math.min((n-t)/(1-t),1)/n;return[r*o,e*o]}i(Y,"beyondRest");var[Ur,Gr,Nr]=[300,400,16];function gt(r){let e=new Map,t=null,n=i((o,s)=>Math.hypot(o.clientX-s.clientX,o.clientY-s.clientY)<=Nr,"isNear");return{down(o){e.size>0&&(t=null),e.set(o.pointerId,o)},up(o){let s=e.get(o.pointerId),a=e.size===1;if(e.delete(o.pointerId),!(s&&a&&o.timeStamp-s.timeStamp<=Ur&&n(s,o))){t=null;return}let u=t!==null&&o.timeStamp-t.timeStamp<=Gr&&n(t,o);t=u?null:o,u&&r(o)}}}i(gt,"createTaps");var[ce,wt]=[1.6,Math.PI],je=1.5,kr=.0015,Ir=[1,16,400],de=56,zr=.12;function vt(r,e){let t=new Map,n=new AbortController,o=D,s=gt(d),a=!1,l=i(()=>1/Math.max(r.clientHeight,1),"scale"),u=i(()=>r.ownerDocument.pointerLockElement===r,"isLocked");function d({clientX:h,clientY:v}){let{left:E,top:M,width:_,height:A}=r.getBoundingClientRect();u()?e.go(.5,.5):e.go((h-E)/Math.max(_,1),(v-M)/Math.max(A,1))}i(d,"go");function c(h){if(u())return;a=h.pointerType==="touch";let v=h.pointerType==="mouse",E=h.button===0&&!h.shiftKey;if(e.mode()==="walk"&&v&&!E)return;r.setPointerCapture(h.pointerId),a&&s.down(h);let M=f(h)?"step":E?"turn":"pan";t.set(h.pointerId,{x:h.clientX,y:h.clientY,task:M}),M==="step"&&p({x:h.clientX,y:h.clientY},h)}i(c,"down");function f({pointerType:h,clientX:v}){if(e.mode()!=="walk"||h!=="touch"||[...t.values()].some(({task:_})=>_==="step"))return!1;let{left:E,width:M}=r.getBoundingClientRect();return v-E<M/2}i(f,"isThumb");function m(h){let v=t.get(h.pointerId);if(!v){u()&&e.look(-h.movementX*ce*l(),-h.movementY*ce*l());return}if(v.task==="step"){p(v,h);return}let E={...v,x:h.clientX,y:h.clientY},M=[...t].find(([k,{task:C}])=>k!==h.pointerId&&C!=="step")?.[1],[_,A]=[(E.x-v.x)*l(),(E.y-v.y)*l()];t.set(h.pointerId,E),e.mode()==="walk"?e.look(_*ce,A*ce):M?y(v,E,M):v.task==="pan"?e.pan(-_*je,A*je):e.rotate(-_*wt,-A*wt)}i(m,"move");function p({x:h,y:v},{clientX:E,clientY:M}){let[_,A]=Y((E-h)/de,(M-v)/de,zr);o={...D,right:_,ahead:0-A},e.thumb({x:h,y:v,right:E-h,down:M-v})}i(p,"step");function y(h,v,E){let[M,_]=[h,v].map(({x:k,y:C})=>Math.hypot(k-E.x,C-E.y));M&&_&&e.zoom(M/_);let A=.5*je*l();e.pan(-(v.x-h.x)*A,(v.y-h.y)*A)}i(y,"pinch");function b(h){h.pointerType==="touch"&&s.up(h),t.get(h.pointerId)?.task==="step"&&g(),t.delete(h.pointerId)}i(b,"up");function g(){o=D,e.thumb(null)}i(g,"rest");function w(h){e.mode()==="orbit"&&(h.preventDefault(),e.zoom(Math.exp(kr*h.deltaY*(Ir[h.deltaMode]??1)*(h.ctrlKey?6:1))))}i(w,"wheel");function T(){e.mode()==="walk"&&Promise.resolve(r.requestPointerLock()).catch(()=>{})}i(T,"lock");let{signal:x}=n;r.addEventListener("pointerdown",c,{signal:x}),r.addEventListener("pointermove",m,{signal:x}),r.addEventListener("pointerup",b,{signal:x}),r.addEventListener("pointercancel",b,{signal:x}),r.addEventListener("dblclick",h=>a||d(h),{signal:x}),r.addEventListener("wheel",w,{signal:x,passive:!1}),r.addEventListener("contextmenu",h=>h.preventDefault(),{signal:x});function P(){t.clear(),g(),u()&&r.ownerDocument.exitPointerLock()}return i(P,"release"),{get drive(){return o},lock:T,release:P,dispose(){P(),n.abort()}}}i(vt,"createPointers");function xt(r){let e=S("div",{class:"thumb",hidden:!0,"aria-hidden":"true"},S("span",{}));return r.append(e),{show(t){if(e.hidden=t===null,!t)return;let{x:n,y:o,right:s,down:a}=t,l=Math.min(1,de/Math.max(Math.hypot(s,a),1)),u={"--x":n,"--y":o,"--right":s*l,"--down":a*l};for(let[d,c]of Object.entries(u))e.style.setProperty(d,`${c}px`)},dispose:i(()=>e.remove(),"dispose")}}i(xt,"createThumbMark");var Tt=.18,Cr=[4,10];function Et(r){let e=r.filter(t=>t!==null&&t.connected&&t.mapping==="standard");return e.length===0?D:ue(...e.map(t=>t?Br(t):D))}i(Et,"readPads");function Br({axes:r,buttons:e}){let[t,n]=Y(r[0]??0,r[1]??0,Tt),[o,s]=Y(r[2]??0,r[3]??0,Tt),a=Cr.some(l=>e[l]?.pressed??!1);return{right:t,ahead:0-n,turn:0-o,look:0-s,isHasty:a}}i(Br,"wishOf");var Pt={KeyW:[0,1,0,0],KeyS:[0,-1,0,0],KeyA:[-1,0,0,0],KeyD:[1,0,0,0],ArrowUp:[0,1,0,0],ArrowDown:[0,-1,0,0],ArrowLeft:[0,0,1,0],ArrowRight:[0,0,-1,0],PageUp:[0,0,0,1],PageDown:[0,0,0,-1]};function Dr(r){return Object.hasOwn(Pt,r)}i(Dr,"isMoving");function qe(r){if(r.defaultPrevented||r.ctrlKey||r.metaKey||r.altKey)return!0;let{target:e}=r;return typeof Element<"u"&&e instanceof Element&&e.closest(Fr)!==null}i(qe,"isElsewhere");var Fr="input, textarea, select, [contenteditable], dialog[open]";function St(r){let e=new Set,t=new AbortController,n=i((s,a)=>r.addEventListener(s,a,{signal:t.signal}),"listen"),o=!1;return n("keydown",s=>{let a=s;o=a.shiftKey,!(!Dr(a.code)||qe(a))&&(e.add(a.code),a.preventDefault())}),n("keyup",s=>{o=s.shiftKey,e.delete(s.code),s.key==="Meta"&&e.clear()}),n("blur",()=>{e.clear(),o=!1}),{get drive(){let s=[0,0,0,0];for(let m of e)Pt[m]?.forEach((p,y)=>s[y]=(s[y]??0)+p);let[a=0,l=0,u=0,d=0]=s,[c,f]=le(a,l);return{right:c,ahead:f,turn:Math.sign(u),look:Math.sign(d),isHasty:o}},dispose:i(()=>t.abort(),"dispose")}}i(St,"createKeys");var[Hr,$r]=[.6,3],[Wr,Mt,Vr]=[4,5,.004],_t=1.2,Kr=.25,Rt={KeyE:1,Space:1,KeyQ:-1,KeyC:-1};function Yr(r,e,t,n,o,s){let a=r.yaw+_t*e.turn*s,l=V(r.pitch+_t*e.look*s,-1.5,1.5),u=Math.max(r.position[1]-o,$r),d=Hr*u*2**n*(e.isHasty?Wr:1)*s,c=se(r.position,ut({yaw:a,pitch:l}),d*e.ahead);return c=se(c,ct(a),d*e.right),{position:se(c,[0,1,0],d*t),yaw:a,pitch:l}}i(Yr,"flown");function At(r,e,t,n){let o=e,s=0,a=new Set,l=St(window),u=i((f,m)=>{o={...o,yaw:o.yaw+f,pitch:V(o.pitch+m,-1.5,1.5)}},"turn"),d=i(()=>{},"none"),c=vt(r,{mode:i(()=>"walk","mode"),look:u,rotate:d,pan:d,zoom:d,thumb:n,go:d});return window.addEventListener("keydown",f=>{!Object.hasOwn(Rt,f.code)||qe(f)||(a.add(f.code),f.target instanceof HTMLButtonElement||f.preventDefault())}),window.addEventListener("keyup",({code:f})=>a.delete(f)),window.addEventListener("blur",()=>a.clear()),r.addEventListener("wheel",f=>{f.preventDefault(),s=V(s-Vr*f.deltaY*(f.deltaMode===1?16:1),-Mt,Mt)},{passive:!1}),{get pose(){return o},get power(){return s},update(f){let m=f>0?Math.min(f,Kr):0,p=ue(l.drive,c.drive,Et(Xr())),y=Math.sign([...a].reduce((g,w)=>g+(Rt[w]??0),0));return y===0&&[p.right,p.ahead,p.turn,p.look].every(g=>g===0)||(o=Yr(o,p,y,s,t(),m)),o},setPose(f){o=f}}}i(At,"createFly");function Xr(){try{return navigator.getGamepads?.()??[]}catch{return[]}}i(Xr,"padsOf");var[jr,Je]=[.55,.45];function Lt({origin:r,cell:e,counts:t}){let n=r.map((a,l)=>a+e*t[l]/2),o=jr*e*Math.max(t[0],t[2]);return{position:[n[0],r[1]+o*Math.sin(Je),n[2]+o*Math.cos(Je)],yaw:0,pitch:-Je}}i(Lt,"startOf");function Ot({position:r,yaw:e,pitch:t},n,o,s){let[a,l,u,d]=[Math.sin(e),Math.cos(e),Math.sin(t),Math.cos(t)],c=Math.tan(n/2),f=c*o/s;return{position:r,right:[l,0,-a],up:[a*u,d,l*u],back:[a*d,-u,l*d],fov:{left:-f,right:f,down:-c,up:c},width:o,height:s}}i(Ot,"cameraOf");function fe({right:r,up:e,back:t,fov:n,width:o,height:s},a,l){let u=n.left+(n.right-n.left)*a/o,d=n.up+(n.down-n.up)*l/s;return[0,1,2].map(c=>{let[f,m,p]=[r[c],e[c],t[c]];return u*f+d*m-p})}i(fe,"directionAt");function F(r,e){return r[0]*e[0]+r[1]*e[1]+r[2]*e[2]}i(F,"dot");function Qe(r,e){return[r[1]*e[2]-r[2]*e[1],r[2]*e[0]-r[0]*e[2],r[0]*e[1]-r[1]*e[0]]}i(Qe,"cross");function K(r){let e=Math.sqrt(F(r,r));return e>0?[r[0]/e,r[1]/e,r[2]/e]:[0,1,0]}i(K,"unit");var Ut=["","k","M","G","T"];function me(r){return kt(r,"B")}i(me,"bytes");function Gt(r){return r===null?"idle":kt(r,"b/s")}i(Gt,"rate");function pe(r){return he(r)?r>=9995e5?`${(r/1e9).toFixed(2)}\xA0billion`:r>=999999.5?`${(r/1e6).toFixed(2)}\xA0million`:Math.round(r).toLocaleString("en"):"\u2013"}i(pe,"count");function Nt(r){return he(r)?`${r.toFixed(r<99.95?1:0)}\xA0ms`:"\u2013"}i(Nt,"milliseconds");function Ze(r){return he(r)?r>=999.5?`${(r/1e3).toFixed(1)}\xA0km`:`${r.toFixed(r<.995?2:r<99.95?1:0)}\xA0m`:"\u2013"}i(Ze,"metres");function kt(r,e){if(!he(r))return"\u2013";let t=qr(r);return`${Jr(r,t)}\xA0${Ut[t]}${e}`}i(kt,"scaled");function qr(r){let e=0;for(;e<Ut.length-1&&r/1e3**e>=999.5;)e+=1;return e}i(qr,"powerOf");function Jr(r,e){let t=r/1e3**e;return t.toFixed(e>1&&t<99.95?1:0)}i(Jr,"digits");function he(r){return Number.isFinite(r)&&r>=0}i(he,"isAmount");var Qr={frame:"Frame",splats:"Splats",views:"Views",waiting:"Waiting",loaded:"Loaded",memory:"On the GPU",height:"Height"};function It(r,e){let t=new Map,n=Object.entries(Qr).map(([c,f])=>{let m=S("dd",{},"\u2013");return t.set(c,m),S("div",{},S("dt",{},f),m)}),o=S("div",{class:"panel card",role:"region","aria-label":"Figures"}),s=et("Figures","chip card",()=>d(!0)),a=S("button",{type:"button","aria-label":"Hide the figures",title:"Hide"},ae(ie.close));a.addEventListener("click",()=>d(!1)),o.append(S("header",{},S("h1",{},"nearfar"),a),S("div",{class:"panel-body"},S("dl",{class:"figures"},...n)));let l=S("p",{class:"note card"}),u=S("div",{class:"tools"},et("Home","tool",e),et("Help","tool",()=>l.hidden=!l.hidden));l.textContent=en,l.hidden=!0,r.append(S("div",{class:"frame"},S("div",{class:"top"},o,s),S("div",{class:"bottom"},l,u)));function d(c){o.hidden=!c,s.hidden=c}return i(d,"show"),d(window.innerWidth>600),{update({facts:c,frame:f,received:m,rate:p,height:y,power:b}){let g=i((w,T)=>pt(t.get(w),T),"put");g("frame",Nt(f)),g("splats",Zr(c)),g("views",c.standIns>0?`${c.views}, ${c.standIns} coarser`:String(c.views)),g("waiting",c.waiting>0?`${c.waiting} views`:"nothing"),g("loaded",p===null?me(m):`${me(m)}, ${Gt(p)}`),g("memory",me(c.bytes)),g("height",b===0?Ze(y):`${Ze(y)}, speed \xD7 ${(2**b).toFixed(b<0?2:1)}`)}}}i(It,"createPanel");function Zr({splats:r,unhidden:e}){return e===null?pe(r):`${pe(r)}, ${pe(e)} drawn`}i(Zr,"splatsOf");var en="Dragging looks around. W A S D or the left thumb fly, E and Q go up and down, arrow keys turn, Shift is four times as fast, the wheel changes the speed. The address leads back to this place.";function et(r,e,t){let n=S("button",{type:"button",class:e},r);return n.addEventListener("click",t),n}i(et,"button");function I({kind:r}){return r==="refused"||r==="unreachable"}i(I,"isPassing");var tt=["color","depth","normal"],tn="behind_";var rn="nearfar",U=-1;function zt({depthBits:r}){return Math.floor((2**r-1)/6)*6}i(zt,"stepsOf");function X({cell:r},e){return r*2**e}i(X,"sideAt");function ye(r,e,[t,n,o]){let[s,[a,l,u]]=[X(r,e),r.origin];return[a+t*s,l+n*s,u+o*s]}i(ye,"cornerOf");function rt({subtree:r},e){return 2**(r-e%r)}i(rt,"shardSide");function H(r,e,[t,n,o]){let s=rt(r,e),a=[Math.floor(t/s),Math.floor(n/s),Math.floor(o/s)];return{tier:Math.floor(e/r.subtree),place:a}}i(H,"subtreeOf");function Ct(r){return r===0?"":`${rn}/generations/${r}/`}i(Ct,"overlay");function Bt({names:r},e,t,n){return`${e}/${r[t]}/${n}`}i(Bt,"arrayOf");function Dt(r,e,t,n){return`${n}/c/${H(r,e,t).place.join("/")}/0/0/0`}i(Dt,"shardOf");function Ft({levels:r},e){return["content","moving"].map(t=>`geometry/${t}/${r-1}/${e.join("/")}.glb`)}i(Ft,"geometryOf");function Ht({layers:r}){return r===2?[...tt,...tt.map(e=>tn+e)]:tt}i(Ht,"channelsOf");function R(r,[e,t,n]){return`${r}/${e}/${t}/${n}`}i(R,"nameOf");function nt([r,e,t]){return Array.from({length:8},(n,o)=>[2*r+(o>>2),2*e+(o>>1&1),2*t+(o&1)])}i(nt,"childrenOf");function $t([r,e,t],n){let o=2**n;return[Math.floor(r/o),Math.floor(e/o),Math.floor(t/o)]}i($t,"above");var nn={mask:0,generation:0},be=class{constructor(e){this.layout=e}layout;static{i(this,"Cells")}#e=new Map;add(e){this.#e.set(R(e.tier,e.place),e)}knows(e,t){return this.#e.has(R(e,t))}guestsOf(e){let{tier:t,place:n}=H(this.layout,0,e);return this.#e.get(R(t,n))?.guests.get(R(0,e))??[]}at(e,t){let{tier:n,place:o}=H(this.layout,e,t),s=this.#e.get(R(n,o));if(!s)return null;let a=rt(this.layout,e),[l,u,d]=t.map((y,b)=>y-o[b]*a),c=(l*a+u)*a+d,f=e%this.layout.subtree,[m,p]=[s.masks[f]?.[c],s.generations[f]?.[c]];return m===void 0||p===void 0?nn:{mask:m,generation:p}}};var[on,sn]=[1,30],Wt="",ge=class{constructor(e){this.settings=e}settings;static{i(this,"Queue")}#e=new Map;#t=new Map;#r=new Set;#n=new Map;#s=0;get waiting(){return[...this.#n.keys()].filter(e=>this.#t.get(e)?.again!==Number.POSITIVE_INFINITY).length}want(e){this.#n=e;for(let[t,n]of this.#e)n.isCancelled||e.has(n.name)||(n.isCancelled=!0,this.settings.cancel(t));this.fill()}fill(){let e=new Set([...this.#e.values()].map(({name:n})=>n)),t=this.settings.now();for(let[n,o]of this.#n){if(this.#e.size>=this.settings.atOnce)return;if(e.has(n)||(this.#t.get(n)?.again??0)>t)continue;let s=++this.#s;this.#e.set(s,{name:n,job:o,isCancelled:!1}),this.settings.send(s,o)}}done(e){let t=this.#a(e);return t&&(this.#t.delete(t.name),this.#n.delete(t.name),this.#r.delete(Wt)&&this.settings.recovered()),t?.job??null}cancelled(e){this.#a(e),this.fill()}failed(e,t){let n=this.#a(e);if(n){let o=Math.min(2*(this.#t.get(n.name)?.pause??on/2),sn),s=I(t)?this.settings.now()+o:Number.POSITIVE_INFINITY;this.#t.set(n.name,{again:s,pause:o});let a=I(t)?Wt:t.message;this.#r.has(a)||this.settings.failed(t),this.#r.add(a)}return this.fill(),I(t)?null:n?.job??null}retry(){this.#t.clear(),this.#r.clear(),this.fill()}#a(e){let t=this.#e.get(e);return this.#e.delete(e),t??null}};function Vt(r,e,t,n,o){let s=new Map,a=Array.from({length:e},()=>new Worker(r,{type:"module"}));for(let l of a)l.onmessage=({data:u})=>{switch(u.kind){case"view":s.delete(u.id),o.view(u.id,u.layers);break;case"leaf":s.delete(u.id),o.leaf(u.id,u.pieces);break;case"failed":s.delete(u.id),o.failed(u.id,u.failure);break;case"cancelled":s.delete(u.id),o.cancelled(u.id);break;case"received":o.received(u.bytes)}},l.onerror=({message:u})=>{let d={kind:"other",message:`a worker stopped: ${u||"the browser gives no reason"}`};for(let[c,f]of s)f===l&&o.failed(c,d)},ot(l,{kind:"open",base:t.href,layout:n});return{read(l,u){let d=u.direction===U?"":u.shards[0]?.[0]??"",c=a[an(d)%a.length];s.set(l,c),ot(c,{kind:"read",id:l,wanted:u})},cancel(l){let u=s.get(l);u&&ot(u,{kind:"cancel",id:l})}}}i(Vt,"startReaders");function ot(r,e){r.postMessage(e)}i(ot,"send");function an(r){let e=2166136261;for(let t=0;t<r.length;t++)e=Math.imul(e^r.charCodeAt(t),16777619);return e>>>0}i(an,"hash");function st(r){let e=r[0]===0&&r[2]===0?[1,0,0]:[r[2],0,-r[0]],t=[e,Qe(r,e),r],n=t.map(o=>(Math.abs(o[0])+Math.abs(o[1])+Math.abs(o[2]))/Math.hypot(...o));return{axes:[K(t[0]),K(t[1]),K(t[2])],extents:n}}i(st,"frameOf");function Kt(r,{views:e}){let[t,n]=[0,r];for(;n!==0;n&=n-1)t+=1;return Math.min(t,e)}i(Kt,"countOf");var ln=3;function Yt(r,e,t,n,o){let s=[],a=[],l=new Map,u=new Map,d=0,c=i((b,g,w=null)=>t(b,g).map(T=>({level:b,place:g,direction:T,box:w})),"all"),f=i((b,g)=>{let w=e.at(b,g)?.mask??0;return w!==0&&t(b,g).length>=Kt(w,{views:n})},"isFull");function m(b,g,w){if(b===0||w===0)return null;let T=[];for(let x of nt(g)){let P=e.at(b-1,x);if(!P)return null;if(P.mask===0)continue;let h=f(b-1,x)?c(b-1,x).slice(-n):m(b-1,x,w-1);if(!h)return null;T.push(...h)}return T}i(m,"below");function p(b){let g=[];for(let w=b.level+1;w<e.layout.levels;w++){let T=$t(b.place,w-b.level),x={level:b.level,place:b.place};if(f(w,T))return c(w,T,x).slice(-n);g.length===0&&(g=c(w,T,x))}return g}i(p,"standIn");function y(b,g){let{level:w,place:T,directions:x}=b,P=new Set(t(w,T)),h=x.filter(_=>P.has(_)),v=x.filter(_=>g&&!P.has(_));if(a.push(...v.map(_=>({level:w,place:T,direction:_}))),h.length===x.length){s.push(...h.map(_=>({level:w,place:T,direction:_,box:null})));return}let E=f(w,T)?un(h,P,x.length):null;if(E){s.push(...E.map(_=>({level:w,place:T,direction:_,box:null})));return}let M=m(w,T,ln)??p(b);M.length===0&&(M=c(w,T)),M.length===0&&(d+=1),s.push(...M)}i(y,"show");for(let b of r.leaves){let g=[b.place,...e.guestsOf(b.place)],w=g.map(o),T=!w.includes("never"),x=g.filter((P,h)=>w[h]==="coming");if(T&&x.length===0)for(let P of g)l.set(R(0,P),P);else y(b,!T);if(T)for(let P of x)u.set(R(0,P),P)}for(let b of r.cells)y(b,!0);return{shown:cn(s),near:[...l.values()],coming:[...u.values()],missing:a,holes:d}}i(Yt,"choose");function un(r,e,t){let n=[...e].filter(o=>!r.includes(o));return[...r,...n.slice(n.length-(t-r.length))]}i(un,"fill");function cn(r){let e=new Map;for(let t of r){let n=t.box?R(t.box.level,t.box.place):"";e.set(`${R(t.level,t.place)}/${t.direction}/${n}`,t)}return[...e.values()]}i(cn,"unique");var we=3;var[j,z]=[1.27,.5],q=.25,G=10;function Xt(r,e,t,n){let o=X(r,e),s=ye(r,e,t),a=st(r.directions[n]),l=a.extents.map(b=>b*o),u=[l[0]/r.size,l[1]/r.size,l[2]/zt(r)],[d,c,f]=a.axes,m=s.map((b,g)=>b+o/2+(-d[g]*l[0]+c[g]*l[1]+f[g]*l[2])/2),p=i((b,g)=>[b[0]*g,b[1]*g,b[2]*g],"scaled"),y=[p(d,u[0]),p(c,-u[1]),p(f,-u[2])];return{frame:a,pitch:u,start:m,steps:y,normalBits:r.normalBits/2}}i(Xt,"modelOf");function ve(r){let{position:e,right:t,up:n,back:o,fov:s,width:a,height:l}=r,[u,d]=[a/(s.right-s.left),l/(s.up-s.down)],c=i(y=>[y(0),y(1),y(2)],"row"),f=[c(y=>u*(t[y]+s.left*o[y])),c(y=>-d*(n[y]+s.up*o[y])),c(y=>-o[y])],m=fe(r,0,0),p=i((y,b)=>{let g=fe(r,y,b);return[g[0]-m[0],g[1]-m[1],g[2]-m[2]]},"step");return{eye:e,rows:f,rays:[m,p(1,0),p(0,1)],width:a,height:l}}i(ve,"projectorOf");function xe(r,{eye:e,rows:t}){let{start:n,steps:o,pitch:s}=r,a=[n[0]-e[0],n[1]-e[1],n[2]-e[2]],l=i(m=>[F(t[0],m),F(t[1],m),F(t[2],m)],"along"),[u,d]=[j*Math.sqrt(z),jt(r)],c=i(m=>Math.max(u,d/m)-.5,"across"),f=u*(s[0]+s[1])/q;return{start:l(a),steps:[l(o[0]),l(o[1]),l(o[2])],least:Math.max(s[0],s[1]),margin:[c(s[0]),c(s[1]),Math.max(f,d)/s[2]]}}i(xe,"sightOf");function jt({pitch:r}){return Math.hypot(r[0],r[1])/2}i(jt,"ballOf");function Te({start:r,steps:e,least:t,margin:n},{low:o,high:s},a,l){let[u,d,c,f,m]=[!0,!0,!0,!0,!0],p=Number.POSITIVE_INFINITY,y=[Number.POSITIVE_INFINITY,Number.POSITIVE_INFINITY],b=[Number.NEGATIVE_INFINITY,Number.NEGATIVE_INFINITY];for(let g=0;g<8;g++){let w=o.map((v,E)=>g>>E&1?s[E]+n[E]:v-n[E]),T=i(v=>r[v]+w[0]*e[0][v]+w[1]*e[1][v]+w[2]*e[2][v],"value"),[x,P,h]=[T(0),T(1),T(2)];u&&=x<-h,d&&=x>(a+1)*h,c&&=P<-h,f&&=P>(l+1)*h,m&&=h<t,p=Math.min(p,h),y[0]=Math.min(y[0],x/h),y[1]=Math.min(y[1],P/h),b[0]=Math.max(b[0],x/h),b[1]=Math.max(b[1],P/h)}return u||d||c||f||m?null:p<t?{low:[0,0],high:[a,l],nearness:Number.POSITIVE_INFINITY}:{low:[Math.max(Math.floor(y[0])-1,0),Math.max(Math.floor(y[1])-1,0)],high:[Math.min(Math.floor(b[0])+2,a),Math.min(Math.floor(b[1])+2,l)],nearness:1/p}}i(Te,"seenOf");function Ee(r,{low:e,high:t}){return r.every(([n,o,s,a])=>{let l=[n,o,s].map((d,c)=>{let[f,m]=[d*e[c],d*t[c]];return[Math.min(f,m),Math.max(f,m)]}),u=i(d=>l.reduce((c,f)=>c+f[d],a),"sum");return u(0)<1&&u(1)>=0})}i(Ee,"isIn");function Pe(r,e,t){if(!t)return[0,1,2].map(()=>[0,0,0,.5]);let n=X(e,t.level),o=ye(e,t.level,t.place);return[0,1,2].map(s=>{let a=i(l=>r.steps[l][s]/n,"factor");return[a(0),a(1),a(2),(r.start[s]-o[s])/n]})}i(Pe,"rowsOf");function Se(r,e,t,n){let{frame:o,pitch:s}=e,[a,l,u]=o.axes,d=2/(2**e.normalBits-2),c=i((m,[p,y,b],g)=>r.set([p,y,b,g],4*m),"put"),f=i((m,p)=>[m[0]*p,m[1]*p,m[2]*p],"scaled");c(0,t.start,t.least),c(1,t.steps[0],d),c(2,t.steps[1],jt(e)/Math.sqrt(z)),c(3,t.steps[2],0),c(4,f(a,s[0]/s[2]),0),c(5,f(l,s[1]/s[2]),0),c(6,u,0),n.forEach((m,p)=>r.set(m,4*(7+p)))}i(Se,"writeView");function Me(r,e){let t=1e6;for(let{layer:n}of r)t=Math.min(t,Math.max(n.model.pitch[0],n.model.pitch[1]));return e?Math.min(t/2,.05):t/2}i(Me,"nearestOf");function J(r,e,t){let n=r.createProgram();for(let[s,a]of[[r.VERTEX_SHADER,e],[r.FRAGMENT_SHADER,t]]){let l=r.createShader(s);if(!l)throw new Error("the browser has taken the graphics away");r.shaderSource(l,a),r.compileShader(l),r.attachShader(n,l),r.deleteShader(l)}if(r.linkProgram(n),!r.getProgramParameter(n,r.LINK_STATUS)){let s=(r.getAttachedShaders(n)??[]).map(a=>r.getShaderInfoLog(a));throw new Error(`a shader does not compile: ${[...s,r.getProgramInfoLog(n)].filter(Boolean).join(" ")}`)}let o=new Map;return{program:n,at(s){return o.has(s)||o.set(s,r.getUniformLocation(n,s)),o.get(s)??null}}}i(J,"programOf");function qt(r,e,t){let[n,o,s]=[r.createFramebuffer(),r.createTexture(),r.createRenderbuffer()];return r.bindTexture(r.TEXTURE_2D,o),r.texStorage2D(r.TEXTURE_2D,1,r.SRGB8_ALPHA8,e,t),r.texParameteri(r.TEXTURE_2D,r.TEXTURE_MIN_FILTER,r.NEAREST),r.texParameteri(r.TEXTURE_2D,r.TEXTURE_MAG_FILTER,r.NEAREST),r.bindRenderbuffer(r.RENDERBUFFER,s),r.renderbufferStorage(r.RENDERBUFFER,r.DEPTH_COMPONENT32F,e,t),r.bindFramebuffer(r.FRAMEBUFFER,n),r.framebufferTexture2D(r.FRAMEBUFFER,r.COLOR_ATTACHMENT0,r.TEXTURE_2D,o,0),r.framebufferRenderbuffer(r.FRAMEBUFFER,r.DEPTH_ATTACHMENT,r.RENDERBUFFER,s),r.bindFramebuffer(r.FRAMEBUFFER,null),{frame:n,color:o,width:e,height:t,dispose(){r.deleteFramebuffer(n),r.deleteTexture(o),r.deleteRenderbuffer(s)}}}i(qt,"targetOf");var dn={SUN_DIRECTION:[.5263158,.7894737,.3157895],SUN:[.6,.56,.5],SKY_DIRECTION:[-.2062843,.9282791,.3094264],SKY_LOW:[.13,.135,.15],SKY_HIGH:[.38,.42,.48],HORIZON:[.66,.74,.82],ZENITH:[.16,.34,.66],NADIR:[.24,.25,.26]},Jt=["SUN_DIRECTION","SUN","SKY_DIRECTION","SKY_LOW","SKY_HIGH"],Qt=["HORIZON","ZENITH","NADIR"],L=i(r=>Number.isInteger(r)?r.toFixed(1):String(r),"float"),Zt=i(r=>dn[r].map(L).join(", "),"vector"),er=i(r=>r.map(e=>`const vec3 ${e} = vec3(${Zt(e)});`).join(`
`),"glsl"),fn=i(r=>r.map(e=>`const ${e} = vec3<f32>(${Zt(e)});`).join(`
`),"wgsl"),_e=`
${er(Jt)}

vec3 irradiance(vec3 n) {
  float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
  return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`,tr=`
${er(Qt)}

vec3 background(vec3 direction) {
  return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`,rr=`
vec3 srgb_of(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
`,nr=`
vec3 linear_of(vec3 c) {
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, vec3(lessThanEqual(c, vec3(0.04045))));
}
`,Q=`
${fn([...Jt,...Qt])}

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
`;var $=`#version 300 es
precision highp float;
precision highp int;
`,or=`${$}
layout(location = 0) in uvec3 splat;
uniform vec4 view[${G}];
// The camera's gradients of X, Y and W, and the rays through the corner, a sample to the right and one down.
uniform vec3 gradients[3];
uniform vec3 rays[3];
// Width and height of the picture in samples, and the greatest size of a point.
uniform vec3 screen;
flat out vec4 v_inverse;
flat out vec2 v_middle;
flat out vec3 v_nearness;
flat out vec3 v_color;
const float RADIUS = ${L(Math.sqrt(z))};
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
${_e}
${nr}
// Half of the extent of a ball along an axis: the length of the gradient of X/W.
float disc(vec3 own, float place, float over) {
  return length((own - place * gradients[2]) * over) * view[2].w;
}

void main() {
  float depth = float((splat.x >> 24) << 8 | splat.y >> 24) - 0.5;
  vec3 at = vec3(float(splat.z & 4095u) + 0.5, float(splat.z >> 12 & 4095u) + 0.5, depth);
  vec3 inside = vec3(dot(view[7].xyz, at), dot(view[8].xyz, at), dot(view[9].xyz, at));
  inside += vec3(view[7].w, view[8].w, view[9].w);
  vec3 function = view[0].xyz + at.x * view[1].xyz + at.y * view[2].xyz + at.z * view[3].xyz;
  float over = 1.0 / function.z;
  vec2 middle = function.xy * over;

  // The normal, and the depth steps by which its plane falls for each pixel.
  vec2 code = vec2(float(splat.y & 4095u), float(splat.y >> 12 & 4095u)) * view[1].w - 1.0;
  vec3 normal = vec3(code, 1.0 - abs(code.x) - abs(code.y));
  float fold = max(-normal.z, 0.0);
  normal.xy -= vec2(normal.x < 0.0 ? -fold : fold, normal.y < 0.0 ? -fold : fold);
  normal = normalize(normal);
  float facing = 1.0 / max(dot(view[6].xyz, normal), ${L(q)});
  vec3 u = view[1].xyz + dot(view[4].xyz, normal) * facing * view[3].xyz;
  vec3 v = view[2].xyz - dot(view[5].xyz, normal) * facing * view[3].xyz;
  bool is_surfel = (splat.z >> 24 & 1u) == 1u;
  float factor = is_surfel ? ((splat.z >> 25 & 1u) == 1u ? 1.0 : ${L(j)}) : 0.0;

  // The ellipse's axes in the picture, and the changes of nearness along them.
  vec2 du = (u.xy - middle * u.z) * over * factor;
  vec2 dv = (v.xy - middle * v.z) * over * factor;
  vec2 slope = -vec2(u.z, v.z) * over * over * factor;
  float determinant = du.x * dv.y - dv.x * du.y;
  vec2 half_size;
  if (is_surfel) {
    // A surfel that is seen from its edge is a line: only the sample of its middle shows it.
    bool is_flat = abs(determinant) <= 1.2e-7 * (abs(du.x) + abs(dv.x)) * (abs(du.y) + abs(dv.y));
    float inverse = is_flat ? 0.0 : 1.0 / determinant;
    v_inverse = is_flat ? vec4(1e9) : vec4(dv.y, -dv.x, -du.y, du.x) * inverse;
    vec4 change = vec4(dv.y, -dv.x, -du.y, du.x) * inverse;
    v_nearness = vec3(over, slope.x * change.x + slope.y * change.z, slope.x * change.y + slope.y * change.w);
    half_size = is_flat ? vec2(0.0) : RADIUS * sqrt(vec2(du.x * du.x + dv.x * dv.x, du.y * du.y + dv.y * dv.y));
  } else {
    vec2 ball = vec2(disc(gradients[0], middle.x, over), disc(gradients[1], middle.y, over));
    v_inverse = vec4(1.0 / ball.x, 0.0, 0.0, 1.0 / ball.y);
    v_nearness = vec3(over, 0.0, 0.0);
    half_size = RADIUS * ball;
  }
  v_middle = middle;

  // A view sees the insides of what a cell's side cuts open: normals are turned towards the viewer.
  vec3 ray = rays[0] + middle.x * rays[1] + middle.y * rays[2];
  normal = dot(normal, ray) > 0.0 ? -normal : normal;
  vec3 albedo = linear_of(vec3(splat.x & 255u, splat.x >> 8 & 255u, splat.x >> 16 & 255u) / 255.0);
  v_color = albedo * irradiance(normal);

  // Near the eye the derivative at the middle would sweep ellipses across the picture.
  bool is_shown = function.z - RADIUS * factor * length(vec2(u.z, v.z)) >= view[0].w;
  is_shown = is_shown && all(greaterThanEqual(inside, vec3(0.0))) && all(lessThan(inside, vec3(1.0)));
  is_shown = is_shown && all(lessThan(abs(middle - 0.5 * screen.xy), 0.5 * screen.xy + max(half_size, 0.5)));
  // Points whose middles lie outside are clipped, however large: such ones begin at the picture's side.
  vec2 start = clamp(middle, vec2(0.0), screen.xy);
  vec2 reach = half_size + abs(start - middle);
  gl_PointSize = clamp(2.0 * max(reach.x, reach.y), 1.0, screen.z);
  vec2 place = start / screen.xy * 2.0 - 1.0;
  gl_Position = is_shown ? vec4(place.x, -place.y, 0.0, 1.0) : NOWHERE;
}
`,sr=`${$}
uniform vec3 screen;
// Metres at which the depth buffer ends.
uniform float nearest;
flat in vec4 v_inverse;
flat in vec2 v_middle;
flat in vec3 v_nearness;
flat in vec3 v_color;
out vec4 shade;

void main() {
  vec2 at = vec2(gl_FragCoord.x, screen.y - gl_FragCoord.y);
  vec2 p = at - v_middle;
  vec2 q = vec2(dot(v_inverse.xy, p), dot(v_inverse.zw, p));
  bool is_inside = dot(q, q) <= ${L(z)};
  // The sample that holds a splat's middle always belongs to it.
  if (!is_inside && any(notEqual(floor(at), floor(v_middle)))) {
    discard;
  }
  float nearness = v_nearness.x + (is_inside ? dot(v_nearness.yz, p) : 0.0);
  // Exact on a plane. What is nearer has more, so that float32 keeps its digits far away.
  gl_FragDepth = nearest * nearness;
  shade = vec4(v_color, 1.0);
}
`,ar=`${$}
void main() {
  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
`,ir=`${$}
uniform sampler2D samples;
// Samples along each axis of a pixel.
uniform int grid;
uniform vec3 screen;
uniform vec3 rays[3];
out vec4 shade;
${rr}
${tr}
void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * grid;
  vec3 sum = vec3(0.0);
  for (int row = 0; row < grid; row++) {
    for (int column = 0; column < grid; column++) {
      ivec2 at = first + ivec2(column, row);
      vec4 found = texelFetch(samples, at, 0);
      vec2 place = vec2(float(at.x) + 0.5, screen.y - float(at.y) - 0.5);
      vec3 ray = rays[0] + place.x * rays[1] + place.y * rays[2];
      sum += found.a > 0.0 ? found.rgb : background(normalize(ray));
    }
  }
  shade = vec4(srgb_of(sum / float(grid * grid)), 1.0);
}
`;var lr=`${$}
layout(location = 0) in vec3 position;
// Of length 0 where faces are flat.
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
// Rows of the matrix to metres from the leaf's origin, which lies at an offset from the eye.
layout(location = 4) in vec4 row_x;
layout(location = 5) in vec4 row_y;
layout(location = 6) in vec4 row_z;
uniform vec3 offset;
// The camera's gradients of X, Y and W.
uniform vec3 gradients[3];
uniform vec2 screen;
// Metres along the axis at which the depth buffer ends.
uniform float nearest;
out vec3 v_point;
out vec3 v_normal;
out vec2 v_uv;
out vec3 v_color;

void main() {
  vec4 at = vec4(position, 1.0);
  v_point = vec3(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + offset;
  // Normals go by the cofactors of the matrix, whatever its scale and handedness.
  vec3 x = cross(row_y.xyz, row_z.xyz);
  vec3 y = cross(row_z.xyz, row_x.xyz);
  vec3 z = cross(row_x.xyz, row_y.xyz);
  v_normal = vec3(dot(x, normal), dot(y, normal), dot(z, normal));
  v_uv = uv;
  v_color = color.rgb;
  vec3 shown = vec3(dot(gradients[0], v_point), dot(gradients[1], v_point), dot(gradients[2], v_point));
  vec2 place = 2.0 * shown.xy / screen - shown.z;
  gl_Position = vec4(place.x, -place.y, shown.z - 2.0 * nearest, shown.z);
}
`,ur=`${$}
uniform sampler2D image;
uniform sampler2D glow;
uniform vec4 base;
uniform vec3 emission;
// Least alpha that is drawn; below 0 where nothing is cut out.
uniform float cutoff;
uniform float unlit;
uniform float nearest;
in vec3 v_point;
in vec3 v_normal;
in vec2 v_uv;
in vec3 v_color;
out vec4 shade;
${_e}
// The face's normal towards the viewer; the vertices' one on its side.
vec3 shading_normal() {
  vec3 face = cross(dFdx(v_point), dFdy(v_point));
  float size = length(face);
  vec3 toward = -normalize(v_point);
  face = size > 0.0 ? face / size : toward;
  face = dot(face, toward) < 0.0 ? -face : face;
  float long_normal = length(v_normal);
  if (long_normal == 0.0) {
    return face;
  }
  vec3 n = v_normal / long_normal;
  return dot(n, face) < 0.0 ? -n : n;
}

// The level at which a texel is as large as a pixel, by areas.
float level_of(ivec2 size) {
  vec2 dx = dFdx(v_uv) * vec2(size);
  vec2 dy = dFdy(v_uv) * vec2(size);
  return 0.5 * log2(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-30));
}

void main() {
  vec3 normal = shading_normal();
  vec4 texel = textureLod(image, v_uv, level_of(textureSize(image, 0)));
  vec3 light = textureLod(glow, v_uv, level_of(textureSize(glow, 0))).rgb;
  if (base.a * textureLod(image, v_uv, 0.0).a < cutoff) {
    discard;
  }
  vec3 albedo = base.rgb * v_color * texel.rgb;
  shade = vec4(albedo * mix(irradiance(normal), vec3(1.0), unlit) + emission * light, 1.0);
  // As that of splats: nearest over the distance along the axis.
  gl_FragDepth = nearest * gl_FragCoord.w;
}
`;var Re=class{static{i(this,"Meshes")}#e;#t;#r;constructor(e){this.#e=e,this.#t=J(e,lr,ur),this.#r=e.createTexture(),e.bindTexture(e.TEXTURE_2D,this.#r),e.texImage2D(e.TEXTURE_2D,0,e.RGBA,1,1,0,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array([255,255,255,255])),e.texParameteri(e.TEXTURE_2D,e.TEXTURE_MIN_FILTER,e.NEAREST)}upload(e){let t=this.#e,n=t.createVertexArray();t.bindVertexArray(n);let o=[],s=i((d,c)=>{let f=t.createBuffer();o.push(f),t.bindBuffer(d,f),t.bufferData(d,c,t.STATIC_DRAW)},"fill"),a=i((d,c,f)=>{if(!c)return 0;s(t.ARRAY_BUFFER,c);let m=c instanceof Float32Array;return t.enableVertexAttribArray(d),t.vertexAttribPointer(d,f,m?t.FLOAT:t.UNSIGNED_SHORT,!m,0,0),c.byteLength},"attribute"),l=a(0,e.positions,3)+a(1,e.normals,3);l+=a(2,e.uvs,2)+a(3,e.colors,4),s(t.ARRAY_BUFFER,e.placements);for(let d=0;d<3;d++)t.enableVertexAttribArray(4+d),t.vertexAttribPointer(4+d,4,t.FLOAT,!1,48,16*d),t.vertexAttribDivisor(4+d,1);s(t.ELEMENT_ARRAY_BUFFER,e.indices),t.bindVertexArray(null);let u=[e.image,e.glow];for(let d of u)l+=d?Math.ceil(16*d.width*d.height/3):0;return{origin:e.origin,material:e.material,array:n,buffers:o,textures:u.map(d=>d?this.#n(d):null),kind:e.indices instanceof Uint16Array?t.UNSIGNED_SHORT:t.UNSIGNED_INT,corners:e.indices.length,copies:e.placements.length/12,bytes:l+e.placements.byteLength+e.indices.byteLength}}drop({array:e,buffers:t,textures:n}){this.#e.deleteVertexArray(e);for(let o of t)this.#e.deleteBuffer(o);for(let o of n)this.#e.deleteTexture(o)}draw(e,{eye:t,rows:n,width:o,height:s},a){let[l,{at:u,program:d}]=[this.#e,this.#t];l.useProgram(d),l.uniform3fv(u("gradients"),n.flat()),l.uniform2f(u("screen"),o,s),l.uniform1f(u("nearest"),a),l.uniform1i(u("image"),0),l.uniform1i(u("glow"),1);let c=0;for(let f of e){let{origin:m,material:p,textures:y,corners:b,copies:g}=f;l.uniform3f(u("offset"),m[0]-t[0],m[1]-t[1],m[2]-t[2]),l.uniform4fv(u("base"),p.color),l.uniform3fv(u("emission"),p.emission??[0,0,0]),l.uniform1f(u("cutoff"),p.cutoff??-1),l.uniform1f(u("unlit"),p.isUnlit?1:0),y.forEach((w,T)=>{l.activeTexture(l.TEXTURE0+T),l.bindTexture(l.TEXTURE_2D,w??this.#r)}),l.bindVertexArray(f.array),l.vertexAttrib3f(1,0,0,0),l.vertexAttrib4f(3,1,1,1,1),l.drawElementsInstanced(l.TRIANGLES,b,f.kind,0,g),c+=b/3*g}return l.bindVertexArray(null),{triangles:c,calls:e.length}}#n(e){let t=this.#e,n=t.createTexture();return t.bindTexture(t.TEXTURE_2D,n),t.texImage2D(t.TEXTURE_2D,0,t.SRGB8_ALPHA8,t.RGBA,t.UNSIGNED_BYTE,e),t.generateMipmap(t.TEXTURE_2D),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,t.LINEAR_MIPMAP_LINEAR),e.close(),n}};var Ae=class{constructor(e,t){this.canvas=e;this.layout=t;let n=e.getContext("webgl2",{alpha:!1,antialias:!1,depth:!1});if(!n)throw new Error("this browser has no WebGL 2");this.#e=n,this.#t=J(this.#e,or,sr),this.#r=J(this.#e,ar,ir),this.#n=new Re(this.#e),this.#a=this.#e.getParameter(this.#e.ALIASED_POINT_SIZE_RANGE)[1]??1}canvas;layout;static{i(this,"WebglDrawer")}#e;#t;#r;#n;#s=new Float32Array(4*G);#a;#o=null;#i=null;unhidden=null;upload(e,{words:t,parts:n}){let o=this.#e,[s,a]=[o.createVertexArray(),o.createBuffer()];return o.bindVertexArray(s),o.bindBuffer(o.ARRAY_BUFFER,a),o.bufferData(o.ARRAY_BUFFER,t,o.STATIC_DRAW),o.enableVertexAttribArray(0),o.vertexAttribIPointer(0,we,o.UNSIGNED_INT,0,0),o.bindVertexArray(null),{model:e,parts:n,array:s,buffer:a,bytes:t.byteLength}}drop({array:e,buffer:t}){this.#e.deleteVertexArray(e),this.#e.deleteBuffer(t)}uploadMesh(e){return this.#n.upload(e)}dropMesh(e){this.#n.drop(e)}draw(e,t,n,o){let s=this.#e,a={...n,width:n.width*o,height:n.height*o},l=ve(a),u=this.#u(a.width,a.height);s.bindFramebuffer(s.FRAMEBUFFER,u.frame),s.viewport(0,0,u.width,u.height),s.enable(s.DEPTH_TEST),s.depthFunc(s.GREATER),s.clearColor(0,0,0,0),s.clearDepth(0),s.clear(s.COLOR_BUFFER_BIT|s.DEPTH_BUFFER_BIT);let d=Me(t,e.length>0),{triangles:c,calls:f}=this.#n.draw(e,l,d);s.useProgram(this.#t.program),this.#c(this.#t,l),s.uniform1f(this.#t.at("nearest"),d);let[m,p]=[0,f];for(let y of t){let b=this.#l(y,l);m+=b.splats,p+=b.calls}return s.bindVertexArray(null),this.#d(u,l,n,o),{splats:m,triangles:c,calls:p}}get isDone(){let e=this.#e;return this.#i&&e.getSyncParameter(this.#i,e.SYNC_STATUS)!==e.SIGNALED?!1:(e.deleteSync(this.#i),this.#i=null,!0)}async finish(){this.#e.readPixels(0,0,1,1,this.#e.RGBA,this.#e.UNSIGNED_BYTE,new Uint8Array(4))}#l({layer:e,box:t},n){let o=this.#e,s=xe(e.model,n),a=Pe(e.model,this.layout,t),l=e.parts.filter(c=>Te(s,c,n.width,n.height)&&(!t||Ee(a,c)));if(l.length===0)return{splats:0,calls:0};Se(this.#s,e.model,s,a),o.uniform4fv(this.#t.at("view"),this.#s),o.bindVertexArray(e.array);let[u,d]=[0,0];for(let c=0;c<l.length;){let{first:f}=l[c],m=f;for(;l[c]?.first===m;c++)m+=l[c].count;o.drawArrays(o.POINTS,f,m-f),u+=m-f,d+=1}return{splats:u,calls:d}}#c(e,{rows:t,rays:n,width:o,height:s}){let a=this.#e;a.uniform3fv(e.at("gradients"),t.flat()),a.uniform3fv(e.at("rays"),n.flat()),a.uniform3f(e.at("screen"),o,s,this.#a)}#d(e,t,{width:n,height:o},s){let a=this.#e;a.bindFramebuffer(a.FRAMEBUFFER,null),a.viewport(0,0,n,o),a.disable(a.DEPTH_TEST),a.useProgram(this.#r.program),this.#c(this.#r,t),a.uniform1i(this.#r.at("grid"),s),a.activeTexture(a.TEXTURE0),a.bindTexture(a.TEXTURE_2D,e.color),a.uniform1i(this.#r.at("samples"),0),a.drawArrays(a.TRIANGLES,0,3),a.deleteSync(this.#i),this.#i=a.fenceSync(a.SYNC_GPU_COMMANDS_COMPLETE,0),a.flush()}#u(e,t){return(this.#o?.width!==e||this.#o.height!==t)&&(this.#o?.dispose(),this.#o=qt(this.#e,e,t)),this.#o}};var mn=["maxBufferSize","maxStorageBufferBindingSize","maxTextureDimension2D"];async function cr(r){let e=await navigator.gpu?.requestAdapter({powerPreference:"high-performance"});if(!e||e.info.isFallbackAdapter&&!r)return null;let t=Object.fromEntries(mn.map(n=>[n,e.limits[n]]));return e.requestDevice({requiredLimits:t})}i(cr,"deviceOf");var Le=class{constructor(e){this.device=e}device;static{i(this,"Arena")}#e=[];put(e){let t=Math.max(Math.ceil(e.length/64),1)*64,{page:n,gap:o}=this.#r(t)??this.#n(t),s={page:n,first:o.first,words:t,bytes:4*t};return o.first+=t,o.words-=t,o.words===0&&n.gaps.splice(n.gaps.indexOf(o),1),this.device.queue.writeBuffer(n.buffer,4*s.first,e),s}free({page:e,first:t,words:n}){let{gaps:o}=e,s=o.findIndex(l=>l.first>t),a=s<0?o.length:s;o.splice(a,0,{first:t,words:n}),this.#t(o,a),this.#t(o,a-1),o[0]?.words===e.words&&(e.buffer.destroy(),this.#e.splice(this.#e.indexOf(e),1))}#t(e,t){let[n,o]=[e[t],e[t+1]];!n||!o||n.first+n.words!==o.first||(n.words+=o.words,e.splice(t+1,1))}#r(e){for(let t of this.#e){let n=t.gaps.find(o=>o.words>=e);if(n)return{page:t,gap:n}}return null}#n(e){let{maxBufferSize:t,maxStorageBufferBindingSize:n}=this.device.limits,o=Math.floor(Math.min(t,n)/4/64)*64;if(e>o)throw new Error(`a view of ${4*e} bytes is larger than the graphics allow`);let s=Math.min(Math.max(e,16777216),o),a=GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_DST,l=this.device.createBuffer({label:"views",size:4*s,usage:a}),u={first:0,words:s},d={buffer:l,words:s,gaps:[u]};return this.#e.push(d),{page:d,gap:u}}};var[W,ee]=[64,16384],Oe=16,pn=256,te=`
struct Draw {
  // The camera's gradients of X, Y and W, and the rays through the corner, a sample to the right and one down.
  gradients: array<vec4<f32>, 3>,
  rays: array<vec4<f32>, 3>,
  // Width and height of the samples that are drawn, the picture's first row of them, samples along each axis of a pixel.
  size: vec4<u32>,
  // First part, number of them, number of the round.
  work: vec4<u32>,
  // Number of all parts, number of the page.
  all: vec4<u32>,
  // Metres at which depths end.
  nearest: f32,
}

@group(0) @binding(0) var<uniform> draw: Draw;
`,dr=`
${te}
struct Part {
  view: u32,
  // Its first word in its page, number of splats, and the number of its first one among those of all parts.
  first: u32,
  count: u32,
  number: u32,
  order: u32,
  // Columns and rows of its place in the picture, in 16 bits each: the first ones, and those after the last.
  low: u32,
  high: u32,
  page: u32,
}

@group(0) @binding(1) var<storage, read> views: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> parts: array<Part>;
// All parts, those of the first splats first.
@group(0) @binding(3) var<storage, read> listed: array<u32>;
@group(0) @binding(4) var<storage, read> words: array<u32>;
// The number of splats of parts that are seen, then the farthest order of each tile.
@group(0) @binding(5) var<storage, read_write> tiles: array<atomic<u32>>;
// Bits of the samples' depths, whose order is that of floats of at least 0; LAST less the numbers of their splats, in the
// end colours.
@group(0) @binding(6) var<storage, read_write> orders: array<atomic<u32>>;
@group(0) @binding(7) var<storage, read_write> colors: array<atomic<u32>>;
${Q}
const TILE = ${Oe}u;
const GROUP = ${W}u;
const ROW = ${ee}u;
// Splats between which a workgroup looks at those that cover much.
const TURN = 1024u;
const RADIUS = ${L(Math.sqrt(z))};
const SQUARED_RADIUS = ${L(z)};

struct Ellipse {
  middle: vec2<f32>,
  // By rows: the inverse of its axes.
  inverse: vec4<f32>,
  // 1/W at the middle, and its changes by a column and a row.
  nearness: vec3<f32>,
  // First and last columns and rows; nothing is shown if they are in the wrong order.
  low: vec2<i32>,
  high: vec2<i32>,
  normal: vec3<f32>,
  code: u32,
}

const LAST = 0x7fffffffu;
// Marks a colour.
const COLOR = 0x80000000u;

fn column_of(view: u32, n: u32) -> vec4<f32> {
  return views[view * ${G}u + n];
}

// Half of the extent of a ball along an axis: the length of the gradient of X/W.
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

  // The normal, and the depth steps by which its plane falls for each pixel.
  var normal = normal_of(word.y, column.w);
  let facing = 1.0 / max(dot(column_of(own, 6u).xyz, normal), ${L(q)});
  let u = column.xyz + dot(column_of(own, 4u).xyz, normal) * facing * step;
  let v = row.xyz - dot(column_of(own, 5u).xyz, normal) * facing * step;
  let is_surfel = ((word.z >> 24u) & 1u) == 1u;
  let factor = select(0.0, select(${L(j)}, 1.0, ((word.z >> 25u) & 1u) == 1u), is_surfel);

  var found: Ellipse;
  found.middle = middle;
  found.nearness = vec3<f32>(over, 0.0, 0.0);
  // The ellipse's axes in the picture, and the changes of nearness along them.
  let du = (u.xy - middle * u.z) * over * factor;
  let dv = (v.xy - middle * v.z) * over * factor;
  let slope = -vec2<f32>(u.z, v.z) * over * over * factor;
  var half_size = vec2<f32>(0.0);
  if is_surfel {
    // A surfel that is seen from its edge is a line: only the sample of its middle shows it.
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
  // Near the eye the derivative at the middle would sweep ellipses across the picture.
  let is_shown = function.z - RADIUS * factor * length(vec2<f32>(u.z, v.z)) >= start.w
    && all(inside >= vec3<f32>(0.0)) && all(inside < vec3<f32>(1.0));
  if !is_shown {
    found.high.x = -1;
    found.low.x = 0;
  }
  return found;
}

fn cover(own: Ellipse, at: vec2<i32>, number: u32) {
  let p = vec2<f32>(at) + 0.5 - own.middle;
  let q = vec2<f32>(dot(own.inverse.xy, p), dot(own.inverse.zw, p));
  let is_inside = dot(q, q) <= SQUARED_RADIUS;
  // The sample that holds a splat's middle always belongs to it.
  if !is_inside && any(at != vec2<i32>(floor(own.middle))) {
    return;
  }
  let nearness = own.nearness.x + select(0.0, dot(own.nearness.yz, p), is_inside);
  let order = bitcast<u32>(clamp(draw.nearest * nearness, 1e-30, 1.0));
  let sample = (u32(at.y) - draw.size.z) * draw.size.x + u32(at.x);
  if draw.work.z == 0u {
    atomicMax(&orders[sample], order);
  } else if order == atomicLoad(&orders[sample]) {
    atomicMax(&colors[sample], LAST - number);
  }
}

fn extent_of(own: Ellipse) -> vec2<u32> {
  return vec2<u32>(max(own.high - own.low + 1, vec2<i32>(0)));
}

// Of a part, the first tile and number of tiles in which it may show.
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
// Splats that cover much.
var<workgroup> large_count: atomic<u32>;
var<workgroup> large: array<u32, TURN>;

// A workgroup draws a part, if it does not lie behind what all of its tiles show.
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
      if extent.x * extent.y > ${pn}u {
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
  }
}

// Number of the part that has a splat.
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

// Light on the splats that samples show, as far as they lie in this page.
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
  // A view sees the insides of what a cell's side cuts open: normals are turned towards the viewer.
  let ray = draw.rays[0].xyz + own.middle.x * draw.rays[1].xyz + own.middle.y * draw.rays[2].xyz;
  let normal = select(own.normal, -own.normal, dot(own.normal, ray) > 0.0);
  let albedo = linear_of(vec3<f32>(vec3<u32>(own.code, own.code >> 8u, own.code >> 16u) & vec3<u32>(255u)) / 255.0);
  let bits = vec3<u32>(srgb_of(albedo * irradiance(normal)) * 1023.0 + 0.5);
  atomicStore(&colors[sample], COLOR | (bits.x << 20u) | (bits.y << 10u) | bits.z);
}

// A thread looks at all samples of a tile: there are few, and groups that wait for one another take longer.
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
`,fr=`
${te}
@group(0) @binding(1) var depths: texture_depth_2d;
@group(0) @binding(2) var<storage, read_write> orders: array<u32>;

@compute @workgroup_size(${W})
fn begin(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
  let sample = (group.y * ${ee}u + group.x) * ${W}u + lane;
  if sample >= draw.size.x * draw.size.y {
    return;
  }
  let at = vec2<u32>(sample % draw.size.x, sample / draw.size.x);
  orders[sample] = bitcast<u32>(textureLoad(depths, at, 0));
}
`,mr=`
${te}
@group(0) @binding(1) var geometry: texture_2d<f32>;
@group(0) @binding(2) var<storage, read> orders: array<u32>;
@group(0) @binding(3) var<storage, read> colors: array<u32>;
${Q}
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
`;function pr(r,e){let t=i((g,w)=>{let x=[{buffer:{hasDynamicOffset:!0}},...w].map((P,h)=>({binding:h,visibility:g,...P}));return r.createBindGroupLayout({entries:x})},"layoutOf"),{COMPUTE:n,FRAGMENT:o,VERTEX:s}=GPUShaderStage,a={buffer:{type:"read-only-storage"}},l={buffer:{type:"storage"}},u=t(s|o,[]),d=t(n,[a,a,a,a,l,l,l]),c=t(n,[{texture:{sampleType:"depth"}},l]),f=t(o,[{texture:{sampleType:"unfilterable-float"}},a,a]),m=i((g,w)=>r.createShaderModule({label:g,code:w}),"moduleOf"),p=i((g,w,T)=>r.createComputePipeline({label:T,layout:r.createPipelineLayout({bindGroupLayouts:[g]}),compute:{module:w,entryPoint:T}}),"computed"),[y,b]=[m("splats",dr),m("resolve",mr)];return{draw:u,work:d,begun:c,resolved:f,splats:p(d,y,"splats"),tiles:p(d,y,"farthest_of_tiles"),shade:p(d,y,"shade"),begin:p(c,m("begin",fr),"begin"),resolve:r.createRenderPipeline({label:"resolve",layout:r.createPipelineLayout({bindGroupLayouts:[f]}),vertex:{module:b},fragment:{module:b,targets:[{format:e}]}})}}i(pr,"kernelsOf");var hr=`
${te}
struct Mesh {
  // Place of the leaf's origin from the eye; least alpha that is drawn, below 0 where nothing is cut out.
  offset: vec4<f32>,
  base: vec4<f32>,
  // Of light, and whether it is drawn without light.
  emission: vec4<f32>,
}

@group(1) @binding(0) var<uniform> mesh: Mesh;
@group(2) @binding(0) var image: texture_2d<f32>;
@group(2) @binding(1) var glow: texture_2d<f32>;
@group(2) @binding(2) var smooth_texels: sampler;
${Q}
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
  // Of length 0 where faces are flat.
  @location(1) normal: vec3<f32>,
  @location(2) uv: vec2<f32>,
  @location(3) color: vec4<f32>,
  // Rows of the matrix to metres from the leaf's origin.
  @location(4) row_x: vec4<f32>,
  @location(5) row_y: vec4<f32>,
  @location(6) row_z: vec4<f32>,
) -> Corner {
  let at = vec4<f32>(position, 1.0);
  var out: Corner;
  out.point = vec3<f32>(dot(row_x, at), dot(row_y, at), dot(row_z, at)) + mesh.offset.xyz;
  // Normals go by the cofactors of the matrix, whatever its scale and handedness.
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
  // Depths are the nearest distance over that along the axis, as those of splats.
  out.place = vec4<f32>(
    2.0 * shown.x / f32(draw.size.x) - shown.z,
    shown.z - 2.0 * row / f32(draw.size.y),
    draw.nearest,
    shown.z,
  );
  return out;
}

// The face's normal towards the viewer; the vertices' one on its side.
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

// The level at which a texel is as large as a pixel, by areas.
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
`,yr=`
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
`;var N=class{constructor(e,t,n){this.device=e;this.label=t;this.usage=n}device;label;usage;static{i(this,"Room")}#e=null;ofSize(e){if(this.#e&&this.#e.size>=e)return this.#e;this.#e?.destroy();let t=Math.max(2**Math.ceil(Math.log2(Math.max(e,1))),256),n=this.usage|GPUBufferUsage.COPY_DST;return this.#e=this.device.createBuffer({label:this.label,size:t,usage:n}),this.#e}with(e){let t=this.ofSize(e.byteLength);return this.device.queue.writeBuffer(t,0,e),t}};var br="rgba8unorm-srgb",Ue=class{constructor(e){this.device=e;let t=e.createShaderModule({label:"levels of textures",code:yr});this.#e=e.createRenderPipeline({label:"levels of textures",layout:"auto",vertex:{module:t},fragment:{module:t,targets:[{format:br}]}}),this.#t=e.createSampler({minFilter:"linear"}),this.white=this.#r(1,1),e.queue.writeTexture({texture:this.white},new Uint8Array([255,255,255,255]),{},[1,1])}device;static{i(this,"Textures")}#e;#t;white;of(e){let{width:t,height:n}=e,o=this.#r(t,n);this.device.queue.copyExternalImageToTexture({source:e},{texture:o},[t,n]),e.close();let s=this.device.createCommandEncoder();for(let a=1;a<o.mipLevelCount;a++)this.#n(s,o,a);return this.device.queue.submit([s.finish()]),o}#r(e,t){return this.device.createTexture({label:"image",size:[e,t],format:br,mipLevelCount:1+Math.floor(Math.log2(Math.max(e,t))),usage:GPUTextureUsage.TEXTURE_BINDING|GPUTextureUsage.COPY_DST|GPUTextureUsage.RENDER_ATTACHMENT})}#n(e,t,n){let o=i(l=>t.createView({baseMipLevel:l,mipLevelCount:1}),"view"),s=e.beginRenderPass({colorAttachments:[{view:o(n),loadOp:"clear",storeOp:"store"}]});s.setPipeline(this.#e);let a=[{binding:0,resource:o(n-1)},{binding:1,resource:this.#t}];s.setBindGroup(0,this.device.createBindGroup({layout:this.#e.getBindGroupLayout(0),entries:a})),s.draw(3),s.end()}};var[re,at]=["rgba8unorm-srgb","depth32float"],hn=[{format:"float32x3",stride:12},{format:"float32x3",stride:12},{format:"float32x2",stride:8},{format:"unorm16x4",stride:8}],[yn,bn]=[0,12],Ge=class{constructor(e,t){this.device=e;this.#e=e.createShaderModule({label:"meshes",code:hr}),this.#t=e.createBindGroupLayout({entries:[{binding:0,visibility:GPUShaderStage.VERTEX|GPUShaderStage.FRAGMENT,buffer:{hasDynamicOffset:!0}}]});let n=GPUShaderStage.FRAGMENT;this.#r=e.createBindGroupLayout({entries:[{binding:0,visibility:n,texture:{}},{binding:1,visibility:n,texture:{}},{binding:2,visibility:n,sampler:{}}]}),this.#n=e.createPipelineLayout({bindGroupLayouts:[t,this.#t,this.#r]}),this.#s=new Ue(e),this.#a=e.createSampler({addressModeU:"repeat",addressModeV:"repeat",minFilter:"linear",magFilter:"linear",mipmapFilter:"linear"}),this.#o=this.#u(new Uint32Array([0,0,0,4294967295,4294967295]),GPUBufferUsage.VERTEX),this.#l=new N(e,"meshes",GPUBufferUsage.UNIFORM)}device;static{i(this,"Meshes")}#e;#t;#r;#n;#s;#a;#o;#i=new Map;#l;upload(e){let{positions:t,normals:n,uvs:o,colors:s,placements:a,indices:l}=e,u=i(y=>y&&this.#u(y,GPUBufferUsage.VERTEX),"fill"),d=[t,n,o,s,a].map(u),c=[e.image,e.glow],f=[...d,this.#u(l,GPUBufferUsage.INDEX)],m=f.reduce((y,b)=>y+(b?.size??0),0);for(let y of c)m+=y?Math.ceil(16*y.width*y.height/3):0;let p=c.map(y=>y&&this.#s.of(y));return{origin:e.origin,material:e.material,pipeline:this.#d(!0,n!==null,o!==null,s!==null),buffers:d,indices:f.at(-1),format:l instanceof Uint16Array?"uint16":"uint32",corners:l.length,copies:a.length/12,textures:p,group:this.#c(p),bytes:m}}drop({buffers:e,indices:t,textures:n}){for(let o of[...e,t,...n])o?.destroy()}record(e,t,n){let o=new Float32Array(256/4*t.length);t.forEach((l,u)=>o.set(gn(l,n),256/4*u));let s={buffer:this.#l.with(o),size:256},a=this.device.createBindGroup({layout:this.#t,entries:[{binding:0,resource:s}]});return t.reduce((l,u,d)=>(e.setPipeline(u.pipeline),e.setBindGroup(1,a,[256*d]),e.setBindGroup(2,u.group),u.buffers.forEach((c,f)=>{c?e.setVertexBuffer(f,c):e.setVertexBuffer(f,this.#o,f===3?bn:yn)}),e.setIndexBuffer(u.indices,u.format),e.drawIndexed(u.corners,u.copies),l+u.corners/3*u.copies),0)}#c(e){let n=[...e.map((o,s)=>({binding:s,resource:(o??this.#s.white).createView()})),{binding:2,resource:this.#a}];return this.device.createBindGroup({layout:this.#r,entries:n})}#d(...e){let t=e.join(),n=this.#i.get(t);if(n)return n;let o=hn.map(({format:u,stride:d},c)=>({arrayStride:e[c]?d:0,attributes:[{shaderLocation:c,offset:0,format:u}]})),s=[0,1,2].map(u=>({shaderLocation:4+u,offset:16*u,format:"float32x4"})),a={arrayStride:48,stepMode:"instance",attributes:s},l=this.device.createRenderPipeline({label:"meshes",layout:this.#n,vertex:{module:this.#e,buffers:[...o,a]},fragment:{module:this.#e,targets:[{format:re}]},depthStencil:{format:at,depthWriteEnabled:!0,depthCompare:"greater"}});return this.#i.set(t,l),l}#u(e,t){let n=4*Math.ceil(Math.max(e.byteLength,4)/4),o=this.device.createBuffer({label:"mesh",size:n,usage:t,mappedAtCreation:!0});return new Uint8Array(o.getMappedRange()).set(new Uint8Array(e.buffer,e.byteOffset,e.byteLength)),o.unmap(),o}};function gn({origin:r,material:e},t){let{color:n,cutoff:o,emission:s,isUnlit:a}=e;return[...[r[0]-t[0],r[1]-t[1],r[2]-t[2]],o??-1,...n,...s??[0,0,0],a?1:0]}i(gn,"numbersOf");var Ne=class{constructor(e,t){this.common=e;this.#e=new ArrayBuffer(256*t)}common;static{i(this,"Numbers")}#e;#t=0;get all(){return new Uint32Array(this.#e)}put(e,{first:t=0,count:n=0,round:o=0,page:s=0}){let{projector:a,grid:l,nearest:u,parts:d}=this.common,c=256*this.#t,f=new Float32Array(this.#e,c,256/4);return[...a.rows,...a.rays].forEach((m,p)=>f.set(m,4*p)),new Uint32Array(this.#e,c+96,12).set([a.width,e.rows,e.first,l,t,n,o,0,d,s,0,0]),f[36]=u,this.#t+=1,c}};var wn=1<<26;function gr(r,e,t,n){let{maxStorageBufferBindingSize:o,maxTextureDimension2D:s}=r.limits,a=Math.min(Math.min(o,wn)/(4*e),s),l=Math.max(Math.floor(a/n),1)*n;return Array.from({length:Math.ceil(t/l)},(u,d)=>({number:d,first:d*l,rows:Math.min(l,t-d*l)}))}i(gr,"bandsOf");function it(r,e){return Math.ceil(r/Oe)*Math.ceil(e/Oe)}i(it,"tilesOf");var ke=class{constructor(e){this.device=e;let t=i(n=>new N(e,n,GPUBufferUsage.STORAGE|GPUBufferUsage.COPY_SRC),"room");[this.#e,this.#t,this.#r]=[t("orders"),t("colors"),t("tiles")]}device;static{i(this,"Samples")}#e;#t;#r;#n=null;get counts(){return this.#r.ofSize(0)}buffers(e,t){let n=4*e*t,o=this.#r.ofSize(4*(1+it(e,t)));return{orders:this.#e.ofSize(n),colors:this.#t.ofSize(n),tiles:o}}textures(e,t){let n=this.#n;if(n&&n.color.width===e&&n.color.height===t)return n;n?.color.destroy(),n?.depth.destroy();let o=GPUTextureUsage.RENDER_ATTACHMENT|GPUTextureUsage.TEXTURE_BINDING,s=i(a=>this.device.createTexture({label:"samples",size:[e,t],format:a,usage:o}),"made");return this.#n={color:s(re),depth:s(at)},this.#n}};var wr=8,Ie=[1/16,1/8,1/4,1/2];function vr(r,e,t,n){let o=[],s=[],a=new Float32Array(4*G),l=0;for(let{layer:u,box:d}of r){let c=xe(u.model,e),f=Pe(u.model,t,d),m=o.length/(4*G),p=s.length;for(let y of u.parts){let b=Te(c,y,e.width,e.height);if(!b||d&&!Ee(f,y))continue;let{count:g}=y;s.push({view:m,first:u.first+we*y.first,number:l,count:g,place:b,page:u.page}),l+=g}s.length!==p&&(Se(a,u.model,c,f),o.push(...a))}return{views:new Float32Array(o),splats:l,...En(s,l,n)}}i(vr,"workOf");var[vn,xn]=(r=>[new Float32Array(r),new Uint32Array(r)])(new ArrayBuffer(4));function Tn(r){return vn[0]=r,xn[0]+(Number.isFinite(r)?1:0)}i(Tn,"orderOf");function En(r,e,t){let n=[...r].sort((d,c)=>Pn(c.place.nearness,d.place.nearness)),o=[...new Set(r.map(({page:d})=>d))],s=new Uint32Array(wr*r.length),a=new Map,l=[];for(let d of Mn(n,e)){let c=!0;for(let f of o){let m=d.filter(p=>p.page===f);if(m.length!==0){l.push({page:f,begins:c,first:a.size,count:m.length}),c=!1;for(let p of m)s.set(Sn(p,o.indexOf(f),t),wr*a.size),a.set(p,a.size)}}}let u=new Uint32Array(r.map(d=>a.get(d)));return{parts:s,listed:u,pages:o,calls:l}}i(En,"sharedOut");function Pn(r,e){return+(r>e)-+(r<e)}i(Pn,"compared");function Sn({view:r,first:e,number:t,count:n,place:o},s,a){let{low:l,high:u,nearness:d}=o,c=Tn(a*d);return[r,e,n,t,c,l[0]|l[1]<<16,u[0]|u[1]<<16,s]}i(Sn,"numbersOf");function Mn(r,e){let t=[],[n,o,s]=[[],0,0];for(let a of r)if(n.push(a),o+=a.count,!(s>=Ie.length||o<e*Ie[s])){for(;s<Ie.length&&o>=e*Ie[s];)s+=1;t.push(n),n=[]}return n.length>0&&t.push(n),t}i(Mn,"batchesOf");var ze=class{constructor(e,t,n,o){this.layout=t;this.device=n;let s=e.getContext("webgpu");if(!s)throw new Error("this browser has no WebGPU for pictures");this.#e=s;let a=navigator.gpu.getPreferredCanvasFormat();s.configure({device:n,format:a,alphaMode:"opaque"}),this.#t=pr(n,a),this.#r=new Le(n),this.#n=new Ge(n,this.#t.draw),this.#s=new ke(n),this.#a=new N(n,"calls",GPUBufferUsage.UNIFORM);let l=i(u=>new N(n,u,GPUBufferUsage.STORAGE),"room");[this.#o,this.#i,this.#l]=[l("views"),l("parts"),l("listed")],this.#c=n.createTexture({size:[1,1],format:re,usage:GPUTextureUsage.TEXTURE_BINDING}),n.lost.then(({message:u,reason:d})=>d!=="destroyed"&&o(`the graphics are gone: ${u}`)),n.onuncapturederror=({error:u})=>o(`the graphics cannot go on: ${u.message}`)}layout;device;static{i(this,"WebgpuDrawer")}#e;#t;#r;#n;#s;#a;#o;#i;#l;#c;#d=Promise.resolve();#u=0;unhidden=null;upload(e,{words:t,parts:n}){let o=this.#r.put(t);return{model:e,parts:n,page:o.page,first:o.first,place:o,bytes:o.bytes}}drop({place:e}){this.#r.free(e)}uploadMesh(e){return this.#n.upload(e)}dropMesh(e){this.#n.drop(e)}draw(e,t,n,o){let s=ve({...n,width:n.width*o,height:n.height*o}),a=Me(t,e.length>0),l=vr(t,s,this.layout,a),u=gr(this.device,s.width,s.height,o),d=u.length*(1+4*l.calls.length+l.pages.length),c={meshes:e,projector:s,grid:o,rows:u[0]?.rows??0,work:l,numbers:new Ne({projector:s,grid:o,nearest:a,parts:l.listed.length},d),bound:{buffer:this.#a.ofSize(256*d),size:256},views:this.#o.with(l.views),parts:this.#i.with(l.parts),listed:this.#l.with(l.listed),target:this.#e.getCurrentTexture().createView()},f=this.device.createCommandEncoder(),m=0;for(let y of u)m=this.#p(f,c,y);this.#a.with(c.numbers.all),this.#b(f,u);let p=2*l.calls.length+l.pages.length+e.length;return{splats:l.splats,triangles:m,calls:u.length*p}}get isDone(){return this.#u===0}finish(){return this.#d}#p(e,t,n){let{meshes:o,projector:s}=t,a=4*s.width*n.rows,{orders:l,colors:u,tiles:d}=this.#s.buffers(s.width,n.rows),{color:c,depth:f}=o.length>0?this.#s.textures(s.width,t.rows):{color:this.#c,depth:null};n.number===0&&e.clearBuffer(d,0,4),e.clearBuffer(u,0,a);let m=t.numbers.put(n,{}),p=0;if(f){p=this.#h(e,t,n,m,{color:c,depth:f});let b=this.#m(this.#t.begun,[t.bound,f.createView(),{buffer:l}]),g=e.beginComputePass({label:"begin"});g.setPipeline(this.#t.begin),g.setBindGroup(0,b,[m]),xr(g,Math.ceil(s.width*n.rows/W)),g.end()}else e.clearBuffer(l,0,a);this.#f(e,t,n,[{buffer:d},{buffer:l},{buffer:u}]);let y=[t.bound,c.createView(),{buffer:l},{buffer:u}];return this.#y(e,t,n,m,this.#m(this.#t.resolved,y)),p}#h(e,{meshes:t,projector:n,bound:o},{rows:s},a,{color:l,depth:u}){let d=e.beginRenderPass({label:"meshes",colorAttachments:[{view:l.createView(),loadOp:"clear",storeOp:"store"}],depthStencilAttachment:{view:u.createView(),depthClearValue:0,depthLoadOp:"clear",depthStoreOp:"store"}});d.setViewport(0,0,n.width,s,0,1),d.setBindGroup(0,this.#m(this.#t.draw,[o]),[a]);let c=this.#n.record(d,t,n.eye);return d.end(),c}#f(e,{projector:t,work:n,numbers:o,bound:s,views:a,parts:l,listed:u},d,c){let f=new Map;for(let x of n.pages){let P=[a,l,u,x.buffer].map(h=>({buffer:h}));f.set(x,this.#m(this.#t.work,[s,...P,...c]))}let m=e.beginComputePass({label:"splats"}),p=i((x,P,h,v)=>{m.setPipeline(x),m.setBindGroup(0,f.get(P),[o.put(d,v)]),xr(m,h)},"call"),{splats:y,tiles:b,shade:g}=this.#t,w=Math.ceil(it(t.width,d.rows)/W);for(let x of[0,1])for(let[P,h]of n.calls.entries())h.begins&&(x===0||P===0)&&p(b,h.page,w,{}),p(y,h.page,h.count,{first:h.first,count:h.count,round:x});let T=Math.ceil(t.width*d.rows/W);for(let[x,P]of n.pages.entries())p(g,P,T,{page:x});m.end()}#y(e,{projector:t,grid:n,target:o},{number:s,first:a,rows:l},u,d){let c=s===0?"clear":"load",f=e.beginRenderPass({label:"show",colorAttachments:[{view:o,loadOp:c,storeOp:"store"}]});f.setPipeline(this.#t.resolve),f.setBindGroup(0,d,[u]),f.setScissorRect(0,a/n,t.width/n,l/n),f.draw(3),f.end()}#b(e,t){let n=this.device.createBuffer({size:4,usage:GPUBufferUsage.MAP_READ|GPUBufferUsage.COPY_DST});t.length>0&&e.copyBufferToBuffer(this.#s.counts,0,n,0,4),this.device.queue.submit([e.finish()]),this.#u+=1;let o=i(()=>{this.unhidden=new Uint32Array(n.getMappedRange())[0]??0,n.destroy()},"read");this.#d=n.mapAsync(GPUMapMode.READ).then(o,()=>{}).finally(()=>this.#u-=1)}#m(e,t){let n=t.map((o,s)=>({binding:s,resource:o}));return this.device.createBindGroup({layout:e,entries:n})}};function xr(r,e){r.dispatchWorkgroups(Math.min(e,ee),Math.ceil(e/ee))}i(xr,"dispatch");var ne=class{constructor(e,t){this.drop=e;this.most=t}drop;most;static{i(this,"Resident")}#e=new Map;#t=new Map;#r=0;bytes=0;get count(){return this.#e.size}add(e,t,n,o){let s=`${R(e,t)}/${n}`;this.#n(s);let a=o.reduce((l,u)=>l+u.bytes,0);this.#e.set(s,{level:e,place:t,direction:n,layers:o,bytes:a,used:this.#r}),this.#t.set(R(e,t),[...this.there(e,t),n]),this.bytes+=a}there(e,t){return this.#t.get(R(e,t))??[]}begin(){this.#r+=1}use(e,t,n){let o=`${R(e,t)}/${n}`,s=this.#e.get(o);return s?(s.used!==this.#r&&(s.used=this.#r,this.#e.delete(o),this.#e.set(o,s)),s.layers):[]}trim(e){for(let[t,n]of this.#e){if(this.bytes<=this.most)break;n.used===this.#r||e(n.level,n.place)||this.#n(t)}}#n(e){let t=this.#e.get(e);if(!t)return;let{level:n,place:o,direction:s,layers:a,bytes:l}=t;a.forEach(c=>this.drop(c)),this.#e.delete(e),this.bytes-=l;let u=R(n,o),d=this.there(n,o).filter(c=>c!==s);d.length>0?this.#t.set(u,d):this.#t.delete(u)}};function lt(r,e,t){let n=new ne(s=>e.drop(s),t),o=new ne(s=>e.dropMesh(s),t/4);return{addView(s,a,l,u){let d=Xt(r,s,a,l);n.add(s,a,l,u.map(c=>e.upload(d,c)))},addLeaf(s,a){o.add(0,s,U,a.map(l=>e.uploadMesh(l)))},there:i((s,a)=>n.there(s,a),"there"),hasLeaf:i(s=>o.there(0,s).length>0,"hasLeaf"),draw({near:s,shown:a},l,u,d){n.begin(),o.begin();let c=s.flatMap(p=>o.use(0,p,U)),f=a.flatMap(({level:p,place:y,direction:b,box:g})=>n.use(p,y,b).map(w=>({layer:w,box:g}))),m=e.draw(c,f,l,u);return n.trim((p,y)=>d.cells.has(R(p,y))),o.trim((p,y)=>d.leaves.has(R(p,y))),m},get bytes(){return n.bytes+o.bytes},get views(){return n.count},get isDone(){return e.isDone},finish:i(()=>e.finish(),"finish"),get unhidden(){return e.unhidden}}}i(lt,"stockOf");async function Tr(r,e,{graphics:t,bytes:n,failed:o}){let s=t==="webgl"?null:await cr(t==="webgpu");if(s){let a=new ze(r,e,s,o);return{stock:lt(e,a,n),graphics:"webgpu"}}if(t==="webgpu")throw new Error("this browser has no WebGPU");return{stock:lt(e,new Ae(r,e),n),graphics:"webgl"}}i(Tr,"startStock");var _n=6,Rn=/^nearfar\/generations\/\d+\//,[An,Ln]=[50,.5],On={views:0,standIns:0,waiting:0,holes:0,splats:0,unhidden:null,leaves:0,triangles:0,calls:0,bytes:0,kept:0,isComplete:!1,graphics:null},Ce=class{constructor(e,t){this.canvas=e;this.#e=t,this.#t=new Worker(t.scripts.cutter,{type:"module"}),this.#t.onmessage=({data:n})=>this.#M(n),this.#t.onerror=({message:n})=>t.failed({kind:"other",message:`a worker stopped: ${n}`},!0),this.#r=new ge({atOnce:_n*t.workers,send:i((n,o)=>this.#i?.read(n,o),"send"),cancel:i(n=>this.#i?.cancel(n),"cancel"),failed:i(n=>t.failed(n,!1),"failed"),recovered:t.recovered,now:i(()=>performance.now()/1e3,"now")}),this.#g({kind:"open",base:t.base.href})}canvas;static{i(this,"Viewer")}#e;#t;#r;#n=new Map;#s=new Map;#a=new Set;#o=null;#i=null;#l=null;#c=null;#d=null;#u=!1;#p=!1;#h=!0;#f=!0;#y=0;#b=0;#m=!1;facts=On;frame(e){if(!this.#o||((!this.#d||!Un(this.#d,e))&&(this.#d=e,this.#p=this.#h=!0),this.#p&&!this.#u&&this.#S(e),this.#r.fill(),!this.#l||!this.#P(this.#o.stock)))return!1;let t=performance.now()-this.#b>=Math.max(An,this.took/Ln-this.took);return this.#h||this.#f&&(t||this.#r.waiting===0)?(this.#T(e),!0):!1}get took(){return Math.max(this.#b-this.#y,0)}async time(){if(!this.#d||!this.#o)return 0;let{stock:e}=this.#o;e.isDone||await e.finish(),this.#T(this.#d);let t=this.#y;return await e.finish(),performance.now()-t}#P(e){return this.#m?e.isDone?(this.#b=performance.now(),this.#m=!1,this.facts={...this.facts,unhidden:e.unhidden},!0):!1:!0}retry(){this.#a.clear(),this.#r.retry(),this.#g({kind:"retry"})}#S(e){let{views:t,error:n,geometry:o,lift:s}=this.#e,a={views:t,error:n,isAround:!1,geometry:o,lift:s};[this.#u,this.#p]=[!0,!1],this.#g({kind:"look",camera:e,settings:a})}#M(e){switch(e.kind){case"opened":this.#_(e.layout,e.shards,e.geometry);break;case"learned":this.#o?.cells.add(e.subtree),this.#w(e.subtree.shards,e.subtree.geometry);break;case"base":this.#c=e.cut;break;case"cut":this.#l=e.cut,this.#u=!1,this.#f=!0,this.#E();break;case"received":this.#e.received(e.bytes);break;case"failed":this.#e.failed(e.failure,e.isFatal)}}async#_(e,t,n){let{scripts:o,workers:s,base:a,bytes:l}=this.#e,u=await this.#R(e,l);u&&(this.#o={cells:new be(e),...u},this.#w(t,n),this.#i=Vt(o.reader,s,a,e,{view:i((d,c)=>{let f=this.#r.done(d);f&&this.#o?.stock.addView(f.level,f.place,f.direction,c),this.#f=!0,this.#r.fill()},"view"),leaf:i((d,c)=>{let f=this.#r.done(d);f&&this.#o?.stock.addLeaf(f.place,c),this.#f=!0,this.#r.fill()},"leaf"),failed:i((d,c)=>{let f=this.#r.failed(d,c);f?.direction===U&&(this.#a.add(R(0,f.place)),this.#f=!0,this.#E())},"failed"),cancelled:i(d=>this.#r.cancelled(d),"cancelled"),received:this.#e.received}),this.#e.opened(e))}async#R(e,t){let n=i(o=>this.#e.failed({kind:"other",message:o},!0),"failed");try{return await Tr(this.canvas,e,{graphics:this.#e.graphics,bytes:t,failed:n})}catch(o){return n(o instanceof Error?o.message:String(o)),null}}#w(e,t){for(let n of e)this.#n.set(n[0],n);for(let n of t){let o=n[0].replace(Rn,"");this.#s.has(o)||this.#s.set(o,n)}}#v(e){let{cells:t,stock:n}=this.#o;return Yt(e,t,i((s,a)=>n.there(s,a),"there"),this.#e.views,s=>this.#A(s))}#A(e){let{cells:t,stock:n}=this.#o;if(this.#a.has(R(0,e)))return"never";if(n.hasLeaf(e))return"there";let{tier:o,place:s}=H(t.layout,0,e);return t.knows(o,s)&&this.#x(e).length===0?"there":"coming"}#x(e){let{layout:t}=this.#o.cells;return Ft(t,e).map(o=>this.#s.get(o)).filter(o=>o!==void 0&&o[1]>0)}#T(e){if(!this.#o||!this.#l)return;let{cells:t,stock:n,graphics:o}=this.#o;this.#h=this.#f=!1,this.#y=performance.now(),this.#m=!0;let s=this.#v(this.#l),a=this.#l.leaves.flatMap(({place:c})=>[c,...t.guestsOf(c)]),l=n.draw(s,e,this.#e.grid,{cells:new Set(this.#c?.cells.map(({level:c,place:f})=>R(c,f))),leaves:new Set(a.map(c=>R(0,c)))}),[{waiting:u},d]=[this.#r,!this.#u&&!this.#p];this.facts={views:s.shown.length,standIns:s.shown.filter(({box:c})=>c!==null).length,waiting:u,holes:s.holes,...l,unhidden:null,leaves:s.near.length,bytes:n.bytes,kept:n.views,isComplete:d&&u===0&&this.#l.unknown.length===0,graphics:o}}#E(){let e=new Map,t=i(n=>this.#c&&{...this.#c,cells:this.#c.cells.filter(o=>o.isInPicture===n)},"coarse");for(let n of[t(!0),this.#l,t(!1)]){if(!n)continue;let{coming:o,missing:s}=this.#v(n),a=o.map(l=>({level:0,place:l,direction:U}));for(let{level:l,place:u,direction:d}of[...a,...s]){let c=`${R(l,u)}/${d}`;e.has(c)||e.set(c,this.#L(l,u,d))}}this.#r.want(e)}#L(e,t,n){let{cells:o}=this.#o;if(n===U)return{level:e,place:t,direction:n,generation:0,shards:this.#x(t)};let s=o.at(e,t)?.generation??0,a=Ht(o.layout).map(l=>{let u=Bt(o.layout,e,n,l);return this.#n.get(Ct(s)+Dt(o.layout,e,t,u))});return{level:e,place:t,direction:n,generation:s,shards:a.filter(l=>l!==void 0)}}#g(e){this.#t.postMessage(e)}};function Un(r,e){let t=i(({position:o,right:s,up:a,fov:l,width:u,height:d})=>[...o,...s,...a,...Object.values(l),u,d],"numbers"),n=t(e);return t(r).every((o,s)=>o===n[s])}i(Un,"isSame");var Gn=Math.PI/3,Nn=1.5,[Er,kn]=[.25,.5],Pr=1<<29;function In(){let r=new URLSearchParams(location.search),[e,t]=[Sr("canvas",HTMLCanvasElement),Sr("#ui",HTMLElement)],n=Math.min(screen.width,screen.height)<600,o=ft(),s=i(({kind:v,message:E})=>{let{title:M,text:_}=Mr[v];Ye(M,_,{detail:E,retry:i(()=>location.reload(),"retry")})},"fatal"),a=[],l=i(v=>{a=v,yt(a.map(({message:E})=>E),b)},"show"),u=new Ce(e,{base:Dn(new URL(r.get("store")??".",location.href)),scripts:{cutter:new URL("orthoview-cut.js",import.meta.url),reader:new URL("orthoview-read.js",import.meta.url)},views:oe(r,"views",3,1,8),error:oe(r,"error",1,.1,64),geometry:r.get("geometry")!=="0",lift:oe(r,"lift",0,0,90),grid:Math.round(Math.sqrt(oe(r,"samples",1,1,16))),graphics:Bn(r.get("graphics")),bytes:oe(r,"megabytes",(n?Pr/4:Pr)>>20,1,16384)*2**20,workers:Math.min(Math.max((navigator.hardwareConcurrency||2)-1,1),4),received:o.receive,opened:y,failed(v,E){if(E){s(v);return}let M=I(v)?{...v,message:`${v.message}; ${zn}`}:v;a.some(({kind:A,message:k})=>I(M)?A===M.kind:k===M.message)||l([...a,M])},recovered:i(()=>l(a.filter(v=>!I(v))),"recovered")}),[d,c]=[0,{position:[0,0,0],yaw:0,pitch:0}],f=We(location.hash),m=At(e,f??c,()=>d,xt(t).show),p=It(t,()=>m.setPose(c));window.addEventListener("hashchange",()=>m.setPose(We(location.hash)??m.pose)),e.addEventListener("webglcontextlost",()=>s({kind:"other",message:Cn}));function y(v){d=v.origin[1],c=Lt(v),f||m.setPose(c),P=!0}i(y,"opened");function b(){l([]),u.retry()}i(b,"retry");let[g,w,T]=[performance.now(),Er,0],[x,P]=["",!1];window.orthoview={get facts(){return u.facts},get pose(){return m.pose},get received(){return o.read().received},setPose:m.setPose,time:i(()=>u.time(),"time")};function h(v){let E=Math.max(v-g,0)/1e3;g=v;let M=m.update(E),_=Math.min(window.devicePixelRatio||1,Nn),[A,k]=[e.clientWidth,e.clientHeight].map(Be=>Math.max(Math.round(Be*_),1));if((e.width!==A||e.height!==k)&&([e.width,e.height]=[A,k]),u.frame(Ot(M,Gn,e.width,e.height)),w+=E,T+=E,w>=Er){w=0;let{received:Be,rate:_r}=o.read();p.update({facts:u.facts,frame:u.took,received:Be,rate:_r,height:M.position[1]-d,power:m.power})}let C=dt(M);P&&T>=kn&&C!==x&&([T,x]=[0,C],history.replaceState(null,"",C)),requestAnimationFrame(h)}i(h,"frame"),requestAnimationFrame(h)}i(In,"main");var zn="what has come stays, and the rest is asked for again",Cn="The browser has taken the graphics away.",Mr={gone:{title:"There is no tree at this address",text:"The page shows the store of orthoviews in whose folder it lies, or the one that ?store= names."},refused:{title:"The server refuses the tree",text:"Tell whoever runs the server what stands below."},unreachable:{title:"The tree cannot be reached",text:"Check the connection and the address, and try again."},damaged:{title:"The tree is damaged",text:"A file is not what the build has written. Check it with nearfar orthoview verify."},newer:{title:"The tree needs a newer nearfar",text:"It was written in a later format than this page reads."},other:{title:"The tree cannot be shown",text:"Reload the page. If that does not help, tell whoever sent you here what stands below."}};function Bn(r){return r==="webgl"||r==="webgpu"?r:null}i(Bn,"graphicsOf");function Dn(r){return r.pathname.endsWith("/")||(r.pathname+="/"),r.hash="",r}i(Dn,"folderOf");function oe(r,e,t,n,o){let s=r.get(e),a=s===null||s===""?t:Number(s);return Number.isFinite(a)?Math.min(Math.max(a,n),o):t}i(oe,"number");function Sr(r,e){let t=document.querySelector(r);if(!(t instanceof e))throw new Error(`the page has no ${r}`);return t}i(Sr,"element");try{In()}catch(r){let{title:e,text:t}=Mr.other;Ye(e,t,{detail:r instanceof Error?r.message:String(r)})}
