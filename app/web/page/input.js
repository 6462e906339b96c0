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
const held = {mods: 0, control: false, keys: new Map()};  // keys: the number that was sent, by code

function modsOf(event) {
  // AltGr types characters: it is neither Ctrl nor Alt.
  const types = event.getModifierState?.('AltGraph');
  const ctrl = (event.ctrlKey || (apple && event.metaKey)) && !types;
  return (event.shiftKey ? 1 : 0) | (ctrl ? 2 : 0) | (event.altKey && !types ? 4 : 0);
}
/// The event's modifiers count: one may have been pressed or released elsewhere.
function sendMods(mods) {
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
/// Keys that stay with the browser: Ctrl with R, L, T, W, N and the zoom, its tools; Tab in a frame, until it is clicked.
function isBrowsers(event, mods) {
  if (event.key === 'F12' || event.isComposing || (event.key === 'Tab' && !engaged)) return true;
  if (apple ? event.ctrlKey : event.metaKey) return true;
  return (mods & 2) !== 0 && /^[lrtwn+\-=0]$/i.test(event.key) || (mods & 3) === 3 && /^[ijk]$/i.test(event.key);
}

function onKey(event) {
  if (!program || event.keyCode === 229) return;  // of a keyboard on the screen: its text comes by an event of its own
  const mods = modsOf(event);
  sendMods(mods);
  const down = event.type === 'keydown';
  const ofModifier = /^(Shift|Control|Alt|Meta)/.test(event.code);
  if (event.code.startsWith('Control')) held.control = down;
  // A Mac does not tell of keys that are released while Command is held.
  if (!down && event.key === 'Meta') releaseAll();
  if (down && isBrowsers(event, mods)) return wake();
  const character = [...event.key].length === 1 ? event.key.codePointAt(0) : 0;
  // Text in the field of the page comes by its own event.
  const ofField = event.target === typed && ((mods & 6) === 0 || (mods & 2 && /v/i.test(event.key))) && (character !== 0 || event.key === 'Backspace');
  const key = down ? keyNumber(event) : held.keys.get(event.code) ?? 0;
  if (key !== 0 && !ofModifier && !ofField) {
    program._webKey(key, !down ? kRelease : event.repeat ? kRepeat : kPress, mods);
    down ? held.keys.set(event.code, key) : held.keys.delete(event.code);
  }
  if (down && character !== 0 && !ofField) program._webCharacter(character, mods);
  // The event of pasting follows its key.
  if (!ofField && !(character !== 0 && (mods & 2) && /v/i.test(event.key))) event.preventDefault();
  wake();
}
function releaseAll() {
  if (!program) return;
  for (const key of held.keys.values()) program._webKey(key, kRelease, 0);
  held.keys.clear();
  held.control = false;
  sendMods(0);
}

// A keyboard on the screen writes into a field of the page: what it changes there is typed. The space is
// for Backspace, which has no event in an empty field.
const typed = document.getElementById('typed');
typed.value = ' ';
let wasTyped = typed.value;
function typeKey(key) { for (const action of [kPress, kRelease]) program._webKey(key, action, 0); }
typed.addEventListener('input', event => {
  if (!program) return;
  const now = [...typed.value], before = [...wasTyped];
  let same = 0;
  while (same < now.length && now[same] === before[same]) ++same;
  for (let i = same; i < before.length; ++i) typeKey(kKeys.Backspace);
  for (const character of now.slice(same)) program._webCharacter(character.codePointAt(0), 0);
  if (!event.isComposing) typed.value = ' ';
  wasTyped = typed.value;
  wake();
});
typed.addEventListener('blur', event => {
  typed.value = wasTyped = ' ';
  if (event.relatedTarget !== canvas) leaveProgram();
});
/// Shows the keyboard of the screen while a text field of the program has the focus; called in an event of a finger,
/// in which alone a browser shows it.
function showKeyboard() {
  for (let i = 0; i < 5; ++i) turnNow();  // a field has the focus in the fourth frame after the tap
  if (program._webTyping()) typed.focus({preventScroll: true});
  else hideKeyboard();
}
function hideKeyboard() { if (document.activeElement === typed) canvas.focus({preventScroll: true}); }
for (const type of ['keydown', 'keyup']) {
  canvas.addEventListener(type, onKey);
  typed.addEventListener(type, onKey);
}
canvas.addEventListener('focus', () => { program?._webFocus(1); wake(); });
canvas.addEventListener('blur', event => {
  releaseAll();
  if (event.relatedTarget !== typed) leaveProgram();
});
/// The keyboard is of something else.
function leaveProgram() {
  releaseAll();
  engage(false);
  program?._webFocus(0);
  wake();
}

/// In a page of others wheel, Tab and a finger are of that page, until the picture has been clicked.
let engaged = !framed;
function engage(on) {
  engaged = on || !framed;
  canvas.style.touchAction = engaged ? 'none' : 'pan-x pan-y';
}
engage(false);
canvas.addEventListener('pointerleave', event => {
  if (!program || event.pointerType === 'touch' || event.buttons !== 0) return;
  engage(false);
  leave();
});

/// The pointer is nowhere.
function leave() {
  program._webPointer(-1e9, -1e9);
  wake();
}

function toScreen(event) {
  const ratio = window.devicePixelRatio;
  program._webPointer(event.clientX * ratio, event.clientY * ratio);
}
function press(event, button, action) {
  const mods = modsOf(event);
  sendMods(mods);
  program._webButton(button, action, mods);
  wake();
}
const kButtons = [0, 2, 1];
function onPointer(event) {
  if (!program || event.pointerType === 'touch') return;
  toScreen(event);
  sendMods(modsOf(event));
  if (event.type === 'pointerdown') {
    engage(true);
    canvas.focus({preventScroll: true});
    canvas.setPointerCapture(event.pointerId);
  }
  wake();
}
for (const type of ['pointermove', 'pointerdown', 'pointerup']) canvas.addEventListener(type, onPointer);
// Of several buttons only the first has events of the pointer; those of the mouse have them all.
for (const [type, action] of [['mousedown', kPress], ['mouseup', kRelease]])
  canvas.addEventListener(type, event => {
    if (!program || fingers.size > 0 || event.button >= kButtons.length) return;
    event.preventDefault();
    press(event, kButtons[event.button], action);
  });
canvas.addEventListener('contextmenu', event => event.preventDefault());
canvas.addEventListener('wheel', event => {
  if (!program || !engaged) return;
  event.preventDefault();
  toScreen(event);
  const pinch = event.ctrlKey && !held.control;  // a touchpad says it so
  sendMods(modsOf(event) & (pinch ? 5 : 7));
  const unit = -[100, 3, 1][event.deltaMode] / (pinch ? 10 : 1);
  program._webWheel(event.deltaX / unit, event.deltaY / unit);
  wake();
}, {passive: false});

// One finger taps, drags, or scrolls a list; held still it is the right button. Two fingers move and zoom.
const kHold = 600;   // ms until a finger that rests is the right button
const kStill = 8;    // pixels that a resting finger may move
const fingers = new Map();
const touch = {does: 'nothing', button: -1, span: 0, hold: 0, began: null, at: null};

function holdButton(event, button) {
  if (touch.button >= 0) press(event, touch.button, kRelease);
  touch.button = button;
  if (button >= 0) press(event, button, kPress);
}
/// The middle of the fingers, and how far they are apart.
function middle() {
  const all = [...fingers.values()];
  const sum = all.reduce((a, b) => ({clientX: a.clientX + b.clientX, clientY: a.clientY + b.clientY}));
  const span = all.length < 2 ? 0 : Math.hypot(all[0].clientX - all[1].clientX, all[0].clientY - all[1].clientY);
  return {clientX: sum.clientX / all.length, clientY: sum.clientY / all.length, span};
}
function begins(does, event) {
  clearTimeout(touch.hold);
  holdButton(event, -1);
  touch.does = does;
  if (fingers.size === 0) return;
  touch.at = middle();
  if (does === 'tap') touch.began = touch.at;
  if (does === 'scroll' || does === 'nothing') return;
  toScreen(touch.at);
  if (does === 'tap' && engaged) touch.hold = setTimeout(() => { holdButton(event, 1); begins('nothing', event); }, kHold);
  if (does === 'move') holdButton(event, 1);
}
/// Scrolls the list where the finger began, if one is there.
function scrollList(by) {
  const ratio = window.devicePixelRatio;
  return program._webScroll(touch.began.clientX * ratio, touch.began.clientY * ratio, by * ratio);
}
/// What a finger does that has begun to move: a list scrolls across its rows, a slider is drawn along them.
function fingerMoves(event, dx, dy) {
  if (!engaged) return begins('nothing', event);
  const list = Math.abs(dy) > Math.abs(dx) && scrollList(0);
  begins(list ? 'scroll' : 'drag', event);
  if (!list) holdButton(event, 0);
}
function onFingerMove(event) {
  const finger = fingers.get(event.pointerId);
  Object.assign(finger, {clientX: event.clientX, clientY: event.clientY});
  const now = middle();
  if (touch.does === 'tap') {
    const dx = now.clientX - touch.at.clientX, dy = now.clientY - touch.at.clientY;
    if (Math.hypot(dx, dy) <= kStill) return;
    fingerMoves(event, dx, dy);
  }
  if (touch.does === 'scroll') {
    scrollList(now.clientY - touch.at.clientY);
    touch.at = now;
  } else if (touch.does !== 'nothing') {
    toScreen(now);
  }
  if (touch.does === 'move' && Math.abs(now.span - touch.at.span) > 4) {
    program._webWheel(0, (now.span - touch.at.span) / 25);
    touch.at = now;
  }
}
function onFingerUp(event) {
  const tapped = touch.does === 'tap' && event.type === 'pointerup';
  fingers.delete(event.pointerId);
  if (tapped) {
    engage(true);
    canvas.focus({preventScroll: true});
    holdButton(event, 0);
  }
  begins('nothing', event);
  if (tapped) showKeyboard();
  // Nothing stays under a finger that has left.
  setTimeout(() => { if (program && fingers.size === 0) leave(); }, 100);
}
function onTouch(event) {
  if (!program || event.pointerType !== 'touch') return;
  if (event.type === 'pointerdown') {
    fingers.set(event.pointerId, {clientX: event.clientX, clientY: event.clientY});
    begins(['tap', engaged ? 'move' : 'nothing'][fingers.size - 1] ?? 'nothing', event);
  } else if (fingers.has(event.pointerId)) {
    event.type === 'pointermove' ? onFingerMove(event) : onFingerUp(event);
  }
  event.preventDefault();  // no presses of a mouse follow; what scrolls the page around is chosen by touchAction
  wake();
}
for (const type of ['pointerdown', 'pointermove', 'pointerup', 'pointercancel']) canvas.addEventListener(type, onTouch);

/// Size in pixels of the screen, and how many of them are one of the page.
function sendSize() {
  const ratio = window.devicePixelRatio;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  program._webSize(canvas.width, canvas.height, ratio);
  wake();
}
new ResizeObserver(() => { if (program && document.body.classList.contains('runs')) sendSize(); }).observe(canvas);
/// Zoom of the browser, or another screen.
function watchRatio() {
  matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`).addEventListener('change', () => { if (program) sendSize(); watchRatio(); }, {once: true});
}
watchRatio();

const kCursors = {0x36001: 'default', 0x36002: 'text', 0x36003: 'crosshair', 0x36004: 'pointer', 0x36005: 'ew-resize', 0x36006: 'ns-resize'};
function setCursor(shape) { canvas.style.cursor = kCursors[shape] ?? 'default'; }
