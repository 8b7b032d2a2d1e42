/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Va={ROTATE:0,DOLLY:1,PAN:2},ka={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},kg=0,lu=1,Bg=2,Xr=1,Vg=2,ys=3,qn=0,Qt=1,yn=2,ui=0,za=1,du=2,uu=3,hu=4,zg=5,Zi=100,Gg=101,Wg=102,Hg=103,jg=104,Xg=200,Yg=201,Zg=202,Kg=203,Yc=204,Zc=205,Jg=206,qg=207,$g=208,Qg=209,eb=210,tb=211,nb=212,ib=213,ab=214,Kc=0,no=1,Jc=2,ta=3,qc=4,$c=5,io=6,Qc=7,_p=0,sb=1,rb=2,Jn=0,vp=1,yp=2,xp=3,Ep=4,Sp=5,Mp=6,Ap=7,wp=300,na=301,ja=302,ko=303,Bo=304,vo=306,el=1e3,li=1001,tl=1002,Wt=1003,ob=1004,qs=1005,Ht=1006,Vo=1007,Ji=1008,xn=1009,Tp=1010,Ip=1011,Rs=1012,sd=1013,On=1014,Zn=1015,pi=1016,rd=1017,od=1018,Cs=1020,Np=35902,Rp=35899,Cp=1021,Up=1022,En=1023,mi=1026,qi=1027,Pp=1028,cd=1029,ia=1030,ld=1031,dd=1033,Yr=33776,Zr=33777,Kr=33778,Jr=33779,nl=35840,il=35841,al=35842,sl=35843,rl=36196,ol=37492,cl=37496,ll=37488,dl=37489,ao=37490,ul=37491,hl=37808,fl=37809,pl=37810,ml=37811,gl=37812,bl=37813,_l=37814,vl=37815,yl=37816,xl=37817,El=37818,Sl=37819,Ml=37820,Al=37821,wl=36492,Tl=36494,Il=36495,Nl=36283,Rl=36284,so=36285,Cl=36286,cb=3200,fu=0,lb=1,Ci="",bn="srgb",Us="srgb-linear",ro="linear",Qe="srgb",da=7680,pu=519,db=512,ub=513,hb=514,ud=515,fb=516,pb=517,hd=518,mb=519,Ul=35044,gb=35048,mu="300 es",Kn=2e3,oo=2001;function bb(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function co(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function _b(){const n=co("canvas");return n.style.display="block",n}const gu={};function lo(...n){const e="THREE."+n.shift();console.log(e,...n)}function Lp(n){const e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){const t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ne(...n){n=Lp(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Xe(...n){n=Lp(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Pl(...n){const e=n.join(" ");e in gu||(gu[e]=!0,Ne(...n))}function vb(n,e,t){return new Promise(function(i,a){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:a();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}const yb={[Kc]:no,[Jc]:io,[qc]:Qc,[ta]:$c,[no]:Kc,[io]:Jc,[Qc]:qc,[$c]:ta};class Fi{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){const i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){const i=this._listeners;if(i===void 0)return;const a=i[e];if(a!==void 0){const s=a.indexOf(t);s!==-1&&a.splice(s,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const i=t[e.type];if(i!==void 0){e.target=this;const a=i.slice(0);for(let s=0,r=a.length;s<r;s++)a[s].call(this,e);e.target=null}}}const Xt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];let bu=1234567;const Ss=Math.PI/180,Ps=180/Math.PI;function hi(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Xt[n&255]+Xt[n>>8&255]+Xt[n>>16&255]+Xt[n>>24&255]+"-"+Xt[e&255]+Xt[e>>8&255]+"-"+Xt[e>>16&15|64]+Xt[e>>24&255]+"-"+Xt[t&63|128]+Xt[t>>8&255]+"-"+Xt[t>>16&255]+Xt[t>>24&255]+Xt[i&255]+Xt[i>>8&255]+Xt[i>>16&255]+Xt[i>>24&255]).toLowerCase()}function Pe(n,e,t){return Math.max(e,Math.min(t,n))}function fd(n,e){return(n%e+e)%e}function xb(n,e,t,i,a){return i+(n-e)*(a-i)/(t-e)}function Eb(n,e,t){return n!==e?(t-n)/(e-n):0}function Ms(n,e,t){return(1-t)*n+t*e}function Sb(n,e,t,i){return Ms(n,e,1-Math.exp(-t*i))}function Mb(n,e=1){return e-Math.abs(fd(n,e*2)-e)}function Ab(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function wb(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function Tb(n,e){return n+Math.floor(Math.random()*(e-n+1))}function Ib(n,e){return n+Math.random()*(e-n)}function Nb(n){return n*(.5-Math.random())}function Rb(n){n!==void 0&&(bu=n);let e=bu+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Cb(n){return n*Ss}function Ub(n){return n*Ps}function Pb(n){return(n&n-1)===0&&n!==0}function Lb(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Db(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ob(n,e,t,i,a){const s=Math.cos,r=Math.sin,o=s(t/2),c=r(t/2),l=s((e+i)/2),u=r((e+i)/2),h=s((e-i)/2),d=r((e-i)/2),f=s((i-e)/2),g=r((i-e)/2);switch(a){case"XYX":n.set(o*u,c*h,c*d,o*l);break;case"YZY":n.set(c*d,o*u,c*h,o*l);break;case"ZXZ":n.set(c*h,c*d,o*u,o*l);break;case"XZX":n.set(o*u,c*g,c*f,o*l);break;case"YXY":n.set(c*f,o*u,c*g,o*l);break;case"ZYZ":n.set(c*g,c*f,o*u,o*l);break;default:Ne("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+a)}}function Ln(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function et(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}const Dp={DEG2RAD:Ss,RAD2DEG:Ps,generateUUID:hi,clamp:Pe,euclideanModulo:fd,mapLinear:xb,inverseLerp:Eb,lerp:Ms,damp:Sb,pingpong:Mb,smoothstep:Ab,smootherstep:wb,randInt:Tb,randFloat:Ib,randFloatSpread:Nb,seededRandom:Rb,degToRad:Cb,radToDeg:Ub,isPowerOfTwo:Pb,ceilPowerOfTwo:Lb,floorPowerOfTwo:Db,setQuaternionFromProperEuler:Ob,normalize:et,denormalize:Ln};class we{static{we.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,a=e.elements;return this.x=a[0]*t+a[3]*i+a[6],this.y=a[1]*t+a[4]*i+a[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Pe(this.x,e.x,t.x),this.y=Pe(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Pe(this.x,e,t),this.y=Pe(this.y,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Pe(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Pe(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),a=Math.sin(t),s=this.x-e.x,r=this.y-e.y;return this.x=s*i-r*a+e.x,this.y=s*a+r*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Di{constructor(e=0,t=0,i=0,a=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=a}static slerpFlat(e,t,i,a,s,r,o){let c=i[a+0],l=i[a+1],u=i[a+2],h=i[a+3],d=s[r+0],f=s[r+1],g=s[r+2],y=s[r+3];if(h!==y||c!==d||l!==f||u!==g){let p=c*d+l*f+u*g+h*y;p<0&&(d=-d,f=-f,g=-g,y=-y,p=-p);let m=1-o;if(p<.9995){const b=Math.acos(p),x=Math.sin(b);m=Math.sin(m*b)/x,o=Math.sin(o*b)/x,c=c*m+d*o,l=l*m+f*o,u=u*m+g*o,h=h*m+y*o}else{c=c*m+d*o,l=l*m+f*o,u=u*m+g*o,h=h*m+y*o;const b=1/Math.sqrt(c*c+l*l+u*u+h*h);c*=b,l*=b,u*=b,h*=b}}e[t]=c,e[t+1]=l,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,a,s,r){const o=i[a],c=i[a+1],l=i[a+2],u=i[a+3],h=s[r],d=s[r+1],f=s[r+2],g=s[r+3];return e[t]=o*g+u*h+c*f-l*d,e[t+1]=c*g+u*d+l*h-o*f,e[t+2]=l*g+u*f+o*d-c*h,e[t+3]=u*g-o*h-c*d-l*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,a){return this._x=e,this._y=t,this._z=i,this._w=a,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,a=e._y,s=e._z,r=e._order,o=Math.cos,c=Math.sin,l=o(i/2),u=o(a/2),h=o(s/2),d=c(i/2),f=c(a/2),g=c(s/2);switch(r){case"XYZ":this._x=d*u*h+l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h+d*f*g;break;case"YZX":this._x=d*u*h+l*f*g,this._y=l*f*h+d*u*g,this._z=l*u*g-d*f*h,this._w=l*u*h-d*f*g;break;case"XZY":this._x=d*u*h-l*f*g,this._y=l*f*h-d*u*g,this._z=l*u*g+d*f*h,this._w=l*u*h+d*f*g;break;default:Ne("Quaternion: .setFromEuler() encountered an unknown order: "+r)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,a=Math.sin(i);return this._x=e.x*a,this._y=e.y*a,this._z=e.z*a,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],a=t[4],s=t[8],r=t[1],o=t[5],c=t[9],l=t[2],u=t[6],h=t[10],d=i+o+h;if(d>0){const f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-c)*f,this._y=(s-l)*f,this._z=(r-a)*f}else if(i>o&&i>h){const f=2*Math.sqrt(1+i-o-h);this._w=(u-c)/f,this._x=.25*f,this._y=(a+r)/f,this._z=(s+l)/f}else if(o>h){const f=2*Math.sqrt(1+o-i-h);this._w=(s-l)/f,this._x=(a+r)/f,this._y=.25*f,this._z=(c+u)/f}else{const f=2*Math.sqrt(1+h-i-o);this._w=(r-a)/f,this._x=(s+l)/f,this._y=(c+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Pe(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const a=Math.min(1,t/i);return this.slerp(e,a),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,a=e._y,s=e._z,r=e._w,o=t._x,c=t._y,l=t._z,u=t._w;return this._x=i*u+r*o+a*l-s*c,this._y=a*u+r*c+s*o-i*l,this._z=s*u+r*l+i*c-a*o,this._w=r*u-i*o-a*c-s*l,this._onChangeCallback(),this}slerp(e,t){let i=e._x,a=e._y,s=e._z,r=e._w,o=this.dot(e);o<0&&(i=-i,a=-a,s=-s,r=-r,o=-o);let c=1-t;if(o<.9995){const l=Math.acos(o),u=Math.sin(l);c=Math.sin(c*l)/u,t=Math.sin(t*l)/u,this._x=this._x*c+i*t,this._y=this._y*c+a*t,this._z=this._z*c+s*t,this._w=this._w*c+r*t,this._onChangeCallback()}else this._x=this._x*c+i*t,this._y=this._y*c+a*t,this._z=this._z*c+s*t,this._w=this._w*c+r*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),a=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(a*Math.sin(e),a*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class U{static{U.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(_u.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(_u.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,a=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*a,this.y=s[1]*t+s[4]*i+s[7]*a,this.z=s[2]*t+s[5]*i+s[8]*a,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,a=this.z,s=e.elements,r=1/(s[3]*t+s[7]*i+s[11]*a+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*a+s[12])*r,this.y=(s[1]*t+s[5]*i+s[9]*a+s[13])*r,this.z=(s[2]*t+s[6]*i+s[10]*a+s[14])*r,this}applyQuaternion(e){const t=this.x,i=this.y,a=this.z,s=e.x,r=e.y,o=e.z,c=e.w,l=2*(r*a-o*i),u=2*(o*t-s*a),h=2*(s*i-r*t);return this.x=t+c*l+r*h-o*u,this.y=i+c*u+o*l-s*h,this.z=a+c*h+s*u-r*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,a=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*a,this.y=s[1]*t+s[5]*i+s[9]*a,this.z=s[2]*t+s[6]*i+s[10]*a,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Pe(this.x,e.x,t.x),this.y=Pe(this.y,e.y,t.y),this.z=Pe(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Pe(this.x,e,t),this.y=Pe(this.y,e,t),this.z=Pe(this.z,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Pe(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,a=e.y,s=e.z,r=t.x,o=t.y,c=t.z;return this.x=a*c-s*o,this.y=s*r-i*c,this.z=i*o-a*r,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return zo.copy(this).projectOnVector(e),this.sub(zo)}reflect(e){return this.sub(zo.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Pe(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,a=this.z-e.z;return t*t+i*i+a*a}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const a=Math.sin(t)*e;return this.x=a*Math.sin(i),this.y=Math.cos(t)*e,this.z=a*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),a=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=a,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const zo=new U,_u=new Di;class De{static{De.prototype.isMatrix3=!0}constructor(e,t,i,a,s,r,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,a,s,r,o,c,l)}set(e,t,i,a,s,r,o,c,l){const u=this.elements;return u[0]=e,u[1]=a,u[2]=o,u[3]=t,u[4]=s,u[5]=c,u[6]=i,u[7]=r,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,a=t.elements,s=this.elements,r=i[0],o=i[3],c=i[6],l=i[1],u=i[4],h=i[7],d=i[2],f=i[5],g=i[8],y=a[0],p=a[3],m=a[6],b=a[1],x=a[4],v=a[7],M=a[2],w=a[5],N=a[8];return s[0]=r*y+o*b+c*M,s[3]=r*p+o*x+c*w,s[6]=r*m+o*v+c*N,s[1]=l*y+u*b+h*M,s[4]=l*p+u*x+h*w,s[7]=l*m+u*v+h*N,s[2]=d*y+f*b+g*M,s[5]=d*p+f*x+g*w,s[8]=d*m+f*v+g*N,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],a=e[2],s=e[3],r=e[4],o=e[5],c=e[6],l=e[7],u=e[8];return t*r*u-t*o*l-i*s*u+i*o*c+a*s*l-a*r*c}invert(){const e=this.elements,t=e[0],i=e[1],a=e[2],s=e[3],r=e[4],o=e[5],c=e[6],l=e[7],u=e[8],h=u*r-o*l,d=o*c-u*s,f=l*s-r*c,g=t*h+i*d+a*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const y=1/g;return e[0]=h*y,e[1]=(a*l-u*i)*y,e[2]=(o*i-a*r)*y,e[3]=d*y,e[4]=(u*t-a*c)*y,e[5]=(a*s-o*t)*y,e[6]=f*y,e[7]=(i*c-l*t)*y,e[8]=(r*t-i*s)*y,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,a,s,r,o){const c=Math.cos(s),l=Math.sin(s);return this.set(i*c,i*l,-i*(c*r+l*o)+r+e,-a*l,a*c,-a*(-l*r+c*o)+o+t,0,0,1),this}scale(e,t){return this.premultiply(Go.makeScale(e,t)),this}rotate(e){return this.premultiply(Go.makeRotation(-e)),this}translate(e,t){return this.premultiply(Go.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let a=0;a<9;a++)if(t[a]!==i[a])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const Go=new De,vu=new De().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),yu=new De().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Fb(){const n={enabled:!0,workingColorSpace:Us,spaces:{},convert:function(a,s,r){return this.enabled===!1||s===r||!s||!r||(this.spaces[s].transfer===Qe&&(a.r=fi(a.r),a.g=fi(a.g),a.b=fi(a.b)),this.spaces[s].primaries!==this.spaces[r].primaries&&(a.applyMatrix3(this.spaces[s].toXYZ),a.applyMatrix3(this.spaces[r].fromXYZ)),this.spaces[r].transfer===Qe&&(a.r=Ga(a.r),a.g=Ga(a.g),a.b=Ga(a.b))),a},workingToColorSpace:function(a,s){return this.convert(a,this.workingColorSpace,s)},colorSpaceToWorking:function(a,s){return this.convert(a,s,this.workingColorSpace)},getPrimaries:function(a){return this.spaces[a].primaries},getTransfer:function(a){return a===Ci?ro:this.spaces[a].transfer},getToneMappingMode:function(a){return this.spaces[a].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(a,s=this.workingColorSpace){return a.fromArray(this.spaces[s].luminanceCoefficients)},define:function(a){Object.assign(this.spaces,a)},_getMatrix:function(a,s,r){return a.copy(this.spaces[s].toXYZ).multiply(this.spaces[r].fromXYZ)},_getDrawingBufferColorSpace:function(a){return this.spaces[a].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(a=this.workingColorSpace){return this.spaces[a].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(a,s){return Pl("ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(a,s)},toWorkingColorSpace:function(a,s){return Pl("ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(a,s)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Us]:{primaries:e,whitePoint:i,transfer:ro,toXYZ:vu,fromXYZ:yu,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:bn},outputColorSpaceConfig:{drawingBufferColorSpace:bn}},[bn]:{primaries:e,whitePoint:i,transfer:Qe,toXYZ:vu,fromXYZ:yu,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:bn}}}),n}const je=Fb();function fi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ga(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}let ua;class kb{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ua===void 0&&(ua=co("canvas")),ua.width=e.width,ua.height=e.height;const a=ua.getContext("2d");e instanceof ImageData?a.putImageData(e,0,0):a.drawImage(e,0,0,e.width,e.height),i=ua}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=co("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const a=i.getImageData(0,0,e.width,e.height),s=a.data;for(let r=0;r<s.length;r++)s[r]=fi(s[r]/255)*255;return i.putImageData(a,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(fi(t[i]/255)*255):t[i]=fi(t[i]);return{data:t,width:e.width,height:e.height}}else return Ne("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let Bb=0;class pd{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Bb++}),this.uuid=hi(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},a=this.data;if(a!==null){let s;if(Array.isArray(a)){s=[];for(let r=0,o=a.length;r<o;r++)a[r].isDataTexture?s.push(Wo(a[r].image)):s.push(Wo(a[r]))}else s=Wo(a);i.url=s}return t||(e.images[this.uuid]=i),i}}function Wo(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?kb.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ne("Texture: Unable to serialize Texture."),{})}let Vb=0;const Ho=new U;class en extends Fi{constructor(e=en.DEFAULT_IMAGE,t=en.DEFAULT_MAPPING,i=li,a=li,s=Ht,r=Ji,o=En,c=xn,l=en.DEFAULT_ANISOTROPY,u=Ci){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Vb++}),this.uuid=hi(),this.name="",this.source=new pd(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=a,this.magFilter=s,this.minFilter=r,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new we(0,0),this.repeat=new we(1,1),this.center=new we(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new De,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.normalized=!1}get width(){return this.source.getSize(Ho).x}get height(){return this.source.getSize(Ho).y}get depth(){return this.source.getSize(Ho).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const i=e[t];if(i===void 0){Ne(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const a=this[t];if(a===void 0){Ne(`Texture.setValues(): property '${t}' does not exist.`);continue}a&&i&&a.isVector2&&i.isVector2||a&&i&&a.isVector3&&i.isVector3||a&&i&&a.isMatrix3&&i.isMatrix3?a.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==wp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case el:e.x=e.x-Math.floor(e.x);break;case li:e.x=e.x<0?0:1;break;case tl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case el:e.y=e.y-Math.floor(e.y);break;case li:e.y=e.y<0?0:1;break;case tl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}en.DEFAULT_IMAGE=null;en.DEFAULT_MAPPING=wp;en.DEFAULT_ANISOTROPY=1;class ut{static{ut.prototype.isVector4=!0}constructor(e=0,t=0,i=0,a=1){this.x=e,this.y=t,this.z=i,this.w=a}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,a){return this.x=e,this.y=t,this.z=i,this.w=a,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,a=this.z,s=this.w,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*a+r[12]*s,this.y=r[1]*t+r[5]*i+r[9]*a+r[13]*s,this.z=r[2]*t+r[6]*i+r[10]*a+r[14]*s,this.w=r[3]*t+r[7]*i+r[11]*a+r[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,a,s;const c=e.elements,l=c[0],u=c[4],h=c[8],d=c[1],f=c[5],g=c[9],y=c[2],p=c[6],m=c[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(g+p)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const x=(l+1)/2,v=(f+1)/2,M=(m+1)/2,w=(u+d)/4,N=(h+y)/4,_=(g+p)/4;return x>v&&x>M?x<.01?(i=0,a=.707106781,s=.707106781):(i=Math.sqrt(x),a=w/i,s=N/i):v>M?v<.01?(i=.707106781,a=0,s=.707106781):(a=Math.sqrt(v),i=w/a,s=_/a):M<.01?(i=.707106781,a=.707106781,s=0):(s=Math.sqrt(M),i=N/s,a=_/s),this.set(i,a,s,t),this}let b=Math.sqrt((p-g)*(p-g)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(b)<.001&&(b=1),this.x=(p-g)/b,this.y=(h-y)/b,this.z=(d-u)/b,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Pe(this.x,e.x,t.x),this.y=Pe(this.y,e.y,t.y),this.z=Pe(this.z,e.z,t.z),this.w=Pe(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Pe(this.x,e,t),this.y=Pe(this.y,e,t),this.z=Pe(this.z,e,t),this.w=Pe(this.w,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Pe(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class zb extends Fi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ht,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new ut(0,0,e,t),this.scissorTest=!1,this.viewport=new ut(0,0,e,t),this.textures=[];const a={width:e,height:t,depth:i.depth},s=new en(a),r=i.count;for(let o=0;o<r;o++)this.textures[o]=s.clone(),this.textures[o].isRenderTargetTexture=!0,this.textures[o].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(e={}){const t={minFilter:Ht,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let a=0,s=this.textures.length;a<s;a++)this.textures[a].image.width=e,this.textures[a].image.height=t,this.textures[a].image.depth=i,this.textures[a].isData3DTexture!==!0&&(this.textures[a].isArrayTexture=this.textures[a].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const a=Object.assign({},e.textures[t].image);this.textures[t].source=new pd(a)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this.multiview=e.multiview,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Dn extends zb{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class Op extends en{constructor(e=null,t=1,i=1,a=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:a},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class Gb extends en{constructor(e=null,t=1,i=1,a=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:a},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class qe{static{qe.prototype.isMatrix4=!0}constructor(e,t,i,a,s,r,o,c,l,u,h,d,f,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,a,s,r,o,c,l,u,h,d,f,g,y,p)}set(e,t,i,a,s,r,o,c,l,u,h,d,f,g,y,p){const m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=a,m[1]=s,m[5]=r,m[9]=o,m[13]=c,m[2]=l,m[6]=u,m[10]=h,m[14]=d,m[3]=f,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new qe().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinant()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinant()===0)return this.identity();const t=this.elements,i=e.elements,a=1/ha.setFromMatrixColumn(e,0).length(),s=1/ha.setFromMatrixColumn(e,1).length(),r=1/ha.setFromMatrixColumn(e,2).length();return t[0]=i[0]*a,t[1]=i[1]*a,t[2]=i[2]*a,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*r,t[9]=i[9]*r,t[10]=i[10]*r,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,a=e.y,s=e.z,r=Math.cos(i),o=Math.sin(i),c=Math.cos(a),l=Math.sin(a),u=Math.cos(s),h=Math.sin(s);if(e.order==="XYZ"){const d=r*u,f=r*h,g=o*u,y=o*h;t[0]=c*u,t[4]=-c*h,t[8]=l,t[1]=f+g*l,t[5]=d-y*l,t[9]=-o*c,t[2]=y-d*l,t[6]=g+f*l,t[10]=r*c}else if(e.order==="YXZ"){const d=c*u,f=c*h,g=l*u,y=l*h;t[0]=d+y*o,t[4]=g*o-f,t[8]=r*l,t[1]=r*h,t[5]=r*u,t[9]=-o,t[2]=f*o-g,t[6]=y+d*o,t[10]=r*c}else if(e.order==="ZXY"){const d=c*u,f=c*h,g=l*u,y=l*h;t[0]=d-y*o,t[4]=-r*h,t[8]=g+f*o,t[1]=f+g*o,t[5]=r*u,t[9]=y-d*o,t[2]=-r*l,t[6]=o,t[10]=r*c}else if(e.order==="ZYX"){const d=r*u,f=r*h,g=o*u,y=o*h;t[0]=c*u,t[4]=g*l-f,t[8]=d*l+y,t[1]=c*h,t[5]=y*l+d,t[9]=f*l-g,t[2]=-l,t[6]=o*c,t[10]=r*c}else if(e.order==="YZX"){const d=r*c,f=r*l,g=o*c,y=o*l;t[0]=c*u,t[4]=y-d*h,t[8]=g*h+f,t[1]=h,t[5]=r*u,t[9]=-o*u,t[2]=-l*u,t[6]=f*h+g,t[10]=d-y*h}else if(e.order==="XZY"){const d=r*c,f=r*l,g=o*c,y=o*l;t[0]=c*u,t[4]=-h,t[8]=l*u,t[1]=d*h+y,t[5]=r*u,t[9]=f*h-g,t[2]=g*h-f,t[6]=o*u,t[10]=y*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Wb,e,Hb)}lookAt(e,t,i){const a=this.elements;return dn.subVectors(e,t),dn.lengthSq()===0&&(dn.z=1),dn.normalize(),Si.crossVectors(i,dn),Si.lengthSq()===0&&(Math.abs(i.z)===1?dn.x+=1e-4:dn.z+=1e-4,dn.normalize(),Si.crossVectors(i,dn)),Si.normalize(),$s.crossVectors(dn,Si),a[0]=Si.x,a[4]=$s.x,a[8]=dn.x,a[1]=Si.y,a[5]=$s.y,a[9]=dn.y,a[2]=Si.z,a[6]=$s.z,a[10]=dn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,a=t.elements,s=this.elements,r=i[0],o=i[4],c=i[8],l=i[12],u=i[1],h=i[5],d=i[9],f=i[13],g=i[2],y=i[6],p=i[10],m=i[14],b=i[3],x=i[7],v=i[11],M=i[15],w=a[0],N=a[4],_=a[8],S=a[12],T=a[1],I=a[5],C=a[9],L=a[13],F=a[2],P=a[6],B=a[10],V=a[14],q=a[3],ee=a[7],le=a[11],ve=a[15];return s[0]=r*w+o*T+c*F+l*q,s[4]=r*N+o*I+c*P+l*ee,s[8]=r*_+o*C+c*B+l*le,s[12]=r*S+o*L+c*V+l*ve,s[1]=u*w+h*T+d*F+f*q,s[5]=u*N+h*I+d*P+f*ee,s[9]=u*_+h*C+d*B+f*le,s[13]=u*S+h*L+d*V+f*ve,s[2]=g*w+y*T+p*F+m*q,s[6]=g*N+y*I+p*P+m*ee,s[10]=g*_+y*C+p*B+m*le,s[14]=g*S+y*L+p*V+m*ve,s[3]=b*w+x*T+v*F+M*q,s[7]=b*N+x*I+v*P+M*ee,s[11]=b*_+x*C+v*B+M*le,s[15]=b*S+x*L+v*V+M*ve,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],a=e[8],s=e[12],r=e[1],o=e[5],c=e[9],l=e[13],u=e[2],h=e[6],d=e[10],f=e[14],g=e[3],y=e[7],p=e[11],m=e[15],b=c*f-l*d,x=o*f-l*h,v=o*d-c*h,M=r*f-l*u,w=r*d-c*u,N=r*h-o*u;return t*(y*b-p*x+m*v)-i*(g*b-p*M+m*w)+a*(g*x-y*M+m*N)-s*(g*v-y*w+p*N)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const a=this.elements;return e.isVector3?(a[12]=e.x,a[13]=e.y,a[14]=e.z):(a[12]=e,a[13]=t,a[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],a=e[2],s=e[3],r=e[4],o=e[5],c=e[6],l=e[7],u=e[8],h=e[9],d=e[10],f=e[11],g=e[12],y=e[13],p=e[14],m=e[15],b=t*o-i*r,x=t*c-a*r,v=t*l-s*r,M=i*c-a*o,w=i*l-s*o,N=a*l-s*c,_=u*y-h*g,S=u*p-d*g,T=u*m-f*g,I=h*p-d*y,C=h*m-f*y,L=d*m-f*p,F=b*L-x*C+v*I+M*T-w*S+N*_;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const P=1/F;return e[0]=(o*L-c*C+l*I)*P,e[1]=(a*C-i*L-s*I)*P,e[2]=(y*N-p*w+m*M)*P,e[3]=(d*w-h*N-f*M)*P,e[4]=(c*T-r*L-l*S)*P,e[5]=(t*L-a*T+s*S)*P,e[6]=(p*v-g*N-m*x)*P,e[7]=(u*N-d*v+f*x)*P,e[8]=(r*C-o*T+l*_)*P,e[9]=(i*T-t*C-s*_)*P,e[10]=(g*w-y*v+m*b)*P,e[11]=(h*v-u*w-f*b)*P,e[12]=(o*S-r*I-c*_)*P,e[13]=(t*I-i*S+a*_)*P,e[14]=(y*x-g*M-p*b)*P,e[15]=(u*M-h*x+d*b)*P,this}scale(e){const t=this.elements,i=e.x,a=e.y,s=e.z;return t[0]*=i,t[4]*=a,t[8]*=s,t[1]*=i,t[5]*=a,t[9]*=s,t[2]*=i,t[6]*=a,t[10]*=s,t[3]*=i,t[7]*=a,t[11]*=s,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],a=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,a))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),a=Math.sin(t),s=1-i,r=e.x,o=e.y,c=e.z,l=s*r,u=s*o;return this.set(l*r+i,l*o-a*c,l*c+a*o,0,l*o+a*c,u*o+i,u*c-a*r,0,l*c-a*o,u*c+a*r,s*c*c+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,a,s,r){return this.set(1,i,s,0,e,1,r,0,t,a,1,0,0,0,0,1),this}compose(e,t,i){const a=this.elements,s=t._x,r=t._y,o=t._z,c=t._w,l=s+s,u=r+r,h=o+o,d=s*l,f=s*u,g=s*h,y=r*u,p=r*h,m=o*h,b=c*l,x=c*u,v=c*h,M=i.x,w=i.y,N=i.z;return a[0]=(1-(y+m))*M,a[1]=(f+v)*M,a[2]=(g-x)*M,a[3]=0,a[4]=(f-v)*w,a[5]=(1-(d+m))*w,a[6]=(p+b)*w,a[7]=0,a[8]=(g+x)*N,a[9]=(p-b)*N,a[10]=(1-(d+y))*N,a[11]=0,a[12]=e.x,a[13]=e.y,a[14]=e.z,a[15]=1,this}decompose(e,t,i){const a=this.elements;e.x=a[12],e.y=a[13],e.z=a[14];const s=this.determinant();if(s===0)return i.set(1,1,1),t.identity(),this;let r=ha.set(a[0],a[1],a[2]).length();const o=ha.set(a[4],a[5],a[6]).length(),c=ha.set(a[8],a[9],a[10]).length();s<0&&(r=-r),In.copy(this);const l=1/r,u=1/o,h=1/c;return In.elements[0]*=l,In.elements[1]*=l,In.elements[2]*=l,In.elements[4]*=u,In.elements[5]*=u,In.elements[6]*=u,In.elements[8]*=h,In.elements[9]*=h,In.elements[10]*=h,t.setFromRotationMatrix(In),i.x=r,i.y=o,i.z=c,this}makePerspective(e,t,i,a,s,r,o=Kn,c=!1){const l=this.elements,u=2*s/(t-e),h=2*s/(i-a),d=(t+e)/(t-e),f=(i+a)/(i-a);let g,y;if(c)g=s/(r-s),y=r*s/(r-s);else if(o===Kn)g=-(r+s)/(r-s),y=-2*r*s/(r-s);else if(o===oo)g=-r/(r-s),y=-r*s/(r-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=u,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=h,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,a,s,r,o=Kn,c=!1){const l=this.elements,u=2/(t-e),h=2/(i-a),d=-(t+e)/(t-e),f=-(i+a)/(i-a);let g,y;if(c)g=1/(r-s),y=r/(r-s);else if(o===Kn)g=-2/(r-s),y=-(r+s)/(r-s);else if(o===oo)g=-1/(r-s),y=-s/(r-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=u,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=h,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let a=0;a<16;a++)if(t[a]!==i[a])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}}const ha=new U,In=new qe,Wb=new U(0,0,0),Hb=new U(1,1,1),Si=new U,$s=new U,dn=new U,xu=new qe,Eu=new Di;class aa{constructor(e=0,t=0,i=0,a=aa.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=a}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,a=this._order){return this._x=e,this._y=t,this._z=i,this._order=a,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const a=e.elements,s=a[0],r=a[4],o=a[8],c=a[1],l=a[5],u=a[9],h=a[2],d=a[6],f=a[10];switch(t){case"XYZ":this._y=Math.asin(Pe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-r,s)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Pe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(o,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(Pe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-r,l)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-Pe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-r,l));break;case"YZX":this._z=Math.asin(Pe(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(o,f));break;case"XZY":this._z=Math.asin(-Pe(r,-1,1)),Math.abs(r)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(o,s)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ne("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return xu.makeRotationFromQuaternion(e),this.setFromRotationMatrix(xu,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Eu.setFromEuler(this),this.setFromQuaternion(Eu,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}aa.DEFAULT_ORDER="XYZ";class md{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let jb=0;const Su=new U,fa=new Di,ni=new qe,Qs=new U,as=new U,Xb=new U,Yb=new Di,Mu=new U(1,0,0),Au=new U(0,1,0),wu=new U(0,0,1),Tu={type:"added"},Zb={type:"removed"},pa={type:"childadded",child:null},jo={type:"childremoved",child:null};class sn extends Fi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:jb++}),this.uuid=hi(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=sn.DEFAULT_UP.clone();const e=new U,t=new aa,i=new Di,a=new U(1,1,1);function s(){i.setFromEuler(t,!1)}function r(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(r),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:a},modelViewMatrix:{value:new qe},normalMatrix:{value:new De}}),this.matrix=new qe,this.matrixWorld=new qe,this.matrixAutoUpdate=sn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new md,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return fa.setFromAxisAngle(e,t),this.quaternion.multiply(fa),this}rotateOnWorldAxis(e,t){return fa.setFromAxisAngle(e,t),this.quaternion.premultiply(fa),this}rotateX(e){return this.rotateOnAxis(Mu,e)}rotateY(e){return this.rotateOnAxis(Au,e)}rotateZ(e){return this.rotateOnAxis(wu,e)}translateOnAxis(e,t){return Su.copy(e).applyQuaternion(this.quaternion),this.position.add(Su.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Mu,e)}translateY(e){return this.translateOnAxis(Au,e)}translateZ(e){return this.translateOnAxis(wu,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ni.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Qs.copy(e):Qs.set(e,t,i);const a=this.parent;this.updateWorldMatrix(!0,!1),as.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ni.lookAt(as,Qs,this.up):ni.lookAt(Qs,as,this.up),this.quaternion.setFromRotationMatrix(ni),a&&(ni.extractRotation(a.matrixWorld),fa.setFromRotationMatrix(ni),this.quaternion.premultiply(fa.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Xe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Tu),pa.child=e,this.dispatchEvent(pa),pa.child=null):Xe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Zb),jo.child=e,this.dispatchEvent(jo),jo.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ni.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ni.multiply(e.parent.matrixWorld)),e.applyMatrix4(ni),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Tu),pa.child=e,this.dispatchEvent(pa),pa.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,a=this.children.length;i<a;i++){const r=this.children[i].getObjectByProperty(e,t);if(r!==void 0)return r}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const a=this.children;for(let s=0,r=a.length;s<r;s++)a[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(as,e,Xb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(as,Yb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let i=0,a=t.length;i<a;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,a=t.length;i<a;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const e=this.pivot;if(e!==null){const t=e.x,i=e.y,a=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*a,s[13]+=i-s[1]*t-s[5]*i-s[9]*a,s[14]+=a-s[2]*t-s[6]*i-s[10]*a}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,a=t.length;i<a;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t){const i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const a=this.children;for(let s=0,r=a.length;s<r;s++)a[s].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const a={};a.uuid=this.uuid,a.type=this.type,this.name!==""&&(a.name=this.name),this.castShadow===!0&&(a.castShadow=!0),this.receiveShadow===!0&&(a.receiveShadow=!0),this.visible===!1&&(a.visible=!1),this.frustumCulled===!1&&(a.frustumCulled=!1),this.renderOrder!==0&&(a.renderOrder=this.renderOrder),this.static!==!1&&(a.static=this.static),Object.keys(this.userData).length>0&&(a.userData=this.userData),a.layers=this.layers.mask,a.matrix=this.matrix.toArray(),a.up=this.up.toArray(),this.pivot!==null&&(a.pivot=this.pivot.toArray()),this.matrixAutoUpdate===!1&&(a.matrixAutoUpdate=!1),this.morphTargetDictionary!==void 0&&(a.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(a.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(a.type="InstancedMesh",a.count=this.count,a.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(a.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(a.type="BatchedMesh",a.perObjectFrustumCulled=this.perObjectFrustumCulled,a.sortObjects=this.sortObjects,a.drawRanges=this._drawRanges,a.reservedRanges=this._reservedRanges,a.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),a.instanceInfo=this._instanceInfo.map(o=>({...o})),a.availableInstanceIds=this._availableInstanceIds.slice(),a.availableGeometryIds=this._availableGeometryIds.slice(),a.nextIndexStart=this._nextIndexStart,a.nextVertexStart=this._nextVertexStart,a.geometryCount=this._geometryCount,a.maxInstanceCount=this._maxInstanceCount,a.maxVertexCount=this._maxVertexCount,a.maxIndexCount=this._maxIndexCount,a.geometryInitialized=this._geometryInitialized,a.matricesTexture=this._matricesTexture.toJSON(e),a.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(a.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(a.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(a.boundingBox=this.boundingBox.toJSON()));function s(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?a.background=this.background.toJSON():this.background.isTexture&&(a.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(a.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){a.geometry=s(e.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const c=o.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){const h=c[l];s(e.shapes,h)}else s(e.shapes,c)}}if(this.isSkinnedMesh&&(a.bindMode=this.bindMode,a.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),a.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(s(e.materials,this.material[c]));a.material=o}else a.material=s(e.materials,this.material);if(this.children.length>0){a.children=[];for(let o=0;o<this.children.length;o++)a.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){a.animations=[];for(let o=0;o<this.animations.length;o++){const c=this.animations[o];a.animations.push(s(e.animations,c))}}if(t){const o=r(e.geometries),c=r(e.materials),l=r(e.textures),u=r(e.images),h=r(e.shapes),d=r(e.skeletons),f=r(e.animations),g=r(e.nodes);o.length>0&&(i.geometries=o),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),g.length>0&&(i.nodes=g)}return i.object=a,i;function r(o){const c=[];for(const l in o){const u=o[l];delete u.metadata,c.push(u)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const a=e.children[i];this.add(a.clone())}return this}}sn.DEFAULT_UP=new U(0,1,0);sn.DEFAULT_MATRIX_AUTO_UPDATE=!0;sn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class xs extends sn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const Kb={type:"move"};class Xo{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new xs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new xs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new xs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let a=null,s=null,r=null;const o=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){r=!0;for(const y of e.hand.values()){const p=t.getJointPose(y,i),m=this._getHandJoint(l,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.rotation,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}const u=l.joints["index-finger-tip"],h=l.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;l.inputState.pinching&&d>f+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&d<=f-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.rotation,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(a=t.getPose(e.targetRaySpace,i),a===null&&s!==null&&(a=s),a!==null&&(o.matrix.fromArray(a.transform.matrix),o.matrix.decompose(o.position,o.rotation,o.scale),o.matrixWorldNeedsUpdate=!0,a.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(a.linearVelocity)):o.hasLinearVelocity=!1,a.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(a.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Kb)))}return o!==null&&(o.visible=a!==null),c!==null&&(c.visible=s!==null),l!==null&&(l.visible=r!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new xs;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}const Fp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Mi={h:0,s:0,l:0},er={h:0,s:0,l:0};function Yo(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Ze{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const a=e;a&&a.isColor?this.copy(a):typeof a=="number"?this.setHex(a):typeof a=="string"&&this.setStyle(a)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=bn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,je.colorSpaceToWorking(this,t),this}setRGB(e,t,i,a=je.workingColorSpace){return this.r=e,this.g=t,this.b=i,je.colorSpaceToWorking(this,a),this}setHSL(e,t,i,a=je.workingColorSpace){if(e=fd(e,1),t=Pe(t,0,1),i=Pe(i,0,1),t===0)this.r=this.g=this.b=i;else{const s=i<=.5?i*(1+t):i+t-i*t,r=2*i-s;this.r=Yo(r,s,e+1/3),this.g=Yo(r,s,e),this.b=Yo(r,s,e-1/3)}return je.colorSpaceToWorking(this,a),this}setStyle(e,t=bn){function i(s){s!==void 0&&parseFloat(s)<1&&Ne("Color: Alpha component of "+e+" will be ignored.")}let a;if(a=/^(\w+)\(([^\)]*)\)/.exec(e)){let s;const r=a[1],o=a[2];switch(r){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(s[4]),this.setRGB(Math.min(100,parseInt(s[1],10))/100,Math.min(100,parseInt(s[2],10))/100,Math.min(100,parseInt(s[3],10))/100,t);break;case"hsl":case"hsla":if(s=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Ne("Color: Unknown color model "+e)}}else if(a=/^\#([A-Fa-f\d]+)$/.exec(e)){const s=a[1],r=s.length;if(r===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(r===6)return this.setHex(parseInt(s,16),t);Ne("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=bn){const i=Fp[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ne("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=fi(e.r),this.g=fi(e.g),this.b=fi(e.b),this}copyLinearToSRGB(e){return this.r=Ga(e.r),this.g=Ga(e.g),this.b=Ga(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=bn){return je.workingToColorSpace(Yt.copy(this),e),Math.round(Pe(Yt.r*255,0,255))*65536+Math.round(Pe(Yt.g*255,0,255))*256+Math.round(Pe(Yt.b*255,0,255))}getHexString(e=bn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=je.workingColorSpace){je.workingToColorSpace(Yt.copy(this),t);const i=Yt.r,a=Yt.g,s=Yt.b,r=Math.max(i,a,s),o=Math.min(i,a,s);let c,l;const u=(o+r)/2;if(o===r)c=0,l=0;else{const h=r-o;switch(l=u<=.5?h/(r+o):h/(2-r-o),r){case i:c=(a-s)/h+(a<s?6:0);break;case a:c=(s-i)/h+2;break;case s:c=(i-a)/h+4;break}c/=6}return e.h=c,e.s=l,e.l=u,e}getRGB(e,t=je.workingColorSpace){return je.workingToColorSpace(Yt.copy(this),t),e.r=Yt.r,e.g=Yt.g,e.b=Yt.b,e}getStyle(e=bn){je.workingToColorSpace(Yt.copy(this),e);const t=Yt.r,i=Yt.g,a=Yt.b;return e!==bn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${a.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(a*255)})`}offsetHSL(e,t,i){return this.getHSL(Mi),this.setHSL(Mi.h+e,Mi.s+t,Mi.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Mi),e.getHSL(er);const i=Ms(Mi.h,er.h,t),a=Ms(Mi.s,er.s,t),s=Ms(Mi.l,er.l,t);return this.setHSL(i,a,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,a=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*a,this.g=s[1]*t+s[4]*i+s[7]*a,this.b=s[2]*t+s[5]*i+s[8]*a,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Yt=new Ze;Ze.NAMES=Fp;let Zo=class extends sn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new aa,this.environmentIntensity=1,this.environmentRotation=new aa,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}};const Nn=new U,ii=new U,Ko=new U,ai=new U,ma=new U,ga=new U,Iu=new U,Jo=new U,qo=new U,$o=new U,Qo=new ut,ec=new ut,tc=new ut;class Dt{constructor(e=new U,t=new U,i=new U){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,a){a.subVectors(i,t),Nn.subVectors(e,t),a.cross(Nn);const s=a.lengthSq();return s>0?a.multiplyScalar(1/Math.sqrt(s)):a.set(0,0,0)}static getBarycoord(e,t,i,a,s){Nn.subVectors(a,t),ii.subVectors(i,t),Ko.subVectors(e,t);const r=Nn.dot(Nn),o=Nn.dot(ii),c=Nn.dot(Ko),l=ii.dot(ii),u=ii.dot(Ko),h=r*l-o*o;if(h===0)return s.set(0,0,0),null;const d=1/h,f=(l*c-o*u)*d,g=(r*u-o*c)*d;return s.set(1-f-g,g,f)}static containsPoint(e,t,i,a){return this.getBarycoord(e,t,i,a,ai)===null?!1:ai.x>=0&&ai.y>=0&&ai.x+ai.y<=1}static getInterpolation(e,t,i,a,s,r,o,c){return this.getBarycoord(e,t,i,a,ai)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,ai.x),c.addScaledVector(r,ai.y),c.addScaledVector(o,ai.z),c)}static getInterpolatedAttribute(e,t,i,a,s,r){return Qo.setScalar(0),ec.setScalar(0),tc.setScalar(0),Qo.fromBufferAttribute(e,t),ec.fromBufferAttribute(e,i),tc.fromBufferAttribute(e,a),r.setScalar(0),r.addScaledVector(Qo,s.x),r.addScaledVector(ec,s.y),r.addScaledVector(tc,s.z),r}static isFrontFacing(e,t,i,a){return Nn.subVectors(i,t),ii.subVectors(e,t),Nn.cross(ii).dot(a)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,a){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[a]),this}setFromAttributeAndIndices(e,t,i,a){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,a),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Nn.subVectors(this.c,this.b),ii.subVectors(this.a,this.b),Nn.cross(ii).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return Dt.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return Dt.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,a,s){return Dt.getInterpolation(e,this.a,this.b,this.c,t,i,a,s)}containsPoint(e){return Dt.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return Dt.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,a=this.b,s=this.c;let r,o;ma.subVectors(a,i),ga.subVectors(s,i),Jo.subVectors(e,i);const c=ma.dot(Jo),l=ga.dot(Jo);if(c<=0&&l<=0)return t.copy(i);qo.subVectors(e,a);const u=ma.dot(qo),h=ga.dot(qo);if(u>=0&&h<=u)return t.copy(a);const d=c*h-u*l;if(d<=0&&c>=0&&u<=0)return r=c/(c-u),t.copy(i).addScaledVector(ma,r);$o.subVectors(e,s);const f=ma.dot($o),g=ga.dot($o);if(g>=0&&f<=g)return t.copy(s);const y=f*l-c*g;if(y<=0&&l>=0&&g<=0)return o=l/(l-g),t.copy(i).addScaledVector(ga,o);const p=u*g-f*h;if(p<=0&&h-u>=0&&f-g>=0)return Iu.subVectors(s,a),o=(h-u)/(h-u+(f-g)),t.copy(a).addScaledVector(Iu,o);const m=1/(p+y+d);return r=y*m,o=d*m,t.copy(i).addScaledVector(ma,r).addScaledVector(ga,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}class kt{constructor(e=new U(1/0,1/0,1/0),t=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Rn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Rn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=Rn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0)for(let r=0,o=s.count;r<o;r++)e.isMesh===!0?e.getVertexPosition(r,Rn):Rn.fromBufferAttribute(s,r),Rn.applyMatrix4(e.matrixWorld),this.expandByPoint(Rn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),tr.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),tr.copy(i.boundingBox)),tr.applyMatrix4(e.matrixWorld),this.union(tr)}const a=e.children;for(let s=0,r=a.length;s<r;s++)this.expandByObject(a[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Rn),Rn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ss),nr.subVectors(this.max,ss),ba.subVectors(e.a,ss),_a.subVectors(e.b,ss),va.subVectors(e.c,ss),Ai.subVectors(_a,ba),wi.subVectors(va,_a),Vi.subVectors(ba,va);let t=[0,-Ai.z,Ai.y,0,-wi.z,wi.y,0,-Vi.z,Vi.y,Ai.z,0,-Ai.x,wi.z,0,-wi.x,Vi.z,0,-Vi.x,-Ai.y,Ai.x,0,-wi.y,wi.x,0,-Vi.y,Vi.x,0];return!nc(t,ba,_a,va,nr)||(t=[1,0,0,0,1,0,0,0,1],!nc(t,ba,_a,va,nr))?!1:(ir.crossVectors(Ai,wi),t=[ir.x,ir.y,ir.z],nc(t,ba,_a,va,nr))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Rn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Rn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(si[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),si[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),si[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),si[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),si[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),si[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),si[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),si[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(si),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const si=[new U,new U,new U,new U,new U,new U,new U,new U],Rn=new U,tr=new kt,ba=new U,_a=new U,va=new U,Ai=new U,wi=new U,Vi=new U,ss=new U,nr=new U,ir=new U,zi=new U;function nc(n,e,t,i,a){for(let s=0,r=n.length-3;s<=r;s+=3){zi.fromArray(n,s);const o=a.x*Math.abs(zi.x)+a.y*Math.abs(zi.y)+a.z*Math.abs(zi.z),c=e.dot(zi),l=t.dot(zi),u=i.dot(zi);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>o)return!1}return!0}const Mt=new U,ar=new we;let Jb=0;class St extends Fi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Jb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Ul,this.updateRanges=[],this.gpuType=Zn,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let a=0,s=this.itemSize;a<s;a++)this.array[e+a]=t.array[i+a];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)ar.fromBufferAttribute(this,t),ar.applyMatrix3(e),this.setXY(t,ar.x,ar.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.applyMatrix3(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.applyMatrix4(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.applyNormalMatrix(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.transformDirection(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=Ln(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=et(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Ln(t,this.array)),t}setX(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Ln(t,this.array)),t}setY(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Ln(t,this.array)),t}setZ(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Ln(t,this.array)),t}setW(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=et(t,this.array),i=et(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,a){return e*=this.itemSize,this.normalized&&(t=et(t,this.array),i=et(i,this.array),a=et(a,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=a,this}setXYZW(e,t,i,a,s){return e*=this.itemSize,this.normalized&&(t=et(t,this.array),i=et(i,this.array),a=et(a,this.array),s=et(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=a,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Ul&&(e.usage=this.usage),e}dispose(){this.dispatchEvent({type:"dispose"})}}class kp extends St{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class Bp extends St{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class Mn extends St{constructor(e,t,i){super(new Float32Array(e),t,i)}}const qb=new kt,rs=new U,ic=new U;class ts{constructor(e=new U,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):qb.setFromPoints(e).getCenter(i);let a=0;for(let s=0,r=e.length;s<r;s++)a=Math.max(a,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(a),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;rs.subVectors(e,this.center);const t=rs.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),a=(i-this.radius)*.5;this.center.addScaledVector(rs,a/i),this.radius+=a}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ic.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(rs.copy(e.center).add(ic)),this.expandByPoint(rs.copy(e.center).sub(ic))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}let $b=0;const mn=new qe,ac=new sn,ya=new U,un=new kt,os=new kt,Lt=new U;class Kt extends Fi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:$b++}),this.uuid=hi(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(bb(e)?Bp:kp)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const s=new De().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}const a=this.attributes.tangent;return a!==void 0&&(a.transformDirection(e),a.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return mn.makeRotationFromQuaternion(e),this.applyMatrix4(mn),this}rotateX(e){return mn.makeRotationX(e),this.applyMatrix4(mn),this}rotateY(e){return mn.makeRotationY(e),this.applyMatrix4(mn),this}rotateZ(e){return mn.makeRotationZ(e),this.applyMatrix4(mn),this}translate(e,t,i){return mn.makeTranslation(e,t,i),this.applyMatrix4(mn),this}scale(e,t,i){return mn.makeScale(e,t,i),this.applyMatrix4(mn),this}lookAt(e){return ac.lookAt(e),ac.updateMatrix(),this.applyMatrix4(ac.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ya).negate(),this.translate(ya.x,ya.y,ya.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let a=0,s=e.length;a<s;a++){const r=e[a];i.push(r.x,r.y,r.z||0)}this.setAttribute("position",new Mn(i,3))}else{const i=Math.min(e.length,t.count);for(let a=0;a<i;a++){const s=e[a];t.setXYZ(a,s.x,s.y,s.z||0)}e.length>t.count&&Ne("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new kt);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Xe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,a=t.length;i<a;i++){const s=t[i];un.setFromBufferAttribute(s),this.morphTargetsRelative?(Lt.addVectors(this.boundingBox.min,un.min),this.boundingBox.expandByPoint(Lt),Lt.addVectors(this.boundingBox.max,un.max),this.boundingBox.expandByPoint(Lt)):(this.boundingBox.expandByPoint(un.min),this.boundingBox.expandByPoint(un.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Xe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ts);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Xe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(e){const i=this.boundingSphere.center;if(un.setFromBufferAttribute(e),t)for(let s=0,r=t.length;s<r;s++){const o=t[s];os.setFromBufferAttribute(o),this.morphTargetsRelative?(Lt.addVectors(un.min,os.min),un.expandByPoint(Lt),Lt.addVectors(un.max,os.max),un.expandByPoint(Lt)):(un.expandByPoint(os.min),un.expandByPoint(os.max))}un.getCenter(i);let a=0;for(let s=0,r=e.count;s<r;s++)Lt.fromBufferAttribute(e,s),a=Math.max(a,i.distanceToSquared(Lt));if(t)for(let s=0,r=t.length;s<r;s++){const o=t[s],c=this.morphTargetsRelative;for(let l=0,u=o.count;l<u;l++)Lt.fromBufferAttribute(o,l),c&&(ya.fromBufferAttribute(e,l),Lt.add(ya)),a=Math.max(a,i.distanceToSquared(Lt))}this.boundingSphere.radius=Math.sqrt(a),isNaN(this.boundingSphere.radius)&&Xe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Xe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,a=t.normal,s=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new St(new Float32Array(4*i.count),4));const r=this.getAttribute("tangent"),o=[],c=[];for(let _=0;_<i.count;_++)o[_]=new U,c[_]=new U;const l=new U,u=new U,h=new U,d=new we,f=new we,g=new we,y=new U,p=new U;function m(_,S,T){l.fromBufferAttribute(i,_),u.fromBufferAttribute(i,S),h.fromBufferAttribute(i,T),d.fromBufferAttribute(s,_),f.fromBufferAttribute(s,S),g.fromBufferAttribute(s,T),u.sub(l),h.sub(l),f.sub(d),g.sub(d);const I=1/(f.x*g.y-g.x*f.y);isFinite(I)&&(y.copy(u).multiplyScalar(g.y).addScaledVector(h,-f.y).multiplyScalar(I),p.copy(h).multiplyScalar(f.x).addScaledVector(u,-g.x).multiplyScalar(I),o[_].add(y),o[S].add(y),o[T].add(y),c[_].add(p),c[S].add(p),c[T].add(p))}let b=this.groups;b.length===0&&(b=[{start:0,count:e.count}]);for(let _=0,S=b.length;_<S;++_){const T=b[_],I=T.start,C=T.count;for(let L=I,F=I+C;L<F;L+=3)m(e.getX(L+0),e.getX(L+1),e.getX(L+2))}const x=new U,v=new U,M=new U,w=new U;function N(_){M.fromBufferAttribute(a,_),w.copy(M);const S=o[_];x.copy(S),x.sub(M.multiplyScalar(M.dot(S))).normalize(),v.crossVectors(w,S);const I=v.dot(c[_])<0?-1:1;r.setXYZW(_,x.x,x.y,x.z,I)}for(let _=0,S=b.length;_<S;++_){const T=b[_],I=T.start,C=T.count;for(let L=I,F=I+C;L<F;L+=3)N(e.getX(L+0)),N(e.getX(L+1)),N(e.getX(L+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new St(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);const a=new U,s=new U,r=new U,o=new U,c=new U,l=new U,u=new U,h=new U;if(e)for(let d=0,f=e.count;d<f;d+=3){const g=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);a.fromBufferAttribute(t,g),s.fromBufferAttribute(t,y),r.fromBufferAttribute(t,p),u.subVectors(r,s),h.subVectors(a,s),u.cross(h),o.fromBufferAttribute(i,g),c.fromBufferAttribute(i,y),l.fromBufferAttribute(i,p),o.add(u),c.add(u),l.add(u),i.setXYZ(g,o.x,o.y,o.z),i.setXYZ(y,c.x,c.y,c.z),i.setXYZ(p,l.x,l.y,l.z)}else for(let d=0,f=t.count;d<f;d+=3)a.fromBufferAttribute(t,d+0),s.fromBufferAttribute(t,d+1),r.fromBufferAttribute(t,d+2),u.subVectors(r,s),h.subVectors(a,s),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Lt.fromBufferAttribute(e,t),Lt.normalize(),e.setXYZ(t,Lt.x,Lt.y,Lt.z)}toNonIndexed(){function e(o,c){const l=o.array,u=o.itemSize,h=o.normalized,d=new l.constructor(c.length*u);let f=0,g=0;for(let y=0,p=c.length;y<p;y++){o.isInterleavedBufferAttribute?f=c[y]*o.data.stride+o.offset:f=c[y]*u;for(let m=0;m<u;m++)d[g++]=l[f++]}return new St(d,u,h)}if(this.index===null)return Ne("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new Kt,i=this.index.array,a=this.attributes;for(const o in a){const c=a[o],l=e(c,i);t.setAttribute(o,l)}const s=this.morphAttributes;for(const o in s){const c=[],l=s[o];for(let u=0,h=l.length;u<h;u++){const d=l[u],f=e(d,i);c.push(f)}t.morphAttributes[o]=c}t.morphTargetsRelative=this.morphTargetsRelative;const r=this.groups;for(let o=0,c=r.length;o<c;o++){const l=r[o];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const c=this.parameters;for(const l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const c in i){const l=i[c];e.data.attributes[c]=l.toJSON(e.data)}const a={};let s=!1;for(const c in this.morphAttributes){const l=this.morphAttributes[c],u=[];for(let h=0,d=l.length;h<d;h++){const f=l[h];u.push(f.toJSON(e.data))}u.length>0&&(a[c]=u,s=!0)}s&&(e.data.morphAttributes=a,e.data.morphTargetsRelative=this.morphTargetsRelative);const r=this.groups;r.length>0&&(e.data.groups=JSON.parse(JSON.stringify(r)));const o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone());const a=e.attributes;for(const l in a){const u=a[l];this.setAttribute(l,u.clone(t))}const s=e.morphAttributes;for(const l in s){const u=[],h=s[l];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[l]=u}this.morphTargetsRelative=e.morphTargetsRelative;const r=e.groups;for(let l=0,u=r.length;l<u;l++){const h=r[l];this.addGroup(h.start,h.count,h.materialIndex)}const o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());const c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Qb{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Ul,this.updateRanges=[],this.version=0,this.uuid=hi()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let a=0,s=this.stride;a<s;a++)this.array[e+a]=t.array[i+a];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=hi()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);const t=new this.array.constructor(e.arrayBuffers[this.array.buffer._uuid]),i=new this.constructor(t,this.stride);return i.setUsage(this.usage),i}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){return e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=hi()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}}const Jt=new U;class Ui{constructor(e,t,i,a=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=a}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)Jt.fromBufferAttribute(this,t),Jt.applyMatrix4(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Jt.fromBufferAttribute(this,t),Jt.applyNormalMatrix(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Jt.fromBufferAttribute(this,t),Jt.transformDirection(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=Ln(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=et(i,this.array)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=Ln(t,this.array)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=Ln(t,this.array)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=Ln(t,this.array)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=Ln(t,this.array)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=et(t,this.array),i=et(i,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,a){return e=e*this.data.stride+this.offset,this.normalized&&(t=et(t,this.array),i=et(i,this.array),a=et(a,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=a,this}setXYZW(e,t,i,a,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=et(t,this.array),i=et(i,this.array),a=et(a,this.array),s=et(s,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=a,this.data.array[e+3]=s,this}clone(e){if(e===void 0){lo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");const t=[];for(let i=0;i<this.count;i++){const a=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[a+s])}return new St(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new Ui(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){lo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");const t=[];for(let i=0;i<this.count;i++){const a=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[a+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}}let e0=0;class Gs extends Fi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:e0++}),this.uuid=hi(),this.name="",this.type="Material",this.blending=za,this.side=qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Yc,this.blendDst=Zc,this.blendEquation=Zi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ze(0,0,0),this.blendAlpha=0,this.depthFunc=ta,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=pu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=da,this.stencilZFail=da,this.stencilZPass=da,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){Ne(`Material: parameter '${t}' has value of undefined.`);continue}const a=this[t];if(a===void 0){Ne(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}a&&a.isColor?a.set(i):a&&a.isVector3&&i&&i.isVector3?a.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==za&&(i.blending=this.blending),this.side!==qn&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Yc&&(i.blendSrc=this.blendSrc),this.blendDst!==Zc&&(i.blendDst=this.blendDst),this.blendEquation!==Zi&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==ta&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==pu&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==da&&(i.stencilFail=this.stencilFail),this.stencilZFail!==da&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==da&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.allowOverride===!1&&(i.allowOverride=!1),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function a(s){const r=[];for(const o in s){const c=s[o];delete c.metadata,r.push(c)}return r}if(t){const s=a(e.textures),r=a(e.images);s.length>0&&(i.textures=s),r.length>0&&(i.images=r)}return i}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const a=t.length;i=new Array(a);for(let s=0;s!==a;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}const ri=new U,sc=new U,sr=new U,Ti=new U,rc=new U,rr=new U,oc=new U;class Ws{constructor(e=new U,t=new U(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ri)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=ri.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ri.copy(this.origin).addScaledVector(this.direction,t),ri.distanceToSquared(e))}distanceSqToSegment(e,t,i,a){sc.copy(e).add(t).multiplyScalar(.5),sr.copy(t).sub(e).normalize(),Ti.copy(this.origin).sub(sc);const s=e.distanceTo(t)*.5,r=-this.direction.dot(sr),o=Ti.dot(this.direction),c=-Ti.dot(sr),l=Ti.lengthSq(),u=Math.abs(1-r*r);let h,d,f,g;if(u>0)if(h=r*c-o,d=r*o-c,g=s*u,h>=0)if(d>=-g)if(d<=g){const y=1/u;h*=y,d*=y,f=h*(h+r*d+2*o)+d*(r*h+d+2*c)+l}else d=s,h=Math.max(0,-(r*d+o)),f=-h*h+d*(d+2*c)+l;else d=-s,h=Math.max(0,-(r*d+o)),f=-h*h+d*(d+2*c)+l;else d<=-g?(h=Math.max(0,-(-r*s+o)),d=h>0?-s:Math.min(Math.max(-s,-c),s),f=-h*h+d*(d+2*c)+l):d<=g?(h=0,d=Math.min(Math.max(-s,-c),s),f=d*(d+2*c)+l):(h=Math.max(0,-(r*s+o)),d=h>0?s:Math.min(Math.max(-s,-c),s),f=-h*h+d*(d+2*c)+l);else d=r>0?-s:s,h=Math.max(0,-(r*d+o)),f=-h*h+d*(d+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,h),a&&a.copy(sc).addScaledVector(sr,d),f}intersectSphere(e,t){ri.subVectors(e.center,this.origin);const i=ri.dot(this.direction),a=ri.dot(ri)-i*i,s=e.radius*e.radius;if(a>s)return null;const r=Math.sqrt(s-a),o=i-r,c=i+r;return c<0?null:o<0?this.at(c,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,a,s,r,o,c;const l=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return l>=0?(i=(e.min.x-d.x)*l,a=(e.max.x-d.x)*l):(i=(e.max.x-d.x)*l,a=(e.min.x-d.x)*l),u>=0?(s=(e.min.y-d.y)*u,r=(e.max.y-d.y)*u):(s=(e.max.y-d.y)*u,r=(e.min.y-d.y)*u),i>r||s>a||((s>i||isNaN(i))&&(i=s),(r<a||isNaN(a))&&(a=r),h>=0?(o=(e.min.z-d.z)*h,c=(e.max.z-d.z)*h):(o=(e.max.z-d.z)*h,c=(e.min.z-d.z)*h),i>c||o>a)||((o>i||i!==i)&&(i=o),(c<a||a!==a)&&(a=c),a<0)?null:this.at(i>=0?i:a,t)}intersectsBox(e){return this.intersectBox(e,ri)!==null}intersectTriangle(e,t,i,a,s){rc.subVectors(t,e),rr.subVectors(i,e),oc.crossVectors(rc,rr);let r=this.direction.dot(oc),o;if(r>0){if(a)return null;o=1}else if(r<0)o=-1,r=-r;else return null;Ti.subVectors(this.origin,e);const c=o*this.direction.dot(rr.crossVectors(Ti,rr));if(c<0)return null;const l=o*this.direction.dot(rc.cross(Ti));if(l<0||c+l>r)return null;const u=-o*Ti.dot(oc);return u<0?null:this.at(u/r,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Vp extends Gs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ze(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new aa,this.combine=_p,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Nu=new qe,Gi=new Ws,or=new ts,Ru=new U,cr=new U,lr=new U,dr=new U,cc=new U,ur=new U,Cu=new U,hr=new U;class An extends sn{constructor(e=new Kt,t=new Vp){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const a=t[i[0]];if(a!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,r=a.length;s<r;s++){const o=a[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}getVertexPosition(e,t){const i=this.geometry,a=i.attributes.position,s=i.morphAttributes.position,r=i.morphTargetsRelative;t.fromBufferAttribute(a,e);const o=this.morphTargetInfluences;if(s&&o){ur.set(0,0,0);for(let c=0,l=s.length;c<l;c++){const u=o[c],h=s[c];u!==0&&(cc.fromBufferAttribute(h,e),r?ur.addScaledVector(cc,u):ur.addScaledVector(cc.sub(t),u))}t.add(ur)}return t}raycast(e,t){const i=this.geometry,a=this.material,s=this.matrixWorld;a!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),or.copy(i.boundingSphere),or.applyMatrix4(s),Gi.copy(e.ray).recast(e.near),!(or.containsPoint(Gi.origin)===!1&&(Gi.intersectSphere(or,Ru)===null||Gi.origin.distanceToSquared(Ru)>(e.far-e.near)**2))&&(Nu.copy(s).invert(),Gi.copy(e.ray).applyMatrix4(Nu),!(i.boundingBox!==null&&Gi.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Gi)))}_computeIntersections(e,t,i){let a;const s=this.geometry,r=this.material,o=s.index,c=s.attributes.position,l=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,d=s.groups,f=s.drawRange;if(o!==null)if(Array.isArray(r))for(let g=0,y=d.length;g<y;g++){const p=d[g],m=r[p.materialIndex],b=Math.max(p.start,f.start),x=Math.min(o.count,Math.min(p.start+p.count,f.start+f.count));for(let v=b,M=x;v<M;v+=3){const w=o.getX(v),N=o.getX(v+1),_=o.getX(v+2);a=fr(this,m,e,i,l,u,h,w,N,_),a&&(a.faceIndex=Math.floor(v/3),a.face.materialIndex=p.materialIndex,t.push(a))}}else{const g=Math.max(0,f.start),y=Math.min(o.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){const b=o.getX(p),x=o.getX(p+1),v=o.getX(p+2);a=fr(this,r,e,i,l,u,h,b,x,v),a&&(a.faceIndex=Math.floor(p/3),t.push(a))}}else if(c!==void 0)if(Array.isArray(r))for(let g=0,y=d.length;g<y;g++){const p=d[g],m=r[p.materialIndex],b=Math.max(p.start,f.start),x=Math.min(c.count,Math.min(p.start+p.count,f.start+f.count));for(let v=b,M=x;v<M;v+=3){const w=v,N=v+1,_=v+2;a=fr(this,m,e,i,l,u,h,w,N,_),a&&(a.faceIndex=Math.floor(v/3),a.face.materialIndex=p.materialIndex,t.push(a))}}else{const g=Math.max(0,f.start),y=Math.min(c.count,f.start+f.count);for(let p=g,m=y;p<m;p+=3){const b=p,x=p+1,v=p+2;a=fr(this,r,e,i,l,u,h,b,x,v),a&&(a.faceIndex=Math.floor(p/3),t.push(a))}}}}function t0(n,e,t,i,a,s,r,o){let c;if(e.side===Qt?c=i.intersectTriangle(r,s,a,!0,o):c=i.intersectTriangle(a,s,r,e.side===qn,o),c===null)return null;hr.copy(o),hr.applyMatrix4(n.matrixWorld);const l=t.ray.origin.distanceTo(hr);return l<t.near||l>t.far?null:{distance:l,point:hr.clone(),object:n}}function fr(n,e,t,i,a,s,r,o,c,l){n.getVertexPosition(o,cr),n.getVertexPosition(c,lr),n.getVertexPosition(l,dr);const u=t0(n,e,t,i,cr,lr,dr,Cu);if(u){const h=new U;Dt.getBarycoord(Cu,cr,lr,dr,h),a&&(u.uv=Dt.getInterpolatedAttribute(a,o,c,l,h,new we)),s&&(u.uv1=Dt.getInterpolatedAttribute(s,o,c,l,h,new we)),r&&(u.normal=Dt.getInterpolatedAttribute(r,o,c,l,h,new U),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const d={a:o,b:c,c:l,normal:new U,materialIndex:0};Dt.getNormal(cr,lr,dr,d.normal),u.face=d,u.barycoord=h}return u}class zp extends en{constructor(e=null,t=1,i=1,a,s,r,o,c,l=Wt,u=Wt,h,d){super(null,r,o,c,l,u,a,s,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const lc=new U,n0=new U,i0=new De;class Xn{constructor(e=new U(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,a){return this.normal.set(e,t,i),this.constant=a,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const a=lc.subVectors(i,t).cross(n0.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(a,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){const a=e.delta(lc),s=this.normal.dot(a);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const r=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(r<0||r>1)?null:t.copy(e.start).addScaledVector(a,r)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||i0.getNormalMatrix(e),a=this.coplanarPoint(lc).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-a.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Wi=new ts,a0=new we(.5,.5),pr=new U;class Gp{constructor(e=new Xn,t=new Xn,i=new Xn,a=new Xn,s=new Xn,r=new Xn){this.planes=[e,t,i,a,s,r]}set(e,t,i,a,s,r){const o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(a),o[4].copy(s),o[5].copy(r),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Kn,i=!1){const a=this.planes,s=e.elements,r=s[0],o=s[1],c=s[2],l=s[3],u=s[4],h=s[5],d=s[6],f=s[7],g=s[8],y=s[9],p=s[10],m=s[11],b=s[12],x=s[13],v=s[14],M=s[15];if(a[0].setComponents(l-r,f-u,m-g,M-b).normalize(),a[1].setComponents(l+r,f+u,m+g,M+b).normalize(),a[2].setComponents(l+o,f+h,m+y,M+x).normalize(),a[3].setComponents(l-o,f-h,m-y,M-x).normalize(),i)a[4].setComponents(c,d,p,v).normalize(),a[5].setComponents(l-c,f-d,m-p,M-v).normalize();else if(a[4].setComponents(l-c,f-d,m-p,M-v).normalize(),t===Kn)a[5].setComponents(l+c,f+d,m+p,M+v).normalize();else if(t===oo)a[5].setComponents(c,d,p,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Wi.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Wi.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Wi)}intersectsSprite(e){Wi.center.set(0,0,0);const t=a0.distanceTo(e.center);return Wi.radius=.7071067811865476+t,Wi.applyMatrix4(e.matrixWorld),this.intersectsSphere(Wi)}intersectsSphere(e){const t=this.planes,i=e.center,a=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<a)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const a=t[i];if(pr.x=a.normal.x>0?e.max.x:e.min.x,pr.y=a.normal.y>0?e.max.y:e.min.y,pr.z=a.normal.z>0?e.max.z:e.min.z,a.distanceToPoint(pr)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}class s0 extends Gs{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ze(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}}const Uu=new qe,Ll=new Ws,mr=new ts,gr=new U;class r0 extends sn{constructor(e=new Kt,t=new s0){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}raycast(e,t){const i=this.geometry,a=this.matrixWorld,s=e.params.Points.threshold,r=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),mr.copy(i.boundingSphere),mr.applyMatrix4(a),mr.radius+=s,e.ray.intersectsSphere(mr)===!1)return;Uu.copy(a).invert(),Ll.copy(e.ray).applyMatrix4(Uu);const o=s/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=i.index,h=i.attributes.position;if(l!==null){const d=Math.max(0,r.start),f=Math.min(l.count,r.start+r.count);for(let g=d,y=f;g<y;g++){const p=l.getX(g);gr.fromBufferAttribute(h,p),Pu(gr,p,c,a,e,t,this)}}else{const d=Math.max(0,r.start),f=Math.min(h.count,r.start+r.count);for(let g=d,y=f;g<y;g++)gr.fromBufferAttribute(h,g),Pu(gr,g,c,a,e,t,this)}}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const a=t[i[0]];if(a!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,r=a.length;s<r;s++){const o=a[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}}function Pu(n,e,t,i,a,s,r){const o=Ll.distanceSqToPoint(n);if(o<t){const c=new U;Ll.closestPointToPoint(n,c),c.applyMatrix4(i);const l=a.ray.origin.distanceTo(c);if(l<a.near||l>a.far)return;s.push({distance:l,distanceToRay:Math.sqrt(o),point:c,index:e,face:null,faceIndex:null,barycoord:null,object:r})}}class Wp extends en{constructor(e=[],t=na,i,a,s,r,o,c,l,u){super(e,t,i,a,s,r,o,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class sa extends en{constructor(e,t,i=On,a,s,r,o=Wt,c=Wt,l,u=mi,h=1){if(u!==mi&&u!==qi)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const d={width:e,height:t,depth:h};super(d,a,s,r,o,c,u,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new pd(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}class o0 extends sa{constructor(e,t=On,i=na,a,s,r=Wt,o=Wt,c,l=mi){const u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,a,s,r,o,c,l),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}}class Hp extends en{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class Hs extends Kt{constructor(e=1,t=1,i=1,a=1,s=1,r=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:a,heightSegments:s,depthSegments:r};const o=this;a=Math.floor(a),s=Math.floor(s),r=Math.floor(r);const c=[],l=[],u=[],h=[];let d=0,f=0;g("z","y","x",-1,-1,i,t,e,r,s,0),g("z","y","x",1,-1,i,t,-e,r,s,1),g("x","z","y",1,1,e,i,t,a,r,2),g("x","z","y",1,-1,e,i,-t,a,r,3),g("x","y","z",1,-1,e,t,i,a,s,4),g("x","y","z",-1,-1,e,t,-i,a,s,5),this.setIndex(c),this.setAttribute("position",new Mn(l,3)),this.setAttribute("normal",new Mn(u,3)),this.setAttribute("uv",new Mn(h,2));function g(y,p,m,b,x,v,M,w,N,_,S){const T=v/N,I=M/_,C=v/2,L=M/2,F=w/2,P=N+1,B=_+1;let V=0,q=0;const ee=new U;for(let le=0;le<B;le++){const ve=le*I-L;for(let ye=0;ye<P;ye++){const Ge=ye*T-C;ee[y]=Ge*b,ee[p]=ve*x,ee[m]=F,l.push(ee.x,ee.y,ee.z),ee[y]=0,ee[p]=0,ee[m]=w>0?1:-1,u.push(ee.x,ee.y,ee.z),h.push(ye/N),h.push(1-le/_),V+=1}}for(let le=0;le<_;le++)for(let ve=0;ve<N;ve++){const ye=d+ve+P*le,Ge=d+ve+P*(le+1),$e=d+(ve+1)+P*(le+1),Re=d+(ve+1)+P*le;c.push(ye,Ge,Re),c.push(Ge,$e,Re),q+=6}o.addGroup(f,q,S),f+=q,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Hs(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}class js extends Kt{constructor(e=1,t=1,i=1,a=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:a};const s=e/2,r=t/2,o=Math.floor(i),c=Math.floor(a),l=o+1,u=c+1,h=e/o,d=t/c,f=[],g=[],y=[],p=[];for(let m=0;m<u;m++){const b=m*d-r;for(let x=0;x<l;x++){const v=x*h-s;g.push(v,-b,0),y.push(0,0,1),p.push(x/o),p.push(1-m/c)}}for(let m=0;m<c;m++)for(let b=0;b<o;b++){const x=b+l*m,v=b+l*(m+1),M=b+1+l*(m+1),w=b+1+l*m;f.push(x,v,w),f.push(v,M,w)}this.setIndex(f),this.setAttribute("position",new Mn(g,3)),this.setAttribute("normal",new Mn(y,3)),this.setAttribute("uv",new Mn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new js(e.width,e.height,e.widthSegments,e.heightSegments)}}class c0 extends Kt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){const t=[],i=new Set,a=new U,s=new U;if(e.index!==null){const r=e.attributes.position,o=e.index;let c=e.groups;c.length===0&&(c=[{start:0,count:o.count,materialIndex:0}]);for(let l=0,u=c.length;l<u;++l){const h=c[l],d=h.start,f=h.count;for(let g=d,y=d+f;g<y;g+=3)for(let p=0;p<3;p++){const m=o.getX(g+p),b=o.getX(g+(p+1)%3);a.fromBufferAttribute(r,m),s.fromBufferAttribute(r,b),Lu(a,s,i)===!0&&(t.push(a.x,a.y,a.z),t.push(s.x,s.y,s.z))}}}else{const r=e.attributes.position;for(let o=0,c=r.count/3;o<c;o++)for(let l=0;l<3;l++){const u=3*o+l,h=3*o+(l+1)%3;a.fromBufferAttribute(r,u),s.fromBufferAttribute(r,h),Lu(a,s,i)===!0&&(t.push(a.x,a.y,a.z),t.push(s.x,s.y,s.z))}}this.setAttribute("position",new Mn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}}function Lu(n,e,t){const i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,a=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(a)===!0?!1:(t.add(i),t.add(a),!0)}function Xa(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const a=n[t][i];if(Du(a))a.isRenderTargetTexture?(Ne("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=a.clone();else if(Array.isArray(a))if(Du(a[0])){const s=[];for(let r=0,o=a.length;r<o;r++)s[r]=a[r].clone();e[t][i]=s}else e[t][i]=a.slice();else e[t][i]=a}}return e}function qt(n){const e={};for(let t=0;t<n.length;t++){const i=Xa(n[t]);for(const a in i)e[a]=i[a]}return e}function Du(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function l0(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function jp(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:je.workingColorSpace}const gd={clone:Xa,merge:qt};var d0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,u0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class on extends Gs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=d0,this.fragmentShader=u0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Xa(e.uniforms),this.uniformsGroups=l0(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const a in this.uniforms){const r=this.uniforms[a].value;r&&r.isTexture?t.uniforms[a]={type:"t",value:r.toJSON(e).uuid}:r&&r.isColor?t.uniforms[a]={type:"c",value:r.getHex()}:r&&r.isVector2?t.uniforms[a]={type:"v2",value:r.toArray()}:r&&r.isVector3?t.uniforms[a]={type:"v3",value:r.toArray()}:r&&r.isVector4?t.uniforms[a]={type:"v4",value:r.toArray()}:r&&r.isMatrix3?t.uniforms[a]={type:"m3",value:r.toArray()}:r&&r.isMatrix4?t.uniforms[a]={type:"m4",value:r.toArray()}:t.uniforms[a]={value:r}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const a in this.extensions)this.extensions[a]===!0&&(i[a]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}}class h0 extends on{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class f0 extends Gs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=cb,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class p0 extends Gs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const br=new U,_r=new Di,Vn=new U;class Xp extends sn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new qe,this.projectionMatrix=new qe,this.projectionMatrixInverse=new qe,this.coordinateSystem=Kn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(br,_r,Vn),Vn.x===1&&Vn.y===1&&Vn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(br,_r,Vn.set(1,1,1)).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorld.decompose(br,_r,Vn),Vn.x===1&&Vn.y===1&&Vn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(br,_r,Vn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const Ii=new U,Ou=new we,Fu=new we;class _n extends Xp{constructor(e=50,t=1,i=.1,a=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=a,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=Ps*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(Ss*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ps*2*Math.atan(Math.tan(Ss*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ii.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ii.x,Ii.y).multiplyScalar(-e/Ii.z),Ii.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ii.x,Ii.y).multiplyScalar(-e/Ii.z)}getViewSize(e,t){return this.getViewBounds(e,Ou,Fu),t.subVectors(Fu,Ou)}setViewOffset(e,t,i,a,s,r){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=a,this.view.width=s,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(Ss*.5*this.fov)/this.zoom,i=2*t,a=this.aspect*i,s=-.5*a;const r=this.view;if(this.view!==null&&this.view.enabled){const c=r.fullWidth,l=r.fullHeight;s+=r.offsetX*a/c,t-=r.offsetY*i/l,a*=r.width/c,i*=r.height/l}const o=this.filmOffset;o!==0&&(s+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+a,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}class bd extends Xp{constructor(e=-1,t=1,i=1,a=-1,s=.1,r=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=a,this.near=s,this.far=r,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,a,s,r){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=a,this.view.width=s,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,a=(this.top+this.bottom)/2;let s=i-e,r=i+e,o=a+t,c=a-t;if(this.view!==null&&this.view.enabled){const l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=l*this.view.offsetX,r=s+l*this.view.width,o-=u*this.view.offsetY,c=o-u*this.view.height}this.projectionMatrix.makeOrthographic(s,r,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}class m0 extends Kt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){const e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}}const xa=-90,Ea=1;class g0 extends sn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const a=new _n(xa,Ea,e,t);a.layers=this.layers,this.add(a);const s=new _n(xa,Ea,e,t);s.layers=this.layers,this.add(s);const r=new _n(xa,Ea,e,t);r.layers=this.layers,this.add(r);const o=new _n(xa,Ea,e,t);o.layers=this.layers,this.add(o);const c=new _n(xa,Ea,e,t);c.layers=this.layers,this.add(c);const l=new _n(xa,Ea,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,a,s,r,o,c]=t;for(const l of t)this.remove(l);if(e===Kn)i.up.set(0,1,0),i.lookAt(1,0,0),a.up.set(0,1,0),a.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),r.up.set(0,0,1),r.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===oo)i.up.set(0,-1,0),i.lookAt(-1,0,0),a.up.set(0,-1,0),a.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),r.up.set(0,0,-1),r.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:a}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[s,r,o,c,l,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;const y=i.texture.generateMipmaps;i.texture.generateMipmaps=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,a),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,a),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,2,a),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,3,a),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(i,4,a),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),i.texture.generateMipmaps=y,e.setRenderTarget(i,5,a),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}}class b0 extends _n{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}}class Dl extends Qb{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){const t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){const t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}}const ku=new qe;class _0{constructor(e,t,i=0,a=1/0){this.ray=new Ws(e,t),this.near=i,this.far=a,this.camera=null,this.layers=new md,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Xe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return ku.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(ku),this}intersectObject(e,t=!0,i=[]){return Ol(e,this,i,t),i.sort(Bu),i}intersectObjects(e,t=!0,i=[]){for(let a=0,s=e.length;a<s;a++)Ol(e[a],this,i,t);return i.sort(Bu),i}}function Bu(n,e){return n.distance-e.distance}function Ol(n,e,t,i){let a=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(a=!1),a===!0&&i===!0){const s=n.children;for(let r=0,o=s.length;r<o;r++)Ol(s[r],e,t,!0)}}class Vu{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Pe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(Pe(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class Yp{static{Yp.prototype.isMatrix2=!0}constructor(e,t,i,a){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,a)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,a){const s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=a,this}}const zu=new U,vr=new U,Sa=new U,Ma=new U,dc=new U,v0=new U,y0=new U;class $n{constructor(e=new U,t=new U){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){zu.subVectors(e,this.start),vr.subVectors(this.end,this.start);const i=vr.dot(vr);if(i===0)return 0;let s=vr.dot(zu)/i;return t&&(s=Pe(s,0,1)),s}closestPointToPoint(e,t,i){const a=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(a).add(this.start)}distanceSqToLine3(e,t=v0,i=y0){const a=10000000000000001e-32;let s,r;const o=this.start,c=e.start,l=this.end,u=e.end;Sa.subVectors(l,o),Ma.subVectors(u,c),dc.subVectors(o,c);const h=Sa.dot(Sa),d=Ma.dot(Ma),f=Ma.dot(dc);if(h<=a&&d<=a)return t.copy(o),i.copy(c),t.sub(i),t.dot(t);if(h<=a)s=0,r=f/d,r=Pe(r,0,1);else{const g=Sa.dot(dc);if(d<=a)r=0,s=Pe(-g/h,0,1);else{const y=Sa.dot(Ma),p=h*d-y*y;p!==0?s=Pe((y*f-g*d)/p,0,1):s=0,r=(y*s+f)/d,r<0?(r=0,s=Pe(-g/h,0,1)):r>1&&(r=1,s=Pe((y-g)/h,0,1))}}return t.copy(o).addScaledVector(Sa,s),i.copy(c).addScaledVector(Ma,r),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}}class x0 extends Fi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){Ne("Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}}function Gu(n,e,t,i){const a=E0(i);switch(t){case Cp:return n*e;case Pp:return n*e/a.components*a.byteLength;case cd:return n*e/a.components*a.byteLength;case ia:return n*e*2/a.components*a.byteLength;case ld:return n*e*2/a.components*a.byteLength;case Up:return n*e*3/a.components*a.byteLength;case En:return n*e*4/a.components*a.byteLength;case dd:return n*e*4/a.components*a.byteLength;case Yr:case Zr:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Kr:case Jr:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case il:case sl:return Math.max(n,16)*Math.max(e,8)/4;case nl:case al:return Math.max(n,8)*Math.max(e,8)/2;case rl:case ol:case ll:case dl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case cl:case ao:case ul:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case hl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fl:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case pl:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ml:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case gl:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case bl:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case _l:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case vl:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case yl:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case xl:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case El:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Sl:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Ml:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Al:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case wl:case Tl:case Il:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Nl:case Rl:return Math.ceil(n/4)*Math.ceil(e/4)*8;case so:case Cl:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function E0(n){switch(n){case xn:case Tp:return{byteLength:1,components:1};case Rs:case Ip:case pi:return{byteLength:2,components:1};case rd:case od:return{byteLength:2,components:4};case On:case sd:case Zn:return{byteLength:4,components:1};case Np:case Rp:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"184"}}));typeof window<"u"&&(window.__THREE__?Ne("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="184");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Zp(){let n=null,e=!1,t=null,i=null;function a(s,r){t(s,r),i=n.requestAnimationFrame(a)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(a),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function S0(n){const e=new WeakMap;function t(o,c){const l=o.array,u=o.usage,h=l.byteLength,d=n.createBuffer();n.bindBuffer(c,d),n.bufferData(c,l,u),o.onUploadCallback();let f;if(l instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=n.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=n.SHORT;else if(l instanceof Uint32Array)f=n.UNSIGNED_INT;else if(l instanceof Int32Array)f=n.INT;else if(l instanceof Int8Array)f=n.BYTE;else if(l instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:h}}function i(o,c,l){const u=c.array,h=c.updateRanges;if(n.bindBuffer(l,o),h.length===0)n.bufferSubData(l,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){const g=h[d],y=h[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){const y=h[f];n.bufferSubData(l,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function a(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function s(o){o.isInterleavedBufferAttribute&&(o=o.data);const c=e.get(o);c&&(n.deleteBuffer(c.buffer),e.delete(o))}function r(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const u=e.get(o);(!u||u.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const l=e.get(o);if(l===void 0)e.set(o,t(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,o,c),l.version=o.version}}return{get:a,remove:s,update:r}}var M0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,A0=`#ifdef USE_ALPHAHASH
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
#endif`,w0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,T0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,I0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,N0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,R0=`#ifdef USE_AOMAP
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
#endif`,C0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,U0=`#ifdef USE_BATCHING
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
#endif`,P0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,L0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,D0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,O0=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,F0=`#ifdef USE_IRIDESCENCE
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
#endif`,k0=`#ifdef USE_BUMPMAP
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
#endif`,B0=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,V0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,z0=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,G0=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,W0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,H0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,j0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,X0=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Y0=`#define PI 3.141592653589793
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
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
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
} // validated`,Z0=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,K0=`vec3 transformedNormal = objectNormal;
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
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,J0=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,q0=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,$0=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Q0=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,e_="gl_FragColor = linearToOutputTexel( gl_FragColor );",t_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,n_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
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
#endif`,i_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
#endif`,a_=`#ifdef USE_ENVMAP
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
#endif`,s_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,r_=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,o_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,c_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,l_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,d_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,u_=`#ifdef USE_GRADIENTMAP
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
}`,h_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,f_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,p_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,m_=`uniform bool receiveShadow;
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
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
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
#include <lightprobes_pars_fragment>`,g_=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,b_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,__=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,v_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,y_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,x_=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
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
#endif`,E_=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
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
		vec3 iridescenceF0;
		vec3 iridescenceFresnelDielectric;
		vec3 iridescenceFresnelMetallic;
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
		float roughness = material.clearcoatRoughness;
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
	float roughness = material.roughness;
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
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
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
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
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
vec3 BRDF_GGX_Multiscatter( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 singleScatter = BRDF_GGX( lightDir, viewDir, normal, material );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 dfgV = texture2D( dfgLUT, vec2( material.roughness, dotNV ) ).rg;
	vec2 dfgL = texture2D( dfgLUT, vec2( material.roughness, dotNL ) ).rg;
	vec3 FssEss_V = material.specularColorBlended * dfgV.x + material.specularF90 * dfgV.y;
	vec3 FssEss_L = material.specularColorBlended * dfgL.x + material.specularF90 * dfgL.y;
	float Ess_V = dfgV.x + dfgV.y;
	float Ess_L = dfgL.x + dfgL.y;
	float Ems_V = 1.0 - Ess_V;
	float Ems_L = 1.0 - Ess_L;
	vec3 Favg = material.specularColorBlended + ( 1.0 - material.specularColorBlended ) * 0.047619;
	vec3 Fms = FssEss_V * FssEss_L * Favg / ( 1.0 - Ems_V * Ems_L * Favg + EPSILON );
	float compensationFactor = Ems_V * Ems_L;
	vec3 multiScatter = Fms * compensationFactor;
	return singleScatter + multiScatter;
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
	reflectedLight.directSpecular += irradiance * BRDF_GGX_Multiscatter( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseContribution );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution );
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
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
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnelDielectric, material.roughness, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceFresnelMetallic, material.roughness, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( geometryNormal, geometryViewDir, material.diffuseColor, material.specularF90, material.roughness, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
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
}`,S_=`
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
		material.iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( material.iridescenceFresnelDielectric, material.iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
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
	#ifdef USE_LIGHT_PROBES_GRID
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = inverseTransformDirection( geometryNormal, viewMatrix );
		irradiance += getLightProbeGridIrradiance( probeWorldPos, probeWorldNormal );
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,M_=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_CUBE_UV )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,A_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,w_=`#ifdef USE_LIGHT_PROBES_GRID
uniform highp sampler3D probesSH;
uniform vec3 probesMin;
uniform vec3 probesMax;
uniform vec3 probesResolution;
vec3 getLightProbeGridIrradiance( vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 resMinusOne = res - 1.0;
	vec3 probeSpacing = gridRange / resMinusOne;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.0, 1.0 );
	uvw = uvw * resMinusOne / res + 0.5 / res;
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
#endif`,T_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,I_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,N_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,R_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,C_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,U_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,P_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,L_=`#if defined( USE_POINTS_UV )
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
#endif`,D_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,O_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,F_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,k_=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,B_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,V_=`#ifdef USE_MORPHTARGETS
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
#endif`,z_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,G_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,W_=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,H_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,j_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,X_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Y_=`#ifdef USE_NORMALMAP
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
#endif`,Z_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,K_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,J_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,q_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,$_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Q_=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,ev=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,tv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,nv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,iv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,av=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,sv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,rv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
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
			shadowCoord.z += shadowBias;
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				float radius = shadowRadius * texelSize.x;
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
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float dp = ( shadowCameraNear * ( shadowCameraFar - viewSpaceZ ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
				dp -= shadowBias;
			#else
				float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
				dp += shadowBias;
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			vec2 sample0 = vogelDiskSample( 0, 5, phi );
			vec2 sample1 = vogelDiskSample( 1, 5, phi );
			vec2 sample2 = vogelDiskSample( 2, 5, phi );
			vec2 sample3 = vogelDiskSample( 3, 5, phi );
			vec2 sample4 = vogelDiskSample( 4, 5, phi );
			shadow = (
				texture( shadowMap, vec4( bd3D + ( tangent * sample0.x + bitangent * sample0.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample1.x + bitangent * sample1.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample2.x + bitangent * sample2.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample3.x + bitangent * sample3.y ) * texelSize, dp ) ) +
				texture( shadowMap, vec4( bd3D + ( tangent * sample4.x + bitangent * sample4.y ) * texelSize, dp ) )
			) * 0.2;
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
#endif`,ov=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
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
#endif`,cv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
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
#endif`,lv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
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
}`,dv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,uv=`#ifdef USE_SKINNING
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
#endif`,hv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,fv=`#ifdef USE_SKINNING
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
#endif`,pv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,mv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,gv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,bv=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,_v=`#ifdef USE_TRANSMISSION
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
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,vv=`#ifdef USE_TRANSMISSION
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
#endif`,yv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,xv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ev=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Sv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const Mv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Av=`uniform sampler2D t2D;
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
}`,wv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Tv=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Iv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Nv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Rv=`#include <common>
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
}`,Cv=`#if DEPTH_PACKING == 3200
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
}`,Uv=`#define DISTANCE
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
}`,Pv=`#define DISTANCE
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
void main () {
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
}`,Lv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Dv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ov=`uniform float scale;
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
}`,Fv=`uniform vec3 diffuse;
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
}`,kv=`#include <common>
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
}`,Bv=`uniform vec3 diffuse;
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
}`,Vv=`#define LAMBERT
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
}`,zv=`#define LAMBERT
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
#include <cube_uv_reflection_fragment>
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
}`,Gv=`#define MATCAP
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
}`,Wv=`#define MATCAP
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
}`,Hv=`#define NORMAL
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
}`,jv=`#define NORMAL
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
}`,Xv=`#define PHONG
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
}`,Yv=`#define PHONG
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
#include <cube_uv_reflection_fragment>
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
}`,Zv=`#define STANDARD
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
}`,Kv=`#define STANDARD
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
#ifdef USE_DISPERSION
	uniform float dispersion;
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
#include <cube_uv_reflection_fragment>
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
}`,Jv=`#define TOON
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
}`,qv=`#define TOON
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
}`,$v=`uniform float size;
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
}`,Qv=`uniform vec3 diffuse;
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
}`,ey=`#include <common>
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
}`,ty=`uniform vec3 color;
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
}`,ny=`uniform float rotation;
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
}`,iy=`uniform vec3 diffuse;
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
}`,Be={alphahash_fragment:M0,alphahash_pars_fragment:A0,alphamap_fragment:w0,alphamap_pars_fragment:T0,alphatest_fragment:I0,alphatest_pars_fragment:N0,aomap_fragment:R0,aomap_pars_fragment:C0,batching_pars_vertex:U0,batching_vertex:P0,begin_vertex:L0,beginnormal_vertex:D0,bsdfs:O0,iridescence_fragment:F0,bumpmap_pars_fragment:k0,clipping_planes_fragment:B0,clipping_planes_pars_fragment:V0,clipping_planes_pars_vertex:z0,clipping_planes_vertex:G0,color_fragment:W0,color_pars_fragment:H0,color_pars_vertex:j0,color_vertex:X0,common:Y0,cube_uv_reflection_fragment:Z0,defaultnormal_vertex:K0,displacementmap_pars_vertex:J0,displacementmap_vertex:q0,emissivemap_fragment:$0,emissivemap_pars_fragment:Q0,colorspace_fragment:e_,colorspace_pars_fragment:t_,envmap_fragment:n_,envmap_common_pars_fragment:i_,envmap_pars_fragment:a_,envmap_pars_vertex:s_,envmap_physical_pars_fragment:g_,envmap_vertex:r_,fog_vertex:o_,fog_pars_vertex:c_,fog_fragment:l_,fog_pars_fragment:d_,gradientmap_pars_fragment:u_,lightmap_pars_fragment:h_,lights_lambert_fragment:f_,lights_lambert_pars_fragment:p_,lights_pars_begin:m_,lights_toon_fragment:b_,lights_toon_pars_fragment:__,lights_phong_fragment:v_,lights_phong_pars_fragment:y_,lights_physical_fragment:x_,lights_physical_pars_fragment:E_,lights_fragment_begin:S_,lights_fragment_maps:M_,lights_fragment_end:A_,lightprobes_pars_fragment:w_,logdepthbuf_fragment:T_,logdepthbuf_pars_fragment:I_,logdepthbuf_pars_vertex:N_,logdepthbuf_vertex:R_,map_fragment:C_,map_pars_fragment:U_,map_particle_fragment:P_,map_particle_pars_fragment:L_,metalnessmap_fragment:D_,metalnessmap_pars_fragment:O_,morphinstance_vertex:F_,morphcolor_vertex:k_,morphnormal_vertex:B_,morphtarget_pars_vertex:V_,morphtarget_vertex:z_,normal_fragment_begin:G_,normal_fragment_maps:W_,normal_pars_fragment:H_,normal_pars_vertex:j_,normal_vertex:X_,normalmap_pars_fragment:Y_,clearcoat_normal_fragment_begin:Z_,clearcoat_normal_fragment_maps:K_,clearcoat_pars_fragment:J_,iridescence_pars_fragment:q_,opaque_fragment:$_,packing:Q_,premultiplied_alpha_fragment:ev,project_vertex:tv,dithering_fragment:nv,dithering_pars_fragment:iv,roughnessmap_fragment:av,roughnessmap_pars_fragment:sv,shadowmap_pars_fragment:rv,shadowmap_pars_vertex:ov,shadowmap_vertex:cv,shadowmask_pars_fragment:lv,skinbase_vertex:dv,skinning_pars_vertex:uv,skinning_vertex:hv,skinnormal_vertex:fv,specularmap_fragment:pv,specularmap_pars_fragment:mv,tonemapping_fragment:gv,tonemapping_pars_fragment:bv,transmission_fragment:_v,transmission_pars_fragment:vv,uv_pars_fragment:yv,uv_pars_vertex:xv,uv_vertex:Ev,worldpos_vertex:Sv,background_vert:Mv,background_frag:Av,backgroundCube_vert:wv,backgroundCube_frag:Tv,cube_vert:Iv,cube_frag:Nv,depth_vert:Rv,depth_frag:Cv,distance_vert:Uv,distance_frag:Pv,equirect_vert:Lv,equirect_frag:Dv,linedashed_vert:Ov,linedashed_frag:Fv,meshbasic_vert:kv,meshbasic_frag:Bv,meshlambert_vert:Vv,meshlambert_frag:zv,meshmatcap_vert:Gv,meshmatcap_frag:Wv,meshnormal_vert:Hv,meshnormal_frag:jv,meshphong_vert:Xv,meshphong_frag:Yv,meshphysical_vert:Zv,meshphysical_frag:Kv,meshtoon_vert:Jv,meshtoon_frag:qv,points_vert:$v,points_frag:Qv,shadow_vert:ey,shadow_frag:ty,sprite_vert:ny,sprite_frag:iy},ce={common:{diffuse:{value:new Ze(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new De}},envmap:{envMap:{value:null},envMapRotation:{value:new De},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new De}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new De}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new De},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new De},normalScale:{value:new we(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new De},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new De}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new De}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new De}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ze(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:null},probesMin:{value:new U},probesMax:{value:new U},probesResolution:{value:new U}},points:{diffuse:{value:new Ze(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0},uvTransform:{value:new De}},sprite:{diffuse:{value:new Ze(16777215)},opacity:{value:1},center:{value:new we(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new De},alphaMap:{value:null},alphaMapTransform:{value:new De},alphaTest:{value:0}}},an={basic:{uniforms:qt([ce.common,ce.specularmap,ce.envmap,ce.aomap,ce.lightmap,ce.fog]),vertexShader:Be.meshbasic_vert,fragmentShader:Be.meshbasic_frag},lambert:{uniforms:qt([ce.common,ce.specularmap,ce.envmap,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.fog,ce.lights,{emissive:{value:new Ze(0)},envMapIntensity:{value:1}}]),vertexShader:Be.meshlambert_vert,fragmentShader:Be.meshlambert_frag},phong:{uniforms:qt([ce.common,ce.specularmap,ce.envmap,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.fog,ce.lights,{emissive:{value:new Ze(0)},specular:{value:new Ze(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Be.meshphong_vert,fragmentShader:Be.meshphong_frag},standard:{uniforms:qt([ce.common,ce.envmap,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.roughnessmap,ce.metalnessmap,ce.fog,ce.lights,{emissive:{value:new Ze(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag},toon:{uniforms:qt([ce.common,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.gradientmap,ce.fog,ce.lights,{emissive:{value:new Ze(0)}}]),vertexShader:Be.meshtoon_vert,fragmentShader:Be.meshtoon_frag},matcap:{uniforms:qt([ce.common,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.fog,{matcap:{value:null}}]),vertexShader:Be.meshmatcap_vert,fragmentShader:Be.meshmatcap_frag},points:{uniforms:qt([ce.points,ce.fog]),vertexShader:Be.points_vert,fragmentShader:Be.points_frag},dashed:{uniforms:qt([ce.common,ce.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Be.linedashed_vert,fragmentShader:Be.linedashed_frag},depth:{uniforms:qt([ce.common,ce.displacementmap]),vertexShader:Be.depth_vert,fragmentShader:Be.depth_frag},normal:{uniforms:qt([ce.common,ce.bumpmap,ce.normalmap,ce.displacementmap,{opacity:{value:1}}]),vertexShader:Be.meshnormal_vert,fragmentShader:Be.meshnormal_frag},sprite:{uniforms:qt([ce.sprite,ce.fog]),vertexShader:Be.sprite_vert,fragmentShader:Be.sprite_frag},background:{uniforms:{uvTransform:{value:new De},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Be.background_vert,fragmentShader:Be.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new De}},vertexShader:Be.backgroundCube_vert,fragmentShader:Be.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Be.cube_vert,fragmentShader:Be.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Be.equirect_vert,fragmentShader:Be.equirect_frag},distance:{uniforms:qt([ce.common,ce.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Be.distance_vert,fragmentShader:Be.distance_frag},shadow:{uniforms:qt([ce.lights,ce.fog,{color:{value:new Ze(0)},opacity:{value:1}}]),vertexShader:Be.shadow_vert,fragmentShader:Be.shadow_frag}};an.physical={uniforms:qt([an.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new De},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new De},clearcoatNormalScale:{value:new we(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new De},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new De},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new De},sheen:{value:0},sheenColor:{value:new Ze(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new De},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new De},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new De},transmissionSamplerSize:{value:new we},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new De},attenuationDistance:{value:0},attenuationColor:{value:new Ze(0)},specularColor:{value:new Ze(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new De},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new De},anisotropyVector:{value:new we},anisotropyMap:{value:null},anisotropyMapTransform:{value:new De}}]),vertexShader:Be.meshphysical_vert,fragmentShader:Be.meshphysical_frag};const yr={r:0,b:0,g:0},ay=new qe,Kp=new De;Kp.set(-1,0,0,0,1,0,0,0,1);function sy(n,e,t,i,a,s){const r=new Ze(0);let o=a===!0?0:1,c,l,u=null,h=0,d=null;function f(b){let x=b.isScene===!0?b.background:null;if(x&&x.isTexture){const v=b.backgroundBlurriness>0;x=e.get(x,v)}return x}function g(b){let x=!1;const v=f(b);v===null?p(r,o):v&&v.isColor&&(p(v,1),x=!0);const M=n.xr.getEnvironmentBlendMode();M==="additive"?t.buffers.color.setClear(0,0,0,1,s):M==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||x)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(b,x){const v=f(x);v&&(v.isCubeTexture||v.mapping===vo)?(l===void 0&&(l=new An(new Hs(1,1,1),new on({name:"BackgroundCubeMaterial",uniforms:Xa(an.backgroundCube.uniforms),vertexShader:an.backgroundCube.vertexShader,fragmentShader:an.backgroundCube.fragmentShader,side:Qt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(M,w,N){this.matrixWorld.copyPosition(N.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=v,l.material.uniforms.backgroundBlurriness.value=x.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(ay.makeRotationFromEuler(x.backgroundRotation)).transpose(),v.isCubeTexture&&v.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Kp),l.material.toneMapped=je.getTransfer(v.colorSpace)!==Qe,(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new An(new js(2,2),new on({name:"BackgroundMaterial",uniforms:Xa(an.background.uniforms),vertexShader:an.background.vertexShader,fragmentShader:an.background.fragmentShader,side:qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=x.backgroundIntensity,c.material.toneMapped=je.getTransfer(v.colorSpace)!==Qe,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null))}function p(b,x){b.getRGB(yr,jp(n)),t.buffers.color.setClear(yr.r,yr.g,yr.b,x,s)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return r},setClearColor:function(b,x=1){r.set(b),o=x,p(r,o)},getClearAlpha:function(){return o},setClearAlpha:function(b){o=b,p(r,o)},render:g,addToRenderList:y,dispose:m}}function ry(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},a=d(null);let s=a,r=!1;function o(I,C,L,F,P){let B=!1;const V=h(I,F,L,C);s!==V&&(s=V,l(s.object)),B=f(I,F,L,P),B&&g(I,F,L,P),P!==null&&e.update(P,n.ELEMENT_ARRAY_BUFFER),(B||r)&&(r=!1,v(I,C,L,F),P!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(P).buffer))}function c(){return n.createVertexArray()}function l(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,C,L,F){const P=F.wireframe===!0;let B=i[C.id];B===void 0&&(B={},i[C.id]=B);const V=I.isInstancedMesh===!0?I.id:0;let q=B[V];q===void 0&&(q={},B[V]=q);let ee=q[L.id];ee===void 0&&(ee={},q[L.id]=ee);let le=ee[P];return le===void 0&&(le=d(c()),ee[P]=le),le}function d(I){const C=[],L=[],F=[];for(let P=0;P<t;P++)C[P]=0,L[P]=0,F[P]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:L,attributeDivisors:F,object:I,attributes:{},index:null}}function f(I,C,L,F){const P=s.attributes,B=C.attributes;let V=0;const q=L.getAttributes();for(const ee in q)if(q[ee].location>=0){const ve=P[ee];let ye=B[ee];if(ye===void 0&&(ee==="instanceMatrix"&&I.instanceMatrix&&(ye=I.instanceMatrix),ee==="instanceColor"&&I.instanceColor&&(ye=I.instanceColor)),ve===void 0||ve.attribute!==ye||ye&&ve.data!==ye.data)return!0;V++}return s.attributesNum!==V||s.index!==F}function g(I,C,L,F){const P={},B=C.attributes;let V=0;const q=L.getAttributes();for(const ee in q)if(q[ee].location>=0){let ve=B[ee];ve===void 0&&(ee==="instanceMatrix"&&I.instanceMatrix&&(ve=I.instanceMatrix),ee==="instanceColor"&&I.instanceColor&&(ve=I.instanceColor));const ye={};ye.attribute=ve,ve&&ve.data&&(ye.data=ve.data),P[ee]=ye,V++}s.attributes=P,s.attributesNum=V,s.index=F}function y(){const I=s.newAttributes;for(let C=0,L=I.length;C<L;C++)I[C]=0}function p(I){m(I,0)}function m(I,C){const L=s.newAttributes,F=s.enabledAttributes,P=s.attributeDivisors;L[I]=1,F[I]===0&&(n.enableVertexAttribArray(I),F[I]=1),P[I]!==C&&(n.vertexAttribDivisor(I,C),P[I]=C)}function b(){const I=s.newAttributes,C=s.enabledAttributes;for(let L=0,F=C.length;L<F;L++)C[L]!==I[L]&&(n.disableVertexAttribArray(L),C[L]=0)}function x(I,C,L,F,P,B,V){V===!0?n.vertexAttribIPointer(I,C,L,P,B):n.vertexAttribPointer(I,C,L,F,P,B)}function v(I,C,L,F){y();const P=F.attributes,B=L.getAttributes(),V=C.defaultAttributeValues;for(const q in B){const ee=B[q];if(ee.location>=0){let le=P[q];if(le===void 0&&(q==="instanceMatrix"&&I.instanceMatrix&&(le=I.instanceMatrix),q==="instanceColor"&&I.instanceColor&&(le=I.instanceColor)),le!==void 0){const ve=le.normalized,ye=le.itemSize,Ge=e.get(le);if(Ge===void 0)continue;const $e=Ge.buffer,Re=Ge.type,J=Ge.bytesPerElement,ue=Re===n.INT||Re===n.UNSIGNED_INT||le.gpuType===sd;if(le.isInterleavedBufferAttribute){const ae=le.data,Te=ae.stride,Ce=le.offset;if(ae.isInstancedInterleavedBuffer){for(let Ie=0;Ie<ee.locationSize;Ie++)m(ee.location+Ie,ae.meshPerAttribute);I.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=ae.meshPerAttribute*ae.count)}else for(let Ie=0;Ie<ee.locationSize;Ie++)p(ee.location+Ie);n.bindBuffer(n.ARRAY_BUFFER,$e);for(let Ie=0;Ie<ee.locationSize;Ie++)x(ee.location+Ie,ye/ee.locationSize,Re,ve,Te*J,(Ce+ye/ee.locationSize*Ie)*J,ue)}else{if(le.isInstancedBufferAttribute){for(let ae=0;ae<ee.locationSize;ae++)m(ee.location+ae,le.meshPerAttribute);I.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let ae=0;ae<ee.locationSize;ae++)p(ee.location+ae);n.bindBuffer(n.ARRAY_BUFFER,$e);for(let ae=0;ae<ee.locationSize;ae++)x(ee.location+ae,ye/ee.locationSize,Re,ve,ye*J,ye/ee.locationSize*ae*J,ue)}}else if(V!==void 0){const ve=V[q];if(ve!==void 0)switch(ve.length){case 2:n.vertexAttrib2fv(ee.location,ve);break;case 3:n.vertexAttrib3fv(ee.location,ve);break;case 4:n.vertexAttrib4fv(ee.location,ve);break;default:n.vertexAttrib1fv(ee.location,ve)}}}}b()}function M(){S();for(const I in i){const C=i[I];for(const L in C){const F=C[L];for(const P in F){const B=F[P];for(const V in B)u(B[V].object),delete B[V];delete F[P]}}delete i[I]}}function w(I){if(i[I.id]===void 0)return;const C=i[I.id];for(const L in C){const F=C[L];for(const P in F){const B=F[P];for(const V in B)u(B[V].object),delete B[V];delete F[P]}}delete i[I.id]}function N(I){for(const C in i){const L=i[C];for(const F in L){const P=L[F];if(P[I.id]===void 0)continue;const B=P[I.id];for(const V in B)u(B[V].object),delete B[V];delete P[I.id]}}}function _(I){for(const C in i){const L=i[C],F=I.isInstancedMesh===!0?I.id:0,P=L[F];if(P!==void 0){for(const B in P){const V=P[B];for(const q in V)u(V[q].object),delete V[q];delete P[B]}delete L[F],Object.keys(L).length===0&&delete i[C]}}}function S(){T(),r=!0,s!==a&&(s=a,l(s.object))}function T(){a.geometry=null,a.program=null,a.wireframe=!1}return{setup:o,reset:S,resetDefaultState:T,dispose:M,releaseStatesOfGeometry:w,releaseStatesOfObject:_,releaseStatesOfProgram:N,initAttributes:y,enableAttribute:p,disableUnusedAttributes:b}}function oy(n,e,t){let i;function a(c){i=c}function s(c,l){n.drawArrays(i,c,l),t.update(l,i,1)}function r(c,l,u){u!==0&&(n.drawArraysInstanced(i,c,l,u),t.update(l,i,u))}function o(c,l,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,u);let d=0;for(let f=0;f<u;f++)d+=l[f];t.update(d,i,1)}this.setMode=a,this.render=s,this.renderInstances=r,this.renderMultiDraw=o}function cy(n,e,t,i){let a;function s(){if(a!==void 0)return a;if(e.has("EXT_texture_filter_anisotropic")===!0){const N=e.get("EXT_texture_filter_anisotropic");a=n.getParameter(N.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else a=0;return a}function r(N){return!(N!==En&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(N){const _=N===pi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(N!==xn&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&N!==Zn&&!_)}function c(N){if(N==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";N="mediump"}return N==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp";const u=c(l);u!==l&&(Ne("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);const h=t.logarithmicDepthBuffer===!0,d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control");t.reversedDepthBuffer===!0&&d===!1&&Ne("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.");const f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),x=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),M=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:r,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:b,maxVaryings:x,maxFragmentUniforms:v,maxSamples:M,samples:w}}function ly(n){const e=this;let t=null,i=0,a=!1,s=!1;const r=new Xn,o=new De,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){const f=h.length!==0||d||i!==0||a;return a=d,i=h.length,f},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){const g=h.clippingPlanes,y=h.clipIntersection,p=h.clipShadows,m=n.get(h);if(!a||g===null||g.length===0||s&&!p)s?u(null):l();else{const b=s?0:i,x=b*4;let v=m.clippingState||null;c.value=v,v=u(g,d,x,f);for(let M=0;M!==x;++M)v[M]=t[M];m.clippingState=v,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=b}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,g){const y=h!==null?h.length:0;let p=null;if(y!==0){if(p=c.value,g!==!0||p===null){const m=f+y*4,b=d.matrixWorldInverse;o.getNormalMatrix(b),(p===null||p.length<m)&&(p=new Float32Array(m));for(let x=0,v=f;x!==y;++x,v+=4)r.copy(h[x]).applyMatrix4(b,o),r.normal.toArray(p,v),p[v+3]=r.constant}c.value=p,c.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}const Pi=4,Wu=[.125,.215,.35,.446,.526,.582],Ki=20,dy=256,cs=new bd,Hu=new Ze;let uc=null,hc=0,fc=0,pc=!1;const uy=new U;class ju{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._sizeLods=[],this._sigmas=[],this._lodMeshes=[],this._backgroundBox=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null}fromScene(e,t=0,i=.1,a=100,s={}){const{size:r=256,position:o=uy}=s;uc=this._renderer.getRenderTarget(),hc=this._renderer.getActiveCubeFace(),fc=this._renderer.getActiveMipmapLevel(),pc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(r);const c=this._allocateTargets();return c.depthBuffer=!0,this._sceneToCubeUV(e,i,a,c,o),t>0&&this._blur(c,0,0,t),this._applyPMREM(c),this._cleanup(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Zu(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Yu(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._backgroundBox!==null&&(this._backgroundBox.geometry.dispose(),this._backgroundBox.material.dispose())}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodMeshes.length;e++)this._lodMeshes[e].geometry.dispose()}_cleanup(e){this._renderer.setRenderTarget(uc,hc,fc),this._renderer.xr.enabled=pc,e.scissorTest=!1,Aa(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===na||e.mapping===ja?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),uc=this._renderer.getRenderTarget(),hc=this._renderer.getActiveCubeFace(),fc=this._renderer.getActiveMipmapLevel(),pc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:Ht,minFilter:Ht,generateMipmaps:!1,type:pi,format:En,colorSpace:Us,depthBuffer:!1},a=Xu(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Xu(e,t,i);const{_lodMax:s}=this;({lodMeshes:this._lodMeshes,sizeLods:this._sizeLods,sigmas:this._sigmas}=hy(s)),this._blurMaterial=py(s,e,t),this._ggxMaterial=fy(s,e,t)}return a}_compileMaterial(e){const t=new An(new Kt,e);this._renderer.compile(t,cs)}_sceneToCubeUV(e,t,i,a,s){const c=new _n(90,1,t,i),l=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,d=h.autoClear,f=h.toneMapping;h.getClearColor(Hu),h.toneMapping=Jn,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(a),h.clearDepth(),h.setRenderTarget(null)),this._backgroundBox===null&&(this._backgroundBox=new An(new Hs,new Vp({name:"PMREM.Background",side:Qt,depthWrite:!1,depthTest:!1})));const y=this._backgroundBox,p=y.material;let m=!1;const b=e.background;b?b.isColor&&(p.color.copy(b),e.background=null,m=!0):(p.color.copy(Hu),m=!0);for(let x=0;x<6;x++){const v=x%3;v===0?(c.up.set(0,l[x],0),c.position.set(s.x,s.y,s.z),c.lookAt(s.x+u[x],s.y,s.z)):v===1?(c.up.set(0,0,l[x]),c.position.set(s.x,s.y,s.z),c.lookAt(s.x,s.y+u[x],s.z)):(c.up.set(0,l[x],0),c.position.set(s.x,s.y,s.z),c.lookAt(s.x,s.y,s.z+u[x]));const M=this._cubeSize;Aa(a,v*M,x>2?M:0,M,M),h.setRenderTarget(a),m&&h.render(y,c),h.render(e,c)}h.toneMapping=f,h.autoClear=d,e.background=b}_textureToCubeUV(e,t){const i=this._renderer,a=e.mapping===na||e.mapping===ja;a?(this._cubemapMaterial===null&&(this._cubemapMaterial=Zu()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Yu());const s=a?this._cubemapMaterial:this._equirectMaterial,r=this._lodMeshes[0];r.material=s;const o=s.uniforms;o.envMap.value=e;const c=this._cubeSize;Aa(t,0,0,3*c,2*c),i.setRenderTarget(t),i.render(r,cs)}_applyPMREM(e){const t=this._renderer,i=t.autoClear;t.autoClear=!1;const a=this._lodMeshes.length;for(let s=1;s<a;s++)this._applyGGXFilter(e,s-1,s);t.autoClear=i}_applyGGXFilter(e,t,i){const a=this._renderer,s=this._pingPongRenderTarget,r=this._ggxMaterial,o=this._lodMeshes[i];o.material=r;const c=r.uniforms,l=i/(this._lodMeshes.length-1),u=t/(this._lodMeshes.length-1),h=Math.sqrt(l*l-u*u),d=0+l*1.25,f=h*d,{_lodMax:g}=this,y=this._sizeLods[i],p=3*y*(i>g-Pi?i-g+Pi:0),m=4*(this._cubeSize-y);c.envMap.value=e.texture,c.roughness.value=f,c.mipInt.value=g-t,Aa(s,p,m,3*y,2*y),a.setRenderTarget(s),a.render(o,cs),c.envMap.value=s.texture,c.roughness.value=0,c.mipInt.value=g-i,Aa(e,p,m,3*y,2*y),a.setRenderTarget(e),a.render(o,cs)}_blur(e,t,i,a,s){const r=this._pingPongRenderTarget;this._halfBlur(e,r,t,i,a,"latitudinal",s),this._halfBlur(r,e,i,i,a,"longitudinal",s)}_halfBlur(e,t,i,a,s,r,o){const c=this._renderer,l=this._blurMaterial;r!=="latitudinal"&&r!=="longitudinal"&&Xe("blur direction must be either latitudinal or longitudinal!");const u=3,h=this._lodMeshes[a];h.material=l;const d=l.uniforms,f=this._sizeLods[i]-1,g=isFinite(s)?Math.PI/(2*f):2*Math.PI/(2*Ki-1),y=s/g,p=isFinite(s)?1+Math.floor(u*y):Ki;p>Ki&&Ne(`sigmaRadians, ${s}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${Ki}`);const m=[];let b=0;for(let N=0;N<Ki;++N){const _=N/y,S=Math.exp(-_*_/2);m.push(S),N===0?b+=S:N<p&&(b+=2*S)}for(let N=0;N<m.length;N++)m[N]=m[N]/b;d.envMap.value=e.texture,d.samples.value=p,d.weights.value=m,d.latitudinal.value=r==="latitudinal",o&&(d.poleAxis.value=o);const{_lodMax:x}=this;d.dTheta.value=g,d.mipInt.value=x-i;const v=this._sizeLods[a],M=3*v*(a>x-Pi?a-x+Pi:0),w=4*(this._cubeSize-v);Aa(t,M,w,3*v,2*v),c.setRenderTarget(t),c.render(h,cs)}}function hy(n){const e=[],t=[],i=[];let a=n;const s=n-Pi+1+Wu.length;for(let r=0;r<s;r++){const o=Math.pow(2,a);e.push(o);let c=1/o;r>n-Pi?c=Wu[r-n+Pi-1]:r===0&&(c=0),t.push(c);const l=1/(o-2),u=-l,h=1+l,d=[u,u,h,u,h,h,u,u,h,h,u,h],f=6,g=6,y=3,p=2,m=1,b=new Float32Array(y*g*f),x=new Float32Array(p*g*f),v=new Float32Array(m*g*f);for(let w=0;w<f;w++){const N=w%3*2/3-1,_=w>2?0:-1,S=[N,_,0,N+2/3,_,0,N+2/3,_+1,0,N,_,0,N+2/3,_+1,0,N,_+1,0];b.set(S,y*g*w),x.set(d,p*g*w);const T=[w,w,w,w,w,w];v.set(T,m*g*w)}const M=new Kt;M.setAttribute("position",new St(b,y)),M.setAttribute("uv",new St(x,p)),M.setAttribute("faceIndex",new St(v,m)),i.push(new An(M,null)),a>Pi&&a--}return{lodMeshes:i,sizeLods:e,sigmas:t}}function Xu(n,e,t){const i=new Dn(n,e,t);return i.texture.mapping=vo,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Aa(n,e,t,i,a){n.viewport.set(e,t,i,a),n.scissor.set(e,t,i,a)}function fy(n,e,t){return new on({name:"PMREMGGXConvolution",defines:{GGX_SAMPLES:dy,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},roughness:{value:0},mipInt:{value:0}},vertexShader:yo(),fragmentShader:`

			precision highp float;
			precision highp int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform float roughness;
			uniform float mipInt;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			#define PI 3.14159265359

			// Van der Corput radical inverse
			float radicalInverse_VdC(uint bits) {
				bits = (bits << 16u) | (bits >> 16u);
				bits = ((bits & 0x55555555u) << 1u) | ((bits & 0xAAAAAAAAu) >> 1u);
				bits = ((bits & 0x33333333u) << 2u) | ((bits & 0xCCCCCCCCu) >> 2u);
				bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits & 0xF0F0F0F0u) >> 4u);
				bits = ((bits & 0x00FF00FFu) << 8u) | ((bits & 0xFF00FF00u) >> 8u);
				return float(bits) * 2.3283064365386963e-10; // / 0x100000000
			}

			// Hammersley sequence
			vec2 hammersley(uint i, uint N) {
				return vec2(float(i) / float(N), radicalInverse_VdC(i));
			}

			// GGX VNDF importance sampling (Eric Heitz 2018)
			// "Sampling the GGX Distribution of Visible Normals"
			// https://jcgt.org/published/0007/04/01/
			vec3 importanceSampleGGX_VNDF(vec2 Xi, vec3 V, float roughness) {
				float alpha = roughness * roughness;

				// Section 4.1: Orthonormal basis
				vec3 T1 = vec3(1.0, 0.0, 0.0);
				vec3 T2 = cross(V, T1);

				// Section 4.2: Parameterization of projected area
				float r = sqrt(Xi.x);
				float phi = 2.0 * PI * Xi.y;
				float t1 = r * cos(phi);
				float t2 = r * sin(phi);
				float s = 0.5 * (1.0 + V.z);
				t2 = (1.0 - s) * sqrt(1.0 - t1 * t1) + s * t2;

				// Section 4.3: Reprojection onto hemisphere
				vec3 Nh = t1 * T1 + t2 * T2 + sqrt(max(0.0, 1.0 - t1 * t1 - t2 * t2)) * V;

				// Section 3.4: Transform back to ellipsoid configuration
				return normalize(vec3(alpha * Nh.x, alpha * Nh.y, max(0.0, Nh.z)));
			}

			void main() {
				vec3 N = normalize(vOutputDirection);
				vec3 V = N; // Assume view direction equals normal for pre-filtering

				vec3 prefilteredColor = vec3(0.0);
				float totalWeight = 0.0;

				// For very low roughness, just sample the environment directly
				if (roughness < 0.001) {
					gl_FragColor = vec4(bilinearCubeUV(envMap, N, mipInt), 1.0);
					return;
				}

				// Tangent space basis for VNDF sampling
				vec3 up = abs(N.z) < 0.999 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
				vec3 tangent = normalize(cross(up, N));
				vec3 bitangent = cross(N, tangent);

				for(uint i = 0u; i < uint(GGX_SAMPLES); i++) {
					vec2 Xi = hammersley(i, uint(GGX_SAMPLES));

					// For PMREM, V = N, so in tangent space V is always (0, 0, 1)
					vec3 H_tangent = importanceSampleGGX_VNDF(Xi, vec3(0.0, 0.0, 1.0), roughness);

					// Transform H back to world space
					vec3 H = normalize(tangent * H_tangent.x + bitangent * H_tangent.y + N * H_tangent.z);
					vec3 L = normalize(2.0 * dot(V, H) * H - V);

					float NdotL = max(dot(N, L), 0.0);

					if(NdotL > 0.0) {
						// Sample environment at fixed mip level
						// VNDF importance sampling handles the distribution filtering
						vec3 sampleColor = bilinearCubeUV(envMap, L, mipInt);

						// Weight by NdotL for the split-sum approximation
						// VNDF PDF naturally accounts for the visible microfacet distribution
						prefilteredColor += sampleColor * NdotL;
						totalWeight += NdotL;
					}
				}

				if (totalWeight > 0.0) {
					prefilteredColor = prefilteredColor / totalWeight;
				}

				gl_FragColor = vec4(prefilteredColor, 1.0);
			}
		`,blending:ui,depthTest:!1,depthWrite:!1})}function py(n,e,t){const i=new Float32Array(Ki),a=new U(0,1,0);return new on({name:"SphericalGaussianBlur",defines:{n:Ki,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:a}},vertexShader:yo(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:ui,depthTest:!1,depthWrite:!1})}function Yu(){return new on({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:yo(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:ui,depthTest:!1,depthWrite:!1})}function Zu(){return new on({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:yo(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:ui,depthTest:!1,depthWrite:!1})}function yo(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}class Jp extends Dn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},a=[i,i,i,i,i,i];this.texture=new Wp(a),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},a=new Hs(5,5,5),s=new on({name:"CubemapFromEquirect",uniforms:Xa(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Qt,blending:ui});s.uniforms.tEquirect.value=t;const r=new An(a,s),o=t.minFilter;return t.minFilter===Ji&&(t.minFilter=Ht),new g0(1,10,this).update(e,r),t.minFilter=o,r.geometry.dispose(),r.material.dispose(),this}clear(e,t=!0,i=!0,a=!0){const s=e.getRenderTarget();for(let r=0;r<6;r++)e.setRenderTarget(this,r),e.clear(t,i,a);e.setRenderTarget(s)}}function my(n){let e=new WeakMap,t=new WeakMap,i=null;function a(d,f=!1){return d==null?null:f?r(d):s(d)}function s(d){if(d&&d.isTexture){const f=d.mapping;if(f===ko||f===Bo)if(e.has(d)){const g=e.get(d).texture;return o(g,d.mapping)}else{const g=d.image;if(g&&g.height>0){const y=new Jp(g.height);return y.fromEquirectangularTexture(n,d),e.set(d,y),d.addEventListener("dispose",l),o(y.texture,d.mapping)}else return null}}return d}function r(d){if(d&&d.isTexture){const f=d.mapping,g=f===ko||f===Bo,y=f===na||f===ja;if(g||y){let p=t.get(d);const m=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return i===null&&(i=new ju(n)),p=g?i.fromEquirectangular(d,p):i.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{const b=d.image;return g&&b&&b.height>0||y&&b&&c(b)?(i===null&&(i=new ju(n)),p=g?i.fromEquirectangular(d):i.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",u),p.texture):null}}}return d}function o(d,f){return f===ko?d.mapping=na:f===Bo&&(d.mapping=ja),d}function c(d){let f=0;const g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function l(d){const f=d.target;f.removeEventListener("dispose",l);const g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(d){const f=d.target;f.removeEventListener("dispose",u);const g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:a,dispose:h}}function gy(n){const e={};function t(i){if(e[i]!==void 0)return e[i];const a=n.getExtension(i);return e[i]=a,a}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const a=t(i);return a===null&&Pl("WebGLRenderer: "+i+" extension not supported."),a}}}function by(n,e,t,i){const a={},s=new WeakMap;function r(h){const d=h.target;d.index!==null&&e.remove(d.index);for(const g in d.attributes)e.remove(d.attributes[g]);d.removeEventListener("dispose",r),delete a[d.id];const f=s.get(d);f&&(e.remove(f),s.delete(d)),i.releaseStatesOfGeometry(d),d.isInstancedBufferGeometry===!0&&delete d._maxInstanceCount,t.memory.geometries--}function o(h,d){return a[d.id]===!0||(d.addEventListener("dispose",r),a[d.id]=!0,t.memory.geometries++),d}function c(h){const d=h.attributes;for(const f in d)e.update(d[f],n.ARRAY_BUFFER)}function l(h){const d=[],f=h.index,g=h.attributes.position;let y=0;if(g===void 0)return;if(f!==null){const b=f.array;y=f.version;for(let x=0,v=b.length;x<v;x+=3){const M=b[x+0],w=b[x+1],N=b[x+2];d.push(M,w,w,N,N,M)}}else{const b=g.array;y=g.version;for(let x=0,v=b.length/3-1;x<v;x+=3){const M=x+0,w=x+1,N=x+2;d.push(M,w,w,N,N,M)}}const p=new(g.count>=65535?Bp:kp)(d,1);p.version=y;const m=s.get(h);m&&e.remove(m),s.set(h,p)}function u(h){const d=s.get(h);if(d){const f=h.index;f!==null&&d.version<f.version&&l(h)}else l(h);return s.get(h)}return{get:o,update:c,getWireframeAttribute:u}}function _y(n,e,t){let i;function a(h){i=h}let s,r;function o(h){s=h.type,r=h.bytesPerElement}function c(h,d){n.drawElements(i,d,s,h*r),t.update(d,i,1)}function l(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,s,h*r,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,s,h,0,f);let y=0;for(let p=0;p<f;p++)y+=d[p];t.update(y,i,1)}this.setMode=a,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function vy(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,r,o){switch(t.calls++,r){case n.TRIANGLES:t.triangles+=o*(s/3);break;case n.LINES:t.lines+=o*(s/2);break;case n.LINE_STRIP:t.lines+=o*(s-1);break;case n.LINE_LOOP:t.lines+=o*s;break;case n.POINTS:t.points+=o*s;break;default:Xe("WebGLInfo: Unknown draw mode:",r);break}}function a(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:a,update:i}}function yy(n,e,t){const i=new WeakMap,a=new ut;function s(r,o,c){const l=r.morphTargetInfluences,u=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,h=u!==void 0?u.length:0;let d=i.get(o);if(d===void 0||d.count!==h){let T=function(){_.dispose(),i.delete(o),o.removeEventListener("dispose",T)};var f=T;d!==void 0&&d.texture.dispose();const g=o.morphAttributes.position!==void 0,y=o.morphAttributes.normal!==void 0,p=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],b=o.morphAttributes.normal||[],x=o.morphAttributes.color||[];let v=0;g===!0&&(v=1),y===!0&&(v=2),p===!0&&(v=3);let M=o.attributes.position.count*v,w=1;M>e.maxTextureSize&&(w=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);const N=new Float32Array(M*w*4*h),_=new Op(N,M,w,h);_.type=Zn,_.needsUpdate=!0;const S=v*4;for(let I=0;I<h;I++){const C=m[I],L=b[I],F=x[I],P=M*w*4*I;for(let B=0;B<C.count;B++){const V=B*S;g===!0&&(a.fromBufferAttribute(C,B),N[P+V+0]=a.x,N[P+V+1]=a.y,N[P+V+2]=a.z,N[P+V+3]=0),y===!0&&(a.fromBufferAttribute(L,B),N[P+V+4]=a.x,N[P+V+5]=a.y,N[P+V+6]=a.z,N[P+V+7]=0),p===!0&&(a.fromBufferAttribute(F,B),N[P+V+8]=a.x,N[P+V+9]=a.y,N[P+V+10]=a.z,N[P+V+11]=F.itemSize===4?a.w:1)}}d={count:h,texture:_,size:new we(M,w)},i.set(o,d),o.addEventListener("dispose",T)}if(r.isInstancedMesh===!0&&r.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",r.morphTexture,t);else{let g=0;for(let p=0;p<l.length;p++)g+=l[p];const y=o.morphTargetsRelative?1:1-g;c.getUniforms().setValue(n,"morphTargetBaseInfluence",y),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),c.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:s}}function xy(n,e,t,i,a){let s=new WeakMap;function r(l){const u=a.render.frame,h=l.geometry,d=e.get(l,h);if(s.get(d)!==u&&(e.update(d),s.set(d,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),s.get(l)!==u&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,u))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==u&&(f.update(),s.set(f,u))}return d}function o(){s=new WeakMap}function c(l){const u=l.target;u.removeEventListener("dispose",c),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:r,dispose:o}}const Ey={[vp]:"LINEAR_TONE_MAPPING",[yp]:"REINHARD_TONE_MAPPING",[xp]:"CINEON_TONE_MAPPING",[Ep]:"ACES_FILMIC_TONE_MAPPING",[Mp]:"AGX_TONE_MAPPING",[Ap]:"NEUTRAL_TONE_MAPPING",[Sp]:"CUSTOM_TONE_MAPPING"};function Sy(n,e,t,i,a){const s=new Dn(e,t,{type:n,depthBuffer:i,stencilBuffer:a,depthTexture:i?new sa(e,t):void 0}),r=new Dn(e,t,{type:pi,depthBuffer:!1,stencilBuffer:!1}),o=new Kt;o.setAttribute("position",new Mn([-1,3,0,-1,-1,0,3,-1,0],3)),o.setAttribute("uv",new Mn([0,2,0,0,2,0],2));const c=new h0({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),l=new An(o,c),u=new bd(-1,1,1,-1,0,1);let h=null,d=null,f=!1,g,y=null,p=[],m=!1;this.setSize=function(b,x){s.setSize(b,x),r.setSize(b,x);for(let v=0;v<p.length;v++){const M=p[v];M.setSize&&M.setSize(b,x)}},this.setEffects=function(b){p=b,m=p.length>0&&p[0].isRenderPass===!0;const x=s.width,v=s.height;for(let M=0;M<p.length;M++){const w=p[M];w.setSize&&w.setSize(x,v)}},this.begin=function(b,x){if(f||b.toneMapping===Jn&&p.length===0)return!1;if(y=x,x!==null){const v=x.width,M=x.height;(s.width!==v||s.height!==M)&&this.setSize(v,M)}return m===!1&&b.setRenderTarget(s),g=b.toneMapping,b.toneMapping=Jn,!0},this.hasRenderPass=function(){return m},this.end=function(b,x){b.toneMapping=g,f=!0;let v=s,M=r;for(let w=0;w<p.length;w++){const N=p[w];if(N.enabled!==!1&&(N.render(b,M,v,x),N.needsSwap!==!1)){const _=v;v=M,M=_}}if(h!==b.outputColorSpace||d!==b.toneMapping){h=b.outputColorSpace,d=b.toneMapping,c.defines={},je.getTransfer(h)===Qe&&(c.defines.SRGB_TRANSFER="");const w=Ey[d];w&&(c.defines[w]=""),c.needsUpdate=!0}c.uniforms.tDiffuse.value=v.texture,b.setRenderTarget(y),b.render(l,u),y=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){s.depthTexture&&s.depthTexture.dispose(),s.dispose(),r.dispose(),o.dispose(),c.dispose()}}const qp=new en,Fl=new sa(1,1),$p=new Op,Qp=new Gb,em=new Wp,Ku=[],Ju=[],qu=new Float32Array(16),$u=new Float32Array(9),Qu=new Float32Array(4);function ns(n,e,t){const i=n[0];if(i<=0||i>0)return n;const a=e*t;let s=Ku[a];if(s===void 0&&(s=new Float32Array(a),Ku[a]=s),e!==0){i.toArray(s,0);for(let r=1,o=0;r!==e;++r)o+=t,n[r].toArray(s,o)}return s}function Ut(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Pt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function xo(n,e){let t=Ju[e];t===void 0&&(t=new Int32Array(e),Ju[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function My(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function Ay(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ut(t,e))return;n.uniform2fv(this.addr,e),Pt(t,e)}}function wy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Ut(t,e))return;n.uniform3fv(this.addr,e),Pt(t,e)}}function Ty(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ut(t,e))return;n.uniform4fv(this.addr,e),Pt(t,e)}}function Iy(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Ut(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Pt(t,e)}else{if(Ut(t,i))return;Qu.set(i),n.uniformMatrix2fv(this.addr,!1,Qu),Pt(t,i)}}function Ny(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Ut(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Pt(t,e)}else{if(Ut(t,i))return;$u.set(i),n.uniformMatrix3fv(this.addr,!1,$u),Pt(t,i)}}function Ry(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Ut(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Pt(t,e)}else{if(Ut(t,i))return;qu.set(i),n.uniformMatrix4fv(this.addr,!1,qu),Pt(t,i)}}function Cy(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function Uy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ut(t,e))return;n.uniform2iv(this.addr,e),Pt(t,e)}}function Py(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ut(t,e))return;n.uniform3iv(this.addr,e),Pt(t,e)}}function Ly(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ut(t,e))return;n.uniform4iv(this.addr,e),Pt(t,e)}}function Dy(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function Oy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Ut(t,e))return;n.uniform2uiv(this.addr,e),Pt(t,e)}}function Fy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Ut(t,e))return;n.uniform3uiv(this.addr,e),Pt(t,e)}}function ky(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Ut(t,e))return;n.uniform4uiv(this.addr,e),Pt(t,e)}}function By(n,e,t){const i=this.cache,a=t.allocateTextureUnit();i[0]!==a&&(n.uniform1i(this.addr,a),i[0]=a);let s;this.type===n.SAMPLER_2D_SHADOW?(Fl.compareFunction=t.isReversedDepthBuffer()?hd:ud,s=Fl):s=qp,t.setTexture2D(e||s,a)}function Vy(n,e,t){const i=this.cache,a=t.allocateTextureUnit();i[0]!==a&&(n.uniform1i(this.addr,a),i[0]=a),t.setTexture3D(e||Qp,a)}function zy(n,e,t){const i=this.cache,a=t.allocateTextureUnit();i[0]!==a&&(n.uniform1i(this.addr,a),i[0]=a),t.setTextureCube(e||em,a)}function Gy(n,e,t){const i=this.cache,a=t.allocateTextureUnit();i[0]!==a&&(n.uniform1i(this.addr,a),i[0]=a),t.setTexture2DArray(e||$p,a)}function Wy(n){switch(n){case 5126:return My;case 35664:return Ay;case 35665:return wy;case 35666:return Ty;case 35674:return Iy;case 35675:return Ny;case 35676:return Ry;case 5124:case 35670:return Cy;case 35667:case 35671:return Uy;case 35668:case 35672:return Py;case 35669:case 35673:return Ly;case 5125:return Dy;case 36294:return Oy;case 36295:return Fy;case 36296:return ky;case 35678:case 36198:case 36298:case 36306:case 35682:return By;case 35679:case 36299:case 36307:return Vy;case 35680:case 36300:case 36308:case 36293:return zy;case 36289:case 36303:case 36311:case 36292:return Gy}}function Hy(n,e){n.uniform1fv(this.addr,e)}function jy(n,e){const t=ns(e,this.size,2);n.uniform2fv(this.addr,t)}function Xy(n,e){const t=ns(e,this.size,3);n.uniform3fv(this.addr,t)}function Yy(n,e){const t=ns(e,this.size,4);n.uniform4fv(this.addr,t)}function Zy(n,e){const t=ns(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Ky(n,e){const t=ns(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function Jy(n,e){const t=ns(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function qy(n,e){n.uniform1iv(this.addr,e)}function $y(n,e){n.uniform2iv(this.addr,e)}function Qy(n,e){n.uniform3iv(this.addr,e)}function ex(n,e){n.uniform4iv(this.addr,e)}function tx(n,e){n.uniform1uiv(this.addr,e)}function nx(n,e){n.uniform2uiv(this.addr,e)}function ix(n,e){n.uniform3uiv(this.addr,e)}function ax(n,e){n.uniform4uiv(this.addr,e)}function sx(n,e,t){const i=this.cache,a=e.length,s=xo(t,a);Ut(i,s)||(n.uniform1iv(this.addr,s),Pt(i,s));let r;this.type===n.SAMPLER_2D_SHADOW?r=Fl:r=qp;for(let o=0;o!==a;++o)t.setTexture2D(e[o]||r,s[o])}function rx(n,e,t){const i=this.cache,a=e.length,s=xo(t,a);Ut(i,s)||(n.uniform1iv(this.addr,s),Pt(i,s));for(let r=0;r!==a;++r)t.setTexture3D(e[r]||Qp,s[r])}function ox(n,e,t){const i=this.cache,a=e.length,s=xo(t,a);Ut(i,s)||(n.uniform1iv(this.addr,s),Pt(i,s));for(let r=0;r!==a;++r)t.setTextureCube(e[r]||em,s[r])}function cx(n,e,t){const i=this.cache,a=e.length,s=xo(t,a);Ut(i,s)||(n.uniform1iv(this.addr,s),Pt(i,s));for(let r=0;r!==a;++r)t.setTexture2DArray(e[r]||$p,s[r])}function lx(n){switch(n){case 5126:return Hy;case 35664:return jy;case 35665:return Xy;case 35666:return Yy;case 35674:return Zy;case 35675:return Ky;case 35676:return Jy;case 5124:case 35670:return qy;case 35667:case 35671:return $y;case 35668:case 35672:return Qy;case 35669:case 35673:return ex;case 5125:return tx;case 36294:return nx;case 36295:return ix;case 36296:return ax;case 35678:case 36198:case 36298:case 36306:case 35682:return sx;case 35679:case 36299:case 36307:return rx;case 35680:case 36300:case 36308:case 36293:return ox;case 36289:case 36303:case 36311:case 36292:return cx}}class dx{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Wy(t.type)}}class ux{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=lx(t.type)}}class hx{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const a=this.seq;for(let s=0,r=a.length;s!==r;++s){const o=a[s];o.setValue(e,t[o.id],i)}}}const mc=/(\w+)(\])?(\[|\.)?/g;function eh(n,e){n.seq.push(e),n.map[e.id]=e}function fx(n,e,t){const i=n.name,a=i.length;for(mc.lastIndex=0;;){const s=mc.exec(i),r=mc.lastIndex;let o=s[1];const c=s[2]==="]",l=s[3];if(c&&(o=o|0),l===void 0||l==="["&&r+2===a){eh(t,l===void 0?new dx(o,n,e):new ux(o,n,e));break}else{let h=t.map[o];h===void 0&&(h=new hx(o),eh(t,h)),t=h}}}class qr{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let r=0;r<i;++r){const o=e.getActiveUniform(t,r),c=e.getUniformLocation(t,o.name);fx(o,c,this)}const a=[],s=[];for(const r of this.seq)r.type===e.SAMPLER_2D_SHADOW||r.type===e.SAMPLER_CUBE_SHADOW||r.type===e.SAMPLER_2D_ARRAY_SHADOW?a.push(r):s.push(r);a.length>0&&(this.seq=a.concat(s))}setValue(e,t,i,a){const s=this.map[t];s!==void 0&&s.setValue(e,i,a)}setOptional(e,t,i){const a=t[i];a!==void 0&&this.setValue(e,i,a)}static upload(e,t,i,a){for(let s=0,r=t.length;s!==r;++s){const o=t[s],c=i[o.id];c.needsUpdate!==!1&&o.setValue(e,c.value,a)}}static seqWithValue(e,t){const i=[];for(let a=0,s=e.length;a!==s;++a){const r=e[a];r.id in t&&i.push(r)}return i}}function th(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const px=37297;let mx=0;function gx(n,e){const t=n.split(`
`),i=[],a=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let r=a;r<s;r++){const o=r+1;i.push(`${o===e?">":" "} ${o}: ${t[r]}`)}return i.join(`
`)}const nh=new De;function bx(n){je._getMatrix(nh,je.workingColorSpace,n);const e=`mat3( ${nh.elements.map(t=>t.toFixed(4))} )`;switch(je.getTransfer(n)){case ro:return[e,"LinearTransferOETF"];case Qe:return[e,"sRGBTransferOETF"];default:return Ne("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function ih(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return t.toUpperCase()+`

`+s+`

`+gx(n.getShaderSource(e),o)}else return s}function _x(n,e){const t=bx(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}const vx={[vp]:"Linear",[yp]:"Reinhard",[xp]:"Cineon",[Ep]:"ACESFilmic",[Mp]:"AgX",[Ap]:"Neutral",[Sp]:"Custom"};function yx(n,e){const t=vx[e];return t===void 0?(Ne("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const xr=new U;function xx(){je.getLuminanceCoefficients(xr);const n=xr.x.toFixed(4),e=xr.y.toFixed(4),t=xr.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Ex(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Es).join(`
`)}function Sx(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function Mx(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let a=0;a<i;a++){const s=n.getActiveAttrib(e,a),r=s.name;let o=1;s.type===n.FLOAT_MAT2&&(o=2),s.type===n.FLOAT_MAT3&&(o=3),s.type===n.FLOAT_MAT4&&(o=4),t[r]={type:s.type,location:n.getAttribLocation(e,r),locationSize:o}}return t}function Es(n){return n!==""}function ah(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function sh(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const Ax=/^[ \t]*#include +<([\w\d./]+)>/gm;function kl(n){return n.replace(Ax,Tx)}const wx=new Map;function Tx(n,e){let t=Be[e];if(t===void 0){const i=wx.get(e);if(i!==void 0)t=Be[i],Ne('WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("Can not resolve #include <"+e+">")}return kl(t)}const Ix=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function rh(n){return n.replace(Ix,Nx)}function Nx(n,e,t,i){let a="";for(let s=parseInt(e);s<parseInt(t);s++)a+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return a}function oh(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}const Rx={[Xr]:"SHADOWMAP_TYPE_PCF",[ys]:"SHADOWMAP_TYPE_VSM"};function Cx(n){return Rx[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const Ux={[na]:"ENVMAP_TYPE_CUBE",[ja]:"ENVMAP_TYPE_CUBE",[vo]:"ENVMAP_TYPE_CUBE_UV"};function Px(n){return n.envMap===!1?"ENVMAP_TYPE_CUBE":Ux[n.envMapMode]||"ENVMAP_TYPE_CUBE"}const Lx={[ja]:"ENVMAP_MODE_REFRACTION"};function Dx(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Lx[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}const Ox={[_p]:"ENVMAP_BLENDING_MULTIPLY",[sb]:"ENVMAP_BLENDING_MIX",[rb]:"ENVMAP_BLENDING_ADD"};function Fx(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Ox[n.combine]||"ENVMAP_BLENDING_NONE"}function kx(n){const e=n.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function Bx(n,e,t,i){const a=n.getContext(),s=t.defines;let r=t.vertexShader,o=t.fragmentShader;const c=Cx(t),l=Px(t),u=Dx(t),h=Fx(t),d=kx(t),f=Ex(t),g=Sx(s),y=a.createProgram();let p,m,b=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Es).join(`
`),p.length>0&&(p+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(Es).join(`
`),m.length>0&&(m+=`
`)):(p=[oh(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Es).join(`
`),m=[oh(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",d?"#define CUBEUV_TEXEL_WIDTH "+d.texelWidth:"",d?"#define CUBEUV_TEXEL_HEIGHT "+d.texelHeight:"",d?"#define CUBEUV_MAX_MIP "+d.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.numLightProbeGrids>0?"#define USE_LIGHT_PROBES_GRID":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Jn?"#define TONE_MAPPING":"",t.toneMapping!==Jn?Be.tonemapping_pars_fragment:"",t.toneMapping!==Jn?yx("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Be.colorspace_pars_fragment,_x("linearToOutputTexel",t.outputColorSpace),xx(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Es).join(`
`)),r=kl(r),r=ah(r,t),r=sh(r,t),o=kl(o),o=ah(o,t),o=sh(o,t),r=rh(r),o=rh(o),t.isRawShaderMaterial!==!0&&(b=`#version 300 es
`,p=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,m=["#define varying in",t.glslVersion===mu?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===mu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);const x=b+p+r,v=b+m+o,M=th(a,a.VERTEX_SHADER,x),w=th(a,a.FRAGMENT_SHADER,v);a.attachShader(y,M),a.attachShader(y,w),t.index0AttributeName!==void 0?a.bindAttribLocation(y,0,t.index0AttributeName):t.morphTargets===!0&&a.bindAttribLocation(y,0,"position"),a.linkProgram(y);function N(I){if(n.debug.checkShaderErrors){const C=a.getProgramInfoLog(y)||"",L=a.getShaderInfoLog(M)||"",F=a.getShaderInfoLog(w)||"",P=C.trim(),B=L.trim(),V=F.trim();let q=!0,ee=!0;if(a.getProgramParameter(y,a.LINK_STATUS)===!1)if(q=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(a,y,M,w);else{const le=ih(a,M,"vertex"),ve=ih(a,w,"fragment");Xe("THREE.WebGLProgram: Shader Error "+a.getError()+" - VALIDATE_STATUS "+a.getProgramParameter(y,a.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+P+`
`+le+`
`+ve)}else P!==""?Ne("WebGLProgram: Program Info Log:",P):(B===""||V==="")&&(ee=!1);ee&&(I.diagnostics={runnable:q,programLog:P,vertexShader:{log:B,prefix:p},fragmentShader:{log:V,prefix:m}})}a.deleteShader(M),a.deleteShader(w),_=new qr(a,y),S=Mx(a,y)}let _;this.getUniforms=function(){return _===void 0&&N(this),_};let S;this.getAttributes=function(){return S===void 0&&N(this),S};let T=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=a.getProgramParameter(y,px)),T},this.destroy=function(){i.releaseStatesOfProgram(this),a.deleteProgram(y),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=mx++,this.cacheKey=e,this.usedTimes=1,this.program=y,this.vertexShader=M,this.fragmentShader=w,this}let Vx=0;class zx{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,i=e.fragmentShader,a=this._getShaderStage(t),s=this._getShaderStage(i),r=this._getShaderCacheForMaterial(e);return r.has(a)===!1&&(r.add(a),a.usedTimes++),r.has(s)===!1&&(r.add(s),s.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new Gx(e),t.set(e,i)),i}}class Gx{constructor(e){this.id=Vx++,this.code=e,this.usedTimes=0}}function Wx(n){return n===ia||n===ao||n===so}function Hx(n,e,t,i,a,s){const r=new md,o=new zx,c=new Set,l=[],u=new Map,h=i.logarithmicDepthBuffer;let d=i.precision;const f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function g(_){return c.add(_),_===0?"uv":`uv${_}`}function y(_,S,T,I,C,L){const F=I.fog,P=C.geometry,B=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?I.environment:null,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,q=e.get(_.envMap||B,V),ee=q&&q.mapping===vo?q.image.height:null,le=f[_.type];_.precision!==null&&(d=i.getMaxPrecision(_.precision),d!==_.precision&&Ne("WebGLProgram.getParameters:",_.precision,"not supported, using",d,"instead."));const ve=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,ye=ve!==void 0?ve.length:0;let Ge=0;P.morphAttributes.position!==void 0&&(Ge=1),P.morphAttributes.normal!==void 0&&(Ge=2),P.morphAttributes.color!==void 0&&(Ge=3);let $e,Re,J,ue;if(le){const Oe=an[le];$e=Oe.vertexShader,Re=Oe.fragmentShader}else $e=_.vertexShader,Re=_.fragmentShader,o.update(_),J=o.getVertexShaderID(_),ue=o.getFragmentShaderID(_);const ae=n.getRenderTarget(),Te=n.state.buffers.depth.getReversed(),Ce=C.isInstancedMesh===!0,Ie=C.isBatchedMesh===!0,rt=!!_.map,We=!!_.matcap,nt=!!q,ht=!!_.aoMap,ze=!!_.lightMap,Tt=!!_.bumpMap,pt=!!_.normalMap,cn=!!_.displacementMap,O=!!_.emissiveMap,It=!!_.metalnessMap,He=!!_.roughnessMap,lt=_.anisotropy>0,de=_.clearcoat>0,mt=_.dispersion>0,R=_.iridescence>0,E=_.sheen>0,G=_.transmission>0,Z=lt&&!!_.anisotropyMap,Q=de&&!!_.clearcoatMap,te=de&&!!_.clearcoatNormalMap,oe=de&&!!_.clearcoatRoughnessMap,X=R&&!!_.iridescenceMap,K=R&&!!_.iridescenceThicknessMap,pe=E&&!!_.sheenColorMap,be=E&&!!_.sheenRoughnessMap,se=!!_.specularMap,ne=!!_.specularColorMap,Ue=!!_.specularIntensityMap,ke=G&&!!_.transmissionMap,Ke=G&&!!_.thicknessMap,D=!!_.gradientMap,ie=!!_.alphaMap,Y=_.alphaTest>0,me=!!_.alphaHash,re=!!_.extensions;let $=Jn;_.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&($=n.toneMapping);const Ee={shaderID:le,shaderType:_.type,shaderName:_.name,vertexShader:$e,fragmentShader:Re,defines:_.defines,customVertexShaderID:J,customFragmentShaderID:ue,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:d,batching:Ie,batchingColor:Ie&&C._colorsTexture!==null,instancing:Ce,instancingColor:Ce&&C.instanceColor!==null,instancingMorph:Ce&&C.morphTexture!==null,outputColorSpace:ae===null?n.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:je.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:rt,matcap:We,envMap:nt,envMapMode:nt&&q.mapping,envMapCubeUVHeight:ee,aoMap:ht,lightMap:ze,bumpMap:Tt,normalMap:pt,displacementMap:cn,emissiveMap:O,normalMapObjectSpace:pt&&_.normalMapType===lb,normalMapTangentSpace:pt&&_.normalMapType===fu,packedNormalMap:pt&&_.normalMapType===fu&&Wx(_.normalMap.format),metalnessMap:It,roughnessMap:He,anisotropy:lt,anisotropyMap:Z,clearcoat:de,clearcoatMap:Q,clearcoatNormalMap:te,clearcoatRoughnessMap:oe,dispersion:mt,iridescence:R,iridescenceMap:X,iridescenceThicknessMap:K,sheen:E,sheenColorMap:pe,sheenRoughnessMap:be,specularMap:se,specularColorMap:ne,specularIntensityMap:Ue,transmission:G,transmissionMap:ke,thicknessMap:Ke,gradientMap:D,opaque:_.transparent===!1&&_.blending===za&&_.alphaToCoverage===!1,alphaMap:ie,alphaTest:Y,alphaHash:me,combine:_.combine,mapUv:rt&&g(_.map.channel),aoMapUv:ht&&g(_.aoMap.channel),lightMapUv:ze&&g(_.lightMap.channel),bumpMapUv:Tt&&g(_.bumpMap.channel),normalMapUv:pt&&g(_.normalMap.channel),displacementMapUv:cn&&g(_.displacementMap.channel),emissiveMapUv:O&&g(_.emissiveMap.channel),metalnessMapUv:It&&g(_.metalnessMap.channel),roughnessMapUv:He&&g(_.roughnessMap.channel),anisotropyMapUv:Z&&g(_.anisotropyMap.channel),clearcoatMapUv:Q&&g(_.clearcoatMap.channel),clearcoatNormalMapUv:te&&g(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:oe&&g(_.clearcoatRoughnessMap.channel),iridescenceMapUv:X&&g(_.iridescenceMap.channel),iridescenceThicknessMapUv:K&&g(_.iridescenceThicknessMap.channel),sheenColorMapUv:pe&&g(_.sheenColorMap.channel),sheenRoughnessMapUv:be&&g(_.sheenRoughnessMap.channel),specularMapUv:se&&g(_.specularMap.channel),specularColorMapUv:ne&&g(_.specularColorMap.channel),specularIntensityMapUv:Ue&&g(_.specularIntensityMap.channel),transmissionMapUv:ke&&g(_.transmissionMap.channel),thicknessMapUv:Ke&&g(_.thicknessMap.channel),alphaMapUv:ie&&g(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(pt||lt),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!P.attributes.uv&&(rt||ie),fog:!!F,useFog:_.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&pt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Te,skinning:C.isSkinnedMesh===!0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:ye,morphTextureStride:Ge,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:L.length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&T.length>0,shadowMapType:n.shadowMap.type,toneMapping:$,decodeVideoTexture:rt&&_.map.isVideoTexture===!0&&je.getTransfer(_.map.colorSpace)===Qe,decodeVideoTextureEmissive:O&&_.emissiveMap.isVideoTexture===!0&&je.getTransfer(_.emissiveMap.colorSpace)===Qe,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===yn,flipSided:_.side===Qt,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:re&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(re&&_.extensions.multiDraw===!0||Ie)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Ee.vertexUv1s=c.has(1),Ee.vertexUv2s=c.has(2),Ee.vertexUv3s=c.has(3),c.clear(),Ee}function p(_){const S=[];if(_.shaderID?S.push(_.shaderID):(S.push(_.customVertexShaderID),S.push(_.customFragmentShaderID)),_.defines!==void 0)for(const T in _.defines)S.push(T),S.push(_.defines[T]);return _.isRawShaderMaterial===!1&&(m(S,_),b(S,_),S.push(n.outputColorSpace)),S.push(_.customProgramCacheKey),S.join()}function m(_,S){_.push(S.precision),_.push(S.outputColorSpace),_.push(S.envMapMode),_.push(S.envMapCubeUVHeight),_.push(S.mapUv),_.push(S.alphaMapUv),_.push(S.lightMapUv),_.push(S.aoMapUv),_.push(S.bumpMapUv),_.push(S.normalMapUv),_.push(S.displacementMapUv),_.push(S.emissiveMapUv),_.push(S.metalnessMapUv),_.push(S.roughnessMapUv),_.push(S.anisotropyMapUv),_.push(S.clearcoatMapUv),_.push(S.clearcoatNormalMapUv),_.push(S.clearcoatRoughnessMapUv),_.push(S.iridescenceMapUv),_.push(S.iridescenceThicknessMapUv),_.push(S.sheenColorMapUv),_.push(S.sheenRoughnessMapUv),_.push(S.specularMapUv),_.push(S.specularColorMapUv),_.push(S.specularIntensityMapUv),_.push(S.transmissionMapUv),_.push(S.thicknessMapUv),_.push(S.combine),_.push(S.fogExp2),_.push(S.sizeAttenuation),_.push(S.morphTargetsCount),_.push(S.morphAttributeCount),_.push(S.numDirLights),_.push(S.numPointLights),_.push(S.numSpotLights),_.push(S.numSpotLightMaps),_.push(S.numHemiLights),_.push(S.numRectAreaLights),_.push(S.numDirLightShadows),_.push(S.numPointLightShadows),_.push(S.numSpotLightShadows),_.push(S.numSpotLightShadowsWithMaps),_.push(S.numLightProbes),_.push(S.shadowMapType),_.push(S.toneMapping),_.push(S.numClippingPlanes),_.push(S.numClipIntersection),_.push(S.depthPacking)}function b(_,S){r.disableAll(),S.instancing&&r.enable(0),S.instancingColor&&r.enable(1),S.instancingMorph&&r.enable(2),S.matcap&&r.enable(3),S.envMap&&r.enable(4),S.normalMapObjectSpace&&r.enable(5),S.normalMapTangentSpace&&r.enable(6),S.clearcoat&&r.enable(7),S.iridescence&&r.enable(8),S.alphaTest&&r.enable(9),S.vertexColors&&r.enable(10),S.vertexAlphas&&r.enable(11),S.vertexUv1s&&r.enable(12),S.vertexUv2s&&r.enable(13),S.vertexUv3s&&r.enable(14),S.vertexTangents&&r.enable(15),S.anisotropy&&r.enable(16),S.alphaHash&&r.enable(17),S.batching&&r.enable(18),S.dispersion&&r.enable(19),S.batchingColor&&r.enable(20),S.gradientMap&&r.enable(21),S.packedNormalMap&&r.enable(22),S.vertexNormals&&r.enable(23),_.push(r.mask),r.disableAll(),S.fog&&r.enable(0),S.useFog&&r.enable(1),S.flatShading&&r.enable(2),S.logarithmicDepthBuffer&&r.enable(3),S.reversedDepthBuffer&&r.enable(4),S.skinning&&r.enable(5),S.morphTargets&&r.enable(6),S.morphNormals&&r.enable(7),S.morphColors&&r.enable(8),S.premultipliedAlpha&&r.enable(9),S.shadowMapEnabled&&r.enable(10),S.doubleSided&&r.enable(11),S.flipSided&&r.enable(12),S.useDepthPacking&&r.enable(13),S.dithering&&r.enable(14),S.transmission&&r.enable(15),S.sheen&&r.enable(16),S.opaque&&r.enable(17),S.pointsUvs&&r.enable(18),S.decodeVideoTexture&&r.enable(19),S.decodeVideoTextureEmissive&&r.enable(20),S.alphaToCoverage&&r.enable(21),S.numLightProbeGrids>0&&r.enable(22),_.push(r.mask)}function x(_){const S=f[_.type];let T;if(S){const I=an[S];T=gd.clone(I.uniforms)}else T=_.uniforms;return T}function v(_,S){let T=u.get(S);return T!==void 0?++T.usedTimes:(T=new Bx(n,S,_,a),l.push(T),u.set(S,T)),T}function M(_){if(--_.usedTimes===0){const S=l.indexOf(_);l[S]=l[l.length-1],l.pop(),u.delete(_.cacheKey),_.destroy()}}function w(_){o.remove(_)}function N(){o.dispose()}return{getParameters:y,getProgramCacheKey:p,getUniforms:x,acquireProgram:v,releaseProgram:M,releaseShaderCache:w,programs:l,dispose:N}}function jx(){let n=new WeakMap;function e(r){return n.has(r)}function t(r){let o=n.get(r);return o===void 0&&(o={},n.set(r,o)),o}function i(r){n.delete(r)}function a(r,o,c){n.get(r)[o]=c}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:a,dispose:s}}function Xx(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function ch(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function lh(){const n=[];let e=0;const t=[],i=[],a=[];function s(){e=0,t.length=0,i.length=0,a.length=0}function r(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function o(d,f,g,y,p,m){let b=n[e];return b===void 0?(b={id:d.id,object:d,geometry:f,material:g,materialVariant:r(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:m},n[e]=b):(b.id=d.id,b.object=d,b.geometry=f,b.material=g,b.materialVariant=r(d),b.groupOrder=y,b.renderOrder=d.renderOrder,b.z=p,b.group=m),e++,b}function c(d,f,g,y,p,m){const b=o(d,f,g,y,p,m);g.transmission>0?i.push(b):g.transparent===!0?a.push(b):t.push(b)}function l(d,f,g,y,p,m){const b=o(d,f,g,y,p,m);g.transmission>0?i.unshift(b):g.transparent===!0?a.unshift(b):t.unshift(b)}function u(d,f){t.length>1&&t.sort(d||Xx),i.length>1&&i.sort(f||ch),a.length>1&&a.sort(f||ch)}function h(){for(let d=e,f=n.length;d<f;d++){const g=n[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:a,init:s,push:c,unshift:l,finish:h,sort:u}}function Yx(){let n=new WeakMap;function e(i,a){const s=n.get(i);let r;return s===void 0?(r=new lh,n.set(i,[r])):a>=s.length?(r=new lh,s.push(r)):r=s[a],r}function t(){n=new WeakMap}return{get:e,dispose:t}}function Zx(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new U,color:new Ze};break;case"SpotLight":t={position:new U,direction:new U,color:new Ze,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new U,color:new Ze,distance:0,decay:0};break;case"HemisphereLight":t={direction:new U,skyColor:new Ze,groundColor:new Ze};break;case"RectAreaLight":t={color:new Ze,position:new U,halfWidth:new U,halfHeight:new U};break}return n[e.id]=t,t}}}function Kx(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let Jx=0;function qx(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function $x(n){const e=new Zx,t=Kx(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new U);const a=new U,s=new qe,r=new qe;function o(l){let u=0,h=0,d=0;for(let S=0;S<9;S++)i.probe[S].set(0,0,0);let f=0,g=0,y=0,p=0,m=0,b=0,x=0,v=0,M=0,w=0,N=0;l.sort(qx);for(let S=0,T=l.length;S<T;S++){const I=l[S],C=I.color,L=I.intensity,F=I.distance;let P=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===ia?P=I.shadow.map.texture:P=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=C.r*L,h+=C.g*L,d+=C.b*L;else if(I.isLightProbe){for(let B=0;B<9;B++)i.probe[B].addScaledVector(I.sh.coefficients[B],L);N++}else if(I.isDirectionalLight){const B=e.get(I);if(B.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){const V=I.shadow,q=t.get(I);q.shadowIntensity=V.intensity,q.shadowBias=V.bias,q.shadowNormalBias=V.normalBias,q.shadowRadius=V.radius,q.shadowMapSize=V.mapSize,i.directionalShadow[f]=q,i.directionalShadowMap[f]=P,i.directionalShadowMatrix[f]=I.shadow.matrix,b++}i.directional[f]=B,f++}else if(I.isSpotLight){const B=e.get(I);B.position.setFromMatrixPosition(I.matrixWorld),B.color.copy(C).multiplyScalar(L),B.distance=F,B.coneCos=Math.cos(I.angle),B.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),B.decay=I.decay,i.spot[y]=B;const V=I.shadow;if(I.map&&(i.spotLightMap[M]=I.map,M++,V.updateMatrices(I),I.castShadow&&w++),i.spotLightMatrix[y]=V.matrix,I.castShadow){const q=t.get(I);q.shadowIntensity=V.intensity,q.shadowBias=V.bias,q.shadowNormalBias=V.normalBias,q.shadowRadius=V.radius,q.shadowMapSize=V.mapSize,i.spotShadow[y]=q,i.spotShadowMap[y]=P,v++}y++}else if(I.isRectAreaLight){const B=e.get(I);B.color.copy(C).multiplyScalar(L),B.halfWidth.set(I.width*.5,0,0),B.halfHeight.set(0,I.height*.5,0),i.rectArea[p]=B,p++}else if(I.isPointLight){const B=e.get(I);if(B.color.copy(I.color).multiplyScalar(I.intensity),B.distance=I.distance,B.decay=I.decay,I.castShadow){const V=I.shadow,q=t.get(I);q.shadowIntensity=V.intensity,q.shadowBias=V.bias,q.shadowNormalBias=V.normalBias,q.shadowRadius=V.radius,q.shadowMapSize=V.mapSize,q.shadowCameraNear=V.camera.near,q.shadowCameraFar=V.camera.far,i.pointShadow[g]=q,i.pointShadowMap[g]=P,i.pointShadowMatrix[g]=I.shadow.matrix,x++}i.point[g]=B,g++}else if(I.isHemisphereLight){const B=e.get(I);B.skyColor.copy(I.color).multiplyScalar(L),B.groundColor.copy(I.groundColor).multiplyScalar(L),i.hemi[m]=B,m++}}p>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=ce.LTC_FLOAT_1,i.rectAreaLTC2=ce.LTC_FLOAT_2):(i.rectAreaLTC1=ce.LTC_HALF_1,i.rectAreaLTC2=ce.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;const _=i.hash;(_.directionalLength!==f||_.pointLength!==g||_.spotLength!==y||_.rectAreaLength!==p||_.hemiLength!==m||_.numDirectionalShadows!==b||_.numPointShadows!==x||_.numSpotShadows!==v||_.numSpotMaps!==M||_.numLightProbes!==N)&&(i.directional.length=f,i.spot.length=y,i.rectArea.length=p,i.point.length=g,i.hemi.length=m,i.directionalShadow.length=b,i.directionalShadowMap.length=b,i.pointShadow.length=x,i.pointShadowMap.length=x,i.spotShadow.length=v,i.spotShadowMap.length=v,i.directionalShadowMatrix.length=b,i.pointShadowMatrix.length=x,i.spotLightMatrix.length=v+M-w,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=w,i.numLightProbes=N,_.directionalLength=f,_.pointLength=g,_.spotLength=y,_.rectAreaLength=p,_.hemiLength=m,_.numDirectionalShadows=b,_.numPointShadows=x,_.numSpotShadows=v,_.numSpotMaps=M,_.numLightProbes=N,i.version=Jx++)}function c(l,u){let h=0,d=0,f=0,g=0,y=0;const p=u.matrixWorldInverse;for(let m=0,b=l.length;m<b;m++){const x=l[m];if(x.isDirectionalLight){const v=i.directional[h];v.direction.setFromMatrixPosition(x.matrixWorld),a.setFromMatrixPosition(x.target.matrixWorld),v.direction.sub(a),v.direction.transformDirection(p),h++}else if(x.isSpotLight){const v=i.spot[f];v.position.setFromMatrixPosition(x.matrixWorld),v.position.applyMatrix4(p),v.direction.setFromMatrixPosition(x.matrixWorld),a.setFromMatrixPosition(x.target.matrixWorld),v.direction.sub(a),v.direction.transformDirection(p),f++}else if(x.isRectAreaLight){const v=i.rectArea[g];v.position.setFromMatrixPosition(x.matrixWorld),v.position.applyMatrix4(p),r.identity(),s.copy(x.matrixWorld),s.premultiply(p),r.extractRotation(s),v.halfWidth.set(x.width*.5,0,0),v.halfHeight.set(0,x.height*.5,0),v.halfWidth.applyMatrix4(r),v.halfHeight.applyMatrix4(r),g++}else if(x.isPointLight){const v=i.point[d];v.position.setFromMatrixPosition(x.matrixWorld),v.position.applyMatrix4(p),d++}else if(x.isHemisphereLight){const v=i.hemi[y];v.direction.setFromMatrixPosition(x.matrixWorld),v.direction.transformDirection(p),y++}}}return{setup:o,setupView:c,state:i}}function dh(n){const e=new $x(n),t=[],i=[],a=[];function s(d){h.camera=d,t.length=0,i.length=0,a.length=0}function r(d){t.push(d)}function o(d){i.push(d)}function c(d){a.push(d)}function l(){e.setup(t)}function u(d){e.setupView(t,d)}const h={lightsArray:t,shadowsArray:i,lightProbeGridArray:a,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:u,pushLight:r,pushShadow:o,pushLightProbeGrid:c}}function Qx(n){let e=new WeakMap;function t(a,s=0){const r=e.get(a);let o;return r===void 0?(o=new dh(n),e.set(a,[o])):s>=r.length?(o=new dh(n),r.push(o)):o=r[s],o}function i(){e=new WeakMap}return{get:t,dispose:i}}const eE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,tE=`uniform sampler2D shadow_pass;
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
}`,nE=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],iE=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],uh=new qe,ls=new U,gc=new U;function aE(n,e,t){let i=new Gp;const a=new we,s=new we,r=new ut,o=new f0,c=new p0,l={},u=t.maxTextureSize,h={[qn]:Qt,[Qt]:qn,[yn]:yn},d=new on({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new we},radius:{value:4}},vertexShader:eE,fragmentShader:tE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;const g=new Kt;g.setAttribute("position",new St(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const y=new An(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xr;let m=this.type;this.render=function(w,N,_){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===Vg&&(Ne("WebGLShadowMap: PCFSoftShadowMap has been deprecated. Using PCFShadowMap instead."),this.type=Xr);const S=n.getRenderTarget(),T=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),C=n.state;C.setBlending(ui),C.buffers.depth.getReversed()===!0?C.buffers.color.setClear(0,0,0,0):C.buffers.color.setClear(1,1,1,1),C.buffers.depth.setTest(!0),C.setScissorTest(!1);const L=m!==this.type;L&&N.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(P=>P.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,P=w.length;F<P;F++){const B=w[F],V=B.shadow;if(V===void 0){Ne("WebGLShadowMap:",B,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;a.copy(V.mapSize);const q=V.getFrameExtents();a.multiply(q),s.copy(V.mapSize),(a.x>u||a.y>u)&&(a.x>u&&(s.x=Math.floor(u/q.x),a.x=s.x*q.x,V.mapSize.x=s.x),a.y>u&&(s.y=Math.floor(u/q.y),a.y=s.y*q.y,V.mapSize.y=s.y));const ee=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=ee,V.map===null||L===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===ys){if(B.isPointLight){Ne("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Dn(a.x,a.y,{format:ia,type:pi,minFilter:Ht,magFilter:Ht,generateMipmaps:!1}),V.map.texture.name=B.name+".shadowMap",V.map.depthTexture=new sa(a.x,a.y,Zn),V.map.depthTexture.name=B.name+".shadowMapDepth",V.map.depthTexture.format=mi,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Wt,V.map.depthTexture.magFilter=Wt}else B.isPointLight?(V.map=new Jp(a.x),V.map.depthTexture=new o0(a.x,On)):(V.map=new Dn(a.x,a.y),V.map.depthTexture=new sa(a.x,a.y,On)),V.map.depthTexture.name=B.name+".shadowMap",V.map.depthTexture.format=mi,this.type===Xr?(V.map.depthTexture.compareFunction=ee?hd:ud,V.map.depthTexture.minFilter=Ht,V.map.depthTexture.magFilter=Ht):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Wt,V.map.depthTexture.magFilter=Wt);V.camera.updateProjectionMatrix()}const le=V.map.isWebGLCubeRenderTarget?6:1;for(let ve=0;ve<le;ve++){if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ve),n.clear();else{ve===0&&(n.setRenderTarget(V.map),n.clear());const ye=V.getViewport(ve);r.set(s.x*ye.x,s.y*ye.y,s.x*ye.z,s.y*ye.w),C.viewport(r)}if(B.isPointLight){const ye=V.camera,Ge=V.matrix,$e=B.distance||ye.far;$e!==ye.far&&(ye.far=$e,ye.updateProjectionMatrix()),ls.setFromMatrixPosition(B.matrixWorld),ye.position.copy(ls),gc.copy(ye.position),gc.add(nE[ve]),ye.up.copy(iE[ve]),ye.lookAt(gc),ye.updateMatrixWorld(),Ge.makeTranslation(-ls.x,-ls.y,-ls.z),uh.multiplyMatrices(ye.projectionMatrix,ye.matrixWorldInverse),V._frustum.setFromProjectionMatrix(uh,ye.coordinateSystem,ye.reversedDepth)}else V.updateMatrices(B);i=V.getFrustum(),v(N,_,V.camera,B,this.type)}V.isPointLightShadow!==!0&&this.type===ys&&b(V,_),V.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(S,T,I)};function b(w,N){const _=e.update(y);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null&&(w.mapPass=new Dn(a.x,a.y,{format:ia,type:pi})),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value=w.mapSize,d.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(N,null,_,d,y,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value=w.mapSize,f.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(N,null,_,f,y,null)}function x(w,N,_,S){let T=null;const I=_.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(I!==void 0)T=I;else if(T=_.isPointLight===!0?c:o,n.localClippingEnabled&&N.clipShadows===!0&&Array.isArray(N.clippingPlanes)&&N.clippingPlanes.length!==0||N.displacementMap&&N.displacementScale!==0||N.alphaMap&&N.alphaTest>0||N.map&&N.alphaTest>0||N.alphaToCoverage===!0){const C=T.uuid,L=N.uuid;let F=l[C];F===void 0&&(F={},l[C]=F);let P=F[L];P===void 0&&(P=T.clone(),F[L]=P,N.addEventListener("dispose",M)),T=P}if(T.visible=N.visible,T.wireframe=N.wireframe,S===ys?T.side=N.shadowSide!==null?N.shadowSide:N.side:T.side=N.shadowSide!==null?N.shadowSide:h[N.side],T.alphaMap=N.alphaMap,T.alphaTest=N.alphaToCoverage===!0?.5:N.alphaTest,T.map=N.map,T.clipShadows=N.clipShadows,T.clippingPlanes=N.clippingPlanes,T.clipIntersection=N.clipIntersection,T.displacementMap=N.displacementMap,T.displacementScale=N.displacementScale,T.displacementBias=N.displacementBias,T.wireframeLinewidth=N.wireframeLinewidth,T.linewidth=N.linewidth,_.isPointLight===!0&&T.isMeshDistanceMaterial===!0){const C=n.properties.get(T);C.light=_}return T}function v(w,N,_,S,T){if(w.visible===!1)return;if(w.layers.test(N.layers)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&T===ys)&&(!w.frustumCulled||i.intersectsObject(w))){w.modelViewMatrix.multiplyMatrices(_.matrixWorldInverse,w.matrixWorld);const L=e.update(w),F=w.material;if(Array.isArray(F)){const P=L.groups;for(let B=0,V=P.length;B<V;B++){const q=P[B],ee=F[q.materialIndex];if(ee&&ee.visible){const le=x(w,ee,S,T);w.onBeforeShadow(n,w,N,_,L,le,q),n.renderBufferDirect(_,null,L,le,w,q),w.onAfterShadow(n,w,N,_,L,le,q)}}}else if(F.visible){const P=x(w,F,S,T);w.onBeforeShadow(n,w,N,_,L,P,null),n.renderBufferDirect(_,null,L,P,w,null),w.onAfterShadow(n,w,N,_,L,P,null)}}const C=w.children;for(let L=0,F=C.length;L<F;L++)v(C[L],N,_,S,T)}function M(w){w.target.removeEventListener("dispose",M);for(const _ in l){const S=l[_],T=w.target.uuid;T in S&&(S[T].dispose(),delete S[T])}}}function sE(n,e){function t(){let D=!1;const ie=new ut;let Y=null;const me=new ut(0,0,0,0);return{setMask:function(re){Y!==re&&!D&&(n.colorMask(re,re,re,re),Y=re)},setLocked:function(re){D=re},setClear:function(re,$,Ee,Oe,_t){_t===!0&&(re*=Oe,$*=Oe,Ee*=Oe),ie.set(re,$,Ee,Oe),me.equals(ie)===!1&&(n.clearColor(re,$,Ee,Oe),me.copy(ie))},reset:function(){D=!1,Y=null,me.set(-1,0,0,0)}}}function i(){let D=!1,ie=!1,Y=null,me=null,re=null;return{setReversed:function($){if(ie!==$){const Ee=e.get("EXT_clip_control");$?Ee.clipControlEXT(Ee.LOWER_LEFT_EXT,Ee.ZERO_TO_ONE_EXT):Ee.clipControlEXT(Ee.LOWER_LEFT_EXT,Ee.NEGATIVE_ONE_TO_ONE_EXT),ie=$;const Oe=re;re=null,this.setClear(Oe)}},getReversed:function(){return ie},setTest:function($){$?ae(n.DEPTH_TEST):Te(n.DEPTH_TEST)},setMask:function($){Y!==$&&!D&&(n.depthMask($),Y=$)},setFunc:function($){if(ie&&($=yb[$]),me!==$){switch($){case Kc:n.depthFunc(n.NEVER);break;case no:n.depthFunc(n.ALWAYS);break;case Jc:n.depthFunc(n.LESS);break;case ta:n.depthFunc(n.LEQUAL);break;case qc:n.depthFunc(n.EQUAL);break;case $c:n.depthFunc(n.GEQUAL);break;case io:n.depthFunc(n.GREATER);break;case Qc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}me=$}},setLocked:function($){D=$},setClear:function($){re!==$&&(re=$,ie&&($=1-$),n.clearDepth($))},reset:function(){D=!1,Y=null,me=null,re=null,ie=!1}}}function a(){let D=!1,ie=null,Y=null,me=null,re=null,$=null,Ee=null,Oe=null,_t=null;return{setTest:function(it){D||(it?ae(n.STENCIL_TEST):Te(n.STENCIL_TEST))},setMask:function(it){ie!==it&&!D&&(n.stencilMask(it),ie=it)},setFunc:function(it,ti,kn){(Y!==it||me!==ti||re!==kn)&&(n.stencilFunc(it,ti,kn),Y=it,me=ti,re=kn)},setOp:function(it,ti,kn){($!==it||Ee!==ti||Oe!==kn)&&(n.stencilOp(it,ti,kn),$=it,Ee=ti,Oe=kn)},setLocked:function(it){D=it},setClear:function(it){_t!==it&&(n.clearStencil(it),_t=it)},reset:function(){D=!1,ie=null,Y=null,me=null,re=null,$=null,Ee=null,Oe=null,_t=null}}}const s=new t,r=new i,o=new a,c=new WeakMap,l=new WeakMap;let u={},h={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,b=null,x=null,v=null,M=null,w=null,N=null,_=new Ze(0,0,0),S=0,T=!1,I=null,C=null,L=null,F=null,P=null;const B=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let V=!1,q=0;const ee=n.getParameter(n.VERSION);ee.indexOf("WebGL")!==-1?(q=parseFloat(/^WebGL (\d)/.exec(ee)[1]),V=q>=1):ee.indexOf("OpenGL ES")!==-1&&(q=parseFloat(/^OpenGL ES (\d)/.exec(ee)[1]),V=q>=2);let le=null,ve={};const ye=n.getParameter(n.SCISSOR_BOX),Ge=n.getParameter(n.VIEWPORT),$e=new ut().fromArray(ye),Re=new ut().fromArray(Ge);function J(D,ie,Y,me){const re=new Uint8Array(4),$=n.createTexture();n.bindTexture(D,$),n.texParameteri(D,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(D,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ee=0;Ee<Y;Ee++)D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY?n.texImage3D(ie,0,n.RGBA,1,1,me,0,n.RGBA,n.UNSIGNED_BYTE,re):n.texImage2D(ie+Ee,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,re);return $}const ue={};ue[n.TEXTURE_2D]=J(n.TEXTURE_2D,n.TEXTURE_2D,1),ue[n.TEXTURE_CUBE_MAP]=J(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),ue[n.TEXTURE_2D_ARRAY]=J(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),ue[n.TEXTURE_3D]=J(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),r.setClear(1),o.setClear(0),ae(n.DEPTH_TEST),r.setFunc(ta),Tt(!1),pt(lu),ae(n.CULL_FACE),ht(ui);function ae(D){u[D]!==!0&&(n.enable(D),u[D]=!0)}function Te(D){u[D]!==!1&&(n.disable(D),u[D]=!1)}function Ce(D,ie){return d[D]!==ie?(n.bindFramebuffer(D,ie),d[D]=ie,D===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=ie),D===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=ie),!0):!1}function Ie(D,ie){let Y=g,me=!1;if(D){Y=f.get(ie),Y===void 0&&(Y=[],f.set(ie,Y));const re=D.textures;if(Y.length!==re.length||Y[0]!==n.COLOR_ATTACHMENT0){for(let $=0,Ee=re.length;$<Ee;$++)Y[$]=n.COLOR_ATTACHMENT0+$;Y.length=re.length,me=!0}}else Y[0]!==n.BACK&&(Y[0]=n.BACK,me=!0);me&&n.drawBuffers(Y)}function rt(D){return y!==D?(n.useProgram(D),y=D,!0):!1}const We={[Zi]:n.FUNC_ADD,[Gg]:n.FUNC_SUBTRACT,[Wg]:n.FUNC_REVERSE_SUBTRACT};We[Hg]=n.MIN,We[jg]=n.MAX;const nt={[Xg]:n.ZERO,[Yg]:n.ONE,[Zg]:n.SRC_COLOR,[Yc]:n.SRC_ALPHA,[eb]:n.SRC_ALPHA_SATURATE,[$g]:n.DST_COLOR,[Jg]:n.DST_ALPHA,[Kg]:n.ONE_MINUS_SRC_COLOR,[Zc]:n.ONE_MINUS_SRC_ALPHA,[Qg]:n.ONE_MINUS_DST_COLOR,[qg]:n.ONE_MINUS_DST_ALPHA,[tb]:n.CONSTANT_COLOR,[nb]:n.ONE_MINUS_CONSTANT_COLOR,[ib]:n.CONSTANT_ALPHA,[ab]:n.ONE_MINUS_CONSTANT_ALPHA};function ht(D,ie,Y,me,re,$,Ee,Oe,_t,it){if(D===ui){p===!0&&(Te(n.BLEND),p=!1);return}if(p===!1&&(ae(n.BLEND),p=!0),D!==zg){if(D!==m||it!==T){if((b!==Zi||M!==Zi)&&(n.blendEquation(n.FUNC_ADD),b=Zi,M=Zi),it)switch(D){case za:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case du:n.blendFunc(n.ONE,n.ONE);break;case uu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case hu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Xe("WebGLState: Invalid blending: ",D);break}else switch(D){case za:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case du:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case uu:Xe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hu:Xe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Xe("WebGLState: Invalid blending: ",D);break}x=null,v=null,w=null,N=null,_.set(0,0,0),S=0,m=D,T=it}return}re=re||ie,$=$||Y,Ee=Ee||me,(ie!==b||re!==M)&&(n.blendEquationSeparate(We[ie],We[re]),b=ie,M=re),(Y!==x||me!==v||$!==w||Ee!==N)&&(n.blendFuncSeparate(nt[Y],nt[me],nt[$],nt[Ee]),x=Y,v=me,w=$,N=Ee),(Oe.equals(_)===!1||_t!==S)&&(n.blendColor(Oe.r,Oe.g,Oe.b,_t),_.copy(Oe),S=_t),m=D,T=!1}function ze(D,ie){D.side===yn?Te(n.CULL_FACE):ae(n.CULL_FACE);let Y=D.side===Qt;ie&&(Y=!Y),Tt(Y),D.blending===za&&D.transparent===!1?ht(ui):ht(D.blending,D.blendEquation,D.blendSrc,D.blendDst,D.blendEquationAlpha,D.blendSrcAlpha,D.blendDstAlpha,D.blendColor,D.blendAlpha,D.premultipliedAlpha),r.setFunc(D.depthFunc),r.setTest(D.depthTest),r.setMask(D.depthWrite),s.setMask(D.colorWrite);const me=D.stencilWrite;o.setTest(me),me&&(o.setMask(D.stencilWriteMask),o.setFunc(D.stencilFunc,D.stencilRef,D.stencilFuncMask),o.setOp(D.stencilFail,D.stencilZFail,D.stencilZPass)),O(D.polygonOffset,D.polygonOffsetFactor,D.polygonOffsetUnits),D.alphaToCoverage===!0?ae(n.SAMPLE_ALPHA_TO_COVERAGE):Te(n.SAMPLE_ALPHA_TO_COVERAGE)}function Tt(D){I!==D&&(D?n.frontFace(n.CW):n.frontFace(n.CCW),I=D)}function pt(D){D!==kg?(ae(n.CULL_FACE),D!==C&&(D===lu?n.cullFace(n.BACK):D===Bg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Te(n.CULL_FACE),C=D}function cn(D){D!==L&&(V&&n.lineWidth(D),L=D)}function O(D,ie,Y){D?(ae(n.POLYGON_OFFSET_FILL),(F!==ie||P!==Y)&&(F=ie,P=Y,r.getReversed()&&(ie=-ie),n.polygonOffset(ie,Y))):Te(n.POLYGON_OFFSET_FILL)}function It(D){D?ae(n.SCISSOR_TEST):Te(n.SCISSOR_TEST)}function He(D){D===void 0&&(D=n.TEXTURE0+B-1),le!==D&&(n.activeTexture(D),le=D)}function lt(D,ie,Y){Y===void 0&&(le===null?Y=n.TEXTURE0+B-1:Y=le);let me=ve[Y];me===void 0&&(me={type:void 0,texture:void 0},ve[Y]=me),(me.type!==D||me.texture!==ie)&&(le!==Y&&(n.activeTexture(Y),le=Y),n.bindTexture(D,ie||ue[D]),me.type=D,me.texture=ie)}function de(){const D=ve[le];D!==void 0&&D.type!==void 0&&(n.bindTexture(D.type,null),D.type=void 0,D.texture=void 0)}function mt(){try{n.compressedTexImage2D(...arguments)}catch(D){Xe("WebGLState:",D)}}function R(){try{n.compressedTexImage3D(...arguments)}catch(D){Xe("WebGLState:",D)}}function E(){try{n.texSubImage2D(...arguments)}catch(D){Xe("WebGLState:",D)}}function G(){try{n.texSubImage3D(...arguments)}catch(D){Xe("WebGLState:",D)}}function Z(){try{n.compressedTexSubImage2D(...arguments)}catch(D){Xe("WebGLState:",D)}}function Q(){try{n.compressedTexSubImage3D(...arguments)}catch(D){Xe("WebGLState:",D)}}function te(){try{n.texStorage2D(...arguments)}catch(D){Xe("WebGLState:",D)}}function oe(){try{n.texStorage3D(...arguments)}catch(D){Xe("WebGLState:",D)}}function X(){try{n.texImage2D(...arguments)}catch(D){Xe("WebGLState:",D)}}function K(){try{n.texImage3D(...arguments)}catch(D){Xe("WebGLState:",D)}}function pe(D){return h[D]!==void 0?h[D]:n.getParameter(D)}function be(D,ie){h[D]!==ie&&(n.pixelStorei(D,ie),h[D]=ie)}function se(D){$e.equals(D)===!1&&(n.scissor(D.x,D.y,D.z,D.w),$e.copy(D))}function ne(D){Re.equals(D)===!1&&(n.viewport(D.x,D.y,D.z,D.w),Re.copy(D))}function Ue(D,ie){let Y=l.get(ie);Y===void 0&&(Y=new WeakMap,l.set(ie,Y));let me=Y.get(D);me===void 0&&(me=n.getUniformBlockIndex(ie,D.name),Y.set(D,me))}function ke(D,ie){const me=l.get(ie).get(D);c.get(ie)!==me&&(n.uniformBlockBinding(ie,me,D.__bindingPointIndex),c.set(ie,me))}function Ke(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),r.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},le=null,ve={},d={},f=new WeakMap,g=[],y=null,p=!1,m=null,b=null,x=null,v=null,M=null,w=null,N=null,_=new Ze(0,0,0),S=0,T=!1,I=null,C=null,L=null,F=null,P=null,$e.set(0,0,n.canvas.width,n.canvas.height),Re.set(0,0,n.canvas.width,n.canvas.height),s.reset(),r.reset(),o.reset()}return{buffers:{color:s,depth:r,stencil:o},enable:ae,disable:Te,bindFramebuffer:Ce,drawBuffers:Ie,useProgram:rt,setBlending:ht,setMaterial:ze,setFlipSided:Tt,setCullFace:pt,setLineWidth:cn,setPolygonOffset:O,setScissorTest:It,activeTexture:He,bindTexture:lt,unbindTexture:de,compressedTexImage2D:mt,compressedTexImage3D:R,texImage2D:X,texImage3D:K,pixelStorei:be,getParameter:pe,updateUBOMapping:Ue,uniformBlockBinding:ke,texStorage2D:te,texStorage3D:oe,texSubImage2D:E,texSubImage3D:G,compressedTexSubImage2D:Z,compressedTexSubImage3D:Q,scissor:se,viewport:ne,reset:Ke}}function rE(n,e,t,i,a,s,r){const o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new we,u=new WeakMap,h=new Set;let d;const f=new WeakMap;let g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function y(R,E){return g?new OffscreenCanvas(R,E):co("canvas")}function p(R,E,G){let Z=1;const Q=mt(R);if((Q.width>G||Q.height>G)&&(Z=G/Math.max(Q.width,Q.height)),Z<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){const te=Math.floor(Z*Q.width),oe=Math.floor(Z*Q.height);d===void 0&&(d=y(te,oe));const X=E?y(te,oe):d;return X.width=te,X.height=oe,X.getContext("2d").drawImage(R,0,0,te,oe),Ne("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+te+"x"+oe+")."),X}else return"data"in R&&Ne("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),R;return R}function m(R){return R.generateMipmaps}function b(R){n.generateMipmap(R)}function x(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function v(R,E,G,Z,Q,te=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ne("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let oe;Z&&(oe=e.get("EXT_texture_norm16"),oe||Ne("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let X=E;if(E===n.RED&&(G===n.FLOAT&&(X=n.R32F),G===n.HALF_FLOAT&&(X=n.R16F),G===n.UNSIGNED_BYTE&&(X=n.R8),G===n.UNSIGNED_SHORT&&oe&&(X=oe.R16_EXT),G===n.SHORT&&oe&&(X=oe.R16_SNORM_EXT)),E===n.RED_INTEGER&&(G===n.UNSIGNED_BYTE&&(X=n.R8UI),G===n.UNSIGNED_SHORT&&(X=n.R16UI),G===n.UNSIGNED_INT&&(X=n.R32UI),G===n.BYTE&&(X=n.R8I),G===n.SHORT&&(X=n.R16I),G===n.INT&&(X=n.R32I)),E===n.RG&&(G===n.FLOAT&&(X=n.RG32F),G===n.HALF_FLOAT&&(X=n.RG16F),G===n.UNSIGNED_BYTE&&(X=n.RG8),G===n.UNSIGNED_SHORT&&oe&&(X=oe.RG16_EXT),G===n.SHORT&&oe&&(X=oe.RG16_SNORM_EXT)),E===n.RG_INTEGER&&(G===n.UNSIGNED_BYTE&&(X=n.RG8UI),G===n.UNSIGNED_SHORT&&(X=n.RG16UI),G===n.UNSIGNED_INT&&(X=n.RG32UI),G===n.BYTE&&(X=n.RG8I),G===n.SHORT&&(X=n.RG16I),G===n.INT&&(X=n.RG32I)),E===n.RGB_INTEGER&&(G===n.UNSIGNED_BYTE&&(X=n.RGB8UI),G===n.UNSIGNED_SHORT&&(X=n.RGB16UI),G===n.UNSIGNED_INT&&(X=n.RGB32UI),G===n.BYTE&&(X=n.RGB8I),G===n.SHORT&&(X=n.RGB16I),G===n.INT&&(X=n.RGB32I)),E===n.RGBA_INTEGER&&(G===n.UNSIGNED_BYTE&&(X=n.RGBA8UI),G===n.UNSIGNED_SHORT&&(X=n.RGBA16UI),G===n.UNSIGNED_INT&&(X=n.RGBA32UI),G===n.BYTE&&(X=n.RGBA8I),G===n.SHORT&&(X=n.RGBA16I),G===n.INT&&(X=n.RGBA32I)),E===n.RGB&&(G===n.UNSIGNED_SHORT&&oe&&(X=oe.RGB16_EXT),G===n.SHORT&&oe&&(X=oe.RGB16_SNORM_EXT),G===n.UNSIGNED_INT_5_9_9_9_REV&&(X=n.RGB9_E5),G===n.UNSIGNED_INT_10F_11F_11F_REV&&(X=n.R11F_G11F_B10F)),E===n.RGBA){const K=te?ro:je.getTransfer(Q);G===n.FLOAT&&(X=n.RGBA32F),G===n.HALF_FLOAT&&(X=n.RGBA16F),G===n.UNSIGNED_BYTE&&(X=K===Qe?n.SRGB8_ALPHA8:n.RGBA8),G===n.UNSIGNED_SHORT&&oe&&(X=oe.RGBA16_EXT),G===n.SHORT&&oe&&(X=oe.RGBA16_SNORM_EXT),G===n.UNSIGNED_SHORT_4_4_4_4&&(X=n.RGBA4),G===n.UNSIGNED_SHORT_5_5_5_1&&(X=n.RGB5_A1)}return(X===n.R16F||X===n.R32F||X===n.RG16F||X===n.RG32F||X===n.RGBA16F||X===n.RGBA32F)&&e.get("EXT_color_buffer_float"),X}function M(R,E){let G;return R?E===null||E===On||E===Cs?G=n.DEPTH24_STENCIL8:E===Zn?G=n.DEPTH32F_STENCIL8:E===Rs&&(G=n.DEPTH24_STENCIL8,Ne("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===On||E===Cs?G=n.DEPTH_COMPONENT24:E===Zn?G=n.DEPTH_COMPONENT32F:E===Rs&&(G=n.DEPTH_COMPONENT16),G}function w(R,E){return m(R)===!0||R.isFramebufferTexture&&R.minFilter!==Wt&&R.minFilter!==Ht?Math.log2(Math.max(E.width,E.height))+1:R.mipmaps!==void 0&&R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?E.mipmaps.length:1}function N(R){const E=R.target;E.removeEventListener("dispose",N),S(E),E.isVideoTexture&&u.delete(E),E.isHTMLTexture&&h.delete(E)}function _(R){const E=R.target;E.removeEventListener("dispose",_),I(E)}function S(R){const E=i.get(R);if(E.__webglInit===void 0)return;const G=R.source,Z=f.get(G);if(Z){const Q=Z[E.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&T(R),Object.keys(Z).length===0&&f.delete(G)}i.remove(R)}function T(R){const E=i.get(R);n.deleteTexture(E.__webglTexture);const G=R.source,Z=f.get(G);delete Z[E.__cacheKey],r.memory.textures--}function I(R){const E=i.get(R);if(R.depthTexture&&(R.depthTexture.dispose(),i.remove(R.depthTexture)),R.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(E.__webglFramebuffer[Z]))for(let Q=0;Q<E.__webglFramebuffer[Z].length;Q++)n.deleteFramebuffer(E.__webglFramebuffer[Z][Q]);else n.deleteFramebuffer(E.__webglFramebuffer[Z]);E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer[Z])}else{if(Array.isArray(E.__webglFramebuffer))for(let Z=0;Z<E.__webglFramebuffer.length;Z++)n.deleteFramebuffer(E.__webglFramebuffer[Z]);else n.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&n.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&n.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let Z=0;Z<E.__webglColorRenderbuffer.length;Z++)E.__webglColorRenderbuffer[Z]&&n.deleteRenderbuffer(E.__webglColorRenderbuffer[Z]);E.__webglDepthRenderbuffer&&n.deleteRenderbuffer(E.__webglDepthRenderbuffer)}const G=R.textures;for(let Z=0,Q=G.length;Z<Q;Z++){const te=i.get(G[Z]);te.__webglTexture&&(n.deleteTexture(te.__webglTexture),r.memory.textures--),i.remove(G[Z])}i.remove(R)}let C=0;function L(){C=0}function F(){return C}function P(R){C=R}function B(){const R=C;return R>=a.maxTextures&&Ne("WebGLTextures: Trying to use "+R+" texture units while this GPU supports only "+a.maxTextures),C+=1,R}function V(R){const E=[];return E.push(R.wrapS),E.push(R.wrapT),E.push(R.wrapR||0),E.push(R.magFilter),E.push(R.minFilter),E.push(R.anisotropy),E.push(R.internalFormat),E.push(R.format),E.push(R.type),E.push(R.generateMipmaps),E.push(R.premultiplyAlpha),E.push(R.flipY),E.push(R.unpackAlignment),E.push(R.colorSpace),E.join()}function q(R,E){const G=i.get(R);if(R.isVideoTexture&&lt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&G.__version!==R.version){const Z=R.image;if(Z===null)Ne("WebGLRenderer: Texture marked for update but no image data found.");else if(Z.complete===!1)Ne("WebGLRenderer: Texture marked for update but image is incomplete");else{Te(G,R,E);return}}else R.isExternalTexture&&(G.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,G.__webglTexture,n.TEXTURE0+E)}function ee(R,E){const G=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&G.__version!==R.version){Te(G,R,E);return}else R.isExternalTexture&&(G.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,G.__webglTexture,n.TEXTURE0+E)}function le(R,E){const G=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&G.__version!==R.version){Te(G,R,E);return}t.bindTexture(n.TEXTURE_3D,G.__webglTexture,n.TEXTURE0+E)}function ve(R,E){const G=i.get(R);if(R.isCubeDepthTexture!==!0&&R.version>0&&G.__version!==R.version){Ce(G,R,E);return}t.bindTexture(n.TEXTURE_CUBE_MAP,G.__webglTexture,n.TEXTURE0+E)}const ye={[el]:n.REPEAT,[li]:n.CLAMP_TO_EDGE,[tl]:n.MIRRORED_REPEAT},Ge={[Wt]:n.NEAREST,[ob]:n.NEAREST_MIPMAP_NEAREST,[qs]:n.NEAREST_MIPMAP_LINEAR,[Ht]:n.LINEAR,[Vo]:n.LINEAR_MIPMAP_NEAREST,[Ji]:n.LINEAR_MIPMAP_LINEAR},$e={[db]:n.NEVER,[mb]:n.ALWAYS,[ub]:n.LESS,[ud]:n.LEQUAL,[hb]:n.EQUAL,[hd]:n.GEQUAL,[fb]:n.GREATER,[pb]:n.NOTEQUAL};function Re(R,E){if(E.type===Zn&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===Ht||E.magFilter===Vo||E.magFilter===qs||E.magFilter===Ji||E.minFilter===Ht||E.minFilter===Vo||E.minFilter===qs||E.minFilter===Ji)&&Ne("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,ye[E.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,ye[E.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,ye[E.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,Ge[E.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,Ge[E.minFilter]),E.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,$e[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Wt||E.minFilter!==qs&&E.minFilter!==Ji||E.type===Zn&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||i.get(E).__currentAnisotropy){const G=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,a.getMaxAnisotropy())),i.get(E).__currentAnisotropy=E.anisotropy}}}function J(R,E){let G=!1;R.__webglInit===void 0&&(R.__webglInit=!0,E.addEventListener("dispose",N));const Z=E.source;let Q=f.get(Z);Q===void 0&&(Q={},f.set(Z,Q));const te=V(E);if(te!==R.__cacheKey){Q[te]===void 0&&(Q[te]={texture:n.createTexture(),usedTimes:0},r.memory.textures++,G=!0),Q[te].usedTimes++;const oe=Q[R.__cacheKey];oe!==void 0&&(Q[R.__cacheKey].usedTimes--,oe.usedTimes===0&&T(E)),R.__cacheKey=te,R.__webglTexture=Q[te].texture}return G}function ue(R,E,G){return Math.floor(Math.floor(R/G)/E)}function ae(R,E,G,Z){const te=R.updateRanges;if(te.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,E.width,E.height,G,Z,E.data);else{te.sort((be,se)=>be.start-se.start);let oe=0;for(let be=1;be<te.length;be++){const se=te[oe],ne=te[be],Ue=se.start+se.count,ke=ue(ne.start,E.width,4),Ke=ue(se.start,E.width,4);ne.start<=Ue+1&&ke===Ke&&ue(ne.start+ne.count-1,E.width,4)===ke?se.count=Math.max(se.count,ne.start+ne.count-se.start):(++oe,te[oe]=ne)}te.length=oe+1;const X=t.getParameter(n.UNPACK_ROW_LENGTH),K=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,E.width);for(let be=0,se=te.length;be<se;be++){const ne=te[be],Ue=Math.floor(ne.start/4),ke=Math.ceil(ne.count/4),Ke=Ue%E.width,D=Math.floor(Ue/E.width),ie=ke,Y=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Ke),t.pixelStorei(n.UNPACK_SKIP_ROWS,D),t.texSubImage2D(n.TEXTURE_2D,0,Ke,D,ie,Y,G,Z,E.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,X),t.pixelStorei(n.UNPACK_SKIP_PIXELS,K),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Te(R,E,G){let Z=n.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(Z=n.TEXTURE_2D_ARRAY),E.isData3DTexture&&(Z=n.TEXTURE_3D);const Q=J(R,E),te=E.source;t.bindTexture(Z,R.__webglTexture,n.TEXTURE0+G);const oe=i.get(te);if(te.version!==oe.__version||Q===!0){if(t.activeTexture(n.TEXTURE0+G),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){const Y=je.getPrimaries(je.workingColorSpace),me=E.colorSpace===Ci?null:je.getPrimaries(E.colorSpace),re=E.colorSpace===Ci||Y===me?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re)}t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment);let K=p(E.image,!1,a.maxTextureSize);K=de(E,K);const pe=s.convert(E.format,E.colorSpace),be=s.convert(E.type);let se=v(E.internalFormat,pe,be,E.normalized,E.colorSpace,E.isVideoTexture);Re(Z,E);let ne;const Ue=E.mipmaps,ke=E.isVideoTexture!==!0,Ke=oe.__version===void 0||Q===!0,D=te.dataReady,ie=w(E,K);if(E.isDepthTexture)se=M(E.format===qi,E.type),Ke&&(ke?t.texStorage2D(n.TEXTURE_2D,1,se,K.width,K.height):t.texImage2D(n.TEXTURE_2D,0,se,K.width,K.height,0,pe,be,null));else if(E.isDataTexture)if(Ue.length>0){ke&&Ke&&t.texStorage2D(n.TEXTURE_2D,ie,se,Ue[0].width,Ue[0].height);for(let Y=0,me=Ue.length;Y<me;Y++)ne=Ue[Y],ke?D&&t.texSubImage2D(n.TEXTURE_2D,Y,0,0,ne.width,ne.height,pe,be,ne.data):t.texImage2D(n.TEXTURE_2D,Y,se,ne.width,ne.height,0,pe,be,ne.data);E.generateMipmaps=!1}else ke?(Ke&&t.texStorage2D(n.TEXTURE_2D,ie,se,K.width,K.height),D&&ae(E,K,pe,be)):t.texImage2D(n.TEXTURE_2D,0,se,K.width,K.height,0,pe,be,K.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){ke&&Ke&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ie,se,Ue[0].width,Ue[0].height,K.depth);for(let Y=0,me=Ue.length;Y<me;Y++)if(ne=Ue[Y],E.format!==En)if(pe!==null)if(ke){if(D)if(E.layerUpdates.size>0){const re=Gu(ne.width,ne.height,E.format,E.type);for(const $ of E.layerUpdates){const Ee=ne.data.subarray($*re/ne.data.BYTES_PER_ELEMENT,($+1)*re/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Y,0,0,$,ne.width,ne.height,1,pe,Ee)}E.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Y,0,0,0,ne.width,ne.height,K.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,Y,se,ne.width,ne.height,K.depth,0,ne.data,0,0);else Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ke?D&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,Y,0,0,0,ne.width,ne.height,K.depth,pe,be,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,Y,se,ne.width,ne.height,K.depth,0,pe,be,ne.data)}else{ke&&Ke&&t.texStorage2D(n.TEXTURE_2D,ie,se,Ue[0].width,Ue[0].height);for(let Y=0,me=Ue.length;Y<me;Y++)ne=Ue[Y],E.format!==En?pe!==null?ke?D&&t.compressedTexSubImage2D(n.TEXTURE_2D,Y,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,Y,se,ne.width,ne.height,0,ne.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ke?D&&t.texSubImage2D(n.TEXTURE_2D,Y,0,0,ne.width,ne.height,pe,be,ne.data):t.texImage2D(n.TEXTURE_2D,Y,se,ne.width,ne.height,0,pe,be,ne.data)}else if(E.isDataArrayTexture)if(ke){if(Ke&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ie,se,K.width,K.height,K.depth),D)if(E.layerUpdates.size>0){const Y=Gu(K.width,K.height,E.format,E.type);for(const me of E.layerUpdates){const re=K.data.subarray(me*Y/K.data.BYTES_PER_ELEMENT,(me+1)*Y/K.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,me,K.width,K.height,1,pe,be,re)}E.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,K.width,K.height,K.depth,pe,be,K.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,K.width,K.height,K.depth,0,pe,be,K.data);else if(E.isData3DTexture)ke?(Ke&&t.texStorage3D(n.TEXTURE_3D,ie,se,K.width,K.height,K.depth),D&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,K.width,K.height,K.depth,pe,be,K.data)):t.texImage3D(n.TEXTURE_3D,0,se,K.width,K.height,K.depth,0,pe,be,K.data);else if(E.isFramebufferTexture){if(Ke)if(ke)t.texStorage2D(n.TEXTURE_2D,ie,se,K.width,K.height);else{let Y=K.width,me=K.height;for(let re=0;re<ie;re++)t.texImage2D(n.TEXTURE_2D,re,se,Y,me,0,pe,be,null),Y>>=1,me>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in n){const Y=n.canvas;if(Y.hasAttribute("layoutsubtree")||Y.setAttribute("layoutsubtree","true"),K.parentNode!==Y){Y.appendChild(K),h.add(E),Y.onpaint=Oe=>{const _t=Oe.changedElements;for(const it of h)_t.includes(it.image)&&(it.needsUpdate=!0)},Y.requestPaint();return}const me=0,re=n.RGBA,$=n.RGBA,Ee=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,me,re,$,Ee,K),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ue.length>0){if(ke&&Ke){const Y=mt(Ue[0]);t.texStorage2D(n.TEXTURE_2D,ie,se,Y.width,Y.height)}for(let Y=0,me=Ue.length;Y<me;Y++)ne=Ue[Y],ke?D&&t.texSubImage2D(n.TEXTURE_2D,Y,0,0,pe,be,ne):t.texImage2D(n.TEXTURE_2D,Y,se,pe,be,ne);E.generateMipmaps=!1}else if(ke){if(Ke){const Y=mt(K);t.texStorage2D(n.TEXTURE_2D,ie,se,Y.width,Y.height)}D&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,be,K)}else t.texImage2D(n.TEXTURE_2D,0,se,pe,be,K);m(E)&&b(Z),oe.__version=te.version,E.onUpdate&&E.onUpdate(E)}R.__version=E.version}function Ce(R,E,G){if(E.image.length!==6)return;const Z=J(R,E),Q=E.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+G);const te=i.get(Q);if(Q.version!==te.__version||Z===!0){t.activeTexture(n.TEXTURE0+G);const oe=je.getPrimaries(je.workingColorSpace),X=E.colorSpace===Ci?null:je.getPrimaries(E.colorSpace),K=E.colorSpace===Ci||oe===X?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,K);const pe=E.isCompressedTexture||E.image[0].isCompressedTexture,be=E.image[0]&&E.image[0].isDataTexture,se=[];for(let $=0;$<6;$++)!pe&&!be?se[$]=p(E.image[$],!0,a.maxCubemapSize):se[$]=be?E.image[$].image:E.image[$],se[$]=de(E,se[$]);const ne=se[0],Ue=s.convert(E.format,E.colorSpace),ke=s.convert(E.type),Ke=v(E.internalFormat,Ue,ke,E.normalized,E.colorSpace),D=E.isVideoTexture!==!0,ie=te.__version===void 0||Z===!0,Y=Q.dataReady;let me=w(E,ne);Re(n.TEXTURE_CUBE_MAP,E);let re;if(pe){D&&ie&&t.texStorage2D(n.TEXTURE_CUBE_MAP,me,Ke,ne.width,ne.height);for(let $=0;$<6;$++){re=se[$].mipmaps;for(let Ee=0;Ee<re.length;Ee++){const Oe=re[Ee];E.format!==En?Ue!==null?D?Y&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee,0,0,Oe.width,Oe.height,Ue,Oe.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee,Ke,Oe.width,Oe.height,0,Oe.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee,0,0,Oe.width,Oe.height,Ue,ke,Oe.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee,Ke,Oe.width,Oe.height,0,Ue,ke,Oe.data)}}}else{if(re=E.mipmaps,D&&ie){re.length>0&&me++;const $=mt(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,me,Ke,$.width,$.height)}for(let $=0;$<6;$++)if(be){D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,0,0,0,se[$].width,se[$].height,Ue,ke,se[$].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,0,Ke,se[$].width,se[$].height,0,Ue,ke,se[$].data);for(let Ee=0;Ee<re.length;Ee++){const _t=re[Ee].image[$].image;D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee+1,0,0,_t.width,_t.height,Ue,ke,_t.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee+1,Ke,_t.width,_t.height,0,Ue,ke,_t.data)}}else{D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,0,0,0,Ue,ke,se[$]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,0,Ke,Ue,ke,se[$]);for(let Ee=0;Ee<re.length;Ee++){const Oe=re[Ee];D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee+1,0,0,Ue,ke,Oe.image[$]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+$,Ee+1,Ke,Ue,ke,Oe.image[$])}}}m(E)&&b(n.TEXTURE_CUBE_MAP),te.__version=Q.version,E.onUpdate&&E.onUpdate(E)}R.__version=E.version}function Ie(R,E,G,Z,Q,te){const oe=s.convert(G.format,G.colorSpace),X=s.convert(G.type),K=v(G.internalFormat,oe,X,G.normalized,G.colorSpace),pe=i.get(E),be=i.get(G);if(be.__renderTarget=E,!pe.__hasExternalTextures){const se=Math.max(1,E.width>>te),ne=Math.max(1,E.height>>te);Q===n.TEXTURE_3D||Q===n.TEXTURE_2D_ARRAY?t.texImage3D(Q,te,K,se,ne,E.depth,0,oe,X,null):t.texImage2D(Q,te,K,se,ne,0,oe,X,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),He(E)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,Z,Q,be.__webglTexture,0,It(E)):(Q===n.TEXTURE_2D||Q>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,Z,Q,be.__webglTexture,te),t.bindFramebuffer(n.FRAMEBUFFER,null)}function rt(R,E,G){if(n.bindRenderbuffer(n.RENDERBUFFER,R),E.depthBuffer){const Z=E.depthTexture,Q=Z&&Z.isDepthTexture?Z.type:null,te=M(E.stencilBuffer,Q),oe=E.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;He(E)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,It(E),te,E.width,E.height):G?n.renderbufferStorageMultisample(n.RENDERBUFFER,It(E),te,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,te,E.width,E.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,R)}else{const Z=E.textures;for(let Q=0;Q<Z.length;Q++){const te=Z[Q],oe=s.convert(te.format,te.colorSpace),X=s.convert(te.type),K=v(te.internalFormat,oe,X,te.normalized,te.colorSpace);He(E)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,It(E),K,E.width,E.height):G?n.renderbufferStorageMultisample(n.RENDERBUFFER,It(E),K,E.width,E.height):n.renderbufferStorage(n.RENDERBUFFER,K,E.width,E.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function We(R,E,G){const Z=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const Q=i.get(E.depthTexture);if(Q.__renderTarget=E,(!Q.__webglTexture||E.depthTexture.image.width!==E.width||E.depthTexture.image.height!==E.height)&&(E.depthTexture.image.width=E.width,E.depthTexture.image.height=E.height,E.depthTexture.needsUpdate=!0),Z){if(Q.__webglInit===void 0&&(Q.__webglInit=!0,E.depthTexture.addEventListener("dispose",N)),Q.__webglTexture===void 0){Q.__webglTexture=n.createTexture(),t.bindTexture(n.TEXTURE_CUBE_MAP,Q.__webglTexture),Re(n.TEXTURE_CUBE_MAP,E.depthTexture);const pe=s.convert(E.depthTexture.format),be=s.convert(E.depthTexture.type);let se;E.depthTexture.format===mi?se=n.DEPTH_COMPONENT24:E.depthTexture.format===qi&&(se=n.DEPTH24_STENCIL8);for(let ne=0;ne<6;ne++)n.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0,se,E.width,E.height,0,pe,be,null)}}else q(E.depthTexture,0);const te=Q.__webglTexture,oe=It(E),X=Z?n.TEXTURE_CUBE_MAP_POSITIVE_X+G:n.TEXTURE_2D,K=E.depthTexture.format===qi?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(E.depthTexture.format===mi)He(E)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,K,X,te,0,oe):n.framebufferTexture2D(n.FRAMEBUFFER,K,X,te,0);else if(E.depthTexture.format===qi)He(E)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,K,X,te,0,oe):n.framebufferTexture2D(n.FRAMEBUFFER,K,X,te,0);else throw new Error("Unknown depthTexture format")}function nt(R){const E=i.get(R),G=R.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==R.depthTexture){const Z=R.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),Z){const Q=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,Z.removeEventListener("dispose",Q)};Z.addEventListener("dispose",Q),E.__depthDisposeCallback=Q}E.__boundDepthTexture=Z}if(R.depthTexture&&!E.__autoAllocateDepthBuffer)if(G)for(let Z=0;Z<6;Z++)We(E.__webglFramebuffer[Z],R,Z);else{const Z=R.texture.mipmaps;Z&&Z.length>0?We(E.__webglFramebuffer[0],R,0):We(E.__webglFramebuffer,R,0)}else if(G){E.__webglDepthbuffer=[];for(let Z=0;Z<6;Z++)if(t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[Z]),E.__webglDepthbuffer[Z]===void 0)E.__webglDepthbuffer[Z]=n.createRenderbuffer(),rt(E.__webglDepthbuffer[Z],R,!1);else{const Q=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=E.__webglDepthbuffer[Z];n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,te)}}else{const Z=R.texture.mipmaps;if(Z&&Z.length>0?t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=n.createRenderbuffer(),rt(E.__webglDepthbuffer,R,!1);else{const Q=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=E.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,te)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ht(R,E,G){const Z=i.get(R);E!==void 0&&Ie(Z.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),G!==void 0&&nt(R)}function ze(R){const E=R.texture,G=i.get(R),Z=i.get(E);R.addEventListener("dispose",_);const Q=R.textures,te=R.isWebGLCubeRenderTarget===!0,oe=Q.length>1;if(oe||(Z.__webglTexture===void 0&&(Z.__webglTexture=n.createTexture()),Z.__version=E.version,r.memory.textures++),te){G.__webglFramebuffer=[];for(let X=0;X<6;X++)if(E.mipmaps&&E.mipmaps.length>0){G.__webglFramebuffer[X]=[];for(let K=0;K<E.mipmaps.length;K++)G.__webglFramebuffer[X][K]=n.createFramebuffer()}else G.__webglFramebuffer[X]=n.createFramebuffer()}else{if(E.mipmaps&&E.mipmaps.length>0){G.__webglFramebuffer=[];for(let X=0;X<E.mipmaps.length;X++)G.__webglFramebuffer[X]=n.createFramebuffer()}else G.__webglFramebuffer=n.createFramebuffer();if(oe)for(let X=0,K=Q.length;X<K;X++){const pe=i.get(Q[X]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),r.memory.textures++)}if(R.samples>0&&He(R)===!1){G.__webglMultisampledFramebuffer=n.createFramebuffer(),G.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let X=0;X<Q.length;X++){const K=Q[X];G.__webglColorRenderbuffer[X]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,G.__webglColorRenderbuffer[X]);const pe=s.convert(K.format,K.colorSpace),be=s.convert(K.type),se=v(K.internalFormat,pe,be,K.normalized,K.colorSpace,R.isXRRenderTarget===!0),ne=It(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,se,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+X,n.RENDERBUFFER,G.__webglColorRenderbuffer[X])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(G.__webglDepthRenderbuffer=n.createRenderbuffer(),rt(G.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(te){t.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture),Re(n.TEXTURE_CUBE_MAP,E);for(let X=0;X<6;X++)if(E.mipmaps&&E.mipmaps.length>0)for(let K=0;K<E.mipmaps.length;K++)Ie(G.__webglFramebuffer[X][K],R,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+X,K);else Ie(G.__webglFramebuffer[X],R,E,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+X,0);m(E)&&b(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(oe){for(let X=0,K=Q.length;X<K;X++){const pe=Q[X],be=i.get(pe);let se=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,be.__webglTexture),Re(se,pe),Ie(G.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+X,se,0),m(pe)&&b(se)}t.unbindTexture()}else{let X=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(X=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(X,Z.__webglTexture),Re(X,E),E.mipmaps&&E.mipmaps.length>0)for(let K=0;K<E.mipmaps.length;K++)Ie(G.__webglFramebuffer[K],R,E,n.COLOR_ATTACHMENT0,X,K);else Ie(G.__webglFramebuffer,R,E,n.COLOR_ATTACHMENT0,X,0);m(E)&&b(X),t.unbindTexture()}R.depthBuffer&&nt(R)}function Tt(R){const E=R.textures;for(let G=0,Z=E.length;G<Z;G++){const Q=E[G];if(m(Q)){const te=x(R),oe=i.get(Q).__webglTexture;t.bindTexture(te,oe),b(te),t.unbindTexture()}}}const pt=[],cn=[];function O(R){if(R.samples>0){if(He(R)===!1){const E=R.textures,G=R.width,Z=R.height;let Q=n.COLOR_BUFFER_BIT;const te=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,oe=i.get(R),X=E.length>1;if(X)for(let pe=0;pe<E.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,oe.__webglMultisampledFramebuffer);const K=R.texture.mipmaps;K&&K.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,oe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,oe.__webglFramebuffer);for(let pe=0;pe<E.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(Q|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(Q|=n.STENCIL_BUFFER_BIT)),X){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,oe.__webglColorRenderbuffer[pe]);const be=i.get(E[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,be,0)}n.blitFramebuffer(0,0,G,Z,0,0,G,Z,Q,n.NEAREST),c===!0&&(pt.length=0,cn.length=0,pt.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.resolveDepthBuffer===!1&&(pt.push(te),cn.push(te),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,cn)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,pt))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),X)for(let pe=0;pe<E.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,oe.__webglColorRenderbuffer[pe]);const be=i.get(E[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,be,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,oe.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.resolveDepthBuffer===!1&&c){const E=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[E])}}}function It(R){return Math.min(a.maxSamples,R.samples)}function He(R){const E=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function lt(R){const E=r.render.frame;u.get(R)!==E&&(u.set(R,E),R.update())}function de(R,E){const G=R.colorSpace,Z=R.format,Q=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||G!==Us&&G!==Ci&&(je.getTransfer(G)===Qe?(Z!==En||Q!==xn)&&Ne("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Xe("WebGLTextures: Unsupported texture color space:",G)),E}function mt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(l.width=R.naturalWidth||R.width,l.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(l.width=R.displayWidth,l.height=R.displayHeight):(l.width=R.width,l.height=R.height),l}this.allocateTextureUnit=B,this.resetTextureUnits=L,this.getTextureUnits=F,this.setTextureUnits=P,this.setTexture2D=q,this.setTexture2DArray=ee,this.setTexture3D=le,this.setTextureCube=ve,this.rebindTextures=ht,this.setupRenderTarget=ze,this.updateRenderTargetMipmap=Tt,this.updateMultisampleRenderTarget=O,this.setupDepthRenderbuffer=nt,this.setupFrameBufferTexture=Ie,this.useMultisampledRTT=He,this.isReversedDepthBuffer=function(){return t.buffers.depth.getReversed()}}function oE(n,e){function t(i,a=Ci){let s;const r=je.getTransfer(a);if(i===xn)return n.UNSIGNED_BYTE;if(i===rd)return n.UNSIGNED_SHORT_4_4_4_4;if(i===od)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Np)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Rp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Tp)return n.BYTE;if(i===Ip)return n.SHORT;if(i===Rs)return n.UNSIGNED_SHORT;if(i===sd)return n.INT;if(i===On)return n.UNSIGNED_INT;if(i===Zn)return n.FLOAT;if(i===pi)return n.HALF_FLOAT;if(i===Cp)return n.ALPHA;if(i===Up)return n.RGB;if(i===En)return n.RGBA;if(i===mi)return n.DEPTH_COMPONENT;if(i===qi)return n.DEPTH_STENCIL;if(i===Pp)return n.RED;if(i===cd)return n.RED_INTEGER;if(i===ia)return n.RG;if(i===ld)return n.RG_INTEGER;if(i===dd)return n.RGBA_INTEGER;if(i===Yr||i===Zr||i===Kr||i===Jr)if(r===Qe)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Yr)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Zr)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Kr)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Jr)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Yr)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Zr)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Kr)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Jr)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===nl||i===il||i===al||i===sl)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===nl)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===il)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===al)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===sl)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===rl||i===ol||i===cl||i===ll||i===dl||i===ao||i===ul)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===rl||i===ol)return r===Qe?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===cl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===ll)return s.COMPRESSED_R11_EAC;if(i===dl)return s.COMPRESSED_SIGNED_R11_EAC;if(i===ao)return s.COMPRESSED_RG11_EAC;if(i===ul)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===hl||i===fl||i===pl||i===ml||i===gl||i===bl||i===_l||i===vl||i===yl||i===xl||i===El||i===Sl||i===Ml||i===Al)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===hl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===fl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===pl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ml)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===gl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===bl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===_l)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===vl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===yl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===xl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===El)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Sl)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ml)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Al)return r===Qe?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===wl||i===Tl||i===Il)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===wl)return r===Qe?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Tl)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Il)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Nl||i===Rl||i===so||i===Cl)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Nl)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Rl)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===so)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Cl)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Cs?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}const cE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,lE=`
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

}`;class dE{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const i=new Hp(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new on({vertexShader:cE,fragmentShader:lE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new An(new js(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class uE extends Fi{constructor(e,t){super();const i=this;let a=null,s=1,r=null,o="local-floor",c=1,l=null,u=null,h=null,d=null,f=null,g=null;const y=typeof XRWebGLBinding<"u",p=new dE,m={},b=t.getContextAttributes();let x=null,v=null;const M=[],w=[],N=new we;let _=null;const S=new _n;S.viewport=new ut;const T=new _n;T.viewport=new ut;const I=[S,T],C=new b0;let L=null,F=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let ue=M[J];return ue===void 0&&(ue=new Xo,M[J]=ue),ue.getTargetRaySpace()},this.getControllerGrip=function(J){let ue=M[J];return ue===void 0&&(ue=new Xo,M[J]=ue),ue.getGripSpace()},this.getHand=function(J){let ue=M[J];return ue===void 0&&(ue=new Xo,M[J]=ue),ue.getHandSpace()};function P(J){const ue=w.indexOf(J.inputSource);if(ue===-1)return;const ae=M[ue];ae!==void 0&&(ae.update(J.inputSource,J.frame,l||r),ae.dispatchEvent({type:J.type,data:J.inputSource}))}function B(){a.removeEventListener("select",P),a.removeEventListener("selectstart",P),a.removeEventListener("selectend",P),a.removeEventListener("squeeze",P),a.removeEventListener("squeezestart",P),a.removeEventListener("squeezeend",P),a.removeEventListener("end",B),a.removeEventListener("inputsourceschange",V);for(let J=0;J<M.length;J++){const ue=w[J];ue!==null&&(w[J]=null,M[J].disconnect(ue))}L=null,F=null,p.reset();for(const J in m)delete m[J];e.setRenderTarget(x),f=null,d=null,h=null,a=null,v=null,Re.stop(),i.isPresenting=!1,e.setPixelRatio(_),e.setSize(N.width,N.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){s=J,i.isPresenting===!0&&Ne("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,i.isPresenting===!0&&Ne("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||r},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(a,t)),h},this.getFrame=function(){return g},this.getSession=function(){return a},this.setSession=async function(J){if(a=J,a!==null){if(x=e.getRenderTarget(),a.addEventListener("select",P),a.addEventListener("selectstart",P),a.addEventListener("selectend",P),a.addEventListener("squeeze",P),a.addEventListener("squeezestart",P),a.addEventListener("squeezeend",P),a.addEventListener("end",B),a.addEventListener("inputsourceschange",V),b.xrCompatible!==!0&&await t.makeXRCompatible(),_=e.getPixelRatio(),e.getSize(N),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ae=null,Te=null,Ce=null;b.depth&&(Ce=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ae=b.stencil?qi:mi,Te=b.stencil?Cs:On);const Ie={colorFormat:t.RGBA8,depthFormat:Ce,scaleFactor:s};h=this.getBinding(),d=h.createProjectionLayer(Ie),a.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),v=new Dn(d.textureWidth,d.textureHeight,{format:En,type:xn,depthTexture:new sa(d.textureWidth,d.textureHeight,Te,void 0,void 0,void 0,void 0,void 0,void 0,ae),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}else{const ae={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:s};f=new XRWebGLLayer(a,t,ae),a.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new Dn(f.framebufferWidth,f.framebufferHeight,{format:En,type:xn,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,r=await a.requestReferenceSpace(o),Re.setContext(a),Re.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(a!==null)return a.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function V(J){for(let ue=0;ue<J.removed.length;ue++){const ae=J.removed[ue],Te=w.indexOf(ae);Te>=0&&(w[Te]=null,M[Te].disconnect(ae))}for(let ue=0;ue<J.added.length;ue++){const ae=J.added[ue];let Te=w.indexOf(ae);if(Te===-1){for(let Ie=0;Ie<M.length;Ie++)if(Ie>=w.length){w.push(ae),Te=Ie;break}else if(w[Ie]===null){w[Ie]=ae,Te=Ie;break}if(Te===-1)break}const Ce=M[Te];Ce&&Ce.connect(ae)}}const q=new U,ee=new U;function le(J,ue,ae){q.setFromMatrixPosition(ue.matrixWorld),ee.setFromMatrixPosition(ae.matrixWorld);const Te=q.distanceTo(ee),Ce=ue.projectionMatrix.elements,Ie=ae.projectionMatrix.elements,rt=Ce[14]/(Ce[10]-1),We=Ce[14]/(Ce[10]+1),nt=(Ce[9]+1)/Ce[5],ht=(Ce[9]-1)/Ce[5],ze=(Ce[8]-1)/Ce[0],Tt=(Ie[8]+1)/Ie[0],pt=rt*ze,cn=rt*Tt,O=Te/(-ze+Tt),It=O*-ze;if(ue.matrixWorld.decompose(J.position,J.quaternion,J.scale),J.translateX(It),J.translateZ(O),J.matrixWorld.compose(J.position,J.quaternion,J.scale),J.matrixWorldInverse.copy(J.matrixWorld).invert(),Ce[10]===-1)J.projectionMatrix.copy(ue.projectionMatrix),J.projectionMatrixInverse.copy(ue.projectionMatrixInverse);else{const He=rt+O,lt=We+O,de=pt-It,mt=cn+(Te-It),R=nt*We/lt*He,E=ht*We/lt*He;J.projectionMatrix.makePerspective(de,mt,R,E,He,lt),J.projectionMatrixInverse.copy(J.projectionMatrix).invert()}}function ve(J,ue){ue===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(ue.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(a===null)return;let ue=J.near,ae=J.far;p.texture!==null&&(p.depthNear>0&&(ue=p.depthNear),p.depthFar>0&&(ae=p.depthFar)),C.near=T.near=S.near=ue,C.far=T.far=S.far=ae,(L!==C.near||F!==C.far)&&(a.updateRenderState({depthNear:C.near,depthFar:C.far}),L=C.near,F=C.far),C.layers.mask=J.layers.mask|6,S.layers.mask=C.layers.mask&-5,T.layers.mask=C.layers.mask&-3;const Te=J.parent,Ce=C.cameras;ve(C,Te);for(let Ie=0;Ie<Ce.length;Ie++)ve(Ce[Ie],Te);Ce.length===2?le(C,S,T):C.projectionMatrix.copy(S.projectionMatrix),ye(J,C,Te)};function ye(J,ue,ae){ae===null?J.matrix.copy(ue.matrixWorld):(J.matrix.copy(ae.matrixWorld),J.matrix.invert(),J.matrix.multiply(ue.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(ue.projectionMatrix),J.projectionMatrixInverse.copy(ue.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Ps*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return C},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(C)},this.getCameraTexture=function(J){return m[J]};let Ge=null;function $e(J,ue){if(u=ue.getViewerPose(l||r),g=ue,u!==null){const ae=u.views;f!==null&&(e.setRenderTargetFramebuffer(v,f.framebuffer),e.setRenderTarget(v));let Te=!1;ae.length!==C.cameras.length&&(C.cameras.length=0,Te=!0);for(let We=0;We<ae.length;We++){const nt=ae[We];let ht=null;if(f!==null)ht=f.getViewport(nt);else{const Tt=h.getViewSubImage(d,nt);ht=Tt.viewport,We===0&&(e.setRenderTargetTextures(v,Tt.colorTexture,Tt.depthStencilTexture),e.setRenderTarget(v))}let ze=I[We];ze===void 0&&(ze=new _n,ze.layers.enable(We),ze.viewport=new ut,I[We]=ze),ze.matrix.fromArray(nt.transform.matrix),ze.matrix.decompose(ze.position,ze.quaternion,ze.scale),ze.projectionMatrix.fromArray(nt.projectionMatrix),ze.projectionMatrixInverse.copy(ze.projectionMatrix).invert(),ze.viewport.set(ht.x,ht.y,ht.width,ht.height),We===0&&(C.matrix.copy(ze.matrix),C.matrix.decompose(C.position,C.quaternion,C.scale)),Te===!0&&C.cameras.push(ze)}const Ce=a.enabledFeatures;if(Ce&&Ce.includes("depth-sensing")&&a.depthUsage=="gpu-optimized"&&y){h=i.getBinding();const We=h.getDepthInformation(ae[0]);We&&We.isValid&&We.texture&&p.init(We,a.renderState)}if(Ce&&Ce.includes("camera-access")&&y){e.state.unbindTexture(),h=i.getBinding();for(let We=0;We<ae.length;We++){const nt=ae[We].camera;if(nt){let ht=m[nt];ht||(ht=new Hp,m[nt]=ht);const ze=h.getCameraImage(nt);ht.sourceTexture=ze}}}}for(let ae=0;ae<M.length;ae++){const Te=w[ae],Ce=M[ae];Te!==null&&Ce!==void 0&&Ce.update(Te,ue,l||r)}Ge&&Ge(J,ue),ue.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ue}),g=null}const Re=new Zp;Re.setAnimationLoop($e),this.setAnimationLoop=function(J){Ge=J},this.dispose=function(){}}}const hE=new qe,tm=new De;tm.set(-1,0,0,0,1,0,0,0,1);function fE(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,jp(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function a(p,m,b,x,v){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?s(p,m):m.isMeshLambertMaterial?(s(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(s(p,m),h(p,m)):m.isMeshPhongMaterial?(s(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(s(p,m),d(p,m),m.isMeshPhysicalMaterial&&f(p,m,v)):m.isMeshMatcapMaterial?(s(p,m),g(p,m)):m.isMeshDepthMaterial?s(p,m):m.isMeshDistanceMaterial?(s(p,m),y(p,m)):m.isMeshNormalMaterial?s(p,m):m.isLineBasicMaterial?(r(p,m),m.isLineDashedMaterial&&o(p,m)):m.isPointsMaterial?c(p,m,b,x):m.isSpriteMaterial?l(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function s(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Qt&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Qt&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);const b=e.get(m),x=b.envMap,v=b.envMapRotation;x&&(p.envMap.value=x,p.envMapRotation.value.setFromMatrix4(hE.makeRotationFromEuler(v)).transpose(),x.isCubeTexture&&x.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(tm),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function r(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function o(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function c(p,m,b,x){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*b,p.scale.value=x*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function l(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function h(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function d(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function f(p,m,b){p.ior.value=m.ior,m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Qt&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=m.iridescenceThicknessRange[1],m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=b.texture,p.transmissionSamplerSize.value.set(b.width,b.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){const b=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(b.matrixWorld),p.nearDistance.value=b.shadow.camera.near,p.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:a}}function pE(n,e,t,i){let a={},s={},r=[];const o=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function c(b,x){const v=x.program;i.uniformBlockBinding(b,v)}function l(b,x){let v=a[b.id];v===void 0&&(g(b),v=u(b),a[b.id]=v,b.addEventListener("dispose",p));const M=x.program;i.updateUBOMapping(b,M);const w=e.render.frame;s[b.id]!==w&&(d(b),s[b.id]=w)}function u(b){const x=h();b.__bindingPointIndex=x;const v=n.createBuffer(),M=b.__size,w=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,v),n.bufferData(n.UNIFORM_BUFFER,M,w),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,x,v),v}function h(){for(let b=0;b<o;b++)if(r.indexOf(b)===-1)return r.push(b),b;return Xe("WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function d(b){const x=a[b.id],v=b.uniforms,M=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,x);for(let w=0,N=v.length;w<N;w++){const _=Array.isArray(v[w])?v[w]:[v[w]];for(let S=0,T=_.length;S<T;S++){const I=_[S];if(f(I,w,S,M)===!0){const C=I.__offset,L=Array.isArray(I.value)?I.value:[I.value];let F=0;for(let P=0;P<L.length;P++){const B=L[P],V=y(B);typeof B=="number"||typeof B=="boolean"?(I.__data[0]=B,n.bufferSubData(n.UNIFORM_BUFFER,C+F,I.__data)):B.isMatrix3?(I.__data[0]=B.elements[0],I.__data[1]=B.elements[1],I.__data[2]=B.elements[2],I.__data[3]=0,I.__data[4]=B.elements[3],I.__data[5]=B.elements[4],I.__data[6]=B.elements[5],I.__data[7]=0,I.__data[8]=B.elements[6],I.__data[9]=B.elements[7],I.__data[10]=B.elements[8],I.__data[11]=0):ArrayBuffer.isView(B)?I.__data.set(new B.constructor(B.buffer,B.byteOffset,I.__data.length)):(B.toArray(I.__data,F),F+=V.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,C,I.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function f(b,x,v,M){const w=b.value,N=x+"_"+v;if(M[N]===void 0)return typeof w=="number"||typeof w=="boolean"?M[N]=w:ArrayBuffer.isView(w)?M[N]=w.slice():M[N]=w.clone(),!0;{const _=M[N];if(typeof w=="number"||typeof w=="boolean"){if(_!==w)return M[N]=w,!0}else{if(ArrayBuffer.isView(w))return!0;if(_.equals(w)===!1)return _.copy(w),!0}}return!1}function g(b){const x=b.uniforms;let v=0;const M=16;for(let N=0,_=x.length;N<_;N++){const S=Array.isArray(x[N])?x[N]:[x[N]];for(let T=0,I=S.length;T<I;T++){const C=S[T],L=Array.isArray(C.value)?C.value:[C.value];for(let F=0,P=L.length;F<P;F++){const B=L[F],V=y(B),q=v%M,ee=q%V.boundary,le=q+ee;v+=ee,le!==0&&M-le<V.storage&&(v+=M-le),C.__data=new Float32Array(V.storage/Float32Array.BYTES_PER_ELEMENT),C.__offset=v,v+=V.storage}}}const w=v%M;return w>0&&(v+=M-w),b.__size=v,b.__cache={},this}function y(b){const x={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(x.boundary=4,x.storage=4):b.isVector2?(x.boundary=8,x.storage=8):b.isVector3||b.isColor?(x.boundary=16,x.storage=12):b.isVector4?(x.boundary=16,x.storage=16):b.isMatrix3?(x.boundary=48,x.storage=48):b.isMatrix4?(x.boundary=64,x.storage=64):b.isTexture?Ne("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(x.boundary=16,x.storage=b.byteLength):Ne("WebGLRenderer: Unsupported uniform value type.",b),x}function p(b){const x=b.target;x.removeEventListener("dispose",p);const v=r.indexOf(x.__bindingPointIndex);r.splice(v,1),n.deleteBuffer(a[x.id]),delete a[x.id],delete s[x.id]}function m(){for(const b in a)n.deleteBuffer(a[b]);r=[],a={},s={}}return{bind:c,update:l,dispose:m}}const mE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let zn=null;function gE(){return zn===null&&(zn=new zp(mE,16,16,ia,pi),zn.name="DFG_LUT",zn.minFilter=Ht,zn.magFilter=Ht,zn.wrapS=li,zn.wrapT=li,zn.generateMipmaps=!1,zn.needsUpdate=!0),zn}class bE{constructor(e={}){const{canvas:t=_b(),context:i=null,depth:a=!0,stencil:s=!1,alpha:r=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=xn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=r;const y=f,p=new Set([dd,ld,cd]),m=new Set([xn,On,Rs,Cs,rd,od]),b=new Uint32Array(4),x=new Int32Array(4),v=new U;let M=null,w=null;const N=[],_=[];let S=null;this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Jn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const T=this;let I=!1,C=null;this._outputColorSpace=bn;let L=0,F=0,P=null,B=-1,V=null;const q=new ut,ee=new ut;let le=null;const ve=new Ze(0);let ye=0,Ge=t.width,$e=t.height,Re=1,J=null,ue=null;const ae=new ut(0,0,Ge,$e),Te=new ut(0,0,Ge,$e);let Ce=!1;const Ie=new Gp;let rt=!1,We=!1;const nt=new qe,ht=new U,ze=new ut,Tt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let pt=!1;function cn(){return P===null?Re:1}let O=i;function It(A,k){return t.getContext(A,k)}try{const A={alpha:!0,depth:a,stencil:s,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine","three.js r184"),t.addEventListener("webglcontextlost",$,!1),t.addEventListener("webglcontextrestored",Ee,!1),t.addEventListener("webglcontextcreationerror",Oe,!1),O===null){const k="webgl2";if(O=It(k,A),O===null)throw It(k)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(A){throw Xe("WebGLRenderer: "+A.message),A}let He,lt,de,mt,R,E,G,Z,Q,te,oe,X,K,pe,be,se,ne,Ue,ke,Ke,D,ie,Y;function me(){He=new gy(O),He.init(),D=new oE(O,He),lt=new cy(O,He,e,D),de=new sE(O,He),lt.reversedDepthBuffer&&d&&de.buffers.depth.setReversed(!0),mt=new vy(O),R=new jx,E=new rE(O,He,de,R,lt,D,mt),G=new my(T),Z=new S0(O),ie=new ry(O,Z),Q=new by(O,Z,mt,ie),te=new xy(O,Q,Z,ie,mt),Ue=new yy(O,lt,E),be=new ly(R),oe=new Hx(T,G,He,lt,ie,be),X=new fE(T,R),K=new Yx,pe=new Qx(He),ne=new sy(T,G,de,te,g,c),se=new aE(T,te,lt),Y=new pE(O,mt,lt,de),ke=new oy(O,He,mt),Ke=new _y(O,He,mt),mt.programs=oe.programs,T.capabilities=lt,T.extensions=He,T.properties=R,T.renderLists=K,T.shadowMap=se,T.state=de,T.info=mt}me(),y!==xn&&(S=new Sy(y,t.width,t.height,a,s));const re=new uE(T,O);this.xr=re,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){const A=He.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){const A=He.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Re},this.setPixelRatio=function(A){A!==void 0&&(Re=A,this.setSize(Ge,$e,!1))},this.getSize=function(A){return A.set(Ge,$e)},this.setSize=function(A,k,j=!0){if(re.isPresenting){Ne("WebGLRenderer: Can't change size while VR device is presenting.");return}Ge=A,$e=k,t.width=Math.floor(A*Re),t.height=Math.floor(k*Re),j===!0&&(t.style.width=A+"px",t.style.height=k+"px"),S!==null&&S.setSize(t.width,t.height),this.setViewport(0,0,A,k)},this.getDrawingBufferSize=function(A){return A.set(Ge*Re,$e*Re).floor()},this.setDrawingBufferSize=function(A,k,j){Ge=A,$e=k,Re=j,t.width=Math.floor(A*j),t.height=Math.floor(k*j),this.setViewport(0,0,A,k)},this.setEffects=function(A){if(y===xn){Xe("THREE.WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let k=0;k<A.length;k++)if(A[k].isOutputPass===!0){Ne("THREE.WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}S.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(q)},this.getViewport=function(A){return A.copy(ae)},this.setViewport=function(A,k,j,W){A.isVector4?ae.set(A.x,A.y,A.z,A.w):ae.set(A,k,j,W),de.viewport(q.copy(ae).multiplyScalar(Re).round())},this.getScissor=function(A){return A.copy(Te)},this.setScissor=function(A,k,j,W){A.isVector4?Te.set(A.x,A.y,A.z,A.w):Te.set(A,k,j,W),de.scissor(ee.copy(Te).multiplyScalar(Re).round())},this.getScissorTest=function(){return Ce},this.setScissorTest=function(A){de.setScissorTest(Ce=A)},this.setOpaqueSort=function(A){J=A},this.setTransparentSort=function(A){ue=A},this.getClearColor=function(A){return A.copy(ne.getClearColor())},this.setClearColor=function(){ne.setClearColor(...arguments)},this.getClearAlpha=function(){return ne.getClearAlpha()},this.setClearAlpha=function(){ne.setClearAlpha(...arguments)},this.clear=function(A=!0,k=!0,j=!0){let W=0;if(A){let H=!1;if(P!==null){const fe=P.texture.format;H=p.has(fe)}if(H){const fe=P.texture.type,_e=m.has(fe),he=ne.getClearColor(),xe=ne.getClearAlpha(),Se=he.r,Fe=he.g,Ve=he.b;_e?(b[0]=Se,b[1]=Fe,b[2]=Ve,b[3]=xe,O.clearBufferuiv(O.COLOR,0,b)):(x[0]=Se,x[1]=Fe,x[2]=Ve,x[3]=xe,O.clearBufferiv(O.COLOR,0,x))}else W|=O.COLOR_BUFFER_BIT}k&&(W|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(W|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),W!==0&&O.clear(W)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),C=A},this.dispose=function(){t.removeEventListener("webglcontextlost",$,!1),t.removeEventListener("webglcontextrestored",Ee,!1),t.removeEventListener("webglcontextcreationerror",Oe,!1),ne.dispose(),K.dispose(),pe.dispose(),R.dispose(),G.dispose(),te.dispose(),ie.dispose(),Y.dispose(),oe.dispose(),re.dispose(),re.removeEventListener("sessionstart",tu),re.removeEventListener("sessionend",nu),Bi.stop()};function $(A){A.preventDefault(),lo("WebGLRenderer: Context Lost."),I=!0}function Ee(){lo("WebGLRenderer: Context Restored."),I=!1;const A=mt.autoReset,k=se.enabled,j=se.autoUpdate,W=se.needsUpdate,H=se.type;me(),mt.autoReset=A,se.enabled=k,se.autoUpdate=j,se.needsUpdate=W,se.type=H}function Oe(A){Xe("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function _t(A){const k=A.target;k.removeEventListener("dispose",_t),it(k)}function it(A){ti(A),R.remove(A)}function ti(A){const k=R.get(A).programs;k!==void 0&&(k.forEach(function(j){oe.releaseProgram(j)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,k,j,W,H,fe){k===null&&(k=Tt);const _e=H.isMesh&&H.matrixWorld.determinant()<0,he=Ug(A,k,j,W,H);de.setMaterial(W,_e);let xe=j.index,Se=1;if(W.wireframe===!0){if(xe=Q.getWireframeAttribute(j),xe===void 0)return;Se=2}const Fe=j.drawRange,Ve=j.attributes.position;let Me=Fe.start*Se,at=(Fe.start+Fe.count)*Se;fe!==null&&(Me=Math.max(Me,fe.start*Se),at=Math.min(at,(fe.start+fe.count)*Se)),xe!==null?(Me=Math.max(Me,0),at=Math.min(at,xe.count)):Ve!=null&&(Me=Math.max(Me,0),at=Math.min(at,Ve.count));const vt=at-Me;if(vt<0||vt===1/0)return;ie.setup(H,W,he,j,xe);let gt,ot=ke;if(xe!==null&&(gt=Z.get(xe),ot=Ke,ot.setIndex(gt)),H.isMesh)W.wireframe===!0?(de.setLineWidth(W.wireframeLinewidth*cn()),ot.setMode(O.LINES)):ot.setMode(O.TRIANGLES);else if(H.isLine){let jt=W.linewidth;jt===void 0&&(jt=1),de.setLineWidth(jt*cn()),H.isLineSegments?ot.setMode(O.LINES):H.isLineLoop?ot.setMode(O.LINE_LOOP):ot.setMode(O.LINE_STRIP)}else H.isPoints?ot.setMode(O.POINTS):H.isSprite&&ot.setMode(O.TRIANGLES);if(H.isBatchedMesh)if(He.get("WEBGL_multi_draw"))ot.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const jt=H._multiDrawStarts,ge=H._multiDrawCounts,ln=H._multiDrawCount,Ye=xe?Z.get(xe).bytesPerElement:1,pn=R.get(W).currentProgram.getUniforms();for(let Bn=0;Bn<ln;Bn++)pn.setValue(O,"_gl_DrawID",Bn),ot.render(jt[Bn]/Ye,ge[Bn])}else if(H.isInstancedMesh)ot.renderInstances(Me,vt,H.count);else if(j.isInstancedBufferGeometry){const jt=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,ge=Math.min(j.instanceCount,jt);ot.renderInstances(Me,vt,ge)}else ot.render(Me,vt)};function kn(A,k,j){A.transparent===!0&&A.side===yn&&A.forceSinglePass===!1?(A.side=Qt,A.needsUpdate=!0,Js(A,k,j),A.side=qn,A.needsUpdate=!0,Js(A,k,j),A.side=yn):Js(A,k,j)}this.compile=function(A,k,j=null){j===null&&(j=A),w=pe.get(j),w.init(k),_.push(w),j.traverseVisible(function(H){H.isLight&&H.layers.test(k.layers)&&(w.pushLight(H),H.castShadow&&w.pushShadow(H))}),A!==j&&A.traverseVisible(function(H){H.isLight&&H.layers.test(k.layers)&&(w.pushLight(H),H.castShadow&&w.pushShadow(H))}),w.setupLights();const W=new Set;return A.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const fe=H.material;if(fe)if(Array.isArray(fe))for(let _e=0;_e<fe.length;_e++){const he=fe[_e];kn(he,j,H),W.add(he)}else kn(fe,j,H),W.add(fe)}),w=_.pop(),W},this.compileAsync=function(A,k,j=null){const W=this.compile(A,k,j);return new Promise(H=>{function fe(){if(W.forEach(function(_e){R.get(_e).currentProgram.isReady()&&W.delete(_e)}),W.size===0){H(A);return}setTimeout(fe,10)}He.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let Oo=null;function Rg(A){Oo&&Oo(A)}function tu(){Bi.stop()}function nu(){Bi.start()}const Bi=new Zp;Bi.setAnimationLoop(Rg),typeof self<"u"&&Bi.setContext(self),this.setAnimationLoop=function(A){Oo=A,re.setAnimationLoop(A),A===null?Bi.stop():Bi.start()},re.addEventListener("sessionstart",tu),re.addEventListener("sessionend",nu),this.render=function(A,k){if(k!==void 0&&k.isCamera!==!0){Xe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;C!==null&&C.renderStart(A,k);const j=re.enabled===!0&&re.isPresenting===!0,W=S!==null&&(P===null||j)&&S.begin(T,P);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),re.enabled===!0&&re.isPresenting===!0&&(S===null||S.isCompositing()===!1)&&(re.cameraAutoUpdate===!0&&re.updateCamera(k),k=re.getCamera()),A.isScene===!0&&A.onBeforeRender(T,A,k,P),w=pe.get(A,_.length),w.init(k),w.state.textureUnits=E.getTextureUnits(),_.push(w),nt.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),Ie.setFromProjectionMatrix(nt,Kn,k.reversedDepth),We=this.localClippingEnabled,rt=be.init(this.clippingPlanes,We),M=K.get(A,N.length),M.init(),N.push(M),re.enabled===!0&&re.isPresenting===!0){const _e=T.xr.getDepthSensingMesh();_e!==null&&Fo(_e,k,-1/0,T.sortObjects)}Fo(A,k,0,T.sortObjects),M.finish(),T.sortObjects===!0&&M.sort(J,ue),pt=re.enabled===!1||re.isPresenting===!1||re.hasDepthSensing()===!1,pt&&ne.addToRenderList(M,A),this.info.render.frame++,rt===!0&&be.beginShadows();const H=w.state.shadowsArray;if(se.render(H,A,k),rt===!0&&be.endShadows(),this.info.autoReset===!0&&this.info.reset(),(W&&S.hasRenderPass())===!1){const _e=M.opaque,he=M.transmissive;if(w.setupLights(),k.isArrayCamera){const xe=k.cameras;if(he.length>0)for(let Se=0,Fe=xe.length;Se<Fe;Se++){const Ve=xe[Se];au(_e,he,A,Ve)}pt&&ne.render(A);for(let Se=0,Fe=xe.length;Se<Fe;Se++){const Ve=xe[Se];iu(M,A,Ve,Ve.viewport)}}else he.length>0&&au(_e,he,A,k),pt&&ne.render(A),iu(M,A,k)}P!==null&&F===0&&(E.updateMultisampleRenderTarget(P),E.updateRenderTargetMipmap(P)),W&&S.end(T),A.isScene===!0&&A.onAfterRender(T,A,k),ie.resetDefaultState(),B=-1,V=null,_.pop(),_.length>0?(w=_[_.length-1],E.setTextureUnits(w.state.textureUnits),rt===!0&&be.setGlobalState(T.clippingPlanes,w.state.camera)):w=null,N.pop(),N.length>0?M=N[N.length-1]:M=null,C!==null&&C.renderEnd()};function Fo(A,k,j,W){if(A.visible===!1)return;if(A.layers.test(k.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(k);else if(A.isLightProbeGrid)w.pushLightProbeGrid(A);else if(A.isLight)w.pushLight(A),A.castShadow&&w.pushShadow(A);else if(A.isSprite){if(!A.frustumCulled||Ie.intersectsSprite(A)){W&&ze.setFromMatrixPosition(A.matrixWorld).applyMatrix4(nt);const _e=te.update(A),he=A.material;he.visible&&M.push(A,_e,he,j,ze.z,null)}}else if((A.isMesh||A.isLine||A.isPoints)&&(!A.frustumCulled||Ie.intersectsObject(A))){const _e=te.update(A),he=A.material;if(W&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),ze.copy(A.boundingSphere.center)):(_e.boundingSphere===null&&_e.computeBoundingSphere(),ze.copy(_e.boundingSphere.center)),ze.applyMatrix4(A.matrixWorld).applyMatrix4(nt)),Array.isArray(he)){const xe=_e.groups;for(let Se=0,Fe=xe.length;Se<Fe;Se++){const Ve=xe[Se],Me=he[Ve.materialIndex];Me&&Me.visible&&M.push(A,_e,Me,j,ze.z,Ve)}}else he.visible&&M.push(A,_e,he,j,ze.z,null)}}const fe=A.children;for(let _e=0,he=fe.length;_e<he;_e++)Fo(fe[_e],k,j,W)}function iu(A,k,j,W){const{opaque:H,transmissive:fe,transparent:_e}=A;w.setupLightsView(j),rt===!0&&be.setGlobalState(T.clippingPlanes,j),W&&de.viewport(q.copy(W)),H.length>0&&Ks(H,k,j),fe.length>0&&Ks(fe,k,j),_e.length>0&&Ks(_e,k,j),de.buffers.depth.setTest(!0),de.buffers.depth.setMask(!0),de.buffers.color.setMask(!0),de.setPolygonOffset(!1)}function au(A,k,j,W){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[W.id]===void 0){const Me=He.has("EXT_color_buffer_half_float")||He.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[W.id]=new Dn(1,1,{generateMipmaps:!0,type:Me?pi:xn,minFilter:Ji,samples:Math.max(4,lt.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:je.workingColorSpace})}const fe=w.state.transmissionRenderTarget[W.id],_e=W.viewport||q;fe.setSize(_e.z*T.transmissionResolutionScale,_e.w*T.transmissionResolutionScale);const he=T.getRenderTarget(),xe=T.getActiveCubeFace(),Se=T.getActiveMipmapLevel();T.setRenderTarget(fe),T.getClearColor(ve),ye=T.getClearAlpha(),ye<1&&T.setClearColor(16777215,.5),T.clear(),pt&&ne.render(j);const Fe=T.toneMapping;T.toneMapping=Jn;const Ve=W.viewport;if(W.viewport!==void 0&&(W.viewport=void 0),w.setupLightsView(W),rt===!0&&be.setGlobalState(T.clippingPlanes,W),Ks(A,j,W),E.updateMultisampleRenderTarget(fe),E.updateRenderTargetMipmap(fe),He.has("WEBGL_multisampled_render_to_texture")===!1){let Me=!1;for(let at=0,vt=k.length;at<vt;at++){const gt=k[at],{object:ot,geometry:jt,material:ge,group:ln}=gt;if(ge.side===yn&&ot.layers.test(W.layers)){const Ye=ge.side;ge.side=Qt,ge.needsUpdate=!0,su(ot,j,W,jt,ge,ln),ge.side=Ye,ge.needsUpdate=!0,Me=!0}}Me===!0&&(E.updateMultisampleRenderTarget(fe),E.updateRenderTargetMipmap(fe))}T.setRenderTarget(he,xe,Se),T.setClearColor(ve,ye),Ve!==void 0&&(W.viewport=Ve),T.toneMapping=Fe}function Ks(A,k,j){const W=k.isScene===!0?k.overrideMaterial:null;for(let H=0,fe=A.length;H<fe;H++){const _e=A[H],{object:he,geometry:xe,group:Se}=_e;let Fe=_e.material;Fe.allowOverride===!0&&W!==null&&(Fe=W),he.layers.test(j.layers)&&su(he,k,j,xe,Fe,Se)}}function su(A,k,j,W,H,fe){A.onBeforeRender(T,k,j,W,H,fe),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),H.onBeforeRender(T,k,j,W,A,fe),H.transparent===!0&&H.side===yn&&H.forceSinglePass===!1?(H.side=Qt,H.needsUpdate=!0,T.renderBufferDirect(j,k,W,H,A,fe),H.side=qn,H.needsUpdate=!0,T.renderBufferDirect(j,k,W,H,A,fe),H.side=yn):T.renderBufferDirect(j,k,W,H,A,fe),A.onAfterRender(T,k,j,W,H,fe)}function Js(A,k,j){k.isScene!==!0&&(k=Tt);const W=R.get(A),H=w.state.lights,fe=w.state.shadowsArray,_e=H.state.version,he=oe.getParameters(A,H.state,fe,k,j,w.state.lightProbeGridArray),xe=oe.getProgramCacheKey(he);let Se=W.programs;W.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?k.environment:null,W.fog=k.fog;const Fe=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;W.envMap=G.get(A.envMap||W.environment,Fe),W.envMapRotation=W.environment!==null&&A.envMap===null?k.environmentRotation:A.envMapRotation,Se===void 0&&(A.addEventListener("dispose",_t),Se=new Map,W.programs=Se);let Ve=Se.get(xe);if(Ve!==void 0){if(W.currentProgram===Ve&&W.lightsStateVersion===_e)return ou(A,he),Ve}else he.uniforms=oe.getUniforms(A),C!==null&&A.isNodeMaterial&&C.build(A,j,he),A.onBeforeCompile(he,T),Ve=oe.acquireProgram(he,xe),Se.set(xe,Ve),W.uniforms=he.uniforms;const Me=W.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Me.clippingPlanes=be.uniform),ou(A,he),W.needsLights=Lg(A),W.lightsStateVersion=_e,W.needsLights&&(Me.ambientLightColor.value=H.state.ambient,Me.lightProbe.value=H.state.probe,Me.directionalLights.value=H.state.directional,Me.directionalLightShadows.value=H.state.directionalShadow,Me.spotLights.value=H.state.spot,Me.spotLightShadows.value=H.state.spotShadow,Me.rectAreaLights.value=H.state.rectArea,Me.ltc_1.value=H.state.rectAreaLTC1,Me.ltc_2.value=H.state.rectAreaLTC2,Me.pointLights.value=H.state.point,Me.pointLightShadows.value=H.state.pointShadow,Me.hemisphereLights.value=H.state.hemi,Me.directionalShadowMatrix.value=H.state.directionalShadowMatrix,Me.spotLightMatrix.value=H.state.spotLightMatrix,Me.spotLightMap.value=H.state.spotLightMap,Me.pointShadowMatrix.value=H.state.pointShadowMatrix),W.lightProbeGrid=w.state.lightProbeGridArray.length>0,W.currentProgram=Ve,W.uniformsList=null,Ve}function ru(A){if(A.uniformsList===null){const k=A.currentProgram.getUniforms();A.uniformsList=qr.seqWithValue(k.seq,A.uniforms)}return A.uniformsList}function ou(A,k){const j=R.get(A);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=k.vertexTangents,j.toneMapping=k.toneMapping}function Cg(A,k){if(A.length===0)return null;if(A.length===1)return A[0].texture!==null?A[0]:null;v.setFromMatrixPosition(k.matrixWorld);for(let j=0,W=A.length;j<W;j++){const H=A[j];if(H.texture!==null&&H.boundingBox.containsPoint(v))return H}return null}function Ug(A,k,j,W,H){k.isScene!==!0&&(k=Tt),E.resetTextureUnits();const fe=k.fog,_e=W.isMeshStandardMaterial||W.isMeshLambertMaterial||W.isMeshPhongMaterial?k.environment:null,he=P===null?T.outputColorSpace:P.isXRRenderTarget===!0?P.texture.colorSpace:je.workingColorSpace,xe=W.isMeshStandardMaterial||W.isMeshLambertMaterial&&!W.envMap||W.isMeshPhongMaterial&&!W.envMap,Se=G.get(W.envMap||_e,xe),Fe=W.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,Ve=!!j.attributes.tangent&&(!!W.normalMap||W.anisotropy>0),Me=!!j.morphAttributes.position,at=!!j.morphAttributes.normal,vt=!!j.morphAttributes.color;let gt=Jn;W.toneMapped&&(P===null||P.isXRRenderTarget===!0)&&(gt=T.toneMapping);const ot=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,jt=ot!==void 0?ot.length:0,ge=R.get(W),ln=w.state.lights;if(rt===!0&&(We===!0||A!==V)){const dt=A===V&&W.id===B;be.setState(W,A,dt)}let Ye=!1;W.version===ge.__version?(ge.needsLights&&ge.lightsStateVersion!==ln.state.version||ge.outputColorSpace!==he||H.isBatchedMesh&&ge.batching===!1||!H.isBatchedMesh&&ge.batching===!0||H.isBatchedMesh&&ge.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&ge.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&ge.instancing===!1||!H.isInstancedMesh&&ge.instancing===!0||H.isSkinnedMesh&&ge.skinning===!1||!H.isSkinnedMesh&&ge.skinning===!0||H.isInstancedMesh&&ge.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&ge.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&ge.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&ge.instancingMorph===!1&&H.morphTexture!==null||ge.envMap!==Se||W.fog===!0&&ge.fog!==fe||ge.numClippingPlanes!==void 0&&(ge.numClippingPlanes!==be.numPlanes||ge.numIntersection!==be.numIntersection)||ge.vertexAlphas!==Fe||ge.vertexTangents!==Ve||ge.morphTargets!==Me||ge.morphNormals!==at||ge.morphColors!==vt||ge.toneMapping!==gt||ge.morphTargetsCount!==jt||!!ge.lightProbeGrid!=w.state.lightProbeGridArray.length>0)&&(Ye=!0):(Ye=!0,ge.__version=W.version);let pn=ge.currentProgram;Ye===!0&&(pn=Js(W,k,H),C&&W.isNodeMaterial&&C.onUpdateProgram(W,pn,ge));let Bn=!1,yi=!1,ca=!1;const ct=pn.getUniforms(),yt=ge.uniforms;if(de.useProgram(pn.program)&&(Bn=!0,yi=!0,ca=!0),W.id!==B&&(B=W.id,yi=!0),ge.needsLights){const dt=Cg(w.state.lightProbeGridArray,H);ge.lightProbeGrid!==dt&&(ge.lightProbeGrid=dt,yi=!0)}if(Bn||V!==A){de.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ct.setValue(O,"projectionMatrix",A.projectionMatrix),ct.setValue(O,"viewMatrix",A.matrixWorldInverse);const Ei=ct.map.cameraPosition;Ei!==void 0&&Ei.setValue(O,ht.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&ct.setValue(O,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(W.isMeshPhongMaterial||W.isMeshToonMaterial||W.isMeshLambertMaterial||W.isMeshBasicMaterial||W.isMeshStandardMaterial||W.isShaderMaterial)&&ct.setValue(O,"isOrthographic",A.isOrthographicCamera===!0),V!==A&&(V=A,yi=!0,ca=!0)}if(ge.needsLights&&(ln.state.directionalShadowMap.length>0&&ct.setValue(O,"directionalShadowMap",ln.state.directionalShadowMap,E),ln.state.spotShadowMap.length>0&&ct.setValue(O,"spotShadowMap",ln.state.spotShadowMap,E),ln.state.pointShadowMap.length>0&&ct.setValue(O,"pointShadowMap",ln.state.pointShadowMap,E)),H.isSkinnedMesh){ct.setOptional(O,H,"bindMatrix"),ct.setOptional(O,H,"bindMatrixInverse");const dt=H.skeleton;dt&&(dt.boneTexture===null&&dt.computeBoneTexture(),ct.setValue(O,"boneTexture",dt.boneTexture,E))}H.isBatchedMesh&&(ct.setOptional(O,H,"batchingTexture"),ct.setValue(O,"batchingTexture",H._matricesTexture,E),ct.setOptional(O,H,"batchingIdTexture"),ct.setValue(O,"batchingIdTexture",H._indirectTexture,E),ct.setOptional(O,H,"batchingColorTexture"),H._colorsTexture!==null&&ct.setValue(O,"batchingColorTexture",H._colorsTexture,E));const xi=j.morphAttributes;if((xi.position!==void 0||xi.normal!==void 0||xi.color!==void 0)&&Ue.update(H,j,pn),(yi||ge.receiveShadow!==H.receiveShadow)&&(ge.receiveShadow=H.receiveShadow,ct.setValue(O,"receiveShadow",H.receiveShadow)),(W.isMeshStandardMaterial||W.isMeshLambertMaterial||W.isMeshPhongMaterial)&&W.envMap===null&&k.environment!==null&&(yt.envMapIntensity.value=k.environmentIntensity),yt.dfgLUT!==void 0&&(yt.dfgLUT.value=gE()),yi){if(ct.setValue(O,"toneMappingExposure",T.toneMappingExposure),ge.needsLights&&Pg(yt,ca),fe&&W.fog===!0&&X.refreshFogUniforms(yt,fe),X.refreshMaterialUniforms(yt,W,Re,$e,w.state.transmissionRenderTarget[A.id]),ge.needsLights&&ge.lightProbeGrid){const dt=ge.lightProbeGrid;yt.probesSH.value=dt.texture,yt.probesMin.value.copy(dt.boundingBox.min),yt.probesMax.value.copy(dt.boundingBox.max),yt.probesResolution.value.copy(dt.resolution)}qr.upload(O,ru(ge),yt,E)}if(W.isShaderMaterial&&W.uniformsNeedUpdate===!0&&(qr.upload(O,ru(ge),yt,E),W.uniformsNeedUpdate=!1),W.isSpriteMaterial&&ct.setValue(O,"center",H.center),ct.setValue(O,"modelViewMatrix",H.modelViewMatrix),ct.setValue(O,"normalMatrix",H.normalMatrix),ct.setValue(O,"modelMatrix",H.matrixWorld),W.uniformsGroups!==void 0){const dt=W.uniformsGroups;for(let Ei=0,la=dt.length;Ei<la;Ei++){const cu=dt[Ei];Y.update(cu,pn),Y.bind(cu,pn)}}return pn}function Pg(A,k){A.ambientLightColor.needsUpdate=k,A.lightProbe.needsUpdate=k,A.directionalLights.needsUpdate=k,A.directionalLightShadows.needsUpdate=k,A.pointLights.needsUpdate=k,A.pointLightShadows.needsUpdate=k,A.spotLights.needsUpdate=k,A.spotLightShadows.needsUpdate=k,A.rectAreaLights.needsUpdate=k,A.hemisphereLights.needsUpdate=k}function Lg(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return L},this.getActiveMipmapLevel=function(){return F},this.getRenderTarget=function(){return P},this.setRenderTargetTextures=function(A,k,j){const W=R.get(A);W.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,W.__autoAllocateDepthBuffer===!1&&(W.__useRenderToTexture=!1),R.get(A.texture).__webglTexture=k,R.get(A.depthTexture).__webglTexture=W.__autoAllocateDepthBuffer?void 0:j,W.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,k){const j=R.get(A);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0};const Dg=O.createFramebuffer();this.setRenderTarget=function(A,k=0,j=0){P=A,L=k,F=j;let W=null,H=!1,fe=!1;if(A){const he=R.get(A);if(he.__useDefaultFramebuffer!==void 0){de.bindFramebuffer(O.FRAMEBUFFER,he.__webglFramebuffer),q.copy(A.viewport),ee.copy(A.scissor),le=A.scissorTest,de.viewport(q),de.scissor(ee),de.setScissorTest(le),B=-1;return}else if(he.__webglFramebuffer===void 0)E.setupRenderTarget(A);else if(he.__hasExternalTextures)E.rebindTextures(A,R.get(A.texture).__webglTexture,R.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){const Fe=A.depthTexture;if(he.__boundDepthTexture!==Fe){if(Fe!==null&&R.has(Fe)&&(A.width!==Fe.image.width||A.height!==Fe.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");E.setupDepthRenderbuffer(A)}}const xe=A.texture;(xe.isData3DTexture||xe.isDataArrayTexture||xe.isCompressedArrayTexture)&&(fe=!0);const Se=R.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Se[k])?W=Se[k][j]:W=Se[k],H=!0):A.samples>0&&E.useMultisampledRTT(A)===!1?W=R.get(A).__webglMultisampledFramebuffer:Array.isArray(Se)?W=Se[j]:W=Se,q.copy(A.viewport),ee.copy(A.scissor),le=A.scissorTest}else q.copy(ae).multiplyScalar(Re).floor(),ee.copy(Te).multiplyScalar(Re).floor(),le=Ce;if(j!==0&&(W=Dg),de.bindFramebuffer(O.FRAMEBUFFER,W)&&de.drawBuffers(A,W),de.viewport(q),de.scissor(ee),de.setScissorTest(le),H){const he=R.get(A.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+k,he.__webglTexture,j)}else if(fe){const he=k;for(let xe=0;xe<A.textures.length;xe++){const Se=R.get(A.textures[xe]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+xe,Se.__webglTexture,j,he)}}else if(A!==null&&j!==0){const he=R.get(A.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,he.__webglTexture,j)}B=-1},this.readRenderTargetPixels=function(A,k,j,W,H,fe,_e,he=0){if(!(A&&A.isWebGLRenderTarget)){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xe=R.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&_e!==void 0&&(xe=xe[_e]),xe){de.bindFramebuffer(O.FRAMEBUFFER,xe);try{const Se=A.textures[he],Fe=Se.format,Ve=Se.type;if(A.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+he),!lt.textureFormatReadable(Fe)){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!lt.textureTypeReadable(Ve)){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=A.width-W&&j>=0&&j<=A.height-H&&O.readPixels(k,j,W,H,D.convert(Fe),D.convert(Ve),fe)}finally{const Se=P!==null?R.get(P).__webglFramebuffer:null;de.bindFramebuffer(O.FRAMEBUFFER,Se)}}},this.readRenderTargetPixelsAsync=async function(A,k,j,W,H,fe,_e,he=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xe=R.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&_e!==void 0&&(xe=xe[_e]),xe)if(k>=0&&k<=A.width-W&&j>=0&&j<=A.height-H){de.bindFramebuffer(O.FRAMEBUFFER,xe);const Se=A.textures[he],Fe=Se.format,Ve=Se.type;if(A.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+he),!lt.textureFormatReadable(Fe))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!lt.textureTypeReadable(Ve))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const Me=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,Me),O.bufferData(O.PIXEL_PACK_BUFFER,fe.byteLength,O.STREAM_READ),O.readPixels(k,j,W,H,D.convert(Fe),D.convert(Ve),0);const at=P!==null?R.get(P).__webglFramebuffer:null;de.bindFramebuffer(O.FRAMEBUFFER,at);const vt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await vb(O,vt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,Me),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,fe),O.deleteBuffer(Me),O.deleteSync(vt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,k=null,j=0){const W=Math.pow(2,-j),H=Math.floor(A.image.width*W),fe=Math.floor(A.image.height*W),_e=k!==null?k.x:0,he=k!==null?k.y:0;E.setTexture2D(A,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,_e,he,H,fe),de.unbindTexture()};const Og=O.createFramebuffer(),Fg=O.createFramebuffer();this.copyTextureToTexture=function(A,k,j=null,W=null,H=0,fe=0){let _e,he,xe,Se,Fe,Ve,Me,at,vt;const gt=A.isCompressedTexture?A.mipmaps[fe]:A.image;if(j!==null)_e=j.max.x-j.min.x,he=j.max.y-j.min.y,xe=j.isBox3?j.max.z-j.min.z:1,Se=j.min.x,Fe=j.min.y,Ve=j.isBox3?j.min.z:0;else{const yt=Math.pow(2,-H);_e=Math.floor(gt.width*yt),he=Math.floor(gt.height*yt),A.isDataArrayTexture?xe=gt.depth:A.isData3DTexture?xe=Math.floor(gt.depth*yt):xe=1,Se=0,Fe=0,Ve=0}W!==null?(Me=W.x,at=W.y,vt=W.z):(Me=0,at=0,vt=0);const ot=D.convert(k.format),jt=D.convert(k.type);let ge;k.isData3DTexture?(E.setTexture3D(k,0),ge=O.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(E.setTexture2DArray(k,0),ge=O.TEXTURE_2D_ARRAY):(E.setTexture2D(k,0),ge=O.TEXTURE_2D),de.activeTexture(O.TEXTURE0),de.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,k.flipY),de.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),de.pixelStorei(O.UNPACK_ALIGNMENT,k.unpackAlignment);const ln=de.getParameter(O.UNPACK_ROW_LENGTH),Ye=de.getParameter(O.UNPACK_IMAGE_HEIGHT),pn=de.getParameter(O.UNPACK_SKIP_PIXELS),Bn=de.getParameter(O.UNPACK_SKIP_ROWS),yi=de.getParameter(O.UNPACK_SKIP_IMAGES);de.pixelStorei(O.UNPACK_ROW_LENGTH,gt.width),de.pixelStorei(O.UNPACK_IMAGE_HEIGHT,gt.height),de.pixelStorei(O.UNPACK_SKIP_PIXELS,Se),de.pixelStorei(O.UNPACK_SKIP_ROWS,Fe),de.pixelStorei(O.UNPACK_SKIP_IMAGES,Ve);const ca=A.isDataArrayTexture||A.isData3DTexture,ct=k.isDataArrayTexture||k.isData3DTexture;if(A.isDepthTexture){const yt=R.get(A),xi=R.get(k),dt=R.get(yt.__renderTarget),Ei=R.get(xi.__renderTarget);de.bindFramebuffer(O.READ_FRAMEBUFFER,dt.__webglFramebuffer),de.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ei.__webglFramebuffer);for(let la=0;la<xe;la++)ca&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,R.get(A).__webglTexture,H,Ve+la),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,R.get(k).__webglTexture,fe,vt+la)),O.blitFramebuffer(Se,Fe,_e,he,Me,at,_e,he,O.DEPTH_BUFFER_BIT,O.NEAREST);de.bindFramebuffer(O.READ_FRAMEBUFFER,null),de.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(H!==0||A.isRenderTargetTexture||R.has(A)){const yt=R.get(A),xi=R.get(k);de.bindFramebuffer(O.READ_FRAMEBUFFER,Og),de.bindFramebuffer(O.DRAW_FRAMEBUFFER,Fg);for(let dt=0;dt<xe;dt++)ca?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,yt.__webglTexture,H,Ve+dt):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,yt.__webglTexture,H),ct?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,xi.__webglTexture,fe,vt+dt):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,xi.__webglTexture,fe),H!==0?O.blitFramebuffer(Se,Fe,_e,he,Me,at,_e,he,O.COLOR_BUFFER_BIT,O.NEAREST):ct?O.copyTexSubImage3D(ge,fe,Me,at,vt+dt,Se,Fe,_e,he):O.copyTexSubImage2D(ge,fe,Me,at,Se,Fe,_e,he);de.bindFramebuffer(O.READ_FRAMEBUFFER,null),de.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else ct?A.isDataTexture||A.isData3DTexture?O.texSubImage3D(ge,fe,Me,at,vt,_e,he,xe,ot,jt,gt.data):k.isCompressedArrayTexture?O.compressedTexSubImage3D(ge,fe,Me,at,vt,_e,he,xe,ot,gt.data):O.texSubImage3D(ge,fe,Me,at,vt,_e,he,xe,ot,jt,gt):A.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,fe,Me,at,_e,he,ot,jt,gt.data):A.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,fe,Me,at,gt.width,gt.height,ot,gt.data):O.texSubImage2D(O.TEXTURE_2D,fe,Me,at,_e,he,ot,jt,gt);de.pixelStorei(O.UNPACK_ROW_LENGTH,ln),de.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Ye),de.pixelStorei(O.UNPACK_SKIP_PIXELS,pn),de.pixelStorei(O.UNPACK_SKIP_ROWS,Bn),de.pixelStorei(O.UNPACK_SKIP_IMAGES,yi),fe===0&&k.generateMipmaps&&O.generateMipmap(ge),de.unbindTexture()},this.initRenderTarget=function(A){R.get(A).__webglFramebuffer===void 0&&E.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?E.setTextureCube(A,0):A.isData3DTexture?E.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?E.setTexture2DArray(A,0):E.setTexture2D(A,0),de.unbindTexture()},this.resetState=function(){L=0,F=0,P=null,de.reset(),ie.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Kn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=je._getDrawingBufferColorSpace(e),t.unpackColorSpace=je._getUnpackColorSpace()}}function Ls(n){let e=!1;const t=[];for(let i=0;i<n.length;i++){let a=n.charAt(i);switch(a){case"_":e=!0;break;case"0":case"1":case"2":case"3":case"4":case"5":case"6":case"7":case"8":case"9":t.push(a),e=!1;break;default:e&&(e=!1,a=a.toUpperCase()),t.push(a);break}}return t.join("")}const _E=new Set(["constructor","toString","toJSON","valueOf"]);function Ds(n){return _E.has(n)?n+"$":n}function vE(){let n=0,e=0;for(let i=0;i<28;i+=7){let a=this.buf[this.pos++];if(n|=(a&127)<<i,(a&128)==0)return this.assertBounds(),[n,e]}let t=this.buf[this.pos++];if(n|=(t&15)<<28,e=(t&112)>>4,(t&128)==0)return this.assertBounds(),[n,e];for(let i=3;i<=31;i+=7){let a=this.buf[this.pos++];if(e|=(a&127)<<i,(a&128)==0)return this.assertBounds(),[n,e]}throw new Error("invalid varint")}function bc(n,e,t){for(let s=0;s<28;s=s+7){const r=n>>>s,o=!(!(r>>>7)&&e==0),c=(o?r|128:r)&255;if(t.push(c),!o)return}const i=n>>>28&15|(e&7)<<4,a=e>>3!=0;if(t.push((a?i|128:i)&255),!!a){for(let s=3;s<31;s=s+7){const r=e>>>s,o=!!(r>>>7),c=(o?r|128:r)&255;if(t.push(c),!o)return}t.push(e>>>31&1)}}const $r=4294967296;function hh(n){const e=n[0]==="-";e&&(n=n.slice(1));const t=1e6;let i=0,a=0;function s(r,o){const c=Number(n.slice(r,o));a*=t,i=i*t+c,i>=$r&&(a=a+(i/$r|0),i=i%$r)}return s(-24,-18),s(-18,-12),s(-12,-6),s(-6),e?im(i,a):_d(i,a)}function yE(n,e){let t=_d(n,e);const i=t.hi&2147483648;i&&(t=im(t.lo,t.hi));const a=nm(t.lo,t.hi);return i?"-"+a:a}function nm(n,e){if({lo:n,hi:e}=xE(n,e),e<=2097151)return String($r*e+n);const t=n&16777215,i=(n>>>24|e<<8)&16777215,a=e>>16&65535;let s=t+i*6777216+a*6710656,r=i+a*8147497,o=a*2;const c=1e7;return s>=c&&(r+=Math.floor(s/c),s%=c),r>=c&&(o+=Math.floor(r/c),r%=c),o.toString()+fh(r)+fh(s)}function xE(n,e){return{lo:n>>>0,hi:e>>>0}}function _d(n,e){return{lo:n|0,hi:e|0}}function im(n,e){return e=~e,n?n=~n+1:e+=1,_d(n,e)}const fh=n=>{const e=String(n);return"0000000".slice(e.length)+e};function ph(n,e){if(n>=0){for(;n>127;)e.push(n&127|128),n=n>>>7;e.push(n)}else{for(let t=0;t<9;t++)e.push(n&127|128),n=n>>7;e.push(1)}}function EE(){let n=this.buf[this.pos++],e=n&127;if((n&128)==0)return this.assertBounds(),e;if(n=this.buf[this.pos++],e|=(n&127)<<7,(n&128)==0)return this.assertBounds(),e;if(n=this.buf[this.pos++],e|=(n&127)<<14,(n&128)==0)return this.assertBounds(),e;if(n=this.buf[this.pos++],e|=(n&127)<<21,(n&128)==0)return this.assertBounds(),e;n=this.buf[this.pos++],e|=(n&15)<<28;for(let t=5;(n&128)!==0&&t<10;t++)n=this.buf[this.pos++];if((n&128)!=0)throw new Error("invalid varint");return this.assertBounds(),e>>>0}var mh={};const ft=SE();function SE(){const n=new DataView(new ArrayBuffer(8));if(typeof BigInt=="function"&&typeof n.getBigInt64=="function"&&typeof n.getBigUint64=="function"&&typeof n.setBigInt64=="function"&&typeof n.setBigUint64=="function"&&(typeof process!="object"||typeof mh!="object"||mh.BUF_BIGINT_DISABLE!=="1")){const t=BigInt("-9223372036854775808"),i=BigInt("9223372036854775807"),a=BigInt("0"),s=BigInt("18446744073709551615");return{zero:BigInt(0),supported:!0,parse(r){const o=typeof r=="bigint"?r:BigInt(r);if(o>i||o<t)throw new Error(`invalid int64: ${r}`);return o},uParse(r){const o=typeof r=="bigint"?r:BigInt(r);if(o>s||o<a)throw new Error(`invalid uint64: ${r}`);return o},enc(r){return n.setBigInt64(0,this.parse(r),!0),{lo:n.getInt32(0,!0),hi:n.getInt32(4,!0)}},uEnc(r){return n.setBigInt64(0,this.uParse(r),!0),{lo:n.getInt32(0,!0),hi:n.getInt32(4,!0)}},dec(r,o){return n.setInt32(0,r,!0),n.setInt32(4,o,!0),n.getBigInt64(0,!0)},uDec(r,o){return n.setInt32(0,r,!0),n.setInt32(4,o,!0),n.getBigUint64(0,!0)}}}return{zero:"0",supported:!1,parse(t){return typeof t!="string"&&(t=t.toString()),gh(t),t},uParse(t){return typeof t!="string"&&(t=t.toString()),bh(t),t},enc(t){return typeof t!="string"&&(t=t.toString()),gh(t),hh(t)},uEnc(t){return typeof t!="string"&&(t=t.toString()),bh(t),hh(t)},dec(t,i){return yE(t,i)},uDec(t,i){return nm(t,i)}}}function gh(n){if(!/^-?[0-9]+$/.test(n))throw new Error("invalid int64: "+n)}function bh(n){if(!/^[0-9]+$/.test(n))throw new Error("invalid uint64: "+n)}var z;(function(n){n[n.DOUBLE=1]="DOUBLE",n[n.FLOAT=2]="FLOAT",n[n.INT64=3]="INT64",n[n.UINT64=4]="UINT64",n[n.INT32=5]="INT32",n[n.FIXED64=6]="FIXED64",n[n.FIXED32=7]="FIXED32",n[n.BOOL=8]="BOOL",n[n.STRING=9]="STRING",n[n.BYTES=12]="BYTES",n[n.UINT32=13]="UINT32",n[n.SFIXED32=15]="SFIXED32",n[n.SFIXED64=16]="SFIXED64",n[n.SINT32=17]="SINT32",n[n.SINT64=18]="SINT64"})(z||(z={}));function ra(n,e){switch(n){case z.STRING:return"";case z.BOOL:return!1;case z.DOUBLE:case z.FLOAT:return 0;case z.INT64:case z.UINT64:case z.SFIXED64:case z.FIXED64:case z.SINT64:return e?"0":ft.zero;case z.BYTES:return new Uint8Array(0);default:return 0}}function ME(n,e){switch(n){case z.BOOL:return e===!1;case z.STRING:return e==="";case z.BYTES:return e instanceof Uint8Array&&!e.byteLength;default:return e==0}}const am=2,di=Symbol.for("reflect unsafe local");function sm(n,e){const t=n[e.localName].case;return t===void 0?t:e.fields.find(i=>i.localName===t)}function AE(n,e){const t=e.localName;if(e.oneof)return n[e.oneof.localName].case===t;if(e.presence!=am)return n[t]!==void 0&&Object.prototype.hasOwnProperty.call(n,t);switch(e.fieldKind){case"list":return n[t].length>0;case"map":return Object.keys(n[t]).length>0;case"scalar":return!ME(e.scalar,n[t]);case"enum":return n[t]!==e.enum.values[0].number}throw new Error("message field with implicit presence")}function Os(n,e){return Object.prototype.hasOwnProperty.call(n,e)&&n[e]!==void 0}function rm(n,e){if(e.oneof){const t=n[e.oneof.localName];return t.case===e.localName?t.value:void 0}return n[e.localName]}function om(n,e,t){e.oneof?n[e.oneof.localName]={case:e.localName,value:t}:n[e.localName]=t}function wE(n,e){const t=e.localName;if(e.oneof){const i=e.oneof.localName;n[i].case===t&&(n[i]={case:void 0})}else if(e.presence!=am)delete n[t];else switch(e.fieldKind){case"map":n[t]={};break;case"list":n[t]=[];break;case"enum":n[t]=e.enum.values[0].number;break;case"scalar":n[t]=ra(e.scalar,e.longAsString);break}}function vd(n){for(const e of n.field)Os(e,"jsonName")||(e.jsonName=Ls(e.name));n.nestedType.forEach(vd)}function TE(n,e){const t=n.values.find(i=>i.name===e);if(!t)throw new Error(`cannot parse ${n} default value: ${e}`);return t.number}function IE(n,e){switch(n){case z.STRING:return e;case z.BYTES:{const t=NE(e);if(t===!1)throw new Error(`cannot parse ${z[n]} default value: ${e}`);return t}case z.INT64:case z.SFIXED64:case z.SINT64:return ft.parse(e);case z.UINT64:case z.FIXED64:return ft.uParse(e);case z.DOUBLE:case z.FLOAT:switch(e){case"inf":return Number.POSITIVE_INFINITY;case"-inf":return Number.NEGATIVE_INFINITY;case"nan":return Number.NaN;default:return parseFloat(e)}case z.BOOL:return e==="true";case z.INT32:case z.UINT32:case z.SINT32:case z.FIXED32:case z.SFIXED32:return parseInt(e,10)}}function NE(n){const e=[],t={tail:n,c:"",next(){return this.tail.length==0?!1:(this.c=this.tail[0],this.tail=this.tail.substring(1),!0)},take(i){if(this.tail.length>=i){const a=this.tail.substring(0,i);return this.tail=this.tail.substring(i),a}return!1}};for(;t.next();)switch(t.c){case"\\":if(t.next())switch(t.c){case"\\":e.push(t.c.charCodeAt(0));break;case"b":e.push(8);break;case"f":e.push(12);break;case"n":e.push(10);break;case"r":e.push(13);break;case"t":e.push(9);break;case"v":e.push(11);break;case"0":case"1":case"2":case"3":case"4":case"5":case"6":case"7":{const i=t.c,a=t.take(2);if(a===!1)return!1;const s=parseInt(i+a,8);if(Number.isNaN(s))return!1;e.push(s);break}case"x":{const i=t.c,a=t.take(2);if(a===!1)return!1;const s=parseInt(i+a,16);if(Number.isNaN(s))return!1;e.push(s);break}case"u":{const i=t.c,a=t.take(4);if(a===!1)return!1;const s=parseInt(i+a,16);if(Number.isNaN(s))return!1;const r=new Uint8Array(4);new DataView(r.buffer).setInt32(0,s,!0),e.push(r[0],r[1],r[2],r[3]);break}case"U":{const i=t.c,a=t.take(8);if(a===!1)return!1;const s=ft.uEnc(i+a),r=new Uint8Array(8),o=new DataView(r.buffer);o.setInt32(0,s.lo,!0),o.setInt32(4,s.hi,!0),e.push(r[0],r[1],r[2],r[3],r[4],r[5],r[6],r[7]);break}}break;default:e.push(t.c.charCodeAt(0))}return new Uint8Array(e)}function*Bl(n){switch(n.kind){case"file":for(const e of n.messages)yield e,yield*Bl(e);yield*n.enums,yield*n.services,yield*n.extensions;break;case"message":for(const e of n.nestedMessages)yield e,yield*Bl(e);yield*n.nestedEnums,yield*n.nestedExtensions;break}}function cm(...n){const e=RE();if(!n.length)return e;if("$typeName"in n[0]&&n[0].$typeName=="google.protobuf.FileDescriptorSet"){for(const i of n[0].file)xh(i,e);return e}if("$typeName"in n[0]){let r=function(o){const c=[];for(const l of o.dependency){if(e.getFile(l)!=null||s.has(l))continue;const u=a(l);if(!u)throw new Error(`Unable to resolve ${l}, imported by ${o.name}`);"kind"in u?e.addFile(u,!1,!0):(s.add(u.name),c.push(u))}return c.concat(...c.map(r))};var t=r;const i=n[0],a=n[1],s=new Set;for(const o of[i,...r(i)].reverse())xh(o,e)}else for(const i of n)for(const a of i.files)e.addFile(a);return e}function RE(){const n=new Map,e=new Map,t=new Map;return{kind:"registry",types:n,extendees:e,[Symbol.iterator](){return n.values()},get files(){return t.values()},addFile(i,a,s){if(t.set(i.proto.name,i),!a)for(const r of Bl(i))this.add(r);if(s)for(const r of i.dependencies)this.addFile(r,a,s)},add(i){if(i.kind=="extension"){let a=e.get(i.extendee.typeName);a||e.set(i.extendee.typeName,a=new Map),a.set(i.number,i)}n.set(i.typeName,i)},get(i){return n.get(i)},getFile(i){return t.get(i)},getMessage(i){const a=n.get(i);return a?.kind=="message"?a:void 0},getEnum(i){const a=n.get(i);return a?.kind=="enum"?a:void 0},getExtension(i){const a=n.get(i);return a?.kind=="extension"?a:void 0},getExtensionFor(i,a){var s;return(s=e.get(i.typeName))===null||s===void 0?void 0:s.get(a)},getService(i){const a=n.get(i);return a?.kind=="service"?a:void 0}}}const CE=998,UE=999,PE=9,Fs=10,As=11,LE=12,_h=14,yd=3,DE=2,vh=1,OE=0,_c=1,yh=2,FE=3,kE=1,BE=2,VE=1,lm={998:{fieldPresence:1,enumType:2,repeatedFieldEncoding:2,utf8Validation:3,messageEncoding:1,jsonFormat:2,enforceNamingStyle:2,defaultSymbolVisibility:1},999:{fieldPresence:2,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:2,defaultSymbolVisibility:1},1e3:{fieldPresence:1,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:2,defaultSymbolVisibility:1}};function xh(n,e){var t,i;const a={kind:"file",proto:n,deprecated:(i=(t=n.options)===null||t===void 0?void 0:t.deprecated)!==null&&i!==void 0?i:!1,edition:HE(n),name:n.name.replace(/\.proto$/,""),dependencies:jE(n,e),enums:[],messages:[],extensions:[],services:[],toString(){return`file ${n.name}`}},s=new Map,r={get(o){return s.get(o)},add(o){var c;Pn(((c=o.proto.options)===null||c===void 0?void 0:c.mapEntry)===!0),s.set(o.typeName,o)}};for(const o of n.enumType)dm(o,a,void 0,e);for(const o of n.messageType)um(o,a,void 0,e,r);for(const o of n.service)zE(o,a,e);Vl(a,e);for(const o of s.values())zl(o,e,r);for(const o of a.messages)zl(o,e,r),Vl(o,e);e.addFile(a,!0)}function Vl(n,e){switch(n.kind){case"file":for(const t of n.proto.extension){const i=Gl(t,n,e);n.extensions.push(i),e.add(i)}break;case"message":for(const t of n.proto.extension){const i=Gl(t,n,e);n.nestedExtensions.push(i),e.add(i)}for(const t of n.nestedMessages)Vl(t,e);break}}function zl(n,e,t){const i=n.proto.oneofDecl.map(s=>WE(s,n)),a=new Set;for(const s of n.proto.field){const r=ZE(s,i),o=Gl(s,n,e,r,t);n.fields.push(o),n.field[o.localName]=o,r===void 0?n.members.push(o):(r.fields.push(o),a.has(r)||(a.add(r),n.members.push(r)))}for(const s of i.filter(r=>a.has(r)))n.oneofs.push(s);for(const s of n.nestedMessages)zl(s,e,t)}function dm(n,e,t,i){var a,s,r,o,c;const l=XE(n.name,n.value),u={kind:"enum",proto:n,deprecated:(s=(a=n.options)===null||a===void 0?void 0:a.deprecated)!==null&&s!==void 0?s:!1,file:e,parent:t,open:!0,name:n.name,typeName:Eo(n,t,e),value:{},values:[],sharedPrefix:l,toString(){return`enum ${this.typeName}`}};u.open=$E(u),i.add(u);for(const h of n.value){const d=h.name;u.values.push(u.value[h.number]={kind:"enum_value",proto:h,deprecated:(o=(r=h.options)===null||r===void 0?void 0:r.deprecated)!==null&&o!==void 0?o:!1,parent:u,name:d,localName:Ds(l==null?d:d.substring(l.length)),number:h.number,toString(){return`enum value ${u.typeName}.${d}`}})}((c=t?.nestedEnums)!==null&&c!==void 0?c:e.enums).push(u)}function um(n,e,t,i,a){var s,r,o,c;const l={kind:"message",proto:n,deprecated:(r=(s=n.options)===null||s===void 0?void 0:s.deprecated)!==null&&r!==void 0?r:!1,file:e,parent:t,name:n.name,typeName:Eo(n,t,e),fields:[],field:{},oneofs:[],members:[],nestedEnums:[],nestedMessages:[],nestedExtensions:[],toString(){return`message ${this.typeName}`}};((o=n.options)===null||o===void 0?void 0:o.mapEntry)===!0?a.add(l):(((c=t?.nestedMessages)!==null&&c!==void 0?c:e.messages).push(l),i.add(l));for(const u of n.enumType)dm(u,e,l,i);for(const u of n.nestedType)um(u,e,l,i,a)}function zE(n,e,t){var i,a;const s={kind:"service",proto:n,deprecated:(a=(i=n.options)===null||i===void 0?void 0:i.deprecated)!==null&&a!==void 0?a:!1,file:e,name:n.name,typeName:Eo(n,void 0,e),methods:[],method:{},toString(){return`service ${this.typeName}`}};e.services.push(s),t.add(s);for(const r of n.method){const o=GE(r,s,t);s.methods.push(o),s.method[o.localName]=o}}function GE(n,e,t){var i,a,s,r;let o;n.clientStreaming&&n.serverStreaming?o="bidi_streaming":n.clientStreaming?o="client_streaming":n.serverStreaming?o="server_streaming":o="unary";const c=t.getMessage(oi(n.inputType)),l=t.getMessage(oi(n.outputType));Pn(c,`invalid MethodDescriptorProto: input_type ${n.inputType} not found`),Pn(l,`invalid MethodDescriptorProto: output_type ${n.inputType} not found`);const u=n.name;return{kind:"rpc",proto:n,deprecated:(a=(i=n.options)===null||i===void 0?void 0:i.deprecated)!==null&&a!==void 0?a:!1,parent:e,name:u,localName:Ds(u.length?Ds(u[0].toLowerCase()+u.substring(1)):u),methodKind:o,input:c,output:l,idempotency:(r=(s=n.options)===null||s===void 0?void 0:s.idempotencyLevel)!==null&&r!==void 0?r:OE,toString(){return`rpc ${e.typeName}.${u}`}}}function WE(n,e){return{kind:"oneof",proto:n,deprecated:!1,parent:e,fields:[],name:n.name,localName:Ds(Ls(n.name)),toString(){return`oneof ${e.typeName}.${this.name}`}}}function Gl(n,e,t,i,a){var s,r,o;const c=a===void 0,l={kind:"field",proto:n,deprecated:(r=(s=n.options)===null||s===void 0?void 0:s.deprecated)!==null&&r!==void 0?r:!1,name:n.name,number:n.number,scalar:void 0,message:void 0,enum:void 0,presence:KE(n,i,c,e),listKind:void 0,mapKind:void 0,mapKey:void 0,delimitedEncoding:void 0,packed:void 0,longAsString:!1,getDefaultValue:void 0};if(c){const f=e.kind=="file"?e:e.file,g=e.kind=="file"?void 0:e,y=Eo(n,g,f);l.kind="extension",l.file=f,l.parent=g,l.oneof=void 0,l.typeName=y,l.jsonName=`[${y}]`,l.toString=()=>`extension ${y}`;const p=t.getMessage(oi(n.extendee));Pn(p,`invalid FieldDescriptorProto: extendee ${n.extendee} not found`),l.extendee=p}else{const f=e;Pn(f.kind=="message"),l.parent=f,l.oneof=i,l.localName=i?Ls(n.name):Ds(Ls(n.name)),l.jsonName=n.jsonName,l.toString=()=>`field ${f.typeName}.${n.name}`}const u=n.label,h=n.type,d=(o=n.options)===null||o===void 0?void 0:o.jstype;if(u===yd){const f=h==As?a?.get(oi(n.typeName)):void 0;if(f){l.fieldKind="map";const{key:g,value:y}=qE(f);return l.mapKey=g.scalar,l.mapKind=y.fieldKind,l.message=y.message,l.delimitedEncoding=!1,l.enum=y.enum,l.scalar=y.scalar,l}switch(l.fieldKind="list",h){case As:case Fs:l.listKind="message",l.message=t.getMessage(oi(n.typeName)),Pn(l.message),l.delimitedEncoding=Eh(n,e);break;case _h:l.listKind="enum",l.enum=t.getEnum(oi(n.typeName)),Pn(l.enum);break;default:l.listKind="scalar",l.scalar=h,l.longAsString=d==vh;break}return l.packed=JE(n,e),l}switch(h){case As:case Fs:l.fieldKind="message",l.message=t.getMessage(oi(n.typeName)),Pn(l.message,`invalid FieldDescriptorProto: type_name ${n.typeName} not found`),l.delimitedEncoding=Eh(n,e),l.getDefaultValue=()=>{};break;case _h:{const f=t.getEnum(oi(n.typeName));Pn(f!==void 0,`invalid FieldDescriptorProto: type_name ${n.typeName} not found`),l.fieldKind="enum",l.enum=t.getEnum(oi(n.typeName)),l.getDefaultValue=()=>Os(n,"defaultValue")?TE(f,n.defaultValue):void 0;break}default:{l.fieldKind="scalar",l.scalar=h,l.longAsString=d==vh,l.getDefaultValue=()=>Os(n,"defaultValue")?IE(h,n.defaultValue):void 0;break}}return l}function HE(n){switch(n.syntax){case"":case"proto2":return CE;case"proto3":return UE;case"editions":if(n.edition in lm)return n.edition;throw new Error(`${n.name}: unsupported edition`);default:throw new Error(`${n.name}: unsupported syntax "${n.syntax}"`)}}function jE(n,e){return n.dependency.map(t=>{const i=e.getFile(t);if(!i)throw new Error(`Cannot find ${t}, imported by ${n.name}`);return i})}function XE(n,e){const t=YE(n)+"_";for(const i of e){if(!i.name.toLowerCase().startsWith(t))return;const a=i.name.substring(t.length);if(a.length==0||/^\d/.test(a))return}return t}function YE(n){return(n.substring(0,1)+n.substring(1).replace(/[A-Z]/g,e=>"_"+e)).toLowerCase()}function Eo(n,e,t){let i;return e?i=`${e.typeName}.${n.name}`:t.proto.package.length>0?i=`${t.proto.package}.${n.name}`:i=`${n.name}`,i}function oi(n){return n.startsWith(".")?n.substring(1):n}function ZE(n,e){if(!Os(n,"oneofIndex")||n.proto3Optional)return;const t=e[n.oneofIndex];return Pn(t,`invalid FieldDescriptorProto: oneof #${n.oneofIndex} for field #${n.number} not found`),t}function KE(n,e,t,i){if(n.label==DE)return FE;if(n.label==yd)return yh;if(e||n.proto3Optional||t)return _c;const a=Ya("fieldPresence",{proto:n,parent:i});return a==yh&&(n.type==As||n.type==Fs)?_c:a}function JE(n,e){if(n.label!=yd)return!1;switch(n.type){case PE:case LE:case Fs:case As:return!1}const t=n.options;return t&&Os(t,"packed")?t.packed:kE==Ya("repeatedFieldEncoding",{proto:n,parent:e})}function qE(n){const e=n.fields.find(i=>i.number===1),t=n.fields.find(i=>i.number===2);return Pn(e&&e.fieldKind=="scalar"&&e.scalar!=z.BYTES&&e.scalar!=z.FLOAT&&e.scalar!=z.DOUBLE&&t&&t.fieldKind!="list"&&t.fieldKind!="map"),{key:e,value:t}}function $E(n){var e;return VE==Ya("enumType",{proto:n.proto,parent:(e=n.parent)!==null&&e!==void 0?e:n.file})}function Eh(n,e){return n.type==Fs?!0:BE==Ya("messageEncoding",{proto:n,parent:e})}function Ya(n,e){var t,i;const a=(t=e.proto.options)===null||t===void 0?void 0:t.features;if(a){const s=a[n];if(s!=0)return s}if("kind"in e){if(e.kind=="message")return Ya(n,(i=e.parent)!==null&&i!==void 0?i:e.file);const s=lm[e.edition];if(!s)throw new Error(`feature default for edition ${e.edition} not found`);return s[n]}return Ya(n,e.parent)}function Pn(n,e){if(!n)throw new Error(e)}function QE(n){const e=eS(n);return e.messageType.forEach(vd),cm(e,()=>{}).getFile(e.name)}function eS(n){return Object.assign(Object.create({syntax:"",edition:0}),Object.assign(Object.assign({$typeName:"google.protobuf.FileDescriptorProto",dependency:[],publicDependency:[],weakDependency:[],optionDependency:[],service:[],extension:[]},n),{messageType:n.messageType.map(hm),enumType:n.enumType.map(fm)}))}function hm(n){var e,t,i,a,s,r,o,c;return Object.assign(Object.create({visibility:0}),{$typeName:"google.protobuf.DescriptorProto",name:n.name,field:(t=(e=n.field)===null||e===void 0?void 0:e.map(tS))!==null&&t!==void 0?t:[],extension:[],nestedType:(a=(i=n.nestedType)===null||i===void 0?void 0:i.map(hm))!==null&&a!==void 0?a:[],enumType:(r=(s=n.enumType)===null||s===void 0?void 0:s.map(fm))!==null&&r!==void 0?r:[],extensionRange:(c=(o=n.extensionRange)===null||o===void 0?void 0:o.map(u=>Object.assign({$typeName:"google.protobuf.DescriptorProto.ExtensionRange"},u)))!==null&&c!==void 0?c:[],oneofDecl:[],reservedRange:[],reservedName:[]})}function tS(n){return Object.assign(Object.create({label:1,typeName:"",extendee:"",defaultValue:"",oneofIndex:0,jsonName:"",proto3Optional:!1}),Object.assign(Object.assign({$typeName:"google.protobuf.FieldDescriptorProto"},n),{options:n.options?nS(n.options):void 0}))}function nS(n){var e,t,i;return Object.assign(Object.create({ctype:0,packed:!1,jstype:0,lazy:!1,unverifiedLazy:!1,deprecated:!1,weak:!1,debugRedact:!1,retention:0}),Object.assign(Object.assign({$typeName:"google.protobuf.FieldOptions"},n),{targets:(e=n.targets)!==null&&e!==void 0?e:[],editionDefaults:(i=(t=n.editionDefaults)===null||t===void 0?void 0:t.map(s=>Object.assign({$typeName:"google.protobuf.FieldOptions.EditionDefault"},s)))!==null&&i!==void 0?i:[],uninterpretedOption:[]}))}function fm(n){return Object.assign(Object.create({visibility:0}),{$typeName:"google.protobuf.EnumDescriptorProto",name:n.name,reservedName:[],reservedRange:[],value:n.value.map(t=>Object.assign({$typeName:"google.protobuf.EnumValueDescriptorProto"},t))})}function xd(n){const e=aS();let t=n.length*3/4;n[n.length-2]=="="?t-=2:n[n.length-1]=="="&&(t-=1);let i=new Uint8Array(t),a=0,s=0,r,o=0;for(let c=0;c<n.length;c++){if(r=e[n.charCodeAt(c)],r===void 0)switch(n[c]){case"=":s=0;case`
`:case"\r":case"	":case" ":continue;default:throw Error("invalid base64 string")}switch(s){case 0:o=r,s=1;break;case 1:i[a++]=o<<2|(r&48)>>4,o=r,s=2;break;case 2:i[a++]=(o&15)<<4|(r&60)>>2,o=r,s=3;break;case 3:i[a++]=(o&3)<<6|r,s=0;break}}if(s==1)throw Error("invalid base64 string");return i.subarray(0,a)}function iS(n,e="std"){const t=pm(e),i=e=="std";let a="",s=0,r,o=0;for(let c=0;c<n.length;c++)switch(r=n[c],s){case 0:a+=t[r>>2],o=(r&3)<<4,s=1;break;case 1:a+=t[o|r>>4],o=(r&15)<<2,s=2;break;case 2:a+=t[o|r>>6],a+=t[r&63],s=0;break}return s&&(a+=t[o],i&&(a+="=",s==1&&(a+="="))),a}let Er,Sh,wa;function pm(n){return Er||(Er="ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/".split(""),Sh=Er.slice(0,-2).concat("-","_")),n=="url"?Sh:Er}function aS(){if(!wa){wa=[];const n=pm("std");for(let e=0;e<n.length;e++)wa[n[e].charCodeAt(0)]=e;wa[45]=n.indexOf("+"),wa[95]=n.indexOf("/")}return wa}function Ed(n,e){return n!==null&&typeof n=="object"&&"$typeName"in n&&typeof n.$typeName=="string"?e===void 0?!0:e.typeName===n.$typeName:!1}const sS=["FieldValueInvalidError","FieldListRangeError","ForeignFieldError"];class rn extends Error{constructor(e,t,i="FieldValueInvalidError"){super(t),this.name=i,this.field=()=>e}}function rS(n){return n instanceof Error&&sS.includes(n.name)&&"field"in n&&typeof n.field=="function"}function Oi(n){return n!==null&&typeof n=="object"&&!Array.isArray(n)}function Sd(n,e){var t,i,a,s;if(Oi(n)&&di in n&&"add"in n&&"field"in n&&typeof n.field=="function"){if(e!==void 0){const r=e,o=n.field();return r.listKind==o.listKind&&r.scalar===o.scalar&&((t=r.message)===null||t===void 0?void 0:t.typeName)===((i=o.message)===null||i===void 0?void 0:i.typeName)&&((a=r.enum)===null||a===void 0?void 0:a.typeName)===((s=o.enum)===null||s===void 0?void 0:s.typeName)}return!0}return!1}function Md(n,e){var t,i,a,s;if(Oi(n)&&di in n&&"has"in n&&"field"in n&&typeof n.field=="function"){if(e!==void 0){const r=e,o=n.field();return r.mapKey===o.mapKey&&r.mapKind==o.mapKind&&r.scalar===o.scalar&&((t=r.message)===null||t===void 0?void 0:t.typeName)===((i=o.message)===null||i===void 0?void 0:i.typeName)&&((a=r.enum)===null||a===void 0?void 0:a.typeName)===((s=o.enum)===null||s===void 0?void 0:s.typeName)}return!0}return!1}function Ad(n,e){return Oi(n)&&di in n&&"desc"in n&&Oi(n.desc)&&n.desc.kind==="message"&&(e===void 0||n.desc.typeName==e.typeName)}const vc=Symbol.for("@bufbuild/protobuf/text-encoding");function wd(){if(globalThis[vc]==null){const n=new globalThis.TextEncoder,e=new globalThis.TextDecoder;globalThis[vc]={encodeUtf8(t){return n.encode(t)},decodeUtf8(t){return e.decode(t)},checkUtf8(t){try{return encodeURIComponent(t),!0}catch{return!1}}}}return globalThis[vc]}var xt;(function(n){n[n.Varint=0]="Varint",n[n.Bit64=1]="Bit64",n[n.LengthDelimited=2]="LengthDelimited",n[n.StartGroup=3]="StartGroup",n[n.EndGroup=4]="EndGroup",n[n.Bit32=5]="Bit32"})(xt||(xt={}));const mm=34028234663852886e22,gm=-34028234663852886e22,bm=4294967295,_m=2147483647,vm=-2147483648;class Td{constructor(e=wd().encodeUtf8){this.encodeUtf8=e,this.stack=[],this.chunks=[],this.buf=[]}finish(){this.buf.length&&(this.chunks.push(new Uint8Array(this.buf)),this.buf=[]);let e=0;for(let a=0;a<this.chunks.length;a++)e+=this.chunks[a].length;let t=new Uint8Array(e),i=0;for(let a=0;a<this.chunks.length;a++)t.set(this.chunks[a],i),i+=this.chunks[a].length;return this.chunks=[],t}fork(){return this.stack.push({chunks:this.chunks,buf:this.buf}),this.chunks=[],this.buf=[],this}join(){let e=this.finish(),t=this.stack.pop();if(!t)throw new Error("invalid state, fork stack empty");return this.chunks=t.chunks,this.buf=t.buf,this.uint32(e.byteLength),this.raw(e)}tag(e,t){return this.uint32((e<<3|t)>>>0)}raw(e){return this.buf.length&&(this.chunks.push(new Uint8Array(this.buf)),this.buf=[]),this.chunks.push(e),this}uint32(e){for(Mh(e);e>127;)this.buf.push(e&127|128),e=e>>>7;return this.buf.push(e),this}int32(e){return yc(e),ph(e,this.buf),this}bool(e){return this.buf.push(e?1:0),this}bytes(e){return this.uint32(e.byteLength),this.raw(e)}string(e){let t=this.encodeUtf8(e);return this.uint32(t.byteLength),this.raw(t)}float(e){oS(e);let t=new Uint8Array(4);return new DataView(t.buffer).setFloat32(0,e,!0),this.raw(t)}double(e){let t=new Uint8Array(8);return new DataView(t.buffer).setFloat64(0,e,!0),this.raw(t)}fixed32(e){Mh(e);let t=new Uint8Array(4);return new DataView(t.buffer).setUint32(0,e,!0),this.raw(t)}sfixed32(e){yc(e);let t=new Uint8Array(4);return new DataView(t.buffer).setInt32(0,e,!0),this.raw(t)}sint32(e){return yc(e),e=(e<<1^e>>31)>>>0,ph(e,this.buf),this}sfixed64(e){let t=new Uint8Array(8),i=new DataView(t.buffer),a=ft.enc(e);return i.setInt32(0,a.lo,!0),i.setInt32(4,a.hi,!0),this.raw(t)}fixed64(e){let t=new Uint8Array(8),i=new DataView(t.buffer),a=ft.uEnc(e);return i.setInt32(0,a.lo,!0),i.setInt32(4,a.hi,!0),this.raw(t)}int64(e){let t=ft.enc(e);return bc(t.lo,t.hi,this.buf),this}sint64(e){const t=ft.enc(e),i=t.hi>>31,a=t.lo<<1^i,s=(t.hi<<1|t.lo>>>31)^i;return bc(a,s,this.buf),this}uint64(e){const t=ft.uEnc(e);return bc(t.lo,t.hi,this.buf),this}}class Id{constructor(e,t=wd().decodeUtf8){this.decodeUtf8=t,this.varint64=vE,this.uint32=EE,this.buf=e,this.len=e.length,this.pos=0,this.view=new DataView(e.buffer,e.byteOffset,e.byteLength)}tag(){let e=this.uint32(),t=e>>>3,i=e&7;if(t<=0||i<0||i>5)throw new Error("illegal tag: field no "+t+" wire type "+i);return[t,i]}skip(e,t){let i=this.pos;switch(e){case xt.Varint:for(;this.buf[this.pos++]&128;);break;case xt.Bit64:this.pos+=4;case xt.Bit32:this.pos+=4;break;case xt.LengthDelimited:let a=this.uint32();this.pos+=a;break;case xt.StartGroup:for(;;){const[s,r]=this.tag();if(r===xt.EndGroup){if(t!==void 0&&s!==t)throw new Error("invalid end group tag");break}this.skip(r,s)}break;default:throw new Error("cant skip wire type "+e)}return this.assertBounds(),this.buf.subarray(i,this.pos)}assertBounds(){if(this.pos>this.len)throw new RangeError("premature EOF")}int32(){return this.uint32()|0}sint32(){let e=this.uint32();return e>>>1^-(e&1)}int64(){return ft.dec(...this.varint64())}uint64(){return ft.uDec(...this.varint64())}sint64(){let[e,t]=this.varint64(),i=-(e&1);return e=(e>>>1|(t&1)<<31)^i,t=t>>>1^i,ft.dec(e,t)}bool(){let[e,t]=this.varint64();return e!==0||t!==0}fixed32(){return this.view.getUint32((this.pos+=4)-4,!0)}sfixed32(){return this.view.getInt32((this.pos+=4)-4,!0)}fixed64(){return ft.uDec(this.sfixed32(),this.sfixed32())}sfixed64(){return ft.dec(this.sfixed32(),this.sfixed32())}float(){return this.view.getFloat32((this.pos+=4)-4,!0)}double(){return this.view.getFloat64((this.pos+=8)-8,!0)}bytes(){let e=this.uint32(),t=this.pos;return this.pos+=e,this.assertBounds(),this.buf.subarray(t,t+e)}string(){return this.decodeUtf8(this.bytes())}}function yc(n){if(typeof n=="string")n=Number(n);else if(typeof n!="number")throw new Error("invalid int32: "+typeof n);if(!Number.isInteger(n)||n>_m||n<vm)throw new Error("invalid int32: "+n)}function Mh(n){if(typeof n=="string")n=Number(n);else if(typeof n!="number")throw new Error("invalid uint32: "+typeof n);if(!Number.isInteger(n)||n>bm||n<0)throw new Error("invalid uint32: "+n)}function oS(n){if(typeof n=="string"){const e=n;if(n=Number(n),Number.isNaN(n)&&e!=="NaN")throw new Error("invalid float32: "+e)}else if(typeof n!="number")throw new Error("invalid float32: "+typeof n);if(Number.isFinite(n)&&(n>mm||n<gm))throw new Error("invalid float32: "+n)}function Yi(n,e){const t=n.fieldKind=="list"?Sd(e,n):n.fieldKind=="map"?Md(e,n):Nd(n,e);if(t===!0)return;let i;switch(n.fieldKind){case"list":i=`expected ${Em(n)}, got ${Ft(e)}`;break;case"map":i=`expected ${Sm(n)}, got ${Ft(e)}`;break;default:i=uo(n,e,t)}return new rn(n,i)}function Ah(n,e,t){const i=Nd(n,t);if(i!==!0)return new rn(n,`list item #${e+1}: ${uo(n,t,i)}`)}function cS(n,e,t){const i=ym(e,n.mapKey);if(i!==!0)return new rn(n,`invalid map key: ${uo({scalar:n.mapKey},e,i)}`);const a=Nd(n,t);if(a!==!0)return new rn(n,`map entry ${Ft(e)}: ${uo(n,t,a)}`)}function Nd(n,e){return n.scalar!==void 0?ym(e,n.scalar):n.enum!==void 0?n.enum.open?Number.isInteger(e):n.enum.values.some(t=>t.number===e):Ad(e,n.message)}function ym(n,e){switch(e){case z.DOUBLE:return typeof n=="number";case z.FLOAT:return typeof n!="number"?!1:Number.isNaN(n)||!Number.isFinite(n)?!0:n>mm||n<gm?`${n.toFixed()} out of range`:!0;case z.INT32:case z.SFIXED32:case z.SINT32:return typeof n!="number"||!Number.isInteger(n)?!1:n>_m||n<vm?`${n.toFixed()} out of range`:!0;case z.FIXED32:case z.UINT32:return typeof n!="number"||!Number.isInteger(n)?!1:n>bm||n<0?`${n.toFixed()} out of range`:!0;case z.BOOL:return typeof n=="boolean";case z.STRING:return typeof n!="string"?!1:wd().checkUtf8(n)||"invalid UTF8";case z.BYTES:return n instanceof Uint8Array;case z.INT64:case z.SFIXED64:case z.SINT64:if(typeof n=="bigint"||typeof n=="number"||typeof n=="string"&&n.length>0)try{return ft.parse(n),!0}catch{return`${n} out of range`}return!1;case z.FIXED64:case z.UINT64:if(typeof n=="bigint"||typeof n=="number"||typeof n=="string"&&n.length>0)try{return ft.uParse(n),!0}catch{return`${n} out of range`}return!1}}function uo(n,e,t){return t=typeof t=="string"?`: ${t}`:`, got ${Ft(e)}`,n.scalar!==void 0?`expected ${lS(n.scalar)}`+t:n.enum!==void 0?`expected ${n.enum.toString()}`+t:`expected ${xm(n.message)}`+t}function Ft(n){switch(typeof n){case"object":return n===null?"null":n instanceof Uint8Array?`Uint8Array(${n.length})`:Array.isArray(n)?`Array(${n.length})`:Sd(n)?Em(n.field()):Md(n)?Sm(n.field()):Ad(n)?xm(n.desc):Ed(n)?`message ${n.$typeName}`:"object";case"string":return n.length>30?"string":`"${n.split('"').join('\\"')}"`;case"boolean":return String(n);case"number":return String(n);case"bigint":return String(n)+"n";default:return typeof n}}function xm(n){return`ReflectMessage (${n.typeName})`}function Em(n){switch(n.listKind){case"message":return`ReflectList (${n.message.toString()})`;case"enum":return`ReflectList (${n.enum.toString()})`;case"scalar":return`ReflectList (${z[n.scalar]})`}}function Sm(n){switch(n.mapKind){case"message":return`ReflectMap (${z[n.mapKey]}, ${n.message.toString()})`;case"enum":return`ReflectMap (${z[n.mapKey]}, ${n.enum.toString()})`;case"scalar":return`ReflectMap (${z[n.mapKey]}, ${z[n.scalar]})`}}function lS(n){switch(n){case z.STRING:return"string";case z.BOOL:return"boolean";case z.INT64:case z.SINT64:case z.SFIXED64:return"bigint (int64)";case z.UINT64:case z.FIXED64:return"bigint (uint64)";case z.BYTES:return"Uint8Array";case z.DOUBLE:return"number (float64)";case z.FLOAT:return"number (float32)";case z.FIXED32:case z.UINT32:return"number (uint32)";case z.INT32:case z.SFIXED32:case z.SINT32:return"number (int32)"}}function dS(n){return Mm(n.$typeName)}function Xs(n){const e=n.fields[0];return Mm(n.typeName)&&e!==void 0&&e.fieldKind=="scalar"&&e.name=="value"&&e.number==1}function Mm(n){return n.startsWith("google.protobuf.")&&["DoubleValue","FloatValue","Int64Value","UInt64Value","Int32Value","UInt32Value","BoolValue","StringValue","BytesValue"].includes(n.substring(16))}const uS=999,hS=998,Qr=2;function fn(n,e){if(Ed(e,n))return e;const t=bS(n);return e!==void 0&&fS(n,t,e),t}function fS(n,e,t){for(const i of n.members){let a=t[i.localName];if(a==null)continue;let s;if(i.kind=="oneof"){const r=sm(t,i);if(!r)continue;s=r,a=rm(t,r)}else s=i;switch(s.fieldKind){case"message":a=Rd(s,a);break;case"scalar":a=Am(s,a);break;case"list":a=mS(s,a);break;case"map":a=pS(s,a);break}om(e,s,a)}return e}function Am(n,e){return n.scalar==z.BYTES?Cd(e):e}function pS(n,e){if(Oi(e)){if(n.scalar==z.BYTES)return wh(e,Cd);if(n.mapKind=="message")return wh(e,t=>Rd(n,t))}return e}function mS(n,e){if(Array.isArray(e)){if(n.scalar==z.BYTES)return e.map(Cd);if(n.listKind=="message")return e.map(t=>Rd(n,t))}return e}function Rd(n,e){if(n.fieldKind=="message"&&!n.oneof&&Xs(n.message))return Am(n.message.fields[0],e);if(Oi(e)){if(n.message.typeName=="google.protobuf.Struct"&&n.parent.typeName!=="google.protobuf.Value")return e;if(!Ed(e,n.message))return fn(n.message,e)}return e}function Cd(n){return Array.isArray(n)?new Uint8Array(n):n}function wh(n,e){const t={};for(const i of Object.entries(n))t[i[0]]=e(i[1]);return t}const gS=Symbol(),Th=new WeakMap;function bS(n){let e;if(_S(n)){const t=Th.get(n);let i,a;if(t)({prototype:i,members:a}=t);else{i={},a=new Set;for(const s of n.members)s.kind!="oneof"&&(s.fieldKind!="scalar"&&s.fieldKind!="enum"||s.presence!=Qr&&(a.add(s),i[s.localName]=xc(s)));Th.set(n,{prototype:i,members:a})}e=Object.create(i),e.$typeName=n.typeName;for(const s of n.members)a.has(s)||s.kind=="field"&&(s.fieldKind=="message"||(s.fieldKind=="scalar"||s.fieldKind=="enum")&&s.presence!=Qr)||(e[s.localName]=xc(s))}else{e={$typeName:n.typeName};for(const t of n.members)(t.kind=="oneof"||t.presence==Qr)&&(e[t.localName]=xc(t))}return e}function _S(n){switch(n.file.edition){case uS:return!1;case hS:return!0;default:return n.fields.some(e=>e.presence!=Qr&&e.fieldKind!="message"&&!e.oneof)}}function xc(n){if(n.kind=="oneof")return{case:void 0};if(n.fieldKind=="list")return[];if(n.fieldKind=="map")return{};if(n.fieldKind=="message")return gS;const e=n.getDefaultValue();return e!==void 0?n.fieldKind=="scalar"&&n.longAsString?e.toString():e:n.fieldKind=="scalar"?ra(n.scalar,n.longAsString):n.enum.values[0].number}function Tn(n,e,t=!0){return new wm(n,e,t)}class wm{get sortedFields(){var e;return(e=this._sortedFields)!==null&&e!==void 0?e:this._sortedFields=this.desc.fields.concat().sort((t,i)=>t.number-i.number)}constructor(e,t,i=!0){this.lists=new Map,this.maps=new Map,this.check=i,this.desc=e,this.message=this[di]=t??fn(e),this.fields=e.fields,this.oneofs=e.oneofs,this.members=e.members}findNumber(e){return this._fieldsByNumber||(this._fieldsByNumber=new Map(this.desc.fields.map(t=>[t.number,t]))),this._fieldsByNumber.get(e)}oneofCase(e){return ds(this.message,e),sm(this.message,e)}isSet(e){return ds(this.message,e),AE(this.message,e)}clear(e){ds(this.message,e),wE(this.message,e)}get(e){ds(this.message,e);const t=rm(this.message,e);switch(e.fieldKind){case"list":let i=this.lists.get(e);return(!i||i[di]!==t)&&this.lists.set(e,i=new vS(e,t,this.check)),i;case"map":let a=this.maps.get(e);return(!a||a[di]!==t)&&this.maps.set(e,a=new yS(e,t,this.check)),a;case"message":return Pd(e,t,this.check);case"scalar":return t===void 0?ra(e.scalar,!1):Ld(e,t);case"enum":return t??e.enum.values[0].number}}set(e,t){if(ds(this.message,e),this.check){const a=Yi(e,t);if(a)throw a}let i;e.fieldKind=="message"?i=Ud(e,t):Md(t)||Sd(t)?i=t[di]:i=Dd(e,t),om(this.message,e,i)}getUnknown(){return this.message.$unknown}setUnknown(e){this.message.$unknown=e}}function ds(n,e){if(e.parent.typeName!==n.$typeName)throw new rn(e,`cannot use ${e.toString()} with message ${n.$typeName}`,"ForeignFieldError")}class vS{field(){return this._field}get size(){return this._arr.length}constructor(e,t,i){this._field=e,this._arr=this[di]=t,this.check=i}get(e){const t=this._arr[e];return t===void 0?void 0:Ec(this._field,t,this.check)}set(e,t){if(e<0||e>=this._arr.length)throw new rn(this._field,`list item #${e+1}: out of range`);if(this.check){const i=Ah(this._field,e,t);if(i)throw i}this._arr[e]=Ih(this._field,t)}add(e){if(this.check){const t=Ah(this._field,this._arr.length,e);if(t)throw t}this._arr.push(Ih(this._field,e))}clear(){this._arr.splice(0,this._arr.length)}[Symbol.iterator](){return this.values()}keys(){return this._arr.keys()}*values(){for(const e of this._arr)yield Ec(this._field,e,this.check)}*entries(){for(let e=0;e<this._arr.length;e++)yield[e,Ec(this._field,this._arr[e],this.check)]}}class yS{constructor(e,t,i=!0){this.obj=this[di]=t??{},this.check=i,this._field=e}field(){return this._field}set(e,t){if(this.check){const i=cS(this._field,e,t);if(i)throw i}return this.obj[Sr(e)]=xS(this._field,t),this}delete(e){const t=Sr(e),i=Object.prototype.hasOwnProperty.call(this.obj,t);return i&&delete this.obj[t],i}clear(){for(const e of Object.keys(this.obj))delete this.obj[e]}get(e){let t=this.obj[Sr(e)];return t!==void 0&&(t=Sc(this._field,t,this.check)),t}has(e){return Object.prototype.hasOwnProperty.call(this.obj,Sr(e))}*keys(){for(const e of Object.keys(this.obj))yield Nh(e,this._field.mapKey)}*entries(){for(const e of Object.entries(this.obj))yield[Nh(e[0],this._field.mapKey),Sc(this._field,e[1],this.check)]}[Symbol.iterator](){return this.entries()}get size(){return Object.keys(this.obj).length}*values(){for(const e of Object.values(this.obj))yield Sc(this._field,e,this.check)}forEach(e,t){for(const i of this.entries())e.call(t,i[1],i[0],this)}}function Ud(n,e){return Ad(e)?dS(e.message)&&!n.oneof&&n.fieldKind=="message"?e.message.value:e.desc.typeName=="google.protobuf.Struct"&&n.parent.typeName!="google.protobuf.Value"?Im(e.message):e.message:e}function Pd(n,e,t){return e!==void 0&&(Xs(n.message)&&!n.oneof&&n.fieldKind=="message"?e={$typeName:n.message.typeName,value:Ld(n.message.fields[0],e)}:n.message.typeName=="google.protobuf.Struct"&&n.parent.typeName!="google.protobuf.Value"&&Oi(e)&&(e=Tm(e))),new wm(n.message,e,t)}function Ih(n,e){return n.listKind=="message"?Ud(n,e):Dd(n,e)}function Ec(n,e,t){return n.listKind=="message"?Pd(n,e,t):Ld(n,e)}function xS(n,e){return n.mapKind=="message"?Ud(n,e):Dd(n,e)}function Sc(n,e,t){return n.mapKind=="message"?Pd(n,e,t):e}function Sr(n){return typeof n=="string"||typeof n=="number"?n:String(n)}function Nh(n,e){switch(e){case z.STRING:return n;case z.INT32:case z.FIXED32:case z.UINT32:case z.SFIXED32:case z.SINT32:{const t=Number.parseInt(n);if(Number.isFinite(t))return t;break}case z.BOOL:switch(n){case"true":return!0;case"false":return!1}break;case z.UINT64:case z.FIXED64:try{return ft.uParse(n)}catch{}break;default:try{return ft.parse(n)}catch{}break}return n}function Ld(n,e){switch(n.scalar){case z.INT64:case z.SFIXED64:case z.SINT64:"longAsString"in n&&n.longAsString&&typeof e=="string"&&(e=ft.parse(e));break;case z.FIXED64:case z.UINT64:"longAsString"in n&&n.longAsString&&typeof e=="string"&&(e=ft.uParse(e));break}return e}function Dd(n,e){switch(n.scalar){case z.INT64:case z.SFIXED64:case z.SINT64:"longAsString"in n&&n.longAsString?e=String(e):(typeof e=="string"||typeof e=="number")&&(e=ft.parse(e));break;case z.FIXED64:case z.UINT64:"longAsString"in n&&n.longAsString?e=String(e):(typeof e=="string"||typeof e=="number")&&(e=ft.uParse(e));break}return e}function Tm(n){const e={$typeName:"google.protobuf.Struct",fields:{}};if(Oi(n))for(const[t,i]of Object.entries(n))e.fields[t]=Rm(i);return e}function Im(n){const e={};for(const[t,i]of Object.entries(n.fields))e[t]=Nm(i);return e}function Nm(n){switch(n.kind.case){case"structValue":return Im(n.kind.value);case"listValue":return n.kind.value.values.map(Nm);case"nullValue":case void 0:return null;default:return n.kind.value}}function Rm(n){const e={$typeName:"google.protobuf.Value",kind:{case:void 0}};switch(typeof n){case"number":e.kind={case:"numberValue",value:n};break;case"string":e.kind={case:"stringValue",value:n};break;case"boolean":e.kind={case:"boolValue",value:n};break;case"object":if(n===null)e.kind={case:"nullValue",value:0};else if(Array.isArray(n)){const t={$typeName:"google.protobuf.ListValue",values:[]};if(Array.isArray(n))for(const i of n)t.values.push(Rm(i));e.kind={case:"listValue",value:t}}else e.kind={case:"structValue",value:Tm(n)};break}return e}const ES=3,Rh={writeUnknownFields:!0};function SS(n){return n?Object.assign(Object.assign({},Rh),n):Rh}function Od(n,e,t){return ho(new Td,SS(t),Tn(n,e)).finish()}function ho(n,e,t){var i;for(const a of t.sortedFields){if(!t.isSet(a)){if(a.presence==ES)throw new Error(`cannot encode ${a} to binary: required field not set`);continue}Cm(n,e,t,a)}if(e.writeUnknownFields)for(const{no:a,wireType:s,data:r}of(i=t.getUnknown())!==null&&i!==void 0?i:[])n.tag(a,s).raw(r);return n}function Cm(n,e,t,i){var a;switch(i.fieldKind){case"scalar":case"enum":fo(n,t.desc.typeName,i.name,(a=i.scalar)!==null&&a!==void 0?a:z.INT32,i.number,t.get(i));break;case"list":MS(n,e,i,t.get(i));break;case"message":Um(n,e,i,t.get(i));break;case"map":for(const[s,r]of t.get(i))AS(n,e,i,s,r);break}}function fo(n,e,t,i,a,s){Pm(n.tag(a,wS(i)),e,t,i,s)}function Um(n,e,t,i){t.delimitedEncoding?ho(n.tag(t.number,xt.StartGroup),e,i).tag(t.number,xt.EndGroup):ho(n.tag(t.number,xt.LengthDelimited).fork(),e,i).join()}function MS(n,e,t,i){var a;if(t.listKind=="message"){for(const r of i)Um(n,e,t,r);return}const s=(a=t.scalar)!==null&&a!==void 0?a:z.INT32;if(t.packed){if(!i.size)return;n.tag(t.number,xt.LengthDelimited).fork();for(const r of i)Pm(n,t.parent.typeName,t.name,s,r);n.join();return}for(const r of i)fo(n,t.parent.typeName,t.name,s,t.number,r)}function AS(n,e,t,i,a){var s;switch(n.tag(t.number,xt.LengthDelimited).fork(),fo(n,t.parent.typeName,t.name,t.mapKey,1,i),t.mapKind){case"scalar":case"enum":fo(n,t.parent.typeName,t.name,(s=t.scalar)!==null&&s!==void 0?s:z.INT32,2,a);break;case"message":ho(n.tag(2,xt.LengthDelimited).fork(),e,a).join();break}n.join()}function Pm(n,e,t,i,a){try{switch(i){case z.STRING:n.string(a);break;case z.BOOL:n.bool(a);break;case z.DOUBLE:n.double(a);break;case z.FLOAT:n.float(a);break;case z.INT32:n.int32(a);break;case z.INT64:n.int64(a);break;case z.UINT64:n.uint64(a);break;case z.FIXED64:n.fixed64(a);break;case z.BYTES:n.bytes(a);break;case z.FIXED32:n.fixed32(a);break;case z.SFIXED32:n.sfixed32(a);break;case z.SFIXED64:n.sfixed64(a);break;case z.SINT64:n.sint64(a);break;case z.UINT32:n.uint32(a);break;case z.SINT32:n.sint32(a);break}}catch(s){throw s instanceof Error?new Error(`cannot encode field ${e}.${t} to binary: ${s.message}`):s}}function wS(n){switch(n){case z.BYTES:case z.STRING:return xt.LengthDelimited;case z.DOUBLE:case z.FIXED64:case z.SFIXED64:return xt.Bit64;case z.FIXED32:case z.SFIXED32:case z.FLOAT:return xt.Bit32;default:return xt.Varint}}function _i(n,e,...t){return t.reduce((i,a)=>i.nestedMessages[a],n.messages[e])}const TS=QE({name:"google/protobuf/descriptor.proto",package:"google.protobuf",messageType:[{name:"FileDescriptorSet",field:[{name:"file",number:1,type:11,label:3,typeName:".google.protobuf.FileDescriptorProto"}],extensionRange:[{start:536e6,end:536000001}]},{name:"FileDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"package",number:2,type:9,label:1},{name:"dependency",number:3,type:9,label:3},{name:"public_dependency",number:10,type:5,label:3},{name:"weak_dependency",number:11,type:5,label:3},{name:"option_dependency",number:15,type:9,label:3},{name:"message_type",number:4,type:11,label:3,typeName:".google.protobuf.DescriptorProto"},{name:"enum_type",number:5,type:11,label:3,typeName:".google.protobuf.EnumDescriptorProto"},{name:"service",number:6,type:11,label:3,typeName:".google.protobuf.ServiceDescriptorProto"},{name:"extension",number:7,type:11,label:3,typeName:".google.protobuf.FieldDescriptorProto"},{name:"options",number:8,type:11,label:1,typeName:".google.protobuf.FileOptions"},{name:"source_code_info",number:9,type:11,label:1,typeName:".google.protobuf.SourceCodeInfo"},{name:"syntax",number:12,type:9,label:1},{name:"edition",number:14,type:14,label:1,typeName:".google.protobuf.Edition"}]},{name:"DescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"field",number:2,type:11,label:3,typeName:".google.protobuf.FieldDescriptorProto"},{name:"extension",number:6,type:11,label:3,typeName:".google.protobuf.FieldDescriptorProto"},{name:"nested_type",number:3,type:11,label:3,typeName:".google.protobuf.DescriptorProto"},{name:"enum_type",number:4,type:11,label:3,typeName:".google.protobuf.EnumDescriptorProto"},{name:"extension_range",number:5,type:11,label:3,typeName:".google.protobuf.DescriptorProto.ExtensionRange"},{name:"oneof_decl",number:8,type:11,label:3,typeName:".google.protobuf.OneofDescriptorProto"},{name:"options",number:7,type:11,label:1,typeName:".google.protobuf.MessageOptions"},{name:"reserved_range",number:9,type:11,label:3,typeName:".google.protobuf.DescriptorProto.ReservedRange"},{name:"reserved_name",number:10,type:9,label:3},{name:"visibility",number:11,type:14,label:1,typeName:".google.protobuf.SymbolVisibility"}],nestedType:[{name:"ExtensionRange",field:[{name:"start",number:1,type:5,label:1},{name:"end",number:2,type:5,label:1},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.ExtensionRangeOptions"}]},{name:"ReservedRange",field:[{name:"start",number:1,type:5,label:1},{name:"end",number:2,type:5,label:1}]}]},{name:"ExtensionRangeOptions",field:[{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"},{name:"declaration",number:2,type:11,label:3,typeName:".google.protobuf.ExtensionRangeOptions.Declaration",options:{retention:2}},{name:"features",number:50,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"verification",number:3,type:14,label:1,typeName:".google.protobuf.ExtensionRangeOptions.VerificationState",defaultValue:"UNVERIFIED",options:{retention:2}}],nestedType:[{name:"Declaration",field:[{name:"number",number:1,type:5,label:1},{name:"full_name",number:2,type:9,label:1},{name:"type",number:3,type:9,label:1},{name:"reserved",number:5,type:8,label:1},{name:"repeated",number:6,type:8,label:1}]}],enumType:[{name:"VerificationState",value:[{name:"DECLARATION",number:0},{name:"UNVERIFIED",number:1}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"FieldDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"number",number:3,type:5,label:1},{name:"label",number:4,type:14,label:1,typeName:".google.protobuf.FieldDescriptorProto.Label"},{name:"type",number:5,type:14,label:1,typeName:".google.protobuf.FieldDescriptorProto.Type"},{name:"type_name",number:6,type:9,label:1},{name:"extendee",number:2,type:9,label:1},{name:"default_value",number:7,type:9,label:1},{name:"oneof_index",number:9,type:5,label:1},{name:"json_name",number:10,type:9,label:1},{name:"options",number:8,type:11,label:1,typeName:".google.protobuf.FieldOptions"},{name:"proto3_optional",number:17,type:8,label:1}],enumType:[{name:"Type",value:[{name:"TYPE_DOUBLE",number:1},{name:"TYPE_FLOAT",number:2},{name:"TYPE_INT64",number:3},{name:"TYPE_UINT64",number:4},{name:"TYPE_INT32",number:5},{name:"TYPE_FIXED64",number:6},{name:"TYPE_FIXED32",number:7},{name:"TYPE_BOOL",number:8},{name:"TYPE_STRING",number:9},{name:"TYPE_GROUP",number:10},{name:"TYPE_MESSAGE",number:11},{name:"TYPE_BYTES",number:12},{name:"TYPE_UINT32",number:13},{name:"TYPE_ENUM",number:14},{name:"TYPE_SFIXED32",number:15},{name:"TYPE_SFIXED64",number:16},{name:"TYPE_SINT32",number:17},{name:"TYPE_SINT64",number:18}]},{name:"Label",value:[{name:"LABEL_OPTIONAL",number:1},{name:"LABEL_REPEATED",number:3},{name:"LABEL_REQUIRED",number:2}]}]},{name:"OneofDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"options",number:2,type:11,label:1,typeName:".google.protobuf.OneofOptions"}]},{name:"EnumDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"value",number:2,type:11,label:3,typeName:".google.protobuf.EnumValueDescriptorProto"},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.EnumOptions"},{name:"reserved_range",number:4,type:11,label:3,typeName:".google.protobuf.EnumDescriptorProto.EnumReservedRange"},{name:"reserved_name",number:5,type:9,label:3},{name:"visibility",number:6,type:14,label:1,typeName:".google.protobuf.SymbolVisibility"}],nestedType:[{name:"EnumReservedRange",field:[{name:"start",number:1,type:5,label:1},{name:"end",number:2,type:5,label:1}]}]},{name:"EnumValueDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"number",number:2,type:5,label:1},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.EnumValueOptions"}]},{name:"ServiceDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"method",number:2,type:11,label:3,typeName:".google.protobuf.MethodDescriptorProto"},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.ServiceOptions"}]},{name:"MethodDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"input_type",number:2,type:9,label:1},{name:"output_type",number:3,type:9,label:1},{name:"options",number:4,type:11,label:1,typeName:".google.protobuf.MethodOptions"},{name:"client_streaming",number:5,type:8,label:1,defaultValue:"false"},{name:"server_streaming",number:6,type:8,label:1,defaultValue:"false"}]},{name:"FileOptions",field:[{name:"java_package",number:1,type:9,label:1},{name:"java_outer_classname",number:8,type:9,label:1},{name:"java_multiple_files",number:10,type:8,label:1,defaultValue:"false"},{name:"java_generate_equals_and_hash",number:20,type:8,label:1,options:{deprecated:!0}},{name:"java_string_check_utf8",number:27,type:8,label:1,defaultValue:"false"},{name:"optimize_for",number:9,type:14,label:1,typeName:".google.protobuf.FileOptions.OptimizeMode",defaultValue:"SPEED"},{name:"go_package",number:11,type:9,label:1},{name:"cc_generic_services",number:16,type:8,label:1,defaultValue:"false"},{name:"java_generic_services",number:17,type:8,label:1,defaultValue:"false"},{name:"py_generic_services",number:18,type:8,label:1,defaultValue:"false"},{name:"deprecated",number:23,type:8,label:1,defaultValue:"false"},{name:"cc_enable_arenas",number:31,type:8,label:1,defaultValue:"true"},{name:"objc_class_prefix",number:36,type:9,label:1},{name:"csharp_namespace",number:37,type:9,label:1},{name:"swift_prefix",number:39,type:9,label:1},{name:"php_class_prefix",number:40,type:9,label:1},{name:"php_namespace",number:41,type:9,label:1},{name:"php_metadata_namespace",number:44,type:9,label:1},{name:"ruby_package",number:45,type:9,label:1},{name:"features",number:50,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],enumType:[{name:"OptimizeMode",value:[{name:"SPEED",number:1},{name:"CODE_SIZE",number:2},{name:"LITE_RUNTIME",number:3}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"MessageOptions",field:[{name:"message_set_wire_format",number:1,type:8,label:1,defaultValue:"false"},{name:"no_standard_descriptor_accessor",number:2,type:8,label:1,defaultValue:"false"},{name:"deprecated",number:3,type:8,label:1,defaultValue:"false"},{name:"map_entry",number:7,type:8,label:1},{name:"deprecated_legacy_json_field_conflicts",number:11,type:8,label:1,options:{deprecated:!0}},{name:"features",number:12,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"FieldOptions",field:[{name:"ctype",number:1,type:14,label:1,typeName:".google.protobuf.FieldOptions.CType",defaultValue:"STRING"},{name:"packed",number:2,type:8,label:1},{name:"jstype",number:6,type:14,label:1,typeName:".google.protobuf.FieldOptions.JSType",defaultValue:"JS_NORMAL"},{name:"lazy",number:5,type:8,label:1,defaultValue:"false"},{name:"unverified_lazy",number:15,type:8,label:1,defaultValue:"false"},{name:"deprecated",number:3,type:8,label:1,defaultValue:"false"},{name:"weak",number:10,type:8,label:1,defaultValue:"false"},{name:"debug_redact",number:16,type:8,label:1,defaultValue:"false"},{name:"retention",number:17,type:14,label:1,typeName:".google.protobuf.FieldOptions.OptionRetention"},{name:"targets",number:19,type:14,label:3,typeName:".google.protobuf.FieldOptions.OptionTargetType"},{name:"edition_defaults",number:20,type:11,label:3,typeName:".google.protobuf.FieldOptions.EditionDefault"},{name:"features",number:21,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"feature_support",number:22,type:11,label:1,typeName:".google.protobuf.FieldOptions.FeatureSupport"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],nestedType:[{name:"EditionDefault",field:[{name:"edition",number:3,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"value",number:2,type:9,label:1}]},{name:"FeatureSupport",field:[{name:"edition_introduced",number:1,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"edition_deprecated",number:2,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"deprecation_warning",number:3,type:9,label:1},{name:"edition_removed",number:4,type:14,label:1,typeName:".google.protobuf.Edition"}]}],enumType:[{name:"CType",value:[{name:"STRING",number:0},{name:"CORD",number:1},{name:"STRING_PIECE",number:2}]},{name:"JSType",value:[{name:"JS_NORMAL",number:0},{name:"JS_STRING",number:1},{name:"JS_NUMBER",number:2}]},{name:"OptionRetention",value:[{name:"RETENTION_UNKNOWN",number:0},{name:"RETENTION_RUNTIME",number:1},{name:"RETENTION_SOURCE",number:2}]},{name:"OptionTargetType",value:[{name:"TARGET_TYPE_UNKNOWN",number:0},{name:"TARGET_TYPE_FILE",number:1},{name:"TARGET_TYPE_EXTENSION_RANGE",number:2},{name:"TARGET_TYPE_MESSAGE",number:3},{name:"TARGET_TYPE_FIELD",number:4},{name:"TARGET_TYPE_ONEOF",number:5},{name:"TARGET_TYPE_ENUM",number:6},{name:"TARGET_TYPE_ENUM_ENTRY",number:7},{name:"TARGET_TYPE_SERVICE",number:8},{name:"TARGET_TYPE_METHOD",number:9}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"OneofOptions",field:[{name:"features",number:1,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"EnumOptions",field:[{name:"allow_alias",number:2,type:8,label:1},{name:"deprecated",number:3,type:8,label:1,defaultValue:"false"},{name:"deprecated_legacy_json_field_conflicts",number:6,type:8,label:1,options:{deprecated:!0}},{name:"features",number:7,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"EnumValueOptions",field:[{name:"deprecated",number:1,type:8,label:1,defaultValue:"false"},{name:"features",number:2,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"debug_redact",number:3,type:8,label:1,defaultValue:"false"},{name:"feature_support",number:4,type:11,label:1,typeName:".google.protobuf.FieldOptions.FeatureSupport"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"ServiceOptions",field:[{name:"features",number:34,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"deprecated",number:33,type:8,label:1,defaultValue:"false"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"MethodOptions",field:[{name:"deprecated",number:33,type:8,label:1,defaultValue:"false"},{name:"idempotency_level",number:34,type:14,label:1,typeName:".google.protobuf.MethodOptions.IdempotencyLevel",defaultValue:"IDEMPOTENCY_UNKNOWN"},{name:"features",number:35,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],enumType:[{name:"IdempotencyLevel",value:[{name:"IDEMPOTENCY_UNKNOWN",number:0},{name:"NO_SIDE_EFFECTS",number:1},{name:"IDEMPOTENT",number:2}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"UninterpretedOption",field:[{name:"name",number:2,type:11,label:3,typeName:".google.protobuf.UninterpretedOption.NamePart"},{name:"identifier_value",number:3,type:9,label:1},{name:"positive_int_value",number:4,type:4,label:1},{name:"negative_int_value",number:5,type:3,label:1},{name:"double_value",number:6,type:1,label:1},{name:"string_value",number:7,type:12,label:1},{name:"aggregate_value",number:8,type:9,label:1}],nestedType:[{name:"NamePart",field:[{name:"name_part",number:1,type:9,label:2},{name:"is_extension",number:2,type:8,label:2}]}]},{name:"FeatureSet",field:[{name:"field_presence",number:1,type:14,label:1,typeName:".google.protobuf.FeatureSet.FieldPresence",options:{retention:1,targets:[4,1],editionDefaults:[{value:"EXPLICIT",edition:900},{value:"IMPLICIT",edition:999},{value:"EXPLICIT",edition:1e3}]}},{name:"enum_type",number:2,type:14,label:1,typeName:".google.protobuf.FeatureSet.EnumType",options:{retention:1,targets:[6,1],editionDefaults:[{value:"CLOSED",edition:900},{value:"OPEN",edition:999}]}},{name:"repeated_field_encoding",number:3,type:14,label:1,typeName:".google.protobuf.FeatureSet.RepeatedFieldEncoding",options:{retention:1,targets:[4,1],editionDefaults:[{value:"EXPANDED",edition:900},{value:"PACKED",edition:999}]}},{name:"utf8_validation",number:4,type:14,label:1,typeName:".google.protobuf.FeatureSet.Utf8Validation",options:{retention:1,targets:[4,1],editionDefaults:[{value:"NONE",edition:900},{value:"VERIFY",edition:999}]}},{name:"message_encoding",number:5,type:14,label:1,typeName:".google.protobuf.FeatureSet.MessageEncoding",options:{retention:1,targets:[4,1],editionDefaults:[{value:"LENGTH_PREFIXED",edition:900}]}},{name:"json_format",number:6,type:14,label:1,typeName:".google.protobuf.FeatureSet.JsonFormat",options:{retention:1,targets:[3,6,1],editionDefaults:[{value:"LEGACY_BEST_EFFORT",edition:900},{value:"ALLOW",edition:999}]}},{name:"enforce_naming_style",number:7,type:14,label:1,typeName:".google.protobuf.FeatureSet.EnforceNamingStyle",options:{retention:2,targets:[1,2,3,4,5,6,7,8,9],editionDefaults:[{value:"STYLE_LEGACY",edition:900},{value:"STYLE2024",edition:1001}]}},{name:"default_symbol_visibility",number:8,type:14,label:1,typeName:".google.protobuf.FeatureSet.VisibilityFeature.DefaultSymbolVisibility",options:{retention:2,targets:[1],editionDefaults:[{value:"EXPORT_ALL",edition:900},{value:"EXPORT_TOP_LEVEL",edition:1001}]}}],nestedType:[{name:"VisibilityFeature",enumType:[{name:"DefaultSymbolVisibility",value:[{name:"DEFAULT_SYMBOL_VISIBILITY_UNKNOWN",number:0},{name:"EXPORT_ALL",number:1},{name:"EXPORT_TOP_LEVEL",number:2},{name:"LOCAL_ALL",number:3},{name:"STRICT",number:4}]}]}],enumType:[{name:"FieldPresence",value:[{name:"FIELD_PRESENCE_UNKNOWN",number:0},{name:"EXPLICIT",number:1},{name:"IMPLICIT",number:2},{name:"LEGACY_REQUIRED",number:3}]},{name:"EnumType",value:[{name:"ENUM_TYPE_UNKNOWN",number:0},{name:"OPEN",number:1},{name:"CLOSED",number:2}]},{name:"RepeatedFieldEncoding",value:[{name:"REPEATED_FIELD_ENCODING_UNKNOWN",number:0},{name:"PACKED",number:1},{name:"EXPANDED",number:2}]},{name:"Utf8Validation",value:[{name:"UTF8_VALIDATION_UNKNOWN",number:0},{name:"VERIFY",number:2},{name:"NONE",number:3}]},{name:"MessageEncoding",value:[{name:"MESSAGE_ENCODING_UNKNOWN",number:0},{name:"LENGTH_PREFIXED",number:1},{name:"DELIMITED",number:2}]},{name:"JsonFormat",value:[{name:"JSON_FORMAT_UNKNOWN",number:0},{name:"ALLOW",number:1},{name:"LEGACY_BEST_EFFORT",number:2}]},{name:"EnforceNamingStyle",value:[{name:"ENFORCE_NAMING_STYLE_UNKNOWN",number:0},{name:"STYLE2024",number:1},{name:"STYLE_LEGACY",number:2}]}],extensionRange:[{start:1e3,end:9995},{start:9995,end:1e4},{start:1e4,end:10001}]},{name:"FeatureSetDefaults",field:[{name:"defaults",number:1,type:11,label:3,typeName:".google.protobuf.FeatureSetDefaults.FeatureSetEditionDefault"},{name:"minimum_edition",number:4,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"maximum_edition",number:5,type:14,label:1,typeName:".google.protobuf.Edition"}],nestedType:[{name:"FeatureSetEditionDefault",field:[{name:"edition",number:3,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"overridable_features",number:4,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"fixed_features",number:5,type:11,label:1,typeName:".google.protobuf.FeatureSet"}]}]},{name:"SourceCodeInfo",field:[{name:"location",number:1,type:11,label:3,typeName:".google.protobuf.SourceCodeInfo.Location"}],nestedType:[{name:"Location",field:[{name:"path",number:1,type:5,label:3,options:{packed:!0}},{name:"span",number:2,type:5,label:3,options:{packed:!0}},{name:"leading_comments",number:3,type:9,label:1},{name:"trailing_comments",number:4,type:9,label:1},{name:"leading_detached_comments",number:6,type:9,label:3}]}],extensionRange:[{start:536e6,end:536000001}]},{name:"GeneratedCodeInfo",field:[{name:"annotation",number:1,type:11,label:3,typeName:".google.protobuf.GeneratedCodeInfo.Annotation"}],nestedType:[{name:"Annotation",field:[{name:"path",number:1,type:5,label:3,options:{packed:!0}},{name:"source_file",number:2,type:9,label:1},{name:"begin",number:3,type:5,label:1},{name:"end",number:4,type:5,label:1},{name:"semantic",number:5,type:14,label:1,typeName:".google.protobuf.GeneratedCodeInfo.Annotation.Semantic"}],enumType:[{name:"Semantic",value:[{name:"NONE",number:0},{name:"SET",number:1},{name:"ALIAS",number:2}]}]}]}],enumType:[{name:"Edition",value:[{name:"EDITION_UNKNOWN",number:0},{name:"EDITION_LEGACY",number:900},{name:"EDITION_PROTO2",number:998},{name:"EDITION_PROTO3",number:999},{name:"EDITION_2023",number:1e3},{name:"EDITION_2024",number:1001},{name:"EDITION_1_TEST_ONLY",number:1},{name:"EDITION_2_TEST_ONLY",number:2},{name:"EDITION_99997_TEST_ONLY",number:99997},{name:"EDITION_99998_TEST_ONLY",number:99998},{name:"EDITION_99999_TEST_ONLY",number:99999},{name:"EDITION_MAX",number:2147483647}]},{name:"SymbolVisibility",value:[{name:"VISIBILITY_UNSET",number:0},{name:"VISIBILITY_LOCAL",number:1},{name:"VISIBILITY_EXPORT",number:2}]}]}),IS=_i(TS,1);var Ch;(function(n){n[n.DECLARATION=0]="DECLARATION",n[n.UNVERIFIED=1]="UNVERIFIED"})(Ch||(Ch={}));var Uh;(function(n){n[n.DOUBLE=1]="DOUBLE",n[n.FLOAT=2]="FLOAT",n[n.INT64=3]="INT64",n[n.UINT64=4]="UINT64",n[n.INT32=5]="INT32",n[n.FIXED64=6]="FIXED64",n[n.FIXED32=7]="FIXED32",n[n.BOOL=8]="BOOL",n[n.STRING=9]="STRING",n[n.GROUP=10]="GROUP",n[n.MESSAGE=11]="MESSAGE",n[n.BYTES=12]="BYTES",n[n.UINT32=13]="UINT32",n[n.ENUM=14]="ENUM",n[n.SFIXED32=15]="SFIXED32",n[n.SFIXED64=16]="SFIXED64",n[n.SINT32=17]="SINT32",n[n.SINT64=18]="SINT64"})(Uh||(Uh={}));var Ph;(function(n){n[n.OPTIONAL=1]="OPTIONAL",n[n.REPEATED=3]="REPEATED",n[n.REQUIRED=2]="REQUIRED"})(Ph||(Ph={}));var Lh;(function(n){n[n.SPEED=1]="SPEED",n[n.CODE_SIZE=2]="CODE_SIZE",n[n.LITE_RUNTIME=3]="LITE_RUNTIME"})(Lh||(Lh={}));var Dh;(function(n){n[n.STRING=0]="STRING",n[n.CORD=1]="CORD",n[n.STRING_PIECE=2]="STRING_PIECE"})(Dh||(Dh={}));var Oh;(function(n){n[n.JS_NORMAL=0]="JS_NORMAL",n[n.JS_STRING=1]="JS_STRING",n[n.JS_NUMBER=2]="JS_NUMBER"})(Oh||(Oh={}));var Fh;(function(n){n[n.RETENTION_UNKNOWN=0]="RETENTION_UNKNOWN",n[n.RETENTION_RUNTIME=1]="RETENTION_RUNTIME",n[n.RETENTION_SOURCE=2]="RETENTION_SOURCE"})(Fh||(Fh={}));var kh;(function(n){n[n.TARGET_TYPE_UNKNOWN=0]="TARGET_TYPE_UNKNOWN",n[n.TARGET_TYPE_FILE=1]="TARGET_TYPE_FILE",n[n.TARGET_TYPE_EXTENSION_RANGE=2]="TARGET_TYPE_EXTENSION_RANGE",n[n.TARGET_TYPE_MESSAGE=3]="TARGET_TYPE_MESSAGE",n[n.TARGET_TYPE_FIELD=4]="TARGET_TYPE_FIELD",n[n.TARGET_TYPE_ONEOF=5]="TARGET_TYPE_ONEOF",n[n.TARGET_TYPE_ENUM=6]="TARGET_TYPE_ENUM",n[n.TARGET_TYPE_ENUM_ENTRY=7]="TARGET_TYPE_ENUM_ENTRY",n[n.TARGET_TYPE_SERVICE=8]="TARGET_TYPE_SERVICE",n[n.TARGET_TYPE_METHOD=9]="TARGET_TYPE_METHOD"})(kh||(kh={}));var Bh;(function(n){n[n.IDEMPOTENCY_UNKNOWN=0]="IDEMPOTENCY_UNKNOWN",n[n.NO_SIDE_EFFECTS=1]="NO_SIDE_EFFECTS",n[n.IDEMPOTENT=2]="IDEMPOTENT"})(Bh||(Bh={}));var Vh;(function(n){n[n.DEFAULT_SYMBOL_VISIBILITY_UNKNOWN=0]="DEFAULT_SYMBOL_VISIBILITY_UNKNOWN",n[n.EXPORT_ALL=1]="EXPORT_ALL",n[n.EXPORT_TOP_LEVEL=2]="EXPORT_TOP_LEVEL",n[n.LOCAL_ALL=3]="LOCAL_ALL",n[n.STRICT=4]="STRICT"})(Vh||(Vh={}));var zh;(function(n){n[n.FIELD_PRESENCE_UNKNOWN=0]="FIELD_PRESENCE_UNKNOWN",n[n.EXPLICIT=1]="EXPLICIT",n[n.IMPLICIT=2]="IMPLICIT",n[n.LEGACY_REQUIRED=3]="LEGACY_REQUIRED"})(zh||(zh={}));var Gh;(function(n){n[n.ENUM_TYPE_UNKNOWN=0]="ENUM_TYPE_UNKNOWN",n[n.OPEN=1]="OPEN",n[n.CLOSED=2]="CLOSED"})(Gh||(Gh={}));var Wh;(function(n){n[n.REPEATED_FIELD_ENCODING_UNKNOWN=0]="REPEATED_FIELD_ENCODING_UNKNOWN",n[n.PACKED=1]="PACKED",n[n.EXPANDED=2]="EXPANDED"})(Wh||(Wh={}));var Hh;(function(n){n[n.UTF8_VALIDATION_UNKNOWN=0]="UTF8_VALIDATION_UNKNOWN",n[n.VERIFY=2]="VERIFY",n[n.NONE=3]="NONE"})(Hh||(Hh={}));var jh;(function(n){n[n.MESSAGE_ENCODING_UNKNOWN=0]="MESSAGE_ENCODING_UNKNOWN",n[n.LENGTH_PREFIXED=1]="LENGTH_PREFIXED",n[n.DELIMITED=2]="DELIMITED"})(jh||(jh={}));var Xh;(function(n){n[n.JSON_FORMAT_UNKNOWN=0]="JSON_FORMAT_UNKNOWN",n[n.ALLOW=1]="ALLOW",n[n.LEGACY_BEST_EFFORT=2]="LEGACY_BEST_EFFORT"})(Xh||(Xh={}));var Yh;(function(n){n[n.ENFORCE_NAMING_STYLE_UNKNOWN=0]="ENFORCE_NAMING_STYLE_UNKNOWN",n[n.STYLE2024=1]="STYLE2024",n[n.STYLE_LEGACY=2]="STYLE_LEGACY"})(Yh||(Yh={}));var Zh;(function(n){n[n.NONE=0]="NONE",n[n.SET=1]="SET",n[n.ALIAS=2]="ALIAS"})(Zh||(Zh={}));var Kh;(function(n){n[n.EDITION_UNKNOWN=0]="EDITION_UNKNOWN",n[n.EDITION_LEGACY=900]="EDITION_LEGACY",n[n.EDITION_PROTO2=998]="EDITION_PROTO2",n[n.EDITION_PROTO3=999]="EDITION_PROTO3",n[n.EDITION_2023=1e3]="EDITION_2023",n[n.EDITION_2024=1001]="EDITION_2024",n[n.EDITION_1_TEST_ONLY=1]="EDITION_1_TEST_ONLY",n[n.EDITION_2_TEST_ONLY=2]="EDITION_2_TEST_ONLY",n[n.EDITION_99997_TEST_ONLY=99997]="EDITION_99997_TEST_ONLY",n[n.EDITION_99998_TEST_ONLY=99998]="EDITION_99998_TEST_ONLY",n[n.EDITION_99999_TEST_ONLY=99999]="EDITION_99999_TEST_ONLY",n[n.EDITION_MAX=2147483647]="EDITION_MAX"})(Kh||(Kh={}));var Jh;(function(n){n[n.VISIBILITY_UNSET=0]="VISIBILITY_UNSET",n[n.VISIBILITY_LOCAL=1]="VISIBILITY_LOCAL",n[n.VISIBILITY_EXPORT=2]="VISIBILITY_EXPORT"})(Jh||(Jh={}));const qh={readUnknownFields:!0};function NS(n){return n?Object.assign(Object.assign({},qh),n):qh}function is(n,e,t){const i=Tn(n,void 0,!1);return Lm(i,new Id(e),NS(t),!1,e.byteLength),i.message}function Lm(n,e,t,i,a){var s;const r=i?e.len:e.pos+a;let o,c;const l=(s=n.getUnknown())!==null&&s!==void 0?s:[];for(;e.pos<r&&([o,c]=e.tag(),!(i&&c==xt.EndGroup));){const u=n.findNumber(o);if(!u){const h=e.skip(c,o);t.readUnknownFields&&l.push({no:o,wireType:c,data:h});continue}Dm(n,e,u,c,t)}if(i&&(c!=xt.EndGroup||o!==a))throw new Error("invalid end group tag");l.length>0&&n.setUnknown(l)}function Dm(n,e,t,i,a){var s;switch(t.fieldKind){case"scalar":n.set(t,Za(e,t.scalar));break;case"enum":const r=Za(e,z.INT32);if(t.enum.open)n.set(t,r);else if(t.enum.values.some(c=>c.number===r))n.set(t,r);else if(a.readUnknownFields){const c=new Td().int32(r).finish(),l=(s=n.getUnknown())!==null&&s!==void 0?s:[];l.push({no:t.number,wireType:i,data:c}),n.setUnknown(l)}break;case"message":n.set(t,Fd(e,a,t,n.get(t)));break;case"list":CS(e,i,n.get(t),a);break;case"map":RS(e,n.get(t),a);break}}function RS(n,e,t){const i=e.field();let a,s;const r=n.uint32(),o=n.pos+r;for(;n.pos<o;){const[c]=n.tag();switch(c){case 1:a=Za(n,i.mapKey);break;case 2:switch(i.mapKind){case"scalar":s=Za(n,i.scalar);break;case"enum":s=n.int32();break;case"message":s=Fd(n,t,i);break}break}}if(a===void 0&&(a=ra(i.mapKey,!1)),s===void 0)switch(i.mapKind){case"scalar":s=ra(i.scalar,!1);break;case"enum":s=i.enum.values[0].number;break;case"message":s=Tn(i.message,void 0,!1);break}e.set(a,s)}function CS(n,e,t,i){var a;const s=t.field();if(s.listKind==="message"){t.add(Fd(n,i,s));return}const r=(a=s.scalar)!==null&&a!==void 0?a:z.INT32;if(!(e==xt.LengthDelimited&&r!=z.STRING&&r!=z.BYTES)){t.add(Za(n,r));return}const c=n.uint32()+n.pos;for(;n.pos<c;)t.add(Za(n,r))}function Fd(n,e,t,i){const a=t.delimitedEncoding,s=i??Tn(t.message,void 0,!1);return Lm(s,n,e,a,a?t.number:n.uint32()),s}function Za(n,e){switch(e){case z.STRING:return n.string();case z.BOOL:return n.bool();case z.DOUBLE:return n.double();case z.FLOAT:return n.float();case z.INT32:return n.int32();case z.INT64:return n.int64();case z.UINT64:return n.uint64();case z.FIXED64:return n.fixed64();case z.BYTES:return n.bytes();case z.FIXED32:return n.fixed32();case z.SFIXED32:return n.sfixed32();case z.SFIXED64:return n.sfixed64();case z.SINT64:return n.sint64();case z.UINT32:return n.uint32();case z.SINT32:return n.sint32()}}function Qn(n,e){var t;const i=is(IS,xd(n));return i.messageType.forEach(vd),i.dependency=(t=e?.map(s=>s.proto.name))!==null&&t!==void 0?t:[],cm(i,s=>e?.find(r=>r.proto.name===s)).getFile(i.name)}function kd(n,e,...t){if(t.length>0)throw new Error;return n.services[e]}const So=Qn("ChdnZW9kZXNpYy92MS9xdWVyeS5wcm90bxILZ2VvZGVzaWMudjEieQoNQXBwcm94aW1hdGlvbhIXCgpuZWlnaGJvdXJzGAEgASgNSACIAQESEwoGbGFtYmRhGAIgASgBSAGIAQESFAoHc2FtcGxlcxgDIAEoDUgCiAEBQg0KC19uZWlnaGJvdXJzQgkKB19sYW1iZGFCCgoIX3NhbXBsZXMiMQoKUmVzdW1wdGlvbhIRCglhbnN3ZXJfaWQYASABKAkSEAoIcmVjZWl2ZWQYAiADKAQqtQIKCUFsZ29yaXRobRIZChVBTEdPUklUSE1fVU5TUEVDSUZJRUQQABIUChBBTEdPUklUSE1fRldQX0NIEAESFQoRQUxHT1JJVEhNX0ZXUF9NTVAQAhIRCg1BTEdPUklUSE1fSUNIEAMSEQoNQUxHT1JJVEhNX01NUBAEEhAKDEFMR09SSVRITV9DSBAFEhQKEEFMR09SSVRITV9MQ19NTVAQBhITCg9BTEdPUklUSE1fTENfQ0gQBxIWChJBTEdPUklUSE1fRldQX0xJU1QQCBIRCg1BTEdPUklUSE1fRk1NEBASGAoUQUxHT1JJVEhNX0ZNTV9VTlRJRFkQERISCg5BTEdPUklUSE1fSEVBVBASEhEKDUFMR09SSVRITV9TVkcQExIRCg1BTEdPUklUSE1fR1RVEBQqmwEKCVZhbHVlVHlwZRIaChZWQUxVRV9UWVBFX1VOU1BFQ0lGSUVEEAASFgoSVkFMVUVfVFlQRV9GTE9BVDY0EAESFgoSVkFMVUVfVFlQRV9GTE9BVDMyEAISFQoRVkFMVUVfVFlQRV9VSU5UMzIQAxIVChFWQUxVRV9UWVBFX1VJTlQ2NBAEEhQKEFZBTFVFX1RZUEVfVUlOVDgQBSpSCghQcmlvcml0eRIYChRQUklPUklUWV9VTlNQRUNJRklFRBAAEhgKFFBSSU9SSVRZX0lOVEVSQUNUSVZFEAESEgoOUFJJT1JJVFlfQkFUQ0gQAkI1CgtnZW9kZXNpYy52MVABWhZnZW9kZXNpYy92MTtnZW9kZXNpY3YxqgILR2VvZGVzaWMuVjFiBnByb3RvMw");var ks=(n=>(n[n.UNSPECIFIED=0]="UNSPECIFIED",n[n.FWP_CH=1]="FWP_CH",n[n.FWP_MMP=2]="FWP_MMP",n[n.ICH=3]="ICH",n[n.MMP=4]="MMP",n[n.CH=5]="CH",n[n.LC_MMP=6]="LC_MMP",n[n.LC_CH=7]="LC_CH",n[n.FWP_LIST=8]="FWP_LIST",n[n.FMM=16]="FMM",n[n.FMM_UNTIDY=17]="FMM_UNTIDY",n[n.HEAT=18]="HEAT",n[n.SVG=19]="SVG",n[n.GTU=20]="GTU",n))(ks||{}),Fa=(n=>(n[n.UNSPECIFIED=0]="UNSPECIFIED",n[n.FLOAT64=1]="FLOAT64",n[n.FLOAT32=2]="FLOAT32",n[n.UINT32=3]="UINT32",n[n.UINT64=4]="UINT64",n[n.UINT8=5]="UINT8",n))(Fa||{});const $h=[[.36,.15,298],[.5,.125,258],[.65,.105,200],[.8,.165,146],[.94,.175,106]],Wa=256,ws=US(),po=[[230,159,0],[86,180,233],[0,158,115],[240,228,66],[0,114,178],[213,94,0],[204,121,167]];function Om(n){const e=4*Math.round(Math.min(Math.max(n,0),1)*(Wa-1));return`rgb(${ws[e]}, ${ws[e+1]}, ${ws[e+2]})`}function US(){const e=Array.from({length:2049},(s,r)=>PS(r/2048)),t=[0];for(let s=1;s<=2048;s++)t.push(t[s-1]+Math.hypot(...e[s].map((r,o)=>r-e[s-1][o])));const i=new Uint8Array(4*Wa);let a=0;for(let s=0;s<Wa;s++){const r=t[2048]*s/(Wa-1);for(;a<2048&&t[a]<r;)a++;i.set([...DS(e[a]),255],4*s)}return i}function PS(n){const e=$h.length-1,t=Math.min(Math.floor(n*e),e-1),i=n*e-t,a=f=>$h[Math.min(Math.max(f,0),e)],[s,r,o,c]=[a(t-1),a(t),a(t+1),a(t+2)],[l,u,h]=r.map((f,g)=>LS(s[g],r[g],o[g],c[g],i)),d=h*Math.PI/180;return[l,u*Math.cos(d),u*Math.sin(d)]}function LS(n,e,t,i,a){return e+.5*a*(t-n+a*(2*n-5*e+4*t-i+a*(3*(e-t)+i-n)))}function DS([n,e,t]){const i=(n+.3963377774*e+.2158037573*t)**3,a=(n-.1055613458*e-.0638541728*t)**3,s=(n-.0894841775*e-1.291485548*t)**3;return[4.0767416621*i-3.3077115913*a+.2309699292*s,-1.2684380046*i+2.6097574011*a-.3413193965*s,-.0041960863*i-.7034186147*a+1.707614701*s].map(r=>{const o=Math.min(Math.max(r,0),1);return Math.round(255*(o<=.0031308?12.92*o:1.055*o**(1/2.4)-.055))})}function Bd(n){if(!(n>0)||!Number.isFinite(n))return{step:0,perLabel:1};const e=10**Math.floor(Math.log10(n)),t=n/e;return t<2?{step:e/20,perLabel:4}:t<4.5?{step:e/10,perLabel:5}:{step:e/5,perLabel:5}}function Fm(n){const e=[],t=Bd(n),i=t.step*t.perLabel;if(!(i>0))return e;for(let a=0;a*i<=n*(1+1e-12);a++)e.push({at:a*i,text:String(Number((a*i).toPrecision(6)))});return e}const Qh=700;class ef{constructor(e,t,i,a){this.mesh=e,this.material=t,this.quadratic=a,this.distances=new Float64Array(e.vertexCount).fill(1/0),this.drawn=new Float32Array(e.vertexCount).fill(-1),this.attribute=new St(this.drawn,1).setUsage(gb),e.setAttribute("geodesic",this.attribute),t.uniforms.reference.value=i,t.uniforms.quadratic.value=a,this.paintDistances(),this.setFront(0)}mesh;material;quadratic;distances;painted="distances";difference;largest=0;drawn;attribute;preview;complete=!1;arrived=!1;swept=!1;front=0;lastFrame=0;add(e,t){for(let i=0;i<e.length;i++)this.distances[e[i]]=t[i],this.drawn[e[i]]=t[i]/this.mesh.radius;t.length&&(this.largest=Math.max(this.largest,t[t.length-1])),this.attribute.needsUpdate=!0,this.setScale()}setAll(e){this.distances.set(e);for(let t=0;t<e.length;t++)Number.isFinite(e[t])&&(this.drawn[t]=e[t]/this.mesh.radius,this.largest=Math.max(this.largest,e[t]));this.arrived=!0,this.attribute.needsUpdate=!0,this.setScale(),this.setFront(1/0)}showPreview(e){if(!this.complete){this.preview=e;for(let t=0;t<e.length;t++)!Number.isFinite(e[t])||Number.isFinite(this.distances[t])||(this.drawn[t]=e[t]/this.mesh.radius,this.largest=Math.max(this.largest,e[t]));this.attribute.needsUpdate=!0,this.setScale()}}get isPreview(){return this.preview!==void 0}finish(){if(this.complete=!0,!!this.preview){this.preview=void 0,this.largest=0;for(let e=0;e<this.distances.length;e++)Number.isFinite(this.distances[e])?this.largest=Math.max(this.largest,this.distances[e]):this.drawn[e]=-1;this.attribute.needsUpdate=!0,this.setScale()}}get hasArrived(){return this.arrived}get hasSwept(){return this.swept}advance(e,t){if(this.arrived)return!1;if(!this.complete&&!this.preview&&!this.largest)return this.lastFrame=0,!1;const i=this.largest/this.mesh.radius,a=this.lastFrame?Math.min(e-this.lastFrame,Qh):16;this.lastFrame=e;const s=this.front;return t&&(this.front=i),this.front=Math.min(this.front+i*a/Qh,i),this.swept=this.front>=i&&(this.complete||this.preview!==void 0),this.arrived=this.complete&&this.swept,this.setFront(this.swept?1/0:this.front),this.preview===void 0||s<i}paintCells(e){const t=new Uint8Array(3*e.length).fill(128);for(let i=0;i<e.length;i++)e[i]!==4294967295&&t.set(po[e[i]%po.length],3*i);this.paint("cells",t,.45)}paintDifference(e){this.difference=e;const{shares:t}=e,i=new Uint8Array(3*t.length).fill(128);for(let a=0;a<t.length;a++){if(Number.isNaN(t[a]))continue;const s=4*Math.round(t[a]*(Wa-1));i.set(ws.subarray(s,s+3),3*a)}this.paint("difference",i,0)}paintDistances(){this.painted="distances",this.material.uniforms.painted.value=!1,this.mesh.setAttribute("paint",void 0)}paint(e,t,i){this.painted=e,this.material.uniforms.painted.value=!0,this.material.uniforms.shade.value=i,this.mesh.setAttribute("paint",new St(t,3,!0))}at(e,t){const i=this.mesh.cornersOf(e),a=this.mesh.radius,s=i.map(c=>this.shownAt(c)/a);let r=0;for(let c=0;c<3;c++)r+=t[c]*(this.quadratic?s[c]*s[c]:s[c]);if(!this.quadratic||!Number.isFinite(r))return r*a;const o=i.map(c=>this.mesh.vertexPosition(c));for(let c=0;c<3;c++){const l=(c+1)%3,u=Math.hypot(o[c][0]-o[l][0],o[c][1]-o[l][1],o[c][2]-o[l][2])/a;r-=t[c]*t[l]*u*u}return Math.sqrt(Math.max(r,0))*a}shownAt(e){const t=this.distances[e];return t===1/0&&this.preview?this.preview[e]:t}get scaleEnd(){return{distances:this.largest,cells:0,difference:this.difference?.largest??0}[this.painted]}setScale(){const{step:e,perLabel:t}=Bd(this.largest);this.material.uniforms.largest.value=Math.max(this.largest/this.mesh.radius,1e-30),this.material.uniforms.lineStep.value=e/this.mesh.radius,this.material.uniforms.linesPerLabel.value=t}setFront(e){this.material.uniforms.front.value=Number.isFinite(e)?e:1e10,this.material.uniforms.glow.value=Number.isFinite(e)?.8:0}}function Ha(n){switch(n.kind){case"vertex":return`${n.vertex}`;case"edge":return`edge:${n.from}-${n.to}@${n.t}`;case"face":return`face:${n.face}@${n.weights.join(",")}`}}function Ka(n){return"curve"in n?n.curve.map(Ha).join(";"):Ha(n)}function us(n){switch(n.kind){case"vertex":return`${n.vertex}`;case"edge":return`geodesic.EdgePoint(${n.from}, ${n.to}, ${n.t})`;case"face":return`geodesic.FacePoint(${n.face}, (${n.weights.join(", ")}))`}}function OS(n){const e=n.split(";").map(Wl).filter(t=>t!==void 0);if(!(e.length<n.split(";").length))return e.length>1?{curve:e}:e[0]}function Wl(n){if(/^\d+$/.test(n))return{kind:"vertex",vertex:Number(n)};const e=/^edge:(\d+)-(\d+)@([\d.e+-]+)$/.exec(n);if(e)return{kind:"edge",from:Number(e[1]),to:Number(e[2]),t:Number(e[3])};const t=/^face:(\d+)@([\d.e+-]+),([\d.e+-]+),([\d.e+-]+)$/.exec(n);if(t)return{kind:"face",face:Number(t[1]),weights:[Number(t[2]),Number(t[3]),Number(t[4])]}}const hs={sources:[],paths:[],samples:[]};function FS({sources:n,paths:e,samples:t,radius:i}){return!n.length&&!e.length&&!t.length&&i===void 0}function tf(n,e){return n.length===e.length&&n.every((t,i)=>t===e[i])}function kS(n,e){const t=Ka(n);return e.some(i=>Ka(i)===t)}const BS={[Fa.FLOAT64]:Float64Array,[Fa.FLOAT32]:Float32Array,[Fa.UINT32]:Uint32Array,[Fa.UINT64]:BigUint64Array,[Fa.UINT8]:Uint8Array};class VS{constructor({name:e,shape:t},i){this.kind=i,this.name=e,t.includes(-1n)||(this.size=t.reduce((a,s)=>a*Number(s),1)),this.bytes=new Uint8Array((this.size??1024)*i.BYTES_PER_ELEMENT)}kind;name;size;bytes;count=0;get isComplete(){return this.size===void 0||this.count===this.size}add({first:e,values:t}){if(Number(e)!==this.count)throw km();const i=this.count*this.kind.BYTES_PER_ELEMENT,a=i+t.length;if(this.size===void 0&&a>this.bytes.length){const s=new Uint8Array(2*a);s.set(this.bytes),this.bytes=s}this.bytes.set(t,i),this.count=a/this.kind.BYTES_PER_ELEMENT}numbers(e,t){if(this.kind===e)return new e(this.bytes.buffer,t*e.BYTES_PER_ELEMENT,this.count-t)}}class zS{arrays=[];get(e,t,i=0){const a=this.arrays.find(s=>s?.name===e)?.numbers(t,i);if(!a)throw new Error(`The answer has no ${e}.`);return a}add({header:e,blocks:t}){e&&(this.arrays=e.arrays.map(i=>{const a=BS[i.type];return a&&new VS(i,a)}));for(const i of t)this.arrays[i.array]?.add(i)}get areComplete(){return this.arrays.every(e=>!e||e.isComplete)}}async function oa(n,e=()=>{}){const t=new zS;let i;for await(const a of n)t.add(a),a.blocks.length&&e(t),i=a.trailer;if(!i||!t.areComplete)throw km();return{arrays:t,trailer:i}}function km(){return new Error("The answer broke off.")}var Le;(function(n){n[n.Canceled=1]="Canceled",n[n.Unknown=2]="Unknown",n[n.InvalidArgument=3]="InvalidArgument",n[n.DeadlineExceeded=4]="DeadlineExceeded",n[n.NotFound=5]="NotFound",n[n.AlreadyExists=6]="AlreadyExists",n[n.PermissionDenied=7]="PermissionDenied",n[n.ResourceExhausted=8]="ResourceExhausted",n[n.FailedPrecondition=9]="FailedPrecondition",n[n.Aborted=10]="Aborted",n[n.OutOfRange=11]="OutOfRange",n[n.Unimplemented=12]="Unimplemented",n[n.Internal=13]="Internal",n[n.Unavailable=14]="Unavailable",n[n.DataLoss=15]="DataLoss",n[n.Unauthenticated=16]="Unauthenticated"})(Le||(Le={}));const Bm=Qn("Chlnb29nbGUvcHJvdG9idWYvYW55LnByb3RvEg9nb29nbGUucHJvdG9idWYiJgoDQW55EhAKCHR5cGVfdXJsGAEgASgJEg0KBXZhbHVlGAIgASgMQnYKE2NvbS5nb29nbGUucHJvdG9idWZCCEFueVByb3RvUAFaLGdvb2dsZS5nb2xhbmcub3JnL3Byb3RvYnVmL3R5cGVzL2tub3duL2FueXBiogIDR1BCqgIeR29vZ2xlLlByb3RvYnVmLldlbGxLbm93blR5cGVzYgZwcm90bzM"),GS=_i(Bm,0);function WS(n,e,t){let i=!1;return t||(t=fn(GS),i=!0),t.value=Od(n,e),t.typeUrl=XS(e.$typeName),i?t:void 0}function HS(n,e){if(n.typeUrl==="")return!1;const t=typeof e=="string"?e:e.typeName,i=Vm(n.typeUrl);return t===i}function jS(n,e){if(n.typeUrl==="")return;const t=e.kind=="message"?e:e.getMessage(Vm(n.typeUrl));if(!(!t||!HS(n,t)))return is(t,n.value)}function XS(n){return`type.googleapis.com/${n}`}function Vm(n){const e=n.lastIndexOf("/"),t=e>=0?n.substring(e+1):n;if(!t.length)throw new Error(`invalid type url: ${n}`);return t}const Vd=Qn("Chxnb29nbGUvcHJvdG9idWYvc3RydWN0LnByb3RvEg9nb29nbGUucHJvdG9idWYihAEKBlN0cnVjdBIzCgZmaWVsZHMYASADKAsyIy5nb29nbGUucHJvdG9idWYuU3RydWN0LkZpZWxkc0VudHJ5GkUKC0ZpZWxkc0VudHJ5EgsKA2tleRgBIAEoCRIlCgV2YWx1ZRgCIAEoCzIWLmdvb2dsZS5wcm90b2J1Zi5WYWx1ZToCOAEi6gEKBVZhbHVlEjAKCm51bGxfdmFsdWUYASABKA4yGi5nb29nbGUucHJvdG9idWYuTnVsbFZhbHVlSAASFgoMbnVtYmVyX3ZhbHVlGAIgASgBSAASFgoMc3RyaW5nX3ZhbHVlGAMgASgJSAASFAoKYm9vbF92YWx1ZRgEIAEoCEgAEi8KDHN0cnVjdF92YWx1ZRgFIAEoCzIXLmdvb2dsZS5wcm90b2J1Zi5TdHJ1Y3RIABIwCgpsaXN0X3ZhbHVlGAYgASgLMhouZ29vZ2xlLnByb3RvYnVmLkxpc3RWYWx1ZUgAQgYKBGtpbmQiMwoJTGlzdFZhbHVlEiYKBnZhbHVlcxgBIAMoCzIWLmdvb2dsZS5wcm90b2J1Zi5WYWx1ZSobCglOdWxsVmFsdWUSDgoKTlVMTF9WQUxVRRAAQn8KE2NvbS5nb29nbGUucHJvdG9idWZCC1N0cnVjdFByb3RvUAFaL2dvb2dsZS5nb2xhbmcub3JnL3Byb3RvYnVmL3R5cGVzL2tub3duL3N0cnVjdHBi+AEBogIDR1BCqgIeR29vZ2xlLlByb3RvYnVmLldlbGxLbm93blR5cGVzYgZwcm90bzM"),YS=_i(Vd,0),zm=_i(Vd,1),ZS=_i(Vd,2);var Hl;(function(n){n[n.NULL_VALUE=0]="NULL_VALUE"})(Hl||(Hl={}));function KS(n,e){Gm(e,n);const t=qS(n.$unknown,e),[i,a,s]=Mo(e);for(const r of t)Dm(i,new Id(r.data),a,r.wireType,{readUnknownFields:!0});return s()}function JS(n,e,t){var i;Gm(e,n);const a=((i=n.$unknown)!==null&&i!==void 0?i:[]).filter(l=>l.no!==e.number),[s,r]=Mo(e,t),o=new Td;Cm(o,{writeUnknownFields:!0},s,r);const c=new Id(o.finish());for(;c.pos<c.len;){const[l,u]=c.tag(),h=c.skip(u,l);a.push({no:l,wireType:u,data:h})}n.$unknown=a}function qS(n,e){if(n===void 0)return[];if(e.fieldKind==="enum"||e.fieldKind==="scalar"){for(let t=n.length-1;t>=0;--t)if(n[t].no==e.number)return[n[t]];return[]}return n.filter(t=>t.no===e.number)}function Mo(n,e){const t=n.typeName,i=Object.assign(Object.assign({},n),{kind:"field",parent:n.extendee,localName:t}),a=Object.assign(Object.assign({},n.extendee),{fields:[i],members:[i],oneofs:[]}),s=fn(a,e!==void 0?{[t]:e}:void 0);return[Tn(a,s),i,()=>{const r=s[t];if(r===void 0){const o=n.message;return Xs(o)?ra(o.fields[0].scalar,o.fields[0].longAsString):fn(o)}return r}]}function Gm(n,e){if(n.extendee.typeName!=e.$typeName)throw new Error(`extension ${n.typeName} can only be applied to message ${n.extendee.typeName}`)}const $S=3,QS=2,nf={alwaysEmitImplicit:!1,enumAsInteger:!1,useProtoFieldName:!1};function eM(n){return n?Object.assign(Object.assign({},nf),n):nf}function tM(n,e,t){return Ys(Tn(n,e),eM(t))}function nM(n,e,t){var i;const a=tM(n,e,t);return JSON.stringify(a,null,(i=t?.prettySpaces)!==null&&i!==void 0?i:0)}function Ys(n,e){var t;const i=rM(n,e);if(i!==void 0)return i;const a={};for(const s of n.sortedFields){if(!n.isSet(s)){if(s.presence==$S)throw new Error(`cannot encode ${s} to JSON: required field not set`);if(!e.alwaysEmitImplicit||s.presence!==QS)continue}const r=af(s,n.get(s),e);r!==void 0&&(a[sM(s,e)]=r)}if(e.registry){const s=new Set;for(const{no:r}of(t=n.getUnknown())!==null&&t!==void 0?t:[])if(!s.has(r)){s.add(r);const o=e.registry.getExtensionFor(n.desc,r);if(!o)continue;const c=KS(n.message,o),[l,u]=Mo(o,c),h=af(u,l.get(u),e);h!==void 0&&(a[o.jsonName]=h)}}return a}function af(n,e,t){switch(n.fieldKind){case"scalar":return Ao(n,e);case"message":return Ys(e,t);case"enum":return zd(n.enum,e,t.enumAsInteger);case"list":return aM(e,t);case"map":return iM(e,t)}}function iM(n,e){const t=n.field(),i={};switch(t.mapKind){case"scalar":for(const[a,s]of n)i[a]=Ao(t,s);break;case"message":for(const[a,s]of n)i[a]=Ys(s,e);break;case"enum":for(const[a,s]of n)i[a]=zd(t.enum,s,e.enumAsInteger);break}return e.alwaysEmitImplicit||n.size>0?i:void 0}function aM(n,e){const t=n.field(),i=[];switch(t.listKind){case"scalar":for(const a of n)i.push(Ao(t,a));break;case"enum":for(const a of n)i.push(zd(t.enum,a,e.enumAsInteger));break;case"message":for(const a of n)i.push(Ys(a,e));break}return e.alwaysEmitImplicit||i.length>0?i:void 0}function zd(n,e,t){var i;if(typeof e!="number")throw new Error(`cannot encode ${n} to JSON: expected number, got ${Ft(e)}`);if(n.typeName=="google.protobuf.NullValue")return null;if(t)return e;const a=n.value[e];return(i=a?.name)!==null&&i!==void 0?i:e}function Ao(n,e){var t,i,a,s,r,o;switch(n.scalar){case z.INT32:case z.SFIXED32:case z.SINT32:case z.FIXED32:case z.UINT32:if(typeof e!="number")throw new Error(`cannot encode ${n} to JSON: ${(t=Yi(n,e))===null||t===void 0?void 0:t.message}`);return e;case z.FLOAT:case z.DOUBLE:if(typeof e!="number")throw new Error(`cannot encode ${n} to JSON: ${(i=Yi(n,e))===null||i===void 0?void 0:i.message}`);return Number.isNaN(e)?"NaN":e===Number.POSITIVE_INFINITY?"Infinity":e===Number.NEGATIVE_INFINITY?"-Infinity":e;case z.STRING:if(typeof e!="string")throw new Error(`cannot encode ${n} to JSON: ${(a=Yi(n,e))===null||a===void 0?void 0:a.message}`);return e;case z.BOOL:if(typeof e!="boolean")throw new Error(`cannot encode ${n} to JSON: ${(s=Yi(n,e))===null||s===void 0?void 0:s.message}`);return e;case z.UINT64:case z.FIXED64:case z.INT64:case z.SFIXED64:case z.SINT64:if(typeof e!="bigint"&&typeof e!="string")throw new Error(`cannot encode ${n} to JSON: ${(r=Yi(n,e))===null||r===void 0?void 0:r.message}`);return e.toString();case z.BYTES:if(e instanceof Uint8Array)return iS(e);throw new Error(`cannot encode ${n} to JSON: ${(o=Yi(n,e))===null||o===void 0?void 0:o.message}`)}}function sM(n,e){return e.useProtoFieldName?n.name:n.jsonName}function rM(n,e){if(n.desc.typeName.startsWith("google.protobuf."))switch(n.desc.typeName){case"google.protobuf.Any":return oM(n.message,e);case"google.protobuf.Timestamp":return dM(n.message);case"google.protobuf.Duration":return cM(n.message);case"google.protobuf.FieldMask":return lM(n.message);case"google.protobuf.Struct":return Wm(n.message);case"google.protobuf.Value":return Gd(n.message);case"google.protobuf.ListValue":return Hm(n.message);default:if(Xs(n.desc)){const t=n.desc.fields[0];return Ao(t,n.get(t))}return}}function oM(n,e){if(n.typeUrl==="")return{};const{registry:t}=e;let i,a;if(t&&(i=jS(n,t),i&&(a=t.getMessage(i.$typeName))),!a||!i)throw new Error(`cannot encode message ${n.$typeName} to JSON: "${n.typeUrl}" is not in the type registry`);let s=Ys(Tn(a,i),e);return(a.typeName.startsWith("google.protobuf.")||s===null||Array.isArray(s)||typeof s!="object")&&(s={value:s}),s["@type"]=n.typeUrl,s}function cM(n){if(Number(n.seconds)>315576e6||Number(n.seconds)<-315576e6)throw new Error(`cannot encode message ${n.$typeName} to JSON: value out of range`);let e=n.seconds.toString();if(n.nanos!==0){let t=Math.abs(n.nanos).toString();t="0".repeat(9-t.length)+t,t.substring(3)==="000000"?t=t.substring(0,3):t.substring(6)==="000"&&(t=t.substring(0,6)),e+="."+t,n.nanos<0&&Number(n.seconds)==0&&(e="-"+e)}return e+"s"}function lM(n){return n.paths.map(e=>{if(e.match(/_[0-9]?_/g)||e.match(/[A-Z]/g))throw new Error(`cannot encode message ${n.$typeName} to JSON: lowerCamelCase of path name "`+e+'" is irreversible');return Ls(e)}).join(",")}function Wm(n){const e={};for(const[t,i]of Object.entries(n.fields))e[t]=Gd(i);return e}function Gd(n){switch(n.kind.case){case"nullValue":return null;case"numberValue":if(!Number.isFinite(n.kind.value))throw new Error(`${n.$typeName} cannot be NaN or Infinity`);return n.kind.value;case"boolValue":return n.kind.value;case"stringValue":return n.kind.value;case"structValue":return Wm(n.kind.value);case"listValue":return Hm(n.kind.value);default:throw new Error(`${n.$typeName} must have a value`)}}function Hm(n){return n.values.map(Gd)}function dM(n){const e=Number(n.seconds)*1e3;if(e<Date.parse("0001-01-01T00:00:00Z")||e>Date.parse("9999-12-31T23:59:59Z"))throw new Error(`cannot encode message ${n.$typeName} to JSON: must be from 0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z inclusive`);if(n.nanos<0)throw new Error(`cannot encode message ${n.$typeName} to JSON: nanos must not be negative`);let t="Z";if(n.nanos>0){const i=(n.nanos+1e9).toString().substring(1);i.substring(3)==="000000"?t="."+i.substring(0,3)+"Z":i.substring(6)==="000"?t="."+i.substring(0,6)+"Z":t="."+i+"Z"}return new Date(e).toISOString().replace(".000Z",t)}const sf={ignoreUnknownFields:!1};function uM(n){return n?Object.assign(Object.assign({},sf),n):sf}function hM(n,e,t){return fM(n,yM(e,n.typeName),t)}function fM(n,e,t){const i=Tn(n);try{Ja(i,e,uM(t))}catch(a){throw rS(a)?new Error(`cannot decode ${a.field()} from JSON: ${a.message}`,{cause:a}):a}return i.message}function Ja(n,e,t){var i;if(xM(n,e,t))return;if(e==null||Array.isArray(e)||typeof e!="object")throw new Error(`cannot decode ${n.desc} from JSON: ${Ft(e)}`);const a=new Map,s=new Map;for(const r of n.desc.fields)s.set(r.name,r).set(r.jsonName,r);for(const[r,o]of Object.entries(e)){const c=s.get(r);if(c){if(c.oneof){if(o===null&&c.fieldKind=="scalar")continue;const l=a.get(c.oneof);if(l!==void 0)throw new rn(c.oneof,`oneof set multiple times by ${l.name} and ${c.name}`);a.set(c.oneof,c)}rf(n,c,o,t)}else{let l;if(r.startsWith("[")&&r.endsWith("]")&&(l=(i=t.registry)===null||i===void 0?void 0:i.getExtension(r.substring(1,r.length-1)))&&l.extendee.typeName===n.desc.typeName){const[u,h,d]=Mo(l);rf(u,h,o,t),JS(n.message,l,d())}if(!l&&!t.ignoreUnknownFields)throw new Error(`cannot decode ${n.desc} from JSON: key "${r}" is unknown`)}}}function rf(n,e,t,i){switch(e.fieldKind){case"scalar":_M(n,e,t);break;case"enum":bM(n,e,t,i);break;case"message":gM(n,e,t,i);break;case"list":mM(n.get(e),t,i);break;case"map":pM(n.get(e),t,i);break}}function pM(n,e,t){if(e===null)return;const i=n.field();if(typeof e!="object"||Array.isArray(e))throw new rn(i,"expected object, got "+Ft(e));for(const[a,s]of Object.entries(e)){if(s===null)throw new rn(i,"map value must not be null");let r;switch(i.mapKind){case"message":const c=Tn(i.message);Ja(c,s,t),r=c;break;case"enum":if(r=Wd(i.enum,s,t.ignoreUnknownFields,!0),r===wo)return;break;case"scalar":r=Io(i,s,!0);break}const o=vM(i.mapKey,a);n.set(o,r)}}function mM(n,e,t){if(e===null)return;const i=n.field();if(!Array.isArray(e))throw new rn(i,"expected Array, got "+Ft(e));for(const a of e){if(a===null)throw new rn(i,"list item must not be null");switch(i.listKind){case"message":const s=Tn(i.message);Ja(s,a,t),n.add(s);break;case"enum":const r=Wd(i.enum,a,t.ignoreUnknownFields,!0);r!==wo&&n.add(r);break;case"scalar":n.add(Io(i,a,!0));break}}}function gM(n,e,t,i){if(t===null&&e.message.typeName!="google.protobuf.Value"){n.clear(e);return}const a=n.isSet(e)?n.get(e):Tn(e.message);Ja(a,t,i),n.set(e,a)}function bM(n,e,t,i){const a=Wd(e.enum,t,i.ignoreUnknownFields,!1);a===To?n.clear(e):a!==wo&&n.set(e,a)}function _M(n,e,t){const i=Io(e,t,!1);i===To?n.clear(e):n.set(e,i)}const wo=Symbol();function Wd(n,e,t,i){if(e===null)return n.typeName=="google.protobuf.NullValue"?0:i?n.values[0].number:To;switch(typeof e){case"number":if(Number.isInteger(e))return e;break;case"string":const a=n.values.find(s=>s.name===e);if(a!==void 0)return a.number;if(t)return wo;break}throw new Error(`cannot decode ${n} from JSON: ${Ft(e)}`)}const To=Symbol();function Io(n,e,t){if(e===null)return t?ra(n.scalar,!1):To;switch(n.scalar){case z.DOUBLE:case z.FLOAT:if(e==="NaN")return NaN;if(e==="Infinity")return Number.POSITIVE_INFINITY;if(e==="-Infinity")return Number.NEGATIVE_INFINITY;if(typeof e=="number"){if(Number.isNaN(e))throw new rn(n,"unexpected NaN number");if(!Number.isFinite(e))throw new rn(n,"unexpected infinite number");break}if(typeof e=="string"){if(e===""||e.trim().length!==e.length)break;const i=Number(e);if(!Number.isFinite(i))break;return i}break;case z.INT32:case z.FIXED32:case z.SFIXED32:case z.SINT32:case z.UINT32:return jm(e);case z.BYTES:if(typeof e=="string"){if(e==="")return new Uint8Array(0);try{return xd(e)}catch(i){const a=i instanceof Error?i.message:String(i);throw new rn(n,a)}}break}return e}function vM(n,e){switch(n){case z.BOOL:switch(e){case"true":return!0;case"false":return!1}return e;case z.INT32:case z.FIXED32:case z.UINT32:case z.SFIXED32:case z.SINT32:return jm(e);default:return e}}function jm(n){if(typeof n=="string"){if(n===""||n.trim().length!==n.length)return n;const e=Number(n);return Number.isNaN(e)?n:e}return n}function yM(n,e){try{return JSON.parse(n)}catch(t){const i=t instanceof Error?t.message:String(t);throw new Error(`cannot decode message ${e} from JSON: ${i}`,{cause:t})}}function xM(n,e,t){if(!n.desc.typeName.startsWith("google.protobuf."))return!1;switch(n.desc.typeName){case"google.protobuf.Any":return EM(n.message,e,t),!0;case"google.protobuf.Timestamp":return SM(n.message,e),!0;case"google.protobuf.Duration":return MM(n.message,e),!0;case"google.protobuf.FieldMask":return AM(n.message,e),!0;case"google.protobuf.Struct":return Xm(n.message,e),!0;case"google.protobuf.Value":return Hd(n.message,e),!0;case"google.protobuf.ListValue":return Ym(n.message,e),!0;default:if(Xs(n.desc)){const i=n.desc.fields[0];return e===null?n.clear(i):n.set(i,Io(i,e,!0)),!0}return!1}}function EM(n,e,t){var i;if(e===null||Array.isArray(e)||typeof e!="object")throw new Error(`cannot decode message ${n.$typeName} from JSON: expected object but got ${Ft(e)}`);if(Object.keys(e).length==0)return;const a=e["@type"];if(typeof a!="string"||a=="")throw new Error(`cannot decode message ${n.$typeName} from JSON: "@type" is empty`);const s=a.includes("/")?a.substring(a.lastIndexOf("/")+1):a;if(!s.length)throw new Error(`cannot decode message ${n.$typeName} from JSON: "@type" is invalid`);const r=(i=t.registry)===null||i===void 0?void 0:i.getMessage(s);if(!r)throw new Error(`cannot decode message ${n.$typeName} from JSON: ${a} is not in the type registry`);const o=Tn(r);if(s.startsWith("google.protobuf.")&&Object.prototype.hasOwnProperty.call(e,"value")){const c=e.value;Ja(o,c,t)}else{const c=Object.assign({},e);delete c["@type"],Ja(o,c,t)}WS(o.desc,o.message,n)}function SM(n,e){if(typeof e!="string")throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Ft(e)}`);const t=e.match(/^([0-9]{4})-([0-9]{2})-([0-9]{2})T([0-9]{2}):([0-9]{2}):([0-9]{2})(?:\.([0-9]{1,9}))?(?:Z|([+-][0-9][0-9]:[0-9][0-9]))$/);if(!t)throw new Error(`cannot decode message ${n.$typeName} from JSON: invalid RFC 3339 string`);const i=Date.parse(t[1]+"-"+t[2]+"-"+t[3]+"T"+t[4]+":"+t[5]+":"+t[6]+(t[8]?t[8]:"Z"));if(Number.isNaN(i))throw new Error(`cannot decode message ${n.$typeName} from JSON: invalid RFC 3339 string`);if(i<Date.parse("0001-01-01T00:00:00Z")||i>Date.parse("9999-12-31T23:59:59Z"))throw new Error(`cannot decode message ${n.$typeName} from JSON: must be from 0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z inclusive`);n.seconds=ft.parse(i/1e3),n.nanos=0,t[7]&&(n.nanos=parseInt("1"+t[7]+"0".repeat(9-t[7].length))-1e9)}function MM(n,e){if(typeof e!="string")throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Ft(e)}`);const t=e.match(/^(-?[0-9]+)(?:\.([0-9]+))?s/);if(t===null)throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Ft(e)}`);const i=Number(t[1]);if(i>315576e6||i<-315576e6)throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Ft(e)}`);if(n.seconds=ft.parse(i),typeof t[2]!="string")return;const a=t[2]+"0".repeat(9-t[2].length);n.nanos=parseInt(a),(i<0||Object.is(i,-0))&&(n.nanos=-n.nanos)}function AM(n,e){if(typeof e!="string")throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Ft(e)}`);if(e==="")return;function t(i){if(i.includes("_"))throw new Error(`cannot decode message ${n.$typeName} from JSON: path names must be lowerCamelCase`);const a=i.replace(/[A-Z]/g,s=>"_"+s.toLowerCase());return a[0]==="_"?a.substring(1):a}n.paths=e.split(",").map(t)}function Xm(n,e){if(typeof e!="object"||e==null||Array.isArray(e))throw new Error(`cannot decode message ${n.$typeName} from JSON ${Ft(e)}`);for(const[t,i]of Object.entries(e)){const a=fn(zm);Hd(a,i),n.fields[t]=a}}function Hd(n,e){switch(typeof e){case"number":n.kind={case:"numberValue",value:e};break;case"string":n.kind={case:"stringValue",value:e};break;case"boolean":n.kind={case:"boolValue",value:e};break;case"object":if(e===null)n.kind={case:"nullValue",value:Hl.NULL_VALUE};else if(Array.isArray(e)){const t=fn(ZS);Ym(t,e),n.kind={case:"listValue",value:t}}else{const t=fn(YS);Xm(t,e),n.kind={case:"structValue",value:t}}break;default:throw new Error(`cannot decode message ${n.$typeName} from JSON ${Ft(e)}`)}return n}function Ym(n,e){if(!Array.isArray(e))throw new Error(`cannot decode message ${n.$typeName} from JSON ${Ft(e)}`);for(const t of e){const i=fn(zm);Hd(i,t),n.values.push(i)}}function of(n){const e=Le[n];return typeof e!="string"?n.toString():e[0].toLowerCase()+e.substring(1).replace(/[A-Z]/g,t=>"_"+t.toLowerCase())}class Je extends Error{constructor(e,t=Le.Unknown,i,a,s){super(wM(e,t)),this.name="ConnectError",Object.setPrototypeOf(this,new.target.prototype),this.rawMessage=e,this.code=t,this.metadata=new Headers(i??{}),this.details=a??[],this.cause=s}static from(e,t=Le.Unknown){return e instanceof Je?e:e instanceof Error?e.name=="AbortError"||e.name=="TimeoutError"?new Je(e.message,Le.Canceled):new Je(e.message,t,void 0,void 0,e):new Je(String(e),t,void 0,void 0,e)}static[Symbol.hasInstance](e){return e instanceof Error?Object.getPrototypeOf(e)===Je.prototype?!0:e.name==="ConnectError"&&"code"in e&&typeof e.code=="number"&&"metadata"in e&&"details"in e&&Array.isArray(e.details)&&"rawMessage"in e&&typeof e.rawMessage=="string"&&"cause"in e:!1}findDetails(e){const t=e.kind==="message"?{getMessage:a=>a===e.typeName?e:void 0}:e,i=[];for(const a of this.details){if("desc"in a){t.getMessage(a.desc.typeName)&&i.push(fn(a.desc,a.value));continue}const s=t.getMessage(a.type);if(s)try{i.push(is(s,a.value))}catch{}}return i}}function wM(n,e){return n.length?`[${of(e)}] ${n}`:`[${of(e)}]`}function TM(n,e,t){try{const i=xd(n);return e?is(e,i,t):i}catch(i){throw Je.from(i,Le.DataLoss)}}function IM(n,e){const t={};for(const i of n.methods){const a=e(i);a!=null&&(t[i.localName]=a)}return t}const cf=1;function NM(n,e,t=!1){if(e>n){let i=`message size is larger than configured readMaxBytes ${n}`;throw t&&(i=`message size ${e} is larger than configured readMaxBytes ${n}`),new Je(i,Le.ResourceExhausted)}}function RM(n){return new CM(n)}class CM{constructor(e){this.readMaxBytes=e,this.header=new Uint8Array(5),this.headerView=new DataView(this.header.buffer),this.buf=[]}get byteLength(){return this.buf.reduce((e,t)=>e+t.byteLength,0)}decode(e){this.buf.push(e);const t=[];for(;;){let i=this.pop();if(!i)break;t.push(i)}return t}pop(){if(!(!this.env&&(this.env=this.head(),!this.env))&&this.cons(this.env.data)){const e=this.env;return this.env=void 0,e}}head(){if(!this.cons(this.header))return;const e=this.headerView.getUint8(0),t=this.headerView.getUint32(1);return NM(this.readMaxBytes,t,!0),{flags:e,data:new Uint8Array(t)}}cons(e){const t=e.byteLength;if(this.byteLength<t)return!1;let i=0;for(;i<t;){const a=this.buf.shift();a.byteLength>t-i?(e.set(a.subarray(0,t-i),i),this.buf.unshift(a.subarray(t-i)),i+=t-i):(e.set(a,i),i+=a.byteLength)}return!0}}function lf(n){let e;const t=RM(4294967295);return new ReadableStream({start(){e=n.getReader()},async pull(i){let a=!1;for(;!a;){const s=await e.read();if(s.done)t.byteLength>0&&i.error(new Je("protocol error: incomplete envelope",Le.InvalidArgument)),i.close();else for(const r of t.decode(s.value))i.enqueue(r),a=!0}}})}function jl(n,e){const t=new Uint8Array(e.length+5);t.set(e,5);const i=new DataView(t.buffer,t.byteOffset,t.byteLength);return i.setUint8(0,n),i.setUint32(1,e.length),t}var UM=function(n){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var e=n[Symbol.asyncIterator],t;return e?e.call(n):(n=typeof __values=="function"?__values(n):n[Symbol.iterator](),t={},i("next"),i("throw"),i("return"),t[Symbol.asyncIterator]=function(){return this},t);function i(s){t[s]=n[s]&&function(r){return new Promise(function(o,c){r=n[s](r),a(o,c,r.done,r.value)})}}function a(s,r,o,c){Promise.resolve(c).then(function(l){s({value:l,done:o})},r)}},Bs=function(n){return this instanceof Bs?(this.v=n,this):new Bs(n)},PM=function(n,e,t){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var i=t.apply(n,e||[]),a,s=[];return a=Object.create((typeof AsyncIterator=="function"?AsyncIterator:Object).prototype),o("next"),o("throw"),o("return",r),a[Symbol.asyncIterator]=function(){return this},a;function r(f){return function(g){return Promise.resolve(g).then(f,h)}}function o(f,g){i[f]&&(a[f]=function(y){return new Promise(function(p,m){s.push([f,y,p,m])>1||c(f,y)})},g&&(a[f]=g(a[f])))}function c(f,g){try{l(i[f](g))}catch(y){d(s[0][3],y)}}function l(f){f.value instanceof Bs?Promise.resolve(f.value.v).then(u,h):d(s[0][2],f)}function u(f){c("next",f)}function h(f){c("throw",f)}function d(f,g){f(g),s.shift(),s.length&&c(s[0][0],s[0][1])}},LM=function(n){var e,t;return e={},i("next"),i("throw",function(a){throw a}),i("return"),e[Symbol.iterator]=function(){return this},e;function i(a,s){e[a]=n[a]?function(r){return(t=!t)?{value:Bs(n[a](r)),done:!1}:s?s(r):r}:s}};function DM(n){return PM(this,arguments,function*(){yield Bs(yield*LM(UM(n)))})}var Zm=function(n){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var e=n[Symbol.asyncIterator],t;return e?e.call(n):(n=typeof __values=="function"?__values(n):n[Symbol.iterator](),t={},i("next"),i("throw"),i("return"),t[Symbol.asyncIterator]=function(){return this},t);function i(s){t[s]=n[s]&&function(r){return new Promise(function(o,c){r=n[s](r),a(o,c,r.done,r.value)})}}function a(s,r,o,c){Promise.resolve(c).then(function(l){s({value:l,done:o})},r)}},qa=function(n){return this instanceof qa?(this.v=n,this):new qa(n)},OM=function(n){var e,t;return e={},i("next"),i("throw",function(a){throw a}),i("return"),e[Symbol.iterator]=function(){return this},e;function i(a,s){e[a]=n[a]?function(r){return(t=!t)?{value:qa(n[a](r)),done:!1}:s?s(r):r}:s}},FM=function(n,e,t){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var i=t.apply(n,e||[]),a,s=[];return a=Object.create((typeof AsyncIterator=="function"?AsyncIterator:Object).prototype),o("next"),o("throw"),o("return",r),a[Symbol.asyncIterator]=function(){return this},a;function r(f){return function(g){return Promise.resolve(g).then(f,h)}}function o(f,g){i[f]&&(a[f]=function(y){return new Promise(function(p,m){s.push([f,y,p,m])>1||c(f,y)})},g&&(a[f]=g(a[f])))}function c(f,g){try{l(i[f](g))}catch(y){d(s[0][3],y)}}function l(f){f.value instanceof qa?Promise.resolve(f.value.v).then(u,h):d(s[0][2],f)}function u(f){c("next",f)}function h(f){c("throw",f)}function d(f,g){f(g),s.shift(),s.length&&c(s[0][0],s[0][1])}};function Mc(n,e){return IM(n,t=>{switch(t.methodKind){case"unary":return kM(e,t);case"server_streaming":return BM(e,t);case"client_streaming":return VM(e,t);case"bidi_streaming":return zM(e,t);default:return null}})}function kM(n,e){return async(t,i)=>{var a,s;const r=await n.unary(e,i?.signal,i?.timeoutMs,i?.headers,t,i?.contextValues);return(a=i?.onHeader)===null||a===void 0||a.call(i,r.header),(s=i?.onTrailer)===null||s===void 0||s.call(i,r.trailer),r.message}}function BM(n,e){return(t,i)=>Km(n.stream(e,i?.signal,i?.timeoutMs,i?.headers,DM([t]),i?.contextValues),i)}function VM(n,e){return async(t,i)=>{var a,s,r,o,c,l;const u=await n.stream(e,i?.signal,i?.timeoutMs,i?.headers,t,i?.contextValues);(c=i?.onHeader)===null||c===void 0||c.call(i,u.header);let h,d=0;try{for(var f=!0,g=Zm(u.message),y;y=await g.next(),a=y.done,!a;f=!0)o=y.value,f=!1,h=o,d++}catch(p){s={error:p}}finally{try{!f&&!a&&(r=g.return)&&await r.call(g)}finally{if(s)throw s.error}}if(!h)throw new Je("protocol error: missing response message",Le.Unimplemented);if(d>1)throw new Je("protocol error: received extra messages for client streaming method",Le.Unimplemented);return(l=i?.onTrailer)===null||l===void 0||l.call(i,u.trailer),h}}function zM(n,e){return(t,i)=>Km(n.stream(e,i?.signal,i?.timeoutMs,i?.headers,t,i?.contextValues),i)}function Km(n,e){const t=(function(){return FM(this,arguments,function*(){var i,a;const s=yield qa(n);(i=e?.onHeader)===null||i===void 0||i.call(e,s.header),yield qa(yield*OM(Zm(s.message))),(a=e?.onTrailer)===null||a===void 0||a.call(e,s.trailer)})})()[Symbol.asyncIterator]();return{[Symbol.asyncIterator]:()=>({next:()=>t.next()})}}function GM(...n){const e=new AbortController,t=n.filter(a=>a!==void 0).concat(e.signal);for(const a of t){if(a.aborted){i.apply(a);break}a.addEventListener("abort",i)}function i(){e.signal.aborted||e.abort(Jm(this));for(const a of t)a.removeEventListener("abort",i)}return e}function WM(n){const e=new AbortController,t=()=>{e.abort(new Je("the operation timed out",Le.DeadlineExceeded))};let i;return n!==void 0&&(n<=0?t():i=setTimeout(t,n)),{signal:e.signal,cleanup:()=>clearTimeout(i)}}function Jm(n){if(!n.aborted)return;if(n.reason!==void 0)return n.reason;const e=new Error("This operation was aborted");return e.name="AbortError",e}function df(){return{get(n){return n.id in this?this[n.id]:n.defaultValue},set(n,e){return this[n.id]=e,this},delete(n){return delete this[n.id],this}}}const eo=128;function Xl(n){const e=new Headers,t=new TextDecoder().decode(n).split(`\r
`);for(const i of t){if(i==="")continue;const a=i.indexOf(":");if(a>0){const s=i.substring(0,a).trim(),r=i.substring(a+1).trim();e.append(s,r)}}return e}const HM="Content-Type",jM="Grpc-Timeout",$a="Grpc-Status",qm="Grpc-Message",XM="Grpc-Status-Details-Bin",YM="User-Agent",uf="X-User-Agent",ZM="X-Grpc-Web",KM="application/grpc-web+proto",JM="application/grpc-web+json",qM=Qn("CgxzdGF0dXMucHJvdG8SCmdvb2dsZS5ycGMiTgoGU3RhdHVzEgwKBGNvZGUYASABKAUSDwoHbWVzc2FnZRgCIAEoCRIlCgdkZXRhaWxzGAMgAygLMhQuZ29vZ2xlLnByb3RvYnVmLkFueUJeCg5jb20uZ29vZ2xlLnJwY0ILU3RhdHVzUHJvdG9QAVo3Z29vZ2xlLmdvbGFuZy5vcmcvZ2VucHJvdG8vZ29vZ2xlYXBpcy9ycGMvc3RhdHVzO3N0YXR1c6ICA1JQQ2IGcHJvdG8z",[Bm]),$M=_i(qM,0),QM="0";function $m(n){var e;const t=n.get(XM);if(t!=null){const a=TM(t,$M);if(a.code==0)return;const s=new Je(a.message,a.code,n);return s.details=a.details.map(r=>({type:r.typeUrl.substring(r.typeUrl.lastIndexOf("/")+1),value:r.value})),s}const i=n.get($a);if(i!=null){if(i===QM)return;const a=parseInt(i,10);return a in Le?new Je(decodeURIComponent((e=n.get(qm))!==null&&e!==void 0?e:""),a,n):new Je(`invalid grpc-status: ${i}`,Le.Internal,n)}}function hf(n,e){return n.toString().replace(/\/?$/,`/${e.parent.typeName}/${e.name}`)}function Qm(n,e){return fn(n,e)}function eA(n,e){function t(i){return i.done===!0?i:{done:i.done,value:Qm(n,i.value)}}return{[Symbol.asyncIterator](){const i=e[Symbol.asyncIterator](),a={next:()=>i.next().then(t)};return i.throw!==void 0&&(a.throw=s=>i.throw(s).then(t)),i.return!==void 0&&(a.return=s=>i.return(s).then(t)),a}}}function eg(n,e){if(!e)return n;for(const t of e.concat().reverse())n=t(n);return n}function tA(n){var e;const t=Object.assign({},n);return(e=t.ignoreUnknownFields)!==null&&e!==void 0||(t.ignoreUnknownFields=!0),t}function ff(n,e,t,i){const a=e?pf(n.input,i):mf(n.input,t);return{parse:(e?pf(n.output,i):mf(n.output,t)).parse,serialize:a.serialize}}function pf(n,e){return{parse(t){try{return is(n,t,e)}catch(i){const a=i instanceof Error?i.message:String(i);throw new Je(`parse binary: ${a}`,Le.Internal)}},serialize(t){try{return Od(n,t,e)}catch(i){const a=i instanceof Error?i.message:String(i);throw new Je(`serialize binary: ${a}`,Le.Internal)}}}}function mf(n,e){var t,i;const a=(t=e?.textEncoder)!==null&&t!==void 0?t:new TextEncoder,s=(i=e?.textDecoder)!==null&&i!==void 0?i:new TextDecoder,r=tA(e);return{parse(o){try{const c=s.decode(o);return hM(n,c,r)}catch(c){throw Je.from(c,Le.InvalidArgument)}},serialize(o){try{const c=nM(n,o,r);return a.encode(c)}catch(c){throw Je.from(c,Le.Internal)}}}}function nA(n){const e=eg(n.next,n.interceptors),[t,i,a]=tg(n),s=Object.assign(Object.assign({},n.req),{message:Qm(n.req.method.input,n.req.message),signal:t});return e(s).then(r=>(a(),r),i)}function iA(n){const e=eg(n.next,n.interceptors),[t,i,a]=tg(n),s=Object.assign(Object.assign({},n.req),{message:eA(n.req.method.input,n.req.message),signal:t});let r=!1;return t.addEventListener("abort",function(){var o,c;const l=n.req.message[Symbol.asyncIterator]();r||(o=l.throw)===null||o===void 0||o.call(l,this.reason).catch(()=>{}),(c=l.return)===null||c===void 0||c.call(l).catch(()=>{})}),e(s).then(o=>Object.assign(Object.assign({},o),{message:{[Symbol.asyncIterator](){const c=o.message[Symbol.asyncIterator]();return{next(){return c.next().then(l=>(l.done==!0&&(r=!0,a()),l),i)}}}}}),i)}function tg(n){const{signal:e,cleanup:t}=WM(n.timeoutMs),i=GM(n.signal,e);return[i.signal,function(s){const r=Je.from(e.aborted?Jm(e):s);return i.abort(r),t(),Promise.reject(r)},function(){t(),i.abort()}]}function aA(){try{new Headers}catch{throw new Error("connect-web requires the fetch API. Are you running on an old version of Node.js? Node.js is not supported in Connect for Web - please stay tuned for Connect for Node.")}}function Yl(n,e){const t=$m(n);if(t)throw e.forEach((i,a)=>{t.metadata.append(a,i)}),t;if(!e.has($a)&&!n.has($a))throw new Je("protocol error: missing status",Le.Internal)}function gf(n,e,t,i){var a,s;const r=new Headers(t??{});r.set(HM,n?KM:JM),r.set(ZM,"1");const o=(s=(a=r.get(YM))!==null&&a!==void 0?a:r.get(uf))!==null&&s!==void 0?s:"connect-es/2.0.4";return r.set(uf,o),e!==void 0&&r.set(jM,`${e}m`),r}function sA(n){switch(n){case 400:return Le.Internal;case 401:return Le.Unauthenticated;case 403:return Le.PermissionDenied;case 404:return Le.Unimplemented;case 429:return Le.Unavailable;case 502:return Le.Unavailable;case 503:return Le.Unavailable;case 504:return Le.Unavailable;default:return Le.Unknown}}function Zl(n,e){var t;if(n>=200&&n<300)return{foundStatus:e.has($a),headerError:$m(e)};throw new Je(decodeURIComponent((t=e.get(qm))!==null&&t!==void 0?t:`HTTP ${n}`),sA(n),e)}var $i=function(n){return this instanceof $i?(this.v=n,this):new $i(n)},rA=function(n,e,t){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var i=t.apply(n,e||[]),a,s=[];return a=Object.create((typeof AsyncIterator=="function"?AsyncIterator:Object).prototype),o("next"),o("throw"),o("return",r),a[Symbol.asyncIterator]=function(){return this},a;function r(f){return function(g){return Promise.resolve(g).then(f,h)}}function o(f,g){i[f]&&(a[f]=function(y){return new Promise(function(p,m){s.push([f,y,p,m])>1||c(f,y)})},g&&(a[f]=g(a[f])))}function c(f,g){try{l(i[f](g))}catch(y){d(s[0][3],y)}}function l(f){f.value instanceof $i?Promise.resolve(f.value.v).then(u,h):d(s[0][2],f)}function u(f){c("next",f)}function h(f){c("throw",f)}function d(f,g){f(g),s.shift(),s.length&&c(s[0][0],s[0][1])}};const bf={redirect:"error"};function oA(n){var e;aA();const t=(e=n.useBinaryFormat)!==null&&e!==void 0?e:!0;return{async unary(i,a,s,r,o,c){const{serialize:l,parse:u}=ff(i,t,n.jsonOptions,n.binaryOptions);return s=s===void 0?n.defaultTimeoutMs:s<=0?void 0:s,await nA({interceptors:n.interceptors,signal:a,timeoutMs:s,req:{stream:!1,service:i.parent,method:i,requestMethod:"POST",url:hf(n.baseUrl,i),header:gf(t,s,r),contextValues:c??df(),message:o},next:async h=>{var d;const g=await((d=n.fetch)!==null&&d!==void 0?d:globalThis.fetch)(h.url,Object.assign(Object.assign({},bf),{method:h.requestMethod,headers:h.header,signal:h.signal,body:jl(0,l(h.message))})),{headerError:y}=Zl(g.status,g.headers);if(!g.body)throw y!==void 0?y:"missing response body";const p=lf(g.body).getReader();let m,b;for(;;){const x=await p.read();if(x.done)break;const{flags:v,data:M}=x.value;if((v&cf)===cf)throw new Je("protocol error: received unsupported compressed output",Le.Internal);if(v===eo){if(m!==void 0)throw"extra trailer";m=Xl(M);continue}if(b!==void 0)throw new Je("extra message",Le.Unimplemented);b=u(M)}if(m===void 0)throw y!==void 0?y:new Je("missing trailer",g.headers.has($a)?Le.Unimplemented:Le.Unknown);if(Yl(m,g.headers),b===void 0)throw new Je("missing message",m.has($a)?Le.Unimplemented:Le.Unknown);return{stream:!1,service:i.parent,method:i,header:g.headers,message:b,trailer:m}}})},async stream(i,a,s,r,o,c){const{serialize:l,parse:u}=ff(i,t,n.jsonOptions,n.binaryOptions);function h(f,g,y,p,m){return rA(this,arguments,function*(){const x=lf(f).getReader();if(g){if(!(yield $i(x.read())).done)throw"extra data for trailers-only";return yield $i(void 0)}let v=!1;for(;;){const M=yield $i(x.read());if(M.done)break;const{flags:w,data:N}=M.value;if((w&eo)===eo){if(v)throw"extra trailer";v=!0;const _=Xl(N);Yl(_,p),_.forEach((S,T)=>y.set(T,S));continue}if(v)throw"extra message";yield yield $i(u(N))}if("throwIfAborted"in m&&m.throwIfAborted(),!v)throw"missing trailer"})}async function d(f){if(i.methodKind!="server_streaming")throw"The fetch API does not support streaming request bodies";const g=await f[Symbol.asyncIterator]().next();if(g.done==!0)throw"missing request message";return jl(0,l(g.value))}return s=s===void 0?n.defaultTimeoutMs:s<=0?void 0:s,iA({interceptors:n.interceptors,signal:a,timeoutMs:s,req:{stream:!0,service:i.parent,method:i,requestMethod:"POST",url:hf(n.baseUrl,i),header:gf(t,s,r),contextValues:c??df(),message:o},next:async f=>{var g;const p=await((g=n.fetch)!==null&&g!==void 0?g:globalThis.fetch)(f.url,Object.assign(Object.assign({},bf),{method:f.requestMethod,headers:f.header,signal:f.signal,body:await d(f.message)})),{foundStatus:m,headerError:b}=Zl(p.status,p.headers);if(b!=null)throw b;if(!p.body)throw"missing response body";const x=new Headers;return Object.assign(Object.assign({},f),{header:p.headers,trailer:x,message:h(p.body,m,x,p.headers,f.signal)})}})}}}const ng=Qn("ChZnZW9kZXNpYy92MS9tZXNoLnByb3RvEgtnZW9kZXNpYy52MSKHAQoKRmlsZURpZ2VzdBInCgZmb3JtYXQYASABKA4yFy5nZW9kZXNpYy52MS5NZXNoRm9ybWF0Eg4KBnNoYTI1NhgCIAEoCRIaCg13ZWxkX2Rpc3RhbmNlGAMgASgBSACIAQESEgoKa2VlcF9zZWFtcxgEIAEoCEIQCg5fd2VsZF9kaXN0YW5jZSIoCgVQb2ludBIJCgF4GAEgASgBEgkKAXkYAiABKAESCQoBehgDIAEoASLWBgoETWVzaBIOCgZkaWdlc3QYASABKAkSFAoMdmVydGV4X2NvdW50GAIgASgEEhIKCmZhY2VfY291bnQYAyABKAQSEgoKZWRnZV9jb3VudBgEIAEoBBIbChNib3VuZGFyeV9lZGdlX2NvdW50GAUgASgEEhsKE2JvdW5kYXJ5X2xvb3BfY291bnQYBiABKAQSFwoPY29tcG9uZW50X2NvdW50GAcgASgEEh0KFWlzb2xhdGVkX3ZlcnRleF9jb3VudBgIIAEoBBISCgVnZW51cxgJIAEoA0gAiAEBEhsKE3NhZGRsZV92ZXJ0ZXhfY291bnQYCiABKAQSHQoVZGVnZW5lcmF0ZV9mYWNlX2NvdW50GAsgASgEEiwKEGJvdW5kaW5nX2JveF9taW4YDCABKAsyEi5nZW9kZXNpYy52MS5Qb2ludBIsChBib3VuZGluZ19ib3hfbWF4GA0gASgLMhIuZ2VvZGVzaWMudjEuUG9pbnQSGAoQbWVhbl9lZGdlX2xlbmd0aBgOIAEoARISCgphbmlzb3Ryb3B5GA8gASgBEhYKDnJlc2lkZW50X2J5dGVzGBAgASgEEh8KF25vbl9tYW5pZm9sZF9lZGdlX2NvdW50GBEgASgEEiEKGW5vbl9tYW5pZm9sZF92ZXJ0ZXhfY291bnQYEiABKAQSHwoXaW5jb25zaXN0ZW50X2VkZ2VfY291bnQYEyABKAQSEgoKb3JpZW50YWJsZRgUIAEoCBIUCgxzdG9yZWRfYnl0ZXMYFSABKAQSFgoObGFuZG1hcmtfY291bnQYFiABKA0SNQoQcHJlcGFyZWRfbWV0aG9kcxgXIAMoCzIbLmdlb2Rlc2ljLnYxLlByZXBhcmVkTWV0aG9kEg0KBW5vdGVzGBggAygJEhcKD3NlYW1fZWRnZV9jb3VudBgZIAEoBBIbChNqb2luZWRfdmVydGV4X2NvdW50GBogASgEEhsKE2xlZnRfb3V0X2ZhY2VfY291bnQYGyABKAQSGAoQY2xvc2VfZWRnZV9jb3VudBgcIAEoBBIbChNjbG9zZV9lZGdlX2Rpc3RhbmNlGB0gASgBEhsKE3RvdWNoaW5nX2VkZ2VfY291bnQYHiABKARCCAoGX2dlbnVzIp8BCg5QcmVwYXJlZE1ldGhvZBIpCglhbGdvcml0aG0YASABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SMQoNYXBwcm94aW1hdGlvbhgCIAEoCzIaLmdlb2Rlc2ljLnYxLkFwcHJveGltYXRpb24SFgoOcHJlcGFyZWRfYnl0ZXMYAyABKAQSFwoPcHJlcGFyZV9zZWNvbmRzGAQgASgBKtUBCgpNZXNoRm9ybWF0EhsKF01FU0hfRk9STUFUX1VOU1BFQ0lGSUVEEAASFgoSTUVTSF9GT1JNQVRfQVJSQVlTEAESEwoPTUVTSF9GT1JNQVRfT0JKEAISEwoPTUVTSF9GT1JNQVRfUExZEAMSEwoPTUVTSF9GT1JNQVRfT0ZGEAQSEwoPTUVTSF9GT1JNQVRfU1RMEAUSEwoPTUVTSF9GT1JNQVRfVlRLEAYSFAoQTUVTSF9GT1JNQVRfR0xURhAHEhMKD01FU0hfRk9STUFUX1ZUUBAIQjUKC2dlb2Rlc2ljLnYxUAFaFmdlb2Rlc2ljL3YxO2dlb2Rlc2ljdjGqAgtHZW9kZXNpYy5WMWIGcHJvdG8z",[So]);var Ts=(n=>(n[n.UNSPECIFIED=0]="UNSPECIFIED",n[n.ARRAYS=1]="ARRAYS",n[n.OBJ=2]="OBJ",n[n.PLY=3]="PLY",n[n.OFF=4]="OFF",n[n.STL=5]="STL",n[n.VTK=6]="VTK",n[n.GLTF=7]="GLTF",n[n.VTP=8]="VTP",n))(Ts||{});const cA=Qn("CiZnZW9kZXNpYy92MS9jYXBhYmlsaXRpZXNfc2VydmljZS5wcm90bxILZ2VvZGVzaWMudjEiGAoWR2V0Q2FwYWJpbGl0aWVzUmVxdWVzdCLxAQoXR2V0Q2FwYWJpbGl0aWVzUmVzcG9uc2USDwoHdmVyc2lvbhgBIAEoCRI0CgphbGdvcml0aG1zGAIgAygLMiAuZ2VvZGVzaWMudjEuQWxnb3JpdGhtQ2FwYWJpbGl0eRIoCgdmb3JtYXRzGAMgAygOMhcuZ2VvZGVzaWMudjEuTWVzaEZvcm1hdBIjCgZsaW1pdHMYBCABKAsyEy5nZW9kZXNpYy52MS5MaW1pdHMSQAoWYXBwcm94aW1hdGVfYWxnb3JpdGhtcxgFIAMoCzIgLmdlb2Rlc2ljLnYxLkFsZ29yaXRobUNhcGFiaWxpdHkicwoTQWxnb3JpdGhtQ2FwYWJpbGl0eRIpCglhbGdvcml0aG0YASABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SDAoEbmFtZRgCIAEoCRIPCgdzdW1tYXJ5GAMgASgJEhIKCmlzX2RlZmF1bHQYBCABKAgioAQKBkxpbWl0cxIYChBtYXhfdXBsb2FkX2J5dGVzGAEgASgEEhQKDG1heF92ZXJ0aWNlcxgCIAEoBBIRCgltYXhfZmFjZXMYAyABKAQSEwoLbWF4X3NvdXJjZXMYBCABKAQSGQoRbWF4X21lc3NhZ2VfYnl0ZXMYBSABKAQSGwoTbWF4X2NvbmN1cnJlbnRfam9icxgGIAEoBBIXCg9tYXhfcXVldWVkX2pvYnMYByABKAQSGAoQbWVzaF9zdG9yZV9ieXRlcxgIIAEoBBIZChFmaWVsZF9jYWNoZV9ieXRlcxgJIAEoBBIYChBtYXhfY3VydmVfcG9pbnRzGAogASgEEhMKC21heF90YXJnZXRzGAsgASgEEhIKCm1heF9sZXZlbHMYDCABKAQSEwoLbWF4X3NhbXBsZXMYDSABKAQSFwoPbWF4X21hdHJpeF9yb3dzGA4gASgEEhkKEW1heF9tYXRyaXhfdmFsdWVzGA8gASgEEhcKD21lc2hfZGlza19ieXRlcxgRIAEoBBIYChBmaWVsZF9kaXNrX2J5dGVzGBIgASgEEiIKGm1heF9xdWV1ZWRfam9ic19wZXJfY2xpZW50GBMgASgEEhEKCW1heF9wYWlycxgUIAEoBBIdChVsYW5kbWFya19tZW1vcnlfYnl0ZXMYFSABKAQSHQoVcHJlcGFyZWRfbWVtb3J5X2J5dGVzGBYgASgESgQIEBARMnMKE0NhcGFiaWxpdGllc1NlcnZpY2USXAoPR2V0Q2FwYWJpbGl0aWVzEiMuZ2VvZGVzaWMudjEuR2V0Q2FwYWJpbGl0aWVzUmVxdWVzdBokLmdlb2Rlc2ljLnYxLkdldENhcGFiaWxpdGllc1Jlc3BvbnNlQjUKC2dlb2Rlc2ljLnYxUAFaFmdlb2Rlc2ljL3YxO2dlb2Rlc2ljdjGqAgtHZW9kZXNpYy5WMWIGcHJvdG8z",[ng,So]),lA=kd(cA,0),No=Qn("Ch5nZW9kZXNpYy92MS9tZXNoX3NlcnZpY2UucHJvdG8SC2dlb2Rlc2ljLnYxIlgKGEZpbmRNaXNzaW5nTWVzaGVzUmVxdWVzdBIUCgxtZXNoX2RpZ2VzdHMYASADKAkSJgoFZmlsZXMYAiADKAsyFy5nZW9kZXNpYy52MS5GaWxlRGlnZXN0IpYBChlGaW5kTWlzc2luZ01lc2hlc1Jlc3BvbnNlEhwKFG1pc3NpbmdfbWVzaF9kaWdlc3RzGAEgAygJEi4KDW1pc3NpbmdfZmlsZXMYAiADKAsyFy5nZW9kZXNpYy52MS5GaWxlRGlnZXN0EisKC2tub3duX2ZpbGVzGAMgAygLMhYuZ2VvZGVzaWMudjEuS25vd25GaWxlIkcKCUtub3duRmlsZRIlCgRmaWxlGAEgASgLMhcuZ2VvZGVzaWMudjEuRmlsZURpZ2VzdBITCgttZXNoX2RpZ2VzdBgCIAEoCSJzChFDcmVhdGVNZXNoUmVxdWVzdBIrCgZoZWFkZXIYASABKAsyGS5nZW9kZXNpYy52MS5VcGxvYWRIZWFkZXJIABIpCgVjaHVuaxgCIAEoCzIYLmdlb2Rlc2ljLnYxLlVwbG9hZENodW5rSABCBgoEcGFydCLQAQoMVXBsb2FkSGVhZGVyEicKBmZvcm1hdBgBIAEoDjIXLmdlb2Rlc2ljLnYxLk1lc2hGb3JtYXQSEgoKc2l6ZV9ieXRlcxgCIAEoBBIUCgx2ZXJ0ZXhfY291bnQYAyABKAQSEgoKZmFjZV9jb3VudBgEIAEoBBIXCg9leHBlY3RlZF9kaWdlc3QYBSABKAkSGgoNd2VsZF9kaXN0YW5jZRgGIAEoAUgAiAEBEhIKCmtlZXBfc2VhbXMYByABKAhCEAoOX3dlbGRfZGlzdGFuY2UiKwoLVXBsb2FkQ2h1bmsSDgoGb2Zmc2V0GAEgASgEEgwKBGRhdGEYAiABKAwiTwoSQ3JlYXRlTWVzaFJlc3BvbnNlEh8KBG1lc2gYASABKAsyES5nZW9kZXNpYy52MS5NZXNoEhgKEGFscmVhZHlfcmVzaWRlbnQYAiABKAgiIAoOR2V0TWVzaFJlcXVlc3QSDgoGZGlnZXN0GAEgASgJIjIKD0dldE1lc2hSZXNwb25zZRIfCgRtZXNoGAEgASgLMhEuZ2VvZGVzaWMudjEuTWVzaCIhCg9SZWFkTWVzaFJlcXVlc3QSDgoGZGlnZXN0GAEgASgJIswBChBSZWFkTWVzaFJlc3BvbnNlEi0KBmhlYWRlchgBIAEoCzIbLmdlb2Rlc2ljLnYxLlJlYWRNZXNoSGVhZGVySAASLAoIdmVydGljZXMYAiABKAsyGC5nZW9kZXNpYy52MS5WZXJ0ZXhDaHVua0gAEicKBWZhY2VzGAMgASgLMhYuZ2VvZGVzaWMudjEuRmFjZUNodW5rSAASKgoGam9pbmVkGAQgASgLMhguZ2VvZGVzaWMudjEuSm9pbmVkQ2h1bmtIAEIGCgRwYXJ0IsABCg5SZWFkTWVzaEhlYWRlchIOCgZkaWdlc3QYASABKAkSFAoMdmVydGV4X2NvdW50GAIgASgEEhIKCmZhY2VfY291bnQYAyABKAQSFwoPc2VhbV9lZGdlX2NvdW50GAQgASgEEh4KFmNyb3NzaW5nX3BvbHlnb25fY291bnQYBSABKAQSHgoWZmlyc3RfY3Jvc3NpbmdfcG9seWdvbhgGIAEoBBIbChNqb2luZWRfdmVydGV4X2NvdW50GAcgASgEIjYKC1ZlcnRleENodW5rEhQKDGZpcnN0X3ZlcnRleBgBIAEoBBIRCglwb3NpdGlvbnMYAiABKAwiMAoJRmFjZUNodW5rEhIKCmZpcnN0X2ZhY2UYASABKAQSDwoHaW5kaWNlcxgCIAEoDCIwCgtKb2luZWRDaHVuaxISCgpmaXJzdF9wYWlyGAEgASgEEg0KBXBhaXJzGAIgASgMIjoKEUxpc3RNZXNoZXNSZXF1ZXN0EhEKCXBhZ2Vfc2l6ZRgBIAEoBRISCgpwYWdlX3Rva2VuGAIgASgJIlAKEkxpc3RNZXNoZXNSZXNwb25zZRIhCgZtZXNoZXMYASADKAsyES5nZW9kZXNpYy52MS5NZXNoEhcKD25leHRfcGFnZV90b2tlbhgCIAEoCSIjChFEZWxldGVNZXNoUmVxdWVzdBIOCgZkaWdlc3QYASABKAkiFAoSRGVsZXRlTWVzaFJlc3BvbnNlMvEDCgtNZXNoU2VydmljZRJiChFGaW5kTWlzc2luZ01lc2hlcxIlLmdlb2Rlc2ljLnYxLkZpbmRNaXNzaW5nTWVzaGVzUmVxdWVzdBomLmdlb2Rlc2ljLnYxLkZpbmRNaXNzaW5nTWVzaGVzUmVzcG9uc2USTwoKQ3JlYXRlTWVzaBIeLmdlb2Rlc2ljLnYxLkNyZWF0ZU1lc2hSZXF1ZXN0Gh8uZ2VvZGVzaWMudjEuQ3JlYXRlTWVzaFJlc3BvbnNlKAESRAoHR2V0TWVzaBIbLmdlb2Rlc2ljLnYxLkdldE1lc2hSZXF1ZXN0GhwuZ2VvZGVzaWMudjEuR2V0TWVzaFJlc3BvbnNlEkkKCFJlYWRNZXNoEhwuZ2VvZGVzaWMudjEuUmVhZE1lc2hSZXF1ZXN0Gh0uZ2VvZGVzaWMudjEuUmVhZE1lc2hSZXNwb25zZTABEk0KCkxpc3RNZXNoZXMSHi5nZW9kZXNpYy52MS5MaXN0TWVzaGVzUmVxdWVzdBofLmdlb2Rlc2ljLnYxLkxpc3RNZXNoZXNSZXNwb25zZRJNCgpEZWxldGVNZXNoEh4uZ2VvZGVzaWMudjEuRGVsZXRlTWVzaFJlcXVlc3QaHy5nZW9kZXNpYy52MS5EZWxldGVNZXNoUmVzcG9uc2VCNQoLZ2VvZGVzaWMudjFQAVoWZ2VvZGVzaWMvdjE7Z2VvZGVzaWN2MaoCC0dlb2Rlc2ljLlYxYgZwcm90bzM",[ng]),_f=_i(No,3),dA=_i(No,4),uA=_i(No,6),ig=kd(No,0),hA=Qn("ChhnZW9kZXNpYy92MS9hbnN3ZXIucHJvdG8SC2dlb2Rlc2ljLnYxIsUBCgZBbnN3ZXISKQoGaGVhZGVyGAEgASgLMhkuZ2VvZGVzaWMudjEuQW5zd2VySGVhZGVyEiwKCHByb2dyZXNzGAIgASgLMhouZ2VvZGVzaWMudjEuU29sdmVQcm9ncmVzcxIiCgZibG9ja3MYAyADKAsyEi5nZW9kZXNpYy52MS5CbG9jaxIrCgd0cmFpbGVyGAQgASgLMhouZ2VvZGVzaWMudjEuQW5zd2VyVHJhaWxlchIRCglhbnN3ZXJfaWQYBSABKAkilgIKDEFuc3dlckhlYWRlchITCgttZXNoX2RpZ2VzdBgBIAEoCRIUCgx2ZXJ0ZXhfY291bnQYAiABKAQSKQoJYWxnb3JpdGhtGAMgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEjEKDWFwcHJveGltYXRpb24YBCABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uEhYKDnNlcnZlcl92ZXJzaW9uGAUgASgJEhIKCm1lc2hfbm90ZXMYBiADKAkSKQoGb3JpZ2luGAcgASgOMhkuZ2VvZGVzaWMudjEuQW5zd2VyT3JpZ2luEiYKBmFycmF5cxgIIAMoCzIWLmdlb2Rlc2ljLnYxLkFycmF5SW5mbyJOCglBcnJheUluZm8SDAoEbmFtZRgBIAEoCRIkCgR0eXBlGAIgASgOMhYuZ2VvZGVzaWMudjEuVmFsdWVUeXBlEg0KBXNoYXBlGAMgAygDIjUKBUJsb2NrEg0KBWFycmF5GAEgASgNEg0KBWZpcnN0GAIgASgEEg4KBnZhbHVlcxgDIAEoDCKLAQoNU29sdmVQcm9ncmVzcxIWCg5zZXR0bGVkX3JhZGl1cxgBIAEoARIYChB2ZXJ0aWNlc19yZWFjaGVkGAIgASgEEhQKDGxpdmVfd2luZG93cxgDIAEoBBIaChJ3aW5kb3dzX3Byb3BhZ2F0ZWQYBCABKAQSFgoOaXRlbXNfZmluaXNoZWQYBSABKAQirwIKDUFuc3dlclRyYWlsZXISFwoPY29tcHV0ZV9zZWNvbmRzGAEgASgBEhoKEndpbmRvd3NfcHJvcGFnYXRlZBgCIAEoBBIaChJyZWxhdGl2ZV90b2xlcmFuY2UYAyABKAESHAoPY2VydGlmaWVkX2Vycm9yGAQgASgBSACIAQESKQoGb3JpZ2luGAUgASgOMhkuZ2VvZGVzaWMudjEuQW5zd2VyT3JpZ2luEhYKDnNldHRsZWRfcmFkaXVzGAYgASgBEjAKCnN0YXRpc3RpY3MYByABKAsyHC5nZW9kZXNpYy52MS5Tb2x2ZVN0YXRpc3RpY3MSJgoFcGFpcnMYCCABKAsyFy5nZW9kZXNpYy52MS5QYWlyQ291bnRzQhIKEF9jZXJ0aWZpZWRfZXJyb3IiRwoKUGFpckNvdW50cxIQCghzZWFyY2hlZBgBIAEoBBITCgtmcm9tX2ZpZWxkcxgCIAEoBBISCgpmcm9tX2NhY2hlGAMgASgEItIBCg9Tb2x2ZVN0YXRpc3RpY3MSEgoKaXRlcmF0aW9ucxgBIAEoBBIXCg93aW5kb3dzX2NyZWF0ZWQYAiABKAQSGgoSd2luZG93c19wcm9wYWdhdGVkGAMgASgEEhYKDnBlYWtfd2F2ZWZyb250GAQgASgEEhYKDm1lYW5fd2F2ZWZyb250GAUgASgBEhQKDHBlYWtfd2luZG93cxgGIAEoBBIZChFwZWFrX3NvbHZlcl9ieXRlcxgHIAEoBBIVCg1zb2x2ZV9zZWNvbmRzGAggASgBKn0KDEFuc3dlck9yaWdpbhIdChlBTlNXRVJfT1JJR0lOX1VOU1BFQ0lGSUVEEAASGgoWQU5TV0VSX09SSUdJTl9DT01QVVRFRBABEhgKFEFOU1dFUl9PUklHSU5fSk9JTkVEEAISGAoUQU5TV0VSX09SSUdJTl9DQUNIRUQQA0I1CgtnZW9kZXNpYy52MVABWhZnZW9kZXNpYy92MTtnZW9kZXNpY3YxqgILR2VvZGVzaWMuVjFiBnByb3RvMw",[So]),fA=Qn("ChlnZW9kZXNpYy92MS9zdXJmYWNlLnByb3RvEgtnZW9kZXNpYy52MSJ5CgxTdXJmYWNlUG9pbnQSEAoGdmVydGV4GAEgASgESAASJgoEZWRnZRgCIAEoCzIWLmdlb2Rlc2ljLnYxLkVkZ2VQb2ludEgAEiYKBGZhY2UYAyABKAsyFi5nZW9kZXNpYy52MS5GYWNlUG9pbnRIAEIHCgVwbGFjZSIwCglFZGdlUG9pbnQSDAoEZnJvbRgBIAEoBBIKCgJ0bxgCIAEoBBIJCgF0GAMgASgBIioKCUZhY2VQb2ludBIMCgRmYWNlGAEgASgEEg8KB3dlaWdodHMYAiADKAEiMgoFQ3VydmUSKQoGcG9pbnRzGAEgAygLMhkuZ2VvZGVzaWMudjEuU3VyZmFjZVBvaW50IqgBCgZTb3VyY2USEAoGdmVydGV4GAEgASgESAASJgoEZWRnZRgDIAEoCzIWLmdlb2Rlc2ljLnYxLkVkZ2VQb2ludEgAEiYKBGZhY2UYBCABKAsyFi5nZW9kZXNpYy52MS5GYWNlUG9pbnRIABIjCgVjdXJ2ZRgFIAEoCzISLmdlb2Rlc2ljLnYxLkN1cnZlSAASDgoGb2Zmc2V0GAIgASgBQgcKBXBsYWNlQjUKC2dlb2Rlc2ljLnYxUAFaFmdlb2Rlc2ljL3YxO2dlb2Rlc2ljdjGqAgtHZW9kZXNpYy5WMWIGcHJvdG8z"),pA=Qn("CiJnZW9kZXNpYy92MS9xdWVzdGlvbl9zZXJ2aWNlLnByb3RvEgtnZW9kZXNpYy52MSK3BAoTQ29tcHV0ZUZpZWxkUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIpCglhbGdvcml0aG0YAiABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SMQoNYXBwcm94aW1hdGlvbhgDIAEoCzIaLmdlb2Rlc2ljLnYxLkFwcHJveGltYXRpb24SFgoJdG9sZXJhbmNlGAQgASgBSACIAQESKgoKdmFsdWVfdHlwZRgFIAEoDjIWLmdlb2Rlc2ljLnYxLlZhbHVlVHlwZRInCghwcmlvcml0eRgGIAEoDjIVLmdlb2Rlc2ljLnYxLlByaW9yaXR5EisKCnJlc3VtcHRpb24YByABKAsyFy5nZW9kZXNpYy52MS5SZXN1bXB0aW9uEiQKB3NvdXJjZXMYCiADKAsyEy5nZW9kZXNpYy52MS5Tb3VyY2USKgoHdGFyZ2V0cxgLIAMoCzIZLmdlb2Rlc2ljLnYxLlN1cmZhY2VQb2ludBIWCg52ZXJ0ZXhfdGFyZ2V0cxgMIAMoBxITCgZyYWRpdXMYDSABKAFIAYgBARIfChJzdG9wX2FmdGVyX3RhcmdldHMYDiABKARIAogBARIuCgpxdWFudGl0aWVzGA8gAygOMhouZ2VvZGVzaWMudjEuRmllbGRRdWFudGl0eRITCgtwcm9ncmVzc2l2ZRgQIAEoCEIMCgpfdG9sZXJhbmNlQgkKB19yYWRpdXNCFQoTX3N0b3BfYWZ0ZXJfdGFyZ2V0cyK6AwoTQ29tcHV0ZVBhdGhzUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIpCglhbGdvcml0aG0YAiABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SMQoNYXBwcm94aW1hdGlvbhgDIAEoCzIaLmdlb2Rlc2ljLnYxLkFwcHJveGltYXRpb24SFgoJdG9sZXJhbmNlGAQgASgBSACIAQESKgoKdmFsdWVfdHlwZRgFIAEoDjIWLmdlb2Rlc2ljLnYxLlZhbHVlVHlwZRInCghwcmlvcml0eRgGIAEoDjIVLmdlb2Rlc2ljLnYxLlByaW9yaXR5EisKCnJlc3VtcHRpb24YByABKAsyFy5nZW9kZXNpYy52MS5SZXN1bXB0aW9uEiQKB3NvdXJjZXMYCiADKAsyEy5nZW9kZXNpYy52MS5Tb3VyY2USKgoHdGFyZ2V0cxgLIAMoCzIZLmdlb2Rlc2ljLnYxLlN1cmZhY2VQb2ludBIWCg52ZXJ0ZXhfdGFyZ2V0cxgMIAMoBxITCgZyYWRpdXMYDSABKAFIAYgBAUIMCgpfdG9sZXJhbmNlQgkKB19yYWRpdXMiYQoJUG9pbnRQYWlyEikKBnNvdXJjZRgBIAEoCzIZLmdlb2Rlc2ljLnYxLlN1cmZhY2VQb2ludBIpCgZ0YXJnZXQYAiABKAsyGS5nZW9kZXNpYy52MS5TdXJmYWNlUG9pbnQi/AIKE0NvbXB1dGVQYWlyc1JlcXVlc3QSEwoLbWVzaF9kaWdlc3QYASABKAkSKQoJYWxnb3JpdGhtGAIgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEjEKDWFwcHJveGltYXRpb24YAyABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uEhYKCXRvbGVyYW5jZRgEIAEoAUgAiAEBEioKCnZhbHVlX3R5cGUYBSABKA4yFi5nZW9kZXNpYy52MS5WYWx1ZVR5cGUSJwoIcHJpb3JpdHkYBiABKA4yFS5nZW9kZXNpYy52MS5Qcmlvcml0eRIrCgpyZXN1bXB0aW9uGAcgASgLMhcuZ2VvZGVzaWMudjEuUmVzdW1wdGlvbhIlCgVwYWlycxgKIAMoCzIWLmdlb2Rlc2ljLnYxLlBvaW50UGFpchIUCgx2ZXJ0ZXhfcGFpcnMYCyADKAcSDQoFcGF0aHMYDCABKAhCDAoKX3RvbGVyYW5jZSL+AwoUQ29tcHV0ZU1hdHJpeFJlcXVlc3QSEwoLbWVzaF9kaWdlc3QYASABKAkSKQoJYWxnb3JpdGhtGAIgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEjEKDWFwcHJveGltYXRpb24YAyABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uEhYKCXRvbGVyYW5jZRgEIAEoAUgAiAEBEioKCnZhbHVlX3R5cGUYBSABKA4yFi5nZW9kZXNpYy52MS5WYWx1ZVR5cGUSJwoIcHJpb3JpdHkYBiABKA4yFS5nZW9kZXNpYy52MS5Qcmlvcml0eRIrCgpyZXN1bXB0aW9uGAcgASgLMhcuZ2VvZGVzaWMudjEuUmVzdW1wdGlvbhIkCgdzb3VyY2VzGAogAygLMhMuZ2VvZGVzaWMudjEuU291cmNlEhYKDnZlcnRleF9zb3VyY2VzGAsgAygHEioKB3RhcmdldHMYDCADKAsyGS5nZW9kZXNpYy52MS5TdXJmYWNlUG9pbnQSFgoOdmVydGV4X3RhcmdldHMYDSADKAcSEwoGcmFkaXVzGA4gASgBSAGIAQESKQoGbGF5b3V0GA8gASgOMhkuZ2VvZGVzaWMudjEuTWF0cml4TGF5b3V0QgwKCl90b2xlcmFuY2VCCQoHX3JhZGl1cyLgAwoSRmluZE5lYXJlc3RSZXF1ZXN0EhMKC21lc2hfZGlnZXN0GAEgASgJEikKCWFsZ29yaXRobRgCIAEoDjIWLmdlb2Rlc2ljLnYxLkFsZ29yaXRobRIxCg1hcHByb3hpbWF0aW9uGAMgASgLMhouZ2VvZGVzaWMudjEuQXBwcm94aW1hdGlvbhIWCgl0b2xlcmFuY2UYBCABKAFIAIgBARIqCgp2YWx1ZV90eXBlGAUgASgOMhYuZ2VvZGVzaWMudjEuVmFsdWVUeXBlEicKCHByaW9yaXR5GAYgASgOMhUuZ2VvZGVzaWMudjEuUHJpb3JpdHkSKwoKcmVzdW1wdGlvbhgHIAEoCzIXLmdlb2Rlc2ljLnYxLlJlc3VtcHRpb24SJAoHc291cmNlcxgKIAMoCzITLmdlb2Rlc2ljLnYxLlNvdXJjZRIWCg52ZXJ0ZXhfc291cmNlcxgLIAMoBxIqCgd0YXJnZXRzGAwgAygLMhkuZ2VvZGVzaWMudjEuU3VyZmFjZVBvaW50EhYKDnZlcnRleF90YXJnZXRzGA0gAygHEhMKBnJhZGl1cxgOIAEoAUgBiAEBEg0KBWNvdW50GA8gASgEQgwKCl90b2xlcmFuY2VCCQoHX3JhZGl1cyKTAwoWQ29tcHV0ZUlzb2xpbmVzUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIpCglhbGdvcml0aG0YAiABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SMQoNYXBwcm94aW1hdGlvbhgDIAEoCzIaLmdlb2Rlc2ljLnYxLkFwcHJveGltYXRpb24SFgoJdG9sZXJhbmNlGAQgASgBSACIAQESKgoKdmFsdWVfdHlwZRgFIAEoDjIWLmdlb2Rlc2ljLnYxLlZhbHVlVHlwZRInCghwcmlvcml0eRgGIAEoDjIVLmdlb2Rlc2ljLnYxLlByaW9yaXR5EisKCnJlc3VtcHRpb24YByABKAsyFy5nZW9kZXNpYy52MS5SZXN1bXB0aW9uEiQKB3NvdXJjZXMYCiADKAsyEy5nZW9kZXNpYy52MS5Tb3VyY2USDgoGbGV2ZWxzGAsgAygBEhgKC2Nob3JkX2Vycm9yGAwgASgBSAGIAQFCDAoKX3RvbGVyYW5jZUIOCgxfY2hvcmRfZXJyb3Ii7QIKG1NhbXBsZUZhcnRoZXN0UG9pbnRzUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIpCglhbGdvcml0aG0YAiABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SMQoNYXBwcm94aW1hdGlvbhgDIAEoCzIaLmdlb2Rlc2ljLnYxLkFwcHJveGltYXRpb24SFgoJdG9sZXJhbmNlGAQgASgBSACIAQESKgoKdmFsdWVfdHlwZRgFIAEoDjIWLmdlb2Rlc2ljLnYxLlZhbHVlVHlwZRInCghwcmlvcml0eRgGIAEoDjIVLmdlb2Rlc2ljLnYxLlByaW9yaXR5EisKCnJlc3VtcHRpb24YByABKAsyFy5nZW9kZXNpYy52MS5SZXN1bXB0aW9uEiQKB3NvdXJjZXMYCiADKAsyEy5nZW9kZXNpYy52MS5Tb3VyY2USDQoFY291bnQYCyABKARCDAoKX3RvbGVyYW5jZSL8AgoUQ29tcHV0ZUxvZ01hcFJlcXVlc3QSEwoLbWVzaF9kaWdlc3QYASABKAkSKQoJYWxnb3JpdGhtGAIgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEjEKDWFwcHJveGltYXRpb24YAyABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uEhYKCXRvbGVyYW5jZRgEIAEoAUgAiAEBEioKCnZhbHVlX3R5cGUYBSABKA4yFi5nZW9kZXNpYy52MS5WYWx1ZVR5cGUSJwoIcHJpb3JpdHkYBiABKA4yFS5nZW9kZXNpYy52MS5Qcmlvcml0eRIrCgpyZXN1bXB0aW9uGAcgASgLMhcuZ2VvZGVzaWMudjEuUmVzdW1wdGlvbhIpCgZzb3VyY2UYCiABKAsyGS5nZW9kZXNpYy52MS5TdXJmYWNlUG9pbnQSEwoGcmFkaXVzGAsgASgBSAGIAQFCDAoKX3RvbGVyYW5jZUIJCgdfcmFkaXVzItADChFUcmFjZUxpbmVzUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIpCglhbGdvcml0aG0YAiABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SMQoNYXBwcm94aW1hdGlvbhgDIAEoCzIaLmdlb2Rlc2ljLnYxLkFwcHJveGltYXRpb24SFgoJdG9sZXJhbmNlGAQgASgBSACIAQESKgoKdmFsdWVfdHlwZRgFIAEoDjIWLmdlb2Rlc2ljLnYxLlZhbHVlVHlwZRInCghwcmlvcml0eRgGIAEoDjIVLmdlb2Rlc2ljLnYxLlByaW9yaXR5EisKCnJlc3VtcHRpb24YByABKAsyFy5nZW9kZXNpYy52MS5SZXN1bXB0aW9uEioKB3NvdXJjZXMYCiADKAsyGS5nZW9kZXNpYy52MS5TdXJmYWNlUG9pbnQSFgoOdmVydGV4X3NvdXJjZXMYCyADKAcSDgoGYW5nbGVzGAwgAygBEg8KB3ZlY3RvcnMYDSADKAESKgoHdG93YXJkcxgOIAMoCzIZLmdlb2Rlc2ljLnYxLlN1cmZhY2VQb2ludBIPCgdsZW5ndGhzGA8gAygBQgwKCl90b2xlcmFuY2UqkwEKDUZpZWxkUXVhbnRpdHkSHgoaRklFTERfUVVBTlRJVFlfVU5TUEVDSUZJRUQQABIhCh1GSUVMRF9RVUFOVElUWV9ORUFSRVNUX1NPVVJDRRABEhsKF0ZJRUxEX1FVQU5USVRZX0dSQURJRU5UEAISIgoeRklFTERfUVVBTlRJVFlfQ0VSVElGSUVEX0VSUk9SEAMqYAoMTWF0cml4TGF5b3V0Eh0KGU1BVFJJWF9MQVlPVVRfVU5TUEVDSUZJRUQQABIXChNNQVRSSVhfTEFZT1VUX0RFTlNFEAESGAoUTUFUUklYX0xBWU9VVF9TUEFSU0UQAjK2BQoPUXVlc3Rpb25TZXJ2aWNlEkcKDENvbXB1dGVGaWVsZBIgLmdlb2Rlc2ljLnYxLkNvbXB1dGVGaWVsZFJlcXVlc3QaEy5nZW9kZXNpYy52MS5BbnN3ZXIwARJHCgxDb21wdXRlUGF0aHMSIC5nZW9kZXNpYy52MS5Db21wdXRlUGF0aHNSZXF1ZXN0GhMuZ2VvZGVzaWMudjEuQW5zd2VyMAESRwoMQ29tcHV0ZVBhaXJzEiAuZ2VvZGVzaWMudjEuQ29tcHV0ZVBhaXJzUmVxdWVzdBoTLmdlb2Rlc2ljLnYxLkFuc3dlcjABEkkKDUNvbXB1dGVNYXRyaXgSIS5nZW9kZXNpYy52MS5Db21wdXRlTWF0cml4UmVxdWVzdBoTLmdlb2Rlc2ljLnYxLkFuc3dlcjABEkUKC0ZpbmROZWFyZXN0Eh8uZ2VvZGVzaWMudjEuRmluZE5lYXJlc3RSZXF1ZXN0GhMuZ2VvZGVzaWMudjEuQW5zd2VyMAESTQoPQ29tcHV0ZUlzb2xpbmVzEiMuZ2VvZGVzaWMudjEuQ29tcHV0ZUlzb2xpbmVzUmVxdWVzdBoTLmdlb2Rlc2ljLnYxLkFuc3dlcjABElcKFFNhbXBsZUZhcnRoZXN0UG9pbnRzEiguZ2VvZGVzaWMudjEuU2FtcGxlRmFydGhlc3RQb2ludHNSZXF1ZXN0GhMuZ2VvZGVzaWMudjEuQW5zd2VyMAESSQoNQ29tcHV0ZUxvZ01hcBIhLmdlb2Rlc2ljLnYxLkNvbXB1dGVMb2dNYXBSZXF1ZXN0GhMuZ2VvZGVzaWMudjEuQW5zd2VyMAESQwoKVHJhY2VMaW5lcxIeLmdlb2Rlc2ljLnYxLlRyYWNlTGluZXNSZXF1ZXN0GhMuZ2VvZGVzaWMudjEuQW5zd2VyMAFCNQoLZ2VvZGVzaWMudjFQAVoWZ2VvZGVzaWMvdjE7Z2VvZGVzaWN2MaoCC0dlb2Rlc2ljLlYxYgZwcm90bzM",[hA,So,fA]);var ag=(n=>(n[n.UNSPECIFIED=0]="UNSPECIFIED",n[n.NEAREST_SOURCE=1]="NEAREST_SOURCE",n[n.GRADIENT=2]="GRADIENT",n[n.CERTIFIED_ERROR=3]="CERTIFIED_ERROR",n))(ag||{});const mA=kd(pA,0);class gA{constructor(e,t){this.baseUrl=e,this.token=t;const a=oA({baseUrl:e,interceptors:[s=>r=>(this.token&&r.header.set("authorization",`Bearer ${this.token}`),s(r))]});this.capabilities=Mc(lA,a),this.meshes=Mc(ig,a),this.questions=Mc(mA,a)}baseUrl;token;capabilities;meshes;questions}function ei(n,e){return{signal:e,headers:{"geo-mesh-digest":n}}}function Qa(n){switch(n.kind){case"vertex":return{place:{case:"vertex",value:BigInt(n.vertex)}};case"edge":return{place:{case:"edge",value:{from:BigInt(n.from),to:BigInt(n.to),t:n.t}}};case"face":return{place:{case:"face",value:{face:BigInt(n.face),weights:[...n.weights]}}}}}function sg(n){return"curve"in n?{place:{case:"curve",value:{points:n.curve.map(Qa)}}}:{place:Qa(n).place}}function rg(n){const e=n.get("point_numbers",Uint32Array),t=n.get("point_weights",Float64Array);return Array.from(n.get("point_kind",Uint8Array),(i,a)=>{const[s,r]=e.subarray(2*a),[o,c,l]=t.subarray(3*a);return i===1?{kind:"edge",from:s,to:r,t:o}:i===2?{kind:"face",face:s,weights:[o,c,l]}:{kind:"vertex",vertex:s}})}function mo({question:n}){return"direction"in n}async function bA(n,e,t,i){return"direction"in t?vA(n,e,t,i):_A(n,e,t,i)}async function _A(n,e,{sources:t,target:i,algorithm:a},s){const{arrays:r}=await oa(n.questions.computePaths({meshDigest:e,algorithm:a,sources:t.map(sg),targets:[Qa(i)]},ei(e,s))),o=og(r);if(!o.places.length)return;const c=t[r.get("source",Uint32Array)[0]];return{...o,question:{from:"curve"in c?o.places[0]:c,target:i}}}async function vA(n,e,t,i){const{from:a,direction:s,length:r}=t,{arrays:o}=await oa(n.questions.traceLines({meshDigest:e,sources:[Qa(a)],vectors:[...s],lengths:[r]},ei(e,i))),c=[void 0,"boundary","singular"][o.get("end",Uint8Array)[0]];return{...og(o),question:t,ended:c}}async function yA(n,e,t,i){const a=t.slice(1).map((o,c)=>({source:Qa(t[c]),target:Qa(o)})),{arrays:s}=await oa(n.questions.computePairs({meshDigest:e,pairs:a,paths:!0},ei(e,i))),r=new Set([0,...Array.from(s.get("line_end",BigUint64Array),Number)]);if(r.size<=a.length)throw new Error("No path leads along this curve.");return rg(s).filter((o,c)=>c===0||!r.has(c))}function og(n){return{positions:n.get("position",Float64Array),places:rg(n),length:n.get("length",Float64Array)[0]}}const xA=`
attribute vec3 fill;
uniform sampler2D depths;
uniform float size;
uniform float pixelRatio;
varying vec3 vFill;
varying float vSeen;
const float kDepthError = 2e-3;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  vec3 screen = 0.5 * gl_Position.xyz / gl_Position.w + 0.5;
  vSeen = screen.z <= texture2D(depths, screen.xy).r + kDepthError ? 1.0 : 0.0;
  vFill = fill;
  gl_PointSize = size * pixelRatio;
}`,EA=`
uniform float size;
uniform float pixelRatio;
varying vec3 vFill;
varying float vSeen;
void main() {
  float r = length(2.0 * gl_PointCoord - 1.0);
  float soft = 2.5 / (size * pixelRatio);
  float disk = 1.0 - smoothstep(1.0 - soft, 1.0, r);
  float inner = 1.0 - smoothstep(0.66 - soft, 0.66, r);
  bool seen = vSeen > 0.5;
  float alpha = seen ? disk : 0.45 * (disk - inner);
  if (alpha < 0.02) discard;
  gl_FragColor = vec4(seen ? mix(vec3(0.06, 0.06, 0.09), vFill, inner) : vFill, alpha);
}`;class vf extends r0{constructor(e,t){super(new Kt,new on({vertexShader:xA,fragmentShader:EA,transparent:!0,depthTest:!1,depthWrite:!1,uniforms:{size:{value:e},depths:t.depths,pixelRatio:t.pixelRatio}})),this.frustumCulled=!1,this.renderOrder=20,this.visible=!1}setDots(e){this.geometry.dispose(),this.geometry=new Kt;const t=new Float32Array(e.flatMap(a=>Array.from(a.point))),i=new Float32Array(e.flatMap(a=>[...a.fill]));this.geometry.setAttribute("position",new St(t,3)),this.geometry.setAttribute("fill",new St(i,3)),this.visible=e.length>0}}const yf=new kt,Mr=new U;class cg extends m0{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";const e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Mn(e,3)),this.setAttribute("uv",new Mn(t,2))}applyMatrix4(e){const t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));const i=new Dl(t,6,1);return this.setAttribute("instanceStart",new Ui(i,3,0)),this.setAttribute("instanceEnd",new Ui(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));const i=new Dl(t,6,1);return this.setAttribute("instanceColorStart",new Ui(i,3,0)),this.setAttribute("instanceColorEnd",new Ui(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new c0(e.geometry)),this}fromLineSegments(e){const t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new kt);const e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),yf.setFromBufferAttribute(t),this.boundingBox.union(yf))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ts),this.boundingBox===null&&this.computeBoundingBox();const e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){const i=this.boundingSphere.center;this.boundingBox.getCenter(i);let a=0;for(let s=0,r=e.count;s<r;s++)Mr.fromBufferAttribute(e,s),a=Math.max(a,i.distanceToSquared(Mr)),Mr.fromBufferAttribute(t,s),a=Math.max(a,i.distanceToSquared(Mr));this.boundingSphere.radius=Math.sqrt(a),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}}ce.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new we(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};an.line={uniforms:gd.merge([ce.common,ce.fog,ce.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		void trimSegment( const in vec4 start, inout vec4 end ) {

			// trim end segment so it terminates between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column
			float nearEstimate = - 0.5 * b / a;

			float alpha = ( nearEstimate - start.z ) / ( end.z - start.z );

			end.xyz = mix( start.xyz, end.xyz, alpha );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? dashScale * instanceDistanceStart : dashScale * instanceDistanceEnd;
				vUv = uv;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					trimSegment( start, end );

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					trimSegment( end, start );

				}

			}

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = normalize( mix( start.xyz, end.xyz, 0.5 ) );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;
				clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				// Find the closest points on the view ray and the line segment
				vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
				vec3 lineDir = worldEnd - worldStart;
				vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

				vec3 p1 = worldStart + lineDir * params.x;
				vec3 p2 = rayEnd * params.y;
				vec3 delta = p1 - p2;
				float len = length( delta );
				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};class jd extends on{constructor(e){super({type:"LineMaterial",uniforms:gd.clone(an.line.uniforms),vertexShader:an.line.vertexShader,fragmentShader:an.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}}const Ac=new ut,xf=new U,Ef=new U,Bt=new ut,Vt=new ut,Gn=new ut,wc=new U,Tc=new qe,zt=new $n,Sf=new U,Ar=new kt,wr=new ts,Wn=new ut;let Yn,Qi;function Mf(n,e,t){return Wn.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),Wn.multiplyScalar(1/Wn.w),Wn.x=Qi/t.width,Wn.y=Qi/t.height,Wn.applyMatrix4(n.projectionMatrixInverse),Wn.multiplyScalar(1/Wn.w),Math.abs(Math.max(Wn.x,Wn.y))}function SA(n,e){const t=n.matrixWorld,i=n.geometry,a=i.attributes.instanceStart,s=i.attributes.instanceEnd,r=Math.min(i.instanceCount,a.count);for(let o=0,c=r;o<c;o++){zt.start.fromBufferAttribute(a,o),zt.end.fromBufferAttribute(s,o),zt.applyMatrix4(t);const l=new U,u=new U;Yn.distanceSqToSegment(zt.start,zt.end,u,l),u.distanceTo(l)<Qi*.5&&e.push({point:u,pointOnLine:l,distance:Yn.origin.distanceTo(u),object:n,face:null,faceIndex:o,uv:null,uv1:null})}}function MA(n,e,t){const i=e.projectionMatrix,s=n.material.resolution,r=n.matrixWorld,o=n.geometry,c=o.attributes.instanceStart,l=o.attributes.instanceEnd,u=Math.min(o.instanceCount,c.count),h=-e.near;Yn.at(1,Gn),Gn.w=1,Gn.applyMatrix4(e.matrixWorldInverse),Gn.applyMatrix4(i),Gn.multiplyScalar(1/Gn.w),Gn.x*=s.x/2,Gn.y*=s.y/2,Gn.z=0,wc.copy(Gn),Tc.multiplyMatrices(e.matrixWorldInverse,r);for(let d=0,f=u;d<f;d++){if(Bt.fromBufferAttribute(c,d),Vt.fromBufferAttribute(l,d),Bt.w=1,Vt.w=1,Bt.applyMatrix4(Tc),Vt.applyMatrix4(Tc),Bt.z>h&&Vt.z>h)continue;if(Bt.z>h){const x=Bt.z-Vt.z,v=(Bt.z-h)/x;Bt.lerp(Vt,v)}else if(Vt.z>h){const x=Vt.z-Bt.z,v=(Vt.z-h)/x;Vt.lerp(Bt,v)}Bt.applyMatrix4(i),Vt.applyMatrix4(i),Bt.multiplyScalar(1/Bt.w),Vt.multiplyScalar(1/Vt.w),Bt.x*=s.x/2,Bt.y*=s.y/2,Vt.x*=s.x/2,Vt.y*=s.y/2,zt.start.copy(Bt),zt.start.z=0,zt.end.copy(Vt),zt.end.z=0;const y=zt.closestPointToPointParameter(wc,!0);zt.at(y,Sf);const p=Dp.lerp(Bt.z,Vt.z,y),m=p>=-1&&p<=1,b=wc.distanceTo(Sf)<Qi*.5;if(m&&b){zt.start.fromBufferAttribute(c,d),zt.end.fromBufferAttribute(l,d),zt.start.applyMatrix4(r),zt.end.applyMatrix4(r);const x=new U,v=new U;Yn.distanceSqToSegment(zt.start,zt.end,v,x),t.push({point:v,pointOnLine:x,distance:Yn.origin.distanceTo(v),object:n,face:null,faceIndex:d,uv:null,uv1:null})}}}class AA extends An{constructor(e=new cg,t=new jd({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){const e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,a=new Float32Array(2*t.count);for(let r=0,o=0,c=t.count;r<c;r++,o+=2)xf.fromBufferAttribute(t,r),Ef.fromBufferAttribute(i,r),a[o]=o===0?0:a[o-1],a[o+1]=a[o]+xf.distanceTo(Ef);const s=new Dl(a,2,1);return e.setAttribute("instanceDistanceStart",new Ui(s,1,0)),e.setAttribute("instanceDistanceEnd",new Ui(s,1,1)),this}raycast(e,t){const i=this.material.worldUnits,a=e.camera;a===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');const s=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Yn=e.ray;const r=this.matrixWorld,o=this.geometry,c=this.material;Qi=c.linewidth+s,o.boundingSphere===null&&o.computeBoundingSphere(),wr.copy(o.boundingSphere).applyMatrix4(r);let l;if(i)l=Qi*.5;else{const h=Math.max(a.near,wr.distanceToPoint(Yn.origin));l=Mf(a,h,c.resolution)}if(wr.radius+=l,Yn.intersectsSphere(wr)===!1)return;o.boundingBox===null&&o.computeBoundingBox(),Ar.copy(o.boundingBox).applyMatrix4(r);let u;if(i)u=Qi*.5;else{const h=Math.max(a.near,Ar.distanceToPoint(Yn.origin));u=Mf(a,h,c.resolution)}Ar.expandByScalar(u),Yn.intersectsBox(Ar)!==!1&&(i?SA(this,t):MA(this,a,t))}onBeforeRender(e){const t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Ac),this.material.uniforms.resolution.value.set(Ac.z,Ac.w))}}class Kl extends cg{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){const t=e.length-3,i=new Float32Array(2*t);for(let a=0;a<t;a+=3)i[2*a]=e[a],i[2*a+1]=e[a+1],i[2*a+2]=e[a+2],i[2*a+3]=e[a+3],i[2*a+4]=e[a+4],i[2*a+5]=e[a+5];return super.setPositions(i),this}setColors(e){const t=e.length-3,i=new Float32Array(2*t);for(let a=0;a<t;a+=3)i[2*a]=e[a],i[2*a+1]=e[a+1],i[2*a+2]=e[a+2],i[2*a+3]=e[a+3],i[2*a+4]=e[a+4],i[2*a+5]=e[a+5];return super.setColors(i),this}setFromPoints(e){const t=e.length-1,i=new Float32Array(6*t);for(let a=0;a<t;a++)i[6*a]=e[a].x,i[6*a+1]=e[a].y,i[6*a+2]=e[a].z||0,i[6*a+3]=e[a+1].x,i[6*a+4]=e[a+1].y,i[6*a+5]=e[a+1].z||0;return super.setPositions(i),this}fromLine(e){const t=e.geometry;return this.setPositions(t.attributes.position.array),this}}class wA extends AA{constructor(e=new Kl,t=new jd({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}}class Xd extends xs{geometry=new Kl;passes;constructor(e,t,i){super();const a=[{color:e,width:.75*t,opacity:.32,hidden:!0},{color:1052696,width:1.9*t,opacity:.85,hidden:!1},{color:e,width:t,opacity:1,hidden:!1}];this.passes=a.map((s,r)=>{const o=new jd({color:new Ze(s.color),linewidth:s.width,transparent:!0,opacity:s.opacity,depthWrite:!1,depthFunc:s.hidden?io:ta});o.resolution=i;const c=new wA(this.geometry,o);return c.renderOrder=10+r,c.frustumCulled=!1,c}),this.add(...this.passes),this.visible=!1}setPoints(e){this.geometry.dispose(),this.geometry=new Kl,this.visible=e.length>=6,this.visible&&this.geometry.setPositions(e);for(const t of this.passes)t.geometry=this.geometry}dispose(){this.geometry.dispose();for(const e of this.passes)e.material.dispose()}}const TA=16747586,IA=16743110,lg=9425919,Af=[1,1,1],NA=[.55,.83,1],RA=[1,.55,.26],CA=[1,.48,.78];class UA{constructor(e){this.scene=e,this.dots=new vf(15,e),this.samples=new vf(10,e),e.overlay.add(this.samples,this.dots)}scene;lines=new Map;dots;samples;show(e,{sources:t,paths:i,samples:a},s){this.dropLinesBut(new Set([...i,...t]));for(const c of i)this.addLine(e,c,mo(c)?IA:TA,c.positions);const r=[],o=(c,l)=>r.push({point:c.toArray(),fill:l});t.forEach((c,l)=>{"curve"in c?this.addLine(e,c,lg,new Float64Array(c.curve.flatMap(u=>e.positionOf(u)))):o(Is(e,c),s?po[l%po.length].map(u=>u/255):Af)});for(const c of i){const l=mo(c)?CA:RA,{from:u}=c.question;kS(u,t)||o(Is(e,u),l),o(dg(e,c),l)}this.dots.setDots(r),this.samples.setDots(a.map(({vertex:c})=>({point:Is(e,{kind:"vertex",vertex:c}).toArray(),fill:NA})))}warmUp(){this.dots.setDots([{point:[0,0,0],fill:Af}])}addLine(e,t,i,a){if(this.lines.has(t))return;const s=new Xd(i,3,this.scene.resolution);s.setPoints(e.toScreen(a)),this.lines.set(t,s),this.scene.overlay.add(s)}dropLinesBut(e){for(const[t,i]of this.lines)e.has(t)||(this.scene.overlay.remove(i),i.dispose(),this.lines.delete(t))}}function Is(n,e){return new U(...n.toScreen(new Float64Array(n.positionOf(e))))}function dg(n,{positions:e}){return new U(...n.toScreen(e.slice(-3)))}class ug{constructor(e){this.patienceMs=e}patienceMs;running;waiting;timer;ask(e){if(this.waiting=e,!this.running){this.run();return}const t=performance.now()-this.running.since;this.timer??=setTimeout(()=>this.running?.abort.abort(),Math.max(this.patienceMs-t,0))}stop(){this.waiting=void 0,this.running?.abort.abort()}async run(){for(;this.waiting;){const e=this.waiting;this.waiting=void 0,this.running={abort:new AbortController,since:performance.now()},await e(this.running.abort.signal),clearTimeout(this.timer),this.timer=void 0,this.running=void 0}}}async function PA(n,e,t,i){let a=0;const{trailer:s}=await oa(n.questions.computeField({...Ro(e),radius:e.radius,progressive:!0},ei(e.digest,i)),r=>{const o=r.get("settled_vertex",Uint32Array,a),c=r.get("settled_distance",Float64Array,a).subarray(0,o.length);t({vertices:o.subarray(0,c.length),distances:c}),a+=c.length});return hg(s)}async function Ic(n,e,t){const{arrays:i,trailer:a}=await oa(n.questions.computeField({...Ro(e),radius:e.radius,tolerance:e.tolerance},ei(e.digest,t)));return{distances:i.get("distance",Float64Array),summary:hg(a)}}async function LA(n,e,t){const{arrays:i}=await oa(n.questions.computeField({...Ro(e),radius:e.radius,quantities:[ag.NEAREST_SOURCE]},ei(e.digest,t)));return i.get("nearest_source",Uint32Array)}async function DA(n,e,t,i){const{arrays:a}=await oa(n.questions.sampleFarthestPoints({...Ro(e),count:BigInt(t)},ei(e.digest,i))),s=a.get("distance",Float64Array);return Array.from(a.get("vertex",Uint32Array),(r,o)=>({vertex:r,distance:s[o]}))}function hg(n){return{settledRadius:n.settledRadius,solveSeconds:n.statistics?.solveSeconds??0}}function Ro(n){return{meshDigest:n.digest,algorithm:n.algorithm,sources:n.sources.map(sg)}}function OA(n,e){const t=new Float32Array(n.length),i=[0,0];let a=0,s=0,r=0;for(let c=0;c<n.length;c++){const l=e[c]-n[c];if(!Number.isFinite(l)){if(n[c]===e[c])continue;r++,t[c]=NaN;continue}t[c]=Math.abs(l),i[0]=Math.min(i[0],l),i[1]=Math.max(i[1],l),n[c]>0&&(a+=t[c]/n[c],s++)}const o=Math.max(-i[0],i[1]);if(o>0)for(let c=0;c<t.length;c++)t[c]/=o;return{shares:t,largest:o,range:i,meanRelative:a/Math.max(s,1),oneSided:r}}const FA=.001,fg="within 0.1 %",kA=3e5;function BA(n,e){const{algorithm:t,sources:i}=e,a=t===ks.UNSPECIFIED||t===ks.FWP_LIST,s=i.every(o=>!("curve"in o)),r=s&&i.every(o=>"kind"in o&&o.kind==="vertex");return n.faceCount>kA&&a&&(r||s&&i.length===1)}const VA=1500,zA=2e3;class GA{constructor(e,t,i,a){this.scene=e,this.asking=t,this.placed=i,this.events=a,e.onFrame=s=>{const r=this.shown?.advance(s,this.still.matches)??!1;return this.shown?.hasSwept&&this.swept?.(),document.documentElement.dataset.sweep=this.shown?.hasArrived?"done":this.shown?.hasSwept?"preview":"",r},e.isWaiting=()=>this.waiting&&!this.swept,e.isBusy=()=>this.waiting||this.summary!==void 0&&this.shown?.hasArrived===!1}scene;asking;placed;events;shown;summary;algorithm=ks.UNSPECIFIED;against=ks.UNSPECIFIED;sources=[];wantsCells=!1;reach=1/0;dragged=new ug(zA);asked=new AbortController;waiting=!1;swept;still=matchMedia("(prefers-reduced-motion: reduce)");get isWaiting(){return this.waiting}reaches(e){return(e??1/0)<=this.reach}get signal(){return this.asked.signal}question(e){const{sources:t,radius:i}=this.placed();return{digest:e.digest,sources:t,algorithm:this.algorithm,radius:i}}takeAway(e){this.asked.abort(),this.dragged.stop(),this.events.left(),this.shown=void 0,this.sources=[],this.summary=void 0,this.reach=1/0,this.waiting=!1,e&&new ef(e,this.scene.material,new U,!0)}async ask(e){const{sources:t}=this.placed();if(!t.length)return;this.asked.abort(),this.dragged.stop(),this.events.left();const i=this.asked=new AbortController,a=!this.shown,s=this.begin(e,t);document.documentElement.dataset.sweep="",this.summary=void 0,this.waiting=!0,this.events.changed(),a?this.scene.redraw():this.scene.redrawSurface();const r=this.newQuestion(e);try{BA(e,r)&&await this.preview(r,s,i.signal);const o=await this.asking.answerTo(e,()=>PA(this.asking.connection,r,c=>{s.add(c.vertices,c.distances),s.isPreview||this.scene.redrawSurface()},i.signal));if(i.signal.aborted)return;this.answer(o,r),s.finish(),this.showsCells&&this.paintCells(e,s)}catch(o){this.asking.report(o,()=>{i===this.asked&&!i.signal.aborted&&this.ask(e)})}finally{i===this.asked&&(this.waiting=!1),this.events.changed(),this.scene.redrawSurface()}}follow(e){this.asked.abort(),this.asked=new AbortController,this.waiting=!1,this.events.left(),this.dragged.ask(t=>this.followOnce(e,t))}get showsCells(){return this.wantsCells&&this.placed().sources.length>1}showCells(e,t){const{shown:i}=this;this.wantsCells=t,!(!e||!i)&&(this.showsCells?this.paintCells(e,i):(i.paintDistances(),this.events.repainted()))}async compare(e,t){const{shown:i}=this,a={...this.question(e),algorithm:t},{signal:s}=this,{distances:r}=await this.asking.answerTo(e,()=>Ic(this.asking.connection,a,s));if(!i||i!==this.shown)return;const o=OA(i.distances,r);return this.wantsCells=!1,this.against=t,i.paintDifference(o),this.events.repainted(),o}async preview(e,t,i){try{const{distances:a}=await Ic(this.asking.connection,{...e,tolerance:FA},i);if(i.aborted)return;t.showPreview(a),this.events.changed(),this.scene.redrawSurface(),await this.sweep()}catch{}}async sweep(){let e;await new Promise(t=>{this.swept=e=t,setTimeout(t,VA)}),this.swept===e&&(this.swept=void 0)}async paintCells(e,t){try{const{signal:i}=this,a=await this.asking.answerTo(e,()=>LA(this.asking.connection,this.question(e),i));if(t!==this.shown||!this.showsCells)return;t.paintCells(a),this.events.repainted()}catch(i){this.asking.reportAbout(e,i,()=>this.paintCells(e,t))}}async followOnce(e,t){const{sources:i}=this.placed();try{const a=this.newQuestion(e),{distances:s,summary:r}=await this.asking.answerTo(e,()=>Ic(this.asking.connection,a,t));if(t.aborted)return;const o=this.begin(e,i);o.setAll(s),this.answer(r,a),this.events.changed(),this.scene.redrawSurface(),this.showsCells&&await this.paintCells(e,o)}catch(a){this.asking.reportAbout(e,a,()=>this.ask(e))}}begin(e,t){const[i]=t,a="curve"in i?i.curve[0]:i,s=Is(e,a),r=t.every(o=>!("curve"in o));return this.sources=t,this.shown=new ef(e,this.scene.material,s,r)}newQuestion(e){const t=this.question(e);return this.reach=t.radius??1/0,t}answer(e,{radius:t}){this.reach=Math.min(e.settledRadius,t??1/0),this.summary={...e,settledRadius:this.reach}}}class WA{past=[];future=[];gesture;get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}record(e,t){this.future.length=0,(t===void 0||t!==this.gesture)&&this.past.push(e),this.gesture=t}undo(e){return this.go(this.past,this.future,e)}redo(e){return this.go(this.future,this.past,e)}cancel(e){if(!(e===void 0||e!==this.gesture))return this.gesture=void 0,this.past.pop()}clear(){this.past.length=this.future.length=0,this.gesture=void 0}go(e,t,i){this.gesture=void 0;const a=e.pop();return a!==void 0&&t.push(i),a}}const HA=16777215,jA=250;class XA{constructor(e,t){this.scene=e,this.actions=t,this.line=new Xd(HA,3,e.resolution),e.overlay.add(this.line)}scene;actions;line;newest=new ug(jA);aimed;lead(e,t,i){const a=this.aimed={mesh:e,ask:t,since:i};this.newest.ask(s=>this.draw(a,s))}hide(){this.aimed=void 0,this.newest.stop(),this.line.visible&&(this.line.setPoints(new Float32Array),this.scene.redraw())}warmUp(){this.line.setPoints(new Float32Array([-2,0,0,2,0,0]))}async draw({mesh:e,ask:t,since:i},a){try{const s=await t(a);if(this.aimed?.mesh!==e||a.aborted)return;this.line.setPoints(s?e.toScreen(s.positions):new Float32Array),this.actions.value(s?.length),this.scene.draw(),performance.measure("path under the cursor",{start:i,end:performance.now()})}catch(s){this.actions.failed(s,()=>{this.aimed&&this.lead(this.aimed.mesh,this.aimed.ask,this.aimed.since)})}}}function ea(n){if(n instanceof DOMException&&n.name==="AbortError")return"cancelled";if(n instanceof TypeError)return"gone";if(!(n instanceof Je)||YA(n))return"refused";switch(n.code){case Le.Canceled:return"cancelled";case Le.Unauthenticated:case Le.PermissionDenied:return"token";case Le.Unavailable:return"gone";case Le.NotFound:return"forgotten";case Le.ResourceExhausted:return pg(n)===void 0?"refused":"full";default:return n.code===Le.Unknown?"gone":"refused"}}function pg(n){const e=n instanceof Je?n.metadata.get("grpc-retry-pushback-ms"):null;return e!==null&&/^\d+$/.test(e)?Number(e):void 0}function fs(n){switch(ea(n)){case"cancelled":return"Stopped.";case"gone":return"The server does not answer.";case"forgotten":return"The server has lost this mesh.";default:return n instanceof Je?wf(ZA(n.rawMessage)):wf(n instanceof Error?n.message:String(n))}}function YA(n){return/^HTTP 4\d\d$/.test(n.rawMessage)&&n.rawMessage!=="HTTP 429"}function ZA(n){switch(n){case"HTTP 403":return`The server answers no page of ${location.origin}: its flag --web-allow-origin must name this address.`;case"HTTP 413":return"The server, or a proxy before it, refuses files of this size.";default:return n}}function wf(n){const e=n.trim()||"It failed for an unknown reason";return e[0].toUpperCase()+e.slice(1)+(/[.!?]$/.test(e)?"":".")}class KA{constructor(e,t,i){this.asking=t,this.events=i,this.live=new XA(e,{value:a=>i.value(a??this.unreached),failed:(a,s)=>t.report(a,s)})}asking;events;awaited=[];live;unreached;lead(e,t,i){this.unreached="target"in t?1/0:void 0,this.live.lead(e,a=>this.askLive(e,t,a),i)}hide(){this.live.hide()}warmUp(){this.live.warmUp()}async keep(e,t){const{signal:i}=this.asking;try{const a=await this.ask(e,t,i);if(i.aborted)return;a?a.length>0&&this.events.kept(a):this.events.told("No path leads there.")}catch(a){this.asking.reportAbout(e,a,()=>this.keep(e,t))}}async fetch(e,t,i=this.asking.signal){try{for(let a=this.awaited[0];a&&!i.aborted;a=this.awaited[0]){const s="target"in a?{sources:[a.from],target:a.target,algorithm:t}:a,r=await this.ask(e,s,i);a===this.awaited[0]&&(this.awaited=this.awaited.slice(1),r?this.events.came(r):this.events.told("The address names a path between places that nothing connects."))}}catch(a){this.asking.reportAbout(e,a,()=>this.fetch(e,t,i))}}async askLive(e,t,i){try{return await this.ask(e,t,i)}catch(a){if("direction"in t&&ea(a)==="refused")return;throw a}}ask(e,t,i){return this.asking.answerTo(e,()=>bA(this.asking.connection,e.digest,t,i))}}async function mg(n,e){try{return await n()}catch(t){if(ea(t)!=="forgotten"||!await e())throw t;return n()}}class JA{constructor(e,t){this.connection=e,this.events=t}connection;events;shown;abort=new AbortController;show(e){this.abort.abort(),this.abort=new AbortController,this.shown=e}get signal(){return this.abort.signal}answerTo(e,t){return mg(t,()=>this.events.lost(e))}reportAbout(e,t,i){this.report(t,()=>{e===this.shown&&i()})}report(e,t){ea(e)!=="cancelled"&&this.events.failed(e,t)}}class qA{constructor(e,t,i){this.scene=e,this.events=i,this.asking=new JA(t,i),this.fields=new GA(e,this.asking,()=>this.placed,{changed:()=>i.changed(),repainted:()=>{this.drawMarks(),i.changed(),e.redrawSurface()},left:()=>this.hideLive()}),this.lines=new KA(e,this.asking,{value:a=>i.value(a,!0),told:a=>i.told(a),kept:a=>{this.change(this.withPath(a))},came:a=>{this.put(this.withPath(a))}}),this.sketch=new Xd(lg,3,e.resolution),e.overlay.add(this.sketch),this.marks=new UA(e)}scene;events;mesh;fields;placed=hs;history=new WA;asking;lines;sketch;marks;get field(){return this.fields.shown}get summary(){return this.fields.summary}get sources(){return this.placed.sources}get paths(){return this.placed.paths}get awaitedPaths(){return this.lines.awaited}get samples(){return this.placed.samples}get radius(){return this.placed.radius}get isEmpty(){return FS(this.placed)}get canUndo(){return this.history.canUndo}get canRedo(){return this.history.canRedo}get exactField(){return this.summary&&tf(this.sources,this.fields.sources)?this.field:void 0}show(e){const t=e.digest===this.mesh?.digest?this.placed:void 0;this.asking.show(e),this.mesh?.dispose(),this.mesh=e,t||this.history.clear(),this.placed=hs,this.lines.awaited=[],this.fields.takeAway(this.mesh),this.showRadius(e),this.scene.show(e),this.lines.warmUp(),this.marks.warmUp(),this.scene.draw(),this.lines.hide(),this.put(t??hs)}showCoarse(e,t){e===this.mesh&&(e.awaitsCoarse=!1,t&&e.setCoarse(t),this.events.changed(),this.scene.redrawSurface())}clear(){this.isEmpty||this.change(hs)}setSources(e){return this.change({...this.placed,sources:e,samples:[]})}undo(){this.goTo(this.history.undo(this.placed))}redo(){this.goTo(this.history.redo(this.placed))}cancel(e){this.goTo(this.history.cancel(e))}async ask(e,t,i,a){const s={...hs,sources:e,radius:i};this.lines.awaited=t,a?this.change(s):this.put(s),this.mesh&&await this.lines.fetch(this.mesh,this.fields.algorithm)}moveSource(e,t,i){const{mesh:a}=this;a&&(this.history.record(this.placed,i),this.placed={...this.placed,sources:this.sources.map((s,r)=>r===e?t:s),samples:[]},this.drawMarks(),this.scene.redraw(),this.fields.follow(a))}async askField(){this.mesh&&await this.fields.ask(this.mesh)}dropSource(){this.events.changed()}async compare(e,t){const{mesh:i}=this;if(!(!i||!this.summary))try{return t&&await this.moveToVertices(i),await this.fields.compare(i,e)}catch(a){this.asking.report(a,()=>{});return}}hover(e,t){const{mesh:i}=this;if(!e||!this.field||!i){this.hideLive();return}const a=this.field.at(e.face,e.weights);if(this.events.value(a===1/0?void 0:a,!1),this.summary&&a===1/0&&this.summary.settledRadius===1/0){this.hideLive(),this.events.value(1/0,!0);return}this.lines.lead(i,this.pathTo(e),t)}async keepPath(e){this.mesh&&this.sources.length&&await this.lines.keep(this.mesh,this.pathTo(e))}get straightLength(){const e=this.exactField?.largest;return e&&(this.radius??e)||void 0}leadStraight(e,t,i){const a=this.straightLine(e,t);this.mesh&&a&&this.lines.lead(this.mesh,a,i)}async keepStraight(e,t){const i=this.straightLine(e,t);this.hideLive(),this.mesh&&i&&await this.lines.keep(this.mesh,i)}removePath(e){this.change({...this.placed,paths:this.paths.filter(t=>t!==e)})}removeLast(){const e=this.paths.at(-1);e?this.removePath(e):this.sources.length&&this.setSources(this.sources.slice(0,-1))}drawSketch(e){this.sketch.setPoints(new Float32Array(e.flatMap(t=>t.toArray()))),this.scene.redraw()}async addCurve(e,t){const{mesh:i}=this;if(this.drawSketch([]),!(!i||e.length<2))try{const{signal:a}=this.asking,s=await this.asking.answerTo(i,()=>yA(this.asking.connection,i.digest,e,a));if(i!==this.mesh)return;await this.setSources([...t?[]:this.sources,{curve:s}])}catch(a){this.asking.reportAbout(i,a,()=>this.addCurve(e,t))}}async sample(e){const{mesh:t}=this;if(!t||!this.sources.length)return;const{signal:i}=this.fields;try{const a=await this.asking.answerTo(t,()=>DA(this.asking.connection,this.fields.question(t),e,i));this.change({...this.placed,samples:a})}catch(a){this.asking.reportAbout(t,a,()=>this.sample(e))}}setRadius(e){e!==this.radius&&this.change({...this.placed,radius:e},"radius")}change(e,t){return this.history.record(this.placed,t),this.put(e)}goTo(e){e&&this.put(e)}async put(e){const{sources:t,radius:i,field:a}=this;if(this.placed=e,this.mesh&&this.showRadius(this.mesh),e.sources.length||this.fields.takeAway(this.mesh),this.drawMarks(),e.sources.length&&(!tf(t,e.sources)||!this.fields.reaches(e.radius)))return this.askField();this.events.changed(),i===e.radius&&a===this.field?this.scene.redraw():this.scene.redrawSurface()}showRadius(e){const{radius:t}=this;this.scene.material.uniforms.radius.value=t===void 0?1e10:t/e.radius}withPath(e){return{...this.placed,paths:[...this.paths,e]}}async moveToVertices(e){const t=this.sources.map(i=>{if("curve"in i)throw new Error("Approximate algorithms take points, no curves.");return i});t.every(i=>i.kind==="vertex")||(this.events.told("Sources are at the nearest vertices now: approximate algorithms measure between vertices."),await this.setSources(t.map(i=>({kind:"vertex",vertex:e.nearestCorner(i)}))))}pathTo(e){return{sources:this.sources,target:e,algorithm:this.fields.algorithm}}straightLine(e,t){const{mesh:i,straightLength:a}=this;if(!i||a===void 0)return;const[s,r]=[e,t].map(o=>i.positionOf(o));return{from:e,direction:[r[0]-s[0],r[1]-s[1],r[2]-s[2]],length:a}}hideLive(){this.lines.hide(),this.events.value(void 0,!1)}drawMarks(){this.mesh&&this.marks.show(this.mesh,this.placed,this.field?.painted==="cells")}sourcesOnScreen(){const{mesh:e}=this;return this.sources.map(t=>e&&!("curve"in t)?Is(e,t):void 0)}pathEnds(){const{mesh:e}=this;return e?this.paths.map(t=>({point:dg(e,t),length:t.length})):[]}}function $t(n,e=6){if(n===1/0)return"∞";const t=Number(n.toPrecision(e)),i=Math.abs(t);return i!==0&&(i<1e-4||i>=1e7)?t.toExponential():String(t)}function go(n){return n.toLocaleString("en")}function Vs(n,e){return n===0?`no ${e}`:n===1?`1 ${e}`:`${go(n)} ${e}s`}function Ae(n){const e=document.getElementById(n);if(!e)throw new Error(`The page has no element "${n}".`);return e}function Gt(n,e){Ae(n).addEventListener("click",e)}function zs(n,e){const t=document.createElement(n);return t.textContent=e,t}class $A{notes=Ae("mesh-notes");row=Ae("joining");choice=Ae("join");distance=Ae("join-distance");constructor(e){this.choice.addEventListener("change",()=>this.showDistance()),Gt("join-again",()=>{this.choice.value!=="distance"?e({keepSeams:this.choice.value==="none"}):this.distance.reportValidity()&&e({keepSeams:!1,weldDistance:this.distance.valueAsNumber})})}show(e,t){this.notes.hidden=e.length===0,this.notes.replaceChildren(...e.map(i=>{const a=document.createElement("li");return a.textContent=i,a})),this.row.hidden=!t,this.choice.value=t?.keepSeams?"none":t?.weldDistance===void 0?"rounding":"distance",t?.weldDistance!==void 0&&(this.distance.value=String(t.weldDistance)),this.showDistance()}showDistance(){this.distance.hidden=this.choice.value!=="distance"}}function Tf({keepSeams:n,weldDistance:e}){return n?"nothing joined":e===void 0?"":`joined within ${e}`}const QA=3e5,ew=15e4,tw=6e4,gg=4e6,nw=5e5,iw=/swiftshader|llvmpipe|softpipe|software|basic render/i,aw=300;class sw{constructor(e,t){this.still=t,this.inSoftware=iw.test(e)}still;changing=!0;timer;inSoftware;get coarseFaces(){return this.inSoftware?tw:ew}mayBeWhole(e){return e.faceCount<=(this.inSoftware?nw:gg)}change(){this.changing=!0,clearTimeout(this.timer)}isCoarse(e){return e.coarse!==void 0&&(this.changing||!this.mayBeWhole(e))}get isDraft(){return this.inSoftware&&this.changing}name(e){if(e.awaitsCoarse)return"coming";const t=this.isCoarse(e);return t&&this.mayBeWhole(e)?"coarse":this.isDraft?"draft":t?"always coarse":"whole"}drawn(e,t){clearTimeout(this.timer),!(!(this.isDraft||this.isCoarse(e)&&this.mayBeWhole(e))||t)&&(this.timer=setTimeout(()=>{this.settle(),this.still()},aw))}settle(){clearTimeout(this.timer),this.changing=!1}}function rw(n){return n.faceCount<=gg}async function ow(n,e,t,i){let a=new Float64Array(0),s=new Uint32Array(0),r=0;for await(const{part:o}of n.meshes.readMesh({digest:e},ei(e,i)))o.case==="header"?(a=new Float64Array(3*Number(o.value.vertexCount)),s=new Uint32Array(3*Number(o.value.faceCount))):o.case==="vertices"?r+=If(o.value.positions,a,3*Number(o.value.firstVertex)):o.case==="faces"&&(r+=If(o.value.indices,s,3*Number(o.value.firstFace))),t(r/Math.max(a.byteLength+s.byteLength,1));return{positions:a,indices:s}}function If(n,e,t){return new Uint8Array(e.buffer).set(n,t*e.BYTES_PER_ELEMENT),n.length}const cw={glb:Ts.GLTF},bg={...Object.fromEntries(Object.entries(Ts).filter(([,n])=>typeof n=="number"&&n!==Ts.UNSPECIFIED&&n!==Ts.ARRAYS).map(([n,e])=>[n.toLowerCase(),e])),...cw},_g=Object.keys(bg).map(n=>`.${n}`),Nf=512*1024;function vg(n){const e=n.toLowerCase().replace(/\.gz$/,"").split(".").pop()??"",t=bg[e];if(t===void 0)throw new Error(`Meshes are files in ${_g.join(", ")}, or these with .gz; ${n} is none.`);return t}async function lw(n,e,t,i,a,s=""){const r={format:vg(e.name),...t},o=new Uint8Array(await e.arrayBuffer());return await dw(n,r,o,a,s)??uw(n,r,o,i,a,s)}async function dw(n,e,t,i,a){if(!globalThis.crypto?.subtle)return;const s=new Uint8Array(await crypto.subtle.digest("SHA-256",t)),r=Array.from(s,c=>c.toString(16).padStart(2,"0")).join("");return(await n.meshes.findMissingMeshes({files:[{...e,sha256:r}]},ei(a||r,i))).knownFiles[0]?.meshDigest}async function uw(n,e,t,i,a,s){const r=new Blob([...hw(e,t)],{type:"application/grpc-web+proto"}),o=await fw(n,r,i,a,s),c=pw(o);return is(uA,c).mesh?.digest??""}function*hw(n,e){const t=i=>jl(0,Od(_f,fn(_f,{part:i})));yield t({case:"header",value:fn(dA,{...n,sizeBytes:BigInt(e.length)})});for(let i=0;i<e.length;i+=Nf){const a=e.subarray(i,i+Nf);yield t({case:"chunk",value:{$typeName:"geodesic.v1.UploadChunk",offset:BigInt(i),data:a}})}}function fw(n,e,t,i,a){return new Promise((s,r)=>{const o=new XMLHttpRequest;o.open("POST",`${n.baseUrl}/${ig.typeName}/CreateMesh`),o.responseType="arraybuffer",o.setRequestHeader("content-type","application/grpc-web+proto"),o.setRequestHeader("x-grpc-web","1"),n.token&&o.setRequestHeader("authorization",`Bearer ${n.token}`),a&&o.setRequestHeader("geo-mesh-digest",a),o.upload.onprogress=c=>t(c.loaded/Math.max(c.total,1)),o.onload=()=>s(o),o.onerror=()=>r(new Je("the upload broke off",Le.Unavailable)),o.onabort=()=>r(new Je("stopped",Le.Canceled)),i.addEventListener("abort",()=>o.abort()),o.send(e)})}function pw(n){const e=new Headers;for(const o of n.getAllResponseHeaders().trim().split(/[\r\n]+/)){const c=o.indexOf(":");c>0&&e.append(o.slice(0,c),o.slice(c+1).trim())}const{headerError:t}=Zl(n.status,e);if(t)throw t;const i=new Uint8Array(n.response),a=new DataView(i.buffer);let s,r=!1;for(let o=0;o+5<=i.length;){const c=i[o],l=a.getUint32(o+1),u=i.subarray(o+5,o+5+l);o+=5+l,c&eo?(Yl(Xl(u),e),r=!0):s=u}if(!r||!s)throw new Je("the answer broke off",Le.Unavailable);return s}function mw(n,e){const t=new Float32Array(n.length);for(let i=0;i<e.length;i+=3){const a=3*e[i],s=3*e[i+1],r=3*e[i+2],o=n[s]-n[a],c=n[s+1]-n[a+1],l=n[s+2]-n[a+2],u=n[r]-n[a],h=n[r+1]-n[a+1],d=n[r+2]-n[a+2],f=c*d-l*h,g=l*u-o*d,y=o*h-c*u;for(const p of[a,s,r])t[p]+=f,t[p+1]+=g,t[p+2]+=y}for(let i=0;i<t.length;i+=3){const a=Math.hypot(t[i],t[i+1],t[i+2])||1;for(let s=0;s<3;s++)t[i+s]/=a}return t}const gw=1e-6;class bw{constructor(e,t,i){this.arrays=e,this.digest=t,this.name=i,this.vertexCount=e.positions.length/3,this.faceCount=e.indices.length/3;const a=_w(e),{low:s,high:r}=vw(a);this.center=[0,1,2].map(c=>(s[c]+r[c])/2),this.radius=Math.hypot(...[0,1,2].map(c=>(r[c]-s[c])/2))||1;const o=this.toScreen(e.positions);this.framed=a===e.positions?o:this.toScreen(a),this.geometry=new Kt,this.geometry.setAttribute("position",new St(o,3)),this.geometry.setAttribute("normal",new St(mw(o,e.indices),3)),this.geometry.setIndex(new St(e.indices,1))}arrays;digest;name;vertexCount;faceCount;geometry;coarse;framed;isFile=!1;awaitsCoarse=!1;center;radius;setCoarse(e){this.coarse?.dispose(),this.coarse=new Kt;for(const[t,i]of Object.entries(this.geometry.attributes))this.coarse.setAttribute(t,i);this.coarse.setIndex(new St(e,1))}setAttribute(e,t){for(const i of[this.geometry,this.coarse])t?i?.setAttribute(e,t):i?.deleteAttribute(e)}toScreen(e){const t=new Float32Array(e.length);for(let i=0;i<e.length;i+=3)for(let a=0;a<3;a++)t[i+a]=(e[i+a]-this.center[a])/this.radius;return t}get hasArea(){const e=this.geometry.getAttribute("position"),[t,i,a]=[new U,new U,new U];let s=0;for(let r=0;r<this.faceCount;r++)if([t,i,a].forEach((o,c)=>o.fromBufferAttribute(e,this.arrays.indices[3*r+c])),s+=i.sub(t).cross(a.sub(t)).length()/2,s>gw)return!0;return!1}cornersOf(e){const{indices:t}=this.arrays;return[t[3*e],t[3*e+1],t[3*e+2]]}vertexPosition(e){const{positions:t}=this.arrays;return[t[3*e],t[3*e+1],t[3*e+2]]}positionOf(e){return this.weighted(e).reduce((t,[i,a])=>{const s=this.vertexPosition(i);return[t[0]+a*s[0],t[1]+a*s[1],t[2]+a*s[2]]},[0,0,0])}nearestCorner(e){return this.weighted(e).reduce((t,i)=>i[1]>t[1]?i:t)[0]}holds(e){return e.kind==="face"?e.face<this.faceCount:this.weighted(e).every(([t])=>t<this.vertexCount)}holdsSource(e){return"curve"in e?e.curve.every(t=>this.holds(t)):this.holds(e)}holdsLine(e){return this.holds(e.from)&&(!("target"in e)||this.holds(e.target))}weighted(e){return e.kind==="vertex"?[[e.vertex,1]]:e.kind==="edge"?[[e.from,1-e.t],[e.to,e.t]]:this.cornersOf(e.face).map((t,i)=>[t,e.weights[i]])}dispose(){this.geometry.dispose(),this.coarse?.dispose()}}function _w({positions:n,indices:e}){const t=new Uint8Array(n.length/3);for(const r of e)t[r]=1;const i=t.reduce((r,o)=>r+o,0);if(i===0||i===t.length)return n;const a=new Float64Array(3*i);let s=0;return t.forEach((r,o)=>{r&&(a.set(n.subarray(3*o,3*o+3),s),s+=3)}),a}function vw(n){const e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i+=3)for(let a=0;a<3;a++){const s=n[i+a];s<e[a]&&(e[a]=s),s>t[a]&&(t[a]=s)}return n.length?{low:e,high:t}:{low:[0,0,0],high:[0,0,0]}}const yg=`(function(){"use strict";var C=(function(){var E="b9H79Tebbbe;veC9Geueu9Geub9Gbb9Gsuuuuuuuuuuuu99uueu9Gvuuuuub9Gruuuuuuub9Gouuuuuue999Gvuuuuueu9Gzuuuuuuuuuuu99uuuub9Gquuuuuuu99uueu9GPuuuuuuuuuuu99uueu9Gquuuuuuuu99ueu9Gruuuuuu99eu9Gwuuuuuu99ueu9Giuuue999GDuuuuuuuuueu9Gkuuuuuuuu99uub9Gluuuueu9Gluuuub9Giuuueui3EdilvorlwDiqkrxmPszdHObAAbeAlve9Weiiviebeoweuecj:Gdkr:Sdmo9TW9T9VV95dbH9F9F939H79T9F9J9H229F9Jt9VV7bbz9TW79O9V9Wt9F79P9T9W29P9M95bw8E9TW79O9V9Wt9F79P9T9W29P9M959x9Pt9OcttV9P9I91tW7bD8A9TW79O9V9Wt9F79P9T9W29P9M959x9Pt9O9v9W9K9HtWbqQ9TW79O9V9Wt9F79P9T9W29P9M959t29V9W9W95bkX9TW79O9V9Wt9F79P9T9W29P9M959qV919UWbmQ9TW79O9V9Wt9F79P9T9W29P9M959q9V9P9Ut7bPX9TW79O9V9Wt9F79P9T9W29P9M959t9J9H2WbsP9TW79O9V9Wt9FVW9TW79Obza9TW79O9V9Wt9F9V9Wt9P9T9P96W9wWVtW94SWt9J9O9sW9T9H9WbA59TW79O9V9Wt9F9NW9UWV9HtW9q9V79Pt9P9V9U9sW9T9H9WbCl79IV9RbXDwebcekdKYq:p:1dElbzOk:Q:tekYue99iuQ99eui99Due99xue9:w998Jjjjjbcj;sb9Rgs8Kjjjjbcbhzasc:Cefcbc;Kbz:xjjjb8AdnabaeSmbabaeadcdtz:wjjjb8AkdnamcdGTmbalcrfci4cbyd;y:L:cjbHjjjjbbhHasc:Cefasyd;8egecdtfaHBdbasaecefBd;8ecbhlcbhednadTmbabheadhOinaHaeydbci4fcb86bbaeclfheaOcufgOmbkcbhlabheadhOinaHaeydbgAci4fgCaCRbbgCceaAcrGgAtV86bbaCcu7aA4ceGalfhlaeclfheaOcufgOmbkcualcdtalcFFFFi0Ehekaecbyd;y:L:cjbHjjjjbbhzasc:Cefasyd;8egecdtfazBdbasaecefBd;8ealcd4alfhOcehHinaHgecethHaeaO6mbkcbhXcuaecdtgOaecFFFFi0Ecbyd;y:L:cjbHjjjjbbhHasc:Cefasyd;8egAcdtfaHBdbasaAcefBd;8eaHcFeaOz:xjjjbhQdnadTmbaecufhLcbhKindndnaQabaKcdtfgYydbgAc:v;t;h;Ev2aLGgOcdtfgCydbgHcuSmbceheinazaHcdtfydbaASmdaOaefhHaecefheaQaHaLGgOcdtfgCydbgHcu9hmbkkazaXcdtfaABdbaCaXBdbaXhHaXcefhXkaYaHBdbaKcefgKad9hmbkkaQcbyd;C:L:cjbH:bjjjbbasasyd;8ecufBd;8ekcbh8AcualcefgecdtaecFFFFi0Ecbyd;y:L:cjbHjjjjbbhKasc:Cefasyd;8egecdtfaKBdbasaKBdNeasaecefBd;8ecuadcitadcFFFFe0Ecbyd;y:L:cjbHjjjjbbhEasc:Cefasyd;8egecdtfaEBdbasaEBd:yeasaecefBd;8eascNefabadalcbz:cjjjbcualcdtgealcFFFFi0Eg3cbyd;y:L:cjbHjjjjbbhHasc:Cefasyd;8egOcdtfaHBdbasaOcefBd;8ea3cbyd;y:L:cjbHjjjjbbhXasc:Cefasyd;8egOcdtfaXBdbasaOcefBd;8eaHaXaialavazasc:Cefz:djjjbalcbyd;y:L:cjbHjjjjbbh5asc:Cefasyd;8egOcdtfa5BdbasaOcefBd;8ea3cbyd;y:L:cjbHjjjjbbhOasc:Cefasyd;8egAcdtfaOBdbasaAcefBd;8ea3cbyd;y:L:cjbHjjjjbbhAasc:Cefasyd;8egCcdtfaABdbasaCcefBd;8eaOcFeaez:xjjjbh8EaAcFeaez:xjjjbh8FdnalTmbindnaKa8AgAcefg8AcdtfydbgCaKaAcdtgefydbgOSmbaCaO9RhYaEaOcitfhaa8Faefhha8EaefhLcbhCindndnaaaCcitfydbgQaA9hmbaLaABdbahaABdbxekdnaKaQcdtggfgeclfydbgOaeydbgeSmbaOae9RhOaEaecitfheinaeydbaASmdaecwfheaOcufgOmbkka8FagfgeaAaQaeydbcuSEBdbaLaQaAaLydbcuSEBdbkaCcefgCaY9hmbkka8Aal9hmbkaHhOaXhAa8EhQa8FhCcbheindndnaeaOydbgL9hmbdnaeaAydbgL9hmbaQydbhLdnaCydbgYcu9hmbaLcu9hmba5aefcb86bbxikdnaYcuSmbaLcuSmbaeaYSmbaHaYcdtfydbaHaLcdtfydb9hmba5aefcd86bbxika5aefhadnaeaYSmbaeaLSmbaace86bbxikaacv86bbxdkdnaeaXaLcdtgYfydb9hmbdnaCydbgacuSmbaeaaSmbaQydbggcuSmbaeagSmba8FaYfydbghcuSmbahaLSmba8EaYfydbgYcuSmbaYaLSmbaHaacdtfydbgLaHaYcdtfydb9hmbaLaHagcdtfydbgYSmbaYaHahcdtfydb9hmba5aefcd86bbxika5aefcv86bbxdka5aefcv86bbxeka5aefa5aLfRbb86bbkaOclfhOaAclfhAaQclfhQaCclfhCalaecefge9hmbkdnamcaGTmbcbh8Jindndna5a8Jfg8KRbbg8Lc9:fPlbeebekdndndnaHa8Jcdtfydbgea8J9hmbcbhYcbh8MaqTmednazTmbcbh8Ma8JheinaqazaecdtgefydbfRbbce4a8MVceGh8MaXaefydbgea8J9hmbxikkcbh8Ma8JheinaqaefRbbce4a8MVceGh8MaXaecdtfydbgea8J9hmbxdkka5aefRbbhexeka8JheindnaKaecdtg8AfgeclfydbgOaeydbgeSmbaOae9RhgaEaecitfhhaHa8AfhacbhLinahaLcitfydbgQhednindnaKaecdtgCfgeclfydbgOaeydbgeSmbaOae9RhOaEaecitfheaaydbhAdninaHaeydbcdtfydbaASmeaecwfheaOcufgOTmdxbkkcbhexdkaXaCfydbgeaQ9hmbkcehekaYaeVhYaLcefgLag9hmbkkaXa8Afydbgea8J9hmbka8LclciaYceGEa8MEheka8Kae86bbka8Jcefg8Jal9hmbkkdnaqTmbdndnazTmbazheaHhOalhAindnaqaeydbfRbbceGTmba5aOydbfcv86bbkaeclfheaOclfhOaAcufgAmbxdkkaqheaHhOalhAindnaeRbbceGTmba5aOydbfcv86bbkaecefheaOclfhOaAcufgAmbkkaHhealhAa5hOindna5aeydbfRbbcv9hmbaOcv86bbkaeclfheaOcefhOaAcufgAmbkkamceGTmba5healhOindndnaeRbbcufPlbeebekaecv86bbkaecefheaOcufgOmbkkcbh8Ncualcx2alc;v:Q;v:Qe0Ecbyd;y:L:cjbHjjjjbbh8Kasc:Cefasyd;8egecdtfa8KBdbasaecefBd;8eascbBd:qeas9cb83i1ea8Kaialavazasc1efz:ejjjbhydndnaDmbcbh8PcbhaxekcbhaawhecbhOindnaeIdbJbbbb9ETmbasaacdtfaOBdbaacefhakaeclfheaDaOcefgO9hmbkcuaaal2gecdtaecFFFFi0Ecbyd;y:L:cjbHjjjjbbh8Pasc:Cefasyd;8egecdtfa8PBdbasaecefBd;8ealTmbdnaambcbhaxekarcd4hgdnazTmbaacdthhcbhLa8PhYinaoazaLcdtfydbag2cdtfhQasheaYhOaahAinaOaQaeydbcdtgCfIdbawaCfIdbNUdbaeclfheaOclfhOaAcufgAmbkaYahfhYaLcefgLal9hmbxdkkaacdthhcbhLa8PhYinaoaLag2cdtfhQasheaYhOaahAinaOaQaeydbcdtgCfIdbawaCfIdbNUdbaeclfheaOclfhOaAcufgAmbkaYahfhYaLcefgLal9hmbkkcualc8S2gOalc;D;O;f8U0EgCcbyd;y:L:cjbHjjjjbbheasc:Cefasyd;8egAcdtfaeBdbasaAcefBd;8eaecbaOz:xjjjbhIcbh8RcbhgdnaaTmbcbh8NaCcbyd;y:L:cjbHjjjjbbhgasc:Cefasyd;8egecdtfagBdbasaecefBd;8eagcbaOz:xjjjb8Acuaaal2gecltgOaecFFFFb0Ecbyd;y:L:cjbHjjjjbbh8Rasc:Cefasyd;8egecdtfa8RBdbasaecefBd;8ea8RcbaOz:xjjjb8AamcjjjjdGTmbcualcltgealcFFFFb0Ecbyd;y:L:cjbHjjjjbbh8Nasc:Cefasyd;8egOcdtfa8NBdbasaOcefBd;8ea8Ncbaez:xjjjb8AkdnadTmbcbhQabhOina8KaOclfydbgLcx2fgeIdba8KaOydbgYcx2fgAIdbg8S:tgRa8KaOcwfydbghcx2fgCIdlaAIdlg8U:tg8VNaeIdla8U:tg8WaCIdba8S:tg8XN:tg8Ya8YNa8WaCIdwaAIdwg8Z:tg80NaeIdwa8Z:tg8Wa8VN:tg81a81Na8Wa8XNaRa80N:tg80a80NMMg8V:rhBa8Yh8Xa80h8Wa81hRdna8VJbbbb9EgATmba8YaB:vh8Xa80aB:vh8Wa81aB:vhRkaIaHaYcdtfydbgCc8S2fgeaRaB:rg8VaRNNg83aeIdbMUdbaea8Wa8Va8WNgUNg85aeIdlMUdlaea8Xa8Va8XNg86Ng87aeIdwMUdwaeaRaUNgUaeIdxMUdxaea86aRNg88aeIdzMUdzaea8Wa86Ng89aeIdCMUdCaeaRa8Va8Xa8ZNaRa8SNa8Ua8WNMM:mg8:Ng86NgRaeIdKMUdKaea8Wa86Ng8WaeId3MUd3aea8Xa86Ng8XaeIdaMUdaaea86a8:Ng86aeId8KMUd8Kaea8VaeIdyMUdyaIaHaLcdtfydbgLc8S2fgea83aeIdbMUdbaea85aeIdlMUdlaea87aeIdwMUdwaeaUaeIdxMUdxaea88aeIdzMUdzaea89aeIdCMUdCaeaRaeIdKMUdKaea8WaeId3MUd3aea8XaeIdaMUdaaea86aeId8KMUd8Kaea8VaeIdyMUdyaIaHahcdtfydbgYc8S2fgea83aeIdbMUdbaea85aeIdlMUdlaea87aeIdwMUdwaeaUaeIdxMUdxaea88aeIdzMUdzaea89aeIdCMUdCaeaRaeIdKMUdKaea8WaeId3MUd3aea8XaeIdaMUdaaea86aeId8KMUd8Kaea8VaeIdyMUdydna8NTmbdnaATmba8YaB:vh8Ya80aB:vh80a81aB:vh81ka8NaCcltfgeaBJbbbZNgRa80Ng8VaeIdlMUdlaeaRa8YNg8WaeIdwMUdwaeaRa81Ng8XaeIdbMUdbaeaRa8S:ma81Na8Ua80N:ta8Za8YN:tNgRaeIdxMUdxa8NaLcltfgea8VaeIdlMUdlaea8WaeIdwMUdwaea8XaeIdbMUdbaeaRaeIdxMUdxa8NaYcltfgea8VaeIdlMUdlaea8WaeIdwMUdwaea8XaeIdbMUdbaeaRaeIdxMUdxkaOcxfhOaQcifgQad6mbkkdnalTmbJq;x8J88J;n;m;m89J:v:;;w8ZamczGEamc;abGEh80cbhOaHhCazhQaIhea8KhAindnaOaCydb9hmbaOhLdnazTmbaQydbhLka80hRdnaqTmbJbbjZa80aqaLfRbbclGEhRkaecxfgLaLIdbJbbbbMUdbaeczfgLaLIdbJbbbbMUdbaecCfgLaLIdbJbbbbMUdbaeaRaecyfgLIdbg8YNgRaeIdbMUdbaeclfgYaRaYIdbMUdbaecwfgYaRaYIdbMUdbaecKfgYaYIdbaAIdbg8WaRN:tUdbaAcwfIdbh8Vaec3fgYaYIdbaRaAclfIdbg8XN:tUdbaecafgYaYIdbaRa8VN:tUdbaec8KfgYIdbh81aLa8YaRMUdbaYa81aRa8Va8VNa8Wa8WNa8Xa8XNMMNMUdbkaCclfhCaQclfhQaec8SfheaAcxfhAalaOcefgO9hmbkkdnadTmbcbh8AabhLinaba8AcdtfhYcbheindna5aLaefydbgCfRbbgOTmba5aYaec:G:G:cjbfydbcdtfydbgQfRbbcFeGgATmbdnaOclSghmbaOci6mbaAclSmbaAcd0mekdnaOcd0mba8EaCcdtfydbaQ9hmekdnaAcd0mba8FaQcdtfydbaC9hmekdndnahmbaAcl9hmekaOciSmeaAciSmekJbbbZJbbbZJbbacaAcdSEaOcdSEhUdna8KaYaec:K:G:cjbfydbcdtfydbcx2fgOIdwa8KaCcx2fgAIdwg86:tg8Sa8KaQcx2fghIdwa86:tg8Xa8XNahIdbaAIdbg8U:tg80a80NahIdlaAIdlg8Z:tg8Va8VNMMg81Na8Xa8Sa8XNaOIdba8U:tg83a80Na8VaOIdla8Z:tg85NMMg8WN:tg8Ya8YNa83a81Na80a8WN:tgRaRNa85a81Na8Va8WN:tg8Wa8WNMMgBJbbbb9ETmba8YaB:rgB:vh8Ya8WaB:vh8WaRaB:vhRkaUa81:rNgBa8Ya86NaRa8UNa8Za8WNMM:mg81Ng87a81Nh88a80a85Na8Va83N:tg81a81Na8Va8SNa8Xa85N:tg8Va8VNa8Xa83Na80a8SN:tg8Xa8XNMMg83:rh80a8Ya87Nh85a8Wa87Nh89aRa87Nh87a8WaBa8YNg8SNh8:a8SaRNhZaRaBa8WNgnNhca8Ya8SNh8Ya8WanNh8WaRaBaRNNh8Sdna83Jbbbb9ETmba81a80:vh81a8Xa80:vh8Xa8Va80:vh8VkaIaHaCcdtfydbc8S2fgOaOIdba8Sa8VaUa80:rNgRa8VNNMg80MUdbaOa8Wa8XaRa8XNg8SNMg83aOIdlMUdlaOa8Ya81aRa81Ng8WNMg8YaOIdwMUdwaOaca8Va8SNMg8SaOIdxMUdxaOaZa8Wa8VNMgUaOIdzMUdzaOa8:a8Xa8WNMg8WaOIdCMUdCaOa87a8VaRa81a86Na8Va8UNa8Za8XNMMg86:mNgRNMg8VaOIdKMUdKaOa89a8XaRNMg8XaOId3MUd3aOa85a81aRNMg81aOIdaMUdaaOa88a86aRN:tgRaOId8KMUd8KaOaBaOIdyMUdyaIaHaQcdtfydbc8S2fgOa80aOIdbMUdbaOa83aOIdlMUdlaOa8YaOIdwMUdwaOa8SaOIdxMUdxaOaUaOIdzMUdzaOa8WaOIdCMUdCaOa8VaOIdKMUdKaOa8XaOId3MUd3aOa81aOIdaMUdaaOaRaOId8KMUd8KaOaBaOIdyMUdykaeclfgecx9hmbkaLcxfhLa8Acifg8Aad6mbkkdnamcjeGTmbalTmbcbh9cindnaKa9cgecdtgOfydbghaKaecefg9ccdtfydbg8M9pmba8Kaecx2fhDaIaHaOfydbgCc8S2fh8AindnaHaEahcitfgeydbgLcdtfydbg8JaC0mbaeydlh8LcuhAaLheindnaKaecdtgYfgeclfydbgOaeydbgeSmbaOae9RhOaEaecitfheindnaHaeydbcdtfydbaC9hmbaAcu9hhQaLhAaQmbaeclfydbhAkaecwfheaOcufgOmbkkaXaYfydbgeaL9hmbkaAaLSmbaAcuSmba8KaLcx2fgeIdbaDIdbg81:tgRa8Ka8Lcx2fgOIdlaDIdlg80:tg8XNaeIdla80:tg8VaOIdba81:tg8YN:tg86a8KaAcx2fgAIdba81:tg8Za8VNaAIdla80:tg83aRN:tg8SNa8VaOIdwaDIdwgB:tg8UNaeIdwaB:tg8Wa8XN:tg85a83a8WNaAIdwaB:tg87a8VN:tgUNa8Wa8YNaRa8UN:tg88a87aRNa8Za8WN:tg89NMMa86a86Na85a85Na88a88NMM:rJ:A:z9z:;Na8Sa8SNaUaUNa89a89NMM:rN9Gmbdna8Ua8Wa8WNaRaRNa8Va8VNMMg8SNa8Wa8Ua8WNa8YaRNa8Va8XNMMg86N:tg8Ua8UNa8Ya8SNaRa86N:tg8Ya8YNa8Xa8SNa8Va86N:tg86a86NMMg8XJbbbb9ETmba8Ua8X:rg8X:vh8Ua86a8X:vh86a8Ya8X:vh8Yka8S:rg8Xa8UaBNa8Ya81Na80a86NMM:mgUNg85aUNhUa8Ua85Nh88a86a85Nh89a8Ya85Nh8:a86a8Xa8UNg85NhZa85a8YNhna8Ya8Xa86NgcNhJa8Ua85Nh8Ua86acNh86a8Ya8Xa8YNNh85dna87a8SNa8Wa87a8WNa8ZaRNa8Va83NMMg8YN:tg8Wa8WNa8Za8SNaRa8YN:tgRaRNa83a8SNa8Va8YN:tg8Va8VNMMg8YJbbbb9ETmba8Wa8Y:rg8Y:vh8Wa8Va8Y:vh8VaRa8Y:vhRka8Aa8AIdba85aRa8XaRNNMg8SMUdba8Aa86a8Va8Xa8VNg8ZNMg86a8AIdlMUdla8Aa8Ua8Wa8Xa8WNg8YNMg8Ua8AIdwMUdwa8AaJaRa8ZNMg8Za8AIdxMUdxa8Aana8YaRNMg83a8AIdzMUdza8AaZa8Va8YNMg85a8AIdCMUdCa8Aa8:aRa8Xa8WaBNaRa81Na80a8VNMMg81:mNg8YNMgRa8AIdKMUdKa8Aa89a8Va8YNMg8Va8AId3MUd3a8Aa88a8Wa8YNMg8Wa8AIdaMUdaa8AaUa81a8YN:tg8Ya8AId8KMUd8Ka8Aa8Xa8XMg8Xa8AIdyMUdyaIa8Jc8S2fgea8SaeIdbMUdbaea86aeIdlMUdlaea8UaeIdwMUdwaea8ZaeIdxMUdxaea83aeIdzMUdzaea85aeIdCMUdCaeaRaeIdKMUdKaea8VaeId3MUd3aea8WaeIdaMUdaaea8YaeId8KMUd8Kaea8XaeIdyMUdykahcefgha8M9hmbkka9cal9hmbkkdnadTmbaaTmbcbhYinJbbbbh80a8KabaYcdtfgeclfydbgLcx2fgOIdwa8Kaeydbghcx2fgAIdwg8Z:tg8Va8VNaOIdbaAIdbg83:tg8Wa8WNaOIdlaAIdlg85:tg8Xa8XNMMg8Sa8Kaecwfydbg8Acx2fgeIdwa8Z:tg8YNa8Va8YNa8WaeIdba83:tg81Na8XaeIdla85:tgBNMMgRa8VN:tJbbbbJbbjZa8Sa8Ya8YNa81a81NaBaBNMMg8UNaRaRN:tg86:va86Jbbbb9BEg86Nh88a8Ua8VNaRa8YN:ta86Nh89a8SaBNaRa8XN:ta86Nh8:a8Ua8XNaRaBN:ta86NhZa8Sa81NaRa8WN:ta86Nhna8Ua8WNaRa81N:ta86Nhca8WaBNa8Xa81N:tgRaRNa8Xa8YNa8VaBN:tgRaRNa8Va81Na8Wa8YN:tgRaRNMM:rJbbbZNhRa8Pahaa2g8JcdtfhOa8Pa8Aaa2g8McdtfhAa8PaLaa2gDcdtfhCa8Z:mhJa85:mh9ea83:mhTascjdfheaahQJbbbbhBJbbbbh86Jbbbbh8SJbbbbh8UJbbbbh8ZJbbbbh83Jbbbbh85Jbbbbh87JbbbbhUinaecwfaRa89aCIdbaOIdbg8Y:tg8XNa88aAIdba8Y:tg81NMg8VNUdbaeclfaRaZa8XNa8:a81NMg8WNUdbaeaRaca8XNana81NMg8XNUdbaecxfaRaJa8VNa9ea8WNa8YaTa8XNMMMg8YNUdbaRa8Va8WNNa8ZMh8ZaRa8Va8XNNa8UMh8UaRa8Wa8XNNa8SMh8SaRa8Ya8YNNaUMhUaRa8Va8YNNa87Mh87aRa8Wa8YNNa85Mh85aRa8Xa8YNNa83Mh83aRa8Va8VNNa86Mh86aRa8Wa8WNNaBMhBaRa8Xa8XNNa80Mh80aOclfhOaCclfhCaAclfhAaeczfheaQcufgQmbkagahc8S2fgea80aeIdbMUdbaeaBaeIdlMUdlaea86aeIdwMUdwaea8SaeIdxMUdxaea8UaeIdzMUdzaea8ZaeIdCMUdCaea83aeIdKMUdKaea85aeId3MUd3aea87aeIdaMUdaaeaUaeId8KMUd8KaeaRaeIdyMUdyagaLc8S2fgea80aeIdbMUdbaeaBaeIdlMUdlaea86aeIdwMUdwaea8SaeIdxMUdxaea8UaeIdzMUdzaea8ZaeIdCMUdCaea83aeIdKMUdKaea85aeId3MUd3aea87aeIdaMUdaaeaUaeId8KMUd8KaeaRaeIdyMUdyaga8Ac8S2fgea80aeIdbMUdbaeaBaeIdlMUdlaea86aeIdwMUdwaea8SaeIdxMUdxaea8UaeIdzMUdzaea8ZaeIdCMUdCaea83aeIdKMUdKaea85aeId3MUd3aea87aeIdaMUdaaeaUaeId8KMUd8KaeaRaeIdyMUdya8Ra8JcltfhLcbhOaahCinaLaOfgeascjdfaOfgAIdbaeIdbMUdbaeclfgQaAclfIdbaQIdbMUdbaecwfgQaAcwfIdbaQIdbMUdbaecxfgeaAcxfIdbaeIdbMUdbaOczfhOaCcufgCmbka8RaDcltfhLcbhOaahCinaLaOfgeascjdfaOfgAIdbaeIdbMUdbaeclfgQaAclfIdbaQIdbMUdbaecwfgQaAcwfIdbaQIdbMUdbaecxfgeaAcxfIdbaeIdbMUdbaOczfhOaCcufgCmbka8Ra8McltfhLcbhOaahCinaLaOfgeascjdfaOfgAIdbaeIdbMUdbaeclfgQaAclfIdbaQIdbMUdbaecwfgQaAcwfIdbaQIdbMUdbaecxfgeaAcxfIdbaeIdbMUdbaOczfhOaCcufgCmbkaYcifgYad6mbkkcbhAdndnamcwGgSmbJbbbbh86cbh9hcbh9icbh6xekcbh9ha3cbyd;y:L:cjbHjjjjbbh6asc:Cefasyd;8egecdtfa6BdbasaecefBd;8ecua6alabadaHz:fjjjbgCcltaCcjjjjiGEcbyd;y:L:cjbHjjjjbbh9iasc:Cefasyd;8egecdtfa9iBdbasaecefBd;8ea9iaCa6a8Kalz:gjjjbJFFuuh86aCTmba9iheaChOinaeIdbgRa86a86aR9EEh86aeclfheaOcufgOmbkaCh9hkdnalTmbaKclfheaKydbhCa5hOalhQcbhAincbaeydbgLaC9RaORbbcpeGEaAfhAaOcefhOaeclfheaLhCaQcufgQmbkaAce4hAkcuadaA9Rcifg9kcx2a9kc;v:Q;v:Qe0Ecbyd;y:L:cjbHjjjjbbh0asc:Cefasyd;8egecdtfa0BdbasaecefBd;8ecua9kcdta9kcFFFFi0Ecbyd;y:L:cjbHjjjjbbh9masc:Cefasyd;8egecdtfa9mBdbasaecefBd;8ea3cbyd;y:L:cjbHjjjjbbh9nasc:Cefasyd;8egecdtfa9nBdbasaecefBd;8ealcbyd;y:L:cjbHjjjjbbh9oasc:Cefasyd;8egecdtfa9oBdbasaecefBd;8eaxaxNayJbbjZamclGEg9pa9pN:vh87JbbbbhUdnadak9nmbdna9kci6mbamcjdGh9qaaclth9ra0cwfh9sJbbbbh85JbbbbhUinascNefabadalaHz:cjjjbabh8Acbh3cbh9tinaba9tcdtfh8McbheindnaHa8AaefydbgAcdtghfydbgCaHa8Maec:W:G:cjbfydbcdtfydbgOcdtg8JfydbgQSmba5aOfRbbgYco2a5aAfRbbgLfRb;a:G:cjbg8LaLco2aYfgDRb;a:G:cjbg9cVcFeGTmbdnaQaC9nmbaDRb;W:G:cjbcFeGmekdnaLcufcFeGce0mbaYTmba8EahfydbaO9hmekdnaLTmbaYcufcFeGce0mba8Fa8JfydbaA9hmeka0a3cx2fgCaOaAa9ccFeGgQEBdlaCaAaOaQEBdbaCaQa8LGcb9hBdwa3cefh3kaeclfgecx9hmbkdna9tcifg9tad9pmba8Acxfh8Aa3cifa9k9nmekka3TmdcbhDinaIaHa0aDcx2fghydbgLcdtgCfydbg8Jc8S2fgeIdwa8KahydlgYcx2fgOIdwg8WNaeIdzaOIdbg8XNaeIdaMgRaRMMa8WNaeIdlaOIdlg8YNaeIdCa8WNaeId3MgRaRMMa8YNaeIdba8XNaeIdxa8YNaeIdKMgRaRMMa8XNaeId8KMMM:lhRJbbbbJbbjZaeIdyg8V:va8VJbbbb9BEh8Vdndnahydwg8MmbJFFuuhBxekJbbbbJbbjZaIaHaYcdtfydbc8S2fgeIdyg81:va81Jbbbb9BEaeIdwa8KaLcx2fgOIdwg81NaeIdzaOIdbg80NaeIdaMgBaBMMa81NaeIdlaOIdlgBNaeIdCa81NaeId3Mg81a81MMaBNaeIdba80NaeIdxaBNaeIdKMg81a81MMa80NaeId8KMMM:lNhBka8VaRNh80dnaaTmbagaLc8S2fgAIdwa8WNaAIdza8XNaAIdaMgRaRMMa8WNaAIdla8YNaAIdCa8WNaAId3MgRaRMMa8YNaAIdba8XNaAIdxa8YNaAIdKMgRaRMMa8XNaAId8KMMMhRa8PaYaa2gQcdtfhOa8RaLaa2g8AcltfheaAIdyh81aahAinaOIdbg8Va8Va81NaecxfIdba8WaecwfIdbNa8XaeIdbNa8YaeclfIdbNMMMg8Va8VM:tNaRMhRaOclfhOaeczfheaAcufgAmbkaR:lgRa81aRa819DEaRa9qEh8Sdndna8MmbJbbbbhRxekagaYc8S2fgAIdwa8KaLcx2fgeIdwg8WNaAIdzaeIdbg8XNaAIdaMgRaRMMa8WNaAIdlaeIdlg8YNaAIdCa8WNaAId3MgRaRMMa8YNaAIdba8XNaAIdxa8YNaAIdKMgRaRMMa8XNaAId8KMMMhRa8Pa8AcdtfhOa8RaQcltfheaAIdyh81aahAinaOIdbg8Va8Va81NaecxfIdba8WaecwfIdbNa8XaeIdbNa8YaeclfIdbNMMMg8Va8VM:tNaRMhRaOclfhOaeczfheaAcufgAmbkaR:lgRa81aRa819DEaRa9qEhRka80a8SMh80aBaRMhBdndndna5aLfRbbc9:fPibeedkdna8Fa8Ea8EaCfydbaYSEaXaCfydbgQcdtfydbgCcu9hmbaXaYcdtfydbhCkagaQc8S2fgAIdwa8KaCcx2fgeIdwg8WNaAIdzaeIdbg8XNaAIdaMgRaRMMa8WNaAIdlaeIdlg8YNaAIdCa8WNaAId3MgRaRMMa8YNaAIdba8XNaAIdxa8YNaAIdKMgRaRMMa8XNaAId8KMMMhRa8PaCaa2g8AcdtfhOa8RaQaa2g8JcltfheaAIdyh81aahAinaOIdbg8Va8Va81NaecxfIdba8WaecwfIdbNa8XaeIdbNa8YaeclfIdbNMMMg8Va8VM:tNaRMhRaOclfhOaeczfheaAcufgAmbkaR:lgRa81aRa819DEaRa9qEh8Sdndna8MmbJbbbbhRxekagaCc8S2fgAIdwa8KaQcx2fgeIdwg8WNaAIdzaeIdbg8XNaAIdaMgRaRMMa8WNaAIdlaeIdlg8YNaAIdCa8WNaAId3MgRaRMMa8YNaAIdba8XNaAIdxa8YNaAIdKMgRaRMMa8XNaAId8KMMMhRa8Pa8JcdtfhOa8Ra8AcltfheaAIdyh81aahAinaOIdbg8Va8Va81NaecxfIdba8WaecwfIdbNa8XaeIdbNa8YaeclfIdbNMMMg8Va8VM:tNaRMhRaOclfhOaeczfheaAcufgAmbkaR:lgRa81aRa819DEaRa9qEhRka80a8SMh80aBaRMhBxdkaXaCfydbgCaLSmbaHaYcdtfydbh8Aindndna8EaCcdtgQfydbgecuSmbaHaecdtfydba8ASmekdna8FaQfydbgecuSmbaHaecdtfydba8ASmekaYhekagaCc8S2fgAIdwa8Kaecx2fgOIdwg8WNaAIdzaOIdbg8XNaAIdaMgRaRMMa8WNaAIdlaOIdlg8YNaAIdCa8WNaAId3MgRaRMMa8YNaAIdba8XNaAIdxa8YNaAIdKMgRaRMMa8XNaAId8KMMMhRa8Paeaa2cdtfhOa8RaCaa2cltfheaAIdyh81aahAinaOIdbg8Va8Va81NaecxfIdba8WaecwfIdbNa8XaeIdbNa8YaeclfIdbNMMMg8Va8VM:tNaRMhRaOclfhOaeczfheaAcufgAmbka80aR:lgRa81aRa819DEaRa9qEMh80aXaQfydbgCaL9hmbkkdna5aYfRbbgeciSmbaecl9hmeka8MTmbaXaYcdtfydbgCaYSmbindndna8EaCcdtgQfydbgecuSmbaHaecdtfydba8JSmekdna8FaQfydbgecuSmbaHaecdtfydba8JSmekaLhekagaCc8S2fgAIdwa8Kaecx2fgOIdwg8WNaAIdzaOIdbg8XNaAIdaMgRaRMMa8WNaAIdlaOIdlg8YNaAIdCa8WNaAId3MgRaRMMa8YNaAIdba8XNaAIdxa8YNaAIdKMgRaRMMa8XNaAId8KMMMhRa8Paeaa2cdtfhOa8RaCaa2cltfheaAIdyh81aahAinaOIdbg8Va8Va81NaecxfIdba8WaecwfIdbNa8XaeIdbNa8YaeclfIdbNMMMg8Va8VM:tNaRMhRaOclfhOaeczfheaAcufgAmbkaBaR:lgRa81aRa819DEaRa9qEMhBaXaQfydbgCaY9hmbkkahaBa80aBa809DgeEUdwahaLaYaea8Mcb9hGgeEBdlahaYaLaeEBdbaDcefgDa39hmbkascjdfcbcj;qbz:xjjjb8Aa9shea3hOinascjdfaeydbcA4cF8FGgAcFAaAcFA6EcdtfgAaAydbcefBdbaecxfheaOcufgOmbkcbhecbhOinascjdfaefgAydbhCaAaOBdbaCaOfhOaeclfgecj;qb9hmbkcbhea9shOinascjdfaOydbcA4cF8FGgAcFAaAcFA6EcdtfgAaAydbgAcefBdba9maAcdtfaeBdbaOcxfhOa3aecefge9hmbkadak9RgAci9Uh9udnalTmbcbhea9nhOinaOaeBdbaOclfhOalaecefge9hmbkkcbh9va9ocbalz:xjjjbh9caAcO9Uh9wa9uce4h9tcbh8Lcbh8Mdnina0a9ma8Mcdtfydbcx2fg8JIdwgRa879Emea8La9u9pmeJFFuuh8Vdna9ta39pmba0a9ma9tcdtfydbcx2fIdwJbb;aZNh8VkdnaRa8V9ETmbaRaU9ETmba8La9w0mdkdna9caHa8JydlgDcdtg9xfg8AydbgAfg9yRbba9caHa8Jydbghcdtg9zfydbgefg9ARbbVmba5ahfRbbh9BdndnaKaecdtfgOclfydbgCaOydbgOSmbaCaO9RhCa8KaAcx2fhLa8Kaecx2fhYaEaOcitfheindna9naeydbcdtfydbgOaASmba9naeclfydbcdtfydbgQaASmbaOaQSmba8KaQcx2fgQIdba8KaOcx2fgOIdbg8W:tgRaYIdlaOIdlg8X:tg80NaQIdla8X:tg8VaYIdba8W:tgBN:tg8YaRaLIdla8X:tg8SNa8VaLIdba8W:tg8UN:tg8XNa8VaYIdwaOIdwg81:tg8ZNaQIdwa81:tg8Wa80N:tg80a8VaLIdwa81:tg83Na8Wa8SN:tg8VNa8WaBNaRa8ZN:tg81a8Wa8UNaRa83N:tgRNMMa8Ya8YNa80a80Na81a81NMMa8Xa8XNa8Va8VNaRaRNMMN:rJbbj8:N9FmikaecwfheaCcufgCmbkkdndna9Bc99fcFeGce0mba9na9zfaDBdbaXa9zfydbgeahSmeina8AydbhAdndna8EaecdtgOfydbgecuSmbaHaecdtfydbaASmekdna8FaOfydbgecuSmbaHaecdtfydbaASmekaDheka9naOfaeBdbaXaOfydbgeah9hmbxdkkdndna9BcFeGcdSmbaDhexekdna8Fa8Ea8Ea9zfydbaDSEaXa9zfydbghcdtfydbgecu9hmbaXa9xfydbheka9na9zfaDBdbka9nahcdtfaeBdbka9Ace86bba9yce86bba8JIdwgRaUaUaR9DEhUa9vcefh9vcecda9BcFeGceSEa8Lfh8Lxeka9tcefh9tka8Mcefg8Ma39hmbkka9vTmddnalTmbcbhLcbhhindna9nahcdtgefydbgAahSmbaHaAcdtfydbh8AdnahaHaefydb9hg8JmbaIa8Ac8S2fgeaIahc8S2fgOIdbaeIdbMUdbaeaOIdlaeIdlMUdlaeaOIdwaeIdwMUdwaeaOIdxaeIdxMUdxaeaOIdzaeIdzMUdzaeaOIdCaeIdCMUdCaeaOIdKaeIdKMUdKaeaOId3aeId3MUd3aeaOIdaaeIdaMUdaaeaOId8KaeId8KMUd8KaeaOIdyaeIdyMUdya8NTmba8Na8Acltfgea8NahcltfgOIdbaeIdbMUdbaeaOIdlaeIdlMUdlaeaOIdwaeIdwMUdwaeaOIdxaeIdxMUdxkaaTmbagaAc8S2fgeagahc8S2g8MfgOIdbaeIdbMUdbaeaOIdlaeIdlMUdlaeaOIdwaeIdwMUdwaeaOIdxaeIdxMUdxaeaOIdzaeIdzMUdzaeaOIdCaeIdCMUdCaeaOIdKaeIdKMUdKaeaOId3aeId3MUd3aeaOIdaaeIdaMUdaaeaOId8KaeId8KMUd8KaeaOIdyaeIdyMUdya9raA2hYa8RhOaahCinaOaYfgeaOaLfgAIdbaeIdbMUdbaeclfgQaAclfIdbaQIdbMUdbaecwfgQaAcwfIdbaQIdbMUdbaecxfgeaAcxfIdbaeIdbMUdbaOczfhOaCcufgCmbka8JmbJbbbbJbbjZaIa8MfgeIdygR:vaRJbbbb9BEaeIdwa8Ka8Acx2fgOIdwgRNaeIdzaOIdbg8VNaeIdaMg8Wa8WMMaRNaeIdlaOIdlg8WNaeIdCaRNaeId3MgRaRMMa8WNaeIdba8VNaeIdxa8WNaeIdKMgRaRMMa8VNaeId8KMMM:lNgRa85a85aR9DEh85kaLa9rfhLahcefghal9hmbkcbhOa8EheindnaeydbgAcuSmbdnaOa9naAcdtgCfydbgA9hmbcuhAa8EaCfydbgCcuSmba9naCcdtfydbhAkaeaABdbkaeclfhealaOcefgO9hmbkcbhOa8FheindnaeydbgAcuSmbdnaOa9naAcdtgCfydbgA9hmbcuhAa8FaCfydbgCcuSmba9naCcdtfydbhAkaeaABdbkaeclfhealaOcefgO9hmbkka85aUaaEh85cbhOabhecbhAindnaHa9naeydbcdtfydbgLcdtfydbgCaHa9naeclfydbcdtfydbgYcdtfydbgQSmbaCaHa9naecwfydbcdtfydbg8AcdtfydbghSmbaQahSmbabaOcdtfgCaLBdbaCcwfa8ABdbaCclfaYBdbaOcifhOkaecxfheaAcifgAad6mbkdndnaSmbaOhdxekdnaOak0mbaOhdxekdna86a859FmbaOhdxekJFFuuh86cbhdabhecbhAindna9ia6aeydbgCcdtfydbcdtfIdbgRa859ETmbaeclf8Pdbh9CabadcdtfgQaCBdbaQclfa9C83dbaRa86a86aR9EEh86adcifhdkaecxfheaAcifgAaO6mbkkadak0mbxdkkascNefabadalaHz:cjjjbkdndnadak0mbadhYxekdnaSmbadhYxekdna86a879FmbadhYxekcehQina86Jbb;aZNgRa87aRa879DEh8WJbbbbhRdna9hTmba9ihea9hhOinaeIdbg8VaRa8Va8W9FEaRa8VaR9EEhRaeclfheaOcufgOmbkkJFFuuh86cbhYabhecbhOindna9ia6aeydbgAcdtfydbcdtfIdbg8Va8W9ETmbaeclf8Pdbh9CabaYcdtfgCaABdbaCclfa9C83dba8Va86a86a8V9EEh86aYcifhYkaecxfheaOcifgOad6mbkdnaQaYad9hVceGmbadhYxdkaRaUaUaR9DEhUaYak9nmecbhQaYhda86a879FmbkkdnamcjjjjdGTmba9ocbalz:xjjjbh8AdnaYTmbabheaYhOina8AaeydbgAfce86bba8AaHaAcdtfydbfce86bbaeclfheaOcufgOmbkkascNefabaYalaHz:cjjjbdndnalTmbcbhCindna8AaCfRbbTmbdna5aCfRbbPlbeebekdnaHaCcdtgLfydbgeaCSmba8KaCcx2fgOa8Kaecx2fgeydwBdwaOae8Pdb83dbxekaIaCc8S2fgQIdygnanJL:3;rUNgRMh87aQIdwgxaRMh8SaQIdlg9DaRMh8UaQIdbg9EaRMh81aQIdag9FaRa8KaCcx2fg8JIdwg88N:th8ZaQId3g9GaRa8JIdlg89N:th83aQIdKg9Ha8JIdbg8:aRN:th80JbbbbhZaQIdCg9IJbbbbMh85aQIdzg9JJbbbbMhBaQIdxg9KJbbbbMh86dndnaaTmbaChAinJbbbba87agaAc8S2fgOIdygR:vaRJbbbb9BEhRa8RaAaa2cltfheaOIdaa87Na8ZMh8ZaOId3a87Na83Mh83aOIdKa87Na80Mh80aOIdCa87Na85Mh85aOIdza87NaBMhBaOIdxa87Na86Mh86aOIdwa87Na8SMh8SaOIdla87Na8UMh8UaOIdba87Na81Mh81aahOina8ZaecwfIdbg8VaecxfIdbg8YNaRN:th8Za83aeclfIdbg8Wa8YNaRN:th83a85a8Wa8VNaRN:th85a81aeIdbg8Xa8XNaRN:th81a80a8Xa8YNaRN:th80aBa8Xa8VNaRN:thBa86a8Xa8WNaRN:th86a8Sa8Va8VNaRN:th8Sa8Ua8Wa8WNaRN:th8UaeczfheaOcufgOmbkaXaAcdtfydbgAaC9hmbka8NTmba8NaCcltfgeIdxhTaeIdwhcaeIdlhJaeIdbhRxekJbbbbhTJbbbbhcJbbbbhJJbbbbhRkaBa81:vg8Wa80Na8Z:ta85aBa86a81:vg8VN:tg8Za8Ua86a8VN:tg8Y:vg8Xa8Va80Na83:tg8UN:th83acaRa8WN:taJaRa8VN:tg86a8XN:tg85a8SaBa8WN:ta8Za8XN:tgB:vg8S:mh8Za86a8Y:vgc:mhJdnJbbbbaRaRa81:vg9eN:ta86acN:ta85a8SN:tg86:la87J:983:g81NgR9ETmba8Za83NaJa8UNa9ea80NaT:tMMa86:vhZka81:laR9ETmba8Y:laR9ETmbaB:laR9ETmba9e:maZNa8W:ma8ZaZNa83aB:vMgBNa8V:maJaZNa8X:maBNa8Ua8Y:vMMg85Na80:ma81:vMMMh87aKaLfgeclfydbgOaeydbge9RhhaEaecitfhLJbbbbhRdnaOaeSg8MmbJbbbbhRaLheahhAina8Kaeclfydbcx2fgOIdwa88:tg8Va8VNaOIdba8::tg8Va8VNaOIdla89:tg8Va8VNMMg8Va8Kaeydbcx2fgOIdwa88:tg8Wa8WNaOIdba8::tg8Wa8WNaOIdla89:tg8Wa8WNMMg8WaRaRa8W9DEgRaRa8V9DEhRaecwfheaAcufgAmbkaR:rgRaRNhRkaBa88:tg8Va8VNa87a8::tg8Va8VNa85a89:tg8Va8VNMMaR9EmbaQId8KhZdna8Mmbina8KaLclfydbcx2fgeIdba8KaLydbcx2fgOIdbg8W:tgRa89aOIdlg8X:tg80NaeIdla8X:tg8Va8:a8W:tg86N:tg8YaRa85a8X:tg8SNa8Va87a8W:tg8UN:tg8XNa8Va88aOIdwg81:tg8ZNaeIdwa81:tg8Wa80N:tg80a8VaBa81:tg83Na8Wa8SN:tg8VNa8Wa86NaRa8ZN:tg81a8Wa8UNaRa83N:tgRNMMa8Ya8YNa80a80Na81a81NMMa8Xa8XNa8Va8VNaRaRNMMN:rJbbj8:N9FmdaLcwfhLahcufghmbkkJbbbbJbbjZan:vanJbbbb9BEgRaxaBNa9Ja87Na9FMg8Va8VMMaBNa9Da85Na9IaBNa9GMg8Va8VMMa85Na9Ea87Na9Ka85Na9HMg8Va8VMMa87NaZMMM:lNaRaxa88Na9Ja8:Na9FMg8Va8VMMa88Na9Da89Na9Ia88Na9GMg8Va8VMMa89Na9Ea8:Na9Ka89Na9HMg8Va8VMMa8:NaZMMM:lNJbb;aZNJ:983:g81M9Emba8JaBUdwa8Ja85Udla8Ja87UdbkaCcefgCal9hmbkdnaambcbhaxdkcbhQindna8AaQfRbbTmbaHaQcdtgefydbaQ9hmba5aQfhhaXaefh8Ja8KaQcx2fhAa8PaQaa2cdtfh8McbhEincuhCdnahRbbc99fcFeGce0mbaQhCa8JydbgeaQSmba8PaEcdtgOfhLa8MaOfIdbhRaQhCinaChOcuhCdnaLaeaa2cdtfIdbaR9CmbaOcuSmbaOhCagaec8S2fIdyagaOc8S2fIdy9ETmbaehCkaXaecdtfydbgeaQ9hmbkka8PaEcdtfhLa8RaEcltfhKaQheinaLaeaa2cdtfJbbbbJbbjZagaeaCaCcuSEgOc8S2fIdygR:vaRJbbbb9BEaKaOaa2cltfgOIdwaAIdwNaOIdbaAIdbNaOIdlaAIdlNMMaOIdxMNUdbaXaecdtfydbgeaQ9hmbkaEcefgEaa9hmbkkaQcefgQal9hmbxdkkaambcbhakaiavaoarawaaala8Ka8Pazasayasc1efa5a8Aaqz:hjjjbkdnamcjjjjlGTmbazmbaYTmbabhecbhLina5aeydbgAfRbbc3thQaecwfgXydbhHcjjjj94hCdna8EaAcdtgEfydbaeclfgKydbgOSmbcjjjj94cba8FaOcdtfydbaASEhCkaeaQaCVaAVBdba5aOfRbbc3thacjjjj94hCcjjjj94hQdna8EaOcdtfydbaHSmbcjjjj94cba8FaHcdtfydbaOSEhQkaKaaaQVaOVBdba5aHfRbbc3thOdna8EaHcdtfydbaASmbcjjjj94cba8FaEfydbaHSEhCkaXaOaCVaHVBdbaecxfheaLcifgLaY6mbkkdnazTmbaYTmbaYheinabazabydbcdtfydbBdbabclfhbaecufgembkkdnaPTmbaPa9paU:rNUdbkdnasyd;8egHTmbaHcdtasc:Ceffc98fheinaeydbcbyd;C:L:cjbH:bjjjbbaec98fheaHcufgHmbkkascj;sbf8KjjjjbaYk;Yieouabydlhvabydbclfcbaicdtz:xjjjbhoadci9UhrdnadTmbdnalTmbaehwadhDinaoalawydbcdtfydbcdtfgqaqydbcefBdbawclfhwaDcufgDmbxdkkaehwadhDinaoawydbcdtfgqaqydbcefBdbawclfhwaDcufgDmbkkdnaiTmbcbhDaohwinawydbhqawaDBdbawclfhwaqaDfhDaicufgimbkkdnadci6mbinaecwfydbhwaeclfydbhDaeydbhidnalTmbalawcdtfydbhwalaDcdtfydbhDalaicdtfydbhikavaoaicdtfgqydbcitfaDBdbavaqydbcitfawBdlaqaqydbcefBdbavaoaDcdtfgqydbcitfawBdbavaqydbcitfaiBdlaqaqydbcefBdbavaoawcdtfgwydbcitfaiBdbavawydbcitfaDBdlawawydbcefBdbaecxfhearcufgrmbkkabydbcbBdbk:todDue99aicd4aifhrcehwinawgDcethwaDar6mbkcuaDcdtgraDcFFFFi0Ecbyd;y:L:cjbHjjjjbbhwaoaoyd9GgqcefBd9GaoaqcdtfawBdbawcFearz:xjjjbhkdnaiTmbalcd4hlaDcufhxcbhminamhDdnavTmbavamcdtfydbhDkcbadaDal2cdtfgDydlgwawcjjjj94SEgwcH4aw7c:F:b:DD2cbaDydbgwawcjjjj94SEgwcH4aw7c;D;O:B8J27cbaDydwgDaDcjjjj94SEgDcH4aD7c:3F;N8N27axGhwamcdthPdndndnavTmbakawcdtfgrydbgDcuSmeadavaPfydbal2cdtfgsIdbhzcehqinaqhrdnadavaDcdtfydbal2cdtfgqIdbaz9CmbaqIdlasIdl9CmbaqIdwasIdw9BmlkarcefhqakawarfaxGgwcdtfgrydbgDcu9hmbxdkkakawcdtfgrydbgDcuSmbadamal2cdtfgsIdbhzcehqinaqhrdnadaDal2cdtfgqIdbaz9CmbaqIdlasIdl9CmbaqIdwasIdw9BmikarcefhqakawarfaxGgwcdtfgrydbgDcu9hmbkkaramBdbamhDkabaPfaDBdbamcefgmai9hmbkkakcbyd;C:L:cjbH:bjjjbbaoaoyd9GcufBd9GdnaeTmbaiTmbcbhDaehwinawaDBdbawclfhwaiaDcefgD9hmbkcbhDaehwindnaDabydbgrSmbawaearcdtfgrydbBdbaraDBdbkabclfhbawclfhwaiaDcefgD9hmbkkk;:odvuv998Jjjjjbca9Rgocbyd1:G:cjbBdKaocb8Pdj:G:cjb83izaocbydN:G:cjbBdwaocb8Pd:m:G:cjb83ibdnadTmbaicd4hrdnabmbdnalTmbcbhwinaealawcdtfydbar2cdtfhDcbhiinaoczfaifgqaDaifIdbgkaqIdbgxaxak9EEUdbaoaifgqakaqIdbgxaxak9DEUdbaiclfgicx9hmbkawcefgwad9hmbxikkarcdthwcbhDincbhiinaoczfaifgqaeaifIdbgkaqIdbgxaxak9EEUdbaoaifgqakaqIdbgxaxak9DEUdbaiclfgicx9hmbkaeawfheaDcefgDad9hmbxdkkdnalTmbcbhwinabawcx2fgiaealawcdtfydbar2cdtfgDIdbUdbaiaDIdlUdlaiaDIdwUdwcbhiinaoczfaifgqaDaifIdbgkaqIdbgxaxak9EEUdbaoaifgqakaqIdbgxaxak9DEUdbaiclfgicx9hmbkawcefgwad9hmbxdkkarcdthlcbhwaehDinabawcx2fgiaeawar2cdtfgqIdbUdbaiaqIdlUdlaiaqIdwUdwcbhiinaoczfaifgqaDaifIdbgkaqIdbgxaxak9EEUdbaoaifgqakaqIdbgxaxak9DEUdbaiclfgicx9hmbkaDalfhDawcefgwad9hmbkkJbbbbaoIdbaoIdzgx:tgkakJbbbb9DEgkaoIdlaoIdCgm:tgPaPak9DEgkaoIdwaoIdKgP:tgsasak9DEhsdnabTmbadTmbJbbbbJbbjZas:vasJbbbb9BEhkinabakabIdbax:tNUdbabclfgoakaoIdbam:tNUdbabcwfgoakaoIdbaP:tNUdbabcxfhbadcufgdmbkkdnavTmbavaPUdwavamUdlavaxUdbkask:WlewudnaeTmbcbhvabhoinaoavBdbaoclfhoaeavcefgv9hmbkkdnaiTmbcbhrinadarcdtfhwcbhDinalawaDcdtgvyd:G:G:cjbcdtfydbcdtfydbhodnalawavfydbcdtfydbgqabaqcdtfgkydbgvSmbinakabavgqcdtfgxydbgvBdbaxhkaqav9hmbkkdnaoabaocdtfgkydbgvSmbinakabavgocdtfgxydbgvBdbaxhkaoav9hmbkkdnaqaoSmbabaqaoaqao0Ecdtfaqaoaqao6EBdbkaDcefgDci9hmbkarcifgrai6mbkkdnaembcbskcbhxindnalaxcdtgvfydbax9hmbaxhodnaxabavfgDydbgvSmbaDhqinaqabavgocdtfgkydbgvBdbakhqaoav9hmbkkaDaoBdbkaxcefgxae9hmbkcbhkabhvcbhoindndnaoalydbgq9hmbdnaoavydbgq9hmbavakBdbakcefhkxdkavabaqcdtfydbBdbxekavabaqcdtfydbBdbkalclfhlavclfhvaeaocefgo9hmbkakk;jiilud99euabcbaecltz:xjjjbhvdnalTmbadhoaihralhwinarcwfIdbhDarclfIdbhqavaoydbcltfgkarIdbakIdbMUdbakaqakIdlMUdlakaDakIdwMUdwakakIdxJbbjZMUdxaoclfhoarcxfhrawcufgwmbkkdnaeTmbavhkaehrinakcxfgoIdbhDaocbBdbakakIdbJbbbbJbbjZaD:vaDJbbbb9BEgDNUdbakclfgoaDaoIdbNUdbakcwfgoaDaoIdbNUdbakczfhkarcufgrmbkkdnalTmbinavadydbcltfgkaicwfIdbakIdw:tgDaDNaiIdbakIdb:tgDaDNaiclfIdbakIdl:tgDaDNMMgDakIdxgqaqaD9DEUdxadclfhdaicxfhialcufglmbkkdnaeTmbavcxfhkinabakIdbUdbakczfhkabclfhbaecufgembkkk:moerudnaoTmbaecd4hzdnavTmbaicd4hHavcdthOcbhAindnaPaAfRbbTmbaAhednaDTmbaDaAcdtfydbhekdnasTmbasaefRbbceGmekdnamaAfRbbcvSmbabaeaz2cdtfgiaraAcx2fgCIdbakNaxIdbMUdbaiaCIdlakNaxIdlMUdlaiaCIdwakNaxIdwMUdwkadaeaH2cdtfhXaqheawhiavhCinaXaeydbcdtgQfaiIdbalaQfIdb:vUdbaeclfheaiclfhiaCcufgCmbkkawaOfhwaAcefgAao9hmbxdkkdnasmbcbheaDhiindnaPaefRbbTmbaehCdnaDTmbaiydbhCkamaefRbbcvSmbabaCaz2cdtfgCarIdbakNaxIdbMUdbaCarclfIdbakNaxIdlMUdlaCarcwfIdbakNaxIdwMUdwkaiclfhiarcxfhraoaecefge9hmbxdkkdnaDTmbindnaPRbbTmbasaDydbgefRbbceGmbamRbbcvSmbabaeaz2cdtfgearIdbakNaxIdbMUdbaearclfIdbakNaxIdlMUdlaearcwfIdbakNaxIdwMUdwkaPcefhPaDclfhDamcefhmarcxfhraocufgombxdkkazcdthicbheindnaPaefRbbTmbasaefRbbceGmbamaefRbbcvSmbabarIdbakNaxIdbMUdbabclfarclfIdbakNaxIdlMUdbabcwfarcwfIdbakNaxIdwMUdbkarcxfhrabaifhbaoaecefge9hmbkkk8MbabaeadaialavcbcbcbcbcbaoarawaDz:bjjjbk8MbabaeadaialavaoarawaDaqakaxamaPz:bjjjbkRbababaeadaialavaoarawaDaqakaxcjjjjdVamz:bjjjbk:vgoque99due99duq998Jjjjjbc;Wb9Rgq8Kjjjjbcbhkaqcxfcbc;Kbz:xjjjb8Aaqcualcx2alc;v:Q;v:Qe0Ecbyd;y:L:cjbHjjjjbbgxBdxaqceBd2axaialavcbcbz:ejjjb8AaqcualcdtalcFFFFi0Egmcbyd;y:L:cjbHjjjjbbgiBdzaqcdBd2dndnJFF959eJbbjZawJbbjZawJbbjZ9DE:vawJ9VO:d869DEgw:lJbbb9p9DTmbaw:OhPxekcjjjj94hPkadci9Uhsarco9UhzdndnaombaPcd9imekdnalTmbaPcuf:YhwdnaoTmbcbhvaihHaxhOindndnaoavfRbbceGTmbavcjjjjlVhAxekdndnaOclfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhAxekcjjjj94hAkaAcqthAdndnaOcwfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaAaXVhAdndnaOIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaAaXcCtVhAkaHaABdbaHclfhHaOcxfhOalavcefgv9hmbxdkkaxhvaihOalhHindndnavIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhAxekcjjjj94hAkaAcCthAdndnavclfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaXcqtaAVhAdndnavcwfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaOaAaXVBdbavcxfhvaOclfhOaHcufgHmbkkadTmbcbhkaehvcbhOinakaiavclfydbcdtfydbgHaiavcwfydbcdtfydbgA9haiavydbcdtfydbgXaH9haXaA9hGGfhkavcxfhvaOcifgOad6mbkkarci9UhQdndnaz:Z:rJbbbZMgw:lJbbb9p9DTmbaw:Ohvxekcjjjj94hvkaQ:ZhLcbhKc:bwhzdninakaQ9pmeazaP9Rcd9imeavazcufgOavaO9iEaPcefavaP9kEhYdnalTmbaYcuf:YhwdnaoTmbcbhOaihHaxhvindndnaoaOfRbbceGTmbaOcjjjjlVhAxekdndnavclfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhAxekcjjjj94hAkaAcqthAdndnavcwfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaAaXVhAdndnavIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaAaXcCtVhAkaHaABdbaHclfhHavcxfhvalaOcefgO9hmbxdkkaxhvaihOalhHindndnavIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhAxekcjjjj94hAkaAcCthAdndnavclfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaXcqtaAVhAdndnavcwfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaOaAaXVBdbavcxfhvaOclfhOaHcufgHmbkkcbhOdnadTmbaehvcbhHinaOaiavclfydbcdtfydbgAaiavcwfydbcdtfydbgX9haiavydbcdtfydbgraA9haraX9hGGfhOavcxfhvaHcifgHad6mbkkdnas:ZgCaL:taY:Ygwaz:Y:tg8ANak:ZgEaO:Zg3:tNaEaL:tawaP:Y:tg5Na3aC:tNMg8EJbbbb9BmbaCaE:ta5a8Aa3aL:tNNNa8E:vawMhwkdndnaOaQ0mbaOhkaYhPxekaOhsaYhzkdndnaKcl0mbdnawJbbbZMgw:lJbbb9p9DTmbaw:Ohvxdkcjjjj94hvxekaPazfcd9ThvkaKcefgKcs9hmbkkdndndnakmbJbbjZhwcbhOcdhvaDmexdkalcd4alfhHcehOinaOgvcethOavaH6mbkaqcuavcdtavcFFFFi0Ecbyd;y:L:cjbHjjjjbbgYBdCaqciBd2aqamcbyd;y:L:cjbHjjjjbbgzBdKaqclBd2dnalTmbaPcuf:YhwdnaoTmbcbhOaihAaxhHindndnaoaOfRbbceGTmbaOcjjjjlVhXxekdndnaHclfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaXcqthXdndnaHcwfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:Ohrxekcjjjj94hrkaXarVhXdndnaHIdbawNJbbbZMgC:lJbbb9p9DTmbaC:Ohrxekcjjjj94hrkaXarcCtVhXkaAaXBdbaAclfhAaHcxfhHalaOcefgO9hmbxdkkaxhOaihHalhAindndnaOIdbawNJbbbZMgC:lJbbb9p9DTmbaC:OhXxekcjjjj94hXkaXcCthXdndnaOclfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:Ohrxekcjjjj94hrkarcqtaXVhXdndnaOcwfIdbawNJbbbZMgC:lJbbb9p9DTmbaC:Ohrxekcjjjj94hrkaHaXarVBdbaOcxfhOaHclfhHaAcufgAmbkkaqcuaYavazaialz:mjjjbgXc8S2gvaXc;D;O;f8U0Ecbyd;y:L:cjbHjjjjbbgiBd3aqcvBd2aicbavz:xjjjbhOdnadTmbcbhraehiinaxaiclfydbgocx2fgvIdbaxaiydbgPcx2fgHIdbg3:tgCaxaicwfydbgYcx2fgAIdlaHIdlg8A:tgwNavIdla8A:tgEaAIdba3:tg8EN:tgLaLNaEaAIdwaHIdwg5:tg8FNavIdwa5:tgEawN:tgwawNaEa8ENaCa8FN:tgCaCNMMg8E:rhEJbbnnJbbjZazaPcdtfydbgvazaocdtfydbgASavazaYcdtfydbgoSGgHEh8Fdna8EJbbbb9ETmbaLaE:vhLaCaE:vhCawaE:vhwkaOavc8S2fgvavIdbawa8FaE:rNgEawNNg8FMUdbavaCaEaCNgaNghavIdlMUdlavaLaEaLNg8ENggavIdwMUdwavawaaNgaavIdxMUdxava8EawNg8JavIdzMUdzavaCa8ENg8EavIdCMUdCavawaEaLa5Nawa3Na8AaCNMM:mg8ANg3NgwavIdKMUdKavaCa3NgCavId3MUd3avaLa3NgLavIdaMUdaava3a8ANg3avId8KMUd8KavaEavIdyMUdydnaHmbaOaAc8S2fgva8FavIdbMUdbavahavIdlMUdlavagavIdwMUdwavaaavIdxMUdxava8JavIdzMUdzava8EavIdCMUdCavawavIdKMUdKavaCavId3MUd3avaLavIdaMUdaava3avId8KMUd8KavaEavIdyMUdyaOaoc8S2fgva8FavIdbMUdbavahavIdlMUdlavagavIdwMUdwavaaavIdxMUdxava8JavIdzMUdzava8EavIdCMUdCavawavIdKMUdKavaCavId3MUd3avaLavIdaMUdaava3avId8KMUd8KavaEavIdyMUdykaicxfhiarcifgrad6mbkkcbhAaqcuaXcdtgvaXcFFFFi0Egicbyd;y:L:cjbHjjjjbbgHBdaaqcoBd2aqaicbyd;y:L:cjbHjjjjbbgiBd8KaqcrBd2aHcFeavz:xjjjbhPdnalTmbazhHinJbbbbJbbjZaOaHydbgrc8S2fgvIdygw:vawJbbbb9BEavIdwaxcwfIdbgwNavIdzaxIdbgCNavIdaMgLaLMMawNavIdlaxclfIdbgLNavIdCawNavId3MgwawMMaLNavIdbaCNavIdxaLNavIdKMgwawMMaCNavId8KMMM:lNhwdndnaParcdtgvfgrydbcuSmbaiavfIdbaw9ETmekaraABdbaiavfawUdbkaHclfhHaxcxfhxalaAcefgA9hmbkkdndnaXmbJbbbbhwxekJbbbbhwinaiIdbgCawawaC9DEhwaiclfhiaXcufgXmbkaw:rhwkakcd4akfhOcehiinaigvcethiavaO6mbkcbhOaqcuavcdtgiavcFFFFi0Ecbyd;y:L:cjbHjjjjbbgHBdyaHcFeaiz:xjjjbhXdnadTmbavcufhrcbhkcbhxindnazaeaxcdtfgvydbcdtfydbgiazavclfydbcdtfydbgOSmbaiazavcwfydbcdtfydbgvSmbaOavSmbaPavcdtfydbhAdndnaPaOcdtfydbgvaPaicdtfydbgi9pmbavaA9pmbaAhlaihoavhAxekdnaAai9pmbaAav9pmbaihlavhoxekavhlaAhoaihAkabakcx2fgvaABdbavcwfaoBdbavclfalBdbdnaXaoc:3F;N8N2alc:F:b:DD27aAc;D;O:B8J27arGgOcdtfgvydbgicuSmbcehHinaHhvdnabaicx2fgiydbaA9hmbaiydlal9hmbaiydwaoSmikavcefhHaXaOavfarGgOcdtfgvydbgicu9hmbkkavakBdbakcefhkkaxcifgxad6mbkakci2hOkcwhvaDTmekaDawUdbkavcdthvaqcxfc98fhiinaiavfydbcbyd;C:L:cjbH:bjjjbbavc98fgvmbkaqc;Wbf8KjjjjbaOk:0iewuabcFeaecdtz:xjjjbhbdnalmbcbskaecufhvdndnaiTmbcbhocbhrindndndnabaiarcdtgwfydbgDcm4aD7c:v;t;h;Ev2gecs4ae7avGgqcdtfgkydbgxcuSmbceheinaiaxcdtgxfydbaDSmdaqaefhxaecefheabaxavGgqcdtfgkydbgxcu9hmbkkakarBdbaoheaocefhoxekadaxfydbhekadawfaeBdbarcefgral9hmbxdkkcbhocbhDindnabaDcm4aD7c:v;t;h;Ev2gecs4ae7avGgqcdtfgkydbgxcuSmbaxaDSmbceheinabaqaefavGgqcdtfgkydbgxcuSmeaecefheaxaD9hmbkkdndnaxcu9hmbakaDBdbaoheaocefhoxekadaxcdtfydbhekadaDcdtfaeBdbaDcefgDal9hmbkkaok:3ldrue9:8Jjjjjbc;Wb9Rgr8Kjjjjbcbhwarcxfcbc;Kbz:xjjjb8AdnabaeSmbabaeadcdtz:wjjjb8AkarcualcdtalcFFFFi0EgDcbyd;y:L:cjbHjjjjbbgqBdxarceBd2aqcbaialavcbarcxfz:djjjbcualcx2alc;v:Q;v:Qe0Ecbyd;y:L:cjbHjjjjbbhkarcxfaryd2gxcdtfakBdbaraxcefgmBd2akaialavcbcbz:ejjjb8AarcxfamcdtfaDcbyd;y:L:cjbHjjjjbbgiBdbaraxcdfgvBd2arcxfavcdtfcuaialaeadaqz:fjjjbgecltaecjjjjiGEcbyd;y:L:cjbHjjjjbbgqBdbaqaeaiakalz:gjjjbaxcifhkdnadTmbaoaoNhocbhwabhlcbheindnaqaialydbgvcdtfydbcdtfIdbao9ETmbalclf8PdbhPabawcdtfgDavBdbaDclfaP83dbawcifhwkalcxfhlaecifgead6mbkkdnakTmbaxcdtarcxffcwfhlinalydbcbyd;C:L:cjbH:bjjjbbalc98fhlakcufgkmbkkarc;Wbf8Kjjjjbawk;lOoDud99oue99vuv998Jjjjjbc;Wb9Rgw8KjjjjbdndnarmbcbhDxekawcxfcbc;Kbz:xjjjb8Aawcuadcx2adc;v:Q;v:Qe0Ecbyd;y:L:cjbHjjjjbbgqBdxawceBd2aqaeadaicbcbz:ejjjb8AawcuadcdtadcFFFFi0Egkcbyd;y:L:cjbHjjjjbbgxBdzawcdBd2adcd4adfhecehiinaigmcethiamae6mbkcbhPawcuamcdtgsamcFFFFi0Ecbyd;y:L:cjbHjjjjbbgzBdCawciBd2dndnar:ZgH:rJbbbZMgO:lJbbb9p9DTmbaO:Ohixekcjjjj94hikamcufhAc:bwhCcbhXadhQcbhLinaiaCcufgeaiae9iEaPcefaiaP9kEhDdndnadTmbaDcuf:YhOaqhiaxheadhKindndnaiIdbaONJbbbZMgY:lJbbb9p9DTmbaY:Oh8Axekcjjjj94h8Aka8AcCth8AdndnaiclfIdbaONJbbbZMgY:lJbbb9p9DTmbaY:OhExekcjjjj94hEkaEcqta8AVh8AdndnaicwfIdbaONJbbbZMgY:lJbbb9p9DTmbaY:OhExekcjjjj94hEkaea8AaEVBdbaicxfhiaeclfheaKcufgKmbkazcFeasz:xjjjbh3cbh5cbh8Eindna3axa8Ecdtfydbg8Acm4a8A7c:v;t;h;Ev2gics4ai7aAGgKcdtfgEydbgecuSmbaea8ASmbcehiina3aKaifaAGgKcdtfgEydbgecuSmeaicefhiaea8A9hmbkkaEa8ABdba5aecuSfh5a8Ecefg8Ead9hmbxdkkazcFeasz:xjjjb8Acbh5kdnaQ:ZgYaH:taD:YgOaC:Y:tg8FNaX:Zgaa5:Zgh:tNaaaH:taOaP:Y:tggNahaY:tNMg8JJbbbb9BmbaYaa:taga8FahaH:tNNNa8J:vaOMhOkaPaDa5ar0geEhPaXa5aeEhXdna5arSmbaDaCaeEgCaP9Rcd9imbdndnaLcl0mbdnaOJbbbZMgO:lJbbb9p9DTmbaO:Ohixdkcjjjj94hixekaPaCfcd9Thika5aQaeEhQaLcefgLcs9hmekkdndnaXmbcihicbhDxekawakcbyd;y:L:cjbHjjjjbbg8ABdKawclBd2aPcuf:YhYdnadTmbaqhiaxheadhKindndnaiIdbaYNJbbbZMgO:lJbbb9p9DTmbaO:OhExekcjjjj94hEkaEcCthEdndnaiclfIdbaYNJbbbZMgO:lJbbb9p9DTmbaO:Oh3xekcjjjj94h3ka3cqtaEVhEdndnaicwfIdbaYNJbbbZMgO:lJbbb9p9DTmbaO:Oh3xekcjjjj94h3kaeaEa3VBdbaicxfhiaeclfheaKcufgKmbkkawcuazama8Aaxadz:mjjjbgDc32giaDc;j:KM;jb0Ecbyd;y:L:cjbHjjjjbbgeBd3awcvBd2aecbaiz:xjjjbh3avcd4hxdnadTmbdnalTmbaxcdth8Ea8AhEaqhealhKadhAina3aEydbc32fgiaeIdbaiIdbMUdbaiaeclfIdbaiIdlMUdlaiaecwfIdbaiIdwMUdwaiaKIdbaiIdxMUdxaiaKclfIdbaiIdzMUdzaiaKcwfIdbaiIdCMUdCaiaiIdKJbbjZMUdKaEclfhEaecxfheaKa8EfhKaAcufgAmbxdkka8AhKaqheadhEina3aKydbc32fgiaeIdbaiIdbMUdbaiaeclfIdbaiIdlMUdlaiaecwfIdbaiIdwMUdwaiaiIdxJbbbbMUdxaiaiIdzJbbbbMUdzaiaiIdCJbbbbMUdCaiaiIdKJbbjZMUdKaKclfhKaecxfheaEcufgEmbkkdnaDTmba3hiaDheinaiaiIdbJbbbbJbbjZaicKfIdbgO:vaOJbbbb9BEgONUdbaiclfgKaOaKIdbNUdbaicwfgKaOaKIdbNUdbaicxfgKaOaKIdbNUdbaiczfgKaOaKIdbNUdbaicCfgKaOaKIdbNUdbaic3fhiaecufgembkkcbhEawcuaDcdtgCaDcFFFFi0Egicbyd;y:L:cjbHjjjjbbgeBdaawcoBd2awaicbyd;y:L:cjbHjjjjbbg8EBd8KaecFeaCz:xjjjbh5dnadTmbaoJbbjZJbbjZaY:vaPceSENgOaONhYaxcdthxalheinaYaecN:H:cjbalEgKIdwa3a8AydbgAc32fgiIdC:tgOaONaKIdbaiIdx:tgOaONaKIdlaiIdz:tgOaONMMNaqcwfIdbaiIdw:tgOaONaqIdbaiIdb:tgOaONaqclfIdbaiIdl:tgOaONMMMhOdndna5aAcdtgifgKydbcuSmba8EaifIdbaO9ETmekaKaEBdba8EaifaOUdbka8Aclfh8AaqcxfhqaeaxfheadaEcefgE9hmbkkaba5aCz:wjjjb8Acrhikaicdthiawcxfc98fheinaeaifydbcbyd;C:L:cjbH:bjjjbbaic98fgimbkkawc;Wbf8KjjjjbaDk:Pdidui99ducbhi8Jjjjjbca9Rglcbyd1:G:cjbBdKalcb8Pdj:G:cjb83izalcbydN:G:cjbBdwalcb8Pd:m:G:cjb83ibdndnaembJbbjFhvJbbjFhoJbbjFhrxekadcd4cdthwincbhdinalczfadfgDabadfIdbgvaDIdbgoaoav9EEUdbaladfgDavaDIdbgoaoav9DEUdbadclfgdcx9hmbkabawfhbaicefgiae9hmbkalIdwalIdK:thralIdlalIdC:thoalIdbalIdz:thvkJbbbbavavJbbbb9DEgvaoaoav9DEgvararav9DEk:H8Modui99lud99Aus998Jjjjjbcji9RgD8KjjjjbcbhqaDcxfcbc;Kbz:xjjjb8AaDcbBdwaD9cb83ibaDcbyd;i:L:cjbBd1eaDcb8Pd;a:L:cjb83ijeaDcbyd;u:L:cjbBd94aDcb8Pd;m:L:cjb83i9WdndnavmbJbbjFhkJbbjFhxJbbjFhmxekaocd4cdthPalhsincbhzinaDcjefazfgHasazfIdbgkaHIdbgxaxak9EEUdbaDc;WbfazfgHakaHIdbgxaxak9DEUdbazclfgzcx9hmbkasaPfhsaqcefgqav9hmbkaDId94aDId1e:thmaDIdtaDId:ee:thxaDId9WaDIdje:thkkJbbbbhOdnar:YgAJq;x8J88MaA:vJbbbbakakJbbbb9DEgkaxaxak9DEgkamamak9DENgxJbbbb9Bmbarc9:f:Yax:vhOkaDcCfhCaDcxfcxfhXcbhzinaDazfaDcjefazfIdbgkaxaDc;WbfazfIdbak:t:tJbbb:;NMUdbazclfgzcx9hmbkcbhQaDarar2gLar2gzcbyd;y:L:cjbHjjjjbbgHBdxaDceBd2aHcbazz:xjjjbgKcbcbadaialaoaraOaDawz:rjjjbcdhYaDcuaLcdtaLcFFFFi0Eg8Acbyd;y:L:cjbHjjjjbbgEBdzaDcdBd2aDcjefcbarz:xjjjb8Acbh3dnaLTmbdnarcb9kmbaKhzaEhHaLhsincbh3aHcbcuazaDcjefarz:AjjjbEBdbazarfhzaHclfhHascufgsmbxdkkaKhPcbh3cbhvindndnaKavar2faDcjefarz:AjjjbTmbcbhHaPhzarhsinazaHazRbbgqfgHcbaqE86bbazcefhzascufgsmbkaEavcdtfa3BdbaHa3fh3xekaEavcdtfcuBdbkaParfhPavcefgvaL9hmbkkdnabTmbaDcua3cotgza3cFFF8F0Ecbyd;y:L:cjbHjjjjbbgQBdCcihYaDciBd2aQcbazz:xjjjb8AaXhCkdnawceGmbaCa8Acbyd;y:L:cjbHjjjjbbg5BdbaDaYcefgzBd2aDcxfazcdtfaLcbyd;y:L:cjbHjjjjbbgzBdbaDaYcdfgYBd2azcbaLz:xjjjbh8EarcufhXdnarci9imbarc9:fhCararcef2aKfcefh8Aceh8Fina8Far2hPa8AhvcehqindnaEaqaPfcdtfydbcuSmbavhzaChHinazazRbbgscuasE86bbazcefhzaHcufgHmbkkavarfhvaqcefgqaX9hmbka8AaLfh8Aa8Fcefg8FaX9hmbkkarce9imbcbh8Acbhqcbhvina8EaqfhscbhzindnasazfgHRbbmbaHce86bba5a8AcdtfaqazfBdba8Acefh8Akarazcefgz9hmbkaqarfhqavcefgvar9hmbka8ATmbaKcefhaaKc9:fhharc9:fhgarci9ih8Jina8Ea5a8Acufg8Acdtfydbgvfcb86bbavar2hPdna8JmbaEavcdtfydbcuSmbaKaPfhHaghqindnaHcefgzRbbgscFe9hmbaHRbbmbcbhskazas86bbazhHaqcufgqmbkaharavcef2fhzaXhsindnazRbbgHcFe9hmbazcefRbbmbcbhHkazaH86bbazcufhzascufgsce9kmbkkaaaPfh8Kavavar9Ug8Lar29Rh8FcbhCindnaCceScuaCEa8Ffgzce9imbazaX9ombcuaCciSaCcdSEa8LfgHce9imbaHaX9ombaEaHar2azfg8McdtfydbcuSmba8Jmbaaa8Mar2fhzcbhqa8KhsaghvinazazRbbgHcbaHaHcFeSEasRbbEgP86bbascefhsazcefhzaPaH7aqVhqavcufgvmbkaqcFeGTmba8Ea8MfgzRbbmbazce86bba5a8Acdtfa8MBdba8Acefh8AkaCcefgCcl9hmbka8AmbkkdnaQTmbaKaEaQadaialaoaraOaDawz:rjjjba3TmbJbbjZaO:vhkawcjjjjlGhPdnawcdGTmbJbbnnaOaON:vh8NakJbbbZNhyaQhzinazczfgsIdbg8PazcCfIdbgx:vhmazcxfgqIdbgIax:vhAazcwfgvIdbg8Rax:vh8SakazydbgHcFrG:ZNhRakaHcq4cFrG:ZNh8UakaHcC4cFrG:ZNh8VdnaxJ:p;c;188Ng8WazcKfIdbMg8X:laxJ:983:g81Ngx9ETmba8Wazc3fIdbMazc8KfIdbg8Ya8Ya8X:vg8YN:tg8Z:lax9ETmba8WazcafIdbMazcyfIdbg8Wa8Wa8X:vg80N:tazc8SfIdba8Wa8YN:tg8Wa8Wa8Z:vg8WN:tg81:lax9ETmba8PJ:p;c;188NazcUfIdb:ta80a8RJ:p;c;188Nazc8WfIdb:tg8PN:ta8WaIJ:p;c;188Nazc80fIdb:ta8Ya8PN:tgIN:ta81:vgxam:tg8Ra8RNa8Pa8X:va8YaIa8Z:va8WaxN:tg8XN:ta80axN:tg8Wa8S:tg8Ya8YNa8XaA:tg8Ya8YNMMa8N9DTmbaxaRaxaR9EEgxakaRMgmaxam9DEhma8Xa8Ua8Xa8U9EEgxaka8UMgAaxaA9DEhAa8Wa8Va8Wa8V9EEgxaka8VMg8Saxa8S9DEh8SkdnaPTmbayaRMhmaya8UMhAaya8VMh8SkasamUdbaqaAUdbava8SUdbazc;abfhza3cufg3mbxdkkdnaPTmbakJbbbZNhxaQhzinazczfaxakazydbgHcFrG:ZNMUdbazcxfaxakaHcq4cFrG:ZNMUdbazcwfaxakaHcC4cFrG:ZNMUdbazc;abfhza3cufg3mbxdkkaQcCfhzinazc98fgHaHIdbazIdbgk:vUdbazc94fgHaHIdbak:vUdbazctfgHaHIdbak:vUdbazc;abfhza3cufg3mbkkcbhsdndnarcd9imbarcufh3aEarcdtfhadnabmbaKcefg8Mararcefgz2fh8JaKazfhba8MaLfh8Ecbhscbh8Kina8Kar2h8La8Mheabh8Aa8Eh8Fa8Jh5cbhXindnaEaXa8LfgqcdtgzfgHclfydbaHydbGaaazfgzydbGazclfydbGcuSmbclcbaKaqar2fgzarfRbbEazRbbcb9hVczcbazaLfgzRbbEVc;abcbazarfRbbEVhPaehza8AhHa8Fhqa5hva3hQindnaPclcbaHRbbEazRbbcb9hVczcbaqRbbEVc;abcbavRbbEVgPcetVgCTmbaCcFeSmbasaCRb;W;p:cjbfhskazcefhzaHcefhHaqcefhqavcefhvaQcufgQmbkkaearfhea8Aarfh8Aa8Farfh8Fa5arfh5aXcefgXa39hmbka8MaLfh8MabaLfhba8EaLfh8Ea8JaLfh8Ja8Kcefg8Ka39hmbxdkkJbbjZaO:vgkakJk;x8J88NNh8RawcdGh8EaDIdwhkaDIdlhxaDIdbhmcbhscbhPinaPar2h8KcbhvindnaEava8KfgqcdtgzfgHclfydbaHydbGaaazfgzydbGazclfydbGcuSmbcbh8AclcbaKaqar2fgYarfRbbEaYRbbcb9hVczcbaYaLfg8JRbbEVc;abcba8JarfRbbEVh8Lindna8LclcbaYa8Ag8Mcefg8AfgzarfRbbEazRbbcb9hVczcba8Ja8AfgzRbbEVc;abcbazarfRbbEVg8LcetVgCTmbaCcFeSmbcbhqdndndnaCRb;W;n:cjbcufPdebdka8ETmeaCcC2gz8Ve;W:L:cjbcltaz8Ve;Y:L:cjbcsGVh8FaKa8Mfh5cxhzaDcjefhHinaHaQaEa8Faz4gqce4ceGavfaqcd4ceGaPfar2fgXcdtfydbcotfa5aqceGfaXar2fRbbcotfcnfBdbaHclfhHazc98fgzc989hmbkaDydjegzIdyaDyd:megHIdyMaDyd:eegqIdyaDyd1egXIdyMMg8XaqIdwaXIdwMJbbbZNgANazIdUaHIdUMaqIdUaXIdUMMg8WMg8Sa8SMazIdaaHIdaMaqIdaaXIdaMMg8YaqIdzaXIdzMJbbbZNg8SNMa8SNazId8SaHId8SMaqId8SaXId8SMMgRa8SNazId80aHId80MaqId80aXId80MMg8UMg8Sa8SMazId3aHId3MaqId3aXId3MMg8VaqIdxaXIdxMJbbbZNg8SNMa8SNazId8KaHId8KMaqId8KaXId8KMMg8Za8SNazId8WaHId8WMaqId8WaXId8WMMg80Mg8Sa8SMazIdKaHIdKMaqIdKaXIdKMMgyaANMaANazId88aHId88MaqId88aXId88MMg8PMMM:lgIa8RazIdCaHIdCMaqIdCaXIdCMMN9Ea8XazIdwaHIdwMJbbbZNgANa8WMg8Sa8SMa8YazIdzaHIdzMJbbbZNg8SNMa8SNaRa8SNa8UMg8Sa8SMa8VazIdxaHIdxMJbbbZNg8SNMa8SNa8Za8SNa80Mg8Sa8SMayaANMaANa8PMMM:laIJ;d;1UZN9DGhqxekaKa8Mfh8FcbhzcrhHindnaCaz4ceGTmba8FazceGfazce4ceGavfazcd4aPfar2fgqar2fRbbgXcFeSmbaQaEaqcdtfydbcotfaXcotfc9efRbbaH4ceGTmbcbhqxdkaHcufhHcehqazcefgzcw9hmbkkaCcC2aqcq2fgH8Ve;W:L:cjbgzTmbaHc;Y:L:cjbfhqaKa8MfhCabasc8K2fhHindnasae9pmbaHaQaEazcD4ceGavfazcq4ceGaPfar2fgXcdtfydbcotfaCazcw4ceGfaXar2fRbbcotfgXc9ifIdbamMUdbaHclfaXc9mfIdbaxMUdbaHcwfaXc9qfIdbakMUdbaHcxfamaQaEazcv4ceGavfazco4ceGaPfar2fgXcdtfydbcotfaCazcl4ceGfaXar2fRbbcotfgXc9ifIdbMUdbaHczfaxaXc9mfIdbMUdbaHcCfakaXc9qfIdbMUdbaHcKfamaQaEazce4ceGavfazcd4ceGaPfar2fgXcdtfydbcotfaCazceGfaXar2fRbbcotfgzc9ifIdbMUdbaHc3faxazc9mfIdbMUdbaHcafakazc9qfIdbMUdbkaHc8KfhHascefhsaq8Vebhzaqcdfhqazmbkka8Aa39hmbkkavcefgva39hmbkaPcefgPa39hmbkaDyd2gYTmekaYcdtaDcxffc98fhzinazydbcbyd;C:L:cjbH:bjjjbbazc98fhzaYcufgYmbkkaDcjif8Kjjjjbask;Kxmiue99due99euz99eui99eud99dud99oudnalTmbaocd4hkaqcdGhxarc99fhqarcethmawawMhPcbhsindndnawavaiascdtfgoclfydbak2cdtfgzIdwgHavaoydbak2cdtfgOIdwgA:tgCaCNazIdbgXaOIdbgQ:tgLaLNazIdlgKaOIdlgY:tg8Aa8ANMMgEavaocwfydbak2cdtfgoIdwg3aA:tg5a5NaoIdbg8EaQ:tg8Fa8FNaoIdlgaaY:tghahNMMggaEag9EEgEa3aH:tgHaHNa8EaX:tgHaHNaaaK:tgHaHNMMgHaEaH9EE:rNgHaHMgH:lJbbb9p9DTmbaH:Ohoxekcjjjj94hokdnaLahNa8Aa8FN:tgHaHNa8Aa5NaCahN:tgXaXNaCa8FNaLa5N:tgKaKNMMg3Jbbbb9BmbJbbjZhEdnaoceaoce9kEgoamaoam9iEg8Jcd9imbJbbjZa8J:Z:vhEkarcb9imbaAaDIdw:th8KaYaDIdl:th8LaQaDIdb:th8Ma8Jcba8Jcb9kEh8NdnadTmbaHJbbjZa3:rgA:vgQNg3aAa8Jcefa8Jcdf2:Y:vgANh8EaKaQNgKaANhyaXaQNgXaXaANNh8PcbhIina8Jcba8Jcb9kEcefh8RaEaI:ZNgQaCNa8KMhgaQa8ANa8LMh8SaQaLNa8MMhRcbhzindndnaPaEaz:ZNgQahNa8SMgYNgH:lJbbb9p9DTmbaH:OhOxekcjjjj94hOkaOce91goaqaoaq6Eh8UdndnaPaQa5NagMgHNga:lJbbb9p9DTmbaa:Oh8Vxekcjjjj94h8Vka8Ua8Vce91goaqaoaq6Eg8Wcefar2fcefgoar2h8XdndnaPaQa8FNaRMgQNga:lJbbb9p9DTmbaa:Oh8Yxekcjjjj94h8Ykadaeaocdtfydbcotfaba8Yce91goaqaoaq6Eg8Zfa8XfcefRbbcotfgocnfa8Ucqta8ZcCtVa8WVBdbaoc9efg8Ua8URbbcea8YceGaOcetcdGVa8VcdtclGVtV86bbaoc9ifgOaQaANaOIdbMUdbaoc9mfgOaYaANaOIdbMUdbaoc9qfgOaHaANaOIdbMUdbaoc9ufgOaAaOIdbMUdbdnaxTmbaoc9yfgOa8PaOIdbMUdbaoc9CfgOaKayNaOIdbMUdbaoc9GfgOa3a8ENaOIdbMUdbaoc9KfgOaXayNaOIdbMUdbaoc9OfgOaXa8ENaOIdbMUdbaoc2fgOaKa8ENaOIdbMUdbaoc9WfgOaXaAa3aHNaXaQNaKaYNMMgY:mNgQNaOIdbMUdbaoctfgOaKaQNaOIdbMUdbaoc94fgOa3aQNaOIdbMUdbaoc98fgoaoIdbaYaQN:tUdbka8Razcefgz9hmbka8Jcufh8JaIa8NShoaIcefhIaoTmbxdkkcbh8Vina8Jcba8Jcb9kEcefh8UaEa8V:ZNgAaCNa8KMhYaAa8ANa8LMhHaAaLNa8MMhXcbhoindndnaPaEao:ZNgAahNaHMNgQ:lJbbb9p9DTmbaQ:Ohzxekcjjjj94hzkazce91gzaqazaq6EhzdndnaPaAa5NaYMNgQ:lJbbb9p9DTmbaQ:OhOxekcjjjj94hOkazaOce91gOaqaOaq6Ecefar2fcefar2hzdndnaPaAa8FNaXMNgA:lJbbb9p9DTmbaA:OhOxekcjjjj94hOkabaOce91gOaqaOaq6Efazfcefce86bba8Uaocefgo9hmbka8Jcufh8Ja8Va8NShoa8Vcefh8VaoTmbkkascifgsal6mbkkk:Nvezu8Jjjjjbcjd9Rgb8Kjjjjbcbheabcbcjdz:xjjjbhdc:W:H:cjbhbinabRbbgicC2glabcqf8Veb87e;4:L:cjbalabcdfgv8Peb83e;W:L:cjbaiabcefRbb86b;W;n:cjbadaifce86bbalavabcxfceaetc:F:d;avGEgi8Peb83e;6:L:cjbalai8Vew87e:c:M:cjbabcQfhbaecefgecK9hmbkcbhoinc;Y:L:cjbhrcbhvindnadavfgwRbbce9hmbavcC2c;W:L:cjbfhDcbhbcehqavc;W;n:cjbfhkinabcitc:G:H:cjbfhlcbhbcbheinaeavab4ceGalabfRbbtVheabcefgbcw9hmbkdnadaecFeGgxfgmRbbmbaxcC2c;W:L:cjbfhPcbhbcehsindnaDabcq2gif8VebgbTmbaraifheaPaifhiinaialabcl4csGfRbbcltalabcw4csGfRbbcwtValabcsGfRbbV87ebaicdfhiae8VebhbaecdfheabmbkkcehbasceGhecbhsaembkamce86bbaxakRbb86b;W;n:cjbkcehbaqceGhlcbhqalmbkawcd86bbkarcCfhravcefgvcjd9hmbkaocefgoci9hmbkcbhic;W:L:cjbhvincuhlavhbinalcefhlab8Vebheabcdfhbaembkaial86b;W;p:cjbavcCfhvaicefgicjd9hmbkadcjdf8Kjjjjbk9DeeuabcFeaicdtz:xjjjbhlcbhbdnadTmbindnalaeydbcdtfgiydbcu9hmbaiabBdbabcefhbkaeclfheadcufgdmbkkabk;Bidqui998Jjjjjbc;Wb9Rgl8Kjjjjbalcxfcbc;Kbz:xjjjb8Aadcd4adfhvcehoinaogrcethoarav6mbkalcuarcdtgoarcFFFFi0Ecbyd;y:L:cjbHjjjjbbgvBdxavcFeaoz:xjjjbhwdnadTmbaicd4hDarcufhqcbhkindndnawcbaeakaD2cdtfgrydlgiaicjjjj94SEgocH4ao7c:F:b:DD2cbarydbgxaxcjjjj94SEgocH4ao7c;D;O:B8J27cbarydwgmamcjjjj94SEgrcH4ar7c:3F;N8N27aqGgvcdtfgrydbgocuSmbam::hPai::hsax::hzcehiinaihrdnaeaoaD2cdtfgiIdbaz9CmbaiIdlas9CmbaiIdwaP9BmikarcefhiawavarfaqGgvcdtfgrydbgocu9hmbkkarakBdbakhokabakcdtfaoBdbakcefgkad9hmbkkalydxcbyd;C:L:cjbH:bjjjbbalc;Wbf8Kjjjjbk9teiucbcbyd;G:L:cjbgeabcifc98GfgbBd;G:L:cjbdndnabZbcztgd9nmbcuhiabad9RcFFifcz4nbcuSmekaehikaik;LeeeudndnaeabVciGTmbabhixekdndnadcz9pmbabhixekabhiinaiaeydbBdbaiclfaeclfydbBdbaicwfaecwfydbBdbaicxfaecxfydbBdbaeczfheaiczfhiadc9Wfgdcs0mbkkadcl6mbinaiaeydbBdbaeclfheaiclfhiadc98fgdci0mbkkdnadTmbinaiaeRbb86bbaicefhiaecefheadcufgdmbkkabk;aeedudndnabciGTmbabhixekaecFeGc:b:c:ew2hldndnadcz9pmbabhixekabhiinaialBdbaicxfalBdbaicwfalBdbaiclfalBdbaiczfhiadc9Wfgdcs0mbkkadcl6mbinaialBdbaiclfhiadc98fgdci0mbkkdnadTmbinaiae86bbaicefhiadcufgdmbkkabk9teiucbcbyd;G:L:cjbgeabcrfc94GfgbBd;G:L:cjbdndnabZbcztgd9nmbcuhiabad9RcFFifcz4nbcuSmekaehikaikTeeucbabcbyd;G:L:cjbge9Rcifc98GaefgbBd;G:L:cjbdnabZbcztge9nmbabae9RcFFifcz4nb8Akk6eiucbhidnadTmbdninabRbbglaeRbbgv9hmeaecefheabcefhbadcufgdmbxdkkalav9Rhikaikk;0vdbcj:Gdk;yvFFuuFFuuFFuuFFuFFFuFFFuFbbbbbbbbebbbdbbbbbbbebbbebbbdbbbbbbbbbbbeeeeeebebbeebbebbebbbeeebbbbebbbbbbbbbbbbbbbbbbbeeeeeeebebbbeeebbeebbbbbebbbbbebebbbbbbbbbbbbbbbdiorbelvlbodveribbbbbbbbbbbbbbbbbbbbbbebbbbbbbbbbbbbbbbbbbbbibbbbbbbbbbbbbbbbbbbbbobbbbbbbbbbbbbbbbbbbbbrbaebbbbbbbbbbbbbbbbbbsd8We8YbbbbbbbhiaebbbbbbQe8Ke9cebbbbbbbbbbbbbbbbLb8KebbbbbbbbbbbbbbbbbbKbbbbbbbbbbbbbbbbbbbbbYeJbilbbbbbbbbbbbbbbbbEe80e8WlbbbbbbzlAbbbbbbb5eJdnibbbbbbai8Kbbbbbbb8Ee9ce8Ylcibbbb8Yebbbbbbbb8FdOlAdbbbbbb80e8Ylbbbbbb88eTi8KiJv8Jlbbbbbbbbbbbb89e9td8Kv9qibbbbndlvaibbbbZd8Li8KvbbbbbbJdTibbbbbb9Pe81b9GvoiBvbbbbbbbbbbbb9Re9JbvoWibbbbvibbbbbbbb9VeWi9Gvbbbbbb8WvBbbbbbbb9:b9ceBvbbbbbbbbbbbbbbbbubWibbbbbbbbbbbbbbbbbb;Wd9hvSrbbbbbbWl9NvbbbbbbFbbbbbbbbbbbbbbbbbbbbbFFuuFFuuFFuuFFuFFFuFFFuFbc;y:Ldkxebbbdbbb;W:Obb",z=new Uint8Array([32,0,65,2,1,106,34,33,3,128,11,4,13,64,6,253,10,7,15,116,127,5,8,12,40,16,19,54,20,9,27,255,113,17,42,67,24,23,146,148,18,14,22,45,70,69,56,114,101,21,25,63,75,136,108,28,118,29,73,115]);if(typeof WebAssembly!="object")return{supported:!1};var m,x=WebAssembly.instantiate(Y(E),{}).then(function(a){m=a.instance,m.exports.__wasm_call_ctors()});function Y(a){for(var b=new Uint8Array(a.length),d=0;d<a.length;++d){var h=a.charCodeAt(d);b[d]=h>96?h-97:h>64?h-39:h+4}for(var f=0,d=0;d<a.length;++d)b[f++]=b[d]<60?z[b[d]]:(b[d]-60)*64+b[++d];return b.buffer.slice(0,f)}function c(a){if(!a)throw new Error("Assertion failed")}function M(a){return new Uint8Array(a.buffer,a.byteOffset,a.byteLength)}function K(a,b,d,h){var f=m.exports.sbrk,e=f(d*4),I=f(d*h*4),g=new Uint8Array(m.exports.memory.buffer);g.set(M(b),I),a(e,I,d,h*4),g=new Uint8Array(m.exports.memory.buffer);var N=new Uint32Array(d);return new Uint8Array(N.buffer).set(g.subarray(e,e+d*4)),f(e-f(0)),N}function X(a,b,d){var h=m.exports.sbrk,f=h(b.length*4),e=h(d*4),I=new Uint8Array(m.exports.memory.buffer),g=M(b);I.set(g,f);var N=a(e,f,b.length,d);I=new Uint8Array(m.exports.memory.buffer);var j=new Uint32Array(d);new Uint8Array(j.buffer).set(I.subarray(e,e+d*4)),h(f-h(0));for(var n=0;n<b.length;++n)b[n]=j[b[n]];return[j,N]}function S(a){for(var b=0,d=0;d<a.length;++d){var h=a[d];b=b<h?h:b}return b}function F(a,b,d,h,f,e,I,g,N){var j=m.exports.sbrk,n=j(4),l=j(d*4),y=j(f*e),k=j(d*4),t=new Uint8Array(m.exports.memory.buffer);t.set(M(h),y),t.set(M(b),k);var A=a(l,k,d,y,f,e,I,g,N,n);t=new Uint8Array(m.exports.memory.buffer);var O=new Uint32Array(A);M(O).set(t.subarray(l,l+A*4));var U=new Float32Array(1);return M(U).set(t.subarray(n,n+4)),j(n-j(0)),[O,U[0]]}function L(a,b,d,h,f,e,I,g,N,j,n,l,y){var k=m.exports.sbrk,t=k(4),A=k(d*4),O=k(f*e),U=k(f*g),u=k(N.length*4),R=k(d*4),r=j?k(f):0,i=new Uint8Array(m.exports.memory.buffer);i.set(M(h),O),i.set(M(I),U),i.set(M(N),u),i.set(M(b),R),j&&i.set(M(j),r);var v=a(A,R,d,O,f,e,U,g,u,N.length,r,n,l,y,t);i=new Uint8Array(m.exports.memory.buffer);var J=new Uint32Array(v);M(J).set(i.subarray(A,A+v*4));var D=new Float32Array(1);return M(D).set(i.subarray(t,t+4)),k(t-k(0)),[J,D[0]]}function V(a,b,d,h,f,e,I,g,N,j,n,l,y){var k=m.exports.sbrk,t=k(4),A=k(f*e),O=k(f*g),U=k(N.length*4),u=k(d*4),R=j?k(f):0,r=new Uint8Array(m.exports.memory.buffer);r.set(M(h),A),r.set(M(I),O),r.set(M(N),U),r.set(M(b),u),j&&r.set(M(j),R);var i=a(u,d,A,f,e,O,g,U,N.length,R,n,l,y,t);r=new Uint8Array(m.exports.memory.buffer),M(b).set(r.subarray(u,u+i*4)),M(h).set(r.subarray(A,A+f*e)),M(I).set(r.subarray(O,O+f*g));var v=new Float32Array(1);return M(v).set(r.subarray(t,t+4)),k(t-k(0)),[i,v[0]]}function W(a,b,d,h){var f=m.exports.sbrk,e=f(d*h),I=new Uint8Array(m.exports.memory.buffer);I.set(M(b),e);var g=a(e,d,h);return f(e-f(0)),g}function H(a,b,d,h,f,e,I,g){var N=m.exports.sbrk,j=N(g*4),n=N(d*h),l=f?N(d*e):0,y=new Uint8Array(m.exports.memory.buffer);y.set(M(b),n),f&&y.set(M(f),l);var k=a(j,n,d,h,l,e,I,g);y=new Uint8Array(m.exports.memory.buffer);var t=new Uint32Array(k);return M(t).set(y.subarray(j,j+k*4)),N(j-N(0)),t}function T(a,b,d,h,f,e,I,g,N){var j=m.exports.sbrk,n=j(4),l=j(d*4),y=j(f*e),k=j(d*4),t=I?j(f):0,A=new Uint8Array(m.exports.memory.buffer);A.set(M(h),y),A.set(M(b),k),I&&A.set(M(I),t);var O=a(l,k,d,y,f,e,t,g,N,n);A=new Uint8Array(m.exports.memory.buffer);var U=new Uint32Array(O);M(U).set(A.subarray(l,l+O*4));var u=new Float32Array(1);return M(u).set(A.subarray(n,n+4)),j(n-j(0)),[U,u[0]]}function q(a,b,d,h,f,e,I){var g=m.exports.sbrk,N=g(d*4),j=g(f*e),n=g(d*4),l=new Uint8Array(m.exports.memory.buffer);l.set(M(h),j),l.set(M(b),n);var y=a(N,n,d,j,f,e,I);l=new Uint8Array(m.exports.memory.buffer);var k=new Uint32Array(y);return M(k).set(l.subarray(N,N+y*4)),g(N-g(0)),k}function o(a,b,d,h,f,e){var I=m.exports.sbrk,g=I(d.byteLength),N=I(b.byteLength),j=new Uint8Array(m.exports.memory.buffer);j.set(M(d),g),j.set(M(b),N);var n=d.byteLength/h,l=a(0,0,N,b.length,g,n,h,f,e),y=I(l*9*4),k=a(y,l,N,b.length,g,n,h,f,e);c(k<=l),j=new Uint8Array(m.exports.memory.buffer);var t=new Float32Array(k*9);return M(t).set(j.subarray(y,y+t.byteLength)),I(g-I(0)),t}var w={LockBorder:1,Sparse:2,ErrorAbsolute:4,Prune:8,Regularize:16,Permissive:32,RegularizeLight:64,PreserveFolds:128,ErrorClamped:256,_InternalDebug:1<<30},B={Shell:1,Solve:2,Thicken:0,_InternalDebug:1<<30};return{ready:x,supported:!0,compactMesh:function(a){c(a instanceof Uint32Array||a instanceof Int32Array||a instanceof Uint16Array||a instanceof Int16Array),c(a.length%3==0);var b=a.BYTES_PER_ELEMENT==4?a:new Uint32Array(a),d=X(m.exports.meshopt_optimizeVertexFetchRemap,b,S(a)+1);if(a!==b)for(var h=0;h<b.length;++h)a[h]=b[h];return d},generatePositionRemap:function(a,b){return c(a instanceof Float32Array),c(a.length%b==0),c(b>=3),K(m.exports.meshopt_generatePositionRemap,a,a.length/b,b)},simplify:function(a,b,d,h,f,e){c(a instanceof Uint32Array||a instanceof Int32Array||a instanceof Uint16Array||a instanceof Int16Array),c(a.length%3==0),c(b instanceof Float32Array),c(b.length%d==0),c(d>=3),c(h>=0&&h<=a.length),c(h%3==0),c(f>=0);for(var I=0,g=0;g<(e?e.length:0);++g)c(e[g]in w),I|=w[e[g]];var N=a.BYTES_PER_ELEMENT==4?a:new Uint32Array(a),j=F(m.exports.meshopt_simplify,N,a.length,b,b.length/d,d*4,h,f,I);return j[0]=a instanceof Uint32Array?j[0]:new a.constructor(j[0]),j},simplifyWithAttributes:function(a,b,d,h,f,e,I,g,N,j){c(a instanceof Uint32Array||a instanceof Int32Array||a instanceof Uint16Array||a instanceof Int16Array),c(a.length%3==0),c(b instanceof Float32Array),c(b.length%d==0),c(d>=3),c(h instanceof Float32Array),c(h.length==f*(b.length/d)),c(f>=0),c(I==null||I instanceof Uint8Array),c(I==null||I.length==b.length/d),c(g>=0&&g<=a.length),c(g%3==0),c(N>=0),c(Array.isArray(e)),c(f>=e.length),c(e.length<=32);for(var n=0;n<e.length;++n)c(e[n]>=0);for(var l=0,n=0;n<(j?j.length:0);++n)c(j[n]in w),l|=w[j[n]];var y=a.BYTES_PER_ELEMENT==4?a:new Uint32Array(a),k=L(m.exports.meshopt_simplifyWithAttributes,y,a.length,b,b.length/d,d*4,h,f*4,new Float32Array(e),I,g,N,l);return k[0]=a instanceof Uint32Array?k[0]:new a.constructor(k[0]),k},simplifyWithUpdate:function(a,b,d,h,f,e,I,g,N,j){c(a instanceof Uint32Array||a instanceof Int32Array||a instanceof Uint16Array||a instanceof Int16Array),c(a.length%3==0),c(b instanceof Float32Array),c(b.length%d==0),c(d>=3),c(h instanceof Float32Array),c(h.length==f*(b.length/d)),c(f>=0),c(I==null||I instanceof Uint8Array),c(I==null||I.length==b.length/d),c(g>=0&&g<=a.length),c(g%3==0),c(N>=0),c(Array.isArray(e)),c(f>=e.length),c(e.length<=32);for(var n=0;n<e.length;++n)c(e[n]>=0);for(var l=0,n=0;n<(j?j.length:0);++n)c(j[n]in w),l|=w[j[n]];var y=a.BYTES_PER_ELEMENT==4?a:new Uint32Array(a),k=V(m.exports.meshopt_simplifyWithUpdate,y,a.length,b,b.length/d,d*4,h,f*4,new Float32Array(e),I,g,N,l);if(a!==y)for(var n=0;n<k[0];++n)a[n]=y[n];return k},getScale:function(a,b){return c(a instanceof Float32Array),c(a.length%b==0),c(b>=3),W(m.exports.meshopt_simplifyScale,a,a.length/b,b*4)},simplifyPoints:function(a,b,d,h,f,e){return c(a instanceof Float32Array),c(a.length%b==0),c(b>=3),c(d>=0&&d<=a.length/b),h?(c(h instanceof Float32Array),c(h.length%f==0),c(f>=3),c(a.length/b==h.length/f),H(m.exports.meshopt_simplifyPoints,a,a.length/b,b*4,h,f*4,e||0,d)):H(m.exports.meshopt_simplifyPoints,a,a.length/b,b*4,void 0,0,0,d)},simplifySloppy:function(a,b,d,h,f,e){c(a instanceof Uint32Array||a instanceof Int32Array||a instanceof Uint16Array||a instanceof Int16Array),c(a.length%3==0),c(b instanceof Float32Array),c(b.length%d==0),c(d>=3),c(h==null||h instanceof Uint8Array),c(h==null||h.length==b.length/d),c(f>=0&&f<=a.length),c(f%3==0),c(e>=0);var I=a.BYTES_PER_ELEMENT==4?a:new Uint32Array(a),g=T(m.exports.meshopt_simplifySloppy,I,a.length,b,b.length/d,d*4,h,f,e);return g[0]=a instanceof Uint32Array?g[0]:new a.constructor(g[0]),g},simplifyPrune:function(a,b,d,h){c(a instanceof Uint32Array||a instanceof Int32Array||a instanceof Uint16Array||a instanceof Int16Array),c(a.length%3==0),c(b instanceof Float32Array),c(b.length%d==0),c(d>=3),c(h>=0);var f=a.BYTES_PER_ELEMENT==4?a:new Uint32Array(a),e=q(m.exports.meshopt_simplifyPrune,f,a.length,b,b.length/d,d*4,h);return e=a instanceof Uint32Array?e:new a.constructor(e),e},remesh:function(a,b,d,h,f){c(a instanceof Uint32Array||a instanceof Int32Array||a instanceof Uint16Array||a instanceof Int16Array),c(a.length%3==0),c(b instanceof Float32Array),c(b.length%d==0),c(d>=3),c(h>=4&&h<=256);for(var e=0,I=0;I<(f?f.length:0);++I)c(f[I]in B),e|=B[f[I]];var g=a.BYTES_PER_ELEMENT==4?a:new Uint32Array(a);return o(m.exports.meshopt_remesh,g,b,d*4,h,e)}}})();onmessage=async({data:{positions:E,indices:z,maxFaces:m}})=>{try{await C.ready;const[x]=C.simplify(z,E,3,3*m,1,["RegularizeLight"]);postMessage(x)}catch{postMessage(void 0)}}})();
`,Rf=typeof self<"u"&&self.Blob&&new Blob([yg],{type:"text/javascript;charset=utf-8"});function yw(n){let e;try{if(e=Rf&&(self.URL||self.webkitURL).createObjectURL(Rf),!e)throw"";const t=new Worker(e,{name:n?.name});return t.addEventListener("error",()=>{(self.URL||self.webkitURL).revokeObjectURL(e)}),t}catch{return new Worker("data:text/javascript;charset=utf-8,"+encodeURIComponent(yg),{name:n?.name})}finally{e&&(self.URL||self.webkitURL).revokeObjectURL(e)}}function xw(n,e,t){const i=new yw,a=new Promise((r,o)=>{i.onmessage=({data:c})=>r(c),i.onerror=()=>r(void 0),t.addEventListener("abort",()=>o(t.reason))}),{array:s}=n.geometry.getAttribute("position");return i.postMessage({positions:s,indices:n.arrays.indices,maxFaces:e}),a.finally(()=>i.terminate())}const Ew={keepSeams:!1};class Sw{constructor(e,t,i,a,s,r){this.connection=e,this.notice=t,this.recovery=i,this.coarseFaces=a,this.opened=s,this.simplified=r,this.input.accept=[..._g,".gz"].join(","),Gt("open",()=>this.input.click()),Gt("welcome-open",()=>this.input.click()),this.input.addEventListener("change",()=>{this.openFiles(this.input.files),this.input.value=""}),this.select.addEventListener("change",()=>{if(!this.select.value){this.select.value=this.shown;return}this.openDigest(this.select.value)}),this.listenToDrops(Ae("stage"))}connection;notice;recovery;coarseFaces;opened;simplified;input=Ae("file");select=Ae("meshes");files=new Map;restored=new Map;seams=new $A(e=>this.readAnew(e));shown="";opening=new AbortController;restoring=new AbortController;openDigest(e){this.open(t=>mg(()=>this.read(e,t),()=>this.restore(e)))}async restore(e){const t=this.files.get(e);if(!t)return!1;const i=this.restored.get(e)??this.sendAgain(e,t).finally(()=>this.restored.delete(e));return this.restored.set(e,i),await i,!0}async sendAgain(e,t){this.restoring=new AbortController;const i=await this.upload(t,this.restoring.signal,e);if(this.notice.done(),i!==e)throw new Error(`The server has lost this mesh, and ${t.file.name} holds another one by now.`)}openFiles(e){const[t,...i]=e??[];t&&this.recovery.attempt(async()=>{vg(t.name),this.openFile({file:t,joining:Ew},()=>{i.length&&this.notice.hint(`One mesh at a time is shown: ${t.name}.`)})})}openFile(e,t){this.open(async i=>{this.notice.clear();const a=await this.upload(e,i);this.files.set(a,e);const s=this.shown;await this.read(a,i),t(s),this.recovery.attempt(()=>this.list())},e.file.name)}readAnew(e){const t=this.files.get(this.shown);t&&this.openFile({...t,joining:e},i=>{this.notice.hint(i===this.shown?"It is the same mesh: this joins no other edges.":"This is another mesh. Back, in the browser, shows the one before with its sources and paths.",8e3)})}open(e,t){this.opening.abort();const{signal:i}=this.opening=new AbortController;this.recovery.attempt(async()=>{i.aborted||await e(i)},t)}async read(e,t){const i=c=>this.notice.busy("Reading the mesh",c),[a,{mesh:s}]=await Promise.all([ow(this.connection,e,i,t),this.connection.meshes.getMesh({digest:e},ei(e,t))]);this.notice.busy("Preparing the picture"),await new Promise(c=>requestAnimationFrame(()=>setTimeout(c)));const r=new bw(a,e,this.nameOf(e)),o=this.files.get(e);r.isFile=o!==void 0&&!Tf(o.joining),r.awaitsCoarse=r.faceCount>QA,this.restoring.abort(),this.notice.clear(),this.opened(r),this.seams.show(s?.notes??[],o?.joining),r.awaitsCoarse&&this.simplify(r,t),r.hasArea||this.notice.error(`${r.name}: no face has an area, so there is nothing to see.`),Ae("welcome").hidden=!0,this.shown=this.select.value=e}async simplify(e,t){this.simplified(e,await xw(e,this.coarseFaces,t).catch(()=>{}))}async list(){const{meshes:e}=await this.connection.meshes.listMeshes({pageSize:1e3}),t=e.map(i=>{const a=this.files.get(i.digest),s=[Vs(Number(i.faceCount),"face"),a?Tf(a.joining):""].filter(Boolean);return{digest:i.digest,text:`${this.nameOf(i.digest)} (${s.join(", ")})`}});this.select.replaceChildren(new Option(t.length?"on the server…":"no mesh yet",""),...t.map(({digest:i,text:a})=>new Option(a,i))),this.select.value=this.shown,Ae("welcome-meshes").replaceChildren(...t.slice(0,12).map(({digest:i,text:a})=>{const s=document.createElement("button");return s.textContent=a,s.addEventListener("click",()=>this.openDigest(i)),s}))}nameOf(e){return this.files.get(e)?.file.name??e.slice(0,8)}upload({file:e,joining:t},i,a){const s=r=>this.notice.busy(r<1?`Sending ${e.name}`:`The server reads ${e.name}`,r<1?r:void 0);return s(0),lw(this.connection,e,t,s,i,a)}listenToDrops(e){const t=document.body;t.addEventListener("dragover",i=>{i.preventDefault(),e.classList.add("over")}),t.addEventListener("dragleave",()=>e.classList.remove("over")),t.addEventListener("drop",i=>{i.preventDefault(),e.classList.remove("over"),this.openFiles(i.dataTransfer?.files??null)})}}const Mw=6e3;class Aw{element=Ae("notice");text=Ae("notice-text");bar=Ae("notice-progress");button=Ae("notice-action");errorStaysUntil=0;timer;constructor(){Ae("notice-close").addEventListener("click",()=>this.clear())}busy(e,t){performance.now()<this.errorStaysUntil||(this.put(e,"busy"),this.bar.hidden=t===void 0,t!==void 0&&(this.bar.value=t))}done(){this.element.dataset.kind==="busy"&&this.clear()}error(e,t){this.errorStaysUntil=performance.now()+Mw,this.put(e,"error"),t&&(this.button.textContent=t.label,this.button.onclick=()=>t.run(),this.button.hidden=!1)}hint(e,t=4e3){this.put(e,"hint"),this.timer=setTimeout(()=>this.clear(),t)}clear(){this.errorStaysUntil=0,this.element.hidden=!0}put(e,t){clearTimeout(this.timer),this.text.textContent=e,this.element.dataset.kind=t,this.element.hidden=!1,this.bar.hidden=!0,this.button.hidden=!0}}const Nc=3;function Jl(n){switch(n.kind){case"vertex":return`vertex ${n.vertex}`;case"edge":return`a point on edge ${n.from}-${n.to}`;case"face":return`a point in face ${n.face}`}}function ww(n,e){const t=e.slice(0,Nc).map(i=>"curve"in i?`a curve of ${i.curve.length} points`:`${Jl(i)} (${n.positionOf(i).map(a=>$t(a,4)).join(", ")})`);return e.length>Nc&&t.push(`${e.length-Nc} more`),e.length===1?t[0]:`the nearest of ${e.length} sources: ${t.join(", ")}`}const Cf="in the unit of the file",Rc=20,Uf=12,Pf=17,Tw="12px system-ui, sans-serif";class Iw{constructor(e,t,i){this.explorer=e,this.scene=t,this.methods=i}explorer;scene;methods;box=Ae("legend");lines=[];update(){const{mesh:e,field:t,paths:i}=this.explorer;this.lines=e&&t?this.describe(e,t):[];const a=i.filter(mo).length,s=i.length-a;e&&s&&this.lines.push(`orange: ${Vs(s,"exact shortest path")}, with the length`),e&&a&&this.lines.push(`pink: ${Vs(a,"line")} straight on, with the length`),this.box.textContent=this.lines.join(`
`)}drawOn(e,t){e.save(),e.scale(t,t);const i=getComputedStyle(document.documentElement);e.font=Tw,e.textBaseline="top",e.lineJoin="round",e.lineWidth=4,e.strokeStyle=i.getPropertyValue("--background"),e.fillStyle=i.getPropertyValue("--text");const a=e.canvas.width/t-2*Rc;this.lines.flatMap(s=>Nw(e,s,a)).forEach((s,r)=>{e.strokeText(s,Rc,Uf+r*Pf),e.fillText(s,Rc,Uf+r*Pf)}),e.restore()}describe(e,t){const i=ww(e,this.explorer.fields.sources),a=this.methods.nameOf(this.explorer.fields.algorithm),s=[];switch(t.painted){case"distances":s.push(`${e.name}: distance from ${i}`,`${this.accuracy(t)} (${a}), ${Cf}`);break;case"cells":s.push(`${e.name}: colours tell which source is nearest, darker is farther: ${i}`,`${this.accuracy(t)} (${a})`);break;case"difference":s.push(...this.describeDifference(e,t,a,i));break}const{step:r}=Bd(t.largest);this.scene.material.uniforms.showLines.value&&r>0&&s.push(`lines: ${t.painted==="difference"?`distances of ${a}`:"distances"}, every ${$t(r,6)}`);const{radius:o}=this.explorer;return o!==void 0&&s.push(`up to ${$t(o,4)}; what is farther is grey`),s}describeDifference(e,t,i,a){const{difference:s}=t;if(!s)return[];const{against:r}=this.explorer.fields,o=this.methods.nameOf(r),[c,l]=s.range.map(d=>$t(d,3)),u=this.methods.isApproximate(r)?"approximate":"exact",h=[`${e.name}: how far ${o} (${u}) is from ${i} (${this.accuracy(t)}), without sign, ${Cf}`,`${o} − ${i} is from ${c} to ${l}`,`both: distance from ${a}`];return s.oneSided&&h.push(`grey: ${go(s.oneSided)} of the vertices have a distance in one of them only`),h}accuracy(e){return e.isPreview?fg:this.explorer.summary?"exact":"exact, still on its way: grey is not known yet"}}function Nw(n,e,t){const i=[];for(const a of e.split(" ")){const s=i.length?`${i.at(-1)} ${a}`:a;i.length&&n.measureText(s).width<=t?i[i.length-1]=s:i.push(a)}return i}const Lf=0;class Rw{algorithm=Ae("algorithm");compared=Ae("against");exact=[];approximate=[];constructor(e){this.algorithm.addEventListener("change",()=>e(Number(this.algorithm.value)))}show({algorithms:e,approximateAlgorithms:t}){this.exact=e,this.approximate=t;const i=this.algorithm.value;this.algorithm.replaceChildren(new Option("the server's choice",String(Lf)),...e.map(xg)),i&&(this.algorithm.value=i),this.compared.replaceChildren(Df("exact",e),Df("approximate",t));const a=t[0]??e[1];a&&(this.compared.value=String(a.algorithm)),Ae("compare-row").hidden=e.length+t.length<2}get against(){return Number(this.compared.value)}isApproximate(e){return this.approximate.some(t=>t.algorithm===e)}nameOf(e){const t=[...this.exact,...this.approximate],i=a=>a.algorithm===e||e===Lf&&a.isDefault;return t.find(i)?.name??"the server's choice"}}function Df(n,e){const t=document.createElement("optgroup");return t.label=n,t.hidden=e.length===0,t.append(...e.map(xg)),t}function xg({algorithm:n,name:e,summary:t}){const i=new Option(e,String(n));return i.title=t,i}class Cw{constructor(e){this.remove=e}remove;list=Ae("paths");show(e){Ae("paths-section").hidden=e.length===0,this.list.replaceChildren(...e.map(t=>this.item(t)))}item(e){const t=zs("li",$t(e.length,10)),i=document.createElement("button");return i.textContent="×",i.setAttribute("aria-label",`Remove this ${mo(e)?"line":"path"}`),i.addEventListener("click",()=>this.remove(e)),t.append(i,zs("small",Uw(e))),t}}function Uw({question:n,ended:e}){const t=`from ${Jl(n.from)}`;if("target"in n)return`${t} to ${Jl(n.target)}`;switch(e){case"boundary":return`${t} straight on, up to the boundary`;case"singular":return`${t} straight on, up to where there is no straight on`;default:return`${t} straight on`}}function Cc(n,e){const t=e instanceof Blob?e:new Blob(e),i=document.createElement("a");i.href=URL.createObjectURL(t),i.download=n,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),6e4)}function Uc(n){return n.replace(/\.[^.]*$/,"")||"mesh"}function Pw(n){const e=`{'descr': '<f8', 'fortran_order': False, 'shape': (${n.length},), }`,t=e.padEnd(Math.ceil((e.length+11)/64)*64-11)+`
`,i=new Uint8Array(10+t.length);return i.set([147,...Of("NUMPY"),1,0,t.length&255,t.length>>8]),i.set(Of(t),10),[i,n]}function Lw(n){const e=["vertex,geodesic_distance"];return n.forEach((t,i)=>e.push(`${i},${Ow(t)}`)),[e.join(`
`),`
`]}function Dw(n,e){const t=n.indices.length/3,i=["ply","format binary_little_endian 1.0",`element vertex ${e.length}`,...["x","y","z","geodesic_distance"].map(r=>`property double ${r}`),`element face ${t}`,"property list uchar int vertex_indices","end_header"],a=new Float64Array(4*e.length);for(let r=0;r<e.length;r++)a.set(n.positions.subarray(3*r,3*r+3),4*r),a[4*r+3]=e[r];const s=new DataView(new ArrayBuffer(13*t));for(let r=0;r<t;r++){s.setUint8(13*r,3);for(let o=0;o<3;o++)s.setUint32(13*r+1+4*o,n.indices[3*r+o],!0)}return[i.join(`
`)+`
`,a,s]}function Ow(n){return n===1/0?"inf":String(n)}function Of(n){return new TextEncoder().encode(n)}function Fw(n){const e=[];let t=1;return n.forEach((i,a)=>{const s=i.positions.length/3;e.push(`g path_${a}`);for(let r=0;r<s;r++)e.push(`v ${i.positions.subarray(3*r,3*r+3).join(" ")}`);e.push(`l ${Array.from({length:s},(r,o)=>t+o).join(" ")}`),t+=s}),[e.join(`
`),`
`]}function kw(n,e,t,i){const a=n.takePicture(),s=a.getContext("2d");s&&e&&e.scaleEnd>0&&Bw(s,e,a.height);for(const r of[t,i])s&&r.drawOn(s,n.pixelRatio.value);return new Promise((r,o)=>a.toBlob(c=>c?r(c):o(new Error("The picture could not be made.")),"image/png"))}function Bw(n,e,t){const i=t/700,a={left:24*i,top:.28*t,width:14*i,height:.44*t};for(let s=0;s<a.height;s++)n.fillStyle=Om(1-s/a.height),n.fillRect(a.left,a.top+s,a.width,1);n.font=`${13*i}px system-ui, sans-serif`,n.textBaseline="middle",n.fillStyle=getComputedStyle(document.documentElement).getPropertyValue("--text");for(const{at:s,text:r}of Fm(e.scaleEnd)){const o=a.top+a.height*(1-s/e.scaleEnd);n.fillText(r,a.left+a.width+8*i,o)}}function Vw(n){const e=n.sources.map(u=>"curve"in u?`--curve '${Ka(u)}'`:`--source ${Ka(u)}`),t=n.server?`geodesic --server ${n.server}`:"geodesic",i=Gw(n.mesh),a=n.algorithm?[`--algorithm ${n.algorithm}`]:[],s=n.radius===void 0?[]:[`--radius ${n.radius}`],r=e.length?[[t,"field",i,...e,...s,...a,"-o field.npy"]]:[],o=new Map,{paths:c,straight:l}=Eg(n.lines);for(const{from:u,target:h}of c){const d=`--source ${Ha(u)}`;o.set(d,[...o.get(d)??[],`--target ${Ha(h)}`])}return[...o].forEach(([u,h],d)=>{r.push([t,"path",i,u,...h,...a,`-o ${Ff("paths",d)}.obj`])}),l.forEach(({from:u,direction:h,length:d},f)=>{const g=[`--source ${Ha(u)}`,`--direction ${h.join(",")}`,`--length ${d}`];r.push([t,"trace",i,...g,`-o ${Ff("line",f)}.obj`])}),r.map(u=>u.join(" ")).join(`
`)}function zw(n){const e=n.sources.map(l=>"curve"in l?`geodesic.Curve([${l.curve.map(us).join(", ")}])`:us(l)),t=e.length===1?e[0]:`[${e.join(", ")}]`,i=n.radius===void 0?"":`, radius=${n.radius}`,a=n.algorithm?`, algorithm="${n.algorithm}"`:"",s=["import geodesic","",n.server?`mesh = geodesic.connect(${JSON.stringify(n.server)}).open(${JSON.stringify(n.mesh)})`:`mesh = geodesic.Mesh(${JSON.stringify(n.mesh)})`];e.length&&s.push(`d = mesh.distances(${t}${i}${a})`);const{paths:r,straight:o}=Eg(n.lines),c=r.map(({from:l,target:u})=>`mesh.path(${us(l)}, ${us(u)}${a})`);return s.push(...kf("path",c)),s.push(...kf("line",o.map(({from:l,direction:u,length:h})=>`mesh.trace(${us(l)}, direction=[${u.join(", ")}], length=${h})`))),s.join(`
`)}function Eg(n){return{paths:n.filter(e=>"target"in e),straight:n.filter(e=>"direction"in e)}}function Ff(n,e){return e?`${n}-${e+1}`:n}function kf(n,e){return e.length<2?e.map(t=>`${n} = ${t}`):[`${n}s = [`,...e.map(t=>`    ${t},`),"]"]}function Gw(n){const e=n.startsWith("-")?`./${n}`:n;return/^[\w./-]+$/.test(e)?e:`'${e.replaceAll("'","'\\''")}'`}class Ww{constructor(e,t,i,a,s,r){this.explorer=e,this.scene=t,this.notice=i,this.labels=a,this.legend=s,this.algorithmName=r,Gt("save-picture",()=>{this.savePicture()}),Gt("save-npy",()=>this.saveField("npy",Pw)),Gt("save-csv",()=>this.saveField("csv",Lw)),Gt("save-ply",()=>this.saveField("ply",o=>e.mesh?Dw(e.mesh.arrays,o):[])),Gt("save-paths",()=>this.savePaths()),Gt("copy-command",()=>this.copy(Vw)),Gt("copy-python",()=>this.copy(zw))}explorer;scene;notice;labels;legend;algorithmName;text=Ae("question-text");write;update(){const e=this.question();this.text.hidden=!e||!this.write,e&&this.write&&(this.text.textContent=this.write(e))}async savePicture(){const{mesh:e,field:t}=this.explorer;e&&Cc(`${Uc(e.name)}.png`,await kw(this.scene,t,this.labels,this.legend))}saveField(e,t){const{mesh:i,exactField:a,fields:s,summary:r,radius:o}=this.explorer;if(!i||!a){this.notice.hint(s.isWaiting||r?"The exact field is still on its way.":"There is no field yet: click a point of the surface.");return}const c=o??1/0,l=a.distances.map(u=>u<=c?u:1/0);Cc(`${Uc(i.name)}-field.${e}`,t(l))}savePaths(){const{mesh:e,paths:t}=this.explorer;if(!e||!t.length){this.notice.hint("There is no path yet: click where one should end.");return}Cc(`${Uc(e.name)}-paths.obj`,Fw(t))}copy(e){const t=this.question();if(!t){this.notice.hint("There is no question yet: click a point of the surface.");return}this.write=e,this.update();const i=t.server?" For PORT put the one of the server's --listen.":"";navigator.clipboard?.writeText(e(t)).then(()=>this.notice.hint(`Copied.${i}`),()=>this.notice.hint(`Select the text and copy it.${i}`))}question(){const{mesh:e,sources:t,radius:i,paths:a}=this.explorer;if(!(!e||!t.length&&!a.length))return{mesh:e.isFile?e.name:e.digest,server:e.isFile?void 0:`${location.hostname}:PORT`,sources:t,radius:i,algorithm:this.algorithmName(),lines:a.map(s=>s.question)}}}class Hw{constructor(e){this.element=e;const t=document.createElement("canvas");t.className="scale-colors",t.width=1,t.height=128;const i=t.getContext("2d");for(let a=0;i&&a<128;a++)i.fillStyle=Om(1-a/127),i.fillRect(0,a,1,1);this.ticks.className="scale-ticks",this.mark.className="scale-mark",this.mark.hidden=!0,this.element.append(t,this.ticks,this.mark)}element;ticks=document.createElement("div");mark=document.createElement("div");largest=0;show(e){this.largest=e,this.element.hidden=!(e>0),this.ticks.replaceChildren(...Fm(e).map(({at:t,text:i})=>{const a=document.createElement("span");return a.textContent=i,a.style.bottom=`${100*t/e}%`,a}))}point(e){const t=e!==void 0&&Number.isFinite(e)&&this.largest>0;this.mark.hidden=!t,t&&(this.mark.style.bottom=`${Math.min(100*e/this.largest,100)}%`)}}const Tr=1e3,Bf="There is no field yet: click a point of the surface.";class jw{constructor(e,t,i,a,s,r){this.explorer=e,this.scene=t,this.connection=i,this.notice=a,this.theme=s,this.methods=new Rw(o=>{e.fields.algorithm=o,e.askField()}),this.legend=new Iw(e,t,this.methods),this.save=new Ww(e,t,a,r,this.legend,()=>this.algorithmName()),this.paths=new Cw(o=>e.removePath(o)),Gt("theme",()=>s.toggle()),Gt("help",()=>this.help()),Gt("undo",()=>this.undo()),Gt("redo",()=>this.redo()),Gt("clear",()=>this.clear()),Gt("sample",()=>{const o=Ae("sample-count");o.reportValidity()&&(e.sources.length?e.sample(o.valueAsNumber):a.hint(Bf))}),Gt("compare",()=>{this.compare()}),this.isolines.addEventListener("change",()=>this.showIsolines()),this.cells.addEventListener("change",()=>e.fields.showCells(e.mesh,this.cells.checked)),this.radius.addEventListener("input",()=>{const o=this.radius.valueAsNumber/Tr,c=this.widestRadius();this.setRadius(o<1&&c>0?o*c:1/0)});for(const o of this.tools())o.addEventListener("change",()=>this.update())}explorer;scene;connection;notice;theme;scale=new Hw(Ae("scale"));valueBox=Ae("value");radius=Ae("radius");isolines=Ae("isolines");cells=Ae("cells");undoButton=Ae("undo");redoButton=Ae("redo");clearButton=Ae("clear");methods;legend;save;paths;get tool(){return this.tools().find(e=>e.checked)?.value}choose(e){for(const t of this.tools())t.checked=t.value===e;this.update()}async showCapabilities(){this.methods.show(await this.connection.capabilities.getCapabilities({})),this.legend.update()}show(e){Ae("mesh-name").textContent=e.name,Ae("mesh-name").title=e.digest,Ae("questions").hidden=!1,document.title=`${e.name} - geodesic`}chooseNext(){this.choose(this.explorer.sources.length?"path":"source")}update(){const{field:e,fields:t,sources:i,summary:a,paths:s,samples:r}=this.explorer;this.showSize(),Ae("source-count").textContent=Vs(i.length,"source"),Ae("next-step").textContent=this.nextStep(),Ae("cells-choice").hidden=i.length<2,this.cells.checked=t.showsCells,this.undoButton.disabled=!this.explorer.canUndo,this.redoButton.disabled=!this.explorer.canRedo,this.clearButton.disabled=this.explorer.isEmpty,e?.painted!=="difference"&&Ae("difference").replaceChildren(),this.scale.show(e?.scaleEnd??0);const o=[];e?.isPreview&&(o.push([Vf(this.explorer.radius??1/0),`≈ ${$t(e.largest,4)}`]),o.push(["for now",fg+(t.isWaiting?"; the exact field is on its way":"")])),e&&a&&(o.push([Vf(a.settledRadius),$t(e.largest,10)]),o.push(["solved in",`${$t(1e3*a.solveSeconds,3)} ms`]),r.length&&o.push(["samples",go(r.length)])),zf(Ae("figures"),o),this.paths.show(s),this.showRadius(),this.legend.update(),this.save.update()}pointer(e){const t=Ae("stage").getBoundingClientRect();this.valueBox.style.setProperty("--x",`${e.x-t.left}px`),this.valueBox.style.setProperty("--y",`${e.y-t.top}px`)}value(e,t){this.valueBox.hidden=e===void 0,this.scale.point(this.explorer.field?.painted==="distances"?e:void 0),e!==void 0&&(this.valueBox.textContent=e===1/0?"not reached":t?$t(e,8):`≈ ${$t(e,4)}`,this.valueBox.dataset.exact=String(t))}setRadius(e){const{field:t,summary:i}=this.explorer,a=i?.settledRadius===1/0&&e>=(t?.largest??0);this.explorer.setRadius(a||e===1/0?void 0:Math.max(e,0))}clear(){this.explorer.clear(),this.choose("source")}undo(){this.explorer.undo(),this.chooseAgain()}redo(){this.explorer.redo(),this.chooseAgain()}toggleIsolines(){this.isolines.checked=!this.isolines.checked,this.showIsolines()}toggleTheme(){this.theme.toggle()}help(){Ae("help-dialog").showModal()}chooseAgain(){this.tool==="straight"&&this.explorer.sources.length?this.update():this.chooseNext()}async compare(){if(!this.explorer.exactField){this.notice.hint(this.explorer.fields.isWaiting?"The exact field is still on its way.":Bf);return}const e=this.methods.against;Ae("difference").replaceChildren(zs("dt","Comparing…"));const t=await this.explorer.compare(e,this.methods.isApproximate(e));if(!t){Ae("difference").replaceChildren();return}zf(Ae("difference"),[["largest difference",$t(t.largest,3)],["mean, relative",$t(t.meanRelative,3)]])}showIsolines(){this.scene.material.uniforms.showLines.value=this.isolines.checked,this.legend.update(),this.scene.redrawSurface()}showSize(){const{mesh:e}=this.explorer;if(!e)return;const t=Vs(e.faceCount,"face"),i=e.coarse?.index?go(e.coarse.index.count/3):void 0,a=this.scene.mayBeWhole(e)?" while it moves":"";Ae("mesh-size").textContent=i?`${t}, ${i} drawn${a}`:t,Ae("mesh-size").title=i?"Drawn with fewer faces over the same vertices. All answers are the whole mesh's.":""}showRadius(){const{radius:e}=this.explorer;Ae("radius-value").textContent=e===void 0?"all":$t(e,4);const t=e?e/this.widestRadius():0;this.radius.value=String(e===void 0?Tr:Math.min(Math.round(t*Tr),Tr-1))}widestRadius(){const{field:e,radius:t}=this.explorer;return Math.max(e?.largest??0,t??0)}nextStep(){return this.tool==="curve"?"Drag on the surface: every point of the curve is a source.":this.explorer.sources.length?this.tool==="straight"?this.explorer.straightLength===void 0?"Lines are as long as the slider says, or as the farthest distance: there is no such length yet.":"Drag from a source's dot: the line runs straight on in that direction. Click to move the source.":this.tool==="source"?"Click to move the source; Shift and click for one more.":"Move: the shortest path follows. Click to keep it; Shift and click for one more source.":"Click a point of the surface."}algorithmName(){const{algorithm:e}=this.explorer.fields;return e===0?void 0:this.methods.nameOf(e)}tools(){return[...document.querySelectorAll('input[name="tool"]')]}}function Vf(n){return n===1/0?"farthest":`farthest up to ${$t(n,4)}`}function zf(n,e){n.replaceChildren(...e.flatMap(([t,i])=>[zs("dt",t),zs("dd",i)]))}const Gf={x:12,y:-12};class Xw{constructor(e,t,i){this.explorer=e,this.scene=t,this.isSeen=i}explorer;scene;isSeen;box=Ae("labels");labels=[];update(){const e=this.explorer.pathEnds().filter(({point:t})=>this.isSeen(t));this.labels=e.map(({point:t,length:i})=>{const{x:a,y:s}=this.scene.pixelOf(t);return{text:$t(i,6),x:a+Gf.x,y:s+Gf.y}}),this.box.replaceChildren(...this.labels.map(({text:t,x:i,y:a})=>{const s=document.createElement("span");return s.textContent=t,s.style.left=`${i}px`,s.style.top=`${a}px`,s}))}drawOn(e,t){const i=getComputedStyle(document.documentElement);e.font=`${13*t}px system-ui, sans-serif`,e.textBaseline="middle",e.lineJoin="round",e.lineWidth=4*t,e.strokeStyle=i.getPropertyValue("--background"),e.fillStyle=i.getPropertyValue("--text");for(const{text:a,x:s,y:r}of this.labels)e.strokeText(a,t*s,t*r),e.fillText(a,t*s,t*r)}}class Yw{dialog=Ae("token-dialog");input=Ae("token");declined=!1;constructor(e){this.dialog.addEventListener("submit",t=>{t.submitter?.value==="ok"&&this.input.value?e(this.input.value.trim()):this.declined=!0}),this.dialog.addEventListener("cancel",()=>this.declined=!0)}get wasDeclined(){return this.declined}close(){this.declined=!1,this.dialog.close()}open(e){this.declined=!1,Ae("token-reason").textContent=e,this.input.value="",this.dialog.open||this.dialog.showModal()}}const Zw=500,Kw=5e3,Jw=250,qw=1e4,$w="Whoever runs this server gives tokens to those who may ask it.";class Qw{constructor(e,t,i){this.connection=e,this.notice=t,this.dialog=new Yw(a=>{i(a),this.goOnWith(a)})}connection;notice;questions=new Set;waiting=!1;dialog;goOnWith(e){this.connection.token=e,this.dialog.close(),this.resume()}async attempt(e,t){try{await e()}catch(i){const a=ea(i),s=t?`${t}: `:"";a==="full"||a==="refused"?this.notice.error(s+fs(i)):this.handle(i,()=>{this.attempt(e,t)})}}handle(e,t){switch(ea(e)){case"cancelled":return;case"token":this.questions.add(t),this.askForToken(this.connection.token?fs(e):$w);return;case"gone":this.questions.add(t),this.waitForServer();return;case"forgotten":this.notice.error(`${fs(e)} Drop its file here again.`);return;case"full":this.waitForRoom(e,t);return;default:this.notice.error(fs(e))}}askForToken(e){const t=()=>this.dialog.open(e);this.notice.error(e,{label:"Enter a token",run:t}),this.dialog.wasDeclined||t()}waitForRoom(e,t){const i=Math.max(pg(e)??0,Jw);if(i>qw){this.notice.error(fs(e));return}this.notice.hint("The server has much to do. This page asks again.",2*i),setTimeout(t,i)}async waitForServer(){if(this.notice.error("The server does not answer. This page goes on when it is back."),!this.waiting){this.waiting=!0;for(let e=Zw;;e=Math.min(2*e,Kw)){await new Promise(t=>setTimeout(t,e));try{await this.connection.capabilities.getCapabilities({});break}catch(t){if(ea(t)!=="gone")break}}this.waiting=!1,this.notice.hint("The server is back.",2e3),this.resume()}}resume(){const e=[...this.questions];this.questions.clear(),this.notice.clear();for(const t of e)t()}}const Sg="geodesic.theme";class eT{constructor(e){this.changed=e,this.system.addEventListener("change",()=>this.apply()),this.apply()}changed;system=matchMedia("(prefers-color-scheme: dark)");chosen=tT();toggle(){this.chosen=this.isDark()?"light":"dark";try{localStorage.setItem(Sg,this.chosen)}catch{}this.apply()}isDark(){return this.chosen?this.chosen==="dark":this.system.matches}apply(){const e=this.isDark();document.documentElement.dataset.theme=e?"dark":"light";const t=getComputedStyle(document.documentElement).getPropertyValue("--background").trim();this.changed(e,t)}}function tT(){try{return localStorage.getItem(Sg)}catch{return null}}const Wf={type:"change"},Yd={type:"start"},Mg={type:"end"},Ir=new Ws,Hf=new Xn,nT=Math.cos(70*Dp.DEG2RAD),Nt=new U,nn=2*Math.PI,st={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Pc=1e-6;class iT extends x0{constructor(e,t=null){super(e,t),this.state=st.NONE,this.target=new U,this.cursor=new U,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Va.ROTATE,MIDDLE:Va.DOLLY,RIGHT:Va.PAN},this.touches={ONE:ka.ROTATE,TWO:ka.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new U,this._lastQuaternion=new Di,this._lastTargetPosition=new U,this._quat=new Di().setFromUnitVectors(e.up,new U(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Vu,this._sphericalDelta=new Vu,this._scale=1,this._panOffset=new U,this._rotateStart=new we,this._rotateEnd=new we,this._rotateDelta=new we,this._panStart=new we,this._panEnd=new we,this._panDelta=new we,this._dollyStart=new we,this._dollyEnd=new we,this._dollyDelta=new we,this._dollyDirection=new U,this._mouse=new we,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=sT.bind(this),this._onPointerDown=aT.bind(this),this._onPointerUp=rT.bind(this),this._onContextMenu=fT.bind(this),this._onMouseWheel=lT.bind(this),this._onKeyDown=dT.bind(this),this._onTouchStart=uT.bind(this),this._onTouchMove=hT.bind(this),this._onMouseDown=oT.bind(this),this._onMouseMove=cT.bind(this),this._interceptControlDown=pT.bind(this),this._interceptControlUp=mT.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction=""}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Wf),this.update(),this.state=st.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){const t=this.object.position;Nt.copy(t).sub(this.target),Nt.applyQuaternion(this._quat),this._spherical.setFromVector3(Nt),this.autoRotate&&this.state===st.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,a=this.maxAzimuthAngle;isFinite(i)&&isFinite(a)&&(i<-Math.PI?i+=nn:i>Math.PI&&(i-=nn),a<-Math.PI?a+=nn:a>Math.PI&&(a-=nn),i<=a?this._spherical.theta=Math.max(i,Math.min(a,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+a)/2?Math.max(i,this._spherical.theta):Math.min(a,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const r=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=r!=this._spherical.radius}if(Nt.setFromSpherical(this._spherical),Nt.applyQuaternion(this._quatInverse),t.copy(this.target).add(Nt),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let r=null;if(this.object.isPerspectiveCamera){const o=Nt.length();r=this._clampDistance(o*this._scale);const c=o-r;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),s=!!c}else if(this.object.isOrthographicCamera){const o=new U(this._mouse.x,this._mouse.y,0);o.unproject(this.object);const c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=c!==this.object.zoom;const l=new U(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(o),this.object.updateMatrixWorld(),r=Nt.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;r!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(r).add(this.object.position):(Ir.origin.copy(this.object.position),Ir.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ir.direction))<nT?this.object.lookAt(this.target):(Hf.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ir.intersectPlane(Hf,this.target))))}else if(this.object.isOrthographicCamera){const r=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),r!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>Pc||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Pc||this._lastTargetPosition.distanceToSquared(this.target)>Pc?(this.dispatchEvent(Wf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?nn/60*this.autoRotateSpeed*e:nn/60/60*this.autoRotateSpeed}_getZoomScale(e){const t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Nt.setFromMatrixColumn(t,0),Nt.multiplyScalar(-e),this._panOffset.add(Nt)}_panUp(e,t){this.screenSpacePanning===!0?Nt.setFromMatrixColumn(t,1):(Nt.setFromMatrixColumn(t,0),Nt.crossVectors(this.object.up,Nt)),Nt.multiplyScalar(e),this._panOffset.add(Nt)}_pan(e,t){const i=this.domElement;if(this.object.isPerspectiveCamera){const a=this.object.position;Nt.copy(a).sub(this.target);let s=Nt.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*s/i.clientHeight,this.object.matrix),this._panUp(2*t*s/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const i=this.domElement.getBoundingClientRect(),a=e-i.left,s=t-i.top,r=i.width,o=i.height;this._mouse.x=a/r*2-1,this._mouse.y=-(s/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(nn*this._rotateDelta.x/t.clientHeight),this._rotateUp(nn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),a=.5*(e.pageY+t.y);this._rotateStart.set(i,a)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),a=.5*(e.pageY+t.y);this._panStart.set(i,a)}}_handleTouchStartDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,a=e.pageY-t.y,s=Math.sqrt(i*i+a*a);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{const i=this._getSecondPointerPosition(e),a=.5*(e.pageX+i.x),s=.5*(e.pageY+i.y);this._rotateEnd.set(a,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(nn*this._rotateDelta.x/t.clientHeight),this._rotateUp(nn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),a=.5*(e.pageY+t.y);this._panEnd.set(i,a)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,a=e.pageY-t.y,s=Math.sqrt(i*i+a*a);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const r=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(r,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new we,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){const t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){const t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}}function aT(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function sT(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function rT(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Mg),this.state=st.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:const e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function oT(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Va.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=st.DOLLY;break;case Va.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=st.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=st.ROTATE}break;case Va.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=st.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=st.PAN}break;default:this.state=st.NONE}this.state!==st.NONE&&this.dispatchEvent(Yd)}function cT(n){switch(this.state){case st.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case st.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case st.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function lT(n){this.enabled===!1||this.enableZoom===!1||this.state!==st.NONE||(n.preventDefault(),this.dispatchEvent(Yd),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Mg))}function dT(n){this.enabled!==!1&&this._handleKeyDown(n)}function uT(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ka.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=st.TOUCH_ROTATE;break;case ka.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=st.TOUCH_PAN;break;default:this.state=st.NONE}break;case 2:switch(this.touches.TWO){case ka.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=st.TOUCH_DOLLY_PAN;break;case ka.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=st.TOUCH_DOLLY_ROTATE;break;default:this.state=st.NONE}break;default:this.state=st.NONE}this.state!==st.NONE&&this.dispatchEvent(Yd)}function hT(n){switch(this._trackPointer(n),this.state){case st.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case st.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case st.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case st.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=st.NONE}}function fT(n){this.enabled!==!1&&n.preventDefault()}function pT(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function mT(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}const gT=`
attribute float geodesic;  // Below 0 where it is not known or no path leads.
attribute vec3 paint;
uniform vec3 reference;
uniform float setBack;
varying vec3 vPoint;
varying vec3 vView;
varying vec3 vNormal;
varying vec3 vPaint;
varying float vDistance;
varying float vSquare;
varying float vReached;
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  float d = max(geodesic, 0.0);
  vPoint = position - reference;
  vView = view.xyz;
  vNormal = normalMatrix * normal;
  vPaint = paint;
  vDistance = d;
  vSquare = d * d - dot(vPoint, vPoint);
  vReached = geodesic < 0.0 ? 0.0 : 1.0;
  gl_Position = projectionMatrix * view;
  // Depths are those of a surface a little farther away.
  vec4 back = projectionMatrix * (view - vec4(0.0, 0.0, setBack, 0.0));
  gl_Position.z = back.z / back.w * gl_Position.w;
}`,bT=`
uniform sampler2D colors;
uniform bool quadratic;
uniform bool painted;
uniform float shade;
uniform bool showLines;
uniform float largest;
uniform float lineStep;
uniform float linesPerLabel;
uniform float lineWidth;
uniform float front;
uniform float glow;
uniform float radius;
uniform vec3 bare;
varying vec3 vPoint;
varying vec3 vView;
varying vec3 vNormal;
varying vec3 vPaint;
varying float vDistance;
varying float vSquare;
varying float vReached;

// Coverage by the lines at multiples of a step; t is the distance in steps.
float lines(float t, float perPixel, float width) {
  float off = abs(t - max(round(t), 1.0)) / perPixel;
  float inside = clamp(0.5 * width - off + 0.5, 0.0, 1.0);
  return inside * smoothstep(2.0 * width, 4.0 * width, 1.0 / perPixel);
}

void main() {
  vec3 flatNormal = normalize(cross(dFdx(vView), dFdy(vView)));
  vec3 smoothNormal = normalize(vNormal + 1e-6 * flatNormal);
  // Faces may be turned either way: what is seen is lit.
  if (dot(smoothNormal, flatNormal) < 0.0) smoothNormal = -smoothNormal;
  vec3 n = normalize(mix(flatNormal, smoothNormal,
                         smoothstep(0.75, 0.9, dot(smoothNormal, flatNormal))));
  float light = 0.58 + 0.42 * max(dot(n, normalize(vec3(-0.35, 0.5, 0.8))), 0.0)
      + 0.08 * max(dot(n, vec3(0.0, 0.0, 1.0)), 0.0);

  float d = vDistance;
  if (quadratic) d = sqrt(max(vSquare + dot(vPoint, vPoint), 0.0));
  float perPixel = max(fwidth(d), 1e-9);
  bool reached = vReached > 0.9999;
  vec3 color = bare;
  if (reached && d <= front && d <= radius) {
    float share = clamp(d / largest, 0.0, 1.0);
    color = texture2D(colors, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    if (painted) color = vPaint * (1.0 - shade * share);
    if (showLines && lineStep > 0.0) {
      float t = d / lineStep;
      float coverage = max(0.7 * lines(t, perPixel / lineStep, lineWidth),
          lines(t / linesPerLabel, perPixel / (lineStep * linesPerLabel), 1.6 * lineWidth));
      float luminance = dot(color, vec3(0.299, 0.587, 0.114));
      vec3 ink = luminance > 0.36 ? color * 0.22 : mix(color, vec3(1.0), 0.62);
      color = mix(color, ink, coverage);
    }
    color = mix(color, vec3(1.0), glow * exp((d - front) / (0.025 * largest)));
  }
  if (reached && radius < 1e9 && abs(d - radius) < 1.2 * lineWidth * perPixel) color *= 0.35;
  gl_FragColor = vec4(color * light, 1.0);
}`,Lc={light:new Ze(.74,.75,.77),dark:new Ze(.5,.51,.54)};class _T extends on{constructor(){const e=new zp(ws,Wa,1,En);e.minFilter=e.magFilter=Ht,e.needsUpdate=!0,super({vertexShader:gT,fragmentShader:bT,side:yn,polygonOffset:!0,polygonOffsetFactor:1.5,polygonOffsetUnits:8,uniforms:{colors:{value:e},reference:{value:new U},setBack:{value:0},quadratic:{value:!0},painted:{value:!1},shade:{value:0},showLines:{value:!0},largest:{value:1},lineStep:{value:0},linesPerLabel:{value:5},lineWidth:{value:1},front:{value:1/0},glow:{value:0},radius:{value:1e10},bare:{value:Lc.light}}})}setDark(e){this.uniforms.bare.value=e?Lc.dark:Lc.light}}function vT(n){const[e,t,i]=[0,1,2].map(a=>Ag(n,a));return i.size<.4*Math.min(e.size,t.size)||Yf(2,n)&&!Yf(1,n)?"z":"y"}function yT(n){const e=vT(n),t=(e==="z"?38:16)*Math.PI/180;return Array.from({length:8},(a,s)=>{const r=(30+45*s)*Math.PI/180,o=new U(Math.sin(r),0,Math.cos(r)).multiplyScalar(Math.cos(t));return e==="y"?Xf(o.setY(Math.sin(t)),new U(0,1,0),n):Xf(new U(o.x,-o.z,Math.sin(t)),new U(0,0,1),n)}).reduce((a,s)=>jf(s)>1.01*jf(a)?s:a)}function jf({halfSize:n}){return n.x*n.y}function Xf(n,e,t){const i=e.clone().cross(n).normalize(),a=n.clone().cross(i),s=new we,r=3*Math.ceil(t.length/15e3);for(let o=0;o<t.length;o+=r){const c=new U(t[o],t[o+1],t[o+2]);s.x=Math.max(s.x,Math.abs(c.dot(i))),s.y=Math.max(s.y,Math.abs(c.dot(a)))}return{up:e,direction:n,halfSize:s}}function Ag(n,e){let t=1/0,i=-1/0;for(let a=e;a<n.length;a+=3)t=Math.min(t,n[a]),i=Math.max(i,n[a]);return{low:t,size:i-t}}function Yf(n,e){const{low:t,size:i}=Ag(e,n),a=t+.03*i;return[(n+1)%3,(n+2)%3].every(s=>{let r=0,o=1/0,c=-1/0;for(let u=0;u<e.length;u+=3)r+=e[u+s],!(e[u+n]>a)&&(o=Math.min(o,e[u+s]),c=Math.max(c,e[u+s]));const l=3*r/e.length;return l>=o&&l<=c})}const xT=`
varying vec2 vUv;
void main() { vUv = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }`,ET=`
uniform sampler2D colors;
uniform sampler2D depths;
varying vec2 vUv;
void main() {
  gl_FragColor = vec4(texture2D(colors, vUv).rgb, 1.0);
  gl_FragDepth = texture2D(depths, vUv).r;
}`,Zf=32,Kf=4,ST=.004,MT=50,AT=2e3,wT=3,TT=600,IT="This browser cannot draw meshes: it has no WebGL 2. Turn its hardware acceleration on, or take another browser.",NT=1.08;class RT{constructor(e){this.canvas=e,je.enabled=!1,this.renderer=new bE({canvas:e,antialias:!0}),this.renderer.outputColorSpace=Us,this.renderer.autoClear=!1,this.detail=new sw(CT(this.renderer.getContext()),()=>{this.surfaceIsStale=!0,this.redraw()}),this.fine=this.target=Nr(1,1,Kf),this.draft=Nr(1,1,0),this.copyMaterial=new on({vertexShader:xT,fragmentShader:ET,depthFunc:no,uniforms:{colors:{value:null},depths:{value:null}}});const t=new An(new js(2,2),this.copyMaterial);t.frustumCulled=!1,this.copy.add(t),this.controls=new iT(this.camera,e),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.minDistance=.02,this.controls.maxDistance=12,this.controls.addEventListener("change",()=>this.redrawSurface()),e.addEventListener("webglcontextlost",()=>this.onLost()),e.addEventListener("webglcontextrestored",()=>{this.renderer.setClearColor(this.background),this.redrawSurface(),this.onRestored()}),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}canvas;material=new _T;overlay=new Zo;resolution=new we(1,1);pixelRatio={value:1};depths={value:null};camera=new _n(Zf);onFrame=()=>!1;isBusy=()=>!1;onSurface=()=>{};onLost=()=>{};onRestored=()=>{};isWaiting=()=>!1;renderer;background=new Ze;controls;surface=new Zo;copy=new Zo;copyMaterial;screen=new bd;fine;draft;target;home;mesh;drawn;detail;surfaceIsStale=!0;frame=0;lastFrame=0;pause;get coarseFaces(){return this.detail.coarseFaces}mayBeWhole(e){return this.detail.mayBeWhole(e)}show(e){this.surface.clear(),this.mesh=e,this.drawn=new An(e.geometry,this.material),this.drawn.frustumCulled=!1,this.surface.add(this.drawn),this.home=yT(e.framed),this.camera.up.copy(this.home.up),this.lookAtAll()}lookAtAll(){if(!this.home)return;this.controls.target.set(0,0,0);const{direction:e,halfSize:t}=this.home,i=Math.max(t.x/this.camera.aspect,t.y),a=NT*i/Math.tan(Zf*Math.PI/360)+.3;this.camera.position.copy(e).multiplyScalar(a),this.controls.update(),this.redrawSurface()}turn(e,t,i){const a=this.camera.position.clone().sub(this.controls.target);a.applyAxisAngle(this.camera.up,e);const s=a.clone().cross(this.camera.up).normalize(),r=a.clone().applyAxisAngle(s,t);Math.abs(r.clone().normalize().dot(this.camera.up))<.995&&a.copy(r),this.camera.position.copy(this.controls.target).addScaledVector(a,i),this.controls.update(),this.redrawSurface()}setTurning(e){this.controls.enabled=e}setBackground(e,t){this.renderer.setClearColor(this.background.set(e)),this.material.setDark(t),this.redrawSurface()}pointerAt(e,t){const i=this.canvas.getBoundingClientRect();return new we(2*(e-i.left)/i.width-1,1-2*(t-i.top)/i.height)}pixelOf(e){const t=e.clone().project(this.camera);return new we((t.x+1)/2*this.canvas.clientWidth,(1-t.y)/2*this.canvas.clientHeight)}redrawSurface(){this.detail.change(),this.surfaceIsStale=!0,this.redraw()}redraw(){this.pause&&!this.isWaiting()&&(clearTimeout(this.pause),this.pause=void 0),!(this.frame||this.pause)&&(this.frame=requestAnimationFrame(e=>{const t=e-this.lastFrame;this.frame=0,this.lastFrame=e,this.isWaiting()&&t>MT&&t<AT&&(this.pause=setTimeout(()=>{this.pause=void 0,this.lastFrame=performance.now(),this.redraw()},Math.min(wT*t,TT))),this.onFrame(e)&&this.redrawSurface(),this.draw()}))}draw(){this.surfaceIsStale&&this.drawSurface(),this.copyMaterial.uniforms.colors.value=this.target.texture,this.copyMaterial.uniforms.depths.value=this.target.depthTexture,this.renderer.setRenderTarget(null),this.renderer.render(this.copy,this.screen),this.depths.value=this.target.depthTexture,this.renderer.render(this.overlay,this.camera)}takePicture(){const e=document.createElement("canvas");return e.width=this.canvas.width,e.height=this.canvas.height,this.detail.settle(),this.mesh&&this.drawSurface(rw(this.mesh)),this.draw(),e.getContext("2d")?.drawImage(this.canvas,0,0),e}drawSurface(e=!1){const t=this.camera.position.length();this.camera.near=Math.max(t-1.1,.004),this.camera.far=t+1.1,this.camera.updateProjectionMatrix();const i=this.mesh&&!e&&this.detail.isCoarse(this.mesh)?this.mesh.coarse:void 0;this.mesh&&this.drawn&&(this.drawn.geometry=i??this.mesh.geometry),this.material.uniforms.setBack.value=i?ST:0,this.target=this.detail.isDraft&&!e?this.draft:this.fine,this.renderer.setRenderTarget(this.target),this.renderer.clear(),this.renderer.render(this.surface,this.camera),this.surfaceIsStale=!1,this.mesh&&this.detail.drawn(this.mesh,this.isBusy()),document.documentElement.dataset.detail=this.mesh?this.detail.name(this.mesh):"",this.onSurface()}resize(){const e=Math.max(this.canvas.clientWidth,1),t=Math.max(this.canvas.clientHeight,1),i=Math.min(devicePixelRatio,2);this.renderer.setPixelRatio(i),this.renderer.setSize(e,t,!1),this.resolution.set(e,t),this.material.uniforms.lineWidth.value=i,this.camera.aspect=e/t,this.camera.updateProjectionMatrix();for(const a of[this.fine,this.draft])a.dispose(),a.depthTexture?.dispose();this.fine=this.target=Nr(Math.round(e*i),Math.round(t*i),Kf),this.draft=Nr(this.fine.width,this.fine.height,0),this.pixelRatio.value=i,this.surfaceIsStale=!0,this.draw()}}function Nr(n,e,t){return new Dn(n,e,{samples:t,depthTexture:new sa(n,e,On)})}function CT(n){const e=n.getExtension("WEBGL_debug_renderer_info");return String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER))}const Jf=12;class UT{cross=Ae("aim");stage=Ae("stage");at;get point(){return this.at}move(e,t){const i=this.stage.getBoundingClientRect(),{x:a,y:s}=this.at??{x:i.left+i.width/2,y:i.top+i.height/2},r=(o,c,l)=>Math.min(Math.max(o,c),c+l-1);return this.at={x:r(a+e*Jf,i.left,i.width),y:r(s+t*Jf,i.top,i.height)},this.cross.style.left=`${this.at.x-i.left}px`,this.cross.style.top=`${this.at.y-i.top}px`,this.cross.hidden=!1,this.at}hide(){this.at=void 0,this.cross.hidden=!0}}const PT=5;function LT(n,e){let t,i=0;n.addEventListener("pointerdown",r=>{if(i++,r.button!==0||i>1){t?.draws?e.drawn():t?.grabs&&t.moved&&e.dropped(),t=void 0;return}const o=e.drawsCurve(r.altKey),c={x:r.clientX,y:r.clientY},l=!o&&e.grabs(c);e.setTurning(!o&&!l),t={...c,moved:!1,draws:o,grabs:l,id:r.pointerId},(o||l)&&n.setPointerCapture(r.pointerId),o&&e.draw(c)},{capture:!0});const a="onpointerrawupdate"in window?"pointerrawupdate":"pointermove";n.addEventListener(a,r=>{const o={x:r.clientX,y:r.clientY};if(t&&r.pointerId===t.id){Math.hypot(o.x-t.x,o.y-t.y)>PT&&(t.moved=!0),t.draws&&t.moved&&e.draw(o),t.grabs&&t.moved&&e.drag({...o,since:r.timeStamp});return}i===0&&e.move({...o,since:r.timeStamp})});const s=r=>{if(i=Math.max(i-1,0),!t||r.pointerId!==t.id)return;const{moved:o,draws:c,grabs:l}=t;t=void 0,e.setTurning(!0),c&&o?e.drawn():l&&o?e.dropped():!o&&r.type==="pointerup"&&e.click({x:r.clientX,y:r.clientY,shift:r.shiftKey})};return n.addEventListener("pointerup",s),n.addEventListener("pointercancel",s),n.addEventListener("pointerleave",()=>e.leave()),n.addEventListener("wheel",r=>{r.altKey&&(r.preventDefault(),r.stopImmediatePropagation(),e.wheel(Math.sign(r.deltaY||r.deltaX)))},{capture:!0,passive:!1}),{cancel:()=>!t?.draws&&!t?.grabs?!1:(t=void 0,e.setTurning(!0),!0)}}function DT(n){if(n.altKey)return!0;const e=n.target;return n.ctrlKey||n.metaKey?!/^[zy]$/i.test(n.key)||e.matches("input[type=number], input[type=password]"):e.matches("input:is([type=radio], [type=checkbox], [type=range])")?n.key.startsWith("Arrow"):e.matches("button, summary, a")?n.key==="Enter":e.matches("input, select, textarea")}const wg=0,OT=1,FT=2,qf=2,Dc=1.25,$f=1,hn=32,At=hn/4,Tg=65535,to=Math.pow(2,-24),Zd=Symbol("SKIP_GENERATION"),Ig={strategy:wg,maxDepth:40,targetLeafSize:10,useSharedArrayBuffer:!1,setBoundingBox:!0,onProgress:null,indirect:!1,verbose:!0,range:null,[Zd]:!1};function bt(n,e,t){return t.min.x=e[n],t.min.y=e[n+1],t.min.z=e[n+2],t.max.x=e[n+3],t.max.y=e[n+4],t.max.z=e[n+5],t}function ql(n){let e=-1,t=-1/0;for(let i=0;i<3;i++){const a=n[i+3]-n[i];a>t&&(t=a,e=i)}return e}function Qf(n,e,t){for(let i=0;i<3;i++){const a=e[n+2*i],s=e[n+2*i+1],r=a-s,o=a+s;r<t[i]&&(t[i]=r),o>t[i+3]&&(t[i+3]=o)}}function Oc(n){const e=n[3]-n[0],t=n[4]-n[1],i=n[5]-n[2];return 2*(e*t+t*i+i*e)}function Et(n,e){return e[n+15]===Tg}function Ot(n,e){return e[n+6]}function Zt(n,e){return e[n+14]}function Rt(n){return n+At}function Ct(n,e){const t=e[n+6];return n+t*At}function Kd(n,e){return e[n+7]}function Fc(n,e,t,i,a){let s=1/0,r=1/0,o=1/0,c=-1/0,l=-1/0,u=-1/0,h=1/0,d=1/0,f=1/0,g=-1/0,y=-1/0,p=-1/0;const m=n.offset||0;for(let b=(e-m)*6,x=(e+t-m)*6;b<x;b+=6){const v=n[b+0],M=n[b+1],w=v-M,N=v+M;w<s&&(s=w),N>c&&(c=N),v<h&&(h=v),v>g&&(g=v);const _=n[b+2],S=n[b+3],T=_-S,I=_+S;T<r&&(r=T),I>l&&(l=I),_<d&&(d=_),_>y&&(y=_);const C=n[b+4],L=n[b+5],F=C-L,P=C+L;F<o&&(o=F),P>u&&(u=P),C<f&&(f=C),C>p&&(p=C)}i[0]=s,i[1]=r,i[2]=o,i[3]=c,i[4]=l,i[5]=u,a[0]=h,a[1]=d,a[2]=f,a[3]=g,a[4]=y,a[5]=p}const jn=8,Jd=8,kc=new Int32Array(jn),Hn=new Float32Array(jn*6),Ta=new Float32Array(jn*6),Cn=new Float32Array(6),Rr=new Float32Array(6),Ni=new Int32Array(Jd),ep=new Float32Array(Jd*6);function kT(n,e,t,i){for(let a=0;a<3;a++){const s=e[n+2*a],r=e[n+2*a+1],o=s-r,c=s+r;o<t[i+a]&&(t[i+a]=o),c>t[i+a+3]&&(t[i+a+3]=c)}}function tp(n,e){const t=n[e+3]-n[e],i=n[e+4]-n[e+1],a=n[e+5]-n[e+2];return 2*(t*i+i*a+a*t)}function BT(n,e,t,i,a,s){let r=-1,o=0;if(s===wg)r=ql(e),r!==-1&&(o=(e[r]+e[r+3])/2);else if(s===OT)r=ql(n),r!==-1&&(o=VT(t,i,a,r));else if(s===FT){const c=Oc(n);let l=Dc*a;const u=t.offset||0,h=(i-u)*6,d=(i+a-u)*6;for(let f=0;f<3;f++){const g=e[f],m=(e[f+3]-g)/jn;if(a<Jd){for(let b=0;b<a;b++){const x=h+b*6,v=t[x+2*f];let M=b;for(;M>0&&t[Ni[M-1]+2*f]>v;)Ni[M]=Ni[M-1],M--;Ni[M]=x}for(let b=0;b<3;b++)Cn[b]=1/0,Cn[b+3]=-1/0,Rr[b]=1/0,Rr[b+3]=-1/0;for(let b=a-1;b>=0;b--)Qf(Ni[b],t,Rr),ep.set(Rr,b*6);for(let b=0;b<a-1;b++){Qf(Ni[b],t,Cn);const x=t[Ni[b+1]+2*f];if(t[Ni[b]+2*f]===x)continue;const v=b+1,M=a-v,w=Oc(Cn)/c,N=tp(ep,v*6)/c,_=$f+Dc*(w*v+N*M);_<l&&(r=f,l=_,o=x)}}else{for(let v=0;v<jn;v++){kc[v]=0;for(let M=0;M<3;M++)Hn[v*6+M]=1/0,Hn[v*6+M+3]=-1/0}for(let v=h;v<d;v+=6){let N=~~((t[v+2*f]-g)/m);N>=jn&&(N=jn-1),kc[N]++,kT(v,t,Hn,N*6)}const b=(jn-1)*6;for(let v=0;v<6;v++)Ta[b+v]=Hn[b+v];for(let v=jn-2;v>=0;v--){const M=v*6,w=M+6;for(let N=0;N<3;N++)Ta[M+N]=Math.min(Hn[M+N],Ta[w+N]),Ta[M+N+3]=Math.max(Hn[M+N+3],Ta[w+N+3])}let x=0;for(let v=0;v<jn-1;v++){const M=v*6,w=kc[v];if(w!==0)for(let I=0;I<3;I++)x===0?(Cn[I]=Hn[M+I],Cn[I+3]=Hn[M+I+3]):(Cn[I]=Math.min(Cn[I],Hn[M+I]),Cn[I+3]=Math.max(Cn[I+3],Hn[M+I+3]));x+=w;let N=0,_=0;x!==0&&(N=Oc(Cn)/c);const S=a-x;S!==0&&(_=tp(Ta,M+6)/c);const T=$f+Dc*(N*x+_*S);T<l&&(r=f,l=T,o=g+m+v*m)}}}}else console.warn(`BVH: Invalid build strategy value ${s} used.`);return{axis:r,pos:o}}function VT(n,e,t,i){let a=0;const s=n.offset;for(let r=e,o=e+t;r<o;r++)a+=n[(r-s)*6+i*2];return a/t}function zT(n,e,t,i,a,s){let r=i,o=i+a-1;const c=s.pos,l=s.axis*2,u=t.offset||0;for(;;){for(;r<=o&&t[(r-u)*6+l]<c;)r++;for(;r<=o&&t[(o-u)*6+l]>=c;)o--;if(r<o){for(let h=0;h<e;h++){let d=n[r*e+h];n[r*e+h]=n[o*e+h],n[o*e+h]=d}for(let h=0;h<6;h++){const d=r-u,f=o-u,g=t[d*6+h];t[d*6+h]=t[f*6+h],t[f*6+h]=g}r++,o--}else return r}}const GT=Math.pow(2,32),Ia=new Float32Array(6),Cr=new Float32Array(6);function WT(n,e,t,i,a,s){const{maxDepth:r,verbose:o,targetLeafSize:c,_strictLeafSize:l=1/0,strategy:u,onProgress:h,useSharedArrayBuffer:d=!1}=a,f=n.primitiveBuffer,g=n.primitiveBufferStride,y=d?SharedArrayBuffer:ArrayBuffer,p=new y(hn*Math.max(1,2*Math.ceil(i)-1)),m=new Float32Array(p),b=new Uint32Array(p),x=new Uint16Array(p);let v=0,M=!1;return Fc(e,t,i,Ia,Cr),_(t,i,0),p.slice(0,v*hn);function w(S){h&&h((S-s.offset)/s.count)}function N(S,T,I){const C=S*2;b[S+6]=T,x[C+14]=I,x[C+15]=Tg,w(T+I)}function _(S,T,I){const C=v++,L=C*At;m.set(Ia,L),!M&&I>=r&&(M=!0,o&&console.warn(`BVH: Max depth of ${r} reached when generating BVH. Consider increasing maxDepth.`));const F=T>l;if(T<=c&&!F||I>=r){N(L,S,T);return}const P=BT(Ia,Cr,e,S,T,u);let B=P.axis===-1?-1:zT(f,g,e,S,T,P);if(P.axis===-1||B===S||B===S+T){if(!F){N(L,S,T);return}P.axis=Math.max(0,ql(Ia)),B=S+Math.max(1,Math.floor(T/2))}b[L+7]=P.axis;const V=B-S;Fc(e,S,V,Ia,Cr),_(S,V,I+1);const q=v-C;if(q>GT)throw new Error("MeshBVH: Cannot store relative child node offset greater than 32 bits.");b[L+6]=q;const ee=T-V;Fc(e,B,ee,Ia,Cr),_(B,ee,I+1)}}function HT(n,e){const t=n.getRootRanges(e.range),i=t[0],a=t[t.length-1],s={offset:i.offset,count:a.offset+a.count-i.offset},r=new Float32Array(6*s.count);r.offset=s.offset,n.computePrimitiveBounds(s.offset,s.count,r),n._roots=t.map(o=>WT(n,r,o.offset,o.count,e,s))}class qd{constructor(e){this._getNewPrimitive=e,this._primitives=[]}getPrimitive(){const e=this._primitives;return e.length===0?this._getNewPrimitive():e.pop()}releasePrimitive(e){this._primitives.push(e)}}class jT{constructor(){this.float32Array=null,this.uint16Array=null,this.uint32Array=null;const e=[];let t=null;this.setBuffer=i=>{t&&e.push(t),t=i,this.float32Array=new Float32Array(i),this.uint16Array=new Uint16Array(i),this.uint32Array=new Uint32Array(i)},this.clearBuffer=()=>{t=null,this.float32Array=null,this.uint16Array=null,this.uint32Array=null,e.length!==0&&this.setBuffer(e.pop())}}}const tt=new jT;let Li,Ba;const Na=[],Ur=new qd(()=>new kt);function XT(n,e,t,i,a,s){Li=Ur.getPrimitive(),Ba=Ur.getPrimitive(),Na.push(Li,Ba),tt.setBuffer(n._roots[e]);const r=$l(0,n.geometry,t,i,a,s);tt.clearBuffer(),Ur.releasePrimitive(Li),Ur.releasePrimitive(Ba),Na.pop(),Na.pop();const o=Na.length;return o>0&&(Ba=Na[o-1],Li=Na[o-2]),r}function $l(n,e,t,i,a=null,s=0,r=0){const{float32Array:o,uint16Array:c,uint32Array:l}=tt;let u=n*2;if(Et(u,c)){const g=Ot(n,l),y=Zt(u,c);return bt(n,o,Li),i(g,y,!1,r,s+n/At,Li)}else{let C=function(F){const{uint16Array:P,uint32Array:B}=tt;let V=F*2;for(;!Et(V,P);)F=Rt(F),V=F*2;return Ot(F,B)},L=function(F){const{uint16Array:P,uint32Array:B}=tt;let V=F*2;for(;!Et(V,P);)F=Ct(F,B),V=F*2;return Ot(F,B)+Zt(V,P)};var d=C,f=L;const g=Rt(n),y=Ct(n,l);let p=g,m=y,b,x,v,M;if(a&&(v=Li,M=Ba,bt(p,o,v),bt(m,o,M),b=a(v),x=a(M),x<b)){p=y,m=g;const F=b;b=x,x=F,v=M}v||(v=Li,bt(p,o,v));const w=Et(p*2,c),N=t(v,w,b,r+1,s+p/At);let _;if(N===qf){const F=C(p),B=L(p)-F;_=i(F,B,!0,r+1,s+p/At,v)}else _=N&&$l(p,e,t,i,a,s,r+1);if(_)return!0;M=Ba,bt(m,o,M);const S=Et(m*2,c),T=t(M,S,x,r+1,s+m/At);let I;if(T===qf){const F=C(m),B=L(m)-F;I=i(F,B,!0,r+1,s+m/At,M)}else I=T&&$l(m,e,t,i,a,s,r+1);return!!I}}const Ns=new tt.constructor,bo=new tt.constructor,Ri=new qd(()=>new kt),Ra=new kt,Ca=new kt,Bc=new kt,Vc=new kt;let zc=!1;function YT(n,e,t,i){if(zc)throw new Error("MeshBVH: Recursive calls to bvhcast not supported.");zc=!0;const a=n._roots,s=e._roots;let r,o=0,c=0;const l=new qe().copy(t).invert();for(let u=0,h=a.length;u<h;u++){Ns.setBuffer(a[u]),c=0;const d=Ri.getPrimitive();bt(0,Ns.float32Array,d),d.applyMatrix4(l);for(let f=0,g=s.length;f<g&&(bo.setBuffer(s[f]),r=Un(0,0,t,l,i,o,c,0,0,d),bo.clearBuffer(),c+=s[f].byteLength/hn,!r);f++);if(Ri.releasePrimitive(d),Ns.clearBuffer(),o+=a[u].byteLength/hn,r)break}return zc=!1,r}function Un(n,e,t,i,a,s=0,r=0,o=0,c=0,l=null,u=!1){let h,d;u?(h=bo,d=Ns):(h=Ns,d=bo);const f=h.float32Array,g=h.uint32Array,y=h.uint16Array,p=d.float32Array,m=d.uint32Array,b=d.uint16Array,x=n*2,v=e*2,M=Et(x,y),w=Et(v,b);let N=!1;if(w&&M)u?N=a(Ot(e,m),Zt(e*2,b),Ot(n,g),Zt(n*2,y),c,r+e/At,o,s+n/At):N=a(Ot(n,g),Zt(n*2,y),Ot(e,m),Zt(e*2,b),o,s+n/At,c,r+e/At);else if(w){const _=Ri.getPrimitive();bt(e,p,_),_.applyMatrix4(t);const S=Rt(n),T=Ct(n,g);bt(S,f,Ra),bt(T,f,Ca);const I=_.intersectsBox(Ra),C=_.intersectsBox(Ca);N=I&&Un(e,S,i,t,a,r,s,c,o+1,_,!u)||C&&Un(e,T,i,t,a,r,s,c,o+1,_,!u),Ri.releasePrimitive(_)}else{const _=Rt(e),S=Ct(e,m);bt(_,p,Bc),bt(S,p,Vc);const T=l.intersectsBox(Bc),I=l.intersectsBox(Vc);if(T&&I)N=Un(n,_,t,i,a,s,r,o,c+1,l,u)||Un(n,S,t,i,a,s,r,o,c+1,l,u);else if(T)if(M)N=Un(n,_,t,i,a,s,r,o,c+1,l,u);else{const C=Ri.getPrimitive();C.copy(Bc).applyMatrix4(t);const L=Rt(n),F=Ct(n,g);bt(L,f,Ra),bt(F,f,Ca);const P=C.intersectsBox(Ra),B=C.intersectsBox(Ca);N=P&&Un(_,L,i,t,a,r,s,c,o+1,C,!u)||B&&Un(_,F,i,t,a,r,s,c,o+1,C,!u),Ri.releasePrimitive(C)}else if(I)if(M)N=Un(n,S,t,i,a,s,r,o,c+1,l,u);else{const C=Ri.getPrimitive();C.copy(Vc).applyMatrix4(t);const L=Rt(n),F=Ct(n,g);bt(L,f,Ra),bt(F,f,Ca);const P=C.intersectsBox(Ra),B=C.intersectsBox(Ca);N=P&&Un(S,L,i,t,a,r,s,c,o+1,C,!u)||B&&Un(S,F,i,t,a,r,s,c,o+1,C,!u),Ri.releasePrimitive(C)}}return N}const Gc=new class{constructor(){let n=null,e=null,t=null,i=!1;this.root=null,this.buffer=null,this.uint32Array=null,this.uint16Array=null,this.setBVH=(s,r)=>{if(i)throw new Error("BVHTraversalHelper: cannot call setBVH during an active traversal.");this.root=r,this.buffer=n=s._roots[r],this.uint16Array=t=new Uint16Array(n),this.uint32Array=e=new Uint32Array(n)},this.reset=()=>{this.root=null,this.buffer=n=null,this.uint16Array=t=null,this.uint32Array=e=null},this.getRangeStart=s=>{let r=s*2;for(;!Et(r,t);)s=Rt(s),r=s*2;return Ot(s,e)},this.getRangeEnd=s=>{let r=s*2;for(;!Et(r,t);)s=Ct(s,e),r=s*2;return Ot(s,e)+Zt(r,t)};const a=(s,r,o)=>{const c=r*2,l=Et(c,t);if(!s(o,l,r)&&!l){const h=Rt(r),d=Ct(r,e);a(s,h,o+1),a(s,d,o+1)}};this.traverseBuffer=s=>{if(i)throw new Error("BVHTraversalHelper: cannot start a traversal during an active traversal.");i=!0;try{a(s,0,0)}finally{i=!1}},this.traverse=s=>{this.traverseBuffer((r,o,c)=>{if(o){const l=c*2,u=e[c+6],h=t[l+14];return s(r,o,new Float32Array(n,c*4,6),u,h)}else{const l=Kd(c,e);return s(r,o,new Float32Array(n,c*4,6),l)}})}}},np=new kt,Ua=new Float32Array(6);class ZT{constructor(){this._roots=null,this.primitiveBuffer=null,this.primitiveBufferStride=null}init(e){e={...Ig,...e},"maxLeafSize"in e&&(console.warn('BVH: "maxLeafSize" option has been deprecated. Use "targetLeafSize", instead.'),e={...e,targetLeafSize:e.maxLeafSize}),HT(this,e)}getRootRanges(){throw new Error("BVH: getRootRanges() not implemented")}writePrimitiveBounds(){throw new Error("BVH: writePrimitiveBounds() not implemented")}writePrimitiveRangeBounds(e,t,i,a){let s=1/0,r=1/0,o=1/0,c=-1/0,l=-1/0,u=-1/0;for(let h=e,d=e+t;h<d;h++){this.writePrimitiveBounds(h,Ua,0);const[f,g,y,p,m,b]=Ua;f<s&&(s=f),p>c&&(c=p),g<r&&(r=g),m>l&&(l=m),y<o&&(o=y),b>u&&(u=b)}return i[a+0]=s,i[a+1]=r,i[a+2]=o,i[a+3]=c,i[a+4]=l,i[a+5]=u,i}computePrimitiveBounds(e,t,i){const a=i.offset||0;for(let s=e,r=e+t;s<r;s++){this.writePrimitiveBounds(s,Ua,0);const[o,c,l,u,h,d]=Ua,f=(o+u)/2,g=(c+h)/2,y=(l+d)/2,p=(u-o)/2,m=(h-c)/2,b=(d-l)/2,x=(s-a)*6;i[x+0]=f,i[x+1]=p+(Math.abs(f)+p)*to,i[x+2]=g,i[x+3]=m+(Math.abs(g)+m)*to,i[x+4]=y,i[x+5]=b+(Math.abs(y)+b)*to}return i}shiftPrimitiveOffsets(e){const t=this._indirectBuffer;if(t)for(let i=0,a=t.length;i<a;i++)t[i]+=e;else{const i=this._roots;for(let a=0;a<i.length;a++){const s=i[a],r=new Uint32Array(s),o=new Uint16Array(s),c=s.byteLength/hn;for(let l=0;l<c;l++){const u=At*l,h=2*u;Et(h,o)&&(r[u+6]+=e)}}}}traverse(e,t=0){Gc.setBVH(this,t),Gc.traverse(e),Gc.reset()}refit(){const e=this._roots;for(let t=0,i=e.length;t<i;t++){const a=e[t],s=new Uint32Array(a),r=new Uint16Array(a),o=new Float32Array(a),c=a.byteLength/hn;for(let l=c-1;l>=0;l--){const u=l*At,h=u*2;if(Et(h,r)){const f=Ot(u,s),g=Zt(h,r);this.writePrimitiveRangeBounds(f,g,Ua,0),o.set(Ua,u)}else{const f=Rt(u),g=Ct(u,s);for(let y=0;y<3;y++){const p=o[f+y],m=o[f+y+3],b=o[g+y],x=o[g+y+3];o[u+y]=p<b?p:b,o[u+y+3]=m>x?m:x}}}}}getBoundingBox(e){return e.makeEmpty(),this._roots.forEach(i=>{bt(0,new Float32Array(i),np),e.union(np)}),e}shapecast(e){let{boundsTraverseOrder:t,intersectsBounds:i,intersectsRange:a,intersectsPrimitive:s,scratchPrimitive:r,iterate:o}=e;if(a&&s){const h=a;a=(d,f,g,y,p)=>h(d,f,g,y,p)?!0:o(d,f,this,s,g,y,r)}else a||(s?a=(h,d,f,g)=>o(h,d,this,s,f,g,r):a=(h,d,f)=>f);let c=!1,l=0;const u=this._roots;for(let h=0,d=u.length;h<d;h++){const f=u[h];if(c=XT(this,h,i,a,t,l),c)break;l+=f.byteLength/hn}return c}bvhcast(e,t,i){let{intersectsRanges:a}=i;return YT(this,e,t,a)}}function KT(){return typeof SharedArrayBuffer<"u"}function $d(n){return n.index?n.index.count:n.attributes.position.count}function Co(n){return $d(n)/3}function JT(n,e=ArrayBuffer){return n>65535?new Uint32Array(new e(4*n)):new Uint16Array(new e(2*n))}function qT(n,e){if(!n.index){const t=n.attributes.position.count,i=e.useSharedArrayBuffer?SharedArrayBuffer:ArrayBuffer,a=JT(t,i);n.setIndex(new St(a,1));for(let s=0;s<t;s++)a[s]=s}}function $T(n,e,t){const i=$d(n)/t,a=e||n.drawRange,s=a.start/t,r=(a.start+a.count)/t,o=Math.max(0,s),c=Math.min(i,r)-o;return{offset:Math.floor(o),count:Math.floor(c)}}function QT(n,e){return n.groups.map(t=>({offset:t.start/e,count:t.count/e}))}function ip(n,e,t){const i=$T(n,e,t),a=QT(n,t);if(!a.length)return[i];const s=[],r=i.offset,o=i.offset+i.count,c=$d(n)/t,l=[];for(const d of a){const{offset:f,count:g}=d,y=f,p=isFinite(g)?g:c-f,m=f+p;y<o&&m>r&&(l.push({pos:Math.max(r,y),isStart:!0}),l.push({pos:Math.min(o,m),isStart:!1}))}l.sort((d,f)=>d.pos!==f.pos?d.pos-f.pos:d.type==="end"?-1:1);let u=0,h=null;for(const d of l){const f=d.pos;u!==0&&f!==h&&s.push({offset:h,count:f-h}),u+=d.isStart?1:-1,h=f}return s}function eI(n,e){const t=n[n.length-1],i=t.offset+t.count>2**16,a=n.reduce((l,u)=>l+u.count,0),s=i?4:2,r=e?new SharedArrayBuffer(a*s):new ArrayBuffer(a*s),o=i?new Uint32Array(r):new Uint16Array(r);let c=0;for(let l=0;l<n.length;l++){const{offset:u,count:h}=n[l];for(let d=0;d<h;d++)o[c+d]=u+d;c+=h}return o}class tI extends ZT{get indirect(){return!!this._indirectBuffer}get primitiveStride(){return null}get primitiveBufferStride(){return this.indirect?1:this.primitiveStride}set primitiveBufferStride(e){}get primitiveBuffer(){return this.indirect?this._indirectBuffer:this.geometry.index.array}set primitiveBuffer(e){}constructor(e,t={}){if(e.isBufferGeometry){if(e.index&&e.index.isInterleavedBufferAttribute)throw new Error("BVH: InterleavedBufferAttribute is not supported for the index attribute.")}else throw new Error("BVH: Only BufferGeometries are supported.");if(t.useSharedArrayBuffer&&!KT())throw new Error("BVH: SharedArrayBuffer is not available.");super(),this.geometry=e,this.resolvePrimitiveIndex=t.indirect?i=>this._indirectBuffer[i]:i=>i,this.primitiveBuffer=null,this.primitiveBufferStride=null,this._indirectBuffer=null,t={...Ig,...t},t[Zd]||this.init(t)}init(e){const{geometry:t,primitiveStride:i}=this;if(e.indirect){const a=ip(t,e.range,i),s=eI(a,e.useSharedArrayBuffer);this._indirectBuffer=s}else qT(t,e);super.init(e),!t.boundingBox&&e.setBoundingBox&&(t.boundingBox=this.getBoundingBox(new kt))}getRootRanges(e){return this.indirect?[{offset:0,count:this._indirectBuffer.length}]:ip(this.geometry,e,this.primitiveStride)}raycastObject3D(){throw new Error("BVH: raycastObject3D() not implemented")}}class gi{constructor(){this.min=1/0,this.max=-1/0}setFromPointsField(e,t){let i=1/0,a=-1/0;for(let s=0,r=e.length;s<r;s++){const c=e[s][t];i=c<i?c:i,a=c>a?c:a}this.min=i,this.max=a}setFromPoints(e,t){let i=1/0,a=-1/0;for(let s=0,r=t.length;s<r;s++){const o=t[s],c=e.dot(o);i=c<i?c:i,a=c>a?c:a}this.min=i,this.max=a}isSeparated(e){return this.min>e.max||e.min>this.max}}gi.prototype.setFromBox=(function(){const n=new U;return function(t,i){const a=i.min,s=i.max;let r=1/0,o=-1/0;for(let c=0;c<=1;c++)for(let l=0;l<=1;l++)for(let u=0;u<=1;u++){n.x=a.x*c+s.x*(1-c),n.y=a.y*l+s.y*(1-l),n.z=a.z*u+s.z*(1-u);const h=t.dot(n);r=Math.min(h,r),o=Math.max(h,o)}this.min=r,this.max=o}})();const nI=(function(){const n=new U,e=new U,t=new U;return function(a,s,r){const o=a.start,c=n,l=s.start,u=e;t.subVectors(o,l),n.subVectors(a.end,a.start),e.subVectors(s.end,s.start);const h=t.dot(u),d=u.dot(c),f=u.dot(u),g=t.dot(c),p=c.dot(c)*f-d*d;let m,b;p!==0?m=(h*d-g*f)/p:m=0,b=(h+m*d)/f,r.x=m,r.y=b}})(),Qd=(function(){const n=new we,e=new U,t=new U;return function(a,s,r,o){nI(a,s,n);let c=n.x,l=n.y;if(c>=0&&c<=1&&l>=0&&l<=1){a.at(c,r),s.at(l,o);return}else if(c>=0&&c<=1){l<0?s.at(0,o):s.at(1,o),a.closestPointToPoint(o,!0,r);return}else if(l>=0&&l<=1){c<0?a.at(0,r):a.at(1,r),s.closestPointToPoint(r,!0,o);return}else{let u;c<0?u=a.start:u=a.end;let h;l<0?h=s.start:h=s.end;const d=e,f=t;if(a.closestPointToPoint(h,!0,e),s.closestPointToPoint(u,!0,t),d.distanceToSquared(h)<=f.distanceToSquared(u)){r.copy(d),o.copy(h);return}else{r.copy(u),o.copy(f);return}}}})(),iI=(function(){const n=new U,e=new U,t=new Xn,i=new $n;return function(s,r){const{radius:o,center:c}=s,{a:l,b:u,c:h}=r;if(i.start=l,i.end=u,i.closestPointToPoint(c,!0,n).distanceTo(c)<=o||(i.start=l,i.end=h,i.closestPointToPoint(c,!0,n).distanceTo(c)<=o)||(i.start=u,i.end=h,i.closestPointToPoint(c,!0,n).distanceTo(c)<=o))return!0;const y=r.getPlane(t);if(Math.abs(y.distanceToPoint(c))<=o){const m=y.projectPoint(c,e);if(r.containsPoint(m))return!0}return!1}})(),aI=["x","y","z"],ci=1e-15,ap=ci*ci;function gn(n){return Math.abs(n)<ci}class Fn extends Dt{constructor(...e){super(...e),this.isExtendedTriangle=!0,this.satAxes=new Array(4).fill().map(()=>new U),this.satBounds=new Array(4).fill().map(()=>new gi),this.points=[this.a,this.b,this.c],this.plane=new Xn,this.isDegenerateIntoSegment=!1,this.isDegenerateIntoPoint=!1,this.degenerateSegment=new $n,this.needsUpdate=!0}intersectsSphere(e){return iI(e,this)}update(){const e=this.a,t=this.b,i=this.c,a=this.points,s=this.satAxes,r=this.satBounds,o=s[0],c=r[0];this.getNormal(o),c.setFromPoints(o,a);const l=s[1],u=r[1];l.subVectors(e,t),u.setFromPoints(l,a);const h=s[2],d=r[2];h.subVectors(t,i),d.setFromPoints(h,a);const f=s[3],g=r[3];f.subVectors(i,e),g.setFromPoints(f,a);const y=l.length(),p=h.length(),m=f.length();this.isDegenerateIntoPoint=!1,this.isDegenerateIntoSegment=!1,y<ci?p<ci||m<ci?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(e),this.degenerateSegment.end.copy(i)):p<ci?m<ci?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(t),this.degenerateSegment.end.copy(e)):m<ci&&(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(i),this.degenerateSegment.end.copy(t)),this.plane.setFromNormalAndCoplanarPoint(o,e),this.needsUpdate=!1}}Fn.prototype.closestPointToSegment=(function(){const n=new U,e=new U,t=new $n;return function(a,s=null,r=null){this.needsUpdate&&this.update();const{start:o,end:c}=a,l=this.points;let u,h=1/0;const d=this.plane.distanceToPoint(o),f=this.plane.distanceToPoint(c);if(d*f<0&&this.plane.intersectLine(a,n)!==null&&this.containsPoint(n))return s&&s.copy(n),r&&r.copy(n),0;for(let g=0;g<3;g++){const y=(g+1)%3;t.start.copy(l[g]),t.end.copy(l[y]),Qd(t,a,n,e),u=n.distanceToSquared(e),u<h&&(h=u,s&&s.copy(n),r&&r.copy(e))}return this.closestPointToPoint(o,n),u=o.distanceToSquared(n),u<h&&(h=u,s&&s.copy(n),r&&r.copy(o)),this.closestPointToPoint(c,n),u=c.distanceToSquared(n),u<h&&(h=u,s&&s.copy(n),r&&r.copy(c)),Math.sqrt(h)}})();Fn.prototype.intersectsTriangle=(function(){const n=new Fn,e=new gi,t=new gi,i=new U,a=new U,s=new U,r=new U,o=new $n,c=new $n,l=new U,u=new we,h=new we;function d(x,v,M,w){const N=i;!x.isDegenerateIntoPoint&&!x.isDegenerateIntoSegment?N.copy(x.plane.normal):N.copy(v.plane.normal);const _=x.satBounds,S=x.satAxes;for(let C=1;C<4;C++){const L=_[C],F=S[C];if(e.setFromPoints(F,v.points),L.isSeparated(e)||(r.copy(N).cross(F),e.setFromPoints(r,x.points),t.setFromPoints(r,v.points),e.isSeparated(t)))return!1}const T=v.satBounds,I=v.satAxes;for(let C=1;C<4;C++){const L=T[C],F=I[C];if(e.setFromPoints(F,x.points),L.isSeparated(e)||(r.crossVectors(N,F),e.setFromPoints(r,x.points),t.setFromPoints(r,v.points),e.isSeparated(t)))return!1}return M&&(w||console.warn("ExtendedTriangle.intersectsTriangle: Triangles are coplanar which does not support an output edge. Setting edge to 0, 0, 0."),M.start.set(0,0,0),M.end.set(0,0,0)),!0}function f(x,v,M,w,N,_,S,T,I,C,L){let F=S/(S-T);C.x=w+(N-w)*F,L.start.subVectors(v,x).multiplyScalar(F).add(x),F=S/(S-I),C.y=w+(_-w)*F,L.end.subVectors(M,x).multiplyScalar(F).add(x)}function g(x,v,M,w,N,_,S,T,I,C,L){if(N>0)f(x.c,x.a,x.b,w,v,M,I,S,T,C,L);else if(_>0)f(x.b,x.a,x.c,M,v,w,T,S,I,C,L);else if(T*I>0||S!=0)f(x.a,x.b,x.c,v,M,w,S,T,I,C,L);else if(T!=0)f(x.b,x.a,x.c,M,v,w,T,S,I,C,L);else if(I!=0)f(x.c,x.a,x.b,w,v,M,I,S,T,C,L);else return!0;return!1}function y(x,v,M,w){const N=v.degenerateSegment,_=x.plane.distanceToPoint(N.start),S=x.plane.distanceToPoint(N.end);return gn(_)?gn(S)?d(x,v,M,w):(M&&(M.start.copy(N.start),M.end.copy(N.start)),x.containsPoint(N.start)):gn(S)?(M&&(M.start.copy(N.end),M.end.copy(N.end)),x.containsPoint(N.end)):x.plane.intersectLine(N,i)!=null?(M&&(M.start.copy(i),M.end.copy(i)),x.containsPoint(i)):!1}function p(x,v,M){const w=v.a;return gn(x.plane.distanceToPoint(w))&&x.containsPoint(w)?(M&&(M.start.copy(w),M.end.copy(w)),!0):!1}function m(x,v,M){const w=x.degenerateSegment,N=v.a;return w.closestPointToPoint(N,!0,i),N.distanceToSquared(i)<ap?(M&&(M.start.copy(N),M.end.copy(N)),!0):!1}function b(x,v,M,w){if(x.isDegenerateIntoSegment)if(v.isDegenerateIntoSegment){const N=x.degenerateSegment,_=v.degenerateSegment,S=a,T=s;N.delta(S),_.delta(T);const I=i.subVectors(_.start,N.start),C=S.x*T.y-S.y*T.x;if(gn(C))return!1;const L=(I.x*T.y-I.y*T.x)/C,F=-(S.x*I.y-S.y*I.x)/C;if(L<0||L>1||F<0||F>1)return!1;const P=N.start.z+S.z*L,B=_.start.z+T.z*F;return gn(P-B)?(M&&(M.start.copy(N.start).addScaledVector(S,L),M.end.copy(N.start).addScaledVector(S,L)),!0):!1}else return v.isDegenerateIntoPoint?m(x,v,M):y(v,x,M,w);else{if(x.isDegenerateIntoPoint)return v.isDegenerateIntoPoint?v.a.distanceToSquared(x.a)<ap?(M&&(M.start.copy(x.a),M.end.copy(x.a)),!0):!1:v.isDegenerateIntoSegment?m(v,x,M):p(v,x,M);if(v.isDegenerateIntoPoint)return p(x,v,M);if(v.isDegenerateIntoSegment)return y(x,v,M,w)}}return function(v,M=null,w=!1){this.needsUpdate&&this.update(),v.isExtendedTriangle?v.needsUpdate&&v.update():(n.copy(v),n.update(),v=n);const N=b(this,v,M,w);if(N!==void 0)return N;const _=this.plane,S=v.plane;let T=S.distanceToPoint(this.a),I=S.distanceToPoint(this.b),C=S.distanceToPoint(this.c);gn(T)&&(T=0),gn(I)&&(I=0),gn(C)&&(C=0);const L=T*I,F=T*C;if(L>0&&F>0)return!1;let P=_.distanceToPoint(v.a),B=_.distanceToPoint(v.b),V=_.distanceToPoint(v.c);gn(P)&&(P=0),gn(B)&&(B=0),gn(V)&&(V=0);const q=P*B,ee=P*V;if(q>0&&ee>0)return!1;a.copy(_.normal),s.copy(S.normal);const le=a.cross(s);let ve=0,ye=Math.abs(le.x);const Ge=Math.abs(le.y);Ge>ye&&(ye=Ge,ve=1),Math.abs(le.z)>ye&&(ve=2);const Re=aI[ve],J=this.a[Re],ue=this.b[Re],ae=this.c[Re],Te=v.a[Re],Ce=v.b[Re],Ie=v.c[Re];if(g(this,J,ue,ae,L,F,T,I,C,u,o))return d(this,v,M,w);if(g(v,Te,Ce,Ie,q,ee,P,B,V,h,c))return d(this,v,M,w);if(u.y<u.x){const rt=u.y;u.y=u.x,u.x=rt,l.copy(o.start),o.start.copy(o.end),o.end.copy(l)}if(h.y<h.x){const rt=h.y;h.y=h.x,h.x=rt,l.copy(c.start),c.start.copy(c.end),c.end.copy(l)}return u.y<h.x||h.y<u.x?!1:(M&&(h.x>u.x?M.start.copy(c.start):M.start.copy(o.start),h.y<u.y?M.end.copy(c.end):M.end.copy(o.end)),!0)}})();Fn.prototype.distanceToPoint=(function(){const n=new U;return function(t){return this.closestPointToPoint(t,n),t.distanceTo(n)}})();Fn.prototype.distanceToTriangle=(function(){const n=new U,e=new U,t=["a","b","c"],i=new $n,a=new $n;return function(r,o=null,c=null){const l=o||c?i:null;if(this.intersectsTriangle(r,l,!0))return(o||c)&&(o&&l.getCenter(o),c&&l.getCenter(c)),0;let u=1/0;for(let h=0;h<3;h++){let d;const f=t[h],g=r[f];this.closestPointToPoint(g,n),d=g.distanceToSquared(n),d<u&&(u=d,o&&o.copy(n),c&&c.copy(g));const y=this[f];r.closestPointToPoint(y,n),d=y.distanceToSquared(n),d<u&&(u=d,o&&o.copy(y),c&&c.copy(n))}for(let h=0;h<3;h++){const d=t[h],f=t[(h+1)%3];i.set(this[d],this[f]);for(let g=0;g<3;g++){const y=t[g],p=t[(g+1)%3];a.set(r[y],r[p]),Qd(i,a,n,e);const m=n.distanceToSquared(e);m<u&&(u=m,o&&o.copy(n),c&&c.copy(e))}}return Math.sqrt(u)}})();class tn{constructor(e,t,i){this.isOrientedBox=!0,this.min=new U,this.max=new U,this.matrix=new qe,this.invMatrix=new qe,this.points=new Array(8).fill().map(()=>new U),this.satAxes=new Array(3).fill().map(()=>new U),this.satBounds=new Array(3).fill().map(()=>new gi),this.alignedSatBounds=new Array(3).fill().map(()=>new gi),this.needsUpdate=!1,e&&this.min.copy(e),t&&this.max.copy(t),i&&this.matrix.copy(i)}set(e,t,i){this.min.copy(e),this.max.copy(t),this.matrix.copy(i),this.needsUpdate=!0}copy(e){this.min.copy(e.min),this.max.copy(e.max),this.matrix.copy(e.matrix),this.needsUpdate=!0}}tn.prototype.update=(function(){return function(){const e=this.matrix,t=this.min,i=this.max,a=this.points;for(let l=0;l<=1;l++)for(let u=0;u<=1;u++)for(let h=0;h<=1;h++){const d=1*l|2*u|4*h,f=a[d];f.x=l?i.x:t.x,f.y=u?i.y:t.y,f.z=h?i.z:t.z,f.applyMatrix4(e)}const s=this.satBounds,r=this.satAxes,o=a[0];for(let l=0;l<3;l++){const u=r[l],h=s[l],d=1<<l,f=a[d];u.subVectors(o,f),h.setFromPoints(u,a)}const c=this.alignedSatBounds;c[0].setFromPointsField(a,"x"),c[1].setFromPointsField(a,"y"),c[2].setFromPointsField(a,"z"),this.invMatrix.copy(this.matrix).invert(),this.needsUpdate=!1}})();tn.prototype.intersectsBox=(function(){const n=new gi;return function(t){this.needsUpdate&&this.update();const i=t.min,a=t.max,s=this.satBounds,r=this.satAxes,o=this.alignedSatBounds;if(n.min=i.x,n.max=a.x,o[0].isSeparated(n)||(n.min=i.y,n.max=a.y,o[1].isSeparated(n))||(n.min=i.z,n.max=a.z,o[2].isSeparated(n)))return!1;for(let c=0;c<3;c++){const l=r[c],u=s[c];if(n.setFromBox(l,t),u.isSeparated(n))return!1}return!0}})();tn.prototype.intersectsTriangle=(function(){const n=new Fn,e=new Array(3),t=new gi,i=new gi,a=new U;return function(r){this.needsUpdate&&this.update(),r.isExtendedTriangle?r.needsUpdate&&r.update():(n.copy(r),n.update(),r=n);const o=this.satBounds,c=this.satAxes;e[0]=r.a,e[1]=r.b,e[2]=r.c;for(let d=0;d<3;d++){const f=o[d],g=c[d];if(t.setFromPoints(g,e),f.isSeparated(t))return!1}const l=r.satBounds,u=r.satAxes,h=this.points;for(let d=0;d<3;d++){const f=l[d],g=u[d];if(t.setFromPoints(g,h),f.isSeparated(t))return!1}for(let d=0;d<3;d++){const f=c[d];for(let g=0;g<4;g++){const y=u[g];if(a.crossVectors(f,y),t.setFromPoints(a,e),i.setFromPoints(a,h),t.isSeparated(i))return!1}}return!0}})();tn.prototype.closestPointToPoint=(function(){return function(e,t){return this.needsUpdate&&this.update(),t.copy(e).applyMatrix4(this.invMatrix).clamp(this.min,this.max).applyMatrix4(this.matrix),t}})();tn.prototype.distanceToPoint=(function(){const n=new U;return function(t){return this.closestPointToPoint(t,n),t.distanceTo(n)}})();tn.prototype.distanceToBox=(function(){const n=["x","y","z"],e=new Array(12).fill().map(()=>new $n),t=new Array(12).fill().map(()=>new $n),i=new U,a=new U;return function(r,o=0,c=null,l=null){if(this.needsUpdate&&this.update(),this.intersectsBox(r))return(c||l)&&(r.getCenter(a),this.closestPointToPoint(a,i),r.closestPointToPoint(i,a),c&&c.copy(i),l&&l.copy(a)),0;const u=o*o,h=r.min,d=r.max,f=this.points;let g=1/0;for(let p=0;p<8;p++){const m=f[p];a.copy(m).clamp(h,d);const b=m.distanceToSquared(a);if(b<g&&(g=b,c&&c.copy(m),l&&l.copy(a),b<u))return Math.sqrt(b)}let y=0;for(let p=0;p<3;p++)for(let m=0;m<=1;m++)for(let b=0;b<=1;b++){const x=(p+1)%3,v=(p+2)%3,M=m<<x|b<<v,w=1<<p|m<<x|b<<v,N=f[M],_=f[w];e[y].set(N,_);const T=n[p],I=n[x],C=n[v],L=t[y],F=L.start,P=L.end;F[T]=h[T],F[I]=m?h[I]:d[I],F[C]=b?h[C]:d[C],P[T]=d[T],P[I]=m?h[I]:d[I],P[C]=b?h[C]:d[C],y++}for(let p=0;p<=1;p++)for(let m=0;m<=1;m++)for(let b=0;b<=1;b++){a.x=p?d.x:h.x,a.y=m?d.y:h.y,a.z=b?d.z:h.z,this.closestPointToPoint(a,i);const x=a.distanceToSquared(i);if(x<g&&(g=x,c&&c.copy(i),l&&l.copy(a),x<u))return Math.sqrt(x)}for(let p=0;p<12;p++){const m=e[p];for(let b=0;b<12;b++){const x=t[b];Qd(m,x,i,a);const v=i.distanceToSquared(a);if(v<g&&(g=v,c&&c.copy(i),l&&l.copy(a),v<u))return Math.sqrt(v)}}return Math.sqrt(g)}})();class sI extends qd{constructor(){super(()=>new Fn)}}const Sn=new sI,ps=new U,Wc=new U;function rI(n,e,t={},i=0,a=1/0){const s=i*i,r=a*a;let o=1/0,c=null;if(n.shapecast({boundsTraverseOrder:u=>(ps.copy(e).clamp(u.min,u.max),ps.distanceToSquared(e)),intersectsBounds:(u,h,d)=>d<o&&d<r,intersectsTriangle:(u,h)=>{u.closestPointToPoint(e,ps);const d=e.distanceToSquared(ps);return d<o&&(Wc.copy(ps),o=d,c=h),d<s}}),o===1/0)return null;const l=Math.sqrt(o);return t.point?t.point.copy(Wc):t.point=Wc.clone(),t.distance=l,t.faceIndex=c,t}const Pr=parseInt("184")>=169,oI=parseInt("184")<=161,Hi=new U,ji=new U,Xi=new U,Lr=new we,Dr=new we,Or=new we,sp=new U,rp=new U,op=new U,ms=new U;function cI(n,e,t,i,a,s,r,o){let c;if(s===Qt?c=n.intersectTriangle(i,t,e,!0,a):c=n.intersectTriangle(e,t,i,s!==yn,a),c===null)return null;const l=n.origin.distanceTo(a);return l<r||l>o?null:{distance:l,point:a.clone()}}function cp(n,e,t,i,a,s,r,o,c,l,u){Hi.fromBufferAttribute(e,s),ji.fromBufferAttribute(e,r),Xi.fromBufferAttribute(e,o);const h=cI(n,Hi,ji,Xi,ms,c,l,u);if(h){if(i){Lr.fromBufferAttribute(i,s),Dr.fromBufferAttribute(i,r),Or.fromBufferAttribute(i,o),h.uv=new we;const f=Dt.getInterpolation(ms,Hi,ji,Xi,Lr,Dr,Or,h.uv);Pr||(h.uv=f)}if(a){Lr.fromBufferAttribute(a,s),Dr.fromBufferAttribute(a,r),Or.fromBufferAttribute(a,o),h.uv1=new we;const f=Dt.getInterpolation(ms,Hi,ji,Xi,Lr,Dr,Or,h.uv1);Pr||(h.uv1=f),oI&&(h.uv2=h.uv1)}if(t){sp.fromBufferAttribute(t,s),rp.fromBufferAttribute(t,r),op.fromBufferAttribute(t,o),h.normal=new U;const f=Dt.getInterpolation(ms,Hi,ji,Xi,sp,rp,op,h.normal);h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1),Pr||(h.normal=f)}const d={a:s,b:r,c:o,normal:new U,materialIndex:0};if(Dt.getNormal(Hi,ji,Xi,d.normal),h.face=d,h.faceIndex=s,Pr){const f=new U;Dt.getBarycoord(ms,Hi,ji,Xi,f),h.barycoord=f}}return h}function lp(n){return n&&n.isMaterial?n.side:n}function Uo(n,e,t,i,a,s,r){const o=i*3;let c=o+0,l=o+1,u=o+2;const{index:h,groups:d}=n;n.index&&(c=h.getX(c),l=h.getX(l),u=h.getX(u));const{position:f,normal:g,uv:y,uv1:p}=n.attributes;if(Array.isArray(e)){const m=i*3;for(let b=0,x=d.length;b<x;b++){const{start:v,count:M,materialIndex:w}=d[b];if(m>=v&&m<v+M){const N=lp(e[w]),_=cp(t,f,g,y,p,c,l,u,N,s,r);if(_)if(_.faceIndex=i,_.face.materialIndex=w,a)a.push(_);else return _}}}else{const m=lp(e),b=cp(t,f,g,y,p,c,l,u,m,s,r);if(b)if(b.faceIndex=i,b.face.materialIndex=0,a)a.push(b);else return b}return null}function wt(n,e,t,i){const a=n.a,s=n.b,r=n.c;let o=e,c=e+1,l=e+2;t&&(o=t.getX(o),c=t.getX(c),l=t.getX(l)),a.x=i.getX(o),a.y=i.getY(o),a.z=i.getZ(o),s.x=i.getX(c),s.y=i.getY(c),s.z=i.getZ(c),r.x=i.getX(l),r.y=i.getY(l),r.z=i.getZ(l)}function lI(n,e,t,i,a,s,r,o){const{geometry:c,_indirectBuffer:l}=n;for(let u=i,h=i+a;u<h;u++)Uo(c,e,t,u,s,r,o)}function dI(n,e,t,i,a,s,r){const{geometry:o,_indirectBuffer:c}=n;let l=1/0,u=null;for(let h=i,d=i+a;h<d;h++){let f;f=Uo(o,e,t,h,null,s,r),f&&f.distance<l&&(u=f,l=f.distance)}return u}function uI(n,e,t,i,a,s,r){const{geometry:o}=t,{index:c}=o,l=o.attributes.position;for(let u=n,h=e+n;u<h;u++){let d;if(d=u,wt(r,d*3,c,l),r.needsUpdate=!0,i(r,d,a,s))return!0}return!1}function hI(n,e=null){e&&Array.isArray(e)&&(e=new Set(e));const t=n.geometry,i=t.index?t.index.array:null,a=t.attributes.position;let s,r,o,c,l=0;const u=n._roots;for(let d=0,f=u.length;d<f;d++)s=u[d],r=new Uint32Array(s),o=new Uint16Array(s),c=new Float32Array(s),h(0,l),l+=s.byteLength;function h(d,f,g=!1){const y=d*2;if(Et(y,o)){const p=Ot(d,r),m=Zt(y,o);let b=1/0,x=1/0,v=1/0,M=-1/0,w=-1/0,N=-1/0;for(let _=3*p,S=3*(p+m);_<S;_++){let T=i[_];const I=a.getX(T),C=a.getY(T),L=a.getZ(T);I<b&&(b=I),I>M&&(M=I),C<x&&(x=C),C>w&&(w=C),L<v&&(v=L),L>N&&(N=L)}return c[d+0]!==b||c[d+1]!==x||c[d+2]!==v||c[d+3]!==M||c[d+4]!==w||c[d+5]!==N?(c[d+0]=b,c[d+1]=x,c[d+2]=v,c[d+3]=M,c[d+4]=w,c[d+5]=N,!0):!1}else{const p=Rt(d),m=Ct(d,r);let b=g,x=!1,v=!1;if(e){if(!b){const T=p/At+f/hn,I=m/At+f/hn;x=e.has(T),v=e.has(I),b=!x&&!v}}else x=!0,v=!0;const M=b||x,w=b||v;let N=!1;M&&(N=h(p,f,b));let _=!1;w&&(_=h(m,f,b));const S=N||_;if(S)for(let T=0;T<3;T++){const I=p+T,C=m+T,L=c[I],F=c[I+3],P=c[C],B=c[C+3];c[d+T]=L<P?L:P,c[d+T+3]=F>B?F:B}return S}}}function wn(n,e,t,i,a){let s,r,o,c,l,u;const h=1/t.direction.x,d=1/t.direction.y,f=1/t.direction.z,g=t.origin.x,y=t.origin.y,p=t.origin.z;let m=e[n],b=e[n+3],x=e[n+1],v=e[n+3+1],M=e[n+2],w=e[n+3+2];return h>=0?(s=(m-g)*h,r=(b-g)*h):(s=(b-g)*h,r=(m-g)*h),d>=0?(o=(x-y)*d,c=(v-y)*d):(o=(v-y)*d,c=(x-y)*d),s>c||o>r||((o>s||isNaN(s))&&(s=o),(c<r||isNaN(r))&&(r=c),f>=0?(l=(M-p)*f,u=(w-p)*f):(l=(w-p)*f,u=(M-p)*f),s>u||l>r)?!1:((l>s||s!==s)&&(s=l),(u<r||r!==r)&&(r=u),s<=a&&r>=i)}function fI(n,e,t,i,a,s,r,o){const{geometry:c,_indirectBuffer:l}=n;for(let u=i,h=i+a;u<h;u++){let d=l?l[u]:u;Uo(c,e,t,d,s,r,o)}}function pI(n,e,t,i,a,s,r){const{geometry:o,_indirectBuffer:c}=n;let l=1/0,u=null;for(let h=i,d=i+a;h<d;h++){let f;f=Uo(o,e,t,c?c[h]:h,null,s,r),f&&f.distance<l&&(u=f,l=f.distance)}return u}function mI(n,e,t,i,a,s,r){const{geometry:o}=t,{index:c}=o,l=o.attributes.position;for(let u=n,h=e+n;u<h;u++){let d;if(d=t.resolveTriangleIndex(u),wt(r,d*3,c,l),r.needsUpdate=!0,i(r,d,a,s))return!0}return!1}function gI(n,e,t,i,a,s,r){tt.setBuffer(n._roots[e]),wn(0,tt.float32Array,i,s,r)&&Ql(0,n,t,i,a,s,r),tt.clearBuffer()}function Ql(n,e,t,i,a,s,r){const{float32Array:o,uint16Array:c,uint32Array:l}=tt,u=n*2;if(Et(u,c)){const d=Ot(n,l),f=Zt(u,c);lI(e,t,i,d,f,a,s,r)}else{const d=Rt(n);wn(d,o,i,s,r)&&Ql(d,e,t,i,a,s,r);const f=Ct(n,l);wn(f,o,i,s,r)&&Ql(f,e,t,i,a,s,r)}}const bI=["x","y","z"];function _I(n,e,t,i,a,s){tt.setBuffer(n._roots[e]);let r=null;return wn(0,tt.float32Array,i,a,s)&&(r=ed(0,n,t,i,a,s)),tt.clearBuffer(),r}function ed(n,e,t,i,a,s){const{float32Array:r,uint16Array:o,uint32Array:c}=tt;let l=n*2;if(Et(l,o)){const h=Ot(n,c),d=Zt(l,o);return dI(e,t,i,h,d,a,s)}else{const h=Kd(n,c),d=bI[h],g=i.direction[d]>=0;let y,p;g?(y=Rt(n),p=Ct(n,c)):(y=Ct(n,c),p=Rt(n));const b=wn(y,r,i,a,s)?ed(y,e,t,i,a,s):null;if(b){const M=b.point[d];if(g?M<=r[p+h]:M>=r[p+h+3])return b}const v=wn(p,r,i,a,s)?ed(p,e,t,i,a,s):null;return b&&v?b.distance<=v.distance?b:v:b||v||null}}const Fr=new kt,Pa=new Fn,La=new Fn,gs=new qe,dp=new tn,kr=new tn;function vI(n,e,t,i){tt.setBuffer(n._roots[e]);const a=td(0,n,t,i);return tt.clearBuffer(),a}function td(n,e,t,i,a=null){const{float32Array:s,uint16Array:r,uint32Array:o}=tt;let c=n*2;if(a===null&&(t.boundingBox||t.computeBoundingBox(),dp.set(t.boundingBox.min,t.boundingBox.max,i),a=dp),Et(c,r)){const u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,g=t.attributes.position,y=Ot(n,o),p=Zt(c,r);if(gs.copy(i).invert(),t.boundsTree)return bt(n,s,kr),kr.matrix.copy(gs),kr.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:b=>kr.intersectsBox(b),intersectsTriangle:b=>{b.a.applyMatrix4(i),b.b.applyMatrix4(i),b.c.applyMatrix4(i),b.needsUpdate=!0;for(let x=y*3,v=(p+y)*3;x<v;x+=3)if(wt(La,x,h,d),La.needsUpdate=!0,b.intersectsTriangle(La))return!0;return!1}});{const m=Co(t);for(let b=y*3,x=(p+y)*3;b<x;b+=3){wt(Pa,b,h,d),Pa.a.applyMatrix4(gs),Pa.b.applyMatrix4(gs),Pa.c.applyMatrix4(gs),Pa.needsUpdate=!0;for(let v=0,M=m*3;v<M;v+=3)if(wt(La,v,f,g),La.needsUpdate=!0,Pa.intersectsTriangle(La))return!0}}}else{const u=Rt(n),h=Ct(n,o);return bt(u,s,Fr),!!(a.intersectsBox(Fr)&&td(u,e,t,i,a)||(bt(h,s,Fr),a.intersectsBox(Fr)&&td(h,e,t,i,a)))}}const Br=new qe,Hc=new tn,bs=new tn,yI=new U,xI=new U,EI=new U,SI=new U;function MI(n,e,t,i={},a={},s=0,r=1/0){e.boundingBox||e.computeBoundingBox(),Hc.set(e.boundingBox.min,e.boundingBox.max,t),Hc.needsUpdate=!0;const o=n.geometry,c=o.attributes.position,l=o.index,u=e.attributes.position,h=e.index,d=Sn.getPrimitive(),f=Sn.getPrimitive();let g=yI,y=xI,p=null,m=null;a&&(p=EI,m=SI);let b=1/0,x=null,v=null;return Br.copy(t).invert(),bs.matrix.copy(Br),n.shapecast({boundsTraverseOrder:M=>Hc.distanceToBox(M),intersectsBounds:(M,w,N)=>N<b&&N<r?(w&&(bs.min.copy(M.min),bs.max.copy(M.max),bs.needsUpdate=!0),!0):!1,intersectsRange:(M,w)=>{if(e.boundsTree)return e.boundsTree.shapecast({boundsTraverseOrder:_=>bs.distanceToBox(_),intersectsBounds:(_,S,T)=>T<b&&T<r,intersectsRange:(_,S)=>{for(let T=_,I=_+S;T<I;T++){wt(f,3*T,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let C=M,L=M+w;C<L;C++){wt(d,3*C,l,c),d.needsUpdate=!0;const F=d.distanceToTriangle(f,g,p);if(F<b&&(y.copy(g),m&&m.copy(p),b=F,x=C,v=T),F<s)return!0}}}});{const N=Co(e);for(let _=0,S=N;_<S;_++){wt(f,3*_,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let T=M,I=M+w;T<I;T++){wt(d,3*T,l,c),d.needsUpdate=!0;const C=d.distanceToTriangle(f,g,p);if(C<b&&(y.copy(g),m&&m.copy(p),b=C,x=T,v=_),C<s)return!0}}}}}),Sn.releasePrimitive(d),Sn.releasePrimitive(f),b===1/0?null:(i.point?i.point.copy(y):i.point=y.clone(),i.distance=b,i.faceIndex=x,a&&(a.point?a.point.copy(m):a.point=m.clone(),a.point.applyMatrix4(Br),y.applyMatrix4(Br),a.distance=y.sub(a.point).length(),a.faceIndex=v),i)}function AI(n,e=null){e&&Array.isArray(e)&&(e=new Set(e));const t=n.geometry,i=t.index?t.index.array:null,a=t.attributes.position;let s,r,o,c,l=0;const u=n._roots;for(let d=0,f=u.length;d<f;d++)s=u[d],r=new Uint32Array(s),o=new Uint16Array(s),c=new Float32Array(s),h(0,l),l+=s.byteLength;function h(d,f,g=!1){const y=d*2;if(Et(y,o)){const p=Ot(d,r),m=Zt(y,o);let b=1/0,x=1/0,v=1/0,M=-1/0,w=-1/0,N=-1/0;for(let _=p,S=p+m;_<S;_++){const T=3*n.resolveTriangleIndex(_);for(let I=0;I<3;I++){let C=T+I;C=i?i[C]:C;const L=a.getX(C),F=a.getY(C),P=a.getZ(C);L<b&&(b=L),L>M&&(M=L),F<x&&(x=F),F>w&&(w=F),P<v&&(v=P),P>N&&(N=P)}}return c[d+0]!==b||c[d+1]!==x||c[d+2]!==v||c[d+3]!==M||c[d+4]!==w||c[d+5]!==N?(c[d+0]=b,c[d+1]=x,c[d+2]=v,c[d+3]=M,c[d+4]=w,c[d+5]=N,!0):!1}else{const p=Rt(d),m=Ct(d,r);let b=g,x=!1,v=!1;if(e){if(!b){const T=p/At+f/hn,I=m/At+f/hn;x=e.has(T),v=e.has(I),b=!x&&!v}}else x=!0,v=!0;const M=b||x,w=b||v;let N=!1;M&&(N=h(p,f,b));let _=!1;w&&(_=h(m,f,b));const S=N||_;if(S)for(let T=0;T<3;T++){const I=p+T,C=m+T,L=c[I],F=c[I+3],P=c[C],B=c[C+3];c[d+T]=L<P?L:P,c[d+T+3]=F>B?F:B}return S}}}function wI(n,e,t,i,a,s,r){tt.setBuffer(n._roots[e]),wn(0,tt.float32Array,i,s,r)&&nd(0,n,t,i,a,s,r),tt.clearBuffer()}function nd(n,e,t,i,a,s,r){const{float32Array:o,uint16Array:c,uint32Array:l}=tt,u=n*2;if(Et(u,c)){const d=Ot(n,l),f=Zt(u,c);fI(e,t,i,d,f,a,s,r)}else{const d=Rt(n);wn(d,o,i,s,r)&&nd(d,e,t,i,a,s,r);const f=Ct(n,l);wn(f,o,i,s,r)&&nd(f,e,t,i,a,s,r)}}const TI=["x","y","z"];function II(n,e,t,i,a,s){tt.setBuffer(n._roots[e]);let r=null;return wn(0,tt.float32Array,i,a,s)&&(r=id(0,n,t,i,a,s)),tt.clearBuffer(),r}function id(n,e,t,i,a,s){const{float32Array:r,uint16Array:o,uint32Array:c}=tt;let l=n*2;if(Et(l,o)){const h=Ot(n,c),d=Zt(l,o);return pI(e,t,i,h,d,a,s)}else{const h=Kd(n,c),d=TI[h],g=i.direction[d]>=0;let y,p;g?(y=Rt(n),p=Ct(n,c)):(y=Ct(n,c),p=Rt(n));const b=wn(y,r,i,a,s)?id(y,e,t,i,a,s):null;if(b){const M=b.point[d];if(g?M<=r[p+h]:M>=r[p+h+3])return b}const v=wn(p,r,i,a,s)?id(p,e,t,i,a,s):null;return b&&v?b.distance<=v.distance?b:v:b||v||null}}const Vr=new kt,Da=new Fn,Oa=new Fn,_s=new qe,up=new tn,zr=new tn;function NI(n,e,t,i){tt.setBuffer(n._roots[e]);const a=ad(0,n,t,i);return tt.clearBuffer(),a}function ad(n,e,t,i,a=null){const{float32Array:s,uint16Array:r,uint32Array:o}=tt;let c=n*2;if(a===null&&(t.boundingBox||t.computeBoundingBox(),up.set(t.boundingBox.min,t.boundingBox.max,i),a=up),Et(c,r)){const u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,g=t.attributes.position,y=Ot(n,o),p=Zt(c,r);if(_s.copy(i).invert(),t.boundsTree)return bt(n,s,zr),zr.matrix.copy(_s),zr.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:b=>zr.intersectsBox(b),intersectsTriangle:b=>{b.a.applyMatrix4(i),b.b.applyMatrix4(i),b.c.applyMatrix4(i),b.needsUpdate=!0;for(let x=y,v=p+y;x<v;x++)if(wt(Oa,3*e.resolveTriangleIndex(x),h,d),Oa.needsUpdate=!0,b.intersectsTriangle(Oa))return!0;return!1}});{const m=Co(t);for(let b=y,x=p+y;b<x;b++){const v=e.resolveTriangleIndex(b);wt(Da,3*v,h,d),Da.a.applyMatrix4(_s),Da.b.applyMatrix4(_s),Da.c.applyMatrix4(_s),Da.needsUpdate=!0;for(let M=0,w=m*3;M<w;M+=3)if(wt(Oa,M,f,g),Oa.needsUpdate=!0,Da.intersectsTriangle(Oa))return!0}}}else{const u=Rt(n),h=Ct(n,o);return bt(u,s,Vr),!!(a.intersectsBox(Vr)&&ad(u,e,t,i,a)||(bt(h,s,Vr),a.intersectsBox(Vr)&&ad(h,e,t,i,a)))}}const Gr=new qe,jc=new tn,vs=new tn,RI=new U,CI=new U,UI=new U,PI=new U;function LI(n,e,t,i={},a={},s=0,r=1/0){e.boundingBox||e.computeBoundingBox(),jc.set(e.boundingBox.min,e.boundingBox.max,t),jc.needsUpdate=!0;const o=n.geometry,c=o.attributes.position,l=o.index,u=e.attributes.position,h=e.index,d=Sn.getPrimitive(),f=Sn.getPrimitive();let g=RI,y=CI,p=null,m=null;a&&(p=UI,m=PI);let b=1/0,x=null,v=null;return Gr.copy(t).invert(),vs.matrix.copy(Gr),n.shapecast({boundsTraverseOrder:M=>jc.distanceToBox(M),intersectsBounds:(M,w,N)=>N<b&&N<r?(w&&(vs.min.copy(M.min),vs.max.copy(M.max),vs.needsUpdate=!0),!0):!1,intersectsRange:(M,w)=>{if(e.boundsTree){const N=e.boundsTree;return N.shapecast({boundsTraverseOrder:_=>vs.distanceToBox(_),intersectsBounds:(_,S,T)=>T<b&&T<r,intersectsRange:(_,S)=>{for(let T=_,I=_+S;T<I;T++){const C=N.resolveTriangleIndex(T);wt(f,3*C,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let L=M,F=M+w;L<F;L++){const P=n.resolveTriangleIndex(L);wt(d,3*P,l,c),d.needsUpdate=!0;const B=d.distanceToTriangle(f,g,p);if(B<b&&(y.copy(g),m&&m.copy(p),b=B,x=L,v=T),B<s)return!0}}}})}else{const N=Co(e);for(let _=0,S=N;_<S;_++){wt(f,3*_,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let T=M,I=M+w;T<I;T++){const C=n.resolveTriangleIndex(T);wt(d,3*C,l,c),d.needsUpdate=!0;const L=d.distanceToTriangle(f,g,p);if(L<b&&(y.copy(g),m&&m.copy(p),b=L,x=T,v=_),L<s)return!0}}}}}),Sn.releasePrimitive(d),Sn.releasePrimitive(f),b===1/0?null:(i.point?i.point.copy(y):i.point=y.clone(),i.distance=b,i.faceIndex=x,a&&(a.point?a.point.copy(m):a.point=m.clone(),a.point.applyMatrix4(Gr),y.applyMatrix4(Gr),a.distance=y.sub(a.point).length(),a.faceIndex=v),i)}function hp(n,e,t){return n===null?null:(n.point.applyMatrix4(e.matrixWorld),n.distance=n.point.distanceTo(t.ray.origin),n.object=e,n)}const Wr=new tn,Hr=new Ws,fp=new U,pp=new qe,mp=new U,Xc=["getX","getY","getZ"];class _o extends tI{static serialize(e,t={}){t={cloneBuffers:!0,...t};const i=e.geometry,a=e._roots,s=e._indirectBuffer,r=i.getIndex(),o={version:1,roots:null,index:null,indirectBuffer:null};return t.cloneBuffers?(o.roots=a.map(c=>c.slice()),o.index=r?r.array.slice():null,o.indirectBuffer=s?s.slice():null):(o.roots=a,o.index=r?r.array:null,o.indirectBuffer=s),o}static deserialize(e,t,i={}){i={setIndex:!0,indirect:!!e.indirectBuffer,...i};const{index:a,roots:s,indirectBuffer:r}=e;e.version||(console.warn("MeshBVH.deserialize: Serialization format has been changed and will be fixed up. It is recommended to regenerate any stored serialized data."),c(s));const o=new _o(t,{...i,[Zd]:!0});if(o._roots=s,o._indirectBuffer=r||null,i.setIndex){const l=t.getIndex();if(l===null){const u=new St(e.index,1,!1);t.setIndex(u)}else l.array!==a&&(l.array.set(a),l.needsUpdate=!0)}return o;function c(l){for(let u=0;u<l.length;u++){const h=l[u],d=new Uint32Array(h),f=new Uint16Array(h);for(let g=0,y=h.byteLength/hn;g<y;g++){const p=At*g,m=2*p;Et(m,f)||(d[p+6]=d[p+6]/At-g)}}}}get primitiveStride(){return 3}get resolveTriangleIndex(){return this.resolvePrimitiveIndex}constructor(e,t={}){t.maxLeafTris&&(console.warn('MeshBVH: "maxLeafTris" option has been deprecated. Use "targetLeafSize", instead.'),t={...t,targetLeafSize:t.maxLeafTris}),super(e,t)}shiftTriangleOffsets(e){return super.shiftPrimitiveOffsets(e)}writePrimitiveBounds(e,t,i){const a=this.geometry,s=this._indirectBuffer,r=a.attributes.position,o=a.index?a.index.array:null,l=(s?s[e]:e)*3;let u=l+0,h=l+1,d=l+2;o&&(u=o[u],h=o[h],d=o[d]);for(let f=0;f<3;f++){const g=r[Xc[f]](u),y=r[Xc[f]](h),p=r[Xc[f]](d);let m=g;y<m&&(m=y),p<m&&(m=p);let b=g;y>b&&(b=y),p>b&&(b=p),t[i+f]=m,t[i+f+3]=b}return t}computePrimitiveBounds(e,t,i){const a=this.geometry,s=this._indirectBuffer,r=a.attributes.position,o=a.index?a.index.array:null,c=r.normalized;if(e<0||t+e-i.offset>i.length/6)throw new Error("MeshBVH: compute triangle bounds range is invalid.");const l=r.array,u=r.offset||0;let h=3;r.isInterleavedBufferAttribute&&(h=r.data.stride);const d=["getX","getY","getZ"],f=i.offset;for(let g=e,y=e+t;g<y;g++){const m=(s?s[g]:g)*3,b=(g-f)*6;let x=m+0,v=m+1,M=m+2;o&&(x=o[x],v=o[v],M=o[M]),c||(x=x*h+u,v=v*h+u,M=M*h+u);for(let w=0;w<3;w++){let N,_,S;c?(N=r[d[w]](x),_=r[d[w]](v),S=r[d[w]](M)):(N=l[x+w],_=l[v+w],S=l[M+w]);let T=N;_<T&&(T=_),S<T&&(T=S);let I=N;_>I&&(I=_),S>I&&(I=S);const C=(I-T)/2,L=w*2;i[b+L+0]=T+C,i[b+L+1]=C+(Math.abs(T)+C)*to}}return i}raycastObject3D(e,t,i=[]){const{material:a}=e;if(a===void 0)return;pp.copy(e.matrixWorld).invert(),Hr.copy(t.ray).applyMatrix4(pp),mp.setFromMatrixScale(e.matrixWorld),fp.copy(Hr.direction).multiply(mp);const s=fp.length(),r=t.near/s,o=t.far/s;if(t.firstHitOnly===!0){let c=this.raycastFirst(Hr,a,r,o);c=hp(c,e,t),c&&i.push(c)}else{const c=this.raycast(Hr,a,r,o);for(let l=0,u=c.length;l<u;l++){const h=hp(c[l],e,t);h&&i.push(h)}}return i}refit(e=null){return(this.indirect?AI:hI)(this,e)}raycast(e,t=qn,i=0,a=1/0){const s=this._roots,r=[],o=this.indirect?wI:gI;for(let c=0,l=s.length;c<l;c++)o(this,c,t,e,r,i,a);return r}raycastFirst(e,t=qn,i=0,a=1/0){const s=this._roots;let r=null;const o=this.indirect?II:_I;for(let c=0,l=s.length;c<l;c++){const u=o(this,c,t,e,i,a);u!=null&&(r==null||u.distance<r.distance)&&(r=u)}return r}intersectsGeometry(e,t){let i=!1;const a=this._roots,s=this.indirect?NI:vI;for(let r=0,o=a.length;r<o&&(i=s(this,r,e,t),!i);r++);return i}shapecast(e){const t=Sn.getPrimitive(),i=super.shapecast({...e,intersectsPrimitive:e.intersectsTriangle,scratchPrimitive:t,iterate:this.indirect?mI:uI});return Sn.releasePrimitive(t),i}bvhcast(e,t,i){let{intersectsRanges:a,intersectsTriangles:s}=i;const r=Sn.getPrimitive(),o=this.geometry.index,c=this.geometry.attributes.position,l=this.indirect?g=>{const y=this.resolveTriangleIndex(g);wt(r,y*3,o,c)}:g=>{wt(r,g*3,o,c)},u=Sn.getPrimitive(),h=e.geometry.index,d=e.geometry.attributes.position,f=e.indirect?g=>{const y=e.resolveTriangleIndex(g);wt(u,y*3,h,d)}:g=>{wt(u,g*3,h,d)};if(s){if(!(e instanceof _o))throw new Error('MeshBVH: "intersectsTriangles" callback can only be used with another MeshBVH.');const g=(y,p,m,b,x,v,M,w)=>{for(let N=m,_=m+b;N<_;N++){f(N),u.a.applyMatrix4(t),u.b.applyMatrix4(t),u.c.applyMatrix4(t),u.needsUpdate=!0;for(let S=y,T=y+p;S<T;S++)if(l(S),r.needsUpdate=!0,s(r,u,S,N,x,v,M,w))return!0}return!1};if(a){const y=a;a=function(p,m,b,x,v,M,w,N){return y(p,m,b,x,v,M,w,N)?!0:g(p,m,b,x,v,M,w,N)}}else a=g}return super.bvhcast(e,t,{intersectsRanges:a})}intersectsBox(e,t){return Wr.set(e.min,e.max,t),Wr.needsUpdate=!0,this.shapecast({intersectsBounds:i=>Wr.intersectsBox(i),intersectsTriangle:i=>Wr.intersectsTriangle(i)})}intersectsSphere(e){return this.shapecast({intersectsBounds:t=>e.intersectsBox(t),intersectsTriangle:t=>t.intersectsSphere(e)})}closestPointToGeometry(e,t,i={},a={},s=0,r=1/0){return(this.indirect?LI:MI)(this,e,t,i,a,s,r)}closestPointToPoint(e,t={},i=0,a=1/0){return rI(this,e,t,i,a)}}class DI{constructor(e){this.mesh=e,this.tree=new _o(e.geometry,{indirect:!0})}mesh;tree;caster=new _0;pick(e,t){this.caster.setFromCamera(e,t);const i=this.tree.raycastFirst(this.caster.ray,yn);if(i?.faceIndex==null)return;const a=i.faceIndex;return{place:{kind:"face",face:a,weights:this.weightsAt(a,i.point)},point:i.point}}weightsAt(e,t){const i=this.mesh.geometry.getAttribute("position"),a=this.mesh.cornersOf(e).map(c=>new U().fromBufferAttribute(i,c)),s=new U;if(!Dt.getBarycoord(t,a[0],a[1],a[2],s))return[1,0,0];const r=s.toArray().map(c=>Math.max(c,0)),o=r[0]+r[1]+r[2];return[r[0]/o,r[1]/o,r[2]/o]}}const jr=.12,gp=1.15,OI=8,FI=12,kI=.03,BI=150,VI=.002;function zI(n,e,t){const i=Ae("picture");let a,s=[],r={x:0,y:0},o,c;const l=new UT;let u,h;const d=S=>a?.pick(n.pointerAt(S.x,S.y),n.camera),f=S=>{const{camera:T}=n,{x:I,y:C}=S.clone().project(T),L=a?.pick(new we(I,C),T);return!(L&&L.point.distanceTo(T.position)<S.distanceTo(T.position)-VI)},g=S=>{const T=i.getBoundingClientRect();return e.sourcesOnScreen().findIndex(I=>{if(!I)return!1;const C=n.pixelOf(I);return Math.hypot(T.left+C.x-S.x,T.top+C.y-S.y)<FI&&f(I)})},y=(S,T)=>{u={field:e.field,summary:e.summary,view:n.camera.matrixWorld.clone()},i.classList.toggle("grab",g(S)>=0),e.hover(d(S)?.place,T)},p=(S,T)=>{c=S,t.pointer(S),y(S,T)},m=(S,T)=>{const I=d(S)?.place;I&&(T?e.setSources([...e.sources,I]):t.tool==="path"&&e.sources.length?e.keepPath(I):e.setSources([I]),e.sources.length===1&&t.tool==="source"&&t.choose("path"))},b=S=>{const T={};return{drag:I=>e.moveSource(S,I,T),drop:()=>e.dropSource(),cancel:()=>e.cancel(T)}},x=S=>{const T=e.sources[S];if(e.straightLength===void 0||"curve"in T)return;let I;return{drag:(C,L)=>{I=C,e.leadStraight(T,C,L)},drop:()=>{I&&e.keepStraight(T,I)},cancel:()=>e.hover(void 0,0)}},v=LT(i,{move:S=>{l.hide(),p(S,S.since)},leave:()=>{l.point||(c=void 0,e.hover(void 0,0))},click:S=>{l.hide(),m(S,S.shift)},drawsCurve:S=>(s=[],o=void 0,e.mesh!==void 0&&(S||t.tool==="curve")),grabs:S=>{const T=g(S);return o=T<0?void 0:t.tool==="straight"?x(T):b(T),o!==void 0},drag:S=>{const T=d(S)?.place;T&&o?.drag(T,S.since),t.pointer(S)},dropped:()=>o?.drop(),draw:S=>{if(s.length&&Math.hypot(S.x-r.x,S.y-r.y)<OI)return;const T=d(S);T&&(r=S,s.push(T),e.drawSketch(s.map(({point:I})=>I)))},drawn:()=>{e.addCurve(s.map(({place:S})=>S),t.tool==="curve"),s=[]},wheel:S=>{const T=e.field?.largest??0;T>0&&t.setRadius((e.radius??T)-S*kI*T)},setTurning:S=>n.setTurning(S)}),M=(S,T)=>p(l.move(S,T),performance.now()),w=S=>{l.point?m(l.point,S):M(0,0)},_={ArrowLeft:()=>n.turn(jr,0,1),ArrowRight:()=>n.turn(-jr,0,1),ArrowUp:()=>n.turn(0,jr,1),ArrowDown:()=>n.turn(0,-jr,1),"+":()=>n.turn(0,0,1/gp),"-":()=>n.turn(0,0,gp),Backspace:()=>e.removeLast(),Escape:()=>{if(v.cancel()){s=[],e.drawSketch([]),o?.cancel();return}l.point&&(l.hide(),c=void 0,e.hover(void 0,0)),(t.tool==="curve"||t.tool==="straight")&&t.chooseNext()},s:()=>t.choose("source"),p:()=>t.choose("path"),c:()=>t.choose("curve"),d:()=>t.choose("straight"),i:()=>t.toggleIsolines(),t:()=>t.toggleTheme(),l:()=>n.lookAtAll(),"?":()=>t.help(),Enter:()=>w(!1),"Shift+ArrowLeft":()=>M(-1,0),"Shift+ArrowRight":()=>M(1,0),"Shift+ArrowUp":()=>M(0,-1),"Shift+ArrowDown":()=>M(0,1),"Shift+Enter":()=>w(!0),"Control+z":()=>t.undo(),"Control+Shift+z":()=>t.redo(),"Control+y":()=>t.redo()};return document.addEventListener("keydown",S=>{if(DT(S)||document.querySelector("dialog[open]"))return;const T=S.key.length===1?S.key.toLowerCase():S.key,I=S.ctrlKey||S.metaKey,C=(I?"Control+":"")+(S.shiftKey?"Shift+":""),L=_[C+T]??(I?void 0:_[T]);L&&(S.preventDefault(),L())}),{show:S=>a=new DI(S),isSeen:f,changed:()=>{if(!c||!u)return;const S=!n.camera.matrixWorld.equals(u.view);!S&&u.field===e.field&&u.summary===e.summary||(S&&e.hover(void 0,0),clearTimeout(h),h=setTimeout(()=>{c&&!e.fields.isWaiting&&y(c,performance.now())},BI))}}}function GI(n){return"target"in n?Ka({curve:[n.from,n.target]}):`${Ha(n.from)};straight:${n.direction.join(",")}@${n.length}`}function WI(n){const[e,t,...i]=n.split(";"),a=Wl(e);if(!a||t===void 0||i.length)return;const s=/^straight:([\d.e+-]+),([\d.e+-]+),([\d.e+-]+)@([\d.e+-]+)$/.exec(t);if(s){const[o,c,l,u]=s.slice(1).map(Number);return[o,c,l,u].every(Number.isFinite)&&u>0?{from:a,direction:[o,c,l],length:u}:void 0}const r=Wl(t);return r&&{from:a,target:r}}const bp="geodesic.token",HI=/^[!-~]{1,4096}$/,jI=100,XI=/^[0-9a-f]{64}$/;class YI{constructor(e){this.wrong=e,this.read()}wrong;mesh="";token="";sources=[];paths=[];radius=null;shown;wanted;pause;read(){this.wanted=void 0;const e=new URLSearchParams(location.hash.slice(1)),t=e.get("mesh")??"",i=e.get("token");this.mesh=XI.test(t)?t:"",this.sources=e.getAll("source"),this.paths=e.getAll("path"),this.radius=e.get("radius");let a;return t&&!this.mesh&&(a="The address names no mesh: a mesh has 64 digits and letters from a to f."),i&&HI.test(i)?this.keepToken(i):i&&(a="The token in the address is none: it has letters, digits and signs only."),this.token=sessionStorage.getItem(bp)??"",i!==null&&(e.delete("token"),history.replaceState(null,"",`#${e}`)),a&&this.wrong(a),!a}keepToken(e){sessionStorage.setItem(bp,e)}questionOn(e){if(e.digest!==this.mesh)return{sources:[],paths:[]};const t=c=>c!==void 0&&e.holdsSource(c),i=this.sources.splice(0),a=i.map(OS).filter(t);a.length<i.length&&this.wrong("The address names a source that is no place of this mesh.");const s=this.paths.splice(0),r=s.map(WI).filter(c=>c!==void 0&&e.holdsLine(c));r.length<s.length&&this.wrong("The address names a path that is none of this mesh.");const o=this.radius===null?void 0:parseFloat(this.radius);return this.radius=null,o===void 0||Number.isFinite(o)&&o>=0?{sources:a,paths:r,radius:o}:(this.wrong("The address names a radius that is no length."),{sources:a,paths:r})}show({mesh:e,sources:t,paths:i,awaitedPaths:a,radius:s}){if(!e)return;const r=new URLSearchParams({mesh:e.digest});for(const o of t)r.append("source",Ka(o));for(const o of[...i.map(({question:c})=>c),...a])r.append("path",GI(o));if(s!==void 0&&r.set("radius",String(s)),this.shown!==void 0&&this.shown!==e.digest){this.write();const{hash:o}=location;new URLSearchParams(o.slice(1)).get("mesh")!==e.digest&&history.pushState(null,"",o)}this.shown=e.digest,this.wanted=`#${r}`,this.pause===void 0&&this.write()}write(){const{wanted:e}=this;clearTimeout(this.pause),this.pause=this.wanted=void 0,!(e===void 0||e===location.hash)&&(history.replaceState(null,"",e),this.pause=setTimeout(()=>this.write(),jI))}}const ki=new Aw,vn=new YI(n=>ki.error(n)),vi=JI(),ZI=new eT((n,e)=>vi.setBackground(e,n)),Zs=new gA(location.origin,vn.token),Po=new Qw(Zs,ki,n=>vn.keepToken(n)),bi=new qA(vi,Zs,{changed:()=>{es.update(),eu.update(),vn.show(bi),Do.changed()},value:(n,e)=>es.value(n,e),failed:(n,e)=>Po.handle(n,e),told:n=>ki.hint(n),lost:n=>Lo.restore(n.digest)}),eu=new Xw(bi,vi,n=>Do.isSeen(n));vi.onLost=()=>ki.error("The graphics processor is away. The picture comes back with it.");vi.onRestored=()=>ki.clear();vi.onSurface=()=>{eu.update(),Do.changed()};const es=new jw(bi,vi,Zs,ki,ZI,eu),Ng=(n,e)=>{const{sources:t,paths:i,radius:a}=vn.questionOn(n);bi.ask(t,i,a,e),es.chooseNext()},KI=n=>{const e=bi.mesh?.digest===n.digest;bi.show(n),Do.show(n),es.show(n),e||Ng(n,!1)},Lo=new Sw(Zs,ki,Po,vi.coarseFaces,KI,(n,e)=>bi.showCoarse(n,e)),Do=zI(vi,bi,es);Po.attempt(async()=>{await es.showCapabilities(),await Lo.list()});vn.mesh&&Lo.openDigest(vn.mesh);addEventListener("hashchange",()=>{const{token:n}=Zs,e=vn.read();vn.token!==n&&Po.goOnWith(vn.token);const{mesh:t}=bi;e&&(t&&t.digest===vn.mesh?Ng(t,!0):vn.mesh&&Lo.openDigest(vn.mesh))});function JI(){try{return new RT(Ae("picture"))}catch(n){throw Ae("welcome").hidden=!0,ki.error(IT),n}}
