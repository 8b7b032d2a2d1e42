/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Os={ROTATE:0,DOLLY:1,PAN:2},Fs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Ig=0,uh=1,Cg=2,Za=1,Pg=2,_r=3,qn=0,Qt=1,yn=2,hi=0,Vs=1,hh=2,fh=3,dh=4,Lg=5,$i=100,Dg=101,Ug=102,Fg=103,Bg=104,Og=200,Vg=201,kg=202,Gg=203,Yc=204,Kc=205,zg=206,Wg=207,Hg=208,Xg=209,Zg=210,Yg=211,Kg=212,$g=213,Jg=214,$c=0,no=1,Jc=2,ts=3,jc=4,qc=5,io=6,Qc=7,xp=0,jg=1,qg=2,jn=0,yp=1,bp=2,Sp=3,Ep=4,Mp=5,Ap=6,wp=7,Tp=300,ns=301,Ws=302,Oo=303,Vo=304,yo=306,el=1e3,li=1001,tl=1002,Wt=1003,Qg=1004,Jr=1005,Ht=1006,ko=1007,ji=1008,bn=1009,Rp=1010,Np=1011,Tr=1012,su=1013,Fn=1014,$n=1015,pi=1016,ru=1017,au=1018,Rr=1020,Ip=35902,Cp=35899,Pp=1021,Lp=1022,Sn=1023,mi=1026,qi=1027,Dp=1028,ou=1029,is=1030,cu=1031,lu=1033,Ya=33776,Ka=33777,$a=33778,Ja=33779,nl=35840,il=35841,sl=35842,rl=35843,al=36196,ol=37492,cl=37496,ll=37488,ul=37489,so=37490,hl=37491,fl=37808,dl=37809,pl=37810,ml=37811,gl=37812,_l=37813,vl=37814,xl=37815,yl=37816,bl=37817,Sl=37818,El=37819,Ml=37820,Al=37821,wl=36492,Tl=36494,Rl=36495,Nl=36283,Il=36284,ro=36285,Cl=36286,e0=3200,ph=0,t0=1,Pi="",_n="srgb",Nr="srgb-linear",ao="linear",Qe="srgb",ls=7680,mh=519,n0=512,i0=513,s0=514,uu=515,r0=516,a0=517,hu=518,o0=519,Pl=35044,c0=35048,gh="300 es",Jn=2e3,oo=2001;function l0(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function co(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function u0(){const n=co("canvas");return n.style.display="block",n}const _h={};function lo(...n){const e="THREE."+n.shift();console.log(e,...n)}function Up(n){const e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){const t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ne(...n){n=Up(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function Ze(...n){n=Up(n);const e="THREE."+n.shift();{const t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Ll(...n){const e=n.join(" ");e in _h||(_h[e]=!0,Ne(...n))}function h0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}const f0={[$c]:no,[Jc]:io,[jc]:Qc,[ts]:qc,[no]:$c,[io]:Jc,[Qc]:jc,[qc]:ts};class Oi{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){const i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){const i=this._listeners;if(i===void 0)return;const s=i[e];if(s!==void 0){const r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){const t=this._listeners;if(t===void 0)return;const i=t[e.type];if(i!==void 0){e.target=this;const s=i.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}}const Zt=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];let vh=1234567;const yr=Math.PI/180,Ir=180/Math.PI;function fi(){const n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Zt[n&255]+Zt[n>>8&255]+Zt[n>>16&255]+Zt[n>>24&255]+"-"+Zt[e&255]+Zt[e>>8&255]+"-"+Zt[e>>16&15|64]+Zt[e>>24&255]+"-"+Zt[t&63|128]+Zt[t>>8&255]+"-"+Zt[t>>16&255]+Zt[t>>24&255]+Zt[i&255]+Zt[i>>8&255]+Zt[i>>16&255]+Zt[i>>24&255]).toLowerCase()}function Le(n,e,t){return Math.max(e,Math.min(t,n))}function fu(n,e){return(n%e+e)%e}function d0(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function p0(n,e,t){return n!==e?(t-n)/(e-n):0}function br(n,e,t){return(1-t)*n+t*e}function m0(n,e,t,i){return br(n,e,1-Math.exp(-t*i))}function g0(n,e=1){return e-Math.abs(fu(n,e*2)-e)}function _0(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function v0(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function x0(n,e){return n+Math.floor(Math.random()*(e-n+1))}function y0(n,e){return n+Math.random()*(e-n)}function b0(n){return n*(.5-Math.random())}function S0(n){n!==void 0&&(vh=n);let e=vh+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function E0(n){return n*yr}function M0(n){return n*Ir}function A0(n){return(n&n-1)===0&&n!==0}function w0(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function T0(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function R0(n,e,t,i,s){const r=Math.cos,a=Math.sin,o=r(t/2),c=a(t/2),l=r((e+i)/2),u=a((e+i)/2),f=r((e-i)/2),h=a((e-i)/2),d=r((i-e)/2),g=a((i-e)/2);switch(s){case"XYX":n.set(o*u,c*f,c*h,o*l);break;case"YZY":n.set(c*h,o*u,c*f,o*l);break;case"ZXZ":n.set(c*f,c*h,o*u,o*l);break;case"XZX":n.set(o*u,c*g,c*d,o*l);break;case"YXY":n.set(c*d,o*u,c*g,o*l);break;case"ZYZ":n.set(c*g,c*d,o*u,o*l);break;default:Ne("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Dn(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function et(n,e){switch(e.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}const Fp={DEG2RAD:yr,RAD2DEG:Ir,generateUUID:fi,clamp:Le,euclideanModulo:fu,mapLinear:d0,inverseLerp:p0,lerp:br,damp:m0,pingpong:g0,smoothstep:_0,smootherstep:v0,randInt:x0,randFloat:y0,randFloatSpread:b0,seededRandom:S0,degToRad:E0,radToDeg:M0,isPowerOfTwo:A0,ceilPowerOfTwo:w0,floorPowerOfTwo:T0,setQuaternionFromProperEuler:R0,normalize:et,denormalize:Dn};class we{static{we.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){const t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Le(this.x,e.x,t.x),this.y=Le(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Le(this.x,e,t),this.y=Le(this.y,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Le(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Le(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){const i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*i-a*s+e.x,this.y=r*s+a*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Fi{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,a,o){let c=i[s+0],l=i[s+1],u=i[s+2],f=i[s+3],h=r[a+0],d=r[a+1],g=r[a+2],y=r[a+3];if(f!==y||c!==h||l!==d||u!==g){let p=c*h+l*d+u*g+f*y;p<0&&(h=-h,d=-d,g=-g,y=-y,p=-p);let m=1-o;if(p<.9995){const v=Math.acos(p),b=Math.sin(v);m=Math.sin(m*v)/b,o=Math.sin(o*v)/b,c=c*m+h*o,l=l*m+d*o,u=u*m+g*o,f=f*m+y*o}else{c=c*m+h*o,l=l*m+d*o,u=u*m+g*o,f=f*m+y*o;const v=1/Math.sqrt(c*c+l*l+u*u+f*f);c*=v,l*=v,u*=v,f*=v}}e[t]=c,e[t+1]=l,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,a){const o=i[s],c=i[s+1],l=i[s+2],u=i[s+3],f=r[a],h=r[a+1],d=r[a+2],g=r[a+3];return e[t]=o*g+u*f+c*d-l*h,e[t+1]=c*g+u*h+l*f-o*d,e[t+2]=l*g+u*d+o*h-c*f,e[t+3]=u*g-o*f-c*h-l*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){const i=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,c=Math.sin,l=o(i/2),u=o(s/2),f=o(r/2),h=c(i/2),d=c(s/2),g=c(r/2);switch(a){case"XYZ":this._x=h*u*f+l*d*g,this._y=l*d*f-h*u*g,this._z=l*u*g+h*d*f,this._w=l*u*f-h*d*g;break;case"YXZ":this._x=h*u*f+l*d*g,this._y=l*d*f-h*u*g,this._z=l*u*g-h*d*f,this._w=l*u*f+h*d*g;break;case"ZXY":this._x=h*u*f-l*d*g,this._y=l*d*f+h*u*g,this._z=l*u*g+h*d*f,this._w=l*u*f-h*d*g;break;case"ZYX":this._x=h*u*f-l*d*g,this._y=l*d*f+h*u*g,this._z=l*u*g-h*d*f,this._w=l*u*f+h*d*g;break;case"YZX":this._x=h*u*f+l*d*g,this._y=l*d*f+h*u*g,this._z=l*u*g-h*d*f,this._w=l*u*f-h*d*g;break;case"XZY":this._x=h*u*f-l*d*g,this._y=l*d*f-h*u*g,this._z=l*u*g+h*d*f,this._w=l*u*f+h*d*g;break;default:Ne("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){const i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){const t=e.elements,i=t[0],s=t[4],r=t[8],a=t[1],o=t[5],c=t[9],l=t[2],u=t[6],f=t[10],h=i+o+f;if(h>0){const d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-c)*d,this._y=(r-l)*d,this._z=(a-s)*d}else if(i>o&&i>f){const d=2*Math.sqrt(1+i-o-f);this._w=(u-c)/d,this._x=.25*d,this._y=(s+a)/d,this._z=(r+l)/d}else if(o>f){const d=2*Math.sqrt(1+o-i-f);this._w=(r-l)/d,this._x=(s+a)/d,this._y=.25*d,this._z=(c+u)/d}else{const d=2*Math.sqrt(1+f-i-o);this._w=(a-s)/d,this._x=(r+l)/d,this._y=(c+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Le(this.dot(e),-1,1)))}rotateTowards(e,t){const i=this.angleTo(e);if(i===0)return this;const s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){const i=e._x,s=e._y,r=e._z,a=e._w,o=t._x,c=t._y,l=t._z,u=t._w;return this._x=i*u+a*o+s*l-r*c,this._y=s*u+a*c+r*o-i*l,this._z=r*u+a*l+i*c-s*o,this._w=a*u-i*o-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(i=-i,s=-s,r=-r,a=-a,o=-o);let c=1-t;if(o<.9995){const l=Math.acos(o),u=Math.sin(l);c=Math.sin(c*l)/u,t=Math.sin(t*l)/u,this._x=this._x*c+i*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+a*t,this._onChangeCallback()}else this._x=this._x*c+i*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+a*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){const e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class P{static{P.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(xh.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(xh.setFromAxisAngle(e,t))}applyMatrix3(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*a,this}applyQuaternion(e){const t=this.x,i=this.y,s=this.z,r=e.x,a=e.y,o=e.z,c=e.w,l=2*(a*s-o*i),u=2*(o*t-r*s),f=2*(r*i-a*t);return this.x=t+c*l+a*f-o*u,this.y=i+c*u+o*l-r*f,this.z=s+c*f+r*u-a*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){const t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Le(this.x,e.x,t.x),this.y=Le(this.y,e.y,t.y),this.z=Le(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Le(this.x,e,t),this.y=Le(this.y,e,t),this.z=Le(this.z,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Le(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){const i=e.x,s=e.y,r=e.z,a=t.x,o=t.y,c=t.z;return this.x=s*c-r*o,this.y=r*a-i*c,this.z=i*o-s*a,this}projectOnVector(e){const t=e.lengthSq();if(t===0)return this.set(0,0,0);const i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Go.copy(this).projectOnVector(e),this.sub(Go)}reflect(e){return this.sub(Go.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){const t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;const i=this.dot(e)/t;return Math.acos(Le(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){const t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){const s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){const t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const Go=new P,xh=new Fi;class Ue{static{Ue.prototype.isMatrix3=!0}constructor(e,t,i,s,r,a,o,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,c,l)}set(e,t,i,s,r,a,o,c,l){const u=this.elements;return u[0]=e,u[1]=s,u[2]=o,u[3]=t,u[4]=r,u[5]=c,u[6]=i,u[7]=a,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){const t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[3],c=i[6],l=i[1],u=i[4],f=i[7],h=i[2],d=i[5],g=i[8],y=s[0],p=s[3],m=s[6],v=s[1],b=s[4],x=s[7],E=s[2],w=s[5],T=s[8];return r[0]=a*y+o*v+c*E,r[3]=a*p+o*b+c*w,r[6]=a*m+o*x+c*T,r[1]=l*y+u*v+f*E,r[4]=l*p+u*b+f*w,r[7]=l*m+u*x+f*T,r[2]=h*y+d*v+g*E,r[5]=h*p+d*b+g*w,r[8]=h*m+d*x+g*T,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],c=e[6],l=e[7],u=e[8];return t*a*u-t*o*l-i*r*u+i*o*c+s*r*l-s*a*c}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],c=e[6],l=e[7],u=e[8],f=u*a-o*l,h=o*c-u*r,d=l*r-a*c,g=t*f+i*h+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const y=1/g;return e[0]=f*y,e[1]=(s*l-u*i)*y,e[2]=(o*i-s*a)*y,e[3]=h*y,e[4]=(u*t-s*c)*y,e[5]=(s*r-o*t)*y,e[6]=d*y,e[7]=(i*c-l*t)*y,e[8]=(a*t-i*r)*y,this}transpose(){let e;const t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){const t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,a,o){const c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*a+l*o)+a+e,-s*l,s*c,-s*(-l*a+c*o)+o+t,0,0,1),this}scale(e,t){return this.premultiply(zo.makeScale(e,t)),this}rotate(e){return this.premultiply(zo.makeRotation(-e)),this}translate(e,t){return this.premultiply(zo.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}}const zo=new Ue,yh=new Ue().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),bh=new Ue().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function N0(){const n={enabled:!0,workingColorSpace:Nr,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Qe&&(s.r=di(s.r),s.g=di(s.g),s.b=di(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Qe&&(s.r=ks(s.r),s.g=ks(s.g),s.b=ks(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Pi?ao:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[a].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return Ll("ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return Ll("ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Nr]:{primaries:e,whitePoint:i,transfer:ao,toXYZ:yh,fromXYZ:bh,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:_n},outputColorSpaceConfig:{drawingBufferColorSpace:_n}},[_n]:{primaries:e,whitePoint:i,transfer:Qe,toXYZ:yh,fromXYZ:bh,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:_n}}}),n}const Xe=N0();function di(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ks(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}let us;class I0{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{us===void 0&&(us=co("canvas")),us.width=e.width,us.height=e.height;const s=us.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=us}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){const t=co("canvas");t.width=e.width,t.height=e.height;const i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);const s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=di(r[a]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){const t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(di(t[i]/255)*255):t[i]=di(t[i]);return{data:t,width:e.width,height:e.height}}else return Ne("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}}let C0=0;class du{constructor(e=null){this.isSource=!0,Object.defineProperty(this,"id",{value:C0++}),this.uuid=fi(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){const t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width,t.height,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(Wo(s[a].image)):r.push(Wo(s[a]))}else r=Wo(s);i.url=r}return t||(e.images[this.uuid]=i),i}}function Wo(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?I0.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ne("Texture: Unable to serialize Texture."),{})}let P0=0;const Ho=new P;class en extends Oi{constructor(e=en.DEFAULT_IMAGE,t=en.DEFAULT_MAPPING,i=li,s=li,r=Ht,a=ji,o=Sn,c=bn,l=en.DEFAULT_ANISOTROPY,u=Pi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:P0++}),this.uuid=fi(),this.name="",this.source=new du(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=l,this.format=o,this.internalFormat=null,this.type=c,this.offset=new we(0,0),this.repeat=new we(1,1),this.center=new we(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ue,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.normalized=!1}get width(){return this.source.getSize(Ho).x}get height(){return this.source.getSize(Ho).y}get depth(){return this.source.getSize(Ho).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(const t in e){const i=e[t];if(i===void 0){Ne(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){Ne(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];const i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Tp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case el:e.x=e.x-Math.floor(e.x);break;case li:e.x=e.x<0?0:1;break;case tl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case el:e.y=e.y-Math.floor(e.y);break;case li:e.y=e.y<0?0:1;break;case tl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}}en.DEFAULT_IMAGE=null;en.DEFAULT_MAPPING=Tp;en.DEFAULT_ANISOTROPY=1;class ht{static{ht.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){const t=this.x,i=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*i+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*i+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*i+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*i+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);const t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r;const c=e.elements,l=c[0],u=c[4],f=c[8],h=c[1],d=c[5],g=c[9],y=c[2],p=c[6],m=c[10];if(Math.abs(u-h)<.01&&Math.abs(f-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+y)<.1&&Math.abs(g+p)<.1&&Math.abs(l+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;const b=(l+1)/2,x=(d+1)/2,E=(m+1)/2,w=(u+h)/4,T=(f+y)/4,_=(g+p)/4;return b>x&&b>E?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=w/i,r=T/i):x>E?x<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(x),i=w/s,r=_/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=T/r,s=_/r),this.set(i,s,r,t),this}let v=Math.sqrt((p-g)*(p-g)+(f-y)*(f-y)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(f-y)/v,this.z=(h-u)/v,this.w=Math.acos((l+d+m-1)/2),this}setFromMatrixPosition(e){const t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Le(this.x,e.x,t.x),this.y=Le(this.y,e.y,t.y),this.z=Le(this.z,e.z,t.z),this.w=Le(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Le(this.x,e,t),this.y=Le(this.y,e,t),this.z=Le(this.z,e,t),this.w=Le(this.w,e,t),this}clampLength(e,t){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Le(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class L0 extends Oi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ht,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new ht(0,0,e,t),this.scissorTest=!1,this.viewport=new ht(0,0,e,t),this.textures=[];const s={width:e,height:t,depth:i.depth},r=new en(s),a=i.count;for(let o=0;o<a;o++)this.textures[o]=r.clone(),this.textures[o].isRenderTargetTexture=!0,this.textures[o].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(e={}){const t={minFilter:Ht,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),e!==null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;const s=Object.assign({},e.textures[t].image);this.textures[t].source=new du(s)}return this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,e.depthTexture!==null&&(this.depthTexture=e.depthTexture.clone()),this.samples=e.samples,this.multiview=e.multiview,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Un extends L0{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}}class Bp extends en{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}}class D0 extends en{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Wt,this.minFilter=Wt,this.wrapR=li,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class je{static{je.prototype.isMatrix4=!0}constructor(e,t,i,s,r,a,o,c,l,u,f,h,d,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,a,o,c,l,u,f,h,d,g,y,p)}set(e,t,i,s,r,a,o,c,l,u,f,h,d,g,y,p){const m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=a,m[9]=o,m[13]=c,m[2]=l,m[6]=u,m[10]=f,m[14]=h,m[3]=d,m[7]=g,m[11]=y,m[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new je().fromArray(this.elements)}copy(e){const t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){const t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){const t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinant()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinant()===0)return this.identity();const t=this.elements,i=e.elements,s=1/hs.setFromMatrixColumn(e,0).length(),r=1/hs.setFromMatrixColumn(e,1).length(),a=1/hs.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*a,t[9]=i[9]*a,t[10]=i[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){const t=this.elements,i=e.x,s=e.y,r=e.z,a=Math.cos(i),o=Math.sin(i),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){const h=a*u,d=a*f,g=o*u,y=o*f;t[0]=c*u,t[4]=-c*f,t[8]=l,t[1]=d+g*l,t[5]=h-y*l,t[9]=-o*c,t[2]=y-h*l,t[6]=g+d*l,t[10]=a*c}else if(e.order==="YXZ"){const h=c*u,d=c*f,g=l*u,y=l*f;t[0]=h+y*o,t[4]=g*o-d,t[8]=a*l,t[1]=a*f,t[5]=a*u,t[9]=-o,t[2]=d*o-g,t[6]=y+h*o,t[10]=a*c}else if(e.order==="ZXY"){const h=c*u,d=c*f,g=l*u,y=l*f;t[0]=h-y*o,t[4]=-a*f,t[8]=g+d*o,t[1]=d+g*o,t[5]=a*u,t[9]=y-h*o,t[2]=-a*l,t[6]=o,t[10]=a*c}else if(e.order==="ZYX"){const h=a*u,d=a*f,g=o*u,y=o*f;t[0]=c*u,t[4]=g*l-d,t[8]=h*l+y,t[1]=c*f,t[5]=y*l+h,t[9]=d*l-g,t[2]=-l,t[6]=o*c,t[10]=a*c}else if(e.order==="YZX"){const h=a*c,d=a*l,g=o*c,y=o*l;t[0]=c*u,t[4]=y-h*f,t[8]=g*f+d,t[1]=f,t[5]=a*u,t[9]=-o*u,t[2]=-l*u,t[6]=d*f+g,t[10]=h-y*f}else if(e.order==="XZY"){const h=a*c,d=a*l,g=o*c,y=o*l;t[0]=c*u,t[4]=-f,t[8]=l*u,t[1]=h*f+y,t[5]=a*u,t[9]=d*f-g,t[2]=g*f-d,t[6]=o*u,t[10]=y*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(U0,e,F0)}lookAt(e,t,i){const s=this.elements;return un.subVectors(e,t),un.lengthSq()===0&&(un.z=1),un.normalize(),Mi.crossVectors(i,un),Mi.lengthSq()===0&&(Math.abs(i.z)===1?un.x+=1e-4:un.z+=1e-4,un.normalize(),Mi.crossVectors(i,un)),Mi.normalize(),jr.crossVectors(un,Mi),s[0]=Mi.x,s[4]=jr.x,s[8]=un.x,s[1]=Mi.y,s[5]=jr.y,s[9]=un.y,s[2]=Mi.z,s[6]=jr.z,s[10]=un.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){const i=e.elements,s=t.elements,r=this.elements,a=i[0],o=i[4],c=i[8],l=i[12],u=i[1],f=i[5],h=i[9],d=i[13],g=i[2],y=i[6],p=i[10],m=i[14],v=i[3],b=i[7],x=i[11],E=i[15],w=s[0],T=s[4],_=s[8],M=s[12],N=s[1],R=s[5],C=s[9],U=s[13],B=s[2],L=s[6],V=s[10],k=s[14],j=s[3],ee=s[7],le=s[11],xe=s[15];return r[0]=a*w+o*N+c*B+l*j,r[4]=a*T+o*R+c*L+l*ee,r[8]=a*_+o*C+c*V+l*le,r[12]=a*M+o*U+c*k+l*xe,r[1]=u*w+f*N+h*B+d*j,r[5]=u*T+f*R+h*L+d*ee,r[9]=u*_+f*C+h*V+d*le,r[13]=u*M+f*U+h*k+d*xe,r[2]=g*w+y*N+p*B+m*j,r[6]=g*T+y*R+p*L+m*ee,r[10]=g*_+y*C+p*V+m*le,r[14]=g*M+y*U+p*k+m*xe,r[3]=v*w+b*N+x*B+E*j,r[7]=v*T+b*R+x*L+E*ee,r[11]=v*_+b*C+x*V+E*le,r[15]=v*M+b*U+x*k+E*xe,this}multiplyScalar(e){const t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){const e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],a=e[1],o=e[5],c=e[9],l=e[13],u=e[2],f=e[6],h=e[10],d=e[14],g=e[3],y=e[7],p=e[11],m=e[15],v=c*d-l*h,b=o*d-l*f,x=o*h-c*f,E=a*d-l*u,w=a*h-c*u,T=a*f-o*u;return t*(y*v-p*b+m*x)-i*(g*v-p*E+m*w)+s*(g*b-y*E+m*T)-r*(g*x-y*w+p*T)}transpose(){const e=this.elements;let t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){const s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){const e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],a=e[4],o=e[5],c=e[6],l=e[7],u=e[8],f=e[9],h=e[10],d=e[11],g=e[12],y=e[13],p=e[14],m=e[15],v=t*o-i*a,b=t*c-s*a,x=t*l-r*a,E=i*c-s*o,w=i*l-r*o,T=s*l-r*c,_=u*y-f*g,M=u*p-h*g,N=u*m-d*g,R=f*p-h*y,C=f*m-d*y,U=h*m-d*p,B=v*U-b*C+x*R+E*N-w*M+T*_;if(B===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const L=1/B;return e[0]=(o*U-c*C+l*R)*L,e[1]=(s*C-i*U-r*R)*L,e[2]=(y*T-p*w+m*E)*L,e[3]=(h*w-f*T-d*E)*L,e[4]=(c*N-a*U-l*M)*L,e[5]=(t*U-s*N+r*M)*L,e[6]=(p*x-g*T-m*b)*L,e[7]=(u*T-h*x+d*b)*L,e[8]=(a*C-o*N+l*_)*L,e[9]=(i*N-t*C-r*_)*L,e[10]=(g*w-y*x+m*v)*L,e[11]=(f*x-u*w-d*v)*L,e[12]=(o*M-a*R-c*_)*L,e[13]=(t*R-i*M+s*_)*L,e[14]=(y*b-g*E-p*v)*L,e[15]=(u*E-f*b+h*v)*L,this}scale(e){const t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){const e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){const t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){const t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){const i=Math.cos(t),s=Math.sin(t),r=1-i,a=e.x,o=e.y,c=e.z,l=r*a,u=r*o;return this.set(l*a+i,l*o-s*c,l*c+s*o,0,l*o+s*c,u*o+i,u*c-s*a,0,l*c-s*o,u*c+s*a,r*c*c+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,a){return this.set(1,i,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){const s=this.elements,r=t._x,a=t._y,o=t._z,c=t._w,l=r+r,u=a+a,f=o+o,h=r*l,d=r*u,g=r*f,y=a*u,p=a*f,m=o*f,v=c*l,b=c*u,x=c*f,E=i.x,w=i.y,T=i.z;return s[0]=(1-(y+m))*E,s[1]=(d+x)*E,s[2]=(g-b)*E,s[3]=0,s[4]=(d-x)*w,s[5]=(1-(h+m))*w,s[6]=(p+v)*w,s[7]=0,s[8]=(g+b)*T,s[9]=(p-v)*T,s[10]=(1-(h+y))*T,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){const s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];const r=this.determinant();if(r===0)return i.set(1,1,1),t.identity(),this;let a=hs.set(s[0],s[1],s[2]).length();const o=hs.set(s[4],s[5],s[6]).length(),c=hs.set(s[8],s[9],s[10]).length();r<0&&(a=-a),Rn.copy(this);const l=1/a,u=1/o,f=1/c;return Rn.elements[0]*=l,Rn.elements[1]*=l,Rn.elements[2]*=l,Rn.elements[4]*=u,Rn.elements[5]*=u,Rn.elements[6]*=u,Rn.elements[8]*=f,Rn.elements[9]*=f,Rn.elements[10]*=f,t.setFromRotationMatrix(Rn),i.x=a,i.y=o,i.z=c,this}makePerspective(e,t,i,s,r,a,o=Jn,c=!1){const l=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s);let g,y;if(c)g=r/(a-r),y=a*r/(a-r);else if(o===Jn)g=-(a+r)/(a-r),y=-2*a*r/(a-r);else if(o===oo)g=-a/(a-r),y=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return l[0]=u,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=f,l[9]=d,l[13]=0,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,i,s,r,a,o=Jn,c=!1){const l=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s);let g,y;if(c)g=1/(a-r),y=a/(a-r);else if(o===Jn)g=-2/(a-r),y=-(a+r)/(a-r);else if(o===oo)g=-1/(a-r),y=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return l[0]=u,l[4]=0,l[8]=0,l[12]=h,l[1]=0,l[5]=f,l[9]=0,l[13]=d,l[2]=0,l[6]=0,l[10]=g,l[14]=y,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){const t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){const i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}}const hs=new P,Rn=new je,U0=new P(0,0,0),F0=new P(1,1,1),Mi=new P,jr=new P,un=new P,Sh=new je,Eh=new Fi;class ss{constructor(e=0,t=0,i=0,s=ss.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){const s=e.elements,r=s[0],a=s[4],o=s[8],c=s[1],l=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(Le(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(h,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Le(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(o,d),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(Le(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-a,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Le(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-a,l));break;case"YZX":this._z=Math.asin(Le(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,d));break;case"XZY":this._z=Math.asin(-Le(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(h,l),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ne("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Sh.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Sh,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Eh.setFromEuler(this),this.setFromQuaternion(Eh,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}ss.DEFAULT_ORDER="XYZ";class pu{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}}let B0=0;const Mh=new P,fs=new Fi,ti=new je,qr=new P,tr=new P,O0=new P,V0=new Fi,Ah=new P(1,0,0),wh=new P(0,1,0),Th=new P(0,0,1),Rh={type:"added"},k0={type:"removed"},ds={type:"childadded",child:null},Xo={type:"childremoved",child:null};class rn extends Oi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:B0++}),this.uuid=fi(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=rn.DEFAULT_UP.clone();const e=new P,t=new ss,i=new Fi,s=new P(1,1,1);function r(){i.setFromEuler(t,!1)}function a(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new je},normalMatrix:{value:new Ue}}),this.matrix=new je,this.matrixWorld=new je,this.matrixAutoUpdate=rn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new pu,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return fs.setFromAxisAngle(e,t),this.quaternion.multiply(fs),this}rotateOnWorldAxis(e,t){return fs.setFromAxisAngle(e,t),this.quaternion.premultiply(fs),this}rotateX(e){return this.rotateOnAxis(Ah,e)}rotateY(e){return this.rotateOnAxis(wh,e)}rotateZ(e){return this.rotateOnAxis(Th,e)}translateOnAxis(e,t){return Mh.copy(e).applyQuaternion(this.quaternion),this.position.add(Mh.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Ah,e)}translateY(e){return this.translateOnAxis(wh,e)}translateZ(e){return this.translateOnAxis(Th,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ti.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?qr.copy(e):qr.set(e,t,i);const s=this.parent;this.updateWorldMatrix(!0,!1),tr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ti.lookAt(tr,qr,this.up):ti.lookAt(qr,tr,this.up),this.quaternion.setFromRotationMatrix(ti),s&&(ti.extractRotation(s.matrixWorld),fs.setFromRotationMatrix(ti),this.quaternion.premultiply(fs.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ze("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Rh),ds.child=e,this.dispatchEvent(ds),ds.child=null):Ze("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(k0),Xo.child=e,this.dispatchEvent(Xo),Xo.child=null),this}removeFromParent(){const e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ti.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ti.multiply(e.parent.matrixWorld)),e.applyMatrix4(ti),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Rh),ds.child=e,this.dispatchEvent(ds),ds.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){const a=this.children[i].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(tr,e,O0),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(tr,V0,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);const t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}traverse(e){e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){const t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const e=this.pivot;if(e!==null){const t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);const t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t){const i=this.parent;if(e===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),t===!0){const s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(e){const t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),this.static!==!1&&(s.static=this.static),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);const o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){const c=o.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){const f=c[l];r(e.shapes,f)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const o=[];for(let c=0,l=this.material.length;c<l;c++)o.push(r(e.materials,this.material[c]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){const c=this.animations[o];s.animations.push(r(e.animations,c))}}if(t){const o=a(e.geometries),c=a(e.materials),l=a(e.textures),u=a(e.images),f=a(e.shapes),h=a(e.skeletons),d=a(e.animations),g=a(e.nodes);o.length>0&&(i.geometries=o),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function a(o){const c=[];for(const l in o){const u=o[l];delete u.metadata,c.push(u)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){const s=e.children[i];this.add(s.clone())}return this}}rn.DEFAULT_UP=new P(0,1,0);rn.DEFAULT_MATRIX_AUTO_UPDATE=!0;rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class vr extends rn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const G0={type:"move"};class Zo{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new vr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new vr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new vr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){const t=this._hand;if(t)for(const i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,a=null;const o=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){a=!0;for(const y of e.hand.values()){const p=t.getJointPose(y,i),m=this._getHandJoint(l,y);p!==null&&(m.matrix.fromArray(p.transform.matrix),m.matrix.decompose(m.position,m.rotation,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=p.radius),m.visible=p!==null}const u=l.joints["index-finger-tip"],f=l.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,g=.005;l.inputState.pinching&&h>d+g?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&h<=d-g&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.rotation,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.rotation,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(G0)))}return o!==null&&(o.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){const i=new vr;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}}const Op={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ai={h:0,s:0,l:0},Qr={h:0,s:0,l:0};function Yo(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}class Ke{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){const s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=_n){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Xe.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=Xe.workingColorSpace){return this.r=e,this.g=t,this.b=i,Xe.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=Xe.workingColorSpace){if(e=fu(e,1),t=Le(t,0,1),i=Le(i,0,1),t===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+t):i+t-i*t,a=2*i-r;this.r=Yo(a,r,e+1/3),this.g=Yo(a,r,e),this.b=Yo(a,r,e-1/3)}return Xe.colorSpaceToWorking(this,s),this}setStyle(e,t=_n){function i(r){r!==void 0&&parseFloat(r)<1&&Ne("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r;const a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,t);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(o))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ne("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){const r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);Ne("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=_n){const i=Op[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ne("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=di(e.r),this.g=di(e.g),this.b=di(e.b),this}copyLinearToSRGB(e){return this.r=ks(e.r),this.g=ks(e.g),this.b=ks(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=_n){return Xe.workingToColorSpace(Yt.copy(this),e),Math.round(Le(Yt.r*255,0,255))*65536+Math.round(Le(Yt.g*255,0,255))*256+Math.round(Le(Yt.b*255,0,255))}getHexString(e=_n){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Xe.workingColorSpace){Xe.workingToColorSpace(Yt.copy(this),t);const i=Yt.r,s=Yt.g,r=Yt.b,a=Math.max(i,s,r),o=Math.min(i,s,r);let c,l;const u=(o+a)/2;if(o===a)c=0,l=0;else{const f=a-o;switch(l=u<=.5?f/(a+o):f/(2-a-o),a){case i:c=(s-r)/f+(s<r?6:0);break;case s:c=(r-i)/f+2;break;case r:c=(i-s)/f+4;break}c/=6}return e.h=c,e.s=l,e.l=u,e}getRGB(e,t=Xe.workingColorSpace){return Xe.workingToColorSpace(Yt.copy(this),t),e.r=Yt.r,e.g=Yt.g,e.b=Yt.b,e}getStyle(e=_n){Xe.workingToColorSpace(Yt.copy(this),e);const t=Yt.r,i=Yt.g,s=Yt.b;return e!==_n?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ai),this.setHSL(Ai.h+e,Ai.s+t,Ai.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ai),e.getHSL(Qr);const i=br(Ai.h,Qr.h,t),s=br(Ai.s,Qr.s,t),r=br(Ai.l,Qr.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){const t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Yt=new Ke;Ke.NAMES=Op;let Ko=class extends rn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ss,this.environmentIntensity=1,this.environmentRotation=new ss,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),e.background!==null&&(this.background=e.background.clone()),e.environment!==null&&(this.environment=e.environment.clone()),e.fog!==null&&(this.fog=e.fog.clone()),this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),e.overrideMaterial!==null&&(this.overrideMaterial=e.overrideMaterial.clone()),this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){const t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(t.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(t.object.backgroundIntensity=this.backgroundIntensity),t.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(t.object.environmentIntensity=this.environmentIntensity),t.object.environmentRotation=this.environmentRotation.toArray(),t}};const Nn=new P,ni=new P,$o=new P,ii=new P,ps=new P,ms=new P,Nh=new P,Jo=new P,jo=new P,qo=new P,Qo=new ht,ec=new ht,tc=new ht;class Ut{constructor(e=new P,t=new P,i=new P){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Nn.subVectors(e,t),s.cross(Nn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Nn.subVectors(s,t),ni.subVectors(i,t),$o.subVectors(e,t);const a=Nn.dot(Nn),o=Nn.dot(ni),c=Nn.dot($o),l=ni.dot(ni),u=ni.dot($o),f=a*l-o*o;if(f===0)return r.set(0,0,0),null;const h=1/f,d=(l*c-o*u)*h,g=(a*u-o*c)*h;return r.set(1-d-g,g,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ii)===null?!1:ii.x>=0&&ii.y>=0&&ii.x+ii.y<=1}static getInterpolation(e,t,i,s,r,a,o,c){return this.getBarycoord(e,t,i,s,ii)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,ii.x),c.addScaledVector(a,ii.y),c.addScaledVector(o,ii.z),c)}static getInterpolatedAttribute(e,t,i,s,r,a){return Qo.setScalar(0),ec.setScalar(0),tc.setScalar(0),Qo.fromBufferAttribute(e,t),ec.fromBufferAttribute(e,i),tc.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Qo,r.x),a.addScaledVector(ec,r.y),a.addScaledVector(tc,r.z),a}static isFrontFacing(e,t,i,s){return Nn.subVectors(i,t),ni.subVectors(e,t),Nn.cross(ni).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Nn.subVectors(this.c,this.b),ni.subVectors(this.a,this.b),Nn.cross(ni).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return Ut.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return Ut.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return Ut.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return Ut.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return Ut.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){const i=this.a,s=this.b,r=this.c;let a,o;ps.subVectors(s,i),ms.subVectors(r,i),Jo.subVectors(e,i);const c=ps.dot(Jo),l=ms.dot(Jo);if(c<=0&&l<=0)return t.copy(i);jo.subVectors(e,s);const u=ps.dot(jo),f=ms.dot(jo);if(u>=0&&f<=u)return t.copy(s);const h=c*f-u*l;if(h<=0&&c>=0&&u<=0)return a=c/(c-u),t.copy(i).addScaledVector(ps,a);qo.subVectors(e,r);const d=ps.dot(qo),g=ms.dot(qo);if(g>=0&&d<=g)return t.copy(r);const y=d*l-c*g;if(y<=0&&l>=0&&g<=0)return o=l/(l-g),t.copy(i).addScaledVector(ms,o);const p=u*g-d*f;if(p<=0&&f-u>=0&&d-g>=0)return Nh.subVectors(r,s),o=(f-u)/(f-u+(d-g)),t.copy(s).addScaledVector(Nh,o);const m=1/(p+y+h);return a=y*m,o=h*m,t.copy(i).addScaledVector(ps,a).addScaledVector(ms,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}}class Ot{constructor(e=new P(1/0,1/0,1/0),t=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(In.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(In.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){const i=In.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);const i=e.geometry;if(i!==void 0){const r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,In):In.fromBufferAttribute(r,a),In.applyMatrix4(e.matrixWorld),this.expandByPoint(In);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ea.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),ea.copy(i.boundingBox)),ea.applyMatrix4(e.matrixWorld),this.union(ea)}const s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,In),In.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(nr),ta.subVectors(this.max,nr),gs.subVectors(e.a,nr),_s.subVectors(e.b,nr),vs.subVectors(e.c,nr),wi.subVectors(_s,gs),Ti.subVectors(vs,_s),Gi.subVectors(gs,vs);let t=[0,-wi.z,wi.y,0,-Ti.z,Ti.y,0,-Gi.z,Gi.y,wi.z,0,-wi.x,Ti.z,0,-Ti.x,Gi.z,0,-Gi.x,-wi.y,wi.x,0,-Ti.y,Ti.x,0,-Gi.y,Gi.x,0];return!nc(t,gs,_s,vs,ta)||(t=[1,0,0,0,1,0,0,0,1],!nc(t,gs,_s,vs,ta))?!1:(na.crossVectors(wi,Ti),t=[na.x,na.y,na.z],nc(t,gs,_s,vs,ta))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,In).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(In).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(si[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),si[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),si[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),si[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),si[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),si[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),si[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),si[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(si),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}}const si=[new P,new P,new P,new P,new P,new P,new P,new P],In=new P,ea=new Ot,gs=new P,_s=new P,vs=new P,wi=new P,Ti=new P,Gi=new P,nr=new P,ta=new P,na=new P,zi=new P;function nc(n,e,t,i,s){for(let r=0,a=n.length-3;r<=a;r+=3){zi.fromArray(n,r);const o=s.x*Math.abs(zi.x)+s.y*Math.abs(zi.y)+s.z*Math.abs(zi.z),c=e.dot(zi),l=t.dot(zi),u=i.dot(zi);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>o)return!1}return!0}const Mt=new P,ia=new we;let z0=0;class Et extends Oi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:z0++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Pl,this.updateRanges=[],this.gpuType=$n,this.version=0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)ia.fromBufferAttribute(this,t),ia.applyMatrix3(e),this.setXY(t,ia.x,ia.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.applyMatrix3(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.applyMatrix4(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.applyNormalMatrix(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Mt.fromBufferAttribute(this,t),Mt.transformDirection(e),this.setXYZ(t,Mt.x,Mt.y,Mt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=Dn(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=et(i,this.array)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=Dn(t,this.array)),t}setX(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=Dn(t,this.array)),t}setY(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=Dn(t,this.array)),t}setZ(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=Dn(t,this.array)),t}setW(e,t){return this.normalized&&(t=et(t,this.array)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=et(t,this.array),i=et(i,this.array)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=et(t,this.array),i=et(i,this.array),s=et(s,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=et(t,this.array),i=et(i,this.array),s=et(s,this.array),r=et(r,this.array)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(e.name=this.name),this.usage!==Pl&&(e.usage=this.usage),e}dispose(){this.dispatchEvent({type:"dispose"})}}class Vp extends Et{constructor(e,t,i){super(new Uint16Array(e),t,i)}}class kp extends Et{constructor(e,t,i){super(new Uint32Array(e),t,i)}}class Mn extends Et{constructor(e,t,i){super(new Float32Array(e),t,i)}}const W0=new Ot,ir=new P,ic=new P;class qs{constructor(e=new P,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){const i=this.center;t!==void 0?i.copy(t):W0.setFromPoints(e).getCenter(i);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){const t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){const i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ir.subVectors(e,this.center);const t=ir.lengthSq();if(t>this.radius*this.radius){const i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ir,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ic.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ir.copy(e.center).add(ic)),this.expandByPoint(ir.copy(e.center).sub(ic))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}}let H0=0;const mn=new je,sc=new rn,xs=new P,hn=new Ot,sr=new Ot,Dt=new P;class $t extends Oi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:H0++}),this.uuid=fi(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(l0(e)?kp:Vp)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){const t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new Ue().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(e){return mn.makeRotationFromQuaternion(e),this.applyMatrix4(mn),this}rotateX(e){return mn.makeRotationX(e),this.applyMatrix4(mn),this}rotateY(e){return mn.makeRotationY(e),this.applyMatrix4(mn),this}rotateZ(e){return mn.makeRotationZ(e),this.applyMatrix4(mn),this}translate(e,t,i){return mn.makeTranslation(e,t,i),this.applyMatrix4(mn),this}scale(e,t,i){return mn.makeScale(e,t,i),this.applyMatrix4(mn),this}lookAt(e){return sc.lookAt(e),sc.updateMatrix(),this.applyMatrix4(sc.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(xs).negate(),this.translate(xs.x,xs.y,xs.z),this}setFromPoints(e){const t=this.getAttribute("position");if(t===void 0){const i=[];for(let s=0,r=e.length;s<r;s++){const a=e[s];i.push(a.x,a.y,a.z||0)}this.setAttribute("position",new Mn(i,3))}else{const i=Math.min(e.length,t.count);for(let s=0;s<i;s++){const r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ne("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ot);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ze("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){const r=t[i];hn.setFromBufferAttribute(r),this.morphTargetsRelative?(Dt.addVectors(this.boundingBox.min,hn.min),this.boundingBox.expandByPoint(Dt),Dt.addVectors(this.boundingBox.max,hn.max),this.boundingBox.expandByPoint(Dt)):(this.boundingBox.expandByPoint(hn.min),this.boundingBox.expandByPoint(hn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ze('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new qs);const e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ze("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(e){const i=this.boundingSphere.center;if(hn.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){const o=t[r];sr.setFromBufferAttribute(o),this.morphTargetsRelative?(Dt.addVectors(hn.min,sr.min),hn.expandByPoint(Dt),Dt.addVectors(hn.max,sr.max),hn.expandByPoint(Dt)):(hn.expandByPoint(sr.min),hn.expandByPoint(sr.max))}hn.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)Dt.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dt));if(t)for(let r=0,a=t.length;r<a;r++){const o=t[r],c=this.morphTargetsRelative;for(let l=0,u=o.count;l<u;l++)Dt.fromBufferAttribute(o,l),c&&(xs.fromBufferAttribute(e,l),Dt.add(xs)),s=Math.max(s,i.distanceToSquared(Dt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ze('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ze("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=t.position,s=t.normal,r=t.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Et(new Float32Array(4*i.count),4));const a=this.getAttribute("tangent"),o=[],c=[];for(let _=0;_<i.count;_++)o[_]=new P,c[_]=new P;const l=new P,u=new P,f=new P,h=new we,d=new we,g=new we,y=new P,p=new P;function m(_,M,N){l.fromBufferAttribute(i,_),u.fromBufferAttribute(i,M),f.fromBufferAttribute(i,N),h.fromBufferAttribute(r,_),d.fromBufferAttribute(r,M),g.fromBufferAttribute(r,N),u.sub(l),f.sub(l),d.sub(h),g.sub(h);const R=1/(d.x*g.y-g.x*d.y);isFinite(R)&&(y.copy(u).multiplyScalar(g.y).addScaledVector(f,-d.y).multiplyScalar(R),p.copy(f).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(R),o[_].add(y),o[M].add(y),o[N].add(y),c[_].add(p),c[M].add(p),c[N].add(p))}let v=this.groups;v.length===0&&(v=[{start:0,count:e.count}]);for(let _=0,M=v.length;_<M;++_){const N=v[_],R=N.start,C=N.count;for(let U=R,B=R+C;U<B;U+=3)m(e.getX(U+0),e.getX(U+1),e.getX(U+2))}const b=new P,x=new P,E=new P,w=new P;function T(_){E.fromBufferAttribute(s,_),w.copy(E);const M=o[_];b.copy(M),b.sub(E.multiplyScalar(E.dot(M))).normalize(),x.crossVectors(w,M);const R=x.dot(c[_])<0?-1:1;a.setXYZW(_,b.x,b.y,b.z,R)}for(let _=0,M=v.length;_<M;++_){const N=v[_],R=N.start,C=N.count;for(let U=R,B=R+C;U<B;U+=3)T(e.getX(U+0)),T(e.getX(U+1)),T(e.getX(U+2))}}computeVertexNormals(){const e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Et(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);const s=new P,r=new P,a=new P,o=new P,c=new P,l=new P,u=new P,f=new P;if(e)for(let h=0,d=e.count;h<d;h+=3){const g=e.getX(h+0),y=e.getX(h+1),p=e.getX(h+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),a.fromBufferAttribute(t,p),u.subVectors(a,r),f.subVectors(s,r),u.cross(f),o.fromBufferAttribute(i,g),c.fromBufferAttribute(i,y),l.fromBufferAttribute(i,p),o.add(u),c.add(u),l.add(u),i.setXYZ(g,o.x,o.y,o.z),i.setXYZ(y,c.x,c.y,c.z),i.setXYZ(p,l.x,l.y,l.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),a.fromBufferAttribute(t,h+2),u.subVectors(a,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dt.fromBufferAttribute(e,t),Dt.normalize(),e.setXYZ(t,Dt.x,Dt.y,Dt.z)}toNonIndexed(){function e(o,c){const l=o.array,u=o.itemSize,f=o.normalized,h=new l.constructor(c.length*u);let d=0,g=0;for(let y=0,p=c.length;y<p;y++){o.isInterleavedBufferAttribute?d=c[y]*o.data.stride+o.offset:d=c[y]*u;for(let m=0;m<u;m++)h[g++]=l[d++]}return new Et(h,u,f)}if(this.index===null)return Ne("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const t=new $t,i=this.index.array,s=this.attributes;for(const o in s){const c=s[o],l=e(c,i);t.setAttribute(o,l)}const r=this.morphAttributes;for(const o in r){const c=[],l=r[o];for(let u=0,f=l.length;u<f;u++){const h=l[u],d=e(h,i);c.push(d)}t.morphAttributes[o]=c}t.morphTargetsRelative=this.morphTargetsRelative;const a=this.groups;for(let o=0,c=a.length;o<c;o++){const l=a[o];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){const e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.type,this.name!==""&&(e.name=this.name),Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0){const c=this.parameters;for(const l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};const t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});const i=this.attributes;for(const c in i){const l=i[c];e.data.attributes[c]=l.toJSON(e.data)}const s={};let r=!1;for(const c in this.morphAttributes){const l=this.morphAttributes[c],u=[];for(let f=0,h=l.length;f<h;f++){const d=l[f];u.push(d.toJSON(e.data))}u.length>0&&(s[c]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);const a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));const o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const t={};this.name=e.name;const i=e.index;i!==null&&this.setIndex(i.clone());const s=e.attributes;for(const l in s){const u=s[l];this.setAttribute(l,u.clone(t))}const r=e.morphAttributes;for(const l in r){const u=[],f=r[l];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[l]=u}this.morphTargetsRelative=e.morphTargetsRelative;const a=e.groups;for(let l=0,u=a.length;l<u;l++){const f=a[l];this.addGroup(f.start,f.count,f.materialIndex)}const o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());const c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}class X0{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Pl,this.updateRanges=[],this.version=0,this.uuid=fi()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=fi()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);const t=new this.array.constructor(e.arrayBuffers[this.array.buffer._uuid]),i=new this.constructor(t,this.stride);return i.setUsage(this.usage),i}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){return e.arrayBuffers===void 0&&(e.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=fi()),e.arrayBuffers[this.array.buffer._uuid]===void 0&&(e.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}}const Jt=new P;class Li{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)Jt.fromBufferAttribute(this,t),Jt.applyMatrix4(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Jt.fromBufferAttribute(this,t),Jt.applyNormalMatrix(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Jt.fromBufferAttribute(this,t),Jt.transformDirection(e),this.setXYZ(t,Jt.x,Jt.y,Jt.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=Dn(i,this.array)),i}setComponent(e,t,i){return this.normalized&&(i=et(i,this.array)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=et(t,this.array)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=Dn(t,this.array)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=Dn(t,this.array)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=Dn(t,this.array)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=Dn(t,this.array)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=et(t,this.array),i=et(i,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=et(t,this.array),i=et(i,this.array),s=et(s,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=et(t,this.array),i=et(i,this.array),s=et(s,this.array),r=et(r,this.array)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){lo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");const t=[];for(let i=0;i<this.count;i++){const s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Et(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new Li(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){lo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");const t=[];for(let i=0;i<this.count;i++){const s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}}let Z0=0;class Or extends Oi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Z0++}),this.uuid=fi(),this.name="",this.type="Material",this.blending=Vs,this.side=qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Yc,this.blendDst=Kc,this.blendEquation=$i,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ke(0,0,0),this.blendAlpha=0,this.depthFunc=ts,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=mh,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ls,this.stencilZFail=ls,this.stencilZPass=ls,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(const t in e){const i=e[t];if(i===void 0){Ne(`Material: parameter '${t}' has value of undefined.`);continue}const s=this[t];if(s===void 0){Ne(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){const t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});const i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Vs&&(i.blending=this.blending),this.side!==qn&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Yc&&(i.blendSrc=this.blendSrc),this.blendDst!==Kc&&(i.blendDst=this.blendDst),this.blendEquation!==$i&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==ts&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==mh&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==ls&&(i.stencilFail=this.stencilFail),this.stencilZFail!==ls&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==ls&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.allowOverride===!1&&(i.allowOverride=!1),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const a=[];for(const o in r){const c=r[o];delete c.metadata,a.push(c)}return a}if(t){const r=s(e.textures),a=s(e.images);r.length>0&&(i.textures=r),a.length>0&&(i.images=a)}return i}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;const t=e.clippingPlanes;let i=null;if(t!==null){const s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}}const ri=new P,rc=new P,sa=new P,Ri=new P,ac=new P,ra=new P,oc=new P;class Vr{constructor(e=new P,t=new P(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ri)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);const i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){const t=ri.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ri.copy(this.origin).addScaledVector(this.direction,t),ri.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){rc.copy(e).add(t).multiplyScalar(.5),sa.copy(t).sub(e).normalize(),Ri.copy(this.origin).sub(rc);const r=e.distanceTo(t)*.5,a=-this.direction.dot(sa),o=Ri.dot(this.direction),c=-Ri.dot(sa),l=Ri.lengthSq(),u=Math.abs(1-a*a);let f,h,d,g;if(u>0)if(f=a*c-o,h=a*o-c,g=r*u,f>=0)if(h>=-g)if(h<=g){const y=1/u;f*=y,h*=y,d=f*(f+a*h+2*o)+h*(a*f+h+2*c)+l}else h=r,f=Math.max(0,-(a*h+o)),d=-f*f+h*(h+2*c)+l;else h=-r,f=Math.max(0,-(a*h+o)),d=-f*f+h*(h+2*c)+l;else h<=-g?(f=Math.max(0,-(-a*r+o)),h=f>0?-r:Math.min(Math.max(-r,-c),r),d=-f*f+h*(h+2*c)+l):h<=g?(f=0,h=Math.min(Math.max(-r,-c),r),d=h*(h+2*c)+l):(f=Math.max(0,-(a*r+o)),h=f>0?r:Math.min(Math.max(-r,-c),r),d=-f*f+h*(h+2*c)+l);else h=a>0?-r:r,f=Math.max(0,-(a*h+o)),d=-f*f+h*(h+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(rc).addScaledVector(sa,h),d}intersectSphere(e,t){ri.subVectors(e.center,this.origin);const i=ri.dot(this.direction),s=ri.dot(ri)-i*i,r=e.radius*e.radius;if(s>r)return null;const a=Math.sqrt(r-s),o=i-a,c=i+a;return c<0?null:o<0?this.at(c,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){const t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){const i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){const t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,a,o,c;const l=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return l>=0?(i=(e.min.x-h.x)*l,s=(e.max.x-h.x)*l):(i=(e.max.x-h.x)*l,s=(e.min.x-h.x)*l),u>=0?(r=(e.min.y-h.y)*u,a=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,a=(e.min.y-h.y)*u),i>a||r>s||((r>i||isNaN(i))&&(i=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(e.min.z-h.z)*f,c=(e.max.z-h.z)*f):(o=(e.max.z-h.z)*f,c=(e.min.z-h.z)*f),i>c||o>s)||((o>i||i!==i)&&(i=o),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ri)!==null}intersectTriangle(e,t,i,s,r){ac.subVectors(t,e),ra.subVectors(i,e),oc.crossVectors(ac,ra);let a=this.direction.dot(oc),o;if(a>0){if(s)return null;o=1}else if(a<0)o=-1,a=-a;else return null;Ri.subVectors(this.origin,e);const c=o*this.direction.dot(ra.crossVectors(Ri,ra));if(c<0)return null;const l=o*this.direction.dot(ac.cross(Ri));if(l<0||c+l>a)return null;const u=-o*Ri.dot(oc);return u<0?null:this.at(u/a,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Gp extends Or{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ke(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ss,this.combine=xp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}}const Ih=new je,Wi=new Vr,aa=new qs,Ch=new P,oa=new P,ca=new P,la=new P,cc=new P,ua=new P,Ph=new P,ha=new P;class An extends rn{constructor(e=new $t,t=new Gp){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=e.morphTargetInfluences.slice()),e.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary)),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,a=i.morphTargetsRelative;t.fromBufferAttribute(s,e);const o=this.morphTargetInfluences;if(r&&o){ua.set(0,0,0);for(let c=0,l=r.length;c<l;c++){const u=o[c],f=r[c];u!==0&&(cc.fromBufferAttribute(f,e),a?ua.addScaledVector(cc,u):ua.addScaledVector(cc.sub(t),u))}t.add(ua)}return t}raycast(e,t){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),aa.copy(i.boundingSphere),aa.applyMatrix4(r),Wi.copy(e.ray).recast(e.near),!(aa.containsPoint(Wi.origin)===!1&&(Wi.intersectSphere(aa,Ch)===null||Wi.origin.distanceToSquared(Ch)>(e.far-e.near)**2))&&(Ih.copy(r).invert(),Wi.copy(e.ray).applyMatrix4(Ih),!(i.boundingBox!==null&&Wi.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Wi)))}_computeIntersections(e,t,i){let s;const r=this.geometry,a=this.material,o=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,y=h.length;g<y;g++){const p=h[g],m=a[p.materialIndex],v=Math.max(p.start,d.start),b=Math.min(o.count,Math.min(p.start+p.count,d.start+d.count));for(let x=v,E=b;x<E;x+=3){const w=o.getX(x),T=o.getX(x+1),_=o.getX(x+2);s=fa(this,m,e,i,l,u,f,w,T,_),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const g=Math.max(0,d.start),y=Math.min(o.count,d.start+d.count);for(let p=g,m=y;p<m;p+=3){const v=o.getX(p),b=o.getX(p+1),x=o.getX(p+2);s=fa(this,a,e,i,l,u,f,v,b,x),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(a))for(let g=0,y=h.length;g<y;g++){const p=h[g],m=a[p.materialIndex],v=Math.max(p.start,d.start),b=Math.min(c.count,Math.min(p.start+p.count,d.start+d.count));for(let x=v,E=b;x<E;x+=3){const w=x,T=x+1,_=x+2;s=fa(this,m,e,i,l,u,f,w,T,_),s&&(s.faceIndex=Math.floor(x/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{const g=Math.max(0,d.start),y=Math.min(c.count,d.start+d.count);for(let p=g,m=y;p<m;p+=3){const v=p,b=p+1,x=p+2;s=fa(this,a,e,i,l,u,f,v,b,x),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}}function Y0(n,e,t,i,s,r,a,o){let c;if(e.side===Qt?c=i.intersectTriangle(a,r,s,!0,o):c=i.intersectTriangle(s,r,a,e.side===qn,o),c===null)return null;ha.copy(o),ha.applyMatrix4(n.matrixWorld);const l=t.ray.origin.distanceTo(ha);return l<t.near||l>t.far?null:{distance:l,point:ha.clone(),object:n}}function fa(n,e,t,i,s,r,a,o,c,l){n.getVertexPosition(o,oa),n.getVertexPosition(c,ca),n.getVertexPosition(l,la);const u=Y0(n,e,t,i,oa,ca,la,Ph);if(u){const f=new P;Ut.getBarycoord(Ph,oa,ca,la,f),s&&(u.uv=Ut.getInterpolatedAttribute(s,o,c,l,f,new we)),r&&(u.uv1=Ut.getInterpolatedAttribute(r,o,c,l,f,new we)),a&&(u.normal=Ut.getInterpolatedAttribute(a,o,c,l,f,new P),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const h={a:o,b:c,c:l,normal:new P,materialIndex:0};Ut.getNormal(oa,ca,la,h.normal),u.face=h,u.barycoord=f}return u}class zp extends en{constructor(e=null,t=1,i=1,s,r,a,o,c,l=Wt,u=Wt,f,h){super(null,a,o,c,l,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const lc=new P,K0=new P,$0=new Ue;class Yn{constructor(e=new P(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){const s=lc.subVectors(i,t).cross(K0.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){const e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){const s=e.delta(lc),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;const a=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){const t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){const i=t||$0.getNormalMatrix(e),s=this.coplanarPoint(lc).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Hi=new qs,J0=new we(.5,.5),da=new P;class Wp{constructor(e=new Yn,t=new Yn,i=new Yn,s=new Yn,r=new Yn,a=new Yn){this.planes=[e,t,i,s,r,a]}set(e,t,i,s,r,a){const o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(i),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){const t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Jn,i=!1){const s=this.planes,r=e.elements,a=r[0],o=r[1],c=r[2],l=r[3],u=r[4],f=r[5],h=r[6],d=r[7],g=r[8],y=r[9],p=r[10],m=r[11],v=r[12],b=r[13],x=r[14],E=r[15];if(s[0].setComponents(l-a,d-u,m-g,E-v).normalize(),s[1].setComponents(l+a,d+u,m+g,E+v).normalize(),s[2].setComponents(l+o,d+f,m+y,E+b).normalize(),s[3].setComponents(l-o,d-f,m-y,E-b).normalize(),i)s[4].setComponents(c,h,p,x).normalize(),s[5].setComponents(l-c,d-h,m-p,E-x).normalize();else if(s[4].setComponents(l-c,d-h,m-p,E-x).normalize(),t===Jn)s[5].setComponents(l+c,d+h,m+p,E+x).normalize();else if(t===oo)s[5].setComponents(c,h,p,x).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Hi.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{const t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Hi.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Hi)}intersectsSprite(e){Hi.center.set(0,0,0);const t=J0.distanceTo(e.center);return Hi.radius=.7071067811865476+t,Hi.applyMatrix4(e.matrixWorld),this.intersectsSphere(Hi)}intersectsSphere(e){const t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){const t=this.planes;for(let i=0;i<6;i++){const s=t[i];if(da.x=s.normal.x>0?e.max.x:e.min.x,da.y=s.normal.y>0?e.max.y:e.min.y,da.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(da)<0)return!1}return!0}containsPoint(e){const t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}class j0 extends Or{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ke(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}}const Lh=new je,Dl=new Vr,pa=new qs,ma=new P;class q0 extends rn{constructor(e=new $t,t=new j0){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}raycast(e,t){const i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,a=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),pa.copy(i.boundingSphere),pa.applyMatrix4(s),pa.radius+=r,e.ray.intersectsSphere(pa)===!1)return;Lh.copy(s).invert(),Dl.copy(e.ray).applyMatrix4(Lh);const o=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,l=i.index,f=i.attributes.position;if(l!==null){const h=Math.max(0,a.start),d=Math.min(l.count,a.start+a.count);for(let g=h,y=d;g<y;g++){const p=l.getX(g);ma.fromBufferAttribute(f,p),Dh(ma,p,c,s,e,t,this)}}else{const h=Math.max(0,a.start),d=Math.min(f.count,a.start+a.count);for(let g=h,y=d;g<y;g++)ma.fromBufferAttribute(f,g),Dh(ma,g,c,s,e,t,this)}}updateMorphTargets(){const t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){const s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){const o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}}function Dh(n,e,t,i,s,r,a){const o=Dl.distanceSqToPoint(n);if(o<t){const c=new P;Dl.closestPointToPoint(n,c),c.applyMatrix4(i);const l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(o),point:c,index:e,face:null,faceIndex:null,barycoord:null,object:a})}}class Hp extends en{constructor(e=[],t=ns,i,s,r,a,o,c,l,u){super(e,t,i,s,r,a,o,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}}class rs extends en{constructor(e,t,i=Fn,s,r,a,o=Wt,c=Wt,l,u=mi,f=1){if(u!==mi&&u!==qi)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const h={width:e,height:t,depth:f};super(h,s,r,a,o,c,u,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new du(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){const t=super.toJSON(e);return this.compareFunction!==null&&(t.compareFunction=this.compareFunction),t}}class Q0 extends rs{constructor(e,t=Fn,i=ns,s,r,a=Wt,o=Wt,c,l=mi){const u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,a,o,c,l),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}}class Xp extends en{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}}class kr extends $t{constructor(e=1,t=1,i=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:a};const o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);const c=[],l=[],u=[],f=[];let h=0,d=0;g("z","y","x",-1,-1,i,t,e,a,r,0),g("z","y","x",1,-1,i,t,-e,a,r,1),g("x","z","y",1,1,e,i,t,s,a,2),g("x","z","y",1,-1,e,i,-t,s,a,3),g("x","y","z",1,-1,e,t,i,s,r,4),g("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new Mn(l,3)),this.setAttribute("normal",new Mn(u,3)),this.setAttribute("uv",new Mn(f,2));function g(y,p,m,v,b,x,E,w,T,_,M){const N=x/T,R=E/_,C=x/2,U=E/2,B=w/2,L=T+1,V=_+1;let k=0,j=0;const ee=new P;for(let le=0;le<V;le++){const xe=le*R-U;for(let ye=0;ye<L;ye++){const ze=ye*N-C;ee[y]=ze*v,ee[p]=xe*b,ee[m]=B,l.push(ee.x,ee.y,ee.z),ee[y]=0,ee[p]=0,ee[m]=w>0?1:-1,u.push(ee.x,ee.y,ee.z),f.push(ye/T),f.push(1-le/_),k+=1}}for(let le=0;le<_;le++)for(let xe=0;xe<T;xe++){const ye=h+xe+L*le,ze=h+xe+L*(le+1),qe=h+(xe+1)+L*(le+1),Ie=h+(xe+1)+L*le;c.push(ye,ze,Ie),c.push(ze,qe,Ie),j+=6}o.addGroup(d,j,M),d+=j,h+=k}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new kr(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}}class Gr extends $t{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};const r=e/2,a=t/2,o=Math.floor(i),c=Math.floor(s),l=o+1,u=c+1,f=e/o,h=t/c,d=[],g=[],y=[],p=[];for(let m=0;m<u;m++){const v=m*h-a;for(let b=0;b<l;b++){const x=b*f-r;g.push(x,-v,0),y.push(0,0,1),p.push(b/o),p.push(1-m/c)}}for(let m=0;m<c;m++)for(let v=0;v<o;v++){const b=v+l*m,x=v+l*(m+1),E=v+1+l*(m+1),w=v+1+l*m;d.push(b,x,w),d.push(x,E,w)}this.setIndex(d),this.setAttribute("position",new Mn(g,3)),this.setAttribute("normal",new Mn(y,3)),this.setAttribute("uv",new Mn(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new Gr(e.width,e.height,e.widthSegments,e.heightSegments)}}class e_ extends $t{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){const t=[],i=new Set,s=new P,r=new P;if(e.index!==null){const a=e.attributes.position,o=e.index;let c=e.groups;c.length===0&&(c=[{start:0,count:o.count,materialIndex:0}]);for(let l=0,u=c.length;l<u;++l){const f=c[l],h=f.start,d=f.count;for(let g=h,y=h+d;g<y;g+=3)for(let p=0;p<3;p++){const m=o.getX(g+p),v=o.getX(g+(p+1)%3);s.fromBufferAttribute(a,m),r.fromBufferAttribute(a,v),Uh(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{const a=e.attributes.position;for(let o=0,c=a.count/3;o<c;o++)for(let l=0;l<3;l++){const u=3*o+l,f=3*o+(l+1)%3;s.fromBufferAttribute(a,u),r.fromBufferAttribute(a,f),Uh(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Mn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}}function Uh(n,e,t){const i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function Hs(n){const e={};for(const t in n){e[t]={};for(const i in n[t]){const s=n[t][i];if(Fh(s))s.isRenderTargetTexture?(Ne("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Fh(s[0])){const r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function jt(n){const e={};for(let t=0;t<n.length;t++){const i=Hs(n[t]);for(const s in i)e[s]=i[s]}return e}function Fh(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function t_(n){const e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Zp(n){const e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Xe.workingColorSpace}const mu={clone:Hs,merge:jt};var n_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,i_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class on extends Or{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=n_,this.fragmentShader=i_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Hs(e.uniforms),this.uniformsGroups=t_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){const t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(const s in this.uniforms){const a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}}class s_ extends on{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class r_ extends Or{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=e0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}}class a_ extends Or{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}}const ga=new P,_a=new Fi,Gn=new P;class Yp extends rn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new je,this.projectionMatrix=new je,this.projectionMatrixInverse=new je,this.coordinateSystem=Jn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ga,_a,Gn),Gn.x===1&&Gn.y===1&&Gn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ga,_a,Gn.set(1,1,1)).invert()}updateWorldMatrix(e,t){super.updateWorldMatrix(e,t),this.matrixWorld.decompose(ga,_a,Gn),Gn.x===1&&Gn.y===1&&Gn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ga,_a,Gn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const Ni=new P,Bh=new we,Oh=new we;class vn extends Yp{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){const t=.5*this.getFilmHeight()/e;this.fov=Ir*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){const e=Math.tan(yr*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ir*2*Math.atan(Math.tan(yr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Ni.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ni.x,Ni.y).multiplyScalar(-e/Ni.z),Ni.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ni.x,Ni.y).multiplyScalar(-e/Ni.z)}getViewSize(e,t){return this.getViewBounds(e,Bh,Oh),t.subVectors(Oh,Bh)}setViewOffset(e,t,i,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=this.near;let t=e*Math.tan(yr*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s;const a=this.view;if(this.view!==null&&this.view.enabled){const c=a.fullWidth,l=a.fullHeight;r+=a.offsetX*s/c,t-=a.offsetY*i/l,s*=a.width/c,i*=a.height/l}const o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}}class gu extends Yp{constructor(e=-1,t=1,i=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-e,a=i+e,o=s+t,c=s-t;if(this.view!==null&&this.view.enabled){const l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,a=r+l*this.view.width,o-=u*this.view.offsetY,c=o-u*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){const t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}}class o_ extends $t{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){const e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}}const ys=-90,bs=1;class c_ extends rn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new vn(ys,bs,e,t);s.layers=this.layers,this.add(s);const r=new vn(ys,bs,e,t);r.layers=this.layers,this.add(r);const a=new vn(ys,bs,e,t);a.layers=this.layers,this.add(a);const o=new vn(ys,bs,e,t);o.layers=this.layers,this.add(o);const c=new vn(ys,bs,e,t);c.layers=this.layers,this.add(c);const l=new vn(ys,bs,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){const e=this.coordinateSystem,t=this.children.concat(),[i,s,r,a,o,c]=t;for(const l of t)this.remove(l);if(e===Jn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===oo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(const l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());const[r,a,o,c,l,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;const y=i.texture.generateMipmaps;i.texture.generateMipmaps=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(i,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),i.texture.generateMipmaps=y,e.setRenderTarget(i,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=g,i.texture.needsPMREMUpdate=!0}}class l_ extends vn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e}}class Ul extends X0{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){const t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){const t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}}const Vh=new je;class u_{constructor(e,t,i=0,s=1/0){this.ray=new Vr(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new pu,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,(t.near+t.far)/(t.near-t.far)).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Ze("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Vh.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Vh),this}intersectObject(e,t=!0,i=[]){return Fl(e,this,i,t),i.sort(kh),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Fl(e[s],this,i,t);return i.sort(kh),i}}function kh(n,e){return n.distance-e.distance}function Fl(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){const r=n.children;for(let a=0,o=r.length;a<o;a++)Fl(r[a],e,t,!0)}}class Gh{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Le(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(Le(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class Kp{static{Kp.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){const r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}}const zh=new P,va=new P,Ss=new P,Es=new P,uc=new P,h_=new P,f_=new P;class Qn{constructor(e=new P,t=new P){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){zh.subVectors(e,this.start),va.subVectors(this.end,this.start);const i=va.dot(va);if(i===0)return 0;let r=va.dot(zh)/i;return t&&(r=Le(r,0,1)),r}closestPointToPoint(e,t,i){const s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=h_,i=f_){const s=10000000000000001e-32;let r,a;const o=this.start,c=e.start,l=this.end,u=e.end;Ss.subVectors(l,o),Es.subVectors(u,c),uc.subVectors(o,c);const f=Ss.dot(Ss),h=Es.dot(Es),d=Es.dot(uc);if(f<=s&&h<=s)return t.copy(o),i.copy(c),t.sub(i),t.dot(t);if(f<=s)r=0,a=d/h,a=Le(a,0,1);else{const g=Ss.dot(uc);if(h<=s)a=0,r=Le(-g/f,0,1);else{const y=Ss.dot(Es),p=f*h-y*y;p!==0?r=Le((y*d-g*h)/p,0,1):r=0,a=(y*r+d)/h,a<0?(a=0,r=Le(-g/f,0,1)):a>1&&(a=1,r=Le((y-g)/f,0,1))}}return t.copy(o).addScaledVector(Ss,r),i.copy(c).addScaledVector(Es,a),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}}class d_ extends Oi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){if(e===void 0){Ne("Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}}function Wh(n,e,t,i){const s=p_(i);switch(t){case Pp:return n*e;case Dp:return n*e/s.components*s.byteLength;case ou:return n*e/s.components*s.byteLength;case is:return n*e*2/s.components*s.byteLength;case cu:return n*e*2/s.components*s.byteLength;case Lp:return n*e*3/s.components*s.byteLength;case Sn:return n*e*4/s.components*s.byteLength;case lu:return n*e*4/s.components*s.byteLength;case Ya:case Ka:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case $a:case Ja:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case il:case rl:return Math.max(n,16)*Math.max(e,8)/4;case nl:case sl:return Math.max(n,8)*Math.max(e,8)/2;case al:case ol:case ll:case ul:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case cl:case so:case hl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case dl:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case pl:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case ml:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case gl:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case _l:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case vl:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case xl:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case yl:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case bl:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Sl:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case El:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Ml:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Al:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case wl:case Tl:case Rl:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Nl:case Il:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ro:case Cl:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function p_(n){switch(n){case bn:case Rp:return{byteLength:1,components:1};case Tr:case Np:case pi:return{byteLength:2,components:1};case ru:case au:return{byteLength:2,components:4};case Fn:case su:case $n:return{byteLength:4,components:1};case Ip:case Cp:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"184"}}));typeof window<"u"&&(window.__THREE__?Ne("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="184");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function $p(){let n=null,e=!1,t=null,i=null;function s(r,a){t(r,a),i=n.requestAnimationFrame(s)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function m_(n){const e=new WeakMap;function t(o,c){const l=o.array,u=o.usage,f=l.byteLength,h=n.createBuffer();n.bindBuffer(c,h),n.bufferData(c,l,u),o.onUploadCallback();let d;if(l instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)d=n.HALF_FLOAT;else if(l instanceof Uint16Array)o.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)d=n.SHORT;else if(l instanceof Uint32Array)d=n.UNSIGNED_INT;else if(l instanceof Int32Array)d=n.INT;else if(l instanceof Int8Array)d=n.BYTE;else if(l instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:h,type:d,bytesPerElement:l.BYTES_PER_ELEMENT,version:o.version,size:f}}function i(o,c,l){const u=c.array,f=c.updateRanges;if(n.bindBuffer(l,o),f.length===0)n.bufferSubData(l,0,u);else{f.sort((d,g)=>d.start-g.start);let h=0;for(let d=1;d<f.length;d++){const g=f[h],y=f[d];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++h,f[h]=y)}f.length=h+1;for(let d=0,g=f.length;d<g;d++){const y=f[d];n.bufferSubData(l,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);const c=e.get(o);c&&(n.deleteBuffer(c.buffer),e.delete(o))}function a(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){const u=e.get(o);(!u||u.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}const l=e.get(o);if(l===void 0)e.set(o,t(o,c));else if(l.version<o.version){if(l.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,o,c),l.version=o.version}}return{get:s,remove:r,update:a}}var g_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,__=`#ifdef USE_ALPHAHASH
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
#endif`,v_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,x_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,y_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,b_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,S_=`#ifdef USE_AOMAP
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
#endif`,E_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,M_=`#ifdef USE_BATCHING
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
#endif`,A_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,w_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,T_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,R_=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,N_=`#ifdef USE_IRIDESCENCE
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
#endif`,I_=`#ifdef USE_BUMPMAP
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
#endif`,C_=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,P_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,L_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,D_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,U_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,F_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,B_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,O_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,V_=`#define PI 3.141592653589793
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
} // validated`,k_=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,G_=`vec3 transformedNormal = objectNormal;
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
#endif`,z_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,W_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,H_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,X_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Z_="gl_FragColor = linearToOutputTexel( gl_FragColor );",Y_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,K_=`#ifdef USE_ENVMAP
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
#endif`,$_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
#endif`,J_=`#ifdef USE_ENVMAP
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
#endif`,j_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,q_=`#ifdef USE_ENVMAP
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
#endif`,Q_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ev=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,tv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,nv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,iv=`#ifdef USE_GRADIENTMAP
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
}`,sv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,rv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,av=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ov=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,cv=`#ifdef USE_ENVMAP
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
#endif`,lv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,uv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,hv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,fv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,dv=`PhysicalMaterial material;
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
#endif`,pv=`uniform sampler2D dfgLUT;
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
}`,mv=`
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
#endif`,gv=`#if defined( RE_IndirectDiffuse )
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
#endif`,_v=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,vv=`#ifdef USE_LIGHT_PROBES_GRID
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
#endif`,xv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,yv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Sv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Ev=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Mv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Av=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,wv=`#if defined( USE_POINTS_UV )
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
#endif`,Tv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Rv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Nv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Iv=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Cv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Pv=`#ifdef USE_MORPHTARGETS
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
#endif`,Lv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Dv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Uv=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Fv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Bv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ov=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Vv=`#ifdef USE_NORMALMAP
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
#endif`,kv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Gv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,zv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Wv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Hv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Xv=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Zv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Yv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Kv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,$v=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Jv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,jv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,qv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Qv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,ex=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,tx=`float getShadowMask() {
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
}`,nx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ix=`#ifdef USE_SKINNING
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
#endif`,sx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,rx=`#ifdef USE_SKINNING
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
#endif`,ax=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ox=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,cx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lx=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ux=`#ifdef USE_TRANSMISSION
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
#endif`,hx=`#ifdef USE_TRANSMISSION
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
#endif`,fx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,px=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const gx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,_x=`uniform sampler2D t2D;
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
}`,vx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xx=`#ifdef ENVMAP_TYPE_CUBE
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
}`,yx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,bx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Sx=`#include <common>
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
}`,Ex=`#if DEPTH_PACKING == 3200
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
}`,Mx=`#define DISTANCE
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
}`,Ax=`#define DISTANCE
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
}`,wx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Tx=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Rx=`uniform float scale;
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
}`,Nx=`uniform vec3 diffuse;
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
}`,Ix=`#include <common>
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
}`,Cx=`uniform vec3 diffuse;
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
}`,Px=`#define LAMBERT
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
}`,Lx=`#define LAMBERT
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
}`,Dx=`#define MATCAP
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
}`,Ux=`#define MATCAP
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
}`,Fx=`#define NORMAL
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
}`,Bx=`#define NORMAL
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
}`,Ox=`#define PHONG
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
}`,Vx=`#define PHONG
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
}`,kx=`#define STANDARD
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
}`,Gx=`#define STANDARD
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
}`,zx=`#define TOON
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
}`,Wx=`#define TOON
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
}`,Hx=`uniform float size;
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
}`,Xx=`uniform vec3 diffuse;
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
}`,Zx=`#include <common>
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
}`,Yx=`uniform vec3 color;
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
}`,Kx=`uniform float rotation;
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
}`,$x=`uniform vec3 diffuse;
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
}`,Ve={alphahash_fragment:g_,alphahash_pars_fragment:__,alphamap_fragment:v_,alphamap_pars_fragment:x_,alphatest_fragment:y_,alphatest_pars_fragment:b_,aomap_fragment:S_,aomap_pars_fragment:E_,batching_pars_vertex:M_,batching_vertex:A_,begin_vertex:w_,beginnormal_vertex:T_,bsdfs:R_,iridescence_fragment:N_,bumpmap_pars_fragment:I_,clipping_planes_fragment:C_,clipping_planes_pars_fragment:P_,clipping_planes_pars_vertex:L_,clipping_planes_vertex:D_,color_fragment:U_,color_pars_fragment:F_,color_pars_vertex:B_,color_vertex:O_,common:V_,cube_uv_reflection_fragment:k_,defaultnormal_vertex:G_,displacementmap_pars_vertex:z_,displacementmap_vertex:W_,emissivemap_fragment:H_,emissivemap_pars_fragment:X_,colorspace_fragment:Z_,colorspace_pars_fragment:Y_,envmap_fragment:K_,envmap_common_pars_fragment:$_,envmap_pars_fragment:J_,envmap_pars_vertex:j_,envmap_physical_pars_fragment:cv,envmap_vertex:q_,fog_vertex:Q_,fog_pars_vertex:ev,fog_fragment:tv,fog_pars_fragment:nv,gradientmap_pars_fragment:iv,lightmap_pars_fragment:sv,lights_lambert_fragment:rv,lights_lambert_pars_fragment:av,lights_pars_begin:ov,lights_toon_fragment:lv,lights_toon_pars_fragment:uv,lights_phong_fragment:hv,lights_phong_pars_fragment:fv,lights_physical_fragment:dv,lights_physical_pars_fragment:pv,lights_fragment_begin:mv,lights_fragment_maps:gv,lights_fragment_end:_v,lightprobes_pars_fragment:vv,logdepthbuf_fragment:xv,logdepthbuf_pars_fragment:yv,logdepthbuf_pars_vertex:bv,logdepthbuf_vertex:Sv,map_fragment:Ev,map_pars_fragment:Mv,map_particle_fragment:Av,map_particle_pars_fragment:wv,metalnessmap_fragment:Tv,metalnessmap_pars_fragment:Rv,morphinstance_vertex:Nv,morphcolor_vertex:Iv,morphnormal_vertex:Cv,morphtarget_pars_vertex:Pv,morphtarget_vertex:Lv,normal_fragment_begin:Dv,normal_fragment_maps:Uv,normal_pars_fragment:Fv,normal_pars_vertex:Bv,normal_vertex:Ov,normalmap_pars_fragment:Vv,clearcoat_normal_fragment_begin:kv,clearcoat_normal_fragment_maps:Gv,clearcoat_pars_fragment:zv,iridescence_pars_fragment:Wv,opaque_fragment:Hv,packing:Xv,premultiplied_alpha_fragment:Zv,project_vertex:Yv,dithering_fragment:Kv,dithering_pars_fragment:$v,roughnessmap_fragment:Jv,roughnessmap_pars_fragment:jv,shadowmap_pars_fragment:qv,shadowmap_pars_vertex:Qv,shadowmap_vertex:ex,shadowmask_pars_fragment:tx,skinbase_vertex:nx,skinning_pars_vertex:ix,skinning_vertex:sx,skinnormal_vertex:rx,specularmap_fragment:ax,specularmap_pars_fragment:ox,tonemapping_fragment:cx,tonemapping_pars_fragment:lx,transmission_fragment:ux,transmission_pars_fragment:hx,uv_pars_fragment:fx,uv_pars_vertex:dx,uv_vertex:px,worldpos_vertex:mx,background_vert:gx,background_frag:_x,backgroundCube_vert:vx,backgroundCube_frag:xx,cube_vert:yx,cube_frag:bx,depth_vert:Sx,depth_frag:Ex,distance_vert:Mx,distance_frag:Ax,equirect_vert:wx,equirect_frag:Tx,linedashed_vert:Rx,linedashed_frag:Nx,meshbasic_vert:Ix,meshbasic_frag:Cx,meshlambert_vert:Px,meshlambert_frag:Lx,meshmatcap_vert:Dx,meshmatcap_frag:Ux,meshnormal_vert:Fx,meshnormal_frag:Bx,meshphong_vert:Ox,meshphong_frag:Vx,meshphysical_vert:kx,meshphysical_frag:Gx,meshtoon_vert:zx,meshtoon_frag:Wx,points_vert:Hx,points_frag:Xx,shadow_vert:Zx,shadow_frag:Yx,sprite_vert:Kx,sprite_frag:$x},ce={common:{diffuse:{value:new Ke(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ue},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ue}},envmap:{envMap:{value:null},envMapRotation:{value:new Ue},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ue}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ue}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ue},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ue},normalScale:{value:new we(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ue},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ue}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ue}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ue}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ke(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:null},probesMin:{value:new P},probesMax:{value:new P},probesResolution:{value:new P}},points:{diffuse:{value:new Ke(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0},uvTransform:{value:new Ue}},sprite:{diffuse:{value:new Ke(16777215)},opacity:{value:1},center:{value:new we(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ue},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0}}},sn={basic:{uniforms:jt([ce.common,ce.specularmap,ce.envmap,ce.aomap,ce.lightmap,ce.fog]),vertexShader:Ve.meshbasic_vert,fragmentShader:Ve.meshbasic_frag},lambert:{uniforms:jt([ce.common,ce.specularmap,ce.envmap,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.fog,ce.lights,{emissive:{value:new Ke(0)},envMapIntensity:{value:1}}]),vertexShader:Ve.meshlambert_vert,fragmentShader:Ve.meshlambert_frag},phong:{uniforms:jt([ce.common,ce.specularmap,ce.envmap,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.fog,ce.lights,{emissive:{value:new Ke(0)},specular:{value:new Ke(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Ve.meshphong_vert,fragmentShader:Ve.meshphong_frag},standard:{uniforms:jt([ce.common,ce.envmap,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.roughnessmap,ce.metalnessmap,ce.fog,ce.lights,{emissive:{value:new Ke(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Ve.meshphysical_vert,fragmentShader:Ve.meshphysical_frag},toon:{uniforms:jt([ce.common,ce.aomap,ce.lightmap,ce.emissivemap,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.gradientmap,ce.fog,ce.lights,{emissive:{value:new Ke(0)}}]),vertexShader:Ve.meshtoon_vert,fragmentShader:Ve.meshtoon_frag},matcap:{uniforms:jt([ce.common,ce.bumpmap,ce.normalmap,ce.displacementmap,ce.fog,{matcap:{value:null}}]),vertexShader:Ve.meshmatcap_vert,fragmentShader:Ve.meshmatcap_frag},points:{uniforms:jt([ce.points,ce.fog]),vertexShader:Ve.points_vert,fragmentShader:Ve.points_frag},dashed:{uniforms:jt([ce.common,ce.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Ve.linedashed_vert,fragmentShader:Ve.linedashed_frag},depth:{uniforms:jt([ce.common,ce.displacementmap]),vertexShader:Ve.depth_vert,fragmentShader:Ve.depth_frag},normal:{uniforms:jt([ce.common,ce.bumpmap,ce.normalmap,ce.displacementmap,{opacity:{value:1}}]),vertexShader:Ve.meshnormal_vert,fragmentShader:Ve.meshnormal_frag},sprite:{uniforms:jt([ce.sprite,ce.fog]),vertexShader:Ve.sprite_vert,fragmentShader:Ve.sprite_frag},background:{uniforms:{uvTransform:{value:new Ue},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Ve.background_vert,fragmentShader:Ve.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ue}},vertexShader:Ve.backgroundCube_vert,fragmentShader:Ve.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Ve.cube_vert,fragmentShader:Ve.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Ve.equirect_vert,fragmentShader:Ve.equirect_frag},distance:{uniforms:jt([ce.common,ce.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Ve.distance_vert,fragmentShader:Ve.distance_frag},shadow:{uniforms:jt([ce.lights,ce.fog,{color:{value:new Ke(0)},opacity:{value:1}}]),vertexShader:Ve.shadow_vert,fragmentShader:Ve.shadow_frag}};sn.physical={uniforms:jt([sn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ue},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ue},clearcoatNormalScale:{value:new we(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ue},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ue},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ue},sheen:{value:0},sheenColor:{value:new Ke(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ue},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ue},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ue},transmissionSamplerSize:{value:new we},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ue},attenuationDistance:{value:0},attenuationColor:{value:new Ke(0)},specularColor:{value:new Ke(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ue},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ue},anisotropyVector:{value:new we},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ue}}]),vertexShader:Ve.meshphysical_vert,fragmentShader:Ve.meshphysical_frag};const xa={r:0,b:0,g:0},Jx=new je,Jp=new Ue;Jp.set(-1,0,0,0,1,0,0,0,1);function jx(n,e,t,i,s,r){const a=new Ke(0);let o=s===!0?0:1,c,l,u=null,f=0,h=null;function d(v){let b=v.isScene===!0?v.background:null;if(b&&b.isTexture){const x=v.backgroundBlurriness>0;b=e.get(b,x)}return b}function g(v){let b=!1;const x=d(v);x===null?p(a,o):x&&x.isColor&&(p(x,1),b=!0);const E=n.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(v,b){const x=d(b);x&&(x.isCubeTexture||x.mapping===yo)?(l===void 0&&(l=new An(new kr(1,1,1),new on({name:"BackgroundCubeMaterial",uniforms:Hs(sn.backgroundCube.uniforms),vertexShader:sn.backgroundCube.vertexShader,fragmentShader:sn.backgroundCube.fragmentShader,side:Qt,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(E,w,T){this.matrixWorld.copyPosition(T.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=x,l.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Jx.makeRotationFromEuler(b.backgroundRotation)).transpose(),x.isCubeTexture&&x.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Jp),l.material.toneMapped=Xe.getTransfer(x.colorSpace)!==Qe,(u!==x||f!==x.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=x,f=x.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null)):x&&x.isTexture&&(c===void 0&&(c=new An(new Gr(2,2),new on({name:"BackgroundMaterial",uniforms:Hs(sn.background.uniforms),vertexShader:sn.background.vertexShader,fragmentShader:sn.background.fragmentShader,side:qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=x,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.toneMapped=Xe.getTransfer(x.colorSpace)!==Qe,x.matrixAutoUpdate===!0&&x.updateMatrix(),c.material.uniforms.uvTransform.value.copy(x.matrix),(u!==x||f!==x.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=x,f=x.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null))}function p(v,b){v.getRGB(xa,Zp(n)),t.buffers.color.setClear(xa.r,xa.g,xa.b,b,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(v,b=1){a.set(v),o=b,p(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(v){o=v,p(a,o)},render:g,addToRenderList:y,dispose:m}}function qx(n,e){const t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null);let r=s,a=!1;function o(R,C,U,B,L){let V=!1;const k=f(R,B,U,C);r!==k&&(r=k,l(r.object)),V=d(R,B,U,L),V&&g(R,B,U,L),L!==null&&e.update(L,n.ELEMENT_ARRAY_BUFFER),(V||a)&&(a=!1,x(R,C,U,B),L!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(L).buffer))}function c(){return n.createVertexArray()}function l(R){return n.bindVertexArray(R)}function u(R){return n.deleteVertexArray(R)}function f(R,C,U,B){const L=B.wireframe===!0;let V=i[C.id];V===void 0&&(V={},i[C.id]=V);const k=R.isInstancedMesh===!0?R.id:0;let j=V[k];j===void 0&&(j={},V[k]=j);let ee=j[U.id];ee===void 0&&(ee={},j[U.id]=ee);let le=ee[L];return le===void 0&&(le=h(c()),ee[L]=le),le}function h(R){const C=[],U=[],B=[];for(let L=0;L<t;L++)C[L]=0,U[L]=0,B[L]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:U,attributeDivisors:B,object:R,attributes:{},index:null}}function d(R,C,U,B){const L=r.attributes,V=C.attributes;let k=0;const j=U.getAttributes();for(const ee in j)if(j[ee].location>=0){const xe=L[ee];let ye=V[ee];if(ye===void 0&&(ee==="instanceMatrix"&&R.instanceMatrix&&(ye=R.instanceMatrix),ee==="instanceColor"&&R.instanceColor&&(ye=R.instanceColor)),xe===void 0||xe.attribute!==ye||ye&&xe.data!==ye.data)return!0;k++}return r.attributesNum!==k||r.index!==B}function g(R,C,U,B){const L={},V=C.attributes;let k=0;const j=U.getAttributes();for(const ee in j)if(j[ee].location>=0){let xe=V[ee];xe===void 0&&(ee==="instanceMatrix"&&R.instanceMatrix&&(xe=R.instanceMatrix),ee==="instanceColor"&&R.instanceColor&&(xe=R.instanceColor));const ye={};ye.attribute=xe,xe&&xe.data&&(ye.data=xe.data),L[ee]=ye,k++}r.attributes=L,r.attributesNum=k,r.index=B}function y(){const R=r.newAttributes;for(let C=0,U=R.length;C<U;C++)R[C]=0}function p(R){m(R,0)}function m(R,C){const U=r.newAttributes,B=r.enabledAttributes,L=r.attributeDivisors;U[R]=1,B[R]===0&&(n.enableVertexAttribArray(R),B[R]=1),L[R]!==C&&(n.vertexAttribDivisor(R,C),L[R]=C)}function v(){const R=r.newAttributes,C=r.enabledAttributes;for(let U=0,B=C.length;U<B;U++)C[U]!==R[U]&&(n.disableVertexAttribArray(U),C[U]=0)}function b(R,C,U,B,L,V,k){k===!0?n.vertexAttribIPointer(R,C,U,L,V):n.vertexAttribPointer(R,C,U,B,L,V)}function x(R,C,U,B){y();const L=B.attributes,V=U.getAttributes(),k=C.defaultAttributeValues;for(const j in V){const ee=V[j];if(ee.location>=0){let le=L[j];if(le===void 0&&(j==="instanceMatrix"&&R.instanceMatrix&&(le=R.instanceMatrix),j==="instanceColor"&&R.instanceColor&&(le=R.instanceColor)),le!==void 0){const xe=le.normalized,ye=le.itemSize,ze=e.get(le);if(ze===void 0)continue;const qe=ze.buffer,Ie=ze.type,J=ze.bytesPerElement,he=Ie===n.INT||Ie===n.UNSIGNED_INT||le.gpuType===su;if(le.isInterleavedBufferAttribute){const se=le.data,Te=se.stride,Ce=le.offset;if(se.isInstancedInterleavedBuffer){for(let Re=0;Re<ee.locationSize;Re++)m(ee.location+Re,se.meshPerAttribute);R.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=se.meshPerAttribute*se.count)}else for(let Re=0;Re<ee.locationSize;Re++)p(ee.location+Re);n.bindBuffer(n.ARRAY_BUFFER,qe);for(let Re=0;Re<ee.locationSize;Re++)b(ee.location+Re,ye/ee.locationSize,Ie,xe,Te*J,(Ce+ye/ee.locationSize*Re)*J,he)}else{if(le.isInstancedBufferAttribute){for(let se=0;se<ee.locationSize;se++)m(ee.location+se,le.meshPerAttribute);R.isInstancedMesh!==!0&&B._maxInstanceCount===void 0&&(B._maxInstanceCount=le.meshPerAttribute*le.count)}else for(let se=0;se<ee.locationSize;se++)p(ee.location+se);n.bindBuffer(n.ARRAY_BUFFER,qe);for(let se=0;se<ee.locationSize;se++)b(ee.location+se,ye/ee.locationSize,Ie,xe,ye*J,ye/ee.locationSize*se*J,he)}}else if(k!==void 0){const xe=k[j];if(xe!==void 0)switch(xe.length){case 2:n.vertexAttrib2fv(ee.location,xe);break;case 3:n.vertexAttrib3fv(ee.location,xe);break;case 4:n.vertexAttrib4fv(ee.location,xe);break;default:n.vertexAttrib1fv(ee.location,xe)}}}}v()}function E(){M();for(const R in i){const C=i[R];for(const U in C){const B=C[U];for(const L in B){const V=B[L];for(const k in V)u(V[k].object),delete V[k];delete B[L]}}delete i[R]}}function w(R){if(i[R.id]===void 0)return;const C=i[R.id];for(const U in C){const B=C[U];for(const L in B){const V=B[L];for(const k in V)u(V[k].object),delete V[k];delete B[L]}}delete i[R.id]}function T(R){for(const C in i){const U=i[C];for(const B in U){const L=U[B];if(L[R.id]===void 0)continue;const V=L[R.id];for(const k in V)u(V[k].object),delete V[k];delete L[R.id]}}}function _(R){for(const C in i){const U=i[C],B=R.isInstancedMesh===!0?R.id:0,L=U[B];if(L!==void 0){for(const V in L){const k=L[V];for(const j in k)u(k[j].object),delete k[j];delete L[V]}delete U[B],Object.keys(U).length===0&&delete i[C]}}}function M(){N(),a=!0,r!==s&&(r=s,l(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:M,resetDefaultState:N,dispose:E,releaseStatesOfGeometry:w,releaseStatesOfObject:_,releaseStatesOfProgram:T,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function Qx(n,e,t){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),t.update(l,i,1)}function a(c,l,u){u!==0&&(n.drawArraysInstanced(i,c,l,u),t.update(l,i,u))}function o(c,l,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,u);let h=0;for(let d=0;d<u;d++)h+=l[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function ey(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){const T=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(T.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(T){return!(T!==Sn&&i.convert(T)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(T){const _=T===pi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(T!==bn&&i.convert(T)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&T!==$n&&!_)}function c(T){if(T==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";T="mediump"}return T==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp";const u=c(l);u!==l&&(Ne("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);const f=t.logarithmicDepthBuffer===!0,h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control");t.reversedDepthBuffer===!0&&h===!1&&Ne("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer.");const d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),p=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),x=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),w=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:a,textureTypeReadable:o,precision:l,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:m,maxVertexUniforms:v,maxVaryings:b,maxFragmentUniforms:x,maxSamples:E,samples:w}}function ty(n){const e=this;let t=null,i=0,s=!1,r=!1;const a=new Yn,o=new Ue,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){const d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){const g=f.clippingPlanes,y=f.clipIntersection,p=f.clipShadows,m=n.get(f);if(!s||g===null||g.length===0||r&&!p)r?u(null):l();else{const v=r?0:i,b=v*4;let x=m.clippingState||null;c.value=x,x=u(g,h,b,d);for(let E=0;E!==b;++E)x[E]=t[E];m.clippingState=x,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,g){const y=f!==null?f.length:0;let p=null;if(y!==0){if(p=c.value,g!==!0||p===null){const m=d+y*4,v=h.matrixWorldInverse;o.getNormalMatrix(v),(p===null||p.length<m)&&(p=new Float32Array(m));for(let b=0,x=d;b!==y;++b,x+=4)a.copy(f[b]).applyMatrix4(v,o),a.normal.toArray(p,x),p[x+3]=a.constant}c.value=p,c.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}const Di=4,Hh=[.125,.215,.35,.446,.526,.582],Ji=20,ny=256,rr=new gu,Xh=new Ke;let hc=null,fc=0,dc=0,pc=!1;const iy=new P;class Zh{constructor(e){this._renderer=e,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._sizeLods=[],this._sigmas=[],this._lodMeshes=[],this._backgroundBox=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){const{size:a=256,position:o=iy}=r;hc=this._renderer.getRenderTarget(),fc=this._renderer.getActiveCubeFace(),dc=this._renderer.getActiveMipmapLevel(),pc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(a);const c=this._allocateTargets();return c.depthBuffer=!0,this._sceneToCubeUV(e,i,s,c,o),t>0&&this._blur(c,0,0,t),this._applyPMREM(c),this._cleanup(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=$h(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Kh(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._backgroundBox!==null&&(this._backgroundBox.geometry.dispose(),this._backgroundBox.material.dispose())}_setSize(e){this._lodMax=Math.floor(Math.log2(e)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let e=0;e<this._lodMeshes.length;e++)this._lodMeshes[e].geometry.dispose()}_cleanup(e){this._renderer.setRenderTarget(hc,fc,dc),this._renderer.xr.enabled=pc,e.scissorTest=!1,Ms(e,0,0,e.width,e.height)}_fromTexture(e,t){e.mapping===ns||e.mapping===Ws?this._setSize(e.image.length===0?16:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4),hc=this._renderer.getRenderTarget(),fc=this._renderer.getActiveCubeFace(),dc=this._renderer.getActiveMipmapLevel(),pc=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=t||this._allocateTargets();return this._textureToCubeUV(e,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const e=3*Math.max(this._cubeSize,112),t=4*this._cubeSize,i={magFilter:Ht,minFilter:Ht,generateMipmaps:!1,type:pi,format:Sn,colorSpace:Nr,depthBuffer:!1},s=Yh(e,t,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==e||this._pingPongRenderTarget.height!==t){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Yh(e,t,i);const{_lodMax:r}=this;({lodMeshes:this._lodMeshes,sizeLods:this._sizeLods,sigmas:this._sigmas}=sy(r)),this._blurMaterial=ay(r,e,t),this._ggxMaterial=ry(r,e,t)}return s}_compileMaterial(e){const t=new An(new $t,e);this._renderer.compile(t,rr)}_sceneToCubeUV(e,t,i,s,r){const c=new vn(90,1,t,i),l=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],f=this._renderer,h=f.autoClear,d=f.toneMapping;f.getClearColor(Xh),f.toneMapping=jn,f.autoClear=!1,f.state.buffers.depth.getReversed()&&(f.setRenderTarget(s),f.clearDepth(),f.setRenderTarget(null)),this._backgroundBox===null&&(this._backgroundBox=new An(new kr,new Gp({name:"PMREM.Background",side:Qt,depthWrite:!1,depthTest:!1})));const y=this._backgroundBox,p=y.material;let m=!1;const v=e.background;v?v.isColor&&(p.color.copy(v),e.background=null,m=!0):(p.color.copy(Xh),m=!0);for(let b=0;b<6;b++){const x=b%3;x===0?(c.up.set(0,l[b],0),c.position.set(r.x,r.y,r.z),c.lookAt(r.x+u[b],r.y,r.z)):x===1?(c.up.set(0,0,l[b]),c.position.set(r.x,r.y,r.z),c.lookAt(r.x,r.y+u[b],r.z)):(c.up.set(0,l[b],0),c.position.set(r.x,r.y,r.z),c.lookAt(r.x,r.y,r.z+u[b]));const E=this._cubeSize;Ms(s,x*E,b>2?E:0,E,E),f.setRenderTarget(s),m&&f.render(y,c),f.render(e,c)}f.toneMapping=d,f.autoClear=h,e.background=v}_textureToCubeUV(e,t){const i=this._renderer,s=e.mapping===ns||e.mapping===Ws;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=$h()),this._cubemapMaterial.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Kh());const r=s?this._cubemapMaterial:this._equirectMaterial,a=this._lodMeshes[0];a.material=r;const o=r.uniforms;o.envMap.value=e;const c=this._cubeSize;Ms(t,0,0,3*c,2*c),i.setRenderTarget(t),i.render(a,rr)}_applyPMREM(e){const t=this._renderer,i=t.autoClear;t.autoClear=!1;const s=this._lodMeshes.length;for(let r=1;r<s;r++)this._applyGGXFilter(e,r-1,r);t.autoClear=i}_applyGGXFilter(e,t,i){const s=this._renderer,r=this._pingPongRenderTarget,a=this._ggxMaterial,o=this._lodMeshes[i];o.material=a;const c=a.uniforms,l=i/(this._lodMeshes.length-1),u=t/(this._lodMeshes.length-1),f=Math.sqrt(l*l-u*u),h=0+l*1.25,d=f*h,{_lodMax:g}=this,y=this._sizeLods[i],p=3*y*(i>g-Di?i-g+Di:0),m=4*(this._cubeSize-y);c.envMap.value=e.texture,c.roughness.value=d,c.mipInt.value=g-t,Ms(r,p,m,3*y,2*y),s.setRenderTarget(r),s.render(o,rr),c.envMap.value=r.texture,c.roughness.value=0,c.mipInt.value=g-i,Ms(e,p,m,3*y,2*y),s.setRenderTarget(e),s.render(o,rr)}_blur(e,t,i,s,r){const a=this._pingPongRenderTarget;this._halfBlur(e,a,t,i,s,"latitudinal",r),this._halfBlur(a,e,i,i,s,"longitudinal",r)}_halfBlur(e,t,i,s,r,a,o){const c=this._renderer,l=this._blurMaterial;a!=="latitudinal"&&a!=="longitudinal"&&Ze("blur direction must be either latitudinal or longitudinal!");const u=3,f=this._lodMeshes[s];f.material=l;const h=l.uniforms,d=this._sizeLods[i]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Ji-1),y=r/g,p=isFinite(r)?1+Math.floor(u*y):Ji;p>Ji&&Ne(`sigmaRadians, ${r}, is too large and will clip, as it requested ${p} samples when the maximum is set to ${Ji}`);const m=[];let v=0;for(let T=0;T<Ji;++T){const _=T/y,M=Math.exp(-_*_/2);m.push(M),T===0?v+=M:T<p&&(v+=2*M)}for(let T=0;T<m.length;T++)m[T]=m[T]/v;h.envMap.value=e.texture,h.samples.value=p,h.weights.value=m,h.latitudinal.value=a==="latitudinal",o&&(h.poleAxis.value=o);const{_lodMax:b}=this;h.dTheta.value=g,h.mipInt.value=b-i;const x=this._sizeLods[s],E=3*x*(s>b-Di?s-b+Di:0),w=4*(this._cubeSize-x);Ms(t,E,w,3*x,2*x),c.setRenderTarget(t),c.render(f,rr)}}function sy(n){const e=[],t=[],i=[];let s=n;const r=n-Di+1+Hh.length;for(let a=0;a<r;a++){const o=Math.pow(2,s);e.push(o);let c=1/o;a>n-Di?c=Hh[a-n+Di-1]:a===0&&(c=0),t.push(c);const l=1/(o-2),u=-l,f=1+l,h=[u,u,f,u,f,f,u,u,f,f,u,f],d=6,g=6,y=3,p=2,m=1,v=new Float32Array(y*g*d),b=new Float32Array(p*g*d),x=new Float32Array(m*g*d);for(let w=0;w<d;w++){const T=w%3*2/3-1,_=w>2?0:-1,M=[T,_,0,T+2/3,_,0,T+2/3,_+1,0,T,_,0,T+2/3,_+1,0,T,_+1,0];v.set(M,y*g*w),b.set(h,p*g*w);const N=[w,w,w,w,w,w];x.set(N,m*g*w)}const E=new $t;E.setAttribute("position",new Et(v,y)),E.setAttribute("uv",new Et(b,p)),E.setAttribute("faceIndex",new Et(x,m)),i.push(new An(E,null)),s>Di&&s--}return{lodMeshes:i,sizeLods:e,sigmas:t}}function Yh(n,e,t){const i=new Un(n,e,t);return i.texture.mapping=yo,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function Ms(n,e,t,i,s){n.viewport.set(e,t,i,s),n.scissor.set(e,t,i,s)}function ry(n,e,t){return new on({name:"PMREMGGXConvolution",defines:{GGX_SAMPLES:ny,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},roughness:{value:0},mipInt:{value:0}},vertexShader:bo(),fragmentShader:`

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
		`,blending:hi,depthTest:!1,depthWrite:!1})}function ay(n,e,t){const i=new Float32Array(Ji),s=new P(0,1,0);return new on({name:"SphericalGaussianBlur",defines:{n:Ji,CUBEUV_TEXEL_WIDTH:1/e,CUBEUV_TEXEL_HEIGHT:1/t,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:bo(),fragmentShader:`

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
		`,blending:hi,depthTest:!1,depthWrite:!1})}function Kh(){return new on({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:bo(),fragmentShader:`

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
		`,blending:hi,depthTest:!1,depthWrite:!1})}function $h(){return new on({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:bo(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:hi,depthTest:!1,depthWrite:!1})}function bo(){return`

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
	`}class jp extends Un{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;const i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Hp(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new kr(5,5,5),r=new on({name:"CubemapFromEquirect",uniforms:Hs(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Qt,blending:hi});r.uniforms.tEquirect.value=t;const a=new An(s,r),o=t.minFilter;return t.minFilter===ji&&(t.minFilter=Ht),new c_(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){const r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,i,s);e.setRenderTarget(r)}}function oy(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?a(h):r(h)}function r(h){if(h&&h.isTexture){const d=h.mapping;if(d===Oo||d===Vo)if(e.has(h)){const g=e.get(h).texture;return o(g,h.mapping)}else{const g=h.image;if(g&&g.height>0){const y=new jp(g.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",l),o(y.texture,h.mapping)}else return null}}return h}function a(h){if(h&&h.isTexture){const d=h.mapping,g=d===Oo||d===Vo,y=d===ns||d===Ws;if(g||y){let p=t.get(h);const m=p!==void 0?p.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Zh(n)),p=g?i.fromEquirectangular(h,p):i.fromCubemap(h,p),p.texture.pmremVersion=h.pmremVersion,t.set(h,p),p.texture;if(p!==void 0)return p.texture;{const v=h.image;return g&&v&&v.height>0||y&&v&&c(v)?(i===null&&(i=new Zh(n)),p=g?i.fromEquirectangular(h):i.fromCubemap(h),p.texture.pmremVersion=h.pmremVersion,t.set(h,p),h.addEventListener("dispose",u),p.texture):null}}}return h}function o(h,d){return d===Oo?h.mapping=ns:d===Vo&&(h.mapping=Ws),h}function c(h){let d=0;const g=6;for(let y=0;y<g;y++)h[y]!==void 0&&d++;return d===g}function l(h){const d=h.target;d.removeEventListener("dispose",l);const g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function u(h){const d=h.target;d.removeEventListener("dispose",u);const g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function cy(n){const e={};function t(i){if(e[i]!==void 0)return e[i];const s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){const s=t(i);return s===null&&Ll("WebGLRenderer: "+i+" extension not supported."),s}}}function ly(n,e,t,i){const s={},r=new WeakMap;function a(f){const h=f.target;h.index!==null&&e.remove(h.index);for(const g in h.attributes)e.remove(h.attributes[g]);h.removeEventListener("dispose",a),delete s[h.id];const d=r.get(h);d&&(e.remove(d),r.delete(h)),i.releaseStatesOfGeometry(h),h.isInstancedBufferGeometry===!0&&delete h._maxInstanceCount,t.memory.geometries--}function o(f,h){return s[h.id]===!0||(h.addEventListener("dispose",a),s[h.id]=!0,t.memory.geometries++),h}function c(f){const h=f.attributes;for(const d in h)e.update(h[d],n.ARRAY_BUFFER)}function l(f){const h=[],d=f.index,g=f.attributes.position;let y=0;if(g===void 0)return;if(d!==null){const v=d.array;y=d.version;for(let b=0,x=v.length;b<x;b+=3){const E=v[b+0],w=v[b+1],T=v[b+2];h.push(E,w,w,T,T,E)}}else{const v=g.array;y=g.version;for(let b=0,x=v.length/3-1;b<x;b+=3){const E=b+0,w=b+1,T=b+2;h.push(E,w,w,T,T,E)}}const p=new(g.count>=65535?kp:Vp)(h,1);p.version=y;const m=r.get(f);m&&e.remove(m),r.set(f,p)}function u(f){const h=r.get(f);if(h){const d=f.index;d!==null&&h.version<d.version&&l(f)}else l(f);return r.get(f)}return{get:o,update:c,getWireframeAttribute:u}}function uy(n,e,t){let i;function s(f){i=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function c(f,h){n.drawElements(i,h,r,f*a),t.update(h,i,1)}function l(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*a,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let y=0;for(let p=0;p<d;p++)y+=h[p];t.update(y,i,1)}this.setMode=s,this.setIndex=o,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function hy(n){const e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,a,o){switch(t.calls++,a){case n.TRIANGLES:t.triangles+=o*(r/3);break;case n.LINES:t.lines+=o*(r/2);break;case n.LINE_STRIP:t.lines+=o*(r-1);break;case n.LINE_LOOP:t.lines+=o*r;break;case n.POINTS:t.points+=o*r;break;default:Ze("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function fy(n,e,t){const i=new WeakMap,s=new ht;function r(a,o,c){const l=a.morphTargetInfluences,u=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=u!==void 0?u.length:0;let h=i.get(o);if(h===void 0||h.count!==f){let N=function(){_.dispose(),i.delete(o),o.removeEventListener("dispose",N)};var d=N;h!==void 0&&h.texture.dispose();const g=o.morphAttributes.position!==void 0,y=o.morphAttributes.normal!==void 0,p=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],v=o.morphAttributes.normal||[],b=o.morphAttributes.color||[];let x=0;g===!0&&(x=1),y===!0&&(x=2),p===!0&&(x=3);let E=o.attributes.position.count*x,w=1;E>e.maxTextureSize&&(w=Math.ceil(E/e.maxTextureSize),E=e.maxTextureSize);const T=new Float32Array(E*w*4*f),_=new Bp(T,E,w,f);_.type=$n,_.needsUpdate=!0;const M=x*4;for(let R=0;R<f;R++){const C=m[R],U=v[R],B=b[R],L=E*w*4*R;for(let V=0;V<C.count;V++){const k=V*M;g===!0&&(s.fromBufferAttribute(C,V),T[L+k+0]=s.x,T[L+k+1]=s.y,T[L+k+2]=s.z,T[L+k+3]=0),y===!0&&(s.fromBufferAttribute(U,V),T[L+k+4]=s.x,T[L+k+5]=s.y,T[L+k+6]=s.z,T[L+k+7]=0),p===!0&&(s.fromBufferAttribute(B,V),T[L+k+8]=s.x,T[L+k+9]=s.y,T[L+k+10]=s.z,T[L+k+11]=B.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new we(E,w)},i.set(o,h),o.addEventListener("dispose",N)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",a.morphTexture,t);else{let g=0;for(let p=0;p<l.length;p++)g+=l[p];const y=o.morphTargetsRelative?1:1-g;c.getUniforms().setValue(n,"morphTargetBaseInfluence",y),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),c.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function dy(n,e,t,i,s){let r=new WeakMap;function a(l){const u=s.render.frame,f=l.geometry,h=e.get(l,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(t.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){const d=l.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function o(){r=new WeakMap}function c(l){const u=l.target;u.removeEventListener("dispose",c),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:a,dispose:o}}const py={[yp]:"LINEAR_TONE_MAPPING",[bp]:"REINHARD_TONE_MAPPING",[Sp]:"CINEON_TONE_MAPPING",[Ep]:"ACES_FILMIC_TONE_MAPPING",[Ap]:"AGX_TONE_MAPPING",[wp]:"NEUTRAL_TONE_MAPPING",[Mp]:"CUSTOM_TONE_MAPPING"};function my(n,e,t,i,s){const r=new Un(e,t,{type:n,depthBuffer:i,stencilBuffer:s,depthTexture:i?new rs(e,t):void 0}),a=new Un(e,t,{type:pi,depthBuffer:!1,stencilBuffer:!1}),o=new $t;o.setAttribute("position",new Mn([-1,3,0,-1,-1,0,3,-1,0],3)),o.setAttribute("uv",new Mn([0,2,0,0,2,0],2));const c=new s_({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),l=new An(o,c),u=new gu(-1,1,1,-1,0,1);let f=null,h=null,d=!1,g,y=null,p=[],m=!1;this.setSize=function(v,b){r.setSize(v,b),a.setSize(v,b);for(let x=0;x<p.length;x++){const E=p[x];E.setSize&&E.setSize(v,b)}},this.setEffects=function(v){p=v,m=p.length>0&&p[0].isRenderPass===!0;const b=r.width,x=r.height;for(let E=0;E<p.length;E++){const w=p[E];w.setSize&&w.setSize(b,x)}},this.begin=function(v,b){if(d||v.toneMapping===jn&&p.length===0)return!1;if(y=b,b!==null){const x=b.width,E=b.height;(r.width!==x||r.height!==E)&&this.setSize(x,E)}return m===!1&&v.setRenderTarget(r),g=v.toneMapping,v.toneMapping=jn,!0},this.hasRenderPass=function(){return m},this.end=function(v,b){v.toneMapping=g,d=!0;let x=r,E=a;for(let w=0;w<p.length;w++){const T=p[w];if(T.enabled!==!1&&(T.render(v,E,x,b),T.needsSwap!==!1)){const _=x;x=E,E=_}}if(f!==v.outputColorSpace||h!==v.toneMapping){f=v.outputColorSpace,h=v.toneMapping,c.defines={},Xe.getTransfer(f)===Qe&&(c.defines.SRGB_TRANSFER="");const w=py[h];w&&(c.defines[w]=""),c.needsUpdate=!0}c.uniforms.tDiffuse.value=x.texture,v.setRenderTarget(y),v.render(l,u),y=null,d=!1},this.isCompositing=function(){return d},this.dispose=function(){r.depthTexture&&r.depthTexture.dispose(),r.dispose(),a.dispose(),o.dispose(),c.dispose()}}const qp=new en,Bl=new rs(1,1),Qp=new Bp,em=new D0,tm=new Hp,Jh=[],jh=[],qh=new Float32Array(16),Qh=new Float32Array(9),ef=new Float32Array(4);function Qs(n,e,t){const i=n[0];if(i<=0||i>0)return n;const s=e*t;let r=Jh[s];if(r===void 0&&(r=new Float32Array(s),Jh[s]=r),e!==0){i.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,n[a].toArray(r,o)}return r}function Pt(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Lt(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function So(n,e){let t=jh[e];t===void 0&&(t=new Int32Array(e),jh[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function gy(n,e){const t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function _y(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pt(t,e))return;n.uniform2fv(this.addr,e),Lt(t,e)}}function vy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Pt(t,e))return;n.uniform3fv(this.addr,e),Lt(t,e)}}function xy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pt(t,e))return;n.uniform4fv(this.addr,e),Lt(t,e)}}function yy(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Pt(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Lt(t,e)}else{if(Pt(t,i))return;ef.set(i),n.uniformMatrix2fv(this.addr,!1,ef),Lt(t,i)}}function by(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Pt(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Lt(t,e)}else{if(Pt(t,i))return;Qh.set(i),n.uniformMatrix3fv(this.addr,!1,Qh),Lt(t,i)}}function Sy(n,e){const t=this.cache,i=e.elements;if(i===void 0){if(Pt(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Lt(t,e)}else{if(Pt(t,i))return;qh.set(i),n.uniformMatrix4fv(this.addr,!1,qh),Lt(t,i)}}function Ey(n,e){const t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function My(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pt(t,e))return;n.uniform2iv(this.addr,e),Lt(t,e)}}function Ay(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Pt(t,e))return;n.uniform3iv(this.addr,e),Lt(t,e)}}function wy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pt(t,e))return;n.uniform4iv(this.addr,e),Lt(t,e)}}function Ty(n,e){const t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function Ry(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pt(t,e))return;n.uniform2uiv(this.addr,e),Lt(t,e)}}function Ny(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Pt(t,e))return;n.uniform3uiv(this.addr,e),Lt(t,e)}}function Iy(n,e){const t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pt(t,e))return;n.uniform4uiv(this.addr,e),Lt(t,e)}}function Cy(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(Bl.compareFunction=t.isReversedDepthBuffer()?hu:uu,r=Bl):r=qp,t.setTexture2D(e||r,s)}function Py(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||em,s)}function Ly(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTextureCube(e||tm,s)}function Dy(n,e,t){const i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Qp,s)}function Uy(n){switch(n){case 5126:return gy;case 35664:return _y;case 35665:return vy;case 35666:return xy;case 35674:return yy;case 35675:return by;case 35676:return Sy;case 5124:case 35670:return Ey;case 35667:case 35671:return My;case 35668:case 35672:return Ay;case 35669:case 35673:return wy;case 5125:return Ty;case 36294:return Ry;case 36295:return Ny;case 36296:return Iy;case 35678:case 36198:case 36298:case 36306:case 35682:return Cy;case 35679:case 36299:case 36307:return Py;case 35680:case 36300:case 36308:case 36293:return Ly;case 36289:case 36303:case 36311:case 36292:return Dy}}function Fy(n,e){n.uniform1fv(this.addr,e)}function By(n,e){const t=Qs(e,this.size,2);n.uniform2fv(this.addr,t)}function Oy(n,e){const t=Qs(e,this.size,3);n.uniform3fv(this.addr,t)}function Vy(n,e){const t=Qs(e,this.size,4);n.uniform4fv(this.addr,t)}function ky(n,e){const t=Qs(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function Gy(n,e){const t=Qs(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function zy(n,e){const t=Qs(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function Wy(n,e){n.uniform1iv(this.addr,e)}function Hy(n,e){n.uniform2iv(this.addr,e)}function Xy(n,e){n.uniform3iv(this.addr,e)}function Zy(n,e){n.uniform4iv(this.addr,e)}function Yy(n,e){n.uniform1uiv(this.addr,e)}function Ky(n,e){n.uniform2uiv(this.addr,e)}function $y(n,e){n.uniform3uiv(this.addr,e)}function Jy(n,e){n.uniform4uiv(this.addr,e)}function jy(n,e,t){const i=this.cache,s=e.length,r=So(t,s);Pt(i,r)||(n.uniform1iv(this.addr,r),Lt(i,r));let a;this.type===n.SAMPLER_2D_SHADOW?a=Bl:a=qp;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function qy(n,e,t){const i=this.cache,s=e.length,r=So(t,s);Pt(i,r)||(n.uniform1iv(this.addr,r),Lt(i,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||em,r[a])}function Qy(n,e,t){const i=this.cache,s=e.length,r=So(t,s);Pt(i,r)||(n.uniform1iv(this.addr,r),Lt(i,r));for(let a=0;a!==s;++a)t.setTextureCube(e[a]||tm,r[a])}function eb(n,e,t){const i=this.cache,s=e.length,r=So(t,s);Pt(i,r)||(n.uniform1iv(this.addr,r),Lt(i,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||Qp,r[a])}function tb(n){switch(n){case 5126:return Fy;case 35664:return By;case 35665:return Oy;case 35666:return Vy;case 35674:return ky;case 35675:return Gy;case 35676:return zy;case 5124:case 35670:return Wy;case 35667:case 35671:return Hy;case 35668:case 35672:return Xy;case 35669:case 35673:return Zy;case 5125:return Yy;case 36294:return Ky;case 36295:return $y;case 36296:return Jy;case 35678:case 36198:case 36298:case 36306:case 35682:return jy;case 35679:case 36299:case 36307:return qy;case 35680:case 36300:case 36308:case 36293:return Qy;case 36289:case 36303:case 36311:case 36292:return eb}}class nb{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=Uy(t.type)}}class ib{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=tb(t.type)}}class sb{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){const s=this.seq;for(let r=0,a=s.length;r!==a;++r){const o=s[r];o.setValue(e,t[o.id],i)}}}const mc=/(\w+)(\])?(\[|\.)?/g;function tf(n,e){n.seq.push(e),n.map[e.id]=e}function rb(n,e,t){const i=n.name,s=i.length;for(mc.lastIndex=0;;){const r=mc.exec(i),a=mc.lastIndex;let o=r[1];const c=r[2]==="]",l=r[3];if(c&&(o=o|0),l===void 0||l==="["&&a+2===s){tf(t,l===void 0?new nb(o,n,e):new ib(o,n,e));break}else{let f=t.map[o];f===void 0&&(f=new sb(o),tf(t,f)),t=f}}}class ja{constructor(e,t){this.seq=[],this.map={};const i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<i;++a){const o=e.getActiveUniform(t,a),c=e.getUniformLocation(t,o.name);rb(o,c,this)}const s=[],r=[];for(const a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){const r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){const s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,a=t.length;r!==a;++r){const o=t[r],c=i[o.id];c.needsUpdate!==!1&&o.setValue(e,c.value,s)}}static seqWithValue(e,t){const i=[];for(let s=0,r=e.length;s!==r;++s){const a=e[s];a.id in t&&i.push(a)}return i}}function nf(n,e,t){const i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}const ab=37297;let ob=0;function cb(n,e){const t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){const o=a+1;i.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return i.join(`
`)}const sf=new Ue;function lb(n){Xe._getMatrix(sf,Xe.workingColorSpace,n);const e=`mat3( ${sf.elements.map(t=>t.toFixed(4))} )`;switch(Xe.getTransfer(n)){case ao:return[e,"LinearTransferOETF"];case Qe:return[e,"sRGBTransferOETF"];default:return Ne("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function rf(n,e,t){const i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";const a=/ERROR: 0:(\d+)/.exec(r);if(a){const o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+cb(n.getShaderSource(e),o)}else return r}function ub(n,e){const t=lb(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( value.rgb * ${t[0]}, value.a ) );`,"}"].join(`
`)}const hb={[yp]:"Linear",[bp]:"Reinhard",[Sp]:"Cineon",[Ep]:"ACESFilmic",[Ap]:"AgX",[wp]:"Neutral",[Mp]:"Custom"};function fb(n,e){const t=hb[e];return t===void 0?(Ne("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}const ya=new P;function db(){Xe.getLuminanceCoefficients(ya);const n=ya.x.toFixed(4),e=ya.y.toFixed(4),t=ya.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function pb(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(xr).join(`
`)}function mb(n){const e=[];for(const t in n){const i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function gb(n,e){const t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(e,s),a=r.name;let o=1;r.type===n.FLOAT_MAT2&&(o=2),r.type===n.FLOAT_MAT3&&(o=3),r.type===n.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:n.getAttribLocation(e,a),locationSize:o}}return t}function xr(n){return n!==""}function af(n,e){const t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows)}function of(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}const _b=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ol(n){return n.replace(_b,xb)}const vb=new Map;function xb(n,e){let t=Ve[e];if(t===void 0){const i=vb.get(e);if(i!==void 0)t=Ve[i],Ne('WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',e,i);else throw new Error("Can not resolve #include <"+e+">")}return Ol(t)}const yb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function cf(n){return n.replace(yb,bb)}function bb(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function lf(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}const Sb={[Za]:"SHADOWMAP_TYPE_PCF",[_r]:"SHADOWMAP_TYPE_VSM"};function Eb(n){return Sb[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const Mb={[ns]:"ENVMAP_TYPE_CUBE",[Ws]:"ENVMAP_TYPE_CUBE",[yo]:"ENVMAP_TYPE_CUBE_UV"};function Ab(n){return n.envMap===!1?"ENVMAP_TYPE_CUBE":Mb[n.envMapMode]||"ENVMAP_TYPE_CUBE"}const wb={[Ws]:"ENVMAP_MODE_REFRACTION"};function Tb(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":wb[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}const Rb={[xp]:"ENVMAP_BLENDING_MULTIPLY",[jg]:"ENVMAP_BLENDING_MIX",[qg]:"ENVMAP_BLENDING_ADD"};function Nb(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Rb[n.combine]||"ENVMAP_BLENDING_NONE"}function Ib(n){const e=n.envMapCubeUVHeight;if(e===null)return null;const t=Math.log2(e)-2,i=1/e;return{texelWidth:1/(3*Math.max(Math.pow(2,t),112)),texelHeight:i,maxMip:t}}function Cb(n,e,t,i){const s=n.getContext(),r=t.defines;let a=t.vertexShader,o=t.fragmentShader;const c=Eb(t),l=Ab(t),u=Tb(t),f=Nb(t),h=Ib(t),d=pb(t),g=mb(r),y=s.createProgram();let p,m,v=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(xr).join(`
`),p.length>0&&(p+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g].filter(xr).join(`
`),m.length>0&&(m+=`
`)):(p=[lf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(xr).join(`
`),m=[lf(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,g,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",h?"#define CUBEUV_TEXEL_WIDTH "+h.texelWidth:"",h?"#define CUBEUV_TEXEL_HEIGHT "+h.texelHeight:"",h?"#define CUBEUV_MAX_MIP "+h.maxMip+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.numLightProbeGrids>0?"#define USE_LIGHT_PROBES_GRID":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==jn?"#define TONE_MAPPING":"",t.toneMapping!==jn?Ve.tonemapping_pars_fragment:"",t.toneMapping!==jn?fb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Ve.colorspace_pars_fragment,ub("linearToOutputTexel",t.outputColorSpace),db(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(xr).join(`
`)),a=Ol(a),a=af(a,t),a=of(a,t),o=Ol(o),o=af(o,t),o=of(o,t),a=cf(a),o=cf(o),t.isRawShaderMaterial!==!0&&(v=`#version 300 es
`,p=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+p,m=["#define varying in",t.glslVersion===gh?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===gh?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);const b=v+p+a,x=v+m+o,E=nf(s,s.VERTEX_SHADER,b),w=nf(s,s.FRAGMENT_SHADER,x);s.attachShader(y,E),s.attachShader(y,w),t.index0AttributeName!==void 0?s.bindAttribLocation(y,0,t.index0AttributeName):t.morphTargets===!0&&s.bindAttribLocation(y,0,"position"),s.linkProgram(y);function T(R){if(n.debug.checkShaderErrors){const C=s.getProgramInfoLog(y)||"",U=s.getShaderInfoLog(E)||"",B=s.getShaderInfoLog(w)||"",L=C.trim(),V=U.trim(),k=B.trim();let j=!0,ee=!0;if(s.getProgramParameter(y,s.LINK_STATUS)===!1)if(j=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,y,E,w);else{const le=rf(s,E,"vertex"),xe=rf(s,w,"fragment");Ze("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(y,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+L+`
`+le+`
`+xe)}else L!==""?Ne("WebGLProgram: Program Info Log:",L):(V===""||k==="")&&(ee=!1);ee&&(R.diagnostics={runnable:j,programLog:L,vertexShader:{log:V,prefix:p},fragmentShader:{log:k,prefix:m}})}s.deleteShader(E),s.deleteShader(w),_=new ja(s,y),M=gb(s,y)}let _;this.getUniforms=function(){return _===void 0&&T(this),_};let M;this.getAttributes=function(){return M===void 0&&T(this),M};let N=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(y,ab)),N},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(y),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=ob++,this.cacheKey=e,this.usedTimes=1,this.program=y,this.vertexShader=E,this.fragmentShader=w,this}let Pb=0;class Lb{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e){const t=e.vertexShader,i=e.fragmentShader,s=this._getShaderStage(t),r=this._getShaderStage(i),a=this._getShaderCacheForMaterial(e);return a.has(s)===!1&&(a.add(s),s.usedTimes++),a.has(r)===!1&&(a.add(r),r.usedTimes++),this}remove(e){const t=this.materialCache.get(e);for(const i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderID(e){return this._getShaderStage(e.vertexShader).id}getFragmentShaderID(e){return this._getShaderStage(e.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){const t=this.materialCache;let i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){const t=this.shaderCache;let i=t.get(e);return i===void 0&&(i=new Db(e),t.set(e,i)),i}}class Db{constructor(e){this.id=Pb++,this.code=e,this.usedTimes=0}}function Ub(n){return n===is||n===so||n===ro}function Fb(n,e,t,i,s,r){const a=new pu,o=new Lb,c=new Set,l=[],u=new Map,f=i.logarithmicDepthBuffer;let h=i.precision;const d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function g(_){return c.add(_),_===0?"uv":`uv${_}`}function y(_,M,N,R,C,U){const B=R.fog,L=C.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?R.environment:null,k=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,j=e.get(_.envMap||V,k),ee=j&&j.mapping===yo?j.image.height:null,le=d[_.type];_.precision!==null&&(h=i.getMaxPrecision(_.precision),h!==_.precision&&Ne("WebGLProgram.getParameters:",_.precision,"not supported, using",h,"instead."));const xe=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ye=xe!==void 0?xe.length:0;let ze=0;L.morphAttributes.position!==void 0&&(ze=1),L.morphAttributes.normal!==void 0&&(ze=2),L.morphAttributes.color!==void 0&&(ze=3);let qe,Ie,J,he;if(le){const Fe=sn[le];qe=Fe.vertexShader,Ie=Fe.fragmentShader}else qe=_.vertexShader,Ie=_.fragmentShader,o.update(_),J=o.getVertexShaderID(_),he=o.getFragmentShaderID(_);const se=n.getRenderTarget(),Te=n.state.buffers.depth.getReversed(),Ce=C.isInstancedMesh===!0,Re=C.isBatchedMesh===!0,at=!!_.map,We=!!_.matcap,nt=!!j,ft=!!_.aoMap,Ge=!!_.lightMap,Tt=!!_.bumpMap,pt=!!_.normalMap,cn=!!_.displacementMap,F=!!_.emissiveMap,Rt=!!_.metalnessMap,He=!!_.roughnessMap,lt=_.anisotropy>0,ue=_.clearcoat>0,mt=_.dispersion>0,I=_.iridescence>0,S=_.sheen>0,z=_.transmission>0,K=lt&&!!_.anisotropyMap,Q=ue&&!!_.clearcoatMap,te=ue&&!!_.clearcoatNormalMap,oe=ue&&!!_.clearcoatRoughnessMap,Z=I&&!!_.iridescenceMap,$=I&&!!_.iridescenceThicknessMap,pe=S&&!!_.sheenColorMap,_e=S&&!!_.sheenRoughnessMap,re=!!_.specularMap,ne=!!_.specularColorMap,Pe=!!_.specularIntensityMap,Oe=z&&!!_.transmissionMap,$e=z&&!!_.thicknessMap,D=!!_.gradientMap,ie=!!_.alphaMap,Y=_.alphaTest>0,me=!!_.alphaHash,ae=!!_.extensions;let q=jn;_.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(q=n.toneMapping);const Se={shaderID:le,shaderType:_.type,shaderName:_.name,vertexShader:qe,fragmentShader:Ie,defines:_.defines,customVertexShaderID:J,customFragmentShaderID:he,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:h,batching:Re,batchingColor:Re&&C._colorsTexture!==null,instancing:Ce,instancingColor:Ce&&C.instanceColor!==null,instancingMorph:Ce&&C.morphTexture!==null,outputColorSpace:se===null?n.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:Xe.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:at,matcap:We,envMap:nt,envMapMode:nt&&j.mapping,envMapCubeUVHeight:ee,aoMap:ft,lightMap:Ge,bumpMap:Tt,normalMap:pt,displacementMap:cn,emissiveMap:F,normalMapObjectSpace:pt&&_.normalMapType===t0,normalMapTangentSpace:pt&&_.normalMapType===ph,packedNormalMap:pt&&_.normalMapType===ph&&Ub(_.normalMap.format),metalnessMap:Rt,roughnessMap:He,anisotropy:lt,anisotropyMap:K,clearcoat:ue,clearcoatMap:Q,clearcoatNormalMap:te,clearcoatRoughnessMap:oe,dispersion:mt,iridescence:I,iridescenceMap:Z,iridescenceThicknessMap:$,sheen:S,sheenColorMap:pe,sheenRoughnessMap:_e,specularMap:re,specularColorMap:ne,specularIntensityMap:Pe,transmission:z,transmissionMap:Oe,thicknessMap:$e,gradientMap:D,opaque:_.transparent===!1&&_.blending===Vs&&_.alphaToCoverage===!1,alphaMap:ie,alphaTest:Y,alphaHash:me,combine:_.combine,mapUv:at&&g(_.map.channel),aoMapUv:ft&&g(_.aoMap.channel),lightMapUv:Ge&&g(_.lightMap.channel),bumpMapUv:Tt&&g(_.bumpMap.channel),normalMapUv:pt&&g(_.normalMap.channel),displacementMapUv:cn&&g(_.displacementMap.channel),emissiveMapUv:F&&g(_.emissiveMap.channel),metalnessMapUv:Rt&&g(_.metalnessMap.channel),roughnessMapUv:He&&g(_.roughnessMap.channel),anisotropyMapUv:K&&g(_.anisotropyMap.channel),clearcoatMapUv:Q&&g(_.clearcoatMap.channel),clearcoatNormalMapUv:te&&g(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:oe&&g(_.clearcoatRoughnessMap.channel),iridescenceMapUv:Z&&g(_.iridescenceMap.channel),iridescenceThicknessMapUv:$&&g(_.iridescenceThicknessMap.channel),sheenColorMapUv:pe&&g(_.sheenColorMap.channel),sheenRoughnessMapUv:_e&&g(_.sheenRoughnessMap.channel),specularMapUv:re&&g(_.specularMap.channel),specularColorMapUv:ne&&g(_.specularColorMap.channel),specularIntensityMapUv:Pe&&g(_.specularIntensityMap.channel),transmissionMapUv:Oe&&g(_.transmissionMap.channel),thicknessMapUv:$e&&g(_.thicknessMap.channel),alphaMapUv:ie&&g(_.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(pt||lt),vertexNormals:!!L.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!L.attributes.uv&&(at||ie),fog:!!B,useFog:_.fog===!0,fogExp2:!!B&&B.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||L.attributes.normal===void 0&&pt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Te,skinning:C.isSkinnedMesh===!0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ye,morphTextureStride:ze,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:U.length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&N.length>0,shadowMapType:n.shadowMap.type,toneMapping:q,decodeVideoTexture:at&&_.map.isVideoTexture===!0&&Xe.getTransfer(_.map.colorSpace)===Qe,decodeVideoTextureEmissive:F&&_.emissiveMap.isVideoTexture===!0&&Xe.getTransfer(_.emissiveMap.colorSpace)===Qe,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===yn,flipSided:_.side===Qt,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:ae&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(ae&&_.extensions.multiDraw===!0||Re)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Se.vertexUv1s=c.has(1),Se.vertexUv2s=c.has(2),Se.vertexUv3s=c.has(3),c.clear(),Se}function p(_){const M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(const N in _.defines)M.push(N),M.push(_.defines[N]);return _.isRawShaderMaterial===!1&&(m(M,_),v(M,_),M.push(n.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function m(_,M){_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapCubeUVHeight),_.push(M.mapUv),_.push(M.alphaMapUv),_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),_.push(M.morphAttributeCount),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(M.numLightProbes),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.depthPacking)}function v(_,M){a.disableAll(),M.instancing&&a.enable(0),M.instancingColor&&a.enable(1),M.instancingMorph&&a.enable(2),M.matcap&&a.enable(3),M.envMap&&a.enable(4),M.normalMapObjectSpace&&a.enable(5),M.normalMapTangentSpace&&a.enable(6),M.clearcoat&&a.enable(7),M.iridescence&&a.enable(8),M.alphaTest&&a.enable(9),M.vertexColors&&a.enable(10),M.vertexAlphas&&a.enable(11),M.vertexUv1s&&a.enable(12),M.vertexUv2s&&a.enable(13),M.vertexUv3s&&a.enable(14),M.vertexTangents&&a.enable(15),M.anisotropy&&a.enable(16),M.alphaHash&&a.enable(17),M.batching&&a.enable(18),M.dispersion&&a.enable(19),M.batchingColor&&a.enable(20),M.gradientMap&&a.enable(21),M.packedNormalMap&&a.enable(22),M.vertexNormals&&a.enable(23),_.push(a.mask),a.disableAll(),M.fog&&a.enable(0),M.useFog&&a.enable(1),M.flatShading&&a.enable(2),M.logarithmicDepthBuffer&&a.enable(3),M.reversedDepthBuffer&&a.enable(4),M.skinning&&a.enable(5),M.morphTargets&&a.enable(6),M.morphNormals&&a.enable(7),M.morphColors&&a.enable(8),M.premultipliedAlpha&&a.enable(9),M.shadowMapEnabled&&a.enable(10),M.doubleSided&&a.enable(11),M.flipSided&&a.enable(12),M.useDepthPacking&&a.enable(13),M.dithering&&a.enable(14),M.transmission&&a.enable(15),M.sheen&&a.enable(16),M.opaque&&a.enable(17),M.pointsUvs&&a.enable(18),M.decodeVideoTexture&&a.enable(19),M.decodeVideoTextureEmissive&&a.enable(20),M.alphaToCoverage&&a.enable(21),M.numLightProbeGrids>0&&a.enable(22),_.push(a.mask)}function b(_){const M=d[_.type];let N;if(M){const R=sn[M];N=mu.clone(R.uniforms)}else N=_.uniforms;return N}function x(_,M){let N=u.get(M);return N!==void 0?++N.usedTimes:(N=new Cb(n,M,_,s),l.push(N),u.set(M,N)),N}function E(_){if(--_.usedTimes===0){const M=l.indexOf(_);l[M]=l[l.length-1],l.pop(),u.delete(_.cacheKey),_.destroy()}}function w(_){o.remove(_)}function T(){o.dispose()}return{getParameters:y,getProgramCacheKey:p,getUniforms:b,acquireProgram:x,releaseProgram:E,releaseShaderCache:w,programs:l,dispose:T}}function Bb(){let n=new WeakMap;function e(a){return n.has(a)}function t(a){let o=n.get(a);return o===void 0&&(o={},n.set(a,o)),o}function i(a){n.delete(a)}function s(a,o,c){n.get(a)[o]=c}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function Ob(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function uf(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function hf(){const n=[];let e=0;const t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function a(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function o(h,d,g,y,p,m){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:g,materialVariant:a(h),groupOrder:y,renderOrder:h.renderOrder,z:p,group:m},n[e]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=g,v.materialVariant=a(h),v.groupOrder=y,v.renderOrder=h.renderOrder,v.z=p,v.group=m),e++,v}function c(h,d,g,y,p,m){const v=o(h,d,g,y,p,m);g.transmission>0?i.push(v):g.transparent===!0?s.push(v):t.push(v)}function l(h,d,g,y,p,m){const v=o(h,d,g,y,p,m);g.transmission>0?i.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||Ob),i.length>1&&i.sort(d||uf),s.length>1&&s.sort(d||uf)}function f(){for(let h=e,d=n.length;h<d;h++){const g=n[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:f,sort:u}}function Vb(){let n=new WeakMap;function e(i,s){const r=n.get(i);let a;return r===void 0?(a=new hf,n.set(i,[a])):s>=r.length?(a=new hf,r.push(a)):a=r[s],a}function t(){n=new WeakMap}return{get:e,dispose:t}}function kb(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={direction:new P,color:new Ke};break;case"SpotLight":t={position:new P,direction:new P,color:new Ke,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new P,color:new Ke,distance:0,decay:0};break;case"HemisphereLight":t={direction:new P,skyColor:new Ke,groundColor:new Ke};break;case"RectAreaLight":t={color:new Ke,position:new P,halfWidth:new P,halfHeight:new P};break}return n[e.id]=t,t}}}function Gb(){const n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new we,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}let zb=0;function Wb(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function Hb(n){const e=new kb,t=Gb(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new P);const s=new P,r=new je,a=new je;function o(l){let u=0,f=0,h=0;for(let M=0;M<9;M++)i.probe[M].set(0,0,0);let d=0,g=0,y=0,p=0,m=0,v=0,b=0,x=0,E=0,w=0,T=0;l.sort(Wb);for(let M=0,N=l.length;M<N;M++){const R=l[M],C=R.color,U=R.intensity,B=R.distance;let L=null;if(R.shadow&&R.shadow.map&&(R.shadow.map.texture.format===is?L=R.shadow.map.texture:L=R.shadow.map.depthTexture||R.shadow.map.texture),R.isAmbientLight)u+=C.r*U,f+=C.g*U,h+=C.b*U;else if(R.isLightProbe){for(let V=0;V<9;V++)i.probe[V].addScaledVector(R.sh.coefficients[V],U);T++}else if(R.isDirectionalLight){const V=e.get(R);if(V.color.copy(R.color).multiplyScalar(R.intensity),R.castShadow){const k=R.shadow,j=t.get(R);j.shadowIntensity=k.intensity,j.shadowBias=k.bias,j.shadowNormalBias=k.normalBias,j.shadowRadius=k.radius,j.shadowMapSize=k.mapSize,i.directionalShadow[d]=j,i.directionalShadowMap[d]=L,i.directionalShadowMatrix[d]=R.shadow.matrix,v++}i.directional[d]=V,d++}else if(R.isSpotLight){const V=e.get(R);V.position.setFromMatrixPosition(R.matrixWorld),V.color.copy(C).multiplyScalar(U),V.distance=B,V.coneCos=Math.cos(R.angle),V.penumbraCos=Math.cos(R.angle*(1-R.penumbra)),V.decay=R.decay,i.spot[y]=V;const k=R.shadow;if(R.map&&(i.spotLightMap[E]=R.map,E++,k.updateMatrices(R),R.castShadow&&w++),i.spotLightMatrix[y]=k.matrix,R.castShadow){const j=t.get(R);j.shadowIntensity=k.intensity,j.shadowBias=k.bias,j.shadowNormalBias=k.normalBias,j.shadowRadius=k.radius,j.shadowMapSize=k.mapSize,i.spotShadow[y]=j,i.spotShadowMap[y]=L,x++}y++}else if(R.isRectAreaLight){const V=e.get(R);V.color.copy(C).multiplyScalar(U),V.halfWidth.set(R.width*.5,0,0),V.halfHeight.set(0,R.height*.5,0),i.rectArea[p]=V,p++}else if(R.isPointLight){const V=e.get(R);if(V.color.copy(R.color).multiplyScalar(R.intensity),V.distance=R.distance,V.decay=R.decay,R.castShadow){const k=R.shadow,j=t.get(R);j.shadowIntensity=k.intensity,j.shadowBias=k.bias,j.shadowNormalBias=k.normalBias,j.shadowRadius=k.radius,j.shadowMapSize=k.mapSize,j.shadowCameraNear=k.camera.near,j.shadowCameraFar=k.camera.far,i.pointShadow[g]=j,i.pointShadowMap[g]=L,i.pointShadowMatrix[g]=R.shadow.matrix,b++}i.point[g]=V,g++}else if(R.isHemisphereLight){const V=e.get(R);V.skyColor.copy(R.color).multiplyScalar(U),V.groundColor.copy(R.groundColor).multiplyScalar(U),i.hemi[m]=V,m++}}p>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=ce.LTC_FLOAT_1,i.rectAreaLTC2=ce.LTC_FLOAT_2):(i.rectAreaLTC1=ce.LTC_HALF_1,i.rectAreaLTC2=ce.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;const _=i.hash;(_.directionalLength!==d||_.pointLength!==g||_.spotLength!==y||_.rectAreaLength!==p||_.hemiLength!==m||_.numDirectionalShadows!==v||_.numPointShadows!==b||_.numSpotShadows!==x||_.numSpotMaps!==E||_.numLightProbes!==T)&&(i.directional.length=d,i.spot.length=y,i.rectArea.length=p,i.point.length=g,i.hemi.length=m,i.directionalShadow.length=v,i.directionalShadowMap.length=v,i.pointShadow.length=b,i.pointShadowMap.length=b,i.spotShadow.length=x,i.spotShadowMap.length=x,i.directionalShadowMatrix.length=v,i.pointShadowMatrix.length=b,i.spotLightMatrix.length=x+E-w,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=w,i.numLightProbes=T,_.directionalLength=d,_.pointLength=g,_.spotLength=y,_.rectAreaLength=p,_.hemiLength=m,_.numDirectionalShadows=v,_.numPointShadows=b,_.numSpotShadows=x,_.numSpotMaps=E,_.numLightProbes=T,i.version=zb++)}function c(l,u){let f=0,h=0,d=0,g=0,y=0;const p=u.matrixWorldInverse;for(let m=0,v=l.length;m<v;m++){const b=l[m];if(b.isDirectionalLight){const x=i.directional[f];x.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(p),f++}else if(b.isSpotLight){const x=i.spot[d];x.position.setFromMatrixPosition(b.matrixWorld),x.position.applyMatrix4(p),x.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),x.direction.sub(s),x.direction.transformDirection(p),d++}else if(b.isRectAreaLight){const x=i.rectArea[g];x.position.setFromMatrixPosition(b.matrixWorld),x.position.applyMatrix4(p),a.identity(),r.copy(b.matrixWorld),r.premultiply(p),a.extractRotation(r),x.halfWidth.set(b.width*.5,0,0),x.halfHeight.set(0,b.height*.5,0),x.halfWidth.applyMatrix4(a),x.halfHeight.applyMatrix4(a),g++}else if(b.isPointLight){const x=i.point[h];x.position.setFromMatrixPosition(b.matrixWorld),x.position.applyMatrix4(p),h++}else if(b.isHemisphereLight){const x=i.hemi[y];x.direction.setFromMatrixPosition(b.matrixWorld),x.direction.transformDirection(p),y++}}}return{setup:o,setupView:c,state:i}}function ff(n){const e=new Hb(n),t=[],i=[],s=[];function r(h){f.camera=h,t.length=0,i.length=0,s.length=0}function a(h){t.push(h)}function o(h){i.push(h)}function c(h){s.push(h)}function l(){e.setup(t)}function u(h){e.setupView(t,h)}const f={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:f,setupLights:l,setupLightsView:u,pushLight:a,pushShadow:o,pushLightProbeGrid:c}}function Xb(n){let e=new WeakMap;function t(s,r=0){const a=e.get(s);let o;return a===void 0?(o=new ff(n),e.set(s,[o])):r>=a.length?(o=new ff(n),a.push(o)):o=a[r],o}function i(){e=new WeakMap}return{get:t,dispose:i}}const Zb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Yb=`uniform sampler2D shadow_pass;
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
}`,Kb=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],$b=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],df=new je,ar=new P,gc=new P;function Jb(n,e,t){let i=new Wp;const s=new we,r=new we,a=new ht,o=new r_,c=new a_,l={},u=t.maxTextureSize,f={[qn]:Qt,[Qt]:qn,[yn]:yn},h=new on({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new we},radius:{value:4}},vertexShader:Zb,fragmentShader:Yb}),d=h.clone();d.defines.HORIZONTAL_PASS=1;const g=new $t;g.setAttribute("position",new Et(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const y=new An(g,h),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Za;let m=this.type;this.render=function(w,T,_){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||w.length===0)return;this.type===Pg&&(Ne("WebGLShadowMap: PCFSoftShadowMap has been deprecated. Using PCFShadowMap instead."),this.type=Za);const M=n.getRenderTarget(),N=n.getActiveCubeFace(),R=n.getActiveMipmapLevel(),C=n.state;C.setBlending(hi),C.buffers.depth.getReversed()===!0?C.buffers.color.setClear(0,0,0,0):C.buffers.color.setClear(1,1,1,1),C.buffers.depth.setTest(!0),C.setScissorTest(!1);const U=m!==this.type;U&&T.traverse(function(B){B.material&&(Array.isArray(B.material)?B.material.forEach(L=>L.needsUpdate=!0):B.material.needsUpdate=!0)});for(let B=0,L=w.length;B<L;B++){const V=w[B],k=V.shadow;if(k===void 0){Ne("WebGLShadowMap:",V,"has no shadow.");continue}if(k.autoUpdate===!1&&k.needsUpdate===!1)continue;s.copy(k.mapSize);const j=k.getFrameExtents();s.multiply(j),r.copy(k.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/j.x),s.x=r.x*j.x,k.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/j.y),s.y=r.y*j.y,k.mapSize.y=r.y));const ee=n.state.buffers.depth.getReversed();if(k.camera._reversedDepth=ee,k.map===null||U===!0){if(k.map!==null&&(k.map.depthTexture!==null&&(k.map.depthTexture.dispose(),k.map.depthTexture=null),k.map.dispose()),this.type===_r){if(V.isPointLight){Ne("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}k.map=new Un(s.x,s.y,{format:is,type:pi,minFilter:Ht,magFilter:Ht,generateMipmaps:!1}),k.map.texture.name=V.name+".shadowMap",k.map.depthTexture=new rs(s.x,s.y,$n),k.map.depthTexture.name=V.name+".shadowMapDepth",k.map.depthTexture.format=mi,k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Wt,k.map.depthTexture.magFilter=Wt}else V.isPointLight?(k.map=new jp(s.x),k.map.depthTexture=new Q0(s.x,Fn)):(k.map=new Un(s.x,s.y),k.map.depthTexture=new rs(s.x,s.y,Fn)),k.map.depthTexture.name=V.name+".shadowMap",k.map.depthTexture.format=mi,this.type===Za?(k.map.depthTexture.compareFunction=ee?hu:uu,k.map.depthTexture.minFilter=Ht,k.map.depthTexture.magFilter=Ht):(k.map.depthTexture.compareFunction=null,k.map.depthTexture.minFilter=Wt,k.map.depthTexture.magFilter=Wt);k.camera.updateProjectionMatrix()}const le=k.map.isWebGLCubeRenderTarget?6:1;for(let xe=0;xe<le;xe++){if(k.map.isWebGLCubeRenderTarget)n.setRenderTarget(k.map,xe),n.clear();else{xe===0&&(n.setRenderTarget(k.map),n.clear());const ye=k.getViewport(xe);a.set(r.x*ye.x,r.y*ye.y,r.x*ye.z,r.y*ye.w),C.viewport(a)}if(V.isPointLight){const ye=k.camera,ze=k.matrix,qe=V.distance||ye.far;qe!==ye.far&&(ye.far=qe,ye.updateProjectionMatrix()),ar.setFromMatrixPosition(V.matrixWorld),ye.position.copy(ar),gc.copy(ye.position),gc.add(Kb[xe]),ye.up.copy($b[xe]),ye.lookAt(gc),ye.updateMatrixWorld(),ze.makeTranslation(-ar.x,-ar.y,-ar.z),df.multiplyMatrices(ye.projectionMatrix,ye.matrixWorldInverse),k._frustum.setFromProjectionMatrix(df,ye.coordinateSystem,ye.reversedDepth)}else k.updateMatrices(V);i=k.getFrustum(),x(T,_,k.camera,V,this.type)}k.isPointLightShadow!==!0&&this.type===_r&&v(k,_),k.needsUpdate=!1}m=this.type,p.needsUpdate=!1,n.setRenderTarget(M,N,R)};function v(w,T){const _=e.update(y);h.defines.VSM_SAMPLES!==w.blurSamples&&(h.defines.VSM_SAMPLES=w.blurSamples,d.defines.VSM_SAMPLES=w.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),w.mapPass===null&&(w.mapPass=new Un(s.x,s.y,{format:is,type:pi})),h.uniforms.shadow_pass.value=w.map.depthTexture,h.uniforms.resolution.value=w.mapSize,h.uniforms.radius.value=w.radius,n.setRenderTarget(w.mapPass),n.clear(),n.renderBufferDirect(T,null,_,h,y,null),d.uniforms.shadow_pass.value=w.mapPass.texture,d.uniforms.resolution.value=w.mapSize,d.uniforms.radius.value=w.radius,n.setRenderTarget(w.map),n.clear(),n.renderBufferDirect(T,null,_,d,y,null)}function b(w,T,_,M){let N=null;const R=_.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(R!==void 0)N=R;else if(N=_.isPointLight===!0?c:o,n.localClippingEnabled&&T.clipShadows===!0&&Array.isArray(T.clippingPlanes)&&T.clippingPlanes.length!==0||T.displacementMap&&T.displacementScale!==0||T.alphaMap&&T.alphaTest>0||T.map&&T.alphaTest>0||T.alphaToCoverage===!0){const C=N.uuid,U=T.uuid;let B=l[C];B===void 0&&(B={},l[C]=B);let L=B[U];L===void 0&&(L=N.clone(),B[U]=L,T.addEventListener("dispose",E)),N=L}if(N.visible=T.visible,N.wireframe=T.wireframe,M===_r?N.side=T.shadowSide!==null?T.shadowSide:T.side:N.side=T.shadowSide!==null?T.shadowSide:f[T.side],N.alphaMap=T.alphaMap,N.alphaTest=T.alphaToCoverage===!0?.5:T.alphaTest,N.map=T.map,N.clipShadows=T.clipShadows,N.clippingPlanes=T.clippingPlanes,N.clipIntersection=T.clipIntersection,N.displacementMap=T.displacementMap,N.displacementScale=T.displacementScale,N.displacementBias=T.displacementBias,N.wireframeLinewidth=T.wireframeLinewidth,N.linewidth=T.linewidth,_.isPointLight===!0&&N.isMeshDistanceMaterial===!0){const C=n.properties.get(N);C.light=_}return N}function x(w,T,_,M,N){if(w.visible===!1)return;if(w.layers.test(T.layers)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&N===_r)&&(!w.frustumCulled||i.intersectsObject(w))){w.modelViewMatrix.multiplyMatrices(_.matrixWorldInverse,w.matrixWorld);const U=e.update(w),B=w.material;if(Array.isArray(B)){const L=U.groups;for(let V=0,k=L.length;V<k;V++){const j=L[V],ee=B[j.materialIndex];if(ee&&ee.visible){const le=b(w,ee,M,N);w.onBeforeShadow(n,w,T,_,U,le,j),n.renderBufferDirect(_,null,U,le,w,j),w.onAfterShadow(n,w,T,_,U,le,j)}}}else if(B.visible){const L=b(w,B,M,N);w.onBeforeShadow(n,w,T,_,U,L,null),n.renderBufferDirect(_,null,U,L,w,null),w.onAfterShadow(n,w,T,_,U,L,null)}}const C=w.children;for(let U=0,B=C.length;U<B;U++)x(C[U],T,_,M,N)}function E(w){w.target.removeEventListener("dispose",E);for(const _ in l){const M=l[_],N=w.target.uuid;N in M&&(M[N].dispose(),delete M[N])}}}function jb(n,e){function t(){let D=!1;const ie=new ht;let Y=null;const me=new ht(0,0,0,0);return{setMask:function(ae){Y!==ae&&!D&&(n.colorMask(ae,ae,ae,ae),Y=ae)},setLocked:function(ae){D=ae},setClear:function(ae,q,Se,Fe,vt){vt===!0&&(ae*=Fe,q*=Fe,Se*=Fe),ie.set(ae,q,Se,Fe),me.equals(ie)===!1&&(n.clearColor(ae,q,Se,Fe),me.copy(ie))},reset:function(){D=!1,Y=null,me.set(-1,0,0,0)}}}function i(){let D=!1,ie=!1,Y=null,me=null,ae=null;return{setReversed:function(q){if(ie!==q){const Se=e.get("EXT_clip_control");q?Se.clipControlEXT(Se.LOWER_LEFT_EXT,Se.ZERO_TO_ONE_EXT):Se.clipControlEXT(Se.LOWER_LEFT_EXT,Se.NEGATIVE_ONE_TO_ONE_EXT),ie=q;const Fe=ae;ae=null,this.setClear(Fe)}},getReversed:function(){return ie},setTest:function(q){q?se(n.DEPTH_TEST):Te(n.DEPTH_TEST)},setMask:function(q){Y!==q&&!D&&(n.depthMask(q),Y=q)},setFunc:function(q){if(ie&&(q=f0[q]),me!==q){switch(q){case $c:n.depthFunc(n.NEVER);break;case no:n.depthFunc(n.ALWAYS);break;case Jc:n.depthFunc(n.LESS);break;case ts:n.depthFunc(n.LEQUAL);break;case jc:n.depthFunc(n.EQUAL);break;case qc:n.depthFunc(n.GEQUAL);break;case io:n.depthFunc(n.GREATER);break;case Qc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}me=q}},setLocked:function(q){D=q},setClear:function(q){ae!==q&&(ae=q,ie&&(q=1-q),n.clearDepth(q))},reset:function(){D=!1,Y=null,me=null,ae=null,ie=!1}}}function s(){let D=!1,ie=null,Y=null,me=null,ae=null,q=null,Se=null,Fe=null,vt=null;return{setTest:function(it){D||(it?se(n.STENCIL_TEST):Te(n.STENCIL_TEST))},setMask:function(it){ie!==it&&!D&&(n.stencilMask(it),ie=it)},setFunc:function(it,ei,Vn){(Y!==it||me!==ei||ae!==Vn)&&(n.stencilFunc(it,ei,Vn),Y=it,me=ei,ae=Vn)},setOp:function(it,ei,Vn){(q!==it||Se!==ei||Fe!==Vn)&&(n.stencilOp(it,ei,Vn),q=it,Se=ei,Fe=Vn)},setLocked:function(it){D=it},setClear:function(it){vt!==it&&(n.clearStencil(it),vt=it)},reset:function(){D=!1,ie=null,Y=null,me=null,ae=null,q=null,Se=null,Fe=null,vt=null}}}const r=new t,a=new i,o=new s,c=new WeakMap,l=new WeakMap;let u={},f={},h={},d=new WeakMap,g=[],y=null,p=!1,m=null,v=null,b=null,x=null,E=null,w=null,T=null,_=new Ke(0,0,0),M=0,N=!1,R=null,C=null,U=null,B=null,L=null;const V=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let k=!1,j=0;const ee=n.getParameter(n.VERSION);ee.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(ee)[1]),k=j>=1):ee.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(ee)[1]),k=j>=2);let le=null,xe={};const ye=n.getParameter(n.SCISSOR_BOX),ze=n.getParameter(n.VIEWPORT),qe=new ht().fromArray(ye),Ie=new ht().fromArray(ze);function J(D,ie,Y,me){const ae=new Uint8Array(4),q=n.createTexture();n.bindTexture(D,q),n.texParameteri(D,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(D,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Se=0;Se<Y;Se++)D===n.TEXTURE_3D||D===n.TEXTURE_2D_ARRAY?n.texImage3D(ie,0,n.RGBA,1,1,me,0,n.RGBA,n.UNSIGNED_BYTE,ae):n.texImage2D(ie+Se,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ae);return q}const he={};he[n.TEXTURE_2D]=J(n.TEXTURE_2D,n.TEXTURE_2D,1),he[n.TEXTURE_CUBE_MAP]=J(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),he[n.TEXTURE_2D_ARRAY]=J(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),he[n.TEXTURE_3D]=J(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),se(n.DEPTH_TEST),a.setFunc(ts),Tt(!1),pt(uh),se(n.CULL_FACE),ft(hi);function se(D){u[D]!==!0&&(n.enable(D),u[D]=!0)}function Te(D){u[D]!==!1&&(n.disable(D),u[D]=!1)}function Ce(D,ie){return h[D]!==ie?(n.bindFramebuffer(D,ie),h[D]=ie,D===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ie),D===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ie),!0):!1}function Re(D,ie){let Y=g,me=!1;if(D){Y=d.get(ie),Y===void 0&&(Y=[],d.set(ie,Y));const ae=D.textures;if(Y.length!==ae.length||Y[0]!==n.COLOR_ATTACHMENT0){for(let q=0,Se=ae.length;q<Se;q++)Y[q]=n.COLOR_ATTACHMENT0+q;Y.length=ae.length,me=!0}}else Y[0]!==n.BACK&&(Y[0]=n.BACK,me=!0);me&&n.drawBuffers(Y)}function at(D){return y!==D?(n.useProgram(D),y=D,!0):!1}const We={[$i]:n.FUNC_ADD,[Dg]:n.FUNC_SUBTRACT,[Ug]:n.FUNC_REVERSE_SUBTRACT};We[Fg]=n.MIN,We[Bg]=n.MAX;const nt={[Og]:n.ZERO,[Vg]:n.ONE,[kg]:n.SRC_COLOR,[Yc]:n.SRC_ALPHA,[Zg]:n.SRC_ALPHA_SATURATE,[Hg]:n.DST_COLOR,[zg]:n.DST_ALPHA,[Gg]:n.ONE_MINUS_SRC_COLOR,[Kc]:n.ONE_MINUS_SRC_ALPHA,[Xg]:n.ONE_MINUS_DST_COLOR,[Wg]:n.ONE_MINUS_DST_ALPHA,[Yg]:n.CONSTANT_COLOR,[Kg]:n.ONE_MINUS_CONSTANT_COLOR,[$g]:n.CONSTANT_ALPHA,[Jg]:n.ONE_MINUS_CONSTANT_ALPHA};function ft(D,ie,Y,me,ae,q,Se,Fe,vt,it){if(D===hi){p===!0&&(Te(n.BLEND),p=!1);return}if(p===!1&&(se(n.BLEND),p=!0),D!==Lg){if(D!==m||it!==N){if((v!==$i||E!==$i)&&(n.blendEquation(n.FUNC_ADD),v=$i,E=$i),it)switch(D){case Vs:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hh:n.blendFunc(n.ONE,n.ONE);break;case fh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case dh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Ze("WebGLState: Invalid blending: ",D);break}else switch(D){case Vs:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case fh:Ze("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case dh:Ze("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ze("WebGLState: Invalid blending: ",D);break}b=null,x=null,w=null,T=null,_.set(0,0,0),M=0,m=D,N=it}return}ae=ae||ie,q=q||Y,Se=Se||me,(ie!==v||ae!==E)&&(n.blendEquationSeparate(We[ie],We[ae]),v=ie,E=ae),(Y!==b||me!==x||q!==w||Se!==T)&&(n.blendFuncSeparate(nt[Y],nt[me],nt[q],nt[Se]),b=Y,x=me,w=q,T=Se),(Fe.equals(_)===!1||vt!==M)&&(n.blendColor(Fe.r,Fe.g,Fe.b,vt),_.copy(Fe),M=vt),m=D,N=!1}function Ge(D,ie){D.side===yn?Te(n.CULL_FACE):se(n.CULL_FACE);let Y=D.side===Qt;ie&&(Y=!Y),Tt(Y),D.blending===Vs&&D.transparent===!1?ft(hi):ft(D.blending,D.blendEquation,D.blendSrc,D.blendDst,D.blendEquationAlpha,D.blendSrcAlpha,D.blendDstAlpha,D.blendColor,D.blendAlpha,D.premultipliedAlpha),a.setFunc(D.depthFunc),a.setTest(D.depthTest),a.setMask(D.depthWrite),r.setMask(D.colorWrite);const me=D.stencilWrite;o.setTest(me),me&&(o.setMask(D.stencilWriteMask),o.setFunc(D.stencilFunc,D.stencilRef,D.stencilFuncMask),o.setOp(D.stencilFail,D.stencilZFail,D.stencilZPass)),F(D.polygonOffset,D.polygonOffsetFactor,D.polygonOffsetUnits),D.alphaToCoverage===!0?se(n.SAMPLE_ALPHA_TO_COVERAGE):Te(n.SAMPLE_ALPHA_TO_COVERAGE)}function Tt(D){R!==D&&(D?n.frontFace(n.CW):n.frontFace(n.CCW),R=D)}function pt(D){D!==Ig?(se(n.CULL_FACE),D!==C&&(D===uh?n.cullFace(n.BACK):D===Cg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Te(n.CULL_FACE),C=D}function cn(D){D!==U&&(k&&n.lineWidth(D),U=D)}function F(D,ie,Y){D?(se(n.POLYGON_OFFSET_FILL),(B!==ie||L!==Y)&&(B=ie,L=Y,a.getReversed()&&(ie=-ie),n.polygonOffset(ie,Y))):Te(n.POLYGON_OFFSET_FILL)}function Rt(D){D?se(n.SCISSOR_TEST):Te(n.SCISSOR_TEST)}function He(D){D===void 0&&(D=n.TEXTURE0+V-1),le!==D&&(n.activeTexture(D),le=D)}function lt(D,ie,Y){Y===void 0&&(le===null?Y=n.TEXTURE0+V-1:Y=le);let me=xe[Y];me===void 0&&(me={type:void 0,texture:void 0},xe[Y]=me),(me.type!==D||me.texture!==ie)&&(le!==Y&&(n.activeTexture(Y),le=Y),n.bindTexture(D,ie||he[D]),me.type=D,me.texture=ie)}function ue(){const D=xe[le];D!==void 0&&D.type!==void 0&&(n.bindTexture(D.type,null),D.type=void 0,D.texture=void 0)}function mt(){try{n.compressedTexImage2D(...arguments)}catch(D){Ze("WebGLState:",D)}}function I(){try{n.compressedTexImage3D(...arguments)}catch(D){Ze("WebGLState:",D)}}function S(){try{n.texSubImage2D(...arguments)}catch(D){Ze("WebGLState:",D)}}function z(){try{n.texSubImage3D(...arguments)}catch(D){Ze("WebGLState:",D)}}function K(){try{n.compressedTexSubImage2D(...arguments)}catch(D){Ze("WebGLState:",D)}}function Q(){try{n.compressedTexSubImage3D(...arguments)}catch(D){Ze("WebGLState:",D)}}function te(){try{n.texStorage2D(...arguments)}catch(D){Ze("WebGLState:",D)}}function oe(){try{n.texStorage3D(...arguments)}catch(D){Ze("WebGLState:",D)}}function Z(){try{n.texImage2D(...arguments)}catch(D){Ze("WebGLState:",D)}}function $(){try{n.texImage3D(...arguments)}catch(D){Ze("WebGLState:",D)}}function pe(D){return f[D]!==void 0?f[D]:n.getParameter(D)}function _e(D,ie){f[D]!==ie&&(n.pixelStorei(D,ie),f[D]=ie)}function re(D){qe.equals(D)===!1&&(n.scissor(D.x,D.y,D.z,D.w),qe.copy(D))}function ne(D){Ie.equals(D)===!1&&(n.viewport(D.x,D.y,D.z,D.w),Ie.copy(D))}function Pe(D,ie){let Y=l.get(ie);Y===void 0&&(Y=new WeakMap,l.set(ie,Y));let me=Y.get(D);me===void 0&&(me=n.getUniformBlockIndex(ie,D.name),Y.set(D,me))}function Oe(D,ie){const me=l.get(ie).get(D);c.get(ie)!==me&&(n.uniformBlockBinding(ie,me,D.__bindingPointIndex),c.set(ie,me))}function $e(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),a.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},le=null,xe={},h={},d=new WeakMap,g=[],y=null,p=!1,m=null,v=null,b=null,x=null,E=null,w=null,T=null,_=new Ke(0,0,0),M=0,N=!1,R=null,C=null,U=null,B=null,L=null,qe.set(0,0,n.canvas.width,n.canvas.height),Ie.set(0,0,n.canvas.width,n.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:se,disable:Te,bindFramebuffer:Ce,drawBuffers:Re,useProgram:at,setBlending:ft,setMaterial:Ge,setFlipSided:Tt,setCullFace:pt,setLineWidth:cn,setPolygonOffset:F,setScissorTest:Rt,activeTexture:He,bindTexture:lt,unbindTexture:ue,compressedTexImage2D:mt,compressedTexImage3D:I,texImage2D:Z,texImage3D:$,pixelStorei:_e,getParameter:pe,updateUBOMapping:Pe,uniformBlockBinding:Oe,texStorage2D:te,texStorage3D:oe,texSubImage2D:S,texSubImage3D:z,compressedTexSubImage2D:K,compressedTexSubImage3D:Q,scissor:re,viewport:ne,reset:$e}}function qb(n,e,t,i,s,r,a){const o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new we,u=new WeakMap,f=new Set;let h;const d=new WeakMap;let g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function y(I,S){return g?new OffscreenCanvas(I,S):co("canvas")}function p(I,S,z){let K=1;const Q=mt(I);if((Q.width>z||Q.height>z)&&(K=z/Math.max(Q.width,Q.height)),K<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){const te=Math.floor(K*Q.width),oe=Math.floor(K*Q.height);h===void 0&&(h=y(te,oe));const Z=S?y(te,oe):h;return Z.width=te,Z.height=oe,Z.getContext("2d").drawImage(I,0,0,te,oe),Ne("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+te+"x"+oe+")."),Z}else return"data"in I&&Ne("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),I;return I}function m(I){return I.generateMipmaps}function v(I){n.generateMipmap(I)}function b(I){return I.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?n.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function x(I,S,z,K,Q,te=!1){if(I!==null){if(n[I]!==void 0)return n[I];Ne("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let oe;K&&(oe=e.get("EXT_texture_norm16"),oe||Ne("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=S;if(S===n.RED&&(z===n.FLOAT&&(Z=n.R32F),z===n.HALF_FLOAT&&(Z=n.R16F),z===n.UNSIGNED_BYTE&&(Z=n.R8),z===n.UNSIGNED_SHORT&&oe&&(Z=oe.R16_EXT),z===n.SHORT&&oe&&(Z=oe.R16_SNORM_EXT)),S===n.RED_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.R8UI),z===n.UNSIGNED_SHORT&&(Z=n.R16UI),z===n.UNSIGNED_INT&&(Z=n.R32UI),z===n.BYTE&&(Z=n.R8I),z===n.SHORT&&(Z=n.R16I),z===n.INT&&(Z=n.R32I)),S===n.RG&&(z===n.FLOAT&&(Z=n.RG32F),z===n.HALF_FLOAT&&(Z=n.RG16F),z===n.UNSIGNED_BYTE&&(Z=n.RG8),z===n.UNSIGNED_SHORT&&oe&&(Z=oe.RG16_EXT),z===n.SHORT&&oe&&(Z=oe.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RG8UI),z===n.UNSIGNED_SHORT&&(Z=n.RG16UI),z===n.UNSIGNED_INT&&(Z=n.RG32UI),z===n.BYTE&&(Z=n.RG8I),z===n.SHORT&&(Z=n.RG16I),z===n.INT&&(Z=n.RG32I)),S===n.RGB_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RGB8UI),z===n.UNSIGNED_SHORT&&(Z=n.RGB16UI),z===n.UNSIGNED_INT&&(Z=n.RGB32UI),z===n.BYTE&&(Z=n.RGB8I),z===n.SHORT&&(Z=n.RGB16I),z===n.INT&&(Z=n.RGB32I)),S===n.RGBA_INTEGER&&(z===n.UNSIGNED_BYTE&&(Z=n.RGBA8UI),z===n.UNSIGNED_SHORT&&(Z=n.RGBA16UI),z===n.UNSIGNED_INT&&(Z=n.RGBA32UI),z===n.BYTE&&(Z=n.RGBA8I),z===n.SHORT&&(Z=n.RGBA16I),z===n.INT&&(Z=n.RGBA32I)),S===n.RGB&&(z===n.UNSIGNED_SHORT&&oe&&(Z=oe.RGB16_EXT),z===n.SHORT&&oe&&(Z=oe.RGB16_SNORM_EXT),z===n.UNSIGNED_INT_5_9_9_9_REV&&(Z=n.RGB9_E5),z===n.UNSIGNED_INT_10F_11F_11F_REV&&(Z=n.R11F_G11F_B10F)),S===n.RGBA){const $=te?ao:Xe.getTransfer(Q);z===n.FLOAT&&(Z=n.RGBA32F),z===n.HALF_FLOAT&&(Z=n.RGBA16F),z===n.UNSIGNED_BYTE&&(Z=$===Qe?n.SRGB8_ALPHA8:n.RGBA8),z===n.UNSIGNED_SHORT&&oe&&(Z=oe.RGBA16_EXT),z===n.SHORT&&oe&&(Z=oe.RGBA16_SNORM_EXT),z===n.UNSIGNED_SHORT_4_4_4_4&&(Z=n.RGBA4),z===n.UNSIGNED_SHORT_5_5_5_1&&(Z=n.RGB5_A1)}return(Z===n.R16F||Z===n.R32F||Z===n.RG16F||Z===n.RG32F||Z===n.RGBA16F||Z===n.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function E(I,S){let z;return I?S===null||S===Fn||S===Rr?z=n.DEPTH24_STENCIL8:S===$n?z=n.DEPTH32F_STENCIL8:S===Tr&&(z=n.DEPTH24_STENCIL8,Ne("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Fn||S===Rr?z=n.DEPTH_COMPONENT24:S===$n?z=n.DEPTH_COMPONENT32F:S===Tr&&(z=n.DEPTH_COMPONENT16),z}function w(I,S){return m(I)===!0||I.isFramebufferTexture&&I.minFilter!==Wt&&I.minFilter!==Ht?Math.log2(Math.max(S.width,S.height))+1:I.mipmaps!==void 0&&I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?S.mipmaps.length:1}function T(I){const S=I.target;S.removeEventListener("dispose",T),M(S),S.isVideoTexture&&u.delete(S),S.isHTMLTexture&&f.delete(S)}function _(I){const S=I.target;S.removeEventListener("dispose",_),R(S)}function M(I){const S=i.get(I);if(S.__webglInit===void 0)return;const z=I.source,K=d.get(z);if(K){const Q=K[S.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&N(I),Object.keys(K).length===0&&d.delete(z)}i.remove(I)}function N(I){const S=i.get(I);n.deleteTexture(S.__webglTexture);const z=I.source,K=d.get(z);delete K[S.__cacheKey],a.memory.textures--}function R(I){const S=i.get(I);if(I.depthTexture&&(I.depthTexture.dispose(),i.remove(I.depthTexture)),I.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(S.__webglFramebuffer[K]))for(let Q=0;Q<S.__webglFramebuffer[K].length;Q++)n.deleteFramebuffer(S.__webglFramebuffer[K][Q]);else n.deleteFramebuffer(S.__webglFramebuffer[K]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[K])}else{if(Array.isArray(S.__webglFramebuffer))for(let K=0;K<S.__webglFramebuffer.length;K++)n.deleteFramebuffer(S.__webglFramebuffer[K]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let K=0;K<S.__webglColorRenderbuffer.length;K++)S.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[K]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}const z=I.textures;for(let K=0,Q=z.length;K<Q;K++){const te=i.get(z[K]);te.__webglTexture&&(n.deleteTexture(te.__webglTexture),a.memory.textures--),i.remove(z[K])}i.remove(I)}let C=0;function U(){C=0}function B(){return C}function L(I){C=I}function V(){const I=C;return I>=s.maxTextures&&Ne("WebGLTextures: Trying to use "+I+" texture units while this GPU supports only "+s.maxTextures),C+=1,I}function k(I){const S=[];return S.push(I.wrapS),S.push(I.wrapT),S.push(I.wrapR||0),S.push(I.magFilter),S.push(I.minFilter),S.push(I.anisotropy),S.push(I.internalFormat),S.push(I.format),S.push(I.type),S.push(I.generateMipmaps),S.push(I.premultiplyAlpha),S.push(I.flipY),S.push(I.unpackAlignment),S.push(I.colorSpace),S.join()}function j(I,S){const z=i.get(I);if(I.isVideoTexture&&lt(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&z.__version!==I.version){const K=I.image;if(K===null)Ne("WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)Ne("WebGLRenderer: Texture marked for update but image is incomplete");else{Te(z,I,S);return}}else I.isExternalTexture&&(z.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,z.__webglTexture,n.TEXTURE0+S)}function ee(I,S){const z=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&z.__version!==I.version){Te(z,I,S);return}else I.isExternalTexture&&(z.__webglTexture=I.sourceTexture?I.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,z.__webglTexture,n.TEXTURE0+S)}function le(I,S){const z=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&z.__version!==I.version){Te(z,I,S);return}t.bindTexture(n.TEXTURE_3D,z.__webglTexture,n.TEXTURE0+S)}function xe(I,S){const z=i.get(I);if(I.isCubeDepthTexture!==!0&&I.version>0&&z.__version!==I.version){Ce(z,I,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,z.__webglTexture,n.TEXTURE0+S)}const ye={[el]:n.REPEAT,[li]:n.CLAMP_TO_EDGE,[tl]:n.MIRRORED_REPEAT},ze={[Wt]:n.NEAREST,[Qg]:n.NEAREST_MIPMAP_NEAREST,[Jr]:n.NEAREST_MIPMAP_LINEAR,[Ht]:n.LINEAR,[ko]:n.LINEAR_MIPMAP_NEAREST,[ji]:n.LINEAR_MIPMAP_LINEAR},qe={[n0]:n.NEVER,[o0]:n.ALWAYS,[i0]:n.LESS,[uu]:n.LEQUAL,[s0]:n.EQUAL,[hu]:n.GEQUAL,[r0]:n.GREATER,[a0]:n.NOTEQUAL};function Ie(I,S){if(S.type===$n&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Ht||S.magFilter===ko||S.magFilter===Jr||S.magFilter===ji||S.minFilter===Ht||S.minFilter===ko||S.minFilter===Jr||S.minFilter===ji)&&Ne("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(I,n.TEXTURE_WRAP_S,ye[S.wrapS]),n.texParameteri(I,n.TEXTURE_WRAP_T,ye[S.wrapT]),(I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY)&&n.texParameteri(I,n.TEXTURE_WRAP_R,ye[S.wrapR]),n.texParameteri(I,n.TEXTURE_MAG_FILTER,ze[S.magFilter]),n.texParameteri(I,n.TEXTURE_MIN_FILTER,ze[S.minFilter]),S.compareFunction&&(n.texParameteri(I,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(I,n.TEXTURE_COMPARE_FUNC,qe[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Wt||S.minFilter!==Jr&&S.minFilter!==ji||S.type===$n&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){const z=e.get("EXT_texture_filter_anisotropic");n.texParameterf(I,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function J(I,S){let z=!1;I.__webglInit===void 0&&(I.__webglInit=!0,S.addEventListener("dispose",T));const K=S.source;let Q=d.get(K);Q===void 0&&(Q={},d.set(K,Q));const te=k(S);if(te!==I.__cacheKey){Q[te]===void 0&&(Q[te]={texture:n.createTexture(),usedTimes:0},a.memory.textures++,z=!0),Q[te].usedTimes++;const oe=Q[I.__cacheKey];oe!==void 0&&(Q[I.__cacheKey].usedTimes--,oe.usedTimes===0&&N(S)),I.__cacheKey=te,I.__webglTexture=Q[te].texture}return z}function he(I,S,z){return Math.floor(Math.floor(I/z)/S)}function se(I,S,z,K){const te=I.updateRanges;if(te.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,z,K,S.data);else{te.sort((_e,re)=>_e.start-re.start);let oe=0;for(let _e=1;_e<te.length;_e++){const re=te[oe],ne=te[_e],Pe=re.start+re.count,Oe=he(ne.start,S.width,4),$e=he(re.start,S.width,4);ne.start<=Pe+1&&Oe===$e&&he(ne.start+ne.count-1,S.width,4)===Oe?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++oe,te[oe]=ne)}te.length=oe+1;const Z=t.getParameter(n.UNPACK_ROW_LENGTH),$=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let _e=0,re=te.length;_e<re;_e++){const ne=te[_e],Pe=Math.floor(ne.start/4),Oe=Math.ceil(ne.count/4),$e=Pe%S.width,D=Math.floor(Pe/S.width),ie=Oe,Y=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,$e),t.pixelStorei(n.UNPACK_SKIP_ROWS,D),t.texSubImage2D(n.TEXTURE_2D,0,$e,D,ie,Y,z,K,S.data)}I.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,Z),t.pixelStorei(n.UNPACK_SKIP_PIXELS,$),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Te(I,S,z){let K=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(K=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(K=n.TEXTURE_3D);const Q=J(I,S),te=S.source;t.bindTexture(K,I.__webglTexture,n.TEXTURE0+z);const oe=i.get(te);if(te.version!==oe.__version||Q===!0){if(t.activeTexture(n.TEXTURE0+z),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){const Y=Xe.getPrimaries(Xe.workingColorSpace),me=S.colorSpace===Pi?null:Xe.getPrimaries(S.colorSpace),ae=S.colorSpace===Pi||Y===me?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ae)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let $=p(S.image,!1,s.maxTextureSize);$=ue(S,$);const pe=r.convert(S.format,S.colorSpace),_e=r.convert(S.type);let re=x(S.internalFormat,pe,_e,S.normalized,S.colorSpace,S.isVideoTexture);Ie(K,S);let ne;const Pe=S.mipmaps,Oe=S.isVideoTexture!==!0,$e=oe.__version===void 0||Q===!0,D=te.dataReady,ie=w(S,$);if(S.isDepthTexture)re=E(S.format===qi,S.type),$e&&(Oe?t.texStorage2D(n.TEXTURE_2D,1,re,$.width,$.height):t.texImage2D(n.TEXTURE_2D,0,re,$.width,$.height,0,pe,_e,null));else if(S.isDataTexture)if(Pe.length>0){Oe&&$e&&t.texStorage2D(n.TEXTURE_2D,ie,re,Pe[0].width,Pe[0].height);for(let Y=0,me=Pe.length;Y<me;Y++)ne=Pe[Y],Oe?D&&t.texSubImage2D(n.TEXTURE_2D,Y,0,0,ne.width,ne.height,pe,_e,ne.data):t.texImage2D(n.TEXTURE_2D,Y,re,ne.width,ne.height,0,pe,_e,ne.data);S.generateMipmaps=!1}else Oe?($e&&t.texStorage2D(n.TEXTURE_2D,ie,re,$.width,$.height),D&&se(S,$,pe,_e)):t.texImage2D(n.TEXTURE_2D,0,re,$.width,$.height,0,pe,_e,$.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){Oe&&$e&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ie,re,Pe[0].width,Pe[0].height,$.depth);for(let Y=0,me=Pe.length;Y<me;Y++)if(ne=Pe[Y],S.format!==Sn)if(pe!==null)if(Oe){if(D)if(S.layerUpdates.size>0){const ae=Wh(ne.width,ne.height,S.format,S.type);for(const q of S.layerUpdates){const Se=ne.data.subarray(q*ae/ne.data.BYTES_PER_ELEMENT,(q+1)*ae/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Y,0,0,q,ne.width,ne.height,1,pe,Se)}S.clearLayerUpdates()}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,Y,0,0,0,ne.width,ne.height,$.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,Y,re,ne.width,ne.height,$.depth,0,ne.data,0,0);else Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Oe?D&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,Y,0,0,0,ne.width,ne.height,$.depth,pe,_e,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,Y,re,ne.width,ne.height,$.depth,0,pe,_e,ne.data)}else{Oe&&$e&&t.texStorage2D(n.TEXTURE_2D,ie,re,Pe[0].width,Pe[0].height);for(let Y=0,me=Pe.length;Y<me;Y++)ne=Pe[Y],S.format!==Sn?pe!==null?Oe?D&&t.compressedTexSubImage2D(n.TEXTURE_2D,Y,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,Y,re,ne.width,ne.height,0,ne.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Oe?D&&t.texSubImage2D(n.TEXTURE_2D,Y,0,0,ne.width,ne.height,pe,_e,ne.data):t.texImage2D(n.TEXTURE_2D,Y,re,ne.width,ne.height,0,pe,_e,ne.data)}else if(S.isDataArrayTexture)if(Oe){if($e&&t.texStorage3D(n.TEXTURE_2D_ARRAY,ie,re,$.width,$.height,$.depth),D)if(S.layerUpdates.size>0){const Y=Wh($.width,$.height,S.format,S.type);for(const me of S.layerUpdates){const ae=$.data.subarray(me*Y/$.data.BYTES_PER_ELEMENT,(me+1)*Y/$.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,me,$.width,$.height,1,pe,_e,ae)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,$.width,$.height,$.depth,pe,_e,$.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,$.width,$.height,$.depth,0,pe,_e,$.data);else if(S.isData3DTexture)Oe?($e&&t.texStorage3D(n.TEXTURE_3D,ie,re,$.width,$.height,$.depth),D&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,$.width,$.height,$.depth,pe,_e,$.data)):t.texImage3D(n.TEXTURE_3D,0,re,$.width,$.height,$.depth,0,pe,_e,$.data);else if(S.isFramebufferTexture){if($e)if(Oe)t.texStorage2D(n.TEXTURE_2D,ie,re,$.width,$.height);else{let Y=$.width,me=$.height;for(let ae=0;ae<ie;ae++)t.texImage2D(n.TEXTURE_2D,ae,re,Y,me,0,pe,_e,null),Y>>=1,me>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){const Y=n.canvas;if(Y.hasAttribute("layoutsubtree")||Y.setAttribute("layoutsubtree","true"),$.parentNode!==Y){Y.appendChild($),f.add(S),Y.onpaint=Fe=>{const vt=Fe.changedElements;for(const it of f)vt.includes(it.image)&&(it.needsUpdate=!0)},Y.requestPaint();return}const me=0,ae=n.RGBA,q=n.RGBA,Se=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,me,ae,q,Se,$),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Pe.length>0){if(Oe&&$e){const Y=mt(Pe[0]);t.texStorage2D(n.TEXTURE_2D,ie,re,Y.width,Y.height)}for(let Y=0,me=Pe.length;Y<me;Y++)ne=Pe[Y],Oe?D&&t.texSubImage2D(n.TEXTURE_2D,Y,0,0,pe,_e,ne):t.texImage2D(n.TEXTURE_2D,Y,re,pe,_e,ne);S.generateMipmaps=!1}else if(Oe){if($e){const Y=mt($);t.texStorage2D(n.TEXTURE_2D,ie,re,Y.width,Y.height)}D&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,_e,$)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,_e,$);m(S)&&v(K),oe.__version=te.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function Ce(I,S,z){if(S.image.length!==6)return;const K=J(I,S),Q=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,I.__webglTexture,n.TEXTURE0+z);const te=i.get(Q);if(Q.version!==te.__version||K===!0){t.activeTexture(n.TEXTURE0+z);const oe=Xe.getPrimaries(Xe.workingColorSpace),Z=S.colorSpace===Pi?null:Xe.getPrimaries(S.colorSpace),$=S.colorSpace===Pi||oe===Z?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,$);const pe=S.isCompressedTexture||S.image[0].isCompressedTexture,_e=S.image[0]&&S.image[0].isDataTexture,re=[];for(let q=0;q<6;q++)!pe&&!_e?re[q]=p(S.image[q],!0,s.maxCubemapSize):re[q]=_e?S.image[q].image:S.image[q],re[q]=ue(S,re[q]);const ne=re[0],Pe=r.convert(S.format,S.colorSpace),Oe=r.convert(S.type),$e=x(S.internalFormat,Pe,Oe,S.normalized,S.colorSpace),D=S.isVideoTexture!==!0,ie=te.__version===void 0||K===!0,Y=Q.dataReady;let me=w(S,ne);Ie(n.TEXTURE_CUBE_MAP,S);let ae;if(pe){D&&ie&&t.texStorage2D(n.TEXTURE_CUBE_MAP,me,$e,ne.width,ne.height);for(let q=0;q<6;q++){ae=re[q].mipmaps;for(let Se=0;Se<ae.length;Se++){const Fe=ae[Se];S.format!==Sn?Pe!==null?D?Y&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se,0,0,Fe.width,Fe.height,Pe,Fe.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se,$e,Fe.width,Fe.height,0,Fe.data):Ne("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se,0,0,Fe.width,Fe.height,Pe,Oe,Fe.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se,$e,Fe.width,Fe.height,0,Pe,Oe,Fe.data)}}}else{if(ae=S.mipmaps,D&&ie){ae.length>0&&me++;const q=mt(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,me,$e,q.width,q.height)}for(let q=0;q<6;q++)if(_e){D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,0,0,0,re[q].width,re[q].height,Pe,Oe,re[q].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,0,$e,re[q].width,re[q].height,0,Pe,Oe,re[q].data);for(let Se=0;Se<ae.length;Se++){const vt=ae[Se].image[q].image;D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se+1,0,0,vt.width,vt.height,Pe,Oe,vt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se+1,$e,vt.width,vt.height,0,Pe,Oe,vt.data)}}else{D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,0,0,0,Pe,Oe,re[q]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,0,$e,Pe,Oe,re[q]);for(let Se=0;Se<ae.length;Se++){const Fe=ae[Se];D?Y&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se+1,0,0,Pe,Oe,Fe.image[q]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+q,Se+1,$e,Pe,Oe,Fe.image[q])}}}m(S)&&v(n.TEXTURE_CUBE_MAP),te.__version=Q.version,S.onUpdate&&S.onUpdate(S)}I.__version=S.version}function Re(I,S,z,K,Q,te){const oe=r.convert(z.format,z.colorSpace),Z=r.convert(z.type),$=x(z.internalFormat,oe,Z,z.normalized,z.colorSpace),pe=i.get(S),_e=i.get(z);if(_e.__renderTarget=S,!pe.__hasExternalTextures){const re=Math.max(1,S.width>>te),ne=Math.max(1,S.height>>te);Q===n.TEXTURE_3D||Q===n.TEXTURE_2D_ARRAY?t.texImage3D(Q,te,$,re,ne,S.depth,0,oe,Z,null):t.texImage2D(Q,te,$,re,ne,0,oe,Z,null)}t.bindFramebuffer(n.FRAMEBUFFER,I),He(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,K,Q,_e.__webglTexture,0,Rt(S)):(Q===n.TEXTURE_2D||Q>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,K,Q,_e.__webglTexture,te),t.bindFramebuffer(n.FRAMEBUFFER,null)}function at(I,S,z){if(n.bindRenderbuffer(n.RENDERBUFFER,I),S.depthBuffer){const K=S.depthTexture,Q=K&&K.isDepthTexture?K.type:null,te=E(S.stencilBuffer,Q),oe=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;He(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Rt(S),te,S.width,S.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,Rt(S),te,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,te,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,I)}else{const K=S.textures;for(let Q=0;Q<K.length;Q++){const te=K[Q],oe=r.convert(te.format,te.colorSpace),Z=r.convert(te.type),$=x(te.internalFormat,oe,Z,te.normalized,te.colorSpace);He(S)?o.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Rt(S),$,S.width,S.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,Rt(S),$,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,$,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function We(I,S,z){const K=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,I),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const Q=i.get(S.depthTexture);if(Q.__renderTarget=S,(!Q.__webglTexture||S.depthTexture.image.width!==S.width||S.depthTexture.image.height!==S.height)&&(S.depthTexture.image.width=S.width,S.depthTexture.image.height=S.height,S.depthTexture.needsUpdate=!0),K){if(Q.__webglInit===void 0&&(Q.__webglInit=!0,S.depthTexture.addEventListener("dispose",T)),Q.__webglTexture===void 0){Q.__webglTexture=n.createTexture(),t.bindTexture(n.TEXTURE_CUBE_MAP,Q.__webglTexture),Ie(n.TEXTURE_CUBE_MAP,S.depthTexture);const pe=r.convert(S.depthTexture.format),_e=r.convert(S.depthTexture.type);let re;S.depthTexture.format===mi?re=n.DEPTH_COMPONENT24:S.depthTexture.format===qi&&(re=n.DEPTH24_STENCIL8);for(let ne=0;ne<6;ne++)n.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0,re,S.width,S.height,0,pe,_e,null)}}else j(S.depthTexture,0);const te=Q.__webglTexture,oe=Rt(S),Z=K?n.TEXTURE_CUBE_MAP_POSITIVE_X+z:n.TEXTURE_2D,$=S.depthTexture.format===qi?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===mi)He(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,$,Z,te,0,oe):n.framebufferTexture2D(n.FRAMEBUFFER,$,Z,te,0);else if(S.depthTexture.format===qi)He(S)?o.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,$,Z,te,0,oe):n.framebufferTexture2D(n.FRAMEBUFFER,$,Z,te,0);else throw new Error("Unknown depthTexture format")}function nt(I){const S=i.get(I),z=I.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==I.depthTexture){const K=I.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),K){const Q=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,K.removeEventListener("dispose",Q)};K.addEventListener("dispose",Q),S.__depthDisposeCallback=Q}S.__boundDepthTexture=K}if(I.depthTexture&&!S.__autoAllocateDepthBuffer)if(z)for(let K=0;K<6;K++)We(S.__webglFramebuffer[K],I,K);else{const K=I.texture.mipmaps;K&&K.length>0?We(S.__webglFramebuffer[0],I,0):We(S.__webglFramebuffer,I,0)}else if(z){S.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[K]),S.__webglDepthbuffer[K]===void 0)S.__webglDepthbuffer[K]=n.createRenderbuffer(),at(S.__webglDepthbuffer[K],I,!1);else{const Q=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=S.__webglDepthbuffer[K];n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,te)}}else{const K=I.texture.mipmaps;if(K&&K.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),at(S.__webglDepthbuffer,I,!1);else{const Q=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,te=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,te),n.framebufferRenderbuffer(n.FRAMEBUFFER,Q,n.RENDERBUFFER,te)}}t.bindFramebuffer(n.FRAMEBUFFER,null)}function ft(I,S,z){const K=i.get(I);S!==void 0&&Re(K.__webglFramebuffer,I,I.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),z!==void 0&&nt(I)}function Ge(I){const S=I.texture,z=i.get(I),K=i.get(S);I.addEventListener("dispose",_);const Q=I.textures,te=I.isWebGLCubeRenderTarget===!0,oe=Q.length>1;if(oe||(K.__webglTexture===void 0&&(K.__webglTexture=n.createTexture()),K.__version=S.version,a.memory.textures++),te){z.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(S.mipmaps&&S.mipmaps.length>0){z.__webglFramebuffer[Z]=[];for(let $=0;$<S.mipmaps.length;$++)z.__webglFramebuffer[Z][$]=n.createFramebuffer()}else z.__webglFramebuffer[Z]=n.createFramebuffer()}else{if(S.mipmaps&&S.mipmaps.length>0){z.__webglFramebuffer=[];for(let Z=0;Z<S.mipmaps.length;Z++)z.__webglFramebuffer[Z]=n.createFramebuffer()}else z.__webglFramebuffer=n.createFramebuffer();if(oe)for(let Z=0,$=Q.length;Z<$;Z++){const pe=i.get(Q[Z]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),a.memory.textures++)}if(I.samples>0&&He(I)===!1){z.__webglMultisampledFramebuffer=n.createFramebuffer(),z.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){const $=Q[Z];z.__webglColorRenderbuffer[Z]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,z.__webglColorRenderbuffer[Z]);const pe=r.convert($.format,$.colorSpace),_e=r.convert($.type),re=x($.internalFormat,pe,_e,$.normalized,$.colorSpace,I.isXRRenderTarget===!0),ne=Rt(I);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,I.width,I.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Z,n.RENDERBUFFER,z.__webglColorRenderbuffer[Z])}n.bindRenderbuffer(n.RENDERBUFFER,null),I.depthBuffer&&(z.__webglDepthRenderbuffer=n.createRenderbuffer(),at(z.__webglDepthRenderbuffer,I,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(te){t.bindTexture(n.TEXTURE_CUBE_MAP,K.__webglTexture),Ie(n.TEXTURE_CUBE_MAP,S);for(let Z=0;Z<6;Z++)if(S.mipmaps&&S.mipmaps.length>0)for(let $=0;$<S.mipmaps.length;$++)Re(z.__webglFramebuffer[Z][$],I,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,$);else Re(z.__webglFramebuffer[Z],I,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);m(S)&&v(n.TEXTURE_CUBE_MAP),t.unbindTexture()}else if(oe){for(let Z=0,$=Q.length;Z<$;Z++){const pe=Q[Z],_e=i.get(pe);let re=n.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(re=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,_e.__webglTexture),Ie(re,pe),Re(z.__webglFramebuffer,I,pe,n.COLOR_ATTACHMENT0+Z,re,0),m(pe)&&v(re)}t.unbindTexture()}else{let Z=n.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(Z=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(Z,K.__webglTexture),Ie(Z,S),S.mipmaps&&S.mipmaps.length>0)for(let $=0;$<S.mipmaps.length;$++)Re(z.__webglFramebuffer[$],I,S,n.COLOR_ATTACHMENT0,Z,$);else Re(z.__webglFramebuffer,I,S,n.COLOR_ATTACHMENT0,Z,0);m(S)&&v(Z),t.unbindTexture()}I.depthBuffer&&nt(I)}function Tt(I){const S=I.textures;for(let z=0,K=S.length;z<K;z++){const Q=S[z];if(m(Q)){const te=b(I),oe=i.get(Q).__webglTexture;t.bindTexture(te,oe),v(te),t.unbindTexture()}}}const pt=[],cn=[];function F(I){if(I.samples>0){if(He(I)===!1){const S=I.textures,z=I.width,K=I.height;let Q=n.COLOR_BUFFER_BIT;const te=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,oe=i.get(I),Z=S.length>1;if(Z)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,oe.__webglMultisampledFramebuffer);const $=I.texture.mipmaps;$&&$.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,oe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,oe.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(Q|=n.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(Q|=n.STENCIL_BUFFER_BIT)),Z){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,oe.__webglColorRenderbuffer[pe]);const _e=i.get(S[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,_e,0)}n.blitFramebuffer(0,0,z,K,0,0,z,K,Q,n.NEAREST),c===!0&&(pt.length=0,cn.length=0,pt.push(n.COLOR_ATTACHMENT0+pe),I.depthBuffer&&I.resolveDepthBuffer===!1&&(pt.push(te),cn.push(te),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,cn)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,pt))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Z)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,oe.__webglColorRenderbuffer[pe]);const _e=i.get(S[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,oe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,_e,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,oe.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.resolveDepthBuffer===!1&&c){const S=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function Rt(I){return Math.min(s.maxSamples,I.samples)}function He(I){const S=i.get(I);return I.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function lt(I){const S=a.render.frame;u.get(I)!==S&&(u.set(I,S),I.update())}function ue(I,S){const z=I.colorSpace,K=I.format,Q=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||z!==Nr&&z!==Pi&&(Xe.getTransfer(z)===Qe?(K!==Sn||Q!==bn)&&Ne("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ze("WebGLTextures: Unsupported texture color space:",z)),S}function mt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(l.width=I.naturalWidth||I.width,l.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(l.width=I.displayWidth,l.height=I.displayHeight):(l.width=I.width,l.height=I.height),l}this.allocateTextureUnit=V,this.resetTextureUnits=U,this.getTextureUnits=B,this.setTextureUnits=L,this.setTexture2D=j,this.setTexture2DArray=ee,this.setTexture3D=le,this.setTextureCube=xe,this.rebindTextures=ft,this.setupRenderTarget=Ge,this.updateRenderTargetMipmap=Tt,this.updateMultisampleRenderTarget=F,this.setupDepthRenderbuffer=nt,this.setupFrameBufferTexture=Re,this.useMultisampledRTT=He,this.isReversedDepthBuffer=function(){return t.buffers.depth.getReversed()}}function Qb(n,e){function t(i,s=Pi){let r;const a=Xe.getTransfer(s);if(i===bn)return n.UNSIGNED_BYTE;if(i===ru)return n.UNSIGNED_SHORT_4_4_4_4;if(i===au)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ip)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Cp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Rp)return n.BYTE;if(i===Np)return n.SHORT;if(i===Tr)return n.UNSIGNED_SHORT;if(i===su)return n.INT;if(i===Fn)return n.UNSIGNED_INT;if(i===$n)return n.FLOAT;if(i===pi)return n.HALF_FLOAT;if(i===Pp)return n.ALPHA;if(i===Lp)return n.RGB;if(i===Sn)return n.RGBA;if(i===mi)return n.DEPTH_COMPONENT;if(i===qi)return n.DEPTH_STENCIL;if(i===Dp)return n.RED;if(i===ou)return n.RED_INTEGER;if(i===is)return n.RG;if(i===cu)return n.RG_INTEGER;if(i===lu)return n.RGBA_INTEGER;if(i===Ya||i===Ka||i===$a||i===Ja)if(a===Qe)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Ya)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Ya)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ka)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ja)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===nl||i===il||i===sl||i===rl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===nl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===il)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===sl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===rl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===al||i===ol||i===cl||i===ll||i===ul||i===so||i===hl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===al||i===ol)return a===Qe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===cl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ll)return r.COMPRESSED_R11_EAC;if(i===ul)return r.COMPRESSED_SIGNED_R11_EAC;if(i===so)return r.COMPRESSED_RG11_EAC;if(i===hl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===fl||i===dl||i===pl||i===ml||i===gl||i===_l||i===vl||i===xl||i===yl||i===bl||i===Sl||i===El||i===Ml||i===Al)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===fl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===dl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===pl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===ml)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===gl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===_l)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===vl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===xl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===yl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===bl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Sl)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===El)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ml)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Al)return a===Qe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===wl||i===Tl||i===Rl)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===wl)return a===Qe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Tl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Rl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Nl||i===Il||i===ro||i===Cl)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Nl)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Il)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ro)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Cl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Rr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}const eS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,tS=`
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

}`;class nS{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){const i=new Xp(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){const t=e.cameras[0].viewport,i=new on({vertexShader:eS,fragmentShader:tS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new An(new Gr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class iS extends Oi{constructor(e,t){super();const i=this;let s=null,r=1,a=null,o="local-floor",c=1,l=null,u=null,f=null,h=null,d=null,g=null;const y=typeof XRWebGLBinding<"u",p=new nS,m={},v=t.getContextAttributes();let b=null,x=null;const E=[],w=[],T=new we;let _=null;const M=new vn;M.viewport=new ht;const N=new vn;N.viewport=new ht;const R=[M,N],C=new l_;let U=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let he=E[J];return he===void 0&&(he=new Zo,E[J]=he),he.getTargetRaySpace()},this.getControllerGrip=function(J){let he=E[J];return he===void 0&&(he=new Zo,E[J]=he),he.getGripSpace()},this.getHand=function(J){let he=E[J];return he===void 0&&(he=new Zo,E[J]=he),he.getHandSpace()};function L(J){const he=w.indexOf(J.inputSource);if(he===-1)return;const se=E[he];se!==void 0&&(se.update(J.inputSource,J.frame,l||a),se.dispatchEvent({type:J.type,data:J.inputSource}))}function V(){s.removeEventListener("select",L),s.removeEventListener("selectstart",L),s.removeEventListener("selectend",L),s.removeEventListener("squeeze",L),s.removeEventListener("squeezestart",L),s.removeEventListener("squeezeend",L),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",k);for(let J=0;J<E.length;J++){const he=w[J];he!==null&&(w[J]=null,E[J].disconnect(he))}U=null,B=null,p.reset();for(const J in m)delete m[J];e.setRenderTarget(b),d=null,h=null,f=null,s=null,x=null,Ie.stop(),i.isPresenting=!1,e.setPixelRatio(_),e.setSize(T.width,T.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,i.isPresenting===!0&&Ne("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){o=J,i.isPresenting===!0&&Ne("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||a},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&y&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(b=e.getRenderTarget(),s.addEventListener("select",L),s.addEventListener("selectstart",L),s.addEventListener("selectend",L),s.addEventListener("squeeze",L),s.addEventListener("squeezestart",L),s.addEventListener("squeezeend",L),s.addEventListener("end",V),s.addEventListener("inputsourceschange",k),v.xrCompatible!==!0&&await t.makeXRCompatible(),_=e.getPixelRatio(),e.getSize(T),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let se=null,Te=null,Ce=null;v.depth&&(Ce=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,se=v.stencil?qi:mi,Te=v.stencil?Rr:Fn);const Re={colorFormat:t.RGBA8,depthFormat:Ce,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Re),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),x=new Un(h.textureWidth,h.textureHeight,{format:Sn,type:bn,depthTexture:new rs(h.textureWidth,h.textureHeight,Te,void 0,void 0,void 0,void 0,void 0,void 0,se),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1})}else{const se={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,se),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),x=new Un(d.framebufferWidth,d.framebufferHeight,{format:Sn,type:bn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}x.isXRRenderTarget=!0,this.setFoveation(c),l=null,a=await s.requestReferenceSpace(o),Ie.setContext(s),Ie.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function k(J){for(let he=0;he<J.removed.length;he++){const se=J.removed[he],Te=w.indexOf(se);Te>=0&&(w[Te]=null,E[Te].disconnect(se))}for(let he=0;he<J.added.length;he++){const se=J.added[he];let Te=w.indexOf(se);if(Te===-1){for(let Re=0;Re<E.length;Re++)if(Re>=w.length){w.push(se),Te=Re;break}else if(w[Re]===null){w[Re]=se,Te=Re;break}if(Te===-1)break}const Ce=E[Te];Ce&&Ce.connect(se)}}const j=new P,ee=new P;function le(J,he,se){j.setFromMatrixPosition(he.matrixWorld),ee.setFromMatrixPosition(se.matrixWorld);const Te=j.distanceTo(ee),Ce=he.projectionMatrix.elements,Re=se.projectionMatrix.elements,at=Ce[14]/(Ce[10]-1),We=Ce[14]/(Ce[10]+1),nt=(Ce[9]+1)/Ce[5],ft=(Ce[9]-1)/Ce[5],Ge=(Ce[8]-1)/Ce[0],Tt=(Re[8]+1)/Re[0],pt=at*Ge,cn=at*Tt,F=Te/(-Ge+Tt),Rt=F*-Ge;if(he.matrixWorld.decompose(J.position,J.quaternion,J.scale),J.translateX(Rt),J.translateZ(F),J.matrixWorld.compose(J.position,J.quaternion,J.scale),J.matrixWorldInverse.copy(J.matrixWorld).invert(),Ce[10]===-1)J.projectionMatrix.copy(he.projectionMatrix),J.projectionMatrixInverse.copy(he.projectionMatrixInverse);else{const He=at+F,lt=We+F,ue=pt-Rt,mt=cn+(Te-Rt),I=nt*We/lt*He,S=ft*We/lt*He;J.projectionMatrix.makePerspective(ue,mt,I,S,He,lt),J.projectionMatrixInverse.copy(J.projectionMatrix).invert()}}function xe(J,he){he===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(he.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let he=J.near,se=J.far;p.texture!==null&&(p.depthNear>0&&(he=p.depthNear),p.depthFar>0&&(se=p.depthFar)),C.near=N.near=M.near=he,C.far=N.far=M.far=se,(U!==C.near||B!==C.far)&&(s.updateRenderState({depthNear:C.near,depthFar:C.far}),U=C.near,B=C.far),C.layers.mask=J.layers.mask|6,M.layers.mask=C.layers.mask&-5,N.layers.mask=C.layers.mask&-3;const Te=J.parent,Ce=C.cameras;xe(C,Te);for(let Re=0;Re<Ce.length;Re++)xe(Ce[Re],Te);Ce.length===2?le(C,M,N):C.projectionMatrix.copy(M.projectionMatrix),ye(J,C,Te)};function ye(J,he,se){se===null?J.matrix.copy(he.matrixWorld):(J.matrix.copy(se.matrixWorld),J.matrix.invert(),J.matrix.multiply(he.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(he.projectionMatrix),J.projectionMatrixInverse.copy(he.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Ir*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return C},this.getFoveation=function(){if(!(h===null&&d===null))return c},this.setFoveation=function(J){c=J,h!==null&&(h.fixedFoveation=J),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(C)},this.getCameraTexture=function(J){return m[J]};let ze=null;function qe(J,he){if(u=he.getViewerPose(l||a),g=he,u!==null){const se=u.views;d!==null&&(e.setRenderTargetFramebuffer(x,d.framebuffer),e.setRenderTarget(x));let Te=!1;se.length!==C.cameras.length&&(C.cameras.length=0,Te=!0);for(let We=0;We<se.length;We++){const nt=se[We];let ft=null;if(d!==null)ft=d.getViewport(nt);else{const Tt=f.getViewSubImage(h,nt);ft=Tt.viewport,We===0&&(e.setRenderTargetTextures(x,Tt.colorTexture,Tt.depthStencilTexture),e.setRenderTarget(x))}let Ge=R[We];Ge===void 0&&(Ge=new vn,Ge.layers.enable(We),Ge.viewport=new ht,R[We]=Ge),Ge.matrix.fromArray(nt.transform.matrix),Ge.matrix.decompose(Ge.position,Ge.quaternion,Ge.scale),Ge.projectionMatrix.fromArray(nt.projectionMatrix),Ge.projectionMatrixInverse.copy(Ge.projectionMatrix).invert(),Ge.viewport.set(ft.x,ft.y,ft.width,ft.height),We===0&&(C.matrix.copy(Ge.matrix),C.matrix.decompose(C.position,C.quaternion,C.scale)),Te===!0&&C.cameras.push(Ge)}const Ce=s.enabledFeatures;if(Ce&&Ce.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){f=i.getBinding();const We=f.getDepthInformation(se[0]);We&&We.isValid&&We.texture&&p.init(We,s.renderState)}if(Ce&&Ce.includes("camera-access")&&y){e.state.unbindTexture(),f=i.getBinding();for(let We=0;We<se.length;We++){const nt=se[We].camera;if(nt){let ft=m[nt];ft||(ft=new Xp,m[nt]=ft);const Ge=f.getCameraImage(nt);ft.sourceTexture=Ge}}}}for(let se=0;se<E.length;se++){const Te=w[se],Ce=E[se];Te!==null&&Ce!==void 0&&Ce.update(Te,he,l||a)}ze&&ze(J,he),he.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:he}),g=null}const Ie=new $p;Ie.setAnimationLoop(qe),this.setAnimationLoop=function(J){ze=J},this.dispose=function(){}}}const sS=new je,nm=new Ue;nm.set(-1,0,0,0,1,0,0,0,1);function rS(n,e){function t(p,m){p.matrixAutoUpdate===!0&&p.updateMatrix(),m.value.copy(p.matrix)}function i(p,m){m.color.getRGB(p.fogColor.value,Zp(n)),m.isFog?(p.fogNear.value=m.near,p.fogFar.value=m.far):m.isFogExp2&&(p.fogDensity.value=m.density)}function s(p,m,v,b,x){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(p,m):m.isMeshLambertMaterial?(r(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(p,m),f(p,m)):m.isMeshPhongMaterial?(r(p,m),u(p,m),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(p,m),h(p,m),m.isMeshPhysicalMaterial&&d(p,m,x)):m.isMeshMatcapMaterial?(r(p,m),g(p,m)):m.isMeshDepthMaterial?r(p,m):m.isMeshDistanceMaterial?(r(p,m),y(p,m)):m.isMeshNormalMaterial?r(p,m):m.isLineBasicMaterial?(a(p,m),m.isLineDashedMaterial&&o(p,m)):m.isPointsMaterial?c(p,m,v,b):m.isSpriteMaterial?l(p,m):m.isShadowMaterial?(p.color.value.copy(m.color),p.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(p,m){p.opacity.value=m.opacity,m.color&&p.diffuse.value.copy(m.color),m.emissive&&p.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.bumpMap&&(p.bumpMap.value=m.bumpMap,t(m.bumpMap,p.bumpMapTransform),p.bumpScale.value=m.bumpScale,m.side===Qt&&(p.bumpScale.value*=-1)),m.normalMap&&(p.normalMap.value=m.normalMap,t(m.normalMap,p.normalMapTransform),p.normalScale.value.copy(m.normalScale),m.side===Qt&&p.normalScale.value.negate()),m.displacementMap&&(p.displacementMap.value=m.displacementMap,t(m.displacementMap,p.displacementMapTransform),p.displacementScale.value=m.displacementScale,p.displacementBias.value=m.displacementBias),m.emissiveMap&&(p.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,p.emissiveMapTransform)),m.specularMap&&(p.specularMap.value=m.specularMap,t(m.specularMap,p.specularMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest);const v=e.get(m),b=v.envMap,x=v.envMapRotation;b&&(p.envMap.value=b,p.envMapRotation.value.setFromMatrix4(sS.makeRotationFromEuler(x)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(nm),p.reflectivity.value=m.reflectivity,p.ior.value=m.ior,p.refractionRatio.value=m.refractionRatio),m.lightMap&&(p.lightMap.value=m.lightMap,p.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,p.lightMapTransform)),m.aoMap&&(p.aoMap.value=m.aoMap,p.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,p.aoMapTransform))}function a(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform))}function o(p,m){p.dashSize.value=m.dashSize,p.totalSize.value=m.dashSize+m.gapSize,p.scale.value=m.scale}function c(p,m,v,b){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.size.value=m.size*v,p.scale.value=b*.5,m.map&&(p.map.value=m.map,t(m.map,p.uvTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function l(p,m){p.diffuse.value.copy(m.color),p.opacity.value=m.opacity,p.rotation.value=m.rotation,m.map&&(p.map.value=m.map,t(m.map,p.mapTransform)),m.alphaMap&&(p.alphaMap.value=m.alphaMap,t(m.alphaMap,p.alphaMapTransform)),m.alphaTest>0&&(p.alphaTest.value=m.alphaTest)}function u(p,m){p.specular.value.copy(m.specular),p.shininess.value=Math.max(m.shininess,1e-4)}function f(p,m){m.gradientMap&&(p.gradientMap.value=m.gradientMap)}function h(p,m){p.metalness.value=m.metalness,m.metalnessMap&&(p.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,p.metalnessMapTransform)),p.roughness.value=m.roughness,m.roughnessMap&&(p.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,p.roughnessMapTransform)),m.envMap&&(p.envMapIntensity.value=m.envMapIntensity)}function d(p,m,v){p.ior.value=m.ior,m.sheen>0&&(p.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),p.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(p.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,p.sheenColorMapTransform)),m.sheenRoughnessMap&&(p.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,p.sheenRoughnessMapTransform))),m.clearcoat>0&&(p.clearcoat.value=m.clearcoat,p.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(p.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,p.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(p.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Qt&&p.clearcoatNormalScale.value.negate())),m.dispersion>0&&(p.dispersion.value=m.dispersion),m.iridescence>0&&(p.iridescence.value=m.iridescence,p.iridescenceIOR.value=m.iridescenceIOR,p.iridescenceThicknessMinimum.value=m.iridescenceThicknessRange[0],p.iridescenceThicknessMaximum.value=m.iridescenceThicknessRange[1],m.iridescenceMap&&(p.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,p.iridescenceMapTransform)),m.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),m.transmission>0&&(p.transmission.value=m.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(p.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,p.transmissionMapTransform)),p.thickness.value=m.thickness,m.thicknessMap&&(p.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=m.attenuationDistance,p.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(p.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(p.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=m.specularIntensity,p.specularColor.value.copy(m.specularColor),m.specularColorMap&&(p.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,p.specularColorMapTransform)),m.specularIntensityMap&&(p.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,m){m.matcap&&(p.matcap.value=m.matcap)}function y(p,m){const v=e.get(m).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function aS(n,e,t,i){let s={},r={},a=[];const o=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function c(v,b){const x=b.program;i.uniformBlockBinding(v,x)}function l(v,b){let x=s[v.id];x===void 0&&(g(v),x=u(v),s[v.id]=x,v.addEventListener("dispose",p));const E=b.program;i.updateUBOMapping(v,E);const w=e.render.frame;r[v.id]!==w&&(h(v),r[v.id]=w)}function u(v){const b=f();v.__bindingPointIndex=b;const x=n.createBuffer(),E=v.__size,w=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,x),n.bufferData(n.UNIFORM_BUFFER,E,w),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,b,x),x}function f(){for(let v=0;v<o;v++)if(a.indexOf(v)===-1)return a.push(v),v;return Ze("WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function h(v){const b=s[v.id],x=v.uniforms,E=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let w=0,T=x.length;w<T;w++){const _=Array.isArray(x[w])?x[w]:[x[w]];for(let M=0,N=_.length;M<N;M++){const R=_[M];if(d(R,w,M,E)===!0){const C=R.__offset,U=Array.isArray(R.value)?R.value:[R.value];let B=0;for(let L=0;L<U.length;L++){const V=U[L],k=y(V);typeof V=="number"||typeof V=="boolean"?(R.__data[0]=V,n.bufferSubData(n.UNIFORM_BUFFER,C+B,R.__data)):V.isMatrix3?(R.__data[0]=V.elements[0],R.__data[1]=V.elements[1],R.__data[2]=V.elements[2],R.__data[3]=0,R.__data[4]=V.elements[3],R.__data[5]=V.elements[4],R.__data[6]=V.elements[5],R.__data[7]=0,R.__data[8]=V.elements[6],R.__data[9]=V.elements[7],R.__data[10]=V.elements[8],R.__data[11]=0):ArrayBuffer.isView(V)?R.__data.set(new V.constructor(V.buffer,V.byteOffset,R.__data.length)):(V.toArray(R.__data,B),B+=k.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,C,R.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(v,b,x,E){const w=v.value,T=b+"_"+x;if(E[T]===void 0)return typeof w=="number"||typeof w=="boolean"?E[T]=w:ArrayBuffer.isView(w)?E[T]=w.slice():E[T]=w.clone(),!0;{const _=E[T];if(typeof w=="number"||typeof w=="boolean"){if(_!==w)return E[T]=w,!0}else{if(ArrayBuffer.isView(w))return!0;if(_.equals(w)===!1)return _.copy(w),!0}}return!1}function g(v){const b=v.uniforms;let x=0;const E=16;for(let T=0,_=b.length;T<_;T++){const M=Array.isArray(b[T])?b[T]:[b[T]];for(let N=0,R=M.length;N<R;N++){const C=M[N],U=Array.isArray(C.value)?C.value:[C.value];for(let B=0,L=U.length;B<L;B++){const V=U[B],k=y(V),j=x%E,ee=j%k.boundary,le=j+ee;x+=ee,le!==0&&E-le<k.storage&&(x+=E-le),C.__data=new Float32Array(k.storage/Float32Array.BYTES_PER_ELEMENT),C.__offset=x,x+=k.storage}}}const w=x%E;return w>0&&(x+=E-w),v.__size=x,v.__cache={},this}function y(v){const b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=48,b.storage=48):v.isMatrix4?(b.boundary=64,b.storage=64):v.isTexture?Ne("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Ne("WebGLRenderer: Unsupported uniform value type.",v),b}function p(v){const b=v.target;b.removeEventListener("dispose",p);const x=a.indexOf(b.__bindingPointIndex);a.splice(x,1),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function m(){for(const v in s)n.deleteBuffer(s[v]);a=[],s={},r={}}return{bind:c,update:l,dispose:m}}const oS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let zn=null;function cS(){return zn===null&&(zn=new zp(oS,16,16,is,pi),zn.name="DFG_LUT",zn.minFilter=Ht,zn.magFilter=Ht,zn.wrapS=li,zn.wrapT=li,zn.generateMipmaps=!1,zn.needsUpdate=!0),zn}class lS{constructor(e={}){const{canvas:t=u0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=bn}=e;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=a;const y=d,p=new Set([lu,cu,ou]),m=new Set([bn,Fn,Tr,Rr,ru,au]),v=new Uint32Array(4),b=new Int32Array(4),x=new P;let E=null,w=null;const T=[],_=[];let M=null;this.domElement=t,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=jn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const N=this;let R=!1,C=null;this._outputColorSpace=_n;let U=0,B=0,L=null,V=-1,k=null;const j=new ht,ee=new ht;let le=null;const xe=new Ke(0);let ye=0,ze=t.width,qe=t.height,Ie=1,J=null,he=null;const se=new ht(0,0,ze,qe),Te=new ht(0,0,ze,qe);let Ce=!1;const Re=new Wp;let at=!1,We=!1;const nt=new je,ft=new P,Ge=new ht,Tt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let pt=!1;function cn(){return L===null?Ie:1}let F=i;function Rt(A,O){return t.getContext(A,O)}try{const A={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine","three.js r184"),t.addEventListener("webglcontextlost",q,!1),t.addEventListener("webglcontextrestored",Se,!1),t.addEventListener("webglcontextcreationerror",Fe,!1),F===null){const O="webgl2";if(F=Rt(O,A),F===null)throw Rt(O)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(A){throw Ze("WebGLRenderer: "+A.message),A}let He,lt,ue,mt,I,S,z,K,Q,te,oe,Z,$,pe,_e,re,ne,Pe,Oe,$e,D,ie,Y;function me(){He=new cy(F),He.init(),D=new Qb(F,He),lt=new ey(F,He,e,D),ue=new jb(F,He),lt.reversedDepthBuffer&&h&&ue.buffers.depth.setReversed(!0),mt=new hy(F),I=new Bb,S=new qb(F,He,ue,I,lt,D,mt),z=new oy(N),K=new m_(F),ie=new qx(F,K),Q=new ly(F,K,mt,ie),te=new dy(F,Q,K,ie,mt),Pe=new fy(F,lt,S),_e=new ty(I),oe=new Fb(N,z,He,lt,ie,_e),Z=new rS(N,I),$=new Vb,pe=new Xb(He),ne=new jx(N,z,ue,te,g,c),re=new Jb(N,te,lt),Y=new aS(F,mt,lt,ue),Oe=new Qx(F,He,mt),$e=new uy(F,He,mt),mt.programs=oe.programs,N.capabilities=lt,N.extensions=He,N.properties=I,N.renderLists=$,N.shadowMap=re,N.state=ue,N.info=mt}me(),y!==bn&&(M=new my(y,t.width,t.height,s,r));const ae=new iS(N,F);this.xr=ae,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){const A=He.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){const A=He.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Ie},this.setPixelRatio=function(A){A!==void 0&&(Ie=A,this.setSize(ze,qe,!1))},this.getSize=function(A){return A.set(ze,qe)},this.setSize=function(A,O,X=!0){if(ae.isPresenting){Ne("WebGLRenderer: Can't change size while VR device is presenting.");return}ze=A,qe=O,t.width=Math.floor(A*Ie),t.height=Math.floor(O*Ie),X===!0&&(t.style.width=A+"px",t.style.height=O+"px"),M!==null&&M.setSize(t.width,t.height),this.setViewport(0,0,A,O)},this.getDrawingBufferSize=function(A){return A.set(ze*Ie,qe*Ie).floor()},this.setDrawingBufferSize=function(A,O,X){ze=A,qe=O,Ie=X,t.width=Math.floor(A*X),t.height=Math.floor(O*X),this.setViewport(0,0,A,O)},this.setEffects=function(A){if(y===bn){Ze("THREE.WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let O=0;O<A.length;O++)if(A[O].isOutputPass===!0){Ne("THREE.WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}M.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(j)},this.getViewport=function(A){return A.copy(se)},this.setViewport=function(A,O,X,W){A.isVector4?se.set(A.x,A.y,A.z,A.w):se.set(A,O,X,W),ue.viewport(j.copy(se).multiplyScalar(Ie).round())},this.getScissor=function(A){return A.copy(Te)},this.setScissor=function(A,O,X,W){A.isVector4?Te.set(A.x,A.y,A.z,A.w):Te.set(A,O,X,W),ue.scissor(ee.copy(Te).multiplyScalar(Ie).round())},this.getScissorTest=function(){return Ce},this.setScissorTest=function(A){ue.setScissorTest(Ce=A)},this.setOpaqueSort=function(A){J=A},this.setTransparentSort=function(A){he=A},this.getClearColor=function(A){return A.copy(ne.getClearColor())},this.setClearColor=function(){ne.setClearColor(...arguments)},this.getClearAlpha=function(){return ne.getClearAlpha()},this.setClearAlpha=function(){ne.setClearAlpha(...arguments)},this.clear=function(A=!0,O=!0,X=!0){let W=0;if(A){let H=!1;if(L!==null){const de=L.texture.format;H=p.has(de)}if(H){const de=L.texture.type,ve=m.has(de),fe=ne.getClearColor(),be=ne.getClearAlpha(),Ee=fe.r,Be=fe.g,ke=fe.b;ve?(v[0]=Ee,v[1]=Be,v[2]=ke,v[3]=be,F.clearBufferuiv(F.COLOR,0,v)):(b[0]=Ee,b[1]=Be,b[2]=ke,b[3]=be,F.clearBufferiv(F.COLOR,0,b))}else W|=F.COLOR_BUFFER_BIT}O&&(W|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),X&&(W|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),W!==0&&F.clear(W)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),C=A},this.dispose=function(){t.removeEventListener("webglcontextlost",q,!1),t.removeEventListener("webglcontextrestored",Se,!1),t.removeEventListener("webglcontextcreationerror",Fe,!1),ne.dispose(),$.dispose(),pe.dispose(),I.dispose(),z.dispose(),te.dispose(),ie.dispose(),Y.dispose(),oe.dispose(),ae.dispose(),ae.removeEventListener("sessionstart",nh),ae.removeEventListener("sessionend",ih),ki.stop()};function q(A){A.preventDefault(),lo("WebGLRenderer: Context Lost."),R=!0}function Se(){lo("WebGLRenderer: Context Restored."),R=!1;const A=mt.autoReset,O=re.enabled,X=re.autoUpdate,W=re.needsUpdate,H=re.type;me(),mt.autoReset=A,re.enabled=O,re.autoUpdate=X,re.needsUpdate=W,re.type=H}function Fe(A){Ze("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function vt(A){const O=A.target;O.removeEventListener("dispose",vt),it(O)}function it(A){ei(A),I.remove(A)}function ei(A){const O=I.get(A).programs;O!==void 0&&(O.forEach(function(X){oe.releaseProgram(X)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,O,X,W,H,de){O===null&&(O=Tt);const ve=H.isMesh&&H.matrixWorld.determinant()<0,fe=Mg(A,O,X,W,H);ue.setMaterial(W,ve);let be=X.index,Ee=1;if(W.wireframe===!0){if(be=Q.getWireframeAttribute(X),be===void 0)return;Ee=2}const Be=X.drawRange,ke=X.attributes.position;let Me=Be.start*Ee,st=(Be.start+Be.count)*Ee;de!==null&&(Me=Math.max(Me,de.start*Ee),st=Math.min(st,(de.start+de.count)*Ee)),be!==null?(Me=Math.max(Me,0),st=Math.min(st,be.count)):ke!=null&&(Me=Math.max(Me,0),st=Math.min(st,ke.count));const xt=st-Me;if(xt<0||xt===1/0)return;ie.setup(H,W,fe,X,be);let gt,ot=Oe;if(be!==null&&(gt=K.get(be),ot=$e,ot.setIndex(gt)),H.isMesh)W.wireframe===!0?(ue.setLineWidth(W.wireframeLinewidth*cn()),ot.setMode(F.LINES)):ot.setMode(F.TRIANGLES);else if(H.isLine){let Xt=W.linewidth;Xt===void 0&&(Xt=1),ue.setLineWidth(Xt*cn()),H.isLineSegments?ot.setMode(F.LINES):H.isLineLoop?ot.setMode(F.LINE_LOOP):ot.setMode(F.LINE_STRIP)}else H.isPoints?ot.setMode(F.POINTS):H.isSprite&&ot.setMode(F.TRIANGLES);if(H.isBatchedMesh)if(He.get("WEBGL_multi_draw"))ot.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const Xt=H._multiDrawStarts,ge=H._multiDrawCounts,ln=H._multiDrawCount,Ye=be?K.get(be).bytesPerElement:1,pn=I.get(W).currentProgram.getUniforms();for(let kn=0;kn<ln;kn++)pn.setValue(F,"_gl_DrawID",kn),ot.render(Xt[kn]/Ye,ge[kn])}else if(H.isInstancedMesh)ot.renderInstances(Me,xt,H.count);else if(X.isInstancedBufferGeometry){const Xt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,ge=Math.min(X.instanceCount,Xt);ot.renderInstances(Me,xt,ge)}else ot.render(Me,xt)};function Vn(A,O,X){A.transparent===!0&&A.side===yn&&A.forceSinglePass===!1?(A.side=Qt,A.needsUpdate=!0,$r(A,O,X),A.side=qn,A.needsUpdate=!0,$r(A,O,X),A.side=yn):$r(A,O,X)}this.compile=function(A,O,X=null){X===null&&(X=A),w=pe.get(X),w.init(O),_.push(w),X.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(w.pushLight(H),H.castShadow&&w.pushShadow(H))}),A!==X&&A.traverseVisible(function(H){H.isLight&&H.layers.test(O.layers)&&(w.pushLight(H),H.castShadow&&w.pushShadow(H))}),w.setupLights();const W=new Set;return A.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const de=H.material;if(de)if(Array.isArray(de))for(let ve=0;ve<de.length;ve++){const fe=de[ve];Vn(fe,X,H),W.add(fe)}else Vn(de,X,H),W.add(de)}),w=_.pop(),W},this.compileAsync=function(A,O,X=null){const W=this.compile(A,O,X);return new Promise(H=>{function de(){if(W.forEach(function(ve){I.get(ve).currentProgram.isReady()&&W.delete(ve)}),W.size===0){H(A);return}setTimeout(de,10)}He.get("KHR_parallel_shader_compile")!==null?de():setTimeout(de,10)})};let Fo=null;function Sg(A){Fo&&Fo(A)}function nh(){ki.stop()}function ih(){ki.start()}const ki=new $p;ki.setAnimationLoop(Sg),typeof self<"u"&&ki.setContext(self),this.setAnimationLoop=function(A){Fo=A,ae.setAnimationLoop(A),A===null?ki.stop():ki.start()},ae.addEventListener("sessionstart",nh),ae.addEventListener("sessionend",ih),this.render=function(A,O){if(O!==void 0&&O.isCamera!==!0){Ze("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;C!==null&&C.renderStart(A,O);const X=ae.enabled===!0&&ae.isPresenting===!0,W=M!==null&&(L===null||X)&&M.begin(N,L);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),ae.enabled===!0&&ae.isPresenting===!0&&(M===null||M.isCompositing()===!1)&&(ae.cameraAutoUpdate===!0&&ae.updateCamera(O),O=ae.getCamera()),A.isScene===!0&&A.onBeforeRender(N,A,O,L),w=pe.get(A,_.length),w.init(O),w.state.textureUnits=S.getTextureUnits(),_.push(w),nt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),Re.setFromProjectionMatrix(nt,Jn,O.reversedDepth),We=this.localClippingEnabled,at=_e.init(this.clippingPlanes,We),E=$.get(A,T.length),E.init(),T.push(E),ae.enabled===!0&&ae.isPresenting===!0){const ve=N.xr.getDepthSensingMesh();ve!==null&&Bo(ve,O,-1/0,N.sortObjects)}Bo(A,O,0,N.sortObjects),E.finish(),N.sortObjects===!0&&E.sort(J,he),pt=ae.enabled===!1||ae.isPresenting===!1||ae.hasDepthSensing()===!1,pt&&ne.addToRenderList(E,A),this.info.render.frame++,at===!0&&_e.beginShadows();const H=w.state.shadowsArray;if(re.render(H,A,O),at===!0&&_e.endShadows(),this.info.autoReset===!0&&this.info.reset(),(W&&M.hasRenderPass())===!1){const ve=E.opaque,fe=E.transmissive;if(w.setupLights(),O.isArrayCamera){const be=O.cameras;if(fe.length>0)for(let Ee=0,Be=be.length;Ee<Be;Ee++){const ke=be[Ee];rh(ve,fe,A,ke)}pt&&ne.render(A);for(let Ee=0,Be=be.length;Ee<Be;Ee++){const ke=be[Ee];sh(E,A,ke,ke.viewport)}}else fe.length>0&&rh(ve,fe,A,O),pt&&ne.render(A),sh(E,A,O)}L!==null&&B===0&&(S.updateMultisampleRenderTarget(L),S.updateRenderTargetMipmap(L)),W&&M.end(N),A.isScene===!0&&A.onAfterRender(N,A,O),ie.resetDefaultState(),V=-1,k=null,_.pop(),_.length>0?(w=_[_.length-1],S.setTextureUnits(w.state.textureUnits),at===!0&&_e.setGlobalState(N.clippingPlanes,w.state.camera)):w=null,T.pop(),T.length>0?E=T[T.length-1]:E=null,C!==null&&C.renderEnd()};function Bo(A,O,X,W){if(A.visible===!1)return;if(A.layers.test(O.layers)){if(A.isGroup)X=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(O);else if(A.isLightProbeGrid)w.pushLightProbeGrid(A);else if(A.isLight)w.pushLight(A),A.castShadow&&w.pushShadow(A);else if(A.isSprite){if(!A.frustumCulled||Re.intersectsSprite(A)){W&&Ge.setFromMatrixPosition(A.matrixWorld).applyMatrix4(nt);const ve=te.update(A),fe=A.material;fe.visible&&E.push(A,ve,fe,X,Ge.z,null)}}else if((A.isMesh||A.isLine||A.isPoints)&&(!A.frustumCulled||Re.intersectsObject(A))){const ve=te.update(A),fe=A.material;if(W&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Ge.copy(A.boundingSphere.center)):(ve.boundingSphere===null&&ve.computeBoundingSphere(),Ge.copy(ve.boundingSphere.center)),Ge.applyMatrix4(A.matrixWorld).applyMatrix4(nt)),Array.isArray(fe)){const be=ve.groups;for(let Ee=0,Be=be.length;Ee<Be;Ee++){const ke=be[Ee],Me=fe[ke.materialIndex];Me&&Me.visible&&E.push(A,ve,Me,X,Ge.z,ke)}}else fe.visible&&E.push(A,ve,fe,X,Ge.z,null)}}const de=A.children;for(let ve=0,fe=de.length;ve<fe;ve++)Bo(de[ve],O,X,W)}function sh(A,O,X,W){const{opaque:H,transmissive:de,transparent:ve}=A;w.setupLightsView(X),at===!0&&_e.setGlobalState(N.clippingPlanes,X),W&&ue.viewport(j.copy(W)),H.length>0&&Kr(H,O,X),de.length>0&&Kr(de,O,X),ve.length>0&&Kr(ve,O,X),ue.buffers.depth.setTest(!0),ue.buffers.depth.setMask(!0),ue.buffers.color.setMask(!0),ue.setPolygonOffset(!1)}function rh(A,O,X,W){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[W.id]===void 0){const Me=He.has("EXT_color_buffer_half_float")||He.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[W.id]=new Un(1,1,{generateMipmaps:!0,type:Me?pi:bn,minFilter:ji,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:Xe.workingColorSpace})}const de=w.state.transmissionRenderTarget[W.id],ve=W.viewport||j;de.setSize(ve.z*N.transmissionResolutionScale,ve.w*N.transmissionResolutionScale);const fe=N.getRenderTarget(),be=N.getActiveCubeFace(),Ee=N.getActiveMipmapLevel();N.setRenderTarget(de),N.getClearColor(xe),ye=N.getClearAlpha(),ye<1&&N.setClearColor(16777215,.5),N.clear(),pt&&ne.render(X);const Be=N.toneMapping;N.toneMapping=jn;const ke=W.viewport;if(W.viewport!==void 0&&(W.viewport=void 0),w.setupLightsView(W),at===!0&&_e.setGlobalState(N.clippingPlanes,W),Kr(A,X,W),S.updateMultisampleRenderTarget(de),S.updateRenderTargetMipmap(de),He.has("WEBGL_multisampled_render_to_texture")===!1){let Me=!1;for(let st=0,xt=O.length;st<xt;st++){const gt=O[st],{object:ot,geometry:Xt,material:ge,group:ln}=gt;if(ge.side===yn&&ot.layers.test(W.layers)){const Ye=ge.side;ge.side=Qt,ge.needsUpdate=!0,ah(ot,X,W,Xt,ge,ln),ge.side=Ye,ge.needsUpdate=!0,Me=!0}}Me===!0&&(S.updateMultisampleRenderTarget(de),S.updateRenderTargetMipmap(de))}N.setRenderTarget(fe,be,Ee),N.setClearColor(xe,ye),ke!==void 0&&(W.viewport=ke),N.toneMapping=Be}function Kr(A,O,X){const W=O.isScene===!0?O.overrideMaterial:null;for(let H=0,de=A.length;H<de;H++){const ve=A[H],{object:fe,geometry:be,group:Ee}=ve;let Be=ve.material;Be.allowOverride===!0&&W!==null&&(Be=W),fe.layers.test(X.layers)&&ah(fe,O,X,be,Be,Ee)}}function ah(A,O,X,W,H,de){A.onBeforeRender(N,O,X,W,H,de),A.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),H.onBeforeRender(N,O,X,W,A,de),H.transparent===!0&&H.side===yn&&H.forceSinglePass===!1?(H.side=Qt,H.needsUpdate=!0,N.renderBufferDirect(X,O,W,H,A,de),H.side=qn,H.needsUpdate=!0,N.renderBufferDirect(X,O,W,H,A,de),H.side=yn):N.renderBufferDirect(X,O,W,H,A,de),A.onAfterRender(N,O,X,W,H,de)}function $r(A,O,X){O.isScene!==!0&&(O=Tt);const W=I.get(A),H=w.state.lights,de=w.state.shadowsArray,ve=H.state.version,fe=oe.getParameters(A,H.state,de,O,X,w.state.lightProbeGridArray),be=oe.getProgramCacheKey(fe);let Ee=W.programs;W.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?O.environment:null,W.fog=O.fog;const Be=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;W.envMap=z.get(A.envMap||W.environment,Be),W.envMapRotation=W.environment!==null&&A.envMap===null?O.environmentRotation:A.envMapRotation,Ee===void 0&&(A.addEventListener("dispose",vt),Ee=new Map,W.programs=Ee);let ke=Ee.get(be);if(ke!==void 0){if(W.currentProgram===ke&&W.lightsStateVersion===ve)return ch(A,fe),ke}else fe.uniforms=oe.getUniforms(A),C!==null&&A.isNodeMaterial&&C.build(A,X,fe),A.onBeforeCompile(fe,N),ke=oe.acquireProgram(fe,be),Ee.set(be,ke),W.uniforms=fe.uniforms;const Me=W.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Me.clippingPlanes=_e.uniform),ch(A,fe),W.needsLights=wg(A),W.lightsStateVersion=ve,W.needsLights&&(Me.ambientLightColor.value=H.state.ambient,Me.lightProbe.value=H.state.probe,Me.directionalLights.value=H.state.directional,Me.directionalLightShadows.value=H.state.directionalShadow,Me.spotLights.value=H.state.spot,Me.spotLightShadows.value=H.state.spotShadow,Me.rectAreaLights.value=H.state.rectArea,Me.ltc_1.value=H.state.rectAreaLTC1,Me.ltc_2.value=H.state.rectAreaLTC2,Me.pointLights.value=H.state.point,Me.pointLightShadows.value=H.state.pointShadow,Me.hemisphereLights.value=H.state.hemi,Me.directionalShadowMatrix.value=H.state.directionalShadowMatrix,Me.spotLightMatrix.value=H.state.spotLightMatrix,Me.spotLightMap.value=H.state.spotLightMap,Me.pointShadowMatrix.value=H.state.pointShadowMatrix),W.lightProbeGrid=w.state.lightProbeGridArray.length>0,W.currentProgram=ke,W.uniformsList=null,ke}function oh(A){if(A.uniformsList===null){const O=A.currentProgram.getUniforms();A.uniformsList=ja.seqWithValue(O.seq,A.uniforms)}return A.uniformsList}function ch(A,O){const X=I.get(A);X.outputColorSpace=O.outputColorSpace,X.batching=O.batching,X.batchingColor=O.batchingColor,X.instancing=O.instancing,X.instancingColor=O.instancingColor,X.instancingMorph=O.instancingMorph,X.skinning=O.skinning,X.morphTargets=O.morphTargets,X.morphNormals=O.morphNormals,X.morphColors=O.morphColors,X.morphTargetsCount=O.morphTargetsCount,X.numClippingPlanes=O.numClippingPlanes,X.numIntersection=O.numClipIntersection,X.vertexAlphas=O.vertexAlphas,X.vertexTangents=O.vertexTangents,X.toneMapping=O.toneMapping}function Eg(A,O){if(A.length===0)return null;if(A.length===1)return A[0].texture!==null?A[0]:null;x.setFromMatrixPosition(O.matrixWorld);for(let X=0,W=A.length;X<W;X++){const H=A[X];if(H.texture!==null&&H.boundingBox.containsPoint(x))return H}return null}function Mg(A,O,X,W,H){O.isScene!==!0&&(O=Tt),S.resetTextureUnits();const de=O.fog,ve=W.isMeshStandardMaterial||W.isMeshLambertMaterial||W.isMeshPhongMaterial?O.environment:null,fe=L===null?N.outputColorSpace:L.isXRRenderTarget===!0?L.texture.colorSpace:Xe.workingColorSpace,be=W.isMeshStandardMaterial||W.isMeshLambertMaterial&&!W.envMap||W.isMeshPhongMaterial&&!W.envMap,Ee=z.get(W.envMap||ve,be),Be=W.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,ke=!!X.attributes.tangent&&(!!W.normalMap||W.anisotropy>0),Me=!!X.morphAttributes.position,st=!!X.morphAttributes.normal,xt=!!X.morphAttributes.color;let gt=jn;W.toneMapped&&(L===null||L.isXRRenderTarget===!0)&&(gt=N.toneMapping);const ot=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,Xt=ot!==void 0?ot.length:0,ge=I.get(W),ln=w.state.lights;if(at===!0&&(We===!0||A!==k)){const ut=A===k&&W.id===V;_e.setState(W,A,ut)}let Ye=!1;W.version===ge.__version?(ge.needsLights&&ge.lightsStateVersion!==ln.state.version||ge.outputColorSpace!==fe||H.isBatchedMesh&&ge.batching===!1||!H.isBatchedMesh&&ge.batching===!0||H.isBatchedMesh&&ge.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&ge.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&ge.instancing===!1||!H.isInstancedMesh&&ge.instancing===!0||H.isSkinnedMesh&&ge.skinning===!1||!H.isSkinnedMesh&&ge.skinning===!0||H.isInstancedMesh&&ge.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&ge.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&ge.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&ge.instancingMorph===!1&&H.morphTexture!==null||ge.envMap!==Ee||W.fog===!0&&ge.fog!==de||ge.numClippingPlanes!==void 0&&(ge.numClippingPlanes!==_e.numPlanes||ge.numIntersection!==_e.numIntersection)||ge.vertexAlphas!==Be||ge.vertexTangents!==ke||ge.morphTargets!==Me||ge.morphNormals!==st||ge.morphColors!==xt||ge.toneMapping!==gt||ge.morphTargetsCount!==Xt||!!ge.lightProbeGrid!=w.state.lightProbeGridArray.length>0)&&(Ye=!0):(Ye=!0,ge.__version=W.version);let pn=ge.currentProgram;Ye===!0&&(pn=$r(W,O,H),C&&W.isNodeMaterial&&C.onUpdateProgram(W,pn,ge));let kn=!1,bi=!1,os=!1;const ct=pn.getUniforms(),yt=ge.uniforms;if(ue.useProgram(pn.program)&&(kn=!0,bi=!0,os=!0),W.id!==V&&(V=W.id,bi=!0),ge.needsLights){const ut=Eg(w.state.lightProbeGridArray,H);ge.lightProbeGrid!==ut&&(ge.lightProbeGrid=ut,bi=!0)}if(kn||k!==A){ue.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ct.setValue(F,"projectionMatrix",A.projectionMatrix),ct.setValue(F,"viewMatrix",A.matrixWorldInverse);const Ei=ct.map.cameraPosition;Ei!==void 0&&Ei.setValue(F,ft.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&ct.setValue(F,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(W.isMeshPhongMaterial||W.isMeshToonMaterial||W.isMeshLambertMaterial||W.isMeshBasicMaterial||W.isMeshStandardMaterial||W.isShaderMaterial)&&ct.setValue(F,"isOrthographic",A.isOrthographicCamera===!0),k!==A&&(k=A,bi=!0,os=!0)}if(ge.needsLights&&(ln.state.directionalShadowMap.length>0&&ct.setValue(F,"directionalShadowMap",ln.state.directionalShadowMap,S),ln.state.spotShadowMap.length>0&&ct.setValue(F,"spotShadowMap",ln.state.spotShadowMap,S),ln.state.pointShadowMap.length>0&&ct.setValue(F,"pointShadowMap",ln.state.pointShadowMap,S)),H.isSkinnedMesh){ct.setOptional(F,H,"bindMatrix"),ct.setOptional(F,H,"bindMatrixInverse");const ut=H.skeleton;ut&&(ut.boneTexture===null&&ut.computeBoneTexture(),ct.setValue(F,"boneTexture",ut.boneTexture,S))}H.isBatchedMesh&&(ct.setOptional(F,H,"batchingTexture"),ct.setValue(F,"batchingTexture",H._matricesTexture,S),ct.setOptional(F,H,"batchingIdTexture"),ct.setValue(F,"batchingIdTexture",H._indirectTexture,S),ct.setOptional(F,H,"batchingColorTexture"),H._colorsTexture!==null&&ct.setValue(F,"batchingColorTexture",H._colorsTexture,S));const Si=X.morphAttributes;if((Si.position!==void 0||Si.normal!==void 0||Si.color!==void 0)&&Pe.update(H,X,pn),(bi||ge.receiveShadow!==H.receiveShadow)&&(ge.receiveShadow=H.receiveShadow,ct.setValue(F,"receiveShadow",H.receiveShadow)),(W.isMeshStandardMaterial||W.isMeshLambertMaterial||W.isMeshPhongMaterial)&&W.envMap===null&&O.environment!==null&&(yt.envMapIntensity.value=O.environmentIntensity),yt.dfgLUT!==void 0&&(yt.dfgLUT.value=cS()),bi){if(ct.setValue(F,"toneMappingExposure",N.toneMappingExposure),ge.needsLights&&Ag(yt,os),de&&W.fog===!0&&Z.refreshFogUniforms(yt,de),Z.refreshMaterialUniforms(yt,W,Ie,qe,w.state.transmissionRenderTarget[A.id]),ge.needsLights&&ge.lightProbeGrid){const ut=ge.lightProbeGrid;yt.probesSH.value=ut.texture,yt.probesMin.value.copy(ut.boundingBox.min),yt.probesMax.value.copy(ut.boundingBox.max),yt.probesResolution.value.copy(ut.resolution)}ja.upload(F,oh(ge),yt,S)}if(W.isShaderMaterial&&W.uniformsNeedUpdate===!0&&(ja.upload(F,oh(ge),yt,S),W.uniformsNeedUpdate=!1),W.isSpriteMaterial&&ct.setValue(F,"center",H.center),ct.setValue(F,"modelViewMatrix",H.modelViewMatrix),ct.setValue(F,"normalMatrix",H.normalMatrix),ct.setValue(F,"modelMatrix",H.matrixWorld),W.uniformsGroups!==void 0){const ut=W.uniformsGroups;for(let Ei=0,cs=ut.length;Ei<cs;Ei++){const lh=ut[Ei];Y.update(lh,pn),Y.bind(lh,pn)}}return pn}function Ag(A,O){A.ambientLightColor.needsUpdate=O,A.lightProbe.needsUpdate=O,A.directionalLights.needsUpdate=O,A.directionalLightShadows.needsUpdate=O,A.pointLights.needsUpdate=O,A.pointLightShadows.needsUpdate=O,A.spotLights.needsUpdate=O,A.spotLightShadows.needsUpdate=O,A.rectAreaLights.needsUpdate=O,A.hemisphereLights.needsUpdate=O}function wg(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return U},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return L},this.setRenderTargetTextures=function(A,O,X){const W=I.get(A);W.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,W.__autoAllocateDepthBuffer===!1&&(W.__useRenderToTexture=!1),I.get(A.texture).__webglTexture=O,I.get(A.depthTexture).__webglTexture=W.__autoAllocateDepthBuffer?void 0:X,W.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,O){const X=I.get(A);X.__webglFramebuffer=O,X.__useDefaultFramebuffer=O===void 0};const Tg=F.createFramebuffer();this.setRenderTarget=function(A,O=0,X=0){L=A,U=O,B=X;let W=null,H=!1,de=!1;if(A){const fe=I.get(A);if(fe.__useDefaultFramebuffer!==void 0){ue.bindFramebuffer(F.FRAMEBUFFER,fe.__webglFramebuffer),j.copy(A.viewport),ee.copy(A.scissor),le=A.scissorTest,ue.viewport(j),ue.scissor(ee),ue.setScissorTest(le),V=-1;return}else if(fe.__webglFramebuffer===void 0)S.setupRenderTarget(A);else if(fe.__hasExternalTextures)S.rebindTextures(A,I.get(A.texture).__webglTexture,I.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){const Be=A.depthTexture;if(fe.__boundDepthTexture!==Be){if(Be!==null&&I.has(Be)&&(A.width!==Be.image.width||A.height!==Be.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");S.setupDepthRenderbuffer(A)}}const be=A.texture;(be.isData3DTexture||be.isDataArrayTexture||be.isCompressedArrayTexture)&&(de=!0);const Ee=I.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Ee[O])?W=Ee[O][X]:W=Ee[O],H=!0):A.samples>0&&S.useMultisampledRTT(A)===!1?W=I.get(A).__webglMultisampledFramebuffer:Array.isArray(Ee)?W=Ee[X]:W=Ee,j.copy(A.viewport),ee.copy(A.scissor),le=A.scissorTest}else j.copy(se).multiplyScalar(Ie).floor(),ee.copy(Te).multiplyScalar(Ie).floor(),le=Ce;if(X!==0&&(W=Tg),ue.bindFramebuffer(F.FRAMEBUFFER,W)&&ue.drawBuffers(A,W),ue.viewport(j),ue.scissor(ee),ue.setScissorTest(le),H){const fe=I.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+O,fe.__webglTexture,X)}else if(de){const fe=O;for(let be=0;be<A.textures.length;be++){const Ee=I.get(A.textures[be]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+be,Ee.__webglTexture,X,fe)}}else if(A!==null&&X!==0){const fe=I.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,fe.__webglTexture,X)}V=-1},this.readRenderTargetPixels=function(A,O,X,W,H,de,ve,fe=0){if(!(A&&A.isWebGLRenderTarget)){Ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let be=I.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&ve!==void 0&&(be=be[ve]),be){ue.bindFramebuffer(F.FRAMEBUFFER,be);try{const Ee=A.textures[fe],Be=Ee.format,ke=Ee.type;if(A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+fe),!lt.textureFormatReadable(Be)){Ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!lt.textureTypeReadable(ke)){Ze("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=A.width-W&&X>=0&&X<=A.height-H&&F.readPixels(O,X,W,H,D.convert(Be),D.convert(ke),de)}finally{const Ee=L!==null?I.get(L).__webglFramebuffer:null;ue.bindFramebuffer(F.FRAMEBUFFER,Ee)}}},this.readRenderTargetPixelsAsync=async function(A,O,X,W,H,de,ve,fe=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let be=I.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&ve!==void 0&&(be=be[ve]),be)if(O>=0&&O<=A.width-W&&X>=0&&X<=A.height-H){ue.bindFramebuffer(F.FRAMEBUFFER,be);const Ee=A.textures[fe],Be=Ee.format,ke=Ee.type;if(A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+fe),!lt.textureFormatReadable(Be))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!lt.textureTypeReadable(ke))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const Me=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,Me),F.bufferData(F.PIXEL_PACK_BUFFER,de.byteLength,F.STREAM_READ),F.readPixels(O,X,W,H,D.convert(Be),D.convert(ke),0);const st=L!==null?I.get(L).__webglFramebuffer:null;ue.bindFramebuffer(F.FRAMEBUFFER,st);const xt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await h0(F,xt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,Me),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,de),F.deleteBuffer(Me),F.deleteSync(xt),de}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,O=null,X=0){const W=Math.pow(2,-X),H=Math.floor(A.image.width*W),de=Math.floor(A.image.height*W),ve=O!==null?O.x:0,fe=O!==null?O.y:0;S.setTexture2D(A,0),F.copyTexSubImage2D(F.TEXTURE_2D,X,0,0,ve,fe,H,de),ue.unbindTexture()};const Rg=F.createFramebuffer(),Ng=F.createFramebuffer();this.copyTextureToTexture=function(A,O,X=null,W=null,H=0,de=0){let ve,fe,be,Ee,Be,ke,Me,st,xt;const gt=A.isCompressedTexture?A.mipmaps[de]:A.image;if(X!==null)ve=X.max.x-X.min.x,fe=X.max.y-X.min.y,be=X.isBox3?X.max.z-X.min.z:1,Ee=X.min.x,Be=X.min.y,ke=X.isBox3?X.min.z:0;else{const yt=Math.pow(2,-H);ve=Math.floor(gt.width*yt),fe=Math.floor(gt.height*yt),A.isDataArrayTexture?be=gt.depth:A.isData3DTexture?be=Math.floor(gt.depth*yt):be=1,Ee=0,Be=0,ke=0}W!==null?(Me=W.x,st=W.y,xt=W.z):(Me=0,st=0,xt=0);const ot=D.convert(O.format),Xt=D.convert(O.type);let ge;O.isData3DTexture?(S.setTexture3D(O,0),ge=F.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(S.setTexture2DArray(O,0),ge=F.TEXTURE_2D_ARRAY):(S.setTexture2D(O,0),ge=F.TEXTURE_2D),ue.activeTexture(F.TEXTURE0),ue.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,O.flipY),ue.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),ue.pixelStorei(F.UNPACK_ALIGNMENT,O.unpackAlignment);const ln=ue.getParameter(F.UNPACK_ROW_LENGTH),Ye=ue.getParameter(F.UNPACK_IMAGE_HEIGHT),pn=ue.getParameter(F.UNPACK_SKIP_PIXELS),kn=ue.getParameter(F.UNPACK_SKIP_ROWS),bi=ue.getParameter(F.UNPACK_SKIP_IMAGES);ue.pixelStorei(F.UNPACK_ROW_LENGTH,gt.width),ue.pixelStorei(F.UNPACK_IMAGE_HEIGHT,gt.height),ue.pixelStorei(F.UNPACK_SKIP_PIXELS,Ee),ue.pixelStorei(F.UNPACK_SKIP_ROWS,Be),ue.pixelStorei(F.UNPACK_SKIP_IMAGES,ke);const os=A.isDataArrayTexture||A.isData3DTexture,ct=O.isDataArrayTexture||O.isData3DTexture;if(A.isDepthTexture){const yt=I.get(A),Si=I.get(O),ut=I.get(yt.__renderTarget),Ei=I.get(Si.__renderTarget);ue.bindFramebuffer(F.READ_FRAMEBUFFER,ut.__webglFramebuffer),ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ei.__webglFramebuffer);for(let cs=0;cs<be;cs++)os&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,I.get(A).__webglTexture,H,ke+cs),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,I.get(O).__webglTexture,de,xt+cs)),F.blitFramebuffer(Ee,Be,ve,fe,Me,st,ve,fe,F.DEPTH_BUFFER_BIT,F.NEAREST);ue.bindFramebuffer(F.READ_FRAMEBUFFER,null),ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(H!==0||A.isRenderTargetTexture||I.has(A)){const yt=I.get(A),Si=I.get(O);ue.bindFramebuffer(F.READ_FRAMEBUFFER,Rg),ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ng);for(let ut=0;ut<be;ut++)os?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,yt.__webglTexture,H,ke+ut):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,yt.__webglTexture,H),ct?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,Si.__webglTexture,de,xt+ut):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Si.__webglTexture,de),H!==0?F.blitFramebuffer(Ee,Be,ve,fe,Me,st,ve,fe,F.COLOR_BUFFER_BIT,F.NEAREST):ct?F.copyTexSubImage3D(ge,de,Me,st,xt+ut,Ee,Be,ve,fe):F.copyTexSubImage2D(ge,de,Me,st,Ee,Be,ve,fe);ue.bindFramebuffer(F.READ_FRAMEBUFFER,null),ue.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else ct?A.isDataTexture||A.isData3DTexture?F.texSubImage3D(ge,de,Me,st,xt,ve,fe,be,ot,Xt,gt.data):O.isCompressedArrayTexture?F.compressedTexSubImage3D(ge,de,Me,st,xt,ve,fe,be,ot,gt.data):F.texSubImage3D(ge,de,Me,st,xt,ve,fe,be,ot,Xt,gt):A.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,de,Me,st,ve,fe,ot,Xt,gt.data):A.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,de,Me,st,gt.width,gt.height,ot,gt.data):F.texSubImage2D(F.TEXTURE_2D,de,Me,st,ve,fe,ot,Xt,gt);ue.pixelStorei(F.UNPACK_ROW_LENGTH,ln),ue.pixelStorei(F.UNPACK_IMAGE_HEIGHT,Ye),ue.pixelStorei(F.UNPACK_SKIP_PIXELS,pn),ue.pixelStorei(F.UNPACK_SKIP_ROWS,kn),ue.pixelStorei(F.UNPACK_SKIP_IMAGES,bi),de===0&&O.generateMipmaps&&F.generateMipmap(ge),ue.unbindTexture()},this.initRenderTarget=function(A){I.get(A).__webglFramebuffer===void 0&&S.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?S.setTextureCube(A,0):A.isData3DTexture?S.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?S.setTexture2DArray(A,0):S.setTexture2D(A,0),ue.unbindTexture()},this.resetState=function(){U=0,B=0,L=null,ue.reset(),ie.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Jn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;const t=this.getContext();t.drawingBufferColorSpace=Xe._getDrawingBufferColorSpace(e),t.unpackColorSpace=Xe._getUnpackColorSpace()}}function Cr(n){let e=!1;const t=[];for(let i=0;i<n.length;i++){let s=n.charAt(i);switch(s){case"_":e=!0;break;case"0":case"1":case"2":case"3":case"4":case"5":case"6":case"7":case"8":case"9":t.push(s),e=!1;break;default:e&&(e=!1,s=s.toUpperCase()),t.push(s);break}}return t.join("")}const uS=new Set(["constructor","toString","toJSON","valueOf"]);function Pr(n){return uS.has(n)?n+"$":n}function hS(){let n=0,e=0;for(let i=0;i<28;i+=7){let s=this.buf[this.pos++];if(n|=(s&127)<<i,(s&128)==0)return this.assertBounds(),[n,e]}let t=this.buf[this.pos++];if(n|=(t&15)<<28,e=(t&112)>>4,(t&128)==0)return this.assertBounds(),[n,e];for(let i=3;i<=31;i+=7){let s=this.buf[this.pos++];if(e|=(s&127)<<i,(s&128)==0)return this.assertBounds(),[n,e]}throw new Error("invalid varint")}function _c(n,e,t){for(let r=0;r<28;r=r+7){const a=n>>>r,o=!(!(a>>>7)&&e==0),c=(o?a|128:a)&255;if(t.push(c),!o)return}const i=n>>>28&15|(e&7)<<4,s=e>>3!=0;if(t.push((s?i|128:i)&255),!!s){for(let r=3;r<31;r=r+7){const a=e>>>r,o=!!(a>>>7),c=(o?a|128:a)&255;if(t.push(c),!o)return}t.push(e>>>31&1)}}const qa=4294967296;function pf(n){const e=n[0]==="-";e&&(n=n.slice(1));const t=1e6;let i=0,s=0;function r(a,o){const c=Number(n.slice(a,o));s*=t,i=i*t+c,i>=qa&&(s=s+(i/qa|0),i=i%qa)}return r(-24,-18),r(-18,-12),r(-12,-6),r(-6),e?sm(i,s):_u(i,s)}function fS(n,e){let t=_u(n,e);const i=t.hi&2147483648;i&&(t=sm(t.lo,t.hi));const s=im(t.lo,t.hi);return i?"-"+s:s}function im(n,e){if({lo:n,hi:e}=dS(n,e),e<=2097151)return String(qa*e+n);const t=n&16777215,i=(n>>>24|e<<8)&16777215,s=e>>16&65535;let r=t+i*6777216+s*6710656,a=i+s*8147497,o=s*2;const c=1e7;return r>=c&&(a+=Math.floor(r/c),r%=c),a>=c&&(o+=Math.floor(a/c),a%=c),o.toString()+mf(a)+mf(r)}function dS(n,e){return{lo:n>>>0,hi:e>>>0}}function _u(n,e){return{lo:n|0,hi:e|0}}function sm(n,e){return e=~e,n?n=~n+1:e+=1,_u(n,e)}const mf=n=>{const e=String(n);return"0000000".slice(e.length)+e};function gf(n,e){if(n>=0){for(;n>127;)e.push(n&127|128),n=n>>>7;e.push(n)}else{for(let t=0;t<9;t++)e.push(n&127|128),n=n>>7;e.push(1)}}function pS(){let n=this.buf[this.pos++],e=n&127;if((n&128)==0)return this.assertBounds(),e;if(n=this.buf[this.pos++],e|=(n&127)<<7,(n&128)==0)return this.assertBounds(),e;if(n=this.buf[this.pos++],e|=(n&127)<<14,(n&128)==0)return this.assertBounds(),e;if(n=this.buf[this.pos++],e|=(n&127)<<21,(n&128)==0)return this.assertBounds(),e;n=this.buf[this.pos++],e|=(n&15)<<28;for(let t=5;(n&128)!==0&&t<10;t++)n=this.buf[this.pos++];if((n&128)!=0)throw new Error("invalid varint");return this.assertBounds(),e>>>0}var _f={};const dt=mS();function mS(){const n=new DataView(new ArrayBuffer(8));if(typeof BigInt=="function"&&typeof n.getBigInt64=="function"&&typeof n.getBigUint64=="function"&&typeof n.setBigInt64=="function"&&typeof n.setBigUint64=="function"&&(typeof process!="object"||typeof _f!="object"||_f.BUF_BIGINT_DISABLE!=="1")){const t=BigInt("-9223372036854775808"),i=BigInt("9223372036854775807"),s=BigInt("0"),r=BigInt("18446744073709551615");return{zero:BigInt(0),supported:!0,parse(a){const o=typeof a=="bigint"?a:BigInt(a);if(o>i||o<t)throw new Error(`invalid int64: ${a}`);return o},uParse(a){const o=typeof a=="bigint"?a:BigInt(a);if(o>r||o<s)throw new Error(`invalid uint64: ${a}`);return o},enc(a){return n.setBigInt64(0,this.parse(a),!0),{lo:n.getInt32(0,!0),hi:n.getInt32(4,!0)}},uEnc(a){return n.setBigInt64(0,this.uParse(a),!0),{lo:n.getInt32(0,!0),hi:n.getInt32(4,!0)}},dec(a,o){return n.setInt32(0,a,!0),n.setInt32(4,o,!0),n.getBigInt64(0,!0)},uDec(a,o){return n.setInt32(0,a,!0),n.setInt32(4,o,!0),n.getBigUint64(0,!0)}}}return{zero:"0",supported:!1,parse(t){return typeof t!="string"&&(t=t.toString()),vf(t),t},uParse(t){return typeof t!="string"&&(t=t.toString()),xf(t),t},enc(t){return typeof t!="string"&&(t=t.toString()),vf(t),pf(t)},uEnc(t){return typeof t!="string"&&(t=t.toString()),xf(t),pf(t)},dec(t,i){return fS(t,i)},uDec(t,i){return im(t,i)}}}function vf(n){if(!/^-?[0-9]+$/.test(n))throw new Error("invalid int64: "+n)}function xf(n){if(!/^[0-9]+$/.test(n))throw new Error("invalid uint64: "+n)}var G;(function(n){n[n.DOUBLE=1]="DOUBLE",n[n.FLOAT=2]="FLOAT",n[n.INT64=3]="INT64",n[n.UINT64=4]="UINT64",n[n.INT32=5]="INT32",n[n.FIXED64=6]="FIXED64",n[n.FIXED32=7]="FIXED32",n[n.BOOL=8]="BOOL",n[n.STRING=9]="STRING",n[n.BYTES=12]="BYTES",n[n.UINT32=13]="UINT32",n[n.SFIXED32=15]="SFIXED32",n[n.SFIXED64=16]="SFIXED64",n[n.SINT32=17]="SINT32",n[n.SINT64=18]="SINT64"})(G||(G={}));function as(n,e){switch(n){case G.STRING:return"";case G.BOOL:return!1;case G.DOUBLE:case G.FLOAT:return 0;case G.INT64:case G.UINT64:case G.SFIXED64:case G.FIXED64:case G.SINT64:return e?"0":dt.zero;case G.BYTES:return new Uint8Array(0);default:return 0}}function gS(n,e){switch(n){case G.BOOL:return e===!1;case G.STRING:return e==="";case G.BYTES:return e instanceof Uint8Array&&!e.byteLength;default:return e==0}}const rm=2,ui=Symbol.for("reflect unsafe local");function am(n,e){const t=n[e.localName].case;return t===void 0?t:e.fields.find(i=>i.localName===t)}function _S(n,e){const t=e.localName;if(e.oneof)return n[e.oneof.localName].case===t;if(e.presence!=rm)return n[t]!==void 0&&Object.prototype.hasOwnProperty.call(n,t);switch(e.fieldKind){case"list":return n[t].length>0;case"map":return Object.keys(n[t]).length>0;case"scalar":return!gS(e.scalar,n[t]);case"enum":return n[t]!==e.enum.values[0].number}throw new Error("message field with implicit presence")}function Lr(n,e){return Object.prototype.hasOwnProperty.call(n,e)&&n[e]!==void 0}function om(n,e){if(e.oneof){const t=n[e.oneof.localName];return t.case===e.localName?t.value:void 0}return n[e.localName]}function cm(n,e,t){e.oneof?n[e.oneof.localName]={case:e.localName,value:t}:n[e.localName]=t}function vS(n,e){const t=e.localName;if(e.oneof){const i=e.oneof.localName;n[i].case===t&&(n[i]={case:void 0})}else if(e.presence!=rm)delete n[t];else switch(e.fieldKind){case"map":n[t]={};break;case"list":n[t]=[];break;case"enum":n[t]=e.enum.values[0].number;break;case"scalar":n[t]=as(e.scalar,e.longAsString);break}}function vu(n){for(const e of n.field)Lr(e,"jsonName")||(e.jsonName=Cr(e.name));n.nestedType.forEach(vu)}function xS(n,e){const t=n.values.find(i=>i.name===e);if(!t)throw new Error(`cannot parse ${n} default value: ${e}`);return t.number}function yS(n,e){switch(n){case G.STRING:return e;case G.BYTES:{const t=bS(e);if(t===!1)throw new Error(`cannot parse ${G[n]} default value: ${e}`);return t}case G.INT64:case G.SFIXED64:case G.SINT64:return dt.parse(e);case G.UINT64:case G.FIXED64:return dt.uParse(e);case G.DOUBLE:case G.FLOAT:switch(e){case"inf":return Number.POSITIVE_INFINITY;case"-inf":return Number.NEGATIVE_INFINITY;case"nan":return Number.NaN;default:return parseFloat(e)}case G.BOOL:return e==="true";case G.INT32:case G.UINT32:case G.SINT32:case G.FIXED32:case G.SFIXED32:return parseInt(e,10)}}function bS(n){const e=[],t={tail:n,c:"",next(){return this.tail.length==0?!1:(this.c=this.tail[0],this.tail=this.tail.substring(1),!0)},take(i){if(this.tail.length>=i){const s=this.tail.substring(0,i);return this.tail=this.tail.substring(i),s}return!1}};for(;t.next();)switch(t.c){case"\\":if(t.next())switch(t.c){case"\\":e.push(t.c.charCodeAt(0));break;case"b":e.push(8);break;case"f":e.push(12);break;case"n":e.push(10);break;case"r":e.push(13);break;case"t":e.push(9);break;case"v":e.push(11);break;case"0":case"1":case"2":case"3":case"4":case"5":case"6":case"7":{const i=t.c,s=t.take(2);if(s===!1)return!1;const r=parseInt(i+s,8);if(Number.isNaN(r))return!1;e.push(r);break}case"x":{const i=t.c,s=t.take(2);if(s===!1)return!1;const r=parseInt(i+s,16);if(Number.isNaN(r))return!1;e.push(r);break}case"u":{const i=t.c,s=t.take(4);if(s===!1)return!1;const r=parseInt(i+s,16);if(Number.isNaN(r))return!1;const a=new Uint8Array(4);new DataView(a.buffer).setInt32(0,r,!0),e.push(a[0],a[1],a[2],a[3]);break}case"U":{const i=t.c,s=t.take(8);if(s===!1)return!1;const r=dt.uEnc(i+s),a=new Uint8Array(8),o=new DataView(a.buffer);o.setInt32(0,r.lo,!0),o.setInt32(4,r.hi,!0),e.push(a[0],a[1],a[2],a[3],a[4],a[5],a[6],a[7]);break}}break;default:e.push(t.c.charCodeAt(0))}return new Uint8Array(e)}function*Vl(n){switch(n.kind){case"file":for(const e of n.messages)yield e,yield*Vl(e);yield*n.enums,yield*n.services,yield*n.extensions;break;case"message":for(const e of n.nestedMessages)yield e,yield*Vl(e);yield*n.nestedEnums,yield*n.nestedExtensions;break}}function lm(...n){const e=SS();if(!n.length)return e;if("$typeName"in n[0]&&n[0].$typeName=="google.protobuf.FileDescriptorSet"){for(const i of n[0].file)Ef(i,e);return e}if("$typeName"in n[0]){let a=function(o){const c=[];for(const l of o.dependency){if(e.getFile(l)!=null||r.has(l))continue;const u=s(l);if(!u)throw new Error(`Unable to resolve ${l}, imported by ${o.name}`);"kind"in u?e.addFile(u,!1,!0):(r.add(u.name),c.push(u))}return c.concat(...c.map(a))};var t=a;const i=n[0],s=n[1],r=new Set;for(const o of[i,...a(i)].reverse())Ef(o,e)}else for(const i of n)for(const s of i.files)e.addFile(s);return e}function SS(){const n=new Map,e=new Map,t=new Map;return{kind:"registry",types:n,extendees:e,[Symbol.iterator](){return n.values()},get files(){return t.values()},addFile(i,s,r){if(t.set(i.proto.name,i),!s)for(const a of Vl(i))this.add(a);if(r)for(const a of i.dependencies)this.addFile(a,s,r)},add(i){if(i.kind=="extension"){let s=e.get(i.extendee.typeName);s||e.set(i.extendee.typeName,s=new Map),s.set(i.number,i)}n.set(i.typeName,i)},get(i){return n.get(i)},getFile(i){return t.get(i)},getMessage(i){const s=n.get(i);return s?.kind=="message"?s:void 0},getEnum(i){const s=n.get(i);return s?.kind=="enum"?s:void 0},getExtension(i){const s=n.get(i);return s?.kind=="extension"?s:void 0},getExtensionFor(i,s){var r;return(r=e.get(i.typeName))===null||r===void 0?void 0:r.get(s)},getService(i){const s=n.get(i);return s?.kind=="service"?s:void 0}}}const ES=998,MS=999,AS=9,Dr=10,Sr=11,wS=12,yf=14,xu=3,TS=2,bf=1,RS=0,vc=1,Sf=2,NS=3,IS=1,CS=2,PS=1,um={998:{fieldPresence:1,enumType:2,repeatedFieldEncoding:2,utf8Validation:3,messageEncoding:1,jsonFormat:2,enforceNamingStyle:2,defaultSymbolVisibility:1},999:{fieldPresence:2,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:2,defaultSymbolVisibility:1},1e3:{fieldPresence:1,enumType:1,repeatedFieldEncoding:1,utf8Validation:2,messageEncoding:1,jsonFormat:1,enforceNamingStyle:2,defaultSymbolVisibility:1}};function Ef(n,e){var t,i;const s={kind:"file",proto:n,deprecated:(i=(t=n.options)===null||t===void 0?void 0:t.deprecated)!==null&&i!==void 0?i:!1,edition:FS(n),name:n.name.replace(/\.proto$/,""),dependencies:BS(n,e),enums:[],messages:[],extensions:[],services:[],toString(){return`file ${n.name}`}},r=new Map,a={get(o){return r.get(o)},add(o){var c;Ln(((c=o.proto.options)===null||c===void 0?void 0:c.mapEntry)===!0),r.set(o.typeName,o)}};for(const o of n.enumType)hm(o,s,void 0,e);for(const o of n.messageType)fm(o,s,void 0,e,a);for(const o of n.service)LS(o,s,e);kl(s,e);for(const o of r.values())Gl(o,e,a);for(const o of s.messages)Gl(o,e,a),kl(o,e);e.addFile(s,!0)}function kl(n,e){switch(n.kind){case"file":for(const t of n.proto.extension){const i=zl(t,n,e);n.extensions.push(i),e.add(i)}break;case"message":for(const t of n.proto.extension){const i=zl(t,n,e);n.nestedExtensions.push(i),e.add(i)}for(const t of n.nestedMessages)kl(t,e);break}}function Gl(n,e,t){const i=n.proto.oneofDecl.map(r=>US(r,n)),s=new Set;for(const r of n.proto.field){const a=kS(r,i),o=zl(r,n,e,a,t);n.fields.push(o),n.field[o.localName]=o,a===void 0?n.members.push(o):(a.fields.push(o),s.has(a)||(s.add(a),n.members.push(a)))}for(const r of i.filter(a=>s.has(a)))n.oneofs.push(r);for(const r of n.nestedMessages)Gl(r,e,t)}function hm(n,e,t,i){var s,r,a,o,c;const l=OS(n.name,n.value),u={kind:"enum",proto:n,deprecated:(r=(s=n.options)===null||s===void 0?void 0:s.deprecated)!==null&&r!==void 0?r:!1,file:e,parent:t,open:!0,name:n.name,typeName:Eo(n,t,e),value:{},values:[],sharedPrefix:l,toString(){return`enum ${this.typeName}`}};u.open=HS(u),i.add(u);for(const f of n.value){const h=f.name;u.values.push(u.value[f.number]={kind:"enum_value",proto:f,deprecated:(o=(a=f.options)===null||a===void 0?void 0:a.deprecated)!==null&&o!==void 0?o:!1,parent:u,name:h,localName:Pr(l==null?h:h.substring(l.length)),number:f.number,toString(){return`enum value ${u.typeName}.${h}`}})}((c=t?.nestedEnums)!==null&&c!==void 0?c:e.enums).push(u)}function fm(n,e,t,i,s){var r,a,o,c;const l={kind:"message",proto:n,deprecated:(a=(r=n.options)===null||r===void 0?void 0:r.deprecated)!==null&&a!==void 0?a:!1,file:e,parent:t,name:n.name,typeName:Eo(n,t,e),fields:[],field:{},oneofs:[],members:[],nestedEnums:[],nestedMessages:[],nestedExtensions:[],toString(){return`message ${this.typeName}`}};((o=n.options)===null||o===void 0?void 0:o.mapEntry)===!0?s.add(l):(((c=t?.nestedMessages)!==null&&c!==void 0?c:e.messages).push(l),i.add(l));for(const u of n.enumType)hm(u,e,l,i);for(const u of n.nestedType)fm(u,e,l,i,s)}function LS(n,e,t){var i,s;const r={kind:"service",proto:n,deprecated:(s=(i=n.options)===null||i===void 0?void 0:i.deprecated)!==null&&s!==void 0?s:!1,file:e,name:n.name,typeName:Eo(n,void 0,e),methods:[],method:{},toString(){return`service ${this.typeName}`}};e.services.push(r),t.add(r);for(const a of n.method){const o=DS(a,r,t);r.methods.push(o),r.method[o.localName]=o}}function DS(n,e,t){var i,s,r,a;let o;n.clientStreaming&&n.serverStreaming?o="bidi_streaming":n.clientStreaming?o="client_streaming":n.serverStreaming?o="server_streaming":o="unary";const c=t.getMessage(oi(n.inputType)),l=t.getMessage(oi(n.outputType));Ln(c,`invalid MethodDescriptorProto: input_type ${n.inputType} not found`),Ln(l,`invalid MethodDescriptorProto: output_type ${n.inputType} not found`);const u=n.name;return{kind:"rpc",proto:n,deprecated:(s=(i=n.options)===null||i===void 0?void 0:i.deprecated)!==null&&s!==void 0?s:!1,parent:e,name:u,localName:Pr(u.length?Pr(u[0].toLowerCase()+u.substring(1)):u),methodKind:o,input:c,output:l,idempotency:(a=(r=n.options)===null||r===void 0?void 0:r.idempotencyLevel)!==null&&a!==void 0?a:RS,toString(){return`rpc ${e.typeName}.${u}`}}}function US(n,e){return{kind:"oneof",proto:n,deprecated:!1,parent:e,fields:[],name:n.name,localName:Pr(Cr(n.name)),toString(){return`oneof ${e.typeName}.${this.name}`}}}function zl(n,e,t,i,s){var r,a,o;const c=s===void 0,l={kind:"field",proto:n,deprecated:(a=(r=n.options)===null||r===void 0?void 0:r.deprecated)!==null&&a!==void 0?a:!1,name:n.name,number:n.number,scalar:void 0,message:void 0,enum:void 0,presence:GS(n,i,c,e),listKind:void 0,mapKind:void 0,mapKey:void 0,delimitedEncoding:void 0,packed:void 0,longAsString:!1,getDefaultValue:void 0};if(c){const d=e.kind=="file"?e:e.file,g=e.kind=="file"?void 0:e,y=Eo(n,g,d);l.kind="extension",l.file=d,l.parent=g,l.oneof=void 0,l.typeName=y,l.jsonName=`[${y}]`,l.toString=()=>`extension ${y}`;const p=t.getMessage(oi(n.extendee));Ln(p,`invalid FieldDescriptorProto: extendee ${n.extendee} not found`),l.extendee=p}else{const d=e;Ln(d.kind=="message"),l.parent=d,l.oneof=i,l.localName=i?Cr(n.name):Pr(Cr(n.name)),l.jsonName=n.jsonName,l.toString=()=>`field ${d.typeName}.${n.name}`}const u=n.label,f=n.type,h=(o=n.options)===null||o===void 0?void 0:o.jstype;if(u===xu){const d=f==Sr?s?.get(oi(n.typeName)):void 0;if(d){l.fieldKind="map";const{key:g,value:y}=WS(d);return l.mapKey=g.scalar,l.mapKind=y.fieldKind,l.message=y.message,l.delimitedEncoding=!1,l.enum=y.enum,l.scalar=y.scalar,l}switch(l.fieldKind="list",f){case Sr:case Dr:l.listKind="message",l.message=t.getMessage(oi(n.typeName)),Ln(l.message),l.delimitedEncoding=Mf(n,e);break;case yf:l.listKind="enum",l.enum=t.getEnum(oi(n.typeName)),Ln(l.enum);break;default:l.listKind="scalar",l.scalar=f,l.longAsString=h==bf;break}return l.packed=zS(n,e),l}switch(f){case Sr:case Dr:l.fieldKind="message",l.message=t.getMessage(oi(n.typeName)),Ln(l.message,`invalid FieldDescriptorProto: type_name ${n.typeName} not found`),l.delimitedEncoding=Mf(n,e),l.getDefaultValue=()=>{};break;case yf:{const d=t.getEnum(oi(n.typeName));Ln(d!==void 0,`invalid FieldDescriptorProto: type_name ${n.typeName} not found`),l.fieldKind="enum",l.enum=t.getEnum(oi(n.typeName)),l.getDefaultValue=()=>Lr(n,"defaultValue")?xS(d,n.defaultValue):void 0;break}default:{l.fieldKind="scalar",l.scalar=f,l.longAsString=h==bf,l.getDefaultValue=()=>Lr(n,"defaultValue")?yS(f,n.defaultValue):void 0;break}}return l}function FS(n){switch(n.syntax){case"":case"proto2":return ES;case"proto3":return MS;case"editions":if(n.edition in um)return n.edition;throw new Error(`${n.name}: unsupported edition`);default:throw new Error(`${n.name}: unsupported syntax "${n.syntax}"`)}}function BS(n,e){return n.dependency.map(t=>{const i=e.getFile(t);if(!i)throw new Error(`Cannot find ${t}, imported by ${n.name}`);return i})}function OS(n,e){const t=VS(n)+"_";for(const i of e){if(!i.name.toLowerCase().startsWith(t))return;const s=i.name.substring(t.length);if(s.length==0||/^\d/.test(s))return}return t}function VS(n){return(n.substring(0,1)+n.substring(1).replace(/[A-Z]/g,e=>"_"+e)).toLowerCase()}function Eo(n,e,t){let i;return e?i=`${e.typeName}.${n.name}`:t.proto.package.length>0?i=`${t.proto.package}.${n.name}`:i=`${n.name}`,i}function oi(n){return n.startsWith(".")?n.substring(1):n}function kS(n,e){if(!Lr(n,"oneofIndex")||n.proto3Optional)return;const t=e[n.oneofIndex];return Ln(t,`invalid FieldDescriptorProto: oneof #${n.oneofIndex} for field #${n.number} not found`),t}function GS(n,e,t,i){if(n.label==TS)return NS;if(n.label==xu)return Sf;if(e||n.proto3Optional||t)return vc;const s=Xs("fieldPresence",{proto:n,parent:i});return s==Sf&&(n.type==Sr||n.type==Dr)?vc:s}function zS(n,e){if(n.label!=xu)return!1;switch(n.type){case AS:case wS:case Dr:case Sr:return!1}const t=n.options;return t&&Lr(t,"packed")?t.packed:IS==Xs("repeatedFieldEncoding",{proto:n,parent:e})}function WS(n){const e=n.fields.find(i=>i.number===1),t=n.fields.find(i=>i.number===2);return Ln(e&&e.fieldKind=="scalar"&&e.scalar!=G.BYTES&&e.scalar!=G.FLOAT&&e.scalar!=G.DOUBLE&&t&&t.fieldKind!="list"&&t.fieldKind!="map"),{key:e,value:t}}function HS(n){var e;return PS==Xs("enumType",{proto:n.proto,parent:(e=n.parent)!==null&&e!==void 0?e:n.file})}function Mf(n,e){return n.type==Dr?!0:CS==Xs("messageEncoding",{proto:n,parent:e})}function Xs(n,e){var t,i;const s=(t=e.proto.options)===null||t===void 0?void 0:t.features;if(s){const r=s[n];if(r!=0)return r}if("kind"in e){if(e.kind=="message")return Xs(n,(i=e.parent)!==null&&i!==void 0?i:e.file);const r=um[e.edition];if(!r)throw new Error(`feature default for edition ${e.edition} not found`);return r[n]}return Xs(n,e.parent)}function Ln(n,e){if(!n)throw new Error(e)}function XS(n){const e=ZS(n);return e.messageType.forEach(vu),lm(e,()=>{}).getFile(e.name)}function ZS(n){return Object.assign(Object.create({syntax:"",edition:0}),Object.assign(Object.assign({$typeName:"google.protobuf.FileDescriptorProto",dependency:[],publicDependency:[],weakDependency:[],optionDependency:[],service:[],extension:[]},n),{messageType:n.messageType.map(dm),enumType:n.enumType.map(pm)}))}function dm(n){var e,t,i,s,r,a,o,c;return Object.assign(Object.create({visibility:0}),{$typeName:"google.protobuf.DescriptorProto",name:n.name,field:(t=(e=n.field)===null||e===void 0?void 0:e.map(YS))!==null&&t!==void 0?t:[],extension:[],nestedType:(s=(i=n.nestedType)===null||i===void 0?void 0:i.map(dm))!==null&&s!==void 0?s:[],enumType:(a=(r=n.enumType)===null||r===void 0?void 0:r.map(pm))!==null&&a!==void 0?a:[],extensionRange:(c=(o=n.extensionRange)===null||o===void 0?void 0:o.map(u=>Object.assign({$typeName:"google.protobuf.DescriptorProto.ExtensionRange"},u)))!==null&&c!==void 0?c:[],oneofDecl:[],reservedRange:[],reservedName:[]})}function YS(n){return Object.assign(Object.create({label:1,typeName:"",extendee:"",defaultValue:"",oneofIndex:0,jsonName:"",proto3Optional:!1}),Object.assign(Object.assign({$typeName:"google.protobuf.FieldDescriptorProto"},n),{options:n.options?KS(n.options):void 0}))}function KS(n){var e,t,i;return Object.assign(Object.create({ctype:0,packed:!1,jstype:0,lazy:!1,unverifiedLazy:!1,deprecated:!1,weak:!1,debugRedact:!1,retention:0}),Object.assign(Object.assign({$typeName:"google.protobuf.FieldOptions"},n),{targets:(e=n.targets)!==null&&e!==void 0?e:[],editionDefaults:(i=(t=n.editionDefaults)===null||t===void 0?void 0:t.map(r=>Object.assign({$typeName:"google.protobuf.FieldOptions.EditionDefault"},r)))!==null&&i!==void 0?i:[],uninterpretedOption:[]}))}function pm(n){return Object.assign(Object.create({visibility:0}),{$typeName:"google.protobuf.EnumDescriptorProto",name:n.name,reservedName:[],reservedRange:[],value:n.value.map(t=>Object.assign({$typeName:"google.protobuf.EnumValueDescriptorProto"},t))})}function yu(n){const e=JS();let t=n.length*3/4;n[n.length-2]=="="?t-=2:n[n.length-1]=="="&&(t-=1);let i=new Uint8Array(t),s=0,r=0,a,o=0;for(let c=0;c<n.length;c++){if(a=e[n.charCodeAt(c)],a===void 0)switch(n[c]){case"=":r=0;case`
`:case"\r":case"	":case" ":continue;default:throw Error("invalid base64 string")}switch(r){case 0:o=a,r=1;break;case 1:i[s++]=o<<2|(a&48)>>4,o=a,r=2;break;case 2:i[s++]=(o&15)<<4|(a&60)>>2,o=a,r=3;break;case 3:i[s++]=(o&3)<<6|a,r=0;break}}if(r==1)throw Error("invalid base64 string");return i.subarray(0,s)}function $S(n,e="std"){const t=mm(e),i=e=="std";let s="",r=0,a,o=0;for(let c=0;c<n.length;c++)switch(a=n[c],r){case 0:s+=t[a>>2],o=(a&3)<<4,r=1;break;case 1:s+=t[o|a>>4],o=(a&15)<<2,r=2;break;case 2:s+=t[o|a>>6],s+=t[a&63],r=0;break}return r&&(s+=t[o],i&&(s+="=",r==1&&(s+="="))),s}let ba,Af,As;function mm(n){return ba||(ba="ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/".split(""),Af=ba.slice(0,-2).concat("-","_")),n=="url"?Af:ba}function JS(){if(!As){As=[];const n=mm("std");for(let e=0;e<n.length;e++)As[n[e].charCodeAt(0)]=e;As[45]=n.indexOf("+"),As[95]=n.indexOf("/")}return As}function bu(n,e){return n!==null&&typeof n=="object"&&"$typeName"in n&&typeof n.$typeName=="string"?e===void 0?!0:e.typeName===n.$typeName:!1}const jS=["FieldValueInvalidError","FieldListRangeError","ForeignFieldError"];class an extends Error{constructor(e,t,i="FieldValueInvalidError"){super(t),this.name=i,this.field=()=>e}}function qS(n){return n instanceof Error&&jS.includes(n.name)&&"field"in n&&typeof n.field=="function"}function Bi(n){return n!==null&&typeof n=="object"&&!Array.isArray(n)}function Su(n,e){var t,i,s,r;if(Bi(n)&&ui in n&&"add"in n&&"field"in n&&typeof n.field=="function"){if(e!==void 0){const a=e,o=n.field();return a.listKind==o.listKind&&a.scalar===o.scalar&&((t=a.message)===null||t===void 0?void 0:t.typeName)===((i=o.message)===null||i===void 0?void 0:i.typeName)&&((s=a.enum)===null||s===void 0?void 0:s.typeName)===((r=o.enum)===null||r===void 0?void 0:r.typeName)}return!0}return!1}function Eu(n,e){var t,i,s,r;if(Bi(n)&&ui in n&&"has"in n&&"field"in n&&typeof n.field=="function"){if(e!==void 0){const a=e,o=n.field();return a.mapKey===o.mapKey&&a.mapKind==o.mapKind&&a.scalar===o.scalar&&((t=a.message)===null||t===void 0?void 0:t.typeName)===((i=o.message)===null||i===void 0?void 0:i.typeName)&&((s=a.enum)===null||s===void 0?void 0:s.typeName)===((r=o.enum)===null||r===void 0?void 0:r.typeName)}return!0}return!1}function Mu(n,e){return Bi(n)&&ui in n&&"desc"in n&&Bi(n.desc)&&n.desc.kind==="message"&&(e===void 0||n.desc.typeName==e.typeName)}const xc=Symbol.for("@bufbuild/protobuf/text-encoding");function Au(){if(globalThis[xc]==null){const n=new globalThis.TextEncoder,e=new globalThis.TextDecoder;globalThis[xc]={encodeUtf8(t){return n.encode(t)},decodeUtf8(t){return e.decode(t)},checkUtf8(t){try{return encodeURIComponent(t),!0}catch{return!1}}}}return globalThis[xc]}var bt;(function(n){n[n.Varint=0]="Varint",n[n.Bit64=1]="Bit64",n[n.LengthDelimited=2]="LengthDelimited",n[n.StartGroup=3]="StartGroup",n[n.EndGroup=4]="EndGroup",n[n.Bit32=5]="Bit32"})(bt||(bt={}));const gm=34028234663852886e22,_m=-34028234663852886e22,vm=4294967295,xm=2147483647,ym=-2147483648;class wu{constructor(e=Au().encodeUtf8){this.encodeUtf8=e,this.stack=[],this.chunks=[],this.buf=[]}finish(){this.buf.length&&(this.chunks.push(new Uint8Array(this.buf)),this.buf=[]);let e=0;for(let s=0;s<this.chunks.length;s++)e+=this.chunks[s].length;let t=new Uint8Array(e),i=0;for(let s=0;s<this.chunks.length;s++)t.set(this.chunks[s],i),i+=this.chunks[s].length;return this.chunks=[],t}fork(){return this.stack.push({chunks:this.chunks,buf:this.buf}),this.chunks=[],this.buf=[],this}join(){let e=this.finish(),t=this.stack.pop();if(!t)throw new Error("invalid state, fork stack empty");return this.chunks=t.chunks,this.buf=t.buf,this.uint32(e.byteLength),this.raw(e)}tag(e,t){return this.uint32((e<<3|t)>>>0)}raw(e){return this.buf.length&&(this.chunks.push(new Uint8Array(this.buf)),this.buf=[]),this.chunks.push(e),this}uint32(e){for(wf(e);e>127;)this.buf.push(e&127|128),e=e>>>7;return this.buf.push(e),this}int32(e){return yc(e),gf(e,this.buf),this}bool(e){return this.buf.push(e?1:0),this}bytes(e){return this.uint32(e.byteLength),this.raw(e)}string(e){let t=this.encodeUtf8(e);return this.uint32(t.byteLength),this.raw(t)}float(e){QS(e);let t=new Uint8Array(4);return new DataView(t.buffer).setFloat32(0,e,!0),this.raw(t)}double(e){let t=new Uint8Array(8);return new DataView(t.buffer).setFloat64(0,e,!0),this.raw(t)}fixed32(e){wf(e);let t=new Uint8Array(4);return new DataView(t.buffer).setUint32(0,e,!0),this.raw(t)}sfixed32(e){yc(e);let t=new Uint8Array(4);return new DataView(t.buffer).setInt32(0,e,!0),this.raw(t)}sint32(e){return yc(e),e=(e<<1^e>>31)>>>0,gf(e,this.buf),this}sfixed64(e){let t=new Uint8Array(8),i=new DataView(t.buffer),s=dt.enc(e);return i.setInt32(0,s.lo,!0),i.setInt32(4,s.hi,!0),this.raw(t)}fixed64(e){let t=new Uint8Array(8),i=new DataView(t.buffer),s=dt.uEnc(e);return i.setInt32(0,s.lo,!0),i.setInt32(4,s.hi,!0),this.raw(t)}int64(e){let t=dt.enc(e);return _c(t.lo,t.hi,this.buf),this}sint64(e){const t=dt.enc(e),i=t.hi>>31,s=t.lo<<1^i,r=(t.hi<<1|t.lo>>>31)^i;return _c(s,r,this.buf),this}uint64(e){const t=dt.uEnc(e);return _c(t.lo,t.hi,this.buf),this}}class Tu{constructor(e,t=Au().decodeUtf8){this.decodeUtf8=t,this.varint64=hS,this.uint32=pS,this.buf=e,this.len=e.length,this.pos=0,this.view=new DataView(e.buffer,e.byteOffset,e.byteLength)}tag(){let e=this.uint32(),t=e>>>3,i=e&7;if(t<=0||i<0||i>5)throw new Error("illegal tag: field no "+t+" wire type "+i);return[t,i]}skip(e,t){let i=this.pos;switch(e){case bt.Varint:for(;this.buf[this.pos++]&128;);break;case bt.Bit64:this.pos+=4;case bt.Bit32:this.pos+=4;break;case bt.LengthDelimited:let s=this.uint32();this.pos+=s;break;case bt.StartGroup:for(;;){const[r,a]=this.tag();if(a===bt.EndGroup){if(t!==void 0&&r!==t)throw new Error("invalid end group tag");break}this.skip(a,r)}break;default:throw new Error("cant skip wire type "+e)}return this.assertBounds(),this.buf.subarray(i,this.pos)}assertBounds(){if(this.pos>this.len)throw new RangeError("premature EOF")}int32(){return this.uint32()|0}sint32(){let e=this.uint32();return e>>>1^-(e&1)}int64(){return dt.dec(...this.varint64())}uint64(){return dt.uDec(...this.varint64())}sint64(){let[e,t]=this.varint64(),i=-(e&1);return e=(e>>>1|(t&1)<<31)^i,t=t>>>1^i,dt.dec(e,t)}bool(){let[e,t]=this.varint64();return e!==0||t!==0}fixed32(){return this.view.getUint32((this.pos+=4)-4,!0)}sfixed32(){return this.view.getInt32((this.pos+=4)-4,!0)}fixed64(){return dt.uDec(this.sfixed32(),this.sfixed32())}sfixed64(){return dt.dec(this.sfixed32(),this.sfixed32())}float(){return this.view.getFloat32((this.pos+=4)-4,!0)}double(){return this.view.getFloat64((this.pos+=8)-8,!0)}bytes(){let e=this.uint32(),t=this.pos;return this.pos+=e,this.assertBounds(),this.buf.subarray(t,t+e)}string(){return this.decodeUtf8(this.bytes())}}function yc(n){if(typeof n=="string")n=Number(n);else if(typeof n!="number")throw new Error("invalid int32: "+typeof n);if(!Number.isInteger(n)||n>xm||n<ym)throw new Error("invalid int32: "+n)}function wf(n){if(typeof n=="string")n=Number(n);else if(typeof n!="number")throw new Error("invalid uint32: "+typeof n);if(!Number.isInteger(n)||n>vm||n<0)throw new Error("invalid uint32: "+n)}function QS(n){if(typeof n=="string"){const e=n;if(n=Number(n),Number.isNaN(n)&&e!=="NaN")throw new Error("invalid float32: "+e)}else if(typeof n!="number")throw new Error("invalid float32: "+typeof n);if(Number.isFinite(n)&&(n>gm||n<_m))throw new Error("invalid float32: "+n)}function Ki(n,e){const t=n.fieldKind=="list"?Su(e,n):n.fieldKind=="map"?Eu(e,n):Ru(n,e);if(t===!0)return;let i;switch(n.fieldKind){case"list":i=`expected ${Em(n)}, got ${Bt(e)}`;break;case"map":i=`expected ${Mm(n)}, got ${Bt(e)}`;break;default:i=uo(n,e,t)}return new an(n,i)}function Tf(n,e,t){const i=Ru(n,t);if(i!==!0)return new an(n,`list item #${e+1}: ${uo(n,t,i)}`)}function eE(n,e,t){const i=bm(e,n.mapKey);if(i!==!0)return new an(n,`invalid map key: ${uo({scalar:n.mapKey},e,i)}`);const s=Ru(n,t);if(s!==!0)return new an(n,`map entry ${Bt(e)}: ${uo(n,t,s)}`)}function Ru(n,e){return n.scalar!==void 0?bm(e,n.scalar):n.enum!==void 0?n.enum.open?Number.isInteger(e):n.enum.values.some(t=>t.number===e):Mu(e,n.message)}function bm(n,e){switch(e){case G.DOUBLE:return typeof n=="number";case G.FLOAT:return typeof n!="number"?!1:Number.isNaN(n)||!Number.isFinite(n)?!0:n>gm||n<_m?`${n.toFixed()} out of range`:!0;case G.INT32:case G.SFIXED32:case G.SINT32:return typeof n!="number"||!Number.isInteger(n)?!1:n>xm||n<ym?`${n.toFixed()} out of range`:!0;case G.FIXED32:case G.UINT32:return typeof n!="number"||!Number.isInteger(n)?!1:n>vm||n<0?`${n.toFixed()} out of range`:!0;case G.BOOL:return typeof n=="boolean";case G.STRING:return typeof n!="string"?!1:Au().checkUtf8(n)||"invalid UTF8";case G.BYTES:return n instanceof Uint8Array;case G.INT64:case G.SFIXED64:case G.SINT64:if(typeof n=="bigint"||typeof n=="number"||typeof n=="string"&&n.length>0)try{return dt.parse(n),!0}catch{return`${n} out of range`}return!1;case G.FIXED64:case G.UINT64:if(typeof n=="bigint"||typeof n=="number"||typeof n=="string"&&n.length>0)try{return dt.uParse(n),!0}catch{return`${n} out of range`}return!1}}function uo(n,e,t){return t=typeof t=="string"?`: ${t}`:`, got ${Bt(e)}`,n.scalar!==void 0?`expected ${tE(n.scalar)}`+t:n.enum!==void 0?`expected ${n.enum.toString()}`+t:`expected ${Sm(n.message)}`+t}function Bt(n){switch(typeof n){case"object":return n===null?"null":n instanceof Uint8Array?`Uint8Array(${n.length})`:Array.isArray(n)?`Array(${n.length})`:Su(n)?Em(n.field()):Eu(n)?Mm(n.field()):Mu(n)?Sm(n.desc):bu(n)?`message ${n.$typeName}`:"object";case"string":return n.length>30?"string":`"${n.split('"').join('\\"')}"`;case"boolean":return String(n);case"number":return String(n);case"bigint":return String(n)+"n";default:return typeof n}}function Sm(n){return`ReflectMessage (${n.typeName})`}function Em(n){switch(n.listKind){case"message":return`ReflectList (${n.message.toString()})`;case"enum":return`ReflectList (${n.enum.toString()})`;case"scalar":return`ReflectList (${G[n.scalar]})`}}function Mm(n){switch(n.mapKind){case"message":return`ReflectMap (${G[n.mapKey]}, ${n.message.toString()})`;case"enum":return`ReflectMap (${G[n.mapKey]}, ${n.enum.toString()})`;case"scalar":return`ReflectMap (${G[n.mapKey]}, ${G[n.scalar]})`}}function tE(n){switch(n){case G.STRING:return"string";case G.BOOL:return"boolean";case G.INT64:case G.SINT64:case G.SFIXED64:return"bigint (int64)";case G.UINT64:case G.FIXED64:return"bigint (uint64)";case G.BYTES:return"Uint8Array";case G.DOUBLE:return"number (float64)";case G.FLOAT:return"number (float32)";case G.FIXED32:case G.UINT32:return"number (uint32)";case G.INT32:case G.SFIXED32:case G.SINT32:return"number (int32)"}}function nE(n){return Am(n.$typeName)}function zr(n){const e=n.fields[0];return Am(n.typeName)&&e!==void 0&&e.fieldKind=="scalar"&&e.name=="value"&&e.number==1}function Am(n){return n.startsWith("google.protobuf.")&&["DoubleValue","FloatValue","Int64Value","UInt64Value","Int32Value","UInt32Value","BoolValue","StringValue","BytesValue"].includes(n.substring(16))}const iE=999,sE=998,Qa=2;function dn(n,e){if(bu(e,n))return e;const t=lE(n);return e!==void 0&&rE(n,t,e),t}function rE(n,e,t){for(const i of n.members){let s=t[i.localName];if(s==null)continue;let r;if(i.kind=="oneof"){const a=am(t,i);if(!a)continue;r=a,s=om(t,a)}else r=i;switch(r.fieldKind){case"message":s=Nu(r,s);break;case"scalar":s=wm(r,s);break;case"list":s=oE(r,s);break;case"map":s=aE(r,s);break}cm(e,r,s)}return e}function wm(n,e){return n.scalar==G.BYTES?Iu(e):e}function aE(n,e){if(Bi(e)){if(n.scalar==G.BYTES)return Rf(e,Iu);if(n.mapKind=="message")return Rf(e,t=>Nu(n,t))}return e}function oE(n,e){if(Array.isArray(e)){if(n.scalar==G.BYTES)return e.map(Iu);if(n.listKind=="message")return e.map(t=>Nu(n,t))}return e}function Nu(n,e){if(n.fieldKind=="message"&&!n.oneof&&zr(n.message))return wm(n.message.fields[0],e);if(Bi(e)){if(n.message.typeName=="google.protobuf.Struct"&&n.parent.typeName!=="google.protobuf.Value")return e;if(!bu(e,n.message))return dn(n.message,e)}return e}function Iu(n){return Array.isArray(n)?new Uint8Array(n):n}function Rf(n,e){const t={};for(const i of Object.entries(n))t[i[0]]=e(i[1]);return t}const cE=Symbol(),Nf=new WeakMap;function lE(n){let e;if(uE(n)){const t=Nf.get(n);let i,s;if(t)({prototype:i,members:s}=t);else{i={},s=new Set;for(const r of n.members)r.kind!="oneof"&&(r.fieldKind!="scalar"&&r.fieldKind!="enum"||r.presence!=Qa&&(s.add(r),i[r.localName]=bc(r)));Nf.set(n,{prototype:i,members:s})}e=Object.create(i),e.$typeName=n.typeName;for(const r of n.members)s.has(r)||r.kind=="field"&&(r.fieldKind=="message"||(r.fieldKind=="scalar"||r.fieldKind=="enum")&&r.presence!=Qa)||(e[r.localName]=bc(r))}else{e={$typeName:n.typeName};for(const t of n.members)(t.kind=="oneof"||t.presence==Qa)&&(e[t.localName]=bc(t))}return e}function uE(n){switch(n.file.edition){case iE:return!1;case sE:return!0;default:return n.fields.some(e=>e.presence!=Qa&&e.fieldKind!="message"&&!e.oneof)}}function bc(n){if(n.kind=="oneof")return{case:void 0};if(n.fieldKind=="list")return[];if(n.fieldKind=="map")return{};if(n.fieldKind=="message")return cE;const e=n.getDefaultValue();return e!==void 0?n.fieldKind=="scalar"&&n.longAsString?e.toString():e:n.fieldKind=="scalar"?as(n.scalar,n.longAsString):n.enum.values[0].number}function Tn(n,e,t=!0){return new Tm(n,e,t)}class Tm{get sortedFields(){var e;return(e=this._sortedFields)!==null&&e!==void 0?e:this._sortedFields=this.desc.fields.concat().sort((t,i)=>t.number-i.number)}constructor(e,t,i=!0){this.lists=new Map,this.maps=new Map,this.check=i,this.desc=e,this.message=this[ui]=t??dn(e),this.fields=e.fields,this.oneofs=e.oneofs,this.members=e.members}findNumber(e){return this._fieldsByNumber||(this._fieldsByNumber=new Map(this.desc.fields.map(t=>[t.number,t]))),this._fieldsByNumber.get(e)}oneofCase(e){return or(this.message,e),am(this.message,e)}isSet(e){return or(this.message,e),_S(this.message,e)}clear(e){or(this.message,e),vS(this.message,e)}get(e){or(this.message,e);const t=om(this.message,e);switch(e.fieldKind){case"list":let i=this.lists.get(e);return(!i||i[ui]!==t)&&this.lists.set(e,i=new hE(e,t,this.check)),i;case"map":let s=this.maps.get(e);return(!s||s[ui]!==t)&&this.maps.set(e,s=new fE(e,t,this.check)),s;case"message":return Pu(e,t,this.check);case"scalar":return t===void 0?as(e.scalar,!1):Lu(e,t);case"enum":return t??e.enum.values[0].number}}set(e,t){if(or(this.message,e),this.check){const s=Ki(e,t);if(s)throw s}let i;e.fieldKind=="message"?i=Cu(e,t):Eu(t)||Su(t)?i=t[ui]:i=Du(e,t),cm(this.message,e,i)}getUnknown(){return this.message.$unknown}setUnknown(e){this.message.$unknown=e}}function or(n,e){if(e.parent.typeName!==n.$typeName)throw new an(e,`cannot use ${e.toString()} with message ${n.$typeName}`,"ForeignFieldError")}class hE{field(){return this._field}get size(){return this._arr.length}constructor(e,t,i){this._field=e,this._arr=this[ui]=t,this.check=i}get(e){const t=this._arr[e];return t===void 0?void 0:Sc(this._field,t,this.check)}set(e,t){if(e<0||e>=this._arr.length)throw new an(this._field,`list item #${e+1}: out of range`);if(this.check){const i=Tf(this._field,e,t);if(i)throw i}this._arr[e]=If(this._field,t)}add(e){if(this.check){const t=Tf(this._field,this._arr.length,e);if(t)throw t}this._arr.push(If(this._field,e))}clear(){this._arr.splice(0,this._arr.length)}[Symbol.iterator](){return this.values()}keys(){return this._arr.keys()}*values(){for(const e of this._arr)yield Sc(this._field,e,this.check)}*entries(){for(let e=0;e<this._arr.length;e++)yield[e,Sc(this._field,this._arr[e],this.check)]}}class fE{constructor(e,t,i=!0){this.obj=this[ui]=t??{},this.check=i,this._field=e}field(){return this._field}set(e,t){if(this.check){const i=eE(this._field,e,t);if(i)throw i}return this.obj[Sa(e)]=dE(this._field,t),this}delete(e){const t=Sa(e),i=Object.prototype.hasOwnProperty.call(this.obj,t);return i&&delete this.obj[t],i}clear(){for(const e of Object.keys(this.obj))delete this.obj[e]}get(e){let t=this.obj[Sa(e)];return t!==void 0&&(t=Ec(this._field,t,this.check)),t}has(e){return Object.prototype.hasOwnProperty.call(this.obj,Sa(e))}*keys(){for(const e of Object.keys(this.obj))yield Cf(e,this._field.mapKey)}*entries(){for(const e of Object.entries(this.obj))yield[Cf(e[0],this._field.mapKey),Ec(this._field,e[1],this.check)]}[Symbol.iterator](){return this.entries()}get size(){return Object.keys(this.obj).length}*values(){for(const e of Object.values(this.obj))yield Ec(this._field,e,this.check)}forEach(e,t){for(const i of this.entries())e.call(t,i[1],i[0],this)}}function Cu(n,e){return Mu(e)?nE(e.message)&&!n.oneof&&n.fieldKind=="message"?e.message.value:e.desc.typeName=="google.protobuf.Struct"&&n.parent.typeName!="google.protobuf.Value"?Nm(e.message):e.message:e}function Pu(n,e,t){return e!==void 0&&(zr(n.message)&&!n.oneof&&n.fieldKind=="message"?e={$typeName:n.message.typeName,value:Lu(n.message.fields[0],e)}:n.message.typeName=="google.protobuf.Struct"&&n.parent.typeName!="google.protobuf.Value"&&Bi(e)&&(e=Rm(e))),new Tm(n.message,e,t)}function If(n,e){return n.listKind=="message"?Cu(n,e):Du(n,e)}function Sc(n,e,t){return n.listKind=="message"?Pu(n,e,t):Lu(n,e)}function dE(n,e){return n.mapKind=="message"?Cu(n,e):Du(n,e)}function Ec(n,e,t){return n.mapKind=="message"?Pu(n,e,t):e}function Sa(n){return typeof n=="string"||typeof n=="number"?n:String(n)}function Cf(n,e){switch(e){case G.STRING:return n;case G.INT32:case G.FIXED32:case G.UINT32:case G.SFIXED32:case G.SINT32:{const t=Number.parseInt(n);if(Number.isFinite(t))return t;break}case G.BOOL:switch(n){case"true":return!0;case"false":return!1}break;case G.UINT64:case G.FIXED64:try{return dt.uParse(n)}catch{}break;default:try{return dt.parse(n)}catch{}break}return n}function Lu(n,e){switch(n.scalar){case G.INT64:case G.SFIXED64:case G.SINT64:"longAsString"in n&&n.longAsString&&typeof e=="string"&&(e=dt.parse(e));break;case G.FIXED64:case G.UINT64:"longAsString"in n&&n.longAsString&&typeof e=="string"&&(e=dt.uParse(e));break}return e}function Du(n,e){switch(n.scalar){case G.INT64:case G.SFIXED64:case G.SINT64:"longAsString"in n&&n.longAsString?e=String(e):(typeof e=="string"||typeof e=="number")&&(e=dt.parse(e));break;case G.FIXED64:case G.UINT64:"longAsString"in n&&n.longAsString?e=String(e):(typeof e=="string"||typeof e=="number")&&(e=dt.uParse(e));break}return e}function Rm(n){const e={$typeName:"google.protobuf.Struct",fields:{}};if(Bi(n))for(const[t,i]of Object.entries(n))e.fields[t]=Cm(i);return e}function Nm(n){const e={};for(const[t,i]of Object.entries(n.fields))e[t]=Im(i);return e}function Im(n){switch(n.kind.case){case"structValue":return Nm(n.kind.value);case"listValue":return n.kind.value.values.map(Im);case"nullValue":case void 0:return null;default:return n.kind.value}}function Cm(n){const e={$typeName:"google.protobuf.Value",kind:{case:void 0}};switch(typeof n){case"number":e.kind={case:"numberValue",value:n};break;case"string":e.kind={case:"stringValue",value:n};break;case"boolean":e.kind={case:"boolValue",value:n};break;case"object":if(n===null)e.kind={case:"nullValue",value:0};else if(Array.isArray(n)){const t={$typeName:"google.protobuf.ListValue",values:[]};if(Array.isArray(n))for(const i of n)t.values.push(Cm(i));e.kind={case:"listValue",value:t}}else e.kind={case:"structValue",value:Rm(n)};break}return e}const pE=3,Pf={writeUnknownFields:!0};function mE(n){return n?Object.assign(Object.assign({},Pf),n):Pf}function Uu(n,e,t){return ho(new wu,mE(t),Tn(n,e)).finish()}function ho(n,e,t){var i;for(const s of t.sortedFields){if(!t.isSet(s)){if(s.presence==pE)throw new Error(`cannot encode ${s} to binary: required field not set`);continue}Pm(n,e,t,s)}if(e.writeUnknownFields)for(const{no:s,wireType:r,data:a}of(i=t.getUnknown())!==null&&i!==void 0?i:[])n.tag(s,r).raw(a);return n}function Pm(n,e,t,i){var s;switch(i.fieldKind){case"scalar":case"enum":fo(n,t.desc.typeName,i.name,(s=i.scalar)!==null&&s!==void 0?s:G.INT32,i.number,t.get(i));break;case"list":gE(n,e,i,t.get(i));break;case"message":Lm(n,e,i,t.get(i));break;case"map":for(const[r,a]of t.get(i))_E(n,e,i,r,a);break}}function fo(n,e,t,i,s,r){Dm(n.tag(s,vE(i)),e,t,i,r)}function Lm(n,e,t,i){t.delimitedEncoding?ho(n.tag(t.number,bt.StartGroup),e,i).tag(t.number,bt.EndGroup):ho(n.tag(t.number,bt.LengthDelimited).fork(),e,i).join()}function gE(n,e,t,i){var s;if(t.listKind=="message"){for(const a of i)Lm(n,e,t,a);return}const r=(s=t.scalar)!==null&&s!==void 0?s:G.INT32;if(t.packed){if(!i.size)return;n.tag(t.number,bt.LengthDelimited).fork();for(const a of i)Dm(n,t.parent.typeName,t.name,r,a);n.join();return}for(const a of i)fo(n,t.parent.typeName,t.name,r,t.number,a)}function _E(n,e,t,i,s){var r;switch(n.tag(t.number,bt.LengthDelimited).fork(),fo(n,t.parent.typeName,t.name,t.mapKey,1,i),t.mapKind){case"scalar":case"enum":fo(n,t.parent.typeName,t.name,(r=t.scalar)!==null&&r!==void 0?r:G.INT32,2,s);break;case"message":ho(n.tag(2,bt.LengthDelimited).fork(),e,s).join();break}n.join()}function Dm(n,e,t,i,s){try{switch(i){case G.STRING:n.string(s);break;case G.BOOL:n.bool(s);break;case G.DOUBLE:n.double(s);break;case G.FLOAT:n.float(s);break;case G.INT32:n.int32(s);break;case G.INT64:n.int64(s);break;case G.UINT64:n.uint64(s);break;case G.FIXED64:n.fixed64(s);break;case G.BYTES:n.bytes(s);break;case G.FIXED32:n.fixed32(s);break;case G.SFIXED32:n.sfixed32(s);break;case G.SFIXED64:n.sfixed64(s);break;case G.SINT64:n.sint64(s);break;case G.UINT32:n.uint32(s);break;case G.SINT32:n.sint32(s);break}}catch(r){throw r instanceof Error?new Error(`cannot encode field ${e}.${t} to binary: ${r.message}`):r}}function vE(n){switch(n){case G.BYTES:case G.STRING:return bt.LengthDelimited;case G.DOUBLE:case G.FIXED64:case G.SFIXED64:return bt.Bit64;case G.FIXED32:case G.SFIXED32:case G.FLOAT:return bt.Bit32;default:return bt.Varint}}function vi(n,e,...t){return t.reduce((i,s)=>i.nestedMessages[s],n.messages[e])}const xE=XS({name:"google/protobuf/descriptor.proto",package:"google.protobuf",messageType:[{name:"FileDescriptorSet",field:[{name:"file",number:1,type:11,label:3,typeName:".google.protobuf.FileDescriptorProto"}],extensionRange:[{start:536e6,end:536000001}]},{name:"FileDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"package",number:2,type:9,label:1},{name:"dependency",number:3,type:9,label:3},{name:"public_dependency",number:10,type:5,label:3},{name:"weak_dependency",number:11,type:5,label:3},{name:"option_dependency",number:15,type:9,label:3},{name:"message_type",number:4,type:11,label:3,typeName:".google.protobuf.DescriptorProto"},{name:"enum_type",number:5,type:11,label:3,typeName:".google.protobuf.EnumDescriptorProto"},{name:"service",number:6,type:11,label:3,typeName:".google.protobuf.ServiceDescriptorProto"},{name:"extension",number:7,type:11,label:3,typeName:".google.protobuf.FieldDescriptorProto"},{name:"options",number:8,type:11,label:1,typeName:".google.protobuf.FileOptions"},{name:"source_code_info",number:9,type:11,label:1,typeName:".google.protobuf.SourceCodeInfo"},{name:"syntax",number:12,type:9,label:1},{name:"edition",number:14,type:14,label:1,typeName:".google.protobuf.Edition"}]},{name:"DescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"field",number:2,type:11,label:3,typeName:".google.protobuf.FieldDescriptorProto"},{name:"extension",number:6,type:11,label:3,typeName:".google.protobuf.FieldDescriptorProto"},{name:"nested_type",number:3,type:11,label:3,typeName:".google.protobuf.DescriptorProto"},{name:"enum_type",number:4,type:11,label:3,typeName:".google.protobuf.EnumDescriptorProto"},{name:"extension_range",number:5,type:11,label:3,typeName:".google.protobuf.DescriptorProto.ExtensionRange"},{name:"oneof_decl",number:8,type:11,label:3,typeName:".google.protobuf.OneofDescriptorProto"},{name:"options",number:7,type:11,label:1,typeName:".google.protobuf.MessageOptions"},{name:"reserved_range",number:9,type:11,label:3,typeName:".google.protobuf.DescriptorProto.ReservedRange"},{name:"reserved_name",number:10,type:9,label:3},{name:"visibility",number:11,type:14,label:1,typeName:".google.protobuf.SymbolVisibility"}],nestedType:[{name:"ExtensionRange",field:[{name:"start",number:1,type:5,label:1},{name:"end",number:2,type:5,label:1},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.ExtensionRangeOptions"}]},{name:"ReservedRange",field:[{name:"start",number:1,type:5,label:1},{name:"end",number:2,type:5,label:1}]}]},{name:"ExtensionRangeOptions",field:[{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"},{name:"declaration",number:2,type:11,label:3,typeName:".google.protobuf.ExtensionRangeOptions.Declaration",options:{retention:2}},{name:"features",number:50,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"verification",number:3,type:14,label:1,typeName:".google.protobuf.ExtensionRangeOptions.VerificationState",defaultValue:"UNVERIFIED",options:{retention:2}}],nestedType:[{name:"Declaration",field:[{name:"number",number:1,type:5,label:1},{name:"full_name",number:2,type:9,label:1},{name:"type",number:3,type:9,label:1},{name:"reserved",number:5,type:8,label:1},{name:"repeated",number:6,type:8,label:1}]}],enumType:[{name:"VerificationState",value:[{name:"DECLARATION",number:0},{name:"UNVERIFIED",number:1}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"FieldDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"number",number:3,type:5,label:1},{name:"label",number:4,type:14,label:1,typeName:".google.protobuf.FieldDescriptorProto.Label"},{name:"type",number:5,type:14,label:1,typeName:".google.protobuf.FieldDescriptorProto.Type"},{name:"type_name",number:6,type:9,label:1},{name:"extendee",number:2,type:9,label:1},{name:"default_value",number:7,type:9,label:1},{name:"oneof_index",number:9,type:5,label:1},{name:"json_name",number:10,type:9,label:1},{name:"options",number:8,type:11,label:1,typeName:".google.protobuf.FieldOptions"},{name:"proto3_optional",number:17,type:8,label:1}],enumType:[{name:"Type",value:[{name:"TYPE_DOUBLE",number:1},{name:"TYPE_FLOAT",number:2},{name:"TYPE_INT64",number:3},{name:"TYPE_UINT64",number:4},{name:"TYPE_INT32",number:5},{name:"TYPE_FIXED64",number:6},{name:"TYPE_FIXED32",number:7},{name:"TYPE_BOOL",number:8},{name:"TYPE_STRING",number:9},{name:"TYPE_GROUP",number:10},{name:"TYPE_MESSAGE",number:11},{name:"TYPE_BYTES",number:12},{name:"TYPE_UINT32",number:13},{name:"TYPE_ENUM",number:14},{name:"TYPE_SFIXED32",number:15},{name:"TYPE_SFIXED64",number:16},{name:"TYPE_SINT32",number:17},{name:"TYPE_SINT64",number:18}]},{name:"Label",value:[{name:"LABEL_OPTIONAL",number:1},{name:"LABEL_REPEATED",number:3},{name:"LABEL_REQUIRED",number:2}]}]},{name:"OneofDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"options",number:2,type:11,label:1,typeName:".google.protobuf.OneofOptions"}]},{name:"EnumDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"value",number:2,type:11,label:3,typeName:".google.protobuf.EnumValueDescriptorProto"},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.EnumOptions"},{name:"reserved_range",number:4,type:11,label:3,typeName:".google.protobuf.EnumDescriptorProto.EnumReservedRange"},{name:"reserved_name",number:5,type:9,label:3},{name:"visibility",number:6,type:14,label:1,typeName:".google.protobuf.SymbolVisibility"}],nestedType:[{name:"EnumReservedRange",field:[{name:"start",number:1,type:5,label:1},{name:"end",number:2,type:5,label:1}]}]},{name:"EnumValueDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"number",number:2,type:5,label:1},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.EnumValueOptions"}]},{name:"ServiceDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"method",number:2,type:11,label:3,typeName:".google.protobuf.MethodDescriptorProto"},{name:"options",number:3,type:11,label:1,typeName:".google.protobuf.ServiceOptions"}]},{name:"MethodDescriptorProto",field:[{name:"name",number:1,type:9,label:1},{name:"input_type",number:2,type:9,label:1},{name:"output_type",number:3,type:9,label:1},{name:"options",number:4,type:11,label:1,typeName:".google.protobuf.MethodOptions"},{name:"client_streaming",number:5,type:8,label:1,defaultValue:"false"},{name:"server_streaming",number:6,type:8,label:1,defaultValue:"false"}]},{name:"FileOptions",field:[{name:"java_package",number:1,type:9,label:1},{name:"java_outer_classname",number:8,type:9,label:1},{name:"java_multiple_files",number:10,type:8,label:1,defaultValue:"false"},{name:"java_generate_equals_and_hash",number:20,type:8,label:1,options:{deprecated:!0}},{name:"java_string_check_utf8",number:27,type:8,label:1,defaultValue:"false"},{name:"optimize_for",number:9,type:14,label:1,typeName:".google.protobuf.FileOptions.OptimizeMode",defaultValue:"SPEED"},{name:"go_package",number:11,type:9,label:1},{name:"cc_generic_services",number:16,type:8,label:1,defaultValue:"false"},{name:"java_generic_services",number:17,type:8,label:1,defaultValue:"false"},{name:"py_generic_services",number:18,type:8,label:1,defaultValue:"false"},{name:"deprecated",number:23,type:8,label:1,defaultValue:"false"},{name:"cc_enable_arenas",number:31,type:8,label:1,defaultValue:"true"},{name:"objc_class_prefix",number:36,type:9,label:1},{name:"csharp_namespace",number:37,type:9,label:1},{name:"swift_prefix",number:39,type:9,label:1},{name:"php_class_prefix",number:40,type:9,label:1},{name:"php_namespace",number:41,type:9,label:1},{name:"php_metadata_namespace",number:44,type:9,label:1},{name:"ruby_package",number:45,type:9,label:1},{name:"features",number:50,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],enumType:[{name:"OptimizeMode",value:[{name:"SPEED",number:1},{name:"CODE_SIZE",number:2},{name:"LITE_RUNTIME",number:3}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"MessageOptions",field:[{name:"message_set_wire_format",number:1,type:8,label:1,defaultValue:"false"},{name:"no_standard_descriptor_accessor",number:2,type:8,label:1,defaultValue:"false"},{name:"deprecated",number:3,type:8,label:1,defaultValue:"false"},{name:"map_entry",number:7,type:8,label:1},{name:"deprecated_legacy_json_field_conflicts",number:11,type:8,label:1,options:{deprecated:!0}},{name:"features",number:12,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"FieldOptions",field:[{name:"ctype",number:1,type:14,label:1,typeName:".google.protobuf.FieldOptions.CType",defaultValue:"STRING"},{name:"packed",number:2,type:8,label:1},{name:"jstype",number:6,type:14,label:1,typeName:".google.protobuf.FieldOptions.JSType",defaultValue:"JS_NORMAL"},{name:"lazy",number:5,type:8,label:1,defaultValue:"false"},{name:"unverified_lazy",number:15,type:8,label:1,defaultValue:"false"},{name:"deprecated",number:3,type:8,label:1,defaultValue:"false"},{name:"weak",number:10,type:8,label:1,defaultValue:"false"},{name:"debug_redact",number:16,type:8,label:1,defaultValue:"false"},{name:"retention",number:17,type:14,label:1,typeName:".google.protobuf.FieldOptions.OptionRetention"},{name:"targets",number:19,type:14,label:3,typeName:".google.protobuf.FieldOptions.OptionTargetType"},{name:"edition_defaults",number:20,type:11,label:3,typeName:".google.protobuf.FieldOptions.EditionDefault"},{name:"features",number:21,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"feature_support",number:22,type:11,label:1,typeName:".google.protobuf.FieldOptions.FeatureSupport"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],nestedType:[{name:"EditionDefault",field:[{name:"edition",number:3,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"value",number:2,type:9,label:1}]},{name:"FeatureSupport",field:[{name:"edition_introduced",number:1,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"edition_deprecated",number:2,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"deprecation_warning",number:3,type:9,label:1},{name:"edition_removed",number:4,type:14,label:1,typeName:".google.protobuf.Edition"}]}],enumType:[{name:"CType",value:[{name:"STRING",number:0},{name:"CORD",number:1},{name:"STRING_PIECE",number:2}]},{name:"JSType",value:[{name:"JS_NORMAL",number:0},{name:"JS_STRING",number:1},{name:"JS_NUMBER",number:2}]},{name:"OptionRetention",value:[{name:"RETENTION_UNKNOWN",number:0},{name:"RETENTION_RUNTIME",number:1},{name:"RETENTION_SOURCE",number:2}]},{name:"OptionTargetType",value:[{name:"TARGET_TYPE_UNKNOWN",number:0},{name:"TARGET_TYPE_FILE",number:1},{name:"TARGET_TYPE_EXTENSION_RANGE",number:2},{name:"TARGET_TYPE_MESSAGE",number:3},{name:"TARGET_TYPE_FIELD",number:4},{name:"TARGET_TYPE_ONEOF",number:5},{name:"TARGET_TYPE_ENUM",number:6},{name:"TARGET_TYPE_ENUM_ENTRY",number:7},{name:"TARGET_TYPE_SERVICE",number:8},{name:"TARGET_TYPE_METHOD",number:9}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"OneofOptions",field:[{name:"features",number:1,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"EnumOptions",field:[{name:"allow_alias",number:2,type:8,label:1},{name:"deprecated",number:3,type:8,label:1,defaultValue:"false"},{name:"deprecated_legacy_json_field_conflicts",number:6,type:8,label:1,options:{deprecated:!0}},{name:"features",number:7,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"EnumValueOptions",field:[{name:"deprecated",number:1,type:8,label:1,defaultValue:"false"},{name:"features",number:2,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"debug_redact",number:3,type:8,label:1,defaultValue:"false"},{name:"feature_support",number:4,type:11,label:1,typeName:".google.protobuf.FieldOptions.FeatureSupport"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"ServiceOptions",field:[{name:"features",number:34,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"deprecated",number:33,type:8,label:1,defaultValue:"false"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],extensionRange:[{start:1e3,end:536870912}]},{name:"MethodOptions",field:[{name:"deprecated",number:33,type:8,label:1,defaultValue:"false"},{name:"idempotency_level",number:34,type:14,label:1,typeName:".google.protobuf.MethodOptions.IdempotencyLevel",defaultValue:"IDEMPOTENCY_UNKNOWN"},{name:"features",number:35,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"uninterpreted_option",number:999,type:11,label:3,typeName:".google.protobuf.UninterpretedOption"}],enumType:[{name:"IdempotencyLevel",value:[{name:"IDEMPOTENCY_UNKNOWN",number:0},{name:"NO_SIDE_EFFECTS",number:1},{name:"IDEMPOTENT",number:2}]}],extensionRange:[{start:1e3,end:536870912}]},{name:"UninterpretedOption",field:[{name:"name",number:2,type:11,label:3,typeName:".google.protobuf.UninterpretedOption.NamePart"},{name:"identifier_value",number:3,type:9,label:1},{name:"positive_int_value",number:4,type:4,label:1},{name:"negative_int_value",number:5,type:3,label:1},{name:"double_value",number:6,type:1,label:1},{name:"string_value",number:7,type:12,label:1},{name:"aggregate_value",number:8,type:9,label:1}],nestedType:[{name:"NamePart",field:[{name:"name_part",number:1,type:9,label:2},{name:"is_extension",number:2,type:8,label:2}]}]},{name:"FeatureSet",field:[{name:"field_presence",number:1,type:14,label:1,typeName:".google.protobuf.FeatureSet.FieldPresence",options:{retention:1,targets:[4,1],editionDefaults:[{value:"EXPLICIT",edition:900},{value:"IMPLICIT",edition:999},{value:"EXPLICIT",edition:1e3}]}},{name:"enum_type",number:2,type:14,label:1,typeName:".google.protobuf.FeatureSet.EnumType",options:{retention:1,targets:[6,1],editionDefaults:[{value:"CLOSED",edition:900},{value:"OPEN",edition:999}]}},{name:"repeated_field_encoding",number:3,type:14,label:1,typeName:".google.protobuf.FeatureSet.RepeatedFieldEncoding",options:{retention:1,targets:[4,1],editionDefaults:[{value:"EXPANDED",edition:900},{value:"PACKED",edition:999}]}},{name:"utf8_validation",number:4,type:14,label:1,typeName:".google.protobuf.FeatureSet.Utf8Validation",options:{retention:1,targets:[4,1],editionDefaults:[{value:"NONE",edition:900},{value:"VERIFY",edition:999}]}},{name:"message_encoding",number:5,type:14,label:1,typeName:".google.protobuf.FeatureSet.MessageEncoding",options:{retention:1,targets:[4,1],editionDefaults:[{value:"LENGTH_PREFIXED",edition:900}]}},{name:"json_format",number:6,type:14,label:1,typeName:".google.protobuf.FeatureSet.JsonFormat",options:{retention:1,targets:[3,6,1],editionDefaults:[{value:"LEGACY_BEST_EFFORT",edition:900},{value:"ALLOW",edition:999}]}},{name:"enforce_naming_style",number:7,type:14,label:1,typeName:".google.protobuf.FeatureSet.EnforceNamingStyle",options:{retention:2,targets:[1,2,3,4,5,6,7,8,9],editionDefaults:[{value:"STYLE_LEGACY",edition:900},{value:"STYLE2024",edition:1001}]}},{name:"default_symbol_visibility",number:8,type:14,label:1,typeName:".google.protobuf.FeatureSet.VisibilityFeature.DefaultSymbolVisibility",options:{retention:2,targets:[1],editionDefaults:[{value:"EXPORT_ALL",edition:900},{value:"EXPORT_TOP_LEVEL",edition:1001}]}}],nestedType:[{name:"VisibilityFeature",enumType:[{name:"DefaultSymbolVisibility",value:[{name:"DEFAULT_SYMBOL_VISIBILITY_UNKNOWN",number:0},{name:"EXPORT_ALL",number:1},{name:"EXPORT_TOP_LEVEL",number:2},{name:"LOCAL_ALL",number:3},{name:"STRICT",number:4}]}]}],enumType:[{name:"FieldPresence",value:[{name:"FIELD_PRESENCE_UNKNOWN",number:0},{name:"EXPLICIT",number:1},{name:"IMPLICIT",number:2},{name:"LEGACY_REQUIRED",number:3}]},{name:"EnumType",value:[{name:"ENUM_TYPE_UNKNOWN",number:0},{name:"OPEN",number:1},{name:"CLOSED",number:2}]},{name:"RepeatedFieldEncoding",value:[{name:"REPEATED_FIELD_ENCODING_UNKNOWN",number:0},{name:"PACKED",number:1},{name:"EXPANDED",number:2}]},{name:"Utf8Validation",value:[{name:"UTF8_VALIDATION_UNKNOWN",number:0},{name:"VERIFY",number:2},{name:"NONE",number:3}]},{name:"MessageEncoding",value:[{name:"MESSAGE_ENCODING_UNKNOWN",number:0},{name:"LENGTH_PREFIXED",number:1},{name:"DELIMITED",number:2}]},{name:"JsonFormat",value:[{name:"JSON_FORMAT_UNKNOWN",number:0},{name:"ALLOW",number:1},{name:"LEGACY_BEST_EFFORT",number:2}]},{name:"EnforceNamingStyle",value:[{name:"ENFORCE_NAMING_STYLE_UNKNOWN",number:0},{name:"STYLE2024",number:1},{name:"STYLE_LEGACY",number:2}]}],extensionRange:[{start:1e3,end:9995},{start:9995,end:1e4},{start:1e4,end:10001}]},{name:"FeatureSetDefaults",field:[{name:"defaults",number:1,type:11,label:3,typeName:".google.protobuf.FeatureSetDefaults.FeatureSetEditionDefault"},{name:"minimum_edition",number:4,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"maximum_edition",number:5,type:14,label:1,typeName:".google.protobuf.Edition"}],nestedType:[{name:"FeatureSetEditionDefault",field:[{name:"edition",number:3,type:14,label:1,typeName:".google.protobuf.Edition"},{name:"overridable_features",number:4,type:11,label:1,typeName:".google.protobuf.FeatureSet"},{name:"fixed_features",number:5,type:11,label:1,typeName:".google.protobuf.FeatureSet"}]}]},{name:"SourceCodeInfo",field:[{name:"location",number:1,type:11,label:3,typeName:".google.protobuf.SourceCodeInfo.Location"}],nestedType:[{name:"Location",field:[{name:"path",number:1,type:5,label:3,options:{packed:!0}},{name:"span",number:2,type:5,label:3,options:{packed:!0}},{name:"leading_comments",number:3,type:9,label:1},{name:"trailing_comments",number:4,type:9,label:1},{name:"leading_detached_comments",number:6,type:9,label:3}]}],extensionRange:[{start:536e6,end:536000001}]},{name:"GeneratedCodeInfo",field:[{name:"annotation",number:1,type:11,label:3,typeName:".google.protobuf.GeneratedCodeInfo.Annotation"}],nestedType:[{name:"Annotation",field:[{name:"path",number:1,type:5,label:3,options:{packed:!0}},{name:"source_file",number:2,type:9,label:1},{name:"begin",number:3,type:5,label:1},{name:"end",number:4,type:5,label:1},{name:"semantic",number:5,type:14,label:1,typeName:".google.protobuf.GeneratedCodeInfo.Annotation.Semantic"}],enumType:[{name:"Semantic",value:[{name:"NONE",number:0},{name:"SET",number:1},{name:"ALIAS",number:2}]}]}]}],enumType:[{name:"Edition",value:[{name:"EDITION_UNKNOWN",number:0},{name:"EDITION_LEGACY",number:900},{name:"EDITION_PROTO2",number:998},{name:"EDITION_PROTO3",number:999},{name:"EDITION_2023",number:1e3},{name:"EDITION_2024",number:1001},{name:"EDITION_1_TEST_ONLY",number:1},{name:"EDITION_2_TEST_ONLY",number:2},{name:"EDITION_99997_TEST_ONLY",number:99997},{name:"EDITION_99998_TEST_ONLY",number:99998},{name:"EDITION_99999_TEST_ONLY",number:99999},{name:"EDITION_MAX",number:2147483647}]},{name:"SymbolVisibility",value:[{name:"VISIBILITY_UNSET",number:0},{name:"VISIBILITY_LOCAL",number:1},{name:"VISIBILITY_EXPORT",number:2}]}]}),yE=vi(xE,1);var Lf;(function(n){n[n.DECLARATION=0]="DECLARATION",n[n.UNVERIFIED=1]="UNVERIFIED"})(Lf||(Lf={}));var Df;(function(n){n[n.DOUBLE=1]="DOUBLE",n[n.FLOAT=2]="FLOAT",n[n.INT64=3]="INT64",n[n.UINT64=4]="UINT64",n[n.INT32=5]="INT32",n[n.FIXED64=6]="FIXED64",n[n.FIXED32=7]="FIXED32",n[n.BOOL=8]="BOOL",n[n.STRING=9]="STRING",n[n.GROUP=10]="GROUP",n[n.MESSAGE=11]="MESSAGE",n[n.BYTES=12]="BYTES",n[n.UINT32=13]="UINT32",n[n.ENUM=14]="ENUM",n[n.SFIXED32=15]="SFIXED32",n[n.SFIXED64=16]="SFIXED64",n[n.SINT32=17]="SINT32",n[n.SINT64=18]="SINT64"})(Df||(Df={}));var Uf;(function(n){n[n.OPTIONAL=1]="OPTIONAL",n[n.REPEATED=3]="REPEATED",n[n.REQUIRED=2]="REQUIRED"})(Uf||(Uf={}));var Ff;(function(n){n[n.SPEED=1]="SPEED",n[n.CODE_SIZE=2]="CODE_SIZE",n[n.LITE_RUNTIME=3]="LITE_RUNTIME"})(Ff||(Ff={}));var Bf;(function(n){n[n.STRING=0]="STRING",n[n.CORD=1]="CORD",n[n.STRING_PIECE=2]="STRING_PIECE"})(Bf||(Bf={}));var Of;(function(n){n[n.JS_NORMAL=0]="JS_NORMAL",n[n.JS_STRING=1]="JS_STRING",n[n.JS_NUMBER=2]="JS_NUMBER"})(Of||(Of={}));var Vf;(function(n){n[n.RETENTION_UNKNOWN=0]="RETENTION_UNKNOWN",n[n.RETENTION_RUNTIME=1]="RETENTION_RUNTIME",n[n.RETENTION_SOURCE=2]="RETENTION_SOURCE"})(Vf||(Vf={}));var kf;(function(n){n[n.TARGET_TYPE_UNKNOWN=0]="TARGET_TYPE_UNKNOWN",n[n.TARGET_TYPE_FILE=1]="TARGET_TYPE_FILE",n[n.TARGET_TYPE_EXTENSION_RANGE=2]="TARGET_TYPE_EXTENSION_RANGE",n[n.TARGET_TYPE_MESSAGE=3]="TARGET_TYPE_MESSAGE",n[n.TARGET_TYPE_FIELD=4]="TARGET_TYPE_FIELD",n[n.TARGET_TYPE_ONEOF=5]="TARGET_TYPE_ONEOF",n[n.TARGET_TYPE_ENUM=6]="TARGET_TYPE_ENUM",n[n.TARGET_TYPE_ENUM_ENTRY=7]="TARGET_TYPE_ENUM_ENTRY",n[n.TARGET_TYPE_SERVICE=8]="TARGET_TYPE_SERVICE",n[n.TARGET_TYPE_METHOD=9]="TARGET_TYPE_METHOD"})(kf||(kf={}));var Gf;(function(n){n[n.IDEMPOTENCY_UNKNOWN=0]="IDEMPOTENCY_UNKNOWN",n[n.NO_SIDE_EFFECTS=1]="NO_SIDE_EFFECTS",n[n.IDEMPOTENT=2]="IDEMPOTENT"})(Gf||(Gf={}));var zf;(function(n){n[n.DEFAULT_SYMBOL_VISIBILITY_UNKNOWN=0]="DEFAULT_SYMBOL_VISIBILITY_UNKNOWN",n[n.EXPORT_ALL=1]="EXPORT_ALL",n[n.EXPORT_TOP_LEVEL=2]="EXPORT_TOP_LEVEL",n[n.LOCAL_ALL=3]="LOCAL_ALL",n[n.STRICT=4]="STRICT"})(zf||(zf={}));var Wf;(function(n){n[n.FIELD_PRESENCE_UNKNOWN=0]="FIELD_PRESENCE_UNKNOWN",n[n.EXPLICIT=1]="EXPLICIT",n[n.IMPLICIT=2]="IMPLICIT",n[n.LEGACY_REQUIRED=3]="LEGACY_REQUIRED"})(Wf||(Wf={}));var Hf;(function(n){n[n.ENUM_TYPE_UNKNOWN=0]="ENUM_TYPE_UNKNOWN",n[n.OPEN=1]="OPEN",n[n.CLOSED=2]="CLOSED"})(Hf||(Hf={}));var Xf;(function(n){n[n.REPEATED_FIELD_ENCODING_UNKNOWN=0]="REPEATED_FIELD_ENCODING_UNKNOWN",n[n.PACKED=1]="PACKED",n[n.EXPANDED=2]="EXPANDED"})(Xf||(Xf={}));var Zf;(function(n){n[n.UTF8_VALIDATION_UNKNOWN=0]="UTF8_VALIDATION_UNKNOWN",n[n.VERIFY=2]="VERIFY",n[n.NONE=3]="NONE"})(Zf||(Zf={}));var Yf;(function(n){n[n.MESSAGE_ENCODING_UNKNOWN=0]="MESSAGE_ENCODING_UNKNOWN",n[n.LENGTH_PREFIXED=1]="LENGTH_PREFIXED",n[n.DELIMITED=2]="DELIMITED"})(Yf||(Yf={}));var Kf;(function(n){n[n.JSON_FORMAT_UNKNOWN=0]="JSON_FORMAT_UNKNOWN",n[n.ALLOW=1]="ALLOW",n[n.LEGACY_BEST_EFFORT=2]="LEGACY_BEST_EFFORT"})(Kf||(Kf={}));var $f;(function(n){n[n.ENFORCE_NAMING_STYLE_UNKNOWN=0]="ENFORCE_NAMING_STYLE_UNKNOWN",n[n.STYLE2024=1]="STYLE2024",n[n.STYLE_LEGACY=2]="STYLE_LEGACY"})($f||($f={}));var Jf;(function(n){n[n.NONE=0]="NONE",n[n.SET=1]="SET",n[n.ALIAS=2]="ALIAS"})(Jf||(Jf={}));var jf;(function(n){n[n.EDITION_UNKNOWN=0]="EDITION_UNKNOWN",n[n.EDITION_LEGACY=900]="EDITION_LEGACY",n[n.EDITION_PROTO2=998]="EDITION_PROTO2",n[n.EDITION_PROTO3=999]="EDITION_PROTO3",n[n.EDITION_2023=1e3]="EDITION_2023",n[n.EDITION_2024=1001]="EDITION_2024",n[n.EDITION_1_TEST_ONLY=1]="EDITION_1_TEST_ONLY",n[n.EDITION_2_TEST_ONLY=2]="EDITION_2_TEST_ONLY",n[n.EDITION_99997_TEST_ONLY=99997]="EDITION_99997_TEST_ONLY",n[n.EDITION_99998_TEST_ONLY=99998]="EDITION_99998_TEST_ONLY",n[n.EDITION_99999_TEST_ONLY=99999]="EDITION_99999_TEST_ONLY",n[n.EDITION_MAX=2147483647]="EDITION_MAX"})(jf||(jf={}));var qf;(function(n){n[n.VISIBILITY_UNSET=0]="VISIBILITY_UNSET",n[n.VISIBILITY_LOCAL=1]="VISIBILITY_LOCAL",n[n.VISIBILITY_EXPORT=2]="VISIBILITY_EXPORT"})(qf||(qf={}));const Qf={readUnknownFields:!0};function bE(n){return n?Object.assign(Object.assign({},Qf),n):Qf}function er(n,e,t){const i=Tn(n,void 0,!1);return Um(i,new Tu(e),bE(t),!1,e.byteLength),i.message}function Um(n,e,t,i,s){var r;const a=i?e.len:e.pos+s;let o,c;const l=(r=n.getUnknown())!==null&&r!==void 0?r:[];for(;e.pos<a&&([o,c]=e.tag(),!(i&&c==bt.EndGroup));){const u=n.findNumber(o);if(!u){const f=e.skip(c,o);t.readUnknownFields&&l.push({no:o,wireType:c,data:f});continue}Fm(n,e,u,c,t)}if(i&&(c!=bt.EndGroup||o!==s))throw new Error("invalid end group tag");l.length>0&&n.setUnknown(l)}function Fm(n,e,t,i,s){var r;switch(t.fieldKind){case"scalar":n.set(t,Zs(e,t.scalar));break;case"enum":const a=Zs(e,G.INT32);if(t.enum.open)n.set(t,a);else if(t.enum.values.some(c=>c.number===a))n.set(t,a);else if(s.readUnknownFields){const c=new wu().int32(a).finish(),l=(r=n.getUnknown())!==null&&r!==void 0?r:[];l.push({no:t.number,wireType:i,data:c}),n.setUnknown(l)}break;case"message":n.set(t,Fu(e,s,t,n.get(t)));break;case"list":EE(e,i,n.get(t),s);break;case"map":SE(e,n.get(t),s);break}}function SE(n,e,t){const i=e.field();let s,r;const a=n.uint32(),o=n.pos+a;for(;n.pos<o;){const[c]=n.tag();switch(c){case 1:s=Zs(n,i.mapKey);break;case 2:switch(i.mapKind){case"scalar":r=Zs(n,i.scalar);break;case"enum":r=n.int32();break;case"message":r=Fu(n,t,i);break}break}}if(s===void 0&&(s=as(i.mapKey,!1)),r===void 0)switch(i.mapKind){case"scalar":r=as(i.scalar,!1);break;case"enum":r=i.enum.values[0].number;break;case"message":r=Tn(i.message,void 0,!1);break}e.set(s,r)}function EE(n,e,t,i){var s;const r=t.field();if(r.listKind==="message"){t.add(Fu(n,i,r));return}const a=(s=r.scalar)!==null&&s!==void 0?s:G.INT32;if(!(e==bt.LengthDelimited&&a!=G.STRING&&a!=G.BYTES)){t.add(Zs(n,a));return}const c=n.uint32()+n.pos;for(;n.pos<c;)t.add(Zs(n,a))}function Fu(n,e,t,i){const s=t.delimitedEncoding,r=i??Tn(t.message,void 0,!1);return Um(r,n,e,s,s?t.number:n.uint32()),r}function Zs(n,e){switch(e){case G.STRING:return n.string();case G.BOOL:return n.bool();case G.DOUBLE:return n.double();case G.FLOAT:return n.float();case G.INT32:return n.int32();case G.INT64:return n.int64();case G.UINT64:return n.uint64();case G.FIXED64:return n.fixed64();case G.BYTES:return n.bytes();case G.FIXED32:return n.fixed32();case G.SFIXED32:return n.sfixed32();case G.SFIXED64:return n.sfixed64();case G.SINT64:return n.sint64();case G.UINT32:return n.uint32();case G.SINT32:return n.sint32()}}function On(n,e){var t;const i=er(yE,yu(n));return i.messageType.forEach(vu),i.dependency=(t=e?.map(r=>r.proto.name))!==null&&t!==void 0?t:[],lm(i,r=>e?.find(a=>a.proto.name===r)).getFile(i.name)}function Wr(n,e,...t){if(t.length>0)throw new Error;return n.services[e]}const Hr=On("ChdnZW9kZXNpYy92MS9xdWVyeS5wcm90bxILZ2VvZGVzaWMudjEieQoNQXBwcm94aW1hdGlvbhIXCgpuZWlnaGJvdXJzGAEgASgNSACIAQESEwoGbGFtYmRhGAIgASgBSAGIAQESFAoHc2FtcGxlcxgDIAEoDUgCiAEBQg0KC19uZWlnaGJvdXJzQgkKB19sYW1iZGFCCgoIX3NhbXBsZXMiywEKDEFuc3dlckhlYWRlchITCgttZXNoX2RpZ2VzdBgBIAEoCRIUCgx2ZXJ0ZXhfY291bnQYAiABKAQSKQoJYWxnb3JpdGhtGAMgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEhoKEnJlbGF0aXZlX3RvbGVyYW5jZRgEIAEoARIWCg5zZXJ2ZXJfdmVyc2lvbhgFIAEoCRIxCg1hcHByb3hpbWF0aW9uGAYgASgLMhouZ2VvZGVzaWMudjEuQXBwcm94aW1hdGlvbiJzCg1Tb2x2ZVByb2dyZXNzEhYKDnNldHRsZWRfcmFkaXVzGAEgASgBEhgKEHZlcnRpY2VzX3JlYWNoZWQYAiABKAQSFAoMbGl2ZV93aW5kb3dzGAMgASgEEhoKEndpbmRvd3NfcHJvcGFnYXRlZBgEIAEoBCKKAQoNQW5zd2VyVHJhaWxlchIXCg9jb21wdXRlX3NlY29uZHMYASABKAESGgoSd2luZG93c19wcm9wYWdhdGVkGAIgASgEEhIKCml0ZW1fY291bnQYAyABKAQSHAoPY2VydGlmaWVkX2Vycm9yGAQgASgBSACIAQFCEgoQX2NlcnRpZmllZF9lcnJvciLSAQoPU29sdmVTdGF0aXN0aWNzEhIKCml0ZXJhdGlvbnMYASABKAQSFwoPd2luZG93c19jcmVhdGVkGAIgASgEEhoKEndpbmRvd3NfcHJvcGFnYXRlZBgDIAEoBBIWCg5wZWFrX3dhdmVmcm9udBgEIAEoBBIWCg5tZWFuX3dhdmVmcm9udBgFIAEoARIUCgxwZWFrX3dpbmRvd3MYBiABKAQSGQoRcGVha19zb2x2ZXJfYnl0ZXMYByABKAQSFQoNc29sdmVfc2Vjb25kcxgIIAEoASq1AgoJQWxnb3JpdGhtEhkKFUFMR09SSVRITV9VTlNQRUNJRklFRBAAEhQKEEFMR09SSVRITV9GV1BfQ0gQARIVChFBTEdPUklUSE1fRldQX01NUBACEhEKDUFMR09SSVRITV9JQ0gQAxIRCg1BTEdPUklUSE1fTU1QEAQSEAoMQUxHT1JJVEhNX0NIEAUSFAoQQUxHT1JJVEhNX0xDX01NUBAGEhMKD0FMR09SSVRITV9MQ19DSBAHEhYKEkFMR09SSVRITV9GV1BfTElTVBAIEhEKDUFMR09SSVRITV9GTU0QEBIYChRBTEdPUklUSE1fRk1NX1VOVElEWRAREhIKDkFMR09SSVRITV9IRUFUEBISEQoNQUxHT1JJVEhNX1NWRxATEhEKDUFMR09SSVRITV9HVFUQFCpXCglWYWx1ZVR5cGUSGgoWVkFMVUVfVFlQRV9VTlNQRUNJRklFRBAAEhYKElZBTFVFX1RZUEVfRkxPQVQ2NBABEhYKElZBTFVFX1RZUEVfRkxPQVQzMhACKlIKCFByaW9yaXR5EhgKFFBSSU9SSVRZX1VOU1BFQ0lGSUVEEAASGAoUUFJJT1JJVFlfSU5URVJBQ1RJVkUQARISCg5QUklPUklUWV9CQVRDSBACYgZwcm90bzM");var Ur=(n=>(n[n.UNSPECIFIED=0]="UNSPECIFIED",n[n.FWP_CH=1]="FWP_CH",n[n.FWP_MMP=2]="FWP_MMP",n[n.ICH=3]="ICH",n[n.MMP=4]="MMP",n[n.CH=5]="CH",n[n.LC_MMP=6]="LC_MMP",n[n.LC_CH=7]="LC_CH",n[n.FWP_LIST=8]="FWP_LIST",n[n.FMM=16]="FMM",n[n.FMM_UNTIDY=17]="FMM_UNTIDY",n[n.HEAT=18]="HEAT",n[n.SVG=19]="SVG",n[n.GTU=20]="GTU",n))(Ur||{});class ME{past=[];future=[];gesture;get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}record(e,t){this.future.length=0,(t===void 0||t!==this.gesture)&&this.past.push(e),this.gesture=t}undo(e){return this.go(this.past,this.future,e)}redo(e){return this.go(this.future,this.past,e)}cancel(e){if(!(e===void 0||e!==this.gesture))return this.gesture=void 0,this.past.pop()}clear(){this.past.length=this.future.length=0,this.gesture=void 0}go(e,t,i){this.gesture=void 0;const s=e.pop();return s!==void 0&&t.push(i),s}}function po(n){switch(n.kind){case"vertex":return`${n.vertex}`;case"edge":return`edge:${n.from}-${n.to}@${n.t}`;case"face":return`face:${n.face}@${n.weights.join(",")}`}}function Ys(n){return"curve"in n?n.curve.map(po).join(";"):po(n)}function Ea(n){switch(n.kind){case"vertex":return`${n.vertex}`;case"edge":return`geodesic.EdgePoint(${n.from}, ${n.to}, ${n.t})`;case"face":return`geodesic.FacePoint(${n.face}, (${n.weights.join(", ")}))`}}function ed(n){const e=n.split(";").map(AE).filter(t=>t!==void 0);if(!(e.length<n.split(";").length))return e.length>1?{curve:e}:e[0]}function AE(n){if(/^\d+$/.test(n))return{kind:"vertex",vertex:Number(n)};const e=/^edge:(\d+)-(\d+)@([\d.e+-]+)$/.exec(n);if(e)return{kind:"edge",from:Number(e[1]),to:Number(e[2]),t:Number(e[3])};const t=/^face:(\d+)@([\d.e+-]+),([\d.e+-]+),([\d.e+-]+)$/.exec(n);if(t)return{kind:"face",face:Number(t[1]),weights:[Number(t[2]),Number(t[3]),Number(t[4])]}}const cr={sources:[],paths:[],samples:[]};function wE({sources:n,paths:e,samples:t,radius:i}){return!n.length&&!e.length&&!t.length&&i===void 0}function td(n,e){return n.length===e.length&&n.every((t,i)=>t===e[i])}function nd(n,e,t){const i=e[n.source];return{...n,from:"curve"in i?n.places[0]:i,target:t}}function TE(n,e){const t=Ys(n);return e.some(i=>Ys(i)===t)}class Bm{constructor(e){this.patienceMs=e}patienceMs;running;waiting;timer;ask(e){if(this.waiting=e,!this.running){this.run();return}const t=performance.now()-this.running.since;this.timer??=setTimeout(()=>this.running?.abort.abort(),Math.max(this.patienceMs-t,0))}stop(){this.waiting=void 0,this.running?.abort.abort()}async run(){for(;this.waiting;){const e=this.waiting;this.waiting=void 0,this.running={abort:new AbortController,since:performance.now()},await e(this.running.abort.signal),clearTimeout(this.timer),this.timer=void 0,this.running=void 0}}}const id=new Ot,Ma=new P;class Om extends o_{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";const e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Mn(e,3)),this.setAttribute("uv",new Mn(t,2))}applyMatrix4(e){const t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));const i=new Ul(t,6,1);return this.setAttribute("instanceStart",new Li(i,3,0)),this.setAttribute("instanceEnd",new Li(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));const i=new Ul(t,6,1);return this.setAttribute("instanceColorStart",new Li(i,3,0)),this.setAttribute("instanceColorEnd",new Li(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new e_(e.geometry)),this}fromLineSegments(e){const t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ot);const e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),id.setFromBufferAttribute(t),this.boundingBox.union(id))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new qs),this.boundingBox===null&&this.computeBoundingBox();const e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){const i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,a=e.count;r<a;r++)Ma.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Ma)),Ma.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Ma));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}}ce.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new we(1,1)},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};sn.line={uniforms:mu.merge([ce.common,ce.fog,ce.line]),vertexShader:`
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
		`};class Bu extends on{constructor(e){super({type:"LineMaterial",uniforms:mu.clone(sn.line.uniforms),vertexShader:sn.line.vertexShader,fragmentShader:sn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}}const Mc=new ht,sd=new P,rd=new P,Vt=new ht,kt=new ht,Wn=new ht,Ac=new P,wc=new je,Gt=new Qn,ad=new P,Aa=new Ot,wa=new qs,Hn=new ht;let Kn,es;function od(n,e,t){return Hn.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),Hn.multiplyScalar(1/Hn.w),Hn.x=es/t.width,Hn.y=es/t.height,Hn.applyMatrix4(n.projectionMatrixInverse),Hn.multiplyScalar(1/Hn.w),Math.abs(Math.max(Hn.x,Hn.y))}function RE(n,e){const t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,a=Math.min(i.instanceCount,s.count);for(let o=0,c=a;o<c;o++){Gt.start.fromBufferAttribute(s,o),Gt.end.fromBufferAttribute(r,o),Gt.applyMatrix4(t);const l=new P,u=new P;Kn.distanceSqToSegment(Gt.start,Gt.end,u,l),u.distanceTo(l)<es*.5&&e.push({point:u,pointOnLine:l,distance:Kn.origin.distanceTo(u),object:n,face:null,faceIndex:o,uv:null,uv1:null})}}function NE(n,e,t){const i=e.projectionMatrix,r=n.material.resolution,a=n.matrixWorld,o=n.geometry,c=o.attributes.instanceStart,l=o.attributes.instanceEnd,u=Math.min(o.instanceCount,c.count),f=-e.near;Kn.at(1,Wn),Wn.w=1,Wn.applyMatrix4(e.matrixWorldInverse),Wn.applyMatrix4(i),Wn.multiplyScalar(1/Wn.w),Wn.x*=r.x/2,Wn.y*=r.y/2,Wn.z=0,Ac.copy(Wn),wc.multiplyMatrices(e.matrixWorldInverse,a);for(let h=0,d=u;h<d;h++){if(Vt.fromBufferAttribute(c,h),kt.fromBufferAttribute(l,h),Vt.w=1,kt.w=1,Vt.applyMatrix4(wc),kt.applyMatrix4(wc),Vt.z>f&&kt.z>f)continue;if(Vt.z>f){const b=Vt.z-kt.z,x=(Vt.z-f)/b;Vt.lerp(kt,x)}else if(kt.z>f){const b=kt.z-Vt.z,x=(kt.z-f)/b;kt.lerp(Vt,x)}Vt.applyMatrix4(i),kt.applyMatrix4(i),Vt.multiplyScalar(1/Vt.w),kt.multiplyScalar(1/kt.w),Vt.x*=r.x/2,Vt.y*=r.y/2,kt.x*=r.x/2,kt.y*=r.y/2,Gt.start.copy(Vt),Gt.start.z=0,Gt.end.copy(kt),Gt.end.z=0;const y=Gt.closestPointToPointParameter(Ac,!0);Gt.at(y,ad);const p=Fp.lerp(Vt.z,kt.z,y),m=p>=-1&&p<=1,v=Ac.distanceTo(ad)<es*.5;if(m&&v){Gt.start.fromBufferAttribute(c,h),Gt.end.fromBufferAttribute(l,h),Gt.start.applyMatrix4(a),Gt.end.applyMatrix4(a);const b=new P,x=new P;Kn.distanceSqToSegment(Gt.start,Gt.end,x,b),t.push({point:x,pointOnLine:b,distance:Kn.origin.distanceTo(x),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}class IE extends An{constructor(e=new Om,t=new Bu({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){const e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let a=0,o=0,c=t.count;a<c;a++,o+=2)sd.fromBufferAttribute(t,a),rd.fromBufferAttribute(i,a),s[o]=o===0?0:s[o-1],s[o+1]=s[o]+sd.distanceTo(rd);const r=new Ul(s,2,1);return e.setAttribute("instanceDistanceStart",new Li(r,1,0)),e.setAttribute("instanceDistanceEnd",new Li(r,1,1)),this}raycast(e,t){const i=this.material.worldUnits,s=e.camera;s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.');const r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Kn=e.ray;const a=this.matrixWorld,o=this.geometry,c=this.material;es=c.linewidth+r,o.boundingSphere===null&&o.computeBoundingSphere(),wa.copy(o.boundingSphere).applyMatrix4(a);let l;if(i)l=es*.5;else{const f=Math.max(s.near,wa.distanceToPoint(Kn.origin));l=od(s,f,c.resolution)}if(wa.radius+=l,Kn.intersectsSphere(wa)===!1)return;o.boundingBox===null&&o.computeBoundingBox(),Aa.copy(o.boundingBox).applyMatrix4(a);let u;if(i)u=es*.5;else{const f=Math.max(s.near,Aa.distanceToPoint(Kn.origin));u=od(s,f,c.resolution)}Aa.expandByScalar(u),Kn.intersectsBox(Aa)!==!1&&(i?RE(this,t):NE(this,s,t))}onBeforeRender(e){const t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Mc),this.material.uniforms.resolution.value.set(Mc.z,Mc.w))}}class Wl extends Om{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(e){const t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setPositions(i),this}setColors(e){const t=e.length-3,i=new Float32Array(2*t);for(let s=0;s<t;s+=3)i[2*s]=e[s],i[2*s+1]=e[s+1],i[2*s+2]=e[s+2],i[2*s+3]=e[s+3],i[2*s+4]=e[s+4],i[2*s+5]=e[s+5];return super.setColors(i),this}setFromPoints(e){const t=e.length-1,i=new Float32Array(6*t);for(let s=0;s<t;s++)i[6*s]=e[s].x,i[6*s+1]=e[s].y,i[6*s+2]=e[s].z||0,i[6*s+3]=e[s+1].x,i[6*s+4]=e[s+1].y,i[6*s+5]=e[s+1].z||0;return super.setPositions(i),this}fromLine(e){const t=e.geometry;return this.setPositions(t.attributes.position.array),this}}class CE extends IE{constructor(e=new Wl,t=new Bu({color:Math.random()*16777215})){super(e,t),this.isLine2=!0,this.type="Line2"}}class Ou extends vr{geometry=new Wl;passes;constructor(e,t,i){super();const s=[{color:e,width:.75*t,opacity:.32,hidden:!0},{color:1052696,width:1.9*t,opacity:.85,hidden:!1},{color:e,width:t,opacity:1,hidden:!1}];this.passes=s.map((r,a)=>{const o=new Bu({color:new Ke(r.color),linewidth:r.width,transparent:!0,opacity:r.opacity,depthWrite:!1,depthFunc:r.hidden?io:ts});o.resolution=i;const c=new CE(this.geometry,o);return c.renderOrder=10+a,c.frustumCulled=!1,c}),this.add(...this.passes),this.visible=!1}setPoints(e){this.geometry.dispose(),this.geometry=new Wl,this.visible=e.length>=6,this.visible&&this.geometry.setPositions(e);for(const t of this.passes)t.geometry=this.geometry}dispose(){this.geometry.dispose();for(const e of this.passes)e.material.dispose()}}const PE=16777215,LE=250;class DE{constructor(e,t){this.scene=e,this.actions=t,this.line=new Ou(PE,3,e.resolution),e.overlay.add(this.line)}scene;actions;line;newest=new Bm(LE);aimed;lead(e,t,i){const s=this.aimed={mesh:e,target:t,since:i};this.newest.ask(r=>this.draw(s,r))}hide(){this.aimed=void 0,this.newest.stop(),this.line.visible&&(this.line.setPoints(new Float32Array),this.scene.redraw())}warmUp(){this.line.setPoints(new Float32Array([-2,0,0,2,0,0]))}async draw({mesh:e,target:t,since:i},s){try{const r=await this.actions.ask(e,t,s);if(this.aimed?.mesh!==e||s.aborted)return;this.line.setPoints(r?e.toScreen(r.positions):new Float32Array),this.actions.value(r?.distance??1/0),this.scene.draw(),performance.measure("path under the cursor",{start:i,end:performance.now()})}catch(r){this.actions.failed(r,()=>{this.aimed&&this.lead(this.aimed.mesh,this.aimed.target,this.aimed.since)})}}}const cd=[[.36,.15,298],[.5,.125,258],[.65,.105,200],[.8,.165,146],[.94,.175,106]],Gs=256,Er=UE(),mo=[[230,159,0],[86,180,233],[0,158,115],[240,228,66],[0,114,178],[213,94,0],[204,121,167]];function Vm(n){const e=4*Math.round(Math.min(Math.max(n,0),1)*(Gs-1));return`rgb(${Er[e]}, ${Er[e+1]}, ${Er[e+2]})`}function UE(){const e=Array.from({length:2049},(r,a)=>FE(a/2048)),t=[0];for(let r=1;r<=2048;r++)t.push(t[r-1]+Math.hypot(...e[r].map((a,o)=>a-e[r-1][o])));const i=new Uint8Array(4*Gs);let s=0;for(let r=0;r<Gs;r++){const a=t[2048]*r/(Gs-1);for(;s<2048&&t[s]<a;)s++;i.set([...OE(e[s]),255],4*r)}return i}function FE(n){const e=cd.length-1,t=Math.min(Math.floor(n*e),e-1),i=n*e-t,s=d=>cd[Math.min(Math.max(d,0),e)],[r,a,o,c]=[s(t-1),s(t),s(t+1),s(t+2)],[l,u,f]=a.map((d,g)=>BE(r[g],a[g],o[g],c[g],i)),h=f*Math.PI/180;return[l,u*Math.cos(h),u*Math.sin(h)]}function BE(n,e,t,i,s){return e+.5*s*(t-n+s*(2*n-5*e+4*t-i+s*(3*(e-t)+i-n)))}function OE([n,e,t]){const i=(n+.3963377774*e+.2158037573*t)**3,s=(n-.1055613458*e-.0638541728*t)**3,r=(n-.0894841775*e-1.291485548*t)**3;return[4.0767416621*i-3.3077115913*s+.2309699292*r,-1.2684380046*i+2.6097574011*s-.3413193965*r,-.0041960863*i-.7034186147*s+1.707614701*r].map(a=>{const o=Math.min(Math.max(a,0),1);return Math.round(255*(o<=.0031308?12.92*o:1.055*o**(1/2.4)-.055))})}function Vu(n){if(!(n>0)||!Number.isFinite(n))return{step:0,perLabel:1};const e=10**Math.floor(Math.log10(n)),t=n/e;return t<2?{step:e/20,perLabel:4}:t<4.5?{step:e/10,perLabel:5}:{step:e/5,perLabel:5}}function km(n){const e=[],t=Vu(n),i=t.step*t.perLabel;if(!(i>0))return e;for(let s=0;s*i<=n*(1+1e-12);s++)e.push({at:s*i,text:String(Number((s*i).toPrecision(6)))});return e}const ld=700;class ud{constructor(e,t,i,s){this.mesh=e,this.material=t,this.quadratic=s,this.distances=new Float64Array(e.vertexCount).fill(1/0),this.drawn=new Float32Array(e.vertexCount).fill(-1),this.attribute=new Et(this.drawn,1).setUsage(c0),e.setAttribute("geodesic",this.attribute),t.uniforms.reference.value=i,t.uniforms.quadratic.value=s,this.paintDistances(),this.setFront(0)}mesh;material;quadratic;distances;painted="distances";difference;largest=0;drawn;attribute;preview;complete=!1;arrived=!1;swept=!1;front=0;lastFrame=0;add(e,t){for(let i=0;i<e.length;i++)this.distances[e[i]]=t[i],this.drawn[e[i]]=t[i]/this.mesh.radius;t.length&&(this.largest=Math.max(this.largest,t[t.length-1])),this.attribute.needsUpdate=!0,this.setScale()}setAll(e){this.distances.set(e);for(let t=0;t<e.length;t++)Number.isFinite(e[t])&&(this.drawn[t]=e[t]/this.mesh.radius,this.largest=Math.max(this.largest,e[t]));this.arrived=!0,this.attribute.needsUpdate=!0,this.setScale(),this.setFront(1/0)}showPreview(e){if(!this.complete){this.preview=e;for(let t=0;t<e.length;t++)!Number.isFinite(e[t])||Number.isFinite(this.distances[t])||(this.drawn[t]=e[t]/this.mesh.radius,this.largest=Math.max(this.largest,e[t]));this.attribute.needsUpdate=!0,this.setScale()}}get isPreview(){return this.preview!==void 0}finish(){if(this.complete=!0,!!this.preview){this.preview=void 0,this.largest=0;for(let e=0;e<this.distances.length;e++)Number.isFinite(this.distances[e])?this.largest=Math.max(this.largest,this.distances[e]):this.drawn[e]=-1;this.attribute.needsUpdate=!0,this.setScale()}}get hasArrived(){return this.arrived}get hasSwept(){return this.swept}advance(e,t){if(this.arrived)return!1;if(!this.complete&&!this.preview&&!this.largest)return this.lastFrame=0,!1;const i=this.largest/this.mesh.radius,s=this.lastFrame?Math.min(e-this.lastFrame,ld):16;this.lastFrame=e;const r=this.front;return t&&(this.front=i),this.front=Math.min(this.front+i*s/ld,i),this.swept=this.front>=i&&(this.complete||this.preview!==void 0),this.arrived=this.complete&&this.swept,this.setFront(this.swept?1/0:this.front),this.preview===void 0||r<i}paintCells(e){const t=new Uint8Array(3*e.length).fill(128);for(let i=0;i<e.length;i++)e[i]!==4294967295&&t.set(mo[e[i]%mo.length],3*i);this.paint("cells",t,.45)}paintDifference(e){this.difference=e;const{shares:t}=e,i=new Uint8Array(3*t.length).fill(128);for(let s=0;s<t.length;s++){if(Number.isNaN(t[s]))continue;const r=4*Math.round(t[s]*(Gs-1));i.set(Er.subarray(r,r+3),3*s)}this.paint("difference",i,0)}paintDistances(){this.painted="distances",this.material.uniforms.painted.value=!1,this.mesh.setAttribute("paint",void 0)}paint(e,t,i){this.painted=e,this.material.uniforms.painted.value=!0,this.material.uniforms.shade.value=i,this.mesh.setAttribute("paint",new Et(t,3,!0))}at(e,t){const i=this.mesh.cornersOf(e),s=this.mesh.radius,r=i.map(c=>this.shownAt(c)/s);let a=0;for(let c=0;c<3;c++)a+=t[c]*(this.quadratic?r[c]*r[c]:r[c]);if(!this.quadratic||!Number.isFinite(a))return a*s;const o=i.map(c=>this.mesh.vertexPosition(c));for(let c=0;c<3;c++){const l=(c+1)%3,u=Math.hypot(o[c][0]-o[l][0],o[c][1]-o[l][1],o[c][2]-o[l][2])/s;a-=t[c]*t[l]*u*u}return Math.sqrt(Math.max(a,0))*s}shownAt(e){const t=this.distances[e];return t===1/0&&this.preview?this.preview[e]:t}get scaleEnd(){return{distances:this.largest,cells:0,difference:this.difference?.largest??0}[this.painted]}setScale(){const{step:e,perLabel:t}=Vu(this.largest);this.material.uniforms.largest.value=Math.max(this.largest/this.mesh.radius,1e-30),this.material.uniforms.lineStep.value=e/this.mesh.radius,this.material.uniforms.linesPerLabel.value=t}setFront(e){this.material.uniforms.front.value=Number.isFinite(e)?e:1e10,this.material.uniforms.glow.value=Number.isFinite(e)?.8:0}}const VE=`
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
}`,kE=`
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
}`;class hd extends q0{constructor(e,t){super(new $t,new on({vertexShader:VE,fragmentShader:kE,transparent:!0,depthTest:!1,depthWrite:!1,uniforms:{size:{value:e},depths:t.depths,pixelRatio:t.pixelRatio}})),this.frustumCulled=!1,this.renderOrder=20,this.visible=!1}setDots(e){this.geometry.dispose(),this.geometry=new $t;const t=new Float32Array(e.flatMap(s=>Array.from(s.point))),i=new Float32Array(e.flatMap(s=>[...s.fill]));this.geometry.setAttribute("position",new Et(t,3)),this.geometry.setAttribute("fill",new Et(i,3)),this.visible=e.length>0}}const GE=16747586,Gm=9425919,fd=[1,1,1],zE=[.55,.83,1],dd=[1,.55,.26];class WE{constructor(e){this.scene=e,this.dots=new hd(15,e),this.samples=new hd(10,e),e.overlay.add(this.samples,this.dots)}scene;lines=new Map;dots;samples;show(e,{sources:t,paths:i,samples:s},r){this.dropLinesBut(new Set([...i,...t]));for(const c of i)this.addLine(e,c,GE,c.positions);const a=[],o=(c,l)=>a.push({point:Mr(e,c).toArray(),fill:l});t.forEach((c,l)=>{"curve"in c?this.addLine(e,c,Gm,new Float64Array(c.curve.flatMap(u=>e.positionOf(u)))):o(c,r?mo[l%mo.length].map(u=>u/255):fd)});for(const{from:c,target:l}of i)TE(c,t)||o(c,dd),o(l,dd);this.dots.setDots(a),this.samples.setDots(s.map(({vertex:c})=>({point:Mr(e,{kind:"vertex",vertex:c}).toArray(),fill:zE})))}warmUp(){this.dots.setDots([{point:[0,0,0],fill:fd}])}addLine(e,t,i,s){if(this.lines.has(t))return;const r=new Ou(i,3,this.scene.resolution);r.setPoints(e.toScreen(s)),this.lines.set(t,r),this.scene.overlay.add(r)}dropLinesBut(e){for(const[t,i]of this.lines)e.has(t)||(this.scene.overlay.remove(i),i.dispose(),this.lines.delete(t))}}function Mr(n,e){return new P(...n.toScreen(new Float64Array(n.positionOf(e))))}var De;(function(n){n[n.Canceled=1]="Canceled",n[n.Unknown=2]="Unknown",n[n.InvalidArgument=3]="InvalidArgument",n[n.DeadlineExceeded=4]="DeadlineExceeded",n[n.NotFound=5]="NotFound",n[n.AlreadyExists=6]="AlreadyExists",n[n.PermissionDenied=7]="PermissionDenied",n[n.ResourceExhausted=8]="ResourceExhausted",n[n.FailedPrecondition=9]="FailedPrecondition",n[n.Aborted=10]="Aborted",n[n.OutOfRange=11]="OutOfRange",n[n.Unimplemented=12]="Unimplemented",n[n.Internal=13]="Internal",n[n.Unavailable=14]="Unavailable",n[n.DataLoss=15]="DataLoss",n[n.Unauthenticated=16]="Unauthenticated"})(De||(De={}));const zm=On("Chlnb29nbGUvcHJvdG9idWYvYW55LnByb3RvEg9nb29nbGUucHJvdG9idWYiJgoDQW55EhAKCHR5cGVfdXJsGAEgASgJEg0KBXZhbHVlGAIgASgMQnYKE2NvbS5nb29nbGUucHJvdG9idWZCCEFueVByb3RvUAFaLGdvb2dsZS5nb2xhbmcub3JnL3Byb3RvYnVmL3R5cGVzL2tub3duL2FueXBiogIDR1BCqgIeR29vZ2xlLlByb3RvYnVmLldlbGxLbm93blR5cGVzYgZwcm90bzM"),HE=vi(zm,0);function XE(n,e,t){let i=!1;return t||(t=dn(HE),i=!0),t.value=Uu(n,e),t.typeUrl=KE(e.$typeName),i?t:void 0}function ZE(n,e){if(n.typeUrl==="")return!1;const t=typeof e=="string"?e:e.typeName,i=Wm(n.typeUrl);return t===i}function YE(n,e){if(n.typeUrl==="")return;const t=e.kind=="message"?e:e.getMessage(Wm(n.typeUrl));if(!(!t||!ZE(n,t)))return er(t,n.value)}function KE(n){return`type.googleapis.com/${n}`}function Wm(n){const e=n.lastIndexOf("/"),t=e>=0?n.substring(e+1):n;if(!t.length)throw new Error(`invalid type url: ${n}`);return t}const ku=On("Chxnb29nbGUvcHJvdG9idWYvc3RydWN0LnByb3RvEg9nb29nbGUucHJvdG9idWYihAEKBlN0cnVjdBIzCgZmaWVsZHMYASADKAsyIy5nb29nbGUucHJvdG9idWYuU3RydWN0LkZpZWxkc0VudHJ5GkUKC0ZpZWxkc0VudHJ5EgsKA2tleRgBIAEoCRIlCgV2YWx1ZRgCIAEoCzIWLmdvb2dsZS5wcm90b2J1Zi5WYWx1ZToCOAEi6gEKBVZhbHVlEjAKCm51bGxfdmFsdWUYASABKA4yGi5nb29nbGUucHJvdG9idWYuTnVsbFZhbHVlSAASFgoMbnVtYmVyX3ZhbHVlGAIgASgBSAASFgoMc3RyaW5nX3ZhbHVlGAMgASgJSAASFAoKYm9vbF92YWx1ZRgEIAEoCEgAEi8KDHN0cnVjdF92YWx1ZRgFIAEoCzIXLmdvb2dsZS5wcm90b2J1Zi5TdHJ1Y3RIABIwCgpsaXN0X3ZhbHVlGAYgASgLMhouZ29vZ2xlLnByb3RvYnVmLkxpc3RWYWx1ZUgAQgYKBGtpbmQiMwoJTGlzdFZhbHVlEiYKBnZhbHVlcxgBIAMoCzIWLmdvb2dsZS5wcm90b2J1Zi5WYWx1ZSobCglOdWxsVmFsdWUSDgoKTlVMTF9WQUxVRRAAQn8KE2NvbS5nb29nbGUucHJvdG9idWZCC1N0cnVjdFByb3RvUAFaL2dvb2dsZS5nb2xhbmcub3JnL3Byb3RvYnVmL3R5cGVzL2tub3duL3N0cnVjdHBi+AEBogIDR1BCqgIeR29vZ2xlLlByb3RvYnVmLldlbGxLbm93blR5cGVzYgZwcm90bzM"),$E=vi(ku,0),Hm=vi(ku,1),JE=vi(ku,2);var Hl;(function(n){n[n.NULL_VALUE=0]="NULL_VALUE"})(Hl||(Hl={}));function jE(n,e){Xm(e,n);const t=QE(n.$unknown,e),[i,s,r]=Mo(e);for(const a of t)Fm(i,new Tu(a.data),s,a.wireType,{readUnknownFields:!0});return r()}function qE(n,e,t){var i;Xm(e,n);const s=((i=n.$unknown)!==null&&i!==void 0?i:[]).filter(l=>l.no!==e.number),[r,a]=Mo(e,t),o=new wu;Pm(o,{writeUnknownFields:!0},r,a);const c=new Tu(o.finish());for(;c.pos<c.len;){const[l,u]=c.tag(),f=c.skip(u,l);s.push({no:l,wireType:u,data:f})}n.$unknown=s}function QE(n,e){if(n===void 0)return[];if(e.fieldKind==="enum"||e.fieldKind==="scalar"){for(let t=n.length-1;t>=0;--t)if(n[t].no==e.number)return[n[t]];return[]}return n.filter(t=>t.no===e.number)}function Mo(n,e){const t=n.typeName,i=Object.assign(Object.assign({},n),{kind:"field",parent:n.extendee,localName:t}),s=Object.assign(Object.assign({},n.extendee),{fields:[i],members:[i],oneofs:[]}),r=dn(s,e!==void 0?{[t]:e}:void 0);return[Tn(s,r),i,()=>{const a=r[t];if(a===void 0){const o=n.message;return zr(o)?as(o.fields[0].scalar,o.fields[0].longAsString):dn(o)}return a}]}function Xm(n,e){if(n.extendee.typeName!=e.$typeName)throw new Error(`extension ${n.typeName} can only be applied to message ${n.extendee.typeName}`)}const eM=3,tM=2,pd={alwaysEmitImplicit:!1,enumAsInteger:!1,useProtoFieldName:!1};function nM(n){return n?Object.assign(Object.assign({},pd),n):pd}function iM(n,e,t){return Xr(Tn(n,e),nM(t))}function sM(n,e,t){var i;const s=iM(n,e,t);return JSON.stringify(s,null,(i=t?.prettySpaces)!==null&&i!==void 0?i:0)}function Xr(n,e){var t;const i=cM(n,e);if(i!==void 0)return i;const s={};for(const r of n.sortedFields){if(!n.isSet(r)){if(r.presence==eM)throw new Error(`cannot encode ${r} to JSON: required field not set`);if(!e.alwaysEmitImplicit||r.presence!==tM)continue}const a=md(r,n.get(r),e);a!==void 0&&(s[oM(r,e)]=a)}if(e.registry){const r=new Set;for(const{no:a}of(t=n.getUnknown())!==null&&t!==void 0?t:[])if(!r.has(a)){r.add(a);const o=e.registry.getExtensionFor(n.desc,a);if(!o)continue;const c=jE(n.message,o),[l,u]=Mo(o,c),f=md(u,l.get(u),e);f!==void 0&&(s[o.jsonName]=f)}}return s}function md(n,e,t){switch(n.fieldKind){case"scalar":return Ao(n,e);case"message":return Xr(e,t);case"enum":return Gu(n.enum,e,t.enumAsInteger);case"list":return aM(e,t);case"map":return rM(e,t)}}function rM(n,e){const t=n.field(),i={};switch(t.mapKind){case"scalar":for(const[s,r]of n)i[s]=Ao(t,r);break;case"message":for(const[s,r]of n)i[s]=Xr(r,e);break;case"enum":for(const[s,r]of n)i[s]=Gu(t.enum,r,e.enumAsInteger);break}return e.alwaysEmitImplicit||n.size>0?i:void 0}function aM(n,e){const t=n.field(),i=[];switch(t.listKind){case"scalar":for(const s of n)i.push(Ao(t,s));break;case"enum":for(const s of n)i.push(Gu(t.enum,s,e.enumAsInteger));break;case"message":for(const s of n)i.push(Xr(s,e));break}return e.alwaysEmitImplicit||i.length>0?i:void 0}function Gu(n,e,t){var i;if(typeof e!="number")throw new Error(`cannot encode ${n} to JSON: expected number, got ${Bt(e)}`);if(n.typeName=="google.protobuf.NullValue")return null;if(t)return e;const s=n.value[e];return(i=s?.name)!==null&&i!==void 0?i:e}function Ao(n,e){var t,i,s,r,a,o;switch(n.scalar){case G.INT32:case G.SFIXED32:case G.SINT32:case G.FIXED32:case G.UINT32:if(typeof e!="number")throw new Error(`cannot encode ${n} to JSON: ${(t=Ki(n,e))===null||t===void 0?void 0:t.message}`);return e;case G.FLOAT:case G.DOUBLE:if(typeof e!="number")throw new Error(`cannot encode ${n} to JSON: ${(i=Ki(n,e))===null||i===void 0?void 0:i.message}`);return Number.isNaN(e)?"NaN":e===Number.POSITIVE_INFINITY?"Infinity":e===Number.NEGATIVE_INFINITY?"-Infinity":e;case G.STRING:if(typeof e!="string")throw new Error(`cannot encode ${n} to JSON: ${(s=Ki(n,e))===null||s===void 0?void 0:s.message}`);return e;case G.BOOL:if(typeof e!="boolean")throw new Error(`cannot encode ${n} to JSON: ${(r=Ki(n,e))===null||r===void 0?void 0:r.message}`);return e;case G.UINT64:case G.FIXED64:case G.INT64:case G.SFIXED64:case G.SINT64:if(typeof e!="bigint"&&typeof e!="string")throw new Error(`cannot encode ${n} to JSON: ${(a=Ki(n,e))===null||a===void 0?void 0:a.message}`);return e.toString();case G.BYTES:if(e instanceof Uint8Array)return $S(e);throw new Error(`cannot encode ${n} to JSON: ${(o=Ki(n,e))===null||o===void 0?void 0:o.message}`)}}function oM(n,e){return e.useProtoFieldName?n.name:n.jsonName}function cM(n,e){if(n.desc.typeName.startsWith("google.protobuf."))switch(n.desc.typeName){case"google.protobuf.Any":return lM(n.message,e);case"google.protobuf.Timestamp":return fM(n.message);case"google.protobuf.Duration":return uM(n.message);case"google.protobuf.FieldMask":return hM(n.message);case"google.protobuf.Struct":return Zm(n.message);case"google.protobuf.Value":return zu(n.message);case"google.protobuf.ListValue":return Ym(n.message);default:if(zr(n.desc)){const t=n.desc.fields[0];return Ao(t,n.get(t))}return}}function lM(n,e){if(n.typeUrl==="")return{};const{registry:t}=e;let i,s;if(t&&(i=YE(n,t),i&&(s=t.getMessage(i.$typeName))),!s||!i)throw new Error(`cannot encode message ${n.$typeName} to JSON: "${n.typeUrl}" is not in the type registry`);let r=Xr(Tn(s,i),e);return(s.typeName.startsWith("google.protobuf.")||r===null||Array.isArray(r)||typeof r!="object")&&(r={value:r}),r["@type"]=n.typeUrl,r}function uM(n){if(Number(n.seconds)>315576e6||Number(n.seconds)<-315576e6)throw new Error(`cannot encode message ${n.$typeName} to JSON: value out of range`);let e=n.seconds.toString();if(n.nanos!==0){let t=Math.abs(n.nanos).toString();t="0".repeat(9-t.length)+t,t.substring(3)==="000000"?t=t.substring(0,3):t.substring(6)==="000"&&(t=t.substring(0,6)),e+="."+t,n.nanos<0&&Number(n.seconds)==0&&(e="-"+e)}return e+"s"}function hM(n){return n.paths.map(e=>{if(e.match(/_[0-9]?_/g)||e.match(/[A-Z]/g))throw new Error(`cannot encode message ${n.$typeName} to JSON: lowerCamelCase of path name "`+e+'" is irreversible');return Cr(e)}).join(",")}function Zm(n){const e={};for(const[t,i]of Object.entries(n.fields))e[t]=zu(i);return e}function zu(n){switch(n.kind.case){case"nullValue":return null;case"numberValue":if(!Number.isFinite(n.kind.value))throw new Error(`${n.$typeName} cannot be NaN or Infinity`);return n.kind.value;case"boolValue":return n.kind.value;case"stringValue":return n.kind.value;case"structValue":return Zm(n.kind.value);case"listValue":return Ym(n.kind.value);default:throw new Error(`${n.$typeName} must have a value`)}}function Ym(n){return n.values.map(zu)}function fM(n){const e=Number(n.seconds)*1e3;if(e<Date.parse("0001-01-01T00:00:00Z")||e>Date.parse("9999-12-31T23:59:59Z"))throw new Error(`cannot encode message ${n.$typeName} to JSON: must be from 0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z inclusive`);if(n.nanos<0)throw new Error(`cannot encode message ${n.$typeName} to JSON: nanos must not be negative`);let t="Z";if(n.nanos>0){const i=(n.nanos+1e9).toString().substring(1);i.substring(3)==="000000"?t="."+i.substring(0,3)+"Z":i.substring(6)==="000"?t="."+i.substring(0,6)+"Z":t="."+i+"Z"}return new Date(e).toISOString().replace(".000Z",t)}const gd={ignoreUnknownFields:!1};function dM(n){return n?Object.assign(Object.assign({},gd),n):gd}function pM(n,e,t){return mM(n,SM(e,n.typeName),t)}function mM(n,e,t){const i=Tn(n);try{Ks(i,e,dM(t))}catch(s){throw qS(s)?new Error(`cannot decode ${s.field()} from JSON: ${s.message}`,{cause:s}):s}return i.message}function Ks(n,e,t){var i;if(EM(n,e,t))return;if(e==null||Array.isArray(e)||typeof e!="object")throw new Error(`cannot decode ${n.desc} from JSON: ${Bt(e)}`);const s=new Map,r=new Map;for(const a of n.desc.fields)r.set(a.name,a).set(a.jsonName,a);for(const[a,o]of Object.entries(e)){const c=r.get(a);if(c){if(c.oneof){if(o===null&&c.fieldKind=="scalar")continue;const l=s.get(c.oneof);if(l!==void 0)throw new an(c.oneof,`oneof set multiple times by ${l.name} and ${c.name}`);s.set(c.oneof,c)}_d(n,c,o,t)}else{let l;if(a.startsWith("[")&&a.endsWith("]")&&(l=(i=t.registry)===null||i===void 0?void 0:i.getExtension(a.substring(1,a.length-1)))&&l.extendee.typeName===n.desc.typeName){const[u,f,h]=Mo(l);_d(u,f,o,t),qE(n.message,l,h())}if(!l&&!t.ignoreUnknownFields)throw new Error(`cannot decode ${n.desc} from JSON: key "${a}" is unknown`)}}}function _d(n,e,t,i){switch(e.fieldKind){case"scalar":yM(n,e,t);break;case"enum":xM(n,e,t,i);break;case"message":vM(n,e,t,i);break;case"list":_M(n.get(e),t,i);break;case"map":gM(n.get(e),t,i);break}}function gM(n,e,t){if(e===null)return;const i=n.field();if(typeof e!="object"||Array.isArray(e))throw new an(i,"expected object, got "+Bt(e));for(const[s,r]of Object.entries(e)){if(r===null)throw new an(i,"map value must not be null");let a;switch(i.mapKind){case"message":const c=Tn(i.message);Ks(c,r,t),a=c;break;case"enum":if(a=Wu(i.enum,r,t.ignoreUnknownFields,!0),a===wo)return;break;case"scalar":a=Ro(i,r,!0);break}const o=bM(i.mapKey,s);n.set(o,a)}}function _M(n,e,t){if(e===null)return;const i=n.field();if(!Array.isArray(e))throw new an(i,"expected Array, got "+Bt(e));for(const s of e){if(s===null)throw new an(i,"list item must not be null");switch(i.listKind){case"message":const r=Tn(i.message);Ks(r,s,t),n.add(r);break;case"enum":const a=Wu(i.enum,s,t.ignoreUnknownFields,!0);a!==wo&&n.add(a);break;case"scalar":n.add(Ro(i,s,!0));break}}}function vM(n,e,t,i){if(t===null&&e.message.typeName!="google.protobuf.Value"){n.clear(e);return}const s=n.isSet(e)?n.get(e):Tn(e.message);Ks(s,t,i),n.set(e,s)}function xM(n,e,t,i){const s=Wu(e.enum,t,i.ignoreUnknownFields,!1);s===To?n.clear(e):s!==wo&&n.set(e,s)}function yM(n,e,t){const i=Ro(e,t,!1);i===To?n.clear(e):n.set(e,i)}const wo=Symbol();function Wu(n,e,t,i){if(e===null)return n.typeName=="google.protobuf.NullValue"?0:i?n.values[0].number:To;switch(typeof e){case"number":if(Number.isInteger(e))return e;break;case"string":const s=n.values.find(r=>r.name===e);if(s!==void 0)return s.number;if(t)return wo;break}throw new Error(`cannot decode ${n} from JSON: ${Bt(e)}`)}const To=Symbol();function Ro(n,e,t){if(e===null)return t?as(n.scalar,!1):To;switch(n.scalar){case G.DOUBLE:case G.FLOAT:if(e==="NaN")return NaN;if(e==="Infinity")return Number.POSITIVE_INFINITY;if(e==="-Infinity")return Number.NEGATIVE_INFINITY;if(typeof e=="number"){if(Number.isNaN(e))throw new an(n,"unexpected NaN number");if(!Number.isFinite(e))throw new an(n,"unexpected infinite number");break}if(typeof e=="string"){if(e===""||e.trim().length!==e.length)break;const i=Number(e);if(!Number.isFinite(i))break;return i}break;case G.INT32:case G.FIXED32:case G.SFIXED32:case G.SINT32:case G.UINT32:return Km(e);case G.BYTES:if(typeof e=="string"){if(e==="")return new Uint8Array(0);try{return yu(e)}catch(i){const s=i instanceof Error?i.message:String(i);throw new an(n,s)}}break}return e}function bM(n,e){switch(n){case G.BOOL:switch(e){case"true":return!0;case"false":return!1}return e;case G.INT32:case G.FIXED32:case G.UINT32:case G.SFIXED32:case G.SINT32:return Km(e);default:return e}}function Km(n){if(typeof n=="string"){if(n===""||n.trim().length!==n.length)return n;const e=Number(n);return Number.isNaN(e)?n:e}return n}function SM(n,e){try{return JSON.parse(n)}catch(t){const i=t instanceof Error?t.message:String(t);throw new Error(`cannot decode message ${e} from JSON: ${i}`,{cause:t})}}function EM(n,e,t){if(!n.desc.typeName.startsWith("google.protobuf."))return!1;switch(n.desc.typeName){case"google.protobuf.Any":return MM(n.message,e,t),!0;case"google.protobuf.Timestamp":return AM(n.message,e),!0;case"google.protobuf.Duration":return wM(n.message,e),!0;case"google.protobuf.FieldMask":return TM(n.message,e),!0;case"google.protobuf.Struct":return $m(n.message,e),!0;case"google.protobuf.Value":return Hu(n.message,e),!0;case"google.protobuf.ListValue":return Jm(n.message,e),!0;default:if(zr(n.desc)){const i=n.desc.fields[0];return e===null?n.clear(i):n.set(i,Ro(i,e,!0)),!0}return!1}}function MM(n,e,t){var i;if(e===null||Array.isArray(e)||typeof e!="object")throw new Error(`cannot decode message ${n.$typeName} from JSON: expected object but got ${Bt(e)}`);if(Object.keys(e).length==0)return;const s=e["@type"];if(typeof s!="string"||s=="")throw new Error(`cannot decode message ${n.$typeName} from JSON: "@type" is empty`);const r=s.includes("/")?s.substring(s.lastIndexOf("/")+1):s;if(!r.length)throw new Error(`cannot decode message ${n.$typeName} from JSON: "@type" is invalid`);const a=(i=t.registry)===null||i===void 0?void 0:i.getMessage(r);if(!a)throw new Error(`cannot decode message ${n.$typeName} from JSON: ${s} is not in the type registry`);const o=Tn(a);if(r.startsWith("google.protobuf.")&&Object.prototype.hasOwnProperty.call(e,"value")){const c=e.value;Ks(o,c,t)}else{const c=Object.assign({},e);delete c["@type"],Ks(o,c,t)}XE(o.desc,o.message,n)}function AM(n,e){if(typeof e!="string")throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Bt(e)}`);const t=e.match(/^([0-9]{4})-([0-9]{2})-([0-9]{2})T([0-9]{2}):([0-9]{2}):([0-9]{2})(?:\.([0-9]{1,9}))?(?:Z|([+-][0-9][0-9]:[0-9][0-9]))$/);if(!t)throw new Error(`cannot decode message ${n.$typeName} from JSON: invalid RFC 3339 string`);const i=Date.parse(t[1]+"-"+t[2]+"-"+t[3]+"T"+t[4]+":"+t[5]+":"+t[6]+(t[8]?t[8]:"Z"));if(Number.isNaN(i))throw new Error(`cannot decode message ${n.$typeName} from JSON: invalid RFC 3339 string`);if(i<Date.parse("0001-01-01T00:00:00Z")||i>Date.parse("9999-12-31T23:59:59Z"))throw new Error(`cannot decode message ${n.$typeName} from JSON: must be from 0001-01-01T00:00:00Z to 9999-12-31T23:59:59Z inclusive`);n.seconds=dt.parse(i/1e3),n.nanos=0,t[7]&&(n.nanos=parseInt("1"+t[7]+"0".repeat(9-t[7].length))-1e9)}function wM(n,e){if(typeof e!="string")throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Bt(e)}`);const t=e.match(/^(-?[0-9]+)(?:\.([0-9]+))?s/);if(t===null)throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Bt(e)}`);const i=Number(t[1]);if(i>315576e6||i<-315576e6)throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Bt(e)}`);if(n.seconds=dt.parse(i),typeof t[2]!="string")return;const s=t[2]+"0".repeat(9-t[2].length);n.nanos=parseInt(s),(i<0||Object.is(i,-0))&&(n.nanos=-n.nanos)}function TM(n,e){if(typeof e!="string")throw new Error(`cannot decode message ${n.$typeName} from JSON: ${Bt(e)}`);if(e==="")return;function t(i){if(i.includes("_"))throw new Error(`cannot decode message ${n.$typeName} from JSON: path names must be lowerCamelCase`);const s=i.replace(/[A-Z]/g,r=>"_"+r.toLowerCase());return s[0]==="_"?s.substring(1):s}n.paths=e.split(",").map(t)}function $m(n,e){if(typeof e!="object"||e==null||Array.isArray(e))throw new Error(`cannot decode message ${n.$typeName} from JSON ${Bt(e)}`);for(const[t,i]of Object.entries(e)){const s=dn(Hm);Hu(s,i),n.fields[t]=s}}function Hu(n,e){switch(typeof e){case"number":n.kind={case:"numberValue",value:e};break;case"string":n.kind={case:"stringValue",value:e};break;case"boolean":n.kind={case:"boolValue",value:e};break;case"object":if(e===null)n.kind={case:"nullValue",value:Hl.NULL_VALUE};else if(Array.isArray(e)){const t=dn(JE);Jm(t,e),n.kind={case:"listValue",value:t}}else{const t=dn($E);$m(t,e),n.kind={case:"structValue",value:t}}break;default:throw new Error(`cannot decode message ${n.$typeName} from JSON ${Bt(e)}`)}return n}function Jm(n,e){if(!Array.isArray(e))throw new Error(`cannot decode message ${n.$typeName} from JSON ${Bt(e)}`);for(const t of e){const i=dn(Hm);Hu(i,t),n.values.push(i)}}function vd(n){const e=De[n];return typeof e!="string"?n.toString():e[0].toLowerCase()+e.substring(1).replace(/[A-Z]/g,t=>"_"+t.toLowerCase())}class Je extends Error{constructor(e,t=De.Unknown,i,s,r){super(RM(e,t)),this.name="ConnectError",Object.setPrototypeOf(this,new.target.prototype),this.rawMessage=e,this.code=t,this.metadata=new Headers(i??{}),this.details=s??[],this.cause=r}static from(e,t=De.Unknown){return e instanceof Je?e:e instanceof Error?e.name=="AbortError"||e.name=="TimeoutError"?new Je(e.message,De.Canceled):new Je(e.message,t,void 0,void 0,e):new Je(String(e),t,void 0,void 0,e)}static[Symbol.hasInstance](e){return e instanceof Error?Object.getPrototypeOf(e)===Je.prototype?!0:e.name==="ConnectError"&&"code"in e&&typeof e.code=="number"&&"metadata"in e&&"details"in e&&Array.isArray(e.details)&&"rawMessage"in e&&typeof e.rawMessage=="string"&&"cause"in e:!1}findDetails(e){const t=e.kind==="message"?{getMessage:s=>s===e.typeName?e:void 0}:e,i=[];for(const s of this.details){if("desc"in s){t.getMessage(s.desc.typeName)&&i.push(dn(s.desc,s.value));continue}const r=t.getMessage(s.type);if(r)try{i.push(er(r,s.value))}catch{}}return i}}function RM(n,e){return n.length?`[${vd(e)}] ${n}`:`[${vd(e)}]`}function NM(n,e,t){try{const i=yu(n);return e?er(e,i,t):i}catch(i){throw Je.from(i,De.DataLoss)}}function IM(n,e){const t={};for(const i of n.methods){const s=e(i);s!=null&&(t[i.localName]=s)}return t}const xd=1;function CM(n,e,t=!1){if(e>n){let i=`message size is larger than configured readMaxBytes ${n}`;throw t&&(i=`message size ${e} is larger than configured readMaxBytes ${n}`),new Je(i,De.ResourceExhausted)}}function PM(n){return new LM(n)}class LM{constructor(e){this.readMaxBytes=e,this.header=new Uint8Array(5),this.headerView=new DataView(this.header.buffer),this.buf=[]}get byteLength(){return this.buf.reduce((e,t)=>e+t.byteLength,0)}decode(e){this.buf.push(e);const t=[];for(;;){let i=this.pop();if(!i)break;t.push(i)}return t}pop(){if(!(!this.env&&(this.env=this.head(),!this.env))&&this.cons(this.env.data)){const e=this.env;return this.env=void 0,e}}head(){if(!this.cons(this.header))return;const e=this.headerView.getUint8(0),t=this.headerView.getUint32(1);return CM(this.readMaxBytes,t,!0),{flags:e,data:new Uint8Array(t)}}cons(e){const t=e.byteLength;if(this.byteLength<t)return!1;let i=0;for(;i<t;){const s=this.buf.shift();s.byteLength>t-i?(e.set(s.subarray(0,t-i),i),this.buf.unshift(s.subarray(t-i)),i+=t-i):(e.set(s,i),i+=s.byteLength)}return!0}}function yd(n){let e;const t=PM(4294967295);return new ReadableStream({start(){e=n.getReader()},async pull(i){let s=!1;for(;!s;){const r=await e.read();if(r.done)t.byteLength>0&&i.error(new Je("protocol error: incomplete envelope",De.InvalidArgument)),i.close();else for(const a of t.decode(r.value))i.enqueue(a),s=!0}}})}function Xl(n,e){const t=new Uint8Array(e.length+5);t.set(e,5);const i=new DataView(t.buffer,t.byteOffset,t.byteLength);return i.setUint8(0,n),i.setUint32(1,e.length),t}var DM=function(n){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var e=n[Symbol.asyncIterator],t;return e?e.call(n):(n=typeof __values=="function"?__values(n):n[Symbol.iterator](),t={},i("next"),i("throw"),i("return"),t[Symbol.asyncIterator]=function(){return this},t);function i(r){t[r]=n[r]&&function(a){return new Promise(function(o,c){a=n[r](a),s(o,c,a.done,a.value)})}}function s(r,a,o,c){Promise.resolve(c).then(function(l){r({value:l,done:o})},a)}},Fr=function(n){return this instanceof Fr?(this.v=n,this):new Fr(n)},UM=function(n,e,t){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var i=t.apply(n,e||[]),s,r=[];return s=Object.create((typeof AsyncIterator=="function"?AsyncIterator:Object).prototype),o("next"),o("throw"),o("return",a),s[Symbol.asyncIterator]=function(){return this},s;function a(d){return function(g){return Promise.resolve(g).then(d,f)}}function o(d,g){i[d]&&(s[d]=function(y){return new Promise(function(p,m){r.push([d,y,p,m])>1||c(d,y)})},g&&(s[d]=g(s[d])))}function c(d,g){try{l(i[d](g))}catch(y){h(r[0][3],y)}}function l(d){d.value instanceof Fr?Promise.resolve(d.value.v).then(u,f):h(r[0][2],d)}function u(d){c("next",d)}function f(d){c("throw",d)}function h(d,g){d(g),r.shift(),r.length&&c(r[0][0],r[0][1])}},FM=function(n){var e,t;return e={},i("next"),i("throw",function(s){throw s}),i("return"),e[Symbol.iterator]=function(){return this},e;function i(s,r){e[s]=n[s]?function(a){return(t=!t)?{value:Fr(n[s](a)),done:!1}:r?r(a):a}:r}};function BM(n){return UM(this,arguments,function*(){yield Fr(yield*FM(DM(n)))})}var jm=function(n){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var e=n[Symbol.asyncIterator],t;return e?e.call(n):(n=typeof __values=="function"?__values(n):n[Symbol.iterator](),t={},i("next"),i("throw"),i("return"),t[Symbol.asyncIterator]=function(){return this},t);function i(r){t[r]=n[r]&&function(a){return new Promise(function(o,c){a=n[r](a),s(o,c,a.done,a.value)})}}function s(r,a,o,c){Promise.resolve(c).then(function(l){r({value:l,done:o})},a)}},$s=function(n){return this instanceof $s?(this.v=n,this):new $s(n)},OM=function(n){var e,t;return e={},i("next"),i("throw",function(s){throw s}),i("return"),e[Symbol.iterator]=function(){return this},e;function i(s,r){e[s]=n[s]?function(a){return(t=!t)?{value:$s(n[s](a)),done:!1}:r?r(a):a}:r}},VM=function(n,e,t){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var i=t.apply(n,e||[]),s,r=[];return s=Object.create((typeof AsyncIterator=="function"?AsyncIterator:Object).prototype),o("next"),o("throw"),o("return",a),s[Symbol.asyncIterator]=function(){return this},s;function a(d){return function(g){return Promise.resolve(g).then(d,f)}}function o(d,g){i[d]&&(s[d]=function(y){return new Promise(function(p,m){r.push([d,y,p,m])>1||c(d,y)})},g&&(s[d]=g(s[d])))}function c(d,g){try{l(i[d](g))}catch(y){h(r[0][3],y)}}function l(d){d.value instanceof $s?Promise.resolve(d.value.v).then(u,f):h(r[0][2],d)}function u(d){c("next",d)}function f(d){c("throw",d)}function h(d,g){d(g),r.shift(),r.length&&c(r[0][0],r[0][1])}};function lr(n,e){return IM(n,t=>{switch(t.methodKind){case"unary":return kM(e,t);case"server_streaming":return GM(e,t);case"client_streaming":return zM(e,t);case"bidi_streaming":return WM(e,t);default:return null}})}function kM(n,e){return async(t,i)=>{var s,r;const a=await n.unary(e,i?.signal,i?.timeoutMs,i?.headers,t,i?.contextValues);return(s=i?.onHeader)===null||s===void 0||s.call(i,a.header),(r=i?.onTrailer)===null||r===void 0||r.call(i,a.trailer),a.message}}function GM(n,e){return(t,i)=>qm(n.stream(e,i?.signal,i?.timeoutMs,i?.headers,BM([t]),i?.contextValues),i)}function zM(n,e){return async(t,i)=>{var s,r,a,o,c,l;const u=await n.stream(e,i?.signal,i?.timeoutMs,i?.headers,t,i?.contextValues);(c=i?.onHeader)===null||c===void 0||c.call(i,u.header);let f,h=0;try{for(var d=!0,g=jm(u.message),y;y=await g.next(),s=y.done,!s;d=!0)o=y.value,d=!1,f=o,h++}catch(p){r={error:p}}finally{try{!d&&!s&&(a=g.return)&&await a.call(g)}finally{if(r)throw r.error}}if(!f)throw new Je("protocol error: missing response message",De.Unimplemented);if(h>1)throw new Je("protocol error: received extra messages for client streaming method",De.Unimplemented);return(l=i?.onTrailer)===null||l===void 0||l.call(i,u.trailer),f}}function WM(n,e){return(t,i)=>qm(n.stream(e,i?.signal,i?.timeoutMs,i?.headers,t,i?.contextValues),i)}function qm(n,e){const t=(function(){return VM(this,arguments,function*(){var i,s;const r=yield $s(n);(i=e?.onHeader)===null||i===void 0||i.call(e,r.header),yield $s(yield*OM(jm(r.message))),(s=e?.onTrailer)===null||s===void 0||s.call(e,r.trailer)})})()[Symbol.asyncIterator]();return{[Symbol.asyncIterator]:()=>({next:()=>t.next()})}}function HM(...n){const e=new AbortController,t=n.filter(s=>s!==void 0).concat(e.signal);for(const s of t){if(s.aborted){i.apply(s);break}s.addEventListener("abort",i)}function i(){e.signal.aborted||e.abort(Qm(this));for(const s of t)s.removeEventListener("abort",i)}return e}function XM(n){const e=new AbortController,t=()=>{e.abort(new Je("the operation timed out",De.DeadlineExceeded))};let i;return n!==void 0&&(n<=0?t():i=setTimeout(t,n)),{signal:e.signal,cleanup:()=>clearTimeout(i)}}function Qm(n){if(!n.aborted)return;if(n.reason!==void 0)return n.reason;const e=new Error("This operation was aborted");return e.name="AbortError",e}function bd(){return{get(n){return n.id in this?this[n.id]:n.defaultValue},set(n,e){return this[n.id]=e,this},delete(n){return delete this[n.id],this}}}const eo=128;function Zl(n){const e=new Headers,t=new TextDecoder().decode(n).split(`\r
`);for(const i of t){if(i==="")continue;const s=i.indexOf(":");if(s>0){const r=i.substring(0,s).trim(),a=i.substring(s+1).trim();e.append(r,a)}}return e}const ZM="Content-Type",YM="Grpc-Timeout",Js="Grpc-Status",eg="Grpc-Message",KM="Grpc-Status-Details-Bin",$M="User-Agent",Sd="X-User-Agent",JM="X-Grpc-Web",jM="application/grpc-web+proto",qM="application/grpc-web+json",QM=On("CgxzdGF0dXMucHJvdG8SCmdvb2dsZS5ycGMiTgoGU3RhdHVzEgwKBGNvZGUYASABKAUSDwoHbWVzc2FnZRgCIAEoCRIlCgdkZXRhaWxzGAMgAygLMhQuZ29vZ2xlLnByb3RvYnVmLkFueUJeCg5jb20uZ29vZ2xlLnJwY0ILU3RhdHVzUHJvdG9QAVo3Z29vZ2xlLmdvbGFuZy5vcmcvZ2VucHJvdG8vZ29vZ2xlYXBpcy9ycGMvc3RhdHVzO3N0YXR1c6ICA1JQQ2IGcHJvdG8z",[zm]),eA=vi(QM,0),tA="0";function tg(n){var e;const t=n.get(KM);if(t!=null){const s=NM(t,eA);if(s.code==0)return;const r=new Je(s.message,s.code,n);return r.details=s.details.map(a=>({type:a.typeUrl.substring(a.typeUrl.lastIndexOf("/")+1),value:a.value})),r}const i=n.get(Js);if(i!=null){if(i===tA)return;const s=parseInt(i,10);return s in De?new Je(decodeURIComponent((e=n.get(eg))!==null&&e!==void 0?e:""),s,n):new Je(`invalid grpc-status: ${i}`,De.Internal,n)}}function Ed(n,e){return n.toString().replace(/\/?$/,`/${e.parent.typeName}/${e.name}`)}function ng(n,e){return dn(n,e)}function nA(n,e){function t(i){return i.done===!0?i:{done:i.done,value:ng(n,i.value)}}return{[Symbol.asyncIterator](){const i=e[Symbol.asyncIterator](),s={next:()=>i.next().then(t)};return i.throw!==void 0&&(s.throw=r=>i.throw(r).then(t)),i.return!==void 0&&(s.return=r=>i.return(r).then(t)),s}}}function ig(n,e){if(!e)return n;for(const t of e.concat().reverse())n=t(n);return n}function iA(n){var e;const t=Object.assign({},n);return(e=t.ignoreUnknownFields)!==null&&e!==void 0||(t.ignoreUnknownFields=!0),t}function Md(n,e,t,i){const s=e?Ad(n.input,i):wd(n.input,t);return{parse:(e?Ad(n.output,i):wd(n.output,t)).parse,serialize:s.serialize}}function Ad(n,e){return{parse(t){try{return er(n,t,e)}catch(i){const s=i instanceof Error?i.message:String(i);throw new Je(`parse binary: ${s}`,De.Internal)}},serialize(t){try{return Uu(n,t,e)}catch(i){const s=i instanceof Error?i.message:String(i);throw new Je(`serialize binary: ${s}`,De.Internal)}}}}function wd(n,e){var t,i;const s=(t=e?.textEncoder)!==null&&t!==void 0?t:new TextEncoder,r=(i=e?.textDecoder)!==null&&i!==void 0?i:new TextDecoder,a=iA(e);return{parse(o){try{const c=r.decode(o);return pM(n,c,a)}catch(c){throw Je.from(c,De.InvalidArgument)}},serialize(o){try{const c=sM(n,o,a);return s.encode(c)}catch(c){throw Je.from(c,De.Internal)}}}}function sA(n){const e=ig(n.next,n.interceptors),[t,i,s]=sg(n),r=Object.assign(Object.assign({},n.req),{message:ng(n.req.method.input,n.req.message),signal:t});return e(r).then(a=>(s(),a),i)}function rA(n){const e=ig(n.next,n.interceptors),[t,i,s]=sg(n),r=Object.assign(Object.assign({},n.req),{message:nA(n.req.method.input,n.req.message),signal:t});let a=!1;return t.addEventListener("abort",function(){var o,c;const l=n.req.message[Symbol.asyncIterator]();a||(o=l.throw)===null||o===void 0||o.call(l,this.reason).catch(()=>{}),(c=l.return)===null||c===void 0||c.call(l).catch(()=>{})}),e(r).then(o=>Object.assign(Object.assign({},o),{message:{[Symbol.asyncIterator](){const c=o.message[Symbol.asyncIterator]();return{next(){return c.next().then(l=>(l.done==!0&&(a=!0,s()),l),i)}}}}}),i)}function sg(n){const{signal:e,cleanup:t}=XM(n.timeoutMs),i=HM(n.signal,e);return[i.signal,function(r){const a=Je.from(e.aborted?Qm(e):r);return i.abort(a),t(),Promise.reject(a)},function(){t(),i.abort()}]}function zs(n){if(n instanceof DOMException&&n.name==="AbortError")return"cancelled";if(n instanceof TypeError)return"gone";if(!(n instanceof Je)||aA(n))return"refused";switch(n.code){case De.Canceled:return"cancelled";case De.Unauthenticated:case De.PermissionDenied:return"token";case De.Unavailable:return"gone";case De.NotFound:return"forgotten";case De.ResourceExhausted:return rg(n)===void 0?"refused":"full";default:return n.code===De.Unknown?"gone":"refused"}}function rg(n){const e=n instanceof Je?n.metadata.get("grpc-retry-pushback-ms"):null;return e!==null&&/^\d+$/.test(e)?Number(e):void 0}function ur(n){switch(zs(n)){case"cancelled":return"Stopped.";case"gone":return"The server does not answer.";case"forgotten":return"The server has lost this mesh.";default:return n instanceof Je?Td(oA(n.rawMessage)):Td(n instanceof Error?n.message:String(n))}}function aA(n){return/^HTTP 4\d\d$/.test(n.rawMessage)&&n.rawMessage!=="HTTP 429"}function oA(n){switch(n){case"HTTP 403":return`The server answers no page of ${location.origin}: its flag --web-allow-origin must name this address.`;case"HTTP 413":return"The server, or a proxy before it, refuses files of this size.";default:return n}}function Td(n){const e=n.trim()||"It failed for an unknown reason";return e[0].toUpperCase()+e.slice(1)+(/[.!?]$/.test(e)?"":".")}async function ag(n,e){try{return await n()}catch(t){if(zs(t)!=="forgotten"||!await e())throw t;return n()}}const Xu=On("ChZnZW9kZXNpYy92MS9tZXNoLnByb3RvEgtnZW9kZXNpYy52MSKHAQoKRmlsZURpZ2VzdBInCgZmb3JtYXQYASABKA4yFy5nZW9kZXNpYy52MS5NZXNoRm9ybWF0Eg4KBnNoYTI1NhgCIAEoCRIaCg13ZWxkX2Rpc3RhbmNlGAMgASgBSACIAQESEgoKa2VlcF9zZWFtcxgEIAEoCEIQCg5fd2VsZF9kaXN0YW5jZSIoCgVQb2ludBIJCgF4GAEgASgBEgkKAXkYAiABKAESCQoBehgDIAEoASKvBQoETWVzaBIOCgZkaWdlc3QYASABKAkSFAoMdmVydGV4X2NvdW50GAIgASgEEhIKCmZhY2VfY291bnQYAyABKAQSEgoKZWRnZV9jb3VudBgEIAEoBBIbChNib3VuZGFyeV9lZGdlX2NvdW50GAUgASgEEhsKE2JvdW5kYXJ5X2xvb3BfY291bnQYBiABKAQSFwoPY29tcG9uZW50X2NvdW50GAcgASgEEh0KFWlzb2xhdGVkX3ZlcnRleF9jb3VudBgIIAEoBBISCgVnZW51cxgJIAEoA0gAiAEBEhsKE3NhZGRsZV92ZXJ0ZXhfY291bnQYCiABKAQSHQoVZGVnZW5lcmF0ZV9mYWNlX2NvdW50GAsgASgEEiwKEGJvdW5kaW5nX2JveF9taW4YDCABKAsyEi5nZW9kZXNpYy52MS5Qb2ludBIsChBib3VuZGluZ19ib3hfbWF4GA0gASgLMhIuZ2VvZGVzaWMudjEuUG9pbnQSGAoQbWVhbl9lZGdlX2xlbmd0aBgOIAEoARISCgphbmlzb3Ryb3B5GA8gASgBEhYKDnJlc2lkZW50X2J5dGVzGBAgASgEEh8KF25vbl9tYW5pZm9sZF9lZGdlX2NvdW50GBEgASgEEiEKGW5vbl9tYW5pZm9sZF92ZXJ0ZXhfY291bnQYEiABKAQSHwoXaW5jb25zaXN0ZW50X2VkZ2VfY291bnQYEyABKAQSEgoKb3JpZW50YWJsZRgUIAEoCBIUCgxzdG9yZWRfYnl0ZXMYFSABKAQSFgoObGFuZG1hcmtfY291bnQYFiABKA0SNQoQcHJlcGFyZWRfbWV0aG9kcxgXIAMoCzIbLmdlb2Rlc2ljLnYxLlByZXBhcmVkTWV0aG9kEg0KBW5vdGVzGBggAygJQggKBl9nZW51cyKfAQoOUHJlcGFyZWRNZXRob2QSKQoJYWxnb3JpdGhtGAEgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEjEKDWFwcHJveGltYXRpb24YAiABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uEhYKDnByZXBhcmVkX2J5dGVzGAMgASgEEhcKD3ByZXBhcmVfc2Vjb25kcxgEIAEoASrVAQoKTWVzaEZvcm1hdBIbChdNRVNIX0ZPUk1BVF9VTlNQRUNJRklFRBAAEhYKEk1FU0hfRk9STUFUX0FSUkFZUxABEhMKD01FU0hfRk9STUFUX09CShACEhMKD01FU0hfRk9STUFUX1BMWRADEhMKD01FU0hfRk9STUFUX09GRhAEEhMKD01FU0hfRk9STUFUX1NUTBAFEhMKD01FU0hfRk9STUFUX1ZUSxAGEhQKEE1FU0hfRk9STUFUX0dMVEYQBxITCg9NRVNIX0ZPUk1BVF9WVFAQCGIGcHJvdG8z",[Hr]);var ai=(n=>(n[n.UNSPECIFIED=0]="UNSPECIFIED",n[n.ARRAYS=1]="ARRAYS",n[n.OBJ=2]="OBJ",n[n.PLY=3]="PLY",n[n.OFF=4]="OFF",n[n.STL=5]="STL",n[n.VTK=6]="VTK",n[n.GLTF=7]="GLTF",n[n.VTP=8]="VTP",n))(ai||{});const Zu=On("ChlnZW9kZXNpYy92MS9zdXJmYWNlLnByb3RvEgtnZW9kZXNpYy52MSJ5CgxTdXJmYWNlUG9pbnQSEAoGdmVydGV4GAEgASgESAASJgoEZWRnZRgCIAEoCzIWLmdlb2Rlc2ljLnYxLkVkZ2VQb2ludEgAEiYKBGZhY2UYAyABKAsyFi5nZW9kZXNpYy52MS5GYWNlUG9pbnRIAEIHCgVwbGFjZSIwCglFZGdlUG9pbnQSDAoEZnJvbRgBIAEoBBIKCgJ0bxgCIAEoBBIJCgF0GAMgASgBIioKCUZhY2VQb2ludBIMCgRmYWNlGAEgASgEEg8KB3dlaWdodHMYAiADKAEiMgoFQ3VydmUSKQoGcG9pbnRzGAEgAygLMhkuZ2VvZGVzaWMudjEuU3VyZmFjZVBvaW50IqgBCgZTb3VyY2USEAoGdmVydGV4GAEgASgESAASJgoEZWRnZRgDIAEoCzIWLmdlb2Rlc2ljLnYxLkVkZ2VQb2ludEgAEiYKBGZhY2UYBCABKAsyFi5nZW9kZXNpYy52MS5GYWNlUG9pbnRIABIjCgVjdXJ2ZRgFIAEoCzISLmdlb2Rlc2ljLnYxLkN1cnZlSAASDgoGb2Zmc2V0GAIgASgBQgcKBXBsYWNlIncKDVBvbHlsaW5lUGllY2USEwoLcG9pbnRfY291bnQYASABKAQSEwoLZmlyc3RfcG9pbnQYAiABKAQSKQoGcG9pbnRzGAMgAygLMhkuZ2VvZGVzaWMudjEuU3VyZmFjZVBvaW50EhEKCXBvc2l0aW9ucxgEIAEoDGIGcHJvdG8z"),cA=On("Ch9nZW9kZXNpYy92MS9maWVsZF9zZXJ2aWNlLnByb3RvEgtnZW9kZXNpYy52MSKkBAoTQ29tcHV0ZUZpZWxkUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIkCgdzb3VyY2VzGAIgAygLMhMuZ2VvZGVzaWMudjEuU291cmNlEikKCWFsZ29yaXRobRgDIAEoDjIWLmdlb2Rlc2ljLnYxLkFsZ29yaXRobRIqCgp2YWx1ZV90eXBlGAQgASgOMhYuZ2VvZGVzaWMudjEuVmFsdWVUeXBlEioKB3RhcmdldHMYBSADKAsyGS5nZW9kZXNpYy52MS5TdXJmYWNlUG9pbnQSEwoGcmFkaXVzGAYgASgBSACIAQESHwoSc3RvcF9hZnRlcl90YXJnZXRzGAcgASgESAGIAQESLgoKcXVhbnRpdGllcxgIIAMoDjIaLmdlb2Rlc2ljLnYxLkZpZWxkUXVhbnRpdHkSEwoLcHJvZ3Jlc3NpdmUYCSABKAgSJwoIcHJpb3JpdHkYCiABKA4yFS5nZW9kZXNpYy52MS5Qcmlvcml0eRIwCgpyZXN1bXB0aW9uGAsgASgLMhwuZ2VvZGVzaWMudjEuRmllbGRSZXN1bXB0aW9uEjEKDWFwcHJveGltYXRpb24YDCABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uEhYKCXRvbGVyYW5jZRgNIAEoAUgCiAEBQgkKB19yYWRpdXNCFQoTX3N0b3BfYWZ0ZXJfdGFyZ2V0c0IMCgpfdG9sZXJhbmNlIjkKD0ZpZWxkUmVzdW1wdGlvbhIQCghmaWVsZF9pZBgBIAEoCRIUCgxmaXJzdF92ZXJ0ZXgYAiABKAQirQIKFENvbXB1dGVGaWVsZFJlc3BvbnNlEioKBmhlYWRlchgBIAEoCzIYLmdlb2Rlc2ljLnYxLkZpZWxkSGVhZGVySAASLgoIcHJvZ3Jlc3MYAiABKAsyGi5nZW9kZXNpYy52MS5Tb2x2ZVByb2dyZXNzSAASKAoFY2h1bmsYAyABKAsyFy5nZW9kZXNpYy52MS5GaWVsZENodW5rSAASLAoHdHJhaWxlchgEIAEoCzIZLmdlb2Rlc2ljLnYxLkZpZWxkVHJhaWxlckgAEisKB3RhcmdldHMYBSABKAsyGC5nZW9kZXNpYy52MS5UYXJnZXRDaHVua0gAEiwKB3NldHRsZWQYBiABKAsyGS5nZW9kZXNpYy52MS5TZXR0bGVkQ2h1bmtIAEIGCgRwYXJ0IoICCgtGaWVsZEhlYWRlchITCgttZXNoX2RpZ2VzdBgBIAEoCRIUCgx2ZXJ0ZXhfY291bnQYAiABKAQSKQoJYWxnb3JpdGhtGAMgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEigKBm9yaWdpbhgEIAEoDjIYLmdlb2Rlc2ljLnYxLkZpZWxkT3JpZ2luEioKCnZhbHVlX3R5cGUYBSABKA4yFi5nZW9kZXNpYy52MS5WYWx1ZVR5cGUSFAoMdGFyZ2V0X2NvdW50GAYgASgEEjEKDWFwcHJveGltYXRpb24YByABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uIocBCgpGaWVsZENodW5rEg4KBm9mZnNldBgBIAEoBBIRCglkaXN0YW5jZXMYAiABKAwSFwoPbmVhcmVzdF9zb3VyY2VzGAMgASgMEhEKCWdyYWRpZW50cxgEIAEoDBIQCghmaWVsZF9pZBgFIAEoCRIYChBjZXJ0aWZpZWRfZXJyb3JzGAYgASgMIjAKC1RhcmdldENodW5rEg4KBm9mZnNldBgBIAEoBBIRCglkaXN0YW5jZXMYAiABKAwiQwoMU2V0dGxlZENodW5rEhAKCHZlcnRpY2VzGAEgASgMEhEKCWRpc3RhbmNlcxgCIAEoDBIOCgZvZmZzZXQYAyABKAQi6AEKDEZpZWxkVHJhaWxlchIoCgZvcmlnaW4YASABKA4yGC5nZW9kZXNpYy52MS5GaWVsZE9yaWdpbhIwCgpzdGF0aXN0aWNzGAIgASgLMhwuZ2VvZGVzaWMudjEuU29sdmVTdGF0aXN0aWNzEhoKEnJlbGF0aXZlX3RvbGVyYW5jZRgDIAEoARIWCg5zZXJ2ZXJfdmVyc2lvbhgEIAEoCRIWCg5zZXR0bGVkX3JhZGl1cxgFIAEoARIcCg9jZXJ0aWZpZWRfZXJyb3IYBiABKAFIAIgBAUISChBfY2VydGlmaWVkX2Vycm9yIvYBChRDb21wdXRlTG9nTWFwUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIpCgZzb3VyY2UYAiABKAsyGS5nZW9kZXNpYy52MS5TdXJmYWNlUG9pbnQSKQoJYWxnb3JpdGhtGAMgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEioKCnZhbHVlX3R5cGUYBCABKA4yFi5nZW9kZXNpYy52MS5WYWx1ZVR5cGUSEwoGcmFkaXVzGAUgASgBSACIAQESJwoIcHJpb3JpdHkYBiABKA4yFS5nZW9kZXNpYy52MS5Qcmlvcml0eUIJCgdfcmFkaXVzIoECChVDb21wdXRlTG9nTWFwUmVzcG9uc2USKwoGaGVhZGVyGAEgASgLMhkuZ2VvZGVzaWMudjEuQW5zd2VySGVhZGVySAASLgoIcHJvZ3Jlc3MYAiABKAsyGi5nZW9kZXNpYy52MS5Tb2x2ZVByb2dyZXNzSAASKQoFZnJhbWUYAyABKAsyGC5nZW9kZXNpYy52MS5Mb2dNYXBGcmFtZUgAEikKBWNodW5rGAQgASgLMhguZ2VvZGVzaWMudjEuTG9nTWFwQ2h1bmtIABItCgd0cmFpbGVyGAUgASgLMhouZ2VvZGVzaWMudjEuQW5zd2VyVHJhaWxlckgAQgYKBHBhcnQiOQoLTG9nTWFwRnJhbWUSKgoOemVyb19kaXJlY3Rpb24YASABKAsyEi5nZW9kZXNpYy52MS5Qb2ludCIyCgtMb2dNYXBDaHVuaxIOCgZvZmZzZXQYASABKAQSEwoLY29vcmRpbmF0ZXMYAiABKAwi4QEKG1NhbXBsZUZhcnRoZXN0UG9pbnRzUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIkCgdzb3VyY2VzGAIgAygLMhMuZ2VvZGVzaWMudjEuU291cmNlEg0KBWNvdW50GAMgASgEEikKCWFsZ29yaXRobRgEIAEoDjIWLmdlb2Rlc2ljLnYxLkFsZ29yaXRobRInCghwcmlvcml0eRgFIAEoDjIVLmdlb2Rlc2ljLnYxLlByaW9yaXR5EhYKCXRvbGVyYW5jZRgGIAEoAUgAiAEBQgwKCl90b2xlcmFuY2Ui3wEKHFNhbXBsZUZhcnRoZXN0UG9pbnRzUmVzcG9uc2USKwoGaGVhZGVyGAEgASgLMhkuZ2VvZGVzaWMudjEuQW5zd2VySGVhZGVySAASLgoIcHJvZ3Jlc3MYAiABKAsyGi5nZW9kZXNpYy52MS5Tb2x2ZVByb2dyZXNzSAASKwoHc2FtcGxlcxgDIAEoCzIYLmdlb2Rlc2ljLnYxLlNhbXBsZUNodW5rSAASLQoHdHJhaWxlchgEIAEoCzIaLmdlb2Rlc2ljLnYxLkFuc3dlclRyYWlsZXJIAEIGCgRwYXJ0IjsKC1NhbXBsZUNodW5rEiwKB3NhbXBsZXMYASADKAsyGy5nZW9kZXNpYy52MS5GYXJ0aGVzdFNhbXBsZSIyCg5GYXJ0aGVzdFNhbXBsZRIOCgZ2ZXJ0ZXgYASABKAQSEAoIZGlzdGFuY2UYAiABKAEqkwEKDUZpZWxkUXVhbnRpdHkSHgoaRklFTERfUVVBTlRJVFlfVU5TUEVDSUZJRUQQABIhCh1GSUVMRF9RVUFOVElUWV9ORUFSRVNUX1NPVVJDRRABEhsKF0ZJRUxEX1FVQU5USVRZX0dSQURJRU5UEAISIgoeRklFTERfUVVBTlRJVFlfQ0VSVElGSUVEX0VSUk9SEAMqfgoLRmllbGRPcmlnaW4SHAoYRklFTERfT1JJR0lOX1VOU1BFQ0lGSUVEEAASGQoVRklFTERfT1JJR0lOX0NPTVBVVEVEEAESFwoTRklFTERfT1JJR0lOX0pPSU5FRBACEhcKE0ZJRUxEX09SSUdJTl9DQUNIRUQQAyIECAQQBDKuAgoMRmllbGRTZXJ2aWNlElUKDENvbXB1dGVGaWVsZBIgLmdlb2Rlc2ljLnYxLkNvbXB1dGVGaWVsZFJlcXVlc3QaIS5nZW9kZXNpYy52MS5Db21wdXRlRmllbGRSZXNwb25zZTABElgKDUNvbXB1dGVMb2dNYXASIS5nZW9kZXNpYy52MS5Db21wdXRlTG9nTWFwUmVxdWVzdBoiLmdlb2Rlc2ljLnYxLkNvbXB1dGVMb2dNYXBSZXNwb25zZTABEm0KFFNhbXBsZUZhcnRoZXN0UG9pbnRzEiguZ2VvZGVzaWMudjEuU2FtcGxlRmFydGhlc3RQb2ludHNSZXF1ZXN0GikuZ2VvZGVzaWMudjEuU2FtcGxlRmFydGhlc3RQb2ludHNSZXNwb25zZTABYgZwcm90bzM",[Xu,Hr,Zu]);var og=(n=>(n[n.UNSPECIFIED=0]="UNSPECIFIED",n[n.NEAREST_SOURCE=1]="NEAREST_SOURCE",n[n.GRADIENT=2]="GRADIENT",n[n.CERTIFIED_ERROR=3]="CERTIFIED_ERROR",n))(og||{});const lA=Wr(cA,0);function uA(){try{new Headers}catch{throw new Error("connect-web requires the fetch API. Are you running on an old version of Node.js? Node.js is not supported in Connect for Web - please stay tuned for Connect for Node.")}}function Yl(n,e){const t=tg(n);if(t)throw e.forEach((i,s)=>{t.metadata.append(s,i)}),t;if(!e.has(Js)&&!n.has(Js))throw new Je("protocol error: missing status",De.Internal)}function Rd(n,e,t,i){var s,r;const a=new Headers(t??{});a.set(ZM,n?jM:qM),a.set(JM,"1");const o=(r=(s=a.get($M))!==null&&s!==void 0?s:a.get(Sd))!==null&&r!==void 0?r:"connect-es/2.0.4";return a.set(Sd,o),e!==void 0&&a.set(YM,`${e}m`),a}function hA(n){switch(n){case 400:return De.Internal;case 401:return De.Unauthenticated;case 403:return De.PermissionDenied;case 404:return De.Unimplemented;case 429:return De.Unavailable;case 502:return De.Unavailable;case 503:return De.Unavailable;case 504:return De.Unavailable;default:return De.Unknown}}function Kl(n,e){var t;if(n>=200&&n<300)return{foundStatus:e.has(Js),headerError:tg(e)};throw new Je(decodeURIComponent((t=e.get(eg))!==null&&t!==void 0?t:`HTTP ${n}`),hA(n),e)}var Qi=function(n){return this instanceof Qi?(this.v=n,this):new Qi(n)},fA=function(n,e,t){if(!Symbol.asyncIterator)throw new TypeError("Symbol.asyncIterator is not defined.");var i=t.apply(n,e||[]),s,r=[];return s=Object.create((typeof AsyncIterator=="function"?AsyncIterator:Object).prototype),o("next"),o("throw"),o("return",a),s[Symbol.asyncIterator]=function(){return this},s;function a(d){return function(g){return Promise.resolve(g).then(d,f)}}function o(d,g){i[d]&&(s[d]=function(y){return new Promise(function(p,m){r.push([d,y,p,m])>1||c(d,y)})},g&&(s[d]=g(s[d])))}function c(d,g){try{l(i[d](g))}catch(y){h(r[0][3],y)}}function l(d){d.value instanceof Qi?Promise.resolve(d.value.v).then(u,f):h(r[0][2],d)}function u(d){c("next",d)}function f(d){c("throw",d)}function h(d,g){d(g),r.shift(),r.length&&c(r[0][0],r[0][1])}};const Nd={redirect:"error"};function dA(n){var e;uA();const t=(e=n.useBinaryFormat)!==null&&e!==void 0?e:!0;return{async unary(i,s,r,a,o,c){const{serialize:l,parse:u}=Md(i,t,n.jsonOptions,n.binaryOptions);return r=r===void 0?n.defaultTimeoutMs:r<=0?void 0:r,await sA({interceptors:n.interceptors,signal:s,timeoutMs:r,req:{stream:!1,service:i.parent,method:i,requestMethod:"POST",url:Ed(n.baseUrl,i),header:Rd(t,r,a),contextValues:c??bd(),message:o},next:async f=>{var h;const g=await((h=n.fetch)!==null&&h!==void 0?h:globalThis.fetch)(f.url,Object.assign(Object.assign({},Nd),{method:f.requestMethod,headers:f.header,signal:f.signal,body:Xl(0,l(f.message))})),{headerError:y}=Kl(g.status,g.headers);if(!g.body)throw y!==void 0?y:"missing response body";const p=yd(g.body).getReader();let m,v;for(;;){const b=await p.read();if(b.done)break;const{flags:x,data:E}=b.value;if((x&xd)===xd)throw new Je("protocol error: received unsupported compressed output",De.Internal);if(x===eo){if(m!==void 0)throw"extra trailer";m=Zl(E);continue}if(v!==void 0)throw new Je("extra message",De.Unimplemented);v=u(E)}if(m===void 0)throw y!==void 0?y:new Je("missing trailer",g.headers.has(Js)?De.Unimplemented:De.Unknown);if(Yl(m,g.headers),v===void 0)throw new Je("missing message",m.has(Js)?De.Unimplemented:De.Unknown);return{stream:!1,service:i.parent,method:i,header:g.headers,message:v,trailer:m}}})},async stream(i,s,r,a,o,c){const{serialize:l,parse:u}=Md(i,t,n.jsonOptions,n.binaryOptions);function f(d,g,y,p,m){return fA(this,arguments,function*(){const b=yd(d).getReader();if(g){if(!(yield Qi(b.read())).done)throw"extra data for trailers-only";return yield Qi(void 0)}let x=!1;for(;;){const E=yield Qi(b.read());if(E.done)break;const{flags:w,data:T}=E.value;if((w&eo)===eo){if(x)throw"extra trailer";x=!0;const _=Zl(T);Yl(_,p),_.forEach((M,N)=>y.set(N,M));continue}if(x)throw"extra message";yield yield Qi(u(T))}if("throwIfAborted"in m&&m.throwIfAborted(),!x)throw"missing trailer"})}async function h(d){if(i.methodKind!="server_streaming")throw"The fetch API does not support streaming request bodies";const g=await d[Symbol.asyncIterator]().next();if(g.done==!0)throw"missing request message";return Xl(0,l(g.value))}return r=r===void 0?n.defaultTimeoutMs:r<=0?void 0:r,rA({interceptors:n.interceptors,signal:s,timeoutMs:r,req:{stream:!0,service:i.parent,method:i,requestMethod:"POST",url:Ed(n.baseUrl,i),header:Rd(t,r,a),contextValues:c??bd(),message:o},next:async d=>{var g;const p=await((g=n.fetch)!==null&&g!==void 0?g:globalThis.fetch)(d.url,Object.assign(Object.assign({},Nd),{method:d.requestMethod,headers:d.header,signal:d.signal,body:await h(d.message)})),{foundStatus:m,headerError:v}=Kl(p.status,p.headers);if(v!=null)throw v;if(!p.body)throw"missing response body";const b=new Headers;return Object.assign(Object.assign({},d),{header:p.headers,trailer:b,message:f(p.body,m,b,p.headers,d.signal)})}})}}}const pA=On("CiZnZW9kZXNpYy92MS9jYXBhYmlsaXRpZXNfc2VydmljZS5wcm90bxILZ2VvZGVzaWMudjEiGAoWR2V0Q2FwYWJpbGl0aWVzUmVxdWVzdCLxAQoXR2V0Q2FwYWJpbGl0aWVzUmVzcG9uc2USDwoHdmVyc2lvbhgBIAEoCRI0CgphbGdvcml0aG1zGAIgAygLMiAuZ2VvZGVzaWMudjEuQWxnb3JpdGhtQ2FwYWJpbGl0eRIoCgdmb3JtYXRzGAMgAygOMhcuZ2VvZGVzaWMudjEuTWVzaEZvcm1hdBIjCgZsaW1pdHMYBCABKAsyEy5nZW9kZXNpYy52MS5MaW1pdHMSQAoWYXBwcm94aW1hdGVfYWxnb3JpdGhtcxgFIAMoCzIgLmdlb2Rlc2ljLnYxLkFsZ29yaXRobUNhcGFiaWxpdHkicwoTQWxnb3JpdGhtQ2FwYWJpbGl0eRIpCglhbGdvcml0aG0YASABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SDAoEbmFtZRgCIAEoCRIPCgdzdW1tYXJ5GAMgASgJEhIKCmlzX2RlZmF1bHQYBCABKAgiwAQKBkxpbWl0cxIYChBtYXhfdXBsb2FkX2J5dGVzGAEgASgEEhQKDG1heF92ZXJ0aWNlcxgCIAEoBBIRCgltYXhfZmFjZXMYAyABKAQSEwoLbWF4X3NvdXJjZXMYBCABKAQSGQoRbWF4X21lc3NhZ2VfYnl0ZXMYBSABKAQSGwoTbWF4X2NvbmN1cnJlbnRfam9icxgGIAEoBBIXCg9tYXhfcXVldWVkX2pvYnMYByABKAQSGAoQbWVzaF9zdG9yZV9ieXRlcxgIIAEoBBIZChFmaWVsZF9jYWNoZV9ieXRlcxgJIAEoBBIYChBtYXhfY3VydmVfcG9pbnRzGAogASgEEhMKC21heF90YXJnZXRzGAsgASgEEhIKCm1heF9sZXZlbHMYDCABKAQSEwoLbWF4X3NhbXBsZXMYDSABKAQSFwoPbWF4X21hdHJpeF9yb3dzGA4gASgEEhkKEW1heF9tYXRyaXhfdmFsdWVzGA8gASgEEhcKD21lc2hfZGlza19ieXRlcxgRIAEoBBIYChBmaWVsZF9kaXNrX2J5dGVzGBIgASgEEiIKGm1heF9xdWV1ZWRfam9ic19wZXJfY2xpZW50GBMgASgEEhEKCW1heF9wYWlycxgUIAEoBBIdChVsYW5kbWFya19tZW1vcnlfYnl0ZXMYFSABKAQSHQoVcHJlcGFyZWRfbWVtb3J5X2J5dGVzGBYgASgEEh4KFmRlY2ltYXRlZF9tZW1vcnlfYnl0ZXMYFyABKARKBAgQEBEycwoTQ2FwYWJpbGl0aWVzU2VydmljZRJcCg9HZXRDYXBhYmlsaXRpZXMSIy5nZW9kZXNpYy52MS5HZXRDYXBhYmlsaXRpZXNSZXF1ZXN0GiQuZ2VvZGVzaWMudjEuR2V0Q2FwYWJpbGl0aWVzUmVzcG9uc2ViBnByb3RvMw",[Xu,Hr]),mA=Wr(pA,0),No=On("Ch5nZW9kZXNpYy92MS9tZXNoX3NlcnZpY2UucHJvdG8SC2dlb2Rlc2ljLnYxIlgKGEZpbmRNaXNzaW5nTWVzaGVzUmVxdWVzdBIUCgxtZXNoX2RpZ2VzdHMYASADKAkSJgoFZmlsZXMYAiADKAsyFy5nZW9kZXNpYy52MS5GaWxlRGlnZXN0IpYBChlGaW5kTWlzc2luZ01lc2hlc1Jlc3BvbnNlEhwKFG1pc3NpbmdfbWVzaF9kaWdlc3RzGAEgAygJEi4KDW1pc3NpbmdfZmlsZXMYAiADKAsyFy5nZW9kZXNpYy52MS5GaWxlRGlnZXN0EisKC2tub3duX2ZpbGVzGAMgAygLMhYuZ2VvZGVzaWMudjEuS25vd25GaWxlIkcKCUtub3duRmlsZRIlCgRmaWxlGAEgASgLMhcuZ2VvZGVzaWMudjEuRmlsZURpZ2VzdBITCgttZXNoX2RpZ2VzdBgCIAEoCSJzChFDcmVhdGVNZXNoUmVxdWVzdBIrCgZoZWFkZXIYASABKAsyGS5nZW9kZXNpYy52MS5VcGxvYWRIZWFkZXJIABIpCgVjaHVuaxgCIAEoCzIYLmdlb2Rlc2ljLnYxLlVwbG9hZENodW5rSABCBgoEcGFydCLQAQoMVXBsb2FkSGVhZGVyEicKBmZvcm1hdBgBIAEoDjIXLmdlb2Rlc2ljLnYxLk1lc2hGb3JtYXQSEgoKc2l6ZV9ieXRlcxgCIAEoBBIUCgx2ZXJ0ZXhfY291bnQYAyABKAQSEgoKZmFjZV9jb3VudBgEIAEoBBIXCg9leHBlY3RlZF9kaWdlc3QYBSABKAkSGgoNd2VsZF9kaXN0YW5jZRgGIAEoAUgAiAEBEhIKCmtlZXBfc2VhbXMYByABKAhCEAoOX3dlbGRfZGlzdGFuY2UiKwoLVXBsb2FkQ2h1bmsSDgoGb2Zmc2V0GAEgASgEEgwKBGRhdGEYAiABKAwiTwoSQ3JlYXRlTWVzaFJlc3BvbnNlEh8KBG1lc2gYASABKAsyES5nZW9kZXNpYy52MS5NZXNoEhgKEGFscmVhZHlfcmVzaWRlbnQYAiABKAgiIAoOR2V0TWVzaFJlcXVlc3QSDgoGZGlnZXN0GAEgASgJIjIKD0dldE1lc2hSZXNwb25zZRIfCgRtZXNoGAEgASgLMhEuZ2VvZGVzaWMudjEuTWVzaCIhCg9SZWFkTWVzaFJlcXVlc3QSDgoGZGlnZXN0GAEgASgJIqABChBSZWFkTWVzaFJlc3BvbnNlEi0KBmhlYWRlchgBIAEoCzIbLmdlb2Rlc2ljLnYxLlJlYWRNZXNoSGVhZGVySAASLAoIdmVydGljZXMYAiABKAsyGC5nZW9kZXNpYy52MS5WZXJ0ZXhDaHVua0gAEicKBWZhY2VzGAMgASgLMhYuZ2VvZGVzaWMudjEuRmFjZUNodW5rSABCBgoEcGFydCJKCg5SZWFkTWVzaEhlYWRlchIOCgZkaWdlc3QYASABKAkSFAoMdmVydGV4X2NvdW50GAIgASgEEhIKCmZhY2VfY291bnQYAyABKAQiNgoLVmVydGV4Q2h1bmsSFAoMZmlyc3RfdmVydGV4GAEgASgEEhEKCXBvc2l0aW9ucxgCIAEoDCIwCglGYWNlQ2h1bmsSEgoKZmlyc3RfZmFjZRgBIAEoBBIPCgdpbmRpY2VzGAIgASgMIjgKE0RlY2ltYXRlTWVzaFJlcXVlc3QSDgoGZGlnZXN0GAEgASgJEhEKCW1heF9mYWNlcxgCIAEoBCJ6ChREZWNpbWF0ZU1lc2hSZXNwb25zZRIxCgZoZWFkZXIYASABKAsyHy5nZW9kZXNpYy52MS5EZWNpbWF0ZU1lc2hIZWFkZXJIABInCgVmYWNlcxgCIAEoCzIWLmdlb2Rlc2ljLnYxLkZhY2VDaHVua0gAQgYKBHBhcnQiOAoSRGVjaW1hdGVNZXNoSGVhZGVyEg4KBmRpZ2VzdBgBIAEoCRISCgpmYWNlX2NvdW50GAIgASgEIjoKEUxpc3RNZXNoZXNSZXF1ZXN0EhEKCXBhZ2Vfc2l6ZRgBIAEoBRISCgpwYWdlX3Rva2VuGAIgASgJIlAKEkxpc3RNZXNoZXNSZXNwb25zZRIhCgZtZXNoZXMYASADKAsyES5nZW9kZXNpYy52MS5NZXNoEhcKD25leHRfcGFnZV90b2tlbhgCIAEoCSIjChFEZWxldGVNZXNoUmVxdWVzdBIOCgZkaWdlc3QYASABKAkiFAoSRGVsZXRlTWVzaFJlc3BvbnNlMsgECgtNZXNoU2VydmljZRJiChFGaW5kTWlzc2luZ01lc2hlcxIlLmdlb2Rlc2ljLnYxLkZpbmRNaXNzaW5nTWVzaGVzUmVxdWVzdBomLmdlb2Rlc2ljLnYxLkZpbmRNaXNzaW5nTWVzaGVzUmVzcG9uc2USTwoKQ3JlYXRlTWVzaBIeLmdlb2Rlc2ljLnYxLkNyZWF0ZU1lc2hSZXF1ZXN0Gh8uZ2VvZGVzaWMudjEuQ3JlYXRlTWVzaFJlc3BvbnNlKAESRAoHR2V0TWVzaBIbLmdlb2Rlc2ljLnYxLkdldE1lc2hSZXF1ZXN0GhwuZ2VvZGVzaWMudjEuR2V0TWVzaFJlc3BvbnNlEkkKCFJlYWRNZXNoEhwuZ2VvZGVzaWMudjEuUmVhZE1lc2hSZXF1ZXN0Gh0uZ2VvZGVzaWMudjEuUmVhZE1lc2hSZXNwb25zZTABElUKDERlY2ltYXRlTWVzaBIgLmdlb2Rlc2ljLnYxLkRlY2ltYXRlTWVzaFJlcXVlc3QaIS5nZW9kZXNpYy52MS5EZWNpbWF0ZU1lc2hSZXNwb25zZTABEk0KCkxpc3RNZXNoZXMSHi5nZW9kZXNpYy52MS5MaXN0TWVzaGVzUmVxdWVzdBofLmdlb2Rlc2ljLnYxLkxpc3RNZXNoZXNSZXNwb25zZRJNCgpEZWxldGVNZXNoEh4uZ2VvZGVzaWMudjEuRGVsZXRlTWVzaFJlcXVlc3QaHy5nZW9kZXNpYy52MS5EZWxldGVNZXNoUmVzcG9uc2ViBnByb3RvMw",[Xu]),Id=vi(No,3),gA=vi(No,4),_A=vi(No,6),cg=Wr(No,0),vA=On("Ch5nZW9kZXNpYy92MS9wYWlyX3NlcnZpY2UucHJvdG8SC2dlb2Rlc2ljLnYxImEKCVBvaW50UGFpchIpCgZzb3VyY2UYASABKAsyGS5nZW9kZXNpYy52MS5TdXJmYWNlUG9pbnQSKQoGdGFyZ2V0GAIgASgLMhkuZ2VvZGVzaWMudjEuU3VyZmFjZVBvaW50Is8CChNDb21wdXRlUGFpcnNSZXF1ZXN0EhMKC21lc2hfZGlnZXN0GAEgASgJEiUKBXBhaXJzGAIgAygLMhYuZ2VvZGVzaWMudjEuUG9pbnRQYWlyEhQKDHZlcnRleF9wYWlycxgDIAMoBxIqCgp2YWx1ZV90eXBlGAQgASgOMhYuZ2VvZGVzaWMudjEuVmFsdWVUeXBlEicKCHByaW9yaXR5GAUgASgOMhUuZ2VvZGVzaWMudjEuUHJpb3JpdHkSDQoFcGF0aHMYBiABKAgSKQoJYWxnb3JpdGhtGAcgASgOMhYuZ2VvZGVzaWMudjEuQWxnb3JpdGhtEjEKDWFwcHJveGltYXRpb24YCCABKAsyGi5nZW9kZXNpYy52MS5BcHByb3hpbWF0aW9uEhYKCXRvbGVyYW5jZRgJIAEoAUgAiAEBQgwKCl90b2xlcmFuY2Ui+QEKFENvbXB1dGVQYWlyc1Jlc3BvbnNlEioKBmhlYWRlchgBIAEoCzIYLmdlb2Rlc2ljLnYxLlBhaXJzSGVhZGVySAASLgoIcHJvZ3Jlc3MYAiABKAsyGi5nZW9kZXNpYy52MS5QYWlyc1Byb2dyZXNzSAASKAoFY2h1bmsYAyABKAsyFy5nZW9kZXNpYy52MS5QYWlyc0NodW5rSAASLAoHdHJhaWxlchgEIAEoCzIZLmdlb2Rlc2ljLnYxLlBhaXJzVHJhaWxlckgAEiUKBHBhdGgYBSABKAsyFS5nZW9kZXNpYy52MS5QYWlyUGF0aEgAQgYKBHBhcnQieAoLUGFpcnNIZWFkZXISKQoGYW5zd2VyGAEgASgLMhkuZ2VvZGVzaWMudjEuQW5zd2VySGVhZGVyEhIKCnBhaXJfY291bnQYAiABKAQSKgoKdmFsdWVfdHlwZRgDIAEoDjIWLmdlb2Rlc2ljLnYxLlZhbHVlVHlwZSInCg1QYWlyc1Byb2dyZXNzEhYKDnBhaXJzX2ZpbmlzaGVkGAEgASgEIi8KClBhaXJzQ2h1bmsSDgoGb2Zmc2V0GAEgASgEEhEKCWRpc3RhbmNlcxgCIAEoDCJDCghQYWlyUGF0aBIMCgRwYWlyGAEgASgEEikKBXBpZWNlGAIgASgLMhouZ2VvZGVzaWMudjEuUG9seWxpbmVQaWVjZSKHAQoMUGFpcnNUcmFpbGVyEioKBmFuc3dlchgBIAEoCzIaLmdlb2Rlc2ljLnYxLkFuc3dlclRyYWlsZXISFgoOcGFpcnNfc2VhcmNoZWQYAiABKAQSGQoRcGFpcnNfZnJvbV9maWVsZHMYAyABKAQSGAoQcGFpcnNfZnJvbV9jYWNoZRgEIAEoBDJkCgtQYWlyU2VydmljZRJVCgxDb21wdXRlUGFpcnMSIC5nZW9kZXNpYy52MS5Db21wdXRlUGFpcnNSZXF1ZXN0GiEuZ2VvZGVzaWMudjEuQ29tcHV0ZVBhaXJzUmVzcG9uc2UwAWIGcHJvdG8z",[Hr,Zu]),xA=Wr(vA,0),yA=On("Ch5nZW9kZXNpYy92MS9wYXRoX3NlcnZpY2UucHJvdG8SC2dlb2Rlc2ljLnYxIvABChNDb21wdXRlUGF0aHNSZXF1ZXN0EhMKC21lc2hfZGlnZXN0GAEgASgJEiQKB3NvdXJjZXMYAiADKAsyEy5nZW9kZXNpYy52MS5Tb3VyY2USKgoHdGFyZ2V0cxgDIAMoCzIZLmdlb2Rlc2ljLnYxLlN1cmZhY2VQb2ludBIpCglhbGdvcml0aG0YBCABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SEwoGcmFkaXVzGAUgASgBSACIAQESJwoIcHJpb3JpdHkYBiABKA4yFS5nZW9kZXNpYy52MS5Qcmlvcml0eUIJCgdfcmFkaXVzItUBChRDb21wdXRlUGF0aHNSZXNwb25zZRIrCgZoZWFkZXIYASABKAsyGS5nZW9kZXNpYy52MS5BbnN3ZXJIZWFkZXJIABIuCghwcm9ncmVzcxgCIAEoCzIaLmdlb2Rlc2ljLnYxLlNvbHZlUHJvZ3Jlc3NIABIpCgRwYXRoGAMgASgLMhkuZ2VvZGVzaWMudjEuR2VvZGVzaWNQYXRoSAASLQoHdHJhaWxlchgEIAEoCzIaLmdlb2Rlc2ljLnYxLkFuc3dlclRyYWlsZXJIAEIGCgRwYXJ0IosBCgxHZW9kZXNpY1BhdGgSDgoGdGFyZ2V0GAEgASgEEhMKBnNvdXJjZRgCIAEoBEgAiAEBEhAKCGRpc3RhbmNlGAMgASgBEg4KBmxlbmd0aBgEIAEoARIpCgVwaWVjZRgFIAEoCzIaLmdlb2Rlc2ljLnYxLlBvbHlsaW5lUGllY2VCCQoHX3NvdXJjZSLdAQoWQ29tcHV0ZUlzb2xpbmVzUmVxdWVzdBITCgttZXNoX2RpZ2VzdBgBIAEoCRIkCgdzb3VyY2VzGAIgAygLMhMuZ2VvZGVzaWMudjEuU291cmNlEg4KBmxldmVscxgDIAMoARIpCglhbGdvcml0aG0YBCABKA4yFi5nZW9kZXNpYy52MS5BbGdvcml0aG0SJwoIcHJpb3JpdHkYBSABKA4yFS5nZW9kZXNpYy52MS5Qcmlvcml0eRIWCgl0b2xlcmFuY2UYBiABKAFIAIgBAUIMCgpfdG9sZXJhbmNlItYBChdDb21wdXRlSXNvbGluZXNSZXNwb25zZRIrCgZoZWFkZXIYASABKAsyGS5nZW9kZXNpYy52MS5BbnN3ZXJIZWFkZXJIABIuCghwcm9ncmVzcxgCIAEoCzIaLmdlb2Rlc2ljLnYxLlNvbHZlUHJvZ3Jlc3NIABInCgdpc29saW5lGAMgASgLMhQuZ2VvZGVzaWMudjEuSXNvbGluZUgAEi0KB3RyYWlsZXIYBCABKAsyGi5nZW9kZXNpYy52MS5BbnN3ZXJUcmFpbGVySABCBgoEcGFydCJmCgdJc29saW5lEg4KBm51bWJlchgBIAEoBBINCgVsZXZlbBgCIAEoARIRCglpc19jbG9zZWQYAyABKAgSKQoFcGllY2UYBCABKAsyGi5nZW9kZXNpYy52MS5Qb2x5bGluZVBpZWNlMsQBCgtQYXRoU2VydmljZRJVCgxDb21wdXRlUGF0aHMSIC5nZW9kZXNpYy52MS5Db21wdXRlUGF0aHNSZXF1ZXN0GiEuZ2VvZGVzaWMudjEuQ29tcHV0ZVBhdGhzUmVzcG9uc2UwARJeCg9Db21wdXRlSXNvbGluZXMSIy5nZW9kZXNpYy52MS5Db21wdXRlSXNvbGluZXNSZXF1ZXN0GiQuZ2VvZGVzaWMudjEuQ29tcHV0ZUlzb2xpbmVzUmVzcG9uc2UwAWIGcHJvdG8z",[Hr,Zu]),bA=Wr(yA,0);class SA{constructor(e,t){this.baseUrl=e,this.token=t;const s=dA({baseUrl:e,interceptors:[r=>a=>(this.token&&a.header.set("authorization",`Bearer ${this.token}`),r(a))]});this.capabilities=lr(mA,s),this.meshes=lr(cg,s),this.fields=lr(lA,s),this.pairs=lr(xA,s),this.paths=lr(bA,s)}baseUrl;token;capabilities;meshes;fields;pairs;paths}function xi(n,e){return{signal:e,headers:{"geo-mesh-digest":n}}}function Io(n){return new Float64Array(n.slice().buffer)}function Yu(n){return new Uint32Array(n.slice().buffer)}async function EA(n,e,t,i){const s=n.fields.computeField({...Zr(e),radius:e.radius,progressive:!0},xi(e.digest,i));let r;for await(const{part:a}of s)a.case==="settled"?t({vertices:Yu(a.value.vertices),distances:Io(a.value.distances)}):a.case==="trailer"&&(r=lg(a.value));if(!r)throw new Error("The answer broke off.");return r}async function Tc(n,e,t,i){const s=new Float64Array(t);let r;const a=n.fields.computeField({...Zr(e),radius:e.radius,tolerance:e.tolerance},xi(e.digest,i));for await(const{part:o}of a)o.case==="chunk"&&s.set(Io(o.value.distances),Number(o.value.offset)),o.case==="trailer"&&(r=lg(o.value));if(!r)throw new Error("The answer broke off.");return{distances:s,summary:r}}async function MA(n,e,t,i){const s=new Uint32Array(t),r=n.fields.computeField({...Zr(e),radius:e.radius,quantities:[og.NEAREST_SOURCE]},xi(e.digest,i));for await(const{part:a}of r)a.case==="chunk"&&s.set(Yu(a.value.nearestSources),Number(a.value.offset));return s}async function Rc(n,e,t,i){const s=n.paths.computePaths({...Zr(e),targets:[Br(t)]},xi(e.digest,i));let r;for await(const{part:a}of s){if(a.case!=="path"||!a.value.piece||a.value.piece.pointCount===0n)continue;const{piece:o,distance:c,length:l,source:u}=a.value;r??={positions:new Float64Array(3*Number(o.pointCount)),places:[],distance:c,length:l,source:Number(u??0n)},r.positions.set(Io(o.positions),3*Number(o.firstPoint));for(const f of o.points)r.places.push(ug(f))}return r}async function AA(n,e,t,i){const s=[],r=n.fields.sampleFarthestPoints({...Zr(e),count:BigInt(t)},xi(e.digest,i));for await(const{part:a}of r)if(a.case==="samples")for(const{vertex:o,distance:c}of a.value.samples)s.push({vertex:Number(o),distance:c});return s}async function wA(n,e,t,i){const s=t.slice(1).map((c,l)=>({source:Br(t[l]),target:Br(c)})),r=[],a=[],o=n.pairs.computePairs({meshDigest:e,pairs:s,paths:!0},xi(e,i));for await(const{part:c}of o){if(c.case!=="path"||!c.value.piece)continue;const{piece:l}=c.value;if(l.pointCount===0n)throw new Error("No path leads along this curve.");const u=r.length>0&&l.firstPoint===0n?1:0;for(const f of l.points.slice(u))r.push(ug(f));a.push(...Io(l.positions).subarray(3*u))}return{places:r,positions:new Float64Array(a)}}function lg(n){return{settledRadius:n.settledRadius,solveSeconds:n.statistics?.solveSeconds??0}}function Zr(n){return{meshDigest:n.digest,algorithm:n.algorithm,sources:n.sources.map(TA)}}function TA(n){return"curve"in n?{place:{case:"curve",value:{points:n.curve.map(Br)}}}:{place:Br(n).place}}function Br(n){switch(n.kind){case"vertex":return{place:{case:"vertex",value:BigInt(n.vertex)}};case"edge":return{place:{case:"edge",value:{from:BigInt(n.from),to:BigInt(n.to),t:n.t}}};case"face":return{place:{case:"face",value:{face:BigInt(n.face),weights:[...n.weights]}}}}}function ug(n){const e=n.place;if(e?.case==="edge"){const{from:t,to:i,t:s}=e.value;return{kind:"edge",from:Number(t),to:Number(i),t:s??0}}if(e?.case==="face"){const[t,i,s]=e.value.weights??[];return{kind:"face",face:Number(e.value.face),weights:[t,i,s]}}return{kind:"vertex",vertex:Number(e?.value??0)}}function RA(n,e){const t=new Float32Array(n.length),i=[0,0];let s=0,r=0,a=0;for(let c=0;c<n.length;c++){const l=e[c]-n[c];if(!Number.isFinite(l)){if(n[c]===e[c])continue;a++,t[c]=NaN;continue}t[c]=Math.abs(l),i[0]=Math.min(i[0],l),i[1]=Math.max(i[1],l),n[c]>0&&(s+=t[c]/n[c],r++)}const o=Math.max(-i[0],i[1]);if(o>0)for(let c=0;c<t.length;c++)t[c]/=o;return{shares:t,largest:o,range:i,meanRelative:s/Math.max(r,1),oneSided:a}}const NA=.001,hg="within 0.1 %",IA=3e5;function CA(n,e){const{algorithm:t,sources:i}=e,s=t===Ur.UNSPECIFIED||t===Ur.FWP_LIST,r=i.every(o=>!("curve"in o)),a=r&&i.every(o=>"kind"in o&&o.kind==="vertex");return n.faceCount>IA&&s&&(a||r&&i.length===1)}const PA=1500,LA=2e3;class DA{constructor(e,t,i){this.scene=e,this.connection=t,this.events=i,this.live=new DE(e,{ask:(s,r,a)=>{const o={...this.question(s)};return this.answerTo(s,()=>Rc(this.connection,o,r,a))},value:s=>i.value(s,!0),failed:(s,r)=>this.report(s,r)}),this.sketch=new Ou(Gm,3,e.resolution),e.overlay.add(this.sketch),this.marks=new WE(e),e.onFrame=s=>{const r=this.field?.advance(s,this.still.matches)??!1;return this.field?.hasSwept&&this.swept?.(),document.documentElement.dataset.sweep=this.field?.hasArrived?"done":this.field?.hasSwept?"preview":"",r},e.isWaiting=()=>this.waiting&&!this.swept,e.isBusy=()=>this.waiting||this.summary!==void 0&&this.field?.hasArrived===!1}scene;connection;events;mesh;field;summary;algorithm=Ur.UNSPECIFIED;against=Ur.UNSPECIFIED;fieldSources=[];wantsCells=!1;awaitedPaths=[];placed=cr;history=new ME;reach=1/0;live;sketch;marks;dragged=new Bm(LA);fieldQuestion=new AbortController;meshQuestions=new AbortController;waiting=!1;swept;still=matchMedia("(prefers-reduced-motion: reduce)");get sources(){return this.placed.sources}get paths(){return this.placed.paths}get samples(){return this.placed.samples}get radius(){return this.placed.radius}get isEmpty(){return wE(this.placed)}get canUndo(){return this.history.canUndo}get canRedo(){return this.history.canRedo}get isWaiting(){return this.waiting}get exactField(){return this.summary&&td(this.sources,this.fieldSources)?this.field:void 0}show(e){const t=e.digest===this.mesh?.digest?this.placed:void 0;this.meshQuestions.abort(),this.meshQuestions=new AbortController,this.mesh?.dispose(),this.mesh=e,t||this.history.clear(),this.placed=cr,this.awaitedPaths=[],this.takeFieldAway(),this.showRadius(e),this.scene.show(e),this.live.warmUp(),this.marks.warmUp(),this.scene.draw(),this.live.hide(),this.put(t??cr)}showCoarse(e,t){e===this.mesh&&(e.awaitsCoarse=!1,t&&e.setCoarse(t),this.events.changed(),this.scene.redrawSurface())}clear(){this.isEmpty||this.change(cr)}setSources(e){return this.change({...this.placed,sources:e,samples:[]})}undo(){this.goTo(this.history.undo(this.placed))}redo(){this.goTo(this.history.redo(this.placed))}cancel(e){this.goTo(this.history.cancel(e))}async ask(e,t,i,s){const r={...cr,sources:e,radius:i};this.awaitedPaths=t,s?this.change(r):this.put(r),await this.fetchPaths(this.meshQuestions.signal)}moveSource(e,t,i){const{mesh:s}=this;s&&(this.history.record(this.placed,i),this.fieldQuestion.abort(),this.fieldQuestion=new AbortController,this.waiting=!1,this.hideLive(),this.placed={...this.placed,sources:this.sources.map((r,a)=>a===e?t:r),samples:[]},this.drawMarks(),this.scene.redraw(),this.dragged.ask(r=>this.follow(s,r)))}dropSource(){this.events.changed()}async askField(){const{mesh:e}=this;if(!e||!this.sources.length)return;this.fieldQuestion.abort(),this.dragged.stop(),this.hideLive();const t=this.fieldQuestion=new AbortController,i=!this.field,s=this.beginField(e,this.sources);document.documentElement.dataset.sweep="",this.summary=void 0,this.waiting=!0,this.events.changed(),i?this.scene.redraw():this.scene.redrawSurface();const r=this.newQuestion(e);try{CA(e,r)&&await this.preview(e,r,s,t.signal);const a=await this.answerTo(e,()=>EA(this.connection,r,o=>{s.add(o.vertices,o.distances),s.isPreview||this.scene.redrawSurface()},t.signal));if(t.signal.aborted)return;this.answer(a,r),s.finish(),this.showsCells&&this.paintCells(e,s)}catch(a){this.report(a,()=>{t===this.fieldQuestion&&this.askField()})}finally{t===this.fieldQuestion&&(this.waiting=!1),this.events.changed(),this.scene.redrawSurface()}}async preview(e,t,i,s){try{const{distances:r}=await Tc(this.connection,{...t,tolerance:NA},e.vertexCount,s);if(s.aborted)return;i.showPreview(r),this.events.changed(),this.scene.redrawSurface(),await this.sweep()}catch{}}async sweep(){let e;await new Promise(t=>{this.swept=e=t,setTimeout(t,PA)}),this.swept===e&&(this.swept=void 0)}get showsCells(){return this.wantsCells&&this.sources.length>1}showCells(e){const{mesh:t,field:i}=this;this.wantsCells=e,!(!t||!i)&&(this.showsCells?this.paintCells(t,i):(i.paintDistances(),this.repainted()))}async paintCells(e,t){try{const{signal:i}=this.fieldQuestion,s=await this.answerTo(e,()=>MA(this.connection,this.question(e),e.vertexCount,i));if(t!==this.field||!this.showsCells)return;t.paintCells(s),this.repainted()}catch(i){this.reportAbout(e,i,()=>this.paintCells(e,t))}}async compare(e,t){const{mesh:i}=this;if(!(!i||!this.summary))try{t&&await this.moveToVertices(i);const{field:s}=this,r={...this.question(i),algorithm:e},{signal:a}=this.fieldQuestion,{distances:o}=await this.answerTo(i,()=>Tc(this.connection,r,i.vertexCount,a));if(!s||s!==this.field)return;const c=RA(s.distances,o);return this.wantsCells=!1,this.against=e,s.paintDifference(c),this.repainted(),c}catch(s){this.report(s,()=>{});return}}hover(e,t){const{mesh:i}=this;if(!e||!this.field||!i){this.hideLive();return}const s=this.field.at(e.face,e.weights);if(this.events.value(s===1/0?void 0:s,!1),this.summary&&s===1/0&&this.summary.settledRadius===1/0){this.hideLive(),this.events.value(1/0,!0);return}this.live.lead(i,e,t)}async keepPath(e){const{mesh:t}=this;if(!t||!this.sources.length)return;const i=this.question(t),{signal:s}=this.meshQuestions;try{const r=await this.answerTo(t,()=>Rc(this.connection,i,e,s));if(t!==this.mesh)return;r?r.length>0&&this.change(this.withPath(nd(r,i.sources,e))):this.events.told("No path leads there.")}catch(r){this.reportAbout(t,r,()=>this.keepPath(e))}}removePath(e){this.change({...this.placed,paths:this.paths.filter(t=>t!==e)})}removeLast(){const e=this.paths.at(-1);e?this.removePath(e):this.sources.length&&this.setSources(this.sources.slice(0,-1))}drawSketch(e){this.sketch.setPoints(new Float32Array(e.flatMap(t=>t.toArray()))),this.scene.redraw()}async addCurve(e,t){const{mesh:i}=this;if(this.drawSketch([]),!(!i||e.length<2))try{const{signal:s}=this.meshQuestions,r=await this.answerTo(i,()=>wA(this.connection,i.digest,e,s));if(i!==this.mesh)return;await this.setSources([...t?[]:this.sources,{curve:r.places}])}catch(s){this.reportAbout(i,s,()=>this.addCurve(e,t))}}async sample(e){const{mesh:t}=this;if(!t||!this.sources.length)return;const{signal:i}=this.fieldQuestion;try{const s=await this.answerTo(t,()=>AA(this.connection,this.question(t),e,i));this.change({...this.placed,samples:s})}catch(s){this.reportAbout(t,s,()=>this.sample(e))}}setRadius(e){e!==this.radius&&this.change({...this.placed,radius:e},"radius")}change(e,t){return this.history.record(this.placed,t),this.put(e)}goTo(e){e&&this.put(e)}async put(e){const{sources:t,radius:i,field:s}=this;if(this.placed=e,this.mesh&&this.showRadius(this.mesh),e.sources.length||this.takeFieldAway(),this.drawMarks(),e.sources.length&&(!td(t,e.sources)||(e.radius??1/0)>this.reach))return this.askField();this.events.changed(),i===e.radius&&s===this.field?this.scene.redraw():this.scene.redrawSurface()}takeFieldAway(){this.fieldQuestion.abort(),this.dragged.stop(),this.hideLive(),this.field=void 0,this.fieldSources=[],this.summary=void 0,this.reach=1/0,this.waiting=!1,this.mesh&&new ud(this.mesh,this.scene.material,new P,!0)}showRadius(e){const{radius:t}=this;this.scene.material.uniforms.radius.value=t===void 0?1e10:t/e.radius}withPath(e){return{...this.placed,paths:[...this.paths,e]}}async fetchPaths(e){const{mesh:t}=this;if(t)try{for(let i=this.awaitedPaths[0];i&&!e.aborted;i=this.awaitedPaths[0]){const{from:s,target:r}=i,a={digest:t.digest,sources:[s],algorithm:this.algorithm},o=await this.answerTo(t,()=>Rc(this.connection,a,r,e));i===this.awaitedPaths[0]&&(this.awaitedPaths=this.awaitedPaths.slice(1),o?await this.put(this.withPath(nd(o,[s],r))):this.events.told("The address names a path between places that nothing connects."))}}catch(i){this.reportAbout(t,i,()=>this.fetchPaths(e))}}async moveToVertices(e){const t=this.sources.map(i=>{if("curve"in i)throw new Error("Approximate algorithms take points, no curves.");return i});t.every(i=>i.kind==="vertex")||(this.events.told("Sources are at the nearest vertices now: approximate algorithms measure between vertices."),await this.setSources(t.map(i=>({kind:"vertex",vertex:e.nearestCorner(i)}))))}repainted(){this.drawMarks(),this.events.changed(),this.scene.redrawSurface()}question(e){return{digest:e.digest,sources:this.sources,algorithm:this.algorithm,radius:this.radius}}newQuestion(e){return this.reach=this.radius??1/0,this.question(e)}answer(e,{radius:t}){this.reach=Math.min(e.settledRadius,t??1/0),this.summary={...e,settledRadius:this.reach}}async follow(e,t){const{sources:i}=this;try{const s=this.newQuestion(e),{distances:r,summary:a}=await this.answerTo(e,()=>Tc(this.connection,s,e.vertexCount,t));if(e!==this.mesh||t.aborted)return;const o=this.beginField(e,i);o.setAll(r),this.answer(a,s),this.events.changed(),this.scene.redrawSurface(),this.showsCells&&await this.paintCells(e,o)}catch(s){this.reportAbout(e,s,()=>this.askField())}}beginField(e,t){const[i]=t,s="curve"in i?i.curve[0]:i,r=Mr(e,s),a=t.every(o=>!("curve"in o));return this.fieldSources=t,this.field=new ud(e,this.scene.material,r,a)}hideLive(){this.live.hide(),this.events.value(void 0,!1)}drawMarks(){this.mesh&&this.marks.show(this.mesh,this.placed,this.field?.painted==="cells")}sourcesOnScreen(){const{mesh:e}=this;return this.sources.map(t=>e&&!("curve"in t)?Mr(e,t):void 0)}pathEnds(){const{mesh:e}=this;return e?this.paths.map(({target:t,length:i})=>({point:Mr(e,t),length:i})):[]}answerTo(e,t){return ag(t,()=>this.events.lost(e))}reportAbout(e,t,i){this.report(t,()=>{e===this.mesh&&i()})}report(e,t){zs(e)!=="cancelled"&&this.events.failed(e,t)}}function qt(n,e=6){if(n===1/0)return"∞";const t=Number(n.toPrecision(e)),i=Math.abs(t);return i!==0&&(i<1e-4||i>=1e7)?t.toExponential():String(t)}function go(n){return n.toLocaleString("en")}function _o(n,e){return n===0?`no ${e}`:n===1?`1 ${e}`:`${go(n)} ${e}s`}function Ae(n){const e=document.getElementById(n);if(!e)throw new Error(`The page has no element "${n}".`);return e}function zt(n,e){Ae(n).addEventListener("click",e)}class UA{notes=Ae("mesh-notes");row=Ae("joining");choice=Ae("join");distance=Ae("join-distance");constructor(e){this.choice.addEventListener("change",()=>this.showDistance()),zt("join-again",()=>{this.choice.value!=="distance"?e({keepSeams:this.choice.value==="none"}):this.distance.reportValidity()&&e({keepSeams:!1,weldDistance:this.distance.valueAsNumber})})}show(e,t){this.notes.hidden=e.length===0,this.notes.replaceChildren(...e.map(i=>{const s=document.createElement("li");return s.textContent=i,s})),this.row.hidden=!t,this.choice.value=t?.keepSeams?"none":t?.weldDistance===void 0?"rounding":"distance",t?.weldDistance!==void 0&&(this.distance.value=String(t.weldDistance)),this.showDistance()}showDistance(){this.distance.hidden=this.choice.value!=="distance"}}function Cd({keepSeams:n,weldDistance:e}){return n?"nothing joined":e===void 0?"":`joined within ${e}`}const FA=3e5,BA=15e4,OA=6e4,fg=4e6,VA=5e5,kA=/swiftshader|llvmpipe|softpipe|software|basic render/i,GA=300;class zA{constructor(e,t){this.still=t,this.inSoftware=kA.test(e)}still;changing=!0;timer;inSoftware;get coarseFaces(){return this.inSoftware?OA:BA}mayBeWhole(e){return e.faceCount<=(this.inSoftware?VA:fg)}change(){this.changing=!0,clearTimeout(this.timer)}isCoarse(e){return e.coarse!==void 0&&(this.changing||!this.mayBeWhole(e))}get isDraft(){return this.inSoftware&&this.changing}name(e){if(e.awaitsCoarse)return"coming";const t=this.isCoarse(e);return t&&this.mayBeWhole(e)?"coarse":this.isDraft?"draft":t?"always coarse":"whole"}drawn(e,t){clearTimeout(this.timer),!(!(this.isDraft||this.isCoarse(e)&&this.mayBeWhole(e))||t)&&(this.timer=setTimeout(()=>{this.settle(),this.still()},GA))}settle(){clearTimeout(this.timer),this.changing=!1}}function WA(n){return n.faceCount<=fg}async function HA(n,e,t,i){let s=new Uint32Array(0);const r=n.meshes.decimateMesh({digest:e,maxFaces:BigInt(t)},xi(e,i));for await(const{part:a}of r)a.case==="header"?s=new Uint32Array(3*Number(a.value.faceCount)):a.case==="faces"&&s.set(Yu(a.value.indices),3*Number(a.value.firstFace));return s}async function XA(n,e,t,i,s){let r=new Float64Array(0),a=new Uint32Array(0),o=0;for await(const{part:c}of n.meshes.readMesh({digest:e},xi(e,s)))c.case==="header"?(r=new Float64Array(3*Number(c.value.vertexCount)),a=new Uint32Array(3*Number(c.value.faceCount)),t(Number(c.value.faceCount))):c.case==="vertices"?o+=Pd(c.value.positions,r,3*Number(c.value.firstVertex)):c.case==="faces"&&(o+=Pd(c.value.indices,a,3*Number(c.value.firstFace))),i(o/Math.max(r.byteLength+a.byteLength,1));return{positions:r,indices:a}}function Pd(n,e,t){return new Uint8Array(e.buffer).set(n,t*e.BYTES_PER_ELEMENT),n.length}const ZA={obj:ai.OBJ,ply:ai.PLY,off:ai.OFF,stl:ai.STL,vtk:ai.VTK,vtp:ai.VTP,glb:ai.GLTF,gltf:ai.GLTF},Ld=512*1024;function dg(n){const e=n.toLowerCase().replace(/\.gz$/,"").split(".").pop()??"",t=ZA[e];if(t===void 0)throw new Error(`Meshes are files in .obj, .ply, .off, .stl, .vtk, .vtp, .glb or .gltf, or these with .gz; ${n} is none.`);return t}async function YA(n,e,t,i,s){const r={format:dg(e.name),...t},a=new Uint8Array(await e.arrayBuffer());return await KA(n,r,a,s)??$A(n,r,a,i,s)}async function KA(n,e,t,i){if(!globalThis.crypto?.subtle)return;const s=new Uint8Array(await crypto.subtle.digest("SHA-256",t)),r=Array.from(s,o=>o.toString(16).padStart(2,"0")).join("");return(await n.meshes.findMissingMeshes({files:[{...e,sha256:r}]},{signal:i})).knownFiles[0]?.meshDigest}async function $A(n,e,t,i,s){const r=new Blob([...JA(e,t)],{type:"application/grpc-web+proto"}),a=await jA(n,r,i,s),o=qA(a);return er(_A,o).mesh?.digest??""}function*JA(n,e){const t=i=>Xl(0,Uu(Id,dn(Id,{part:i})));yield t({case:"header",value:dn(gA,{...n,sizeBytes:BigInt(e.length)})});for(let i=0;i<e.length;i+=Ld){const s=e.subarray(i,i+Ld);yield t({case:"chunk",value:{$typeName:"geodesic.v1.UploadChunk",offset:BigInt(i),data:s}})}}function jA(n,e,t,i){return new Promise((s,r)=>{const a=new XMLHttpRequest;a.open("POST",`${n.baseUrl}/${cg.typeName}/CreateMesh`),a.responseType="arraybuffer",a.setRequestHeader("content-type","application/grpc-web+proto"),a.setRequestHeader("x-grpc-web","1"),n.token&&a.setRequestHeader("authorization",`Bearer ${n.token}`),a.upload.onprogress=o=>t(o.loaded/Math.max(o.total,1)),a.onload=()=>s(a),a.onerror=()=>r(new Je("the upload broke off",De.Unavailable)),a.onabort=()=>r(new Je("stopped",De.Canceled)),i.addEventListener("abort",()=>a.abort()),a.send(e)})}function qA(n){const e=new Headers;for(const o of n.getAllResponseHeaders().trim().split(/[\r\n]+/)){const c=o.indexOf(":");c>0&&e.append(o.slice(0,c),o.slice(c+1).trim())}const{headerError:t}=Kl(n.status,e);if(t)throw t;const i=new Uint8Array(n.response),s=new DataView(i.buffer);let r,a=!1;for(let o=0;o+5<=i.length;){const c=i[o],l=s.getUint32(o+1),u=i.subarray(o+5,o+5+l);o+=5+l,c&eo?(Yl(Zl(u),e),a=!0):r=u}if(!a||!r)throw new Je("the answer broke off",De.Unavailable);return r}function QA(n,e){const t=new Float32Array(n.length);for(let i=0;i<e.length;i+=3){const s=3*e[i],r=3*e[i+1],a=3*e[i+2],o=n[r]-n[s],c=n[r+1]-n[s+1],l=n[r+2]-n[s+2],u=n[a]-n[s],f=n[a+1]-n[s+1],h=n[a+2]-n[s+2],d=c*h-l*f,g=l*u-o*h,y=o*f-c*u;for(const p of[s,r,a])t[p]+=d,t[p+1]+=g,t[p+2]+=y}for(let i=0;i<t.length;i+=3){const s=Math.hypot(t[i],t[i+1],t[i+2])||1;for(let r=0;r<3;r++)t[i+r]/=s}return t}const ew=1e-6;class tw{constructor(e,t,i){this.arrays=e,this.digest=t,this.name=i,this.vertexCount=e.positions.length/3,this.faceCount=e.indices.length/3;const s=nw(e),{low:r,high:a}=iw(s);this.center=[0,1,2].map(c=>(r[c]+a[c])/2),this.radius=Math.hypot(...[0,1,2].map(c=>(a[c]-r[c])/2))||1;const o=this.toScreen(e.positions);this.framed=s===e.positions?o:this.toScreen(s),this.geometry=new $t,this.geometry.setAttribute("position",new Et(o,3)),this.geometry.setAttribute("normal",new Et(QA(o,e.indices),3)),this.geometry.setIndex(new Et(e.indices,1))}arrays;digest;name;vertexCount;faceCount;geometry;coarse;framed;isFile=!1;awaitsCoarse=!1;center;radius;setCoarse(e){this.coarse?.dispose(),this.coarse=new $t;for(const[t,i]of Object.entries(this.geometry.attributes))this.coarse.setAttribute(t,i);this.coarse.setIndex(new Et(e,1))}setAttribute(e,t){for(const i of[this.geometry,this.coarse])t?i?.setAttribute(e,t):i?.deleteAttribute(e)}toScreen(e){const t=new Float32Array(e.length);for(let i=0;i<e.length;i+=3)for(let s=0;s<3;s++)t[i+s]=(e[i+s]-this.center[s])/this.radius;return t}get hasArea(){const e=this.geometry.getAttribute("position"),[t,i,s]=[new P,new P,new P];let r=0;for(let a=0;a<this.faceCount;a++)if([t,i,s].forEach((o,c)=>o.fromBufferAttribute(e,this.arrays.indices[3*a+c])),r+=i.sub(t).cross(s.sub(t)).length()/2,r>ew)return!0;return!1}cornersOf(e){const{indices:t}=this.arrays;return[t[3*e],t[3*e+1],t[3*e+2]]}vertexPosition(e){const{positions:t}=this.arrays;return[t[3*e],t[3*e+1],t[3*e+2]]}positionOf(e){return this.weighted(e).reduce((t,[i,s])=>{const r=this.vertexPosition(i);return[t[0]+s*r[0],t[1]+s*r[1],t[2]+s*r[2]]},[0,0,0])}nearestCorner(e){return this.weighted(e).reduce((t,i)=>i[1]>t[1]?i:t)[0]}holds(e){return e.kind==="face"?e.face<this.faceCount:this.weighted(e).every(([t])=>t<this.vertexCount)}holdsSource(e){return"curve"in e?e.curve.every(t=>this.holds(t)):this.holds(e)}weighted(e){return e.kind==="vertex"?[[e.vertex,1]]:e.kind==="edge"?[[e.from,1-e.t],[e.to,e.t]]:this.cornersOf(e.face).map((t,i)=>[t,e.weights[i]])}dispose(){this.geometry.dispose(),this.coarse?.dispose()}}function nw({positions:n,indices:e}){const t=new Uint8Array(n.length/3);for(const a of e)t[a]=1;const i=t.reduce((a,o)=>a+o,0);if(i===0||i===t.length)return n;const s=new Float64Array(3*i);let r=0;return t.forEach((a,o)=>{a&&(s.set(n.subarray(3*o,3*o+3),r),r+=3)}),s}function iw(n){const e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i+=3)for(let s=0;s<3;s++){const r=n[i+s];r<e[s]&&(e[s]=r),r>t[s]&&(t[s]=r)}return n.length?{low:e,high:t}:{low:[0,0,0],high:[0,0,0]}}const sw={keepSeams:!1};class rw{constructor(e,t,i,s,r,a){this.connection=e,this.notice=t,this.recovery=i,this.coarseFaces=s,this.opened=r,this.decimated=a,zt("open",()=>this.input.click()),zt("welcome-open",()=>this.input.click()),this.input.addEventListener("change",()=>{this.openFiles(this.input.files),this.input.value=""}),this.select.addEventListener("change",()=>{if(!this.select.value){this.select.value=this.shown;return}this.openDigest(this.select.value)}),this.listenToDrops(Ae("stage"))}connection;notice;recovery;coarseFaces;opened;decimated;input=Ae("file");select=Ae("meshes");files=new Map;restored=new Map;seams=new UA(e=>this.readAnew(e));shown="";opening=new AbortController;restoring=new AbortController;openDigest(e){this.open(t=>ag(()=>this.read(e,t),()=>this.restore(e)))}async restore(e){const t=this.files.get(e);if(!t)return!1;const i=this.restored.get(e)??this.sendAgain(e,t).finally(()=>this.restored.delete(e));return this.restored.set(e,i),await i,!0}async sendAgain(e,t){this.restoring=new AbortController;const i=await this.upload(t,this.restoring.signal);if(this.notice.done(),i!==e)throw new Error(`The server has lost this mesh, and ${t.file.name} holds another one by now.`)}openFiles(e){const[t,...i]=e??[];t&&this.recovery.attempt(async()=>{dg(t.name),this.openFile({file:t,joining:sw},()=>{i.length&&this.notice.hint(`One mesh at a time is shown: ${t.name}.`)})})}openFile(e,t){this.open(async i=>{this.notice.clear();const s=await this.upload(e,i);this.files.set(s,e);const r=this.shown;await this.read(s,i),t(r),this.recovery.attempt(()=>this.list())},e.file.name)}readAnew(e){const t=this.files.get(this.shown);t&&this.openFile({...t,joining:e},i=>{this.notice.hint(i===this.shown?"It is the same mesh: this joins no other edges.":"This is another mesh. Back, in the browser, shows the one before with its sources and paths.",8e3)})}open(e,t){this.opening.abort();const{signal:i}=this.opening=new AbortController;this.recovery.attempt(async()=>{i.aborted||await e(i)},t)}async read(e,t){const i=u=>this.notice.busy("Reading the mesh",u);let s;const r=u=>{u<=FA||(s=HA(this.connection,e,this.coarseFaces,t).catch(()=>{}))},[a,{mesh:o}]=await Promise.all([XA(this.connection,e,r,i,t),this.connection.meshes.getMesh({digest:e},xi(e,t))]);this.notice.busy("Preparing the picture"),await new Promise(u=>requestAnimationFrame(()=>setTimeout(u)));const c=new tw(a,e,this.nameOf(e)),l=this.files.get(e);c.isFile=l!==void 0&&!Cd(l.joining),c.awaitsCoarse=s!==void 0,this.restoring.abort(),this.notice.clear(),this.opened(c),this.seams.show(o?.notes??[],l?.joining),s?.then(u=>this.decimated(c,u)),c.hasArea||this.notice.error(`${c.name}: no face has an area, so there is nothing to see.`),Ae("welcome").hidden=!0,this.shown=this.select.value=e}async list(){const{meshes:e}=await this.connection.meshes.listMeshes({pageSize:1e3}),t=e.map(i=>{const s=this.files.get(i.digest),r=[_o(Number(i.faceCount),"face"),s?Cd(s.joining):""].filter(Boolean);return{digest:i.digest,text:`${this.nameOf(i.digest)} (${r.join(", ")})`}});this.select.replaceChildren(new Option(t.length?"on the server…":"no mesh yet",""),...t.map(({digest:i,text:s})=>new Option(s,i))),this.select.value=this.shown,Ae("welcome-meshes").replaceChildren(...t.slice(0,12).map(({digest:i,text:s})=>{const r=document.createElement("button");return r.textContent=s,r.addEventListener("click",()=>this.openDigest(i)),r}))}nameOf(e){return this.files.get(e)?.file.name??e.slice(0,8)}upload({file:e,joining:t},i){const s=r=>this.notice.busy(r<1?`Sending ${e.name}`:`The server reads ${e.name}`,r<1?r:void 0);return s(0),YA(this.connection,e,t,s,i)}listenToDrops(e){const t=document.body;t.addEventListener("dragover",i=>{i.preventDefault(),e.classList.add("over")}),t.addEventListener("dragleave",()=>e.classList.remove("over")),t.addEventListener("drop",i=>{i.preventDefault(),e.classList.remove("over"),this.openFiles(i.dataTransfer?.files??null)})}}const aw=6e3;class ow{element=Ae("notice");text=Ae("notice-text");bar=Ae("notice-progress");button=Ae("notice-action");errorStaysUntil=0;timer;constructor(){Ae("notice-close").addEventListener("click",()=>this.clear())}busy(e,t){performance.now()<this.errorStaysUntil||(this.put(e,"busy"),this.bar.hidden=t===void 0,t!==void 0&&(this.bar.value=t))}done(){this.element.dataset.kind==="busy"&&this.clear()}error(e,t){this.errorStaysUntil=performance.now()+aw,this.put(e,"error"),t&&(this.button.textContent=t.label,this.button.onclick=()=>t.run(),this.button.hidden=!1)}hint(e,t=4e3){this.put(e,"hint"),this.timer=setTimeout(()=>this.clear(),t)}clear(){this.errorStaysUntil=0,this.element.hidden=!0}put(e,t){clearTimeout(this.timer),this.text.textContent=e,this.element.dataset.kind=t,this.element.hidden=!1,this.bar.hidden=!0,this.button.hidden=!0}}const Nc=3;function $l(n){switch(n.kind){case"vertex":return`vertex ${n.vertex}`;case"edge":return`a point on edge ${n.from}-${n.to}`;case"face":return`a point in face ${n.face}`}}function cw(n,e){const t=e.slice(0,Nc).map(i=>"curve"in i?`a curve of ${i.curve.length} points`:`${$l(i)} (${n.positionOf(i).map(s=>qt(s,4)).join(", ")})`);return e.length>Nc&&t.push(`${e.length-Nc} more`),e.length===1?t[0]:`the nearest of ${e.length} sources: ${t.join(", ")}`}const Dd="in the unit of the file",Ic=20,Ud=12,Fd=17,lw="12px system-ui, sans-serif";class uw{constructor(e,t,i){this.explorer=e,this.scene=t,this.methods=i}explorer;scene;methods;box=Ae("legend");lines=[];update(){const{mesh:e,field:t,paths:i}=this.explorer;this.lines=e&&t?this.describe(e,t):[],e&&i.length&&this.lines.push(`orange: ${_o(i.length,"exact shortest path")}, with the length`),this.box.textContent=this.lines.join(`
`)}drawOn(e,t){e.save(),e.scale(t,t);const i=getComputedStyle(document.documentElement);e.font=lw,e.textBaseline="top",e.lineJoin="round",e.lineWidth=4,e.strokeStyle=i.getPropertyValue("--background"),e.fillStyle=i.getPropertyValue("--text");const s=e.canvas.width/t-2*Ic;this.lines.flatMap(r=>hw(e,r,s)).forEach((r,a)=>{e.strokeText(r,Ic,Ud+a*Fd),e.fillText(r,Ic,Ud+a*Fd)}),e.restore()}describe(e,t){const i=cw(e,this.explorer.fieldSources),s=this.methods.nameOf(this.explorer.algorithm),r=[];switch(t.painted){case"distances":r.push(`${e.name}: distance from ${i}`,`${this.accuracy(t)} (${s}), ${Dd}`);break;case"cells":r.push(`${e.name}: colours tell which source is nearest, darker is farther: ${i}`,`${this.accuracy(t)} (${s})`);break;case"difference":r.push(...this.describeDifference(e,t,s,i));break}const{step:a}=Vu(t.largest);this.scene.material.uniforms.showLines.value&&a>0&&r.push(`lines: ${t.painted==="difference"?`distances of ${s}`:"distances"}, every ${qt(a,6)}`);const{radius:o}=this.explorer;return o!==void 0&&r.push(`up to ${qt(o,4)}; what is farther is grey`),r}describeDifference(e,t,i,s){const{difference:r}=t;if(!r)return[];const{against:a}=this.explorer,o=this.methods.nameOf(a),[c,l]=r.range.map(h=>qt(h,3)),u=this.methods.isApproximate(a)?"approximate":"exact",f=[`${e.name}: how far ${o} (${u}) is from ${i} (${this.accuracy(t)}), without sign, ${Dd}`,`${o} − ${i} is from ${c} to ${l}`,`both: distance from ${s}`];return r.oneSided&&f.push(`grey: ${go(r.oneSided)} of the vertices have a distance in one of them only`),f}accuracy(e){return e.isPreview?hg:this.explorer.summary?"exact":"exact, still on its way: grey is not known yet"}}function hw(n,e,t){const i=[];for(const s of e.split(" ")){const r=i.length?`${i.at(-1)} ${s}`:s;i.length&&n.measureText(r).width<=t?i[i.length-1]=r:i.push(s)}return i}const Bd=0;class fw{algorithm=Ae("algorithm");compared=Ae("against");exact=[];approximate=[];constructor(e){this.algorithm.addEventListener("change",()=>e(Number(this.algorithm.value)))}show({algorithms:e,approximateAlgorithms:t}){this.exact=e,this.approximate=t;const i=this.algorithm.value;this.algorithm.replaceChildren(new Option("the server's choice",String(Bd)),...e.map(pg)),i&&(this.algorithm.value=i),this.compared.replaceChildren(Od("exact",e),Od("approximate",t));const s=t[0]??e[1];s&&(this.compared.value=String(s.algorithm)),Ae("compare-row").hidden=e.length+t.length<2}get against(){return Number(this.compared.value)}isApproximate(e){return this.approximate.some(t=>t.algorithm===e)}nameOf(e){const t=[...this.exact,...this.approximate],i=s=>s.algorithm===e||e===Bd&&s.isDefault;return t.find(i)?.name??"the server's choice"}}function Od(n,e){const t=document.createElement("optgroup");return t.label=n,t.hidden=e.length===0,t.append(...e.map(pg)),t}function pg({algorithm:n,name:e,summary:t}){const i=new Option(e,String(n));return i.title=t,i}function Cc(n,e){const t=e instanceof Blob?e:new Blob(e),i=document.createElement("a");i.href=URL.createObjectURL(t),i.download=n,i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),6e4)}function Pc(n){return n.replace(/\.[^.]*$/,"")||"mesh"}function dw(n){const e=`{'descr': '<f8', 'fortran_order': False, 'shape': (${n.length},), }`,t=e.padEnd(Math.ceil((e.length+11)/64)*64-11)+`
`,i=new Uint8Array(10+t.length);return i.set([147,...Vd("NUMPY"),1,0,t.length&255,t.length>>8]),i.set(Vd(t),10),[i,n]}function pw(n){const e=["vertex,geodesic_distance"];return n.forEach((t,i)=>e.push(`${i},${gw(t)}`)),[e.join(`
`),`
`]}function mw(n,e){const t=n.indices.length/3,i=["ply","format binary_little_endian 1.0",`element vertex ${e.length}`,...["x","y","z","geodesic_distance"].map(a=>`property double ${a}`),`element face ${t}`,"property list uchar int vertex_indices","end_header"],s=new Float64Array(4*e.length);for(let a=0;a<e.length;a++)s.set(n.positions.subarray(3*a,3*a+3),4*a),s[4*a+3]=e[a];const r=new DataView(new ArrayBuffer(13*t));for(let a=0;a<t;a++){r.setUint8(13*a,3);for(let o=0;o<3;o++)r.setUint32(13*a+1+4*o,n.indices[3*a+o],!0)}return[i.join(`
`)+`
`,s,r]}function gw(n){return n===1/0?"inf":String(n)}function Vd(n){return new TextEncoder().encode(n)}function _w(n){const e=[];let t=1;return n.forEach((i,s)=>{const r=i.positions.length/3;e.push(`g path_${s}`);for(let a=0;a<r;a++)e.push(`v ${i.positions.subarray(3*a,3*a+3).join(" ")}`);e.push(`l ${Array.from({length:r},(a,o)=>t+o).join(" ")}`),t+=r}),[e.join(`
`),`
`]}function vw(n,e,t,i){const s=n.takePicture(),r=s.getContext("2d");r&&e&&e.scaleEnd>0&&xw(r,e,s.height);for(const a of[t,i])r&&a.drawOn(r,n.pixelRatio.value);return new Promise((a,o)=>s.toBlob(c=>c?a(c):o(new Error("The picture could not be made.")),"image/png"))}function xw(n,e,t){const i=t/700,s={left:24*i,top:.28*t,width:14*i,height:.44*t};for(let r=0;r<s.height;r++)n.fillStyle=Vm(1-r/s.height),n.fillRect(s.left,s.top+r,s.width,1);n.font=`${13*i}px system-ui, sans-serif`,n.textBaseline="middle",n.fillStyle=getComputedStyle(document.documentElement).getPropertyValue("--text");for(const{at:r,text:a}of km(e.scaleEnd)){const o=s.top+s.height*(1-r/e.scaleEnd);n.fillText(a,s.left+s.width+8*i,o)}}function yw(n){const e=n.sources.map(c=>"curve"in c?`--curve '${Ys(c)}'`:`--source ${Ys(c)}`),t=n.server?`geodesic --server ${n.server}`:"geodesic",i=Sw(n.mesh),s=n.algorithm?[`--algorithm ${n.algorithm}`]:[],r=n.radius===void 0?[]:[`--radius ${n.radius}`],a=e.length?[[t,"field",i,...e,...r,...s,"-o field.npy"]]:[],o=new Map;for(const{from:c,target:l}of n.paths){const u=`--source ${po(c)}`;o.set(u,[...o.get(u)??[],`--target ${po(l)}`])}return[...o].forEach(([c,l],u)=>{a.push([t,"path",i,c,...l,...s,`-o paths${u?`-${u+1}`:""}.obj`])}),a.map(c=>c.join(" ")).join(`
`)}function bw(n){const e=n.sources.map(o=>"curve"in o?`geodesic.Curve([${o.curve.map(Ea).join(", ")}])`:Ea(o)),t=e.length===1?e[0]:`[${e.join(", ")}]`,i=n.radius===void 0?"":`, radius=${n.radius}`,s=n.algorithm?`, algorithm="${n.algorithm}"`:"",r=["import geodesic","",n.server?`mesh = geodesic.connect(${JSON.stringify(n.server)}).open(${JSON.stringify(n.mesh)})`:`mesh = geodesic.Mesh(${JSON.stringify(n.mesh)})`];e.length&&r.push(`d = mesh.distances(${t}${i}${s})`);const a=n.paths.map(({from:o,target:c})=>`mesh.path(${Ea(o)}, ${Ea(c)}${s})`);return a.length===1&&r.push(`path = ${a[0]}`),a.length>1&&r.push("paths = [",...a.map(o=>`    ${o},`),"]"),r.join(`
`)}function Sw(n){const e=n.startsWith("-")?`./${n}`:n;return/^[\w./-]+$/.test(e)?e:`'${e.replaceAll("'","'\\''")}'`}class Ew{constructor(e,t,i,s,r,a){this.explorer=e,this.scene=t,this.notice=i,this.labels=s,this.legend=r,this.algorithmName=a,zt("save-picture",()=>{this.savePicture()}),zt("save-npy",()=>this.saveField("npy",dw)),zt("save-csv",()=>this.saveField("csv",pw)),zt("save-ply",()=>this.saveField("ply",o=>e.mesh?mw(e.mesh.arrays,o):[])),zt("save-paths",()=>this.savePaths()),zt("copy-command",()=>this.copy(yw)),zt("copy-python",()=>this.copy(bw))}explorer;scene;notice;labels;legend;algorithmName;text=Ae("question-text");write;update(){const e=this.question();this.text.hidden=!e||!this.write,e&&this.write&&(this.text.textContent=this.write(e))}async savePicture(){const{mesh:e,field:t}=this.explorer;e&&Cc(`${Pc(e.name)}.png`,await vw(this.scene,t,this.labels,this.legend))}saveField(e,t){const{mesh:i,exactField:s,isWaiting:r,summary:a,radius:o}=this.explorer;if(!i||!s){this.notice.hint(r||a?"The exact field is still on its way.":"There is no field yet: click a point of the surface.");return}const c=o??1/0,l=s.distances.map(u=>u<=c?u:1/0);Cc(`${Pc(i.name)}-field.${e}`,t(l))}savePaths(){const{mesh:e,paths:t}=this.explorer;if(!e||!t.length){this.notice.hint("There is no path yet: click where one should end.");return}Cc(`${Pc(e.name)}-paths.obj`,_w(t))}copy(e){const t=this.question();if(!t){this.notice.hint("There is no question yet: click a point of the surface.");return}this.write=e,this.update();const i=t.server?" For PORT put the one of the server's --listen.":"";navigator.clipboard?.writeText(e(t)).then(()=>this.notice.hint(`Copied.${i}`),()=>this.notice.hint(`Select the text and copy it.${i}`))}question(){const{mesh:e,sources:t,radius:i,paths:s}=this.explorer;if(!(!e||!t.length&&!s.length))return{mesh:e.isFile?e.name:e.digest,server:e.isFile?void 0:`${location.hostname}:PORT`,sources:t,radius:i,algorithm:this.algorithmName(),paths:s}}}class Mw{constructor(e){this.element=e;const t=document.createElement("canvas");t.className="scale-colors",t.width=1,t.height=128;const i=t.getContext("2d");for(let s=0;i&&s<128;s++)i.fillStyle=Vm(1-s/127),i.fillRect(0,s,1,1);this.ticks.className="scale-ticks",this.mark.className="scale-mark",this.mark.hidden=!0,this.element.append(t,this.ticks,this.mark)}element;ticks=document.createElement("div");mark=document.createElement("div");largest=0;show(e){this.largest=e,this.element.hidden=!(e>0),this.ticks.replaceChildren(...km(e).map(({at:t,text:i})=>{const s=document.createElement("span");return s.textContent=i,s.style.bottom=`${100*t/e}%`,s}))}point(e){const t=e!==void 0&&Number.isFinite(e)&&this.largest>0;this.mark.hidden=!t,t&&(this.mark.style.bottom=`${Math.min(100*e/this.largest,100)}%`)}}const Ta=1e3,kd="There is no field yet: click a point of the surface.";class Aw{constructor(e,t,i,s,r,a){this.explorer=e,this.scene=t,this.connection=i,this.notice=s,this.theme=r,this.methods=new fw(o=>{e.algorithm=o,e.askField()}),this.legend=new uw(e,t,this.methods),this.save=new Ew(e,t,s,a,this.legend,()=>this.algorithmName()),zt("theme",()=>r.toggle()),zt("help",()=>this.help()),zt("undo",()=>this.undo()),zt("redo",()=>this.redo()),zt("clear",()=>this.clear()),zt("sample",()=>{const o=Ae("sample-count");o.reportValidity()&&(e.sources.length?e.sample(o.valueAsNumber):s.hint(kd))}),zt("compare",()=>{this.compare()}),this.isolines.addEventListener("change",()=>this.showIsolines()),this.cells.addEventListener("change",()=>e.showCells(this.cells.checked)),this.radius.addEventListener("input",()=>{const o=this.radius.valueAsNumber/Ta,c=this.widestRadius();this.setRadius(o<1&&c>0?o*c:1/0)});for(const o of this.tools())o.addEventListener("change",()=>this.update())}explorer;scene;connection;notice;theme;scale=new Mw(Ae("scale"));valueBox=Ae("value");radius=Ae("radius");isolines=Ae("isolines");cells=Ae("cells");undoButton=Ae("undo");redoButton=Ae("redo");clearButton=Ae("clear");methods;legend;save;get tool(){return this.tools().find(e=>e.checked)?.value}choose(e){for(const t of this.tools())t.checked=t.value===e;this.update()}async showCapabilities(){this.methods.show(await this.connection.capabilities.getCapabilities({})),this.legend.update()}show(e){Ae("mesh-name").textContent=e.name,Ae("mesh-name").title=e.digest,Ae("questions").hidden=!1,document.title=`${e.name} - geodesic`}chooseNext(){this.choose(this.explorer.sources.length?"path":"source")}update(){const{field:e,isWaiting:t,sources:i,summary:s,paths:r,samples:a}=this.explorer;this.showSize(),Ae("source-count").textContent=_o(i.length,"source"),Ae("next-step").textContent=this.nextStep(),Ae("cells-choice").hidden=i.length<2,this.cells.checked=this.explorer.showsCells,this.undoButton.disabled=!this.explorer.canUndo,this.redoButton.disabled=!this.explorer.canRedo,this.clearButton.disabled=this.explorer.isEmpty,e?.painted!=="difference"&&Ae("difference").replaceChildren(),this.scale.show(e?.scaleEnd??0);const o=[];e?.isPreview&&(o.push([Gd(this.explorer.radius??1/0),`≈ ${qt(e.largest,4)}`]),o.push(["for now",hg+(t?"; the exact field is on its way":"")])),e&&s&&(o.push([Gd(s.settledRadius),qt(e.largest,10)]),o.push(["solved in",`${qt(1e3*s.solveSeconds,3)} ms`]),a.length&&o.push(["samples",go(a.length)])),zd(Ae("figures"),o),Ae("paths-section").hidden=r.length===0,Ae("paths").replaceChildren(...r.map(c=>{const l=Ar("li",qt(c.length,10)),u=Ar("small",`from ${$l(c.from)} to ${$l(c.target)}`),f=document.createElement("button");return f.textContent="×",f.setAttribute("aria-label","Remove this path"),f.addEventListener("click",()=>this.explorer.removePath(c)),l.append(f,u),l})),this.showRadius(),this.legend.update(),this.save.update()}pointer(e){const t=Ae("stage").getBoundingClientRect();this.valueBox.style.setProperty("--x",`${e.x-t.left}px`),this.valueBox.style.setProperty("--y",`${e.y-t.top}px`)}value(e,t){this.valueBox.hidden=e===void 0,this.scale.point(this.explorer.field?.painted==="distances"?e:void 0),e!==void 0&&(this.valueBox.textContent=e===1/0?"not reached":t?qt(e,8):`≈ ${qt(e,4)}`,this.valueBox.dataset.exact=String(t))}setRadius(e){const{field:t,summary:i}=this.explorer,s=i?.settledRadius===1/0&&e>=(t?.largest??0);this.explorer.setRadius(s||e===1/0?void 0:Math.max(e,0))}clear(){this.explorer.clear(),this.choose("source")}undo(){this.explorer.undo(),this.chooseNext()}redo(){this.explorer.redo(),this.chooseNext()}toggleIsolines(){this.isolines.checked=!this.isolines.checked,this.showIsolines()}toggleTheme(){this.theme.toggle()}help(){Ae("help-dialog").showModal()}async compare(){if(!this.explorer.exactField){this.notice.hint(this.explorer.isWaiting?"The exact field is still on its way.":kd);return}const e=this.methods.against;Ae("difference").replaceChildren(Ar("dt","Comparing…"));const t=await this.explorer.compare(e,this.methods.isApproximate(e));if(!t){Ae("difference").replaceChildren();return}zd(Ae("difference"),[["largest difference",qt(t.largest,3)],["mean, relative",qt(t.meanRelative,3)]])}showIsolines(){this.scene.material.uniforms.showLines.value=this.isolines.checked,this.legend.update(),this.scene.redrawSurface()}showSize(){const{mesh:e}=this.explorer;if(!e)return;const t=_o(e.faceCount,"face"),i=e.coarse?.index?go(e.coarse.index.count/3):void 0,s=this.scene.mayBeWhole(e)?" while it moves":"";Ae("mesh-size").textContent=i?`${t}, ${i} drawn${s}`:t,Ae("mesh-size").title=i?"Drawn with fewer faces over the same vertices. All answers are the whole mesh's.":""}showRadius(){const{radius:e}=this.explorer;Ae("radius-value").textContent=e===void 0?"all":qt(e,4);const t=e?e/this.widestRadius():0;this.radius.value=String(e===void 0?Ta:Math.min(Math.round(t*Ta),Ta-1))}widestRadius(){const{field:e,radius:t}=this.explorer;return Math.max(e?.largest??0,t??0)}nextStep(){return this.tool==="curve"?"Drag on the surface: every point of the curve is a source.":this.explorer.sources.length?this.tool==="source"?"Click to move the source; Shift and click for one more.":"Move: the shortest path follows. Click to keep it; Shift and click for one more source.":"Click a point of the surface."}algorithmName(){const{algorithm:e}=this.explorer;return e===0?void 0:this.methods.nameOf(e)}tools(){return[...document.querySelectorAll('input[name="tool"]')]}}function Gd(n){return n===1/0?"farthest":`farthest up to ${qt(n,4)}`}function zd(n,e){n.replaceChildren(...e.flatMap(([t,i])=>[Ar("dt",t),Ar("dd",i)]))}function Ar(n,e){const t=document.createElement(n);return t.textContent=e,t}const Wd={x:12,y:-12};class ww{constructor(e,t,i){this.explorer=e,this.scene=t,this.isSeen=i}explorer;scene;isSeen;box=Ae("labels");labels=[];update(){const e=this.explorer.pathEnds().filter(({point:t})=>this.isSeen(t));this.labels=e.map(({point:t,length:i})=>{const{x:s,y:r}=this.scene.pixelOf(t);return{text:qt(i,6),x:s+Wd.x,y:r+Wd.y}}),this.box.replaceChildren(...this.labels.map(({text:t,x:i,y:s})=>{const r=document.createElement("span");return r.textContent=t,r.style.left=`${i}px`,r.style.top=`${s}px`,r}))}drawOn(e,t){const i=getComputedStyle(document.documentElement);e.font=`${13*t}px system-ui, sans-serif`,e.textBaseline="middle",e.lineJoin="round",e.lineWidth=4*t,e.strokeStyle=i.getPropertyValue("--background"),e.fillStyle=i.getPropertyValue("--text");for(const{text:s,x:r,y:a}of this.labels)e.strokeText(s,t*r,t*a),e.fillText(s,t*r,t*a)}}class Tw{dialog=Ae("token-dialog");input=Ae("token");declined=!1;constructor(e){this.dialog.addEventListener("submit",t=>{t.submitter?.value==="ok"&&this.input.value?e(this.input.value.trim()):this.declined=!0}),this.dialog.addEventListener("cancel",()=>this.declined=!0)}get wasDeclined(){return this.declined}close(){this.declined=!1,this.dialog.close()}open(e){this.declined=!1,Ae("token-reason").textContent=e,this.input.value="",this.dialog.open||this.dialog.showModal()}}const Rw=500,Nw=5e3,Iw=250,Cw=1e4,Pw="Whoever runs this server gives tokens to those who may ask it.";class Lw{constructor(e,t,i){this.connection=e,this.notice=t,this.dialog=new Tw(s=>{i(s),this.goOnWith(s)})}connection;notice;questions=new Set;waiting=!1;dialog;goOnWith(e){this.connection.token=e,this.dialog.close(),this.resume()}async attempt(e,t){try{await e()}catch(i){const s=zs(i),r=t?`${t}: `:"";s==="full"||s==="refused"?this.notice.error(r+ur(i)):this.handle(i,()=>{this.attempt(e,t)})}}handle(e,t){switch(zs(e)){case"cancelled":return;case"token":this.questions.add(t),this.askForToken(this.connection.token?ur(e):Pw);return;case"gone":this.questions.add(t),this.waitForServer();return;case"forgotten":this.notice.error(`${ur(e)} Drop its file here again.`);return;case"full":this.waitForRoom(e,t);return;default:this.notice.error(ur(e))}}askForToken(e){const t=()=>this.dialog.open(e);this.notice.error(e,{label:"Enter a token",run:t}),this.dialog.wasDeclined||t()}waitForRoom(e,t){const i=Math.max(rg(e)??0,Iw);if(i>Cw){this.notice.error(ur(e));return}this.notice.hint("The server has much to do. This page asks again.",2*i),setTimeout(t,i)}async waitForServer(){if(this.notice.error("The server does not answer. This page goes on when it is back."),!this.waiting){this.waiting=!0;for(let e=Rw;;e=Math.min(2*e,Nw)){await new Promise(t=>setTimeout(t,e));try{await this.connection.capabilities.getCapabilities({});break}catch(t){if(zs(t)!=="gone")break}}this.waiting=!1,this.notice.hint("The server is back.",2e3),this.resume()}}resume(){const e=[...this.questions];this.questions.clear(),this.notice.clear();for(const t of e)t()}}const mg="geodesic.theme";class Dw{constructor(e){this.changed=e,this.system.addEventListener("change",()=>this.apply()),this.apply()}changed;system=matchMedia("(prefers-color-scheme: dark)");chosen=Uw();toggle(){this.chosen=this.isDark()?"light":"dark";try{localStorage.setItem(mg,this.chosen)}catch{}this.apply()}isDark(){return this.chosen?this.chosen==="dark":this.system.matches}apply(){const e=this.isDark();document.documentElement.dataset.theme=e?"dark":"light";const t=getComputedStyle(document.documentElement).getPropertyValue("--background").trim();this.changed(e,t)}}function Uw(){try{return localStorage.getItem(mg)}catch{return null}}const Hd={type:"change"},Ku={type:"start"},gg={type:"end"},Ra=new Vr,Xd=new Yn,Fw=Math.cos(70*Fp.DEG2RAD),Nt=new P,nn=2*Math.PI,rt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Lc=1e-6;class Bw extends d_{constructor(e,t=null){super(e,t),this.state=rt.NONE,this.target=new P,this.cursor=new P,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Os.ROTATE,MIDDLE:Os.DOLLY,RIGHT:Os.PAN},this.touches={ONE:Fs.ROTATE,TWO:Fs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new P,this._lastQuaternion=new Fi,this._lastTargetPosition=new P,this._quat=new Fi().setFromUnitVectors(e.up,new P(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Gh,this._sphericalDelta=new Gh,this._scale=1,this._panOffset=new P,this._rotateStart=new we,this._rotateEnd=new we,this._rotateDelta=new we,this._panStart=new we,this._panEnd=new we,this._panDelta=new we,this._dollyStart=new we,this._dollyEnd=new we,this._dollyDelta=new we,this._dollyDirection=new P,this._mouse=new we,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Vw.bind(this),this._onPointerDown=Ow.bind(this),this._onPointerUp=kw.bind(this),this._onContextMenu=Yw.bind(this),this._onMouseWheel=Ww.bind(this),this._onKeyDown=Hw.bind(this),this._onTouchStart=Xw.bind(this),this._onTouchMove=Zw.bind(this),this._onMouseDown=Gw.bind(this),this._onMouseMove=zw.bind(this),this._interceptControlDown=Kw.bind(this),this._interceptControlUp=$w.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction=""}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Hd),this.update(),this.state=rt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){const t=this.object.position;Nt.copy(t).sub(this.target),Nt.applyQuaternion(this._quat),this._spherical.setFromVector3(Nt),this.autoRotate&&this.state===rt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=nn:i>Math.PI&&(i-=nn),s<-Math.PI?s+=nn:s>Math.PI&&(s-=nn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const a=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=a!=this._spherical.radius}if(Nt.setFromSpherical(this._spherical),Nt.applyQuaternion(this._quatInverse),t.copy(this.target).add(Nt),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let a=null;if(this.object.isPerspectiveCamera){const o=Nt.length();a=this._clampDistance(o*this._scale);const c=o-a;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){const o=new P(this._mouse.x,this._mouse.y,0);o.unproject(this.object);const c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;const l=new P(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(o),this.object.updateMatrixWorld(),a=Nt.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;a!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(a).add(this.object.position):(Ra.origin.copy(this.object.position),Ra.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ra.direction))<Fw?this.object.lookAt(this.target):(Xd.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ra.intersectPlane(Xd,this.target))))}else if(this.object.isOrthographicCamera){const a=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),a!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Lc||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Lc||this._lastTargetPosition.distanceToSquared(this.target)>Lc?(this.dispatchEvent(Hd),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?nn/60*this.autoRotateSpeed*e:nn/60/60*this.autoRotateSpeed}_getZoomScale(e){const t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Nt.setFromMatrixColumn(t,0),Nt.multiplyScalar(-e),this._panOffset.add(Nt)}_panUp(e,t){this.screenSpacePanning===!0?Nt.setFromMatrixColumn(t,1):(Nt.setFromMatrixColumn(t,0),Nt.crossVectors(this.object.up,Nt)),Nt.multiplyScalar(e),this._panOffset.add(Nt)}_pan(e,t){const i=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;Nt.copy(s).sub(this.target);let r=Nt.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,a=i.width,o=i.height;this._mouse.x=s/a*2-1,this._mouse.y=-(r/o)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientX),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(nn*this._rotateDelta.x/t.clientHeight),this._rotateUp(nn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{const i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const t=this.domElement;this._rotateLeft(nn*this._rotateDelta.x/t.clientHeight),this._rotateUp(nn*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{const t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){const t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const a=(e.pageX+t.x)*.5,o=(e.pageY+t.y)*.5;this._updateZoomParameters(a,o)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new we,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){const t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){const t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}}function Ow(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function Vw(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function kw(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(gg),this.state=rt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:const e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function Gw(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Os.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=rt.DOLLY;break;case Os.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=rt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=rt.ROTATE}break;case Os.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=rt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=rt.PAN}break;default:this.state=rt.NONE}this.state!==rt.NONE&&this.dispatchEvent(Ku)}function zw(n){switch(this.state){case rt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case rt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case rt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Ww(n){this.enabled===!1||this.enableZoom===!1||this.state!==rt.NONE||(n.preventDefault(),this.dispatchEvent(Ku),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(gg))}function Hw(n){this.enabled!==!1&&this._handleKeyDown(n)}function Xw(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Fs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=rt.TOUCH_ROTATE;break;case Fs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=rt.TOUCH_PAN;break;default:this.state=rt.NONE}break;case 2:switch(this.touches.TWO){case Fs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=rt.TOUCH_DOLLY_PAN;break;case Fs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=rt.TOUCH_DOLLY_ROTATE;break;default:this.state=rt.NONE}break;default:this.state=rt.NONE}this.state!==rt.NONE&&this.dispatchEvent(Ku)}function Zw(n){switch(this._trackPointer(n),this.state){case rt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case rt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case rt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case rt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=rt.NONE}}function Yw(n){this.enabled!==!1&&n.preventDefault()}function Kw(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function $w(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}const Jw=`
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
}`,jw=`
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
}`,Dc={light:new Ke(.74,.75,.77),dark:new Ke(.5,.51,.54)};class qw extends on{constructor(){const e=new zp(Er,Gs,1,Sn);e.minFilter=e.magFilter=Ht,e.needsUpdate=!0,super({vertexShader:Jw,fragmentShader:jw,side:yn,polygonOffset:!0,polygonOffsetFactor:1.5,polygonOffsetUnits:8,uniforms:{colors:{value:e},reference:{value:new P},setBack:{value:0},quadratic:{value:!0},painted:{value:!1},shade:{value:0},showLines:{value:!0},largest:{value:1},lineStep:{value:0},linesPerLabel:{value:5},lineWidth:{value:1},front:{value:1/0},glow:{value:0},radius:{value:1e10},bare:{value:Dc.light}}})}setDark(e){this.uniforms.bare.value=e?Dc.dark:Dc.light}}function Qw(n){const[e,t,i]=[0,1,2].map(s=>_g(n,s));return i.size<.4*Math.min(e.size,t.size)||Kd(2,n)&&!Kd(1,n)?"z":"y"}function eT(n){const e=Qw(n),t=(e==="z"?38:16)*Math.PI/180;return Array.from({length:8},(s,r)=>{const a=(30+45*r)*Math.PI/180,o=new P(Math.sin(a),0,Math.cos(a)).multiplyScalar(Math.cos(t));return e==="y"?Yd(o.setY(Math.sin(t)),new P(0,1,0),n):Yd(new P(o.x,-o.z,Math.sin(t)),new P(0,0,1),n)}).reduce((s,r)=>Zd(r)>1.01*Zd(s)?r:s)}function Zd({halfSize:n}){return n.x*n.y}function Yd(n,e,t){const i=e.clone().cross(n).normalize(),s=n.clone().cross(i),r=new we,a=3*Math.ceil(t.length/15e3);for(let o=0;o<t.length;o+=a){const c=new P(t[o],t[o+1],t[o+2]);r.x=Math.max(r.x,Math.abs(c.dot(i))),r.y=Math.max(r.y,Math.abs(c.dot(s)))}return{up:e,direction:n,halfSize:r}}function _g(n,e){let t=1/0,i=-1/0;for(let s=e;s<n.length;s+=3)t=Math.min(t,n[s]),i=Math.max(i,n[s]);return{low:t,size:i-t}}function Kd(n,e){const{low:t,size:i}=_g(e,n),s=t+.03*i;return[(n+1)%3,(n+2)%3].every(r=>{let a=0,o=1/0,c=-1/0;for(let u=0;u<e.length;u+=3)a+=e[u+r],!(e[u+n]>s)&&(o=Math.min(o,e[u+r]),c=Math.max(c,e[u+r]));const l=3*a/e.length;return l>=o&&l<=c})}const tT=`
varying vec2 vUv;
void main() { vUv = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }`,nT=`
uniform sampler2D colors;
uniform sampler2D depths;
varying vec2 vUv;
void main() {
  gl_FragColor = vec4(texture2D(colors, vUv).rgb, 1.0);
  gl_FragDepth = texture2D(depths, vUv).r;
}`,$d=32,Jd=4,iT=.004,sT=50,rT=2e3,aT=3,oT=600,cT="This browser cannot draw meshes: it has no WebGL 2. Turn its hardware acceleration on, or take another browser.",lT=1.08;class uT{constructor(e){this.canvas=e,Xe.enabled=!1,this.renderer=new lS({canvas:e,antialias:!0}),this.renderer.outputColorSpace=Nr,this.renderer.autoClear=!1,this.detail=new zA(hT(this.renderer.getContext()),()=>{this.surfaceIsStale=!0,this.redraw()}),this.fine=this.target=Na(1,1,Jd),this.draft=Na(1,1,0),this.copyMaterial=new on({vertexShader:tT,fragmentShader:nT,depthFunc:no,uniforms:{colors:{value:null},depths:{value:null}}});const t=new An(new Gr(2,2),this.copyMaterial);t.frustumCulled=!1,this.copy.add(t),this.controls=new Bw(this.camera,e),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.minDistance=.02,this.controls.maxDistance=12,this.controls.addEventListener("change",()=>this.redrawSurface()),e.addEventListener("webglcontextlost",()=>this.onLost()),e.addEventListener("webglcontextrestored",()=>{this.renderer.setClearColor(this.background),this.redrawSurface(),this.onRestored()}),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}canvas;material=new qw;overlay=new Ko;resolution=new we(1,1);pixelRatio={value:1};depths={value:null};camera=new vn($d);onFrame=()=>!1;isBusy=()=>!1;onSurface=()=>{};onLost=()=>{};onRestored=()=>{};isWaiting=()=>!1;renderer;background=new Ke;controls;surface=new Ko;copy=new Ko;copyMaterial;screen=new gu;fine;draft;target;home;mesh;drawn;detail;surfaceIsStale=!0;frame=0;lastFrame=0;pause;get coarseFaces(){return this.detail.coarseFaces}mayBeWhole(e){return this.detail.mayBeWhole(e)}show(e){this.surface.clear(),this.mesh=e,this.drawn=new An(e.geometry,this.material),this.drawn.frustumCulled=!1,this.surface.add(this.drawn),this.home=eT(e.framed),this.camera.up.copy(this.home.up),this.lookAtAll()}lookAtAll(){if(!this.home)return;this.controls.target.set(0,0,0);const{direction:e,halfSize:t}=this.home,i=Math.max(t.x/this.camera.aspect,t.y),s=lT*i/Math.tan($d*Math.PI/360)+.3;this.camera.position.copy(e).multiplyScalar(s),this.controls.update(),this.redrawSurface()}turn(e,t,i){const s=this.camera.position.clone().sub(this.controls.target);s.applyAxisAngle(this.camera.up,e);const r=s.clone().cross(this.camera.up).normalize(),a=s.clone().applyAxisAngle(r,t);Math.abs(a.clone().normalize().dot(this.camera.up))<.995&&s.copy(a),this.camera.position.copy(this.controls.target).addScaledVector(s,i),this.controls.update(),this.redrawSurface()}setTurning(e){this.controls.enabled=e}setBackground(e,t){this.renderer.setClearColor(this.background.set(e)),this.material.setDark(t),this.redrawSurface()}pointerAt(e,t){const i=this.canvas.getBoundingClientRect();return new we(2*(e-i.left)/i.width-1,1-2*(t-i.top)/i.height)}pixelOf(e){const t=e.clone().project(this.camera);return new we((t.x+1)/2*this.canvas.clientWidth,(1-t.y)/2*this.canvas.clientHeight)}redrawSurface(){this.detail.change(),this.surfaceIsStale=!0,this.redraw()}redraw(){this.pause&&!this.isWaiting()&&(clearTimeout(this.pause),this.pause=void 0),!(this.frame||this.pause)&&(this.frame=requestAnimationFrame(e=>{const t=e-this.lastFrame;this.frame=0,this.lastFrame=e,this.isWaiting()&&t>sT&&t<rT&&(this.pause=setTimeout(()=>{this.pause=void 0,this.lastFrame=performance.now(),this.redraw()},Math.min(aT*t,oT))),this.onFrame(e)&&this.redrawSurface(),this.draw()}))}draw(){this.surfaceIsStale&&this.drawSurface(),this.copyMaterial.uniforms.colors.value=this.target.texture,this.copyMaterial.uniforms.depths.value=this.target.depthTexture,this.renderer.setRenderTarget(null),this.renderer.render(this.copy,this.screen),this.depths.value=this.target.depthTexture,this.renderer.render(this.overlay,this.camera)}takePicture(){const e=document.createElement("canvas");return e.width=this.canvas.width,e.height=this.canvas.height,this.detail.settle(),this.mesh&&this.drawSurface(WA(this.mesh)),this.draw(),e.getContext("2d")?.drawImage(this.canvas,0,0),e}drawSurface(e=!1){const t=this.camera.position.length();this.camera.near=Math.max(t-1.1,.004),this.camera.far=t+1.1,this.camera.updateProjectionMatrix();const i=this.mesh&&!e&&this.detail.isCoarse(this.mesh)?this.mesh.coarse:void 0;this.mesh&&this.drawn&&(this.drawn.geometry=i??this.mesh.geometry),this.material.uniforms.setBack.value=i?iT:0,this.target=this.detail.isDraft&&!e?this.draft:this.fine,this.renderer.setRenderTarget(this.target),this.renderer.clear(),this.renderer.render(this.surface,this.camera),this.surfaceIsStale=!1,this.mesh&&this.detail.drawn(this.mesh,this.isBusy()),document.documentElement.dataset.detail=this.mesh?this.detail.name(this.mesh):"",this.onSurface()}resize(){const e=Math.max(this.canvas.clientWidth,1),t=Math.max(this.canvas.clientHeight,1),i=Math.min(devicePixelRatio,2);this.renderer.setPixelRatio(i),this.renderer.setSize(e,t,!1),this.resolution.set(e,t),this.material.uniforms.lineWidth.value=i,this.camera.aspect=e/t,this.camera.updateProjectionMatrix();for(const s of[this.fine,this.draft])s.dispose(),s.depthTexture?.dispose();this.fine=this.target=Na(Math.round(e*i),Math.round(t*i),Jd),this.draft=Na(this.fine.width,this.fine.height,0),this.pixelRatio.value=i,this.surfaceIsStale=!0,this.draw()}}function Na(n,e,t){return new Un(n,e,{samples:t,depthTexture:new rs(n,e,Fn)})}function hT(n){const e=n.getExtension("WEBGL_debug_renderer_info");return String(n.getParameter(e?e.UNMASKED_RENDERER_WEBGL:n.RENDERER))}const jd=12;class fT{cross=Ae("aim");stage=Ae("stage");at;get point(){return this.at}move(e,t){const i=this.stage.getBoundingClientRect(),{x:s,y:r}=this.at??{x:i.left+i.width/2,y:i.top+i.height/2},a=(o,c,l)=>Math.min(Math.max(o,c),c+l-1);return this.at={x:a(s+e*jd,i.left,i.width),y:a(r+t*jd,i.top,i.height)},this.cross.style.left=`${this.at.x-i.left}px`,this.cross.style.top=`${this.at.y-i.top}px`,this.cross.hidden=!1,this.at}hide(){this.at=void 0,this.cross.hidden=!0}}const dT=5;function pT(n,e){let t,i=0;n.addEventListener("pointerdown",a=>{if(i++,a.button!==0||i>1){t?.draws&&e.drawn(),t=void 0;return}const o=e.drawsCurve(a.altKey),c={x:a.clientX,y:a.clientY},l=!o&&e.grabs(c);e.setTurning(!o&&!l),t={...c,moved:!1,draws:o,grabs:l,id:a.pointerId},(o||l)&&n.setPointerCapture(a.pointerId),o&&e.draw(c)},{capture:!0});const s="onpointerrawupdate"in window?"pointerrawupdate":"pointermove";n.addEventListener(s,a=>{const o={x:a.clientX,y:a.clientY};if(t&&a.pointerId===t.id){Math.hypot(o.x-t.x,o.y-t.y)>dT&&(t.moved=!0),t.draws&&t.moved&&e.draw(o),t.grabs&&t.moved&&e.drag(o);return}i===0&&e.move({...o,since:a.timeStamp})});const r=a=>{if(i=Math.max(i-1,0),!t||a.pointerId!==t.id)return;const{moved:o,draws:c,grabs:l}=t;t=void 0,e.setTurning(!0),c&&o?e.drawn():l&&o?e.dropped():!o&&a.type==="pointerup"&&e.click({x:a.clientX,y:a.clientY,shift:a.shiftKey})};return n.addEventListener("pointerup",r),n.addEventListener("pointercancel",r),n.addEventListener("pointerleave",()=>e.leave()),n.addEventListener("wheel",a=>{a.altKey&&(a.preventDefault(),a.stopImmediatePropagation(),e.wheel(Math.sign(a.deltaY||a.deltaX)))},{capture:!0,passive:!1}),{cancel:()=>!t?.draws&&!t?.grabs?!1:(t=void 0,e.setTurning(!0),!0)}}function mT(n){if(n.altKey)return!0;const e=n.target;return n.ctrlKey||n.metaKey?!/^[zy]$/i.test(n.key)||e.matches("input[type=number], input[type=password]"):e.matches("input:is([type=radio], [type=checkbox], [type=range])")?n.key.startsWith("Arrow"):e.matches("button, summary, a")?n.key==="Enter":e.matches("input, select, textarea")}const vg=0,gT=1,_T=2,qd=2,Uc=1.25,Qd=1,fn=32,At=fn/4,xg=65535,to=Math.pow(2,-24),$u=Symbol("SKIP_GENERATION"),yg={strategy:vg,maxDepth:40,targetLeafSize:10,useSharedArrayBuffer:!1,setBoundingBox:!0,onProgress:null,indirect:!1,verbose:!0,range:null,[$u]:!1};function _t(n,e,t){return t.min.x=e[n],t.min.y=e[n+1],t.min.z=e[n+2],t.max.x=e[n+3],t.max.y=e[n+4],t.max.z=e[n+5],t}function Jl(n){let e=-1,t=-1/0;for(let i=0;i<3;i++){const s=n[i+3]-n[i];s>t&&(t=s,e=i)}return e}function ep(n,e,t){for(let i=0;i<3;i++){const s=e[n+2*i],r=e[n+2*i+1],a=s-r,o=s+r;a<t[i]&&(t[i]=a),o>t[i+3]&&(t[i+3]=o)}}function Fc(n){const e=n[3]-n[0],t=n[4]-n[1],i=n[5]-n[2];return 2*(e*t+t*i+i*e)}function St(n,e){return e[n+15]===xg}function Ft(n,e){return e[n+6]}function Kt(n,e){return e[n+14]}function It(n){return n+At}function Ct(n,e){const t=e[n+6];return n+t*At}function Ju(n,e){return e[n+7]}function Bc(n,e,t,i,s){let r=1/0,a=1/0,o=1/0,c=-1/0,l=-1/0,u=-1/0,f=1/0,h=1/0,d=1/0,g=-1/0,y=-1/0,p=-1/0;const m=n.offset||0;for(let v=(e-m)*6,b=(e+t-m)*6;v<b;v+=6){const x=n[v+0],E=n[v+1],w=x-E,T=x+E;w<r&&(r=w),T>c&&(c=T),x<f&&(f=x),x>g&&(g=x);const _=n[v+2],M=n[v+3],N=_-M,R=_+M;N<a&&(a=N),R>l&&(l=R),_<h&&(h=_),_>y&&(y=_);const C=n[v+4],U=n[v+5],B=C-U,L=C+U;B<o&&(o=B),L>u&&(u=L),C<d&&(d=C),C>p&&(p=C)}i[0]=r,i[1]=a,i[2]=o,i[3]=c,i[4]=l,i[5]=u,s[0]=f,s[1]=h,s[2]=d,s[3]=g,s[4]=y,s[5]=p}const Zn=8,ju=8,Oc=new Int32Array(Zn),Xn=new Float32Array(Zn*6),ws=new Float32Array(Zn*6),Cn=new Float32Array(6),Ia=new Float32Array(6),Ii=new Int32Array(ju),tp=new Float32Array(ju*6);function vT(n,e,t,i){for(let s=0;s<3;s++){const r=e[n+2*s],a=e[n+2*s+1],o=r-a,c=r+a;o<t[i+s]&&(t[i+s]=o),c>t[i+s+3]&&(t[i+s+3]=c)}}function np(n,e){const t=n[e+3]-n[e],i=n[e+4]-n[e+1],s=n[e+5]-n[e+2];return 2*(t*i+i*s+s*t)}function xT(n,e,t,i,s,r){let a=-1,o=0;if(r===vg)a=Jl(e),a!==-1&&(o=(e[a]+e[a+3])/2);else if(r===gT)a=Jl(n),a!==-1&&(o=yT(t,i,s,a));else if(r===_T){const c=Fc(n);let l=Uc*s;const u=t.offset||0,f=(i-u)*6,h=(i+s-u)*6;for(let d=0;d<3;d++){const g=e[d],m=(e[d+3]-g)/Zn;if(s<ju){for(let v=0;v<s;v++){const b=f+v*6,x=t[b+2*d];let E=v;for(;E>0&&t[Ii[E-1]+2*d]>x;)Ii[E]=Ii[E-1],E--;Ii[E]=b}for(let v=0;v<3;v++)Cn[v]=1/0,Cn[v+3]=-1/0,Ia[v]=1/0,Ia[v+3]=-1/0;for(let v=s-1;v>=0;v--)ep(Ii[v],t,Ia),tp.set(Ia,v*6);for(let v=0;v<s-1;v++){ep(Ii[v],t,Cn);const b=t[Ii[v+1]+2*d];if(t[Ii[v]+2*d]===b)continue;const x=v+1,E=s-x,w=Fc(Cn)/c,T=np(tp,x*6)/c,_=Qd+Uc*(w*x+T*E);_<l&&(a=d,l=_,o=b)}}else{for(let x=0;x<Zn;x++){Oc[x]=0;for(let E=0;E<3;E++)Xn[x*6+E]=1/0,Xn[x*6+E+3]=-1/0}for(let x=f;x<h;x+=6){let T=~~((t[x+2*d]-g)/m);T>=Zn&&(T=Zn-1),Oc[T]++,vT(x,t,Xn,T*6)}const v=(Zn-1)*6;for(let x=0;x<6;x++)ws[v+x]=Xn[v+x];for(let x=Zn-2;x>=0;x--){const E=x*6,w=E+6;for(let T=0;T<3;T++)ws[E+T]=Math.min(Xn[E+T],ws[w+T]),ws[E+T+3]=Math.max(Xn[E+T+3],ws[w+T+3])}let b=0;for(let x=0;x<Zn-1;x++){const E=x*6,w=Oc[x];if(w!==0)for(let R=0;R<3;R++)b===0?(Cn[R]=Xn[E+R],Cn[R+3]=Xn[E+R+3]):(Cn[R]=Math.min(Cn[R],Xn[E+R]),Cn[R+3]=Math.max(Cn[R+3],Xn[E+R+3]));b+=w;let T=0,_=0;b!==0&&(T=Fc(Cn)/c);const M=s-b;M!==0&&(_=np(ws,E+6)/c);const N=Qd+Uc*(T*b+_*M);N<l&&(a=d,l=N,o=g+m+x*m)}}}}else console.warn(`BVH: Invalid build strategy value ${r} used.`);return{axis:a,pos:o}}function yT(n,e,t,i){let s=0;const r=n.offset;for(let a=e,o=e+t;a<o;a++)s+=n[(a-r)*6+i*2];return s/t}function bT(n,e,t,i,s,r){let a=i,o=i+s-1;const c=r.pos,l=r.axis*2,u=t.offset||0;for(;;){for(;a<=o&&t[(a-u)*6+l]<c;)a++;for(;a<=o&&t[(o-u)*6+l]>=c;)o--;if(a<o){for(let f=0;f<e;f++){let h=n[a*e+f];n[a*e+f]=n[o*e+f],n[o*e+f]=h}for(let f=0;f<6;f++){const h=a-u,d=o-u,g=t[h*6+f];t[h*6+f]=t[d*6+f],t[d*6+f]=g}a++,o--}else return a}}const ST=Math.pow(2,32),Ts=new Float32Array(6),Ca=new Float32Array(6);function ET(n,e,t,i,s,r){const{maxDepth:a,verbose:o,targetLeafSize:c,_strictLeafSize:l=1/0,strategy:u,onProgress:f,useSharedArrayBuffer:h=!1}=s,d=n.primitiveBuffer,g=n.primitiveBufferStride,y=h?SharedArrayBuffer:ArrayBuffer,p=new y(fn*Math.max(1,2*Math.ceil(i)-1)),m=new Float32Array(p),v=new Uint32Array(p),b=new Uint16Array(p);let x=0,E=!1;return Bc(e,t,i,Ts,Ca),_(t,i,0),p.slice(0,x*fn);function w(M){f&&f((M-r.offset)/r.count)}function T(M,N,R){const C=M*2;v[M+6]=N,b[C+14]=R,b[C+15]=xg,w(N+R)}function _(M,N,R){const C=x++,U=C*At;m.set(Ts,U),!E&&R>=a&&(E=!0,o&&console.warn(`BVH: Max depth of ${a} reached when generating BVH. Consider increasing maxDepth.`));const B=N>l;if(N<=c&&!B||R>=a){T(U,M,N);return}const L=xT(Ts,Ca,e,M,N,u);let V=L.axis===-1?-1:bT(d,g,e,M,N,L);if(L.axis===-1||V===M||V===M+N){if(!B){T(U,M,N);return}L.axis=Math.max(0,Jl(Ts)),V=M+Math.max(1,Math.floor(N/2))}v[U+7]=L.axis;const k=V-M;Bc(e,M,k,Ts,Ca),_(M,k,R+1);const j=x-C;if(j>ST)throw new Error("MeshBVH: Cannot store relative child node offset greater than 32 bits.");v[U+6]=j;const ee=N-k;Bc(e,V,ee,Ts,Ca),_(V,ee,R+1)}}function MT(n,e){const t=n.getRootRanges(e.range),i=t[0],s=t[t.length-1],r={offset:i.offset,count:s.offset+s.count-i.offset},a=new Float32Array(6*r.count);a.offset=r.offset,n.computePrimitiveBounds(r.offset,r.count,a),n._roots=t.map(o=>ET(n,a,o.offset,o.count,e,r))}class qu{constructor(e){this._getNewPrimitive=e,this._primitives=[]}getPrimitive(){const e=this._primitives;return e.length===0?this._getNewPrimitive():e.pop()}releasePrimitive(e){this._primitives.push(e)}}class AT{constructor(){this.float32Array=null,this.uint16Array=null,this.uint32Array=null;const e=[];let t=null;this.setBuffer=i=>{t&&e.push(t),t=i,this.float32Array=new Float32Array(i),this.uint16Array=new Uint16Array(i),this.uint32Array=new Uint32Array(i)},this.clearBuffer=()=>{t=null,this.float32Array=null,this.uint16Array=null,this.uint32Array=null,e.length!==0&&this.setBuffer(e.pop())}}}const tt=new AT;let Ui,Bs;const Rs=[],Pa=new qu(()=>new Ot);function wT(n,e,t,i,s,r){Ui=Pa.getPrimitive(),Bs=Pa.getPrimitive(),Rs.push(Ui,Bs),tt.setBuffer(n._roots[e]);const a=jl(0,n.geometry,t,i,s,r);tt.clearBuffer(),Pa.releasePrimitive(Ui),Pa.releasePrimitive(Bs),Rs.pop(),Rs.pop();const o=Rs.length;return o>0&&(Bs=Rs[o-1],Ui=Rs[o-2]),a}function jl(n,e,t,i,s=null,r=0,a=0){const{float32Array:o,uint16Array:c,uint32Array:l}=tt;let u=n*2;if(St(u,c)){const g=Ft(n,l),y=Kt(u,c);return _t(n,o,Ui),i(g,y,!1,a,r+n/At,Ui)}else{let C=function(B){const{uint16Array:L,uint32Array:V}=tt;let k=B*2;for(;!St(k,L);)B=It(B),k=B*2;return Ft(B,V)},U=function(B){const{uint16Array:L,uint32Array:V}=tt;let k=B*2;for(;!St(k,L);)B=Ct(B,V),k=B*2;return Ft(B,V)+Kt(k,L)};var h=C,d=U;const g=It(n),y=Ct(n,l);let p=g,m=y,v,b,x,E;if(s&&(x=Ui,E=Bs,_t(p,o,x),_t(m,o,E),v=s(x),b=s(E),b<v)){p=y,m=g;const B=v;v=b,b=B,x=E}x||(x=Ui,_t(p,o,x));const w=St(p*2,c),T=t(x,w,v,a+1,r+p/At);let _;if(T===qd){const B=C(p),V=U(p)-B;_=i(B,V,!0,a+1,r+p/At,x)}else _=T&&jl(p,e,t,i,s,r,a+1);if(_)return!0;E=Bs,_t(m,o,E);const M=St(m*2,c),N=t(E,M,b,a+1,r+m/At);let R;if(N===qd){const B=C(m),V=U(m)-B;R=i(B,V,!0,a+1,r+m/At,E)}else R=N&&jl(m,e,t,i,s,r,a+1);return!!R}}const wr=new tt.constructor,vo=new tt.constructor,Ci=new qu(()=>new Ot),Ns=new Ot,Is=new Ot,Vc=new Ot,kc=new Ot;let Gc=!1;function TT(n,e,t,i){if(Gc)throw new Error("MeshBVH: Recursive calls to bvhcast not supported.");Gc=!0;const s=n._roots,r=e._roots;let a,o=0,c=0;const l=new je().copy(t).invert();for(let u=0,f=s.length;u<f;u++){wr.setBuffer(s[u]),c=0;const h=Ci.getPrimitive();_t(0,wr.float32Array,h),h.applyMatrix4(l);for(let d=0,g=r.length;d<g&&(vo.setBuffer(r[d]),a=Pn(0,0,t,l,i,o,c,0,0,h),vo.clearBuffer(),c+=r[d].byteLength/fn,!a);d++);if(Ci.releasePrimitive(h),wr.clearBuffer(),o+=s[u].byteLength/fn,a)break}return Gc=!1,a}function Pn(n,e,t,i,s,r=0,a=0,o=0,c=0,l=null,u=!1){let f,h;u?(f=vo,h=wr):(f=wr,h=vo);const d=f.float32Array,g=f.uint32Array,y=f.uint16Array,p=h.float32Array,m=h.uint32Array,v=h.uint16Array,b=n*2,x=e*2,E=St(b,y),w=St(x,v);let T=!1;if(w&&E)u?T=s(Ft(e,m),Kt(e*2,v),Ft(n,g),Kt(n*2,y),c,a+e/At,o,r+n/At):T=s(Ft(n,g),Kt(n*2,y),Ft(e,m),Kt(e*2,v),o,r+n/At,c,a+e/At);else if(w){const _=Ci.getPrimitive();_t(e,p,_),_.applyMatrix4(t);const M=It(n),N=Ct(n,g);_t(M,d,Ns),_t(N,d,Is);const R=_.intersectsBox(Ns),C=_.intersectsBox(Is);T=R&&Pn(e,M,i,t,s,a,r,c,o+1,_,!u)||C&&Pn(e,N,i,t,s,a,r,c,o+1,_,!u),Ci.releasePrimitive(_)}else{const _=It(e),M=Ct(e,m);_t(_,p,Vc),_t(M,p,kc);const N=l.intersectsBox(Vc),R=l.intersectsBox(kc);if(N&&R)T=Pn(n,_,t,i,s,r,a,o,c+1,l,u)||Pn(n,M,t,i,s,r,a,o,c+1,l,u);else if(N)if(E)T=Pn(n,_,t,i,s,r,a,o,c+1,l,u);else{const C=Ci.getPrimitive();C.copy(Vc).applyMatrix4(t);const U=It(n),B=Ct(n,g);_t(U,d,Ns),_t(B,d,Is);const L=C.intersectsBox(Ns),V=C.intersectsBox(Is);T=L&&Pn(_,U,i,t,s,a,r,c,o+1,C,!u)||V&&Pn(_,B,i,t,s,a,r,c,o+1,C,!u),Ci.releasePrimitive(C)}else if(R)if(E)T=Pn(n,M,t,i,s,r,a,o,c+1,l,u);else{const C=Ci.getPrimitive();C.copy(kc).applyMatrix4(t);const U=It(n),B=Ct(n,g);_t(U,d,Ns),_t(B,d,Is);const L=C.intersectsBox(Ns),V=C.intersectsBox(Is);T=L&&Pn(M,U,i,t,s,a,r,c,o+1,C,!u)||V&&Pn(M,B,i,t,s,a,r,c,o+1,C,!u),Ci.releasePrimitive(C)}}return T}const zc=new class{constructor(){let n=null,e=null,t=null,i=!1;this.root=null,this.buffer=null,this.uint32Array=null,this.uint16Array=null,this.setBVH=(r,a)=>{if(i)throw new Error("BVHTraversalHelper: cannot call setBVH during an active traversal.");this.root=a,this.buffer=n=r._roots[a],this.uint16Array=t=new Uint16Array(n),this.uint32Array=e=new Uint32Array(n)},this.reset=()=>{this.root=null,this.buffer=n=null,this.uint16Array=t=null,this.uint32Array=e=null},this.getRangeStart=r=>{let a=r*2;for(;!St(a,t);)r=It(r),a=r*2;return Ft(r,e)},this.getRangeEnd=r=>{let a=r*2;for(;!St(a,t);)r=Ct(r,e),a=r*2;return Ft(r,e)+Kt(a,t)};const s=(r,a,o)=>{const c=a*2,l=St(c,t);if(!r(o,l,a)&&!l){const f=It(a),h=Ct(a,e);s(r,f,o+1),s(r,h,o+1)}};this.traverseBuffer=r=>{if(i)throw new Error("BVHTraversalHelper: cannot start a traversal during an active traversal.");i=!0;try{s(r,0,0)}finally{i=!1}},this.traverse=r=>{this.traverseBuffer((a,o,c)=>{if(o){const l=c*2,u=e[c+6],f=t[l+14];return r(a,o,new Float32Array(n,c*4,6),u,f)}else{const l=Ju(c,e);return r(a,o,new Float32Array(n,c*4,6),l)}})}}},ip=new Ot,Cs=new Float32Array(6);class RT{constructor(){this._roots=null,this.primitiveBuffer=null,this.primitiveBufferStride=null}init(e){e={...yg,...e},"maxLeafSize"in e&&(console.warn('BVH: "maxLeafSize" option has been deprecated. Use "targetLeafSize", instead.'),e={...e,targetLeafSize:e.maxLeafSize}),MT(this,e)}getRootRanges(){throw new Error("BVH: getRootRanges() not implemented")}writePrimitiveBounds(){throw new Error("BVH: writePrimitiveBounds() not implemented")}writePrimitiveRangeBounds(e,t,i,s){let r=1/0,a=1/0,o=1/0,c=-1/0,l=-1/0,u=-1/0;for(let f=e,h=e+t;f<h;f++){this.writePrimitiveBounds(f,Cs,0);const[d,g,y,p,m,v]=Cs;d<r&&(r=d),p>c&&(c=p),g<a&&(a=g),m>l&&(l=m),y<o&&(o=y),v>u&&(u=v)}return i[s+0]=r,i[s+1]=a,i[s+2]=o,i[s+3]=c,i[s+4]=l,i[s+5]=u,i}computePrimitiveBounds(e,t,i){const s=i.offset||0;for(let r=e,a=e+t;r<a;r++){this.writePrimitiveBounds(r,Cs,0);const[o,c,l,u,f,h]=Cs,d=(o+u)/2,g=(c+f)/2,y=(l+h)/2,p=(u-o)/2,m=(f-c)/2,v=(h-l)/2,b=(r-s)*6;i[b+0]=d,i[b+1]=p+(Math.abs(d)+p)*to,i[b+2]=g,i[b+3]=m+(Math.abs(g)+m)*to,i[b+4]=y,i[b+5]=v+(Math.abs(y)+v)*to}return i}shiftPrimitiveOffsets(e){const t=this._indirectBuffer;if(t)for(let i=0,s=t.length;i<s;i++)t[i]+=e;else{const i=this._roots;for(let s=0;s<i.length;s++){const r=i[s],a=new Uint32Array(r),o=new Uint16Array(r),c=r.byteLength/fn;for(let l=0;l<c;l++){const u=At*l,f=2*u;St(f,o)&&(a[u+6]+=e)}}}}traverse(e,t=0){zc.setBVH(this,t),zc.traverse(e),zc.reset()}refit(){const e=this._roots;for(let t=0,i=e.length;t<i;t++){const s=e[t],r=new Uint32Array(s),a=new Uint16Array(s),o=new Float32Array(s),c=s.byteLength/fn;for(let l=c-1;l>=0;l--){const u=l*At,f=u*2;if(St(f,a)){const d=Ft(u,r),g=Kt(f,a);this.writePrimitiveRangeBounds(d,g,Cs,0),o.set(Cs,u)}else{const d=It(u),g=Ct(u,r);for(let y=0;y<3;y++){const p=o[d+y],m=o[d+y+3],v=o[g+y],b=o[g+y+3];o[u+y]=p<v?p:v,o[u+y+3]=m>b?m:b}}}}}getBoundingBox(e){return e.makeEmpty(),this._roots.forEach(i=>{_t(0,new Float32Array(i),ip),e.union(ip)}),e}shapecast(e){let{boundsTraverseOrder:t,intersectsBounds:i,intersectsRange:s,intersectsPrimitive:r,scratchPrimitive:a,iterate:o}=e;if(s&&r){const f=s;s=(h,d,g,y,p)=>f(h,d,g,y,p)?!0:o(h,d,this,r,g,y,a)}else s||(r?s=(f,h,d,g)=>o(f,h,this,r,d,g,a):s=(f,h,d)=>d);let c=!1,l=0;const u=this._roots;for(let f=0,h=u.length;f<h;f++){const d=u[f];if(c=wT(this,f,i,s,t,l),c)break;l+=d.byteLength/fn}return c}bvhcast(e,t,i){let{intersectsRanges:s}=i;return TT(this,e,t,s)}}function NT(){return typeof SharedArrayBuffer<"u"}function Qu(n){return n.index?n.index.count:n.attributes.position.count}function Co(n){return Qu(n)/3}function IT(n,e=ArrayBuffer){return n>65535?new Uint32Array(new e(4*n)):new Uint16Array(new e(2*n))}function CT(n,e){if(!n.index){const t=n.attributes.position.count,i=e.useSharedArrayBuffer?SharedArrayBuffer:ArrayBuffer,s=IT(t,i);n.setIndex(new Et(s,1));for(let r=0;r<t;r++)s[r]=r}}function PT(n,e,t){const i=Qu(n)/t,s=e||n.drawRange,r=s.start/t,a=(s.start+s.count)/t,o=Math.max(0,r),c=Math.min(i,a)-o;return{offset:Math.floor(o),count:Math.floor(c)}}function LT(n,e){return n.groups.map(t=>({offset:t.start/e,count:t.count/e}))}function sp(n,e,t){const i=PT(n,e,t),s=LT(n,t);if(!s.length)return[i];const r=[],a=i.offset,o=i.offset+i.count,c=Qu(n)/t,l=[];for(const h of s){const{offset:d,count:g}=h,y=d,p=isFinite(g)?g:c-d,m=d+p;y<o&&m>a&&(l.push({pos:Math.max(a,y),isStart:!0}),l.push({pos:Math.min(o,m),isStart:!1}))}l.sort((h,d)=>h.pos!==d.pos?h.pos-d.pos:h.type==="end"?-1:1);let u=0,f=null;for(const h of l){const d=h.pos;u!==0&&d!==f&&r.push({offset:f,count:d-f}),u+=h.isStart?1:-1,f=d}return r}function DT(n,e){const t=n[n.length-1],i=t.offset+t.count>2**16,s=n.reduce((l,u)=>l+u.count,0),r=i?4:2,a=e?new SharedArrayBuffer(s*r):new ArrayBuffer(s*r),o=i?new Uint32Array(a):new Uint16Array(a);let c=0;for(let l=0;l<n.length;l++){const{offset:u,count:f}=n[l];for(let h=0;h<f;h++)o[c+h]=u+h;c+=f}return o}class UT extends RT{get indirect(){return!!this._indirectBuffer}get primitiveStride(){return null}get primitiveBufferStride(){return this.indirect?1:this.primitiveStride}set primitiveBufferStride(e){}get primitiveBuffer(){return this.indirect?this._indirectBuffer:this.geometry.index.array}set primitiveBuffer(e){}constructor(e,t={}){if(e.isBufferGeometry){if(e.index&&e.index.isInterleavedBufferAttribute)throw new Error("BVH: InterleavedBufferAttribute is not supported for the index attribute.")}else throw new Error("BVH: Only BufferGeometries are supported.");if(t.useSharedArrayBuffer&&!NT())throw new Error("BVH: SharedArrayBuffer is not available.");super(),this.geometry=e,this.resolvePrimitiveIndex=t.indirect?i=>this._indirectBuffer[i]:i=>i,this.primitiveBuffer=null,this.primitiveBufferStride=null,this._indirectBuffer=null,t={...yg,...t},t[$u]||this.init(t)}init(e){const{geometry:t,primitiveStride:i}=this;if(e.indirect){const s=sp(t,e.range,i),r=DT(s,e.useSharedArrayBuffer);this._indirectBuffer=r}else CT(t,e);super.init(e),!t.boundingBox&&e.setBoundingBox&&(t.boundingBox=this.getBoundingBox(new Ot))}getRootRanges(e){return this.indirect?[{offset:0,count:this._indirectBuffer.length}]:sp(this.geometry,e,this.primitiveStride)}raycastObject3D(){throw new Error("BVH: raycastObject3D() not implemented")}}class gi{constructor(){this.min=1/0,this.max=-1/0}setFromPointsField(e,t){let i=1/0,s=-1/0;for(let r=0,a=e.length;r<a;r++){const c=e[r][t];i=c<i?c:i,s=c>s?c:s}this.min=i,this.max=s}setFromPoints(e,t){let i=1/0,s=-1/0;for(let r=0,a=t.length;r<a;r++){const o=t[r],c=e.dot(o);i=c<i?c:i,s=c>s?c:s}this.min=i,this.max=s}isSeparated(e){return this.min>e.max||e.min>this.max}}gi.prototype.setFromBox=(function(){const n=new P;return function(t,i){const s=i.min,r=i.max;let a=1/0,o=-1/0;for(let c=0;c<=1;c++)for(let l=0;l<=1;l++)for(let u=0;u<=1;u++){n.x=s.x*c+r.x*(1-c),n.y=s.y*l+r.y*(1-l),n.z=s.z*u+r.z*(1-u);const f=t.dot(n);a=Math.min(f,a),o=Math.max(f,o)}this.min=a,this.max=o}})();const FT=(function(){const n=new P,e=new P,t=new P;return function(s,r,a){const o=s.start,c=n,l=r.start,u=e;t.subVectors(o,l),n.subVectors(s.end,s.start),e.subVectors(r.end,r.start);const f=t.dot(u),h=u.dot(c),d=u.dot(u),g=t.dot(c),p=c.dot(c)*d-h*h;let m,v;p!==0?m=(f*h-g*d)/p:m=0,v=(f+m*h)/d,a.x=m,a.y=v}})(),eh=(function(){const n=new we,e=new P,t=new P;return function(s,r,a,o){FT(s,r,n);let c=n.x,l=n.y;if(c>=0&&c<=1&&l>=0&&l<=1){s.at(c,a),r.at(l,o);return}else if(c>=0&&c<=1){l<0?r.at(0,o):r.at(1,o),s.closestPointToPoint(o,!0,a);return}else if(l>=0&&l<=1){c<0?s.at(0,a):s.at(1,a),r.closestPointToPoint(a,!0,o);return}else{let u;c<0?u=s.start:u=s.end;let f;l<0?f=r.start:f=r.end;const h=e,d=t;if(s.closestPointToPoint(f,!0,e),r.closestPointToPoint(u,!0,t),h.distanceToSquared(f)<=d.distanceToSquared(u)){a.copy(h),o.copy(f);return}else{a.copy(u),o.copy(d);return}}}})(),BT=(function(){const n=new P,e=new P,t=new Yn,i=new Qn;return function(r,a){const{radius:o,center:c}=r,{a:l,b:u,c:f}=a;if(i.start=l,i.end=u,i.closestPointToPoint(c,!0,n).distanceTo(c)<=o||(i.start=l,i.end=f,i.closestPointToPoint(c,!0,n).distanceTo(c)<=o)||(i.start=u,i.end=f,i.closestPointToPoint(c,!0,n).distanceTo(c)<=o))return!0;const y=a.getPlane(t);if(Math.abs(y.distanceToPoint(c))<=o){const m=y.projectPoint(c,e);if(a.containsPoint(m))return!0}return!1}})(),OT=["x","y","z"],ci=1e-15,rp=ci*ci;function gn(n){return Math.abs(n)<ci}class Bn extends Ut{constructor(...e){super(...e),this.isExtendedTriangle=!0,this.satAxes=new Array(4).fill().map(()=>new P),this.satBounds=new Array(4).fill().map(()=>new gi),this.points=[this.a,this.b,this.c],this.plane=new Yn,this.isDegenerateIntoSegment=!1,this.isDegenerateIntoPoint=!1,this.degenerateSegment=new Qn,this.needsUpdate=!0}intersectsSphere(e){return BT(e,this)}update(){const e=this.a,t=this.b,i=this.c,s=this.points,r=this.satAxes,a=this.satBounds,o=r[0],c=a[0];this.getNormal(o),c.setFromPoints(o,s);const l=r[1],u=a[1];l.subVectors(e,t),u.setFromPoints(l,s);const f=r[2],h=a[2];f.subVectors(t,i),h.setFromPoints(f,s);const d=r[3],g=a[3];d.subVectors(i,e),g.setFromPoints(d,s);const y=l.length(),p=f.length(),m=d.length();this.isDegenerateIntoPoint=!1,this.isDegenerateIntoSegment=!1,y<ci?p<ci||m<ci?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(e),this.degenerateSegment.end.copy(i)):p<ci?m<ci?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(t),this.degenerateSegment.end.copy(e)):m<ci&&(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(i),this.degenerateSegment.end.copy(t)),this.plane.setFromNormalAndCoplanarPoint(o,e),this.needsUpdate=!1}}Bn.prototype.closestPointToSegment=(function(){const n=new P,e=new P,t=new Qn;return function(s,r=null,a=null){this.needsUpdate&&this.update();const{start:o,end:c}=s,l=this.points;let u,f=1/0;const h=this.plane.distanceToPoint(o),d=this.plane.distanceToPoint(c);if(h*d<0&&this.plane.intersectLine(s,n)!==null&&this.containsPoint(n))return r&&r.copy(n),a&&a.copy(n),0;for(let g=0;g<3;g++){const y=(g+1)%3;t.start.copy(l[g]),t.end.copy(l[y]),eh(t,s,n,e),u=n.distanceToSquared(e),u<f&&(f=u,r&&r.copy(n),a&&a.copy(e))}return this.closestPointToPoint(o,n),u=o.distanceToSquared(n),u<f&&(f=u,r&&r.copy(n),a&&a.copy(o)),this.closestPointToPoint(c,n),u=c.distanceToSquared(n),u<f&&(f=u,r&&r.copy(n),a&&a.copy(c)),Math.sqrt(f)}})();Bn.prototype.intersectsTriangle=(function(){const n=new Bn,e=new gi,t=new gi,i=new P,s=new P,r=new P,a=new P,o=new Qn,c=new Qn,l=new P,u=new we,f=new we;function h(b,x,E,w){const T=i;!b.isDegenerateIntoPoint&&!b.isDegenerateIntoSegment?T.copy(b.plane.normal):T.copy(x.plane.normal);const _=b.satBounds,M=b.satAxes;for(let C=1;C<4;C++){const U=_[C],B=M[C];if(e.setFromPoints(B,x.points),U.isSeparated(e)||(a.copy(T).cross(B),e.setFromPoints(a,b.points),t.setFromPoints(a,x.points),e.isSeparated(t)))return!1}const N=x.satBounds,R=x.satAxes;for(let C=1;C<4;C++){const U=N[C],B=R[C];if(e.setFromPoints(B,b.points),U.isSeparated(e)||(a.crossVectors(T,B),e.setFromPoints(a,b.points),t.setFromPoints(a,x.points),e.isSeparated(t)))return!1}return E&&(w||console.warn("ExtendedTriangle.intersectsTriangle: Triangles are coplanar which does not support an output edge. Setting edge to 0, 0, 0."),E.start.set(0,0,0),E.end.set(0,0,0)),!0}function d(b,x,E,w,T,_,M,N,R,C,U){let B=M/(M-N);C.x=w+(T-w)*B,U.start.subVectors(x,b).multiplyScalar(B).add(b),B=M/(M-R),C.y=w+(_-w)*B,U.end.subVectors(E,b).multiplyScalar(B).add(b)}function g(b,x,E,w,T,_,M,N,R,C,U){if(T>0)d(b.c,b.a,b.b,w,x,E,R,M,N,C,U);else if(_>0)d(b.b,b.a,b.c,E,x,w,N,M,R,C,U);else if(N*R>0||M!=0)d(b.a,b.b,b.c,x,E,w,M,N,R,C,U);else if(N!=0)d(b.b,b.a,b.c,E,x,w,N,M,R,C,U);else if(R!=0)d(b.c,b.a,b.b,w,x,E,R,M,N,C,U);else return!0;return!1}function y(b,x,E,w){const T=x.degenerateSegment,_=b.plane.distanceToPoint(T.start),M=b.plane.distanceToPoint(T.end);return gn(_)?gn(M)?h(b,x,E,w):(E&&(E.start.copy(T.start),E.end.copy(T.start)),b.containsPoint(T.start)):gn(M)?(E&&(E.start.copy(T.end),E.end.copy(T.end)),b.containsPoint(T.end)):b.plane.intersectLine(T,i)!=null?(E&&(E.start.copy(i),E.end.copy(i)),b.containsPoint(i)):!1}function p(b,x,E){const w=x.a;return gn(b.plane.distanceToPoint(w))&&b.containsPoint(w)?(E&&(E.start.copy(w),E.end.copy(w)),!0):!1}function m(b,x,E){const w=b.degenerateSegment,T=x.a;return w.closestPointToPoint(T,!0,i),T.distanceToSquared(i)<rp?(E&&(E.start.copy(T),E.end.copy(T)),!0):!1}function v(b,x,E,w){if(b.isDegenerateIntoSegment)if(x.isDegenerateIntoSegment){const T=b.degenerateSegment,_=x.degenerateSegment,M=s,N=r;T.delta(M),_.delta(N);const R=i.subVectors(_.start,T.start),C=M.x*N.y-M.y*N.x;if(gn(C))return!1;const U=(R.x*N.y-R.y*N.x)/C,B=-(M.x*R.y-M.y*R.x)/C;if(U<0||U>1||B<0||B>1)return!1;const L=T.start.z+M.z*U,V=_.start.z+N.z*B;return gn(L-V)?(E&&(E.start.copy(T.start).addScaledVector(M,U),E.end.copy(T.start).addScaledVector(M,U)),!0):!1}else return x.isDegenerateIntoPoint?m(b,x,E):y(x,b,E,w);else{if(b.isDegenerateIntoPoint)return x.isDegenerateIntoPoint?x.a.distanceToSquared(b.a)<rp?(E&&(E.start.copy(b.a),E.end.copy(b.a)),!0):!1:x.isDegenerateIntoSegment?m(x,b,E):p(x,b,E);if(x.isDegenerateIntoPoint)return p(b,x,E);if(x.isDegenerateIntoSegment)return y(b,x,E,w)}}return function(x,E=null,w=!1){this.needsUpdate&&this.update(),x.isExtendedTriangle?x.needsUpdate&&x.update():(n.copy(x),n.update(),x=n);const T=v(this,x,E,w);if(T!==void 0)return T;const _=this.plane,M=x.plane;let N=M.distanceToPoint(this.a),R=M.distanceToPoint(this.b),C=M.distanceToPoint(this.c);gn(N)&&(N=0),gn(R)&&(R=0),gn(C)&&(C=0);const U=N*R,B=N*C;if(U>0&&B>0)return!1;let L=_.distanceToPoint(x.a),V=_.distanceToPoint(x.b),k=_.distanceToPoint(x.c);gn(L)&&(L=0),gn(V)&&(V=0),gn(k)&&(k=0);const j=L*V,ee=L*k;if(j>0&&ee>0)return!1;s.copy(_.normal),r.copy(M.normal);const le=s.cross(r);let xe=0,ye=Math.abs(le.x);const ze=Math.abs(le.y);ze>ye&&(ye=ze,xe=1),Math.abs(le.z)>ye&&(xe=2);const Ie=OT[xe],J=this.a[Ie],he=this.b[Ie],se=this.c[Ie],Te=x.a[Ie],Ce=x.b[Ie],Re=x.c[Ie];if(g(this,J,he,se,U,B,N,R,C,u,o))return h(this,x,E,w);if(g(x,Te,Ce,Re,j,ee,L,V,k,f,c))return h(this,x,E,w);if(u.y<u.x){const at=u.y;u.y=u.x,u.x=at,l.copy(o.start),o.start.copy(o.end),o.end.copy(l)}if(f.y<f.x){const at=f.y;f.y=f.x,f.x=at,l.copy(c.start),c.start.copy(c.end),c.end.copy(l)}return u.y<f.x||f.y<u.x?!1:(E&&(f.x>u.x?E.start.copy(c.start):E.start.copy(o.start),f.y<u.y?E.end.copy(c.end):E.end.copy(o.end)),!0)}})();Bn.prototype.distanceToPoint=(function(){const n=new P;return function(t){return this.closestPointToPoint(t,n),t.distanceTo(n)}})();Bn.prototype.distanceToTriangle=(function(){const n=new P,e=new P,t=["a","b","c"],i=new Qn,s=new Qn;return function(a,o=null,c=null){const l=o||c?i:null;if(this.intersectsTriangle(a,l,!0))return(o||c)&&(o&&l.getCenter(o),c&&l.getCenter(c)),0;let u=1/0;for(let f=0;f<3;f++){let h;const d=t[f],g=a[d];this.closestPointToPoint(g,n),h=g.distanceToSquared(n),h<u&&(u=h,o&&o.copy(n),c&&c.copy(g));const y=this[d];a.closestPointToPoint(y,n),h=y.distanceToSquared(n),h<u&&(u=h,o&&o.copy(y),c&&c.copy(n))}for(let f=0;f<3;f++){const h=t[f],d=t[(f+1)%3];i.set(this[h],this[d]);for(let g=0;g<3;g++){const y=t[g],p=t[(g+1)%3];s.set(a[y],a[p]),eh(i,s,n,e);const m=n.distanceToSquared(e);m<u&&(u=m,o&&o.copy(n),c&&c.copy(e))}}return Math.sqrt(u)}})();class tn{constructor(e,t,i){this.isOrientedBox=!0,this.min=new P,this.max=new P,this.matrix=new je,this.invMatrix=new je,this.points=new Array(8).fill().map(()=>new P),this.satAxes=new Array(3).fill().map(()=>new P),this.satBounds=new Array(3).fill().map(()=>new gi),this.alignedSatBounds=new Array(3).fill().map(()=>new gi),this.needsUpdate=!1,e&&this.min.copy(e),t&&this.max.copy(t),i&&this.matrix.copy(i)}set(e,t,i){this.min.copy(e),this.max.copy(t),this.matrix.copy(i),this.needsUpdate=!0}copy(e){this.min.copy(e.min),this.max.copy(e.max),this.matrix.copy(e.matrix),this.needsUpdate=!0}}tn.prototype.update=(function(){return function(){const e=this.matrix,t=this.min,i=this.max,s=this.points;for(let l=0;l<=1;l++)for(let u=0;u<=1;u++)for(let f=0;f<=1;f++){const h=1*l|2*u|4*f,d=s[h];d.x=l?i.x:t.x,d.y=u?i.y:t.y,d.z=f?i.z:t.z,d.applyMatrix4(e)}const r=this.satBounds,a=this.satAxes,o=s[0];for(let l=0;l<3;l++){const u=a[l],f=r[l],h=1<<l,d=s[h];u.subVectors(o,d),f.setFromPoints(u,s)}const c=this.alignedSatBounds;c[0].setFromPointsField(s,"x"),c[1].setFromPointsField(s,"y"),c[2].setFromPointsField(s,"z"),this.invMatrix.copy(this.matrix).invert(),this.needsUpdate=!1}})();tn.prototype.intersectsBox=(function(){const n=new gi;return function(t){this.needsUpdate&&this.update();const i=t.min,s=t.max,r=this.satBounds,a=this.satAxes,o=this.alignedSatBounds;if(n.min=i.x,n.max=s.x,o[0].isSeparated(n)||(n.min=i.y,n.max=s.y,o[1].isSeparated(n))||(n.min=i.z,n.max=s.z,o[2].isSeparated(n)))return!1;for(let c=0;c<3;c++){const l=a[c],u=r[c];if(n.setFromBox(l,t),u.isSeparated(n))return!1}return!0}})();tn.prototype.intersectsTriangle=(function(){const n=new Bn,e=new Array(3),t=new gi,i=new gi,s=new P;return function(a){this.needsUpdate&&this.update(),a.isExtendedTriangle?a.needsUpdate&&a.update():(n.copy(a),n.update(),a=n);const o=this.satBounds,c=this.satAxes;e[0]=a.a,e[1]=a.b,e[2]=a.c;for(let h=0;h<3;h++){const d=o[h],g=c[h];if(t.setFromPoints(g,e),d.isSeparated(t))return!1}const l=a.satBounds,u=a.satAxes,f=this.points;for(let h=0;h<3;h++){const d=l[h],g=u[h];if(t.setFromPoints(g,f),d.isSeparated(t))return!1}for(let h=0;h<3;h++){const d=c[h];for(let g=0;g<4;g++){const y=u[g];if(s.crossVectors(d,y),t.setFromPoints(s,e),i.setFromPoints(s,f),t.isSeparated(i))return!1}}return!0}})();tn.prototype.closestPointToPoint=(function(){return function(e,t){return this.needsUpdate&&this.update(),t.copy(e).applyMatrix4(this.invMatrix).clamp(this.min,this.max).applyMatrix4(this.matrix),t}})();tn.prototype.distanceToPoint=(function(){const n=new P;return function(t){return this.closestPointToPoint(t,n),t.distanceTo(n)}})();tn.prototype.distanceToBox=(function(){const n=["x","y","z"],e=new Array(12).fill().map(()=>new Qn),t=new Array(12).fill().map(()=>new Qn),i=new P,s=new P;return function(a,o=0,c=null,l=null){if(this.needsUpdate&&this.update(),this.intersectsBox(a))return(c||l)&&(a.getCenter(s),this.closestPointToPoint(s,i),a.closestPointToPoint(i,s),c&&c.copy(i),l&&l.copy(s)),0;const u=o*o,f=a.min,h=a.max,d=this.points;let g=1/0;for(let p=0;p<8;p++){const m=d[p];s.copy(m).clamp(f,h);const v=m.distanceToSquared(s);if(v<g&&(g=v,c&&c.copy(m),l&&l.copy(s),v<u))return Math.sqrt(v)}let y=0;for(let p=0;p<3;p++)for(let m=0;m<=1;m++)for(let v=0;v<=1;v++){const b=(p+1)%3,x=(p+2)%3,E=m<<b|v<<x,w=1<<p|m<<b|v<<x,T=d[E],_=d[w];e[y].set(T,_);const N=n[p],R=n[b],C=n[x],U=t[y],B=U.start,L=U.end;B[N]=f[N],B[R]=m?f[R]:h[R],B[C]=v?f[C]:h[C],L[N]=h[N],L[R]=m?f[R]:h[R],L[C]=v?f[C]:h[C],y++}for(let p=0;p<=1;p++)for(let m=0;m<=1;m++)for(let v=0;v<=1;v++){s.x=p?h.x:f.x,s.y=m?h.y:f.y,s.z=v?h.z:f.z,this.closestPointToPoint(s,i);const b=s.distanceToSquared(i);if(b<g&&(g=b,c&&c.copy(i),l&&l.copy(s),b<u))return Math.sqrt(b)}for(let p=0;p<12;p++){const m=e[p];for(let v=0;v<12;v++){const b=t[v];eh(m,b,i,s);const x=i.distanceToSquared(s);if(x<g&&(g=x,c&&c.copy(i),l&&l.copy(s),x<u))return Math.sqrt(x)}}return Math.sqrt(g)}})();class VT extends qu{constructor(){super(()=>new Bn)}}const En=new VT,hr=new P,Wc=new P;function kT(n,e,t={},i=0,s=1/0){const r=i*i,a=s*s;let o=1/0,c=null;if(n.shapecast({boundsTraverseOrder:u=>(hr.copy(e).clamp(u.min,u.max),hr.distanceToSquared(e)),intersectsBounds:(u,f,h)=>h<o&&h<a,intersectsTriangle:(u,f)=>{u.closestPointToPoint(e,hr);const h=e.distanceToSquared(hr);return h<o&&(Wc.copy(hr),o=h,c=f),h<r}}),o===1/0)return null;const l=Math.sqrt(o);return t.point?t.point.copy(Wc):t.point=Wc.clone(),t.distance=l,t.faceIndex=c,t}const La=parseInt("184")>=169,GT=parseInt("184")<=161,Xi=new P,Zi=new P,Yi=new P,Da=new we,Ua=new we,Fa=new we,ap=new P,op=new P,cp=new P,fr=new P;function zT(n,e,t,i,s,r,a,o){let c;if(r===Qt?c=n.intersectTriangle(i,t,e,!0,s):c=n.intersectTriangle(e,t,i,r!==yn,s),c===null)return null;const l=n.origin.distanceTo(s);return l<a||l>o?null:{distance:l,point:s.clone()}}function lp(n,e,t,i,s,r,a,o,c,l,u){Xi.fromBufferAttribute(e,r),Zi.fromBufferAttribute(e,a),Yi.fromBufferAttribute(e,o);const f=zT(n,Xi,Zi,Yi,fr,c,l,u);if(f){if(i){Da.fromBufferAttribute(i,r),Ua.fromBufferAttribute(i,a),Fa.fromBufferAttribute(i,o),f.uv=new we;const d=Ut.getInterpolation(fr,Xi,Zi,Yi,Da,Ua,Fa,f.uv);La||(f.uv=d)}if(s){Da.fromBufferAttribute(s,r),Ua.fromBufferAttribute(s,a),Fa.fromBufferAttribute(s,o),f.uv1=new we;const d=Ut.getInterpolation(fr,Xi,Zi,Yi,Da,Ua,Fa,f.uv1);La||(f.uv1=d),GT&&(f.uv2=f.uv1)}if(t){ap.fromBufferAttribute(t,r),op.fromBufferAttribute(t,a),cp.fromBufferAttribute(t,o),f.normal=new P;const d=Ut.getInterpolation(fr,Xi,Zi,Yi,ap,op,cp,f.normal);f.normal.dot(n.direction)>0&&f.normal.multiplyScalar(-1),La||(f.normal=d)}const h={a:r,b:a,c:o,normal:new P,materialIndex:0};if(Ut.getNormal(Xi,Zi,Yi,h.normal),f.face=h,f.faceIndex=r,La){const d=new P;Ut.getBarycoord(fr,Xi,Zi,Yi,d),f.barycoord=d}}return f}function up(n){return n&&n.isMaterial?n.side:n}function Po(n,e,t,i,s,r,a){const o=i*3;let c=o+0,l=o+1,u=o+2;const{index:f,groups:h}=n;n.index&&(c=f.getX(c),l=f.getX(l),u=f.getX(u));const{position:d,normal:g,uv:y,uv1:p}=n.attributes;if(Array.isArray(e)){const m=i*3;for(let v=0,b=h.length;v<b;v++){const{start:x,count:E,materialIndex:w}=h[v];if(m>=x&&m<x+E){const T=up(e[w]),_=lp(t,d,g,y,p,c,l,u,T,r,a);if(_)if(_.faceIndex=i,_.face.materialIndex=w,s)s.push(_);else return _}}}else{const m=up(e),v=lp(t,d,g,y,p,c,l,u,m,r,a);if(v)if(v.faceIndex=i,v.face.materialIndex=0,s)s.push(v);else return v}return null}function wt(n,e,t,i){const s=n.a,r=n.b,a=n.c;let o=e,c=e+1,l=e+2;t&&(o=t.getX(o),c=t.getX(c),l=t.getX(l)),s.x=i.getX(o),s.y=i.getY(o),s.z=i.getZ(o),r.x=i.getX(c),r.y=i.getY(c),r.z=i.getZ(c),a.x=i.getX(l),a.y=i.getY(l),a.z=i.getZ(l)}function WT(n,e,t,i,s,r,a,o){const{geometry:c,_indirectBuffer:l}=n;for(let u=i,f=i+s;u<f;u++)Po(c,e,t,u,r,a,o)}function HT(n,e,t,i,s,r,a){const{geometry:o,_indirectBuffer:c}=n;let l=1/0,u=null;for(let f=i,h=i+s;f<h;f++){let d;d=Po(o,e,t,f,null,r,a),d&&d.distance<l&&(u=d,l=d.distance)}return u}function XT(n,e,t,i,s,r,a){const{geometry:o}=t,{index:c}=o,l=o.attributes.position;for(let u=n,f=e+n;u<f;u++){let h;if(h=u,wt(a,h*3,c,l),a.needsUpdate=!0,i(a,h,s,r))return!0}return!1}function ZT(n,e=null){e&&Array.isArray(e)&&(e=new Set(e));const t=n.geometry,i=t.index?t.index.array:null,s=t.attributes.position;let r,a,o,c,l=0;const u=n._roots;for(let h=0,d=u.length;h<d;h++)r=u[h],a=new Uint32Array(r),o=new Uint16Array(r),c=new Float32Array(r),f(0,l),l+=r.byteLength;function f(h,d,g=!1){const y=h*2;if(St(y,o)){const p=Ft(h,a),m=Kt(y,o);let v=1/0,b=1/0,x=1/0,E=-1/0,w=-1/0,T=-1/0;for(let _=3*p,M=3*(p+m);_<M;_++){let N=i[_];const R=s.getX(N),C=s.getY(N),U=s.getZ(N);R<v&&(v=R),R>E&&(E=R),C<b&&(b=C),C>w&&(w=C),U<x&&(x=U),U>T&&(T=U)}return c[h+0]!==v||c[h+1]!==b||c[h+2]!==x||c[h+3]!==E||c[h+4]!==w||c[h+5]!==T?(c[h+0]=v,c[h+1]=b,c[h+2]=x,c[h+3]=E,c[h+4]=w,c[h+5]=T,!0):!1}else{const p=It(h),m=Ct(h,a);let v=g,b=!1,x=!1;if(e){if(!v){const N=p/At+d/fn,R=m/At+d/fn;b=e.has(N),x=e.has(R),v=!b&&!x}}else b=!0,x=!0;const E=v||b,w=v||x;let T=!1;E&&(T=f(p,d,v));let _=!1;w&&(_=f(m,d,v));const M=T||_;if(M)for(let N=0;N<3;N++){const R=p+N,C=m+N,U=c[R],B=c[R+3],L=c[C],V=c[C+3];c[h+N]=U<L?U:L,c[h+N+3]=B>V?B:V}return M}}}function wn(n,e,t,i,s){let r,a,o,c,l,u;const f=1/t.direction.x,h=1/t.direction.y,d=1/t.direction.z,g=t.origin.x,y=t.origin.y,p=t.origin.z;let m=e[n],v=e[n+3],b=e[n+1],x=e[n+3+1],E=e[n+2],w=e[n+3+2];return f>=0?(r=(m-g)*f,a=(v-g)*f):(r=(v-g)*f,a=(m-g)*f),h>=0?(o=(b-y)*h,c=(x-y)*h):(o=(x-y)*h,c=(b-y)*h),r>c||o>a||((o>r||isNaN(r))&&(r=o),(c<a||isNaN(a))&&(a=c),d>=0?(l=(E-p)*d,u=(w-p)*d):(l=(w-p)*d,u=(E-p)*d),r>u||l>a)?!1:((l>r||r!==r)&&(r=l),(u<a||a!==a)&&(a=u),r<=s&&a>=i)}function YT(n,e,t,i,s,r,a,o){const{geometry:c,_indirectBuffer:l}=n;for(let u=i,f=i+s;u<f;u++){let h=l?l[u]:u;Po(c,e,t,h,r,a,o)}}function KT(n,e,t,i,s,r,a){const{geometry:o,_indirectBuffer:c}=n;let l=1/0,u=null;for(let f=i,h=i+s;f<h;f++){let d;d=Po(o,e,t,c?c[f]:f,null,r,a),d&&d.distance<l&&(u=d,l=d.distance)}return u}function $T(n,e,t,i,s,r,a){const{geometry:o}=t,{index:c}=o,l=o.attributes.position;for(let u=n,f=e+n;u<f;u++){let h;if(h=t.resolveTriangleIndex(u),wt(a,h*3,c,l),a.needsUpdate=!0,i(a,h,s,r))return!0}return!1}function JT(n,e,t,i,s,r,a){tt.setBuffer(n._roots[e]),wn(0,tt.float32Array,i,r,a)&&ql(0,n,t,i,s,r,a),tt.clearBuffer()}function ql(n,e,t,i,s,r,a){const{float32Array:o,uint16Array:c,uint32Array:l}=tt,u=n*2;if(St(u,c)){const h=Ft(n,l),d=Kt(u,c);WT(e,t,i,h,d,s,r,a)}else{const h=It(n);wn(h,o,i,r,a)&&ql(h,e,t,i,s,r,a);const d=Ct(n,l);wn(d,o,i,r,a)&&ql(d,e,t,i,s,r,a)}}const jT=["x","y","z"];function qT(n,e,t,i,s,r){tt.setBuffer(n._roots[e]);let a=null;return wn(0,tt.float32Array,i,s,r)&&(a=Ql(0,n,t,i,s,r)),tt.clearBuffer(),a}function Ql(n,e,t,i,s,r){const{float32Array:a,uint16Array:o,uint32Array:c}=tt;let l=n*2;if(St(l,o)){const f=Ft(n,c),h=Kt(l,o);return HT(e,t,i,f,h,s,r)}else{const f=Ju(n,c),h=jT[f],g=i.direction[h]>=0;let y,p;g?(y=It(n),p=Ct(n,c)):(y=Ct(n,c),p=It(n));const v=wn(y,a,i,s,r)?Ql(y,e,t,i,s,r):null;if(v){const E=v.point[h];if(g?E<=a[p+f]:E>=a[p+f+3])return v}const x=wn(p,a,i,s,r)?Ql(p,e,t,i,s,r):null;return v&&x?v.distance<=x.distance?v:x:v||x||null}}const Ba=new Ot,Ps=new Bn,Ls=new Bn,dr=new je,hp=new tn,Oa=new tn;function QT(n,e,t,i){tt.setBuffer(n._roots[e]);const s=eu(0,n,t,i);return tt.clearBuffer(),s}function eu(n,e,t,i,s=null){const{float32Array:r,uint16Array:a,uint32Array:o}=tt;let c=n*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),hp.set(t.boundingBox.min,t.boundingBox.max,i),s=hp),St(c,a)){const u=e.geometry,f=u.index,h=u.attributes.position,d=t.index,g=t.attributes.position,y=Ft(n,o),p=Kt(c,a);if(dr.copy(i).invert(),t.boundsTree)return _t(n,r,Oa),Oa.matrix.copy(dr),Oa.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>Oa.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(i),v.b.applyMatrix4(i),v.c.applyMatrix4(i),v.needsUpdate=!0;for(let b=y*3,x=(p+y)*3;b<x;b+=3)if(wt(Ls,b,f,h),Ls.needsUpdate=!0,v.intersectsTriangle(Ls))return!0;return!1}});{const m=Co(t);for(let v=y*3,b=(p+y)*3;v<b;v+=3){wt(Ps,v,f,h),Ps.a.applyMatrix4(dr),Ps.b.applyMatrix4(dr),Ps.c.applyMatrix4(dr),Ps.needsUpdate=!0;for(let x=0,E=m*3;x<E;x+=3)if(wt(Ls,x,d,g),Ls.needsUpdate=!0,Ps.intersectsTriangle(Ls))return!0}}}else{const u=It(n),f=Ct(n,o);return _t(u,r,Ba),!!(s.intersectsBox(Ba)&&eu(u,e,t,i,s)||(_t(f,r,Ba),s.intersectsBox(Ba)&&eu(f,e,t,i,s)))}}const Va=new je,Hc=new tn,pr=new tn,e1=new P,t1=new P,n1=new P,i1=new P;function s1(n,e,t,i={},s={},r=0,a=1/0){e.boundingBox||e.computeBoundingBox(),Hc.set(e.boundingBox.min,e.boundingBox.max,t),Hc.needsUpdate=!0;const o=n.geometry,c=o.attributes.position,l=o.index,u=e.attributes.position,f=e.index,h=En.getPrimitive(),d=En.getPrimitive();let g=e1,y=t1,p=null,m=null;s&&(p=n1,m=i1);let v=1/0,b=null,x=null;return Va.copy(t).invert(),pr.matrix.copy(Va),n.shapecast({boundsTraverseOrder:E=>Hc.distanceToBox(E),intersectsBounds:(E,w,T)=>T<v&&T<a?(w&&(pr.min.copy(E.min),pr.max.copy(E.max),pr.needsUpdate=!0),!0):!1,intersectsRange:(E,w)=>{if(e.boundsTree)return e.boundsTree.shapecast({boundsTraverseOrder:_=>pr.distanceToBox(_),intersectsBounds:(_,M,N)=>N<v&&N<a,intersectsRange:(_,M)=>{for(let N=_,R=_+M;N<R;N++){wt(d,3*N,f,u),d.a.applyMatrix4(t),d.b.applyMatrix4(t),d.c.applyMatrix4(t),d.needsUpdate=!0;for(let C=E,U=E+w;C<U;C++){wt(h,3*C,l,c),h.needsUpdate=!0;const B=h.distanceToTriangle(d,g,p);if(B<v&&(y.copy(g),m&&m.copy(p),v=B,b=C,x=N),B<r)return!0}}}});{const T=Co(e);for(let _=0,M=T;_<M;_++){wt(d,3*_,f,u),d.a.applyMatrix4(t),d.b.applyMatrix4(t),d.c.applyMatrix4(t),d.needsUpdate=!0;for(let N=E,R=E+w;N<R;N++){wt(h,3*N,l,c),h.needsUpdate=!0;const C=h.distanceToTriangle(d,g,p);if(C<v&&(y.copy(g),m&&m.copy(p),v=C,b=N,x=_),C<r)return!0}}}}}),En.releasePrimitive(h),En.releasePrimitive(d),v===1/0?null:(i.point?i.point.copy(y):i.point=y.clone(),i.distance=v,i.faceIndex=b,s&&(s.point?s.point.copy(m):s.point=m.clone(),s.point.applyMatrix4(Va),y.applyMatrix4(Va),s.distance=y.sub(s.point).length(),s.faceIndex=x),i)}function r1(n,e=null){e&&Array.isArray(e)&&(e=new Set(e));const t=n.geometry,i=t.index?t.index.array:null,s=t.attributes.position;let r,a,o,c,l=0;const u=n._roots;for(let h=0,d=u.length;h<d;h++)r=u[h],a=new Uint32Array(r),o=new Uint16Array(r),c=new Float32Array(r),f(0,l),l+=r.byteLength;function f(h,d,g=!1){const y=h*2;if(St(y,o)){const p=Ft(h,a),m=Kt(y,o);let v=1/0,b=1/0,x=1/0,E=-1/0,w=-1/0,T=-1/0;for(let _=p,M=p+m;_<M;_++){const N=3*n.resolveTriangleIndex(_);for(let R=0;R<3;R++){let C=N+R;C=i?i[C]:C;const U=s.getX(C),B=s.getY(C),L=s.getZ(C);U<v&&(v=U),U>E&&(E=U),B<b&&(b=B),B>w&&(w=B),L<x&&(x=L),L>T&&(T=L)}}return c[h+0]!==v||c[h+1]!==b||c[h+2]!==x||c[h+3]!==E||c[h+4]!==w||c[h+5]!==T?(c[h+0]=v,c[h+1]=b,c[h+2]=x,c[h+3]=E,c[h+4]=w,c[h+5]=T,!0):!1}else{const p=It(h),m=Ct(h,a);let v=g,b=!1,x=!1;if(e){if(!v){const N=p/At+d/fn,R=m/At+d/fn;b=e.has(N),x=e.has(R),v=!b&&!x}}else b=!0,x=!0;const E=v||b,w=v||x;let T=!1;E&&(T=f(p,d,v));let _=!1;w&&(_=f(m,d,v));const M=T||_;if(M)for(let N=0;N<3;N++){const R=p+N,C=m+N,U=c[R],B=c[R+3],L=c[C],V=c[C+3];c[h+N]=U<L?U:L,c[h+N+3]=B>V?B:V}return M}}}function a1(n,e,t,i,s,r,a){tt.setBuffer(n._roots[e]),wn(0,tt.float32Array,i,r,a)&&tu(0,n,t,i,s,r,a),tt.clearBuffer()}function tu(n,e,t,i,s,r,a){const{float32Array:o,uint16Array:c,uint32Array:l}=tt,u=n*2;if(St(u,c)){const h=Ft(n,l),d=Kt(u,c);YT(e,t,i,h,d,s,r,a)}else{const h=It(n);wn(h,o,i,r,a)&&tu(h,e,t,i,s,r,a);const d=Ct(n,l);wn(d,o,i,r,a)&&tu(d,e,t,i,s,r,a)}}const o1=["x","y","z"];function c1(n,e,t,i,s,r){tt.setBuffer(n._roots[e]);let a=null;return wn(0,tt.float32Array,i,s,r)&&(a=nu(0,n,t,i,s,r)),tt.clearBuffer(),a}function nu(n,e,t,i,s,r){const{float32Array:a,uint16Array:o,uint32Array:c}=tt;let l=n*2;if(St(l,o)){const f=Ft(n,c),h=Kt(l,o);return KT(e,t,i,f,h,s,r)}else{const f=Ju(n,c),h=o1[f],g=i.direction[h]>=0;let y,p;g?(y=It(n),p=Ct(n,c)):(y=Ct(n,c),p=It(n));const v=wn(y,a,i,s,r)?nu(y,e,t,i,s,r):null;if(v){const E=v.point[h];if(g?E<=a[p+f]:E>=a[p+f+3])return v}const x=wn(p,a,i,s,r)?nu(p,e,t,i,s,r):null;return v&&x?v.distance<=x.distance?v:x:v||x||null}}const ka=new Ot,Ds=new Bn,Us=new Bn,mr=new je,fp=new tn,Ga=new tn;function l1(n,e,t,i){tt.setBuffer(n._roots[e]);const s=iu(0,n,t,i);return tt.clearBuffer(),s}function iu(n,e,t,i,s=null){const{float32Array:r,uint16Array:a,uint32Array:o}=tt;let c=n*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),fp.set(t.boundingBox.min,t.boundingBox.max,i),s=fp),St(c,a)){const u=e.geometry,f=u.index,h=u.attributes.position,d=t.index,g=t.attributes.position,y=Ft(n,o),p=Kt(c,a);if(mr.copy(i).invert(),t.boundsTree)return _t(n,r,Ga),Ga.matrix.copy(mr),Ga.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>Ga.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(i),v.b.applyMatrix4(i),v.c.applyMatrix4(i),v.needsUpdate=!0;for(let b=y,x=p+y;b<x;b++)if(wt(Us,3*e.resolveTriangleIndex(b),f,h),Us.needsUpdate=!0,v.intersectsTriangle(Us))return!0;return!1}});{const m=Co(t);for(let v=y,b=p+y;v<b;v++){const x=e.resolveTriangleIndex(v);wt(Ds,3*x,f,h),Ds.a.applyMatrix4(mr),Ds.b.applyMatrix4(mr),Ds.c.applyMatrix4(mr),Ds.needsUpdate=!0;for(let E=0,w=m*3;E<w;E+=3)if(wt(Us,E,d,g),Us.needsUpdate=!0,Ds.intersectsTriangle(Us))return!0}}}else{const u=It(n),f=Ct(n,o);return _t(u,r,ka),!!(s.intersectsBox(ka)&&iu(u,e,t,i,s)||(_t(f,r,ka),s.intersectsBox(ka)&&iu(f,e,t,i,s)))}}const za=new je,Xc=new tn,gr=new tn,u1=new P,h1=new P,f1=new P,d1=new P;function p1(n,e,t,i={},s={},r=0,a=1/0){e.boundingBox||e.computeBoundingBox(),Xc.set(e.boundingBox.min,e.boundingBox.max,t),Xc.needsUpdate=!0;const o=n.geometry,c=o.attributes.position,l=o.index,u=e.attributes.position,f=e.index,h=En.getPrimitive(),d=En.getPrimitive();let g=u1,y=h1,p=null,m=null;s&&(p=f1,m=d1);let v=1/0,b=null,x=null;return za.copy(t).invert(),gr.matrix.copy(za),n.shapecast({boundsTraverseOrder:E=>Xc.distanceToBox(E),intersectsBounds:(E,w,T)=>T<v&&T<a?(w&&(gr.min.copy(E.min),gr.max.copy(E.max),gr.needsUpdate=!0),!0):!1,intersectsRange:(E,w)=>{if(e.boundsTree){const T=e.boundsTree;return T.shapecast({boundsTraverseOrder:_=>gr.distanceToBox(_),intersectsBounds:(_,M,N)=>N<v&&N<a,intersectsRange:(_,M)=>{for(let N=_,R=_+M;N<R;N++){const C=T.resolveTriangleIndex(N);wt(d,3*C,f,u),d.a.applyMatrix4(t),d.b.applyMatrix4(t),d.c.applyMatrix4(t),d.needsUpdate=!0;for(let U=E,B=E+w;U<B;U++){const L=n.resolveTriangleIndex(U);wt(h,3*L,l,c),h.needsUpdate=!0;const V=h.distanceToTriangle(d,g,p);if(V<v&&(y.copy(g),m&&m.copy(p),v=V,b=U,x=N),V<r)return!0}}}})}else{const T=Co(e);for(let _=0,M=T;_<M;_++){wt(d,3*_,f,u),d.a.applyMatrix4(t),d.b.applyMatrix4(t),d.c.applyMatrix4(t),d.needsUpdate=!0;for(let N=E,R=E+w;N<R;N++){const C=n.resolveTriangleIndex(N);wt(h,3*C,l,c),h.needsUpdate=!0;const U=h.distanceToTriangle(d,g,p);if(U<v&&(y.copy(g),m&&m.copy(p),v=U,b=N,x=_),U<r)return!0}}}}}),En.releasePrimitive(h),En.releasePrimitive(d),v===1/0?null:(i.point?i.point.copy(y):i.point=y.clone(),i.distance=v,i.faceIndex=b,s&&(s.point?s.point.copy(m):s.point=m.clone(),s.point.applyMatrix4(za),y.applyMatrix4(za),s.distance=y.sub(s.point).length(),s.faceIndex=x),i)}function dp(n,e,t){return n===null?null:(n.point.applyMatrix4(e.matrixWorld),n.distance=n.point.distanceTo(t.ray.origin),n.object=e,n)}const Wa=new tn,Ha=new Vr,pp=new P,mp=new je,gp=new P,Zc=["getX","getY","getZ"];class xo extends UT{static serialize(e,t={}){t={cloneBuffers:!0,...t};const i=e.geometry,s=e._roots,r=e._indirectBuffer,a=i.getIndex(),o={version:1,roots:null,index:null,indirectBuffer:null};return t.cloneBuffers?(o.roots=s.map(c=>c.slice()),o.index=a?a.array.slice():null,o.indirectBuffer=r?r.slice():null):(o.roots=s,o.index=a?a.array:null,o.indirectBuffer=r),o}static deserialize(e,t,i={}){i={setIndex:!0,indirect:!!e.indirectBuffer,...i};const{index:s,roots:r,indirectBuffer:a}=e;e.version||(console.warn("MeshBVH.deserialize: Serialization format has been changed and will be fixed up. It is recommended to regenerate any stored serialized data."),c(r));const o=new xo(t,{...i,[$u]:!0});if(o._roots=r,o._indirectBuffer=a||null,i.setIndex){const l=t.getIndex();if(l===null){const u=new Et(e.index,1,!1);t.setIndex(u)}else l.array!==s&&(l.array.set(s),l.needsUpdate=!0)}return o;function c(l){for(let u=0;u<l.length;u++){const f=l[u],h=new Uint32Array(f),d=new Uint16Array(f);for(let g=0,y=f.byteLength/fn;g<y;g++){const p=At*g,m=2*p;St(m,d)||(h[p+6]=h[p+6]/At-g)}}}}get primitiveStride(){return 3}get resolveTriangleIndex(){return this.resolvePrimitiveIndex}constructor(e,t={}){t.maxLeafTris&&(console.warn('MeshBVH: "maxLeafTris" option has been deprecated. Use "targetLeafSize", instead.'),t={...t,targetLeafSize:t.maxLeafTris}),super(e,t)}shiftTriangleOffsets(e){return super.shiftPrimitiveOffsets(e)}writePrimitiveBounds(e,t,i){const s=this.geometry,r=this._indirectBuffer,a=s.attributes.position,o=s.index?s.index.array:null,l=(r?r[e]:e)*3;let u=l+0,f=l+1,h=l+2;o&&(u=o[u],f=o[f],h=o[h]);for(let d=0;d<3;d++){const g=a[Zc[d]](u),y=a[Zc[d]](f),p=a[Zc[d]](h);let m=g;y<m&&(m=y),p<m&&(m=p);let v=g;y>v&&(v=y),p>v&&(v=p),t[i+d]=m,t[i+d+3]=v}return t}computePrimitiveBounds(e,t,i){const s=this.geometry,r=this._indirectBuffer,a=s.attributes.position,o=s.index?s.index.array:null,c=a.normalized;if(e<0||t+e-i.offset>i.length/6)throw new Error("MeshBVH: compute triangle bounds range is invalid.");const l=a.array,u=a.offset||0;let f=3;a.isInterleavedBufferAttribute&&(f=a.data.stride);const h=["getX","getY","getZ"],d=i.offset;for(let g=e,y=e+t;g<y;g++){const m=(r?r[g]:g)*3,v=(g-d)*6;let b=m+0,x=m+1,E=m+2;o&&(b=o[b],x=o[x],E=o[E]),c||(b=b*f+u,x=x*f+u,E=E*f+u);for(let w=0;w<3;w++){let T,_,M;c?(T=a[h[w]](b),_=a[h[w]](x),M=a[h[w]](E)):(T=l[b+w],_=l[x+w],M=l[E+w]);let N=T;_<N&&(N=_),M<N&&(N=M);let R=T;_>R&&(R=_),M>R&&(R=M);const C=(R-N)/2,U=w*2;i[v+U+0]=N+C,i[v+U+1]=C+(Math.abs(N)+C)*to}}return i}raycastObject3D(e,t,i=[]){const{material:s}=e;if(s===void 0)return;mp.copy(e.matrixWorld).invert(),Ha.copy(t.ray).applyMatrix4(mp),gp.setFromMatrixScale(e.matrixWorld),pp.copy(Ha.direction).multiply(gp);const r=pp.length(),a=t.near/r,o=t.far/r;if(t.firstHitOnly===!0){let c=this.raycastFirst(Ha,s,a,o);c=dp(c,e,t),c&&i.push(c)}else{const c=this.raycast(Ha,s,a,o);for(let l=0,u=c.length;l<u;l++){const f=dp(c[l],e,t);f&&i.push(f)}}return i}refit(e=null){return(this.indirect?r1:ZT)(this,e)}raycast(e,t=qn,i=0,s=1/0){const r=this._roots,a=[],o=this.indirect?a1:JT;for(let c=0,l=r.length;c<l;c++)o(this,c,t,e,a,i,s);return a}raycastFirst(e,t=qn,i=0,s=1/0){const r=this._roots;let a=null;const o=this.indirect?c1:qT;for(let c=0,l=r.length;c<l;c++){const u=o(this,c,t,e,i,s);u!=null&&(a==null||u.distance<a.distance)&&(a=u)}return a}intersectsGeometry(e,t){let i=!1;const s=this._roots,r=this.indirect?l1:QT;for(let a=0,o=s.length;a<o&&(i=r(this,a,e,t),!i);a++);return i}shapecast(e){const t=En.getPrimitive(),i=super.shapecast({...e,intersectsPrimitive:e.intersectsTriangle,scratchPrimitive:t,iterate:this.indirect?$T:XT});return En.releasePrimitive(t),i}bvhcast(e,t,i){let{intersectsRanges:s,intersectsTriangles:r}=i;const a=En.getPrimitive(),o=this.geometry.index,c=this.geometry.attributes.position,l=this.indirect?g=>{const y=this.resolveTriangleIndex(g);wt(a,y*3,o,c)}:g=>{wt(a,g*3,o,c)},u=En.getPrimitive(),f=e.geometry.index,h=e.geometry.attributes.position,d=e.indirect?g=>{const y=e.resolveTriangleIndex(g);wt(u,y*3,f,h)}:g=>{wt(u,g*3,f,h)};if(r){if(!(e instanceof xo))throw new Error('MeshBVH: "intersectsTriangles" callback can only be used with another MeshBVH.');const g=(y,p,m,v,b,x,E,w)=>{for(let T=m,_=m+v;T<_;T++){d(T),u.a.applyMatrix4(t),u.b.applyMatrix4(t),u.c.applyMatrix4(t),u.needsUpdate=!0;for(let M=y,N=y+p;M<N;M++)if(l(M),a.needsUpdate=!0,r(a,u,M,T,b,x,E,w))return!0}return!1};if(s){const y=s;s=function(p,m,v,b,x,E,w,T){return y(p,m,v,b,x,E,w,T)?!0:g(p,m,v,b,x,E,w,T)}}else s=g}return super.bvhcast(e,t,{intersectsRanges:s})}intersectsBox(e,t){return Wa.set(e.min,e.max,t),Wa.needsUpdate=!0,this.shapecast({intersectsBounds:i=>Wa.intersectsBox(i),intersectsTriangle:i=>Wa.intersectsTriangle(i)})}intersectsSphere(e){return this.shapecast({intersectsBounds:t=>e.intersectsBox(t),intersectsTriangle:t=>t.intersectsSphere(e)})}closestPointToGeometry(e,t,i={},s={},r=0,a=1/0){return(this.indirect?p1:s1)(this,e,t,i,s,r,a)}closestPointToPoint(e,t={},i=0,s=1/0){return kT(this,e,t,i,s)}}class m1{constructor(e){this.mesh=e,this.tree=new xo(e.geometry,{indirect:!0})}mesh;tree;caster=new u_;pick(e,t){this.caster.setFromCamera(e,t);const i=this.tree.raycastFirst(this.caster.ray,yn);if(i?.faceIndex==null)return;const s=i.faceIndex;return{place:{kind:"face",face:s,weights:this.weightsAt(s,i.point)},point:i.point}}weightsAt(e,t){const i=this.mesh.geometry.getAttribute("position"),s=this.mesh.cornersOf(e).map(c=>new P().fromBufferAttribute(i,c)),r=new P;if(!Ut.getBarycoord(t,s[0],s[1],s[2],r))return[1,0,0];const a=r.toArray().map(c=>Math.max(c,0)),o=a[0]+a[1]+a[2];return[a[0]/o,a[1]/o,a[2]/o]}}const Xa=.12,_p=1.15,g1=8,_1=12,v1=.03,x1=150,y1=.002;function b1(n,e,t){const i=Ae("picture");let s,r=[],a={x:0,y:0},o=-1,c={},l;const u=new fT;let f,h;const d=_=>s?.pick(n.pointerAt(_.x,_.y),n.camera),g=_=>{const{camera:M}=n,{x:N,y:R}=_.clone().project(M),C=s?.pick(new we(N,R),M);return!(C&&C.point.distanceTo(M.position)<_.distanceTo(M.position)-y1)},y=_=>{const M=i.getBoundingClientRect();return e.sourcesOnScreen().findIndex(N=>{if(!N)return!1;const R=n.pixelOf(N);return Math.hypot(M.left+R.x-_.x,M.top+R.y-_.y)<_1&&g(N)})},p=(_,M)=>{f={field:e.field,summary:e.summary,view:n.camera.matrixWorld.clone()},i.classList.toggle("grab",y(_)>=0),e.hover(d(_)?.place,M)},m=(_,M)=>{l=_,t.pointer(_),p(_,M)},v=(_,M)=>{const N=d(_)?.place;N&&(M?e.setSources([...e.sources,N]):t.tool==="path"&&e.sources.length?e.keepPath(N):e.setSources([N]),e.sources.length===1&&t.tool==="source"&&t.choose("path"))},b=pT(i,{move:_=>{u.hide(),m(_,_.since)},leave:()=>{u.point||(l=void 0,e.hover(void 0,0))},click:_=>{u.hide(),v(_,_.shift)},drawsCurve:_=>(r=[],e.mesh!==void 0&&(_||t.tool==="curve")),grabs:_=>(c={},(o=y(_))>=0),drag:_=>{const M=d(_)?.place;M&&e.moveSource(o,M,c)},dropped:()=>e.dropSource(),draw:_=>{if(r.length&&Math.hypot(_.x-a.x,_.y-a.y)<g1)return;const M=d(_);M&&(a=_,r.push(M),e.drawSketch(r.map(({point:N})=>N)))},drawn:()=>{e.addCurve(r.map(({place:_})=>_),t.tool==="curve"),r=[]},wheel:_=>{const M=e.field?.largest??0;M>0&&t.setRadius((e.radius??M)-_*v1*M)},setTurning:_=>n.setTurning(_)}),x=(_,M)=>m(u.move(_,M),performance.now()),E=_=>{u.point?v(u.point,_):x(0,0)},T={ArrowLeft:()=>n.turn(Xa,0,1),ArrowRight:()=>n.turn(-Xa,0,1),ArrowUp:()=>n.turn(0,Xa,1),ArrowDown:()=>n.turn(0,-Xa,1),"+":()=>n.turn(0,0,1/_p),"-":()=>n.turn(0,0,_p),Backspace:()=>e.removeLast(),Escape:()=>{if(b.cancel()){r=[],e.drawSketch([]),e.cancel(c);return}u.point&&(u.hide(),l=void 0,e.hover(void 0,0)),t.tool==="curve"&&t.chooseNext()},s:()=>t.choose("source"),p:()=>t.choose("path"),c:()=>t.choose("curve"),i:()=>t.toggleIsolines(),t:()=>t.toggleTheme(),l:()=>n.lookAtAll(),"?":()=>t.help(),Enter:()=>E(!1),"Shift+ArrowLeft":()=>x(-1,0),"Shift+ArrowRight":()=>x(1,0),"Shift+ArrowUp":()=>x(0,-1),"Shift+ArrowDown":()=>x(0,1),"Shift+Enter":()=>E(!0),"Control+z":()=>t.undo(),"Control+Shift+z":()=>t.redo(),"Control+y":()=>t.redo()};return document.addEventListener("keydown",_=>{if(mT(_)||document.querySelector("dialog[open]"))return;const M=_.key.length===1?_.key.toLowerCase():_.key,N=_.ctrlKey||_.metaKey,R=(N?"Control+":"")+(_.shiftKey?"Shift+":""),C=T[R+M]??(N?void 0:T[M]);C&&(_.preventDefault(),C())}),{show:_=>s=new m1(_),isSeen:g,changed:()=>{if(!l||!f)return;const _=!n.camera.matrixWorld.equals(f.view);!_&&f.field===e.field&&f.summary===e.summary||(_&&e.hover(void 0,0),clearTimeout(h),h=setTimeout(()=>{l&&!e.isWaiting&&p(l,performance.now())},x1))}}}const vp="geodesic.token",S1=/^[!-~]{1,4096}$/,E1=100,M1=/^[0-9a-f]{64}$/;class A1{constructor(e){this.wrong=e,this.read()}wrong;mesh="";token="";sources=[];paths=[];radius=null;shown;wanted;pause;read(){this.wanted=void 0;const e=new URLSearchParams(location.hash.slice(1)),t=e.get("mesh")??"",i=e.get("token");this.mesh=M1.test(t)?t:"",this.sources=e.getAll("source"),this.paths=e.getAll("path"),this.radius=e.get("radius");let s;return t&&!this.mesh&&(s="The address names no mesh: a mesh has 64 digits and letters from a to f."),i&&S1.test(i)?this.keepToken(i):i&&(s="The token in the address is none: it has letters, digits and signs only."),this.token=sessionStorage.getItem(vp)??"",i!==null&&(e.delete("token"),history.replaceState(null,"",`#${e}`)),s&&this.wrong(s),!s}keepToken(e){sessionStorage.setItem(vp,e)}questionOn(e){if(e.digest!==this.mesh)return{sources:[],paths:[]};const t=c=>c!==void 0&&e.holdsSource(c),i=this.sources.splice(0),s=i.map(ed).filter(t);s.length<i.length&&this.wrong("The address names a source that is no place of this mesh.");const r=this.paths.splice(0),a=r.map(ed).filter(t).flatMap(c=>c&&"curve"in c&&c.curve.length===2?[{from:c.curve[0],target:c.curve[1]}]:[]);a.length<r.length&&this.wrong("The address names a path whose ends are no two places of this mesh.");const o=this.radius===null?void 0:parseFloat(this.radius);return this.radius=null,o===void 0||Number.isFinite(o)&&o>=0?{sources:s,paths:a,radius:o}:(this.wrong("The address names a radius that is no length."),{sources:s,paths:a})}show({mesh:e,sources:t,paths:i,awaitedPaths:s,radius:r}){if(!e)return;const a=new URLSearchParams({mesh:e.digest});for(const o of t)a.append("source",Ys(o));for(const{from:o,target:c}of[...i,...s])a.append("path",Ys({curve:[o,c]}));if(r!==void 0&&a.set("radius",String(r)),this.shown!==void 0&&this.shown!==e.digest){this.write();const{hash:o}=location;new URLSearchParams(o.slice(1)).get("mesh")!==e.digest&&history.pushState(null,"",o)}this.shown=e.digest,this.wanted=`#${a}`,this.pause===void 0&&this.write()}write(){const{wanted:e}=this;clearTimeout(this.pause),this.pause=this.wanted=void 0,!(e===void 0||e===location.hash)&&(history.replaceState(null,"",e),this.pause=setTimeout(()=>this.write(),E1))}}const Vi=new ow,xn=new A1(n=>Vi.error(n)),yi=R1(),w1=new Dw((n,e)=>yi.setBackground(e,n)),Yr=new SA(location.origin,xn.token),Lo=new Lw(Yr,Vi,n=>xn.keepToken(n)),_i=new DA(yi,Yr,{changed:()=>{js.update(),th.update(),xn.show(_i),Uo.changed()},value:(n,e)=>js.value(n,e),failed:(n,e)=>Lo.handle(n,e),told:n=>Vi.hint(n),lost:n=>Do.restore(n.digest)}),th=new ww(_i,yi,n=>Uo.isSeen(n));yi.onLost=()=>Vi.error("The graphics processor is away. The picture comes back with it.");yi.onRestored=()=>Vi.clear();yi.onSurface=()=>{th.update(),Uo.changed()};const js=new Aw(_i,yi,Yr,Vi,w1,th),bg=(n,e)=>{const{sources:t,paths:i,radius:s}=xn.questionOn(n);_i.ask(t,i,s,e),js.chooseNext()},T1=n=>{const e=_i.mesh?.digest===n.digest;_i.show(n),Uo.show(n),js.show(n),e||bg(n,!1)},Do=new rw(Yr,Vi,Lo,yi.coarseFaces,T1,(n,e)=>_i.showCoarse(n,e)),Uo=b1(yi,_i,js);Lo.attempt(async()=>{await js.showCapabilities(),await Do.list()});xn.mesh&&Do.openDigest(xn.mesh);addEventListener("hashchange",()=>{const{token:n}=Yr,e=xn.read();xn.token!==n&&Lo.goOnWith(xn.token);const{mesh:t}=_i;e&&(t&&t.digest===xn.mesh?bg(t,!0):xn.mesh&&Do.openDigest(xn.mesh))});function R1(){try{return new uT(Ae("picture"))}catch(n){throw Ae("welcome").hidden=!0,Vi.error(cT),n}}
