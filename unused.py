import re,subprocess,collections
files=subprocess.check_output(['git','ls-files'],text=True).split('\n')
prod=[f for f in files if re.match(r'(core|types|codec|server|client|python|web/src|proto|manual|digest|bench|examples|scripts)',f) and not f.startswith('web/dist') and re.search(r'\.(h|cc|py|pyi|ts|proto|ipynb)$|scripts/',f)]
tests=[f for f in files if f.startswith('tests/') and re.search(r'\.(h|cc|py|mjs|sh)$',f)]
tok=re.compile(r'[A-Za-z_]\w*')
def strip(t,f):
    if f.endswith(('.h','.cc','.ts','.proto')):
        t=re.sub(r'//[^\n]*','',t); t=re.sub(r'/\*.*?\*/','',t,flags=re.S)
    return t
pc=collections.Counter();tc=collections.Counter();where=collections.defaultdict(collections.Counter)
hdr=collections.defaultdict(set)
for f in prod:
    t=strip(open(f,errors='replace').read(),f)
    for w in tok.findall(t): pc[w]+=1; where[w][f]+=1
    if f.endswith('.h'):
        for w in re.findall(r'\b([A-Za-z_]\w*)\s*\(',t)+re.findall(r'\b(?:class|struct|enum class|using)\s+([A-Za-z_]\w*)',t)+re.findall(r'\b(k[A-Z]\w+)\b',t)+re.findall(r'\b([a-z]\w*_?)\s*(?:=[^;]*)?(?:\{[^;{}]*\})?;',t): hdr[w].add(f)
for f in tests:
    t=strip(open(f,errors='replace').read(),f)
    for w in tok.findall(t): tc[w]+=1
for w in sorted(hdr,key=lambda w:sorted(hdr[w])):
    fs=where[w]
    # used only by own .h/.cc
    base={re.sub(r'\.(h|cc)$','',f.split('/')[-1]) for f in fs}
    if pc[w]<=2 and len(base)<=1:
        print(pc[w],tc[w],w,dict(fs))
