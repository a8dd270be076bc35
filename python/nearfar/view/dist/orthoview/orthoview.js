var Ut=Object.defineProperty;var i=(t,e)=>Ut(t,"name",{value:e,configurable:!0});function I(t,e,r){return Math.min(Math.max(t,e),r)}i(I,"bounded");function ce(t){return t-2*Math.PI*Math.round(t/(2*Math.PI))}i(ce,"wrapped");function Oe({yaw:t,pitch:e}){return[-Math.sin(t)*Math.cos(e),Math.sin(e),-Math.cos(t)*Math.cos(e)]}i(Oe,"ahead");function Ne(t){return[Math.cos(t),0,-Math.sin(t)]}i(Ne,"rightOf");function $(t,e,r){return[t[0]+r*e[0],t[1]+r*e[1],t[2]+r*e[2]]}i($,"moved");var zt=512,Ht=3e7,$t=/^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;function fe(t){if(t.length>zt)return null;let e=new URLSearchParams(t.replace(/^#/,"")),[r,o,n,...s]=(e.get("p")??"").split(",").map(de);if(!ue(r)||!ue(o)||!ue(n)||s.length>0)return null;let[a,l]=[de(e.get("yaw")??"0"),de(e.get("pitch")??"0")];return a===null||l===null?null:{position:[r,o,n],yaw:ce(a),pitch:I(l,-1.5,1.5)}}i(fe,"readLink");function Fe({position:t,yaw:e,pitch:r}){return`#p=${t.map(n=>he(n,3)).join(",")}&yaw=${he(ce(e),4)}&pitch=${he(r,4)}`}i(Fe,"writeLink");function de(t){let e=$t.test(t)?Number(t):Number.NaN;return Number.isFinite(e)?e:null}i(de,"numberIn");function ue(t){return t!=null&&Math.abs(t)<=Ht}i(ue,"isPlace");function he(t,e){return String(Number(t.toFixed(e)))}i(he,"rounded");function Ce(t=()=>performance.now()/1e3){let e=0,r=[],o=[];return{receive(n){e+=n,r.push({time:t(),bytes:n})},frame(n){o.push(n);let s=o.reduce((a,l)=>a+l,0);for(;o.length>1&&s>1;)s-=o.shift()??0},restart(){e=0,r=[],o=[]},read(){let n=t()-1;r=r.filter(({time:l})=>l>n);let s=r.reduce((l,c)=>l+c.bytes,0),a=o.reduce((l,c)=>l+c,0)/Math.max(o.length,1);return{received:e,rate:s>0?8*s/1:null,frame:1e3*a,longest:1e3*Math.max(0,...o)}}}}i(Ce,"createMeter");function g(t,e={},...r){let o=document.createElement(t);return me(o,e),o.append(...r),o}i(g,"make");var Ie="http://www.w3.org/2000/svg";function W(t){let e=document.createElementNS(Ie,"svg");me(e,{viewBox:"0 0 24 24",class:"icon","aria-hidden":"true",focusable:"false"});let r=document.createElementNS(Ie,"path");return me(r,{d:t}),e.append(r),e}i(W,"icon");function De(t,e){t.textContent!==e&&(t.textContent=e)}i(De,"write");function me(t,e){for(let[r,o]of Object.entries(e))o!==void 0&&o!==!1&&t.setAttribute(r,o===!0?"":o)}i(me,"setAll");var B={walk:"M13 4.5a1.5 1.5 0 1 0 0-.01M9.5 21l2-5.5-2-3 1-4.5 3 .5 2 3 2.5 1M7 12.5l.5-3 3-1.5M12.5 13l2.5 3.5.5 4.5",orbit:"M12 14a2 2 0 1 0 0-4 2 2 0 0 0 0 4M17 8c2.5.8 4 2.2 4 4 0 2.8-4 5-9 5s-9-2.2-9-5 4-5 9-5M9.5 4L13 7l-3.5 3",split:"M12 3v18M4 6h5M4 6v12h5M20 6h-5M20 6v12h-5",photo:"M4 8h3.5L9 5.5h6L16.5 8H20v11H4zM12 16.5a3.25 3.25 0 1 0 0-6.5 3.25 3.25 0 0 0 0 6.5",link:"M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1",home:"M4 11.5L12 5l8 6.5M6 10v9h4v-5h4v5h4v-9",next:"M12 21c-4-4.6-6-7.9-6-10.5a6 6 0 0 1 12 0C18 13.1 16 16.4 12 21M10 8.5l2.5 2-2.5 2",panel:"M4 5h16v14H4zM7 9h6M7 12h10M7 15h8",help:"M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.5v.01M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18",headset:"M3 8.5h18v8h-5.5L13.5 14h-3l-2 2.5H3zM7.5 12v.01M16.5 12v.01",close:"M6 6l12 12M18 6L6 18",grip:"M9 7l-5 5 5 5M15 7l5 5-5 5"};var pe=3;function be(t,e,{detail:r,retry:o}={}){let n=g("h1",{tabindex:"-1",id:"message-title"},t),s=g("div",{class:"fatal-card"},g("p",{class:"fatal-brand"},"nearfar"),n);s.append(g("p",{},e)),r&&s.append(g("p",{class:"fatal-detail"},r)),o&&s.append(He("Try again","button-main",o));let a=ye();a.replaceChildren(s),a.dataset.kind="fatal";for(let l of document.querySelectorAll("canvas, [data-behind]"))l.setAttribute("inert","");n.focus({preventScroll:!0})}i(be,"showFatal");function ze(t,e){let r=ye();if(r.dataset.kind==="fatal")return;let o=g("ul",{},...t.slice(0,pe).map(a=>g("li",{},a)));t.length>pe&&o.append(g("li",{},`and ${t.length-pe} more`));let n=g("button",{type:"button",class:"button-icon","aria-label":"Dismiss",title:"Dismiss"});n.append(W(B.close)),n.addEventListener("click",Ue);let s=g("div",{class:"banner-text"},g("strong",{},"Not all of the scene is shown"),o);t.length===0?Ue():(r.replaceChildren(s,He("Try again","button-main",e),n),r.dataset.kind="banner")}i(ze,"showProblems");function Ue(){let t=ye();t.replaceChildren(),delete t.dataset.kind;for(let e of document.querySelectorAll("canvas, [data-behind]"))e.removeAttribute("inert")}i(Ue,"clearMessage");function He(t,e,r){let o=g("button",{type:"button",class:e},t);return o.addEventListener("click",r),o}i(He,"button");function ye(){let t=document.getElementById("message");if(t)return t;let e=g("div",{id:"message",role:"alert"});return document.body.append(e),e}i(ye,"message");var N={right:0,ahead:0,turn:0,look:0,isHasty:!1};function K(...t){let e=i(a=>t.reduce((l,c)=>l+a(c),0),"sum"),[r,o]=G(e(a=>a.right),e(a=>a.ahead)),[n,s]=G(e(a=>a.turn),e(a=>a.look));return{right:r,ahead:o,turn:n,look:s,isHasty:t.some(a=>a.isHasty)}}i(K,"together");function G(t,e){let r=Math.max(Math.hypot(t,e),1);return[t/r,e/r]}i(G,"within");function U(t,e,r){let o=Math.hypot(t,e);if(!(o>r))return[0,0];let n=Math.min((o-r)/(1-r),1)/o;return[t*n,e*n]}i(U,"beyondRest");var[Wt,Bt,Gt]=[300,400,16];function $e(t){let e=new Map,r=null,o=i((n,s)=>Math.hypot(n.clientX-s.clientX,n.clientY-s.clientY)<=Gt,"isNear");return{down(n){e.size>0&&(r=null),e.set(n.pointerId,n)},up(n){let s=e.get(n.pointerId),a=e.size===1;if(e.delete(n.pointerId),!(s&&a&&n.timeStamp-s.timeStamp<=Wt&&o(s,n))){r=null;return}let c=r!==null&&n.timeStamp-r.timeStamp<=Bt&&o(r,n);r=c?null:n,c&&t(n)}}}i($e,"createTaps");var[V,We]=[1.6,Math.PI],we=1.5,Kt=.0015,Vt=[1,16,400],q=56,qt=.12;function Be(t,e){let r=new Map,o=new AbortController,n=N,s=$e(f),a=!1,l=i(()=>1/Math.max(t.clientHeight,1),"scale"),c=i(()=>t.ownerDocument.pointerLockElement===t,"isLocked");function f({clientX:b,clientY:v}){let{left:x,top:E,width:_,height:P}=t.getBoundingClientRect();c()?e.go(.5,.5):e.go((b-x)/Math.max(_,1),(v-E)/Math.max(P,1))}i(f,"go");function h(b){if(c())return;a=b.pointerType==="touch";let v=b.pointerType==="mouse",x=b.button===0&&!b.shiftKey;if(e.mode()==="walk"&&v&&!x)return;t.setPointerCapture(b.pointerId),a&&s.down(b);let E=d(b)?"step":x?"turn":"pan";r.set(b.pointerId,{x:b.clientX,y:b.clientY,task:E}),E==="step"&&m({x:b.clientX,y:b.clientY},b)}i(h,"down");function d({pointerType:b,clientX:v}){if(e.mode()!=="walk"||b!=="touch"||[...r.values()].some(({task:_})=>_==="step"))return!1;let{left:x,width:E}=t.getBoundingClientRect();return v-x<E/2}i(d,"isThumb");function u(b){let v=r.get(b.pointerId);if(!v){c()&&e.look(-b.movementX*V*l(),-b.movementY*V*l());return}if(v.task==="step"){m(v,b);return}let x={...v,x:b.clientX,y:b.clientY},E=[...r].find(([A,{task:L}])=>A!==b.pointerId&&L!=="step")?.[1],[_,P]=[(x.x-v.x)*l(),(x.y-v.y)*l()];r.set(b.pointerId,x),e.mode()==="walk"?e.look(_*V,P*V):E?p(v,x,E):v.task==="pan"?e.pan(-_*we,P*we):e.rotate(-_*We,-P*We)}i(u,"move");function m({x:b,y:v},{clientX:x,clientY:E}){let[_,P]=U((x-b)/q,(E-v)/q,qt);n={...N,right:_,ahead:0-P},e.thumb({x:b,y:v,right:x-b,down:E-v})}i(m,"step");function p(b,v,x){let[E,_]=[b,v].map(({x:A,y:L})=>Math.hypot(A-x.x,L-x.y));E&&_&&e.zoom(E/_);let P=.5*we*l();e.pan(-(v.x-b.x)*P,(v.y-b.y)*P)}i(p,"pinch");function y(b){b.pointerType==="touch"&&s.up(b),r.get(b.pointerId)?.task==="step"&&w(),r.delete(b.pointerId)}i(y,"up");function w(){n=N,e.thumb(null)}i(w,"rest");function S(b){e.mode()==="orbit"&&(b.preventDefault(),e.zoom(Math.exp(Kt*b.deltaY*(Vt[b.deltaMode]??1)*(b.ctrlKey?6:1))))}i(S,"wheel");function M(){e.mode()==="walk"&&Promise.resolve(t.requestPointerLock()).catch(()=>{})}i(M,"lock");let{signal:T}=o;t.addEventListener("pointerdown",h,{signal:T}),t.addEventListener("pointermove",u,{signal:T}),t.addEventListener("pointerup",y,{signal:T}),t.addEventListener("pointercancel",y,{signal:T}),t.addEventListener("dblclick",b=>a||f(b),{signal:T}),t.addEventListener("wheel",S,{signal:T,passive:!1}),t.addEventListener("contextmenu",b=>b.preventDefault(),{signal:T});function R(){r.clear(),w(),c()&&t.ownerDocument.exitPointerLock()}return i(R,"release"),{get drive(){return n},lock:M,release:R,dispose(){R(),o.abort()}}}i(Be,"createPointers");function Ge(t){let e=g("div",{class:"thumb",hidden:!0,"aria-hidden":"true"},g("span",{}));return t.append(e),{show(r){if(e.hidden=r===null,!r)return;let{x:o,y:n,right:s,down:a}=r,l=Math.min(1,q/Math.max(Math.hypot(s,a),1)),c={"--x":o,"--y":n,"--right":s*l,"--down":a*l};for(let[f,h]of Object.entries(c))e.style.setProperty(f,`${h}px`)},dispose:i(()=>e.remove(),"dispose")}}i(Ge,"createThumbMark");var Ke=.18,jt=[4,10];function Ve(t){let e=t.filter(r=>r!==null&&r.connected&&r.mapping==="standard");return e.length===0?N:K(...e.map(r=>r?Yt(r):N))}i(Ve,"readPads");function Yt({axes:t,buttons:e}){let[r,o]=U(t[0]??0,t[1]??0,Ke),[n,s]=U(t[2]??0,t[3]??0,Ke),a=jt.some(l=>e[l]?.pressed??!1);return{right:r,ahead:0-o,turn:0-n,look:0-s,isHasty:a}}i(Yt,"wishOf");var qe={KeyW:[0,1,0,0],KeyS:[0,-1,0,0],KeyA:[-1,0,0,0],KeyD:[1,0,0,0],ArrowUp:[0,1,0,0],ArrowDown:[0,-1,0,0],ArrowLeft:[0,0,1,0],ArrowRight:[0,0,-1,0],PageUp:[0,0,0,1],PageDown:[0,0,0,-1]};function Xt(t){return Object.hasOwn(qe,t)}i(Xt,"isMoving");function ve(t){if(t.defaultPrevented||t.ctrlKey||t.metaKey||t.altKey)return!0;let{target:e}=t;return typeof Element<"u"&&e instanceof Element&&e.closest(Qt)!==null}i(ve,"isElsewhere");var Qt="input, textarea, select, [contenteditable], dialog[open]";function je(t){let e=new Set,r=new AbortController,o=i((s,a)=>t.addEventListener(s,a,{signal:r.signal}),"listen"),n=!1;return o("keydown",s=>{let a=s;n=a.shiftKey,!(!Xt(a.code)||ve(a))&&(e.add(a.code),a.preventDefault())}),o("keyup",s=>{n=s.shiftKey,e.delete(s.code),s.key==="Meta"&&e.clear()}),o("blur",()=>{e.clear(),n=!1}),{get drive(){let s=[0,0,0,0];for(let u of e)qe[u]?.forEach((m,p)=>s[p]=(s[p]??0)+m);let[a=0,l=0,c=0,f=0]=s,[h,d]=G(a,l);return{right:h,ahead:d,turn:Math.sign(c),look:Math.sign(f),isHasty:n}},dispose:i(()=>r.abort(),"dispose")}}i(je,"createKeys");var[Jt,Zt]=[.6,3],[er,Ye,tr]=[4,5,.004],Xe=1.2,rr=.25,Qe={KeyE:1,Space:1,KeyQ:-1,KeyC:-1};function nr(t,e,r,o,n,s){let a=t.yaw+Xe*e.turn*s,l=I(t.pitch+Xe*e.look*s,-1.5,1.5),c=Math.max(t.position[1]-n,Zt),f=Jt*c*2**o*(e.isHasty?er:1)*s,h=$(t.position,Oe({yaw:a,pitch:l}),f*e.ahead);return h=$(h,Ne(a),f*e.right),{position:$(h,[0,1,0],f*r),yaw:a,pitch:l}}i(nr,"flown");function Je(t,e,r,o){let n=e,s=0,a=new Set,l=je(window),c=i((d,u)=>{n={...n,yaw:n.yaw+d,pitch:I(n.pitch+u,-1.5,1.5)}},"turn"),f=i(()=>{},"none"),h=Be(t,{mode:i(()=>"walk","mode"),look:c,rotate:f,pan:f,zoom:f,thumb:o,go:f});return window.addEventListener("keydown",d=>{!Object.hasOwn(Qe,d.code)||ve(d)||(a.add(d.code),d.target instanceof HTMLButtonElement||d.preventDefault())}),window.addEventListener("keyup",({code:d})=>a.delete(d)),window.addEventListener("blur",()=>a.clear()),t.addEventListener("wheel",d=>{d.preventDefault(),s=I(s-tr*d.deltaY*(d.deltaMode===1?16:1),-Ye,Ye)},{passive:!1}),{get pose(){return n},get power(){return s},update(d){let u=d>0?Math.min(d,rr):0,m=K(l.drive,h.drive,Ve(or())),p=Math.sign([...a].reduce((w,S)=>w+(Qe[S]??0),0));return p===0&&[m.right,m.ahead,m.turn,m.look].every(w=>w===0)||(n=nr(n,m,p,s,r(),u)),n},setPose(d){n=d}}}i(Je,"createFly");function or(){try{return navigator.getGamepads?.()??[]}catch{return[]}}i(or,"padsOf");var[sr,ge]=[.55,.45];function Ze({origin:t,cell:e,counts:r}){let o=t.map((a,l)=>a+e*r[l]/2),n=sr*e*Math.max(r[0],r[2]);return{position:[o[0],t[1]+n*Math.sin(ge),o[2]+n*Math.cos(ge)],yaw:0,pitch:-ge}}i(Ze,"startOf");function et({position:t,yaw:e,pitch:r},o,n,s){let[a,l,c,f]=[Math.sin(e),Math.cos(e),Math.sin(r),Math.cos(r)],h=Math.tan(o/2),d=h*n/s;return{position:t,right:[l,0,-a],up:[a*c,f,l*c],back:[a*f,-c,l*f],fov:{left:-d,right:d,down:-h,up:h},width:n,height:s}}i(et,"cameraOf");function j({right:t,up:e,back:r,fov:o,width:n,height:s},a,l){let c=o.left+(o.right-o.left)*a/n,f=o.up+(o.down-o.up)*l/s;return[0,1,2].map(h=>{let[d,u,m]=[t[h],e[h],r[h]];return c*d+f*u-m})}i(j,"directionAt");function F(t,e){return t[0]*e[0]+t[1]*e[1]+t[2]*e[2]}i(F,"dot");function xe(t,e){return[t[1]*e[2]-t[2]*e[1],t[2]*e[0]-t[0]*e[2],t[0]*e[1]-t[1]*e[0]]}i(xe,"cross");function D(t){let e=Math.sqrt(F(t,t));return e>0?[t[0]/e,t[1]/e,t[2]/e]:[0,1,0]}i(D,"unit");var tt=["","k","M","G","T"];function Y(t){return st(t,"B")}i(Y,"bytes");function rt(t){return t===null?"idle":st(t,"b/s")}i(rt,"rate");function nt(t){return X(t)?t>=9995e5?`${(t/1e9).toFixed(2)}\xA0billion`:t>=999999.5?`${(t/1e6).toFixed(2)}\xA0million`:Math.round(t).toLocaleString("en"):"\u2013"}i(nt,"count");function ot(t){return X(t)?`${t.toFixed(t<99.95?1:0)}\xA0ms`:"\u2013"}i(ot,"milliseconds");function Te(t){return X(t)?t>=999.5?`${(t/1e3).toFixed(1)}\xA0km`:`${t.toFixed(t<.995?2:t<99.95?1:0)}\xA0m`:"\u2013"}i(Te,"metres");function st(t,e){if(!X(t))return"\u2013";let r=ir(t);return`${ar(t,r)}\xA0${tt[r]}${e}`}i(st,"scaled");function ir(t){let e=0;for(;e<tt.length-1&&t/1e3**e>=999.5;)e+=1;return e}i(ir,"powerOf");function ar(t,e){let r=t/1e3**e;return r.toFixed(e>1&&r<99.95?1:0)}i(ar,"digits");function X(t){return Number.isFinite(t)&&t>=0}i(X,"isAmount");var lr={frame:"Frame",splats:"Splats",views:"Views",waiting:"Waiting",loaded:"Loaded",memory:"On the GPU",height:"Height"};function it(t,e){let r=new Map,o=Object.entries(lr).map(([h,d])=>{let u=g("dd",{},"\u2013");return r.set(h,u),g("div",{},g("dt",{},d),u)}),n=g("div",{class:"panel card",role:"region","aria-label":"Figures"}),s=Ee("Figures","chip card",()=>f(!0)),a=g("button",{type:"button","aria-label":"Hide the figures",title:"Hide"},W(B.close));a.addEventListener("click",()=>f(!1)),n.append(g("header",{},g("h1",{},"nearfar"),a),g("div",{class:"panel-body"},g("dl",{class:"figures"},...o)));let l=g("p",{class:"note card"}),c=g("div",{class:"tools"},Ee("Home","tool",e),Ee("Help","tool",()=>l.hidden=!l.hidden));l.textContent=cr,l.hidden=!0,t.append(g("div",{class:"frame"},g("div",{class:"top"},n,s),g("div",{class:"bottom"},l,c)));function f(h){n.hidden=!h,s.hidden=h}return i(f,"show"),f(window.innerWidth>600),{update({facts:h,frame:d,received:u,rate:m,height:p,power:y}){let w=i((S,M)=>De(r.get(S),M),"put");w("frame",ot(d)),w("splats",nt(h.splats)),w("views",h.standIns>0?`${h.views}, ${h.standIns} coarser`:String(h.views)),w("waiting",h.waiting>0?`${h.waiting} views`:"nothing"),w("loaded",m===null?Y(u):`${Y(u)}, ${rt(m)}`),w("memory",Y(h.bytes)),w("height",y===0?Te(p):`${Te(p)}, speed \xD7 ${(2**y).toFixed(y<0?2:1)}`)}}}i(it,"createPanel");var cr="Dragging looks around. W A S D or the left thumb fly, E and Q go up and down, arrow keys turn, Shift is four times as fast, the wheel changes the speed. The address leads back to this place.";function Ee(t,e,r){let o=g("button",{type:"button",class:e},t);return o.addEventListener("click",r),o}i(Ee,"button");function C({kind:t}){return t==="refused"||t==="unreachable"}i(C,"isPassing");var Se=["color","depth","normal"],dr="behind_";var ur="nearfar";function at({depthBits:t}){return Math.floor((2**t-1)/6)*6}i(at,"stepsOf");function z({cell:t},e){return t*2**e}i(z,"sideAt");function Q(t,e,[r,o,n]){let[s,[a,l,c]]=[z(t,e),t.origin];return[a+r*s,l+o*s,c+n*s]}i(Q,"cornerOf");function Me({subtree:t},e){return 2**(t-e%t)}i(Me,"shardSide");function J(t,e,[r,o,n]){let s=Me(t,e),a=[Math.floor(r/s),Math.floor(o/s),Math.floor(n/s)];return{tier:Math.floor(e/t.subtree),place:a}}i(J,"subtreeOf");function lt(t){return t===0?"":`${ur}/generations/${t}/`}i(lt,"overlay");function ct({names:t},e,r,o){return`${e}/${t[r]}/${o}`}i(ct,"arrayOf");function dt(t,e,r,o){return`${o}/c/${J(t,e,r).place.join("/")}/0/0/0`}i(dt,"shardOf");function ut({layers:t}){return t===2?[...Se,...Se.map(e=>dr+e)]:Se}i(ut,"channelsOf");function k(t,[e,r,o]){return`${t}/${e}/${r}/${o}`}i(k,"nameOf");function _e([t,e,r]){return Array.from({length:8},(o,n)=>[2*t+(n>>2),2*e+(n>>1&1),2*r+(n&1)])}i(_e,"childrenOf");function ht([t,e,r],o){let n=2**o;return[Math.floor(t/n),Math.floor(e/n),Math.floor(r/n)]}i(ht,"above");var hr={mask:0,generation:0},Z=class{constructor(e){this.layout=e}layout;static{i(this,"Cells")}#e=new Map;add(e){this.#e.set(k(e.tier,e.place),e)}knows(e,r){return this.#e.has(k(e,r))}at(e,r){let{tier:o,place:n}=J(this.layout,e,r),s=this.#e.get(k(o,n));if(!s)return null;let a=Me(this.layout,e),[l,c,f]=r.map((p,y)=>p-n[y]*a),h=(l*a+c)*a+f,d=e%this.layout.subtree,[u,m]=[s.masks[d]?.[h],s.generations[d]?.[h]];return u===void 0||m===void 0?hr:{mask:u,generation:m}}};var ft=3;function ke(t){let e=t[0]===0&&t[2]===0?[1,0,0]:[t[2],0,-t[0]],r=[e,xe(t,e),t],o=r.map(n=>(Math.abs(n[0])+Math.abs(n[1])+Math.abs(n[2]))/Math.hypot(...n));return{axes:[D(r[0]),D(r[1]),D(r[2])],extents:o}}i(ke,"frameOf");var[Pe,H]=[1.27,.5],Re=.25,ee=10;function mt(t,e,r,o){let n=z(t,e),s=Q(t,e,r),a=ke(t.directions[o]),l=a.extents.map(y=>y*n),c=[l[0]/t.size,l[1]/t.size,l[2]/at(t)],[f,h,d]=a.axes,u=s.map((y,w)=>y+n/2+(-f[w]*l[0]+h[w]*l[1]+d[w]*l[2])/2),m=i((y,w)=>[y[0]*w,y[1]*w,y[2]*w],"scaled"),p=[m(f,c[0]),m(h,-c[1]),m(d,-c[2])];return{frame:a,pitch:c,start:u,steps:p,normalBits:t.normalBits/2}}i(mt,"modelOf");function pt(t){let{position:e,right:r,up:o,back:n,fov:s,width:a,height:l}=t,[c,f]=[a/(s.right-s.left),l/(s.up-s.down)],h=i(p=>[p(0),p(1),p(2)],"row"),d=[h(p=>c*(r[p]+s.left*n[p])),h(p=>-f*(o[p]+s.up*n[p])),h(p=>-n[p])],u=j(t,0,0),m=i((p,y)=>{let w=j(t,p,y);return[w[0]-u[0],w[1]-u[1],w[2]-u[2]]},"step");return{eye:e,rows:d,rays:[u,m(1,0),m(0,1)],width:a,height:l}}i(pt,"projectorOf");function bt(t,{eye:e,rows:r}){let{start:o,steps:n,pitch:s}=t,a=[o[0]-e[0],o[1]-e[1],o[2]-e[2]],l=i(u=>[F(r[0],u),F(r[1],u),F(r[2],u)],"along"),[c,f]=[Pe*Math.sqrt(H),yt(t)],h=i(u=>Math.max(c,f/u)-.5,"across"),d=c*(s[0]+s[1])/Re;return{start:l(a),steps:[l(n[0]),l(n[1]),l(n[2])],least:Math.max(s[0],s[1]),margin:[h(s[0]),h(s[1]),Math.max(d,f)/s[2]]}}i(bt,"sightOf");function yt({pitch:t}){return Math.hypot(t[0],t[1])/2}i(yt,"ballOf");function wt({start:t,steps:e,least:r,margin:o},{low:n,high:s},a,l){let[c,f,h,d,u]=[!0,!0,!0,!0,!0];for(let m=0;m<8;m++){let p=n.map((T,R)=>m>>R&1?s[R]+o[R]:T-o[R]),y=i(T=>t[T]+p[0]*e[0][T]+p[1]*e[1][T]+p[2]*e[2][T],"value"),[w,S,M]=[y(0),y(1),y(2)];c&&=w<-M,f&&=w>(a+1)*M,h&&=S<-M,d&&=S>(l+1)*M,u&&=M<r}return!(c||f||h||d||u)}i(wt,"isSeen");function vt(t,{low:e,high:r}){return t.every(([o,n,s,a])=>{let l=[o,n,s].map((f,h)=>{let[d,u]=[f*e[h],f*r[h]];return[Math.min(d,u),Math.max(d,u)]}),c=i(f=>l.reduce((h,d)=>h+d[f],a),"sum");return c(0)<1&&c(1)>=0})}i(vt,"isIn");function gt(t,e,r){if(!r)return[0,1,2].map(()=>[0,0,0,.5]);let o=z(e,r.level),n=Q(e,r.level,r.place);return[0,1,2].map(s=>{let a=i(l=>t.steps[l][s]/o,"factor");return[a(0),a(1),a(2),(t.start[s]-n[s])/o]})}i(gt,"rowsOf");function xt(t,e,r,o){let{frame:n,pitch:s}=e,[a,l,c]=n.axes,f=2/(2**e.normalBits-2),h=i((u,[m,p,y],w)=>t.set([m,p,y,w],4*u),"put"),d=i((u,m)=>[u[0]*m,u[1]*m,u[2]*m],"scaled");h(0,r.start,r.least),h(1,r.steps[0],f),h(2,r.steps[1],yt(e)/Math.sqrt(H)),h(3,r.steps[2],0),h(4,d(a,s[0]/s[2]),0),h(5,d(l,s[1]/s[2]),0),h(6,c,0),o.forEach((u,m)=>t.set(u,4*(7+m)))}i(xt,"writeView");function Ae(t,e,r){let o=t.createProgram();for(let[s,a]of[[t.VERTEX_SHADER,e],[t.FRAGMENT_SHADER,r]]){let l=t.createShader(s);if(!l)throw new Error("the browser has taken the graphics away");t.shaderSource(l,a),t.compileShader(l),t.attachShader(o,l),t.deleteShader(l)}if(t.linkProgram(o),!t.getProgramParameter(o,t.LINK_STATUS)){let s=(t.getAttachedShaders(o)??[]).map(a=>t.getShaderInfoLog(a));throw new Error(`a shader does not compile: ${[...s,t.getProgramInfoLog(o)].filter(Boolean).join(" ")}`)}let n=new Map;return{program:o,at(s){return n.has(s)||n.set(s,t.getUniformLocation(o,s)),n.get(s)??null}}}i(Ae,"programOf");function Tt(t,e,r){let[o,n,s]=[t.createFramebuffer(),t.createTexture(),t.createRenderbuffer()];return t.bindTexture(t.TEXTURE_2D,n),t.texStorage2D(t.TEXTURE_2D,1,t.SRGB8_ALPHA8,e,r),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,t.NEAREST),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,t.NEAREST),t.bindRenderbuffer(t.RENDERBUFFER,s),t.renderbufferStorage(t.RENDERBUFFER,t.DEPTH_COMPONENT32F,e,r),t.bindFramebuffer(t.FRAMEBUFFER,o),t.framebufferTexture2D(t.FRAMEBUFFER,t.COLOR_ATTACHMENT0,t.TEXTURE_2D,n,0),t.framebufferRenderbuffer(t.FRAMEBUFFER,t.DEPTH_ATTACHMENT,t.RENDERBUFFER,s),t.bindFramebuffer(t.FRAMEBUFFER,null),{frame:o,color:n,width:e,height:r,dispose(){t.deleteFramebuffer(o),t.deleteTexture(n),t.deleteRenderbuffer(s)}}}i(Tt,"targetOf");var Et=`// The morph of nearfar in GLSL: where the user is shown a point of the world. Licence: MIT or Apache-2.0.
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
`;var fr=`
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`,mr=`
// The eye, from the centre: each eye of a headset has its own.
uniform vec3 cameraPosition;
// r1, r2, 1 / (r2 - r1), and the strength of the morph; a strength below 0 stands for no morph at all.
uniform vec4 radii;

bool is_morphed() {
  return radii.w >= 0.0;
}
`,St=`
vec3 srgb_of(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
`,no=fr+Et+mr;var re=`#version 300 es
precision highp float;
precision highp int;
`,te=i(t=>Number.isInteger(t)?t.toFixed(1):String(t),"float"),pr=`
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
`,Mt=`${re}
layout(location = 0) in uvec3 splat;
uniform vec4 view[${ee}];
// The camera's gradients of X, Y and W, and the rays through the corner, a sample to the right and one down.
uniform vec3 gradients[3];
uniform vec3 rays[3];
// Width and height of the picture in samples, and the greatest size of a point.
uniform vec3 screen;
flat out vec4 v_inverse;
flat out vec2 v_middle;
flat out vec3 v_nearness;
flat out vec3 v_color;
const float RADIUS = ${te(Math.sqrt(H))};
const vec4 NOWHERE = vec4(2.0, 2.0, 2.0, 1.0);
${pr}
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
  float facing = 1.0 / max(dot(view[6].xyz, normal), ${te(Re)});
  vec3 u = view[1].xyz + dot(view[4].xyz, normal) * facing * view[3].xyz;
  vec3 v = view[2].xyz - dot(view[5].xyz, normal) * facing * view[3].xyz;
  bool is_surfel = (splat.z >> 24 & 1u) == 1u;
  float factor = is_surfel ? ((splat.z >> 25 & 1u) == 1u ? 1.0 : ${te(Pe)}) : 0.0;

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
`,_t=`${re}
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
  bool is_inside = dot(q, q) <= ${te(H)};
  // The sample that holds a splat's middle always belongs to it.
  if (!is_inside && any(notEqual(floor(at), floor(v_middle)))) {
    discard;
  }
  float nearness = v_nearness.x + (is_inside ? dot(v_nearness.yz, p) : 0.0);
  // Exact on a plane. What is nearer has more, so that float32 keeps its digits far away.
  gl_FragDepth = nearest * nearness;
  shade = vec4(v_color, 1.0);
}
`,kt=`${re}
void main() {
  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
`,Pt=`${re}
uniform sampler2D samples;
// Samples along each axis of a pixel.
uniform int grid;
uniform vec3 screen;
uniform vec3 rays[3];
out vec4 shade;
${St}
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
`;var ne=class{constructor(e,r){this.canvas=e;this.layout=r;let o=e.getContext("webgl2",{alpha:!1,antialias:!1,depth:!1});if(!o)throw new Error("this browser has no WebGL 2");this.#e=o,this.#r=Ae(this.#e,Mt,_t),this.#t=Ae(this.#e,kt,Pt),this.#n=this.#e.getParameter(this.#e.ALIASED_POINT_SIZE_RANGE)[1]??1}canvas;layout;static{i(this,"Drawer")}#e;#r;#t;#i=new Float32Array(4*ee);#n;#o=null;#s=null;upload(e,{words:r,parts:o}){let n=this.#e,[s,a]=[n.createVertexArray(),n.createBuffer()];return n.bindVertexArray(s),n.bindBuffer(n.ARRAY_BUFFER,a),n.bufferData(n.ARRAY_BUFFER,r,n.STATIC_DRAW),n.enableVertexAttribArray(0),n.vertexAttribIPointer(0,ft,n.UNSIGNED_INT,0,0),n.bindVertexArray(null),{model:e,parts:o,array:s,buffer:a,bytes:r.byteLength}}drop({array:e,buffer:r}){this.#e.deleteVertexArray(e),this.#e.deleteBuffer(r)}draw(e,r,o){let n=this.#e,s={...r,width:r.width*o,height:r.height*o},a=pt(s),l=this.#c(s.width,s.height);n.bindFramebuffer(n.FRAMEBUFFER,l.frame),n.viewport(0,0,l.width,l.height),n.enable(n.DEPTH_TEST),n.depthFunc(n.GREATER),n.clearColor(0,0,0,0),n.clearDepth(0),n.clear(n.COLOR_BUFFER_BIT|n.DEPTH_BUFFER_BIT),n.useProgram(this.#r.program);let c=Math.min(...e.map(({layer:d})=>Math.max(d.model.pitch[0],d.model.pitch[1])),1e6);this.#a(this.#r,a),n.uniform1f(this.#r.at("nearest"),c/2);let[f,h]=[0,0];for(let d of e){let u=this.#d(d,a);f+=u.splats,h+=u.calls}return n.bindVertexArray(null),this.#l(l,a,r,o),{splats:f,calls:h}}get isDone(){let e=this.#e;return this.#s&&e.getSyncParameter(this.#s,e.SYNC_STATUS)!==e.SIGNALED?!1:(e.deleteSync(this.#s),this.#s=null,!0)}finish(){this.#e.readPixels(0,0,1,1,this.#e.RGBA,this.#e.UNSIGNED_BYTE,new Uint8Array(4))}#d({layer:e,box:r},o){let n=this.#e,s=bt(e.model,o),a=gt(e.model,this.layout,r),l=e.parts.filter(h=>wt(s,h,o.width,o.height)&&(!r||vt(a,h)));if(l.length===0)return{splats:0,calls:0};xt(this.#i,e.model,s,a),n.uniform4fv(this.#r.at("view"),this.#i),n.bindVertexArray(e.array);let[c,f]=[0,0];for(let h=0;h<l.length;){let{first:d}=l[h],u=d;for(;l[h]?.first===u;h++)u+=l[h].count;n.drawArrays(n.POINTS,d,u-d),c+=u-d,f+=1}return{splats:c,calls:f}}#a(e,{rows:r,rays:o,width:n,height:s}){let a=this.#e;a.uniform3fv(e.at("gradients"),r.flat()),a.uniform3fv(e.at("rays"),o.flat()),a.uniform3f(e.at("screen"),n,s,this.#n)}#l(e,r,{width:o,height:n},s){let a=this.#e;a.bindFramebuffer(a.FRAMEBUFFER,null),a.viewport(0,0,o,n),a.disable(a.DEPTH_TEST),a.useProgram(this.#t.program),this.#a(this.#t,r),a.uniform1i(this.#t.at("grid"),s),a.activeTexture(a.TEXTURE0),a.bindTexture(a.TEXTURE_2D,e.color),a.uniform1i(this.#t.at("samples"),0),a.drawArrays(a.TRIANGLES,0,3),a.deleteSync(this.#s),this.#s=a.fenceSync(a.SYNC_GPU_COMMANDS_COMPLETE,0),a.flush()}#c(e,r){return(this.#o?.width!==e||this.#o.height!==r)&&(this.#o?.dispose(),this.#o=Tt(this.#e,e,r)),this.#o}};var[br,yr]=[1,30],Rt="",oe=class{constructor(e){this.settings=e}settings;static{i(this,"Queue")}#e=new Map;#r=new Map;#t=new Set;#i=new Map;#n=0;get waiting(){return[...this.#i.keys()].filter(e=>this.#r.get(e)?.again!==Number.POSITIVE_INFINITY).length}want(e){this.#i=e;for(let[r,o]of this.#e)o.isCancelled||e.has(o.name)||(o.isCancelled=!0,this.settings.cancel(r));this.fill()}fill(){let e=new Set([...this.#e.values()].map(({name:o})=>o)),r=this.settings.now();for(let[o,n]of this.#i){if(this.#e.size>=this.settings.atOnce)return;if(e.has(o)||(this.#r.get(o)?.again??0)>r)continue;let s=++this.#n;this.#e.set(s,{name:o,job:n,isCancelled:!1}),this.settings.send(s,n)}}done(e){let r=this.#o(e);return r&&(this.#r.delete(r.name),this.#i.delete(r.name),this.#t.delete(Rt)&&this.settings.recovered()),r?.job??null}cancelled(e){this.#o(e),this.fill()}failed(e,r){let o=this.#o(e);if(o){let n=Math.min(2*(this.#r.get(o.name)?.pause??br/2),yr),s=C(r)?this.settings.now()+n:Number.POSITIVE_INFINITY;this.#r.set(o.name,{again:s,pause:n});let a=C(r)?Rt:r.message;this.#t.has(a)||this.settings.failed(r),this.#t.add(a)}this.fill()}retry(){this.#r.clear(),this.#t.clear(),this.fill()}#o(e){let r=this.#e.get(e);return this.#e.delete(e),r??null}};function At(t,e,r,o,n){let s=new Map,a=Array.from({length:e},()=>new Worker(t,{type:"module"}));for(let l of a)l.onmessage=({data:c})=>{switch(c.kind){case"view":s.delete(c.id),n.view(c.id,c.layers);break;case"failed":s.delete(c.id),n.failed(c.id,c.failure);break;case"cancelled":s.delete(c.id),n.cancelled(c.id);break;case"received":n.received(c.bytes)}},l.onerror=({message:c})=>{let f={kind:"other",message:`a worker stopped: ${c||"the browser gives no reason"}`};for(let[h,d]of s)d===l&&n.failed(h,f)},Le(l,{kind:"open",base:r.href,layout:o});return{read(l,c){let f=a[wr(c.shards[0]?.[0]??"")%a.length];s.set(l,f),Le(f,{kind:"read",id:l,wanted:c})},cancel(l){let c=s.get(l);c&&Le(c,{kind:"cancel",id:l})}}}i(At,"startReaders");function Le(t,e){t.postMessage(e)}i(Le,"send");function wr(t){let e=2166136261;for(let r=0;r<t.length;r++)e=Math.imul(e^t.charCodeAt(r),16777619);return e>>>0}i(wr,"hash");var se=class{constructor(e,r,o){this.layout=e;this.uploader=r;this.most=o}layout;uploader;most;static{i(this,"Resident")}#e=new Map;#r=new Map;#t=0;bytes=0;get count(){return this.#e.size}add(e,r,o,n){let s=`${k(e,r)}/${o}`;if(this.#e.has(s))return;let a=mt(this.layout,e,r,o),l=n.map(f=>this.uploader.upload(a,f)),c=l.reduce((f,h)=>f+h.bytes,0);this.#e.set(s,{level:e,place:r,direction:o,layers:l,bytes:c,used:this.#t}),this.#r.set(k(e,r),[...this.there(e,r),o]),this.bytes+=c}there(e,r){return this.#r.get(k(e,r))??[]}begin(){this.#t+=1}use(e,r,o){let n=`${k(e,r)}/${o}`,s=this.#e.get(n);return s?(s.used!==this.#t&&(s.used=this.#t,this.#e.delete(n),this.#e.set(n,s)),s.layers):[]}trim(e){for(let[r,o]of this.#e){if(this.bytes<=this.most)break;o.used===this.#t||e(o.level,o.place)||this.#i(r,o)}}#i(e,{level:r,place:o,direction:n,layers:s,bytes:a}){s.forEach(f=>this.uploader.drop(f)),this.#e.delete(e),this.bytes-=a;let l=k(r,o),c=this.there(r,o).filter(f=>f!==n);c.length>0?this.#r.set(l,c):this.#r.delete(l)}};function Lt(t,{views:e}){let[r,o]=[0,t];for(;o!==0;o&=o-1)r+=1;return Math.min(r,e)}i(Lt,"countOf");var vr=3;function Ot({cells:t},e,r,o){let n=[],s=[],a=0,l=i((d,u,m=null)=>r(d,u).map(p=>({level:d,place:u,direction:p,box:m})),"all"),c=i((d,u)=>{let m=e.at(d,u)?.mask??0;return m!==0&&r(d,u).length>=Lt(m,{views:o})},"isFull");function f(d,u,m){if(d===0||m===0)return null;let p=[];for(let y of _e(u)){let w=e.at(d-1,y);if(!w)return null;if(w.mask===0)continue;let S=c(d-1,y)?l(d-1,y).slice(-o):f(d-1,y,m-1);if(!S)return null;p.push(...S)}return p}i(f,"below");function h(d){let u=[];for(let m=d.level+1;m<e.layout.levels;m++){let p=ht(d.place,m-d.level),y={level:d.level,place:d.place};if(c(m,p))return l(m,p,y).slice(-o);u.length===0&&(u=l(m,p,y))}return u}i(h,"standIn");for(let d of t){let{level:u,place:m,directions:p}=d,y=new Set(r(u,m)),w=p.filter(T=>y.has(T));for(let T of p)y.has(T)||s.push({level:u,place:m,direction:T});if(w.length===p.length){n.push(...w.map(T=>({level:u,place:m,direction:T,box:null})));continue}let S=c(u,m)?gr(w,y,p.length):null;if(S){n.push(...S.map(T=>({level:u,place:m,direction:T,box:null})));continue}let M=f(u,m,vr)??h(d);M.length===0&&(M=l(u,m)),M.length===0&&(a+=1),n.push(...M)}return{shown:xr(n),missing:s,holes:a}}i(Ot,"choose");function gr(t,e,r){let o=[...e].filter(n=>!t.includes(n));return[...t,...o.slice(o.length-(r-t.length))]}i(gr,"fill");function xr(t){let e=new Map;for(let r of t){let o=r.box?k(r.box.level,r.box.place):"";e.set(`${k(r.level,r.place)}/${r.direction}/${o}`,r)}return[...e.values()]}i(xr,"unique");var Tr=6,[Er,Sr]=[50,.5],Mr={views:0,standIns:0,waiting:0,holes:0,splats:0,calls:0,bytes:0,kept:0,isComplete:!1},ie=class{constructor(e,r){this.canvas=e;this.#e=r,this.#r=new Worker(r.scripts.cutter,{type:"module"}),this.#r.onmessage=({data:o})=>this.#T(o),this.#r.onerror=({message:o})=>r.failed({kind:"other",message:`a worker stopped: ${o}`},!0),this.#t=new oe({atOnce:Tr*r.workers,send:i((o,n)=>this.#o?.read(o,n),"send"),cancel:i(o=>this.#o?.cancel(o),"cancel"),failed:i(o=>r.failed(o,!1),"failed"),recovered:r.recovered,now:i(()=>performance.now()/1e3,"now")}),this.#b({kind:"open",base:r.base.href})}canvas;static{i(this,"Viewer")}#e;#r;#t;#i=new Map;#n=null;#o=null;#s=null;#d=null;#a=null;#l=!1;#c=!1;#h=!0;#u=!0;#f=0;#m=0;#p=!1;facts=Mr;frame(e){if(!this.#n||((!this.#a||!_r(this.#a,e))&&(this.#a=e,this.#c=this.#h=!0),this.#c&&!this.#l&&this.#x(e),this.#t.fill(),!this.#s||!this.#g(this.#n.drawer)))return!1;let r=performance.now()-this.#m>=Math.max(Er,this.took/Sr-this.took);return this.#h||this.#u&&(r||this.#t.waiting===0)?(this.#v(e),!0):!1}get took(){return Math.max(this.#m-this.#f,0)}time(){return!this.#a||!this.#n?0:(this.#v(this.#a),this.#n.drawer.finish(),performance.now()-this.#f)}#g(e){return this.#p?e.isDone?(this.#m=performance.now(),this.#p=!1,!0):!1:!0}retry(){this.#t.retry(),this.#b({kind:"retry"})}#x(e){let{views:r,error:o}=this.#e,n={views:r,error:o,isAround:!1};[this.#l,this.#c]=[!0,!1],this.#b({kind:"look",camera:e,settings:n})}#T(e){switch(e.kind){case"opened":this.#E(e.layout,e.shards);break;case"learned":this.#n?.cells.add(e.subtree),this.#y(e.subtree.shards);break;case"base":this.#d=e.cut;break;case"cut":this.#s=e.cut,this.#l=!1,this.#u=!0,this.#S();break;case"received":this.#e.received(e.bytes);break;case"failed":this.#e.failed(e.failure,e.isFatal)}}#E(e,r){let o=new ne(this.canvas,e);this.#n={cells:new Z(e),drawer:o,resident:new se(e,o,this.#e.bytes)},this.#y(r);let{scripts:n,workers:s,base:a}=this.#e;this.#o=At(n.reader,s,a,e,{view:i((l,c)=>{let f=this.#t.done(l);f&&this.#n?.resident.add(f.level,f.place,f.direction,c),this.#u=!0,this.#t.fill()},"view"),failed:i((l,c)=>this.#t.failed(l,c),"failed"),cancelled:i(l=>this.#t.cancelled(l),"cancelled"),received:this.#e.received}),this.#e.opened(e)}#y(e){for(let r of e)this.#i.set(r[0],r)}#w(e){let{cells:r,resident:o}=this.#n;return Ot(e,r,(n,s)=>o.there(n,s),this.#e.views)}#v(e){if(!this.#n||!this.#s)return;let{drawer:r,resident:o}=this.#n;this.#h=this.#u=!1,this.#f=performance.now(),this.#p=!0;let n=this.#w(this.#s);o.begin();let s=n.shown.flatMap(({level:d,place:u,direction:m,box:p})=>o.use(d,u,m).map(y=>({layer:y,box:p}))),{splats:a,calls:l}=r.draw(s,e,this.#e.grid),c=new Set(this.#d?.cells.map(({level:d,place:u})=>k(d,u)));o.trim((d,u)=>c.has(k(d,u)));let[{waiting:f},h]=[this.#t,!this.#l&&!this.#c];this.facts={views:n.shown.length,standIns:n.shown.filter(({box:d})=>d!==null).length,waiting:f,holes:n.holes,splats:a,calls:l,bytes:o.bytes,kept:o.count,isComplete:h&&f===0&&this.#s.unknown.length===0}}#S(){let e=[this.#d,this.#s].flatMap(o=>o?this.#w(o).missing:[]),r=new Map;for(let{level:o,place:n,direction:s}of e){let a=`${k(o,n)}/${s}`;r.has(a)||r.set(a,this.#M(o,n,s))}this.#t.want(r)}#M(e,r,o){let{cells:n}=this.#n,s=n.at(e,r)?.generation??0,a=ut(n.layout).map(l=>{let c=ct(n.layout,e,o,l);return this.#i.get(lt(s)+dt(n.layout,e,r,c))});return{level:e,place:r,direction:o,generation:s,shards:a.filter(l=>l!==void 0)}}#b(e){this.#r.postMessage(e)}};function _r(t,e){let r=i(({position:n,right:s,up:a,fov:l,width:c,height:f})=>[...n,...s,...a,...Object.values(l),c,f],"numbers"),o=r(e);return r(t).every((n,s)=>n===o[s])}i(_r,"isSame");var kr=Math.PI/3,Pr=1.5,[Nt,Rr]=[.25,.5],Ft=1<<29;function Ar(){let t=new URLSearchParams(location.search),[e,r]=[Ct("canvas",HTMLCanvasElement),Ct("#ui",HTMLElement)],o=Math.min(screen.width,screen.height)<600,n=Ce(),s=i(({kind:v,message:x})=>{let{title:E,text:_}=It[v];be(E,_,{detail:x,retry:i(()=>location.reload(),"retry")})},"fatal"),a=[],l=i(v=>{a=v,ze(a.map(({message:x})=>x),y)},"show"),c=new ie(e,{base:Nr(new URL(t.get("store")??".",location.href)),scripts:{cutter:new URL("orthoview-cut.js",import.meta.url),reader:new URL("orthoview-read.js",import.meta.url)},views:ae(t,"views",3,1,8),error:ae(t,"error",1,.1,64),grid:Math.round(Math.sqrt(ae(t,"samples",1,1,16))),bytes:ae(t,"megabytes",(o?Ft/4:Ft)>>20,1,16384)*2**20,workers:Math.min(Math.max((navigator.hardwareConcurrency||2)-1,1),4),received:n.receive,opened:p,failed(v,x){if(x){s(v);return}let E=C(v)?{...v,message:`${v.message}; ${Lr}`}:v;a.some(({kind:P,message:A})=>C(E)?P===E.kind:A===E.message)||l([...a,E])},recovered:i(()=>l(a.filter(v=>!C(v))),"recovered")}),[f,h]=[0,{position:[0,0,0],yaw:0,pitch:0}],d=fe(location.hash),u=Je(e,d??h,()=>f,Ge(r).show),m=it(r,()=>u.setPose(h));window.addEventListener("hashchange",()=>u.setPose(fe(location.hash)??u.pose)),e.addEventListener("webglcontextlost",()=>s({kind:"other",message:Or}));function p(v){f=v.origin[1],h=Ze(v),d||u.setPose(h),R=!0}i(p,"opened");function y(){l([]),c.retry()}i(y,"retry");let[w,S,M]=[performance.now(),Nt,0],[T,R]=["",!1];window.orthoview={get facts(){return c.facts},get pose(){return u.pose},get received(){return n.read().received},setPose:u.setPose,time:i(()=>c.time(),"time")};function b(v){let x=Math.max(v-w,0)/1e3;w=v;let E=u.update(x),_=Math.min(window.devicePixelRatio||1,Pr),[P,A]=[e.clientWidth,e.clientHeight].map(le=>Math.max(Math.round(le*_),1));if((e.width!==P||e.height!==A)&&([e.width,e.height]=[P,A]),c.frame(et(E,kr,e.width,e.height)),S+=x,M+=x,S>=Nt){S=0;let{received:le,rate:Dt}=n.read();m.update({facts:c.facts,frame:c.took,received:le,rate:Dt,height:E.position[1]-f,power:u.power})}let L=Fe(E);R&&M>=Rr&&L!==T&&([M,T]=[0,L],history.replaceState(null,"",L)),requestAnimationFrame(b)}i(b,"frame"),requestAnimationFrame(b)}i(Ar,"main");var Lr="what has come stays, and the rest is asked for again",Or="The browser has taken the graphics away.",It={gone:{title:"There is no tree at this address",text:"The page shows the store of orthoviews in whose folder it lies, or the one that ?store= names."},refused:{title:"The server refuses the tree",text:"Tell whoever runs the server what stands below."},unreachable:{title:"The tree cannot be reached",text:"Check the connection and the address, and try again."},damaged:{title:"The tree is damaged",text:"A file is not what the build has written. Check it with nearfar orthoview verify."},newer:{title:"The tree needs a newer nearfar",text:"It was written in a later format than this page reads."},other:{title:"The tree cannot be shown",text:"Reload the page. If that does not help, tell whoever sent you here what stands below."}};function Nr(t){return t.pathname.endsWith("/")||(t.pathname+="/"),t.hash="",t}i(Nr,"folderOf");function ae(t,e,r,o,n){let s=t.get(e),a=s===null||s===""?r:Number(s);return Number.isFinite(a)?Math.min(Math.max(a,o),n):r}i(ae,"number");function Ct(t,e){let r=document.querySelector(t);if(!(r instanceof e))throw new Error(`the page has no ${t}`);return r}i(Ct,"element");try{Ar()}catch(t){let{title:e,text:r}=It.other;be(e,r,{detail:t instanceof Error?t.message:String(t)})}
