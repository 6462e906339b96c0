// Start: what the browser lacks is said in a sentence; the files are fetched under a bar; then the
// program runs, and the loop of its frames sleeps while nothing moves.
const canvas = document.getElementById('canvas');
const framed = window.parent !== window;
let program = null;  // Emscripten's module, once it runs
let failedWith = null;

/// Says in the page why there is no program. The first reason counts.
function fail(sentence) {
  if (failedWith) return console.error(sentence);
  failedWith = sentence;
  document.body.classList.remove('runs');
  document.getElementById('share').hidden = true;
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
  if (!document.createElement('canvas').getContext('webgl2'))
    return 'This browser shows no WebGL 2. Allow hardware acceleration in its settings, or use another browser.';
  return '';
}

/// Where the link leads, in words.
function placeInWords(hash) {
  const link = new URLSearchParams(hash.replace(/^#/, '').replace(/\+/g, '%2B'));
  const input = ['scene', 'lesson', 'figure', 'sample', 'file'].filter(name => link.get(name)).map(name => `${name} ${link.get(name)}`)[0]
    ?? (link.get('pack') ?? '').split(':')[0];
  return [input, link.get('goto') && `at ${link.get('goto')}`, link.get('step') && `step ${link.get('step')}`].filter(Boolean).join(', ');
}

/// Bytes of one file of the program: from this page if it holds them, else from beside it.
async function load(name, progress) {
  const packed = document.getElementById('packed-' + name);
  if (packed) {
    const bytes = Uint8Array.from(atob(packed.textContent), c => c.charCodeAt(0));
    packed.remove();
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
  }
  const answer = await fetch(name).catch(() => null);
  if (!answer) throw new Error(`The file ${name} of the program could not be fetched. Check the connection, and load the page again.`);
  if (!answer.ok) throw new Error(`The file ${name} of the program is not there (${answer.status}). Whoever set up this page has to add it.`);
  const whole = new Uint8Array(kBytes[name]);
  let at = 0;
  for (const reader = answer.body.getReader(); ;) {
    const {done, value} = await reader.read();
    if (done) break;
    if (at + value.length > whole.length) throw new Error(`The file ${name} is of another version. Load the page again, without its cache.`);
    whole.set(value, at);
    at += value.length;
    progress(value.length);
  }
  if (at !== whole.length) throw new Error(`The file ${name} is incomplete. Load the page again.`);
  return whole.buffer;
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
  if (!program || frames.asked || document.hidden) return;
  clearTimeout(frames.later);
  frames.asked = true;
  requestAnimationFrame(turn);
}
function turn() {
  frames.asked = false;
  if (!program || failedWith) return;
  let next = 0;
  try {
    next = program._webTurn();
  } catch (error) {
    return stopped(error);
  }
  ++frames.count;
  document.body.classList.add('runs');
  if (next === 1) return wake();
  keepSettings();
  if (next === 2) frames.later = setTimeout(wake, 250);
}
document.addEventListener('visibilitychange', wake);

/// Another link in the same page moves the program there.
addEventListener('hashchange', () => {
  if (!program || failedWith) return location.reload();
  program.ccall('webGo', null, ['string'], [location.hash]);
  wake();
});

/// An address and the sentence about it: for a screen reader, and for the page around.
function narrated(line) {
  const [address, sentence] = line.split('\t');
  document.getElementById('sentence').textContent = sentence ?? line;
  if (framed && sentence) window.parent.postMessage({address, sentence}, '*');
}

/// The program cannot go on.
function stopped(error) {
  console.error(error);
  const text = String(error?.message ?? error);
  fail(/memory|allocation/i.test(text) ? 'The memory that a browser gives is used up: this input is too large here. The program for a desktop has no such limit.'
    : 'The program had to stop: ' + text + '\nLoad the page again. What was saved is in your downloads.');
}

async function begin() {
  document.getElementById('place').textContent = placeInWords(location.hash);
  // Kept for visits without a network, but for the page that holds all of itself.
  if (store && window.isSecureContext && navigator.serviceWorker && !document.getElementById('packed-viewer.wasm'))
    navigator.serviceWorker.register('offline.js').catch(() => {});
  const lacks = lacking();
  if (lacks) return fail(lacks);
  try {
    const [code, wasm, data] = await loadAll();
    const script = document.createElement('script');
    script.textContent = new TextDecoder().decode(code);
    document.head.append(script);
    await spiralingEdge({
      arguments: [location.href, matchMedia('(prefers-color-scheme: light)').matches ? 'light' : 'dark'],
      wasmBinary: wasm,
      getPreloadedPackage: () => data,
      preRun: [module => { program = module; openStore(module); }],
      begin() { saveAsDownloads(program); canvas.focus(); wake(); },
      failed: fail,
      tellSize, setCursor, copied,
      pick() { document.getElementById('picker').click(); },
      print: narrated,
      printErr(text) { console.warn(text); },
      onAbort: stopped,
    });
  } catch (error) {
    failedWith || (error instanceof WebAssembly.RuntimeError || error instanceof RangeError ? stopped(error) : fail(error.message));
  }
}

/// The page around may move the program: {go: "137.sphere.3"}, or a link.
addEventListener('message', event => {
  if (!framed || event.source !== window.parent || typeof event.data?.go !== 'string' || !program || failedWith) return;
  program.ccall('webGo', null, ['string'], [event.data.go]);
  wake();
});
