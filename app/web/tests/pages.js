// The program in Chromium, as a reader has it: pages.js SITE ONE_FILE [PICTURES] [NAME...]
// Each test opens a browser of its own. PICTURES: a folder for what they show. NAME: these tests alone.
'use strict';
const assert = require('assert');
const {execFileSync} = require('child_process');
const crypto = require('crypto');
const fs = require('fs');
const os = require('os');
const path = require('path');
const zlib = require('zlib');
const {Browser, sleep} = require('./chromium.js');
const {serve} = require('./server.js');

const [site, oneFile] = process.argv.slice(2, 4).map(each => path.resolve(each));
const pictures = process.argv[4] ?? fs.mkdtempSync(path.join(os.tmpdir(), 'pictures-'));
const wanted = process.argv.slice(5);
const commandLine = path.resolve(site, '../build/bin/spiraling-edge.js');
const assets = path.resolve(__dirname, '../../../assets');
fs.mkdirSync(pictures, {recursive: true});

const title = browser => browser.value('document.title');
const sentence = browser => browser.value('document.getElementById("sentence").textContent');
const why = browser => browser.value('document.getElementById("why").textContent');
/// What the canvas shows, as a hash.
const shown = async browser => {
  await browser.settled();
  const {data} = await browser.call('Page.captureScreenshot', {format: 'png'});
  return crypto.createHash('sha256').update(data).digest('hex');
};
/// Waits until the page says why there is no program; what it says.
const refused = async browser => {
  await browser.until('failedWith');
  return why(browser);
};

