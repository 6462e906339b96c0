// Keys, pointer, fingers, wheel and size, as calls of platform/glfw_canvas.cpp.
const kPress = 1, kRepeat = 2, kRelease = 0;
/// Numbers of GLFW by the browser's code of the key, for keys that are not known by their label.
const kKeys = {
  Space: 32, Quote: 39, Comma: 44, Minus: 45, Period: 46, Slash: 47, Semicolon: 59, Equal: 61, BracketLeft: 91, Backslash: 92,
  BracketRight: 93, Backquote: 96, Escape: 256, Enter: 257, Tab: 258, Backspace: 259, Insert: 260, Delete: 261, ArrowRight: 262,
  ArrowLeft: 263, ArrowDown: 264, ArrowUp: 265, PageUp: 266, PageDown: 267, Home: 268, End: 269, NumpadDecimal: 330, NumpadDivide: 331,
  NumpadMultiply: 332, NumpadSubtract: 333, NumpadAdd: 334, NumpadEnter: 335,
};
const kModifiers = [['shiftKey', 1, 340], ['ctrlKey', 2, 341], ['altKey', 4, 342]];
const apple = /Mac|iPhone|iPad/.test(navigator.platform);
const held = {mods: 0, keys: new Map()};  // keys: the number that was sent, by code

function modsOf(event) {
  // AltGr types characters: it is neither Ctrl nor Alt.
  const types = event.getModifierState?.('AltGraph');
  const ctrl = (event.ctrlKey || (apple && event.metaKey)) && !types;
  return (event.shiftKey ? 1 : 0) | (ctrl ? 2 : 0) | (event.altKey && !types ? 4 : 0);
}
/// The event's modifiers count: one may have been pressed or released elsewhere.
function tellMods(mods) {
  for (const [, bit, key] of kModifiers)
    if ((mods ^ held.mods) & bit) program._webKey(key, mods & bit ? kPress : kRelease, mods);
  held.mods = mods;
}
function keyNumber(event) {
  if (/^[a-zA-Z]$/.test(event.key)) return event.key.toUpperCase().charCodeAt(0);
  if (/^Digit\d$/.test(event.code)) return event.code.charCodeAt(5);
  if (/^Key[A-Z]$/.test(event.code)) return event.code.charCodeAt(3);
  if (/^F\d+$/.test(event.code)) return 289 + Number(event.code.slice(1));
  if (/^Numpad\d$/.test(event.code)) return 320 + Number(event.code.slice(6));
  return kKeys[event.code] ?? kKeys[event.key] ?? 0;
}
/// Keys that stay with the browser: paste, zoom, reload, tabs, its address and its tools.
function isBrowsers(event, mods) {
  if (event.key === 'F12' || event.isComposing) return true;
  if (apple ? event.ctrlKey : event.metaKey) return true;
  return (mods & 2) !== 0 && /^[vlrtwn+\-=0]$/i.test(event.key) || (mods & 3) === 3 && /^[ijk]$/i.test(event.key);
}

function onKey(event) {
  if (!program) return;
  const mods = modsOf(event);
  tellMods(mods);
  const down = event.type === 'keydown';
  const ofModifier = /^(Shift|Control|Alt|Meta)/.test(event.code);
  const key = down ? keyNumber(event) : held.keys.get(event.code) ?? 0;
  if (key !== 0 && !ofModifier) {
    program._webKey(key, !down ? kRelease : event.repeat ? kRepeat : kPress, mods);
    down ? held.keys.set(event.code, key) : held.keys.delete(event.code);
  }
  const signs = [...event.key];
  if (down && signs.length === 1 && event.target !== typed) program._webSign(signs[0].codePointAt(0), mods);
  if (!isBrowsers(event, mods) && event.target !== typed) event.preventDefault();
  if (down && (mods & 2) && event.key === 'o') event.preventDefault();
  wake();
}
function releaseAll() {
  if (!program) return;
  for (const key of held.keys.values()) program._webKey(key, kRelease, 0);
  held.keys.clear();
  tellMods(0);
}

// A keyboard on the screen writes into a field of the page.
const typed = document.getElementById('typed');
typed.addEventListener('input', () => {
  for (const sign of typed.value) program?._webSign(sign.codePointAt(0), 0);
  typed.value = '';
  wake();
});
for (const type of ['keydown', 'keyup']) {
  canvas.addEventListener(type, onKey);
  typed.addEventListener(type, onKey);
}
canvas.addEventListener('focus', () => { program?._webFocus(1); wake(); });
canvas.addEventListener('blur', () => { releaseAll(); program?._webFocus(0); wake(); });

/// In a page of others the wheel scrolls that page, until the picture has been clicked.
let engaged = !framed;
canvas.addEventListener('pointerleave', () => { engaged = !framed; });

