// Chromium without a screen, driven over a pipe: no library is needed.
'use strict';
const {spawn} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

const kVirtualKeys = {ArrowRight: 39, ArrowLeft: 37, ArrowUp: 38, ArrowDown: 40, Enter: 13, Escape: 27, Tab: 9, Home: 36, End: 35, PageDown: 34, PageUp: 33, Backspace: 8};
const sleep = ms => new Promise(done => setTimeout(done, ms));

class Browser {
  /// options: width, height, ratio, mobile, profile (a folder that stays), arguments (of Chromium).
  static async start(options = {}) {
    const made = new Browser();
    made.options = {width: 1280, height: 800, ratio: 1, arguments: [], ...options, mobile: options.mobile ?? false};
    made.profile = options.profile ?? fs.mkdtempSync(path.join(os.tmpdir(), 'spiraling-edge-'));
    made.downloads = path.join(made.profile, 'downloads');
    made.process = spawn('chromium', ['--headless=new', '--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader', '--ignore-gpu-blocklist',
      '--hide-scrollbars', '--no-first-run', '--remote-debugging-pipe', `--user-data-dir=${made.profile}`, `--window-size=${made.options.width},${made.options.height}`,
      ...made.options.arguments, 'about:blank'], {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    made.log = [];
    made.waiting = new Map();
    made.next = 0;
    let text = '';
    made.process.stdio[4].on('data', data => {
      text += data;
      for (let end; (end = text.indexOf('\0')) >= 0; text = text.slice(end + 1)) made.take(JSON.parse(text.slice(0, end)));
    });
    const {targetInfos} = await made.send('Target.getTargets');
    await made.attach(targetInfos.find(each => each.type === 'page').targetId);
    await made.shape();
    await made.send('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: made.downloads});
    return made;
  }

  async attach(targetId) {
    const {sessionId} = await this.send('Target.attachToTarget', {targetId, flatten: true});
    this.session = sessionId;
    for (const domain of ['Page', 'Runtime', 'Log']) await this.call(domain + '.enable');
  }
  async shape() {
    const {width, height, ratio, mobile} = this.options;
    await this.call('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: ratio, mobile});
    await this.call('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: 'light'}]});
    if (mobile) await this.call('Emulation.setTouchEmulationEnabled', {enabled: true, maxTouchPoints: 2});
  }

  take(message) {
    if (message.id) {
      const [done, failed] = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      return message.error ? failed(new Error(message.error.message)) : done(message.result);
    }
    const {method, params} = message;
    if (method === 'Runtime.consoleAPICalled') this.log.push(params.type + ': ' + params.args.map(each => each.value ?? each.description).join(' '));
    if (method === 'Runtime.exceptionThrown') this.log.push('exception: ' + (params.exceptionDetails.exception?.description ?? params.exceptionDetails.text));
    if (method === 'Log.entryAdded') this.log.push('log: ' + params.entry.text);
  }
  send(method, params = {}, sessionId = undefined) {
    return new Promise((done, failed) => {
      const id = ++this.next;
      this.waiting.set(id, [done, failed]);
      this.process.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + '\0');
    });
  }
  call(method, params) { return this.send(method, params, this.session); }

  /// Value of an expression in the page.
  async value(expression) {
    const {result, exceptionDetails} = await this.call('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true, userGesture: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  /// Waits until an expression in the page holds; fails with what the page says after a minute.
  async until(expression) {
    for (let i = 0; i < 600; ++i) {
      if (await this.value(expression).catch(() => false)) return;
      await sleep(100);
    }
    const said = await this.value(`document.title + ' | ' + (failedWith ?? '') + ' | ' + document.getElementById('sentence').textContent`).catch(String);
    throw new Error(`never: ${expression}\n  the page: ${said}\n  ${this.log.slice(-8).join('\n  ')}`);
  }
  /// Waits until the loop of frames sleeps.
  settled() { return this.until('document.body.classList.contains("runs") && !frames.asked'); }
  async open(address) {
    await this.call('Page.navigate', {url: address});
    await this.until(`document.readyState === 'complete'`);
  }
  async picture(file) {
    const {data} = await this.call('Page.captureScreenshot', {format: 'png'});
    fs.writeFileSync(file, Buffer.from(data, 'base64'));
  }

  /// "Ctrl+Shift+g", "ArrowRight", "F10"; a sign is typed.
  async key(chord) {
    const names = chord.split(/\+(?=.)/);
    const key = names.pop();
    const bits = {Alt: 1, Ctrl: 2, Shift: 8};
    const modifiers = names.reduce((sum, name) => sum | bits[name], 0);
    const code = /^[a-z]$/i.test(key) ? 'Key' + key.toUpperCase() : /^\d$/.test(key) ? 'Digit' + key : key === ' ' ? 'Space' : key;
    const number = kVirtualKeys[key] ?? (/^F\d+$/.test(key) ? 111 + Number(key.slice(1)) : key.toUpperCase().charCodeAt(0));
    const event = {modifiers, key, code, windowsVirtualKeyCode: number};
    const types = key.length === 1 && (modifiers & 3) === 0;
    await this.call('Input.dispatchKeyEvent', {...event, type: types ? 'keyDown' : 'rawKeyDown', text: types ? key : undefined});
    await this.call('Input.dispatchKeyEvent', {...event, type: 'keyUp'});
  }
  async type(text) { for (const sign of text) await this.key(sign); }
  mouse(type, x, y, more = {}) { return this.call('Input.dispatchMouseEvent', {type, x, y, ...more}); }
  async click(x, y) {
    await this.mouse('mouseMoved', x, y);
    await this.settled();
    await this.mouse('mousePressed', x, y, {button: 'left', clickCount: 1});
    await this.settled();
    await this.mouse('mouseReleased', x, y, {button: 'left', clickCount: 1});
  }
  async drag(x, y, toX, toY) {
    await this.mouse('mouseMoved', x, y);
    await this.mouse('mousePressed', x, y, {button: 'left', clickCount: 1});
    for (let i = 1; i <= 8; ++i) {
      await this.mouse('mouseMoved', x + (toX - x) * i / 8, y + (toY - y) * i / 8, {button: 'left', buttons: 1});
      await sleep(30);
    }
    await this.mouse('mouseReleased', toX, toY, {button: 'left', clickCount: 1});
  }
  wheel(x, y, deltaY) { return this.mouse('mouseWheel', x, y, {deltaX: 0, deltaY}); }
  /// Fingers along paths: [[[x, y], [toX, toY]], ...].
  async touch(paths) {
    const at = share => paths.map(([[x, y], [toX, toY]]) => ({x: x + (toX - x) * share, y: y + (toY - y) * share}));
    await this.call('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: at(0)});
    for (let i = 1; i <= 8; ++i) {
      await this.call('Input.dispatchTouchEvent', {type: 'touchMove', touchPoints: at(i / 8)});
      await sleep(30);
    }
    await this.call('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
  }
  async drop(name, bytes) {
    await this.value(`(() => { const all = new DataTransfer(); all.items.add(new File([Uint8Array.from(atob('${bytes.toString('base64')}'), c => c.charCodeAt(0))], '${name}'));
      canvas.dispatchEvent(new DragEvent('drop', {dataTransfer: all, bubbles: true, cancelable: true})); })()`);
  }
  async end() {
    if (this.ended) return;
    this.ended = true;
    const over = new Promise(done => this.process.on('exit', done));
    await this.send('Browser.close').catch(() => this.process.kill());
    await over;
    // Processes of its own may still write there.
    if (!this.options.profile) fs.rm(this.profile, {recursive: true, force: true, maxRetries: 10}, () => {});
  }
}

module.exports = {Browser, sleep};
