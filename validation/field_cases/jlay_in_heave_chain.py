#!/usr/bin/python3
"""Independent lumped-mass chain (explicit) of JL-heave.yaml: 2-D, extensible, bending, Morison drag normal, linear bed."""
import numpy as np, sys, math
g=9.80665; rho=1.025
D,t,E=.3239,.0191,207e6
A=math.pi/4*(D**2-(D-2*t)**2); I=math.pi/64*(D**4-(D-2*t)**4); EA,EI=E*A,E*I
wa=76.9822*A; ws=wa-10.05181625*math.pi/4*D**2; Ao=math.pi/4*D**2
L=507.44013581475207; xa,za=458.2009035205804,-149.84384713954026; zb=-150+D/2
n=int(sys.argv[1]) if len(sys.argv)>1 else 200; l=L/n
m=wa/g*l; ma=rho*Ao*l; cd=.5*rho*1.2*D*l; ks=100.*l
mass=np.full(n+1,m); 
# start: catenary
H0=150.; a=H0/ws; h=150-D/2; S=math.sqrt(h*h+2*a*h); X=a*math.acosh(1+h/a)
s=np.linspace(0,L,n+1); x=np.zeros(n+1); z=np.zeros(n+1)
for i,si in enumerate(s):
    q=S-si
    if q>0: z[i]=zb+a*(math.sqrt(1+(q/a)**2)-1); x[i]=X-a*math.asinh(q/a)
    else: z[i]=zb; x[i]=X-q
x+= (xa-x[-1])*s/L; z[0]=0; z[-1]=za; x[-1]=xa
r=np.stack([x,z],1); v=np.zeros_like(r)
def forces(r,v):
    d=np.diff(r,axis=0); le=np.hypot(d[:,0],d[:,1]); tt=d/le[:,None]
    dv=np.diff(v,axis=0); rate=(dv*tt).sum(1)
    T=EA*(le/l-1)+cax*rate
    F=np.zeros_like(r)
    F[:-1]+=T[:,None]*tt; F[1:]-=T[:,None]*tt
    # bending: M at inner nodes
    th=np.arctan2(d[:,1],d[:,0]); dth=np.diff(th); M=EI*dth/l
    nn=np.stack([-tt[:,1],tt[:,0]],1)
    Mn=np.zeros(n+1); Mn[1:-1]=M
    Q=(Mn[1:]-Mn[:-1])/le                      # shear in elements
    F[:-1]+=-Q[:,None]*nn*-1*-1; F[1:]+=Q[:,None]*nn
    wet=(r[:,1]<0)
    F[:,1]-=np.where(wet,ws,wa)*l
    pen=zb-r[:,1]; F[:,1]+=np.where(pen>0,ks*pen,0)
    tn=np.zeros_like(r); tn[1:-1]=tt[:-1]+tt[1:]; tn[0]=tt[0]; tn[-1]=tt[-1]; tn/=np.hypot(tn[:,0],tn[:,1])[:,None]
    vt=(v*tn).sum(1); vn=v-vt[:,None]*tn
    F-=np.where(wet,cd*np.hypot(vn[:,0],vn[:,1]),0)[:,None]*vn
    return F,T,M,tn,wet
wmax=2*math.sqrt(EA/l/m); cax=2*.01*math.sqrt(EA/l*m)
dt=.7/wmax
def acc(F,tn,wet):
    an=np.where(wet,ma,0)
    Ft=(F*tn).sum(1); Fn=F-Ft[:,None]*tn
    return (Ft/m)[:,None]*tn+Fn/(m+an)[:,None]
# sign check of the bending force: energy must fall on relaxation -> start with heavy damping
steps=int(60/dt)
for k in range(steps):
    F,T,M,tn,wet=forces(r,v); a_=acc(F-.15*m*v*1.0,tn,wet); a_[0]=0; a_[-1]=0
    v+=dt*a_; r+=dt*v
print('n %d dt %.2e static: T top %.3f bottom %.3f Mmax %.3f'%(n,dt,T[0]+0.5*0,T[-1],M.max()),flush=True)
amp,per=1.5,9.; tb=45.; te=54.+tb; om=2*math.pi/per
N=int(te/dt); out=[]; x0,z0=r[0].copy()
v[:]=0
for k in range(N):
    tm=(k+1)*dt-tb
    f=min(1,(tm+tb)/tb); ramp=f*f*(3-2*f)
    zt=z0+ramp*amp*math.sin(om*tm)
    F,T,M,tn,wet=forces(r,v); a_=acc(F,tn,wet); a_[-1]=0
    v+=dt*a_; v[-1]=0
    vz=(zt-r[0,1])/dt; v[0]=(0,vz)
    r+=dt*v; r[0]=(x0,zt)
    if k%200==0 and tm>18: out.append((tm,T[0],T.min(),M.max(),M.argmax()*l,T[-1]))
o=np.array(out)
print('dynamic: T top %.2f .. %.2f  smallest %.2f  M max %.2f (min of largest %.2f)'%(o[:,1].min(),o[:,1].max(),o[:,2].min(),o[:,3].max(),o[:,3].min()))
