// Keeps the program for visits without a network. Its files change together: a new set is fetched whole
// before the old one goes.
const kCache = 'spiraling-edge-{{digest}}';
const kFiles = ['./', 'viewer.js', 'viewer.wasm', 'viewer.data'];
addEventListener('install', event => {
  skipWaiting();
  event.waitUntil(caches.open(kCache).then(cache => cache.addAll(kFiles)));
});
addEventListener('activate', event => event.waitUntil(caches.keys()
  .then(names => Promise.all(names.filter(name => name.startsWith('spiraling-edge-') && name !== kCache).map(name => caches.delete(name))))
  .then(() => clients.claim())));
addEventListener('fetch', event => {
  if (event.request.method !== 'GET' || new URL(event.request.url).origin !== location.origin) return;
  event.respondWith(caches.open(kCache)
    .then(cache => cache.match(event.request, {ignoreSearch: true}))
    .then(kept => kept ?? fetch(event.request)));
});
