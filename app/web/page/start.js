// Start: what the browser lacks is said in a sentence; the files are fetched under a bar; then the
// program runs, and the loop of its frames sleeps while nothing moves.
const canvas = document.getElementById('canvas');
const framed = window.parent !== window;
const onePage = document.getElementById('packed-viewer.wasm') !== null;  // this page holds all of the program
const root = document.currentScript.src && new URL('.', document.currentScript.src).href;  // of the files, where they are not inside
let program = null;    // Emscripten's module, once it is made
let loading = false;   // the program is to come, or runs
let begun = false;     // it has a window
let failedWith = null;

/// Says in the page why there is no program. The first reason counts.
function fail(sentence) {
  if (failedWith) return console.error(sentence);
  failedWith = sentence;
  document.body.classList.remove('runs');
  document.getElementById('share').hidden = document.getElementById('stay').hidden = true;
  const why = document.getElementById('why');
  why.textContent = sentence;
  why.hidden = false;
}

/// What this browser lacks, in a sentence; empty: nothing.
function lacking() {
  if (typeof WebAssembly !== 'object') return 'This browser does not run WebAssembly. Please use a newer one.';
  const tryAndCatch = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11];
  if (!WebAssembly.validate(new Uint8Array(tryAndCatch)))
    return 'This browser is too old for this program: its WebAssembly has no exceptions. Please use a newer one.';
  if (onePage && typeof DecompressionStream !== 'function')
    return 'This browser is too old for the program in one file. Please use a newer one, or the program from a server.';
  if (!document.createElement('canvas').getContext('webgl2'))
    return 'This browser has no WebGL 2. Allow hardware acceleration in its settings, or use another browser.';
  return '';
}

/// The link that the page begins with: after # in its address, or inside the page.
function linkOf() {
  const inside = document.querySelector('meta[name=start]').content;
  return location.hash.length > 1 || !inside ? location.hash : '#' + inside;
}

