// Time to the first frame of the window with a scene: of the page on a later visit against the native
// program, in the same run. Shaders may still be compiled then, in Chromium by another process. warm.js VIEWER SITE; fails above twice the native time.
'use strict';
const {execFileSync} = require('child_process');
const fs = require('fs');
const path = require('path');
const {Browser} = require('./chromium.js');
const {serve} = require('./server.js');

const kTimes = 7;
const median = all => all.sort((a, b) => a - b)[all.length >> 1];

function nativeTimes(viewer) {
  return Array.from({length: kTimes}, () => {
    const began = performance.now();
    execFileSync(viewer, ['scene:torus', '--no-config', '--frames', '1'], {stdio: 'ignore'});
    return performance.now() - began;
  });
}

async function pageTimes(site) {
  const server = await serve(site);
  const version = fs.readdirSync(site).find(name => fs.statSync(path.join(site, name)).isDirectory());
  const browser = await Browser.start();
  await browser.call('Page.addScriptToEvaluateOnNewDocument', {source: `addEventListener('DOMContentLoaded', () => {
    new MutationObserver(() => { if (document.body.classList.contains('runs')) window.shown ??= performance.now(); }).observe(document.body, {attributes: true}); });`});
  const times = [];
  for (let i = 0; i <= kTimes; ++i) {
    await browser.open(`${server.address}${version}/?${i}#scene=torus`);
    await browser.until('window.shown');
    await browser.settled();
    if (i > 0) times.push(await browser.value('window.shown'));
    else await browser.until(`navigator.serviceWorker.ready.then(() => true)`);
  }
  await browser.end();
  await server.stop();
  return times;
}

(async () => {
  const [viewer, site] = process.argv.slice(2, 4).map(each => path.resolve(each));
  const native = median(nativeTimes(viewer));
  const page = median(await pageTimes(site));
  console.log(`first frame: native ${native.toFixed(0)} ms, page on a later visit ${page.toFixed(0)} ms, ratio ${(page / native).toFixed(2)}, at most 2`);
  process.exit(page <= 2 * native ? 0 : 1);
})();
