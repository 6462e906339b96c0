// The program in Firefox, on the display that DISPLAY names: without one it has no WebGL.
// firefox.js SITE ONE_FILE PICTURES. Driven by Marionette, a socket of Firefox.
'use strict';
const {spawn} = require('child_process');
const fs = require('fs');
const net = require('net');
const os = require('os');
const path = require('path');
const {serve} = require('./server.js');

const sleep = ms => new Promise(done => setTimeout(done, ms));

class Firefox {
  static async start(width, height) {
    const made = new Firefox();
    made.profile = fs.mkdtempSync(path.join(os.tmpdir(), 'firefox-'));
    const port = 20000 + process.pid % 20000;
    fs.writeFileSync(path.join(made.profile, 'user.js'), [
      ['marionette.port', port], ['webgl.force-enabled', true], ['browser.download.folderList', 2],
      ['browser.download.dir', `'${made.profile}'`]].map(([name, value]) => `user_pref('${name}', ${value});\n`).join(''));
    made.process = spawn('firefox-esr', ['--marionette', '--remote-allow-system-access', '--no-remote', '--profile', made.profile, '--width', String(width), '--height', String(height)], {stdio: 'ignore'});
    for (let i = 0; !made.socket; ++i) {
      await sleep(200);
      made.socket = await new Promise(done => {
        const socket = net.connect(port, '127.0.0.1', () => done(socket)).on('error', () => done(null));
      });
      if (i > 150) throw new Error('Firefox does not answer');
    }
    made.waiting = new Map();
    let bytes = Buffer.alloc(0);
    made.socket.on('data', data => {
      bytes = Buffer.concat([bytes, data]);
      for (let colon; (colon = bytes.indexOf(':')) > 0;) {
        const length = Number(bytes.subarray(0, colon));
        if (bytes.length < colon + 1 + length) break;
        const message = JSON.parse(bytes.subarray(colon + 1, colon + 1 + length));
        bytes = bytes.subarray(colon + 1 + length);
        if (!Array.isArray(message)) continue;
        const [, id, error, result] = message;
        const [done, failed] = made.waiting.get(id);
        error ? failed(new Error(error.message)) : done(result);
      }
    });
    await made.call('WebDriver:NewSession', {});
    return made;
  }
  call(name, parameters) {
    return new Promise((done, failed) => {
      const id = this.waiting.size + 1;
      this.waiting.set(id, [done, failed]);
      const text = JSON.stringify([0, id, name, parameters]);
      this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  }
  async value(expression) { return (await this.call('WebDriver:ExecuteScript', {script: `return ${expression}`, args: [], sandbox: null})).value; }
  async until(expression) {
    for (let i = 0; i < 600; ++i, await sleep(100)) if (await this.value(expression).catch(() => false)) return;
    throw new Error(`never: ${expression}; the page: ${await this.value('document.title + " | " + document.body.innerText').catch(String)}`);
  }
  /// Sets a preference of the browser.
  async prefer(name, value) {
    await this.call('Marionette:SetContext', {value: 'chrome'});
    await this.call('WebDriver:ExecuteScript', {script: `Services.prefs.setBoolPref('${name}', ${value})`, args: []});
    await this.call('Marionette:SetContext', {value: 'content'});
  }
  /// A key by its name, or by WebDriver's number.
  key(value) {
    return this.call('WebDriver:PerformActions', {actions: [{type: 'key', id: 'keyboard', actions: [{type: 'keyDown', value}, {type: 'keyUp', value}]}]});
  }
  /// Keys that are held together.
  keys(values) {
    const actions = [...values.map(value => ({type: 'keyDown', value})), ...values.map(value => ({type: 'keyUp', value})).reverse()];
    return this.call('WebDriver:PerformActions', {actions: [{type: 'key', id: 'keyboard', actions}]});
  }
  /// A pointer along a path, pressed: [[x, y], ...]; type: mouse or touch.
  async drag(pointerType, path) {
    const moves = path.map(([x, y]) => ({type: 'pointerMove', x, y, duration: 60, origin: 'viewport'}));
    const actions = [moves[0], {type: 'pointerDown', button: 0}, ...moves.slice(1), {type: 'pointerUp', button: 0}];
    await this.call('WebDriver:PerformActions', {actions: [{type: 'pointer', id: pointerType, parameters: {pointerType}, actions}]});
  }
  wheel(x, y, deltaY) {
    return this.call('WebDriver:PerformActions', {actions: [{type: 'wheel', id: 'wheel', actions: [{type: 'scroll', x, y, deltaX: 0, deltaY, origin: 'viewport'}]}]});
  }
  async screen() { return (await this.call('WebDriver:TakeScreenshot', {full: false})).value; }
  async picture(file) { fs.writeFileSync(file, Buffer.from(await this.screen(), 'base64')); }
  async end() {
    this.process.kill();
    await new Promise(done => this.process.on('exit', done));
    fs.rmSync(this.profile, {recursive: true, force: true, maxRetries: 5});
  }
}

(async () => {
  const [site, oneFile, pictures] = process.argv.slice(2, 5).map(each => path.resolve(each));
  fs.mkdirSync(pictures, {recursive: true});
  const server = await serve(site);
  const lacking = await serve(site, {missing: ['viewer.wasm']});
  const version = fs.readdirSync(site).find(name => fs.statSync(path.join(site, name)).isDirectory());
  const listens = `<title></title><script>addEventListener('message', e => { document.title = JSON.stringify(e.data); });</script>`;
  const page = fs.readFileSync(path.join(site, version, 'index.html'), 'utf8');
  const around = await serve(site, {pages: {
    [`/${version}/old`]: page.replace('<head>', '<head><script>WebAssembly.validate = () => false;</script>'),
    '/around': `${listens}<iframe src="/${version}/#scene=torus&goto=137.sphere.3" width="900" height="600"></iframe>`,
    '/sandbox': `${listens}<iframe sandbox="allow-scripts" src="/one#scene=torus&goto=137.sphere.3" width="900" height="600"></iframe>`,
    '/one': fs.readFileSync(oneFile, 'utf8')}});
  const browser = await Firefox.start(1280, 800);
  let code = 0;
  const test = async (name, run) => {
    try {
      await run();
      console.log(`ok    Firefox: ${name}`);
    } catch (error) {
      console.log(`FAIL  Firefox: ${name}\n${error.stack}`);
      code = 1;
    }
  };
  // The page before may go on for a while: it, too, runs.
  const open = async url => {
    await browser.call('WebDriver:Navigate', {url});
    await browser.until(`location.href.startsWith('${url.replace(/#.*/, '')}') && document.readyState === 'complete'`);
  };
  await test('a link lands at its decision, and keys step', async () => {
    await open(`${server.address}${version}/#scene=torus&goto=137.sphere.3`);
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.key('\uE014');
    await browser.until(`document.title.startsWith('137.sphere.4')`);
    await browser.picture(path.join(pictures, 'firefox.png'));
  });
  await test('a lesson opens by a link', async () => {
    await open(`${server.address}${version}/#lesson=removal`);
    await browser.until(`/scene:figure-8/.test(document.title)`);
  });
  await test('one file opens from a disk', async () => {
    await open(`file://${oneFile}#scene=torus&goto=20.sort.1`);
    await browser.until(`document.title.startsWith('20.sort.1')`);
  });
  const runs = `document.body.classList.contains('runs')`;
  await test('the mouse turns, the wheel zooms, a finger turns', async () => {
    await open(`${server.address}${version}/?hand#scene=torus&goto=137.sphere.3`);
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    const seen = new Set();
    for (const act of [async () => {}, () => browser.drag('mouse', [[450, 400], [500, 380], [540, 360]]), () => browser.wheel(450, 400, -300),
      () => browser.drag('touch', [[450, 400], [470, 430], [520, 470]])]) {
      await act();
      await sleep(1500);
      seen.add(await browser.screen());
    }
    if (seen.size !== 4) throw new Error(`${seen.size} of 4 pictures differ`);
  });
  const drop = (name, bytes) => browser.value(`(() => { const all = new DataTransfer();
    all.items.add(new File([Uint8Array.from(atob('${bytes.toString('base64')}'), c => c.charCodeAt(0))], '${name}'));
    document.getElementById('canvas').dispatchEvent(new DragEvent('drop', {dataTransfer: all, bubbles: true, cancelable: true})); return 1; })()`);
  await test('a dropped file runs', async () => {
    await open(`${server.address}${version}/?drop`);
    await browser.until(runs);
    await drop('sheet.ply', fs.readFileSync(path.resolve(__dirname, '../../../assets/points/sheet.ply')));
    await browser.until(`/sheet\\.ply/.test(document.title)`);
  });
  await test('what is saved is a download, and opens again', async () => {
    await open(`${server.address}${version}/?save#scene=torus&goto=137.sphere.3`);
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.keys(['\uE009', 's']);
    await sleep(500);
    await browser.key('\uE007');
    const file = path.join(browser.profile, 'torus.sesession');
    for (let i = 0; i < 300 && !(fs.existsSync(file) && fs.statSync(file).size > 0); ++i) await sleep(100);
    const saved = fs.readFileSync(file);
    await open(`${server.address}${version}/?saved#scene=sphere`);
    await browser.until(`/scene:sphere/.test(document.title)`);
    await drop('torus.sesession', saved);
    await browser.until(`/137\\.sphere\\.3/.test(document.title)`);
  });
  await test('a chosen theme stays for the next visit', async () => {
    await open(`${server.address}${version}/?theme#scene=torus`);
    await browser.until(runs);
    await browser.key('t');
    await browser.until(`Object.keys(localStorage).some(name => /"theme"/.test(localStorage[name]))`);
  });
  await test('a copied link leads back, and one to a failure opens on it', async () => {
    const copies = `(window.said = '', navigator.clipboard.writeText = async text => { window.said = text; }, 1)`;
    await open(`${server.address}${version}/?copy#scene=noise`);
    await browser.until(runs);
    await browser.value(`window.eval("${copies.replace(/"/g, '\\"')}")`);
    await browser.key('\uE038');  // F8
    await browser.until(`/fault|Place/.test(document.getElementById('sentence').textContent)`);
    await browser.keys(['\uE009', 'c']);
    await browser.until(`window.eval('said').includes('#scene=noise')`);
    await browser.keys(['\uE009', 'p']);
    await sleep(500);
    for (const letter of 'link to this failure') await browser.key(letter);
    await sleep(500);
    await browser.key('\uE007');
    await browser.until(`window.eval('said').includes('pack=')`);
    await open((await browser.value(`window.eval('said')`)).replace('#', '?again#'));
    await browser.until(`/\\.ply/.test(document.title)`);
  });
  await test('a page around hears of steps and moves the frame', async () => {
    await open(around.address + 'around');
    await browser.until(`/"address":"137.sphere.3","sentence":"Point 242 lies/.test(document.title)`);
    await browser.value(`(frames[0].postMessage({go: '20.sort.1'}, '*'), 1)`);
    await browser.until(`/"address":"20.sort.1"/.test(document.title)`);
  });
  await test('a sandboxed frame runs the one file', async () => {
    await open(around.address + 'sandbox');
    await browser.until(`/"address":"137.sphere.3"/.test(document.title)`);
  });
  await test('a wrong name, and a file that is not there, are said', async () => {
    await open(`${server.address}${version}/?wrong#scene=torus&gto=1`);
    await browser.until(`/gto.*goto/s.test(document.getElementById('why').textContent)`);
    await open(`${lacking.address}${version}/`);
    await browser.until(`/viewer\\.wasm of the program is not there/.test(document.getElementById('why').textContent)`);
  });
  const says = sentence => browser.until(`${sentence}.test(document.getElementById('why').textContent)`);
  await test('a browser without WebGL 2, or without exceptions of WebAssembly, is told what to do', async () => {
    await browser.prefer('webgl.disabled', true);
    await open(`${server.address}${version}/?flat#scene=torus`);
    await says('/no WebGL 2.*hardware acceleration/');
    await browser.prefer('webgl.disabled', false);
    await open(`${around.address}${version}/old`);
    await says('/too old/');
  });
  await test('memory that is used up, and graphics that stop, are said', async () => {
    await open(`${server.address}${version}/?full#scene=torus`);
    await browser.until(runs);
    await browser.value(`window.eval("WebAssembly.Memory.prototype.grow = () => { throw new RangeError('no more'); }; while (program._malloc(1e6)); go('#sample=torus,n=20000')")`);
    await browser.until(`/Out of memory/.test(document.getElementById('sentence').textContent)`);
    await open(`${server.address}${version}/?lost#scene=torus`);
    await browser.until(runs);
    await browser.value(`window.eval("canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()")`);
    await says('/graphics of this browser have stopped/');
  });
  await test('it opens without a network after the first visit', async () => {
    await open(`${server.address}${version}/#scene=torus`);
    await browser.until(runs);
    await browser.until(`(window.kept ??= 0, caches.keys().then(([name]) => caches.open(name)).then(cache => cache.keys()).then(all => { window.kept = all.length; }), window.kept >= 4)`);
    await server.stop();
    await open(`${server.address}${version}/?again#scene=torus&goto=20.sort.1`);
    await browser.until(`document.title.startsWith('20.sort.1')`);
  });
  await browser.end();
  for (const each of [around, lacking]) await each.stop();
  process.exit(code);
})();
