var It=Object.defineProperty;var i=(t,e)=>It(t,"name",{value:e,configurable:!0});function C(t,e,r){return Math.min(Math.max(t,e),r)}i(C,"bounded");function ce(t){return t-2*Math.PI*Math.round(t/(2*Math.PI))}i(ce,"wrapped");function Le({yaw:t,pitch:e}){return[-Math.sin(t)*Math.cos(e),Math.sin(e),-Math.cos(t)*Math.cos(e)]}i(Le,"ahead");function Oe(t){return[Math.cos(t),0,-Math.sin(t)]}i(Oe,"rightOf");function $(t,e,r){return[t[0]+r*e[0],t[1]+r*e[1],t[2]+r*e[2]]}i($,"moved");var Dt=512,Ut=3e7,zt=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;function W(t){if(t.length>Dt)return null;let e=new URLSearchParams(t.replace(/^#/,"")),[r,o,n,...s]=(e.get("p")??"").split(",").map(de);if(!ue(r)||!ue(o)||!ue(n)||s.length>0)return null;let[a,l]=[de(e.get("yaw")??"0"),de(e.get("pitch")??"0")];return a===null||l===null?null:{position:[r,o,n],yaw:ce(a),pitch:C(l,-1.5,1.5)}}i(W,"readLink");function Ne({position:t,yaw:e,pitch:r}){return`#p=${t.map(n=>he(n,3)).join(",")}&yaw=${he(ce(e),4)}&pitch=${he(r,4)}`}i(Ne,"writeLink");function de(t){let e=zt.test(t)?Number(t):Number.NaN;return Number.isFinite(e)?e:null}i(de,"numberIn");function ue(t){return t!=null&&Math.abs(t)<=Ut}i(ue,"isPlace");function he(t,e){return String(Number(t.toFixed(e)))}i(he,"rounded");function Fe(t=()=>performance.now()/1e3){let e=0,r=[],o=[];return{receive(n){e+=n,r.push({time:t(),bytes:n})},frame(n){o.push(n);let s=o.reduce((a,l)=>a+l,0);for(;o.length>1&&s>1;)s-=o.shift()??0},restart(){e=0,r=[],o=[]},read(){let n=t()-1;r=r.filter(({time:l})=>l>n);let s=r.reduce((l,c)=>l+c.bytes,0),a=o.reduce((l,c)=>l+c,0)/Math.max(o.length,1);return{received:e,rate:s>0?8*s/1:null,frame:1e3*a,longest:1e3*Math.max(0,...o)}}}}i(Fe,"createMeter");function g(t,e={},...r){let o=document.createElement(t);return me(o,e),o.append(...r),o}i(g,"make");var Ce="http://www.w3.org/2000/svg";function B(t){let e=document.createElementNS(Ce,"svg");me(e,{viewBox:"0 0 24 24",class:"icon","aria-hidden":"true",focusable:"false"});let r=document.createElementNS(Ce,"path");return me(r,{d:t}),e.append(r),e}i(B,"icon");function Ie(t,e){t.textContent!==e&&(t.textContent=e)}i(Ie,"write");function me(t,e){for(let[r,o]of Object.entries(e))o!==void 0&&o!==!1&&t.setAttribute(r,o===!0?"":o)}i(me,"setAll");var G={walk:"M13 4.5a1.5 1.5 0 1 0 0-.01M9.5 21l2-5.5-2-3 1-4.5 3 .5 2 3 2.5 1M7 12.5l.5-3 3-1.5M12.5 13l2.5 3.5.5 4.5",orbit:"M12 14a2 2 0 1 0 0-4 2 2 0 0 0 0 4M17 8c2.5.8 4 2.2 4 4 0 2.8-4 5-9 5s-9-2.2-9-5 4-5 9-5M9.5 4L13 7l-3.5 3",split:"M12 3v18M4 6h5M4 6v12h5M20 6h-5M20 6v12h-5",photo:"M4 8h3.5L9 5.5h6L16.5 8H20v11H4zM12 16.5a3.25 3.25 0 1 0 0-6.5 3.25 3.25 0 0 0 0 6.5",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",home:"M4 11.5L12 5l8 6.5M6 10v9h4v-5h4v5h4v-9",next:"M12 21c-4-4.6-6-7.9-6-10.5a6 6 0 0 1 12 0C18 13.1 16 16.4 12 21M10 8.5l2.5 2-2.5 2",panel:"M4 5h16v14H4zM7 9h6M7 12h10M7 15h8",help:"M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.5v.01M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18",headset:"M3 8.5h18v8h-5.5L13.5 14h-3l-2 2.5H3zM7.5 12v.01M16.5 12v.01",close:"M6 6l12 12M18 6L6 18",grip:"M9 7l-5 5 5 5M15 7l5 5-5 5"};var fe=3;function pe(t,e,{detail:r,retry:o}={}){let n=g("h1",{tabindex:"-1",id:"message-title"},t),s=g("div",{class:"fatal-card"},g("p",{class:"fatal-brand"},"nearfar"),n);s.append(g("p",{},e)),r&&s.append(g("p",{class:"fatal-detail"},r)),o&&s.append(ze("Try again","button-main",o));let a=be();a.replaceChildren(s),a.dataset.kind="fatal";for(let l of document.querySelectorAll("canvas, [data-behind]"))l.setAttribute("inert","");n.focus({preventScroll:!0})}i(pe,"showFatal");function Ue(t,e){let r=be();if(r.dataset.kind==="fatal")return;let o=g("ul",{},...t.slice(0,fe).map(a=>g("li",{},a)));t.length>fe&&o.append(g("li",{},`and ${t.length-fe} more`));let n=g("button",{type:"button",class:"button-icon","aria-label":"Dismiss",title:"Dismiss"});n.append(B(G.close)),n.addEventListener("click",De);let s=g("div",{class:"banner-text"},g("strong",{},"Not all of the scene is shown"),o);t.length===0?De():(r.replaceChildren(s,ze("Try again","button-main",e),n),r.dataset.kind="banner")}i(Ue,"showProblems");function De(){let t=be();t.replaceChildren(),delete t.dataset.kind;for(let e of document.querySelectorAll("canvas, [data-behind]"))e.removeAttribute("inert")}i(De,"clearMessage");function ze(t,e,r){let o=g("button",{type:"button",class:e},t);return o.addEventListener("click",r),o}i(ze,"button");function be(){let t=document.getElementById("message");if(t)return t;let e=g("div",{id:"message",role:"alert"});return document.body.append(e),e}i(be,"message");var O={right:0,ahead:0,turn:0,look:0,isHasty:!1};function V(...t){let e=i(a=>t.reduce((l,c)=>l+a(c),0),"sum"),[r,o]=K(e(a=>a.right),e(a=>a.ahead)),[n,s]=K(e(a=>a.turn),e(a=>a.look));return{right:r,ahead:o,turn:n,look:s,isHasty:t.some(a=>a.isHasty)}}i(V,"together");function K(t,e){let r=Math.max(Math.hypot(t,e),1);return[t/r,e/r]}i(K,"within");function U(t,e,r){let o=Math.hypot(t,e);if(!(o>r))return[0,0];let n=Math.min((o-r)/(1-r),1)/o;return[t*n,e*n]}i(U,"beyondRest");var[Ht,$t,Wt]=[300,400,16];function He(t){let e=new Map,r=null,o=i((n,s)=>Math.hypot(n.clientX-s.clientX,n.clientY-s.clientY)<=Wt,"isNear");return{down(n){e.size>0&&(r=null),e.set(n.pointerId,n)},up(n){let s=e.get(n.pointerId),a=e.size===1;if(e.delete(n.pointerId),!(s&&a&&n.timeStamp-s.timeStamp<=Ht&&o(s,n))){r=null;return}let c=r!==null&&n.timeStamp-r.timeStamp<=$t&&o(r,n);r=c?null:n,c&&t(n)}}}i(He,"createTaps");var[q,$e]=[1.6,Math.PI],ye=1.5,Bt=.0015,Gt=[1,16,400],j=56,Kt=.12;function We(t,e){let r=new Map,o=new AbortController,n=O,s=He(h),a=!1,l=i(()=>1/Math.max(t.clientHeight,1),"scale"),c=i(()=>t.ownerDocument.pointerLockElement===t,"isLocked");function h({clientX:p,clientY:v}){let{left:E,top:S,width:k,height:R}=t.getBoundingClientRect();c()?e.go(.5,.5):e.go((p-E)/Math.max(k,1),(v-S)/Math.max(R,1))}i(h,"go");function u(p){if(c())return;a=p.pointerType==="touch";let v=p.pointerType==="mouse",E=p.button===0&&!p.shiftKey;if(e.mode()==="walk"&&v&&!E)return;t.setPointerCapture(p.pointerId),a&&s.down(p);let S=d(p)?"step":E?"turn":"pan";r.set(p.pointerId,{x:p.clientX,y:p.clientY,task:S}),S==="step"&&f({x:p.clientX,y:p.clientY},p)}i(u,"down");function d({pointerType:p,clientX:v}){if(e.mode()!=="walk"||p!=="touch"||[...r.values()].some(({task:k})=>k==="step"))return!1;let{left:E,width:S}=t.getBoundingClientRect();return v-E<S/2}i(d,"isThumb");function m(p){let v=r.get(p.pointerId);if(!v){c()&&e.look(-p.movementX*q*l(),-p.movementY*q*l());return}if(v.task==="step"){f(v,p);return}let E={...v,x:p.clientX,y:p.clientY},S=[...r].find(([A,{task:D}])=>A!==p.pointerId&&D!=="step")?.[1],[k,R]=[(E.x-v.x)*l(),(E.y-v.y)*l()];r.set(p.pointerId,E),e.mode()==="walk"?e.look(k*q,R*q):S?b(v,E,S):v.task==="pan"?e.pan(-k*ye,R*ye):e.rotate(-k*$e,-R*$e)}i(m,"move");function f({x:p,y:v},{clientX:E,clientY:S}){let[k,R]=U((E-p)/j,(S-v)/j,Kt);n={...O,right:k,ahead:0-R},e.thumb({x:p,y:v,right:E-p,down:S-v})}i(f,"step");function b(p,v,E){let[S,k]=[p,v].map(({x:A,y:D})=>Math.hypot(A-E.x,D-E.y));S&&k&&e.zoom(S/k);let R=.5*ye*l();e.pan(-(v.x-p.x)*R,(v.y-p.y)*R)}i(b,"pinch");function y(p){p.pointerType==="touch"&&s.up(p),r.get(p.pointerId)?.task==="step"&&w(),r.delete(p.pointerId)}i(y,"up");function w(){n=O,e.thumb(null)}i(w,"rest");function M(p){e.mode()==="orbit"&&(p.preventDefault(),e.zoom(Math.exp(Bt*p.deltaY*(Gt[p.deltaMode]??1)*(p.ctrlKey?6:1))))}i(M,"wheel");function _(){e.mode()==="walk"&&Promise.resolve(t.requestPointerLock()).catch(()=>{})}i(_,"lock");let{signal:x}=o;t.addEventListener("pointerdown",u,{signal:x}),t.addEventListener("pointermove",m,{signal:x}),t.addEventListener("pointerup",y,{signal:x}),t.addEventListener("pointercancel",y,{signal:x}),t.addEventListener("dblclick",p=>a||h(p),{signal:x}),t.addEventListener("wheel",M,{signal:x,passive:!1}),t.addEventListener("contextmenu",p=>p.preventDefault(),{signal:x});function T(){r.clear(),w(),c()&&t.ownerDocument.exitPointerLock()}return i(T,"release"),{get drive(){return n},lock:_,release:T,dispose(){T(),o.abort()}}}i(We,"createPointers");function Be(t){let e=g("div",{class:"thumb",hidden:!0,"aria-hidden":"true"},g("span",{}));return t.append(e),{show(r){if(e.hidden=r===null,!r)return;let{x:o,y:n,right:s,down:a}=r,l=Math.min(1,j/Math.max(Math.hypot(s,a),1)),c={"--x":o,"--y":n,"--right":s*l,"--down":a*l};for(let[h,u]of Object.entries(c))e.style.setProperty(h,`${u}px`)},dispose:i(()=>e.remove(),"dispose")}}i(Be,"createThumbMark");var Ge=.18,Vt=[4,10];function Ke(t){let e=t.filter(r=>r!==null&&r.connected&&r.mapping==="standard");return e.length===0?O:V(...e.map(r=>r?qt(r):O))}i(Ke,"readPads");function qt({axes:t,buttons:e}){let[r,o]=U(t[0]??0,t[1]??0,Ge),[n,s]=U(t[2]??0,t[3]??0,Ge),a=Vt.some(l=>e[l]?.pressed??!1);return{right:r,ahead:0-o,turn:0-n,look:0-s,isHasty:a}}i(qt,"wishOf");var Ve={KeyW:[0,1,0,0],KeyS:[0,-1,0,0],KeyA:[-1,0,0,0],KeyD:[1,0,0,0],ArrowUp:[0,1,0,0],ArrowDown:[0,-1,0,0],ArrowLeft:[0,0,1,0],ArrowRight:[0,0,-1,0],PageUp:[0,0,0,1],PageDown:[0,0,0,-1]};function jt(t){return Object.hasOwn(Ve,t)}i(jt,"isMoving");function we(t){if(t.defaultPrevented||t.ctrlKey||t.metaKey||t.altKey)return!0;let{target:e}=t;return typeof Element<"u"&&e instanceof Element&&e.closest(Yt)!==null}i(we,"isElsewhere");var Yt="input, textarea, select, [contenteditable], dialog[open]";function qe(t){let e=new Set,r=new AbortController,o=i((s,a)=>t.addEventListener(s,a,{signal:r.signal}),"listen"),n=!1;return o("keydown",s=>{let a=s;n=a.shiftKey,!(!jt(a.code)||we(a))&&(e.add(a.code),a.preventDefault())}),o("keyup",s=>{n=s.shiftKey,e.delete(s.code),s.key==="Meta"&&e.clear()}),o("blur",()=>{e.clear(),n=!1}),{get drive(){let s=[0,0,0,0];for(let m of e)Ve[m]?.forEach((f,b)=>s[b]=(s[b]??0)+f);let[a=0,l=0,c=0,h=0]=s,[u,d]=K(a,l);return{right:u,ahead:d,turn:Math.sign(c),look:Math.sign(h),isHasty:n}},dispose:i(()=>r.abort(),"dispose")}}i(qe,"createKeys");var[Xt,Qt]=[.6,3],[Jt,je,Zt]=[4,5,.004],Ye=1.2,er=.25,Xe={KeyE:1,Space:1,KeyQ:-1,KeyC:-1};function tr(t,e,r,o,n,s){let a=t.yaw+Ye*e.turn*s,l=C(t.pitch+Ye*e.look*s,-1.5,1.5),c=Math.max(t.position[1]-n,Qt),h=Xt*c*2**o*(e.isHasty?Jt:1)*s,u=$(t.position,Le({yaw:a,pitch:l}),h*e.ahead);return u=$(u,Oe(a),h*e.right),{position:$(u,[0,1,0],h*r),yaw:a,pitch:l}}i(tr,"flown");function Qe(t,e,r,o){let n=e,s=0,a=new Set,l=qe(window),c=i((d,m)=>{n={...n,yaw:n.yaw+d,pitch:C(n.pitch+m,-1.5,1.5)}},"turn"),h=i(()=>{},"none"),u=We(t,{mode:i(()=>"walk","mode"),look:c,rotate:h,pan:h,zoom:h,thumb:o,go:h});return window.addEventListener("keydown",d=>{!Object.hasOwn(Xe,d.code)||we(d)||(a.add(d.code),d.target instanceof HTMLButtonElement||d.preventDefault())}),window.addEventListener("keyup",({code:d})=>a.delete(d)),window.addEventListener("blur",()=>a.clear()),t.addEventListener("wheel",d=>{d.preventDefault(),s=C(s-Zt*d.deltaY*(d.deltaMode===1?16:1),-je,je)},{passive:!1}),{get pose(){return n},get power(){return s},update(d){let m=d>0?Math.min(d,er):0,f=V(l.drive,u.drive,Ke(rr())),b=Math.sign([...a].reduce((w,M)=>w+(Xe[M]??0),0));return b===0&&[f.right,f.ahead,f.turn,f.look].every(w=>w===0)||(n=tr(n,f,b,s,r(),m)),n},setPose(d){n=d}}}i(Qe,"createFly");function rr(){try{return navigator.getGamepads?.()??[]}catch{return[]}}i(rr,"padsOf");var[nr,ve]=[.55,.45];function Je({origin:t,cell:e,counts:r}){let o=t.map((a,l)=>a+e*r[l]/2),n=nr*e*Math.max(r[0],r[2]);return{position:[o[0],t[1]+n*Math.sin(ve),o[2]+n*Math.cos(ve)],yaw:0,pitch:-ve}}i(Je,"startOf");function Ze({position:t,yaw:e,pitch:r},o,n,s){let[a,l,c,h]=[Math.sin(e),Math.cos(e),Math.sin(r),Math.cos(r)],u=Math.tan(o/2),d=u*n/s;return{position:t,right:[l,0,-a],up:[a*c,h,l*c],back:[a*h,-c,l*h],fov:{left:-d,right:d,down:-u,up:u},width:n,height:s}}i(Ze,"cameraOf");function Y({right:t,up:e,back:r,fov:o,width:n,height:s},a,l){let c=o.left+(o.right-o.left)*a/n,h=o.up+(o.down-o.up)*l/s;return[0,1,2].map(u=>{let[d,m,f]=[t[u],e[u],r[u]];return c*d+h*m-f})}i(Y,"directionAt");function N(t,e){return t[0]*e[0]+t[1]*e[1]+t[2]*e[2]}i(N,"dot");function ge(t,e){return[t[1]*e[2]-t[2]*e[1],t[2]*e[0]-t[0]*e[2],t[0]*e[1]-t[1]*e[0]]}i(ge,"cross");function I(t){let e=Math.sqrt(N(t,t));return e>0?[t[0]/e,t[1]/e,t[2]/e]:[0,1,0]}i(I,"unit");var et=["","k","M","G","T"];function X(t){return ot(t,"B")}i(X,"bytes");function tt(t){return t===null?"idle":ot(t,"b/s")}i(tt,"rate");function rt(t){return Q(t)?t>=9995e5?`${(t/1e9).toFixed(2)}\xA0billion`:t>=999999.5?`${(t/1e6).toFixed(2)}\xA0million`:Math.round(t).toLocaleString("en"):"\u2013"}i(rt,"count");function nt(t){return Q(t)?`${t.toFixed(t<99.95?1:0)}\xA0ms`:"\u2013"}i(nt,"milliseconds");function xe(t){return Q(t)?t>=999.5?`${(t/1e3).toFixed(1)}\xA0km`:`${t.toFixed(t<.995?2:t<99.95?1:0)}\xA0m`:"\u2013"}i(xe,"metres");function ot(t,e){if(!Q(t))return"\u2013";let r=or(t);return`${sr(t,r)}\xA0${et[r]}${e}`}i(ot,"scaled");function or(t){let e=0;for(;e<et.length-1&&t/1e3**e>=999.5;)e+=1;return e}i(or,"powerOf");function sr(t,e){let r=t/1e3**e;return r.toFixed(e>1&&r<99.95?1:0)}i(sr,"digits");function Q(t){return Number.isFinite(t)&&t>=0}i(Q,"isAmount");var ir={frame:"Frame",splats:"Splats",views:"Views",waiting:"Waiting",loaded:"Loaded",memory:"On the GPU",height:"Height"};function st(t,e){let r=new Map,o=Object.entries(ir).map(([u,d])=>{let m=g("dd",{},"\u2013");return r.set(u,m),g("div",{},g("dt",{},d),m)}),n=g("div",{class:"panel card",role:"region","aria-label":"Figures"}),s=Te("Figures","chip card",()=>h(!0)),a=g("button",{type:"button","aria-label":"Hide the figures",title:"Hide"},B(G.close));a.addEventListener("click",()=>h(!1)),n.append(g("header",{},g("h1",{},"nearfar"),a),g("div",{class:"panel-body"},g("dl",{class:"figures"},...o)));let l=g("p",{class:"note card"}),c=g("div",{class:"tools"},Te("Home","tool",e),Te("Help","tool",()=>l.hidden=!l.hidden));l.textContent=ar,l.hidden=!0,t.append(g("div",{class:"frame"},g("div",{class:"top"},n,s),g("div",{class:"bottom"},l,c)));function h(u){n.hidden=!u,s.hidden=u}return i(h,"show"),h(window.innerWidth>600),{update({facts:u,frame:d,received:m,rate:f,height:b,power:y}){let w=i((M,_)=>Ie(r.get(M),_),"put");w("frame",nt(d)),w("splats",rt(u.splats)),w("views",u.standIns>0?`${u.views}, ${u.standIns} coarser`:String(u.views)),w("waiting",u.waiting>0?`${u.waiting} views`:"nothing"),w("loaded",f===null?X(m):`${X(m)}, ${tt(f)}`),w("memory",X(u.bytes)),w("height",y===0?xe(b):`${xe(b)}, speed \xD7 ${(2**y).toFixed(y<0?2:1)}`)}}}i(st,"createPanel");var ar="Dragging looks around. W A S D or the left thumb fly, E and Q go up and down, arrow keys turn, Shift is four times as fast, the wheel changes the speed. The address leads back to this place.";function Te(t,e,r){let o=g("button",{type:"button",class:e},t);return o.addEventListener("click",r),o}i(Te,"button");function F({kind:t}){return t==="refused"||t==="unreachable"}i(F,"isPassing");var Ee=["color","depth","normal"],lr="behind_";var cr="nearfar";function it({depthBits:t}){return Math.floor((2**t-1)/6)*6}i(it,"stepsOf");function z({cell:t},e){return t*2**e}i(z,"sideAt");function J(t,e,[r,o,n]){let[s,[a,l,c]]=[z(t,e),t.origin];return[a+r*s,l+o*s,c+n*s]}i(J,"cornerOf");function Se({subtree:t},e){return 2**(t-e%t)}i(Se,"shardSide");function Z(t,e,[r,o,n]){let s=Se(t,e),a=[Math.floor(r/s),Math.floor(o/s),Math.floor(n/s)];return{tier:Math.floor(e/t.subtree),place:a}}i(Z,"subtreeOf");function at(t){return t===0?"":`${cr}/generations/${t}/`}i(at,"overlay");function lt({names:t},e,r,o){return`${e}/${t[r]}/${o}`}i(lt,"arrayOf");function ct(t,e,r,o){return`${o}/c/${Z(t,e,r).place.join("/")}/0/0/0`}i(ct,"shardOf");function dt({layers:t}){return t===2?[...Ee,...Ee.map(e=>lr+e)]:Ee}i(dt,"channelsOf");function P(t,[e,r,o]){return`${t}/${e}/${r}/${o}`}i(P,"nameOf");function Me([t,e,r]){return Array.from({length:8},(o,n)=>[2*t+(n>>2),2*e+(n>>1&1),2*r+(n&1)])}i(Me,"childrenOf");function ut([t,e,r],o){let n=2**o;return[Math.floor(t/n),Math.floor(e/n),Math.floor(r/n)]}i(ut,"above");var dr={mask:0,generation:0},ee=class{constructor(e){this.layout=e}layout;static{i(this,"Cells")}#e=new Map;add(e){this.#e.set(P(e.tier,e.place),e)}knows(e,r){return this.#e.has(P(e,r))}at(e,r){let{tier:o,place:n}=Z(this.layout,e,r),s=this.#e.get(P(o,n));if(!s)return null;let a=Se(this.layout,e),[l,c,h]=r.map((b,y)=>b-n[y]*a),u=(l*a+c)*a+h,d=e%this.layout.subtree,[m,f]=[s.masks[d]?.[u],s.generations[d]?.[u]];return m===void 0||f===void 0?dr:{mask:m,generation:f}}};var ht=3;function _e(t){let e=t[0]===0&&t[2]===0?[1,0,0]:[t[2],0,-t[0]],r=[e,ge(t,e),t],o=r.map(n=>(Math.abs(n[0])+Math.abs(n[1])+Math.abs(n[2]))/Math.hypot(...n));return{axes:[I(r[0]),I(r[1]),I(r[2])],extents:o}}i(_e,"frameOf");var[ke,H]=[1.27,.5],Pe=.25,te=10;function mt(t,e,r,o){let n=z(t,e),s=J(t,e,r),a=_e(t.directions[o]),l=a.extents.map(y=>y*n),c=[l[0]/t.size,l[1]/t.size,l[2]/it(t)],[h,u,d]=a.axes,m=s.map((y,w)=>y+n/2+(-h[w]*l[0]+u[w]*l[1]+d[w]*l[2])/2),f=i((y,w)=>[y[0]*w,y[1]*w,y[2]*w],"scaled"),b=[f(h,c[0]),f(u,-c[1]),f(d,-c[2])];return{frame:a,pitch:c,start:m,steps:b,normalBits:t.normalBits/2}}i(mt,"modelOf");function ft(t){let{position:e,right:r,up:o,back:n,fov:s,width:a,height:l}=t,[c,h]=[a/(s.right-s.left),l/(s.up-s.down)],u=i(b=>[b(0),b(1),b(2)],"row"),d=[u(b=>c*(r[b]+s.left*n[b])),u(b=>-h*(o[b]+s.up*n[b])),u(b=>-n[b])],m=Y(t,0,0),f=i((b,y)=>{let w=Y(t,b,y);return[w[0]-m[0],w[1]-m[1],w[2]-m[2]]},"step");return{eye:e,rows:d,rays:[m,f(1,0),f(0,1)],width:a,height:l}}i(ft,"projectorOf");function pt(t,{eye:e,rows:r}){let{start:o,steps:n,pitch:s}=t,a=[o[0]-e[0],o[1]-e[1],o[2]-e[2]],l=i(m=>[N(r[0],m),N(r[1],m),N(r[2],m)],"along"),[c,h]=[ke*Math.sqrt(H),bt(t)],u=i(m=>Math.max(c,h/m)-.5,"across"),d=c*(s[0]+s[1])/Pe;return{start:l(a),steps:[l(n[0]),l(n[1]),l(n[2])],least:Math.max(s[0],s[1]),margin:[u(s[0]),u(s[1]),Math.max(d,h)/s[2]]}}i(pt,"sightOf");function bt({pitch:t}){return Math.hypot(t[0],t[1])/2}i(bt,"ballOf");function yt({start:t,steps:e,least:r,margin:o},{low:n,high:s},a,l){let[c,h,u,d,m]=[!0,!0,!0,!0,!0];for(let f=0;f<8;f++){let b=n.map((x,T)=>f>>T&1?s[T]+o[T]:x-o[T]),y=i(x=>t[x]+b[0]*e[0][x]+b[1]*e[1][x]+b[2]*e[2][x],"value"),[w,M,_]=[y(0),y(1),y(2)];c&&=w<-_,h&&=w>(a+1)*_,u&&=M<-_,d&&=M>(l+1)*_,m&&=_<r}return!(c||h||u||d||m)}i(yt,"isSeen");function wt(t,{low:e,high:r}){return t.every(([o,n,s,a])=>{let l=[o,n,s].map((h,u)=>{let[d,m]=[h*e[u],h*r[u]];return[Math.min(d,m),Math.max(d,m)]}),c=i(h=>l.reduce((u,d)=>u+d[h],a),"sum");return c(0)<1&&c(1)>=0})}i(wt,"isIn");function vt(t,e,r){if(!r)return[0,1,2].map(()=>[0,0,0,.5]);let o=z(e,r.level),n=J(e,r.level,r.place);return[0,1,2].map(s=>{let a=i(l=>t.steps[l][s]/o,"factor");return[a(0),a(1),a(2),(t.start[s]-n[s])/o]})}i(vt,"rowsOf");function gt(t,e,r,o){let{frame:n,pitch:s}=e,[a,l,c]=n.axes,h=2/(2**e.normalBits-2),u=i((m,[f,b,y],w)=>t.set([f,b,y,w],4*m),"put"),d=i((m,f)=>[m[0]*f,m[1]*f,m[2]*f],"scaled");u(0,r.start,r.least),u(1,r.steps[0],h),u(2,r.steps[1],bt(e)/Math.sqrt(H)),u(3,r.steps[2],0),u(4,d(a,s[0]/s[2]),0),u(5,d(l,s[1]/s[2]),0),u(6,c,0),o.forEach((m,f)=>t.set(m,4*(7+f)))}i(gt,"writeView");function Re(t,e,r){let o=t.createProgram();for(let[s,a]of[[t.VERTEX_SHADER,e],[t.FRAGMENT_SHADER,r]]){let l=t.createShader(s);if(!l)throw new Error("the browser has taken the graphics away");t.shaderSource(l,a),t.compileShader(l),t.attachShader(o,l),t.deleteShader(l)}if(t.linkProgram(o),!t.getProgramParameter(o,t.LINK_STATUS)){let s=(t.getAttachedShaders(o)??[]).map(a=>t.getShaderInfoLog(a));throw new Error(`a shader does not compile: ${[...s,t.getProgramInfoLog(o)].filter(Boolean).join(" ")}`)}let n=new Map;return{program:o,at(s){return n.has(s)||n.set(s,t.getUniformLocation(o,s)),n.get(s)??null}}}i(Re,"programOf");function xt(t,e,r){let[o,n,s]=[t.createFramebuffer(),t.createTexture(),t.createRenderbuffer()];return t.bindTexture(t.TEXTURE_2D,n),t.texStorage2D(t.TEXTURE_2D,1,t.SRGB8_ALPHA8,e,r),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,t.NEAREST),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,t.NEAREST),t.bindRenderbuffer(t.RENDERBUFFER,s),t.renderbufferStorage(t.RENDERBUFFER,t.DEPTH_COMPONENT32F,e,r),t.bindFramebuffer(t.FRAMEBUFFER,o),t.framebufferTexture2D(t.FRAMEBUFFER,t.COLOR_ATTACHMENT0,t.TEXTURE_2D,n,0),t.framebufferRenderbuffer(t.FRAMEBUFFER,t.DEPTH_ATTACHMENT,t.RENDERBUFFER,s),t.bindFramebuffer(t.FRAMEBUFFER,null),{frame:o,color:n,width:e,height:r,dispose(){t.deleteFramebuffer(o),t.deleteTexture(n),t.deleteRenderbuffer(s)}}}i(xt,"targetOf");var Tt=`// The morph of nearfar in GLSL: where the user is shown a point of the world. Licence: MIT or Apache-2.0.
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
`;var ur=`
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`,hr=`
// The eye, from the centre: each eye of a headset has its own.
uniform vec3 cameraPosition;
// r1, r2, 1 / (r2 - r1), and the strength of the morph; a strength below 0 stands for no morph at all.
uniform vec4 radii;

bool is_morphed() {
  return radii.w >= 0.0;
}
`,Et=`
vec3 srgb_of(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
`,to=ur+Tt+hr;var ne=`#version 300 es
precision highp float;
precision highp int;
`,re=i(t=>Number.isInteger(t)?t.toFixed(1):String(t),"float"),mr=`
const vec3 SUN_DIRECTION = vec3(0.5263158, 0.7894737, 0.3157895);
const vec3 SUN = vec3(0.60, 0.56, 0.50);
const vec3 SKY_DIRECTION = vec3(-0.2062843, 0.9282791, 0.3094264);
const vec3 SKY_LOW = vec3(0.130, 0.135, 0.150);
const vec3 SKY_HIGH = vec3(0.380, 0.420, 0.480);

vec3 irradiance(vec3 n) {
  float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
  return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}

vec3 linear_of(vec3 c) {
  return mix(pow((c + 0.055) / 1.055, vec3(2.4)), c / 12.92, vec3(lessThanEqual(c, vec3(0.04045))));
}
`,St=`${ne}
layout(location = 0) in uvec3 splat;
uniform vec4 view[${te}];
// The camera's gradients of X, Y and W, and the rays through the corner, a sample to the right and one down.
uniform vec3 gradients[3];
uniform vec3 rays[3];
// Width and height of the picture in samples, and the greatest size of a point.
uniform vec3 screen;
flat out vec4 v_inverse;
flat out vec2 v_middle;
flat out vec3 v_nearness;
flat out vec3 v_color;
const float RADIUS = ${re(Math.sqrt(H))};
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
${mr}
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
  float facing = 1.0 / max(dot(view[6].xyz, normal), ${re(Pe)});
  vec3 u = view[1].xyz + dot(view[4].xyz, normal) * facing * view[3].xyz;
  vec3 v = view[2].xyz - dot(view[5].xyz, normal) * facing * view[3].xyz;
  bool is_surfel = (splat.z >> 24 & 1u) == 1u;
  float factor = is_surfel ? ((splat.z >> 25 & 1u) == 1u ? 1.0 : ${re(ke)}) : 0.0;

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
`,Mt=`${ne}
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
  bool is_inside = dot(q, q) <= ${re(H)};
  // The sample that holds a splat's middle always belongs to it.
  if (!is_inside && any(notEqual(floor(at), floor(v_middle)))) {
    discard;
  }
  float nearness = v_nearness.x + (is_inside ? dot(v_nearness.yz, p) : 0.0);
  // Exact on a plane. What is nearer has more, so that float32 keeps its digits far away.
  gl_FragDepth = nearest * nearness;
  shade = vec4(v_color, 1.0);
}
`,_t=`${ne}
void main() {
  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
`,kt=`${ne}
uniform sampler2D samples;
// Samples along each axis of a pixel.
uniform int grid;
uniform vec3 screen;
uniform vec3 rays[3];
out vec4 shade;
${Et}
vec3 background(vec3 direction) {
  const vec3 HORIZON = vec3(0.66, 0.74, 0.82);
  vec3 end = direction.y < 0.0 ? vec3(0.24, 0.25, 0.26) : vec3(0.16, 0.34, 0.66);
  return mix(HORIZON, end, sqrt(abs(direction.y)));
}

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
`;var oe=class{constructor(e,r){this.canvas=e;this.layout=r;let o=e.getContext("webgl2",{alpha:!1,antialias:!1,depth:!1});if(!o)throw new Error("this browser has no WebGL 2");this.#e=o,this.#r=Re(this.#e,St,Mt),this.#t=Re(this.#e,_t,kt),this.#n=this.#e.getParameter(this.#e.ALIASED_POINT_SIZE_RANGE)[1]??1}canvas;layout;static{i(this,"Drawer")}#e;#r;#t;#i=new Float32Array(4*te);#n;#o=null;#s=null;upload(e,{words:r,parts:o}){let n=this.#e,[s,a]=[n.createVertexArray(),n.createBuffer()];return n.bindVertexArray(s),n.bindBuffer(n.ARRAY_BUFFER,a),n.bufferData(n.ARRAY_BUFFER,r,n.STATIC_DRAW),n.enableVertexAttribArray(0),n.vertexAttribIPointer(0,ht,n.UNSIGNED_INT,0,0),n.bindVertexArray(null),{model:e,parts:o,array:s,buffer:a,bytes:r.byteLength}}drop({array:e,buffer:r}){this.#e.deleteVertexArray(e),this.#e.deleteBuffer(r)}draw(e,r,o){let n=this.#e,s={...r,width:r.width*o,height:r.height*o},a=ft(s),l=this.#c(s.width,s.height);n.bindFramebuffer(n.FRAMEBUFFER,l.frame),n.viewport(0,0,l.width,l.height),n.enable(n.DEPTH_TEST),n.depthFunc(n.GREATER),n.clearColor(0,0,0,0),n.clearDepth(0),n.clear(n.COLOR_BUFFER_BIT|n.DEPTH_BUFFER_BIT),n.useProgram(this.#r.program);let c=Math.min(...e.map(({layer:d})=>Math.max(d.model.pitch[0],d.model.pitch[1])),1e6);this.#a(this.#r,a),n.uniform1f(this.#r.at("nearest"),c/2);let[h,u]=[0,0];for(let d of e){let m=this.#d(d,a);h+=m.splats,u+=m.calls}return n.bindVertexArray(null),this.#l(l,a,r,o),{splats:h,calls:u}}get isDone(){let e=this.#e;return this.#s&&e.getSyncParameter(this.#s,e.SYNC_STATUS)!==e.SIGNALED?!1:(e.deleteSync(this.#s),this.#s=null,!0)}finish(){this.#e.readPixels(0,0,1,1,this.#e.RGBA,this.#e.UNSIGNED_BYTE,new Uint8Array(4))}#d({layer:e,box:r},o){let n=this.#e,s=pt(e.model,o),a=vt(e.model,this.layout,r),l=e.parts.filter(u=>yt(s,u,o.width,o.height)&&(!r||wt(a,u)));if(l.length===0)return{splats:0,calls:0};gt(this.#i,e.model,s,a),n.uniform4fv(this.#r.at("view"),this.#i),n.bindVertexArray(e.array);let[c,h]=[0,0];for(let u=0;u<l.length;){let{first:d}=l[u],m=d;for(;l[u]?.first===m;u++)m+=l[u].count;n.drawArrays(n.POINTS,d,m-d),c+=m-d,h+=1}return{splats:c,calls:h}}#a(e,{rows:r,rays:o,width:n,height:s}){let a=this.#e;a.uniform3fv(e.at("gradients"),r.flat()),a.uniform3fv(e.at("rays"),o.flat()),a.uniform3f(e.at("screen"),n,s,this.#n)}#l(e,r,{width:o,height:n},s){let a=this.#e;a.bindFramebuffer(a.FRAMEBUFFER,null),a.viewport(0,0,o,n),a.disable(a.DEPTH_TEST),a.useProgram(this.#t.program),this.#a(this.#t,r),a.uniform1i(this.#t.at("grid"),s),a.activeTexture(a.TEXTURE0),a.bindTexture(a.TEXTURE_2D,e.color),a.uniform1i(this.#t.at("samples"),0),a.drawArrays(a.TRIANGLES,0,3),a.deleteSync(this.#s),this.#s=a.fenceSync(a.SYNC_GPU_COMMANDS_COMPLETE,0),a.flush()}#c(e,r){return(this.#o?.width!==e||this.#o.height!==r)&&(this.#o?.dispose(),this.#o=xt(this.#e,e,r)),this.#o}};var[fr,pr]=[1,30],Pt="",se=class{constructor(e){this.settings=e}settings;static{i(this,"Queue")}#e=new Map;#r=new Map;#t=new Set;#i=new Map;#n=0;get waiting(){return[...this.#i.keys()].filter(e=>this.#r.get(e)?.again!==Number.POSITIVE_INFINITY).length}want(e){this.#i=e;for(let[r,o]of this.#e)o.isCancelled||e.has(o.name)||(o.isCancelled=!0,this.settings.cancel(r));this.fill()}fill(){let e=new Set([...this.#e.values()].map(({name:o})=>o)),r=this.settings.now();for(let[o,n]of this.#i){if(this.#e.size>=this.settings.atOnce)return;if(e.has(o)||(this.#r.get(o)?.again??0)>r)continue;let s=++this.#n;this.#e.set(s,{name:o,job:n,isCancelled:!1}),this.settings.send(s,n)}}done(e){let r=this.#o(e);return r&&(this.#r.delete(r.name),this.#i.delete(r.name),this.#t.delete(Pt)&&this.settings.recovered()),r?.job??null}cancelled(e){this.#o(e),this.fill()}failed(e,r){let o=this.#o(e);if(o){let n=Math.min(2*(this.#r.get(o.name)?.pause??fr/2),pr),s=F(r)?this.settings.now()+n:Number.POSITIVE_INFINITY;this.#r.set(o.name,{again:s,pause:n});let a=F(r)?Pt:r.message;this.#t.has(a)||this.settings.failed(r),this.#t.add(a)}this.fill()}retry(){this.#r.clear(),this.#t.clear(),this.fill()}#o(e){let r=this.#e.get(e);return this.#e.delete(e),r??null}};function Rt(t,e,r,o,n){let s=new Map,a=Array.from({length:e},()=>new Worker(t,{type:"module"}));for(let l of a)l.onmessage=({data:c})=>{switch(c.kind){case"view":s.delete(c.id),n.view(c.id,c.layers);break;case"failed":s.delete(c.id),n.failed(c.id,c.failure);break;case"cancelled":s.delete(c.id),n.cancelled(c.id);break;case"received":n.received(c.bytes)}},l.onerror=({message:c})=>{let h={kind:"other",message:`a worker stopped: ${c||"the browser gives no reason"}`};for(let[u,d]of s)d===l&&n.failed(u,h)},Ae(l,{kind:"open",base:r.href,layout:o});return{read(l,c){let h=a[br(c.shards[0]?.[0]??"")%a.length];s.set(l,h),Ae(h,{kind:"read",id:l,wanted:c})},cancel(l){let c=s.get(l);c&&Ae(c,{kind:"cancel",id:l})}}}i(Rt,"startReaders");function Ae(t,e){t.postMessage(e)}i(Ae,"send");function br(t){let e=2166136261;for(let r=0;r<t.length;r++)e=Math.imul(e^t.charCodeAt(r),16777619);return e>>>0}i(br,"hash");var ie=class{constructor(e,r,o){this.layout=e;this.uploader=r;this.most=o}layout;uploader;most;static{i(this,"Resident")}#e=new Map;#r=new Map;#t=0;bytes=0;get count(){return this.#e.size}add(e,r,o,n){let s=`${P(e,r)}/${o}`;if(this.#e.has(s))return;let a=mt(this.layout,e,r,o),l=n.map(h=>this.uploader.upload(a,h)),c=l.reduce((h,u)=>h+u.bytes,0);this.#e.set(s,{level:e,place:r,direction:o,layers:l,bytes:c,used:this.#t}),this.#r.set(P(e,r),[...this.there(e,r),o]),this.bytes+=c}there(e,r){return this.#r.get(P(e,r))??[]}begin(){this.#t+=1}use(e,r,o){let n=`${P(e,r)}/${o}`,s=this.#e.get(n);return s?(s.used!==this.#t&&(s.used=this.#t,this.#e.delete(n),this.#e.set(n,s)),s.layers):[]}trim(e){for(let[r,o]of this.#e){if(this.bytes<=this.most)break;o.used===this.#t||e(o.level,o.place)||this.#i(r,o)}}#i(e,{level:r,place:o,direction:n,layers:s,bytes:a}){s.forEach(h=>this.uploader.drop(h)),this.#e.delete(e),this.bytes-=a;let l=P(r,o),c=this.there(r,o).filter(h=>h!==n);c.length>0?this.#r.set(l,c):this.#r.delete(l)}};function At(t,{views:e}){let[r,o]=[0,t];for(;o!==0;o&=o-1)r+=1;return Math.min(r,e)}i(At,"countOf");var yr=3;function Lt({cells:t},e,r,o){let n=[],s=[],a=0,l=i((d,m,f=null)=>r(d,m).map(b=>({level:d,place:m,direction:b,box:f})),"all"),c=i((d,m)=>{let f=e.at(d,m)?.mask??0;return f!==0&&r(d,m).length>=At(f,{views:o})},"isFull");function h(d,m,f){if(d===0||f===0)return null;let b=[];for(let y of Me(m)){let w=e.at(d-1,y);if(!w)return null;if(w.mask===0)continue;let M=c(d-1,y)?l(d-1,y).slice(-o):h(d-1,y,f-1);if(!M)return null;b.push(...M)}return b}i(h,"below");function u(d){let m=[];for(let f=d.level+1;f<e.layout.levels;f++){let b=ut(d.place,f-d.level),y={level:d.level,place:d.place};if(c(f,b))return l(f,b,y).slice(-o);m.length===0&&(m=l(f,b,y))}return m}i(u,"standIn");for(let d of t){let{level:m,place:f,directions:b}=d,y=new Set(r(m,f)),w=b.filter(x=>y.has(x));for(let x of b)y.has(x)||s.push({level:m,place:f,direction:x});if(w.length===b.length){n.push(...w.map(x=>({level:m,place:f,direction:x,box:null})));continue}let M=c(m,f)?wr(w,y,b.length):null;if(M){n.push(...M.map(x=>({level:m,place:f,direction:x,box:null})));continue}let _=h(m,f,yr)??u(d);_.length===0&&(_=l(m,f)),_.length===0&&(a+=1),n.push(..._)}return{shown:vr(n),missing:s,holes:a}}i(Lt,"choose");function wr(t,e,r){let o=[...e].filter(n=>!t.includes(n));return[...t,...o.slice(o.length-(r-t.length))]}i(wr,"fill");function vr(t){let e=new Map;for(let r of t){let o=r.box?P(r.box.level,r.box.place):"";e.set(`${P(r.level,r.place)}/${r.direction}/${o}`,r)}return[...e.values()]}i(vr,"unique");var gr=6,[xr,Tr]=[50,.5],Er={views:0,standIns:0,waiting:0,holes:0,splats:0,calls:0,bytes:0,kept:0,isComplete:!1},ae=class{constructor(e,r){this.canvas=e;this.#e=r,this.#r=new Worker(r.scripts.cutter,{type:"module"}),this.#r.onmessage=({data:o})=>this.#T(o),this.#r.onerror=({message:o})=>r.failed({kind:"other",message:`a worker stopped: ${o}`},!0),this.#t=new se({atOnce:gr*r.workers,send:i((o,n)=>this.#o?.read(o,n),"send"),cancel:i(o=>this.#o?.cancel(o),"cancel"),failed:i(o=>r.failed(o,!1),"failed"),recovered:r.recovered,now:i(()=>performance.now()/1e3,"now")}),this.#b({kind:"open",base:r.base.href})}canvas;static{i(this,"Viewer")}#e;#r;#t;#i=new Map;#n=null;#o=null;#s=null;#d=null;#a=null;#l=!1;#c=!1;#h=!0;#u=!0;#m=0;#f=0;#p=!1;facts=Er;frame(e){if(!this.#n||((!this.#a||!Sr(this.#a,e))&&(this.#a=e,this.#c=this.#h=!0),this.#c&&!this.#l&&this.#x(e),this.#t.fill(),!this.#s||!this.#g(this.#n.drawer)))return!1;let r=performance.now()-this.#f>=Math.max(xr,this.took/Tr-this.took);return this.#h||this.#u&&(r||this.#t.waiting===0)?(this.#v(e),!0):!1}get took(){return Math.max(this.#f-this.#m,0)}time(){return!this.#a||!this.#n?0:(this.#v(this.#a),this.#n.drawer.finish(),performance.now()-this.#m)}#g(e){return this.#p?e.isDone?(this.#f=performance.now(),this.#p=!1,!0):!1:!0}retry(){this.#t.retry(),this.#b({kind:"retry"})}#x(e){let{views:r,error:o}=this.#e,n={views:r,error:o,isAround:!1};[this.#l,this.#c]=[!0,!1],this.#b({kind:"look",camera:e,settings:n})}#T(e){switch(e.kind){case"opened":this.#E(e.layout,e.shards);break;case"learned":this.#n?.cells.add(e.subtree),this.#y(e.subtree.shards);break;case"base":this.#d=e.cut;break;case"cut":this.#s=e.cut,this.#l=!1,this.#u=!0,this.#S();break;case"received":this.#e.received(e.bytes);break;case"failed":this.#e.failed(e.failure,e.isFatal)}}#E(e,r){let o=new oe(this.canvas,e);this.#n={cells:new ee(e),drawer:o,resident:new ie(e,o,this.#e.bytes)},this.#y(r);let{scripts:n,workers:s,base:a}=this.#e;this.#o=Rt(n.reader,s,a,e,{view:i((l,c)=>{let h=this.#t.done(l);h&&this.#n?.resident.add(h.level,h.place,h.direction,c),this.#u=!0,this.#t.fill()},"view"),failed:i((l,c)=>this.#t.failed(l,c),"failed"),cancelled:i(l=>this.#t.cancelled(l),"cancelled"),received:this.#e.received}),this.#e.opened(e)}#y(e){for(let r of e)this.#i.set(r[0],r)}#w(e){let{cells:r,resident:o}=this.#n;return Lt(e,r,(n,s)=>o.there(n,s),this.#e.views)}#v(e){if(!this.#n||!this.#s)return;let{drawer:r,resident:o}=this.#n;this.#h=this.#u=!1,this.#m=performance.now(),this.#p=!0;let n=this.#w(this.#s);o.begin();let s=n.shown.flatMap(({level:d,place:m,direction:f,box:b})=>o.use(d,m,f).map(y=>({layer:y,box:b}))),{splats:a,calls:l}=r.draw(s,e,this.#e.grid),c=new Set(this.#d?.cells.map(({level:d,place:m})=>P(d,m)));o.trim((d,m)=>c.has(P(d,m)));let[{waiting:h},u]=[this.#t,!this.#l&&!this.#c];this.facts={views:n.shown.length,standIns:n.shown.filter(({box:d})=>d!==null).length,waiting:h,holes:n.holes,splats:a,calls:l,bytes:o.bytes,kept:o.count,isComplete:u&&h===0&&this.#s.unknown.length===0}}#S(){let e=[this.#d,this.#s].flatMap(o=>o?this.#w(o).missing:[]),r=new Map;for(let{level:o,place:n,direction:s}of e){let a=`${P(o,n)}/${s}`;r.has(a)||r.set(a,this.#M(o,n,s))}this.#t.want(r)}#M(e,r,o){let{cells:n}=this.#n,s=n.at(e,r)?.generation??0,a=dt(n.layout).map(l=>{let c=lt(n.layout,e,o,l);return this.#i.get(at(s)+ct(n.layout,e,r,c))});return{level:e,place:r,direction:o,generation:s,shards:a.filter(l=>l!==void 0)}}#b(e){this.#r.postMessage(e)}};function Sr(t,e){let r=i(({position:n,right:s,up:a,fov:l,width:c,height:h})=>[...n,...s,...a,...Object.values(l),c,h],"numbers"),o=r(e);return r(t).every((n,s)=>n===o[s])}i(Sr,"isSame");var Mr=Math.PI/3,_r=1.5,[Ot,kr]=[.25,.5],Nt=1<<29;function Pr(){let t=new URLSearchParams(location.search),[e,r]=[Ft("canvas",HTMLCanvasElement),Ft("#ui",HTMLElement)],o=Math.min(screen.width,screen.height)<600,n=Fe(),s=i(({kind:T,message:p})=>{let{title:v,text:E}=Ct[T];pe(v,E,{detail:p,retry:i(()=>location.reload(),"retry")})},"fatal"),a=[],l=i(T=>{a=T,Ue(a.map(({message:p})=>p),b)},"show"),c=new ae(e,{base:Lr(new URL(t.get("store")??".",location.href)),scripts:{cutter:new URL("orthoview-cut.js",import.meta.url),reader:new URL("orthoview-read.js",import.meta.url)},views:le(t,"views",3,1,8),error:le(t,"error",1,.1,64),grid:Math.round(Math.sqrt(le(t,"samples",1,1,16))),bytes:le(t,"megabytes",(o?Nt/4:Nt)>>20,1,16384)*2**20,workers:Math.min(Math.max((navigator.hardwareConcurrency||2)-1,1),4),received:n.receive,opened:f,failed(T,p){if(p){s(T);return}let v=F(T)?{...T,message:`${T.message}; ${Rr}`}:T;a.some(({kind:S,message:k})=>F(v)?S===v.kind:k===v.message)||l([...a,v])},recovered:i(()=>l(a.filter(T=>!F(T))),"recovered")}),[h,u]=[0,{position:[0,0,0],yaw:0,pitch:0}],d=Qe(e,W(location.hash)??u,()=>h,Be(r).show),m=st(r,()=>d.setPose(u));window.addEventListener("hashchange",()=>d.setPose(W(location.hash)??d.pose)),e.addEventListener("webglcontextlost",()=>s({kind:"other",message:Ar}));function f(T){h=T.origin[1],u=Je(T),W(location.hash)||d.setPose(u)}i(f,"opened");function b(){l([]),c.retry()}i(b,"retry");let[y,w,M]=[performance.now(),Ot,0],_="";window.orthoview={get facts(){return c.facts},get pose(){return d.pose},get received(){return n.read().received},setPose:d.setPose,time:i(()=>c.time(),"time")};function x(T){let p=Math.max(T-y,0)/1e3;y=T;let v=d.update(p),E=Math.min(window.devicePixelRatio||1,_r),[S,k]=[e.clientWidth,e.clientHeight].map(A=>Math.max(Math.round(A*E),1));if((e.width!==S||e.height!==k)&&([e.width,e.height]=[S,k]),c.frame(Ze(v,Mr,e.width,e.height)),w+=p,M+=p,w>=Ot){w=0;let{received:A,rate:D}=n.read();m.update({facts:c.facts,frame:c.took,received:A,rate:D,height:v.position[1]-h,power:d.power})}let R=Ne(v);M>=kr&&R!==_&&([M,_]=[0,R],history.replaceState(null,"",R)),requestAnimationFrame(x)}i(x,"frame"),requestAnimationFrame(x)}i(Pr,"main");var Rr="what has come stays, and the rest is asked for again",Ar="The browser has taken the graphics away.",Ct={gone:{title:"There is no tree at this address",text:"The page shows the store of orthoviews in whose folder it lies, or the one that ?store= names."},refused:{title:"The server refuses the tree",text:"Tell whoever runs the server what stands below."},unreachable:{title:"The tree cannot be reached",text:"Check the connection and the address, and try again."},damaged:{title:"The tree is damaged",text:"A file is not what the build has written. Check it with nearfar orthoview verify."},newer:{title:"The tree needs a newer nearfar",text:"It was written in a later format than this page reads."},other:{title:"The tree cannot be shown",text:"Reload the page. If that does not help, tell whoever sent you here what stands below."}};function Lr(t){return t.pathname.endsWith("/")||(t.pathname+="/"),t.hash="",t}i(Lr,"folderOf");function le(t,e,r,o,n){let s=t.get(e),a=s===null||s===""?r:Number(s);return Number.isFinite(a)?Math.min(Math.max(a,o),n):r}i(le,"number");function Ft(t,e){let r=document.querySelector(t);if(!(r instanceof e))throw new Error(`the page has no ${t}`);return r}i(Ft,"element");try{Pr()}catch(t){let{title:e,text:r}=Ct.other;pe(e,r,{detail:t instanceof Error?t.message:String(t)})}