function toScreen(event) {
  const ratio = window.devicePixelRatio;
  program._webPointer(event.clientX * ratio, event.clientY * ratio);
}
function press(event, button, action) {
  const mods = modsOf(event);
  tellMods(mods);
  program._webButton(button, action, mods);
  wake();
}
const kButtons = [0, 2, 1];
function onPointer(event) {
  if (!program || event.pointerType === 'touch') return;
  toScreen(event);
  tellMods(modsOf(event));
  if (event.type === 'pointerdown') {
    engaged = true;
    canvas.focus();
    canvas.setPointerCapture(event.pointerId);
  }
  wake();
}
for (const type of ['pointermove', 'pointerdown', 'pointerup']) canvas.addEventListener(type, onPointer);
// Of several buttons only the first has events of the pointer; those of the mouse have them all.
for (const [type, action] of [['mousedown', kPress], ['mouseup', kRelease]])
  canvas.addEventListener(type, event => {
    if (!program || fingers.size > 0) return;
    event.preventDefault();
    press(event, kButtons[event.button] ?? 0, action);
  });
canvas.addEventListener('contextmenu', event => event.preventDefault());
canvas.addEventListener('wheel', event => {
  if (!program || !engaged) return;
  event.preventDefault();
  toScreen(event);
  tellMods(modsOf(event) & (event.ctrlKey && !held.keys.size ? 5 : 7));  // a pinch on a touchpad says Ctrl
  const unit = -[100, 3, 1][event.deltaMode] / (event.ctrlKey ? 10 : 1);
  program._webWheel(event.deltaX / unit, event.deltaY / unit);
  wake();
}, {passive: false});

// One finger is the left button, held still the right one; two fingers move and zoom.
const fingers = new Map();
const touch = {button: -1, span: 0, hold: 0};
function liftButton(event) {
  clearTimeout(touch.hold);
  if (touch.button >= 0) press(event, touch.button, kRelease);
  touch.button = -1;
}
function touchButton(event, button) {
  liftButton(event);
  touch.button = button;
  press(event, button, kPress);
}
/// The middle of the fingers and how far they are apart.
function middle() {
  const all = [...fingers.values()];
  const sum = all.reduce((a, b) => ({clientX: a.clientX + b.clientX, clientY: a.clientY + b.clientY}));
  const span = all.length < 2 ? 0 : Math.hypot(all[0].clientX - all[1].clientX, all[0].clientY - all[1].clientY);
  return {clientX: sum.clientX / all.length, clientY: sum.clientY / all.length, span};
}
function onTouch(event) {
  if (!program || event.pointerType !== 'touch') return;
  event.preventDefault();
  const type = event.type;
  if (type === 'pointerdown') {
    engaged = true;
    canvas.focus({preventScroll: true});
    fingers.set(event.pointerId, {clientX: event.clientX, clientY: event.clientY, began: event});
    toScreen(middle());
    if (fingers.size === 1) {
      touchButton(event, 0);
      touch.hold = setTimeout(() => { touchButton(event, 1); liftButton(event); }, 600);
    } else if (fingers.size === 2) {
      touch.span = middle().span;
      touchButton(event, 1);
    }
  } else if (fingers.has(event.pointerId)) {
    const finger = fingers.get(event.pointerId);
    if (type === 'pointermove') {
      if (Math.hypot(event.clientX - finger.began.clientX, event.clientY - finger.began.clientY) > 8) clearTimeout(touch.hold);
      Object.assign(finger, {clientX: event.clientX, clientY: event.clientY});
      const now = middle();
      toScreen(now);
      if (fingers.size === 2 && Math.abs(now.span - touch.span) > 4) {
        program._webWheel(0, (now.span - touch.span) / 25);
        touch.span = now.span;
      }
    } else {
      fingers.delete(event.pointerId);
      liftButton(event);
      // Nothing stays under a finger that has left.
      if (fingers.size === 0) setTimeout(() => { program._webPointer(-1e9, -1e9); wake(); }, 100);
    }
  }
  wake();
}
for (const type of ['pointerdown', 'pointermove', 'pointerup', 'pointercancel']) canvas.addEventListener(type, onTouch);

/// Size in pixels of the screen, and how many of them are one of the page.
function tellSize() {
  const ratio = window.devicePixelRatio;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  program._webSize(canvas.width, canvas.height, ratio);
  wake();
}
new ResizeObserver(() => { if (program && document.body.classList.contains('runs')) tellSize(); }).observe(canvas);
/// Zoom of the browser, or another screen.
function watchRatio() {
  matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`).addEventListener('change', () => { if (program) tellSize(); watchRatio(); }, {once: true});
}
watchRatio();

const kCursors = {0x36001: 'default', 0x36002: 'text', 0x36003: 'crosshair', 0x36004: 'pointer', 0x36005: 'ew-resize', 0x36006: 'ns-resize'};
function setCursor(shape) { canvas.style.cursor = kCursors[shape] ?? 'default'; }