const tests = {
  async 'the start page opens'({open}) {
    const browser = await open('');
    await browser.settled();
    assert.equal(await title(browser), 'Spiraling Edge');
    await browser.picture(path.join(pictures, 'start.png'));
  },
  async 'a link lands at its decision'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.settled();
    await browser.picture(path.join(pictures, 'decision.png'));
  },
  async 'the sentence of the decision is read aloud'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.getElementById('sentence').textContent !== ''`);
    assert.match(await sentence(browser), /Point 242 lies 0.00918747 outside the sphere/);
  },
  async 'a lesson opens by a link'({open}) {
    const browser = await open('#lesson=removal');
    await browser.until(`/scene:figure-8/.test(document.title)`);
    await browser.settled();
    await browser.picture(path.join(pictures, 'lesson.png'));
  },
  async 'a page shows picture and sentence, and the program takes their place'({open}) {
    const browser = await open('scene/torus/', {
      script: `{ const come = new Promise(done => { window.release = done; }), get = fetch; window.fetch = async name => { await come; return get(name); }; }`});
    assert.match(await browser.value('wait.innerText'), /Torus.*Point 916 is met again.*Back.*All pages.*Next.*Stay with the page/s);
    assert.ok(await browser.value(`document.querySelector('#picture svg').clientWidth > 300`));
    await browser.picture(path.join(pictures, 'page-loads.png'));
    await browser.value('release()');
    await browser.until(`document.title.startsWith('200.split.1')`);
    await browser.settled();
    assert.equal(await browser.value('location.pathname'), `/${version}/scene/torus/`);
    assert.equal(await browser.value('getComputedStyle(wait).display'), 'none');
    assert.match(await sentence(browser), /Point 916 is met again/);
    await browser.picture(path.join(pictures, 'page-runs.png'));
  },
  async 'without WebGL the page stays, and leads through a lesson'({open}) {
    for (const [width, height, mobile] of [[1280, 800], [390, 844, true]]) {
      const browser = await open('lesson/removal/2/', {width, height, mobile, arguments: ['--disable-3d-apis']});
      assert.match(await refused(browser), /no WebGL 2/);
      await browser.picture(path.join(pictures, `page-stays-${width}.png`));
      for (const [way, heading] of [['next', 'step 3: Inside is kept?'], ['prev', 'step 2: Which of them go?'], ['prev', 'step 1: Four candidates']]) {
        await browser.value(`document.querySelector('[rel=${way}]').click()`);
        await browser.until(`document.querySelector('h1').textContent.endsWith(${JSON.stringify(heading)}) && picture.querySelector('svg').clientWidth > 300`);
      }
      await browser.end();
    }
  },
  async 'a reader stays with the pages, until the program is asked for'({open}) {
    const browser = await open('figure/8/', {script: `addEventListener('DOMContentLoaded', () => { if (!localStorage['spiraling-edge pages']) setTimeout(() => stay.click()); });`});
    await browser.until(`stay.textContent === 'Start the program'`);
    assert.equal(await browser.value('share.hidden'), true);
    await browser.picture(path.join(pictures, 'page-chosen.png'));
    await browser.value('stay.click()');
    await browser.until(`document.title.startsWith('9.sphere.2')`);
  },
  async 'a link in the address of a page comes before the page'({open}) {
    const browser = await open('scene/torus/#scene=sphere&goto=20.sort.1');
    assert.equal(await browser.value(`document.querySelector('.page')`), null);
    await browser.until(`document.title.startsWith('20.sort.1')`);
  },
  async 'keys step forward and back'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.key('ArrowRight');
    await browser.until(`document.title.startsWith('137.sphere.4')`);
    await browser.key('ArrowLeft');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
  },
  async 'an address is typed'({open}) {
    const browser = await open('#scene=torus');
    await browser.settled();
    await browser.key('Ctrl+g');
    await browser.settled();
    await browser.type('20.sort.1');
    await browser.key('Enter');
    await browser.until(`document.title.startsWith('20.sort.1')`);
  },
  async 'a modifier that was released elsewhere is not held'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.call('Input.dispatchKeyEvent', {type: 'rawKeyDown', key: 'Control', code: 'ControlLeft', windowsVirtualKeyCode: 17, modifiers: 2});
    await browser.key('ArrowRight');
    await browser.until(`document.title.startsWith('137.sphere.4')`);
  },
  async 'the mouse turns, the wheel zooms, a finger turns'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3', {mobile: true});
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    const seen = new Set([await shown(browser)]);
    await browser.drag(450, 500, 520, 460);
    seen.add(await shown(browser));
    await browser.wheel(450, 500, -240);
    seen.add(await shown(browser));
    await browser.touch([[[450, 500], [520, 560]]]);
    await sleep(300);
    seen.add(await shown(browser));
    await browser.touch([[[400, 450], [360, 430]], [[500, 450], [560, 430]]]);
    await sleep(300);
    seen.add(await shown(browser));
    assert.equal(seen.size, 5);
  },
  async 'the loop sleeps while nothing moves'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await sleep(1500);
    await browser.settled();
    const before = await browser.value('frames.count');
    await sleep(1000);
    assert.equal(await browser.value('frames.count'), before);
  },
  async 'a dropped file runs'({open}) {
    const browser = await open('');
    await browser.settled();
    await browser.drop('sheet.ply', fs.readFileSync(path.join(assets, 'points/sheet.ply')));
    await browser.until(`/sheet\\.ply/.test(document.title)`);
  },
  async 'a picked file runs'({open}) {
    const browser = await open('');
    await browser.settled();
    const {root} = await browser.call('DOM.getDocument');
    const {nodeId} = await browser.call('DOM.querySelector', {nodeId: root.nodeId, selector: '#picker'});
    await browser.call('DOM.setFileInputFiles', {nodeId, files: [path.join(assets, 'points/corner.ply')]});
    await browser.until(`/corner\\.ply/.test(document.title)`);
  },
  async 'a chosen theme stays for the next visit'({open}) {
    const browser = await open('#scene=torus');
    await browser.settled();
    await browser.key('F8');
    await browser.settled();
    await browser.key('t');
    await browser.until(`Object.keys(localStorage).some(name => /light|"theme"/.test(localStorage[name]))`);
  },
  async 'what is saved is a download, and opens again'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.key('Ctrl+s');
    await browser.settled();
    await browser.key('Enter');
    const file = path.join(browser.downloads, 'torus.sesession');
    for (let i = 0; i < 300 && !fs.existsSync(file); ++i) await sleep(100);
    await browser.call('Page.navigate', {url: 'about:blank'});
    await browser.open(browser.address + '#scene=sphere');
    await browser.until(`/scene:sphere/.test(document.title)`);
    await browser.settled();
    await browser.drop('torus.sesession', fs.readFileSync(file));
    await browser.until(`/137\\.sphere\\.3/.test(document.title)`);
  },
  async 'a copied link leads to the same place of this page'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3&rules=robust');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.drag(450, 500, 520, 460);
    await browser.settled();
    await browser.value(`window.said = '', navigator.clipboard.writeText = async text => { said = text; }`);
    await browser.key('Ctrl+c');
    await browser.until(`said !== ''`);
    const link = await browser.value('said');
    assert.ok(link.startsWith(browser.address + '#scene=torus'), link);
    assert.match(link, /rules=robust.*goto=137\.sphere\.3.*camera=|goto=137\.sphere\.3.*camera=.*rules=robust/);
    assert.ok(link.length < 250, link);
  },
  async 'a link to a failure holds its points, and opens on it'({open}) {
    const browser = await open('#scene=noise');
    await browser.settled();
    await browser.value(`window.said = '', navigator.clipboard.writeText = async text => { window.said = text; }`);
    await browser.key('F8');
    await browser.until(`/fault|Place/.test(document.getElementById('sentence').textContent)`);
    await browser.key('Ctrl+p');
    await browser.settled();
    await browser.type('link to this failure');
    await browser.settled();
    await browser.key('Enter');
    await browser.until(`said.includes('pack=')`);
    const link = await browser.value('said');
    assert.ok(link.length < 8000, link);
    await browser.open(link.replace('#', '?again#'));
    await browser.until(`/\\.ply/.test(document.title)`);
    await browser.settled();
    await browser.picture(path.join(pictures, 'failure.png'));
  },
  async 'a pivot to practice opens by a link, and new points from a key'({open}) {
    const browser = await open('#lesson=practice:7');
    await browser.until(`/practice:7/.test(document.title)`);
    await browser.value(`location.hash = '#scene=torus'`);
    await browser.until(`/scene:torus/.test(document.title)`);
    await browser.key('Alt+n');
    await browser.until(`/^New points/.test(document.title)`);
  },
  async 'a trace of another program is dropped on its run'({open}) {
    const browser = await open('#scene=torus');
    await browser.settled();
    const trace = path.join(os.tmpdir(), `torus-${process.pid}.setrace`);
    execFileSync('node', ['--no-experimental-fetch', commandLine, 'run', 'scene:torus', '--rules', 'robust', '-q', '--trace', trace]);
    await browser.drop('torus.setrace', fs.readFileSync(trace));
    fs.unlinkSync(trace);
    await browser.until(`/setrace|differ|[Cc]ompare/.test(document.getElementById('sentence').textContent)`);
    await browser.settled();
    await browser.picture(path.join(pictures, 'trace.png'));
  },
  async 'a folder that is dropped is said, and the program goes on'({open}) {
    const browser = await open('#scene=torus');
    await browser.settled();
    await browser.value(`openFiles([{name: 'scans', arrayBuffer() { return Promise.reject(new Error()); }}])`);
    await browser.until(`/scans could not be read/.test(document.getElementById('sentence').textContent)`);
    assert.equal(await browser.value('failedWith'), null);
  },
  async 'an address of a file that leads elsewhere is refused'({open}) {
    const browser = await open('#scene=torus');
    await browser.settled();
    await browser.value(`go('#file=https://example.org/x/../../../home/web_user/.config/a.ply')`);
    await browser.until(`/is no address of a file/.test(document.getElementById('sentence').textContent)`);
  },
  async 'a page around hears of steps and moves the frame'({browser, server}) {
    const {address} = await server({pages: {'/around': `<title></title><script>addEventListener('message', e => { document.title = JSON.stringify(e.data); });</script>
      <iframe src="/${version}/#scene=torus&goto=137.sphere.3" width="900" height="600"></iframe>`}});
    const opened = await browser();
    await opened.call('Page.navigate', {url: address + 'around'});
    await opened.until(`/"address":"137.sphere.3","sentence":"Point 242 lies/.test(document.title)`);
    await opened.value(`frames[0].postMessage({go: '20.sort.1'}, '*')`);
    await opened.until(`/"address":"20.sort.1"/.test(document.title)`);
  },
  async 'two tabs keep the settings of both'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    const kept = text => browser.until(`Object.values(localStorage).some(each => ${text}.every(part => part.test(each)))`);
    await browser.settled();
    await browser.key('t');
    await kept('[/"theme": ?"dark"/]');
    const first = browser.session;
    const {targetId} = await browser.send('Target.createTarget', {url: browser.address + 'offline.js'});
    await browser.attach(targetId);
    await browser.value(`(() => { const name = Object.keys(localStorage).find(each => each.endsWith('settings.json'));
      localStorage[name] = JSON.stringify({...JSON.parse(localStorage[name]), playRate: 8}); })()`);
    browser.session = first;
    await browser.send('Target.closeTarget', {targetId});
    await browser.call('Page.bringToFront');
    await browser.key('t');
    await kept('[/"theme": ?"light"/, /"playRate": ?8/]');
  },
  async 'a link whose address is changed moves, and does not load again'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.value(`window.mark = 1, location.hash = '#scene=torus&goto=20.sort.1'`);
    await browser.until(`document.title.startsWith('20.sort.1')`);
    assert.equal(await browser.value('window.mark'), 1);
  },
  async 'a link to the open input alone stays where it is'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.value(`location.hash = '#scene=torus&mesh-style=wire'`);
    await sleep(500);
    await browser.settled();
    assert.match(await title(browser), /^137\.sphere\.3/);
  },
  async 'a link longer than the stack opens'({open}) {
    const browser = await open('');
    await browser.settled();
    await browser.value(`go('#scene=torus&goto=' + 'x'.repeat(6e6))`);
    await browser.settled();
    assert.equal(await browser.value('failedWith'), null);
  },
  async 'a file is named by its address on the web'({browser, server}) {
    const sheet = fs.readFileSync(path.join(assets, 'points/sheet.ply'));
    const other = await server({pages: {'/points/sheet.ply': sheet}, headers: {'Access-Control-Allow-Origin': '*'}});
    const {address} = await server();
    const opened = await browser();
    await opened.open(`${address}${version}/#file=${other.address}points/sheet.ply`);
    await opened.until(`/sheet\\.ply/.test(document.title)`);
    await opened.value(`window.said = '', navigator.clipboard.writeText = async text => { window.said = text; }`);
    await opened.key('Ctrl+c');
    await opened.until(`said.includes('file=${other.address}points/sheet.ply')`);
  },
  async 'a file that may not be read from another page is said'({browser, server}) {
    const other = await server({pages: {'/sheet.ply': 'ply'}});
    const {address} = await server();
    const opened = await browser();
    await opened.open(`${address}${version}/#file=${other.address}sheet.ply`);
    assert.match(await refused(opened), /sheet\.ply could not be fetched.*CORS/);
  },
  async 'keys of the browser do nothing in the program'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    const before = await shown(browser);
    await browser.value(`for (const key of ['=', '0', 'r']) canvas.dispatchEvent(new KeyboardEvent('keydown', {key, code: 'Key', ctrlKey: true, cancelable: true}))`);
    await browser.value(`canvas.dispatchEvent(new KeyboardEvent('keyup', {key: 'Control', code: 'ControlLeft'}))`);
    await sleep(300);
    assert.equal(await shown(browser), before);
  },
  async 'a finger taps a field, and the keyboard of the screen types into it'({open}) {
    const browser = await open('#scene=torus', {mobile: true});
    await browser.settled();
    await browser.key('Ctrl+g');
    await browser.until('program._webTyping() === 1');
    await browser.value('showKeyboard()');
    assert.equal(await browser.value('document.activeElement.id'), 'typed');
    await browser.value(`for (const text of [' 20.sorx', ' 20.sor', ' 20.sort.1']) { typed.value = text; typed.dispatchEvent(new InputEvent('input', {isComposing: true})); }`);
    await browser.key('Enter');
    await browser.until(`document.title.startsWith('20.sort.1')`);
  },
  async 'a finger scrolls a list and does not press its rows'({open}) {
    const browser = await open('', {mobile: true, width: 390, height: 844});
    await browser.settled();
    const before = await shown(browser);
    await browser.touch([[[200, 700], [200, 300]]]);
    await browser.settled();
    assert.equal(await title(browser), 'Spiraling Edge');
    assert.notEqual(await shown(browser), before);
    await browser.picture(path.join(pictures, 'scrolled.png'));
  },
  async 'work that is not saved is asked about'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    const asks = `(() => { const event = new Event('beforeunload', {cancelable: true}); dispatchEvent(event); return event.defaultPrevented; })()`;
    assert.equal(await browser.value(asks), false);
    await browser.key('Ctrl+b');
    await browser.settled();
    assert.equal(await browser.value(asks), true);
  },
  async 'the answer to a question reaches the page around'({browser, server}) {
    const {address} = await server({pages: {'/around': `<script>window.heard = []; addEventListener('message', e => heard.push(e.data));</script>
      <iframe src="/${version}/#lesson=class&step=2&layout=present" width="900" height="600"></iframe>`}});
    const opened = await browser();
    await opened.call('Page.navigate', {url: address + 'around'});
    await opened.until(`heard.length > 0`);
    for (const type of ['mousePressed', 'mouseReleased']) await opened.mouse(type, 450, 200, {button: 'left', clickCount: 1});
    await sleep(300);
    for (const key of ['b', 'Enter']) { await opened.key(key); await sleep(300); }
    await opened.until(`heard.some(each => each.answered === 2 && each.result.answers[0].given[0] === '3')`);
  },
  async 'the theme of the system is followed until one is chosen'({open}) {
    const browser = await open('#scene=torus');
    await browser.settled();
    const light = await shown(browser);
    const scheme = value => browser.call('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value}]});
    await scheme('dark');
    await sleep(300);
    const dark = await shown(browser);
    assert.notEqual(dark, light);
    await browser.key('t');
    await browser.until(`Object.values(localStorage).some(each => /"theme": ?"light"/.test(each))`);
    const chosen = await shown(browser);
    await scheme('light');
    await sleep(300);
    await scheme('dark');
    await sleep(300);
    assert.equal(await shown(browser), chosen);
  },
  async 'one file opens from a disk'({browser}) {
    const opened = await browser();
    await opened.open(`file://${oneFile}#scene=torus&goto=137.sphere.3`);
    await opened.until(`document.title.startsWith('137.sphere.3')`);
  },
  async 'a page opens from a disk at the lesson inside it'({browser}) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'page-'));
    const inside = (link, files = {}) => fs.readFileSync(oneFile, 'utf8').replace('<meta name="start" content="">', () =>
      `<meta name="start" content="${link}">` + Object.entries(files).map(([name, bytes]) =>
        `\n<script type="text/plain" data-file="${name}">${zlib.deflateRawSync(bytes).toString('base64')}</script>`).join(''));
    const lesson = '# Mine\n```se lesson\nversion = 1\ninput = "data/sheet.ply"\n```\n## One\nText.\n```se step\nat = "5"\n```\n';
    fs.writeFileSync(path.join(folder, 'removal.html'), inside('lesson=removal&amp;step=2'));
    fs.writeFileSync(path.join(folder, 'mine.html'),
      inside('file=mine.lesson.md', {'mine.lesson.md': lesson, 'data/sheet.ply': fs.readFileSync(path.join(assets, 'points/sheet.ply'))}));
    const opened = await browser();
    await opened.open(`file://${folder}/removal.html`);
    await opened.until(`/scene:figure-8/.test(document.title)`);
    await opened.settled();
    await opened.picture(path.join(pictures, 'inside.png'));
    await opened.open(`file://${folder}/mine.html`);
    await opened.until(`/^5\..*sheet\.ply/.test(document.title)`);
    await opened.open(`file://${folder}/removal.html#scene=torus&goto=137.sphere.3`);
    await opened.until(`document.title.startsWith('137.sphere.3')`);
    fs.rmSync(folder, {recursive: true});
  },
  async 'one file runs in a sandboxed frame'({browser, server}) {
    const {address} = await server({pages: {
      '/frame': '<iframe sandbox="allow-scripts" src="/one#scene=torus&goto=137.sphere.3" width="900" height="600"></iframe>',
      '/one': fs.readFileSync(oneFile, 'utf8')}});
    const opened = await browser();
    await opened.call('Page.navigate', {url: address + 'frame'});
    let frame;
    for (let i = 0; i < 300 && !frame; ++i, await sleep(100))
      frame = (await opened.send('Target.getTargets')).targetInfos.find(each => each.type === 'iframe');
    const page = opened.session;
    await opened.attach(frame.targetId);
    await opened.until(`document.title.startsWith('137.sphere.3')`);
    opened.session = page;
    await opened.picture(path.join(pictures, 'sandboxed.png'));
  },
  async 'it opens without a network after the first visit'({browser, server}) {
    const {address, stop} = await server();
    const opened = await browser();
    await opened.open(address + version + '/#scene=torus&goto=137.sphere.3');
    await opened.until(`document.title.startsWith('137.sphere.3')`);
    await opened.until(`navigator.serviceWorker.ready.then(() => caches.keys()).then(names => names.length === 1)`);
    await opened.until(`caches.keys().then(([name]) => caches.open(name)).then(cache => cache.keys()).then(all => all.length === 6)`);
    await stop();
    await opened.open(address + version + '/?again#scene=torus&goto=20.sort.1');
    await opened.until(`document.title.startsWith('20.sort.1')`);
  },
  async 'without WebGL the page says what to do'({open}) {
    const browser = await open('#scene=torus', {arguments: ['--disable-3d-apis']});
    assert.match(await refused(browser), /no WebGL 2.*hardware acceleration/);
  },
  async 'without exceptions of WebAssembly the page says so'({open}) {
    const browser = await open('#scene=torus', {script: 'WebAssembly.validate = () => false;'});
    assert.match(await refused(browser), /too old/);
  },
  async 'a file of the program that is not there is named'({browser, server}) {
    const {address} = await server({missing: ['viewer.wasm']});
    const opened = await browser();
    await opened.open(address + version + '/');
    assert.match(await refused(opened), /viewer\.wasm of the program is not there \(404\)/);
  },
  async 'a name that no link has is said, with the nearest'({open}) {
    const browser = await open('#scene=torus&gto=137.sphere.3');
    assert.match(await refused(browser), /gto.*goto/s);
    await browser.picture(path.join(pictures, 'wrong-link.png'));
  },
  async 'a scene that does not exist is said'({open}) {
    const browser = await open('#scene=tours');
    await browser.until(`/tours/.test(document.body.innerText + document.getElementById('sentence').textContent)`);
  },
  async 'memory that is used up is said'({open}) {
    const browser = await open('#scene=torus', {script: `WebAssembly.Memory.prototype.grow = () => { throw new RangeError('no more'); };`});
    await browser.settled();
    await browser.value(`while (program._malloc(1e6)); go('#sample=torus,n=20000')`);
    await browser.until(`/Out of memory/.test(document.getElementById('sentence').textContent)`);
    assert.equal(await browser.value('failedWith'), null);
  },
  async 'graphics that stop are said'({open}) {
    const browser = await open('#scene=torus');
    await browser.settled();
    await browser.value(`canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()`);
    assert.match(await refused(browser), /graphics of this browser have stopped/);
  },
  async 'little motion is respected'({open}) {
    const browser = await open('#scene=torus&goto=137.sphere.3');
    await browser.until(`document.title.startsWith('137.sphere.3')`);
    await browser.call('Emulation.setEmulatedMedia', {features: [{name: 'prefers-reduced-motion', value: 'reduce'}]});
    await browser.settled();
    const before = await browser.value('frames.count');
    await browser.key('ArrowRight');
    await browser.until(`document.title.startsWith('137.sphere.4')`);
    await browser.settled();
    assert.ok(await browser.value('frames.count') - before < 12, 'frames of a step without motion');
  },
  async 'the phone, the laptop and the large screen'({open}) {
    for (const [width, height, ratio, mobile] of [[390, 844, 1, true], [1366, 768, 1], [1920, 1080, 1], [2560, 1440, 2]])
      for (const [name, link] of [['start', ''], ['decision', '#scene=torus&goto=137.sphere.3'], ['lesson', '#lesson=removal']]) {
        const browser = await open(link, {width, height, ratio, mobile});
        await browser.until(`document.title !== 'Spiraling Edge' || ${link === ''}`);
        await sleep(1000);
        await browser.settled();
        await browser.picture(path.join(pictures, `${name}-${width}x${height}.png`));
        await browser.end();
      }
  },
};

const version = fs.readdirSync(site).find(name => fs.statSync(path.join(site, name)).isDirectory());
(async () => {
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    if (wanted.length > 0 && !wanted.some(each => name.includes(each))) continue;
    const ends = [];
    const server = async options => {
      const made = await serve(site, options);
      let runs = true;
      const stop = async () => { if (runs) { runs = false; await made.stop(); } };
      ends.push(stop);
      return {...made, stop};
    };
    const browser = async options => {
      const made = await Browser.start(options);
      ends.push(() => made.end());
      if (options?.script) await made.call('Page.addScriptToEvaluateOnNewDocument', {source: options.script});
      return made;
    };
    const open = async (hash, options) => {
      const {address} = await server();
      const made = await browser(options);
      made.address = address + version + '/';
      await made.open(made.address + hash);
      return made;
    };
    const began = Date.now();
    try {
      await test({open, browser, server});
      console.log(`ok    ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
    } catch (error) {
      ++failed;
      console.log(`FAIL  ${name}\n${error.stack}`);
    }
    for (const end of ends.reverse()) await end().catch(() => {});
  }
  console.log(failed === 0 ? 'all passed' : `${failed} failed`);
  process.exit(failed === 0 ? 0 : 1);
})();
