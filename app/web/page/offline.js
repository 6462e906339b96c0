// Keeps the program for visits without a network. Its files change together: a new set is fetched whole
// before the old one goes. Other versions on this server keep theirs.
const kOfVersion = 'spiraling-edge ' + registration.scope + ' ';
const kCache = kOfVersion + '{{digest}}';
const kFiles = ['./', 'page.css', 'page.js', 'viewer.js', 'viewer.wasm', 'viewer.data'];
addEventListener('install', event => {
  const fresh = kFiles.map(name => new Request(name, {cache: 'reload'}));
  event.waitUntil(caches.open(kCache).then(cache => cache.addAll(fresh)));
});
addEventListener('activate', event => event.waitUntil(caches.keys()
  .then(names => Promise.all(names.filter(name => name.startsWith(kOfVersion) && name !== kCache).map(name => caches.delete(name))))));
addEventListener('fetch', event => {
  if (event.request.method !== 'GET' || !event.request.url.startsWith(registration.scope)) return;
  event.respondWith(caches.open(kCache)
    .then(cache => cache.match(event.request, {ignoreSearch: true}))
    .then(kept => kept ?? fetch(event.request)));
});
