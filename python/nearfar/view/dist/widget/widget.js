var Gd=Object.defineProperty;var o=(i,e)=>Gd(i,"name",{value:e,configurable:!0});var Yc='var Ee=Object.defineProperty;var s=(a,e)=>Ee(a,"name",{value:e,configurable:!0});function Re(a){return Array.from(a,e=>e.toString(16).padStart(2,"0")).join("")}s(Re,"hexOf");async function xa(a){return globalThis.crypto?.subtle?Re(new Uint8Array(await crypto.subtle.digest("SHA-256",a))):null}s(xa,"sha256");async function U(a){let{name:e,data:r,bytes:b,sha256:n}=a;if(r.byteLength!==b)throw new Error(`${e}: expected ${b} bytes, as the manifest lists it, got ${r.byteLength}`);let t=await xa(r);if(t!==null&&t!==n)throw new Error(`${e}: expected SHA-256 ${n.slice(0,16)}\\u2026, got ${t.slice(0,16)}\\u2026`);return new Uint8Array(r)}s(U,"contentOf");function L(a){return a instanceof Error?a.message:String(a)}s(L,"reasonOf");async function ta(a,e,r){let b=[],n=0;try{let o=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate"));for(let d=o.getReader();;){let{done:l,value:f}=await d.read();if(l)break;if(b.push(f),n+=f.length,n>r)throw await d.cancel(),new Error(`more than ${r} bytes`)}}catch(o){throw new Error(`${a}: expected compressed ranges, got ${L(o)}`)}let t=new Uint8Array(n),c=0;for(let o of b)t.set(o,c),c+=o.length;return t}s(ta,"inflated");var ca=(function(){var a="b9H79Tebbbe8Fv9Gbb9Gvuuuuueu9Giuuub9Geueu9Giuuueuixkbeeeddddillviebeoweuecj:Gdkr;Neqo9TW9T9VV95dbH9F9F939H79T9F9J9H229F9Jt9VV7bb8A9TW79O9V9Wt9F9KW9J9V9KW9wWVtW949c919M9MWVbeY9TW79O9V9Wt9F9KW9J9V9KW69U9KW949c919M9MWVbdE9TW79O9V9Wt9F9KW9J9V9KW69U9KW949tWG91W9U9JWbiL9TW79O9V9Wt9F9KW9J9V9KWS9P2tWV9p9JtblK9TW79O9V9Wt9F9KW9J9V9KWS9P2tWV9r919HtbvL9TW79O9V9Wt9F9KW9J9V9KWS9P2tWVT949WboY9TW79O9V9Wt9F9KW9J9V9KWS9P2tWVJ9V29VVbrl79IV9Rbwq;X8:kdbk:kYi5ud9:du8Jjjjjbcjq9Rgv8Kjjjjbc9:hodnalTmbcuhoaiRbbgrc;WeGc:Ge9hmbarcsGgwce0mbc9:hoalcufadcd4cbawEgDadfgrcKcaawEgqaraq0Egk6mbaicefhxcj;abad9Uc;WFbGcjdadca0EhmaialfgPar9Rgoadfhsavaoadz:jjjjbgzceVhHcbhOdndninaeaO9nmeaPax9RaD6mdamaeaO9RaOamfgoae6EgAcsfglc9WGhCaAcethXaxaDfhiaOaeaoaeao6E9RhQalcl4cifcd4hLazcjdfaAfhKcbhYabaOad2fg8AhEaHh3incbh5dnawTmbaxaYcd4fRbbh5kcbh8Eazcjdfhqinaih8Fdndndndna5a8Ecet4ciGgoc9:fPdebdkaPa8F9RaA6mrazcjdfa8EaA2fa8FaAz:jjjjb8Aa8FaAfhixdkazcjdfa8EaA2fcbaAz:kjjjb8Aa8FhixekaPa8F9RaL6mva8FaLfhidnaCTmbaPai9RcK6mbaocdtc:q:G:cjbfcj:G:cjbawEhaczhrcbhlinargoc9Wfghaqfhrdndndndndndnaaa8Fahco4fRbbalcoG4ciGcdtfydbPDbedvivvvlvkar9cb83bwar9cb83bbxlkarcbaiRbdai8Xbb9c:c:qj:bw9:9c:q;c1:I1e:d9c:b:c:e1z9:gg9cjjjjjz:dg8J9qE86bbaqaofgrcGfcbaicdfa8J9c8N1:NfghRbbag9cjjjjjw:dg8J9qE86bbarcVfcbaha8J9c8M1:NfghRbbag9cjjjjjl:dg8J9qE86bbarc7fcbaha8J9c8L1:NfghRbbag9cjjjjjd:dg8J9qE86bbarctfcbaha8J9c8K1:NfghRbbag9cjjjjje:dg8J9qE86bbarc91fcbaha8J9c8J1:NfghRbbag9cjjjj;ab:dg8J9qE86bbarc4fcbaha8J9cg1:NfghRbbag9cjjjja:dg8J9qE86bbarc93fcbaha8J9ch1:NfghRbbag9cjjjjz:dgg9qE86bbarc94fcbahag9ca1:NfghRbbai8Xbe9c:c:qj:bw9:9c:q;c1:I1e:d9c:b:c:e1z9:gg9cjjjjjz:dg8J9qE86bbarc95fcbaha8J9c8N1:NfgiRbbag9cjjjjjw:dg8J9qE86bbarc96fcbaia8J9c8M1:NfgiRbbag9cjjjjjl:dg8J9qE86bbarc97fcbaia8J9c8L1:NfgiRbbag9cjjjjjd:dg8J9qE86bbarc98fcbaia8J9c8K1:NfgiRbbag9cjjjjje:dg8J9qE86bbarc99fcbaia8J9c8J1:NfgiRbbag9cjjjj;ab:dg8J9qE86bbarc9:fcbaia8J9cg1:NfgiRbbag9cjjjja:dg8J9qE86bbarcufcbaia8J9ch1:NfgiRbbag9cjjjjz:dgg9qE86bbaiag9ca1:NfhixikaraiRblaiRbbghco4g8Ka8KciSg8KE86bbaqaofgrcGfaiclfa8Kfg8KRbbahcl4ciGg8La8LciSg8LE86bbarcVfa8Ka8Lfg8KRbbahcd4ciGg8La8LciSg8LE86bbarc7fa8Ka8Lfg8KRbbahciGghahciSghE86bbarctfa8Kahfg8KRbbaiRbeghco4g8La8LciSg8LE86bbarc91fa8Ka8Lfg8KRbbahcl4ciGg8La8LciSg8LE86bbarc4fa8Ka8Lfg8KRbbahcd4ciGg8La8LciSg8LE86bbarc93fa8Ka8Lfg8KRbbahciGghahciSghE86bbarc94fa8Kahfg8KRbbaiRbdghco4g8La8LciSg8LE86bbarc95fa8Ka8Lfg8KRbbahcl4ciGg8La8LciSg8LE86bbarc96fa8Ka8Lfg8KRbbahcd4ciGg8La8LciSg8LE86bbarc97fa8Ka8Lfg8KRbbahciGghahciSghE86bbarc98fa8KahfghRbbaiRbigico4g8Ka8KciSg8KE86bbarc99faha8KfghRbbaicl4ciGg8Ka8KciSg8KE86bbarc9:faha8KfghRbbaicd4ciGg8Ka8KciSg8KE86bbarcufaha8KfgrRbbaiciGgiaiciSgiE86bbaraifhixdkaraiRbwaiRbbghcl4g8Ka8KcsSg8KE86bbaqaofgrcGfaicwfa8Kfg8KRbbahcsGghahcsSghE86bbarcVfa8KahfghRbbaiRbeg8Kcl4g8La8LcsSg8LE86bbarc7faha8LfghRbba8KcsGg8Ka8KcsSg8KE86bbarctfaha8KfghRbbaiRbdg8Kcl4g8La8LcsSg8LE86bbarc91faha8LfghRbba8KcsGg8Ka8KcsSg8KE86bbarc4faha8KfghRbbaiRbig8Kcl4g8La8LcsSg8LE86bbarc93faha8LfghRbba8KcsGg8Ka8KcsSg8KE86bbarc94faha8KfghRbbaiRblg8Kcl4g8La8LcsSg8LE86bbarc95faha8LfghRbba8KcsGg8Ka8KcsSg8KE86bbarc96faha8KfghRbbaiRbvg8Kcl4g8La8LcsSg8LE86bbarc97faha8LfghRbba8KcsGg8Ka8KcsSg8KE86bbarc98faha8KfghRbbaiRbog8Kcl4g8La8LcsSg8LE86bbarc99faha8LfghRbba8KcsGg8Ka8KcsSg8KE86bbarc9:faha8KfghRbbaiRbrgicl4g8Ka8KcsSg8KE86bbarcufaha8KfgrRbbaicsGgiaicsSgiE86bbaraifhixekarai8Pbw83bwarai8Pbb83bbaiczfhikdnaoaC9pmbalcdfhlaoczfhraPai9RcL0mekkaoaC6moaimexokaCmva8FTmvkaqaAfhqa8Ecefg8Ecl9hmbkdndndndnawTmbasaYcd4fRbbgociGPlbedrbkaATmdazaYfh8Fazcjdfhhcbh8EaEhaina8FRbbhraahocbhlinaoahalfRbbgqce4cbaqceG9R7arfgr86bbaoadfhoaAalcefgl9hmbkaacefhaa8Fcefh8FahaAfhha8Ecefg8Ecl9hmbxikkaATmeazaYfhaazcjdfhhcbhoceh8EaKh8FinaEaofhlaa8Vbbhrcbhoinala8FaofRbbcwtahaofRbbgqVc;:FiGce4cbaqceG9R7arfgr87bbaladfhlaQaocefgofmbka8FaXfh8FcdhoaacdfhaahaXfhha8EceGhlcbh8EalmbxdkkaATmbaocl4h8EazaYfRbbhqcwhoa3hlinalRbbaotaqVhqalcefhlaocwfgoca9hmbkcbhhaEh8FaKhainazcjdfahfRbbhrcwhoaahlinalRbbaotarVhralaAfhlaocwfgoca9hmbkara8E94aq7hqcbhoa8Fhlinalaqao486bbalcefhlaocwfgoca9hmbka8Fadfh8FaacefhaahcefghaA9hmbkkaEclfhEa3clfh3aYclfgYad6mbkaza8AaAcufad2fadz:jjjjb8AaAaOfhOaihxaimbkc9:hoxdkcbc99aPax9RakSEhoxekc9:hokavcjqf8Kjjjjbaok:bsesu8Jjjjjbc;ae9Rgv8Kjjjjbc9:hodnalaeci9UgrcHf6mbcuhoaiRbbgwc;WeGc;Ge9hmbawcsGgwce0mbavc;abfcFecjez:kjjjb8Aav9cu83iUav9cu83i8Wav9cu83iyav9cu83iaav9cu83iKav9cu83izav9cu83iwav9cu83ibaialfc9WfhDaicefgiarfhqdndnaeci9pmbaqhexekcmcsawceSEhkcbhxcbhmaqhecbhlcbhoindndnaiRbbgrc;Ve0mbavc;abfaoarcu7gPcl4fcsGcitfgwydlhsawydbhzdndnarcsGgwak9pmbavalaPfcsGcdtfydbaxawEhraxawTgHfhxxekdnaeaD9nmbc9:hoxokdndnawcsSmbcehHamawcetfcWfhrxekaecefhrae8SbbgwcFeGhPdndnawcu9mmbarhexekaecvfheaPcFbGhPcrhwdninar8SbbgHcFbGawtaPVhPaHcu9kmearcefhrawcrfgwc8J9hmbxdkkarcefhekcehHaPce4cbaPceG9R7amfhrkarhmkavc;abfaocitfgwarBdbawasBdlavalcdtfarBdbavc;abfaocefcsGcitfgwazBdbawarBdlaocdfhoaHalfhldnadcd9hmbabar87elabas87edabaz87ebabcofhbxdkabarBdwabasBdlabazBdbabcxfhbxekdnarcpe0mbavalaDarcsGfRbbgwcl4gP9RcsGcdtfydbaxcefgsaPEhravalaw9RcsGcdtfydbasaPTgzfgsawcsGgPEhwaPThPdndnadcd9hmbabaw87elabar87edabax87ebcohHxekabawBdwabarBdlabaxBdbcxhHkavalcdtfaxBdbavc;abfaocitfgOarBdbaOaxBdlavalcefglcsGcdtfarBdbavc;abfaocefcsGcitfgOawBdbaOarBdlavalazfglcsGcdtfawBdbavc;abfaocdfcsGcitfgraxBdbarawBdlaocifhoabaHfhbalaPfhlasaPfhxxekdnaeaD9nmbc9:hoxlkaxcbaeRbbgwEgHarc;:eSgrfhsawcsGhOdndnawcl4gAmbascefhzxekashzavalaA9RcsGcdtfydbhskdndnaOmbazcefhxxekazhxavalaw9RcsGcdtfydbhzkdndnarTmbaecefhrxekaecdfhrae8SbegPcFeGhwdnaPcu9kmbaecofhHawcFbGhwcrhedninar8SbbgPcFbGaetawVhwaPcu9kmearcefhraecrfgec8J9hmbkaHhrxekarcefhrkawce4cbawceG9R7amfgmhHkdndnaAcsSmbarhwxekarcefhwar8SbbgecFeGhPdnaecu9kmbarcvfhsaPcFbGhPcrhedninaw8SbbgrcFbGaetaPVhParcu9kmeawcefhwaecrfgec8J9hmbkashwxekawcefhwkaPce4cbaPceG9R7amfgmhskdndnaOcsSmbawhexekawcefheaw8SbbgrcFeGhPdnarcu9kmbawcvfhzaPcFbGhPcrhrdninae8SbbgwcFbGartaPVhPawcu9kmeaecefhearcrfgrc8J9hmbkazhexekaecefhekaPce4cbaPceG9R7amfgmhzkdndnadcd9hmbabaz87elabas87edabaH87ebcohrxekabazBdwabasBdlabaHBdbcxhrkavc;abfaocitfgwasBdbawaHBdlavalcdtfaHBdbavc;abfaocefcsGcitfgwazBdbawasBdlavalcefglcsGcdtfasBdbavc;abfaocdfcsGcitfgwaHBdbawazBdlavalaATaAcsSVfglcsGcdtfazBdbalaOTaOcsSVfhlaocifhoabarfhbkaocsGhoalcsGhlaicefgiaq6mbkkcbc99aeaDSEhokavc;aef8Kjjjjbaok:clevu8Jjjjjbcz9Rhvdnalaecvf9pmbc9:skdnaiRbbc;:eGc;qeSmbcuskav9cb83iwaicefhoaialfc98fhrdnaeTmbdnadcdSmbcbhwindnaoar6mbc9:skaocefhlao8SbbgicFeGhddndnaicu9mmbalhoxekaocvfhoadcFbGhdcrhidninal8SbbgDcFbGaitadVhdaDcu9kmealcefhlaicrfgic8J9hmbxdkkalcefhokabawcdtfadc8Etc8F91adcd47avcwfadceGcdtVglydbfgiBdbalaiBdbawcefgwae9hmbxdkkcbhwindnaoar6mbc9:skaocefhlao8SbbgicFeGhddndnaicu9mmbalhoxekaocvfhoadcFbGhdcrhidninal8SbbgDcFbGaitadVhdaDcu9kmealcefhlaicrfgic8J9hmbxdkkalcefhokabawcetfadc8Etc8F91adcd47avcwfadceGcdtVglydbfgi87ebalaiBdbawcefgwae9hmbkkcbc99aoarSEk:Lvoeue99dud99eud99dndnadcl9hmbaeTmeindndnabcdfgd8Sbb:Yab8Sbbgi:Ygl:l:tabcefgv8Sbbgo:Ygr:l:tgwJbb;:9cawawNJbbbbawawJbbbb9GgDEgq:mgkaqaicb9iEalMgwawNakaqaocb9iEarMgqaqNMM:r:vglNJbbbZJbbb:;aDEMgr:lJbbb9p9DTmbar:Ohixekcjjjj94hikadai86bbdndnaqalNJbbbZJbbb:;aqJbbbb9GEMgq:lJbbb9p9DTmbaq:Ohdxekcjjjj94hdkavad86bbdndnawalNJbbbZJbbb:;awJbbbb9GEMgw:lJbbb9p9DTmbaw:Ohdxekcjjjj94hdkabad86bbabclfhbaecufgembxdkkaeTmbindndnabclfgd8Ueb:Yab8Uebgi:Ygl:l:tabcdfgv8Uebgo:Ygr:l:tgwJb;:FSawawNJbbbbawawJbbbb9GgDEgq:mgkaqaicb9iEalMgwawNakaqaocb9iEarMgqaqNMM:r:vglNJbbbZJbbb:;aDEMgr:lJbbb9p9DTmbar:Ohixekcjjjj94hikadai87ebdndnaqalNJbbbZJbbb:;aqJbbbb9GEMgq:lJbbb9p9DTmbaq:Ohdxekcjjjj94hdkavad87ebdndnawalNJbbbZJbbb:;awJbbbb9GEMgw:lJbbb9p9DTmbaw:Ohdxekcjjjj94hdkabad87ebabcwfhbaecufgembkkk:4ioiue99dud99dud99dnaeTmbcbhiabhlindndnal8Uebgv:YgoJ:ji:1Salcof8UebgrciVgw:Y:vgDNJbbbZJbbb:;avcu9kEMgq:lJbbb9p9DTmbaq:Ohkxekcjjjj94hkkalclf8Uebhvalcdf8UebhxalarcefciGcetfak87ebdndnax:YgqaDNJbbbZJbbb:;axcu9kEMgm:lJbbb9p9DTmbam:Ohxxekcjjjj94hxkabaiarciGgkfcd7cetfax87ebdndnav:YgmaDNJbbbZJbbb:;avcu9kEMgP:lJbbb9p9DTmbaP:Ohvxekcjjjj94hvkalarcufciGcetfav87ebdndnawaw2:ZgPaPMaoaoN:taqaqN:tamamN:tgoJbbbbaoJbbbb9GE:raDNJbbbZMgD:lJbbb9p9DTmbaD:Ohrxekcjjjj94hrkalakcetfar87ebalcwfhlaiclfhiaecufgembkkk9mbdnadcd4ae2gdTmbinababydbgecwtcw91:Yaece91cjjj98Gcjjj;8if::NUdbabclfhbadcufgdmbkkk:Tvirud99eudndnadcl9hmbaeTmeindndnabRbbgiabcefgl8Sbbgvabcdfgo8Sbbgrf9R:YJbbuJabcifgwRbbgdce4adVgDcd4aDVgDcl4aDVgD:Z:vgqNJbbbZMgk:lJbbb9p9DTmbak:Ohxxekcjjjj94hxkaoax86bbdndnaraif:YaqNJbbbZMgk:lJbbb9p9DTmbak:Ohoxekcjjjj94hokalao86bbdndnavaifar9R:YaqNJbbbZMgk:lJbbb9p9DTmbak:Ohixekcjjjj94hikabai86bbdndnaDadcetGadceGV:ZaqNJbbbZMgq:lJbbb9p9DTmbaq:Ohdxekcjjjj94hdkawad86bbabclfhbaecufgembxdkkaeTmbindndnab8Vebgiabcdfgl8Uebgvabclfgo8Uebgrf9R:YJbFu9habcofgw8Vebgdce4adVgDcd4aDVgDcl4aDVgDcw4aDVgD:Z:vgqNJbbbZMgk:lJbbb9p9DTmbak:Ohxxekcjjjj94hxkaoax87ebdndnaraif:YaqNJbbbZMgk:lJbbb9p9DTmbak:Ohoxekcjjjj94hokalao87ebdndnavaifar9R:YaqNJbbbZMgk:lJbbb9p9DTmbak:Ohixekcjjjj94hikabai87ebdndnaDadcetGadceGV:ZaqNJbbbZMgq:lJbbb9p9DTmbaq:Ohdxekcjjjj94hdkawad87ebabcwfhbaecufgembkkk9teiucbcbyd:K:G:cjbgeabcifc98GfgbBd:K:G:cjbdndnabZbcztgd9nmbcuhiabad9RcFFifcz4nbcuSmekaehikaik;LeeeudndnaeabVciGTmbabhixekdndnadcz9pmbabhixekabhiinaiaeydbBdbaiclfaeclfydbBdbaicwfaecwfydbBdbaicxfaecxfydbBdbaeczfheaiczfhiadc9Wfgdcs0mbkkadcl6mbinaiaeydbBdbaeclfheaiclfhiadc98fgdci0mbkkdnadTmbinaiaeRbb86bbaicefhiaecefheadcufgdmbkkabk;aeedudndnabciGTmbabhixekaecFeGc:b:c:ew2hldndnadcz9pmbabhixekabhiinaialBdbaicxfalBdbaicwfalBdbaiclfalBdbaiczfhiadc9Wfgdcs0mbkkadcl6mbinaialBdbaiclfhiadc98fgdci0mbkkdnadTmbinaiae86bbaicefhiadcufgdmbkkabkk83dbcj:Gdk8Kbbbbdbbblbbbwbbbbbbbebbbdbbblbbbwbbbbc:K:Gdkl8W:qbb",e="b9H79TebbbeKl9Gbb9Gvuuuuueu9Giuuub9Geueuixkbbebeeddddilve9Weeeviebeoweuecj:Gdkr;Neqo9TW9T9VV95dbH9F9F939H79T9F9J9H229F9Jt9VV7bb8A9TW79O9V9Wt9F9KW9J9V9KW9wWVtW949c919M9MWVbdY9TW79O9V9Wt9F9KW9J9V9KW69U9KW949c919M9MWVblE9TW79O9V9Wt9F9KW9J9V9KW69U9KW949tWG91W9U9JWbvL9TW79O9V9Wt9F9KW9J9V9KWS9P2tWV9p9JtboK9TW79O9V9Wt9F9KW9J9V9KWS9P2tWV9r919HtbrL9TW79O9V9Wt9F9KW9J9V9KWS9P2tWVT949WbwY9TW79O9V9Wt9F9KW9J9V9KWS9P2tWVJ9V29VVbDl79IV9Rbqq:I9Dklbzik94evu8Jjjjjbcz9Rhbcbheincbhdcbhiinabcwfadfaicjuaead4ceGglE86bbaialfhiadcefgdcw9hmbkaeai86b:q:W:cjbaecitab8Piw83i:q:G:cjbaecefgecjd9hmbkk:SBlEud97dur978Jjjjjbcj;kb9Rgv8Kjjjjbc9:hodnalTmbcuhoaiRbbgrc;WeGc:Ge9hmbarcsGgwce0mbc9:hoalcufadcd4cbawEgDadfgrcKcaawEgqaraq0Egk6mbaialfgxar9RhodnadTgmmbavaoad;8qbbkaicefhPcj;abad9Uc;WFbGcjdadca0EhsdndndnadTmbaoadfhzcbhHinaeaH9nmdaxaP9RaD6miabaHad2fgOavcjdfasaeaH9RaHasfae6EgAaAcsfgoc9WGgCSEhXaPaDfhQaocl4cifcd4hLavcj;cbfaCcetfhKavcj;cbfaCci2fhYavcj;cbfaCfh8AcbhEaoc;ab6h3incbh5dnawTmbaPaEcd4fRbbh5kcbh8Eavcj;cbfh8Findndndndna5a8Ecet4ciGgoc9:fPdebdkaxaQ9RaC6mwdnaCTmbavcj;cbfa8EaC2faQaC;8qbbkaQaAfhQxdkaCTmeavcj;cbfa8EaC2fcbaC;8kbxekaxaQ9RaL6moaoclVcbawEhraQaLfhocbhidna3mbaxao9Rc;Gb6mbcbhlina8FalfhidndndndndndnaQalco4fRbbgqciGarfPDbedibledibkaipxbbbbbbbbbbbbbbbbpklbxlkaiaopbblaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLgacdp:meaapmbzeHdOiAlCvXoQrLpxiiiiiiiiiiiiiiiip9oghpxiiiiiiiiiiiiiiiip8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbagaoclffa8JRb:q:W:cjbfhoxikaiaopbbwaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLpxssssssssssssssssp9oghpxssssssssssssssssp8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbagaocwffa8JRb:q:W:cjbfhoxdkaiaopbbbpklbaoczfhoxekaiaopbbdaoRbbggcitpbi:q:G:cjbagRb:q:W:cjbggpsaoRbeg8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPpklbagaocdffa8JRb:q:W:cjbfhokdndndndndndnaqcd4ciGarfPDbedibledibkaiczfpxbbbbbbbbbbbbbbbbpklbxlkaiczfaopbblaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLgacdp:meaapmbzeHdOiAlCvXoQrLpxiiiiiiiiiiiiiiiip9oghpxiiiiiiiiiiiiiiiip8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbagaoclffa8JRb:q:W:cjbfhoxikaiczfaopbbwaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLpxssssssssssssssssp9oghpxssssssssssssssssp8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbagaocwffa8JRb:q:W:cjbfhoxdkaiczfaopbbbpklbaoczfhoxekaiczfaopbbdaoRbbggcitpbi:q:G:cjbagRb:q:W:cjbggpsaoRbeg8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPpklbagaocdffa8JRb:q:W:cjbfhokdndndndndndnaqcl4ciGarfPDbedibledibkaicafpxbbbbbbbbbbbbbbbbpklbxlkaicafaopbblaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLgacdp:meaapmbzeHdOiAlCvXoQrLpxiiiiiiiiiiiiiiiip9oghpxiiiiiiiiiiiiiiiip8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbagaoclffa8JRb:q:W:cjbfhoxikaicafaopbbwaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLpxssssssssssssssssp9oghpxssssssssssssssssp8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbagaocwffa8JRb:q:W:cjbfhoxdkaicafaopbbbpklbaoczfhoxekaicafaopbbdaoRbbggcitpbi:q:G:cjbagRb:q:W:cjbggpsaoRbeg8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPpklbagaocdffa8JRb:q:W:cjbfhokdndndndndndnaqco4arfPDbedibledibkaic8Wfpxbbbbbbbbbbbbbbbbpklbxlkaic8Wfaopbblaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLgacdp:meaapmbzeHdOiAlCvXoQrLpxiiiiiiiiiiiiiiiip9oghpxiiiiiiiiiiiiiiiip8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Ngicitpbi:q:G:cjbaiRb:q:W:cjbgipsaap5e9cjF;8;4;W;G;ab9:9cU1:Ngqcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbaiaoclffaqRb:q:W:cjbfhoxikaic8Wfaopbbwaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLpxssssssssssssssssp9oghpxssssssssssssssssp8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Ngicitpbi:q:G:cjbaiRb:q:W:cjbgipsaap5e9cjF;8;4;W;G;ab9:9cU1:Ngqcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spklbaiaocwffaqRb:q:W:cjbfhoxdkaic8Wfaopbbbpklbaoczfhoxekaic8WfaopbbdaoRbbgicitpbi:q:G:cjbaiRb:q:W:cjbgipsaoRbegqcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPpklbaiaocdffaqRb:q:W:cjbfhokalc;abfhialcjefaC0meaihlaxao9Rc;Fb0mbkkdnaiaC9pmbaici4hlinaxao9RcK6mwa8FaifhqdndndndndndnaQaico4fRbbalcoG4ciGarfPDbedibledibkaqpxbbbbbbbbbbbbbbbbpkbbxlkaqaopbblaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLgacdp:meaapmbzeHdOiAlCvXoQrLpxiiiiiiiiiiiiiiiip9oghpxiiiiiiiiiiiiiiiip8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spkbbagaoclffa8JRb:q:W:cjbfhoxikaqaopbbwaopbbbgaclp:meaapmbzeHdOiAlCvXoQrLpxssssssssssssssssp9oghpxssssssssssssssssp8Jgap5b9cjF;8;4;W;G;ab9:9cU1:Nggcitpbi:q:G:cjbagRb:q:W:cjbggpsaap5e9cjF;8;4;W;G;ab9:9cU1:Ng8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPahaap9spkbbagaocwffa8JRb:q:W:cjbfhoxdkaqaopbbbpkbbaoczfhoxekaqaopbbdaoRbbggcitpbi:q:G:cjbagRb:q:W:cjbggpsaoRbeg8Jcitpbi:q:G:cjbp9UpmbedilvorzHOACXQLpPpkbbagaocdffa8JRb:q:W:cjbfhokalcdfhlaiczfgiaC6mbkkaohQaoTmoka8FaCfh8Fa8Ecefg8Ecl9hmbkdndndndnawTmbazaEcd4fRbbglciGPlbedwbkaCTmdaXaEfhlavaEfpbdbh8Kcbhoinalavcj;cbfaofpblbg8La8Aaofpblbg8MpmbzeHdOiAlCvXoQrLg8NaKaofpblbgyaYaofpblbg8PpmbzeHdOiAlCvXoQrLgIpmbezHdiOAlvCXorQLgacep9Taapxeeeeeeeeeeeeeeeeghp9op9Hp9rgaa8Kp9Ug8Kp9Abbbaladfgla8Kaaaapmlvorlvorlvorlvorp9Ug8Kp9Abbbaladfgla8KaaaapmwDqkwDqkwDqkwDqkp9Ug8Kp9Abbbaladfgla8KaaaapmxmPsxmPsxmPsxmPsp9Ug8Kp9Abbbaladfgla8Ka8NaIpmwDKYqk8AExm35Ps8E8Fgacep9Taaahp9op9Hp9rgap9Ug8Kp9Abbbaladfgla8Kaaaapmlvorlvorlvorlvorp9Ug8Kp9Abbbaladfgla8KaaaapmwDqkwDqkwDqkwDqkp9Ug8Kp9Abbbaladfgla8KaaaapmxmPsxmPsxmPsxmPsp9Ug8Kp9Abbbaladfgla8Ka8La8MpmwKDYq8AkEx3m5P8Es8Fg8Laya8PpmwKDYq8AkEx3m5P8Es8Fg8MpmbezHdiOAlvCXorQLgacep9Taaahp9op9Hp9rgap9Ug8Kp9Abbbaladfgla8Kaaaapmlvorlvorlvorlvorp9Ug8Kp9Abbbaladfgla8KaaaapmwDqkwDqkwDqkwDqkp9Ug8Kp9Abbbaladfgla8KaaaapmxmPsxmPsxmPsxmPsp9Ug8Kp9Abbbaladfgla8Ka8La8MpmwDKYqk8AExm35Ps8E8Fgacep9Taaahp9op9Hp9rgap9Ughp9Abbbaladfglahaaaapmlvorlvorlvorlvorp9Ughp9AbbbaladfglahaaaapmwDqkwDqkwDqkwDqkp9Ughp9AbbbaladfglahaaaapmxmPsxmPsxmPsxmPsp9Ug8Kp9AbbbaladfhlaoczfgoaC6mbxikkaCTmeaXaEfhlavaEfpbdbh8Kcbhoinalavcj;cbfaofpblbg8La8Aaofpblbg8MpmbzeHdOiAlCvXoQrLg8NaKaofpblbgyaYaofpblbg8PpmbzeHdOiAlCvXoQrLgIpmbezHdiOAlvCXorQLgacep:neaapxebebebebebebebebghp9op:bep9rgaa8Kp:oeg8Kp9Abbbaladfgla8Kaaaapmlvorlvorlvorlvorp:oeg8Kp9Abbbaladfgla8KaaaapmwDqkwDqkwDqkwDqkp:oeg8Kp9Abbbaladfgla8KaaaapmxmPsxmPsxmPsxmPsp:oeg8Kp9Abbbaladfgla8Ka8NaIpmwDKYqk8AExm35Ps8E8Fgacep:neaaahp9op:bep9rgap:oeg8Kp9Abbbaladfgla8Kaaaapmlvorlvorlvorlvorp:oeg8Kp9Abbbaladfgla8KaaaapmwDqkwDqkwDqkwDqkp:oeg8Kp9Abbbaladfgla8KaaaapmxmPsxmPsxmPsxmPsp:oeg8Kp9Abbbaladfgla8Ka8La8MpmwKDYq8AkEx3m5P8Es8Fg8Laya8PpmwKDYq8AkEx3m5P8Es8Fg8MpmbezHdiOAlvCXorQLgacep:neaaahp9op:bep9rgap:oeg8Kp9Abbbaladfgla8Kaaaapmlvorlvorlvorlvorp:oeg8Kp9Abbbaladfgla8KaaaapmwDqkwDqkwDqkwDqkp:oeg8Kp9Abbbaladfgla8KaaaapmxmPsxmPsxmPsxmPsp:oeg8Kp9Abbbaladfgla8Ka8La8MpmwDKYqk8AExm35Ps8E8Fgacep:neaaahp9op:bep9rgap:oeghp9Abbbaladfglahaaaapmlvorlvorlvorlvorp:oeghp9AbbbaladfglahaaaapmwDqkwDqkwDqkwDqkp:oeghp9AbbbaladfglahaaaapmxmPsxmPsxmPsxmPsp:oeg8Kp9AbbbaladfhlaoczfgoaC6mbxdkkaCTmbaXaEfhrcbhocbalcl4gl9Rc8FGhiavaEfpbdbhhinaravcj;cbfaofpblbg8Ka8Aaofpblbg8LpmbzeHdOiAlCvXoQrLg8MaKaofpblbg8NaYaofpblbgypmbzeHdOiAlCvXoQrLg8PpmbezHdiOAlvCXorQLgaaip:Reaaalp:Tep9qgaahp9rghp9Abbbaradfgrahaaaapmlvorlvorlvorlvorp9rghp9AbbbaradfgrahaaaapmwDqkwDqkwDqkwDqkp9rghp9AbbbaradfgrahaaaapmxmPsxmPsxmPsxmPsp9rghp9Abbbaradfgraha8Ma8PpmwDKYqk8AExm35Ps8E8Fgaaip:Reaaalp:Tep9qgap9rghp9Abbbaradfgrahaaaapmlvorlvorlvorlvorp9rghp9AbbbaradfgrahaaaapmwDqkwDqkwDqkwDqkp9rghp9AbbbaradfgrahaaaapmxmPsxmPsxmPsxmPsp9rghp9Abbbaradfgraha8Ka8LpmwKDYq8AkEx3m5P8Es8Fg8Ka8NaypmwKDYq8AkEx3m5P8Es8Fg8LpmbezHdiOAlvCXorQLgaaip:Reaaalp:Tep9qgap9rghp9Abbbaradfgrahaaaapmlvorlvorlvorlvorp9rghp9AbbbaradfgrahaaaapmwDqkwDqkwDqkwDqkp9rghp9AbbbaradfgrahaaaapmxmPsxmPsxmPsxmPsp9rghp9Abbbaradfgraha8Ka8LpmwDKYqk8AExm35Ps8E8Fgaaip:Reaaalp:Tep9qgap9rghp9Abbbaradfgrahaaaapmlvorlvorlvorlvorp9rghp9AbbbaradfgrahaaaapmwDqkwDqkwDqkwDqkp9rghp9AbbbaradfgrahaaaapmxmPsxmPsxmPsxmPsp9rghp9AbbbaradfhraoczfgoaC6mbkkaEclfgEad6mbkdnaXavcjdf9hmbaAad2goTmbaOavcjdfao;8qbbkdnammbavaXaAcufad2fad;8qbbkaAaHfhHc9:hoaQhPaQmbxlkkaeTmbaDalfhrcbhocuhlinaralaD9RglfaD6mdasaeao9Raoasfae6Eaofgoae6mbkaial9RhPkcbc99axaP9RakSEhoxekc9:hokavcj;kbf8Kjjjjbaokwbz:bjjjbkpPesu8Jjjjjbc;ae9Rgv8Kjjjjbc9:hodnalaeci9UgrcHf6mbcuhoaiRbbgwc;WeGc;Ge9hmbawcsGgwce0mbavc;abfcFecje;8kbav9cu83iUav9cu83i8Wav9cu83iyav9cu83iaav9cu83iKav9cu83izav9cu83iwav9cu83ibaialfc9WfhDaicefgiarfhqdndnaeci9pmbaqhexekcmcsawceSEhkcbhxcbhmaqhecbhlcbhoindndnaiRbbgrc;Ve0mbavc;abfaoarcu7gPcl4fcsGcitfgwydlhsawydbhzdndnarcsGgwak9pmbavalaPfcsGcdtfydbaxawEhraxawTgHfhxxekdnaeaD9nmbc9:hoxokdndnawcsSmbcehHamawcetfcWfhrxekaecefhrae8SbbgwcFeGhPdndnawcu9mmbarhexekaecvfheaPcFbGhPcrhwdninar8SbbgHcFbGawtaPVhPaHcu9kmearcefhrawcrfgwc8J9hmbxdkkarcefhekcehHaPce4cbaPceG9R7amfhrkarhmkavc;abfaocitfgwarBdbawasBdlavalcdtfarBdbavc;abfaocefcsGcitfgwazBdbawarBdlaocdfhoaHalfhldnadcd9hmbabar87elabas87edabaz87ebabcofhbxdkabarBdwabasBdlabazBdbabcxfhbxekdnarcpe0mbavalaDarcsGfRbbgwcl4gP9RcsGcdtfydbaxcefgsaPEhravalaw9RcsGcdtfydbasaPTgzfgsawcsGgPEhwaPThPdndnadcd9hmbabaw87elabar87edabax87ebcohHxekabawBdwabarBdlabaxBdbcxhHkavalcdtfaxBdbavc;abfaocitfgOarBdbaOaxBdlavalcefglcsGcdtfarBdbavc;abfaocefcsGcitfgOawBdbaOarBdlavalazfglcsGcdtfawBdbavc;abfaocdfcsGcitfgraxBdbarawBdlaocifhoabaHfhbalaPfhlasaPfhxxekdnaeaD9nmbc9:hoxlkaxcbaeRbbgwEgHarc;:eSgrfhsawcsGhOdndnawcl4gAmbascefhzxekashzavalaA9RcsGcdtfydbhskdndnaOmbazcefhxxekazhxavalaw9RcsGcdtfydbhzkdndnarTmbaecefhrxekaecdfhrae8SbegPcFeGhwdnaPcu9kmbaecofhHawcFbGhwcrhedninar8SbbgPcFbGaetawVhwaPcu9kmearcefhraecrfgec8J9hmbkaHhrxekarcefhrkawce4cbawceG9R7amfgmhHkdndnaAcsSmbarhwxekarcefhwar8SbbgecFeGhPdnaecu9kmbarcvfhsaPcFbGhPcrhedninaw8SbbgrcFbGaetaPVhParcu9kmeawcefhwaecrfgec8J9hmbkashwxekawcefhwkaPce4cbaPceG9R7amfgmhskdndnaOcsSmbawhexekawcefheaw8SbbgrcFeGhPdnarcu9kmbawcvfhzaPcFbGhPcrhrdninae8SbbgwcFbGartaPVhPawcu9kmeaecefhearcrfgrc8J9hmbkazhexekaecefhekaPce4cbaPceG9R7amfgmhzkdndnadcd9hmbabaz87elabas87edabaH87ebcohrxekabazBdwabasBdlabaHBdbcxhrkavc;abfaocitfgwasBdbawaHBdlavalcdtfaHBdbavc;abfaocefcsGcitfgwazBdbawasBdlavalcefglcsGcdtfasBdbavc;abfaocdfcsGcitfgwaHBdbawazBdlavalaATaAcsSVfglcsGcdtfazBdbalaOTaOcsSVfhlaocifhoabarfhbkaocsGhoalcsGhlaicefgiaq6mbkkcbc99aeaDSEhokavc;aef8Kjjjjbaok:clevu8Jjjjjbcz9Rhvdnalaecvf9pmbc9:skdnaiRbbc;:eGc;qeSmbcuskav9cb83iwaicefhoaialfc98fhrdnaeTmbdnadcdSmbcbhwindnaoar6mbc9:skaocefhlao8SbbgicFeGhddndnaicu9mmbalhoxekaocvfhoadcFbGhdcrhidninal8SbbgDcFbGaitadVhdaDcu9kmealcefhlaicrfgic8J9hmbxdkkalcefhokabawcdtfadc8Etc8F91adcd47avcwfadceGcdtVglydbfgiBdbalaiBdbawcefgwae9hmbxdkkcbhwindnaoar6mbc9:skaocefhlao8SbbgicFeGhddndnaicu9mmbalhoxekaocvfhoadcFbGhdcrhidninal8SbbgDcFbGaitadVhdaDcu9kmealcefhlaicrfgic8J9hmbxdkkalcefhokabawcetfadc8Etc8F91adcd47avcwfadceGcdtVglydbfgi87ebalaiBdbawcefgwae9hmbkkcbc99aoarSEk;Toio97eue97aec98Ghedndnadcl9hmbaeTmecbhdinababpbbbgicKp:RecKp:Sep;6eglaicwp:RecKp:Sep;6ealp;Geaiczp:RecKp:Sep;6egvp;Gep;Kep;Legopxbbbbbbbbbbbbbbbbp:2egralpxbbbjbbbjbbbjbbbjgwp9op9rp;Keglpxbb;:9cbb;:9cbb;:9cbb;:9calalp;Meaoaop;Meavaravawp9op9rp;Keglalp;Mep;Kep;Kep;Jep;Negvp;Mepxbbn0bbn0bbn0bbn0grp;KepxFbbbFbbbFbbbFbbbp9oaipxbbbFbbbFbbbFbbbFp9op9qalavp;Mearp;Kecwp:RepxbFbbbFbbbFbbbFbbp9op9qaoavp;Mearp;Keczp:RepxbbFbbbFbbbFbbbFbp9op9qpkbbabczfhbadclfgdae6mbxdkkaeTmbcbhdinabczfgDaDpbbbgipxbbbbbbFFbbbbbbFFgwp9oabpbbbgoaipmbediwDqkzHOAKY8AEgvczp:Reczp:Sep;6eglaoaipmlvorxmPsCXQL358E8FpxFubbFubbFubbFubbp9op;6eavczp:Sep;6egvp;Gealp;Gep;Kep;Legipxbbbbbbbbbbbbbbbbp:2egralpxbbbjbbbjbbbjbbbjgqp9op9rp;Keglpxb;:FSb;:FSb;:FSb;:FSalalp;Meaiaip;Meavaravaqp9op9rp;Keglalp;Mep;Kep;Kep;Jep;Negvp;Mepxbbn0bbn0bbn0bbn0grp;KepxFFbbFFbbFFbbFFbbp9oaiavp;Mearp;Keczp:Rep9qgialavp;Mearp;KepxFFbbFFbbFFbbFFbbp9oglpmwDKYqk8AExm35Ps8E8Fp9qpkbbabaoawp9oaialpmbezHdiOAlvCXorQLp9qpkbbabcafhbadclfgdae6mbkkk;2ileue97euo97dnaec98GgiTmbcbheinabcKfpx:ji:1S:ji:1S:ji:1S:ji:1SabpbbbglabczfgvpbbbgopmlvorxmPsCXQL358E8Fgrczp:Segwpxibbbibbbibbbibbbp9qp;6egDp;NegqaDaDp;MegDaDp;KealaopmbediwDqkzHOAKY8AEgDczp:Reczp:Sep;6eglalp;MeaDczp:Sep;6egoaop;Mearczp:Reczp:Sep;6egrarp;Mep;Kep;Kep;Lepxbbbbbbbbbbbbbbbbp:4ep;Jep;Mepxbbn0bbn0bbn0bbn0gDp;KepxFFbbFFbbFFbbFFbbgkp9oaqaop;MeaDp;Keczp:Rep9qgoaqalp;MeaDp;Keakp9oaqarp;MeaDp;Keczp:Rep9qgDpmwDKYqk8AExm35Ps8E8Fglp5eawclp:RegqpEi:T:j83ibavalp5baqpEd:T:j83ibabcwfaoaDpmbezHdiOAlvCXorQLgDp5eaqpEe:T:j83ibabaDp5baqpEb:T:j83ibabcafhbaeclfgeai6mbkkkuee97dnadcd4ae2c98GgeTmbcbhdinababpbbbgicwp:Recwp:Sep;6eaicep:SepxbbjFbbjFbbjFbbjFp9opxbbjZbbjZbbjZbbjZp:Uep;Mepkbbabczfhbadclfgdae6mbkkk:Sodw97euaec98Ghedndnadcl9hmbaeTmecbhdinabpxbbuJbbuJbbuJbbuJabpbbbgicKp:TeglaicYp:Tep9qgvcdp:Teavp9qgvclp:Teavp9qgop;6ep;Negvaicwp:RecKp:SegraipxFbbbFbbbFbbbFbbbgwp9ogDp:Uep;6ep;Mepxbbn0bbn0bbn0bbn0gqp;Kecwp:RepxbFbbbFbbbFbbbFbbp9oavaDarp:Xeaiczp:RecKp:Segip:Uep;6ep;Meaqp;Keawp9op9qavaDaraip:Uep:Xep;6ep;Meaqp;Keczp:RepxbbFbbbFbbbFbbbFbp9op9qavaoalcep:Rep9oalpxebbbebbbebbbebbbp9op9qp;6ep;Meaqp;KecKp:Rep9qpkbbabczfhbadclfgdae6mbxdkkaeTmbcbhdinabczfgkpxbFu9hbFu9hbFu9hbFu9habpbbbglakpbbbgrpmlvorxmPsCXQL358E8Fgvczp:TegqavcHp:Tep9qgicdp:Teaip9qgiclp:Teaip9qgicwp:Teaip9qgop;6ep;NegialarpmbediwDqkzHOAKY8AEgDpxFFbbFFbbFFbbFFbbglp9ograDczp:Segwp:Ueavczp:Reczp:SegDp:Xep;6ep;Mepxbbn0bbn0bbn0bbn0gvp;Kealp9oaiarawaDp:Uep:Xep;6ep;Meavp;Keczp:Rep9qgwaiaoaqcep:Rep9oaqpxebbbebbbebbbebbbp9op9qp;6ep;Meavp;Keczp:ReaiaDarp:Uep;6ep;Meavp;Kealp9op9qgipmwDKYqk8AExm35Ps8E8FpkbbabawaipmbezHdiOAlvCXorQLpkbbabcafhbadclfgdae6mbkkk9teiucbcbydj:G:cjbgeabcifc98GfgbBdj:G:cjbdndnabZbcztgd9nmbcuhiabad9RcFFifcz4nbcuSmekaehikaikkxebcj:Gdklz:zbb",r=new Uint8Array([0,97,115,109,1,0,0,0,1,4,1,96,0,0,3,3,2,0,0,5,3,1,0,1,12,1,0,10,22,2,12,0,65,0,65,0,65,0,252,10,0,0,11,7,0,65,0,253,15,26,11]),b=new Uint8Array([32,0,65,2,1,106,34,33,3,128,11,4,13,64,6,253,10,7,15,116,127,5,8,12,40,16,19,54,20,9,27,255,113,17,42,67,24,23,146,148,18,14,22,45,70,69,56,114,101,21,25,63,75,136,108,28,118,29,73,115]);if(typeof WebAssembly!="object")return{supported:!1};var n=WebAssembly.validate(r)?o(e):o(a),t,c=WebAssembly.instantiate(n,{}).then(function(y){t=y.instance,t.exports.__wasm_call_ctors()});function o(y){for(var g=new Uint8Array(y.length),m=0;m<y.length;++m){var u=y.charCodeAt(m);g[m]=u>96?u-97:u>64?u-39:u+4}for(var w=0,m=0;m<y.length;++m)g[w++]=g[m]<60?b[g[m]]:(g[m]-60)*64+g[++m];return g.buffer.slice(0,w)}s(o,"unpack");function d(y,g,m,u,w,v,j){var R=y.exports.sbrk,F=u+3&-4,E=R(F*w),q=R(v.length),P=new Uint8Array(y.exports.memory.buffer);P.set(v,q);var K=g(E,u,w,q,v.length);if(K==0&&j&&j(E,F,w),m.set(P.subarray(E,E+u*w)),R(E-R(0)),K!=0)throw new Error("Malformed buffer data: "+K)}s(d,"decode");var l={NONE:"",OCTAHEDRAL:"meshopt_decodeFilterOct",QUATERNION:"meshopt_decodeFilterQuat",EXPONENTIAL:"meshopt_decodeFilterExp",COLOR:"meshopt_decodeFilterColor"},f={ATTRIBUTES:"meshopt_decodeVertexBuffer",TRIANGLES:"meshopt_decodeIndexBuffer",INDICES:"meshopt_decodeIndexSequence"},i=[],p=0;function h(y){var g={object:new Worker(y),pending:0,requests:{}};return g.object.onmessage=function(m){var u=m.data;g.pending-=u.count,g.requests[u.id][u.action](u.value),delete g.requests[u.id]},g}s(h,"createWorker");function A(y){for(var g="self.ready = WebAssembly.instantiate(new Uint8Array(["+new Uint8Array(n)+"]), {}).then(function(result) { result.instance.exports.__wasm_call_ctors(); return result.instance; });self.onmessage = "+k.name+";"+d.toString()+k.toString(),m=new Blob([g],{type:"text/javascript"}),u=URL.createObjectURL(m),w=i.length;w<y;++w)i[w]=h(u);for(var w=y;w<i.length;++w)i[w].object.postMessage({});i.length=y,URL.revokeObjectURL(u)}s(A,"initWorkers");function x(y,g,m,u,w){for(var v=i[0],j=1;j<i.length;++j)i[j].pending<v.pending&&(v=i[j]);return new Promise(function(R,F){var E=new Uint8Array(m),q=++p;v.pending+=y,v.requests[q]={resolve:R,reject:F},v.object.postMessage({id:q,count:y,size:g,source:E,mode:u,filter:w},[E.buffer])})}s(x,"decodeWorker");function k(y){var g=y.data;self.ready.then(function(m){if(!g.id)return self.close();try{var u=new Uint8Array(g.count*g.size);d(m,m.exports[g.mode],u,g.count,g.size,g.source,m.exports[g.filter]),self.postMessage({id:g.id,count:g.count,action:"resolve",value:u},[u.buffer])}catch(w){self.postMessage({id:g.id,count:g.count,action:"reject",value:w})}})}return s(k,"workerProcess"),{ready:c,supported:!0,useWorkers:s(function(y){A(y)},"useWorkers"),decodeVertexBuffer:s(function(y,g,m,u,w){d(t,t.exports.meshopt_decodeVertexBuffer,y,g,m,u,t.exports[l[w]])},"decodeVertexBuffer"),decodeIndexBuffer:s(function(y,g,m,u){d(t,t.exports.meshopt_decodeIndexBuffer,y,g,m,u)},"decodeIndexBuffer"),decodeIndexSequence:s(function(y,g,m,u){d(t,t.exports.meshopt_decodeIndexSequence,y,g,m,u)},"decodeIndexSequence"),decodeGltfBuffer:s(function(y,g,m,u,w,v){d(t,t.exports[f[w]],y,g,m,u,t.exports[l[v]])},"decodeGltfBuffer"),decodeGltfBufferAsync:s(function(y,g,m,u,w){return i.length>0?x(y,g,m,f[u],l[w]):c.then(function(){var v=new Uint8Array(y*g);return d(t,t.exports[f[u]],v,y,g,m,t.exports[l[w]]),v})},"decodeGltfBufferAsync")}})();var Fe=2**28,qe=64,Pe=2**16,Ge=256,Aa=s(a=>a===2||a===4,"isCorner"),Ke=new Map([["ATTRIBUTES",a=>a%4===0&&a<=Ge],["TRIANGLES",Aa],["INDICES",Aa]]),Te=new Map([["NONE",()=>!0],["OCTAHEDRAL",a=>a===4||a===8],["QUATERNION",a=>a===8],["EXPONENTIAL",a=>a%4===0]]);async function va(a,{count:e,byteStride:r,mode:b,filter:n="NONE"}){let t=O(e)&&O(r)&&r>0,c=e*r;if(!t||c>Math.min(Fe,Pe+qe*a.length))throw new Error(`${a.length} compressed bytes claim ${e} rows of ${r} bytes`);if(!Ke.get(b)?.(r)||b==="TRIANGLES"&&e%3!==0)throw new Error(`${e} rows of ${r} bytes cannot be ${b}`);if(!Te.get(n)?.(r)||b!=="ATTRIBUTES"&&n!=="NONE")throw new Error(`${b} of ${r} bytes have no filter ${n}`);let o=new Uint8Array(c);await ca.ready;try{ca.decodeGltfBuffer(o,e,r,a,b,n)}catch{throw new Error("expected a compressed array, got something else")}return o}s(va,"decompressed");function O(a){return Number.isSafeInteger(a)&&a>=0}s(O,"isCount");var[Me,ja]=[1179937895,2],[Se,Oe]=[1313821514,5130562],De={SCALAR:1,VEC2:2,VEC3:3,VEC4:4},[Ue,Le]=[2**26,2**30],We={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array};function Ea(a,e,r=Le){let{document:b,chunk:n}=Ne(a),t=new Map,c=0;function o(f){if(c+=f,c>r)throw new Error(`the arrays take more than ${r} bytes`)}s(o,"spend");function d(f){let i=T(b.buffers,f,"buffer"),p=i.uri===void 0?n:e.get(i.uri);if(!p)throw new Error(`the buffer ${i.uri??f} is not there`);return p}s(d,"bufferOf");async function l(f){let i=T(b.bufferViews,f,"view"),p=i.extensions?.EXT_meshopt_compression;if(!p)return I(d(i.buffer),i.byteOffset??0,i.byteLength);let h=I(d(p.buffer),p.byteOffset??0,p.byteLength),A=await va(h,p);return o(A.length),A}return s(l,"viewOf"),{document:b,async read(f,i){let p=T(b.accessors,f,"accessor"),{count:h,byteOffset:A=0}=p,x=We[p.componentType];if(!x||De[p.type]!==i||!O(h)||h>Ue||!O(A))throw new Error(`accessor ${f}: expected rows of ${i} columns, got ${p.type}`);let k=T(b.bufferViews,p.bufferView,"view"),y=t.get(p.bufferView);y||(y=l(p.bufferView),t.set(p.bufferView,y));let g=i*x.BYTES_PER_ELEMENT,m=k.byteStride??k.extensions?.EXT_meshopt_compression?.byteStride??g,u=await y;if(!O(m)||m<g)throw new Error(`accessor ${f}: expected rows of ${g} bytes`);if(h>0&&A+(h-1)*m+g>u.length)throw new Error(`accessor ${f} reaches beyond its array`);o(h*g);let w=new Uint8Array(h*g);if(m===g)w.set(u.subarray(A,A+w.length));else for(let v=0,j=A;v<h;v++,j+=m)w.set(u.subarray(j,j+g),v*g);return new x(w.buffer)},placeOf(f){let{bufferView:i,byteOffset:p=0,count:h}=T(b.accessors,f,"accessor"),A=T(b.bufferViews,i,"view"),{buffer:x,byteOffset:k=0}=A.extensions?.EXT_meshopt_compression??A;return`${T(b.buffers,x,"buffer").uri??""}:${k}:${p}:${h}`}}}s(Ea,"openGlb");function T(a,e,r){if(e===void 0)throw new Error(`the ${r}\'s number is missing`);let b=Array.isArray(a)&&O(e)?a[e]:void 0;if(typeof b!="object"||b===null)throw new Error(`${r} ${e} is not there`);return b}s(T,"entryAt");function X(a,e){if(!(a===void 0||Array.isArray(a)&&a.every(b=>typeof b=="object"&&b)))throw new Error(`expected a list of ${e}, got something else`);return a??[]}s(X,"entries");function Ne(a){let e=new DataView(a.buffer,a.byteOffset,a.byteLength);if(a.length<20||e.getUint32(0,!0)!==Me||e.getUint32(16,!0)!==Se)throw new Error("expected a GLB, got something else");if(e.getUint32(4,!0)!==ja)throw new Error(`expected version ${ja} of glTF, got another one`);let r=e.getUint32(12,!0),b=Je(I(a,20,r)),n=20+r;if(a.length<n+8)return{document:b,chunk:null};if(e.getUint32(n+4,!0)!==Oe)throw new Error("expected a binary chunk, got another one");return{document:b,chunk:I(a,n+8,e.getUint32(n,!0))}}s(Ne,"chunksOf");function Je(a){let e;try{e=JSON.parse(new TextDecoder().decode(a))}catch{throw new Error("expected a glTF document, got something else")}if(typeof e!="object"||e===null)throw new Error("expected a glTF document, got a value");return e}s(Je,"parsed");function I(a,e,r){if(!(O(e)&&O(r)&&e+r<=a.length))throw new Error("an array reaches beyond the file");return a.subarray(e,e+r)}s(I,"slice");var ze=2**26,Be=2**18,Ra={colorSpaceConversion:"none",premultiplyAlpha:"none",imageOrientation:"none"};async function oa(a,e){let[r,b]=qa(a,e);if(r*b>ze)throw new Error(`${a}: expected a smaller picture, got ${r} \\xD7 ${b} pixels`);try{return await createImageBitmap(new Blob([e],{type:"image/webp"}),Ra)}catch{throw new Error(`${a}: expected a WebP picture, got something else`)}}s(oa,"pictureOf");async function Fa(a){let e=[];for(let[r,b]of Object.entries(a)){let{width:n,height:t}=b,c=Math.max(Math.floor(Be/(4*n)),1);for(let o=0;o<t;o+=c){let d=await createImageBitmap(b,0,o,n,Math.min(c,t-o),Ra);e.push({name:r,width:n,height:t,y:o,rows:d})}b.close()}return e}s(Fa,"bandsOf");async function sa(a,e,r){let b=await U(a),n=qa(a.name,b);if(n[0]!==e||n[1]!==r)throw new Error(`${a.name}: expected ${e} \\xD7 ${r} pixels, got ${n[0]} \\xD7 ${n[1]}`);let t=await oa(a.name,b);try{let c=new OffscreenCanvas(e,r).getContext("2d",{willReadFrequently:!0});if(!c)throw new Error(`${a.name}: the browser cannot read pictures here`);return c.drawImage(t,0,0),new Uint8Array(c.getImageData(0,0,e,r).data.buffer)}finally{t.close()}}s(sa,"pixelsOf");function qa(a,e){let r=new DataView(e.buffer,e.byteOffset,e.byteLength),b=s(n=>String.fromCharCode(...e.subarray(n,n+4)),"textAt");if(e.length>=30&&b(0)==="RIFF"&&b(8)==="WEBP")switch(b(12)){case"VP8 ":return[r.getUint16(26,!0)&16383,r.getUint16(28,!0)&16383];case"VP8L":{let n=r.getUint32(21,!0);return[1+(n&16383),1+(n>>>14&16383)]}case"VP8X":return[1+(r.getUint32(24,!0)&16777215),1+(r.getUint32(26,!0)>>>8)]}throw new Error(`${a}: expected a WebP picture, got something else`)}s(qa,"sizeOf");function Pa(a){if(a.indices.length===0)return[];if(a.indices.length<=98304)return[a];let r=new Int32Array(a.positions.length/3).fill(-1),b=Math.ceil(a.indices.length/98304);return Array.from({length:b},(n,t)=>ia(a,a.indices.subarray(t*98304,(t+1)*98304),r))}s(Pa,"chopped");function ia(a,e,r=new Int32Array(a.positions.length/3).fill(-1)){let b=new Uint32Array(e.length),n=new Uint32Array(e.length),t=0;for(let o=0;o<e.length;o++){let d=e[o];r[d]===-1&&(r[d]=t,n[t++]=d),b[o]=r[d]}let c=n.subarray(0,t);for(let o of c)r[o]=-1;return{...a,indices:t<=65536?Uint16Array.from(b):b,positions:_(a.positions,c,3),normals:a.normals&&_(a.normals,c,3),uvs:a.uvs&&_(a.uvs,c,2),colors:a.colors&&_(a.colors,c,4)}}s(ia,"chosenRows");function _(a,e,r){let b=new a.constructor(e.length*r);for(let n=0;n<e.length;n++){let t=e[n];for(let c=0;c<r;c++)b[n*r+c]=a[t*r+c]}return b}s(_,"rowsOf");var Ga=[1,0,0,0,0,1,0,0,0,0,1,0];function Ka(a){return a.length===12&&a.every((e,r)=>e===Ga[r])}s(Ka,"isIdentity");async function Ta(a,e){let r=e.extensions?.EXT_mesh_gpu_instancing?await He(a,e):Ve(e);if(!r.every(Number.isFinite))throw new Error("expected placements of finite numbers");return r}s(Ta,"placementsOf");function Ve({matrix:a}){if(a===void 0)return Float64Array.from(Ga);if(!Array.isArray(a)||a.length!==16)throw new Error("expected matrices of 16 numbers");return Float64Array.from({length:12},(e,r)=>a[4*(r%4)+Math.floor(r/4)])}s(Ve,"matrixOf");async function He(a,e){let r=e.extensions?.EXT_mesh_gpu_instancing?.attributes??{},b=s(async(i,p)=>{if(r[i]===void 0)return null;let h=await a.read(r[i],p);if(!(h instanceof Float32Array))throw new Error(`expected placements whose ${i} has 32 bits`);return h},"read"),[n,t,c]=await Promise.all([b("TRANSLATION",3),b("ROTATION",4),b("SCALE",3)]),d=[[n,3],[t,4],[c,3]].flatMap(([i,p])=>i?[i.length/p]:[]),[l]=d;if(l===void 0||d.some(i=>i!==l)||e.matrix!==void 0)throw new Error("expected arrays of placements of one length");let f=new Float64Array(12*l);for(let i=0;i<l;i++)Ce(f,i,n,t,c);return f}s(He,"instancesOf");function Ce(a,e,r,b,n){let t=s((k,y,g,m)=>k?k[y*e+g]:m,"part"),[c,o,d,l]=[t(b,4,0,0),t(b,4,1,0),t(b,4,2,0),t(b,4,3,1)],f=Math.sqrt(c*c+o*o+d*d+l*l)||1,[i,p,h,A]=[c/f,o/f,d/f,l/f],x=[1-2*(p*p+h*h),2*(i*p-A*h),2*(i*h+A*p),2*(i*p+A*h),1-2*(i*i+h*h),2*(p*h-A*i),2*(i*h-A*p),2*(p*h+A*i),1-2*(i*i+p*p)];for(let k=0;k<3;k++){for(let y=0;y<3;y++)a[12*e+4*k+y]=x[3*k+y]*t(n,3,y,1);a[12*e+4*k+3]=t(r,3,k,0)}}s(Ce,"compose");function Ma(a,e){let r=new Float32Array(a.reduce((n,t)=>n+t.length,0)),b=0;for(let n of a)for(let t=0;t<n.length;t++)r[b++]=n[t]+(t%4===3?e[Math.floor(t%12/4)]:0);return r}s(Ma,"rounded");function $(a,e,r){let b=da(a,e);if(b.length===0)return a;let{indices:n}=a,t=Ie(a,e),c=[],o=0;for(let d of b){for(;o<3*d;o++)c.push(n[o]);if(o+=3,r.left+=1,t.split([n[o-3],n[o-2],n[o-1]],(l,f,i)=>(r.left-=1,c.push(l,f,i),r.left>=0)),r.left<0)return a}for(;o<n.length;o++)c.push(n[o]);return t.made()>0?t.finished(c):a}s($,"splitArrays");function da({positions:a,indices:e},r){let b=[];for(let n=0;n<e.length;n+=3){let[t,c,o]=[3*e[n],3*e[n+1],3*e[n+2]],d=Math.max(fa(a,t,c),fa(a,c,o),fa(a,o,t)),[l,f]=[1/0,1/0];for(let A of[t,c,o]){let[x,k,y]=[a[A],a[A+1],a[A+2]],g=x*x+y*y;l=Math.min(l,g),f=Math.min(f,g+k*k)}let[i,p]=[Math.sqrt(l),Math.sqrt(f)],h=[Math.max(i-d,0),i+d];r.isHarmless(d,h,Math.max(p-d,0))||b.push(n/3)}return b}s(da,"largeTriangles");function fa(a,e,r){let b=a[e]-a[r],n=a[e+1]-a[r+1],t=a[e+2]-a[r+2];return Math.sqrt(b*b+n*n+t*t)}s(fa,"lengthOf");function Ie(a,e){let r=a.positions.length/3,b=s((k,y)=>({source:k,width:y,more:[]}),"rows"),n=b(a.positions,3),t=a.normals&&b(a.normals,3),c=a.uvs&&b(a.uvs,2),o=a.colors&&b(a.colors,4),d=[n,t,c,o].filter(k=>k!==null),l=new Map,f=r;function i({source:k,width:y,more:g},m,u){return m<r?k[y*m+u]:g[y*(m-r)+u]}s(i,"value");function p(k){return[i(n,k,0),i(n,k,1),i(n,k,2)]}s(p,"point");function h(k,y){let g=k<y?k*67108864+y:y*67108864+k,m=l.get(g);if(m!==void 0)return m;let[u,w]=[p(k),p(y)],v=u[0]-w[0]||u[1]-w[1]||u[2]-w[2],[j,R,F,E]=v<=0?[k,y,u,w]:[y,k,w,u],q=e.share(F,E),P=q>0?A([[j,1-q],[R,q]]):-1;return l.set(g,P),P}s(h,"cut");function A(k){let[[y]]=k,g=s((u,w)=>{let v=i(u,y,w);return k.reduce((j,[R,F])=>j+F*(i(u,R,w)-v),v)},"mean"),m=[0,1,2].map(u=>Math.fround(g(n,u)));if(k.some(([u])=>p(u).every((w,v)=>w===m[v])))return-1;for(let u of d)for(let w=0;w<u.width;w++)u.more.push(u===n?m[w]:g(u,w));return f++}s(A,"add");function x(k){let[y,g,m]=k.map(p);if([y,g,m].some(([v,,j])=>Math.hypot(v,j)<e.outer))return-1;let u=[la(g,m),la(m,y),la(y,g)],w=u.reduce((v,j)=>v+j,0);return u.some(v=>!(v/w>0))?-1:A(k.map((v,j)=>[v,u[j]/w]))}return s(x,"addInteriorVertex"),{split(k,y){let g=[[...k,0]];for(let m=g.pop();m;m=g.pop()){let[u,w,v,j]=m,R=[[u,w,v],[w,v,u],[v,u,w]].map(([q,P,K])=>({i:q,j:P,k:K,at:h(q,P)})),[F]=R.filter(({at:q})=>q>=0&&j<192).sort((q,P)=>Sa(p(P.i),p(P.j))-Sa(p(q.i),p(q.j))),E=F?-1:x([u,w,v]);if(F){let{i:q,j:P,k:K,at:D}=F;g.push([q,D,K,j+1],[D,P,K,j+1])}else if(E>=0)g.push([u,w,E,j+1],[w,v,E,j+1],[v,u,E,j+1]);else if(!y(u,w,v))return}},made:s(()=>f-r,"made"),finished(k){let y=s(g=>{let m=g.source.constructor,u=new m(g.width*f);u.set(g.source);for(let w=0;w<g.more.length;w++){let v=g.more[w];u[g.source.length+w]=u instanceof Uint16Array?Math.round(v):v}return u},"joined");return{...a,indices:f<=2**16?Uint16Array.from(k):Uint32Array.from(k),positions:y(n),normals:t&&y(t),uvs:c&&y(c),colors:o&&y(o)}}}}s(Ie,"createMesh");function la(a,e){return a[0]*e[2]-a[2]*e[0]}s(la,"cross");function Sa(a,e){return(a[0]-e[0])**2+(a[1]-e[1])**2+(a[2]-e[2])**2}s(Sa,"squared");function La(a,e,r,b){let n=_e(a),t=new Set,[c,o]=[[],[]];for(let h=0;h<e.length;h+=12){let A=e.subarray(h,h+12),x=$e(n,A,r)?[]:da(Oa(a,A),r);(x.length>0?c:o).push(A);for(let k of x)t.add(k)}if(t.size===0)return[{arrays:a,placements:e}];let d=Array.from({length:a.indices.length/3},(h,A)=>A),l=Ua(a,[...t].sort((h,A)=>h-A)),f=c.map(h=>$(Oa(l,h),r,b)),i=[{arrays:Xe(f),placements:null}];o.length>0&&i.push({arrays:l,placements:Ze(o)});let p=d.filter(h=>!t.has(h));return p.length>0&&i.push({arrays:Ua(a,p),placements:e}),i}s(La,"splitPlaced");function Xe(a){let[e]=a,r=new Uint32Array(a.reduce((c,o)=>c+o.indices.length,0)),[b,n]=[0,0];for(let c of a){for(let o of c.indices)r[b++]=n+o;n+=c.positions.length/3}let t=s(c=>{let o=a.map(c).filter(l=>l!==null);if(!o[0])return null;let d=new o[0].constructor(o.reduce((l,f)=>l+f.length,0));return o.reduce((l,f)=>(d.set(f,l),l+f.length),0),d},"all");return{...e,indices:r,positions:t(c=>c.positions)??e.positions,normals:t(c=>c.normals),uvs:t(c=>c.uvs),colors:t(c=>c.colors)}}s(Xe,"together");function _e({positions:a,indices:e}){let[r,b]=[[1/0,1/0,1/0],[-1/0,-1/0,-1/0]];for(let o=0;o<a.length;o++)r[o%3]=Math.min(r[o%3],a[o]),b[o%3]=Math.max(b[o%3],a[o]);let n=0;for(let o=0;o<e.length;o++){let d=3*e[o],l=3*e[o%3===2?o-2:o+1],[f,i,p]=[0,1,2].map(h=>a[d+h]-a[l+h]);n=Math.max(n,f*f+i*i+p*p)}let t=r.map((o,d)=>(o+b[d])/2),c=Math.hypot(...r.map((o,d)=>b[d]-o))/2;return{center:t,radius:c,longest:Math.sqrt(n)}}s(_e,"ballOf");function $e({center:a,radius:e,longest:r},b,n){let[t,c,o]=Qe(a,b),d=Ye(b),[l,f]=[Math.hypot(t,o),Math.hypot(t,c,o)],i=e*d;return n.isHarmless(r*d,[Math.max(l-i,0),l+i],Math.max(f-i,0))}s($e,"isHarmless");function Ye(a){let e=s((n,t)=>a[4*n+t],"at"),r=s((n,t)=>e(0,n)*e(0,t)+e(1,n)*e(1,t)+e(2,n)*e(2,t),"dot"),b=[0,1,2].map(n=>[0,1,2].reduce((t,c)=>t+Math.abs(r(n,c)),0));return Math.sqrt(Math.max(...b))}s(Ye,"stretchOf");function Qe([a,e,r],b){return[0,4,8].map(n=>{let[t,c,o,d]=b.subarray(n,n+4);return t*a+c*e+o*r+d})}s(Qe,"pointOf");function Oa(a,e){let r=s((n,t)=>e[4*(n%3)+t%3],"at"),b=new Float32Array(12);for(let n=0;n<3;n++)for(let t=0;t<3;t++){let[c,o]=[n+1,t+1];b[4*n+t]=r(c,o)*r(c+1,o+1)-r(c,o+1)*r(c+1,o)}return{...a,positions:Da(a.positions,e),normals:a.normals&&Da(a.normals,b)}}s(Oa,"transformMesh");function Da(a,e){let[r,b,n,t,c,o,d,l,f,i,p,h]=e,A=new Float32Array(a.length);for(let x=0;x<a.length;x+=3){let[k,y,g]=[a[x],a[x+1],a[x+2]];A[x]=r*k+b*y+n*g+t,A[x+1]=c*k+o*y+d*g+l,A[x+2]=f*k+i*y+p*g+h}return A}s(Da,"transformed");function Ua(a,e){let r=e.flatMap(b=>[0,1,2].map(n=>a.indices[3*b+n]));return ia(a,Uint32Array.from(r))}s(Ua,"picked");function Ze(a){let e=new Float32Array(12*a.length);return a.forEach((r,b)=>e.set(r,12*b)),e}s(Ze,"concatRows");var za={radii:[],nearShare:.5,reach:0},Q=7e-4,Wa=.3,ar=.1,er=.35,rr=.75,[nr,br]=[.03,.004],[tr,z]=[.002,5e-4],pa=1/8,Y=1.1;function Ba({radii:a,nearShare:e,reach:r},b=Q){let n=a[0]??0,t=b/Q,c=a.at(-1)??0,o=e*n,d=Math.min(r,er*n),l=[...new Set(a.flatMap(m=>[e*m,m]))].filter(m=>m>pa*n).sort((m,u)=>m-u),f=s((m,u,w)=>Math.max(A(m,u,w),t*br*m),"atRest"),i=s((m,u)=>Math.max(A(m,u,d),t*nr*m),"growing"),p=cr(l,m=>i(m,m));function h(m){return m<c?1/((1-e)*Math.max(n,m)):0}s(h,"slopeAt");function A(m,u,w){let v=w/Na(u,w);return 4*Wa*b/(v*(1+v/2)*(h(m)||1e-9))}s(A,"rangeAt");function x(m,u,w,v){let j=Na(u,w),R=w/j,F=v?0:h(m),E=8/3*R*R*F/j,q=R*R*F*F+.75*E,P=R*(1+R/2)*F/Math.max(m,pa*n),K=.3*R*R/(j*j)+E/3;return[q,P,K]}s(x,"formAt");let k=6*b*(1-Wa),y=s(m=>Math.max(d,ar*m),"usersAt"),g=s(m=>tr*Math.max(m,pa*n),"shortestAt");return{outer:c,isHarmless(m,[u,w],v){if(u>=c||m<=g(u))return!0;let[j,R]=[u/Y,v/Y],F=w<=o,E=y(w),[q,P,K]=x(j,R,E,F);return(q+P+K)*m*m>k?!1:F||m<=f(j,R,E)?!0:!(Z(l,j)<Z(l,w))&&m<=i(j,R)},share(m,u){let[w,v,j]=[u[0]-m[0],u[1]-m[1],u[2]-m[2]],[R,F]=[Math.hypot(w,j),Math.hypot(w,v,j)],E=Ja([m[0],0,m[2]],[w,0,j]),q=g(E);if(E>=c*(1-z)||F<=q)return 0;let P=Math.max(Math.hypot(m[0],m[2]),Math.hypot(u[0],u[2])),K=P<=o*(1+z),D=P-E,[ra,na]=[E/Y,Ja(m,[w,v,j])/Y],wa=y(E);if(!K&&D>f(ra,na,wa)){let je=D>i(ra,na)?p:l,ka=or(je,[m[0],m[2]],[w,j],[E,P]);if(ka>0||P>c*(1+z))return ka}let[ke,xe,Ae]=x(ra,na,wa,K),ve=ke*D*D+xe*R*R+Ae*F*F,ba=Math.min(Math.ceil(Math.sqrt(ve/k)-1e-9),Math.floor(F/q));return ba>=2?Math.floor(ba/2)/ba:0}}}s(Ba,"createRule");function Na(a,e){return Math.max(a-e,rr*a,1e-9)}s(Na,"clear");function cr(a,e){return a.flatMap((r,b)=>{let n=a[b+1]??r,t=[0];for(let o=r;o<n;)o+=e(o),t.push(o-r);let c=(n-r)/(t.at(-1)||1);return t.slice(0,Math.max(t.length-1,1)).map(o=>r+c*o)})}s(cr,"bandsOf");function Ja([a,e,r],[b,n,t]){let c=b*b+n*n+t*t,o=c>0?Math.min(Math.max(-(a*b+e*n+r*t)/c,0),1):0;return Math.hypot(a+o*b,e+o*n,r+o*t)}s(Ja,"segmentDistance");function or(a,[e,r],[b,n],[t,c]){let o=Z(a,t*(1+z)),d=Z(a,c*(1-z));if(d<=o)return 0;let l=31-Math.clz32(o^d),f=a[(d>>l<<l)-1],i=b*b+n*n,p=e*b+r*n,h=Math.sqrt(p*p-i*(e*e+r*r-f*f));return[(-p-h)/i,(-p+h)/i].filter(x=>x>0&&x<1).sort((x,k)=>Math.abs(x-.5)-Math.abs(k-.5))[0]??0}s(or,"cutAt");function Z(a,e){let[r,b]=[0,a.length];for(;r<b;){let n=r+b>>1;a[n]<e?r=n+1:b=n}return r}s(Z,"countBelow");var N="files/";async function Ha(a,{attributes:e={},indices:r,material:b}){let n=s((p,h)=>e[p]===void 0?null:a.read(e[p],h),"optional"),[t,c,o,d,l]=await Promise.all([a.read(e.POSITION,3),n("NORMAL",3),n("TEXCOORD_0",2),n("COLOR_0",4),a.read(r,1)]),f=t.length/3;if(!(l instanceof Uint16Array||l instanceof Uint32Array)||l.length%3!==0)throw new Error("expected triangles of 16 or 32 bits");if(sr(l)>=f)throw new Error(`expected corners below ${f}`);if([[c,3],[o,2],[d,4]].some(([p,h])=>p&&p.length!==h*f))throw new Error(`expected attributes of ${f} vertices`);if(d&&!(d instanceof Uint16Array))throw new Error("expected colours of 16 bits");return{positions:ma(t,"positions"),normals:c&&ir(c),uvs:o&&ma(o,"texture coordinates"),colors:d,indices:l,material:fr(a,T(a.document.materials,b,"material"))}}s(Ha,"primitiveOf");function Ca(a,{attributes:e={},indices:r},b){return Object.entries({...e,indices:r}).map(([t,c])=>{let o=c===void 0?"":a.placeOf(c);return`${t}=${o.startsWith(":")?b:""}${o}`}).sort().join(" ")}s(Ca,"sameOf");function sr(a){let e=-1;for(let r of a)r>e&&(e=r);return e}s(sr,"greatest");function ma(a,e){let r=a instanceof Float32Array;for(let b=0;r&&b<a.length;b++)r=Number.isFinite(a[b]);if(!r)throw new Error(`expected ${e} that are finite numbers of 32 bits`);return a}s(ma,"finite");function ir(a){a instanceof Int8Array||ma(a,"normals");let e=new Float32Array(a.length);for(let r=0;r<a.length;r+=3){let[b,n,t]=[a[r],a[r+1],a[r+2]],c=Math.sqrt(b*b+n*n+t*t)||1;e[r]=b/c,e[r+1]=n/c,e[r+2]=t/c}return e}s(ir,"unitVectors");function fr(a,e){let{pbrMetallicRoughness:r={},alphaMode:b,alphaCutoff:n=.5}=e,[t,c,o,d,...l]=r.baseColorFactor??[1,1,1,1],f=[Number(t),Number(c),Number(o),Number(d)];if(l.length>0||!f.every(Number.isFinite)||!Number.isFinite(n))throw new Error("expected materials of finite numbers");let i=r.baseColorTexture,p=lr(e);return{color:f,image:i?Va(a,i.index):null,cutoff:b==="MASK"?n:null,emission:p,glow:p&&e.emissiveTexture?Va(a,e.emissiveTexture.index):null,isUnlit:e.extensions?.KHR_materials_unlit!==void 0}}s(fr,"materialOf");function lr({emissiveFactor:a=[0,0,0],extensions:e}){let r=e?.KHR_materials_emissive_strength?.emissiveStrength??1,[b,n,t,...c]=a,o=[Number(b)*r,Number(n)*r,Number(t)*r];if(c.length>0||!o.every(d=>Number.isFinite(d)&&d>=0))throw new Error("expected emission of three finite numbers of at least 0");return e?.KHR_materials_unlit===void 0&&o.some(d=>d>0)?o:null}s(lr,"emissionOf");function Va({document:a},e){let r=T(a.textures,e,"texture");return ua(T(a.images,r.extensions?.EXT_texture_webp?.source??r.source,"image"))}s(Va,"imageOf");function ua({uri:a}){if(typeof a!="string"||!/^[0-9a-f]{16}\\.[a-z]+$/.test(a))throw new Error("expected pictures that are files of the bundle");return N+a}s(ua,"pictureName");var Ia=2**18,dr=2**19;async function _a(a,e){let r=await mr(a.parts,e),{name:b}=a.glb,n=await pr(a,e);try{let t=Ea(n,e),[c,o]=await gr(t,a),d=hr(c,o,a),l=c.flatMap(({arrays:p,placed:h})=>h.map(A=>Xa(p,A))),f=d.map(p=>Xa(p,p)),i={own:l.reduce((p,h)=>p+h,0),drawn:f.reduce((p,h)=>p+h,0)};return{pieces:d,images:await ur(t,r,a.known),triangles:i}}catch(t){let c=L(t);throw new Error(c.startsWith(N)?c:`${b}: ${c}`)}}s(_a,"decodeGeometry");async function pr({glb:a,isDynamic:e},r){let b=a.name.slice(N.length);if(a.data===null){let t=r.get(b);if(!t)throw new Error(`${a.name} is not there`);return t}let n=await U(a);return e&&r.set(b,n),n}s(pr,"fileOf");function Xa({indices:a},{placements:e}){return a.length/3*(e?e.length/12:1)}s(Xa,"trianglesOf");async function mr(a,e){let r=new Map,n=(await Promise.allSettled(a.map(async t=>{let c=await U(t);r.set(t.name,c),t.name.endsWith(".bin")&&e.set(t.name.slice(N.length),c)}))).find(t=>t.status==="rejected");if(n)throw n.reason;return r}s(mr,"partsOf");async function ur(a,e,r){let b={};try{for(let n of X(a.document.images,"images")){let t=ua(n),c=e.get(t);if(c&&!Object.hasOwn(b,t))b[t]=await oa(t,c);else if(!c&&!r.includes(t))throw new Error(`${t} is not there`)}}catch(n){for(let t of Object.values(b))t.close();throw n}return b}s(ur,"imagesOf");async function gr(a,{glb:e,center:r,isDynamic:b}){let[n,...t]=X(a.document.nodes,"nodes"),c=wr(n?.translation,r),o=new Map;for(let l of t){if(l.mesh===void 0)continue;let f=await Ta(a,l),i=o.get(l.mesh)??[];o.set(l.mesh,i);let p=i.at(-1);p&&!b?p.rows.push(f):i.push({name:typeof l.name=="string"?l.name:"",rows:[f]})}let d=[];for(let[l,f]of o){let i=f.map(({name:p,rows:h})=>{let A=!b&&h.length===1&&h.every(Ka);return{name:p,placements:A?null:Ma(h,c)}});for(let p of X(T(a.document.meshes,l,"mesh").primitives,"primitives"))d.push({arrays:await Ha(a,p),same:Ca(a,p,e.name),placed:i})}return[d,c]}s(gr,"surfacesOf");function hr(a,e,{growth:r,isDynamic:b}){for(let n=Q;;n*=2){let t={left:dr},c=yr(a,e,Ba(b?za:r,n),t);if(t.left>=0)return c}}s(hr,"splitPieces");function yr(a,e,r,b){let n=[];for(let{arrays:t,same:c,placed:o}of a)for(let{name:d,placements:l}of o){let i=l?La(t,l,r,b):[{arrays:$(s(()=>({...t,positions:kr(t.positions,e)}),"lying")(),r,b),placements:l}];for(let p of i)for(let[h,A]of Pa(p.arrays).entries()){let x=p.arrays===t?`${c} ${h}`:null;if(p.placements?.length!==0&&n.push({...A,name:d,same:x,placements:p.placements}),n.length>Ia)throw new Error(`expected at most ${Ia} pieces of geometry`)}}return n}s(yr,"piecesOf");function wr(a,e){let[r,b,n]=a??[0,0,0],t=[Number(r)-e[0],Number(b)-e[1],Number(n)-e[2]];if(!t.every(Number.isFinite))throw new Error("expected an origin of three numbers");return t}s(wr,"offsetOf");function kr(a,e){return a.map((r,b)=>r+e[b%3])}s(kr,"translate");var[xr,Ar,vr,aa]=[0,1,2,8],S={high:{pair:3,byte:6,isBit:!0},some:{pair:4,byte:6,isBit:!1},calm:{pair:5,byte:6,isBit:!1},low:{pair:null,byte:7,isBit:!1}};function M(a){return new Error(`expected ranges of the listed tiles, got ${a}`)}s(M,"damaged");function $a(a){if(a.length<36)throw M("fewer bytes");let r=new DataView(a.buffer,a.byteOffset,36),b=[],n=36;for(let l=0;l<9;l++){let f=n;if(n+=r.getUint32(4*l,!0),n>a.length)throw M("fewer bytes");b.push(a.subarray(f,n))}if(n!==a.length)throw M("more bytes");let t=new Uint32Array(9);function c(l,f){let i=t[l],p=b[l]?.[i>>3];if(p===void 0)throw M("fewer bytes");return t[l]=i+f,p>>8-f-(i&7)&(1<<f)-1}s(c,"bits");function o(l){let f=t[l],i=b[l]?.[f];if(i===void 0)throw M("fewer bytes");return t[l]=f+1,i}s(o,"byteOf");function d(){let l=b[aa],f=l.length>>1,i=t[aa],[p,h]=[l[i],l[f+i]];if(i>=f||p===void 0||h===void 0)throw M("fewer bytes");return t[aa]=i+1,p<<8|h}return s(d,"word"),{changed:s(l=>l!==(c(xr,1)===1),"changed"),nothing:s(l=>l!==(c(Ar,1)===1),"nothing"),residual(l){let f=0;if(l.isBit){if(c(vr,1)===0)return 0;f=1}if(l.pair!==null){let h=c(l.pair,2);if(h<3)return f+h;f+=3}let i=o(l.byte),p=f+i+(i===255?d():0);if(p>65535)throw M("a number beyond 16 bits");return p},finish(){let l=s(f=>{let i=t[f];return f===aa?2*i:f>=6?i:i+7>>3},"whole");if(b.some((f,i)=>l(i)!==f.length))throw M("more bytes")}}}s($a,"readPlanes");var Ya=4;function Za(a){let[e,r]=[Qa(a),Qa(.5*a)],b=new Float64Array(65535),n=new Float64Array(65534);for(let c=0,o=1;c<65535;c++,o*=e)b[c]=1/o,c<n.length&&(n[c]=o*r);let t=n.length;return{nearness:s((c,o)=>o*b[c],"nearness"),code(c,o,d){if(!(c>0))return 65534;let l=o/c,f=Math.max(d-Ya,0),i=d+Ya;for(i<t&&(f===0||n[f-1]<=l)&&l<n[i]||([f,i]=[0,t]);f<i;){let h=f+i>>1;n[h]<=l?f=h+1:i=h}return f}}}s(Za,"createScale");function Qa(a){let e=1;for(let r=10;r>=1;r--)e=1+a/r*e;return e}s(Qa,"exponential");var[B,ga,jr]=[3,8,128],[V,ae,Er]=[1,64,8];function ha(a,e,r,b,n){let t=n.size*n.size,c=$a(a),o=Za(n.step),d=new Uint8Array(e.length),l=new Set(b);for(let f=0;f<e.length/t;f++){let[i,p]=[f*t,(f+1)*t],h={codes:e.subarray(i,p),before:r?.subarray(i,p)??null,changed:d.subarray(i,p)};Rr(f,h,l,n,o,c)}return c.finish(),d}s(ha,"decodeRanges");function ee(a){return{value:new Float64Array(a),slope:new Float64Array(a),count:new Uint8Array(a)}}s(ee,"createLines");function Rr(a,e,r,{size:b,tile:n},t,c){let o=b/n,d=ee(b),l=ee(1),f={last:0};for(let i=0;i<o;i++){let p=(a*o+i)*o,h=Array.from({length:o},(x,k)=>r.has(p+k)),A=h.map(x=>x||e.before===null);for(let x=0;x<b;x++)(i===0||!A[Math.floor(x/n)])&&(d.count[x]=0);for(let x=i*n;x<(i+1)*n;x++){let k=(2*x+1)/b-1;l.count[0]=0;for(let y=0;y<o;y++){if(!A[y]){l.count[0]=0;continue}for(let g=y*n;g<(y+1)*n;g++){let m=x*b+g;h[y]&&(e.changed[m]=c.changed(qr(e,g,x,b))?1:0);let u=(2*g+1)/b-1;Fr(e,g,x,b,Math.sqrt(1+u*u+k*k),l,d,f,t,c)}}}}}s(Rr,"decodeFace");function Fr(a,e,r,b,n,t,c,o,d,l){let{codes:f}=a,i=r*b+e,p=a.before===null||a.changed[i]===1,h=e>0?f[i-1]:65535,A=r>0?f[i-b]:65535,x=e>0&&r>0?f[i-b-1]:65535,k=f[i]===65535;if(p&&(k=l.nothing(ne(h===65535,A===65535,x===65535))),k){f[i]=65535,t.count[0]=0,c.count[e]=0;return}let y=e+1<b&&r>0?f[i-b+1]:65535,g=Pr(h,A,x,y,o.last),[m,u]=[t.count[0],c.count[e]],w=m>0?d.code(H(t,0),n,g):-1,v=u>0?d.code(H(c,e),n,g):-1;if(p){let F=g,E=h!==65535&&A!==65535&&Math.abs(h-A)<=Er?S.calm:S.low;m>=B&&u>=B?Math.abs(w-v)<=V?(F=d.code((H(t,0)*m+H(c,e)*u)/(m+u),n,w),E=m+u>2*ga?S.high:S.some):(F=Math.abs(w-g)<=Math.abs(v-g)?w:v,E=S.some):m>=B&&Math.abs(w-g)<=V?(F=w,E=m>ga?S.high:S.some):m<B&&u>=B&&Math.abs(v-g)<=V&&(F=v,E=u>ga?S.high:S.some);let q=l.residual(E),P=F+(q>>1^-(q&1))&65535;if(P===65535)throw M("a surface without range");f[i]=P}let j=f[i],R=d.nearness(j,n);re(t,0,R,m>0&&Math.abs(w-j)<=(m<2?ae:V)),re(c,e,R,u>0&&Math.abs(v-j)<=(u<2?ae:V)),o.last=j}s(Fr,"texel");function H(a,e){return a.value[e]+a.slope[e]}s(H,"next");function re(a,e,r,b){if(!b){a.value[e]=r,a.slope[e]=0,a.count[e]=1;return}let n=H(a,e),t=r-n,c=Math.min(a.count[e]+1,jr),o=1/(c*(c+1));a.count[e]=c,a.value[e]=n+(4*c-2)*o*t,a.slope[e]=a.slope[e]+6*o*t}s(re,"extend");function qr({before:a,changed:e},r,b,n){let t=b*n+r,c=r>0&&e[t-1]===1,o=b>0&&e[t-n]===1;if(r===0||b===0)return r===0?o:c;if(a===null)return ne(c,o,e[t-n-1]===1);let d=a[t],l=Math.abs(a[t-1]-d),f=Math.abs(a[t-n]-d);return l<=f?c:o}s(qr,"predictedChange");function Pr(a,e,r,b,n){if(a===65535||e===65535||r===65535)return[a,e,r,b].find(c=>c!==65535)??n;let t=a+e-r;return Math.max(Math.min(a,e),Math.min(Math.max(a,e),t))}s(Pr,"predicted");function ne(a,e,r){return r?a&&e:a||e}s(ne,"median");var J=6,be=4096,[ce,oe,se]=[36,4,9];function ie(){let a=null;return{async first({faceSize:e,tile:r,across:b,step:n,color:t}){if(Gr(e,r,b),t.length!==J)throw new Error(`map: expected six pictures, got ${t.length}`);let c=new Uint8Array(4*J*e*e);return(await Promise.all(t.map(d=>sa(d,e,e)))).forEach((d,l)=>c.set(d,l*d.length)),a={size:e,tile:r,across:b,step:n,color:c,codes:null,changed:[]},te(a)},async next(e){if(!a)throw new Error("map: a ring came before the first map");let{since:r,ring:b}=e;if(r!==null&&!(Number.isInteger(r)&&r>=0&&r<=b))throw new Error(`map: expected an earlier ring than ${b}, got ${r}`);return await Kr(a,e),r===null?te(a):Ur(a,r,b)}}}s(ie,"createMaps");function Gr(a,e,r){if(!([a,e,r].every(t=>Number.isInteger(t)&&t>0)&&a<=be&&a%e===0))throw new Error(`map: expected faces of up to ${be} texels in tiles, got ${a} in ${e}`)}s(Gr,"checkLayout");async function Kr(a,{ring:e,tiles:r,color:b,range:n}){let{size:t,tile:c}=a,o=t/c;if(e!==a.changed.length+1)throw new Error(`map: expected ring ${a.changed.length+1}, got ${e}`);let d=s(i=>Number.isInteger(i)&&i>=0&&i<J*o*o,"isTile");if(!r.every(d))throw new Error("map: expected tiles of the map, got others");let l=await(a.codes?Sr(a,a.codes,r,n):Mr(a,r,n)),f=await Tr(a,r.length,b);f&&Or(a,f,l.changed,r),a.codes=l.codes,a.changed.push([...r])}s(Kr,"apply");function Tr({tile:a,across:e},r,b){if(r===0)return null;if(!b)throw new Error("map: expected a picture of the tiles that change, got none");return sa(b,e*a,Math.ceil(r/e)*a)}s(Tr,"sheetOf");async function Mr(a,e,r){let b=a.size*a.size,n=(a.size/a.tile)**2;if(r.length!==J)throw new Error(`map: expected six files of ranges, got ${r.length}`);let t=new Uint16Array(J*b),c=new Uint8Array(J*b);return await Promise.all(r.map(async(o,d)=>{let l=await ta(o.name,await U(o),ce+se+oe*b),f=e.filter(p=>Math.floor(p/n)===d).map(p=>p%n),i=t.subarray(d*b,(d+1)*b);c.set(fe(o,()=>ha(l,i,null,f,a)),d*b)})),{codes:t,changed:c}}s(Mr,"firstCodes");async function Sr(a,e,r,b){let{tile:n}=a,[t]=b;if(b.length!==(r.length>0?1:0))throw new Error(`map: expected ranges exactly where tiles change, got ${b.length} files`);if(!t)return{codes:e,changed:new Uint8Array(e.length)};let c=await ta(t.name,await U(t),ce+se+oe*r.length*n*n),o=e.slice();return{codes:o,changed:fe(t,()=>ha(c,o,e,r,a))}}s(Sr,"laterCodes");function fe(a,e){try{return e()}catch(r){throw new Error(`${a.name}: ${L(r)}`)}}s(fe,"withFileName");function Or(a,e,r,b){let{size:n,tile:t,across:c}=a,o=n/t;b.forEach((d,l)=>{let f=Math.floor(d/(o*o)),[i,p]=[d%o,Math.floor(d/o)%o],[h,A]=[l%c*t,Math.floor(l/c)*t];for(let x=0;x<t;x++)for(let k=0;k<t;k++){let[y,g]=[i*t+k,p*t+x];if(!Dr(r,f*n*n,y,g,n))continue;let m=4*(f*n*n+g*n+y),u=4*((A+x)*c*t+h+k);for(let w=0;w<3;w++)a.color[m+w]=e[u+w]}})}s(Or,"putChanges");function Dr(a,e,r,b,n){for(let t=Math.max(b-1,0);t<=Math.min(b+1,n-1);t++)for(let c=Math.max(r-1,0);c<=Math.min(r+1,n-1);c++)if(a[e+t*n+c])return!0;return!1}s(Dr,"isNear");function te({size:a,color:e,codes:r}){let b=a*a,n=Array.from({length:J},(t,c)=>c);return{whole:!0,color:n.map(t=>e.slice(4*t*b,4*(t+1)*b)),codes:r&&n.map(t=>r.slice(t*b,(t+1)*b))}}s(te,"wholeMap");function Ur(a,e,r){let{size:b,tile:n,color:t,codes:c}=a;if(!c)throw new Error("map: a ring has no ranges");let o=Int32Array.from(new Set(a.changed.slice(e,r).flat())).sort(),d=b/n,l={whole:!1,tiles:o,color:new Uint8Array(4*o.length*n*n),codes:new Uint16Array(o.length*n*n)};return o.forEach((f,i)=>{let p=Math.floor(f/(d*d)),[h,A]=[f%d,Math.floor(f/d)%d];for(let x=0;x<n;x++){let k=p*b*b+(A*n+x)*b+h*n,y=(i*n+x)*n;l.color.set(t.subarray(4*k,4*(k+n)),4*y),l.codes.set(c.subarray(k,k+n),y)}}),l}s(Ur,"changedTiles");function le(a,e){let r=[],[b,n]=[0,0],t=s(o=>{let d=r.at(-1);return(!d||b===32||n+o>4194304)&&(d={bands:[],pieces:[]},r.push(d),[b,n]=[0,0]),b+=1,n+=o,d},"place");for(let o of a)t(4*o.rows.width*o.rows.height).bands.push(o);let c=new Set;for(let o of e){let{same:d,placements:l}=o,f=d!==null&&c.has(d)?ue(o):o,i=l&&c.has(l)?{...f,placements:l.slice()}:f;c.add(d).add(l),t(me(i).reduce((p,h)=>p+h.byteLength,0)).pieces.push(i)}return r}s(le,"parcelled");function de(a){let e=new Map;for(let r of a){let{normals:b,uvs:n,colors:t,placements:c,material:o}=r,{image:d,cutoff:l,emission:f,glow:i,isUnlit:p}=o,A=[...[b,n,t,c,d,l,f,i].map(x=>x!==null),p].join();e.has(A)||e.set(A,{...ue(r),placements:c&&new Float32Array(0)})}return[...e.values()]}s(de,"samplesOf");function pe({bands:a,pieces:e}){let r=e.flatMap(me).map(b=>b.buffer);return[...new Set(r),...a.map(({rows:b})=>b)]}s(pe,"contentsOf");function me({positions:a,normals:e,uvs:r,colors:b,indices:n,placements:t}){return[a,e,r,b,n,t].filter(c=>c!==null)}s(me,"arraysOf");function ue(a){let{normals:e,uvs:r,colors:b}=a;return{...a,positions:new Float32Array(0),normals:e&&new Float32Array(0),uvs:r&&new Float32Array(0),colors:b&&new Uint16Array(0),indices:new Uint16Array(0)}}s(ue,"emptied");var ea=new Map,ya=new Map,C=new Map,ge=Promise.resolve();self.onmessage=({data:a})=>{a.kind==="part"||a.kind==="drop"?he(a):ge=ge.then(()=>he(a))};async function he(a){try{let e=await Lr(a);we({id:a.id,result:e},zr(e))}catch(e){we({id:a.id,error:L(e)},[])}}s(he,"answer");async function Lr(a){switch(a.kind){case"geometry":return Wr(a);case"part":return Nr(a);case"drop":for(let{rows:e}of C.get(a.of)?.flatMap(({bands:r})=>r)??[])e.close();return C.delete(a.of),null;case"first-map":return ea.set(a.region,ie()),ye(a.region).first(a);case"next-map":return ye(a.region).next(a);case"forget":return Jr(a)}}s(Lr,"work");async function Wr(a){let{pieces:e,images:r,triangles:b}=await _a(a,ya),n=le(await Fa(r),e);return C.set(a.id,n),{number:a.id,parts:n.length,samples:de(e),triangles:b}}s(Wr,"geometry");function Nr({of:a,part:e}){let r=C.get(a),b=r?.[e];if(!r||!b)throw new Error(`geometry ${a} has no part ${e}`);return e===r.length-1&&C.delete(a),b}s(Nr,"part");function ye(a){let e=ea.get(a);if(!e)throw new Error("map: a ring came before the first map");return e}s(ye,"mapsOf");function Jr({buffers:a,region:e}){for(let b of a)ya.delete(b.slice(N.length));ea.delete(e);let r=[...ya.values()].map(({byteLength:b})=>b);return{buffers:r.length,bytes:r.reduce((b,n)=>b+n,0),maps:ea.size}}s(Jr,"forget");function we(a,e){self.postMessage(a,{transfer:e})}s(we,"post");function zr(a){if(!a||"buffers"in a||"parts"in a)return[];if("pieces"in a)return pe(a);let e=a.whole?[...a.color,...a.codes??[]]:[a.tiles,a.color,a.codes];return[...new Set(e.map(r=>r.buffer))]}s(zr,"transferred");\n';var hi={right:0,ahead:0,turn:0,look:0,isHasty:!1};function Zr(...i){let e=o(a=>i.reduce((c,l)=>c+a(l),0),"sum"),[t,n]=$r(e(a=>a.right),e(a=>a.ahead)),[r,s]=$r(e(a=>a.turn),e(a=>a.look));return{right:t,ahead:n,turn:r,look:s,isHasty:i.some(a=>a.isHasty)}}o(Zr,"together");function $r(i,e){let t=Math.max(Math.hypot(i,e),1);return[i/t,e/t]}o($r,"clampLength");function rr(i,e,t){let n=Math.hypot(i,e);if(!(n>t))return[0,0];let r=Math.min((n-t)/(1-t),1)/n;return[i*r,e*r]}o(rr,"beyondRest");var Jc=.18,Hd=[4,10];function $c(i){let e=i.filter(t=>t!==null&&t.connected&&t.mapping==="standard");return e.length===0?hi:Zr(...e.map(t=>t?Wd(t):hi))}o($c,"readPads");function Wd({axes:i,buttons:e}){let[t,n]=rr(i[0]??0,i[1]??0,Jc),[r,s]=rr(i[2]??0,i[3]??0,Jc),a=Hd.some(c=>e[c]?.pressed??!1);return{right:t,ahead:0-n,turn:0-r,look:0-s,isHasty:a}}o(Wd,"wishOf");var Zc={KeyW:[0,1,0,0],KeyS:[0,-1,0,0],KeyA:[-1,0,0,0],KeyD:[1,0,0,0],ArrowUp:[0,1,0,0],ArrowDown:[0,-1,0,0],ArrowLeft:[0,0,1,0],ArrowRight:[0,0,-1,0],PageUp:[0,0,0,1],PageDown:[0,0,0,-1]};function qd(i){return Object.hasOwn(Zc,i)}o(qd,"isMoving");function Xd(i){if(i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey)return!0;let{target:e}=i;return typeof Element<"u"&&e instanceof Element&&e.closest(Kd)!==null}o(Xd,"isElsewhere");var Kd="input, textarea, select, [contenteditable], dialog[open]";function Qc(i){let e=new Set,t=new AbortController,n=o((s,a)=>i.addEventListener(s,a,{signal:t.signal}),"listen"),r=!1;return n("keydown",s=>{let a=s;r=a.shiftKey,!(!qd(a.code)||Xd(a))&&(e.add(a.code),a.preventDefault())}),n("keyup",s=>{r=s.shiftKey,e.delete(s.code),s.key==="Meta"&&e.clear()}),n("blur",()=>{e.clear(),r=!1}),{get drive(){let s=[0,0,0,0];for(let d of e)Zc[d]?.forEach((f,g)=>s[g]=(s[g]??0)+f);let[a=0,c=0,l=0,h=0]=s,[u,p]=$r(a,c);return{right:u,ahead:p,turn:Math.sign(l),look:Math.sign(h),isHasty:r}},dispose:o(()=>t.abort(),"dispose")}}o(Qc,"createKeys");function Qr(i,e,t){let n=t&&co(e,t.open),r=n?nl(i,e,n):e;for(let s of t?.shown??[]){let a=Math.max(kt(i,s),s.metres),c=kt(r,s);c>a&&(r=ts(r,a,c,s))}return r}o(Qr,"confine");function oo(i,e,t){let n=t&&co(e,t.open),r=n?el(i,e,kt(nl(i,e,n),n),n):1,s=(t?.shown??[]).map(a=>el(i,e,a.metres,a));return Math.min(r,...s)}o(oo,"allowedShare");function es(i,e,t){let n=e&&co(i,e.open),r=i;for(let s of new Set([...n?[n]:[],...e?.shown??[]])){let a=kt(r,s);a<=s.metres||(r=ts(r,s.metres+(a-s.metres)*Math.exp(-3*t),a,s))}return r}o(es,"settle");function kt([i,,e],{center:t}){return Math.hypot(i-t[0],e-t[2])}o(kt,"distance");function tl(i,e){let t=kt(i,e);return t<=e.metres?i:ts(i,e.metres,t,e)}o(tl,"clampToLimit");function co(i,e){let t=o(n=>n.metres-kt(i,n),"room");return e.reduce((n,r)=>n&&t(n)>=t(r)?n:r,null)}o(co,"roomiest");function nl(i,e,t){let[n,r]=[kt(i,t),kt(e,t)],s=.8*t.metres,a=Math.max(n,s);if(r<=a)return e;let c=t.metres-s,l=a>=t.metres?a:t.metres-(t.metres-a)*Math.exp((a-r)/c);return ts(e,l,r,t)}o(nl,"slowed");function el(i,e,t,n){let[r,s]=[kt(i,n),kt(e,n)];return s<=r||s<=t?1:Math.max(t-r,0)/(s-r)}o(el,"shareOf");function ts([i,e,t],n,r,{center:s}){let a=n/r;return[s[0]+a*(i-s[0]),e,s[2]+a*(t-s[2])]}o(ts,"atDistance");function qn(i,e,t){return Math.min(Math.max(i,e),t)}o(qn,"bounded");function sr({yaw:i,pitch:e}){return[-Math.sin(i)*Math.cos(e),Math.sin(e),-Math.cos(i)*Math.cos(e)]}o(sr,"ahead");function ns(i){return[Math.cos(i),0,-Math.sin(i)]}o(ns,"rightOf");function il({yaw:i,pitch:e}){return[Math.sin(i)*Math.sin(e),Math.cos(e),Math.cos(i)*Math.sin(e)]}o(il,"upOf");function xn(i,e,t){return[i[0]+t*e[0],i[1]+t*e[1],i[2]+t*e[2]]}o(xn,"addScaled");function rl(i,e){return[i[0]-e[0],i[1]-e[1],i[2]-e[2]]}o(rl,"minus");function sl(i,e){return i.yaw===e.yaw&&i.pitch===e.pitch&&i.position.every((t,n)=>t===e.position[n])}o(sl,"isSamePose");var[al,ol,cl]=[.3,2e3,4],[ll,jd,hl]=[1.4,1.2,.8];function ul(i,e){let t=i,n=cl,r=o(()=>xn(t.position,sr(t),n),"target");function s(h,u){let[p,d,f]=xn(u,h,-1),g=Math.hypot(p,f);n=qn(Math.hypot(g,d),al,ol);let y=g>1e-9?Yd(Math.atan2(-p,-f),t.yaw):t.yaw;t={position:h,yaw:y,pitch:qn(Math.atan2(d,g),-1.5,1.5)}}o(s,"put");function a(h,u){if(h===0&&u===0)return;let p=r(),d={yaw:t.yaw+h,pitch:qn(t.pitch+u,-1.5,1.5)},f=xn(p,sr(d),-n),g=Qr(t.position,f,e());g===f?t={...d,position:f}:s(g,p)}o(a,"rotate");function c(h){if(!(h>0)||h===1)return;let u=qn(n*h,al,ol),p=xn(r(),sr(t),-u),d=oo(t.position,p,e()),f=xn(t.position,sr(t),d*(n-u));n+=d*(u-n),t={...t,position:f}}o(c,"zoom");function l(h,u){let p=xn(xn([0,0,0],ns(t.yaw),h*n),il(t),u*n),d=oo(t.position,xn(t.position,p,1),e());t={...t,position:xn(t.position,p,d)}}return o(l,"pan"),{get pose(){return t},update(h,{right:u,ahead:p,turn:d,look:f,isHasty:g}){g?l(hl*h*u,hl*h*p):c(Math.exp(-jd*h*p));let y=g?d:d-u;a(ll*h*y,ll*h*f),t={...t,position:es(t.position,e(),h)}},rotate:a,zoom:c,pan:l,setPose(h){t=h,n=cl}}}o(ul,"createOrbit");function Yd(i,e){return i+2*Math.PI*Math.round((e-i)/(2*Math.PI))}o(Yd,"nearest");var[Jd,$d,Zd]=[300,400,16];function dl(i){let e=new Map,t=null,n=o((r,s)=>Math.hypot(r.clientX-s.clientX,r.clientY-s.clientY)<=Zd,"isNear");return{down(r){e.size>0&&(t=null),e.set(r.pointerId,r)},up(r){let s=e.get(r.pointerId),a=e.size===1;if(e.delete(r.pointerId),!(s&&a&&r.timeStamp-s.timeStamp<=Jd&&n(s,r))){t=null;return}let l=t!==null&&r.timeStamp-t.timeStamp<=$d&&n(t,r);t=l?null:r,l&&i(r)}}}o(dl,"createTaps");var[is,fl]=[1.6,Math.PI],lo=1.5,Qd=.0015,ef=[1,16,400],pl=56,tf=.12;function ml(i,e){let t=new Map,n=new AbortController,r=hi,s=dl(h),a=!1,c=o(()=>1/Math.max(i.clientHeight,1),"scale"),l=o(()=>i.ownerDocument.pointerLockElement===i,"isLocked");function h({clientX:S,clientY:E}){let{left:_,top:A,width:U,height:I}=i.getBoundingClientRect();l()?e.go(.5,.5):e.go((S-_)/Math.max(U,1),(E-A)/Math.max(I,1))}o(h,"go");function u(S){if(l())return;a=S.pointerType==="touch";let E=S.pointerType==="mouse",_=S.button===0&&!S.shiftKey;if(e.mode()==="walk"&&E&&!_)return;i.setPointerCapture(S.pointerId),a&&s.down(S);let A=p(S)?"step":_?"turn":"pan";t.set(S.pointerId,{x:S.clientX,y:S.clientY,task:A}),A==="step"&&f({x:S.clientX,y:S.clientY},S)}o(u,"down");function p({pointerType:S,clientX:E}){if(e.mode()!=="walk"||S!=="touch"||[...t.values()].some(({task:U})=>U==="step"))return!1;let{left:_,width:A}=i.getBoundingClientRect();return E-_<A/2}o(p,"isThumb");function d(S){let E=t.get(S.pointerId);if(!E){l()&&e.look(-S.movementX*is*c(),-S.movementY*is*c());return}if(E.task==="step"){f(E,S);return}let _={...E,x:S.clientX,y:S.clientY},A=[...t].find(([D,{task:F}])=>D!==S.pointerId&&F!=="step")?.[1],[U,I]=[(_.x-E.x)*c(),(_.y-E.y)*c()];t.set(S.pointerId,_),e.mode()==="walk"?e.look(U*is,I*is):A?g(E,_,A):E.task==="pan"?e.pan(-U*lo,I*lo):e.rotate(-U*fl,-I*fl)}o(d,"move");function f({x:S,y:E},{clientX:_,clientY:A}){let[U,I]=rr((_-S)/pl,(A-E)/pl,tf);r={...hi,right:U,ahead:0-I},e.thumb({x:S,y:E,right:_-S,down:A-E})}o(f,"step");function g(S,E,_){let[A,U]=[S,E].map(({x:D,y:F})=>Math.hypot(D-_.x,F-_.y));A&&U&&e.zoom(A/U);let I=.5*lo*c();e.pan(-(E.x-S.x)*I,(E.y-S.y)*I)}o(g,"pinch");function y(S){S.pointerType==="touch"&&s.up(S),t.get(S.pointerId)?.task==="step"&&m(),t.delete(S.pointerId)}o(y,"up");function m(){r=hi,e.thumb(null)}o(m,"rest");function b(S){e.mode()==="orbit"&&(S.preventDefault(),e.zoom(Math.exp(Qd*S.deltaY*(ef[S.deltaMode]??1)*(S.ctrlKey?6:1))))}o(b,"wheel");function w(){e.mode()==="walk"&&Promise.resolve(i.requestPointerLock()).catch(()=>{})}o(w,"lock");let{signal:T}=n;i.addEventListener("pointerdown",u,{signal:T}),i.addEventListener("pointermove",d,{signal:T}),i.addEventListener("pointerup",y,{signal:T}),i.addEventListener("pointercancel",y,{signal:T}),i.addEventListener("dblclick",S=>a||h(S),{signal:T}),i.addEventListener("wheel",b,{signal:T,passive:!1}),i.addEventListener("contextmenu",S=>S.preventDefault(),{signal:T});function x(){t.clear(),m(),l()&&i.ownerDocument.exitPointerLock()}return o(x,"release"),{get drive(){return r},lock:w,release:x,dispose(){x(),n.abort()}}}o(ml,"createPointers");var[nf,rf]=[1.6,3],gl=1.4,[bl,sf]=[.09,.25],af=1/120;function xl(i,e,t){let{position:n,yaw:r,pitch:s}=i,a=n[1],c=[0,0];function l(u,p){let d=gl*p.turn*u,f=r+d/2;r+=d,s=qn(s+gl*p.look*u,-1.5,1.5);let g=nf*(p.isHasty?rf:1),[y,m]=_l(c[0],g*p.right,u,t()),[b,w]=_l(c[1],g*p.ahead,u,t());c=[m,w];let[T,,x]=ns(f),S=t()?0:(n[1]-a)*Math.exp(-u/sf),E=[n[0]+T*y+x*b,a+S,n[2]+x*y-T*b];n=es(Qr(n,E,e()),e(),u)}o(l,"step");function h(u){({position:n,yaw:r,pitch:s}=u),a=n[1]}return o(h,"follow"),{get pose(){return{position:n,yaw:r,pitch:s}},update(u,p){let d=Math.ceil(u/af);for(let f=0;f<d;f++)l(u/d,p)},look(u,p){r+=u,s=qn(s+p,-1.5,1.5)},setPose(u){h(u),c=[0,0]},follow:h,resume(u){({position:n,yaw:r,pitch:s}=u),c=[0,0]}}}o(xl,"createWalk");function _l(i,e,t,n){if(n)return[e*t,e];let r=Math.exp(-t/bl);return[e*t+(i-e)*bl*(1-r),e+(i-e)*r]}o(_l,"glide");var of=.5;function yl(i,e){let{start:t,onChange:n,onThumb:r,onGo:s,pads:a=cf,isSudden:c=lf()}=e,l="walk",h=null,u=t,p=xl(t,()=>h,c),d=ul(t,()=>h),f=Qc(e.keys??window),g=ml(i,{mode:o(()=>l,"mode"),look:p.look,rotate:d.rotate,pan:d.pan,zoom:d.zoom,thumb:o(m=>r?.(m),"thumb"),go:o((m,b)=>s?.(m,b),"go")}),y=o(()=>l==="walk"?p.pose:d.pose,"current");return{update(m){let b=Zr(f.drive,g.drive,$c(a())),w=m>0?Math.min(m,of):0;l==="walk"?p.update(w,b):d.update(w,b);let T=y();return sl(T,u)||n?.(T),u=T,T},get mode(){return l},setMode(m){if(m===l)return;let b=y();g.release(),l=m,l==="walk"?p.resume(b):d.setPose(b)},setPose(m){p.setPose(m),d.setPose(m)},lookAround:g.lock,setBounds(m){h=m},dispose(){f.dispose(),g.dispose()}}}o(yl,"createControls");function cf(){try{return navigator.getGamepads?.()??[]}catch{return[]}}o(cf,"browserPads");function lf(){let i=window.matchMedia("(prefers-reduced-motion: reduce)");return()=>i.matches}o(lf,"reducedMotion");var je=class extends Error{constructor(t,n="damaged"){super(t);this.kind=n}kind;static{o(this,"BundleError")}name="BundleError"};function ho(i){return{...i,regions:i.regions.map(hf)}}o(ho,"byFootprint");function hf(i,e){let{by_footprint:t,rings:n}=i;if(!t){let c=`manifest.json: regions[${e}].by_footprint`;throw new je(`${c}: expected objects by footprint, got none: export the scene with by_footprint=True`,"address")}let r=n[n.length-1]?.radius??0,s={objects:0,triangles:0,geometry:null,parts:[]},a=t.portions.map(c=>({...c,radius:r,map:null}));return{...i,rings:[{...s,radius:0,map:null},...a,{...s,radius:r,map:t.map}]}}o(hf,"inPortions");var vl=o(i=>i,"asItIs"),uo={clovr:{isSmooth:!0,isWhole:!1,arrange:vl,isByRings:!0},clovrd:{isSmooth:!1,isWhole:!1,arrange:vl,isByRings:!0},vis0:{isSmooth:!1,isWhole:!0,arrange:ho,isByRings:!1},vis1:{isSmooth:!1,isWhole:!1,arrange:ho,isByRings:!1}};function Sl(i){let e=Object.hasOwn(uo,i??"clovr")?uo[i??"clovr"]:void 0;if(!e)throw new je(`strategy: expected ${Object.keys(uo).join(", ")}, got ${i??""}`,"address");return e}o(Sl,"strategyOf");var Wl=0,zo=1,ql=2;var Rr=1,Xl=2,ji=3,ii=0,Ft=1,rn=2,On=0,Yi=1,Go=2,Vo=3,Ho=4,Ji=5;var xi=100,Kl=101,jl=102,Yl=103,Jl=104,$l=200,$i=201,Zl=202,Ql=203,Cr=204,ri=205,eh=206,th=207,nh=208,ih=209,rh=210,sh=211,ah=212,oh=213,ch=214,As=0,Ts=1,Rs=2,Gi=3,Cs=4,Ps=5,Is=6,Ls=7,Wo=0,lh=1,hh=2,En=0,qo=1,Xo=2,Ko=3,jo=4,Yo=5,Jo=6,$o=7;var Zo=300,yi=301,Zi=302,ra=303,sa=304,Ds=1e3,vn=1001,Ns=1002,yt=1003,uh=1004;var Pr=1005;var Nt=1006,aa=1007;var Bn=1008;var Xt=1009,Qo=1010,ec=1011,Qi=1012,oa=1013,Kt=1014,pn=1015,mn=1016,ca=1017,la=1018,vi=1020,tc=35902,nc=35899,ic=1021,rc=1022,gn=1023,Fn=1026,kn=1027,sc=1028,ha=1029,si=1030,ua=1031;var da=1033,Ir=33776,Lr=33777,Dr=33778,Nr=33779,fa=35840,pa=35841,ma=35842,ga=35843,ba=36196,_a=37492,xa=37496,ya=37488,va=37489,Ur=37490,Sa=37491,Ma=37808,wa=37809,Ea=37810,Aa=37811,Ta=37812,Ra=37813,Ca=37814,Pa=37815,Ia=37816,La=37817,Da=37818,Na=37819,Ua=37820,Fa=37821,Oa=36492,Ba=36494,ka=36495,za=36283,Ga=36284,Fr=36285,Va=36286;var ur=2300,Us=2301,ws=2302,No=2303,Uo=2400,Fo=2401,Oo=2402;var dh=3200;var ac=0,fh=1,zn="",Vt="srgb",dr="srgb-linear",fr="linear",Ye="srgb";var Es=7680;var ph=519,mh=512,gh=513,bh=514,oc=515,_h=516,xh=517,cc=518,lc=519,yh=35044;var Gn="300 es",en=2e3,pr=2001;function uf(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}o(uf,"arrayNeedsUint32");function df(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}o(df,"isTypedArray");function mr(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}o(mr,"createElementNS");function vh(){let i=mr("canvas");return i.style.display="block",i}o(vh,"createCanvasElement");var Ml={},Vi=null;function gr(...i){let e="THREE."+i.shift();Vi?Vi("log",e,...i):console.log(e,...i)}o(gr,"log");function Sh(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}o(Sh,"enhanceLogMessage");function Pe(...i){i=Sh(i);let e="THREE."+i.shift();if(Vi)Vi("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}o(Pe,"warn");function Ie(...i){i=Sh(i);let e="THREE."+i.shift();if(Vi)Vi("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}o(Ie,"error");function hr(...i){let e=i.join(" ");e in Ml||(Ml[e]=!0,Pe(...i))}o(hr,"warnOnce");function Mh(i,e,t){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:n()}}o(s,"probe"),setTimeout(s,t)})}o(Mh,"probeAsync");var wh={[As]:As,[Rs]:Is,[Cs]:Cs,[Gi]:Ps,[Ts]:Ts,[Is]:Rs,[Ls]:Ls,[Ps]:Gi},Sn=class{static{o(this,"EventDispatcher")}addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let s=0,a=r.length;s<a;s++)r[s].call(this,e);e.target=null}}},At=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var fo=Math.PI/180,Fs=180/Math.PI;function Or(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(At[i&255]+At[i>>8&255]+At[i>>16&255]+At[i>>24&255]+"-"+At[e&255]+At[e>>8&255]+"-"+At[e>>16&15|64]+At[e>>24&255]+"-"+At[t&63|128]+At[t>>8&255]+"-"+At[t>>16&255]+At[t>>24&255]+At[n&255]+At[n>>8&255]+At[n>>16&255]+At[n>>24&255]).toLowerCase()}o(Or,"generateUUID");function He(i,e,t){return Math.max(e,Math.min(t,i))}o(He,"clamp");function ff(i,e){return(i%e+e)%e}o(ff,"euclideanModulo");function po(i,e,t){return(1-t)*i+t*e}o(po,"lerp");function Eh(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}o(Eh,"floorPowerOfTwo");function Ha(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}o(Ha,"getNormalizationScale");function Ah(i,e){if(e.constructor===Float32Array)return i;let t=Ha(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}o(Ah,"denormalize");function Th(i,e){if(e.constructor===Float32Array)return i;let t=Ha(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}o(Th,"normalize");var Xe=class{static{o(this,"Vector2")}static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=He(this.x,e.x,t.x),this.y=He(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=He(this.x,e,t),this.y=He(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(He(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(He(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),s=this.x-e.x,a=this.y-e.y;return this.x=s*n-a*r+e.x,this.y=s*r+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Mn=class{static{o(this,"Quaternion")}constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,s,a,c){let l=n[r+0],h=n[r+1],u=n[r+2],p=n[r+3],d=s[a+0],f=s[a+1],g=s[a+2],y=s[a+3];if(p!==y||l!==d||h!==f||u!==g){let m=l*d+h*f+u*g+p*y;m<0&&(d=-d,f=-f,g=-g,y=-y,m=-m);let b=1-c;if(m<.9995){let w=Math.acos(m),T=Math.sin(w);b=Math.sin(b*w)/T,c=Math.sin(c*w)/T,l=l*b+d*c,h=h*b+f*c,u=u*b+g*c,p=p*b+y*c}else{l=l*b+d*c,h=h*b+f*c,u=u*b+g*c,p=p*b+y*c;let w=1/Math.sqrt(l*l+h*h+u*u+p*p);l*=w,h*=w,u*=w,p*=w}}e[t]=l,e[t+1]=h,e[t+2]=u,e[t+3]=p}static multiplyQuaternionsFlat(e,t,n,r,s,a){let c=n[r],l=n[r+1],h=n[r+2],u=n[r+3],p=s[a],d=s[a+1],f=s[a+2],g=s[a+3];return e[t]=c*g+u*p+l*f-h*d,e[t+1]=l*g+u*d+h*p-c*f,e[t+2]=h*g+u*f+c*d-l*p,e[t+3]=u*g-c*p-l*d-h*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,s=e._z,a=e._order,c=Math.cos,l=Math.sin,h=c(n/2),u=c(r/2),p=c(s/2),d=l(n/2),f=l(r/2),g=l(s/2);switch(a){case"XYZ":this._x=d*u*p+h*f*g,this._y=h*f*p-d*u*g,this._z=h*u*g+d*f*p,this._w=h*u*p-d*f*g;break;case"YXZ":this._x=d*u*p+h*f*g,this._y=h*f*p-d*u*g,this._z=h*u*g-d*f*p,this._w=h*u*p+d*f*g;break;case"ZXY":this._x=d*u*p-h*f*g,this._y=h*f*p+d*u*g,this._z=h*u*g+d*f*p,this._w=h*u*p-d*f*g;break;case"ZYX":this._x=d*u*p-h*f*g,this._y=h*f*p+d*u*g,this._z=h*u*g-d*f*p,this._w=h*u*p+d*f*g;break;case"YZX":this._x=d*u*p+h*f*g,this._y=h*f*p+d*u*g,this._z=h*u*g-d*f*p,this._w=h*u*p-d*f*g;break;case"XZY":this._x=d*u*p-h*f*g,this._y=h*f*p-d*u*g,this._z=h*u*g+d*f*p,this._w=h*u*p+d*f*g;break;default:Pe("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],s=t[8],a=t[1],c=t[5],l=t[9],h=t[2],u=t[6],p=t[10],d=n+c+p;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(s-h)*f,this._z=(a-r)*f}else if(n>c&&n>p){let f=2*Math.sqrt(1+n-c-p);this._w=(u-l)/f,this._x=.25*f,this._y=(r+a)/f,this._z=(s+h)/f}else if(c>p){let f=2*Math.sqrt(1+c-n-p);this._w=(s-h)/f,this._x=(r+a)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+p-n-c);this._w=(a-r)/f,this._x=(s+h)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(He(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,s=e._z,a=e._w,c=t._x,l=t._y,h=t._z,u=t._w;return this._x=n*u+a*c+r*h-s*l,this._y=r*u+a*l+s*c-n*h,this._z=s*u+a*h+n*l-r*c,this._w=a*u-n*c-r*l-s*h,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,s=e._z,a=e._w,c=this.dot(e);c<0&&(n=-n,r=-r,s=-s,a=-a,c=-c);let l=1-t;if(c<.9995){let h=Math.acos(c),u=Math.sin(h);l=Math.sin(l*h)/u,t=Math.sin(t*h)/u,this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{o(this,"Vector3")}static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(wl.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(wl.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6]*r,this.y=s[1]*t+s[4]*n+s[7]*r,this.z=s[2]*t+s[5]*n+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=e.elements,a=1/(s[3]*t+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*n+s[8]*r+s[12])*a,this.y=(s[1]*t+s[5]*n+s[9]*r+s[13])*a,this.z=(s[2]*t+s[6]*n+s[10]*r+s[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,s=e.x,a=e.y,c=e.z,l=e.w,h=2*(a*r-c*n),u=2*(c*t-s*r),p=2*(s*n-a*t);return this.x=t+l*h+a*p-c*u,this.y=n+l*u+c*h-s*p,this.z=r+l*p+s*u-a*h,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*n+s[8]*r,this.y=s[1]*t+s[5]*n+s[9]*r,this.z=s[2]*t+s[6]*n+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=He(this.x,e.x,t.x),this.y=He(this.y,e.y,t.y),this.z=He(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=He(this.x,e,t),this.y=He(this.y,e,t),this.z=He(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(He(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,s=e.z,a=t.x,c=t.y,l=t.z;return this.x=r*l-s*c,this.y=s*a-n*l,this.z=n*c-r*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return mo.copy(this).projectOnVector(e),this.sub(mo)}reflect(e){return this.sub(mo.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(He(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},mo=new G,wl=new Mn,Le=class{static{o(this,"Matrix3")}static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,s,a,c,l,h){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,a,c,l,h)}set(e,t,n,r,s,a,c,l,h){let u=this.elements;return u[0]=e,u[1]=r,u[2]=c,u[3]=t,u[4]=s,u[5]=l,u[6]=n,u[7]=a,u[8]=h,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,a=n[0],c=n[3],l=n[6],h=n[1],u=n[4],p=n[7],d=n[2],f=n[5],g=n[8],y=r[0],m=r[3],b=r[6],w=r[1],T=r[4],x=r[7],S=r[2],E=r[5],_=r[8];return s[0]=a*y+c*w+l*S,s[3]=a*m+c*T+l*E,s[6]=a*b+c*x+l*_,s[1]=h*y+u*w+p*S,s[4]=h*m+u*T+p*E,s[7]=h*b+u*x+p*_,s[2]=d*y+f*w+g*S,s[5]=d*m+f*T+g*E,s[8]=d*b+f*x+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],a=e[4],c=e[5],l=e[6],h=e[7],u=e[8];return t*a*u-t*c*h-n*s*u+n*c*l+r*s*h-r*a*l}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],a=e[4],c=e[5],l=e[6],h=e[7],u=e[8],p=u*a-c*h,d=c*l-u*s,f=h*s-a*l,g=t*p+n*d+r*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=p*y,e[1]=(r*h-u*n)*y,e[2]=(c*n-r*a)*y,e[3]=d*y,e[4]=(u*t-r*l)*y,e[5]=(r*s-c*t)*y,e[6]=f*y,e[7]=(n*l-h*t)*y,e[8]=(a*t-n*s)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,s,a,c){let l=Math.cos(s),h=Math.sin(s);return this.set(n*l,n*h,-n*(l*a+h*c)+a+e,-r*h,r*l,-r*(-h*a+l*c)+c+t,0,0,1),this}scale(e,t){return hr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(go.makeScale(e,t)),this}rotate(e){return hr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(go.makeRotation(-e)),this}translate(e,t){return hr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(go.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},go=new Le,El=new Le().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Al=new Le().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function pf(){let i={enabled:!0,workingColorSpace:dr,spaces:{},convert:o(function(r,s,a){return this.enabled===!1||s===a||!s||!a||(this.spaces[s].transfer===Ye&&(r.r=Un(r.r),r.g=Un(r.g),r.b=Un(r.b)),this.spaces[s].primaries!==this.spaces[a].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Ye&&(r.r=zi(r.r),r.g=zi(r.g),r.b=zi(r.b))),r},"convert"),workingToColorSpace:o(function(r,s){return this.convert(r,this.workingColorSpace,s)},"workingToColorSpace"),colorSpaceToWorking:o(function(r,s){return this.convert(r,s,this.workingColorSpace)},"colorSpaceToWorking"),getPrimaries:o(function(r){return this.spaces[r].primaries},"getPrimaries"),getTransfer:o(function(r){return r===zn?fr:this.spaces[r].transfer},"getTransfer"),getToneMappingMode:o(function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},"getToneMappingMode"),getLuminanceCoefficients:o(function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},"getLuminanceCoefficients"),define:o(function(r){Object.assign(this.spaces,r)},"define"),_getMatrix:o(function(r,s,a){return r.copy(this.spaces[a].fromXYZ).multiply(this.spaces[s].toXYZ)},"_getMatrix"),_getDrawingBufferColorSpace:o(function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},"_getDrawingBufferColorSpace"),_getUnpackColorSpace:o(function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace},"_getUnpackColorSpace")},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[dr]:{primaries:e,whitePoint:n,transfer:fr,toXYZ:El,fromXYZ:Al,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Vt},outputColorSpaceConfig:{drawingBufferColorSpace:Vt}},[Vt]:{primaries:e,whitePoint:n,transfer:Ye,toXYZ:El,fromXYZ:Al,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Vt}}}),i}o(pf,"createColorManagement");var Ve=pf();function Un(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}o(Un,"SRGBToLinear");function zi(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}o(zi,"LinearToSRGB");var Ti,Os=class{static{o(this,"ImageUtils")}static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Ti===void 0&&(Ti=mr("canvas")),Ti.width=e.width,Ti.height=e.height;let r=Ti.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=Ti}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=mr("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),s=r.data;for(let a=0;a<s.length;a++)s[a]=Un(s[a]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Un(t[n]/255)*255):t[n]=Un(t[n]);return{data:t,width:e.width,height:e.height}}else return Pe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},mf=0,Hi=class{static{o(this,"TextureSource")}constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:mf++}),this.uuid=Or(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let a=0,c=r.length;a<c;a++)r[a].isDataTexture?s.push(bo(r[a].image)):s.push(bo(r[a]))}else s=bo(r);n.url=s}return t||(e.images[this.uuid]=n),n}};function bo(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Os.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Pe("Texture: Unable to serialize Texture."),{})}o(bo,"serializeImage");var gf=0,_o=new G,Rt=class i extends Sn{static{o(this,"Texture")}constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=vn,r=vn,s=Nt,a=Bn,c=gn,l=Xt,h=i.DEFAULT_ANISOTROPY,u=zn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:gf++}),this.uuid=Or(),this.name="",this.source=new Hi(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=a,this.anisotropy=h,this.format=c,this.internalFormat=null,this.type=l,this.offset=new Xe(0,0),this.repeat=new Xe(1,1),this.center=new Xe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Le,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(_o).x}get height(){return this.source.getSize(_o).y}get depth(){return this.source.getSize(_o).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Pe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Pe(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Zo)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ds:e.x=e.x-Math.floor(e.x);break;case vn:e.x=e.x<0?0:1;break;case Ns:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ds:e.y=e.y-Math.floor(e.y);break;case vn:e.y=e.y<0?0:1;break;case Ns:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Rt.DEFAULT_IMAGE=null;Rt.DEFAULT_MAPPING=Zo;Rt.DEFAULT_ANISOTROPY=1;var et=class{static{o(this,"Vector4")}static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*r+a[12]*s,this.y=a[1]*t+a[5]*n+a[9]*r+a[13]*s,this.z=a[2]*t+a[6]*n+a[10]*r+a[14]*s,this.w=a[3]*t+a[7]*n+a[11]*r+a[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,s,l=e.elements,h=l[0],u=l[4],p=l[8],d=l[1],f=l[5],g=l[9],y=l[2],m=l[6],b=l[10];if(Math.abs(u-d)<.01&&Math.abs(p-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(p+y)<.1&&Math.abs(g+m)<.1&&Math.abs(h+f+b-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(h+1)/2,x=(f+1)/2,S=(b+1)/2,E=(u+d)/4,_=(p+y)/4,A=(g+m)/4;return T>x&&T>S?T<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(T),r=E/n,s=_/n):x>S?x<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(x),n=E/r,s=A/r):S<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(S),n=_/s,r=A/s),this.set(n,r,s,t),this}let w=Math.sqrt((m-g)*(m-g)+(p-y)*(p-y)+(d-u)*(d-u));return Math.abs(w)<.001&&(w=1),this.x=(m-g)/w,this.y=(p-y)/w,this.z=(d-u)/w,this.w=Math.acos((h+f+b-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=He(this.x,e.x,t.x),this.y=He(this.y,e.y,t.y),this.z=He(this.z,e.z,t.z),this.w=He(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=He(this.x,e,t),this.y=He(this.y,e,t),this.z=He(this.z,e,t),this.w=He(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(He(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Bs=class extends Sn{static{o(this,"RenderTarget")}constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Nt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new et(0,0,e,t),this.scissorTest=!1,this.viewport=new et(0,0,e,t),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new Rt({width:e,height:t,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Nt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Hi(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ct=class extends Bs{static{o(this,"WebGLRenderTarget")}constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},br=class extends Rt{static{o(this,"DataArrayTexture")}constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=yt,this.minFilter=yt,this.wrapR=vn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ks=class extends Rt{static{o(this,"Data3DTexture")}constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=yt,this.minFilter=yt,this.wrapR=vn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var at=class i{static{o(this,"Matrix4")}static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,s,a,c,l,h,u,p,d,f,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,a,c,l,h,u,p,d,f,g,y,m)}set(e,t,n,r,s,a,c,l,h,u,p,d,f,g,y,m){let b=this.elements;return b[0]=e,b[4]=t,b[8]=n,b[12]=r,b[1]=s,b[5]=a,b[9]=c,b[13]=l,b[2]=h,b[6]=u,b[10]=p,b[14]=d,b[3]=f,b[7]=g,b[11]=y,b[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/Ri.setFromMatrixColumn(e,0).length(),s=1/Ri.setFromMatrixColumn(e,1).length(),a=1/Ri.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*s,t[5]=n[5]*s,t[6]=n[6]*s,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,s=e.z,a=Math.cos(n),c=Math.sin(n),l=Math.cos(r),h=Math.sin(r),u=Math.cos(s),p=Math.sin(s);if(e.order==="XYZ"){let d=a*u,f=a*p,g=c*u,y=c*p;t[0]=l*u,t[4]=-l*p,t[8]=h,t[1]=f+g*h,t[5]=d-y*h,t[9]=-c*l,t[2]=y-d*h,t[6]=g+f*h,t[10]=a*l}else if(e.order==="YXZ"){let d=l*u,f=l*p,g=h*u,y=h*p;t[0]=d+y*c,t[4]=g*c-f,t[8]=a*h,t[1]=a*p,t[5]=a*u,t[9]=-c,t[2]=f*c-g,t[6]=y+d*c,t[10]=a*l}else if(e.order==="ZXY"){let d=l*u,f=l*p,g=h*u,y=h*p;t[0]=d-y*c,t[4]=-a*p,t[8]=g+f*c,t[1]=f+g*c,t[5]=a*u,t[9]=y-d*c,t[2]=-a*h,t[6]=c,t[10]=a*l}else if(e.order==="ZYX"){let d=a*u,f=a*p,g=c*u,y=c*p;t[0]=l*u,t[4]=g*h-f,t[8]=d*h+y,t[1]=l*p,t[5]=y*h+d,t[9]=f*h-g,t[2]=-h,t[6]=c*l,t[10]=a*l}else if(e.order==="YZX"){let d=a*l,f=a*h,g=c*l,y=c*h;t[0]=l*u,t[4]=y-d*p,t[8]=g*p+f,t[1]=p,t[5]=a*u,t[9]=-c*u,t[2]=-h*u,t[6]=f*p+g,t[10]=d-y*p}else if(e.order==="XZY"){let d=a*l,f=a*h,g=c*l,y=c*h;t[0]=l*u,t[4]=-p,t[8]=h*u,t[1]=d*p+y,t[5]=a*u,t[9]=f*p-g,t[2]=g*p-f,t[6]=c*u,t[10]=y*p+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(bf,e,_f)}lookAt(e,t,n){let r=this.elements;return zt.subVectors(e,t),zt.lengthSq()===0&&(zt.z=1),zt.normalize(),Xn.crossVectors(n,zt),Xn.lengthSq()===0&&(Math.abs(n.z)===1?zt.x+=1e-4:zt.z+=1e-4,zt.normalize(),Xn.crossVectors(n,zt)),Xn.normalize(),rs.crossVectors(zt,Xn),r[0]=Xn.x,r[4]=rs.x,r[8]=zt.x,r[1]=Xn.y,r[5]=rs.y,r[9]=zt.y,r[2]=Xn.z,r[6]=rs.z,r[10]=zt.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,a=n[0],c=n[4],l=n[8],h=n[12],u=n[1],p=n[5],d=n[9],f=n[13],g=n[2],y=n[6],m=n[10],b=n[14],w=n[3],T=n[7],x=n[11],S=n[15],E=r[0],_=r[4],A=r[8],U=r[12],I=r[1],D=r[5],F=r[9],V=r[13],C=r[2],q=r[6],Y=r[10],W=r[14],ne=r[3],X=r[7],Q=r[11],ee=r[15];return s[0]=a*E+c*I+l*C+h*ne,s[4]=a*_+c*D+l*q+h*X,s[8]=a*A+c*F+l*Y+h*Q,s[12]=a*U+c*V+l*W+h*ee,s[1]=u*E+p*I+d*C+f*ne,s[5]=u*_+p*D+d*q+f*X,s[9]=u*A+p*F+d*Y+f*Q,s[13]=u*U+p*V+d*W+f*ee,s[2]=g*E+y*I+m*C+b*ne,s[6]=g*_+y*D+m*q+b*X,s[10]=g*A+y*F+m*Y+b*Q,s[14]=g*U+y*V+m*W+b*ee,s[3]=w*E+T*I+x*C+S*ne,s[7]=w*_+T*D+x*q+S*X,s[11]=w*A+T*F+x*Y+S*Q,s[15]=w*U+T*V+x*W+S*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[12],a=e[1],c=e[5],l=e[9],h=e[13],u=e[2],p=e[6],d=e[10],f=e[14],g=e[3],y=e[7],m=e[11],b=e[15],w=l*f-h*d,T=c*f-h*p,x=c*d-l*p,S=a*f-h*u,E=a*d-l*u,_=a*p-c*u;return t*(y*w-m*T+b*x)-n*(g*w-m*S+b*E)+r*(g*T-y*S+b*_)-s*(g*x-y*E+m*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10];return t*(a*u-c*h)-n*(s*u-c*l)+r*(s*h-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],a=e[4],c=e[5],l=e[6],h=e[7],u=e[8],p=e[9],d=e[10],f=e[11],g=e[12],y=e[13],m=e[14],b=e[15],w=t*c-n*a,T=t*l-r*a,x=t*h-s*a,S=n*l-r*c,E=n*h-s*c,_=r*h-s*l,A=u*y-p*g,U=u*m-d*g,I=u*b-f*g,D=p*m-d*y,F=p*b-f*y,V=d*b-f*m,C=w*V-T*F+x*D+S*I-E*U+_*A;if(C===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let q=1/C;return e[0]=(c*V-l*F+h*D)*q,e[1]=(r*F-n*V-s*D)*q,e[2]=(y*_-m*E+b*S)*q,e[3]=(d*E-p*_-f*S)*q,e[4]=(l*I-a*V-h*U)*q,e[5]=(t*V-r*I+s*U)*q,e[6]=(m*x-g*_-b*T)*q,e[7]=(u*_-d*x+f*T)*q,e[8]=(a*F-c*I+h*A)*q,e[9]=(n*I-t*F-s*A)*q,e[10]=(g*E-y*x+b*w)*q,e[11]=(p*x-u*E-f*w)*q,e[12]=(c*U-a*D-l*A)*q,e[13]=(t*D-n*U+r*A)*q,e[14]=(y*T-g*S-m*w)*q,e[15]=(u*S-p*T+d*w)*q,this}scale(e){let t=this.elements,n=e.x,r=e.y,s=e.z;return t[0]*=n,t[4]*=r,t[8]*=s,t[1]*=n,t[5]*=r,t[9]*=s,t[2]*=n,t[6]*=r,t[10]*=s,t[3]*=n,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),s=1-n,a=e.x,c=e.y,l=e.z,h=s*a,u=s*c;return this.set(h*a+n,h*c-r*l,h*l+r*c,0,h*c+r*l,u*c+n,u*l-r*a,0,h*l-r*c,u*l+r*a,s*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,s,a){return this.set(1,n,s,0,e,1,a,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,s=t._x,a=t._y,c=t._z,l=t._w,h=s+s,u=a+a,p=c+c,d=s*h,f=s*u,g=s*p,y=a*u,m=a*p,b=c*p,w=l*h,T=l*u,x=l*p,S=n.x,E=n.y,_=n.z;return r[0]=(1-(y+b))*S,r[1]=(f+x)*S,r[2]=(g-T)*S,r[3]=0,r[4]=(f-x)*E,r[5]=(1-(d+b))*E,r[6]=(m+w)*E,r[7]=0,r[8]=(g+T)*_,r[9]=(m-w)*_,r[10]=(1-(d+y))*_,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),t.identity(),this;let a=Ri.set(r[0],r[1],r[2]).length(),c=Ri.set(r[4],r[5],r[6]).length(),l=Ri.set(r[8],r[9],r[10]).length();s<0&&(a=-a),on.copy(this);let h=1/a,u=1/c,p=1/l;return on.elements[0]*=h,on.elements[1]*=h,on.elements[2]*=h,on.elements[4]*=u,on.elements[5]*=u,on.elements[6]*=u,on.elements[8]*=p,on.elements[9]*=p,on.elements[10]*=p,t.setFromRotationMatrix(on),n.x=a,n.y=c,n.z=l,this}makePerspective(e,t,n,r,s,a,c=en,l=!1){let h=this.elements,u=2*s/(t-e),p=2*s/(n-r),d=(t+e)/(t-e),f=(n+r)/(n-r),g,y;if(l)g=s/(a-s),y=a*s/(a-s);else if(c===en)g=-(a+s)/(a-s),y=-2*a*s/(a-s);else if(c===pr)g=-a/(a-s),y=-a*s/(a-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+c);return h[0]=u,h[4]=0,h[8]=d,h[12]=0,h[1]=0,h[5]=p,h[9]=f,h[13]=0,h[2]=0,h[6]=0,h[10]=g,h[14]=y,h[3]=0,h[7]=0,h[11]=-1,h[15]=0,this}makeOrthographic(e,t,n,r,s,a,c=en,l=!1){let h=this.elements,u=2/(t-e),p=2/(n-r),d=-(t+e)/(t-e),f=-(n+r)/(n-r),g,y;if(l)g=1/(a-s),y=a/(a-s);else if(c===en)g=-2/(a-s),y=-(a+s)/(a-s);else if(c===pr)g=-1/(a-s),y=-s/(a-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+c);return h[0]=u,h[4]=0,h[8]=0,h[12]=d,h[1]=0,h[5]=p,h[9]=0,h[13]=f,h[2]=0,h[6]=0,h[10]=g,h[14]=y,h[3]=0,h[7]=0,h[11]=0,h[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Ri=new G,on=new at,bf=new G(0,0,0),_f=new G(1,1,1),Xn=new G,rs=new G,zt=new G,Tl=new at,Rl=new Mn,Zn=class i{static{o(this,"Euler")}constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,s=r[0],a=r[4],c=r[8],l=r[1],h=r[5],u=r[9],p=r[2],d=r[6],f=r[10];switch(t){case"XYZ":this._y=Math.asin(He(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-a,s)):(this._x=Math.atan2(d,h),this._z=0);break;case"YXZ":this._x=Math.asin(-He(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(c,f),this._z=Math.atan2(l,h)):(this._y=Math.atan2(-p,s),this._z=0);break;case"ZXY":this._x=Math.asin(He(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-p,f),this._z=Math.atan2(-a,h)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-He(p,-1,1)),Math.abs(p)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-a,h));break;case"YZX":this._z=Math.asin(He(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,h),this._y=Math.atan2(-p,s)):(this._x=0,this._y=Math.atan2(c,f));break;case"XZY":this._z=Math.asin(-He(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(d,h),this._y=Math.atan2(c,s)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Pe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Tl.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Tl,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Rl.setFromEuler(this),this.setFromQuaternion(Rl,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Zn.DEFAULT_ORDER="XYZ";var _r=class{static{o(this,"Layers")}constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},xf=0,Cl=new G,Ci=new Mn,Pn=new at,ss=new G,ar=new G,yf=new G,vf=new Mn,Pl=new G(1,0,0),Il=new G(0,1,0),Ll=new G(0,0,1),Dl={type:"added"},Sf={type:"removed"},Pi={type:"childadded",child:null},xo={type:"childremoved",child:null},nn=class i extends Sn{static{o(this,"Object3D")}constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:xf++}),this.uuid=Or(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new G,t=new Zn,n=new Mn,r=new G(1,1,1);function s(){n.setFromEuler(t,!1)}o(s,"onRotationChange");function a(){t.setFromQuaternion(n,void 0,!1)}o(a,"onQuaternionChange"),t._onChange(s),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new at},normalMatrix:{value:new Le}}),this.matrix=new at,this.matrixWorld=new at,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new _r,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ci.setFromAxisAngle(e,t),this.quaternion.multiply(Ci),this}rotateOnWorldAxis(e,t){return Ci.setFromAxisAngle(e,t),this.quaternion.premultiply(Ci),this}rotateX(e){return this.rotateOnAxis(Pl,e)}rotateY(e){return this.rotateOnAxis(Il,e)}rotateZ(e){return this.rotateOnAxis(Ll,e)}translateOnAxis(e,t){return Cl.copy(e).applyQuaternion(this.quaternion),this.position.add(Cl.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Pl,e)}translateY(e){return this.translateOnAxis(Il,e)}translateZ(e){return this.translateOnAxis(Ll,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Pn.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?ss.copy(e):ss.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),ar.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Pn.lookAt(ar,ss,this.up):Pn.lookAt(ss,ar,this.up),this.quaternion.setFromRotationMatrix(Pn),r&&(Pn.extractRotation(r.matrixWorld),Ci.setFromRotationMatrix(Pn),this.quaternion.premultiply(Ci.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ie("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Dl),Pi.child=e,this.dispatchEvent(Pi),Pi.child=null):Ie("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Sf),xo.child=e,this.dispatchEvent(xo),xo.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Pn.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Pn.multiply(e.parent.matrixWorld)),e.applyMatrix4(Pn),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Dl),Pi.child=e,this.dispatchEvent(Pi),Pi.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let s=0,a=r.length;s<a;s++)r[s].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ar,e,yf),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ar,vf,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*n-s[8]*r,s[13]+=n-s[1]*t-s[5]*n-s[9]*r,s[14]+=r-s[2]*t-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let s=this.children;for(let a=0,c=s.length;a<c;a++)s[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(c=>({...c,boundingBox:c.boundingBox?c.boundingBox.toJSON():void 0,boundingSphere:c.boundingSphere?c.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(c=>({...c})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(c,l){return c[l.uuid]===void 0&&(c[l.uuid]=l.toJSON(e)),l.uuid}if(o(s,"serialize"),this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let c=this.geometry.parameters;if(c!==void 0&&c.shapes!==void 0){let l=c.shapes;if(Array.isArray(l))for(let h=0,u=l.length;h<u;h++){let p=l[h];s(e.shapes,p)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let c=[];for(let l=0,h=this.material.length;l<h;l++)c.push(s(e.materials,this.material[l]));r.material=c}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let c=0;c<this.children.length;c++)r.children.push(this.children[c].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let c=0;c<this.animations.length;c++){let l=this.animations[c];r.animations.push(s(e.animations,l))}}if(t){let c=a(e.geometries),l=a(e.materials),h=a(e.textures),u=a(e.images),p=a(e.shapes),d=a(e.skeletons),f=a(e.animations),g=a(e.nodes);c.length>0&&(n.geometries=c),l.length>0&&(n.materials=l),h.length>0&&(n.textures=h),u.length>0&&(n.images=u),p.length>0&&(n.shapes=p),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=r,n;function a(c){let l=[];for(let h in c){let u=c[h];delete u.metadata,l.push(u)}return l}o(a,"extractFromCache")}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};nn.DEFAULT_UP=new G(0,1,0);nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var un=class extends nn{static{o(this,"Group")}constructor(){super(),this.isGroup=!0,this.type="Group"}},Mf={type:"move"},Wi=class{static{o(this,"WebXRController")}constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new un,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new un,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new un,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,s=null,a=null,c=this._targetRay,l=this._grip,h=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(h&&e.hand){a=!0;for(let y of e.hand.values()){let m=t.getJointPose(y,n),b=this._getHandJoint(h,y);m!==null&&(b.matrix.fromArray(m.transform.matrix),b.matrix.decompose(b.position,b.quaternion,b.scale),b.matrixWorldNeedsUpdate=!0,b.jointRadius=m.radius),b.visible=m!==null}let u=h.joints["index-finger-tip"],p=h.joints["thumb-tip"],d=u.position.distanceTo(p.position),f=.02,g=.005;h.inputState.pinching&&d>f+g?(h.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!h.inputState.pinching&&d<=f-g&&(h.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));c!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,this.dispatchEvent(Mf)))}return c!==null&&(c.visible=r!==null),l!==null&&(l.visible=s!==null),h!==null&&(h.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new un;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Rh={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Kn={h:0,s:0,l:0},as={h:0,s:0,l:0};function yo(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}o(yo,"hue2rgb");var qe=class{static{o(this,"Color")}constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Vt){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Ve.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=Ve.workingColorSpace){return this.r=e,this.g=t,this.b=n,Ve.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=Ve.workingColorSpace){if(e=ff(e,1),t=He(t,0,1),n=He(n,0,1),t===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+t):n+t-n*t,a=2*n-s;this.r=yo(a,s,e+1/3),this.g=yo(a,s,e),this.b=yo(a,s,e-1/3)}return Ve.colorSpaceToWorking(this,r),this}setStyle(e,t=Vt){function n(s){s!==void 0&&parseFloat(s)<1&&Pe("Color: Alpha component of "+e+" will be ignored.")}o(n,"handleAlpha");let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,a=r[1],c=r[2];switch(a){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(c))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(c))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(c))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Pe("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],a=s.length;if(a===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(s,16),t);Pe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Vt){let n=Rh[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Pe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Un(e.r),this.g=Un(e.g),this.b=Un(e.b),this}copyLinearToSRGB(e){return this.r=zi(e.r),this.g=zi(e.g),this.b=zi(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Vt){return Ve.workingToColorSpace(Tt.copy(this),e),Math.round(He(Tt.r*255,0,255))*65536+Math.round(He(Tt.g*255,0,255))*256+Math.round(He(Tt.b*255,0,255))}getHexString(e=Vt){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Ve.workingColorSpace){Ve.workingToColorSpace(Tt.copy(this),t);let n=Tt.r,r=Tt.g,s=Tt.b,a=Math.max(n,r,s),c=Math.min(n,r,s),l,h,u=(c+a)/2;if(c===a)l=0,h=0;else{let p=a-c;switch(h=u<=.5?p/(a+c):p/(2-a-c),a){case n:l=(r-s)/p+(r<s?6:0);break;case r:l=(s-n)/p+2;break;case s:l=(n-r)/p+4;break}l/=6}return e.h=l,e.s=h,e.l=u,e}getRGB(e,t=Ve.workingColorSpace){return Ve.workingToColorSpace(Tt.copy(this),t),e.r=Tt.r,e.g=Tt.g,e.b=Tt.b,e}getStyle(e=Vt){Ve.workingToColorSpace(Tt.copy(this),e);let t=Tt.r,n=Tt.g,r=Tt.b;return e!==Vt?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(Kn),this.setHSL(Kn.h+e,Kn.s+t,Kn.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Kn),e.getHSL(as);let n=po(Kn.h,as.h,t),r=po(Kn.s,as.s,t),s=po(Kn.l,as.l,t);return this.setHSL(n,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*n+s[6]*r,this.g=s[1]*t+s[4]*n+s[7]*r,this.b=s[2]*t+s[5]*n+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Tt=new qe;qe.NAMES=Rh;var Wt=class extends nn{static{o(this,"Scene")}constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Zn,this.environmentIntensity=1,this.environmentRotation=new Zn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},cn=new G,In=new G,vo=new G,Ln=new G,Ii=new G,Li=new G,Nl=new G,So=new G,Mo=new G,wo=new G,Eo=new et,Ao=new et,To=new et,$n=class i{static{o(this,"Triangle")}constructor(e=new G,t=new G,n=new G){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),cn.subVectors(e,t),r.cross(cn);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,n,r,s){cn.subVectors(r,t),In.subVectors(n,t),vo.subVectors(e,t);let a=cn.dot(cn),c=cn.dot(In),l=cn.dot(vo),h=In.dot(In),u=In.dot(vo),p=a*h-c*c;if(p===0)return s.set(0,0,0),null;let d=1/p,f=(h*l-c*u)*d,g=(a*u-c*l)*d;return s.set(1-f-g,g,f)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,Ln)===null?!1:Ln.x>=0&&Ln.y>=0&&Ln.x+Ln.y<=1}static getInterpolation(e,t,n,r,s,a,c,l){return this.getBarycoord(e,t,n,r,Ln)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Ln.x),l.addScaledVector(a,Ln.y),l.addScaledVector(c,Ln.z),l)}static getInterpolatedAttribute(e,t,n,r,s,a){return Eo.setScalar(0),Ao.setScalar(0),To.setScalar(0),Eo.fromBufferAttribute(e,t),Ao.fromBufferAttribute(e,n),To.fromBufferAttribute(e,r),a.setScalar(0),a.addScaledVector(Eo,s.x),a.addScaledVector(Ao,s.y),a.addScaledVector(To,s.z),a}static isFrontFacing(e,t,n,r){return cn.subVectors(n,t),In.subVectors(e,t),cn.cross(In).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return cn.subVectors(this.c,this.b),In.subVectors(this.a,this.b),cn.cross(In).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,s){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,s)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,s=this.c,a,c;Ii.subVectors(r,n),Li.subVectors(s,n),So.subVectors(e,n);let l=Ii.dot(So),h=Li.dot(So);if(l<=0&&h<=0)return t.copy(n);Mo.subVectors(e,r);let u=Ii.dot(Mo),p=Li.dot(Mo);if(u>=0&&p<=u)return t.copy(r);let d=l*p-u*h;if(d<=0&&l>=0&&u<=0&&l-u>0)return a=l/(l-u),t.copy(n).addScaledVector(Ii,a);wo.subVectors(e,s);let f=Ii.dot(wo),g=Li.dot(wo);if(g>=0&&f<=g)return t.copy(s);let y=f*h-l*g;if(y<=0&&h>=0&&g<=0)return c=h/(h-g),t.copy(n).addScaledVector(Li,c);let m=u*g-f*p;if(m<=0&&p-u>=0&&f-g>=0)return Nl.subVectors(s,r),c=(p-u)/(p-u+(f-g)),t.copy(r).addScaledVector(Nl,c);let b=1/(m+y+d);return a=y*b,c=d*b,t.copy(n).addScaledVector(Ii,a).addScaledVector(Li,c)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Qn=class{static{o(this,"Box3")}constructor(e=new G(1/0,1/0,1/0),t=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ln.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ln.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ln.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let s=n.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,c=s.count;a<c;a++)e.isMesh===!0?e.getVertexPosition(a,ln):ln.fromBufferAttribute(s,a),ln.applyMatrix4(e.matrixWorld),this.expandByPoint(ln);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),os.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),os.copy(n.boundingBox)),os.applyMatrix4(e.matrixWorld),this.union(os)}let r=e.children;for(let s=0,a=r.length;s<a;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ln),ln.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(or),cs.subVectors(this.max,or),Di.subVectors(e.a,or),Ni.subVectors(e.b,or),Ui.subVectors(e.c,or),jn.subVectors(Ni,Di),Yn.subVectors(Ui,Ni),ui.subVectors(Di,Ui);let t=[0,-jn.z,jn.y,0,-Yn.z,Yn.y,0,-ui.z,ui.y,jn.z,0,-jn.x,Yn.z,0,-Yn.x,ui.z,0,-ui.x,-jn.y,jn.x,0,-Yn.y,Yn.x,0,-ui.y,ui.x,0];return!Ro(t,Di,Ni,Ui,cs)||(t=[1,0,0,0,1,0,0,0,1],!Ro(t,Di,Ni,Ui,cs))?!1:(ls.crossVectors(jn,Yn),t=[ls.x,ls.y,ls.z],Ro(t,Di,Ni,Ui,cs))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ln).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ln).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Dn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Dn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Dn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Dn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Dn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Dn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Dn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Dn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Dn),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Dn=[new G,new G,new G,new G,new G,new G,new G,new G],ln=new G,os=new Qn,Di=new G,Ni=new G,Ui=new G,jn=new G,Yn=new G,ui=new G,or=new G,cs=new G,ls=new G,di=new G;function Ro(i,e,t,n,r){for(let s=0,a=i.length-3;s<=a;s+=3){di.fromArray(i,s);let c=r.x*Math.abs(di.x)+r.y*Math.abs(di.y)+r.z*Math.abs(di.z),l=e.dot(di),h=t.dot(di),u=n.dot(di);if(Math.max(-Math.max(l,h,u),Math.min(l,h,u))>c)return!1}return!0}o(Ro,"satForAxes");var ht=new G,hs=new Xe,wf=0,Ht=class extends Sn{static{o(this,"BufferAttribute")}constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:wf++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=yh,this.updateRanges=[],this.gpuType=pn,this.version=0,this._normalizationScale=e!==void 0?Ha(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)hs.fromBufferAttribute(this,t),hs.applyMatrix3(e),this.setXY(t,hs.x,hs.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.applyMatrix3(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.applyMatrix4(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.applyNormalMatrix(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ht.fromBufferAttribute(this,t),ht.transformDirection(e),this.setXYZ(t,ht.x,ht.y,ht.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ah(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Th(e,this.array)}};var xr=class extends Ht{static{o(this,"Uint16BufferAttribute")}constructor(e,t,n){super(new Uint16Array(e),t,n)}};var yr=class extends Ht{static{o(this,"Uint32BufferAttribute")}constructor(e,t,n){super(new Uint32Array(e),t,n)}};var tn=class extends Ht{static{o(this,"Float32BufferAttribute")}constructor(e,t,n){super(new Float32Array(e),t,n)}},Ef=new Qn,cr=new G,Co=new G,qi=class{static{o(this,"Sphere")}constructor(e=new G,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Ef.setFromPoints(e).getCenter(n);let r=0;for(let s=0,a=e.length;s<a;s++)r=Math.max(r,n.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;cr.subVectors(e,this.center);let t=cr.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector(cr,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Co.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(cr.copy(e.center).add(Co)),this.expandByPoint(cr.copy(e.center).sub(Co))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Af=0,Qt=new at,Po=new nn,Fi=new G,Gt=new Qn,lr=new Qn,xt=new G,Ut=class i extends Sn{static{o(this,"BufferGeometry")}constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Af++}),this.uuid=Or(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(uf(e)?yr:xr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new Le().getNormalMatrix(e);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Qt.makeRotationFromQuaternion(e),this.applyMatrix4(Qt),this}rotateX(e){return Qt.makeRotationX(e),this.applyMatrix4(Qt),this}rotateY(e){return Qt.makeRotationY(e),this.applyMatrix4(Qt),this}rotateZ(e){return Qt.makeRotationZ(e),this.applyMatrix4(Qt),this}translate(e,t,n){return Qt.makeTranslation(e,t,n),this.applyMatrix4(Qt),this}scale(e,t,n){return Qt.makeScale(e,t,n),this.applyMatrix4(Qt),this}lookAt(e){return Po.lookAt(e),Po.updateMatrix(),this.applyMatrix4(Po.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Fi).negate(),this.translate(Fi.x,Fi.y,Fi.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,s=e.length;r<s;r++){let a=e[r];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new tn(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Pe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ie("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let s=t[n];Gt.setFromBufferAttribute(s),this.morphTargetsRelative?(xt.addVectors(this.boundingBox.min,Gt.min),this.boundingBox.expandByPoint(xt),xt.addVectors(this.boundingBox.max,Gt.max),this.boundingBox.expandByPoint(xt)):(this.boundingBox.expandByPoint(Gt.min),this.boundingBox.expandByPoint(Gt.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ie('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new qi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ie("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(e){let n=this.boundingSphere.center;if(Gt.setFromBufferAttribute(e),t)for(let s=0,a=t.length;s<a;s++){let c=t[s];lr.setFromBufferAttribute(c),this.morphTargetsRelative?(xt.addVectors(Gt.min,lr.min),Gt.expandByPoint(xt),xt.addVectors(Gt.max,lr.max),Gt.expandByPoint(xt)):(Gt.expandByPoint(lr.min),Gt.expandByPoint(lr.max))}Gt.getCenter(n);let r=0;for(let s=0,a=e.count;s<a;s++)xt.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(xt));if(t)for(let s=0,a=t.length;s<a;s++){let c=t[s],l=this.morphTargetsRelative;for(let h=0,u=c.count;h<u;h++)xt.fromBufferAttribute(c,h),l&&(Fi.fromBufferAttribute(e,h),xt.add(Fi)),r=Math.max(r,n.distanceToSquared(xt))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&Ie('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ie("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,s=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new Ht(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let c=[],l=[],h=new Uint8Array(n.count);for(let U=0;U<n.count;U++)c[U]=new G,l[U]=new G;let u=new G,p=new G,d=new G,f=new Xe,g=new Xe,y=new Xe,m=new G,b=new G;function w(U,I,D){h[U]=h[I]=h[D]=1,u.fromBufferAttribute(n,U),p.fromBufferAttribute(n,I),d.fromBufferAttribute(n,D),f.fromBufferAttribute(s,U),g.fromBufferAttribute(s,I),y.fromBufferAttribute(s,D),p.sub(u),d.sub(u),g.sub(f),y.sub(f);let F=1/(g.x*y.y-y.x*g.y);isFinite(F)&&(m.copy(p).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(F),b.copy(d).multiplyScalar(g.x).addScaledVector(p,-y.x).multiplyScalar(F),c[U].add(m),c[I].add(m),c[D].add(m),l[U].add(b),l[I].add(b),l[D].add(b))}o(w,"handleTriangle");let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let U=0,I=T.length;U<I;++U){let D=T[U],F=D.start,V=D.count;for(let C=F,q=F+V;C<q;C+=3)w(e.getX(C+0),e.getX(C+1),e.getX(C+2))}let x=new G,S=new G,E=new G,_=new G;function A(U){E.fromBufferAttribute(r,U),_.copy(E);let I=c[U];x.copy(I),x.sub(E.multiplyScalar(E.dot(I))).normalize(),S.crossVectors(_,I);let F=S.dot(l[U])<0?-1:1;a.setXYZW(U,x.x,x.y,x.z,F)}o(A,"handleVertex");for(let U=0,I=n.count;U<I;++U)h[U]&&A(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Ht(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let r=new G,s=new G,a=new G,c=new G,l=new G,h=new G,u=new G,p=new G;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),y=e.getX(d+1),m=e.getX(d+2);r.fromBufferAttribute(t,g),s.fromBufferAttribute(t,y),a.fromBufferAttribute(t,m),u.subVectors(a,s),p.subVectors(r,s),u.cross(p),c.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),h.fromBufferAttribute(n,m),c.add(u),l.add(u),h.add(u),n.setXYZ(g,c.x,c.y,c.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,h.x,h.y,h.z)}else for(let d=0,f=t.count;d<f;d+=3)r.fromBufferAttribute(t,d+0),s.fromBufferAttribute(t,d+1),a.fromBufferAttribute(t,d+2),u.subVectors(a,s),p.subVectors(r,s),u.cross(p),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)xt.fromBufferAttribute(e,t),xt.normalize(),e.setXYZ(t,xt.x,xt.y,xt.z)}toNonIndexed(){function e(c,l){let h=c.array,u=c.itemSize,p=c.normalized,d=new h.constructor(l.length*u),f=0,g=0;for(let y=0,m=l.length;y<m;y++){c.isInterleavedBufferAttribute?f=l[y]*c.data.stride+c.offset:f=l[y]*u;for(let b=0;b<u;b++)d[g++]=h[f++]}return new Ht(d,u,p)}if(o(e,"convertBufferAttribute"),this.index===null)return Pe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let c in r){let l=r[c],h=e(l,n);t.setAttribute(c,h)}let s=this.morphAttributes;for(let c in s){let l=[],h=s[c];for(let u=0,p=h.length;u<p;u++){let d=h[u],f=e(d,n);l.push(f)}t.morphAttributes[c]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let c=0,l=a.length;c<l;c++){let h=a[c];t.addGroup(h.start,h.count,h.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let h in l)l[h]!==void 0&&(e[h]=l[h]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let h=n[l];e.data.attributes[l]=h.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let h=this.morphAttributes[l],u=[];for(let p=0,d=h.length;p<d;p++){let f=h[p];u.push(f.toJSON(e.data))}u.length>0&&(r[l]=u,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let c=this.boundingSphere;return c!==null&&(e.data.boundingSphere=c.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let h in r){let u=r[h];this.setAttribute(h,u.clone(t))}let s=e.morphAttributes;for(let h in s){let u=[],p=s[h];for(let d=0,f=p.length;d<f;d++)u.push(p[d].clone(t));this.morphAttributes[h]=u}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let h=0,u=a.length;h<u;h++){let p=a[h];this.addGroup(p.start,p.count,p.materialIndex)}let c=e.boundingBox;c!==null&&(this.boundingBox=c.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Dt=new G,vr=class i{static{o(this,"InterleavedBufferAttribute")}constructor(e,t,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=r,this._normalizationScale=e!==void 0?Ha(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Dt.fromBufferAttribute(this,t),Dt.applyMatrix4(e),this.setXYZ(t,Dt.x,Dt.y,Dt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Dt.fromBufferAttribute(this,t),Dt.applyNormalMatrix(e),this.setXYZ(t,Dt.x,Dt.y,Dt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Dt.fromBufferAttribute(this,t),Dt.transformDirection(e),this.setXYZ(t,Dt.x,Dt.y,Dt.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){gr("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new Ht(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){gr("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Ah(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Th(e,this.data.array)}},Io=new G,Tf=new G,Rf=new Le,hn=class{static{o(this,"Plane")}constructor(e=new G(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=Io.subVectors(n,t).cross(Tf.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(Io),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/s;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(r,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Rf.getNormalMatrix(e),r=this.coplanarPoint(Io).applyMatrix4(e),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Cf=0,mi=class extends Sn{static{o(this,"Material")}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Cf++}),this.uuid=Or(),this.name="",this.type="Material",this.blending=Yi,this.side=ii,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Cr,this.blendDst=ri,this.blendEquation=xi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new qe(0,0,0),this.blendAlpha=0,this.depthFunc=Gi,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ph,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Es,this.stencilZFail=Es,this.stencilZPass=Es,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Pe(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Pe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let a=[];for(let c in s){let l=s[c];delete l.metadata,a.push(l)}return a}if(o(r,"extractFromCache"),t){let s=r(e.textures),a=r(e.images);s.length>0&&(n.textures=s),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new qe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new hn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Xe().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Xe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=t[s].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Nn=new G,Lo=new G,us=new G,ds=new G,zs=class{static{o(this,"Ray")}constructor(e=new G,t=new G(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Nn)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Nn.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Nn.copy(this.origin).addScaledVector(this.direction,t),Nn.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){Lo.copy(e).add(t).multiplyScalar(.5),us.copy(t).sub(e).normalize(),ds.copy(this.origin).sub(Lo);let s=e.distanceTo(t)*.5,a=-this.direction.dot(us),c=ds.dot(this.direction),l=-ds.dot(us),h=ds.lengthSq(),u=Math.abs(1-a*a),p,d,f,g;if(u>0)if(p=a*l-c,d=a*c-l,g=s*u,p>=0)if(d>=-g)if(d<=g){let y=1/u;p*=y,d*=y,f=p*(p+a*d+2*c)+d*(a*p+d+2*l)+h}else d=s,p=Math.max(0,-(a*d+c)),f=-p*p+d*(d+2*l)+h;else d=-s,p=Math.max(0,-(a*d+c)),f=-p*p+d*(d+2*l)+h;else d<=-g?(p=Math.max(0,-(-a*s+c)),d=p>0?-s:Math.min(Math.max(-s,-l),s),f=-p*p+d*(d+2*l)+h):d<=g?(p=0,d=Math.min(Math.max(-s,-l),s),f=d*(d+2*l)+h):(p=Math.max(0,-(a*s+c)),d=p>0?s:Math.min(Math.max(-s,-l),s),f=-p*p+d*(d+2*l)+h);else d=a>0?-s:s,p=Math.max(0,-(a*d+c)),f=-p*p+d*(d+2*l)+h;return n&&n.copy(this.origin).addScaledVector(this.direction,p),r&&r.copy(Lo).addScaledVector(us,d),f}intersectSphere(e,t){if(e.radius<0)return null;Nn.subVectors(e.center,this.origin);let n=Nn.dot(this.direction),r=Nn.dot(Nn)-n*n,s=e.radius*e.radius;if(r>s)return null;let a=Math.sqrt(s-r),c=n-a,l=n+a;return l<0?null:c<0?this.at(l,t):this.at(c,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,s,a,c,l,h=1/this.direction.x,u=1/this.direction.y,p=1/this.direction.z,d=this.origin;return h>=0?(n=(e.min.x-d.x)*h,r=(e.max.x-d.x)*h):(n=(e.max.x-d.x)*h,r=(e.min.x-d.x)*h),u>=0?(s=(e.min.y-d.y)*u,a=(e.max.y-d.y)*u):(s=(e.max.y-d.y)*u,a=(e.min.y-d.y)*u),n>a||s>r||((s>n||isNaN(n))&&(n=s),(a<r||isNaN(r))&&(r=a),p>=0?(c=(e.min.z-d.z)*p,l=(e.max.z-d.z)*p):(c=(e.max.z-d.z)*p,l=(e.min.z-d.z)*p),n>l||c>r)||((c>n||n!==n)&&(n=c),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,Nn)!==null}intersectTriangle(e,t,n,r,s){let a=this.origin,c=this.direction,l=c.x,h=c.y,u=c.z,p=e.x-a.x,d=e.y-a.y,f=e.z-a.z,g=t.x-a.x,y=t.y-a.y,m=t.z-a.z,b=n.x-a.x,w=n.y-a.y,T=n.z-a.z,x=Math.abs(l),S=Math.abs(h),E=Math.abs(u),_,A,U,I,D,F,V,C,q,Y,W,ne;if(x>=S&&x>=E?(U=l,F=p,q=g,ne=b,l>=0?(_=h,A=u,I=d,D=f,V=y,C=m,Y=w,W=T):(_=u,A=h,I=f,D=d,V=m,C=y,Y=T,W=w)):S>=E?(U=h,F=d,q=y,ne=w,h>=0?(_=u,A=l,I=f,D=p,V=m,C=g,Y=T,W=b):(_=l,A=u,I=p,D=f,V=g,C=m,Y=b,W=T)):(U=u,F=f,q=m,ne=T,u>=0?(_=l,A=h,I=p,D=d,V=g,C=y,Y=b,W=w):(_=h,A=l,I=d,D=p,V=y,C=g,Y=w,W=b)),U===0)return null;let X=_/U,Q=A/U,ee=1/U,ve=I-X*F,fe=D-Q*F,z=V-X*q,te=C-Q*q,xe=Y-X*ne,Ee=W-Q*ne,me=xe*te-Ee*z,De=ve*Ee-fe*xe,nt=z*fe-te*ve;if(r){if(me<0||De<0||nt<0)return null}else if((me<0||De<0||nt<0)&&(me>0||De>0||nt>0))return null;let Re=me+De+nt;if(Re===0)return null;let Je=ee*(me*F+De*q+nt*ne);return(Re>0?Je<0:Je>0)?null:this.at(Je/Re,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Gs=class extends mi{static{o(this,"MeshBasicMaterial")}constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new qe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Zn,this.combine=Wo,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Ul=new at,fi=new zs,fs=new qi,Fl=new G,ps=new G,ms=new G,gs=new G,Do=new G,bs=new G,Ol=new G,_s=new G,ut=class extends nn{static{o(this,"Mesh")}constructor(e=new Ut,t=new Gs){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,a=r.length;s<a;s++){let c=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[c]=s}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let c=this.morphTargetInfluences;if(s&&c){bs.set(0,0,0);for(let l=0,h=s.length;l<h;l++){let u=c[l],p=s[l];u!==0&&(Do.fromBufferAttribute(p,e),a?bs.addScaledVector(Do,u):bs.addScaledVector(Do.sub(t),u))}t.add(bs)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),fs.copy(n.boundingSphere),fs.applyMatrix4(s),fi.copy(e.ray).recast(e.near),!(fs.containsPoint(fi.origin)===!1&&(fi.intersectSphere(fs,Fl)===null||fi.origin.distanceToSquared(Fl)>(e.far-e.near)**2))&&(Ul.copy(s).invert(),fi.copy(e.ray).applyMatrix4(Ul),!(n.boundingBox!==null&&fi.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,fi)))}_computeIntersections(e,t,n){let r,s=this.geometry,a=this.material,c=s.index,l=s.attributes.position,h=s.attributes.uv,u=s.attributes.uv1,p=s.attributes.normal,d=s.groups,f=s.drawRange;if(c!==null)if(Array.isArray(a))for(let g=0,y=d.length;g<y;g++){let m=d[g],b=a[m.materialIndex],w=Math.max(m.start,f.start),T=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let x=w,S=T;x<S;x+=3){let E=c.getX(x),_=c.getX(x+1),A=c.getX(x+2);r=xs(this,b,e,n,h,u,p,E,_,A),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let g=Math.max(0,f.start),y=Math.min(c.count,f.start+f.count);for(let m=g,b=y;m<b;m+=3){let w=c.getX(m),T=c.getX(m+1),x=c.getX(m+2);r=xs(this,a,e,n,h,u,p,w,T,x),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,y=d.length;g<y;g++){let m=d[g],b=a[m.materialIndex],w=Math.max(m.start,f.start),T=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let x=w,S=T;x<S;x+=3){let E=x,_=x+1,A=x+2;r=xs(this,b,e,n,h,u,p,E,_,A),r&&(r.faceIndex=Math.floor(x/3),r.face.materialIndex=m.materialIndex,t.push(r))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=g,b=y;m<b;m+=3){let w=m,T=m+1,x=m+2;r=xs(this,a,e,n,h,u,p,w,T,x),r&&(r.faceIndex=Math.floor(m/3),t.push(r))}}}};function Pf(i,e,t,n,r,s,a,c){let l;if(e.side===Ft?l=n.intersectTriangle(a,s,r,!0,c):l=n.intersectTriangle(r,s,a,e.side===ii,c),l===null)return null;_s.copy(c),_s.applyMatrix4(i.matrixWorld);let h=t.ray.origin.distanceTo(_s);return h<t.near||h>t.far?null:{distance:h,point:_s.clone(),object:i}}o(Pf,"checkIntersection$1");function xs(i,e,t,n,r,s,a,c,l,h){i.getVertexPosition(c,ps),i.getVertexPosition(l,ms),i.getVertexPosition(h,gs);let u=Pf(i,e,t,n,ps,ms,gs,Ol);if(u){let p=new G;$n.getBarycoord(Ol,ps,ms,gs,p),r&&(u.uv=$n.getInterpolatedAttribute(r,c,l,h,p,new Xe)),s&&(u.uv1=$n.getInterpolatedAttribute(s,c,l,h,p,new Xe)),a&&(u.normal=$n.getInterpolatedAttribute(a,c,l,h,p,new G),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a:c,b:l,c:h,normal:new G,materialIndex:0};$n.getNormal(ps,ms,gs,d.normal),u.face=d,u.barycoord=p}return u}o(xs,"checkGeometryIntersection");var Vs=class extends Rt{static{o(this,"DataTexture")}constructor(e=null,t=1,n=1,r,s,a,c,l,h=yt,u=yt,p,d){super(null,a,c,l,h,u,r,s,p,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var pi=new qi,If=new Xe(.5,.5),ys=new G,gi=class{static{o(this,"Frustum")}constructor(e=new hn,t=new hn,n=new hn,r=new hn,s=new hn,a=new hn){this.planes=[e,t,n,r,s,a]}set(e,t,n,r,s,a){let c=this.planes;return c[0].copy(e),c[1].copy(t),c[2].copy(n),c[3].copy(r),c[4].copy(s),c[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=en,n=!1){let r=this.planes,s=e.elements,a=s[0],c=s[1],l=s[2],h=s[3],u=s[4],p=s[5],d=s[6],f=s[7],g=s[8],y=s[9],m=s[10],b=s[11],w=s[12],T=s[13],x=s[14],S=s[15];if(r[0].setComponents(h-a,f-u,b-g,S-w).normalize(),r[1].setComponents(h+a,f+u,b+g,S+w).normalize(),r[2].setComponents(h+c,f+p,b+y,S+T).normalize(),r[3].setComponents(h-c,f-p,b-y,S-T).normalize(),n)r[4].setComponents(l,d,m,x).normalize(),r[5].setComponents(h-l,f-d,b-m,S-x).normalize();else if(r[4].setComponents(h-l,f-d,b-m,S-x).normalize(),t===en)r[5].setComponents(h+l,f+d,b+m,S+x).normalize();else if(t===pr)r[5].setComponents(l,d,m,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),pi.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),pi.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(pi)}intersectsSprite(e){pi.center.set(0,0,0);let t=If.distanceTo(e.center);return pi.radius=.7071067811865476+t,pi.applyMatrix4(e.matrixWorld),this.intersectsSphere(pi)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(ys.x=r.normal.x>0?e.max.x:e.min.x,ys.y=r.normal.y>0?e.max.y:e.min.y,ys.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(ys)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Bl=new at,Hs=class i{static{o(this,"FrustumArray")}constructor(){this.coordinateSystem=en,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];Bl.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new gi),n[r].setFromProjectionMatrix(Bl,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new gi),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var bi=class extends Rt{static{o(this,"CubeTexture")}constructor(e=[],t=yi,n,r,s,a,c,l,h,u){super(e,t,n,r,s,a,c,l,h,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var dn=class extends Rt{static{o(this,"DepthTexture")}constructor(e,t,n=Kt,r,s,a,c=yt,l=yt,h,u=Fn,p=1){if(u!==Fn&&u!==kn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:p};super(d,r,s,a,c,l,u,n,h),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Hi(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Sr=class extends dn{static{o(this,"CubeDepthTexture")}constructor(e,t=Kt,n=yi,r,s,a=yt,c=yt,l,h=Fn){let u={width:e,height:e,depth:1},p=[u,u,u,u,u,u];super(e,e,t,n,r,s,a,c,l,h),this.image=p,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},_i=class extends Rt{static{o(this,"ExternalTexture")}constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Xi=class i extends Ut{static{o(this,"BoxGeometry")}constructor(e=1,t=1,n=1,r=1,s=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:s,depthSegments:a};let c=this;r=Math.floor(r),s=Math.floor(s),a=Math.floor(a);let l=[],h=[],u=[],p=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,a,s,0),g("z","y","x",1,-1,n,t,-e,a,s,1),g("x","z","y",1,1,e,n,t,r,a,2),g("x","z","y",1,-1,e,n,-t,r,a,3),g("x","y","z",1,-1,e,t,n,r,s,4),g("x","y","z",-1,-1,e,t,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new tn(h,3)),this.setAttribute("normal",new tn(u,3)),this.setAttribute("uv",new tn(p,2));function g(y,m,b,w,T,x,S,E,_,A,U){let I=x/_,D=S/A,F=x/2,V=S/2,C=E/2,q=_+1,Y=A+1,W=0,ne=0,X=new G;for(let Q=0;Q<Y;Q++){let ee=Q*D-V;for(let ve=0;ve<q;ve++){let fe=ve*I-F;X[y]=fe*w,X[m]=ee*T,X[b]=C,h.push(X.x,X.y,X.z),X[y]=0,X[m]=0,X[b]=E>0?1:-1,u.push(X.x,X.y,X.z),p.push(ve/_),p.push(1-Q/A),W+=1}}for(let Q=0;Q<A;Q++)for(let ee=0;ee<_;ee++){let ve=d+ee+q*Q,fe=d+ee+q*(Q+1),z=d+(ee+1)+q*(Q+1),te=d+(ee+1)+q*Q;l.push(ve,fe,te),l.push(fe,z,te),ne+=6}c.addGroup(f,ne,U),f+=ne,d+=W}o(g,"buildPlane")}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Mr=class i extends Ut{static{o(this,"PlaneGeometry")}constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let s=e/2,a=t/2,c=Math.floor(n),l=Math.floor(r),h=c+1,u=l+1,p=e/c,d=t/l,f=[],g=[],y=[],m=[];for(let b=0;b<u;b++){let w=b*d-a;for(let T=0;T<h;T++){let x=T*p-s;g.push(x,-w,0),y.push(0,0,1),m.push(T/c),m.push(1-b/l)}}for(let b=0;b<l;b++)for(let w=0;w<c;w++){let T=w+h*b,x=w+h*(b+1),S=w+1+h*(b+1),E=w+1+h*b;f.push(T,x,E),f.push(x,S,E)}this.setIndex(f),this.setAttribute("position",new tn(g,3)),this.setAttribute("normal",new tn(y,3)),this.setAttribute("uv",new tn(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function Si(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(kl(r))r.isRenderTargetTexture?(Pe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(kl(r[0])){let s=[];for(let a=0,c=r.length;a<c;a++)s[a]=r[a].clone();e[t][n]=s}else e[t][n]=r.slice();else e[t][n]=r}}return e}o(Si,"cloneUniforms");function Pt(i){let e={};for(let t=0;t<i.length;t++){let n=Si(i[t]);for(let r in n)e[r]=n[r]}return e}o(Pt,"mergeUniforms");function kl(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}o(kl,"isThreeObject");function Lf(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}o(Lf,"cloneUniformsGroups");function hc(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Ve.workingColorSpace}o(hc,"getUnlitUniformColorSpace");var Ch={clone:Si,merge:Pt},Df=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Nf=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,wn=class extends mi{static{o(this,"ShaderMaterial")}constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Df,this.fragmentShader=Nf,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Si(e.uniforms),this.uniformsGroups=Lf(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let a=this.uniforms[r].value;a&&a.isTexture?t.uniforms[r]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[r]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[r]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[r]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[r]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[r]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[r]={type:"m4",value:a.toArray()}:t.uniforms[r]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new qe().setHex(r.value);break;case"v2":this.uniforms[n].value=new Xe().fromArray(r.value);break;case"v3":this.uniforms[n].value=new G().fromArray(r.value);break;case"v4":this.uniforms[n].value=new et().fromArray(r.value);break;case"m3":this.uniforms[n].value=new Le().fromArray(r.value);break;case"m4":this.uniforms[n].value=new at().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},fn=class extends wn{static{o(this,"RawShaderMaterial")}constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ws=class extends mi{static{o(this,"MeshDepthMaterial")}constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=dh,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},qs=class extends mi{static{o(this,"MeshDistanceMaterial")}constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Oi(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}o(Oi,"convertArray");function vs(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}o(vs,"hasTangents");var ei=class{static{o(this,"Interpolant")}constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],s=t[n-1];n:{e:{let a;t:{i:if(!(e<r)){for(let c=n+2;;){if(r===void 0){if(e<s)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===c)break;if(s=r,r=t[++n],e<r)break e}a=t.length;break t}if(!(e>=s)){let c=t[1];e<c&&(n=2,s=c);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=t[--n-1],e>=s)break e}a=n,n=0;break t}break n}for(;n<a;){let c=n+a>>>1;e<t[c]?a=c:n=c+1}if(r=t[n],s=t[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r;for(let a=0;a!==r;++a)t[a]=n[s+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Xs=class extends ei{static{o(this,"CubicInterpolant")}constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Uo,endingEnd:Uo}}intervalChanged_(e,t,n){let r=this.parameterPositions,s=e-2,a=e+1,c=r[s],l=r[a];if(c===void 0)switch(this.getSettings_().endingStart){case Fo:s=e,c=2*t-n;break;case Oo:s=r.length-2,c=t+r[s]-r[s+1];break;default:s=e,c=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Fo:a=e,l=2*n-t;break;case Oo:a=1,l=n+r[1]-r[0];break;default:a=e-1,l=t}let h=(n-t)*.5,u=this.valueSize;this._weightPrev=h/(t-c),this._weightNext=h/(l-n),this._offsetPrev=s*u,this._offsetNext=a*u}interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,c=this.valueSize,l=e*c,h=l-c,u=this._offsetPrev,p=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(r-t),y=g*g,m=y*g,b=-d*m+2*d*y-d*g,w=(1+d)*m+(-1.5-2*d)*y+(-.5+d)*g+1,T=(-1-f)*m+(1.5+f)*y+.5*g,x=f*m-f*y;for(let S=0;S!==c;++S)s[S]=b*a[u+S]+w*a[h+S]+T*a[l+S]+x*a[p+S];return s}},Ks=class extends ei{static{o(this,"LinearInterpolant")}constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,c=this.valueSize,l=e*c,h=l-c,u=(n-t)/(r-t),p=1-u;for(let d=0;d!==c;++d)s[d]=a[h+d]*p+a[l+d]*u;return s}},js=class extends ei{static{o(this,"DiscreteInterpolant")}constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Ys=class extends ei{static{o(this,"BezierInterpolant")}interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,c=this.valueSize,l=e*c,h=l-c,u=this.inTangents,p=this.outTangents;if(!u||!p){let g=(n-t)/(r-t),y=1-g;for(let m=0;m!==c;++m)s[m]=a[h+m]*y+a[l+m]*g;return s}let d=c*2,f=e-1;for(let g=0;g!==c;++g){let y=a[h+g],m=a[l+g],b=f*d+g*2,w=p[b],T=p[b+1],x=e*d+g*2,S=u[x],E=u[x+1],_=Ff(n,t,w,S,r);s[g]=Ph(_,y,T,E,m)}return s}};function Ph(i,e,t,n,r){let s=1-i;return s*s*s*e+3*s*s*i*t+3*s*i*i*n+i*i*i*r}o(Ph,"cubicBezier");function Uf(i,e,t,n,r){let s=1-i;return 3*s*s*(t-e)+6*s*i*(n-t)+3*i*i*(r-n)}o(Uf,"cubicBezierSlope");function Ff(i,e,t,n,r){let s=(i-e)/(r-e);for(let a=0;a<8;a++){let c=Ph(s,e,t,n,r)-i;if(Math.abs(c)<1e-10)break;let l=Uf(s,e,t,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-c/l))}return s}o(Ff,"solveBezierParameter");var qt=class{static{o(this,"KeyframeTrack")}constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Oi(t,this.TimeBufferType),this.values=Oi(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Oi(e.times,Array),values:Oi(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),vs(e.settings)&&(n.settings={inTangents:Oi(e.settings.inTangents,Array),outTangents:Oi(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new js(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ks(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Xs(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Ys(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ur:t=this.InterpolantFactoryMethodDiscrete;break;case Us:t=this.InterpolantFactoryMethodLinear;break;case ws:t=this.InterpolantFactoryMethodSmooth;break;case No:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Pe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ur;case this.InterpolantFactoryMethodLinear:return Us;case this.InterpolantFactoryMethodSmooth:return ws;case this.InterpolantFactoryMethodBezier:return No}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;vs(this.settings)&&(zl(this.settings.inTangents,e),zl(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;vs(this.settings)&&(Gl(this.settings.inTangents,e),Gl(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,s=0,a=r-1;for(;s!==r&&n[s]<e;)++s;for(;a!==-1&&n[a]>t;)--a;if(++a,s!==0||a!==r){s>=a&&(a=Math.max(a,1),s=a-1);let c=this.getValueSize();this.times=n.slice(s,a),this.values=this.values.slice(s*c,a*c)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ie("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,s=n.length;s===0&&(Ie("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let c=0;c!==s;c++){let l=n[c];if(typeof l=="number"&&isNaN(l)){Ie("KeyframeTrack: Time is not a valid number.",this,c,l),e=!1;break}if(a!==null&&a>l){Ie("KeyframeTrack: Out of order keys.",this,c,l,a),e=!1;break}a=l}if(r!==void 0&&df(r))for(let c=0,l=r.length;c!==l;++c){let h=r[c];if(isNaN(h)){Ie("KeyframeTrack: Value is not a valid number.",this,c,h),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===ws,s=e.length-1,a=1;for(let c=1;c<s;++c){let l=!1,h=e[c],u=e[c+1];if(h!==u&&(c!==1||h!==e[0]))if(r)l=!0;else{let p=c*n,d=p-n,f=p+n;for(let g=0;g!==n;++g){let y=t[p+g];if(y!==t[d+g]||y!==t[f+g]){l=!0;break}}}if(l){if(c!==a){e[a]=e[c];let p=c*n,d=a*n;for(let f=0;f!==n;++f)t[d+f]=t[p+f]}++a}}if(s>0){e[a]=e[s];for(let c=s*n,l=a*n,h=0;h!==n;++h)t[l+h]=t[c+h];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,vs(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function zl(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}o(zl,"shiftTangentTimes");function Gl(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}o(Gl,"scaleTangentTimes");qt.prototype.ValueTypeName="";qt.prototype.TimeBufferType=Float32Array;qt.prototype.ValueBufferType=Float32Array;qt.prototype.DefaultInterpolation=Us;var ti=class extends qt{static{o(this,"BooleanKeyframeTrack")}constructor(e,t,n){super(e,t,n)}};ti.prototype.ValueTypeName="bool";ti.prototype.ValueBufferType=Array;ti.prototype.DefaultInterpolation=ur;ti.prototype.InterpolantFactoryMethodLinear=void 0;ti.prototype.InterpolantFactoryMethodSmooth=void 0;var Js=class extends qt{static{o(this,"ColorKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}};Js.prototype.ValueTypeName="color";var $s=class extends qt{static{o(this,"NumberKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}};$s.prototype.ValueTypeName="number";var Zs=class extends ei{static{o(this,"QuaternionLinearInterpolant")}constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,a=this.sampleValues,c=this.valueSize,l=(n-t)/(r-t),h=e*c;for(let u=h+c;h!==u;h+=4)Mn.slerpFlat(s,0,a,h-c,a,h,l);return s}},wr=class extends qt{static{o(this,"QuaternionKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new Zs(this.times,this.values,this.getValueSize(),e)}};wr.prototype.ValueTypeName="quaternion";wr.prototype.InterpolantFactoryMethodSmooth=void 0;var ni=class extends qt{static{o(this,"StringKeyframeTrack")}constructor(e,t,n){super(e,t,n)}};ni.prototype.ValueTypeName="string";ni.prototype.ValueBufferType=Array;ni.prototype.DefaultInterpolation=ur;ni.prototype.InterpolantFactoryMethodLinear=void 0;ni.prototype.InterpolantFactoryMethodSmooth=void 0;var Qs=class extends qt{static{o(this,"VectorKeyframeTrack")}constructor(e,t,n,r){super(e,t,n,r)}};Qs.prototype.ValueTypeName="vector";var ea=class{static{o(this,"LoadingManager")}constructor(e,t,n){let r=this,s=!1,a=0,c=0,l,h=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){c++,s===!1&&r.onStart!==void 0&&r.onStart(u,a,c),s=!0},this.itemEnd=function(u){a++,r.onProgress!==void 0&&r.onProgress(u,a,c),a===c&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,p){return h.push(u,p),this},this.removeHandler=function(u){let p=h.indexOf(u);return p!==-1&&h.splice(p,2),this},this.getHandler=function(u){for(let p=0,d=h.length;p<d;p+=2){let f=h[p],g=h[p+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ih=new ea,ta=class{static{o(this,"Loader")}constructor(e){this.manager=e!==void 0?e:Ih,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,s){n.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};ta.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ss=new G,Ms=new Mn,yn=new G,Er=class extends nn{static{o(this,"Camera")}constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new at,this.projectionMatrix=new at,this.projectionMatrixInverse=new at,this.coordinateSystem=en,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ss,Ms,yn),yn.x===1&&yn.y===1&&yn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ss,Ms,yn.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Ss,Ms,yn),yn.x===1&&yn.y===1&&yn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ss,Ms,yn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Jn=new G,Vl=new Xe,Hl=new Xe,Mt=class extends Er{static{o(this,"PerspectiveCamera")}constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Fs*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(fo*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Fs*2*Math.atan(Math.tan(fo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Jn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Jn.x,Jn.y).multiplyScalar(-e/Jn.z),Jn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Jn.x,Jn.y).multiplyScalar(-e/Jn.z)}getViewSize(e,t){return this.getViewBounds(e,Vl,Hl),t.subVectors(Hl,Vl)}setViewOffset(e,t,n,r,s,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(fo*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,s=-.5*r,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,h=a.fullHeight;s+=a.offsetX*r/l,t-=a.offsetY*n/h,r*=a.width/l,n*=a.height/h}let c=this.filmOffset;c!==0&&(s+=e*c/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var na=class extends Er{static{o(this,"OrthographicCamera")}constructor(e=-1,t=1,n=1,r=-1,s=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=s,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,s,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-e,a=n+e,c=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let h=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=h*this.view.offsetX,a=s+h*this.view.width,c-=u*this.view.offsetY,l=c-u*this.view.height}this.projectionMatrix.makeOrthographic(s,a,c,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Ar=class extends Ut{static{o(this,"InstancedBufferGeometry")}constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Bi=-90,ki=1,Ki=class extends nn{static{o(this,"CubeCamera")}constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new Mt(Bi,ki,e,t);r.layers=this.layers,this.add(r);let s=new Mt(Bi,ki,e,t);s.layers=this.layers,this.add(s);let a=new Mt(Bi,ki,e,t);a.layers=this.layers,this.add(a);let c=new Mt(Bi,ki,e,t);c.layers=this.layers,this.add(c);let l=new Mt(Bi,ki,e,t);l.layers=this.layers,this.add(l);let h=new Mt(Bi,ki,e,t);h.layers=this.layers,this.add(h)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,s,a,c,l]=t;for(let h of t)this.remove(h);if(e===en)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),c.up.set(0,1,0),c.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===pr)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),c.up.set(0,-1,0),c.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let h of t)this.add(h),h.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,a,c,l,h,u]=this.children,p=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,1,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,3,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,r),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(p,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},ia=class extends Mt{static{o(this,"ArrayCamera")}constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var uc="\\[\\]\\.:\\/",Of=new RegExp("["+uc+"]","g"),dc="[^"+uc+"]",Bf="[^"+uc.replace("\\.","")+"]",kf=/((?:WC+[\/:])*)/.source.replace("WC",dc),zf=/(WCOD+)?/.source.replace("WCOD",Bf),Gf=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",dc),Vf=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",dc),Hf=new RegExp("^"+kf+zf+Gf+Vf+"$"),Wf=["material","materials","bones","map"],Bo=class{static{o(this,"Composite")}constructor(e,t,n){let r=n||it.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},it=class i{static{o(this,"PropertyBinding")}constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Of,"")}static parseTrackName(e){let t=Hf.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);Wf.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=o(function(s){for(let a=0;a<s.length;a++){let c=s[a];if(c.name===t||c.uuid===t)return c;let l=n(c.children);if(l)return l}return null},"searchNodeSubtree"),r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Pe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let h=t.objectIndex;switch(n){case"materials":if(!e.material){Ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ie("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ie("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===h){h=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ie("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ie("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Ie("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(h!==void 0){if(e[h]===void 0){Ie("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[h]}}let a=e[r];if(a===void 0){let h=t.nodeName;Ie("PropertyBinding: Trying to update property for track: "+h+"."+r+" but it wasn't found.",e);return}let c=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?c=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(c=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){Ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ie("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=s}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][c]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};it.Composite=Bo;it.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};it.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};it.prototype.GetterByBindingType=[it.prototype._getValue_direct,it.prototype._getValue_array,it.prototype._getValue_arrayElement,it.prototype._getValue_toArray];it.prototype.SetterByBindingTypeAndVersioning=[[it.prototype._setValue_direct,it.prototype._setValue_direct_setNeedsUpdate,it.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[it.prototype._setValue_array,it.prototype._setValue_array_setNeedsUpdate,it.prototype._setValue_array_setMatrixWorldNeedsUpdate],[it.prototype._setValue_arrayElement,it.prototype._setValue_arrayElement_setNeedsUpdate,it.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[it.prototype._setValue_fromArray,it.prototype._setValue_fromArray_setNeedsUpdate,it.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Zx=new Float32Array(1);var Tr=class{static{o(this,"GLBufferAttribute")}constructor(e,t,n,r,s,a=!1){this.isGLBufferAttribute=!0,this.name="",this.buffer=e,this.type=t,this.itemSize=n,this.elementSize=r,this.count=s,this.normalized=a,this.version=0}set needsUpdate(e){e===!0&&this.version++}setBuffer(e){return this.buffer=e,this}setType(e,t){return this.type=e,this.elementSize=t,this}setItemSize(e){return this.itemSize=e,this}setCount(e){return this.count=e,this}};var ko=class{static{o(this,"Matrix2")}static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=n,s[3]=r,this}};function fc(i,e,t,n){let r=qf(n);switch(t){case ic:return i*e;case sc:return i*e/r.components*r.byteLength;case ha:return i*e/r.components*r.byteLength;case si:return i*e*2/r.components*r.byteLength;case ua:return i*e*2/r.components*r.byteLength;case rc:return i*e*3/r.components*r.byteLength;case gn:return i*e*4/r.components*r.byteLength;case da:return i*e*4/r.components*r.byteLength;case Ir:case Lr:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Dr:case Nr:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case pa:case ga:return Math.max(i,16)*Math.max(e,8)/4;case fa:case ma:return Math.max(i,8)*Math.max(e,8)/2;case ba:case _a:case ya:case va:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case xa:case Ur:case Sa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ma:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case wa:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Ea:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Aa:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Ta:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Ra:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Ca:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Pa:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Ia:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case La:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Da:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Na:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Ua:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Fa:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Oa:case Ba:case ka:return Math.ceil(i/4)*Math.ceil(e/4)*16;case za:case Ga:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Fr:case Va:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}o(fc,"getByteLength");function qf(i){switch(i){case Xt:case Qo:return{byteLength:1,components:1};case Qi:case ec:case mn:return{byteLength:2,components:1};case ca:case la:return{byteLength:2,components:4};case Kt:case oa:case pn:return{byteLength:4,components:1};case tc:case nc:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}o(qf,"getTextureTypeByteLength");typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Pe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Qh(){let i=null,e=!1,t=null,n=null;function r(s,a){n=i.requestAnimationFrame(r),t(s,a)}return o(r,"onAnimationFrame"),{start:o(function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},"start"),stop:o(function(){i!==null&&i.cancelAnimationFrame(n),e=!1},"stop"),setAnimationLoop:o(function(s){t=s},"setAnimationLoop"),setContext:o(function(s){i=s},"setContext")}}o(Qh,"WebGLAnimation");function Kf(i){let e=new WeakMap;function t(c,l){let h=c.array,u=c.usage,p=h.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,h,u),c.onUploadCallback();let f;if(h instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&h instanceof Float16Array)f=i.HALF_FLOAT;else if(h instanceof Uint16Array)c.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(h instanceof Int16Array)f=i.SHORT;else if(h instanceof Uint32Array)f=i.UNSIGNED_INT;else if(h instanceof Int32Array)f=i.INT;else if(h instanceof Int8Array)f=i.BYTE;else if(h instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(h instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+h);return{buffer:d,type:f,bytesPerElement:h.BYTES_PER_ELEMENT,version:c.version,size:p}}o(t,"createBuffer");function n(c,l,h){let u=l.array,p=l.updateRanges;if(i.bindBuffer(h,c),p.length===0)i.bufferSubData(h,0,u);else{p.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<p.length;f++){let g=p[d],y=p[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,p[d]=y)}p.length=d+1;for(let f=0,g=p.length;f<g;f++){let y=p[f];i.bufferSubData(h,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}o(n,"updateBuffer");function r(c){return c.isInterleavedBufferAttribute&&(c=c.data),e.get(c)}o(r,"get");function s(c){c.isInterleavedBufferAttribute&&(c=c.data);let l=e.get(c);l&&(i.deleteBuffer(l.buffer),e.delete(c))}o(s,"remove");function a(c,l){if(c.isInterleavedBufferAttribute&&(c=c.data),c.isGLBufferAttribute){let u=e.get(c);(!u||u.version<c.version)&&e.set(c,{buffer:c.buffer,type:c.type,bytesPerElement:c.elementSize,version:c.version});return}let h=e.get(c);if(h===void 0)e.set(c,t(c,l));else if(h.version<c.version){if(h.size!==c.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(h.buffer,c,l),h.version=c.version}}return o(a,"update"),{get:r,remove:s,update:a}}o(Kf,"WebGLAttributes");var jf=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Yf=`#ifdef USE_ALPHAHASH
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
#endif`,Jf=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$f=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Zf=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Qf=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ep=`#ifdef USE_AOMAP
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
#endif`,tp=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,np=`#ifdef USE_BATCHING
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
#endif`,ip=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,rp=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,sp=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ap=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,op=`#ifdef USE_IRIDESCENCE
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
#endif`,cp=`#ifdef USE_BUMPMAP
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
#endif`,lp=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,hp=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,up=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,dp=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,fp=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,pp=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,mp=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,gp=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,bp=`#define PI 3.141592653589793
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
} // validated`,_p=`vec3 transformedNormal = objectNormal;
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
#endif`,xp=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yp=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,vp=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Sp=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Mp="gl_FragColor = linearToOutputTexel( gl_FragColor );",wp=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ep=`#ifdef USE_ENVMAP
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
#endif`,Ap=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Tp=`#ifdef USE_ENVMAP
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
#endif`,Rp=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Cp=`#ifdef USE_ENVMAP
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
#endif`,Pp=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ip=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Lp=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Dp=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Np=`#ifdef USE_GRADIENTMAP
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
}`,Up=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Fp=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Op=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Bp=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,kp=`#ifdef USE_ENVMAP
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
#endif`,zp=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Gp=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Vp=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Hp=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Wp=`PhysicalMaterial material;
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
#endif`,qp=`uniform sampler2D dfgLUT;
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
}`,Xp=`
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
#endif`,Kp=`#if defined( RE_IndirectDiffuse )
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
#endif`,jp=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Yp=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Jp=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$p=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zp=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Qp=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,em=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,tm=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,nm=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,im=`#if defined( USE_POINTS_UV )
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
#endif`,rm=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,sm=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,am=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,om=`#if defined( USE_MORPHCOLORS )
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
#endif`,cm=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lm=`#ifdef USE_MORPHTARGETS
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
#endif`,hm=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,um=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,dm=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,fm=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,pm=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,mm=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,gm=`#ifdef USE_NORMALMAP
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
#endif`,bm=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,_m=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,xm=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ym=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,vm=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Sm=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Mm=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,wm=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Em=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Am=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Tm=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Rm=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Cm=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Pm=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Im=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Lm=`float getShadowMask() {
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
}`,Dm=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Nm=`#ifdef USE_SKINNING
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
#endif`,Um=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Fm=`#ifdef USE_SKINNING
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
#endif`,Om=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Bm=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,km=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,zm=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Gm=`#ifdef USE_TRANSMISSION
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
#endif`,Vm=`#ifdef USE_TRANSMISSION
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
#endif`,Hm=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Wm=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,qm=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Xm=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Km=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,jm=`uniform sampler2D t2D;
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
}`,Ym=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Jm=`uniform float backgroundBlurriness;
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
}`,$m=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Zm=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Qm=`#include <common>
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
}`,eg=`#if DEPTH_PACKING == 3200
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
}`,tg=`#define DISTANCE
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
}`,ng=`#define DISTANCE
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
}`,ig=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,rg=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sg=`uniform float scale;
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
}`,ag=`uniform vec3 diffuse;
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
}`,og=`#include <common>
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
}`,cg=`uniform vec3 diffuse;
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
}`,lg=`#define LAMBERT
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
}`,hg=`#define LAMBERT
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
}`,ug=`#define MATCAP
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
}`,dg=`#define MATCAP
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
}`,fg=`#define NORMAL
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
}`,pg=`#define NORMAL
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
}`,mg=`#define PHONG
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
}`,gg=`#define PHONG
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
}`,bg=`#define STANDARD
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
}`,_g=`#define STANDARD
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
}`,xg=`#define TOON
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
}`,yg=`#define TOON
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
}`,vg=`uniform float size;
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
}`,Sg=`uniform vec3 diffuse;
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
}`,Mg=`#include <common>
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
}`,wg=`uniform vec3 color;
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
}`,Eg=`uniform float rotation;
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
}`,Ag=`uniform vec3 diffuse;
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
}`,Be={alphahash_fragment:jf,alphahash_pars_fragment:Yf,alphamap_fragment:Jf,alphamap_pars_fragment:$f,alphatest_fragment:Zf,alphatest_pars_fragment:Qf,aomap_fragment:ep,aomap_pars_fragment:tp,batching_pars_vertex:np,batching_vertex:ip,begin_vertex:rp,beginnormal_vertex:sp,bsdfs:ap,iridescence_fragment:op,bumpmap_pars_fragment:cp,clipping_planes_fragment:lp,clipping_planes_pars_fragment:hp,clipping_planes_pars_vertex:up,clipping_planes_vertex:dp,color_fragment:fp,color_pars_fragment:pp,color_pars_vertex:mp,color_vertex:gp,common:bp,defaultnormal_vertex:_p,displacementmap_pars_vertex:xp,displacementmap_vertex:yp,emissivemap_fragment:vp,emissivemap_pars_fragment:Sp,colorspace_fragment:Mp,colorspace_pars_fragment:wp,envmap_fragment:Ep,envmap_common_pars_fragment:Ap,envmap_pars_fragment:Tp,envmap_pars_vertex:Rp,envmap_physical_pars_fragment:kp,envmap_vertex:Cp,fog_vertex:Pp,fog_pars_vertex:Ip,fog_fragment:Lp,fog_pars_fragment:Dp,gradientmap_pars_fragment:Np,lightmap_pars_fragment:Up,lights_lambert_fragment:Fp,lights_lambert_pars_fragment:Op,lights_pars_begin:Bp,lights_toon_fragment:zp,lights_toon_pars_fragment:Gp,lights_phong_fragment:Vp,lights_phong_pars_fragment:Hp,lights_physical_fragment:Wp,lights_physical_pars_fragment:qp,lights_fragment_begin:Xp,lights_fragment_maps:Kp,lights_fragment_end:jp,lightprobes_pars_fragment:Yp,logdepthbuf_fragment:Jp,logdepthbuf_pars_fragment:$p,logdepthbuf_pars_vertex:Zp,logdepthbuf_vertex:Qp,map_fragment:em,map_pars_fragment:tm,map_particle_fragment:nm,map_particle_pars_fragment:im,metalnessmap_fragment:rm,metalnessmap_pars_fragment:sm,morphinstance_vertex:am,morphcolor_vertex:om,morphnormal_vertex:cm,morphtarget_pars_vertex:lm,morphtarget_vertex:hm,normal_fragment_begin:um,normal_fragment_maps:dm,normal_pars_fragment:fm,normal_pars_vertex:pm,normal_vertex:mm,normalmap_pars_fragment:gm,clearcoat_normal_fragment_begin:bm,clearcoat_normal_fragment_maps:_m,clearcoat_pars_fragment:xm,iridescence_pars_fragment:ym,opaque_fragment:vm,packing:Sm,premultiplied_alpha_fragment:Mm,project_vertex:wm,dithering_fragment:Em,dithering_pars_fragment:Am,roughnessmap_fragment:Tm,roughnessmap_pars_fragment:Rm,shadowmap_pars_fragment:Cm,shadowmap_pars_vertex:Pm,shadowmap_vertex:Im,shadowmask_pars_fragment:Lm,skinbase_vertex:Dm,skinning_pars_vertex:Nm,skinning_vertex:Um,skinnormal_vertex:Fm,specularmap_fragment:Om,specularmap_pars_fragment:Bm,tonemapping_fragment:km,tonemapping_pars_fragment:zm,transmission_fragment:Gm,transmission_pars_fragment:Vm,uv_pars_fragment:Hm,uv_pars_vertex:Wm,uv_vertex:qm,worldpos_vertex:Xm,background_vert:Km,background_frag:jm,backgroundCube_vert:Ym,backgroundCube_frag:Jm,cube_vert:$m,cube_frag:Zm,depth_vert:Qm,depth_frag:eg,distance_vert:tg,distance_frag:ng,equirect_vert:ig,equirect_frag:rg,linedashed_vert:sg,linedashed_frag:ag,meshbasic_vert:og,meshbasic_frag:cg,meshlambert_vert:lg,meshlambert_frag:hg,meshmatcap_vert:ug,meshmatcap_frag:dg,meshnormal_vert:fg,meshnormal_frag:pg,meshphong_vert:mg,meshphong_frag:gg,meshphysical_vert:bg,meshphysical_frag:_g,meshtoon_vert:xg,meshtoon_frag:yg,points_vert:vg,points_frag:Sg,shadow_vert:Mg,shadow_frag:wg,sprite_vert:Eg,sprite_frag:Ag},be={common:{diffuse:{value:new qe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Le},alphaMap:{value:null},alphaMapTransform:{value:new Le},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Le}},envmap:{envMap:{value:null},envMapRotation:{value:new Le},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Le}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Le}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Le},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Le},normalScale:{value:new Xe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Le},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Le}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Le}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Le}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new qe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new qe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Le},alphaTest:{value:0},uvTransform:{value:new Le}},sprite:{diffuse:{value:new qe(16777215)},opacity:{value:1},center:{value:new Xe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Le},alphaMap:{value:null},alphaMapTransform:{value:new Le},alphaTest:{value:0}}},Tn={basic:{uniforms:Pt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.fog]),vertexShader:Be.meshbasic_vert,fragmentShader:Be.meshbasic_frag},lambert:{uniforms:Pt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new qe(0)},envMapIntensity:{value:1}}]),vertexShader:Be.meshlambert_vert,fragmentShader:Be.meshlambert_frag},phong:{uniforms:Pt([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new qe(0)},specular:{value:new qe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Be.meshphong_vert,fragmentShader:Be.meshphong_frag},standard:{uniforms:Pt([be.common,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.roughnessmap,be.metalnessmap,be.fog,be.lights,{emissive:{value:new qe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag},toon:{uniforms:Pt([be.common,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.gradientmap,be.fog,be.lights,{emissive:{value:new qe(0)}}]),vertexShader:Be.meshtoon_vert,fragmentShader:Be.meshtoon_frag},matcap:{uniforms:Pt([be.common,be.bumpmap,be.normalmap,be.displacementmap,be.fog,{matcap:{value:null}}]),vertexShader:Be.meshmatcap_vert,fragmentShader:Be.meshmatcap_frag},points:{uniforms:Pt([be.points,be.fog]),vertexShader:Be.points_vert,fragmentShader:Be.points_frag},dashed:{uniforms:Pt([be.common,be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Be.linedashed_vert,fragmentShader:Be.linedashed_frag},depth:{uniforms:Pt([be.common,be.displacementmap]),vertexShader:Be.depth_vert,fragmentShader:Be.depth_frag},normal:{uniforms:Pt([be.common,be.bumpmap,be.normalmap,be.displacementmap,{opacity:{value:1}}]),vertexShader:Be.meshnormal_vert,fragmentShader:Be.meshnormal_frag},sprite:{uniforms:Pt([be.sprite,be.fog]),vertexShader:Be.sprite_vert,fragmentShader:Be.sprite_frag},background:{uniforms:{uvTransform:{value:new Le},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Be.background_vert,fragmentShader:Be.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Le}},vertexShader:Be.backgroundCube_vert,fragmentShader:Be.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Be.cube_vert,fragmentShader:Be.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Be.equirect_vert,fragmentShader:Be.equirect_frag},distance:{uniforms:Pt([be.common,be.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Be.distance_vert,fragmentShader:Be.distance_frag},shadow:{uniforms:Pt([be.lights,be.fog,{color:{value:new qe(0)},opacity:{value:1}}]),vertexShader:Be.shadow_vert,fragmentShader:Be.shadow_frag}};Tn.physical={uniforms:Pt([Tn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Le},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Le},clearcoatNormalScale:{value:new Xe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Le},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Le},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Le},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Le},sheen:{value:0},sheenColor:{value:new qe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Le},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Le},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Le},transmissionSamplerSize:{value:new Xe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Le},attenuationDistance:{value:0},attenuationColor:{value:new qe(0)},specularColor:{value:new qe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Le},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Le},anisotropyVector:{value:new Xe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Le}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag};var Wa={r:0,b:0,g:0},Tg=new at,eu=new Le;eu.set(-1,0,0,0,1,0,0,0,1);function Rg(i,e,t,n,r,s){let a=new qe(0),c=r===!0?0:1,l,h,u=null,p=0,d=null;function f(w){let T=w.isScene===!0?w.background:null;if(T&&T.isTexture){let x=w.backgroundBlurriness>0;T=e.get(T,x)}return T}o(f,"getBackground");function g(w){let T=!1,x=f(w);x===null?m(a,c):x&&x.isColor&&(m(x,1),T=!0);let S=i.xr.getEnvironmentBlendMode();S==="additive"?t.buffers.color.setClear(0,0,0,1,s):S==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}o(g,"render");function y(w,T){let x=f(T);x&&x.isCubeTexture?(h===void 0&&(h=new ut(new Xi(1,1,1),new wn({name:"BackgroundCubeMaterial",uniforms:Si(Tn.backgroundCube.uniforms),vertexShader:Tn.backgroundCube.vertexShader,fragmentShader:Tn.backgroundCube.fragmentShader,side:Ft,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(S,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:o(function(){return this.uniforms.envMap.value},"get")}),n.update(h)),h.material.uniforms.envMap.value=x,h.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(Tg.makeRotationFromEuler(T.backgroundRotation)).transpose(),x.isRenderTargetTexture===!1&&h.material.uniforms.backgroundRotation.value.premultiply(eu),h.material.toneMapped=Ve.getTransfer(x.colorSpace)!==Ye,(u!==x||p!==x.version||d!==i.toneMapping)&&(h.material.needsUpdate=!0,u=x,p=x.version,d=i.toneMapping),h.layers.enableAll(),w.unshift(h,h.geometry,h.material,0,0,null)):x&&x.isTexture&&(l===void 0&&(l=new ut(new Mr(2,2),new wn({name:"BackgroundMaterial",uniforms:Si(Tn.background.uniforms),vertexShader:Tn.background.vertexShader,fragmentShader:Tn.background.fragmentShader,side:ii,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:o(function(){return this.uniforms.t2D.value},"get")}),n.update(l)),l.material.uniforms.t2D.value=x,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Ve.getTransfer(x.colorSpace)!==Ye,x.matrixAutoUpdate===!0&&x.updateMatrix(),l.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||p!==x.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=x,p=x.version,d=i.toneMapping),l.layers.enableAll(),w.unshift(l,l.geometry,l.material,0,0,null))}o(y,"addToRenderList");function m(w,T){w.getRGB(Wa,hc(i)),t.buffers.color.setClear(Wa.r,Wa.g,Wa.b,T,s)}o(m,"setClear");function b(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return o(b,"dispose"),{getClearColor:o(function(){return a},"getClearColor"),setClearColor:o(function(w,T=1){a.set(w),c=T,m(a,c)},"setClearColor"),getClearAlpha:o(function(){return c},"getClearAlpha"),setClearAlpha:o(function(w){c=w,m(a,c)},"setClearAlpha"),render:g,addToRenderList:y,dispose:b}}o(Rg,"WebGLBackground");function Cg(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=d(null),s=r,a=!1;function c(D,F,V,C,q){let Y=!1,W=p(D,C,V,F);s!==W&&(s=W,h(s.object)),Y=f(D,C,V,q),Y&&g(D,C,V,q),q!==null&&e.update(q,i.ELEMENT_ARRAY_BUFFER),(Y||a)&&(a=!1,x(D,F,V,C),q!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(q).buffer))}o(c,"setup");function l(){return i.createVertexArray()}o(l,"createVertexArrayObject");function h(D){return i.bindVertexArray(D)}o(h,"bindVertexArrayObject");function u(D){return i.deleteVertexArray(D)}o(u,"deleteVertexArrayObject");function p(D,F,V,C){let q=C.wireframe===!0,Y=n[F.id];Y===void 0&&(Y={},n[F.id]=Y);let W=D.isInstancedMesh===!0?D.id:0,ne=Y[W];ne===void 0&&(ne={},Y[W]=ne);let X=ne[V.id];X===void 0&&(X={},ne[V.id]=X);let Q=X[q];return Q===void 0&&(Q=d(l()),X[q]=Q),Q}o(p,"getBindingState");function d(D){let F=[],V=[],C=[];for(let q=0;q<t;q++)F[q]=0,V[q]=0,C[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:V,attributeDivisors:C,object:D,attributes:{},index:null}}o(d,"createBindingState");function f(D,F,V,C){let q=s.attributes,Y=F.attributes,W=0,ne=V.getAttributes();for(let X in ne)if(ne[X].location>=0){let ee=q[X],ve=Y[X];if(ve===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(ve=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(ve=D.instanceColor)),ee===void 0||ee.attribute!==ve||ve&&ee.data!==ve.data)return!0;W++}return s.attributesNum!==W||s.index!==C}o(f,"needsUpdate");function g(D,F,V,C){let q={},Y=F.attributes,W=0,ne=V.getAttributes();for(let X in ne)if(ne[X].location>=0){let ee=Y[X];ee===void 0&&(X==="instanceMatrix"&&D.instanceMatrix&&(ee=D.instanceMatrix),X==="instanceColor"&&D.instanceColor&&(ee=D.instanceColor));let ve={};ve.attribute=ee,ee&&ee.data&&(ve.data=ee.data),q[X]=ve,W++}s.attributes=q,s.attributesNum=W,s.index=C}o(g,"saveCache");function y(){let D=s.newAttributes;for(let F=0,V=D.length;F<V;F++)D[F]=0}o(y,"initAttributes");function m(D){b(D,0)}o(m,"enableAttribute");function b(D,F){let V=s.newAttributes,C=s.enabledAttributes,q=s.attributeDivisors;V[D]=1,C[D]===0&&(i.enableVertexAttribArray(D),C[D]=1),q[D]!==F&&(i.vertexAttribDivisor(D,F),q[D]=F)}o(b,"enableAttributeAndDivisor");function w(){let D=s.newAttributes,F=s.enabledAttributes;for(let V=0,C=F.length;V<C;V++)F[V]!==D[V]&&(i.disableVertexAttribArray(V),F[V]=0)}o(w,"disableUnusedAttributes");function T(D,F,V,C,q,Y,W){W===!0?i.vertexAttribIPointer(D,F,V,q,Y):i.vertexAttribPointer(D,F,V,C,q,Y)}o(T,"vertexAttribPointer");function x(D,F,V,C){y();let q=C.attributes,Y=V.getAttributes(),W=F.defaultAttributeValues;for(let ne in Y){let X=Y[ne];if(X.location>=0){let Q=q[ne];if(Q===void 0&&(ne==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ne==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ee=Q.normalized,ve=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let z=fe.buffer,te=fe.type,xe=fe.bytesPerElement,Ee=te===i.INT||te===i.UNSIGNED_INT||Q.gpuType===oa;if(Q.isInterleavedBufferAttribute){let me=Q.data,De=me.isInterleavedBuffer===!0?me.stride:me.itemSize,nt=Q.offset;if(me.isInstancedInterleavedBuffer||me.isInstancedBufferAttribute){for(let Re=0;Re<X.locationSize;Re++)b(X.location+Re,me.meshPerAttribute);D.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=me.meshPerAttribute*me.count)}else for(let Re=0;Re<X.locationSize;Re++)m(X.location+Re);i.bindBuffer(i.ARRAY_BUFFER,z);for(let Re=0;Re<X.locationSize;Re++)T(X.location+Re,ve/X.locationSize,te,ee,De*xe,(nt+ve/X.locationSize*Re)*xe,Ee)}else{if(Q.isInstancedBufferAttribute){for(let me=0;me<X.locationSize;me++)b(X.location+me,Q.meshPerAttribute);D.isInstancedMesh!==!0&&C._maxInstanceCount===void 0&&(C._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let me=0;me<X.locationSize;me++)m(X.location+me);i.bindBuffer(i.ARRAY_BUFFER,z);for(let me=0;me<X.locationSize;me++)T(X.location+me,ve/X.locationSize,te,ee,ve*xe,ve/X.locationSize*me*xe,Ee)}}else if(W!==void 0){let ee=W[ne];if(ee!==void 0)switch(ee.length){case 2:i.vertexAttrib2fv(X.location,ee);break;case 3:i.vertexAttrib3fv(X.location,ee);break;case 4:i.vertexAttrib4fv(X.location,ee);break;default:i.vertexAttrib1fv(X.location,ee)}}}}w()}o(x,"setupVertexAttributes");function S(){U();for(let D in n){let F=n[D];for(let V in F){let C=F[V];for(let q in C){let Y=C[q];for(let W in Y)u(Y[W].object),delete Y[W];delete C[q]}}delete n[D]}}o(S,"dispose");function E(D){if(n[D.id]===void 0)return;let F=n[D.id];for(let V in F){let C=F[V];for(let q in C){let Y=C[q];for(let W in Y)u(Y[W].object),delete Y[W];delete C[q]}}delete n[D.id]}o(E,"releaseStatesOfGeometry");function _(D){for(let F in n){let V=n[F];for(let C in V){let q=V[C];if(q[D.id]===void 0)continue;let Y=q[D.id];for(let W in Y)u(Y[W].object),delete Y[W];delete q[D.id]}}}o(_,"releaseStatesOfProgram");function A(D){for(let F in n){let V=n[F],C=D.isInstancedMesh===!0?D.id:0,q=V[C];if(q!==void 0){for(let Y in q){let W=q[Y];for(let ne in W)u(W[ne].object),delete W[ne];delete q[Y]}delete V[C],Object.keys(V).length===0&&delete n[F]}}}o(A,"releaseStatesOfObject");function U(){I(),a=!0,s!==r&&(s=r,h(s.object))}o(U,"reset");function I(){r.geometry=null,r.program=null,r.wireframe=!1}return o(I,"resetDefaultState"),{setup:c,reset:U,resetDefaultState:I,dispose:S,releaseStatesOfGeometry:E,releaseStatesOfObject:A,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:m,disableUnusedAttributes:w}}o(Cg,"WebGLBindingStates");function Pg(i,e,t){let n;function r(l){n=l}o(r,"setMode");function s(l,h){i.drawArrays(n,l,h),t.update(h,n,1)}o(s,"render");function a(l,h,u){u!==0&&(i.drawArraysInstanced(n,l,h,u),t.update(h,n,u))}o(a,"renderInstances");function c(l,h,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,h,0,u);let d=0;for(let f=0;f<u;f++)d+=h[f];t.update(d,n,1)}o(c,"renderMultiDraw"),this.setMode=r,this.render=s,this.renderInstances=a,this.renderMultiDraw=c}o(Pg,"WebGLBufferRenderer");function Ig(i,e,t,n){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}o(s,"getMaxAnisotropy");function a(_){return!(_!==gn&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}o(a,"textureFormatReadable");function c(_){let A=_===mn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Xt&&_!==pn&&!A&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}o(c,"textureTypeReadable");function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}o(l,"getMaxPrecision");let h=t.precision!==void 0?t.precision:"highp",u=l(h);u!==h&&(Pe("WebGLRenderer:",h,"not supported, using",u,"instead."),h=u);let p=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&p===!1;t.reversedDepthBuffer===!0&&p===!1&&Pe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&p===!0&&Pe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),b=i.getParameter(i.MAX_VERTEX_ATTRIBS),w=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),x=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),S=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:c,precision:h,logarithmicDepthBuffer:d,reversedDepthBuffer:p,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:b,maxVertexUniforms:w,maxVaryings:T,maxFragmentUniforms:x,maxSamples:S,samples:E}}o(Ig,"WebGLCapabilities");function Lg(i){let e=this,t=null,n=0,r=!1,s=!1,a=new hn,c=new Le,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(p,d){let f=p.length!==0||d||n!==0||r;return r=d,n=p.length,f},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(p,d){t=u(p,d,0)},this.setState=function(p,d,f){let g=p.clippingPlanes,y=p.clipIntersection,m=p.clipShadows,b=i.get(p);if(!r||g===null||g.length===0||s&&!m)s?u(null):h();else{let w=s?0:n,T=w*4,x=b.clippingState||null;l.value=x,x=u(g,d,T,f);for(let S=0;S!==T;++S)x[S]=t[S];b.clippingState=x,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=w}};function h(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}o(h,"resetGlobalState");function u(p,d,f,g){let y=p!==null?p.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let b=f+y*4,w=d.matrixWorldInverse;c.getNormalMatrix(w),(m===null||m.length<b)&&(m=new Float32Array(b));for(let T=0,x=f;T!==y;++T,x+=4)a.copy(p[T]).applyMatrix4(w,c),a.normal.toArray(m,x),m[x+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,m}o(u,"projectPlanes")}o(Lg,"WebGLClipping");var zr=class extends Ct{static{o(this,"WebGLCubeRenderTarget")}constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new bi(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new Xi(5,5,5),s=new wn({name:"CubemapFromEquirect",uniforms:Si(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Ft,blending:On});s.uniforms.tEquirect.value=t;let a=new ut(r,s),c=t.minFilter;return t.minFilter===Bn&&(t.minFilter=Nt),new Ki(1,10,this).update(e,a),t.minFilter=c,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let s=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,r);e.setRenderTarget(s)}},Lh=256,Dg=3,Ng=20,tu=256,nu=16,Ug=3,Fg=new G,Og=new qe,Xa=class i{static{o(this,"PMREMGenerator")}constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ki(1,10,null),this._boxMesh=new ut(new Xi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,s={}){let{size:a=256,position:c=Fg}=s,l=this._renderer;this._setSize(a);let h=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let p=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(Og));let m=new Ki(n,r,u);return m.position.copy(c),m.update(l,e),l.autoClear=p,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(h,t)),this._applyPMREM(h),h}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Uh(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Nh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Lh,Eh(e))}_fromTexture(e,t){e.mapping===yi||e.mapping===Zi?this._setSize(e.image.length===0?Lh:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Dh(e,!1,!1),n=Math.log2(e)-Dg;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Dh(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=e,s.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===yi||e.mapping===Zi?(this._cubemapMaterial===null&&(this._cubemapMaterial=Uh()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Nh()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Bg(),this._integrationMaterial=kg());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/nu);for(let a=0;a<=n;a++){let c=i.lodToRoughness(a,n);if(a>n-Ug)s.roughness.value=c,this._renderCube(e,a,this._integrationMaterial);else{let l=c>0?Math.log2(t)+.5*Math.log2(6/(tu*Math.pow(c,4)))+.5:0;r.roughness.value=c,r.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=zg());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(s,0,n)}};function Dh(i,e,t){return new zr(i,{minFilter:Bn,generateMipmaps:e,type:mn,colorSpace:dr,depthBuffer:t})}o(Dh,"_createRenderTarget");function Gr(i,e,t){return new wn({name:i,uniforms:e,vertexShader:Be.cube_vert,fragmentShader:t,side:Ft,blending:On,depthTest:!1,depthWrite:!1})}o(Gr,"_getMaterial");function Bg(){return Gr("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${tu}u

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
	`)}o(Bg,"_getGGXMaterial");function kg(){return Gr("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:nu}},`

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
	`)}o(kg,"_getIntegrationMaterial");function zg(){return Gr("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ng}
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
	`)}o(zg,"_getBlurMaterial");function Nh(){return Gr("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}o(Nh,"_getEquirectMaterial");function Uh(){return Gr("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}o(Uh,"_getCubemapMaterial");function Gg(i){let e=new WeakMap,t=new WeakMap,n=null;function r(d,f=!1){return d==null?null:f?a(d):s(d)}o(r,"get");function s(d){if(d&&d.isTexture){let f=d.mapping;if(f===ra||f===sa)if(e.has(d)){let g=e.get(d).texture;return c(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new zr(g.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",h),c(y.texture,d.mapping)}else return null}}return d}o(s,"getCube");function a(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===ra||f===sa,y=f===yi||f===Zi;if(g||y){let m=t.get(d),b=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==b)return n===null&&(n=new Xa(i)),m=g?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let w=d.image;return g&&w&&w.height>0||y&&w&&l(w)?(n===null&&(n=new Xa(i)),m=g?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}o(a,"getPMREM");function c(d,f){return f===ra?d.mapping=yi:f===sa&&(d.mapping=Zi),d}o(c,"mapTextureMapping");function l(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}o(l,"isCubeTextureComplete");function h(d){let f=d.target;f.removeEventListener("dispose",h);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}o(h,"onCubemapDispose");function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}o(u,"onPMREMDispose");function p(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return o(p,"dispose"),{get:r,dispose:p}}o(Gg,"WebGLEnvironments");function Vg(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return o(t,"getExtension"),{has:o(function(n){return t(n)!==null},"has"),init:o(function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},"init"),get:o(function(n){let r=t(n);return r===null&&hr("WebGLRenderer: "+n+" extension not supported."),r},"get")}}o(Vg,"WebGLExtensions");function Hg(i,e,t,n){let r={},s=new WeakMap,a=new FinalizationRegistry(g=>delete r[g]);function c(g){l(g.target)}o(c,"onGeometryDispose");function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",c),delete r[g.id],a.unregister(g);let y=s.get(g);y&&(e.remove(y),s.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}o(l,"destroyGeometry");function h(g,y){return r[y.id]!==void 0||(y.addEventListener("dispose",c),r[y.id]=new WeakRef(y),a.register(y,y.id,y),t.memory.geometries++),y}o(h,"get");function u(g){let y=g.attributes;for(let m in y)e.update(y[m],i.ARRAY_BUFFER)}o(u,"update");function p(g){let y=g.index,m=g.attributes.position,b=0;if(m===void 0)return;let w=y!==null?y.array.length:m.array.length/3-1,T=m.count>=65535?yr:xr,x=new T(Math.ceil(w/3)*6,1),S=x.array;if(y!==null){let _=y.array;b=y.version;for(let A=0,U=0;A<w;A+=3){let I=_[A+0],D=_[A+1],F=_[A+2];S[U++]=I,S[U++]=D,S[U++]=D,S[U++]=F,S[U++]=F,S[U++]=I}}else{b=m.version;for(let _=0,A=0;_<w;_+=3){let U=_+0,I=_+1,D=_+2;S[A++]=U,S[A++]=I,S[A++]=I,S[A++]=D,S[A++]=D,S[A++]=U}}x.version=b;let E=s.get(g);E&&e.remove(E),s.set(g,x)}o(p,"updateWireframeAttribute");function d(g){let y=s.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&p(g)}else p(g);return s.get(g)}o(d,"getWireframeAttribute");function f(){for(let g in r){let y=r[g].deref();y!==void 0&&l(y)}}return o(f,"dispose"),{get:h,update:u,getWireframeAttribute:d,dispose:f}}o(Hg,"WebGLGeometries");function Wg(i,e,t){let n;function r(p){n=p}o(r,"setMode");let s,a;function c(p){s=p.type,a=p.bytesPerElement}o(c,"setIndex");function l(p,d){i.drawElements(n,d,s,p*a),t.update(d,n,1)}o(l,"render");function h(p,d,f){f!==0&&(i.drawElementsInstanced(n,d,s,p*a,f),t.update(d,n,f))}o(h,"renderInstances");function u(p,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,s,p,0,f);let y=0;for(let m=0;m<f;m++)y+=d[m];t.update(y,n,1)}o(u,"renderMultiDraw"),this.setMode=r,this.setIndex=c,this.render=l,this.renderInstances=h,this.renderMultiDraw=u}o(Wg,"WebGLIndexedBufferRenderer");function qg(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,a,c){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=c*(s/3);break;case i.LINES:t.lines+=c*(s/2);break;case i.LINE_STRIP:t.lines+=c*(s-1);break;case i.LINE_LOOP:t.lines+=c*s;break;case i.POINTS:t.points+=c*s;break;default:Ie("WebGLInfo: Unknown draw mode:",a);break}}o(n,"update");function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return o(r,"reset"),{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}o(qg,"WebGLInfo");function Xg(i,e,t){let n=new WeakMap,r=new et;function s(a,c,l){let h=a.morphTargetInfluences,u=c.morphAttributes.position||c.morphAttributes.normal||c.morphAttributes.color,p=u!==void 0?u.length:0,d=n.get(c);if(d===void 0||d.count!==p){let U=function(){_.dispose(),n.delete(c),c.removeEventListener("dispose",U)};o(U,"disposeTexture"),d!==void 0&&d.texture.dispose();let f=c.morphAttributes.position!==void 0,g=c.morphAttributes.normal!==void 0,y=c.morphAttributes.color!==void 0,m=c.morphAttributes.position||[],b=c.morphAttributes.normal||[],w=c.morphAttributes.color||[],T=0;f===!0&&(T=1),g===!0&&(T=2),y===!0&&(T=3);let x=c.attributes.position.count*T,S=1;x>e.maxTextureSize&&(S=Math.ceil(x/e.maxTextureSize),x=e.maxTextureSize);let E=new Float32Array(x*S*4*p),_=new br(E,x,S,p);_.type=pn,_.needsUpdate=!0;let A=T*4;for(let I=0;I<p;I++){let D=m[I],F=b[I],V=w[I],C=x*S*4*I;for(let q=0;q<D.count;q++){let Y=q*A;f===!0&&(r.fromBufferAttribute(D,q),E[C+Y+0]=r.x,E[C+Y+1]=r.y,E[C+Y+2]=r.z,E[C+Y+3]=0),g===!0&&(r.fromBufferAttribute(F,q),E[C+Y+4]=r.x,E[C+Y+5]=r.y,E[C+Y+6]=r.z,E[C+Y+7]=0),y===!0&&(r.fromBufferAttribute(V,q),E[C+Y+8]=r.x,E[C+Y+9]=r.y,E[C+Y+10]=r.z,E[C+Y+11]=V.itemSize===4?r.w:1)}}d={count:p,texture:_,size:new Xe(x,S)},n.set(c,d),c.addEventListener("dispose",U)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let f=0;for(let y=0;y<h.length;y++)f+=h[y];let g=c.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",h)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return o(s,"update"),{update:s}}o(Xg,"WebGLMorphtargets");function Kg(i,e,t,n,r){let s=new WeakMap;function a(h){let u=r.render.frame,p=h.geometry,d=e.get(h,p);if(s.get(d)!==u&&(e.update(d),s.set(d,u)),h.isInstancedMesh&&(h.hasEventListener("dispose",l)===!1&&h.addEventListener("dispose",l),s.get(h)!==u&&(t.update(h.instanceMatrix,i.ARRAY_BUFFER),h.instanceColor!==null&&t.update(h.instanceColor,i.ARRAY_BUFFER),s.set(h,u))),h.isSkinnedMesh){let f=h.skeleton;s.get(f)!==u&&(f.update(),s.set(f,u))}return d}o(a,"update");function c(){s=new WeakMap}o(c,"dispose");function l(h){let u=h.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return o(l,"onInstancedMeshDispose"),{update:a,dispose:c}}o(Kg,"WebGLObjects");var jg={[qo]:"LINEAR_TONE_MAPPING",[Xo]:"REINHARD_TONE_MAPPING",[Ko]:"CINEON_TONE_MAPPING",[jo]:"ACES_FILMIC_TONE_MAPPING",[Jo]:"AGX_TONE_MAPPING",[$o]:"NEUTRAL_TONE_MAPPING",[Yo]:"CUSTOM_TONE_MAPPING"};function Yg(i,e,t,n,r,s){let a=new Ct(e,t,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),c=null,l=null,h=null,u=new Ut;u.setAttribute("position",new tn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new tn([0,2,0,0,2,0],2));let p=new fn({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new ut(u,p),f=new na(-1,1,1,-1,0,1),g=null,y=null,m=!1,b,w=null,T=[],x=!1;this.setSize=function(S,E){a.setSize(S,E),c!==null&&c.setSize(S,E),l!==null&&l.setSize(S,E);for(let _=0;_<T.length;_++){let A=T[_];A.setSize&&A.setSize(S,E)}},this.setEffects=function(S){T=S,x=T.length>0&&T[0].isRenderPass===!0;let E=a.width,_=a.height;T.length>0&&c===null&&(c=new Ct(E,_,{type:mn,depthBuffer:!1,stencilBuffer:!1}),l=new Ct(E,_,{type:mn,depthBuffer:!1,stencilBuffer:!1}));let A=r===!0&&T.some(U=>U.needsDepthTexture===!0);A!==(a.depthTexture!==null)&&(A===!0&&h===null&&(h=new dn(E,_),s===!0&&(h.format=kn,h.type=vi)),a.dispose(),a.depthTexture=A?h:null,a.resolveDepthBuffer=A,a.storeMultisampledDepthBuffer=A);for(let U=0;U<T.length;U++){let I=T[U];I.setSize&&I.setSize(E,_),A&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(h)}},this.begin=function(S,E){if(m||S.toneMapping===En&&T.length===0)return!1;if(w=E,E!==null){let _=E.width,A=E.height;(a.width!==_||a.height!==A)&&this.setSize(_,A)}return x===!1&&S.setRenderTarget(a),b=S.toneMapping,S.toneMapping=En,!0},this.hasRenderPass=function(){return x},this.end=function(S,E){S.toneMapping=b,m=!0;let _=a,A=c;for(let U=0;U<T.length;U++){let I=T[U];I.enabled!==!1&&(I.render(S,A,_,E),I.needsSwap!==!1&&(_=A,A=A===c?l:c))}if(g!==S.outputColorSpace||y!==S.toneMapping){g=S.outputColorSpace,y=S.toneMapping,p.defines={},Ve.getTransfer(g)===Ye&&(p.defines.SRGB_TRANSFER="");let U=jg[y];U&&(p.defines[U]=""),p.needsUpdate=!0}p.uniforms.tDiffuse.value=_.texture,S.setRenderTarget(w),S.render(d,f),w=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),c!==null&&c.dispose(),l!==null&&l.dispose(),u.dispose(),p.dispose()}}o(Yg,"WebGLOutput");var iu=new Rt,ru=new dn(1,1),su=new Sr(1),au=new br,ou=new ks,cu=new bi,Fh=[],Oh=[],Bh=new Float32Array(16),kh=new Float32Array(9),zh=new Float32Array(4);function tr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,s=Fh[r];if(s===void 0&&(s=new Float32Array(r),Fh[r]=s),e!==0){n.toArray(s,0);for(let a=1,c=0;a!==e;++a)c+=t,i[a].toArray(s,c)}return s}o(tr,"flatten");function pt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}o(pt,"arraysEqual");function mt(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}o(mt,"copyArray");function ja(i,e){let t=Oh[e];t===void 0&&(t=new Int32Array(e),Oh[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}o(ja,"allocTexUnits");function Jg(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}o(Jg,"setValueV1f");function $g(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pt(t,e))return;i.uniform2fv(this.addr,e),mt(t,e)}}o($g,"setValueV2f");function Zg(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(pt(t,e))return;i.uniform3fv(this.addr,e),mt(t,e)}}o(Zg,"setValueV3f");function Qg(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pt(t,e))return;i.uniform4fv(this.addr,e),mt(t,e)}}o(Qg,"setValueV4f");function eb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),mt(t,e)}else{if(pt(t,n))return;zh.set(n),i.uniformMatrix2fv(this.addr,!1,zh),mt(t,n)}}o(eb,"setValueM2");function tb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),mt(t,e)}else{if(pt(t,n))return;kh.set(n),i.uniformMatrix3fv(this.addr,!1,kh),mt(t,n)}}o(tb,"setValueM3");function nb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),mt(t,e)}else{if(pt(t,n))return;Bh.set(n),i.uniformMatrix4fv(this.addr,!1,Bh),mt(t,n)}}o(nb,"setValueM4");function ib(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}o(ib,"setValueV1i");function rb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pt(t,e))return;i.uniform2iv(this.addr,e),mt(t,e)}}o(rb,"setValueV2i");function sb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pt(t,e))return;i.uniform3iv(this.addr,e),mt(t,e)}}o(sb,"setValueV3i");function ab(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pt(t,e))return;i.uniform4iv(this.addr,e),mt(t,e)}}o(ab,"setValueV4i");function ob(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}o(ob,"setValueV1ui");function cb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pt(t,e))return;i.uniform2uiv(this.addr,e),mt(t,e)}}o(cb,"setValueV2ui");function lb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pt(t,e))return;i.uniform3uiv(this.addr,e),mt(t,e)}}o(lb,"setValueV3ui");function hb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pt(t,e))return;i.uniform4uiv(this.addr,e),mt(t,e)}}o(hb,"setValueV4ui");function Ya(i){return i.version===0&&(i.compareFunction=lc,i.needsUpdate=!0),i}o(Ya,"initShadowTexture");function ub(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=Ya(ru):s=iu,t.setTexture2D(e||s,r)}o(ub,"setValueT1");function db(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||ou,r)}o(db,"setValueT3D1");function fb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=Ya(su):s=cu,t.setTextureCube(e||s,r)}o(fb,"setValueT6");function pb(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||au,r)}o(pb,"setValueT2DArray1");function mb(i){switch(i){case 5126:return Jg;case 35664:return $g;case 35665:return Zg;case 35666:return Qg;case 35674:return eb;case 35675:return tb;case 35676:return nb;case 5124:case 35670:return ib;case 35667:case 35671:return rb;case 35668:case 35672:return sb;case 35669:case 35673:return ab;case 5125:return ob;case 36294:return cb;case 36295:return lb;case 36296:return hb;case 35678:case 36198:case 36298:case 36306:case 35682:return ub;case 35679:case 36299:case 36307:return db;case 35680:case 36300:case 36308:case 36293:return fb;case 36289:case 36303:case 36311:case 36292:return pb}}o(mb,"getSingularSetter");function gb(i,e){i.uniform1fv(this.addr,e)}o(gb,"setValueV1fArray");function bb(i,e){let t=tr(e,this.size,2);i.uniform2fv(this.addr,t)}o(bb,"setValueV2fArray");function _b(i,e){let t=tr(e,this.size,3);i.uniform3fv(this.addr,t)}o(_b,"setValueV3fArray");function xb(i,e){let t=tr(e,this.size,4);i.uniform4fv(this.addr,t)}o(xb,"setValueV4fArray");function yb(i,e){let t=tr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}o(yb,"setValueM2Array");function vb(i,e){let t=tr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}o(vb,"setValueM3Array");function Sb(i,e){let t=tr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}o(Sb,"setValueM4Array");function Mb(i,e){i.uniform1iv(this.addr,e)}o(Mb,"setValueV1iArray");function wb(i,e){i.uniform2iv(this.addr,e)}o(wb,"setValueV2iArray");function Eb(i,e){i.uniform3iv(this.addr,e)}o(Eb,"setValueV3iArray");function Ab(i,e){i.uniform4iv(this.addr,e)}o(Ab,"setValueV4iArray");function Tb(i,e){i.uniform1uiv(this.addr,e)}o(Tb,"setValueV1uiArray");function Rb(i,e){i.uniform2uiv(this.addr,e)}o(Rb,"setValueV2uiArray");function Cb(i,e){i.uniform3uiv(this.addr,e)}o(Cb,"setValueV3uiArray");function Pb(i,e){i.uniform4uiv(this.addr,e)}o(Pb,"setValueV4uiArray");function Ib(i,e,t){let n=this.cache,r=e.length,s=ja(t,r);pt(n,s)||(i.uniform1iv(this.addr,s),mt(n,s));let a;this.type===i.SAMPLER_2D_SHADOW?a=Ya(ru):a=iu;for(let c=0;c!==r;++c)t.setTexture2D(e[c]||a,s[c])}o(Ib,"setValueT1Array");function Lb(i,e,t){let n=this.cache,r=e.length,s=ja(t,r);pt(n,s)||(i.uniform1iv(this.addr,s),mt(n,s));for(let a=0;a!==r;++a)t.setTexture3D(e[a]||ou,s[a])}o(Lb,"setValueT3DArray");function Db(i,e,t){let n=this.cache,r=e.length,s=ja(t,r);pt(n,s)||(i.uniform1iv(this.addr,s),mt(n,s));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=Ya(su):a=cu;for(let c=0;c!==r;++c)t.setTextureCube(e[c]||a,s[c])}o(Db,"setValueT6Array");function Nb(i,e,t){let n=this.cache,r=e.length,s=ja(t,r);pt(n,s)||(i.uniform1iv(this.addr,s),mt(n,s));for(let a=0;a!==r;++a)t.setTexture2DArray(e[a]||au,s[a])}o(Nb,"setValueT2DArrayArray");function Ub(i){switch(i){case 5126:return gb;case 35664:return bb;case 35665:return _b;case 35666:return xb;case 35674:return yb;case 35675:return vb;case 35676:return Sb;case 5124:case 35670:return Mb;case 35667:case 35671:return wb;case 35668:case 35672:return Eb;case 35669:case 35673:return Ab;case 5125:return Tb;case 36294:return Rb;case 36295:return Cb;case 36296:return Pb;case 35678:case 36198:case 36298:case 36306:case 35682:return Ib;case 35679:case 36299:case 36307:return Lb;case 35680:case 36300:case 36308:case 36293:return Db;case 36289:case 36303:case 36311:case 36292:return Nb}}o(Ub,"getPureArraySetter");var gc=class{static{o(this,"SingleUniform")}constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=mb(t.type)}},bc=class{static{o(this,"PureArrayUniform")}constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Ub(t.type)}},_c=class{static{o(this,"StructuredUniform")}constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let s=0,a=r.length;s!==a;++s){let c=r[s];c.setValue(e,t[c.id],n)}}},pc=/(\w+)(\])?(\[|\.)?/g;function Gh(i,e){i.seq.push(e),i.map[e.id]=e}o(Gh,"addUniform");function Fb(i,e,t){let n=i.name,r=n.length;for(pc.lastIndex=0;;){let s=pc.exec(n),a=pc.lastIndex,c=s[1],l=s[2]==="]",h=s[3];if(l&&(c=c|0),h===void 0||h==="["&&a+2===r){Gh(t,h===void 0?new gc(c,i,e):new bc(c,i,e));break}else{let p=t.map[c];p===void 0&&(p=new _c(c),Gh(t,p)),t=p}}}o(Fb,"parseUniform");var er=class{static{o(this,"WebGLUniforms")}constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let c=e.getActiveUniform(t,a),l=e.getUniformLocation(t,c.name);Fb(c,l,this)}let r=[],s=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(a):s.push(a);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,n,r){let s=this.map[t];s!==void 0&&s.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let s=0,a=t.length;s!==a;++s){let c=t[s],l=n[c.id];l.needsUpdate!==!1&&c.setValue(e,l.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,s=e.length;r!==s;++r){let a=e[r];a.id in t&&n.push(a)}return n}};function Vh(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}o(Vh,"WebGLShader");var Ob=37297,Bb=0;function kb(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let a=r;a<s;a++){let c=a+1;n.push(`${c===e?">":" "} ${c}: ${t[a]}`)}return n.join(`
`)}o(kb,"handleSource");var Hh=new Le;function zb(i){Ve._getMatrix(Hh,Ve.workingColorSpace,i);let e=`mat3( ${Hh.elements.map(t=>t.toFixed(4))} )`;switch(Ve.getTransfer(i)){case fr:return[e,"LinearTransferOETF"];case Ye:return[e,"sRGBTransferOETF"];default:return Pe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}o(zb,"getEncodingComponents");function Wh(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),s=(i.getShaderInfoLog(e)||"").trim();if(n&&s==="")return"";let a=/ERROR: 0:(\d+)/.exec(s);if(a){let c=parseInt(a[1]);return t.toUpperCase()+`

`+s+`

`+kb(i.getShaderSource(e),c)}else return s}o(Wh,"getShaderErrors");function Gb(i,e){let t=zb(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}o(Gb,"getTexelEncodingFunction");var Vb={[qo]:"Linear",[Xo]:"Reinhard",[Ko]:"Cineon",[jo]:"ACESFilmic",[Jo]:"AgX",[$o]:"Neutral",[Yo]:"Custom"};function Hb(i,e){let t=Vb[e];return t===void 0?(Pe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}o(Hb,"getToneMappingFunction");var qa=new G;function Wb(){Ve.getLuminanceCoefficients(qa);let i=qa.x.toFixed(4),e=qa.y.toFixed(4),t=qa.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}o(Wb,"getLuminanceFunction");function qb(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(kr).join(`
`)}o(qb,"generateVertexExtensions");function Xb(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}o(Xb,"generateDefines");function Kb(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(e,r),a=s.name,c=1;s.type===i.FLOAT_MAT2&&(c=2),s.type===i.FLOAT_MAT3&&(c=3),s.type===i.FLOAT_MAT4&&(c=4),t[a]={type:s.type,location:i.getAttribLocation(e,a),locationSize:c}}return t}o(Kb,"fetchAttributeLocations");function kr(i){return i!==""}o(kr,"filterEmptyLine");function qh(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}o(qh,"replaceLightNums");function Xh(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}o(Xh,"replaceClippingPlaneNums");var jb=/^[ \t]*#include +<([\w\d./]+)>/gm;function xc(i){return i.replace(jb,Yb)}o(xc,"resolveIncludes");function Yb(i,e){let t=Be[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return xc(t)}o(Yb,"includeReplacer");var Jb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Kh(i){return i.replace(Jb,$b)}o(Kh,"unrollLoops");function $b(i,e,t,n){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}o($b,"loopReplacer");function jh(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}o(jh,"generatePrecision");var Zb={[Rr]:"SHADOWMAP_TYPE_PCF",[ji]:"SHADOWMAP_TYPE_VSM"};function Qb(i){return Zb[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}o(Qb,"generateShadowMapTypeDefine");var e0={[Zi]:"ENVMAP_MODE_REFRACTION"};function t0(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":e0[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}o(t0,"generateEnvMapModeDefine");var n0={[Wo]:"ENVMAP_BLENDING_MULTIPLY",[lh]:"ENVMAP_BLENDING_MIX",[hh]:"ENVMAP_BLENDING_ADD"};function i0(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":n0[i.combine]||"ENVMAP_BLENDING_NONE"}o(i0,"generateEnvMapBlendingDefine");function r0(i,e,t,n){let r=i.getContext(),s=t.defines,a=t.vertexShader,c=t.fragmentShader,l=Qb(t),h=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=t0(t),p=i0(t),d=qb(t),f=Xb(s),g=r.createProgram(),y,m,b=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(kr).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(kr).join(`
`),m.length>0&&(m+=`
`)):(y=[jh(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(kr).join(`
`),m=[jh(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMap?"#define "+p:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==En?"#define TONE_MAPPING":"",t.toneMapping!==En?Be.tonemapping_pars_fragment:"",t.toneMapping!==En?Hb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Be.colorspace_pars_fragment,Gb("linearToOutputTexel",t.outputColorSpace),Wb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(kr).join(`
`)),a=xc(a),a=qh(a,t),a=Xh(a,t),c=xc(c),c=qh(c,t),c=Xh(c,t),a=Kh(a),c=Kh(c),t.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",t.glslVersion===Gn?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Gn?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let w=b+y+a,T=b+m+c,x=Vh(r,r.VERTEX_SHADER,w),S=Vh(r,r.FRAGMENT_SHADER,T);r.attachShader(g,x),r.attachShader(g,S),t.index0AttributeName!==void 0?r.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(g,0,"position"),r.linkProgram(g);function E(I){if(i.debug.checkShaderErrors){let D=r.getProgramInfoLog(g)||"",F=r.getShaderInfoLog(x)||"",V=r.getShaderInfoLog(S)||"",C=D.trim(),q=F.trim(),Y=V.trim(),W=!0,ne=!0;if(r.getProgramParameter(g,r.LINK_STATUS)===!1)if(W=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,g,x,S);else{let X=Wh(r,x,"vertex"),Q=Wh(r,S,"fragment");Ie("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(g,r.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+C+`
`+X+`
`+Q)}else C!==""?Pe("WebGLProgram: Program Info Log:",C):(q===""||Y==="")&&(ne=!1);ne&&(I.diagnostics={runnable:W,programLog:C,vertexShader:{log:q,prefix:y},fragmentShader:{log:Y,prefix:m}})}r.deleteShader(x),r.deleteShader(S),_=new er(r,g),A=Kb(r,g)}o(E,"onFirstUse");let _;this.getUniforms=function(){return _===void 0&&E(this),_};let A;this.getAttributes=function(){return A===void 0&&E(this),A};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=r.getProgramParameter(g,Ob)),U},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Bb++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=x,this.fragmentShader=S,this}o(r0,"WebGLProgram");var s0=0,yc=class{static{o(this,"WebGLShaderCache")}constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new vc(e),t.set(e,n)),n}},vc=class{static{o(this,"WebGLShaderStage")}constructor(e){this.id=s0++,this.code=e,this.usedTimes=0}};function a0(i){return i===si||i===Ur||i===Fr}o(a0,"isPackedRGFormat");function o0(i,e,t,n,r,s){let a=new _r,c=new yc,l=new Set,h=[],u=new Map,p=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}o(f,"getChannel");function g(_,A,U,I,D,F){let V=I.fog,C=D.geometry,q=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?I.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,W=e.get(_.envMap||q,Y),ne=d[_.type],X=n.precision;_.precision!==null&&(X=n.getMaxPrecision(_.precision),X!==_.precision&&Pe("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let Q=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,ee=Q!==void 0?Q.length:0,ve=0;C.morphAttributes.position!==void 0&&(ve=1),C.morphAttributes.normal!==void 0&&(ve=2),C.morphAttributes.color!==void 0&&(ve=3);let fe,z,te,xe;if(ne){let ge=Tn[ne];fe=ge.vertexShader,z=ge.fragmentShader}else{fe=_.vertexShader,z=_.fragmentShader;let ge=c.getVertexShaderStage(_),$e=c.getFragmentShaderStage(_);c.update(_,ge,$e),te=ge.id,xe=$e.id}let Ee=i.getRenderTarget(),me=i.state.buffers.depth.getReversed(),De=D.isInstancedMesh===!0,nt=D.isBatchedMesh===!0,Re=!!_.map,Je=!!_.matcap,Ze=!!W,ke=Ze&&W.isPMREMTexture===!0,vt=!!_.aoMap,dt=!!_.lightMap,Ot=!!_.bumpMap&&_.wireframe===!1,ot=!!_.normalMap,_n=!!_.displacementMap,gt=!!_.emissiveMap,Yt=!!_.metalnessMap,Jt=!!_.roughnessMap,$t=_.anisotropy>0,N=_.clearcoat>0,Zt=_.diffuseRoughness>0,rt=_.dispersion>0,st=_.retroreflectivity>0,pe=_.iridescence>0,ft=_.sheen>0,Ce=_.transmission>0,Ne=$t&&!!_.anisotropyMap,R=N&&!!_.clearcoatMap,v=N&&!!_.clearcoatNormalMap,B=N&&!!_.clearcoatRoughnessMap,ie=Zt&&!!_.diffuseRoughnessMap,Z=pe&&!!_.iridescenceMap,ae=pe&&!!_.iridescenceThicknessMap,ue=ft&&!!_.sheenColorMap,j=ft&&!!_.sheenRoughnessMap,J=!!_.specularMap,ce=!!_.specularColorMap,P=!!_.specularIntensityMap,$=Ce&&!!_.transmissionMap,K=Ce&&!!_.thicknessMap,le=!!_.gradientMap,se=!!_.alphaMap,oe=_.alphaTest>0,Ae=!!_.alphaHash,Oe=!!_.extensions,re=En;_.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(re=i.toneMapping);let Te=ke?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,Fe={shaderID:ne,shaderType:_.type,shaderName:_.name,vertexShader:fe,fragmentShader:z,defines:_.defines,customVertexShaderID:te,customFragmentShaderID:xe,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:nt,batchingColor:nt&&D._colorsTexture!==null,instancing:De,instancingColor:De&&D.instanceColor!==null,instancingMorph:De&&D.morphTexture!==null,outputColorSpace:Ee===null?i.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:Ve.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Re,matcap:Je,envMap:Ze,envMapMode:Ze&&W.mapping,envMapPMREM:ke,envMapMaxLod:ke?Te.length-1:null,envMapSize:ke?Te[0].width:null,aoMap:vt,lightMap:dt,bumpMap:Ot,normalMap:ot,displacementMap:_n,emissiveMap:gt,normalMapObjectSpace:ot&&_.normalMapType===fh,normalMapTangentSpace:ot&&_.normalMapType===ac,packedNormalMap:ot&&_.normalMapType===ac&&a0(_.normalMap.format),metalnessMap:Yt,roughnessMap:Jt,anisotropy:$t,anisotropyMap:Ne,clearcoat:N,clearcoatMap:R,clearcoatNormalMap:v,clearcoatRoughnessMap:B,diffuseRoughness:Zt,diffuseRoughnessMap:ie,dispersion:rt,retroreflection:st,iridescence:pe,iridescenceMap:Z,iridescenceThicknessMap:ae,sheen:ft,sheenColorMap:ue,sheenRoughnessMap:j,specularMap:J,specularColorMap:ce,specularIntensityMap:P,transmission:Ce,transmissionMap:$,thicknessMap:K,gradientMap:le,opaque:_.transparent===!1&&_.blending===Yi&&_.alphaToCoverage===!1,alphaMap:se,alphaTest:oe,alphaHash:Ae,combine:_.combine,mapUv:Re&&f(_.map.channel),aoMapUv:vt&&f(_.aoMap.channel),lightMapUv:dt&&f(_.lightMap.channel),bumpMapUv:Ot&&f(_.bumpMap.channel),normalMapUv:ot&&f(_.normalMap.channel),displacementMapUv:_n&&f(_.displacementMap.channel),emissiveMapUv:gt&&f(_.emissiveMap.channel),metalnessMapUv:Yt&&f(_.metalnessMap.channel),roughnessMapUv:Jt&&f(_.roughnessMap.channel),anisotropyMapUv:Ne&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:v&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ie&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:Z&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ue&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:j&&f(_.sheenRoughnessMap.channel),specularMapUv:J&&f(_.specularMap.channel),specularColorMapUv:ce&&f(_.specularColorMap.channel),specularIntensityMapUv:P&&f(_.specularIntensityMap.channel),transmissionMapUv:$&&f(_.transmissionMap.channel),thicknessMapUv:K&&f(_.thicknessMap.channel),alphaMapUv:se&&f(_.alphaMap.channel),vertexTangents:!!C.attributes.tangent&&(ot||$t),vertexNormals:!!C.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!C.attributes.uv&&(Re||se),fog:!!V,useFog:_.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||C.attributes.normal===void 0&&ot===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:p,reversedDepthBuffer:me,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:C.attributes.position!==void 0,morphTargets:C.morphAttributes.position!==void 0,morphNormals:C.morphAttributes.normal!==void 0,morphColors:C.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:ve,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:F.filter(ge=>ge.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:re,decodeVideoTexture:Re&&_.map.isVideoTexture===!0&&Ve.getTransfer(_.map.colorSpace)===Ye,decodeVideoTextureEmissive:gt&&_.emissiveMap.isVideoTexture===!0&&Ve.getTransfer(_.emissiveMap.colorSpace)===Ye,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===rn,flipSided:_.side===Ft,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Oe&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Oe&&_.extensions.multiDraw===!0||nt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Fe.vertexUv1s=l.has(1),Fe.vertexUv2s=l.has(2),Fe.vertexUv3s=l.has(3),l.clear(),Fe}o(g,"getParameters");function y(_){let A=[];if(_.shaderID?A.push(_.shaderID):(A.push(_.customVertexShaderID),A.push(_.customFragmentShaderID)),_.defines!==void 0)for(let U in _.defines)A.push(U),A.push(_.defines[U]);return _.isRawShaderMaterial===!1&&(m(A,_),b(A,_),A.push(i.outputColorSpace)),A.push(_.customProgramCacheKey),A.join()}o(y,"getProgramCacheKey");function m(_,A){_.push(A.precision),_.push(A.outputColorSpace),_.push(A.envMapMode),_.push(A.envMapPMREM),_.push(A.envMapMaxLod),_.push(A.envMapSize),_.push(A.mapUv),_.push(A.alphaMapUv),_.push(A.lightMapUv),_.push(A.aoMapUv),_.push(A.bumpMapUv),_.push(A.normalMapUv),_.push(A.displacementMapUv),_.push(A.emissiveMapUv),_.push(A.metalnessMapUv),_.push(A.roughnessMapUv),_.push(A.anisotropyMapUv),_.push(A.clearcoatMapUv),_.push(A.clearcoatNormalMapUv),_.push(A.clearcoatRoughnessMapUv),_.push(A.diffuseRoughnessMapUv),_.push(A.iridescenceMapUv),_.push(A.iridescenceThicknessMapUv),_.push(A.sheenColorMapUv),_.push(A.sheenRoughnessMapUv),_.push(A.specularMapUv),_.push(A.specularColorMapUv),_.push(A.specularIntensityMapUv),_.push(A.transmissionMapUv),_.push(A.thicknessMapUv),_.push(A.combine),_.push(A.fogExp2),_.push(A.sizeAttenuation),_.push(A.morphTargetsCount),_.push(A.numSunLights),_.push(A.numDirLights),_.push(A.numPointLights),_.push(A.numSpotLights),_.push(A.numSpotLightMaps),_.push(A.numHemiLights),_.push(A.numRectAreaLights),_.push(A.numSunLightShadows),_.push(A.numDirLightShadows),_.push(A.numPointLightShadows),_.push(A.numSpotLightShadows),_.push(A.numSpotLightShadowsWithMaps),_.push(A.numLightProbes),_.push(A.numLightProbeGrids),_.push(A.shadowMapType),_.push(A.toneMapping),_.push(A.numClippingPlanes),_.push(A.numClipIntersection),_.push(A.depthPacking)}o(m,"getProgramCacheKeyParameters");function b(_,A){a.disableAll(),A.instancing&&a.enable(0),A.instancingColor&&a.enable(1),A.instancingMorph&&a.enable(2),A.matcap&&a.enable(3),A.envMap&&a.enable(4),A.normalMapObjectSpace&&a.enable(5),A.normalMapTangentSpace&&a.enable(6),A.clearcoat&&a.enable(7),A.iridescence&&a.enable(8),A.alphaTest&&a.enable(9),A.vertexColors&&a.enable(10),A.vertexAlphas&&a.enable(11),A.vertexUv1s&&a.enable(12),A.vertexUv2s&&a.enable(13),A.vertexUv3s&&a.enable(14),A.vertexTangents&&a.enable(15),A.anisotropy&&a.enable(16),A.alphaHash&&a.enable(17),A.batching&&a.enable(18),A.dispersion&&a.enable(19),A.retroreflection&&a.enable(24),A.diffuseRoughness&&a.enable(25),A.batchingColor&&a.enable(20),A.gradientMap&&a.enable(21),A.packedNormalMap&&a.enable(22),A.vertexNormals&&a.enable(23),_.push(a.mask),a.disableAll(),A.fog&&a.enable(0),A.useFog&&a.enable(1),A.flatShading&&a.enable(2),A.logarithmicDepthBuffer&&a.enable(3),A.reversedDepthBuffer&&a.enable(4),A.skinning&&a.enable(5),A.morphTargets&&a.enable(6),A.morphNormals&&a.enable(7),A.morphColors&&a.enable(8),A.premultipliedAlpha&&a.enable(9),A.shadowMapEnabled&&a.enable(10),A.doubleSided&&a.enable(11),A.flipSided&&a.enable(12),A.useDepthPacking&&a.enable(13),A.dithering&&a.enable(14),A.transmission&&a.enable(15),A.sheen&&a.enable(16),A.opaque&&a.enable(17),A.pointsUvs&&a.enable(18),A.decodeVideoTexture&&a.enable(19),A.decodeVideoTextureEmissive&&a.enable(20),A.alphaToCoverage&&a.enable(21),A.numLightProbeGrids>0&&a.enable(22),A.hasPositionAttribute&&a.enable(23),_.push(a.mask)}o(b,"getProgramCacheKeyBooleans");function w(_){let A=d[_.type],U;if(A){let I=Tn[A];U=Ch.clone(I.uniforms)}else U=_.uniforms;return U}o(w,"getUniforms");function T(_,A){let U=u.get(A);return U!==void 0?++U.usedTimes:(U=new r0(i,A,_,r),h.push(U),u.set(A,U)),U}o(T,"acquireProgram");function x(_){if(--_.usedTimes===0){let A=h.indexOf(_);h[A]=h[h.length-1],h.pop(),u.delete(_.cacheKey),_.destroy()}}o(x,"releaseProgram");function S(_){c.remove(_)}o(S,"releaseShaderCache");function E(){c.dispose()}return o(E,"dispose"),{getParameters:g,getProgramCacheKey:y,getUniforms:w,acquireProgram:T,releaseProgram:x,releaseShaderCache:S,programs:h,dispose:E}}o(o0,"WebGLPrograms");function c0(){let i=new WeakMap;function e(a){return i.has(a)}o(e,"has");function t(a){let c=i.get(a);return c===void 0&&(c={},i.set(a,c)),c}o(t,"get");function n(a){i.delete(a)}o(n,"remove");function r(a,c,l){i.get(a)[c]=l}o(r,"update");function s(){i=new WeakMap}return o(s,"dispose"),{has:e,get:t,remove:n,update:r,dispose:s}}o(c0,"WebGLProperties");function l0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}o(l0,"painterSortStable");function Yh(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}o(Yh,"reversePainterSortStable");function Jh(){let i=[],e=0,t=[],n=[],r=[];function s(){e=0,t.length=0,n.length=0,r.length=0}o(s,"init");function a(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}o(a,"materialVariant");function c(d,f,g,y,m,b){let w=i[e];return w===void 0?(w={id:d.id,object:d,geometry:f,material:g,materialVariant:a(d),groupOrder:y,renderOrder:d.renderOrder,z:m,group:b},i[e]=w):(w.id=d.id,w.object=d,w.geometry=f,w.material=g,w.materialVariant=a(d),w.groupOrder=y,w.renderOrder=d.renderOrder,w.z=m,w.group=b),e++,w}o(c,"getNextRenderItem");function l(d,f,g,y,m,b,w){w.reversedDepth===!0&&(m=-m);let T=c(d,f,g,y,m,b);g.transmission>0?n.push(T):g.transparent===!0?r.push(T):t.push(T)}o(l,"push");function h(d,f,g,y,m,b){let w=c(d,f,g,y,m,b);g.transmission>0?n.unshift(w):g.transparent===!0?r.unshift(w):t.unshift(w)}o(h,"unshift");function u(d,f){t.length>1&&t.sort(d||l0),n.length>1&&n.sort(f||Yh),r.length>1&&r.sort(f||Yh)}o(u,"sort");function p(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return o(p,"finish"),{opaque:t,transmissive:n,transparent:r,init:s,push:l,unshift:h,finish:p,sort:u}}o(Jh,"WebGLRenderList");function h0(){let i=new WeakMap;function e(n,r){let s=i.get(n),a;return s===void 0?(a=new Jh,i.set(n,[a])):r>=s.length?(a=new Jh,s.push(a)):a=s[r],a}o(e,"get");function t(){i=new WeakMap}return o(t,"dispose"),{get:e,dispose:t}}o(h0,"WebGLRenderLists");function u0(){let i={};return{get:o(function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new G,color:new qe};break;case"SpotLight":t={position:new G,direction:new G,color:new qe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new G,color:new qe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new G,skyColor:new qe,groundColor:new qe};break;case"RectAreaLight":t={color:new qe,position:new G,halfWidth:new G,halfHeight:new G};break}return i[e.id]=t,t},"get")}}o(u0,"UniformsCache");function d0(){let i={};return{get:o(function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Xe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t},"get")}}o(d0,"ShadowUniformsCache");var f0=0;function p0(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}o(p0,"shadowCastingAndTexturingLightsFirst");function m0(i){let e=new u0,t=d0(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let h=0;h<9;h++)n.probe.push(new G);let r=new G,s=new at,a=new at;function c(h){let u=0,p=0,d=0;for(let F=0;F<9;F++)n.probe[F].set(0,0,0);let f=0,g=0,y=0,m=0,b=0,w=0,T=0,x=0,S=0,E=0,_=0,A=0,U=0,I=0;h.sort(p0);for(let F=0,V=h.length;F<V;F++){let C=h[F],q=C.color,Y=C.intensity,W=C.distance,ne=null;if(C.shadow&&C.shadow.map&&(C.shadow.map.texture.format===si?ne=C.shadow.map.texture:ne=C.shadow.map.depthTexture||C.shadow.map.texture),C.isAmbientLight)u+=q.r*Y,p+=q.g*Y,d+=q.b*Y;else if(C.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(C.sh.coefficients[X],Y);I++}else if(C.isSunLight){let X=e.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let Q=C.shadow,ee=t.get(C);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=ee,n.sunShadowMap[g]=ne;let ve=Q.getViewportCount();for(let fe=0;fe<ve;fe++)n.sunShadowMatrix[y+fe]=Q.getMatrix(fe),n.sunShadowCascade[y+fe]=Q._cascadeData[fe];y+=ve,g++}n.sun[f]=X,f++}else if(C.isDirectionalLight){let X=e.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let Q=C.shadow,ee=t.get(C);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,n.directionalShadow[m]=ee,n.directionalShadowMap[m]=ne,n.directionalShadowMatrix[m]=C.shadow.matrix,S++}n.directional[m]=X,m++}else if(C.isSpotLight){let X=e.get(C);X.position.setFromMatrixPosition(C.matrixWorld),X.color.copy(q).multiplyScalar(Y),X.distance=W,X.coneCos=Math.cos(C.angle),X.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),X.decay=C.decay,n.spot[w]=X;let Q=C.shadow;if(C.map&&(n.spotLightMap[A]=C.map,A++,Q.updateMatrices(C),C.castShadow&&U++),n.spotLightMatrix[w]=Q.matrix,C.castShadow){let ee=t.get(C);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,n.spotShadow[w]=ee,n.spotShadowMap[w]=ne,_++}w++}else if(C.isRectAreaLight){let X=e.get(C);X.color.copy(q).multiplyScalar(Y),X.halfWidth.set(C.width*.5,0,0),X.halfHeight.set(0,C.height*.5,0),n.rectArea[T]=X,T++}else if(C.isPointLight){let X=e.get(C);if(X.color.copy(C.color).multiplyScalar(C.intensity),X.distance=C.distance,X.decay=C.decay,C.castShadow){let Q=C.shadow,ee=t.get(C);ee.shadowIntensity=Q.intensity,ee.shadowBias=Q.bias,ee.shadowNormalBias=Q.normalBias,ee.shadowRadius=Q.radius,ee.shadowMapSize=Q.mapSize,ee.shadowCameraNear=Q.camera.near,ee.shadowCameraFar=Q.camera.far,n.pointShadow[b]=ee,n.pointShadowMap[b]=ne,n.pointShadowMatrix[b]=C.shadow.matrix,E++}n.point[b]=X,b++}else if(C.isHemisphereLight){let X=e.get(C);X.skyColor.copy(C.color).multiplyScalar(Y),X.groundColor.copy(C.groundColor).multiplyScalar(Y),n.hemi[x]=X,x++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=be.LTC_FLOAT_1,n.rectAreaLTC2=be.LTC_FLOAT_2):(n.rectAreaLTC1=be.LTC_HALF_1,n.rectAreaLTC2=be.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=p,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==b||D.spotLength!==w||D.rectAreaLength!==T||D.hemiLength!==x||D.numSunShadows!==g||D.numDirectionalShadows!==S||D.numPointShadows!==E||D.numSpotShadows!==_||D.numSpotMaps!==A||D.numLightProbes!==I)&&(n.sun.length=f,n.directional.length=m,n.spot.length=w,n.rectArea.length=T,n.point.length=b,n.hemi.length=x,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=S,n.directionalShadowMap.length=S,n.directionalShadowMatrix.length=S,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+A-U,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=I,D.sunLength=f,D.directionalLength=m,D.pointLength=b,D.spotLength=w,D.rectAreaLength=T,D.hemiLength=x,D.numSunShadows=g,D.numDirectionalShadows=S,D.numPointShadows=E,D.numSpotShadows=_,D.numSpotMaps=A,D.numLightProbes=I,n.version=f0++)}o(c,"setup");function l(h,u){let p=0,d=0,f=0,g=0,y=0,m=0,b=u.matrixWorldInverse;for(let w=0,T=h.length;w<T;w++){let x=h[w];if(x.isSunLight){let S=n.sun[p];S.direction.setFromMatrixPosition(x.matrixWorld),S.direction.transformDirection(b),p++}else if(x.isDirectionalLight){let S=n.directional[d];S.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),S.direction.sub(r),S.direction.transformDirection(b),d++}else if(x.isSpotLight){let S=n.spot[g];S.position.setFromMatrixPosition(x.matrixWorld),S.position.applyMatrix4(b),S.direction.setFromMatrixPosition(x.matrixWorld),r.setFromMatrixPosition(x.target.matrixWorld),S.direction.sub(r),S.direction.transformDirection(b),g++}else if(x.isRectAreaLight){let S=n.rectArea[y];S.position.setFromMatrixPosition(x.matrixWorld),S.position.applyMatrix4(b),a.identity(),s.copy(x.matrixWorld),s.premultiply(b),a.extractRotation(s),S.halfWidth.set(x.width*.5,0,0),S.halfHeight.set(0,x.height*.5,0),S.halfWidth.applyMatrix4(a),S.halfHeight.applyMatrix4(a),y++}else if(x.isPointLight){let S=n.point[f];S.position.setFromMatrixPosition(x.matrixWorld),S.position.applyMatrix4(b),f++}else if(x.isHemisphereLight){let S=n.hemi[m];S.direction.setFromMatrixPosition(x.matrixWorld),S.direction.transformDirection(b),m++}}}return o(l,"setupView"),{setup:c,setupView:l,state:n}}o(m0,"WebGLLights");function $h(i){let e=new m0(i),t=[],n=[],r=[];function s(p){u.camera=p,t.length=0,n.length=0,r.length=0}o(s,"init");function a(p){p.isLightProbeGrid?r.push(p):t.push(p)}o(a,"pushLight");function c(p){n.push(p)}o(c,"pushShadow");function l(){e.setup(t),r.sort((p,d)=>p.priority-d.priority||p.id-d.id)}o(l,"setupLights");function h(p){e.setupView(t,p)}o(h,"setupLightsView");let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:h,pushLight:a,pushShadow:c}}o($h,"WebGLRenderState");function g0(i){let e=new WeakMap;function t(r,s=0){let a=e.get(r),c;return a===void 0?(c=new $h(i),e.set(r,[c])):s>=a.length?(c=new $h(i),a.push(c)):c=a[s],c}o(t,"get");function n(){e=new WeakMap}return o(n,"dispose"),{get:t,dispose:n}}o(g0,"WebGLRenderStates");var b0=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,_0=`uniform sampler2D shadow_pass;
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
}`,x0=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],y0=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],Zh=new at,Br=new G,mc=new G;function v0(i,e,t){let n=new gi,r=new Xe,s=new Xe,a=new et,c=new Ws,l=new qs,h={},u=t.maxTextureSize,p={[ii]:Ft,[Ft]:ii,[rn]:rn},d=new wn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Xe},radius:{value:4}},vertexShader:b0,fragmentShader:_0}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Ut;g.setAttribute("position",new Ht(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new ut(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Rr;let b=this.type;this.render=function(E,_,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Xl&&(Pe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Rr);let U=i.getRenderTarget(),I=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),F=i.state;F.setBlending(On),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let V=b!==this.type;V&&_.traverse(function(C){C.material&&(Array.isArray(C.material)?C.material.forEach(q=>q.needsUpdate=!0):C.material.needsUpdate=!0)});for(let C=0,q=E.length;C<q;C++){let Y=E[C],W=Y.shadow;if(W===void 0){Pe("WebGLShadowMap:",Y,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;r.copy(W.mapSize);let ne=W.getFrameExtents();r.multiply(ne),s.copy(W.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/ne.x),r.x=s.x*ne.x,W.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/ne.y),r.y=s.y*ne.y,W.mapSize.y=s.y));let X=i.state.buffers.depth.getReversed();if(W.camera._reversedDepth=X,W.map===null||V===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===ji){if(Y.isPointLight){Pe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new Ct(r.x,r.y,{format:si,type:mn,minFilter:Nt,magFilter:Nt,generateMipmaps:!1}),W.map.texture.name=Y.name+".shadowMap",W.map.depthTexture=new dn(r.x,r.y,pn),W.map.depthTexture.name=Y.name+".shadowMapDepth",W.map.depthTexture.format=Fn,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=yt,W.map.depthTexture.magFilter=yt}else Y.isPointLight?(W.map=new zr(r.x),W.map.depthTexture=new Sr(r.x,Kt)):(W.map=new Ct(r.x,r.y),W.map.depthTexture=new dn(r.x,r.y,Kt)),W.map.depthTexture.name=Y.name+".shadowMap",W.map.depthTexture.format=Fn,this.type===Rr?(W.map.depthTexture.compareFunction=X?cc:oc,W.map.depthTexture.minFilter=Nt,W.map.depthTexture.magFilter=Nt):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=yt,W.map.depthTexture.magFilter=yt);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==r.x||W.map.height!==r.y)&&W.map.setSize(r.x,r.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Y.isPointLight!==!0&&W.updateMatrices(Y,A);let ee=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:A.layers;for(let ve=0;ve<Q;ve++){let fe=W.getCamera(ve);if(Y.isPointLight){let z=W.camera,te=W.matrix,xe=Y.distance||z.far;xe!==z.far&&(z.far=xe,z.updateProjectionMatrix()),Br.setFromMatrixPosition(Y.matrixWorld),z.position.copy(Br),mc.copy(z.position),mc.add(x0[ve]),z.up.copy(y0[ve]),z.lookAt(mc),z.updateMatrixWorld(),te.makeTranslation(-Br.x,-Br.y,-Br.z),Zh.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),W._frustum.setFromProjectionMatrix(Zh,z.coordinateSystem,z.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)i.setRenderTarget(W.map,ve),i.clear();else{ve===0&&(i.setRenderTarget(W.map),i.clear());let z=W.getViewport(ve);a.set(s.x*z.x,s.y*z.y,s.x*z.z,s.y*z.w),F.viewport(a)}n=W.getFrustum(ve),x(_,A,fe,Y,ee,this.type)}W.isPointLightShadow!==!0&&this.type===ji&&w(W,A),W.needsUpdate=!1}b=this.type,m.needsUpdate=!1,i.setRenderTarget(U,I,D)};function w(E,_){let A=e.update(y);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new Ct(r.x,r.y,{format:si,type:mn}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,A,d,y,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,A,f,y,null)}o(w,"VSMPass");function T(E,_,A,U){let I=null,D=A.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)I=D;else if(I=A.isPointLight===!0?l:c,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let F=I.uuid,V=_.uuid,C=h[F];C===void 0&&(C={},h[F]=C);let q=C[V];q===void 0&&(q=I.clone(),C[V]=q,_.addEventListener("dispose",S)),I=q}if(I.visible=_.visible,I.wireframe=_.wireframe,U===ji?I.side=_.shadowSide!==null?_.shadowSide:_.side:I.side=_.shadowSide!==null?_.shadowSide:p[_.side],I.alphaMap=_.alphaMap,I.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,I.map=_.map,I.clipShadows=_.clipShadows,I.clippingPlanes=_.clippingPlanes,I.clipIntersection=_.clipIntersection,I.displacementMap=_.displacementMap,I.displacementScale=_.displacementScale,I.displacementBias=_.displacementBias,I.wireframeLinewidth=_.wireframeLinewidth,I.linewidth=_.linewidth,A.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let F=i.properties.get(I);F.light=A}return I}o(T,"getDepthMaterial");function x(E,_,A,U,I,D){if(E.visible===!1)return;if(E.layers.test(I)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===ji)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,E.matrixWorld);let C=e.update(E),q=E.material;if(Array.isArray(q)){let Y=C.groups;for(let W=0,ne=Y.length;W<ne;W++){let X=Y[W],Q=q[X.materialIndex];if(Q&&Q.visible){let ee=T(E,Q,U,D);E.onBeforeShadow(i,E,_,A,C,ee,X),i.renderBufferDirect(A,null,C,ee,E,X),E.onAfterShadow(i,E,_,A,C,ee,X)}}}else if(q.visible){let Y=T(E,q,U,D);E.onBeforeShadow(i,E,_,A,C,Y,null),i.renderBufferDirect(A,null,C,Y,E,null),E.onAfterShadow(i,E,_,A,C,Y,null)}}let V=E.children;for(let C=0,q=V.length;C<q;C++)x(V[C],_,A,U,I,D)}o(x,"renderObject");function S(E){E.target.removeEventListener("dispose",S);for(let A in h){let U=h[A],I=E.target.uuid;I in U&&(U[I].dispose(),delete U[I])}}o(S,"onMaterialDispose")}o(v0,"WebGLShadowMap");function S0(i,e){function t(){let P=!1,$=new et,K=null,le=new et(0,0,0,0);return{setMask:o(function(se){K!==se&&!P&&(i.colorMask(se,se,se,se),K=se)},"setMask"),setLocked:o(function(se){P=se},"setLocked"),setClear:o(function(se,oe,Ae,Oe,re){re===!0&&(se*=Oe,oe*=Oe,Ae*=Oe),$.set(se,oe,Ae,Oe),le.equals($)===!1&&(i.clearColor(se,oe,Ae,Oe),le.copy($))},"setClear"),reset:o(function(){P=!1,K=null,le.set(-1,0,0,0)},"reset")}}o(t,"ColorBuffer");function n(){let P=!1,$=!1,K=null,le=null,se=null;return{setReversed:o(function(oe){if($!==oe){let Ae=e.get("EXT_clip_control");oe?Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.ZERO_TO_ONE_EXT):Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.NEGATIVE_ONE_TO_ONE_EXT),$=oe;let Oe=se;se=null,this.setClear(Oe)}},"setReversed"),getReversed:o(function(){return $},"getReversed"),setTest:o(function(oe){oe?me(i.DEPTH_TEST):De(i.DEPTH_TEST)},"setTest"),setMask:o(function(oe){K!==oe&&!P&&(i.depthMask(oe),K=oe)},"setMask"),setFunc:o(function(oe){if($&&(oe=wh[oe]),le!==oe){switch(oe){case As:i.depthFunc(i.NEVER);break;case Ts:i.depthFunc(i.ALWAYS);break;case Rs:i.depthFunc(i.LESS);break;case Gi:i.depthFunc(i.LEQUAL);break;case Cs:i.depthFunc(i.EQUAL);break;case Ps:i.depthFunc(i.GEQUAL);break;case Is:i.depthFunc(i.GREATER);break;case Ls:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}le=oe}},"setFunc"),setLocked:o(function(oe){P=oe},"setLocked"),setClear:o(function(oe){se!==oe&&(se=oe,$&&(oe=1-oe),i.clearDepth(oe))},"setClear"),reset:o(function(){P=!1,K=null,le=null,se=null,$=!1},"reset")}}o(n,"DepthBuffer");function r(){let P=!1,$=null,K=null,le=null,se=null,oe=null,Ae=null,Oe=null,re=null;return{setTest:o(function(Te){P||(Te?me(i.STENCIL_TEST):De(i.STENCIL_TEST))},"setTest"),setMask:o(function(Te){$!==Te&&!P&&(i.stencilMask(Te),$=Te)},"setMask"),setFunc:o(function(Te,Fe,ge){(K!==Te||le!==Fe||se!==ge)&&(i.stencilFunc(Te,Fe,ge),K=Te,le=Fe,se=ge)},"setFunc"),setOp:o(function(Te,Fe,ge){(oe!==Te||Ae!==Fe||Oe!==ge)&&(i.stencilOp(Te,Fe,ge),oe=Te,Ae=Fe,Oe=ge)},"setOp"),setLocked:o(function(Te){P=Te},"setLocked"),setClear:o(function(Te){re!==Te&&(i.clearStencil(Te),re=Te)},"setClear"),reset:o(function(){P=!1,$=null,K=null,le=null,se=null,oe=null,Ae=null,Oe=null,re=null},"reset")}}o(r,"StencilBuffer");let s=new t,a=new n,c=new r,l={},h=new WeakMap,u={},p={},d={},f=new WeakMap,g=[],y=null,m=!1,b=null,w=null,T=null,x=null,S=null,E=null,_=null,A=new qe(0,0,0),U=0,I=!1,D=null,F=null,V=null,C=null,q=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ne=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(ne=parseFloat(/^WebGL (\d)/.exec(X)[1]),W=ne>=1):X.indexOf("OpenGL ES")!==-1&&(ne=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),W=ne>=2);let Q=null,ee={},ve=i.getParameter(i.SCISSOR_BOX),fe=i.getParameter(i.VIEWPORT),z=new et().fromArray(ve),te=new et().fromArray(fe);function xe(P,$,K,le){let se=new Uint8Array(4),oe=i.createTexture();i.bindTexture(P,oe),i.texParameteri(P,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(P,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ae=0;Ae<K;Ae++)P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY?i.texImage3D($,0,i.RGBA,1,1,le,0,i.RGBA,i.UNSIGNED_BYTE,se):i.texImage2D($+Ae,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,se);return oe}o(xe,"createTexture");let Ee={};Ee[i.TEXTURE_2D]=xe(i.TEXTURE_2D,i.TEXTURE_2D,1),Ee[i.TEXTURE_CUBE_MAP]=xe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[i.TEXTURE_2D_ARRAY]=xe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ee[i.TEXTURE_3D]=xe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),a.setClear(1),c.setClear(0),me(i.DEPTH_TEST),a.setFunc(Gi),Ot(!1),ot(zo),me(i.CULL_FACE),vt(On);function me(P){u[P]!==!0&&(i.enable(P),u[P]=!0)}o(me,"enable");function De(P){u[P]!==!1&&(i.disable(P),u[P]=!1)}o(De,"disable");function nt(P,$){return d[P]!==$?(i.bindFramebuffer(P,$),d[P]=$,P===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=$),P===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=$),!0):!1}o(nt,"bindFramebuffer");function Re(P,$){let K=g,le=!1;if(P){K=f.get($),K===void 0&&(K=[],f.set($,K));let se=P.textures;if(K.length!==se.length||K[0]!==i.COLOR_ATTACHMENT0){for(let oe=0,Ae=se.length;oe<Ae;oe++)K[oe]=i.COLOR_ATTACHMENT0+oe;K.length=se.length,le=!0}}else K[0]!==i.BACK&&(K[0]=i.BACK,le=!0);le&&i.drawBuffers(K)}o(Re,"drawBuffers");function Je(P){return y!==P?(i.useProgram(P),y=P,!0):!1}o(Je,"useProgram");let Ze={[xi]:i.FUNC_ADD,[Kl]:i.FUNC_SUBTRACT,[jl]:i.FUNC_REVERSE_SUBTRACT};Ze[Yl]=i.MIN,Ze[Jl]=i.MAX;let ke={[$l]:i.ZERO,[$i]:i.ONE,[Zl]:i.SRC_COLOR,[Cr]:i.SRC_ALPHA,[rh]:i.SRC_ALPHA_SATURATE,[nh]:i.DST_COLOR,[eh]:i.DST_ALPHA,[Ql]:i.ONE_MINUS_SRC_COLOR,[ri]:i.ONE_MINUS_SRC_ALPHA,[ih]:i.ONE_MINUS_DST_COLOR,[th]:i.ONE_MINUS_DST_ALPHA,[sh]:i.CONSTANT_COLOR,[ah]:i.ONE_MINUS_CONSTANT_COLOR,[oh]:i.CONSTANT_ALPHA,[ch]:i.ONE_MINUS_CONSTANT_ALPHA};function vt(P,$,K,le,se,oe,Ae,Oe,re,Te){if(P===On){m===!0&&(De(i.BLEND),m=!1);return}if(m===!1&&(me(i.BLEND),m=!0),P!==Ji){if(P!==b||Te!==I){if((w!==xi||S!==xi)&&(i.blendEquation(i.FUNC_ADD),w=xi,S=xi),Te)switch(P){case Yi:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Go:i.blendFunc(i.ONE,i.ONE);break;case Vo:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ho:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ie("WebGLState: Invalid blending: ",P);break}else switch(P){case Yi:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Go:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Vo:Ie("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ho:Ie("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ie("WebGLState: Invalid blending: ",P);break}T=null,x=null,E=null,_=null,A.set(0,0,0),U=0,b=P,I=Te}return}se=se||$,oe=oe||K,Ae=Ae||le,($!==w||se!==S)&&(i.blendEquationSeparate(Ze[$],Ze[se]),w=$,S=se),(K!==T||le!==x||oe!==E||Ae!==_)&&(i.blendFuncSeparate(ke[K],ke[le],ke[oe],ke[Ae]),T=K,x=le,E=oe,_=Ae),(Oe.equals(A)===!1||re!==U)&&(i.blendColor(Oe.r,Oe.g,Oe.b,re),A.copy(Oe),U=re),b=P,I=!1}o(vt,"setBlending");function dt(P,$){P.side===rn?De(i.CULL_FACE):me(i.CULL_FACE);let K=P.side===Ft;$&&(K=!K),Ot(K),P.blending===Yi&&P.transparent===!1?vt(On):vt(P.blending,P.blendEquation,P.blendSrc,P.blendDst,P.blendEquationAlpha,P.blendSrcAlpha,P.blendDstAlpha,P.blendColor,P.blendAlpha,P.premultipliedAlpha),a.setFunc(P.depthFunc),a.setTest(P.depthTest),a.setMask(P.depthWrite),s.setMask(P.colorWrite);let le=P.stencilWrite;c.setTest(le),le&&(c.setMask(P.stencilWriteMask),c.setFunc(P.stencilFunc,P.stencilRef,P.stencilFuncMask),c.setOp(P.stencilFail,P.stencilZFail,P.stencilZPass)),gt(P.polygonOffset,P.polygonOffsetFactor,P.polygonOffsetUnits),P.alphaToCoverage===!0?me(i.SAMPLE_ALPHA_TO_COVERAGE):De(i.SAMPLE_ALPHA_TO_COVERAGE)}o(dt,"setMaterial");function Ot(P){D!==P&&(P?i.frontFace(i.CW):i.frontFace(i.CCW),D=P)}o(Ot,"setFlipSided");function ot(P){P!==Wl?(me(i.CULL_FACE),P!==F&&(P===zo?i.cullFace(i.BACK):P===ql?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):De(i.CULL_FACE),F=P}o(ot,"setCullFace");function _n(P){P!==V&&(W&&i.lineWidth(P),V=P)}o(_n,"setLineWidth");function gt(P,$,K){P?(me(i.POLYGON_OFFSET_FILL),(C!==$||q!==K)&&(C=$,q=K,a.getReversed()&&($=-$,K=-K),i.polygonOffset($,K))):De(i.POLYGON_OFFSET_FILL)}o(gt,"setPolygonOffset");function Yt(P){P?me(i.SCISSOR_TEST):De(i.SCISSOR_TEST)}o(Yt,"setScissorTest");function Jt(P){P===void 0&&(P=i.TEXTURE0+Y-1),Q!==P&&(i.activeTexture(P),Q=P)}o(Jt,"activeTexture");function $t(P,$,K){K===void 0&&(Q===null?K=i.TEXTURE0+Y-1:K=Q);let le=ee[K];le===void 0&&(le={type:void 0,texture:void 0},ee[K]=le),(le.type!==P||le.texture!==$)&&(Q!==K&&(i.activeTexture(K),Q=K),i.bindTexture(P,$||Ee[P]),le.type=P,le.texture=$)}o($t,"bindTexture");function N(){let P=ee[Q];P!==void 0&&P.type!==void 0&&(i.bindTexture(P.type,null),P.type=void 0,P.texture=void 0)}o(N,"unbindTexture");function Zt(){try{i.compressedTexImage2D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(Zt,"compressedTexImage2D");function rt(){try{i.compressedTexImage3D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(rt,"compressedTexImage3D");function st(){try{i.texSubImage2D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(st,"texSubImage2D");function pe(){try{i.texSubImage3D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(pe,"texSubImage3D");function ft(){try{i.compressedTexSubImage2D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(ft,"compressedTexSubImage2D");function Ce(){try{i.compressedTexSubImage3D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(Ce,"compressedTexSubImage3D");function Ne(){try{i.texStorage2D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(Ne,"texStorage2D");function R(){try{i.texStorage3D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(R,"texStorage3D");function v(){try{i.texImage2D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(v,"texImage2D");function B(){try{i.texImage3D(...arguments)}catch(P){Ie("WebGLState:",P)}}o(B,"texImage3D");function ie(P){return p[P]!==void 0?p[P]:i.getParameter(P)}o(ie,"getParameter");function Z(P,$){p[P]!==$&&(i.pixelStorei(P,$),p[P]=$)}o(Z,"pixelStorei");function ae(P){z.equals(P)===!1&&(i.scissor(P.x,P.y,P.z,P.w),z.copy(P))}o(ae,"scissor");function ue(P){te.equals(P)===!1&&(i.viewport(P.x,P.y,P.z,P.w),te.copy(P))}o(ue,"viewport");function j(P,$){let K=h.get($);K===void 0&&(K=new WeakMap,h.set($,K));let le=K.get(P);le===void 0&&(le=i.getUniformBlockIndex($,P.name),i.uniformBlockBinding($,le,le),K.set(P,le))}o(j,"updateUBOMapping");function J(P,$,K){let se=h.get($).get(P);l[se]!==K&&(i.bindBufferBase(i.UNIFORM_BUFFER,se,K),l[se]=K)}o(J,"uniformBlockBinding");function ce(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},p={},Q=null,ee={},d={},l={},f=new WeakMap,g=[],y=null,m=!1,b=null,w=null,T=null,x=null,S=null,E=null,_=null,A=new qe(0,0,0),U=0,I=!1,D=null,F=null,V=null,C=null,q=null,z.set(0,0,i.canvas.width,i.canvas.height),te.set(0,0,i.canvas.width,i.canvas.height),s.reset(),a.reset(),c.reset()}return o(ce,"reset"),{buffers:{color:s,depth:a,stencil:c},enable:me,disable:De,bindFramebuffer:nt,drawBuffers:Re,useProgram:Je,setBlending:vt,setMaterial:dt,setFlipSided:Ot,setCullFace:ot,setLineWidth:_n,setPolygonOffset:gt,setScissorTest:Yt,activeTexture:Jt,bindTexture:$t,unbindTexture:N,compressedTexImage2D:Zt,compressedTexImage3D:rt,texImage2D:v,texImage3D:B,pixelStorei:Z,getParameter:ie,updateUBOMapping:j,uniformBlockBinding:J,texStorage2D:Ne,texStorage3D:R,texSubImage2D:st,texSubImage3D:pe,compressedTexSubImage2D:ft,compressedTexSubImage3D:Ce,scissor:ae,viewport:ue,reset:ce}}o(S0,"WebGLState");function M0(i,e,t,n,r,s,a){let c=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),h=new Xe,u=new WeakMap,p=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(R=>g.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function b(R,v){return m?new OffscreenCanvas(R,v):mr("canvas")}o(b,"createCanvas");function w(R,v,B){let ie=1,Z=Ne(R);if((Z.width>B||Z.height>B)&&(ie=B/Math.max(Z.width,Z.height)),ie<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ae=Math.floor(ie*Z.width),ue=Math.floor(ie*Z.height);d===void 0&&(d=b(ae,ue));let j=v?b(ae,ue):d;return j.width=ae,j.height=ue,j.getContext("2d").drawImage(R,0,0,ae,ue),Pe("WebGLRenderer: Texture has been resized from ("+Z.width+"x"+Z.height+") to ("+ae+"x"+ue+")."),j}else return"data"in R&&Pe("WebGLRenderer: Image in DataTexture is too big ("+Z.width+"x"+Z.height+")."),R;return R}o(w,"resizeImage");function T(R){return R.generateMipmaps}o(T,"textureNeedsGenerateMipmaps");function x(R){i.generateMipmap(R)}o(x,"generateMipmap");function S(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}o(S,"getTargetType");function E(R,v,B,ie,Z,ae=!1){if(R!==null){if(i[R]!==void 0)return i[R];Pe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ue;ie&&(ue=e.get("EXT_texture_norm16"),ue||Pe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let j=v;if(v===i.RED&&(B===i.FLOAT&&(j=i.R32F),B===i.HALF_FLOAT&&(j=i.R16F),B===i.UNSIGNED_BYTE&&(j=i.R8),B===i.UNSIGNED_SHORT&&ue&&(j=ue.R16_EXT),B===i.SHORT&&ue&&(j=ue.R16_SNORM_EXT)),v===i.RED_INTEGER&&(B===i.UNSIGNED_BYTE&&(j=i.R8UI),B===i.UNSIGNED_SHORT&&(j=i.R16UI),B===i.UNSIGNED_INT&&(j=i.R32UI),B===i.BYTE&&(j=i.R8I),B===i.SHORT&&(j=i.R16I),B===i.INT&&(j=i.R32I)),v===i.RG&&(B===i.FLOAT&&(j=i.RG32F),B===i.HALF_FLOAT&&(j=i.RG16F),B===i.UNSIGNED_BYTE&&(j=i.RG8),B===i.UNSIGNED_SHORT&&ue&&(j=ue.RG16_EXT),B===i.SHORT&&ue&&(j=ue.RG16_SNORM_EXT)),v===i.RG_INTEGER&&(B===i.UNSIGNED_BYTE&&(j=i.RG8UI),B===i.UNSIGNED_SHORT&&(j=i.RG16UI),B===i.UNSIGNED_INT&&(j=i.RG32UI),B===i.BYTE&&(j=i.RG8I),B===i.SHORT&&(j=i.RG16I),B===i.INT&&(j=i.RG32I)),v===i.RGB_INTEGER&&(B===i.UNSIGNED_BYTE&&(j=i.RGB8UI),B===i.UNSIGNED_SHORT&&(j=i.RGB16UI),B===i.UNSIGNED_INT&&(j=i.RGB32UI),B===i.BYTE&&(j=i.RGB8I),B===i.SHORT&&(j=i.RGB16I),B===i.INT&&(j=i.RGB32I)),v===i.RGBA_INTEGER&&(B===i.UNSIGNED_BYTE&&(j=i.RGBA8UI),B===i.UNSIGNED_SHORT&&(j=i.RGBA16UI),B===i.UNSIGNED_INT&&(j=i.RGBA32UI),B===i.BYTE&&(j=i.RGBA8I),B===i.SHORT&&(j=i.RGBA16I),B===i.INT&&(j=i.RGBA32I)),v===i.RGB&&(B===i.UNSIGNED_SHORT&&ue&&(j=ue.RGB16_EXT),B===i.SHORT&&ue&&(j=ue.RGB16_SNORM_EXT),B===i.UNSIGNED_INT_5_9_9_9_REV&&(j=i.RGB9_E5),B===i.UNSIGNED_INT_10F_11F_11F_REV&&(j=i.R11F_G11F_B10F)),v===i.RGBA){let J=ae?fr:Ve.getTransfer(Z);B===i.FLOAT&&(j=i.RGBA32F),B===i.HALF_FLOAT&&(j=i.RGBA16F),B===i.UNSIGNED_BYTE&&(j=J===Ye?i.SRGB8_ALPHA8:i.RGBA8),B===i.UNSIGNED_SHORT&&ue&&(j=ue.RGBA16_EXT),B===i.SHORT&&ue&&(j=ue.RGBA16_SNORM_EXT),B===i.UNSIGNED_SHORT_4_4_4_4&&(j=i.RGBA4),B===i.UNSIGNED_SHORT_5_5_5_1&&(j=i.RGB5_A1)}return(j===i.R16F||j===i.R32F||j===i.RG16F||j===i.RG32F||j===i.RGBA16F||j===i.RGBA32F)&&e.get("EXT_color_buffer_float"),j}o(E,"getInternalFormat");function _(R,v){let B;return R?v===null||v===Kt||v===vi?B=i.DEPTH24_STENCIL8:v===pn?B=i.DEPTH32F_STENCIL8:v===Qi&&(B=i.DEPTH24_STENCIL8,Pe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===Kt||v===vi?B=i.DEPTH_COMPONENT24:v===pn?B=i.DEPTH_COMPONENT32F:v===Qi&&(B=i.DEPTH_COMPONENT16),B}o(_,"getInternalDepthFormat");function A(R,v){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==yt&&R.minFilter!==Nt?Math.log2(Math.max(v.width,v.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?v.mipmaps.length:1}o(A,"getMipLevels");function U(R){let v=new WeakRef(R);n.get(R).__ref=v,g.add(v),y.register(R,v,v)}o(U,"track");function I(R){let v=n.get(R).__ref;v!==void 0&&(g.delete(v),y.unregister(v))}o(I,"untrack");function D(R){V(R.target)}o(D,"onTextureDispose");function F(R){C(R.target)}o(F,"onRenderTargetDispose");function V(R){R.removeEventListener("dispose",D),I(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&p.delete(R)}o(V,"destroyTexture");function C(R){R.removeEventListener("dispose",F),I(R),ne(R)}o(C,"destroyRenderTarget");function q(){for(let R of g){let v=R.deref();v!==void 0&&(v.isRenderTarget===!0?C(v):V(v))}g.clear(),p.clear()}o(q,"dispose");function Y(R){let v=n.get(R);if(v.__webglInit===void 0)return;let B=R.source,ie=f.get(B);if(ie){let Z=ie[v.__cacheKey];Z.usedTimes--,Z.usedTimes===0&&W(R),Object.keys(ie).length===0&&f.delete(B)}n.remove(R)}o(Y,"deallocateTexture");function W(R){let v=n.get(R);i.deleteTexture(v.__webglTexture);let B=R.source,ie=f.get(B);delete ie[v.__cacheKey],a.memory.textures--}o(W,"deleteTexture");function ne(R){let v=n.get(R);v.__depthDisposeCallback&&v.__depthDisposeCallback();let B=R.depthTexture;if(B&&B.renderTarget===R&&V(B),R.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(v.__webglFramebuffer[Z]))for(let ae=0;ae<v.__webglFramebuffer[Z].length;ae++)i.deleteFramebuffer(v.__webglFramebuffer[Z][ae]);else i.deleteFramebuffer(v.__webglFramebuffer[Z]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[Z])}else{if(Array.isArray(v.__webglFramebuffer))for(let Z=0;Z<v.__webglFramebuffer.length;Z++)i.deleteFramebuffer(v.__webglFramebuffer[Z]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let Z=0;Z<v.__webglColorRenderbuffer.length;Z++)v.__webglColorRenderbuffer[Z]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[Z]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let ie=R.textures;for(let Z=0,ae=ie.length;Z<ae;Z++){let ue=n.get(ie[Z]);ue.__webglTexture&&(i.deleteTexture(ue.__webglTexture),a.memory.textures--),n.remove(ie[Z])}n.remove(R)}o(ne,"deallocateRenderTarget");let X=0;function Q(){X=0}o(Q,"resetTextureUnits");function ee(){return X}o(ee,"getTextureUnits");function ve(R){X=R}o(ve,"setTextureUnits");function fe(){let R=X;return R>=r.maxTextures&&Pe("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),X+=1,R}o(fe,"allocateTextureUnit");function z(R){let v=[];return v.push(R.wrapS),v.push(R.wrapT),v.push(R.wrapR||0),v.push(R.magFilter),v.push(R.minFilter),v.push(R.anisotropy),v.push(R.internalFormat),v.push(R.format),v.push(R.type),v.push(R.generateMipmaps),v.push(R.mipmapsAutoUpdate),v.push(R.premultiplyAlpha),v.push(R.flipY),v.push(R.unpackAlignment),v.push(R.colorSpace),v.join()}o(z,"getTextureCacheKey");function te(R,v){let B=n.get(R);if(R.isVideoTexture&&ft(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&B.__version!==R.version){let ie=R.image;if(ie===null)Pe("WebGLRenderer: Texture marked for update but no image data found.");else if(ie.complete===!1)Pe("WebGLRenderer: Texture marked for update but image is incomplete");else{dt(B,R,v);return}}else R.isExternalTexture&&(B.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,B.__webglTexture,i.TEXTURE0+v)}o(te,"setTexture2D");function xe(R,v){let B=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&B.__version!==R.version){dt(B,R,v);return}else R.isExternalTexture&&(B.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,B.__webglTexture,i.TEXTURE0+v)}o(xe,"setTexture2DArray");function Ee(R,v){let B=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&B.__version!==R.version){dt(B,R,v);return}t.bindTexture(i.TEXTURE_3D,B.__webglTexture,i.TEXTURE0+v)}o(Ee,"setTexture3D");function me(R,v){let B=n.get(R);if(R.version>0&&B.__version!==R.version){Ot(B,R,v);return}t.bindTexture(i.TEXTURE_CUBE_MAP,B.__webglTexture,i.TEXTURE0+v)}o(me,"setTextureCube");let De={[Ds]:i.REPEAT,[vn]:i.CLAMP_TO_EDGE,[Ns]:i.MIRRORED_REPEAT},nt={[yt]:i.NEAREST,[uh]:i.NEAREST_MIPMAP_NEAREST,[Pr]:i.NEAREST_MIPMAP_LINEAR,[Nt]:i.LINEAR,[aa]:i.LINEAR_MIPMAP_NEAREST,[Bn]:i.LINEAR_MIPMAP_LINEAR},Re={[mh]:i.NEVER,[lc]:i.ALWAYS,[gh]:i.LESS,[oc]:i.LEQUAL,[bh]:i.EQUAL,[cc]:i.GEQUAL,[_h]:i.GREATER,[xh]:i.NOTEQUAL};function Je(R,v){if(v.type===pn&&e.has("OES_texture_float_linear")===!1&&(v.magFilter===Nt||v.magFilter===aa||v.magFilter===Pr||v.magFilter===Bn||v.minFilter===Nt||v.minFilter===aa||v.minFilter===Pr||v.minFilter===Bn)&&Pe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,De[v.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,De[v.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,De[v.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,nt[v.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,nt[v.minFilter]),v.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Re[v.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===yt||v.minFilter!==Pr&&v.minFilter!==Bn||v.type===pn&&e.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){let B=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,r.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}o(Je,"setTextureParameters");function Ze(R,v){let B=!1;R.__webglInit===void 0&&(R.__webglInit=!0,v.addEventListener("dispose",D),U(v));let ie=v.source,Z=f.get(ie);Z===void 0&&(Z={},f.set(ie,Z));let ae=z(v);if(ae!==R.__cacheKey){Z[ae]===void 0&&(Z[ae]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,B=!0),Z[ae].usedTimes++;let ue=Z[R.__cacheKey];ue!==void 0&&(Z[R.__cacheKey].usedTimes--,ue.usedTimes===0&&W(v)),R.__cacheKey=ae,R.__webglTexture=Z[ae].texture}return B}o(Ze,"initTexture");function ke(R,v,B){return Math.floor(Math.floor(R/B)/v)}o(ke,"getRow");function vt(R,v,B,ie){let ae=R.updateRanges;if(ae.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,B,ie,v.data);else{ae.sort((P,$)=>P.start-$.start);let ue=0;for(let P=1;P<ae.length;P++){let $=ae[ue],K=ae[P],le=$.start+$.count,se=ke(K.start,v.width,4),oe=ke($.start,v.width,4);K.start<=le+1&&se===oe&&ke(K.start+K.count-1,v.width,4)===se?$.count=Math.max($.count,K.start+K.count-$.start):(++ue,ae[ue]=K)}ae.length=ue+1;let j=t.getParameter(i.UNPACK_ROW_LENGTH),J=t.getParameter(i.UNPACK_SKIP_PIXELS),ce=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let P=0,$=ae.length;P<$;P++){let K=ae[P],le=Math.floor(K.start/4),se=Math.ceil(K.count/4),oe=le%v.width,Ae=Math.floor(le/v.width),Oe=se,re=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,oe),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ae),t.texSubImage2D(i.TEXTURE_2D,0,oe,Ae,Oe,re,B,ie,v.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,j),t.pixelStorei(i.UNPACK_SKIP_PIXELS,J),t.pixelStorei(i.UNPACK_SKIP_ROWS,ce)}}o(vt,"updateTexture");function dt(R,v,B){let ie=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(ie=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(ie=i.TEXTURE_3D);let Z=Ze(R,v),ae=v.source;t.bindTexture(ie,R.__webglTexture,i.TEXTURE0+B);let ue=n.get(ae);if(ae.version!==ue.__version||Z===!0){if(t.activeTexture(i.TEXTURE0+B),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let re=Ve.getPrimaries(Ve.workingColorSpace),Te=v.colorSpace===zn?null:Ve.getPrimaries(v.colorSpace),Fe=v.colorSpace===zn||re===Te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Fe)}t.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment);let J=w(v.image,!1,r.maxTextureSize);J=Ce(v,J);let ce=s.convert(v.format,v.colorSpace),P=s.convert(v.type),$=E(v.internalFormat,ce,P,v.normalized,v.colorSpace,v.isVideoTexture);Je(ie,v);let K,le=v.mipmaps,se=v.isVideoTexture!==!0,oe=ue.__version===void 0||Z===!0,Ae=ae.dataReady,Oe=A(v,J);if(v.isDepthTexture)$=_(v.format===kn,v.type),oe&&(se?t.texStorage2D(i.TEXTURE_2D,1,$,J.width,J.height):t.texImage2D(i.TEXTURE_2D,0,$,J.width,J.height,0,ce,P,null));else if(v.isDataTexture)if(le.length>0){se&&oe&&t.texStorage2D(i.TEXTURE_2D,Oe,$,le[0].width,le[0].height);for(let re=0,Te=le.length;re<Te;re++)K=le[re],se?Ae&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,K.width,K.height,ce,P,K.data):t.texImage2D(i.TEXTURE_2D,re,$,K.width,K.height,0,ce,P,K.data);v.generateMipmaps=!1}else se?(oe&&t.texStorage2D(i.TEXTURE_2D,Oe,$,J.width,J.height),Ae&&vt(v,J,ce,P)):t.texImage2D(i.TEXTURE_2D,0,$,J.width,J.height,0,ce,P,J.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){se&&oe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Oe,$,le[0].width,le[0].height,J.depth);for(let re=0,Te=le.length;re<Te;re++)if(K=le[re],v.format!==gn)if(ce!==null)if(se){if(Ae)if(v.layerUpdates.size>0){let Fe=fc(K.width,K.height,v.format,v.type);for(let ge of v.layerUpdates){let $e=K.data.subarray(ge*Fe/K.data.BYTES_PER_ELEMENT,(ge+1)*Fe/K.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,ge,K.width,K.height,1,ce,$e)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,0,K.width,K.height,J.depth,ce,K.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,re,$,K.width,K.height,J.depth,0,K.data,0,0);else Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else se?Ae&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,re,0,0,0,K.width,K.height,J.depth,ce,P,K.data):t.texImage3D(i.TEXTURE_2D_ARRAY,re,$,K.width,K.height,J.depth,0,ce,P,K.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{se&&oe&&t.texStorage2D(i.TEXTURE_2D,Oe,$,le[0].width,le[0].height);for(let re=0,Te=le.length;re<Te;re++)K=le[re],v.format!==gn?ce!==null?se?Ae&&t.compressedTexSubImage2D(i.TEXTURE_2D,re,0,0,K.width,K.height,ce,K.data):t.compressedTexImage2D(i.TEXTURE_2D,re,$,K.width,K.height,0,K.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):se?Ae&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,K.width,K.height,ce,P,K.data):t.texImage2D(i.TEXTURE_2D,re,$,K.width,K.height,0,ce,P,K.data)}else if(v.isDataArrayTexture)if(se){if(oe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Oe,$,J.width,J.height,J.depth),Ae)if(v.layerUpdates.size>0){let re=fc(J.width,J.height,v.format,v.type);for(let Te of v.layerUpdates){let Fe=J.data.subarray(Te*re/J.data.BYTES_PER_ELEMENT,(Te+1)*re/J.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Te,J.width,J.height,1,ce,P,Fe)}v.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,J.width,J.height,J.depth,ce,P,J.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,$,J.width,J.height,J.depth,0,ce,P,J.data);else if(v.isData3DTexture)se?(oe&&t.texStorage3D(i.TEXTURE_3D,Oe,$,J.width,J.height,J.depth),Ae&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,J.width,J.height,J.depth,ce,P,J.data)):t.texImage3D(i.TEXTURE_3D,0,$,J.width,J.height,J.depth,0,ce,P,J.data);else if(v.isFramebufferTexture){if(oe)if(se)t.texStorage2D(i.TEXTURE_2D,Oe,$,J.width,J.height);else{let re=J.width,Te=J.height;for(let Fe=0;Fe<Oe;Fe++)t.texImage2D(i.TEXTURE_2D,Fe,$,re,Te,0,ce,P,null),re>>=1,Te>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in i){let re=i.canvas;if(re.hasAttribute("layoutsubtree")||re.setAttribute("layoutsubtree","true"),J.parentNode!==re){re.appendChild(J),p.add(v),re.onpaint=Te=>{let Fe=Te.changedElements;for(let ge of p)Fe.includes(ge.image)&&(ge.needsUpdate=!0)},re.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,J);else{let Fe=i.RGBA,ge=i.RGBA,$e=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Fe,ge,$e,J)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(le.length>0){if(se&&oe){let re=Ne(le[0]);t.texStorage2D(i.TEXTURE_2D,Oe,$,re.width,re.height)}for(let re=0,Te=le.length;re<Te;re++)K=le[re],se?Ae&&t.texSubImage2D(i.TEXTURE_2D,re,0,0,ce,P,K):t.texImage2D(i.TEXTURE_2D,re,$,ce,P,K);v.generateMipmaps=!1}else if(se){if(oe){let re=Ne(J);t.texStorage2D(i.TEXTURE_2D,Oe,$,re.width,re.height)}Ae&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ce,P,J)}else t.texImage2D(i.TEXTURE_2D,0,$,ce,P,J);T(v)&&v.mipmapsAutoUpdate===!0&&x(ie),ue.__version=ae.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}o(dt,"uploadTexture");function Ot(R,v,B){if(v.image.length!==6)return;let ie=Ze(R,v),Z=v.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+B);let ae=n.get(Z);if(Z.version!==ae.__version||ie===!0){t.activeTexture(i.TEXTURE0+B);let ue=Ve.getPrimaries(Ve.workingColorSpace),j=v.colorSpace===zn?null:Ve.getPrimaries(v.colorSpace),J=v.colorSpace===zn||ue===j?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,J);let ce=v.isCompressedTexture||v.image[0].isCompressedTexture,P=v.image[0]&&v.image[0].isDataTexture,$=[];for(let ge=0;ge<6;ge++)!ce&&!P?$[ge]=w(v.image[ge],!0,r.maxCubemapSize):$[ge]=P?v.image[ge].image:v.image[ge],$[ge]=Ce(v,$[ge]);let K=$[0],le=s.convert(v.format,v.colorSpace),se=s.convert(v.type),oe=E(v.internalFormat,le,se,v.normalized,v.colorSpace),Ae=v.isVideoTexture!==!0,Oe=ae.__version===void 0||ie===!0,re=Z.dataReady,Te=A(v,K);Je(i.TEXTURE_CUBE_MAP,v);let Fe;if(v.isDepthTexture){if(oe=_(v.format===kn,v.type),Oe)if(Ae)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,oe,K.width,K.height);else for(let ge=0;ge<6;ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,K.width,K.height,0,le,se,null)}else if(ce){Ae&&Oe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Te,oe,K.width,K.height);for(let ge=0;ge<6;ge++){Fe=$[ge].mipmaps;for(let $e=0;$e<Fe.length;$e++){let bt=Fe[$e];v.format!==gn?le!==null?Ae?re&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e,0,0,bt.width,bt.height,le,bt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e,oe,bt.width,bt.height,0,bt.data):Pe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ae?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e,0,0,bt.width,bt.height,le,se,bt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e,oe,bt.width,bt.height,0,le,se,bt.data)}}}else{if(Fe=v.mipmaps,Ae&&Oe){Fe.length>0&&Te++;let ge=Ne($[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Te,oe,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(P){Ae?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,$[ge].width,$[ge].height,le,se,$[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,$[ge].width,$[ge].height,0,le,se,$[ge].data);for(let $e=0;$e<Fe.length;$e++){let Hn=Fe[$e].image[ge].image;Ae?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e+1,0,0,Hn.width,Hn.height,le,se,Hn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e+1,oe,Hn.width,Hn.height,0,le,se,Hn.data)}}else{Ae?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,le,se,$[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,oe,le,se,$[ge]);for(let $e=0;$e<Fe.length;$e++){let bt=Fe[$e];Ae?re&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e+1,0,0,le,se,bt.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,$e+1,oe,le,se,bt.image[ge])}}}T(v)&&v.mipmapsAutoUpdate===!0&&x(i.TEXTURE_CUBE_MAP),ae.__version=Z.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}o(Ot,"uploadCubeTexture");function ot(R,v,B,ie,Z,ae){let ue=s.convert(B.format,B.colorSpace),j=s.convert(B.type),J=E(B.internalFormat,ue,j,B.normalized,B.colorSpace),ce=n.get(v),P=n.get(B);if(P.__renderTarget=v,!ce.__hasExternalTextures){let $=Math.max(1,v.width>>ae),K=Math.max(1,v.height>>ae);Z===i.TEXTURE_3D||Z===i.TEXTURE_2D_ARRAY?t.texImage3D(Z,ae,J,$,K,v.depth,0,ue,j,null):t.texImage2D(Z,ae,J,$,K,0,ue,j,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),pe(v)?c.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ie,Z,P.__webglTexture,0,st(v)):(Z===i.TEXTURE_2D||Z>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Z<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ie,Z,P.__webglTexture,ae),t.bindFramebuffer(i.FRAMEBUFFER,null)}o(ot,"setupFrameBufferTexture");function _n(R,v,B){if(i.bindRenderbuffer(i.RENDERBUFFER,R),v.depthBuffer){let ie=v.depthTexture,Z=ie&&ie.isDepthTexture?ie.type:null,ae=_(v.stencilBuffer,Z),ue=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;pe(v)?c.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,st(v),ae,v.width,v.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,st(v),ae,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,ae,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ue,i.RENDERBUFFER,R)}else{let ie=v.textures;for(let Z=0;Z<ie.length;Z++){let ae=ie[Z],ue=s.convert(ae.format,ae.colorSpace),j=s.convert(ae.type),J=E(ae.internalFormat,ue,j,ae.normalized,ae.colorSpace);pe(v)?c.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,st(v),J,v.width,v.height):B?i.renderbufferStorageMultisample(i.RENDERBUFFER,st(v),J,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,J,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}o(_n,"setupRenderBufferStorage");function gt(R,v,B){let ie=v.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Z=n.get(v.depthTexture);Z.__renderTarget=v;let ae=ie?v.depthTexture.image[0]:v.depthTexture.image;(!Z.__webglTexture||ae.width!==v.width||ae.height!==v.height)&&(ae.width=v.width,ae.height=v.height,v.depthTexture.needsUpdate=!0),ie?me(v.depthTexture,0):te(v.depthTexture,0);let ue=Z.__webglTexture,j=st(v),J=ie?i.TEXTURE_CUBE_MAP_POSITIVE_X+B:i.TEXTURE_2D,ce=v.depthTexture.format===kn?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(v.depthTexture.format===Fn)pe(v)?c.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,J,ue,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,ce,J,ue,0);else if(v.depthTexture.format===kn)pe(v)?c.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,J,ue,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,ce,J,ue,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}o(gt,"setupDepthTexture");function Yt(R){let v=n.get(R),B=R.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==R.depthTexture){let ie=R.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),ie){let Z=o(()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,ie.removeEventListener("dispose",Z)},"disposeEvent");ie.addEventListener("dispose",Z),v.__depthDisposeCallback=Z}v.__boundDepthTexture=ie}if(R.depthTexture&&!v.__autoAllocateDepthBuffer)if(B)for(let ie=0;ie<6;ie++)gt(v.__webglFramebuffer[ie],R,ie);else R.texture.mipmaps.length>0?gt(v.__webglFramebuffer[0],R,0):gt(v.__webglFramebuffer,R,0);else if(B){v.__webglDepthbuffer=[];for(let ie=0;ie<6;ie++)if(t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[ie]),v.__webglDepthbuffer[ie]===void 0)v.__webglDepthbuffer[ie]=i.createRenderbuffer(),_n(v.__webglDepthbuffer[ie],R,!1);else{let Z=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=v.__webglDepthbuffer[ie];i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,Z,i.RENDERBUFFER,ae)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),_n(v.__webglDepthbuffer,R,!1);else{let Z=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,Z,i.RENDERBUFFER,ae)}t.bindFramebuffer(i.FRAMEBUFFER,null)}o(Yt,"setupDepthRenderbuffer");function Jt(R,v,B){let ie=n.get(R);v!==void 0&&ot(ie.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),B!==void 0&&Yt(R)}o(Jt,"rebindTextures");function $t(R){let v=R.texture,B=n.get(R),ie=n.get(v);R.addEventListener("dispose",F),U(R);let Z=R.textures,ae=R.isWebGLCubeRenderTarget===!0,ue=Z.length>1;if(ue||(ie.__webglTexture===void 0&&(ie.__webglTexture=i.createTexture()),ie.__version=v.version,a.memory.textures++),ae){B.__webglFramebuffer=[];for(let j=0;j<6;j++)if(v.mipmaps.length>0){B.__webglFramebuffer[j]=[];for(let J=0;J<v.mipmaps.length;J++)B.__webglFramebuffer[j][J]=i.createFramebuffer()}else B.__webglFramebuffer[j]=i.createFramebuffer()}else{if(v.mipmaps.length>0){B.__webglFramebuffer=[];for(let j=0;j<v.mipmaps.length;j++)B.__webglFramebuffer[j]=i.createFramebuffer()}else B.__webglFramebuffer=i.createFramebuffer();if(ue)for(let j=0,J=Z.length;j<J;j++){let ce=n.get(Z[j]);ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture(),a.memory.textures++)}if(R.samples>0&&pe(R)===!1){B.__webglMultisampledFramebuffer=i.createFramebuffer(),B.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let j=0;j<Z.length;j++){let J=Z[j];B.__webglColorRenderbuffer[j]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,B.__webglColorRenderbuffer[j]);let ce=s.convert(J.format,J.colorSpace),P=s.convert(J.type),$=E(J.internalFormat,ce,P,J.normalized,J.colorSpace,R.isXRRenderTarget===!0),K=st(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,K,$,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+j,i.RENDERBUFFER,B.__webglColorRenderbuffer[j])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(B.__webglDepthRenderbuffer=i.createRenderbuffer(),_n(B.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ae){t.bindTexture(i.TEXTURE_CUBE_MAP,ie.__webglTexture),Je(i.TEXTURE_CUBE_MAP,v);for(let j=0;j<6;j++)if(v.mipmaps.length>0)for(let J=0;J<v.mipmaps.length;J++)ot(B.__webglFramebuffer[j][J],R,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,J);else ot(B.__webglFramebuffer[j],R,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,0);T(v)?x(i.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}else if(ue){for(let j=0,J=Z.length;j<J;j++){let ce=Z[j],P=n.get(ce),$=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&($=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture($,P.__webglTexture),Je($,ce),ot(B.__webglFramebuffer,R,ce,i.COLOR_ATTACHMENT0+j,$,0),T(ce)&&x($)}t.unbindTexture()}else{let j=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(j=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(j,ie.__webglTexture),Je(j,v),v.mipmaps.length>0)for(let J=0;J<v.mipmaps.length;J++)ot(B.__webglFramebuffer[J],R,v,i.COLOR_ATTACHMENT0,j,J);else ot(B.__webglFramebuffer,R,v,i.COLOR_ATTACHMENT0,j,0);T(v)?x(j):v.mipmaps.length>0&&i.texParameteri(j,i.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Yt(R)}o($t,"setupRenderTarget");function N(R){let v=R.textures;for(let B=0,ie=v.length;B<ie;B++){let Z=v[B];if(T(Z)&&Z.mipmapsAutoUpdate===!0){let ae=S(R),ue=n.get(Z).__webglTexture;t.bindTexture(ae,ue),x(ae),t.unbindTexture()}}}o(N,"updateRenderTargetMipmap");let Zt=[];function rt(R){if(R.samples>0){if(pe(R)===!1){let v=R.textures,B=R.width,ie=R.height,Z=i.COLOR_BUFFER_BIT,ae=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ue=n.get(R),j=v.length>1;if(j)for(let ce=0;ce<v.length;ce++)t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ue.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglFramebuffer);for(let ce=0;ce<v.length;ce++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(Z|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(Z|=i.STENCIL_BUFFER_BIT)),j){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ue.__webglColorRenderbuffer[ce]);let P=n.get(v[ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,P,0)}i.blitFramebuffer(0,0,B,ie,0,0,B,ie,Z,i.NEAREST),l===!0&&(Zt.length=0,Zt.push(i.COLOR_ATTACHMENT0+ce),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Zt.push(ae),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Zt))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),j)for(let ce=0;ce<v.length;ce++){t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,ue.__webglColorRenderbuffer[ce]);let P=n.get(v[ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ue.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,P,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ue.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let v=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}o(rt,"updateMultisampleRenderTarget");function st(R){return Math.min(r.maxSamples,R.samples)}o(st,"getRenderTargetSamples");function pe(R){let v=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}o(pe,"useMultisampledRTT");function ft(R){let v=a.render.frame;u.get(R)!==v&&(u.set(R,v),R.update())}o(ft,"updateVideoTexture");function Ce(R,v){let B=R.colorSpace,ie=R.format,Z=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||B!==dr&&B!==zn&&(Ve.getTransfer(B)===Ye?(ie!==gn||Z!==Xt)&&Pe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ie("WebGLTextures: Unsupported texture color space:",B)),v}o(Ce,"verifyColorSpace");function Ne(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(h.width=R.naturalWidth||R.width,h.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(h.width=R.displayWidth,h.height=R.displayHeight):(h.width=R.width,h.height=R.height),h}o(Ne,"getDimensions"),this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=ee,this.setTextureUnits=ve,this.setTexture2D=te,this.setTexture2DArray=xe,this.setTexture3D=Ee,this.setTextureCube=me,this.rebindTextures=Jt,this.setupRenderTarget=$t,this.updateRenderTargetMipmap=N,this.updateMultisampleRenderTarget=rt,this.setupDepthRenderbuffer=Yt,this.setupFrameBufferTexture=ot,this.useMultisampledRTT=pe,this.dispose=q}o(M0,"WebGLTextures");function w0(i,e){function t(n,r=zn){let s,a=Ve.getTransfer(r);if(n===Xt)return i.UNSIGNED_BYTE;if(n===ca)return i.UNSIGNED_SHORT_4_4_4_4;if(n===la)return i.UNSIGNED_SHORT_5_5_5_1;if(n===tc)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===nc)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Qo)return i.BYTE;if(n===ec)return i.SHORT;if(n===Qi)return i.UNSIGNED_SHORT;if(n===oa)return i.INT;if(n===Kt)return i.UNSIGNED_INT;if(n===pn)return i.FLOAT;if(n===mn)return i.HALF_FLOAT;if(n===ic)return i.ALPHA;if(n===rc)return i.RGB;if(n===gn)return i.RGBA;if(n===Fn)return i.DEPTH_COMPONENT;if(n===kn)return i.DEPTH_STENCIL;if(n===sc)return i.RED;if(n===ha)return i.RED_INTEGER;if(n===si)return i.RG;if(n===ua)return i.RG_INTEGER;if(n===da)return i.RGBA_INTEGER;if(n===Ir||n===Lr||n===Dr||n===Nr)if(a===Ye)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===Ir)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Lr)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Dr)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Nr)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===Ir)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Lr)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Dr)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Nr)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===fa||n===pa||n===ma||n===ga)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===fa)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===pa)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===ma)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ga)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===ba||n===_a||n===xa||n===ya||n===va||n===Ur||n===Sa)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(n===ba||n===_a)return a===Ye?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===xa)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===ya)return s.COMPRESSED_R11_EAC;if(n===va)return s.COMPRESSED_SIGNED_R11_EAC;if(n===Ur)return s.COMPRESSED_RG11_EAC;if(n===Sa)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Ma||n===wa||n===Ea||n===Aa||n===Ta||n===Ra||n===Ca||n===Pa||n===Ia||n===La||n===Da||n===Na||n===Ua||n===Fa)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(n===Ma)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===wa)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ea)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Aa)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Ta)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ra)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Ca)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Pa)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ia)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===La)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Da)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Na)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ua)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Fa)return a===Ye?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Oa||n===Ba||n===ka)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(n===Oa)return a===Ye?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ba)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ka)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===za||n===Ga||n===Fr||n===Va)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(n===za)return s.COMPRESSED_RED_RGTC1_EXT;if(n===Ga)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Fr)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Va)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===vi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return o(t,"convert"),{convert:t}}o(w0,"WebGLUtils");var E0=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,A0=`
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

}`,Sc=class{static{o(this,"WebXRDepthSensing")}constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new _i(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new wn({vertexShader:E0,fragmentShader:A0,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new ut(new Mr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Mc=class extends Sn{static{o(this,"WebXRManager")}constructor(e,t){super();let n=this,r=null,s=1,a=null,c="local-floor",l=1,h=null,u=null,p=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",m=new Sc,b={},w=t.getContextAttributes(),T=null,x=null,S=[],E=[],_=new Xe,A=null,U=null,I=new Mt;I.viewport=new et;let D=new Mt;D.viewport=new et;let F=[I,D],V=new ia,C=null,q=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(z){let te=S[z];return te===void 0&&(te=new Wi,S[z]=te),te.getTargetRaySpace()},this.getControllerGrip=function(z){let te=S[z];return te===void 0&&(te=new Wi,S[z]=te),te.getGripSpace()},this.getHand=function(z){let te=S[z];return te===void 0&&(te=new Wi,S[z]=te),te.getHandSpace()};function Y(z){let te=E.indexOf(z.inputSource);if(te===-1)return;let xe=S[te];xe!==void 0&&(xe.update(z.inputSource,z.frame,h||a),xe.dispatchEvent({type:z.type,data:z.inputSource}))}o(Y,"onSessionEvent");function W(){r.removeEventListener("select",Y),r.removeEventListener("selectstart",Y),r.removeEventListener("selectend",Y),r.removeEventListener("squeeze",Y),r.removeEventListener("squeezestart",Y),r.removeEventListener("squeezeend",Y),r.removeEventListener("end",W),r.removeEventListener("inputsourceschange",ne);for(let z=0;z<S.length;z++){let te=E[z];te!==null&&(E[z]=null,S[z].disconnect(te))}C=null,q=null,m.reset();for(let z in b)delete b[z];if(e.setRenderTarget(T),f=null,d=null,p=null,r=null,x=null,fe.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(_.width,_.height,!1),U!==null){let z=U.camera;z.fov=U.fov,z.zoom=U.zoom,z.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}o(W,"onSessionEnd"),this.setFramebufferScaleFactor=function(z){s=z,n.isPresenting===!0&&Pe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(z){c=z,n.isPresenting===!0&&Pe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return h||a},this.setReferenceSpace=function(z){h=z},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return p===null&&y&&(p=new XRWebGLBinding(r,t)),p},this.getFrame=function(){return g},this.getSession=function(){return r},this.setSession=async function(z){if(r=z,r!==null){if(T=e.getRenderTarget(),r.addEventListener("select",Y),r.addEventListener("selectstart",Y),r.addEventListener("selectend",Y),r.addEventListener("squeeze",Y),r.addEventListener("squeezestart",Y),r.addEventListener("squeezeend",Y),r.addEventListener("end",W),r.addEventListener("inputsourceschange",ne),w.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ee=null,me=null;w.depth&&(me=w.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=w.stencil?kn:Fn,Ee=w.stencil?vi:Kt);let De={colorFormat:t.RGBA8,depthFormat:me,scaleFactor:s};p=this.getBinding(),d=p.createProjectionLayer(De),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),x=new Ct(d.textureWidth,d.textureHeight,{format:gn,type:Xt,depthTexture:new dn(d.textureWidth,d.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:w.stencil,colorSpace:e.outputColorSpace,samples:w.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xe={antialias:w.antialias,alpha:!0,depth:w.depth,stencil:w.stencil,framebufferScaleFactor:s};f=new XRWebGLLayer(r,t,xe),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),x=new Ct(f.framebufferWidth,f.framebufferHeight,{format:gn,type:Xt,colorSpace:e.outputColorSpace,stencilBuffer:w.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(l),h=null,a=await r.requestReferenceSpace(c),fe.setContext(r),fe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ne(z){for(let te=0;te<z.removed.length;te++){let xe=z.removed[te],Ee=E.indexOf(xe);Ee>=0&&(E[Ee]=null,S[Ee].disconnect(xe))}for(let te=0;te<z.added.length;te++){let xe=z.added[te],Ee=E.indexOf(xe);if(Ee===-1){for(let De=0;De<S.length;De++)if(De>=E.length){E.push(xe),Ee=De;break}else if(E[De]===null){E[De]=xe,Ee=De;break}if(Ee===-1)break}let me=S[Ee];me&&me.connect(xe)}}o(ne,"onInputSourcesChange");function X(z,te){te===null?z.matrixWorld.copy(z.matrix):z.matrixWorld.multiplyMatrices(te.matrixWorld,z.matrix),z.matrixWorldInverse.copy(z.matrixWorld).invert()}o(X,"updateCamera"),this.updateCamera=function(z){if(r===null)return;let te=z.near,xe=z.far;m.texture!==null&&(m.depthNear>0&&(te=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),V.near=D.near=I.near=te,V.far=D.far=I.far=xe,(C!==V.near||q!==V.far)&&(r.updateRenderState({depthNear:V.near,depthFar:V.far}),C=V.near,q=V.far),V.layers.mask=z.layers.mask|6,I.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;let Ee=z.parent,me=V.cameras;X(V,Ee);for(let De=0;De<me.length;De++)X(me[De],Ee);V.projectionMatrix.copy(I.projectionMatrix),V.projectionMatrixInverse.copy(I.projectionMatrixInverse),U===null&&z.isPerspectiveCamera&&(U={camera:z,fov:z.fov,zoom:z.zoom}),Q(z,V,Ee)};function Q(z,te,xe){xe===null?z.matrix.copy(te.matrixWorld):(z.matrix.copy(xe.matrixWorld),z.matrix.invert(),z.matrix.multiply(te.matrixWorld)),z.matrix.decompose(z.position,z.quaternion,z.scale),z.updateMatrixWorld(!0),z.projectionMatrix.copy(te.projectionMatrix),z.projectionMatrixInverse.copy(te.projectionMatrixInverse),z.isPerspectiveCamera&&(z.fov=Fs*2*Math.atan(1/z.projectionMatrix.elements[5]),z.zoom=1)}o(Q,"updateUserCamera"),this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(z){l=z,d!==null&&(d.fixedFoveation=z),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=z)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(V)},this.getCameraTexture=function(z){return b[z]};let ee=null;function ve(z,te){if(u=te.getViewerPose(h||a),g=te,u!==null){let xe=u.views;f!==null&&(e.setRenderTargetFramebuffer(x,f.framebuffer),e.setRenderTarget(x));let Ee=!1;xe.length!==V.cameras.length&&(V.cameras.length=0,Ee=!0);for(let Re=0;Re<xe.length;Re++){let Je=xe[Re],Ze=null;if(f!==null)Ze=f.getViewport(Je);else{let vt=p.getViewSubImage(d,Je);Ze=vt.viewport,Re===0&&(e.setRenderTargetTextures(x,vt.colorTexture,vt.depthStencilTexture),e.setRenderTarget(x))}let ke=F[Re];ke===void 0&&(ke=new Mt,ke.layers.enable(Re),ke.viewport=new et,F[Re]=ke),ke.matrix.fromArray(Je.transform.matrix),ke.matrix.decompose(ke.position,ke.quaternion,ke.scale),ke.projectionMatrix.fromArray(Je.projectionMatrix),ke.projectionMatrixInverse.copy(ke.projectionMatrix).invert(),ke.viewport.set(Ze.x,Ze.y,Ze.width,Ze.height),Re===0&&(V.matrix.copy(ke.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ee===!0&&V.cameras.push(ke)}let me=r.enabledFeatures;if(me&&me.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&y){p=n.getBinding();let Re=p.getDepthInformation(xe[0]);Re&&Re.isValid&&Re.texture&&m.init(Re,r.renderState)}if(me&&me.includes("camera-access")&&y){e.state.unbindTexture(),p=n.getBinding();for(let Re=0;Re<xe.length;Re++){let Je=xe[Re].camera;if(Je){let Ze=b[Je];Ze||(Ze=new _i,b[Je]=Ze);let ke=p.getCameraImage(Je);Ze.sourceTexture=ke}}}}for(let xe=0;xe<S.length;xe++){let Ee=E[xe],me=S[xe];Ee!==null&&me!==void 0&&me.update(Ee,te,h||a)}ee&&ee(z,te),te.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:te}),g=null}o(ve,"onAnimationFrame");let fe=new Qh;fe.setAnimationLoop(ve),this.setAnimationLoop=function(z){ee=z},this.dispose=function(){}}},T0=new at,lu=new Le;lu.set(-1,0,0,0,1,0,0,0,1);function R0(i,e){function t(m,b){m.matrixAutoUpdate===!0&&m.updateMatrix(),b.value.copy(m.matrix)}o(t,"refreshTransformUniform");function n(m,b){b.color.getRGB(m.fogColor.value,hc(i)),b.isFog?(m.fogNear.value=b.near,m.fogFar.value=b.far):b.isFogExp2&&(m.fogDensity.value=b.density)}o(n,"refreshFogUniforms");function r(m,b,w,T,x){b.isNodeMaterial?b.uniformsNeedUpdate=!1:b.isMeshBasicMaterial?s(m,b):b.isMeshLambertMaterial?(s(m,b),b.envMap&&(m.envMapIntensity.value=b.envMapIntensity)):b.isMeshToonMaterial?(s(m,b),p(m,b)):b.isMeshPhongMaterial?(s(m,b),u(m,b),b.envMap&&(m.envMapIntensity.value=b.envMapIntensity)):b.isMeshStandardMaterial?(s(m,b),d(m,b),b.isMeshPhysicalMaterial&&f(m,b,x)):b.isMeshMatcapMaterial?(s(m,b),g(m,b)):b.isMeshDepthMaterial?s(m,b):b.isMeshDistanceMaterial?(s(m,b),y(m,b)):b.isMeshNormalMaterial?s(m,b):b.isLineBasicMaterial?(a(m,b),b.isLineDashedMaterial&&c(m,b)):b.isPointsMaterial?l(m,b,w,T):b.isSpriteMaterial?h(m,b):b.isShadowMaterial?(m.color.value.copy(b.color),m.opacity.value=b.opacity):b.isShaderMaterial&&(b.uniformsNeedUpdate=!1)}o(r,"refreshMaterialUniforms");function s(m,b){m.opacity.value=b.opacity,b.color&&m.diffuse.value.copy(b.color),b.emissive&&m.emissive.value.copy(b.emissive).multiplyScalar(b.emissiveIntensity),b.map&&(m.map.value=b.map,t(b.map,m.mapTransform)),b.alphaMap&&(m.alphaMap.value=b.alphaMap,t(b.alphaMap,m.alphaMapTransform)),b.bumpMap&&(m.bumpMap.value=b.bumpMap,t(b.bumpMap,m.bumpMapTransform),m.bumpScale.value=b.bumpScale,b.side===Ft&&(m.bumpScale.value*=-1)),b.normalMap&&(m.normalMap.value=b.normalMap,t(b.normalMap,m.normalMapTransform),m.normalScale.value.copy(b.normalScale),b.side===Ft&&m.normalScale.value.negate()),b.displacementMap&&(m.displacementMap.value=b.displacementMap,t(b.displacementMap,m.displacementMapTransform),m.displacementScale.value=b.displacementScale,m.displacementBias.value=b.displacementBias),b.emissiveMap&&(m.emissiveMap.value=b.emissiveMap,t(b.emissiveMap,m.emissiveMapTransform)),b.specularMap&&(m.specularMap.value=b.specularMap,t(b.specularMap,m.specularMapTransform)),b.alphaTest>0&&(m.alphaTest.value=b.alphaTest);let w=e.get(b),T=w.envMap,x=w.envMapRotation;T&&(m.envMap.value=T,m.envMapRotation.value.setFromMatrix4(T0.makeRotationFromEuler(x)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(lu),m.reflectivity.value=b.reflectivity,m.ior.value=b.ior,m.refractionRatio.value=b.refractionRatio),b.lightMap&&(m.lightMap.value=b.lightMap,m.lightMapIntensity.value=b.lightMapIntensity,t(b.lightMap,m.lightMapTransform)),b.aoMap&&(m.aoMap.value=b.aoMap,m.aoMapIntensity.value=b.aoMapIntensity,t(b.aoMap,m.aoMapTransform))}o(s,"refreshUniformsCommon");function a(m,b){m.diffuse.value.copy(b.color),m.opacity.value=b.opacity,b.map&&(m.map.value=b.map,t(b.map,m.mapTransform))}o(a,"refreshUniformsLine");function c(m,b){m.dashSize.value=b.dashSize,m.totalSize.value=b.dashSize+b.gapSize,m.scale.value=b.scale}o(c,"refreshUniformsDash");function l(m,b,w,T){m.diffuse.value.copy(b.color),m.opacity.value=b.opacity,m.size.value=b.size*w,m.scale.value=T*.5,b.map&&(m.map.value=b.map,t(b.map,m.uvTransform)),b.alphaMap&&(m.alphaMap.value=b.alphaMap,t(b.alphaMap,m.alphaMapTransform)),b.alphaTest>0&&(m.alphaTest.value=b.alphaTest)}o(l,"refreshUniformsPoints");function h(m,b){m.diffuse.value.copy(b.color),m.opacity.value=b.opacity,m.rotation.value=b.rotation,b.map&&(m.map.value=b.map,t(b.map,m.mapTransform)),b.alphaMap&&(m.alphaMap.value=b.alphaMap,t(b.alphaMap,m.alphaMapTransform)),b.alphaTest>0&&(m.alphaTest.value=b.alphaTest)}o(h,"refreshUniformsSprites");function u(m,b){m.specular.value.copy(b.specular),m.shininess.value=Math.max(b.shininess,1e-4)}o(u,"refreshUniformsPhong");function p(m,b){b.gradientMap&&(m.gradientMap.value=b.gradientMap)}o(p,"refreshUniformsToon");function d(m,b){m.metalness.value=b.metalness,b.metalnessMap&&(m.metalnessMap.value=b.metalnessMap,t(b.metalnessMap,m.metalnessMapTransform)),m.roughness.value=b.roughness,b.roughnessMap&&(m.roughnessMap.value=b.roughnessMap,t(b.roughnessMap,m.roughnessMapTransform)),b.envMap&&(m.envMapIntensity.value=b.envMapIntensity)}o(d,"refreshUniformsStandard");function f(m,b,w){m.ior.value=b.ior,b.diffuseRoughness>0&&(m.diffuseRoughness.value=b.diffuseRoughness,b.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=b.diffuseRoughnessMap,t(b.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),b.sheen>0&&(m.sheenColor.value.copy(b.sheenColor).multiplyScalar(b.sheen),m.sheenRoughness.value=b.sheenRoughness,b.sheenColorMap&&(m.sheenColorMap.value=b.sheenColorMap,t(b.sheenColorMap,m.sheenColorMapTransform)),b.sheenRoughnessMap&&(m.sheenRoughnessMap.value=b.sheenRoughnessMap,t(b.sheenRoughnessMap,m.sheenRoughnessMapTransform))),b.clearcoat>0&&(m.clearcoat.value=b.clearcoat,m.clearcoatRoughness.value=b.clearcoatRoughness,b.clearcoatMap&&(m.clearcoatMap.value=b.clearcoatMap,t(b.clearcoatMap,m.clearcoatMapTransform)),b.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=b.clearcoatRoughnessMap,t(b.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),b.clearcoatNormalMap&&(m.clearcoatNormalMap.value=b.clearcoatNormalMap,t(b.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(b.clearcoatNormalScale),b.side===Ft&&m.clearcoatNormalScale.value.negate())),b.dispersion>0&&(m.dispersion.value=b.dispersion),b.retroreflectivity>0&&(m.retroreflectivity.value=b.retroreflectivity),b.iridescence>0&&(m.iridescence.value=b.iridescence,m.iridescenceIOR.value=b.iridescenceIOR,m.iridescenceThicknessMinimum.value=b.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=b.iridescenceThicknessMaximum,b.iridescenceMap&&(m.iridescenceMap.value=b.iridescenceMap,t(b.iridescenceMap,m.iridescenceMapTransform)),b.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=b.iridescenceThicknessMap,t(b.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),b.transmission>0&&(m.transmission.value=b.transmission,m.transmissionSamplerMap.value=w.texture,m.transmissionSamplerSize.value.set(w.width,w.height),b.transmissionMap&&(m.transmissionMap.value=b.transmissionMap,t(b.transmissionMap,m.transmissionMapTransform)),m.thickness.value=b.thickness,b.thicknessMap&&(m.thicknessMap.value=b.thicknessMap,t(b.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=b.attenuationDistance,m.attenuationColor.value.copy(b.attenuationColor)),b.anisotropy>0&&(m.anisotropyVector.value.set(b.anisotropy*Math.cos(b.anisotropyRotation),b.anisotropy*Math.sin(b.anisotropyRotation)),b.anisotropyMap&&(m.anisotropyMap.value=b.anisotropyMap,t(b.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=b.specularIntensity,m.specularColor.value.copy(b.specularColor),b.specularColorMap&&(m.specularColorMap.value=b.specularColorMap,t(b.specularColorMap,m.specularColorMapTransform)),b.specularIntensityMap&&(m.specularIntensityMap.value=b.specularIntensityMap,t(b.specularIntensityMap,m.specularIntensityMapTransform))}o(f,"refreshUniformsPhysical");function g(m,b){b.matcap&&(m.matcap.value=b.matcap)}o(g,"refreshUniformsMatcap");function y(m,b){let w=e.get(b).light;m.referencePosition.value.setFromMatrixPosition(w.matrixWorld),m.nearDistance.value=w.shadow.camera.near,m.farDistance.value=w.shadow.camera.far}return o(y,"refreshUniformsDistance"),{refreshFogUniforms:n,refreshMaterialUniforms:r}}o(R0,"WebGLMaterials");function C0(i,e,t,n){let r={},s={};function a(w,T){let x=T.program;n.uniformBlockBinding(w,x,r[w.id])}o(a,"bind");function c(w,T){let x=r[w.id];x===void 0&&(g(w),x=l(w),r[w.id]=x,w.addEventListener("dispose",m));let S=T.program;n.updateUBOMapping(w,S);let E=e.render.frame;s[w.id]!==E&&(h(w),s[w.id]=E)}o(c,"update");function l(w){let T=i.createBuffer(),x=w.__size,S=w.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,x,S),i.bindBuffer(i.UNIFORM_BUFFER,null),T}o(l,"createBuffer");function h(w){let T=r[w.id],x=w.uniforms,S=w.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let E=0,_=x.length;E<_;E++){let A=x[E];if(Array.isArray(A))for(let U=0,I=A.length;U<I;U++)u(A[U],E,U,S);else u(A,E,0,S)}i.bindBuffer(i.UNIFORM_BUFFER,null)}o(h,"updateBufferData");function u(w,T,x,S){if(d(w,T,x,S)===!0){let E=w.__offset,_=w.value;if(Array.isArray(_)){let A=0;for(let U=0;U<_.length;U++){let I=_[U],D=y(I,!0);p(I,w.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else p(_,w.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,w.__data)}}o(u,"updateUniform");function p(w,T,x){typeof w=="number"||typeof w=="boolean"?T[x]=w:w.isMatrix3?(T[x]=w.elements[0],T[x+1]=w.elements[1],T[x+2]=w.elements[2],T[x+3]=0,T[x+4]=w.elements[3],T[x+5]=w.elements[4],T[x+6]=w.elements[5],T[x+7]=0,T[x+8]=w.elements[6],T[x+9]=w.elements[7],T[x+10]=w.elements[8],T[x+11]=0):ArrayBuffer.isView(w)?T.set(w.subarray(0,T.length-x),x):w.toArray(T,x)}o(p,"writeUniformValue");function d(w,T,x,S){let E=w.value,_=T+"_"+x;if(Array.isArray(E)){S[_]===void 0&&(S[_]=[]);let A=S[_],U=!1;for(let I=0;I<E.length;I++)f(E[I],A,I)===!0&&(U=!0);return U}return f(E,S,_)}o(d,"hasUniformChanged");function f(w,T,x){if(T[x]===void 0)return typeof w=="number"||typeof w=="boolean"?T[x]=w:ArrayBuffer.isView(w)?T[x]=w.slice():T[x]=w.clone(),!0;{let S=T[x];if(typeof w=="number"||typeof w=="boolean"){if(S!==w)return T[x]=w,!0}else{if(ArrayBuffer.isView(w))return!0;if(S.equals(w)===!1)return S.copy(w),!0}}return!1}o(f,"hasValueChanged");function g(w){let T=w.uniforms,x=0,S=16;for(let _=0,A=T.length;_<A;_++){let U=Array.isArray(T[_])?T[_]:[T[_]];for(let I=0,D=U.length;I<D;I++){let F=U[I],V=Array.isArray(F.value)?F.value:[F.value],C=Array.isArray(T[_])||Array.isArray(F.value),q=x;for(let W=0,ne=V.length;W<ne;W++){let X=V[W],Q=y(X,C),ee=x%S,ve=ee%Q.boundary,fe=ee+ve;x+=ve,fe!==0&&S-fe<Q.storage&&(x+=S-fe),W===0&&(q=x),x+=Q.storage}let Y=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new Y((x-q)/Float32Array.BYTES_PER_ELEMENT),F.__offset=q}}let E=x%S;return E>0&&(x+=S-E),w.__size=x,w.__cache={},this}o(g,"prepareUniformsGroup");function y(w,T){let x={boundary:0,storage:0};return typeof w=="number"||typeof w=="boolean"?(x.boundary=4,x.storage=4):w.isVector2?(x.boundary=8,x.storage=8):w.isVector3||w.isColor?(x.boundary=16,x.storage=12):w.isVector4?(x.boundary=16,x.storage=16):w.isMatrix3?(x.boundary=16,x.storage=48):w.isMatrix4?(x.boundary=16,x.storage=64):w.isTexture?Pe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(w)?(x.boundary=16,x.storage=w.byteLength):Pe("WebGLRenderer: Unsupported uniform value type.",w),T===!0&&(x.boundary=16,x.storage=Math.ceil(x.storage/16)*16),x}o(y,"getUniformSize");function m(w){let T=w.target;T.removeEventListener("dispose",m),i.deleteBuffer(r[T.id]),delete r[T.id],delete s[T.id]}o(m,"onUniformsGroupsDispose");function b(){for(let w in r)i.deleteBuffer(r[w]);r={},s={}}return o(b,"dispose"),{bind:a,update:c,dispose:b}}o(C0,"WebGLUniformsGroups");var P0=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),An=null;function I0(){return An===null&&(An=new Vs(P0,16,16,si,mn),An.name="DFG_LUT",An.minFilter=Nt,An.magFilter=Nt,An.wrapS=vn,An.wrapT=vn,An.generateMipmaps=!1,An.needsUpdate=!0),An}o(I0,"getDFGLUT");var Ka=class{static{o(this,"WebGLRenderer")}constructor(e={}){let{canvas:t=vh(),context:n=null,depth:r=!0,stencil:s=!1,alpha:a=!1,antialias:c=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:h=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:p=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Xt}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let y=f,m=new Set([da,ua,ha]),b=new Set([Xt,Kt,Qi,vi,ca,la]),w=new Uint32Array(4),T=new Int32Array(4),x={textures:[],min:[],max:[],resolution:[]},S=null,E=null,_=[],A=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=En,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,F=null,V=null,C=null,q=null;this._outputColorSpace=Vt;let Y=0,W=0,ne=null,X=-1,Q=null,ee=new et,ve=new et,fe=null,z=new qe(0),te=0,xe=t.width,Ee=t.height,me=1,De=null,nt=null,Re=new et(0,0,xe,Ee),Je=new et(0,0,xe,Ee),Ze=!1,ke=new gi,vt=new Hs,dt=!1,Ot=!1,ot=new at,_n=new G,gt=new et,Yt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Jt=!1;function $t(){return ne===null?me:1}o($t,"getTargetPixelRatio");let N=n;function Zt(M,L){return t.getContext(M,L)}o(Zt,"getContext");let rt,st,pe,ft,Ce,Ne,R,v,B,ie,Z,ae,ue,j,J,ce,P,$,K,le,se,oe,Ae;try{let M={alpha:!0,depth:r,stencil:s,antialias:c,premultipliedAlpha:l,preserveDrawingBuffer:h,powerPreference:u,failIfMajorPerformanceCaveat:p};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Te,!1),t.addEventListener("webglcontextrestored",Fe,!1),t.addEventListener("webglcontextcreationerror",ge,!1),N===null){let L="webgl2";if(N=Zt(L,M),N===null)throw Zt(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Oe()}catch(M){throw t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),Ie("WebGLRenderer: "+M.message),M}function Oe(){rt=new Vg(N),rt.init(),se=new w0(N,rt),st=new Ig(N,rt,e,se),pe=new S0(N,rt),st.reversedDepthBuffer&&d&&pe.buffers.depth.setReversed(!0),V=N.createFramebuffer(),C=N.createFramebuffer(),q=N.createFramebuffer(),ft=new qg(N),Ce=new c0,Ne=new M0(N,rt,pe,Ce,st,se,ft),R=new Gg(I),v=new Kf(N),oe=new Cg(N,v),B=new Hg(N,v,ft,oe),ie=new Kg(N,B,v,oe,ft),$=new Xg(N,st,Ne),J=new Lg(Ce),Z=new o0(I,R,rt,st,oe,J),ae=new R0(I,Ce),ue=new h0,j=new g0(rt),P=new Rg(I,R,pe,ie,g,l),ce=new v0(I,ie,st),Ae=new C0(N,ft,st,pe),K=new Pg(N,rt,ft),le=new Wg(N,rt,ft),ft.programs=Z.programs,I.capabilities=st,I.extensions=rt,I.properties=Ce,I.renderLists=ue,I.shadowMap=ce,I.state=pe,I.info=ft}o(Oe,"initGLContext"),y!==Xt&&(U=new Yg(y,t.width,t.height,c,r,s));let re=new Mc(I,N);this.xr=re,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let M=rt.get("WEBGL_lose_context");M&&M.loseContext()},this.forceContextRestore=function(){let M=rt.get("WEBGL_lose_context");M&&M.restoreContext()},this.getPixelRatio=function(){return me},this.setPixelRatio=function(M){M!==void 0&&(me=M,this.setSize(xe,Ee,!1))},this.getSize=function(M){return M.set(xe,Ee)},this.setSize=function(M,L,H=!0){if(re.isPresenting){Pe("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=M,Ee=L,t.width=Math.floor(M*me),t.height=Math.floor(L*me),H===!0&&(t.style.width=M+"px",t.style.height=L+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,M,L)},this.getDrawingBufferSize=function(M){return M.set(xe*me,Ee*me).floor()},this.setDrawingBufferSize=function(M,L,H){xe=M,Ee=L,me=H,t.width=Math.floor(M*H),t.height=Math.floor(L*H),this.setViewport(0,0,M,L)},this.setEffects=function(M){if(y===Xt){Ie("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(M){for(let L=0;L<M.length;L++)if(M[L].isOutputPass===!0){Pe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(M||[])},this.getCurrentViewport=function(M){return M.copy(ee)},this.getViewport=function(M){return M.copy(Re)},this.setViewport=function(M,L,H,O){M.isVector4?Re.set(M.x,M.y,M.z,M.w):Re.set(M,L,H,O),pe.viewport(ee.copy(Re).multiplyScalar($t()).round())},this.getScissor=function(M){return M.copy(Je)},this.setScissor=function(M,L,H,O){M.isVector4?Je.set(M.x,M.y,M.z,M.w):Je.set(M,L,H,O),pe.scissor(ve.copy(Je).multiplyScalar($t()).round())},this.getScissorTest=function(){return Ze},this.setScissorTest=function(M){pe.setScissorTest(Ze=M)},this.setOpaqueSort=function(M){De=M},this.setTransparentSort=function(M){nt=M},this.getClearColor=function(M){return M.copy(P.getClearColor())},this.setClearColor=function(){P.setClearColor(...arguments)},this.getClearAlpha=function(){return P.getClearAlpha()},this.setClearAlpha=function(){P.setClearAlpha(...arguments)},this.clear=function(M=!0,L=!0,H=!0){let O=0;if(M){let k=!1;if(ne!==null){let de=ne.texture.format;k=m.has(de)}if(k){let de=ne.texture.type,ye=b.has(de),he=P.getClearColor(),_e=P.getClearAlpha(),we=he.r,Ue=he.g,ze=he.b;ye?(w[0]=we,w[1]=Ue,w[2]=ze,w[3]=_e,N.clearBufferuiv(N.COLOR,0,w)):(T[0]=we,T[1]=Ue,T[2]=ze,T[3]=_e,N.clearBufferiv(N.COLOR,0,T))}else O|=N.COLOR_BUFFER_BIT}L&&(O|=N.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(O|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),O!==0&&N.clear(O)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(M){M.setRenderer(this),F=M},this.dispose=function(){t.removeEventListener("webglcontextlost",Te,!1),t.removeEventListener("webglcontextrestored",Fe,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),P.dispose(),ue.dispose(),j.dispose(),Ne.dispose(),Ce.dispose(),R.dispose(),ie.dispose(),B.dispose(),oe.dispose(),Ae.dispose(),Z.dispose(),re.dispose(),re.removeEventListener("sessionstart",kc),re.removeEventListener("sessionend",zc),oi.stop()};function Te(M){M.preventDefault(),gr("WebGLRenderer: Context Lost."),D=!0}o(Te,"onContextLost");function Fe(){gr("WebGLRenderer: Context Restored."),D=!1;let M=ft.autoReset,L=ce.enabled,H=ce.autoUpdate,O=ce.needsUpdate,k=ce.type;Oe(),ft.autoReset=M,ce.enabled=L,ce.autoUpdate=H,ce.needsUpdate=O,ce.type=k}o(Fe,"onContextRestore");function ge(M){Ie("WebGLRenderer: A WebGL context could not be created. Reason: ",M.statusMessage)}o(ge,"onContextCreationError");function $e(M){let L=M.target;L.removeEventListener("dispose",$e),bt(L)}o($e,"onMaterialDispose");function bt(M){Hn(M),Ce.remove(M)}o(bt,"deallocateMaterial");function Hn(M){let L=Ce.get(M).programs;L!==void 0&&(L.forEach(function(H){Z.releaseProgram(H)}),M.isShaderMaterial&&Z.releaseShaderCache(M))}o(Hn,"releaseMaterialProgramReferences"),this.renderBufferDirect=function(M,L,H,O,k,de){L===null&&(L=Yt);let ye=k.isMesh&&k.matrixWorld.determinantAffine()<0,he=Bd(M,L,H,O,k);pe.setMaterial(O,ye);let _e=H.index,we=1;if(O.wireframe===!0){if(_e=B.getWireframeAttribute(H),_e===void 0)return;we=2}let Ue=H.drawRange,ze=H.attributes.position,Se=Ue.start*we,Ge=(Ue.start+Ue.count)*we;de!==null&&(Se=Math.max(Se,de.start*we),Ge=Math.min(Ge,(de.start+de.count)*we)),_e!==null?(Se=Math.max(Se,0),Ge=Math.min(Ge,_e.count)):ze!=null&&(Se=Math.max(Se,0),Ge=Math.min(Ge,ze.count));let lt=Ge-Se;if(lt<0||lt===1/0)return;oe.setup(k,O,he,H,_e);let tt,Qe=K;if(_e!==null&&(tt=v.get(_e),Qe=le,Qe.setIndex(tt)),k.isMesh)O.wireframe===!0?(pe.setLineWidth(O.wireframeLinewidth*$t()),Qe.setMode(N.LINES)):Qe.setMode(N.TRIANGLES);else if(k.isLine){let wt=O.linewidth;wt===void 0&&(wt=1),pe.setLineWidth(wt*$t()),k.isLineSegments?Qe.setMode(N.LINES):k.isLineLoop?Qe.setMode(N.LINE_LOOP):Qe.setMode(N.LINE_STRIP)}else k.isPoints?Qe.setMode(N.POINTS):k.isSprite&&Qe.setMode(N.TRIANGLES);if(k.isBatchedMesh)if(rt.get("WEBGL_multi_draw"))Qe.renderMultiDraw(k._multiDrawStarts,k._multiDrawCounts,k._multiDrawCount);else{let wt=k._multiDrawStarts,Me=k._multiDrawCounts,Lt=k._multiDrawCount,Ke=_e?v.get(_e).bytesPerElement:1,ci=Ce.get(O).currentProgram.getUniforms();for(let Et=0;Et<Lt;Et++)ci.setValue(N,"_gl_DrawID",Et),Qe.render(wt[Et]/Ke,Me[Et])}else if(k.isInstancedMesh)Qe.renderInstances(Se,lt,k.count);else if(H.isInstancedBufferGeometry){let wt=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,Me=Math.min(H.instanceCount,wt);Qe.renderInstances(Se,lt,Me)}else Qe.render(Se,lt)};function Bc(M,L,H,O){F!==null&&M.isNodeMaterial&&F.setObject(O,M),dt===!0&&J.setState(M,H,!1),M.transparent===!0&&M.side===rn&&M.forceSinglePass===!1?(M.side=Ft,M.needsUpdate=!0,ir(M,L,O),M.side=ii,M.needsUpdate=!0,ir(M,L,O),M.side=rn):ir(M,L,O)}o(Bc,"prepareMaterial"),this.compile=function(M,L,H=null){H===null&&(H=M),F!==null&&F.renderStart(M,L,H),E=j.get(H),E.init(L),A.push(E),H.traverseVisible(function(k){k.isLight&&k.layers.test(L.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),M!==H&&M.traverseVisible(function(k){k.isLight&&k.layers.test(L.layers)&&(E.pushLight(k),k.castShadow&&E.pushShadow(k))}),E.setupLights(),F!==null&&F.updateLights(E.state.lightsArray),Ot=this.localClippingEnabled,dt=J.init(this.clippingPlanes,Ot),dt===!0&&J.setGlobalState(this.clippingPlanes,L),F!==null&&ce.render(E.state.shadowsArray,H,L);let O=new Set;return M.traverse(function(k){if(!(k.isMesh||k.isPoints||k.isLine||k.isSprite))return;let de=k.material;if(de)if(Array.isArray(de))for(let ye=0;ye<de.length;ye++){let he=de[ye];Bc(he,H,L,k),O.add(he)}else Bc(de,H,L,k),O.add(de)}),E=A.pop(),F!==null&&F.renderEnd(),O},this.compileAsync=function(M,L,H=null){let O=this.compile(M,L,H);return new Promise(k=>{function de(){if(O.forEach(function(ye){let _e=Ce.get(ye).currentProgram;(_e===void 0||_e.isReady())&&O.delete(ye)}),O.size===0){k(M);return}setTimeout(de,10)}o(de,"checkMaterialsReady"),rt.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let so=null;function Fd(M){so&&so(M)}o(Fd,"onAnimationFrame");function kc(){oi.stop()}o(kc,"onXRSessionStart");function zc(){oi.start()}o(zc,"onXRSessionEnd");let oi=new Qh;oi.setAnimationLoop(Fd),typeof self<"u"&&oi.setContext(self),this.setAnimationLoop=function(M){so=M,re.setAnimationLoop(M),M===null?oi.stop():oi.start()},re.addEventListener("sessionstart",kc),re.addEventListener("sessionend",zc),this.render=function(M,L){if(L!==void 0&&L.isCamera!==!0){Ie("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;F!==null&&F.renderStart(M,L);let H=re.enabled===!0&&re.isPresenting===!0,O=U!==null&&(ne===null||H)&&U.begin(I,ne);if(M.matrixWorldAutoUpdate===!0&&M.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),re.enabled===!0&&re.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(re.cameraAutoUpdate===!0&&re.updateCamera(L),L=re.getCamera()),M.isScene===!0&&M.onBeforeRender(I,M,L,ne),E=j.get(M,A.length),E.init(L),E.state.textureUnits=Ne.getTextureUnits(),A.push(E),ot.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?vt.setFromArrayCamera(L):ke.setFromProjectionMatrix(ot,en,L.reversedDepth),Ot=this.localClippingEnabled,dt=J.init(this.clippingPlanes,Ot),S=ue.get(M,_.length),S.init(),_.push(S),this.info.render.frame++,re.enabled===!0&&re.isPresenting===!0){let ye=I.xr.getDepthSensingMesh();ye!==null&&ao(ye,L,-1/0,I.sortObjects)}ao(M,L,0,I.sortObjects),S.finish(),F!==null&&F.updateLights(E.state.lightsArray),I.sortObjects===!0&&S.sort(De,nt),Jt=re.enabled===!1||re.isPresenting===!1||re.hasDepthSensing()===!1,Jt&&P.addToRenderList(S,M),this.info.autoReset===!0&&this.info.reset(),dt===!0&&J.beginShadows();let k=E.state.shadowsArray;if(ce.render(k,M,L),dt===!0&&J.endShadows(),(O&&U.hasRenderPass())===!1){let ye=S.opaque,he=S.transmissive;if(E.setupLights(),L.isArrayCamera){let _e=L.cameras;if(he.length>0)for(let we=0,Ue=_e.length;we<Ue;we++){let ze=_e[we];Vc(ye,he,M,ze)}Jt&&P.render(M);for(let we=0,Ue=_e.length;we<Ue;we++){let ze=_e[we];Gc(S,M,ze,ze.viewport)}}else he.length>0&&Vc(ye,he,M,L),Jt&&P.render(M),Gc(S,M,L)}ne!==null&&W===0&&(Ne.updateMultisampleRenderTarget(ne),Ne.updateRenderTargetMipmap(ne)),O&&U.end(I),M.isScene===!0&&M.onAfterRender(I,M,L),oe.resetDefaultState(),X=-1,Q=null,A.pop(),A.length>0?(E=A[A.length-1],Ne.setTextureUnits(E.state.textureUnits),dt===!0&&J.setGlobalState(I.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?S=_[_.length-1]:S=null,F!==null&&F.renderEnd()};function ao(M,L,H,O){if(M.visible===!1)return;if(M.layers.test(L.layers)){if(M.isGroup)H=M.renderOrder;else if(M.isLOD)M.autoUpdate===!0&&M.update(L);else if(M.isLight)E.pushLight(M),M.castShadow&&E.pushShadow(M);else if(M.isSprite){let ye=L.isArrayCamera?vt:ke;if(!M.frustumCulled||M.intersectsFrustum(ye)){O&&gt.setFromMatrixPosition(M.matrixWorld).applyMatrix4(ot);let he=ie.update(M),_e=M.material;_e.visible&&S.push(M,he,_e,H,gt.z,null,L)}}else if(M.isMesh||M.isLine||M.isPoints){let ye=L.isArrayCamera?vt:ke;if(!M.frustumCulled||M.intersectsFrustum(ye)){let he=ie.update(M),_e=M.material;if(O&&(M.boundingSphere!==void 0?(M.boundingSphere===null&&M.computeBoundingSphere(),gt.copy(M.boundingSphere.center)):(he.boundingSphere===null&&he.computeBoundingSphere(),gt.copy(he.boundingSphere.center)),gt.applyMatrix4(M.matrixWorld).applyMatrix4(ot)),Array.isArray(_e)){let we=he.groups;for(let Ue=0,ze=we.length;Ue<ze;Ue++){let Se=we[Ue],Ge=_e[Se.materialIndex];Ge&&Ge.visible&&S.push(M,he,Ge,H,gt.z,Se,L)}}else _e.visible&&S.push(M,he,_e,H,gt.z,null,L)}}}let de=M.children;for(let ye=0,he=de.length;ye<he;ye++)ao(de[ye],L,H,O)}o(ao,"projectObject");function Gc(M,L,H,O){let{opaque:k,transmissive:de,transparent:ye}=M;E.setupLightsView(H),dt===!0&&J.setGlobalState(I.clippingPlanes,H),O&&pe.viewport(ee.copy(O)),k.length>0&&Yr(k,L,H),de.length>0&&Yr(de,L,H),ye.length>0&&Yr(ye,L,H),pe.buffers.depth.setTest(!0),pe.buffers.depth.setMask(!0),pe.buffers.color.setMask(!0),pe.setPolygonOffset(!1)}o(Gc,"renderScene");function Vc(M,L,H,O){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[O.id]===void 0){let Se=rt.has("EXT_color_buffer_half_float")||rt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[O.id]=new Ct(1,1,{generateMipmaps:!0,type:Se?mn:Xt,minFilter:Bn,samples:Math.max(4,st.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Ve.workingColorSpace})}let de=E.state.transmissionRenderTarget[O.id],ye=O.viewport||ee;de.setSize(ye.z*I.transmissionResolutionScale,ye.w*I.transmissionResolutionScale);let he=I.getRenderTarget(),_e=I.getActiveCubeFace(),we=I.getActiveMipmapLevel();I.setRenderTarget(de),I.getClearColor(z),te=I.getClearAlpha(),te<1&&I.setClearColor(16777215,.5),I.clear(),Jt&&P.render(H);let Ue=I.toneMapping;I.toneMapping=En;let ze=O.viewport;if(O.viewport!==void 0&&(O.viewport=void 0),E.setupLightsView(O),dt===!0&&J.setGlobalState(I.clippingPlanes,O),Yr(M,H,O),Ne.updateMultisampleRenderTarget(de),Ne.updateRenderTargetMipmap(de),rt.has("WEBGL_multisampled_render_to_texture")===!1){let Se=!1;for(let Ge=0,lt=L.length;Ge<lt;Ge++){let tt=L[Ge],{object:Qe,geometry:wt,material:Me,group:Lt}=tt;if(Me.side===rn&&Qe.layers.test(O.layers)){let Ke=Me.side;Me.side=Ft,Me.needsUpdate=!0,Hc(Qe,H,O,wt,Me,Lt),Me.side=Ke,Me.needsUpdate=!0,Se=!0}}Se===!0&&(Ne.updateMultisampleRenderTarget(de),Ne.updateRenderTargetMipmap(de))}I.setRenderTarget(he,_e,we),I.setClearColor(z,te),ze!==void 0&&(O.viewport=ze),I.toneMapping=Ue}o(Vc,"renderTransmissionPass");function Yr(M,L,H){let O=L.isScene===!0?L.overrideMaterial:null;for(let k=0,de=M.length;k<de;k++){let ye=M[k],{object:he,geometry:_e,group:we}=ye,Ue=ye.material;Ue.allowOverride===!0&&O!==null&&(Ue=O),he.layers.test(H.layers)&&Hc(he,L,H,_e,Ue,we)}}o(Yr,"renderObjects");function Hc(M,L,H,O,k,de){F!==null&&k.isNodeMaterial&&F.setObject(M,k),M.onBeforeRender(I,L,H,O,k,de),M.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,M.matrixWorld),M.normalMatrix.getNormalMatrix(M.modelViewMatrix),k.onBeforeRender(I,L,H,O,M,de),k.transparent===!0&&k.side===rn&&k.forceSinglePass===!1?(k.side=Ft,k.needsUpdate=!0,I.renderBufferDirect(H,L,O,k,M,de),k.side=ii,k.needsUpdate=!0,I.renderBufferDirect(H,L,O,k,M,de),k.side=rn):I.renderBufferDirect(H,L,O,k,M,de),M.onAfterRender(I,L,H,O,k,de)}o(Hc,"renderObject");function Wc(M){let L=0;for(let H of M)H.texture!==null&&L++;return L}o(Wc,"countLightProbeGrids");function ir(M,L,H){L.isScene!==!0&&(L=Yt);let O=Ce.get(M),k=E.state.lights,de=E.state.shadowsArray,ye=k.state.version,he=Z.getParameters(M,k.state,de,L,H,E.state.lightProbeGridArray),_e=Z.getProgramCacheKey(he),we=O.programs;O.environment=M.isMeshStandardMaterial||M.isMeshLambertMaterial||M.isMeshPhongMaterial?L.environment:null,O.fog=L.fog;let Ue=M.isMeshStandardMaterial||M.isMeshLambertMaterial&&!M.envMap||M.isMeshPhongMaterial&&!M.envMap;O.envMap=R.get(M.envMap||O.environment,Ue),O.envMapRotation=O.environment!==null&&M.envMap===null?L.environmentRotation:M.envMapRotation,we===void 0&&(M.addEventListener("dispose",$e),we=new Map,O.programs=we,O.programVariants=new Map);let ze=we.get(_e);if(ze!==void 0){if(O.currentProgram===ze&&O.lightsStateVersion===ye)return Xc(M,he),ze}else he.uniforms=Z.getUniforms(M),F!==null&&M.isNodeMaterial&&F.build(M,H,he),M.onBeforeCompile(he,I),ze=Z.acquireProgram(he,_e),we.set(_e,ze),O.uniforms=he.uniforms;let Se=O.uniforms;return(!M.isShaderMaterial&&!M.isRawShaderMaterial||M.clipping===!0)&&(Se.clippingPlanes=J.uniform),Xc(M,he),O.needsLights=zd(M),O.lightsStateVersion=ye,O.needsLights&&(Se.ambientLightColor.value=k.state.ambient,Se.lightProbe.value=k.state.probe,Se.sunLights.value=k.state.sun,Se.sunLightShadows.value=k.state.sunShadow,Se.directionalLights.value=k.state.directional,Se.directionalLightShadows.value=k.state.directionalShadow,Se.spotLights.value=k.state.spot,Se.spotLightShadows.value=k.state.spotShadow,Se.rectAreaLights.value=k.state.rectArea,Se.ltc_1.value=k.state.rectAreaLTC1,Se.ltc_2.value=k.state.rectAreaLTC2,Se.pointLights.value=k.state.point,Se.pointLightShadows.value=k.state.pointShadow,Se.hemisphereLights.value=k.state.hemi,Se.sunShadowMatrix.value=k.state.sunShadowMatrix,Se.sunShadowCascade.value=k.state.sunShadowCascade,Se.directionalShadowMatrix.value=k.state.directionalShadowMatrix,Se.spotLightMatrix.value=k.state.spotLightMatrix,Se.spotLightMap.value=k.state.spotLightMap,Se.pointShadowMatrix.value=k.state.pointShadowMatrix),O.numLightProbeGrids=Wc(E.state.lightProbeGridArray),O.currentProgram=ze,O.uniformsList=null,ze}o(ir,"getProgram");function Od(M,L,H,O,k){let de=Ce.get(M),ye=de.currentProgram.id+","+O+","+k,he=de.programVariants.get(ye);return he===void 0?(he=ir(M,L,H),de.programVariants.set(ye,he)):(de.currentProgram=he,de.uniformsList=null,de.outputColorSpace=O,de.toneMapping=k),he}o(Od,"getProgramVariant");function qc(M){if(M.uniformsList===null){let L=M.currentProgram.getUniforms();M.uniformsList=er.seqWithValue(L.seq,M.uniforms)}return M.uniformsList}o(qc,"getUniformList");function Xc(M,L){let H=Ce.get(M);H.outputColorSpace=L.outputColorSpace,H.batching=L.batching,H.batchingColor=L.batchingColor,H.instancing=L.instancing,H.instancingColor=L.instancingColor,H.instancingMorph=L.instancingMorph,H.skinning=L.skinning,H.morphTargets=L.morphTargets,H.morphNormals=L.morphNormals,H.morphColors=L.morphColors,H.morphTargetsCount=L.morphTargetsCount,H.numClippingPlanes=L.numClippingPlanes,H.numIntersection=L.numClipIntersection,H.vertexAlphas=L.vertexAlphas,H.vertexTangents=L.vertexTangents,H.toneMapping=L.toneMapping}o(Xc,"updateCommonMaterialProperties");function Bd(M,L,H,O,k){L.isScene!==!0&&(L=Yt),Ne.resetTextureUnits();let de=L.fog,ye=O.isMeshStandardMaterial||O.isMeshLambertMaterial||O.isMeshPhongMaterial?L.environment:null,he=ne===null?I.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:Ve.workingColorSpace,_e=O.isMeshStandardMaterial||O.isMeshLambertMaterial&&!O.envMap||O.isMeshPhongMaterial&&!O.envMap,we=R.get(O.envMap||ye,_e),Ue=O.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,ze=!!H.attributes.tangent&&(!!O.normalMap||O.anisotropy>0),Se=!!H.morphAttributes.position,Ge=!!H.morphAttributes.normal,lt=!!H.morphAttributes.color,tt=En;O.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(tt=I.toneMapping);let Qe=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,wt=Qe!==void 0?Qe.length:0,Me=Ce.get(O),Lt=E.state.lights;if(dt===!0&&(Ot===!0||M!==Q)){let ct=M===Q&&O.id===X;J.setState(O,M,ct)}let Ke=!1,ci=!1;O.version===Me.__version?Me.needsLights&&Me.lightsStateVersion!==Lt.state.version||k.isBatchedMesh&&Me.batching===!1||!k.isBatchedMesh&&Me.batching===!0||k.isBatchedMesh&&Me.batchingColor===!0&&k._colorsTexture===null||k.isBatchedMesh&&Me.batchingColor===!1&&k._colorsTexture!==null||k.isInstancedMesh&&Me.instancing===!1||!k.isInstancedMesh&&Me.instancing===!0||k.isSkinnedMesh&&Me.skinning===!1||!k.isSkinnedMesh&&Me.skinning===!0||k.isInstancedMesh&&Me.instancingColor===!0&&k.instanceColor===null||k.isInstancedMesh&&Me.instancingColor===!1&&k.instanceColor!==null||k.isInstancedMesh&&Me.instancingMorph===!0&&k.morphTexture===null||k.isInstancedMesh&&Me.instancingMorph===!1&&k.morphTexture!==null||Me.envMap!==we||O.fog===!0&&Me.fog!==de||Me.numClippingPlanes!==void 0&&(Me.numClippingPlanes!==J.numPlanes||Me.numIntersection!==J.numIntersection)||Me.vertexAlphas!==Ue||Me.vertexTangents!==ze||Me.morphTargets!==Se||Me.morphNormals!==Ge||Me.morphColors!==lt||Me.morphTargetsCount!==wt||Me.numLightProbeGrids!==Wc(E.state.lightProbeGridArray)?Ke=!0:(Me.outputColorSpace!==he||Me.toneMapping!==tt)&&(ci=!0):(Ke=!0,Me.__version=O.version);let Et=Me.currentProgram;(Ke===!0||ci===!0)&&(Et=ci===!0?Od(O,L,k,he,tt):ir(O,L,k),F&&O.isNodeMaterial&&F.onUpdateProgram(O,Et,Me));let Jr=!1,Wn=!1,li=!1,We=Et.getUniforms(),St=Me.uniforms;if(pe.useProgram(Et.program)&&(Jr=!0,Wn=!0,li=!0),O.id!==X&&(X=O.id,Wn=!0),Jr||Q!==M){pe.buffers.depth.getReversed()&&M.reversedDepth!==!0&&(M._reversedDepth=!0,M.updateProjectionMatrix()),We.setValue(N,"projectionMatrix",M.projectionMatrix),We.setValue(N,"viewMatrix",M.matrixWorldInverse);let _t=We.map.cameraPosition;_t!==void 0&&_t.setValue(N,_n.setFromMatrixPosition(M.matrixWorld)),st.logarithmicDepthBuffer&&We.setValue(N,"logDepthBufFC",2/(Math.log(M.far+1)/Math.LN2)),(O.isMeshPhongMaterial||O.isMeshToonMaterial||O.isMeshLambertMaterial||O.isMeshBasicMaterial||O.isMeshStandardMaterial||O.isShaderMaterial)&&We.setValue(N,"isOrthographic",M.isOrthographicCamera===!0),Q!==M&&(Q=M,Wn=!0,li=!0)}if(Me.needsLights&&(Lt.state.sunShadowMap.length>0&&We.setValue(N,"sunShadowMap",Lt.state.sunShadowMap,Ne),Lt.state.directionalShadowMap.length>0&&We.setValue(N,"directionalShadowMap",Lt.state.directionalShadowMap,Ne),Lt.state.spotShadowMap.length>0&&We.setValue(N,"spotShadowMap",Lt.state.spotShadowMap,Ne),Lt.state.pointShadowMap.length>0&&We.setValue(N,"pointShadowMap",Lt.state.pointShadowMap,Ne)),k.isSkinnedMesh){We.setOptional(N,k,"bindMatrix"),We.setOptional(N,k,"bindMatrixInverse");let ct=k.skeleton;ct&&(ct.boneTexture===null&&ct.computeBoneTexture(),We.setValue(N,"boneTexture",ct.boneTexture,Ne))}k.isBatchedMesh&&(We.setOptional(N,k,"batchingTexture"),We.setValue(N,"batchingTexture",k._matricesTexture,Ne),We.setOptional(N,k,"batchingIdTexture"),We.setValue(N,"batchingIdTexture",k._indirectTexture,Ne),We.setOptional(N,k,"batchingColorTexture"),k._colorsTexture!==null&&We.setValue(N,"batchingColorTexture",k._colorsTexture,Ne));let an=H.morphAttributes;if((an.position!==void 0||an.normal!==void 0||an.color!==void 0)&&$.update(k,H,Et),(Wn||Me.receiveShadow!==k.receiveShadow)&&(Me.receiveShadow=k.receiveShadow,We.setValue(N,"receiveShadow",k.receiveShadow)),(O.isMeshStandardMaterial||O.isMeshLambertMaterial||O.isMeshPhongMaterial)&&O.envMap===null&&L.environment!==null&&(St.envMapIntensity.value=L.environmentIntensity),St.dfgLUT!==void 0&&(St.dfgLUT.value=I0()),Wn){if(We.setValue(N,"toneMappingExposure",I.toneMappingExposure),Me.needsLights&&kd(St,li),de&&O.fog===!0&&ae.refreshFogUniforms(St,de),ae.refreshMaterialUniforms(St,O,me,Ee,E.state.transmissionRenderTarget[M.id]),Me.needsLights&&Me.numLightProbeGrids>0){let ct=x,_t=0;for(let Rn of E.state.lightProbeGridArray)Rn.texture!==null&&(ct.textures[_t]=Rn.texture,ct.min[_t]=Rn.boundingBox.min,ct.max[_t]=Rn.boundingBox.max,ct.resolution[_t]=Rn.resolution,_t++);for(let Rn in ct)ct[Rn].length=_t;St.probesSH.value=ct.textures,St.probesMin.value=ct.min,St.probesMax.value=ct.max,St.probesResolution.value=ct.resolution}er.upload(N,qc(Me),St,Ne)}if(O.isShaderMaterial&&O.uniformsNeedUpdate===!0&&(er.upload(N,qc(Me),St,Ne),O.uniformsNeedUpdate=!1),O.isSpriteMaterial&&We.setValue(N,"center",k.center),We.setValue(N,"modelViewMatrix",k.modelViewMatrix),We.setValue(N,"normalMatrix",k.normalMatrix),We.setValue(N,"modelMatrix",k.matrixWorld),O.uniformsGroups!==void 0){let ct=O.uniformsGroups;for(let _t=0,Rn=ct.length;_t<Rn;_t++){let jc=ct[_t];Ae.update(jc,Et),Ae.bind(jc,Et)}}return Et}o(Bd,"setProgram");function kd(M,L){M.ambientLightColor.needsUpdate=L,M.lightProbe.needsUpdate=L,M.sunLights.needsUpdate=L,M.sunLightShadows.needsUpdate=L,M.directionalLights.needsUpdate=L,M.directionalLightShadows.needsUpdate=L,M.pointLights.needsUpdate=L,M.pointLightShadows.needsUpdate=L,M.spotLights.needsUpdate=L,M.spotLightShadows.needsUpdate=L,M.rectAreaLights.needsUpdate=L,M.hemisphereLights.needsUpdate=L}o(kd,"markUniformsLightsNeedsUpdate");function zd(M){return M.isMeshLambertMaterial||M.isMeshToonMaterial||M.isMeshPhongMaterial||M.isMeshStandardMaterial||M.isShadowMaterial||M.isShaderMaterial&&M.lights===!0}o(zd,"materialNeedsLights"),this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ne},this.setRenderTargetTextures=function(M,L,H){let O=Ce.get(M);O.__autoAllocateDepthBuffer=M.resolveDepthBuffer===!1,O.__autoAllocateDepthBuffer===!1&&(O.__useRenderToTexture=!1),Ce.get(M.texture).__webglTexture=L,Ce.get(M.depthTexture).__webglTexture=O.__autoAllocateDepthBuffer?void 0:H,O.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(M,L){let H=Ce.get(M);H.__webglFramebuffer=L,H.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(M,L=0,H=0){ne=M,Y=L,W=H;let O=null,k=!1,de=!1;if(M){let he=Ce.get(M);if(he.__useDefaultFramebuffer!==void 0){pe.bindFramebuffer(N.FRAMEBUFFER,he.__webglFramebuffer),ee.copy(M.viewport),ve.copy(M.scissor),fe=M.scissorTest,pe.viewport(ee),pe.scissor(ve),pe.setScissorTest(fe),X=-1;return}else if(he.__webglFramebuffer===void 0)Ne.setupRenderTarget(M);else if(he.__hasExternalTextures)Ne.rebindTextures(M,Ce.get(M.texture).__webglTexture,Ce.get(M.depthTexture).__webglTexture);else if(M.depthBuffer){let Ue=M.depthTexture;if(he.__boundDepthTexture!==Ue){if(Ue!==null&&Ce.has(Ue)&&(M.width!==Ue.image.width||M.height!==Ue.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ne.setupDepthRenderbuffer(M)}}let _e=M.texture;(_e.isData3DTexture||_e.isDataArrayTexture||_e.isCompressedArrayTexture)&&(de=!0);let we=Ce.get(M).__webglFramebuffer;M.isWebGLCubeRenderTarget?(Array.isArray(we[L])?O=we[L][H]:O=we[L],k=!0):M.samples>0&&Ne.useMultisampledRTT(M)===!1?O=Ce.get(M).__webglMultisampledFramebuffer:Array.isArray(we)?O=we[H]:O=we,ee.copy(M.viewport),ve.copy(M.scissor),fe=M.scissorTest}else ee.copy(Re).multiplyScalar(me).floor(),ve.copy(Je).multiplyScalar(me).floor(),fe=Ze;if(H!==0&&(O=V),pe.bindFramebuffer(N.FRAMEBUFFER,O)&&pe.drawBuffers(M,O),pe.viewport(ee),pe.scissor(ve),pe.setScissorTest(fe),k){let he=Ce.get(M.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+L,he.__webglTexture,H)}else if(de){let he=L;for(let _e=0;_e<M.textures.length;_e++){let we=Ce.get(M.textures[_e]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+_e,we.__webglTexture,H,he)}}else if(M!==null&&H!==0){let he=Ce.get(M.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,he.__webglTexture,H)}X=-1};function Kc(M){let L=Ce.get(M);return(L.__readFormat!==M.format||L.__readType!==M.type)&&(L.__readFormat=M.format,L.__readType=M.type,L.__formatReadable=st.textureFormatReadable(M.format),L.__typeReadable=st.textureTypeReadable(M.type)),L}o(Kc,"getReadableState"),this.readRenderTargetPixels=function(M,L,H,O,k,de,ye,he=0){if(!(M&&M.isWebGLRenderTarget)){Ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _e=Ce.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&ye!==void 0&&(_e=_e[ye],Array.isArray(_e)&&(_e=_e[0])),_e){pe.bindFramebuffer(N.FRAMEBUFFER,_e);try{let we=M.textures[he],Ue=we.format,ze=we.type;M.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+he);let Se=Kc(we);if(Se.__formatReadable===!1){Ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Se.__typeReadable===!1){Ie("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=M.width-O&&H>=0&&H<=M.height-k&&N.readPixels(L,H,O,k,se.convert(Ue),se.convert(ze),de)}finally{let we=ne!==null?Ce.get(ne).__webglFramebuffer:null;pe.bindFramebuffer(N.FRAMEBUFFER,we)}}},this.readRenderTargetPixelsAsync=async function(M,L,H,O,k,de,ye,he=0){if(!(M&&M.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _e=Ce.get(M).__webglFramebuffer;if(M.isWebGLCubeRenderTarget&&ye!==void 0&&(_e=_e[ye],Array.isArray(_e)&&(_e=_e[0])),_e)if(L>=0&&L<=M.width-O&&H>=0&&H<=M.height-k){pe.bindFramebuffer(N.FRAMEBUFFER,_e);let we=M.textures[he],Ue=we.format,ze=we.type;M.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+he);let Se=Kc(we);if(Se.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Se.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ge=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,Ge),N.bufferData(N.PIXEL_PACK_BUFFER,de.byteLength,N.STREAM_READ),N.readPixels(L,H,O,k,se.convert(Ue),se.convert(ze),0),N.bindBuffer(N.PIXEL_PACK_BUFFER,null);let lt=ne!==null?Ce.get(ne).__webglFramebuffer:null;pe.bindFramebuffer(N.FRAMEBUFFER,lt);let tt=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await Mh(N,tt,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,Ge),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,de),N.bindBuffer(N.PIXEL_PACK_BUFFER,null),N.deleteBuffer(Ge),N.deleteSync(tt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(M,L=null,H=0){let O=Math.pow(2,-H),k=Math.floor(M.image.width*O),de=Math.floor(M.image.height*O),ye=L!==null?L.x:0,he=L!==null?L.y:0;Ne.setTexture2D(M,0),N.copyTexSubImage2D(N.TEXTURE_2D,H,0,0,ye,he,k,de),pe.unbindTexture()},this.copyTextureToTexture=function(M,L,H=null,O=null,k=0,de=0){let ye,he,_e,we,Ue,ze,Se,Ge,lt,tt=M.isCompressedTexture?M.mipmaps[de]:M.image;if(H!==null)ye=H.max.x-H.min.x,he=H.max.y-H.min.y,_e=H.isBox3?H.max.z-H.min.z:1,we=H.min.x,Ue=H.min.y,ze=H.isBox3?H.min.z:0;else{let We=Math.pow(2,-k);ye=Math.floor(tt.width*We),he=Math.floor(tt.height*We),M.isDataArrayTexture?_e=tt.depth:M.isData3DTexture?_e=Math.floor(tt.depth*We):_e=1,we=0,Ue=0,ze=0}O!==null?(Se=O.x,Ge=O.y,lt=O.z):(Se=0,Ge=0,lt=0);let Qe=se.convert(L.format),wt=se.convert(L.type),Me;L.isData3DTexture?(Ne.setTexture3D(L,0),Me=N.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(Ne.setTexture2DArray(L,0),Me=N.TEXTURE_2D_ARRAY):(Ne.setTexture2D(L,0),Me=N.TEXTURE_2D),pe.activeTexture(N.TEXTURE0),pe.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,L.flipY),pe.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),pe.pixelStorei(N.UNPACK_ALIGNMENT,L.unpackAlignment);let Lt=pe.getParameter(N.UNPACK_ROW_LENGTH),Ke=pe.getParameter(N.UNPACK_IMAGE_HEIGHT),ci=pe.getParameter(N.UNPACK_SKIP_PIXELS),Et=pe.getParameter(N.UNPACK_SKIP_ROWS),Jr=pe.getParameter(N.UNPACK_SKIP_IMAGES);pe.pixelStorei(N.UNPACK_ROW_LENGTH,tt.width),pe.pixelStorei(N.UNPACK_IMAGE_HEIGHT,tt.height),pe.pixelStorei(N.UNPACK_SKIP_PIXELS,we),pe.pixelStorei(N.UNPACK_SKIP_ROWS,Ue),pe.pixelStorei(N.UNPACK_SKIP_IMAGES,ze);let Wn=M.isDataArrayTexture||M.isData3DTexture,li=L.isDataArrayTexture||L.isData3DTexture;if(M.isDepthTexture){let We=Ce.get(M),St=Ce.get(L),an=Ce.get(We.__renderTarget),ct=Ce.get(St.__renderTarget);pe.bindFramebuffer(N.READ_FRAMEBUFFER,an.__webglFramebuffer),pe.bindFramebuffer(N.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let _t=0;_t<_e;_t++)Wn&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Ce.get(M).__webglTexture,k,ze+_t),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Ce.get(L).__webglTexture,de,lt+_t)),N.blitFramebuffer(we,Ue,we+ye,Ue+he,Se,Ge,Se+ye,Ge+he,N.DEPTH_BUFFER_BIT,N.NEAREST);pe.bindFramebuffer(N.READ_FRAMEBUFFER,null),pe.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(k!==0||M.isRenderTargetTexture||Ce.has(M)){let We=Ce.get(M),St=Ce.get(L);pe.bindFramebuffer(N.READ_FRAMEBUFFER,C),pe.bindFramebuffer(N.DRAW_FRAMEBUFFER,q);for(let an=0;an<_e;an++)Wn?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,We.__webglTexture,k,ze+an):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,We.__webglTexture,k),li?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,St.__webglTexture,de,lt+an):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,St.__webglTexture,de),k!==0?N.blitFramebuffer(we,Ue,we+ye,Ue+he,Se,Ge,Se+ye,Ge+he,N.COLOR_BUFFER_BIT,N.NEAREST):li?N.copyTexSubImage3D(Me,de,Se,Ge,lt+an,we,Ue,ye,he):N.copyTexSubImage2D(Me,de,Se,Ge,we,Ue,ye,he);pe.bindFramebuffer(N.READ_FRAMEBUFFER,null),pe.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else li?M.isDataTexture||M.isData3DTexture?N.texSubImage3D(Me,de,Se,Ge,lt,ye,he,_e,Qe,wt,tt.data):L.isCompressedArrayTexture?N.compressedTexSubImage3D(Me,de,Se,Ge,lt,ye,he,_e,Qe,tt.data):N.texSubImage3D(Me,de,Se,Ge,lt,ye,he,_e,Qe,wt,tt):M.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,de,Se,Ge,ye,he,Qe,wt,tt.data):M.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,de,Se,Ge,tt.width,tt.height,Qe,tt.data):N.texSubImage2D(N.TEXTURE_2D,de,Se,Ge,ye,he,Qe,wt,tt);pe.pixelStorei(N.UNPACK_ROW_LENGTH,Lt),pe.pixelStorei(N.UNPACK_IMAGE_HEIGHT,Ke),pe.pixelStorei(N.UNPACK_SKIP_PIXELS,ci),pe.pixelStorei(N.UNPACK_SKIP_ROWS,Et),pe.pixelStorei(N.UNPACK_SKIP_IMAGES,Jr),de===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&N.generateMipmap(Me),pe.unbindTexture()},this.initRenderTarget=function(M){Ce.get(M).__webglFramebuffer===void 0&&Ne.setupRenderTarget(M)},this.initTexture=function(M){M.isCubeTexture?Ne.setTextureCube(M,0):M.isData3DTexture?Ne.setTexture3D(M,0):M.isDataArrayTexture||M.isCompressedArrayTexture?Ne.setTexture2DArray(M,0):Ne.setTexture2D(M,0),pe.unbindTexture()},this.resetState=function(){Y=0,W=0,ne=null,pe.reset(),oe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return en}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Ve._getDrawingBufferColorSpace(e),t.unpackColorSpace=Ve._getUnpackColorSpace()}};var[L0,D0,N0]=[.5,.05,3e4];function hu(i,e,t,n,r){let s=new Mt(L0,1,D0,N0);s.position.set(...t),s.lookAt(new G(...t).add(new G(...n))),s.updateMatrixWorld(!0);let{enabled:a}=i.xr;i.xr.enabled=!1;try{return e.pick(s,[.5,.5],()=>r(s))?.distanceTo(s.position)??null}finally{i.xr.enabled=a}}o(hu,"castRay");function Vr({geometry:i,parts:e}){return i===null?[]:[i,...e]}o(Vr,"filesOfGeometry");function Ja(i){return i?[i.color,i.range].flat().filter(e=>e!==null):[]}o(Ja,"filesOfMap");function Hr(i){return[...Vr(i),...Ja(i.map),...(i.sharper?.maps??[]).flatMap(Ja)]}o(Hr,"filesOfRing");function wc({dynamic:i},{rings:e}){let t=i?Vr(i):[];return new Set([...t,...e.flatMap(Hr)])}o(wc,"filesOfRegion");function uu({files:i},e){let t=0;for(let n of e)t+=i[n]?.bytes??0;return t}o(uu,"bytesOf");function du(i,e,t=16777216){let n=new Map,r=0;return{fetch(s,a){let c=n.get(s);return c?(n.delete(s),r-=e(s),c):i(s,a)},want(s,a){for(let c of s){if(n.has(c)||r+e(c)>t)continue;let l=i(c,a);l.catch(()=>{}),n.set(c,l),r+=e(c)}},get bytes(){return r}}}o(du,"createAhead");function Mi(i,e){let t=e===null?[]:typeof e=="string"?[e]:e;return Promise.all(t.map(n=>$a(i,n)))}o(Mi,"filesOf");async function $a({ahead:i,manifest:e,signal:t},n){let r=e.files[n];if(!r)throw new Error(`${n} is not listed in the manifest`);return{name:n,data:await i.fetch(n,t),bytes:r.bytes,sha256:r.sha256}}o($a,"fileOf");var U0={map:.2,picture:.2,arrays:.1,mesh:.5,program:2.5},F0=.15,O0=4;function fu(){let i=new Map,e=o(n=>i.get(n)??U0[n],"unit"),t=o(n=>1+n/65536,"units");return{expected:o(({kind:n,bytes:r})=>e(n)*t(r),"expected"),learn({kind:n,bytes:r},s){let a=e(n),c=Math.min(s/t(r),O0*a);i.set(n,a+F0*(c-a))}}}o(fu,"createCosts");function Za(i){let e=[],t=0;function n(r){for(let s=e[0];s;s=e[0]){if(r.getSyncParameter(s.sync,r.SYNC_STATUS)!==r.SIGNALED)return;r.deleteSync(s.sync),e.shift()}}return o(n,"settle"),{send(r){t+=r},hasRoom(r){if(!i||r===0)return!0;n(i);let s=e.reduce((a,c)=>a+c.bytes,t);return s===0||s+r<=8388608},mark(){if(i&&t>0){let r=i.fenceSync(i.SYNC_GPU_COMMANDS_COMPLETE,0);r&&e.push({sync:r,bytes:t}),i.flush()}t=0},forget(){e=[],t=0}}}o(Za,"createFlight");var Wr=2**18;function pu(i=()=>performance.now(),e=Za(null)){let t=[],n=fu(),r=0;function s(){for(let h=t[0];h;h=t[0])try{if(h.signal.throwIfAborted(),h.next??=B0(h),h.next)return{job:h,step:h.next};a(h),h.done()}catch(u){c(h,u)}return null}o(s,"next");function a(h){t.splice(t.indexOf(h),1)}o(a,"end");function c(h,u){a(h),h.steps.return?.(),h.failed(u)}o(c,"fail");function l({job:h,step:u}){let p=i();h.next=null,e.send(u.bytes);try{u.run()}catch(d){c(h,d)}n.learn(u,i()-p)}return o(l,"take"),{add(h,u,p=!1){return new Promise((d,f)=>{let g={steps:h[Symbol.iterator](),signal:u,done:d,failed:f,next:null};p?t.unshift(g):t.push(g)})},spend(h){r+=h},run(h){let u=i()-r,p=r===0;r=0;for(let d=s();d;d=s()){let{step:f}=d;if(i()-u+n.expected(f)>h&&!p||!e.hasRoom(f.bytes))break;l(d),p=!1}return e.mark(),i()-u},forget:e.forget}}o(pu,"createUploads");function B0(i){let{done:e,value:t}=i.steps.next();return e?null:t}o(B0,"following");var k0=6,z0={least:1,step:1};function wi(i,e,t=z0){let n=i.getContext(),r=gu(i,mu(n,e,n.SRGB8_ALPHA8,n.LINEAR)),s=gu(i,mu(n,e,n.R16UI,n.NEAREST));return i.resetState(),{color:r,codes:s,holds:null,hasRange:!1,size:e,scale:t,dispose(){for(let a of[r,s])n.deleteTexture(_u(i,a)),i.properties.remove(a)}}}o(wi,"createCube");function mu(i,e,t,n){let r=i.createTexture();return i.bindTexture(i.TEXTURE_CUBE_MAP,r),i.texStorage2D(i.TEXTURE_CUBE_MAP,1,t,e,e),i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MIN_FILTER,n),i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAG_FILTER,n),r}o(mu,"allocated");function gu(i,e){let t=new bi;return i.properties.get(t).__webglTexture=e,t}o(gu,"wrapped");function _u(i,e){return i.properties.get(e).__webglTexture}o(_u,"handleOf");function*eo(i,e,t,n,r){let s=i.getContext(),{face_size:a,tile:c}=r;if(e.holds=null,t.whole){for(let l=0;l<k0;l++){let h={face:l,x:0,y:0,width:a,height:a};yield*Qa(i,s,e.color,h,bu(t.color,l)),t.codes&&(yield*Qa(i,s,e.codes,h,bu(t.codes,l)))}e.hasRange=t.codes!==null}else{let l=a/c,h=c*c;for(let u=0;u<t.tiles.length;u++){let p=t.tiles[u]??0,d=Math.floor(p/(l*l)),f=p%(l*l),g={face:d,x:f%l*c,y:Math.floor(f/l)*c,width:c,height:c};yield*Qa(i,s,e.color,g,t.color.subarray(4*u*h,4*(u+1)*h)),yield*Qa(i,s,e.codes,g,t.codes.subarray(u*h,(u+1)*h))}}e.holds=n}o(eo,"cubeSteps");function bu(i,e){let t=i[e];if(!t)throw new Error("a map has fewer than six faces");return t}o(bu,"faceOf");function*Qa(i,e,t,n,r){let s=r.length/n.height,a=Math.max(Math.floor(Wr/(s*r.BYTES_PER_ELEMENT)),1);for(let c=0;c<n.height;c+=a){let l={...n,y:n.y+c,height:Math.min(a,n.height-c)},h=r.subarray(c*s,(c+l.height)*s);yield{kind:"map",bytes:h.byteLength,run:o(()=>G0(i,e,t,l,h),"run")}}}o(Qa,"boxSteps");function G0(i,e,t,{face:n,x:r,y:s,width:a,height:c},l){let{state:h}=i;h.activeTexture(e.TEXTURE0),h.bindTexture(e.TEXTURE_CUBE_MAP,_u(i,t)),h.pixelStorei(e.UNPACK_FLIP_Y_WEBGL,!1),h.pixelStorei(e.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),h.pixelStorei(e.UNPACK_ALIGNMENT,1);let u=e.TEXTURE_CUBE_MAP_POSITIVE_X+n,[p,d]=l instanceof Uint8Array?[e.RGBA,e.UNSIGNED_BYTE]:[e.RED_INTEGER,e.UNSIGNED_SHORT];e.texSubImage2D(u,0,r,s,a,c,p,d,l),h.pixelStorei(e.UNPACK_ALIGNMENT,4)}o(G0,"put");var V0={SUN_DIRECTION:[.5263158,.7894737,.3157895],SUN:[.6,.56,.5],SKY_DIRECTION:[-.2062843,.9282791,.3094264],SKY_LOW:[.13,.135,.15],SKY_HIGH:[.38,.42,.48],HORIZON:[.66,.74,.82],ZENITH:[.16,.34,.66],NADIR:[.24,.25,.26]},xu=["SUN_DIRECTION","SUN","SKY_DIRECTION","SKY_LOW","SKY_HIGH"],yu=["HORIZON","ZENITH","NADIR"],H0=o(i=>Number.isInteger(i)?i.toFixed(1):String(i),"float"),vu=o(i=>V0[i].map(H0).join(", "),"vector"),Su=o(i=>i.map(e=>`const vec3 ${e} = vec3(${vu(e)});`).join(`
`),"glsl"),W0=o(i=>i.map(e=>`const ${e} = vec3<f32>(${vu(e)});`).join(`
`),"wgsl"),Mu=`
${Su(xu)}

vec3 irradiance(vec3 n) {
  float sky = 0.5 + 0.5 * dot(n, SKY_DIRECTION);
  return SKY_LOW + (SKY_HIGH - SKY_LOW) * sky + SUN * max(dot(n, SUN_DIRECTION), 0.0);
}
`,lw=`
${Su(yu)}

vec3 background(vec3 direction) {
  return mix(HORIZON, direction.y < 0.0 ? NADIR : ZENITH, sqrt(abs(direction.y)));
}
`,to=`
vec3 srgb_of(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}
`;var hw=`
${W0([...xu,...yu])}

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
`;var wu=`struct Place {
    vec2 at;
    float rho;
};
struct Zones {
    float stays;
    float r2_;
    float slope;
    float strength;
};
const float OPPOSED = 1e-6;
const float FAR_SQUARED = 1e28;

float user_weight(float rho, float r2_, float slope) {
    return clamp(((r2_ - rho) * slope), 0.0, 1.0);
}

vec4 blended(vec3 from_user, vec3 from_center, float w) {
    vec3 direction = vec3(0.0);
    float by_user = length(from_user);
    float by_center = length(from_center);
    vec3 user_direction = (from_user / vec3(max(by_user, 1e-30)));
    vec3 mixed = ((w * user_direction) + (((1.0 - w) * from_center) / vec3(max(by_center, 1e-30))));
    float size = length(mixed);
    direction = user_direction;
    if ((size > OPPOSED)) {
        direction = (mixed / vec3(size));
    }
    vec3 _e24 = direction;
    return vec4(_e24, ((w * by_user) + ((1.0 - w) * by_center)));
}

Place ground_place(vec3 offset) {
    return Place(offset.xz, length(offset.xz));
}

float leave_cylinder(Place user, vec3 direction_1, float rho_1) {
    bool local = false;
    float a = dot(direction_1.xz, direction_1.xz);
    if (!((rho_1 <= user.rho))) {
        local = (a == 0.0);
    } else {
        local = true;
    }
    bool _e14 = local;
    if (_e14) {
        return -1.0;
    }
    float b = dot(direction_1.xz, user.at);
    float c = ((user.rho - rho_1) * (user.rho + rho_1));
    float q = sqrt(((b * b) - (a * c)));
    if ((b > 0.0)) {
        return (-(c) / (b + q));
    }
    return ((q - b) / a);
}

vec4 on_cylinder(Place user_1, vec3 from_user_1, vec3 from_center_1, float w_1, float rho_2) {
    vec4 _e5 = blended(from_user_1, from_center_1, w_1);
    float _e7 = leave_cylinder(user_1, _e5.xyz, rho_2);
    return vec4(_e5.xyz, ((_e7 >= 0.0) ? _e7 : _e5.w));
}

float range_on_cylinder(Place user_2, vec3 direction_2, float from_center_2) {
    if ((from_center_2 > 1e30)) {
        return from_center_2;
    }
    float _e8 = leave_cylinder(user_2, direction_2, (from_center_2 * length(direction_2.xz)));
    return ((_e8 >= 0.0) ? _e8 : from_center_2);
}

Zones zones_of(float r1_, float r2_1, float strength) {
    Zones zones = Zones(0.0, 0.0, 0.0, 0.0);
    bool local_1 = false;
    zones = Zones(-1.0, r2_1, 0.0, strength);
    if ((r2_1 > r1_)) {
        zones.slope = (1.0 / (r2_1 - r1_));
    }
    if ((r2_1 > 0.0)) {
        local_1 = (strength >= 1.0);
    } else {
        local_1 = false;
    }
    bool _e19 = local_1;
    if (_e19) {
        zones.stays = r1_;
    }
    Zones _e21 = zones;
    return _e21;
}

vec3 shift_of_blend(vec3 from_center_3, vec3 offset_1, float w_2) {
    bool local_2 = false;
    float b_squared = dot(from_center_3, from_center_3);
    if (!((w_2 == 0.0))) {
        local_2 = (b_squared > FAR_SQUARED);
    } else {
        local_2 = true;
    }
    bool _e12 = local_2;
    if (_e12) {
        return ((1.0 - w_2) * offset_1);
    }
    vec3 from_user_2 = (from_center_3 - offset_1);
    float offset_squared = dot(offset_1, offset_1);
    float a_1 = length(from_user_2);
    float b_1 = sqrt(b_squared);
    if ((offset_squared > (a_1 * b_1))) {
        vec4 _e22 = blended(from_user_2, from_center_3, w_2);
        return ((offset_1 + (_e22.w * _e22.xyz)) - from_center_3);
    }
    float difference = ((offset_squared - (2.0 * dot(from_center_3, offset_1))) / (a_1 + b_1));
    float e = (difference * difference);
    float turn = (offset_squared - e);
    float h = ((w_2 * (1.0 - w_2)) / (a_1 * b_1));
    float n = sqrt((1.0 - (h * turn)));
    float along = ((h * (e + (turn / (1.0 + n)))) / n);
    float by_offset = (1.0 - ((w_2 * (w_2 + (((1.0 - w_2) * b_1) / a_1))) / n));
    return ((along * from_center_3) + (by_offset * offset_1));
}

vec3 shift_on_cylinder(vec3 from_center_4, vec3 offset_2, float w_3, float rho_3) {
    if ((dot(from_center_4, from_center_4) > FAR_SQUARED)) {
        return offset_2;
    }
    Place _e7 = ground_place(offset_2);
    vec4 _e9 = on_cylinder(_e7, (from_center_4 - offset_2), from_center_4, w_3, rho_3);
    return ((offset_2 + (_e9.w * _e9.xyz)) - from_center_4);
}

vec3 displayed_in_world(vec3 p_1, vec3 from_center_5, vec3 offset_3, Zones zones_1, bool keeps_rho) {
    float rho_4 = length(from_center_5.xz);
    if ((rho_4 <= zones_1.stays)) {
        return p_1;
    }
    float _e12 = user_weight(rho_4, zones_1.r2_, zones_1.slope);
    float w_4 = (zones_1.strength * _e12);
    if (keeps_rho) {
        vec3 _e14 = shift_on_cylinder(from_center_5, offset_3, w_4, rho_4);
        return (p_1 + _e14);
    }
    vec3 _e16 = shift_of_blend(from_center_5, offset_3, w_4);
    return (p_1 + _e16);
}

vec3 nearfar_morph(vec3 p_2, vec3 user_3, vec3 center, float r1_1, float r2_2, float strength_1) {
    Zones _e8 = zones_of(r1_1, r2_2, strength_1);
    vec3 _e10 = displayed_in_world(p_2, (p_2 - center), (user_3 - center), _e8, false);
    return _e10;
}

vec3 nearfar_morph_cylinder(vec3 p_3, vec3 user_4, vec3 center_1, float r1_2, float r2_3, float strength_2) {
    Zones _e8 = zones_of(r1_2, r2_3, strength_2);
    vec3 _e10 = displayed_in_world(p_3, (p_3 - center_1), (user_4 - center_1), _e8, true);
    return _e10;
}

float nearfar_range_cylinder(vec3 direction_3, float range, vec3 user_5, vec3 center_2) {
    Place _e5 = ground_place((user_5 - center_2));
    float _e6 = range_on_cylinder(_e5, direction_3, range);
    return _e6;
}
`;var Ec=`
precision highp float;
precision highp int;
precision highp samplerCube;
precision highp usamplerCube;
`,q0=`
// The eye, from the centre: each eye of a headset has its own.
uniform vec3 cameraPosition;
// r1, r2, 1 / (r2 - r1), and the strength of the morph; a strength below 0 stands for no morph at all.
uniform vec4 radii;

bool is_morphed() {
  return radii.w >= 0.0;
}
`,Ac=Ec+wu+q0,Eu=`
vec3 displayed(vec3 p) {
  vec3 from_user = p - cameraPosition;
  float rho = length(p.xz);
  if (!is_morphed() || (radii.w == 1.0 && rho <= radii.x)) {
    return from_user;
  }
  float w = radii.w * user_weight(rho, radii.y, radii.z);
  vec4 to = blended(from_user, p, w);
  return to.w * to.xyz;
}
`;var Au=`
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
`,Tu=`
${Ec}
${to}
uniform samplerCube map;
uniform float opacity;
in vec3 v_direction;
out vec4 shade;

void main() {
  shade = vec4(srgb_of(textureLod(map, v_direction, 0.0).rgb), opacity);
}
`;var Ru=`
#if defined(TEXTURED) || defined(GLOWING)
#define MAPPED
#endif
`,Cu=`
${Ac}
${Ru}
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

${Eu}
void main() {
#ifdef PLACED
  mat4 placement = transpose(mat4(row_x, row_y, row_z, vec4(0.0, 0.0, 0.0, 1.0)));
#endif
  v_point = (placement * vec4(position, 1.0)).xyz;
  v_shown = displayed(v_point);
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
`,Pu=`
${Ac}
${to}
${Ru}
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

${Mu}
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
`;function Iu(i,e){return{radii:{value:new et},opacity:{value:1},map:{value:i},codes:{value:e},coding:{value:new et}}}o(Iu,"createShared");var X0=1e30,Lu={blending:Ji,blendSrc:Cr,blendDst:ri,blendSrcAlpha:$i,blendDstAlpha:ri,transparent:!1,depthTest:!0,side:rn,glslVersion:Gn};function qr({image:i,glow:e},t){return{image:i===null?null:t(i),glow:e===null?null:t(e)}}o(qr,"texturesOf");function no(i,{image:e,glow:t}){let{material:n}=i,r={};return i.normals&&(r.SMOOTH=""),i.colors&&(r.COLORED=""),i.placements&&(r.PLACED=""),e&&i.uvs&&(r.TEXTURED=""),n.cutoff!==null&&(r.CUTOUT=""),n.emission&&(n.glow===null||t&&i.uvs)&&(r[n.glow===null?"EMISSIVE":"GLOWING"]=""),n.isUnlit&&(r.UNLIT=""),r}o(no,"definesOf");function Tc(i,e,t,n){let{material:r}=i;return new fn({...Lu,vertexShader:Cu,fragmentShader:Pu,defines:no(i,e),uniforms:{...t,...K0(r,e),cut:{value:Math.min(n,X0)}}})}o(Tc,"nearMaterial");function Du(i){let e=new Map;return{of(t,n,r){let s=Object.keys(no(t,n)),a=JSON.stringify([s,t.material,String(r)]),c=e.get(a)??Tc(t,n,i,r);return e.set(a,c),c},dispose(){for(let t of e.values())t.dispose();e.clear()}}}o(Du,"createMaterials");function K0(i,{image:e,glow:t}){return{base_color:{value:new et(...i.color)},cutoff:{value:i.cutoff??0},image:{value:e},emission:{value:new G(...i.emission??[0,0,0])},glow:{value:t},placement:{value:new at}}}o(K0,"ownUniforms");function Nu(i){return new fn({...Lu,vertexShader:Au,fragmentShader:Tu,depthWrite:!1,uniforms:{map:i.map,opacity:i.opacity}})}o(Nu,"farMaterial");function Rc(i,e){let t=Object.entries(e).flatMap(([r,s])=>s?[{name:r,rows:s.rows,attribute:j0(i,s,r==="index")}]:[]),n={};for(let{name:r,attribute:s}of t)n[r]=s;return{attributes:n,*steps(){for(let r of Q0(t.flatMap(({rows:s,attribute:a})=>[...Z0(s,a.buffer)])))yield{kind:"arrays",bytes:r.reduce((a,{data:c})=>a+c.byteLength,0),run:o(()=>{for(let{buffer:a,data:c,start:l}of r)i.bindBuffer(io,a),i.bufferSubData(io,l,c)},"run")}},dispose(){for(let{attribute:r}of t)i.deleteBuffer(r.buffer)}}}o(Rc,"createBuffers");var io=36663;function j0(i,{rows:e,width:t,isShare:n=!1},r){let s=i.createBuffer();return r&&Y0(i,s),i.bindBuffer(io,s),i.bufferData(io,e.byteLength,i.STATIC_DRAW),new Tr(s,J0(i,e),t,$0(e),e.length/t,n)}o(j0,"attributeOf");function Y0(i,e){let t=i.getParameter(i.VERTEX_ARRAY_BINDING);i.bindVertexArray(null),i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e),i.bindVertexArray(t)}o(Y0,"markIndex");function J0(i,e){return e instanceof Float32Array?i.FLOAT:e instanceof Uint16Array?i.UNSIGNED_SHORT:i.UNSIGNED_INT}o(J0,"typeOf");function $0(i){return i instanceof Uint16Array?2:4}o($0,"bytesEach");function*Z0(i,e){let t=Wr/i.BYTES_PER_ELEMENT;for(let n=0;n<i.length;n+=t)yield{buffer:e,data:i.subarray(n,n+t),start:n*i.BYTES_PER_ELEMENT}}o(Z0,"partsOf");function*Q0(i){let e=[],t=0;for(let n of i)e.length>0&&t+n.data.byteLength>Wr&&(yield e,[e,t]=[[],0]),e.push(n),t+=n.data.byteLength;e.length>0&&(yield e)}o(Q0,"bundled");var e_=12,Cc=new WeakMap;function Uu(i,{gl:e,store:t}){let{same:n}=i,r=!1,s=t.take(n,()=>(r=!0,n_(e,i))),a=i.placements?Rc(e,{placement:nr(i.placements,e_)}):null,c={arrays:s,placements:a,same:n};return{*steps(){r&&(yield*s.steps()),a&&(yield*a.steps())},make(l){let h=t_(i.name,c,l);return Cc.set(h,c),h},free:o(()=>Ou(c,t),"free")}}o(Uu,"prepare");function t_(i,{arrays:e,placements:t},n){let r=t?i_(t):new Ut,{index:s,...a}=e.attributes;for(let[l,h]of Object.entries(a))r.setAttribute(l,h);r.setIndex(s);let c=new ut(r,n);return c.name=i,c.frustumCulled=!1,c.matrixAutoUpdate=!1,c}o(t_,"meshOf");function Fu(i,e){let{geometry:t}=i;for(let r of Object.keys(t.attributes))t.deleteAttribute(r);t.setIndex(null),t.dispose();let n=Cc.get(i);n&&Ou(n,e),Cc.delete(i)}o(Fu,"disposeMesh");function Ou({arrays:i,placements:e,same:t},n){n.give(t)&&i.dispose(),e?.dispose()}o(Ou,"free");function n_(i,{positions:e,normals:t,uvs:n,colors:r,indices:s}){return Rc(i,{position:nr(e,3),normal:t&&nr(t,3),uv:n&&nr(n,2),color:r&&{...nr(r,4),isShare:!0},index:nr(s,1)})}o(n_,"arraysOf");function nr(i,e){return{rows:i,width:e}}o(nr,"columnOf");function i_({attributes:i}){let e=new Ar,t=Object.assign(i.placement,{isInstancedBufferAttribute:!0,meshPerAttribute:1,array:new Float32Array(0)});return["row_x","row_y","row_z"].forEach((n,r)=>{e.setAttribute(n,new vr(t,4,4*r))}),e.instanceCount=t.count,e}o(i_,"placedGeometry");var r_=4;function Bu(i,e,t,n,r){let s=e.rings.map(()=>Object.assign(new un,{visible:!1})),a=Du(r),c=o(()=>wi(i,t,e.range),"make"),l=[c(),c()];return{entry:e,groups:s,materials:a,triangles:e.rings.map(()=>({own:0,drawn:0})),cubes:l,dispose(){for(let h of s){for(let u of Ic(h))Fu(u,n);h.clear()}a.dispose();for(let h of l)h.dispose()}}}o(Bu,"createRegion");function ro(i,e){let t=i.cubes.find(n=>n.holds===e);if(!t)throw new Error(`the map of ring ${e} is not there`);return t}o(ro,"cubeOf");function ku({entry:i},e){let{map:t,sharper:n}=i.rings[e]??{};return!!(t??n)}o(ku,"hasMap");function Pc(i){return i%2===0?0:1}o(Pc,"turnOf");function Ic(i){return i.children}o(Ic,"meshesOf");function zu(i,e){let t=i.groups[e];if(!t)throw new Error(`there is no ring ${e}`);return t}o(zu,"groupOf");function Gu(i,e,t){zu(i,e).visible=!0,i.triangles[e]=t}o(Gu,"complete");function Vu(i,e){let t={own:0,drawn:0};for(let{own:n,drawn:r}of i.triangles.slice(0,e+1))t.own+=n,t.drawn+=r;return t}o(Vu,"trianglesShown");function*Hu(i,e,{bands:t,pieces:n},r,s){let a=e===0?1/0:i.entry.cut,c=zu(i,e),l=[],h=o(()=>{let u=l.splice(0).map(({piece:p,prepared:d})=>{let f=qr(p.material,g=>r.store.textures.get(g)??null);return d.make(i.materials.of(p,f,a))});r.warm(u),c.add(...u)},"make");try{for(let u of t)yield*s.steps(u);for(let[u,p]of n.entries()){let d=Uu(p,r);l.push({piece:p,prepared:d}),yield*d.steps(),(l.length===r_||u===n.length-1)&&(yield{kind:"mesh",bytes:0,run:h})}}finally{for(let{prepared:u}of l)u.free();for(let{rows:u}of t)u.close()}}o(Hu,"partSteps");async function Wu(i,e){let{manifest:t,region:n,renderer:r,signal:s,uploads:a}=i,c=await i.maps(Lc(i,t.map,n.entry.range,await Mi(i,e.color)));s.throwIfAborted(),await a.add(eo(r,n.cubes[0],c,0,t.map),s)}o(Wu,"loadFirstMap");async function qu(i,e,{tiles:t,color:n,range:r}){let{manifest:s,maps:a,number:c,region:l,renderer:h,signal:u,uploads:p}=i,[d,f]=await Promise.all([Mi(i,n),Mi(i,r)]),g=Array.isArray(n),y=l.cubes[Pc(e)];await i.mayReplace(e),u.throwIfAborted(),g&&await a(Lc(i,s.map,l.entry.range,d)),u.throwIfAborted();let m=y.holds!==null&&y.hasRange?y.holds:null,b=await a({kind:"next-map",region:c,ring:g?1:e,tiles:t,color:g?null:d[0]??null,range:f,since:m});u.throwIfAborted(),await p.add(eo(h,y,b,e,s.map),u)}o(qu,"loadMap");function Lc({number:i,signal:e},{face_size:t,tile:n,across:r},{step:s},a){return e.throwIfAborted(),{kind:"first-map",region:i,faceSize:t,tile:n,across:r,step:s,color:a}}o(Lc,"firstRequest");async function Xu(i,e,{layout:t,maps:n,range:r}){let{region:s,renderer:a,signal:c,uploads:l}=i,[h,...u]=n;if(!h||u.length===0)throw new Error("maps of full size: expected those of all rings");let p=await i.maps(Lc(i,t,r,await Mi(i,h.color)));for(let[f,g]of u.entries()){let y=f===u.length-1;p=await s_(i,f+1,g,y)}await i.mayReplace(e),c.throwIfAborted();let d=Pc(e);s.cubes[d].dispose(),s.cubes[d]=wi(a,t.face_size,r),await l.add(eo(a,s.cubes[d],p,e,t),c)}o(Xu,"loadSharper");async function s_(i,e,{tiles:t,color:n,range:r},s){let[[a],c]=await Promise.all([Mi(i,n),Mi(i,r)]);i.signal.throwIfAborted();let l=s?null:e-1;return i.maps({kind:"next-map",region:i.number,ring:e,tiles:t,color:a??null,range:c,since:l})}o(s_,"changed");function Ku(i,e){let t=i.getContext(),n=new Map;function r(l){i.state.activeTexture(t.TEXTURE0),i.state.bindTexture(t.TEXTURE_2D,l)}o(r,"bind");function s({name:l,width:h,height:u}){let p=t.createTexture();n.set(l,p),r(p);let d=1+Math.floor(Math.log2(Math.max(h,u)));return t.texStorage2D(t.TEXTURE_2D,d,t.SRGB8_ALPHA8,h,u),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MAG_FILTER,t.LINEAR),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_MIN_FILTER,t.LINEAR_MIPMAP_LINEAR),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_S,t.REPEAT),t.texParameteri(t.TEXTURE_2D,t.TEXTURE_WRAP_T,t.REPEAT),p}o(s,"begin");function a(l){r(n.get(l.name)??s(l));let{state:h}=i;h.pixelStorei(t.UNPACK_FLIP_Y_WEBGL,!1),h.pixelStorei(t.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),h.pixelStorei(t.UNPACK_COLORSPACE_CONVERSION_WEBGL,t.NONE),t.texSubImage2D(t.TEXTURE_2D,0,0,l.y,t.RGBA,t.UNSIGNED_BYTE,l.rows),l.rows.close()}o(a,"send");function c(l){let h=n.get(l);if(!h)return;n.delete(l),r(h),t.generateMipmap(t.TEXTURE_2D);let u=new _i(h);u.addEventListener("dispose",()=>t.deleteTexture(h)),e(l,u)}return o(c,"finish"),{*steps(l){let{name:h,y:u,rows:p,height:d}=l,f=u+p.height===d;yield{kind:"picture",bytes:4*p.width*p.height,run:o(()=>a(l),"run")},f&&(yield{kind:"picture",bytes:0,run:o(()=>c(h),"run")})},dispose(){for(let l of n.values())t.deleteTexture(l);n.clear()}}}o(Ku,"createPictures");async function ju(i,e,t,{number:n,parts:r,samples:s,triangles:a},c){let{renderer:l,store:h,uploads:u,geometry:p,programs:d,warm:f}=i,g={gl:l.getContext(),store:h,warm:f},y=Ku(l,(m,b)=>{h.textures.has(m)?b.dispose():h.textures.set(m,b)});try{c.throwIfAborted(),await d.ready(s);let m=Promise.resolve();for(let b=0;b<r;b++){let w=await p({kind:"part",of:n,part:b}),T=u.add(Hu(e,t,w,g,y),c);T.catch(()=>{}),await m,m=T}await m,Gu(e,t,a)}finally{y.dispose(),p({kind:"drop",of:n}).catch(()=>{})}}o(ju,"receiveParts");async function Ju(i,e){let{manifest:t,region:n,received:r,signal:s,turn:a}=e,h={...i,...e,ahead:du(o((f,g)=>i.fetch(f,g,r),"fetch"),o(f=>t.files[f]?.bytes??0,"sizeOf")),had:new Set},{rings:u}=n.entry,{map:p}=await a(0,s);p&&await Wu(h,p),e.arrived(0);let{dynamic:d}=t;d&&await Yu(h,0,d.geometry,d.parts);for(let f=1;f<u.length;f++){let g=await a(f,s),y=[];g.map&&y.push(qu(h,f,g.map)),g.sharper&&y.push(Xu(h,f,g.sharper)),g.geometry!==null&&y.push(Yu(h,f,g.geometry,g.parts));let m=u[f+1],b=o(w=>!Dc(i,w)&&!h.had.has(w),"isNew");m&&h.ahead.want(Hr(m).filter(b),s),await Promise.all(y),e.arrived(f)}}o(Ju,"loadRegion");function Dc({store:i},e){return i.textures.has(e)||i.buffers.has(e)}o(Dc,"isHere");async function Yu(i,e,t,n){let{manifest:r,region:s,signal:a,store:c}=i,l=n.filter(f=>!Dc(i,f));for(let f of n)Dc(i,f)&&!i.had.has(f)&&i.received(r.files[f]?.bytes??0),i.had.add(f);let h=c.buffers.has(t);h&&i.received(r.files[t]?.bytes??0);let[u,...p]=await Promise.all([h?{name:t,data:null}:$a(i,t),...l.map(f=>$a(i,f))]);a.throwIfAborted();let d=await i.geometry({kind:"geometry",glb:u,parts:p,known:[...c.textures.keys()],center:s.entry.center,growth:{radii:s.entry.rings.slice(1).map(({radius:f})=>f),nearShare:r.morph.near_share,reach:r.growth.reach},isDynamic:e===0});for(let f of l)f.endsWith(".bin")&&c.buffers.add(f);e===0&&c.buffers.add(t),await ju(i,s,e,d,a)}o(Yu,"loadGeometry");var jt={radius:0,strength:0};function $u(i,e,t,n,r=0){let s=n.radii[e-1];if(s===void 0)return jt;let a=n.speed*Math.PI/180/n.reach,c=t,l=i.radius===0?0:i.strength,h=n.radii.find(d=>d>=r)??Number.POSITIVE_INFINITY;if(l===0&&h>s)return{radius:s,strength:l};let u=l===0?h:i.radius;if(l<1){let d=1/(Math.max(n.nearShare,.05)*u*a),f=(1-l)*d;l=c>=f?1:l+c/d,c=Math.max(0,c-f)}if(l<1||u>=s)return{radius:Math.min(u,s),strength:l};let p=1/u-(1-n.nearShare)*a*c;return{radius:p<=1/s?s:1/p,strength:l}}o($u,"grow");function Zu(i,{isSmooth:e,isWhole:t}){let n=-1,r=-1,s=0,a=!1,c=!1,l=jt,h=[];function u(){return r>=(t?i.radii.length:0)}o(u,"isThere");function p(y){let[m,b]=[i.radii[0],i.radii[r-1]];return u()?m===void 0||b===void 0?jt:{radius:Math.min(Math.max(y.radius,m),b),strength:y.radius>0?y.strength:0}:null}o(p,"offer");function d(y){let m=i.radii[r-1];return m===void 0?jt:{radius:m,strength:l.strength===1||m>=y?1:0}}o(d,"atOnce");function f(){let y=h.filter(m=>g(m.ring));h=h.filter(m=>!g(m.ring));for(let{done:m}of y)m()}o(f,"release");function g(y){return r>=y-1||n<1}return o(g,"isFree"),{arrive(y){n=y,!(c&&e&&r>=0)&&(r=y,f())},offer:p,enter(y){l=p(y)??jt,c=!0},leave(){c=a=!1,r=n,f()},advance(y,m=0){if(!u())return null;if(l=e?$u(l,r,a?0:y,i,m):d(m),!a&&n>r)return a=!0,s=0,{ring:r,grown:l,fading:{ring:r+1,share:0}};if(!a)return{ring:r,grown:l,fading:null};s+=y;let b=i.fade>0?Math.min(s/i.fade,1):1;return b<1?{ring:r,grown:l,fading:{ring:r+1,share:b}}:(r+=1,a=!1,f(),{ring:r,grown:l,fading:null})},replaceable(y){return new Promise(m=>{g(y)?m():h.push({ring:y,done:m})})}}}o(Zu,"createStage");function Nc(i,e,t){performance.mark(`nearfar:${i}`,{detail:{region:e,ring:t}})}o(Nc,"tell");function td({world:i,loading:e,manner:t,failed:n}){let{renderer:r,store:s}=e,{nearShare:a}=i,c=new Map,l=new Map,h=[],u=[],p=[];function d(){let x=h.find(E=>a_(c.get(E))),S=u.filter(({region:E})=>E===x);u=u.filter(({region:E})=>E!==x);for(let{done:E}of S)E()}o(d,"call");function f(x,S){return new Promise((E,_)=>{S.addEventListener("abort",()=>_(S.reason),{once:!0}),u.push({region:x,done:E}),d()})}o(f,"turn");async function g(x,S,E,_){let A=S.ring(E);return A instanceof Promise&&(x.isIdle=!0,d(),await A,x.isIdle=!1),await f(x.number,_),A}o(g,"ready");function y(x){let S={stop:new AbortController,from:null,hasFailed:!1},{signal:E}=S.stop;l.set(x,S),i.open(x,E).then(_=>{E.aborted||(l.delete(x),m(x,_,S.stop),S.from&&T(x).stage.enter(S.from))},_=>{E.aborted||(S.hasFailed=!0,n(x,Qu(_)))})}o(y,"ask");function m(x,S,E){let{entry:_,manifest:A}=S,U=_.rings.slice(1).map(C=>C.radius),I=Zu({...A.growth,radii:U,nearShare:a},t),D=Bu(r,_,A.map.face_size,s,e.shared),F={number:x,region:D,stage:I,stop:E,arrived:-1,shown:null,received:0,get expected(){return uu(A,wc(A,_))},state:"loading",isIdle:!1,needed:o(()=>wc(A,_),"needed")};c.set(x,F);let V=o(C=>{F.state=C,d()},"ended");Ju(e,{manifest:A,region:D,number:x,arrived(C){F.arrived=C,Nc("arrived",x,C),I.arrive(C)},received:o(C=>{F.received+=C},"received"),turn:o((C,q)=>g(F,S,C,q),"turn"),mayReplace:o(C=>I.replaceable(C),"mayReplace"),signal:E.signal}).then(()=>V("complete"),C=>{E.signal.aborted||(V("failed"),n(x,Qu(C)))})}o(m,"begin");function b(x){c.delete(x.number),x.stop.abort(),x.region.dispose(),u=u.filter(({region:_})=>_!==x.number);let S=[...c.values()].flatMap(_=>[..._.needed()]),E={kind:"forget",buffers:s.keep(new Set(S)),region:x.number};Promise.all([e.geometry(E),e.maps(E)]).then(_=>{p=_},()=>{})}o(b,"end");function w(x,S){y(x);let E=l.get(x);E&&(E.from=S)}o(w,"again");function T(x){let S=c.get(x);if(!S)throw new Error(`region ${x} is not open`);return S}return o(T,"requireOpen"),{find:o(x=>c.get(x)??null,"find"),open(x){!c.has(x)&&!l.has(x)&&y(x)},close(x){l.get(x)?.stop.abort(),l.delete(x);let S=c.get(x);S&&b(S)},prefer(x){h=x,d()},offer:o((x,S)=>c.get(x)?.stage.offer(S)??null,"offer"),isComplete:o(x=>c.get(x)?.state==="complete","isComplete"),isCoarse:o(x=>c.get(x)?.region.entry.isCoarse??!1,"isCoarse"),enter(x,S){let E=l.get(x);if(E){E.from=S;return}let _=T(x);_.stage.enter(S),_.shown=null},leave(x){let S=c.get(x);S?.stage.leave(),S&&(S.shown=null)},grown:o(x=>c.get(x)?.shown?.grown??null,"grown"),advance(x,S,E){let _=c.get(x);if(!_)return null;let A=ed(_.shown);_.shown=_.stage.advance(S,E);let U=ed(_.shown);return U>A&&Nc("shown",x,U),_.shown},retry(){for(let x of[...c.values()].filter(({state:S})=>S==="failed")){let{grown:S}=x.shown??{};b(x),w(x.number,S??null)}for(let[x,{hasFailed:S,from:E}]of l)S&&w(x,E)},get holding(){let x=[...l.values()].some(({hasFailed:E})=>!E),S=[...c.values()].some(({state:E})=>E==="loading");return{regions:[...c.keys(),...l.keys()],isLoading:x||S,kept:p}},dispose(){for(let{stop:x}of l.values())x.abort();l.clear();for(let x of[...c.values()])b(x)}}}o(td,"createAtlas");function a_(i){return i?.state==="loading"&&!i.isIdle}o(a_,"isLoading");function Qu(i){return i instanceof Error?i:new Error(String(i))}o(Qu,"asError");function ed(i){return i?.fading?.ring??i?.ring??-1}o(ed,"lastOf");function nd(i,e,t,{camera:n,rig:r,setPose:s}){let a=null,c=null;function l(f,g,y,m=!0){let b=e.find(f);if(!b?.shown||g===0)return;let{ring:w,grown:T,fading:x}=b.shown,S={region:b.region,radius:T.radius,strength:y?T.strength:null};t.draw({...S,ring:w},n,g,{map:!m}),g===1&&x&&x.share>0&&t.draw({...S,ring:x.ring},n,x.share)}o(l,"paint");function h({region:f,leaving:g},y,m){let b=g?.pose??y;g&&b&&(s(b),l(g.region,1,m)),y&&s(y),l(f,g?.share??1,m)}o(h,"paintLeg");function u({region:f,leaving:g}){g&&!g.pose&&l(g.region,1,!0),l(f,g?.share??1,!0,g!==null||!p(f))}o(u,"paintEyes");function p(f){let g=e.find(f);return!g?.shown||g.shown.fading?!1:c?.show(ro(g.region,g.shown.ring),r.rotation.y)??!1}o(p,"isApart");function d(f,g,y){let{clientWidth:m,clientHeight:b}=i.domElement,w=Math.round(y*m);i.setScissorTest(!0),i.setScissor(0,0,w,b),h(f,g,!1),i.setScissor(w,0,m-w,b),h(f,g,!0),i.setScissorTest(!1)}return o(d,"paintSides"),{draw(f,g){e.find(f.region)?.shown&&(i.xr.isPresenting?u(f):a===null?h(f,g,!0):d(f,g,a))},setDivider(f){a=f},isMorphedAt:o(f=>a===null||f>=a||i.xr.isPresenting,"isMorphedAt"),setMapLayer(f){c=f}}}o(nd,"createComposer");function id(i,e){let t=new Worker(i,{type:"module"}),n=new Map,r=0,s=null;return t.onmessage=c=>{let l=performance.now(),{data:h}=c,u=n.get(h.id);n.delete(h.id),"error"in h?u?.failed(new je(h.error)):u?.done(h.result),e(performance.now()-l)},t.onerror=c=>{s=new je(`the decoder stopped: ${c.message||"the browser gives no reason"}`,"other");for(let{failed:l}of n.values())l(s);n.clear()},{decode:o(c=>new Promise((l,h)=>{if(s){h(s);return}let u=++r;n.set(u,{done:l,failed:h}),t.postMessage({...c,id:u},o_(c))}),"decode"),dispose:o(()=>t.terminate(),"dispose")}}o(id,"startDecoder");function o_(i){switch(i.kind){case"geometry":return[i.glb,...i.parts].flatMap(({data:e})=>e??[]);case"first-map":return i.color.map(e=>e.data);case"next-map":return[...i.color?[i.color]:[],...i.range].map(e=>e.data);case"part":case"drop":case"forget":return[]}}o(o_,"buffersOf");var[c_,l_,h_]=[.5,4,.9],rd=.25;function Ei(i,e){return Math.hypot(i[0]-e[0],i[1]-e[1],i[2]-e[2])}o(Ei,"apartOf");function sd(i,e,t){let n=Math.max(Ei(e,i),1e-6);return{apart:n,border:(Ei(e,t)**2-Ei(i,t)**2)/(2*n)}}o(sd,"borderOf");function ad(i,e,t=-1){let n=null,r=Number.POSITIVE_INFINITY;return i.forEach(({center:s},a)=>{let c=Ei(s,e);a!==t&&c<r&&([n,r]=[a,c])}),n}o(ad,"nearestOf");function od(i){let e=o(t=>i[t],"of");return{of:e,nearest:o(t=>ad(i,t)??0,"nearest"),ahead({place:t,current:n,ahead:r}){let s=ad(i,t,n);if(s===null)return null;let a=e(n).center,c=o(p=>Ei(e(p).center,t),"far"),{apart:l,border:h}=sd(a,e(s).center,t),u=Math.max(c_*l/2,Math.min(h_*l/2,l_));if(r!==null&&r!==n){let p=c(r)<c(s)+rd*l,d=sd(a,e(r).center,t).border;if(p&&d<u+rd*l/2)return r}return h<u?s:null}}}o(od,"knownPlaces");var[u_,d_]=[.1,2],f_=.3,p_=.5,m_=1-1e-9,[g_,b_]=[.9,.5];function ld(i,e,t){let n=t,r=null,s=null,a=null,c=null,l=[t],{places:h}=i;function u(T,x){let{center:S,fold_margin:E}=h.of(T);return{center:S,metres:x&&x.strength>0?i.marginShare*x.radius:E}}o(u,"limitOf");function p(T,x){return T.metres-kt(x,T)}o(p,"room");let d=o((T,x)=>Ei(h.of(T).center,x),"far");function f(T){let x=e.grown(n),S=x&&e.offer(T,x);return!x||!S||x.strength>0&&S.strength===0?null:S}o(f,"offered");function g(T,x){let[S,E]=[e.grown(n),f(T)];if(!S||!E)return!1;let _=Math.min(u_*d(T,h.of(n).center),d_),[A,U]=[u(n,S),u(T,E)],I=d(T,x)+_<=d(n,x),D=E.radius>=S.radius&&!e.isCoarse(T),F=S.strength===0||D||e.isComplete(T);return I&&F&&p(U,x)>=f_*U.metres?!0:p(A,x)<(1-.8)*A.metres&&p(U,x)>=Math.max(p(A,x),0)+_}o(g,"mayCross");function y(T,x,S){s={region:n,pose:S,since:0},T!==n&&(e.enter(T,x),n=T)}o(y,"take");function m(T,x,S){let{center:E,metres:_}=u(T,x);return{...S,position:tl(S.position,{center:E,metres:g_*_})}}o(m,"landing");function b(T){if(!a)return;let{region:x,target:S}=a,E=e.grown(n),_=x===n,A=_?E:e.offer(x,E??jt);if(!A)return;let U=_||p(u(x,A),S.position)>(1-.8)*u(x,A).metres,I=m(x,U?A:jt,S);a=null,y(x,U&&E?E:jt,E?T:null),E||(s=null),c=I,i.moved(I)}o(b,"depart");function w(T){let x=a?.region??null;s?r=s.region===n?null:s.region:r=x===null?h.ahead({place:T,current:n,ahead:r,limit:u(n,e.grown(n))}):null;let S=s?r:x??r,E=[...new Set([n,S??n])];S!==null&&(x!==null&&!s||d(S,T)<d(n,T))&&E.reverse();for(let A of l)E.includes(A)||e.close(A);for(let A of E)e.open(A);l=E,e.prefer(E)}return o(w,"arrange"),e.open(t),e.enter(t,jt),{advance(T,x){c=x,s&&(s.since+=T,s.since>=i.fade&&(s.region!==n&&e.leave(s.region),s=null)),s||b(x),w(c.position),!s&&!a&&r!==null&&g(r,c.position)&&(y(r,e.grown(n)??jt,null),w(c.position));let S=s&&i.fade>0?s.since/i.fade:1;return{region:n,leaving:s&&{region:s.region,pose:s.pose,share:S}}},go(T){let x=h.nearest(T.position),S=u(n,e.grown(n));a={region:p(S,T.position)>=b_*S.metres?n:x,target:T}},failed(T){a?.region===T&&T!==n&&e.offer(T,jt)===null&&(a=null)},get bounds(){let T=u(n,e.grown(n)),x=s&&!s.pose?[T,u(s.region,e.grown(s.region))]:[T],S=!s&&r!==null?f(r):null;return{shown:x,open:S&&r!==null?[T,u(r,S)]:[T]}},get region(){return n},get goal(){return a?.region??null},get least(){let{center:T,fold_margin:x}=h.of(n),S=c?kt(c.position,{center:T,metres:x}):0;return m_*Math.min(S+p_,x)/i.marginShare}}}o(ld,"createJourney");function hd(i,e,t){let n=!1,r=new AbortController,{signal:s}=r,a=o(l=>{l.preventDefault(),n=!0,e()},"went"),c=o(()=>{n=!1,t()},"came");return i.addEventListener("webglcontextlost",a,{signal:s}),i.addEventListener("webglcontextrestored",c,{signal:s}),{get isLost(){return n},dispose:o(()=>r.abort(),"dispose")}}o(hd,"watchLoss");var __=`
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,x_=`
precision mediump float;
uniform float darkness;
out vec4 shade;

void main() {
  shade = vec4(0.0, 0.0, 0.0, darkness);
}
`;function ud(){let i={value:0},e=new fn({vertexShader:__,fragmentShader:x_,glslVersion:Gn,uniforms:{darkness:i},blending:Ji,blendSrc:$i,blendDst:ri,depthTest:!1,depthWrite:!1,transparent:!0}),t=new ut(Xr(),e);return t.frustumCulled=!1,t.visible=!1,{mesh:t,set(n){i.value=n,t.visible=n>0}}}o(ud,"createVeil");function Xr(){let i=new Ut;return i.setAttribute("position",new Ht(new Float32Array([-1,-1,0,3,-1,0,-1,3,0]),3)),i}o(Xr,"covering");var y_=`
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,v_=`
precision highp float;
precision highp sampler2D;
uniform sampler2D depth;
out vec4 digits;

void main() {
  float value = texelFetch(depth, ivec2(0), 0).r;
  vec3 scaled = fract(value * vec3(1.0, 255.0, 65025.0));
  digits = vec4(scaled - vec3(scaled.yz / 255.0, 0.0), value < 1.0 ? 1.0 : 0.0);
}
`;function dd(i){let e=new dn(1,1,Kt),t=new Ct(1,1,{depthTexture:e}),n=new Ct(1,1),r=new fn({vertexShader:y_,fragmentShader:v_,glslVersion:Gn,blending:On,depthTest:!1,uniforms:{depth:{value:e}}}),s=new ut(Xr(),r);s.frustumCulled=!1;let a=new Wt().add(s),c=new Uint8Array(4);return{pick(l,[h,u],p){let d=i.getRenderTarget(),[f,g]=[i.domElement.width,i.domElement.height];l.setViewOffset(f,g,Math.floor(h*f),Math.floor(u*g),1,1);try{if(i.setRenderTarget(t),p(),i.setRenderTarget(n),i.render(a,l),i.readRenderTargetPixels(n,0,0,1,1,c),c[3]===0)return null;let y=((c[2]??0)/65025+(c[1]??0)/255+(c[0]??0))/255;return new G(0,0,2*y-1).unproject(l)}finally{l.clearViewOffset(),i.setRenderTarget(d)}},dispose(){for(let l of[s.geometry,r,e,t,n])l.dispose()}}}o(dd,"createPicker");function fd(i,e,t,n,r){let s=new Wt,a=new Wt;a.add(S_(e));let c=null;return{prepare(l){i.compile(a,l)},draw(l,h,u,p={}){let{region:d,ring:f,radius:g,strength:y}=l;r(d.entry.center);let m=ku(d,f)?ro(d,f):n(),b=t*g,w=g>0?1/(g-b):1;e.radii.value.set(b,g,w,y??-1),e.map.value=m.color,e.codes.value=m.codes;let{least:T,step:x}=m.scale;e.coding.value.set(T,x,m.size,m.hasRange?1:0),e.opacity.value=u;let S=p.guests?[]:c?.meshes??[];S.length>0&&c?.place(d.entry.center);let E=d.groups.slice(0,f+1),_=u<1?[...E.flatMap(Ic),...S]:[];s.children=[...E,...S],i.clearDepth(),u<1&&(Uc(_,!1,!0),i.render(s,h),Uc(_,!0,!1)),i.render(s,h),u<1&&Uc(_,!0,!0),p.map||i.render(a,h),s.children=[]},setGuests(l){c=l}}}o(fd,"createPainter");function Uc(i,e,t){for(let{material:n}of i)n.colorWrite=e,n.depthWrite=t}o(Uc,"setWrites");function S_(i){let e=new ut(Xr(),Nu(i));return e.frustumCulled=!1,e}o(S_,"screen");function pd(i,e,t,n){let r=new Map,s=new Rt;async function a(l){let h=Tc(l,qr(l.material,()=>s),t,1/0),u=new Wt().add(new ut(new Ut,h)),p=Promise.resolve(),d=o(()=>{p=E_(i,u,e)},"begin");await n.add([{kind:"program",bytes:0,run:d}],new AbortController().signal,!0),await p,await A_(i);let f=performance.now();T_(i,h),n.spend(performance.now()-f)}o(a,"make");function c(l){return Object.keys(no(l,qr(l.material,()=>s))).join(" ")}return o(c,"kindOf"),{async ready(l){let h=l.map(u=>{let p=c(u),d=r.get(p)??a(u);return r.set(p,d),d});await Promise.all(h)},forget(){r.clear()}}}o(pd,"createPrograms");var[M_,w_]=[10,3];async function E_(i,e,t){if(i.extensions.has("KHR_parallel_shader_compile")){await i.compileAsync(e,t);return}i.compile(e,t),await md(i)}o(E_,"compile");async function md(i){let e=i.getContext(),t=e.fenceSync(e.SYNC_GPU_COMMANDS_COMPLETE,0);for(e.flush();t&&!e.isContextLost()&&e.getSyncParameter(t,e.SYNC_STATUS)!==e.SIGNALED;)await new Promise(n=>setTimeout(n,M_));e.deleteSync(t)}o(md,"passed");async function A_(i){for(let e=0;e<w_;e++){let{frame:t}=i.info.render;if(await md(i),i.info.render.frame===t)return}}o(A_,"idle");function T_(i,e){let t=i.getContext(),{currentProgram:n}=i.properties.get(e);if(!(!n||t.isContextLost())){if(t.getProgramParameter(n.program,t.LINK_STATUS)!==!0){let r=[n.vertexShader,n.fragmentShader].map(s=>t.getShaderInfoLog(s));throw new Error(`the browser refuses a program: ${[t.getProgramInfoLog(n.program),...r].join(" ")}`)}n.getUniforms(),n.getAttributes()}}o(T_,"look");function gd(i,e){i.clear();let t=i.getRenderTarget(),n=t?.samples??0;t&&(t.samples=0),e(),t&&(t.samples=n)}o(gd,"resolveOnce");function bd(){let i=new Map,e=new Set,t=new Map;return{textures:i,buffers:e,take(n,r){if(n===null)return r();let s=t.get(n)??{arrays:r(),users:0};return t.set(n,s),s.users+=1,s.arrays},give(n){let r=n===null?void 0:t.get(n);return!r||n===null?!0:(r.users-=1,r.users>0?!1:(t.delete(n),!0))},keep(n){for(let[s,a]of i)n.has(s)||(a.dispose(),i.delete(s));let r=[...e].filter(s=>!n.has(s));for(let s of r)e.delete(s);return r},get shared(){return[...t.values()].filter(({users:n})=>n>1).length}}}o(bd,"createStore");var R_=.05,C_=3e4;function _d(i){let e=new Mt(i,1,R_,C_);e.rotation.order="YXZ";let t=new un;t.add(e);let n={x:0,y:0,z:0};function r({position:[s,a,c],yaw:l}){Object.assign(n,{x:s,y:a,z:c}),t.rotation.y=l}return o(r,"stand"),{camera:e,rig:t,place(s){t.position.set(n.x-s[0],n.y-s[1],n.z-s[2]),t.updateMatrixWorld(!0)},setPose({position:[s,a,c],yaw:l,pitch:h}){r({position:[s,a,c],yaw:0}),e.position.set(0,0,0),e.rotation.set(h,l,0)},stand:r}}o(_d,"createViewpoint");var xd={map:!0,guests:!0},P_=3;function yd(i,e){let{faceSize:t,fade:n,marginShare:r,nearShare:s,places:a}=e.world,c=I_(i,e.antialias),l=_d(e.angle),{camera:h,rig:u,setPose:p,stand:d}=l,f=ud(),g=new Wt;g.add(u,f.mesh);let y=wi(c,1),m=Iu(y.color,y.codes),b=Za(c.getContext()),w=pu(()=>performance.now(),b),T=o(()=>id(e.worker,w.spend),"start"),x=[T(),T()],S=fd(c,m,s,()=>y,l.place);S.prepare(h);let E=dd(c),_=pd(c,h,m,w),A=new Wt,U=bd(),I={renderer:c,shared:m,store:U,uploads:w,geometry:x[0].decode,maps:x[1].decode,fetch:e.fetch,programs:_,warm(fe){for(let{geometry:z}of fe)z.setDrawRange(0,0);A.children=[...fe],c.render(A,h),A.children=[];for(let{geometry:z}of fe)z.setDrawRange(0,1/0)}},D=td({world:e.world,loading:I,manner:e,failed(fe,z){V?.failed(fe),e.failed(z)}}),F=nd(c,D,S,l),V=null,C=null,q=null,Y=0,W=null,ne=hd(i,()=>{W=V?.region??null,X(),y.dispose(),E.dispose(),_.forget(),w.forget(),e.lost(!0)},()=>{c.setClearAlpha(0),y=wi(c,1),[m.map.value,m.codes.value]=[y.color,y.codes],S.prepare(h),W!==null&&Q(W),e.lost(!1)});function X(){for(let fe of D.holding.regions)D.close(fe);V=C=null}o(X,"close");function Q(fe){X(),V=ld({places:a,marginShare:r,fade:n,moved:o(te=>{q=te,e.moved(te)},"moved")},D,fe)}o(Q,"begin");function ee(){if(c.xr.isPresenting)return;let{clientWidth:fe,clientHeight:z}=i,te=Math.min(window.devicePixelRatio,2);i.width===Math.floor(fe*te)&&i.height===Math.floor(z*te)||(c.setPixelRatio(te),c.setSize(fe,z,!1),h.aspect=fe/z,h.updateProjectionMatrix())}o(ee,"fit");function ve(fe,z){Y=w.run(P_),V&&(C=V.advance(z,fe),D.advance(C.region,C.leaving?0:z,V.least),F.draw(C,q))}return o(ve,"advance"),{uploads:w,renderer:c,camera:h,rig:u,faceSize:t,open:Q,go:o(fe=>V?.go(fe),"go"),pointAt(fe,z){let te=C&&D.find(C.region);if(!te?.shown||!q)return null;let{region:xe,shown:Ee}=te;p(q);let{radius:me}=Ee.grown,De=F.isMorphedAt(fe)?Ee.grown.strength:null,nt=E.pick(h,[fe,z],()=>{S.draw({region:xe,ring:Ee.ring,radius:me,strength:De},h,1,xd)}),{center:Re}=xe.entry;return nt&&[nt.x+Re[0],nt.y+Re[1],nt.z+Re[2]]},along(fe,z){let te=C&&D.find(C.region);if(!te?.shown)return null;let{region:xe,shown:Ee}=te;return hu(c,E,rl(fe,xe.entry.center),z,me=>{S.draw({region:xe,ring:Ee.ring,radius:Ee.grown.radius,strength:null},me,1,xd)})},shared:m,setGuests:S.setGuests,retry:D.retry,frame(fe,z){if(q=fe,ne.isLost)return;ee();let{isPresenting:te}=c.xr;te?gd(c,()=>ve(fe,z)):ve(fe,z),(te||f.mesh.visible)&&c.render(g,h)},stand:d,setMapLayer:F.setMapLayer,setVeil:f.set,still(fe,z){let te=V&&D.find(V.region);if(!te)throw new Error("no region is open");p(z),S.draw({...fe,region:te.region},h,1)},setDivider:F.setDivider,isMorphedAt:F.isMorphedAt,photo(){return c.xr.isPresenting?Promise.reject(new Error("Pictures are saved outside the headset")):ne.isLost||!C||!D.find(C.region)?.shown?Promise.reject(new Error("There is no picture yet")):(F.draw(C,q),new Promise((fe,z)=>{i.toBlob(te=>te?fe(te):z(new Error("The browser gives no picture")),"image/png")}))},get facts(){let fe=V?.region??0,z=D.find(fe),te=z?.shown?.fading?.ring??z?.shown?.ring??0;return{region:fe,entry:z?.region.entry??null,goal:V?.goal??null,leaving:C?.leaving?.region??null,shown:z?.shown??null,arrived:z?.arrived??-1,received:z?.received??0,expected:z?.expected??0,triangles:z?Vu(z.region,te):{own:0,drawn:0},upload:Y,bounds:V?.bounds??null,...D.holding,shared:U.shared}},dispose(){D.dispose();for(let fe of x)fe.dispose();y.dispose(),E.dispose(),ne.dispose(),c.dispose(),c.forceContextLoss()}}}o(yd,"createViewer");function I_(i,e){let t;try{t=new Ka({canvas:i,antialias:e,powerPreference:"high-performance"})}catch(n){throw new je(n instanceof Error?n.message:String(n),"webgl")}return t.autoClear=!1,t.setClearAlpha(0),t.sortObjects=!1,t.debug.checkShaderErrors=!1,t}o(I_,"createRenderer");function vd(i,e){let t=i.regions[e];if(!t)throw new Error(`there is no region ${e}`);return{manifest:i,entry:t,ring(n){let r=t.rings[n];if(!r)throw new Error(`region ${e} has no ring ${n}`);return r}}}o(vd,"thereOf");function Sd(i){return{places:od(i.regions),faceSize:i.map.face_size,nearShare:i.morph.near_share,marginShare:L_(i),fade:i.growth.fade,open:o(e=>Promise.resolve(vd(i,e)),"open")}}o(Sd,"worldOf");function L_({morph:i,regions:e}){let[t]=e;return!t||!Number.isFinite(t.cut)?i.near_share:Math.max(t.fold_margin/t.cut,Number.EPSILON)}o(L_,"marginShareOf");function ai(i,e,t){let n=JSON.stringify(t)??"nothing";return new je(`manifest.json: ${i}: expected ${e}, got ${n.slice(0,60)}`)}o(ai,"wrong");function Bt(i,e){if(typeof e!="object"||e===null||Array.isArray(e))throw ai(i,"an object",e);return e}o(Bt,"object");function bn(i,e,t,n=Number.MAX_VALUE){if(!(typeof e=="number"&&e>=t&&e<=n))throw ai(i,`a number of at least ${t}`,e);return e}o(bn,"number");function sn(i,e,t,n=Number.MAX_SAFE_INTEGER){let r=bn(i,e,t,n);if(!Number.isSafeInteger(r))throw ai(i,"a whole number",e);return r}o(sn,"integer");function Kr(i,e){if(typeof e!="string")throw ai(i,"text",e);return e}o(Kr,"text");function Fc(i,e,t){let n=t.find(r=>r===e);if(n===void 0)throw ai(i,t.join(" or "),e);return n}o(Fc,"choice");function It(i,e,t,n){if(!Array.isArray(e)||n!==void 0&&e.length!==n)throw ai(i,n===void 0?"a list":`a list of ${n}`,e);return e.map((r,s)=>t(`${i}[${s}]`,r,s))}o(It,"list");function Ai(i,e,t){return e==null?null:t(i,e)}o(Ai,"optional");function Md(i,e){let t=Kr(i,e);if(!/^[0-9a-f]{64}$/.test(t))throw ai(i,"a SHA-256",e);return t}o(Md,"hash");function Vn(i,e){let t=Kr(i,e);if(!/^files\/[0-9a-f]{16}\.[a-z]+$/.test(t))throw ai(i,"the name of a file of the bundle",e);return t}o(Vn,"fileName");var wd="nearfar.bundle",Ed=1,D_=4096,N_=16383,[Oc,Ad,U_]=[6,1e3,1e3],F_=2**31-1,[O_,B_]=[65534,600],jr=1e12;function Td(i){return z_(k_("manifest.json",i))}o(Td,"parseManifest");function k_(i,e){try{return JSON.parse(e)}catch{throw new je(`${i}: expected JSON, got something else`)}}o(k_,"parseJson");function z_(i,e=K_){let t=Bt("manifest",i);if(t.format!==wd)throw new je(`manifest.json: expected the format ${wd}, got another one`);let n=sn("version",t.version,1);if(n>Ed){let m=`it has version ${n}, this page reads ${Ed}`;throw new je(`this bundle was written by a newer nearfar (${m}): update the page`,"newer")}let[r,s,a]=["morph","growth","map"].map(m=>Bt(m,t[m])),c=sn("map.face_size",a?.face_size,1,D_),l=sn("map.tile",a?.tile,1,c);if(c%l!==0)throw new je(`manifest.json: map.tile: expected a divisor of ${c}, got ${l}`);let h=Fc("morph.kind",r?.kind,["blend","cylinder"]),u=Fc("unit",t.unit??"object",["object","triangle"]),p=sn("map.across",a?.across,1,Math.floor(N_/l)),d=V_({face_size:c,tile:l,across:p}),f=Bt("files",t.files),g=It("regions",t.regions,Bt);if(g.length===0||g.length>Ad)throw new je(`manifest.json: regions: expected 1 to ${Ad}, got ${g.length}`);let y={version:n,morph:{kind:h,near_share:bn("morph.near_share",r?.near_share,0,1-1e-9)},growth:{speed:bn("growth.speed",s?.speed,1e-9),reach:bn("growth.reach",s?.reach,1e-9),fade:bn("growth.fade",s?.fade,0)},triangles:sn("triangles",t.triangles,0),bounds:It("bounds",t.bounds,Rd,2),map:{face_size:c,tile:l,across:p},regions:g.map((m,b)=>{let w=`regions[${b}]`;return X_(u,w,q_(w,m,d,b,g.length,e))}),dynamic:Ai("dynamic",t.dynamic,J_),notes:It("notes",t.notes,Kr),files:G_(f)};return W_(y),y}o(z_,"readManifest");function G_(i){return Object.fromEntries(Object.entries(i).map(([e,t])=>[Vn("files",e),H_(e,t)]))}o(G_,"readFiles");function V_({face_size:i,tile:e}){return Oc*(i/e)**2}o(V_,"tilesOf");function H_(i,e){let t=Bt(i,e);return{bytes:sn(`${i}.bytes`,t.bytes,0,F_),sha256:Md(`${i}.sha256`,t.sha256)}}o(H_,"parseFileEntry");function W_({regions:i,dynamic:e,files:t}){let n=[...i.flatMap(({rings:r})=>r.flatMap(Hr)),...i.flatMap(({by_footprint:r})=>r?[...r.portions.flatMap(Vr),...Ja(r.map)]:[]),...e?Vr(e):[]];for(let r of n)if(!Object.hasOwn(t,r))throw new je(`manifest.json: files: expected ${r}, which is used, among them`)}o(W_,"checkListed");function Rd(i,e){return It(i,e,(t,n)=>bn(t,n,-jr,jr),3)}o(Rd,"point");function q_(i,e,t,n,r,s){let a=Bt(`${i}.range`,e.range),c=It(`${i}.rings`,e.rings,(g,y,m)=>s(g,y,m,t)),l=c.map(({radius:g})=>g),h=l[0]===0&&l.every((g,y)=>y===0||g>(l[y-1]??0));if(c.length<2||c.length>U_||!h)throw new je(`manifest.json: ${i}.rings: expected radii that ascend from 0`);let u=o((g,y)=>sn(g,y,0,r-1),"other"),p=It(`${i}.neighbours`,e.neighbours,u);if(p.includes(n))throw new je(`manifest.json: ${i}.neighbours: expected other regions`);let[d,f]=["least","step"].map(g=>bn(`${i}.range.${g}`,a[g],Number.MIN_VALUE));if(!(Math.abs(Math.log(d))+O_*f<=B_))throw new je(`manifest.json: ${i}.range: expected ranges that are finite`);return{center:Rd(`${i}.center`,e.center),fold_margin:bn(`${i}.fold_margin`,e.fold_margin,0),neighbours:p,range:{least:d,step:f},rings:c,cut:1/0,by_footprint:Ai(`${i}.by_footprint`,e.by_footprint,j_)}}o(q_,"region");function X_(i,e,t){if(i==="object")return t;if(t.rings.length!==2)throw new je(`manifest.json: ${e}.rings: expected two with unit triangle`);return{...t,cut:t.rings[1]?.radius??1/0}}o(X_,"cutBy");function K_(i,e,t,n){let r=Bt(i,e);return{...Cd(i,r),radius:bn(`${i}.radius`,r.radius,0,jr),map:Y_(`${i}.map`,r.map,t,n)}}o(K_,"ring");function Cd(i,e){let t=Bt(i,e);return{objects:sn(`${i}.objects`,t.objects,0),triangles:sn(`${i}.triangles`,t.triangles,0),geometry:Ai(`${i}.geometry`,t.geometry,Vn),parts:It(`${i}.parts`,t.parts,Vn)}}o(Cd,"group");function j_(i,e){let t=Bt(i,e),n=Bt(`${i}.map`,t.map),r=o(s=>It(`${i}.map.${s}`,n[s],Vn,Oc),"faces");return{portions:It(`${i}.portions`,t.portions,Cd),map:{tiles:[],color:r("color"),range:r("range")}}}o(j_,"footprints");function Y_(i,e,t,n){let r=Bt(i,e),s=o((h,u)=>Array.isArray(u)?It(h,u,Vn,Oc):Vn(h,u),"names"),a={tiles:It(`${i}.tiles`,r.tiles??[],(h,u)=>sn(h,u,0,n-1)),color:Ai(`${i}.color`,r.color,s),range:Ai(`${i}.range`,r.range,s)},c=o(h=>new je(`manifest.json: ${i}: expected ${h}`),"wrong");if(t===0){if(!Array.isArray(a.color))throw c("six pictures for ring 0");return a}if(a.tiles.some((h,u)=>u>0&&h<=(a.tiles[u-1]??0)))throw c("numbers of tiles that ascend");let l=a.tiles.length>0;if(l!==(typeof a.color=="string"))throw c("a picture exactly where tiles change");if(t===1&&!Array.isArray(a.range))throw c("six files of ranges for ring 1");if(t>1&&l!==(typeof a.range=="string"))throw c("ranges exactly where tiles change");return a}o(Y_,"mapOf");function J_(i,e){let t=Bt(i,e);return{geometry:Vn(`${i}.geometry`,t.geometry),parts:It(`${i}.parts`,t.parts,Vn),triangles:sn(`${i}.triangles`,t.triangles,0),instances:It(`${i}.instances`,t.instances,$_)}}o(J_,"moving");function $_(i,e){let t=Bt(i,e),n=o((r,s)=>It(r,s,(a,c)=>bn(a,c,-jr,jr),4),"row");return{object:Kr(`${i}.object`,t.object),transform:Ai(`${i}.transform`,t.transform,(r,s)=>It(r,s,n,4))}}o($_,"movingEntry");function Pd(i){let e=new Map;function t(n){let r=new AbortController,s=new Set,a={askers:s,stop:r,size:0,result:Promise.resolve().then(()=>i(n,r.signal,l=>{a.size+=l;for(let h of s)h(l)}))};e.set(n,a);let c=o(()=>{e.get(n)===a&&e.delete(n)},"forget");return a.result.then(c,c),a}return o(t,"begin"),async(n,r,s)=>{r.throwIfAborted();let a=e.get(n)??t(n),c=a.askers.size===0,l=o(u=>s(u),"own");a.askers.add(l),a.size>0&&l(a.size);let h=o(()=>{a.askers.delete(l),!(a.askers.size>0)&&(e.get(n)===a&&e.delete(n),a.stop.abort(r.reason))},"leave");return new Promise((u,p)=>{let d=o(()=>{h(),p(r.reason)},"stopped");r.addEventListener("abort",d,{once:!0});let f=o(g=>u(c?g:g.slice(0)),"copied");a.result.then(f,p).finally(()=>r.removeEventListener("abort",d))})}}o(Pd,"createShared");function Id(i){let e=i,t=new Set;function n(r){return new Promise((s,a)=>{let c=o(()=>{t.delete(l),a(r.reason)},"leave"),l=o(()=>{r.removeEventListener("abort",c),s()},"enter");t.add(l),r.addEventListener("abort",c,{once:!0})})}return o(n,"place"),async(r,s)=>{r.throwIfAborted(),e===0?await n(r):e-=1;try{return await s()}finally{let[a]=t;a?(t.delete(a),a()):e+=1}}}o(Id,"createSlots");var Z_=2,Q_="manifest.json";async function Ld(i,e,t){let n=new Map,r=Math.random().toString(36).slice(2),s=0,a=o((f,g)=>{let y=n.get(f?.id);if(!y)return;n.delete(f.id);let[m]=g;"problem"in f?y.failed(new je(f.problem)):m?y.done({data:ex(m),bytes:f.bytes}):y.failed(new je("the kernel answers without a file"))},"answered");i.on("msg:custom",a);function c(f,g,y){y.throwIfAborted();let m=`${r}-${++s}`;return new Promise((b,w)=>{let T=o(()=>{n.delete(m),w(y.reason)},"leave");y.addEventListener("abort",T,{once:!0});let x=o(()=>y.removeEventListener("abort",T),"free");n.set(m,{done:o(S=>(x(),b(S)),"done"),failed:o(S=>(x(),w(S)),"failed")}),i.send({kind:"read",id:m,name:f,start:g})})}o(c,"ask");async function l(f,g,y,m){let b=[],w=0;for(;;){let T=await c(f,w,y);if(b.push(T.data),w+=T.data.length,e(T.data.length),m(T.data.length),g!==null&&T.bytes!==g)throw new je(`${f}: expected ${g} bytes, as the manifest lists it, got ${T.bytes}`);if(w===T.bytes)return await new Blob(b).arrayBuffer();if(T.data.length===0||w>T.bytes)throw new je(`${f}: expected ${T.bytes} bytes`)}}o(l,"load");let h=await l(Q_,null,t,()=>{}),u=Td(new TextDecoder().decode(h)),p=Id(Z_),d=Pd((f,g,y)=>{let m=u.files[f]?.bytes;if(m===void 0)throw new je(`${f}: the manifest does not list this file`);return p(g,()=>l(f,m,g,y))});return{manifest:u,fetch:o((f,g,y=()=>{})=>d(f,g,y),"fetch"),distrust:o(()=>{},"distrust"),dispose(){i.off("msg:custom",a),n.clear()}}}o(Ld,"openKernel");function ex(i){return new Uint8Array(i.buffer,i.byteOffset,i.byteLength).slice()}o(ex,"bytesOf");function Dd(i){let e=[],t=Number.NEGATIVE_INFINITY,n=!1;return{tell(r,s){let a=Object.entries(r).filter(([c,l])=>!Nd(i.get(c),l));if(!(a.length===0||s-t<100)){t=s,n=!0;for(let[c,l]of a)i.set(c,l);n=!1,i.save_changes()}},hear(r,s){let a=!1,c=o(()=>{n||a||(a=!0,queueMicrotask(()=>{a=!1,s()}))},"callback");for(let l of r)e.push([`change:${l}`,c]),i.on(`change:${l}`,c)},dispose(){for(let[r,s]of e)i.off(r,s);e.length=0}}}o(Dd,"createMirror");function Nd(i,e){return!Array.isArray(i)||!Array.isArray(e)?Object.is(i,e):i.length===e.length&&i.every((t,n)=>Nd(t,e[n]))}o(Nd,"isSame");var tx=.1,nx="The browser has taken the graphics away. The picture comes back as soon as they do.",Ud=["position","yaw","pitch"];function ix({model:i,el:e}){let t=rx(i,e),n=new AbortController,r=null,s=o(()=>{},"end"),a=o(c=>{if(n.signal.aborted)return;let l=c instanceof Error?c.message:String(c);t.complain(l),i.set("problem",l),i.save_changes()},"failed");return Ld(i,()=>{},n.signal).then(c=>{r=c,n.signal.aborted?c.dispose():s=sx(i,t,c,a)}).catch(a),()=>{n.abort(new Error("the view is gone")),r?.dispose(),s(),t.host.remove()}}o(ix,"render");function rx(i,e){let t=document.createElement("div"),[n,r]=[document.createElement("canvas"),document.createElement("p")];t.className="nearfar-view",t.dataset.lmSuppressShortcuts="true",n.tabIndex=0,n.setAttribute("aria-label","3D view: drag to look, W A S D and arrows to walk"),n.style.width=`${i.get("width")}px`,n.style.aspectRatio=`${i.get("width")} / ${i.get("height")}`,r.setAttribute("role","status"),r.textContent="Loading\u2026",t.append(n,r),e.append(t);let s="",a=o(c=>{r.textContent!==(s||c)&&(r.textContent=s||c)},"say");return{host:t,canvas:n,say:a,complain:o(c=>a(s=c),"complain")}}o(rx,"createView");function sx(i,e,t,n){let{canvas:r,host:s}=e,{arrange:a,isSmooth:c,isWhole:l}=Sl(String(i.get("strategy"))),h=Sd(a(t.manifest)),u=URL.createObjectURL(new Blob([Yc],{type:"text/javascript"})),p=o(()=>Object.fromEntries(Ud.map(w=>[w,i.get(w)])),"asked"),d=yl(r,{start:p(),keys:r}),f=yd(r,{world:h,fetch:t.fetch,worker:new URL(u),angle:Number(i.get("angle")),antialias:!0,isSmooth:c,isWhole:l,failed:n,lost:o(w=>e.complain(w?nx:""),"lost"),moved:d.setPose});s.nearfar={viewer:f};let g=Dd(i);g.hear(Ud,()=>{let w=p();h.places.nearest(w.position)===f.facts.region?d.setPose(w):f.go(w)}),g.hear(["angle"],()=>{f.camera.fov=Number(i.get("angle")),f.camera.updateProjectionMatrix()}),f.open(h.places.nearest(p().position));let y=!0,m=new IntersectionObserver(w=>{y=w.at(-1)?.isIntersecting??!0});m.observe(r);let b=performance.now();return f.renderer.setAnimationLoop(w=>{let T=Math.max(w-b,0)/1e3;if(b=w,!y)return;let x=d.update(T);f.frame(x,Math.min(T,tx));let{bounds:S,shown:E,region:_,entry:A,goal:U,arrived:I}=f.facts;d.setBounds(S);let D=(A?.rings.length??1)-1;I>=0&&e.say(I<D?`Ring ${I} of ${D}`:"");let{radius:F,strength:V}=E?.grown??{radius:0,strength:0},C={region:_,ring:E?.ring??-1,radius:F,strength:V};g.tell(U===null?{...x,...C}:C,w)}),()=>{f.renderer.setAnimationLoop(null),m.disconnect(),g.dispose(),d.dispose(),f.dispose(),URL.revokeObjectURL(u)}}o(sx,"show");var oT={render:ix};export{oT as default};