/// Where a link leads, in words.
function placeInWords(hash) {
  const link = new URLSearchParams(hash.replace(/^#/, '').replace(/\+/g, '%2B'));
  const input = ['scene', 'lesson', 'figure', 'sample', 'file'].filter(name => link.get(name)).map(name => `${name} ${link.get(name)}`)[0]
    ?? (link.get('pack') ?? '').split(':')[0];
  return [input, link.get('goto') && `at ${link.get('goto')}`, link.get('step') && `step ${link.get('step')}`].filter(Boolean).join(', ');
}

/// Bytes that an element of this page holds, which goes.
async function unpack(element) {
  const bytes = Uint8Array.from(atob(element.textContent), c => c.charCodeAt(0));
  element.remove();
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
}
/// One file of the program, from this page if it holds it, else from beside it: its bytes, or what they compile to.
/// Browsers keep that for the next visit, if it is compiled while it arrives.
async function load(name, progress) {
  const packed = document.getElementById('packed-' + name);
  if (packed) return unpack(packed);
  const answer = await fetch(root + name).catch(() => null);
  if (!answer) throw new Error(`The file ${name} of the program could not be fetched. Check the connection, and load the page again.`);
  if (!answer.ok) throw new Error(`The file ${name} of the program is not there (${answer.status}). Whoever set up this page has to add it.`);
  const copy = answer.clone();
  const compiled = answer.headers.get('Content-Type') === 'application/wasm' ? WebAssembly.compileStreaming(answer).catch(() => null) : null;
  const whole = await readWhole(name, copy.body.getReader(), progress);
  return await compiled ?? whole.buffer;
}
/// All bytes of a file of the program.
async function readWhole(name, reader, progress) {
  const whole = new Uint8Array(kBytes[name]);
  for (let at = 0; ;) {
    const {done, value} = await reader.read().catch(() => ({done: true}));
    if (done && at === whole.length) return whole;
    if (done) throw new Error(`The file ${name} is incomplete. Check the connection, and load the page again.`);
    if (at + value.length > whole.length) throw new Error(`The file ${name} is of another version. Load the page again, without its cache.`);
    whole.set(value, at);
    at += value.length;
    progress(value.length);
  }
}

async function loadAll() {
  const bar = document.getElementById('share');
  const all = Object.values(kBytes).reduce((sum, each) => sum + each, 0);
  let got = 0;
  const progress = more => { bar.value = (got += more) / all; };
  return Promise.all(['viewer.js', 'viewer.wasm', 'viewer.data'].map(name => load(name, progress)));
}

const frames = {asked: false, later: 0, count: 0};
/// Asks for a turn of the program's loop, if none is to come.
function wake() {
  if (!begun || frames.asked || document.hidden) return;
  clearTimeout(frames.later);
  frames.asked = true;
  requestAnimationFrame(turn);
}
function turn() {
  frames.asked = false;
  const next = turnNow();
  if (next === undefined) return;
  ++frames.count;
  document.body.classList.add('runs');
  if (document.activeElement === typed && !program._webTyping()) hideKeyboard();
  if (next === 1) return wake();
  keepSettings();
  if (next === 2) frames.later = setTimeout(wake, 250);
}
/// One turn of the program's loop; what it wants next (webTurn in main.cpp), or nothing if there is no program.
function turnNow() { return guarded(() => program._webTurn()); }
/// What a call of the program returns; nothing if it cannot go on.
function guarded(call) {
  if (!program || failedWith) return undefined;
  try {
    return call();
  } catch (error) {
    return stopped(error);
  }
}
/// Calls a function of the program with texts of any length.
function send(name, ...texts) {
  const result = guarded(() => {
    const places = texts.map(text => {
      const bytes = program.lengthBytesUTF8(text) + 1;
      const place = program._malloc(bytes);
      if (!place) throw new RangeError('out of memory');
      program.stringToUTF8(text, place, bytes);
      return place;
    });
    const answer = program['_' + name](...places);
    places.forEach(place => program._free(place));
    return answer;
  });
  wake();
  return result;
}
document.addEventListener('visibilitychange', wake);

let wanted = null;  // where to go, of several the last
/// Goes to an address, or where a link leads, once the program has begun. A file that it names is fetched first.
async function go(link) {
  wanted = link;
  if (!begun) return;
  try {
    await fetchFileOf(link);
    if (wanted === link) send('webGo', link);
  } catch (error) {
    send('webSay', error.message);
  }
}
/// Another link in the same page moves the program there; none begins again.
addEventListener('hashchange', () => {
  if (!loading || failedWith || location.hash.length < 2) return location.reload();
  go(location.hash);
});

/// For the page around: an address and the sentence about it, or the answer to a question of a lesson.
function tellAround(message) { if (framed) window.parent.postMessage(message, '*'); }
/// For a screen reader.
function read(text) { document.getElementById('sentence').textContent = text; }
/// An address and the sentence about it.
function narrated(line) {
  const [address, sentence] = line.split('\t');
  read(sentence ?? line);
  if (sentence) tellAround({address, sentence});
}

/// Enters or leaves full screen, as the program asks.
function setFullScreen(full) {
  const asked = full ? document.documentElement.requestFullscreen?.() : document.fullscreenElement && document.exitFullscreen();
  asked?.catch(toldFullScreen);
  if (full && !asked) toldFullScreen();
}
function toldFullScreen() {
  const full = document.fullscreenElement ? 1 : 0;
  guarded(() => { program._webMonitor(full); program._webFullScreen(full); });
  wake();
}
document.addEventListener('fullscreenchange', toldFullScreen);

/// The program cannot go on.
function stopped(error) {
  console.error(error);
  const text = String(error?.message ?? error);
  fail(/memory|alloc/i.test(text) ? 'The memory that a browser gives is used up: this input is too large here. The program for a desktop has no such limit.'
    : 'The program had to stop: ' + text + '\nLoad the page again. What was saved is in your downloads.');
}

canvas.addEventListener('webglcontextlost', event => {
  event.preventDefault();
  fail('The graphics of this browser have stopped. Load the page again.');
});
/// Work that is not saved: the browser asks before it goes.
addEventListener('beforeunload', event => {
  if (!guarded(() => program._webUnsaved())) return;
  event.preventDefault();
  event.returnValue = true;  // older browsers
});

// Until the reader has chosen a theme, that of the page around, or of the system.
const light = matchMedia('(prefers-color-scheme: light)');
light.addEventListener('change', () => send('webTheme', light.matches ? 'light' : 'dark'));
const still = matchMedia('(prefers-reduced-motion: reduce)');
still.addEventListener('change', () => guarded(() => program._webMotion(still.matches ? 0 : 1)));

const kPages = 'spiraling-edge pages';  // in the store: stay or start
/// The reader stays with the pages before the program: chosen, or of a browser that is to save data.
function stays() {
  const saves = matchMedia('(prefers-reduced-data: reduce)').matches ? 'stay' : 'start';
  return store !== null && (store.getItem(kPages) ?? saves) === 'stay';
}
/// Whether the program is to come. Its picture and sentence stand here where the link is that of a page.
function comesAfterPage(link) {
  if (location.hash.length > 1) document.querySelectorAll('.page').forEach(part => part.remove());
  if (!document.querySelector('.page')) {
    document.getElementById('place').textContent = placeInWords(link);
    return true;
  }
  const stay = document.getElementById('stay');
  stay.hidden = !store;
  stay.textContent = stays() ? 'Start the program' : 'Stay with the page';
  stay.addEventListener('click', () => {
    store.setItem(kPages, stays() ? 'start' : 'stay');
    location.reload();
  });
  document.getElementById('share').hidden = stays();
  return !stays();
}

async function begin() {
  const link = linkOf();
  if (!comesAfterPage(link)) return;
  const lacks = lacking();
  if (lacks) return fail(lacks);
  loading = true;
  try {
    const [code, wasm, data] = await loadAll();
    const script = document.createElement('script');
    script.textContent = new TextDecoder().decode(code);
    document.head.append(script);
    await spiralingEdge({
      instantiateWasm(imports, done) {
        WebAssembly.instantiate(wasm, imports).then(made => done(made.instance ?? made), stopped);
        return {};
      },
      getPreloadedPackage: () => data,
      preRun: [module => { program = module; openStore(module); }],
      failed: fail,
      stopped,
      sendSize, setCursor, setFullScreen, copied, tellAround, read,
      pick() { document.getElementById('picker').click(); },
      print: narrated,
      printErr(text) { console.warn(text); },
      onAbort: stopped,
    });
    await unpackFiles();
    await fetchFileOf(link);
    if (send('webBegin', root || location.href.split('#')[0], link, light.matches ? 'light' : 'dark') !== 0) return;
    program._webMotion(still.matches ? 0 : 1);
    saveAsDownloads(program);
    begun = true;
    if (!framed) canvas.focus();
    wake();
    if (wanted) go(wanted);
    keepOffline();
  } catch (error) {
    failedWith || (error instanceof WebAssembly.RuntimeError || error instanceof RangeError ? stopped(error) : fail(error.message));
  }
}

/// Keeps the program for visits without a network, but for the page that holds all of itself.
function keepOffline() {
  if (store && window.isSecureContext && navigator.serviceWorker && !onePage)
    navigator.serviceWorker.register(root + 'offline.js').catch(() => {});
}

/// The page around may move the program, {go: "137.sphere.3"} or a link, and choose its theme, {theme: "dark"}.
addEventListener('message', ({source, data}) => {
  if (!framed || source !== window.parent) return;
  if (typeof data?.go === 'string') go(data.go);
  if (typeof data?.theme === 'string') send('webTheme', data.theme);
});
